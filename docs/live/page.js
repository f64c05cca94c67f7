(()=>{var Wl=`(()=>{var On=(()=>{var m=typeof document<"u"&&document.currentScript?document.currentScript.src:void 0;return(function(e){e=e||{};var e=typeof e<"u"?e:{},U,R;e.ready=new Promise(function(t,n){U=t,R=n});var ht=Object.assign({},e),bt=[],pt="./this.program",dt=(t,n)=>{throw n},Ft=!1,W=!0,D="";function Bt(t){return e.locateFile?e.locateFile(t,D):D+t}var Ht,Gt,rt,Vt;(Ft||W)&&(W?D=self.location.href:typeof document<"u"&&document.currentScript&&(D=document.currentScript.src),m&&(D=m),D.indexOf("blob:")!==0?D=D.substr(0,D.replace(/[?#].*/,"").lastIndexOf("/")+1):D="",Ht=(t=>{var n=new XMLHttpRequest;return n.open("GET",t,!1),n.send(null),n.responseText}),W&&(rt=(t=>{var n=new XMLHttpRequest;return n.open("GET",t,!1),n.responseType="arraybuffer",n.send(null),new Uint8Array(n.response)})),Gt=((t,n,r)=>{var i=new XMLHttpRequest;i.open("GET",t,!0),i.responseType="arraybuffer",i.onload=(()=>{if(i.status==200||i.status==0&&i.response){n(i.response);return}r()}),i.onerror=r,i.send(null)}),Vt=(t=>document.title=t));var Qt=e.print||console.log.bind(console),X=e.printErr||console.warn.bind(console);Object.assign(e,ht),ht=null,e.arguments&&(bt=e.arguments),e.thisProgram&&(pt=e.thisProgram),e.quit&&(dt=e.quit);var $n=4;function O(t){O.shown||(O.shown={}),O.shown[t]||(O.shown[t]=1,X(t))}function te(t,n){if(typeof WebAssembly.Function=="function"){for(var r={i:"i32",j:"i64",f:"f32",d:"f64"},i={parameters:[],results:n[0]=="v"?[]:[r[n[0]]]},o=1;o<n.length;++o)i.parameters.push(r[n[o]]);return new WebAssembly.Function(i,t)}var l=[1,0,1,96],f=n.slice(0,1),u=n.slice(1),y={i:127,j:126,f:125,d:124};l.push(u.length);for(var o=0;o<u.length;++o)l.push(y[u[o]]);f=="v"?l.push(0):l=l.concat([1,y[f]]),l[1]=l.length-2;var d=new Uint8Array([0,97,115,109,1,0,0,0].concat(l,[2,7,1,1,101,1,102,0,0,7,5,1,1,102,0,0])),F=new WebAssembly.Module(d),Y=new WebAssembly.Instance(F,{e:{f:t}}),p=Y.exports.f;return p}var gt=[],Jt;function ne(){if(gt.length)return gt.pop();try{w.grow(1)}catch(t){throw t instanceof RangeError?"Unable to grow wasm table. Set ALLOW_TABLE_GROWTH.":t}return w.length-1}function ee(t,n){for(var r=t;r<t+n;r++){var i=ft(r);i&&Jt.set(i,r)}}var re=0,K;e.wasmBinary&&(K=e.wasmBinary);var Wt=e.noExitRuntime||!0;typeof WebAssembly!="object"&&N("no native wasm support detected");var M,at=!1,Zt;function ae(t,n){t||N(n)}function Ot(t){var n=e["_"+t];return n}function Mt(t,n,r,i,o){var l={string:function(h){var S=0;if(h!=null&&h!==0){var G=(h.length<<2)+1;S=mt(G),At(h,S,G)}return S},array:function(h){var S=mt(h.length);return St(h,S),S}};function f(h){return n==="string"?A(h):n==="boolean"?!!h:h}var u=Ot(t),y=[],d=0;if(i)for(var F=0;F<i.length;F++){var Y=l[r[F]];Y?(d===0&&(d=qt()),y[F]=Y(i[F])):y[F]=i[F]}var p=u.apply(null,y);function x(h){return d!==0&&Pt(d),f(h)}return p=x(p),p}var ie=1,Dt=typeof TextDecoder<"u"?new TextDecoder("utf8"):void 0;function xt(t,n,r){for(var i=n+r,o=n;t[o]&&!(o>=i);)++o;if(o-n>16&&t.subarray&&Dt)return Dt.decode(t.subarray(n,o));for(var l="";n<o;){var f=t[n++];if(!(f&128)){l+=String.fromCharCode(f);continue}var u=t[n++]&63;if((f&224)==192){l+=String.fromCharCode((f&31)<<6|u);continue}var y=t[n++]&63;if((f&240)==224?f=(f&15)<<12|u<<6|y:f=(f&7)<<18|u<<12|y<<6|t[n++]&63,f<65536)l+=String.fromCharCode(f);else{var d=f-65536;l+=String.fromCharCode(55296|d>>10,56320|d&1023)}}return l}function A(t,n){return t?xt(C,t,n):""}function Tt(t,n,r,i){if(!(i>0))return 0;for(var o=r,l=r+i-1,f=0;f<t.length;++f){var u=t.charCodeAt(f);if(u>=55296&&u<=57343){var y=t.charCodeAt(++f);u=65536+((u&1023)<<10)|y&1023}if(u<=127){if(r>=l)break;n[r++]=u}else if(u<=2047){if(r+1>=l)break;n[r++]=192|u>>6,n[r++]=128|u&63}else if(u<=65535){if(r+2>=l)break;n[r++]=224|u>>12,n[r++]=128|u>>6&63,n[r++]=128|u&63}else{if(r+3>=l)break;n[r++]=240|u>>18,n[r++]=128|u>>12&63,n[r++]=128|u>>6&63,n[r++]=128|u&63}}return n[r]=0,r-o}function At(t,n,r){return Tt(t,C,n,r)}function _t(t){for(var n=0,r=0;r<t.length;++r){var i=t.charCodeAt(r);i>=55296&&i<=57343&&(i=65536+((i&1023)<<10)|t.charCodeAt(++r)&1023),i<=127?++n:i<=2047?n+=2:i<=65535?n+=3:n+=4}return n}var se=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0;function St(t,n){j.set(t,n)}function $t(t,n,r){for(var i=0;i<t.length;++i)j[n++>>0]=t.charCodeAt(i);r||(j[n>>0]=0)}var jt,j,C,tn,nn,c,en,rn,an;function zt(t){jt=t,e.HEAP8=j=new Int8Array(t),e.HEAP16=tn=new Int16Array(t),e.HEAP32=c=new Int32Array(t),e.HEAPU8=C=new Uint8Array(t),e.HEAPU16=nn=new Uint16Array(t),e.HEAPU32=en=new Uint32Array(t),e.HEAPF32=rn=new Float32Array(t),e.HEAPF64=an=new Float64Array(t)}var fe=e.INITIAL_MEMORY||16777216,w,Ut=[],Xt=[],Et=[],sn=!1,fn=!1,un=0;function on(){return Wt||un>0}function ln(){if(e.preRun)for(typeof e.preRun=="function"&&(e.preRun=[e.preRun]);e.preRun.length;)cn(e.preRun.shift());st(Ut)}function mn(){sn=!0,st(Xt)}function ue(){fn=!0}function vn(){if(e.postRun)for(typeof e.postRun=="function"&&(e.postRun=[e.postRun]);e.postRun.length;)hn(e.postRun.shift());st(Et)}function cn(t){Ut.unshift(t)}function yn(t){Xt.unshift(t)}function hn(t){Et.unshift(t)}var E=0,it=null,I=null;function bn(t){E++,e.monitorRunDependencies&&e.monitorRunDependencies(E)}function pn(t){if(E--,e.monitorRunDependencies&&e.monitorRunDependencies(E),E==0&&(it!==null&&(clearInterval(it),it=null),I)){var n=I;I=null,n()}}e.preloadedImages={},e.preloadedAudios={};function N(t){e.onAbort&&e.onAbort(t),t="Aborted("+t+")",X(t),at=!0,Zt=1,t+=". Build with -s ASSERTIONS=1 for more info.";var n=new WebAssembly.RuntimeError(t);throw R(n),n}var dn="data:application/octet-stream;base64,";function Yt(t){return t.startsWith(dn)}var g;g="live.wasm",Yt(g)||(g=Bt(g));function kt(t){try{if(t==g&&K)return new Uint8Array(K);if(rt)return rt(t);throw"both async and sync fetching of the wasm failed"}catch(n){N(n)}}function Fn(){return!K&&(Ft||W)&&typeof fetch=="function"?fetch(g,{credentials:"same-origin"}).then(function(t){if(!t.ok)throw"failed to load wasm binary file at '"+g+"'";return t.arrayBuffer()}).catch(function(){return kt(g)}):Promise.resolve().then(function(){return kt(g)})}function gn(){var t={env:Lt,wasi_snapshot_preview1:Lt};function n(f,u){var y=f.exports;e.asm=y,M=e.asm.memory,zt(M.buffer),w=e.asm.__indirect_function_table,yn(e.asm.__wasm_call_ctors),pn("wasm-instantiate")}bn("wasm-instantiate");function r(f){n(f.instance)}function i(f){return Fn().then(function(u){return WebAssembly.instantiate(u,t)}).then(function(u){return u}).then(f,function(u){X("failed to asynchronously prepare wasm: "+u),N(u)})}function o(){return!K&&typeof WebAssembly.instantiateStreaming=="function"&&!Yt(g)&&typeof fetch=="function"?fetch(g,{credentials:"same-origin"}).then(function(f){var u=WebAssembly.instantiateStreaming(f,t);return u.then(r,function(y){return X("wasm streaming compile failed: "+y),X("falling back to ArrayBuffer instantiation"),i(r)})}):i(r)}if(e.instantiateWasm)try{var l=e.instantiateWasm(t,n);return l}catch(f){return X("Module.instantiateWasm callback failed with error: "+f),!1}return o().catch(R),{}}var oe,le;function st(t){for(;t.length>0;){var n=t.shift();if(typeof n=="function"){n(e);continue}var r=n.func;typeof r=="number"?n.arg===void 0?ft(r)():ft(r)(n.arg):r(n.arg===void 0?null:n.arg)}}function me(t){return t}function ve(t){var n=/\\b_Z[\\w\\d_]+/g;return t.replace(n,function(r){var i=r;return r===i?r:i+" ["+r+"]"})}var B=[];function ft(t){var n=B[t];return n||(t>=B.length&&(B.length=t+1),B[t]=n=w.get(t)),n}function ce(){var t=new Error;if(!t.stack){try{throw new Error}catch(n){t=n}if(!t.stack)return"(no stack trace available)"}return t.stack.toString()}function ye(t,n){w.set(t,n),B[t]=n}function Zn(t){return Rt(t+16)+16}function Dn(t){this.excPtr=t,this.ptr=t-16,this.set_type=function(n){c[this.ptr+4>>2]=n},this.get_type=function(){return c[this.ptr+4>>2]},this.set_destructor=function(n){c[this.ptr+8>>2]=n},this.get_destructor=function(){return c[this.ptr+8>>2]},this.set_refcount=function(n){c[this.ptr>>2]=n},this.set_caught=function(n){n=n?1:0,j[this.ptr+12>>0]=n},this.get_caught=function(){return j[this.ptr+12>>0]!=0},this.set_rethrown=function(n){n=n?1:0,j[this.ptr+13>>0]=n},this.get_rethrown=function(){return j[this.ptr+13>>0]!=0},this.init=function(n,r){this.set_type(n),this.set_destructor(r),this.set_refcount(0),this.set_caught(!1),this.set_rethrown(!1)},this.add_ref=function(){var n=c[this.ptr>>2];c[this.ptr>>2]=n+1},this.release_ref=function(){var n=c[this.ptr>>2];return c[this.ptr>>2]=n-1,n===1}}var xn=0,Tn=0;function Sn(t,n,r){var i=new Dn(t);throw i.init(n,r),xn=t,Tn++,t}function jn(){N("")}function zn(t,n,r){C.copyWithin(t,n,n+r)}function Un(){return 2147483648}function Xn(t){try{return M.grow(t-jt.byteLength+65535>>>16),zt(M.buffer),1}catch{}}function En(t){var n=C.length;t=t>>>0;var r=Un();if(t>r)return!1;let i=(y,d)=>y+(d-y%d)%d;for(var o=1;o<=4;o*=2){var l=n*(1+.2/o);l=Math.min(l,t+100663296);var f=Math.min(r,i(Math.max(t,l),65536)),u=Xn(f);if(u)return!0}return!1}var ut={};function Yn(){return pt||"./this.program"}function H(){if(!H.strings){var t=(typeof navigator=="object"&&navigator.languages&&navigator.languages[0]||"C").replace("-","_")+".UTF-8",n={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:t,_:Yn()};for(var r in ut)ut[r]===void 0?delete n[r]:n[r]=ut[r];var i=[];for(var r in n)i.push(r+"="+n[r]);H.strings=i}return H.strings}var ot={buffers:[null,[],[]],printChar:function(t,n){var r=ot.buffers[t];n===0||n===10?((t===1?Qt:X)(xt(r,0)),r.length=0):r.push(n)},varargs:void 0,get:function(){ot.varargs+=4;var t=c[ot.varargs-4>>2];return t},getStr:function(t){var n=A(t);return n},get64:function(t,n){return t}};function kn(t,n){var r=0;return H().forEach(function(i,o){var l=n+r;c[t+o*4>>2]=l,$t(i,l),r+=i.length+1}),0}function Ln(t,n){var r=H();c[t>>2]=r.length;var i=0;return r.forEach(function(o){i+=o.length+1}),c[n>>2]=i,0}function _(t){return t%4===0&&(t%100!==0||t%400===0)}function lt(t,n){for(var r=0,i=0;i<=n;r+=t[i++]);return r}var $=[31,29,31,30,31,30,31,31,30,31,30,31],tt=[31,28,31,30,31,30,31,31,30,31,30,31];function nt(t,n){for(var r=new Date(t.getTime());n>0;){var i=_(r.getFullYear()),o=r.getMonth(),l=(i?$:tt)[o];if(n>l-r.getDate())n-=l-r.getDate()+1,r.setDate(1),o<11?r.setMonth(o+1):(r.setMonth(0),r.setFullYear(r.getFullYear()+1));else return r.setDate(r.getDate()+n),r}return r}function Rn(t,n,r,i){var o=c[i+40>>2],l={tm_sec:c[i>>2],tm_min:c[i+4>>2],tm_hour:c[i+8>>2],tm_mday:c[i+12>>2],tm_mon:c[i+16>>2],tm_year:c[i+20>>2],tm_wday:c[i+24>>2],tm_yday:c[i+28>>2],tm_isdst:c[i+32>>2],tm_gmtoff:c[i+36>>2],tm_zone:o?A(o):""},f=A(r),u={"%c":"%a %b %d %H:%M:%S %Y","%D":"%m/%d/%y","%F":"%Y-%m-%d","%h":"%b","%r":"%I:%M:%S %p","%R":"%H:%M","%T":"%H:%M:%S","%x":"%m/%d/%y","%X":"%H:%M:%S","%Ec":"%c","%EC":"%C","%Ex":"%m/%d/%y","%EX":"%H:%M:%S","%Ey":"%y","%EY":"%Y","%Od":"%d","%Oe":"%e","%OH":"%H","%OI":"%I","%Om":"%m","%OM":"%M","%OS":"%S","%Ou":"%u","%OU":"%U","%OV":"%V","%Ow":"%w","%OW":"%W","%Oy":"%y"};for(var y in u)f=f.replace(new RegExp(y,"g"),u[y]);var d=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],F=["January","February","March","April","May","June","July","August","September","October","November","December"];function Y(a,s,b){for(var v=typeof a=="number"?a.toString():a||"";v.length<s;)v=b[0]+v;return v}function p(a,s){return Y(a,s,"0")}function x(a,s){function b(T){return T<0?-1:T>0?1:0}var v;return(v=b(a.getFullYear()-s.getFullYear()))===0&&(v=b(a.getMonth()-s.getMonth()))===0&&(v=b(a.getDate()-s.getDate())),v}function h(a){switch(a.getDay()){case 0:return new Date(a.getFullYear()-1,11,29);case 1:return a;case 2:return new Date(a.getFullYear(),0,3);case 3:return new Date(a.getFullYear(),0,2);case 4:return new Date(a.getFullYear(),0,1);case 5:return new Date(a.getFullYear()-1,11,31);case 6:return new Date(a.getFullYear()-1,11,30)}}function S(a){var s=nt(new Date(a.tm_year+1900,0,1),a.tm_yday),b=new Date(s.getFullYear(),0,4),v=new Date(s.getFullYear()+1,0,4),T=h(b),z=h(v);return x(T,s)<=0?x(z,s)<=0?s.getFullYear()+1:s.getFullYear():s.getFullYear()-1}var G={"%a":function(a){return d[a.tm_wday].substring(0,3)},"%A":function(a){return d[a.tm_wday]},"%b":function(a){return F[a.tm_mon].substring(0,3)},"%B":function(a){return F[a.tm_mon]},"%C":function(a){var s=a.tm_year+1900;return p(s/100|0,2)},"%d":function(a){return p(a.tm_mday,2)},"%e":function(a){return Y(a.tm_mday,2," ")},"%g":function(a){return S(a).toString().substring(2)},"%G":function(a){return S(a)},"%H":function(a){return p(a.tm_hour,2)},"%I":function(a){var s=a.tm_hour;return s==0?s=12:s>12&&(s-=12),p(s,2)},"%j":function(a){return p(a.tm_mday+lt(_(a.tm_year+1900)?$:tt,a.tm_mon-1),3)},"%m":function(a){return p(a.tm_mon+1,2)},"%M":function(a){return p(a.tm_min,2)},"%n":function(){return\`
\`},"%p":function(a){return a.tm_hour>=0&&a.tm_hour<12?"AM":"PM"},"%S":function(a){return p(a.tm_sec,2)},"%t":function(){return"	"},"%u":function(a){return a.tm_wday||7},"%U":function(a){var s=new Date(a.tm_year+1900,0,1),b=s.getDay()===0?s:nt(s,7-s.getDay()),v=new Date(a.tm_year+1900,a.tm_mon,a.tm_mday);if(x(b,v)<0){var T=lt(_(v.getFullYear())?$:tt,v.getMonth()-1)-31,z=31-b.getDate(),k=z+T+v.getDate();return p(Math.ceil(k/7),2)}return x(b,s)===0?"01":"00"},"%V":function(a){var s=new Date(a.tm_year+1900,0,4),b=new Date(a.tm_year+1901,0,4),v=h(s),T=h(b),z=nt(new Date(a.tm_year+1900,0,1),a.tm_yday);if(x(z,v)<0)return"53";if(x(T,z)<=0)return"01";var k;return v.getFullYear()<a.tm_year+1900?k=a.tm_yday+32-v.getDate():k=a.tm_yday+1-v.getDate(),p(Math.ceil(k/7),2)},"%w":function(a){return a.tm_wday},"%W":function(a){var s=new Date(a.tm_year,0,1),b=s.getDay()===1?s:nt(s,s.getDay()===0?1:7-s.getDay()+1),v=new Date(a.tm_year+1900,a.tm_mon,a.tm_mday);if(x(b,v)<0){var T=lt(_(v.getFullYear())?$:tt,v.getMonth()-1)-31,z=31-b.getDate(),k=z+T+v.getDate();return p(Math.ceil(k/7),2)}return x(b,s)===0?"01":"00"},"%y":function(a){return(a.tm_year+1900).toString().substring(2)},"%Y":function(a){return a.tm_year+1900},"%z":function(a){var s=a.tm_gmtoff,b=s>=0;return s=Math.abs(s)/60,s=s/60*100+s%60,(b?"+":"-")+("0000"+s).slice(-4)},"%Z":function(a){return a.tm_zone},"%%":function(){return"%"}};f=f.replace(/%%/g,"\\0\\0");for(var y in G)f.includes(y)&&(f=f.replace(new RegExp(y,"g"),G[y](l)));f=f.replace(/\\0\\0/g,"%");var ct=Pn(f,!1);return ct.length>n?0:(St(ct,t),ct.length-1)}function qn(t,n,r,i){return Rn(t,n,r,i)}var he=!1;function Pn(t,n,r){var i=r>0?r:_t(t)+1,o=new Array(i),l=Tt(t,o,0,o.length);return n&&(o.length=l),o}var Lt={__cxa_allocate_exception:Zn,__cxa_throw:Sn,abort:jn,emscripten_memcpy_big:zn,emscripten_resize_heap:En,environ_get:kn,environ_sizes_get:Ln,strftime_l:qn},be=gn(),Kn=e.___wasm_call_ctors=function(){return(Kn=e.___wasm_call_ctors=e.asm.__wasm_call_ctors).apply(null,arguments)},Cn=e._live_start=function(){return(Cn=e._live_start=e.asm.live_start).apply(null,arguments)},wn=e._live_command=function(){return(wn=e._live_command=e.asm.live_command).apply(null,arguments)},In=e._live_step=function(){return(In=e._live_step=e.asm.live_step).apply(null,arguments)},Nn=e._live_values=function(){return(Nn=e._live_values=e.asm.live_values).apply(null,arguments)},Bn=e._live_layout=function(){return(Bn=e._live_layout=e.asm.live_layout).apply(null,arguments)},Rt=e._malloc=function(){return(Rt=e._malloc=e.asm.malloc).apply(null,arguments)},Hn=e.___errno_location=function(){return(Hn=e.___errno_location=e.asm.__errno_location).apply(null,arguments)},qt=e.stackSave=function(){return(qt=e.stackSave=e.asm.stackSave).apply(null,arguments)},Pt=e.stackRestore=function(){return(Pt=e.stackRestore=e.asm.stackRestore).apply(null,arguments)},mt=e.stackAlloc=function(){return(mt=e.stackAlloc=e.asm.stackAlloc).apply(null,arguments)},Gn=e.dynCall_viijii=function(){return(Gn=e.dynCall_viijii=e.asm.dynCall_viijii).apply(null,arguments)},Vn=e.dynCall_iiiiij=function(){return(Vn=e.dynCall_iiiiij=e.asm.dynCall_iiiiij).apply(null,arguments)},Qn=e.dynCall_iiiiijj=function(){return(Qn=e.dynCall_iiiiijj=e.asm.dynCall_iiiiijj).apply(null,arguments)},Jn=e.dynCall_iiiiiijj=function(){return(Jn=e.dynCall_iiiiiijj=e.asm.dynCall_iiiiiijj).apply(null,arguments)};e.ccall=Mt;var et;function Wn(t){this.name="ExitStatus",this.message="Program terminated with exit("+t+")",this.status=t}I=function t(){et||vt(),et||(I=t)};function vt(t){if(t=t||bt,E>0||(ln(),E>0))return;function n(){et||(et=!0,e.calledRun=!0,!at&&(mn(),U(e),e.onRuntimeInitialized&&e.onRuntimeInitialized(),vn()))}e.setStatus?(e.setStatus("Running..."),setTimeout(function(){setTimeout(function(){e.setStatus("")},1),n()},1)):n()}e.run=vt;function pe(t){Zt=t,on()||(e.onExit&&e.onExit(t),at=!0),dt(t,new Wn(t))}if(e.preInit)for(typeof e.preInit=="function"&&(e.preInit=[e.preInit]);e.preInit.length>0;)e.preInit.pop()();return vt(),e.ready})})(),Kt=On;var Ct="H4sIAAAAAAACA+y9e5xcR30vWI9z+jGnZ+aMNJJGGj3qHAuppdFjZIJGY4RnSthCubu50d67n6w++/mwkpDlyC0/ZFsQ5V5dTRvbpANs6AQIjQlxa+Rcmkd8O0CSxpC4bQdoEwMN4dFgWW4T1m4u2OkkhjSP4NXvV3XOqT4zEnPvcnf/2bY15/f71rtOnfr9qupXVeTo3bdRQgitWW84Qufo3BE6R46wOfWHzh3hc0DDXzp3JDGHPzp3xJpD3A54RZDAB1Ee6NyR1NxcGIiepWePJCOeYMBz586dI0cICV10tOcwM/QscOeiKM8d4XNnNXcWHufOzZEjA3NzRkKYi3MQgYoTSXtu7mxYlrPg5yzy7Cxki50FkM2dgzKc1fFk5ub64sV8naVzR5x+3EidHBme6/+RqA7IEXoWMnAOs3H2rK4vXRzgMb9nz+piYwntOeWEBaZn0acKP6cLqMphqeKljYQZeuFnddkgNIWqYFhzUPHgrB4M65adO0f/E/49CxV1jhxh54L3fQ7rfm6O/icjETrHWjTFj9/+lrHDh4+dOXr46K233nHs6Onjh4+fOXb81Olb7ridEHB2lPPpE3fd8VvEAmTF8dvuPnbXLadOH7/98G3Hbzt26rcPv+mW3yQ2uK003O46fvct/+H44RPHj55SUdlH33THXafJyMrfOnr3LYfvvv3oqbtP3HH68Km7jr/lluO/tWvk+O1vueWuO24/DMHuPvybx08TfgWvTuAVPUHcA3efvuvm07fcdvzwrSTFn7Afs0copXQrGaHDwxOrRhkdSzC2jbI0p5xbFl1F6XZmMWoRTi1GWTrNduxMrqeTZNdY8tqEZVkW45ZlDVgW5ZQmLctaZY2OWSOUwX9Ji1kWtyz2astijNn0Vxh7zQaWtCjdvWGYWlZ6XZoyxgidSiaTA8lBsWd60LbswetGRwfhJ17rDZJhQjkjBL9kQpm9wk/a3CKEEG7Dg1JGKOGEE5uAR04I55rlhDCbEUIgL5QwixDgOOF8BR8hNAlRcsZUEMYY0JQRn5DVbLXr7n3d9S5zV7uum5yZlc4+btuccIjYS1nEen36GubYnDuUOOSGlSuTNJW0bPiXIIwNcW4zzilJEGuNk0ysTDgJJ7Eykd54Y2J9IplIDts2pwkyxBPcWpOAX3pjIpFI2oSwFCGc8lQyZS9LMJsuTy1/le0sI+OpFKEpgABZNp7KcJJIJAYSA4l0KpPhET00wPgQlgmysgne0xCQUHrgh+BJ+FqyOcvsxNrN2YQ9MEAoVDFhnFKoWMqgfdiO43Cb246dIlQTmVSKZuxMKkVIimQy6h+Fl8T0D18WQov8R8kw4YQyxgm8F3wl4J/DbwtJW5ZlM3tLmrGkbVvJZJInk1Z6IJ1OD0AmCaHDlCwb2r/GStJT9NPs08xOUppn+TxLpOkclc2HHidO8g/YSOK247fdcddvMzJy+PBvHb37tsPHjt566+Fjp++4626SGrj1lrccP3z36aN3nSaDGWSO3XHbbUdvv4kMpbXb8VPEdZB+y9Fb33z8bjKiuFuP/vYdbz5Nlq0+fPiW22+65a7jx04fvvnNtx+DXuHw6aNvuvU4JYnbsMcgf0rdw4eP33XX7Xccxg4EOo6P0fTdp48eO/nvj77lOHncziDz747fffqOu46TJ+wB5CUG/xt76Kbfvv31kPG33HJL7pZbyGcj5Bb45cjn7OF+JEc+b7t9EGANO92zKJHUeYSlnUzdfpLeR3+PvosWaI1+ij5CP00/Q/+afpx+nD5Kn6B/Qz9HP08/R79An6J/S79I38Z+h93LCuzn9BV6D/td9nb2DvZO9kfsg+wR9iT7AnuKPUw/QT9ifcz6rvW89T3r+9aL1j9Y/2j9s/VD61+sH1s/tf7VesW6YP1n66NWzfqU9Yj1aesz1l9Zz/O/th616lbJ+hvrs9bnrSetL1gfp09ZX7S+bn3D+pb1betp6xmrbX3Taln/QLv0onXJes56krZYi/2p9bD1X6yq9WfWx61PWJ+0nud/bv2F9ZdWiz1mPWY9bn2SfpI+YX2SttiXrC9bj1tQtqb1FavFvmr9nea/Zn0FY/sW+za7yIB6hl1ibdZiz7GX2MvsR6zHeuwn7Gcsz9/K7+Mt9g7+Lv5u/h7+Xv5e/of8ffwB/gH+R7zF5nmF/xn/OP8E/yT/FH+Et9in+V/zJ/jf8M/yz/EGf5JD7E/xL/Iv8S/zr/C/49/gf291rB9YPetnVtd62VLu3+Lf5k/zZ/iz/Dv8/7L+q/WS9RPr59Y/WT+y7rHz9t9z+PsCb7Hv8e/x/4r/fZ9/nP6A/+AK2Iv8RY29dFWsy3/EWyxv3Wu12NutotViv2+9x2qx91p/aD1C4fk+6xH6JH2PfT/W0yfoJ+jH7M/Yn7Iftlvs03bN/i92iz1i/7n9cbvFHrVb7K/sx+yi/Zj9mD3wD99f/Zj9KKds7hoi3ZM+2UjYrCAykxNEpnKuPUjkQ+9hgmRZRrLT0sq5f0p9upsRQW8cJICnELFmwV+WkcBrTpLdjAQgdRM3DlIHWMQdQaSb20hk/WW6nRBJ77zRmpW1l+m+2l+95+Ifv/3hZx+dm+JEVl+m+wgQlctEXv16yqkcONVfppJeR4gjWwgxIpsB0QiIdkB0XqaYg2uInMTyCgLRCPUYEyTIwTdnpnhWkH0/rSDw7Zkp7vazqX6WyO7L9Iab8feNGUHkWE4Q9x4qWz/UOW0HROeHdN8Dn3j+qfd/4vmLKmTg0guI/I+iugAvgshJqLDCe5gsvZtB3dbfzeRWqMwJIv/mZZplxEMCyyeIBS+y9BLJuQOC4L+HqeN8gVI2By/pnW/0qCDg951vFNSaFRgBEzo4s2YFgxCC4t/Lb7oQhijoEIFL6VDgUjqkXDC2LLNGKL7rJ67NbSNEkgOQqSyrXatCyqe9PrzpKXwb+Wc3BDtuADohpspyjrI5+TUsuU+sWXj/QpUdnOHlgwvmRz6lGLbfmhPU5rOCydGTHhFMpk+aWSAqMY8JIugbBkkQjeMRiEPQMH5nNZHff5kGgaGJBRn7uwFmzdFz7JwgNxD8dV9/LKQJuflOSOzPMtTZRxzPloVnqfte22PXEFmnJ326kQgmbEnc5ZJ6XDB8jcKW1F0umPzkRZqT5LUUMk92s+pFKhg0mhoQsn6R5rAJCSYbBt006FZAy9qP4fuDj6/wI+reC//LjpNz76fgpL+r/M+1J4GNs0bVs6qfFf0s62dJP4tU1n9MBZUVmhNUFmnOzQlqfl8F8Kk/oe9cbuV5g//CzBQ/oyI6pR4nBN2H38xT7//nmSl+RDZ/ArH3CMTeJip247M6ZEQOfcbByPlrwB9Q0c4a0QK8J+K/D/ykbP8U0mlgOpMqmR9ceO6HX+n+pA0esioeESX31RnoShB1jdiwz9Dfd/dnEOdYTlA3BxWMVa1fh8cdwWT7Is35lmz+mG7hGJElG5pOCQuqFml4nz1oEa0fQx7dD9A18LafoTlZ/UnkpQFAxQDqAJQNoAVAzQDaANQNoANAIwDYrOCS3jlIrtx0dMsZJP9/w/kf23CgveQv0VzYWrBV4OsygKDJdJ+BjqJwKd5o2pdijaZ1KdZompdijaZzKdZoupdijaZ3yWw0qqfKPwtlqFMQaFpyUSAEQ80CO2wtuSj+g071+0fZq+aSZ5WisioKyQRxP0p9Lk/9qjXLZrFZOr9uwcPNyVN3+knoW22xSiQl6A9n7trNUmKVsCGtVYLvZlaGOkBdRxyxyrMFB11F2IIIDjXjCC7snCTXESKYRyTxktcQ2eUnfQYdtfza++hudh+DCnwfChm+mzWo4DJzEnQfJhs0l5PfRTcUrdBrP0UFy7IG7fPkO74NjqPChsqmOYhqTCCWEfa+t5bz+TaZYpaATO5mrrClyEkis+4H6Rphy7U590OWcFBVOjXFDvTlrg4UZiz/HhRjHPS5D1mCg2o0ph6ueqQE99apl9XV4qUHjSa1m+Uhri7E0KRY2SLnD/sDYpVvv8GaEwPuzyiICls/B4SdZSmo8gFhb2GghGW4I2z3R9SjwnZ/TL2Ueqc2Kp8pOfBrGCzl/h4TA4KKlPsYhTq4jgyLlBgAQTicc9/F4K0NyAEIcVIMbCeO70giHJES1P2g7QgbVcwM60/MMRNzxID7r9RP/SqkCI0Jcum4JQaRCKcvYac/YZGS9CSkdlLSHAS2/JQk4K8veUlsMeBAG4KXuA0qLMsmfVum7rTmBBfD7o+oGHZ/THO72baI/xEFf9vcf8LnpC1sR7p3gsrN0bdvoycMNCyG3Z9Q96e0LzjG6f4zFXw7mZQcwvJZKM0B/DReeeWVV5Luy1A+JE96doY6jrBVGrb7MnVUS60H6gXV+obmK8DXaC6o0YGNRAzIVE61ZX/I/RKFt5KCj1I4ofbmZBlR35IDseG35wCgH8QRQ2IIPOGXkfNTWZbxLGwQDzCVWWEJS5L/edyzxZAcy3mDYkB+8g+Z+zzzuBhwP2xJ4qXYHIeUB83I4Ou0sizjDwsry9w3WLNiGAQu5sICjGTZxhFCfEvOvWGQSJZhDpsVlhw7Lcfe7A9LcgDqJ8tABL9C75T0dG47oVJA/UpsbI4Ydh+yoXnkvNQvyMB+azZMNjtCyBqVj2EJbzYDfVAKdVDqpSRxPCuqGn8QolMdw5BAxh+Ep4uVY90lUuN3uR9g8IlAO1TvDPKDrwc+5Zz7HPU5FCbI3XbiShskOvE4m+W6NxVJqCcu2ARPTUMXLrhMXW55H6OQ2yT0YxXq2yd9LvmbfUfSnK96Wvbrg1QkBZfszX5KJEXqfxrH9wddUA/e46+O+ylrTqQC35ZISX7afa9tS+L4SeFIfjrnO2HKSXTPeSnhyFTOw4/q31izIgn9oeqqmUipJiocyKFgIrmbVahq1zYq97+4AjiUqUo9LNvHqMfh03APE0deWOEeAWkrGCgnu1mZIl0D+o8U3QC6hJ1lTo/A/KS7HgvhZdms+d8iMgCywPBLZ1n2GSrYdvIE5lI1QUkOjMvEG8AZUpU/Xi4T7p/YyvvHqH4Z/KQU4IdPcOJvDscdN904SEF8iazYXNZoavb4jYMWvFSs5C5TpDvNe5ocm+Z5LpipIXWYYObYtx3jW1ARBZ4Tm0FWMKjtFsu594S10vwBySkv7jlB9Atu3iqIbKHLFu6qQW9beRzL+UmtQRDZUZjI+XaIdRWWzfmpUKFRVTHBiZf9H1W+7BXK1/k2CO+whNHHQ2T329QsYA/YqGz5p2lORMUqABuUKMOd/+4mY0VN5ruj0lq0ybhXazJQfSZqLdKIiCxepDnQ+K3oE0nB+5WpnJ/Ebo7gG8Ho3LX6+xCBEwEngk6/pMJ+aOgKhU2hH+wULz+CuSUYW3CdYf2KuaqSbDCSn7lpXGTDmjg2PsHJNG9epL+kDL+0/AoZHgvejpfF2vM2C4IjfGzO/lbVumD4LzYjLbLTOCdAZAVA7aEceZAloLOKLsJ70H4KQEeR5G//JZXtieFFygbOxF0nku46+PzDaQqckPvl1esjK6/WEPpeMSE3Q7QB684ew1Twy3aPwid8kepOiUedksJco6OCrzw1xdv4DnrKHTqtoIMiOEyHMRKoOWFMDQV2Sc53QrD+jOo1TujUlJ8izfnDoZ+2Ags05w+EYEsHzFM1HkvlvEE2p4rf167lMaNZ4wxV9qMZ6oDeMfTfOE+k57GsjURYWnW09MDf0qqjpQf+lh74W8bA38KBv6UH/lZs4G/FBv5W/8DfUgN/Sw38rYUDfwsH/pYe+Fv9A38rNvC3YgN/Sw38rdjA31pk4G/hwN9SA38rNvC31MDf6h/4W2rgb/UP/K1o4G/BwN+C+PToOZoAGBRDskhv9YdgDiCnp4wAbARsCtl6wBIxCLENwRxALmiS4KP6E+3jFLKVgD2BbDlgjyBbC9gzKvaAzVOVeMAX4BuAKQoRfTIwQSHiXwtMThCcnBDGhwJTEyL6RGBiQkQfB0xLmB/HJbPJE5yTENEXATMSIvxqYNI3/yyMkZ/9pXXhy67W1ajOJvzS3uTz68ifXwQhO3gNkU37pJ/eSETSVzPuyXDGPQmKLiiwoJNDXtKyzHICC4xfokjD+KkMT+g7kmqUheABkcZugYv0BK8w6NnT2HlQAKoaINeREhVpLQybn6/ja0X8oHpkRVrS3Wyj4oRIB+33EWy/aWiLrkjv+9nffe59zzxZqmD7TUMa5ctp5CFreZYTaVljOT/hrhFpaMe+JdJbeIlNYS5qNOenAChqoAqjSQAKCgAyz7AXSYOy0HGmeQNp2XVyShwrtqfZlmLzGcW2FVvQbEexRc12FVvSbE+nUnwjFoCD0zNEuREBbbUcsfqVyMozJOeuEZZI6GaGBapi/rEolagoZV0UqDsh0uysSG4nsHqThlUvjPgQ1IKmj0Aimj4IS2YTnMA4LC2b+NLLLwdTbUkIozuCJMSlewFM6ZQO6kzzE7LZIe57bZ97CaEmt9p6FSJxud2kYBb6MfgQ/QS89RMioZqUtZ2csGZFAvo5PyWsLfyAKqq1hR+CRJE6iF3YBD/ibRIJSPmESIhN0/yIIxKAn5rmp4DC9pkK+goA8vDeg84kAXGdgfYITiUayMaSdipSEB+KrlEUOUhXKYodpCsUaxrpMkXxg3SX4iwX0h06BQ0C6TadgraCdItOQTNCukmnoIUh3aBT0PiQrtMpXqdiSOloKXhshiKegaIHguQHl7+UEhOJQOX82cwULzKRAH2rAE9QuJiqox5VHb0Hsw1lmvOG2KzYJDad97eKrW8CFUVkQ3qz2Iz0UW/QEYPyvCM/Mwie58HXPDjPl8sPumOSyq+68h1DugfqzSD07Br53OAND7wfft+acccEBVVlUKliFMZVw5o2deWxiM3X9ZS44bxHUCy/+lKsCZ6n0zCTDWSBTsMcN5BFqhP+1IxwthMyPs0nRQI+JX9EBK0ZKRea1Yig0CiX6eY8ApkbVXlcEXiGzK9UZXDMCMYgzxDBnkBH2qMcJqf4pBiRsycFlbMnw4ElneCThl54k8i+P9CX5o7dKb+YkY8uE1l3TNj9CmTc48dG5DuG0COd4GM+vhEHgwC1IqDK5QevEsk7l8v3rcdIBjCA4Sjz4/LeYXRbhs1PEm8ZmxWo4m0VW8/7m8XmsMVomsK4AZvNZrH5qLfMEcvkd4ag2WwVW3WzQT86a+6YGAlzv1LHPC9GccSIzcvfFGXemhUjYrPY9KC/6cI0z4oRsVUAJcSIyCI15uBKhu+IIXwz0NDcnD8ArKvYVM63gU0hK4aC1xK0svvqqEclZIfl/OVhY1kO0WZU7CMh5ub8ZSqJ0RBL5fwVKp2VAQZlFpBPePpbjNexpe91vARfkdii3inxt4gtulaAKqtqQXAkBMsPhvF1Hy2//4afffgfv/prbzo4c0w+6sgLLka2PAy3IqxYfKmqtjNAwWddLptNxZoVy8UmkX3Qz0LNiuViqwDKFcvFZqRSYrnYghRxxHAguB9H44LBoD7fWe+vX+THogWqx2fUypRyLX+0TtTSlPb+IRU8IYsc619XaUZ9nepNZJEVwQcshH5P6p2MIesGn7KLbPh2UiIjJ2HBo0FwxQMr3mhzYlPfG7pvVJbXi03umHovV/b4fCbwuOLqHt++JvA4utSkly016ZGlJk1BE8YOaxioLL5BoARQDlD4NQ0AhR+SDZT+hlKLfkNGz12oY7eYkAULPsbgJQ6E3SRSWXiTSAl4iQNh7zoQdtQD+gPWr24g6F3NCPdAUtB5elsl8eygy0Ihp7sps/vq67I0MBYHRBzIxoFJo9vDpZp/SYfSEr8yTAeoclklEaBCoSrWAJzUXrGLpBN8j781GkmLrX2v8Z5B2RwXW5XH2at4/OiofEx7DN7MPLyZOo2AYj1YVtfAQ/VgfT0Qw68EC+wmUIoDxThQiAP5OKDX2FtxvEljGW4YwCP1YN3fDHJK6QGuv0kkJ3g5U1YKwyZQW1ENLyu1AYBqALgaqAXAmAbqASA00AiArAaaATApKKTYyohN56dBXYEmmpRtdEcM8pGUnQg4gEA3Ag4i0IuAQwjkB0PgCAKFCAAVummhWredjKG9lKUHKo7KUXFwGmslKUuDanBxBrmy5uBtQO1otqDYqmaLiq1ptgRMHRlvU1T1H4m3pvfFWlP3o7HWVH0yeH2gnZapWvhbvZGIlG+HHYWN1g7+emQnkc3m/A2687dV5y9052+rzt/Tnb+tOn9fd/626kGu0T2IHfUYoaa20UgVBiKvQv4A8jAiGkT+IPItEowoDiHfJsH02RHkOyTnu3quA9M6BW0TXMo054+hS5kiACOQ5cEIxFZWKn4GgaICYDwzEoxnAIDxzLJgPGMrAxQt9c6o5PQAxcYh7wpAqjiFYeOgGPRZeI4HJcaxc0pZUvhrzXoIh0cNlVIznBJsKqBFc/4aBOD7VRoHdFzH5Kdc+UQ60GpOmeqP/OCAvEcpPNeoEBsnODFDKJVn0RC+CvGqWIhlVw7hqRCDsRAjVw4hVIihWIjMlUNsUCGGYyGWXznEehXCjYUYu3IIJ+YU0yJfWRlokQPxOH40ABIfnNb0O90s/3i1/NyqxZxAEdwi1qoBxbhWIEX22Li/aT4SNrPH5YUNsqxiWA2f2BoRNKDVImhgK8RW0BgFxnDT+APz7gXqZ8+LLSKIqD0zHy6LlOf9LaBcChv00AfmBXAVKlaK1eEkyJqokU7wFlWNrkEx5gcwQIM6YrVasU6ws9g/3mjN6kT2zXpaP8rfPItL5QtUJk1fPzsfacezx+/UxQXtKRt6GqtjiTafhwwvXqLsBW+TCFbDrq/Pi+wFZ5pXE9H4/UEUcQaAKnM9oUbwtUS/YdrBfhYsyYy5sj2q888PBXKnMJTzU9iHp5AvDuX8IeRdJRyGcv4g8mNKPAzl/GHkhZIPQznfQT4L4mEo5w8EQsCY9p5V/TmMuZuJnO+GPbmrevIR3ZO7qidfpntyV/Xko7ond1VPvkL35K7qyVfqntzt1wXdsCd3w558uZEq9ORjuid3dU+e0T25K8Z0H+6KjO69Xei7JZHlBI4LxmKLmGJz3zf381XwYW0O+oYre3x8NPDo7nvqX372ieffXYGFhEISO0tvs3Bl4bNE24a5uJSRVM+yflaSwkWrmaRww4YFX1T5wcujsyK4ljEG+QTDrLvy7z9PcjipD6X6PLrdl9Bu3S8iX6HR8MfIvXx0QD68DPNrX9lp5ZWdVlzZafTKTsuu7DRyZSfUk69c9a2BoOqXX/0dvW8ZzMGEHreGtfwnYc/QncHUHrzgbxabxOabxrGBiMjrQ/P+Vuzmtt40fiFMq7p3Xo/Qj8wcl49tkB9RGbL6Fanmo3X8PPr5bIwXMX4sxrsxPhXjYVTd+TrJiU2CupsvdzegWBwSCZlvBQ0Q52VbvwHD7xbRq6gJWTLoskFXDLpq0LWQDsupi0f6TFZJn6kqiUxU+7s4GEjWQfHqnw4wupVMf7eS6e9WMv3dSqa/W8n0dyv4VU6IDHRnsyIjJkCpz4hND6DLBXeeggKfge5EEvlPahIhA/qShElvZM1RtzBky53yntXy/JAagUPbvfJQ/cmU4dEUUDdHHifl8Tvlw2vkW9WY3l6qx5VL9bhiqR5Hl+px2VI9jizVY0ZXENrlZFQlTKBlTkYVdBva5mRUYbZMg3FGRmU4O82LwKjOZ5qXgMGEt06D/U4GJtTb8MxOg71ORmyZ5k14bpvmDaYaR52ptlKD59ZpXuYiIbvPRB9Dx6DbEY0D3zfGO4L6Z/o7AsVnY7yI8WMx3o3xqRgPWek9ozuCUZDZbRItbyZkA1gnZOvADodsDdjBkK0COxSyFWCDCaIErM3mh6Z4+YhIyFbblEQJ2X4e+Q9TzTc6UTdU7xjdiUFXDbpi0GWDLnX6arl4Qlhy9qRaEUvI1jdIzksKSwoYPSe2k/whxC8nnD/kBC8kKVJ6QQ4pF9QnpMbEpnnQnZBJgdaUVAbUhV/07b80FnzSqatP0z2ckpfWBR5T/V8Bhj1+p/yT5bIY+hlb/EvByL6+TP5V6BGmRzAC0BFTZuZeWCH/aS16wxU2qAkq22AgIMJVZDB0h1VkWDnGZWRYMbTBQBp3m5RozhuW1U2eoww/xTDYY6FFqWkcqVbBwYbXHwCrexv8WWCMaolBMMHuWxSH5e5BsPtWq+HDWZbSXrOMnJSp/YNgLwsduCNbm9DStbXJcxwBdvAAoOlZhjv6IYisXsRlbDvLrFxoxBItpkP7A7P9lWB36q4Ey9mkEyzAo1k/g4r4GBVc2YJuI09QZZjMsqxGtYHoxasY8ncMQ35tBg/R/DSKpquiWefWcFvFfSzn/iVYBnY5vJGkx8Wq0Bx6VbDlbJUa9PBhxx0mTorIPx4FU9MWZ/YcPQtWAP/GmuWz4X4JWKVleguC3i7hc2VmSkKrvJuDPVvNi1h06h4VVDB3HPrd5kXqJ/oGjmhQJBLhssS8zG+SpU3KrrGHm3G04SaY5pyDqCZ4j6LlJg0tN/NMrd20NV/QfEfzRc1rk80SC6xPwHLeA1vJ/wf5Q8NLK8yhFeQQE9SWl0EGe5oPMoi2l0YG0fiyP4Pc9dTmxvyzFI20cSuLzm2ULxzeXqTlafgLG0MYvFsbTKNtQaChO87XGbzZc9cQKdRiO2gy+vW6x4PdixZYiPftXrSWuHvRWmT3otW3OxLKkYKdpLixcQvLTMHuGxitBBrdFXdXYlCPO+AB6FEfnWANwLNVHGsxhI1xwpaSUcHRjJyC+TuWhC+xJBxKgik6HoyLORi9gwedPQ9cpcDuzqkkWVpVa5HqDc2LbNNESSW/qzfLgpnb94EGsK0J6G16JHojDPN1xufwOOvb+wfVplwvgf1lQm+7VVoyh16OQ4cIdrBBh+hb4z6DRkDlqV9X+wiIl0RDcKr2LDE5gnuWUrBniQqibeNhz9Ik7EjdzbJgKbWbbYPpDyLYdeTVgshszqOCYf+GFvfCGr/8FalPSjAtl8GbFLA3Afcm8yzLuB8GZvakz9AVSjamdy5vJ9f41Mw5OK6Fmepx94Lto9pt6Y4QXjwjagccbPCB3RmIyz1BitAvkt3soNpDgnZXOAFwQNXYHtxvDnlyVZ5gahYyBTZ0sMtcuZPtZPnCXGWunqtDC3IFI6YBM1un+rJ1yE/DDDBm7BC0B5H+EFhZQVa2kbt9BklTTPpWwWAbiKCQ/Bp0DpvwiWDf8rEQOhRAy0MoFUD/PoQOBNDrQ2hPAF0TQmMB9OoQyiLE5SiKyDcM0gxzUJyA433Uhw9QKQKB/MMWrXZsY6uO7Y/m/d8lD75LKrjP8KuECByPq7Z5VsWqvzeP648NPmLoj3G3HFQnB+XA+YMPUD4ylzjL4GPN27iDiM2691LfQvH4bzG3VmioZ6l9ZKrhw0uGP5Z73nY4eByUDXqrz3M+tn80zcWVySRYHOLKJFKuMofK5gSH70FbGKJ9O5oioSc0NEIKbAjzVNEFinP5SZRCHP6GZpPwUQ/KpKoSyHPBmeIF6EJKDlhrlpxcaH9YRKRoIGVEyk4uMngsZTBYxgiGSNFACogUDCSPSN5Aehh1z0isi0g3QtDsyZniHZ31cmaKlzNgxYaxVYzYqohUDaSGSM1A6ojUDaSBSMNAmog0zbIMYlkGjbIgkjeQHobqGaG6iHQNpINIx0DaiLQzfeVtZaZg1Q/p4uAULw5CnWOKJSPFMiJlA6kgUjGQKiJVA6khUjOQOiL1wb48NAaneAPSbaJr0/DfQqRlIG1E2gbSQaRj1g8iPQPpItI1czuEuR0ySoRIxUDKiJQNpIRIyUCKiBQNpIBIYaivjDB8zA8pujY0xWtDUBvos26EbSDSMJAmIk0DaSHSMpA2Im0D6SDS6c9Dd2iKdyHdHrr2DP/5YWxjw0YpECkYSBGRooGUECkZSBmR8nBfupXhKV4ZhjpH16rhv4ZIzUDqiNQNpIFIw0CaiDQNpIVIqz/d9vAUb0O6HXTtGP67iHQNpIdIz0DyaF6ed406QaRgIEVEim5fuiV3ipdcqA10LRv+K4hUDKSKSNVAaojUDKSuDN0NpIFIoz/dpjvFm5BuG13bhv8WIi0D6bg50Lj6pUwylDJJU8ok+6UMWGjHJI0sjORMaQNGt/mRnJY4wPXcnJY6wBVHYmJHtkZyWvSAe1uFPaN8dxSnzNiTsqvYgmZ7I1cVQrI7ngsEEb7WtXE51BuPy6HC2gVyKL8uLod6a+NyqLs2Loc6a+NyqL02Lodaa2NySDbX5gJZhLlZlwvEEba5dXFpVFoXl0bldXFpVFkXl0bVdXFpVFsXl0bddXFp1FkXl0btdXFp1FoXl0bNdXFp1FgXk0ayrorZ0sXsKRaEEr629XGZVFgfl0nF9XGZVFofl0nl9XGZVFkfk0myuj4XyCWslvVxsVRfHxdLjfVxsdRcHxdL7fVxsdRaHxdLpQ1xsVTcEBdLhQ1xsZTfEBdLvfVxsdRdHxNLsqOKCaIJa2ZDLpBOWC0b4sKpuiEunGob4sKpviEunBob4sKpuSEmnGRLJd3VSbc3xOVTZ0NcPnU3xOVTb0NcPuVFXD4VREw+yaLIBTIK61/ERVRZxEVURcRFVFXERVRNxEVUXcRElGyopNs66aaIS6mWiEuptohLqY6IS6muiEupnohJKZn3coGkwmrx4oKq6MUFVcmLC6qyFxdUFS8uqKpeTFDJmkq6qZNueHFZVffisqrp/VJlVddbIKs6nimr2p4pq3peXFbVfVNWNXxTVjX9PlnV8vtkVdu/uqxqbeuTVZ1tcVnV3haXVd1tC2RVZ3tcVrW3x2VVa3tcVjW3x2VVY3tcVtW3x2VVbXufrOpu75NVve1xWZXfEZdVhR1xWVXcEZdVpR1xWVXeEZdVrR1xWdXcEZdVjR1xWVXfEZdVtR1xWVXdEZdVlR19sqq9o09WdXbEZVV3R1xW9XbEZVV+Z1xWFXbGZVVxZ1xWlXb2yaryzrisquyMy6rqzrisqu2My6rGzrisqu+My6r8ZFxW9XbGZVV3Z1xWdXbGZVV7Z1xWtXbGZVVzZ5+sKkz2yariZFxWlSbjsqo8GZdVlcm4rKpOxmVVbTIuq+qTfbKqMRmXVc3JuKxqTcZlVXsyLqs6k3FZ1Z2My6reZJ+syu+Ky6rCrrisKu6Ky6rSrrisKu+Ky6rKrrisqu7qk1W1XXFZVd8Vl1WNXXFZ1dwVl1WtXXFZ1d4Vl1WdXX2yqrsrLqt6u+KyKn9tXFYVro3LquK1cVlVujYuq8rX9smq6rVxWVW5Ni6ratf+UmVV69oFsqp5rSmrGteasqp9bVxWVV5tyqrqq01ZVXt1n6yqv7pPVjVefXVZVX9dn6xqvi4uqxqvi8uq1usWyKrm9XFZ1bg+Lqvq18dlVe36uKyqXh+XVZXr47KqfH2frGpd3yer2tfHZVXn+ris6l4fl1W96+OyKj8Tl1WFmbisqs/EZVVtJi6rqjNxWVWZicuq8kxcVpVm4rKqONMnqxozfbKqOROXVa2ZuKxqz8RlVWcmLqu6M3FZ1ZuJy6r87ElTVhXqJC6sigoypVVJQaa4KivIlFdVBZkCq6IgU2J1FGSKrLaCTJnVUpAptJoKMqVWQ0Gm2KoryJRbNYQiwdXVfCC5eiqIKbryj5G47CooyBReRQWZ0qukIFN8lRVkyq/KY6RPgFWVF1OC1RRkirC6gkwZ1lCQKcSaCjKlWEtBphhr6xwEcqyjvJiCrKsgU5L1FGSKsvzjJC7LCgoyhVlRQaY0Kz1O+sRZWXkx5VlFQaZAqyrIlGg1BZkira4gU6Y1FGQKtabOQSDVWsqLKdbaCjLlWkdBpmDrKsiUbD0FmaIt/wSJy7bCE6RPuBWVF1OWlRRkCjyym5VfL4h86InAyokI2KwBWOUJkvOsfdRbAyeDiDUfgjPKBN13fUHQ+/f96c+//t2v3f+vlRY5J9ac9VHIWGLNPnrWH7+yz3HDJ1uSzzX7+Fl/fF+N/TtcNlMhMG+/IJh11oNj51AMQ11/Qx0rh43hm2jj9bKykxwIzNAeUhsE+/nJGJ+N8SLGj8V4N8bDii+Yq4ZGFXi4oDvq3ks9Dn+SeFoWyZkbztWBWhFWqAfNxQDzAdgxwAcCsA2gYZOPrdTw+JHAY9MA9b5X0relsvG/q/MQOQy01QkdRJaeVsZ6Y7r1IQsWrdw480t5SemPVHkRhvJQvBjYyBFZMOi8QfeejuiuQXcMunERzt7q00LqCjLVkJqCTD2kqiBTEakoyNREygoyVZESQpEuoo42ITL/TFSZ3eBFXlyIdRfBOhcXNoL2IlhrEay5AOOqcgbgK+9Z6lnWzzbXvH622OVGq/e2kutI3RID+9S2iqe+NzPFa1bYpjGzFR1NRwev6GebqecsPF5Lr/xlqXaVFQPqrJCBfQ++/eF33f/NF35/Vm28ZdeRqiULA2A8Asd4zOb8zEYiK19djUfgXkNkmZ30UxuJpPI7jjw/FH5ceAbEdxz5bhPC5uszPwEWj6OGCa9IgGnjCtOoFyDXX9kHjYrRebFCrJgXK8VK3Pw+alot5lOyNSxGwWpxGxnz05LuF2k5t/8uPFG0TU76fCMRzo2WOmRWnef7xIh7jfy0cDcKLidz6CDftR7Z2ZOIyU8Kd6OyqnIgPJx4xeAIUrki5wMvcr61H8/PIf8WbXi2K+sYmoPDfUX6pJcGWznofNPuR2zBMSgYPabcpxlGAIZ6YESuU3VfpVh3EwHzizbB7UuwWdgosNB04QnYj/TMuPzeKBSezUkKfrOG36ODZI0kQQDSnYHzyNYEfK43e9yRX1guvzeoam87acJx/QkwSl8kQWV0/dmVsPEC/cvZk/hGl+B1gh9Yor+DS/R3aIn+jizR34kl+jt1ZX9Fx/B3Zon+8nSJHgtL9VhcqsfSUj2Wl+qxchWPP14GG3G0x+pSPdaW6rG+VI+NpXpsLtVja6ke21fx+K61Rj12luqxu1SPvaV6zLMleiws1WNxqR5LV/H4UEZ+Yjxsj0v1WFmqx+pSPdaW6rG+VI+NpXh0oHcucdU7t8wQN4tRFBHH75TfHZHfXhu2tVi0ffsBKmPyd1aEjY0tEMpdtlAq91i/WJY/G5FfXrtQOOtmxK9cqkfHYKdd0IyW6rG4FI9w1HVCG+chlVL7/YPz0xJbuPAoPLLeGpHYSSc9B7gxb1yd0N5k6rlH2MJ5LYVjB9bo4wbUMQPjoCIFotKG858wgj3qyJQEHh44qagjEBCpQxAWqYMQHKkDkEcHpWh4LEEiPFAM6RLVxwIkwoPJkNYGhEhrw0Kkz6gTABLhgQOJ8MAxpPWBY0jrA8eQ1geOIa0PPUNaH3qGdHCmAOaF4VljKi9sCs4bU3lhU3DmGNI9ikf9I60PRkNaH4yGtD4YTZWV4Xlmqg7YFC9rGk64q2gaDr6rarrGpmC7lco/m4ItWKpcbAq2Zdmg2jbhzH6tYOOzxNFIGr8lvFwg1FLVnq0JLrwVIqU2I6aUSm7LCs95Dkw423A6s3rfLaZfONjk60EXvkHZY8HhED3MEpzrrE+H6CoAzphSx0N0FACnHKldjEWOQIEH+xgLCsjz4JiIPFdlK3FVDC/931IKkcZ9N2YJoryrXDcgRZXfOpAqpzUgVR7bQKrctYBU+WpyrCGx4oZX4+/vZuaneZUjor7UJiAVHh4iVNOkqxIKTjZtzagkzONaWzG+Cbyx87wBN0HIDgd7ZaUDw3w91599SlEpqA6uu4cxMB6Ggyj5DbX193//f6k9PAOb3bk6FqrAcaYCx3B1fvlpDO1qXOEN/WzqZzvmr6Xxjn52uUqyl1DPpq2eDf0s2spfQfN5uz++no4nb2l/+lnUz5J+lvWzop9VS8VXg2d7rZ524rK4Vs/PqFhdXVpXcJjnUqNXLktrQ7IckZUomnwSKuyi2vfGZTMNbD1ga0NhmGpIYu6GdO6Gwddw6KtukFvDRLpbgryCSVKIRrnorM2Zm4V1IuX1kNf1YYy9LSGZ3xqShSidZkT2JkKS7Ga1bfqlw9NIqL4NSrYtt++R0uO//9KfXZq/XlfQQqi8ECothIoLocICyGTzkIPG1njxYSEwKGArIpsR2TA8bAvJdkR2IrIbkb2ILGwPyWJEliKyHJGViKxFZD0iGxHZjMhWRBZ2RC8vInuRh25EdozUIr/ViKxEZDkiSxHZich2RLYishmRDSOGnVGVRGQhIvMR2TNiiNB6RNYishqRFSOGiOxGZCci2xHZMmKYjAofkaWILEZkISJbEdmMyEZE1iOyZsQQtbN8RPYiD92I7BgxRH6rEVmJyHJElgwPQzkvLUb7tvvx6PiG0QvTvLPWCTt/MPgIP/5tERmh+e0RORmS1QitRmg7QtsRWtwRkbtCsh6h9Qjthqi7RfU8xbUwwSRLLOhgXTyfxNZsYXUucrVl8zVQfNQARpWig3pqSiumexR1BFTUlFZMs4o6CCpqSiumY0AFiqmr4D0gSFNazTygKFA+DyoSdNJDigRV9YgiQYM9oUhQbE8p8hScFZMKtNMKVXRTab6pQDstabquNN9UoJ0WNF1Vmm8q0E7PKLKjFNhUoHjWNd1TCm8qUFSbmgYFtqVpUGzbmm4r5TcVKKTdICmGim0qUEjzTGdNKcKpQAktabqulOVUoOR28LqbVNhGU7MX/BXhibnz/srwENt5f9W0imbVtIpi1bRKYkW/n7x2w2ytmlZZDeJ5cmbeH5tWxRqbVkUdm1bFX9Hvp6Hd6vqJ1bhyWr2hldPq7aycVm9mxbR6Kyum1RtZMa3exkqtAD4xM++vnsZXvnoaG8HqaWwWK/o9HFIuB9XjgCpBR+egqmM+o1xnMX6lsP0x1NU0NumV09ieV05jY15heFgxja16xTQ26RXT2Jgv5zgFbwCGfz5/LbVESvDX0miPsLdSpMOjD5BKqQPIHT20RAr3giGF+8OcLXyPR+Ex6a2BR9YbF2kxCrlOw7AxK9IwlpwUaRhL7hFp2JQoiWwpZSm9D08gSps630GFnlCPPO13PaXgAlXPcsy5qPGKftZj7lWNN/SzHXNvarwTw7sazzOdPoMjxmEUpDrh/kxoT2W47emet94H+4RFWlHkoxCyCtuihUjBGgEXDkxnuFvhcPIX7Jys+sLEik85OVna2Ifl/2wEarG71v0g3N5HdrM/Oiq4TO5m3bUgaEBJlN96ne4vYQkODklKaL7+HAk7X7qblY9q9RSiqD5HInFk+GsgrVKEOL77OA3V09rPSQ7Sxn7956Qv7fJnaF/ahSdopMBCHPo2ve7jNJKTBp03/BeRjvLwsYdYmId8m4Z5KLRpXx46H2R9eWg+xCJJBrTOQ+0hFsl1g24Y/ltIR3l4+X4e5qHxGAvz0HyM9eWh+kp/Hkpv45HaDXHoPOTfxiMtwqCLhv8y0lEePvNClIfiBR7moXSB9+Wh1+Z9eWi/EMVZfyHKQ+OFKN2mQbcM/50X+vNw35NWmIfWfVaYhzbQRh7qj1t9eahgOBVnAWidh+KTVqTqGHTZ8F9FOsrDUx+xwzyUn4/yUHm+Pw+Fh+y+PHQ/YkdaENA6D62P2JFWadAdw38P6SgP73lnIsxD5/N2mIfu5+2+PDTvT/TloYbhVJwloHUeyu9MRHqeQVcN/3WkozxcfDHKQ/XDiTAPtQ8n+vJQeqE/D/mXojjbL0Z56LwYpds16N6Lkf/CS/15eOjLyTAPvbcnwzzk35Hsy0O7kTTzgJMLX4Z77xoYgYq8ArTOTPXLyaiDMui64b8LeAHO+KX6jQHwNlhKDl4nAPfBAWFB2wbgrfl8flLxXwuTTMv/857VkAxeCFJQNN5Xkb9ntSEAYPIrv1oRpXtWQ29u+K0YdNWgawZdN+iGQTeB7ltoT8vWPagEF5NKjsr87y70U/hd9PMVNEFhZ0VKWjk/sZ3AnvW0Evz1u+qhBgCaM/GdcVAgoCQ8dAn9CkfS/eOggpBFHdn+cbxPIzxjeRYrRfsVdS+YF7uh7nij/VKzgnUG9StwJmuFGBUrYZZdrDw27q8So2LVTeP+qvPuPPVWiJVCUStFWvYKEEYB/qgKFmavXC77oxfUBSNd8LhSBGwH2BWatWXt0aDKbfnJR1fr1oQXyFYfXQ1HxhoeGgbdMugmBKQqYNvAOxghtCdbdg28Z9D5ekST19JiHRIt1I0XCxcgget76vhm36lGRDZK78+C7/Jn483AltXPRtHWDLpu0A2Dbhp026Bbi8TdMdy7Bt0z6MLnjCJ+bmEcRcO9ZNBlg64sEq5huNcNumbQVYNuLhJH63NqLJnUY8nuF406+eJC/z3DvfAlo1xfWqRchnvJoMsGXTHoqkHXDLr+pagtNgy8adBf/1LQRdmyjf5lJxwffyX0Z2ax8RVoMK2vGC/boLsG3fnKIhVhuOe/arTb60j5q6tVkyx9FRvwVxeGtnazIji6WZGCu0rgaCd1qTSTZZ7zbJEE0xMON0ptJy1YA8zAzY6TU3gmoY1H6E8qSqiDD20cnAhFueq4Q1tPgGf0rZBoQZ/pOxpyT4yfjPHZGC9i/FiMd2N8yhE8MsPLgBneZrj3FU5t5Ppw8iQcby2JfKsaFCX1DZclpsgUjiiQVCMPphb0YBHDWyMYLOglAIQFPby5qmWBaT6MTlS7SYrEa2kN4liDi0lJtL+E5ziOUpieMuEQC67qcX0l2KSicFUPKVzVQwpX9ZA6oBYZWLSqh5mFyY8KVzTMiZQ1DUK5pGmYQSlqGiZWCpo+g4s+SJ7CRSUkYeakrWGYOWlpGmZOmpqGmZOGpmHmpK5pmDmpaRpmTqpBbhguIySDw6yKmobpkoKmYRolr2mYXunpsDDt0tU0TJ10gtIyXJJQtcBwWUKly3BpQuWHoZGbyies5Wkapk4amoYplSa8Swrv1FEvtwwfR9sKXy7Ti+T4KtQCF5JtFr6JHkzZ2Dr/MJWj4+/AFI+mi3yKl7SfAp/iRU3nOS7PYB7Kts5DG4CKbeahpfIQXP7D9ec6qaisakC2njfg+nMdU5SrGpCt5xwwrXaQVjkBNqA23P0YlhdO9rKxkFwdiQ0FsNSJ+ZB/Sy1fQ/YttYQNtcDVKflQCVwtlkMd8DDJcsLR7+xy+Ap+UhULDofawquWtwbu2FBZ6kGW6gnj+1ozBcdV43dVTUAWu1bwSmpW+Eo6VvhFta3wk2pZ4TfVtMKPqmHpr2oLr1thFnuQRWPpM5+ExCqWx1XOfjcJx+1cRwr4rOEpyUlZQh27qwQCm+Bl6yp2Et9eCac1ggECm+DVq/n8yyFtyMJnw7cCi878dG6Ct/tMF+R3Vmu/Tlg7odeamcjN8oFB+dnAsAFPfdPbhzJy9iQcUwa3Ur8TDF9LlyJz3KJBFww6b9C9Zwyz3mdIzrc1BzuvtGFt+f/AOxEX2PY2Li2w7a1fWmDbW7u0wLa3emmBbW/l0gLb3t6LoW08aIkNvM35EjGO1lX3Pksiv0c0D7fOhkWOaJymuh1MiC+RHNxKp4zsud4mBreCJ2X3G6qELt6rYbkr5tVmr+4Q3nQxKvCkts5v+AwDpLB7/yOakzV2CpAtqklLhWhfcKC4v2YfvXff9z5R+tuPfP8D9/z53Ln7xZp9P4cLy+/Fw1FROJ659759tHC/v0btGgNTeTEq1uxbV9j39Y98/SNfJ/eKNff7a/aNvG1fPl968eevPPj9fwywV71NydeLP/2PGtldEGv2OYX7H4kOn9dUee98eDR9WZewMqxLmFlKmX5BiTKLlggPmev8BnTT/++VLLbTrnxt2DZq3gLT7boX2bFHJGzvCOhqFL5y7YLwRcMn7PiIu5fUifJVS21+wOPnREJZ8cMZu37SsOOHU3Z9DoDaVqLt92tHoM23+wz4Pbgnu/QcYpBEk2mrfrhH0rgJHG6ZjC5LhXPpakemePGN+npJvF8WQ9rqyEFbHcxtq4O5bWVFYmsrEsOoPQMPdS037qhYKYi76jKWh8Ngnb+waPIsbG5RN0H3zEN+qXk6LjVNubtgTC6o6m+Jz43ulgsa3agAloMjsrZacOU1tXSv7tK9ji3dq1i61+zSvU4u0StefE8Enfc5HFGMbApYCxY8kHWBtWEZBNkxYBOwOIKsADYJyyfIZoFNwaIKspPApmGphQj+gPufqaAXprELtULugCDCDrmD0MRD7hDIqZA7AqdRhtwJQUQ65E45D3DGzvE5dZ9ufbnPsTeFExZ5vH/CKXvVPylfsEnYpwt6KBr0UHa8h9Jbo5YQN8TMFsTMgpiteMxMfWx8N6svF9Ts8uj9Po13eYj1dXmI7C4IesUuz/2T8Mupzz8omJkG+yWlccPY9hv+1596q2fn3QfovPOJV7HhOessbKoYUZsqiKBZQnaTcE+boNuJdR3R5y+ycAc3hwMyU7sZ3nyrBm9nMnjGJFyizfBY5OgQxgRu4LaUK7x9Blu4La0w21DdY0p/tQJbTziI0TJ2btvhnbB2eOMrUqG9pBXZUeJBjJa5VzsBEiShJQjHMxOZsTmb45mJzNicjaWCvdz5DMwmo6uxUZvL4iBGkTGiQKRoIHlECgbSw4jyBtJFpGdkpYNItz8roL+1IStljLNixFBBpGogVURqBlJDpG4gdUQaBtJAJNqWjenCbvDSIJRlCMsyaJQF/ecNpItIz4izg0jXQNqIdAykhUi7P13Ynt2EdIuYbslIpYRI2UDKiFQMpIJI1UCqiNQMpIZItCEb04V94IUhqA10bRr+m4i0DKSFSNtA2oh0zDpBpGcgHUS6/enCJvA6pFsZxpwPGaVDpGIgJUTKBlJEpGQgBUSKBpJHJNqNjenCRuzekLLZg9ow/NcRaRhIA5GmgTQRaRlIC5G2gbQR6fSnCxu+0Vawi649w38PkWi3NcejB5mx2Zrj0YPM2GvN8ehBZmy15jAAgFoa7ksXtnl3IN0KulYN/1VEagZSQ6RuIHVEGgbSQKRpIE1EWv3pwubuMthittG1Y/jvINI1kC4iPQPpIRLtq+Z4nCAztlVzPHOQGbuq1Vh8eIq3IN0SupYN/2VEKgZSQaRqIFVEagZSQ6RuIHVEGv3pwkbu4gi0hxHs8I1d01w2R9RZ7K3+MLD1ujECIgdt8dUtXstDjWneH1U3gYzccOgPsuNP/PAfZubLcJhHY8RfdsPem16Zv/SHH56Zx8sZLbEsCieWi5GIK5eVLfGyKBYxKkaiCMBDY8SBw7fV9RJwt3vrmySn74UGthmwk8g2AjaLbD1gBbK1gB1DthqwMAVCtvDK/6ZMmonsBC4HkO0G7EFkewF7CFm430ffcgVsIWBPIFsM2FPItoOws0pKp3DSBEfbivUsWV4Gl71TWd2CR7YDCPeuotA2RL+t5T1OTUWHt9gLpD6ciAxyP6EkfiLnJ/SMNhr2jynZH5hv27BtM9En8RMo8c+EeyHyxhaJgrF1ArZRwEUVYHlPjbNeKMwGKJFP8XRlFhzPQvFoZVMDoHggs6kBUFlxYlKfynKmX+pTrRoUDUQpFwUDKcSkPsUDmU2pT/FAZlPqUzyQmQVboimeusyC41koHrls6gEUj1w29QCKRy6begDFI5dNPYDikcumHkBlK9OvB1Ct60Syn2pdJ28g+Zjsp1rX6RqI0nU6BqJ0nbaBtFUxW7qYcPYyC45noVr7KRnpKu2nbCBK+6kYiNJ+qgaitJ+agSjtp24gTZV0Qyet1JSm4UGpMi0DUepO20CUStQxKyqmEFCtSHXNDA/1KwFUqy8VA1EqTtlAlBpUMhClKhUNRKlTBQOB85lZcCILxUOYWXAgC9VqUN3wr9SghoEoNahpIEoNahmIUnraBqIUo46B9FTSXZ10PqYZUK3TRJoB1XpPwUCUblQ0EKU/lQxE6VhlA4GjmFlwBAvVylDV8KCUoZqBKGWobiBKGWoYiFKGmgailKGWgXRU0m2dtNKHOoYHpQ91DSQf0w+o1oci/YBqfahgIEofKhoIHMjMgkNXqFaJyoYHpRJVDESpRFUDUSpRzUCUSlQ3EKUSNQykpZJu6qSVVtQyPCitKNIaqD4zrAvXPvbw/OZUzk9FdTICkJvz01GlIDQWXHGLtYKQCK7BxWoZUSNNfY8k1gtCk8ElwVg3I3g6zB5dL+hh9qSfiCpmRE295XwWVQ1icEdlMqocxKIbh7EyEOuEtw5jlSHWDm8eJpKiOLbMe41uGiR49VMfkI4DA3HAiQOZODAYB6wJvqcfUKcFxD0diAMH48ChOHAkDpyIALiFHa+c6YwIKuzrSHsEvpERPUNL4bTrgMwvC8lCRBYjsrTMuMDQHzGWZc6vlX+xTIyoOxz39Dn9RQauW9dOqSuESsQj7AvlXiEUu2qosSuESl41lLhCqKGrhspeIZR71VCTVwg1fOVQOMudZaVDHkwBWrtZ6ZCwUam0s4xkmTVCYYJmG7mXhleLnNG3l7RHYCL6OYfZc0MwadW01f1IRJa/SXDhAxaEes8qGo4BKmkczgzqajwNyrHGB0Dn1jgsLBQ0DpdctDUOZx/lNQ6XBbQ0Dgfp976haDhkvqnxEUEmePc3vGXwbBz2lsMVKhPq4H1YrPKZuwJGJMtgmFGywRV6e5jvRZcR4YJLWbl0DZdhMQQuFeXSM1wGRQZcqsol70YujhgAl5pyKRguaZECl7pyKRouSZHAIRC8IbVSpy6PPww1+ixcdiPbAYi1r7COiVUU1jWxqsJ6JlZTWP5ZA6srrGBixWdhmU8Qef4JuHCO4FlWzF1xw38cffgNz/2H0zPzUMnFw2WVz4VOJXAqLepUBqfyok4VcKos6lQFp+qiTjVwqi3qVAen+mFHXSqPFQxLmT6L1o/gsqwz0eqRvm5eXVsEZivR2hFeHW9cDfMcYnBpqV47omAqBYM8P0iOwaqD+zvY6P4evcNSU4HD+hPcxlN+QaVYtvRik+ZLmi9qvqj5guYLms9rPq/53vOK73G9NK35ruYrLxCYCoA77nWIqo6hqvma5muar2u+rvmG5huab2q+qfmW5luab0OKNiBtjXS0j47mu5rvBmXQfC8oY0eX0dZ1oPmC5ouaL2oeTisD6WPDkV9MWMJ2V68RRC2JNG6VA6fknltzPsOVRR9XAb+FeVRT8NsJGdfmVHl49QV49RyvqcTUNOsqtqTZMf1talboz1KzWf1FanZSTZnY+nNjePEmhP5W+AkyvJgTojCxqsKqJlZTWM3E6gqrm1hDYY0Io+riSeedjLI5fdSTBR38jXjZnVAKnqDBSU+goimcIQfHaRoHPbl4zZsg7kvUp4K6P6HuT6nCbcR/TD2Gd7QRSdzvMw+mFDjWDJuD+9Fgxai8Qtjul5lP1eQHFezXBpnALV9M0tOS3uX4zP0pAHBNEiQBK1BwwRjDtSg1QyKI+0OYpcC7HIn7x3AnmGJQP9SZd1+lWDwvylLnRTk/G2azZ7E+4OK6/XBIl/cGeFeT3kaUwt6r8B16m+BxwtsMjzL1svBsUW8LPIvM24pTZcybgGeee9sgjqw3hPLfG8Zm4bnwOOKtg0eJetvh2aTeDngWmLcTnnXmTcKzx7xdEIfwRlDz8JZhS/OWw+OQtx7Tpd61mC71Xo3pMu9X4Flj3mvg2WXebohjzBtFncdbgY3XWwmPg94GTJd6U5gu9fZgutSbhmeVedfBs8O810IcrrcKtS1vDL8HbzU8DngC06XeXkyXeq/DdKl3PTwrzJuBZ5t5sxBHyluDep43jp+YtxYes54HjzOexGSptw+Tpd7rsaqZdwNWNfNuFPuBUsu3fnIemD1qPTuFzCm1Yp2YL+PEZYWqZek0OrapWnkeULOaJaZWlx10bDK1gJyZB6NvHyUQPQ8P4g9ewOuSz6Nei1/xef8acOrQcmhJAfOih8R+sVYk54UnUvNCCszHPpGeF68XkOoNwpkXNwqVxloUZfS8UNGnfO+8GBdrzvtrUMPpi9ofh3Xg/WI1RC4g8r0q8tdB5Ndj5DMQ+ayOfDUKwzBy1xfnxZhYdd5fBQ69/sjHYFl5v1gJkW+AyKdU5Hsg8mmM/DqI/LU68pWoeoWRj/kbzoMp/Hl/FBzyrC/yFbCmuF8sh8jXQ+TXqshfDZH/Ckb+Goh8t458OcTRDCMX/vrzYpkYOe+j4lfoj3wZTF/uFy5Evg4i364i3wGR78TIJyHyXTpyF+JohZFn/XXnQe077w+hetMf+TBu0NwvNkHsmyH2rIp9C8S+FWOfgNi36diTqIiGsU/6ifPiVWLjeT+FGlJ/7GnYBspmhW+cEQRnjayN8atj/MoYvzzGuzE+GeOvifFrYvyqGD8a40di/FCMT8V4+HJikBfjRYzfEOPXx/h1MT4R4/fDaXcJkTgPf940SMS4GA/pMTEW0ivEipBeJpaF9LAYDum0SIc02U7KsHSyX1+ieVBRk7CgsB8kDEFrVaJgAYsZSI3BOgZSLkzPI5WC6fn9ytQHLjx2xX6xH+Yt4JJVIEUO5BoX+2EeRl1Di0YrcO+zpamUjx0T9mBEr7ugLYuFBi2Xe1jllipP4xIIGrZYaN1yuQdXbm55WhmLgpWLhaYulyWEchsrTyubUjB5sdDu5bIEUm6iPK1MT8H+xUIjmMsSTrlly9PKQhWMYSy0iLksQZXb5GW9fhJGg2A1C8c9pnDTNhFDuGmbiBHctE1gJ08enmqjNhFrcKM2EdfgdmcikrhJmwgXN2kTsRw3aRPY1tyA52rcmE3EWtyYTYQP26Ml8d7giP36Wsw3OB/gzDprz2Ez9ZnqcTg8Zn2rXPbtvoMRiLAjs48HfRZ9z2goFLKCXVBxYZ3sOY9GdnhftK4KF6BUAKV0jU9zdxgqhsEw4pifEJagIiG5JCIxnlP2ruSmcT+hDiUWCWkjhCTNSX7KT2roPK4OKSwVYFfMOw5+RFLyW/20SAUpCSpSAA2IZACd7y+iKjYEPJ2DosDQFkIkjSgSIh1wZZ1UyvCf6vM60OfVuTfFEmcH59ShoillP6PGym8MDPVoqKiXNasV9YpmtaJeRRZmJtPR4Fhh2Zw/EA2OFTaZ850QayhsT87PhFhTYbMn/cEQaykM5iiHQrCtQJikHA7BjgJhltINwa7O8ZHp0OJYjR/9kdAPmCTDBB3J+ctCsHBJBTwzHZozq7Grvzz0U1Jggeb80Sjg0ypgMAnwdF+Flp7uq9Dy030VWgE2qssqnpYcVS2wUQ3WgY0qrwFsVG9NYKMaawEb1VUb2KiWOk/31RIcsSyi+oHTl0VUM3Aws1EzcGaziOoEjnMWYW1kWeGNcOG2SF0eTI7lXLDZT2P5PfWV4pYi7CdsYZ/3LWGBTOCChzQTDOmjcJJtWp535GcGYeptHnzNg7M68E9S+VVXvmNIf009dQzws2vkc4PhwRZgphgc2fWDGdzREx5z/TN1UAARTHeVXHeVtjrTAubJODxSHoOH69nwGPMsSeVLRsqpWXfMyJvKqyWsedBmHgxvge8+Wn5/uHHgmHzUkRdckYC50r7u0RKJC54F68YXPDi+N3EBLjKGB3NUJjssdlZ3AW4wtqZhw47KvS5VlzkihQf+Ok3G+Fk6J7s/pFgu2VOEJfM/QgIG8vUXwSxO92TTvHYbtKMX1QC4jQNgtUyvaCgjkb2AgQiKzymmXC4LdsNjqyo/XvbNf3h0vqxbKEZ/w7a/fcffPvx7n4KpJpw7CqJtmdF2zWgLUbQ6qoaKKjKegFGAMjFomtF0zGjyC6IBo//tRE3Jdl80jhk36HZIJ2CEjxK3d5vjbCbRjoBOsCNAR4j+iPL3VcboHMWpYHrSZ3BLNKwIBB6RuxDOFzKcAqMq4u7L1D2Hg3j4Ypq3wgiDwTrUD7SdxBlkOwGbp8i3fhBaVTDoq6Crg+jUHJwDcdVuw9uxez+k2saDQTvQ5h9MzS8waCx6OxkDA3C4z1yVU2eTqdyZ+ScL8k6CvGOrijKXQjYsiotsWBS4yF0syDmTTdA4nG9YNH1WyzFfmeDM+ykc0M4rk5zUvJ9GJU7z7jyYd8CzXFYDRbw0OzWvBnYJ1MXm1UDMwRExfL0Z+JLT6n5td16gryzMV8N4GzwMzp/3B1Dpg/ltTAyH1mpUPXZ5pIPK2uXxTbnsJ+bP+0nUAiGq9LxIicw8qMWg/EGrfEBLdtT4IGEG+RCYcUhOYFIHYPKbTfCDEAu7rKXroKkg6BEd9IQOeioMekYHzVMdtkB1YDcIXKQ6dInq4GUahq9QHUE1iKAWRDAWRFAPImgEETSjCFpBBO0ggk4QgQgi6AYR9III8iyMoMB0BEWmIygxHUE2iKDMdAQVpiOoRhHUggjqQQSNIIJJ5+0J6pyFT1d+BbZqeSSQVVFXcxOMjYhgD/qqo4xO+QJdbpqjMo7qKAsN46GJAasN46GRAZtQtQbaMrBJVQeo8DK0hFeKL4qW81fKwp6FWajoLIAs4fPnITJbWc7TCX4AWrEC08qA/vLneRCauAIHlB09ncAjkjTIYFaGwswQiLXzKOHOm9sEVI74g1DiU2aO+AWAqjpHZ0QCw6chvODzvgNTD+iE19SD20DglsGZA3TEo57AkQWOHM9/ojg7lRAJjDM9f144wpk/71vxnFkPQuVXqJk16wJUS01nrYp6N6YP8WQgHmHjO6vqXKjzvTAX4IUHXhI4NKI4N5YUSYxjAOPIzJ9XNWYOgVSO7Ach9XZfjmzMUV3nCE+jSmJyA5gcxKbqT+Wrg4niUV0p9MbQG0dviTDpeMNRZ9SGDQhUIrMFTfMGKBrO2z5s8a1np+eS5+DmhcxJf+9GIvbq+XglbhLIVwK+ZyNfDviu4ksB31F8MeDbii8EfAv5LTx/ZIo3bbFXFhI5vWIUrBXtlS3YyYRCPlhT2gvHf+oVOW2YsFc2EKqZUB2hqgnVEKqYUBWhsglVECpFENnCi4e9m8ResKtTZ03slZ0BvX9wryyHpLhpipfTYi+w3QH1rA6IvXhehOZb4F6iOX9yn06wSHP+RMDAYGN3wMBwZFfAwJzHawIGBjPbNKNO79obrqvtlWWaU9eHB0t5ByDHJCf2wjLbXtkbyEG+7Zw/rTX5vTLvAAZ7jLeHWAGxqp3zrw2xImI1O+dPhVgJsbqd83eEWBmxhp3zdwaY2DvBS/Y07w4IXXhdbF1gXVRdyF9UvKaXE7FygXGkTgNfrpMTUQFrTk5ERas7OREVquHkRFScppMTUUFaTk4ERfglZLt27YJst/uz3enLdrcv272+bIPFZpRtsOiMsg0Wnzujcdo73+jthuWa5El/10YidkEx7Zz/GpyJOyV2idfgNNwJRQmw4EVqDEx7kXJh7g6pFMzdIQXGu2IX7q95jdwTfre7ZIMDUuDhZ/uaLbzFvZvg2ebecXh2uHczPLvc+0149rh3Ap55y7sFnk3u5cQufWzxLnEL7tnfJU7gPv5d4jdxb/8ucTPu998ljuMZALvgGyxZKlwD+ByeMfCa7aQJm6B3yYaV8ycgfrU+jGQJN38jWcTN31g6WO7tWoqGpeCOpmEhuq1pWOIt2IqG5d+8pmFpuAfZoJB9R7xmgrdgbzvmq2WrZxk8UzS52AWfozcB+SzZ/qQ1q3LTjvIIS7eTioRV3awiYcFXKLKHm9mR7Ebl6ajy4JEGtqPSLSTVs21Deo0E1kvbhldWtnOyQvVbpODVEZM3YnZ246L/pKJOqBzsxrMqhKIOqfR341kVrqIOQOoTYndwVgWJsrI7y4h3rSTehCTeDhgxJU/6UzBigntmvG0Samv2pD+5YDZ8jaRicoKnFkXdRdGxRVGxKJpdFJ2MoXxWbBOTYkJO3or96J6+ywymlSlaPzbBD8SBg3HgUBw4YgLeNjEBNuQTyoZcUm+azYptIOkn4Z4DY4x8uXhlgy8DUDOBkHyTCl2Mha7EQ9evFroUC12Nh25cLXSTx9YjJid4axGsvQjWWQTrLoL1FsHyVhzT/QTUZr8bNoLiIlhpEay8CFZZBKsugtUWweqLYI0Y5kDmS2C5NonnlUz0tz8x0f/F3AmAGwfG4oCIA9k4YH4Ydwb5wE5lEnWM/0/yAcCeODAbBw7EgYNx4FAcOBIHTsSBU3HgTBzI0zhSWIAUFyClBUiZLqx6kDPGIABu4wqnzlQbl8TbxuDlwA0QE2gVADMYE2gSALMa8D58GGCVy4tOZuISKb4kn8K0BrwdH0fhE7j1fL4c900FVdOlOGD5RdFO+paOdo9v62hn0UBhQbTWPA4SYeJ0oTMMiNT0bAKdr5hqGux4YQqRzZ+HlDkETAgKXBJmY3GmZ/78vHnKnWEQvM2RsAK1bdybdsS0408PEtDSytxj6oV4VEyJSdS1yprM4uHTSArcLoTkGO4iQtLFGT4kUzD3hxRO803JCs2JSVhcuS5QuaZkj+fUOw1Urkmtck1qlWtSq1yTWuWa1CrXpFa5JrXKNYX3A9piClSuriWmQOXqwPM3Ue+ZApWrBc/jeFzSFKhcDUuF6wGfQ1Ut6EqnZM/K+dMQv1K5kFQqF5JK5cLygcpVthUNKldJ06ByFTUNKldN06ByVTUNKlfFFv83eW8f41iW3YfxvcevKlZVs79mqqZmZ+97M5JqVEWymtVdxapSd/P19EfNx+62ZFluW5bdq24JDfbE7lltgEmw8HBtJ+EgTsDYMsBuO1mSbdkMICNM4GCJQPZShmSV7dipGI5Usa2gYBgSAcMwnQgIAzjezO93zuN7JKvnYxP7n/Rgiuece9599913373nnns+diBf9GGjHXlDW9K6WlJ+j3CJRXvSYM7coTzM9pyErRShS9pOoYugCF0ERegiOAyfSIQutqSWzMBCy2ytYjD4R07F3ZVG9FLyW0+OJ8wdv56syLQZSGGspJfKmB2I+k9McSO2/F3PakPzQtKHBsiHglQtYhw4O9SkAK0pWhe0rmhD0IaiTUGblikaG+O38+srMDX99RX7I1P06/0VThf33CxnSvcsZ1D3nFkXWcc9z0/WvcBv2L3I2cB9ibKTK4KVO0+py+U8tewuUF5zF/EDS2bIdO4ZCD2broOfNTeOH+Mm8LPsJvGTdVP4SbtpbpPcObPOycvYPLFfClMTmjMh/IFZjCILUSQTReajiBVBYOH11HNM/KkXN4mnXsIkn3pJk3rqpUz6qZc2c0+9uTC6Zwg+XMURsZl7uOohQFj64aqXMkmTwrE0Tn4erkKrbRIPVxGPwMQfrnqOnmn919cfUva2cd60roYHGfsjsxsv+zGznt1ctF6BW+iSeenr5oy5iOc0F/CA5jyezJzDI5mzeBaT/foHqC0Xiy1ayKG7ZQuGOXDdrMNKogTpMrdtx8dKIv/3HJMzJf//cN5Z/e5zN+6gPVu+801vo+IV6A2yK4dnuxCIecBTgFWDx7gsBSo7NsQUfsNYOPpzpAAR8zZMeKew7yLd7u2umg0q/lufzMJNubLr8ErjPJ0tG72wViwSY+yBVuvAwoKX7mKbU8CZgzQ3geZKnTXWaeHt86Ik6nqwir+Rtyy8yBBUOP2pTGLi/tiee1arbSzcP2O20Pdb6h3KDsfb8n/P2bbj/u85bi6jI92zZPWNj0fJL3mOcZom5/+z2IFXWIU5Brr64apnmfjNn1rK/Xf/5b/8l9fbMGvG+IIqmqu8NaktXDeWrOZxNRH/00HNn6dOk8HmZN9CPZtUPawJxDAvhLJQYWO+4ASw6yirgW6a0BoU0jpjrEtAoHW8hXuCZX1rwcZ4X8/KHpkfPjpjfDrb9qxxt5gQfLh688//5g8PMvmzf6P5cC9Ga1mMePQYnhx7hnFaqYfABxG8AsJomlCNTxFq04T6NKERJfjxt3EaHrbxlrQkffMv/zn7v4hSOOUafcYLfMbgBZkQfLgq/Fgy8Hi5mHUrw6S0Rb+2pVrKIhKnBCCWnzhIYekgLB2E1MalELw8Bg9D6mFIHYXUUUjtFEPwyhg8DqkDp5J9E9d8WSP3FuEoFWYeKfq9C5G8JEXJzTQuzeZR3a+vVPhVYf3qOh7P6bGUObhcC8X4oN304g/QNRF1ePAmvtfOti1o1OXrxEx2/OsrGTTu761U7G9F5pSJD+iV6GSDcwtePMkCb4fnqAoxbENvNaTosMKmhODDVcRL9ufcXQzZIj6O0q4z+vsrqOJ/WoG4wOUXH1PRr5Gy7hwIWlf0rqANRe8J2lT0vqAdRR8J2lX0iaA9RT8UtK9o1RL8UPGa4keK1xU/Vryh+IniTcUHincUHyreVXykeE/x6pHgfcVrih8qXlf8SPGG4seKNxU/Ubyj+EDxruJDxXuKjxTvK1619fkVryl+pHhd8WPFG4qfKN5UfKB4R/Gh4l3FR4r3FK/+z/r8itcUP1S8rviR4g3FjxVvKn6ieEfxgeJdxYeK9xQfKd5XvMrFvCjqp11GOS4yBLLZZM7B3fHQPBZiw6l4W2PiiRCbTsXzx8SBEDtOxbsxJg6FiKX/rTFxJMSeU/FujYmIj/zJV9F3Kt7t8MMQ4qFT8d4OiBRx3ZexIYb6MfbYK7wRMwWzw/OVnF+qmBwk9uwWJRp3Dj/GncfPspvBT9ZdwE/aXeRy7i7ZZZnKvPVcbI2KU0xmx2mZldegL6yYXPayWTdzu04nZdbN/K7TxG9m12ngd4FhRNfN4q5Tw+8S446u6zFAV8H0rtNTMLvr9BVEhh0Fza5zpODarnOs4Oauc5Iy69k3zXqYnm8dnvvhXLo+mQFqfSID1IKVCaep9akQevFvTcs9OBUe77bbp09xD1Zbxh4zPc/+FasVGo1mbv5n/+K/b/6ff6t77ZdgKbW+Zh+nvZIfe88tUxTNQxTdh3yWM/sVbx/y5waUCFbL40Ye0lU3haghTz3r5sF/8yvP/vff+g+vPRQFwobfTFe8q3yMB7ci0/nPfrAYM1cpAGbMPjSUqLUab7m4aJCquPt22ZTxhjfgxOhtUDQ0FphjLa48Wtly+TkFzH0RJ/MQ8/IQ82yRun95ybcq2/YvL2GCn2GCE8+6KZGFw+goW/Eum8u42ScbrW7KROxSSVni33kY4wLqb4Qry3K5HXkBrRfKSp5Fgwax5VqHE3zwfJ9s8XowH9CSE5bgLiCSRUsGLHFQdpiaKBmGJUeTJaOw5HiypHp2XHIyUQLXoAQ1dW5S9qUp2Zemx/vSM7IvzXL4u2f5Qbjn+Im45/nRuBf4GbkX+WG5L2HI84YWPzpuaFsT7alr8UsmO1nQ0IKL5sxkQVMLLpj0ZEFHC86b1GRBVwvOmeRkQU8LzprERAEae+RAzYZuggH7CXphkObXAY06yqJvIig5mS4ZBSWD6ZLqnJYMp0tqQclouqQelFTjkyWy3xiI+rExB3/YOfTVnDwgpPLJcdAJS0aTJd2gxK+mxQow2mPjwtpsYX9cWJ8tPBwXNmYKpR29My2PWkZ8BWfgS3tG9iy9Myan2qV147Cb4+Q6BNfhGXzLZ2RYo6PjE/c9DkuGkyUnYclosmQQllQTky86LKlNlozCkvpEiXxsVWgcqtkM1y2cPkFLigl1PuDozcOzeJ69wZmnimGMbxuv8wiv83iu4uWNZRa5R0JxPvI4WrjA/dJU4UALMxwfKS8+WTzU4nlqw1PUA0SKR1pMDXIn5SUnixvzYrCAGQNWHFw7OG905iteGaZT4czq0U7NapsyKgjmc7z2tJk3lobwyotOOmUyY1JO1aA6BGo6BNBrh/MYAmiFvoD4RPuOw5LGZMlJWNKcLBmEJZ3JkmFY0p0sGYUlvcmSamZc0p8sqYUlhxMlMij6eLz+fMZs/GCyDkQTrDhrdowLn4oo7rUXLXbNpihF+hue8/O3oBxzqWwy16SK77bDDNE/jwO09ewVqgCyV8w63GX6WXzs2YpUKo+CQcydd2/JQ+hYIFybsowke6zoiaAnig4EHSg6FHSo6EjQkaLVs0SrZwWtCVpTtC5oXdGGoA1Fm4I2Fe0I2lG0K2hX0Z6gvbOmoFotzHxYSLbtA1MwG9v2TVMwBX+zsm2XAW3bP0bCIfyrSiaQb57rvHg2FHmUdDRLOp4lncySBrOk4SxpNEuqnpsh1WZJ9VlSY5bUnCV1ZkndWVJvltSfJR3Oko5mScfTpAJOefKMQxKTkqZl8tTUrjux51TXk9yxjFI6SumOKV2l9MaUnlL6Y0pfKYdjyqFSjsaUI6UcjynHSjkZU06UMhhTBkoZjilDpYzGlJFSqnZAqdpCqY0pNaXUx5S6UhpjSkMpzTGlqZTOmNJRSndM6SqlN6b0lNIfU/pKORxTDpVyNKYcKeV4TDm2zcTLO7Hl5eW1s/SCgW2UMlDKcEwZKmU0poyUUnUCStXRzhpTakqpjyl1pTTGlIZSmmNKUymdMaWjlO6Y0lVKb0zpKaU/pvSVcjimHCrlaEw5UsrxmHKslJMx5UQpgzFloJThmDJUymhMGSmlGh/3T1z7Z0ypKaU+ptSV0hhTGkppjilNpXTGlE5ctsfedXM92JHJYsGZZ2V25pklNWdJnVlSd5bUmyGt2Z0lL+8778Vla4wgHhvgc/fNBqpwsV3trFTcq9j6rlTcktlAm9ybZgPNde9gO7tScd9xojX0VyrmHVWbbPiHKxVzZ4xBMXVzjB2vVDj4BTtZqZirY2ywUqH4JNhwpcK9cmS7G8fRB9X72BV7G36MD+J3NxjHCFJ4R8AE+m1DIyytI8t9IMjVNzSm0jqy2ktIJSy0G26GC35EebFm9zY83rr03eciP1Q3xsbbu+X2zb0/s/lP//P/4Na15s3cW6/+83+6/cp1k/dj73h5HN1hvc6aje96znM50HuwauQkCpbu1Q1pAXcPckr1GRWzziDs0Wyd8zqmvniVjRdVOadj8otX2XxRlSkd01+8ys64yjjc4h6Oq0zqN/HFqsSH2R1XmTZxkw5bmdAPKFsJRP7uhh77xaltuYT/D1a37d6G2aBTcfwz7wgLfnhAQO58sGo+2avw5CCWMev2tyi/6YFEMKApwQ5sIcoGsqdYklhNMdkfH1uCzRHrKDZP7ENBMhMmKvjnUR6vOzzywP4FAqstmNyyq5jcsqqY3PLIEkxu2VRMbvlEkFNuGWfbHbEmklse2x6NgOSWHcXkliNLMLnloWJyy4ZicstHgpxyS+u0w2PqsSwTfyC/eCm6ZcD+Aoty3rcw9+BkW69aK7fb+lb3rj+Xw0/nr3sPb5jaX/G/j1QMH3h5v1rtfz/1NdiG/rl/9X//Q5sGVXn/+9+//pV4GaS/a7sb493j3bfa0xXQVuth4NZZrX70p6DH/GNmo/JXb5j/+E9/T7o2/slwarPpVrttrJu/9S/+2T+Mdf/m9fbN//XHf/dv/N2bg+812yi8+Td/8+137v+r/+t6+6Z5Y/hnT9b+zfea7Zt/9ne+fuZ3nH9zvdk08fZf573S3+LPt/7U9zzsjVAvxytc362mcZrPoS51nYxxMp4eBetwHp84/mJ44viL13Hs29/wY+7NMLF5GOXaPf96zO/PPfbyb4ji8Iy8P1GU6MYK4/a5GI10zyDWjmtx6bkJvW6p4l1FpFdZ4tx4ZPI2N2l5u+8f4svFy7yDmbzsL5iyv3AAW4U5zBXGg87tql+VTw5xtmBq4WZoH+amzEYuloYW18yZOC5ALBz8LntQ1KUZzmFjbCPilducTCRSRrgZbQOFbYexWuPuCQ4PDTbC9AfbwClAmjdL4SZrVGnEOcmtmTv+5ntsSnnbjoVWKS5yxiUQEwXhoNh8b2ymUjZzz0PLtu8EcLavDzH36R8HJkU4MundypfL7YerrmXDVTU1NobJltsPRNUd27bjJq/hKyNRMnEub7hjj3tlP27Kfvxg1Stz9x6HptyP45x9yuBgY2wmowEhNuCX1Yrs8ZPSNVi6Z+/KzyhPu4RE8zm8pGLAdXKLOH+1dIbhCmWS6MzQR8skop2SMAmY5rRpTJSHUtOUKmFVeUaKuIoYwMEM3lui8LWPcEw8K3jkLuDnibuIn7rlLuG3arln8Fuz3CyqSbuYe7rxilsOq9/3GwUdzjTFueMvmDs6nOdlOMc5nJvURqK1oWKj3Q4Midyz5ipV2PtirpJsu+lwoM+bpAz0VDBGWm0zJwM9bMqd7z4fx6j3yjCITMGjNRUd8ylT8uPvwL4JCfDmHnLVw3CO66BPTgz6eZOWQQ9NXLIp6YBKwaC/Mznok/ACNGPLqJY3N16DY2Uz/6mDfr75qe93DpKASQePJ4PeJORhENLWRkiD+OmDv6y5V18w+Et+HPUcrHql8eAvyeBPTA/++enBnzap6OBPSRdh8M/elYO/LB3UfE4pCThetolHBr/MVNBTxps0QItHXSZNPNo5kLzSweDfxyjtximkMwzJElS87bbJwpasjeifljnTbiNuaNM9B52nybThGm2ZxXbbLECr226b8yg+b25iPN/0U7cp0jdfRS5o5zk/TM8y59qhIYRKpa8iYMv5KXqePoHrjPGxL99ndsvk8T1ID+WhqA/Abpo+USdpubQn6EDRQ0FHih4JWqVUzMmmnjZ5kI7Tu05H4WF61+mnpTwrP+lgauLnDLnSqYAZ5wnZnzJ59CRKsn8EK6WubqX3vatYvqCDK3HLZPLmqpxFMl/EPnVsWnQVcYmEejRBzSr1eIK6rNSTCapR6mCCuqZUqNz2+bJB3SRV39k8TdLyOCl5I5aQOc9lfEHs1XBKINJCbykcvDRc9DuvRuZOSzdZh2faqu7iK17XwLFKPFLiMEo8VOIgSuwr8SRK7CnxOErsKvEoSjx5tUJTSDmaP3mV20Olih0VfKReBbGfrVDGW/cbr6HYy0Ovf5jEWM5TnUxdPJwbX8XzvEqnvY5uM6pfItpVtCZoT9G6oH1FG4IeKtoU9EjRjqDHinYFPQn2M4IOFO0LOlT0UNCRokeCVnV7dSxoTdETQeuKDgRtKDoUtKnoSNCOotXX5HkVrQnaU7QuaB8ol3UxktiLNV6TNzBE70VtoPl+Gq+h7HhVLO82tHcEbaa10UB126/tJqUeoQxJaUQoI1KaEUr11cpY1aDPQEo3Qunwqk46pHRJ6UYoPVJ6EUqflH6EckjKYYRyRMpRhDK8yC4raXuBhUZf6371JRYfaFMFu6u9Ldg9HVyC3dfeE+yRPpBgT/RhBPtQH0QwMfZa9/uC1hQ9FLSu6JGgDUWPBW0qeiJoR9GBoF1Fh4L2FB0J2le0+rJ8G4rWBD1StC7osaINQU8UbQo6ULQj6FDRrqAjRXuCinHXut8XtKbooaB1RY8EbSh6LGhT0RNBO4oOBO0qOhS0p+hI0L6i1WV5XkVrgh4pWhf0WNGGoCeKNgUdKNoRdKhoV9CRoj1BxZhr3e8LWlP0UNC6okeCNhQ9FrSp6ImgHUUHgnYVHQraU3QkaF/R6oo8r6LN1ypmI7ut1kqxbbv+qrkWmildDk2Uro+p8BzNwIwbgWrNhrtu3hbNYNE/EvtP1zJviVqw6B8qyTFbEnC96PeVFDe+xF2/JSHXd0VTdENcFW6LYUlRQq3T+M09CzTrJs1OxNg0AWJaw2/swNyfISTumh2IWvBcWmpTjGpCOEu2uQtFfFWoPCyTYlgpCZSKq7Ma3WMHexnI5HFzts1oERS6oAkB8334t0CFkkCwCEQS2kFS2D2z45cfZwuw7/u1lYq3KZ4WRXjwe3S7iI8NsZ5873m2bbmWPHhCXC6iDhjL4oBh3Dlx1Zg3m2OVB62LYCduHGjBMjAA36R9N/UJ80Keh/hPsqgZ5oQ8h9AoJC+TnBbyAkRkkrMkp4S8iB0GyWmSk0JeggRLcozkhJDP0I2fvUHTRNkX7srFDqGsWAc3+Yxi2YHHpBBN4po4zKG/qOJilNSb87/1/MnV+e9efxj/Ft4n7XRbfL+BhS52RobOLgct1J8wdIC522KAINrlfkLHrptGuXRFo6fMoxZjbGUpLDdfZEP3om1+xJQOTkNFDMjGP1hB3LUXXLGLckg7kIKKuVjzH6wsxsyO2du2+yn5XTA7a/YCfbM9Ovax/yUiGt/QGFwOQROCayG4GYKlECyH4EEI3g3BeyF4PwQfheCTEPwwBKtWCNcicD0CNyJwMwJ3InA3AvcicD8CH0bgowh8HIFPIvAgAg8j8CgCV+1I+yNwPQI3InAzAncicDcC9yJwPwIfKjy5bS36NQ9ObDKMIk52BYSOsR5762/QAPpKxdvMxX7x2yv0BK7+t2crbt4p45tcs+vfXvGH/yzxfsXv2hWTz15yc0p2N0wOF0BpQOOE+rdXMmbDd77GamJ7qNFsZot0M/7Fb6/gxAiGvbGKm/djbs7srtlHGQ/hAzao2aXLUt7kENLTK/nLFXfL5Ey+4p9YFW8fAeGuhkoHi4YjuybHbL97sHbjEH9q9jBJhvb62XLbxJ9/R7Fz5bbnhIcBIQhfLuyEtmbsYr8XiWgHXdzuhGqr6VqykjlmD9Zr0ogHn6cmLumWsZu0VLUqQS3D/9e1lFgPjKP2gpq+9TlrkipYYcKMLYiPJJJqKZzQNr4bFrUwhZcM7vXUOA9veRvm6q0P9mJZs2824DOSo7OaOkzlMSEfpnVCV/E5wI5DDBO7fzJROoiUml1YRUYKR9FLm9/BXRoZs4sAN9gq7yLqDE3CzC4izgitJzSzi0AzQjpUtmZk2Ii3UmD4bELw4erDvdjvWmaTS9Ou08CY1wfkdDt+QMWOQyz6gFo6iJSGD6iFo+ilze/sOs1vr5hdNZTEwq9mkVj81QgSAoBqICEE6C5IZIVq2p2Dmf/HKwxjM0h5NnpGjSd3YdHpOeiikDJKeXF0VVoDNnKN9uuowWZwPQhK8bFF3SZDchlHfLaTpNY+XhEPsSfy86H8VNWLrKa/df1t6O8j+bln1k1hL3YXPmj+oCZ+OYHZ+YO92H27jAde0LCHu4gEpT6PCLQj4uIuIvAEXVZdGHfZKDPusmEm6LJ1Z5ChBgVTVy2QODf942+vaB2b/pHSkwjooPQUeJSeRmO/Hci0m/6J0tH9Q6XPm01/pDDuVf2TK5pOaNOvKbyIzlYYwkpD4TPsjuafjLopDa+jYVJhy3OeMaAxfPfOGEBQbS0RKsGojxBc/xYIwR0wQwgRY+Yo40o0wXV63VttCU64DiEOou8zTB5pGp3ibTefyTS5S+Mmqy1Owh2CdBSmC7PIqnRuFnmVbs8is9IhWvqfrtKcZXMOk4dz1qe5AyMeNl0Htq5iW9VuMkirLQZY7aabQDRBmosASzJMwAbjKTbdFAIT0twEWJru3xsMw4jJVCet+duiNdLgza69EMvEuKYdfywrZudjeQ1wG+9+HL7a3sfhq+1/HL7aw4/Hr3bdaX684i7SGnPTP5KCFl290ZcLLTqBr5uEybToHo4en2/RcXwdivwWPMrxUuwWZEbY9i5iG5Exm7AebH68YjYZx4cAbiBRRKUVOOqKaetMQmC02iQFxtOYlMB4SpMee4KOqivY6mxSLtg1eWw3YxWVH7yN7A7HZFUGoHA2fzcRZQ14alGe+v+YmeZh+ylLcGf57RVsOBlvFL6EfgyxHHb8o1SFEYnKZndpPmbpP3hXbiOmU4lOONvmSqCO6aek4IB+OATv0g+H4D364RC8Tz8cgo92nYGCT3adoYIf7jqjlNmGNTtQUb1sY1oGWlO0Lmhd0YagDUWbgjYV7QjaUbQraFfRnqA9RfuC9hU9FPRQ0SNBjxQ9FvRY0RNBTxQdCDpQdCjoUNGRoCNFq3PyvLY+r6A1ReuC1hVtCNpQtCloU9GOoB1Fu4J2Fe0J2lO0L2hf0UNBDxU9EvRI0WNBjxU9EfRE0YGgA0WHgg4VHQkqqpcrzHtjmW2Mxo/5vucrYqC7bbZhEI+/Vf7tJLkBfGa2c7FaavULbwRpan0JOZQRdavgx9zy6zG/aj32Nt6ISTguiN2lSOzfTYQk80sVd1PCubl5Mri7r8f8buKxl3sjFvWGXR+rPeIv8ovF3tqjfl44m1PBMl/BXv15xrXxqf76ytjYK9DUwFIoUNHA3Gv0twINzrpf/Y2VsT1P7TdWxnZg9d8IZsx1v/EbwYyZM7hHU+qSNg3/3orKQut+Uxjbbaa3y3EWzwBrBtg8sEaAzQGrB1gaWC3AHGBVYOt+U9x+RZ5BKISTOOkdpUNpkmq3m1j6BlLUjRQl2zicG0pBL1KQYMEo7lvuvlM2+2YTxtzvS5zGichBO9MBmHamAzDtTAdg2pkOwLQzFYDJ3TcFLGwFlcb3cTAyFfgpP33f/PR989P3zU/fNz8d+Ck/HfgpPx34KT8V+MktZ2RCn82ysjsTVI4KoVnS8izJzJLWZkmbs6TSNGkmdByoObPLmEAHVP0DSePEkWSmgCdkIMsSWkMIR0LLCNxIqATxOMcbaEBxkjd3nEeQRHPRTx9o1apwyTyEl215leJKCSea4l8C8UmdUCiAiacKBTBxZ6EAJl4vFMDEMwlym2+5BaZjt/U246G6RiEJghfG3Fjuwogci107jOytUhdGM4UuR5AYJTcdjPN34mWTQzg0UwglLbhU5jDJbpocZJU1k4OYYpAKCdJoDsJJ1uQMIzrTDxiB/kZ/X7oh56cr0KHySOaZuD/n1p0yo3ITPKAYS/Au5VuC9xj3muB9RrAm+OgZ24Ewq5hMMdE3IjkCGL1BNLNFiYRTlEg4RVHEFiUSTlHmuuK6WAtgksbymELL81hG7Ur2y2YD603MbG/EmrYEEYoJLc3QP2lBskSygiwTWRbEEDGCrBFZE2STyKbZ8NZ1uWAgMktXr+gy5C6M1yrXwXqIwLZRm05mRojESQ52xd8LjRqaEafjaAyGVbMw6UcMWzaGI0pIOCJa7RrxEYUCG7E1XPqHpcVOOObadhlhMWsWut6WTZoz+UKUeiUaQkXDXyMmf4tjWGVCxvRJ0BrUTVBmJCUplCQ7j5SUUFLsW1LSQkmz60mZE8oc3wwp80KZz5grSOaQNVf4MHhlhLJ4X4SW8bIIGbwpQmvcqMkpwBWGq5J2izR/hZLsOJrc8Pq4d+VwoEXNut2SxerAXGHKlnXxCrfYOCswgjVXmLpFC+f5LPMojEvhSVg4x0ef04MDFA7CwjR7Kq2afxQOw8IUOzal+n8UjsLCJN9DMjwFELGBQacSEokqKXGpUhKlKi0xq+YkHs28RPitWuaK/S14k9NoN4wux2DgDM7dZHRyhgWXo4FxKA8MHShdqFrSUwbEMDeLOLsxSzgLOsOzoKbJtiXqkxWqOUwGt1jkLZZwizN6CzTDc1rGebBohRZUHKJjiyEoLLOBoVSsH8pd/MQi0uPphlPe+iq2hxFZj8Ia546FZkaC31/Bh/Ox5cfujL+Yo+sPv7EX+5gBWTYxG9DadwP5Clo6p4lN9712Syc3we+2WzrLCX7Qbul0J3i53dJ5T/BSu6UToOD3260MzvhEisZZFMOob5oiDqDacvhUZPd6CZmYLT2cWyacYpD+LOE0I/SnCc+1xW5+OxdrJiMTlWshApiN+w0SovV1EKP/BVK6a2UQNoz8wyi/TXtG+yE5UsoxeiFHUjmqyRdxJJSj9kKOeeWov5AjrhyNF3IUKdFKB8/r0lCEuWpbOjepC0nRpHR9KZpg2SnStZYGbBsQB7AdwXklNitZ7xWELa5jI24O3CuaJti9hJAdc4+9Tabb7mH+2Ibq5ommZpbQlnNt9Zlj3Kz5tjq0MfgV0nSo0xnDaS201S2Mds/4IMVji1Etl9rqTsUAlfKJxvzDfyThz5D3EhaVDOnbomj5zHPantVysxzsRhrSwNBTN7vg9iNYyamLmt702DZyv5qjswH1XLwHlVcHTItgt9yzHOpaez2ovR/WPgxqb45rPwpqr0Zqb0rtlEjLknSh5Z4TZzD3vDiguRfEA869KF537kvi6ee+LN6F7opovdxXxK3MXRVXNndZfOncV8V/z/2S+Ay6r4mfovtl0Y+5RhzUXFec4lxPvPLc18UT0H1DvA/dHxKtnPvD+P0Q6WVxcO0mjEWB00I0Phtx+VKwb8aaEUGey/GtbQLICiActU9kZ2JOhu+0vfhzF3JnXHI0xZ+7cSjCsnJanHqGTKpJcw5Wx2cxW2dlth4niTJyePAdGlxj99B8zq0GVqq2HNiPcFh9VnLKkDAE4Vyg+G7tOoM0D8WWK9v2ryVwGCCJD/vQFHfsCiNoYy+fe4OqNwTtx45+xxTX7LhbhKZx24bEX9y2v2lyZmfbfiLY+4I9MjmT27bvy88fxo/4/t4jOAD4kwRPAN5FbJxYJfuzdplBMjzGysARL2Rhz4EfyERn5iNB8dAXk7av+TBNHs0EEaSDArZkAsxLKI5NxumQTIBKSjOCBzMB0prMx6xkP/CK2G6YIlMBFqOpAItMpYciTQUIUNL+7YxTAeYQeJO0wmmpAK3JVIB58jvve/umME7Ol8OW432vbHZOSQWIZ5TnxoVMTZij3YjzvrcTqaJo9idTAeZlI0P+gplkLU+mApStFYcDtHccJtkHco5kePachtoDB73pthg22OZHMJf8MOaRH5I55A3MH69z7vAwb7jhnNGzWhiZ1TlohXnIncaAN6jiy6jiNaniS6jiVVaxjCpWwyr6UkVtXMUxq3gFVaygipelipdQxUVWcQFVnA+rOJQq6nPyZDVbLDP4pR1Z3PG0+HiwLsCi0MZgqaeFvW7LN3lMTnh8kClNpoYyNZTphEzZgClLpqYyNZVpQKblgGmZTB1l6ijTkEwmYDJk6ipTV5lGZFoLmNbI1FOmnjJVbW4hAqZNMvXTclbe09nBXMr+pxbnD6yTV7btNJJBJB97xfFswQP4NH3gGLaCQZS4/+USIxviDVE1LwsI3bAREMrcNQGhfd0UML1LxcQGFeVlgR5hp5CTxXCXmokNUSvfExB64PsCQnH7SMDsLlUXkPt2qbfYoLK8auk9LR5j5GR55+lGTpZ2HnrkZGGntzzhZbrJEzygfzzBD+kYL7e26BKfkwWHzvA5WYToBp+ThYkO8IQNPd8J3qXLu9zeorO73N6im3tOlj46uEt/SkJC6VCbTu2E1+jNTvAe3djl/hYd2OX+Fl3Xc7II02ld+tWmu7p0rE1H9aKfQrrc4o3/pFqtntBkvWiK/v/gVPwnH8DKIk78daK723bMT8rA8XYws2T/rHV6FXqlXiG8fw689aRMPIjxunvjz//Vv/Crf+NX/27t2g6Pb69s2x0bhiAYeNv2L+OEKy3mG/uQ6uwgEFvBzzKjrzSljIVsz5SxrG1Bxekn33d3zJ7Zx7GdCze0ooPQFUWdF82W4WTPlDaUbtqyiGwwFxz0MBxbmGCor+LQaIvFKd9quylGonwhbTHr5IfRZlbBLFcOr+gnRekJZF+RAlydlz2+FxiV0Ahlw99838tV+GBe0eREezteJiN2EKttDSiT89Pf8HYqkb1DuAfb8K3bq20+bxCABRdkKy++wD7tguVPucA57QLzKRfET7tgrYLHPv2CBC7ImeL4AjH9CfrRP7JlLMX2Yn8R85m9bTfCnamL3sWBxts6TPIcTeOJLK8TUVqgLN5aXueAZYEMprG8fnRrAm1iEsvr1FUSqLwrL5GTxoFAdzGH5fUrvSfQfcxgeZ3sHgn0BBNYXmeZDwXC9FC1BK7JDJYPpti6wpgkGwpjlmsqjAmqozCmlq7CmBR6CvdlEssHM+yhwpghjxTG5HasMKalE4UxoQwUHso0lg+m55HCmF2rtrZfprF8MKXVbd0jWOIc00QZnsV2yvwq4b1jilD76hEFDVHtx4hKzSCKcfjSJkzxsZfznQ/cMuyhEHj6a1TpfusDdw+nWDy738E41e/8KT/ZtPxk5Wf5KXTCG34cNkgFP44IzXuMNUCLsXK8HK2GlZCfNktyYG/K5DfFW+MtP8zFFhxYHu3zGhcTn3V70aYcOibCqNjShyjMPESZnHyWHWrE9zhJRJ9lU37uP9VZ6qnYZPFhdvAwO0HjCjgpYH07eDDWtyP1yUNZUw9VkOtsI5FqH1BMt7jcWMhAOzG95fHlITAJvsTfwy/2HT78guyK+xY+Q5P3h3bFu8mdh2+5V/nBFL0NztCX8WaRr8ZPvO3dgSLVx4z0zQrWEaqrFLc/QnzD0lPPYpzDp5790LvOqQUu17a5DvKTp6J+NNdXPeshol5f53QFFkdYOhbUFuAqRHls8sSF54Rhve1pHos8CeFp2E+1loerGRRXvBKCUl1fpK49+b67JR1bxEOUfOebjA65MX4dMvc736y4eL3WB+4tjF2Ad+hY+Cc+cG/oG9vjWYi3VfGuiWHPNbNlymHM1C05HQab9Y3Pw1nw7YpbMDnfxhu/IW/8FpqmtyqIPZ+LsVdABUHesIKGv5QnpB9j8rH/J95ZhLtYGh9RHt6b71fkAbe45hYwmBOmpCP+th9zr/FhS779ODLwMWXf0Od1vunlNPyaZfZNDo0I4rneCp6XC+G+FLiWuWX2wRZEENkP2bKfj235G7M3zY2lX+26OLruBj6yG6YoXXf71mJsot03pIobL6jCQhXX8CFdM7elistyxWX2H0yOJntcFsCiWzDXffuAd8ubgtmiUOOV5WLS/OT7piTkPa1iL7yvVzClA94wr4LQLXlJGJ3yJcZnRiZH8mPv2iJMYQtwbL0sp2ZwccVALanxAAbrW7obRVNKnGR0UI3d7N7iOPXKylYO2cpRtslBWpJu2op/jjtkaCBKl442/Nbxfb/t3UYMOEs6/gP3Boj40q7hAbZg+aBzbWE81wZ3YmAtkfs24SOZ5mGOtq+M9pXNlr5GicJ6gxb/YauCmlgPrF1bgQ1s/F1ZHPRCSwoyfsJsPHYva+ukydfx3fAc/xqGWaHi3jAFc0uaF3na20zoI88qD8knK+mT7UWfLCdPtqd6lE95susSHbd0+jNhTbtBTxhj0U1UR/dlDd9jl6MWwF4pgj3wtr7hFeD8vAjvUhuzqC9BiPOS7yMvp5wwBXAZ0gm55NVd3vctOlSH/yFEbyRHRzTbkSQXcyawxAQWn8BgJzBNOJgm3J0m3AvvjsXAxyOlF8YQWD6cviZyjKKUmjVdjbNtLyyMIXpiz1zVm77qxp+uVqtHsR0768fcq/hifT+OXVuealp0YGLbvhDpsp9lqESwYrVesDK6QMff9cqLnEXuYLYXt2D7uQ5j2C6SliYtLeuu0rKkZWWdVdoyacuyrirNkGbwkFfNnQ8gDlw15Q/YCt4vYsf0dTf6nvH4IgywDZ/B5yhf9jP4bOVb/gw+S/lMlAv7vbc/8K1fMFch0xV86xfcvcgw3VlyYpYdh7y54ztuzmwt2gsOOl3QEmMIUBotLcZ8m9JTzmzRyf8mFLIxk3N34OB/1RRW3atmz7z9DfdtQ+EMBg15HN9CKjNXfeuDW9v2SLbY9TSCEIS77RhBRtjdthtzr8f8bLDd1h2/7KLAWTCbb9qxHTuOlfAbXg5hKWhpcFbsDs6JFcJ5sUm4IBYKF3kI574kZgsv46fkruCn7L6CnwN3FT933WX83HNfxc9990v4eeS+hp8n7pfx86Fr8FO1XBe/Ncv18Fu33NfpfmK5bzDRFk4EinoiUOSJwo/gt2e5a/jtW+6b+D203B/F7xE+hSJPEhz8nlhyEjmw5ARyaMnJ48iSE8eq7S7x/ra4/NVtnOqwBbbJIegDFeA2U000qQBP40ygSH1fjunUoGMoUrWXY4AKlvZs0Zln2izsE13DQVSRkQaxBuEgCrqGNcahssWljxnleeY83zZLUJGaM9CQZo1yw0bjh8H9I+BeE+43wf2j5OapkBNww7zjy+A24HaF2wP36+SmDviHAm48+wq4XwH3qnAvg/tVclPd+1rADaOSs+DmYcZ54b4A7ovkpmb3ZeGWdTLPYcaQIBsqtwQ5b4vGlhgv6PSiSs8YifYMczrKnPaKIgBsyHoyzZyNMi/giECZl09hXo4yZ72iH1dmcwqziTJf8Ip+QpnXTmFeGzNvyFEfjJsk4JnVbskZ+4YcNFpiBYVdK87Cmy3JN8/SZSld1tIDnCEhU1i72WzhrHtZ2IywGWW7224KXxVxugDACr7Zwom4kSvW5Io1veJecEUtuKKHoF4ABvSWacEMY41pn3Zon/E81PukAgO3LA5lUmKKxGpLnhXhsyb4zkgX8K5PPoUvK53BRnWsT2GMS3ew0SefxuhILywxc5r9KYyWPLIj3WD0xRm22tFulQ75pLfkvaEF2eAlCVM1YKpZwWvDA53h6xaTEL7aZvDyhPte8MbSDKXE8ZPUl5MNXlcwMEw7eJ94V3gDO2v2r9heTgcpojePBUfR78uGcGfN7oEtHPjWDLeJcv81cIff1Cz3cpS7C+7wc53lzka5f9n2diIzgXDzUE1TlKcl2Z98gjFvRzhjp3DGxpxQ0L4REwdinLyu2Y05qhSDk1i4aPLTTAeHtfBeICUbnOfCXZMxyJaDUzI4bUpUsuDQC66bpKzJGdauuQRDa1mnr2zbXazil5Ddcds+jKzoPYEHgP8aVKC512P+MPbYgx7fVLbtZV3Od9fstLsDr8gFKqGL0pNQ1nOHcCXUjV/R2SbdFjPAQDdOM0BRjdMIkJpxMQHc0NHD9x11x/sxMe3ZxQy5Ib5wa/Yy70bQ8FU2JTF8UatK815p0eBx7fgxsRtCS1iWFbUeVyGWldgwaaPo+rie/ZgpivkdG8tiw2LDpvLSA7aeZWssW+Myy7K71AGzbFP2gk36sMMR4I0go/qm/S1AtZ/xrtBjp/yYhvF1tUrZpqSSxm/fcudo6GO58/ht2m4Gv0e2u0DjHcddxO8jd4lWNggVtk2BJSs2U+5ZegDY7jn8HtvueVr0OO4F/D5xL7JWy32JtcIiY5tyywp+u7b7Cn5PbHeVrXLcZfx+6L7KWi33S6wVBhnbFHO+jN+e7RpaM9muy1Y5rsdqIX5tU8x6g9VC/NqmWPTDfFjb/RE+rO2usVmO+yZ+77s/Cr+cuQpvYqmZYJu3UgMdm9hADXSQKpY3VgOdOEsP1UAn1WbhSA10EizsqIFOUgYljg3gUPI6DO7egBTyQ0xAa34Yxho/ApsPs4bZ9E0TXmFeBfeXwP2acH8Z3IbcLri9gJuf+UWwvwT2l4V9BeyvkH0V7MsBO+eJJbDDXc5khf0s2M+R/TzYLwTsnGh+1DDJLvPrkn2eUTfJvgD2xYD9JG1/iwnkLY5GnPlv44umCwxsNeneIja5MfGTQeaKK+IA3qYDHsqy4iWDsGH0gOF78OJtRH+DLTYgGj7SeibJdLkSY6zZ9ObETYaBEbx0y1uEKWfzubjHeJlnbY9xLTIwx5trt8ROc9MkIBDCiaKFJR7H1+Jf4y2IC2hCsvEmweaQjWknwLcgnqBJyd671NRz9AWa8yFKBMjIuNFBOIU0DShNuklfmuxfthiVYa4dGnQ01Ssz0n1Vu+XZ4nfkWc/EfDPoxJElyX7E0ifovhqvsCV6h7goMazE86gVSeK5F29LeNtN9iIEBT47OhkWinzApD6Rw0ew2B1hNc8zdP6EQ9a81IQTHZzvH6lnzwYsaG2RMSUzHkNcND0bAfyKGvui6XHPs+wl2h7m3hLFtmTbm2OKZQ/ugYZyjd32MoxDaTW9hbaXaOFYDBEt53VzkGEyzk1KIFgeJ8IKIgunR9fKtmc36eMdKcW+BMmHULA2WeCAdoAN/bbN2PTbOLfMbdsMXZ/btiWovY8V8ddC8FcEPILNUjcC/7LADcTok5D5fg/wXxK4C7jJBFFWJfuzYmimXp2uo/ZqjBd6nw66MDSWw3qe+7W4/I1taU++BzsviXeYY/RQRL2Li5RkG4eoNeF7EBfbC0t0yYmxxzgPHXmiKEeFn8h77ag1Eow8jtTsZxSruDnfcvMwaWc6Nu4l4OTbSeuAiLfhOpwWEcjjog8fc0QCXDK2mDXK586wmhwuRDmONP7Jcy+FB2y2KXF6Z/m9Esl652jmiS/h1Za3bJYZixOqlCWxlYODB6/mFpHXncWQg80crnqp5Z035yNXpeWqdHBVcLdzsOkLrnq55V0wF/gRUm3DTbcJ9ukQgr2MxNPE+LbNvJlrSWzKMFl5TnKtWm3Zw4uJIEItMjUWazEe5hlHnnXNW+R8g/uvtLyL5iKnBtx/nnGLeczEqzELkdUsMP24I61+hRe0vDPmjFyVkqtStEzWmIpJXj1HIq86g9iYc5yCpYcgM8EAPUdLBW/1qRdEqh1+9NCE8INv3CI/urMoNkvozKJYJuFtFGl/1GyiNjREbO3YjJxw4TlyAVfTSzwdm/3hXvGpe70Ku/aXELPoZXNO1soM1soFLImiA0h/eg0b8BZ+gr0dztY3zCoO2zfMskw4cziE38BUeddsmIsyYZQfmwuyvzy/6+D4Ig/D+Ly3sRc7fKSnIFf8+iBWcTfEaP6KP/hfYhWzm/WE6VSW5m/GAjOD2j2UHscq5orf+c1YELntit8QWjdKawqtF6V1hNaP0rpCO4zSekI7itKqxzENTHDFP/5NfPJcO39mvER92AK4DC+L345VQqkLTp0DpcjaBR+OoVKw6oehX9rhYshw0dvcA9AmvIQleZsKhOkLZC0MLljjBSKX6zX3eM2X/6N//uO9/+r1PoaQCw/Gol02B7NOcAez/nkHs/55B7P+eQez/nkHs/55B7P+eRuzjdiYbcTGbCM2ZhuxMduIjdlGbMw2Ij7jC5iTuEqYlsQap0hXWqcpi0jRiGMOfEJs5txuqW5N/FFp+XRAs1GxL4QfGnsXm0KJjCXUJ+xg+sBxgWiprdSH7GX6IjKZiXBXLfa0GA7zULMlJ2k1FqyJyTDPXOWCOulwf4NzUFlv0GzhSezgSeBRhSehJy2exJEnOVCtxC5bLrv3A1r44NT9QBNMF9gkOfs9oIVPzHBwbUotXOpeEA7XarUQ/13sjJvPv6jD9djphGaHYsiDx4m3mroSwS46B/MYkQPi2LvSN1F25GIJacmeXGwhLdmVizmkGqyJRaRarKlRpJqsqVmkJUZrMCuCmQbmr+JpM5stM1vvt3R6wbyGaSnA64IfBnhD8KMAbwp+HOAdwU8CvCv4IMB79+SGo9/mtIZWIJ2kuWQuIX+rKD6yK94um7q7CKGmlmJuUksc1LmxRAcQesSnJ/iEj07wQ5pTbcrelW9hU7agfDObslGnOdWm7L5pTrUpW2qaU23KPpnmVJuy96U51aZsXmlOtSkbfZpTbcruneZUm7IlpznVpuyzaU61KXtnmlNtyraX5lSboiigOZV6TNGcStpv0yxU2m/TUEfab9MuVNpv0y5U2m/TLlTaL3ah0n6xC5X220xdJO23mbRI2m8zQ5G032ZuImm/zaxE0n6b+Yik/TYzEUn7beYgkvbbzD4k7XeYd0ja7zDjkLTfYa4hab/DLEPSfof5haT9DjMLbZpLHDuHCqaZS4hglkmECC4zexBBw7RBBNeYL4jgJhMFESwxQxDBMlMDETxgTiCCd5kMiOA9ZgEieJ/pfwg+2kWgbIJPdp2egh/uOn0FMe4OFca4O1IY4+5YYYy7E4Ux7gYKY9wNFaYVscIYd9WEwBh3NYUx7uoKY9w1FMa4ayqMcddRGOOuqzDGXU9hjLu+whh3hwrTBlphjLtjhTHuThTGuBsojHE3VBjjbqQwxl01qe3HeFEY466uMMZdQ2GMu6bCGHcdhTHuugpj3PUUxrjrK4xxd6gwxt2Rwhh3xwpj3J0ojHE3UBjjbqgw4piOFEYQ02rKXFmzX/Wt2wxad8Wv0SuH+gt/+L8BRqiloyR2hzQzoXEqXHO4ytI7R1bvlqxHOXXxouydlg1yTlZ6uBtx2wVqVsUAOhRRem+2ZAOZo+IVfyDIN1uyy6RDDZw8KNPL/jonVi7wl+CeAdTNjOheEJO1lhIYAVnrCh85TN0o+hmH6RwJnzhM8Uh44DBPNRQmcZd6p0bcjVPlFBcH505cnKG7cXHJRtCOA/Fhh8QYF2fstJvh2u4uiKP2Itd3d0m8t89wjXez4tJ9luu8e078vM9zrXcv6LPAEx16rjgX/hY1ModxL/CYYACeTQYPvUBHivOgnQgtYc6Rdha0Y6GljDiBnAHtSGhxs0TaImiHQnPMAmkZ0PpCw06T7meg9VI6VtlLtXtNBgCSIcsOq4M0QtgvBAK6xBxm6M97qt2sCbUuvRtQ60JtkNoJqA2hNkntBtSmUDuk9oR6xe9DINv1crnYr1ouzgpie7FfhSixPhXVY306qsf6dFSP9emoHuvTUT3Wp6N6rE9F9fCKe7G+Bakl/pGM2gPxETsUNcqhCDkM2dxGpFh4V0AN4sFjtyiJX/h9+ccTxKQQTyaIKSEOJohpIQ4niHNCHE0QF4VYs6PEJSHWJ4hnhNiYIGaF2JwgnhViZ4IocjBCZUWIVBjhjIthtN15kcsltXXXQtwbaLJeEulb0mDfc1+W0B2SDvu+uyJBPSQt9iP3FQn34XLj8MRdlYgBy/KlvSof6pfkC31NPs0vyzdpdLwwEEZLHAOt57IhgKYDqtuFh6vBCzPGrLaM9dxQeQol0NmHq3h0er982bzCwgvQ7GRN1lx4wHNeesm8ZlZYeB7KojPmjDn/gIfF9Kb5knmZheda3jk42ZtzD1bxQuh24zyjNtIxcTkN5lB61bzEKzItLyPRu6GXMZkHPAemA86yuUiW+ZbolbrMaWXmH/AEmH4588+8ebNo5s3iw1WMCrr/ZJ55GQQIYGVz6h9kP/NsRo1LP1zFSKMD0QUQEeIkJQfkdDA6DyKcUZMPVzF66YB0DkSo5pEpJQFpNCNfCUIZYVNB1yCqs+LUzfYVh2Yv2aQoqJvKpEk1KQ7KOuKlmAHpWPE1L81EMSeKb3pzxmpSjMshhF+T0l3OpMzZJoW+nEkanNbVACaohq86VIFCUT+yue1ZaFKgzJk5s9iknCnDRtzDJJzFPYGysiWScBaPBDKyGZJwFh8KtImNgB9L+FbGu8TNw6XFGA5HHvFs5CQtDuTduDjM5riN8GxtKHYSeNF1RZ5gYDQUqVvo4qZiDQtvoaNY08KL6irWt/Aue4odWnjdfcWOLOj3DxUbWgh1caTYyMIXcaxY1cbYOQnuYGPkDhTr2BjkQ8W6Nr6HUXAHG59ONS7Yse2do2ybE7HdO0/xVu7geBco4eZELPcuUsiVp3W8lyjnIiTKIxjpMc7Iyc9D8TSIVcxLGmjjd2MV6NsYkQPwBQ3dAfi8xvgAfE6DgQA+K/AR4KzAh4DP6BoEWAN59ABrxI8u4AVVnAHWMCFNwPOqeAM8J3AdcFrgGuCUKs4AJ7X9vxPTWIVX/CFgjUsyAOyIO63hGdDJz7foVMosnycIILmDZ/udmMQ3hj0BXLuwpiBPQ82piGsTjLDFuViSdRYpCH4Oxh2fVnkXea4uUVoe/f/1LYh+qmguMRhWTDzLdoBqOKxLjGxlRKaUU2VXnHVdR9amuKxN0YBAm25KUkW4ackC4c5JggdZPju2LJt9nNYz44K7KMkU3CXJKeGeEdnDzUomCPesLAmyvh7asrCe2LKijmxZjoeWrMM1Wxbgpi0rb8+WJfcI5/XM4eAuS3oGHNi/6aTdh/iJuT+HLvvHsQowdscVfwj0IWHzczvO4KfRw/8kVjE5Rgdj5wPdYT/xvQAtjtEGmTEag/QrV/wjqGcs8xLE1pehuV2BGjBuXsHB7Gq7aZJmGUetrwZn6Ff8Q7nkDC6hmdpZueQcLjnPSy7gkovhJX1ckmbuR5y+zMtxN06KedDd5Em3WZJTGBV94gjYKQGblnUH1vnHsYrGRAPaDNBNoo0AXSNaD1Aju7cAXSZaDdAs0dE/UlS2d72g9IBoP0DvEj0M0HtEjwL0PtHjAH1E9CRAnxDtBmhZzqLT0HgNNS6bHOvtmAN3W/xmL6kDJPxnt3DuG3vsld+ImStezj/+nVhFzOtz/vFJrOKWaI6cy8XS1CT7R/EKnW5PYnQGhx+BXebJgWdPqZ23ZxXf27OK7+1Zxff2rOJ7e1bxvT2r+BYLkVliepaUnSUtz5LMLGltljTdjEs8J50lpmdJ2VnS8izJzJLWZkmnNKPkJaaJp0YLhPpqlnR3lnRvlnR/lvRokuSn4M61ZleTvvWOGMN3rWfuHICO5c0/czPOR0x6BtO6AvYMC6YAM/AUfhB1a5/GTWn8HtHa2uQRaKQYpEQdXcd3VMS6cGCKp7gN5/3k7VVGGzq1MIHCtRcUxlFoXlDooHD5BYU2CrMvKLRQmB4XRt2586tivRznIarTakscqSTz885DyGdCROSlTDXD03zGLHNM6qG3t8poS+lnsJ1Iw0gibRKt8Z1+qelBeZEye6uS4FRT3tqyGykzcJUElAuvaXlxHn0jP64ETVmF2UfJFOERsGj5SbNl9lbdrSA9d+p2/COzlTCX+GbHfoPImFzQKOQFs61Bq/fwvhOItegW4Eh6EmMkZVPwv2994G0vpWI2/sXsjNlGeJpc7BFGWzmyuR/8NA+JkPQjx4Ut8OC/5znYdStFTqTuU1MG36cc1zDy4sJmgOCazj+JjYPMZ5W7G+XuRbn7Ee5l5T6Mch9FuY8j3Ea5T6Lcgyj3MMK9ptyjKHf1tyPctd8OuTeVu/7bEe5GlLsZ4S6ZMg7AcUEnekE3ekEvckFMq+9HuQ+j3EcR7gM/abbtj0QzYOlCsv1GzJQp3iIWQV4GRBHmOvr5w0RVXC/jpggRbk/i/BYh3W1JnN8izhyvavImOI+Mo1zm/G6y4l2WkL6XRU24LqHP6ZayKGLfkoh9Z0TsG6sJKfadE7HvPOd2EcW52FwIP482p3ixS7w4Rc6KgeJLEXKzycleLBVfnuI3YrK4HOXnrC+2iytT7JtixPjKRPVNEzbuL3ExaJuLUUpwsP7SJNsBmvbyJO1u2yxPUmDLvzJJut82r0xSHvFwFjan5qrKVNtmS8WpbbOnktS22VchatsUVH7aNnkVnYoqwOJA9MBsj2f870PeMdsivG6bCzAoewbzl0VYhzBmmcQrM3FIlAlIlAi7BSnyPBrWbpl0iyM+r5ORDLx9GXM6V23JSLuqgwwDBWG3P8Lys200IJhaAAVBvBiqMRrssQnVRMlsZx+7RcT/ZrKxorfuJ29nVt2iWecEN44Vn8MBgLvtx6h0qJ8PlA47DLmHY59zgnWS0EGMFEOwvV1noFg3CS1E9bxgzSS0EEMt6yWhhaidh60XvYV3zCVad69PB3/+t6GudfPmElaIS2L7rTJkXlxw1xcs+LVdYmQWNKskzTqyp+s8nqGczFAGM5ThDGU0Q6k6E80tTDd3XSIn7CCx5pT0A7eQU2iDU2jDU2ijU2jV5CytNk2blnqdKXy6XvszbEZOuWf/FNrhKbSjU2jHp9BOTqENTqENT6GNTqFVU6f00ym0+im0xim05im0zjQt5zfOVJD4wa5kf5+3nov1HYzjOMcxFt2FCr3fsdGqO4+9vTdiZs9fxgZtJGkJ9zDiao6kLtkLBcQgrhh+6o632va+BBlkmiMrHAfmSwI0nLb32q6zPMW23G4xeUme7t55v/S+Wa9g/dlD4Mx84KvdYpJxSm8O9Ud7hkqRptP2Xt6N+LDyK4cJ9Wm1mhfXGo/W2nHa0DKuTdS69qJa115cayJaa9fhkc7mRK2bL6p188W1JqO19hyeHJXMHkwIDyIxXaKvhG9iNXgT3vm298quc/e0fscNzV5FF+Hgri7CYlgVb8u3p7t/ede5h4EUTT52Ss9/Vr3O9Au4sOvc/8x61z6z3vj0K1jcdR59Zr2bn1lvYvolpKC+34N2MuIFP/MWakgF3pK+85ba3oraMm359gv7DN50n/Ei0GEXYRI0/WT2C3vs9Fqd6e46A+Oiz6x189NrjU93VppmSnvQxx5+Sm8dIlF7Sx7Qm2tDhX8kveV8ynN1rc/qLjwYjGxmHsz5lAc7tVpn+snmecC1B21xzf6UcUAnEWmLl+HBaN3mk8U/pQmDFz/ZOvWzCVOQhnhJE2+HafgggB3ZpgDl86YpiPNNFgLpS5A8l8zLEWZYLzt8QQWx87YkJOwCNJrnJhi9V/m4rHfZFMyr2DIWxOAbTtzmJahHl8zybPVdqT6FmhdR84WZmgda811TwJ6/Lc7hF9HiFShwz5vXJutlxU/koqwpjE3EEQMcxgttLyFeRwvR63BRQztnjbdKiRm3uYjWr0ApfN68csqtPpSLDkwBYe/bIuJfQPuW0b5XzGtwLP/S1JW8tCSXpnlpSkKnmwu43zLu9wqU0qtmdfrSXcqfcVEmL8C4/Rxs0F+Gj9dr8Pb6koj8U5c1xYQ0IYb4ixNPL+Z3fHf3TAHnMffRdSYVHT9iT8fSR+yitIR4NxfNRXTRCrro/NRtacWI0UBXhzMYDRcxGlamRoNN40RWXpNRkcaoOINRcXFyVNg8aSZr3eITpfFEZ6afqKONbVh8lvTUs5xocVPaN4/20aL/pTbD10+0j+aSBYZbN2fBNmdemmnVSFozj9ZkJ1oT5zE6b3corZmfas0AxXFaXxboBGIy5ux0HT2bbbDQhrNtxuaPtoGmB7zJsdzEit7E4sk0b1KzWZyYasPI5r0TbUbyj9TMU3YGdKrLlclIKY/B5dFsswfXnDdiEDJVwtxijCXL3WOgqS2JfeTlpzdz/04y6rh7k6l99m4x5FABia7+XnC6sO0PfiNWcfexmUKgMCqHY+8hdhVQU/BPYu9XvEtr9j0v78cOGAVsYFXkec2l7Pt6cGbpwZujB2MJPViz9WAurgdnST14Sy2IrQOryY+7CVIFjSjQRdgbDxXJYkiMFFn2bLU8ydNbS01C8sxTrcYjeQYTxkSXodLFTdNO1J2jbsWdl12jm5Gdorsgu0N3UXaE7pLsAt0zsvNzs7LbwwEhjuQa9g5sHQnX7R3YQBKu2TuwjSRctXdgM0l4ZO3AlpLw0NqBjSXhgbUD28sc9Bi9JC0wUqKsCPJM2BI7JNFWnYYmNKXpZA7ntZ0kLTBScMhJYoqM0yFHNC8JaF6Mg4/Y4lFe06PdR5J2HwAbSQRR808SlexjmAkEAcgwEr7KsFcZeVXbbzr3teHbbzr3tN3DBBLWDGIVv+Zk/4LlXoI6FC6Y/tBR2ivQgy7wsLOaktPe7TedUXLHqS7Ind3rZoe7s71IeNDXY37/7GPvMg+3EDd2yxTMHrUj/04+KHfL7KEv9sbqhjwjm102EvVtuCQgRLszAmZ3nRMFl3edRlZAs+scKbi269TOCgg7Zq2htOt09bLyrjNQ8GDXaepld3edYwXv7Tp1reH+rlNV3ke7Tk9BpCJU8MNdp6OXwY75RGHYMTe0Dtgx15Qddsx9hWHHPFIYdsxdvRZ2zAOFYcfc1Hpgx1xXfoYsVRh2zFXlhx1zT2HYMQ8Vhh1zR+uBHXNDr4Ud85HCsGOuBe2HfbDCsGMeKUz7ea0HdszNoP1YIxSGHXM9aD9mcYVhx1zVa2HH3DtrLvvDpYpbMpf9/lLF/RpGJ2Z1zKfvu3nOjclvSgxHOhtGc0Db+h3t+SlEnUIc2r0gyLt4HVtBDDdvK+TZOpXH+Rw88c/Bk/gcPMnP4smYrwWR7L/jOc+MY66FWWZjGpkF50XOZPbxa+SDOCqR56KOxYmnqPs78Oy+ptEBgw70/dQd7+4tbY8vIRO3jEV18DgC4Wybp3mcz8ET/xw8ic/Bk/wsHoQpib/LcnLfQFZzhHK8Q0qi4r0VUN4mJY4IkEp5hxSn4t0MKO+SYle82wHlvUhvuV8xBeyw7G+xc8E7Phd837uqrUPLouKTucs0QV+RK65qXTymQMBZc5sP+Ip5L2C4PcVwUxneDRhuTjHcUoZ3AoZbUwxvKcPbAcNbUww3lOFOwHAjygD3+i12udFh1ZJx5Qfv5mpkPD3zLD5sm1dw93A75LsdvsP3Jpluhkw3Q6Z3J5luhUy3QqZ3JpneCpneCpnenmS6ETLdCJnuTDAhpFxCwkHuiepM4i0jMKUMhdNOwb0tU7i9ypkrbwpfXWRwyA+YS4UToWy+MWbCWcFc9k/sSZVdBpfdZujT4MLINTguLMnu/jJ293a7heOdJ+OKbEyZEQXgnpcPYh0jAKqXF84KK++jcrA+F+NpRLN0r6Ghj928HgY1Xdts+bF3JCI5pWHRJl4PJyD7O5GYUIEK4+gjOYJvJs11c33dSUdDGlyXmzJG1At8CNueeLpc9xsOlMxHomS+7HeXKjdosnXZ74RgMwQbIVgfg0yGvvTJb8TOorfkJ7gmST/vQVOqC5K57NeW9M1Mf9zUp6Tel7OeyCIltRTChUor2Yt8VLzWrnilyUtKU5eUpi9xvvgl8S9+SeKLX5L8gpdkTp9Txl047rBgUpnp1cjXrOP9tEs/4zrnB7wu/gNel/gBr0v+INcxJuZjd8/k+aHCUqC2RLc0wvUluqVJgO8luqURbi7RLU0CiC/RLY1wd4luaYR7S9zw2BMJji77gwxdU4NPtJ+pcKYZZSpqXnnZP8xUvD1z2a8uhLSjDJ7lMjY3Y9pxBruny9jWjmknGUbZ9RsLFa80ptYzFc/HhBDhbGQgDVz2exFaM1Px7qBVEVonU/HeRqsWKt7VMbWbqXjvoF0LFe+tgGouv+kMMztOLyNwZ2HHqWXwJJmK9y5av1jxbo3rGM1XvPdQuljxbo6pw/mK9xWULlS822PqYL7i3UVp9FnnK97XUBbtp/mK9+N4gsWK9xNhj85XvN+HZ12seD85pvbnK97vx7MsVryfGlN78xXvD+C5FyvevfB55yveH0QPLVaiT3uysOMczwvcWNxxOvPgma94fwhPsFjxfjrs7/mK94fxBIsV72fCNzNf8f4InmGx4v3RMbU2X/Hu4wkXK97Xx9TqfMX7Wbz3xYr3INqKo8UdZzQnIaP7GL4ZU+LQpHn2VYawJ3ibA5kG3PcAHhF8wGFPE29Wcbi06zQXzFuAB7zuJgc9mX8K4DHBr/MTCa87Wtp1jhfMLd6aHD/JWxP8o7x1yHyMT2XR/ARvQo6f4U1CjhMcYCyan2Z1IXmAb28J3ZCquDfli2KsfCQSuIow9LfNLXM1iNM9hE9SieHVHPzWoR8qwYMpgZ9NN4mfmJdyLXPVLTllcxMx7N83Iq5yTkZM7beY48VuI652H8FYANSpvX8LoRIS/N2ENsUS8+OmZjW9aUoq1UmknhIWwpKfhDvoVcBXISfYCXNrvAAwdyyjh1+nwYfF2D/sNrjeHKfMZUO0Ds+bejpAD4EejtEq/HCqcwHaA9obo0OgwzkViNifWYNNqJrh3DWX1VznnrmsJjz3sW1Vo+TL5praI182PqEa4tXfIFgHeIdgA+DbBJsA3yHYsSYljPIk+qGM7F4GptMEaxlmVr1svsbr+wDvEjwE+BWCRwDfI3gM8F2CJwD/IMERwD9AsGqby+b3S8MB/j5pOMAfl4bbk23qTjV5YEnLjud3oGOXKW9+B+Nkgq+JKv+QtA/gH5ZWA/wj8iwA7xPsAfxZgl1bqhzN7UDlPlHlsY2ZKlHBd+6XH2f/gG+5PsUzRHDKB0JdDYt3gFSxMQ2QkV3xCgGCfBzXAgRhwEoRUfDEjgzDr0IyviH31uj6JzY3Ogx5jZEVlCLnAcJJDGzEOR+XwmaMCnNfom4rsY5UdyNQ4xFqH9Sqg5jkEeoQ1JqTGY/U0nikbo5H6tp4pJrxSF02l01Jjc1k+rZ3nPSnSbbp/w8E2/QXlmvTX1isTX9hqTb9hYXa9BeWadNfVKRN/8ASbfoHE2jTP5g8m/7BxNn0DybNpn9AYfarctRB81f6JhLM0jGR4DK9EgkauiQSXKM/IsFNOiMSLNET0ce+1zdfxZD/arC9xdyATEDX/Sxk25oD2dZHtjc7mtMdeZgum+vhQVXD0ePCy1CINx1aMirWcaDcGyrWdXDwMlIMJ/CcFoj1HRzk1BQ7dGD/UHeQf13VqNfNntwRhsZbCBU00dPLIDpTRANifIq4BmJiighjZJ4IRoklEFNTRIRBEt+lfEAcK/25NcAyvDchAUycqklQsst+/ywsSfM0ROskJErvyblKtqDHZZfMjt9PVnBcJgdg9E+DS28nIaQhSV2QukoakdQDqaekKs/T+vQFVlKNpEOQDpVUJ+kIpCMlNUg6Buk4YXaYuKqkySSvvqFu837M72OguNfMNky+aynP5qlE23XgfYSzGsy6nWREuYszIxjzuZZTNtcgp8F5xNhmT5IM8bRGVKNGMoK0xQyASLYtlgtMGbLcFqsKIqYtthVE1tpiqmCJ7LcF7VGCURNVcuPbWKD+qergc7jG7FY3gCPLFXCr4t4GbkGvGrb5ql/CnDjAQee/vXZvybQr31hbrFIssBwBgwaX1v5IKhLXuxLrAzsIsBGwuwHWRRfcCzB2yP2JDuGzuZc14VrBX3zfvR41/4m5Jd8yBS//2LvlOx94l5iGBvmNro9V/5IJuRma4cgNzCXNXebPP/YkM9rEpZDzl+XiEo5vAyg9hsZVN5vjxTHvL0q1V8NTBvuZwSRT8Id4QzenjhscWa7syeOGm+Ymnb+Mg+UsouszcT1skKeHQtRMP7V3J1CqyiRxylNv+fa7Mw+M0RlcVYJrwiVj0VFBKdkZyvLUVZN9UPAT7y5qKqo9c4v5x0xBzkLFFGrxfbcUtbnC0+CDvMm1PrryT8pJe5i1Cv7CneAZaFcdvnRz2VyKXDs5IiT/VVTXPpafxk23nkVaEzbEg172Jq8K59vptgS86KuJG9PHQi4aN7kUvjG0OcJ7Z0IoGbdsS1bIyWncXKNjgWiRy4/hJdG0IG2TnsYH+DaIOOpPC4iTfi3P0jbnNqhVB3IswRF5CQ5D3mXaq7xFqgPpl+CAlxE8cXAZwWNnfJmhzdINMsQhPhM8jqMGgkdx1EDwMI4aCPbj4xrWROonbwKiOMHDBCoj2E+gMoK9BCoj2E2gMoKdxLiyTUgmmF0kX6zEXEGGJCcSRxKTlz2JV6fwvjVVPoWXJ9Hww5e9fBi18uucOKfufjh1t9oUfjh1t9oUfjCJpl98d1oP1KdufzR1u/oUfjR1u/oUfncSzX7G7RtTtz+eul1jCj+eul1jCr83iS5/xu2bU7c/mbpdcwo/mbpdcwq/P4maz7h9Z+r2g6nbdabwwdTtOlP4o0l07TNu3526/XDqdt0pfDh1u+4U/mQS3fyM2/embj+aul1vCh9N3a43hX84iZY+5fbifNG1Kmbb7PijZCX779El3JXQsS7DxSJsw7Zk5YHruRunUzqMweiy/kxcSVoSBib5TLxIWhoSM/5MPEhaGhTTfibeIy3NF554Jp4jLc0Z7jwTr5FWEMDzmXiMtGjiuy2z1bb9F1PwuXceezeR88FvpCD95SSAOIS5HPz1kXWtYPa9dWRjK4hw711CcLhL4qt2SQJVXJJAFfAkdGlvZtw4HQXdBB0D3aQp+LH92N+GNWsBseMuIdpcwRRyscOyH7sDYr/s3fGtdz7wtvZih+XA+pFCkhMEVcic5tX2nV2nC3s9xMrZwgsprCELGHZMl7J/LLjjlrlktlZ5W9zLvZMx1Db1y/I7gsw1vFpByDBc/f2rOH2MQbq6Q5tAU/A7KxX3qriFwUTDXPJ71vve9cqafeLA6uG9OOy01sV4zEJ2NRhBnkBRYq5X4JdZkrvzuv2Kdz37x03BXDc3/bpVyT6BcNB3sH0dz4Z3r7Up0hWYmbeaeBqGc/3oYRjPVcNMF7Qjr/t4j32kXQsq/0BycY6uVhCLJZZRbzJzR/JVs1X6mCdOhWJWQS/9hh9zr+OB9SUhu6e5g3yb60iWui+CtHvJ3BknS11HslR0FfL+XPIZFNWu8J6QU8yW9F3Fu4Ov32yZ60SBPEAq2zuYw04lN+Onko8TU2T3urmERKiXzDrEynVzVQSffUmEGm3EKU3g1RauVsl3X8WmMVc9zMr484uwwb2e/QXp/18rs/d/rRz06jt6qfTmN/2Ye8fchAXqn7HMTYy9Kk2mzE3/z1iVT0qqViX779MY0VTc607ZT7iXtOL9d+ieeAcZnAvm5hqrYAhjqfyPy697DfaDzmPvrTdi9kfY5OjVsBi5huUGf7O0M7uOwgWqE1ttkJc/+VirkoZmC5mCSDSm4Nf69KAGNcuQytfgiFHw6yF9Wbg3TcFvhFSDgMrX1rnPa4ZkxHC+pglvCn4nLNiUeMpuRgfjXQ7Ga+Ytds0T/6Ox3D/8iHtzGZn7fuw978cXYU2Srgiz2fedb9IKc1+yLe0jWfdP+DH3PbPPwblv3vM/+oWKdwMbjLxcuu5d1dENIyT4aZj3zE/g8htIdgpruK9wG0LVMy7BYSKNfQpm3R/F3q/4AwPaDT7S24Fm0dxAOuDgkhK3PuaGeXeKawvZTbfMVyC6f8V8TYZePq533NLLNZlpcEd83QMzWVPGvIdR/B4On74Khc1Hbsn8+CJ9W7c4ifF5t4LdrjW5jyyYrfFol5TU7QeTyUp/yVjPXcdsuaWM7sqCL+UtiAUuNPFv5WI9R7xqeTvOC/vhxm3hk7FaxvkyhuRTjykkiCw/lQRiRMxTqNiWBVl7Cg2bEWTzKRRsa4KUniJe2SYQjTECH50SdvkcI5f92Dvcas2bqxwc8txIeC0T0hammPbTpjvPFAdbiEcJdA6KMqB1omko04DWiKagcANaJZpkppEtRMgEmoDiDuiQaByDseLtS+pZs2fmxaNPG64Pow+oD60dgc6R3IBuflKVEenQcGZyQ1WVmwrBUJZ350JwnmZLcXZFUg4YSk+ZbRftx2cJLGGSgq0BQ/QOYgZYCn47nAaApc2cYFlgc/BC4oQCbN4sCBYDtqAdImpHekIGr8aNU+tof0ccYOC80aQ3hJEkHqHJuAoFaiH+ncCS6cfaPyfjfR1RTCLR0D96IOmCnZ+Lrpw3dBTgfCa9g5B1W3pUc0KQ+92hgsuMW0fQMGgdwTVGrCO4yXB1BEuMVUewvCur2DWaOXcUvMtozATvMRozwfuMxkzwEYMxE3zCWMwEP2QoZoJVCcVMuCahmNn4OszvFW5YOwjFTBib/GpC4I61g1DMhLvWDkIxU94xN3TWhfxwbc2OhSJE0GeBrDG5+PlIDWtKfuyr8bJxnolVsHYx5QxOuF/j5HpD5mZOru9qhvW7Ovd4bxtrcpZqY37rwnq/a5HN+ob3tvB+JeB9e8z7lZBXp9UbmFZvmHdlnvpadKLz6wkUzdzwxvg8o2BK4TrvbQUrfcbwJD7TNOurLqbC/QPmt8XzZ1zM2H1HIsnAiB5LfbqS/UYAfBOq20Iu9rfLMETMxf5O+Ru34mUs4XOPvUtvUAm2F/s77MC0t06lM2TaABJpF7Lumh1319HKdZLM+iqE93TGXDLr23bVlt9/bZtLa/a/trnoS66YrSBrTJNfbAguh6AJwbUQ3AzBUgiWQ/AgBO+G4L0QvB+Cj0LwSQh+GIJVK4RrEbgegRsRuBmBOxG4G4F7EbgfgQ8j8FEEPo7AJxF4EIGHEXgUgat2pP0RuB6BGxG4GYE7EbgbgXsRuB+BDyPwUQQ+jsAnEXgQgYcReBSBq06k/RG4HoEbEbgZgTsRuBuBewpjQ2nW33RKOzj5+39IexcoOarzXLSravo1rdG0RjOjkYbHXxsJBgaJIQbNDAJpSghJvIR4CAQYLIHAoiVAYExIQqz2k3Zsxx3Hj0axTU3LxJ3Yjjsvu3PyoBO/2k4wHa/kppOcddzGWUmfHDvpe5OT9Do39/rq+/9dVbtnGjtnXS2tqX9/9e9df+3avZ//g8m5eZwHMjkzj1NCJmkeZ4dMTs3jaI3J7DzO3JhMzeMwbhbeBo/RlZhiNxy5NvW1pa9tfe0g57F5nOhxuo609VK0CoPmTE0Xv38e/T6TB+fR7zN5eB79PpNH5tHvM3l8Hv0+k6fm0e8z+dw8+v1Zb+mEIWN7SMumr019bQyJbF0taxVpi8cIkVUXWrPm4SqfafThJU1XpD9n2pd+numS9P9MF2VcuNLrwhAASIG3gM/VYd4KBKzGtYD62tTXRlwE7GiBKnEtoL5f1w+BHVgpITTswIqahh1YQdNti23ImG5ZbEN2Jeys1AKQJgt1pdeJY/507lM0BABZF2sykTShJdFXP6El0ummvjb0ta6fWINlW1JXISzbNF2BZZumfVi2JSBVIqeu44q0tVQJqDrOyk45gDbbN8wG++WcHYZxLf3YalKLqa++vpaSWlydbuhrPYlAq1ihyA47npGXZDd6QgcCgrObhDHFrGiVsIBJjKeo2UDAJFYpqFgNtJLQgETFRuXV7Xm4i7/Sq6a0RvaViMQWkH5ElkISl2JKS53Sb5OCuGkWt+ZIjp5IX9XJbgqDOCpcA50UNCpR6xpA0LeDXOkaaKWgX4lK10AzlVN3cKU7UaU789BCu9KrpqNXiEg/IksRWUybb1NI67dIQ2w7596AcC92zj2EY3D4L/JGT7o39c/KPc+hbWr2BI4X9/K64waapZsGHC/OYqE2y+oMyqO9es3nrTmhrgqOF6OsyguPF73weNELjxe9VceLsgfijUqxh0SFKDxevAGqQ8/k1IH/1OniATrwnzld9GibO0srX1rdSRbdGZz4DXzpq4LTRfN9yeK34lweThf3kkV7IyS7Cplakau/CrbJ6SIfb17jWbTtBKajd9E29yrWvLJy6ip8T888YMQL3TW0xO+PSjMMg1YcMM7iCWv3Ba+B4vZGn51uIM+0GeprE5zyVh4wzmLSGkrPB4yBNJEgapYsFq7MnuX0AeMKWQJeVFffg8tce2KzE4jsRR/tBtpr8t4Z8PZLdlVwwBhYWcn24m7W2eTLQbns5zN/+X0xsCCXObnM4AeKgsOfqB1qEV7JsQeuCX+mdk5dFSQQv8ALEg0rp24IEoirsDdIIJ7CTUECcRQOhAVYOXVnWLSVU3eFD7Vy6lBYdCyn7g6LjuXUPUZXkQ8mEZZO6yu2QlM5dTjIV7Ohwv0mrTh9JcdEeBOcQXeGdO9oQW97IWToyl5kmO7wNsKVlzrtuC7Ryqn76bqoRCjz6gUs93kWRqjdYdq3MEBdeanTSoTSxyRsjWzvN23Z36/DuP1KHNtiMsDeR7CFjACib6brIwFjGHFujASMYcC5OUy3YxhvbgnTiNdxC8ptJgVYyKkHtOYsknO8ARYmZzAYHAyThKHg9jA5hYHgjjCZxTBw5aVOI6XfqWPLsUTblnOJro2DCXgAh5OLY/PsCcMR/ZUrZaCGdxHRJIbzj6tESxe7vdcE6sVXaI1P9k8xG6gXX6G/KnucuDdQL2bXCewJ5UqZrrAfjBsC7eEraG+gPXyF1klmHxEHAu3hK/SnZx8s0irYaYpo8rKnDEv7prg/0N29QrcGdkohDYG9ZUgbYFcghwLd4ivorkDj+AqtfMz+I1AZ1ry4nIhrDxGiMsz+IOTzs0sJ+fLsfEI+Oju7kO/NXjhE0Zmdi9wd6B/zA5ZY/1h8VqBQMUhogJTmUAcpTaEGUppBFaQ0gQpI+fw+SDGVKDlSfowXClfouf8V2Fdr4noFx51P0RXZZzGeI1A6VuNvgsNXvdc+lJEF+Df1svvKcNm9K1hzX4k1N84UrpzWhWVWbuijV8TZERb4f7oEbxRenK7Q48bSdV4s+9PqTdPuldjQeJu7LyMKOmrWK+xkR9oSOm422OmWXcxZmqUF2fvYhVMoUcpEFpwideQsKdoPfFnZZdlgzu/KkY27hXg5MgEINm9n8ZwptUvmEbMz9rhakK0CeCrcpRCo0TmmvfUem17EKcIsDg3Um9hcUNmi7CRWv6vZMWrgNEHYs8Ke/bHsxZB9Stinfix7KWQnYacfy+6H7DPCPvNj2XFWoWbBPifsc0pHhh/Azhs77ptoj9fEHhBd6SX4LJL2TbuztN0rfiMm6nbROXO/Zkdq0I2nVmhFrLgz9YZ36A3vzLzhnbmBd/Az2O61vhHT0+Ttnv81uFbxKmxLpt1oggUvqBUor9D98zbowqegXrNNO4/ICjWFDe9t2nUECTWDLfFt2nHEnFAL7DMV+kpXyE6/RNAU3xH7hToIdcFt2nPEYaGOQE1wm/YbcVyoU/AjtU17jXhOKOym5i2hsZta0DScRhQ1XZLAjNsCpxG+pisSmHFb4DSiqumaBGbcFjiNqGu6IYEZtwVOI5qabklgxm2B04i2pjsSmHFb4DSiq+medP/bAqcReVvLb7OTmG2B04iipksSmHFb6DRC0xXxqbQtcBpR1XRNAjNuC5xG1DXdEJdAIr8EZhT5xZGUyC+a1SK/uEES+SUwo8gvrolEfoc1qkV+h0cFkV9C3Ij8jtYiv0KC3/marjhaj/wKCX5X1XTN0ZrkV0iouLqmESquoWmEimtqGqHiWppGqLi2phEqrqPprsMHAiK/wycCIv8QHwmI/EN8JiDyD/GhgMg/xKcCIv8QHwuI/EN8LiDyD/HBgMg/xLs+Iv8QHw2I/EN8NiDyD/HhgMg/xKcDIv8Qnw6I/EN8OiDyD3GgRpF/iAM1ivxxDtQo8sc5UKPIH+dAjSJ/nAM1ivxxDtQo8sdZtVvkj7NOt8gf500hkT/OWtwif5zVt0X+OOtti/xxVtgW+eMcqFHkj7NFrMgfZ4tYkT/OFrEif4ItYkX+BFvEivwJtogV+RNsEct9kZ/gbSKmKwneOtoueuqLTuUAbfeq30aMEXkhdHY1na7pdF2n6zrd0OmGTjd1uqnTLZ1uSZrjFu1bdLq30nav9yrio3ilb4QRs7d7+W8z5ptYQbCKiRUFq5pYSbCaifmC1SNsqye+i/Dwea8VhzYTgiVrR1W4nT2JJ7wmoVlOSa9f0Mnjkszr5BFJ9r4tycOS7OrkQUl2dHK/+M/eyhPB9gF2Wrseo+Us/RTOVLZnaAnrLEQIoe06BPp2zzqxdsiKxSy2RdhOiwhD8pcx8SDNXfaijsRV1GSWO+xFHYvL1yRxd72oo3FVNTmHztpeosWtsboVRfZAYGeLrId0VI+VQHYlMLUSoJXAzEpgLgSO4s0X8cZ/bElkGCyhtm+3z5PwLX8Ry32B5rDT94Xd9L73SNCX7dvtGbpcgnZePWOTeIm3EfRzXLHKGSJL4iyJg3teDf2PqyUW9+rpy+Xylqy7ljojMQ44pHpqAHtK2LPCntXsHFA9O4A9K+xTwj6l2afAPjWAfUrYSdhJsxPYaQA7CfuMsM9o9hmwzwxgnxH2OWGf0+wcinNuADtCjmKLcLNEP3eTHLvaTXB0a1ciXrs2R8F2HY6M7Q5xsGvMia5FwXOzzikcml8LoeZmneM4T78W7z836xzGrs+1qLu5WecgPHlci3qfm3X2+66DBMJg8sQHGgXXoh7mZp0jfsaNU4xis05+rUpR6ozCKfwQpR+eVrimIHvjLRTzmt/lSWwMvglkQ2/ojEpx7I4UQgZKdEE0gZjXAu92isEph/aIdKYvEIeNyhHeNnivpBh8eeiNyDNcfRY5D/c1rZjXAe/VFIMLEP3j6osKKFFBhLf7XY6zHYPnEPGmFD/DAUQsCStIcUoEvD3wLlIMDkfAm6DEGRWnJHxiIi4hHF5q3hm7dNido2tpMVhxX0uXB+vwa+nqYHV+rV5F1kBul8UnyNlgdX8txS51Gm/Bot9eoph39iux3NZYbGiJrsV+E2r8B7Gc1/1XK/sObgP4SM2TPMO7FnX8Ax0/qS3pdpDuSLoTpLsWXYutIdQJSmzEoOEkPWDMa7e5P0cr8HqaXosv9z2hRyGIxtMoVtMZinl5zTMMcTS+Bo/R9Ahai+aZ8Fr/02I1UK8thON1hBiia7Ezzh+2+E9oDdrEFUABwKwOq3A16iz/hN6gQWyDq6F2A7eUTpn91vq+SkrHmypzq36Cw76sgVboCNRBEYtLZcscGvhq2NJBC8SB+78hDrygrDK7N+WIwldTFvbwsHnjuMMxr/fD4CvFvNZ/i+lWGPMq39OxQ2JeW8MOWCK4o+EhvNTrYVSXGEdQlkYX82qvh/w9DSeRN+BHpX9X8BR+Mt8P2QsatinmNb4fFO9T2utyLatsmTJeT+h0mYa9/L8xncFLryO8RO17YQCUmNcJEhC4FAkMMRuBmBCuFwoHkSrfDyOqxLxWJIgahpRVKRSfLOa1dcJBoiiliB/HmFfXyQTudXUiyRXgS6Hw7Rrzmjph8zPGaQ28N45A4WeC+M3GysvL7iS/nm++XtN8vXz/61XN12v3vV7RfL26Uc9xPHgtHjwqD14Pd714bN18bNd8rN//2Kb52Pz3zcdWzce2jVpFhJDlZXcDP6lkPqlhPqn3vb4nVcwntfpesGA+qWa84Bh+KMNwUL7sbkT58iOn9b47gbfUyTHfzeKHVztC63x3nMbOuJto3Rl3mtafcfEL6v5QOgTI0dE017OmIUTrh1FH1Pxh1BE1fhh1RO0sk+eBXcjzIYbmuIB7y6x7IcvyuJsxFNcMXcKIHHGW4GZ6WfRbRim7LH781tIEYkhxz2K/5MZX+MMZovhZF5F141BstHCxjGdhbLpgWcX78ujU0heX0EBStHEZXyxJG5bxsRI0CX1WnWPnUtlX9mqXW2yQbGdYu84+o6DevufMi/j3e7vKy5Q5S+f5e/7j1/7P79z60Nyusq8SUYLW+u5aSkLmMiVX5Dq/L1fSyDXqu6OUogulx0z15+vLlTJypQNVvtBX2K6ysrVKn4OfrbuGRlgdyndHMEXPqe3aJXwMu67dxykG5cYOrqlFp40r/LTgOrroNHFNLzqNx+lqGuGgpRJqkdbIrHORx41hmVMu8qgyBk/Ma2iq7MvUEV371bQeA8Qwh3rkGaIMAOzZfIQ2CTqDQFYZuhYnFTSn3/PgLroWRyO0n+Zm7NiMnVp3fox4rtA4ySpfjZMUy24A1xrEcvwLx5563jrtWe4me4mkF0Y7XVDrl9UaWsMNDnN7C1NpjKI8cVPjfGMZUxl9N6vWIuN+NcHoMmYu+taUGsWtg2qS0WWVpKS+RYp/oofVBkaXMfHTt2bUOtw6oqYYXVZpSutbc2oMt46rjYwifLWNW2mgc2df5OjOsVln5uyLypEZHsd2js06xFAC5NTZF9UwOTSMA+OQK45bWeYaApnq41oDKDYoY3icjN/VRsTUPOu7YzSFONNnfXcdbUDcubPokyYRUfosGvEEJoxn8SMYR8M8i4a3ntYwlUGzG8NOXwwxY49QDOFiD0tbOyhNbz/FEB92iWI4DFrwYu6mDG3KPGs5p8nKfs5StnfqxqElDkJpexkYONjwLHDqKTWU/VjcdShGQx48oTz3NLb/Y+TAvXSM7O029FdBXYP27zpk3wDLEPQsNs/a8OLa6CQ2msmOxjJXI6eFuXX2c1b2bFxZl9qxeS7PwoouNmPH8BRrt6Dsyzpzl2Wdlnw4mLDJ3hrLKMubesabersX26+cadyBHrIzjULtsFDbLNTuK3Tesk57qWxMWdmPx8nyfvB/WXgxyxvKUSz7b1b2E0A/+S8arf+L5Q1lrVjmR7ZlPY+iZWrA82wkUpxISSLLiawkpjgxJQniBElihhMzIOdQ03JWHAsPj2NymhyTs+WYnDTz5Yhc8OUdLmQuClDUPf2w6bHwKe8vp7zltWRlp7hpRne8X5r0/mqE30TupQbdS8m97KB7Wbk3NejelNyjQfdI7s0Mujcj9+YG3ZvLTmX+16SdPH3x8xfFPN86oazNvNZ6dSOWDKUvbwwchsW8tmBFE2sJVjCxpmB5E2sI1vuSmffrjFW+vDGnHL2rFPPagla/vDEXYh3BaibWfXVjLtIniXm+3FzWdyVH3czRE6xhYvlvMNY0sYJgLRMrCtY2sZJgHRPzBeuaWOUbG3MuJlS9L2/MuXFnCQHvYZwxlMMMImC0aQg/rkQOa1MTzA4CpwaBlFtRZhIOXJLe38VkSPXy396Y40VC84/MF/62VO8fGR+nKFjdxEqCNUzMF6xkllcRzDexqmAVE6sJVu3L6+TUEDZFUuTIZG8IeyPQmR7ivbcpzJrQFVjof2FnwdG3LW8mCiGMjguD3xp0DJxxBuMZu4fg5JxOnpLkgk6WsBhP92swsf3AmmNa/x/dUvosQsunJJlFUsvjoGtKn4URCUt5BokMLz95vI0OxtS4H7VdFACOIwpzEgeD7GaDddRXF9Iwl8UhJBxWVM5yoRXLiKxYViOYxTussLxJiqpZaovBMOGri42k8qW8rqXWcXk9S00b99fq8vK2Ok/KK9jqEoNh0lfGQaC6SJdXt9UYl9ewlXGEqM7X5TVt5Up5LVtdajBc4KvLYKrBe7AWree3TqMGU7Sh7BshHctqg0+jWGgNI+JFFhwby74Rz7Gspnya8NWsgWyEPcg68GKid55xZ5NPk7663ECmfY5pQymisk+ucec8ny7wFYmgBQi6hsZ9EoFGJWTIiE/yeLev+mkdrfVJHra1ryJpjM73SYq+QIrOo+hhDhzDpadoc9lXa2DZOswrXX5GiraUfTViFJb1aRhvKU9K0SVlX61FkTSMF5LHpOjSsq/ON7Kt83GeadF6PGCjT5dzFvP7jfmYG1m8yKUJH5ERyj5d0NeuMW1ChaQxccbttf0NFE85TBZdCI6LmeMiny7ra3WYbFk4SxgFk8tMkz6N89wehWd90kUtcFGKC1nLoWPxAht9mj5Xoxx4Fvz4JJzlfJS1Z90/bn3ni5946rqXeYMfBWTKKGNGBO5jOMUFpss0yze5WPP+fq6PCS2geQeGHtBCGuIJgX7B1NJZlTZ++9EcdlpxXxfjEFjo0ObQVac5M4eyA7ZgYlOCLZ0wsI2CQcssAjcJ2OoDpwVs94HnSQ1jmYDwzdKBIgrICFmsoBWxns8dNuy3LwBLyXLX4lq0sOGCY3B3FNe85WZxfc5dh8spl9cR3Vc3uusjk+RdwPwvb8QiZ0KviThgVgw7OTROmfK5NZtfdjP287Q+DB/9MLQK0jRSdtfwb9Vdzz9vd5x7BHeC0jRadkcoTWvL7to9W68/73+8vn3TLhFsSuTKilwpd4yD92AGPhQNJNhHcFyZP3OXj4EC1bIft1rhrWxwaz1aTAwnwMGtqeAWPOpae47+1KG5y37tTbvcUWP7ISKjeLduFAzXjX6mbtRpuVFX7UbdnhsNCG7UXbobBlr0RXNQd11EjoVkxp3EZAETp7UyPjdATwpdBz2ix3LQE3qsBz2ux3PQ6/XkCPT5evIE+jw9uQKtN+MLoDfpyRnoNXry9rWNOdqoJ3egp/TUEPQGPXUEnRK6CTqrZQa9TssMekzLDHpYH1qAvoBGyzwVUCnKUIoyx6aVLq/36sac/Xy0FTPcN0vYZNyg4bIaphR2QvpYEOzqbIbSZ+V351vYDPhE2kqdhneFWDDzbqfMeQw6AUfWLtKXBDTllK1p3ch0M5SGGmPXvHG96mGPvAljCZTHpj1c+ibJjqZyw/h5D4XpynAOE5MgzRvqw4tOE/tvrXSOEtGcPZ2jeDRbT+coGc3T0znuMHQ1pnOUClP14VwgYS0k2dZhmJevXgznFfw79FoRb7OPt4F3aQ/nyGJjH5ZgOGe8R3c4F70F3DaDc0FS+UyOe9DwdiHDt/eHr3x80Sli6lzK5JA8pZuypJ7TjVxSeUu3f0kWdLImyaJO1iVZ0smGJH2dbEqyopMtSVZ1si3Jmk52JFnXya4kGzrZk2RTJ/NrONnSyYIk2zpZlGRHJ0uS7OqkL8meTlYkCa0hfl9JFnSyJsmiTtYlWdLJhiR9nWxKsqKTLUlWdbItyZpOdiRZ18muJBs62ZNkUyfzI/K+OlmQZFsni5Ls6GRJkl2d9CXZ08mKJKFlxO8ryYJO1iRZ1Mm6JEs62ZCkr5NNSVZ0siXJqiT5XaE6hF2/jtyqa86uJBs62ZNkUyfza+VldbIgybZOFiXZ0cmSJLs66Uuy54RTh82xzHuvci48bT+ffMdFMS/fip1Qqc0xgg401jzqYrq4TA4WoSMYq3WScmptkPR5ej8T3JrLqVGDE9OYiNN3t/B+VcfK/oqF81awXxQoGiM9k1ObA21jpCmn0oHKMdJTOTUceEVGOptTmcBhMtKpnFoTHIcmKRGclDK5wJrN4NLdQMWWG/tZEZrJg6wezeRhdnjM5BFWQ2byOCsnoxBoyVsim8MATAGygQI0ABgKrAvUoAHAjGAsUIYGkLdyan2gEg0AqvPjgWI0P/AUK0Yn2WHyBIAKG7clEURDTQKoasB3cmoDgJoGsMSeAlDXQNXJqY0AGhqoOTm1CUBTA3Unp6YBtBhIwEjNvQzXou3O4pq33ctx7VnuVly7lnsJrh3LncG1bbmXwv6f9dySXsPJqfPoUim96eTU+TQjiZaTUxfQJZKAO5wLaaskOk5OEV0uiZ6TUy7NSqLr5JSiyzhBW1h9LukVh3LIZLFHjyTJN6nACYF8DR+kfIcSSPkCRZBS9wWQUuv5RFjrvTiETGJs+isJg5DEmCJBApMYbExP1yz3agjDVRJb8Vtkl6Y1nCNNNiOyEZH1iKxFZDUgE5hYX8wjsruFksHjfqEudoJJ2kJbyhwIL0kX64OL/K6yEriToHHkvJjWDCqgEhVQG1xAN0HrpYDMoAKqUQH1wQX0EjQmBQwPKqAWFdAYXEA+SeukgPSgAupRAc3BBRSSlJUCNg8qoBEV0BpcQDHJ6xb3YrpoUAHNJCW92A4rn8EvcIPexU96rcmg6bDdIO4WM3p6k/TakyHZicjuZJi9uiG3+/+u1P7wo//1098K2tZUeLcWPkfL3h4sewnCdTjEe8vSbTq/MXre1KoGXIju+hFZ3LiKsRLdrUdkdTVjI7rbjsjmasZOdDe/KZJxNWMhulvctOquH92tRGRjUzhRTnrV1bnqAWvCe+e73pOS3/yfbspJiiu9uQn1WAr7hvNyFGeDcxZTUinpquLSx5+HVzkfudpS+xPoHFJqC00EBomTtIUmg8QG2kIbgsQUbaGpILGRttDGILGJttCmIDFNW2g6SJxHW+i8IHE+baHzg8QFtIUuCBIX0ha6MEgQbSEKEoq2kAoSLm0hN0ggEEXM61zAU+6UzKJl8t2+ALMYuZHVc/ELcjQSTr3zF+ZorU5hVeJeQqO4zCDHjHspDs4WHf9CzG8uzMngEfOKF+Zk6Ih5pQtzMnDEvMqFvIo6Dy6aoQ/x1bylf2cxr3RtTtleUhL+tWD86+vACC2o/P9iq4SvJPSyo8MZ+cTNa4C2JF8TY/RIsCJp5a1wddI2cnSZ1nJAn+GDr0dytD9l5QIxOp+yQjnw2MbfWn1iVF+PCi2+HolRet3KqdHg0f7rkRgVI0ft9UgMlPYXX7FDKSo/iqSo/qhfiuIf2n1S9DiflNkCraVof8UOn9sx6K7Bn/+q3SfDJ192Qhm6bTuUode2+2Rofdrpk6H+cngE6vmgtQyVl53wuVWDrhn8DaYjGf7ufUOhDLU/cUIZ6n/i9Mng54f6ZCi8MBSW2UEZWobu+4bC5/YMOm/wF5mOZPh8J5Ih/5mhUIbCZ4b6ZOh8r1+GZicqs9qJZKh1oufWDbph8Lc6/TL86zfjoQyN98ZDGZqgDRmqX4n3yVD6Vjwss4cytAz5b8XD5xYMumjwx7bb/rfwi6sw6OWTutDKn8dzKgG2FCVkUwOX2AZJLRDfmxNwl4BHBDws4FsFLFiC5i2BPyxXaGIyXtH4l3W6qdPf1Xwtfc3bcr+n77+g074t9ytyjX1R4w2NNzX+Vxrvaryn8R9pvOQI7ss19llH8LrGGxp/Tae7+n5H4/+u8dKQ4MUhwV+SKww/GK9p/Bsa72i8rfF/1ngxLnghLvgndLoqaRhlMP6Kxls6/Q/6flvj+YSu94T+Hgld7xr/ssarGm9q/Lsab2m8p/EXkvp7JHX9J3W9a7yi8YbG/0rjTY13Nf4jjfd4dZbSLTLhfTYlXjyxiEuFw3w9YngtYmhEDJ2I4d8jhm7EUEyHDC+lQ4bQd0TCq0UM34gY6hFDO2L454ihEzEUhkOGTwyHDMXhkKEaMbwSMdQihlbE8A8RQztiyGdChg9nQoZCJmSoRAxfjhiqEUMzYvhuxNCKGHoRwwtrQob8mpDBXxMyfDFiqEQMjYjhryKGZsTQjRh+FDH0IobSSNQeRqL2MBK1h4jhtYihETF0IoZ/jxi6EUNxbdQe1kbtYW3UHiKGb0QM9YihHTH8c8TQiRgKo1F7GI3aw2jUHiKGVyKGWsTQihj+IWJoRwz5bNQeslF7yEbtIWL4csRQjRiaEcN3I4ZWxNCLGF5YF7WHdVF7WBe1h4ihss7YHo79P69jkHGuif0HE7Htdg/E7tPzTpcJ9IR8673fj+syYt6HDPpjBv0pg37ZoD//fR5BY3pPuvd9XXKNCTMK1/d5lvl3xgBp0EWDLhm0b9AVg+4YdBt033Il5rUGYM0BWGMAVh+A1QZg1ZWYF3MzF8W8uRNqzeYYpYKJhkpjWtE9j9JYEyHSzg4544D5o7tFjuQuliO5IUp7jfSKpW2aXQb1Q+zi+SW2yEpjjUvYUSwDadkBEimrKn0X2y6dBO6ziWFa9oxYBzjj1VInMf/oXITYuRk2kh9m32qyVuYmeH4OGxVFR/ZvhrEti+0Xr7QZRypbaEuk76qzFM7P0cVCNjbnIOYKljWwp0t4/vk5SmcvRzPekkNlHKZh9N6z8pxeXL8EbcFmTdaXHdUkG2RdTFv2vIn/fV8v7RVXwLFpPjjPQL02o72srPHmYI3kUMqrYIuMV0lNynE65zWmedvMptSM3T0Ps7o4pS51eufpNngtGPPnR3pAVUYKBlJjpGggdUZKBtJgxD8/5zUS/MCYV/xKDFjnopzXsDTW+ypjzS1Rzq5ADQPqCFQ3oLZANQNqCVQ1oPzXGGptMcRo/Clj/uWGGNVXGStsi7JWBMobkC9Qb6uhOCVQ14CKAnUMqCZQcZshRv4vRLSrDDE6fynvud14T4FqBtQSqGpATYEqBtQQyDegrkCN7YYYtf8qol1niOH/N3nPncZ7CtQ1oKJAHQMqCNQ2oLxALQOqCJTfZYjR/TsRDZ4DQjlafy8v+o2Y8aaCVUysIZhvYnXBSiZWE6xoYm3BYBIbSVP5oUj4bVOa4j/L+75m5C4I1jaxvGAtE+v9kzRzE+sK1jCxkuTtvmZK0/6fIuL/EUkzsvsXfv8z+S98/M9ee+U0cq4lJwsbPnu77f95nEZ3/+qfN5vf/8K737ek5cQ2wRDG0xTOfPh8eq0VZ1Xh4MyWdSVELdfSnhhE4VwUci3tiUHUyaF+I9rjUMxhij0xMLUkStSW9sHA1EFRs7a0DwamjogitqV9MDDFPhiYYh8MMVE0YY2pmCifsGJWTBRSWJssJkoqrPHDtPhggAzs6cihIehk2jgPRjpOdqCV6Ijac7++pcNq3eC3I33LIYTnG/J+z9EmDJb0nl3YqWAj0MLf7FYt8OFFJ38Y9d6K4RYukcKpYEUTKwlWMjFfMN/EKoJVTKwqWNXEaoLVTKwuWN3EGoI1TKwpWNPEWoK1TKwtWNvEOoJ1TKwrWNfEeoL1TCz/14zhEumvClYwsaJgRRMrCVYyMV8w38QqglVMrCpY1cRqgtVMrC5Y3cQagjVMrClY08RagrVMrC1Y28Q6gnVMrCtY18R6gvVMLP83Un9/Y9afYAUTKwpWNLGSYCUT8wXzTawiWMXEqoJVTawmWM3E6oLVTawhWMPAyNoaa953Tax5H+pN7rfMPG3B2ibWEaxjYl3BuibWE6xnYvm/lXr7W7PeBCuYWFGwoomVBCuZmC+Yb2IVwSomVhWsamI1wWomVhesbmINwRom1hSsaWItwVom1hasbWIdwTom1hWsG2JejFXcY17vb2PQfYyHvSoDTtStDqFbfRrdqhN1qwCzg8Cpp6WvdQIwDh+Nce8vYkFfe6lTOjrvlI5qq0vUxvfYXldvgguGSzRrFaxqYhXBKibmC+aHWOZdjm2dnngeqk0+YnLbrAEZx7VouQlcC5abxDVvuSlcn3NZdfKUO4zLcTeDyxF3DS6HXTbHOOiuxWW/O4rLkpvFZcFdJwYtY2zN4a5ngw93nG1C3Ak2G3En2bLE3cC6Vu4UD62OOO4kx6vA6Rcb2EyVxbYG2tRsVzNZFpOaibJY04yzvSfb0qxnaI7GhHcBOsUQC7rHkJJNpoX5IGyo8R40IsxHoLaM14RqLd4azviF9zlo03K9wIqXK4pDjkvdweiXKxOGhly7bH7p+7yGcbCGcbw4ux77rSErdZrfNI1VmxrKsbn3UGROYrPGPqYrTPF0hSmerjCF6YoXc1Mwy4CeSYJS2jbDQTJJQ0GDS4iBRhzTgKQJZgeBU4PAwEAjBFMw0Eh5/10aMQvUTfCBOtO9BJ+NM51P8jE304Ukn1gzXUzy4TPTpSQf5jLtJxdx9s90JbmI7VGmq8lFnMgzXUuy32Cm68lFnJMz3Ugu4sib6WZyEVuoTLeSHL6d6XZy0WlrugMbTU13k4tOV9O95CK2WW12POzgb/Bh2DOxg78hUmSkaCAlRkoG4jPiG0iFkYqBVBmphkgabSYt697M54btzOnU8zDPLH5nI7vG0+ZJfPxXfWVjjk8wm3+/LsdWys2rc26Sw5/Etsb+7ksbYQjC1p3tL230un8XP5nz8gs5SmSvhI0Pw+gOUCwN4clD24FBq9i5cYRPPq5BOZTM/hTFsjOsSaYUWzkW1TLcJsw6la9t1IbUX9vosiVn62sbX3LXekOe49kUV/wbxg/6GHrUWWnW2t+qmEjOSgNfgZGJKWcaQVdghbo1tnADWypatw5xksi+Ye+IDRV2a7u9QFa4xYO1xGHRMz1IFnRsoQIPk8iMvUSOLubmESsqhhXKoyh5D7NZowXV3sMo/5rYIhxSsJ2j5+xVKeS8xovte1qlr4ldw7C9F+AOBoevie1gtf6RZV40+IaFtGffOK1GFp2D8laLaggfLDUSozUsxLLeDfrrXcdcJ+NZNLLHnzzwMWwPHSNnGi+PD7Qg9ps3wBfJ1hjtGzrtWZ5D9nScjTJpVMxl1yy/SGv2/Nz4b+z73s9+dFdZraG16AjZXnYEXeFLodp/WY1A4mPTx24YsTzbG6Khac+m4emMi05rrZgujIrFgnNNjF2/COXFXZvSN/DXQH1Do9y+JjYkivr7xfhIVlRQUbdm7BgbHkuY376yM6JkWFCLTvVrG1mD8FW+tF7d6O959c/w7we72NoJ4Nc3SsOsXVR214klbvWisjsmZOUiaNwz6V8EPXsmSxeV3bVCFi8qu6NCFi4qu1nPcm1nidaxIanzTI5NAKEHuIYRhLke8moXidcBdx3hOUNeNQDG2FB3yKsEwHoaYcAPgBFay0ApANbSKAPFABilLAOFAMiitUIhYFjPI6BkqWgdYuShhlgHU9EYYugF6Zqi9YixF6SrikYQgy9IVxStXV50el/VaV/R6PKi0w3SJUXZ5UWn89WNGb0rp/uj/exRM+a12DLuUqf6yka9USGmcp1XNkYTmoZg3VcM87mmYD0Ta2vzvlcMs72ONu8zsa427wuxzHccK/G8Xv1zb6Mcbtzc9aTUECd4jpJVcYzgFvc6MD9PlMWIBH2OSnKCzXJnFCLx+DKJd/iXAr8H2BkoIxASQmiznwq0bLiowA+cnbDMOoclZyrIeUTnPK5zngpzPqdz5i2dtWBJ3myQt2jpzCVL5/atMHvF0vmrQf6azj8V5K8H+RtB/maUvxXkbwf5Ozo/Bfm7Qf5ekD9vh/kLts5ftHX+ki35Z4L8vq3zV2ydvxrlrwX560H+hs4/l3kfJk32aU8ath1ujiPC0SZBe3bUSbLlAmsoi4q37s+yS+VjGTeOUZGjx5qliKp0XxGi2Cxa4UYJrpUJJGkOlKTgrJak7og6eZ8kCZGktVqS4mpJGo5ooJuS2KEk7YGSlAZI0nREdb1PkqRI0lktib9akpYj2u6mJA53BkNuSgrqri6osrqgtiN68mZBQxlKed+P3UTxp8h6ihJPkf0UJZ8i5ykaeirzkb+3natP/4r1vAUV7+wJdf5mXlezWgYePWP/4PW42gCi83p8P09oNvC48oPX4xfFvG7yhFq/madC/rfiapImvR+8lszN2DF1HvzPnMzBmwRnmjmZE7WODRia+B40tJSVnaV1tGFrLHVNrHRUyI3XxF7U5KZrYmeO0nrzcKmd7E+3VqSbK9KNFen6inQNadEdWK+DaqzXQTX4WtTXgr7m9bWzopyqxnsJWuc6tAGh62xdNXAwgXCv7iwMff4mdkJl2dKnmGFnNYtyVjbFWH6csXn04euZhPuCrpA70XELeQD9upB7MV4IuQ8jgJA3sksR92Z06DAvopj32iaMHdN8lBQ8Xd1yppwtW+4ddAvdSDeWaR/tK9Ne2ou+5AAdKNNO2ln2aYEWyjRP8xwu7UyZbj6LXAd48TXKZ2RprxfPqQmRPo0jK+WK/A446AAEWqI09CPZfnDnmWzZKtMCzZcVSs56zBkdv6kxKPO2bG23d9ku4WNNYV+iTfS7WGBzbT6Lm9dnceOUZg156CqG5n9lxW8zHjiL4RM5NUbzBkffg9jup8+JDx8Byqsqecmp6PjOyV4Ojcysu1fUqvexGqd7IytJ4otguX8Lv+wQ3UE7A3PGV8pcIbfQzXRjWaHe8Tnmaa/P4uDvgnG+h5dQCzRPCw9P+1lPXIeMevFncmrM601pR2UJnLfRGNR5UQeP8r9/egVvyC+hAhVTL+aOOUuUoDH9OesqR/iSjQtygXJn2mtosGmCTQ22InAMG+Fj3gTPqRJeYQs4El5XZl1qQR+Kbs4Rk+NSiQkvrxk7m3UjEUZ/S4402dosHPV+jlLEUeQyFsKnVIOnyJkqf9px9nKFd9c1+hX90fG9dVXmoA28NRa7YSRy8YGf49bYa5vw952Zp2F+6vWm5YeaiZrFTmkW8/8/msXCGZo/azYIfG80iJ1oEEjg77zRIOb1L4kWjqFBZGgUU8tRfeA7pQ98t8ZKR3m4tEB59r4RVoaxnvLsvXA076YRS27hhBrjEHQOTjD4O/K+g+XO47qAnzXvdO3Edcndy7sPlrsP1/3ujeKlwL2Z/TDgrfByB9jLgXsH+zhw78bllHsPLs+59/MWh+W+hca8xjwrCc/Nc0OqS2pGUjVJkaSqkpqSVGU+Ui4e8/z5SAcZGsjudyzwLGiFiTGvGpG1kKTvIO7UPI3xaLBAY/SWKFzLolMCcr+JFIHcYyIFIHebSB7IHSbSm6cxOmAiXSDnPrW/6HRA3kj7/EWnDXIv7fQXnRbIc793f9FpztOY15zmjQ8rp8b1cT13rxXrpBqV2+hHF2AeNE6jbGQ0xX3/RNCtSRlToTrN0gnNW/zJvIhpIsyln8wMa/QEM8M6alR8+/UzB4pFerOGOw40Rn6niZPulOZLB9GQFjDMuAlniUcQd96z3FFnKSjNmzipxr0Jto0Kg+XoEmgiikwjUILGVzGNR0zzvu/O0yhi14zqLm1MftcTJynNfDQvrwKUpgwogfdJeBOIWakfFkQrnedopeYL05hXms+5F3gxN3FuUlb8x9gJldmsy82wk+jszWozR3PAw92LsUsu5VUs9Vb3Tkpgs4reSneW3Ts9y73EWdKNJE2XoFIuQ6XMUDJ83zQlaCZ61zQl6bK+m5cZcXx8372TLkFFXKIlznj5N8HOauKkrmi6U3RNGKaLDSyJN01KVTjsAYfFdu/keggrSkpl0xW0awkOMM07cClv8iQ2Z9O6Mrgh3Nk/AeCslDZ8A915VnZa1yOIUwrVNkMpxHK6SDOnvKp1Mudu9WC9M+0mKMXtTp4hHyjJLHjcW82JQDQu3AnxKM2PcNN0sWch5EG0MaULS0Z1DYfBsfKyeydd5KYzdLHEGr8zeuzESf2Z1CWzTvhiugB1GeemS1CFdNm55TgXlca3SZOOqyRZgmfSnfTWsxyY9GK8/cWUdNN91Z6hadyY5tpRqfBbtEdy7ihlvFIy545Txqskcu6l+MTxnHs5ZWCy526jDEISuVdQBl2NOwd/o3Gp485kzt1KGc+P51x8uuJkzr2EMl6TQ65nvPpEzv0p8Ds59zLwj+fcJJ7j5NwhPHc8564Bv40t2YxXX59zZ/B8O+eupYzXHcu5G8HPb5XxSmM5NwW5Yjl3E+pzXc69kD9oN5vTTdNBFFdMNacxOKursgdQwGiOpnnqORHoUGQQuY+ukrzZWykDE7duAn8ro+cW5JVRgXoMVQFVNZRP4m8NUE1DBYbqgOoaKjLUANTQUImhJqCmhnyGWoBaGqow1AbU1lCVoQ6gjoZqDHUBdTVUZ6gHqKehBkN5uEjMZwVqMlQAVNBQi6EioKKG2gyVAJU01GHIB+RrqMtQBVBFQz2GqoCqGsqnWGBANQ0VGKoDqmuoyFADUENDJYaagJoa8hlqAWppqMJQG1BbQ1WGOoA6WTS8BPwQT2PKrKb0vliGAzNup2mosik3RFsJ6IhMQ+VNqRBtJnJqmKZ5Zr0lQGkaah9qWhxFJyhDV/FscBhPT7HJI4+EcaSz7EnBFzf/GeynbY+8Wma0B3NJ8zvEuDoS/qKUnIFSLD9ojlMlnZrhVFGniFMFnZriVF6nuG6ge6vdLmcoc6nT5UkVanGdeydX3Tr3rfy51rk/zd9onfscbaILeaI2IxThQUxN4SFMZfEApjieC1NcSxdDv3AOYjPFpTDFpTDFpTDFpTDFpTAV0xI2x9yf4Y8/5v4sf/Ex9+f4M4+5z9Na2qjLZorLZorLZorLZorLZkrmMTSjJWSKS2GKS2GKS2GKS2GKS2EqkLC33v15bvDj7ju4lY+7p7lpj7t5BFVfo1mZ4uxMcZFM8WOY4kczxeJcRkmT4rtMcQ6muBSmuGSm+GlM8evh9zPh/oLF33vC/UUmqhPui0zUJtwzCL77U/pJTPGTmOInMcVPYoqfxJTM8egS/SSmuBSmuBSmuBSmuBSmuBSmgopsTLq/wjI1J91PMtGadHfyR59099JFCBHBpTPFpTPFpTPFpTPFpTMVlF7a4O7jutjg3shVscG9mWtig3sL92oT7gH+nBPuHfw5J927+XNOuvewdOPu/SzcuPsWlm3cfZhlG3ePcbnr3ae43PXu01zuevdtXMHr3Xfzy/TWue9hIj/mznPJY+4CZeg5bixj7CYrQz9NCz7O4DL0Vl4cIMD4nfQei51jzYlzmDmxo5oT5zBzu3W/9Dy9G2w9izL0c/Q2n4MDZehn6WmfYwZl6GfoKZ9DCV0hBV0hBV0hBV0RFJS36JjPIXUydJoe9jnSTobeQW/xOQBPhn6e7vclLo8UtE0K2iYFbQsKOmPRPT7Hp8nQixbd7XPcmgz9okV3+BzPJkO/YNEBn+PcXC5lXS5lXS5lXR6UtZdu8TncS4Z2yroK5CctutHn6DAZ+hWLF1mtOF0qJV0qJV0qJV2qS+IpgMylLsB0AimZLWRvoyl0j0WOSOiCLDCpQOaZ3AKyxyETp7krZfIqGg90NydoNJhtIEa8epNesfO8XU8HA4Vsh61zRf/wAq3awBSrNjDFqg1MsSYmU6yJyRRrYjLFmphMsSYmU6yJyRRrYjLFmphMsSYmU6yJyRRrYjLFmphMaU1MprUmJtNaE5NprYnJtGhi8vj0jxy1ZTMm8o63DpqTWBTVF4ytC7gAkw0LZy9WEqyqih2NcE+DcWtr7MWjnrMPR83YfL/QXRSzrxm5kFymTBtDR1sc4uHQWAzolkE3Dbph0HWDrhl016B7Bg0NxoAuGHTRoEsGXTHoqkHXDLpu0A2DbprP+htDBoPuGTxdg+4YdNt8lpG3ZtBVg64YtG/QJYNm5b7F0KVbsI0lyj6shahp1o7UNGttLkaHHWqRFstqUW6yeqmmqwGNPb0EmtCLR2lRGkT2mqhlSCviwzXhYadL2Zc5ug8ilWZ3oAR7a2xyaAlbpTRCI96/6vOOCX3ewd5xtLJPoHiUCBWPEqHiUSJQPBKKf51M8a+TKf51MsW/Tqb418kU/zqZ4l8nU/zrZIp/nUzxr5Mp/nUmZJONf50J2c/jX2dCNvP415mQnTz+dSZkG0/rSSf0PsKY1uiTfYXRSKEvLXrS4zkapXETDPSkRwNQbw9rPekRCirQlv1G1pi2WWPa0RrTtqExbQ/QmLYHaEzbAzSm7QEa0/YAjWl7gMa0PUBj2h6gMW0P0Ji2B2hM2wM0pu0BGtP2AI1pe4DGtD1AY9oeoDFtD9CYtgdoTNsDNKbtARrT9gCNaXuAxrQ9QGPaHqAxbQ/QmLYHaEzbAzSm7QEa0/YAjWl7gMa0PUBj2h6gMW0P0Ji2B2hM2wM0pu0BGtP2AI1pe4DGtD1AY9oeoDFtD9CYtrmDg36kdG/6/C/oCXVHOI/AH9Ah6O8D54M+ENv+UI9Taa99QQ4ONjnbXV7MHfVirsIB58YTKr4Z6rmt9djCK4ojlHi0H3eX0dnvol1l9cxZtWvR6cAz/65Fp6qvvfFBmdDZc6b3WpyrPi7cBX1trreXKI7lK9kKjsSypOytsaYd7cZ1f+RyZx73Wmtzbgp+z+0TanhzjIbhqD8UmdV0fRtPMf090i7Wfikv41Kx1YNldQQd/UqOrHAs0REhqnZZPbJouH0XtqnysrvDs3jbdgclvbmT3KFO0XCwRYpNwh3B7qn0mMO0A3lrdlndtmh4ixcVv12Di6Q3KHLILLJul9WbFw0n86IK/AZFzrxBkXGzyIZdVrcvMu+Di85CtGe6w6wzrqoHg6pSN5XVk4vO0qCKwQMJFpFz4SPdZHDYZa+sn8OLzn40T+Oxg6rmxxbqrKyh+xadgz+x0JkfX+jQyjryMJQP002LxmHzqjp6jm6SOqrZan9Z3bvoPMc/PvvHvNKRn1RPeKWjmBWsfCf7x7zTkZ9UUXinQzy/GKb9MNF947eqWrRfXqtuq91ldSsCK/J7OT9GgqL1hi9mQ+XK3UMpEQSh36NoxL56gFe6KXoAzTJFB8lbcbeHu4fo9jIdpTeX6V66rUw30SMGF+IvXY8pV4p20MGy2gHmW8G8n27r41MP8cQqRddjFpiihzAFROkeSr8PpR9G6U+uLv04l+6h4PtQ8OFVBZd0wUtS8H5KkQdJ7oMkhyH2k/RImR6kI/2lc/FzkjeFKoi+xx7aXV4uqz0oZje92cyHTHX9ROJHeXjUfXjUYTzqSTzqwRWPwlQ2RXvAu5vu6yvP41jGKfIwoU3R7XjmmyH6bRD9EYh+hI6UCV1+f6G8A4raOYTaOYraube/dnZxzE5U9CFU9FFU9L2o6Jv6i8IcmZvCYUphCHmOhT0EYY/2CbuLgy0zD2wX6CAdMpvNLo6hzLcLFou2A6LdCtH29z2S7dXxkB14yK0rH9LSD6nKQ3aYD9nBwZlTtIODQ6OMPShjt1kGb9gg554VOYs2wwfLfUfauriORcOeb2OlHccedGst/jah6AoSiTZDLUBtDXUYagPqMAQFpO12Pcl0ay3iH9kR/R8TTNfW5LbbPaHrydx2+1+Fbti57XZ3QoructEdFN3VT+sx1AXU01B+lG8AAolEgaH8OFR0NVRkqACoqKESQ0VAJQ35DJUAgfS6E7nsXdKDuLqjdN8sna97VAYqd7dMA9zrdZ9zk/Rn7pPa9OcgTrrJfVSMdvaIlc99XIjl7he7oAfBM+U+IBY9D4kJ0BFtQ3QrbmZdT+x8bhPDoMMAZ9zjYhH0mJgQsUvmlHu7mAKdkOmLe0jcQu6SanddSsMzuWt7MTeJQ+Ypnvs4SzQMVzaUoqQY+/DT/exutIo4Vm9J4cheL9FLxqFbMEXDXm9tjt0hdBI8UUKaxrEwHJ512oyNY/aothi8XY1jBbnZwHsab1twOBrhMH4BXrJz6iIDLzDOj4IdTNMWGnYwBUdo2MHUNQ07mJ6m2Q5mSGjYwXQ0DTsYPy407GBamoYdTDEhNOxgGppui10O0x2xp2Fa28GMsoXKsNjCQEGrLcl8SmoLvpTHudq9uZMYwGrZYM4uN6egzlBfAW4B2FgBbgbYXAGyNkRrBXgRwLYBwnX0OMslEav1PC6p1TBse4nto5JQxJAvbAeKGI+495LMEx6he8vuvVoRQ7hGvSQUMZLwJB7pHOgSKBWpFgiUNBQxAiZDEeNe33fv7VfEkEab9JKYHfAp973yRgwHqhj3irpg8FZ7xUaF3QDuG3Hgs33W6Wb4CyJmXCclUI+hShoddlqg/BrmAtTRUIGhyjC4hgUqChegjoZKwpUBV0YgX7gAdTL6ZyY/sTvV+NZY3RmxyPWwPMF6ZM1QJqilQIPkXmhOcGH4ql4TUcLUKM7JoWyT3UsuSYr/ZvejgOIU9/Dw/i6dMorH1jL3gLU13ANC8NKwQHWGfEC+hhoMBW8cdui60y8NR50+07rT9+P/iU6/yUVXUXRVP63FUA1QTUNthuqA6hrqMNQA1NBQl6EmoKaGegy1ALU0lB/hEgG1h2kXHcIC8wRdT9fT7XQCK5+yup0OY5Alj24DQIfpdsAePYiJBT1ADzF8BDA9SB5uPkBPYipDj9Ievnkf38RUc5mepAfA8ijdhFkCHafHmCXHLLcyy36w0E306DnGshIpGGbyzVyUcDNwlB//5vA5OYGfLC/TbYSbD/HNPXyTn+Ye1CPcIWeJlDd3UiXlg2GXgIdxSuYUPMvs+dAPf9f/969Xd7JBppw92+yitP+OhFvkO9n+OxJ7ke9M9d+R+It8h/rvSAxGvjPTf4fjMJLCD1h5rOoiLUrEf+MFvwzk9+qB/BE9kH/Q0iP5Jyw9lPuWHsuXLT2Yly09mp+1ZBz/jCUD+cuWHsl/1ZKh/LOWDOIVS0bxX7P0MP7rlgzgX7ZkBK9ZMnb/niWD93+xZNj+fUuP239gcYPOutfwTzLrXsvNfNS9jn8Oo+6SzNLcG2TO457k1p5138kZ/ax7J/8IRt238o9l1P1pmcO5z8mMyP0ZLiDr/iz/mrPuz/EvZNR9nh886v68TPDcd8h0yT3N+bM4pMZvNIsjYvyAsjgixrNHcUTMMzccEfOECge0KCWLA1rInXV3srzQg8XjR919MrNzb2QxRt2buYisewuLnXUPsLhZ9w5+/Kh7t0z73HtYilH3fr2Dk+R+rTsBDQzMVozeTY1m7zHnaVVb5mk1W6Ziddu9VTeP23T1H+bPc8Z9kD/LGZmcZc/I7GzqjEzP6Ix7ij/fGZngLZ1x387f/YxMzQ6ekblZwTrjchiM587IvCxvnXHfpdvOGfdxaWZn3Cek4Z1x32dpm+RhSvG8wBZjZPwc6bYyJvPY0yNg77OwjmAXUHQrbyPg1hRuPY47T2Dhxbd9uq+s9sj9LO7ncP9dFhhOYCEhXD7dVFb7hS0FtkfB9hi4joPr7bQ/ZPXp+rLaLT3Cg2A7BbYjYHsIbA/Qbt1rMPPhsujisX6Z/HRHg0UH64cNyyfk7cSUfEIYu5b0ByvqD1bQHyyvP1jPkg/WteSDdSz5YHlLPthz8r1Oyec6Ll/riHysw/pbyafaLx9qSb7Tgv5Kc/KN2pZ8opblvo/xpuV+iImG5T7LLclyPxz0CcWg+yhJz2K5L1jaYUDB0h4D3m9plwEfCDqKl3TH8Eu6q/mI7lF+WXcgH9UdxccssfX/uBU2E5XMcdDVUem31Q76JassvqQ9Ol72uWdWe+glS+gptZ+Kmia1mx4QckZdTzeVuZO1aQd9xCqTR4+VfdpDD5V92k8l5NlNT5R9uv7c4l931Dvol5kzx5xHmPMF4Xyfxay3lnVvv4M+yqwnmPUUsxaE9UPCeltZDxk76GPM+i6LeR9l3vcL77PMerisx50d9HFmfZw5386cHxDOD0upD5b9Ve3PWOz68VWL3Up81WK3Go8WuzynMRe4BWvVYjcVTXt4qqOnPQVr1Vq3Fl+11q3HV611G/FVa91mfNVatxVftdZtx1etdTvx/rVu38of86b1/St/zJvWr1ra85JfvznT/xtvHmwgYPq1vn/hj3nx+v6FPxQ61vcv/KHAsr5/4Q81xvH+hb+vjwiMhT9UU8b7F/6Y9o4H0yKRWl7pJ00q/tDSw8gfWXpceSWYVtSDacUfy2/elqV825IthYolWwinZGRakH4uJjsFHcv9k6AT+UowB/mq7hi+pucgXw/6m2/oOUhD9xjf1HOQbwVdy5/qLuTP9BzkVd3VfFvPQV7TXUszmIP8ucVfMYrDxFVDaa+wHn878GbvpXLZu/WHm+CtL6nSSd6hkkn9JG8vyWfbwFtO8lUneGeU6cokby1KA5zk/Vn5phsWEZ9F8k7yhifT1UneOpTWOck7tvLBNyzCI7PkneQtQFnZTPLunbS5Sd6qk9awYRFhXiTvJO/MybJnkjfi5L0meddN3mvDImLBSN5J3qSTNdEkb7vJe03yXpu814ZFBIy5nvacG1XL2Zdh4uLRbtohiYfpvThic4/RM7g8Jd4xpQGkES4A5H04Z+uc5+6XDR6czAP+sCVbQ6d0vL33sReABYxIE7i+xFdyH8QF+0oTGMiKjKZcD5ese0TMkN5liQ20+zRbXLtv0zH93i0+BqCIJsH95tlG211Ethn37Xq4npCfNe8qWXrYTnBj552qou0+gGvBdp/BNW+7j+Las9zjuHYt9zFcO5ZsYuUt9wSuz7mPS2yTJ3A57r6X3/iI+ywuhzGcJiBsga/7MZgmINwH+LqAITSBV/4IX9sWxtAEj94fZaJpYRRN8Oj9cSbqlvspJmqW+2kmqpb7OSYqlvt5JnzL/QITJcv9DSaKlvtFJgqWW7Vka+43Ldn4+y1LNvd+W3+s37HkI/6u/ohfwvA9gUhvJ1UaKiQ2pXMqLcP3b1plfPqU2i0jaRrj9/VU1fSUuok+rWlSt/LIm8b4fZsMitAq2UG/ZWGHuCAjIEbcm+hzSNyK8dqn2zDsiy7KDvpt5n2/8D7OvJ8X3o8K7zMyhIP3d5j3A8L7BPN+QXg/JryPyhgO3t9l3l8S3vdazPwbwvxxYT4uoziYv8TMHxHmZ5n3i8L7KeF9TIZxC8O4pQ/S0A9xM0RzRDNMS5NUXNuHpbIf0J/2Gf1lH9Uf9rj+ro/pz5rTX/WE/qiP60b5hDRKaYanpBke183wiG6Gh3UzPKib4X7dDJd0M1zQrXBON8IZ3QZJN8Ep3QKz7qelaaTZptMiTPwozauBBDePMklJKbW7TFJ4Vl0Py1154pS6qUwiBKlbyyRyzajbAj8KFj2AKfthzNE/bRFn/ZR1bu5HH7dwbvExi24LvDVYVOB1xgsWuJ8V5vcy8xPgfTxghTOSE+DMgfExYTwOvkfB90zANxWYPvH3M0ZVnCqh50wpzF7jkPhWOkJe+dxr+kjvV7fRQ0hfL+nj6gWLd13Ova+vHi/zRk0clfERbklxuGM5LLwHFUsE8pQqQHxfHeeGxlmm1C/LMxcUxAceR+zmE5LlOfV+yfIMzpE4B6mPSo4l9QBpAY+oR/khN/GgZSk0eHXuFxIFffbVs/1mS79kGRFwP2DRrfQh69zKzlfvs+gUVlMfxhEplSzMt30+UZKDNxwA+f5ZX+2hu2gP3fXwNCjDJw2jx6bVXXRX+SW1n95eVnfhV2Q873OWTy+YAnzY8o3UKbqLPmLe/pBFhwmFPGaAn7d8Kphcb/cV9we/bIIfsyjHWU8Y4G9YPr3f5Pq45asvmkAVzd9IfwpNF8U8aoC/aaFFGsCnLV/9lgn8tmV+g0i75NmX1O9YZ1XJoscN7sfpLl41PWNgv2vRE0byWd8vK3yHZfUlq/+L4iNGnD4+6m3E6y117otRXxXjYx82mT9k0WP4sPR234TfTnvwo8yZWNHitbtPqDSslVA3JsPHLexBln1CdXzKqA6zLtCyHqfjZr7Hac+57p74FY/T8fJyVF9fsl5Sn7bOnmsndIq+YBapTtEe9NaEqqbjqJmyeoaeKS+vbPH8wN+1aD+Wo2o/RhC/rJ44ox4/R6L2pFWea+grKkoaWj/uU9EiaUYrMuxHXyYtA3f6XhpfgU4RtA8wSvo+PSECP0FPmK/77EvqJeusehY1hO2Pj1l9D/gUO3ehJ/CW/OP4kFVeVh9Y0R4OiZbAI/QI3U6fsWgH/YFVVqfKy/SyRU/S71sE2rfK6u3lZTpr0VH6smA1iwB9wiorqDxQ2aIPWvRmqsjtX5Pbn7XQtpbL6hD+7KBlC+fdtIt+T9j+i7D9urDRr1p0qLwMrh28w4y/6iBdW0bZh/CMg8LFNw7RdWVaok8gM550SEQ8KAUyy71lOkm+RW+HvPeKXIfk7Q7K45ntkTLdQH+Aav99ix4pL+MlwV0R7s8I9+9p7g9a4mJwB11T9pfVJ3gP8dxUhp6kg3RnmQ7RW3Gs/9Nl+hnoCjxHUYZ3WsjxJM/rLSgAHKSfQ4bnkeHny3QaGd5hZPhZ8B/leT23hTfTIfpFC9wvWmXYCjxShn2CZKCD9Avo3HZQnp/zZl4bWGW6nQ7RXmTaV6abkeXGKMdOzvBJznA7Lw4sqDYcojuQ4e4y3Y8M90QZDnCGW8C/ixc9fEPdiz0/DI6LNO+rHdhXofdYMOZQBzG80tvoaV8d4jmjesRXHwQ3dlDoVuz2HSmrIzyPepdFD5UV9nRewG16sKweLPvqBWtZ+Wa3uWyR1HyNaz4u7o+4qhq6quLsAIn4rVr8VnF2fwRxyxjJeBtpB+aldJA3kw7xlFSdtXz1Gdxl+Q7zvtFjvM9UgEC+emxZ9fWjhUCYTiBMNxCmFwmTt7Uw8KXEwhTZBZJ6mYX5ZRYmx8KcYGEw51W/avnqs7jLwuRYmBMszPtFmNyyMgfOE1qUkq1FgVsmFqVih6JUA1FqgSh1EeX9LMpHWZQHWJRHWRSeLlQsX/0aT/ogygMsyqMsyntFlAeW1WH0aL7aH/VUH7BeUo+eVe+1wPUh64z6dYueOaOeofvOqPvIQ/fCGieyxUaHMZnx1U3Y0VNeGb3BrTI6m8ORusv31a3oLDEFo+Nn1GFs8hYwoO0pE+7u8X16FhMyeuKMug0Tv/30+Dmmc69ZxnyD9tCz6CnuKtP1vkzcbkXnexuQZ85Nlmg3ev/dmFbxwHAXhLsec5zdZfK4mLDnbu8qo+IeQb2dtbjiftXCT7tiGUyv8M72uZ8AHeH29tC5z00PoqJNlg9K/X7G4gr+LH4Q6Lge5B8gfmdldIU7yr70Y2gHh8q+v+z79DsWFl8YvbIvR78Wnx7Nvmz5y/RU9BR1PR8nHjOQm6CHRLvoDy3830Xf5lb95xYqa5lew4jQRHUt0x9b3DnTn2JE+DPBXuXuker8QZbpGxa9ggHhm3L3W3K3YYkiF/rTP7Hojyy6nb4mHF8Xjq8yB32F+1xMSzAQeGitf2TRHmTik8xdZbTkVyw6CNZd8kBPTiR9Okp1i3bjabdLkbtEWE/OKelJ+mMMdq9afAD5LWH7urC9ptlQv/z6dBdeG7L9mfB/U/i/JvzfFv7+pmA46KCH8WXwb9ndgTVhcyOOFnbATQlMC/yjyt5uf/Ioe2/HLqR/lG0+YMzRFWMOsUSg2ey1MHIRB8JsZoSIXEczzD6bvW5T4BtF2V7sFtMTwDzvCnrWU27CPg1ib99dLyb33/GUOw7Nir5b7IIn8Ndge9bT4rl3FPo4o6yPw5Yu0Bi3Tup9ggUs+cM74qvC9mz4nxqDpsQYjYtKpDdxEr4mE2xcJfobijciZaMyLMCdz6C2ULITlMzq4Wqv9jbzL6+UfZrfs+4ft77zxU88dd3LL+15dcfpRz/t/xvMd85mP20ZX2eR9u75mf9+8ZWpzz/PufpvL6v5Pf6f/I//9+b9v7NIEXlsOvuyBSOg6lH4s6Gdvs8GPGz2NQT1jdjWWNsaWuozwxnXViTp0AwnHZrhpEMznHRohpMOzXDSoRlOOjTDSYdmOOnQDCcdmuGkQzOcdGiGkw7NcNKhGU46NMNJh2Y4acMMJ22Y4aQNM5y0YYaTjsxwsPVqseK9t5Bzp7Dbpr2+sG4/9LISgWXOWORA25YY2KOwzBkzwSyHNUhEoAXLHCuyzBmPTJtCy5xEn2VOAg5c4XWb0m/wO8Kd2ex17oK9RAn+zTgrfjOL+LoOfjOj9mkQfb+ZRfnNOPjNjMFRrHErEpHdPyR0jTj6t0MJbuOBNpv49XLe8M6i77MxmJ2DN1r8eiwa08aY+PU4NIpfT/hM8aULd9Nti30r22FB7mKGFjgyq/jFUfP6R7TT/BEtDv4RLa74Ec3TTvNHtLjyR7QY/YgW+39E/ho7Q1lWAnIk0s8mysLThjSSwK40G3ze+oXgvpC9NYeBerJei5GCgbQZKRpIh5EovE8WbpcQMaiBMrt81wj1k/VqFwMyIv1kPX8GUBToJ+uVGGkYSJGRuoEUGKkZSJ6RqoFUGDFi/GS97jYW6XLj+a05fs9tUb4mI3kDaTASxffJenVGugZSY6RjIG1GjOA+WfFXZcb2yXrFRX637ca7MVIzkDwjVQPpLfDnNJAuI76BlDiXEdUn67V3sUjXGc9v/HGMX26n8XICdQ2oJlDHgKoCtQ2oIlDLgJoCGUF9sl6pwZgZ1Cfr5b/FoBHUJ+v1vslYxcS6gvkm1hGsZGJtwYomVpBnmEF9sl6zKRJ+25Sm9h1539eM3FXB2iZWEaxlYr5gTRMrCdYwsbpgZlCfrNjpOX1BfQKL1azYMmfFljkrtsxZsWXOii1zVuKlZr2lE2Jty8B+uRyUy2G5HJHLKbk8J5e8JdeCvhb1taSvusCmTjb0ta6vNX2t6mslKM7WxetrT+Ndfe3oazsoT/PV9LWqrxV99fW1ZFN2oCVxAzfm+UiOry3LYIRBWcDoW8JwXC5zBHfB3Hl6sXCDepVF8ARbBBsTuQWYwU2fUOnNMS/pjmkfesl97LcrTY52schHDywfhngcR9kwYW7qVM+Bb8OWTvlxtZcPGDnVSKh9fKTKqW5S3cgHpmmJK4rDgZv5RBRAfVgcffKRJ4COeP48wGeaAIojDNzBNZSWAJQA7uaT2rTEfQRwDx/FAiisY+B+PmsFUOUZhHoLH6YCEJek6mE+LQWQn2DgGB+HAqhMMvAUfyAAzQ0MPM163AB67FdOvU1H80sgaDuAd1uLTluQBjtfVO+xFp2OLb4dMY312W8pOzJll6ZYzbF/05vp5rJPt9AtZXFvegfdIfs/d2P/5R66p+zT/XR/md5CbynTw/QwZz1Gx8r0FD1VpqfpaSzs30ZvK9O7seVSxs7Le2QTyVfzfW5C02hFWUrLj5O/VUwtnhGnDWkcnN9E82Jkjpn3WXNhuuDDo+QYjkjGvHWYg7AG9sRJdyKYvXP7WcR03x1xlrAZJH7wokUEvHlOnISyNHyhjoS61Yl+veoEjcDdpXFzdKX3O1lKaKVriE4jcFBmG67uBNXe9Riyl2gELzDiTRgq1xP7RhzYdsl0AK+DYdmdkuHRdWWYcpUMFO4W3Ue7m3X36E7zbJBGQg9y7Ekv4+BnCIeAo17iZjV2AyW85I3wwiaSsbc+eS/uvDLELAlhie6ShNWtWpoh/gYMLRsLEidyWjfqJW9j13ajMg2XLnJC282PBd4QacK407RzasRI9xyYykdpPw57ekmPhx4V7ZAaCamxyN9iSI2TG+ZwwxxumMMNc7hhDhXmUGEOFeZQYQ4V5tgS5tgS5tgS5tgS5tgS5tgc5tgc5tgc5tgc5tgc5pgOc0yHOabDHNNhjung22prQKO98i8ie/MmciQOKeDmNLYHFtxFdqB+VJQbakdh5sxt4CjW/bxhsEgLyzS/zKuDAbsCi8G+ANapcEXC7kh4vbrWidmWnRmcz5qxP3l0aEkGGcVODhZEm0NrWUPZQjQvtJIbtDFEN0MryEFdQ3Q3tHJdX6wNrZsHb/kmNiPYcRObE+yUiS0I9pyJLWlnDJYJ7pdX4JP3EXYnM8L+9dibXoJi8mtV7LlezcOunQcdsYCGyf2aIJlFsh4mU0gWwmSs33bvReOgc5HmafHhaVmAhe5FdQck0V/Iye5c9Wn1l1vjZCKvuHuxR4JvYzpxdA/AXmrNCWVvjklzctMUU5bXvSCnRnBifzeNQNvgHlxi7v26LqBFixApYUHZ3UjKJEBXBLuslkpgR8hSAe5OjLVrtJ/voE4VOzIWH8IJr7dZO/xmP9biS5j9Z4O8RRxhg7wDfgHiORlHz89lb4FPgKGcRvlv9lb4SrDQt8/wmn8eg+LCuUGRdmJM3NtvoLpwhvax2lvcF6VYNQ+/1fM484BSq8BNhvcCvpkV34Z8UZgFvA/wHbwBJXCd4RsB38L6bgLXGL6Z5ldYgYomna9uOavmaWdZ1FjmaW9ZlFTmaV9ZVFDm6cay6JegEDSMA+LU/Jazvnugr5XAbwO65TB0Cx0I7Q9efgkPGgncXNvQXVYj1AdVVkE0L8p8ZZ6z6WQXyW6Y7CHZC5N5u8wTNp0sIFkIk0Ukiza8RLzBw2rgqIGjvlrCxmqouRpqvUHRbRTdRtGd1Zm6q6HeaijvDC664JTZcM9mr+0rMpVWQ/5qqPIGRVdRdBVF11Znqq+GGquh5hsU3ULRLRTdXp2psxrqroZ6KyHHq2dyNG8cwiwIXMtob+aOV43ISkT6EVmKyCJKo7t12QVO3aNTeU7dr1O9YZm8BTtp8DeCTmfEa52f0/2DJf0D+uT5s9LL5i8U89MQqBAD2RBoilrVVAj0FAOkAa3OFTg/W6e9ABXXIBDtG2zGa68l7LXpzFGOB+lwIMjAvdQEl+JwIMjQpZVBd00XWH8bg6qrH2dV12DTrAlfKoiO3b4gR/PZXWAEJOvCvKzKeazgfXU5ZUjoU4aEPmUIRdW2KtZmvG/eCh4Az0fGI2wJ0rd4JlzNRp2RjSAO8Ayv5rlHY1MOdHCJqDlNrUJoBWLJnN3io4Qc5C0hDFViu/1RXC04191uF5nebn9QsBKwqBeqoMuCoZNXtVa16NpqqL4aaqyGmquh1mqovRrqrIa6KyHLK8BB8owdw4FBktIz9pBKoR0nEWcI+/lJCtIwVjlspI+UsbcfpY+XsVUQpU+Vsc8fpZ8rY7c/SudRX3nLQApACiZSBFI0kRKQkon4QHwTCb5EhFSBVE2kBqRmInUgdRNpAGmYSBNI00RaQFom0gbSNpFgqIuQYLSLkGDAM+pHj3lG/ehh7w0+WDAMGpUFpGQiPhDfRCpAKiZSBVI1kWD4NCoLSN1EGkAaJtIE0jSRFpCWiQSjp1FZQDom0gXSNZEekJ6J5DHo5B2zsvTgaTQmIEUTKQEpmYgPxDeRCpCKiQRjp1E/QGomUgdSN5EGkIbz/3H3NjByZdeZ2Pup/+qqrv7vZrPJex85EinOSG3LHnb1kOx+4+GQo5FmZyVYoqNNxDGZaLaGwHJGskVJI7Fke5GyETgVrIGtGdur169toIwESSGbALXBBioEgVHraONSvEBqgw1S1njthryb1AbGopB4rcx3znnv3ddkU+NNNghCAv3u/e59t+479//c83O88YoRsZA8wgsREq2jCTIBMjGRIyBHJjIFMjWRGZCZiTQzIFbGQFpAWibSBtI2kQ6QjokEQAIT6QLpmkgPSM9E+kD6JjIAMjCRIZChiYyAjExkDGRsIhMgExM5AnJkIlMgUxOZAZmZSDML+mRN+gBpmUgbSNtEOkA6WezDbDoAWfpN7NNsll/X17B6g/XBxxeHxLHn+dziYPHzlvnk4vgzS3wHvYxZ22p463x6cfwjSxwJvYJZ32JfPnSYgT2zpxD5LFYNq+GdR+RzWFWshrdJJ7D3V539N7xzCH8BHgZZMU7feX/N2m7QPKLvKieRn2FO8IG3wydc762Ql7oLLE5fUHI6976EhLssh55ntG17d4HeYfQcox3buwP0C4xuMhrY3hdC2nQRep7Rru19PqSNGaFPMdqzvc+FtHkj1GO0b3ufBfppRjWjA9v7NNBXGF1ndGh7rwD9JKMrjI5s75NAX2Z0mdGx7b0c0nEpYNMaO+zIznsppOMU++xg9Mj2boR03Ar4tn2HXdt5L9KVJaMVRme2dw3omyK7r66punF4v0xrpS1nt/sUukHrqy1nt9sUepnWZJs+pk4OSPGx7IMUxAB7wpad7g6FsMvdphB2uBco9AU6KdrUWOxPE43JsuuX1ZdCFo6/rN4KIy1YfZHcA+s5MZ1S9C29DXbAv7Te8DJkP4X8lDxNnN2IOXtF78LciruvrqjdUO/6tt6ImbNVtQHm7CkwZ88mtjBUVRXV2YT/WlUFdSqVeCpJ3A0Cvas2wJzdEGZXhq3/FQznJLvkRFtw9bQBxp4eiHFZiDmqu4/4JnH2oxIyYMvWXsZFeMbvnBFA5Wq3EN9qqLloV0zOPPUpzqbP+pauuvuq6jtf1hvqrKqydEuBVC92sW50bH0Fz7atr+LZsvU+nk1bX8fzgb6Hx33ouBegevEZPG7rL+JxS38Fj1f1Azxu6q/isa+/hseO/joe2/ptPC7ob+Ch9DfxWNcP8SC99gLYN79CT0v/qi0eaE6potpgquXYxQ7PHSQeildYFhSFqCZD6+ohPZX6Jt0g4FchdYpKqLc58w4EUlFH9TV63lRf5bsIfIV6QNgt9RXOfBuSrvhmiL2CBiTgypkfqHshk0ldD5luitxoEikhuku0hXAvERvCtJEJLVMJQ1URqUokc8ltn9FX8Oyd11fxbJ3R+3h2z+vreDbP6Ht4BufRIplL7mxLfwbPznn9RTynW/orVNB5/QDPoy39VSrovP4anpMt/XUq6Lx+G8/xlv4GlXNOfxPP0ZZ+SOWcI9P4l9zhFpoHJZ2D1YHMJXewBasDKOscrA5kLrn9LVgdQGnnYHUA9d/S16i4c/pFqv+WvkGlndMvUf239MtU1jn9SUXO3C26k/F26WO2qNRzB5i6EOHT2a56WX2SsECwmtpVN9RLhHUFW1e7cNlFWE8wpXYhT/wbNqF9QS+oXdg8f5fRgaDbahcWz3+V0aGgO2pXPVRNBkcC7qtd9Q31TcLGgt1Uu+rr6m3CJoK9qnbVV9XXCDsS7JbaVV9RDwibCnZb7cJnDGEzwV5Xu+qe+hb/cPMMg/fVrtpX1wlrCfZA7aor6iph7TMq48/WyBNalmcGVVdzNIOh8TdQ1kYEFghsAWzFYI3ANsB2DK4T2AHYiUFFYPcU2iD+oQsE9gD2YnCbwD7AfgzuEDgAOIjBfQJHmyD2ZgTeJHAMcByDrxI4ATiJwVsEHgE8isHbBM5Og7inI/B1JsgWCLIVgfeZIABbMfiACQKwveVbtK5s4OKpKvN0wzuFK1avoOoqp6q8XhQitrjM5RsymdHWrKjq0k6SuxjlPoW7WUrP0azd8M4ey1GgnV5SwtlHSpitJyWA2/hoCZ0fUUJwquGdkhLAMJNankpKwD701PGviNM3MLvFyySPcjQBXBzM3oyGJqYDuEIIvhSNKkwUX8bg+3I0LjAj/RxGys9FkwFaDV4Tmm9FgxmdEOV0vxSNRHQhlDP6cjSW8OsoZ/Zz0QSChkY5rbei4Y9+i3J6X4pGL3odyhl/ORp++PWfx6//fDTpoG+gnPZb0YSBro5y+l+KRjw6KsqZfDkasvh1lNP6+WSx75/jxR59TGX88SJ4ZE3mkWV4eiTV/QxPvXW3tcLh8Vbd7a1yeLZVd8drHA62SK8/w5N33W1L/slW3e1L/uaZujuR/N0tUvrP8PRfdzuS/2ir7g4kf+tM3T2S/L0tsgiQ4fWj7gaSf7pVd4eSv32m7k7X8HUV+Ub+NNrD9OcavJNJ9jHDsnAJM/4oCY6T4DQJzpJgcy4OdpJgkAS7cZAkXcrvP03vtGXGj47hE8Hbc2m8dSzem4tPNppWsuk8r9tH87xuj6uybo+qvG4Pq7xuD6q8bo8Wed0eLvK6PVjkdbu/yOt2d4HX7WCB1+3OAq/b7QVet5s1Wbdn8/pXbHOK6pcbDVVXVd4cNrxTrNezSyO1Cn5lQXLRnHCK9Sji2aCKc10xynGWc4zdUJ1NZji0YxWJZy9xE2zJnODtqq+EB4IUCLmivhgjLEFzVX0mPFBVOnNWOYXwfWy8DpJfKKCmtBvcVffCA3VFXQ8P1FVsCQ/UPvaDRuaikfkhZf4mZf4G5X3bzFo1sn6dsn6Nsn6Vsj6Is5Ypa5Up0MyGqnpsvstgc88ZNyLLcby/z/j9EljPlOhh8aN1zbtCq453PaQVzdullcm7Gh4QgH0KFiBvn6K3vF18MYWxWbkaqitq/30gkCts5OESqNyalHufyy3E5d7kctel3AdGua+my32Xr8KRiYuggrel4BoXfCEu+HUueEcKXjcKvn+8wjUud51LuMIE4HK3udybcbkFLveWlLtjlFt7pMLrXPAFfoMKvi0F73tC0KjgHSUk54JvGgWr4xXe53JvcglUriXl3vaEoFG5t5SQnMt93Sh3/5EK3+SCX+ciqGAlBVueEDQq+IESknPBBaPg28cr/CqXW+ASrjABuFzlCUGjcteVkJzLvWCUaz1S4VtcsOI2u8IEuR73UepyV42OShTaj1vgukH8dMGKC97nIq4wQa7HnZS63FWjpxKF9uMmuG5QP0WJC1zubS7hChPketxHqctdNToqUWg/boHrBvHTFd7mgi0u4gpT4HrcSYk+V42eShTYj5vgukH9VIV3uNxtfuEK96HrcR+l771qdFSi1348i1w3JhCjXO/Ku+DuOEw+HhfSi6SbXo1IGvXVq0yyezKRXFW78Rxy9f2Tr7qOmZiq/DqXe1/GhfQi6aVXI5JGXfUqU+yezCNJua+ny33Xuw4mlcMETHou5gYZCEyje3Fv3WcqvH9o59/YV8k0so/z+y6tK6DHLlhhdAWIVeiqHJQoJ3ao7/9GwD/sSLtxlwwPAu/KIc+5tCdFpMCRGkUwuV2lkGJ4nSLrHLlAkQsc2aYIOtI+hfYZ3qHIDkduUuQmR16lyKscuUWRWxy5TZHbbHjtqnJwMDzkT7xOoftxtV5XGb9dNFQVcNi5GJ0TI7OkAvI5MTJMKiCfEyPTpALyOTEyKlp/V3+e4hVhJXQrwkoIKsJK6FSEldCuCCuhVRFWQrPCrITZHLMSpnPMSjiaY1bCZI5ZCeM5sBJg0FR/gXZQc/oO7aDm9F3aQc3pN+l6fZuv1wvkdZL45m+pArmVPMts7wJ5j3ya2d4Fci1JFqJ2cejaonXbApuG3IUVyJ3pRfIvmSHDNl+iX7P1Z+lTbf05+nZb16k2YLRlVMHvnml4HyUdoGmegNHZhvcxAtoFAmaq4f0EAT0GAq/hfZyAEQPDcw3vJ7kMBnpnGt6zBMy40PHZhpcloMM5mrrhlQjoM9D1+Iqg7o4ZGJ3ja4K6O2Ogf4avCupwGApgcpavC+rw+gmgpfnKoO4OpB4eXxvU3QkD43N8dVB3m0UCBmf4+qAOl6MAjs7yjUYdfkMBtDXfKdTdodTDa9DFApkLpnqc49uFutsqgvURwHjSLlSBfomZUGVhnpV5Ex6UeRPeKcsmvF3mTXirzJvwZpk34bMSb8KnJd6EH5WEeVbiTfi4xJvwUYk34cMSb8IHJd6E90uaXDvAQfgpP/tlb4M7C3aN38DZJd9QGw1vg5YVaNJv0J4qDNRnEKx5kKfeRxBbCZIyrKpvqt1QfU0h1xdJ4Pq6usr2fqrqIdK+TmlfobR7nAZvmk1wH9XblPiAEr9lcyqO+Di/i/cQrhdV1A+icxi6eMR0nuYbtZ9RF9XnGa/9WyqjjC5sdF6j2xod1uiqRic1uqfRMY0uaXRGoxsaHdDoekanM7qb0dGMLmZ0LqNbxR0q+nY+sMq3R8e778Qk+LT6XKD31Svqs4G+frzNC9TkX3i0yW8kTf7rdtLmv2Ifa/Q7aLuXqO1+w6bG+1U7afa7SH2ZUq9R4jt20u5vIvGTlPgiJb57UrNDrvKjVFv9MWE6TPMNr0rXA/dwvGnbGDFVuh/4DJ5NW38Rzwf6K3jc1w/weF1/FY/b+mt43NJfx+NVeIHF9cA38NjX38RjRz/EYxuH1SruB17BQ+lP47GuP4tHTX8Oj4K+TCcsvePuq4+qDZKEqqovqo+pDTLUdIqE/EP1GZzHsIehHn6KtngwkXFKKEqSuVX1NYj+fxUcefUADPqvKE7jMVYP1TcoDQNGfV3SQOxPI+0VSmsSZ/+hJILYO6RPQImfQ9pnJS0+EzKtCySdW+WFITk3FvxpBPdS8CyC+ym4eV7gQQpuRfAwBbcjeJSCOxE8TsFBBE9ScDeCj1JwL4KnKbgfwbMUPIjgpmPCwwhupeBRBLdT8DiCOyl4EsFBCj6K4G4KnkZwLwXPIrifgptPRfROwa0IHqbgdgSPUnAngscpOIjgSQruRvCRAT+t9nm3Ce0bS51V1/GYU79o823wW+RS1pKp6yLv7WpPq6fV08J67doH8X7V4v52wEWdFaDPwBxvoqmPHXDpRQGGDGyjY2+nXKcSXy/xnIqmK7LrVDRXkdVw0ERFdp6KChXZeyqqUmT3qahEkf2n4ueL7EAVP1xkD6ogbZFdqIKcRfahChIW2YkqyFZkL6romkV2o4ruWGQ/quiCJXakim5XYk+qqG9JPKnS7lc8qdKmVzyp0l5XPKnSFpcEw3LMAJfLFsyp7X9JjlVttrUsimtLuMJ1nrGWoYBAGnmuaOSJRt1UnkfynMhzjKfwGY/2LqNnsfQ/bsVt0X7L0aW4HWks2SmNJVs7j9dYmmeNpWVciq+LetElkkOwxZkDnQbmTQUmSlx+osYS1N9Je0rZhsYSo6bGUqyjRC5kWSB15UbFwb0v6UZFVu4pXmBzggHJ1RFSIyuWTkACXYSsk0nBTECSRIQo0uDL4kIhy8gF0veDD/dZjpFtMkyIn+oWoFyIi2hIG/zAYk91VPMSuQauvZzZj1TD5o+phu0oh6QP6mon1Du+rZdjQttqGYReYUIn0gc2aRfFtIQjoZVU4kqSuBMEekctg9DLsT+O5sdF+EB0w3bYHwfBon/F2EmyBzvEm0yUxajU/hpZod3EtYNv63Mu9GuK/uo98JNtIQXxZ3fSZrfoVWU3EhmfnUO+9156uWKx0AabItR5yVz0e/a9htakpHZOO6pIktD8G9wrCpSFVnpT48/QAYUuiSq+hJ/QNtSR3jRVSaLCCgmtad8YHugdldd2mQwNuPtqJ/nZlXvSTHQeij5MCqAjUXiA3WmXDbxSUWLDwGHtF34l+k3sEkAKVpbS86qg7RTZy+ocEs6l5EBUyZ9UoJ1X8jv5hn7Kt/QKEWdaa0gzu2qFz7Q2HUaXa6/AQck8eeA8h4JElblEjrWX+d3ap8QNS478pMyj68+LGxaCeoB6AjXz5LYHUF+gFkEDQAOB2gQNAQ0F6hA0AjQSKCBoDGgsUJegCaCJQD2CjgAdCdQnaApoKtCAoBmgmUBDgppwgdGsMTQiqAWoJdCYoDagtkATgjqAOgIdERQACgSaEtQF1BVoRlAPUE+gZoEqDKgvUIugAaCBQG2ChoCGAnUIGgEaCRQQNAY0FqhL0ATQRKAeQUeAjmpwa5PDfYZNXI5zovVe8ic5tlsCPkY+Rsc5zEk2MUF0jI5yWB5sYoCcj1Cojp1ueJsUH+ZUSS0T74NcMBXo3CaScCXMzuuJ/5IS5ubYnwnVViX34/QNFpED8zKVTP2UlfOh9JUjV6xrDVrc4BQeIvLsFP6csiOn8HkEW+If3o6cwp9HMHIKb0dO4ZfVU5Huf1F50TBZwehbSe1s7GNO4d3YKbwbO4V3Y6fwbuwU3o2dwruxU3g3dgrvxk7h3dgpvBs7hXdjp/Bu7BTejZ3Cu7FTeDd2Cu/GTuFdwym8aziFdw2n8K7hFN5NnMKXIqfwOdbWzJpLnGj+lhOdvhP0L0628lQ2jcmIKmCiY6aT1SQywLLHjuh958VNfS22ApXzrU9WUEn7TQ0NO/vFzEPfyqocjNbAmUVimYZt9eRi606LYKsuGlZocmSfxjnRPk0O9mly0dw+Lxsc2KfJqSJbd8pFFgYmbMQ6bZfGFWXXtJWnF8VAzY1/DQM1L6pr6kZ48JexTANbB73XsAipywdBGSYtSBXmvKXq+rKzrxaIzJBFY2tP+LLLalWd5sa75HZfC7wdVLrzvSyt9RY2Fp3vZdUStkfWBSf4vayHUflnZqvX6sryu7+XbVA2f2SxXQ1/xtDYavgBDULIPF5+J95QTB/eVUn4zlssE5FTC9BqtRJNrTj0GuReC49LeBMptRNT1k9MUSemXDgxZfvElJ0TU/ZPTLl5YsqrJ6bcOjHl9okpr5+Ycv/ElAcnphjKyseTWicntU9O6pycFDw+iQ4UYNLt61wZy9jYgv4wrV80M9DcgZ1+ztlXDvrzCf3qZzmpcHJS7eSk9ZOT1ElJ8D3kpj9M7/CEbSB1ns4N5BpPLQbyIi8FBnKDlgkDeIlWEAN4mRYXA/gkrTsG8AotSQbwaVqtDOCztJAZwOdojTOAz9NcaABfoJXRAO7QomkAd2k9NYA3aak1gLdoFTaAL9ECbQC/SHbDjFbWv2T7dqxCTwuEkyY9mQZh90EGiJmdXQkZ4LUAShjpNlAvBlDGSDeDuhFo0uU2WkK9FGhS5DYaQ70caNLiNtpDfTLQpKttNIl6BVrVTqpV1KcDTareRsOATf1Zuks0sM8Fmrx1Gc2jPh9AmSPVQuoLAZQ6Uo2k7gRQ7ki1k7obQMkj1VTqzQC6KqnWUm8F+i26LDWwLwX6S3SbamC/aNPVjpNqN/VLNl30iCY5M1h/yTYWg1+0zYniS2bkLTPyphm5a0bumJEvmJHPm5HPmZHPmpFPm5FXzMgnzcjLZuQlM3LDjLxoRq6ZkboZ2TEiNKth6/xIpz7W9451k2MtmiY9RNkNOpNmajpz81j8Vjq6nY4WTir6TXbFk87dOha/nY7upKO1J5bdP1ZW+1j89XR0Px1df2LZg2NldY7F76ejN9NRdWLZvJr1C9iLFnkvilaO92keeY7pwpDnGrw6Btj4dV/DYviHFuwsWs7b2Kv91veyHix6YhP6XlbvKDIKaal6HXFV5xXHKnswCHpZ7dzd5AQLb3Tfy3pAL6udO56ziecBsh0oZ7MW2onJd5hErCO7s+88JCMt1jPWn38/W3Us2y0ry2+9l23QD/vt97KNMnEFy2rB76CyjrOv1i44Fuo7/T7GuFp7xlqnvaf/MPlmaIOTojZOCc86f/Z9VHOJ3RvPUGe/+UfYbEaOjS2/JfGWxNsSb0u8I/GOxAOJBxLvSrwr8Z7EexLvS7wv8YHEBxIfSnwo8ZHERxIfS3ws8YnEJxI/kvhR3iM+qhXbLji9f1h3++9lE7M4tm99IrOvFvx3/5C2QAv+OwjUEvr5vwEgJ1t4veZbeoHo6Z32nTewOqIh1Jpa8J0vN/yRGIB1pMet4uSgTqN5Vqkpchcc60bFol+vVB3bypfV6jPWO6+p2jOWdaNiz+UIePc1VXzGsl6sZNHkdsNbUPZNdGnbz32iQt3RphPlb30vi894peKadbTRcWzffsNbwLEvhzLe1BXyiSSnkTWqrF71bb3gW/q0u88/5KgFZas1tcqfFB9WaOQAth+B72x6/Ibzwd/QNspv6AV1GqfH04p94FXQg7kCXEHvL1UP8CvRGrbZGsZ7GLd3r1ds2CJF2Lus1lTUWDQ5eDKkvToOhAe1ENp39KQRq+s0snkL/YdWA5OCRaVRSC2gBkLhBaMaHgarXqWO8s8QX7jgWM86+NZVPCy+lvAH70W91+y0Vlkt4eqZLkzi3ivzhWvZDk0Y9i7iyqKLku9n1RbMCs1Rbb6XBVfAlZO/9Yz1r76f1WtImn0/qxfUlqLKbKktH/6TM1QfMWZ7tqFQzTW1VdtBjgvOHF1HoGxbSkfXnKNKOMcqQZNiGzPNJbf1XvburvUXj6ua82+2ag58h68xzX74/WzFiub5BZoxeaK/rBZgDfjteEnJ8rBZdWhovEjWFRcwsmhQOTQX2DyMFA+ft7zTakEtKVupx3RbKPMqpZYeSbi76fE7px9959qJ7+glXKeoy9Q51TUJ6Ho0sGA92HMjlvtq5m2pGlfZ+0vWMPVrWVUvv/APv4t//2wvBMvEuuQ2abG0yK0Zam1zOelh6MkSTCOrTswStnSVfYNsav8r+2XinyzFwwHcz2hPN9uLN3EfGtzdvKPX0Odc6XNqbRe95wkjILIl85fqXVQv68bjOhmXrOxPZJKuC0agb2mFxKPvZ30L8zX6im/pJcPI+jnLn1hveKfPwzqh5dncIRVM/NlkVfS9LPraaXyDUqfZdONptqt6mu2q2jzjryrlW5/03Ou4f5OOvsRbn9XHtQFaQO+oJY17nVVa7MCl4uWCW95zTphBd+6ggpZew6Qn7zlfbiiHZjHf/oR21IK2lEOdjjKsUYYlZFgC5ZaUorn+9AWnoBfK1CP7mPewJESt7hEjoP9eNrnV2lT8RQuP6VUO9SH3Bssu9d7L0ub7NdjTA/2C72XBIGXuwoD2gc33skFyRbefHA72727qHVx1Yoo/29BLvhUT6nE/vUp0iQ4aCjdlqxFfFhrn1C02D4huS9Fio1ZrlzAYqf94q0a7YOSs0kJM1Yb6uqw/uK2mTqJVWSkQu+HR/iVpBiwyC3G3oOtLmPXEKZ3ZwnU5s/vum7yZwcfhru0NL+e7f4VsY779Jtkcx7evos/St0dfq5TifnBAe2ck2G+dnOY8Ic09Ic3yMw2NvpJBX3F5+lqju2U7qoc/gtWGVbWK2WHngLd+Nl6T3dIavyafTV4QlmAIMWVGD82ceEFwjiX4ll41f9Nb8AdNG5affPtTGbTzAlXjkmtR8+yUKW9Mjh+d3cJEbalVTNSrMlFHYzf5WSspB3PjDjbF6XJ2Ykb3XeYFW+gDf/b9rLfgWzfppDt7L9ugLn1UEit/YG2it0Eu7UViZ2rctFi4x8aUcKHR4M5n3Cu/DWVkqhrG6Ygs674THCaDtAyuDnpww1v1W5t8O7/q9+hH0VqzbOjB3F0YRm3mWXKjZNNZge4TWmXQxfaP1ht6jeqia+csf78BU8bYH/rtTANT5lHuBu3FrGedTo6e1q/jGKgWnnWOcuClF8RmoeVPC2Kq0PKPCmKq0PInBbFPaPljDr4CAnPw08llPdvVgHHeg2/rz2OZK+gv4DGEmUX2e3qHpwqHDwUWSeEtQPYu5tbvvUbtUzF4ET9bsdWCKS9AmRIG/3d+FuuHrStYmxrPWB061TrcUGT9GLOcWkCHg7E61+Tjxc7l9h/u/xYfiBbIVCDnQlNITm8fJhPrqMrQPYALjuT2BCYt6+ra3U2yPXqIy44FyGvxJhnnX6ssvcJboD0HqrPEcqQu1VtVdq1OTtXUgnQ/MoW60IhZSdM9umyDsAqbdK4fHhgiFAbB7m6G2CJbqv7twzhHIZnBC/t3NhN8kOCDu5vU92LKBrAE4sL4pEctcFftsCDogvosDC1/PopfVvVDmHEmpqPZabFOnLP82hueBakmsbMSke48mfSG1ZKc+gLZdCYzz2TwORDjzzAGHZBpaDISHQTBt8MX/vx3/sX/8Kmfvb13aHSKpEfs3dn0rgV8UoGZ0TrKr6vLh/EPT/dU3cjN4xtOPuB8gzsbWrCAP7UgwGMdfxQFL+DPNlwd6Rt0b8NmaS/wpPFAv0SzIt19+kEO9tzIAN+L6iXYsbwRqGthXO/1pF3WzXZZT9pl/f12CV949x36txfWQltsDBLLBRJOGMgFEhO5s8mVZwbLpiEoBavmaiG6kbVEeMfya42oYca5mJ+4vm8ET67V8UrFzaqSIL3N5mN+CW0UBTEqxjDSsf8Gy7nZ/n9camCCwsTWpaCDXRD0Os9bvo1VfYurq8r/3HfmHlbfxlTV2sD3vPAvXn+v9V/O/uja3Qyd/fzRH2Rlo5ascHlnX/z8oF/GC1sWMUztyVHXn/4CLyl/Yb/pOy+S/xrbb/5isqxUypQ/Xs0+2Cvi7wcXw15OZXkRzvOVaPTjTrqkG+THxDleUiXpyhWz4yfGaw07tnc3dRWNPT2BWIN+OSaWuQGoxC6SEtIZqWkqHksQG98mUSd/knuUQtM/yT2BqB/klQ9G1FRJEVGPlXQiUVVVVVRVyIhl8xFCvk2E7P3mwv8bhBx9d+5Rqky+O/cEQn6QVz4YIVMlRYQ8VtKPJGRWVeMT8ndCw70pmA3f2pCZ5R/sHXonFBV6FWxJ/mmW91DWJXfW3Ai8ah1P8G2/tQFmHTINf6/MmUiIyJsXRi4y5ChD/z9bEPv6lKHCckfz+DC0dXMDvPGqmufZtaYqqnZ306sdePNcocFbA5UE727KT6iqqh141SRP1cwjNUUNagfRVyJXxcxV4ZJg6p+r4GU3+etQL5WlLaSq3NlU9hu++3P+9I+y9xr+hMmCPZHf/GUiBCkpVhNaQhrjWxvv1kL7IKbrz+wbwTubqkpGYbAhy+I0vsoGtZnURH7QkMoVgiMMslVAKw/PKp44nukaCEqheVgdXcU+qMoI5ZxXNdNktFdhDUm/t9rwMnhXNCZrFOqCm3pUbXi22Jv3J9WGl48icGtfjiKjasObkwj5P6m+/zSsL0yrMGxXhdxqO1/7TRv8bCIbk9Dx26sNlRFBNsfvrDbgMEnM3FfqbrAKwfiLbnf1sttCvWYVlDWyyPSG44/zZK02J9FWHqfR8bc2YpEWqlUzz88Z2ppeetY5TcFZpfGsQ7qfePdZZ5mCTQRrnCHXALcFwWG18axTYEtoJbjgoukG5mXIU30lNpDNcjjxMpnhZdKCnWqSRMZ22pXDZLL0hGYJmX1VUpBgq9T+bXBzRn+Q1RlyD4a2zbxSsUkWW1fmrDLZJYMk9qNViBafuArBn2QbGtLU7rF6JLP1E+sx6JcfU49Cqh61R+sRzd1xPdrfLT++Hslk98R69H5z4TH1qEk9IlUJmBTPSW8vqzIN50O2VphPIrRDiyKOP12R67oEmj0KNVePQ2TQvUoxjAKydr5C0aMVdGa6g8171QNVOTxpK1HHgKmm/KdQQbOKqh7W8aBos0rRpvxMi6MtibY52pZoh6MdiQYcDSTa5WhXoj2O9iTa52hfogOODhCtil41j6bxahL+RxwerDaedUYcLjSedb4rWQAPV7nAcZ4KHOc5OuHoJI/RhrlJrKYSoWsqA9OpODsespVCSPIoia9zXEVxxfELUfwCx7ej+DbHd6L4Dsf3o/g+x29G8ZscfzWKv8rxW1H8FsdvR/HbHH89ir/O8ftR/D7HH0TxBxxv2hHQtBlpxUhLkHaMtO3o3BchHUGCGAkE6cZIV5BejPQE6cdIX5BBjAwEGcbI0FapBhrZqRYayQvj+IWxIJMYmQhyFCNHgkxjZCrILEZmgjSdmFiOECtGWoK0Y6QtSCdGOoIEMRII0o2RriC9GOkJ0o+RviCDGBkIMoyRoSCjGBkJMo6RsSCTGJkIchQjR4JMY2QqyCxGZoI03Zg+rtAnRlpuuvHabqrx2vJCJ36hI0gQI4Eg3RjpCtKLkZ4g/RjpCzKIkYEgwxgZCjKKkZEg4xgZCzKJkYkgRzFyJMg0RqaCzGJkJkgzExMrI8SKkZYg7RhpC9KJkY4gQYwEgnRjpCtIL0Z6gvRjpC/IIEYGggxjZJg5NvIy3HgZIZa8MCYzX0QsQSYxMhHkKEaOBJnGyFSQWYzMBGlmI6SZFWLFSEuQdoy0BenESEeQIEYCQbox0hWkFyM9Qfox0hdkECMDQYYxMhRkFCMjQcYxMhZkEiMTQY5i5EiQaYxMBZnFyEyQZi6mT07oEyMtQdox0hakEyOdHC+3usqrMPb1WJx1jddsSIJgKdeLvMLrJV749TLvB/QKbxP0Ku8evDVxwjPON+AROhZJstSaqrAZLYoX1CrHC0oW3RWOx+vtMsfj9XaJ4/F6u8jxeL1d4Hi83tY4Hq+38xyP19sqx2+qLPZ2Wb90g26GZhVUXBhsFdaOo2/Nq7Ug2Rm182o1SHZGnbxaCZKdUZBXy0GyM+rm1VKQ7Ix6ebUYJDujfl4tBMnOaJBXpEwk0WFekeKVREd5VQ1oZ5STQ0p0/vCH8w05qLBEPf3yKp0fB7lG7a9xG/dW9Tw2yn+aBVSDPfEaaa1dgj1Ayw9G5Ubtr0Hpsxbi7JfyAYRD4iW39csb3nzoLaj5UFVfKP2Ph/evlv72XugtUkOLJTKo73i2WsAenI9hHpxNRSo/lt8xDmczygtN+1roLYUqXVKXUpfwc/H7jj9Y4PIrKXS4wHnTaI9KmKc296qppNECMwYqx3+1KQlGrcFdaa02SHOv0NAFEGNfV89Z/iD/hudCb8ZDp2+AQ+Tsw7zFq8YO/Le/7UXH49ogJOMX3nwi3ffv4QhTSzxlqvlAVf9dgAUaSrVft1G2ykv7kpwMiBafXsK7uICdpw+tqnkwKJLtv7Hb3/TWDrxk/z/C7UdVyVFfr4OLNf+ut6Rqh95CrIdyTAmlquYPkGHxhAwH3nLqVLWoFhOHi+A16yVVeeGZnzr9p99/9tRe6K2oilrA/3SuF/7qs//o49db/3gv9FZDtWREF9QiVDAPDb7TqloA4i2oBTi6X1SLagUfhCsZkNOrEWFqJxOGRBvQ1VT1IGIHWZZ1x8tserW4cYhgNSJYDeUbZanMJgQ2XGqpbDQ4XRhLjRpOF82j2HVSyF3DRr/Arz2+qVml6tDbYNWzLI4ElUOvyvpnWZwIKoeeKKFlcSCoHHoLrImWxXmgcugtsjpaFseByqG3zDppWToNVA69JdZMy9JZoHLorbB+WpZOApVDb5W11LJ0DqgceqdYV21NzR9482ojJD2AgNXW5lWV4rcCVl6j6QSaBAGrsM2jRaBqELAi27xapPj9gNXZ5tUyxR8ErNQ2r5ZCVmcIRLVtXq2Eok0lCm7zajVktYhA1Nzm1amQVScCOrKsq8oB+JehBoerFmr0+oVQoy0XQ70AZ+OhXlQVtRTqZfjXDNFN1Wqo0T9PhXpVVdRGqDd8S+dJwYybiRY6GvpeRm0oV+VlCfEqZA6LZ5ssuVEgRlgKnRBaPYYeEVo7hk4JXTiGzghdPIZCfiBDC6mJtghdOoa2CV05hsJKcJaWapqu2AMD1su8X2IVSbVOR78Tu3Ax0u+CU6k86RbS7PnIuhVpgnlZ+qlk1hTvY7XoEu54yuzEFMztj0/pLp6U0lw6KWV8Ykpv+aSU1spJKZPHp9C6ga1U9QT9IMdvkn/gE5NbT05uPzm58+Tk4MnJ3Scn956c3H9y8uBJydm0xlEFgKlxVAVgahzNAzA1jmoATI2jBQCmxtEiAFPjaAmAqXG0DMDUOFpJ9+WQZJHBiszSQGG/bqb0fyXQFfQKU9ugGugqMFO7YT7Q88BMbYpaoMkkhqm8sRDoBfL7ZmCLgV4k53AGthToJfIgZ2DLgV4mIxwGthLolXSvDdVqoFeFQyqzwqqhIbJiqkYsm5ElM7JoRhbMSM2MzJuRqhmpHNN8wVZ6XhM3tD8ve995Pt905/l8E8zz+aYzz+eb9jyfb1rzfL5pzvP5ZlYlQTPcJF1yx9/awEo4q9LF0kRuTFbqbnOekCNBlutui5GpIEt1t83ITJDFutthpPkLjCzU3YCRliA1ss0ApC3IPJlmANIRpEqWGYAEglTIMAOUH7q/sBHr2CL6rY0GLjqG1cuse0Bxf1ptyHWI5Q8ZOjKgAUMTA+ozNDagHkMjA0J9VEV2/AhXReUC4egWD+Eah0EHtcBhUEktchg0VEui/oDwsqhGILwiahMIr4qKBsrJRichyx+2UDVwykXlQuLT6F2JzyQ+kXhTyoOIAmwHyGdNJVrg6EyiNY7i3gnRdbnVWoVTxf8lY3/kbeYC6hJzHnWZWZ9wdEOG1iosqlalE4eeZ8GUGjMKIfQI5qReZO6oXmKOrF5mMbcVOlbrVTr96jXmJep15l/qDWac6lPMtNWbLA13ms7eeouOyPoMsxv1WWZxasVsVa2Zr6s9lo05Rwd0fZ7O0fop5kjqDzEXVH+YOa/6ArN+9UVmN+uP0DFeXyLutn5asYdhz6XTPKuCeRlidYfkabbmZZktzdF1L8ecY44qL8/8XI5egLkL8khH0W2vyFxR9iRFlgZClVFPh4HKqo+Egcqpi2Gg8uoCHL6oD4eBKqoPhWQmDrnPI/dTlPsc5fYot6bcinKfZTt9yL2F3Gco92nKvUm5T1HuDcq9znb7kHsVudco9wrlXqbcS5R7kXIvsCE/5J5H7hrlrlLuCuWeo9xlyl2iG97yfzJnOw8VKzLzjbMt9ilYTZl/3xb7FKyEzN9ri30KCpF9CgqRfQrL339D2f7+G2apZKWCQmSlgkJkpYJCZKWCQmSlgkJkpYJCZKXC4k5BW3mLm5k28RYPBNq+W9y/aeNucbelrabFvZHuFyzuZHSzwNLUNt0piBA03SZYPF7oHsHiYUCXBhb3brousLjT0kWBxR2LrggsHqh0OWDx+KNrAa6/QxcCXH+HrgK4/g5dAnD9HWL/c/0dYvxz/R1i+XP9HWL2c/0dYvNz/R1i8HP9HWLtc/0dYupz/R1i53P9HWLkc/0dYuFz/R1i3nP9HWLbc/1dYthz/V1i1XP9XeLLc/1d4shz/V3ixXP9XeLCc/1d4r9z/V3ivHP9XeK5c/3dSEwS3Hbis3P9XeKwc/1d4q1z/V3iqnP9XeKnc/1d4qRz/TPgobPGyygD0zZ4Qi7GuV6J+lWGuOr8XRnip/N3ZYiTzt+VIR46f1eGuOf8XRnim/N3ZYhjzt+VIV45f1cGXHLaHEBnAL5yRxlWaWxl2NwOnomsgUurRI1Dhcs8Oi+6vcxl+a2LbjdzWepw0Q0yl6VuF91h5jI48hQeZC5LHS66/cxlqhu0o0aZshA2A248E6eTZeJ0smniTDLEn2eCZ4gzzwTPEE+eCZ4hbjwTPEt8eCZsljjwTNgseO8pInSyTISJEGFynAjbl8ngtXvRvXCZ7GC7F111mWxlu7Ryrj+eWPjIDvQb8WHDHH/YMJf+sCBLjH5u0Syx+LlFs8Tc5xbNElufWzRLDH1u0Syx8rmnZomJzwTNEvueCZclxj0TLksseyZclpj1TLgssemZcDli0DPhcsSaZ8LliCnPPTJH7Hiuf67uBhLu5upuV8K9XN3tSbifq7t9CQ9ydXeQmzfoP0QM7pVhvyjINiIb30S/Ya5c/q+2nKWHtbfPQWacnOrB8Uoh9pUyKDQ8J4pA3zgbRXpJpm4SDAqmb5VOwSHd4kHJW8azX/JWE9bgXarkiIX0wXMec3BFZRLZpuVDfnVYCsVC8LJaCcV877JaDckAsOVPkmKOomIctYw9GkVJBj8rL1vxuz282yzLCxak8bmYDL07i94dFugFvUolaKQNi/FbAw5CDr7PwXVsgzkICbYuB0H3gIObJLVV1Kd5fHRKcWFBSQozqLBKVIAoLVdHvn4tFPPH/FkdfMw4rhZMZOo1ocKkeAIV1iIqTPnFLXw2B88IFY6KCRUsrrd3mmTHcAcxI4mxeYzv6Ou8zcTIlwVOBKUxEbxTZlpb0phW3oaZ1pE0Jqm3bqYFksaU99bMtK6kcQN5K0YalHESq3bL6gy36Faol2Gxc1yQg0MGWhFytlD0qQO5brEgluU5KvWFI4JSHzYmKPU9E4JSn3FEUKr2U4JWUgQkqT/rEoxam7RjWDQ8UpSTlOkjKYGkzB5J6UpKs3g8pScprUdS+pLSPpaCRQhsy+yzTj9DsXaZtLzIvLYDsbeMykAfBWJvCPYzJPaG4FGBxN6Il8MqtWXwcWmUlMGGtMDGzhrfVG54eaAPSMoq+p4yGGsWMbVzxseUYRLPIt52wfiSMlweWcTiLibwoNzwStTjbbJNJ/Cw3PDYu7xNUl5RN4BDH7KMYJM8WNQVynCIbpEATMXoDuUG36OZhp0t/6gMi3sWicLMG92i3PBqNBHaqpbAszI0wCwShllI4OZcw1tk/VRYOYs70hzUzCySiFlKfDYVGp4bX++7Fxzc9XvEZOfteSDSQcRl5116IOJBxGbnzXog8kHEZ+c9eyACQmTHiLfugUgIuUQl2sEHIiLkEoVoIx+IjJBL1LETg68EDURUKBApIZeoQrv7gLb3BI1ESCgQ0SCXqEF7/UBkg1yiBG35AxEOckk4iHb+gUgHuSQdRAeAQMSDXBIPonNAIPJBLskH0XEgEAEhlwSE6FQQiISQSxJCdDgIRETIJREhOiMEIiPE2kF0VAhESMglISE6MQQiJeSSlBAdHAIRE3JJTIjOD4HICbkkJ0THiEAEhVwSFKLTREDHidiB2XQPmysaotFQ/W8zyVgdcBjBv59JBittiGmgJos7jdgUC5/ASBQyjaUY4IKxH640xgao0xgbjUxjLHuZxlhEM41VaDymsSoNxjQ2TyMxjdVoGKaxBRqDaWyRBmAaW6LRl8ZoDjw2Dkk6isdgmIxBOSiHyRCU43KYjEA5NIfJAJSjc5iMPzlAh8nwk2N0mIw+OUyHyeCTI3WYjD05WIfJ0JPjdZiMPDlkh8nAk6N2mIw7OXCHybCTY3eYjDo5fIfJoJMjeJiMOTmIh8mQk+N4mIw4OZSHyYCTo3mYjDc5oIfJcJNjepiMNjmsh8lgkyN7mIw1ObiHfHLH2Zj2j0cV9suiaU8ycGnzN62It/Q1mutd2kjOKnQ/QFtJHJtpH9msii912kmOXX0aE3xV3Nls0Szv6jNYe6vs70WfBXjkQl/f70CqHqAGOHW1R29U9DmsqFVZyGYuL2THh5endHB8GCp1Njg+XM+oreD4sD6tNoPjw/+U2giOTxPrau0YllUravUYBgOu51LYpMJjCUtspcHqdBm/U2jUPstnEL1Mc5hyOF/t35FLXFxp7tzzslCMGdCVoWTMckOFyT6CBUyQIUs+kXJpQRJJqKUSxknCeiphkiSoVMJRknAhlTBdwL6LErbDZNuVupElux/dqpf1d0jVZ7DRkC0kdiIlb1kEy4eMHxVUhIwYmUpOQceMztLohNFmMYUeMdpKo1NG2yZqkdjVs063yktIj3ZbvSpLPlncYPS3ytJPVg0+DaYFsNLfXbazD5n3wfx4YcX/f5DTSdrmTVIegJlYz8F5vEm36k4jNiSMC3Ev04BHHBOsPQ5cfxyoGijZScCcn214Of93LekT/79nfkj9c2Q+muufq7sjCY9zpKnK9c+RMjHXP1d3jyQ8zdVhEJ3rnyP3AFz/fB2KPVz/fB2SgFz/fB1igFz/fB0ygFz/fB0CgFz/fB3Sf1z/fB2if1z/fB1yf1z/fB1Cf1z/fB0Sf1z/fB3iflz/PCkvcP3zpLnA9c/XYaec658nZ0xc/zx5WOL6F8htkuW3Cuh8rULURyy/TUjbQDqEdAwkICQwkC4hXQPpEdIzkD4hfQMZEDJIEPreAjMX6Nhti0kCOT0RMjaQCSETAzki5MhApoRMDWRGyCz9u80iuYeisy1oUjRoQkjbQDqEdAwkICQwkC4hXQPpEdIzkD4hfQMZEDIwkCEhQwMZETIykDEhYwOZEDIxkCNCjgxkSsjUQGaEzAykWaLpqZQgLUJaBtImpG0gHUI6BhIQEhhIl5CugfQI6RlIn5C+gQwIGRjIkJChgYwIGRnImJBxKdXik1LdnZSYSxibCBHKEDI1kBkhMwNplokyZYMyhLQMpE1Iu5z63U657nbKzK0ATYz8XUK6BtIjpGcgfUL6BjIgZGAgQ0KGBjIhZFJO7uHHhIwTBEvmqHzZHRErHW6yYfEPrHoOphnqR+U6HGMTOwK0Mn5rRsjMQJpzRKs5g1aEtAykTUjbQDqEdCIkdZsQzDG3FDwSMvBS/n/wNiGYkwWyO1d3u3NEjnElJgcH0+TozdXd3hyahyrdNz5jQMjAQIaEDA1kRMjIQMaEjA1kQsjEQI4IOTKQKSFTA5kRMjOQZoUao2I0BiEtA2kT0jaQDiEdAwkICQykS0jXQHqE9AykT0jfQAaEDAxkSMjQQEaEjCLEvNcYV+heo0ff2ZtL32uMK+XyPz7lVN8uPmSDJStQdVaZZ2EripH18/QxZxqwg/qM1Sx7a2Tsi6cISOS98NP075/uhYbou1esu1PikG8ls8eJuYXyZ5Jp5UdkbZ1J5psfkbV9JpmIfkTWzplkhnpS1jhCg+yF1378p7c/8js/ReaACocshVFjJuz758aDEEWFj6VXmkxZ1uOwZM6LX3w89QyiZVnhw5KpMXlx+oQXW9GLF3geTb04e8KL7ejFbZ5uUy8+ls4GebOsa2LJfJy82DrxxWx0xuCZm94qQ+g1jBcPxI69RsdUGAz0lhse3dTBKJulIZwLf1yQl8kxO6lZZKdFOq+WVU5lD7ys8JmiBDpbqnycMEUC+dr08ngjEnP/Thh6WVz55fhFL2cYUiqorCrc2fSyKvcuR+5uqvyB5KjvHwZcfE4VA0OpIQvDovj5rDChgzwEjzMJX6y+/1tiDhSG9NjoTWQscbpFF1RF0stJRm6t7g5gUmG42ZBjH00jHFMyxXLsgkyvHNuWqZVjOzKtIhafA8vxbZzYvfkveGTEseDQyx6Qy5EMtVJGWmnJH2zC5lmWLLiFKseO02pMyzDwyJrvkj/bbKgcmQ/OfTs24xRSc6j8wTtBqLKHXj7RMcin9LjxexDdFgNjOESfVi409NbfCWI7JNNUnX/rO4ew2JA70HmVecaqeUtEyDz6II76m+Btb5bJZkUWTC+wmPqnG+IEUKFgRe/4zdPoOvTmcqwlE73Xx3uD+L0LxnutJ703wHvD+L1t4732k94b4r1R/N6O8V7nSe+N8N5Y3uOGN14NnvTqGK9O4p+8abzXPY2OTe9lHnlvcpqXHzJjlOHGEXsp1DjCmEr60ugU+hL1oGEhmiTekXd+Zy84VEtirO54wsE7PBDXTXsZBbUE23XeEiTP0B29nFpV68T1Miy0SHEqd+eRribmeJskwziORklmP+Tbt1bGy4YY5rRSGMlhGOi82FyMhnX3TIOGx5K/fa+BvjvI8owIf5BJsMdBUyON8HGSZZQEh4/mVnmeg+Ophc2bLaEjb8HAxxT2PiA8Kds+asgpNS9fEx6d9rKG6HMxmRzi8Zl9Bwsgv1N4h1SHSuGBl4szW4nlOpXZ9MqhiiWsm5gW3q8lXGSFqqyy4YFXQhDLShB828sdemWYzSmp3KE3pwoh7DzQFxdVEa8VKFvp0JtHPKsKKo+seSgsoTyvfKBKh95CeKBzKqvmQm9O5VUx9BYJL6GogpoPMTcsvF8ayRce6IJaVHMHuqjKqnagS2T1RZd5D6Y3XNgCjFcn6u5qGT6PyXZlOYxWGpVVG2rZ32kg3yny+WWmrZJ2CzqdKrKu6LJaiwuksgpmfiohbyL0bo7fNRu5HB3Yas9iul8n+WbZOcLFVG3X+lZZrbNpMkKsXVhRJg8iGuZ2f/DOL/zDv/Xf/f6vvXjZ7ZAhfMhCkWX7fTGR6y2xqfUlGB5dJuuqSz4s+ryU2X/hB/9BUP+Zaxd/lwyVuTAsuwQjpKvHEjBtnG1oWxYTW7mxCVGyXZwjyDGhPEG2CRUISuJFGodFWqyjRTur8vLM3dnUUEfIwD9ABhZJM2oVROMz18NnYX0f4WWyT5qYUBELnTAzZRRjoxg2WKeWifb+Q+3EBTHlOu/x5y5Fdlrw1RmyNB+V79mN2ChoynCy41uvwCCmyrC53kxk14qMOF9ny/Eu/5irndh4y1LUER6KkwBYp4Nt+VTjdt873trfy/LR4y++fyyFTH5D3Kl//J0WuR2wnrOP2wknm8xUnWcRUitkvRn2UJkQK2yreUWtRLaaxUaz61tqpbaDFDHO7EJuwpW+9wr5rxTzzHZk+9l5THlx63G5uKp6Qrk3iWQrNC7Kv7TkZB7mIDK2/YaXPY+WyP4NDRsqpb+hcyJYXoxst4vo4WueU81alu06kEz0B39ooUV1XkTKy3zPyBLwPRt6Os/bOMJnlbNrrRuLkSoexOaLE9DZVEVxofYHeyEmWlUytkqbSdiBESuxOvnqdwIoeM7FZ50X/vrWT3+q9nNnUWDozR0kr5XxYpkUz7P4oHde27UucvDd13atj5CBBLKKgGfWX2/UPq/KKcs62eebzQx/U5nK8enTHvNiWcHAtSJZO2QvcvbMCdmp5GYBPI2sKkHSO4sl2TqWlzJyic//+R/87t/+n/9Bp7t3mUp2TyqZW6OIX8il6uKeWPWcWXX+xKyaS8yE4v3HvRg54ILp6vjLS/xr1sm/VnFTarQVl6nRbCqugMUVqPzICsCoP39uiVtVO3En9I91whf6Z/7mn/7V/t/Zk450f4+7Bzpn0rVK1F2os9Ai66CfZFUOPecxFaCx4rJ59XdfowkspoN0GPsEOmBazht044zZuAMun0x25Vacv0xP+zfdgeacsvPQP+ZRDWa9Tvk0oU1PezZNkqfgR+JN2kO65OAkWmNjk4vFxD3I22/qwrGEyBaj+Ia0scJ2xcEw7bWAOY/B7MdgKaAIbz3kZi4DIwE5rKU5VRAbjLJ6Ru907eglesPGG7JSyZalGKub3ykbffL5/7Pb/69/7Z/8nf9dmiDDTf5B56a4JaWY/+ZHtWQ0yVxQ2Rdwelz+T39/L66Zcjaf3EOJdUfJTye/+Z/Tbz62V2bZ+n/2+Xf/7h9/952/+8f/hA4rNJwfndfm7PLxDfhoLzZPK4Ff22PaeDABT/sI5yXP3YQZ3Re93KY3d6CK0eDdO/SKxopjnIRe+D++2fj7X/5bryfFK3cz9IoHxrb+fcSrYHdMU2Ep/n1zETKWFlr5JNOX90KPrIu+uHmgS6nlh5yflsvJnORyg5dUtCw5H6DZLfjm0W4y4uf4Xde3bvyoQf+jZgdnnyahStoZOPWbVrM5SE9NlQ8wNfHUyXYP0UhYHdBy142pLupLv/ej+q8UhnUmLsi3X6w82gDFRz7A+UBTV/wTVN34N5wP9huZD7i+Zv1t7MJ+OeM4b+fA4G5XeBvGIgyxfKYA+7F0pohF3IxlM0U64tVYMlOEJG6ZbGERl7htYiI48bqJiQjFfRPbEQEIE9uPlL5M8CY588iTQnTeL91TOfaWnocDdgormxgCcK3ru5/KvE18ACernLIp+rIifnltCD2U5FgPa+0wxgJTmLZfuofViH0QkeIhXAXQKctVTqgd3zbqgVLgnyMTO4wnYYYohoN1RurKiXYSe39hCALtqDxM8EZVK6gMPo9LUA5LRGVU0YgLc4XsEGWJ80O8Tod4nTb5YxERnyzuatAVSk72YQEb8sDhrpCFZQXLbztkpzSr3ERAygODAAz6jsO9bWLzs2sbGWv7Scb7nL7DD0s58YR26DliuuUjxuRmY/YSxtPf21P2JpUU6iK1fcHfvueB1+tvY1VEW+RZ5s0QccqAN4DEfFq8Cly5CK+l8KEVv7CeShglCSqVwDY4KOGCYeyiAAoX/Jz4aYB1ZzofuS+89e9/6u4fOzf2QuWGxCCtMYlIPqkAu7whS81ZXlkRd8aNFwm8A0cEMO9Lzzl5lu5sgttSxqtlKnWbBxMokFFlVUKxpjUOyCdJSpGsGBkpQyt6yYKqrBt686n0kZmuQphiMlLHZuoFnKLMVLZOMqecFMrWSSrH0KlYMkmjM7F6kkbZOkntGMrWSUrHULZOMgeWloF2bK5DGg1srkMa7dpchzTakzqk0b7UIY0OpA5umvJShzQ6kjqk0bHUIY1OpA5p9EjqkEanUge0opeu3uyxxGg6jyNGy3kcMdrO44jRcR5HjMCJK3LhWEW6zuMq0ntsRfqPrcjgsRUZPloRTIWBg6lw+GGn8LCMqXDy3BteAWZmxFp04tadhi77gCYzCjTqWLzhNEYERjNuGTl5Ae4rajBbtEDWo9R8GASHgZdYoDCMUdzd1Kuq4E+XG7qkCv5wqaErquAHiw1ddfdVgWWmVFGt1p5XBb+1CGG9IuO1n1IFuoEq+h33HlRaCn5nkQU1aioP0cCyKvjtxUh2I68KF93WIgX99YaqRpfgefRRcmTMUVUiKYiWy8H1y1D3pWDtMrSAKVi4DOVgCoJPhWDhkttZIR1gcXuRZ6Pg8yHJ1x9SgxTB7p3DJzzXEFMOedgDmH+/GnSFomsAdvQCHtt6kSZcvUwTsl6iCZv8M5WJQCBJmRdDVWZXzHlS3JgPkXVkoyXypPCxQIGBDZNReVIUWaZAz4aRqDwpmKyl+P74RwLMmOPL0ZLst3+8oeaI4Jfc1iJLHxcuue1FLHoUHC2SujGFh4ukzkzhwWKdyVq45PYXSR2bwr1FWl8p3F2kNZbCwSKts0zaRSytFGwukbgihWeLJA5J4ekiiVtS+GiRdFkpPFkkJV0KjxdJO5krv0Qiilz7JRIt5J9aIpHAPHU/VGOJ90wTjnaXuCHthleML0NKDs6pJT9/T88JjUrRnqmm51WJ1vOamg/1vOyZOFfez9/zyn6elt14a8RpOVVKtkcMFVX5WKZSgsDATUBdydxD+ZN1jJL8PSmNe53Aai7BYB9cvgrLeAnhEr7QZfWS2SZRcx3KP+uA/PZZrsglN9iA6s0GoV0vQidAJ4wOnorznkLeU4SOL8R5gU4YnV6K8+JWNdgktPWxOC/QySb4/Dcq0Gzgr6FRpbK1F/TKXCbqqsVoSziPLSE5Aq41dHQdPP2hnk9UR394l1jkx0pTmUDPo7jmfIPT/JZLc8W8DMF8nIhXMO1uN2rXoYUwysHio1qA14TUr9TUgqqRr8N5frIX0VpZuFo1vQJeTIGUkVM/WiBd4Sw/2/JsybMpz1mGn9MMiOwY29tCzJibkD3AhdDj8VFQPDboOXONjNjeUsZlGssFqHq25DlyZJ7Ox3UFDQr+NIO/IweEwFSUeyH44X/4zq8cbA4CGElUNbV0Z9NbSRFlRdXUChFliZ9MlBUYFxRi0vkvR3Mry0nkxVwHhUiInUIkxE4hEmKnEAmxU4iE2ClEQuwU2sdpi0Ikvk4hEl+nEImvU4jE1ylE4usUIvF1CpGhDgqJoQ4Ki6EOCouhDgqLoQ4Ki6GOHM/FNPPleIImBaMcz9qkWpTjqZyUinI8v5M6UY4nfVIkorAY6qCwGOqgsBjqoLAY6qCwGOrg+rOhDq4/G+rg+rOhDq4/G+rg+rOhDq4/G+rg+rOhDq4/G+rg+rOhDq4/G+rIob94RZgGhCcyaeMi3SeijSlEbUwhamMKURtTiNqYQtTGFKI2phC1MYWojSlEbUwhamMKURtTiNqYQtTGFKI2LrJhRWrjIit7UhsXWcuT2rjI6p3UxkXW66Q2LrJCJ7VxkTU5qY2LrMJJbVxk3U1q4yIrbVIbF1lbk9q4yGqa1MZF1s+kNi6yYia1cZE1MqmNi6yKSW3M9ec25vpzG3P9uY25/tzGXH9uY64/tzHXn9uY689tzPXnNub6cxtz/dkYC9efjbFw/dkYC9efjbFw/dkYC9efjbFw/dkYC9efjbFw/dkYC9efjbFw/dkYC9efjbFw/dkYC9efjbEUcZ89cHetgSt9nbUtuK+ztgX3dda24L7O2hbc11nbgvs6a1twX2dtCx6rrG2Rg5EuaF0wl44eih/r/Kjxo8APix+sfWMAN/nxKj9u8eM2P+7z4wE/YEGI1g15tuXZkedInkN5DuTZl2dPnt2oHEfKledM8Kk8j+Q5icqTfH159uTZlWcgT7ICtChWfBbFQtCiWB9aFstGy6xGtIwBvwTHsVhwyQIwLc/+yIGFzBItUzTFqFLtReGg5djoKLT7Oo6ex1Z9Apc9ZbpoXcDzvl6kHbxexmNHL6kSnTzyfPIgNVuyyJ8nQZyyP6mJmQViDKiyP2ZglfkIquyPaiJzZBEDpuwPGcjQaQvAoCZmHCzi6ZSxa2GbDzh+Hd+nH0h3n1droarBWNYCRFIWVSZUS2o9hFzJ8XcSC5oS+uv7IblpIV4ntuPF2o2IVchyciWelxWR0iMD5Tm/k2t4ZJQsE7KNcjJKlg1ZApZsktVwKiS5VrJJthCyrCpZJIMFLxJAJYNkbK16m82RLYZyAnEVCXvthCwYtY9vBG8WxZKBt1fxmWIFjQzA3RbD1K9zEYWoiPtSxAMpomnHZbRsKaRtR6V0bCkmsLmcWlRO15aCeraU1E9KGkQlDeOSRlFJYylpPSppEpV0FJU0TUqaRSU1naikliMltR0uSUUldRwpKXCkpK4Tl9RzpKR+XNIgKmkoJYFRXSInGFZiA6REPjDQC4UpXiIXGFbUUQg4ImBdmOIlcoCBvi4c8RL5v8BooF8p8Rik8Uh/azdZeXGbf/4gZumJJyCqw0HMzkvQSYSClZfARxE8SsHTCB6n4FkET1Jw0z1ImHYJ3IrgaQpuR/AsBXciGHy7BA4iuJWCuxHcTsG9CO6k4H4EByl4EMHdFDyM4F4KHkVwPwWPI3iQgicRPEzBRxE8SsHTCB6n4FkET1JwM3OQMPEMekfwNAW3I3iWgjsRDBaeQe8IbqXgbgS3U3AvgjspuB/BQQoeRHA3BQ8juJeCRxHcT8HjCB6k4EkED1PwEcF0tn8Osncr5b+Yc3J8qQGj+mSYipbXPD978uzKM5BnR57tvKKlZ3LGmyN9TuJS+tMztOaUQ9LrZGx2Rix0E/OEseZZNqgasp6nf0R5dAlS8hbOnrMsnT2JXR5il52BrMqraJCzfDhXYH4i7bYCa3NOzYUwVhEG3/bm2OaCJewGDRs4Vcr7Ov1+ja0ZcFU6XBWkjhnD7QJsV8D6fhXzIbHkiEdJPxAEoVcihVaqVFuecGOCJ5yy4NmSJ/nMyfjTXIOvS2ovKSe2HunE1iOdWKfaiXWqnVin2ol1qp1Yp9qJdaopREcVJ9amdmJtaifWpnZibWon1qZ2Ym1qJ7Yb6Rh2Ix3DbqRj2I10DLuRTmI3ktyS8ERCmthkGQ3xQqI1nacLNK/YUAVVNMFaA/mzqpDoV7u4avx75LodPwMBlWed6WkYJD/dYC5z7Rnc6O9andf4Jql29ZTJj+ZLo+As5EDU3N1Nb86QGQgZvbOpE2PIei4JlnA5TlIxWRYdzMIzqes8RIC844LpkoUzUki9ZEXqJSJBNpJmgS2JHeIh2gFdX6kscLmb2+Ejv6SUgkCXIBTV0NnIw2hRbiRX7pUh/sl+u8mBCmwn4I6R7NREBehS+V97PJdlPJOWw/QMDdxZDMzO0KilkUxA86w3T8MYn/7o+IUwN5X5Kg3YMg1mCK6flWFZliFc4wuAEsSqZfxecttn9QIN77IM3pJaiAYvG446S5PNmIF40Mo9gnGxAML83x+57j4upLlfe3lJy/IEwgxRcqmeQychZ6AI4qY55//FD3/4wzz3EtyU51WJC1XZ5EL+EstXR9zZAyo0ldV+y3OO53eO5ZeeU0DPKXDPKSsL9frgP1o28ub8scXiV+VD/oW5WPoTPkogQg+224GeS8kGKBvSL/3XoIj4h1ZDZCbZPUH5tz/qPPv2IslXFN7wrrGz1OCsdnm60azypbfZ0yd8VWyrrHEE8bLwkXFnU/84dBj/J6uhX1TX/GGmoX9KXfMn+YZ+QV3zA7ehb6hrfj/X0DfVNaz9+iV1zW9nG/oTySjfdvfxkg1W7PPqx2vPI2sGV0nPM177KXUNRjpxpxxqEUdXz/tZKEutGwbzp3t3IGj9jPX7p9gZ8PM0Rq9gv4dvU8/7/cK9hvccNCF4yeMffs4PoPNYexp0uKWuiMq2ugIrDyFpK2D5uUaWs1ik7Tm/c75BbnhLyhXp3Pf26B6cL8NLd2NTMBv7oeemZWJcdc1vZqlullcKvHztt21dUM/53aca3nOJeFbp/baFHNRhkPiM8eC9M6vyKSx/4BXgSyb2FHOIa9XnopPBNYO4+GIiLgirrl10pzaxpK8gfGRfpuzXLroTmzjTn1AvRbdtN9WNKPiC+ilRP6YQqR9TiNSPKUTqxxSypEw2u9oqUP/Og0Sq8M67qWoTC7mksooo4x5qEsu/BsOsnsvEcA+9rPHpmG7Jb9R90re7z51FZ5Uj7f+ccrFOP6dIhQI2Yl8j19Lo/u4b3u55S+36U6ehr6gXveeweOjrvqV97ofeVZgjqZPg95KqiznyOtkyX8GzZetVPJtQqqnDePg6Hvf1Bh6v61N43NabeNzSp/F4VW/hcVOfwWNfn8VjRys8trXG44L28FD6HB6wRF6HFfOn8CjoD+HBq90V5dOd0HXl82JXZ/0Qygh73/SieoqAdVj9RrEw+R1Q0gXlEbRNlr9RD6UI2Fdn6XkTZr8l86uwA47vICPg+C61ScDr8EKDr4YtcM77AJwMogvYHEQotRpyWtuGZxsiJi42ibqwDh5dYvqYyXw/QzPZLs4vek9dpePNFea88L6GXoSTigwXBuulGf4BOKbI8M+GZPOUqhLC9ijVLtTrHLof6g0OvR7qUxy6HepNDt0K9WkOvRrqLQ7dDMl8KGgU6rMc2gm14tB2qDWHLoTa45AK9TkOrYf6PIdqoX6KQ4VQf4hDVqhzvq19d18tRS3L31uPmnef+Rt6CRac1D59NZxYrHAM7BC9olY5BsvyelWtcQzsE72m1jn2IAz0utrgyP0w0BvqFEdeDwN9Sm1y5HYY6E11miO3wkCfVlsceTUM9JY6w5GbYaDPqLMc2Q8DfVYpjuyEgVZKc2Q7DLRWHkcuhIH21DmOqDDQ59R5jqyHgT6vnuJILQz0U+pDHCmEgf6QynHECgOdizoLX6DugTkb2GoPDMYOniu0Y96D8dMWnmu0s96DU58Hak9tYMrYU6ewxdlTm9gP7anT2CjtqS3snPbUGWzp99RZ7PH3lMJksqc0TgF7ysOxYE+dwzlhT53HwWFPPYWTxJ76EI4We4p0lneTOf2q6JzvgscRQkW2a6tdRUDLDb0C3SII0HRJTq0fAzMn9Fy6f3gOW/YrykWBFlh4V6LZ/jlMWVchfxZSooAKYCENsvLmcxHDaBc/MbTfpSojPEJY8DHCNQ5PEF7n8BHCisNThC9weIbwNoebzrugG4VbCO9zuI3wTQ53EH6VwwHCtzjcRfg2h3sIv87hPsL3OTxA+IHUH+GmLR+ASEsiY0TaEpkg0pHIESKBrXZp/r+C+d/dNyZVczTm8IJF0xZTsa4IKvCkS4QUqEYQ894E4lmRuW8C8YTL/DeBLhDEHDiBtnmeJhE6gXYI2iFxVIH2efImaVSBbvI8DlnUCHqVIPZkJtAtntnJmZlAtwlif2YCvc7TPbk0E+g+z/y09gr0gCB2bCbQ+5MPT8FscVXQli1LAxtdFbTNaGR3VdCOLUsGm14VNLBl/WDrq+mVAyNMy8DSeR5PtM3axlDAKOAh5RWpn9mey3qVz4GdKRkKKgb334jAfAxi7EC22WVPnc8RF1NyUak9o9RhkpZNih1bj/uxSYImv0bszbgEjAGj9Kn5yzE6e2zp4HA+WnrLTpc+MEpv248rvWM/rnTwOIkyRum7ftvF4SNWnSN+gp9/o1q2nOif7UA+52psHwquVsQwF3tbmeXY28ooy95Wxja7W2m6+ml2bqCfie1NwcuMGPrSH2X7Z/pjbANO/5h4i/k4u4zQP8FuEvRPxvar4JxGDIfpZ9mSmr7M1uT0jjioybDzCXFUk4Gjmsg2ei02RMZ+ayY5dlzTz7LnmoHNnmuOxHNNOwPPNZE59QVY5iiIOXWy7saObHpZ9mTTt9mVzSRyZZOBK5vIAvsiG0hjrzajHHu16WbZrU3PZr82Y4cd2zQzcGwju90rcu4pHHounlM4q4ssg9ESc2SzX5ppnqITm/3SDHMUHdvslybg9Whke2X2aUHRoe3NsXsPig5sryL3M8dF2byc4cIUvveyJAr3/iZVFbBjLb6/g1Xl9/e3ag5724o6/2gRi3zFFbAHXhQBsTrsWAvv719VEZvZMna7c9jqVtSZR4vgyy+ev7kIiOhh81rAvV0RW9sy9r5zcA5ZUeuPFsHOVXm+5yIg7qeeRRGXUcQOilhGEUsoIvNoEXzPxusDF1FFER9FER9DET+GIn4SRfwEivj4o0WwR1heT7iID4fkG0gV1EUU8REU8QyKeBpFXHq0CL4kpPUn2cygq3BPqSn38NvJQS48pBtbW13lFZQW1mRSuKKu8nI6sHFezkVzRC/J5ML7KaN9E12I0IGJ1iJ0aKLzEToy0WqE4qqDln/yN8roVawgV/kOFUrsMjJqn6CDKIL6qm/p3YSDkVhL0InhkpROXhIsP5bTmagV6cThm05kb3WiLmjyShOHcvrDSTDxjacvJsGPJMFLSfDpJPhMEvxoEvyYu6+uqt2oreDLivZIYKPQXaT6WKA/plyQFleUHw30RznWd0L1TKCf4RhuNJ8O9NMc6zqhuhToSxzDDehHAv0RjuFi9GKgL3Ks7YTqQqAvcAzXqR8O9Ic51nTE0R/FcPtKrgApNrXFWSDFcFtL7gQphktccjhIsbEtLgkphqvfuUDPcWxovz8qAl2W77NFlZG/z35/7AS6IN9nvz+cAp2X78M1Mcyk7KIz7crZxOZ18qrMrtljM1z+2HRVODb3FI9NJOVjs8LcsSFeScYrxXkK4M2izW637GinaNMIovsL2ibaNM7oFoP2iDaNRrrLoA0i4h+mOO8OEb9Acd4aIn6R4rwvRPwjFOdNoc3uytIm+DHzpC3wY0JKG+DHpJe2v48ZMDG/nz5meXQ4enRm+jEMYPrsqC/T7HSFjlDqx8weH3rxzPAczU6SCe0laN9ECxE6MNFivAM00XKEjkx0Lt4Xmmgl3heaaDXeF5rofLwjNNFavCM00YV4R+gY6GK8IzTRD8d7QRO9EO8FTfRivBc00Y9EaNdEL8X0NdGnY/qa6DMxfU30ozF9HWOe/1g0zyeDsKy2cUWzLexlTOw31PPI8LyIzVzDnu+8pbbL/9GSs/rQwTVtc+sNL3/eYh1tMtdF90wr9+B6ProD6NreOnzSkMLduloL9Zpv030D3+67quCv3POy/gq8ridqd5hSnUQq3CXDx0mik8RCtRaAg8O3CzKr5NH/VAbahFwKOBxWBKtKgjn7kQLeCtl6JAMmKMXFbQmZQol08ro2uQkvl0l5kby5+rmXvcJ15fr5l96E7i//gIvf5QqSaFtZUZ4c50lSVZ7SJ45kyJ6QoZWBMRMXflZX5NoNlqTjb91/Q1lkCxObCItsYe5wSME+JoXWIZZHoRoY1BQqgEFNIVE5GVqxMSRoldQaZN6MKAENm6n1hmefj8ho+6P/3mrUXqZ2R511kcyMmO3uptu9ZOjfl9DuZbT7nNHuDsa6oVGJS71UYvl4u5fQ7qVoNfFbH5d2d412FzhSu1wz1C5X2MzcsSaO3NpGpQ7WQJjhJgjD/ddB66/eI9veQgoWmUvfadCrymkkU/DaIV+JLb1Ml7crULdAe8IJKGXO+j37XkNXfUsXVQGq29ohTVb8BnfQDGUh6TrT4kiyQ1nDLbHKvoSf0A6UItCzTJVNKiyT0Jq8YIQHek1VYDuneJ0sy6wlP7tyT5qJfAtEHyYFkGsB2GAhJZwy2D4oykHbOMrlSYZfiX5Tran1Q7rYg8qGLqqMdlJkL5Nqpi6ke7vtT/83q0HH0OH/ajXoRBn8c6tBh8PZn1oNnPP80Q+sBs6fcLpA588g39AronRkw3W49AnoBtH9l4PrLq9UewWHVfJMfnQOvzrkqx3bn+WgqULv1j6l2BkMGb+JvEux8xw6BvYB9QVqETQANBCoTdAQ0FCgDkEjQCOBAoLGgMYCdQmaAJoI1GOHqICOBOrzWRTQVKABQTNAM4GGBDWxl2rWGBoR1ALUEmhMUBtQW6AJQR1AHYGOCAoABQJN2dQPoK5AM4J6gHoCNemc3AfUF6hF0ADQQKA2n6YBDQXqEDQCNBIoIGgMaCxQl6AJoIlAPYKOAB0J1CdoCmiK/jTNQePQ8TtbDa8gN3W2f5TDcuX47a2GV4nRSQ4TmOO3thpeNUbHOUjVOrhT9VYjlEVEPIfioxw4CD+w0Kms2tOKGQSNxBkV8QS6jcSxFF1E9xrkYUS8bqHujURXkgnTYP5GUDd+g7qtP85SX15K5vjFJLiQBGtJcD4J2j7biP+B1fCHOWNU8LjGb40oxkbh5xu1v6IKMDfdyV8m3zv2RbdNwSqCLQquItjMs0Fn+6I7y10m5yIr0U9k1XI0BkWLTwxeYhn5v9h7Fyi7srM88Jx9HvdVj1sv6Uqlx76n1d3VL3V1ty2VbGPV6XQ3ckhASZi1NGuFiUwLj1LqZNSNSQRRUBEgUzzGUwwBqjuYPveKhLKJmQJMqBAe5TH21EywKcAzFMaQwjBO4RgoMEmKp6e/7//3OfuW1G5C4gwrQy0t3b3/s9/v/e///35dnbAwC6RbWkJwp6UN3LS0DJGWliHS0jJEWlqGSEvLEKmzDEGL7AJhkJY2IdLSJkRa2oRIS5sQaWkTIi1tQqSl9dvUs36betZvU8/6bepZv02dFBMWvp29gDB1eQ0CR9j4F4+Defj9Sdi8qfr3v1BBFeFVN5juptQpydwduz7f79bMzQF5pLqNn/rKX7/vsfo/u3m+fyULeQjBy2pjACLY4P3T8OZh67cZImv0IP6T2rjfjUW3v0SYq72U0XNlmldAWmf2CpGYm9bl1PGgTzSnCzTQXubUyZq9FsR5XrlhAL0UQIgCP3dlGkB0LzlIu6LfJXrfXNb0Mku9zKzHWdDMLtIqfJmZzYZ7rW5doVE9NOghGQHxIHVERsiQDB6UcDAKhtmIjMAhGZLxAENLBmxsG0+9jX+fON8XMAZ7AMdSRl1sW35ACljVBjJVQeiEAk7QK0sB0pvVgdhLD5opS/1iJjJSa3aAWpORHA9S6zLSExn6NZkpdZlYsW36hUNFiWE5ULgbrQ/Ujbk1dVNM6lW4mgBCRK97lFiM9HmURKz5eRQ1++dRxDygR6AVm+segaieVz0CpbcuewQKk13yCBTbu+gRaOTvgkegeb95j0DDfnMegSb9Zj0CjfnNeASa8bMegQb8Oh6B9lHbHoG2P+segWoagUfA4dtwlBq524eDDW+jQgSd/LaH1mgsrAaPSBZOONgDNi0ECNDvBGH9DMDBKHNoADbGIWEN9AYlBgdhaJTpNABXo2ypcKBbhHEVDvSMsLbCgc4R5lc40D/CHgsHukgYaOFALwmLLRzoKDtRyJOH11d2EmIIA9BmfTtVyOOH12P2UCEPIV6n2cMFj9DuQhq0bHW5eKs9VLmft1O+Z9L3TPiecd8z5nvavmfU94z4nmHfM+R7Wr6n6Xsavqfue2q+J/U9ie+JfU/keVq3k9DQIJSc4Sl8mwnvIUtha4kmRSM1HKZDP8hnDn7C0+cBytwdlPlrByl4uTxA2rqTtH0naedO0u6dpL07Sft3ksSo1ABp6U7S8p2klTtJxZ2k1TtJa3eS1u8kbdxJAp8vEPANIYW8ZOFgPPPcgU8w43YwfvsOSucOij2YhU3vSHkGAszpwW47QNq/k1TcUX5rqDDnATtD1rGHXc8pILXenZjkVnLTSnCR1E3VqoKiduVrhxdEFW2rpaaXCd5FA6412KOLiUQthwhIcc8tZHUn5ct996HoujtrxGS/tBS2i3eQmpN1BzdIXlDBpGvJFj4kB4smTzfgJjWkXMOytceilXtZnFCmvSpO6MBeFydUV2+IcyPiATfGA6fLBcLTyIbKjk093Db0wDvMQzAazqaABHfQUFBDVeT/gss8gGffDu7Hbkck0QX4vBvhdIcGaN6FGyJ98qJtFrez1os9SscjEuw/i6RsC4cBHyR9TUtHFVKPDlVSG71EUaTAtl6iCBJvamrbgruYvklcLrS/UeClaalV7KRoY5GiRaVhPyOCPqiZ9xZOaH9qhbWYHkLhW4cDf1kFcNjBAGGFYvgTbxVs5NAxZZejrMKY7KO8ES3ktlofPGaO3oxuMaiyRZbuFdMLMP53SkcOmSMiS2Dy5VMqGGDy9VP6ym/y5XtVmtjku6f09d7ke/foU7xRUeHuhDX5hjgnQZVoQNTbO+XMuuf796iVdpMXp9TIusk3T6mRdZMXEg0X8f1Tak7d5Iun1Da7yVdPqdiAybfEeQx9SUkUXPWXTimjmdIjySvzek0ohSixZylMInqkTbz4m3zx3oq0hVd/A2llsfNwnNrcOBN3cJSf7hc2pYxozR7uF7Zuh/q8HyxKoEMIdISBjjLQFAO1+gXmMrQPbYz3pgRCoTa1kww0xkDNfoGVYE8CjfT5oI5AbQYaZqCGGGqBpqMaR47lktFkUF4jhvD2fbxfqK5oIPZMY2VdWMXAMyosznjkffBDTbgjAvYi/BMGUu3ezy7i4r0BS7Z1XEo64qaREyvuDq4lM+K2uIzMinsma5TmHHnbbMoqxstgS9Y2rPMnbeQbexQkhUviuijLnCApXBXXZVnkBEnhhriu6x1eoBSW1LnorvCKpbCi7uVQVz7FUlhVdyGYCYHDUlgPiUp4QmYpRmbZKF8qXGpr7Qk5xRiKwyWFa6SYCsc4ibumImUOx3DXYOhG1hzncNdyDHYBp3BtP6FcxBkcTTjvKJdwAmdDtuwJnEpP5IliB51gKJbbhl4JATFIe6VA/6BjPYQthgLOjRCvuYbQTo0+SVsh8XU5Nqkdk8VcbHmN5FFfMxYe0MmKOUUtSs8rEGVtVfgNRL2dIlyq4p2qdnetVOyuq053w6lzN1WTu6UjOBj1Bumhz9kgdcMz020ZAzQbroYo+A1ukGaj1TDN2tVAzcaqoQpwnHKwZhP+cAUcTjVgsykZsjznnHQDN/ivZ9w6ymUMJte8pFzFrdE1MinXcWd0TU3KDdwYXYOTskh5CtfusbDTcF90zR8LuwzXxbIXYmFs4bpYdkYs/CdcF8suIQ0yE1OFdMyfctYV5bQrJ53MP067ctYV5bSDYyfE5iThdkNITRiIj0D7FK59wrOhBYxta3JLBsIRhvbuxyXYioH0lqFx+0k6Vg12teLAzOblVys3JjNbIEFOCn7IScEPOenhh+wousa2/m7pL1E2Dr3m3C/c5HdTXxYBq2e3GTaITn5B2ZXmIL6uyJBcYGMQTleERi5ZBxJxWcVErrIhcDJFO4ATgmYgm8Q1w6stK9Wi4i0pibekpN6SUhtcUurektIYXFKa3pLS8paUIW9JGfaWlBFvSRn1lpS2v6SMDSwp4wNLyoS/C2aT/j6IUV2tKNlhf03JOn+aVcUDcHDLigfh4NYVWXsOrCuy/Pjriiw//roia4+/rsja468rsvb464qsPf66ImuPv67I2jOwrsjiM7CuyOozsK7I6jO4rsjyM7iuyPozuK7I+rNS0tbK9acoaevl+rNa0iDxBXNjYVH2WSzrCenrYSG9N7hesSfEoH2ne/Szr15H3ep1pFy9Erd6pe7IUHPr05Y7R2yX54gdd47YdQvani5obvkadsuXrmhLRle0ZaxouniNuSwKLGm6fsmKtoYVTT6uY01j6QwkX1E688qJ/7OuclNqnvvVVqqjulIdcStVoitVqoeUmluOZvTcMuvOLXN6bpnXpeuCqziXqmFdqnTtuqxr11UVdLuudeZaNe7WqgkVQZMqh05VjexiVJnMZFdl4jr84bAxt2qQEloeUjAHmCmuMPziAYhqvBBg/u218NZwLlrX38WWFxAYfqJJei7abOLDuWhZf7cbNs6XogWwosglimEnuX0RCsNUlsa3pP1X8GZ6xiwNoUfw5YxZ9Nz/KKJ7v7VwxiyLewnmc75Z3ItwLylUjTBA9JVVDLnRJBko20ppk3UCyo5SOqDsgrKrFAvKHih7SpkhcwCUfaXMgrJYK1TLnZ0MngsoS0qZB2UZlGWlXCC3BpQVpVwEpQClUMolMotAWVXKZQKtg7KmlKu0xgbKulKuk80DyoZSbtDwGiibShEO0BZIW0paImkbpG0lLZO0A9KOklZI2gVpV0kFSXsg7dUcehFbCaR9Ja2RtAhZ0cW6dHn7r4rC/7ap3gI5hgY7DzADdwtRNSdAA+6aRlk/QBPcNQ2UZ7kuIfbvmgZCbGmIxehuaTSQRkNCLN0txBZCbDXcUBagzUwkLKIsFawkUVFYNKKMsAE7JOwo0VWYF6WEIKvY+h6H/4qgl7cUxbxeoZnzt6G/Nf1Nn3UWmPbeRFH2gmwOSvQWBNSj8G5B5AQ4mwUXSor4VrKvrVIOd6hQOa4IOul/LYuBbBffrDBQCdqlrEhtF6Nzsi4sWayuaqfV6Nxsuy8XIGzP+RKJantRcK5EhPuCs+OCXnRBl7AH9fSlFtOIgTmfrQt8yQVeZmDOEuxSPcJ89JnJGuNx1s+4eJfL8pTxthiPGRuYz9OXX8xNJsBFYtYlcNUlUJQJbJcJLDMBFsZA3lbaqwJUg+58WsGaZjCHWPltMF1q7u99xkZEO03lV1TV660y+H87f/upL3/3m7/ujSdmN2DiEGrueIuOBlBTgcQq6dT8dKIynaX3l+nMMx032NKBdFIMPU0nrdJJW2JJMKYmYMwDFrAFIq5jsmwI7vyG4YeaTZ9qRe/5qk9+62//BPtokWr2Ne/1CTtdaR/qMy28nsKs+anARq3faZn4VgO73156LUvFVIdN2hdtms9B5ixs/xW8iudzC2fMLl7kzRmzo78fS/lpExvStrh34f6IuHfg3kqtoZQKB30huD2pimeIsDz9FKJwaHipyjnIEZn+SxyxheD5QIaFI7EQVB9IsnBgFYLtA3kWHqELQfiBVAtlQgrB+aFsCw/PhcD9UMCFZ+dCUH8o5cKjcyHgPxR14cm5EAwgyrvw4FwIFFDKpd44kXkS1kgQmXkS1kM5NReKD5SyV00lNU/SZqjCK4oWlHJOmUpunqTtUGVBeAwmaSeUI3PBUzBJu6GcUAsBtsWa2/6rNs03IkgOKswxX4820qzFpkmzIfqTbJj+JBuhP85G6Y+zNv1RVj3Mem+0V6YJDNR+Vn5H9XdEf4f1d0h/WwMLcJMrKeE7m1xKF8U5DGpC5wio4qSkYkwnhQPFOVYQOjkg8h1r2v5rXSMjOrRx+1GbCrMY47InyMYRb9sPRfM9wTfGfZbjsicoxxGPtA9FF3uCdYybLcdlTxCPcbvluOwJ7jGutxyXPUE/5uuckSW/KfBMdQjpRUqvc50zsvK3JEC7NCzKXUADXMA6yMEQ9XE7Q8jqcZGbgIa86EIu4UpBVxH1cX9DHFuCnHEv0DiXXJzlMs4m7iB0rUZ9XPUQewb4OHWNPeNiXy7LVsbeKmMv4QpD1xqsf0g6s4rpGcjGoOlcdekUZTrbZTrLZTqbuArRtV4+Fad4pRVRSOjR1OiChk2DLmgOJHRBCydWefLQRnRBcydVIUhC0SynMUV/NlORutlIRdhmPRUZm7VURGtWU5GoKVIRpFlJu23Z5nlV4nVzK+KKTTGaZR6QtuTxdTnhh3GBXCJimqKnEZQJ8GyFIKsphlq1+TGVBCv+uDcDD6z4AnsLWVGs763lyES30ptcCZN87rlyGIYyPAl4EGF46uhTTlSPx+CoL1bBI2948gKhAS5wEw9leNYlZMcP2XEhL7qQS7gW01UIXALiWD+OdXEuuTjLZRw5pfCk7eZWhOFZxZ5xsS+XZStjb5Wx5azC47mbghGGZ9U4sy6dqy6dokxnu0xnuUxHjiwUfZXhqeLhqV6pjYDlHm19etgM30rUbOnQqeo0u/cTnPq3szGyCAzh4+t2yNIP+IkJLE/qB7bEJJYn9QN8gkw59aNzx7hj5rtmoTsidoH3jmWp4LMRequJn2vZKIG3vvp5vm92FiCmprIrkD6nWkydGhRZjBkc2xofi8f7lVgwbjb1F179ewSsrYiQW1liWyJI36RWSfT2LCozZI54+rTRAobPuG9dxS/6sJm3o0/TXnmEx3MpP634HqhDt6lQYs2yDkm+ecIv6YRX0iTfOoEy1lgj9zk5UBEFDdOKDN+tIsiiqsjE56gieyf9ikwOVGT/5IGKTP6pKoIsqopMfo4qstL1K9IeqEjRPVCR9p+qIsiiqkj7c1SRjcyvyNhARTazAxUZe82KEILsYE2QR1WTMb8mpdhZxLdxXRnH5biRqbJgRPEb/TZhS+rScc9gekldrqjtirpSUccqqkhOjdA8ix3CxkJYbV99tq3Q254GbVvhuT0l2rZCeHt6tG2F+fZUaUfw1tm2ZR5OpdbLw2nVenk4xVovD6db6+Xh1GtHiLRd5eHUbL08nKatl4dTtvXycPq2Xh5O5XYEDyleHk711suj0r71cqkUcL18Kh1cL6dKDXcEDzVeXu5WMZCbu1cM5OZuFgO5rYO4fiC3jVA4J0NiJfI7E2NuPXZTNkoRjd0wIg67bkQEds2I2OuqEVHXwoh464rpKiq3iLEuGRFdXTQirrofiojqXihYHbuK1bETClbHdgisDuKHTCsSyDHF9BhA51gLBZ1jNQQ6BzHkutJuAsmxHAokx5JCciyGAslxA4gcwJC7n10s0CeXBfnkkgCfXBTckwsCezIP1BNgyBHmZFZQTmag5oqnCGKddIDWCE0HIp7UBfAk6L5eXnko2xfZ01BD5JEuVFApplsHHAczamdkGDHvTlbvWxYGhtoKy+LNwLQeyzubtSo899eDrf86MKSeEJbT42DmP0ZOPk7t9lHbqgDk70fo+xD6Xgl9CqHvYegMobsuNBT8LUKfROgTEvo4Qh9j6GmEPupCA8f9CELzdeGwhD6E0FMMPYnQEy40sNrHEXoMoVV+YhShRxgaEMiALHZ47KpmydNZ66fDMLplg/abqTsrSy3WtpDra4C1Is73mwtccEvrKXFeDC2odA5NPw4vOCkEePdGFpyBEHhX2gvObgfBPccWnDkNeHfH6d1R7/IkvWuxeNen6F1MxLtziN6txDtmNlX7aIw6OH9UMxM3o1tc0A6XeBB4gz4sD1pTgutA0XBjpwTXgcLj9AHXgeLl9AHXgQLo9AHXgSLq9IFBRSF2+vYdPgN9ew6fgb5dh89AH3AdKExP37ZDa6Bvy6E10Lfp0BrowysfpfrpW3fYDfThpZC6AfThLZHqA4fRQof1BT+QR5KQuA7GRn0fkd+ogKwD5DcYUB4ev8HY8l5zDV7qvadcg/FWgvHD3/BNaVpcFqh5oTZpjZranFd7tAZyboHbeOAfpv+iqtjgLkztj0Jebvk4GLitBn4xGyj7DPxj9MsmA/84/bK5wD/RFx0V7iyVZGoohkTFzsQBPIbJPOgeZnHdWKIw9iF7SE4N3ojrs4V5MJiieLYGQjsrdd2nJo664VNTR930qTVH3fKpdUfd9qkNR93xqU1H3fWpLUfd86lDjrrvU4cdFXgMJXXEUZd86qijLvvUtqOu+NQxRy186rijAo9hCkNcepBUf5C3fjQ2IwKGsDWtNpnb89kQLZ/XK41x6sevhc9lhnRwgM1CBnuNPHBea//jsFvPQxtd4+m3RvNpUIXujkDp8XlgtEBRHIjWjUgStw3oz8eq5g5DbcFLQHbpGotbZt2S0QaJKTftRqDXHeWTAtTANIytaXTbdpS4UrBPq/N0XTXPUxej6WLEvgXkZsmOpua3U+QWo3yqB+4B+LBw2Zgd9vCK39QfkN0ee/l2t41WiVm3Vh49nzVfpQapiM4HLGrX6N5jm1KIKB+/lpsvuEtcYH3HLm6Mo/RAajGYMgconQOxTB579R1ED5DBIDqqwG7YmgbLaKj1TyIT35pyLKMpGJ9Gabi1icbkCvCPKTrTVQNd3aaI2QB+B0eiIcrjAKgHR6IRSu1guOBI1OaeCfAfHInGaT2sO0G5oO4keandKbJYu4dEL/Kw6GJ2RPnzCNm33aPk1HSn0QUq/KLGugFFzoWJrJzpvrB7j4owdBvYX+TvdvrC1z1MyQKydA/1hZU7JWHncNdF6bBMorB2XEQWUH4srZFKV7F6WItRW6zRqDykmyXsDSzrbB6s92wvsvakCSnnrlwqOT+IFEVRDMBBePgaFFxprZbdFOfJc9wRq3r/Ge2phD2VVD2V/NfTU37nuG6TnvpfU/PQzeSWXiqO6KXiqF4qpvVScUwvFcflUnFCLhUn5VJh5VLRlUtFJpeKe+RScUouFffKpeI+uVTcL5eKGblUPCCXigflUvGQXCoelkvFI5zos5joj+Hs+7iYo7dHoOQa2aNUXLbTUGeN7LE+YbOO94mldaJPgK2T0FKNrO0TfKvbJyJX1idM1z19Yned6hPQ694+Ub7u6xP66/4+8cBmoEsKECKMKfsg9EYBM4QxZR8GCDSAhLqdPCTAGU53j9rH3NpOkLNHZRSdVrjlGICd9rTCLSd8fj2tcMuwaEsf4Zbx8Esf4ZZpBhE+wC03wNOBB3DLTdsSD+CWWzC6DQ/glodgaxsewC0Pw8Q2PIBbHoFlbXgAtzwKg9rwAG4ZFhzoAdzymB0XD+CWx+2EeGYUNZoeq6DR9HQUM5qetkJG01NXxGh6AiJGP4ph+Ggp1vX4Qnbaxrzrn4ae9Ap+U7IKTkNhegm/dTIZTkPR6IY9Da2o6/Y0lKWu2tOWAoKnLSWST0N7/KI9DRO3F+xp28Yh9rQdw9n2NEzJzdrTQHiesacB8GztaeA7d+xpwDu37Wng3dTtaYA7B3YWJZ3VCfMbUE075D9U4w2Kz3lfKLp0Dbzh2LNO2a4Gb+es08arw9s+69T1mvDW5Zkncg8+eDXA2EHK7b8EtUZYqBBMh27MMWNgZED06rDF8pzV5FmCMA494XvX1d/uiQ2Kmvo7PTGx2VC/hR/HKAWaqmHVbkrNav7C3dKFe0gX7mFduEd04R6VhbstC/eYLNzjsnBPyMI9KQv3lCzch2ThPiwLd0cW7iOycB+VhXtaFu5jsnAfl4X7hCzcJ/OgG3LmhWLoOIPQmg3z5Dk5qWQNhb+iMl/hWbw4qR1XrfK490ccq5a5tHH5j8hKYhksl2KWaqZvWcjZfmFZ6DmwASIKS7BKF2SNZy0vwhJfJHbq2Ai0UxdR1JVNdJ0Js9EgMS9tCe5AJGsBWASRSK8OSQcAZDNyFuqKopdZQTdpLFgrUj8hnx91ctFGITFa5BGpMsEhVqGJGaRG/2ST0Fe61j9OzOxNc0uZYw1ljjWVOdZS5tiQMseGlTk2osyxUWWOtZU5NqbMsXFljk0oc2xSmWNTyhw7pMyxw8oc6yhz7Igyx44qc2xamWPHlDl2XPexE7qPndR9zOo+1tV9LJN97B7Zx07JPnav7GP3yT52v+xjM7KPPSD72IOyjz0k+9jDso89IvvYadnHHpV9bFb2scdkH3ucZ4vXCUPMgiHxOjLKnuAuQahV3GqhsQNXO0vQ6S24O2CZNeGyWQ0Aq0+AN1YXXhFYx5NgFEyAOwAeEy3/KZeJPCblKYUYtxi0MZhWDHcY4Q4h3JQLB641BLEAwI/ZkAgXLMVEqGEW1B3/K7T3Idy9CHdKwt2DcBnCdV048MofRriHEO5BCfcAws0g3P0uHNjsjyPcYwg3K+EeRbjTCPeIC4c2DBey1ylv7P/Dwbmmg3NVB+d/ocPTdigDcyuUkbkZytDcCGVsrof/qYNzcGgCSlOGpn1l9dOxSRFrGZr2fnHarMYjrAxOcDUdWugjfRvTJEjCw3NqZwZ1MB3K6GmEyxhOtD4fYLhxp9Dp0EkfRbh7GO4Ywz3IcBNOO9Shms4i3CmGO85wDzHcJMMN90s01McQ7l6GO8Fwhz1F0pF+iaL6OMLdx3AnGa7DcIcYbrTvD05q2rX+QRyGt/CujX9ZCFcMF+X9B98mAgpfeS8TJG0K5BhIm0raEsgxkLaUtC2QYyG1kYW0I5BjIO0oaVcgx0DaVdKeQI6BtKekfYEcA2lfSYtiRs44sdOA8gmcMAUtR4uJLzEqB9KyklbEthxIK0oqxMQcSIWSVo1MzoJWpUlaMzJvCxqXJmndyJQuaGNa2svIbHeSsQGlHLgQFDQcLO1lBCW8oOFpaS8jmOUFDY5JexlBQC9ohlraywikekHdX2kvIxjtBXWGpb2MgL4X1DWW9opEgJjCu61fr4fDN22QB/n7ovY7wy6gM/kgYgYhDwNrXs7IffdgEcxtkKgOLRZ2+1CNqFsVczF9YfyKhd2+cH3Fwm5fWL5iYLevoAY0sNvntKToO/icr1aO+TvLsazluECmMznRWQyZJyoXXJCPF0XeuiP0RDjDIjMvz2+kp8IhFsl5MZdMekM4xSI/T9600Jt8meTNF3lnxpp+T1AjXq0CCHqwBitagyUm08nqkhokaGhEQRuYWkAi2FNzhU7d95ZqBInoTs0VvuG+D6l2kIjk1Fwlmu67kcdMUSqkyA7wqnraG9HBykQvo3E3BioT3c7EnnmgQkcB1WWlTsMsLFJsIUUrQlKbWiSIwFVFRqghF2pEoBtUgmi4KjhCGRcqPqfrzaLR4qcURWpRvghC4K9aCdgIH6hEQkPsgUo8BbJxsC7DLF7K4iHdEUo5JRxoCKrCTV4hUxayxYbUsMk5XZU2XFEbFIwaohzfCCX3ZAilBwucvowhujFQ4PQ2GnLNtToLPJulrjWbTJu8eIIJuCFVE9UbWUQjba2mSBdyFLPjdRDcfUTD5B6ESN3IjgZHNszWt2zQ2osGtxvORm/PgbzoRYE7pO1GyIteEv9lvtP0RCSAsy8QedGr4r/Od5qeCANQcwXvND0RAijn5WLYUxGAco4tgbSkpGXZKUBaVtKK7BQgrSipkJ0CpEJJYkVyFaRVJa3JTgHSmpLWZacAaV1JG7qz9nRPLafLJkibStrSnbWne6rMAO6sPd1TuZvKztrTPZW7qeysPd1TuZvKztrTPZW7qeysPd1TZfJwZ+3pnlrOgCWQlpS0bGRn7emeyt1Udla0l7mjx/3O9kVBaIvQkwNBZ/tCIOhsXwIEne2Lf6CzfbEP9vWg0Af7elDkg309KPDBvh4U92BfD8p5sK8HpTzY14MyHv9/PEW1PjwcPnpTOCUTTj9ZuCQzwmuxihopPBM+AOGgnwjrJJXTf11O/w05/TflntCSe8KQ3BOG5eYxIjePUcp+yj1oVsSJ68K/6QBfRtBpwOvKg3wtUjCJcXuolx2St+spW+tBIRZnFx/VbdRO2rFeNskFeapfvKQ6s8M+Wp2d5AYjn/Ey3PRx8Pi1rl9xChn1kel43B+xh/q9l1TtdsgHvePnln6mRnDDx9PTy4J8vjiQM2zdCmKMTSkhnVU4cf1sDOv6ML4P9YkSU0D/ZryfHSk8TMguSuDJSgMIEnEaiIMLb5YizuGeFwcXpLaH+9aHxJ7ni3t2DCGm0bgTYCEdRULHiuwettBmNFiNceRwvJed4uadnfDLR3M4Y9CNhp5CrZ91evZYkd3HIhy28SuVBGNqWi3OtCSrk0V2P7NaOZDVEYT3kp+R5OPCJj17ssgeYLodG/v1fZBJEX6nibL0bKdAIR5C5ONe21Ed1vpRjzO9BPkmhW2inA2Usy7lnCiyo0x8XRKP7WFW6GSRTSPxI1B6n0XZJorsYaZl7Qk/gxOMviTRE5QtLhB4DNEPe2VL/FhWi9XxiY8wKWw76F2bvtTPHkOPvNTPHvfb7HSfJY2B446SxsiqHA2LVNWzR4rCTvSytF8UL+lxFRnOsnAJUuhUqIaL/WzcjheFPdaDnaNh+5g95ed4RFK5zERqXqwaIJlQih7YUk37+GC8w7RiZB9lb3UkEYiZNGB5aYgX/VErY3IrIv1e0O8jXQZQIfQZ0B8gXUYDEZsaMPsxxKv9qJWO3BD6tNgeAl16aFnoY6Bb0qW5saXbUTAeGsTKsdpiK0JPQB8Xi0ykXyW5ptaahqzWikiuqFWLtRrRWm1HpN8r1qVAl1qtCn0G9AdIl1oRrKqOWrVYqxGt1abQp0F/mHSp1YrQx8T0FOhSK5xKPABKrAOHsBJO9XuFQ18bEZNPMeJqpYlf0BpYdw+hCzXakkRLEG0c0bRNILlTH1iPD2EwaKxLjFRDJNq30hYDu2nyXNRu/Zgx0a3EvebPDiiAFOY1FEBWzWsogMw75Yg18xoKIKWqyA2nRbFuXkP/o9QZWSw1L9ZKzYsN4+t/VHWauUN7pNI4WS9j74aV3sbdtTUK0db4TGxqt8xNIQGnnHi1EHLpxnjM8ZBbKcxWyyIbA8yTFucBACgyNmIW3McBtMYGzshB6zYsIzdVDyVc6NYMJG1oi8FQlJzp6WMUNT7xXlsvrSQ0nfi1Qd5TzwwHlNvJw+clI2cjQXXTMNKqyAmNJEj8aKEbUCblGRpa8KK6Jn6VqKgNDacczCm6a/BASyqCKTVx5JM0Bp9KxlVaNR6iqiah1FEdRuTFgISNxCRKk61NgM+6Z53Ds9HS76Gh0zyU6jUpgkD4TD9C4Ekb9RjEfNYgUBcD/nM+qdXRkpT9frvaor0xMC1aceECntbz8Fo3sNFw4MSSxC5m6wchPBD/WRYeeDQ3b+8+hmd5oEL+mRUemFXhgdkDwgOzfy48cHfhAX2Sj3VJdEIWf0YFCFTUQQQI3heFlH4ORMAIejkRZQgz2WT6lbWKSKAYhFRXCXhiMAiprYLrxFoQUkel04moICSrIugESxCSCAFHAn8gJJEDJmlOSSIKTNK8kkQaOBL8ByGJQHAkOA9CEs5DJGgOQhLmQyRADUIS/kMk0AtCEhYESdeVJFwIkm4oSRgRkaASKM3xIiKFmQhVRKpQoFzBkxCq40hEihYRquiUMCUihYAIVY5K+BID4m2LiUlFhtVey6JTgTWPBAFEEZ+BayyPnnm+m0CpERZ3fiV4biHfWAwXEKaWR9eyev6Z8Pnc0NLQ09gNgdj/SPDHH0+GA0ptQhny44kNP3+Yu+r6r5bY3vNXunFp+VbBQYNHgj/8eDISBaEBJ7CMm6Aw7eF4KKmoz9j4+eFoKPYow9DqYoG+KJ535TAtiWyGIueC3NiXD4cwZZk8TXTcGbP78SSL8zlu6axxmsfPDLM9JliXxKbDED9gVcwjwdTTXZTmkeAzH08gFvhQVIfGcQNRn2bI5BoL80fhFwwHpbRGtwl+dYldsnNeTXf83vmnPvRT+Pvd88jkmWlhKPVvJ7bZIo5Fo2UbXj9sLYaUAyFv5VcT5RmBQ/OrSVFhIXuowvNXpnvPDtOA2gPB6NngMF2mfta0xRWcNbRPkYdApvh4QjexufPVn0kWAJ6EI8U/gzt6wMRn6X2veofE+6PqnRTv++mdCabPBAQBh7dBDTqcR08FrU+asHZz0GDDFVEQXzFPnaQxk3vmb2fKVvIoymf0KJEwqDyK4O6EHiURVpdHSYUf5lEqNoTHkbgyndXAPBCLI7Q8AhMbyZVpyGHbmBg5xkZXpiHSb82V6YwzjxrspXMGrpf6WejdMEXZnW9BNiwK0YEf8K4PejcGvZuD3q3K6wxvHJu/ndiw1foPR01yawqzfaem0CRgs8ZEfOawgmKlTvC6HApF0ioS3Y0ZEw9SUPUkXzupANcewFS+WqPEmE3ydf1cK20X5Wvlx407P67XFjJJeLNKmB9pd+0nF8OFGRPgRFrHvhnC1s1O6GZy3V1yIolhNFjgghFpnWaRVv/P5JWJFAheB4BPYdMItILmh0QrlUFd++SrJxfa51oquNAAZHko2123ZVPhzxLcR25NsFTT6gscBjPIzBmzXSOkBtFO+lySCf3ykRoDbdQA8UL3GfNTQtsGbbMGYJjaQpaUfPIE/VHeFvsiCFDeCfsiQFBe+PoieFCq8PdFYMH5Z+VFtfTP9UV70/nn+6K66fwX+qK36fwX+8Kkd/5LfWHSO//lvjDpnf9qX5j0zn+9L0x657/RFya98y+iscijd5QlUJZ8yjIoyz5lBZQVn+IavaKsgrLqU9ZAWfMp66Cs+5QNUDZ8yiYom+yWu3XQFj5v+RG2Qdn2KTug7PiUXVB2fcoeKHs+ZR+UfZ+yiPs2GfRlY4Gy5FOWQVn2KSugrPiUApTCp6yCsupT1kBZ8ynroKz7lA1QNnwKOQKbPmULlC2fsg3Ktk/ZAWXHp+yCsutT9kDZ8yn7oOz7lEWgRxCTLK5gOiii8Cqdt4zPy36EFVBWfEoBSuFTVkFZ9SlroKz5FAJZrPuUDVA2fMomKJs+ZQuULZ+yDcq2T9kBZcen7IKy61P2QNnzKfug7PuUxbhPICCvsUBZ8inLoCz7lBVQVnxKAUrhU1ZBWfUpa6Cs+ZR1UNZ9ygYoGz5lE5TN+GDnJa6x8HkLERxlG5Rtn7IDyo5P2QVl16fsgbLnU/ZB2fcpi0mfWEoVZQmUJZ+yDMqyT1kBZcWnFKAUPmUVlFWfsgbKmk9ZB2Xdp2yAsuFTNkHZ9ClboGz5lG1Qtn3KDig7PmUXlF2fsgfKnk/ZB2XfpyymfSJQee0DypJPWQZl2aesgLKSUvIhawh0WDbV52mawGLZIbA2GgI7lh0Gg6MhoGRZB2wOem5kR8DroPt6dhQMD7qvZtPgetB9OTsG1gfdl7Lj4H/QfTGb7HcneBGYpB6enAySfAvHppjGBUI7oRjS7iizTer4AeoOqWMHqLuktg9Q90gdPUDdD0T8dpC6SFHp4QPUJVKHDlCXSW0doK6IzpyCGgbFgO5zXFVaODvdBs3lpnYSB68hLpY94Tan9jiv/D0chID+dYzX/R7kjvAwNM2rfg9iRsD+Osprfg9AWoD+OsIrfg+yPED+IgbjbA8AVwD+OsyrfQ9APHM2tYd4re8BhwcggFO80vcA63MBxWpnMaWaqgrFlGLKmiwgeRExmEfAVIwdKyIGB6kP68SOEwFzeoD6YknJiIjBS+pnIyys6LuDodTPRllesiGgJwjMIBaZXIgYrKV+NsZSkwkRg7+E16u4VEqeMZNU+IQqV00GGdgrocdeiQbQPhTp0kf7UIhLH+1DoSx9tA8FrPTRPhSL0gf6UHRJH+iD7JVoAOiD7JVoAOiD7JXIA/oY0KRPabjGRrRzhzqHWuewnFgypQb6TvxVz4m/6jfxV70m/qrPxF/1mPir/hJ/1Vvir/pK/IPVeWYYx3hvYgQt6h7s1P5c9+DPdQ/+jOoeiG50PcjXRtqXg9brwvBWXm8HWdj+dmgefep3yPEJ83jBBu3vAOkjn1bS7346zON2GLS+PzXJrVHwFNbCa5k5FcDEz9f9a3ACwxmz+K9D4Ebk0RkD1NAw3/8Ynq/OmNfRt/TL0Co/Y4AwGp0xDwOH4IwB/qiBfb0zhsCc6p6kcxXMqTadMwtnzBBdKyDC6FB9of2l/CKR2kdJI6X9LCx1fSxUg1Zhvv9L4UIpN7TzsVDm4d4vhbRBFOZ7EjarZHhgVPXaDz/1h+/67Z/9y1968XzfAzGvlZKM3+0xjZ6dpnRBrU8jrUruzLuIpzdKFs2p+aIPKOZ88ZeZqx3uZWN9RcRoQMHANiDXoJgZLagI2FYvmxB5fYo1IRiAJ/tZvf1uqCDX2y+FBPjAmplNEskyo83begn0vHfe1nvZcD9r97MpRVUF0yLDOan9yl6m8K2jdqQnMK04Zg33sxHsc0NkdfQUenXKTvYE21VwRAHZWrctO/xKen0HxoonHGojXKVnCNoWhIx1g0RHh44H7fzZyjnDV9DOQhaeMYRkDc+Y75ZxsoxxUITl6PjOsBozGEoYKO0rtuLr7Z23tR5FQJTw5vn+QLfasb4zjjveF8kJqGiIHElNm5u/9b4IddHT7qsYFn0d4VMYoHOcClpfG9Fwpd5VjLDVQhV45PyJCTYkKCjCy6GUrrBpCoX8Dfii4sLZKtxcFa4u4dpVuJkq3HwVri3hRC6hytdW+c71C4UOdvnWq3xtla+Es16+9SpfW+Ur4Wa8fNtVvjNVvvP9QiGIXb7tKt+ZKl8JN+fl267ynanylXDzrY+mUe1mciv8alFjSJx9GMEIF1wnKp6/XMoxr73p2RgPFTfNvK29mBmbvphFNnkRmrCCa+0YwHexRBgEEN4fsP3c79af+gz/futW19k3iQel/aMyxJVhc9Sayvv0cAUlAzQePGcYa97q5diN+OjRjfAtQiBAVQOFO+4LkzgpXalzFUXRjfGWGr/cB2iIGTS8AuvhWfRjT37G/QVf++TXqJXEzwRfzNH1YhYPBlgsA1wSSQIbF+Cuxj+WjTxpl74na+SLixufia7Zke/Jhl5gkPa3hwjSyE/8ndw8nw3byAVu5if/zgvdFiwm5sig9nzWtCPfg2hk97Zyc23EBGHUeqrzyFNf/AfdxvxQ5d4YMs79e+dt9E9twyXSsEMvPD0cHjUQPUF5as/EyINO8JlbefT2fOtBrM9VgpKIC8WYi3bBNr/o+aeHzVFzEyCJ1Rho6ufGW4aBBxLZ+PaL7W8PW11nIK81EsVBiP56aSiuKmCjp2p/ffKJ+/5p70eLHnrV85c1K9DPLOTeg2Ibs2WjFsZ2USrVBNa8ZM2gpeJnpzOI3welfs5tXzvn9rmoPdoSC0v1QZuYgVA7ttLDhTTUf/wCV68mfPuzLXD1asK3P9sCV68mfPuOBa5z1wVu5o4FrnPXBW7mjgWuc9cFbuaOBW62ynfusy1ws1W+c59tgZut8p27c4H7ZBJGt+RhF6cydJTRn7b84MDUBlRNgDOdkf41NpCjlpzefphNAgibnxkmLmcett8mhN+cAAbmx8KF9n8vA2rrY2EZ+ntGvNC8h3gff+qo97FcxKpJEj4S/NDHwuky/M+9Vvh8+WN8tKqifGzSL+3672J45Kv8uV0G+oah1yzHml+Or22/Vjm+/2A5fvrQa0X5gYNRVpqvFeUHD0bZGn+tKO89GOWHqoKZeWseDiby4ALE2PI6T9V4SAOug4Czmrz+hmCCMSG5FuYrvxks4H3/yf/wsz/z/n//nnf+yOmzAUTGgjcEYmu2vtC+am4NJJy4hCXFxKXYysJ89cQjQfCGILZh/t0nZoLgDEsdvCFIaKgLqflpzZh6+/uYCh+Rf7UR1nWs1+VVcwiCQxjYbVvXhWvGUDihhU0477w973xFHlzIUrzfhu3vDbMGLvLX3xITwlkk4ZK8+ZeJpxWjrHXUniJwSd5eyK8/n7Xa35Z0E5xxsawv3niB+dkEl5G6jc+YoZaNAQhmm9DGmraxwEBRVo5NhTSBpN6+nRxVJtqMaXcTG6MOMYSfzpgO0rTxtTz6ijNmEqcPPk3gp47yxkBnr2N6x7ZOQ9kzJkAZEpna2gIIhnf5IULjTi6cMTEqw2rFuv0w5RA/QZZcyyf/VtYi8lf+oRd/8BPBW2hmA9la+djIw7dnTbxnfsF0/lMIYhv5J37qxSfeMu3ifBE4I/nkc1mj/W0JjBHkk89BcDGmwAE4hQTdammRY1mnWlJyBhtCkRu2ucAH18mFLgUKnxk2NiQqVZpPXkOC+PmPTDW2AhJRsw0Eq9nmGRPDfghvuTYRuLQwn7yG+2zeuPZwEMgQhIISh2DcDV0yLZt0w6Go1f4bQSu/PYU79V1TbtkwnrchordsvRzVdTeqOQ6CfAgVBgezm2KKEi6OPMAsvpbVBEq5lkdfkSW2geka4SfODMbJX8JZCNdphIy+AufUL8TE6QY21CndJd9QU42uZWEe/EXKsUYW8Cw25FRvYD+ILbMzkFATLldWW7hGREg8ttSuZTWBVgv5ji+4HfWFbmhr6IWahYgQoOBwV4ttEovQWPQVAMBDiu3vDHkYupbhHd/S9FX7O3EAZC0aPDugXjCHHnKyGQxGCDkF17IoN18Bg0YchjjNQS50H6e6t0xnIeQ6JcoXYczk0dvb35YkeYDDMDQZg2tZU8oCQLtafuN5SCDXWE92e/T2bvLKyY3NQ10QN4trqCIQWQiHmepoIVvTa4NUQOWMwuFhXai7pmhgfgcWRnY4nIbMwOipc30bbbVHg9bfCqNbZj6fab8nzLCoxLoIRXl8DbIoSCcaDlt53A6yqP3jiY3y7d8J8wRsGkszQYHI4hnamKyLq63K1xgI7bfxCQ0F+elHzcit15GvU9MTxIz55i/ByghLz/swt9Y+AfAgNB8kx/LNaCEbEtud/JmRHys/Hflpyw8YGi7BLMrXP3BEMGA7BPnecF5L76bzztC75byztqlpSa7NJ1/+xu/7n7/+5//Nt8wjoyaskzTzDgzDrfxKAOnEIN/aCRZss30S+eeLO2AoIM8mzfEcY/BujFonIiETkWVLZJwVI+g+u6Hg+pB1GqlkMBGBjosG2wnBoO2KGV3TtUSdBeOUNse7mWIM3SsAQveJwtv9TNN0Z5im6T4gdrq7D4pVzO5Dgkj0sMANPSJaa6eZlOk+KjbIu7Mi6td9THCLHhdQoidEbe51TMl0X4/f/bB7RmyZd88qFtKcoBydE8W8N4jK3RuZoum+SXB2u58nNtG7b1bgpPOCiTQv6nq5qOs9yZqa7l/g8gy7XS2yahv2jbDsJXL7RC/v2zfglW8WOjvn4LoMvldh5+CG1dC+PQvnBt77CnsG7j089wFAGQUDC0xuAg37JHTZcuh1zNOWoT0PyLo3EwPj86DQ8SY74XigDfs6hH4CoR+X0I8htMDdPYrQf8GFxtvgaYR+BKEfltAPIfSDDP0AQs+40B3bsPcj9H0Ifa+EzhC6y9AWoU+60NY27AmEPo7QxyT0NEIfYejDCN1xoWcs9+OW6lBQ/n8peurvTX7f5//KV33d+YIyDGJ7aIC6odT9Aeq+Utdin7oWC3V3gLqr1CLxqUVi3VZOOC9ur/m2QVennNsE5ipf41MKaOE1B11PdMHEWWqjwhmhAxNnoq0Ay9MBAybOGluRCQDhBmlidK3IJgV4cI9EsahWvDJmZPhyjMkzzytjpxwChEKUgswpgiHt9hYKQSj5bNL4pUwaKymuGnuoGncEUmwrOOKY4h26ZAqXzFaZzKLRZNbKZNqSTEeTuaDJ3CiTWXXJbJfJLLlk1stkOpKM1WQcLONiWKaz5tLZKdNZdulslOlYSWdG07mk6SxV6ay7dHbLdFZcOptlOjMUYFuKyL8vnfXK2a6cUPWJ8rA7ChlajJhGOWJaeFmGs50NK3FSnpu/lComDTHekMA6SqQ4aa0FRorssBLiBYkQQgSXN98/WcjOnzik/ROHnFnIElHWcSETDRkLwBtDjuTJW7qjdgRTfiRPn2HkkTx9LpPqfvYU3orzBqxs5Le+HCo8w0TI2zZZ27Z7+O9LhbJzB2X3DsreHZT9OyiL0SBF+rVts+SRYMsge1mw24Kmu23wLo7Zn43jZ9VkY3h2I4zNOECb+/JhPhvDz5rJJu2kFM8yYjs71O+JWYy+hLmRTeJn3QC6WcotQTvZRL9nmdyFDKguk8B/7kvwtTCb4h5jssN40CMeDqPZ7IiLdjGbZmYJhUqO9Xt47kASjLobZofxu2my43jrI0gGk5jJTrgkLmUnXRJLYWZZCpQ2zMb6PXsYyoZ9PMSg4gxIJ74dQx2tFQIUxWGOpGenST4p5Kl+zx6iFvkEPx7hxxPy8RCU2CfsBDpmyk6V7kk7Wbqhlezc43a8dLNT1T0ExRGYQ5oUK0lTYjyJ6vFD0C2ZsUNQKoE+Zr6WAOu4CRmWU8pgWk/kd0N/t/V3R3/X8OtxGFeVvnWAvnnAv5tE8+2vDW0934T+DPaOLreQTneS+0N3iubWku40rTUn3WM0gZZ0j9N8WtI9TPNnSfcEbUgn3Q6NoCXdkzS5lnSP0F5U0iXnz1I6Oi9+OeAT4Xj7pTCbqBj3E70MFvPWABc83n53OKBTf8hTlX9l2BZZ91xUIOSYAg2swnOIUlLGdin3ZAaMkfWZ+n7COOM9Sk8Z9DqNei/TQ0EsvqntxQQthv2uM+ZT9JwxvxbLy1gCUX/PvSPudRiaXK1V7u8W9zIkkQtx78R4YRP3KugruBis1PDCxoy/Wb7tId0lL62v8+iLXlqrnvsu+THu3fIDy4ScZnJNVGYznjEXFAtTpF7IFBY5lorJnKjgjAtnq3BzVbi6hGtX4WaqcPNVuLaECxRq0+Vrq3wdk7nKt1Pla6t8HZO5yrdT5WurfB2Tucp3tsp3rsrXMZmrfGerfOeqfB2Tucp3tsp3rspXmcwyaqTP8k0RpOeDe51CGrE9atv2JEBDj0A+grCj2VGR07kH2Av4dAKfaD88u0dEek7ZaUvI0kmciqf46ZQAra+nC5Jp+6gaqU9FzAeTOhUJH8zjVIR7MHVTVBzIoFldAO2Ehb5+mQK9eEve2AnkQrki/k3nhwlgZin3RogTuDxh8NdluqZu5LqubmS7EVXKTflWxIs7tkF3c6/j5h7Jzb2OD2H+r4atyDHkG7Ajms+132YjuZJXBYO0lCt0d5LBRdVl/bKWFNzu7X8X6g0ryHeVtiM0GKzIF39FaLtCG3en4thOwsZQvi1xgOwa5HvOA3yUJYnpzr+Q0UKEHT/Cvh9h2Y/QBo9XxglfDrTcD0XLX9IrH3Q2UJOVX2K0Xvl8swlqUVI7Nsw/NlKlBIN9kSQBW32xxIOZvlhedmCdK6aATv670xLvb0LvLN//jQDscdUX3/6NYEENWsK75bxtGR3OK3xs4W0Y4W3IIwoY5O+YcuUK83eM2xpZHO2/CeX1fFsYGC9LUWv54gedv03/aunv0L9V+lHyF9ta8nw7wJCqg2NW1yEVy5CqY0jF+BCDI7f4wSPSs7V86YPKPKnTu+y8bXqLD5Z8GEZcRUTLT2sfLJkw8G58sGTCwLvpvHMScQsRwTl9sWPjvFGN4nxOy2xercxGUtj8UFnmrQ8NlHn7QwNl3vmQX+Z890Ml7yjM+7CYmHhzCM25VyUX5u+SkagPVbV83//46cODHxc/7H18/4T30ZMnyZckVE+CfdvQ3YJ5Kmb5xoeP6NsMwv/i5GCeW36exXT1sZZvf/gINKHIfKzlH5Nk1mUUxT/sRtfOh8v2gXf3w177fFNTx5IN8984LDw8DtlvwYcdesim69axvr8nzGpPD0evjJuBnqtpz0V8fyCYk3Rd/aHogvRanQac2uK6JH1Vfyi6LKOr/lB0VQZW/aHoOiXy8m9u2zivVV3X/tqwG+M/dOnqENe+e2yQr8oZDPZE8h0hn6Im2lBXlCj/u+4kkt0e6h6D5pkEOW6DfE1jTtl6vivkw1A/E+cJG+Trv+zW23q+J2QM5w1xnsQqrCHGbT3fF/IRWKkSp8VyoSHGbD1f5AWte8jG+ZaE6GJ90RBHbT1fkhBZbnWaxIPTpFZOE4DnZPZoL8vsUdvtZUftUZtdmc6O2kM4xx+yY9b2eKM6dGU6G8N1oJcdsePAuRm34/bIlelsHIylXtaxE/YEj/i2c2U6m8BVpJcdtlP2eI8XqcNXprMpewr3gFO2be/hHc+eujKdtbFL97J77KSd7vF+ds+V6QwbyOSzWX2a4aauZJG4Jq5kibjGr+DlDa6xK1lDXEevZE1OgrjUWyxF5tQx6Rxt56iXwhWe3Zj6tI2mbTKNJ7fGtG1OCzf+Z5s2zg2mjlsN8oJPwrIH9fWBWPaffr5W+jYv94tCX5F1Wv/muD9Ngxmz9CVZHN/E2PxwgFn5w6Wqc9CSKF9zyIsCFUhw9smtN+DWm4pb/7kg/l15Ppj9XDwf0NVRGRMb5bH3kPBNsQlvtfCQsBiqjjmOG0CyFElEClwZT+CKgoy1F7MEAlYY5smzULatex6RpMLLkbpqzlUUWTwAAFPDYfblfpbcJpZEcrtbZ7xuCktuS//eWSpT82T5cklRA2X5SklxMAUN3OliAHUNV4OugUtg0ssatg7FgVo/G1EkgtQOUd0AtJaCHzRtqycABzVChGZN6h8gbtwTtIIRO9xTWASacAfOQcLgNYpTztOfCva0pUeBo4kxc8bcsFFe/PvwjHm7czwHaM4z5rr8AKDASVICvyA8Y/46voic5SU6d+H8Yjr5WHIRDzABpShx1gGcEn4X9feG/FyXn6vycxmWUCn6+OORiW+aW3nIJ02eO2Mb9yB4Bu6CWkQzPqF9kNA5SLAHCTMHCbMHCRcGoUkhpJ6V5r1vPau0OcDxaIx5jZ2n0PYvLYG/FQr1ZcS3Ekkoeht5XV4WeDesvMOhJ1T3LKZcrZtiCVlMs1pef4bQrTVq4S+mdO4E8mQumjWhzj9BQRR9mlDnH11WtGjQEsKBRROI7kyYzy1kIY+vczbN56/ZUK12pHC1z0YXxNU5G12Ea8bYM+YS8IJaNm19IAnFvuiWqi+sqPrCTqjqC6GoL1wX7YVAlBfmRHdhW3UXCtVd2FXdhTXVXbghqgt10VyYF8WFHSOKC6tGFBf2DiguLKriQlv0Fi6I2sKuEbWFNSNqC/uqtrChagtLame0I3oLF0VvYc+I4sK6Ec2FRTMITr+s4PRWlBcuifLCvhHthQ0j6gtLRvQX+BwnKhSPiZLD46Ic8YTVRTBSMS4jwPTUii5kLUxUV7kQqe1U9YXpBUa9KPDSC7hh0aildzZrqIqrGkRUyPcnCPn+GCHfZwn5/ihRIU/3C9sA5prAawPYx8ZEaEsISe8A7GcY+n6Gvq+vxhiBG1TCzt/D0BlDdxnaMvTJvsofApbIxoSnd6D30wx9lKGPMHTHib1HePmKCWOf8Cks5UODg8gfZ+gxJxIfAcIyJnZ/AgFzmwIc39awIgrwPmRIuDq2XghKYUhncsaJPorJmUr6UUzOVPDkYnKmQigXkzMVSDn01nycciiunYtmW5vN8PhNwVXvTgnIe/eQ4L93DwuURbcjIBfdIwJk0T0qsK9yjt3CZCHAa/eYoH10JwWuFodZjs0xAaYFhqkq8BDhFsBZmBjEvrgImRIM3SHC53ZHiJrbHaX8YJdgGPUumQnAV4W8YlfAw7stSht2Bay6K5aNuxGktMCreGcoGB1BKSxNu5QqER0pKHxYoqYq/jehxJ0uNmw9qpq4IW7CojhrTtMepicVBABI3qJihoIPZJoSi1oQsSGWAYlsAmFfsOEglDr23dSOCgYqwo+KEjgkUEYE+RTUEaeqngJmnEbL+r1syCnUQy0Vezupjb7C8wIlJKYNs34vS/oVmHBpAhSlhT5bXUMRPBtY2ljqWeyYxQagQVXu+LacPJr2hK1ruQW/lTGdmnrTjtM8hH4ekc/jTsUeGKR1rYmgu+LzmEMEaMJisFZJgFyN1mKrBCj2alG3k1RzYfCGBpfqAA0eVWxemc7qL0MbdHugOvXbGaxnZJNQjnLVaWh1cLzRJJyy/aSdsDVXr4bWyyZ4O0e4CYcYMGmnbc1VsKEVBLiphKv1K2sOi8arSgO2kV28IRdvTONJLetoCzTLs9NZ42UAtAMiwTsJ3s4ASp9N2iO25eo05Oo0pnWCTJim5XADJm0H6jIuwoiLMO4iTEiEWr8y8LDhl75lD9thl8CIS2DcJTChCUg1GhjEtmWHrkxnrZehirs7UI3W7ayFBjhkh10lRlwlxl0lJrQSOGdLkjWHecDFzivcsJ2ybZfSqEspdSk1XUqJpiSlbAGJH++oz06/DFZraz0BYlDE1yJIXxk5UFMxLQIWZF6HqFvkPw9d8M5fngHevH4tC6fVAAVgqO8qO5s+I0G8k97A90S/z73K91i/z77K90i/z7zKd6Pf7at8D/U7LhMQVsNCnE/mHe+UeWUaV1JBVaTxg5WQMH2QNLSh4CsOUQQP8oY2lBNnWIXHLcTZ7kg0K7HdkaVy+VDrHUAynREv7HcArnRWvDNqGWOOLe3MeCi8KA9hLwv+WpjP5RvBYOm1JIYlB4eQMpIi9J+oxH/qxP1tTcXy6yKTj51ftICaTuWp6LUUKjZqV8hTXexYEREk8tpfKlG69s77zYIXZGNNQcvW2Hc11MU399GijwT/x/z0QOETa1oAmGl9MjbRrRBX4fkF3oSDGbMxD9lbAhfxmvAkT+aRHu21ZTo6xHm0166YKXthtuyAOW17x4ObBX/sCGCNoLYfqfECsUQQW9P+KvS5H+RggL/X0rIN86gkFm3acmUX7Cj2QChH1FQeiESZvPQv0u4br2WOBPvioZid0DA4u/LGVQYBhJXUowoVoefcivLm/hVnVWJzXnRMkqcpDQ3jhe2/TRJB2mxCkk2mz5i6w6XbmKdAJ3WKiToVPrdAjucNZzqYgS5QaDPIgzbgacP2Dddp/5m77KFo/j9Lf3FynQpan07D+i3qseKheuueBe/kg450+j55StRZ81B0o+TuLIYle2cpLPk7y6EU3+CMKeU3OGZKBfC4HspcR/rhuWgON3yRUg7z6PluI5fjYngtjwDQF+Y3n8fRFKq4RBasLVD3PxFZnljsUSvXKYE89wtZTQw3e8T23YidFw5Ej/J4AapvMNRcdzahG2IkRbJ/taw3aoIVHBFDNkttQyIHjwSbp4ggbB4J/oURyL/PhM9TgqkGiNm7VD95lSbIN6cWiHScEmIgkgYhF+ftef0FGiIAOXwhq7tvdX5bKL+ZO75V8aJXiafNkqJZUr9ZOCu0GJtTVVFcNDaIYB+UDcKJeAoLBhviacIm8n5wYVjtOMZsCLTHF5EDOTgA0AhgWa4DqzcPaL+z6hFYnr5jMKR3Gwzp3QaDF/1VB4MsDW5ApIQTUUErFA7Y3gtgPJQA0pFbKqQNWh+rmRFZ4BfDa2RxcbHI6hwHAoihsHpuyQFiEJBMMFz0cTh8vtvMAzFh/vlspz+mgiLtwwsiSNsKCsxzC/kuDbUasRiqYNCyoTNZBoZ4XCkZd+A7jLV3jaAvJ7YlrdHkeLZtSdeUuTE7ScQsOJhpZ4hZjXRKZfHi/jyVNOt5eC0bejqex3AQhZOvfp6jHdzH/TctlEgnobQ2hUd1RtOwa19KmlKVf8G25SZpUKU/UVgAdnO8soqC+GxbsZ8hzRItoDQqR3G3hFB084XEHTTXusM5sAPqVEEZsk1oIYTPd0ckRpyNotrsbaKaQCd+GL0ZofYtQTXXbmMUFI0isgM9m1jtNA89HD2pUdTwrRqF9UJpr9ZQ5Zrr1ZF43nWoRFe0cZcjWsD1b9W5TYz0ph3Noy9kKmX/6qImtRuSOV3HnMYOvBMtdCOtJaUowucWtDEVJOWcHt+xqiXe9+Tgd/Ma36PP8t1grqMdYrRDfGCFu3uxlrEIhYimxmd1dn/KhMktK1sG4s2YnWgh3/88VeViYKMzPoZCj7RCAo0bXcrWaaHXJtZkqXiMmkoGAisYsXd/VqHLlpvuTLnnzpZb7lx5sjbVEyy/XJBjteET7EVxXRIQY8Mn2MviuiqQxYZPsNetOxTcqA4FhCXWUwHBiM0D0XJ4ViCIzQPRSnhWgIfNA1ERnsUBm+7V8CxOKHSvhby3pVkk7aV9woXv2hmzQbDh9s3Wp8fN6K2GHpahYCJ6faI2MHYu2j8PGZb5aypBKo83SxuAp8IRdUJfc5TQySaFsKIECzM+IBRKmFEbP/mqEmazwwp6ujGfGR4Wq4tCJdDXnaick5VzqnIeqpyHo3k7bkWTnJKDYwDz4BksyXeOiJAMMcbHbJJvOwJwxkHYcgRgjYOw6QjAGwdhwxGAOQ7CuiMAdxyENUfo2CMkrDrCEdUtEE0lcJAwpJqQJZyFDSHRv5kSrZxDoqtzGOO0aXnabdojcqhstr+SoLbzwtks5oXTuTIvnM/leeVczgtHc3FeOJb757tjLbEFvjYvLBdyLiao/ABRVUiKgRF8CJzhw+AMF8XLsJrFQ7zD7XhTHrb/bpa8IfhX8xY3gqr5j0Cxx/AVUgCnoZW+MZ8l7pyGvlcV9aGMvFu8VHCMKLd4poc3Cw4jpdgeXi840pTS6eEhg4NRKe0e3jQwXJVQ78nrxv55YUF3O1gncfSxKU8IdVpNlyUCZwRL3vNehHpTzgl8GUo59Wmdm1JOEKejjBPtcxuCMNpxHtNjXnoZLGGYpE/ItMABVsPKQ3eIa3kq547UnTtwMALkXd2OsVTl7lST7SSWTZOlj/VsMSZ228eoa1p/4dXD6E7VyLmVB7IaDKFEiK3blcu13J8kIf8Mosdz0efUDk1QJ0ENDq9lI3IGiUWD96uf5yET+n04g9S1jrFkiIUUB776QG60kdGXctesFh+nkFcLb6rwRsLHqG7sqpvq4hcfyDj0DyOvmhiqwfNIgvPIqE262NZG7DAOHuHzXeFp2QA6vNfEWgrrCYuTo3Ky/Grp84Y7i8RSAIfyDE6S19vSifXylCE9q1HUFkmsh7H6wbOIVnlIqtyuziIS3Zmm0Ry9s0i96uRh7MvDWD7lLFL2cySjVGo3ImeRBGeRIXBtIrldNcQ4hcyqmtss1dpIrTLKF8uhpCYBUwlYcwHTwYDmTxow+pME1PNKA+eVsq0C1SuVkufLyYI2elX6EiBPTy4i7+qmk2NR4GdWfmbkx8pPR37a8lOXH7kPsYnD//Sdr3J2uAnqUlBthLgbYSM0BzdCc3AjNAc3QnNwIzQHN0JzcCM0BzdC42+EeqGRxSSSjTCSjTCSjTCSjTCSjTCSjTCyyvbBRkh+6p+u4Vu4mbS/Uk2EzstGkXFHxMvufOlcEqfw15Yr+orS+YhckVddcLdrRvmagVyGbQrX6Ptik9xKbwpuZkKJhFTZZLQCEfO8+0gQDMvdmmxi6JlljUGJikglp/bPi8kP2efF1ofs/apGJm+e8sXKKUGUyWbk6KBKgjxOUBCc0uvz2RCelSCUng0DwAx4C81npyvDB1KMpm28TOGuecADDnkWviCT9qLjJc5/Xv/LGLqJtywgSopYiEhF3SG1ufcTNpqW/a1xu9uybCgISOiwSZVpOGM6eHR1YJ6xa0Tqg3stGcjij8vE+QWFxJQbXdbsEV2KS2o2BAw4CEc18Jg2WFNo4TQ9q4+sn1T9QC3x3Jg1bEurmH72Kja6LVcvlZ73bCu1NqOwcUtFu1LH0Pb5qrrYRliDCQFEjUEgDPwPXKrchcljszquiSztepNkcrintV/AlbPkrMS5uSBMk2sZd4Ead4GQ3BNzzdsIGspkMHm0wC2J+QOcpryfgpvNO2WorJm18FmYcYipcnY3chHflbydHCB3y5U9wcpeMs1qT6sBsKoQdykCY/vLes3dmVyo5Ura6G3DtH7d/nK5MP3kPAWJfrJs1L+oUdmYb7epSma9y5j4VusmTLiUjZu6LtBjMUQH3FmYbEs9BUM0wJ1/IVfgTr6QFdAzr8gZrM+LoMH++W5bDQfJ8ACSdkaLr3uRqpzuR3i+hO4q3uFlsViK8R6JR5eYAh3QOaWt0Yhd0ZAzbsQzbjTQKv8Ex80XIfqXh8+IeGHNhv0ve344pHJtjOfIWgEzHTx2Tr+N44YMzvSZYQOgY0zhlo1bvzBqarfO3RRjE+Zp8nE7rIQAS1q1CNF85UIxI3ruEJLKZxeyVFqIUlg1aSE8cmR1bSLiZYk0M6703THexrvjwl7v8ky/A8EPQ9ErHvu3jNiurYsK27xotN0QRba1UBTYdgHfaih61aXim+lmghrJe8WF7j1yx++eooILsAkMZa3uY9aQhzKUxaKIS0e04S52HxBuQPdBqsIAo8BQ1upheWToPsK8IReFi1L3KFkP3UflOaFL8ZhNSEcZyrs8zrxN9wnmbbqv44VLNPYud18vLw/dM6w0UAsMpWbmmLfpnmPepvsGkQajrd9ZUfO72n2jvFV038TKA8XAUNTmzSyC6fIathh1522oYo2hPYYx8UZIM7wJgkOAEGgBTQACRefxyD5Pg7lFdkxlUqYR4fWIcEYinEWEOUY4hwhv0AjTYtriKMI/ivCzEv4xhH+c4Z9A+Ndp+KNiGuMIwj+A8A9K+IcQ/mGGfwThT2v4I2Jao4Pw9yD8KQl/L8Lfx/D3I/yMhu+IaY7DCH8c4U9I+JMIbxm+i/CZhj8spj3aCE985HEJP4Hwkww/hfCHNHyjtNhOdGUeDg4LqjM1v4TxeaQvNwgIg/H2Md3n2R+SYgUNXY2CnyxAcvLIH4rIKNal9O24MizG1/Se1JQ8G4LNCWbuJedt8xZ12Xk7fbCPrjqv7YN5dN15Z/pgHd1w3tk+GEfsbvrn+uAbLRGrUIbQYR3Nx3VGnRDD0id1mFqZpF2dMZyFS5FMeMqAGZVO5JQ+pePzXpml9+mM4WxcjmR9WNZZuRzKtGzLtNwyMi0vyqzc0lm5EslysqKzcyWU2dmR2bltZHpektm5rbOziGTxKXSWFqHMUiuTdMcMzNIdnaWrkSxVq0Zm62oos3VGJusuJiun5zFdozhN1yJZ2NaMTNc1na6zMlv3dLZe787rGpVjHOhbMTtlXaHKs6asKPoi3ZK1TeE9h6T7ikJfnodl/RDc82xEVjJ92+ZicqOC7iwwqg+pTFcDqAdN+yYYhv08gE+/mYkO2/MwW50DQXr+QNRqCE0i6llEnUPUcxr1DYj6RkQ9diBqORgnaKwYMZ9AzNdpzGnEPIOYrz8QsxzV44j5CGKeRsyjGvNRxHwMMWcPxCynxxhizojZXDFmzJgPIubDiPnQgZjlPGvTXDNi3oOYpzTmvX3aE7aj9r4DMcsJexgxjyPmCcQ8qTEtYmaI2T0QEzO/RSG2Zp8CR0XFTOQiNdEnM7EgN5HMRF1fWr9VM+ZWqEfQemYIVBWUbDpFmTQlAq4I6yrarCnRegsR01VESFOi0Ip8biX0WyLmInvH0HavMkYBHSXDC16GF6sML/kZXq4yvOpleL3K8IafoWOYexkuhlWOS6GXpUgZSJ4roZ9pEVa5roZetmthle96eDDj5cGMN7yMN/2Mt7yMtwcy3vEy3vUz3vMy3r8j45UDNTZejY1fY+PV2AzU2Hg1Nn6NjVdjczDj4kCNvYw3/Yy3vIy3BzLe8TLe9TPe8zLeP5AxNyWvjpFfx8irYzRQx8irY+TX0ZNZX4/KrPjmh2tCFnYNpVRsWLIA/MFtSjnrwB+CphS3DvwBYkqp68DvPlMKXwd+45pSBlvNYuSzwF/TgnEXjlsCRxrYmJLgvxkbc6t+U2THAiytTr9iMSwVLJbCUsNiOSxVLFbCUseiCEslC5kCc4AqJMwxTWOlsHmIR688eGO4bgiAl7hrckqRDAguBDBBvXXPgrzJ1skNqzkpdZrIEwF1OR+JcDrJIpdOyTcnlE66yKNLcJFFJ3mu3Pko1aiXSoEwxPXZ1YD2GZqiutASvYchUZoYljP2iKhrjIqqR7uqU0NrpfZ/vcrM9XtquBdlolXnlnhm+j013ItK9HtquBfV6/fUcC+q3e+p4V60R7+nhntrYiO6PVibquVhIXcVvy3triHtwWHt1BHt51Ht+rYMhrY2/qhr+RFt9uGyzYe0wVuutZva1I3qhCEDodVaHTIj8qoJlsnQqUCkFznykmrkJdXIS6qRl1QjL6lGXlKNvEQlytbgpIRSHny+r3r0Qpa+IfgXxqZk/hPQEFdwCPiABQXpnhYZe8BCjF6GyTsy2d8QYNRCmJ+3nTVTSatojydkZ2fASrCpN4pr7Pi02jxTb/NMq80z9TfPtNo8U2/zTKvNM/U3T45iKExVT/xkT9qk/fcFFUjAzoncIy+IAsHDd0TBmZPXRHhWwqyDkwrAisLsCLVSAE8UQsW2r3hB01BcKQrAdqMNwINKnBwYuWWU+Wrya/QWvjvxikCJL0iOhNLwKmVEsd1a3nmBE4YvnSm0rA/464P+yhMVLAxtdXRDJ9o0XAnzsIdCmZHroYskwmiIIdbQnTBUYiOuW2BjHSvh3vrPZiEHAo1oDkGVFW81GDTSCmQWUS5uLA+7IyrC5Sa/ShPL+j8lvOk2OoBL/GFlYls0PZfxIxJkFo2OnnYtLsvlKAuw0B0383YM5RlBg7dzAe6tDzT6CBp9QkVVhrVITuQMfCCOXAiKtQRRCz0DFqmaJrUpJMvk2wC1fgdVewXrjhAO9MwwembYTugjmPSM5F+WisUSZK90QS4sfldBHidr2rYkMW4DO1rOt6ifRSL3NgrBlahSbNVlMX6GsGLhQndERnJ3WgZ396gM+O4RmQPdjkyM7mGZK91DMn+6hLu60TVi4UjGgT/VIligkakGp5tqjrysZDfVHL3wgq9W5DUX/LWmGt9v7z7dmv50ywM+kh6ccmoDoZxypb8+6K88Bzo2QMcGbgLV75xyGumOKVcfmHItO6QM2XcbE4lp7sVIDesoq5ySRatHFtyDgsohE3tk3xCeKiz5qnsRNaqMsFSpx2SEq0pNICNsVSrNiDh7TNUSI7xVqoQYYa/SqCbeHdcgH5tvmAXya2Plt4ZOPjn28mfYg6H+XssrI77p/nT9XD9L5BztbCxzFaJ94vbzThrLey8w+WKEtlqJTfNW46bCq44qYGpbsVDHFN50XBFLJxS0dVJhWKcEWBXa+bqZjdIAmR5fRsinxgoWy/EFBw4afZvlgWNMPDi+jNlx8eD4gsdLenB8wcMlPTi+4NGSHhxf8GBJD44vhxzPWcGCIxxH+B7QPicSVGPnRKpqXE28T6gB+EmVyJpSKa1D56IbYlJ98xRmiuHyDNlkCJBS1oNSFZQJoAxIJRxRg1gANik8mrecYErWkGeqBKtP0z3M8yWhXEub8mwl7/7AOay/gPAqpliXRa254AkQUBqiBdGAltuvhsRCiEiWMGeVjBzID2+Rsk6qbAAOAN2akwORBmz9dt2M3hrmLBK5HxvIvrXDfUuvKWIbKcjGC5EbmxhAEABKnmiYjLtD4MRtcH8ADtDGgx/kf9rC6WcgeEb4lmwnRNAeDwSjDNdZyNpluM5CNjYQrtIqFQVbPCCklWqp3nZmF0QDWM70SpxbED1gOd0rcf4atIFzlTuSX/20GaC/oDJN/oJSYceSZ/2L5DQoFXYsefS/RKaDUmHHkjeBy+Q+CPDAkyrOiEraUTZuLxt/6ZxgtwJLJRHQFfcMjqGMN84pQJGMn4vU6JsGwFBA7DZDHGKIGaVB3nGHL66CYCXisRtcJcZLFIQ/hJTvHkcR4WkJfbAfyu+W/m6GFfDBquf+bnE7w1Jwr4ViWQpuZ1kqomWpW8IsIqiaWKC0VqVi8EbeE5FDZ0D9oehST0QM6zKyAX3bAy8eU6ehlKu9jFJ1OuWALNvDewBsgLWUcqOXTQsA45BSFsMezukBlAGVtBT2suMDPYSRB/CWSXbOiIDelL0yKb1yAr1CwQfyoyerXpnQXpkktKT0ysRLggDF2TQhctoTfk/8F+mDcekAaf4paXtp+cPS7NLoHWlxae8j0tjS1EelnaWVp6WJpYGPaetK2x7XhuX6E+WLlKVYEi2vO+zfEHFWEC/CGdOhLZw+ARZUj41a13L6ratvtj9oEkfjBwzhxbIDseb6gwZyqljtgVgzA7Hm+4PmcqpYquE1UEI7UMLKeM7BEnYGSmgHSliZ0jlYws5ACe1ACSvDOgdLODtQwrmBElZmdg6WcHaghHMDJayM7hws4exACecGSuhM8PyxuYsdJFoDCoBO+ec23j7HNt7eE4bRTUGxjwWXPhEgfNy1QtlvRf6+Lq76WSI9GAKhdAS8ZkZ+ZuVnTn4uyM9F+bnEjbZUnZ6Zvw0L5NAAT6jenKXCoqBJEYITZHGhNgQhG8jPtvXzxjRumq+2KjAAqfVuneLt3SGKrHcbFFTvNiniDukKG6r6AFBcwId7gLi3AS4TSL0tFRrVGgKhKPIAGHpZqsgcqQcum1oDfCPjkWpqixlraFpAx/cC3AJ8MeJgRgYSKXATvSRFmZMGMjaVk4NNrenhfTawMdv6hrjqRA6CS8CDwJzbgDhLE5woWMLkaThQZl4AJh6VeOs8DfP7svqBTARm32LY+qFOmNzK995hHgmCp+P5e4K8aF/LglNBvvTHoUg6Lv9xSNsw+Qoc+X6z/c6wG+dr32Dk++o3DMANB/m6+7LhHFvOsXkw7Lb7suMc2+9Qx+7BsDvll3cY35wFy5r/6LF8vN1PZNit6O8yft/53m/5xU//wc998vxZYPIHT/7KB77tkzvvXfnIT9w6i3tX8OTXrP/gb3/g69+/9koui/Bv/87WBz714d/64fNnYcA+yBfvZ6vvwb1/H927cO+JewfuXXFvU8FH3Ftwb4t7k48ACeBSl5OFSuH+q4Jv+sPf/5UJAm3Clmy+GS+0/4EiRm3E8ruuv2v4/cnf+oYf/LHvX/3nQICG/11bv/gdv77y0Q+jNgUI/+4bP/XB/V/7zfeCsIJs16T4yyyCuJfgLsS9CPeKuPehd7as1YV7Sdy7cO8R7XUtXnDm/X7iqX/5c++8/7t+8NfwgrHC4u9GVfF3Ihs8+XP/+Bu+9mu+9x2fRGm2I/mwhd9vXv+97U9svm8bHzZB+PmP/tuv+/WX/uHPnj8LkwzBkx/5rp993y/+0Dd9+PxZvKYE+Y4UZQ3ubXGv0myJuAu4N8W9AveGVhvuda023XWC1kZlNc4/9X/v/P3/5vRHGuiFdVhvITi7q8ailnrf2ECH3f/+0fNnceUPnvzED/z0133qO/9HFHIX/j/6g5/de98nvu+Xzp8FqyB48l2f+Ic/8L/c/vD/xeoDInV5RsYG3Evi3oR7UdwbcO9Ladfh3tNaw72rtWb4Jsq5Z7xa/N5Hn/gC894h1GLb4OuqqWpRoDS//0fv+tV/9Zvf/anzZ/FuV9UGpVsGYf9D//Tlf7nxb3+GUwOE9/zhP1r85p9+HzplEf4P/Jtf+Pqlj37XTyLAPlg7G1LuPbjXxb0L95q4d/jGJO5tuAutP9wrWn/i97Y4N4w3uL7rO77xf/rKd34ag2s/5NwIvbmhv+v6i7Xvyfe9/O73/9GPffx/Q+mwCD75T77+3R/5/e/9kQ9ycoDwmV9b+fGVP/iBnz9Pbawg35MiYGXMd8WN1THfETew2/Jtcd/AqBHndRRmxi3F+fIwJ0bo9cUPvf9vfOvr3/37nBgs+25Qlf1yuTc++SPf+v3La/9P7xfPy475jt/b2PzAez/+8+dlH/2Ff/5z++s/89F1FH/eq9957rZ58QCLANX4FXHOoDTixA156QHF6g3yxQcUpzfI92fcxp5vjyzIxbYq+a/1futvf9k3/JvzvDaTJdD+ByEZHZvhc5DhXNCVLKw09MJ89Y8hMMoNC95CvXXxrtELm3qKhB3m+yRRxw4hFj8jEa5KhCX1XhfvsnpviHeFXjADXXpUmItECjdfcVvJcrn/vMP8v7y9C3xdR3UvPDN77/Pa5+hs2bJ9JPkxe9tJ5MROFB6OzQWsUW3HjhPi0BACX++voaE03zlpGxmTmq+ypBDHiIQQE0JxXC4cHRficuPWtLRxW4JFgGJeRU2hmEdbtU3BFG5Rgd66oUSf/2vNfpwjOYX2u1/ys87s2TOz57FmzVpr1mP46O9/E1HYvkRHyZnOjOnOjFNpxjco42RnxvHOjGZnxpF3qOFTTz7yjffd/ztfpIzDnRmTnRkTnf04/2BHxlxnxrnOjNkH1fB3j/3tv/z53LMzfMh2Zsx0Zpx5sKPr050ZpzozTnZmHH9QDfPz57/K89GZcaQz43DaxjM8H50ZE50Z59/ekTH39phMmPn0NJMHC3JmF+ScXZAzsyDnzIKc6QU5p5KciUc45+SCnOMLcppJztyHOOfIgpzDC3ImF+RMpC0f5ZzzD3TmzKU577Hzk+RM2/7MpmUetvOT5jxk52dBO2ceUMMEQ8dPvcXOz4KcUwtyTj6ghi0MTNj5WZDTXJBzZEHO4QfU8JN/+JfP/tEffO5eOz8PqOH7vvLpp75z7J632vlZUOb8/Wr4s2994B+PfuFfifIQZu7+zjLn7lfDh/757O9848EHn+MNtaDI2UwOUaAz9yc76gy3e6azyPT9avhtH/jRoY/97W8dpIxTnSVOZj7MjRzvLNK8Xw0f+drh1h+cPvND3lNpxr/znrrfIr3J+9Xw05/4/L99+nf/8B6qOxG/Of+2tBE7CTGmbL5NDdOJ9MBX/4qjGJtmUF8nwCLAi4XwQWz7vcK86zkZR3xElnVp6/8ttEbKkCrP5Fmq7HAcTxUckizrOpMnJf6mT2E3PpknUdVkrh6pTQo+RWBa8lH8qk3qFL+dQYCLk5n045w+kufgGEifynNwDBKC2eAYjmnmOay9w3EHapw8m7M+Gq9wZnPWueMVzrmcZdeucOZyCWuG26Ec82YQcFkGD9KtPPNpuDrJb2H5L0IA4molF5IxzqlcWLRXLT6Vy4VluoLJhRWKKpULu+wVTJVbYiWZSYSmRj4CrpvDdIMK27grnJOUc4RzyMznTK5llQLBz/rssg4eHnXJ6hj77LWxyo7ICnAZRP4em014NhNsf8Pr5Joae7cKwjwLm1nIwiovx2XoWa+kOTLNQeA6xS5HoVs4CQdUObpmUdqD4gYuyn2yQmqRi0BY6eBS4i4Nrw9FeKgKdB6e0aagSAl9IHiR0yU839ZuXeOYGTiG9v/ZU874KgIx6zY5ay+mE8syM9Sw8tzYjizDThZSy7NM7kCHb7Q0jHx3muxJkzUyPvQykXVKHFnH58g6Zbqt4fgyn5QWtFk2W6hvUtNp8lS8OThrBtLdk5n045w+IlMJ8CmZSoBPxhJg05QAeIeFsVGFzfNIFgs5xRA/HJZRlVwfsIYxxVpcxXERCxyvcTXf/BU5hOEaLGR865cPPoT1d+BtGWKTPJZ2TWsq0mwEmNe02KtbU4jfA9n3SizqKp1rTUURmwbmEfskB7MUaMCzr+fVyCm0mnCMBun5KtRaeQFam3CkVqC7xhrFTqlsYa9OvbDEb7EjwTJb7+FKAL70+2CPj1c9eLU0thWAw/1+XYP66wpo5C+HRj6bHcA+t0rCFBdyGxKmeOaMoC92kfNL+vIEfvUW8IMuYhDR1W9E18EupCyz+C3QtbGLzTCjuOHDjq6G3VqHgS6GS3RXuFSH8L8fLtOVcLmOwhU6B9UCuuVMQZ5uvD+yRgXjlwDkZ5c3ovw66PQcCWK0SpEka3dGPueSPl/ACu+noL2QN3Ndde3XWctbRP2sgxqtspqp0Wp2s7umRf5cfd2LtejT/S3y9+rrNVA0WaV7+WaSrxFtD/NmoB4uobAHpNaSmsCFq9Lk6jS5JuNzIE32pcl+Z0j7GE4uM5zj0iq+S7boOQXtCx5XzuovruNrmEvgFDpP2XDV6aQOJWrWwGGgidse+GZYrWv6kla0vhmtZi8Na3RNr2tFG5rRGlacOpnjD2io4UTrdD+BCuTFNb28FV2i+yxYIWNZK7pM9zb5VgrhfcMyDyGsYuVUI/JYqw2xniPFWKN4hXMXbr/OAo+ck/VoqS6udybkNaRtg8u5HmRMcgaS+4mt9ogpLuLuh7mgMIDHLYp+SdeJbUaQa4U5LDkEuAcby27NMQTpUoeO4gpbPFUgRV2Jn6FQ46cQXoofHV6On83hFbqbL86KAJllLTzU8ICQc3gYxEMtIq2lkpn061GJb1ZhPbZMX4pNdzm23xVUgp3JB/Suhncr8U7bdwEJYQvAjJMS5p0wIStuUgfxUNmkJihzkxrlx/24MIQTd/q5Ez+4oIU/9wKpENU3qddTcg7J2xAYgzy20xdu5kb28M9ObuR6WL3hqxUqjzf0cdsEdaDAHSiwH/j9/KUAr7A8NOdz8Jxizso6zX8wpuniPl35WdIi8Hih4ZbKYyAocJI4X2iRJsvd50PxkhAi5je8lB4JXSkzowiwBJu5nFNs5zLhhBtpwm2EN2t8NqfYoGXSCa+mOWdDnFlrZXZeseXKYSfcpJdykI4ejgjikT1LjYPdQd+phq2yTGv9Iqzli9kXySbCsLrFRQLc9q/UV/JiD6LA1WwqppdxEX2pvhxvr0D1jezKJFpObxG3naK+ezpA2EwPax/wU5mfEJHM47U5q9L0lzg9reqb1Ayncex+npNnkX0GZ9wZBXCgr3xScovT9veUTJv7KNJlC4yoiAI9aVtBWrRMyTOqzmHnCwQYZRAF9iqbNAGW6eWMXctQYbBvCFuvSN9sxvSStUUZm6+mV8Zvzojk1Yo0dybNrWkd555Nc5elubPZFnQrWjHFKG65XqZXtqKaXgHjnCYXJm11bndK20z0Sevl/KwB0rjzRSClImIcnyPIJM1kvtpXusvKoUgpxMMjyYtI96OEx4AfdV0vSWKoMSpSjIrIhmsj201dGStxMDTfytZZgwzEOxmGbws3kbJAWEPIIi85JVZYR/PLcNCRmp9AAE3SFOCDYgUiDfe2dD9CURKpw+fFCkBxP07LGvIvZdQ/49hjYxlO0jVYQd2rX4RiL0YbvCWuiU+SNRzMDWWuRJlBlOFdsZkPl+Uw81mNb+jL0Y0r0NGNrPcZbeGPNpX9aC8sgC7VfRQ58yq9BqZEl4Ee0716PawiL7xpNqOr4DOoHyZG63C067AZhRgNouasQ3Tm/tZUM4paU1P2irQfyHsllV2hX6BXcdU1FG1zA0wme6ndF2CqIjTey19GR9Y2o7XcEobTByyv8QG9Qr9Qr+bvrWpN6T7YUK2nTzejF6I7axEcusZ1MUxgUjvMzQiM3UdxPmnEqyn06AsQuhozHmHGQ8z4Wp7xZjKQLYidjYGs4jGtocChL4TN6TKqeSVqDqLm1XFN7vg1MFvtp/ChNIZVFFv0Khin8upEWJ0Qq7M2rini0NRMM0kzG9ggSNKc5SQFV5gJwqtAMXRxpCNQMl02cFLenOHkAKgSTq5HoCtObkCwLE5ejjBpnLwCoMjJjYizxskrTS7sMvmwBI84ILQkU1Kkix5Eod2yXXbLYi+stPvjkpjurCPuMILDtqBqcxz64hSb4bLW1FTYR5rs0VpMUAQk7hODuEJfgrf9pPYTrcPby7B/lmnAWLhKX4K1XqcvoxldjxcDOB56Scd1tY4AJSEa0csRiWEZkxEb6PUafRkmfS3aYguz5TD6XZacIGFNd5n8neRGc1bA6SFOS6jYKdjCQOXsrKiHRcIiISKTDdRhKQ0kChNUs7kOO0+j62GPvuRoOKAvOxqu19HRcAM867DTPO3VyT5gFZ3MRJDHEyuwp3OkD0DzQ96Ya3Y+fSpyXAJXkMsbbPYcKThbnoY9RuTv1F38hd7Yo02kWLPWIgBpqeFVTA2vZqvXNXbfxG9r/PYF/BZBN7rItZbSK4/qdYDmtdgXIdFh2ISX8Qbb0Gpiyi/By6tg40irh/IaQTBazeYUhU5Xeh0Q1lpgv5DsEvVyHOm0OVcg3kaT47ErS2NzxwpRLy8iwRI2NtPykqanEA0wuBCYrr+AISwSZ2gU0WCLMVdo2ZzWFIefX8EQF6KGj3au5njzerkeIOS11qJAeh1cwILNpu7lb3EngM/t3EVr8RVqtZ9BrRD18bmglxNKoc738xCnHXItGe8ouNqKT8KVqTWW0mTEzFGV6DTM6cuo09ZxUQ05EeeAhUaVntjJGiucsDpk1TpNEs3oCq4K1wp6SZq9nrM3I3tpmn3lFqsFGeVYVY6zL+dskBc5Nkrn/AHOn6H8IM3fyPlnKb+Y5m/gfCYyYjs/YSG7K+b2Jjxwe3owOzNXZ2aGV5ZDTWUO2bXZ8n3Z8v3Z8sn5uCpbfnW2/Jps+eSgqWXLvyBb/oVp+ZKRjbAEZxgA2uXg2v8lUkvHC6RhW7G8n2kW66TY4mIFurQTvA3U/0Shrp31ziDzeM56Z+Aa53yek/oaZ84ma9c452wyuMaZtcnCNc5Zm8TNKiXJ1mkS9GaTm97D/OQRftrJT4fxZIYa9hrPM8cp46xILtY8M1GkGictQ3qeGzguk67Cm+UcvnSES56xJQ/z47R9nOTHU/QoN4rZblI3mXGsPAPBCgJogJrN9U0KES9osqICyP084eS1wswV2ZtOnrlVBFJnGhxp8jCVh2shR+dYQanYpkLCuYP8w0GeWEKYY82lHGsu5fh2NsdxunLZJm7j3Lv4Zz//wCjOusag38P294j9hXFdtpGmzT9pf0/Z32n7e8b+ztjfs/b3XEc7szZ/zv6et78TyvbH/h62v0fs73HV0R+bf9L+nrK/0/b3jP2dsb9n7e+5jnZmbf6c/T1vfyfsckza38P294jT0Q/47s1vUqeQ/1bcc7G+B1b573IUkq+0ST3OGZ9zKMPfpI47Jk/SyJw57tSDh+XFWokrL6zzLpg/Fel4BlQRCJHv4iJU7Ut1KMRa5XzSiYUPPN9cDUeBZRIwRT6X8ZMyZV1i06hF8mt7F2vTrYdFwh85M1ck1kl3kVosdKARf7kVi5bYb1iBbJEVR3nKs/+wAtkkK44TlWcvYgUyTVYcaSrP3sQKZKKsOFZVnp2KFa7AcaU42lWenYsVroByjuJ4WdIcWWIjfUpzeImNzCnNJCf7cY+/xMYQleZ8NyVXamnmum3cUIQf6w7XwME1OesmH9OFuu6lHa4LdXL3A36oAMXG1fR7F3k5oaFJUBUFMnBHdKwC2Z/3UdaM4kjZzdgFOfQBdsBmJSNl7PwweTekSx5YseB079WSumHOdTPZFq1qTUX9R3Xvsaj2KKQ+RK9HK19PLp2Pd7No8aju172gaPs/CC6r1kruCJrHwF/0f3AqrPk6r2sIHNobfzR/J3s0jY2Y+ZDJ616MqMB2zXZ5KYttmu0BxVk1NnO2i0tZbOGs7dpS1gAbPdulpSw2eB5scvQ70q3vfTTq1X26V/e9vj9s16rQfdv+5MmvfPVvRr/+stthUgV3k1HFPCOurfCRNwNzI89OLTMtBMweLzp46pl8cwufTzFIIPcscs9y7vkkdxa5s5zLQIXcc8g9x7mTSe4ccuc493CSex655zn3SJI7gfmcKFDuuW6oyudJPtMsQlU+v1aYoBFV+KgmB+GQ4wLt0OmZr0cFhBWmSw6oLBdo9WmFQLb5tG6xALgGy5ACkbK8rAUyV9YkNI9ytFRckkQ+BTJbFnQCRlVaIq5G2vjiGH8H0nnKQLSjXtbDJw39oWP8WIYsgrBBi1/sbDWt7USZX0zIY+wBuxS8XcKSHJKpKtOOeO0cazO1oDpnVPw5axAwrez3rBkHZU6qFhdHAD770Zz9KMfVqOCWsRQ8CHvPgESjFHKW8Zx3hXOqDPeLZYjqyvXIYrpkZ3gIHxxZXJfJnYlza9ncs3GuzubOxrkD2dxzce5gkgvz7jN5LGpXTJohEkdUxvMAP5/KY6m6iErD88l8PQrwXLMEVR6y9liU5eE6OlqSSLo8KwI7AmLncJ6MxNCThB6bzJPBPvqc5E3kYVpEo0vyzufIwS/mIcmby5FEGTOW5J3LYZQ0t3EepMunytc4sxSVjWykYm/RWyH2w17MAf8fpwLgEByGCvIrAON9fgEeIc9vivbNKX4DLsFCUs6+meY3xCfwm4p9cyZn3WfSlQTeFOybGX5zTthTokaiPLw5a/uOPNjO5pF5TnImrFmW2IJzNi+Ao1Obd97m1XSNOBnkTSjO03AUZvMmbd6ArhGHhLzDNm8Q0cls3hHFuEPbCx1AQQ5/Z/J1pvabObvSXj3yk7U5ksPdj2dmvXpUTnIP53AB5JmzXj2qpnCRq0fL0KRXj4IUMnL1CGaSZ7x61J3ChlePVmDNvXq0pG3VvWucOS9edZq5OS+ZObvIK7IzZ5d3eXbm7MIuy86cXdKe7MzZxVyanbmOZTyi2pbxOIHd/nQVPVJ/aFo3EHYZgTMoczKzjh5UK+gzMl1Ij3UlrJMIu5I4liizKdOlxKnEMC8za3mernB4RZO1nCWL83QVz9INXrp+M3SBl67cGYmVS9cMJnnLdbpasOlcoRes00kZrxNZfjNFtj9ephXsPyCeGVqm5UneZLJMy5I8mhdapp4kj6aFlmlpkkezQstUSvKOy3iZPHIvZClQu0weeRmyFKhdJY+8DVkK1C6SRw6GLAVq18gjR0OWArVL5JG/IUuB2hXyiO6jvM2ZBaIIF7xK8frYlbkLtzVWX9ezq3Ebro0odSuCH1JqD8IlUmpnOvdwBHIegVBiXoU10PiqJ8ovyD3sMOKl20barQ5j53PSZpxTjMKP52zG5xXjedJnwrKrJLw7ncXHaWdsUufL/Ms3TXPl5KapqZKbpvPl9Kbpfqk7e93ZX/R0qIGvoosnuYvo3JxHSTp+bD913JUu25Wun6orgimxWGmZqbVYb5kpulh1mam+WHuZKcNYgZmpx8Q4Sa53znVbBFiB2OUDvpLjl5OyRCEWuxx3EResAPNXRTo5m+vBW6HcLV4iYCHARYIHsqB9Mj9F7hcQ9XbOycD3KbyArAThCWDxc97JQPo0vT1p3xa3wMAihfkz9PaUfZvbAlOMFPpn6O20fVvaAqONdB+cpbdn7Ft/C8w70h0xS29n7FuY/9i3TQmNmmnbx1OkFHTWPh0nraAz9mma1IJm7dNJCaWyGft0RsJj3TmHokOkHpYRA7yr7Sloe6q0PVXbnrqTp9dVyJmOVRS8jy9aKb76KYfvbR1cuiJQ0SmnHnEcQnK5WLYBsCs2pHWXDVJdtWGnA47/zNG15yRH1z5vo2tPKI6uPak4vPZhxfG1jygOQTEtOcD2GckBtmdsgO2zNsD2rA2wfU5yhO3DknncI5JDbDclh9g+bkNsn7Qhtk/ZENu3cYjtOzjE9l18CbTfBtiWHGB70gbYHuT42ps5vvYQx9feyeG193B0bbiP9cycY3XyBOI1umxYm7POZUBOQ2GLHMyAio4K1rsMEem1qMhmpUQ1RyXrbwbEcuSTt6aMJPRyKBJeASWtDZpa2QiFviuhW3WVTkrHotJ1KH0JSl/KpS9D6QGUXp+WDuwN3WqUXoPSmkuHKB2h9Nq0dM3aZNZQuhel+7h0P0qvROlVaWkrKOcArUtRuodLL0Pp5bFOmC09YO0zyyhdQekuLl1F6QClu9PSzEYDW7hskXjEZTvFwy7bJE66YY7OPJdNFc87YZ4KzDkIJm3OOFAzK7P3gGlaQp8fCOB1yVoHbiEDKE1e48UxIBAYO8H2kM12p8jU8xiwEiyiyN0YW+ZSrGrwghxp+RiFoiW/cfA/Dk7Q0wLo2oabEMwJ5nixFbvuEcwJcnRd+orQ1nFfnkN1t7gUMYAcQvgYc1jY3OD7PDNbAJp+ryPzqQmwtE7xrB1wAakNdOHC/hucxDbYZa8Q7HnBs9l38BVbE+m7iA1pttjRHcO9sGwke4njDrvssMKztxRYXKZkrDveuA57k0vqBJk6ga0TcJ1aUofdziV1apk6NVunxnV0UoedWyR1dKaOtnU01xlI6rDvi6TOQKbOgK0zwHUGkzrsGiOpM5ipM2jrDPrNiqqMOxTY81py9CGttpiwrtjiOPBpBPg09nsa9T2N986q1dJG4xI2rKdteScrVUsbh4tSt7KNrLRxuChFcbgoRXG4KEVxuASjTCKABaNNa+cqOTznYZtGfM4jNo0AnU2bRoTO4zaNEJ0nbRohDU/Z9LS0Nrd0JFAwc8HHAgX/Fnw0kEKX4ONhCxnA8RFBfJXgY4j4KcFHEfFR3H9F/BP3XxHfxP1XxC9x/xXxSdx/ReG1uf+KSDPuvyLnQNx/tYUMCfk4JIdH3H9FDo+4/4q0VLn/ijRXuf+KtFm5/4o0XLn/irReuf+KNGG5/w60Y322bpt04sA5Obq63nxnnXfxo1BUJFVF7wZ3yOS0anD0y7yR5M7faWSCYBZsbILARnBmB/KPNmn38k/AP7VHmzjt2eeUjSVQiB03ujpP7ouSZqgRKk8ep2x4Chs9QLWFxqqWHYoKQHVIJUCy2/tMJhwuSTsOz45DZceRp8I0HIfcKBXg6v7O7HA2889d/HNcPtoEFcPjQWDOyIn753F41hzHEXSpPYfb43FVO8ZlXT52wy95M6reTju6SjfwVUQWY0UCK+mlcKUgiuGhgRzDuQpz50YCd5w5CkQE50gepeD+qcROLhGsiXSnEMI8rMLJEuYKKsPkhwyxJ0QyL7k49kSeBuAxkDC9wiFaKIgJ2qLkXWnyuOQ0rUY2jGExXnAndjSWNJw0y0uISizgjv2MBbo6FQZ+hoD9xYqkIXJ81n1g2gSaCn2T0wJaIiUdvJ/jTuWMewMNagxxXClkWJcNW+uTM6lIIVak0hUrJiOXSHaS1K6KSKJzCKOutb628tR1G53UBj6Bz1Lt0JnYnk3jUhwLg/hJG0mjC9CStKU48FpayY8d6FQz2t02vhJ1zttNPg0lLxb659HFF0Yaw7PPW91LwmN1H2PRNPxcJV6qONN2EqFH08mniMPcSqKHSMURYoXtOsdDAs7xa/1N6hHHP6FkbjRz7tbY1ZEiZxd72Pu9Rw/srjmIYCgzBd8LNQoqAhpGHouf2buU9Xbi4fdW+NUkWkZSMzDNoBZcPohdS97Ez+yKyno+oRZui1s4AkeFSMxI6w7lAqGEiBwcE14y8WQpquTAVtZHC7V1hyWsmhQznBo7Gzd2gdjiFs7YVhVd13EDE84xHOjt00WBAmJ/0tpOGjuUHrCzxi6lB//DWQs4c1K2+HsXZqvJXcao0z7TvAXJvMlj8TMRaC5Tp9zWHjhU5iWIJ5IbuiOZtEI8aUzrWqJNWCLHzktg22PXzdm1HbANDibzJeL5EgR1K4QWG8RSsm8jP4KwbtPC71s8H3+/VFbL2PQtaER98KcGqykojYU9MAXROTO+oz9chjhwOk/p5do1+0dgLRRCLO/+slH74JCF/c9CaTDsx27eF0IhwqdIdSMIHYnduEr7ZvyNOl8Pa7qIgO5V/AiKH2M92C7VFb2M7hhDBf+fzpDuQYTKO/VKUiMjf8PVO3UFT2FZV3XJOHvj5y56VslzNz3L5DkT72ytVqFY1MhDw8Vk+rguTV6SJqM0eWmavCxNDqTJ9dqPnRGup+WOVkO6uRnEPzjYEE/7+WkgWoMnqNGRq5xI4/G8bDXD9XpAU8VBCuEBM4wWwnoUSf2uqankHEoOQHkWTwNxyTvikseTkudQ8jLooOJJxyVvi0s2k5KzKHmpjgjWuO817l7Afb+VnzT3/Yjt+yD3/SxqR/oS/k4Qf2dP/J3DyXdmUPISvY5LFuKSO+OSk0nJMyi5Dtp69uaGSw7FJSeSktMouZbsIkOoLEyoOsX1IcGaD8+TekBf0gy1vlSvRcnL9DroZq7XUTOM4MI6qIc53YWfXh3o7noImmQJO6vNa//6CqiOVbhhLsJ1aFjWPlFabE0D849Qds5dGGmdzEeo9ZpkyOGazKjCtbrfD7t0jQmDiG5xotXWtTKr1IfWOZNtUsZTzK6ibNsynk52uWU/IuOpI09P+BqMHSik0VAjhGtZBY0vS8ItYYWIxC/QhF47lWr8LdGr0xdrWPO5l2t0py/0FF1i8dtsjYhrlEATlbTLHkFd7e1sRwk57YZdhBK6gBIKMUroSlFCqX33rta5UKT7bzV7r7JAQ6jXghp5obIAKqyBkIVyHW8Qck9lt5WwdkODdqPaHR2uTmFtqNEBaiBcgjo5NWbIMQQuodQrOCokk8BtnQxX6yJAqcgQRXQNbnRX8KrUjLOLgOOnHhn1VNepp5o3hYue2uUupYuzekqX4lWDu+GoKybPWadCO/zUR/fj/hekLIzHJ4Ji6lIB/ZfgIA9SJdheg4YmnkrwPEhyVq8oWq0zZMPo4So7D9emd1o9ZcvS+yQ+koTZMy/AoShmIsgVaTtVWdqehOerL9oqWA8EFbBuW3lU/mdKaoB99+pGhN6760hOWYDNo/ZMfmd/tBwZQVS8M1phcFGhdsHtKUiWIMwT7xhUhF4B+PQ0ikhQ3ojHuRo6YY0oH7nrMAsBx7MN6sEJGXnbK5IeoDaWN25De7jUyCPboXMTDF3xzqjW9lE36g7L9NHuigCA4KO1RT5apk92Zz/pom3XfrKMT1LUxLL9pBt2+2biIfjeMnIEXmb//R3KTExoeNv64Tvgb+EedMW9RgmUYwN8XFpc744b1zPn36EGlDCz8leMutuofZFjQDy41/X7YS+VC9eafLiEYKNo8nophVDRxev6w4JeS1hWL8G/nf3hOksgFBjUSlCWD3UvXIpxrd7r+qM+XaqHlyBcpC4xEon0urDHOg8vIL5uv3F1v3F39oe+ruil9XCZ7ucme4yLfzv7o5VG6pVGXtcfXqpXIkLvZUYQKurLBhOf26ql7tLL6tEqk78zcvSqGL6OhRv1St1lxt8Ygc/HrhjgkMbrtav9OmTlsCAG6F3BaG21LoVrKKDgGjTm2sYiR28kUViLdJTVkL6cvbXDatdW9fQG1vIHt11FVJ5rrWN/hz3xRlpv0K5ezX7NdaJVEsd3vsh7cECho6vYV1U9wPtq/XYKIOpw2MvI1RvgapRruolmyhqMbI2+hPGgRSOX2sAO0H4EvQnzo5CGAKiLoPkIAbmuBI8gIpvfiCxaSWpI7WO6Xb3M5O9MauapphO8U2bbdjNt53ReR1Bz1H0w99eV4LD0sdYNWDhb1+7XWZzdi0NJcM+Lemk9qpr8KypCL2XzjCoYSmhnNiJXL9euXr6zP3IXdNSx2CbuYEG7HR10sr0rwygb3KMZN4J65+jlpN1GVMsSXWyES3Q1WooMSZxvzdwzIYkxh3F5f+RQ9FbjNqyvCzWkV6RF8jpYWITUk9eJqm/cQERO8DEs7NnvS+MFUvxXM79VVNG4GjX5MP+86HQJo1P/zmhpBzrtgl94NaS7aPYJsy1dBLMVLTrtuig6LSbotJig0y6gU//OqKcDnVYtOq1WhO7hj/ZcFJ1Wfyp0Wv0/h06XMTpdTagUB2Ze+4RFVwOLphlroObXiDRhz3aMuixFpcuuwylXAvbMoNJeOMUAclqrNWOedXoNBW4A4unmMPONaIVx9QpCsBQEph72XTgE6QuBcfFvZ3/kGMgMgWAvsQLU5Qswa5/2gK1lI1rJ6HVlil4vox3Wz72o6RIJeaCvGrpqNKEHSRDZp2ssUXJt+WgVkFUaeCy6FKh5hy1Z0KtItfVSzldxfoD8APk+Yvlp13YncvVlfCF16VQr1e3V0U4b5pyoi0sWoL4+ivWu1yZIohdOUfRyXdAr8MoBElyI/7JYrUg1nODdGbSyjhEKKUFScxVd0A4hlADoLjCjursB8aPuBtbrjrHeshTrGVYg9RtRns4a1khGb5doF2fxYugOtl/5tq4B4737YhivuAjGg8b7knrkXMfmYuI6i+h6soiuuiiiW5oWKequ/58R3btd2QUSmMUjFaReQeF5FGQSLgkzG3hYwiSxzyRxmYJZdMPzPYcvgD6/9nmvdUFxH+r9e/m5ap+VfQ7ss7TPS+1eFhybPgITW0qUyFnPtaCXxpQzHgJ+COihyg81ElSH+ThUiQ1mkAcLnItj21d22ggHFab5EaIFktGRMIhHCwYDQy3zULuJ8g/5FsKo3SD5KEZKmAO6gq6FLusKDwVxoCkCDVEzSyyDQPEOohLQFwurY+8QJDjmWB9s9IznYG88OH6u7Y3HhwA7FEzYxYiqGFG1I6iL/Zj9VPwhhGHhKMQkImCSJkhiVSGzjUHyp5T0M5zR6AiNHxcNbXPjUowTmp8Kz4+zC7SmGtIVXE3o8p2hB/MPCLexyrpru50TvnDK20nP9BVZuFaQe7PsUpyrMrlBkutkcmvxtYW93rGcut8WIsV+f+HX7e3FosFSrPjeTtG84zijalyOafFklBvWk4+Z+fn5+fzIBQwzMTHddHEPIxLnj1p8UIsnh+fj/8S9iXnOvLilHzFm1bh2zfz8955z6LzG2f59Z1dFmXHce5Go5tFQqFEq9bl5W2p+/j2cvMAyNpM46k2diAyHmsdCYUTZ8Q18TIlFysCUgoKomPn5Bydw2WJUpuj5TNHzW1vtlYwTemn4dnHMx8d8RObTokXxZ6CAwP9vu+rO+oZtH2mdbm07+uO/fuXGvz5xutna9stH9/3u90/+PpIjy9c+96cjH0Xyk9858uijj37mdLMFe2KdttH9tejvX3Li8NbWtu9U7l63+9d/e2uzte2ml80031D5MJK/oq//1Be2P4Hk/L3i4XW7nkKy8ir89+WtzRa4bp4uXOw1W1NVnxwwRa45fLmNH0YvtGtOUsaUFlNTkTiqyZrtZ/vpssR/GH6+00Ofh5vR73amIjd97U5pZwrKHvh/2+Fln+ttymdf3tr2azd9fPmdH78FI76euviBrU1I+1WLoxGh9Jc2T37s288ef7K17ZMf/siT7/un8OXN1rYTr3zvxI1jD3+sCUthoSWs+v2na07PuDsqx9YKM0jWf6AHcdX0ZNQHGI2cGEo98+yXnqS11sjbOmJ+9Il1O4jw/Pffe4Bf9A2L11C8Y6z+ELmObUZi29W3/0Lf6z4y8yQFo6UIQXr5VJq7xcFlm1P2/GzNrZmaL1u05suo5njolF1/4aeL02kDs4t+epY/rbiBTM2hTM1FPz3Lnx4LHdxHe+ZP3v7PPAGe+eiPvhIn//33Pjfh7qio9r4Njo9+dQn17bOPvOuxd3Z9u6NvSS6+4GSnhWoOZWq+bNGa3LcDPCrP/OgTz0xQPK0FM9SbmaG5RWdojnvhds5Qb2aG5hadoTnuxWg8Q89+4pm3ubsrdFEvtt175jO/PPjzzySoYfPPxJho8yea0fIEeFpNuFxJ1rsV1aaiXosiv3369lCpcb380XgPGdylL/8QcAzw5H6fgnEpAlgJOnB5isqiTKshdGWyHw1XALklH9r6eqawZD3bxtb/qA2fYpXXpiLBwgzP9NyN8ApPDr8IuL860jDdCBOGUqh5mx2jgFHa8m1vvMu58v7eY/+N3C4wRrFt6fZGXgBRci/3GdHXqYdcFW2h8Y/v0pccvffXt0Azb0VbW9xJMaVr8C/GHN7ExPR8/kYGFS3sN6XGuQpyGYX64oMpnxxLJz8uDp4GLg8dXJ1T/KagznQwtBfal0lklukJhh+CHhtjy7RCRIFyWLzq0l23S6QyuqGBoFL1VTp90C37XRXReqtMB7I+uF7HZJ6xvsBOumzGjOUxv1EgbzrQe6n9Mkh/ur3rj7rNHXdCY+SRK8CrF5nx8cCv+XUjiAIGWeRAD7FBpItLnuAQfozFsgrXlCm7RrTJPtO8oj6gxBN+hpSwaiJW8lwwtUZYJi6lCIIfvYEWI0iogAinIKsfI8okTfHrPGeZF6TDoOxcxD3T0P/YxwIt0QwTLxZJWFKaPC2sidoOq6eBddkONYCrdKERLjWD+FmiC6YXMqYith3R+4n5oaAFdPg69frIZ6IuZ2adOs1DXY0DROLVf3krWtEOLivawGVFXPDj6Hb0PKDFDJhr9YF47CsyA+VZxrd1OfhtGYmkE9NbW++1ST3det6PUIiLyhNToT081bguY5jLthPqUfsQavQbpEeqOMSK0kveFCm9ZF8jIrEJNFHCinb10jdhAcsQonC9AfUNx6x4kx91gT2FppOBYrVI6IY3VGJxkKWZA71weiOfqW9s2LCkxllsj+4X4CUTTeC74I1d2B8Y6ZOflewcDellFYEWnFARidDTpaRQPrJkqPy2kbraHcC4RjYpwZcpCI1rwGJlKKCpUNBoArq/SF9gKaaIaEo3Lcd9U0PaiZQuMqcej1A2IhomPunuhRsZXSTGmoK/lim+J22kgq0C/BA5tgogmYldRh4u70MuWdRuI1MO9gp1Yj55B0HyGdk4tCwL6a5n9jV7dM1uwzT48H95N5KwtESIj5WDarrQICBOsOgb3KFkxD/lLovUEz/VLmO8UJb+8+P6UGE9/Gyv4FtY+OnqFy6sPrYScAXOR4dkZjntRYrHn4VszHLLYs9GhgW56+UtTCA77rTNKHK5qiK3EVYzS8IugxRrSJq5aWFDoyrE7mtfD118BV1HVHeR7yKCE6/CfgKasq6r6QK5fATh+MDqZUHA4RODx4VRcc9tGzFUNG3/6cwDK9FFjlFzFMueto4kdGzBadHq2rk229GOxrAbTrow/K2Y/EjI0alDAULxZ/n0P8onP5S1j9Lpr50GEwBSi/TdFqfgk+U0BN7+oxTPiNgbyFedVks720a//MXXvuSr//Cy1rbvvPeK+7/5D6+9wIfg5bYDz3341X+/6tMvb2378us+3tuUl4Oz+eD5oLu7+56tzSZiIWnRwp7eTkJpR3utbbuI8/nUaXAyzarPDFjKSuG2pzXV0nJKu3HZra3mlP9pKdU4KwXJdeCMxZNZRlxdYGl+i5jjFBqVed/Hj4KtRhjGZBWD9zB/DcpJWYKpIvos/id5QXAEEV+7HCGV47NCFJQVUDP7bGTwqDxaVu1FjtIct5XxQ0HxG6HM5N/jSmccX2apAZnqqD4taC5wk8V9eKNxIHwn7EApLTjuvcqk2WOWgiMY8RIhYlmG1UN1RiDSVxqX8YRnHDMKkcW02MU3c2aoHkEtkdsYUIIPNIh9IAulVAG2DJQqwx6NUgGM1CjVA8s1StXgPIZSK+F3hlJ6k9KcWrdJrePUwCY1wKkNm9QGTg1uUoOcetEm9SJObd6kNnPqpZvUS2PtD8U+E70bWMFYuzdWZFvvrSQIcqFIaRcjJ7rKuLsy00Yy18jdffGZpJR8iZCcUi8RilPOS4TT+ZW4NwgMfPH1iOlC4Z9D2DZe5h0V5r6gxNkwhAv3NW5IAOM3ZR/BBYEDzlCuhbGQYIN5tBRCHEAj65Kq7RVsuYVdaSQqu8YZ4flBWGPik5wRHsH2iqeFPZ5xNEqt6rYhW4uEhDdYCZvCdJL5qKrHYGSc3VYLvGLdunFr2baAJNHjpCmncyGhsU28BD6QadIWTvpElG1mjBHhX//7SkFup2hIZHWB4jzdRjb4UZG6Cr9U/ENuxO1rx6ikYD4p6BAMxflFyjdCi4ZxRiLSMpdmXo6Ye95ysHBnJDkmpQJJMkrvFdVGtsu1HTwV+Afe9Ar2tTLlpGBvUrDGPz38E/AP3O0FSbWeJFVLUivjptD7EXjQoXnVaFeeGMbFXjBGiBuzz27ZryEVVe8a0jL1riElUY9DyGiebo021uy20P1YwXETaWmeJFG5VBIVc6gZWvKYzpnVdxs18kST5HPz8/+TxZxInv77dqQupmhDiETUuO3x5WLJX/7j+Y+1tj1zxxvWvrP1aziGbuz9ytdvuvx/ILn0j1b+3we+8CUk7/h6z1v++FemtzYzMkb9utbwz7x35mOtbUHfyugz/z2ECLHa+ItPRjP7kPzjP9v0qus/cBLJ4je+9oU3/9pXkUzlomQmMT9/+jlnt84Pi9eMbG/rrobWc3Oq6idnnM2Ln083m1N22N+7B+InNUoPX0xOs4lnv/SJrSllBhGI0Mn/27bmf6O0+fTrTre2fefd73nNpstb6N93B17+siO3k3T1GX3TxGd//kvI/edPnPrR0NNfQe4Nv//wCfHg15C7+U3/+rFTr7kdkt9Ms6uWvfjVNz8wubW1beVf3dR46n89gKJrXnz7t267dBrJx779/q/+3O2/h+QLf/U7D89d97dIrv37f6q94eV/0j5FU2WZIRLFo1i61jGSb3vmu3/4myx1E22f/7mnjv7p95prp1vbvv/0M6/+xVfePN1sbfu9//n57/zc0l9C8g3RwMEPX/96JB889rlnSoM3Innpt04ad/UlSN72xj9+ZvmLvomxvvj1lduWvOjgacRGb//KLxzd90/f/97vnG5te9d1O9/xvWv7hpqtbRt+Z+c/HRv4v5Dsce56dTjz/yB5x8B3w94rDiI50nf/lyvrfx3J8Fv1V5Zf/Dok33r3XU/+0QdfONS05EW6QJu/8Zuv2Dw23dr28GuurL/OPYzuDXz/TUsnv3svkkf+16d+5r/30FBe++jPv6r41NVI/vV9T931x+/6Nvp/3a+e27JI/7f9wsaR4b+7a9N0a9vt33r/t/YdP4BufPO//c2f9X7/GJL1dW+/44n540jWbvofte+oI0iW3t8f/c7P7UPy8E2rLn3glpcPNf0wll//3WktnyTB0F33niaZ/lTQolNwCpibSD+h3ezyNoOWbGl5zI/SiwhQV9gN/dWUfk5f0ht/tZSWolNaHsUxSJQtmRbKlh+kjKUIgvfLtoy7kHG/S/cyakyNstw7F4vWItd8Jt8wW+mgDD2+8DiTJzBLe15F7tsKuyopdZi6Utt/E+hG18xXdyyolSMy24igKau+EcEUfk5+nCOvtswpSkWyiYFNRdKc+bgNIWumbUo0aRMTFmshsBnnm1n6bbbIYOaszZyJM9WTUe4x4+4zczTE5lPM8Ag4ZsX5cPwpAYt+nRveeGgUuvDbCZ3wmAr37oEPzXh8k1sPnEaw+wufiiW4YrxVlj4tCUy94pJzW0e5JIbTjNKpuN0d1W5cqnCNY41eY7P2AC7ZUhv37BxGfM8jprIXU9qZajab7VgulSL0ezphNQPR8qu+zicD8P1/8Bx3VNJZT/8nEJFhEjzz7MyDb2G6+6L3cxXPLm/SERw427635dnnhq88NPR60NQJ8h5vEer+xDfOPofrO+2ZD3/qqXmQKWjkNe4Q7uG23f3SN7/4e1v+8WWw+tkmxOxzw1d+83SzrGCMk7x9Mvt2a9Oy49uee8sVv3jtsn9N5O04Pz7YjGQ7ny6z7L/3RCSTb7ZCImmSz7aaPp2caioCAzTF5C+dy8+AVYKeC0v6M9dbmXs9Lbdt/ETxV5748f0fa23b8spvHvrsF2dwR/XE1z/0vt4/6wG6uu9Vz/U25WtxBvwQzGD31OnscZBclRWIKWxNRc5U4qcDtHlr6hguAr3t8dUd2MEpyyuqqZZWUxcyQmkZNuiudDlCSUWU8lTa8fSIraYCqZnTtydXKVyuGVcR0y2mtqei7A3rVkuW5Osnhl906DT4cbPFMm9TmXFl6syO46JOtcgp6Y7+FKar6UFo5vPaa1CTkTNFjTWJ7HeamVa1Z5be0H8BDfNNZFlYwT6uX//WdXKjclwRpVWIgfhftx5g2H7/U/JWuNdLnUPelBE4Z6YkoSjsc9NcWPAmoS4tW+bs04TO3FbkNckMle8/rYwAAdL/gpGaMk2bEuYIp8xh+m3C/7Eyk8nrCfv6/NOZ13NPx6/PPW3RYfpakEyAfptkfqRzQBdNXKfrwvDg5GNR3szNy4Z5/8TYDTTuzA7fQ25Sg0aUT8a8xdqyJzNyrOpnJmte3FSBS++JCTWyXVPTI/hzLbNawW/JzAwO/kzrybhm0zkAMVnS0g+2HoiKwy9662NPXKC0m3aIxeGNwEtixLj7orw59ReEyYEX8+YkPyAkR3IY3XvgNN78veBL6rw5ZZOtSDQjN14UyQfHjJ2+M0/bg0OYaZt1ys4oDqOTT8frdjyeeVD+NK1NhrcvOJ3EfOgRdh2lnfdvB/8xS/faG6hfz9D38xkoe13F7SPwbZtyz8h9QF2fze+qQHPxUz/+7HO/fmMltZcAh0gk9nx+d8Xx284RaXtl/u5jl+Bap+duM5+HdS1VOGoJy+w2tdjQwv0UF5xwd/dreQyy8DyBTfVeerF1BDKkead+YlgfOng6rRcKnXvCp1jXjLBbOruDoIkRyXY02opcoM9WlHIv297/p/tnikc/sbW17Xf3v2PVp0Y+D6TpPvueRx99FGwGoQOU2/bKl//Nkn9+amtr2187n/uN1+/4NMq95l3RI+t2PY3ku0hS9g9bm+Ro3Emxv1bNJq0ozkvhny85xVFnLGfprm5WGtDyyagM0ilaQsTTUvOxAlxsz4/txrL79Kpq5qsN85a7bhyBYH5YHooqw/JAvMd+9bUZridU2s8gnYrSlT34Q/wlKMubtY8GkkJ33cqbSstmqCDRSN7MYRumUniaQF0e3jq5p63MzTv6QwU4Qbsd3aKdQV0i2ag6CnckwXFpJCr5ujwsXlNRujsjODxGYXbgxtY2SjVRKQri3c8dxayMhFUdGLnDLNmHK5ws2glJrXx+7IbnnZ2l5kkiTSXI4My7W/pTsOXPLTETwa4Lg7wnLnLztUSHTnF3iCLlPlcz9zKEnRYhd4CpSDBYRs7QvacjaKhzB2Y+9AEgrnIGA9n1Koxm2INygse8fVGXOf8DwkpRyh/w0WKmf0BniNOKvFaU12XGhwVz8geMeLrM5A8tCiyCv9D+aRz1UakJ/KaA4vIQn0w1dUmzYDlymi1dMKeSFg7bFshfiyIsZukHWOZCfifMHJc2536QYMZZm3X2BzFmFGbG5p2J85o4+9ST8Tw5rSjeGLRjuiy7ATdOC/kM1icKLIh2geUIq7j6o1Wy0BUkSxfwcpKoPjcF8sfDDdMUjG8vkMiaTBktu/GTMhv/SW7DT7iNaie3UU24DV8HJ0aJ4yiT0h/jli6S0vsZ1qP8H7IeaZG5raNR2XIdDnEdj7axHV1tbEeX7upkO9KmJibG7z2dOYUykogEr9zezzDmxEwJwxrsnaeenw0JseIs2uc1KydDA3Lp5nfKf4Ui5mQcMsIEbKSZh0Sxz0AN8fcLu5EUw0hq2ThxKFLD8oC+sF/FK6mQIUnxvXv6ff+4xDWbNBOFV2RgbXa8RVcN81UwvpKOQkki4Y4CP15Bf3b1m+eqKAJYM/fsvy6DNG5zuOipu3ZTW5/J17lgZ4G5O+jP7n7zcLUekuxDJsRyy/9c+8XN0EUvbvg2hu5rMhNuRPCoZOUIlaq3CLpGI8n1f3htQ1cwoSh3XOWEou3mhi9z+ENt1zkhhZqxlzfjuLsRYD1I6M4GkhuF2F5hRdJIWuk48iNlrwnIMy+MzB0SBzdGzMQ9bzm4f4SvpSEmxqGitGhUUVFtFFZ/ph7RRSEJVqUWDT8nzMGHlH/8SunbOfVjvb/O/7UwP4Q1iJl8iDqQM4ha7tfN/hH87oJ6vHN3JO+OeCTQcX+jkSOabwb2RcqceojE+ZEkI0/AG0xiIJw++ZCqR2oHtw5vHdr5NSgMkKAFt8K4KXI3qYJPSvcwwjLOXgi2pYafLLpjMhI55TKkMIe5k4UbsPiuXdB92Bf7Ipar7x2xiRGI93GmlO82wUgk7o6k8e42hZHI0WIvPoAhqbuNOxLJvWgHzxIC5vZnmTwvHDEGKi420ChnhyrioQoeKhvDwromHixdEFHjnnahuCDtC68Oh9FCF8gBunN3BL1U+lzomvfSbIRSjUMTWXv7Io8scdAHT+f2kgif5npAFfwQx4PkmG10CyAx9fjx0C20Rhf1mGT6aLnsm7fzhJOhEakn/R+ZVyhUnHonz6nCku8f0S5d5OGOSg2xTZXYzlZNPZHYTnqGSUm6epLa2R05/SFhP+30Q6LBuhPYWjVyB6MGVDkihyqKls4cofHtAr/hsSNNrFGZ7q16rO9D+q7iHlQcChkTOtiBDhwNgZuIC8KYkN5qj4pb0w/MZQlSHFcLc3p8N10C+fVIwB2FG88xFNEJ8btmQhG6X6NZoQcIHybUd9O8Tzy3tW4CmnGxD3vETMyuoRzM+D6w22Zioko5aiRy9pnq3ZjmvdrZC58Wch/8dZhldSzBXrOy7sNIgebbooR8dj2c7aSYI1j/iNTlDFzqy7sbOm/W7OjfZ5UrnHQ5clreyHodOhdJtpHWDiNXwUuYg7aLVmYVul3HbDk7+sGt97NazL4Eownt7eU+eEbpfLLRNSYAC3Kx/e5YuFSAS0erFC4dwJ2TwmXbs0yes3BJfC7AzhnKAl5Oy11QJYKojEHPQ8JDmSBy3HHtULrHJ2iw3qSkRWTabWCePIAnecYHeMIfEVId4JlBIeUiON028PQS8PQy4JnTIlJt4MnAa6EZ4Jlj8CxksKvAcZDgFrJnB0oKbnSHEtxA2ILxFmsDxChLaGlRVoLfADnvfUjRh9CA4ZtbHI1JlYi9EXIjMYosl9CrR7hXsGlEmm5H6abUNB9S+Ed9Rlccvj6VSVdiBCvi5iwEX1WPCmrczD6Muu6QOUcJ9PO7D6vhcZgsPvOwGp5oJhaMsw8r7ZsyjCHN2Q99+UPeG8nO8WE7qk/GiQntRxSwV2jZiCBMxr1/0UzTFyLpDplTnCTFsqJ2bqiUtNTFXZWSj2ZgT+mOVOgOPx4cap15WJGKp2R3QuTTy6E5q2vJ8g4CGTZ5Cz4MsmJ8R8XTXpjDYGiSsEWkViOkzYrraq3qvHnqYQ5Hcu5GyLXNc4x1vLjbIu22RJQmR8sbKhDxObsqOV/n8DkB8ypZzkONTTV0fiRK2nG5hKKuc593AJGGgtXaxqHe4JrBus7dUBF2NSLEes016jSToIG5MauLkfe1DD4szfi1xBDD9srmG6FzjeDDsg8K7exBa/zaikdsb+hRgVBB5V4hX9Gk4x+MUd29pM3oxR2X2gs+LKF0iR/snnHo2Qv7o9UN/AM8gMjjN1Skj4myk4WpIqj4KD8KgPBHH6ZNLCxNutgaK7vG7KDTq8PCIFld3AccsUBvSEnhhn6gxyP2+CYYN59/WGmQH2iTT/XjDykzjsTjDykL+Xj6koVch0jVfZEk4gZSP5A0vJHNR5FFaXLPJowmH2GPEK0zgENlP1Qb8yOkmlKom/xIfwQFTLtLCdBYu0FmMIWqm4FNyjW/9ZAyc3GPiA/ZKMqmMEJKL6R0IbW6kVQqYGaHKtSo2a+l/aqMvyq40+ibxRwcVkw0aCmwZxLiavHvy3h+tdqdnVet2AcgrVKWhHbsThTXWi9VkaiAnUrGgWPj+TYw9lOyhUNRFr6wRCMJCwdgcFpndY+F80wmcxbPOWa/dux7J3mfgw+sOpQiQSblQKVi+tyOaXIYWIk4YJLbwfHAB8EOPhK4EnD44YtUAtatE4BTdfIwa5wRI+l6FARPgfb8PJmg5zBbdBJkKNsdfegmjkJhKWrLnJgx7TH/oIjRwYkoiKQFkUuBpIoKiqS55BzNWQo9c3iSHlMOpyL7wiWPiUH6ZJhDx4aA00U+QJOidIAKPkBlhZAF7WbyqRd/fGUkY9KBatLYeT1VRYLgs0SfGdMyGVHRBKYHXsUCndvRX7flidRVmqOu0bHNTCDUeajNGg2diGLBL3rSF7oAzOjgB8tBC2LGRrBQbrITocbD29ux6+IQz5ewGqBLLX8IW3e5L5IJoyG1Q4wGczrEaAAngquLOQyXl4q5DyDiNaQjCxzLH/sJKVtFvH1C2aqUslUxZeu0UbYg2ujjK7U7LK7BjMXrAsomprxJYhIzT28nEsPba0kYBm6oUrGCIIhfQcSvYOJXsOEra5ZLSxk6O4guXXU3nT+SSkE7baRO0ZfpowQ82Q+gr3a+MHtA9M+PYb1GlI8xLKxWI48DB+SfH8MSDr4sgyguaxCiMFcRAU1ijF39kWf60YhnZh5W6xXNngcsRukCcm1Y78VOm/hY0Z6p1UM+XfIJKYZJceusv7yLgvRqDzNGFHAMn3CRLRtRzg7Goy/oXIw5AKHOYhCK1YQkIYFQtRBCHYs3YoU4i0wkRWcquwyhkkEmlwBqbnFAJYYrBVTnooDqZAA1twBQJQNqCqHOTwChjo5PVQuhucUg1EkhNObScjsqbgeEOotDaOYD6KSdL7uVtRWBuIlAoQAOEcjK5aKulXrkmQb3fPaYIvitVWeUXIW+Ylej4MeUvyDVWdoL4j9N+zs+RGJmEHUFCfXA6DLO9oCxnTaMrb2FOFsXrFynYBF2nhB2HgjbW4Cw8xiQdxGE7V0EYZOwtkpKjcxdpTyS184jkTpGMkgXr1UyepA2dt3sdpH/ZYSuGKGnJylpefOBytsl2SfyJ90nLtm0J/vETfeJG+8TuWCfKN4nqhOh22AZvFPcZKe4umB3Ssyp2p0iL7pTXPK/HO8USeQ3doqb7hQ33ik5zCEZLuayH0A37VQpS584GVLE4elUDPaKwT6WD3oMsUSnlBhC1SIQqhhCGedbCC2mIlblIyam6dElwKcCfHJRgk8P8TlrVg5A4Gbh0+POJ/DpxfDptcOn6oRPtRA+VQKfSltdZ5lIdxk+n0+uCSBlqabO/UdyTcFyTUsSuvyTyjWdWK4pmZKnGfa1HwvsP1+WeVK1J/VvQzaigh2uRNLsH4lEHQoNGABxJYnRBPNuUGy2ohpiCCWdbXYc1/IdC21DxZJx2o35DL3rsmRSLqB387yYjh+jUxnTBizUhMcRK9Z0ErGmRaNOvD3J8qmnDuqEYJWjXsdP1uIXrEmYB9y3FXVA70oWwLqpPNPXue0VGX98ZeQmsCktvSstRdlJ77rJiHIEnrkEPLn89gosDXHYW/CUxCiR+np8ChF4SvJExert6fkHAoKuVwzsKGjNmQ7R0tIVKsOqKGZV4FFee1YUh+pyhPedNMoqrDQTNqgZy8kzvJOwbFDadrL6FSeReSVSMFJnaWesVAdjtbDFbG8lXc/Y2xYLW95FYct7XthSnbDFs8iwZWWSTiKTlKlMchEw89pgx/v/BsxE3I//BJipNjDzsmAmEzDzLgJmngUz0Q5m/mKLkllwmUBd1X9+uPMTRlhc9Hx2F57P7k91PldxPMv0vIxPabpQICYrPaWlPZPTU9q9yIUCekEXChKnNFBi5pQm3C9xSid8MFslpRStJTtSitaxFK0bH6Ou3dGCzmlJ57Tkc1qS8TG7SYtce06LHXS7uupuNvGhUmS/klK0DlO0mQ8sck67mXPa7Tin3cw5TRK14wxvdAKMa9WPRfWbBfhKIrm8DE5I2q9DkJ6nFGjVV+MGATH4plXiphVcCY4ewkEFiEoUETTMyWCP4F5I9ZG1k1a058kU2mlYmamR+26ASJPgHhwhPLiiwI10YjvoZYAjygOdNKKdvUZZCYCH81nZ4zoPotZNpAMqOElX+vkMFrSIT9HF5Q0VtXiTBf6qFTQQCZ/IBAv2djSfwYSHs63uqihlu+3S7cPFuh33VDEVbA3uVcJKMq1MVVVcVXFVJxmnYedVTgfB4Ma9xKLkjBqpwAnc/hH0sahJC6EIm1kWKvFmzgOCFLOo5QwmVnhTjtwFmLicICsVSwBiaMzT1SV5XabKuWuTD6SYmLjvMlOgFhPngV5VjF4pXrJKMXGOMTEiumFU2aKQheFGK8HEZYuJLSlK/chiYrt23AmhcxfHxBl6NA9MzOUJE+eYHgUvFcGfCw0l4DZrNAs9Ednm0Yue5IUfc0u0usV4deGro211MyDQCT2+BXqqY8Emhnw/OImK8Kzs+pFL7rUKdWxodpGJfVklGZMZNfsTktEzzki/9sz+EbhLxNW0t7sfVpoUu0C7/gNlmRtnQtFjLQyAl2LqMjbJFexKQtbtLZwCS5TSlCo+OmJti45zX5AQVLvXVtTFaEoRH/OCSzuJBLsNuJyUZWHgEm0QIzqAy4mBKznmVdsxrxY/5lXcj8WB63mPebftmBfZY95JjnkRA5cTAxef5sICl+IXPTGPqCw1qSw1KRMOglzM8akuEqaGJSXVTs0Wli+glcVJSdFBSkp7UZI2LH5KUlJ0kJKLtIhLWttbRecPw5hqJyXVRUhJ9bykZGbwz09KPj+MESnpWjkUk5LxUwpjiOShGMaSogRjLsOY+klIyZ8Qxn5yUnIRGPMSBNYGY/5ii5JZ8BTkiJRcCHRJJb9d1KMSUlK2k5JqX6QyklEmJVmzj0hJZaVvMQ1p5XRMXxIpqSjkGMjkdoEPCT1TUlL9xKSkiklJxQIflSUllb0JW8nulFJSMktIqsUJScFQ77YJfBQRkspqrixGSJLARzEhaTVRLkJIZj5AxlA8U4JmiulIGV990JwKpiMTAQXIc99/JZboyA8lX3oL49Rh/K2Yu1N0xytv6Aei3SpMsI+uwAOCOtTiTsCyMKEux30XHhcdIZGQ/qgk/0cU0FGSPfveTWon4T3Ct4T1Dd0mD6h13Z7o87mrKzm6XMBHkTTuCKvfG72XvsM21gNqA/4Mki5IgZcLfGj/PrPmTf5rpLzIx0ljcJEWAV2ubTgiLkIw+yX48nQQ0Y+N8AtCi+C9qs9fRrLGR+zecevBb7tawA+rCE7ZM9dOhhZ+EZq148GTbCiqJcU1xiizr6aldK3mpLtOsO8Y7V1P+INPSj5Ncrusx835+Tyvc047DY7rqbTXINmsKdeJbIDQsB5My2Ba0k0sGmLX4E7wcWnPYI3Yu2VrG0zhOge6BemF7qD4aE7wFJwJwHUaKU0S1wxK3yNNN5clWp4/kKjTqnV8RUXN7QxZgW0d+5Nw+v1uQQ70EkcSvl/CLNb2mdqbAD7j/lUi6cu6bgHlB3coXfsy5LQUhFpsECL4lKR1gbYq1/69dCq9ZCpdOP0H9cETuTLKWUM5bsJ+7UXdjlW14PAW1nNDWXkQA9JEQ2NPkUsrRL4u1zn8NU0wmteybYI5s85+EVxqkWawrHx2b00T4/qbMCfjmBf2DGvvzeylVeLWI/YfYQS0vfsYvsokQKwHT0gt/KXx1JkyCMN68FlJ0xt8VgIoF7z+vPSbiudL88pR0GwyaMkU+xoDUCaLHWcBGAfUTrYRSV8OqJ3BDB2qHdmumdAjdAthavWObxxVlBv8uSQHQzXaVQAdLYOnWfG4UA/+QkJajm9rN/gSyUo8MzEttBN8WQZ/ycKT4Cuyj6AThc5SXtu3TC74KiuEd4zyJYJVhY1LBRS5vfbzmMCvSf8Tqg3G22ZyQNWIRKYANoLxkWCnHtn5/qJ0hzor7lwkC9MH6IMPe0Wq1wV2FNL+yeDr0EjqfGEkeq/i7pBKREdFmpIFL4IvysVf0MpNi5GLvU07svAt98a3WMD3AWIf+Q0VfFNRuLVOEKkR4HMx3gRsXCqDb0gj30hIFG7J/0palHEZ8L2CAyyKN1wgonLEyH31q6TQcsSIaz3t+H7FVvxrYGhCvdSmX7WzF2i5N/hNRdhkQAXbkxfYwt1C0JeDw0rL4LB6I7pyOZ00JOukKjuShWTEBbbNoqgXPU/RAS7KvnBILGor5amPO/yX2co11mhbyZVlO95iP03UAjk8ok2MVj4i2/a34nOWNqAI/kxSaqOgO0NstnaAoE0Z1M35R7BgdhNqgQ3paoXdSE5Z6AJzQHXAIRy71C1GHFAbunOij1qj47K94IBamdlx8fo/zmBi1/8crX/JLuO3LTaTVnttQJW7PZGs8j9mV/kcn73BO7F47+TFu+wnWLwBJfyrf7KVc3nlUAMt87EtmALHV2elGQ/+RvJ1D7EHnd0fRPdfbT0wxXXVOF27RKRBu3KHvQdTyarzrZdDn68ll/P+gm/1Jz4tJKY3+BeZGo/kBUt1+bfsv7YdywX/LplJh8dQEfxY9mmHwyImfriElqSkgYkQwTsAM+IlokqkdbUePKTizb+C7N6Si+mEJKV81U55gcaNt2BNE1z7G2kxKP6VVSBkdUxcytYtusCRjXnx/SVtvSdD0xenvj3WCTv1th+Jrooy5dRbFHX7kTaSggiXR+DV8VdvIJMQ15TYntfF2K0/Wzy9m2xlcsG7vcgJfgPaBLngPaRUEBxRdDOhSWnM0RKT1OYuis4vj+cRStY8j0wxVP2gKogKTYbnVkn7j1falCChx7txWjEjG56Wvv8MxkGnsgj+TUZQN0xoTvSlEXlE6z8rw7gIKD2HlANUY7cl2xwtG5B3Bu/36Goi+N8ykqCERNCEAbwT/CtkpBYEHNCh1PuYWoydeWANAOxtEKYy9WLoISMq9jKHt13MhSrTlbx9h0oPGGCIjcI3+bv9LgZta9Tl/6IFJmCj3fE+rm1SG0jGtFEMku6kPQ1QaFdcqMC0MvKC7/M1CD0FN3LxMqPsqm/G/ZaM8fVFPhQ3dyPd7GKrtn8GTIv9kpbBhOKlHTTBCEv4n5JxMXwVGz2m3her/xRFHUZ/FZ0J1McuVuUV9PV+/34lixbAnXVAOhZb8bKUoYgATVEvGdVKIsmTbuGSgGV7xOTBTGVAbQgL/FSk4HkRtJp/yyPAeVYGP6I7JIBOSavg36Qu1YMfIC+n843gh5Y9QXypYqOOmbPEdEz7awfUtzAb6sFbWM9sQ7yEPJtG19E6CR2016hnFo9mJZhlKUQwofyQpTiEDtd1EHkyeFAtYGLeo5Qcd8bIwyA5Ddwd08C0ysPjpHXqmtpI5FlX3zugmrZjhGmkDbTTPPJVFvxv2Xg8zFn9bO10OUpIXMDzUODikDBt4/EwT4qo9ps9lAFZdpgnBaDRSA2Ln6UDJ/cq0nAvjLDD8j3ogm2L7rtdWjXqSo3FSXH/C/xHPVanftKEoXT8vod8KWKppFaPBT/EpoRfCaELYGTbZw9YZJHZ80TgCn8lFmku5qJ1PXif1xdz0My0HFI4aCyVqNazu1DC1AMq6F4m/JfQTjPfeA/LMmKhoyU8z70nZaQK9eAQgNS81HJK9IG3qUW5orephXn3q5i2oA7ssrTFS4Rv6RP2+edvsJufNOy1BJ2a2Upie9WPD2UjFxT+9vMV7haxQAIbsNsR7Tkbup2E4HlU+cTK+TfiBLAxtehsZJMlf0e/Z0q+LY72WTbBrnr24kiOX7mgC8jIk4dpVtaD4y52DCO17VrujegWm7arHHGHgvtAcvwqCYHM3BFelgE1wJ776GqRiN0GaS0zUbuubiUGmn01drt0hmuB7/024R+NqwwUtb+D9vel9Mvil/cqK37hzvLy0+CM3qGFKTaMt2uvfy0LqOQ1zl0ZgZIbOY3Hr3H2M7LD9YDcQ7vJaTyu5av5Wv6xVER4h/82pRz4+RrSYr1zV+Tu2Q7J23puwmWKcUOkGo+PRt6rRxIbdLlOmHH6gAj+QLLrRlOtGyqvuz1hJPFSG0UVH7OUGngcvqXZwBjdJavm4XEehdyk7mBzMC0bj49e4+wnmYk3LEcZcbuh5JE5aX+BJbR3gE3MG4+/hjhl9zFS3iZKjZukYThxuzicWQoLOoDCrCkW4gw2TGmXv0eSa0vHTAtGG44Zqp84FKphwabaDlPFzonIPQR/AHACfGLyIMmC3UPWVvsacuCvrnEK/jh5y0zOJy3UmMYmGbbO6UHMrnkTnHiqN0bqxLDQ6pciZf5c1INjSjvrndjpzbS4z7xvArTMieHBQ6MxwI+QGxXI8Nc7wucPu5DT8aHQOSDFA5oM5bA1rucB2YEcwohPRO7kQQhttDvJAJMd0GdKyhuvYkSzgmlK1zrC2Hov4hhp976smwCYkibvo/KwnkSsKPgWMvPzcgS3HcDySUYEikc2zFsmxm4kNWJ6umdijMJlyD1Ja+R2I/F3Mj0/L27W2aeb+skU1ebog2EJB5CzJ+kuN6DaGlALGnAzDWiHTf9l24fuO7iHJxa/Nn92fl6EJYIZx9elTOmDNpsUt9SCZqT2DzKwadXZ3CJN2d7Ql22rcUfsY+w7ZeutdJ82I8DVlulfeU+U73+zzpvcvhOjcPVUbQTHlAl0vgELy/XOrfF6eeudPaSoEjd2C8muhhoUag7/KnuiYv+bddG2VeS2dF4XG7hiouZ2hhX8DGGDOsNVdlbz3Hz1XlzcDuvJyB2LurWPlK+l9RkUybHRqDqsD0VLcJCOjUZdesnNJ+BwJi5RHosQut4fG42W6Mpw9ZB2hq+ePBgtjQs4Go1UdFV334ztoqvDevLgaNStlQ6GJybcg1F1LFqufV0eG40CvXRYT7KTjYPo2thotBSSgrHRqGdYHxqNVoyGksxFEPdufl40rGqhOxbVtK+rY6ORq2s3nyAH3WjS1+7NJ0bhKn1sVCOm57KbT+gKxjGKoj5eOro6Rj78UEFph3uqqKeQkNOXVdzQUt1zywkd6OU34+/SW06MjqJ4Dw/M1QrFXF3R3bec0N16BQrY2pGbYJR792ynPYbAZsAFXcNbJ0NHu8MSX946Cbyi8CDpQemuYXko7ALaGpaHDoakQz8/L+EwYzEgl74ag5b99fDap3ONqGAm5I0WOCkSzmBdd8GCycwLcJvHwCbqOtG99ingEoXgA4rl1za53hnEn80Hh8UrTyCl8Sc4eDDsQmIAf2pAY956B6aN3nqO6JJiK50DJj3o6xL2dtceGDG85sKfFHsxCgAGk6MwBr35xGhYoolqK3bfQZpHxScE2c4Py3vTGhkUWgJq9sysoAjaReWMEXc+JxpRIYNK2dMR40a5Jyp2YD0vM9cH4vTExPjN2ttDXXaGxSsTv5tUKspnyt2is0839QO1FrXXhgq958OlrpbsGNvZ0/aZm9ueFmBQl/GV14n2MmiOhETOfZ3nyH0HgWBCdxiHfLHffrzta/cd3EO3Ph4hUkfnABkVau5eCoLm3ssdwKs9xEEgO3STg1g7N+OyhP7c1B+V+kldWulSf5RLzzhymoS89NAK4b80OcGK20lRe1bUYV9E//KLokcTILhvURfWO3eEefzcFlJ8K0eXoOGWHpyhS3FMdIEQuEOIxdXunqjU/2Zdsq2WklZLjdBHc7ciODpwN1iyYQeI8WWTB+NpdQ+SS1LnkPaQTSd+7r5QqTHtDDuHIgdBKRtRiUKplsy82E071x0mMC8w+nfNhNQlQvYF7Gb0q4QNWljvbObPD+LPEP7spM16EDZFMtOLvPaGnUOsVRFHW3AORJg49wAty4kDkWtPNQddICXveEs4t1SkLgBteBTRsHNiTLkRldDBIiaGpnuAe6bZj63UzigCwRPGzo+mGBJelnDSDct7tTu8FRMlJw8eDD2KbRgWgSknofCUayN54P7DYkXZhhXdYZawIZgjBT6nCJFFxikFoDr0vghkSBNKVitSFxt2QgX+BPhT45kMPTwUSOdq+GXonzN5kJxIeo+ZPIU/3n1iNPJuOYH1n0xRX4lQn5YHR60L/KJxSdmEJYAujTmS2hvF6QksRtsEvk3IzYSToTQLZo7Q2bNSOWMqFTaC0n0ychYltyYKiUO5782LWwm7vPQQHTfuZDKZLx0lwVnGgeRrCblRSSctSbNLRffElLUHUNLOY79ExwncI/2SbSi4uT/KmatphulscOlsyJDZbz8Pu3g+HMjXq2vp3wt4NbPOBxmXE5n9dangNdRIulwUQL/yoij7lg7kCgIcNdqnKtdWI9dZQ2h1EIjqIPYFadYB0bGHXPKeotXNyPpZ/AGKR859hFwBO1U/LnUL8l5lS4n2UqzM90k7uHFmvxYOzm3rqtvRVZhh/jRzQXxddljKDotEKRiPsuORWtnB2F5p9Sr7WmReE8Hpv1hkOJl0JzAvApekGS5kLy0+2J3Xk5OxjFCtjX9TcPEvtPylSMYsm1rIsklm2YDRUybNAfRYue/2RLQPfook1kCk2fMveMxCK/lNWe+QkzY7HguDn1TczIwgqThxfRMThIZc7ALSa4/bnJ8XwQeVdoEL6UdTaIj5eYqE4TBZS6esS/fYi9R1zI/n7V94PZunqILueqfGDQaWYTb3TIxfRyK9oUZ7O1tsD3ZyhSHqwQ8nxnZTDx6cF3WLjXCwLKzpmHP3HOC/u/vN0efoBsLFsUPNDYaEyCQjAgyojmVATYH3dgbd9Q4UWrSLo3Wd8N8k4ZkV3PwYVmFsVDvEmzCLoug55StSLiXyhvUk14hQY5SbiAvbTP6mFztEdcC8Q53mVFV5412Asxm1gKv2s5RAeSGLXXlehrr4UzHUpTZqrvR8RGDlv8pQV1KGurSAE16EOwbbkOWIKyADKm0nbOV5mOv4ldSlTqKzwmxzf1rfstEXa77UzlZPq5+CrT4DVfILjPC0WoSnPklx1Chsofb3RIX+N+uCbamQMNWFOvzJU2OnVOjj96QKiaFqqnoqnRAHoyDlh+P9c/KbH33LvwitDlzA2yL4XTBZh1V9mNDKcXVgGLBn8ydUHblHiAm8wF4dJq4Q9bCruMycrKMC159Efc6flVT3vLR15+TCujPZuudkUnea656N684sUvdktu6ZtC7F/eLcU3H9k1R/WGaHDN9Lw9VD2eHOiUyTx4l1bMqI5veIBP9MnLoalrecGE2+NyHrw1Jn5y2vi/DGE+bUGKreFXXDNS+xpZMyqto+TVCfRqPS8Le+Kw5ESwm9JD42sXYrEtYbggeSj5SJ846WsZCkBM5fl3TXzcQB70f5bpTX1eGtk6OjoxhxN8qWSHBSvvmE7tLdieBE98TJbkhZ0A6kBqUx/C2PRUt0SXfHIhfIF7pYHFFF4hDyq6jRpRNRy1LdjWqKpDFVktQggP2y4ef4/ZKx0Wg51Uq+V0Wkx7GoS5f0EpKcKPpmyYpjIILSJV0GCUsDdXXJijtI0lHlPi9HGMkxLJFeCokLI2P/lhNcTpGkBNOrD40SW54Rh8TIKxWRkRarDrCYcvhqWq5bD5AYLJIgvA+EJXL9JOphDuf/Afb4P0vwsxXCE4kNR/xBlGlqkJq6g5q6LfLTpuapKS3DZXpF2DMstH/ADzPSlcXQUCxduY6kL/KQ9klKU1oo4gjL5MWZfR48NH59igtJiEdhVuEJCnIVnLXLdI/OYTckAhlHkxRwKCIqZGdUJthf72wmWYuFaB0RsNLoBunElIcieTMN0dXywP/L3ptA2XWVZ6J77zPde8+9VaekmqyyYZ8TsZ4cLEfpTmRjIGhXWqXBYwKhWVlvddLDe4t1r5NQwrizVmxXEWyjEAKK7fDEYFM2TmwntqNOGNwdE8vGgBJMoiQQ1B0/ELZsK2ESGUAmDnp837/PuefWpAGb0G8hL9+695x99tnDv/f+x+9HXnMqdAKbTQd+/fBHJD/aXnVSaBtiboPXWgB+ha+9D8qUDJxq9lNT90EmwRQWZtE2/xpLXp4Fof4pyNyan5qavc/r1PhoxcbXnlH+mUYR4lsoz4gGx3auzzs1JU5HGP+DBvzC52ITzgU4uee1iD3eFio7SXaP94WpnedN/qwOaE4yQKdDBAQBlBYCXPP6K6bkIGtef0WaQu1ARP5G7SFggSUMUfc8Gr0GfwejimEoQhkF6guyfaIDy0upRyRfs5hWihabvog/5jsTKdDM7jHU6eEkRfuye+AVq0W7IruocGtkE7ExyUvfIC+Nw+usjvxywdFfsnX7/2h/+cTrixbfe1wRef7c4OdBPMnWaoUGtrncc68rmtVzieitg9Q2q+70d9e8dojXL7dgxWcWSXOdbdn0WgzHa+9DwgFmDG9iML06QtbGYF83SF9tHgK/o4mlEWJVUDVY/Uq5TDXk2BjWRLyT8Rc0pi9+L1QirbxJCbx8PRGMZbkONuBCacAmL7HXGBUEgYiGF+/M47IFAZt5fdGshuE1Pt0yxKI88Spc2SzC2mja2B1XXZuIuNSfj4+9yrdlu7Rly6K2vAVjLA+JgSnsG5jkRF2v0r//t8HIXHKdvuaHYJwrOuvFxd+I+S7Edmlog3WPv1sTdhJJeg/678MBMg/TpZOpDF+/TSLl6IOh4JUquMTZ7SYtTPZ+OCc7DbUM3/LSHkCPFdzREDPhNs4g0fSq1Xl88ex2k5vUY51F7t2N7nnMZ2d3zYSSWyW+uHQ2PaWqmI2liFxjm0dKi8R1LHINuHsDBMBGLpRcObiUWg2mY1zolThWsJ4z8CUQr2NkcbTj0+rVYtfeuqQcs3lHPjtg3+PpOtv6g59Uan7ulgeLoMSbpiUy7OHnNyXE5b7ps24sJZT9r6ISJ6hd4yEmBsznmCkURyi1jMvL0yofWyxW/9oJ5cXq69N83HbsGCioY8cp81Z20b6MbTvY+8bwR+XjbVO6rEQMkWLuWXd4pJqrbQRsiJw+s7liXkqPpW2joVBpbbxb86ZtPA5YZ1SrM/J1RnXKdD836w4x4KpDMxrCUZGlPZDpWFKN9tWEg9UwcHIuEPLbJMRz/rZOWH9cQiYGHhfIolr9TuftRYXyqG0iuY4hiHx4gH+t0zmtPNuYXXJyWl+bT55yq4vIbZqRZdnuG1xflY9jabErdpfXXkbYIZqutYPUff42G7ovqp6LL59l/pPz4ZKQdgybM5ZPilLhc6oHq4d72c4pApaMTSf/np5NsQuv8haxsemzqZzENhtldxp6+dp1WDtli/6Fmx0dkA2U3QZckQE3tA5/NhTjvI/vGT4m7YQ9C+ockHR+lhD4BBlILM4GzfE44upvmT/h3wJ27dzgCny8rlbR9vwsp/MGvm7JJ9BufU0+xpFbfbQ5fwNz587PI3CWbebKhQHq3OANspdoXxd3iZDRfKzO8GdKyHZsT/hJ3oWb0bTKFujjiPO+9ZEKh/6O7G62/efzCfx5vYw352AsH2dW8fCqPLbjsL6NTzd+WnLu+gn/uVl3sES1yP7QfGe766tEfroTiFeYtLyDRB7TKp/wbZlGEOy0ysd9gVd3qBUQAHW0nTcRBMmpP7Z8s98gzf5lNHvSjtl0atrcaMevmbbXFmNO2ax33894HINHvUcuRNOWUBHETwPxEp936+k5fzY+5JVrBqcg7u1hib3LlIAIKW3YTU1b5p7QvXvt2L+nmgdZtRFZ7BaCLgilT7AnHpoD1eBan7h+1zB0ZY8Utqx2Ac67anuhpyzJ9O7A6ik8OoaFzD15byAUvCfIJ8BVXIUnLtsFUN/LOF3X2TGb3XvttL2mmLyriJzkfJ+yw3bSDt/3akDnfZ0JwI2bD8rROTfYHeST7GGQr/OqVnfYdPuZvvZoGyG/OycDrHg5sMcMh+0wqznKz4NGluIhU0xmv8dLx00+hb/HDI4PQwVOjA7MbvWDpcjlbsMus312toi62b2oHvqZdZZt28+aDhiZrj3y3n28+ICx45ZDZaiRWWcnp5WdsNHUtLJn2WjKT7E8s8BnhKr28HOvkWePCQ3My5hIpffxxzFdcI6O66Js7dY6tXHAtEzm2F3Z/XzosKeXo6CXAco82KfM/fLOg6S7Q7pPN54u98n9/bx/YMl9KFvkLQ/oNB+ziZ3A0ZzghMZhvC/wp/GknMZZPt6O02olqkWMSAcZcddYBGu08tQGeRsRzf4c3PMJUXU7ZYdt1i3W9vLR6qQzctIZOekkrhx/eNJF/gwPhRMM0noBOemCRYWQSSaS6zzsy0A4nnQ4WhJ/ugdb/AIxc4tqXfxa7R8vTHXS0XlWbTZ7wGVs6uUNu8ZctygNhXHnzxBgteGal3YUw7s94BYAL7BrjXPzp89tsDXXCPrHNpqP29g9NwxmfsiO34VXzEzlQ8Azj7s2RihCoW0T8XwS2tS6sus29SLbSBFyqjHytH0ygrk5U5ipvClgv7Es0k3Ep0ZYzfwM467nZ9zj79T5UHpao4GO17rZYr51O2bHbTKVj0G8Fre1n5t1H1fbfKx6G+fA5MA5oGx7ayeaVvkkBVChMA+dKVs9cQ/smJ28Jh8j4uJWxiuq7ZSrV3hGwxOZC+hsUCnPkqg8WwQXZ09cMN1iaNNFZ0dIFpQmCAnfH59uwud5zI6jwcPuRZdgm7TDV0+VWN8pliaNOBG2IZpkYOKguYPWG1pyvD0lk9on5VC47hfus2OvHjiJQh7FvlKwGuG5wc/j4/VLThlabUJwHOG5weuW3ga/wbdtrx9BP7PodTjt/OtwrIU81kIea4PbRyg6WBxt+Ny95D7OXb6P524TArlrXEITV5+ECYknPH3rSm+tL5quCa4cscYCcUC3p9SO3UXknyHXvAzqFDu0nSAwIzv5pznDuvf3O0C9M+ZXZmJB+rOf7T3Az338fED7Bi9oafHdWoAwy+aa/piYgSqP+SHi03v5Oc/P3UbG6LAG1HvSQ5S/F3j9XMqTx9iA4/w8zM+jGvqfENu6NOYQGzNsE3ftlV03hRAHkp2nXGs88R3utxKHrCc/HJchD9mQhywq5uch30Ick0yNsbvevAV5bD+LHuCntOoBU46V8WPlYaX9rBYMIObkwre8Q+T2JqF7mr/EdeZEI8rsGZFr0vXGqe1TeZuZ6lnAMKPrLV96HLtYuz56RfAL+YhTecPLgvLaiMQk51ER2+AXiyHb6BLSlJFOSDgF17StxOSdLRrIapG4Zg8mmqk8sSNM3DF0Ze/KvOFFQyD/q9QyJFbeAiVGlwhP3A6ZMBGta3bzpD8EcDfv5kPUKiRuPTimxK3f1jF2CPv0X/zts+HlHXLZJ4a7PCAb8Lm5zz8eMDmWdCj4caOmz7nxmmJs+s0YjNeEc4jKHrNj0xycefDS+HIdmLzxu9Ic2L9jdzFHD5O+EVpyir2ekl28h/q3TTGRqxbw9Igdbbpz6HOzVZae9kUJsVcNwLeHOZZsXSTRmOUtXzzyU0+0iohjxAGqj06JkpUaYXxlgqBoG6iLA9kOtrimw2xt3DkFmymx9jBskZcuARQgLbVmppos7dtRUOy5yi14+mkI8n7jYmphqAMIt9FXhrOkplU+hspxUjBrQb96Rkb6xgL55iobMh7w7cgy4ebj7qJX+z0igpq+FBCfes9H3lFuoIcj2QMi7gH8nI+5e8RgKrFgI1lkh6N8rNZaAIC7g1G13vfLK7i4Wc2hyK/SA1E+jh5xMUf5pG26rysgmMGDocbiR3Z4e5FMFdodU5d0mEkitk04Thl6mwVkekhrNr46H3JzNr7Kzb2RazGCdbii/4DE0bANjraNr64wvGsrMcJKDGZmi6i2EiOsxIYdmbVDOAuCcqgDvxQjkWJb22oECWpi5S1JEtm2bfKkuzyFMQNMVBNHvggvDy+OhG6fTMEejtreyE7accgd2OiifB23vSg/C7Nbr+Prql7HQtTFc5w+1rM7yv4bZz6sbixEBefg7qiYgFwQusNh155l+YpjIQkgLCc99JMe5sSmReAtxyEmfZuBE1Sym534kw99VQDEt9rACb1aMzNLkIljQbfP2Rx8lXA27nAAmpng++mMcTwo3w8JEe8P8jExRM3/6Ye+qmXUD4a1yo6Wle0Pq8oOsjOHys4cCKWy/aFUln4kP5uxDdJIv7eEXXt2P1ms1Dnfr3MP69xb1rnb1znv6wzdvloFVaMW+hXsYwUPlBXc7StYCPMxRL58TYnby0EZk5oA/irO5LnBQQ7RocALcCy9f5nSvtN+BPcHqD+EJEVCGLMTLEFJH81irQ8EIARSBSR3mfyFIJ80W9x1dm3PlqGll8nmFoCnH6+7clBes5PiHDMvL1uskMIwBsVZHMigWFfefGC/gkbBCJnuZmjsdpyP43aSYxzggJy0o0gr6tRl4M6+qro81WzCw2MWzR+sD+c5wou0HyAxrtUlWQwLFAAYliaEXtChZymOmxQ9WmPHpUd7PqG8JLpBJFGbj0NO6qu7BiTRitsXte6p2hbchhlJWd/Wad13ZaySeIOB97SRjuo0LBfuYdWrrBaMYeoo23LrdlA8+iJufkdM+oKakcuXi7VQewycwRYZdy5xQWE9mFxmCDxsStSBPFkfD3LaupdHdrnHoGNP6XgjmkCcHDD6jIvRh3qBjtsEm89vhiZETs++tDvn4f7whyOhlgiNiiMR9G02NnAbZ/Lo1J817qIefNq3cmd7E5IZqVIzaEuk7kqpKYWDnL5xV8tAbwLuZmsH2cxADnjIzjlAvDYB1POxd//h02r76TSJVTYvnWVGSwmyRbj+5VQwmPtsPN267prpTdfm8enXih7G0/e/84bPffKRL31Av5rStXQgOPUxL+kNHsHVoqkPVzqtbHwtjBtT1A/URHOEW1fCdf2ZWpnh1MbphwOjrws8Coi4NerlHc72v+ravjfAQ/vVta+hA/ZZSLBu1RXy2LB/oOF90xrilRY55H8Ou+LyGNGGhF/0FUUxOpISRDtyetY7Jqor7Mnc3fh+7LR6FpV+O9klHuC0fdV8/B96aL96rcD1eUN/5H7z22oHN2dim+hlrNVQprg3f1vRL4zevO7NJxQ0o7/Nva9RGPafJwJ9HTNqBsR7vFDe+2+FQRFQB5+VszYKjAmfBRoUtVWEPQnoH3mXN77t+uP0fwbGiDf4yeZt/hW1eTvxsXLewhutmn4Fw45U9eDwWwpVpuqeb/wsHRLLn/vVNTJ9lcP4/JZrMYXVz8YN5SQyQOc0JrFsTBVzUGX8fg4OOUGNuI+fUPV5PfExzOv0wLx+89Tm9ZsD83q8Pq9oEKa0MByiYNHU1pw6h98Cz7+BIQugCQwGXOv90Cjce4sNrlk0s3Wv94fSp4wu090nKOAWbkESUcL9SWoJ443KQQdxXu46OPZv5V6aEPqAIhcPE+PzA28kcBthkZCr7TIeIj6NmtqWhzyZz1PI17b7FgGRUWK2Vu7EQ8GsqCdZjIBq7hHkVHP/Bjsdk0HMv08cAwIBI6vyC+fl25laoemyng3cujfZZneXQzZRYrXoXg415LzGzfiqXUUgTZSEVmVLkTnNN6GfvViq3o/lD3+dtMyCxfPzLAL55R5yN+BpmZTIaj+pfJaFSvGrnekOxUobEwYhV+UrPIqPeaX2X37C+C9wK04fIKCHxhCaKolxIPgJW6Vz/VzLCGpHwTJznUDrajaajJYpixM2aIc8Lzl35t4IGq2nYmbyvxIEDlWLM8HAe3FeEChASzk0QVDi0htebLK5CH5Ve7SETiOh1B6d3aqB8LfZXAJUDUBnBO7czcbKr9dYojsxF7yBpRz5BtczV8kl62oqdKAdE27tQ8AE4g/y/JgtDYUwoZ3XlEnr/Oif0LPZ+wXpjpkPiIq3UWlxH0HUXbZgeICiyoLAqq8XlJzQH6ChP0ADHKDlcwhwZwS3P0NZvFeE1DWzlvN69+L+L9uxa66heAKsJTAEyIH5Eso7G5UutPth2vHdS7YxNQQbVC/Wb5yuNU77xul644qyWwIo6NOyrPygd/eHbcSPpKV0V+9WUNehw0TYwTzZoa2dVrsj9S/trQ0ZLQqVlg2d6YrSXGd3EKEq3KgMVSwcAVgOlEcqsMOSqGFYEt+EPUcYiYunQNtAnWoIcA9qDVCrHZafwyDbYfY7JWATbE7SyewOU2UoB8NE84inAqHgLvGH7jBC66CnxH1FbQvnrI6gtPzONqK2wV0CT8Cho8WnUkJD5tohEXC7XKxVkmHsaA+r3tBFYRqmYRimaZoGKf+F/iP0v0L8U2GUaikYGt5kjkVHP3WFgTqqZgo1lWt3HcBwpvJIts5+gS+XBYAaywJBSkHGpM5QfKCSRuU6dcw/hr4q9yOzLpgpkqm8w73GIj1wMlWk7m+UqBlS91VicqfuSaD20vc0dHrnlPgPNuDMk33EtM3SBaVqpKc86amVFpQaoDzBDyHhqaUkRrjFe4u1slpWelf5GhiHYDhanrBdli+bP96m7pDqDeVxs2ma+KebJtRaNyP+Cng9bDZjJtt5GJZNuIohSVN4lfs6EAwbUJs04PzYcSr7A+JD/PK0qq+ba3+6E7WHUcPX9Kx7kh4SsbNdN+febLJb9Tq4BlykrE3dP6htnVh+OvlzPlMc6x+GQTamayM2lch9HqSw6HlNUnGap3nityPtmH1tqst91G2UfD7/r6LJ1X1ebcsjmzCfjfwsoovUZdQG9X9fhyOQK0+smkJWrEpt7XSscv8v6KbdSN3GXEkTBauOL/KLUJI54ERhUy6tWI1giz+Y2cOujQQyNOFrRJhJBMYj5s28BDVDplHXYDo016pyfEOaXYtNbFrlo05xRUeyAWUCEeb0Nqvc+ktnS/t8JTSf8jlRhELYsuUPOCdiF4JzYrR6VXlFvHmY1mhSuV+aFSOjuKWdansqxzRS+2k89/V3axAHUmsEKx4Nsu5Bhaqj/Zhb5VpWTSGDXVkJfPNWr6I/3tzcWtukr4DPbl4qudolhzB28kK5d//h04/pHafTH18XpXR1X75WnPyaaNra6dZ1cC65Lx8NtthRO35Nvvb0qwYDu3b6PX/4NDQIj531s/zZAlyFua8YnZ674XXQobcqusTbL6WnqBXUpFkqQ/2QFQkzK8OIBB7xStj9Pvnk1y/ccQZzyLrYcYOOY59njuf7aOJYa8evK0Ztct/0Cf2WYmJ67obXdowdtRPX5GutOqPXIXVKBh2kXSvxAtm5QeMK8bS0yk1ciST2yaz7+ns1HDnzkVq/Tb/fI1dZs6tIHEWtM+q4KTue+I6bSztqes6O3FeM7i4m7NrXeCUN+g6sjhuvP9NOM232WjvxOlGz9Ht0qXDRp1xnbdHUFKa0Sc2hEyssJLPFrp2GI0Vq19ro3mL0Bjt6bT4KUz/FlNF87XKn0E91WjzxjsE5Q6ydDbv2JySVBo74tf6Ib0DEWAOPiLU2hkPkqN+ZOtjjsJIbdtSuzT5oLiwfxs8PmZcFStiFUagRG3btBR7fA/adF5O7IBsCz86O09uKDgEUcmXbFNzMVUhLouRQBab53YZcXht2ZSY0bp0G41HguNiockhSsVUXqSkbA0E2dlPAxord3aabfdgUyl03Q2zTuZlOYltEFwlpbkIqZHGWALctjv7RzCztpi0ona5yehftoNnva2Y3d8y2njfbzVReUCjBEVaRU2kn5D2dor/sWeQ7nLB3zTPpHWtqtSmVNLuWKNFoMCJNtvWb1KJfrW9x2Vwc2GhGoy6FnPKr6UnTqL0SJ1rEdzXyZjtIcTyfxpEqtXpHAlSDtp2McyTDWLKP1xSjV3QaQmhY4z892wFwYhu0LrSGPD18YwMpqbFdQAnfn/MqGzaHtSnAC80uwbdXFIaGKEB086HU1iTQQpMjYm9SyA9gTzx9oHepHYLH0lw+RIqA7po8UxMAdC1i4sZw2liv7BARJfdogZR8NeDmCL72GuJK0Gmx0NkDBmOMgO5wCiZyBKHsmCqMZO4hBiqg9V5TJg8meoKokNNLWSdd6rxGoShh1cR9jrKRoRhSiJOxl6tET+ANxwzy7aXvDnRzTqCHmcywks8kT41xr5yplDEumBUnYnq3La+24M7tPvqtf/zb4I0rKTZgnQHkW4luz/sWhctCWLfkNQvD/nkjP0PcXymeARI4kFrAqPnsSEzrE2Gb7ih35y2SiYRSLn0OqDkRowjeLn6QsLcXyM67TtDW++VsQOXTVjoy6R4LwUlhm2hwod42GGntHU+s9hEmOqcAcAJK3o1K9Yg9I0jZotHCmIqbG5D5kKsBdFg+TWyU1DbTY0YHc56H7yj3uXOyB43AReICD+32lW7/bbq76IY7srio+9Y5uU69bwZy9qJrMjTuR2Y6yk1A70PPRDdRRsqA2cWDQY3jFcpw588IXqCMtUABuY9BsEjRZwGmDdy3zsn+SFLRuI/gKxuNyTpyKygUJVEV8sgN0/nI3SuzJmoCj/z/R0KJG4z1SRDWYys2pIkjt5YA1B6BHyF8WESafiAXMSBFKt1sLL75nHxUXOJxpnWf4pJO36y1F8WMC32eiF2geu1VdST8bZ2Kdsvk4lDRmVJFR2VfUC5NGbJwRmAT6+tQsjrIWAc27GEI0v9DVLZWud236W2zVrkF/3ffLYZ/D+BvepOheATFiDuhLkXAzaBqV7v5uVk3/xASxFfaUklOc2L4Up8L5VXQq+66SHEUXHy1249fyhlmEpzfMuvm9wfb8HVfcDlBiOtPGcFcvdod5lNlHVWlLpBqJLzpVYtfytTobs3V7tiyj1e19+sLfe6Zs2hSnoucTgWFnXlKCPtdJkoDGOp+k84RgMQqIOn8GExJ9BI6MbwtvIZ+bdicK//S/yiuXOWFYz95B/CCTS7T7rZ0U2rUBVXFfTvpMSlTaSt46/xcZdY49qrrH0KmjvRta82IIKAcVBU+CbSvkbugS/+hC7v5GpB+ucQoYdO3wKa9nXSuSbs5PawvKZplOdsEVbXCUrvawnZTtNgjAURqQYup8csfCfI7ouoBzmiX2BYIsYWbyKAW0+nnJXI2tGwTSueyHUVrZyexihPYtDp7FPboTuzm8sxphJhuMJecp6BURNzoBnMJ4ahkx6w0jPo80TDikbUuwC4JsJaYR90lUBRigzlPqWIYVq/EvZjYyuIbrfMYDmdXFYn7tb8IZ0ULHsnBxM4ktr0rZwoFXT5vL4ehNtf1B/0BNux+GCsy4skXS9O3SlbeS4q4ajLueJ+y/brnWjRX4FpwlQ26bj4ARHDeQYeQhJFq0LWd2IlWo2MlIbvxOY3ogaD5hMwnNZckhw4hXp2ynV7esW3k3NiVtyUu/jHVzT5uig4UZw0/uinPLoBNQ4nBQwVhWutkpmt90+cpU+9bslEF0rfkPGUW943XBvrWsIkLy35xv1mmP+CYc2maM2WXGm7uje7FV4txRlTdl1S9ycuOOJ1SwI/zxJ2dD3H+3T+rnpvZ0WmWEzyMR2m/iu0w0SMTd9GVXffnt4mYh4BcBydC0fHEbopeH1s7ELRoagptJnKC5NQLbOaCq7oEr9lCYX8rhhbe2rE12SeMtG4Yt1BDpyW+seD/kafyxIlfmS1G4NjG7ChT4CPytvtUM8/sGviZivdF3w9jkTJzWCDcC+1+bpYgtsPQ+8InlP5+1HSGo/7f0OhwPDQ0NBrjh4mC0dHmqB4dDZUkSYdiOxkaTUeHhoaYnO2v1Eyn2V6bSuzwuPtUsx2l9S2mrhcfaihtgnBdFK8jTW6x2OTaZ9V/TJY/7r0gUO2J8tfLtWqPlz+QQGes/tDowENrEQ8NsLPGxVN5A3rYXTnCn3EMr8lHAIc+KyHnW4px4EEGW+wIDsgRO34XRufwHZxqm/CoGJ8efm3etOPT4e583Da5ZY3kTT5/Be1PwPOHhSW82n2q2c0zZ/I2BOA1gmnZf4uYzfCWZNZt8rUnr81H7Ph0gNpHxBaRN32tQJZbI9sjMuLZxvapnGnSpVqJN4+mlR2/thi/IGDYJ+ZAvPaAp84rj+GK+3TTfarJyKmiPZXmmR23a7JPGjCAow5GU7V9qjNEJItfmbWxHRXbb/mqn/Yhj2uKZj4EE0+7DXlp/Aq2EPxQ2b5UpqPQ7n0vtnqqaFa7e0PeUsSQShJkeIhJhXA1pbiE9TNCeA1W47/aIfB+nXYrhUzKyqFD4ypxFhuajbMDRhxClOTPQrN/AvmzmDxrswHWWoPfU4qQmsdfC9tLstXHEIddm2QPmwL+6EWTMQYNq3sX0yMrxPmFZNRJt9AXe16q2emk7pXYS7BjptIcHDTZAUPDet/bnYfVFh6RfCsQ+uSdTbyziXoTq+nSVF5/1JQv1jYRjq96A3aDN+I1HSJidrZP5RAsa3PZYMuUjV4abLEd27Cx1e6HR34Ie4G6rJNAHSED9Qp1AYNSx/Imxhxqg/p5RymvheONunWrOoldu5VRuvT77Ttbt7yxMbiqC3jV7BMSyetluhbY/Waa+muty6nh6D/u5UcpqdJ2kmKfRmuGsAiGQT92ePtU4T0ibbu3s2PYy4ZtY/g6NrGdnaCo1s5OwMHSNpHpUDazbQypcpvkKthFDiGuwJqopFzTDks5W5aToYYjnlN5CvvaK/MhMoh2SBjEnP4CRCazafrftQ6YuUI5O8vwXOiuC0kRG87ZMLJB9mHdkeTwVCGMFhGTnwQCD+JzFooJNdhgrgCBQZigMhECFWad1mdFPT2HjE+H5dM23CGlugIS3pMstaPALo3K1HiiRRy1prvZjKZp+gts+QbDxHd3GM/kBmXuFDdHKZRecpcyP0eAY3QTNjbjWlcWNDbJ9Jjezimx0ATeJ5KimLBAaK1OPxwua4JbxiinXbM3tEZpEwVhnDSarbTdGRrORtaki9mECpN/eLlbP2aAIrfsrR9f+dapP+USJD9HFsiygODWLfvsv9Er3vq3K9/apFa89aPqzBtzuh05rcq/mwF8aaBeViUfe+kIEj+8RZuA/qfeaSyDK5qisbt/0CLzZWu+iKZb1117lz9wxUPt/fq1iICBaCyePnd5PYB/Etqo1i8WcA3t+Qdh4RFvUhvKMZ3uEhjHeePhhLBuL6GiY34/2H9uotDN+Cz18xJKvKMIpmigDbb6XIzAb8OOY1gXcsv5zR4xO5SAiPC2XqV/MhmsmdPXGIh5+8Je0VqPswneNVgiH0WI8at56o+4zzbztVa/p9Afzc8SfXvJEYy4Q818LY6lv2m6v25iF5ktRqbytXZkaz6BDeesmo/cW2rff4pJVS2Qv1yAiKuQ3IJsm2vtiGybh0fcp89BPPZskUy5m8bc355jE3Cc+j9NuaDcWqF/D6tTDL+MjXdOiXq1VXr1SCqpFlLwPGLAZCwUupKi/xNVtC0kjohpBjmPWBPFmPsiLc8E2vO/oVtEyXzUIdYrwBEpKOCxO6dXjOLhsuZ97o5c94uledu2EN3ZYmjdKHmY4RyHVwIFaSnEu/9s+237v5mW4vd4+KcSkQXxJofTfPzA7Sz3f3360+6Oen8oVuAFiDwczQPADNnhnPaS4byBS1BWuXPw/44pwrwm0AjFloFNwX2Iws/PgpRjzyrBK+MfN8quu/Ga4ixMrESOnVVGjv0E5ExfxeXYlM+6q4hpBsLFBsUYrKmGTSQzLAsnjO7TFN8xqiDwAEMY5wkGbaeofZ1C4sm2O6vrmr8IFUBmx9zTagaGR+TZgejcRPzPjqkcPY9tA6obxA4x7ZAPOUqvzjtuzqYMORqi621Dht8m5KVsejWV1ji7h2Zt50oMnQvBEsQ7GMbHGiUY2TsBxoQmqjqQdqUD4DKSrT6IaXyqSEpxjkmjnHmTzRCIxr6JBxxnAS1HTLBtoIxrXpkHroV4JraP3tdB6ahr0eXWlQUgdVLIePDd5LhM9eyYe0bN4Nq22R6ab4d9ha7Z2w7sMXenERK0LYRuzh9QDJn9haJDU8XBF/fylK9u2o5rXgm4leQSsagiyDYpg2yhXaaCIpUhbNrkF4vMJlf2is5Wm2L0hmyMZFJmi80AuBBu8ZS65SepwOHkQNPTsCn0H6kL4cSBoh2d/jtdlU2r4J4qiMp/Of4qG9uhman+zw5U4FcXQzNTtmOHdkwhDsZOwEqPqjdCnTD5nnzS6veAtYD5rdMrmpJVb3LB6v8IBBkgO3aLRBYdm3k5RyAVN9AGm1qkFxOpHWTuLTwpBwPj4589cfOXHve61jOZ2tTTIGjn4qk8xkKKi8Q2LhXweVm75VoCtI17RkmkVWM2TwWWd+6Nbs62nbbtKQS37rSB+5Wds0U6hWj+tptz19l0itmS+ViRdpT7r5TdKMO4ENqVIt3aUa5FI1NsU9d6A1sdFx1GV2Mg0e7mG2jH7GChxRjGkvog8cKX5BP0JVE5Qu0QIuiaCPdVhDdE82Lb3jlFdZIvFMD+GK9UDpxz07bdv4BhdN8WHaBt7yo6U1BItiHcbeuiiUMeTKYYlzZYD2tlh3pg9REpjH1H4hfsGu7dL35TgUC5N95HSbeIe07LShAoN7cJB/saG/ec4VpGTF2vyMTViJqeje6lcgZIyaxHPL/ytbBO2iGcgyNy9Y07O7o63EawgMJFZ+MmayxgHLzo4Znbsk849qCvkAPQNXflgfViz8VTRVNChbGbB5DcMcUN25SwIzxwKa0H9c7J9Yu960Vg420UZjddpCZtihnmdghIyUeRFyDEpjd8KUmAR/3dL3KiggXNYkKcuoQvqVpR+FcsGdf+q+UtbYeJbm6fwqvarglcO//G5PJOgEs7ofnI29SyEPkL79sugjilcwudTqcapuHaMMmBENik3zAZUfZ1WMJyEts49dEiCaCxcblE2rsk32k1KuXoFU3btk3b9p1Dtoh2eQB1Lpdxu8zL75ts263pujWltJmRrrJHqb9oc07cJhs7rC2WST1FDQ2wS0P4v2SX1trIrUNmeteclaUSuPTijnJtG/Ty2O+um7bkk0D3qn7ekU/6/mPGh7jBYtCwu9rJ2xfeI67C3Fgnb6cCzXNbNl6yuKrRxqwM82gdcWYXccXsbN4Q7iuRNdZhttGBZZaUy4x7X1NYQB7yBQKn9LvLQ8T9Z3BWv+uDc+Z/OS2SSmfX2OW9BD9ye62X2kjynCJhrT2mPvP7ozArNcbtP3aoPjsfpqrYGQT320EWDXuW7FjMEdTpFVm3iHs22E7qsNaQbSWz4d9YNJzp2eAyvpCe0f07KU4IMtNCEEM27e8VcX+vQFYaRKI0yrsJTiRV0lHHZidlrbGv7Auho2im51ZpsUuBK6vJcfhoiPdO+nSgGde1oAXEBzFhoSAEKKunNptbNGNfQncb1JRTcMIAbEgVBhBKGEDoztts1lv+ugLYM+79UAucx6978PU1FPTBNNL49kpvR5R88dClwbqlS+tWsNk8pgVI2im3gTIVUQke05vNAZgp4YIQuQNMHAv4FJbNPmbkFXMCCRjClqAuy8V4j75tMNuFBQfo58/NMqTSu/FvMJu2SiS02mw2CQTQ2UCQvQBhPaBwjEW02Zznq85gE5+zIdU961LmqVmuSSnRPu0srPt8gRKQD6qB5D2bMOocL/9W6HLi8uUBgvKnGA8kXgixNbsYtmKlZoA+EJJD8LyR7S8ndMECf8Tp72ktfkmvKQKBomO6RWSCLOJeEaJjF08VYUiNFPa+sK9BUlYEenFKs2EPQf/iqEOfJkGjuHiKSUmB9h/Vn426CKKono7ENzSspbc/D+z52ZIwcNQapnPO7jBiwLa7BEZwx6703EXZlzUzubr3jVmd/XeiGfg0oUyt3k9NHKLits+WHWSfQkZRSSVsA+aIzh4yTFx8v07TH2JuR8HkLIx3LoEGk9gZCjxT+scNHc2JDS5cZJeZ64e30GWBs8WjRdJTBZBcA+FVDQPAFpvcwTDC+t/GHEKJep73XWEGBQmzKl0GxAmr3Oh1eygtM35irUk8VNyD/gUxeFs7AeAfwuz3kMVXSzQBnah1KlA9W0MfpxJcXUQIw4oRhhVJGFYAyGQBUIF+dZ4pYNcRwdDHVgl7qxGAlaSME/Fl7UmLBl2ACwcELvGh2oG0hfI/XQhDug7ZyH2bbseyErzfT7yr7jsUuJCJMOAbE9M3pogwTtYX31XzELIRswfR9I0IavdtaD99U/qBN1hajxCQ9d9c3CmvCwBJGdYG813UFic4GcuAnn6eINgZgrom6AEz/cSivoFzCJATdnTEeLFC15jfGA2VzRzBNnTWYwCOeHiFG5UQO45YVboFYTyKwIUXM5YIXl9xvcs4B9kmyQQdLaUwjEYRiI7/VAZCZlC6nFTUFJGehJq0Dy0nRcE+jMC+mIF9ETmqdbYBcpnneL3qYkapGBYFfu8qxfx9ykxCVr5LfkqlZyX63lne4bNHsOhqBv0loIEPDhiWMvnn2ipjqopeza0E4TxbeSZoG/J3Olx+tyb9USRZl0UPQ1fIHcDtvdlITu2ZKTE80Ka792YzM5XeFppkLvQ5cBoVwLlx63GW0UcoAnkwfqfyuGeqKzCZ2KYIEMDgzuz9Zqt0S3OQYAzCFII4YhJ7n1oH4xwixjkkpYMseSHjwxcwC4hgcDByMg7sC7pEzsXM5aHLJJcNCca4hjVTAljXsmYqLVr35hh/xBptcVfIij+P639Tj8FXEMfdPXM5yAhnAq4BZMHt4KWH/aWzSMaRMF6ty+j2jCj4Nh3WQZqGmdAaYvlEioOiY+N7iyE6yIPdGromb7MfBgaVksTJU6Q8w4Urak4JJANGYQBtLXESxVukV2C4AnHCCGwbadJwIxf1jLQg6ajaswFwC31uvfbP1m/RbdQm9xbpDTa9FuxAozzFylxL03PZZ0w6Xv7qxwzj8rzkkOqze8J0vEL+jAr3NsmjkZEbZN6QKsBpBDoh5jmPBDovtvScwziAjwg3mN0CyfYKZFtX3EUkz04sSB9kRJALmqfsf4AliuasXlfQnuC7to2MG1tOd1FOPo1QRbKdTt0AhXd6OCpVMj4sSFAgjY225Xh1mvpMYdnfmPScihUI1vthyY7rMjXvFqxERKDM8a3gkSK+GLvEVQhH4ejNIi76ahvssuqNVYghQYheQ1+/5duPTTzyLADaH9m43/5Q2h/226+t8e2fUlWiZ9+RLxifxjl9Lzi5fqIqdOeGsAjd1xARf2ko0UlavOTC7B3GqhI+AL9/k1BTcXZTVATZu7DfxNn/w2RM2V5D+4o1Pqw0u80saqZOKys8IBjaXRSRxFfDKbN2Lz+cG8zJhrOsPv2mlumyEjIcgzAnfTig6Cm/swvPSby3KrMt4LtP6h4zjfuk3x6hfhsySov3wEUeZNTB0U88CrQIpaFfXLENsvcYG2d/AYfcGInDq0tPgIWqLj0J1UF7lw2yI5xXN9mlMIYvRSDm2+wpY+MZCsIbzCQ5ysC1e9ltUSHamlQi/MixgmTd4+8y2dOmzMsuieonYRQbuHI2rnw81OmcT3iBrKUNjNQvk1aeMYxw3Yik6g3X6NJrIOtmR02e8ZtPfPiUgnNqE26wLZwHmW1lf4u8SkBRFQbYBhKvDGJqIM9A9hm4lzWnxIlTLh3SxBEF8oCjWCIqluyzOh8S/ObQDmV/Z+Au38bKQcDx8JLX2E7etsPwt1HZ5/S68j4SYHad2dEJqpLtCDs4ogWdoUtg9qy2HSbiEKkixdmdSgwjrDKuLfSlUlU9KSnSbTv7kmGcEuEnYdGLwzk7ghyQI9nfmRSXBD1o2L8HjruJM/49XVHlJj5goIk3N5d9c1omJKDrvLYtaT9VK/SgNCgsR4xIBuWghhxUm2VfNgRA4JY/HDEA+ytGlM2kaTak1rJVm8MFuwPQBIQPoDd7dltIMarRRRRBaPXFAkObLYAjdWobfPS2hlv4rFWIg/X3kMBdQzxq/wLZm/6WG3g5DcTPHQP8lzWyvWQS4bC+bAZTPWpySTxfVPYA9s8RrdJyEchSb48EfKfKvqGt7qZNejyDfhu4+Kzemv5OIO3YY3qFkp10s5n3L9iNlfI1Qz8jIHYGhKzoZsfQvv26m31VI9Yi+5bO/lmz8Sr7koGx70Fan6lRaQsb2JAV4nabroXNGKuEIt8GFA5ANXGXeu3sWbpJ8IvTV6Hq+ktM9Zou3pNKndln4ekBkI0HEemLQVfnqRNlyxUhTFy76xYe1tnXDRVVeOxzep0gMUpBjIk0qo3gOSrL3q93SrpJmuyR+kdtMA0BjJJd9UGc0jr7eyMyQf+FG0zbhtk/mIF+cysQHYXfClBwt4FRLbstWudbIt/2GNFNnE8fdGzwf6pmC2Gu99MW0SAuBZJuuGxY3Ptb6asGqUto8D2Gg9foZk+YQmcLgXcFz24P5PI9YXnk/4MRlVfmTewIZxruQ1IoQhK6l+YexKRow0t6Emf7Rqyojeos25YQhT4emHgukm+Oy3FmNBYOQ29NgokR421EF4Utu+k9JZrWs3dkH5q26dZ1qWnNdgdwj2q6iZ0dXXnLNMCTG0X1bXOnGMO1y7ChNd349krtIGxIbE3PGbw3lkhscOmGDQtFiGEumq4cqk1QEfSt/owUJU6hfAE1UKCcat5DjT4g21cspg4u8L/QxlQ5PIFENFcGPxOgAjwu8YLJ7Cov3gKmJshuDLK/pkHEFyKFhCA/wtAp96ia6UQeDU0EPbk70wkgXJSHu3yDwsOUyYJ/mVjntKUnQH+O7+oX9LageFr9TEet8+roXJWKI5Xeq6kpwpIOJdC95yIMfighPiZ7OGBMBwTQ7Bsaiy57VncrdFOeOwyAubwjUerqEi7eE5BrhW1CmW0dzq939YownXpneVLwIe0f0izv56R3sYTPsNc/2Ayfx83wnwxR816QzfBj2uiBBM7LLZO4vkyi+jIJB5dJtGiZUMWBZSIe7H6ZhMssk2kPVyA/oYj+mXBLDTuMd+tYcmHqRQEb/oDYnkdi+6Z5uX6hiO0r4mq3ZFeuCK4MDY3EO0MwqSxZZ08xom1aQpT9vfuzBjggp7R3x6ewdwepTaZPnAhe16nv1JLQ3SZ3FapnvZqqvlmjyOwPyPJ5JMtnX0CG8Oj/tmR54sRwnTDnTkKWP6DI55Ei//kFPJU/t5gir/ve0+Pg2R2uenYTgZM/pkGD08om19IuQgJMSgJM0j8L1Crk16e7wxzUL/Dz87qb/cvqNKiXpUEMzEUqscp9XF2k4pOTpD49ktSLSRL+D1a5mHhqQprnqS9ofH5+CW16skVXs2+flEQ3quT0SFWXpJqdAIzKd0GoekVChWJd15TDUSUc41v2Fxrrz+1/mErjgEpckZhN9v5A5DlTyc4GsnPkZWdh7dJjQVV/e72y7Up2xu4245ECtiIElWrdmoxYpF6CTOF+o2zCgTS2yXvwdhHZuEUxEEo/LxunFOnEZUyJk1viJ6H+smXrUQP1eKwd71XPNQlxG66ctmvbXtxOe0XqXryTPq9e0mXqxhI/7rpZN94bCrRRlI6lb4KlJ9L1F9QsISDcCTW7rQPzka36TvdDCspctweV19pBbCswX1/AM0QxlWj1spPVaJZ9Z39V2V8l/YWyVPWjLwSMXZrYF+DLJtjUjaGbdJL2t70KAnpaf0J9RBtzbXASeSSp9rTsxmCdlBX1vYgnTmWfM4AWUsQXyj5IXTpfUe14jJnzW56xAYRm9yhk3/5e5ndRm9SFl5qMkgeVDBL8YGf7V9jZ3hy8LHihdjYQ4jXfNSHqQUL80PeAEJ8KNDmHhTop7vGkuNd4EgQpHuOwfY2fXy1J8eBqpPiYkKLt0n8KHZ8UUpzwpDjuSXEvB39PnRQfO3NSfIykuLckxQnUPS6k+JiQ4tdIil/V1QKz+DgbH5Nd6WpJinsXkeLhOilO+MaeTVK0S0jxbCHFSW9z1r5jYfaWANj2MFRH+NJgVmsxRtebtAG+dkKf/SFanj731unzcEWfCyV9GhNeF3nbZd9DQ+ypJX22K/oU2myurxFqa72/miLQFDHX7uyuM6DYlNnikZLcd6Ul6bpTIbKW3G7iC2835bZXvzbldkOwbZq+jJYyTSnTQMq6kG4RooX1YEca2uuzoRNHUF1sQ5qRqvUQDKyHNiMwWH6mr3y0MRBH89A7BSjJNY6Acdg+05tOIgOVSyCXzUjssfhW8jP/42FPZuBpeOOe8Az28NPatOOVV0q80qbtsv5mLWZZM7BHowdLZSPsDGyC7vFN2Td0rrMbgzwu3ZooeGVvDZx3qguFYk9nwzWLNtvSgURerjYYO5KqdennjQ7n3NvfBfYGTkvvApUMp0LzRmieyF08bhBapdxXznGfsACkvcrnupnKPmqKQPyx5ogoK0jn8UyHKm3KzNlDDE/efZv29kh8dZPZH8NzCWBG5eWF2mUA0x++xQioOTHjzVUAPEIzPmGzj3qVhbyNUHmHbzG0nAIOCSUluDjF1/IF+24x1QsO9C8fqF2ehAld0KqYkLVxAWcFeaYvMJl8yy4wjZSZqzHAucIoyqt3ww2DLUv/3XKG08DStS8Q++mvBdQHfHYYdpkG3F5h5Xpb0Lel/miZEz2ozkeJV8ci1nTISCu8d/q6jZSB1dlfyRARA6mUQ3F13feNZ8YTSz0z3h6ctmfGbwSn6ZlxRDwzPvqv5HXx5FKvi2dW8Lo4MuB1cdPpeF08/T30ungHncfhdVHzt7jJpHbo/8feFp3SXwF7Y/rfAk1Dz+H6wXfQH3yHKuWfF1KyPUFel1seM93sN4Mz1wQe4rZ40IC4VtYEJiufc8lSTeAh082OLNUEbjCPmSUyicluCnjW4aGnv1euCv1eP7PsmXhoeT3gYa8HfOVgBAJ7R98D6lH67IjObvWwg/eE/aiEk3guvD2g54IX3pfxXPim0WbQc2GzaS/vuQD9wM9XPgsbzH+x6gX3WTiq4LQAHx/vtPC4gn6h6cybYL5fxnkhXuy8cEhV3gtN8V5oVt4LzRW9F5q+S4BAOon3QnxG3gs/WKkvyEpd1Y7+Xa7UH0zZCzJlq1qjfzBl349T9uwLeB7+YMpekCn75xdwYxS9+LH6hB32E3YU1R8Y0Is/zs9DupvtxcUHVtOpfPBU9eJH2YPD9Xn74JkrIz/IeTsq8zaoF/+g5tA9TrXgIe17t6xe/N0yk0cXzeSB71Yv/sG6xe/AcvPZH43l5/NoXe94oJrPY6di8XuibvG7tbL4vT2gxY+6alr8hDlazuL33BKLn+c5n1+Lnx6w1OkX3uI3r2HyE2aVJr/nlNj8zJsGzX42db8yWyh3SImu6jATZtUMf1Ll/37Gv8+ok1v/frBZfO83i9KI9kJsFqUtaj6ozegxP6PHjcxezRb1ZX4eLWf0wGoz+uip2qKOsw/H6jP66JnP6KOc0ePljNZtUY/KjH6ZY3tU+94ta4vyM3p80Ywe+m5tUY+e1BZ1aDlbVH+Ilp/m4/VpPlRN83wg01yaVFZiy1Y2qTyx2KRy6/NgUlmFTztjk4rwaadiUlnKo525SeUUeK/FJpXDK5lUNtGkAm09454GtPVemVPX1oeltn7Yo2YwCEoN/M7weyBWcBSxgv/Lq+431XIHAFTb9FX3fY298lGHDSUQKhEV6MJRTMJZKPff7kHUQ8g8TizxZL34EUN9Ksp9INhsMsLs8+edAbZ6cBfCavw209m7DV1e8+C0X9L8lf1O0NZUy24o33pbtC5lGOomopykGyr2BMGyWjRy39DZXYGwA7o8ys5fvqDEZCwtLmTqU3X0x1gOSgkw1mIr+YQfXaRm4GJzH39Y/4hSL9eXWOUeflhvUGqz2Y7tU3Wd3uU+utYRUiTM7oHrH/J3CjCAci/v8sN1sFOgvFXZ7wa8hvxOJvs9FsfgGVmzL+9a6M6XbGpZN7u3v3R1bYvB7NJicZ+XxpSM5L3oB+GlBNnDBozHCl1jhsCn+5nY0QhM1kvpI0YTEsy88+EsmaMfql0uMwCFEorcv1MLn0buNPe18lVa3rHOHVLuOC7Oz+vZKcwVrx5R7p8UkAKg+986yPZigwM2eLjZA4OLqcxIGiRQUAO4L+Bx3xaUvhkq/S9KFsE+jYQelvzssKQPzLZJ0mfx7DR9IAT2gmgOSsDlrCHugWRstbvccSVOoKYr0dz/M9CNmtqW0cUEJ4XnXZzdDozJVvYVBDymPtz7hoDpBYA3Q6Bu1U9OLW0qmoKs0W8VzA6C7nAT02fQmFE0POfXsEk1AU120DZ965slcAO+1TqQuk2rVZXaJtCeVynRxAggB5E12f0BcdLjbCFgJt+GbeZxgNjS+NIQKEZNdJXVZPdzvmgzatlG9iXjmeDE/2RIlCpfmviXJraNlwJQr8VTpLejmzfwVoxNjF3lJpN3yseG/GNDtuOhyoADJ5YbUCbhkwgBp9kyhLMD7cG2uK+Laji9qx+M31hfpgqnby7MaFZDC652+v21mX1Z2ybV8NBJALIHKFuxTbZPMc0S7Yk2yn4/KGKaibIvaw7abdE6Yjtqm5RafOYJ30m8xphEg8J0FwbAz77AErHE40PE6XlKTpcZyVjowZAvJ6KMzp4K6ubg9DcGIAYqiwXV978kEAPatXwiHoEYCAViQGe/ZQRg4LeiIhwAGNAAGCA6lMkWAIAA11EimNsArpfvLMOB2zrNhlXaX6TDwkevE6aiDQR2Kp2OlRvu9EsuCF4PPlX212NrltlfvUJFdeXTTXKHPdrfYQ+qLtCKuMXGA1ssHiLrduZ77DG/x57JWaG+D8+KU5gC9X06BX8f6HjOY81VTT/gxT20/RNWWv6hIE/I0S5gp3gfGcTIzNkkJOfU4LoLXxZsAI1vNlZKuhfJdHiuPvtdD74RvizYtEyJTSiRcp42AjkPsHpd58cJvgMNeahoSsYO96LLwi0rtaQhLcHT7wMIXfmW7MP9RmSLb2LoPhykRYR0mMD7/c7ovU9nf2vkC3GPBEwnkZlp9dsKIq21NZY47vdpafMMWYKDqitYUEhGCa+HCF4PsY36r2jiTL3QT3bTthCpQKdLNG9LjzezjwTyl9NM+Lp/h48t/TmOabHHhypB8DwsyUGG6hpBSV/MvRg331jKvXxHprveAKfkeiN6n/s/o16u+se6IXOSh1WeQ+6GZkUuRxgrwVZxISLaP6Hc08qGU9BKfVy5p/hdI+u4+yK+W7ybjM8nlXsGV8D48Oq29FZdBbFXOD5tAbprELandBUKQR9BnVMKhFNCScA9AkrRKQ+MVwj0tU/rUCjMl7hqkSHkQQN/V/BScbVFx6UPUhXXdH+kWyuyPB2qGevMTENg3urMTNxnZuKlR31cjXPDwy/ZhmAAA+2pYmgayzE0K1WX2oZnaFYq0SD+GEH5wLcgoh5sxY1B9mkmFxQmogSAYxHNInkCL0+bMIWWrpers37I4kIGiNxfJDCMjV63SmAagzXqgIUa8pi4sU2IVYdl22efhHPyyCYSVN7sX6jxTn3D+RD617btGu/UljymKdJ5kXcaLh/L/GOZHaZWUtxdmuQtieIj4e02BsZdLIzq+ZBmO9n7gz672H970mfBOPdCZfWBAIyhcMIn58qGV2KGl30hpyERvLt0byiHw7ypHQ7HsZ8dl8Ph8XOqw6FhvYkG/tDUHpg5JjHilpzI1tX3d70Q9iYAffIZ9yIamI73DwG/Q18QXCFusq9bpiD2WRwXsWzB81p0MtyD5zX34KY8VrQQTmbj6rxY3Di8Iis9cZV4sov3dvW6/rFxQWDliQ2Ly+CIw+kRy+nRFP9rv7U/pgksCCoFbh9Pj7TW9ONqoOmJHB+P+fgFOT7mOUeE7ZXjI97akbw/1TtaqWcjeH60/EpS7h95fhzj51HlTxB84RFCe9tV+HhD/whJcHo05QhhVo7qCNnvN9zDFef2Kc+5/Z9WuU96zu11i3g0Hl5bem6UB9ohz+oUMa+uwKXRsZn0I0yNp6RQLtxA0kdx4ZCAcRdZhJd23aYe81VPcQFVjM9hz/g8n1qgtwffpRbowZNpgbD8v+K1QB89qRboR1dR7sDXbql+p6/RocUkfcyPzoJezJmTnSlZ8734sVefTI/z61wbv65L7nyvrpjcX9crsee/rlfmzx86CZO7X+Za4H5N+sRilcMT5fn79mAFlcOtfZUDM2Scrtbh5gFFQFgqAkqX69PROqxSldc6rFLitLUO9FPncfPwaSoewlLxIK9fWfFw84DiISwVD5KqZFXFAxu3vO7hg30pvbm87qHR1z00nHlT0YCKoFFTQODiEh1EkzqIR85IB4EKl1VENFdWRIQ1RcQ3dV3Tnf6x1pHvYlIqIiKviKjhHeoS79ArI+IS71B7vMMAeIexqCOCujoCsKe6CEALjBgIJa9zhZpL0FtmgolsmK4r0Q9j8eBdhIEIxQVx0ZJyk/kfXkxekZ1YRVUhJtXDupSTj/e3kMN6JTn5sF5ZTj7FLcQfe2e4Iarv0w3xVGZCfZ/ORKmxqIy2bLs3Ey6rsTiIjH+PmVPQWBw0pT5CTI5LNRaLSyzVWOw3SzQWB81payweM93+WxZrLAZuLqexeMyU/KA5A42F+HaZpRqLYDmNxWPm1DQWn1xNY7F/scZCbLclu/mxxQJ0/QA/LQH65gF5tjyy4upcPk0BepXqvAC9SonvlQB964AAja36VGXoOjNwGmJ06RKPjKGritE3D4jRYSlGC2b0YjG6imCRcSgFafZ1Obar346kz1pQAUXBu1mWazN7jTS1OVCS9z3jYiEO3ToggVeM4alxKKU0va++cd2NVXF3sLw0PY9Mb8+Z05Km54NSSL47WFWaXlxwOWn6mFkiTc8HZypNP2e6/detIE0PlFlOmn6u3NmeM2ciTT/n95Yl0nSwnDT9nDllafqTq0rT+xdL0/sGtrdPe2m6UsJX0jSl/1KcPqAXsRH7eBTv010vUR/QNYl634qMBB1bFonUqMrL1LdWMrUI1kLmFKuR2v47kvW+aFC03l85MvOEftxn0bFlVKBhFCBDJBkMKB42DQFhybV8uyf0kSYAvedKj22CeTdMWt0Av8AQwkOa+JCyFWafCtxLZkKf9cjgCYTDtHw6TSNFiqb7OO31TULib8LXODfWJxA36F8y0wlskxmofcVYC6DfBjiRxgaTURcA3+SW1wisH2nTsctAyiIlaSQjkgr+WvuwxUQax7xRyTLFkBEvqPfwM/QMlTK4mn1WZ3/Na/yFUGgmZdDV3b8zZbP/zpSjwaxjk2XkdOW2w9AlifQrL9XHdokfD3rPqqyILGspSjhVDUGk0lA5k7pK68CI2Onf3vO39/zln/zZTX+lZBsolSmIQm10iTOR/WmQK484IbG69WKlr3kDjjtwChUdRuWl8qdBesngO0FijQHcch8Kq0QHwxcDyD/IDgaIdm3UX79FiT9S/7WKr8V+JLy3U0Axh87L3YUEe1wo7V9wyS/RDeZ0WpMNtOYvT6U1YdmaBbO4Ne83tda0pTU7T7E1kRsdaMtnlrZlupoWF2afhSElAFMUlmoyd3AYybC/PNRlko4jyNmp3cfV9in35aEeW/Pxvomm0rdBLaBdLOFwVty1ubxdyLyj8xlx04uE1A+LS5J9KkC4LooTFl27Tb1cl88KRkEoOpX+8zGfD8okJuj3pwDj37rSm6ScEWc3eT9D1yVFs41lEURl0OJ7O1XcdwLIMNnUfOxdUu1tid/bGvLtnnAgK9Ip/ydpPIZepvREOBFNxMnExERrYmJiYmg4m5iYWDs2If+UNkEwMaEnGhMTzXSiPdGZSCcmRtaMjqcl6ScS+R3aRnYwaE+mJRHWrv9l0J7AkbrCGoR7nWhB/Ieswc1msj2eUvhnrtSyOmdAKT7VmJEZRj6hF10sOHCzDH0uE3kgLlRCjdtjAA/87f/10Xse+fKnbnqWm8dgmzjMiWwfePsoH/iDD93zl/d96qYjp/DA2pRTffLmTuw8SVvXnGpNusc0hatWNoLKzl5UWbBMZV8xJ2tXJiR78na1B2tibunFlQ2jsvAUKnv5yZo1RE69m9cSemjiOZTunv1F3ODpp8qjT8l6F/uxlFvmrBJ9drszMCvMWlyj44acJc/yDIPK6lndm+lXxaZKfhpJQISz0W+2SP7h05xha+4VittNe1unzH0kEcRKLoUuZcZFGqC5C7bbGIHPCEOnhm3iPv2wPletTLNrS5olksDjD2sG6yLl5iHPFa7wYKd8sJWebNpeUZu2aLlpa3KBDRznqy+whtg8BilGL/Pq+GQUk6SD25F3441VO1llq5pceauKUjnwavveZ4J2KFcHGxz6BvePOqwQf6AhUDt2LyGwzyLKEeKuPM0bLvb9Rd2FZkPLY86ALwaRg49FtLlh4onPVaW29l9gS89qkSeREXwS+bwSYc3C02K8nzh9xvuZivGGRuBQxXiHyzHeUuQkjHdjMeMtT50O490YZLxRwVN1xjtclvGWYksY7ycXM95HdPZUn/F+ehHjfQT+EWWzbzLlaJSM99OnwXg/c9qM94+B8f4Pgyg0bvfHkNL0ggDZbuf998zG7vgj8r1hY3fMfx9ktmNCvGSfE4bcCt/3Y6fDkNOy+LmT8eRPrMKTP36GPPlvBGfKkz+xCk/++TPkycvWnD5P/sSKPPnhk/DkX3xhefJnFvHkR8CTP1Xx5If6PPnTS3jyJ5fhyY+AJ39qMU9+aEWe/JlVefKjniff0u3z5BdWPLlnyDG4DZt8f7DiF5ZHz+ODrHh1/fOnzYr71bfZXDjAjV/YP/i/eMbcuDv+cLmtJO7Yw+W2krijD5fbSuIOP1xuK4t4A55Pvmlg1d3eR/q17XmkX9vuR/q1zT9yCrXV+fhVO3pafPzJhuy0+PgL+3z8F79LPn7Vdp0uH79qZafGx194Ej7+yQE+3p+kSvaIOh//zCnx8Rc+f3z8bwTPEx+/8Ih252Xv1UW85Cg9r6RR8u2HH9HE0gOVH6pR+cFVqHy0rKGVnmy+TomBr/EGSY03SGq8QVLjDVZZdnXu/sI+d//Ff0Xuvrb79Rn8ajc9PMjgX9hn8L/4fDP4F1YM/jN1Bv+IJr/cZ/CfrkqtzuBfKAz+lh4Z/Bu18nB7kvLbwA4hAaZgFajjR6gnqTA7EvBSHuDYbOdhvdmai9Wn6ZTHAx9qKMlEZYXSXdq3B07eAv+W/pdBNkaCV2KE0w8hV/pFqoOhg5wakSfugJkZ6mZPIV8E2BGRD95NcMKujwHNEuvTbkn3f3xRfnNF0XfYCg4A8QCsccMlfJXgiqUhOII/8NBgC0F/pBZgTGsDWVWXgJKBu177+OwGUhQEcD4I4J1QDWDgU87zHsPUXdYtmEabQ13QOnqUFjsaC+uDnFRTo7wHesLg3TZ2IoT3ZH8JJieBs7gf47hAxuMypaC4e4jB9jsP7BEDy+nMqXcclMyly87pQiBzWmYsNG9KIwA2SObAr+p1aZu2cbcx+/3A//jVG+ftZoUigmLaL/JIsK4WjGjEOyl7TnumlBH+NAaca9QFsh/43F4aps/bo7ScyCM+antloOjzsaF65xm4toj56qikCNkDg5bYu/boyof0OwT0Tl1BQAsvv0dS9com807dBQNplbuFFV5vutnXA4ny/MY51Nq8FXe/dg61NvOa1rN5ln0bP7+hPPLuRmleQ+yQ0jIxumG3wDzcInHJPfekugwi6sA1083uo+twssEQhTvh1ppiHbwTR6ZxG4XudReX5UALyopDcQYzApVR+ZXAqpf9mRHkSVgk22EaMUz8G7RlznPYdgfiQ7tRtfqvqCV/J3WWWS8XIUUPgHB6pOjQzwKMo2IAFZzoML17RDw79oUl0HNrs7kzFNSTuwEXcv5m83pilCClcsrZSmlpPWqKYcIybzbXazzg9mCJz2t//6s6H7Ep3IzxdcimcHfB17ZN4YjyVZ13bOo28FtmU5iM85ZN3TdVN19jU4xIvrbP4aQImuEZEWTHARnzbGBbHPbNshdl3wpsx+rs6/AThOFf0+nXtuvX1tgyu8TaKruEFqyZkcXPPmnsUP2ayf6ZVnO04Ll/tRakm8360nO4SWREcRKcD2eLNa55db6WIiSD+K0BzmuFdhjOMJomdXeHXs/ryITVxCxOg9Xd85QairQKg6iJqQ1mOuBBajph5piAD1n294HNbHqemszujNpmELmUADOxryFO6WTZf308WCUuLFcndT5t4TQ7ZDM74BxxBZCx2bPQJPEnkxt+FkgScAJvE6aBWMM+ca63WrXpOAOfmIuncgOGKhYQ1Ti1ncGHtnUi/5AUsR3b4iv9s7HkFmau3up9K76pXrqztPSKr1gypAFdjcgumx2cRmPX4seMTTeqX3Fq2+yurUD8Se2QeLvLyAKiPfuHgJy3YBjZtLtR/VenL4YLLAjADhEVISNYUAZneHodc6JCj4ggJoGQiAhp/SVko9INBpFgNsuepSss4Gvv9G3IsB2HvexfkMoAl/NRPsyoMFuyC6MobOBnQR/EUrIxVA5Lowo2y2wwk5yrDQZ+YpLjaBJQDQJ46hvoka4Dp9/Y0f32Ntig7+xtDQzKOmxzG0y22Uym8nWSUQK1Qak/IOMysJr6k4t6fHtkatMSQCJN7RooXlaqMlg62Sb1cl3tVXBfrAysRtYjgZgCvPvOEETVIPzUnWE3+8eAN5EJokkGU6BKjcBa6y52tRFiy2gkDNUgoqvLBaBR4/XIGJpuMPMaNQ/bFLybIFdl/xRICRyDqYefuV7L/CmnUq7KflKFsjacHjNlhlJWbc1pVu6rW09/uNoQHRKGp5qNjeq/UpBYZh0F5eIr69FL6qkGWpxFltYSEtVWLT/yPvk4EiJwgvqQt6EE+vHFUBisl52uBaEF1aH4tuUIgsJxC9u3JssB/z4bXrpM06shaNnQ7zYrjIMfBc9koCFO54qTJBMw0ymxuqj6H6nd4t4CrCCsmT4PUsprqAh7AE6wDj/b/Bzi5wg/h8GXpG5fSO3qMEchLaNW0ZqXICk3YeE/r8XbUPA0eP6FPto1HVLVNShpH9Xi8+cDU33+bjr/UpUJmaFXBMJF72A0rL6KwGNpEThtg6lSVRF7+cJG7vyZcA4u+LiQ2iD7fV00GC9EZ0iVfTtYBxPDRmlWCDmgQSd+sExRdiKwETorucNh7Ol5ehA5rCvHucQOksn75HfVi/B73Av+Dtw1s0s78lehKLwrL37KFNrLFFpkitHSN52u6qOVF3dWCRSZ91tTIviKCCLCRFaTJaB/hx0L2giFHSX7ehBuqUtGcfYc9s2YW6Pw6sMEpRYEiNipbK+RVHZKZGsDMdrfeocphSXIBMOoyEIGu8lkd0agXQb4MmUJEp5AtQKi6kEBgTXplfYGK1e0IJKkr8/nV8EmVLLQRftbOscqh1HiFlM0sXVSCxMihCis2VsvjZxKsQUggsb0LpbmIeapa3UPInn2/iiVB0xXsg6I5AqQsHeW4kY9cDwpUTKScoBYXfbNoFLKaBoA0LrjumRSY5sUIduYPauzD0TrbMiQOR+ZklYyJESUFWQYcnbeX9K7qEswRZiehRXxnPYhN3vNcOpjbyRXwv7fYq6EARyq84BDNXDF4koNu2o9sKv4/APy/MsWa0O4xzTIZRQlOpOsAAj4uo+zPoqNSwkmohKjSBUQ9O0AEqb2C1pzaQtY4t978ftYWEc7DD3aYdgXvwU24eAi8Xt/X/wGTNoTlfj9kIjfR8Nyxeyvi98PVeL3oxJmEnazN4cD4vdHauL3Pl05ryr3P7QXYAWl7eTi96OlqP1rQSV+V9fMm1aVwB86iQT+6BlI4PvKDnjjZgg0Tl5Ac/p6Li+Mh8sJ4xhXGbZnliXko2FeQtf1hfFjoVDys9kpCOM/v0QYP3wSYfxwXxg/2BfGt/RKWXxTJYvbJbL4P3pZ/NjKsviN4SqS8FvDpZJwdU0kYUzL2gr39SSScPVsXRbf/a/WghTay+dBFn/yjGVx2nUoi5OwfzWE3LzBZNndpyGLPzkgi3tTUbxsnacpix+pZPHsG1QzGpF2nz6JFG5sRx4Q+fvp1eXvI7qsf8Xay3KdxeVeQJl7ULw8icz9oAdLqcmWfZlb/GVE5v7ooMzdqGTuBiNoB8XuB30zGl7s/rWQYveDz4PYvcGfdZwkL3Z/1IvdH11V7FZskE37Mndjs8nSSvxuDAxKVXpQ4PbgnZjTtN8KmdO01oZK2F5S18kl7ScHJe0jkLSfWl3S/qdBSTssJW3ZF5aRtCk0veH5krKffgGl7LMXS9nPeBFTpuCqVSXsp0XCPnuxhP1MXcLmznO6EvY/BT7RVE3CDksJWyIB+WJI2Gc/nxJ2rfuQrplDahXp+ulTl66zxdJ1VkrX2QskXb+4kq7/Ti+Wq0EBn4okvH9/HaoZ4fRgTR4IVpbcmosltycGJLcHghUlt2Ypue0LwISeRHLzuel8CPyA5CY+XtyXbltdcrvZZHd7ye1mph0bkNzCnsfFLSU28vwisYUDElujLrFdH1YS2w1hkawoscHOWAltySKhLamEtrsqoQ0PLJbbbis5U3AYpdzW8FKHbXAAWN1ioa3BBn7BlNxMgyJb3qLQlutKEhUH1Oz6ELnpsmd1YXo4a7ifoVlFIA0DM5Yd0NL8bqGzbwaQH2WaBK8gkcnyCfVYzgbspENjW9nvRBV6gZcYG5XE+EBQksbyjPYDQU1i9FF/+wPhs6e0nnMkQ1DRnFXZvyA8FuDGaVMEs6OBSH8HRfr72SrVlVnfFzeF+PD0Ohtk95e21EETKxxaAAThaVRXNOrtrHzNAXnNK05FyCzt0YvlzL/z2QAPVkvUh4HG8DlRAv682Txu5BsAbN81JkP05yKabdxsjmlBWKfQdkxiNzu1W4cHb7Xka96k88URJBNEjGTSz60aM/jMPW4w33hf9uGgSCSitEOEe0aUtmzihb1W9ushMgFgcBnYTgx42T4O0ZJcjMhzBdzgG13bhL038egiuAF/ko0zSDUIlr0ENRcR+c/5+Wf89ADiwyL74avHN8TXVKAJs7eH0n0E926Qzm9i39tmThAD4X29HfwWzogEGcL0VV3bgBJGCnT9uc8CA9dNN80z1pgbm/lsjG2b+bFo8zTzvpfKrfd7K5JcIqwaqpwR9vCg5Dn+c+Y5/jNth23Dph478TeIcoof6/FhsV0AjSmxbZ4KPCAa/pjoY7jfE9oW7nc8hCHXTuIVeQ0hxq3p35iKZIEM0MSYQDLPjgc59wqkOIR7MrJ9tLx0hgvfCohQ83UtQdoYHlx+R7io3BEzUA6uOsqbTyEYiPkUBW8P4J9eFeS1Jw3QcvrXlBcaTfbc92vzUsaty9ZwtA+7MCb7gfihzIez+USwxY47skJebAm32DHb8TKBsWPg+XX2L8AXuDMQh593itt7QITpYZfJqTEMqGlRJUdWpSwy5tW2A/Jow46LLKp0YMIo9X5EYEPC2g/4rwtCnzgML0LoAzfUyb5iOqZvAl2xrIEs+RXUNYETZpgMczv7QGDbg73itGLPmLQhQtLDfJhndWSHcVbHYDCH+6bLYbA+wzwdh4qMeweLh3b48o6ymS/TK4bRupGydWt869bYEUxsBm1uxlqycM7G1PjiCM/XECmBz4yUPZIdasSuWfToiG3CdCFvlyCGTauNH3eSr5hwzs1F4BcFASKlriFzKh8NpCYyq5ldi1nO8jXtyoO7atKIbUkGljWyN40iTnr0UpZfy/fYUZkgdwIis5urXwYSxtq0NkzZ0voz9BWjlmfCek/KnN0fpHYcl8drOX+9LnYDdLHnU2ua3RzBdIE/iolglcXpJponq7L3yZnbTe8IdEL+tArhf6B/bDwgDkgtG4mWIqpM/C2q6+kcgFyxxqb+yVIb+Pv8vL90ccLB0Paa6q/S75TS01d1gfPzOdU/LpboPrE14v3YOK8BIUTCIOInPeOfBWk35PCIy0PimvLs4P36ZRwdjb4+teGeUjuICdLwh4eIQh0lqklDKCur5PCIwED6D1TZYsf3ySny+zxF7tcW0FLUyl5TO0RCb+CRQyQS3irh/hXXpA8Z9TJPB6Ib0n/wDMq+xkoMyv4EGTUS+bY8g7KAGveGMrILYZ1B4a09g7da8vXkDMqDyUoMyoOJZ1CcuWolHmV3WBHb7hAyjvAoDyZ9HuXWOo/yYLKYR9lNxfE8P58jb3ucn0eDikc5FFQ8yoGg4lEeDbrZTSfhUR4NTsKjPBosz6Pg+ko8Sn84VmdTmhy5klNhDzeY52jrPB70OZVHg+zm5TiV/atyKhjtRZzKvkadU1mRQbkxPCUO4K3hqXEAZbmSA8D2JxwAD/TVOYDy4RqDsvv7tXl1BuWdccWgjC5mUMY57eRTxhbzKaM1PmVU+JRfC20ne3A5PiUp+ZRkGT5llA2JFrEpY6fMphCwyJ9aw15tNEzEnEVsimQIX6lsyaYkdpyGqjqb8uCKbMoE2JTEsylJxaYkfW0vEKsEiNEOyebBh4ftUJ55fiWp+JUE4IW0ka2xxqKFxYi0cY3wH+A47IiwPWANthIscURiQanyGPH1Q2eHCvI1JdsybEdqlazxvJORqocJ3CQcTFJyMDcPcDAlxpPAS63Iw4wgLbxT+VryMMk2mvCG7QgoYHiAh+njVbVEzeZ5mLXgYdZeyvIjwqysXcTD1C6DhxlJa0M3vLR+4mGt6TOMxqNSTdokezgAr6y7+Rgxsu7xbMixUgbH/l2eDNjKn1jEhpCsyIbcbGosyFHu/Yf5+Tg/D/HT7/ttUYCULMjdQcWC3Fk7DVZlQe4MBnmQO4OVmZA7g+W5kDuD1diQ/vlw6pyI1xylZec3mMd5UBwK+szInfWDosaN7F+VG8Hgkxs5Fgg3Eio3J9qeKPtakH5Aq5qHDTV2kfeb10zYg91K26jvNx9VoTYou8GERYn8SYwoeCBIxDOxQS8mpugiENBoGRDQiMilupsd0CWEZ+q9aNKcWpyPSaonJBG6MdgmDEUjOwjDeDqlxMeAXNJXpKA79Am6FPxKFW0q6eIP30GrhHFH7jDedhwyPMSHPDSsKRAVkItWKw9oMQyYlqiMGOAjsgejvuwtOFTeygSCWPJoCRdGpvqzxRiHdulrkb09Ss+Tr+tkMlX2tggtWDd48b0hL6b3eaRZW8Iri17N/YjMkGZKO8FWLozXwoXl2WTK7APU40FlOLeNngQNgHUF2V3BOqh38VccCZSDaj4VdQfDOrQM2qYRpp6eYzxapU32w+UDuJ3upV/sn5FN6g5vD/tuPQkTmNqm6Pe8QrRCbM0Tjul7Q6vpy+B/FUIghdpBnbglZ0O7hOkVnNbsBmpDZV4x3JeS5XkP5sJPE9OQNrp5aObKl5huHlXpdZCmiqkZsl+NivjSUF7+tqgAfJS+ml5mTKKBUQ8Y64LW/yo3xzj12XNsXNJwHvnX5LFT5SQQJUHmD6F9yJ+KSnZHki01ZPhSmL0jslF2fQSbGnNKAPAvKIHRxGoao3SYvTNiq7yG1OcbCnNVz03BYKPA8wDiSNdPVRGJ9pq1FewLqB6wgFaWGhrD4/ytkT8pQOeBnGk8GxoVgyGrlv3+7dCP+zor9imvzvVzhJtYglGvCHuS4yKUcxe2qTB7r17HibMq+6bGM2LO+Kb2s21N9s4IeMVsEg2CMtrZjWxumAu+MZpHes/eAQ8G/nZhb7NpVCebvyuehajW23lJR9mvR2lqWyRviR0yO4Q0uEZpkShfnRvf4rdz6pHyN0xT6YbOFkK+q/4ruyPECfPtQKrgZVm1icClJ2LHUJwHFBYc5352PLw/HVV+76mnyDtHLmZ3hgzvqvy8GiNapembkJBFub1+Z2XMK1KpcFVczCPAlC3uf2cTxB1IIrvgxibuItlvh9wjUTx7HzxG3hL5TTN7W4RRtEoAJaSNvcI7rP74Kjthfw9cdJcDkH0gBIN+v07/qKWYye7Od4HrCbe4hXdherD23/cuY+bc3vLGLdWNQ3eY7N0h/vhRqALbMBXTAlfBleqOYlJlmbqjHyjdqzgT2a9G7kU7fPQcHvRE716UXR+xi6RdVdLnDZEgRZKBy25EufeE7tgHjPvKOdkPrSsJSQq/L/T0dGvoFhbY3IUF4x79NJrLr0dvMdltYfb+0N0t9+9eMO6I3MfXY9X9fXL/wQVpvntgwQgEy74F4+7lAPDasTu8LzFvfPBd5fP75fn9C8bt+SRL4+u91f0Dcv/AgnF3HuB9fH2wun9Q7h9cMP44d4cWgDOKb7j4aFXysJQ8vGDcA3/Ckvj6WHX/qNw/itf/Ke/j62eq+8fk/vEF4+4/pF6uFa64PY+y6HMLBhGGvPR49cju2/nIntvN9P3z8/P7owuMwkX3gDy193Z5CpeOVE/dLU/dfbtx1/+ZDPntxh3vD7nc34eLf877+Dr/W+X9B+T+A7cb99hfyATcbtzu6v5+ub//duM++Fcy5Lcbt6e6f0DuH7jduLf/jQw5mlzd//9oew+oppbtcXifk4QWkIi9H2Lv2BUjw7Gg2LBh92KEiLQAIWC9EhULVlRUioi9F+wtGuxdsXfl2kDFBBXsms+ZOQngvd733u9bf9bSzJw9dc+ePW2XLArPWsXyKx8QOA5mWuF3KPzOKpZPfEiHZBVLHuaEgaDwbNyoR3QgVrHkfVAYCArPXcXy3ygcB+9Y4fkUno/rzyZwHMy2wj9R+KdVLH/yLwLHwVwrXEdnqG41y+c+IXAczLfCZ1F4wmqWz8oj8FmrWf7bDRLEX7fetH5NsuZKorlWrmb5AporaTXLx92mc2o1y++5bf260pprI82VsZqVzZPgGJ9/hw75apbfWDSkNFkmTXZgNcvPvUdHdjXLZxSNHE12FsOf0ZFbzfKfikaOwrNww57TkVvN8jor5SUsZTHjIs1cyhJxLszZ8HfS96WsVLZRjNkhha1cymJGiGHLl7JS4pKccF/ZKrFg5UfYDmN2vUqMVXNB4Pc1KGvduJTF/+j6YuHdrVlxcRFiMV5aPBl6AwekFkFY3w7rgERjZXjLfhEvI5FiKoHBQbBww4ELIDt1M/QSxwrMCCfVBjdlgGMieeiKXxukXnh1Zzjqz4sUUjIL+UJz4fTtGXxJw2It5mJSAqy0MwjiDaKuwj0Lb4YeToy15qJiOCaSCC9JOBF2CIx3NK4sucrvAoKZaBF9gLAWA78rBizZSSvwLk8krY5Xc9oH3SbGurgTxGDjNMU6TJ8N5PBLciIOoA0uuiwq2ddiFSTs/Z8qsCT/DxU0EErw6kIHpREIl2NiinemKGkZamiB4XWMdxWq2yJtVTy7WGgBR+WRvatY9LZKynmw0vrk1URYwaiUtZ3c4jHckcgeUjkFumU4YNky1CXnqN7FsY3thRUhRGiVZ0m0NMIWQErmw8bJi7BCdFuLd7WoIivW/8eKLPn+Q0W/ol+Q3qbGFUomdQRqFIGHblWkLUviXSTUjTc/3UqivVgJLmDx1WFLPHbzRHqEfuJF0jZQ3EyAmFglIB5LiKAI9Q1uFyyLYwWBEnpsEdExSrKM0REJ4ygcJEthruBKxSRFnB1xWu5qR0zKE1F5fPQRB7vSTT1tktAakeWSlMxPfAdsg39K0XOyyI7HIuHEREFpWpVzLaB3f46cMz7lOQuWFEpj83b4SODqgi1PyO1DXB3w+yPNVYYcSPEmWS7FzXHB/znwwNlXcXUSeXJlcKftOSde7F0Fi7WBLJOVO5CtOR/rKsP3qfbiWM6Jxz5VsGRuD2yjjmZzIKchLLAb4uqEbeAHkxdXe1IOvdKU4gIcOFkwkWUXB7tK8f1diNwFe0/h7MnI0vvjMhTXMld7rjQ2A+FM4sUuk7EB/FIs2DAWRFokwASxSolVBctOdlost8MPR5gM8JGFswuWS+htgZW/0WEgd2k0jb2QhowEaxlOaseFjKotvvulr1pFlWCHNjzr6ohvqUuR0vH1GD6lcXbeTljanBiEx6+yEqEmuaPwKuuIDYVgEmFCXO2KH2AsZlaC5fRiyJWas7DSl8RCX2ILfZEnXbGgloHXDVdH3B6CU2zviBzcqNC4u/Udht4uEBfZRRcHFvfYskyrX2yRxdTaZRsr5Zf+PeUL7pHsiBuJ31B+7N8ov7SF8inVu9BqZJgm8N02fueyC+ZkQhNdCNW7OmEvCtiUiR19VXKgpF6KeuOREO0VHctJqrji+zwH4lesiquzQFKliCRuF+JyyIlnY+SOnNT7J61PY3pFOrGcM+eAyVzKOeJ/vapwjOwaK3e0TA57TN/4icfRtRQmcymPR9SZ1OJVRV4mxFXKOXNlyFHcmXPiSgWTxPJS2LNSqSpkyjgGu9rjZjCclMyIUuTtjsxUJ/yfvasjZRScM/YMxTGyfawcu7LiWXIRZZ0XNti7hwM5FzoSgVKLkSEHUikmboIUTHpE14QJkUuJgoCrPc5A3hhwK+3xXHZ0teecSIPIvQ8pgsxSBz6BPOq5YLKQlZiinD1BjGBvUiKI/dLJyTPUjB55X2HJ0HGlLXaMZGfFcgnPBpcS2QHLWCcmNl/kShQQbPCksqUTgnhgKZ7GMnnJHVTR/BVZJ24RbdqRO12eoaqSuN4uZPLixyhbSwWUTsXChvKfp5+NhcglFiKn048uMwzGZ/GpiO/lSwvCnCWnoscv3urJioQtfVk91Ysttp9k+/B0FJdwU7+IKZGf1s/G8izJXoxP4TWSqEpUxr0nPr45iqGQHk5QmVrJY0WxHBbCJLzKggR5kY46CEt7CJF1pLyKbHqlrhZXVxwrHcOIYukMZn+xieZIHfAxFiZTjAfR6zkiQIw7KEi+iuijFNk6kfWEwRqFsgtinvGSSjtaJUFpDfC3GoAX8ww/K5Glu/4qmK8VK56VLsbqvMLrnR1+9aMcCVMr7YJt8cGx/dvg2FIHuZiaGf5ZIssxVfAw2VNDRhLr9CDO50qJWJYBKXY1JxXIBr/zYu0uSuKEsB2k5eAfeiyNs7G+GVilvvHmRdKatSNXZo7Bcnu68yHXqnZ0BhK5aUZwGMNwIh+yKrOOIik1v9WUAbmEN5tPQA8narlLQjbXnjwRmSarjJwJwboCEmy/SyAGhixc1BeS2bkXEY62JGW74VWpeFLeJobPZDRkqROSFQOiSF5HgEJxO0QlyxP9vTzHGD77t+XZxBQV+d/Ut19k6S5xfSfu5iTBeMG7IN0nUSSvOyDq6mTBhQB34M22kZyEd9CSNJyEz7SNlLO8g1aj4XU6cbAFpVjnl2cFP4S/NIXFTcU8hmdj+PzftJflxVreDdfAxvDOkZrfdswBl+aME5IMvyaUCAlx23/BgC5T5O0kLolx0f8TjEsFvRDsZ4QRLup5Fju6Zsh7spQ8AABdbOgbo51FV5Q8FT6SWPXvfzsLHIvNAgcyC+jKQ+Y5EZCRcCL8VO9AHkM5Gx9ii07KSbAjJUYYOTGHJXYE+wY8sUrFcgw+r0uEF1iGP854Y1rhHzPUUZSEEL8EF8TI7fhMBve7K9mjoUiO4W20fKZzpKZYHdYiWaFIU1FRIqEozE9wia52gr7iG4acxfhs7EyRs+OzmUh+JePlxOINKo3qGC8nhixT1lZI8CV9UZPscZNwu3gbLWaYWg1tlyjy740TCY0rYHo4SXjscIw0UIzJRNIYRLSB2DYAaaekmG5lPhNSSgIsyzL4QRUrr1Lz1z5Odo70i9AiW0qLlgaWbHqxlmOjkiytmwwa7occv3HbaOVOfGYNPAEctbwu2xlj3DZSzvAuWo1GI/QKm8C048UxvAiD7bTkiUrO4OI1HMMrIjUaPtMMwbwuQ6TBvXcgLm3oZsYJz3LOXoNZgqY9Q8WtsHtoKrnjQCnb8gAl4iQ9sByB1ELf/H+mb52YEROX8BwrB0ICYNGDIyQrpsIpUJxSgRA+E1yMWPGSTsmTKUaeQMiTmA9k5EWoZskMLSJPK+sCSpXCSJqKSiEcGfCIS0hh2Psn/waTHKFKKnZioUoR3qTZFFEe3Z1iUhLR0ggZiTnbELxBEeECiQ1BXLwNLf6/IShvJ6oqKhAUJn9JcYISF2+EqBhxiejstCHdr4Hx4KLldbp8iKScy7EE9QjO2PCo447YCLOtqxNbvDLGglJCiSJcOplo1oLwo7woWOoKxRy8kldjLAwhlqaKrXub/3mxl5ClXsRJepGlHm9GeSyvK6GrgKV+Ca+LiMRUTu4GS6z7jGUpYMm6jxffIks5/7rus//ndd9aDNlKUg+uHIspjf1/tvazmPSYX4p3+f1STOr+1+L/94VQTM8sZCEkayDzH3nESzGVbPo34pD+4xpIlXlJo4qtgKXICkhv14gANiYhrCTVm0hGYYIRNkiElBxtyHUHx/Id8XRleT/KFxhh8WN+WfzIPpNMMYl1ARRKdWIcybttuLUEkVACXvOYojVPIqx5kv9fax6PLzbsaUssE9POMjF/bZOW8ie6IRTjxohcnf7eNKF5JbiS3d+4kl1JrmRXnCvZF+NETkVhYjDXCTfW3sKZJEWcyc7KmaxTGl8/UTZAJCuDi61JYuuaxHAib3wx5Ei0Vf8jqeWLGMm/L0fk1IQN0cmpIR0bwqQx6VBGYkUq4fod6YLk9+/rEWVXRUzZsibRYoR1IPwfViNbYbngbITVyEZYjSQlVyPJr6uRtuRiBHRPU3yFsy1m/b7EYNv+bbBtSw62bfHBlhQbbPsSg81YKFMYbJuiwbb92zJEt07Flp6iShheREw7E+xZqFzy6/JjPYBilQ1XKFp+yuPRp2/SVLSAyOzR+++blvtvkuiAJZGsRKLblkS2hC7shF97KmZGTuYmkSUiIxH8qMfPKi+rWZmqYN45ycgei6XLi5x84/M3I7vKFrszICyqmK9v1uLrm6W+vsUWX9+sIOZng8X8xFTMz4aK+bFEzI9IMGIFWZEg/ySozYoEGTBRSSfe9FRPG20oanQebXQpQX1GtoWRrZZIX+BXfouMRx55pnSW8meTiQd5LA+SxFJ5IJkRo0YOGNbVCUga8kYqxWn4VfayJ2J+axLLbyShA0ksP4OETiax/HwSykpi+e92OPQgieV3kG+5SSyfREIFSSyf54xDumSW3yvDobnJLD+vPA4lJbP8jio4tDaZ5fNIjoxkljeUwSF9MssvdMShfMvLbd5SFjeMvE0nsdKqpOG0K7xjiGyFRE4AuCvSAgb4TxYkFFiQ8CnFgoSs5F+R8CmFIuFTigUJWcksf+M5I8sR8w+SWT6fBnOTWX7uCxIsSGb5rTSoS2H5GzQ4N4XlP9FgUgrLJ+aQ4NoUlj9AgxkpLH+WBvUpLH+HBs+msHwuDd7AJdBgdgrLz8olwbwUlk+iwU8WlBQsZXEzyat4MkHJp5RfUZJFR1f6GtM2JWmR1Xw4NcEvl2CVbrzkEmFcV+BEcpYcChi5mANqq0YcQogU638Qx8dApaTIjV3R+6dFAZ3FF36sE0jJroded4PwlRx/sJK/OFjIy1oc24MU22QB4ZGMzAkbi2N7TkTV1rHqAuGcRGgYvwySOEM0xgXz5eexhMQyYfy/WcZ/ZZpl/HWpv47/yjQ6/ivTLOOvS2X5fELcc1NZPoeEklJZ/j0h0LU45EKINpXl9xHy1aey/E1C3GdTWf4TyXEDl0Kg2aksv5xMh7xUlv9aCoc+pbL8YvItbjnLryehhOUsv5iUvHw5yx+oikMbl7O8gUD3LGf5rSRv5nJLvReXs3w+gd5ZzvIXSd5ny1leV5ZMoOUsf5ZAvy1n+elkUs1KY/lckjcxjeXnkDp0ywSq+raUxZ0nUiaphKpWpv1KVbpUSlVPsFCJBdFxywREZ6VbEJ2R9iuis9IporPSLYjOSGP5jZSy9Wksf5YGz6axfB4N3khj+biXdEKksfxyGsxLY/mtNPgpjeUzaTBuBcvfoMGEFSyfT4PLV7B80isS3LiC5Q/Q4J4VLP+ABjNXsLzuNQleXMHyCTR4ZwXLr6TBZytYPoMG81dY2/BtBctn0q+z0lk+iwYT01k+mwZXprN8Pg1uTWd5XR4JHkhn+QQaPJnO8itpcJZlAOKWsRgpREwqjQxAVvqvA5BB6VWqBj7Bgv+5Fvx/suI/O/1vjE7A/ycr/rPTWf5GNUKY6Sx/lYQSLG2Zu4zFCYjIUzplMX9rSzYtUhoBfJKlLYmWtiSttE66lb+2JWklbUvSSuukW8nyGRQdc7HQHA0mWVqTuIzFSQhpriStSVr5N9KkhUprAb9xmaXu5ctY/pA9FivcuMxS1/JlrNQB8A9RjqoN/AFr+q3LWD7uFF5f8Uchw1aaYauQoRbwZ60Z9MtY/iSRWzxrTa+n6fVFFdyxpr+4jOU30gruWDNcpBkuFlWQa83wYBnLryYV5FrTP6DpHxRV8MmaPm8Zy1+kFXyyZsijGfKKKpiVZMnwDWdwxhXMSrKk/0bTfyuqIMmafm4Sy688TSpIsmaYm0QyzE2iGfCWRTZFgjdnNah0il2wnFiaocoLJEiVF7yK3z8UyUsTu6Yi6suBmDj9J7EJxnJ+oHtAXhYsRSX9IJANPPG3BI1hHDFpyLjDOHomx+83sngJtqRjEeWn5dgFS9taxLMrC7+CKDyRvf39p8pYu4S+iBI9ExqqSkReiEaI2JNfU042kvjbYbWyJRIifEZl94sUJRpCcbs3wDHUdzoITafyPIItkUaCqUkxsTcniM8AwSJLzNdY/P5gUTUyMETklG4rHYNlCRLaacdg+omszlKiycD6YEMpWA5hUqScqjaQH9arioQvspsSL5HWtaLd+kJmR17IqBA3Y0GvCEDaklIEw0EV/F5EZK63MXJwYviza4lEPBH2Ll2aHBZkYqyIQXe+a98RnRZ3LF+H971yFrvcXCKRi6jBHyJgILZY3gLq9YO+IMpSSdZKuC32vQS7oakSwW7ocglRoiEu29RykC2nyizPIDQEwzpgyFOwZEvC2Rg+x1b4IGRKLZFJKDlZIui5827BVGaaCSbWS/FVkJbPesNgkbj2BMIGSz8Kei6CngTLh8vxs05sVDCpi1jnwZ3HT/ExvCzEm1jFYgSVDDvhOO5IVCqop0minCFbQtSS7LFuCj6hSGVLJIKNPpbYsTqGL8ZITIyNgdqQD8QJUHCI3N4CsMFOWhyCOQnWbT5GLuodMLU5CHZwWHrmkdIzjxintw+Wi2VJ+FoG3MGWFmPH2xJLsnYWM8HOeDoQ1f8iGzuMYGPHIru2v6TfPIwZG44JsaLFlqDFpggtEitaJFa04NdU6t2uOFpsLGixKY4WWwEtIg5rZ1hQgO1McKLinbct2Xly4JMU61lZ4BjhuHgKH9fSmMpS6WCGesTjWN6Bqo+JhAMlZU3hVHWMlS3BxCsXEyKnFYiLnyhFFvI+xtDaIq3sVExPrlhtmJGLrHgSERueJB+xpCCmVrlYThTMiQUTv7h0uucmQjvYQBP2+YWnGYkzsjSJVT8ttvi4FNUoFrKQEaInB2wpSozrwXUfI/3jRMFyXBfWi6TNEOMBIs2g9YuFpoUQf0Bgrd0qmXCkiDCokBHjDs7WOxQLScm+M4LorVxMxRJYfGsikvIOrmIe24aDxiCV4zF1osPJM4K9ZE4sWI0iACqxhFFOxwqo7AeVEcSULnZl6LUYcW5EESqipqTJ24lIsCZND/vS9Yx1xKwyUli5KrY160ja/5mRi3miX8lSOTMRtXAnouxNRNfC1iw2IxpLxxifjbDMKRG1onCsqo81TAjuj7JSOfaUFYsdWGKUEJ0oOzkW28Bd74G7IEhiMYJO/QL2F85EbkT+zp2wqPT/zp8WSn7hT4tK8qezAn/CqjDYZBhmUWd/YVEYhi2RBVMtMawTH0z1wjh7kpjhmf+eW1G9SKJ6QwTf8FnUrrhd8xO/MiSKkJJMScDG/8iWKDaKsaVFJdnS2eJsiXQbK/JZeFOxrv4rb8KdyPzb5CFk919PHsZVTOQZhMnD/DJ5NvyfJg9LxbLlUOxiDOj+z0LT1ssyaRurN16q4Ep8spULJmZIOUa2WUKagz9gAaX7rGCfVHqJIVL6gnQgEyIX8/Y9CTo5LDCsCQzhr9qH8o4xcgkhIn6liQkmasc9QngmuBvpDxv7c6aaj91uim8GcXjBZbJLwAaKUySCqWI+4TKo5YwsRUKs4CVcxhuEZInUAtYdv90Uw5MoHEdDsWV/IVvyL9mI3pSgh4fDHYgOQmPg2C507SSC42IvugHxskj2WL7LDrNdpIdF9MLTM5gsE7E8Q90cy7ZIsOAWEJO1lWkCTBdEEh3ry1PNSVveLoRaRiADU5YT8XkmpjXxGc1QEc/l+QzlYxWDeeDr4lUPW3MIpkrWGExqo34LsOtYCZULJTJjPJA3ROyW0IG6XxbVYzme8apCHUpb0hZLWbG0Pd3ui+qxjUqxgC/MRcT0KP6ph/PSYK2ioFtRibR8okpRj3VzYoSUXWmonkDYIuIdGrNG7BuQx57jCKKIpwRerOGBb0l6KuYFd7ixGDtEoRG71mGotjLxq0AVIgTrR1VL2xLTkpwcqx6LBVnjioJjQsYLP9+KqUNCkI4QNvwyuciqnFyLUkNFus+XYRtemLa8KEVU5NmudD/Rmq3oLKWHoNZ4x0mzAOlscGu2llRaWdCFsbOMDxUJ3CaRSlv8DkTpy05u8R0J1k5JfQVdGDFROgaOteArWo49NxNVkMpUnFoi2ynB70RUbYYUJcHTnXDhyCrFS3UgLSEHlQhSwb80y1GwCSmXCIAM/Ogo+EbGbRBpg0mSisGCwqwlGX58a+3EWDwVir3x9YI0hRFOka1YYbqxXS0Hy5b0k0zOlhgZUdHIYHLHghBAyU94rhIsZNdjK+JrUqqrSjKJiOl7khbnYq1ZSgyaMKD4mGdpEzFRCsQELr3HZVuzVaX4uV9kQRcnLo6uPRJCNIJjQAqirLEeKxPO7GVxV8nWgLSGwf3jnAkXa81yOEUjXvCDSPCNsU/QK+LIfleQ4Jb0oi5f2zMt6SJI1guxbJ+AcWIDpzG0IqorjaEleeGzwcVXxL3BKw55f7Pj2UjyiFr0AdOTSPBgS8R3eTFn28UJa1JjIzaN8KIa6URRjqcmmYD1CBrr4aAw5xnrnGEIZi2UJKE9s7H4SJXtJ4sDpiQbLL2kxX7oCSVJLIo4wLPUy6mlcGxmhXSTFTpvLQdrDnA23sLtOeDOiD2LUtMSvP4lnyMrBWvxjCUDrZygjpia+E2dUmkPy1yV2/J20dhJJlZQIywR7x12EhnpYrNTRA6EPLZdgOdnkS9ZB5B6W8uywWURAwKRgikbMtNdJdJ/mOk2pCSxUBJm6tJCBv4fESzrKZCsVxE9FuNjhCiL9YnQJBGHE2FKwpTZheyC8BtIa7bR/42oirhmiV5LE//rbndxgn/tN1O830ID6Xwt1k62iELB2lIQWmrtoXQZy9hY+YekWLs4sWw3uRZpDK1cbelswbJa4A6tCKpc7WisJZ1C9kVuhvG8tyUZ5Q4aV1t8SmgMLeVSDZZ7wBTRjdiWsSHTy55OLxsrlWM5k2IULirGGERSYs27iDNQbQU8zDYlq6eVc7a4elo5Z6fBQtN4fthw9mR+EGtUZqKASTrF2VljLaXt4N+w8ss4l5gpVX+fU4q9whY4E0MqsqWY+STQGzAJ8N+qSFvQi7S8d8LzuJjuroiSomOInDj6XismQnolVQAzJcLLuRhqgtQGOKgFUhnUBCyXEBFJhX3IXRluyjZOvK0jNyOOeNmG0uWKILgr2zgbCoXSZUBa858gtts4O0uaKiCtXcJv9zbOlsLstnH2llRVQSpNv8bsYoDX2UlnVeoSpQ0KU2rDNZ3C1aODAt3dAzXKmCDteAhSjw5S40CEJnyUclRQKA53Uas0geMHKNUhluT+ygilPwb10agCgvy1QeHqLhpNUXFhqrBwzXjwUo3SRCs146G7Uk1/o0PHw4Ax0ZqoAOV4GBCtIr+DVAFqGuqv1EZrSCBajX96hZMfL00QiSnHQ+2wprUDmtYeDwou0i9MOQ4aN+Q4zm2w2zho7Da4odtgzm1wY7dxDd3GcW7joHd4DK4O+OjA6Cgt9AmP0kZrVJZWalRRWlDFqNRaCAsPwz/aoFAtdA8PUmt7BoUFaaMsKWNUoeG4v36h+DN0igjyt4C04ZrIaNU/ANTRoaF+URFKf5XfWFVQ4Jh/LFiA8JqwPpqgcI27e/jo0VEqLfQMUquUGl6r1Sj9iw2TVqkJVGnBRxOkUmuVGO2/S2IdYXf3AC30It2LDvMZFaXSxKjoRx9/LYxVhob6KbUY8TBaQ0fSL2pM+NioYm2KCYryD4+Oou33ElIVfSY96jTeP7QIscqAoOgo6BykUZG0ytDOyrCIIHWgu7vSXxMeFfXrSERpg0aPVqswQDk+NFwZ0Ck8LEKljiJdtCQKVcWoNFFACFTFqaPDRuFoaJA6JAq0Qf4hUeDBuXG9ubCmNIR/3bhwDdeM04ZzzdzcGrm5uXEaZYAALwo1axoFSi0XFh6l5dyaNOPo1yiICI/WAB+hgRgVRvG/NW6MUh3gFx6j0vip8ET4B6T4q9RalQZjPXyUSgNKrkRHMKmqSKC/KkJLQ51V/jQQFB7lN0oZpXJ39w9VKTXQS6mBAE14BE4Ltb3da/dyr92fqx1hwY1SHcCpw7XcBJUmHE8l6B6thihtgLu7apy/KgK32zra4F+sNxCgigmiISUXrQ7ScpHRSq1Ko8ZfeoWr/4mEI/3CgtS/I9hAZZD6X8mVJPiVPEsA/45J8vlvLEyYiFFBgWpQK9WWwRJoOEwZFeUXpvrbd//wMPq5u1JdYvpSjuCn1IRZyAo8OlgCmLpoNAzzNNCGh4f+A5vUqEYHhYaSSYbJKCi02KTSqKKCAqKVof/QP3W4Jkz5T+Xh0Q1ShmJ+CGNUylDtmL+jIVzAod8opTpgbFCAdgxEREeNwTTjPwaUWq3Sfwzmh/88O0PD1YEwShkV5O8XpdUEqQN/nakBNCn0jg4N7Y+Z268A/zFKdSAO4F9QjgqPUXFuhCItM6wZnYghgQSPIbi+QLzwQO0mbj1HQ238bzQoQ0PD/XHHFAM8cMNITFUvKmiCyk/LqetzddV1OUzOqoAoLkw5LigsOoyLio6ICNdoVQEcTvePI0KwA0p/bVCMCrSaaBVehqD4lO6nDIv4hag0Sq0KQvF/EeFRKhitDI1SFRtLdXhQlApPMtW/sYjRygCVnzYoTPWvK0xEeKiKsp9GVow15zBn4bRjVNxoZZRWpeFoqg7/VbLR4Rp/FfjjigJUan/V38eOcBWlmqQK8/MPj1Fqgkj0H+ZQlDbgH6YQ/vorDt3dI1SaoPCAYsNg/fTLvmGQUus/xgr8B/QIECvbLkFQ4WpVUc8tFfx+HIQxHRUerQ74x1kwKlSlDsD0GwBjVKEBv9vkRGmVWlUAWSRUARi/UVqNMkitCvgdMwxTjvOLilCRBL/OeaU6MDpUqRHgZBKp/NTh2iB/VQDeIFmYEBfVVKMMsLKiX6Ik8jeWgKk3wC+CYoSuA6OUAX5kTuFFphgl+4dHh4aHjfp1qbd89lKNAi+NUh2i5LqEBYUouT5KdYDSsuwMCxsBbnitLVEhNywkcISFERQRq2ULyQ3rLuQq8aW2kqs9iqsdwNXuZlnehkAfn/7eg2lnB4EFAL353tCnF/C9oGcnP75nT4Kq7tCT790VvHt7QSdwa9a8RctWrdu0bQedmvgO8GrclhZCSOmP5tAM7xIaNwMlF6pSB2rHcB6cG4wN0o5pAmHKcfWaNeJCG3GqiKg/Gjdr2rw+15QLC1LXs8QbcVFBgWFKPzfyFaetX59TdOCaqxq3wEmV/mOC1CqcPSg0XM3Va6dq1pwLUnMB4dGjQlWNuGZN2qha4g+jQ8OV2vpQD28c60NHpUYTpNL0CQ9VRbm7RynDIkJVAfUoddf/941mI65o8aJ7AWuKJtapzuEOkI4Jza8PfaI1Ki4mSKONVoZyo6PVZPA5f2VoqCrAFRpxgeFaDtw51bgIlT/msSD8cZmWUEoy/tuEvkwO1msXj0EHqk9/3ffAfDSx7Pauf03QIgo/iEaTvxcI+NOuUlbmCfwdV6knTW1EtKwhnt82vb3Wa1QfZCm9ZDxf+G3paY3z6+VS0SfEAH9ULu2Yj/7n5vzSDeC316TNy6z5++Y17lT19ZPWDdB/bt78WkLzVtSSajpnlkwIYGlmC/J33do8CpV50u/vf6kg+5dfN6HCip6WBljKBX5FbWm/onyXLuK/PBJXXbrE04688qC/XzwomuKQ5ZfmayeU+0n4noiAT6gjzRZT/BwVPu/526/Ijmb0kQIwuIESABYA+tgDiACglRRADAAnk/0uMVNfoMS73OK5y1+gMeN225i2TEUfF0zPlbWVG+CcNrdAPxF1HOqfZb9qMXp39clcZW8dqi8/0eDR2eVIVCfitXpFCmru69ZgU5kIw6wD7ZY4wnS0us6XSYmluyJd5zL1RpVeg+InNvozd+pqpJg244d9kxnIGHOkZRddlKF8uUj3cwNnGlJwM9rNNgxfJIppNT4FfavsPTVCkojWmp8P3QNpyL/z6qxdxljErHesmnXN1+D+QuHvt2sKarviim5Ci9VI13XARnWTFWj10hcD7bZMQdtL6Q5sGaQ07Oy9xFQpPsJgnjBd8lHUBPmMXTHucvmRqJb/3s+xNyNRrk+Vmy89Y9CSO3uPPFxUFdXUd7BjPvczhPm63LUd0holFASV+74qHn3dllbPPj4O5T+YeODZgShUr34GrHdUGLST9rT1T+pv6NWzwqjCrt0MGOficgC2AICHwB4AerfQhKnaqsYRthLVzK1ftDpQ1SNaq1V69wxq06VLl19StOkzZnxUkH+UBeo2DuBRWYDB4wD0ZQG+lQXwOayUBG59iCo27jzgq+tLlPphyjVplEmIf0ZPVE3lsQ0nKGyHl21RZ/0UxZEL+RNm2UYI8YUKSz7h13DNtUXspLusp/CbCby5gTS3nI7C7T2F30xMO2Lhnw0ATPu8Gjr3VsO3+uXg6qC68LBlIYy6nwmK5CXAJ3QC/74/4PCjLbBfeQrc1bXgWq+O4G2TDfavmkDVRVfhdbUfUH9nVcj12ACFraZC58NNYPnLONhTJwL4yX5wa2E76D+tHSwvaAdz/OKg3ucj8KlGe3hkXgbOSRIo3dQEDkPnQFiNMLgyuTXYX6gLXj77YcVoBI1f+cGhutHw/PUZ6DDxLXxsZwuL+s2GryGvoMZOP7AbMQ/cRANh4jcvyN8SApz+CrQuSIGnm6rBH8qFYFflBUxPVsHKsn4wz3MM6O6YoW5UL7CxaQbnB5aDcxujYOKTkRAyNxMqnewKlwJPgH3uAxgyrQHMiTkJ66suhc47HkKlQVdhnYcEJLZmaDEZwfHmuZDk8wgO/9kc6nQ4AdVDTJD+6Q9oVcMdYt+dh7czq8GkBFcIrjUJbqq/gFvjsVCufSfYW/Y0nKiUBttOHodGvXhwhBEw408veBrZGFJPp0CLUQB7rk2CPRuWQRvfm3Db4wOskVWEXjHfICCtAUTc3gL+kz7BhIxBUKFcDmR6D4T2t+7Chri2UKvmBbg1eywMHVAToMZBeOtQBSpdfgzpzcwwunowJA9SwtavXWFy7B2Qq/ZD89x4eGEYCaaTlyC0tT2MQDeg/KPbMLj9I3iUugiuyetBvRm58GRwLzh9vjnYPS0P2X9egAqZfeB9tQ1QMXsYNCnTEqa5jIJp3RgonD8MtmXEQvWX76Bb904gC7wOmx/ege1+HSFYeRkc6q2F68l7wGb9Oxg+NhbWHJ8GSsUsmB01DnbMHQrht49A4/X+UGC4APOmmKDOsUDwPd8Fzt9tDfU2XoPjynngcm4siOuUBRevVDg55CScPdUZeu1aCFDhPdzotA3qez+H7zdlAEe/QfXEixBx2QhlPAoh760OduecgDOf6sFiSSIci/SAJva7QdrlPcxyWQ5buInQZG86dF10HCY2bwqOvmGg2ZAAITk1oNmFpTC+fHfgxz+BgsfxkJu4DJ68iIPkZstg1psQ8PNrDYe/l4JuKXsgcG0oRGo6wrwRzSG93AHQP7eHec1qw0dtO3CTVAUnRwZ62I2BRsbB0HVzAmhzWDhyqxZ8/HM9qLtpIL28CeYnroc9Cz/A1f594YrDO+CSWkBhj8mwy38MPPTwA88RIpgeHwu+/epDm4BMCLsjg+bdmsOwntHQO/IGdBmgBqn9MWhQGARlR9+EurZpMELcB/a0vw+vYk7BzM8VwDvkT6hW9xAsDaoPpy9uhW1lB0DCk2CYdTceGmn6gHjtURhrmwjv3SIAvtWFV5EbYfRxbwjI7gDLHk6DNWgZdEr8Dk4z5kIz/hEsapcGDyPmQoX9OWD3uD2Ua9MQhutWwlDdYpCVXgTOuXcgVLcD7pt7QNsEZxhSMQZGrSsHyguH4Uz8QZB5HoFr78TgHV0XXu/7APflh8Gh7GaIr9MUAqbFgH37FlAqsTL0dd8M1dYchx1vtsPwOi4QdrwXNJ6wHDIHLgMRmgb2+R+goedcCGuWDO322IIjVw7unBgGhYtOwultPaD3+XWwoc0leLGpNWxZlAgPO46BSv6PIGauCcbM6Qff7reB7au2wONyzQC2rwLHr/cgoNdoeCPZD/VVbjBooAG6mt0h+PNBiD76HuotfgxbdG4weu4HEF8oB1/kNnD3WTXosHstDKqyAFpfsofeHV9CmaNroUXNvZC/uTL4qDbCtWPrQIqcYdi4S1DzcwxMnCOG+AoaOL2+P4Srn4DpNUBq98Fw8t5+2Dz6EMRcuQJX2Wqw821jmJt8DE5sGwszut2DjyNWwmldAWzNbwoP81IADddD1qMwSDhTAxrc3wdrarsD7EiBbf0Xw75BYqjfeA/00E2Ge7YbIGZzKZg4ZBWUd2kAD/Y3hi/Pv0P8/R8Qf/Q7PIsJBZtN38BDFwHT1eXg+0wz1POwBWVgC2hQcQb0OvIKdufsgAVhalgS2A6aGYZB3O1u4Pa4PJxp3AlqK1vBuYjL4HbhABhCv8NaWA2S0Gcw9OFKcA3vCqNcrsHB4XEQofSGkIHZkNyPgT6+baD6zf3Q4u1JKKP2gxFuz2B6k01QbdcJWNW8NdjtXwuvdt6A8h9dYUHQM6hrHguOIh3M82wMPpdWArcuGXavvg5NRzjAns8dofS9C/Dn0SxIvX8MtlQ4AudXTwG74OHQxLcC1AVfiC2bD3/ZzoCy0gBYys+DmUcfwb3vDSCk9j6YGN8SJO9/wEHDChgT7APdG2wEn5NDofEnPdwemgQFZ5aAU695wLmvh7WD/KAs2gm6tkvgIsdA5MMZcO7RPjCMLIReqtLA2IbA3IytsCszC/r6doPqX0vBEs0JWGPTHjI9W4HNg4mQ3eUi9K7/BW6dPwu573mYFPAIUgPuwN2jzWDtshMwdvANCHp6CvLvlYFD7grwqugFvtF+cO1IIagXnYatTUZAqc5voKpHR1CenAn1v7+EnFvvQT7pPIQvbAV22afAfHseqIOfQMb307DY7hhMGqGFkG274JI6DTw0E+F06WD4eGUT1I96DHvPHYL90Bee7HIC7aFa8PzPkaC9MxucyjWCKRUdYfLoRGDql4f0CTHw/ftRGNjFBHcnt4a8u2VgzqGDcHLZN2i2sS68VZ+AxFOt4c7GgbBn4164crEUuMQ3hvBBLaHRwHhIvvwUbnEHIeSPzeDRYDmU9rsI36Xd4a+CrzC/fRg8mdEIXt6Ig297NoHJeBWatDoHTdspoa1rZ6hy9yxM+eYAX7sHQ9Oqd6D/njjonTwXBsgvQgPfB5B5+hZIKy2FyhEHIGhJANQZOhJQPyPElnaGgr2l4duFQmipbwwt9UbIHXERHv4xEgLnp8KiFiY4V+EAKAenwl+D9NB32mm44yGDh5HdoHHVh7Cj4ipwbeQFQ97fhrsTkmDFgEzwmfEFBtp8g+fjt0O8vDW03SaHwMUPwDd3M0yt0xbO56RCX6e1kNxiJ2y6XQqCJN1AtSsfYmdtgFk9l8Hnq63BddFumDi1OyRdcQXP9AfwoKsv/KV1h8DXHeFH2mP444YfTAxcC4e2TgDfD6uh4ayawB/yhSFqO3BtMAPadZ0G8U9fwPMVN8D7qyeYB76Eqs7n4dSQ2ZD4pSFcP3YKnE9dgftDt0PXUzNgeqdR4DqjPTQanwgy5Uxo0HMi6BpVhk4GF5hVJwHGKeJh48ln8Pz+RDjpfhzqFLyCj4GzwWmRAVRrGkKHxTvhyCQprO37AOo+9Iegvx5CSmIl2Fh/CYy5XA/s3+yBzukc9E46DxFT/WHypJrgfLA5bCicD2UH5oDrWzvYm9YAwif3gnWV+sLez1tg6uNbsPShEsq3ZuGkezpMW70KNG/CoN28CTD1wCYIaT4cvOoOA2j5Bq7BWPhW4AvMkF6QHakD/n0mSLcxnnjvjPfwjTtrPX7+6pK8Pil+nt9G9r04rj2OT6uS3w4APLnaE9riuHzq09Y4fbX3Qa1+TG2o6louUDiyte3085D5o2OTGIN7+xX6lI+OR458x2oUj5FigK+vr+8ptLBhhSu+vutQhay1gaVLTxGOfGc7mtrhfC9QrZNTzUcMl9HeAsfbdiFb0cU+Xte27JqG4tx7p2bf9sUn5uMgvdYsH6kNsyr7tE9VtGrxdVOHDyY04sGd5WVGRuqVurEeKXkmdHX0TNmEPxL002PVueWemlCZD4Gt+l2bq9BOL3c9464JfZn/uabu8hz9ow8P64dkmZDy7Atl748jFWdToyt2OWNCyddbDHu2JkEx7f3p8x5HTShs4rQR61OWKZzjP4cO3mtC30zfF1XeO1/xsaum4aKtJnR1edOIDkc9FKuvXm+et8aEpOqE+JaiYH2V6z92jE41oVJHmjboN3CJvu8wlyxmsQn5vuo916Tro7/YLDTzyGwTKl9w82DNcwv12Y03bU+ZakI7fIe/fHpdp+g7f93ZpAkm1G3xulflquj0E/v+qTigMaEOzR/55tdYoH81b27bz8EmZOhfBs2Nn6OIvhD+epi/CdV5XTpm+d2l+hvDxXHZw0xoZFN3j495KYrNB8c0mznAhNLazrgwNWeBvtrdb/I+vUxo3on1nfnw2Ypbc0fNau9lQn+Kn2VIJugUSx/8udAbmVDixo1Pv89fqmg7Klo9oa0J/dlN+67iHzMVaP0un8vNTOhdTo2khl11ioeTnqi6NDShP+wi0cQDS/VT/Av/elzLhJptsQ/76+NUxV+PahSmVTehL4bwyqmuHfQJd+9lxVY0oT0OjpqpbeYopKJn66e7mNCCC5fjF5VVKwY29di0w9GE9m3J6BXda5qi3P5mDj9sTKindusTpuMMRbM7Pb9FMCbU/dP1Ee0eLlCYywfssvtmROJh89vr1szQv01f5HfqgxGN6dPj4pvui/QXNrm32fDWiOY37lvlk22yfvQdSdj2PCO61jrRI/dqpP5j+vOW93OMqFyVy7srVUrWP99Y5kTjp0YU1rPBhm7p0xXyli491z8yotlB9SaMdFmsr6rbKu5yz4iGxVfotmDDYH2DJh9dHW4ZUZUU78DURpP0yzb2uVt41YhKbz0+8o1/J0XjeOVIu8tGZAqwaW8/eqliEFR7w583ovGiVff+uqhWZCmO7V192ojcXJzRfPNixaPrt/MbnDCijB0TDl9OiFHUbdD65j2DEY3NHvD6SLXFCqeH35N36Y1o/ppIaJm4QL+hUVrMroNG5L1m8YOLj2bqO46+svrePiPya+t85PSjcfqpPmkDG+4xog/DJ+Z5uczQOy8acX7tTiOaf/t7RUmrxYp7dfe27rrDiCSps5vuT5qo+H5m2Q2XbUZkP6Dqk7/8ExT1B3R7aLvFiF6drtRn+pmWiv1eQ2bX2WRErTIDGr5onqjo5rqtXPgGI0qPSVZ2fzZXb/8g5uBf64xoYy9T+1Mt5uqn+7pnTF5rRNtfNowf1z9Oz5242NJrjRENHjxw3MPLi/W15b5T2642ooBKk3WbZYMUUZt63vBdZUT15H8YTLsX6y+1jx29YqURTT3YcuY2l2C94Z402mWlERk3hR0wBfrrm1ZWKXalG1HfWdkDOjzQ6eMS+37+M92IrngMnRxQY5xe65eXG51uRBl/zsnsbpyh105Z1y0l3Yhmv/Ct3rzSDP25wI4DX6cb0fUb9n9cWJ6gQCMe+QStNKJq63odfNB8on4m8zqq7CojCskMHPA9L1HR/Jgb82aVEfmG3try12uVYlTvK63frzaijld2Nz21apbepbLHgLprjahlm/Zv9wUt1pe53DM5fp0RVTdXco/7Q6ffdqamV+UNRqQepLnT50ai/s2izql3NxoRzC41LHBbgiJ59Oy7ZzYb0Z5X+cea7p+nuL+yQcfnW43InHNq+ch9Kv3cznvLN99hRJ393g+Z9mGiovXYcsnbdxrRtA7VN9SwX6w/bV4oHbbHiOpXD51zYNMI/fNTlzLa7DeiIQcTJn2uGap37nf2QudDRrT5c4G8U6dF+j69H6VPPWJEPeaPvh16frr+kO35iLeZRlT38sKG33ZEKhLy10xdeNKIDkc5/NXqWpiiZs2nlfzPGpG/fJRcfGqmXvV8xMTRF43oZrMnT2dUnaNo0bh7XmqWEZU7rL9+9fBC/YjaHrtEN43oWjPj8mYXExSDd7uVWXHXiHYPjVLHBcUpDN/H+4Y8MqI9afOXXXo8VT/h/XVDyFMjmtniwqKxlecqtl0fmpyea0Rf7l7tvmBign70vnn1bY1GdGj7g4F3T/jqv5bzObD6vRF5fljfodTaBL37kOfzNJ+NqOXibW0Lbo3Rd/3j67sYsxG1mj045Ilxob67zSq3DIkJXXro53DbrFVcO9YjobqjCW1NWvTl65GFevvqt4cddzGh3Y473LaroxTL+01/mFrJhBK/pw9v/nS+YkKW2W8LZ0Jbh9hfXZAdp+hxdVCTt3VNKLBy77Y7Lvkr9ubYJIY1NaExlRaFNgoJVAQlmB5wbUzo2t6L0yrO1um/nBjhK0UmFP7FjEZsW6CfFG/bvXFXE/LeFN12u1OC/l28k91MHxPaYNth/fQ1WsXMtV8fVBxsQs5yT27Fwqn6pGnnyj8daUJbFx272WfofMX05vdFL4JMqEcIs3WIe5xi5B7mvWuUCdXw2GPrenOq3i91Yotlk0zonFPX9gcbxOvrryos6zXDhK7Pch8p3qdVfEBzcpokmFCkJq1v3qlpimk9z3ztm2JC+QuvL3D5uEB/L2Ht6h1rTehPbc0nSdvn6d8Gzm/cbYcJ2XGbef2J+Yq6Q5XGKodMqPnrTScSG8Yplh0KadPwlAkZp19ttilgtsKzi3pYTJYJvXna/tmhNvP1ZY8u3/b9vgmlXVrYq338WMWdhBVTjuWYUPzFkfwxSX/F28gFDY+/NyFoS3cIboFnFg9636QDQy+ZDcPc+v7cWtxECV1em83mK4bSzNtau5PPofSzNs+jfU8ZhMtow1i8AfG9iS6QHckVg+PDJcnJyefQhi6BeGdicHvUeU0t7+NI1aHjWrPZYDh/q0G9uEg9Mo/J6PQ6+aBhetaOj1On7EeXulyNLtNvryH9UfaJ/JYfESS8GB978bahxstGwePKfEQATseN4bcNK/d+sRv57gOC7L5lnpa5bfhzbpka669+QDCuXtthB24Zru45JfXeieO6BN8RtwyHHJu26LrwAwKoGJPF3jLU7CivmB75AUFCwozzG28a7lZfl+zT7wOCPqKBnXxuGk7WWrB5YIsPCDxDTrT5cMNQ9kFayO6yGL7x+4a0G4aew0/3C/hQiGBjfLtFXW4YfBot3Bt4pxDBgYx2BW+uGx4lDLugP1SIIGJB58tLrxvGVb77TplWiGDlkQrVPa8bZg70chmoK0Sg8zI9eXnNcD0k5/Iy/0IE2W5tqyReMyyO3fCkdtdCBLPuzT3lcc0wrYtNR3ODQgQJdev/9fKq4fGRXfflzoUIPnVrGLbkquH2o5ZdF7wvQPDpYEogf9XgWe/RlU53ChAkmRKz3mQZzq4Zl+lxpACB7H7FdSlZhtm1s0/Eri5AcMC/34uuWYaWcTdqSWYVIMif0UX++opB2rhSlcthBQgyKkR373rFMKBiu+t3+/+Mu8k6dF572TA0bk/nuu4Y/rKzE3vZ8PVTOX4vh/OPrb965CXDzgKPe1Ntf9aXsETMZF40LPgxaMQC43sEsviB9bmLhpc9pSvv3sTxKfMqTLlgaHhMljnyyHsEWdcvnnty3nDgXnTDWut+whNcmnh2OW9gs9Ivyee9R5BfbczYjecMVSfEnRoW/R6BW7egMMdzhiett3lfHvEeQWaX9VzkWYPnjV5J470wvOyeBbfOGGpdMF8e3vRn/ohRigOKMwZvp1XRYyu+RzCyTWrKmtOGhHYebc4y7xGs3D+gmfS0gf+05HDv1+8QuNWK+TPqlOHqpkqsw00cP75g4oOThgbf92/8fPQdArjWt5HXScOWKo4Tqm7C8Wn62RknDG57y47ULMZx75DkKicMhasGDfry5zsEnmsTBsw8bjC0r5a6e8w7BCvHfzr4/pjhSOGCaWn9cbxR7bMjjxna253bvN/jZ5z7OCj2cqZhn+emhkwDDP/h/UCRaWjOX1w6vtzP8nU99EcGGQyp365V4xhcvudSuzZHDdJuvbwL8t4i8PzskVThiCFItaBf4Z23CFbe6R34+bBh0uRBpWueeotgZFNu/INDhpd1Lmgn7XyLQFcv50TmQcO+yo0cmRU/82dqdnutP2A4ErFvYsbsn3DYupuZt9+wT2+qPXssjrft8la7z3CvWc9W8wJw/plhpf7Ya3joVzfhYN+f5WevejS82x5Dz2vN15ZCuP7gXndb7Dbc+yzTzGmE6z/1aTy3y9Bsb149t8o/4dyoJK9SOw07Wsbd+2qLy78WHPplh2F3SG9nY2E+As+x3efd22a4nN5ghM0z/Bg2/VmefovBdV0j/87XfsIzXTzjV20yVE56MmlDJo6zLQbP2mC42vr0tKY7fqbX3Qr8I3KdoV2ZlUn303Bc5T17+BrD45x+O7bMxeWXC3jqvcrwtV7vpukTMfz11EzNCkOlBa3m7g3G8X793vqmGBp9zltnHILjU66M6rDUkNDo6iVvb9yezXO/1ltk2LQt//Tptjj+mZvYbK5hU/PxZVT1CHxEq0pxhm5Rr+rWqojjecdFLuMMS3aWtRHb4Xit8fbikYbKX+p8rJFtQgAJce9N4Uj7Snm86ioc79CKfzATNUmekiHz/xnXHT+55vJidGmbUfGhNobHlz2WnopyyiwUnX2JXztLX76TsQpt2XlhnG67EUEmkzVs9jqU6pi2urL2J1x3x3Pa8E1ob7LDtIXuOD7IFFx3GxqYMtI+m8Hpk54nRWegpMNjnzPn3yDgnJ4W9t+FRAsnSd8teoPHf87DJnvQ5eFfR28d/gZB5qCZQ2z2obRHf2xuVBfDg1vF3NuPLjUK8VC/y0MwsmrvTlsOInb8htVhR3Hc6fCZcYdRmF2bsDpz8hBwOc3LdDqCxINHHEkcjOGPIps5GNDc9MMt9tbJQ+C5sGG5wEyEcvKM0wpfI8hYNHV612Po2NL70d9P/oy7nb+krnMc1es+w7H6ktcI+pxaf1t0AjXyMJ16onqNQNZCceLxCTRn1rnAbm1eI9BNCGl96CTq7lbNtYf9awT5V+u1W3wKTTa9m557/xWC/Iq1LgWfRqs7jGxWbcern+vR6LxPnmfQhsHX0YupGF65MLPcWTQnyt7kOegVAt2HAfVfnkV1e2xJaNDoFQLPT2zrw+fQ1XeLy6xkfsKhUdU3c86jKor7tdJvv0SQxQzvO+wCSth5RlJ7+0sEmfqLgfUvoqaXl71rMv0lgpHdbrb6cBFF91hrPDQcw71aHjl2CbXtlpN2uuVPePaVA8zcy+hFv8CmPk4vESRUyLT3vYLSbpvn93uRi+BADZfQUlloElxMv2zIRZC1uNSByCxU6sTRe5nJuQgiZqwIuZGFvlaoubmuFsN7tJjZ+iqyS9m9FXxyEXSrGeiUdBX5eqhyvRvkItBdzDZ/uopGsgVLGJtcBGP8b/sNuYbqr8n2r/0kB8HGsvZuB6+hbXsfjN19NAfByE4yTcXr6HjtZYGbU3MQVMwLqzP2OhpkU+Gd7fgcBG47vvrcvI4cy9y6f37gz/TZTZ8am99AIft8GJC9QIphHReGspMVS/b0EoHbC8SPgG6vDPMU424kOkGfF2j/ulszNsTOV2wL720LES9Qz9oDQl59Uyq2Oz/+YV7wAn0vNaRn3cmT9PpT/raQ8QIx9x50G3Nstv7DseHVIesFKr3YO60qmqbw+CB5bTa9QP0bP6ks1k3W65bNKAWyHNRvvH3kaPNEhcvLwG/mpjmo1swjdZ7AXEVw6SmPzT456BrzVr2QVesTlgc6Q0QO0i4fcCnyW6C+1dnJX8wLctA0ceGKY0enKF4c536Yd+QgVcDF+hUmR+jhHHpjvpKDqs6ZaKfR6fQxleu8NJty0PbPaWH1MucpctcsF4MsF7Xo+bzvtdh4xYJGiyuAWy6a8t5t38sfs/XLo1rYQJ9cpG+lCjEY4hWn4ztyEJGLoieWfq8yzNGLxxe+Ni/IRYMudFithnj9Y7FeDhm5yKFHdtvH8Kd+dhXH5+YruUiSbvaKhFn6TvMXfjObclHbiAlZE6dMU5zx+1IdZC+RaM/jmIUe8YqDE73KgNtLFMMm9eiti1WE2xpfmH1eoiajzHfzJy/QX3VRPDKHv0SH2tZZunlqhN5pdpcC84KXyLQxYGEV3Uy9R5Okh+YdL1GbxUNnZ3vO1I/+6v3GfAXTb+oxu8tI0Xf5Ww7yXyKHYbPqbkaz9TYZXUqD7BUaeG9wcjezVvHlw2FbcHuFKoY1nL3l6FzF+GrLZNDnFXIbP+7h+R+zFN2aFFaDiFfo/pY7HWL4Bfp+LYZUhYRXyCXmeBxrmK/v4eHTADJeIT9kVoi/B+mvVt9+23zlFdoTkeCS4zFVP07c12g2vUJrHpXK9rAJVgxzUt03O79GBx1qtD1rM1Qx6PzmH+amr1E1RU1tdWa8/sGhJXfNPq9ReoMZY2Tm8frlqhW1IOI18vCZkdXFPFvhWX7mZ/OC1+jzieNLx/6YpPC5IL5m3vEanWz4zljX7K/vMpy/Zr7yGrm+am/cbw7VP7b3/2Q2vUbDpU2Wifgp+v4xe/8yO+ehSsH7EwOOzVE8HfTlrblpHnpz2m2e6UeAvtYzwwOzTx6K7pqnH4Pi9B8PDnhjDs9Dedn989dMjlPcXJD82rwgD71d9HmezbQoRYprbVfIyEPiUhUD5n8fo1/ulfjQfCUPaV6dqXp08nxFzMnvr8ymPPRjVvq2dkfnKxp+SikPsjcocujBjQv/jFZU++jsBG5v0L0zEUEJx+IVJ53HvzL7vEGOPwafalNqsP75zAdNIOIN6ux8rNctXax+89QHrpDwBg0f/j1xwSStfhobcse84w2arHQ9VS12rqJd19D6kPUG9d9p3rWCmaUoTOj83Gx6g+Iv9jt9DdSKxA9bLpmdjehaUGPOc1qs/uHZfvfNTY0owK7K+WMwUWEq3/Gd2ceI+m5JzNho1ihK/zE71xxuREOOmnZGfRikdzKvKA0JRsSclf4xTxen71xh3WPzDiPay3W6aQPjFKtiXSpDlhEtGj5w5Ce2j/6k/pAt5BtR6RetRnT2nK5n500oNDubkGShqV2zrz76M7OfVwc3E/ItHfVu65TZisSWUwvNPibU6cztGzyarQjpuembOdyEosclVS1gR+n5k5//Mi8woR45Ywuu/jlWMflp9jXzDhNqtmZSSiUmXL/i2diqkGVCO7de7mGcEqlodiL7o9lkQkNnRjBtJGq9eqSqwOycj+45VPXeNnm2fvCEGe/NTfNR9q5vJ4Jil+krOH37bvbJR8MSL7T8YVimmNrrkggi8tGFgc8yp8FURe6Fd5/NC/JR5eg2Rx+bw/Sqe44MZOSj13VebI9FC/Vtr69lICsffUzvNv7LnzrF9+/3vphN+Sgz5FaERDxWv/T7ISnI3qJR0rC4G7r5ihEFz7+Ym75FptbfA74Y0hR3U246QZ+3aHsfl4ixkKJI8XV1hoi3yPjo6ZPP3+cp6gyo+8284C2K0rR/4AYLFUMUHVwg4y2axYh042OTFftX1P9kvvIWBc5N39L8s0oPN2YXmE1v0ethG9IMsYsVa2fMcQTZOyQf9n1hiC5dIeo0XQRu71ALQ/rr4+bFirgPerPZ5x3SNGkyOYeJUdx1rV9oDn+HlI6xMYe/xSoU7ovLQsI71JBnFedZjb6Mv29ZyHiH2BrvWkzVLdK37/fjtfnKO/TugU/byeZZ+qXbDkgh/x06xbv16Wuert/xZMJXs/N7lFbvj1mRMEUf67f1h7npe1Ru/340wrxQPzBwvSP0eY+OTJ0jnxq7ROH68WtpiHiPLt50OnkIdIqDTYd8Ni94j/pu2NU4DSXqO157KIaM9+ivtjERIbHTFYPO7So0X3mPmrkYZO7sBEXFPRmvzKb3KKPfztFhsUmKgh3Ny4GsANWaXsmvzadARf05XSuAWwHq1PeB5gUzTeG/Z0mO2acADY3fdSDIHK/IjhbnmsML0IB3x1N3Zi7R5xwLN5kXFCBNA/d39p6pCvGGo8/NOwpQlz+dDPvNifpHdWUVIKsAdQh+EBmQmax/4pHvDPkFqGr/6dL42GWKqz0euICsELVeOzpSJR6pmFBXUh7cCpF985qXLxuW6ntG3M8z+xSi26skEg0br980wM9kDi9ELgHnSr0wpCpcZC8qQEIhSjDtmHJq8izFIo9zIsgoRJmOBgc7Pl2vr+RdDbIKUf2utb82mJKkj59wIMdsKkTioDe6/ZMT9b/eR1juGUaSe4bnBhtBCK6375Dk5OSXaMLa+uT7yy7dUod5vzOcQHXmNLQI2a38gICPLwBphbMH301tdMugG9imXq09XxQEqsPQTRhqN9hw5OpNA/cx+47duqpHCHQkhp7D0MFdKoyNuWkI67Pv5tpRNSnUE0NfYuinxjO3Vb5puBmYseJZ3As9lawk9Rb+hI4bu8Tv6A1Dtkf9xUFVxDQvkHoxdGTV43OUNwwX43p2a3qnDO1rdiGuF0M3zpjhJr5hcJdOffO+4wPa5kwMfYmh3YJ8e66/bhiZ2HfG6Z0czbsSQ+M/gLSCLinlYdfrhkW6Uzd6DalNofjWgd+Eodxfh57kXjPcabg/ufrEOhQ6ktSLobMelRkaf82AMq7sK3u+XDHoy99BPUm9H3F/r3zl618zxNzrX6/W0PK0vxypF0OTgo4lnb1qEA/IGaPfUUPABqkXQzdu2TI88Kohf+PUFqdr1BCwUYDrxdBu2z/PkVw1jB4q+X5yYx2aNxND4z+BtEJC1JNaa7IMpUQFk40hjhS6EkM3YWjWnsTanlmG2MYFKw60ztcXQc/9Dqoj9WKo5x9hFQ9eMcxUJG9pMMhJwAap9zMewQcXtuVfNtTaMWP5/joNBWyQejE0v4Hatu5lg8yMBvg0rSBgg9SLoZk+Ia7DLxmqjDl/eOEhV4HSSb0YujLlzMcFFw0t49LH+IyvWwwa/+U30Oz3uF4MTWisnXH8gmHB/jnNMnpXotBMDD2HoZm63ufenzeMTriE/HsfonS1EkNfYmjGkxr6mucNr455PQiYW/tIETT+62+gOlIvhvYpWD603znD0xvHxHevNhDmEakXQ7M41crYswb7L/djDUcsuCL1Ymi2jI3fcsYwuHt/TcL94tD4b7+BcqReDM2qlON867Rh9JNda4KfyQS6IvViaMKGCDfzKUO7PrL0TiuqF4O+/B00+x2u9/9r70rDoyqy9ltJSEhuCAlLIIAYRBZZpPdFYW5aNoEkMiTDDp3Q6YSWbGQhARknigKRLYgiKGAQXMK44OeKAt0QtoAiu4wiBgdGgqDAgwOOYr577q1OdzrdgRmeZ74/3+2GvrlvVZ1z6lSdeqtu1+2bZO/6v5/rudu5bFJYxaLT8bzVEVpFaNmB7L5Ju5wDS/XpOyI7DPKgNYHQSkLrCK3oGv/bzGrnA6m9kuaXXuERSZb7O7Wcu2+MeX6ns+WumR1US+7lNSnLJTRtwPE+H+1wrtwQ03Fj2f1eaE0gNEGWS2jFobmPf+lyXpt0fuFKR8QgD1peHwCNl+USWvu1evlFp/OqdsPk1GLufRC6vx5CbN/csF7bnQNxuU8/XZ9BHvBCALD2CkktY0IH16RlqVO3OkO3W8ePi7yL1zKhVYTWjnwg59lPnPs2TTqvN/NYJqM1gdBKQusIrVSfGFr9sXP62AFJ981t64WWPxEALZPlEpp27pkjlz90flWorTG+wCNOmiyX0PhQMazzB85xU/ekTwri0UpG6wKhCbLcJ0nnziu/tLzn/LbtL599NbWfF1oVCI2X5RJatuFHg/1dZ/iGZbOmzm3Hq1mWK6MxLlXEO87lSw3z1k3o74WWzwuA1tI33KtkNG7mNw/91ZmYf+LcnCe7eKE1gVBaZ7PUEerS/HN80evOH9df1Q37rd82D1r+VAC0UpYro79vWbBug3PT7z1//ijo54EetCYQWkbohaeYEFsa9dKTLzvPhj8+t2fZfds84DNP+wfTZKlPkz3HwzpvecFpfu1fK1KX9Oa9hND9lPW3zW+4ljnXvHb0n3O7frvVA14IAMbLQuczITZ6Rp/avzjPJnzVSvwubpsH3BQAlHcYnJ7PhCA6uTmfCcGun6iwBUyILS9uH10mnu+7dvWMvTyulRFYtYAsWDF+bHyFeOT6d6GTTrl5CaH7KWtN7x4jVom6yImaTyp5KAaBdZQ14fvyKZZKMeXLK5NdMYw780eSupAJsfcfeztzo9j75rbiwljurTICqxaSP15ut+m5N8Q/95x46PnZ3IYEQmtk9JvPCw+8KYb1Pjn86vRO3HxC62Q01KW+8Lb42IM1j/whJorH2kvUSsqpvw07/OAL74ovrWs1dorGPfIQWkVo7eHXf972nvhl8tevTt3He0UaoTWEVr6QNLHuA7HrXVMGhjq4zgmE1hHquhBxFB+Jmktrq5Z0vai0Ichyn6HKmDBlqnaL+NXwbQ9MjunOK+MiySU07a0l+x79VDw3/Xrfsoq2XCtCa+S8W9n4hVvFo29O3HN4mJtJEVpHaHzEPPPe7WLt0H+8M93Vn2tFaPkisuhr8/LzTvFmxPpHTujc0VSWK6O9nlzaYYd4Naz/wdKfODuo/YHkEnq5++N9N+0QdatNQ5a+zmujktA6QsvmR6Yf3imuf/+JA9lrg3lcI7R8MRM6VLTf/Ju9WiwvGNX9jQF7lNpIILSK0M3aeYOW7xJLP7yZOnsej6fxslwZXX/2XK/d4t4/O86d13J7ay+QXEKjF29PHrdHLL1/YL9FX7h5B6HlSySd84sXtbm8RzzTbc25JTFu/xJaRejoIU8vKd8rthi8PD86083BCd2/hAmx5h/e2b5PPNyvblPqoDBekQReIPD6qYkTa8S8+srxva+G8ZgnS11K9fjMwEsr9ouObmNHDy7g/by2jqQSemjSuJPqA+KmM28mL9Fz3ugitEbO+6BpwaED4odtUifsGsX9V0loHaHRl/f8mveZeKTvyt0FF68ocSCN0PJlVMvHNg9693NRv7n99T71vAMmyHIJjf6+PirloKi6Zknr1Wan4oN4QvcvY0LsN2ff+vmgGLP0U3v7bvuVgiGLpayb38vusvoLUfVt5P6LBzrzSj5PYiuY0GF8Uppp5iFxefKl2K/X3ODBlNAqQtPSs/rvOiTWXRgYu6gjp41lhNYQep6a3GGxy+VXbVHdeCdKI7SO0BtvHpg847D4ROyr1z9/0U3QZLnLpbzTJ9pWOw+LH20b/sdLr7kHLVkuoR9H5Qxtd0S88MmwT04v4LSi9nuSS2jFqbmXtx8Rr4WMHvmvNZwcuAitIzTt6Jkr7Y6KHw/sdnTOd9yBlYSWP0sVuX1W1oyj4r6SK5s/z43hFhFaRahKWzJm51Fx8rbQD1Mf7Mi7pyyX0PPHu78fd0xcW1tx0XC2JbdIlkvovpk7l8w8JhafyAo/2GsAD2Wy3BVUcod1tTXHxI0nIzqXx3OSBVkuoZWmsLfvOS5O2JvxRP52PomtpX1zNYQe2pdy/bHj4k8JU3689BYnBy5C61YwoapF2oRvtx0/Lp6yb2zZR4iQi243CogAIACIBNAKQBSA1rTBDEAMgDYA2lJaAO0BxALowPcO0ZE4CugIII42gdXX19M/utYJQGcAQ0YC40cqad8YBXSh7yJ6yesK4G4fefFcXjcu7x7ao5RSpLVaNWZlO7ojr3CELTnFqlbbpqcXWGmrbVHhCNtQ2o2k7EN6YySwOLEhn1rfsI/dnp4zrTizmezyfqbakZ68Wi5UyRw45/ulQJdRiq30jYdjI4Hga/X1TXVw5GYF1CE5xWpu2O/eyKaMUYrP+FCDyYlAdwD30j65+vp6+kfXegDoSd4fBdwYBUQmAse88nn7zJ3P22dufc0eux25Wc1ZH1jndomKPDrIH72kdtDbI8PkfprFUF7vpYmwVK5mwtGQw0XrMG7ttj5l+WNa19f/oRe11AwA54OB6F5A5XyGhIdao2zlKuDMzy3IIr3ES2cCmFFfX3/w1/r6Z5319e4NlfX/7gEWFBzSIjSsZTi/ECFEtopqHR3Tpm279rEdOsZ16tzlrq53x3e7p/vt4f/HB1hQSFhwaAteH0EA7ZZzhQCuFoArFHCFAa6WgCsccEUALgFwRQKuVoArCnC1BlzRgCsGcLUBXG0BVzvA1R5wxQKuDoCrI+CKA1ydAFdnwNUFcN0FuLoCrrsB2uj6HgOqg4DqYKA6BKhuAVSHAtVhQHVLoDocqI4AqgWgOhKobgUcjQKqWwPVQOSnDJHVQYisDkZkdQgivyZ7TrcJed7Xz4eSlUji3uhtqVzHhKCzybC41jFheOJg6+DUCaPlTp842Jr8p6ShY0YMls9TRyQNBb8++JHEREvqUPk86ZHkoamWMRPk86EpKZbhQ1NgqXiZCZY4RCAujjoVeB3T5ko5uspHHGIi4uLigiPCwBAudATCQwXCQykP5bSceZkJ3aI8GSJa0eVW5KzwKLnAKArRlpcqmcAiYXm9kgntKTzLMRrhkXK+SHpbjlOaaFjOUBoK6SGt5TTRygZieluWrWcCawPLS+uZ0JXCrxyDEd5GTtNGflNU6NSpEyxH1jMhyv0Xt88y7xUmsHawLHuFCe1pYJBHB4S3kxO0o7dlG6WJhaXmFSbcR4OIPJIgPFZOEyu/PbvyLQ8NHjJ0WNkYWMpeZUI9C4Lvi56SzV+49Yulhbiae7U82fTlk+K412v37b0a5T/h9dpzey93XvpRjiomBFWMheW5t5jwSzBT+i7cO11b8J2u3jt6/9NR3T0quEcC92jtHqXj+ahMI7J75HGPNu7Ifh+APgD6AvSDcvQbp7gfwACK8ADUADRSENDSdnQes2mLgpH2JNCWcoB+oZwe2y+PWMRkaKsDLb7T1gULgIeoTxO7AEDddBiA4QAeBjACABEOGnQSASTRaEM7zWl3OYA/AhgDIEUaoVMB/AnAWADjaMSivfwAJgKYRCMsgClSbJkKwEos778o/zEAcwH8GcDjUlz7CywVHzAhqHIyLBu3/H9LANIBTANg48zADiBTIsxZEkuYLk1uHNKM7VFiA9IMOFuam+cAyAWQByCfM4UCAIUAigAUA5gFoETisqUAZgOY00xL+G/J99MSKncwYQfzBM30abYMe6YSOkvH9+2fP9oxIjdZ9gjQI1/+3/NoMPlpKdxhOdwhPbgR7vPZ/HMCd5w7bX+vtD14c3+Anyd5nafwRtKDGwt+/nCj9JbLO5nwt+CmQOOC5LsU9sYxgI7UTE9ftNxGf6Rjq93TLy236Jsya8309FFLgDhBx+ZMTyuxBGgpRdzjxby1gLeYdN5CCr2u38o5/iu0ab314OW7nTHN6zzD6/zh23DkBK8yb8/xlmN7mLAyfK7N000sHvpvoClDtl2fmW6zFzVMc2yAaxZ/ygvPZ+f5/t3uxeXobUWz8+0jSuhRFnxyo5Ivuece8iMsbMoU7jNbA0EG6U2f1/gnHRUZik4FXKfmui+XZrTlZdhts4pG2GxqtdWaM01+XJS1yEsfDU/SMBuSdcrNUHRKzGiq08IMj04hdkWnOVynpiEDKJOmpU/40WlIYROlZJm1t5BZymU+yWXOk/R4ShqGnpaGofnSMLSA0kvDULk/mQ7/MlPtgWX6llHStAi5jFW3LsPd7qxWR06+u92dsivpPXKy6SlvNJ2VcWp8/vASjsc3xnmbszXolZAZuF25p8O5xTn59Kwlnk0ut6hxuZ40JZ40q3gamXRnAs9Iw/4i7pfF0tC/RBr6l3K/6TKBZdSOOb5cogHPSjRgBccPZSl+fY7jNKtaKdGCFyRasEqiBavpoUgSLXhJogVrJFqwVqIF6yRa8LKXj3KLc6xZ9iJltcDsaFh2sTqK7AXKIoH/VRRPjzBbrQ2lePUTXcNl7767Mkup47Isz/LLZn5O1wdmNa37j7NgufYFE/azjdMViyu5xeslYvOKRGw2SMRmoxTKXpWIzWsSsXmdFrEkYlMlEZtNErH5qx+LSwJaXNLE4pKAFpc0tJqi6f4tUk1vatHi6bDsO8yE02yxQ7HoTW7RWxL1elsaQN6hUiTq9a5Evf6HZuJUmo8V+cVuv+Xdgd/kUpr6Lb+4kd/GOLh/HB4rsx0eK2/4sbLIAcvmo0zYzlIfVaz8gFv5oUQePyLPSuRxizQkfSKRx09pyJfI4zY/VpYEtPJ2fSWX0uCrex/1b0Wto6kVAx+F5cYxJrwopM4Atku01smtoBWSHdIkYyfk1Q7skkjNbonU7OFLrJR+L23ElgbhGonc7JfIzQFpsvGZNBB/7hVL6OmSd9wJ5UIUh5G/Ws1oKF+jslrdIqy0qplXkJ7ljneUtvcMxfp9vFaCvayPn6F8Js7wrCUnZAMHJTL2Ba+HQxIhOywRsiMSqThKy6nSZOm4RMRO8Hqg9F9K8e+kREz+JpGxryQyRitBpyQS9o2/eriDrhnAWNn1ZGv7bMXWQzMC22rK9th6Nhs4LRHEb7mttb763mEnVLv1zS8ucvtjN9exLLtpazzlpVtGDnBGIorfcd3+7k+3/6Tr8N7QJad5+TdylF59lss/Jw29/6D7ILT4S/es6EacxPt+oBubdMvVa8lalZOXa5/Nh9DEaapGVSJjjfnVyRxFp61+dLqc4+E62bmKTj9ynX4inL4EQd9GoS/+0FhOXzujL+JJHPB6YJ3UpBPJHJ3bvMxaLvMGl/kLPRVQ4na/Ei+WuN1Nidv9TguePOQw5l9mCa8HkrnrFjJT8xSZQUyRSWsMIQxowYBQBoQxoCUDwhkQwQAhsMwGO015zcu8wWVGcpmtGBDlKdesuO0OA5lMFT0FufvtiTzF/xX+dMyDZU0tE15ka/IVDVtzDaMZEONXwzsIMY01bIgsc/IVDXX5TTV8Lh8W1xnSMGGmomEbrmFbBrRrouGdBpUGDd2Du6xh15mKhif9aGiaCcvZ70jDs1zD9lzDWAZ08KvhHYzKjTVsqMOdXMO5M/1EnpmwLDzLhC0tJxcoGnbkGsYxoBMDOnu0NOXYCwvTs+yFjaiN1n21cWwxF3BWUNBUamqBp/2/z+V24XLvYkBXBtztT26JJ46uaabcFD4fzeVz7nSvRYMkPkf2h6V6LU4U+sHHcSyD5w+ULpXP0Yu9lrh80wzjmMMPlsL/LvIqw18at42+dvna4qu7r46++vjqAL6IlM7LL+bnBT722PkCS0GANEle12xcPnh8z/eSn+2TfraXDsVede99LdsrnYVfy+KfhV52pPC8+fyana+dTOPnvFnJi2I2nibPD57Mr89qpowh/G9bM2m869W3Hn3rzLeufOvEtz5868LXfl87fe3ytcFdXhI/H62sYn52kQlzEm/By8E5YHOcVf7SxiwgngHdGHCP1/iqs1oLp6cX2DOstrzi3KKGOLNxFuinjoV9TKVSqVUalValU+lVBpVRZVKZ1Sq1Wq1Ra9U6tV5tUBvVJrVZo9KoNRqNVqPT6DUGjVFj0pi1Kq1aq9FqtTqtXmvQGrUmrVmn0ql1Gp1Wp9PpdQadUWfSmfUqvVqv0Wv1Or1eb9Ab9Sa92aAyqA0ag9agM+gNBoPRYDKYjSqj2qgxao06o95oMBqNJqPZpDKpTRqT1qQz6U0Gk9FkMpnNKrParDFrzTqz3mwwG80msxmWjT8x4WrIrW75Y/+LDyYT1bWVlqZPc8xSqw1UR44cq7y258jNzGtYIdlXAkTPARqnN1qttmx6kn2jDJT+RglwsUTxSJdSoDsD7mVADwb0ZEAvBvRmwH0M6KM83wKVPF1fn3T9GNCfAfczH/k0rSh0+FNB1qG0VJEtr4Tysgf4lK1igJoBmiZlq63WWTmOQPYd8yp7/Gzl5pGWATpuSwK/pmeAgQEpRWbP74XwlqeaLV/3PD+el/3wbCU/HQtnKzenjAwwyeWo1dl5WQ4b/20U2U6v9C6e3uxJb3DkzkrPdmRY0wuyiuWf5nF/yWe2Ur58e4Dne8CTT6M8wJ0L4nlqeZ6UInNDnbjtwRxYVl1jQvDoZ6P/F5VVWrqn6AYA";async function wt(m){let Z=Uint8Array.from(atob(m),U=>U.charCodeAt(0)),e=new Blob([Z]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(e).arrayBuffer())}var q=20,An=200,L,V,J,Q,P,yt;function It(){let m=L._live_values()/8;return L.HEAPF64.slice(m,m+V.length)}function Nt(m){L._live_start(m);let Z=L.ccall("live_layout","string").trim().split(\`
\`).map(e=>e.split(" "));V={names:{},length:0};for(let[e,U,R]of Z)V.names[e]=[+U,+R],V.length=+U+ +R;J=P=0,yt=performance.now(),Q=!1,postMessage({fields:V.names,seed:m}),postMessage({frames:[It()],ticks:J})}function _n(){let m=performance.now();if(P=Math.min(P+m-yt,An),yt=m,Q)return;let Z=[];for(;P>=q;P-=q)L._live_step(q),J+=q,Z.push(It());Z.length>0&&postMessage({frames:Z,ticks:J,busy:(performance.now()-m)/(Z.length*q)})}onmessage=({data:m})=>{if(m.start!==void 0&&Nt(m.start),m.paused!==void 0&&(Q=m.paused,P=0,Q&&postMessage({paused:Q})),m.command){let Z=L.ccall("live_command","number",["string"],[m.command])!==0;postMessage({command:m.command,accepted:Z,at:J})}};wt(Ct).then(m=>Kt({wasmBinary:m})).then(m=>{L=m,Nt(1),setInterval(_n,q/2)});})();
`;var so={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Ji=.2;function ro(i,t){let e=i===Ji?0:.02;return`attach ${i} ${e} ${e/2} ${(.1+.07*t).toFixed(2)}`}function Xl(i){let{act:t,view:e}=i,n=[...document.querySelectorAll("#controls button")],s=l=>t(ro(l,i.held().length)),r=0,a={attach:l=>s(+l.dataset.attach),cup:()=>s(Ji),hang:()=>t(`hang 1 ${.25}`),command:l=>t(l.dataset.command),pose:()=>t(`pose ${r=(r+1)%4}`),restart:()=>{r=0;for(let l of n)l.dataset.toggle&&l.setAttribute("aria-pressed",!1);i.restart()},toggle:l=>{let h=l.getAttribute("aria-pressed")!=="true";l.setAttribute("aria-pressed",h),t(`${l.dataset.toggle} ${h?1:0}`)}},o={pour:l=>{l&&!i.held().some(({kind:h})=>h==="cup")&&s(Ji),t(`pour ${l?.3:0}`)},push:l=>t(`push 0 ${l?15:0} 0`)};for(let l of n){if(fu(l),l.dataset.hold){pu(l,o[l.dataset.hold]);continue}let h=Object.keys(a).find(f=>f in l.dataset);l.addEventListener("click",()=>{a[h](l),l.dataset.say&&l.getAttribute("aria-pressed")!=="false"&&i.say(l.dataset.say)}),l.closest(".weights")&&mu(l,i.say)}if(gu(n),!e)return;let c=l=>t(`push ${l.toArray().map(h=>h.toFixed(3)).join(" ")}`);xu((l,h)=>c(e.inArms(l,h).setLength(l||h?15:0))),vu(e,(l,h)=>{c(e.inArms(l,h).multiplyScalar(100).clampLength(0,i.get("constrained")[0]?15:40))})}function fu(i){let t=i.dataset.key,e=i.lastChild,n=e.data.toLowerCase().indexOf(t),s=document.createElement("u"),r=document.createElement("span");i.setAttribute("aria-keyshortcuts",t),s.textContent=n<0?t.toUpperCase():e.data[n],r.append(...n<0?[e.data," ",s]:[e.data.slice(0,n),s,e.data.slice(n+1)]),e.replaceWith(r)}function pu(i,t){let e=n=>{i.classList.contains("held")!==n&&(i.classList.toggle("held",n),t(n))};for(let n of["pointerdown","hold"])i.addEventListener(n,()=>e(!0));for(let n of["pointerup","pointerleave","pointercancel","blur","keyup","release"])i.addEventListener(n,()=>e(!1));i.addEventListener("keydown",({key:n})=>{(n===" "||n==="Enter")&&e(!0)})}function mu(i,t){i.addEventListener("pointerdown",e=>{let n=document.createElement("div");n.className="dragged",n.append(i.querySelector("i").cloneNode());let s=({clientX:o,clientY:c})=>{!n.isConnected&&Math.hypot(o-e.clientX,c-e.clientY)<6||(document.body.append(n),n.style.left=`${o}px`,n.style.top=`${c}px`)},r=({type:o,clientX:c,clientY:l})=>{for(let[h,f]of a)removeEventListener(h,f);n.isConnected&&(n.remove(),o!=="pointercancel"&&(document.elementFromPoint(c,l)?.closest("#stage")?i.click():t("Let it go over one of the hands.")))},a=[["pointermove",s],["pointerup",r],["pointercancel",r]];for(let[o,c]of a)addEventListener(o,c)})}function gu(i){let t=new Map(i.map(e=>[e.dataset.key,e]));addEventListener("keydown",({altKey:e,ctrlKey:n,key:s,metaKey:r,repeat:a,target:o})=>{if(a||e||n||r||o.closest("input, select, pre"))return;let c=t.get(s.toLowerCase());c?.dataset.hold?c.dispatchEvent(new Event("hold")):c?.click()}),addEventListener("keyup",({key:e})=>t.get(e.toLowerCase())?.dispatchEvent(new Event("release")))}function xu(i){let t=document.getElementById("scene"),e=new Set,n=()=>i(...[...e].reduce(([s,r],a)=>[s+so[a][0],r+so[a][1]],[0,0]));t.addEventListener("keydown",s=>{s.key in so&&(s.preventDefault(),!s.repeat&&(e.add(s.key),n()))}),t.addEventListener("keyup",({key:s})=>e.delete(s)&&n()),t.addEventListener("blur",()=>{e.size!==0&&(e.clear(),n())})}function vu(i,t){let e=document.getElementById("scene");e.addEventListener("pointerdown",n=>{let{left:s,top:r}=e.getBoundingClientRect(),a=["without","with"].some(l=>{let{x:h,y:f}=i.handAt(l);return Math.hypot(n.clientX-s-h,n.clientY-r-f)<90}),o=n,c=l=>{a?t(l.clientX-n.clientX,l.clientY-n.clientY):i.turn(l.clientX-o.clientX,l.clientY-o.clientY),o=l};e.setPointerCapture(n.pointerId),e.addEventListener("pointermove",c),e.addEventListener("lostpointercapture",()=>{e.removeEventListener("pointermove",c),a&&t(0,0)},{once:!0})})}var Hs=class{constructor(){this.clear()}clear(){this.rows=[]}add(t){this.rows.push({t:t("ticks")[0]/1e3,mean:t("with.mean")[0],deviation:t("with.deviation")[0],truth:t("with.payload")[0]}),this.rows.length>12/.02&&this.rows.shift()}},yu=(()=>{let i=document.createElement("canvas");i.width=i.height=6;let t=i.getContext("2d");t.strokeStyle="#1565c0";for(let e of[-6,0,6])t.moveTo(e,6),t.lineTo(e+6,0);return t.stroke(),t.createPattern(i,"repeat")})();function ao(i,t,e,n){let s=devicePixelRatio,r=i.clientWidth,a=i.clientHeight;i.width!==Math.round(r*s)&&(i.width=Math.round(r*s),i.height=Math.round(a*s));let o=i.getContext("2d");o.setTransform(s,0,0,s,0,0),o.clearRect(0,0,r,a);let c=t.reduce((u,M)=>Math.max(u,M.mean+M.deviation,M.truth??0),.5),l=c>10?5:c>4?2:c>2?1:.5,h=l*Math.ceil(1.05*c/l),f=u=>30+(r-34)*(u-e)/(n-e),d=u=>a-16-(a-22)*Math.max(u,0)/h;o.font="11px system-ui, sans-serif",o.fillStyle="#5b6472",o.strokeStyle="#dde2e8";for(let u=0;u<=h+1e-9;u+=l)o.strokeRect(30,d(u),r-34,0),o.fillText(u.toFixed(l<1?1:0),4,d(u)+4);let m=Math.max(1,Math.round((n-e)/6));for(let u=m*Math.ceil(e/m);u<=n;u+=m)o.fillText(`${u} s`,Math.min(f(u)-8,r-26),a-3);let g=(u,M)=>{o.setLineDash(M),o.beginPath();for(let[A,T]of u)o.lineTo(f(A),d(T))},S=t.map(u=>[u.t,u.mean+2*u.deviation]),p=t.map(u=>[u.t,u.mean-2*u.deviation]);o.save(),o.beginPath(),o.rect(30,0,r-34,a-16),o.clip(),g([...S,...p.reverse()],[]),o.fillStyle=yu,o.fill(),o.strokeStyle="#1f2937",g(t.filter(u=>u.truth!==void 0).map(u=>[u.t,u.truth]),[5,4]),o.stroke(),o.lineWidth=2,o.strokeStyle="#1565c0",g(t.map(u=>[u.t,u.mean]),[]),o.stroke(),o.restore(),o.setLineDash([])}function ql(i,{rows:t}){let e=Math.max(12,t[t.length-1].t);ao(i,t,e-12,e)}var oe=i=>document.getElementById(i),kn=[],Zl,Su=0;function Mu(){return Zl??=new Promise((i,t)=>{let e=document.createElement("script");e.src="logs.js",e.onload=()=>i(new Worker(URL.createObjectURL(new Blob([globalThis.rmeLogWorker],{type:"text/javascript"})))),e.onerror=()=>t(new Error("logs.js is missing beside the page")),document.head.append(e)}),Zl}async function Jl(i,t){let e=await Mu(),n=++Su;return new Promise(s=>{let r=({data:a})=>{a.id===n&&(e.removeEventListener("message",r),s(a))};e.addEventListener("message",r),e.postMessage({id:n,files:kn,program:i,options:t})})}async function bu(i){let t=i.name.endsWith(".gz"),e=t?i.stream().pipeThrough(new DecompressionStream("gzip")):i.stream();return{name:t?i.name.slice(0,-3):i.name,bytes:new Uint8Array(await new Response(e).arrayBuffer())}}var si=({name:i})=>/\.(urdf|xml)$/i.test(i),Ws=()=>kn.filter(i=>!si(i)).map(({name:i})=>i);function Tu(i){let t=new DOMParser().parseFromString(new TextDecoder().decode(i.bytes),"text/xml"),e=[...t.querySelectorAll("robot > link")].map(h=>h.getAttribute("name")),n=h=>new Set([...t.querySelectorAll(`robot > joint > ${h}`)].map(f=>f.getAttribute("link"))),s=n("parent"),r=n("child"),a=[...t.querySelectorAll("robot > joint")].find(h=>/revolute|continuous/.test(h.getAttribute("type"))),o=e.filter(h=>!s.has(h)),c=a?.querySelector("parent")?.getAttribute("link")??e.find(h=>!r.has(h)),l=o.find(h=>/^(tool0|.*flange|.*link8|.*ee|.*tip)$/i.test(h))??o.at(-1);for(let[h,f]of[["base",c],["tip",l]])oe(h).replaceChildren(...e.map(d=>new Option(d,d,!1,d===f)))}async function Yl(i){for(let e of i){let n=await bu(e);kn=kn.filter(s=>s.name!==n.name&&!(si(s)&&si(n))),kn.push(n)}let t=kn.find(si);oe("chosen").textContent=kn.map(({name:e})=>e).join(", "),oe("arm").hidden=!t,t&&[...i].some(si)&&Tu(t),oe("replay").disabled=oe("check").disabled=Ws().length===0,Ws().length>0&&[...i].some(e=>!si(e))&&await Ql()}function Kl(){let i=kn.find(si),t=oe("options").value.trim();return[...i?["--urdf",i.name,"--base",oe("base").value,"--tip",oe("tip").value]:[],...t?t.split(/\s+/):[]]}function oo(i,t){oe("verdict").textContent=i,oe("output").hidden=!1,oe("output").textContent=t.join(`
`)}async function jl(i,t){oe("verdict").textContent=i;for(let e of["replay","check"])oe(e).disabled=!0;await t();for(let e of["replay","check"])oe(e).disabled=!1}var Ql=()=>jl("replaying ...",async()=>{let i=Ws().at(-1),{code:t,output:e}=await Jl("replay_log",[i,"--json",...Kl()]);if(t!==0){oe("replayed").hidden=!0,oo(`${i} could not be replayed`,e);return}let n=e.filter(o=>o.startsWith("{")).map(o=>JSON.parse(o)),s=n.filter(({type:o})=>o==="estimate"),r=n.filter(({type:o,final:c})=>c||o==="rejected"),a=n.find(({type:o})=>o==="summary");oe("replayed").hidden=!1,oe("replayed").rows=s.map(({t:o,mass:c,std:l,truth:h})=>({t:o,mean:c,deviation:l[0],truth:h?.[0]})),$l(),oo(`${i}: ${a.samples} samples, ${a.estimates} changes of the payload, ${a.rejected} pushes`,[...n.filter(({type:o})=>o==="note").map(({text:o})=>o),...r.map(({t:o,kind:c,mass:l,std:h})=>`${o.toFixed(3)} s  ${c}`+(l===void 0?"":`  ${l.toFixed(3)} +- ${h[0].toFixed(3)} kg`))])});function $l(){let{rows:i}=oe("replayed");i?.length>1&&ao(oe("replayed"),i,i[0].t,i.at(-1).t)}var Eu=()=>jl("checking ...",async()=>{let{code:i,output:t}=await Jl("check_arm",[...Ws(),...Kl()]);oo(["The arm fits: sign, units and frames of its torque can be right.","Sign, units or frames of the torque do not fit the arm.","check_arm does not take these options.","check_arm cannot use these files."][i],t)});function tc(){oe("files").addEventListener("change",({target:t})=>Yl(t.files)),oe("replay").addEventListener("click",Ql),oe("check").addEventListener("click",Eu),addEventListener("resize",$l);let i=t=>e=>{e.dataTransfer?.types.includes("Files")&&(e.preventDefault(),oe("own").classList.toggle("over",t),e.type==="drop"&&Yl(e.dataTransfer.files))};for(let[t,e]of[["dragover",!0],["dragleave",!1],["drop",!1]])addEventListener(t,i(e))}var Cc=0,zo=1,_c=2;var As=1,Pc=2,Gi=3,Qn=0,Ne=1,xn=2,ui=0,Vi=1,ko=2,Go=3,Vo=4,Ic=5;var di=100,Lc=101,Dc=102,Nc=103,Fc=104,Uc=200,Oc=201,Bc=202,zc=203,Ho=204,Wo=205,kc=206,Gc=207,Vc=208,Hc=209,Wc=210,Xc=211,qc=212,Zc=213,Yc=214,yr=0,Sr=1,Mr=2,Ii=3,br=4,Tr=5,Er=6,wr=7,Qr=0,Jc=1,Kc=2,vn=0,Xo=1,qo=2,Zo=3,Yo=4,Jo=5,Ko=6,jo=7;var Qo=300,fi=301,Hi=302,$r=303,ta=304,Ar=1e3,fn=1001,Rr=1002,Me=1003,jc=1004;var Rs=1005;var De=1006,ea=1007;var Nn=1008;var Be=1009,$o=1010,tl=1011,Wi=1012,na=1013,an=1014,on=1015,ln=1016,ia=1017,sa=1018,pi=1020,el=35902,nl=35899,il=1021,sl=1022,cn=1023,_n=1026,Fn=1027,rl=1028,ra=1029,$n=1030,aa=1031;var oa=1033,Cs=33776,_s=33777,Ps=33778,Is=33779,la=35840,ca=35841,ha=35842,ua=35843,da=36196,fa=37492,pa=37496,ma=37488,ga=37489,Ls=37490,xa=37491,va=37808,ya=37809,Sa=37810,Ma=37811,ba=37812,Ta=37813,Ea=37814,wa=37815,Aa=37816,Ra=37817,Ca=37818,_a=37819,Pa=37820,Ia=37821,La=36492,Da=36494,Na=36495,Fa=36283,Ua=36284,Ds=36285,Oa=36286;var ns=2300,Cr=2301,gr=2302,Lo=2303,Do=2400,No=2401,Fo=2402;var Qc=3200;var Ba=0,$c=1,Un="",Ge="srgb",is="srgb-linear",ss="linear",Zt="srgb";var xr=7680;var th=519,eh=512,nh=513,ih=514,al=515,sh=516,rh=517,ol=518,ll=519,ah=35044;var cl="300 es",je=2e3,Li=2001;function wu(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Au(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function rs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function oh(){let i=rs("canvas");return i.style.display="block",i}var ec={},Di=null;function hl(...i){let t="THREE."+i.shift();Di?Di("log",t,...i):console.log(t,...i)}function lh(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Rt(...i){i=lh(i);let t="THREE."+i.shift();if(Di)Di("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function _t(...i){i=lh(i);let t="THREE."+i.shift();if(Di)Di("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function es(...i){let t=i.join(" ");t in ec||(ec[t]=!0,Rt(...i))}function ch(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var hh={[yr]:yr,[Mr]:Er,[br]:br,[Ii]:Tr,[Sr]:Sr,[Er]:Mr,[wr]:wr,[Tr]:Ii},mn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},Re=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var vr=Math.PI/180,_r=180/Math.PI;function Ns(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Re[i&255]+Re[i>>8&255]+Re[i>>16&255]+Re[i>>24&255]+"-"+Re[t&255]+Re[t>>8&255]+"-"+Re[t>>16&15|64]+Re[t>>24&255]+"-"+Re[e&63|128]+Re[e>>8&255]+"-"+Re[e>>16&255]+Re[e>>24&255]+Re[n&255]+Re[n>>8&255]+Re[n>>16&255]+Re[n>>24&255]).toLowerCase()}function Wt(i,t,e){return Math.max(t,Math.min(e,i))}function Ru(i,t){return(i%t+t)%t}function lo(i,t,e){return(1-e)*i+e*t}function uh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ul(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Cu(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function _u(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Ht=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qe=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let c=n[s+0],l=n[s+1],h=n[s+2],f=n[s+3],d=r[a+0],m=r[a+1],g=r[a+2],S=r[a+3];if(f!==S||c!==d||l!==m||h!==g){let p=c*d+l*m+h*g+f*S;p<0&&(d=-d,m=-m,g=-g,S=-S,p=-p);let u=1-o;if(p<.9995){let M=Math.acos(p),A=Math.sin(M);u=Math.sin(u*M)/A,o=Math.sin(o*M)/A,c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+S*o}else{c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+S*o;let M=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=M,l*=M,h*=M,f*=M}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,s,r,a){let o=n[s],c=n[s+1],l=n[s+2],h=n[s+3],f=r[a],d=r[a+1],m=r[a+2],g=r[a+3];return t[e]=o*g+h*f+c*m-l*d,t[e+1]=c*g+h*d+l*f-o*m,t[e+2]=l*g+h*m+o*d-c*f,t[e+3]=h*g-o*f-c*d-l*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,c=Math.sin,l=o(n/2),h=o(s/2),f=o(r/2),d=c(n/2),m=c(s/2),g=c(r/2);switch(a){case"XYZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"YXZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"ZXY":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"ZYX":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"YZX":this._x=d*h*f+l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f-d*m*g;break;case"XZY":this._x=d*h*f-l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f+d*m*g;break;default:Rt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],c=e[9],l=e[2],h=e[6],f=e[10],d=n+o+f;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-c)*m,this._y=(r-l)*m,this._z=(a-s)*m}else if(n>o&&n>f){let m=2*Math.sqrt(1+n-o-f);this._w=(h-c)/m,this._x=.25*m,this._y=(s+a)/m,this._z=(r+l)/m}else if(o>f){let m=2*Math.sqrt(1+o-n-f);this._w=(r-l)/m,this._x=(s+a)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+f-n-o);this._w=(a-s)/m,this._x=(r+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+a*o+s*l-r*c,this._y=s*h+a*c+r*o-n*l,this._z=r*h+a*l+n*c-s*o,this._w=a*h-n*o-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let c=1-e;if(o<.9995){let l=Math.acos(o),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(nc.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(nc.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,c=t.w,l=2*(a*s-o*n),h=2*(o*e-r*s),f=2*(r*n-a*e);return this.x=e+c*l+a*f-o*h,this.y=n+c*h+o*l-r*f,this.z=s+c*f+r*h-a*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,c=e.z;return this.x=s*c-r*o,this.y=r*a-n*c,this.z=n*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return co.copy(this).projectOnVector(t),this.sub(co)}reflect(t){return this.sub(co.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},co=new F,nc=new Qe,Pt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l)}set(t,e,n,s,r,a,o,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=a,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],c=n[6],l=n[1],h=n[4],f=n[7],d=n[2],m=n[5],g=n[8],S=s[0],p=s[3],u=s[6],M=s[1],A=s[4],T=s[7],R=s[2],w=s[5],x=s[8];return r[0]=a*S+o*M+c*R,r[3]=a*p+o*A+c*w,r[6]=a*u+o*T+c*x,r[1]=l*S+h*M+f*R,r[4]=l*p+h*A+f*w,r[7]=l*u+h*T+f*x,r[2]=d*S+m*M+g*R,r[5]=d*p+m*A+g*w,r[8]=d*u+m*T+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8];return e*a*h-e*o*l-n*r*h+n*o*c+s*r*l-s*a*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=h*a-o*l,d=o*c-h*r,m=l*r-a*c,g=e*f+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/g;return t[0]=f*S,t[1]=(s*l-h*n)*S,t[2]=(o*n-s*a)*S,t[3]=d*S,t[4]=(h*e-s*c)*S,t[5]=(s*r-o*e)*S,t[6]=m*S,t[7]=(n*c-l*e)*S,t[8]=(a*e-n*r)*S,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*a+l*o)+a+t,-s*l,s*c,-s*(-l*a+c*o)+o+e,0,0,1),this}scale(t,e){return es("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ho.makeScale(t,e)),this}rotate(t){return es("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ho.makeRotation(-t)),this}translate(t,e){return es("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ho.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ho=new Pt,ic=new Pt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sc=new Pt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Pu(){let i={enabled:!0,workingColorSpace:is,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Zt&&(s.r=Cn(s.r),s.g=Cn(s.g),s.b=Cn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Zt&&(s.r=Pi(s.r),s.g=Pi(s.g),s.b=Pi(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Un?ss:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[is]:{primaries:t,whitePoint:n,transfer:ss,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ge},outputColorSpaceConfig:{drawingBufferColorSpace:Ge}},[Ge]:{primaries:t,whitePoint:n,transfer:Zt,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ge}}}),i}var Vt=Pu();function Cn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Pi(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xi,Pr=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{xi===void 0&&(xi=rs("canvas")),xi.width=t.width,xi.height=t.height;let s=xi.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=xi}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=rs("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Cn(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Cn(e[n]/255)*255):e[n]=Cn(e[n]);return{data:e,width:t.width,height:t.height}}else return Rt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Iu=0,Ni=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Iu++}),this.uuid=Ns(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(uo(s[a].image)):r.push(uo(s[a]))}else r=uo(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function uo(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Pr.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Rt("Texture: Unable to serialize Texture."),{})}var Lu=0,fo=new F,Oe=class i extends mn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=fn,s=fn,r=De,a=Nn,o=cn,c=Be,l=i.DEFAULT_ANISOTROPY,h=Un){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Lu++}),this.uuid=Ns(),this.name="",this.source=new Ni(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new Ht(0,0),this.repeat=new Ht(1,1),this.center=new Ht(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Pt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fo).x}get height(){return this.source.getSize(fo).y}get depth(){return this.source.getSize(fo).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Rt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Rt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Qo)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ar:t.x=t.x-Math.floor(t.x);break;case fn:t.x=t.x<0?0:1;break;case Rr:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ar:t.y=t.y-Math.floor(t.y);break;case fn:t.y=t.y<0?0:1;break;case Rr:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Oe.DEFAULT_IMAGE=null;Oe.DEFAULT_MAPPING=Qo;Oe.DEFAULT_ANISOTROPY=1;var se=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],f=c[8],d=c[1],m=c[5],g=c[9],S=c[2],p=c[6],u=c[10];if(Math.abs(h-d)<.01&&Math.abs(f-S)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+S)<.1&&Math.abs(g+p)<.1&&Math.abs(l+m+u-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(l+1)/2,T=(m+1)/2,R=(u+1)/2,w=(h+d)/4,x=(f+S)/4,b=(g+p)/4;return A>T&&A>R?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=w/n,r=x/n):T>R?T<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(T),n=w/s,r=b/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=x/r,s=b/r),this.set(n,s,r,e),this}let M=Math.sqrt((p-g)*(p-g)+(f-S)*(f-S)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(p-g)/M,this.y=(f-S)/M,this.z=(d-h)/M,this.w=Math.acos((l+m+u-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ir=class extends mn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:De,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new se(0,0,t,e),this.scissorTest=!1,this.viewport=new se(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Oe({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:De,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ni(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},He=class extends Ir{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},as=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Me,this.minFilter=Me,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Lr=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Me,this.minFilter=Me,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p)}set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p){let u=this.elements;return u[0]=t,u[4]=e,u[8]=n,u[12]=s,u[1]=r,u[5]=a,u[9]=o,u[13]=c,u[2]=l,u[6]=h,u[10]=f,u[14]=d,u[3]=m,u[7]=g,u[11]=S,u[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/vi.setFromMatrixColumn(t,0).length(),r=1/vi.setFromMatrixColumn(t,1).length(),a=1/vi.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let d=a*h,m=a*f,g=o*h,S=o*f;e[0]=c*h,e[4]=-c*f,e[8]=l,e[1]=m+g*l,e[5]=d-S*l,e[9]=-o*c,e[2]=S-d*l,e[6]=g+m*l,e[10]=a*c}else if(t.order==="YXZ"){let d=c*h,m=c*f,g=l*h,S=l*f;e[0]=d+S*o,e[4]=g*o-m,e[8]=a*l,e[1]=a*f,e[5]=a*h,e[9]=-o,e[2]=m*o-g,e[6]=S+d*o,e[10]=a*c}else if(t.order==="ZXY"){let d=c*h,m=c*f,g=l*h,S=l*f;e[0]=d-S*o,e[4]=-a*f,e[8]=g+m*o,e[1]=m+g*o,e[5]=a*h,e[9]=S-d*o,e[2]=-a*l,e[6]=o,e[10]=a*c}else if(t.order==="ZYX"){let d=a*h,m=a*f,g=o*h,S=o*f;e[0]=c*h,e[4]=g*l-m,e[8]=d*l+S,e[1]=c*f,e[5]=S*l+d,e[9]=m*l-g,e[2]=-l,e[6]=o*c,e[10]=a*c}else if(t.order==="YZX"){let d=a*c,m=a*l,g=o*c,S=o*l;e[0]=c*h,e[4]=S-d*f,e[8]=g*f+m,e[1]=f,e[5]=a*h,e[9]=-o*h,e[2]=-l*h,e[6]=m*f+g,e[10]=d-S*f}else if(t.order==="XZY"){let d=a*c,m=a*l,g=o*c,S=o*l;e[0]=c*h,e[4]=-f,e[8]=l*h,e[1]=d*f+S,e[5]=a*h,e[9]=m*f-g,e[2]=g*f-m,e[6]=o*h,e[10]=S*f+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Du,t,Nu)}lookAt(t,e,n){let s=this.elements;return ze.subVectors(t,e),ze.lengthSq()===0&&(ze.z=1),ze.normalize(),Gn.crossVectors(n,ze),Gn.lengthSq()===0&&(Math.abs(n.z)===1?ze.x+=1e-4:ze.z+=1e-4,ze.normalize(),Gn.crossVectors(n,ze)),Gn.normalize(),Xs.crossVectors(ze,Gn),s[0]=Gn.x,s[4]=Xs.x,s[8]=ze.x,s[1]=Gn.y,s[5]=Xs.y,s[9]=ze.y,s[2]=Gn.z,s[6]=Xs.z,s[10]=ze.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],c=n[8],l=n[12],h=n[1],f=n[5],d=n[9],m=n[13],g=n[2],S=n[6],p=n[10],u=n[14],M=n[3],A=n[7],T=n[11],R=n[15],w=s[0],x=s[4],b=s[8],N=s[12],I=s[1],D=s[5],B=s[9],H=s[13],_=s[2],V=s[6],q=s[10],G=s[14],et=s[3],X=s[7],Q=s[11],$=s[15];return r[0]=a*w+o*I+c*_+l*et,r[4]=a*x+o*D+c*V+l*X,r[8]=a*b+o*B+c*q+l*Q,r[12]=a*N+o*H+c*G+l*$,r[1]=h*w+f*I+d*_+m*et,r[5]=h*x+f*D+d*V+m*X,r[9]=h*b+f*B+d*q+m*Q,r[13]=h*N+f*H+d*G+m*$,r[2]=g*w+S*I+p*_+u*et,r[6]=g*x+S*D+p*V+u*X,r[10]=g*b+S*B+p*q+u*Q,r[14]=g*N+S*H+p*G+u*$,r[3]=M*w+A*I+T*_+R*et,r[7]=M*x+A*D+T*V+R*X,r[11]=M*b+A*B+T*q+R*Q,r[15]=M*N+A*H+T*G+R*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],c=t[9],l=t[13],h=t[2],f=t[6],d=t[10],m=t[14],g=t[3],S=t[7],p=t[11],u=t[15],M=c*m-l*d,A=o*m-l*f,T=o*d-c*f,R=a*m-l*h,w=a*d-c*h,x=a*f-o*h;return e*(S*M-p*A+u*T)-n*(g*M-p*R+u*w)+s*(g*A-S*R+u*x)-r*(g*T-S*w+p*x)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],c=t[2],l=t[6],h=t[10];return e*(a*h-o*l)-n*(r*h-o*c)+s*(r*l-a*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=t[9],d=t[10],m=t[11],g=t[12],S=t[13],p=t[14],u=t[15],M=e*o-n*a,A=e*c-s*a,T=e*l-r*a,R=n*c-s*o,w=n*l-r*o,x=s*l-r*c,b=h*S-f*g,N=h*p-d*g,I=h*u-m*g,D=f*p-d*S,B=f*u-m*S,H=d*u-m*p,_=M*H-A*B+T*D+R*I-w*N+x*b;if(_===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/_;return t[0]=(o*H-c*B+l*D)*V,t[1]=(s*B-n*H-r*D)*V,t[2]=(S*x-p*w+u*R)*V,t[3]=(d*w-f*x-m*R)*V,t[4]=(c*I-a*H-l*N)*V,t[5]=(e*H-s*I+r*N)*V,t[6]=(p*T-g*x-u*A)*V,t[7]=(h*x-d*T+m*A)*V,t[8]=(a*B-o*I+l*b)*V,t[9]=(n*I-e*B-r*b)*V,t[10]=(g*w-S*T+u*M)*V,t[11]=(f*T-h*w-m*M)*V,t[12]=(o*N-a*D-c*b)*V,t[13]=(e*D-n*N+s*b)*V,t[14]=(S*A-g*R-p*M)*V,t[15]=(h*R-f*A+d*M)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,c=t.z,l=r*a,h=r*o;return this.set(l*a+n,l*o-s*c,l*c+s*o,0,l*o+s*c,h*o+n,h*c-s*a,0,l*c-s*o,h*c+s*a,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,a=e._y,o=e._z,c=e._w,l=r+r,h=a+a,f=o+o,d=r*l,m=r*h,g=r*f,S=a*h,p=a*f,u=o*f,M=c*l,A=c*h,T=c*f,R=n.x,w=n.y,x=n.z;return s[0]=(1-(S+u))*R,s[1]=(m+T)*R,s[2]=(g-A)*R,s[3]=0,s[4]=(m-T)*w,s[5]=(1-(d+u))*w,s[6]=(p+M)*w,s[7]=0,s[8]=(g+A)*x,s[9]=(p-M)*x,s[10]=(1-(d+S))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=vi.set(s[0],s[1],s[2]).length(),o=vi.set(s[4],s[5],s[6]).length(),c=vi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),en.copy(this);let l=1/a,h=1/o,f=1/c;return en.elements[0]*=l,en.elements[1]*=l,en.elements[2]*=l,en.elements[4]*=h,en.elements[5]*=h,en.elements[6]*=h,en.elements[8]*=f,en.elements[9]*=f,en.elements[10]*=f,e.setFromRotationMatrix(en),n.x=a,n.y=o,n.z=c,this}makePerspective(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2*r/(e-t),f=2*r/(n-s),d=(e+t)/(e-t),m=(n+s)/(n-s),g,S;if(c)g=r/(a-r),S=a*r/(a-r);else if(o===je)g=-(a+r)/(a-r),S=-2*a*r/(a-r);else if(o===Li)g=-a/(a-r),S=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=S,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2/(e-t),f=2/(n-s),d=-(e+t)/(e-t),m=-(n+s)/(n-s),g,S;if(c)g=1/(a-r),S=a/(a-r);else if(o===je)g=-2/(a-r),S=-(a+r)/(a-r);else if(o===Li)g=-1/(a-r),S=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=g,l[14]=S,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},vi=new F,en=new Qt,Du=new F(0,0,0),Nu=new F(1,1,1),Gn=new F,Xs=new F,ze=new F,rc=new Qt,ac=new Qe,Pn=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],c=s[1],l=s[5],h=s[9],f=s[2],d=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-a,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Wt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-a,l));break;case"YZX":this._z=Math.asin(Wt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,m));break;case"XZY":this._z=Math.asin(-Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Rt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rc.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rc,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ac.setFromEuler(this),this.setFromQuaternion(ac,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pn.DEFAULT_ORDER="XYZ";var os=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Fu=0,oc=new F,yi=new Qe,bn=new Qt,qs=new F,Ki=new F,Uu=new F,Ou=new Qe,lc=new F(1,0,0),cc=new F(0,1,0),hc=new F(0,0,1),uc={type:"added"},Bu={type:"removed"},Si={type:"childadded",child:null},po={type:"childremoved",child:null},Ee=class i extends mn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Fu++}),this.uuid=Ns(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new F,e=new Pn,n=new Qe,s=new F(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new Pt}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new os,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.multiply(yi),this}rotateOnWorldAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.premultiply(yi),this}rotateX(t){return this.rotateOnAxis(lc,t)}rotateY(t){return this.rotateOnAxis(cc,t)}rotateZ(t){return this.rotateOnAxis(hc,t)}translateOnAxis(t,e){return oc.copy(t).applyQuaternion(this.quaternion),this.position.add(oc.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lc,t)}translateY(t){return this.translateOnAxis(cc,t)}translateZ(t){return this.translateOnAxis(hc,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(bn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?qs.copy(t):qs.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ki.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bn.lookAt(Ki,qs,this.up):bn.lookAt(qs,Ki,this.up),this.quaternion.setFromRotationMatrix(bn),s&&(bn.extractRotation(s.matrixWorld),yi.setFromRotationMatrix(bn),this.quaternion.premultiply(yi.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(_t("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(uc),Si.child=t,this.dispatchEvent(Si),Si.child=null):_t("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Bu),po.child=t,this.dispatchEvent(po),po.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),bn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),bn.multiply(t.parent.matrixWorld)),t.applyMatrix4(bn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(uc),Si.child=t,this.dispatchEvent(Si),Si.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,t,Uu),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,Ou,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let c=o.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];r(t.shapes,f)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(r(t.materials,this.material[c]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let c=this.animations[o];s.animations.push(r(t.animations,c))}}if(e){let o=a(t.geometries),c=a(t.materials),l=a(t.textures),h=a(t.images),f=a(t.shapes),d=a(t.skeletons),m=a(t.animations),g=a(t.nodes);o.length>0&&(n.geometries=o),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let c=[];for(let l in o){let h=o[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ee.DEFAULT_UP=new F(0,1,0);Ee.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ee.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ve=class extends Ee{constructor(){super(),this.isGroup=!0,this.type="Group"}},zu={type:"move"},Fi=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ve,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ve,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ve,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null,o=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){a=!0;for(let S of t.hand.values()){let p=e.getJointPose(S,n),u=this._getHandJoint(l,S);p!==null&&(u.matrix.fromArray(p.transform.matrix),u.matrix.decompose(u.position,u.quaternion,u.scale),u.matrixWorldNeedsUpdate=!0,u.jointRadius=p.radius),u.visible=p!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],d=h.position.distanceTo(f.position),m=.02,g=.005;l.inputState.pinching&&d>m+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=m-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(zu)))}return o!==null&&(o.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ve;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},dh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vn={h:0,s:0,l:0},Zs={h:0,s:0,l:0};function mo(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Ft=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ge){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Vt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Vt.workingColorSpace){return this.r=t,this.g=e,this.b=n,Vt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Vt.workingColorSpace){if(t=Ru(t,1),e=Wt(e,0,1),n=Wt(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=mo(a,r,t+1/3),this.g=mo(a,r,t),this.b=mo(a,r,t-1/3)}return Vt.colorSpaceToWorking(this,s),this}setStyle(t,e=Ge){function n(r){r!==void 0&&parseFloat(r)<1&&Rt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Rt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Rt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ge){let n=dh[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Rt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Cn(t.r),this.g=Cn(t.g),this.b=Cn(t.b),this}copyLinearToSRGB(t){return this.r=Pi(t.r),this.g=Pi(t.g),this.b=Pi(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ge){return Vt.workingToColorSpace(Ce.copy(this),t),Math.round(Wt(Ce.r*255,0,255))*65536+Math.round(Wt(Ce.g*255,0,255))*256+Math.round(Wt(Ce.b*255,0,255))}getHexString(t=Ge){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Vt.workingColorSpace){Vt.workingToColorSpace(Ce.copy(this),e);let n=Ce.r,s=Ce.g,r=Ce.b,a=Math.max(n,s,r),o=Math.min(n,s,r),c,l,h=(o+a)/2;if(o===a)c=0,l=0;else{let f=a-o;switch(l=h<=.5?f/(a+o):f/(2-a-o),a){case n:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-n)/f+2;break;case r:c=(n-s)/f+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=Vt.workingColorSpace){return Vt.workingToColorSpace(Ce.copy(this),e),t.r=Ce.r,t.g=Ce.g,t.b=Ce.b,t}getStyle(t=Ge){Vt.workingToColorSpace(Ce.copy(this),t);let e=Ce.r,n=Ce.g,s=Ce.b;return t!==Ge?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Vn),this.setHSL(Vn.h+t,Vn.s+e,Vn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Vn),t.getHSL(Zs);let n=lo(Vn.h,Zs.h,e),s=lo(Vn.s,Zs.s,e),r=lo(Vn.l,Zs.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ce=new Ft;Ft.NAMES=dh;var ls=class extends Ee{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pn,this.environmentIntensity=1,this.environmentRotation=new Pn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},nn=new F,Tn=new F,go=new F,En=new F,Mi=new F,bi=new F,dc=new F,xo=new F,vo=new F,yo=new F,So=new se,Mo=new se,bo=new se,Rn=class i{constructor(t=new F,e=new F,n=new F){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),nn.subVectors(t,e),s.cross(nn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){nn.subVectors(s,e),Tn.subVectors(n,e),go.subVectors(t,e);let a=nn.dot(nn),o=nn.dot(Tn),c=nn.dot(go),l=Tn.dot(Tn),h=Tn.dot(go),f=a*l-o*o;if(f===0)return r.set(0,0,0),null;let d=1/f,m=(l*c-o*h)*d,g=(a*h-o*c)*d;return r.set(1-m-g,g,m)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,En)===null?!1:En.x>=0&&En.y>=0&&En.x+En.y<=1}static getInterpolation(t,e,n,s,r,a,o,c){return this.getBarycoord(t,e,n,s,En)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,En.x),c.addScaledVector(a,En.y),c.addScaledVector(o,En.z),c)}static getInterpolatedAttribute(t,e,n,s,r,a){return So.setScalar(0),Mo.setScalar(0),bo.setScalar(0),So.fromBufferAttribute(t,e),Mo.fromBufferAttribute(t,n),bo.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(So,r.x),a.addScaledVector(Mo,r.y),a.addScaledVector(bo,r.z),a}static isFrontFacing(t,e,n,s){return nn.subVectors(n,e),Tn.subVectors(t,e),nn.cross(Tn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return nn.subVectors(this.c,this.b),Tn.subVectors(this.a,this.b),nn.cross(Tn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,a,o;Mi.subVectors(s,n),bi.subVectors(r,n),xo.subVectors(t,n);let c=Mi.dot(xo),l=bi.dot(xo);if(c<=0&&l<=0)return e.copy(n);vo.subVectors(t,s);let h=Mi.dot(vo),f=bi.dot(vo);if(h>=0&&f<=h)return e.copy(s);let d=c*f-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return a=c/(c-h),e.copy(n).addScaledVector(Mi,a);yo.subVectors(t,r);let m=Mi.dot(yo),g=bi.dot(yo);if(g>=0&&m<=g)return e.copy(r);let S=m*l-c*g;if(S<=0&&l>=0&&g<=0)return o=l/(l-g),e.copy(n).addScaledVector(bi,o);let p=h*g-m*f;if(p<=0&&f-h>=0&&m-g>=0)return dc.subVectors(r,s),o=(f-h)/(f-h+(m-g)),e.copy(s).addScaledVector(dc,o);let u=1/(p+S+d);return a=S*u,o=d*u,e.copy(n).addScaledVector(Mi,a).addScaledVector(bi,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qn=class{constructor(t=new F(1/0,1/0,1/0),e=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(sn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(sn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=sn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,sn):sn.fromBufferAttribute(r,a),sn.applyMatrix4(t.matrixWorld),this.expandByPoint(sn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ys.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ys.copy(n.boundingBox)),Ys.applyMatrix4(t.matrixWorld),this.union(Ys)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,sn),sn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ji),Js.subVectors(this.max,ji),Ti.subVectors(t.a,ji),Ei.subVectors(t.b,ji),wi.subVectors(t.c,ji),Hn.subVectors(Ei,Ti),Wn.subVectors(wi,Ei),ri.subVectors(Ti,wi);let e=[0,-Hn.z,Hn.y,0,-Wn.z,Wn.y,0,-ri.z,ri.y,Hn.z,0,-Hn.x,Wn.z,0,-Wn.x,ri.z,0,-ri.x,-Hn.y,Hn.x,0,-Wn.y,Wn.x,0,-ri.y,ri.x,0];return!To(e,Ti,Ei,wi,Js)||(e=[1,0,0,0,1,0,0,0,1],!To(e,Ti,Ei,wi,Js))?!1:(Ks.crossVectors(Hn,Wn),e=[Ks.x,Ks.y,Ks.z],To(e,Ti,Ei,wi,Js))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,sn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(sn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(wn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),wn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),wn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),wn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),wn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),wn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),wn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),wn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(wn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},wn=[new F,new F,new F,new F,new F,new F,new F,new F],sn=new F,Ys=new qn,Ti=new F,Ei=new F,wi=new F,Hn=new F,Wn=new F,ri=new F,ji=new F,Js=new F,Ks=new F,ai=new F;function To(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){ai.fromArray(i,r);let o=s.x*Math.abs(ai.x)+s.y*Math.abs(ai.y)+s.z*Math.abs(ai.z),c=t.dot(ai),l=e.dot(ai),h=n.dot(ai);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>o)return!1}return!0}var he=new F,js=new Ht,ku=0,pn=class extends mn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ku++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=ah,this.updateRanges=[],this.gpuType=on,this.version=0,this._normalizationScale=t!==void 0?ul(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)js.fromBufferAttribute(this,e),js.applyMatrix3(t),this.setXY(e,js.x,js.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix3(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix4(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyNormalMatrix(t),this.setXYZ(e,he.x,he.y,he.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.transformDirection(t),this.setXYZ(e,he.x,he.y,he.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Cu(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):_u(t,this.array)}};var cs=class extends pn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var hs=class extends pn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var te=class extends pn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Gu=new qn,Qi=new F,Eo=new F,ci=class{constructor(t=new F,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Gu.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qi.subVectors(t,this.center);let e=Qi.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Qi,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Eo.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qi.copy(t.center).add(Eo)),this.expandByPoint(Qi.copy(t.center).sub(Eo))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Vu=0,Ke=new Qt,wo=new Ee,Ai=new F,ke=new qn,$i=new qn,Se=new F,_e=class i extends mn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Vu++}),this.uuid=Ns(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(wu(t)?hs:cs)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Pt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ke.makeRotationFromQuaternion(t),this.applyMatrix4(Ke),this}rotateX(t){return Ke.makeRotationX(t),this.applyMatrix4(Ke),this}rotateY(t){return Ke.makeRotationY(t),this.applyMatrix4(Ke),this}rotateZ(t){return Ke.makeRotationZ(t),this.applyMatrix4(Ke),this}translate(t,e,n){return Ke.makeTranslation(t,e,n),this.applyMatrix4(Ke),this}scale(t,e,n){return Ke.makeScale(t,e,n),this.applyMatrix4(Ke),this}lookAt(t){return wo.lookAt(t),wo.updateMatrix(),this.applyMatrix4(wo.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ai).negate(),this.translate(Ai.x,Ai.y,Ai.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new te(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Rt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){_t("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ke.setFromBufferAttribute(r),this.morphTargetsRelative?(Se.addVectors(this.boundingBox.min,ke.min),this.boundingBox.expandByPoint(Se),Se.addVectors(this.boundingBox.max,ke.max),this.boundingBox.expandByPoint(Se)):(this.boundingBox.expandByPoint(ke.min),this.boundingBox.expandByPoint(ke.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&_t('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ci);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){_t("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(t){let n=this.boundingSphere.center;if(ke.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];$i.setFromBufferAttribute(o),this.morphTargetsRelative?(Se.addVectors(ke.min,$i.min),ke.expandByPoint(Se),Se.addVectors(ke.max,$i.max),ke.expandByPoint(Se)):(ke.expandByPoint($i.min),ke.expandByPoint($i.max))}ke.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Se.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Se));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],c=this.morphTargetsRelative;for(let l=0,h=o.count;l<h;l++)Se.fromBufferAttribute(o,l),c&&(Ai.fromBufferAttribute(t,l),Se.add(Ai)),s=Math.max(s,n.distanceToSquared(Se))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&_t('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){_t("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],c=[],l=new Uint8Array(n.count);for(let N=0;N<n.count;N++)o[N]=new F,c[N]=new F;let h=new F,f=new F,d=new F,m=new Ht,g=new Ht,S=new Ht,p=new F,u=new F;function M(N,I,D){l[N]=l[I]=l[D]=1,h.fromBufferAttribute(n,N),f.fromBufferAttribute(n,I),d.fromBufferAttribute(n,D),m.fromBufferAttribute(r,N),g.fromBufferAttribute(r,I),S.fromBufferAttribute(r,D),f.sub(h),d.sub(h),g.sub(m),S.sub(m);let B=1/(g.x*S.y-S.x*g.y);isFinite(B)&&(p.copy(f).multiplyScalar(S.y).addScaledVector(d,-g.y).multiplyScalar(B),u.copy(d).multiplyScalar(g.x).addScaledVector(f,-S.x).multiplyScalar(B),o[N].add(p),o[I].add(p),o[D].add(p),c[N].add(u),c[I].add(u),c[D].add(u))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let N=0,I=A.length;N<I;++N){let D=A[N],B=D.start,H=D.count;for(let _=B,V=B+H;_<V;_+=3)M(t.getX(_+0),t.getX(_+1),t.getX(_+2))}let T=new F,R=new F,w=new F,x=new F;function b(N){w.fromBufferAttribute(s,N),x.copy(w);let I=o[N];T.copy(I),T.sub(w.multiplyScalar(w.dot(I))).normalize(),R.crossVectors(x,I);let B=R.dot(c[N])<0?-1:1;a.setXYZW(N,T.x,T.y,T.z,B)}for(let N=0,I=n.count;N<I;++N)l[N]&&b(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new pn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new F,r=new F,a=new F,o=new F,c=new F,l=new F,h=new F,f=new F;if(t)for(let d=0,m=t.count;d<m;d+=3){let g=t.getX(d+0),S=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,S),a.fromBufferAttribute(e,p),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),o.fromBufferAttribute(n,g),c.fromBufferAttribute(n,S),l.fromBufferAttribute(n,p),o.add(h),c.add(h),l.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(S,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,m=e.count;d<m;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Se.fromBufferAttribute(t,e),Se.normalize(),t.setXYZ(e,Se.x,Se.y,Se.z)}toNonIndexed(){function t(o,c){let l=o.array,h=o.itemSize,f=o.normalized,d=new l.constructor(c.length*h),m=0,g=0;for(let S=0,p=c.length;S<p;S++){o.isInterleavedBufferAttribute?m=c[S]*o.data.stride+o.offset:m=c[S]*h;for(let u=0;u<h;u++)d[g++]=l[m++]}return new pn(d,h,f)}if(this.index===null)return Rt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let o in s){let c=s[o],l=t(c,n);e.setAttribute(o,l)}let r=this.morphAttributes;for(let o in r){let c=[],l=r[o];for(let h=0,f=l.length;h<f;h++){let d=l[h],m=t(d,n);c.push(m)}e.morphAttributes[o]=c}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,c=a.length;o<c;o++){let l=a[o];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,d=l.length;f<d;f++){let m=l[f];h.push(m.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],f=r[l];for(let d=0,m=f.length;d<m;d++)h.push(f[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let l=0,h=a.length;l<h;l++){let f=a[l];this.addGroup(f.start,f.count,f.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ao=new F,Hu=new F,Wu=new Pt,rn=class{constructor(t=new F(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Ao.subVectors(n,e).cross(Hu.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Ao),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Wu.getNormalMatrix(t),s=this.coplanarPoint(Ao).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Xu=0,In=class extends mn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Xu++}),this.uuid=Ns(),this.name="",this.type="Material",this.blending=Vi,this.side=Qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ho,this.blendDst=Wo,this.blendEquation=di,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ft(0,0,0),this.blendAlpha=0,this.depthFunc=Ii,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=th,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xr,this.stencilZFail=xr,this.stencilZPass=xr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Rt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Rt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let c=r[o];delete c.metadata,a.push(c)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ft().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new rn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ht().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ht().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var An=new F,Ro=new F,Qs=new F,$s=new F,us=class{constructor(t=new F,e=new F(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,An)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=An.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(An.copy(this.origin).addScaledVector(this.direction,e),An.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ro.copy(t).add(e).multiplyScalar(.5),Qs.copy(e).sub(t).normalize(),$s.copy(this.origin).sub(Ro);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Qs),o=$s.dot(this.direction),c=-$s.dot(Qs),l=$s.lengthSq(),h=Math.abs(1-a*a),f,d,m,g;if(h>0)if(f=a*c-o,d=a*o-c,g=r*h,f>=0)if(d>=-g)if(d<=g){let S=1/h;f*=S,d*=S,m=f*(f+a*d+2*o)+d*(a*f+d+2*c)+l}else d=r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d=-r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d<=-g?(f=Math.max(0,-(-a*r+o)),d=f>0?-r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l):d<=g?(f=0,d=Math.min(Math.max(-r,-c),r),m=d*(d+2*c)+l):(f=Math.max(0,-(a*r+o)),d=f>0?r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l);else d=a>0?-r:r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Ro).addScaledVector(Qs,d),m}intersectSphere(t,e){if(t.radius<0)return null;An.subVectors(t.center,this.origin);let n=An.dot(this.direction),s=An.dot(An)-n*n,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,c=n+a;return c<0?null:o<0?this.at(c,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(t.min.z-d.z)*f,c=(t.max.z-d.z)*f):(o=(t.max.z-d.z)*f,c=(t.min.z-d.z)*f),n>c||o>s)||((o>n||n!==n)&&(n=o),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,An)!==null}intersectTriangle(t,e,n,s,r){let a=this.origin,o=this.direction,c=o.x,l=o.y,h=o.z,f=t.x-a.x,d=t.y-a.y,m=t.z-a.z,g=e.x-a.x,S=e.y-a.y,p=e.z-a.z,u=n.x-a.x,M=n.y-a.y,A=n.z-a.z,T=Math.abs(c),R=Math.abs(l),w=Math.abs(h),x,b,N,I,D,B,H,_,V,q,G,et;if(T>=R&&T>=w?(N=c,B=f,V=g,et=u,c>=0?(x=l,b=h,I=d,D=m,H=S,_=p,q=M,G=A):(x=h,b=l,I=m,D=d,H=p,_=S,q=A,G=M)):R>=w?(N=l,B=d,V=S,et=M,l>=0?(x=h,b=c,I=m,D=f,H=p,_=g,q=A,G=u):(x=c,b=h,I=f,D=m,H=g,_=p,q=u,G=A)):(N=h,B=m,V=p,et=A,h>=0?(x=c,b=l,I=f,D=d,H=g,_=S,q=u,G=M):(x=l,b=c,I=d,D=f,H=S,_=g,q=M,G=u)),N===0)return null;let X=x/N,Q=b/N,$=1/N,Mt=I-X*B,Lt=D-Q*B,J=H-X*V,pt=_-Q*V,vt=q-X*et,wt=G-Q*et,mt=vt*pt-wt*J,Nt=Mt*wt-Lt*vt,le=J*Lt-pt*Mt;if(s){if(mt<0||Nt<0||le<0)return null}else if((mt<0||Nt<0||le<0)&&(mt>0||Nt>0||le>0))return null;let Ct=mt+Nt+le;if(Ct===0)return null;let Yt=$*(mt*B+Nt*V+le*et);return(Ct>0?Yt<0:Yt>0)?null:this.at(Yt/Ct,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$e=class extends In{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ft(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Qr,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fc=new Qt,oi=new us,tr=new ci,pc=new F,er=new F,nr=new F,ir=new F,Co=new F,sr=new F,mc=new F,rr=new F,pe=class extends Ee{constructor(t=new _e,e=new $e){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){sr.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=o[c],f=r[c];h!==0&&(Co.fromBufferAttribute(f,t),a?sr.addScaledVector(Co,h):sr.addScaledVector(Co.sub(e),h))}e.add(sr)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),tr.copy(n.boundingSphere),tr.applyMatrix4(r),oi.copy(t.ray).recast(t.near),!(tr.containsPoint(oi.origin)===!1&&(oi.intersectSphere(tr,pc)===null||oi.origin.distanceToSquared(pc)>(t.far-t.near)**2))&&(fc.copy(r).invert(),oi.copy(t.ray).applyMatrix4(fc),!(n.boundingBox!==null&&oi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,oi)))}_computeIntersections(t,e,n){let s,r=this.geometry,a=this.material,o=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,m=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,S=d.length;g<S;g++){let p=d[g],u=a[p.materialIndex],M=Math.max(p.start,m.start),A=Math.min(o.count,Math.min(p.start+p.count,m.start+m.count));for(let T=M,R=A;T<R;T+=3){let w=o.getX(T),x=o.getX(T+1),b=o.getX(T+2);s=ar(this,u,t,n,l,h,f,w,x,b),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),S=Math.min(o.count,m.start+m.count);for(let p=g,u=S;p<u;p+=3){let M=o.getX(p),A=o.getX(p+1),T=o.getX(p+2);s=ar(this,a,t,n,l,h,f,M,A,T),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(a))for(let g=0,S=d.length;g<S;g++){let p=d[g],u=a[p.materialIndex],M=Math.max(p.start,m.start),A=Math.min(c.count,Math.min(p.start+p.count,m.start+m.count));for(let T=M,R=A;T<R;T+=3){let w=T,x=T+1,b=T+2;s=ar(this,u,t,n,l,h,f,w,x,b),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),S=Math.min(c.count,m.start+m.count);for(let p=g,u=S;p<u;p+=3){let M=p,A=p+1,T=p+2;s=ar(this,a,t,n,l,h,f,M,A,T),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function qu(i,t,e,n,s,r,a,o){let c;if(t.side===Ne?c=n.intersectTriangle(a,r,s,!0,o):c=n.intersectTriangle(s,r,a,t.side===Qn,o),c===null)return null;rr.copy(o),rr.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(rr);return l<e.near||l>e.far?null:{distance:l,point:rr.clone(),object:i}}function ar(i,t,e,n,s,r,a,o,c,l){i.getVertexPosition(o,er),i.getVertexPosition(c,nr),i.getVertexPosition(l,ir);let h=qu(i,t,e,n,er,nr,ir,mc);if(h){let f=new F;Rn.getBarycoord(mc,er,nr,ir,f),s&&(h.uv=Rn.getInterpolatedAttribute(s,o,c,l,f,new Ht)),r&&(h.uv1=Rn.getInterpolatedAttribute(r,o,c,l,f,new Ht)),a&&(h.normal=Rn.getInterpolatedAttribute(a,o,c,l,f,new F),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:c,c:l,normal:new F,materialIndex:0};Rn.getNormal(er,nr,ir,d.normal),h.face=d,h.barycoord=f}return h}var Dr=class extends Oe{constructor(t=null,e=1,n=1,s,r,a,o,c,l=Me,h=Me,f,d){super(null,a,o,c,l,h,s,r,f,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var li=new ci,Zu=new Ht(.5,.5),or=new F,Zn=class{constructor(t=new rn,e=new rn,n=new rn,s=new rn,r=new rn,a=new rn){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=je,n=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],c=r[2],l=r[3],h=r[4],f=r[5],d=r[6],m=r[7],g=r[8],S=r[9],p=r[10],u=r[11],M=r[12],A=r[13],T=r[14],R=r[15];if(s[0].setComponents(l-a,m-h,u-g,R-M).normalize(),s[1].setComponents(l+a,m+h,u+g,R+M).normalize(),s[2].setComponents(l+o,m+f,u+S,R+A).normalize(),s[3].setComponents(l-o,m-f,u-S,R-A).normalize(),n)s[4].setComponents(c,d,p,T).normalize(),s[5].setComponents(l-c,m-d,u-p,R-T).normalize();else if(s[4].setComponents(l-c,m-d,u-p,R-T).normalize(),e===je)s[5].setComponents(l+c,m+d,u+p,R+T).normalize();else if(e===Li)s[5].setComponents(c,d,p,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),li.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),li.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(li)}intersectsSprite(t){li.center.set(0,0,0);let e=Zu.distanceTo(t.center);return li.radius=.7071067811865476+e,li.applyMatrix4(t.matrixWorld),this.intersectsSphere(li)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(or.x=s.normal.x>0?t.max.x:t.min.x,or.y=s.normal.y>0?t.max.y:t.min.y,or.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(or)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gc=new Qt,Nr=class i{constructor(){this.coordinateSystem=je,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];gc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Zn),n[s].setFromProjectionMatrix(gc,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Zn),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Yn=class extends In{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ft(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Fr=new F,Ur=new F,xc=new Qt,ts=new us,lr=new ci,_o=new F,vc=new F,Ui=class extends Ee{constructor(t=new _e,e=new Yn){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Fr.fromBufferAttribute(e,s-1),Ur.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Fr.distanceTo(Ur);t.setAttribute("lineDistance",new te(n,1))}else Rt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),lr.copy(n.boundingSphere),lr.applyMatrix4(s),lr.radius+=r,t.ray.intersectsSphere(lr)===!1)return;xc.copy(s).invert(),ts.copy(t.ray).applyMatrix4(xc);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let S=m,p=g-1;S<p;S+=l){let u=h.getX(S),M=h.getX(S+1),A=cr(this,t,ts,c,u,M,S);A&&e.push(A)}if(this.isLineLoop){let S=h.getX(g-1),p=h.getX(m),u=cr(this,t,ts,c,S,p,g-1);u&&e.push(u)}}else{let m=Math.max(0,a.start),g=Math.min(d.count,a.start+a.count);for(let S=m,p=g-1;S<p;S+=l){let u=cr(this,t,ts,c,S,S+1,S);u&&e.push(u)}if(this.isLineLoop){let S=cr(this,t,ts,c,g-1,m,g-1);S&&e.push(S)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function cr(i,t,e,n,s,r,a){let o=i.geometry.attributes.position;if(Fr.fromBufferAttribute(o,s),Ur.fromBufferAttribute(o,r),e.distanceSqToSegment(Fr,Ur,_o,vc)>n)return;_o.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(_o);if(!(l<t.near||l>t.far))return{distance:l,point:vc.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var yc=new F,Sc=new F,Oi=class extends Ui{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)yc.fromBufferAttribute(e,s),Sc.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+yc.distanceTo(Sc);t.setAttribute("lineDistance",new te(n,1))}else Rt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ds=class extends Oe{constructor(t=[],e=fi,n,s,r,a,o,c,l,h){super(t,e,n,s,r,a,o,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ln=class extends Oe{constructor(t,e,n=an,s,r,a,o=Me,c=Me,l,h=_n,f=1){if(h!==_n&&h!==Fn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:f};super(d,s,r,a,o,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ni(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},fs=class extends Ln{constructor(t,e=an,n=fi,s,r,a=Me,o=Me,c,l=_n){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ps=class extends Oe{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Dn=class i extends _e{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let c=[],l=[],h=[],f=[],d=0,m=0;g("z","y","x",-1,-1,n,e,t,a,r,0),g("z","y","x",1,-1,n,e,-t,a,r,1),g("x","z","y",1,1,t,n,e,s,a,2),g("x","z","y",1,-1,t,n,-e,s,a,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2));function g(S,p,u,M,A,T,R,w,x,b,N){let I=T/x,D=R/b,B=T/2,H=R/2,_=w/2,V=x+1,q=b+1,G=0,et=0,X=new F;for(let Q=0;Q<q;Q++){let $=Q*D-H;for(let Mt=0;Mt<V;Mt++){let Lt=Mt*I-B;X[S]=Lt*M,X[p]=$*A,X[u]=_,l.push(X.x,X.y,X.z),X[S]=0,X[p]=0,X[u]=w>0?1:-1,h.push(X.x,X.y,X.z),f.push(Mt/x),f.push(1-Q/b),G+=1}}for(let Q=0;Q<b;Q++)for(let $=0;$<x;$++){let Mt=d+$+V*Q,Lt=d+$+V*(Q+1),J=d+($+1)+V*(Q+1),pt=d+($+1)+V*Q;c.push(Mt,Lt,pt),c.push(Lt,J,pt),et+=6}o.addGroup(m,et,N),m+=et,d+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Bi=class i extends _e{constructor(t=1,e=1,n=1,s=32,r=1,a=!1,o=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],d=[],m=[],g=0,S=[],p=n/2,u=0;M(),a===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new te(f,3)),this.setAttribute("normal",new te(d,3)),this.setAttribute("uv",new te(m,2));function M(){let T=new F,R=new F,w=0,x=(e-t)/n;for(let b=0;b<=r;b++){let N=[],I=b/r,D=I*(e-t)+t;for(let B=0;B<=s;B++){let H=B/s,_=H*c+o,V=Math.sin(_),q=Math.cos(_);R.x=D*V,R.y=-I*n+p,R.z=D*q,f.push(R.x,R.y,R.z),T.set(V,x,q).normalize(),d.push(T.x,T.y,T.z),m.push(H,1-I),N.push(g++)}S.push(N)}for(let b=0;b<s;b++)for(let N=0;N<r;N++){let I=S[N][b],D=S[N+1][b],B=S[N+1][b+1],H=S[N][b+1];(t>0||N!==0)&&(h.push(I,D,H),w+=3),(e>0||N!==r-1)&&(h.push(D,B,H),w+=3)}l.addGroup(u,w,0),u+=w}function A(T){let R=g,w=new Ht,x=new F,b=0,N=T===!0?t:e,I=T===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,p*I,0),d.push(0,I,0),m.push(.5,.5),g++;let D=g;for(let B=0;B<=s;B++){let _=B/s*c+o,V=Math.cos(_),q=Math.sin(_);x.x=N*q,x.y=p*I,x.z=N*V,f.push(x.x,x.y,x.z),d.push(0,I,0),w.x=V*.5+.5,w.y=q*.5*I+.5,m.push(w.x,w.y),g++}for(let B=0;B<s;B++){let H=R+B,_=D+B;T===!0?h.push(_,_+1,H):h.push(_+1,_,H),b+=3}l.addGroup(u,b,T===!0?1:2),u+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ms=class i extends Bi{constructor(t=1,e=1,n=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,n,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var hr=new F,ur=new F,Po=new F,dr=new Rn,gs=class extends _e{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(vr*e),a=t.getIndex(),o=t.getAttribute("position"),c=a?a.count:o.count,l=[0,0,0],h=["a","b","c"],f=new Array(3),d=new Map,m=[];for(let g=0;g<c;g+=3){a?(l[0]=a.getX(g),l[1]=a.getX(g+1),l[2]=a.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:S,b:p,c:u}=dr;if(S.fromBufferAttribute(o,l[0]),p.fromBufferAttribute(o,l[1]),u.fromBufferAttribute(o,l[2]),dr.getNormal(Po),f[0]=`${Math.round(S.x*s)},${Math.round(S.y*s)},${Math.round(S.z*s)}`,f[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,f[2]=`${Math.round(u.x*s)},${Math.round(u.y*s)},${Math.round(u.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let M=0;M<3;M++){let A=(M+1)%3,T=f[M],R=f[A],w=dr[h[M]],x=dr[h[A]],b=`${T}_${R}`,N=`${R}_${T}`,I=d.get(N);I?(Po.dot(I.normal)<=r&&(m.push(w.x,w.y,w.z),m.push(x.x,x.y,x.z)),d.set(N,null)):d.has(b)||d.set(b,{index0:l[M],index1:l[A],normal:Po.clone()})}}for(let g of d.values())if(g){let{index0:S,index1:p}=g;hr.fromBufferAttribute(o,S),ur.fromBufferAttribute(o,p),m.push(hr.x,hr.y,hr.z),m.push(ur.x,ur.y,ur.z)}this.setAttribute("position",new te(m,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var hi=class i extends _e{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(n),c=Math.floor(s),l=o+1,h=c+1,f=t/o,d=e/c,m=[],g=[],S=[],p=[];for(let u=0;u<h;u++){let M=u*d-a;for(let A=0;A<l;A++){let T=A*f-r;g.push(T,-M,0),S.push(0,0,1),p.push(A/o),p.push(1-u/c)}}for(let u=0;u<c;u++)for(let M=0;M<o;M++){let A=M+l*u,T=M+l*(u+1),R=M+1+l*(u+1),w=M+1+l*u;m.push(A,T,w),m.push(T,R,w)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(S,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var zi=class i extends _e{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(a+o,Math.PI),l=0,h=[],f=new F,d=new F,m=[],g=[],S=[],p=[];for(let u=0;u<=n;u++){let M=[],A=u/n,T=a+A*o,R=t*Math.cos(T),w=Math.sqrt(t*t-R*R),x=0;u===0&&a===0?x=.5/e:u===n&&c===Math.PI&&(x=-.5/e);for(let b=0;b<=e;b++){let N=b/e,I=s+N*r;f.x=-w*Math.cos(I),f.y=R,f.z=w*Math.sin(I),g.push(f.x,f.y,f.z),d.copy(f).normalize(),S.push(d.x,d.y,d.z),p.push(N+x,1-A),M.push(l++)}h.push(M)}for(let u=0;u<n;u++)for(let M=0;M<e;M++){let A=h[u][M+1],T=h[u][M],R=h[u+1][M],w=h[u+1][M+1];(u!==0||a>0)&&m.push(A,T,w),(u!==n-1||c<Math.PI)&&m.push(T,R,w)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(S,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var xs=class i extends _e{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],h=[],f=[],d=new F,m=new F,g=new F;for(let S=0;S<=n;S++){let p=a+S/n*o;for(let u=0;u<=s;u++){let M=u/s*r;m.x=(t+e*Math.cos(p))*Math.cos(M),m.y=(t+e*Math.cos(p))*Math.sin(M),m.z=e*Math.sin(p),l.push(m.x,m.y,m.z),d.x=t*Math.cos(M),d.y=t*Math.sin(M),g.subVectors(m,d).normalize(),h.push(g.x,g.y,g.z),f.push(u/s),f.push(S/n)}}for(let S=1;S<=n;S++)for(let p=1;p<=s;p++){let u=(s+1)*S+p-1,M=(s+1)*(S-1)+p-1,A=(s+1)*(S-1)+p,T=(s+1)*S+p;c.push(u,M,T),c.push(M,A,T)}this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function mi(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Mc(s))s.isRenderTargetTexture?(Rt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Mc(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Pe(i){let t={};for(let e=0;e<i.length;e++){let n=mi(i[e]);for(let s in n)t[s]=n[s]}return t}function Mc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Yu(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function dl(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Vt.workingColorSpace}var fh={clone:mi,merge:Pe},Ju=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ku=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,gn=class extends In{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ju,this.fragmentShader=Ku,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=mi(t.uniforms),this.uniformsGroups=Yu(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Ft().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ht().fromArray(s.value);break;case"v3":this.uniforms[n].value=new F().fromArray(s.value);break;case"v4":this.uniforms[n].value=new se().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Pt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Or=class extends gn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vs=class extends In{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ft(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ft(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new Ht(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Qr,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Br=class extends In{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qc,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},zr=class extends In{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ri(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function fr(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Jn=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let a;e:{i:if(!(t<s)){for(let o=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=e[++n],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(n=2,r=o);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}a=n,n=0;break e}break n}for(;n<a;){let o=n+a>>>1;t<e[o]?a=o:n=o+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=n[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Do,endingEnd:Do}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],c=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case No:r=t,o=2*e-n;break;case Fo:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=n}if(c===void 0)switch(this.getSettings_().endingEnd){case No:a=t,c=2*n-e;break;case Fo:a=1,c=n+s[1]-s[0];break;default:a=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-o),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-e)/(s-e),S=g*g,p=S*g,u=-d*p+2*d*S-d*g,M=(1+d)*p+(-1.5-2*d)*S+(-.5+d)*g+1,A=(-1-m)*p+(1.5+m)*S+.5*g,T=m*p-m*S;for(let R=0;R!==o;++R)r[R]=u*a[h+R]+M*a[l+R]+A*a[c+R]+T*a[f+R];return r}},Gr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=(n-e)/(s-e),f=1-h;for(let d=0;d!==o;++d)r[d]=a[l+d]*f+a[c+d]*h;return r}},Vr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Hr=class extends Jn{interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-e)/(s-e),S=1-g;for(let p=0;p!==o;++p)r[p]=a[l+p]*S+a[c+p]*g;return r}let d=o*2,m=t-1;for(let g=0;g!==o;++g){let S=a[l+g],p=a[c+g],u=m*d+g*2,M=f[u],A=f[u+1],T=t*d+g*2,R=h[T],w=h[T+1],x=Qu(n,e,M,R,s);r[g]=ph(x,S,A,w,p)}return r}};function ph(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function ju(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Qu(i,t,e,n,s){let r=(i-t)/(s-t);for(let a=0;a<8;a++){let o=ph(r,t,e,n,s)-i;if(Math.abs(o)<1e-10)break;let c=ju(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-o/c))}return r}var We=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ri(e,this.TimeBufferType),this.values=Ri(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Ri(t.times,Array),values:Ri(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),fr(t.settings)&&(n.settings={inTangents:Ri(t.settings.inTangents,Array),outTangents:Ri(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Vr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Gr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new kr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Hr(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ns:e=this.InterpolantFactoryMethodDiscrete;break;case Cr:e=this.InterpolantFactoryMethodLinear;break;case gr:e=this.InterpolantFactoryMethodSmooth;break;case Lo:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Rt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ns;case this.InterpolantFactoryMethodLinear:return Cr;case this.InterpolantFactoryMethodSmooth:return gr;case this.InterpolantFactoryMethodBezier:return Lo}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;fr(this.settings)&&(bc(this.settings.inTangents,t),bc(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;fr(this.settings)&&(Tc(this.settings.inTangents,t),Tc(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<t;)++r;for(;a!==-1&&n[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(_t("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(_t("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let c=n[o];if(typeof c=="number"&&isNaN(c)){_t("KeyframeTrack: Time is not a valid number.",this,o,c),t=!1;break}if(a!==null&&a>c){_t("KeyframeTrack: Out of order keys.",this,o,c,a),t=!1;break}a=c}if(s!==void 0&&Au(s))for(let o=0,c=s.length;o!==c;++o){let l=s[o];if(isNaN(l)){_t("KeyframeTrack: Value is not a valid number.",this,o,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===gr,r=t.length-1,a=1;for(let o=1;o<r;++o){let c=!1,l=t[o],h=t[o+1];if(l!==h&&(o!==1||l!==t[0]))if(s)c=!0;else{let f=o*n,d=f-n,m=f+n;for(let g=0;g!==n;++g){let S=e[f+g];if(S!==e[d+g]||S!==e[m+g]){c=!0;break}}}if(c){if(o!==a){t[a]=t[o];let f=o*n,d=a*n;for(let m=0;m!==n;++m)e[d+m]=e[f+m]}++a}}if(r>0){t[a]=t[r];for(let o=r*n,c=a*n,l=0;l!==n;++l)e[c+l]=e[o+l];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,fr(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Tc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}We.prototype.ValueTypeName="";We.prototype.TimeBufferType=Float32Array;We.prototype.ValueBufferType=Float32Array;We.prototype.DefaultInterpolation=Cr;var Kn=class extends We{constructor(t,e,n){super(t,e,n)}};Kn.prototype.ValueTypeName="bool";Kn.prototype.ValueBufferType=Array;Kn.prototype.DefaultInterpolation=ns;Kn.prototype.InterpolantFactoryMethodLinear=void 0;Kn.prototype.InterpolantFactoryMethodSmooth=void 0;var Wr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Wr.prototype.ValueTypeName="color";var Xr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Xr.prototype.ValueTypeName="number";var qr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=(n-e)/(s-e),l=t*o;for(let h=l+o;l!==h;l+=4)Qe.slerpFlat(r,0,a,l-o,a,l,c);return r}},ys=class extends We{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new qr(this.times,this.values,this.getValueSize(),t)}};ys.prototype.ValueTypeName="quaternion";ys.prototype.InterpolantFactoryMethodSmooth=void 0;var jn=class extends We{constructor(t,e,n){super(t,e,n)}};jn.prototype.ValueTypeName="string";jn.prototype.ValueBufferType=Array;jn.prototype.DefaultInterpolation=ns;jn.prototype.InterpolantFactoryMethodLinear=void 0;jn.prototype.InterpolantFactoryMethodSmooth=void 0;var Zr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Zr.prototype.ValueTypeName="vector";var Yr=class{constructor(t,e,n){let s=this,r=!1,a=0,o=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,f){return l.push(h,f),this},this.removeHandler=function(h){let f=l.indexOf(h);return f!==-1&&l.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=l.length;f<d;f+=2){let m=l[f],g=l[f+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mh=new Yr,Jr=class{constructor(t){this.manager=t!==void 0?t:mh,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ss=class extends Ee{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ft(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ms=class extends Ss{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ee.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ft(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Io=new Qt,Ec=new F,wc=new F,Kr=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ht(512,512),this.mapType=Be,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zn,this._frameExtents=new Ht(1,1),this._viewportCount=1,this._viewports=[new se(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ec.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ec),wc.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(wc),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Io.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Io,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Li||t.reversedDepth?e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,.5,.5,0,0,0,1),e.multiply(Io)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},pr=new F,mr=new Qe,dn=new F,bs=class extends Ee{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=je,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xn=new F,Ac=new Ht,Rc=new Ht,Le=class extends bs{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=_r*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(vr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return _r*2*Math.atan(Math.tan(vr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Xn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z),Xn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z)}getViewSize(t,e){return this.getViewBounds(t,Ac,Rc),e.subVectors(Rc,Ac)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(vr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let c=a.fullWidth,l=a.fullHeight;r+=a.offsetX*s/c,e-=a.offsetY*n/l,s*=a.width/c,n*=a.height/l}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ts=class extends bs{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,a=n+t,o=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,a=r+l*this.view.width,o-=h*this.view.offsetY,c=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Uo=class extends Kr{constructor(){super(new Ts(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Es=class extends Ss{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ee.DEFAULT_UP),this.updateMatrix(),this.target=new Ee,this.shadow=new Uo}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ci=-90,_i=1,ki=class extends Ee{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Le(Ci,_i,t,e);s.layers=this.layers,this.add(s);let r=new Le(Ci,_i,t,e);r.layers=this.layers,this.add(r);let a=new Le(Ci,_i,t,e);a.layers=this.layers,this.add(a);let o=new Le(Ci,_i,t,e);o.layers=this.layers,this.add(o);let c=new Le(Ci,_i,t,e);c.layers=this.layers,this.add(c);let l=new Le(Ci,_i,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,c]=e;for(let l of e)this.remove(l);if(t===je)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Li)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,c,l,h]=this.children,f=t.getRenderTarget(),d=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=S,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,d,m),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},jr=class extends Le{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var fl="\\[\\]\\.:\\/",$u=new RegExp("["+fl+"]","g"),pl="[^"+fl+"]",td="[^"+fl.replace("\\.","")+"]",ed=/((?:WC+[\/:])*)/.source.replace("WC",pl),nd=/(WCOD+)?/.source.replace("WCOD",td),id=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pl),sd=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pl),rd=new RegExp("^"+ed+nd+id+sd+"$"),ad=["material","materials","bones","map"],Oo=class{constructor(t,e,n){let s=n||ee.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},ee=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace($u,"")}static parseTrackName(t){let e=rd.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ad.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let c=n(o.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Rt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){_t("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){_t("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){_t("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){_t("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){_t("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let a=t[s];if(a===void 0){let l=e.nodeName;_t("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(c=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ee.Composite=Oo;ee.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ee.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ee.prototype.GetterByBindingType=[ee.prototype._getValue_direct,ee.prototype._getValue_array,ee.prototype._getValue_arrayElement,ee.prototype._getValue_toArray];ee.prototype.SetterByBindingTypeAndVersioning=[[ee.prototype._setValue_direct,ee.prototype._setValue_direct_setNeedsUpdate,ee.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_array,ee.prototype._setValue_array_setNeedsUpdate,ee.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_arrayElement,ee.prototype._setValue_arrayElement_setNeedsUpdate,ee.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_fromArray,ee.prototype._setValue_fromArray_setNeedsUpdate,ee.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p0=new Float32Array(1);var Bo=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var ws=class extends Oi{constructor(t=10,e=10,n=4473924,s=8947848){n=new Ft(n),s=new Ft(s);let r=e/2,a=t/e,o=t/2,c=[],l=[];for(let d=0,m=0,g=-o;d<=e;d++,g+=a){c.push(-o,0,g,o,0,g),c.push(g,0,-o,g,0,o);let S=d===r?n:s;S.toArray(l,m),m+=3,S.toArray(l,m),m+=3,S.toArray(l,m),m+=3,S.toArray(l,m),m+=3}let h=new _e;h.setAttribute("position",new te(c,3)),h.setAttribute("color",new te(l,3));let f=new Yn({vertexColors:!0,toneMapped:!1});super(h,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};function ml(i,t,e,n){let s=od(n);switch(e){case il:return i*t;case rl:return i*t/s.components*s.byteLength;case ra:return i*t/s.components*s.byteLength;case $n:return i*t*2/s.components*s.byteLength;case aa:return i*t*2/s.components*s.byteLength;case sl:return i*t*3/s.components*s.byteLength;case cn:return i*t*4/s.components*s.byteLength;case oa:return i*t*4/s.components*s.byteLength;case Cs:case _s:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ps:case Is:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ca:case ua:return Math.max(i,16)*Math.max(t,8)/4;case la:case ha:return Math.max(i,8)*Math.max(t,8)/2;case da:case fa:case ma:case ga:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case pa:case Ls:case xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case va:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ya:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Sa:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Ma:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ba:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Ta:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Ea:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case wa:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Aa:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Ra:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ca:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case _a:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Pa:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Ia:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case La:case Da:case Na:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Fa:case Ua:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ds:case Oa:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function od(i){switch(i){case Be:case $o:return{byteLength:1,components:1};case Wi:case tl:case ln:return{byteLength:2,components:1};case ia:case sa:return{byteLength:2,components:4};case an:case na:case on:return{byteLength:4,components:1};case el:case nl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Rt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Oh(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function cd(i){let t=new WeakMap;function e(o,c){let l=o.array,h=o.usage,f=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),o.onUploadCallback();let m;if(l instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=i.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=i.SHORT;else if(l instanceof Uint32Array)m=i.UNSIGNED_INT;else if(l instanceof Int32Array)m=i.INT;else if(l instanceof Int8Array)m=i.BYTE;else if(l instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,c,l){let h=c.array,f=c.updateRanges;if(i.bindBuffer(l,o),f.length===0)i.bufferSubData(l,0,h);else{f.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<f.length;m++){let g=f[d],S=f[m];S.start<=g.start+g.count+1?g.count=Math.max(g.count,S.start+S.count-g.start):(++d,f[d]=S)}f.length=d+1;for(let m=0,g=f.length;m<g;m++){let S=f[m];i.bufferSubData(l,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let c=t.get(o);c&&(i.deleteBuffer(c.buffer),t.delete(o))}function a(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let l=t.get(o);if(l===void 0)t.set(o,e(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,o,c),l.version=o.version}}return{get:s,remove:r,update:a}}var hd=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ud=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,dd=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,fd=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,pd=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,md=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,gd=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,xd=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,vd=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,yd=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Sd=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Md=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,bd=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Td=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Ed=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,wd=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ad=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Rd=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Cd=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,_d=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Pd=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Id=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Ld=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Dd=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Nd=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Fd=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ud=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Od=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Bd=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zd="gl_FragColor = linearToOutputTexel( gl_FragColor );",kd=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Gd=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Vd=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Hd=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Wd=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Xd=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,qd=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Zd=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Yd=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Jd=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Kd=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,jd=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Qd=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,$d=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,tf=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,ef=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,nf=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,sf=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,rf=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,af=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,of=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,lf=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,cf=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,hf=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,uf=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,df=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,ff=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,pf=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,mf=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gf=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,xf=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,vf=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,yf=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Sf=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Mf=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,bf=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Tf=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ef=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,wf=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Af=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Rf=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Cf=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,_f=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Pf=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,If=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Lf=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Df=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Nf=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ff=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Uf=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Of=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Bf=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,zf=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,kf=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Gf=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Vf=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Hf=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Wf=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Xf=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,qf=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Zf=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Yf=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Jf=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Kf=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,jf=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Qf=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,$f=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,tp=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ep=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,np=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ip=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,sp=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,rp=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,ap=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,op=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,lp=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,cp=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,hp=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,up=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dp=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fp=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pp=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mp=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gp=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,xp=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,vp=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,yp=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Sp=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Mp=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,bp=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Tp=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ep=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,wp=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ap=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Rp=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Cp=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,_p=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Pp=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Ip=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Lp=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Dp=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Np=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Fp=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Up=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Op=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Bp=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,zp=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,kp=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Gp=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Vp=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Hp=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Bt={alphahash_fragment:hd,alphahash_pars_fragment:ud,alphamap_fragment:dd,alphamap_pars_fragment:fd,alphatest_fragment:pd,alphatest_pars_fragment:md,aomap_fragment:gd,aomap_pars_fragment:xd,batching_pars_vertex:vd,batching_vertex:yd,begin_vertex:Sd,beginnormal_vertex:Md,bsdfs:bd,iridescence_fragment:Td,bumpmap_pars_fragment:Ed,clipping_planes_fragment:wd,clipping_planes_pars_fragment:Ad,clipping_planes_pars_vertex:Rd,clipping_planes_vertex:Cd,color_fragment:_d,color_pars_fragment:Pd,color_pars_vertex:Id,color_vertex:Ld,common:Dd,defaultnormal_vertex:Nd,displacementmap_pars_vertex:Fd,displacementmap_vertex:Ud,emissivemap_fragment:Od,emissivemap_pars_fragment:Bd,colorspace_fragment:zd,colorspace_pars_fragment:kd,envmap_fragment:Gd,envmap_common_pars_fragment:Vd,envmap_pars_fragment:Hd,envmap_pars_vertex:Wd,envmap_physical_pars_fragment:ef,envmap_vertex:Xd,fog_vertex:qd,fog_pars_vertex:Zd,fog_fragment:Yd,fog_pars_fragment:Jd,gradientmap_pars_fragment:Kd,lightmap_pars_fragment:jd,lights_lambert_fragment:Qd,lights_lambert_pars_fragment:$d,lights_pars_begin:tf,lights_toon_fragment:nf,lights_toon_pars_fragment:sf,lights_phong_fragment:rf,lights_phong_pars_fragment:af,lights_physical_fragment:of,lights_physical_pars_fragment:lf,lights_fragment_begin:cf,lights_fragment_maps:hf,lights_fragment_end:uf,lightprobes_pars_fragment:df,logdepthbuf_fragment:ff,logdepthbuf_pars_fragment:pf,logdepthbuf_pars_vertex:mf,logdepthbuf_vertex:gf,map_fragment:xf,map_pars_fragment:vf,map_particle_fragment:yf,map_particle_pars_fragment:Sf,metalnessmap_fragment:Mf,metalnessmap_pars_fragment:bf,morphinstance_vertex:Tf,morphcolor_vertex:Ef,morphnormal_vertex:wf,morphtarget_pars_vertex:Af,morphtarget_vertex:Rf,normal_fragment_begin:Cf,normal_fragment_maps:_f,normal_pars_fragment:Pf,normal_pars_vertex:If,normal_vertex:Lf,normalmap_pars_fragment:Df,clearcoat_normal_fragment_begin:Nf,clearcoat_normal_fragment_maps:Ff,clearcoat_pars_fragment:Uf,iridescence_pars_fragment:Of,opaque_fragment:Bf,packing:zf,premultiplied_alpha_fragment:kf,project_vertex:Gf,dithering_fragment:Vf,dithering_pars_fragment:Hf,roughnessmap_fragment:Wf,roughnessmap_pars_fragment:Xf,shadowmap_pars_fragment:qf,shadowmap_pars_vertex:Zf,shadowmap_vertex:Yf,shadowmask_pars_fragment:Jf,skinbase_vertex:Kf,skinning_pars_vertex:jf,skinning_vertex:Qf,skinnormal_vertex:$f,specularmap_fragment:tp,specularmap_pars_fragment:ep,tonemapping_fragment:np,tonemapping_pars_fragment:ip,transmission_fragment:sp,transmission_pars_fragment:rp,uv_pars_fragment:ap,uv_pars_vertex:op,uv_vertex:lp,worldpos_vertex:cp,background_vert:hp,background_frag:up,backgroundCube_vert:dp,backgroundCube_frag:fp,cube_vert:pp,cube_frag:mp,depth_vert:gp,depth_frag:xp,distance_vert:vp,distance_frag:yp,equirect_vert:Sp,equirect_frag:Mp,linedashed_vert:bp,linedashed_frag:Tp,meshbasic_vert:Ep,meshbasic_frag:wp,meshlambert_vert:Ap,meshlambert_frag:Rp,meshmatcap_vert:Cp,meshmatcap_frag:_p,meshnormal_vert:Pp,meshnormal_frag:Ip,meshphong_vert:Lp,meshphong_frag:Dp,meshphysical_vert:Np,meshphysical_frag:Fp,meshtoon_vert:Up,meshtoon_frag:Op,points_vert:Bp,points_frag:zp,shadow_vert:kp,shadow_frag:Gp,sprite_vert:Vp,sprite_frag:Hp},ft={common:{diffuse:{value:new Ft(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Pt},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Pt}},envmap:{envMap:{value:null},envMapRotation:{value:new Pt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Pt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Pt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Pt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Pt},normalScale:{value:new Ht(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Pt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Pt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Pt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Pt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ft(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ft(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0},uvTransform:{value:new Pt}},sprite:{diffuse:{value:new Ft(16777215)},opacity:{value:1},center:{value:new Ht(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Pt},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0}}},Sn={basic:{uniforms:Pe([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Bt.meshbasic_vert,fragmentShader:Bt.meshbasic_frag},lambert:{uniforms:Pe([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ft(0)},envMapIntensity:{value:1}}]),vertexShader:Bt.meshlambert_vert,fragmentShader:Bt.meshlambert_frag},phong:{uniforms:Pe([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ft(0)},specular:{value:new Ft(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphong_vert,fragmentShader:Bt.meshphong_frag},standard:{uniforms:Pe([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Ft(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag},toon:{uniforms:Pe([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Ft(0)}}]),vertexShader:Bt.meshtoon_vert,fragmentShader:Bt.meshtoon_frag},matcap:{uniforms:Pe([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Bt.meshmatcap_vert,fragmentShader:Bt.meshmatcap_frag},points:{uniforms:Pe([ft.points,ft.fog]),vertexShader:Bt.points_vert,fragmentShader:Bt.points_frag},dashed:{uniforms:Pe([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Bt.linedashed_vert,fragmentShader:Bt.linedashed_frag},depth:{uniforms:Pe([ft.common,ft.displacementmap]),vertexShader:Bt.depth_vert,fragmentShader:Bt.depth_frag},normal:{uniforms:Pe([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Bt.meshnormal_vert,fragmentShader:Bt.meshnormal_frag},sprite:{uniforms:Pe([ft.sprite,ft.fog]),vertexShader:Bt.sprite_vert,fragmentShader:Bt.sprite_frag},background:{uniforms:{uvTransform:{value:new Pt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Bt.background_vert,fragmentShader:Bt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Pt}},vertexShader:Bt.backgroundCube_vert,fragmentShader:Bt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Bt.cube_vert,fragmentShader:Bt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Bt.equirect_vert,fragmentShader:Bt.equirect_frag},distance:{uniforms:Pe([ft.common,ft.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Bt.distance_vert,fragmentShader:Bt.distance_frag},shadow:{uniforms:Pe([ft.lights,ft.fog,{color:{value:new Ft(0)},opacity:{value:1}}]),vertexShader:Bt.shadow_vert,fragmentShader:Bt.shadow_frag}};Sn.physical={uniforms:Pe([Sn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Pt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Pt},clearcoatNormalScale:{value:new Ht(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Pt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Pt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Pt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Pt},sheen:{value:0},sheenColor:{value:new Ft(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Pt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Pt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Pt},transmissionSamplerSize:{value:new Ht},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Pt},attenuationDistance:{value:0},attenuationColor:{value:new Ft(0)},specularColor:{value:new Ft(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Pt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Pt},anisotropyVector:{value:new Ht},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Pt}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag};var za={r:0,b:0,g:0},Wp=new Qt,Bh=new Pt;Bh.set(-1,0,0,0,1,0,0,0,1);function Xp(i,t,e,n,s,r){let a=new Ft(0),o=s===!0?0:1,c,l,h=null,f=0,d=null;function m(M){let A=M.isScene===!0?M.background:null;if(A&&A.isTexture){let T=M.backgroundBlurriness>0;A=t.get(A,T)}return A}function g(M){let A=!1,T=m(M);T===null?p(a,o):T&&T.isColor&&(p(T,1),A=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(M,A){let T=m(A);T&&T.isCubeTexture?(l===void 0&&(l=new pe(new Dn(1,1,1),new gn({name:"BackgroundCubeMaterial",uniforms:mi(Sn.backgroundCube.uniforms),vertexShader:Sn.backgroundCube.vertexShader,fragmentShader:Sn.backgroundCube.fragmentShader,side:Ne,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,w,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=T,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Wp.makeRotationFromEuler(A.backgroundRotation)).transpose(),T.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Bh),l.material.toneMapped=Vt.getTransfer(T.colorSpace)!==Zt,(h!==T||f!==T.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=T,f=T.version,d=i.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null)):T&&T.isTexture&&(c===void 0&&(c=new pe(new hi(2,2),new gn({name:"BackgroundMaterial",uniforms:mi(Sn.background.uniforms),vertexShader:Sn.background.vertexShader,fragmentShader:Sn.background.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=T,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Vt.getTransfer(T.colorSpace)!==Zt,T.matrixAutoUpdate===!0&&T.updateMatrix(),c.material.uniforms.uvTransform.value.copy(T.matrix),(h!==T||f!==T.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=T,f=T.version,d=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function p(M,A){M.getRGB(za,dl(i)),e.buffers.color.setClear(za.r,za.g,za.b,A,r)}function u(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,A=1){a.set(M),o=A,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(M){o=M,p(a,o)},render:g,addToRenderList:S,dispose:u}}function qp(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,a=!1;function o(D,B,H,_,V){let q=!1,G=f(D,_,H,B);r!==G&&(r=G,l(r.object)),q=m(D,_,H,V),q&&g(D,_,H,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(q||a)&&(a=!1,T(D,B,H,_),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function c(){return i.createVertexArray()}function l(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function f(D,B,H,_){let V=_.wireframe===!0,q=n[B.id];q===void 0&&(q={},n[B.id]=q);let G=D.isInstancedMesh===!0?D.id:0,et=q[G];et===void 0&&(et={},q[G]=et);let X=et[H.id];X===void 0&&(X={},et[H.id]=X);let Q=X[V];return Q===void 0&&(Q=d(c()),X[V]=Q),Q}function d(D){let B=[],H=[],_=[];for(let V=0;V<e;V++)B[V]=0,H[V]=0,_[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:H,attributeDivisors:_,object:D,attributes:{},index:null}}function m(D,B,H,_){let V=r.attributes,q=B.attributes,G=0,et=H.getAttributes();for(let X in et)if(et[X].location>=0){let $=V[X],Mt=q[X];if(Mt===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(Mt=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(Mt=D.instanceColor)),$===void 0||$.attribute!==Mt||Mt&&$.data!==Mt.data)return!0;G++}return r.attributesNum!==G||r.index!==_}function g(D,B,H,_){let V={},q=B.attributes,G=0,et=H.getAttributes();for(let X in et)if(et[X].location>=0){let $=q[X];$===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&($=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&($=D.instanceColor));let Mt={};Mt.attribute=$,$&&$.data&&(Mt.data=$.data),V[X]=Mt,G++}r.attributes=V,r.attributesNum=G,r.index=_}function S(){let D=r.newAttributes;for(let B=0,H=D.length;B<H;B++)D[B]=0}function p(D){u(D,0)}function u(D,B){let H=r.newAttributes,_=r.enabledAttributes,V=r.attributeDivisors;H[D]=1,_[D]===0&&(i.enableVertexAttribArray(D),_[D]=1),V[D]!==B&&(i.vertexAttribDivisor(D,B),V[D]=B)}function M(){let D=r.newAttributes,B=r.enabledAttributes;for(let H=0,_=B.length;H<_;H++)B[H]!==D[H]&&(i.disableVertexAttribArray(H),B[H]=0)}function A(D,B,H,_,V,q,G){G===!0?i.vertexAttribIPointer(D,B,H,V,q):i.vertexAttribPointer(D,B,H,_,V,q)}function T(D,B,H,_){S();let V=_.attributes,q=H.getAttributes(),G=B.defaultAttributeValues;for(let et in q){let X=q[et];if(X.location>=0){let Q=V[et];if(Q===void 0&&(et==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),et==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let $=Q.normalized,Mt=Q.itemSize,Lt=t.get(Q);if(Lt===void 0)continue;let J=Lt.buffer,pt=Lt.type,vt=Lt.bytesPerElement,wt=pt===i.INT||pt===i.UNSIGNED_INT||Q.gpuType===na;if(Q.isInterleavedBufferAttribute){let mt=Q.data,Nt=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,le=Q.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Ct=0;Ct<X.locationSize;Ct++)u(X.location+Ct,mt.meshPerAttribute);D.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Ct=0;Ct<X.locationSize;Ct++)p(X.location+Ct);i.bindBuffer(i.ARRAY_BUFFER,J);for(let Ct=0;Ct<X.locationSize;Ct++)A(X.location+Ct,Mt/X.locationSize,pt,$,Nt*vt,(le+Mt/X.locationSize*Ct)*vt,wt)}else{if(Q.isInstancedBufferAttribute){for(let mt=0;mt<X.locationSize;mt++)u(X.location+mt,Q.meshPerAttribute);D.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let mt=0;mt<X.locationSize;mt++)p(X.location+mt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let mt=0;mt<X.locationSize;mt++)A(X.location+mt,Mt/X.locationSize,pt,$,Mt*vt,Mt/X.locationSize*mt*vt,wt)}}else if(G!==void 0){let $=G[et];if($!==void 0)switch($.length){case 2:i.vertexAttrib2fv(X.location,$);break;case 3:i.vertexAttrib3fv(X.location,$);break;case 4:i.vertexAttrib4fv(X.location,$);break;default:i.vertexAttrib1fv(X.location,$)}}}}M()}function R(){N();for(let D in n){let B=n[D];for(let H in B){let _=B[H];for(let V in _){let q=_[V];for(let G in q)h(q[G].object),delete q[G];delete _[V]}}delete n[D]}}function w(D){if(n[D.id]===void 0)return;let B=n[D.id];for(let H in B){let _=B[H];for(let V in _){let q=_[V];for(let G in q)h(q[G].object),delete q[G];delete _[V]}}delete n[D.id]}function x(D){for(let B in n){let H=n[B];for(let _ in H){let V=H[_];if(V[D.id]===void 0)continue;let q=V[D.id];for(let G in q)h(q[G].object),delete q[G];delete V[D.id]}}}function b(D){for(let B in n){let H=n[B],_=D.isInstancedMesh===!0?D.id:0,V=H[_];if(V!==void 0){for(let q in V){let G=V[q];for(let et in G)h(G[et].object),delete G[et];delete V[q]}delete H[_],Object.keys(H).length===0&&delete n[B]}}}function N(){I(),a=!0,r!==s&&(r=s,l(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:N,resetDefaultState:I,dispose:R,releaseStatesOfGeometry:w,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:S,enableAttribute:p,disableUnusedAttributes:M}}function Zp(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function a(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function o(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let m=0;m<h;m++)d+=l[m];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Yp(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==cn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let b=x===ln&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==Be&&x!==on&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Rt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Rt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Rt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),u=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),T=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:a,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:S,maxCubemapSize:p,maxAttributes:u,maxVertexUniforms:M,maxVaryings:A,maxFragmentUniforms:T,maxSamples:R,samples:w}}function Jp(i){let t=this,e=null,n=0,s=!1,r=!1,a=new rn,o=new Pt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let m=f.length!==0||d||n!==0||s;return s=d,n=f.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){e=h(f,d,0)},this.setState=function(f,d,m){let g=f.clippingPlanes,S=f.clipIntersection,p=f.clipShadows,u=i.get(f);if(!s||g===null||g.length===0||r&&!p)r?h(null):l();else{let M=r?0:n,A=M*4,T=u.clippingState||null;c.value=T,T=h(g,d,A,m);for(let R=0;R!==A;++R)T[R]=e[R];u.clippingState=T,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=M}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(f,d,m,g){let S=f!==null?f.length:0,p=null;if(S!==0){if(p=c.value,g!==!0||p===null){let u=m+S*4,M=d.matrixWorldInverse;o.getNormalMatrix(M),(p===null||p.length<u)&&(p=new Float32Array(u));for(let A=0,T=m;A!==S;++A,T+=4)a.copy(f[A]).applyMatrix4(M,o),a.normal.toArray(p,T),p[T+3]=a.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=S,t.numIntersection=0,p}}var Os=class extends He{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ds(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Dn(5,5,5),r=new gn({name:"CubemapFromEquirect",uniforms:mi(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ne,blending:ui});r.uniforms.tEquirect.value=e;let a=new pe(s,r),o=e.minFilter;return e.minFilter===Nn&&(e.minFilter=De),new ki(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(r)}},gh=256,Kp=3,jp=20,zh=256,kh=16,Qp=3,$p=new F,tm=new Ft,Ga=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ki(1,10,null),this._boxMesh=new pe(new Dn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:a=256,position:o=$p}=r,c=this._renderer;this._setSize(a);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,d=c.autoClearColor,m=c.autoClearDepth,g=c.autoClearStencil,S=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,S===null&&(t.background=c.getClearColor(tm));let p=new ki(n,s,h);return p.position.copy(o),p.update(c,t),c.autoClear=f,c.autoClearColor=d,c.autoClearDepth=m,c.autoClearStencil=g,t.background=S,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(gh,uh(t))}_fromTexture(t,e){t.mapping===fi||t.mapping===Hi?this._setSize(t.image.length===0?gh:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=xh(t,!1,!1),n=Math.log2(t)-Kp;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=xh(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===fi||t.mapping===Hi?(this._cubemapMaterial===null&&(this._cubemapMaterial=yh()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vh()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=em(),this._integrationMaterial=nm());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/kh);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-Qp)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let c=o>0?Math.log2(e)+.5*Math.log2(6/(zh*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=c,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=im());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function xh(i,t,e){return new Os(i,{minFilter:Nn,generateMipmaps:t,type:ln,colorSpace:is,depthBuffer:e})}function Bs(i,t,e){return new gn({name:i,uniforms:t,vertexShader:Bt.cube_vert,fragmentShader:e,side:Ne,blending:ui,depthTest:!1,depthWrite:!1})}function em(){return Bs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${zh}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function nm(){return Bs("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:kh}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function im(){return Bs("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${jp}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function vh(){return Bs("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function yh(){return Bs("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function sm(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?a(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===$r||m===ta)if(t.has(d)){let g=t.get(d).texture;return o(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let S=new Os(g.height);return S.fromEquirectangularTexture(i,d),t.set(d,S),d.addEventListener("dispose",l),o(S.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===$r||m===ta,S=m===fi||m===Hi;if(g||S){let p=e.get(d),u=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==u)return n===null&&(n=new Ga(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let M=d.image;return g&&M&&M.height>0||S&&M&&c(M)?(n===null&&(n=new Ga(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function o(d,m){return m===$r?d.mapping=fi:m===ta&&(d.mapping=Hi),d}function c(d){let m=0,g=6;for(let S=0;S<g;S++)d[S]!==void 0&&m++;return m===g}function l(d){let m=d.target;m.removeEventListener("dispose",l);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function rm(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&es("WebGLRenderer: "+n+" extension not supported."),s}}}function am(i,t,e,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let S=r.get(g);S&&(t.remove(S),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,S){return s[S.id]!==void 0||(S.addEventListener("dispose",o),s[S.id]=new WeakRef(S),a.register(S,S.id,S),e.memory.geometries++),S}function h(g){let S=g.attributes;for(let p in S)t.update(S[p],i.ARRAY_BUFFER)}function f(g){let S=g.index,p=g.attributes.position,u=0;if(p===void 0)return;let M=S!==null?S.array.length:p.array.length/3-1,A=p.count>=65535?hs:cs,T=new A(Math.ceil(M/3)*6,1),R=T.array;if(S!==null){let x=S.array;u=S.version;for(let b=0,N=0;b<M;b+=3){let I=x[b+0],D=x[b+1],B=x[b+2];R[N++]=I,R[N++]=D,R[N++]=D,R[N++]=B,R[N++]=B,R[N++]=I}}else{u=p.version;for(let x=0,b=0;x<M;x+=3){let N=x+0,I=x+1,D=x+2;R[b++]=N,R[b++]=I,R[b++]=I,R[b++]=D,R[b++]=D,R[b++]=N}}T.version=u;let w=r.get(g);w&&t.remove(w),r.set(g,T)}function d(g){let S=r.get(g);if(S){let p=g.index;p!==null&&S.version<p.version&&f(g)}else f(g);return r.get(g)}function m(){for(let g in s){let S=s[g].deref();S!==void 0&&c(S)}}return{get:l,update:h,getWireframeAttribute:d,dispose:m}}function om(i,t,e){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function c(f,d){i.drawElements(n,d,r,f*a),e.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,f*a,m),e.update(d,n,m))}function h(f,d,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,m);let S=0;for(let p=0;p<m;p++)S+=d[p];e.update(S,n,1)}this.setMode=s,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function lm(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:_t("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function cm(i,t,e){let n=new WeakMap,s=new se;function r(a,o,c){let l=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=h!==void 0?h.length:0,d=n.get(o);if(d===void 0||d.count!==f){let N=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();let m=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,S=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],u=o.morphAttributes.normal||[],M=o.morphAttributes.color||[],A=0;m===!0&&(A=1),g===!0&&(A=2),S===!0&&(A=3);let T=o.attributes.position.count*A,R=1;T>t.maxTextureSize&&(R=Math.ceil(T/t.maxTextureSize),T=t.maxTextureSize);let w=new Float32Array(T*R*4*f),x=new as(w,T,R,f);x.type=on,x.needsUpdate=!0;let b=A*4;for(let I=0;I<f;I++){let D=p[I],B=u[I],H=M[I],_=T*R*4*I;for(let V=0;V<D.count;V++){let q=V*b;m===!0&&(s.fromBufferAttribute(D,V),w[_+q+0]=s.x,w[_+q+1]=s.y,w[_+q+2]=s.z,w[_+q+3]=0),g===!0&&(s.fromBufferAttribute(B,V),w[_+q+4]=s.x,w[_+q+5]=s.y,w[_+q+6]=s.z,w[_+q+7]=0),S===!0&&(s.fromBufferAttribute(H,V),w[_+q+8]=s.x,w[_+q+9]=s.y,w[_+q+10]=s.z,w[_+q+11]=H.itemSize===4?s.w:1)}}d={count:f,texture:x,size:new Ht(T,R)},n.set(o,d),o.addEventListener("dispose",N)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let m=0;for(let S=0;S<l.length;S++)m+=l[S];let g=o.morphTargetsRelative?1:1-m;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function hm(i,t,e,n,s){let r=new WeakMap;function a(l){let h=s.render.frame,f=l.geometry,d=t.get(l,f);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function o(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var um={[Xo]:"LINEAR_TONE_MAPPING",[qo]:"REINHARD_TONE_MAPPING",[Zo]:"CINEON_TONE_MAPPING",[Yo]:"ACES_FILMIC_TONE_MAPPING",[Ko]:"AGX_TONE_MAPPING",[jo]:"NEUTRAL_TONE_MAPPING",[Jo]:"CUSTOM_TONE_MAPPING"};function dm(i,t,e,n,s,r){let a=new He(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,c=null,l=null,h=new _e;h.setAttribute("position",new te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new te([0,2,0,0,2,0],2));let f=new Or({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new pe(h,f),m=new Ts(-1,1,1,-1,0,1),g=null,S=null,p=!1,u,M=null,A=[],T=!1;this.setSize=function(R,w){a.setSize(R,w),o!==null&&o.setSize(R,w),c!==null&&c.setSize(R,w);for(let x=0;x<A.length;x++){let b=A[x];b.setSize&&b.setSize(R,w)}},this.setEffects=function(R){A=R,T=A.length>0&&A[0].isRenderPass===!0;let w=a.width,x=a.height;A.length>0&&o===null&&(o=new He(w,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}),c=new He(w,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(N=>N.needsDepthTexture===!0);b!==(a.depthTexture!==null)&&(b===!0&&l===null&&(l=new Ln(w,x),r===!0&&(l.format=Fn,l.type=pi)),a.dispose(),a.depthTexture=b?l:null,a.resolveDepthBuffer=b,a.storeMultisampledDepthBuffer=b);for(let N=0;N<A.length;N++){let I=A[N];I.setSize&&I.setSize(w,x),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(l)}},this.begin=function(R,w){if(p||R.toneMapping===vn&&A.length===0)return!1;if(M=w,w!==null){let x=w.width,b=w.height;(a.width!==x||a.height!==b)&&this.setSize(x,b)}return T===!1&&R.setRenderTarget(a),u=R.toneMapping,R.toneMapping=vn,!0},this.hasRenderPass=function(){return T},this.end=function(R,w){R.toneMapping=u,p=!0;let x=a,b=o;for(let N=0;N<A.length;N++){let I=A[N];I.enabled!==!1&&(I.render(R,b,x,w),I.needsSwap!==!1&&(x=b,b=b===o?c:o))}if(g!==R.outputColorSpace||S!==R.toneMapping){g=R.outputColorSpace,S=R.toneMapping,f.defines={},Vt.getTransfer(g)===Zt&&(f.defines.SRGB_TRANSFER="");let N=um[S];N&&(f.defines[N]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(M),R.render(d,m),M=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var Gh=new Oe,Vh=new Ln(1,1),Hh=new fs(1),Wh=new as,Xh=new Lr,qh=new ds,Sh=[],Mh=[],bh=new Float32Array(16),Th=new Float32Array(9),Eh=new Float32Array(4);function qi(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Sh[s];if(r===void 0&&(r=new Float32Array(s),Sh[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function me(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function ge(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Ha(i,t){let e=Mh[t];e===void 0&&(e=new Int32Array(t),Mh[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function fm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function pm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2fv(this.addr,t),ge(e,t)}}function mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(me(e,t))return;i.uniform3fv(this.addr,t),ge(e,t)}}function gm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4fv(this.addr,t),ge(e,t)}}function xm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;Eh.set(n),i.uniformMatrix2fv(this.addr,!1,Eh),ge(e,n)}}function vm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;Th.set(n),i.uniformMatrix3fv(this.addr,!1,Th),ge(e,n)}}function ym(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;bh.set(n),i.uniformMatrix4fv(this.addr,!1,bh),ge(e,n)}}function Sm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2iv(this.addr,t),ge(e,t)}}function bm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3iv(this.addr,t),ge(e,t)}}function Tm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4iv(this.addr,t),ge(e,t)}}function Em(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function wm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2uiv(this.addr,t),ge(e,t)}}function Am(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3uiv(this.addr,t),ge(e,t)}}function Rm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4uiv(this.addr,t),ge(e,t)}}function Wa(i){return i.version===0&&(i.compareFunction=ll,i.needsUpdate=!0),i}function Cm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Wa(Vh):r=Gh,e.setTexture2D(t||r,s)}function _m(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Xh,s)}function Pm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Wa(Hh):r=qh,e.setTextureCube(t||r,s)}function Im(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Wh,s)}function Lm(i){switch(i){case 5126:return fm;case 35664:return pm;case 35665:return mm;case 35666:return gm;case 35674:return xm;case 35675:return vm;case 35676:return ym;case 5124:case 35670:return Sm;case 35667:case 35671:return Mm;case 35668:case 35672:return bm;case 35669:case 35673:return Tm;case 5125:return Em;case 36294:return wm;case 36295:return Am;case 36296:return Rm;case 35678:case 36198:case 36298:case 36306:case 35682:return Cm;case 35679:case 36299:case 36307:return _m;case 35680:case 36300:case 36308:case 36293:return Pm;case 36289:case 36303:case 36311:case 36292:return Im}}function Dm(i,t){i.uniform1fv(this.addr,t)}function Nm(i,t){let e=qi(t,this.size,2);i.uniform2fv(this.addr,e)}function Fm(i,t){let e=qi(t,this.size,3);i.uniform3fv(this.addr,e)}function Um(i,t){let e=qi(t,this.size,4);i.uniform4fv(this.addr,e)}function Om(i,t){let e=qi(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Bm(i,t){let e=qi(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function zm(i,t){let e=qi(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function km(i,t){i.uniform1iv(this.addr,t)}function Gm(i,t){i.uniform2iv(this.addr,t)}function Vm(i,t){i.uniform3iv(this.addr,t)}function Hm(i,t){i.uniform4iv(this.addr,t)}function Wm(i,t){i.uniform1uiv(this.addr,t)}function Xm(i,t){i.uniform2uiv(this.addr,t)}function qm(i,t){i.uniform3uiv(this.addr,t)}function Zm(i,t){i.uniform4uiv(this.addr,t)}function Ym(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Wa(Vh):a=Gh;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function Jm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||Xh,r[a])}function Km(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Wa(Hh):a=qh;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function jm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||Wh,r[a])}function Qm(i){switch(i){case 5126:return Dm;case 35664:return Nm;case 35665:return Fm;case 35666:return Um;case 35674:return Om;case 35675:return Bm;case 35676:return zm;case 5124:case 35670:return km;case 35667:case 35671:return Gm;case 35668:case 35672:return Vm;case 35669:case 35673:return Hm;case 5125:return Wm;case 36294:return Xm;case 36295:return qm;case 36296:return Zm;case 35678:case 36198:case 36298:case 36306:case 35682:return Ym;case 35679:case 36299:case 36307:return Jm;case 35680:case 36300:case 36308:case 36293:return Km;case 36289:case 36303:case 36311:case 36292:return jm}}var vl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Lm(e.type)}},yl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Qm(e.type)}},Sl=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],n)}}},gl=/(\w+)(\])?(\[|\.)?/g;function wh(i,t){i.seq.push(t),i.map[t.id]=t}function $m(i,t,e){let n=i.name,s=n.length;for(gl.lastIndex=0;;){let r=gl.exec(n),a=gl.lastIndex,o=r[1],c=r[2]==="]",l=r[3];if(c&&(o=o|0),l===void 0||l==="["&&a+2===s){wh(e,l===void 0?new vl(o,i,t):new yl(o,i,t));break}else{let f=e.map[o];f===void 0&&(f=new Sl(o),wh(e,f)),e=f}}}var Xi=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=t.getActiveUniform(e,a),c=t.getUniformLocation(e,o.name);$m(o,c,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],c=n[o.id];c.needsUpdate!==!1&&o.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&n.push(a)}return n}};function Ah(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var tg=37297,eg=0;function ng(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}var Rh=new Pt;function ig(i){Vt._getMatrix(Rh,Vt.workingColorSpace,i);let t=`mat3( ${Rh.elements.map(e=>e.toFixed(4))} )`;switch(Vt.getTransfer(i)){case ss:return[t,"LinearTransferOETF"];case Zt:return[t,"sRGBTransferOETF"];default:return Rt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Ch(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+ng(i.getShaderSource(t),o)}else return r}function sg(i,t){let e=ig(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rg={[Xo]:"Linear",[qo]:"Reinhard",[Zo]:"Cineon",[Yo]:"ACESFilmic",[Ko]:"AgX",[jo]:"Neutral",[Jo]:"Custom"};function ag(i,t){let e=rg[t];return e===void 0?(Rt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ka=new F;function og(){Vt.getLuminanceCoefficients(ka);let i=ka.x.toFixed(4),t=ka.y.toFixed(4),e=ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lg(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Us).join(`
`)}function cg(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function hg(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function Us(i){return i!==""}function _h(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Ph(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var ug=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ml(i){return i.replace(ug,dg)}function dg(i,t){let e=Bt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Ml(e)}var fg=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ih(i){return i.replace(fg,pg)}function pg(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Lh(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var mg={[As]:"SHADOWMAP_TYPE_PCF",[Gi]:"SHADOWMAP_TYPE_VSM"};function gg(i){return mg[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var xg={[Hi]:"ENVMAP_MODE_REFRACTION"};function vg(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":xg[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yg={[Qr]:"ENVMAP_BLENDING_MULTIPLY",[Jc]:"ENVMAP_BLENDING_MIX",[Kc]:"ENVMAP_BLENDING_ADD"};function Sg(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":yg[i.combine]||"ENVMAP_BLENDING_NONE"}function Mg(i,t,e,n){let s=i.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,c=gg(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=vg(e),f=Sg(e),d=lg(e),m=cg(r),g=s.createProgram(),S,p,u=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(S=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Us).join(`
`),S.length>0&&(S+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Us).join(`
`),p.length>0&&(p+=`
`)):(S=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Us).join(`
`),p=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==vn?"#define TONE_MAPPING":"",e.toneMapping!==vn?Bt.tonemapping_pars_fragment:"",e.toneMapping!==vn?ag("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Bt.colorspace_pars_fragment,sg("linearToOutputTexel",e.outputColorSpace),og(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Us).join(`
`)),a=Ml(a),a=_h(a,e),a=Ph(a,e),o=Ml(o),o=_h(o,e),o=Ph(o,e),a=Ih(a),o=Ih(o),e.isRawShaderMaterial!==!0&&(u=`#version 300 es
`,S=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,p=["#define varying in",e.glslVersion===cl?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===cl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let M=u+S+a,A=u+p+o,T=Ah(s,s.VERTEX_SHADER,M),R=Ah(s,s.FRAGMENT_SHADER,A);s.attachShader(g,T),s.attachShader(g,R),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function w(I){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(T)||"",H=s.getShaderInfoLog(R)||"",_=D.trim(),V=B.trim(),q=H.trim(),G=!0,et=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,T,R);else{let X=Ch(s,T,"vertex"),Q=Ch(s,R,"fragment");_t("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+_+`
`+X+`
`+Q)}else _!==""?Rt("WebGLProgram: Program Info Log:",_):(V===""||q==="")&&(et=!1);et&&(I.diagnostics={runnable:G,programLog:_,vertexShader:{log:V,prefix:S},fragmentShader:{log:q,prefix:p}})}s.deleteShader(T),s.deleteShader(R),x=new Xi(s,g),b=hg(s,g)}let x;this.getUniforms=function(){return x===void 0&&w(this),x};let b;this.getAttributes=function(){return b===void 0&&w(this),b};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(g,tg)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=eg++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=T,this.fragmentShader=R,this}var bg=0,bl=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Tl(t),e.set(t,n)),n}},Tl=class{constructor(t){this.id=bg++,this.code=t,this.usedTimes=0}};function Tg(i){return i===$n||i===Ls||i===Ds}function Eg(i,t,e,n,s,r){let a=new os,o=new bl,c=new Set,l=[],h=new Map,f=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,b,N,I,D,B){let H=I.fog,_=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=t.get(x.envMap||V,q),et=d[x.type],X=n.precision;x.precision!==null&&(X=n.getMaxPrecision(x.precision),X!==x.precision&&Rt("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let Q=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,$=Q!==void 0?Q.length:0,Mt=0;_.morphAttributes.position!==void 0&&(Mt=1),_.morphAttributes.normal!==void 0&&(Mt=2),_.morphAttributes.color!==void 0&&(Mt=3);let Lt,J,pt,vt;if(et){let dt=Sn[et];Lt=dt.vertexShader,J=dt.fragmentShader}else{Lt=x.vertexShader,J=x.fragmentShader;let dt=o.getVertexShaderStage(x),Jt=o.getFragmentShaderStage(x);o.update(x,dt,Jt),pt=dt.id,vt=Jt.id}let wt=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),Nt=D.isInstancedMesh===!0,le=D.isBatchedMesh===!0,Ct=!!x.map,Yt=!!x.matcap,Kt=!!G,zt=Kt&&G.isPMREMTexture===!0,be=!!x.aoMap,de=!!x.lightMap,Ue=!!x.bumpMap&&x.wireframe===!1,re=!!x.normalMap,un=!!x.displacementMap,xe=!!x.emissiveMap,qe=!!x.metalnessMap,Ze=!!x.roughnessMap,Ye=x.anisotropy>0,L=x.clearcoat>0,Je=x.diffuseRoughness>0,ne=x.dispersion>0,ie=x.retroreflectivity>0,ut=x.iridescence>0,fe=x.sheen>0,At=x.transmission>0,It=Ye&&!!x.anisotropyMap,E=L&&!!x.clearcoatMap,v=L&&!!x.clearcoatNormalMap,O=L&&!!x.clearcoatRoughnessMap,tt=Je&&!!x.diffuseRoughnessMap,j=ut&&!!x.iridescenceMap,st=ut&&!!x.iridescenceThicknessMap,ct=fe&&!!x.sheenColorMap,Z=fe&&!!x.sheenRoughnessMap,Y=!!x.specularMap,at=!!x.specularColorMap,C=!!x.specularIntensityMap,K=At&&!!x.transmissionMap,W=At&&!!x.thicknessMap,ot=!!x.gradientMap,it=!!x.alphaMap,rt=x.alphaTest>0,Tt=!!x.alphaHash,Ot=!!x.extensions,nt=vn;x.toneMapped&&(wt===null||wt.isXRRenderTarget===!0)&&(nt=i.toneMapping);let Et=zt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Ut={shaderID:et,shaderType:x.type,shaderName:x.name,vertexShader:Lt,fragmentShader:J,defines:x.defines,customVertexShaderID:pt,customFragmentShaderID:vt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:le,batchingColor:le&&D._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&D.instanceColor!==null,instancingMorph:Nt&&D.morphTexture!==null,outputColorSpace:wt===null?i.outputColorSpace:wt.isXRRenderTarget===!0?wt.texture.colorSpace:Vt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ct,matcap:Yt,envMap:Kt,envMapMode:Kt&&G.mapping,envMapPMREM:zt,envMapMaxLod:zt?Et.length-1:null,envMapSize:zt?Et[0].width:null,aoMap:be,lightMap:de,bumpMap:Ue,normalMap:re,displacementMap:un,emissiveMap:xe,normalMapObjectSpace:re&&x.normalMapType===$c,normalMapTangentSpace:re&&x.normalMapType===Ba,packedNormalMap:re&&x.normalMapType===Ba&&Tg(x.normalMap.format),metalnessMap:qe,roughnessMap:Ze,anisotropy:Ye,anisotropyMap:It,clearcoat:L,clearcoatMap:E,clearcoatNormalMap:v,clearcoatRoughnessMap:O,diffuseRoughness:Je,diffuseRoughnessMap:tt,dispersion:ne,retroreflection:ie,iridescence:ut,iridescenceMap:j,iridescenceThicknessMap:st,sheen:fe,sheenColorMap:ct,sheenRoughnessMap:Z,specularMap:Y,specularColorMap:at,specularIntensityMap:C,transmission:At,transmissionMap:K,thicknessMap:W,gradientMap:ot,opaque:x.transparent===!1&&x.blending===Vi&&x.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:Tt,combine:x.combine,mapUv:Ct&&m(x.map.channel),aoMapUv:be&&m(x.aoMap.channel),lightMapUv:de&&m(x.lightMap.channel),bumpMapUv:Ue&&m(x.bumpMap.channel),normalMapUv:re&&m(x.normalMap.channel),displacementMapUv:un&&m(x.displacementMap.channel),emissiveMapUv:xe&&m(x.emissiveMap.channel),metalnessMapUv:qe&&m(x.metalnessMap.channel),roughnessMapUv:Ze&&m(x.roughnessMap.channel),anisotropyMapUv:It&&m(x.anisotropyMap.channel),clearcoatMapUv:E&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:j&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:st&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:Z&&m(x.sheenRoughnessMap.channel),specularMapUv:Y&&m(x.specularMap.channel),specularColorMapUv:at&&m(x.specularColorMap.channel),specularIntensityMapUv:C&&m(x.specularIntensityMap.channel),transmissionMapUv:K&&m(x.transmissionMap.channel),thicknessMapUv:W&&m(x.thicknessMap.channel),alphaMapUv:it&&m(x.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(re||Ye),vertexNormals:!!_.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!_.attributes.uv&&(Ct||it),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||_.attributes.normal===void 0&&re===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:mt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:Mt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(dt=>dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Ct&&x.map.isVideoTexture===!0&&Vt.getTransfer(x.map.colorSpace)===Zt,decodeVideoTextureEmissive:xe&&x.emissiveMap.isVideoTexture===!0&&Vt.getTransfer(x.emissiveMap.colorSpace)===Zt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===xn,flipSided:x.side===Ne,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ot&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ot&&x.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Ut.vertexUv1s=c.has(1),Ut.vertexUv2s=c.has(2),Ut.vertexUv3s=c.has(3),c.clear(),Ut}function S(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let N in x.defines)b.push(N),b.push(x.defines[N]);return x.isRawShaderMaterial===!1&&(p(b,x),u(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function p(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function u(x,b){a.disableAll(),b.instancing&&a.enable(0),b.instancingColor&&a.enable(1),b.instancingMorph&&a.enable(2),b.matcap&&a.enable(3),b.envMap&&a.enable(4),b.normalMapObjectSpace&&a.enable(5),b.normalMapTangentSpace&&a.enable(6),b.clearcoat&&a.enable(7),b.iridescence&&a.enable(8),b.alphaTest&&a.enable(9),b.vertexColors&&a.enable(10),b.vertexAlphas&&a.enable(11),b.vertexUv1s&&a.enable(12),b.vertexUv2s&&a.enable(13),b.vertexUv3s&&a.enable(14),b.vertexTangents&&a.enable(15),b.anisotropy&&a.enable(16),b.alphaHash&&a.enable(17),b.batching&&a.enable(18),b.dispersion&&a.enable(19),b.retroreflection&&a.enable(24),b.diffuseRoughness&&a.enable(25),b.batchingColor&&a.enable(20),b.gradientMap&&a.enable(21),b.packedNormalMap&&a.enable(22),b.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),b.numLightProbeGrids>0&&a.enable(22),b.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function M(x){let b=d[x.type],N;if(b){let I=Sn[b];N=fh.clone(I.uniforms)}else N=x.uniforms;return N}function A(x,b){let N=h.get(b);return N!==void 0?++N.usedTimes:(N=new Mg(i,b,x,s),l.push(N),h.set(b,N)),N}function T(x){if(--x.usedTimes===0){let b=l.indexOf(x);l[b]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function R(x){o.remove(x)}function w(){o.dispose()}return{getParameters:g,getProgramCacheKey:S,getUniforms:M,acquireProgram:A,releaseProgram:T,releaseShaderCache:R,programs:l,dispose:w}}function wg(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,c){i.get(a)[o]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Ag(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Dh(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Nh(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function o(d,m,g,S,p,u){let M=i[t];return M===void 0?(M={id:d.id,object:d,geometry:m,material:g,materialVariant:a(d),groupOrder:S,renderOrder:d.renderOrder,z:p,group:u},i[t]=M):(M.id=d.id,M.object=d,M.geometry=m,M.material=g,M.materialVariant=a(d),M.groupOrder=S,M.renderOrder=d.renderOrder,M.z=p,M.group=u),t++,M}function c(d,m,g,S,p,u,M){M.reversedDepth===!0&&(p=-p);let A=o(d,m,g,S,p,u);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):e.push(A)}function l(d,m,g,S,p,u){let M=o(d,m,g,S,p,u);g.transmission>0?n.unshift(M):g.transparent===!0?s.unshift(M):e.unshift(M)}function h(d,m){e.length>1&&e.sort(d||Ag),n.length>1&&n.sort(m||Dh),s.length>1&&s.sort(m||Dh)}function f(){for(let d=t,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:f,sort:h}}function Rg(){let i=new WeakMap;function t(n,s){let r=i.get(n),a;return r===void 0?(a=new Nh,i.set(n,[a])):s>=r.length?(a=new Nh,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function Cg(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new F,color:new Ft};break;case"SpotLight":e={position:new F,direction:new F,color:new Ft,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new F,color:new Ft,distance:0,decay:0};break;case"HemisphereLight":e={direction:new F,skyColor:new Ft,groundColor:new Ft};break;case"RectAreaLight":e={color:new Ft,position:new F,halfWidth:new F,halfHeight:new F};break}return i[t.id]=e,e}}}function _g(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Pg=0;function Ig(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Lg(i){let t=new Cg,e=_g(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new F);let s=new F,r=new Qt,a=new Qt;function o(l){let h=0,f=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let m=0,g=0,S=0,p=0,u=0,M=0,A=0,T=0,R=0,w=0,x=0,b=0,N=0,I=0;l.sort(Ig);for(let B=0,H=l.length;B<H;B++){let _=l[B],V=_.color,q=_.intensity,G=_.distance,et=null;if(_.shadow&&_.shadow.map&&(_.shadow.map.texture.format===$n?et=_.shadow.map.texture:et=_.shadow.map.depthTexture||_.shadow.map.texture),_.isAmbientLight)h+=V.r*q,f+=V.g*q,d+=V.b*q;else if(_.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(_.sh.coefficients[X],q);I++}else if(_.isSunLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=$,n.sunShadowMap[g]=et;let Mt=Q.getViewportCount();for(let Lt=0;Lt<Mt;Lt++)n.sunShadowMatrix[S+Lt]=Q.getMatrix(Lt),n.sunShadowCascade[S+Lt]=Q._cascadeData[Lt];S+=Mt,g++}n.sun[m]=X,m++}else if(_.isDirectionalLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.directionalShadow[p]=$,n.directionalShadowMap[p]=et,n.directionalShadowMatrix[p]=_.shadow.matrix,R++}n.directional[p]=X,p++}else if(_.isSpotLight){let X=t.get(_);X.position.setFromMatrixPosition(_.matrixWorld),X.color.copy(V).multiplyScalar(q),X.distance=G,X.coneCos=Math.cos(_.angle),X.penumbraCos=Math.cos(_.angle*(1-_.penumbra)),X.decay=_.decay,n.spot[M]=X;let Q=_.shadow;if(_.map&&(n.spotLightMap[b]=_.map,b++,Q.updateMatrices(_),_.castShadow&&N++),n.spotLightMatrix[M]=Q.matrix,_.castShadow){let $=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.spotShadow[M]=$,n.spotShadowMap[M]=et,x++}M++}else if(_.isRectAreaLight){let X=t.get(_);X.color.copy(V).multiplyScalar(q),X.halfWidth.set(_.width*.5,0,0),X.halfHeight.set(0,_.height*.5,0),n.rectArea[A]=X,A++}else if(_.isPointLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),X.distance=_.distance,X.decay=_.decay,_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,$.shadowCameraNear=Q.camera.near,$.shadowCameraFar=Q.camera.far,n.pointShadow[u]=$,n.pointShadowMap[u]=et,n.pointShadowMatrix[u]=_.shadow.matrix,w++}n.point[u]=X,u++}else if(_.isHemisphereLight){let X=t.get(_);X.skyColor.copy(_.color).multiplyScalar(q),X.groundColor.copy(_.groundColor).multiplyScalar(q),n.hemi[T]=X,T++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=d;let D=n.hash;(D.sunLength!==m||D.directionalLength!==p||D.pointLength!==u||D.spotLength!==M||D.rectAreaLength!==A||D.hemiLength!==T||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==w||D.numSpotShadows!==x||D.numSpotMaps!==b||D.numLightProbes!==I)&&(n.sun.length=m,n.directional.length=p,n.spot.length=M,n.rectArea.length=A,n.point.length=u,n.hemi.length=T,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-N,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=I,D.sunLength=m,D.directionalLength=p,D.pointLength=u,D.spotLength=M,D.rectAreaLength=A,D.hemiLength=T,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=w,D.numSpotShadows=x,D.numSpotMaps=b,D.numLightProbes=I,n.version=Pg++)}function c(l,h){let f=0,d=0,m=0,g=0,S=0,p=0,u=h.matrixWorldInverse;for(let M=0,A=l.length;M<A;M++){let T=l[M];if(T.isSunLight){let R=n.sun[f];R.direction.setFromMatrixPosition(T.matrixWorld),R.direction.transformDirection(u),f++}else if(T.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(u),d++}else if(T.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(u),R.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(u),g++}else if(T.isRectAreaLight){let R=n.rectArea[S];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(u),a.identity(),r.copy(T.matrixWorld),r.premultiply(u),a.extractRotation(r),R.halfWidth.set(T.width*.5,0,0),R.halfHeight.set(0,T.height*.5,0),R.halfWidth.applyMatrix4(a),R.halfHeight.applyMatrix4(a),S++}else if(T.isPointLight){let R=n.point[m];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(u),m++}else if(T.isHemisphereLight){let R=n.hemi[p];R.direction.setFromMatrixPosition(T.matrixWorld),R.direction.transformDirection(u),p++}}}return{setup:o,setupView:c,state:n}}function Fh(i){let t=new Lg(i),e=[],n=[],s=[];function r(f){h.camera=f,e.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):e.push(f)}function o(f){n.push(f)}function c(){t.setup(e),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function l(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:a,pushShadow:o}}function Dg(i){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new Fh(i),t.set(s,[o])):r>=a.length?(o=new Fh(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}var Ng=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Fg=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Ug=[new F(1,0,0),new F(-1,0,0),new F(0,1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1)],Og=[new F(0,-1,0),new F(0,-1,0),new F(0,0,1),new F(0,0,-1),new F(0,-1,0),new F(0,-1,0)],Uh=new Qt,Fs=new F,xl=new F;function Bg(i,t,e){let n=new Zn,s=new Ht,r=new Ht,a=new se,o=new Br,c=new zr,l={},h=e.maxTextureSize,f={[Qn]:Ne,[Ne]:Qn,[xn]:xn},d=new gn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ht},radius:{value:4}},vertexShader:Ng,fragmentShader:Fg}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new _e;g.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new pe(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=As;let u=this.type;this.render=function(w,x,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===Pc&&(Rt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=As);let N=i.getRenderTarget(),I=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ui),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let H=u!==this.type;H&&x.traverse(function(_){_.material&&(Array.isArray(_.material)?_.material.forEach(V=>V.needsUpdate=!0):_.material.needsUpdate=!0)});for(let _=0,V=w.length;_<V;_++){let q=w[_],G=q.shadow;if(G===void 0){Rt("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let et=G.getFrameExtents();s.multiply(et),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,G.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||H===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Gi){if(q.isPointLight){Rt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new He(s.x,s.y,{format:$n,type:ln,minFilter:De,magFilter:De,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new Ln(s.x,s.y,on),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=_n,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Me,G.map.depthTexture.magFilter=Me}else q.isPointLight?(G.map=new Os(s.x),G.map.depthTexture=new fs(s.x,an)):(G.map=new He(s.x,s.y),G.map.depthTexture=new Ln(s.x,s.y,an)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=_n,this.type===As?(G.map.depthTexture.compareFunction=X?ol:al,G.map.depthTexture.minFilter=De,G.map.depthTexture.magFilter=De):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Me,G.map.depthTexture.magFilter=Me);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,b);let $=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:b.layers;for(let Mt=0;Mt<Q;Mt++){let Lt=G.getCamera(Mt);if(q.isPointLight){let J=G.camera,pt=G.matrix,vt=q.distance||J.far;vt!==J.far&&(J.far=vt,J.updateProjectionMatrix()),Fs.setFromMatrixPosition(q.matrixWorld),J.position.copy(Fs),xl.copy(J.position),xl.add(Ug[Mt]),J.up.copy(Og[Mt]),J.lookAt(xl),J.updateMatrixWorld(),pt.makeTranslation(-Fs.x,-Fs.y,-Fs.z),Uh.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Uh,J.coordinateSystem,J.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,Mt),i.clear();else{Mt===0&&(i.setRenderTarget(G.map),i.clear());let J=G.getViewport(Mt);a.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),B.viewport(a)}n=G.getFrustum(Mt),T(x,b,Lt,q,$,this.type)}G.isPointLightShadow!==!0&&this.type===Gi&&M(G,b),G.needsUpdate=!1}u=this.type,p.needsUpdate=!1,i.setRenderTarget(N,I,D)};function M(w,x){let b=t.update(S);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,m.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),w.mapPass===null?w.mapPass=new He(s.x,s.y,{format:$n,type:ln}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(x,null,b,d,S,null),m.uniforms.shadow_pass.value=w.mapPass.texture,m.uniforms.resolution.value.set(w.map.width,w.map.height),m.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(x,null,b,m,S,null)}function A(w,x,b,N){let I=null,D=b.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(D!==void 0)I=D;else if(I=b.isPointLight===!0?c:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=I.uuid,H=x.uuid,_=l[B];_===void 0&&(_={},l[B]=_);let V=_[H];V===void 0&&(V=I.clone(),_[H]=V,x.addEventListener("dispose",R)),I=V}if(I.visible=x.visible,I.wireframe=x.wireframe,N===Gi?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:f[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=i.properties.get(I);B.light=b}return I}function T(w,x,b,N,I,D){if(w.visible===!1)return;if(w.layers.test(I)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&D===Gi)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,w.matrixWorld);let _=t.update(w),V=w.material;if(Array.isArray(V)){let q=_.groups;for(let G=0,et=q.length;G<et;G++){let X=q[G],Q=V[X.materialIndex];if(Q&&Q.visible){let $=A(w,Q,N,D);w.onBeforeShadow(i,w,x,b,_,$,X),i.renderBufferDirect(b,null,_,$,w,X),w.onAfterShadow(i,w,x,b,_,$,X)}}}else if(V.visible){let q=A(w,V,N,D);w.onBeforeShadow(i,w,x,b,_,q,null),i.renderBufferDirect(b,null,_,q,w,null),w.onAfterShadow(i,w,x,b,_,q,null)}}let H=w.children;for(let _=0,V=H.length;_<V;_++)T(H[_],x,b,N,I,D)}function R(w){w.target.removeEventListener("dispose",R);for(let b in l){let N=l[b],I=w.target.uuid;I in N&&(N[I].dispose(),delete N[I])}}}function zg(i,t){function e(){let C=!1,K=new se,W=null,ot=new se(0,0,0,0);return{setMask:function(it){W!==it&&!C&&(i.colorMask(it,it,it,it),W=it)},setLocked:function(it){C=it},setClear:function(it,rt,Tt,Ot,nt){nt===!0&&(it*=Ot,rt*=Ot,Tt*=Ot),K.set(it,rt,Tt,Ot),ot.equals(K)===!1&&(i.clearColor(it,rt,Tt,Ot),ot.copy(K))},reset:function(){C=!1,W=null,ot.set(-1,0,0,0)}}}function n(){let C=!1,K=!1,W=null,ot=null,it=null;return{setReversed:function(rt){if(K!==rt){let Tt=t.get("EXT_clip_control");rt?Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.ZERO_TO_ONE_EXT):Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.NEGATIVE_ONE_TO_ONE_EXT),K=rt;let Ot=it;it=null,this.setClear(Ot)}},getReversed:function(){return K},setTest:function(rt){rt?mt(i.DEPTH_TEST):Nt(i.DEPTH_TEST)},setMask:function(rt){W!==rt&&!C&&(i.depthMask(rt),W=rt)},setFunc:function(rt){if(K&&(rt=hh[rt]),ot!==rt){switch(rt){case yr:i.depthFunc(i.NEVER);break;case Sr:i.depthFunc(i.ALWAYS);break;case Mr:i.depthFunc(i.LESS);break;case Ii:i.depthFunc(i.LEQUAL);break;case br:i.depthFunc(i.EQUAL);break;case Tr:i.depthFunc(i.GEQUAL);break;case Er:i.depthFunc(i.GREATER);break;case wr:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ot=rt}},setLocked:function(rt){C=rt},setClear:function(rt){it!==rt&&(it=rt,K&&(rt=1-rt),i.clearDepth(rt))},reset:function(){C=!1,W=null,ot=null,it=null,K=!1}}}function s(){let C=!1,K=null,W=null,ot=null,it=null,rt=null,Tt=null,Ot=null,nt=null;return{setTest:function(Et){C||(Et?mt(i.STENCIL_TEST):Nt(i.STENCIL_TEST))},setMask:function(Et){K!==Et&&!C&&(i.stencilMask(Et),K=Et)},setFunc:function(Et,Ut,dt){(W!==Et||ot!==Ut||it!==dt)&&(i.stencilFunc(Et,Ut,dt),W=Et,ot=Ut,it=dt)},setOp:function(Et,Ut,dt){(rt!==Et||Tt!==Ut||Ot!==dt)&&(i.stencilOp(Et,Ut,dt),rt=Et,Tt=Ut,Ot=dt)},setLocked:function(Et){C=Et},setClear:function(Et){nt!==Et&&(i.clearStencil(Et),nt=Et)},reset:function(){C=!1,K=null,W=null,ot=null,it=null,rt=null,Tt=null,Ot=null,nt=null}}}let r=new e,a=new n,o=new s,c={},l=new WeakMap,h={},f={},d={},m=new WeakMap,g=[],S=null,p=!1,u=null,M=null,A=null,T=null,R=null,w=null,x=null,b=new Ft(0,0,0),N=0,I=!1,D=null,B=null,H=null,_=null,V=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,et=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=et>=1):X.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=et>=2);let Q=null,$={},Mt=i.getParameter(i.SCISSOR_BOX),Lt=i.getParameter(i.VIEWPORT),J=new se().fromArray(Mt),pt=new se().fromArray(Lt);function vt(C,K,W,ot){let it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(C,rt),i.texParameteri(C,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(C,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Tt=0;Tt<W;Tt++)C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,ot,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+Tt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}let wt={};wt[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),wt[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),wt[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),wt[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),mt(i.DEPTH_TEST),a.setFunc(Ii),Ue(!1),re(zo),mt(i.CULL_FACE),be(ui);function mt(C){h[C]!==!0&&(i.enable(C),h[C]=!0)}function Nt(C){h[C]!==!1&&(i.disable(C),h[C]=!1)}function le(C,K){return d[C]!==K?(i.bindFramebuffer(C,K),d[C]=K,C===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),C===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Ct(C,K){let W=g,ot=!1;if(C){W=m.get(K),W===void 0&&(W=[],m.set(K,W));let it=C.textures;if(W.length!==it.length||W[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,Tt=it.length;rt<Tt;rt++)W[rt]=i.COLOR_ATTACHMENT0+rt;W.length=it.length,ot=!0}}else W[0]!==i.BACK&&(W[0]=i.BACK,ot=!0);ot&&i.drawBuffers(W)}function Yt(C){return S!==C?(i.useProgram(C),S=C,!0):!1}let Kt={[di]:i.FUNC_ADD,[Lc]:i.FUNC_SUBTRACT,[Dc]:i.FUNC_REVERSE_SUBTRACT};Kt[Nc]=i.MIN,Kt[Fc]=i.MAX;let zt={[Uc]:i.ZERO,[Oc]:i.ONE,[Bc]:i.SRC_COLOR,[Ho]:i.SRC_ALPHA,[Wc]:i.SRC_ALPHA_SATURATE,[Vc]:i.DST_COLOR,[kc]:i.DST_ALPHA,[zc]:i.ONE_MINUS_SRC_COLOR,[Wo]:i.ONE_MINUS_SRC_ALPHA,[Hc]:i.ONE_MINUS_DST_COLOR,[Gc]:i.ONE_MINUS_DST_ALPHA,[Xc]:i.CONSTANT_COLOR,[qc]:i.ONE_MINUS_CONSTANT_COLOR,[Zc]:i.CONSTANT_ALPHA,[Yc]:i.ONE_MINUS_CONSTANT_ALPHA};function be(C,K,W,ot,it,rt,Tt,Ot,nt,Et){if(C===ui){p===!0&&(Nt(i.BLEND),p=!1);return}if(p===!1&&(mt(i.BLEND),p=!0),C!==Ic){if(C!==u||Et!==I){if((M!==di||R!==di)&&(i.blendEquation(i.FUNC_ADD),M=di,R=di),Et)switch(C){case Vi:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFunc(i.ONE,i.ONE);break;case Go:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Vo:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:_t("WebGLState: Invalid blending: ",C);break}else switch(C){case Vi:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Go:_t("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vo:_t("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:_t("WebGLState: Invalid blending: ",C);break}A=null,T=null,w=null,x=null,b.set(0,0,0),N=0,u=C,I=Et}return}it=it||K,rt=rt||W,Tt=Tt||ot,(K!==M||it!==R)&&(i.blendEquationSeparate(Kt[K],Kt[it]),M=K,R=it),(W!==A||ot!==T||rt!==w||Tt!==x)&&(i.blendFuncSeparate(zt[W],zt[ot],zt[rt],zt[Tt]),A=W,T=ot,w=rt,x=Tt),(Ot.equals(b)===!1||nt!==N)&&(i.blendColor(Ot.r,Ot.g,Ot.b,nt),b.copy(Ot),N=nt),u=C,I=!1}function de(C,K){C.side===xn?Nt(i.CULL_FACE):mt(i.CULL_FACE);let W=C.side===Ne;K&&(W=!W),Ue(W),C.blending===Vi&&C.transparent===!1?be(ui):be(C.blending,C.blendEquation,C.blendSrc,C.blendDst,C.blendEquationAlpha,C.blendSrcAlpha,C.blendDstAlpha,C.blendColor,C.blendAlpha,C.premultipliedAlpha),a.setFunc(C.depthFunc),a.setTest(C.depthTest),a.setMask(C.depthWrite),r.setMask(C.colorWrite);let ot=C.stencilWrite;o.setTest(ot),ot&&(o.setMask(C.stencilWriteMask),o.setFunc(C.stencilFunc,C.stencilRef,C.stencilFuncMask),o.setOp(C.stencilFail,C.stencilZFail,C.stencilZPass)),xe(C.polygonOffset,C.polygonOffsetFactor,C.polygonOffsetUnits),C.alphaToCoverage===!0?mt(i.SAMPLE_ALPHA_TO_COVERAGE):Nt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ue(C){D!==C&&(C?i.frontFace(i.CW):i.frontFace(i.CCW),D=C)}function re(C){C!==Cc?(mt(i.CULL_FACE),C!==B&&(C===zo?i.cullFace(i.BACK):C===_c?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Nt(i.CULL_FACE),B=C}function un(C){C!==H&&(G&&i.lineWidth(C),H=C)}function xe(C,K,W){C?(mt(i.POLYGON_OFFSET_FILL),(_!==K||V!==W)&&(_=K,V=W,a.getReversed()&&(K=-K,W=-W),i.polygonOffset(K,W))):Nt(i.POLYGON_OFFSET_FILL)}function qe(C){C?mt(i.SCISSOR_TEST):Nt(i.SCISSOR_TEST)}function Ze(C){C===void 0&&(C=i.TEXTURE0+q-1),Q!==C&&(i.activeTexture(C),Q=C)}function Ye(C,K,W){W===void 0&&(Q===null?W=i.TEXTURE0+q-1:W=Q);let ot=$[W];ot===void 0&&(ot={type:void 0,texture:void 0},$[W]=ot),(ot.type!==C||ot.texture!==K)&&(Q!==W&&(i.activeTexture(W),Q=W),i.bindTexture(C,K||wt[C]),ot.type=C,ot.texture=K)}function L(){let C=$[Q];C!==void 0&&C.type!==void 0&&(i.bindTexture(C.type,null),C.type=void 0,C.texture=void 0)}function Je(){try{i.compressedTexImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function ne(){try{i.compressedTexImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function ie(){try{i.texSubImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function ut(){try{i.texSubImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function fe(){try{i.compressedTexSubImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function At(){try{i.compressedTexSubImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function It(){try{i.texStorage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function E(){try{i.texStorage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function v(){try{i.texImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function O(){try{i.texImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function tt(C){return f[C]!==void 0?f[C]:i.getParameter(C)}function j(C,K){f[C]!==K&&(i.pixelStorei(C,K),f[C]=K)}function st(C){J.equals(C)===!1&&(i.scissor(C.x,C.y,C.z,C.w),J.copy(C))}function ct(C){pt.equals(C)===!1&&(i.viewport(C.x,C.y,C.z,C.w),pt.copy(C))}function Z(C,K){let W=l.get(K);W===void 0&&(W=new WeakMap,l.set(K,W));let ot=W.get(C);ot===void 0&&(ot=i.getUniformBlockIndex(K,C.name),i.uniformBlockBinding(K,ot,ot),W.set(C,ot))}function Y(C,K,W){let it=l.get(K).get(C);c[it]!==W&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,W),c[it]=W)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,$={},d={},c={},m=new WeakMap,g=[],S=null,p=!1,u=null,M=null,A=null,T=null,R=null,w=null,x=null,b=new Ft(0,0,0),N=0,I=!1,D=null,B=null,H=null,_=null,V=null,J.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:mt,disable:Nt,bindFramebuffer:le,drawBuffers:Ct,useProgram:Yt,setBlending:be,setMaterial:de,setFlipSided:Ue,setCullFace:re,setLineWidth:un,setPolygonOffset:xe,setScissorTest:qe,activeTexture:Ze,bindTexture:Ye,unbindTexture:L,compressedTexImage2D:Je,compressedTexImage3D:ne,texImage2D:v,texImage3D:O,pixelStorei:j,getParameter:tt,updateUBOMapping:Z,uniformBlockBinding:Y,texStorage2D:It,texStorage3D:E,texSubImage2D:ie,texSubImage3D:ut,compressedTexSubImage2D:fe,compressedTexSubImage3D:At,scissor:st,viewport:ct,reset:at}}function kg(i,t,e,n,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ht,h=new WeakMap,f=new Set,d,m=new WeakMap,g=new Set,S=new FinalizationRegistry(E=>g.delete(E)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function u(E,v){return p?new OffscreenCanvas(E,v):rs("canvas")}function M(E,v,O){let tt=1,j=It(E);if((j.width>O||j.height>O)&&(tt=O/Math.max(j.width,j.height)),tt<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let st=Math.floor(tt*j.width),ct=Math.floor(tt*j.height);d===void 0&&(d=u(st,ct));let Z=v?u(st,ct):d;return Z.width=st,Z.height=ct,Z.getContext("2d").drawImage(E,0,0,st,ct),Rt("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+st+"x"+ct+")."),Z}else return"data"in E&&Rt("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),E;return E}function A(E){return E.generateMipmaps}function T(E){i.generateMipmap(E)}function R(E){return E.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?i.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(E,v,O,tt,j,st=!1){if(E!==null){if(i[E]!==void 0)return i[E];Rt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||Rt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=v;if(v===i.RED&&(O===i.FLOAT&&(Z=i.R32F),O===i.HALF_FLOAT&&(Z=i.R16F),O===i.UNSIGNED_BYTE&&(Z=i.R8),O===i.UNSIGNED_SHORT&&ct&&(Z=ct.R16_EXT),O===i.SHORT&&ct&&(Z=ct.R16_SNORM_EXT)),v===i.RED_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.R8UI),O===i.UNSIGNED_SHORT&&(Z=i.R16UI),O===i.UNSIGNED_INT&&(Z=i.R32UI),O===i.BYTE&&(Z=i.R8I),O===i.SHORT&&(Z=i.R16I),O===i.INT&&(Z=i.R32I)),v===i.RG&&(O===i.FLOAT&&(Z=i.RG32F),O===i.HALF_FLOAT&&(Z=i.RG16F),O===i.UNSIGNED_BYTE&&(Z=i.RG8),O===i.UNSIGNED_SHORT&&ct&&(Z=ct.RG16_EXT),O===i.SHORT&&ct&&(Z=ct.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RG8UI),O===i.UNSIGNED_SHORT&&(Z=i.RG16UI),O===i.UNSIGNED_INT&&(Z=i.RG32UI),O===i.BYTE&&(Z=i.RG8I),O===i.SHORT&&(Z=i.RG16I),O===i.INT&&(Z=i.RG32I)),v===i.RGB_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),O===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),O===i.UNSIGNED_INT&&(Z=i.RGB32UI),O===i.BYTE&&(Z=i.RGB8I),O===i.SHORT&&(Z=i.RGB16I),O===i.INT&&(Z=i.RGB32I)),v===i.RGBA_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),O===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),O===i.UNSIGNED_INT&&(Z=i.RGBA32UI),O===i.BYTE&&(Z=i.RGBA8I),O===i.SHORT&&(Z=i.RGBA16I),O===i.INT&&(Z=i.RGBA32I)),v===i.RGB&&(O===i.UNSIGNED_SHORT&&ct&&(Z=ct.RGB16_EXT),O===i.SHORT&&ct&&(Z=ct.RGB16_SNORM_EXT),O===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),O===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),v===i.RGBA){let Y=st?ss:Vt.getTransfer(j);O===i.FLOAT&&(Z=i.RGBA32F),O===i.HALF_FLOAT&&(Z=i.RGBA16F),O===i.UNSIGNED_BYTE&&(Z=Y===Zt?i.SRGB8_ALPHA8:i.RGBA8),O===i.UNSIGNED_SHORT&&ct&&(Z=ct.RGBA16_EXT),O===i.SHORT&&ct&&(Z=ct.RGBA16_SNORM_EXT),O===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),O===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Z}function x(E,v){let O;return E?v===null||v===an||v===pi?O=i.DEPTH24_STENCIL8:v===on?O=i.DEPTH32F_STENCIL8:v===Wi&&(O=i.DEPTH24_STENCIL8,Rt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===an||v===pi?O=i.DEPTH_COMPONENT24:v===on?O=i.DEPTH_COMPONENT32F:v===Wi&&(O=i.DEPTH_COMPONENT16),O}function b(E,v){return A(E)===!0||E.isFramebufferTexture&&E.minFilter!==Me&&E.minFilter!==De?Math.log2(Math.max(v.width,v.height))+1:E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?v.mipmaps.length:1}function N(E){let v=new WeakRef(E);n.get(E).__ref=v,g.add(v),S.register(E,v,v)}function I(E){let v=n.get(E).__ref;v!==void 0&&(g.delete(v),S.unregister(v))}function D(E){H(E.target)}function B(E){_(E.target)}function H(E){E.removeEventListener("dispose",D),I(E),q(E),E.isVideoTexture&&h.delete(E),E.isHTMLTexture&&f.delete(E)}function _(E){E.removeEventListener("dispose",B),I(E),et(E)}function V(){for(let E of g){let v=E.deref();v!==void 0&&(v.isRenderTarget===!0?_(v):H(v))}g.clear(),f.clear()}function q(E){let v=n.get(E);if(v.__webglInit===void 0)return;let O=E.source,tt=m.get(O);if(tt){let j=tt[v.__cacheKey];j.usedTimes--,j.usedTimes===0&&G(E),Object.keys(tt).length===0&&m.delete(O)}n.remove(E)}function G(E){let v=n.get(E);i.deleteTexture(v.__webglTexture);let O=E.source,tt=m.get(O);delete tt[v.__cacheKey],a.memory.textures--}function et(E){let v=n.get(E);v.__depthDisposeCallback&&v.__depthDisposeCallback();let O=E.depthTexture;if(O&&O.renderTarget===E&&H(O),E.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(v.__webglFramebuffer[j]))for(let st=0;st<v.__webglFramebuffer[j].length;st++)i.deleteFramebuffer(v.__webglFramebuffer[j][st]);else i.deleteFramebuffer(v.__webglFramebuffer[j]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[j])}else{if(Array.isArray(v.__webglFramebuffer))for(let j=0;j<v.__webglFramebuffer.length;j++)i.deleteFramebuffer(v.__webglFramebuffer[j]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let j=0;j<v.__webglColorRenderbuffer.length;j++)v.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[j]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let tt=E.textures;for(let j=0,st=tt.length;j<st;j++){let ct=n.get(tt[j]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),a.memory.textures--),n.remove(tt[j])}n.remove(E)}let X=0;function Q(){X=0}function $(){return X}function Mt(E){X=E}function Lt(){let E=X;return E>=s.maxTextures&&Rt("WebGLTextures: Trying to use "+(E+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,E}function J(E){let v=[];return v.push(E.wrapS),v.push(E.wrapT),v.push(E.wrapR||0),v.push(E.magFilter),v.push(E.minFilter),v.push(E.anisotropy),v.push(E.internalFormat),v.push(E.format),v.push(E.type),v.push(E.generateMipmaps),v.push(E.mipmapsAutoUpdate),v.push(E.premultiplyAlpha),v.push(E.flipY),v.push(E.unpackAlignment),v.push(E.colorSpace),v.join()}function pt(E,v){let O=n.get(E);if(E.isVideoTexture&&fe(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&O.__version!==E.version){let tt=E.image;if(tt===null)Rt("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)Rt("WebGLRenderer: Texture marked for update but image is incomplete");else{de(O,E,v);return}}else E.isExternalTexture&&(O.__webglTexture=E.sourceTexture?E.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,O.__webglTexture,i.TEXTURE0+v)}function vt(E,v){let O=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&O.__version!==E.version){de(O,E,v);return}else E.isExternalTexture&&(O.__webglTexture=E.sourceTexture?E.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,O.__webglTexture,i.TEXTURE0+v)}function wt(E,v){let O=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&O.__version!==E.version){de(O,E,v);return}e.bindTexture(i.TEXTURE_3D,O.__webglTexture,i.TEXTURE0+v)}function mt(E,v){let O=n.get(E);if(E.version>0&&O.__version!==E.version){Ue(O,E,v);return}e.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+v)}let Nt={[Ar]:i.REPEAT,[fn]:i.CLAMP_TO_EDGE,[Rr]:i.MIRRORED_REPEAT},le={[Me]:i.NEAREST,[jc]:i.NEAREST_MIPMAP_NEAREST,[Rs]:i.NEAREST_MIPMAP_LINEAR,[De]:i.LINEAR,[ea]:i.LINEAR_MIPMAP_NEAREST,[Nn]:i.LINEAR_MIPMAP_LINEAR},Ct={[eh]:i.NEVER,[ll]:i.ALWAYS,[nh]:i.LESS,[al]:i.LEQUAL,[ih]:i.EQUAL,[ol]:i.GEQUAL,[sh]:i.GREATER,[rh]:i.NOTEQUAL};function Yt(E,v){if(v.type===on&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===De||v.magFilter===ea||v.magFilter===Rs||v.magFilter===Nn||v.minFilter===De||v.minFilter===ea||v.minFilter===Rs||v.minFilter===Nn)&&Rt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(E,i.TEXTURE_WRAP_S,Nt[v.wrapS]),i.texParameteri(E,i.TEXTURE_WRAP_T,Nt[v.wrapT]),(E===i.TEXTURE_3D||E===i.TEXTURE_2D_ARRAY)&&i.texParameteri(E,i.TEXTURE_WRAP_R,Nt[v.wrapR]),i.texParameteri(E,i.TEXTURE_MAG_FILTER,le[v.magFilter]),i.texParameteri(E,i.TEXTURE_MIN_FILTER,le[v.minFilter]),v.compareFunction&&(i.texParameteri(E,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(E,i.TEXTURE_COMPARE_FUNC,Ct[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Me||v.minFilter!==Rs&&v.minFilter!==Nn||v.type===on&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");i.texParameterf(E,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function Kt(E,v){let O=!1;E.__webglInit===void 0&&(E.__webglInit=!0,v.addEventListener("dispose",D),N(v));let tt=v.source,j=m.get(tt);j===void 0&&(j={},m.set(tt,j));let st=J(v);if(st!==E.__cacheKey){j[st]===void 0&&(j[st]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,O=!0),j[st].usedTimes++;let ct=j[E.__cacheKey];ct!==void 0&&(j[E.__cacheKey].usedTimes--,ct.usedTimes===0&&G(v)),E.__cacheKey=st,E.__webglTexture=j[st].texture}return O}function zt(E,v,O){return Math.floor(Math.floor(E/O)/v)}function be(E,v,O,tt){let st=E.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,O,tt,v.data);else{st.sort((C,K)=>C.start-K.start);let ct=0;for(let C=1;C<st.length;C++){let K=st[ct],W=st[C],ot=K.start+K.count,it=zt(W.start,v.width,4),rt=zt(K.start,v.width,4);W.start<=ot+1&&it===rt&&zt(W.start+W.count-1,v.width,4)===it?K.count=Math.max(K.count,W.start+W.count-K.start):(++ct,st[ct]=W)}st.length=ct+1;let Z=e.getParameter(i.UNPACK_ROW_LENGTH),Y=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let C=0,K=st.length;C<K;C++){let W=st[C],ot=Math.floor(W.start/4),it=Math.ceil(W.count/4),rt=ot%v.width,Tt=Math.floor(ot/v.width),Ot=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Tt),e.texSubImage2D(i.TEXTURE_2D,0,rt,Tt,Ot,nt,O,tt,v.data)}E.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Z),e.pixelStorei(i.UNPACK_SKIP_PIXELS,Y),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function de(E,v,O){let tt=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(tt=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(tt=i.TEXTURE_3D);let j=Kt(E,v),st=v.source;e.bindTexture(tt,E.__webglTexture,i.TEXTURE0+O);let ct=n.get(st);if(st.version!==ct.__version||j===!0){if(e.activeTexture(i.TEXTURE0+O),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let nt=Vt.getPrimaries(Vt.workingColorSpace),Et=v.colorSpace===Un?null:Vt.getPrimaries(v.colorSpace),Ut=v.colorSpace===Un||nt===Et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ut)}e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let Y=M(v.image,!1,s.maxTextureSize);Y=At(v,Y);let at=r.convert(v.format,v.colorSpace),C=r.convert(v.type),K=w(v.internalFormat,at,C,v.normalized,v.colorSpace,v.isVideoTexture);Yt(tt,v);let W,ot=v.mipmaps,it=v.isVideoTexture!==!0,rt=ct.__version===void 0||j===!0,Tt=st.dataReady,Ot=b(v,Y);if(v.isDepthTexture)K=x(v.format===Fn,v.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,Y.width,Y.height):e.texImage2D(i.TEXTURE_2D,0,K,Y.width,Y.height,0,at,C,null));else if(v.isDataTexture)if(ot.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Et=ot.length;nt<Et;nt++)W=ot[nt],it?Tt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,C,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,C,W.data);v.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,Y.width,Y.height),Tt&&be(v,Y,at,C)):e.texImage2D(i.TEXTURE_2D,0,K,Y.width,Y.height,0,at,C,Y.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,ot[0].width,ot[0].height,Y.depth);for(let nt=0,Et=ot.length;nt<Et;nt++)if(W=ot[nt],v.format!==cn)if(at!==null)if(it){if(Tt)if(v.layerUpdates.size>0){let Ut=ml(W.width,W.height,v.format,v.type);for(let dt of v.layerUpdates){let Jt=W.data.subarray(dt*Ut/W.data.BYTES_PER_ELEMENT,(dt+1)*Ut/W.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,dt,W.width,W.height,1,at,Jt)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Y.depth,at,W.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Y.depth,0,W.data,0,0);else Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?Tt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Y.depth,at,C,W.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Y.depth,0,at,C,W.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Et=ot.length;nt<Et;nt++)W=ot[nt],v.format!==cn?at!==null?it?Tt&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,W.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,W.data):Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?Tt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,C,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,C,W.data)}else if(v.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,Y.width,Y.height,Y.depth),Tt)if(v.layerUpdates.size>0){let nt=ml(Y.width,Y.height,v.format,v.type);for(let Et of v.layerUpdates){let Ut=Y.data.subarray(Et*nt/Y.data.BYTES_PER_ELEMENT,(Et+1)*nt/Y.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Et,Y.width,Y.height,1,at,C,Ut)}v.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,at,C,Y.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,Y.width,Y.height,Y.depth,0,at,C,Y.data);else if(v.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Ot,K,Y.width,Y.height,Y.depth),Tt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,at,C,Y.data)):e.texImage3D(i.TEXTURE_3D,0,K,Y.width,Y.height,Y.depth,0,at,C,Y.data);else if(v.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Ot,K,Y.width,Y.height);else{let nt=Y.width,Et=Y.height;for(let Ut=0;Ut<Ot;Ut++)e.texImage2D(i.TEXTURE_2D,Ut,K,nt,Et,0,at,C,null),nt>>=1,Et>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){let nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),Y.parentNode!==nt){nt.appendChild(Y),f.add(v),nt.onpaint=Et=>{let Ut=Et.changedElements;for(let dt of f)Ut.includes(dt.image)&&(dt.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Y);else{let Ut=i.RGBA,dt=i.RGBA,Jt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ut,dt,Jt,Y)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ot.length>0){if(it&&rt){let nt=It(ot[0]);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}for(let nt=0,Et=ot.length;nt<Et;nt++)W=ot[nt],it?Tt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,at,C,W):e.texImage2D(i.TEXTURE_2D,nt,K,at,C,W);v.generateMipmaps=!1}else if(it){if(rt){let nt=It(Y);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}Tt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,C,Y)}else e.texImage2D(i.TEXTURE_2D,0,K,at,C,Y);A(v)&&v.mipmapsAutoUpdate===!0&&T(tt),ct.__version=st.version,v.onUpdate&&v.onUpdate(v)}E.__version=v.version}function Ue(E,v,O){if(v.image.length!==6)return;let tt=Kt(E,v),j=v.source;e.bindTexture(i.TEXTURE_CUBE_MAP,E.__webglTexture,i.TEXTURE0+O);let st=n.get(j);if(j.version!==st.__version||tt===!0){e.activeTexture(i.TEXTURE0+O);let ct=Vt.getPrimaries(Vt.workingColorSpace),Z=v.colorSpace===Un?null:Vt.getPrimaries(v.colorSpace),Y=v.colorSpace===Un||ct===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);let at=v.isCompressedTexture||v.image[0].isCompressedTexture,C=v.image[0]&&v.image[0].isDataTexture,K=[];for(let dt=0;dt<6;dt++)!at&&!C?K[dt]=M(v.image[dt],!0,s.maxCubemapSize):K[dt]=C?v.image[dt].image:v.image[dt],K[dt]=At(v,K[dt]);let W=K[0],ot=r.convert(v.format,v.colorSpace),it=r.convert(v.type),rt=w(v.internalFormat,ot,it,v.normalized,v.colorSpace),Tt=v.isVideoTexture!==!0,Ot=st.__version===void 0||tt===!0,nt=j.dataReady,Et=b(v,W);Yt(i.TEXTURE_CUBE_MAP,v);let Ut;if(v.isDepthTexture){if(rt=x(v.format===Fn,v.type),Ot)if(Tt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,W.width,W.height);else for(let dt=0;dt<6;dt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,W.width,W.height,0,ot,it,null)}else if(at){Tt&&Ot&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Et,rt,W.width,W.height);for(let dt=0;dt<6;dt++){Ut=K[dt].mipmaps;for(let Jt=0;Jt<Ut.length;Jt++){let ve=Ut[Jt];v.format!==cn?ot!==null?Tt?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,ve.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ve.data):Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,it,ve.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ot,it,ve.data)}}}else{if(Ut=v.mipmaps,Tt&&Ot){Ut.length>0&&Et++;let dt=It(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Et,rt,dt.width,dt.height)}for(let dt=0;dt<6;dt++)if(C){Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,K[dt].width,K[dt].height,ot,it,K[dt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,K[dt].width,K[dt].height,0,ot,it,K[dt].data);for(let Jt=0;Jt<Ut.length;Jt++){let Bn=Ut[Jt].image[dt].image;Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,Bn.width,Bn.height,ot,it,Bn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,Bn.width,Bn.height,0,ot,it,Bn.data)}}else{Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,ot,it,K[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,ot,it,K[dt]);for(let Jt=0;Jt<Ut.length;Jt++){let ve=Ut[Jt];Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,ot,it,ve.image[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,ot,it,ve.image[dt])}}}A(v)&&v.mipmapsAutoUpdate===!0&&T(i.TEXTURE_CUBE_MAP),st.__version=j.version,v.onUpdate&&v.onUpdate(v)}E.__version=v.version}function re(E,v,O,tt,j,st){let ct=r.convert(O.format,O.colorSpace),Z=r.convert(O.type),Y=w(O.internalFormat,ct,Z,O.normalized,O.colorSpace),at=n.get(v),C=n.get(O);if(C.__renderTarget=v,!at.__hasExternalTextures){let K=Math.max(1,v.width>>st),W=Math.max(1,v.height>>st);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,st,Y,K,W,v.depth,0,ct,Z,null):e.texImage2D(j,st,Y,K,W,0,ct,Z,null)}e.bindFramebuffer(i.FRAMEBUFFER,E),ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,tt,j,C.__webglTexture,0,ie(v)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,tt,j,C.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function un(E,v,O){if(i.bindRenderbuffer(i.RENDERBUFFER,E),v.depthBuffer){let tt=v.depthTexture,j=tt&&tt.isDepthTexture?tt.type:null,st=x(v.stencilBuffer,j),ct=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),st,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),st,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,st,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,E)}else{let tt=v.textures;for(let j=0;j<tt.length;j++){let st=tt[j],ct=r.convert(st.format,st.colorSpace),Z=r.convert(st.type),Y=w(st.internalFormat,ct,Z,st.normalized,st.colorSpace);ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),Y,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),Y,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Y,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(E,v,O){let tt=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,E),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(v.depthTexture);j.__renderTarget=v;let st=tt?v.depthTexture.image[0]:v.depthTexture.image;(!j.__webglTexture||st.width!==v.width||st.height!==v.height)&&(st.width=v.width,st.height=v.height,v.depthTexture.needsUpdate=!0),tt?mt(v.depthTexture,0):pt(v.depthTexture,0);let ct=j.__webglTexture,Z=ie(v),Y=tt?i.TEXTURE_CUBE_MAP_POSITIVE_X+O:i.TEXTURE_2D,at=v.depthTexture.format===Fn?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===_n)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Y,ct,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,at,Y,ct,0);else if(v.depthTexture.format===Fn)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Y,ct,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,at,Y,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function qe(E){let v=n.get(E),O=E.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==E.depthTexture){let tt=E.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),tt){let j=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,tt.removeEventListener("dispose",j)};tt.addEventListener("dispose",j),v.__depthDisposeCallback=j}v.__boundDepthTexture=tt}if(E.depthTexture&&!v.__autoAllocateDepthBuffer)if(O)for(let tt=0;tt<6;tt++)xe(v.__webglFramebuffer[tt],E,tt);else E.texture.mipmaps.length>0?xe(v.__webglFramebuffer[0],E,0):xe(v.__webglFramebuffer,E,0);else if(O){v.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[tt]),v.__webglDepthbuffer[tt]===void 0)v.__webglDepthbuffer[tt]=i.createRenderbuffer(),un(v.__webglDepthbuffer[tt],E,!1);else{let j=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer[tt];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}}else if(E.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),un(v.__webglDepthbuffer,E,!1);else{let j=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ze(E,v,O){let tt=n.get(E);v!==void 0&&re(tt.__webglFramebuffer,E,E.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),O!==void 0&&qe(E)}function Ye(E){let v=E.texture,O=n.get(E),tt=n.get(v);E.addEventListener("dispose",B),N(E);let j=E.textures,st=E.isWebGLCubeRenderTarget===!0,ct=j.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=i.createTexture()),tt.__version=v.version,a.memory.textures++),st){O.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0){O.__webglFramebuffer[Z]=[];for(let Y=0;Y<v.mipmaps.length;Y++)O.__webglFramebuffer[Z][Y]=i.createFramebuffer()}else O.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(v.mipmaps.length>0){O.__webglFramebuffer=[];for(let Z=0;Z<v.mipmaps.length;Z++)O.__webglFramebuffer[Z]=i.createFramebuffer()}else O.__webglFramebuffer=i.createFramebuffer();if(ct)for(let Z=0,Y=j.length;Z<Y;Z++){let at=n.get(j[Z]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),a.memory.textures++)}if(E.samples>0&&ut(E)===!1){O.__webglMultisampledFramebuffer=i.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let Z=0;Z<j.length;Z++){let Y=j[Z];O.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,O.__webglColorRenderbuffer[Z]);let at=r.convert(Y.format,Y.colorSpace),C=r.convert(Y.type),K=w(Y.internalFormat,at,C,Y.normalized,Y.colorSpace,E.isXRRenderTarget===!0),W=ie(E);i.renderbufferStorageMultisample(i.RENDERBUFFER,W,K,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,O.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),E.depthBuffer&&(O.__webglDepthRenderbuffer=i.createRenderbuffer(),un(O.__webglDepthRenderbuffer,E,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture),Yt(i.TEXTURE_CUBE_MAP,v);for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)re(O.__webglFramebuffer[Z][Y],E,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,Y);else re(O.__webglFramebuffer[Z],E,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);A(v)?T(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let Z=0,Y=j.length;Z<Y;Z++){let at=j[Z],C=n.get(at),K=i.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(K=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,C.__webglTexture),Yt(K,at),re(O.__webglFramebuffer,E,at,i.COLOR_ATTACHMENT0+Z,K,0),A(at)&&T(K)}e.unbindTexture()}else{let Z=i.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(Z=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Z,tt.__webglTexture),Yt(Z,v),v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)re(O.__webglFramebuffer[Y],E,v,i.COLOR_ATTACHMENT0,Z,Y);else re(O.__webglFramebuffer,E,v,i.COLOR_ATTACHMENT0,Z,0);A(v)?T(Z):v.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}E.depthBuffer&&qe(E)}function L(E){let v=E.textures;for(let O=0,tt=v.length;O<tt;O++){let j=v[O];if(A(j)&&j.mipmapsAutoUpdate===!0){let st=R(E),ct=n.get(j).__webglTexture;e.bindTexture(st,ct),T(st),e.unbindTexture()}}}let Je=[];function ne(E){if(E.samples>0){if(ut(E)===!1){let v=E.textures,O=E.width,tt=E.height,j=i.COLOR_BUFFER_BIT,st=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(E),Z=v.length>1;if(Z)for(let at=0;at<v.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),E.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let at=0;at<v.length;at++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let C=n.get(v[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,C,0)}i.blitFramebuffer(0,0,O,tt,0,0,O,tt,j,i.NEAREST),c===!0&&(Je.length=0,Je.push(i.COLOR_ATTACHMENT0+at),E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&Je.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Je))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let at=0;at<v.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let C=n.get(v[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,C,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&c){let v=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function ie(E){return Math.min(s.maxSamples,E.samples)}function ut(E){let v=n.get(E);return E.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function fe(E){let v=a.render.frame;h.get(E)!==v&&(h.set(E,v),E.update())}function At(E,v){let O=E.colorSpace,tt=E.format,j=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||O!==is&&O!==Un&&(Vt.getTransfer(O)===Zt?(tt!==cn||j!==Be)&&Rt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):_t("WebGLTextures: Unsupported texture color space:",O)),v}function It(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(l.width=E.naturalWidth||E.width,l.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(l.width=E.displayWidth,l.height=E.displayHeight):(l.width=E.width,l.height=E.height),l}this.allocateTextureUnit=Lt,this.resetTextureUnits=Q,this.getTextureUnits=$,this.setTextureUnits=Mt,this.setTexture2D=pt,this.setTexture2DArray=vt,this.setTexture3D=wt,this.setTextureCube=mt,this.rebindTextures=Ze,this.setupRenderTarget=Ye,this.updateRenderTargetMipmap=L,this.updateMultisampleRenderTarget=ne,this.setupDepthRenderbuffer=qe,this.setupFrameBufferTexture=re,this.useMultisampledRTT=ut,this.dispose=V}function Gg(i,t){function e(n,s=Un){let r,a=Vt.getTransfer(s);if(n===Be)return i.UNSIGNED_BYTE;if(n===ia)return i.UNSIGNED_SHORT_4_4_4_4;if(n===sa)return i.UNSIGNED_SHORT_5_5_5_1;if(n===el)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nl)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$o)return i.BYTE;if(n===tl)return i.SHORT;if(n===Wi)return i.UNSIGNED_SHORT;if(n===na)return i.INT;if(n===an)return i.UNSIGNED_INT;if(n===on)return i.FLOAT;if(n===ln)return i.HALF_FLOAT;if(n===il)return i.ALPHA;if(n===sl)return i.RGB;if(n===cn)return i.RGBA;if(n===_n)return i.DEPTH_COMPONENT;if(n===Fn)return i.DEPTH_STENCIL;if(n===rl)return i.RED;if(n===ra)return i.RED_INTEGER;if(n===$n)return i.RG;if(n===aa)return i.RG_INTEGER;if(n===oa)return i.RGBA_INTEGER;if(n===Cs||n===_s||n===Ps||n===Is)if(a===Zt)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Cs)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Cs)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===la||n===ca||n===ha||n===ua)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===la)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ca)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ha)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ua)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===da||n===fa||n===pa||n===ma||n===ga||n===Ls||n===xa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===da||n===fa)return a===Zt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===pa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ma)return r.COMPRESSED_R11_EAC;if(n===ga)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ls)return r.COMPRESSED_RG11_EAC;if(n===xa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===va||n===ya||n===Sa||n===Ma||n===ba||n===Ta||n===Ea||n===wa||n===Aa||n===Ra||n===Ca||n===_a||n===Pa||n===Ia)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===va)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ya)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Sa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Ma)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ba)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ta)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ea)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===wa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Aa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ra)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ca)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_a)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Pa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ia)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===La||n===Da||n===Na)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===La)return a===Zt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Da)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Na)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Fa||n===Ua||n===Ds||n===Oa)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Fa)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ua)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ds)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oa)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===pi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Vg=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Hg=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,El=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ps(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new gn({vertexShader:Vg,fragmentShader:Hg,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new pe(new hi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},wl=class extends mn{constructor(t,e){super();let n=this,s=null,r=1,a=null,o="local-floor",c=1,l=null,h=null,f=null,d=null,m=null,g=null,S=typeof XRWebGLBinding<"u",p=new El,u={},M=e.getContextAttributes(),A=null,T=null,R=[],w=[],x=new Ht,b=null,N=null,I=new Le;I.viewport=new se;let D=new Le;D.viewport=new se;let B=[I,D],H=new jr,_=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let pt=R[J];return pt===void 0&&(pt=new Fi,R[J]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(J){let pt=R[J];return pt===void 0&&(pt=new Fi,R[J]=pt),pt.getGripSpace()},this.getHand=function(J){let pt=R[J];return pt===void 0&&(pt=new Fi,R[J]=pt),pt.getHandSpace()};function q(J){let pt=w.indexOf(J.inputSource);if(pt===-1)return;let vt=R[pt];vt!==void 0&&(vt.update(J.inputSource,J.frame,l||a),vt.dispatchEvent({type:J.type,data:J.inputSource}))}function G(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",et);for(let J=0;J<R.length;J++){let pt=w[J];pt!==null&&(w[J]=null,R[J].disconnect(pt))}_=null,V=null,p.reset();for(let J in u)delete u[J];if(t.setRenderTarget(A),m=null,d=null,f=null,s=null,T=null,Lt.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(x.width,x.height,!1),N!==null){let J=N.camera;J.fov=N.fov,J.zoom=N.zoom,J.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Rt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,n.isPresenting===!0&&Rt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||a},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return f===null&&S&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",G),s.addEventListener("inputsourceschange",et),M.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(x),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,wt=null,mt=null;M.depth&&(mt=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=M.stencil?Fn:_n,wt=M.stencil?pi:an);let Nt={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(Nt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),T=new He(d.textureWidth,d.textureHeight,{format:cn,type:Be,depthTexture:new Ln(d.textureWidth,d.textureHeight,wt,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let vt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),T=new He(m.framebufferWidth,m.framebufferHeight,{format:cn,type:Be,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}T.isXRRenderTarget=!0,this.setFoveation(c),l=null,a=await s.requestReferenceSpace(o),Lt.setContext(s),Lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function et(J){for(let pt=0;pt<J.removed.length;pt++){let vt=J.removed[pt],wt=w.indexOf(vt);wt>=0&&(w[wt]=null,R[wt].disconnect(vt))}for(let pt=0;pt<J.added.length;pt++){let vt=J.added[pt],wt=w.indexOf(vt);if(wt===-1){for(let Nt=0;Nt<R.length;Nt++)if(Nt>=w.length){w.push(vt),wt=Nt;break}else if(w[Nt]===null){w[Nt]=vt,wt=Nt;break}if(wt===-1)break}let mt=R[wt];mt&&mt.connect(vt)}}function X(J,pt){pt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(pt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let pt=J.near,vt=J.far;p.texture!==null&&(p.depthNear>0&&(pt=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),H.near=D.near=I.near=pt,H.far=D.far=I.far=vt,(_!==H.near||V!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),_=H.near,V=H.far),H.layers.mask=J.layers.mask|6,I.layers.mask=H.layers.mask&-5,D.layers.mask=H.layers.mask&-3;let wt=J.parent,mt=H.cameras;X(H,wt);for(let Nt=0;Nt<mt.length;Nt++)X(mt[Nt],wt);H.projectionMatrix.copy(I.projectionMatrix),H.projectionMatrixInverse.copy(I.projectionMatrixInverse),N===null&&J.isPerspectiveCamera&&(N={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,H,wt)};function Q(J,pt,vt){vt===null?J.matrix.copy(pt.matrixWorld):(J.matrix.copy(vt.matrixWorld),J.matrix.invert(),J.matrix.multiply(pt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(pt.projectionMatrix),J.projectionMatrixInverse.copy(pt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=_r*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&m===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(J){return u[J]};let $=null;function Mt(J,pt){if(h=pt.getViewerPose(l||a),g=pt,h!==null){let vt=h.views;m!==null&&(t.setRenderTargetFramebuffer(T,m.framebuffer),t.setRenderTarget(T));let wt=!1;vt.length!==H.cameras.length&&(H.cameras.length=0,wt=!0);for(let Ct=0;Ct<vt.length;Ct++){let Yt=vt[Ct],Kt=null;if(m!==null)Kt=m.getViewport(Yt);else{let be=f.getViewSubImage(d,Yt);Kt=be.viewport,Ct===0&&(t.setRenderTargetTextures(T,be.colorTexture,be.depthStencilTexture),t.setRenderTarget(T))}let zt=B[Ct];zt===void 0&&(zt=new Le,zt.layers.enable(Ct),zt.viewport=new se,B[Ct]=zt),zt.matrix.fromArray(Yt.transform.matrix),zt.matrix.decompose(zt.position,zt.quaternion,zt.scale),zt.projectionMatrix.fromArray(Yt.projectionMatrix),zt.projectionMatrixInverse.copy(zt.projectionMatrix).invert(),zt.viewport.set(Kt.x,Kt.y,Kt.width,Kt.height),Ct===0&&(H.matrix.copy(zt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),wt===!0&&H.cameras.push(zt)}let mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){f=n.getBinding();let Ct=f.getDepthInformation(vt[0]);Ct&&Ct.isValid&&Ct.texture&&p.init(Ct,s.renderState)}if(mt&&mt.includes("camera-access")&&S){t.state.unbindTexture(),f=n.getBinding();for(let Ct=0;Ct<vt.length;Ct++){let Yt=vt[Ct].camera;if(Yt){let Kt=u[Yt];Kt||(Kt=new ps,u[Yt]=Kt);let zt=f.getCameraImage(Yt);Kt.sourceTexture=zt}}}}for(let vt=0;vt<R.length;vt++){let wt=w[vt],mt=R[vt];wt!==null&&mt!==void 0&&mt.update(wt,pt,l||a)}$&&$(J,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),g=null}let Lt=new Oh;Lt.setAnimationLoop(Mt),this.setAnimationLoop=function(J){$=J},this.dispose=function(){}}},Wg=new Qt,Zh=new Pt;Zh.set(-1,0,0,0,1,0,0,0,1);function Xg(i,t){function e(p,u){p.matrixAutoUpdate===!0&&p.updateMatrix(),u.value.copy(p.matrix)}function n(p,u){u.color.getRGB(p.fogColor.value,dl(i)),u.isFog?(p.fogNear.value=u.near,p.fogFar.value=u.far):u.isFogExp2&&(p.fogDensity.value=u.density)}function s(p,u,M,A,T){u.isNodeMaterial?u.uniformsNeedUpdate=!1:u.isMeshBasicMaterial?r(p,u):u.isMeshLambertMaterial?(r(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshToonMaterial?(r(p,u),f(p,u)):u.isMeshPhongMaterial?(r(p,u),h(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshStandardMaterial?(r(p,u),d(p,u),u.isMeshPhysicalMaterial&&m(p,u,T)):u.isMeshMatcapMaterial?(r(p,u),g(p,u)):u.isMeshDepthMaterial?r(p,u):u.isMeshDistanceMaterial?(r(p,u),S(p,u)):u.isMeshNormalMaterial?r(p,u):u.isLineBasicMaterial?(a(p,u),u.isLineDashedMaterial&&o(p,u)):u.isPointsMaterial?c(p,u,M,A):u.isSpriteMaterial?l(p,u):u.isShadowMaterial?(p.color.value.copy(u.color),p.opacity.value=u.opacity):u.isShaderMaterial&&(u.uniformsNeedUpdate=!1)}function r(p,u){p.opacity.value=u.opacity,u.color&&p.diffuse.value.copy(u.color),u.emissive&&p.emissive.value.copy(u.emissive).multiplyScalar(u.emissiveIntensity),u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.bumpMap&&(p.bumpMap.value=u.bumpMap,e(u.bumpMap,p.bumpMapTransform),p.bumpScale.value=u.bumpScale,u.side===Ne&&(p.bumpScale.value*=-1)),u.normalMap&&(p.normalMap.value=u.normalMap,e(u.normalMap,p.normalMapTransform),p.normalScale.value.copy(u.normalScale),u.side===Ne&&p.normalScale.value.negate()),u.displacementMap&&(p.displacementMap.value=u.displacementMap,e(u.displacementMap,p.displacementMapTransform),p.displacementScale.value=u.displacementScale,p.displacementBias.value=u.displacementBias),u.emissiveMap&&(p.emissiveMap.value=u.emissiveMap,e(u.emissiveMap,p.emissiveMapTransform)),u.specularMap&&(p.specularMap.value=u.specularMap,e(u.specularMap,p.specularMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest);let M=t.get(u),A=M.envMap,T=M.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(Wg.makeRotationFromEuler(T)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Zh),p.reflectivity.value=u.reflectivity,p.ior.value=u.ior,p.refractionRatio.value=u.refractionRatio),u.lightMap&&(p.lightMap.value=u.lightMap,p.lightMapIntensity.value=u.lightMapIntensity,e(u.lightMap,p.lightMapTransform)),u.aoMap&&(p.aoMap.value=u.aoMap,p.aoMapIntensity.value=u.aoMapIntensity,e(u.aoMap,p.aoMapTransform))}function a(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform))}function o(p,u){p.dashSize.value=u.dashSize,p.totalSize.value=u.dashSize+u.gapSize,p.scale.value=u.scale}function c(p,u,M,A){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.size.value=u.size*M,p.scale.value=A*.5,u.map&&(p.map.value=u.map,e(u.map,p.uvTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function l(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.rotation.value=u.rotation,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function h(p,u){p.specular.value.copy(u.specular),p.shininess.value=Math.max(u.shininess,1e-4)}function f(p,u){u.gradientMap&&(p.gradientMap.value=u.gradientMap)}function d(p,u){p.metalness.value=u.metalness,u.metalnessMap&&(p.metalnessMap.value=u.metalnessMap,e(u.metalnessMap,p.metalnessMapTransform)),p.roughness.value=u.roughness,u.roughnessMap&&(p.roughnessMap.value=u.roughnessMap,e(u.roughnessMap,p.roughnessMapTransform)),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)}function m(p,u,M){p.ior.value=u.ior,u.diffuseRoughness>0&&(p.diffuseRoughness.value=u.diffuseRoughness,u.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=u.diffuseRoughnessMap,e(u.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),u.sheen>0&&(p.sheenColor.value.copy(u.sheenColor).multiplyScalar(u.sheen),p.sheenRoughness.value=u.sheenRoughness,u.sheenColorMap&&(p.sheenColorMap.value=u.sheenColorMap,e(u.sheenColorMap,p.sheenColorMapTransform)),u.sheenRoughnessMap&&(p.sheenRoughnessMap.value=u.sheenRoughnessMap,e(u.sheenRoughnessMap,p.sheenRoughnessMapTransform))),u.clearcoat>0&&(p.clearcoat.value=u.clearcoat,p.clearcoatRoughness.value=u.clearcoatRoughness,u.clearcoatMap&&(p.clearcoatMap.value=u.clearcoatMap,e(u.clearcoatMap,p.clearcoatMapTransform)),u.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=u.clearcoatRoughnessMap,e(u.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),u.clearcoatNormalMap&&(p.clearcoatNormalMap.value=u.clearcoatNormalMap,e(u.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(u.clearcoatNormalScale),u.side===Ne&&p.clearcoatNormalScale.value.negate())),u.dispersion>0&&(p.dispersion.value=u.dispersion),u.retroreflectivity>0&&(p.retroreflectivity.value=u.retroreflectivity),u.iridescence>0&&(p.iridescence.value=u.iridescence,p.iridescenceIOR.value=u.iridescenceIOR,p.iridescenceThicknessMinimum.value=u.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=u.iridescenceThicknessMaximum,u.iridescenceMap&&(p.iridescenceMap.value=u.iridescenceMap,e(u.iridescenceMap,p.iridescenceMapTransform)),u.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=u.iridescenceThicknessMap,e(u.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),u.transmission>0&&(p.transmission.value=u.transmission,p.transmissionSamplerMap.value=M.texture,p.transmissionSamplerSize.value.set(M.width,M.height),u.transmissionMap&&(p.transmissionMap.value=u.transmissionMap,e(u.transmissionMap,p.transmissionMapTransform)),p.thickness.value=u.thickness,u.thicknessMap&&(p.thicknessMap.value=u.thicknessMap,e(u.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=u.attenuationDistance,p.attenuationColor.value.copy(u.attenuationColor)),u.anisotropy>0&&(p.anisotropyVector.value.set(u.anisotropy*Math.cos(u.anisotropyRotation),u.anisotropy*Math.sin(u.anisotropyRotation)),u.anisotropyMap&&(p.anisotropyMap.value=u.anisotropyMap,e(u.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=u.specularIntensity,p.specularColor.value.copy(u.specularColor),u.specularColorMap&&(p.specularColorMap.value=u.specularColorMap,e(u.specularColorMap,p.specularColorMapTransform)),u.specularIntensityMap&&(p.specularIntensityMap.value=u.specularIntensityMap,e(u.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,u){u.matcap&&(p.matcap.value=u.matcap)}function S(p,u){let M=t.get(u).light;p.referencePosition.value.setFromMatrixPosition(M.matrixWorld),p.nearDistance.value=M.shadow.camera.near,p.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function qg(i,t,e,n){let s={},r={};function a(M,A){let T=A.program;n.uniformBlockBinding(M,T,s[M.id])}function o(M,A){let T=s[M.id];T===void 0&&(g(M),T=c(M),s[M.id]=T,M.addEventListener("dispose",p));let R=A.program;n.updateUBOMapping(M,R);let w=t.render.frame;r[M.id]!==w&&(l(M),r[M.id]=w)}function c(M){let A=i.createBuffer(),T=M.__size,R=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,T,R),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(M){let A=s[M.id],T=M.uniforms,R=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let w=0,x=T.length;w<x;w++){let b=T[w];if(Array.isArray(b))for(let N=0,I=b.length;N<I;N++)h(b[N],w,N,R);else h(b,w,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(M,A,T,R){if(d(M,A,T,R)===!0){let w=M.__offset,x=M.value;if(Array.isArray(x)){let b=0;for(let N=0;N<x.length;N++){let I=x[N],D=S(I,!0);f(I,M.__data,b),b+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,M.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,M.__data)}}function f(M,A,T){typeof M=="number"||typeof M=="boolean"?A[T]=M:M.isMatrix3?(A[T]=M.elements[0],A[T+1]=M.elements[1],A[T+2]=M.elements[2],A[T+3]=0,A[T+4]=M.elements[3],A[T+5]=M.elements[4],A[T+6]=M.elements[5],A[T+7]=0,A[T+8]=M.elements[6],A[T+9]=M.elements[7],A[T+10]=M.elements[8],A[T+11]=0):ArrayBuffer.isView(M)?A.set(M.subarray(0,A.length-T),T):M.toArray(A,T)}function d(M,A,T,R){let w=M.value,x=A+"_"+T;if(Array.isArray(w)){R[x]===void 0&&(R[x]=[]);let b=R[x],N=!1;for(let I=0;I<w.length;I++)m(w[I],b,I)===!0&&(N=!0);return N}return m(w,R,x)}function m(M,A,T){if(A[T]===void 0)return typeof M=="number"||typeof M=="boolean"?A[T]=M:ArrayBuffer.isView(M)?A[T]=M.slice():A[T]=M.clone(),!0;{let R=A[T];if(typeof M=="number"||typeof M=="boolean"){if(R!==M)return A[T]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(R.equals(M)===!1)return R.copy(M),!0}}return!1}function g(M){let A=M.uniforms,T=0,R=16;for(let x=0,b=A.length;x<b;x++){let N=Array.isArray(A[x])?A[x]:[A[x]];for(let I=0,D=N.length;I<D;I++){let B=N[I],H=Array.isArray(B.value)?B.value:[B.value],_=Array.isArray(A[x])||Array.isArray(B.value),V=T;for(let G=0,et=H.length;G<et;G++){let X=H[G],Q=S(X,_),$=T%R,Mt=$%Q.boundary,Lt=$+Mt;T+=Mt,Lt!==0&&R-Lt<Q.storage&&(T+=R-Lt),G===0&&(V=T),T+=Q.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((T-V)/Float32Array.BYTES_PER_ELEMENT),B.__offset=V}}let w=T%R;return w>0&&(T+=R-w),M.__size=T,M.__cache={},this}function S(M,A){let T={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(T.boundary=4,T.storage=4):M.isVector2?(T.boundary=8,T.storage=8):M.isVector3||M.isColor?(T.boundary=16,T.storage=12):M.isVector4?(T.boundary=16,T.storage=16):M.isMatrix3?(T.boundary=16,T.storage=48):M.isMatrix4?(T.boundary=16,T.storage=64):M.isTexture?Rt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(T.boundary=16,T.storage=M.byteLength):Rt("WebGLRenderer: Unsupported uniform value type.",M),A===!0&&(T.boundary=16,T.storage=Math.ceil(T.storage/16)*16),T}function p(M){let A=M.target;A.removeEventListener("dispose",p),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function u(){for(let M in s)i.deleteBuffer(s[M]);s={},r={}}return{bind:a,update:o,dispose:u}}var Zg=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yn=null;function Yg(){return yn===null&&(yn=new Dr(Zg,16,16,$n,ln),yn.name="DFG_LUT",yn.minFilter=De,yn.magFilter=De,yn.wrapS=fn,yn.wrapT=fn,yn.generateMipmaps=!1,yn.needsUpdate=!0),yn}var Va=class{constructor(t={}){let{canvas:e=oh(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:m=Be}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let S=m,p=new Set([oa,aa,ra]),u=new Set([Be,an,Wi,pi,ia,sa]),M=new Uint32Array(4),A=new Int32Array(4),T={textures:[],min:[],max:[],resolution:[]},R=null,w=null,x=[],b=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,B=null,H=null,_=null,V=null;this._outputColorSpace=Ge;let q=0,G=0,et=null,X=-1,Q=null,$=new se,Mt=new se,Lt=null,J=new Ft(0),pt=0,vt=e.width,wt=e.height,mt=1,Nt=null,le=null,Ct=new se(0,0,vt,wt),Yt=new se(0,0,vt,wt),Kt=!1,zt=new Zn,be=new Nr,de=!1,Ue=!1,re=new Qt,un=new F,xe=new se,qe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ze=!1;function Ye(){return et===null?mt:1}let L=n;function Je(y,P){return e.getContext(y,P)}let ne,ie,ut,fe,At,It,E,v,O,tt,j,st,ct,Z,Y,at,C,K,W,ot,it,rt,Tt;try{let y={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Et,!1),e.addEventListener("webglcontextrestored",Ut,!1),e.addEventListener("webglcontextcreationerror",dt,!1),L===null){let P="webgl2";if(L=Je(P,y),L===null)throw Je(P)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ot()}catch(y){throw e.removeEventListener("webglcontextlost",Et,!1),e.removeEventListener("webglcontextrestored",Ut,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),_t("WebGLRenderer: "+y.message),y}function Ot(){ne=new rm(L),ne.init(),it=new Gg(L,ne),ie=new Yp(L,ne,t,it),ut=new zg(L,ne),ie.reversedDepthBuffer&&d&&ut.buffers.depth.setReversed(!0),H=L.createFramebuffer(),_=L.createFramebuffer(),V=L.createFramebuffer(),fe=new lm(L),At=new wg,It=new kg(L,ne,ut,At,ie,it,fe),E=new sm(I),v=new cd(L),rt=new qp(L,v),O=new am(L,v,fe,rt),tt=new hm(L,O,v,rt,fe),K=new cm(L,ie,It),Y=new Jp(At),j=new Eg(I,E,ne,ie,rt,Y),st=new Xg(I,At),ct=new Rg,Z=new Dg(ne),C=new Xp(I,E,ut,tt,g,c),at=new Bg(I,tt,ie),Tt=new qg(L,fe,ie,ut),W=new Zp(L,ne,fe),ot=new om(L,ne,fe),fe.programs=j.programs,I.capabilities=ie,I.extensions=ne,I.properties=At,I.renderLists=ct,I.shadowMap=at,I.state=ut,I.info=fe}S!==Be&&(N=new dm(S,e.width,e.height,o,s,r));let nt=new wl(I,L);this.xr=nt,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let y=ne.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){let y=ne.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(y){y!==void 0&&(mt=y,this.setSize(vt,wt,!1))},this.getSize=function(y){return y.set(vt,wt)},this.setSize=function(y,P,k=!0){if(nt.isPresenting){Rt("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=y,wt=P,e.width=Math.floor(y*mt),e.height=Math.floor(P*mt),k===!0&&(e.style.width=y+"px",e.style.height=P+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,y,P)},this.getDrawingBufferSize=function(y){return y.set(vt*mt,wt*mt).floor()},this.setDrawingBufferSize=function(y,P,k){vt=y,wt=P,mt=k,e.width=Math.floor(y*k),e.height=Math.floor(P*k),this.setViewport(0,0,y,P)},this.setEffects=function(y){if(S===Be){_t("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let P=0;P<y.length;P++)if(y[P].isOutputPass===!0){Rt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy($)},this.getViewport=function(y){return y.copy(Ct)},this.setViewport=function(y,P,k,U){y.isVector4?Ct.set(y.x,y.y,y.z,y.w):Ct.set(y,P,k,U),ut.viewport($.copy(Ct).multiplyScalar(Ye()).round())},this.getScissor=function(y){return y.copy(Yt)},this.setScissor=function(y,P,k,U){y.isVector4?Yt.set(y.x,y.y,y.z,y.w):Yt.set(y,P,k,U),ut.scissor(Mt.copy(Yt).multiplyScalar(Ye()).round())},this.getScissorTest=function(){return Kt},this.setScissorTest=function(y){ut.setScissorTest(Kt=y)},this.setOpaqueSort=function(y){Nt=y},this.setTransparentSort=function(y){le=y},this.getClearColor=function(y){return y.copy(C.getClearColor())},this.setClearColor=function(){C.setClearColor(...arguments)},this.getClearAlpha=function(){return C.getClearAlpha()},this.setClearAlpha=function(){C.setClearAlpha(...arguments)},this.clear=function(y=!0,P=!0,k=!0){let U=0;if(y){let z=!1;if(et!==null){let ht=et.texture.format;z=p.has(ht)}if(z){let ht=et.texture.type,xt=u.has(ht),lt=C.getClearColor(),gt=C.getClearAlpha(),bt=lt.r,Dt=lt.g,kt=lt.b;xt?(M[0]=bt,M[1]=Dt,M[2]=kt,M[3]=gt,L.clearBufferuiv(L.COLOR,0,M)):(A[0]=bt,A[1]=Dt,A[2]=kt,A[3]=gt,L.clearBufferiv(L.COLOR,0,A))}else U|=L.COLOR_BUFFER_BIT}P&&(U|=L.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),k&&(U|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&L.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),B=y},this.dispose=function(){e.removeEventListener("webglcontextlost",Et,!1),e.removeEventListener("webglcontextrestored",Ut,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),C.dispose(),ct.dispose(),Z.dispose(),It.dispose(),At.dispose(),E.dispose(),tt.dispose(),O.dispose(),rt.dispose(),Tt.dispose(),j.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Nl),nt.removeEventListener("sessionend",Fl),ei.stop()};function Et(y){y.preventDefault(),hl("WebGLRenderer: Context Lost."),D=!0}function Ut(){hl("WebGLRenderer: Context Restored."),D=!1;let y=fe.autoReset,P=at.enabled,k=at.autoUpdate,U=at.needsUpdate,z=at.type;Ot(),fe.autoReset=y,at.enabled=P,at.autoUpdate=k,at.needsUpdate=U,at.type=z}function dt(y){_t("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Jt(y){let P=y.target;P.removeEventListener("dispose",Jt),ve(P)}function ve(y){Bn(y),At.remove(y)}function Bn(y){let P=At.get(y).programs;P!==void 0&&(P.forEach(function(k){j.releaseProgram(k)}),y.isShaderMaterial&&j.releaseShaderCache(y))}this.renderBufferDirect=function(y,P,k,U,z,ht){P===null&&(P=qe);let xt=z.isMesh&&z.matrixWorld.determinantAffine()<0,lt=cu(y,P,k,U,z);ut.setMaterial(U,xt);let gt=k.index,bt=1;if(U.wireframe===!0){if(gt=O.getWireframeAttribute(k),gt===void 0)return;bt=2}let Dt=k.drawRange,kt=k.attributes.position,yt=Dt.start*bt,Gt=(Dt.start+Dt.count)*bt;ht!==null&&(yt=Math.max(yt,ht.start*bt),Gt=Math.min(Gt,(ht.start+ht.count)*bt)),gt!==null?(yt=Math.max(yt,0),Gt=Math.min(Gt,gt.count)):kt!=null&&(yt=Math.max(yt,0),Gt=Math.min(Gt,kt.count));let ce=Gt-yt;if(ce<0||ce===1/0)return;rt.setup(z,U,lt,k,gt);let $t,jt=W;if(gt!==null&&($t=v.get(gt),jt=ot,jt.setIndex($t)),z.isMesh)U.wireframe===!0?(ut.setLineWidth(U.wireframeLinewidth*Ye()),jt.setMode(L.LINES)):jt.setMode(L.TRIANGLES);else if(z.isLine){let we=U.linewidth;we===void 0&&(we=1),ut.setLineWidth(we*Ye()),z.isLineSegments?jt.setMode(L.LINES):z.isLineLoop?jt.setMode(L.LINE_LOOP):jt.setMode(L.LINE_STRIP)}else z.isPoints?jt.setMode(L.POINTS):z.isSprite&&jt.setMode(L.TRIANGLES);if(z.isBatchedMesh)if(ne.get("WEBGL_multi_draw"))jt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let we=z._multiDrawStarts,St=z._multiDrawCounts,Ie=z._multiDrawCount,qt=gt?v.get(gt).bytesPerElement:1,ni=At.get(U).currentProgram.getUniforms();for(let Ae=0;Ae<Ie;Ae++)ni.setValue(L,"_gl_DrawID",Ae),jt.render(we[Ae]/qt,St[Ae])}else if(z.isInstancedMesh)jt.renderInstances(yt,ce,z.count);else if(k.isInstancedBufferGeometry){let we=k._maxInstanceCount!==void 0?k._maxInstanceCount:1/0,St=Math.min(k.instanceCount,we);jt.renderInstances(yt,ce,St)}else jt.render(yt,ce)};function Dl(y,P,k,U){B!==null&&y.isNodeMaterial&&B.setObject(U,y),de===!0&&Y.setState(y,k,!1),y.transparent===!0&&y.side===xn&&y.forceSinglePass===!1?(y.side=Ne,y.needsUpdate=!0,Yi(y,P,U),y.side=Qn,y.needsUpdate=!0,Yi(y,P,U),y.side=xn):Yi(y,P,U)}this.compile=function(y,P,k=null){k===null&&(k=y),B!==null&&B.renderStart(y,P,k),w=Z.get(k),w.init(P),b.push(w),k.traverseVisible(function(z){z.isLight&&z.layers.test(P.layers)&&(w.pushLight(z),z.castShadow&&w.pushShadow(z))}),y!==k&&y.traverseVisible(function(z){z.isLight&&z.layers.test(P.layers)&&(w.pushLight(z),z.castShadow&&w.pushShadow(z))}),w.setupLights(),B!==null&&B.updateLights(w.state.lightsArray),Ue=this.localClippingEnabled,de=Y.init(this.clippingPlanes,Ue),de===!0&&Y.setGlobalState(this.clippingPlanes,P),B!==null&&at.render(w.state.shadowsArray,k,P);let U=new Set;return y.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let ht=z.material;if(ht)if(Array.isArray(ht))for(let xt=0;xt<ht.length;xt++){let lt=ht[xt];Dl(lt,k,P,z),U.add(lt)}else Dl(ht,k,P,z),U.add(ht)}),w=b.pop(),B!==null&&B.renderEnd(),U},this.compileAsync=function(y,P,k=null){let U=this.compile(y,P,k);return new Promise(z=>{function ht(){if(U.forEach(function(xt){let gt=At.get(xt).currentProgram;(gt===void 0||gt.isReady())&&U.delete(xt)}),U.size===0){z(y);return}setTimeout(ht,10)}ne.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let no=null;function ou(y){no&&no(y)}function Nl(){ei.stop()}function Fl(){ei.start()}let ei=new Oh;ei.setAnimationLoop(ou),typeof self<"u"&&ei.setContext(self),this.setAnimationLoop=function(y){no=y,nt.setAnimationLoop(y),y===null?ei.stop():ei.start()},nt.addEventListener("sessionstart",Nl),nt.addEventListener("sessionend",Fl),this.render=function(y,P){if(P!==void 0&&P.isCamera!==!0){_t("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(y,P);let k=nt.enabled===!0&&nt.isPresenting===!0,U=N!==null&&(et===null||k)&&N.begin(I,et);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),P.parent===null&&P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(P),P=nt.getCamera()),y.isScene===!0&&y.onBeforeRender(I,y,P,et),w=Z.get(y,b.length),w.init(P),w.state.textureUnits=It.getTextureUnits(),b.push(w),re.multiplyMatrices(P.projectionMatrix,P.matrixWorldInverse),P.isArrayCamera?be.setFromArrayCamera(P):zt.setFromProjectionMatrix(re,je,P.reversedDepth),Ue=this.localClippingEnabled,de=Y.init(this.clippingPlanes,Ue),R=ct.get(y,x.length),R.init(),x.push(R),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let xt=I.xr.getDepthSensingMesh();xt!==null&&io(xt,P,-1/0,I.sortObjects)}io(y,P,0,I.sortObjects),R.finish(),B!==null&&B.updateLights(w.state.lightsArray),I.sortObjects===!0&&R.sort(Nt,le),Ze=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Ze&&C.addToRenderList(R,y),this.info.autoReset===!0&&this.info.reset(),de===!0&&Y.beginShadows();let z=w.state.shadowsArray;if(at.render(z,y,P),de===!0&&Y.endShadows(),(U&&N.hasRenderPass())===!1){let xt=R.opaque,lt=R.transmissive;if(w.setupLights(),P.isArrayCamera){let gt=P.cameras;if(lt.length>0)for(let bt=0,Dt=gt.length;bt<Dt;bt++){let kt=gt[bt];Ol(xt,lt,y,kt)}Ze&&C.render(y);for(let bt=0,Dt=gt.length;bt<Dt;bt++){let kt=gt[bt];Ul(R,y,kt,kt.viewport)}}else lt.length>0&&Ol(xt,lt,y,P),Ze&&C.render(y),Ul(R,y,P)}et!==null&&G===0&&(It.updateMultisampleRenderTarget(et),It.updateRenderTargetMipmap(et)),U&&N.end(I),y.isScene===!0&&y.onAfterRender(I,y,P),rt.resetDefaultState(),X=-1,Q=null,b.pop(),b.length>0?(w=b[b.length-1],It.setTextureUnits(w.state.textureUnits),de===!0&&Y.setGlobalState(I.clippingPlanes,w.state.camera)):w=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,B!==null&&B.renderEnd()};function io(y,P,k,U){if(y.visible===!1)return;if(y.layers.test(P.layers)){if(y.isGroup)k=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(P);else if(y.isLight)w.pushLight(y),y.castShadow&&w.pushShadow(y);else if(y.isSprite){let xt=P.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){U&&xe.setFromMatrixPosition(y.matrixWorld).applyMatrix4(re);let lt=tt.update(y),gt=y.material;gt.visible&&R.push(y,lt,gt,k,xe.z,null,P)}}else if(y.isMesh||y.isLine||y.isPoints){let xt=P.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){let lt=tt.update(y),gt=y.material;if(U&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),xe.copy(y.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),xe.copy(lt.boundingSphere.center)),xe.applyMatrix4(y.matrixWorld).applyMatrix4(re)),Array.isArray(gt)){let bt=lt.groups;for(let Dt=0,kt=bt.length;Dt<kt;Dt++){let yt=bt[Dt],Gt=gt[yt.materialIndex];Gt&&Gt.visible&&R.push(y,lt,Gt,k,xe.z,yt,P)}}else gt.visible&&R.push(y,lt,gt,k,xe.z,null,P)}}}let ht=y.children;for(let xt=0,lt=ht.length;xt<lt;xt++)io(ht[xt],P,k,U)}function Ul(y,P,k,U){let{opaque:z,transmissive:ht,transparent:xt}=y;w.setupLightsView(k),de===!0&&Y.setGlobalState(I.clippingPlanes,k),U&&ut.viewport($.copy(U)),z.length>0&&Gs(z,P,k),ht.length>0&&Gs(ht,P,k),xt.length>0&&Gs(xt,P,k),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function Ol(y,P,k,U){if((k.isScene===!0?k.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[U.id]===void 0){let yt=ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[U.id]=new He(1,1,{generateMipmaps:!0,type:yt?ln:Be,minFilter:Nn,samples:Math.max(4,ie.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Vt.workingColorSpace})}let ht=w.state.transmissionRenderTarget[U.id],xt=U.viewport||$;ht.setSize(xt.z*I.transmissionResolutionScale,xt.w*I.transmissionResolutionScale);let lt=I.getRenderTarget(),gt=I.getActiveCubeFace(),bt=I.getActiveMipmapLevel();I.setRenderTarget(ht),I.getClearColor(J),pt=I.getClearAlpha(),pt<1&&I.setClearColor(16777215,.5),I.clear(),Ze&&C.render(k);let Dt=I.toneMapping;I.toneMapping=vn;let kt=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),w.setupLightsView(U),de===!0&&Y.setGlobalState(I.clippingPlanes,U),Gs(y,k,U),It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht),ne.has("WEBGL_multisampled_render_to_texture")===!1){let yt=!1;for(let Gt=0,ce=P.length;Gt<ce;Gt++){let $t=P[Gt],{object:jt,geometry:we,material:St,group:Ie}=$t;if(St.side===xn&&jt.layers.test(U.layers)){let qt=St.side;St.side=Ne,St.needsUpdate=!0,Bl(jt,k,U,we,St,Ie),St.side=qt,St.needsUpdate=!0,yt=!0}}yt===!0&&(It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht))}I.setRenderTarget(lt,gt,bt),I.setClearColor(J,pt),kt!==void 0&&(U.viewport=kt),I.toneMapping=Dt}function Gs(y,P,k){let U=P.isScene===!0?P.overrideMaterial:null;for(let z=0,ht=y.length;z<ht;z++){let xt=y[z],{object:lt,geometry:gt,group:bt}=xt,Dt=xt.material;Dt.allowOverride===!0&&U!==null&&(Dt=U),lt.layers.test(k.layers)&&Bl(lt,P,k,gt,Dt,bt)}}function Bl(y,P,k,U,z,ht){B!==null&&z.isNodeMaterial&&B.setObject(y,z),y.onBeforeRender(I,P,k,U,z,ht),y.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),z.onBeforeRender(I,P,k,U,y,ht),z.transparent===!0&&z.side===xn&&z.forceSinglePass===!1?(z.side=Ne,z.needsUpdate=!0,I.renderBufferDirect(k,P,U,z,y,ht),z.side=Qn,z.needsUpdate=!0,I.renderBufferDirect(k,P,U,z,y,ht),z.side=xn):I.renderBufferDirect(k,P,U,z,y,ht),y.onAfterRender(I,P,k,U,z,ht)}function zl(y){let P=0;for(let k of y)k.texture!==null&&P++;return P}function Yi(y,P,k){P.isScene!==!0&&(P=qe);let U=At.get(y),z=w.state.lights,ht=w.state.shadowsArray,xt=z.state.version,lt=j.getParameters(y,z.state,ht,P,k,w.state.lightProbeGridArray),gt=j.getProgramCacheKey(lt),bt=U.programs;U.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,U.fog=P.fog;let Dt=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;U.envMap=E.get(y.envMap||U.environment,Dt),U.envMapRotation=U.environment!==null&&y.envMap===null?P.environmentRotation:y.envMapRotation,bt===void 0&&(y.addEventListener("dispose",Jt),bt=new Map,U.programs=bt,U.programVariants=new Map);let kt=bt.get(gt);if(kt!==void 0){if(U.currentProgram===kt&&U.lightsStateVersion===xt)return Gl(y,lt),kt}else lt.uniforms=j.getUniforms(y),B!==null&&y.isNodeMaterial&&B.build(y,k,lt),y.onBeforeCompile(lt,I),kt=j.acquireProgram(lt,gt),bt.set(gt,kt),U.uniforms=lt.uniforms;let yt=U.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(yt.clippingPlanes=Y.uniform),Gl(y,lt),U.needsLights=uu(y),U.lightsStateVersion=xt,U.needsLights&&(yt.ambientLightColor.value=z.state.ambient,yt.lightProbe.value=z.state.probe,yt.sunLights.value=z.state.sun,yt.sunLightShadows.value=z.state.sunShadow,yt.directionalLights.value=z.state.directional,yt.directionalLightShadows.value=z.state.directionalShadow,yt.spotLights.value=z.state.spot,yt.spotLightShadows.value=z.state.spotShadow,yt.rectAreaLights.value=z.state.rectArea,yt.ltc_1.value=z.state.rectAreaLTC1,yt.ltc_2.value=z.state.rectAreaLTC2,yt.pointLights.value=z.state.point,yt.pointLightShadows.value=z.state.pointShadow,yt.hemisphereLights.value=z.state.hemi,yt.sunShadowMatrix.value=z.state.sunShadowMatrix,yt.sunShadowCascade.value=z.state.sunShadowCascade,yt.directionalShadowMatrix.value=z.state.directionalShadowMatrix,yt.spotLightMatrix.value=z.state.spotLightMatrix,yt.spotLightMap.value=z.state.spotLightMap,yt.pointShadowMatrix.value=z.state.pointShadowMatrix),U.numLightProbeGrids=zl(w.state.lightProbeGridArray),U.currentProgram=kt,U.uniformsList=null,kt}function lu(y,P,k,U,z){let ht=At.get(y),xt=ht.currentProgram.id+","+U+","+z,lt=ht.programVariants.get(xt);return lt===void 0?(lt=Yi(y,P,k),ht.programVariants.set(xt,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=U,ht.toneMapping=z),lt}function kl(y){if(y.uniformsList===null){let P=y.currentProgram.getUniforms();y.uniformsList=Xi.seqWithValue(P.seq,y.uniforms)}return y.uniformsList}function Gl(y,P){let k=At.get(y);k.outputColorSpace=P.outputColorSpace,k.batching=P.batching,k.batchingColor=P.batchingColor,k.instancing=P.instancing,k.instancingColor=P.instancingColor,k.instancingMorph=P.instancingMorph,k.skinning=P.skinning,k.morphTargets=P.morphTargets,k.morphNormals=P.morphNormals,k.morphColors=P.morphColors,k.morphTargetsCount=P.morphTargetsCount,k.numClippingPlanes=P.numClippingPlanes,k.numIntersection=P.numClipIntersection,k.vertexAlphas=P.vertexAlphas,k.vertexTangents=P.vertexTangents,k.toneMapping=P.toneMapping}function cu(y,P,k,U,z){P.isScene!==!0&&(P=qe),It.resetTextureUnits();let ht=P.fog,xt=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?P.environment:null,lt=et===null?I.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Vt.workingColorSpace,gt=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,bt=E.get(U.envMap||xt,gt),Dt=U.vertexColors===!0&&!!k.attributes.color&&k.attributes.color.itemSize===4,kt=!!k.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),yt=!!k.morphAttributes.position,Gt=!!k.morphAttributes.normal,ce=!!k.morphAttributes.color,$t=vn;U.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&($t=I.toneMapping);let jt=k.morphAttributes.position||k.morphAttributes.normal||k.morphAttributes.color,we=jt!==void 0?jt.length:0,St=At.get(U),Ie=w.state.lights;if(de===!0&&(Ue===!0||y!==Q)){let ae=y===Q&&U.id===X;Y.setState(U,y,ae)}let qt=!1,ni=!1;U.version===St.__version?St.needsLights&&St.lightsStateVersion!==Ie.state.version||z.isBatchedMesh&&St.batching===!1||!z.isBatchedMesh&&St.batching===!0||z.isBatchedMesh&&St.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&St.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&St.instancing===!1||!z.isInstancedMesh&&St.instancing===!0||z.isSkinnedMesh&&St.skinning===!1||!z.isSkinnedMesh&&St.skinning===!0||z.isInstancedMesh&&St.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&St.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&St.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&St.instancingMorph===!1&&z.morphTexture!==null||St.envMap!==bt||U.fog===!0&&St.fog!==ht||St.numClippingPlanes!==void 0&&(St.numClippingPlanes!==Y.numPlanes||St.numIntersection!==Y.numIntersection)||St.vertexAlphas!==Dt||St.vertexTangents!==kt||St.morphTargets!==yt||St.morphNormals!==Gt||St.morphColors!==ce||St.morphTargetsCount!==we||St.numLightProbeGrids!==zl(w.state.lightProbeGridArray)?qt=!0:(St.outputColorSpace!==lt||St.toneMapping!==$t)&&(ni=!0):(qt=!0,St.__version=U.version);let Ae=St.currentProgram;(qt===!0||ni===!0)&&(Ae=ni===!0?lu(U,P,z,lt,$t):Yi(U,P,z),B&&U.isNodeMaterial&&B.onUpdateProgram(U,Ae,St));let Vs=!1,zn=!1,ii=!1,Xt=Ae.getUniforms(),Te=St.uniforms;if(ut.useProgram(Ae.program)&&(Vs=!0,zn=!0,ii=!0),U.id!==X&&(X=U.id,zn=!0),Vs||Q!==y){ut.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),Xt.setValue(L,"projectionMatrix",y.projectionMatrix),Xt.setValue(L,"viewMatrix",y.matrixWorldInverse);let ye=Xt.map.cameraPosition;ye!==void 0&&ye.setValue(L,un.setFromMatrixPosition(y.matrixWorld)),ie.logarithmicDepthBuffer&&Xt.setValue(L,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&Xt.setValue(L,"isOrthographic",y.isOrthographicCamera===!0),Q!==y&&(Q=y,zn=!0,ii=!0)}if(St.needsLights&&(Ie.state.sunShadowMap.length>0&&Xt.setValue(L,"sunShadowMap",Ie.state.sunShadowMap,It),Ie.state.directionalShadowMap.length>0&&Xt.setValue(L,"directionalShadowMap",Ie.state.directionalShadowMap,It),Ie.state.spotShadowMap.length>0&&Xt.setValue(L,"spotShadowMap",Ie.state.spotShadowMap,It),Ie.state.pointShadowMap.length>0&&Xt.setValue(L,"pointShadowMap",Ie.state.pointShadowMap,It)),z.isSkinnedMesh){Xt.setOptional(L,z,"bindMatrix"),Xt.setOptional(L,z,"bindMatrixInverse");let ae=z.skeleton;ae&&(ae.boneTexture===null&&ae.computeBoneTexture(),Xt.setValue(L,"boneTexture",ae.boneTexture,It))}z.isBatchedMesh&&(Xt.setOptional(L,z,"batchingTexture"),Xt.setValue(L,"batchingTexture",z._matricesTexture,It),Xt.setOptional(L,z,"batchingIdTexture"),Xt.setValue(L,"batchingIdTexture",z._indirectTexture,It),Xt.setOptional(L,z,"batchingColorTexture"),z._colorsTexture!==null&&Xt.setValue(L,"batchingColorTexture",z._colorsTexture,It));let tn=k.morphAttributes;if((tn.position!==void 0||tn.normal!==void 0||tn.color!==void 0)&&K.update(z,k,Ae),(zn||St.receiveShadow!==z.receiveShadow)&&(St.receiveShadow=z.receiveShadow,Xt.setValue(L,"receiveShadow",z.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&P.environment!==null&&(Te.envMapIntensity.value=P.environmentIntensity),Te.dfgLUT!==void 0&&(Te.dfgLUT.value=Yg()),zn){if(Xt.setValue(L,"toneMappingExposure",I.toneMappingExposure),St.needsLights&&hu(Te,ii),ht&&U.fog===!0&&st.refreshFogUniforms(Te,ht),st.refreshMaterialUniforms(Te,U,mt,wt,w.state.transmissionRenderTarget[y.id]),St.needsLights&&St.numLightProbeGrids>0){let ae=T,ye=0;for(let Mn of w.state.lightProbeGridArray)Mn.texture!==null&&(ae.textures[ye]=Mn.texture,ae.min[ye]=Mn.boundingBox.min,ae.max[ye]=Mn.boundingBox.max,ae.resolution[ye]=Mn.resolution,ye++);for(let Mn in ae)ae[Mn].length=ye;Te.probesSH.value=ae.textures,Te.probesMin.value=ae.min,Te.probesMax.value=ae.max,Te.probesResolution.value=ae.resolution}Xi.upload(L,kl(St),Te,It)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(Xi.upload(L,kl(St),Te,It),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&Xt.setValue(L,"center",z.center),Xt.setValue(L,"modelViewMatrix",z.modelViewMatrix),Xt.setValue(L,"normalMatrix",z.normalMatrix),Xt.setValue(L,"modelMatrix",z.matrixWorld),U.uniformsGroups!==void 0){let ae=U.uniformsGroups;for(let ye=0,Mn=ae.length;ye<Mn;ye++){let Hl=ae[ye];Tt.update(Hl,Ae),Tt.bind(Hl,Ae)}}return Ae}function hu(y,P){y.ambientLightColor.needsUpdate=P,y.lightProbe.needsUpdate=P,y.sunLights.needsUpdate=P,y.sunLightShadows.needsUpdate=P,y.directionalLights.needsUpdate=P,y.directionalLightShadows.needsUpdate=P,y.pointLights.needsUpdate=P,y.pointLightShadows.needsUpdate=P,y.spotLights.needsUpdate=P,y.spotLightShadows.needsUpdate=P,y.rectAreaLights.needsUpdate=P,y.hemisphereLights.needsUpdate=P}function uu(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(y,P,k){let U=At.get(y);U.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),At.get(y.texture).__webglTexture=P,At.get(y.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:k,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,P){let k=At.get(y);k.__webglFramebuffer=P,k.__useDefaultFramebuffer=P===void 0},this.setRenderTarget=function(y,P=0,k=0){et=y,q=P,G=k;let U=null,z=!1,ht=!1;if(y){let lt=At.get(y);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(L.FRAMEBUFFER,lt.__webglFramebuffer),$.copy(y.viewport),Mt.copy(y.scissor),Lt=y.scissorTest,ut.viewport($),ut.scissor(Mt),ut.setScissorTest(Lt),X=-1;return}else if(lt.__webglFramebuffer===void 0)It.setupRenderTarget(y);else if(lt.__hasExternalTextures)It.rebindTextures(y,At.get(y.texture).__webglTexture,At.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){let Dt=y.depthTexture;if(lt.__boundDepthTexture!==Dt){if(Dt!==null&&At.has(Dt)&&(y.width!==Dt.image.width||y.height!==Dt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");It.setupDepthRenderbuffer(y)}}let gt=y.texture;(gt.isData3DTexture||gt.isDataArrayTexture||gt.isCompressedArrayTexture)&&(ht=!0);let bt=At.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(bt[P])?U=bt[P][k]:U=bt[P],z=!0):y.samples>0&&It.useMultisampledRTT(y)===!1?U=At.get(y).__webglMultisampledFramebuffer:Array.isArray(bt)?U=bt[k]:U=bt,$.copy(y.viewport),Mt.copy(y.scissor),Lt=y.scissorTest}else $.copy(Ct).multiplyScalar(mt).floor(),Mt.copy(Yt).multiplyScalar(mt).floor(),Lt=Kt;if(k!==0&&(U=H),ut.bindFramebuffer(L.FRAMEBUFFER,U)&&ut.drawBuffers(y,U),ut.viewport($),ut.scissor(Mt),ut.setScissorTest(Lt),z){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+P,lt.__webglTexture,k)}else if(ht){let lt=P;for(let gt=0;gt<y.textures.length;gt++){let bt=At.get(y.textures[gt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+gt,bt.__webglTexture,k,lt)}}else if(y!==null&&k!==0){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,lt.__webglTexture,k)}X=-1};function Vl(y){let P=At.get(y);return(P.__readFormat!==y.format||P.__readType!==y.type)&&(P.__readFormat=y.format,P.__readType=y.type,P.__formatReadable=ie.textureFormatReadable(y.format),P.__typeReadable=ie.textureTypeReadable(y.type)),P}this.readRenderTargetPixels=function(y,P,k,U,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget)){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt){ut.bindFramebuffer(L.FRAMEBUFFER,gt);try{let bt=y.textures[lt],Dt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Vl(bt);if(yt.__formatReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(yt.__typeReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}P>=0&&P<=y.width-U&&k>=0&&k<=y.height-z&&L.readPixels(P,k,U,z,it.convert(Dt),it.convert(kt),ht)}finally{let bt=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,bt)}}},this.readRenderTargetPixelsAsync=async function(y,P,k,U,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt)if(P>=0&&P<=y.width-U&&k>=0&&k<=y.height-z){ut.bindFramebuffer(L.FRAMEBUFFER,gt);let bt=y.textures[lt],Dt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Vl(bt);if(yt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(yt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Gt=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,Gt),L.bufferData(L.PIXEL_PACK_BUFFER,ht.byteLength,L.STREAM_READ),L.readPixels(P,k,U,z,it.convert(Dt),it.convert(kt),0),L.bindBuffer(L.PIXEL_PACK_BUFFER,null);let ce=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,ce);let $t=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await ch(L,$t,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,Gt),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,ht),L.bindBuffer(L.PIXEL_PACK_BUFFER,null),L.deleteBuffer(Gt),L.deleteSync($t),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,P=null,k=0){let U=Math.pow(2,-k),z=Math.floor(y.image.width*U),ht=Math.floor(y.image.height*U),xt=P!==null?P.x:0,lt=P!==null?P.y:0;It.setTexture2D(y,0),L.copyTexSubImage2D(L.TEXTURE_2D,k,0,0,xt,lt,z,ht),ut.unbindTexture()},this.copyTextureToTexture=function(y,P,k=null,U=null,z=0,ht=0){let xt,lt,gt,bt,Dt,kt,yt,Gt,ce,$t=y.isCompressedTexture?y.mipmaps[ht]:y.image;if(k!==null)xt=k.max.x-k.min.x,lt=k.max.y-k.min.y,gt=k.isBox3?k.max.z-k.min.z:1,bt=k.min.x,Dt=k.min.y,kt=k.isBox3?k.min.z:0;else{let Xt=Math.pow(2,-z);xt=Math.floor($t.width*Xt),lt=Math.floor($t.height*Xt),y.isDataArrayTexture?gt=$t.depth:y.isData3DTexture?gt=Math.floor($t.depth*Xt):gt=1,bt=0,Dt=0,kt=0}U!==null?(yt=U.x,Gt=U.y,ce=U.z):(yt=0,Gt=0,ce=0);let jt=it.convert(P.format),we=it.convert(P.type),St;P.isData3DTexture?(It.setTexture3D(P,0),St=L.TEXTURE_3D):P.isDataArrayTexture||P.isCompressedArrayTexture?(It.setTexture2DArray(P,0),St=L.TEXTURE_2D_ARRAY):(It.setTexture2D(P,0),St=L.TEXTURE_2D),ut.activeTexture(L.TEXTURE0),ut.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,P.flipY),ut.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),ut.pixelStorei(L.UNPACK_ALIGNMENT,P.unpackAlignment);let Ie=ut.getParameter(L.UNPACK_ROW_LENGTH),qt=ut.getParameter(L.UNPACK_IMAGE_HEIGHT),ni=ut.getParameter(L.UNPACK_SKIP_PIXELS),Ae=ut.getParameter(L.UNPACK_SKIP_ROWS),Vs=ut.getParameter(L.UNPACK_SKIP_IMAGES);ut.pixelStorei(L.UNPACK_ROW_LENGTH,$t.width),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,$t.height),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,bt),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Dt),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,kt);let zn=y.isDataArrayTexture||y.isData3DTexture,ii=P.isDataArrayTexture||P.isData3DTexture;if(y.isDepthTexture){let Xt=At.get(y),Te=At.get(P),tn=At.get(Xt.__renderTarget),ae=At.get(Te.__renderTarget);ut.bindFramebuffer(L.READ_FRAMEBUFFER,tn.__webglFramebuffer),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,ae.__webglFramebuffer);for(let ye=0;ye<gt;ye++)zn&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(y).__webglTexture,z,kt+ye),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(P).__webglTexture,ht,ce+ye)),L.blitFramebuffer(bt,Dt,bt+xt,Dt+lt,yt,Gt,yt+xt,Gt+lt,L.DEPTH_BUFFER_BIT,L.NEAREST);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(z!==0||y.isRenderTargetTexture||At.has(y)){let Xt=At.get(y),Te=At.get(P);ut.bindFramebuffer(L.READ_FRAMEBUFFER,_),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,V);for(let tn=0;tn<gt;tn++)zn?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Xt.__webglTexture,z,kt+tn):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Xt.__webglTexture,z),ii?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Te.__webglTexture,ht,ce+tn):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Te.__webglTexture,ht),z!==0?L.blitFramebuffer(bt,Dt,bt+xt,Dt+lt,yt,Gt,yt+xt,Gt+lt,L.COLOR_BUFFER_BIT,L.NEAREST):ii?L.copyTexSubImage3D(St,ht,yt,Gt,ce+tn,bt,Dt,xt,lt):L.copyTexSubImage2D(St,ht,yt,Gt,bt,Dt,xt,lt);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else ii?y.isDataTexture||y.isData3DTexture?L.texSubImage3D(St,ht,yt,Gt,ce,xt,lt,gt,jt,we,$t.data):P.isCompressedArrayTexture?L.compressedTexSubImage3D(St,ht,yt,Gt,ce,xt,lt,gt,jt,$t.data):L.texSubImage3D(St,ht,yt,Gt,ce,xt,lt,gt,jt,we,$t):y.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,ht,yt,Gt,xt,lt,jt,we,$t.data):y.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,ht,yt,Gt,$t.width,$t.height,jt,$t.data):L.texSubImage2D(L.TEXTURE_2D,ht,yt,Gt,xt,lt,jt,we,$t);ut.pixelStorei(L.UNPACK_ROW_LENGTH,Ie),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,qt),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,ni),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Ae),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,Vs),ht===0&&P.generateMipmaps===!0&&P.mipmapsAutoUpdate===!0&&L.generateMipmap(St),ut.unbindTexture()},this.initRenderTarget=function(y){At.get(y).__webglFramebuffer===void 0&&It.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?It.setTextureCube(y,0):y.isData3DTexture?It.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?It.setTexture2DArray(y,0):It.setTexture2D(y,0),ut.unbindTexture()},this.resetState=function(){q=0,G=0,et=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return je}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Vt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Vt._getUnpackColorSpace()}};var Yh=.5,Jh=.012,Za=new F(0,0,1),Kh=.15,Xa=Math.PI/180,Qh=60*Xa,Zi=i=>new vs({color:i}),Jg=Zi("#e8eaee"),jh=Zi("#9aa3b2"),Al=Zi("#5c6675"),Kg=Zi("#3d4653"),jg=Zi("#c9723c"),Qg=Zi("#8a6d3b"),$g=new $e({color:"#b3261e"}),t0=new $e({color:"#6a1b9a",wireframe:!0}),e0=new Yn({color:"#1f2937"}),n0=new Yn({color:"#5b4a2a"}),i0=new $e({color:"#1565c0",wireframe:!0,depthTest:!1});function On(i,t,e,n=20){let s=new Bi(i,i,t,n);return s.rotateX(Math.PI/2),new pe(s,e)}var ti=(i,t=0)=>new F(i[t],i[t+1],i[t+2]);function qa(i,t,e){let n=e.clone().sub(t);i.position.copy(t).addScaledVector(n,.5),i.scale.z=Math.max(n.length(),1e-6),i.quaternion.setFromUnitVectors(Za,n.normalize())}var Ya=class extends Ve{constructor(t){super(),this.shaft=On(.012,1,t,8),this.head=new pe(new ms(.032,.07,10).rotateX(Math.PI/2),t),this.add(this.shaft,this.head)}show(t,e){let n=Jh*e.length();if(this.visible=n>.012,!this.visible)return;let s=t.clone().addScaledVector(e,Jh);qa(this.shaft,t,s),this.head.position.copy(s),this.head.quaternion.copy(this.shaft.quaternion)}},Ja=class extends Ve{constructor(t,e){super(),this.believes=e,this.position.y=t,this.rotation.z=Qh;let n=On(.1,.06,jh);n.position.z=.03,this.add(n),this.limbs=Array.from({length:8},(a,o)=>On(o<5?.055:.045,1,Jg)),this.joints=Array.from({length:7},(a,o)=>On(o<5?.068:.055,o<5?.15:.12,jh)),this.flange=new Ve;let s=On(.05,.02,Al),r=new pe(new Dn(.05,.19,.05),Al);r.position.z=.035,this.flange.add(s,r);for(let a of[-1,1]){let o=new pe(new Dn(.02,.015,.05),Al);o.position.set(0,a*.055,.085),this.flange.add(o)}this.objects=new Ve,this.flange.add(this.objects),this.belief=new pe(new zi(1,12,8),i0),this.belief.matrixAutoUpdate=!1,this.flange.add(this.belief),this.bag=new pe(new zi(.06,14,10),Qg),this.string=new Ui(new _e().setFromPoints([new F,Za]),n0),this.target=new Ve,this.target.add(new pe(new xs(.085,.006,6,28),new $e({color:"#1f2937"}))),this.stream=On(.008,1,new $e({color:"#3b82c4"}),8),this.sag=On(.004,1,new $e({color:"#1f2937"}),6),this.push=new Ya($g),this.felt=new Ya(t0),this.add(...this.limbs,...this.joints,this.flange,this.bag,this.string,this.target,this.sag,this.stream,this.push,this.felt)}update(t,e,n,s){let r=t("links"),a=M=>[ti(r,7*M),new Qe(...r.slice(7*M+3,7*M+7))],o=new F;for(let M=0;M<8;++M){let[A,T]=a(M);this.limbs[M].visible=A.distanceTo(o)>.001,this.limbs[M].visible&&qa(this.limbs[M],o,A),M<7?(this.joints[M].position.copy(A),this.joints[M].quaternion.copy(T)):(this.flange.position.copy(A),this.flange.quaternion.copy(T),this.target.quaternion.copy(T),this.target.position.copy(A).sub(ti(t("error"))),this.sag.visible=ti(t("error")).length()>.004,this.sag.visible&&qa(this.sag,this.target.position,A)),o=A}let c=ti(t("hand")),l=c.clone().add(new F(.07,.03,.35));this.stream.visible=s,qa(this.stream,l,l.clone().setZ(c.z-.05)),this.bag.visible=this.string.visible=n,n&&(this.bag.position.copy(ti(t("bag"))),this.string.geometry.setFromPoints([c,this.bag.position])),this.push.show(c,e),this.felt.show(c,this.believes?ti(t("force")):new F);let h=t("mean"),f=t("com_covariance");this.belief.visible=this.believes&&t("held")[0]>.5&&Math.max(f[0],f[4],f[8])<Kh*Kh;let d=2*Math.sqrt(f[0]),m=2*f[1]/Math.sqrt(f[0]),g=2*f[2]/Math.sqrt(f[0]),S=Math.sqrt(Math.max(4*f[4]-m*m,1e-8)),p=(4*f[5]-m*g)/S,u=Math.sqrt(Math.max(4*f[8]-g*g-p*p,1e-8));this.belief.matrix.set(d,0,0,h[1],m,S,0,h[2],g,p,u,h[3],0,0,0,1),this.belief.matrixWorldNeedsUpdate=!0}hold(t){this.objects.clear();for(let{mass:e,com:n,kind:s}of t){let r=.05*Math.cbrt(Math.max(e,.05)),a=s==="cup"?On(.045,.03+.06*e,jg):On(r,1.6*r,Kg);a.position.copy(ti(n)),a.add(new Oi(new gs(a.geometry,30),e0)),this.objects.add(a)}}};function s0(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;return t!==void 0&&/swiftshader|llvmpipe|software/i.test(i.getParameter(t))}var Ka=class{constructor(t){this.canvas=t,this.renderer=new Va({canvas:t,antialias:!s0()}),this.scene=new ls,this.scene.background=new Ft("#f4f6f8"),this.camera=new Le(32,1,.1,10),this.camera.up.copy(Za),this.azimuth=0,this.elevation=12*Xa;let e=new Es("#ffffff",2);e.position.set(2,-1,3);let n=new ws(3,15,"#b8c0cc","#dde2e8");n.rotation.x=Math.PI/2,this.arms={without:new Ja(-Yh,!1),with:new Ja(Yh,!0)},this.wall=new pe(new hi(1,1.1,5,5),new $e({color:"#37474f",wireframe:!0})),this.wall.rotation.x=Math.PI/2,this.scene.add(new Ms("#ffffff","#b0b6bf",2),e,n,...Object.values(this.arms)),this.walls=Object.values(this.arms).map(s=>{let r=this.wall.clone();return s.add(r),r}),this.ratio=Math.min(devicePixelRatio,2),this.interval=this.drawn=0,this.resize(),new ResizeObserver(()=>this.resize()).observe(t)}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.look())}look(){let t=Math.tan(this.camera.fov*Xa/2),e=Math.max(.58/t,.98/(t*this.camera.aspect))+.45,n=new F(.15,.18,.45),s=Math.cos(this.elevation);this.camera.position.set(s*Math.cos(this.azimuth),s*Math.sin(this.azimuth),Math.sin(this.elevation)).multiplyScalar(e).add(n),this.camera.lookAt(n),this.camera.updateMatrixWorld()}turn(t,e){this.azimuth=Math.min(Math.max(this.azimuth-.006*t,-1.2),1.2),this.elevation=Math.min(Math.max(this.elevation+.006*e,0),1.2),this.look()}handAt(t){let n=this.arms[t].flange.localToWorld(new F(0,0,.1)).project(this.camera);return{x:(n.x+1)/2*this.canvas.clientWidth,y:(1-n.y)/2*this.canvas.clientHeight}}inArms(t,e){let n=this.camera.position.distanceTo(this.arms.with.position),s=2*Math.tan(this.camera.fov*Xa/2)*n/this.canvas.clientHeight,r=new Qt().extractRotation(this.camera.matrixWorld);return new F(t*s,-e*s,0).applyMatrix4(r).applyAxisAngle(Za,-Qh)}draw(t,e){let n=JSON.stringify(e);for(let[r,a]of Object.entries(this.arms))a.update(o=>t(`${r}.${o}`),ti(t("push")),t("hanging")[0]!==0,t("pour")[0]>0),n!==this.held&&a.hold(e);this.held=n;let s=t("wall_at");for(let r of this.walls)r.visible=t("constrained")[0]!==0,r.position.set(.4,s[0]+.1,.5);this.renderer.render(this.scene,this.camera),this.adapt()}adapt(){let t=performance.now(),e=t-this.drawn;this.drawn=t,e<1e3&&(this.interval+=(e-this.interval)/10),!(this.interval<45||this.ratio<.6)&&(this.interval=0,this.ratio*=.8,this.resize())}};var eu=["hand is empty","holds it steadily","is being filled","something pushes","payload is changing"],$h=["","attached","exchanged","removed","filled","only a push"],Rl=300,r0=100,Xe=i=>document.getElementById(i),zs=new Worker(URL.createObjectURL(new Blob([Wl],{type:"text/javascript"}))),Cl=new Hs,Pl,Il,$a,hn=0,Ll=1,Qa=0,to=[],ks=[],eo=!0,tu=!1,_l=0,ja=-1,ue=i=>{let[t,e]=Pl[i];return Il.subarray(t,t+e)},nu=i=>zs.postMessage({command:i});function a0(i){eo=!1,nu(i)}zs.onmessage=({data:i})=>{if(i.fields&&(Pl=i.fields,to=[],ks=[],_l=0,Cl.clear()),i.frames){for(Il of i.frames)Cl.add(ue);hn=i.ticks,i.busy&&(Qa+=(i.busy-Qa)*.05),eo&&l0()}i.command&&(i.accepted?o0(i.command,i.at):gi("A Panda is rated for 3 kg: that would be too much.")),i.paused&&au()};function o0(i,t){to.push(`${t} ${i}`);let[e,...n]=i.split(" ");e==="attach"&&ks.push({kind:+n[0]===Ji?"cup":"weight",mass:+n[0],com:n.slice(1).map(Number)}),e==="drop"&&(ks=[])}function l0(){!tu&&hn>=Rl&&nu(ro(1.2,0)),tu=hn>=Rl,hn<Rl?gi("Both hands are empty."):hn<4e3?gi("Both hands were given 1.2 kg. Nobody told the arms."):gi("Your turn: drag a weight onto a hand, or pull at a hand.")}function gi(i){Xe("caption").textContent!==i&&(Xe("caption").textContent=i)}function Fe(i,t,e,n=""){let s=Xe(i);s.dataset.value=t;let r=t.toFixed(e)+n;s.textContent!==r&&(s.textContent=r)}function iu(){let i=ue("with.mean"),t=ue("with.deviation"),e=ue("with.payload"),n=g=>Math.hypot(...g);Fe("error-without",1e3*n(ue("without.error")),1),Fe("error-with",1e3*n(ue("with.error")),1),Fe("mass",i[0],3),Fe("mass-deviation",t[0],3),Fe("truth",e[0],3);for(let g=0;g<3;++g)Fe(`com-${g}`,1e3*i[g+1],1),Fe(`com-deviation-${g}`,1e3*t[g+1],1),Fe(`com-truth-${g}`,1e3*e[g+1],1);let s=ue("with.probability"),r=s.indexOf(Math.max(...s));eu.forEach((g,S)=>{let p=Xe("modes").children[S];p.classList.toggle("likeliest",S===r),p.querySelector("i").style.width=`${100*s[S]}%`,Fe(`mode-${S}`,100*s[S],1," %")}),[...ue("with.force"),...ue("with.moment")].forEach((g,S)=>{let p=Math.max(-1,Math.min(1,g/(S<3?40:4))),u=Xe("wrench").children[S].querySelector("i");u.style.left=`${50+50*Math.min(p,0)}%`,u.style.width=`${50*Math.abs(p)}%`,Fe(`wrench-${S}`,g,S<3?1:2,S<3?" N":" N m")});let o=ue("with.health")[0],[c,l]=ue("with.limit");Fe("health",o,1),Xe("health-word").textContent=o<3?"good":"not explained",Fe("confidence",100*ue("with.confidence")[0],0," %"),Fe("friction",100*ue("with.friction_shows")[0],0," %"),Fe("wall",1e3*ue("with.wall")[0],0," mm"),Xe("limit").textContent=`joint ${c}, ${(l*180/Math.PI).toFixed(0)}\xB0 away`,Qa>0&&Fe("speed",1/Qa,1);let[h,f,d,m]=ue("with.event");ue("with.changing")[0]?Xe("noticed").textContent="something is happening":h>0&&(Xe("noticed").textContent=`${$h[f]}: noticed ${Math.round(1e3*(m-d))} ms after it began`),h>_l&&!eo&&gi(`rme: ${$h[f]}, ${i[0].toFixed(2)} kg.`),_l=h}function su(){requestAnimationFrame(su),Il&&($a?.draw(ue,ks.map(i=>i.kind==="cup"?{...i,mass:ue("poured")[0]}:i)),!(ja>=0&&hn>=ja&&hn<ja+r0)&&(ja=hn,iu(),ql(Xe("history"),Cl)))}function ru(i,t,e){for(let[n,s]of t.entries())Xe(i).insertAdjacentHTML("beforeend",`<li><span>${s}</span><span class="bar"><i></i></span><output id="${e}-${n}"></output></li>`)}Xe("save").addEventListener("click",()=>{let i=document.createElement("a");i.href=URL.createObjectURL(new Blob([to.join(`
`)+`
`])),i.download=`session-seed-${Ll}-until-${hn}.txt`,i.click()});ru("modes",eu,"mode");ru("wrench",["force x","force y","force z","moment x","moment y","moment z"],"wrench");tc();try{$a=new Ka(Xe("scene"))}catch{gi("This browser draws no three dimensions (WebGL). The numbers are those of the arms all the same.")}Xl({act:a0,get:ue,say:gi,view:$a,held:()=>ks,restart:()=>{eo=!1,zs.postMessage({start:++Ll})}});requestAnimationFrame(su);var au;globalThis.rme={pause:()=>new Promise(i=>{au=()=>{iu();let t=Object.fromEntries(Object.keys(Pl).map(e=>[e,[...ue(e)]]));i({ticks:hn,seed:Ll,session:to.join(`
`),numbers:t})},zs.postMessage({paused:!0})}),resume:()=>zs.postMessage({paused:!1}),ticks:()=>hn,handAt:i=>$a.handAt(i)};})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
