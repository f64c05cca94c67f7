(()=>{var Wl=`(()=>{var Ut=(()=>{var p=typeof document<"u"&&document.currentScript?document.currentScript.src:void 0;return(function(n){n=n||{};var n=typeof n<"u"?n:{},g,F;n.ready=new Promise(function(e,t){g=e,F=t});var de=Object.assign({},n),me=[],be="./this.program",Xe=(e,t)=>{throw t},Le=!1,U=!0,H="";function Ge(e){return n.locateFile?n.locateFile(e,H):H+e}var Qe,Ie,re,qe;(Le||U)&&(U?H=self.location.href:typeof document<"u"&&document.currentScript&&(H=document.currentScript.src),p&&(H=p),H.indexOf("blob:")!==0?H=H.substr(0,H.replace(/[?#].*/,"").lastIndexOf("/")+1):H="",Qe=(e=>{var t=new XMLHttpRequest;return t.open("GET",e,!1),t.send(null),t.responseText}),U&&(re=(e=>{var t=new XMLHttpRequest;return t.open("GET",e,!1),t.responseType="arraybuffer",t.send(null),new Uint8Array(t.response)})),Ie=((e,t,r)=>{var a=new XMLHttpRequest;a.open("GET",e,!0),a.responseType="arraybuffer",a.onload=(()=>{if(a.status==200||a.status==0&&a.response){t(a.response);return}r()}),a.onerror=r,a.send(null)}),qe=(e=>document.title=e));var Ce=n.print||console.log.bind(console),O=n.printErr||console.warn.bind(console);Object.assign(n,de),de=null,n.arguments&&(me=n.arguments),n.thisProgram&&(be=n.thisProgram),n.quit&&(Xe=n.quit);var _t=4;function V(e){V.shown||(V.shown={}),V.shown[e]||(V.shown[e]=1,O(e))}function $t(e,t){if(typeof WebAssembly.Function=="function"){for(var r={i:"i32",j:"i64",f:"f32",d:"f64"},a={parameters:[],results:t[0]=="v"?[]:[r[t[0]]]},l=1;l<t.length;++l)a.parameters.push(r[t[l]]);return new WebAssembly.Function(a,e)}var f=[1,0,1,96],u=t.slice(0,1),o=t.slice(1),y={i:127,j:126,f:125,d:124};f.push(o.length);for(var l=0;l<o.length;++l)f.push(y[o[l]]);u=="v"?f.push(0):f=f.concat([1,y[u]]),f[1]=f.length-2;var X=new Uint8Array([0,97,115,109,1,0,0,0].concat(f,[2,7,1,1,101,1,102,0,0,7,5,1,1,102,0,0])),L=new WebAssembly.Module(X),Y=new WebAssembly.Instance(L,{e:{f:e}}),b=Y.exports.f;return b}var Ne=[],Pe;function en(){if(Ne.length)return Ne.pop();try{B.grow(1)}catch(e){throw e instanceof RangeError?"Unable to grow wasm table. Set ALLOW_TABLE_GROWTH.":e}return B.length-1}function tn(e,t){for(var r=e;r<e+t;r++){var a=ue(r);a&&Pe.set(a,r)}}var nn=0,M;n.wasmBinary&&(M=n.wasmBinary);var Ue=n.noExitRuntime||!0;typeof WebAssembly!="object"&&J("no native wasm support detected");var E,ie=!1,xe;function rn(e,t){e||J(t)}function Ve(e){var t=n["_"+e];return t}function Ee(e,t,r,a,l){var f={string:function(d){var w=0;if(d!=null&&d!==0){var I=(d.length<<2)+1;w=pe(I),Ae(d,w,I)}return w},array:function(d){var w=pe(d.length);return we(d,w),w}};function u(d){return t==="string"?A(d):t==="boolean"?!!d:d}var o=Ve(e),y=[],X=0;if(a)for(var L=0;L<a.length;L++){var Y=f[r[L]];Y?(X===0&&(X=je()),y[L]=Y(a[L])):y[L]=a[L]}var b=o.apply(null,y);function h(d){return X!==0&&De(X),u(d)}return b=h(b),b}var an=1,He=typeof TextDecoder<"u"?new TextDecoder("utf8"):void 0;function he(e,t,r){for(var a=t+r,l=t;e[l]&&!(l>=a);)++l;if(l-t>16&&e.subarray&&He)return He.decode(e.subarray(t,l));for(var f="";t<l;){var u=e[t++];if(!(u&128)){f+=String.fromCharCode(u);continue}var o=e[t++]&63;if((u&224)==192){f+=String.fromCharCode((u&31)<<6|o);continue}var y=e[t++]&63;if((u&240)==224?u=(u&15)<<12|o<<6|y:u=(u&7)<<18|o<<12|y<<6|e[t++]&63,u<65536)f+=String.fromCharCode(u);else{var X=u-65536;f+=String.fromCharCode(55296|X>>10,56320|X&1023)}}return f}function A(e,t){return e?he(Z,e,t):""}function Re(e,t,r,a){if(!(a>0))return 0;for(var l=r,f=r+a-1,u=0;u<e.length;++u){var o=e.charCodeAt(u);if(o>=55296&&o<=57343){var y=e.charCodeAt(++u);o=65536+((o&1023)<<10)|y&1023}if(o<=127){if(r>=f)break;t[r++]=o}else if(o<=2047){if(r+1>=f)break;t[r++]=192|o>>6,t[r++]=128|o&63}else if(o<=65535){if(r+2>=f)break;t[r++]=224|o>>12,t[r++]=128|o>>6&63,t[r++]=128|o&63}else{if(r+3>=f)break;t[r++]=240|o>>18,t[r++]=128|o>>12&63,t[r++]=128|o>>6&63,t[r++]=128|o&63}}return t[r]=0,r-l}function Ae(e,t,r){return Re(e,Z,t,r)}function _e(e){for(var t=0,r=0;r<e.length;++r){var a=e.charCodeAt(r);a>=55296&&a<=57343&&(a=65536+((a&1023)<<10)|e.charCodeAt(++r)&1023),a<=127?++t:a<=2047?t+=2:a<=65535?t+=3:t+=4}return t}var sn=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0;function we(e,t){W.set(e,t)}function $e(e,t,r){for(var a=0;a<e.length;++a)W[t++>>0]=e.charCodeAt(a);r||(W[t>>0]=0)}var We,W,Z,et,tt,v,nt,rt,it;function Ke(e){We=e,n.HEAP8=W=new Int8Array(e),n.HEAP16=et=new Int16Array(e),n.HEAP32=v=new Int32Array(e),n.HEAPU8=Z=new Uint8Array(e),n.HEAPU16=tt=new Uint16Array(e),n.HEAPU32=nt=new Uint32Array(e),n.HEAPF32=rt=new Float32Array(e),n.HEAPF64=it=new Float64Array(e)}var un=n.INITIAL_MEMORY||16777216,B,ge=[],Oe=[],ze=[],at=!1,st=!1,ut=0;function ot(){return Ue||ut>0}function lt(){if(n.preRun)for(typeof n.preRun=="function"&&(n.preRun=[n.preRun]);n.preRun.length;)ct(n.preRun.shift());se(ge)}function ft(){at=!0,se(Oe)}function on(){st=!0}function pt(){if(n.postRun)for(typeof n.postRun=="function"&&(n.postRun=[n.postRun]);n.postRun.length;)yt(n.postRun.shift());se(ze)}function ct(e){ge.unshift(e)}function vt(e){Oe.unshift(e)}function yt(e){ze.unshift(e)}var z=0,ae=null,S=null;function dt(e){z++,n.monitorRunDependencies&&n.monitorRunDependencies(z)}function mt(e){if(z--,n.monitorRunDependencies&&n.monitorRunDependencies(z),z==0&&(ae!==null&&(clearInterval(ae),ae=null),S)){var t=S;S=null,t()}}n.preloadedImages={},n.preloadedAudios={};function J(e){n.onAbort&&n.onAbort(e),e="Aborted("+e+")",O(e),ie=!0,xe=1,e+=". Build with -s ASSERTIONS=1 for more info.";var t=new WebAssembly.RuntimeError(e);throw F(t),t}var bt="data:application/octet-stream;base64,";function Ye(e){return e.startsWith(bt)}var N;N="live.wasm",Ye(N)||(N=Ge(N));function Te(e){try{if(e==N&&M)return new Uint8Array(M);if(re)return re(e);throw"both async and sync fetching of the wasm failed"}catch(t){J(t)}}function Xt(){return!M&&(Le||U)&&typeof fetch=="function"?fetch(N,{credentials:"same-origin"}).then(function(e){if(!e.ok)throw"failed to load wasm binary file at '"+N+"'";return e.arrayBuffer()}).catch(function(){return Te(N)}):Promise.resolve().then(function(){return Te(N)})}function Lt(){var e={env:ke,wasi_snapshot_preview1:ke};function t(u,o){var y=u.exports;n.asm=y,E=n.asm.memory,Ke(E.buffer),B=n.asm.__indirect_function_table,vt(n.asm.__wasm_call_ctors),mt("wasm-instantiate")}dt("wasm-instantiate");function r(u){t(u.instance)}function a(u){return Xt().then(function(o){return WebAssembly.instantiate(o,e)}).then(function(o){return o}).then(u,function(o){O("failed to asynchronously prepare wasm: "+o),J(o)})}function l(){return!M&&typeof WebAssembly.instantiateStreaming=="function"&&!Ye(N)&&typeof fetch=="function"?fetch(N,{credentials:"same-origin"}).then(function(u){var o=WebAssembly.instantiateStreaming(u,e);return o.then(r,function(y){return O("wasm streaming compile failed: "+y),O("falling back to ArrayBuffer instantiation"),a(r)})}):a(r)}if(n.instantiateWasm)try{var f=n.instantiateWasm(e,t);return f}catch(u){return O("Module.instantiateWasm callback failed with error: "+u),!1}return l().catch(F),{}}var ln,fn;function se(e){for(;e.length>0;){var t=e.shift();if(typeof t=="function"){t(n);continue}var r=t.func;typeof r=="number"?t.arg===void 0?ue(r)():ue(r)(t.arg):r(t.arg===void 0?null:t.arg)}}function pn(e){return e}function cn(e){var t=/\\b_Z[\\w\\d_]+/g;return e.replace(t,function(r){var a=r;return r===a?r:a+" ["+r+"]"})}var G=[];function ue(e){var t=G[e];return t||(e>=G.length&&(G.length=e+1),G[e]=t=B.get(e)),t}function vn(){var e=new Error;if(!e.stack){try{throw new Error}catch(t){e=t}if(!e.stack)return"(no stack trace available)"}return e.stack.toString()}function yn(e,t){B.set(e,t),G[e]=t}function Nt(e){return Fe(e+16)+16}function xt(e){this.excPtr=e,this.ptr=e-16,this.set_type=function(t){v[this.ptr+4>>2]=t},this.get_type=function(){return v[this.ptr+4>>2]},this.set_destructor=function(t){v[this.ptr+8>>2]=t},this.get_destructor=function(){return v[this.ptr+8>>2]},this.set_refcount=function(t){v[this.ptr>>2]=t},this.set_caught=function(t){t=t?1:0,W[this.ptr+12>>0]=t},this.get_caught=function(){return W[this.ptr+12>>0]!=0},this.set_rethrown=function(t){t=t?1:0,W[this.ptr+13>>0]=t},this.get_rethrown=function(){return W[this.ptr+13>>0]!=0},this.init=function(t,r){this.set_type(t),this.set_destructor(r),this.set_refcount(0),this.set_caught(!1),this.set_rethrown(!1)},this.add_ref=function(){var t=v[this.ptr>>2];v[this.ptr>>2]=t+1},this.release_ref=function(){var t=v[this.ptr>>2];return v[this.ptr>>2]=t-1,t===1}}var Ht=0,ht=0;function Rt(e,t,r){var a=new xt(e);throw a.init(t,r),Ht=e,ht++,e}function wt(){J("")}function Wt(e,t,r){Z.copyWithin(e,t,t+r)}function Kt(){return 2147483648}function gt(e){try{return E.grow(e-We.byteLength+65535>>>16),Ke(E.buffer),1}catch{}}function Ot(e){var t=Z.length;e=e>>>0;var r=Kt();if(e>r)return!1;let a=(y,X)=>y+(X-y%X)%X;for(var l=1;l<=4;l*=2){var f=t*(1+.2/l);f=Math.min(f,e+100663296);var u=Math.min(r,a(Math.max(e,f),65536)),o=gt(u);if(o)return!0}return!1}var oe={};function zt(){return be||"./this.program"}function Q(){if(!Q.strings){var e=(typeof navigator=="object"&&navigator.languages&&navigator.languages[0]||"C").replace("-","_")+".UTF-8",t={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:e,_:zt()};for(var r in oe)oe[r]===void 0?delete t[r]:t[r]=oe[r];var a=[];for(var r in t)a.push(r+"="+t[r]);Q.strings=a}return Q.strings}var le={buffers:[null,[],[]],printChar:function(e,t){var r=le.buffers[e];t===0||t===10?((e===1?Ce:O)(he(r,0)),r.length=0):r.push(t)},varargs:void 0,get:function(){le.varargs+=4;var e=v[le.varargs-4>>2];return e},getStr:function(e){var t=A(e);return t},get64:function(e,t){return e}};function Yt(e,t){var r=0;return Q().forEach(function(a,l){var f=t+r;v[e+l*4>>2]=f,$e(a,f),r+=a.length+1}),0}function Tt(e,t){var r=Q();v[e>>2]=r.length;var a=0;return r.forEach(function(l){a+=l.length+1}),v[t>>2]=a,0}function _(e){return e%4===0&&(e%100!==0||e%400===0)}function fe(e,t){for(var r=0,a=0;a<=t;r+=e[a++]);return r}var $=[31,29,31,30,31,30,31,31,30,31,30,31],ee=[31,28,31,30,31,30,31,31,30,31,30,31];function te(e,t){for(var r=new Date(e.getTime());t>0;){var a=_(r.getFullYear()),l=r.getMonth(),f=(a?$:ee)[l];if(t>f-r.getDate())t-=f-r.getDate()+1,r.setDate(1),l<11?r.setMonth(l+1):(r.setMonth(0),r.setFullYear(r.getFullYear()+1));else return r.setDate(r.getDate()+t),r}return r}function kt(e,t,r,a){var l=v[a+40>>2],f={tm_sec:v[a>>2],tm_min:v[a+4>>2],tm_hour:v[a+8>>2],tm_mday:v[a+12>>2],tm_mon:v[a+16>>2],tm_year:v[a+20>>2],tm_wday:v[a+24>>2],tm_yday:v[a+28>>2],tm_isdst:v[a+32>>2],tm_gmtoff:v[a+36>>2],tm_zone:l?A(l):""},u=A(r),o={"%c":"%a %b %d %H:%M:%S %Y","%D":"%m/%d/%y","%F":"%Y-%m-%d","%h":"%b","%r":"%I:%M:%S %p","%R":"%H:%M","%T":"%H:%M:%S","%x":"%m/%d/%y","%X":"%H:%M:%S","%Ec":"%c","%EC":"%C","%Ex":"%m/%d/%y","%EX":"%H:%M:%S","%Ey":"%y","%EY":"%Y","%Od":"%d","%Oe":"%e","%OH":"%H","%OI":"%I","%Om":"%m","%OM":"%M","%OS":"%S","%Ou":"%u","%OU":"%U","%OV":"%V","%Ow":"%w","%OW":"%W","%Oy":"%y"};for(var y in o)u=u.replace(new RegExp(y,"g"),o[y]);var X=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],L=["January","February","March","April","May","June","July","August","September","October","November","December"];function Y(i,s,m){for(var c=typeof i=="number"?i.toString():i||"";c.length<s;)c=m[0]+c;return c}function b(i,s){return Y(i,s,"0")}function h(i,s){function m(R){return R<0?-1:R>0?1:0}var c;return(c=m(i.getFullYear()-s.getFullYear()))===0&&(c=m(i.getMonth()-s.getMonth()))===0&&(c=m(i.getDate()-s.getDate())),c}function d(i){switch(i.getDay()){case 0:return new Date(i.getFullYear()-1,11,29);case 1:return i;case 2:return new Date(i.getFullYear(),0,3);case 3:return new Date(i.getFullYear(),0,2);case 4:return new Date(i.getFullYear(),0,1);case 5:return new Date(i.getFullYear()-1,11,31);case 6:return new Date(i.getFullYear()-1,11,30)}}function w(i){var s=te(new Date(i.tm_year+1900,0,1),i.tm_yday),m=new Date(s.getFullYear(),0,4),c=new Date(s.getFullYear()+1,0,4),R=d(m),K=d(c);return h(R,s)<=0?h(K,s)<=0?s.getFullYear()+1:s.getFullYear():s.getFullYear()-1}var I={"%a":function(i){return X[i.tm_wday].substring(0,3)},"%A":function(i){return X[i.tm_wday]},"%b":function(i){return L[i.tm_mon].substring(0,3)},"%B":function(i){return L[i.tm_mon]},"%C":function(i){var s=i.tm_year+1900;return b(s/100|0,2)},"%d":function(i){return b(i.tm_mday,2)},"%e":function(i){return Y(i.tm_mday,2," ")},"%g":function(i){return w(i).toString().substring(2)},"%G":function(i){return w(i)},"%H":function(i){return b(i.tm_hour,2)},"%I":function(i){var s=i.tm_hour;return s==0?s=12:s>12&&(s-=12),b(s,2)},"%j":function(i){return b(i.tm_mday+fe(_(i.tm_year+1900)?$:ee,i.tm_mon-1),3)},"%m":function(i){return b(i.tm_mon+1,2)},"%M":function(i){return b(i.tm_min,2)},"%n":function(){return\`
\`},"%p":function(i){return i.tm_hour>=0&&i.tm_hour<12?"AM":"PM"},"%S":function(i){return b(i.tm_sec,2)},"%t":function(){return"	"},"%u":function(i){return i.tm_wday||7},"%U":function(i){var s=new Date(i.tm_year+1900,0,1),m=s.getDay()===0?s:te(s,7-s.getDay()),c=new Date(i.tm_year+1900,i.tm_mon,i.tm_mday);if(h(m,c)<0){var R=fe(_(c.getFullYear())?$:ee,c.getMonth()-1)-31,K=31-m.getDate(),T=K+R+c.getDate();return b(Math.ceil(T/7),2)}return h(m,s)===0?"01":"00"},"%V":function(i){var s=new Date(i.tm_year+1900,0,4),m=new Date(i.tm_year+1901,0,4),c=d(s),R=d(m),K=te(new Date(i.tm_year+1900,0,1),i.tm_yday);if(h(K,c)<0)return"53";if(h(R,K)<=0)return"01";var T;return c.getFullYear()<i.tm_year+1900?T=i.tm_yday+32-c.getDate():T=i.tm_yday+1-c.getDate(),b(Math.ceil(T/7),2)},"%w":function(i){return i.tm_wday},"%W":function(i){var s=new Date(i.tm_year,0,1),m=s.getDay()===1?s:te(s,s.getDay()===0?1:7-s.getDay()+1),c=new Date(i.tm_year+1900,i.tm_mon,i.tm_mday);if(h(m,c)<0){var R=fe(_(c.getFullYear())?$:ee,c.getMonth()-1)-31,K=31-m.getDate(),T=K+R+c.getDate();return b(Math.ceil(T/7),2)}return h(m,s)===0?"01":"00"},"%y":function(i){return(i.tm_year+1900).toString().substring(2)},"%Y":function(i){return i.tm_year+1900},"%z":function(i){var s=i.tm_gmtoff,m=s>=0;return s=Math.abs(s)/60,s=s/60*100+s%60,(m?"+":"-")+("0000"+s).slice(-4)},"%Z":function(i){return i.tm_zone},"%%":function(){return"%"}};u=u.replace(/%%/g,"\\0\\0");for(var y in I)u.includes(y)&&(u=u.replace(new RegExp(y,"g"),I[y](f)));u=u.replace(/\\0\\0/g,"%");var ve=jt(u,!1);return ve.length>t?0:(we(ve,e),ve.length-1)}function Ft(e,t,r,a){return kt(e,t,r,a)}var dn=!1;function jt(e,t,r){var a=r>0?r:_e(e)+1,l=new Array(a),f=Re(e,l,0,l.length);return t&&(l.length=f),l}var ke={__cxa_allocate_exception:Nt,__cxa_throw:Rt,abort:wt,emscripten_memcpy_big:Wt,emscripten_resize_heap:Ot,environ_get:Yt,environ_sizes_get:Tt,strftime_l:Ft},mn=Lt(),Dt=n.___wasm_call_ctors=function(){return(Dt=n.___wasm_call_ctors=n.asm.__wasm_call_ctors).apply(null,arguments)},Mt=n._live_start=function(){return(Mt=n._live_start=n.asm.live_start).apply(null,arguments)},Zt=n._live_command=function(){return(Zt=n._live_command=n.asm.live_command).apply(null,arguments)},Bt=n._live_step=function(){return(Bt=n._live_step=n.asm.live_step).apply(null,arguments)},St=n._live_values=function(){return(St=n._live_values=n.asm.live_values).apply(null,arguments)},Jt=n._live_layout=function(){return(Jt=n._live_layout=n.asm.live_layout).apply(null,arguments)},Fe=n._malloc=function(){return(Fe=n._malloc=n.asm.malloc).apply(null,arguments)},Gt=n.___errno_location=function(){return(Gt=n.___errno_location=n.asm.__errno_location).apply(null,arguments)},je=n.stackSave=function(){return(je=n.stackSave=n.asm.stackSave).apply(null,arguments)},De=n.stackRestore=function(){return(De=n.stackRestore=n.asm.stackRestore).apply(null,arguments)},pe=n.stackAlloc=function(){return(pe=n.stackAlloc=n.asm.stackAlloc).apply(null,arguments)},Qt=n.dynCall_viijii=function(){return(Qt=n.dynCall_viijii=n.asm.dynCall_viijii).apply(null,arguments)},It=n.dynCall_iiiiij=function(){return(It=n.dynCall_iiiiij=n.asm.dynCall_iiiiij).apply(null,arguments)},qt=n.dynCall_iiiiijj=function(){return(qt=n.dynCall_iiiiijj=n.asm.dynCall_iiiiijj).apply(null,arguments)},Ct=n.dynCall_iiiiiijj=function(){return(Ct=n.dynCall_iiiiiijj=n.asm.dynCall_iiiiiijj).apply(null,arguments)};n.ccall=Ee;var ne;function Pt(e){this.name="ExitStatus",this.message="Program terminated with exit("+e+")",this.status=e}S=function e(){ne||ce(),ne||(S=e)};function ce(e){if(e=e||me,z>0||(lt(),z>0))return;function t(){ne||(ne=!0,n.calledRun=!0,!ie&&(ft(),g(n),n.onRuntimeInitialized&&n.onRuntimeInitialized(),pt()))}n.setStatus?(n.setStatus("Running..."),setTimeout(function(){setTimeout(function(){n.setStatus("")},1),t()},1)):t()}n.run=ce;function bn(e){xe=e,ot()||(n.onExit&&n.onExit(e),ie=!0),Xe(e,new Pt(e))}if(n.preInit)for(typeof n.preInit=="function"&&(n.preInit=[n.preInit]);n.preInit.length>0;)n.preInit.pop()();return ce(),n.ready})})(),Me=Ut;var Ze="H4sIAAAAAAACA+y9f5xcR3UnWj/u7R9ze2buSCNppNGPutdCamn0Y2SCRmOEZ0rYQtn3stHbfZ88fd7nw5OELEdu+YdsC6LsajVtbJMO8EJnA6FxQtwaOUtjiLcDJGkMidt2gDZxQvO7wbLcJqzdLNjpJIY04MVP51Tde6vvjMTse+x7/7y2Nfecb/2uW7fOqapTVeTo3bdRQgitWW85Qufo3BE6R46wOfWHzh3hc0DDXzp3JDGHPzp3xJpD3A54RZDAB1Ee6NyR1NxcGIiepWePJCOeYMBz586dI0cICV10tOcwM/QscOeiKM8d4XNnNXcWHufOzZEjA3NzRkKYi3MQgYoTSXtu7mxYlrPg5yzy7Cxki50FkM2dgzKc1fFk5ub64sV8naVzR5x+3EidHBme6/+RqA7IEXoWMnAOs3H2rK4vXRzgMb9nz+piYwntOeWEBaZn0acKP6cLqMphqeKljYQZeuFnddkgNIWqYFhzUPHgrB4M65adO0f/A/49CxV1jhxh54L3fQ7rfm6O/gcjETrHWjTFj9/+jrHDh4+dOXr46K233nHs6Onjh4+fOXb81Olb7ridEHB2lPPpE3fd8RvEAmTF8dvuPnbXLadOH7/98G3Hbzt26jcPv+2WXyc2uK003O46fvct/+744RPHj55SUdlH33bHXafJyMrfOHr3LYfvvv3oqbtP3HH68Km7jr/jluO/sWvk+O3vuOWuO24/DMHuPvzrx08TfgWvTuAVPUHcA3efvuvm07fcdvzwrSTFn7Qft0copXQrGaHDwxOrRhkdSzC2jbI0p5xbFl1F6XZmMWoRTi1GWTrNduxMrqeTZNdY8tqEZVkW45ZlDVgW5ZQmLctaZY2OWSOUwX9Ji1kWtyz2estijNn0lxh7wwaWtCjdvWGYWlZ6XZoyxgidSiaTA8lBsWd60LbswetGRwfhJ97oDZJhQjkjBL9kQpm9wk/a3CKEEG7Dg1JGKOGEE5uAR04I55rlhDCbEUIgL5QwixDgOOF8BR8hNAlRcsZUEMYY0JQRn5DVbLXr7n3T9S5zV7uum5yZlc4+btuccIjYS1nEenP6GubYnDuUOOSGlSuTNJW0bPiXIIwNcW4zzilJEGuNk0ysTDgJJ7Eykd54Y2J9IplIDts2pwkyxBPcWpOAX3pjIpFI2oSwFCGc8lQyZS9LMJsuTy1/ne0sI+OpFKEpgABZNp7KcJJIJAYSA4l0KpPhET00wPgQlgmysgne0xCQUHrgh+BJ+FqyOcvsxNrN2YQ9MEAoVDFhnFKoWMqgfdiO43Cb246dIlQTmVSKZuxMKkVIimQy6h+Fl8T0D18WQov8R8kw4YQyxgm8F3wl4J/DbwtJW5ZlM3tLmrGkbVvJZJInk1Z6IJ1OD0AmCaHDlCwb2r/GStJT9DPsM8xOUppn+TxLpOkclc2HniBO8j+ykcRtx2+7467fZGTk8OHfOHr3bYePHb311sPHTt9x190kNXDrLe84fvju00fvOk0GM8gcu+O2247efhMZSmu346eI6yD9jqO3vv343WREcbce/c073n6aLFt9+PAtt990y13Hj50+fPPbbz8GvcLh00ffdutxShK3YY9B/oS6hw8fv+uu2+84jB0IdBwfp+m7Tx89dvLfHn3HcfKEnUHm3xy/+/Qddx0nT9oDyEsM/tf20E2/efubIePvuOWW3C23kM9FyC3wy5HP28P9SI58wXb7IMAadrpnUSKp8yhLO5m6/RS9j/4OfR8t0Br9NH2UfoZ+lv4V/QT9BH2MPkn/mn6efoF+nn6RPk3/hv4tfRf7LXYvK7Cf0dfoPey32bvZe9h72R+yD7NH2VPsi+xp9gj9JH3Y+rj1XesF63vW962XrH+w/tH6Z+uH1r9YP7Z+av036zXrgvWfrI9ZNevT1qPWZ6zPWn9pvcD/ynrMqlsl66+tz1lfsJ6yvmh9gj5t/a31desb1resb1vPWM9abeubVsv6B9qlF61L1vPWU7TFWuxPrEes/2xVrT+1PmF90vqU9QL/M+vPrb+wWuxx63HrCetT9FP0SetTtMX+zvqS9YQFZWtaX7Za7CvWVzX/NevLGNu32LfZRQbUs+wSa7MWe569zF5hP2I91mM/Ya+yPH8nv4+32Hv4+/jv8ffzD/AP8N/nH+QP8D/gf8hbbJ5X+J/yT/BP8k/xT/NHeYt9hv8Vf5L/Nf8c/zxv8Kc4xP40/1v+d/xL/Mv8q/wb/O+tjvUDq2e9anWtVyzl/i3+bf4Mf5Y/x7/D/4v1X62XrZ9YP7P+yfqRdY+dt/+ew98XeYt9j3+P/1f87/v8E/QH/AdXwF7iL2ns5atiXf4j3mJ5616rxd5tFa0W+13r/VaLfcD6fetRCs8PWo/Sp+j77fuxnj5JP0k/bn/W/rT9iN1in7Fr9n+2W+xR+8/sT9gt9pjdYn9pP24X7cftx+2Bf/nH1Y/bj3HK5q4h0j3pk42EzQoiMzlBZCrn2oNEPvR+JkiWZSQ7La2c+yfUp7sZEfTGQQJ4ChFrFvxlGQm85iTZzUgAUjdx4yB1gEXcEUS6uY1E1l+h2wmR9M4brVlZe4Xuq/3l+y/+0bsfee6xuSlOZPUVuo8AUblM5NWvp5zKgVP9FSrpdYQ4soUQI7IZEI2AaAdE5xWKObiGyEksryAQjVCPMUGCHHxzZopnBdn30woC356Z4m4/m+pniey+Qm+4GX/fmBFEjuUEce+hsvVDndN2QHR+SPc98MkXnv7QJ1+4qEIGLr2AyP8oqgvwIoichAorvJ/J0u8xqNv67zG5FSpzgsi/foVmGfGQwPIJYsGLLL1Mcu6AIPjvEeo4X6SUzcFLeu9bPSoI+H3vWwW1ZgVGwIQOzqxZwSCEoPj38psuhCEKOkTgUjoUuJQOKReMLcusEYrv+slrc9sIkeQAZCrLateqkPIZrw9vegrfRv7ZDcGOG4BOiKmynKNsTn4NS+4Taxbev1BlB2d4+eCC+ZFPK4btt+YEtfmsYHL0pEcEk+mTZhaISsxjggj6lkESRON4BOIQNIzfWU3k91+hQWBoYkHGvjrArDl6jp0T5AaCv+6bj4U0ITffCYn9aYY6+4jj2bLwHHU/YHvsGiLr9KRPNxLBhC2Ju1xSjwuGr1HYkrrLBZOfukhzkryRQubJbla9SAWDRlMDQtYv0hw2IcFkw6CbBt0KaFn7MXx/8PEVfkTde+F/2XFy7v0UnPR3lf+Z9iSwcdaoelb1s6KfZf0s6WeRyvqPqaCyQnOCyiLNuTlBze+rAD71J/Sdy608b/BfnJniZ1REp9TjhKD78Jt5+kP/PDPFj8jmTyD2HoHY20TFbnxWh4zIoc84GDl/DfgDKtpZI1qA90T894GflO2fQjoNTGdSJfODC8//8Mvdn7TBQ1bFI6LkvjIDXQmirhEb9hn6++6+CnGO5QR1c1DBWNX6dXjcEUy2L9Kcb8nmj+kWjhFZsqHplLCgapGG99mDFtH6MeTR/QO6Bt72szQnqz+JvDQAqBhAHYCyAbQAqBlAG4C6AXQAaAQAmxVc0jsHyZWbjm45g+T/bzj/YxsOtJf8JZoLWwu2CnxdBhA0me6z0FEULsUbTftSrNG0LsUaTfNSrNF0LsUaTfdSrNH0LpmNRvVU+eegDHUKAk1LLgqEYKhZYIetJRfFf9Cpfv8oe91c8qxSVFZFIZkg7seoz+WpX7Zm2Sw2S+dXLXi4OXnqTj8JfastVomkBP3hzF27WUqsEjaktUrw3czKUAeo64gjVnm24KCrCFsQwaFmHMGFnZPkOkIE84gkXvIaIrv8pM+go5Zf+yDdze5jUIEfRCHDd7MGFVxmToLuw2SD5nLyu+iGohV67aepYFnWoH2efMe3wXFU2FDZNAdRjQnEMsLe985yPt8mU8wSkMndzBW2FDlJZNb9MF0jbLk2537EEg6qSqem2IG+3NWBwozl349ijIM+9xFLcFCNxtTDVY+U4N469bK6Wrz0oNGkdrM8xNWFGJoUK1vk/GF/QKzy7bdYc2LAfZWCqLD1c0DYWZaCKh8Q9hYGSliGO8J2f0Q9Kmz3x9RLqXdqo/KZkgO/gsFS7u8wMSCoSLmPU6iD68iwSIkBEITDOfd9DN7agByAECfFwHbi+I4kwhEpQd0P246wUcXMsP7EHDMxRwy4/436qV+GFKExQS4dt8QgEuH0Jez0JyxSkp6E1E5KmoPAlp+SBPz1JS+JLQYcaEPwErdBhWXZpG/L1J3WnOBi2P0RFcPuj2luN9sW8T+i4G+b+0/4nLSF7Uj3TlC5Ofr2bfSEgYbFsPsT6v6U9gXHON1/poJvJ5OSQ1g+C6U5gJ/Ga6+99lrSfQXKh+RJz85QxxG2SsN2X6GOaqn1QL2gWt/QfAX4Gs0FNTqwkYgBmcqptuwPuX9H4a2k4KMUTqi9OVlG1LfkQGz47TkA6AdxxJAYAk/4ZeT8VJZlPAsbxANMZVZYwpLkfx73bDEkx3LeoBiQn/p95r7APC4G3I9akngpNsch5UEzMvg6rSzL+MPCyjL3LdasGAaBi7mwACNZtnGEEN+Sc28ZJJJlmMNmhSXHTsuxt/vDkhyA+skyEMGv0TslPZ3bTqgUUL8SG5sjht2HbGgeOS/1czKw35oNk82OELJG5WNYwpvNQB+UQh2UeilJHM+KqsYfhOhUxzAkkPEH4eli5Vh3idT4Xe4fMPhEoB2qdwb5wdcDn3LOfZ76HAoT5G47caUNEp14nM1y3ZuKJNQTF2yCp6ahCxdcpi63vI9TyG0S+rEK9e2TPpf87b4jac5XPS371UEqkoJL9nY/JZIi9T+N4/uDLqgH7/GXx/2UNSdSgW9LpCQ/7X7AtiVx/KRwJD+d850w5SS657yUcGQq5+FH9a+sWZGE/lB11UykVBMVDuRQMJHczSpUtWsblfufXwEcylSlHpbt49Tj8Gm4h4kjL6xwj4C0FQyUk92sTJGuAf2Him4AXcLOMqdHYH7SXY+F8LJs1vxvERkAWWD4pbMs+ywVbDt5EnOpmqAkB8Zl4i3gDKnKHy+XCfePbeX941S/DH5SCvDDJzjxN4fjjptuHKQgvkRWbC5rNDV7/MZBC14qVnKXKdKd5j1Njk3zPBfM1JA6TDBz7NuO8S2oiALPic0gKxjUdovl3HvCWmn+gOSUF/ecIPoFN28VRLbQZQt31aC3rTyO5fyk1iCI7ChM5Hw7xLoKy+b8VKjQqKqY4MTL/o8qX/YK5et8G4R3WMLo4yGy+21qFrAHbFS2/DM0J6JiFYANSpThzv/tJmNFTea7o9JatMm4V2syUH0mai3SiIgsXqQ50Pit6BNJwfuVqZyfxG6O4BvB6Ny1+vsQgRMBJ4JOv6DCfmToCoVNoR/sFC8/grklGFtwnWH9irmqkmwwkp+5aVxkw5o4Nj7ByTRvXqS/oAy/vPwKGR4L3o6XxdrzNguCI3xszv5W1bpg+C82Iy2y0zgnQGQFQO2hHHmQJaCzii7Ce9B+CkBHkeRv/wWV7cnhRcoGzsRdJ5LuOvj8w2kKnJD7xdXroyuv1hD6XjEhN0O0AevOHsNU8Mt2j8InfJHqTolHnZLCXKOjgq88NcXb+A56yh06raCDIjhMhzESqDlhTA0FdknOd0Kw/qzqNU7o1JSfIs35w6GftgILNOcPhGBLB8xTNR5L5bxBNqeK39eu5TGjWeMMVfZjGeqA3jH03zlPpOexrI1EWFp1tPTA39Kqo6UH/pYe+FvGwN/Cgb+lB/5WbOBvxQb+Vv/A31IDf0sN/K2FA38LB/6WHvhb/QN/Kzbwt2IDf0sN/K3YwN9aZOBv4cDfUgN/Kzbwt9TA3+of+Ftq4G/1D/ytaOBvwcDfgvj06DmaABgUQ7JIb/WHYA4gp6eMAGwEbArZesASMQixDcEcQC5okuCj+hPt4xSylYA9gWw5YI8gWwvYMyr2gM1TlXjAF+AbgCkKEX0yMEEh4l8LTE4QnJwQxocCUxMi+kRgYkJEHwdMS5gfxyWzyROckxDRFwEzEiL8amDSN/8cjJGf+4V14cuu1tWozib80t7m8+vIn10EITt4DZFN+6Sf3khE0lcz7slwxj0Jii4osKCTQ17SssxyAguMX6JIw/ipDE/oO5JqlIXgAZHGboGL9ASvMOjZ09h5UACqGiDXkRIVaS0Mm1+o42tF/KB6ZEVa0t1so+KESAft91Fsv2loi65I73v1q5//4LNPlSrYftOQRvlyGnnIWp7lRFrWWM5PuGtEGtqxb4n0Fl5iU5iLGs35KQCKGqjCaBKAggKAzDPsRdKgLHScad5AWnadnBLHiu1ptqXYfEaxbcUWNNtRbFGzXcWWNNvTqRTfigXg4PQsUW5EQFstR6x+JbLyLMm5a4QlErqZYYGqmH8sSiUqSlkXBepOiDQ7K5LbCazepGHVCyM+BLWg6SOQiKYPwpLZBCcwDkvLJr708ivBVFsSwuiOIAlx6V4AUzqlgzrT/IRsdoj7AdvnXkKoya22XoVIXG43KZiFfhw+RD8Bb/2ESKgmZW0nJ6xZkYB+zk8Jaws/oIpqbeGHIFGkDmIXNsGPeJtEAlI+IRJi0zQ/4ogE4Kem+SmgsH2mgr4CgDy896AzSUBcZ6A9glOJBrKxpJ2KFMSHomsURQ7SVYpiB+kKxZpGukxR/CDdpTjLhXSHTkGDQLpNp6CtIN2iU9CMkG7SKWhhSDfoFDQ+pOt0itepGFI6Wgoem6GIZ6DogSD5weUvpcREIlA5X52Z4kUmEqBvFeAJChdTddSjqqP3YLahTHPeEJsVm8Sm8/5WsfVtoKKIbEhvFpuRPuoNOmJQnnfkZwfB8zz4mgfn+XL5QXdMUvkVV75nSPdAvRmEnlsjnx+84YEPwe9bM+6YoKCqDCpVjMK4aljTpq48FrH5up4SN5z3CIrlV1+KNcHzdBpmsoEs0GmY4waySHXCn54RznZCxqf5pEjAp+SPiKA1I+VCsxoRFBrlMt2cRyBzoyqPKwLPkPmVqgyOGcEY5Bki2BPoSHuUw+QUnxQjcvakoHL2ZDiwpBN80tALbxLZDwX60tyxO+XfZuRjy0TWHRN2vwIZ9/jxEfmeIfRIJ/iYj2/EwSBArQiocvnBq0Ty3uXyg+sxkgEMYDjK/Li8dxjdlmHzk8RbxmYFqnhbxdbz/maxOWwxmqYwbsBms1lsPuotc8Qy+Z0haDZbxVbdbNCPzpo7JkbC3K/UMc+LURwxYvPyN0WZt2bFiNgsNj3ob7owzbNiRGwVQAkxIrJIjTm4kuE7YgjfDDQ0N+cPAOsqNpXzbWBTyIqh4LUErey+OupRCdlhOX952FiWQ7QZFftIiLk5f5lKYjTEUjl/hUpnZYBBmQXkE57+FuN1bOl7HS/DVyS2qHdK/C1ii64VoMqqWhAcCcHyg2F83cfKH7rh1Y/+41d+5W0HZ47Jxxx5wcXIlofhVoQViy9V1XYGKPisy2WzqVizYrnYJLIP+lmoWbFcbBVAuWK52IxUSiwXW5AijhgOBPcTaFwwGNTne+v99Yv8WLRA9cSMWplSruWP1YlamtLeP6KCJ2SRY/3rKs2or1O9iSyyIviAhdDvSb2TMWTd4FN2kQ3fTkpk5CQseDQIrnhgxRttTmzqe0P3jcryerHJHVPv5coeX8gEHldc3eO71wQeR5ea9LKlJj2y1KQpaMLYYQ0DlcU3CJQAygEKv6YBoPBDsoHS31Bq0W/I6LkLdewWE7JgwccYvMSBsJtEKgtvEikBL3Eg7F0Hwo56QH/A+tUNBL2rGeEeSAo6T2+rJJ4ddFko5HQ3ZXZffV2WBsbigIgD2TgwaXR7uFTzL+lQWuJXhukAVS6rJAJUKFTFGoCT2it2kXSC7/G3RiNpsbXvNd4zKJvjYqvyOHsVjx8blY9rj8GbmYc3U6cRUKwHy+oaeKgerK8HYvi1YIHdBEpxoBgHCnEgHwf0GnsrjjdpLMMNA3i0Hqz7m0FOKT3A9TeJ5AQvZ8pKYdgEaiuq4WWlNgBQDQBXA7UAGNNAPQCEBhoBkNVAMwAmBYUUWxmx6fw0qCvQRJOyje6IQT6SshMBBxDoRsBBBHoRcAiB/GAIHEGgEAGgQjctVOu2kzG0l7L0QMVROSoOTmOtJGVpUA0uziBX1hy8DagdzRYUW9VsUbE1zZaAqSPjbYqq/uF4a/pgrDV1PxZrTdWngtcH2mmZqoW/1RuJSPl22FHYaO3gr0d2Etlszt+gO39bdf5Cd/626vw93fnbqvP3dedvqx7kGt2D2FGPEWpqG41UYSDyOuQPIA8jokHkDyLfIsGI4hDybRJMnx1BvkNyvqvnOjCtU9A2waVMc/4YupQpAjACWR6MQGxlpeJnECgqAMYzI8F4BgAYzywLxjO2MkDRUu+MSk4PUGwc8q4ApIpTGDYOikGfhed4UGIcO6eUJYW/1qyHcHjUUCk1wynBpgJaNOevQQC+X6VxQMd1TH7alU+mA63mlKn+yA8PyHuUwnONCrFxghMzhFJ5Fg3hqxCvi4VYduUQngoxGAsxcuUQQoUYioXIXDnEBhViOBZi+ZVDrFch3FiIsSuHcGJOMS3ytZWBFjkQj+NHAyDxwWlNv9PN8o9Wy8+vWswJFMEtYq0aUIxrBVJkj437m+YjYTN7XF7YIMsqhtXwia0RQQNaLYIGtkJsBY1RYAw3jT8w716gfva82CKCiNoz8+GySHne3wLKpbBBD31gXgBXoWKlWB1OgqyJGukEb1HV6BoUY34AAzSoI1arFesEO4v9443WrE5k36yn9aP8zbO4VL5AZdL09bPzkXY8e/xOXVzQnrKhp7E6lmjzecjw4iXKXvA2iWA17Pr6vMhecKZ5NRGN3x9EEWcAqDLXE2oEX0v0G6Yd7GfBksyYK9ujOv/8UCB3CkM5P4V9eAr54lDOH0LeVcJhKOcPIj+mxMNQzh9GXij5MJTzHeSzIB6Gcv5AIASMae9Z1Z/DmLuZyPlu2JO7qicf0T25q3ryZbond1VPPqp7clf15Ct0T+6qnnyl7sndfl3QDXtyN+zJlxupQk8+pntyV/fkGd2Tu2JM9+GuyOje24W+WxJZTuC4YCy2iCk2931zP1sFH9bmoG+4sscnRgOP7r6n/+XVT77wexVYSCgksbP0NgtXFj5HtG2Yi0sZSfUs62clKVy0mkkKN2xY8EWVH7w8OiuCaxljkE8yzLor//4LJIeT+lCqL6DbfQnt1v1b5Cs0Gv4YuZePDchHlmF+7Ss7rbyy04orO41e2WnZlZ1GruyEevKVq741EFT98qu/ow8ugzmY0OPWsJb/OOwZujOY2oMX/M1ik9h80zg2EBF5fWje34rd3Nabxi+EaVX3zusR+pGZ4/LxDfJhlSGrX5FqPlbHz6Ofz8Z4EePHYrwb41MxHkbVna+TnNgkqLv5cncDisUhkZD5VtAAcV629Wsw/G4RvYqakCWDLht0xaCrBl0L6bCcunikz2SV9JmqkshEtb+Lg4FkHRSv/ukAo1vJ9Hcrmf5uJdPfrWT6u5VMf7eCX+WEyEB3NisyYgKU+ozY9AC6XHDnKSjwGehOJJH/pCYRMqAvSZj0RtYcdQtDttwp71ktzw+pETi03SsP1Z9KGR5NAXVz5HFSHr9TPrJGvlON6e2lely5VI8rlupxdKkely3V48hSPWZ0BaFdTkZVwgRa5mRUQbehbU5GFWbLNBhnZFSGs9O8CIzqfKZ5CRhMeOs02O9kYEK9Dc/sNNjrZMSWad6E57Zp3mCqcdSZais1eG6d5mUuErL7bPQxdAy6HdE48H1rvCOof7a/I1B8NsaLGD8W490Yn4rxkJXes7ojGAWZ3SbR8mZCNoB1QrYO7HDI1oAdDNkqsEMhWwE2mCBKwNpsfmiKl4+IhGy1TUmUkO0XkP8o1XyjE3VD9Y7RnRh01aArBl026FKnr5aLJ4QlZ0+qFbGEbH2D5LyksKSA0XNiO8kfQvxywvlDTvBCkiKlF+SQckF9QmpMbJoH3QmZFGhNSWVAXfh53/7LY8Ennbr6NN0jKXlpXeAx1f8VYNjjd8o/Xi6LoZ+xxb8UjOzry+Rfhh5hegQjAB0xZWbuxRXyn9aiN1xhg5qgsg0GAiJcRQZDd1hFhpVjXEaGFUMbDKRxt0mJ5rxhWd3kOcrwUwyDPRZalJrGkWoVHGx4/QGwurfBnwXGqJYYBBPsvkVxWO4eBLtvtRo+nGUp7TXLyEmZ2j8I9rLQgTuytQktXVubPMcRYAcPAJqeZbijH4LI6kVcxrazzMqFRizRYjq0PzDbXwl2p+5KsJxNOsECPJr1M6iIj1PBlS3oNvIkVYbJLMtqVBuIXryKIX/HMOTXZvAQzU+jaLoqmnVuDbdV3Mdy7l+AZWCXwxtJelysCs2hVwVbzlapQQ8fdtxh4qSI/KNRMDVtcWbP0bNgBfCvrFk+G+6XgFVaprcg6O0SPldmpiS0yrs52LPVvIhFp+5RQQVzx6HfbV6kfqJv4IgGRSIRLkvMy/wmWdqk7Bp7uBlHG26Cac45iGqC9yhabtLQcjPP1NpNW/MFzXc0X9S8NtksscD6BCznPbCV/H+QPzS8tMIcWkEOMUFteRlksKf5IINoe2lkEI0v+zPIXU9tbsw/R9FIG7ey6NxG+cLh7UVanoa/sDGEwbu1wTTaFgQauuN8ncGbPXcNkUIttoMmo1+vezzYvWiBhXjf7kVribsXrUV2L1p9uyOhHCnYSYobG7ewzBTsvoHRSqDRXXF3JQb1uAMegB710QnWADxbxbEWQ9gYJ2wpGRUczcgpmL9jSfgSS8KhJJii48G4mIPRO3jQ2fPAVQrs7pxKkqVVtRap3tC8yDZNlFTyu3qzLJi5fR9oANuagN6mR6I3wjBfZ3wOj7O+vX9Qbcr1EthfJvS2W6Ulc+jlOHSIYAcbdIi+Ne4zaARUnvpVtY+AeEk0BKdqzxKTI7hnKQV7lqgg2jYe9ixNwo7U3SwLllK72TaY/iCCXUdeL4jM5jwqGPZvaHEvrPHLX5H6pATTchm8SQF7E3BvMs+yjPtRYGZP+gxdoWRjeufydnKNT82cg+NamKkedy/YPqrdlu4I4cUzonbAwQYf2J2BuNwTpAj9ItnNDqo9JGh3hRMAB1SN7cH95pAnV+UJpmYhU2BDB7vMlTvZTpYvzFXm6rk6tCBXMGIaMLN1qi9bh/w0zABjxg5BexDpj4CVFWRlG7nbZ5A0xaRvFQy2gQgKya9B57AJnwj2LR8LoUMBtDyEUgH0b0PoQAC9OYT2BNA1ITQWQK8PoSxCXI6iiHzLIM0wB8UJON5HffgAlSIQyD9s0WrHNrbq2P5o3v9d8uC7pIL7DL9KiMDxuGqbZ1Ws+nvzuP7Y4COG/hh3y0F1clAOnJ89QPnIXOIsg481b+MOIjbr3kt9C8Xjv8bcWqGhnqX2kamGDy8Z/ljuedvh4HFQNuitPs/52P7RNBdXJpNgcYgrk0i5yhwqmxMcvgdtYYj27WiKhJ7Q0AgpsCHMU0UXKM7lJ1EKcfgbmk3CRz0ok6pKIM8FZ4oXoAspOWCtWXJyof1hEZGigZQRKTu5yOCxlMFgGSMYIkUDKSBSMJA8InkD6WHUPSOxLiLdCEGzJ2eKd3TWy5kpXs6AFRvGVjFiqyJSNZAaIjUDqSNSN5AGIg0DaSLSNMsyiGUZNMqCSN5AehiqZ4TqItI1kA4iHQNpI9LO9JW3lZmCVT+ki4NTvDgIdY4plowUy4iUDaSCSMVAqohUDaSGSM1A6ojUB/vy0Bic4g1It4muTcN/C5GWgbQRaRtIB5GOWT+I9Ayki0jXzO0Q5nbIKBEiFQMpI1I2kBIiJQMpIlI0kAIihaG+MsLwMT+k6NrQFK8NQW2gz7oRtoFIw0CaiDQNpIVIy0DaiLQNpINIpz8P3aEp3oV0e+jaM/znh7GNDRulQKRgIEVEigZSQqRkIGVEysN96VaGp3hlGOocXauG/xoiNQOpI1I3kAYiDQNpItI0kBYirf5028NTvA3pdtC1Y/jvItI1kB4iPQPJo3l53jXqBJGCgRQRKbp96ZbcKV5yoTbQtWz4ryBSMZAqIlUDqSFSM5C6MnQ3kAYijf50m+4Ub0K6bXRtG/5biLQMpOPmQOPqlzLJUMokTSmT7JcyYKEdkzSyMJIzpQ0Y3eZHclriANdzc1rqAFcciYkd2RrJadED7m0V9ozy3VGcMmNPyq5iC5rtjVxVCMnueC4QRPha18blUG88LocKaxfIofy6uBzqrY3Loe7auBzqrI3LofbauBxqrY3JIdlcmwtkEeZmXS4QR9jm1sWlUWldXBqV18WlUWVdXBpV18WlUW1dXBp118WlUWddXBq118WlUWtdXBo118WlUWNdTBrJuipmSxezp1gQSvja1sdlUmF9XCYV18dlUml9XCaV18dlUmV9TCbJ6vpcIJewWtbHxVJ9fVwsNdbHxVJzfVwstdfHxVJrfVwslTbExVJxQ1wsFTbExVJ+Q1ws9dbHxVJ3fUwsyY4qJogmrJkNuUA6YbVsiAun6oa4cKptiAun+oa4cGpsiAun5oaYcJItlXRXJ93eEJdPnQ1x+dTdEJdPvQ1x+ZQXcflUEDH5JIsiF8gorH8RF1FlERdRFREXUVURF1E1ERdRdRETUbKhkm7rpJsiLqVaIi6l2iIupToiLqW6Ii6leiImpWTeywWSCqvFiwuqohcXVCUvLqjKXlxQVby4oKp6MUElayrppk664cVlVd2Ly6qm9wuVVV1vgazqeKasanumrOp5cVlV901Z1fBNWdX0+2RVy++TVW3/6rKqta1PVnW2xWVVe1tcVnW3LZBVne1xWdXeHpdVre1xWdXcHpdVje1xWVXfHpdVte19sqq7vU9W9bbHZVV+R1xWFXbEZVVxR1xWlXbEZVV5R1xWtXbEZVVzR1xWNXbEZVV9R1xW1XbEZVV1R1xWVXb0yar2jj5Z1dkRl1XdHXFZ1dsRl1X5nXFZVdgZl1XFnXFZVdrZJ6vKO+OyqrIzLquqO+OyqrYzLqsaO+Oyqr4zLqvyk3FZ1dsZl1XdnXFZ1dkZl1XtnXFZ1doZl1XNnX2yqjDZJ6uKk3FZVZqMy6ryZFxWVSbjsqo6GZdVtcm4rKpP9smqxmRcVjUn47KqNRmXVe3JuKzqTMZlVXcyLqt6k32yKr8rLqsKu+KyqrgrLqtKu+KyqrwrLqsqu+KyqrqrT1bVdsVlVX1XXFY1dsVlVXNXXFa1dsVlVXtXXFZ1dvXJqu6uuKzq7YrLqvy1cVlVuDYuq4rXxmVV6dq4rCpf2yerqtfGZVXl2risql37C5VVrWsXyKrmtaasalxryqr2tXFZVXm9KauqrzdlVe31fbKq/vo+WdV4/dVlVf1NfbKq+aa4rGq8KS6rWm9aIKua18dlVeP6uKyqXx+XVbXr47Kqen1cVlWuj8uq8vV9sqp1fZ+sal8fl1Wd6+Oyqnt9XFb1ro/LqvxMXFYVZuKyqj4Tl1W1mbisqs7EZVVlJi6ryjNxWVWaicuq4kyfrGrM9Mmq5kxcVrVm4rKqPROXVZ2ZuKzqzsRlVW8mLqvysydNWVWok7iwKirIlFYlBZniqqwgU15VFWQKrIqCTInVUZApstoKMmVWS0Gm0GoqyJRaDQWZYquuIFNu1RCKBFdX84Hk6qkgpujKP07isqugIFN4FRVkSq+SgkzxVVaQKb8qj5M+AVZVXkwJVlOQKcLqCjJlWENBphBrKsiUYi0FmWKsrXMQyLGO8mIKsq6CTEnWU5ApyvJPkLgsKyjIFGZFBZnSrPQE6RNnZeXFlGcVBZkCraogU6LVFGSKtLqCTJnWUJAp1Jo6B4FUaykvplhrK8iUax0FmYKtqyBTsvUUZIq2/JMkLtsKT5I+4VZUXkxZVlKQKfDIblZ+syDyoScDKyciYLMGYJUnSc6z9lFvDZwMItZ8BM4oE3Tf9QVB79/3Jz/7+ne/dv9/q7TIObHmrI9CxhJr9tGz/viVfY4bPtmSfK7Zx8/64/tq7N/gspkKgXn7OcGssx4cO4diGOr6G+pYOWwM30Qbr1eUneRAYIb2kNog2M9PxvhsjBcxfizGuzEeVnzBXDU0qsDDBd1R917qcfiTxNOySM7ccK4O1IqwQj1oLgaYD8COAT4QgG0ADZt8bKWGx4cDj00D1PteSd+Wysb/rs5D5DDQVid0EFl6RhnrjenWhyxYtHLjzC/lJaU/UuVFGMpD8WJgI0dkwaDzBt17JqK7Bt0x6MZFOHurTwupK8hUQ2oKMvWQqoJMRaSiIFMTKSvIVEVKCEW6iDrahMj8s1FldoMXeXEh1l0E61xc2Ajai2CtRbDmAoyryhmAr7xnqWdZP9tc8/rZYpcbrd7bSq4jdUsM7FPbKp7+3swUr1lhm8bMVnQ0HR28op9tpp6z8HgjvfKXpdpVVgyos0IG9j347kfed/83X/zdWbXxll1HqpYsDIDxCBzjMZvzMxuJrH11NR6Bew2RZXbST20kksrvOPL8UPhx4RkQ33Hk75kQNl+f+QmweBw1THhFAkwbV5hGvQC5/so+aFSMzosVYsW8WClW4ub3UdNqMZ+SrWExClaL28iYn5Z0v0jLuf134YmibXLS5xuJcG601CGz6jzfJ0fca+RnhLtRcDmZQwf5vvXIzp5ETH5KuBuVVZUD4eHEKwZHkMoVOR94kfOt/Xh+DvnXaMOzXVnH0Bwc7ivSJ7002MpB55t2H7YFx6Bg9Jhyn2EYARjqgRG5TtV9nWLdTQTML9oEty/BZmGjwELThSdhP9Kz4/J7o1B4Nicp+M0afo8OkjWSBAFIdwbOI1sT8Lne7HFHfnG5/N6gqr3tpAnH9SfAKH2RBJXR9edWwsYL9C9nT+IbXYLXCX5gif4OLtHfoSX6O7JEfyeW6O/Ulf0VHcPfmSX6y9Mleiws1WNxqR5LS/VYXqrHylU8/ngZbMTRHqtL9Vhbqsf6Uj02luqxuVSPraV6bF/F4/vWGvXYWarH7lI99pbqMc+W6LGwVI/FpXosXcXjQxn5yfGwPS7VY2WpHqtL9Vhbqsf6Uj02luLRgd65xFXv3DJD3CxGUUQcv1N+d0R+e23Y1mLR9u0HqIzJ31oRNja2QCh32UKp3GP9Ylm+OiK/tHahcNbNiF+5VI+NwU67oBkt1WNxKR7hqOuENs5DKqX2+wfnpyW2cOFReGS9NSKxk056DnBj3rg6ob3J1HOPsIXzRgrHDqzRxw2oYwbGQUUKRKUN5z9hBHvUkSkJPDxwUlFHICBShyAsUgchOFIHII8OStHwWIJEeKAY0iWqjwVIhAeTIa0NCJHWhoVIn1EnACTCAwcS4YFjSOsDx5DWB44hrQ8cQ1ofeoa0PvQM6eBMAcwLw7PGVF7YFJw3pvLCpuDMMaR7FI/6R1ofjIa0PhgNaX0wmiorw/PMVB2wKV7WNJxwV9E0HHxX1XSNTcF2K5V/NgVbsFS52BRsy7JBtW3Cmf1awcZniaORNH5LeLlAqKWqPVsTXHgrREptRkwpldyWFZ7zHJhwtuF0ZvW+W0y/cLDJ14MufIOyx4LDIXqYJTjXWZ8O0VUAnDGljofoKABOOVK7GIscgQIP9jEWFJDnwTERea7KVuKqGF76v6cUIo37bswSRHlXuW5Aiiq/dSBVTmtAqjy2gVS5awGp8tXkWENixQ2vx99XZ+aneZUjor7UJiAVHh4iVNOkqxIKTjZtzagkzONaWzG+Cbyx87wBN0HIDgd7ZaUDw3w91599SlEpqA6uu4cxMB6Ggyj5DbX193//f6k9MgOb3bk6FqrAcaYCx3B1fvlpDO1qXOEN/WzqZzvmr6Xxjn52uUqyl1DPpq2eDf0s2spfQfN5uz++no4nb2l/+lnUz5J+lvWzop9VS8VXg2d7rZ524rK4Vs/PqFhdXVpXcJjnUqNXLktrQ7IckZUomnwSKuyi2vfGZTMNbD1ga0NhmGpIYu6GdO6Gwddw6KtukFvDRLpbgryCSVKIRrnorM2Zm4V1IuX1kNf1YYy9LSGZ3xqShSidZkT2JkKS7Ga1bfqlw9NIqL4NSrYtt+/R0hO/+/KfXpq/XlfQQqi8ECothIoLocICyGTzkIPG1njxYSEwKGArIpsR2TA8bAvJdkR2IrIbkb2ILGwPyWJEliKyHJGViKxFZD0iGxHZjMhWRBZ2RC8vInuRh25EdozUIr/ViKxEZDkiSxHZich2RLYishmRDSOGnVGVRGQhIvMR2TNiiNB6RNYishqRFSOGiOxGZCci2xHZMmKYjAofkaWILEZkISJbEdmMyEZE1iOyZsQQtbN8RPYiD92I7BgxRH6rEVmJyHJElgwPQzkvLUb7tvvx6PiG0QvTvLPWCTt/MPgIP/5tERmh+e0RORmS1QitRmg7QtsRWtwRkbtCsh6h9Qjthqi7RfU8xbUwwSRLLOhgXTyfxNZsYXUucrVl8w1QfNQARpWig3pqSiumexR1BFTUlFZMs4o6CCpqSiumY0AFiqmr4D0gSFNazTygKFA+DyoSdNJDigRV9YgiQYM9oUhQbE8p8hScFZMKtNMKVXRTab6pQDstabquNN9UoJ0WNF1Vmm8q0E7PKLKjFNhUoHjWNd1TCm8qUFSbmgYFtqVpUGzbmm4r5TcVKKTdICmGim0qUEjzTGdNKcKpQAktabqulOVUoOR28LqbVNhGU7MX/BXhibnz/srwENt5f9W0imbVtIpi1bRKYkW/n7x2w2ytmlZZDeJ5ambeH5tWxRqbVkUdm1bFX9Hvp6Hd6vqJ1bhyWr2hldPq7aycVm9mxbR6Kyum1RtZMa3exkqtAD45M++vnsZXvnoaG8HqaWwWK/o9HFIuB9XjgCpBR+egqmM+o1xnMX6lsP0R1NU0NumV09ieV05jY15heFgxja16xTQ26RXT2Jgv5zgFbwCGfz5/I7VESvA30miPsLdSpMOjD5BKqQPIHT20RAr3giGF+8OcLXyPR+Ex6a2BR9YbF2kxCrlOw7AxK9IwlpwUaRhL7hFp2JQoiWwpZSm9D08gSps630GFnlCPPO13PaXgAlXPcsy5qPGKftZj7lWNN/SzHXNvarwTw7sazzOdPoMjxmEUpDrh/kxoT2W47emed94H+4RFWlHkYxCyCtuihUjBGgEXDkxnuFvhcPIX7Zys+sLEik87OVna2Ifl/3QEarG71v0w3N5HdrM/PCq4TO5m3bUgaEBJlN96k+4vYQkODklKaL7+PAk7X7qblY9q9RSiqD5PInFk+GsgrVKEOL77BA3V09rPSA7Sxn79Z6Qv7fJnaV/ahSdppMBCHPo2ve4TNJKTBp03/BeRjvLw8YdYmId8m4Z5KLRpXx46H2Z9eWg+xCJJBrTOQ+0hFsl1g24Y/ltIR3l45X4e5qHxOAvz0Hyc9eWh+lp/Hkrv4pHaDXHoPOTfxSMtwqCLhv8y0lEePvtilIfiBR7moXSB9+Wh1+Z9eWi/GMVZfzHKQ+PFKN2mQbcM/50X+/Nw31NWmIfWfVaYhzbQRh7qT1h9eahgOBVnAWidh+JTVqTqGHTZ8F9FOsrD0w/bYR7KL0R5qLzQn4fCQ3ZfHroP25EWBLTOQ+thO9IqDbpj+O8hHeXh/e9NhHnofMEO89D9gt2Xh+b9ib481DCcirMEtM5D+b2JSM8z6Krhv450lIeLL0V5qH40Eeah9tFEXx5KL/bnIf9yFGf7pSgPnZeidLsG3Xsp8l94uT8PD30pGeah9+5kmIf8e5J9eWg3kmYecHLhS3DvXQMjUJFXgNaZqX4pGXVQBl03/HcBL8AZv1S/MQDeBUvJwesE4D44ICxo2wC8M5/PTyr+a2GSafl/3rMaksELQQqKxvsq8vesNgQATH7lVyuidM9q6M0NvxWDrhp0zaDrBt0w6CbQfQvtadm6B5XgYlLJUZn/7YV+Cr+Nfr6MJijsrEhJK+cnthPYs55Wgr9+Vz3UAEBzJr4zDgoElISHLqFf4Ui6fxxUELKoI9s/jvdphGcsz2KlaL+i7gXzYjfUHW+0X2pWsM6gfgXOZK0Qo2IlzLKLlcfG/VViVKy6adxfdd6dp94KsVIoaqVIy14BwijAH1XBwuyVy2V/9IK6YKQLHleKgO0Au0Kztqw9FlS5LT/12GrdmvAC2epjq+HIWMNDw6Cb4Jkqzy0MKB+ienBSfDzyVzDovEGTN9Ly45BA6XHjJcJlR+D60OMY43vV6MfGO6E+D76rn4+/clvWP29k0aCbBt0y6LZBdw26s0jcPcM9/wWjWAZdMujiFxbGUTbcKwZdNejaIuFahnvToBsGXTfo9iJxdL6gxo1J/WryXzLq5O8W+i8Y7iWDLn5pkXIZ7hWDrhp0zaDrBt0w6OaXonbXMvC2Qf+XLwXdkS276F92grFw+yuhv7552a9Ag+l8xXjZBp3/akT3vrJIRRjuRYMm15HqV1erJln5Kjbgry4Mbe1mZXB0syIF95LAMU7qAmkmyzzn2SIJZiYcbo/aTlqw3peBWxwnp/D8QRuPy59UlFCHHNo4EBGKctXRhrae7M7oGyDRWj7Tdwzknhg/GeOzMV7E+LEY78b4lCN4ZHKXAZO7zXDHK5zQyPVB5Ek4yloS+U7VQST1bZYlpsgUjh6QVKMMphbvYMHCWyMYLN4lAITFO7ylqmWBGT6MRFS7SYrEG2kN4liDC0dJtLWE5ziOSJieHuEQC67gcX3916SicAUPKVzBQwpX8JA6oBYUWLSCh5mFiY4KVzTMf5Q1DQK4pGmYLSlqGiZRCpo+gws8SJ7CBSQkYZakrWGYJWlpGmZJmpqGWZKGpmGWpK5pmCWpaRpmSapBbhguGSSDg6uKmoapkYKmYcokr2mYSunpsDDF0tU0TJN0gtIyXH5QtcBwCUKly3AZQuWHoUGbyies22kapkkamobpkya8Swrv1FEvtwwfR9sKXy7TC+L4KtRiFpJtFr6JHkzP2Dr/MG2j4+/AdI6mi3yKl7SfAp/iRU3nOS7FYB7Kts5DG4CKbeahpfIQXPTD9ec6qaisakC2niPg+nMdU5SrGpCt5xcwrXaQVjkB9p423PMYlhdO8bKxkFwdfw0FsNTp+JB/Sy1VQ/YttVwNtcDVifhQCVwtjEMd8DDJcsLR7+xy+Ap+UhULDoLawquWtwbu01BZ6kGW6gnj+1ozBUdT43dVTUAWu1bwSmpW+Eo6VvhFta3wk2pZ4TfVtMKPqmHpr2oLr1thFnuQRWOZM5+ExCqWx1XOfjsJR+tcRwr4rOGJyElZQn26qwQCm+Bl6yo2Ed9eCSczgrEBm+DVq/n8iyFttMJnw7cCC8z8dG6Ct/vMFOR3Vmu/Tlg7odeamcjN8oFB+bnAiAFPeNNbhTJy9iQcSQY3UL8XjFxLlyLT26JBFww6b9C9Zw0T3mdJzrc1B7ustBFt+f/A+w8X2PE2Li2w461fWmDHW7u0wI63emmBHW/l0gI73t5LoR086JYNvLn5EjGO0VV3PEsiv0c0DzfMhkWOaJySuh3MhS+RHNxApwzqud4SBjeAJ2X3G6qELt6hYbkr5tXGru4Q3moxKvBUts6v+QwDpLB7/0OakzV2CpAtqklLhWhfcHi4v2YfvXff9z5Z+puHv/8H9/zZ3Ln7xZp9P4PLye/Fg1BROJ659759tHC/v0btEAOzeDEq1uxbV9j39Ye//vDXyb1izf3+mn0j79qXz5de+tlrD37/HwPsde9S8vXiT/+9RnYXxJp9TuH+R6OD5jVV3jsfHkNf1iWsDOsSZpZSpp9TosyiJcID5Tq/Bt30/3sli+2qK18bto2at8BMu+5FNusRCVs5Aroaha9cuyB80fAJuzvi7iV1enzVUhsd8Kg5kVAW+3Cerp80bPbhRF2fA6C2kGhb/doRaPPtPmN9D+7ELj2PGCTRZNqCH+6MNG79hhslo4tR4Qy62pEpXnyrvkoS75LFkLY6XtBWh3Db6hBuW1mM2NpixDBgz8BDXcGNuydWCuKuuozl4eBX588tmjwLG1nUrc8980Bfap6ES02z7S4Yjguq+lvic6O75YJGtyeAleCIrK0WXHlNLd2ru3SvY0v3KpbuNbt0r5NL9IqX3BNB530OxxGrO++BtWBxA1kXWBuWPJAdAzYBCyHICmCTsFSCbBbYFCygIDsJbBqWVYjgD7j/iQp6YRq7UCvkDggi7JA7CE085A6BnAq5I3DyZMidEESkQ+6U8wBn7ByfU3fn1pf7HHtTOE2Rx/snnJ5X/ZPyBRuCfbqgh6JBD2XHeyi9DWoJcUPMbEHMLIjZisfM1MfGd7P6ckHNLo/e79N4l4dYX5eHyO6CoFfs8tw/Dr+c+vyDgplpsF9QGjeMbb/hf/2pt3p23n2AzjuffB0bnrPOwgaKEbWBggiaJWQ3CfevCbqdWNcRfdYiC3drczgMM7Wb4S23avB2JoPnScKF2QyPQI4OXEzgZm1LucLbZ7Bd29IKsw3VPab0Vyuw64RDFy1jl7Yd3v9qh7e7IhXaRlqRzSQeumiZ+7ITIEESWoJwPB+RGRuxOZ6PyIyN2Fgq2Ledz8DMMboam7K5LA5iFBkjCkSKBpJHpGAgPYwobyBdRHpGVjqIdPuzAvpbG7JSxjgrRgwVRKoGUkWkZiA1ROoGUkekYSANRKIt2Jgu7PwuDUJZhrAsg0ZZ0H/eQLqI9Iw4O4h0DaSNSMdAWoi0+9OFrdhNSLeI6ZaMVEqIlA2kjEjFQCqIVA2kikjNQGqIRJuvMV3Y810YgtpA16bhv4lIy0BaiLQNpI1Ix6wTRHoG0kGk258ubPiuQ7qVYcz5kFE6RCoGUkKkbCBFREoGUkCkaCB5RKKd15gubLruDSn7PKgNw38dkYaBNBBpGkgTkZaBtBBpG0gbkU5/urC5G+0Cu+jaM/z3EIl2VnM8ZpAZG6s5HjPIjH3VHI8ZZMa2ag4DAKil4b50YUt3B9KtoGvV8F9FpGYgNUTqBlJHpGEgDUSaBtJEpNWfLmzkLoPdZRtdO4b/DiJdA+ki0jOQHiLRHmqORwcyYws1x/MFmbGDWo3Fh6d4C9ItoWvZ8F9GpGIgFUSqBlJFpGYgNUTqBlJHpNGfLmzaLo5AexjBDt/YIc1lc0Sdu97qDwPbrBsjIHLQ7l7d2LU81Jjm/VF168fIDYf+Y3b8yR/+w8x8GQ7uaIz4y27Ye9Nr85d+/6Mz83gRoyWWReHEcjESceWyshteFsUiRsVIFAF4aIw4cNC2ukoC7nFvfZPk9B3QwDYDdhLZRsBmka0HrEC2FrBjyFYDFqZAyBZe+d+U+TKRncDlALLdgD2IbC9gDyELd/noG62ALQTsCWSLAXsK2XYQdlZJ6RROmuBoW7GeJcvL4GJ3Kqtb8Hh2AOGOVRTahui3tbzHqanooBZ7gdSH049B7ieUxE/k/ISe0UYj/jEl+wNTbRu2aCb6JH4CJf6ZcN9D3tgOUTC2ScCWCbiUAqzsqXGuC4XZACXyKZ6kzIKjWCgeo2xqABQPXzY1ACorTkzqU1nO9Et9qlWDooEo5aJgIIWY1Kd4+LIp9SkevmxKfYqHL7Ng+zPFE5ZZcBQLxeOVTT2A4vHKph5A8XhlUw+geLyyqQdQPF7Z1AOobGX69QCqdZ1I9lOt6+QNJB+T/VTrOl0DUbpOx0CUrtM2kLYqZksXE85ZZsFRLFRrPyUjXaX9lA1EaT8VA1HaT9VAlPZTMxCl/dQNpKmSbuiklZrSNDwoVaZlIErdaRuIUok6ZkXFFAKqFamumeGhfiWAavWlYiBKxSkbiFKDSgaiVKWigSh1qmAgcBYzC05foXjgMgsOX6FaDaob/pUa1DAQpQY1DUSpQS0DUUpP20CUYtQxkJ5KuquTzsc0A6p1mkgzoFrvKRiI0o2KBqL0p5KBKB2rbCBw7DILjluhWhmqGh6UMlQzEKUM1Q1EKUMNA1HKUNNAlDLUMpCOSrqtk1b6UMfwoPShroHkY/oB1fpQpB9QrQ8VDETpQ0UDgcOXWXDACtUqUdnwoFSiioEolahqIEolqhmIUonqBqJUooaBtFTSTZ200opahgelFUVaA9Xng3XhiscentWcyvmpqE5GAHJzfjqqFITGgutssVYQEsGVt1gtI2qkqe+MxHpBaDK4EBjrZgRPgtmj6wU9zJ70E1HFjKipt5zPoqpBDO6jTEaVg1h0uzBWBmKd8IZhrDLE2uEtw0RSFMeWeYfRTYMEr3nqA9JxYCAOOHEgEwcG44A1wff0A+pkgLinA3HgYBw4FAeOxIETEQA3ruP1Mp0RQYV9HWmPwDcyomdoKZxsHZD5ZSFZiMhiRJaWGZcV+iPGssz5tfLPl4kRdV/jnj6nP8/A1eraKXWFUIl4hH2h3CuEYlcNNXaFUMmrhhJXCDV01VDZK4Ryrxpq8gqhhq8cCme5s6x0yIMpQGs3Kx0SNiqVdpaRLLNGKEzQbCP30vAakTP6ppL2CExEP+8we24IJq2atroLicjyNwkufMCCUO85RcORPyWNw/lAXY2nQTnW+ADo3BqHhYWCxuFCi7bG4ZyjvMbhYoCWxuHQ/N43FA0Hyjc1PiLIBO/+mrcMno3D3nK4LmVCHbIPi1U+c1fAiGQZDDNKNrhCbw/zvegyIlxwKSuXruEyLIbApaJceobLoMiAS1W55N3IxRED4FJTLgXDJS1S4FJXLkXDJSkSOASCN6RW6tRF8YehRp+Di21kOwCx9hXWMbGKwromVlVYz8RqCss/Z2B1hRVMrPgcLPMJIs8/CZfLETy3irkrbvj3o4+85fl/d3pmHiq5eLis8rnQqQROpUWdyuBUXtSpAk6VRZ2q4FRd1KkGTrVFnergVD/sqAvksYJhKdNn0foRXIx1Jlo90lfLqyuKwGwlWjvCa+KNa2CeRwwuKNVrRxRMpWCQ5wfJMVh1cH8LG93fo3dYaipwWH+Cm3fKL6oUy5ZebNJ8SfNFzRc1X9B8QfN5zec133tB8T2ul6Y139V85UUCUwFwn70OUdUxVDVf03xN83XN1zXf0HxD803NNzXf0nxL821I0QakrZGO9tHRfFfz3aAMmu8FZezoMtq6DjRf0HxR80XNw8lkIH1sON6LCUvY7uo1gqglkcatcuCU3HNrzme4sujjKuC3MI9qCn47IePanCoPr74Ar57jlZSYmmZdxZY0O6a/Tc0K/VlqNqu/SM1OqikTW39uDC/ZhNDfCj9BhpdwQhQmVlVY1cRqCquZWF1hdRNrKKwRYVRdMum8l1E2p491sqCDvxEvthNKwRM0ONUJVDSFM+Tg6EzjUCcXr3QTxH2Z+lRQ9yfU/SlVuI34j6nH8D42Ion7febBlALHmmFzcBcarBiVVwjb/RLzqZr8oIL9yiATuL2LSXpa0rscn7k/BQCuRIIkYAUKLhNjuBalZkgEcX8IsxR4byNx/wju/1IM6oc68+7rFItnQ1nqbCjn1WE2exbrAy6p2w8HcnlvgXc16W1EKey9Dt+htwkeJ7zN8ChTLwvPFvW2wLPIvK04Vca8CXjmubcN4sh6Qyj/vWFsFp4LjyPeOniUqLcdnk3q7YBngXk74Vln3iQ8e8zbBXEIbwQ1D28ZtjRvOTwOeesxXepdi+lS7/WYLvN+CZ415r0Bnl3m7YY4xrxR1Hm8Fdh4vZXwOOhtwHSpN4XpUm8Ppku9aXhWmXcdPDvMeyPE4XqrUNvyxvB78FbD44AnMF3q7cV0qfcmTJd618OzwrwZeLaZNwtxpLw1qOd54/iJeWvhMet58DjjSUyWevswWeq9GauaeTdgVTPvRrEfKLV86yfngdmj1rNTyJxSK9aJ+TJOXFaoWpZOo2ObqpXnATWrWWJqddlBxyZTC8iZeTDw9lEC0fPwIP7gBbwa+TzqtfgVn/evAacOLYeWFDAvekjsF2tFcl54IjUvpMB87BPpefFmAaneIJx5caNQaaxFUUbPCxV9yvfOi3Gx5ry/BjWcvqj9cVgH3i9WQ+QCIt+rIn8TRH49Rj4Dkc/qyFejMAwjd31xXoyJVef9VeDQ6498DJaV94uVEPkGiHxKRb4HIp/GyK+DyN+oI1+JqlcY+Zi/4TyYvZ/3R8Ehz/oiXwFrivvFcoh8PUR+rYr89RD5L2Hkb4DId+vIl0MczTBy4a8/L5aJkfM+Kn6F/siXwfTlfuFC5Osg8u0q8h0Q+U6MfBIi36UjdyGOVhh51l93HtS+8/4Qqjf9kQ/jZsz9YhPEvhliz6rYt0DsWzH2CYh9m449iYpoGPuknzgvXic2nvdTqCH1x56GLZ9sVvjGeUBwrsjaGL86xq+M8ctjvBvjkzH+mhi/JsavivGjMX4kxg/F+FSMhy8nBnkxXsT4DTF+fYxfF+MTMX4/nGyXEInz8Odtg0SMi/GQHhNjIb1CrAjpZWJZSA+L4ZBOi3RIk+2kDEsn+/WFmQcVNQkLCvtBwhC0ViUKFrCYgdQYrGMg5cL0PFIpmJ7fr0x94HJjV+wX+2HeAi5UBVLkQK5xsR/mYdSVs2i0Anc8W5pK+dgxYQ9G9LoL2rJYaNByuYdVbqnyNC6BoGGLhdYtl3tw5eaWp5WxKFi5WGjqcllCKLex8rSyKQWTFwvtXi5LIOUmytPK9BTsXyw0grks4ZRbtjytLFTBGMZCi5jLElS5TV7W6ydhNAhWs3C0Ywo3aBMxhBu0iRjBDdoEdu3k4ak2ZROxBjdlE3ENbm0mIokbsolwcUM2EctxQzaBLcwNeK7GTdhErMVN2ET4sBVaEu8tjtivr8B8i/MHnFln7Tlspj5TPQ6Hx6xvlcu+3XcIAhF2ZPbxoM+i7xkNhUJWsAsqLqyTPefRyA7vhtZV4QKUCqCUrvFp7g5DxTAYRhzzE8ISVCQkl0QkxnPK3pXcNO4n1AHEIiFthJCkOclP+UkNncfVIYWlAuyKecfBj0hKfqufFqkgJUFFCqABkQyg8/1FVMWGgKdzUBQY2kKIpBFFQqQDrqyTShn+U31eB/q8OvemWOLs4Jw6QDSl7GfUWPmtgaEeDRX1sma1ol7RrFbUq8jCzGQ6GhwrLJvzB6LBscImc74TYg2F7cn5mRBrKmz2pD8YYi2FwRzlUAi2FQiTlMMh2FEgzFK6IdjVOT4yHVocq/GjPxL6AZNkmKAjOX9ZCBYuqYBnpkNzZjV29ZeHfkoKLNCcPxoFfEYFDCYBnumr0NIzfRVafqavQivARnVZxZORo6oFNqrBOrBR5TWAjeqtCWxUYy1go7pqAxvVUueZvlqC45RFVD9w0rKIagYOYTZqBs5nFlGdwNHNIqyNLCu8FS7XFqnLg8mxnAs2+2ksv6e+UtxShP2ELezzviUskAlc8JBmgiF9FE6tTcvzjvzsIEy9zYOveXBWh/tJKr/iyvcM6a+pp478fW6NfH4wPMQCzBSD47l+MIM7esIjrV9VhwIQwXRXyXVXaavzK2CejMMj5TF4uJ4NjzHPklS+bKScmnXHjLypvFrCmgdt5sHwxvfuY+UPhRsHjsnHHHnBFQmYK+3rHi2RuOBZsG58wYOjehMX4NJieDBHZbLDYudyF+C2YmsaNuyo3OtSdZkjUni4r9NkjJ+lc7L7Q4rlkj1FWDL/IyRgIF9/CczidE82zWu3QTt6SQ2A2zgAVsv0ioYyEtkLGIig+LxiyuWyYDc8vqry42Xf/IfH5su6hWL0N2z7m/f8zSO/82mYasK5oyDalhlt14y2EEWro2qoqCLjCRgFKBODphlNx4wmvyAaMPrfTtSUbPcl40hxg26HdAJG+Chxe7c5zmYS7QjoBDsCdITojyh/X2GMzlGcCqYnfQY3QsOKQOARuQvhfCHDKTCqIu6+Qt1zOIiHL6Z5K4wwGKxD/UDbSZxBthOweYp86wehVQWDvgq6OohOzcE5EFftNrwJu/dDqm08GLQDbf7B1PwCg8ait5MxMACHu8tVOXU2mcqdmX+yIO8kyDu2qihzKWTDorjIhkWBS9vFgpwz2QSNw/mGRdNntRzzlQnOvJ/CAe28MslJzftpVOI0786DeQc8y2U1UMQLslPzamCXQF1sXg3EHBwRw9ebgS85re7SducF+srCfDWMt8HD4Px5fwCVPpjfxsRwaK1G1WOXRzqorF0e35TLfmL+vJ9ELRCiSs+LlMjMg1oMyh+0yge0ZEeNDxJmkA+BGYfkBCZ1ACa/2QQ/CLGwy1q6DpoKgh7RQU/ooKfCoGd00DzVYQtUB3aDwEWqQ5eoDl6mYfgK1RFUgwhqQQRjQQT1IIJGEEEziqAVRNAOIugEEYgggm4QQS+IIM/CCApMR1BkOoIS0xFkgwjKTEdQYTqCahRBLYigHkTQCCKYdN6doM5Z+HTll2GrlkcCWRV1NTfB2IgI9qCvOsroRC/Q5aY5KuOojrLQMB6aGLDaMB4aGbAJVWugLQObVHWACi9DS3il+KJoOX+lLOxZmIWKzgLIEj5/HiKzleU8neAHoBUrMK0M6C9/ngehiStwQNnR0wk8DkmDDGZlKMwMgVg7jxLuvLlNQOWIPwglPmXmiF8AqKpzdEYkMHwawgs+7zsw9YBOeCU9uA0EbhmcOUBHPNYJHFngyPGsJ4qzUwmRwDjT8+eFI5z5874Vz5n1IFR+hZpZsy5AtdR01qqod2P6EE8G4hE2vrOqzoU6ywtzAV544CWBQyOKc2NJkcQ4BjCOzPx5VWPmEEjlyH4QUm/35cjGHNV1jvDkqSQmN4DJQWyq/lS+OpgoHsuVQm8MvXH0lgiTjjccdR5t2IBAJTJb0DRvgKLhvOujFt96dnoueQ5uWcic9PduJGKvno9X4iaBfCXgezby5YDvKr4U8B3FFwO+rfhCwLeQ38LzR6Z40xZ7ZSGR0ytGwVrRXtmCnUwo5IM1pb1w1KdekdOGCXtlA6GaCdURqppQDaGKCVURKptQBaFSBJEtvHjYu0nsBbs6dcbEXtkZ0PsH98pySIqbpng5LfYC2x1Qz+qA2Iub8zXfAvcSzfmT+3SCRZrzJwIGBhu7AwaGI7sCBuY83hAwMJjZphl1UtfecF1tryzTnLoqPFjKOwA5JjmxF5bZ9sreQA7ybef8aa3J75V5BzDYY7w9xAqIVe2cf22IFRGr2Tl/KsRKiNXtnL8jxMqINeycvzPAxN4JXrKneXdA6MLrYusC66LqQv684jW9nIiVC4wjdRr4cp2ciApYc3IiKlrdyYmoUA0nJ6LiNJ2ciArScnIiKMIvINu1axdku92f7U5ftrt92e71ZRssNqNsg0VnlG2w+NwZjdPe+1ZvNyzXJE/6uzYSsQuKaef8N+BM3CmxS7wBp+FOKEqABS9SY2Dai5QLc3dIpWDuDikw3hW7cH/NG+Se8LvdJRsckAIPP9s3bOEt7t0Ezzb3jsOzw72b4dnl3q/Ds8e9E/DMW94t8GxyLyd26SOKd4lbcM/+LnEC9/HvEr+Oe/t3iZtxv/8ucRzPANgF32DJUuEawOfwjIE3bCdN2AS9SzasnD8B8av1YSRLuPkbySJu/sbSwXJv11I0LAV3NA0L0W1NwxJvwVY0LP/mNQ1Lwz3IBoXsO+INE7wFe9sxXy1bPcvgmaLJxS74HL0JyGfJ9ietWZWbdpRHWLqdVCSs6mYVCQu+QpE93MyOZDcqT0eVB480sB2VbiGpnm0b0msksF7aNryysp2TFarfIgWvjpi8EbOzGxf9JxV1QuVgN55VIRR1SKW/G8+qcBV1AFKfELuDsypIlJXdWUa8ayXxJiTxdsCIKXnSn4IRE9wp422TUFuzJ/3JBbPhayQVkxM8tSjqLoqOLYqKRdHsouhkDOWzYpuYFBNy8lbsR/f0XVwwrUzR+rEJfiAOHIwDh+LAERPwtokJsCGfUDbkknrTbFZsA0k/CXcaGGPky8UrG3wZgJoJhOTbVOhiLHQlHrp+tdClWOhqPHTjaqGbPLYeMTnBW4tg7UWwziJYdxGstwiWt+KY7iegNvvdsBEUF8FKi2DlRbDKIlh1Eay2CFZfBGvEMAcyXwLLtUk8r2Siv/2Jif4v5k4A3DgwFgdEHMjGAfPDuDPIB3Yqk6hj/H+SDwD2xIHZOHAgDhyMA4fiwJE4cCIOnIoDZ+JAnsaRwgKkuAApLUDKdGHVg5wxBgFw81Y4dabauCTeNgYvB257mECrAJjBmECTAJjVgPfhwwCrXF50MhOXSPEl+RSmNeDt+DgKn8Ct5/PluG8qqJouxQHLz4t20rd0tHt8W0c7iwYKC6K15nGQCBOnC51hQKSmZxPofMVU02DHC1OIbP48pMwhYEJQ4JIwG4szPfPn580T7QyD4G2OhBWobePetCOmHX96kICWVuYeUy/Eo2JKTKKuVdZkFg+aRlLgdiEkx3AXEZIuzvAhmYK5P6Rwmm9KVmhOTMLiynWByjUlezyn3mmgck1qlWtSq1yTWuWa1CrXpFa5JrXKNalVrim8C9AWU6BydS0xBSpXB56/jnrPFKhcLXgex+OSpkDlalgqXA/4HKpqQVc6JXtWzp+G+JXKhaRSuZBUKheWD1Susq1oULlKmgaVq6hpULlqmgaVq6ppULkqtpgC/aIONtr/F3lvH+NYlt2H8b3HrypWVbO/ZqqmZmfvezOSalRFsprVXcWqUnfz9fRHzcfutmRbbluW3atuCQ32xO5ZbYBOsPBwbSfhIErA2DLAbjtZkm3ZDCAjTOBgicD2UoailO0EqcSOVLGtoGAYEgHDMJ0ICAM43uzvd87jeySr52MT+5/0YIrnnHvefffdd9+95557PiJvaEtaV0vK7xEusWhPGsyZO5SH2Z6TsJUidEnbKXQRFKGLoAhdBIfhE4nQxZbUkhlYaJmtVQwG/8ipuLvSiF5KfuvJ8YS549eTFZk2AymMlfRSGbMDUf+JKW7Elr/rWW1oXkh6aoA8FaRqEePA2aEmBWhN0bqgdUUbgjYUbQratEzR2Bi/vd9YgdHob6zYH5ui3/y1FU4X99wsZ0r3LGdQ95xZF1nHPc9P1r3Ab9i9yNnAfYWykyuClTtPqcvlPLXsLlBecxfxA0tmyHTuGQg9m66DnzU3jh/jJvCz7Cbxk3VT+Em7aW6T3DmzzsnL2DyxXwrTEJozIfyRWYwiC1EkE0Xmo4gVQWDh9cxzTPyZFzeJZ17CJJ95SZN65qVM+pmXNnPPvLkwkmcIPlzFEbGZe7jqIUBY+uGqlzJJk8KxNE5+Hq5Cq20SD1cRj8DEH656jp5p/efXH1L2tnHetK6GBxn7Y7MbL/sxs57dXLReg1voknnl6+aMuYjnNBfwgOY8nsycwyOZs3gWk/36R6gtF4stWsiXu2ULhjlw3azDSqIE6TK3bcfHSiL/9xyTMyX//3DeW/3uCzfuoD1bvvNNb6PiFegNsiuHZ7sQiHnAU4BVg8e4LAUqOzbEFH7DWDj6c6QAEfM2THinsO8i3e7trpoNKv5bP5iFm3Jl1+GVxnk2WzZ6aa1YJMbYA63WgYUFL93FNqeAMwdpbgLNlTprrNPC2+dFSdT1YBV/I29ZeJENqHD6U5nExP2xPfesVttYuH/GbKHvt9Q7lB2Ot+X/nrNtx/3fc9xcRke6Z8nqGx+Pkl/xHOM0Tc7/J7EDr7AKcwx09cNVzzLxmz+9lPuv/tN//s+vt2HWjPEFVTRXeWtSW7huLFnN42oi/meCmj9PnSaDzcm+hXo2qXpYE4hhXghlocLGfMEJYNdRVgPdNKE1KKR1xliXgEDreAv3BMv61oKN8b6elT0yP3x0xvh0tu1Z424xIfhw9eaf/80fHWTyZ/9m8+FejNayGPHoMTw59gzjFFIPgQ8ieAWE0TShGp8i1KYJ9WlCI0rw4+/iNDxs4y1pSfrmX/5z9n8SpXDKNfqMF/iMwQsyIfhwVfixZODxcjHrVoYJaIt+bUu1lEUkSQlALD9xkMLSQVg6CKmNSyF4eQwehtTDkDoKqaOQ2imG4JUxeBxSB04l+zau+bJGrS7CUSrMMlL0exciOUiKkodpXJrNo47fWKnwq8L61XU8ntMXsZdFE7VQjA/aTS/+AF0TUYcHb+J77WzbgkZdvk7MZIPfWMmgG//HlYr9rcicMvEBvRadbHBuwYsnWeDt8AJVIYZt6K2GdBxW2JQQfLiK2Mj+nLuLIVvEx1HadWpHK6jiaAXiApdffExFv0HKunMgaFPRu4J2FL0naFfR+4L2FH0kaF/RJ4IeKvpU0CNFq5bgx4rXFD9RvK74QPGG4kPFm4qPFO8oXv2fBO8qXlO8p3hd8b7iDcUPFW8qfqR4R/FjxbuKnyjeU3ygeF/xoeKHio8UP1K8auvzK15T/ETxuuIDxRuKDxVvKj5SvKN49X/W51e8pnhP8brifcUbih8q3lT8SPGO4seKdxU/Ubyn+EDxvuJDxQ8VHyl+pHiVi3lR1E+7jHJcZAhks8n8grvjoTkQYsOpeFtj4lCITafi+WPiSIgdp+LdGBMRIdlscul/Z0ysCbHnVLxbY2JdiH2n4t0OPwwhHjoV792ASBHXfRUbYqgfY4+9wlsxUzA7PF/J+aWKyUFiz25RonHn8GPcefwsuxn8ZN0F/KTdRS7n7pJdlqnMW8/F1qg4xWR2nJZZeQ36worJZS+bdTO363RSZt3M7zpN/GZ2nQZ+FxhGdN0s7jo1/C4x7ui6HgN0FUzvOj0Fs7tOX0Fk01HQ7DpHCq7tOscKbu46Jymznn3brIep+NbhuR/OpeuT2Z7WJ7I9LViZcJpanwqhF//WtNyDU+Hxbrt9+hT3YLVl7DHTi+xfsVqh0Wjm5n/0z/7r5v/5G91rvwJLqfU1+zjtlfzYB26Zomgeoug+5LOc2a94+5A/N6BEsFoeN/KQrropRA155lk3D/6Lv/78f/+tf/faQ1EgbPjNdMW7ysd4cCsynf/cR4sxc5UCYMbsQ0OJWqvxlouLBqmKu2+XTRlveANOjN4GRUNjgTnW4sqjlS2XX1DA3BdxMg8xLw8xzxap+1eXfKuybf/qEib4GSY48aybElk4jI6yFe+yuYyb/WCj1U2ZiF0qKUv8Ow9jXED9jXBlWS63Iy+g9VJZybNo0CC2XOtwgg+e7wdbvB7MB7TkhCW4C4hk0ZIBSxyUHaYmSoZhydFkySgsOZ4sqZ4dl5xMlMA1KEFNnZuUfWlK9qXp8b70jOxLsxz+7ll+EO45fiLueX407gV+Ru5FfljuKxjyvKHFj44b2tZEe+pa/IrJThY0tOCiOTNZ0NSCCyY9WdDRgvMmNVnQ1YJzJjlZ0NOCsyYxUYDGHjlQs6GbYMB+gl4YpPl1QKOOsuibCEpOpktGQclguqQ6pyXD6ZJaUDKaLqkHJdX4ZInsNwaifmzMwR92Dn01Jw8IqXxyHHTCktFkSTco8atpsQKM9ti4sDZb2B8X1mcLD8eFjZlCaUfvTMujlhFfwRn40p6RPUvvjMmpdmndOOzmOLkOwXV4Bt/yGRnW6Oj4xH2Pw5LhZMlJWDKaLBmEJdXE5IsOS2qTJaOwpD5RIh9bFRqHajbDdQunT9CSYkKdDzh681ASzbM3OPNUMYzxbeN1HuF1Hs9VvLyxzCL3SCjORx5HCxe4X5oqHGhhhuMj5cUni4daPE9teIp6gEjxSIupQe6kvORkcWNeDBYwY8CKg2sH543OfMUrw3QqnFk92qlZbVNGBcF8jteeNvPG0hBeedFJp0xmTMqpGlSHQE2HAHrtcB5DAK3QFxCfaN9xWNKYLDkJS5qTJYOwpDNZMgxLupMlo7CkN1lSzYxL+pMltbDkcKJEBkUfj9efz5iNH07WgWiCFWfNjnHhUxHFvfayxa7ZFKVIf8NzfuEWlGMulU3mmlTx3XaYDfoXcIC2nr1CFUD2ilmHu0w/i489W5FK5VEwiLnz7i15CB0LhGtTlpFkjxU9EfRE0YGgA0WHgg4VHQk6UrR6lmj1rKA1QWuK1gWtK9oQtKFoU9Cmoh1BO4p2Be0q2hO0d9YUVKuFmQ8LybZ9YApmY9u+aQqm4G9Wtu0yoG37J0g4hH9VyQTyzQudF8+GIo+SjmZJx7Okk1nSYJY0nCWNZknVczOk2iypPktqzJKas6TOLKk7S+rNkvqzpMNZ0tEs6XiaVMApT55xSGJS0rRMnpradSf2gup6kjuWUUpHKd0xpauU3pjSU0p/TOkr5XBMOVTK0ZhypJTjMeVYKSdjyolSBmPKQCnDMWWolNGYMlJK1Q4oVVsotTGlppT6mFJXSmNMaSilOaY0ldIZUzpK6Y4pXaX0xpSeUvpjSl8ph2PKoVKOxpQjpRyPKce2mXh5J7a8vLx2ll4wsI1SBkoZjilDpYzGlJFSqk5AqTraWWNKTSn1MaWulMaY0lBKc0xpKqUzpnSU0h1TukrpjSk9pfTHlL5SDseUQ6UcjSlHSjkeU46VcjKmnChlMKYMlDIcU4ZKGY0pI6VU4+P+iWv/jCk1pdTHlLpSGmNKQynNMaWplM6Y0onL9ti7bq4HOzJZLDjzrMzOPLOk5iypM0vqzpJ6M6Q1u7Pk5X3ng7hsjRHEYwN87r7ZQBUutqudlYp7FVvflYpbMhtok3vTbKC57h1sZ1cq7ntOtIb+SsW8p2qTDf9wpWLujDEo7m6OseOVCge/YCcrFXN1jA1WKhSfBBuuVLhXjmx34zj6oHofu2Jvw4/xQZDpHqIZpPCOgAn024ZGWFpHRvtAkKtvaEyldWSwl5BKWGg33AwX/IjyYs3ubXi8dem7L0R+qG6Mjbd3y+2be7+0+Y//43/n1rXmzdw7r//Tf7z92nWT92PveXkc3WG9zpqN73rOCznQe7Bq5CQKlu7VDWkBdw9ySvUZFbPOIOzRbJ3zOqa+eJWNl1U5p2Pyi1fZfFmVKR3TX7zKzrjKONziHo6rTOo38cWqxIfZHVeZNnGTDluZ0A8oWwlE/u6GHvvFqW25hP8PVrft3obZoFNx/DPvCAt+eEBA7nywan6wV+HJQSxj1u1vUX7TA4lgQFOCHdhClA1kT7EksZpisj8+tgSbI9ZRbJ7YU0EyEyYq+OdRHq87PPLA/gUCqy2Y3LKrmNyyqpjc8sgSTG7ZVExu+USQU24ZZ9sdsSaSWx7bHo2A5JYdxeSWI0swueWhYnLLhmJyy0eCnHJL67TDY+qxLBN/IL94KbplwP4Ci3LetzD34GRbr1ort9v6Vveuv5DDT+dveA9vmNpf8b+PVAwfeXm/Wu1/P/U12Ib+uX/xf/99mwZVef/737/+lXgZpL9ruxvj3ePdd9rTFdBW62Hg1lmtfvynocf842aj8ldvmH//z3xPujb+g+HUZtOtdttYN3/rn/2Tvx/r/q3r7Zv/60/+7t/8uzcH32u2UXjzb/3mu+/d/xf/1/X2TfPW8M+erP2r7zXbN//s73z9zO84/+p6s2ni7b/Be6W/xZ9v/envedgboV6OV7i+W03jNF9AXeo6GeNkPD0K1uE8PnH85fDE8Zev49i3v+HH3JthEvMwyrV7/s2Y35977OXfEsXhGXl/oijRjRXG7QsxGumeQawd1+LScxN63VLFu4pIr7LEufHI5G1u0vJ23z/El4uXeQczedlfMGV/4QC2CnOYK4wHndtVvyqfHOJswdTCzdA+zE2ZjVwsDS2umTNxXIBYOPhd9qCoSzOcw8bYRsQrtzmZSKSMcDPaBgrbDmO1xt0THB4abITpD7aBU4A0b5bCTdao0ohzklszd/zND9iU8rYdC61SXOSMSyAmCsJBsfne2EylbOZehJZt3wngbF8fYu7TPw5MinBk0ruVL5fbD1ddy4arampsDJMttx+Iqju2bcdNXsNXRqJk4lzecMce98p+3JT9+MGqV+buPQ5NuR/HOfuUwcHG2ExGA0JswC+rFdnjJ6VrsHTP3pWfUZ52CYnmC3hJxYDr5BZx/mrpDMMVyiTRmaGPlklEOyVhEjDNadOYKA+lpilVwqryjBRxFTGAgxm8t0Thax/hmHhW8MhdwM8TdxE/dctdwm/Vcs/gt2a5WVSTdjH3dOMVtxxWv+83CjqcaYpzx18wd3Q4z8twjnM4N6mNRGtDxUa7HRgSuWfNVaqw98VcJdl20+FAnzdJGeipYIy02mZOBnrYlDvffTGOUe+VYRCZgkdrKjrmU6bkx9+DfRMS4M095KqH4RzXQZ+cGPTzJi2DHpq4ZFPSAZWCQX9nctAn4QVoxpZRLW9uvAbHymb+Uwf9fPNT3+8cJAGTDh5PBr1JyMMgpK2NkAbx0wd/WXOvvmTwl/w46jlY9UrjwV+SwZ+YHvzz04M/bVLRwZ+SLsLgn70rB39ZOqj5glIScLxsE48MfpmpoKeMN2mAFo+6TJp4tHMgeaWDwb+PUdqNU0hnGJIlqHjbbZOFLVkb0T8tc6bdRtzQpnsOOk+TacM12jKL7bZZgFa33TbnUXze3MR4vumnblOkb76OvM/OC36YnmXOtUNDCJVKX0fAlvNT9Dx9AtcZ42Nfvs/slsnje5AeykNRH4DdNH2iTtJyaU/QgaKHgo4UPRK0SqmYk009bfIgHad3nY7Cw/Su009LeVZ+0sHUxM8ZcqVTATPOE7I/bfLoSZRk/yhWSl3dSh96V7F8QQdX4pbJ5M1VOYtkvoh96ti06CriEgn1aIKaVerxBHVZqScTVKPUwQR1TalQue3zZYO6Saq+s3mapOVxUvJWLCFznsv4gtir4ZRApIXeUjh4abjod16PzJ2WbrIOz7RV3cVXvK6BY5V4pMRhlHioxEGU2FfiSZTYU+JxlNhV4lGUePJ6haaQcjR/8jq3h0oVOyr4SL0OYj9boYy37jfeQLGXh17/MImxnKc6mbp4ODe+jud5nU57Hd1mVL9EtKtoTdCeonVB+4o2BD1UtCnokaIdQY8V7Qp6EuxnBB0o2hd0qOihoCNFjwSt6vbqWNCaoieC1hUdCNpQdChoU9GRoB1Fq2/I8ypaE7SnaF3QPlAu62IksRdrvCFvYIjei9pA8/003kDZ8apY3m1o7wjaTGujgeq2X9tNSj1CGZLSiFBGpDQjlOrrlbGqQZ+BlG6E0uFVnXRI6ZLSjVB6pPQilD4p/QjlkJTDCOWIlKMIZXiRXVbS9gILjb7W/eorLD7Qpgp2V3tbsHs6uAS7r70n2CN9IMGe6MMI9lQfRDAx9lr3+4LWFD0UtK7okaANRY8FbSp6ImhH0YGgXUWHgvYUHQnaV7T6qnwbitYEPVK0Luixog1BTxRtCjpQtCPoUNGuoCNFe4KKcde63xe0puihoHVFjwRtKHosaFPRE0E7ig4E7So6FLSn6EjQvqLVZXleRWuCHilaF/RY0YagJ4o2BR0o2hF0qGhX0JGiPUHFmGvd7wtaU/RQ0LqiR4I2FD0WtKnoiaAdRQeCdhUdCtpTdCRoX9Hqijyvos03KmYju63WSrFtu/66uRaaKV0OTZSuj6nwHM3AjBuBas2Gu27eFc1g0T8R+0/XMu+IWrDoHyvJMVsScL3oHykpbnyJu35LQq7viqbohrgq3BbDkqKEWqfxm3sWaNZNmp2IsWkCxLSG39iBuT9DSNw1OxC14Lm01KYY1YRwlmxzF4r4qlB5WCbFsFISKBVXZzW6xw72MpDJ4+Zsm9EiKHRBEwLm+/BvgQolgWARiCS0g6Swe2bHLz/OFmDf99+uVLxN8bQowoPfo9tFfGyI9eR7L7Jty7XkwRPichF1wFgWBwzjzomrxrzZHKs8aF0EO3HjQAuWgQH4Ju27qU+YF/I8xH+SRc0wJ+Q5hEYheZnktJAXICKTnCU5JeRF7DBITpOcFPISJFiSYyQnhHyGbvzsDZomyr5wVy52CGXFOrjJZxTLDjwmhWgS18RhDv1FFRejpN6c/60XT67Of/f6w/i38D5pp9vi+w0sdLEzMnR2OWih/oShA8zdFgME0S73B3TsummUS1c0eso8ajHGVpbCcvNlNnQv2+ZHTOngNFSkPfTfW0HctZdcsYtySDuQgoq5WPfvrSzGzI7Z27b7KfldMDtr9gJ9sz069rH/JSIa39AYXA5BE4JrIbgZgqUQLIfgQQjeDcF7IXg/BB+F4JMQfBqCVSuEaxG4HoEbEbgZgTsRuBuBexG4H4EPI/BRBD6OwCcReBCBhxF4FIGrdqT9EbgegRsRuBmBOxG4G4F7EbgfgQ8Vnty2Fv2aByc2GUYRJ7sCQsdYj731t2ggfKXibeZiv/ztFXoCV//LsxU375TxTa7Z9W+v+MN/kviw4nftislnL7k5JbsbJocLoDSgcUL92ysZs+E7X2M1sT3UaDazRboZ//K3V3BiBMPeWMXN+zE3Z3bX7KOMh/ABG9Ts0mUpb3II6emV/OWKu2VyJl/xT6yKt4+AcFdDpYNFw5Fdk2O23z1Yu3GIPzN7mCRDe/1suW3iL76j2Lly23PCw4AQhC8XdkJbM3ax34tEtIMubndCtdV0LVnJHLMH6zVpxIPPUxOXdMvYTVqqWpWgluH/61pKrAfGUXtBTd/6nDVJFawwYcYWxEcSSbUUTmgb3w2LWpjCSwb3emach7e8DXP11kd7sazZNxvwGcnRWU0dpvKYkA/TOqGr+BxgxyGGid0/mSgdRErNLqwiI4Wj6KXN7+AujYzZRYAbbJV3EXWGJmFmFxFnhNYTmtlFoBkhHSpbMzJsxFspMHw2Ifhw9eFe7Hcts8mladdpYMzrA3K6HT+gYschFn1ALR1ESsMH1MJR9NLmd3ad5rdXzK4aSmLhV7NILP5qBAkBQDWQEAJ0FySyQjXtzsHM/5MVhrEZpDwbPaPGk7uw6PQcdFFIGaW8OLoqrQEbuUb7ddRgM7geBKX42KJukyG5jCM+20lSa5+siIfYE/l5Kj9V9SKr6W9dfxv6+0h+7pl1U9iL3YUPmj+oiV9OYHb+YC923y7jgRc07OEuIkGpzyMC7Yi4uIsIPEGXVRfGXTbKjLtsmAm6bN0ZZKhBwdRVCyTOTf/42ytax6Z/pPQkAjooPQUepafR2G8HMu2mf6J0dP9Q6fNm0x8pjHtV/9SKphPa9GsKL6KzFYaw0lD4DLuj+aeibkrD62iYVNjynOcMaAzfvTMGEFRbS4RKMOojBNe/BUJwB8wQQsSYOcq4Ek1wnV73VluCE65DiIPo+xyTR5pGp3jbzecyTe7SuMlqi5NwhyAdhenCLLIqnZtFXqXbs8isdIiW/qerNGfZnMPk4Zz1ae7AiIdN14Gtq9hWtZsM0mqLAVa76SYQTZDmIsCSDBOwwXiKTTeFwIQ0NwGWpvv3BsMwYjLVSWv+tmiNNHizay/EMjGuacefyIrZ+UReA9zGu5+Er7b3Sfhq+5+Er/bwk/GrXXean6y4i7TG3PSPpKBFV2/05UKLTuDrJmEyLbqHo8fnW3QcX4civwWPcrwUuwWZEba9i9hGZMwmrAebn6yYTcbxIYAbSBRRaQWOumLaOpMQGK02SYHxNCYlMJ7SpMeeoKPqCrY6m5QLdk0e281YReUHbyO7wzFZlQEonM3fTURZA55alKf+32emedh+yhLcWX57BRtOxhuFL6EfQyyHHf8oVWFEorLZXZqPWfoP3pXbiOlUohPOtrkSqGP6KSk4oB8Owbv0wyF4j344BO/TD4fgo11noOCTXWeo4NNdZ5Qy27BmByqql21My0BritYFrSvaELShaFPQpqIdQTuKdgXtKtoTtKdoX9C+ooeCHip6JOiRoseCHit6IuiJogNBB4oOBR0qOhJ0pGh1Tp7X1ucVtKZoXdC6og1BG4o2BW0q2hG0o2hX0K6iPUF7ivYF7St6KOihokeCHil6LOixoieCnig6EHSg6FDQoaIjQUX1coV5byyzjdH4Cd/3fEUMdLfNNgzi8bfKv50kN4DPzXYuVkutfuGNIE2tLyGHMqJuFfyYW34z5letx97GWzEJxwWxuxSJ/buJkGR+qeJuSjg3N08Gd/fNmN9NPPZyb8Wi3rDrY7VH/GV+sdhbe9TkC2dzKljma9irv8i4NlRJv7EyNvYKNDWwFApUNDD3qh0GGpx1v364MrbnaRyujO3AmofBjLnudw6DGTNncI+u1CVtqopLrscCYWy3md4ux1k8A6wZYPPAGgE2B6weYGlgtQBzgFWBrftduYfIMwiFcBInvad0KE1S7XYTS99AivqRomQbh3NDKTiMFCRYMIr7lrvvlM2+2YQx94cSp3EictDOdACmnekATDvTAZh2pgMw7UwFYHL3TQELW0Gl8X0cjEwFfspP3zc/fd/89H3z0/fNTwd+yk8HfspPB37KTwV+cssZmdBns6zszgSVo0JolrQ8SzKzpLVZ0uYsqTRNmgkdB2rO7DIm0AFV/0DSOHEkmSngCRnIsoTWEMKR0DICNxIqQTzO8QYaUJzkzR3nESTRXPTTB1q1Klwyj+GPW16luFLCiab4l0B8UicUCmDiqUIBTNxZKICJ1wsFMPFMgtzmW26B6dhtvc14qK5RSILghTE3lrswIsdi1w4je6vUhdFMocsRJEbJTQfj/J142eQQDs0UQkkLLpU5TLKbJgdZZc3kIKYYpEKCNJqDcJI1OcOIzvQDRqC/2pF0Q85PV6BD5ZHMc3F/zq07ZUblJnhAMZbgXcq3BO8x7jXB+4xgTfDRc7YDYVYxmWKib0RyBDB6g2hmixIJpyiRcIqiiC1KJJyizHXFdbEWwCSN5TGFluexjNqV7JfNBtabmNneiDVtCSIUE1qaoX/SgmSJZAVZJrIsiCFiBFkjsibIJpFNs+Gt63LBQGSWrl7RZchdGK9VroP1EIFtozadzIwQiZMc7Iq/Fxo1NCNOx9EYDKtmYdKPGLZsDEeUkHBEtNo14iMKBTZia7j0D0uLnXDMte0ywmLWLHS9LZs0Z/KFKPVKNISKhr9GTP4Wx7DKhIzpk6A1qJugzEhKUihJdh4pKaGk2LekpIWSZteTMieUOb4ZUuaFMp8xV5DMIWuu8GHwyghl8b4ILeNlETJ4U4TWuFGTU4ArDFcl7RZp/gol2XE0ueH1ce/K4UCLmnW7JYvVgbnClC3r4hVusXFWYARrrjB1ixbO81nmURiXwpOwcI6PPqcHBygchIVp9lRaNf8oHIaFKXZsSvX/KByFhUm+h2R4CiBiA4NOJSQSVVLiUqUkSlVaYlbNSTyaeYnwW7XMFftb8Can0W4YXY7BwBmcu8no5AwLLkcD41AeGDpQulC1pKcMiGFuFnF2Y5ZwFnSGZ0FNk21L1CcrVHOYDG6xyFss4RZn9BZohue0jPNg0QotqDhExxZDUFhmA0OpWD+Uu/iJRaTH0w2nvPVVbA8jsh6FNc4dC82MBL+/gg/nE8uP3Rl/MUfXH35jL/YJA7JsYjagte8G8hW0dE4Tm+577ZZOboLfbbd0lhP8oN3S6U7wcrul857gpXZLJ0DB77dbGZzxiRSNsyiGUd80RRxAteXwqcju9RIyMVt6OLdMOMUg/VnCaUboTxOea4vd/HYu1kxGJirXQgQwG/cbJETr6yBG/0ukdNfKIGwY+YdRfpv2jPZDcqSUY/RSjqRyVJMv40goR+2lHPPKUX8pR1w5Gi/lKFKilQ6e16WhCHPVtnRuUheSoknp+lI0wbJTpGstDdg2IA5gO4LzSmxWst5rCFtcx0bcHLhXNE2wewkhO+Yee5tMt93D/LEN1c0TTc0soS3n2uozx7hZ8211aGPwK6TpUKczhtNaaKtbGO2e8UGKxxajWi611Z2KASrlE435h/9Awp8h7yUsKhnSt0XR8rnntD2r5WY52I00pIGhp252we1HsJJTFzW96bFt5H41R2cD6rl4DyqvDpgWwW65ZznUtfZ6UHs/rH0Y1N4c134U1F6N1N6U2imRliXpQss9J85g7nlxQHMviAece1G87txXxNPPfVW8C90V0Xq5r4lbmbsqrmzusvjSua+L/577JfEZdN8QP0X3y6Ifc404qLmuOMW5nnjluW+KJ6D7lngfuj8iWjn3R/H7FOllcXDtJoxFgdNCND4bcflSsG/GmhFBXsjxrW0CyAogHLVPZGdiTobvtL34CxdyZ1xyNMVfuHEowrJyWpx6jkyqSXMOVsdnMVtnZbYeJ4kycnjwHRpcY/fQfMGtBlaqthzYj3BYfVZyypAwBOFcoPhu7TqDNA/Flivb9q8ncBggiQ/70BR37AojaGMvn3uLqjcE7ceOfscU1+y4W4SmcduGxF/ctr9pcmZn234i2IeCPTI5k9u278vPH8GP+P7eIzgA+PsJngC8i9g4sUr25+wyg2R4jJWBI17Iwp4DP5CJzsxHguKhLyZtX/NhmjyaCSJIBwVsyQSYl1Acm4zTIZkAlZRmBA9mAqQ1mY9ZyX7gFbHdMEWmAixGUwEWmUoPRZoKEKCk/dsZpwLMIfAmaYXTUgFak6kA8+R3PvT2TWGcnC+HLceHXtnsnJIKEM8oz40LmZowR7sR50NvJ1JF0exPpgLMy0aG/AUzyVqeTAUoWysOB2jvOEyyD+QcyfDsOQ21Bw56020xbLDNj2Eu+VHMIz8ic8hbmD/e5NzhYd5wwzmjZ7UwMqtz0ArzkDuNAW9QxZdRxRtSxZdQxeusYhlVrIZV9KWK2riKY1bxGqpYQRWvShWvoIqLrOICqjgfVnEoVdTn5Mlqtlhm8Es7srjjafHxYF2ARaGNwVJPC3vdlm/ymJzw+CBTmkwNZWoo0wmZsgFTlkxNZWoq04BMywHTMpk6ytRRpiGZTMBkyNRVpq4yjci0FjCtkamnTD1lqtrcQgRMm2Tqp+WsvKezg7mU/Q8tzh9YJ69s22kkg0g+9orj2YIH8Gn6wDFsBYMocf/LJUY2xBuial4WELphIyCUuWsCQvu6KWB6l4qJDSrKywI9wk4hJ4vhLjUTG6JWvicg9MD3BYTi9pGA2V2qLiD37VJvsUFledXSe1o8xsjJ8s7TjZws7Tz0yMnCTm95wst0kyd4QP94gk/pGC+3tugSn5MFh87wOVmE6Aafk4WJDvCEDT3fCd6ly7vc3qKzu9zeopt7TpY+OrhLf0pCQulQm07thNfozU7wHt3Y5f4WHdjl/hZd13OyCNNpXfrVpru6dKxNR/Win0K63OKN/6BarZ7QZL1oiv5/41T8Jx/ByiJO/E2iu9t2zE/KwPF2MLNk/6x1ehV6pV4hvH8OvPWkTDyI8bp748//1b/wa3/z1/5u7doOj2+vbNsdG4YgGHjb9q/ihCst5hv7kOrsIBBbwc8yo680pYyFbM+UsaxtQcXpJz90d8ye2cexnQs3tKKD0BVFnRfNluFkz5Q2lG7asohsMBcc9DAcW5hgqK/i0GiLxSnfarspRqJ8IW0x6+SH0WZWwSxXDq/oJ0XpCWRfkQJcnZc9vhcYldAIZcPf/NDLVfhgXtHkRHs7XiYjdhCrbQ0ok/PT3/B2KpG9Q7gH2/Ct26ttPm8QgAUXZCsvv8A+7YLlT7nAOe0C8ykXxE+7YK2Cxz79ggQuyJni+AIx/Qn60T+yZSzF9mJ/EfOZvW03wp2pi97Fgca7OkzyHE3jiSyvE1FaoCzeWl7ngGWBDKaxvH50awJtYhLL69RVEqi8Ky+Rk8aBQHcxh+X1K70n0H3MYHmd7B4J9AQTWF5nmacCYXqoWgLXZAbLB1NsXWFMkg2FMcs1FcYE1VEYU0tXYUwKPYX7Monlgxn2UGHMkEcKY3I7VhjT0onCmFAGCg9lGssH0/NIYcyuVVvbL9NYPpjS6rbuESxxjmmiDM9iO2V+lfDeMUWoffWIgoao9mNEpWYQxTh8aROm+NjL+c5Hbhn2UAg8/TWqdL/1kbuHUyye3e9gnOp3/oyfbFp+svKz/Aw64Q0/Dhukgh9HhOY9xhqgxVg5Xo5Ww0rIT5slObA3ZfKb4q3xlh/mYgsOLI/2eY2Lic+6vWhTDh0TYVRs6UMUZh6iTE4+yw414nucJKLPsik/95/pLPVMbLL4MDt4mJ2gcQWcFLC+HTwY69uR+uShrKmHKsh1tpFItQ8opltcbixkoJ2Y3vL48hCYBF/i7+EX+w4ffkF2xX0Hn6HJ+0O74t3kzsO33Kv8YIreBmfoy3izyFfjJ9717kCR6mNG+mYF6wjVVYrbHyO+YemZZzHO4TPPfuhd59QCl2vbXAf5yTNRP5rrq571EFGvr3O6AosjLB0LagtwFaI8NnniwnPCsN72NI9FnoTwNOxnWsvD1QyKK14JQamuL1LXnvzQ3ZKOLeIhSr7zTUaH3Bi/Dpn7nW9WXLxe6yP3FsYuwDt0LPyTH7k39I3t8SzE26p418Sw55rZMuUwZuqWnA6DzfrG5+Es+HbFLZicb+ON35A3fgtN01sVxJ7PxdgroIIgb1hBw1/KE9KPMfnY/5PvLcJdLI2PKA/vzQ8r8oBbXHMLGMwJU9IRf9uPudf4sCXffhwZ+Jiyb+jzOt/0chp+zTL7JodGBPFcbwXPy4VwXwpcy9wy+2ALIojsh2zZz8e2/I3Zm+bG0q92XRxddwMf2Q1TlK67fWsxNtHuG1LFjZdUYaGKa/iQrpnbUsVlueIy+w8mR5M9Lgtg0S2Y6759wLvlTcFsUajxynIxaX7yQ1MS8p5WsRfe1yuY0gFvmFdB6Ja8JIxO+RLjMyOTI/mxd20RprAFOLZellMzuLhioJbUeACD9R3djaIpJU4yOqjGbnbvcJx6ZWUrh2zlKNvkIC1JN23FP8cdMjQQpUtHG37r+L7f9W4jBpwlHf+RewNEfGnX8ABbsHzQubYwnmuDOzGwlsh9m/CRTPMwR9tXRvvKZktfo0RhvUGL/7BVQU2sB9aurcAGNv6+LA56oSUFGT9hNh67l7V10uTr+G54jn8Nw6xQcW+YgrklzYs87W0m9JFnlYfkk5X0yfaiT5aTJ9tTPcqnPNl1iY5bOv2ZsKbdoCeMsegmqqP7sobvsctRC2CvFMEeeFvf8Apwfl6Ed6mNWdSXIMR5yfeRl1NOmAK4DOmEXPLqLu/7Fh2qw/8QojeSoyOa7UiSizkTWGICi09gsBOYJhxME+5OE+6Fd8di4OOR0gtjCCxPp6+JHKMopWZNV+Ns2wsLY4ie2DNX9aavuvFnqtXqUWzHzvox9yq+WN+PY9eWp5oWHZjYti9EuuznGCoRrFitF6yMLtDx973yImeRO5jtxS3YfqHDGLaLpKVJS8u6q7QsaVlZZ5W2TNqyrKtKM6QZPORVc+cjiANXTfkjtoL3i9gxfd2Nvmc8vggDbMNn8DnKl/0MPlv5lj+Dz1I+E+XCfu/dj3zrF81VyHQF3/pFdy8yTHeWnJhlxyFv7viOmzNbi/aCg04XtMQYApRGS4sx36b0lDNbdPK/CYVszOTcHTj4XzWFVfeq2TPvfsN911A4g0FDHse3kMrMVd/66Na2PZItdj2NIAThbjtGkBF2t+3G3JsxPxtst3XHL7socBbM5tt2bMeOYyX8hpdDWApaGpwVu4NzYoVwXmwSLoiFwkUewrmviNnCq/gpuSv4Kbuv4efAXcXPXXcZP/fc1/Fz3/0Sfh65b+Dniftl/Dx1DX6qluvit2a5Hn7rlvsmfhuW+xYTbeFEoKgnAkWeKPwYo7tb7hp++5b7Nn4PLffH8XuET6HIkwQHvyeWnEQOLDmBHFpy8jiy5MSxartLvL8tLn91G6c6bIFtcgj6QAW4zVQTTSrA0zgTKFLfl2M6NegYilTt5RiggqU9W3TmmTYL+0TXcBBVZKRBrEE4iIKuYY1xqGxx6WNGeZ45z7fNElSk5gw0pFmj3LDR+FFw/xi414T7bXD/OLl5KuQE3DDv+DK4Dbhd4fbA/Sa5qQP+kYAbz74C7tfAvSrcy+B+ndxU974RcMOo5Cy4eZhxXrgvgPsiuanZfVW4ZZ3Mc5gxJMiGyi1BztuisSXGCzq9qNIzRqI9w5yOMqe9oggAG7KeTDNno8wLOCJQ5uVTmJejzFmv6MeV2ZzCbKLMF7yin1DmtVOY18bMG3LUB+MmCXhmtVtyxr4hB42WWEFh14qz8GZL8s2zdFlKl7X0AGdIyBTWbjZbOOteFjYjbEbZ7rabwldFnC4AsIJvtnAibuSKNbliTa+4F1xRC67oIagXgAG9ZVoww1hj2qcd2me8CPU+qcDALYtDmZSYIrHakmdF+KwJvjPSBbzrk0/hy0pnsFEd61MY49IdbPTJpzE60gtLzJxmfwqjJY/sSDcYfXGGrXa0W6VDftBb8t7QgmzwkoSpGjDVrOC14YHO8HWLSQhfbTN4ecJ9L3hjaYZS4vhJ6svJBq8rGBimHbxPvCu8gZ01+6/bXk4HKaI3jwVH0e/LhnBnze6BLRz41gy3iXL/NXCH39Qs93KUuwvu8HOd5c5GuX/V9nYiM4Fw81BNU5SnJdmffIIxb0c4Y6dwxsacUNC+FRMHYpy8rtmNOaoUg5NYuGjy00wHh7XwXiAlG5znwl2TMciWg1MyOG1KVLLg0Auum6SsyRnWrrkEQ2tZp69s212s4peQ3XHbPoys6D2BB4D/GlSguTdj/jD22IMe31S27WVdznfX7LS7A6/IBSqhi9KTUNZzh3Al1I1f0dkm3RYzwEA3TjNAUY3TCJCacTEB3NDRw/cddcf7CTHt2cUMuSG+cGv2Mu9G0PBVNiUxfFGrSvNeadHgce34CbEbQktYlhW1HlchlpXYMGmj6Pq4nv2EKYr5HRvLYsNiw6by0gO2nmVrLFvjMsuyu9QBs2xT9oJN+rDDEeCtIKP6pv0tQLWf9a7QY6f8mIbxdbVK2aakksZv33LnaOhjufP4bdpuBr9HtrtA4x3HXcTvI3eJVjYIFbZNgSUrNlPuWXoA2O45/B7b7nla9DjuBfw+cS+yVst9hbXCImObcssKfru2+xp+T2x3la1y3GX8PnVfZ62W+yXWCoOMbYo5X8Zvz3YNrZls12WrHNdjtRC/tilmvcVqIX5tUyz6UT6s7f4YH9Z219gsx30bv/fdH4dfzlyFN7HUTLDNW6mBjk1soAY6SBXLG6uBTpylh2qgk2qzcKQGOgkWdtRAJymDEscGcCh5EwZ3b0EK+REmoDU/CmONH4PNh1nDbPq2Ca8wr4P7S+B+Q7i/DG5DbhfcXsDNz/wi2F8B+6vCvgL218i+CvblgJ3zxBLY4S5nssJ+FuznyH4e7BcCdk40P26YZJf5dck+z6ibZF8A+2LAfpK2v8UE8hZHI878t/FF0wUGtpp0bxGb3Jj4ySBzxRVxAG/TAQ9lWfGSQdgwesDwPXjxNqK/wRYbEA0faT2TZLpciTHWbHpz4ibDwAheuuUtwpSz+ULcY7zM87bHuBYZmOPNtVtip7lpEhAI4UTRwhKP42vxr/EWxAU0Idl4k2BzyMa0E+BbEE/QpGTvXWrqOfoCzfkQJQJkZNzoIJxCmgaUJt2kL032L1uMyjDXDg06muqVGem+qt3ybPE78qznYr4ZdOLIkmQ/YukTdF+NV9gSvUNclBhW4kXUiiTxwou3JbztJnsRggKfHZ0MC0U+YFKfyOEjWOyOsJoXGTp/wiFrXmrCiQ7O94/Us2cDFrS2yJiSGY8hLpqejQB+RY190fS451n2Em0Pc2+JYluy7c0xxbIH90BDucZuexnGobSa3kLbS7RwLIaIlvO6OcgwGecmJRAsjxNhBZGF06NrZduzm/TxjpRiX4LkQyhYmyxwQDvAhn7bZmz6bZxb5rZthq7PbdsS1N7HivjrIfjXBTyCzVI3Av+qwA3E6JOQ+X4P8F8SuAu4yQRRViX7c2Jopl6drqP2aowXep8OujA0lsN6nvu1uPyNbWlPvgc7L4l3mGP0UES9i4uUZBuHqDXhexAX2wtLdMmJscc4Dx15oihHhT+Q99pRayQYeRyp2c8oVnFzvuXmYdLOdGzcS8DJt5PWARFvw3U4LSKQx0UfPuaIBLhkbDFrlM+dYTU5XIhyHGn8kxdeCg/YbFPi9M7yeyWS9c7RzBNfwustb9ksMxYnVClLYisHBw9ezS0irzuLIQebOVz1Sss7b85HrkrLVengquBu52DTF1z1asu7YC7wI6TahptuE+zTIQR7GYmnifFtm3kz15LYlGGy8pzkWrXasocXE0GEWmRqLNZiPMwzjjzrmrfI+Qb3X2l5F81FTg24/zzjFvOYiVdjFiKrWWD6cUda/RovaHlnzBm5KiVXpWiZrDEVk7x6jkRedQaxMec4BUsPQWaCAXqOlgre6jMviFQ7/PihCeEH37hFfnRnUWyW0JlFsUzC2yjS/qjZRG1oiNjasRk54cJz5AKuppd4Njb7w73iU/d6HXbtryBm0avmnKyVGayVC1gSRQeQ/vQaNuAt/AR7O5ytb5hVHLZvmGWZcOZwCL+BqfKu2TAXZcIoPzYXZH95ftfB8UUehvF5b2MvdvhIT0Gu+PVBrOJuiNH8FX/wv8QqZjfrCdOpLM3fjAVmBrV7KD2OVcwVv/ObsSBy2xW/IbRulNYUWi9K6witH6V1hXYYpfWEdhSlVY9jGpjgin/8m/jkuXb+7HiJetoCuAwvi9+OVUKpC06dA6XI2gUfjqFSsOqHoV/a4WLIcNHb3APQJryEJXmbCoTpC2QtDC5Y4wUil+s193jNl/+9f/qTvf/szT6GkAsPxqJdNgezTnAHs/55B7P+eQez/nkHs/55B7P+eQez/nkbs43YmG3ExmwjNmYbsTHbiI3ZRmzMNiI+4wuYk7hKmJbEGqdIV1qnKYtI0YhjDnxCbObcbqluTfxRafl0QLNRsS+EHxp7F5tCiYwl1CfsYPrAcYFoqa3UU/YyfRGZzES4qxZ7WgyHeajZkpO0GgvWxGSYZ65yQZ10uL/BOaisN2i28CR28CTwqMKT0JMWT+LIkxyoVmKXLZfd+wEtfHDqfqAJpgtskpz9HtDCJ2Y4uDalFi51LwmHa7VaiP8udsbNF1/U4XrsdEKzQzHkwePEW01diWAXnYN5jMgBcexd6ZsoO3KxhLRkTy62kJbsysUcUg3WxCJSLdbUKFJN1tQs0hKjNZgVwUwD81fxtJnNlpmt91s6vWBew7QU4HXBDwO8IfhRgDcFPw7wjuAnAd4VfBDgvXtyw9Fvc1pDK5BO0lwyl5C/VRQf2RVvl03dXYRQU0sxN6klDurcWKIDCD3i0xN8wkcn+JTmVJuyd+Vb2JQtKN/MpmzUaU61KbtvmlNtypaa5lSbsk+mOdWm7H1pTrUpm1eaU23KRp/mVJuye6c51aZsyWlOtSn7bJpTbcremeZUm7LtpTnVpigKaE6lHlM0p5L22zQLlfbbNNSR9tu0C5X227QLlfbbtAuV9otdqLRf7EKl/TZTF0n7bSYtkvbbzFAk7beZm0jabzMrkbTfZj4iab/NTETSfps5iKT9NrMPSfsd5h2S9jvMOCTtd5hrSNrvMMuQtN9hfiFpv8PMQpvmEsfOoYJp5hIimGUSIYLLzB5E0DBtEME15gsiuMlEQQRLzBBEsMzUQAQPmBOI4F0mAyJ4j1mACN5n+h+Cj3YRKJvgk12np+DTXaevIMbdocIYd0cKY9wdK4xxd6Iwxt1AYYy7ocK0IlYY466aEBjjrqYwxl1dYYy7hsIYd02FMe46CmPcdRXGuOspjHHXVxjj7lBh2kArjHF3rDDG3YnCGHcDhTHuhgpj3I0UxrirJrX9GC8KY9zVFca4ayiMcddUGOOuozDGXVdhjLuewhh3fYUx7g4Vxrg7Uhjj7lhhjLsThTHuBgpj3A0VRhzTkcIIYlpNmStr9uu+dZtB6674NXrlUH/hD/83wAi1dJTE7pBmJjROhWsOV1l658jq3ZL1KKcuXpS907JBzslKD3cjbrtAzaoYQIciSu/Nlmwgc1S84g8E+WZLdpl0qIGTB2V62V/nxMoF/hLcM4C6mRHdC2Ky1lICIyBrXeEjh6kbRT/jMJ0j4ROHKR4JDxzmqYbCJO5S79SIu3GqnOLi4NyJizN0Ny4u2QjacSA+7JAY4+KMnXYzXNvdBXHUXuT67i6J9/YZrvFuVly6z3Kdd8+Jn/d5rvXuBX0WeKJDzxXnwt+iRuYw7gUeEwzAs8ngoRfoSHEetBOhJcw50s6Cdiy0lBEnkDOgHQktbpZIWwTtUGiOWSAtA1pfaNhp0v0MtF5Kxyp7qXavyQBAMmTZYXWQRgj7hUBAl5jDDP15T7WbNaHWpXcDal2oDVI7AbUh1Cap3YDaFGqH1J5Qr/h9CGS7Xi4X+zXLxVlBbC/2axAl1qeieqxPR/VYn47qsT4d1WN9OqrH+nRUj/WpqB5ecS/WtyC1xD+WUXsgPmKHokY5FCGHIZvbiBQL7wqoQTx47BYl8Qu/L/94gpgU4skEMSXEwQQxLcThBHFOiKMJ4qIQa3aUuCTE+gTxjBAbE8SsEJsTxLNC7EwQRQ5GqKwIkQojnHExjLY7L3K5pLbuWoh7A03WKyJ9Sxrse+6rErpD0mHfd1ckqIekxX7kvibhPlxuHJ64qxIxYFm+tNflQ/2SfKFvyKf5ZfkmjY4XBsJoiWOg9UI2BNB0QHW78HA1eGHGmNWWsV4YKk+hBDr7cBWPTu+XL5vXWHgBmp2syZoLD3jOSy+ZN8wKC89DWXTGnDHnH/CwmN40XzKvsvBcyzsHJ3tz7sEqXgjdbpzn1EY6Ji6nwRxKr5tXeEWm5WUkejf0MibzgOfAdMBZNhfJMt8SvVKXOa3M/AOeANMvZ/65N28WzbxZfLiKUUH3n8xzL4MAAaxsTv2D7Oeezahx6YerGGl0ILoAIkKcpOSAnA5G50GEM2ry4SpGLx2QzoEI1TwypSQgjWbkK0EoI2wq6BpEdVacutm+4tDsJZsUBXVTmTSpJsVBWUe8FDMgHSu+5qWZKOZE8U1vzlhNinE5hPBrUrrLmZQ526TQlzNJg9O6GsAE1fBVhypQKOpHNrc9C00KlDkzZxablDNl2Ih7mISzuCdQVrZEEs7ikUBGNkMSzuKpQJvYCPixhG9lvEvcPFxajOFw5BHPRk7S4kDejYvDbI7bCM/WhmIngRddV+QJBkZDkbqFLm4q1rDwFjqKNS28qK5ifQvvsqfYoYXX3VfsyIJ+/1CxoYVQF0eKjSx8EceKVW2MnZPgDjZG7kCxjo1BPlSsa+N7GAV3sPHpVOOCHdveOcq2ORHbvfMUb+UOjneBEm5OxHLvIoVceVrHe4VyLkKiPIKRHuOMnPwCFE+DWMW8ooE2fjdWgb6NETkAX9DQHYDPa4wPwOc0GAjgswIfAc4KfAj4jK5BgDWQRw+wRvzoAl5QxRlgDRPSBDyvijfAcwLXAacFrgFOqeIMcFLb/zsxjVV4xR8C1rgkA8COuNMangGd/EKLTqXM8nmCAJI7eLbfiUl8Y9gTwLULawryNNScirg2wQhbnIslWWeRguDnYNzxaZV3kefqEqXl0f9f34Lop4rmEoNhxcSzbAeohsO6xMhWRmRKOVV2xVnXdWRtisvaFA0ItOmmJFWEm5YsEO6cJHiQ5bNjy7LZx2k9My64i5JMwV2SnBLuGZE93KxkgnDPypIg6+uhLQvriS0r6siW5XhoyTpcs2UBbtqy8vZsWXKPcF7PHA7usqRnwIH9207afYifmPvz6LJ/GKsAY3dc8YdAHxI2P7/jDH4GPfyPYhWTY3Qwdj7QHfYT3wvQ4hhtkBmjMUi/csU/gnrGMq9AbH0VmtsVqAHj5jUczK62myZplnHU+npwhn7FP5RLzuASmqmdlUvO4ZLzvOQCLrkYXtLHJWnmfsTpy7wcd+OkmAfdTZ50myU5hVHRJ46AnRKwaVl3YJ1/GKtoTDSgzQDdJNoI0DWi9QA1snsL0GWi1QDNEh39A0Vle9cLSg+I9gP0LtHDAL1H9ChA7xM9DtBHRE8C9AnRboCW5Sw6DY3XUOOyybHejjlwt8Vv9pI6QMJ/dgvnvrHHXvmtmLni5fzj34lVxLw+5x+fxCpuiebIuVwsTU2yfxSv0On2JEZncPgR2GWeHHj2lNp5e1bxvT2r+N6eVXxvzyq+t2cV39uzim+xEJklpmdJ2VnS8izJzJLWZknTzbjEc9JZYnqWlJ0lLc+SzCxpbZZ0SjNKXmKaeGq0QKivZkl3Z0n3Zkn3Z0mPJkl+Cu5ca3Y16VvviTF813ruzgHoWN78czfjfMykZzCtK2DPsGAKMANP4QdRt/Zp3JTG7xGtrU0egUaKQUrU0XV8R0WsCwemeIrbcN5P3l5ltKFTCxMoXHtJYRyF5iWFDgqXX1JoozD7kkILhelxYdSdO78q1stxHqI6rbbEkUoyP+88hHwmREReylQzPM1nzDLHpB56e6uMtpR+DtuJNIwk0ibRGt/pV5oelBcps7cqCU415a0tu5EyA1dJQLnwmpYX59E38uNK0JRVmH2UTBEeAYuWnzRbZm/V3QrSc6duxz82WwlziW927DeIjMkFjUJeMNsatHoP7zuBWItuAY6kJzFGUjYF//vWR972Uipm41/MzphthKfJxR5htJUjm/vBz/CQCEk/clzYAg/+e56DXbdS5ETqPjVl8H3KcQ0jLy5sBgiu6fyj2DjIfFa5u1HuXpS7H+FeVu7DKPdRlPs4wm2U+yTKPYhyDyPca8o9inJXfzvCXfvtkHtTueu/HeFuRLmbEe6SKeMAHBd0ohd0oxf0IhfEtPp+lPswyn0U4T7wk2bb/lg0A5YuJNtvxUyZ4i1iEeRlQBRhrqOfP0xUxfUybooQ4fYkzm8R0t2WxPkt4szxqiZvgvPIOMplzu8mK95lCel7WdSE6xL6nG4piyL2LYnYd0bEvrGakGLfORH7znNuF1Gci82F8PNoc4oXu8SLU+SsGCi+EiE3m5zsxVLx1Sl+IyaLy1F+zvpiu7gyxb4pRoyvTVTfNGHj/hIXg7a5GKUEB+uvTLIdoGmvTtLuts3yJAW2/CuTpPtt89ok5REPZ2Fzaq6qTLVttlSc2jZ7Kkltm30VorZNQeWnbZNX0amoAiwORA/M9njG/z7kHbMtwuu2uQCDsucwf1mEdQhjlkm8MhOHRJmARImwW5Aiz6Nh7ZZJtzji8zoZycDblzGnc9WWjLSrOsgwUBB2+2MsP9tGA4KpBVAQxIuhGqPBHptQTZTMdvaxW0T8byYbK3rrfvJ2ZtUtmnVOcONY8TkcALjbfoxKh/r5QOmww5B7OPY5J1gnCR3ESDEE29t1Bop1k9BCVM8L1kxCCzHUsl4SWojaedh60Vt4x1yidff6dPDnfx3qWjdvLmGFuCS23ypD5sUFd33Bgl/bJUZmQbNK0qwje7rO4xnKyQxlMEMZzlBGM5SqM9HcwnRz1yVywg4Sa05JP3ALOYU2OIU2PIU2OoVWTc7SatO0aanXmcKn67U/w2bklHv2T6EdnkI7OoV2fArt5BTa4BTa8BTa6BRaNXVKP51Cq59Ca5xCa55C60zTcn7jTAWJH+xK9vd567lY38E4jnMcY9FdqND7HRutuvPY23srZvb8ZWzQRpKWcA8jruZI6pK9UEAM4orhp+54q23vS5BBpjmywnFgviRAw2l7b+w6y1Nsy+0Wk5fk6e6d90sfmvUK1p89BM7MB77aLSYZp/TmUH+0Z6gUaTpt79XdiA8rv3KYUJ9Wq3l5rfForR2nDS3j2kStay+rde3ltSaitXYdHulsTtS6+bJaN19eazJaa8/hyVHJ7MGE8CAS0yX6SvgmVoM34Z1ve6/tOndP63fc0OxVdBEO7uoiLIZV8bZ8e7r7l3edexhI0eRjp/T8Z9XrTL+AC7vO/c+sd+0z641Pv4LFXefRZ9a7+Zn1JqZfQgrq+z1oJyNe8DNvoYZU4C3pO2+p7a2oLdOWb7+0z+BN9xkvAh12ESZB009mv7THTq/Vme6uMzAu+sxaNz+91vh0Z6VpprQHfezhp/TWIRK1t+QBvbk2VPhH0lvOpzxX1/qs7sKDwchm5sGcT3mwU6t1pp9sngdce9AW1+xPGQd0EpG2eBkejNZtPln8U5owePmTrVM/mzAFaYiXNPF2mIYPAtiRbQpQPm+agjjfZCGQvgLJc8m8GmGG9bLDF1QQO29LQsIuQKN5boLRe52Py3qXTcG8ji1jQQy+4cRtXoF6dMksz1bflepTqHkRNV+YqXmgNd81Bez52+IcfhEtXoEC97x5Y7JeVvxELsqawthEHDHAYbzQ9hLidbQQvQ4XNbRz1nirlJhxm4to/QqUwufNa6fc6qlcdGAKCHvfFhH/Atq3jPa9Zt6AY/mXpq7kpSW5NM1LUxI63VzA/ZZxv9eglF41q9OX7lL+jIsyeQHG7edgg/4qfLzegLfXl0Tkn7qsKSakCTHEX5x4ejG/47u7Zwo4j7mPrjOp6PgRezqWPmIXpSXEu7loLqKLVtBF56duSytGjAa6OpzBaLiI0bAyNRpsGiey8pqMijRGxRmMiouTo8LmSTNZ6xafKI0nOjP9RB1tbMPis6SnnuVEi5vSvnm0jxb9r7QZvn6ifTSXLDDcujkLtjnzykyrRtKaebQmO9GaOI/RebtDac38VGsGKI7T+rJAJxCTMWen6+jZbIOFNpxtMzZ/tA00PeBNjuUmVvQmFk+meZOazeLEVBtGNu+daDOSf6RmnrIzoFNdrkxGSnkMLo9mmz245rwVg5CpEuYWYyxZ7h4DTW1J7CMvP72Z+zeSUcfdm0zts3eLIYcKSHT1PwSnC9v+4L+LVdx9bKYQKIzK4dgHiF0F1BT8k9iHFe/Smn3Py/uxA0YBG1gVeV5zKfuhHpxZevDm6MFYQg/WbD2Yi+vBWVIP3lILYuvAavLjboJUQSMKdBH2xkNFshgSI0WWPVstT/L01lKTkDzzVKvxSJ7BhDHRZah0cdO0E3XnqFtx52XX6GZkp+guyO7QXZQdobsku0D3jOz83Kzs9nBAiCO5hr0DW0fCdXsHNpCEa/YObCMJV+0d2EwSHlk7sKUkPLR2YGNJeGDtwPYyBz1GL0kLjJQoK4I8E7bEDkm0VaehCU1pOpnDeW0nSQuMFBxykpgi43TIEc1LApoX4+AjtniU1/Ro95Gk3QfARhJB1PyTRCX7GGYCQQAyjISvMuxVRl7V9tvOfW349tvOPW33MIGENYNYxa852b9guZegDoULpj90lPYa9KALPOyspuS0d/ttZ5TccaoLcmf3utnh7mwvEh70zZjfP/vYu8zDLcSN3TIFs0ftyL+RD8rdMnvoi72xuiHPyGaXjUR9Gy4JCNHujIDZXedEweVdp5EV0Ow6Rwqu7Tq1swLCjllrKO06Xb2svOsMFDzYdZp62d1d51jBe7tOXWu4v+tUlffRrtNTEKkIFXy663T0MtgxnygMO+aG1gE75pqyw465rzDsmEcKw465q9fCjnmgMOyYm1oP7Jjrys+QpQrDjrmq/LBj7ikMO+ahwrBj7mg9sGNu6LWwYz5SGHbMtaD9sA9WGHbMI4VpP6/1wI65GbQfa4TCsGOuB+3HLK4w7Jirei3smHtnzWV/uFRxS+ay31+quF/D6MSsjvn0QzfPuTH5TYnhSGfDaA5oW7+jPT+FqFOIQ7sXBHkXr2MriOHmbYU8W6fyOJ+DJ/45eBKfgyf5WTwZ87Ugkv13POe5ccy1MMtsTCOz4LzImcw+fo18EEcl8lzUsTjxDHV/B57d1zQ6YNCBvp+64929pe3xJWTilrGoDh5HIJxt8zSP8zl44p+DJ/E5eJKfxYMwJfH3WU7uG8hqjlCOd0hJVLx3Asq7pMQRAVIp75HiVLybAeV9UuyKdzugfBDpLfcrpoAdlv0tdi54x+eCH3pXtXVoWVR8MneZJugrcsVVrYvHFAg4a27zAV8zHwQMt6cYbirD+wHDzSmGW8rwXsBwa4rhHWV4N2B4Z4rhhjLcCRhuRBngXr/FLjc6rFoyrvzg3VyNjKfnnsWHbfMK7h5uh3y3w3f4wSTTzZDpZsj0/iTTrZDpVsj03iTTOyHTOyHTu5NMN0KmGyHTnQkmhJRLSDjIPVGdSbxlBKaUoXDaKbi3ZQq3Vzlz5U3hq4sMDvkRc6lwIpTNN8ZMOCuYy/6JPamyy+Cy2wx9GlwYuQbHhSXZ3V/G7t5ut3C882RckY0pM6IA3PPyQaxjBED18sJZYeV9VA7WF2I8jWiW7jU09LGb18OgpmubLT/2nkQkpzQs2sTr4QRkfycSEypQYRx9LEfwzaS5bq6vO+loSIPrclPGiHqJD2HbE0+X637DgZL5SJTMl/3uUuUGTbYu+50QbIZgIwTrY5DJ0Jd+8Buxs+gt+QmuSdLPe9CU6oJkLvu1JX0z0x839SmpD+WsJ7JISS2FcKHSSvYiHxWvtSteafKS0tQlpelLnC9+SfyLX5L44pckv+AlmdPnlHEXjjssmFRmejXyNet4P+3Sz7jO+SGvi/+Q1yV+yOuSP8x1jIn52N0zeX6osBSoLdEtjXB9iW5pEuB7iW5phJtLdEuTAOJLdEsj3F2iWxrh3hI3PPZEgqPL/iBD19TgE+1nKpxpRpmKmlde9g8zFW/PXParCyHtKINnuYzNzZh2nMHu6TK2tWPaSYZRdv3GQsUrjan1TMXzMSFEOBsZSAOX/V6E1sxUvDtoVYTWyVS8d9GqhYp3dUztZiree2jXQsV7J6Cay287w8yO08sI3FnYcWoZPEmm4r2P1i9WvFvjOkbzFe8DlC5WvJtj6nC+4n0FpQsV7/aYOpiveHdRGn3W+Yr3NZRF+2m+4v0knmCx4v1U2KPzFe/34VkXK97vH1P78xXvD+BZFiveT4+pvfmK9wfx3IsV7174vPMV7w+hhxYr0ac9WdhxjucFbizuOJ158MxXvD+MJ1iseD8T9vd8xfsjeILFivez4ZuZr3h/FM+wWPH+2Jham6949/GEixXv62Nqdb7i/Rze+2LFexBtxdHijjOak5DRfQzfjClxaNI8+ypD2BO8zYFMA+57AI8IPuCwp4k3qzhc2nWaC+YdwANed5ODnsw/DfCY4Nf5iYTXHS3tOscL5hZvTY7fz1sT/GO8dch8jE9l0fwUb0KOn+VNQo4THGAsmp9hdSF5gG9vCd2Qqrg35YtirHwkEriKMPS3zS1zNYjTPYRPUonh1Rz81qEfKsGDKYGfTTeJn5iXci1z1S05ZXMTMew/NCKuck5GTO13mOPFbiOudh/BWADUqb1/B6ESEvzdhDbFEvPjpmY1vWlKKtVJpJ4SFsKSn4Q76FXAVyEn2Alza7wAMHcso4dfp8GHxdg/7Da43hynzGVDtA7Pm3o6QA+BHo7RKvxwqnMB2gPaG6NDoMM5FYjYn1mDTaia4dw1l9Vc5565rCY897FtVaPky+aa2iNfNj6hGuLV3yBYB3iHYAPguwSbAN8j2LEmJYzyJPpURnYvA9NpgrUMM6teNl/j9X2AdwkeAvwKwSOAHxA8Bvg+wROAf4jgCOAfJFi1zWXzB6ThAH+fNBzgT0rD7ck2daeaPLCkZcfzO9Cxy5Q3v4NxMsHXRJV/WNoH8I9IqwH+UXkWgPcJ9gD+HMGuLVWO5nagcp+o8tjGTJWo4Dv3y4+zf9C3XJ/iGSI45QOhrobFO0Cq2JgGyMiueIUAQT6OawGCMGCliCh4YkeG4VchGd+Qe2t0/RObGx2GvMbICkqR8wDhJAY24pyPS2EzRoW5L1G3lVhHqrsRqPEItQ9q1UFM8gh1CGrNyYxHamk8UjfHI3VtPFLNeKQum8umpMZmMn3bO0760yTb9P8Hgm36C8u16S8s1qa/sFSb/sJCbfoLy7TpLyrSpn9oiTb9wwm06R9Onk3/cOJs+oeTZtM/pDD7VTnqoPkrfRMJZumYSHCZXokEDV0SCa7RH5HgJp0RCZboiehj3+ubr2LIfzXY3mJuQCag634Wsm3NgWzrI9ubHc3pjjxMl8318KCq4ehx4WUoxJsOLRkV6zhQ7g0V6zo4eBkphhN4TgvE+g4OcmqKHTqwf6g7yL+uatTrZk/uCEPjLYQKmujpZRCdKaIBMT5FXAMxMUWEMTJPBKPEEoipKSLCIInvUj4gjpX+3BpgGd6bkAAmTtUkKNllv38WlqR5GqJ1EhKl9+RcJVvQ47JLZsfvJys4LpMDMPqnwaW3kxDSkKQuSF0ljUjqgdRTUpXnaX36AiupRtIhSIdKqpN0BNKRkhokHYN0nDA7TFxV0mSSV99St3k/5vcxUNxrZhsm37WUZ/NUou068D7CWQ1m3U4yotzFmRGM+VzLKZtrkNPgPGJssydJhnhaI6pRIxlB2mIGQCTbFssFpgxZbotVBRHTFtsKImttMVWwRPbbgvYowaiJKrnxbSxQ/1R18DlcY3arG8CR5Qq4VXFvA7egVw3bfNUvYU4c4KDzX1+7t2TalW+sLVYpFliOgEGDS2t/JBWJ612J9YEdBNgI2N0A66IL7gUYO+T+RIfw2dzLmnCt4C9+6F6Pmv/E3JJvmYKXf+zd8p2PvEtMQ4P8RtfHqn/JhNwMzXDkBuaS5i7z5x97khlt4lLI+ctycQnHtwGUHkPjqpvN8eKY9xel2qvhKYP93GCSKfhDvKGbU8cNjixX9uRxw01zk85fxsFyFtH1mbgeNsjTQyFqpp/auxMoVWWSOOWpt3z7/ZkHxugMrirBNeGSseiooJTsDGV56qrJPij4ifcXNRXVnrnF/GOmIGehYgq1+KFbitpc4WnwQd7kWh9d+SflpD3MWgV/4U7wDLSrDl+6uWwuRa6dHBGS/yqqax/LT+OmW88jrQkb4kEve5NXhfPtdFsCXvTVxI3pYyEXjZtcCt8Y2hzhvTMhlIxbtiUr5OQ0bq7RsUC0yOXH8JJoWpC2SU/jA3wXRBz1pwXESb+WZ2mbcxvUqgM5luCIvASHIe8y7VXeIdWB9EtwwMsInji4jOCxM77M0GbpBhniEJ8JHsdRA8GjOGogeBhHDQT78XENayL1kzcBUZzgYQKVEewnUBnBXgKVEewmUBnBTmJc2SYkE8wuki9WYq4gQ5ITiSOJycuexKtTeN+aKp/Cy5No+OHLXj6MWvl1TpxTdz+culttCj+culttCj+YRNMvvzutB+pTtz+aul19Cj+aul19Cr87iWY/4/aNqdsfT92uMYUfT92uMYXfm0SXP+P2zanbn0zdrjmFn0zdrjmF359EzWfcvjN1+8HU7TpT+GDqdp0p/NEkuvYZt+9O3X44dbvuFD6cul13Cn8yiW5+xu17U7cfTd2uN4WPpm7Xm8KfTqKlT7m9OF90rYrZNjv+KFnJ/lt0CXcldKzLcLEI27AtWXngeu7G6ZQOYzC6rD8XV5KWhIFJPhcvkpaGxIw/Fw+SlgbFtJ+L90hL84UnnovnSEtzhjvPxWukFQTwfC4eIy2a+G7LbLVt/8UUfO6dx95N5HzwGylIfzkJIA5hLgd/fWRdK5h9bx3Z2Aoi3HuXEBzukviqXZJAFZckUAU8CV3amxk3TkdBN0HHQDdpCn5sP/a3Yc1aQOy4S4g2VzCFXOyw7MfugNgve3d8672PvK292GE5sH6kkOQEQRUyp3m1fWfX6cJeD7FytvBCCmvIAoYd06XsHw/uuGUuma1V3hb3cu9kDLVN/bL8jiBzDa9WEDIMV3//Kk4fY5Cu7tAm0BT8zkrFvSpuYTDRMJf8nvWhd72yZp84sHr4IA47rXUxHrOQXQ1GkCdQlJjrFfhlluTuvG6/4l3P/glTMNfNTb9uVbJPIBz0HWxfx7Ph3WttinQFZuatJp6F4Vw/fhjGc9Uw0wXtyOs+3mMfadeCyj+SXJyjqxXEYoll1JvM3JF81WyVPuaJU6GYVdBLv+HH3Ot4YH1JyO5p7iDf5jqSpe6LIO1eMnfGyVLXkSwVXYW8P5d8BkW1K7wn5BSzJX1X8e7g6zdb5jpRIA+QyvYO5rBTyc34qeTjxBTZvW4uIRHqJbMOsXLdXBXBZ18SoUYbcUoTeLWFq1Xy3VexacxVD7My/sIibHCvZ39R+v/Xy+z9Xy8HvfqeXiq9+U0/5t4xN2GB+kuWuYmxV6XJlLnp/5JV+UFJ1apk/20aI5qKe90p+wn3kla8/x7dE+8gg3PB3FxjFQxhLJX/Cfl1r8F+0HnsvfNWzP4Ymxy9GhYj17Dc4G+WdmbXUbhAdWKrDfLyDz7WqqSh2UKmIBKNKfi1Pj2oQc0ypPI1OGIU/HpIXxbuTVPwGyHVIKDytXXu85ohGTGcr2nCm4LfCQs2JZ6ym9HBeJeD8Zp5h13zxP94LPcPP+beXEbmvh/7wPvJRViTpCvCbPZ955u0wtyXbEv7SNb9U37M/cDsc3Dumw/8j3+x4t3ABiMvl657V3V0wwgJfhrmA/NTuPwGkp3CGu4r3IZQ9YxLcJhIY5+CWfdHsQ8r/sCAdoOP9G6gWTQ3kA44uKTErY+5Yd6f4tpCdtMt8xWI7l8xX5Ohl4/rHbf0ck1mGtwRX/fATNaUMR9gFH+Aw6evQmHzsVsyP7lI39YtTmJ83q1gt2tN7iMLZms82iUldfvBZLLSXzHWC9cxW24po7uy4Et5B2KBC038O7lYzxGvWt6O88J+uHFb+MFYLeN8GUPymccUEkSWn0kCMSLmGVRsy4KsPYOGzQiy+QwKtjVBSs8Qr2wTiMYYgY9OCbt8jpHLfuw9brXmzVUODnluJLyWCWkLU0z7WdOdZ4qDLcSjBDoHRRnQOtE0lGlAa0RTULgBrRJNMtPIFiJkAk1AcQd0SDSOwVjx9iX1rNkz8+LRpw3Xh9EH1IfWjkDnSG5ANz+pyoh0aDgzuaGqyk2FYCjLu3MhOE+zpTi7IikHDKVnzLaL9uOzBJYwScHWgCF6BzEDLAW/HU4DwNJmTrAssDl4IXFCATZvFgSLAVvQDhG1Iz0hg1fjxql1tL8jDjBw3mjSG8JIEo/QZFyFArUQ/05gyfQT7Z+X8b6OKCaRaOgfP5B0wc7PR1fOGzoKcD6T3kHIui09qjkhyP3uUMFlxq0jaBi0juAaI9YR3GS4OoIlxqojWN6VVewazZw7Ct5lNGaC9xiNmeB9RmMm+IjBmAk+YSxmgk8ZiplgVUIxE65JKGY2vg7ze4Ub1g5CMRPGJr+aELhj7SAUM+GutYNQzJR3zA2ddSE/XFuzY6EIEfRZIGtMLn4+UsOakh/7arxsnOdiFaxdTDmDE+7XOLnekLmZk+v7mmH9rs493rvGmpyl2pjfurDe71pks77hvSu8Xwl43x3zfiXk1Wn1BqbVG+Z9mae+Fp3o/HoCRTM3vDE+zyiYUrjOe1vBSp8xPInPNM36qoupcP+A+W3x/BkXM3bfkUgyMKLHUp+uZL8RAN+E6raQi/3tMgwRc7G/U/7GrXgZS/jcY+/SW1SC7cX+Djsw7a1T6QyZNoBE2oWsu2bH3XW0cp0ks74K4T2dMZfM+rZdteX3X9rm0pr9L20u+pIrZivIGtPkFxuCyyFoQnAtBDdDsBSC5RA8CMG7IXgvBO+H4KMQfBKCT0OwaoVwLQLXI3AjAjcjcCcCdyNwLwL3I/BhBD6KwMcR+CQCDyLwMAKPInDVjrQ/AtcjcCMCNyNwJwJ3I3AvAvcj8GEEPorAxxH4JAIPIvAwAo8icNWJtD8C1yNwIwI3I3AnAncjcE9hbCjN+ttOaQcnfwQ3d3AeSHBtB6eEBP8f0t4FTI7qOhftqpp+TWs0rdHMaKThsWpLgoFBYhSDZgaBNCWEJF5CPAQCDJZAYNESIDAmJCFW+0k7tuOO40czsU1Ny8SdxI47L7tz8qAdx6Ztx6aTm9x0kvMdt7G/pE9iJ31vcpL+zj33+upfa1fV7pnBzv2uPn3Ta/+19q5Vu3bt53rQLM4OmZyYxdEak9lZnLkxmZrFYdw0vA2eoB2YYjcc+W3q35b+bevfDnKemMWJHqfrSFsvRaswaM7UdPEHZ9HvM3l4Fv0+k0dn0e8zeWwW/T6TJ2fR7zN5Zhb9PpPPzaLfn/YWThkytge0bPq3qX8bAyJbV8taRdriMUJk1YXWrFm4ymcafXhJ0xXpz5n2pZ9nuiT9P9NFGRd2eF0YAgAp8Bbw+TrMW4GA1bgWUP829W8jLgJ2tECVuBZQX6/rm8AOrJQQGnZgRU3DDqyg6bbFNmRMtyy2IdsBOys1B6TJQu3wOnHMn86/ioYAIOtiTSaSJrQk+tdPaIl0uql/G/q3ru9Yg2VbUlchLNs0XYFlm6Z9WLYlIFUip67jirS1VAmoOk7LTjmANts3TAf75ZwdhnEtfdtqUoupf339W0pqcXW6oX/rSQRaxQpFdthxj7wku9EdOhAQnN0kjCmmRauEBUxiPEXNBgImsUpBxWqglYQGJCo2Kq9uz8Jd/A6vmtIa2TsQiS0g/YgshSR+iiktdUo/TQriplncmiM5eiJ9VSe7KQziqHANdFLQqEStawBB3w5zpWuglYJ+JSpdA81UTt3Ble5Ele7MQgtth1dNR48QkX5EliKymDafppDWT5GG2HbOvQHhXuycewTH4PBf5A2fdm/qn5V7nkPb1fQpHC/u53XHDTRNN61yvDiNhdo0qzMoj/brNZ+35pS6KjhejLIqLzxe9MLjRS88XvRWHC/KHog3LMUeERWi8HjxBqgOPZNTh/5Tp4uH6NB/5nTRo+3uNC1/aHUnWXRncOK36kNfFZwums9LFj8V5/JwurifLNofIdkVyMSyXP1VsF1OF/l48xrPou2nMB29i7a7V7HmlZVTV+F9euYBIx7oroEFfn5UmmEYtOyAcRp3WHsgeAwUtz967XQDeabNUF+b4JS3/IBxGpPWUHo+YAykiQRR02SxcGX2LKcPGJfJEvCiuvpuXObaE5udQGQvemk30H6T986At1+yq4IDxsDKSrYX97LOJv8clp+DfOYv3xcDc/IzIz9T+EBRcPiJ2qEW4Q6OPXBN+JnaOXVVkED8Ai9INKycuiFIIK7C/iCBeAo3BQnEUTgUFmDl1J1h0VZO3RXe1MqpI2HRsZy6Oyw6llP3GF1FPphEWDqtf7EVmsqpo0G+mg0V7jdpxekdHBPhTXAG3RnQvaMFve25kKEre5FhusPbCDsuc9pxXaKVU/fTdVGJUObVC1ju8yyMUHvDtG9hgNpxmdNKhNLHJGyNbO83bdnfr8O4fQeObTEZYO8j2EJGANE30/WRgDGMODdGAsYw4NwcptsxjDe3hGnE67gF5TaTAszl1ANacxbJGd4AC5NTGAwOh0nCUHB7mJzAQHBHmMxiGNhxmdNI6Wfq2HIs0bblXKJr42ACHsDh5OLELHvCcER/ZYcM1PAuIprEcP5xlWjpYrf3mkC9+Eqt8cn+KaYD9eIr9VtljxP3BurF7DqBPaHskOkK+8G4IdAevpL2B9rDV2qdZPYRcSjQHr5Sv3r2wSKtgp2miCYve8qwtG+K+wPd3St1a2CnFNIQ2FuGtAF2BXIk0C2+ku4KNI6v1MrH7D8ClWHNisuJuPYQISrD7A9CXj+7lJA3z84n5KWzswt53+yFQxSd2bnI3YH+Md9ggfWPxWcFChWDhAZIaQ51kNIUaiClGVRBShOogJTX74MUU4mSI+XHeKFwpZ77X4l9tSZ+r+S48ym6MvssxnMESsdq/E1w+Kr32gcysgD/ul527wiX3XuCNfcOrLlxprBjUheWWb6hj14RZ0dY4H9zAd4ovDhdqceNheu8WPan1Zsm3R3Y0HibeyAjCjpq2ivsZkfaEjpuOtjpll3MaZqmOdn72INTKFHKRBacInXkLCnaD3xZ2WXZYM7vyZGNq4V4OTIBCDZvp3GfCbVH5hHTU/aompOtAngq3KMQqNE5ob31npicxynCNA4N1JvYXFDZouwkVr8r2TFq4DRB2LPCnv2x7MWQfULYJ34seylkJ2GnH8vuh+xTwj71Y9lxVqGmwT4j7DNKR4ZfhZ03dtw30T6viT0g2uEl+CySDky607TTK74aE3W76Jy5X7MjtdqFp5ZpRSy7MvGGV+gNr0y94ZWZVa/gM9jptV6N6WnyTs//KlyreBW2JdNuNMGCB9QKlFfq/nk7dOFTUK/Zrp1HZIWawIb3du06goSawpb4du04YkaoOfaZCn2lK2WnXyJoiu+Ig0Idhrrgdu054qhQx6AmuF37jTgp1Bn4kdquvUY8JxR2U/OW0NhNLWgaTiOKmi5JYMbtgdMIX9MVCcy4PXAaUdV0TQIzbg+cRtQ13ZDAjNsDpxFNTbckMOP2wGlEW9MdCcy4PXAa0dV0T7r/7YHTiLyt5bfZScz2wGlEUdMlCcy4PXQaoemK+FTaHjiNqGq6JoEZtwdOI+qabohLIJFfAjOK/OJISuQXzWqRX9wgifwSmFHkF9dEIr/DGtUiv8OjgsgvIW5EfkdrkV8pwe98TVccrUd+pQS/q2q65mhN8islVFxd0wgV19A0QsU1NY1QcS1NI1RcW9MIFdfRdNfhAwGR3+ETAZF/gI8ERP4BPhMQ+Qf4UEDkH+BTAZF/gI8FRP4BPhcQ+Qf4YEDkH+BdH5F/gI8GRP4BPhsQ+Qf4cEDkH+DTAZF/gE8HRP4BPh0Q+Qc4UKPIP8CBGkX+OAdqFPnjHKhR5I9zoEaRP86BGkX+OAdqFPnjrNot8sdZp1vkj/OmkMgfZy1ukT/O6tsif5z1tkX+OCtsi/xxDtQo8sfZIlbkj7NFrMgfZ4tYkT/BFrEif4ItYkX+BFvEivwJtojlvshP8DYR05UEbx3tFD31eadyiHZ61W8jxog8EDq7mk7XdLqu03Wdbuh0Q6ebOt3U6ZZOtyTNcYsOzDvdW2mn1/sW4qN4pVfDiNk7vfy3GfNNrCBYxcSKglVNrCRYzcR8weoRts0T30W4+azXikObCcGStaMqXM6exh1ek9AsZ6TXL+jkSUnmdfKYJHvfluRRSXZ18rAkOzp5UPxnb+OJYPsQO61dj9Fymn4KZyo7M7SAdRYihNBOHQJ9p2edWjtgxWIW2yLspHmEIfmrmHiQ5i57XkfiKmoyyx32vI7F5WuSuLue19G4qpqcQWdtL9D8tljdiiJ7ILCzRdZDOqrHciC7HJhYDtByYGo5MBMCx/Hk83jiL1sSGQZLqJ077QskfMtfxnKfpxns9H1+L73vPRL0ZedOe4qukKCdV0/ZJF7ibQT9HFWscobIkjhL4uCeV0P/42qJxb1y+nKFPCXrrqUWJcYBh1RPrcKeEvassGc1OwdUz67CnhX2CWGf0OwTYJ9YhX1C2EnYSbMT2GkVdhL2KWGf0uxTYJ9ahX1K2GeEfUazcyjOmVXYEXIUW4RbJPq5m+TY1W6Co1u7EvHatTkKtutwZGx3gINdY050LQqemXbO4ND8Wgg1M+2cxHn6tXj+mWnnKHZ9rkXdzUw7h+HJ41rU+8y0c9B3HSQQBpMnPtAouBb1MDPtHPMzbpxiFJt28mtVilKLCqfwA5R+eFLhNwXZG2+hmNf8Dk9iY/BNIBt6A4sqxbE7UggZKNEF0QRiXgu8OykGpxzaI9JiXyAOG5UjvG3w7qAYfHnojchFrj6LnIf7mlbM64D3aorBBYj+uPqiAkpUEOHtfofjbMfgOUS8KcUXOYCIJWEFKU6JgLcH3nmKweEIeBOUWFRxSsInJuISwuGl5p2yS0fdGbqW5oMV97V0RbAOv5auDlbn1+pVZA3kTll8gpwOVvfXUuwyp/EWLPrtBYp5574Sy22LxQYW6FrsN6HGfxDLed1/s7Lv4DaAl9Q8zTO8a1HHP9Dxk9qSbgfpjqQ7Qbpr0bXYGkKdoMRGDBpO0gPGvHab+3O0Aq+n6bV4c98VehiCaDyNYjWdoZiX1zyDEEfja3AbTQ+htWieMa/1PyxWA/XaQjheR4gBuhY74/xii/+M1qBNXAEUAEzrsApXo87yT+gNGsQ2uBpqN3BL6ZTZb63vq6R0vKkyt+onOOzLGmiFDkEdFLG4VLbMoYGvhi0dtEAcuP8b4MALyiqze1OOKHw1ZWEPD5s3jjsc83o/DN5SzGv9t5huhTGv8l0dOyTmtTXsgCWCOxoewEO9HkZ1iXEEZWl0Ma/2esjf03ASeQN+VPp3BE/hk/leyF7QsE0xr/G9oHif0l6Xa1lly5TxekKnyzTo5f+d6Qweeh3hIWrfDQOgxLxOkIDApUhgiNkIxIRwvVA4iFT5XhhRJea1IkHUIKSsSqF4ZTGvrRMOEkUpRfw4xry6TiZwrasTSa4AXwqFb9eY19QJm+8xSmvgvXEICj9jxE82Ul5acsf58Xzz8Zrm4+X7H69qPl677/GK5uPVjXqO48ZrceNhufF6uOvFbevmbbvmbf3+2zbN2+a/Z962at62bdQqIoQsLbkb+E4l804N80697/bdqWLeqdX3gAXzTjXjAUfwoQzCQfmSuxHly0dO6313DE+pkyO+m8WHVztG63x3lEYW3U20btGdpPWLLr6g7g+lQ4AcHU1zPWsaQrR+GHVEzR9GHVHjh1FH1M4yeQHYhbwQYmiOi7i3zLoXsyyPuxlDcc3QJYzIIWcBbqaXRL9lmLJL4sdvLY0hhhT3LPZLbnyZP5wBip9zEVk3DsVGCz+WcS+MTRctqXhfHp1a+MICGkiKNi7hjSVpwxJeVoLGoc+qc+xeKPvKXulyiw2S7Qxr19mLCurt+xZfxL/f31Neosw5usDf979+7f/4i1sfmtlT9lUiStBa311LSchcpuSyXBf25UoauYZ9d5hSdLH0mKn+fH25UkaudKDKF/oK21NWtlbpc/DZumtoiNWhfHcIU/Sc2qldwsew69p9nGJQbuzgNzXvtPELPy34HZ53mvhNzzuNx+lqGuKgpRJqkdbIrHOex41BmVPO86gyAk/Ma2ii7MvUEV371bQeA8Qgh3rkGaIMAOzZfIg2CTqFQFYZuhYnFTSjn/PwHroWRyN0kGam7NiUnVp3YYx4rtA4zSpfjdMUy24A1xrEcvxLx5543jrrWe4me4GkF0Y7nVPrl9QaWsMNDnN7C1NpjKI8cVOjfGEJUxl9NavWIuNBNcboEmYu+tKEGsalw2qc0SWVpKS+RIo/0aNqA6NLmPjpS1NqHS4dUxOMLqk0pfWlGTWCSyfVRkYRvtrGpTTQmXMvcnTn2LQzde5F5cgMj2M7x6YdYigBcuLci2qQHBrEgXHIFcelLHMNgEz1ca0BFFstY3icjO9qI2JqnvPdEZpAnOlzvruONiDu3Dn0SeOIKH0OjXgME8Zz+AhG0TDPoeGtpzVMZdDsRrDTF0PM2GMUQ7jYo9LWDkvTO0gxxIddoBgOg+a8mLspQ5syz1rOWbKyv2Ep2ztz48ACB6G0vQwMHGx4FjjzlBrIfizuOhSjAQ+eUJ57Gtv/MXLgXjpG9k4b+qugrkH7dx2yb4BlCHoWm2dteHBtdBIbzmSHY5mrkdPC3Dr7G1b2XFxZl9mxWS7PwoouNmXHcBdrr6Dsyzpzl2WdlXw4mLDJ3hbLKMubeMabeLsXO6icSVyBHrIziULtsFDbLNTuK3TWss56qWxMWdmPx8nyfvB/WngwyxvIUSz771b2E0A/+a8arf+r5Q1krVjmR7ZlPY+iZWrA82wkUpxISSLLiawkJjgxIQniBEliihNTIGdQ03JWHAsPj2NymhyTs+WYnDTzzzH5wZt3uJCZKEBR9+zDpsfCp7y/mvCW1pKVneCmGV3xfmnc++shfhK5llrtWkquZVe7lpVrE6tdm5BrtNo1kmtTq12bkmszq12byU5k/ue4nTx7yfObY55vnVLWFl4TfXsjlgylL20MHIbFvK5gRRPrCFYwsbZgeRNrCdb7opn3VcYqX9qYU47eVYp5XUGrX9qYC7GeYDUTy7+2MRfpk8Q8Xy4u6asNzlE3cxQEa5hYUbCmiZUEa5mYL1jbxCqCdUysKljXxGqNjTkXE6relzbm3LizgID3MM4YyGEGETDaNICPK5HD2tQEs6uBE6uBlFtWZhIOXJLe92MypHrF1zbmeJHQ/GPzgV+T6v1j4+X4gtVNrCJYw8SqgpXM8mqC+SZWF6xiYg3BqiZWcXJqAJsiKXJksjeAvRHoTA/w3tsEZk3oCiz0v7Cz4OjbljcVhRBGx4XBbw06Bs44hfGM3UNwckYnz0hyTidLWIyn+zWY2H5gzQmt/49uKX0OoeVTkswiqeVx0DWlz8GIhKVcRCLDy08eb6ODMTXqR20XBYDjmMKcxMEgu8VgHfbVxTTIZXEICYcVlbNcaMUyIiuW1RBm8Q4rLG+SomqW2mowjPnqEiOpfCmva6l1XF7PUpPG9bW6vLytLpDyCra61GAY95VxEKg26/Lqthrh8hq2Mo4Q1YW6vKatXCmvZavLDIaLfHU5TDV4D9ai9fzUadRgijaUfSOkY1lt8GkYC61BRLzIgmNj2TfiOZbVhE9jvpo2kI2wB1kHXkz0LjCubPJp3FdXGMikzzFtKEVU9sk1rlzg00W+IhG0AEHX0KhPItCwhAwZ8klu7/ZVP62jtT7Jzbb1VSSN0IU+SdEXSdF5FD3IgWO49BRtKftqDSxbB3mly/dI0dayr4aMwrI+DeIp5U4purTsq7UokgbxQHKbFF1W9tWFRrZ1Ps4zLVqPG2z06QrOYr6/ER9zI4sXuTTmIzJC2aeL+to1pk2okDQmzri8tr+B4i5HyaKLwXEJc2z26fK+VofJloWzhGEwucw07tMoz+1ReNYnXdQcF6W4kLUcOhYPsNGnyfM1yoFnwY9XwlkuRFn71v3jtne++ImnrnuZN/hRQKaMMqZE4D6GM1xgukzTfJGLNa8f5PoY0wKaV2DoAS2kAZ4Q6AdMLZxTaePbj+awk4r7uhiHwEKHNoOuOs2ZOZQdsDkTmxBs4ZSBbRQMWmYRuEnAVh84KWC7D7xAahjLBIRvlg4UUUCGyGIFrYj1Qu6wYb99EVhKlrsWv0ULGy44BneH8Zu33Cx+n3PX4eeMy+uI/Gsb3fWRSfIeYP6XNmKRM6bXRBwwK4adHBqlTPn8ms0vuxn7eVofho9+GFoFaRoqu2v4W3XX8+ftjnKP4I5RmobL7hClaW3ZXbtv2/UX/NPrOzftEcEmRK6syJVyRzh4D2bgA9FAgn0Ex5X5M3f5GChQLQdxqRVeygaX1qPFxHACHFyaCC7Bo6617/hPHZm5/NfetMcdNrYfIjKKd+tGwXDd6DN1o07LjbpqN+r23GhAcKPu0t2wqkVfNAd110XkSEhm3HHMejD9Wqs390GPC90EPaTHctBjeqwHParnAqDX68kR6Av1OA/6Aj25Aq0340ugN+nJGeg1evIGeqOe3IGe0FPDr23M0QY9dQSd0gcLoLNaZtDrtMygR7TMoAf14QLoi2i4zFMBlaIMpShzYlLp8gqvbczZz0dbMYN9s4RNxgUaLKtBSmEnpI8Fwa7OZSh9Tr4738JmwCfSVuosvCvEgpl3O2XOY9AJOLJ2kb4koCmnbE3rRqaboTTUGLvmjetVD3vkTRhLoDw27eHSN0l2NOUbxOc9EE33BnOYmARp/mwH550m9t9a6RwlwklbO52jeJjqpHOUjObz6Rx3GPp1pXOUiiaFg7lAwlpIsq3DIC9fvRjOK/g79FoRb7OPt4FnaQ/myGJjH5ZgMGc8R3cwFz0F3DaDc05S+UyOe9DwciHDlw+Gj3xy3ili6lzK5JA8o5uspJ7TjVlSeUu3c0kWdLImyaJO1iVZ0smGJH2dbEqyopMtSVZ1si3Jmk52JFnXya4kGzrZk2RTJ/NrONnSyYIk2zpZlGRHJ0uS7OqkL8meTlYkCa0hfl5JFnSyJsmiTtYlWdLJhiR9nWxKsqKTLUlWdbItyZpOdiRZ18muJBs62ZNkUyfzQ/K8OlmQZFsni5Ls6GRJkl2d9CXZ08mKJKFlxM8ryYJO1iRZ1Mm6JEs62ZCkr5NNSVZ0siXJqiT5WaE6hF2/jlyqa86uJBs62ZNkUyfza+VhdbIgybZOFiXZ0cmSJLs66Uuy54RThy2xzHuvci4+az+ffMfmmJdvxU6p1JYYQQcaax51CV1SJgeL0CGM1TpJObU2SPo8vZ8KLs3k1LDBiWlMxOm7W3m/qmNlf8XCeSvYNweKxkhP5dSWQNsYacqpdKByjPRETg0GXpGRzuZUJnCYjHQqp9YEx6FJSgQnpUzOsWYzuHQ3ULHlwkFWhGbyMKtHM3mUHR4zeYzVkJk8ycrJKARa8pbI5jAAU4BsoAANAIYC6wI1aAAwIxgJlKEB5K2cWh+oRAOA6vxooBjNNzzDitFJdpg8BqDCxm1JBNFQ4wCqGvCdnNoAoKYBLLEnANQ1UHVyaiOAhgZqTk5tAtDUQN3JqUkALQYSMFJzL8dv0Xan8Zu33Svw27PcbfjtWu6l+O1Y7hR+25Z7Gez/Wc8t6TWcnLqALpPSm05OXUhTkmg5OXURXSoJuMO5mLZJouPkFNEVkug5OeXStCS6Tk4pupwTtJXV55JecSCHTBZ79EiSvJMKnBDI2/BBynsogZQ3UAQpdV8AKbWeT4S13otDyCTGpr+WMAhJjCkSJDCJwcb0dM1yr4QwXCWxFb9VdmlagznSZDMiGxFZj8haRFYDMoGJ9SU8IrtbKRnc7hfqYieYpK20tcyB8JJ0iT64yO8pK4E7CRpFzktozWoFVKICaqsX0E3Qeikgs1oB1aiA+uoF9BI0IgUMrlZALSqgsXoB+SStkwLSqxVQjwporl5AIUlZKWDLagU0ogJaqxdQTPK6xb2ENq9WQDNJSS+2y8pn8AVu0Lv4Sa81HjQdthvE1WJGT2+SXns8JDsR2R0Ps1c35Pb+X5XaH330v376G0Hbmgiv1sL7aNnbq8tegnAdDvHesnSbzm+M7jexogEXoqt+RBY3rmCsRFfrEVldydiIrrYjsrmSsRNdzW+KZFzJWIiuFjetuOpHVysR2dgUTpSTXnVlrnrAmvDe+a73pOSb/+amnKS40pubUI+lsG+4IEdxNjhnMSWVkq4qLn38BXiUC5GrLbU/hs4hpbbSWGCQOE5baTxIbKCttCFITNBWmggSG2krbQwSm2grbQoSk7SVJoPEBbSVLggSF9JWujBIXERb6aIgcTFtpYuDBNFWoiChaCupIOHSVnKDBAJRxLzORTzlTsksWibf7Yswi5ELWT0XvyhHQ+HUO39xjtbqFFYl7qU0jJ8p5JhyL8PB2bzjX4z5zcU5GTxiXvHinAwdMa90cU4GjphXuZhXURfARTP0If40b+nvLOaVrs0p20tKwr8WjH9zHRihBZX/n2yV8JWEXnZ0OCOfuHkN0Jbka2KMHgpWJK28Fa5O2kaOLtNaDugzfPD1SI72p6xcIEbnU1YoB27b+DurT4zq61GhxdcjMUqvWzk1HNzafz0So2LkqL0eiYHS/vIrdihF5UeRFNUf9UtR/CO7T4oe55MyW6C1FO2v2OF9OwbdNfjzf2r3yfDJl51Qhm7bDmXote0+GVqfdvpkqL8cHoF6PmgtQ+VlJ7xv1aBrBn+D6UiG779vIJSh9idOKEP9T5w+Gfz8QJ8MhRcGwjI7KEPL0H3fQHjfnkHnDf4i05EMn+tEMuQ/MxDKUPjMQJ8Mne/2y9DsRGVWO5EMtU5037pBNwz+Vqdfhn/7ejyUofHeeChDE7QhQ/Ur8T4ZSt+Ih2X2UIaWIf+NeHjfgkEXDf7YTtv/Br64CoNePqkLrfx5PKcSYEtRQjY18BPbIKk54mszAu4R8JiARwV8q4AFS9C8JfCH5ReamIxXNP4lnW7q9Hc0X0v/5m253tPXX9Bp35brFfmNfUHjDY03Nf7XGu9qvKfxH2m85Ajuy2/ss47gdY03NP6aTnf19Y7G/0PjpQHBiwOCvyS/MPxgvKbxVzXe0Xhb4/+i8WJc8EJc8E/odFXSMMpg/BWNt3T6H/T1tsbzCV3vCf0+ErreNf4ljVc13tT4dzTe0nhP4y8k9ftI6vpP6nrXeEXjDY3/tcabGu9q/Eca7/HqLKVbZML7bEq8eGIRlwqH+XrE8FrE0IgYOhHDf0QM3YihmA4ZXkqHDKHviIRXixhejRjqEUM7YviXiKETMRQGQ4ZPDIYMxcGQoRoxvBIx1CKGVsTwDxFDO2LIZ0KGD2dChkImZKhEDF+KGKoRQzNi+E7E0IoYehHDC2tChvyakMFfEzJ8IWKoRAyNiOGvI4ZmxNCNGH4UMfQihtJQ1B6GovYwFLWHiOG1iKERMXQihv+IGLoRQ3Ft1B7WRu1hbdQeIoZXI4Z6xNCOGP4lYuhEDIXhqD0MR+1hOGoPEcMrEUMtYmhFDP8QMbQjhnw2ag/ZqD1ko/YQMXwpYqhGDM2I4TsRQyti6EUML6yL2sO6qD2si9pDxFBZZ2wPx/7v1zHIONfE/hcTsZ12D8Tes7NOlwn0hHzpvd+L6zJi3ocM+mMG/SmDftmgP/c9HkFjek+69z1dco0JMwrX93iW+X1jgDTookGXDNo36IpBdwy6DbpvuRLzWqtgzVWwxipYfRWstgpWXY55MTezOebNnFJrtsQoFUw0VBrTiu4FlMaaCJF2dskZB8wf3a1yJHeJHMkNUNprpJctbdPsMqgfYhfPL7FFVhprXMKOYhlIyw6QSFlV6avYdukkcJ1NDNOyZ8Q6wBmvljqN+UdnM2LnZthIfpB9q8lamZvghTlsVBQd2b8ZxLYstl+80hYcqWylrZG+q85SuDBHlwjZ2JKDmMtY1sCeLuH5F+Yonb0CzXhrDpVxlAbRe0/LfXpx/RC0FZs1WV92VJNskHUJbd33Jv73Pb20V1wBJyb54DwD9dqM9rKyxpuBNZJDKa+CLTJeJTUpx+mc15jkbTObUlN29wLM6uKUuszpXaDb4LVgzF9o6AExUjCQGiNFA6kzUjKQBiP+hTmvkeAbxrziV2LAOptzXsPSWO9PGWtuNZTRBGoYUEegugG1BaoZUEugqgHlv8pQa6shRuObjPlXGGJUv8VYYbuhEiVQ3oB8gXrbIqgkUNeAigJ1DKgmUHG7IUb+L0W0qwwxOn8lz7nTeE6BagbUEqhqQE2BKgbUEMg3oK5AjZ2GGLX/KqJdZ4jh/zd5zt3GcwrUNaCiQB0DKgjUNqC8QC0DqgiU32OI0f2+iAbPAaEcrb+XB301ZjypYBUTawjmm1hdsJKJ1QQrmlhbMJjERtJUfigSftuUpvgv8ryvGbkLgrVNLC9Yy8R6/yzN3MS6gjVMrCR5u6+Z0rT/h4j4v0fSDO39hT/4TP7zH/+z1145i5xrycnChs/eaft/Hqfhvb/6583m9z7/7vctaDmxTTCA8TSFMx8+n15rxVlVODizZV0JUcu1tCcGUTgXhVxLe2IQdXKo34j2OBRzmGJPDEwtiBK1pX0wMHVY1Kwt7YOBqWOiiG1pHwxMsQ8GptgHQ0wUTVhjKibKJ6yYFROFFNYmi4mSCmv8MC0+GCADezpyaAA6mTbOg5GOkx1oJTqi9tyvb+mwWjf47UjfcgDh+Qa833e0CYMlvWcXdirYCLTwN7tNC3x03skfRb23YriEn0gxVbCiiZUEK5mYL5hvYhXBKiZWFaxqYjXBaiZWF6xuYg3BGibWFKxpYi3BWibWFqxtYh3BOibWFaxrYj3BeiaW/xvG8BMp9gpWMLGiYEUTKwlWMjFfMN/EKoJVTKwqWNXEaoLVTKwuWN3EGoI1TKwpWNPEWoK1TKwtWNvEOoJ1TKwrWNfEeoL1TCz/t1J/f2vWn2AFEysKVjSxkmAlE/MF802sIljFxKqCVU2sJljNxOqC1U2sIVjDwMjaFmved02seR/qTa63zDxtwdom1hGsY2Jdwbom1hOsZ2L5v5N6+zuz3gQrmFhRsKKJlQQrmZgvmG9iFcEqJlYVrGpiNcFqJlYXrG5iDcEaJtYUrGliLcFaJtYWrG1iHcE6JtYVrBtiXoxV3GNe7+9i0H2Mh70qA07UrQ6gW30a3aoTdasAs6uBE09LX+sEYBw+GuPeX8aCvvYyp3R81ikd11aXqI3vsr2u3gQXDD/RrFWwqolVBKuYmC+YH2KZdzm2dXbseag2+YjJbbMGZBy/RctN4LdguUn85i03hd/nXFadPOMO4uekm8HPMXcNfo66bI5x2F2Ln4PuMH4W3Cx+5tx1YtAywtYc7no2+HBH2SbEHWOzEXecLUvcDaxr5U7w0OqI405yvAqcfrGBzURZbGugTc12NeNlMakZK4s1zSjbe7ItzXqGZmhEeOegUwyxoHsMKdlkWpgPw4Yaz0FDwnwMast4TKjW4qnhjF94n4M2LdcLrHi5ojjkuNQdjH65MmFoyLXL5pe+z2sYB2sYx4uz67HfHrBSZ/lJ01i1qYEcm3sPROYkNmvsY7rCFE9XmOLpClOYrngxNwWzDOiZJCilbTMcJJM0EDS4hBhoxDENSJpgdjVwYjUwMNAIwRQMNFLef5dGzAJ1E3ygznQvwWfjTOeTfMzNdCHJJ9ZMF5N8+Mx0KcmHuUz7yXmc/TNdSc5je5TpanIeJ/JM15LsN5jpenIe5+RMN5LzOPJmupmcxxYq060kh29nup2cd9qa7sBGU9Pd5LzT1XQvOY9tVpsdDzv4G7wY9kzs4G+IFBkpGkiJkZKB+Iz4BlJhpGIgVUaqIZJGm0nLujfzatZOnx18HuaZ/v+2kV3jaU1Qd0DbKbFxcvWVjTk+ymz+/bocmyg3r86hlcBdw7bY97+4ERYhbObZ/uJGr/v9+Omcl5/LUTK7A2tphl2bHJRPNkSwdwLLkO05Nw7xEcg1KIdS2Z+iWHaKVcqUGmRdMoWANtAG+9pGd9gb8BzPpoTiLxef8Qn0o9PSmLWXVTGMnJZmvQwjE1PxSY6DY22LNawbYKmIrwoObq1tMSLnhgNDMYN/37f+DP9+sOfEDUO2mMvERK1+gD+tGaGyrIoPnf0B/rpiocGONrmZYqV+Nr4RA4ABXgzAWGAg8Ml2UuCDoWHOYbFIGOD1AJtDDPCCoKDJk9pQZICXBCVNPsfOepjMi3M1pgviXI3pojhXY7rEztUQgcLCAVbDIivcz8LCqWOJVm0b/MPsgoNtj5pWxl6gOHTQuQKtoAL3D7EGvRE472E25LSgbIzS2EEkBxqxuXt29sN7ybbYNywvduDpa2LfYP8nnr0f4Dc1+E2xBsksoey2FUWWA+eNkyoDl2/yXr/OHojiQ9BGZkGW9B7Y3+w54doZz6LMPn/80MewKXaC7ElwD7g2hu7zcxwcoVg2W7DaZz3Hs8i5ASahDj/fAagyO3hoMdiEkt/g0os0uO/nRn/zwHd/9qN7oP6MVR23vDC4SmqhrDKQ/8TkiYEFz/YGRNJJz5annFxjoz7F8hNxnRRUqbXx5/lRkI2j9WBlSYtZUtnzY5Hvh5r9bKbFQxMWib7K9Nty8TjEy0DD/Crz0jm1TsYwrCd9iJkpLxkWNUHeEr/WugUrHh7reNXpl9VaWlteikoceumcGpGRjteZPq1FiWU1REPlJbW+v2CY6sijZhbZNN2nkbI869Ai/q5dFPsVQ+b1L52TPL6/747aRe/9p9uvWDjhxjNeguJDMBTmxjRkeTF4+LHIuSYGQzg7/Hbt8Nu1zW/XDr9dO/x27fDbtcNv1w6/Xdv8du3w27XDb9eOvl07+nbt6Nu1o2/Xjr5d2/h2bePbtY1v1w6+XYrfMGSv4S8MT+rF3XhGvlUYX8SviQ2ITQt0n7NCQisa9hzWlB1jK/0YG39zHzzv1L+2kfVnv80/nW9v9M1ukNk6r26Uvrq2ueyiYUONd3PZHRayshlGKUz6m2GDwmRpc9ldK2Rxc9nNClnYXHbXeZbrOAgOo+dtbB4LHdlBRhAC3vZqm8Ujh5sh3Mf2qgEwDCsnDIcBAMcKAPwAGKK1DJQCYC1lGSgGQJbWMVAIgHXBfGtQz7GhgKwog/iQqCHWT1Y0jPiRQbqmaA3iSwbpqqIhxJ8M0hVFaxGfMkj7irKIXxmkS4rWLc07va9uzOiRW4/VB9nbbMzrsNXoZU71lY16s0/MSHv1jdFkvyVY/suGaWlbsIKJdbXp6yuGSWtPm76aWL4ppq8hlvkLx0o8r3fG+MNSTpk3x/jbUgOc4Pl7VsUxu7V4bIZrhkRZDKzwjakkJ9hkfUohSpUvC1yHO0H4BEHnV0aQMISXZx8u6F3hvgU7ZuygaNo5KjlTQc5jOudJnfNMmPM5nTNv6awFS/Jmg7xFS2cuWTq3b4XZK5bOXw3y13T+iSB/PcjfCPI3o/ytIH87yN/R+SnI3w3y94L8eTvMX7B1/qKt85dsyT8V5Pdtnb9i6/zVKH8tyF8P8jd0/pnM+7CgsM960rDt8OAI0b82Cdqzo6GUrXpYe1/MH3T/nF0on8i4cUwUObKyWYqYEfQVIUr/YjFhlOBamUCS5qqSFJyVktQdMbXokyQhkrRWSlJcKUnDEesMUxI7lKS9qiSlVSRpOmLW0SdJUiTprJTEXylJyxFLEFMSJ4POYMBNSUHdlQVVVhbUdsSGxCxoIEMp73uxmyj+FFlPUeIpsp+i5FPkPEUDT2U+8ve2c/XZX7Get2D+kD2lLtzCe06ssoRbT9k/eD2uNoDovB4/yHP8DTyM/OD1+OaY102eUuu38OrA/0ZcjdO494PXkrkpO6YugG+m0zl4WuFMU6dzovK0ASMRX4P2orKy07SONmyLpa6JlY4LufGa2Iua3HRNbPE4rTcPXtvJ/nRrWbq5LN1Ylq4vS9eQFr2a9TrgzHodcIZ/i/q3oH/z+rezrJyqxnsJWuc6tAFhHW1dNXC+glDI7jSM4P42dkpl2QqumGFHTvNyjjzBWH6UsVl00euZhGuPrpC7MTIIeQh9vZD7MRQIeQAjhZA3srsd92Z06DC9o5j32iaMHZN8zBrcXd2yWM6WLfcOuoVupBvLdIAOlGk/7UdfcogOlWk37S77NEdzZZqlWQ4luFimm88h1yHemBjm8+O014vn1JhIn8ZxrnJFfgccdAgCLVAausNsW7t7MVu2yjRHs2WFkrMec0ZH02oEiu4tW898L98jfKxF70skln73I+zKgM+pZ/U59Sil2XoEerzhBLqs+GlGA0dKfFqtRmjW4Oi7EdvE9Tm44uNxeVQlDzkRHW072SugrZx194vJwQFWcXZvZAVivBFshd3CDztAd9DuwNT3lTJXyC10M91YVqh3vI5Z2u+zOPg7Z5x94yHUHM3S3MOTftYTtzrDXvyZnBrxehPaiV8CZ9E0AlV31MGj/O+fX8ET8kOoQP3ai7kjzgIlaES/zrrKEd5k46JcoPic9hoabJpgU4OtCBzBIdGIN8ZzqoRX2AqOhNeVWZea0woDW3LE5KhUYsLLa8bOFt1IhNHfmiNNtrYIR72foxRxFLmMufAu1eAuom/Ar3aUPcDh2XWNfkW/dLxvXZU5aMpvi8VuGIrc3+Bz3BZ7bRP+vjPzNEyzvd6kfKiZqFnslmYx+/+jWcwt0uw5s0HgfaNB7EaDQAJ/Z40GMau/JJo7gQaRoWFMLYe1MsSEVobYFisd5+HSAuXZ2AlJILiDZ+9HEAY3jTiLc6fUCIdndHC6x++R9+Qsdxa/c/iseRd4N34X3P28M2e5B/B70L1RPHi4N7OPEjwVHu4QewBx72D/H+7d+Dnj3oOf59z7efvPct9CI15jlhXoZ2a5IdUlNSWpmqRIUlVJTUiqMhsp3o94/myknw/tfPcvLPDMaWWiEa8akbWQpL9ATLZZGuHRYI5G6C1RKKN5pwTkfhMpArnHRApA7jaRPJA7TKQ3SyN0yES6QM6/an/e6YC8kQ74804b5H7a7c87LZDnv3d/3mnO0ojXnORNQSunRrUqC3evFeu0GpbL6EfnYDo3SsNsgDfBff9Y0K1JGROhqtnCKc1b/Mm8iPcjzKWfzAxPDQlmhuXgsPi97GcOlO70RiZ3HGiM/Exjp90JzZcOIoXNYZhxE84CjyDurGe5w85CUJo3dlqNemNsNxgGktIl0FgUtUmgBI2uYBqNmGZ9352lYcR1GtZd2oh812OnKc18NCuPApQmDCiB50l4Y4jnqm8WRPKd5Ui+5gPTiFeazbkXeTE3cX5SVvzH2CmV2aLLzbAD9ezNagtHOsHN3UtwgiTlVSz1VvdOSrhJZ4HeSneW3Ts9y73UWdCNJE2XolIuR6VMUTJ83jQlaCp61jQl6fK+i5cbMa58372TLkVFXKolznj5N8EGcey0rmi6U/SwGKZLDCyJJ01KVTjsHYrFdu/keggrSkplsy60awmcMcmb0ilv/DQOLtK6Mrgh3Nk/AeCslDb8Zt15Tk4h1mP/N4Vqm6IU4pxt1swpr2qdzrnbPFi2TboJSnG7k3vIC0oyC273VnMiEI0Ld0I8SvMt3DRd4lkIBxLtX+rCklFdw5l2rLzk3kmb3XSGLrlhKOYs0J3RbcdO69ekLp12wgfTBajLOTddiiqky88vx7moNN5NmnTMMckS3JPupLee46C9l+DpL6Gkm+6r9gxN4sIk145Khe+iPZRzhynjlZI5d5QyXiWRcy/DK47n3CsoA3NWdztlEK7LvZIy6GrcGfjijUsdd8Zz7jbKeH485+LVFcdz7qWU8ZoDOXcHZbz6WM79KfA7Ofdy8I/iNCIDI153APcdzblrwG/j3CLj1dfn3Cnc3865aynjdUdy7kbw81NlvNJIzk1BrljO3YT6XJdzL+YX2s3mdNN0EOEYU81JDM7qquwhFDCco0meeo4F+kUZRLWkqyRv9lbKwPyzm8DfyvD5BXllWKAeQ1VAVQ3lk/hbA1TTUIGhOqC6hooMNQA1NFRiqAmoqSGfoRagloYqDLUBtTVUZagDqKOhGkNdQF0N1RnqAeppqMFQHu5D81mBmgwVABU01GKoCKiooTZDJUAlDXUY8gH5GuoyVAFU0VCPoSqgqobyKRYYUE1DBYbqgOoaKjLUANTQUImhJqCmhnyGWoBaGqow1AbU1lCVoQ6gThYNLwEf3ZOYMqsJvS+W4aClO2kSap7KDdFWAvpTk1AHVSpEm4mcGqRJnllvDVCahEqUmhQn6gnK0FU8GxzE3VNsDswjYRzpLHsZ8SUERgb7aTsjj68Z7d1f0vwMMa6OhD8vJWegMM43muFUSaemOFXUKeJUQacmOJXXKa4b6KVrl+QZylzmdHlShVpc597JVbfOfSu/rnXuT/M7Wuc+R5voYp6oTQlFuBFTE7gJU1ncgCmOdcQU19Il0L2dgdhMcSlMcSlMcSlMcSlMcSlMxbSEzRH3Z/jlj7g/y298xP05fs0j7vO0ljbqspnispnispnispnispmSeQxNaQmZ4lKY4lKY4lKY4lKY4lKYCiTsrXd/nhv8qPsObuWj7llu2qNu3qIBWqNZmeLsTHGRTPFtmOJbM8XiXE5Jk+KrTHEOprgUprhkpvhuTPHj4fsZc3/B4vc95v4iE9Ux90UmamPuIgJT/5S+E1N8J6b4TkzxnZjiOzElczy6VN+JKS6FKS6FKS6FKS6FKS6FqaAiG+Pur7BMzXH3k0y0xt3d/NLH3f20GeFTuHSmuHSmuHSmuHSmuHSmgtJLG9wDXBcb3Bu5Kja4N3NNbHBv4V5tzD3Er3PMvYNf57h7N7/Ocfcelm7UvZ+FG3XfwrKNug+zbKPuCS53vfsUl7vefZrLXe++jSt4vftufpjeOvc9TORH3FkuecSdoww9x41lhF3IZeinac7HKVaG3sqLA5yv3Envsdhx3Iw4TpoRG8MZcZw0s1f3S8/Tu8HWsyhDP0dv8zlwVoZ+lp72+RA3Qz9DT/kcZutKKehKKehKKejKoKC8RSd8DjeVobP0sM9RqDL0DnqLz8GpMvTzdL8vMaukoO1S0HYpaHtQ0KJF9/gcuylDL1p0t88xnTL0ixbd4XOspwz9gkWHfI4BdYWUdYWUdYWUdUVQ1n66xedQSBnaLesqkJ+06EafIydl6FcsXmS14nSZlHSZlHSZlHSZLomnADKXugjTCaRktpC9jSbQPRY5WqcLssCkAplncivIHocTneSulMmraDTQax6j4WC28SZMvN6kV+w8b9fTwcBYwWHLddHNvUir/TDFaj9MsdoPU6ylzBRrKTPFWspMsZYyU6ylzBRrKTPFWspMsZYyU6ylzBRrKTPFWspMsZYyU1pLmWmtpcy01lJmWmspMy1ayjw+/SNHNNqCibzjrYNWMRZF9Tlj6wLu8WTDwtnPaglQ48aORrinwbi1Lfbicc85AKUEbL5f7M6LSeSU/JD8TJj2t462xsXNoc0b0C2Dbhp0w6DrBl0z6K5B9wwa2r0BXTDookGXDLpi0FWDrhl03aAbBt007/W3hgwG3TN4ugbdMei2eS8jb82gqwZdMWjfoEsGzYqv86G7w2AbSxThWENX06w5rGnWaJ6PDjvUPM2X1bxcZNVrTVcDGnt6CTShF4/TvDSI7DVRy5BWxIdrwsMOybIvc+QrRPHN7kIJ9rbY+MACtkppiIa8f9PnHWP6vIM9R2lFuEApLxEq5SVCpbxEoJQnFH+dTPHXyRR/nUzx18kUf51M8dfJFH+dTPHXyRR/nUzx18kUf50J2WTjrzMh+3n8dSZkM4+/zoTs5PHXmZBtPG1DkND7CCNa21X2FYYjZde02BCM5miYRk0wsCEYDkC9PaxtCIYoqEBb9hvZmsBmawJHWxPYhjWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYG9ijWBvYo1gb2KNYHNHZyyZVwMz/+CnlB3hLMIigMdgv4+cDboA7HtD41RlfbaF+XgfJaz3eXF3GEv5ioccG48peJboLreWo8tvKI4CYpH+3F3GZ39HtpTVs+cU3vmnQ6iVuyZd6r6tze6WiZ09pzpvRbnqo8Kd0H/NtdDXxHLV7IVnOxlSdnbYk072o3r/sjlzjzutdbm3BRiAtin1OCWGA0iiEUoMquw+zbuYvpCpT2s/VJewk/FVg+W1TF09Ms5ssKxQMeEqNpl9ci8ERJB2CbKS+4uz+Jt212U9GZOc4c6QYPBFik2CXcFu6fSYw7SLuSt2WV127wRSUEUYfesXiS9QZEDZpF1u6zePG8EYBA1+TcocuoNioybRTbssrp9nnkfnHfmoj3TXWadcVU9GFSVuqmsnpx3FlarGNyQYC08E97STQaHXfby+jk67xxE8zRuu1rV/NhCneU1dN+8c/gnFjr14wsdWF5HHobyQbpp3jhsXlFHz9FNUkc1Wx0sq3vnnef447N/zCMd+0n1hEc6jlnB8meyf8wzHftJFYVnOsLzi0E6CDXHN36qqkUH5bHqttpbVrdCE5Kfy/kxEhStN3wwGypX7j5KiSDqMN0eRer21QO80k3RA2iWKTpM3rKrPVw9QreX6Ti9uUz30m1luokeMbgQm+x6TLlStIsOl9UuMN8K5oN0Wx+feognVim6HrPAFD2EKSBK91D6fSj9KEp/cmXpJ7l0DwXfh4KPrii4pAtekIIPUoo8SHIfJDkKsZ+kR8r0IB3rL52Ln5G8KVRB9D720V4o8u5DMXvpzWY+ZKrrOxLfysOt7sOtjuJWT+JWDy67FaayKdoH3r10X195Hsf5TpGHCW2Kbsc93wzRb4Poj0D0Y3SsTOjy+wvlHVDUzhHUznHUzr39tbOH1WxR0UdQ0cdR0feiom/qLwpzZG4KRymFIeQ5FvYIhD3eJ+weDkTOPLDrocN0xGw2ezi+OF8uWCzaLoh2K0Q72HdL1vnFTXbhJrcuv0lL36QqN9ll3mQXBy5P0S7WD0YZ+1DGXrMM3rBBzn3LchZthg+X+460dXEdiwY938ZKO4496NZa/G2uX5pnEok2Qy1AbQ11GGoD6jAEBaSddj3JdGstYoPZEf2/xpiurcnttHtC15O5nfa/Cd2wczvt7pgU3eWiOyi6q+/WY6gLqKeh/DBfAAQSiQJD+VGo4GqoyFABUFFDJYaKgEoa8hkqAQLpdcdy2bukB3F1R+m+WTpf97gMVO5emQa41+s+5ybpz9wntVncYZx0k/uoGLTtEwu4+7gQyz0oNnMPgmfCfUCs3R4S87hj2r7uVlzMup7YwN0mRnNHAU65J8Va7jExr2N35Sn3djGTOyXTF/eIuEzdI9XuupSG1362hEjikHmC5z7OAg3CzROlKCmGcHx3P7sXrSKO1VtSOLLXS2SfUegWTNCg11ubY1chnQRPlJCmUSwMB6edNmOjmD2qrQZvV+NYQW4x8J7G2xac8UY4DMOAl+yc2mzgBcb5VrARa9pCw0as4AgNG7G6pmEj1tM024gNCA0bsY6mYSPmx4WGjVhL07ARKyaEho1YQ9NtsVljuiO2ZkxrG7Fhtt4aFDsxKGi1JZlPSW3Bz/goV7s3cxoDWC0bzNnl4gTUGerLwK0AG8vALQCby0DWhmgtAzcDbBsg3KqPslwSzV3P45JaDcO2F9h2MAlFDHnDdqCI8Yh7L8k84RG6t+zeqxUxhGvYS0IRIwkv+5HOgS6BUpFqgUBJQxEjYDIUMe71fffefkUMabRJL4nZAZ9y3ytPxHCginGvqAsGT7WfA9ZZ7CLzwJCDeAbTTjfDbxDxFDspgXoMVdLosNMC5dcwF6COhgoMVQbBNShQUbgAdTRUEq4MuDIC+cIFqJPRn5l8Yneq0W2xujNkketheYL1yJqBTFBLgQbJvdCc4MLwVr0mIuipYZyTQ9kmu59ckhT/zR5EAcUJ7uERGUE6ZRSPrWXuAWtruAeE4KVBgeoM+YB8DTUYCp447NB1p18ajDp9pnWn78f/E51+k4uuouiqvluLoRqgmobaDNUB1TXUYagBqKGhLkNNQE0N9RhqAWppKD/EJQJqD9IeOoIF5im6nq6n2+kUVj5ldTsdxSBLHt0GgI7S7YA9ehATC3qAHmL4GGB6kDxcfICexFSGHqV9fPE+voip5hI9SQ+A5VG6CbMEOkmPMUuOWW5lloNgoZvo0fOMZSVSMMzkm7ko4WbgON/+zeF9cgI/WV6i2wgXH+KL+/gi3809rEe4I84CKW/mtErKC8MuAQ/jlMwpeF3a96Ef/p7/H1+r7mbLNDl7ttl9b/8VCUXKV7L9VyQuKV+Z6L8isUn5CvVfkfikfGWq/wrHKCWFD1h5rOoiLUrEf+MFvwzk9+qB/BE9kH/Q0iP5Jyw9lPuWHsuXLD2Yl7WxlntOrMbcz4j5l/uypUfyXxXLLvezlgziFbEUc39Nm3a5vy5maO6XLBnBa2J15v6+mI+5/0UM1tw/sPS4/YcWN+isew1/kln3Wm7mw+51/DkMuwsyS3NvkDmPe5pbe9Z9J2f0s+6d/BEMu2/lj2XY/WmZw7nPyYzI/RkuIOv+LH/NWffn+AsZdp/nGw+7Py8TPPcdMl1yz3L+LA6p8Y1mcUSMDyiLI2LcexhHxDxzwxExT6hwQItSsjighdxZdzfLCz1Y3H7YPSAzO/dGFmPYvZmLyLq3sNhZ9xCLm3Xv4NsPu3fLtM+9h6UYdu/XOzhJ7te6Y9DAwGzF6N3UcPYec55WtWWeVrNlKla33Vt187hNV/9Rfj2L7oP8WhZlcpZdlNnZxKJMz2jRPcOvb1EmeAuL7tv5vS/K1OzwoszNCtaiyyFinluUeVneWnTfpdvOovu4NLNF9wlpeIvu+yxtrz9IKZ4X2GKoj8+RbitjMo89PQL2PgvrCHaPRrfyNgIuTeDS47jyBBZefNmn+8pqn1zP4noO199lgeEUFhLC5dNNZXVQ2FJgexRsj4HrJLjeTgdDVp+uL6u90iM8CLYzYDsGtofA9gDt1b0GMx8tiy4e65fJpzscLDpYP2xQXiFvJ6bkFcIkvKRfWFG/sIJ+YXn9wnqWvLCuJS+sY8kLy1vywp6T93VGXtdJeVvH5GUd1e9KXtVBeVEL8p7m9FuakXfUtuQVtSz3fYw3LfdDTDQs91luSZb74aBPKAbdR0l6Fst9wdLONArastN9vzb3dD8QdBQv6Y7hl3RX8xHdo/yy7kA+qjuKj4mtq/txK2wmKpnjgMTD0m+rXfRLVln8rHt0suxzz6z20UuW0BPqIBU1TWovPSDklLqebipzJ2vTLvqIVSaPHiv7tI8eKvt0kErIs5eeKPt0/fnFv+6od9EvM2eOOY8x5wvC+T6LWW8t695+F32UWU8x6xlmLQjrh4T1trIeMnbRx5j1XRbzPsq87xfeZ5n1aFmPO7vo48z6OHO+nTk/IJwfllIfLPsr2p+x2PXjKxa7lfiKxW41Hi12eU5jLnAL1orFbiqa9vBUR097CtaKtW4tvmKtW4+vWOs24ivWus34irVuK75irduOr1jrduL9a92+lT/mTev7V/6YN61fsbTnJb9+cqb/Pzx5sIGA6df6/oU/5sXr+xf+UOhY37/whwLL+v6FP9QYR/sX/r4+IjAW/lBNGe1f+GPaOxpMi0RqeaSfNKn4I0sPI39s6XHllWBaUQ+mFV+Wb96WpXzbki2FiiVbCGdkZJqTfi4mOwUdy/2ToBP5SjAH+VPdMXxVz0G+FvQ3r+o5SEP3GF/Xc5BvBF3LN3UX8md6DvIt3dV8W89BXtNdSzOYg/y5xW8xilHGVUNpr7AefzuI9OClctm79Ysb460vqdJx3qGSSf04by/Ja9vAW07yVsd4Z5TpyrhYuXM7G+f9WXmnG+YRu0jyjvOGJ9PVcd46lNY5zju28sI3zMNbueQd5y1AWdmM8+6dtLlx3qqT1rBhHiGQJO8478zJsmecN+LkucZ5102ea8M84iRJ3nHepJM10Thvu8lzjfNemzzXhnkEU7qe9p0fVcvZl2Hi4tFe2iWJh+m9OGJzT9Az+HlKPMdKA0gjlAbI+3DO1rnAPSgbPDiZB/xhS7aGzuhYlO9jq/85jEhj+H2Jf8l9ED/YVxrDQFZkNOV6+Mm6x8QM6V2W2EC7T7PFtfs2He/y3ZbExnyPpQNfzrKNtjuPbFPu2/VwPSafNe8qWXrYTnBj552qou0+gN+C7T6D37ztPorfnuWexG/Xch/Db8eSTay85Z7C73Pu4xL35wn8nHTfy098zH0WP0cxnCYgbIF/D2IwTUC4D/DvHIbQBB75I/zbtjCGJnj0/igTTQujaIJH748zUbfcTzFRs9xPM1G13N9gomK5n2PCt9zPM1Gy3N9komi5X2CiYLlVS7bmfsuSjb/ftmRz73f0y/pdS17i7+mX+EUM32OIgnhapaFCYlM6p9IyfP+WVcarT6m9MpKmMX5fT1VNT6ib6NOaJnUrj7xpjN+3yaAIrZJd9NsWdogLMgJixL2JfgOJWzFe+3Qbhn3RRdlFv8O87xfex5n3c8L7UeF9RoZw8P4u835AeJ9g3s8L78eE91EZw8H7e8z7S8L7XouZf1OYPy7MJ2UUB/MXmfkjwvws835BeD8lvI/JMG5hGLf0QRr6IW6GaI5ohmlpkopr+6hU9gP61T6j3+yj+sWe1O/1Mf1ac/qtntIv9XHdKJ+QRinN8Iw0w5O6GR7TzfCoboaHdTM8qJvhgm6Gc7oVzuhGOKXbIOkmOKFbYNb9tDSNNNt0WoSJH6V5NZDg5lEmKSml9pZJCs+q62G5K3ecUDeVSYQgdWuZRK4pdVvgR8GiBzBlP4o5+qct4qyfss7P/ejjFs4tPmbRbYG3BosKvM54wQL3s8L8XmZ+AryPB6xwPnIKnDkwPiaMJ8H3KPieCfgmAtMnfn/GqIpTJfScKYXZaxwS30rHyCuff0wf6YPqNnoI6eslfVK9YPGuy/nn9dXjZd6oiaMyPsItKY5g6EeF97BiiUCeUQWI76uT3NA4y4T6ZbnnnIL4wOOIa35Ksjyn3i9ZnsE5Eucg9VHJsaAeIC3gMfUo3+QmHrQshQavnigb3m189Wy/2dIvWUZ06A9YdCt9yDq/svPV+yw6g9XUh3FESiUL822fT5Tk4A0HQL5/zlf76C7aR3c9PAnKcFTE6IlJdRfdVX5JHaS3l9Vd+IqM+/2G5dMLpgAfNlwvldUZuos+Yl7+kEVHCYU8ZoCfs3wqmFxv9xX3B79sgh+zKMdZTxngb1o+vd/k+rjlqy+YQBXN30h/Ck0XxTxqgL9loUUawKctX/22CfyOZb6DSLvk2ZfU71rnVMmixw3ux+kuXjU9Y2C/Z9ETRvJZ3y8rvIcl9UWr/43iJUacPl7qbcTrLXX+jVFfFeNlHzWZP2TRY3ix9HbfhN9O+/BR5kysaPHa3SdUGtZKqBuT4eMW9iDLPqE6PmVUh1kXaFmP00kz3+O073x3T/yIJ+mk6f3pi9ZL6tPWufPthM7Q580i1Rnah96aUNV0EjVTVs/QM+Wl5S2eb/h7Fh3EclQdxAjil9UTi+rx8yRqT1rl+Ya+rKKkofXjPhUtkma0LMNB9GXSMnCl76HxFugMQfsAo6Tv0xMi8BP0hPm4z76kXrLOqWdRQ9j++JjVd4NPsXMXegJPyR/Hh6zykvrAsvZwRLQEHqFH6Hb6jEW76A+tsjpTXqKXLXqS/sAi0L5VVm8vL9E5i47TlwSrWQToE1ZZQeWByhZ90KI3U0Uu/5pc/qyFtrVUVkfwZxctWTjvpj30+8L2X4Tt14WNftWiI+UlcO3iHWb8VYfp2jLKPoJ7HBYuvnCErivTAn0CmXGnIyLiYSmQWe4t02nyLXo75L1X5DoiT3dYbs9sj5TpBvpDVPsfWPRIeQkPCe6KcH9GuH9fc3/QEvebu+iasr+kPsF7iOenMvQkHaY7y3SE3opj/Z8u089AV+A5ijK800KOJ3leb0EB4DD9HDI8jww/X6azyPAOI8PPgv84z+u5LbyZjtAvWuB+0SrDVuCRMuwTJAMdpl9A57aL8nyfN/PawCrT7XSE9iPTgTLdjCw3Rjl2c4ZPcobbeXFgQbXhCN2BDHeX6X5kuCfKcIgz3AL+Pbzo4QvqXuz5YXCcp1lf7cK+Cr3HgjGHOozhld5GT/vqCM8Z1SO++iC4sYNCt2K371hZHeN51LsseqissKfzAi7Tg2X1YNlXL1hLyje7zSWLpOZrXPNxcX/EVdXQVRVnB0jET9Xip4qz+yOIW8ZIxttIuzAvpcO8mXSEp6TqnOWrz+Aqy3eU940e432mAgTy1WNLqq8fLQTCdAJhuoEwvUiYvK2FgS8lFqbILpDUyyzML7MwORbmFAuDOa/6VctXn8VVFibHwpxiYd4vwuSWlDlwntKilGwtCtwysSgVOxSlGohSC0SpiyjvZ1E+yqI8wKI8yqLwdKFi+erXeNIHUR5gUR5lUd4rojywpI6iR/PVwain+oD1knr0nHqvBa4PWYvq1y16ZlE9Q/ctqvvIQ/fCGieyxUZHMZnx1U3Y0VNeGb3BrTI6m8ORusv31a3oLDEFo5OL6ig2eQsY0PaVCVf3+T49iwkZPbGobsPE7yA9fp7p/GOWMd+gffQseoq7ynS9LxO3W9H53gbkmfOTJdqL3n8vplU8MNwF4a7HHGdvmTwuJuy523vKqLhHUG/nLK64X7XwaVcsg+kV3tk+/wnQMW5vD51/3fQgKtpk+aDU72csruDP4oNAx/Ugf4D4zsroCneVfenH0A6OlH1/yffpdy0svjB6ZV+OvhafHs2+bPlL9FR0F3U9HyeeMJCboIdEe+iPLPzfQ9/mVv3nFipriV7DiNBEdS3Rly3unOmbGBH+TLBvcfdIdX4hS/SqRa9gQPi6XP2GXG1YosiF/vRPLPpji26nrwrH14TjT5mDvsJ9LqYlGAg8tNY/tmgfMvFJ5p4yWvIrFh0G6x65oScnkj4dp7pFe3G326XIPSKsJ+eU9CR9GYPdtyw+gPyGsH1N2F7TbKhffny6C48N2f5M+L8u/F8V/m8Lf39TMBx00MN4M/i35O7CmrC5EUcLu+CmBKYF/nF4qP3kcY5sgF1I/zjbfMCYoyvGHGKJQNPZa2HkIs612cwI0eqOs+tCms5etynwjaJsL3aL6QlglncFPespN2GfBbG/76oXk+vveModhWZF3yV2wRP4a7A962nxaj0MfZxh1sdhSxdojFun9T7BHJb84RXxVWF7NvxPjUBTYoRGRSXSGzudcW1KsHGV6G8o3oiUjcqwAHc2g9pCyU5QMquHq/3a28y/vlL2aXbfun/c9s4XP/HUdS+/tO9bu84++mn/32G+cy77act4O/O0f9/P/PdLdqQ+9zzn6r+8pGb3+X/yT//PzQd/d54i8sRk9mULRkDV4/BnQ7t9nw142OxrAOobsW2xtjWw0GeGM6qtSNKhGU46NMNJh2Y46dAMJx2a4aRDM5x0aIaTDs1w0qEZTjo0w0mHZjjp0AwnHZrhpEMznHRohpMOzXDShhlO2jDDSRtmOGnDDCcdmeFg69VixXtvLudOYLdNe31h3X7oZSUCy5yRyLm8LfHhh2GZM2KCWQ75kYhAC5Y5VmSZMxqZNoWWOYk+y5wEPP3CIz2l3+A7wpXp7HXunL1ACf5mnGXfzDzeroNvZtg+C6Lvm5mXb8bBNzPixVzHuBSJyO4fErpGHP3tUILbeKDNJn69nDe8Mu/7bAxm51yHLHw9Fo1oY0x8PQ4N4+sJ7yluTOGKvW2x33E7LMidz9AcRy0WvzhqVn9Eu82PaH71j2h+2Uc0S7vNj2h++Uc0H31E8/0fkQ+fz1lWAnIkCtYmysLThjSSwK40G7ze+sXgvpg9mYdBrLJei5GCgbQZKRpIh5Eo9FUWbpcQTauBMrt81QiDlfVqlwAyomBlPX8KUBQEK+uVGGkYSJGRuoEUGKkZSJ6RqoFUGDHiX2W97nYW6Qrj/q0Zfs7tUb4mI3kDaTASxb7KenVGugZSY6RjIG1GjMBXWfFXZca9ynrFeX62ncazMVIzkDwjVQPpzfHrNJAuI76BlDiXEfEq67X3sEjXGfdvfDnGD7fbeDiBugZUE6hjQFWB2gZUEahlQE2BjIBXWa/UYMwMeJX18t9g0Ah4lfV6X2esYmJdwXwT6whWMrG2YEUTK8g9zIBXWa/ZFAm/bUpT+wt53teM3FXB2iZWEaxlYr5gTRMrCdYwsbpgZsCrrNjpOX0BrwKL1azYMmfFljkrtsxZsWXOii1zVmIJZ72FU2Jty8BB+TksP0fl55j8nJGf5+Qnb8lvQf8W9W9J/+oCmzrZ0L91/VvTv1X9WwmKs3Xx+ren8a7+7ejfdlCe5qvp36r+rehfX/+WbMquakncwIVZPpLj35ZlMMKgLGD0LWE4KT8zBHfB3Hl6sXCDeoVF8BhbBBsTuTmYwU2eUuktMS/pjmgfeskD7LcrTY52schHDywfhngcR9kwYW7qVM+Bb8OWTvlxtZ8PGDnVSKgDfKTKqW5S3cgHpmmJuYvDgZv5RBRAfVAcffKRJ4COeP48xGeaAIpDDNzBNZSW4KwA7uaT2rTERAVwDx/FAiisY+B+PmsFUOUZhHoLH6YCEJek6mE+LQWQH2PgBB+HAqiMM/AUvyAAzQ0MPM163AB67FdOvU1Hukx4PvsOVe+25p22IA12vqjeY807HVt8O2Ia67PfUnZkyi5NsZpj/6Y3081ln26hW8ri3vQOukP2f+7G/ss9dE/Zp/vp/jK9hd5SpofpYc56gk6U6Sl6qkxP09NY2L+N3lamd2PLpYydl/fIJpKvZvvchKbRirKUlo+T31VMzS+K04Y0Ds5volkxMsfM+5y5MJ3z4VFyBEckI946zEFYA3vstDsWzN65/cxjuu8OOQvYDBI/eNEiAt48x05DWRq+UIdC3epEv151gobg7tK4OLzc+50sJbTSNUSnITgosw1Xd4Jq73oM2Qs0hAcY8sYMleuxA0MObLtkOoDHwbDsTsjw6LoyTLlKBgp3q+6j3S26e3QneTZIQ6EHOfakl3HwGcIh4LCXuFmN3EAJL3kjvLCJZOytT56LO68MMUtCWKKrJCGnq5ZmiL8BQ8vGgsSJnNYNe8nb2LXdsEzDpYsc03bzI4E3RBozrjTtnBoy0j0HpvJR2o/Dnl7So6FHRTukhkJqJPK3GFKj5IY53DCHG+ZwwxxumEOFOVSYQ4U5VJhDhTm2hjm2hjm2hjm2hjm2hjm2hDm2hDm2hDm2hDm2hDkmwxyTYY7JMMdkmGMyeLfaGtBor/xFZG/eRI7E6AXcnMT2wJw7zw7Uj4tyQ+04zJy5DRzHup83DOZpbolml3h1sMquwHywL4B1qo4rsiDr1bVOzLbszOr5rCn7k8cHFmSQUezkYE60ObSWNZQtRPNCK7lZOvJHydIKcpaO6uFbWrkOnvJNAy8S7JiJTQl20sRmBDtjYnOCPWdiC9oZg2WCB+UR+OR9iN3JDLF/Pfaml6CYfK2KPderWdi186AjFtAwuV8TJLNI1sNkCslCmIz12+69aBx0ztMszT88KQuw0L2o7oAkMhI52d0rXq1+c2ucTOQVdz/2SPBuTCeO7iHYS605pewtMWlObppiyvK6F+XUEE7s76YhaBvcg5+Ye7+uC2jRkkVRsJXsXiRlEqArgl1WSyWwI2SpAHc3xto12s93UKeKHRmLD+GE19uiHX6zH2vxJcz+s0HeIo6wQd4BvwDxnIyjF+ayt8AnwEBOo/w3eyt8JVjo26d4zT+LQXHu/KBIuzEm7u83UJ1bpAOs9hb3RSlWzcJv9SzOPKDUKnCT4f2Ab2bFtwFfFGYBHwB8B29ACVxn+EbAt7C+m8A1hm+m2WVWoKJJ56tbzqlZ2l0WNZZZ2l8WJZVZOlAWFZRZurEs+iUoBA3jkDg1v+Wc7x7qayXw24BuOQzqQ4dC+4OXX8KNhgI31zZ0l9UQ9UGVFRDNijJfmedsOtlFshsme0j2wmTeLvOETScLSBbCZBHJog0vEW9wsxo4auCor5SwsRJqroRab1B0G0W3UXRnZabuSqi3Eso7qxddcMpsuGez1/ZlmUorIX8lVHmDoqsouoqiaysz1VdCjZVQ8w2KbqHoFopur8zUWQl1V0K95ZDj1TM5mjUOYeYErmW0N3PHq0ZkJSL9iCxFZBGl0d267AKn7tGpPKfu16neoEzegp00+BtBpzPktS7M6f7Bkv4BffLsOell8xeL+WkIVIiBbAg0Ra1qIgR6igHSgFbnCpyfrdNegIprEKT5DTbjtdcS9tq0eJxjpTocJDVwLzXGpTgcJDV0aWXQXdMF1t/FoOrqx1nVNdg0a8KXCiLHty/K0Wx2DxgBybowL6tyHit4X11OGRL6lCGhTxlCUbWtirUFz5u3ghvA85FxC1tChM0vhqvZqDOyEcQBnuHVLPdobMqBDi4RNaeJFQgtQyyZs1t8lJCDvCXEaUvstD+KXwvOdXfaRaZ32h8UrAQs6oUq6LL+X+7eBUau7EwPu496V1d19bubzSbPueRITXFG6n0Nu3pIdt/Z4ZCjkSZjLSzRkRNxlkyWriFgzkhrUdJILO0qSO0icCqwAdeMH7p9ew2UkSApxAlQDhxsIQiM8mYdl7IGUg4cpFZj7zZ27aQcLIxCsl5lvv//773nNtnUrBMHQUig7znfOffUuf95/+d/QNHJ79lP9Oj+k9DgSWj4JDR6Eho/CU2ehI6fhKYnIdtvwUDytmPhwiCvittOxiugH+fhZwj8/LyK4lBWuW3E74Tg7Sfx+yFYBUn8YQg+fxJ/FILbn8SboFfTNpAWkJaJtIG0TaQDpGMiAZDARKKWSJAekJ6J9IH0TWQAZGAiQyBDExkBGZnIGMjYRCZAJiYSLXUJEq12CRIteAZ9ZM0z6CPL3ikNFi2DBrGAdEwkABKYSBdI10R6QHomEi2fBrGADExkCGRoIiMgIxMZAxmbSLR6GsQCcmwiUyBTE5kBmZlIE4tO0zWJJYun0ZmAtE2kA6RjIgGQwES6QLomEq2dBn2A9E1kAGRgIkMgQ/dk4xUjYiF5hBciJFpHE2QCZGIix0COTWQKZGoiMyAzE2lmQKyMgbSAtEykDaRtIh0gHRMJgAQm0gXSNZEekJ6J9IH0TWQAZGAiQyBDExkBGZnIGMjYRCZAJiZyDOTYRKZApiYyAzIzkWYW9Mma9AHSMpE2kLaJdIB0stiH2XQAsvQ72KfZLL+ur2P1BuuDjy8OiWPP87nFweLnLfPJxfFnlvgOeh2zttXw1vn04vjHljgSegOzvsW+fOgwA3tmzyHyRawaVsO7iMiXsKpYDW+TTmDku9G7gPBXPlqUdlkxTt/9aM3aadA8ou8pJ5GfYU7wobfLJ1zv3ZCXum0Wpy8oOZ17X0XCPZZDzzPatr17QO8yeoHRju3dBfoVRjcZDWzvKyFtugi9yGjX9r4c0saM0OcY7dnel0LavBHqMdq3vS8C/QKjmtGB7X0B6BuMrjM6tL03gH6O0RVGR7b3OaCvM7rM6Nj2Xg/puBSwaY1ddmTnvRbScYp9djB6bHs3QzpuBXzbvsuu7bxX6cqS0QqjM9u7DvQdkd1X11XdOLxfCdmVJp/dHlLoZsguN/nsdodCr4fsnRMfwx478bHsxRPEAHvClp3uLoWwy92hEHa42xT6Cp0UbWosdqCJxmTZ9SvqqyELx19R74aRFqy+RK6z9ZyYTin6lt4BO+BfWG97GbKfQn5KnifObsScvar3YG7FPVBX1V6o93xbb8TM2araAHP2DJiz5xNbGKqqiup8wn+tqoI6k0o8kyTuBYHeUxtgzm4IsyvD1v8KhnOSPXIwL7h63gBjTw/EuCzEHNW9J3yTOAdRCRmwZWuvk0Ndv3NOAJWr3UZ8q6Hmol1xBs489RnOps/7lq66B6rqO1/TG+q8qrJ0S4FUL/awbnRsfRXPtq2v4dmy9QGeTVvfwPORfoDHQ+i4F6B68XN43NG/gMdt/XU83tSP8Lilv4HHgf4mHrv6W3js6Pfw2NbfxkPp7+Cxrh/jQXrtBbBvfpWelv7ztnigOaOKaoOplmMXOzx3kHgoXmFZUBSimgytq8f0VOo7dIOAX4XUKSqh3uPMuxBIRR3VN+l5S32D7yLwFeoRYbfV1znzHUi64psh9goakIArZ36kHoRMJnUjZLopcqNJpIToLtEWwr1EbAjTRia0TCUMVUWkKhG4kD6nr+LZu6ivkXvpc/oAz+5FfYNcT5/TD/AMLqJFMpfd2Zb+OfI3fVH/Ap7TLf11KuiifoTn8Zb+BhV0UX8Tz8mW/hYVdFG/h+d4S3+byrmgv4PnaEs/pnIukGn8y+5wC82Dki7A6kDmsjvYgtUBlHUBVgcyl93+FqwOoLQLsDqA+m/p61TcBf0q1X9L36TSLujXqP5b+nUq64L+nMqw12cyKbxHH7NFpV44xNSFCJ/O9tTr6nOEBYLV1J66qV4jrCvYutqDyy7CeoIptQd54r9iE9oXdFvtweb5B4wOBN1Re7B4/ucZHQq6q/bUY9VkcCTggdpT31bfIWws2C21p76l3iNsItibak99Q32TsGPBbqs99XX1iLCpYHfUHnzGEDYT7L7aUw/Ud/mHm+cYfKj21IG6QVhLsEdqT11V1whrn1MZf7ZGntCyPDOoupqjGQyNv4GyNiKwQGALYCsGawS2AbZjcJ3ADsBODCoCu2fQBvEPbRPYA9iLwR0C+wD7MbhL4ADgIAYPCBxtgtibEXiLwDHAcQy+SeAE4CQGbxN4DPA4Bu8QODsL4p6NwPtMkC0QZCsCHzJBALZi8BETBGB7y7doXdnAxVNV5umGdwZXrF5B1VVOVXm9KERscZnLN2Qyo61ZUdWlnSR3Mcp9BnezlJ6jWbvhnT+Ro0A7vaSE80+UMFtPSgC38ckSOj+mhOBMwzsjJYBhJrU8k5SAfeiZk18Rp29gdouXSR7laAK4OJi9Ew1NTAdwhRB8NRpVmCi+hsH3tWhcYEb6RYyUX4wmA7QavCY0340GMzohyul+NRqJ6EIoZ/S1aCzh11HO7BejCQQNjXJa70bDH/0W5fS+Go1e9DqUM/5aNPzw638Ov/7nokkHfQPltN+NJgx0dZTT/2o04tFRUc7ka9GQxa+jnNafSxb7/gVe7NHHVMYfL4JH1mQeWYanR1Ldz/DUW3dbKxweb9Xd3iqHZ1t1d7zG4WCL9PozPHnX3bbkn2zV3b7kb56ruxPJ390ipf8MT/91tyP5j7fq7kDyt87V3WPJ39siiwAZXj/qbiD5p1t1dyj52+fq7nQNX1eRb+RPoz1Mf67BO5lkHzMsC5cw44+S4DgJTpPgLAk25+JgJwkGSbAbB0nSpfzR0/ROW2b8+AQ+Ebw9l8ZbJ+K9ufhko2klm87zun08z+v2uCrr9qjK6/awyuv2oMrr9miR1+3hIq/bg0Vet/uLvG53F3jdDhZ43e4s8LrdXuB1u1mTdXs2r3/VNqeofrnRUHVV5c1hwzvDej17NFKr4FcWJBfNCWdYjyKeDao41xWjHOc5x9gN1flkhkM7VpF4/jI3wZbMCd6e+np4KEiBkKvqF2KEJWiuqZ8LD1WVzpxVTiH8ABuvw+QXCqgp7Qb31IPwUF1VN8JDdQ1bwkN1gP2gkbloZH5Mmb9Dmb9Ned8zs1aNrN+irN+krN+grI/irGXKWmUKNLOhqp6Y7zLY3HPGjchyHO/vM36/BNYzJXpY/Ghd867SquPdCGlF8/ZoZfKuhYcEYJ+CBcg7oOhtbw9fTGFsVq6F6qo6+AgI5AobebgEKrcm5T7kcgtxube43HUp95FR7pvpcj/gq3Bk4iKo4B0puMYFb8cF3+eCd6XgdaPghycrXONy17mEq0wALneHy70Vl1vgcm9LubtGubUnKrzOBW/zG1TwHSn4wBOCRgXvKiE5F3zLKFidrPABl3uLS6ByLSn3jicEjcq9rYTkXO59o9yDJyp8iwu+z0VQwUoKtjwhaFTwIyUk54ILRsF3Tlb4TS63wCVcZQJwucoTgkblrishOZe7bZRrPVHh21yw4ja7ygS5EfdR6nLXjI5KFDqIW+CGQfx0wYoLPuAirjJBbsSdlLrcNaOnEoUO4ia4YVA/RYltLvcOl3CVCXIj7qPU5a4ZHZUodBC3wA2D+OkK73DBFhdxlSlwI+6kRJ9rRk8lChzETXDDoH6qwrtc7g6/cJX70I24j9L3XjM6KtHrIJ5FbhgTiFGud/UDcHccJh+PC+lF0k2vRSSN+uo1JtkDmUiuqb14Drn20clX3cBMTFW+z+U+lHEhvUh66bWIpFFXvcYUeyDzSFLu/XS5H3g3wKRymIBJz8XcIAOBafQg7q0HTIWPDu38GwcqmUYOcH7fo3UF9NgDK4yuALEKXZODEuXEDvWj3wj4hx1pN+6S4WHgXT3iOZf2pIgUOFKjCCa3axRSDK9TZJ0j2xTZ5sgORdCRDih0wPAuRXY5cositzjyJkXe5MhtitzmyB2K3GHDa9eUg4PhEX/iDQo9jKt1X2X8dtFQVcBh51J0TozMkgrI58TIMKmAfE6MTJMKyOfEyKho/QP9ZYpXhJXQrQgrIagIK6FTEVZCuyKshFZFWAnNCrMSZnPMSpjOMSvheI5ZCZM5ZiWM58BKgEFT/RXaQc3pu7SDmtP3aAc1p9+h6/Udvl4vkNdJ4pu/qwrkVvI8s70L5D3yeWZ7F8i1JFmI2sOha4vWbQtsGnIXViB3ppfIv2SGDNt8lX7N1l+kT7X1l+jbbV2n2oDRllEFv3uu4X2adICmeQJG5xveZwhoFwiYqYb30wT0GAi8hvdTBIwYGF5oeD/DZTDQO9fwXiRgxoWOzze8LAEdztHUDa9EQJ+BrsdXBHV3zMDoAl8T1N0ZA/1zfFVQh8NQAJPzfF1Qh9dPAC3NVwZ1dyD18PjaoO5OGBhf4KuDutssEjA4x9cHdbgcBXB8nm806vAbCqCt+U6h7g6lHl6DLhbIXDDV4wLfLtTdVhGsjwDGk/agCvQ9ZkKVhXlW5k14UOZNeKcsm/B2mTfhrTJvwptl3oTPSrwJn5Z4E35cEuZZiTfh4xJvwkcl3oQPS7wJH5R4E94vaXLtAAfhZ/zs17wN7izYNX4bZ5d8Q200vA1aVqBJv0F7qjBQP4dgzYM89QGC2EqQlGFVfUftheqbCrl+gQSub6hrbO+nqh4j7VuU9nVKe8Bp8KbZBPdRvUeJjyjxuzan4oiP87t4D+F6UUX9IDqHoYtHTOdpvlH7U+qS+jLjtX9TZZTRhY3Oa3Rbo8MaXdXopEb3NDqm0SWNzmh0Q6MDGl3P6HRGdzM6mtHFjM5ldKu4Q0XfzgdW+fboePfrMQm+oL4U6AP1hvpioG+cbPMCNflXnmzym0mT/2U7afNftU80+l203WvUdn/Fpsb783bS7PeQ+jqlXqfE9+2k3d9B4uco8VVK/OC0Zodc5aeptvozwnSY5htela4HHuB407YxYqp0P/BzeDZt/Qt4PtJfx+OhfoTHff0NPO7ob+JxW38LjzfhBRbXA9/G40B/B49d/RiPHRxWq7gfeAMPpb+Ax7r+Ih41/SU8CvoKnbD0rnugPq02SBKqqn5BfUZtkKGmMyTkH6qfw3kMexjq4WdoiwcTGWeEoiSZW1XfhOj/N8CRV4/AoP+64jQeY/VQfZvSMGDUtyQNxP4C0t6gtCZx9h9LIoi9S/oElPglpH1R0uIzIdO6QNK5VV4YknNjwZ9GcC8FzyK4n4KbFwUepOBWBA9TcDuCRym4E8HjFBxE8CQFdyP4OAX3IniagvsRPEvBgwhuOiY8jOBWCh5FcDsFjyO4k4InERyk4OMI7qbgaQT3UvAsgvspuPlcRO8U3IrgYQpuR/AoBXcieJyCgwiepOBuBB8b8PPqgHeb0L6x1Hl1A4859cs23wa/Sy5lLZm6LvHerva8el49L6zXrn0Y71ct7m+HXNR5AfoMzPEmmvrYIZdeFGDIwA469k7KdSrx9RLPqWi6IrtORXMVWQ0HTVRk56moUJG9p6IqRXafikoU2X8qfr7IDlTxw0X2oArSFtmFKshZZB+qIGGRnaiCbEX2ooquWWQ3quiORfajii5YYkeq6HYl9qSK+pbEkyrtfsWTKm16xZMq7XXFkyptcUkwLMcMcLlswZza/hfkWNVmW8uiuLaEK1znBWsZCgikkeeKRp5o1E3leSzPiTzHeAqf8Xj/CnoWS//jVtwW7bccXYrbkcaSndJYsrXzdI2ledZYWsal+LqoF10mOQRbnDnQaWDeVGCixOVnaixB/Z20p5RtaCwxamosxTpK5EKWBVJXblYc3PuSblRk5Z7iBTYnGJBcHSE1smLpBCTQRcg6mRTMBCRJRIgiDb4sLhSyjGyTvh98uM9yjOyQYUL8VLcA5UJcREPa4Pcs9lRHNS+Ra+Da65mDSDVs/oRq2K5ySPqgrnZDvevbejkmtK2WQegVJnQifWCTdlFMSzgSWkklriSJu0Ggd9UyCL0c++No/pQIH4hu2C774yBY9K8YO032YJd4k4myGJXaXyMrtJu4dvBtfcGFfk3RX30AfrItpCD+7G7a7Ba9quxGIuOze8T33kuvVywW2mBThDovmYt+z37Q0JqU1C5oRxVJEpp/g3tFgbLQSm9q/Bk6oNAlUcXX8BPahjrSO6YqSVRYIaE17RvDQ72r8touk6EB90DtJj+78kCaic5D0YdJAXQkCg+xO+2ygVcqSmwYOKz9wq9Ev4ldAkjBylJ6XhW0nSJ7WV1AwoWUHIgq+ZMKtPNKfiff0M/5ll4h4kxrDWlmV63wmdamw+hy7Q04KJknD5wXUJCoMpfIsfYyv1v7vLhhyZGflHl0/Xlxw0JQD1BPoGae3PYA6gvUImgAaCBQm6AhoKFAHYJGgEYCBQSNAY0F6hI0ATQRqEfQMaBjgfoETQFNBRoQNAM0E2hIUBMuMJo1hkYEtQC1BBoT1AbUFmhCUAdQR6BjggJAgUBTgrqAugLNCOoB6gnULFCFAfUFahE0ADQQqE3QENBQoA5BI0AjgQKCxoDGAnUJmgCaCNQj6BjQcQ1ubXK4z7CJy3FBtN5L/iTHdkvAx8jH6DiHOckmJoiO0VEOy4NNDJCLEQrVsbMNb5Piw5wqqWXifZALpgKd20QSroTZeT3xX1LC3Bz7M6HaquR+nL7BInJgXqaSqZ+ycj6UvnLkinWtQYsbnMJDRJ6dwl9QduQUPo9gS/zD25FT+IsIRk7h7cgp/LJ6LtL9LyovGiYrGH0rqZ2NfcIpvBs7hXdjp/Bu7BTejZ3Cu7FTeDd2Cu/GTuHd2Cm8GzuFd2On8G7sFN6NncK7sVN4N3YK78ZO4d3YKbxrOIV3DafwruEU3jWcwruJU/hS5BQ+x9qaWXOJE83fcqLTd4r+xelWnsqmMRlRBUx0zHSymkQGWPbZEb3vvLqpr8dWoHK+9bkKKmm/o6FhZ7+aeexbWZWD0Ro4s0gs07Ctnlxs3WkRbNVFwwpNjuzTOKfap8nBPk0umtvnZYMD+zQ5VWTrTrnIwsCEjVin7dK4ouyatvL0qhioufmvYKDmVXVd3QwP/ziWaWDroPcWFiF15TAow6QFqcJctFRdX3EO1AKRGbJobO0JX3ZFraqz3HiX3e5bgbeLSnd+kKW13sLGovODrFrC9sjadoLfyHoYlX9gtnqtriy/+xvZBmXzRxbb1fBnDI2thh/QIITM45X34w3F9PE9lYTvvssyETm1AK1WK9HUikNvQe618LSEd5BSOzVl/dQUdWrK9qkpO6em7J6acnBqyq1TU948NeX2qSl3Tk25f2rKw1NTHp2aYigrn0xqnZ7UPj2pc3pS8PQkOlCASXegc2UsY2ML+sO0ftHMQHMHdvo550A56M+n9Kuf56TC6Um105PWT09SpyXB95Cb/jC9yxO2gdR5OjeQ6zy1GMirvBQYyE1aJgzgNVpBDOB1WlwM4HO07hjAG7QkGcAXaLUygC/SQmYAX6I1zgC+THOhAXyFVkYDuEuLpgHco/XUAN6hpdYA3qVV2AC+Sgu0Afwy2Q0zWll/z/btWIWeFggnTXoyDcLugwwQMzu7EjLA6wGUMNJtoF4NoIyRbgZ1M9Cky220hHot0KTIbTSGej3QpMVttIf6XKBJV9toEvUGtKqdVKuoLwSaVL2NhgGb+ot0l2hgXwo0eesymkd9OYAyR6qF1FcCKHWkGkndDaDckWondS+AkkeqqdQ7AXRVUq2l3g30u3RZamBfDfRX6TbVwH7ZpqsdJ9Vu6ns2XfSIJjkzWL9nG4vBL9vmRPFVM/KuGXnHjNwzI3fNyFfMyJfNyJfMyBfNyBfMyBtm5HNm5HUz8poZuWlGXjUj181I3YzsGhGa1bB1fqJTn+h7J7rJiRZNkx6i7AadSTM1nbl5In47Hd1JRwunFf0Ou+JJ526diN9JR3fT0dozy+6fKKt9In4/HT1IR9efWfbgRFmdE/GH6eitdFSdWjavZv0C9qJF3ouileN9mkeeY7ow5LkGr44BNn7dt7AY/rYFO4uW8x72ar/2g6wHi57YhH6Y1buKjEJaql5HXNV5xbHKHgyCXlG79zY5wcIb3Q+zHtAraveu52zieYhsh8rZrIV2YvIdJhHryO4cOI/JSIv1gvWHP8xWHct2y8ryWx9mG/TDfvvDbKNMXMGyWvA7qKzjHKi1bcdCfac/xBhXay9Y67T39B8n3wxtcFLUxinhRecPfohqLrF74xnq7Df/MTabkWNjy29JvCXxtsTbEu9IvCPxQOKBxLsS70q8J/GexPsS70t8IPGBxIcSH0p8JPGRxMcSH0t8IvGJxI8lfpz3iI9qxbYLzh4c1d3+h9nELI7tW5/NHKgF/4Pfpi3Qgv8+ArWEfv5fAZCTLbxe8y29QPT0zvrO21gd0RBqTS34ztca/kgMwDrS41ZxclBn0Tyr1BS5bce6WbHo1ytVx7byZbX6gvX+W6r2gmXdrNhzOQI+eEsVX7CsVytZNLnd8BaUfQtd2vZzn61Qd7TpRPlrP8jiM96ouGYdbXQc27ff9hZw7MuhjHd0hXwiyWlkjSqrV31bL/iWPuse8A85akHZak2t8ifFhxUaOYDtJ+C7mx6/4Xz8N7SN8ht6QZ3F6fGsYh94FfRgrgBX0Ptj1QP8SrSGbbaG8R7G7b0bFRu2SBH2rqg1FTUWTQ6eDGmvjgPhYS2E9h09acTqOo1s3kL/ttXApGBRaRRSC6iBUHjBqIaHwapXqaP8U8QXth3rRQffuoqHxdcS/uDDqPeandYqqyVcPdOFSdx7Zb5wLduhCcPeQ1xZdFHyw6zaglmhOarND7LgCrhy8rdesP7lD7N6DUmzH2b1gtpSVJktteXDf3KG6iPGbM83FKq5prZqu8ix7czRdQTKtqV0dM05qoRzohI0KbYx01x2Wx9m7+1Zf/S0qjn/eqvmwHf4GtPsRz/MVqxonl+gGZMn+itqAdaA34uXlCwPm1WHhsarZF1xASOLBpVDc4HNw0jx8HnXO6sW1JKylXpKt4Uyr1Jq6YmEe5sev3P2yXeun/qOXsJ1irpCnVNdl4CuRwML1oM9N2K5r2bek6pxlb0/Zg1Tv5ZV9fIrf+838e+f7odgmViX3SYtlha5NUOtbS4nPQw9WYJpZNWJWcKWrrJvk03tf2m/TvyTpXg4gPsZ7elm+/Em7hODe5t39Rr6nCt9Tq3tofc8YwREtmT+WL2L6mXdfFon45KV/dlM0nXBCPQtrZB4/MOsb2G+Rl/xLb1kGFm/YPkT623v7EVYJ7Q8mzukgok/m6yKfphFXzuLb1DqLJtuPMt2Vc+yXVWbZ/xVpXzrc557A/dv0tGXeOuz+rQ2QAvoXbWkca+zSosduFS8XHDLe84pM+juXVTQ0muY9OQ952sN5dAs5tuf1Y5a0JZyqNNRhjXKsIQMS6DcklI015/ddgp6oUw9so95D0tC1OoeMQL6H2aTW61NxV+08JRe5VAfcm+y7FLvwyxtvt+CPT3QL/hBFgxS5i4MaB/Y/DAbJFd0B8nh4ODept7FVSem+PMNveRbMaGe9tOrRJfooKFwU7Ya8WWhcU7dYvOQ6LYULTZqtXYZg5H6j7dqtAtGziotxFRtqK/L+oPbauokWpWVArEbHu1fkmbAIrMQdwu6voRZT5zSmS1clzO7777Dmxl8HO7a3vZyvvtvkG3M994hm+P49lX0Wfr26GuVUtwPDmnvjAT73dPTnGekuaekWX6modFXMugrLk9fa3S3bEf18Eew2rCqVjE77B7y1s/Ga7JbWuPX5LPJC8ISDCGmzOihmRMvCM6JBN/Sq+Zvegv+oGnD8pNvfz6Ddl6galx2LWqe3TLljcnx47NbmKgttYqJelUm6mjsJj9rJeVgbtzFpjhdzm7M6L7HvGALfeAPfpj1FnzrFp10Zx9mG9Slj0ti5Q+sTfQ2yKW9SuxMjZsWC/fYmBK2Gw3ufMa98ntQRqaqYZyOyLLu+8FRMkjL4OqgBze8Vb+1ybfzq36PfhStNcuGHszdhWHUZp4lN0o2nRXoPqFVBl1s/3i9odeoLrp2wfIPGjBljP2h3840MGUe527SXsx60enk6Gn9ZRwD1cKLznEOvPSC2Cy0/GlBTBVa/nFBTBVa/qQg9gktf8zBN0BgDn4huaxnuxowznv4ff1lLHMF/RU8hjCzyH5P7/JU4fChwCIpvAXI3sXc+v23qH0qBi/i5yu2WjDlBShTwuD/9Z/H+mHrCtamxgtWh061DjcUWT/GLKcW0OFgrM41+Xixc7mDxwe/xgeiBTIVyLnQFJLTO4DJxDqqMnQP4YIjuT2BScu6un5vk2yPHuGyYwHyWrxJxvnXKkuv8BZoz4HqLLEcqUv1VpU9q5NTNbUg3Y9MoS40YlbSdJ8u2yCswiad60eHhgiFQbB7myG2yJaqf/8ozlFIZvDCwd3NBB8k+ODeJvW9mLIBLIG4MD7pUQvcU7ssCLqgvghDy1+O4ldU/QhmnInpaHZarBMXLL/2tmdBqknsrESku0gmvWG1JKe+QjadycwzGXwOxPgzjEEHZBqajEQHQfD98JU//Bv//H/4/M/f2T8yOkXSI/bvbnrXAz6pwMxoHeXX1ZWj+Ien+6pu5ObxDScfcL7BnQ0tWMCfWhDgsY4/ioLb+LMDV0f6Jt3bsFnabZ40HunXaFaku08/yMGeGxnge1W9BjuWNwN1PYzrvZ60y7rZLutJu6x/1C7hKx+8T//2w1poi41BYrlAwgkDuUBiInc3ufLMYNk0BKVg1VwtRDeylgjvWH6tETXMOBfzE9cPjODptTpZqbhZVRKkt9l8zPfQRlEQo2IMIx0Hb7Ocm+3/x6UGJihMbF0KOtgFQa/zouXbWNW3uLqq/M98Z+5x9T1MVa0NfM8r//z+h63/cvaPr9/L0NnPH/1WVjZqyQqXdw7Ezw/6ZbywZRHD1J4cdf3pL/GS8kf2O77zKvmvsf3mLyfLSqVM+ePV7OO9Iv5+cDHs5VSWF+E8X4lGP+6kS7pJfkyckyVVkq5cMTt+YrzWsGN7b1NX0djTU4g16JdjYpkbgErsIikhnZGapuKJBLHxbRJ18ru5Jyk0/d3cM4j6cV75eERNlRQR9URJpxJVVVVFVYWMWDafIOR7RMjeX134f4OQo9+ce5Iqk9+cewYhP84rH4+QqZIiQp4o6ccSMquq8Qn510PDvSmYDd/dkJnl7+4feacUFXoVbEn+SZb3UNZld9bcCLxqHU/wbb+7AWYdMg1/o8yZSIjImxdGLjLkKEP/P1sQ+/qUocJyR/P4MLR1cwO88aqa59m1piqqdm/Tqx1681yhwbsDlQTvbcpPqKqqHXrVJE/VzCM1RQ1qh9FXIlfFzFXhkmDqn6vgZTf561AvlaUtpKrc3VT22777i/70H2cfNPwJkwV7Ir/5K0QIUlKsJrSENMZ3Nz6ohfZhTNc/dWAE726qKhmFwYYsi9P4KhvUZlIT+UFDKlcIjjDIVgGtPDyreOJ4pmsgKIXmYXV0FfugKiOUc17VTJPRXoU1JP3easPL4F3RmKxRqAtu6nG14dlib96fVBtePorArX05ioyqDW9OIuT/pPrR07C+MK3CsF0VcqvtfO2v2uBnE9mYhI7fXm2ojAiyOX5ntQGHSWLmvlJ3g1UIxl9yu6tX3BbqNaugrJFFpjccf5wna7U5ibbyOI2Ov7sRi7RQrZp5fs7Q1vTSi85ZCs4qjRcd0v3Euy86yxRsIljjDLkGuC0IDquNF50CW0IrwQUXTTcwL0Oe6iuxgWyWw4mXyQwvkxbsVJMkMrbTrhwmk6UnNEvIHKiSggRbpfZvgZsz+q2szpB7MLRt5o2KTbLYujJnlckuGSSxn6xCtPjEVQh+N9vQkKZ2T9Qjma2fWY9Bv/yUehRS9ag9WY9o7o7r0f7N8tPrkUx2z6xH768uPKUeNalHpCoBk+I56e1lVabhfMTWCvNJhHZoUcTxpytyXZdAsyeh5upJiAy6VymGUUDWzlcoeryCzkx3sHmveqgqR6dtJeoYMNWU/xQqaFZR1aM6HhRtVinalJ9pcbQl0TZH2xLtcLQj0YCjgUS7HO1KtMfRnkT7HO1LdMDRAaJV0avm0TReTcL/gMOD1caLzojDhcaLzm9KFsDDVS5wnKcCx3mOTjg6yWO0YW4Sq6lE6JrKwHQqzo5HbKUQkjxK4uscV1FccXw7im9zfCeK73B8N4rvcvwgih9w/FYUv8XxN6P4mxy/HcVvc/xOFL/D8ftR/D7HH0bxhxx/FMUfcbxpR0DTZqQVIy1B2jHStqNzX4R0BAliJBCkGyNdQXox0hOkHyN9QQYxMhBkGCNDW6UaaGSnWmgkL4zjF8aCTGJkIshxjBwLMo2RqSCzGJkJ0nRiYjlCrBhpCdKOkbYgnRjpCBLESCBIN0a6gvRipCdIP0b6ggxiZCDIMEaGgoxiZCTIOEbGgkxiZCLIcYwcCzKNkakgsxiZCdJ0Y/q4Qp8Yabnpxmu7qcZrywud+IWOIEGMBIJ0Y6QrSC9GeoL0Y6QvyCBGBoIMY2QoyChGRoKMY2QsyCRGJoIcx8ixINMYmQoyi5GZIM1MTKyMECtGWoK0Y6QtSCdGOoIEMRII0o2RriC9GOkJ0o+RviCDGBkIMoyRYebEyMtw42WEWPLCmMx8EbEEmcTIRJDjGDkWZBojU0FmMTITpJmNkGZWiBUjLUHaMdIWpBMjHUGCGAkE6cZIV5BejPQE6cdIX5BBjAwEGcbIUJBRjIwEGcfIWJBJjEwEOY6RY0GmMTIVZBYjM0GauZg+OaFPjLQEacdIW5BOjHRyvNzqKq/C2NdjcdY1XrMhCYKlXC/yCq+XeOHXy7wf0Cu8TdCrvHvw1sQJzzjfgEfoWCTJUmuqwma0KF5QqxwvKFl0Vzger7fLHI/X2yWOx+vtIsfj9XaB4/F6W+N4vN7Oczxeb6scv6Wy2Ntl/dJNuhmaVVBxYbBVWDuOvjWv1oJkZ9TOq9Ug2Rl18molSHZGQV4tB8nOqJtXS0GyM+rl1WKQ7Iz6ebUQJDujQV6RMpFEh3lFilcSHeVVNaCdUU4OKdH5wx/ON+SgwhL19MurdH4c5Bq1P81t3FvV89go/34WUA32xGuktXYZ9gAtPxiVG7U/DaXPWoizX8oHEA6Jl93Wr2x486G3oOZDVX2l9D8ePbxW+kv7obdIDS2WyKC+49lqAXtwPoZ5cDYVqfxYfsc4nM0oLzTta6G3FKp0SV1KXcLPxe87/mCBy6+k0OEC502jPSphntrcq6aSRgvMGKic/NWmJBi1Bneltdogzb1CQxdAjANdvWD5g/zbngu9GQ+dvgEOkXMA8xZvGjvwv/59Lzoe1wYhGb/w5hPpvn8XR5ha4ilTzQeq+u8ALNBQqv1lG2WrvLQvycmAaPHpJbyHC9h5+tCqmgeDItn+G7v9TW/t0Ev2/yPcflSVHPX1OrhY8x94S6p25C3EeignlFCqav4QGRZPyXDoLadOVYtqMXG4CF6zXlKVV1742bO//8MXz+yH3oqqqAX8T+d65U+8+A9+6kbrH+6H3mqolozoglqECuaRwXdaVQtAvAW1AEf3i2pRreCDcCUDcno1IkztdMKQaAO6mqoeRuwgy7LueplNrxY3DhGsRgSroXyjLJXZhMCGSy2VjQanC2OpUcPponkUu0EKuWvY6Bf4tac3NatUHXkbrHqWxZGgcuRVWf8sixNB5cgTJbQsDgSVI2+BNdGyOA9UjrxFVkfL4jhQOfKWWSctS6eBypG3xJppWToLVI68FdZPy9JJoHLkrbKWWpbOAZUj7wzrqq2p+UNvXm2EpAcQsNravKpS/HbAyms0nUCTIGAVtnm0CFQNAlZkm1eLFH8YsDrbvFqm+KOAldrm1VLI6gyBqLbNq5VQtKlEwW1erYasFhGImtu8OhOy6kRAR5Z1VTkE/zLU4HDVQo1evxBqtOViqBfgbDzUi6qilkK9DP+aIbqpWg01+ueZUK+qitoI9YZv6TwpmHEz0UJHQ9/LqA3lqrwsIV6FzGHxbJMlNwrECEuhE0KrJ9BjQmsn0CmhCyfQGaGLJ1DID2RoITXRFqFLJ9A2oSsnUFgJztJSTdMVe2DAepn3S6wiqdbp6HdqFy5G+l1wKpUn3UKaPZ9YtyJNMC9LP5XMmuJ9rBZdwp1MmZ2agrn96SndxdNSmkunpYxPTektn5bSWjktZfL0FFo3sJWqnqIf5PhN8g98anLr2cntZyd3np0cPDu5++zk3rOT+89OHjwrOZvWOKoAMDWOqgBMjaN5AKbGUQ2AqXG0AMDUOFoEYGocLQEwNY6WAZgaRyvpvhySLDJYkVkaKOzXzZT+rwS6gl5hahtUA10FZmo3zAd6HpipTVELNJnEMJU3FgK9QH7fDGwx0IvkHM7AlgK9RB7kDGw50MtkhMPAVgK9ku61oVoN9KpwSGVWWDU0RFZM1YhlM7JkRhbNyIIZqZmReTNSNSOVE5ov2ErPa+KG9udl7zvP55vuPJ9vgnk+33Tm+XzTnufzTWuezzfNeT7fzKokaIabpMvu+LsbWAlnVbpYmsiNyUrdbc4TcizIct1tMTIVZKnuthmZCbJYdzuMNH+JkYW6GzDSEqRGthmAtAWZJ9MMQDqCVMkyA5BAkAoZZoDyQ/eXNmIdW0S/u9HARceweoV1DyjuT6sNuQ6x/CFDxwY0YGhiQH2GxgbUY2hkQKiPqsiOH+GqqFwgHN3iIVzjMOigFjgMKqlFDoOGaknUHxBeFtUIhFdEbQLhVVHRQDnZ6CRk+cMWqgZOuahcSHwavSvxmcQnEm9KeRBRgO0A+aypRAscnUm0xlHcOyG6Lrdaq3Cq+L9k7E+9x1xAXWLOoy4z6xOObsjQWoVF1ap04tDzLJhSY0YhhB7BnNSLzB3VS8yR1css5rZCx2q9Sqdfvca8RL3O/Eu9wYxTfYaZtnqTpeHO0tlbb9ERWZ9jdqM+zyxOrZitqjXzdbXHsjEX6ICuL9I5Wj/HHEn9CeaC6k8y51VvM+tXX2J2s/4UHeP1ZeJu6+cVexj2XDrNsyqYlyFWd0ieZmteltnSHF33csw55qjy8szP5eg2zF2QRzqK7nhF5oqyJymyNBCqjHo+DFRWfSoMVE5dCgOVV9tw+KI+GQaqqD4Rkpk45L6I3M9R7guU26PcmnIryn2e7fQh9xZyn6PcZyn3JuU+Q7k3KPc62+1D7lXkXqPcK5R7mXIvUe5Fyr3AhvyQex65a5S7SrkrlHuOcpcpd4lueMv/yZztPFasyMw3zrbYp2A1Zf59W+xTsBIyf68t9ikoRPYpKET2KSz/4G1l+wdvm6WSlQoKkZUKCpGVCgqRlQoKkZUKCpGVCgqRlQqLOwVt5S1uZtrEWzwQaPtucf+mjbvF3Za2mhb3RrpfsLiT0c0CS1PbdKcgQtB0m2DxeKF7BIuHAV0aWNy76brA4k5LFwUWdyy6IrB4oNLlgMXjj64FuP4OXQhw/R26CuD6O3QJwPV3iP3P9XeI8c/1d4jlz/V3iNnP9XeIzc/1d4jBz/V3iLXP9XeIqc/1d4idz/V3iJHP9XeIhc/1d4h5z/V3iG3P9XeJYc/1d4lVz/V3iS/P9XeJI8/1d4kXz/V3iQvP9XeJ/871d4nzzvV3iefO9XcjMUlw24nPzvV3icPO9XeJt871d4mrzvV3iZ/O9XeJk871z4CHzhovowxM2+AJuRjnRiXqVxniqvN3ZYifzt+VIU46f1eGeOj8XRninvN3ZYhvzt+VIY45f1eGeOX8XRlwyWlzAJ0B+ModZVilsZVhczt4JrIGLq0SNQ4VrvDovOT2Mlfkty653cwVqcMlN8hckbpdcoeZK+DIU3iQuSJ1uOT2M1eobtCOGmXKQtgMuPFMnE6WidPJpokzyRB/ngmeIc48EzxDPHkmeIa48UzwLPHhmbBZ4sAzYbPgvaeI0MkyESZChMlJIuxcIYPX7iV3+wrZwXYvueoK2cp2aeVcfzqx8JEd6Dfiw4Y5/rBhLv1hQZYY/dyiWWLxc4tmibnPLZoltj63aJYY+tyiWWLlc0/NEhOfCZol9j0TLkuMeyZcllj2TLgsMeuZcFli0zPhcsSgZ8LliDXPhMsRU557ZI7Y8Vz/XN0NJNzN1d2uhHu5utuTcD9Xd/sSHuTq7iA3b9B/iBjcK8N+UZBtRDa+iX7DXLn8X205S49r712AzDg51YPjlULsK2VQaHhOFIG+cTaK9JJM3SQYFEzfKp2CQ7rFg5K3jGe/5K0mrMF7VMkRC+mD5zzm4IrKJLJNy0f86rAUioXgZbUSivneZbUakgFgy58kxRxHxThqGXs0ipIMflZetuJ3e3i3WZYXLEjjczEZencWvTss0At6lUrQSBsW47cGHIQcfJ+D69gGcxASbF0Ogu4BBzdJaquoz/L46JTiwoKSFGZQYZWoAFFaro58/Voo5o/5szr4mHFcLZjI1GtChUnxFCqsRVSY8otb+GwOnhMqHBcTKlhcb+8syY7hDmJGEmPzGN/R13mbiZEvC5wISmMieGfMtLakMa28DTOtI2lMUm/dTAskjSnvrZlpXUnjBvJWjDQo4yRW7ZbVOW7RrVAvw2LnuCAHhwy0IuRsoehTB3LdYkEsy3NU6gtHBKU+bExQ6nsmBKU+45igVO2nBK2kCEhSf9ZlGLU2acewaHikKCcp0ydSAkmZPZHSlZRm8WRKT1JaT6T0JaV9IgWLENiW2RedfoZi7TJpeZF5bQdibxmVgT4KxN4Q7GdI7A3B4wKJvREvh1Vqy+Dj0igpgw1pgY2dNb6p3PDyQB+RlFX0PWUw1ixiaueMjynDJJ5FvO2C8SVluDyyiMVdTOBBueGVqMfbZJtO4GG54bF3eZukvKJuAIc+ZBnBJnmwqCuU4RDdIgGYitEdyg2+RzMNO1v+cRkW9ywShZk3ukW54dVoIrRVLYFnZWiAWSQMs5DAzbmGt8j6qbByFnekOaiZWSQRs5T4bCo0PDe+3ne3Hdz1e8Rk5+15INJBxGXnXXog4kHEZufNeiDyQcRn5z17IAJCZMeIt+6BSAi5RCXawQciIuQShWgjH4iMkEvUsRODrwQNRFQoECkhl6hCu/uAtvcEjURIKBDRIJeoQXv9QGSDXKIEbfkDEQ5ySTiIdv6BSAe5JB1EB4BAxINcEg+ic0Ag8kEuyQfRcSAQASGXBIToVBCIhJBLEkJ0OAhERMglESE6IwQiI8TaQXRUCERIyCUhIToxBCIl5JKUEB0cAhETcklMiM4PgcgJuSQnRMeIQASFXBIUotNEQMeJ2IHZdB+bKxqi0VD9bzPJWB1wGMG/nUkGK22IaaAmizuN2BQLn8BIFDKNpRjggrEfrjTGBqjTGBuNTGMse5nGWEQzjVVoPKaxKg3GNDZPIzGN1WgYprEFGoNpbJEGYBpbotGXxmgOPDEOSTqKx2CYjEE5KIfJEJTjcpiMQDk0h8kAlKNzmIw/OUCHyfCTY3SYjD45TIfJ4JMjdZiMPTlYh8nQk+N1mIw8OWSHycCTo3aYjDs5cIfJsJNjd5iMOjl8h8mgkyN4mIw5OYiHyZCT43iYjDg5lIfJgJOjeZiMNzmgh8lwk2N6mIw2OayHyWCTI3uYjDU5uId8csfZmPaPxxX2y6JpTzJwafM3rYi39DWa613aSM4qdD9AW0kcm2kf2ayKL3XaSY5dfRYTfFXc2WzRLO/qc1h7q+zvRZ8HeOxCX9/vQKoeoAY4dbVHb1T0BayoVVnIZi4vZCeHl6d0cHIYKnU+ODlcz6mt4OSwPqs2g5PD/4zaCE5OE+tq7QSWVStq9QQGA64XUtikwmMJS2ylwep0Gb9TaNS+yGcQvUxzmHI4X+3flktcXGnuPvCyUIwZ0JWhZMxyQ4XJPoIFTJAhSz6RcmlBEkmopRLGScJ6KmGSJKhUwnGSsJ1KmC5g30UJO2Gy7UrdyJLdj27Vy/q7pOoz2GjIFhI7kZK3LILlQ8aPCypCRoxMJaegY0ZnaXTCaLOYQo8ZbaXRKaNtE7VI7OpFp1vlJaRHu61elSWfLG4w+ltl6SerBp8G0wJY6R8s29nHzPtgfryw4v8/yOkkbfMmKQ/ATKzn4DzepFt1pxEbEsaFuJdpwCOOCdaeBq4/DVQNlOwkYM7PNryc/3cs6RP/v2d+SP1zZD6a65+ruyMJj3Okqcr1z5EyMdc/V3ePJTzN1WEQneufI/cAXP98HYo9XP98HZKAXP98HWKAXP98HTKAXP98HQKAXP98HdJ/XP98HaJ/XP98HXJ/XP98HUJ/XP98HRJ/XP98HeJ+XP88KS9w/fOkucD1z9dhp5zrnydnTFz/PHlY4voXyG2S5bcK6HytQtRHLL9NSNtAOoR0DCQgJDCQLiFdA+kR0jOQPiF9AxkQMkgQ+t4CMxfo2G2LSQI5PREyNpAJIRMDOSbk2ECmhEwNZEbILP27zSK5h6KzLWhSNGhCSNtAOoR0DCQgJDCQLiFdA+kR0jOQPiF9AxkQMjCQISFDAxkRMjKQMSFjA5kQMjGQY0KODWRKyNRAZoTMDKRZoumplCAtQloG0iakbSAdQjoGEhASGEiXkK6B9AjpGUifkL6BDAgZGMiQkKGBjAgZGciYkHEp1eKTUt2dlJhLGJsIEcoQMjWQGSEzA2mWiTJlgzKEtAykTUi7nPrdTrnudsrMrQBNjPxdQroG0iOkZyB9QvoGMiBkYCBDQoYGMiFkUk7u4ceEjBMES+aofMUdESsdbrJh8Q+seg6mGerH5TocYxM7ArQyfmtGyMxAmnNEqzmDVoS0DKRNSNtAOoR0IiR1mxDMMbcUPBIy8FL+f/A2IZiTBbI7V3e7c0SOcSUmBwfT5OjN1d3eHJqHKt03PmNAyMBAhoQMDWREyMhAxoSMDWRCyMRAjgk5NpApIVMDmREyM5BmhRqjYjQGIS0DaRPSNpAOIR0DCQgJDKRLSNdAeoT0DKRPSN9ABoQMDGRIyNBARoSMIsS81xhX6F6jR9/Zm0vfa4wr5fI/PONU3ys+ZoMlK1B1VpkXYSuKkfWL9DHnGrCD+oLVLHtrZOyLpwhI5L3yJ+nfP9kPDdF3r1h3p8Qh30pmj1NzC+XPJdPKj8naOpfMNz8ma/tcMhH9mKydc8kM9ayscYQG2Stv/eSf3PnU3/hZMgdUOGIpjBozYT86Nx6GKCp8Kr3SZMqyHoclc1784tOpZxAtywoflkyNyYvTZ7zYil7c5nk09eLsGS+2oxd3eLpNvfhUOhvkzbKuiSXzcfJi69QXs9EZg2dueqsModcwXjwQO/EaHVNhMNBbbnh0UwejbJaGcC78cUFeJsfspGaRnRbpvFpWOZU99LLCZ4oS6Gyp8nHCFAnka9PL441IzP3Xw9DL4sovxy96OcOQUkFlVeHuppdVuQ84cm9T5Q8lR/3gKODic6oYGEoNWRgWxc9nhQkd5CF4nEn4YvWDXxNzoDCkx0ZvImOJ0y26oCqSXk4ycmt1dwCTCsPNhhz7aBrhmJIplmPbMr1ybEemVo7tyrSKWHwOLMe3cWL35r/gkRHHgiMve0guRzLUShlppSV/sAmbZ1my4BaqHDtOqzEtw8Aja75L/myzoXJkPjj3/diMU0jNofKH7wehyh55+UTHIJ/S48bvQXRbDIzhEH1WudDQW38/iO2QTFN1/rVfP4LFhtyhzqvMC1bNWyJC5tEHcdTfBG97s0w2K7JgeoHF1D/bECeACgUresdvnkXXoTeXYy2Z6L0+3hvE720b77We9d4A7w3j93aM99rPem+I90bxe7vGe51nvTfCe2N5jxveeDV41qtjvDqJf/KW8V73LDo2vZd54r3JWV5+yIxRhhtH7KVQ4whjKulLozPoS9SDhoVoknhf3vkb+8GRWhJjdScTDt/ngbhu2ssoqCXYrvOWIHmG7ujl1KpaJ66XYaFFilO5u090NTHH2yQZxnE0SjIHId++tTJeNsQwp5XCSA7DQOfF5mI0rLvnGjQ8lvydBw303UGWZ0T4g0yCPQ6aGmmEj5MsoyQ4fDK3yvMcHE8tbN5sCR15CwY+prD3AeFJ2fZRQ06pefma8PislzVEn4vJ5BCPz+z7WAD5ncL7pDpUCg+9XJzZSizXqcymVw5VLGHdxLTwUS3hIitUZZUND70SglhWguD7Xu7IK8NsTknljrw5VQhh54G+uKiKeK1A2UpH3jziWVVQeWTNQ2EJ5XnlQ1U68hbCQ51TWTUXenMqr4qht0h4CUUV1HyIuWHho9JIvvBQF9SimjvURVVWtUNdIqsvusx7ML3hwhZgvDpRd1fL8HlMtivLYbTSqKzaUMv+bgP5zpDPLzNtlbRb0OlUkXVFl9VaXCCVVTDzUwl5E6F3c/yu2cjl6MBWexHT/TrJN8vOES6manvWd8tqnU2TEWLtwYoyeRDRMLf7e+//0t/7C//d3/+Lr15xO2QIH7JQZNn+QEzkektsan0JhkeXybrqkg+LPq9lDl75vf8gqP+p65f+Dhkqc2FYdglGSFdPJGDaON/QtiwmtnJjE6JkuzhHkGNCeYJsEyoQlMSLNA6LtFhHi3ZW5eWZu7upoY6QgX+ADCySZtQqiMZnrscvwvo+wstknzQxoSIWOmFmyijGRjFssE4tE+39x9qJC2LKdT7kz12K7LTgqzNkaT4q37MbsVHQlOFkx7fegEFMlWFzvZnIrhUZcb7BluNd/jFXO7HxlqWoIzwWJwGwTgfb8qnG7X54srV/kOWjxx/98EQKmfyGuFP/5DstcjtgvWSftBNONpmpOi8ipFbIejPsoTIhVthW84paiWw1i41m17fUSm0XKWKc2YXchCt97w3yXynmme3I9rPzlPLi1uNycVX1jHJvEclWaFyUv7fkZB7nIDK287aXvYiWyP5ZDRsqpT+rcyJYXoxst4vo4VueU81alu06kEz0B79toUV1XkTKy3zPyBLwPRt6Oi/bOMJnlbNnrRuLkSoexuaLE9DZVEVxofZb+yEmWlUytkqbSdiBESuxOvnmrwdQ8JyLzzqv/JmtP/n52i+eR4GhN3eYvFbGi2VSPM/ig95/a8+6xMEP3tqzPkUGEsgqAp5Zf71R+7IqpyzrZF9uNjP8TWUqx6dPe8qLZQUD14pk7ZC9yNkzp2SnkpsF8DSyqgRJ7yyWZOtEXsrIJb78h7/1d/7S//x3O939K1Sye1rJ3BpF/EIuVRf31KrnzKrzJ2bVXGImFO8/7cXIARdMV8dfXuJfs07/tYqbUqOtuEyNZlNxBSyuQOXHVgBG/flzS9yq2ok7oX+iE77SP/fv/f6f6P+1felID/e5e6BzJl2rRN2FOgstsg76SVbl0HOeUgEaKy6bV//gLZrAYjpIh7FPoQOm5bxBN86YjTvg8ulkV27F+eP0tH/dHWjOKTuP/RMe1WDW64xPE9r0rGfTJHkGfiTeoT2kSw5OojU2NrlYTNyDvPeOLpxIiGwxim9IGytsVxwM014LmPMUzH4KlgKK8NZDbuYyMBKQw1qaUwWxwSirZ/RO145eojdsvCErlWxZirG6+d2y0Sdf/j+7/f/6L/6jv/a/SxNkuMk/7twUt6QU89/8uJaMJpltlX0Fp8fl//Tv78c1U87ms3sose4o+fnkN/9z+s2n9sosW//PvvzB3/yd33z/b/7OP6LDCg3nJ+e1Obt8cgM+2o/N00rgL+4zbTyYgKd9hPOa527CjO6rXm7TmztUxWjw7h95RWPFMU5Cr/wf32n87a/9hftJ8crdDL3iobGt/wjxKtgd01RYin/fXISMpYVWPsn0tf3QI+uir24e6lJq+SHnp+VyMie53OAlFS1Lzsdodgu+ebSbjPg5ftf1rZs/btD/uNnBOaBJqJJ2Bk79ptVsDtJTU+VjTE08dbLdQzQSVge03A1jqov60m/8uP4rhWGdiQvy7VcrTzZA8YkPcD7W1BX/BFU3/g3n4/1G5mOur1l/B7uwX8k4zns5MLjbFd6GsQhDLJ8pwEEsnSliEbdi2UyRjngzlswUIYnbJltYxCXumJgITtw3MRGheGhiuyIAYWIHkdKXCd4iZx55UojO+6UHKsfe0vNwwE5hZRNDAK51fffzmfeID+BklVM2RV9WxC+vDaGHkhzrYa0dxlhgCtP2Sw+wGrEPIlI8hKsAOmW5ygm149tGPVAK/HNkYofxJMwQxXCwzkhdOdFOYh8tDEGgHZWHCd6oagWVwedxCcphiaiMKhpxYa6QHaIscX6I1+kQr9Mmfywi4pPFXQ26QsnJPi5gQx443BWysKxg+W2H7JRmlZsISHlgEIBB33G4t01sfnZtI2PtIMn4kNN3+WEpJ57QjjxHTLd8ypjcbMxewnj6W/vK3qSSQl2kti/4Ow888Hr9HayKaIs8y7wZIk4Z8AaQmE+LV4ErF+G1FD604hfWUwmjJEGlEtgGByVsG8YuCqBwwc+JnwZYd6bzkfvKu//+5+/9jnNzP1RuSAzSGpOI5JMKsMsbstSc5ZUVcWfceJHAO3BEAPO+9JyTZ+nuJrgtZbxaplJ3eDCBAhlVViUUa1rjgHySpBTJipGRMrSilyyoyrqhN59KH5npKoQpJiN1bKZu4xRlprJ1kjnlpFC2TlI5gU7FkkkanYnVkzTK1klqJ1C2TlI6gbJ1kjmwtAy0Y3Md0mhgcx3SaNfmOqTRntQhjfalDml0IHVw05SXOqTRkdQhjY6lDml0InVIo8dShzQ6lTqgFb109WZPJUbTeRoxWs7TiNF2nkaMjvM0YgROXJHtExXpOk+rSO+pFek/tSKDp1Zk+GRFMBUGDqbC4SedwuMypsLJS297BZiZEWvRiVt3GrrsA5rMKNCoY/GGsxgRGM24ZeTkBbivqMFs0QJZj1LzYRAcBV5igcIwRnFvU6+qgj9dbuiSKvjDpYauqIIfLDZ01T1QBZaZUkW1WntZFfzWIoT1iozXflYV6Aaq6HfcB1BpKfidRRbUqKk8RAPLquC3FyPZjbwqXHJbixT01xuqGl2C59FHyZExR1WJpCBaLgfXr0Ddl4K1K9ACpmDhCpSDKQg+FYKFy25nhXSAxe1Fno2Cz4ckX39EDVIEu3cOn/BSQ0w55GEPYP6jatAViq4B2NULeOzoRZpw9TJNyHqJJmzyz1QmAoEkZV4MVZldMedJcWM+RNaRjZbIk8LHAgUGNkxG5UlRZJkCPRtGovKkYLKW4vvjHwkwY44vR0uy3/7Jhpojgl92W4ssfVy47LYXsehRcLRI6sYUHi6SOjOFB4t1JmvhsttfJHVsCvcWaX2lcHeR1lgKB4u0zjJpF7G0UrC5ROKKFJ4tkjgkhaeLJG5J4eNF0mWl8GSRlHQpPF4k7WSu/BKJKHLtl0i0kH9qiUQC89T9UI0l3jNNONpd4oa0G14xvgwpOTinlvz8Az0nNCpFe6aanlclWs9raj7U87Jn4lx5P//AK/t5WnbjrRGn5VQp2R4xVFTlE5lKCQIDNwF1JXMP5U/WMUryD6Q07nUCq7kEg31w+Sos4yWES/hCl9VLZptEzXUo/6wD8tvnuSKX3WADqjcbhHa9CJ0AnTA6eC7OewZ5zxA63o7zAp0wOr0c58WtarBJaOszcV6gk03w+W9WoNnAX0OjSmVrr+iVuUzUVYvRlnAeW0JyBFxr6Og6ePojPZ+ojv7oHrHIT5SmMoGeR3HN+Qan+S2X5op5GYL5OBGvYNrdadRuQAthlIPFR7UArwmpX6mpBVUjX4fz/GQvorWycLVqegW8mAIpI6d+tEC6wll+tuXZkmdTnrMMP6cZENkxtreFmDE3IXuAC6HH46OgeGzQc+YaGbG9pYzLNJYLUPVsyXPkyDydj+sKGhT8aQZ/Rw4Igako90rwo//w/V893BwEMJKoamrp7qa3kiLKiqqpFSLKEj+ZKCswLijEpPNfjuZWlpPIi7kOCpEQO4VIiJ1CJMROIRJipxAJsVOIhNgpdIDTFoVIfJ1CJL5OIRJfpxCJr1OIxNcpROLrFCJDHRQSQx0UFkMdFBZDHRQWQx0UFkMdOZ6LaebL8QRNCkY5nrVJtSjHUzkpFeV4fid1ohxP+qRIRGEx1EFhMdRBYTHUQWEx1EFhMdTB9WdDHVx/NtTB9WdDHVx/NtTB9WdDHVx/NtTB9WdDHVx/NtTB9WdDHVx/NtSRQ3/xijANCE9k0sZFuk9EG1OI2phC1MYUojamELUxhaiNKURtTCFqYwpRG1OI2phC1MYUojamELUxhaiNKURtXGTDitTGRVb2pDYuspYntXGR1TupjYus10ltXGSFTmrjImtyUhsXWYWT2rjIupvUxkVW2qQ2LrK2JrVxkdU0qY2LrJ9JbVxkxUxq4yJrZFIbF1kVk9qY689tzPXnNub6cxtz/bmNuf7cxlx/bmOuP7cx15/bmOvPbcz15zbm+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Mp4j574O5ZA1f6OmtbcF9nbQvu66xtwX2dtS24r7O2Bfd11rbgvs7aFjxWWdsiByNd0LpgLh09FD/W+VHjR4EfFj9Y+8YAbvHjTX7c5scdfjzkxyN+wIIQrRvybMuzI8+RPIfyHMizL8+ePLtROY6UK8+Z4FN5HstzEpUn+fry7MmzK89AnmQFaFGs+CyKhaBFsT60LJaNllmNaBkDfgmOY7HgkgVgWp79kQMLmSVapmiKUaXaq8JBy7HRUWj3dRw9j636BC57ynTRuoDnQ71IO3i9jMeuXlIlOnnk+eRBarZkkT9Pgjhlf1ITMwvEGFBlf8zAKvMRVNkf1UTmyCIGTNkfMpCh0xaAQU3MOFjE0ylj18I2H3D8OrlPP5TuPq/WQlWDsawFiKQsqkyoltR6CLmSk+8kFjQl9GcOQnLTQrxObMeLtZsRq5Dl5Eo8LysipUcGynN+J9fwyChZJmQb5WSULBuyBCzZJKvhVEhyrWSTbCFkWVWySAYLXiSASgbJ2Fr1DpsjWwzlBOIqEvbaDVkw6gDfCN4siiUDb2/iM8UKGhmAuyOGqe9zEYWoiIdSxCMpomnHZbRsKaRtR6V0bCkmsLmcWlRO15aCeraU1E9KGkQlDeOSRlFJYylpPSppEpV0HJU0TUqaRSU1naikliMltR0uSUUldRwpKXCkpK4Tl9RzpKR+XNIgKmkoJYFRXSInGFZiA6REPjDQC4UpXiIXGFbUUQg4JmBdmOIlcoCBvi4c8RL5v8BooF8p8Rik8Uh/a7dYeXGHf/4wZumJJyCqw2HMzkvQSYSClZfAxxE8SsHTCB6n4FkET1Jw0z1MmHYJ3IrgaQpuR/AsBXciGHy7BA4iuJWCuxHcTsG9CO6k4H4EByl4EMHdFDyM4F4KHkVwPwWPI3iQgicRPEzBxxE8SsHTCB6n4FkET1JwM3OYMPEMekfwNAW3I3iWgjsRDBaeQe8IbqXgbgS3U3AvgjspuB/BQQoeRHA3BQ8juJeCRxHcT8HjCB6k4EkED1PwMcF0tn8Jsncr5T+ac3J8qQGj+mSYipbXPD978uzKM5BnR57tvKKlZ3LOmyN9TuJS+tNztOaUQ9LrZGx2Tix0E/OEseZ5Nqgasp6nf0x5dAlS8hbOnrMsnT2JXR5il52BrMqbaJDzfDhXYH4i7Y4Ca3NOzYUwVhEG3/fm2OaCJewGDRs4Vcp7n36/xtYMuCodrgpSx4zhdgG2K2B9v4r5kFhyxKOkHwiC0CuRQitVqi1PuDHBE05Z8GzJk3zmZPxprsHXJbXXlBNbj3Ri65FOrFPtxDrVTqxT7cQ61U6sU+3EOtUUoqOKE2tTO7E2tRNrUzuxNrUTa1M7sTa1E9uNdAy7kY5hN9Ix7EY6ht1IJ7EbSW5JeCIhTWyyjIZ4IdGaztMFmldsqIIqmmCtgfxZVUj0q11cNf4tct2On4GAyovO9CwMkp9tMJe59gJu9Peszlt8k1S7dsbkR/OlUXAeciBq7t6mN2fIDISM3t3UiTFkPZcES7gcJ6mYLIsOZuGZ1HUeI0DeccF0ycIZKaResiL1EpEgG0mzwJbELvEQ7YCur1QWuNzN7fKRX1JKQaBLEIpq6GzkYbQoN5IrD8oQ/2S/3eRABbYTcMdIdmqiAnSp/K88nssynknLYXqOBu4sBmbnaNTSSCaged6bp2GMT39y/EKYm8p8kwZsmQYzBNfPy7AsyxCu8QVACWLVMn4vu+3zeoGGd1kGb0ktRIOXDUedp8lmzEA8aOUewbhYAGH+749c9wAX0tyvvbykZXkCYYYouVTPoZOQM1AEcdOc8//oRz/6UZ57CW7K86rEhapsciF/meWrI+7sIRWaymq/6zkn8zsn8kvPKaDnFLjnlJWFen38Hy0beXP+2GLxq/IR/8JcLP0JHyUQoQfb7VDPpWQDlA3pl/5bUET8bashMpPsnqD81z/tvPjeIslXFN72rrOz1OC8dnm60azypXfY0yd8VeyorHEE8bLwkXF3U/8kdBj/J6uhX1XX/WGmoX9WXfcn+YZ+RV33A7ehb6rrfj/X0LfUdaz9+jV13W9nG/qzySjfcQ/wkg1W7MvqJ2svI2sGV0kvM177WXUdRjpxpxxqEUdXL/tZKEutGwbzp/t3IWj9gvX3z7Az4JdpjF7Ffg/fpl72+4UHDe8laELwksc//JIfQOex9jzocFtdFZVtdRVWHkLSVsDyc50sZ7FI20t+52KD3PCWlCvSuR/u0z04X4aX7sWmYDYOQs9Ny8S46rrfzFLdLK8UePnaX7d1Qb3kd59reC8l4lmlj9oWclBHQeIzxoP3zqzKp7D8oVeAL5nYU8wRrlVfik4G1w3i4ouJuCCsun7JndrEkr6K8LF9hbJfv+RObOJMf1a9Ft223VI3o+Ar6mdF/ZhCpH5MIVI/phCpH1PIkjLZ7GqrQP07DxKpwvsfpKpNLOSSyiqijHukSSz/Ogyzei4Twz3yssanY7olv1EPSd/uIXcWnVWOtP9LysU6/ZIiFQrYiH2LXEuj+7tve3sXLbXnT52Gvqpe9V7C4qFv+Jb2uR9612COpE6C30uqLubI62TLfAXPlq1X8WxCqaYO4+HreDzUG3jc12fwuKM38bitz+Lxpt7C45Y+h8eBPo/HrlZ47GiNx7b28FD6Ah6wRF6HFfPn8CjoT+DBq91V5dOd0A3l82JXZ/0Qygh73/Sieo6AdVj9RrEw+R1Q0rbyCNohy9+oh1IEHKjz9LwFs9+S+U3YAcd3kBFwfJfaJOA+vNDgq2ELnPM+AieD6AI2BxFKrYac1rbh2YaIiYtNoi6sg0eXmD5mMt/P0Ey2h/OL3lfX6HhzlTkvvK+hF+GkIsOFwXpphn8Ajiky/LMh2TylqoSwPUq1C/U6hx6GeoND90N9hkN3Qr3JoduhPsuhN0O9xaFbIZkPBY1CfZ5Du6FWHNoJtebQdqg9DqlQX+DQeqgvcqgW6uc4VAj1JzhkhTrn29p3D9RS1LL8vfWoeQ+Yv6GXYMFJHdBXw4nFCsfADtErapVjsCyvV9Uax8A+0WtqnWOPwkCvqw2OPAwDvaHOcOR+GOgzapMjd8JAb6qzHLkdBvqs2uLIm2Ggt9Q5jtwKA31OnefIQRjo80pxZDcMtFKaIzthoLXyOLIdBtpTFziiwkBfUBc5sh4G+qJ6jiO1MNDPqU9wpBAG+hMqxxErDHQu6ix8gboP5mxgq30wGDt4rtCOeR/GT1t4rtHOeh9OfR6pfbWBKWNfncEWZ19tYj+0r85io7SvtrBz2lfnsKXfV+exx99XCpPJvtI4BewrD8eCfXUB54R9dREHh331HE4S++oTOFrsK9JZ3kvm9Guic74HHkcIFdmurfYUAS039Ap0iyBA0yU5tX4MzJzQc+n+4SVs2a8qFwVaYOFdjWb7lzBlXYP8WUiJAiqAhTTIypsvRQyjPfzE0P6AqozwCGHBxwjXODxBeJ3DxwgrDk8R3ubwDOEdDjedD0A3CrcQPuBwG+FbHO4g/CaHA4Rvc7iL8B0O9xC+z+E+wg85PED4kdQf4aYtH4BISyJjRNoSmSDSkcgxIoGt9mj+v4r53z0wJlVzNObwgkXTFlOxrggq8KRLhBSoRhDz3gTiWZG5bwLxhMv8N4G2CWIOnEA7PE+TCJ1AuwTtkjiqQAc8eZM0qkC3eB6HLGoEvUkQezIT6DbP7OTMTKA7BLE/M4Hu83RPLs0EesgzP629Aj0iiB2bCfTR5MNTMFtcFbRly9LARlcFbTMa2V0VtGPLksGmVwUNbFk/2PpqeuXACNMysHSexxNts3YwFDAKeEh5RepntueyXuVLYGdKhoKKwYO3IzAfgxg7kG122VPnS8TFlFxUas8odZikZZNix9bTfmySoMmvEXszLgFjwCh9av5yjM6eWjo4nE+W3rLTpQ+M0tv200rv2E8rHTxOooxR+p7fdnH4iFXniJ/g59+uli0n+mc7kM+5FtuHgqsVMczF3lZmOfa2Msqyt5Wxze5Wmq5+np0b6Bdie1PwMiOGvvSn2f6Z/gzbgNM/Id5ifopdRuifZjcJ+mdi+1VwTiOGw/SLbElNX2FrcnpXHNRk2PmEOKrJwFFNZBu9FhsiY781kxw7ruln2XPNwGbPNcfiuaadgeeayJz6AixzFMScOll3Y0c2vSx7sunb7MpmErmyycCVTWSBfZENpLFXm1GOvdp0s+zWpmezX5uxw45tmhk4tpHd7lU59xSOPBfPKZzVRZbBaIk5ttkvzTRP0YnNfmmGOYqObfZLE/B6NLK9Mvu0oOjQ9ubYvQdFB7ZXkfuZk6JsXs5wYQrfe1kShftok6oK2LEWP9rBqvJH+1s1h71tRV18sohFvuIK2AMvioBYHXashY/2r6qIzWwZu905bHUr6tyTRfDlF8/fXARE9LB5LeDeroitbRl73zk4h6yo9SeLYOeqPN9zERD3Uy+iiCsoYhdFLKOIJRSRebIIvmfj9YGLqKKIT6OIz6CIn0ARP4MifhpF/NSTRbBHWF5PuIhPhuQbSBXUJRTxKRTxAop4HkVcfrIIviSk9SfZzKCrcE+pKffo+8lBLjyiG1tbXeMVlBbWZFK4qq7xcjqwcV7ORXNEL8nkwvspo30TXYjQgYnWInRoovMROjLRaoTiqoOWf/I3yug1rCDX+A4VSuwyMmqfpYMogvqab+m9hIORWEvQieGSlE5eEiw/ldOZqBXpxOGbTmRvdaIuaPJKE4dy+pNJMPGNpy8lwU8lwctJ8Pkk+EIS/HQS/Ix7oK6pvait4MuK9khgo9BdpPpMoD+jXJAWV5SfDvSnOdZ3QvVCoF/gGG40nw/08xzrOqG6HOjLHMMN6KcC/SmO4WL0UqAvcazthGo70Nscw3XqJwP9SY41HXH0RzHcvpIrQIpNbXEWSDHc1pI7QYrhEpccDlJsbItLQorh6ncu0HMcG9ofjYpAl+X7bFFl5O+zPxo7gS7I99kfDadA5+X7cE0MMyl76Ex7cjaxeZ28JrNr9sQMlz8xXRVOzD3FExNJ+cSsMHdiiFeS8UpxngJ4s2iz2y072inaNILo/oK2iTaNM7rFoD2iTaOR7jJog4j4JynOu0PEtynOW0PEL1Gc94WIf4rivCm02V1Z2gQ/Zp60BX5MSGkD/Jj00vb3MQMm5vfTxyyPDkdPzkw/gQFMnx31ZZqdrtIRSv2E2eNDL54ZXqLZSTKhvQTtm2ghQgcmWox3gCZajtCRic7F+0ITrcT7QhOtxvtCE52Pd4QmWot3hCa6EO8IHQNdjHeEJvrJeC9ootvxXtBEL8V7QRP9VIR2TfRyTF8TfT6mr4m+ENPXRD8d09cx5vnPRPN8MgjLagdXNDvCXsbEflO9jAwvi9jMdez5Llpqp/wfLTmrjx1c0za33vbyFy3W0SZzXXTPtPIAruejO4Cu7a3DJw0p3K2rtVCv+TbdN/DtvqsK/soDL+uvwOt6onaHKdVJpMJdMnycJDpJLFRrATg4fLsgs0oe/U9loE3IpYDDYUWwqiSYcxAp4K2QrUcyYIJSXNyWkCmUSCeva5Ob8HKZlBfJm6ufe90r3FCun3/tHej+8g+4+F2uIIm2lRXlyXGeJFXlKX3iSIbsKRlaGRgzceFndUWu3WBJOv7Wg7eVRbYwsYmwyBbmLocU7GNSaB1ieRSqgUFNoQIY1BQSlZOhFRtDglZJrUHmzYgS0LCZWm979sWIjLY/+u+tRu11anfUWRfJzIjZ7m663UuG/n0J7V5Gu88Z7e5grBsalbjUSyWWT7Z7Ce1eilYTv/VT0u6u0e4CR2qXa4ba5QqbmTvRxJFb26jUwRoIM9wEYbj/Omj91Qdk21tIwSJz6TsNelU5jWQKXjviK7Gl1+nydgXqFmhPOAGlzFm/Zz9o6Kpv6aIqQHVbO6TJit/gDpqhLCRdZ1ocSXYoa7glVtnX8BPagVIEepapskmFZRJakxeM8FCvqQps5xRvkGWZteRnVx5IM5FvgejDpAByLQAbLKSEUwbbB0U5aBtHuTzJ8CvRb6o1tX5EF3tQ2dBFldFOiuxlUs3UhXRvt/3p/2Y16Bg6/F+tBp0og39mNehwOPt9q4Fznj/6PauB8yecLtD5M8g39IooHdlwHS59ArpBdP/l4LrLK9XewGGVPJMfX8CvDvlqx/ZnOWiq0Lu1zyt2BkPGbyLvUuw8h46BfUB9gVoEDQANBGoTNAQ0FKhD0AjQSKCAoDGgsUBdgiaAJgL12CEqoGOB+nwWBTQVaEDQDNBMoCFBTeylmjWGRgS1ALUEGhPUBtQWaEJQB1BHoGOCAkCBQFM29QOoK9CMoB6g3v/F3rtAV3al5YHn7PO4Lz2uXlW3SvXY57hsy6+ybDdVcnfTpePYpjokUHnMWjVrJTPVuNLjqJwZ2zRJQSqUCJCIwDDKTEhkh8bn3iJBkMCIAIMygaAeIK2ZkG7xmIkCDRFNVkd0GhA0SUQC9Pj7/n+fs6+q3CYknWFl0KpVd+//7Pd7//v/v19Jy7wnb4K0qaQVkrZA2lLSqtymQdpW0hpJOyDtKKkkaRekXSWtk7QH0p6SNkjaB2lfSZskHYB0gPF0kELj0BRrp5fypr7UhcV+iu3KFKunl/LRirqXYgEzxcrppXysou6mkKo1eFPNjzmqiIjkhv6dFByETwYYVEH3USsMgqXaGBV5AutLtWEpPkRvLNHCiFrdQtmXal1JaZgl4W+UT3t5cNgWuwnH8lS9xk/Wzona2a2d47UzLAQj/pPBUrGderNC5jXy2qFPQOHHl7pfbJuAm15rXKTtnfChaJXOMThX6DwG53JDAJ3Dh6LD9CKNi8y4LBI77eagavEp4CW2EV2dsDALpFtaQXCnlQ3ctLIMkVaWIdLKMkRaWYZIK8sQqbMMQYvsAmGQVjYh0somRFrZhEgrmxBpZRMirWxCpJX129Szfpt61m9Tz/pt6lm/TZ0UExa+vYOAMHVFAwJH2PiXT4N5+N1J2L6l+vf/rIYqwqtuMJul1CnJ3R27uTjIGubWkDxS08bPfvkvPvBE8+/eujS4noc8hOBltTUEEWzw/ml487DNOwyRt/oQ/0ltPMhi0e2vEOYar+f0XJ/lFZDWmb1CJOaWdTn1POgTzekyDbRXOfXydr8DcZ43bxhALwUQosDPXZ8FEN3rDtKuHGRE71vI215mqZeZ9TgLmtkVWoWvMrP5aL+TNRUa1UODHpEREA9Tx2SEjMjgQQmHo2CYjckIHJEhGQ8xtGTAxrb17Pv594lLAwFjsEdwLGXUxbbjB6SAVWMoUxWETijgBL2yFCC9eROIvfSgmfLUL2YiI7Vhh6gNGcnxMLUpIz2Rod+QmdKUiRXbtl84VJQYlkOFu9n50aYxt2duiUm9GlcTQIjodY8Si5E+j5KINT+Pomb/PIqYB/QItGLzskcgqueLHoHSW9c8AoXJrnoEiu1d8Qg08nfZI9C836JHoGG/BY9Ak37zHoHG/OY8As34WY9AA349j0D7qF2PQNufTY9ANY3AI+DwbThKjdztw+GGt1Epgk5+20NrNBZWg0ckCycc7gGblgIE6HeCsH6G4GCUOTQEG+OQsIZ6gxKDwzA0ynQagqtRtlQ41C3CuAqHekZYW+FQ5wjzKxzqH2GPhUNdJAy0cKiXhMUWDnWUnSrlycPrKzsNMYQhaLOBnSnl8cPrMXuslIcQr9Ps8ZJHaHchDTq2vly8zx6r3a/YGd8z7XumfM+k75nwPV3fM+57xnzPqO8Z8T0d39P2PS3f0/Q9Dd+T+p7E98S+J/I8nTtJaGgQSs7wFL7NhfeQp7C1RJOikRoO06EfFHNHP+Hp8whl4S7K4o2jFLxcHiHt3E3avZu0dzdp/27Swd2kw7tJYlRqiLRyN2n1btLa3aTybtL63aSNu0mbd5O27iaBzxcI+IaQQl6ycDCee+nIJ5hxOxq/exeldxfFHs3CpnelPAcB5vRotx0hHd5NKu8qvzVUmPOAnSHr2Meu5xSQOt+RmOR2cstKcJHUTdWqgqJ2FRvHl0QVbaejppcJ3kUDrg3Yo4uJRC2HCEhxLyzlTSfly333kehld9aIyX7pKGwX7yANJ+sObpC8oIJJ15EtfEQOFm2ebsBNakm5RmVrj0Ur95o4oUz7ojihA/uyOKG6elOcWxEPuDEeOF0uEJ5GNlR2bOvhtqUH3lEegtFwNgUkuIOGghqqIv+XXOYBPPsBcD/2eyKJLsDnWYTTHRqgfQ9uiPTJa7Zd3sk7r/UpHY9IsP8skrIdHAZ8kPQNLR1VSD06VElt9DpFkQLbeZ0iSLypqW0L7mL6JnGt1P5GgVdmpVaxk6KNRYoWlYb9jAj6oGbRWzih/akV1mJ6CIXvGw38ZRXAYUcDhDWK4Q+9T7CRQ8eUXY3yGmNygPJGtJDb6fyjU+bkreg2gypbZOV+Mb0A43/ndOSQOSKyBKZYPaeCAabYPKev/KZYvV+liU2xf05f701xcJ8+xRsVFc6mrCm2xDkNqkQDot7BOWfWvTi8T620m6I8p0bWTbF9To2sm6KUaLiIH55Tc+qmWD6nttlNsX5OxQZMsSPOU+hLSqLgqr9yThnNlB5J3pzXG0IpRYk9T2ES0SNt48XfFMv316QdvPobSCuLnYfT1ObGmbiHo/zsoLQpZUQb9vigtE07MuD9YFkCHUOgEwx0koFmGKgzKDGXoX1oY7w3JRAKtamdZqAJBmoPSqwEBxJobMAHdQTqMtAoA7XEUAs0HdU4ciyXjDaD8hoxgrfv04NSdUUDsWcaK+vCKgaeUWFxxiPvgx8awh0RsBfhnzCQavd+dhEX7w1Ysm3iUtITN42cWHH3cC2ZE7fFZWRe3HN5qzLnyNtmW1YxXgY7srZhnT9rI9/YoyApXBXXFVnmBEnhRXFdk0VOkBRuiutlvcMLlMKKOpfdFV6xFNbUvRrqyqdYCuvqLgUzIXBYCpshUQnPyCzFyKwa5UuES22tPSOnGENxuKR0jRRT4RgncddUpCzgGO4aDN3ImuMc7lqOwS7jFK7tJ5QrOIOjCRcd5SpO4GzIjj2DU+mZIlHsoDMMxXLb0CshIAZprxToH3RshrDFUMK5FeI11xDaqTUgaSckvi7HJrVj8piLLa+RPOprxsIDOlszp6hF6XkFoqyrCr+BqLdThEtVvFPV7m5Uit1N1eluOXXutmpyd3QEB+PeID32ORukbnjmui1jgOaj9RAFv8EN0ny8HqZ5tx6o+UQ9VAGOUw3WfMofroDDqQdsPiNDluecs27gBv/ljFtHuYbB5JqXlBdxa3SNTMrLuDO6piblJm6MrsFJWaY8hWv3WNhpuC+65o+FXYbrYtULsTC2cF2sOiMW/hOui1WXkAaZiZlSOuZ3OevKatpVk07mH6ddNevKatrBsRdic5Jw+yGkJgzER6B9Ctch4dnQAsZ2NbkVA+EIQ3v3kxJszUB6y9C4/TQd6wa7WnlkZvPyq5WbkJktkCBnBT/krOCHnPXwQ/YUXWNXf3f0lygbx9527pdu8rupL4uA1bPbHBtEJ7+g7EpzEF9XZEguszEIpytCI1etA4m4pmIiL7IhcDJFO4ATgmYgm8Q1w1stK/Wi4i0pibekpN6S0hheUprektIaXlLa3pLS8ZaUEW9JGfWWlDFvSRn3lpSuv6RMDC0pk0NLypS/C+bT/j6IUV2vKPlxf03Je7+bVcUDcHDLigfh4NYVWXuOrCuy/Pjriiw//roia4+/rsja468rsvb464qsPf66ImuPv67I2jO0rsjiM7SuyOoztK7I6jO8rsjyM7yuyPozvK7I+rNW0Taq9aesaJvV+rNe0SDxBXNjYVn1WSzrCembYSm9N7xesSfEoH0vO/nZV6+TbvU6Ua1eiVu9UndkaLj1acedI3arc8SeO0fsuwXtQBc0t3yNuuVLV7QVoyvaKlY0XbwmXBYlljRdv2RF28CKJh83saaxdAaSryidefPE/1lXuRk1z/1WK9VJXalOuJUq0ZUq1UNKwy1Hc3pumXfnlgU9tyzq0nXZVZxL1aguVbp2XdO160UVdHtZ68y1atKtVVMqgiZVDp2qGtnFqDKZya7KxHX4zVFjbjcgJbQ6omAOMFNcY/jFQxDVeCHA/Dvo4K3h6WhTf5c7XkBg+Ikm6dPRdhsfno5W9Xe3ZeNiJVoCK4pcohh2krtXoDBMZWl8S7p/BG+mF8zKCHoEXy6YZc/91yK6DztLF8yquFdgPucbxL0M94pC1QgDRF9ZxZAbTZKBsquULlknoOwppQfKPij7SrGgHIByoJQ5MgdAOVTKPCjLjVK13NnJ4LmAsqKURVBWQVlVymVya0BZU8oVUEpQSqVcJbMIlHWlXCPQOigbSnmR1thA2VTKy2TzgLKllJs0vAbKtlKEA7QD0o6SVkjaBWlXSask7YG0p6Q1kvZB2ldSSdIBSAcNh17EVgLpUEkbJC1DVnS5KV3e/aOi8L9r6rdAjqHhzgPMwL1C1M0J0IB7plHVD9AE90wD5VltSojDe6aBEDsaYjm6VxotpNGSECv3CrGDEDstN5QFaDMXCYsoTwUrSVQUlo0oI2zBDgk7SnQVFkUpIchrtr7H4b8u6OUdRTFv1mjm/G3pb0N/0xecBaaDd1OUvSSbgxK9JQH1KLxbEjkBznbJhZIivrXsa6eSwx0pVY4rgk76H8tjINvFt2oMVIJ2KStS28XonGwKSxarq9ppNTo3u+7LZQjbc75EotpelpwrEeG+4Oy5oFdc0BXsQX19qcU0YmDOZ+sCX3WBVxmYswS7VJ8wHwNmssF4nPVzLt61qjxVvB3GY8YG5vP05RdzkwlwkZh3CbzoEiirBHarBFaZAAtjIG8r7VUDqkF3Pq1hTXOYQ6z9NpitNPcPPmMjop2m8iuq6s1OFfy/Xrzz7Jd+x3u+5l1n5rdg4hBq7niLjoZQU4HEKuk0/HSiKp2VH67SWWQ6brClQ+mkGHqaTlqnk3bEkmBMTcCYByxgC0Rcx2TZENz5LcMPDZs+24m+8ys++b/86g+xj5apZt/wXp+w01X2oT7TwespzJqfC2zU+bWOiW+3sPsdpDfyVEx12KR7xabFAmTOwu4fwat4sbB0wezjRd5cMHv6+7GUn7axIe2Kex/unxL3Htw7qTWUUuGgLwW3J1XxDBGWp59CFA4NL1U5Bzki03+VI7YUPB/IsHAkloLqA0kWDqxSsH0gz8IjdCkIP5BqoUxIKTg/lG3h4bkUuB8KuPDsXArqD6VceHQuBfyHoi48OZeCAUR5Fx6cS4ECSrnUGycyT8IGCSIzT8JmKKfmUvGBUvaqqaXmSdoOVXhF0YJSzilTy82TtBuqLAiPwSTthXJkLnkKJmk/lBNqKcC2WHO7f9SmxVYEyUGFOebr0Vaad9g0aT5Cf5KP0p/kY/TH+Tj9cd6lP8rrh1nvjfb6LIGBui/I77j+junvqP6O6G9naAFucyUlfGebS+myOEdBTegcA1WclFSM6aRwoDgnSkInB0S+Y027fywzMqJDG3cft6kwizEu+4JsHPG2/Ui02Bd8Y9xnOS77gnIc8Uj7SHSlL1jHuNlyXPYF8Ri3W47LvuAe43rLcdkX9GO+zhlZ8tsCz9SEkF6k9CbXOSMrf0cCdCvDotwFNMBlrIMcDNEAtzOErB8XuQloyCsu5AquFHSV0QD3N8SxFcgZ9wKNc9XFWa3ibOMOQtd6NMBVD7HngI/T1NhzLva1qmxV7J0q9gquMHRtwPqHpDOvmJ6BbAyazosunbJKZ7dKZ7VKZxtXIbo2q6fiFK+0IgoJPZoGXdCwadEFzYGELmjhxCpPHtqILmjupCoESSia1TSm6M92KlI3W6kI22ymImOzkYpozXoqEjVlKoI0a2nWlW2eVyVeN3cirtgUo1nlAWlHHl9XE36YFMglIqYpehpBmQDPVgqymmKo1ZsfU0mw4k96M/DIii+wt5AVxfreWY1MdDu9xZUwKRZeqoZhKMOTgAcRhqeOPuVE9XkMjgZiFTzyhicvEBrgMjfxUIZnU0L2/JA9F/KKC7mCazFdpcAlII7141gX56qLs1rFkVMKT9pubkUYnnXsORf7WlW2KvZOFVvOKjyeuykYYXjWjTPv0nnRpVNW6exW6axW6ciRhaKvMjxVPDzVK7URsNyTnU+PmtHbiZotHTlXn2YPfohT/04+QRaBIXx8045Y+gE/MYXlSf3AlpjG8qR+gE+QKad+dO4Ed8xi3yxlY2IX+OBUngo+G6G32vi5kY8TeOsrX+H7Zm8JYmoquwLpc6rFNKlBkceYwbFt8LF4clCLBeNm03z1rb9HwNqKCLmVJ7YjgvRtapVEH8ijKkPmiKdPGy1h+Ez61lX8oo+aRTv+HO2VR3g8l/LTiu+ROmRthRJrV3VIiu0zfkmnvJImxc4ZlLHBGrnPyZGKKGiYVmT0XhVBFnVFpj5HFTk461dkeqgih2ePVGT6d1URZFFXZPpzVJG1zK9Id6giZXakIt3fVUWQRV2R7ueoIlu5X5GJoYps50cqMvG2FSEE2dGaII+6JhN+TSqxs4hv47oyTspxI1dlwYjiN/ptylbUldOewfSKulpTuzV1raZO1FSRnBqjeRY7go2FsNq++mxXobc9DdquwnN7SrRdhfD29Gi7CvPtqdKO4a2za6s8nEqtl4fTqvXycIq1Xh5Ot9bLw6nXjhFpu87Dqdl6eThNWy8Pp2zr5eH0bb08nMrtGB5SvDyc6q2XR6196+VSK+B6+dQ6uF5OtRruGB5qvLzcrWIoN3evGMrN3SyGctsEcfNIbluhcE5GxErkNyfG3H7ilmyUIhq7ZUQcdtOICOyGEbHXdSOirqUR8dY1kykqt4ixrhgRXV02Iq56GIqI6kEoWB37itWxFwpWx24IrA7ih8wqEsgpxfQYQufYCAWdYz0EOgcx5DJpN4HkWA0FkmNFITmWQ4HkuAlEDmDIPcguFuiTa4J8clWAT64I7sllgT1ZBOoJMOQIczIvKCdzUHPFUwSxTnpAa4SmAxFPmgJ4EmSfJ688lO2L7HmoIfJIFyqoFNNtAo6DGXVzMoyYdy9vDiwLA0NtpWXx5mBaj+Wdzzs1nvvnga3/DjCknhKW05Ng5j9BTj5O7fZx26kB5B9E6AcQ+n4JfQ6h72PoHKEzFxoK/hahzyL0GQl9GqFPMfQsQp90oYHjfgKh+bpwXEIfQ+gZhp5G6CkXGljtkwg9gdAqPzGO0GMMDQhkQBY7PHZVs+TprPPRMIxu26D7HurOylKLtS3k+hpgrYiLw/YSF9zKekpclCNLKp1D04+jS04KAd6DsSVnIATete6Ss9tBcM+JJWdOA979SXr31Ls6Te9GLN7NGXqXE/HuHaN3J/GOmW3VPpqgDs5vNczUreg2F7TjFR4E3qCPy4PWjOA6UDTc2BnBdaDwOH3AdaB4OX3AdaAAOn3AdaCIOn1gUFGInb5Dh89A34HDZ6Bv3+Ez0AdcBwrT07fr0Bro23FoDfRtO7QG+vDKR6l++jYddgN9eCmkbgB9eEuk+sBxtNBxfcEP5JEkJK6DsdHAR+Q3KiDrAPkNBpSHx28wtrzXXIOXeu8p12C8VWD88Ld8U5oWlwVqXqhNWqOmNhfVHq2BnFvgNh74R+m/oio2uAtT+6OUl1s+DgZuq4FfzAbKPgP/BP2yycA/Sb9sLvBPDURHhTtLLZkaiiFRsTNxBI9hugiy4yyuG0sUxj5mj8mpwRtxA7YwDwYzFM/WQGhnpW761MRRt3xq6qjbPrXhqDs+temouz615ah7PrXtqPs+teOoBz51xFEPfeqoowKPoaKOOeqKTx131FWf2nXUNZ864ailT510VOAxzGCISw+S6g/yzg/EZkzAEHZm1SZzdzEfoeXzZq0xTv34jfCl3JAODrBZymGvkQfOG92/GWbNIrTRDZ5+GzSfBlXobAxKj68AowWK4kC0bkWSuG1Bfz5WNXcYagteB7JLZixumU1LRhskpty0G4Ned1RMC1AD0zC2odFt11HiWsE+rc/TTdU8T12MtosR+xaQ2xU7mprfTpFbjPKpHrgH4MPC5RN21MMrfvdgSHZ74o07WRetErNunSJ6JW+/RQ1SEZ0PWNTM6N5j21KIqJi8UZgvvEdcYH3HLm6Mo/RQajGYMkcovSOxTBF79R1GD5DBIDqqwG7YmQXLaKTztyIT355xLKMZGJ9Gabi1icbkGvCPKTqTqYGurC1iNoDfwZFohPI4AOrBkWiMUjsYLjgSdblnAvwHR6JJWg/LpigXlE2Tl5rNkMWaHRO9yOOii9kT5c8TZN9mJ8mpyWbRBSr8osa6AUXOhYmsnNmBsHtPijB0F9hf5O/2BsLXPU7JArJ0jw2ElTsjYRdw10XpsEyisHZSRBZQfiytkUpXsXpYi1FbrNGoPKSbJexNLOtsHqz3bC+y9qQJKeeuXCo5P4gURVkOwUF4+BoUXOmsV90UF8lL3BHrev8e7amEPZXUPZX8l9NTfue4bpOe+l9T88it5LZeKk7opeKkXipm9VJxSi8Vp+VScUYuFWflUmHlUpHJpSKXS8V9cqk4J5eK++VS8YBcKh6US8WcXCoekkvFw3KpeEQuFY/KpeIxTvR5TPQncPZ9UszR2xNQco3sSSou21mos0b21ICwWacHxNI6MyDA1lloqUbWDgi+lQ2IyJUPCNN134DYXecGBPS6f0CUrwcGhP56cEA8sDnokgKECGPKPgy9UcAMYUzZRwECDSChrFeEBDjD6e5x+4Rb2wly9riMovMKtxwDsNOeV7jlhM+v5xVuGRZt6SPcMh5+6SPcMs0gwge45RZ4OvAAbrltO+IB3HIHRrfhAdzyCGxtwwO45VGY2IYHcMtjsKwND+CWx2FQGx7ALcOCAz2AW56wk+IB3PKknRLPnKJG02MVNJqenmJG09NVyGh6mooYTU9AxOjHMQwfr8S6nlzKz9uYd/3z0JNew29KVsF5KEyv4LdJJsN5KBrdtOehFfWyPQ9lqRfteUsBwfOWEsnnoT1+xZ6HidvL9rzt4hB73k7gbHsepuTm7XkgPM/Z8wB4tvY88J179jzgnbv2PPBumvY8wJ0DO4+SzuuE+SWoph3zH6rxBsXnvC8SXboW3nDsRads14C3d9Fp4zXh7V506npteJvyzBO5Bx+8GmDsIOXuH4JaIyxUCKZDFnPMGBgZEL06bLE8Z7V5liCMQ1/43k31d/tig6Kh/l5fTGy21G/hxzFKgaYaWLXbUrOGv3B3dOEe0YV7VBfuMV24x2Xh7srCPSEL96Qs3FOycE/Lwj0jC/cxWbiPy8Ldk4X7hCzcJ2XhnpWF+5Qs3Kdl4T4jC/fZIshCzrxQDB3nEFqzYZG8JCeVvKXwV1TmKz2LF2e14+pVHvf+iGPVMpcuLv8RWUksg+VSzFLNDSwLOT8oLQu9ADZARGEJVumyrPGs5RVY4ovETh0bgXbqIoq6soleZsJsNEjMS1uCOxDJWgAWQSTSqyPSAQDZjJyFurLs51bQTVpL1orUT8jnR51ctFFIjBZ5RKpNcIhVaGIGqdE/2ST0la7zNxMzf8vcVuZYS5ljbWWOdZQ5NqLMsVFljo0pc2xcmWNdZY5NKHNsUpljU8ocm1bm2Iwyx44pc+y4Msd6yhw7ocyxk8ocm1Xm2Clljp3WfeyM7mNndR+zuo9luo/lso/dJ/vYOdnH7pd97AHZxx6UfWxO9rGHZB97WPaxR2Qfe1T2scdkHzsv+9jjso/Nyz72hOxjT/Js8Q5hiFkwJN5BRtlT3CUItYpbLTR24OrmCTq9A3cPLLM2XDZvAGD1KfDGmsIrAut4GoyCKXAHwGOi5T/lMpHHpDylEOMWgzYG04rhjiPcMYSbceHAtYYgFgD4MRsS4YKlmAgNzIKm43+F9gGEux/hzkm4+xAuR7jMhQOv/FGEewThHpZwDyHcHMI96MKBzf4kwj2BcPMS7nGEO49wj7lwaMNwKX+H8sb+PxycGzo413Vw/mc6PO2GMjB3QhmZ26EMza1QxuZm+B87OIeHJqA0ZWjaN1c/HZsUsZahaR8Up80bPMLK4ARX06GFPjawMU2CJDw8p3ZuWAfToYyeR7ic4UTr8yGGm3QKnQ6d9HGEu4/hTjHcwww35bRDHarpPMKdY7jTDPcIw00z3OigQkN9AuHuZ7gzDHfcUyQdG1Qoqk8i3AMMd5bhegx3jOHGB/7gpKZd5y/GYXgb79r4l4dwxXBR3n/4bSKg8JX3MkHStkCOgbStpB2BHANpR0m7AjkWUhtZSHsCOQbSnpL2BXIMpH0lHQjkGEgHSjoUyDGQDpW0LGbkjBM7DSifwAlT0nK0mPgSo3IgrSppTWzLgbSmpFJMzIFUKmndyOQsaVWapA0j87akcWmSNo1M6ZI2pqW9jMx2JxkbUMqBC0FJw8HSXkZQwksanpb2MoJZXtLgmLSXEQT0kmaopb2MQKqX1P2V9jKC0V5SZ1jaywjoe0ldY2mvSASIKbzb+cVmOHrLBkVQfCjqfjDMAJ3JBxEzDHkYWPNGTu67B4tg7oBEdWixsDuAakTTqpiLGQjjVyzsDoTrKxZ2B8LyFQO7AwU1oIHdAaclRd/B53yrcizeXY5VLcdlMp3Jic5jyDxRueCyfLwi8tY9oSfCGRaZeXl+Iz0VDrFIzou5ZNJbwikW+XnypoXe5sskb77IOzfWDPqCGvFWFUDQozVY0xqsMJle3pTUIEFDIwrawNQCEsGehit06r53VCNIRHcarvAt931EtYNEJKfhKtF23408ZopSIUV2gFfV196IjlYmegONuzVUmehOLvbMAxU6CqguK3UaZWGRYgcpWhGS2tYiQQSuLjJCjbhQYwLdoBJEo3XBEcq4UPHTut4sGy1+SlGkDuWLIAT+lpWAjfChSiQ0xB6oxFMgGwfrMsripSwe0h2jlFPCgYagKtzkFTJlITtsSA2bPK2r0pYraouCUSOU4xuj5J4MofRogdM3MES3hgqc3kFDbrhWZ4Hn89S1ZptpkxdPMAE3pBqieiOLaKSt1RbpQo5idrwOgnuPaJjcgxCpG9nR8MiG2fqODToH0fB2w9no7TmQF70icIe03Qh50aviv8Z3mr6IBHD2BSIv+qL4X+Y7TV+EAai5gneavggBVPNyOeyrCEA1x1ZAWlHSquwUIK0qaU12CpDWlFTKTgFSqSSxIrkO0rqSNmSnAGlDSZuyU4C0qaQt3Vn7uqdW02UbpG0l7ejO2tc9VWYAd9a+7qncTWVn7eueyt1Udta+7qncTWVn7eueyt1Udta+7qkyebiz9nVPrWbACkgrSlo1srP2dU/lbio7K9rL3NXjfmf7oiC0RejJgaCzfSEQdLYvAYLO9sU/0Nm+2Af7eljog309LPLBvh4W+GBfD4t7sK+H5TzY18NSHuzrYRmP/z+eojofGQ0fvyWckimnnyxckjnhtVhFjRSeCR+AcNBPhHWSyum/Kaf/lpz+23JP6Mg9YUTuCaNy8xiTm8c4ZT/lHjQv4sRN4d/0gC8j6DTgdRVBsREpmMSkPdbPj8nb9Yxt9KEQi7OLj+o2bqftRD+f5oI8MyhfV53ZUR+tzk5zg5HPeBlu+zh4/NrUrziFjPvIdDzuj9ljg/7rqnY74oPe8XNHP1MjuOXj6ellQT5fGcoZtm4FMcamlJDOa5y4QT6BdX0U30cGRIkpoX8zOchPlB4mZIYSeLLSAIJEnBbi4MKbp4hzvO/FwQWp6+G+DSCx5/nivp1AiFk07hRYSCeR0Kkyv48ttB0NV2MSOZzu5+e4eedn/PLRHM4EdKOhp9AY5L2+PVXmD7AIx238ZiXBmJpVizMdyepsmT/IrNaOZHUC4b3k5yT5uLRJ354t84eYbs/Gfn0fZlKE32mjLH3bK1GIRxD5tNd2VIe1ftTTTC9Bvklp2yhnC+VsSjmnyvwkE9+UxGN7nBU6W+azSPwElN7nUbapMn+UaVl7xs/gDKOvSPQEZYtLBJ5A9ONe2RI/ltVi9XziY0wK2w5616avD/In0COvD/In/TY7P2BJY+C4o6QxsqpGwzJV9eyJsrRT/TwdlOXrelxFhvMsXIIUejWq4fIgn7STZWlP9WHnaNQ+Yc/5OZ6QVK4xkYYXqwFIJpSiD7ZU2z45HO84rRjZx9lbPUkEYiYtWF4a4UV/3MqY3IlIvx/0B0iXAVQKfQ70h0iX0UDEphbMfozwaj9upSO3hD4rtodAlx5aFfoE6JZ0aW5s6XYcjIcWsXKsttia0BPQJ8UiE+kvktxQa00jVmtFJFfUqsNajWmtdiPS7xfrUqBLrdaFPgf6Q6RLrQhW1UStOqzVmNZqW+izoD9KutRqTegTYnoKdKkVTiUeACXWgWNYCWcG/dKhr42JyacYcbXSxC/oDK27x9CFGm1FoiWINolo2iaQ3GkOrcfHMBg01lVGaiAS7Vtpi4HdNP101O38oDHR7cS95s8PKYCU5m0UQNbN2yiALDrliA3zNgoglarITadFsWneRv+j0hlZrjQvNirNiy3j63/UdZq7S3uk1jjZrGLvh7Xexr21NUrR1vhMbBq3zS0hAaeceLUQcsliPOZ4yK0UZmvkkY0B5kmL8wAAFBkbMQvu4wBaYwNn5KBzB5aR26qHEi5lDQNJG9piMBQlZ3r6GEWNT7zXNisrCW0nfm2Q98zzowHldorwFcnI2UhQ3TSMtDpyQiMJEj9aygLKpDxPQwteVNfEbxEVtaHhlKM5RfcMHmhJRTClIY5imsbgU8m4TqvBQ1TdJJQ6asKIvBiQsJGYRGmztQnw2fSsc3g2WgZ9NHRahFK9NkUQCJ/pRwg8aaM+g5jPGgTqYsB/Lqa1OlqSqt/v1Fu0NwZmRSsuXMLTehHeyAIbjQZOLEnsYna+B8ID8e9l4YHHC/OB7Ak8ywMV8ves8MC8Cg/MHxEemP994YF7Cw/ok3ysS6ITsvg9KkCgog4iQPChKKT0cyACRtDLiShDmMsmM6itVUQCxSCkpkrAE4NBSF0VXCfWgpB6Kp1ORAUhWRVBJ1iCkEQIOBL4AyGJHDBJC0oSUWCSFpUk0sCR4D8ISQSCI8F5EJJwHiJBcxCSMB8iAWoQkvAfIoFeEJKwIEh6WUnChSDpppKEEREJKoHSHC8iUpiJUEWkSgXKFTwJoTqORKRoEaGKTglTIlIIiFDlqIQvMSTetpyYVGRY7Y08OhdY81gQQBTxebgmiuj5V7IESo2wuPPzwUtLxdZyuIQwjSK6kTeLz4SvFIaWhp7DbgjE/seC3/54MhpQahPKkB9PbPgFo9xVN3+hwvZevJ7FleVbBQcNHgt+8+PJWBSEBpzAKm6CwnRH45Gkpj5v41dGo5HYo4xCq4sF+uJ40ZXDdCSyGYmcC3JjXzoawpRl8hzRcefM/seTPC4WuKWzxmkRPz/K9phiXRKbjkL8gFUxjwUzz2UozWPBZz6eQCzwkagJjeMWoj7HkMkNFua3wi8cDSppjawNfnWFXbJ3SU13/MalZ//Jj+Hv1y8hk+dnhaE0uJPYdoc4Fq2ObXn9sLMcUg6EvJVfSJRnBA7NLyRljYXsoQovXp/tvzBKA2oPBeMXg+N0meZF0xVXcNHQPkURApni4wndxOYu1n88WQJ4Eo4Ufxfu6CETX6T3e9U7It4fUO+0eH+Y3rlg9kJAEHB4W9Sgw3n0XND5pAkbt4YNNlwXBfE18+xZGjO5b/FOrmwlj6J8Ro8SCYPKowjuTuhREmF1eZRU+GEepWZDeByJ67N5A8wDsThCyyMwsZFcn4Ucto2JkWNsdH0WIv3WXJ/NOfOowV455+B6fZCH3g1TlN35FmTDshQd+CHv5rB3a9i7Pezdqb3O8MapxTuJDTudf3vSJLdnMNv3GgpNAjZrTMRnDisoVuoEb8qhUCStItHdmDPxMAVVT4qNswpw7QFMFesNSozZpNjUz43KdlGxUX3cuvvjZmMpl4S364T5kXbXfmQ5XJozAU6kTeybIWzd7IVuJjfdJSeSGEaDBS4YkdZpFmn9/0renEiB4HUA+BQ2jUAraX5ItFIZ1LVPsX52qft0RwUXWoAsD2W7yzo2Ff4swX3k1gRLNZ2BwGEwg9xcMLsNQmoQ7WTAJZnQLz/VYKCtBiBe6L5gfkxou6BtNwAM01jKk4pPnqA/qtviQAQBqjvhQAQIqgvfQAQPKhX+gQgsOP+8vKhW/oWBaG86/+JAVDed//JA9Dad/8pAmPTOf3UgTHrnvzYQJr3zvzgQJr3zvzwQJr3z3xwIk975l9FY5NE7ygooKz5lFZRVn7IGyppPcY1eU9ZBWfcpG6Bs+JRNUDZ9yhYoWz5lG5Rtdsu9OmgHn3f8CLug7PqUPVD2fMo+KPs+5QCUA59yCMqhT1nGfZsM+qqxQFnxKaugrPqUNVDWfEoJSulT1kFZ9ykboGz4lE1QNn3KFihbPoUcgW2fsgPKjk/ZBWXXp+yBsudT9kHZ9ykHoBz4lENQDn3KMtAjiEkW1zAdFFF4i85bxedVP8IaKGs+pQSl9CnroKz7lA1QNnwKgSw2fcoWKFs+ZRuUbZ+yA8qOT9kFZden7IGy51P2Qdn3KQegHPiUQ1AOfcpyPCAQkNdYoKz4lFVQVn3KGihrPqUEpfQp66Cs+5QNUDZ8yiYomz5lC5Qtn7INynZ8tPMS11j4vIMIjrILyq5P2QNlz6fsg7LvUw5AOfAph6Ac+pTlZEAspZqyAsqKT1kFZdWnrIGy5lNKUEqfsg7Kuk/ZAGXDp2yCsulTtkDZ8inboGz7lB1QdnzKLii7PmUPlD2fsg/Kvk85AOXApxyCcuhTltMBEai89gFlxaesgrLqU9ZAWUsp+ZC3BDosnxnwNE1gsfwYWBstgR3Lj4PB0RJQsrwHNgc9N/MT4HXQ/XJ+EgwPul/MZ8H1oPtafgqsD7qv5qfB/6D7Sj49yKZ4EZimHp6cDJJiB8emmMYFQjulGNLuKLNL6uQR6h6pE0eo+6R2j1APSB0/Qj0MRPx2mLpMUenRI9QVUkeOUFdJ7RyhronOnIIaBuWQ7nNcV1o4O1mL5nJTO42D1wgXy75wm1N7mlf+Pg5CQP86xet+H3JHeBia5VW/DzEjYH+d5DW/DyAtQH+d4BW/D1keIH8Rg3G+D4ArAH8d59W+DyCeBZvaY7zW94HDAxDAGV7p+4D1uYxidfOYUk11hWJKMeVtFpC8iBjMI2Aqxo4VEYODNIB1YseJgDk9QH2xpGRExOAlDfIxFlb03cFQGuTjLC/ZENATBGYQi0wuRAzW0iCfYKnJhIjBX8LrVVwpJc+ZaSp8QpWrIYMM7JXQY69EQ2gfinTpo30oxKWP9qFQlj7ahwJW+mgfikXpA30ouqQP9EH2SjQE9EH2SjQE9EH2SuQBfQxp0qc0XGMj2rlDnUOtc1hNLJlSQ30n/rrnxF/3m/jrXhN/3Wfir3tM/HV/ib/uLfHXfSX+4eo8P4pjvDcxgg51D/Yav6978Pu6B79HdQ9EN7oZFBtj3WtB5x1heLtodoM87P51aB596tfI8QmLeMkG3b8B0k99Wkm//umwiLth0Pnu1CS3x8FT2Ahv5OZcABM/X/PPwQkM58zyPw+BG1FEFwxQQ8Pi8GN4vrpg3kHfys9Bq/yCAcJodME8ChyCCwb4owb29S4YAnOqe5rOdTCnunTOLV0wI3StgQijQ82l7pfwi0TqniSNlO4LsNT1sVANWoXF4c+GS5Xc0N7HQpmHBz8b0gZRWBxI2LyW4YFR1Rvf/+xvfvuv/sQf/pIrlwYeiHmjkmT8Vo9p9MIspQsaAxppVXJv0UU8v1WxaM4tlgNAMRfLP8dc7Wg/nxgoIkYLCga2BbkGxczoQEXAdvr5lMjrU6wJwQA8Ocib3e+ACnKz+3pIgA+smfk0kSxz2rxtVkDPB5dss5+PDvLuIJ9RVFUwLXKck7pv7mUK3zpux/oC04pj1uggH8M+N0JWR1+hV2fsdF+wXQVHFJCtTduxo2+mN3BgrHjCoTbCi/SMQNuCkLFukOjo0PGgnT9fO+f4CtpbysMLhpCs4QXzrTJOVjEOyrAaHd8c1mMGQwkDpXvd1ny9g0u20acIiBLeszgY6lY7MXDGcScHIjkBFQ2RI2loc/O3ORChLnq6AxXDoq8nfAoDdI5zQeerIxqu1LuKEbZaqAKPnD8xwYYEBUV4OZTSFTZNqZC/AV9UXDhbh1uowzUlXLcON1eHW6zDdSWcyCXU+do634VBqdDBLt9mna+t85Vw1su3Wedr63wl3JyXb7fOd67Od3FQKgSxy7db5ztX5yvhFrx8u3W+c3W+Em6x89Np1LiV3A6/UtQYEmcfRjDCBdeJiudvVHLMG+9+IcZDxS2zaBuv5camr+WRTV6DJqzgWjsG8D0sEQYBhPeHbD8Psuazn+Hfr9zOnH2TeFjaP6pCXB81J62pvc+N1lAyQOPBc4ax5n1ejlnER48swrcIgQBVDRTueCBM4qRypc5VlmUW4y01fmMA0BAzbHgF1sPz6Aef+Yz7C776ma9SK4mfCf44R9dreTwcYLkKcFUkCWxcgrsa/2A+9oxd+ba8VSwvb30mumHHvi0feZVBun89RJBWcebPFuaVfNRGLnC7OPtnX806sJhYIIPGK3nbjn0bopHd2ynMjTEThFHn2d5jz/7xf5+1Fkdq99aIce7fuGSjv21bLpGWHXn1udHwpIHoCcrTeD5GHnSCz9wpog8UOw9jfa4TlERcKMZctku2/cWvPDdqTppbAEmsx0BbP7feOwo8kMjGd17r/vWwkzkDeZ2xKA5C9NfrI3FdARs92/gT00898Lf7P1D20auev6pZiX5mIQ8eFtuYHRt1MLbLSqkmsOZ1a4YtFb8wm0P8Pqj0c+742jl3no664x2xsNQctokZCLVnaz1cSEP9hy9wzXrCdz/bAtesJ3z3sy1wzXrCd+9a4Hr3XODm7lrgevdc4ObuWuB691zg5u5a4ObrfBc+2wI3X+e78NkWuPk634W7F7hPJmF0Wx52cSpDRxn96coPDkxdQNUEONMZ6V9jAzlqyent+9kkgLD58VHichZh9/1C+OUpYGB+LFzq/ncyoHY+Flahv23MC817iPfxx056H6tFrJ4k4WPB930snK3C/+TbhS9WP8ZHqzrKx6b90m7+OoZHsc6fO1Wgrxt523Js+OX46u7bleO7j5bjo8feLsrfOxplrf12Ub7naJSdybeL8r1Ho3xfXTCzaM2jwVQRXIYYW9HkqRoPacB1EHBWUzTfGUwxJiTXwmLtl4MlvO8/829/4sd/+N985wf/9/MXA4iMBe8MxNZsc6n7ork9lHDiEpYUE5diJw+L9TOPBcE7g9iGxbeemQuCCyx18M4goaEupOanNWea3e9iKnxE/oVW2NSx3pRXzREIDmFgd21TF645Q+GEDjbhoveBovdlRXA5T/F+G3b/Tpi3cJF/+b0xIZxFEi4p2n+YeFoxytpE7SkClxTdpeLlV/JO95uSLMEZF8v68s1XmZ9NcBlp2viCGenYGIBgtg1trFkbCwwUZeXYVEgTSOrdO8lJZaLNmW6W2Bh1iCH8dMH0kKaNbxTRl10w0zh98GkCP02UNwY6exPTO7ZNGsqeMwHKkMjU1hZAMLzLjxAad3rpgolRGVYr1u2HKYf4CfLkRjH9Z/IOkb+Kf/La93wieC/NbCBbKx9bRfiBvI33zC+cLX4MQWyr+MSPvfbUe2ddnC8GZ6SYfilvdb8pgTGCYvolCC7GFDgAp5CgWx0tcizrVEdKzmAjKHLLtpf44Dq9lFGg8PlRY0OiUqXF9A0kiJ//wFRjKyARDdtCsIZtXzAx7IfwlmsTgUsLi+kbuM8WrRuPBoEMQSgocQjGWeiS6dgkC0eiTve/DTrFnRncqe+ZcseG8aINEb1jm9WobrpRzXEQFCOoMDiYWYopSrg48gDz+EbeECjlRhF9WZ7YFqZrhJ84NxgnfwhnIVynETL6MpxTvwgTJwtsqFM6I99QU41u5GER/EHKsUYW8Cw25FRvYT+ILbMzkFATLlfeWLpBREg8tjRu5A2BVgv5ji+4Hc2lLLQN9ELDQkQIUHC4q8U2iUVoLPoyAOAhxe43hzwM3cjxjm9p+qr7zTgAshYtnh1QL5hDDznZDAYjhJyCG3lUmC+DQSMOQ5zmIBd6iFPde2fzEHKdEuWLMWaK6APdb0qSIsBhGJqMwY28LWUBoF2juPkKJJAbrCe7PfpAlrx5cmPzUBfEzeIGqghEFsJhpjpayNb02iAVUDmjcHhYF5quKVqY34GFkR0OpxEzNHqaXN/GO93xoPNnwui2WSzmut8Z5lhUYl2EoiK+AVkUpBONhp0i7gZ51P2HiY2K3V8LiwRsGkszQYHI4hnamGyKq6vK1xgI3ffzCQ0F+ejjZuz2O8jXaegJYs58w5/EyghLz4cwt9Y9A/AgNB8kx4rtaCkfEdud/JmTHys/Pfnpyg8YGi7BPCq2/9EJwYDtEeR7x3ktvbvOO0fvnvPO27amJbm2n3njr3zX//S1//Rf/tVFZNSGdZJ20YNhuLWfDyCdGBQ7e8GSbXfPIv9ieQ8MBeTZpjmeUwyexah1IhIyEVm2RMZZM4Lusx8Krg9Zp5FKBhMR6LRosJ0RDNpMzOiazBJ1FoxT2hzPcsUYul8AhB4QhbcHmabJ5pimyR4SO93Zw2IVM3tEEIkeFbihx0Rr7TyTMtnjYoM8mxdRv+wJwS16UkCJnhK1uXcwJZN9Hn4Pw+yC2DLPLioW0oKgHD0tinnvFJW7dzFFk71bcHazzxeb6Nl7FDjpkmAiLYq6XiHqes+wpib7A1yeYberQ1Zty74Llr1Ebp/o5QP7TrzyzUNn52m4roHvVdoFuGE1dGAvwrmF977SXoD7AM99AFBGwcACk5tAyz4DXbYCeh2LtGVoLwGy7j3EwPh8KHS82045HmjLvgOhn0LoJyX0EwgtcHePI/QfcKHxNngeoR9D6Ecl9CMI/TBDP4TQcy50z7bsgwj9AELfL6FzhM4Y2iL0WRfa2pY9g9CnEfqUhJ5F6BMMfRyhey70nOV+3FEdCsr/r0TP/vnp7/qCn/+Kr7lUUoZBbA8NUbeUejhEPVTqRuxTN2Kh7g9R95VaJj61TKzbygnnxe212DXo6pRzm8Bc1Wt8SgEtvOag64kumDhLbVQ4I3Rg4ky0lWB5OmDAxFljK3MBINwiTYyulfm0AA8ekCgW1co3x4wMX44xeeZ5c+xUQ4BQiFKQBUUwpN3eUiEIJZ9tGr+USWMlxXVjj9XjjkCKXQVHnFC8Q5dM6ZLZqZJZNprMRpVMV5LpaTKXNZmbVTLrLpndKpkVl8xmlUxPkrGajINlXA6rdDZcOntVOqsuna0qHSvpzGk6VzWdlTqdTZfOfpXOmktnu0pnjgJsKxH595WzWTu7tROqPlERZuOQocWIaVUjpoOXZTi7+agSp+W5+UuoYtIS4w0JrKNEipPWWWKkyI4qIV6SCCFEcHnz/Z2F7P2OQ9rfcci5pTwRZR0XMtGQsQC8MeRYkbw3G7djmPJjRfo8I48V6Uu5VPezp/A+nDdgZaO4/aVQ4RklQt6uybu228d/XyKUvbso+3dRDu6iHN5FWY6GKdKvXZsnjwU7BtnLgt0VNN1dg3dxzP58Ej/rJp/AsxthbCYB2jyQD4v5BH42TD5tp6V4lhG7+bFBX8xiDCTMzXwaP5sG0M1Sbgnay6cGfcvkLudAdZkG/vNAgm+E+Qz3GJMfx4Me8XAYzeYnXLQr+SwzSyhUcmrQx3MHkmDU/TA/jt9tk5/GWx9BMpjEXH7GJXE1P+uSWAlzy1KgtGE+Mejb41A2HOAhBhVnQDrx7RTqaK0QoCgOcyR9O0vyWSHPDPr2GLXIp/jxBD+ekY/HoMQ+ZafQMTN2pnJP2+nKDa1k5560k5WbnaruESiOwBzStFhJmhHjSVSPH4FuyZwdgVIJ9DGLjQRYx23IsJxTBtNmIr9b+rurv3v6u4Ffj8O4rvSdI/TtI/79JFrsfnVom8U29Gewd2TcQnrZNPeHbIbm1pJsltaak+wUTaAl2WmaT0uy4zR/lmRnaEM6yXo0gpZkZ2lyLclO0F5UkpHzZykdXZQ/F/CJcLL7ephP1Yz7qX4Oi3kbgAue7H5HOKRTf8xTlX9z2JZ59nRUIuSEAg2sw3OMUlLGZpR7MkPGyAZM/TBhnMk+pacMep1GvVfpoSAW39QOYoIWw37XBfMpei6YfxHLy1gCUX/PvSfuTRiaXG/U7m8V9yokkUtx78V4YRP3OuhruBisNfDCxoy/Qb4dIN0VL62v8ejLXlrrnvse+THuvfIDy4ScZnJNVGYznjOXFQtTpF7IFBY5lprJnKjgjAtn63ALdbimhOvW4ebqcIt1uK6ECxRq0+Vr63wdk7nOt1fna+t8HZO5zrdX52vrfB2Tuc53vs53oc7XMZnrfOfrfBfqfB2Tuc53vs53oc5XmcwyaqTPim0RpOeDe5NCGrE9abv2LEBDT0A+grCj+UmR07kP2Av4dAafaD88v09Ees7ZWUvI0mmcimf46ZwArW+mS5Jp96QaqU9FzAeTOhUJH8zjVIR7MHVTVBzIoHlTAO2Ehb55jQK9eEve2gvkQrkm/m3nhwlgZin3RogTuDxh8NdluqFu5LqpbmS7FdXKTcVOxIs7tkF3c2/i5h7Jzb2JD2Hxj0etyDEUW7AjWix0328juZLXBYO0lCt0Ns3gouqyeU1LCm737r8O9YYVFPtK2xMaDFYUyz8vtH2hTbpTcWynYWOo2JU4QHYNigPnAT7KisR051/IaCHCnh/h0I+w6kfogscr44QvB1ruR6LVP9mvHnS2UJO1n2W0fvV8sw1qWVF7Niw+NlanBIN9kSQBW32xxIOZvlhedmCdK6aATvHrsxLvT0PvrDj8pQDscdUX3/2lYEkNWsK747xdGR3OK3xs4W0Y4W3IIwoY5N8448oVFt84aRtkcXT/NJTXi31hYLwhRW0Uqx92/i79m5W/R/9e5UfJX+tqyYvdAEOqCY5ZU4dULEOqiSEV40MMjtzqh09IzzaKtQ8r86RJb+m8XXo3PlzxYRhxExEtP219uGLCwLvz4YoJA++u8y5IxD1EBOf0tZ6Ni1Y9iosFLbN5qzIbSWH3I1WZ9z4yVOb9jwyV+eAjfpmLw49UvKOwGMBiYuLNITTn8ker5MLi22Uk6kNVo1jxP376+PDHVf/jD095Hz15kmJNQvUl2DeN3CuYp2JW7Hz0hL7NIPzPTA/nuefnWc7WHxvF/kdPQBOKzMdG8SlJZlNGUfz9bnQdfLRqH3gPP+q1z9e3dSzZsPil48LD45D9q/iwRw/ZdFkT6/t3hnnjudHozZYY6rmG9lzE9weCOUnXNR+JLkuvNWnAqSuuq9JXzUeiazK6mo9EL8rAaj4SvUyJvOIbujYuGnXXdb86zGL8hy5dH+Had58NinU5g8GeSLEn5HPURBvJRInyv8mmkezuSHYKmmcS5LQNig2NOWObxb6Qj0P9TJxnbFBs/pxbb5vFgZAxnLfEeRarsIaYtM3iUMgnYKVKnBbLhYaYsM1imRe07JiNix0JkWF90RAnbbNYkRB5YXWaxMPTpFFNE4Dn5PZkP8/tSZv185P2pM2vz+Yn7TGc44/ZCWv7vFEduz6bT+A60M9P2Eng3EzaSXvi+mw+CcZSP+/ZKXuGR3zbuz6bT+Eq0s+P2xl7us+L1PHrs/mMPYd7wDnbtffxjmfPXZ/Nu9il+/l9dtrO9nk/u+/6bI4NZPqFvDnLcDPX80hcU9fzRFyT1/HyBtfE9bwlrpPX8zYnQVzpLVYic+qYdo6uczQr4QrPbkxz1kazNpnFk1tr1rZnhRv/E20bFwZTx60GRcknYdmDBvpALPvPoNiofNvXBmWpr8g6rX950p+mwZxZ+ZN5HN/C2PxIgFn5/ZWqc9CRKF91zIsCFUhw9smtN+DWm5pb/7kg/jl5Ppj/XDwf0NVTGRMbFbH3kPD1sQlvd/CQsByqjjmOG0CyFElEClwZT+CKgoyN1/IEAlYY5skLULZteh6RpMLLkboazlWWeTwEANPAYfaNQZ7cIZZEcidrMl6WwpLbyr9xlsrUPFmxWlHUQFmxVlEcTEELd7oYQF2j9aBr4RKY9POWbUJxoDHIxxSJILUjVDcAraPgB23b6QvAQYMQoXmb+geIG/cFrWDMjvYVFoEm3IFzkDB4g+KUi/Sngj1t6VHgaGLMXDA3bVSU/ya8YD7gHC8BmvOCeVl+AFDgJCmBXxBeMH8CX0TO8iqd+3D+cTr5WHIFzzMBpShx1gGcEn6X9fem/LwsPy/KzzVYQqXo4z+MTHzL3C5CPmny3BnbuA/BM3AX1CKa8Qndo4TeUYI9Spg7Spg/Srg8DE0KIfW8Mu99+wWlLQCOR2MsauwihbZ/ZQn8fVCoryK+j0hC0fvJ6/KywLth7R0NPaG6FzDlGlmKJWQ5zRtF83lCtzaohb+c0rkXyJO5aNaEOv8EBVH0aUKdf3RZ0aJBSwgHFk0gujNhsbCUhzy+Lti0WLxhQ7XakcLVvRhdFlfvYnQFrjljL5irwAvq2LTzo0ko9kV3VH1hTdUX9kJVXwhFfeFl0V4IRHlhQXQXdlV3oVTdhX3VXdhQ3YWborrQFM2FRVFc2DOiuLBuRHHh4IjiwrIqLnRFb+GyqC3sG1Fb2DCitnCoagtbqrawonZGe6K3cEX0Fg6MKC5sGtFcWDbD4PSrCk5vRXnhqigvHBrRXtgyor6wYkR/gc9xokLxhCg5PCnKEU9ZXQQjFeMyAkxPrehS1sJEdZVLkdpOVV+YXmDUiwIvvYAbFo1aeufzlqq4qkFEhXx/ipDvTxDyfZ6Q748TFfL8oLQtYK4JvDaAfWxMhLaEkPQOwH6OoR9k6AcGaowRuEEV7Px9DJ0zdMbQlqHPDlT+ELBENiY8vQO9n2Xokwx9gqF7Tuw9wstXTBj7hE9hKR8aHET+JENPOJH4CBCWMbH7EwiY2xTg+LaBFVGA9yFDwtWx82pQCUM6kzNO9FFMztTSj2JypoYnF5MzNUK5mJypQcqht+bjlENx7elovrPdDk/fElz1bEZA3rNjgv+eHRcoi6wnIBfZCQGyyE4K7KucY3cwWQjwmp0StI9sWuBqcZjl2JwQYFpgmKoCDxFuAZyFiUHsiyuQKcHQHSF8bjZG1NxsnPKDGcEwmhmZCcBXhbxiJuDhWYfShpmAVWdi2TiLIKUFXsUHQ8HoCCphadqlVInoSEHhwwo1VfG/CSXudLFh61HVxA1xE5bF2XCa9jA9qSAAQPIWFTMUfCjTlFjUgogNsQxIZBMI+7INh6HUse+mdlwwUBF+XJTAIYEyJsinoI45VfUUMOM0Wjbo5yNOoR5qqdjbSW0NFJ4XKCExbZgN+nkyqMGEKxOgKC302ZoaiuDZwNLGUs9ixyw2AA3qcsd35OTRtmdsU8st+K2M6dTU23aS5iH085h8nnQq9sAgbWpNBN0VnyccIkAbFoO1SgLkarQWOxVAsVeLpp2mmguDtzS4VAdo8Khi+/ps3nwD2qC7Q9Vp3slhPSOfhnKUq05Lq4PjjSbhlO2n7ZRtuHq1tF42wds5wk05xIBpO2sbroItrSDATSVcY1Bbc1g2XlVasI3s4o24eBMaT2rZRFugWV6YzVtvAKAdEAneSfBODlD6fNqesB1XpxFXpwmtE2TCNC2HGzBte1CXcRHGXIRJF2FKIjQGtYGHLb/0HXvcjroExlwCky6BKU1AqtHCILYdO3J9Nu+8AVXc/aFqdO7kHTTAMTvqKjHmKjHpKjGllcA5W5JsOMwDLnZe4UbtjO26lMZdSqlLqe1SSjQlKWUHSPx4R31h9g2wWjubCRCDIr4WQfrKyIGaimkRsCCLJkTdIv956LJ3/vIM8BbNG3k4qwYoAEN9T9nZ9HkJ4p30hr4n+n3hLb7H+n3+Lb5H+n3uLb4b/W7f4nuo33GZgLAaFuJiuuh5p8zrs7iSCqoijR+shYTpg6ShDQVfcYQieJA3tKGcOMM6PG4hznZHolmJ7Y48lcuHWu8AkumceGG/A3Cl8+KdU8sYC2xpZ8ZD4UV5CHtD8NfCYqHYCoZLryUxLDk4hJSRFKH/RCX+Uyfubxsqlt8UmXzs/KIF1HYqT2W/o1CxUbdGnsqwY0VEkCgaf6hC6Tq45DcLXpCNNSUtW2Pf1VBX3jNAiz4W/J+Ls0OFT6zpAGCm88nYRLdDXIUXl3gTDubM1iJkbwlcxGvCMzyZR3q015bp6RDn0V67Yq7qhfmqAxa07R0Pbh78sROANYLafqTGC8QSQWxN9yvQ536QowH+fEfLNsqjkli06cqVXbCj2AOhHFFTeSASZfLKv0y7b7yWORLsi4didkLD4OzKG1cVBBBWUo86VISecyvKewbXnVWJ7UXRMUmeozQ0jBd2/3uSCNJmE5JsMnvBNB0u3dYiBTqpU0zUqfClJXI8bzrTwQx0mUKbQRF0AU8bdm+6TvtP3GWPRIv/SfqLk+tc0Pl0GjZvU48VD9U79y15Jx90pNP3KVKizppHopsVd2c5rNg7K2HF31kNpfgGZ0wpv8ExUyqAx/VQ5jrSD5+OFnDDFynlsIheyVqFHBfDG0UEgL6wuPUKjqZQxSWyYGOJuv+JyPLEYo9auU4J5LlfzRtiuNkjdu9F7L16JHpUxEtQfYOh5qazCd0SIymS/VtlvdUQrOCIGLJ5alsSOXgs2D5HBGHzWPD3jUD+fSZ8hRJMDUDM3qP6yVs0QbE9s0Sk45QQA5E0CLk4Hyiar9IQAcjhq3nTfWvy21L1zdz1rY4XvUU8bZYUzZL6zcJZocXYnqmL4qKxQQT7oGoQTsRzWDDYEM8RNpH3g8ujascxZkOgPb6YHMjhAYBGAMtyE1i9RUD7nXWPwPL0XYMhvddgSO81GLzobzkYZGlwAyIlnIgKWqFwwPZeAuOhApCO3FIhbdD5WMOMyQK/HN4gi4uLRd7kOBBADIXVc0sOEIOAZILhoo/D4StZuwjEhPkXsJ1+mwqKtA8viCBdKygwLy0V+zTUasRiqIJBy4bOZBkY4nGVZNyR7zDWnhlBX05sR1qjzfFsu5KuqXJjdpKIWXIw084QsxrplMrixf0VKmk2i/BGPvJcvIjhIAonX/kKRzu4j4fvXqqQTkJpbQqP6oymYdeBlDSlKv+S7cpN0qBKv6OwAOzmeGUVBfHZdmI/Q5olWkJpVI7iXgmh6OaLiDtobmSjBbADmlRBGbFtaCGEr2RjEiPOx1Ft9jZRTaATP4rejFD7jqCaa7cxCopGEdmhnk2sdpqHHo6e1Chq+FaNwnqhtFcbqHLD9epYvOg6VKIr2rjLES3g+rfu3DZGetuOF9EXMZWqf3VRk9qNyJxuYk5jB96LlrJIa0kpivClJW1MBUl5Wo/vWNUS73ty9Lt5m+/RZ/luMNfRDjHaIT6ywt27WKtYhEJEU+OzOrs/ZcLktpUtA/HmzF60VBx+vqpyMbDRGR9DoUdaIYHGjS5lm7TQaxNr8lQ8Rk0lA4EVjNh7P6vQZatNd67ac+erLXehOlmb+gmWXy7LsdrwCfaKuK4KiLHhE+w1cb0okMWGT7AvW3couFkfCghLrKcCghGbh6LV8KJAEJuHorXwogAPm4eiMryIAzbd6+FFnFDo3gh5b0vzSNpL+4QL340LZotgw91bnU9PmvHbLT0sQ8FE9PpEbWDi6ejwEmRYFm+oBKk83qxsAZ4KR9Qpfc1RQi+fFsKaEizM+IBQKmFObfwU60qYz48r6OnWYm54WKwvCrVAXzZVO6dr50ztPFY7j0eLdtKKJjklBycA5sEzWFLsnRAhGWKMT9ik2HUE4IyDsOMIwBoHYdsRgDcOwpYjAHMchE1HAO44CBuO0LMnSFh3hBOqWyCaSuAgYUi1IUs4DxtCon8zI1o5x0RX5zjGadvytNu2J+RQ2e5+OUFtF4WzWS4Kp3NtUTifq4vKuVwUjubyonAsDy9lEx2xBb6xKCwXci6mqPwAUVVIioERfAyc4ePgDJflG7CaxUO8w+14dxF2/1yevDP4x4sWN4K6+U9AscfwFVIAp6GVvrWYJ+6chr5XFfWRnLxbvFRwjCi3eK6PNwsOI6XYPl4vONKU0uvjIYODUSndPt40MFyV0OzL68bhJWFBZz2skzj62JQnhCatpssSgTOCJe/5IEK9KecEvgylnAa0zk0pJ4jTUcaJ9rkNQRjtJI/pMS+9DJYwTDIgZFrgAKth5SEb4VqeyrkjdecOHIwAede0EyxVtTs1ZDuJZdNk6WM9W0yI3fYJ6po2X33rMLpTtQpu5YGsBiMoEWLrduVyrfYnScg/g+jxXPQ5tUMT1ElQg8Mb+ZicQWLR4P3KV3jIhH4fziBNrWMsGWIhxYGvOZQbbWQMpNwNq8XHKeStwps6vJHwMaobu+qmuvjFRzIO/cPIWyaGavA8kuA8Mm6TDNvamB3FwSN8JROelg2gw3tDrKWwnrA4OS4ny6+UPm+5s0gsBXAoz+Akeb0tndisThnSsxpFbZHEehhrHj2LaJVHpMrd+iwi0Z1pGs3RO4s0604exb48iuVTziJVP0cySqV2Y3IWSXAWGQHXJpLbVUuMU8isarjNUq2NNGqjfLEcShoSMJWADRcwHQ5ofqcBo99JQD2vtHBeqdoqUL1SKXmxmixpo9elrwDy9OQi8q5uOjkWBX7m5WdOfqz89OSnKz9N+ZH7EJs4/I/f+Wpnj5ugLgX1Roi7ETZCc3QjNEc3QnN0IzRHN0JzdCM0RzdCc3QjNP5GqBcaWUwi2Qgj2Qgj2Qgj2Qgj2Qgj2Qgjq2wfbITkp/7uGr6Dm0n3y9VE6KJsFDl3RLzsLlbOFXEKf221pq8pnY/INXndBXe7ZlRsGMhl2LZwjb4rNsnt9JbgZiaUSEiVTUYrEDHPu48Fwajcrckmhp5Z3hqWqIhUcurwkpj8kH1ebH3I3q9qZPLmKV+snBJEmWxOjg6qJMjjBAXBKb2+mI/gWQlC6fkoAMyAt9B+YbY2fCDFaNvWGxTuWgQ84Ihn4Qsyaa85XuLi5w/+FEO38ZYFREkRCxGpqLukNg9+yEazsr+17mQdy4aCgIQOm1SZhnOmh0dXB+YZu0akPrjXkoEs/rhMXFpSSEy50eXtPtGluKTmI8CAg3BUC49pwzWFFk7bs/rI+knVj9QSz415y3a0iulnr2Ir67h6qfS8Z1upsx2Frdsq2pU6hrbPV9XFNsIaTAggagwCYeB/4FLlLkwem9VxTWRp15skk8M9rfsqrpwVZyUuzGVhmtzIuQs0uAuE5J6YG95G0FImgymiJW5JzB/gNNX9FNxs3ilDZc1shC/AjENMlbN7kcv4nuTd5Ag5q1b2BCt7xTRrPKcGwOpC3KMIjO0v6w13Z3KhVmtpo/eP0vp190vlwvQjixQk+pGqUf+gRmVjfsCmKpn17cbEtzu3YMKlatzUdYEeiyE64M7CZFvqKRiiAe78C7kCd/KFrICeeUXOYHNRBA0OL2VdNRwkwwNI2jktvh5EqnJ6GOH5ErqreIeXxWIlxnskHl1iCnRA55S2RiN2RUvOuBHPuNFQq/wtHDdfg+hfET4v4oUNGw7+1CujIZVrYzxHNkqY6eCxc/b9HDdkcKbPjxoAHWMKd2zc+WfjpnH76VtibMI8Rz5uj5UQYEmrFiHab14o5kTPHUJSxfxSnkoLUQqrIS2ER468qU1EvCyRZsaVPpvgbTybFPZ6xjP9HgQ/DEWveOzfMWK7tikqbIui0XZTFNk2QlFg2wd8q6HoVUbFN5PlghrJe8Xl7D6542fnqOACbAJDWasHmDXkoQxlsSji0hNtuCvZQ8INyB6mKgwwCgxlrR6VR4bsMeYNuShclLKTZD1kj8tzQkbxmG1IRxnKuzzJvE32FPM22Tt44RKNvWvZ58nLQ3aBlQZqgaHUzALzNtnTzNtk7xRpMNr6nRc1vxezd8lbRfZuVh4oBoaiNu9hEUzGa9hylC3aUMUaQ3sKY+JdkGZ4NwSHACHQAZoABIou4ZF9kQZzy/yUyqTMIsLnIcIFiXARERYY4WlEeKdGmBXTFicR/nGEn5fwTyD8kwz/FMK/Q8OfFNMYJxD+IYR/WMI/gvCPMvxjCH9ew58Q0xo9hL8P4c9J+PsR/gGGfxDh5zR8T0xzHEf40wh/RsKfRXjL8BnC5xr+uJj26CI88ZEnJfwUwk8z/AzCH9PwrcpiO9GVeTg4LqjO1PwSxueJgdwgIAzG28fsgGd/SIqVNHQ1Dn6yAMnJI38oIqNYl9IP4MqwHN/Qe1Jb8mwJNieYuVedt8tb1DXn7Q3APnrRee0AzKOXnXduANbRTeedH4BxxO6mf2EAvtEKsQplCB3X0XxaZ9QZMSx9VoeplUma6YzhLFyJZMJTBsyodCKn9Dkdn/fLLH1AZwxn42ok68OqzsrVUKZlV6bljpFpeUVm5Y7OyrVIlpM1nZ1roczOnszOXSPT86rMzl2dnWUki0+ps7QMZZZamaR7ZmiW7uksXY9kqVo3MlvXQ5mtczJZ9zFZOT1P6RrFaboRycK2YWS6buh0nZfZeqCz9eVsUdeoAuNA34rZKZsKVZ63ZUXRF+mOrG0K7zki3VeW+vI8KuuH4J7nY7KS6ds2F5ObNXRniVF9TGW6WkA9aNt3wzDs5wN8+j1MdNRegtnqAgjSi0ei1kNoGlEvIuoCoj6tUd+JqO9C1FNHolaDcYrGihHzKcR8h8acRcwLiPl5R2JWo3oSMR9DzPOIeVJjPo6YTyDm/JGY1fSYQMw5MZsrxowZ82HEfBQxHzkSs5pnXZprRsz7EPOcxrx/QHvCdtw+cCRmNWGPI+ZpxDyDmGc1pkXMHDGzIzEx8zsUYmsPKHBU1sxELlJTAzITS3ITyUzU9aXzKw1jbod6BG3mhkBVQcWmU5RJUyHgirCuos2aCq23FDFdRYQ0FQqtyOfWQr8VYi6ydwxt9ypjFNBRMrzsZXilzvCqn+G1OsMXvQxfrjO86WfoGOZehsthneNK6GUpUgaS51roZ1qGda7roZftRljnuxkezXh1OOMtL+NtP+MdL+PdoYz3vIz3/YwPvIwP78p47UiNjVdj49fYeDU2QzU2Xo2NX2Pj1dgczbg8UmMv420/4x0v492hjPe8jPf9jA+8jA+PZMxNyatj5Ncx8uoYDdUx8uoY+XX0ZNY3oyorvvnhmpCHmaGUig0rFoA/uE0lZx34Q9BU4taBP0BMJXUd+N1nKuHrwG9cU8lgq1mMYh74a1ow7sJxR+BIAxtTEvyXY2NuN2+J7FiApdXpVyyHlYLFSlhpWKyGlYrFWljpWJRhpWQhU2ABUIWEOaZprBQ2D/HoVQTvCjcNAfASd01OKZIBwYUAJqh37luSN9kmuWENJ6VOE3kioC7nIxFOJ1nk0in55oTSSRd5dAkusugkL1Q7H6Ua9VIpEIa4Prsa0D5DW1QXOqL3MCJKE6Nyxh4TdY1xUfXo1nVqaa3U/q9XmYVBXw33oky06twRz9ygr4Z7UYlBXw33onqDvhruRbUHfTXci/YY9NVwb0NsRHeHa1O3PCzkruO3o901oj04qp06pv08rl3flcHQ1cYfdy0/ps0+WrX5iDZ4x7V2W5u6VZ8wZCB0OusjZkxeNcEyGTkXiPQiR15Sj7ykHnlJPfKSeuQl9chL6pGXqETZBpyUUCqCL/BVj17N03cGf9/YlMx/AhriCg4BH7CgIN3TIWMPWIjRGzB5Ryb7OwOMWgjz87azYWppFe3xhOzsHFgJNvVGcYMdn9abZ+ptnmm9eab+5pnWm2fqbZ5pvXmm/ubJUQyFqfqJn+xJm3T/gqACCdg5kXvkBVEgePiOKDhz8poIz1qY93BSAVhRmJ+gVgrgiUKo2A4UL2gWiitlCdhutAF4UImTAyO3jDJfbX6N3st3J14RKPEFyZFQGl6ljCi22yh6r3LC8KUzhZb1EX9z2F97opKFoa2OLHSiTaO1MA97KJQZuRm6SCKMhhhiDd0JQyU24roFNtapCu5t8EIeciDQiOYIVFnxVoNBI61AZhHl4iaKMBtTES43+VWaWNb/GeFNd9EBXOKPKxPboum5jJ+QIPNodPS0a3FZLsdZgKVs0izaCZRnDA3eLQS4tznU6GNo9CkVVRnVIjmRM/CBOHIhKNYRRC30DFikaprUppAsk29D1OZdVO0VrDtCONIzo+iZUTulj2DSM5J/VSoWS5C90iW5sPhdBXmcvG27ksSkDex4Nd+iQR6J3Ns4BFeiWrFVl8X4ecKKhUvZmIzkbFYGd3ZSBnx2QuZA1pOJkR2XuZIdk/mTEe7qZmbEwpGMA3+qRbBAI1MNTjfVHHlVyW6qOXrpBV+vyRsu+NtNNb7f3nu6tf3pVgR8JD065dQGQjXlKn9z2F97jnRsgI4N3ARq3j3lNNJdU645NOU6dkQZst9hTCSmuZcjNayjrHJKFq2fWHIPCiqHTOyRQ0N4qrDiqx5E1KgywlKlHpMRrio1gYywVak0I+LsMVVLjPBWqRJihL1Ko5p4d9yAfGyxZZbIr42V3xo6+eTYy59hj4b68x2vjPim+9PLTw/yRM7RzsYyVyHaJ+6+4qSxvPcCUyxHaKu12LRvt24pvOq4AqZ2FQt1QuFNJxWxdEpBW6cVhnVGgFWhna+b2TgNkOnxZYx8aqxgsRxfcOCg0bd5HjgmxIPjy4SdFA+OL3i8pAfHFzxc0oPjCx4t6cHxBQ+W9OD4cszxnBUsOMJxhO8B3adFgmriaZGqmlQT71NqAH5aJbJmVErr2NPRTTGpvn0OM8VweYZsMgRIKetBqQrKBFAGpBaOaEAsAJsUHs07TjAlb8kzVYLVp+0e5vmSUK2lbXm2knd/4Bw2X0V4FVNsyqLWXvIECCgN0YFoQMftVyNiIUQkS5izSkYO5Ye3SFknVTYAB4Cs4eRApAE7v9o047dHOYtE7scGsm/tcd/Sa4rYRgryyVLkxqaGEASAkicaJpPuEDh1B9wfgAN08eAH+Z+ucPoZCJ4xviXbKRG0xwPBOMP1lvJuFa63lE8Mhau1SkXBFg8Iaa1aqred+SXRAJYzvRIXlkQPWE73Sly8AW3gQuWO5Fc/bQfoL6hMk7+gVNix5Fn/CjkNSoUdSx79r5LpoFTYseRN4Bq5DwI88IyKM6KSdpyN288nX39asFuBpZII6Ip7BsdQxhvnDKBIJp+O1OibBsBQQOwuQxxjiDmlQd5xjy+ugmAl4rFbXCUmKxSE34SU7wFHEeFpCX1wGMrvjv5uhzXwwbrn/lZxO8NScG+EYlkKbmdZKqJlqdvCLCKomligtFalYvBG3heRQ2dA/ZHoal9EDJsysgF92wcvHlOnpZQX+zml6nTKAVm2j/cA2ADrKOVmP58VAMYRpSyHfZzTAygDKmkl7Oenh3oIIw/gLdPsnDEBval6ZVp65Qx6hYIP5EdP170ypb0yTWhJ6ZWp1wUBirNpSuS0p/ye+M/SB5PSAdL8M9L20vLHpdml0XvS4tLeJ6SxpalPSjtLK89KE0sDn9LWlbY9rQ3L9ScqlilLsSJaXnfZvyHirCBehHOmR1s4AwIsqB4bta7l9NtU3/xg2CSOxg8Ywotlh2ItDIYN5NSxukOx5oZiLQ6GzeXUsVTDa6iEdqiEtfGcoyXsDZXQDpWwNqVztIS9oRLaoRLWhnWOlnB+qIQLQyWszewcLeH8UAkXhkpYG905WsL5oRIuDJXQmeD5bXMPO0i0BhQAnfL3bbx9jm28fWcYRrcExT4WXPpEgPBx1wplvxX5+6a4mheJ9GAIhNIT8Jo5+ZmXnwX5uSw/V+TnKjfaSnV6bvEOLJBDAzyhenOeCouCJkUITpDHpdoQhGwgP9vOPzWmdct8pVWBAUitZ02Kt2cjFFnPWhRUz9oUcYd0hQ1VfQAoLuDDPUTc2wCXCaTelQqNaw2BUBR5AAz9PFVkjtQDl02tAb6R8UgNtcWMNTQtoeN7GW4BvhhzMCNDiZS4iV6VoixIAxmbysnBptb08T4b2JhtfVNcTSIHwSXgQWDObUGcpQ1OFCxh8jQcKDMvABOPSrxNnob5fVX9QCYCs2857HxfL0xuFwffaB4LgufixfuCouzeyINzQbHy26FIOq7+dkjbMMUaHMVhu/vBMIuLja8z8n3964bghoNi033Zco4d59g+GnbXfdlzjt1vVMf+0bB71ZdvNL45C5a1+IFTxWR3kMiwW9PfVfx+8Hv/6s98+t//5CcvXQQmf/DMz//oN31y73vXfuqHbl/EvSt45qs2v+dXf/Rrf3jjzVyW4d/9tZ0f/dRHfuX7L12EAfugWH6QrX4A9+EDdO/DfSDuPbj3xb1LBR9x78C9K+5tPgIkgEtdTZZqhfuvCL7+N//dz08RaBO2ZIvteKn7FxUxaiuW30393cDvj/zK133PD373+v8GBGj4v33nZ/7GL6799EdQmxKEf/1XPvWPDv/FL38vCGvIdkOKv8oiiHsF7lLcy3CvifsQemerWl24V8S9D/cB0V434iVn3u+Hnv0HP/nBB7/le/4FXjDWWPz9qC7+XmSDZ37yb37dV3/V3/nGT6I0u5F82MHvN2z+xu4ntj+0iw/bIPzTn/5XX/OLr/+ln7h0ESYZgmd+6lt+4kM/831f/5FLF/GaEhR7UpQNuHfFvU6zJeIu4d4W9xrcW1ptuDe12nQ3CVobVdW49Oz/s/cX/qvzP9VCL2zCegvB2V01lrXUh8YGOuw+/NOXLuLKHzzzib/30a/51Df/ZRRyH/7f+vc/cfChT3zXz166CFZB8My3f+Iv/b3/+c5H/m9WHxCpq3MyNuBeEfc23Mvi3oL7UEq7CfeB1hrufa01w7dRzgPj1eI3fvqpLzTfO4Ja7Bp8XTd1LUqU5t/91rf/wj/+5W/91KWLeLera4PSrYJw+E/+9hv/YOtf/TinBgjf+Zt/bfkbPvohdMoy/D/6L//Z16789Lf8CAIcgrWzJeU+gHtT3Ptwb4h7j29M4t6Fu9T6w72m9Sd+b4dzw3iD61v+xl/5H7/8g5/G4DoMOTdCb27o76b+Yu175kNvfMcP/9YPfvz/QOmwCD7z//L2LvB1HdW98Mzsvc9D+xydLVu2jyQ/Zm87iZzYiXg5NhewRrUdOybEoSE8vt5fQ0NpvnPS1jImNV8VS0kcIxJCRAhFcblwdFyIS+PWUNqolGCRQDGvoqZQzOO2apuCKdyiAr11Q4k+/9ea/ThHcgrtd7/kZ53Zs2dmz2PNmrXWrMcH7vnQl5/5vY/9GW0OZCw8PfmJyR9/5KvbyRpLmHnuAjCjOcdpYEczx2n4bjNnOX0IUMPJ/ehMf4yKzUSZNobMrMUfPfmL73rRh56hjUF9PyfSvt+cnI1DH3vXhydO/cPUN7bzifmOf5s58+mP/t1Xt/M5+rU//svz03/x9Wl0fzAzvu102prGRuoCTOMnOdmP3nASHPL4RuurV5ixjdZPrzDn++OD3ZztrDFjm/b86anv/9ovv+3b24ltJpFAcJckQccZeRt0OGsWk8nUQk+aE89CYZQOLDw27GOBH0/RI2LqWU/Y0pynLLKxQ4mxBa5wK1cYt4/7+XHCPh7ix0l6hDAwbo8M5hzWwjWT8VEykZw/71BDx/7wW4jC9mU6Ss60Z8y0Z0ynGd+kjFPtGSfaMxrtGZPvUEPTjz/0zffd+/tfooyJ9ozx9oyx9n6cv78tY74941x7xtz9auh7x//2X/5i/plZPmTbM2bbM87c39b1mfaM6faMU+0ZJ+5XQ/z8ha/xfLRnTLZnTKRtPM3z0Z4x1p5x/u1tGfNvj8mE2c/MMHmwKGduUc7ZRTmzi3LOLMqZWZQzneSMPcQ5pxblnFiU00hy5j/EOZOLciYW5YwvyhlLWz7GOefva8+ZT3PeY+cnyZmx/ZlLyzxo5yfNecDOz6J2ztynhgiGTkzfZednUc70opxT96khCwNjdn4W5TQW5Uwuypm4Tw09/sd/9cyf/NHn77bzc58auuern3niu8fvfKudn0Vlzt+rhj731vv+8dgX/5UoD2Hm720vc+5eNXT0n8/+/jfvv/9Z3lCLipzN5BAFOntvsqPOcLtn2ovM3KuG3vaBHx/9xN/+zhHKmG4vcSrzYW7kRHuRxr1qaPLrE80/On3mR7yn0ox/5z11r0V64/eqoaee/MK/feYP/vhOqjsWvzn/trQROwkxpmy8TQ3RiXTf1/4nRzE2jaC2QYBFgBcL4YPY9nuEedezMo74iCzr0tb/W2iNlCBVns2zVNnhOJ4qOCpZ1nUmT0r8DZ/CbnwqT6Kq8VwtUlsUfIrAtOTj+FVb1DS/nUWAi1OZ9KOcnsxzcAykp/McHIOEYDY4hmMaeQ5r73DcgSonz+asj8YrnLmcde54hXMuZ9m1K5z5XMKa4XYox7wZBFyWwYN0K898Gq5O8ttY/osQgLhayYVkjDOdC4v2qsWncrmwRFcwubBMUaVyYae9gqlwS6wkM47Q1MhHwHUzQTeosI27wjlFOZOcQ2Y+Z3JNqxQIftZnl3Xw8Kg7rI6xz14bK+yIrACXQeTvsdGAZzPB9je8Tq6psnerIMyzsJmFLKzyckKGnvVKmiPTHASuU+xyFLqF43BAlaNrFqU9KG7gotwnK6QmuQiElQ4uJfZreH0owkNVoPPwjDYFRUroA8GLnO7A882t1jWOmYVjaP+fPeWMriEQs26Ts/ZiOrEsM4N1K8+N7cgy7GQhtTzL5Pa3+UZLw8h3pcnuNFkl40MvE1mngyPr+BxZp0S3NRxf5lPSgjbLZgu1LWomTU7Hm4OzZiHdPZVJP8rpSZlKgKdlKgE+FUuATUMC4B0WxkZlNs8jWSzkFIP8MCGjCrk+YA1jirW4huMiFjhe41q++StyCMN1WMj41i8ffAjr78DbMsQmeSztuuZUpNkIMK9psdc2pxC/B7Lv1VjUNTrXnIoiNg3MI/ZJDmYp0IBnX89rkVNoNuAYDdLzNai1+gK0NuBIrUB3jVWKnVLexl6demCJ32RHgiW23sOVAHzp98IeH6+68Wp5bCsAh/t9ugr111XQyF8JjXw2O4B9boWEKS7kNiRM8cwZQV/sJOeX9OUx/Opt4AddxCCiq9+IroNdSFnm8Fuga2MXm2FWccMTjq6EXVqHgS6Gy3RnuFyH8L8frtDlcKWOwlU6B9UCuuVMQZ5uvD+6TgWjlwDk51bWo/wG6PRMBjFapUiS1dsin3NJny9ghfdpaC/kzXxnTfs11vIWUR/roEZrrGZqtJbd7K5rkj9XX/dgLXp1X5P8vfp6HRRN1ugevpnka0Tbw7zpr4XLKOwBqbWkJnDhmjS5Nk2uy/gcSJO9abLPGdQ+hpPLDOeEtIrvki16pqF9wePKWf3FDXwNcwmcQucpG646ndShRNUaOPQ3cNsD3wxrdVVf0ow2NqK17KVhna7qDc1oUyNax4pTp3L8AQ01nGiD7iNQgby4qlc2o0t0rwUrZKxoRpfpngbfSiG8b1jiIYQVrJyqRx5rtSHWc6QYaxSvcPbj9uss8Mg5WYuW6+JGZ0xeTdo2uJzrRsY4ZyB5iNhqj5jiIu5+mAsKA3jcouiXdJ3YYgS5XpgJySHAPdhYdmmOIUiXOnQUl9niqQwp6mr8DIYaP4XwUvzo8HL8bA2v0F18cVYEyKxo4qGKB4Scw8MAHqoRaS11mHG/FnXwzSqsx1boS7HpLsf2u4JKsDP5gN5V8W413mn7LiAhbAGYcVzCvBMmZMUt6ggeylvUGGVuUSP8eAgXhnDiTj+34QcXtPDnXiAVotoW9QZKziN5MwJjkMd2+sKN3Mg+/tnNjbwcVm/4apnK4w193DZBHShwBwrsB/4QfynAKywPzfk8PKeYs7JG8x8c1nRxn678HGkReLzQcEvlMRAUOEmcL7RIk+Xu9aF4SQgR8xteSo+ErpSZVQRYgs1czim2cxlzws004TbCmzU+m1ds0DLuhM+jOWdDnDlrZXZeseXKhBNu0cs5SEc3RwTxyJ6lysHuoO9UxVZZobV+IdbyReyLZAthWN3kIgFu+1frK3mxB1DgeWwqpldwEX2pvhxvr0D1zezKJFpJbxG3naK+ezpA2EwPax/wU4mfEJHM47U5q9L0lzk9o2pb1Cyncex+gZNnkX0GZ9wZBXCgr3xKcosz9ndaps19HOmSBUZURIHutK0gLVqi5BlV47DzBQKMEogCe5VNmgAr9ErGriWoMNg3hK1XpW+2YnrJ2qKEzVfVq+M3Z0TyalWaO5vmVrWOc8+muSvS3LlsC7oZrZpiFLdSr9Crm1FVr4JxToMLk7Y6tzulbSb6pPVKftYAadz5IjRQETGOzxFkkmYyX+0r3WnlUKQU4uGR5EWk+9GBx4AfdU0vS2KoMSpSjIrIhmsz201dGStxMDS/hq2zBhiIdzMM3xxuIWWBsIpgR15ySqyyjuZX4KAjNT+BAJqkKcAHxSpEGu5p6j6EoiRSh8+LVYDiPpyWVeRfyqh/1rHHxgqcpOuwgrpHvxDFXoQ2eEtcHZ8k6ziYG8pciTIDKMO7YisfLith5rMW39CXoxtXoKObWe8z2sYfbSj70R5YAF2qeyly5lV6HUyJLgM9pnv0RlhFXnjTaERXwWdQH0yMNuBo12EjCjEaRM3ZgOjMfc2pRhQ1p6bsFWkfkPdqKrtKP1+v4arrKNrmJphM9lC7z8dURWi8h7+MjqxvROu5JQynF1he4wN6lX6BXsvfW9Oc0r2wodpIn25EL0B31iM4dJXrYpjApHaYWxEYu5fifNKI11Lo0ecjdDVmPMKMh5jx9TzjjWQg2xA7GwNZw2NaR4FDXwCb0xVU80rUHEDN58U1ueNXw2y1j8KH0hjWUGzRq2CcyqsTYXVCrM76uKaIQ1MzzSTNXGCDIElzlpMUXGE2CK8CxdDJkY5AyXTawEl5c4aT/aBKOLkR0cU4uQlhyDh5+QWa7AQnrwAocnIzgqdx8kqTCztNPuyARxwQWpIpKdJFD6LQbtlOu2WxF1bb/XFJTHfWEHcYwWGbULU5AX1xis1wWXNqKuwlTfZoPSYoAhL3iUFcpS/B2z5S+4k24O1l2D8rNGAsXKMvwVpv0JfRjG7Ei34cDz2k47pWR4CSEI3olYjEsILJiE30ep2+DJO+Hm2xhdlKGP2uSE6QsKo7Tf42cqM5J+D0EKclVOwUbGGgcnZW1MIiYZEQkcn6a7CUBhKFCarZWoOdp9G1sFtfcizs15cdCzfq6Fi4CZ512Gme9mpkH7CGTmYiyOOJFdjTOdIHoPkhb8xVO58+FTkhgSvI5Q02e44UnC1Pwx4j8rfpTv5CT+zRJlKsWWsRgLTU8Bqmhtey1es6u2/it1V++3x+i6AbneRaS+nVx/QGQPN67IuQ6DBswst4g21qNjDll+DlVbBxpNVDeY0gGM1GY4pCpyu9AQhrPbBfSHaJeiWOdNqcqxBvo8Hx2JWlsbljhaiHF5FgCRubaXlJ01OI+hlcCEw3XsAQFokzNIpooMmYK7RsTnOKw8+vYogLUcNHO8/jePN6pe4n5LXeokB6HVzAgo2G7uFvcSeAz+3cRevxFWq1j0GtEPXyuaBXEkqhzvfxEGccci0Z7yi42opPwtWpNZbSZMTMUZXoNMzpy6jT1nFRFTkR54CFRpXu2MkaK5ywOmTFOk0SjegKrgrXCnpZmr2Rs7cie3mafeU2qwUZ5VhVjrMv52yQFzk2Suf8fs6fpfwgzd/M+Wcpv5jmb+J8JjJiOz9hIbsz5vbGPHB7eiA7M8/LzAyvLIeayhyy67Ple7Pl+7Llk/NxTbb82mz5ddnyyUFTzZZ/frb8C9LyHUbWww44wwDQrgTX/i+RWj5aIA3bsuX9TKNYI8UWFyvQqZ3gbaD+xwo17Wx0BpjHczY6/Vc75/Oc1Fc78zZZvdo5Z5PB1c6cTRauds7aJG5WKUm2TuOgNxvc9D7mJyf5aTc/TeDJDNbtNZ5nTlDGWZFcrHlmrEg1TlmG9Dw3cEImXYU3y3l8aZJLnrElJ/hxxj6O8+M0PcrNYq6L1E1mHSvPQLCCABqgZmtti0LEC5qsqAByP084eb0w80X2ppNnbhWB1JkGR5o8TOXhWsjROVZQKraokHDuAP9wkCeWEOZYcynHmks5vp3NcZyuXLaJmzl3P/8c4h8YxVnXGPQ7YX8n7S+M67KNNGz+Kfs7bX9n7O8Z+ztrf8/a33Nt7czZ/Hn7e97+jinbH/s7YX8n7e8J1dYfm3/K/k7b3xn7e8b+ztrfs/b3XFs7czZ/3v6et79jdjnG7e+E/Z102voB3735LWoa+W/FPRfre2CV/y5HIfk6tqhHOePzDmX4W9QJx+RJGpkzJ5xa8KC8WCtx5cV13gXzpyIdz4AqAiHyXVyEqn1HDQqxVjmfdGLhA883z4OjwBIJmCKfy/hJmZLuYNOoJfKrB5Zq062FRcIfOTNfJNZJd5JaLHSgEX+5GYuW2G9YgWyRFUd5yrP/sALZJCuOE5VnL2IFMk1WHGkqz97ECmSirDhWVZ6dihWuwHGlONpVnp2LFa6Aco7ieFnSTC6zkT6lmVhmI3NKM87JPtzjL7MxRKU530XJ1Vqa+S4bNxThx7rCdXBwTc66ycd0oaZ7aIfrQo3c/YAfKkCxcS397icvJzQ0CaqiQAbuiI5VIPvzXsqaVRwpuxG7IIc+wC7YrGSkjO0fJu+GdMkDKxac7j1aUjfMuS4m26I1zamo75juOR5VH4bUh+j1aPUbyKXziS4WLR7TfboHFG3fB8FlVZvJHUHjOPiLvg9OhVVf53UVgUN74o/mb2OPprERMx8yed2DERXYrtkuL2WxTbM9oDirymbOdnEpiy2ctV1byupno2e7tJTFBs8DDY5+R7r1PQ9HPbpX9+jeN/SFrVoVunfHnz7+1a/9zcg3XnoLTKrgbjIqm6fFNWU+8mZhbuTZqWWmhYDZ40UHTz2bb2zj8ykGCeSeRe5Zzj2f5M4hd45zGaiQew655zh3PMmdR+48504kueeRe55zJ5PcMcznWIFyz3VBVT5P8plGEary+fXCBPWozEc1OQiHHBdoh07PfC0qIKwwXXJAZblAq08rBLLNp3WLBcBVWIYUiJTlZS2QubImoXmUo6XikiTyKZDZsqATMKrQEnE10sYXx/k7kM5TBqId9bAePmnoDx7nxxJkEYQNmvxid7NhbSdK/GJMHmcP2B3B2yUsySGZqjDtiNfO8RZTC6pzRsWfswYBM8p+z5pxUOa4anJxBOCzH83Zj3JcjTJuGTuC+2HvGZBolELOMp7zrnCmS3C/WIKorlSLLKZLdoaH8MGRxXWZ3Nk4t5rNPRvn6mzuXJzbn809F+cOJLkw7z6Tx6J2xqQZInFEJTz38/N0HkvVSVQank/la1GA56olqPKQtceiLA/X0dGyRNLlWRHYJIidiTwZiaEnCT02nieDffQ5yRvLw7SIRpfknc+Rg1/MQ5I3nyOJMmYsyTuXwyhpbuM8SJenS1c7cxSVjWykYm/R2yH2w17MAf+foALgEByGCvIrAON9fgEeIc9vivbNNL8Bl2AhKWffzPAb4hP4Tdm+OZOz7jPpSgJvCvbNLL85J+wpUSVRHt6ctX1HHmxn88g8JzkT1izLbMF5mxfA0anNO2/zqrpKnAzyxhTnaTgKs3njNq9fV4lDQt6EzRtAdDKbN6kYd2h7oQMoyOHvbL7G1H4jZ1faq0V+sjaTOdz9eGbOq0WlJHcihwsgz5z1alElhYtcLVqBJr1aFKSQkatFMJM849WirhQ2vFq0Cmvu1aJlLavuXe3Me/Gq08zNe8nM2UVelZ05u7wrszNnF3ZFdubsknZnZ84u5vLszLUt46RqWcYTBHaH0lX0SP2hYd1A2GUEzqDM8cw6elCtoM/IdCE91pWwTiLsSuJYosyGTJcSpxLDvMys5Xm6wuEVTdZyjizO01U8Szd46frN0gVeunJnJFYuXTOY5K3U6WrBpnOVXrROp2S8TmT5zRTZoXiZVrH/gHhmaJlWJnnjyTKtSPJoXmiZupM8mhZapuVJHs0KLVNHkndCxsvkkXshS4HaZfLIy5ClQO0qeeRtyFKgdpE8cjBkKVC7Rh45GrIUqF0ij/wNWQrUrpBHdB/lbc0sEEW44FWK18euzH7c1lh9Xc+uxs24NqLUaxD8kFL7EC6RUrvTuYcjkPMIhBLzKqyBxlc9UX5R7oTDiJduG2m3Ooydz0mbcU4xCj+RsxlfUIznSZ8Jy66S8O50Fp+gnbFFnS/xL980zZeSm6aGSm6azpfSm6Z7pW7vdXt/0dPBOr6KLp7iLqJz8x4l6fix/dRxVzptVzp/pq4IpsRipWWm1mK9ZaboYtVlpvpi7WWmDGMFZqYeE+MkudE512URYBlilw/4So5eTsoShVjscsJFXLACzF8V6eRsrQVvhXK3eLGAhQAXCe7Lgvap/BS5X0DU23knA9/TeAFZCcITwOLnvJOB9Bl6e8q+LW6DgUUK82fo7bR9m9sGU4wU+mfp7Yx927ENRhvpPjhLb8/Yt/42mHekO2KO3s7atzD/sW8bEho1M7aP06QUdNY+nSCtoDP2aYbUgubs0ykJpbJZ+3RGwmPdOYeiQ6QelhEDvLPlKWh5Krc8VVqeupKn15fJmY5VFLyHL1opvvq0w/e2Di5dEaho2qlFHIeQXC6WbADssg1p3WmDVFds2OmA4z9zdO15ydG1z9vo2mOKo2uPKw6vPaE4vvak4hAUM5IDbJ+RHGB71gbYPmsDbM/ZANvnJEfYnpDM405KDrHdkBxi+4QNsX3KhtietiG2b+YQ27dyiO39fAl0yAbYlhxge9wG2B7g+NpbOb72IMfX3s3htfdxdG24j/XMvGN18gTiNbpsWJuzzmVATkNhixzMgIqOCta7DBHp1ajIZqVENUcd1t8MiOXIJ29NGUno5VAkvAJKWps0tbIZCn1XQrfqKp2UjkWlG1D6EpS+lEtfhtL9KL0xLR3YG7q1KL0OpTWXDlE6Qun1aemqtcmsonQPSvdy6T6UXo3Sa9LSVlDOAVqXo3Q3l16B0itjnTBbut/aZ5ZQuozSnVy6gtIBSnelpZmNBrZw2SJx0mU7xQmXbRLH3TBHZ57LpornnTBPBeYdBJM2ZxyomZXYe8AMLaHPDwTwusNaB24jAyhNXuPFcSAQGDvB9pDNdqfI1PM4sBIsosjdGFvmUqxq8IIcafk4haIlv3HwPw5O0NMC6NqGmxDMCeZ4sRW77hHMCXJ0XfqK0NZxX55DdTe5FDGAHEL4OHNY2Nzg+zwzVwCafq8j86kJsLRO8awdcAGpTXThwv4bnMQ22GWvEOx5wbPZt/IVWwPp/cSGNJrs6I7hXlg2kr3EcYdddljh2VsKLC5TMtYdb1yHvckldYJMncDWCbhONanDbueSOtVMnaqtU+U6OqnDzi2SOjpTR9s6muv0J3XY90VSpz9Tp9/W6ec6A0kddo2R1BnI1BmwdQb8RlmVRx0K7HkNOfqQVltMWFdscRz4NAJ8Gvs9jfqexntn1Wppo3EJG9bTtryblaqljcNFqdewjay0cbgoRXG4KEVxuChFcbgEo0wigAWjTWvnKjk854RNIz7npE0jQGfDphGh84RNI0TnKZtGSMNpm56R1uaWjgQKZi74WKDg34KPBlLoEnw8bCMDOD4iiK8SfAwRPyX4KCI+ivuviH/i/ivim7j/ivgl7r8iPon7ryi8NvdfEWnG/VfkHIj7r7aRISEfh+TwiPuvyOER91+Rlir3X5HmKvdfkTYr91+Rhiv3X5HWK/dfkSYs99+BdqzP1m3jThw4J0dX11tvq/EufhiKiqSq6F3nDpqcVnWOfpk3ktz5O/VMEMyCjU0Q2AjO7ED+4QbtXv4J+Kf6cAOnPfucsrEECrHjRlfnyX1R0gw1QuXJ45QNT2GjB6iW0FiVkkNRAagOqQRIdnufyYTDJWnH4dlxqOw48lSYhuOQG6UCXN3flh3OVv7Zzz8n5MMNUDE8HgTmjJy4fx6HZ81xHEGX2nO4PR5XpW1c1uVjF/ySN6LKLbSjK3QDX0FkMVYksJJeClcKohgeGsgxnKswd24kcMeZo0BEcI7kUQrunzrYySWCNZHuFEKYhxU4WcJcQWWY/JAh9oRI5iUXx57I0wA8BhKmVzhECwUxQVuU3J8mT0hO02pkwxgW4wV3YkdjScNJs7yEqMQC7tjPWKArU2HgZwjYXy5LGiLHZz0Ipk2gqdA3OS2gJdKhg/dz3Kmcca+jQR1GHFcKGdZpw9b65EwqUogVqXTZisnIJZKdJLWnLJLoHMKoa6yvrTx13UYntYFP4LNUO3QmtmbTuBTHwiB+0kbS6AS0JG0pDryWVvJjBzqVjHa3ja9EnfP2kk9DyYuF/nl08YWRxvDs81b3kvBYXcdZNA0/V4mXKs60nUTo0XTyKeIwt5LoIVJxhFhhu87RkIBz9Bp/i3rI8U8qmRvJnLtVdnWkyNnFPvZ+79EDu2sOIhjKTMH3QpWCioCGkcfjZ/YuZb2dePh9DfxqEi0jqRmYZlALLh/EriVv4md2RWU9n1ALN8ctTMJRIRKz0rpDuUAoISIHx4SXTDxZiio5sJX10UJt3WoJqwbFDKfGzsaNXSC2uIUztlVF13XcwJhzHAd663RRoIDYn7S2k8YOpfvtrLFL6YH/cNYCzhyXTf7ehdlqcJcx6rTPNG9BMm/yePxMBJrL1Cm3tQ8OlXkJ4onkhm5NJq0QTxrTupZoE5bIsfMS2PbYdXN2bfttgwPJfIl4vgRB3SqhxSaxnOzbyI8grNu08HuXzsffL5fUCjZ9C+pRL/ypwWoKSmNhN0xBdM6M7uoLVyAOnM5TeqV2zaFhWAuFEMu7v2rUQThkYf+zUBoM+7CbD4ZQiPApUt0wQkdiN67Rvhl9k87XwqouIqB7BT+C4sdYD7bLdVmvoDvGUMH/pzOouxGh8ja9mtTIyN9w5TZdxlNY0hXdYZwD8XMnPavkuYueZfKciXe2XqtQLGnkoeFiMn3ckCYvSZNRmrw0TV6WJvvT5Ebtx84IN9JyR2sh3dwK4h8cbIinQ/zUH63DE9ToyFVOpPF4XjYb4Ubdr6niAIXwgBlGE2E9iqR+19BUch4l+6E8i6f+uOStcckTSclzKHkZdFDxpOOSN8clG0nJOZS8VEcEa9z3Kncv4L6/hp80933S9n2A+34WtSN9CX8niL+zL/7ORPKdWZS8RG/gkoW45O645HhS8gxKboC2nr254ZKDccmxpOQMSq4nu8gQKgtjqkZxfUiw5sPzpO7XlzRCrS/V61HyMr0BupkbddQII7iwDmphTnfip0cHuqsWgiZZxs5q89p/eRlUxxrcMBfhOjQsaZ8oLbamgflHKNvnLoy0TuYj1HpdMuRwXWZU4Xrd54edusqEQUS3ONFa61qZVepD65zJNinjKWZXUbZtGU8nu9yyH5Hx1JGnJ3wNxg4U0miwHsK1rILGlyXhlrFCROIXaEyvn0o1/pbptemLdaz53MM1utIXeoousfhttkbENTpAE3Volz2Cutrb3YoSctoNOwkldAIlFGKU0JmihI7W3btW50KR7r+17L3KAg2hXgtq5IXKAqiwBkIWynW8Qcg9ld1WwtoNDdiNand0uDaFtcF6G6iBcAlq5NSYIccQuIRSr+KokEwCt3QyXKuLAKUiQxTRNbjRXcWrUjXOHgKOn3lk1FNdo55q3hQuemqXuyNdnLVTuiNeNbgbjjpj8px1KrTDT710P+5/UcrCaHwiKKYuFdB/BxzkQaoE22vQ0MRTCZ4HSc7qFUWrdQZtGD1cZefh2vQ2q6dsWXqfxEeSMHvmBTgUxUwEuSJtpSo7dibh+WpLtgrWA0EFrNtWHpX/2Q7Vz757dT1C790NJKcswOZReya/uy9aiYwgKt4WrTK4qFB74PYUJEsQ5ol3DMpCrwJ8ehpFJChvxONcC52wepSP3A2YhYDj2Qa14KSMvJ1lSQ9QG8sbt649XGrkke3QuQmGrnhbVG35qBt1hSX6aFdZAEDw0eoSHy3RJ7uyn3TRtms/WcInKWpiyX7SDbt8M/YAfG8ZOQwvs//+DmXGxjS8bf3oHfC3cCe64l6tBMqxAT4uLV7ujhrXM+ffofqVMHPy14y63aiDkWNAPLjX9vlhD5UL15t8uIxgo2jyejmFUNHFa/vCgl5PWFYvw7/dfeEGSyAUGNQ6oCwf6h64FONaPdf2Rb26oxZegnCRuoORSKQ3hN3WeXgB8XX7jKv7jLu7L/R1WS+vhSt0HzfZbVz8290XrTZSrzby2r7wUr0aEXovM4JQUW82mPj8di11p15Ri9aY/G2Ro9fE8HU83KxX604z+qYIfD52RT+HNN6oXe3XICuHBTFA7wpGa2t1R7iOAgquQ2OubSxy9GYShTVJR1kN6svZWzusdm1VT29iLX9w2xVE5bnGOvZ32BNvpPUm7eq17NdcJ1olcXzni7wHBxQ6uoJ9VdH9vK827qQAog6HvYxcvQmuRrmmm2imrMPI1ulLGA9aNHKpDewA7UfQmzA/CmkIgLoImo8QkOty8BAisvn1yKKVpIbUPqbb1StM/rakZp5qOsE7ZbZtN9N2Tud1BDVH3Qtzf10OJqSPta7Dwtm6dr/W4uweHEqCe17Uy2tRxeRfURZ6OZtnVMBQQjuzHrl6pXb1yt19kbuoo47FNnEHC9pt66CT7V0JRtngHs2oEdQ7R68k7TaiWpbpYj1cpivRcmRI4nyr5s4xSYw5jMv7Ioeitxq3bn1dqEG9Ki2S18HiIqSevEFUfOMGInKCT2Bhz/5AGi+Q4r+a+e2iikbViMmH+edEp8sYnfq3Rcvb0Gkn/MKrQd1Js0+YbfkSmK1o0WnnRdFpMUGnxQSddgKd+rdF3W3otGLRaaUsdDd/tPui6LTyM6HTyv85dLqC0elaQqU4MPPaJyy6Flg0zVgHNb96pAl7tmLUFSkqXXEtTrkOYM8MKu2BUwwgp/VaM+bZoNdR4AYgni4OM1+PVhlXryIES0FgamHvhUOQvhAYF/9290WOgcwQCPYSK0BduQiz9moP2FrWo9WMXlen6PUy2mF93Iuq7iAhD/RVQ1eNJPQgCSJ7dZUlSq4tH60BskoDj0WXAjXvsiULeg2ptl7K+SrOD5AfIN9HLD/t2u5Err6ML6QunWqmur062m3DnBN1ccki1NdLsd71+gRJ9MApil6pC3oVXjlAgovxXxarFamGE7w7g1Y2MEIhJUhqrqwL2iGEEgDdBWZEd9UhftRdwHpdMdZbkWI9wwqkfj3K01nDGsno7TLt4ixeCt3B9ivf0jVgvHdfDOMVl8B40HhfVouca9lcTFxrEV13FtFVlkR0y9MiRd35/zOie7crO0ECs3ikjNQrKDyPgkzCJWFmHQ/LmCT2mSQuUTCLLni+5/AF0OfXPu+1TijuQ73/AD9X7LOyz4F9lvZ5ud3LgmPTR2BiOxIlctZzLejlMeWMh4AfAnqo8EOVBNVhPg5VYoMZ5MEC5+LY9uXdNsJBmWl+hGiBZHQ4DOLRgsHAUEs81C6i/EO+hTBqL0g+ipES5oCuoGuhS7rMQ0EcaIpAQ9TMMssgULyDqAPoi4XVsXcIEhxzrA82esZzcCAeHD9XD8TjQ4AdCibsYkQVjKjSFtTFfsx+Kv4QwrBwFGISETBJEySxqpDZwiD5U0r6Gc5oZJjGj4uGlrlxKcYJzU+Z58fZA1pTDeoyriZ06bbQg/kHhNtYZd25084JXzjl7aRn+oosXCvIA1l2Kc5VmdwgyXUyudX42sJe71hO3W8JkWK/v/jr9vZiyWApVnxvp2jBcZwRNSoPa/F4lBvS44+YhYWFhfzwBQwzNjbTcHEPIxLnj1p8UIvHhxbi/8TdiXnOgripDzFm1ah2zcLC95916LzG2f4DZ09ZmVHce5Go5uFQqBEq9fkFW2ph4T2cvMAyNpI46g2diAwHG8dDYUTJ8Q18TIklysCUgoKomIWF+8dw2WJUpuj5TNHz25utlYwTemn4dnHcx8d8RObToknxZ6CAwP/vuOq22qYdH22ebu449pO/fuXmvz55utHc8avHDv7BD079IZLDK9c/+2fDH0fyU9+dfPjhhz97utGEPbFO2+j6evT3Lz45sb2547vl2zfs/c3f3d5o7rjhpbONN5Y/jOSv6Zd/+os7H0Ny4W7x4IY9TyBZfhX++8r2RhNcN08XLvYazamKTw6YItdMXG7jh9EL7ZpTlDGlxdRUJI5psmb7+T66LPEfhJ/v9NDn4Wb0u52pyE1fu1PamYKyB/7fMbHi8z0N+czLmjt+44ZPrrztkzdhxC+nLn5gewPSftXkaEQo/eWt45/4zjMnHm/u+NSHP/r4+/4pfFmjuePkK987dv3hBz/RgKWw0BJW/f5TVad71B2Rh9cLM0DWf6AHcdX0eNQLGI2cGEo988yXH6e11sjbPmx+/OSGXUR4/vtH7uMXvUPitRTvGKs/SK5jG5HY8bxbfqn39R+dfZyC0VKEIL1yKs3d5uCyzSl5frbm9kzNly5Z86VUczR0Sq6/+NPFmbSBuSU/PcefVtxApuZgpuaSn57jTx8OHdxHe+ZP3/7PPAGe+fiPvxon//0jnx9zd5VVa98GRke+toz69rmH3vXIOzu/09a3JBdfcLLTQjUHMzVfumRN7tsdPCrP/PjJp8contaiGerJzND8kjM0z71w22eoJzND80vO0Dz3YiSeoWeefPpt7t4yXdSLHXef+eyvDvzi0wlq2PpzMSba+mQjWpkAT7MBlyvJejej6lTUY1Hkd07fEio1qlc+HO8hg7v0lR8CjgGePORTMC5FACtBB65MUVmUaTWErkz2o+EqILfkQ9vfwBSWrGXb2P4fteFTrPLqVCRYmOGZ7tsRXuHxoRcC91eG66YLYcJQCjVvtmMUMEpbueNN+50r7+05/t/I7QJjFNuWbm3k+RAl93CfEX2deshV0RYa/+Qefcmxu39zGzTzVrW0xZ0UU7oK/2LM4Y2NzSzkr2dQ0cJ+U2qcqyCXUag3PpjyybF06pPiyGng8tDB1TnFbwpqTAdDe6F1mURmmR5j+CHosTG2TDNEFCiHxasu3XW7RCqjGxoIKlVfpdMH3bLfVRGtt8p0IOuD6/VM5hnrC+yUy2bMWB7zWwXypgO9l+qvgvSn27u+qMvcehs0Rh66Arx6kRkfD/yaXzOCKGCQRQ70EOtEurjkCQ7hx1gsq3BNmbJrRJscNI0rav1KPOZnSAmrJmIlzwVTrYcl4lKKIPjRG2gxgoQKiHAKsvoxokTSFL/Gc5Z5QToMys5F3DMN/Y+DLNASjTDxYpGEJaXJ08KaqO2yehpYl51QA7hKF+rhcjOAn2W6YHogYypi2xG9n5gfClpAh69TXx75TNTlzJxTo3moqVGASLz6L2tGq1rBZVULuKyKC34S3Y6eA7SYAXOtPhCPfVVmoDzL+LYuBb8rI5F0YmZ78702qWeaz/kRCnFRfmwqtIenGtUlDHPFTkI96iBCjX6T9EgVh1hRetmbI6WXHaxHJDaBJkpY1q5e/mYsYAlCFK7Xr77pmFVv9qNOsKfQdDJQrBYJ3fDGciwOsjRzoBdPb+Qz9Y0NG3aoURbbo/sFeMlEE/gueGMX9gdG+uRnJTtHg3pFWaAFJ1REInR3KimUjywZKr9lpK52+zGu4S1K8GUKQuMasFgZCmgqFDSagO4v0hdYiikimtJNy3Hf1KB2IqWLzKnHI5T1iIaJT7oH4EZGF4mxpuCvJYrvSRupYKsAP0SOrQJIZmKXkYfL+5BLFrVbz5SDvUKNmE/eQZB8RjYOLctCumqZfc0eXbPbMA0+/F/ejSQs7SDEx8pBVV2oExAnWPSN7mAy4p9xl0XqsZ9plzFeKEn/uXF9qLAefrZX8C0s/HT1CxdWH1sJuALno0Mys5z2IsXjz0I2ZrlpsWc9w4Lsf1kTE8iOO20zilyuqsith5XMkrDLIMUakmZ+RtjQqAqx+1rXQxdfQdcRlT3ku4jgxCuzn4CGrOlKukAuH0E4PrB6WRBw+MTgcWFU3HPbRgwVDdt/OvPASnSSY9QcxbKnrSMJHVtwWrK6dq7JdrStMeyGUy4Mf8smPxxydOpQgFD8eT79j/HJD2XtY3T6a6fOBIDUIn23zSn4ZDkNgbf/MMUzIvYG8lWn2dTOjpGvfOl1L/7aP7y0ueO7773i3m/9w+su8CF4ueOOZz/86r9f85mXNXd85fWf7GnIy8HZfPB80NXVdef2RgOxkLRoYk/vJKG0o73mjj3E+Xz6NDiZRsVnBixlpXDb05xqajml3bjs9mZjyv+MlGqUlYLkBnDG4vEsI64usDS/Q8xxCo3KvO+Tx8BWIwxjsorBe5i/BuWkLMFUFr0W/5O8IJhExNdOR0jl+KwQBWUF1Mw+Gxk8LI+VVGuRYzTHLWX8UFD8Rigz+Xe60hnFl1lqQKY6qlcLmgvcZHEf3mQcCN8JO1BKC457rzJp9pil4AhGvFiIWJZh9VCdYYj0lcZlPOEZx4xAZDEj9vDNnBmsRVBL5Db6leADDWIfyEIpVYAtA6VKsEejVAAjNUp1w3KNUlU4j6HUavidoZTeojSnNmxRGzjVv0X1c2rTFrWJUwNb1ACnXrhFvZBTW7eorZx6yRb1klj7Q7HPRO86VjDW7vVl2dJ7KwmCXChS2sXIia4y7p7MtJHMNXL3XnwmKSVfLCSn1IuF4pTzYuG0fyXuDQIDX3w9YrpQ+OcQto2XeVeZuS8ocdYN4cKD9esSwPht2UtwQeCAM5RrYSwk2GAeLYUQB9DIuqRqZxlbbnFX6onKrnGGeX4Q1pj4JGeYR7Cz7Glhj2ccjVKrmm3I1iIh4XVWwqYwnWQ+qmoxGBlnr9UCL1u3btxati0gSfQ4acppX0hobBMvgQ9kmrSFkz4RZZsZY0T41/+BUpDbKRoSWV2gOE+3kXV+VKSuwi8V/5AbcfvaMSopmE8KOgRDcX6R8o3Qom6c4Yi0zKVZkMPmzruOFG6LJMekVCBJRui9otrIdrm2g6cC/8CbXsG+VqaUFOxJClb5p5t/Av6Bu70gqdadpKpJanXcFHo/DA86NK8a7cqTQ7jYCw4T4sbss1v2q0lF1buatEy9q0lJ1OMQMpqnW6ONdXstdD9ScNxEWponSVQulUTFHGqGljyuc2bt7UYNP9Yg+dzCwu+xmBPJ03/fitTFFG0IkYgadzy6Uiz7q388/4nmjqdvfeP6dzZ/A8fQ9T1f/cYNl/8PJJf/yer/+44vfhnJW7/RfdfHfm1meyMjY9Svbw793HtnP9HcEfSujj7730OIECv1v/xUNHsQyY/9+ZZXvfwDp5AsfvPrX3zLb3wNyVQuSmYSCwunn3X26vyQeO3wzpbuamg9N6YqfnLG2bz4+XSjMWWH/f07IX5SI/TwpeQ0G3vmy09uTykziECETv7fsT3/Wx1bT7/+dHPHd9/9ntduubyJ/n2v/2UvnbyFpKtP6xvGPveLX0buPz85/ePBp76K3Ov+8MGT4v6vI3frm//1E9OvvQWS30yza1a86NU33je+vblj9f+8of7E/7oPRde96JZv33zpDJKPfOf9X/uFWz6C5At+/bsPzl/7t0iu//t/qr7xZX/aOkVTJZkhEsXDWLrmcZJve+Z7f/zbLHUTLZ//hSeO/dn3G+tnmjt+8NTTr/7lV94402ju+MjvfeG7v7D8V5B8Y9R/5MMvfwOS9x///NMdA9cjeem3Txl37SVI3vymjz298oXfwlhf9IbyzcteeOQ0YqO3fuWXjh38px98//dPN3e869rd7/j+Nb2DjeaOTb+/+5+O9/9fSHY7+18dzv4/SN7a/72w54ojSA733vuV8sbfRDL8du2VpRe9Hsm33r7/8T/54AsGG5a8SBdo6zd/+xVbD880dzz42itrr3cn0L3+H7x5+fj37kZy8n99+uf+ezcN5XUP/+Krik88D8m/vueJ/R9713fQ/2t//dy2Jfq/45c2Dw/93f4tM80dt3z7/d8+eOIOdONb/+1v/rznB8eRrG14+62PLZxAsnrD/6h+V00i2fH+vuj3f+EgkhM3rLn0vpteNtjww1h+/XentXycBEP77z5NMv2poEmn4BQwN5F+QrvZ5W0ETdnU8rgfpRcRoK6wG/oqKf2cvqQ3/lopLUWntDyGY5AoWzItlE0/SBlLEQTvly0Z+5Fxr0v3MuqwGmG5dy4WrUWu+Wy+brbTQRl6fOFxJk9glva8gty3FfaUU+owdaV26AbQja5ZqOxaVCtHZLYRQUNWfCOCKfyc+iRHXm2aaUpFsoGBTUXSnPmkDSFrZmxKNGgTExZrIrAZ55s5+m00yWDmrM2cjTPV41HuEeMeNPM0xMYTzPAIOGbF+XDiCQGLfp0b2nx0BLrwOwmd8JgKd++DD814fOPb7ziNYPcXPhVLcMVosyR9WhKYesUl57ePcEkMpxGlU3GLO6LduFThascavcZm7QFcsqU27tk5jPieR0xlL6a0M9VoNFqxXCpF6PN0wmoGoulXfJ1PBuD7/+A57oiks57+TyAiwyR45pnZ++9iuvui93Nlzy5v0hEcODu+v+2ZZ4euPDr4BtDUCfIebRLqfvKbZ5/F9Z32zIc//cQCyBQ08lp3EPdwO25/yVte9P1t//hSWP3sEGLu2aErv3W6UVIwxknePp59u71h2fEdz951xS9fs+JfE3k7zo8PNiLZyqfLLPvvPRbJ5JvNkEia5LPNhk8np5qKwABNMflL5/LTYJWg58KS/sz1VuZeT8sdm58s/tpjP7n3E80d2175raOf+9Is7qge+8aH3tfz591AV/e86tmehnwdzoAfgRnsmjqdPQ6Sq7ICMYXNqciZSvx0gDZvTh3HRaC3M766Azs4ZXlFNdXUaupCRigtwwbdlU5HKKmIUp5KO54esZVUIDV7+pbkKoXLNeIqYqbJ1PZUlL1h3W7Jknzt5NALj54GP262WeZtKjOuTJ25UVzUqSY5Jd3Vl8J0JT0IzUJee3VqMnKmqLEGkf1OI9Oq9szy6/ouoGG+iSwJK9jH9evfuk5uRI4qorQKMRD/6/Y7GLbf/4R8Ddzrpc4hb8gInDNTklAU9rlhLix4g1CXlk1z9ilCZ24z8hpkhsr3n1ZGgADpf8lITZmGTQkzySkzQb8N+D9WZjx5PWZfn38q83r+qfj1uacsOkxfC5IJ0G+DzI90Duiiget0XRgaGH8kypv5BVk37x87fB2NO7PD95Gb1KAe5ZMxb7O27MmMHK/4mclaEDeU4dJ7bEwN79TU9DD+XMOsVvA7MjODAz/XfDyu2XDugJgsaemH2++IikMvfOsjj12gtBt2iMWhzcBLYti4B6O8mf5LwuTAi3lzih8QkiM5jO6+4zTe/L3gS+q8mbbJZiQakRsviuSDY9ZO35mn7MEhzIzNmrYzisPo1FPxup2IZx6UP01rg+Hti047MR96hF1HaOf925F/zNK99gbqNzP0/UIGyl5fdnsJfFum3DPyIFDX5/J7ytBc/PRPPvfsb15fTu0lwCESib2Q31t2/JZzRNpemb/7xCW41um+3SzkYV1LFY5ZwjK7TS02tHA/xQXH3L19Wh6HLDxPYFO5m15sH4YMacGpnRzSR4+cTuuFQuce8ynWNSPsps7uIGhiRLIVjTYjF+izGaXcy473/9mh2eKxJ7c3d/zBoXes+fTwF4A03Wfe8/DDD4PNIHSAcjte+bK/WfbPT2xv7vhr5/O/9YZdn0G5174remjDnqeQfBdJyv5he4McjTsp9teq0aAVxXkp/PMdTnHEOZyzdFcXKw1o+XhUAukULSPiabn5RAEuthcO78Wy+/SqYhYqdXPX/uuHIZgfkkej8pC8I95jv/66DNcTKu1nkE5Z6fI+/CH+EpTljdpHA0mh/a/hTaVlI1SQaCRv5rENUyk8TaAuDW0f39dS5sZdfaECnKDdtm7RzqAukWxUHYM7kuCENBKVfF0aEq8tK92VERwepzA7cGNrG6WaqBQF8e7njmJWhsOKDozcZZYdxBVOFu2EpFa+cPi655yd5eZxIk0lyODMu5v6UrDlzy0zY8GeC4O8My5y4zVEh05xd4gi5T5XMvcyhJ2WIHeAqUgwWELO4N2nI2iocwdmP/QBIK5SBgPZ9SqMZNiDUoLHvINRpzn/Q8JKUcof8NFiZn5IZ4jTjLxmlNclxocFc+qHjHg6zfiPLAosgr/Q/mkc9VFHA/hNAcXlIT6ZaugOzYLlyGk0dcFMJy1M2BbIX4siLGbpB1jmQn4nzDyXNud+mGDGOZt19ocxZhRm1uadifMaOPvU4/E8Oc0o3hi0YzotuwE3Tov5DNYnCiyIdoLlCCu4+qNVstAVJEsX8HKSqD43BfLHww3TFIxvL5DImkwZLbvx0zIb/0luw0+4jUo7t1FJuA1fBydHiOMokdIf45ZOktL7Gdaj9B+yHmmR+e0jUclyHQ5xHQ+3sB2dLWxHp+5sZzvSpsbGRu8+nTmFMpKIBK/c0scw5sRMCcMa7J2nnpsNCbHiLNrnNSslQwNy6eJ3yn+FIuZkFDLCBGykWYBEsddADfEPC3uRFENIalk/eTRSQ/IOfWG/ildSIUOS4rv39fn+CYlrNmnGCq/IwNrcaJOuGhYqYHwlHYWSRMJtBX6yiv7s6TPPVlAEsGbuPHRtBmnc7HDR6f17qa3P5mtcsL3A/K30Z2+febBSC0n2IRNiuel/vvXiZvCiFzd8G0P3NZkJNyJ4WLJyhErVWwRdo5Hk+j+8tqErmFCU2q5yQtFyc8OXOfyhluuckELN2MubUdzdCLAeJHRnA8nNQuwssyJpJK10HPmRstcE5JkXRuYOiYPrw2bszruOHBrma2mIiXGoKC3qFVRUm4XVn6lFdFFIglWpRd3PCXPkAeWfuFL6dk79WO+v/X8tzI9gDWLGH6AO5Ayilvs1c2gYv3ugHu/cHsnbIx4JdNzfZOSw5puBg5Ey0w+QOD+SZOQJeINJDITTpx5QtUjt4tbhrUM7vwGFARK04FYYN0XuFlXwSekeRljGOQDBttTwk0V3TEYip1SCFGaCO1m4Dovv2gU9iH1xMGK5+oFhmxiGeB9nSul2EwxH4vZIGu92UxiOHC0O4AMYkrrduMORPIB28CwhYG59lsnz4hFjoOJiA41ydqgiHqrgobIxLKxr4sHSBRE17mkXigvSvvBqcBgtdIEcoDu3R9BLpc+FrnkvzUYo1Sg0kbV3MPLIEgd98HTuAInwaa77VcEPcTxIjtlGtwASU48fD91Ca3RRj0mmj5ZKvnk7TzgZGpF60v+ReYVCxfQ7eU4VlvzQsHbpIg93VGqQbarETrZq6o7ETtIzTErS1ZPUzt7I6QsJ+2mnDxIN1p3A1qqSOxjVr0oROVRRtHRmksa3B/yGx440sUYlurfqtr4P6buKe1B2KGRM6GAHOnA0BG4iLghjQnqrPSpuTT8wlx2Q4rhamNOje+kSyK9FAu4o3HiOoYhOiN81Y4rQ/TrNCj1A+DChvp3mfezZ7TUT0IyLg9gjZmxuHeVgxg+C3TZjYxXKUcORc9BUbsc0H9DOAfi0kAfhr8OsqGEJDpjVNR9GCjTfFiXks+vh7CTFHMH6R6QuZ+BSX95e13mzblffQatc4aTLkdPyetbr0LlIso20dhi5Cl7CHLRdtDJr0O0aZsvZ1QduvY/VYg4mGE1o7wD3wTNK55ONrjEBWJCL7XfHwqUCXDpapXDpAO6cFC5bnmXynIVL4nMBds5gFvByWu6BKhFEZQx6HhIeygSR445qh9LdPkGD9SYlLSLTbh3z5AE8yTM+wBP+iJBqA88MCikVwem2gKeXgKeXAc+cFpFqAU8GXgvNAM8cg2chg10FjoMEt5A9O1BScL07mOAGwhaMt1gbIEZZQkuLshL8Bsh57wOKPoQGDN/c4mhMqkTsjZAbiVFkqQO9eoh7BZtGpOl2lG5KTeMBhX/UZ3TF4etTmXQlRrAibs5C8FW1qKBGzdyDqOsOmnOUQD+/96AaGoXJ4tMPqqGxRmLBOPeg0r4pwRjSnP3QVz7kvYnsHB+0o/pUnBjTfkQBe4WW9QjCZNz7F80MfSGS7qCZ5iQplhW1c125Q0td3FPu8NEM7Cnd4TLd4ceDQ60zDypS8ZTsToh8ejk0ZzUtWd5BIMMmb8GHQVaM7ip72gtzGAxNEraI1GqYtFlxXa1VjTdPLczhSM5dD7m2eZaxjhd3W6TdlojS5Gh5XRkiPmdPOefrHD4nYF4lS3mosam6zg9HSTsul1DUde7zLiDSULBa2yjUG1wzUNO568rCrkaEWK+5eo1mEjQwN2Z1MfK+lsGHpRm9hhhi2F7ZfCN0rh58WPZCoZ09aI1eU/aI7Q09KhAqqNwr5CuadPyDMap7gLQZvbjjUnvBhyWULvGD3TMKPXthf7S6jn+ABxB5/Lqy9DFRdrIwVQQVH+dHARD++IO0iYWlSZdaY2XXmB10ejVYGCSri/uASQv0hpQUrusDepy0xzfBuPnCg0qD/ECbfKqfeECZUSQefUBZyMfTly3kOkSqHowkETeQ+oGk4Y1sPo4sSpN7NmE0+Qh7iGidfhwqh6DamB8m1ZRCzeSH+yIoYNpdSoDG2g0ygylUzfRvUa75nQeUmY97RHzIZlEyhWFSeiGlC6nV9aRSATM7VKFGzSEt7Vdl/FXBnUbfLObgsGKiTkuBPZMQV0t/X8bzq9Xe7LxqxT4AaZWyJLRjd6K4xnqpikQZ7FQyDhwbz7WBsZ+SLRyKkvCFJRpJWNgPg9Maq3ssnmcymbN4zjGHtGPfO8n7HHxg1aAUCTIpByoV0+e2TZPDwErEAZPcDo4HPgh28ZHAlYDDJy5SCVi3RgBO1cnDrHGGjaTrURA8BdrzC2SCnsNs0UmQoWx39aKbOAqFpagtc2IOa4/5B0WMDk5EQSQtiFwKJFVUUCTNJedozlLomcOT9JhyOBXZFy55TAzSJ8McOjYEnC7yAZoUpQNU8AEqy4QsaDeTT73446sjGZMOVJPGzuupyhIEnyX6zGEtkxEVTWC64VUs0LldfTVbnkhdpTnqGh3bzARCnYfarNLQiSgW/KI7faELwIwOfrActCDm8DAWyk12ItR4eHs7dl0c4vkSVgN0qeUPYesuD0YyYTSkdojRYE6HGA3gRHB1MYfh8lIx9wFEvI50ZIFj+WM/JWWriLdPKFuVUrYqpmydFsoWRBt9fLV2h8TVmLF4XUDZxJQ3SUxi5untRGJ4BywJw8ANVSpWEATxK4j4FUz8CjZ8Zc1yaSlDZxfRpWtup/NHUilopw3XKPoyfZSAJ/sB9NXOF2YPiP65MaxXj/IxhoXVauRx4ID8c2NYwsGXZRDFZXVCFOYqIqBJjLGnL/JMHxrxzOyDaqOi2fOAxShdQK4N673UaRMfK9oz1VrIp0s+IcUwKW6N9Zf3UJBe7WHGiAKO4RMusmU9ytnBePQFnYsxByDUWQpCsZqQJCQQqhZDqGPxRqwQZ5GJpOhMJZchVDLI5BJAzS0NqMRwpYDqXBRQnQyg5hYBqmRATSHU+Skg1NHxqWohNLcUhDophMZcWm5X2W2DUGdpCM18AJ2082W3srYiEDcRKBTAIQJZuVzUtVKPPNPgns8eUwS/teqMkqvQV+xqFPyY8hekOkt7QfynaX/Hh0jMDKCuIKEeGF3G2R4wttOCsbW3GGfrgpXrFCzCzhPCzgNhe4sQdh4D8i6CsL2LIGwS1lZIqZG5q5RH8lp5JFLHSAbp4rVKRg/Sxq6b3S7yv4zQFSP09CQlLW8+UHm7JPtE/rT7xCWb9mSfuOk+ceN9IhftE8X7RLUjdBssg3eKm+wUVxfsTok5VbtT5EV3ikv+l+OdIon8xk5x053ixjslhzkkw8Vc9gPopp0qZekTJ0OKODydisFeMdjH8kGPIZbolA6GULUEhCqGUMb5FkKLqYhV+YiJabp1B+BTAT65KMGnh/icVSsHIHCz8Olx5xP49GL49FrhU7XDp1oMnyqBT6WtrrNMpLsMn88l1wSQslRT5/4juaZguaYlCV3+SeWaTizXlEzJ0wz72o8F9l8oyTyp2pP6tyEbUcEOVyJpDg1HogaFBgyAuJLEaIJ5Nyg2W1ENMYSSzjY7jmv4joW2oWLJOO3GfIbedVkyKRfRu3leTMeP0amMaQMWasLjiBVrOolY06JRJ96eZPnUXQN1QrDKUa/jJ2vxC9YkzAPuW4o6oHclC2DdVJ7p69zOsow/vjpyE9iUlt6VlqJsp3fdZEQ5As9cAp5cfmcZloY47C14SmKUSH09PoUIPCV5omL19vT8AwFB1ysGdhS05kyHaGnpCpVhVRSzKvAorz0rikN1Ocz7ThplFVYaCRvUiOXkGd5JWDYobTtZ/bKTyLwSKRips7QyVqqNsVrcYra3kq5n7G2LhS3vorDlPSdsqXbY4llk2LIySSeRScpUJrkEmHktsOP9fwNmIu7HfwLMVAuYeVkwkwmYeRcBM8+CmWgFM3+pRcksuEygruI/N9z5CSMsLno+u4vPZ/dnOp8rOJ5lel7GpzRdKBCTlZ7S0p7J6SntXuRCAb2gCwWJUxooMXNKE+6XOKUTPpitklKK1pIdKUXrWIrWjY9R1+5oQee0pHNa8jktyfiY3aRFrj2nxS66XV1zO5v4UCmyX0kpWocp2swHljin3cw57bad027mnCaJ2gmGNzoBRrXqw6L6jQJ8JZFcXgYnJe3XQUjPUwq04qtRg4AYfNMqcdMKrgRHD+GgAkQligga5mSwR3AvpHrJ2kkr2vNkCu3UrczUyIPXQaRJcA+OEB5cUeB6OrEd9DLAEeWBThrWzgGjrATAw/ms7HGdB1HrJtIBFZyiK/18BgtaxKfo4vK6slq6yQJ/1QoaiIRPZIIFezuaz2DCiWyre8pK2W67dPtwsW7HPVVMBVuDe5WwkkwrU1UVV1Vc1UnGadh5ldNGMLhxL7EoOaOGy3ACd2gYfSxq0kIowmaWhUq8mfOAIMUsaimDiRXelCJ3ESYuJchKxRKAGBrzdHVJXpepcu6a5AMpJibuu8QUqMXEeaBXFaNXipesUkycY0yMiG4YVbYoZGG40UowccliYkuKUj+ymNiuHXdC6NzFMXGGHs0DE3N5wsQ5pkfBS0Xw50JDCbjNKs1Cd0S2efSiO3nhx9wSrW4xXl346mhZ3QwItEOPb4Ge6liwiSHfD06hIjwru37kknutQg0bml1kYl9WSMZkRsyhhGT0jDPcpz1zaBjuEnE17e3tg5UmxS7Qrn9fSeZGmVD0WAsD4KWYuoxNcgW7kpA1ewunwBKlNKWKj45Y26Lt3BckBNXuNWV1MZpSxMe84NJOIsFuAS4nZVkYuEQLxIg24HJi4EqOedVyzKulj3kV92Np4HrOY95tOeZF9ph3kmNexMDlxMDFp7mwwKX4RXfMIypLTSpLTcqEgyAXc3yqi4SpYUlJpV2zheULaGVpUlK0kZLSXpSkDYufkZQUbaTkEi3iktb2VtH5wzCmWklJdRFSUj0nKZkZ/HOTks8NY0RKulYOxaRk/JTCGCJ5KIaxpCjBmMswpn4aUvKnhLGfnpRcAsa8BIG1wJi/1KJkFjwFOSIlFwNdUslvFfWohJSUraSkOhipjGSUSUnW7CNSUlnpW0xDWjkd05dESioKOQYyuVXgQ0LPlJRUPzUpqWJSUrHAR2VJSWVvwlazO6WUlMwSkmppQlIw1LstAh9FhKSymitLEZIk8FFMSFpNlIsQkpkPkDEUz5SgmWI6UsZXHzSngunIREAB8tz3X4klmvyR5EtvYZwajL8Vc3eK7njldX1AtNuFCQ7SFXhAUIda3AlYFibU5ajvwuOiIyQS0h+R5P+IAjpKsmc/sEXtJrxH+JawvqHb5H61ocsTvT53dTVHlwv4KJLGHWb1e6MP0HfYxrpfbcKfAdIFKfBygQ/tO2jWvdl/rZQX+ThpDC7RIqDLtQ1HxEUIZr8EX54OIPqxEX5BaBG8V/X6K0jW+JDdO24t+F1XC/hhFcG0PXPtZGjhF6FZOxo8zoaiWlJcY4wy+2pGStdqTrobBPuO0d7LCX/wScmnSW6P9bi5sJDndc5pp85xPZX26iSbNaUakQ0QGtaCGRnMSLqJRUPsGtwJPintGawRe7dkbYMpXGd/lyC90F0UH80JnoAzAbhOI6VJ4ppB6Xuk6eayRMvz+xN1WrWBr6ioud0hK7BtYH8STp/fJciBXuJIwvc7MIvVg6b6ZoDPqH+VSPqyoUtA+cEdTNe+BDktBaEWm4QIPi1pXaCtyrU/kk6ll0ylC6f/oD54IldHOWsox03Yr72wy7GqFhzewnpuKCkPYkCaaGjsKXJphcjXpRqHv6YJRvNatkwwZ9bYL4JLLdIMlpTP7q1pYlx/C+ZkFPPCnmHtvZm9tErcesT+I4yAtncvw1eJBIi14DGphb88njpTAmFYCz4naXqDz0kA5aLXX5B+Q/F8aV45CppNBi2ZYl9nAMpkseMsAGO/2s02IunLfrU7mKVDtS3bNWN6mG4hTLXW9o1jinKDv5DkYKhKuwqgo2XwFCseF2rBX0pIy/Ft7QZfJlmJZ8ZmhHaCr8jgr1h4EnxV9hJ0otBZymv5lskFX2OF8LZRvliwqrBxqYAit9d+HhP4dek/qVpgvGUm+1WVSGQKYCMYHwl26pGd7y9Jd7C94u4lsjB9gD74sFekel1gRyGtnwy+AY2k9hdGovcq7g6pRLRVpClZ9CL4klz6Ba3cjBi+2Nu0I4vfcm98iwV8HyD20d9SwbcUhVtrB5EqAT4X403AxqUy+KY08k2EROGW/H9KizIuA75XcIBF8YYLRFQOG3mwdpUUWg4bcY2nHd8v24p/DQxNqJfa9Ct29gItDwS/rQib9KtgZ/ICW7hLCPpyMKG0DCbUm9CVy+mkIVknVdmVLCQjLrBtFkW98DmK9nNR9oVDYlFbKU993OW/1Fauskbbaq4sW/EW+2miFsjhEW1itPJR2bK/FZ+ztAFF8OeSUpsF3Rlis7UCBG3KoGbOP4QFs5tQC2xIVyvsRnLKQheY/aoNDuHYpWYxYr/a1JUTvdQaHZetBfvV6syOi9f/UQYTu/7naP077DJ+x2IzabXX+lWpyxPJKv9jdpXP8dkbvBOL905evMt+isXrV8J/3k+3ci6vHGqgZT62BVPg+OqcNKPB30i+7iH2oL37A+j+q60HpriuGqVrl4g0aFfvsvdgKll1vvVy6PPV5HLeX/StvsSnhcT0Bv8iU+ORvGCpLv+W/Ne1Yrng3yUz6fAYKoKfyF7tcFjExA+X0JKUNDARIngHYEa8WFSItK7UggdUvPlXkd1bcjGdkKSUr1opL9C48RasaoJrfzMtBsW/sgqErI6JS9maRRc4sjEvvr+spfdkaPqi1LfHBmGn3vYj0VVRppR6i6JuP9RCUhDh8hC8Ov76dWQS4poOtud1MXbrzxZP7yZbmVzwbi9ygt+CNkEueA8pFQSTim4mNCmNOVpiklrcRdH55fE8Qsma55EphoofVARRocnw3App//FKmw5I6PFulFbMyLqnpe8/jXHQqSyCf5MR1A0TmhN9qUce0frPyDAuAkrPIeUAVd9ryTZHyzrkncH7PbqaCP63jCQoIRE0YADvBP8KGakFAQd0KPU+phZjZx5YAwB7C4SpTL0YesiIir3M4W0nc6HKdCZv36HSAwYYYrPwTf52v5NB2xp1+b9sgQnYaG+8j6tb1CaSMW0WA6Q7aU8DFNoTFyowrYy84Ad8DUJPwfVcvMQou+KbUb8pY3x9kQ/FzV1PN7vYqq2fAdNiv6RlMKZ4aQdMMMwS/idkXAxfxUaPqfel6j9BUYfRX0VnAvWxk1V5BX29z79XyaIFcGcDkI7FVrwsJSgiQFPUS0a1mkjypFu4JGDZHjF5MFPpV5vCAj8VKXheBK3m3/EIcJ6RwY/pDgmg06FV8G9Sd9SCHyIvp/P14EeWPUF8qWK9hpmzxHRM+2sH1Lcwm2rBXaxntileQp5No2tonYQO2qvXMotHsxLMsRQiGFN+yFIcQocb2og8GdyvFjEx71FKjjqHycMgOQ3cG9PAtMpDo6R16prqcORZV9+7oJq2a5hppE200zzyVRb8b1l/NMxZ/WztdDpKSFzA81Dg4pAwbf3RME+KqPab3ZQBWXaYJwWgkUgNiZ+nAyf3KtJwLwyzw/J96IJti+67XVo16kqVxUlx/wv8Rz1So37ShKF0/L6bfCliqaRWjwQ/wqaEXwmhC2BkW2cPWGSJ2fNE4Ap/NRZpPuaidS14n9cbc9DMtBxVOGgslag2srtQwtT9KuhaIfwX004z33wPyzJioaMlPM+9J2WkCrXgKIDUvMRySvSBt6kluaK3qcV596qYtqAO7LG0xYuFb+kT9vnnb7KbnzTstQSdmtlKYmfFjw9lIxcV/s5zFe4SsUACG7DLEa05m7qchOB5WPnEyvnX4wSwMbXobGSTJX9Xn2c6fFsc7bNsgl31HMCRHL9yQReQkScP06yuBSdc7BhGaju1PBDRLTZtVznsDgb3gOT4dRICmflJXpZ+1c+e++hqkYjdOmktM1G7oWYlBpp9NXa5dIZrge/9LuEfjasMFLW/A/b3JfTL4pf3Kit+4c7y8tPgjN6lhSnWjbfngH8NC6jk1c7+jEDJjZz6o1c7hxjZ4XpA7qPd5NQf1fLVfC3/SCoivNV/m1IO/HwNarHR2R+5+3ZC8raRm3CZYtwUqfqjI5H36uHEBl1uEGaUPiCCP5LsutFUaobK6y5PGEm81GZRwccspQYeh29pNjFGd8mqeWiURyG3qFvZHEzL+qMjVzuHSGbiDckRRtxuKHlkTtpfYAnt3cEm5vVHX0ucsvsIKW8TpcZN0jCcuF0cziyFBR1AYdYUC3EG6qZjj79PkmtLx8wIRhuOGaydPBqqIcGm2g5Txc7JyD0KfwBwAnxy/AjJgt2j1lb7anLgr652Cv4oectMzict1GGNTTJkndODmF33ZjjxVG+K1MkhodWvRMr8hagFx5V2Njqx05sZcY953xhomZNDA0dHYoAfJjcqkOFvdITPH3Yhp+NDoX1Aigc0Hsoha1zPA7IDOYoRn4zc8SMQ2mh3nAEmO6DPdihvtIIRzQmmKV3rCGP73YhjpN17sm4CYEqavI9KQ3ocsaLgW8gsLMhh3HYAyycZESgeWTd3jR2+ntSI6enOscMULkPuS1ojtxuJv5OZhQVxo84+3dBHpqg2Rx8JO3AAOfuS7nIDqqUBtagBN9OAdtj0X7Z86J4j+3hi8Wvz5xYWRNhBMOP4uiNT+ojNJsUttagZqf0jDGxatTe3RFO2N/Rl22rcEfsY+07Z/hq6T5sV4GpL9K+0L8r3vUXnTe7gyRG4eqrUg+PKBDpfh4XlRuc18Xp5G519pKgSN3YTya4G6xRqDv/K+6Ji31t00bZV5LZ0XhfruGKi5naHZfwMYoM6QxV2VvPsQuVuXNwO6fHIPRx1aR8pX0vrMyiSh0eiypA+Gi3DQXp4JOrUy248CYczcYnS4Qih6/3DI9EyXR6qHNXO0PPGj0TL4wKORiNlXdFdN2K76MqQHj8yEnVppYOhsTH3SFQ5HK3Uvi4dHokCvXxIj7OTjSPo2uGRaDkkBYdHou4hfXQkWjUSSjIXQdy7hQVRt6qF7uGoqn1dOTwSubp640ly0I0mfe3eeHIErtIPj2jE9Fxx40ldxjhGUNTHS0dXDpMPP1RQ2uGeKuopJOT0ZRU3tFx333RSB3rljfi7/KaTIyMo3s0Dc7VCMVeXdddNJ3WXXoUCtnbkJhjl7n07aY8hsBlwQefQ9vHQ0e6QxJe3jwOvKDxIelC6c0geDTuBtobk0SMh6dAvLEg4zFgKyKWvDkPL/uXw2qdz9ahgxuT1FjgpEs5ATXfCgsksCHCbx8Em6hrRvfYp4BKF4AOK5dc2udEZwJ+tR4bEK08ipfEnOHIk7ESiH3+qQGPeRgemjd5GjuiSYiudAyY94usO7O3OfTBieO2FPyn2YhQADCZHYAx648mRsIMmqqXYPUdoHhWfEGQ7PyTvTmtkUGgHULNn5gRF0C4q5zBx5/OiHhUyqJQ9HTFulPuiYhvW8zJzfUecHhsbvVF7+6jLzpB4ZeJ3k0pF+Uy5m3T26YY+oNai9lpQofdcuNTVkh1jO/taPnNjy9MiDOoyvvLa0V4GzZGQyLmn/Ry55wgQTOgO4ZAv9tmPt3ztniP76NbHI0Tq6Bwgo0zN3U1B0Ny7uQN4tY84CGSHbnIQa+dGXJbQnxv6oo4+UpdWuqMvyqVnHDlNQl56aIXwX5qcYMWdpKg9J2qwL6J/+SXRowkQ3LeoCxudW8M8fm4OKb6Vozug4ZYenKFLcUx0gRC4Q4jF1e6+qKPvLbrDttqRtNpRD3009xoERwfuBks25AAxvnT8SDyt7hFySeoc1R6y6cTP3RMqdVg7Q87RyEFQynrUQaFUO8yC2Es71x0iMC8w+nfNmNQdhOwL2M3oVwc2aGGjs5U/P4A/g/izmzbrEdgUyUwv8tobco6yVkUcbcG5I8LEuXfQspy8I3LtqeagC6TkHW8J56ay1AWgDY8iGrZPjCnVow50sIiJoenu555p9mMrtTOCQPCEsfMjKYaElyWcdEPybu0ObcdEyfEjR0KPYhuGRWDKcSg85VpIHrj/sFhRtmBFd4glbAjmSIHPKUJkkXFKAagOvS8CGdKEktWK1MW6nVCBPwH+VHkmQw8PBdK5Gnop+ueMHyEnkt4jJk/hj/eeHIm8m05i/cdT1NdBqE/LIyPWBX7RuKRswhJAl8YcSe2N4PQEFqNtAt8m5GbCyVCaBTNP6OwZqZzDKhU2gtJ9PHKWJLfGColDue8viNcQdnnJUTpu3PFkMl8yQoKzjAPJ1xFyo5JOWpJml4ruiylrD6CknUd+hY4TuEf6FdtQcGNflDPPoxmms8GlsyFDZr/9POzi+XAgX6+upX8v4NXMOh9hXE5k9jekgtdQI+lyUQD9youi7JvakCsIcNRonapcS41cew2h1REgqiPYF6RZB0THHnLJe4pWNyLr5/EHKB459xByBexU/LjUTch7lS0lWkuxMt+n7OBGmf1aPDi3patuW1dhhvmzzAXxddlhKTssEqVgPMqOR2plB2N7pdWr7GuReU0Ep/8ikeFk0p3AvAhckma4kAO0+GB33kBOxjJCtRb+TcHFv9DyVyIZs2xqMcsmmWUDRk+ZNAfQY+W+OxPRPvgpklgDkWbPv+ARC63kN2WjQ07a7HgsDH5KcTOzgqTixPWNjREacrELSK89bnNhQQQfVNoFLqQfTaEhFhYoEobDZC2dsi7dYy9R1zE/WbB/4fVsgaIKuhudKjcYWIbZ3Dk2ei2J9Abrre1ssz3YzRUGqQc/Gju8l3pw/4KoWWyEg2VxTcecu/MO/ru3zxx7lm4gXBw71NxASIhMMiLAgGpYBtQUeG9n0N3oQKFFuzhaNwj/zRKeWcHNH8YqHB7RDvEmzKIoek75ipRLibwhPc41ItQY4SbiwjaTv+nFDlEdMO9Qp5muKG+0E3A2qxZx1X6WEigtZrHLz8lQF38mhrqjhZrreC4isPxfZajLKUPdsYgTXoI7BtuQ5YjLIAPKLSds+TmY6/iV1B3tRGeZ2ea+tL5loy/WfEcrWz2jfga2+gxUyS8wwjNqCZ76FMVRo7CF2t8XFfreogu2pULCVBdq8CdPjU2r0MfvKRUSQ9VQtVQ6IY5EQcoPx/vn1Lc+fte/CK3uuIC3RfAHYLImVG2I0MoJdccQYM/mj6kacieJCbzAXk0QV4h62FVcZl7WUIHrj6M+589Jqnte2rrzcnHd2WzdczKpO8N1z8Z1Z5eoeypb90xal+J+ce50XP8U1R+S2SHD99JQ5Wh2uPMi0+QJYh0bMqL5nZTgn4lTV0PyppMjyffGZG1I6uy85XUR3njCnDqMqvujLrjmJbZ0XEYV26cx6tNI1DH07e+JO6LlhF4SH5tYu1UJ6w3BA8lHSsR5RytYSNIBzl936M4biQM+hPJdKK8rQ9vHR0ZGMOIulO0gwUnpxpO6U3clghPdHSe7IGVBO5AadBzG39LhaJnu0F2xyAXyhU4WR1SQOPr/svcm0HJd5Zno3vtMVXWqbp2rO0rXhn1OxHpysBylO5GNgVj7JroaPCYQmpX1Vic9vLdYdZ2EK4w7a8X2vQTbKISAYrt5ZrARxontxCbqhMHdMbFsDKiDSZQEgrrjBmHLthImkQFk4liP7/v3OXXqThqwCd0Ls7iqOrXPHv+99z9+P5538caQrVQtI3YYrxlqY7rU1CCB/dj0c/L7muuuKcb5VtVeF5keryuGbMuuoebEsM2WV8dABWVbtg0WlgMNbcurO6jp6Eqfx5FG8joskR2BxkUO4/Q190k5Q00JptfeeA3F8po6pDy8+ioyerHaDIupp3+Uy/Xaa6kGKzQY72vzFqGfVC+Pcf9fK4j/h0k/F0F5orHhKB8Utao2sarXsapfKNJ+VSdYldX5mJ3IR6eVTa9N85p2ZbljqNSu7KT2Rd9oU2ppWktVHHmbKM6CefCO+Uv6ZyGVeEyzCiQo6FVw147ZURtjN1QKmcBSC7ilIBeyvWiT9s8JLqCuxVO0LUisHN0m3pj6xkK/mkMMrb4Wec2p0AlsNh34/cMvkXxpe9VJoW2ItQ1eYwH4Fb7mPihTMnCq2U9P3QeZBEtYmEXH/KsteXkWhPqnIHNrfnpq7j6vU+OrFRtfe0f5dxpFiE+hvCMaHNu5Pu/UlDgdYfwPGvALn49NOB/g5l7QIvZ4W6icJNk93hemdp83+bW6oLnIAJ0OERAEUFoIcM3rr5iSi6x5/RVpCrUDEfkbtZeABZYwRN3zaPQa/B3MKqahCGUWqC/I9okOLC+lHpF8zWJaKVrs+iL+mG0mUqCZ3WOo08NNiv5l98ArVot2RU5R4dbIJuJgkkZfL43G4XVWR3674Oov2br9f7S/fON1RYvtHldEnj8n+AUQT7K12qGBbS733muLZvVeInrrILXNajj90zWvXeL1xy1Y8ZlF0lxnWza9FtPxmvuQcIAZw5uYTK+OkL0xONYNMlabh8DvaGJrhNgVVA1W31JuUw05NoY1EW0y/oLG9MXtQiXSypuUwMvmiWAs23WwAxdIBzZ5ib3GqCAIRDS8aDOPyx4E7Ob1RbOahlf7dMsQi/LEq3DlsAhrs2ljd1z1bCLiUn89Pn6R78t26cuWRX15M+ZYXhIDU9g3MMmNul6lf/evg+H55Dp9zQ/BOFd01ouLvxHzXYjj0tAG6x57lybsJJL0HvSfuwEyD9Olk6kMX7dNIuXog6HglSq4xNn7TVqY7H1wTnYaahm28tJZgB4ruKMhZsJtnEGi6VWr8/ji2ftNblKPdRa5dzV65zKfnd01E0pulfji0tn0lKpiNpYico1tHiktEtexyDXg7g0QABu5UHLl4FFqNZiOcaFX4ljBes7Al0C8jpHF0Y5Pq1eJXXvrknLM5h357IB9j6frbOsPflKphflbHiiCEm+alshwFl+/JSEu902vvbGUUPZfRCVOUHvGS0wMmM8yUyiuUGoZl5enVT62WKz+9RPKi9XXp/m47dgxUFDHjlPmreyifRnbdnD2jeEflY+3TemyEjFEirln3eHhaq22EbAhcvrM1op5KT2Wto2GQqW18W7Nm7bxOmCdUa3OyNcZ1SnT/fycO8SAqw7NaAhHRZb2QJZjSTXaVxMOVsPAyflAyG+TEM952zph/XUJmRh4XSCLavU7nbcXFcqjtonkOaYg8uEBvlmnc1p5tjG75OS0vjafPOVeF5HbNCPbst03uF6Uj2NrcSh2l9deRjghmq61g9R93jYbui+pWRdfPsf8J+fBJSHtGHZnLJ8UpcLn1SysHu5lO6cIWDI2nfwbejbFLrzKW8TGps+ichLHbJTdaejla9dh75Q9+mcednRANlB2G3BFBtzQOvyzoRjn7/ic4c+knbBroc4BSedrhcAnyEBiczZojscVV29l4YRvBezaOcEV+PPaWkXb87VO5w183JJPoN/6mnyMM7f6bHP9BtbOnZdH4CzbzJULA9Q5wevlLNG+Lp4SIaP5WJ3h15SQ7Tie8JW8Cw+jaZXtpY8j7vvWRysc+juyu9n3X8gn8M/rZL65BmP5OLOKh1flsR2H9W18uvEzknPXL/jPz7mDJapF9ofmO8ddXyXyM51AvMKk5x0k8phW+YTvyzSCYKdVPu4LvKpDrYAAqKPv/BFBkFz6Y8t3+/XS7V9BtyftmE2nps2NdvyaaXttMeaUzWbv+1mPY/CI98iFaNoSKoL4aSBe4u/denre340PeuWawS2I3/awxK3LlIAIKX3YTU1b5h7Xs/fasX9DNQ+yaiOy2O0NeiCUPsGeeHAeVINnfeL6XcPQlT1S2LLavXDeVdsLPWVJpncHVk/h1TFsZJ7JtwZCwXuCfAJcxVV447JdAPW9jMt1nR2z2b3XTttrism7ishJzvcp27WTtnvfqwCd9w0mADduIShn55xgd5BPcoRBvs6rWt1h0+tn+tqjbYT87lwMsOLlxB4znLbDrOYo/x40shUPmWIy+z0+Om7yKfx7zOD6MFTgxBjA3FY/WYpc7jacMtvn5oqol92L6qGfWWfZt/2s6YCR5doj7e7jw/uNHbecKkONzDo7Oa3shI2mppVda6Mpv8Tyzl6+I1S1h39vNfLuMaGBBZkTqfQ+fjmmC67RcV2Uvd1apzZOmJbFHLsr+yBfOuzp5SjoZYAyD/Ypc7+0eZB0d0j36cbT5T75fT9/P7DkdyhbpJX7dZqP2cRO4GpOcEPjMt4X+Nt4Um7jLB9vx2m1E9UiRqSDjLhrLII1Wnlqg7yNiGZ/D+75pKi6nbJdm/WKkdl8tLrpjNx0Rm46iSvHP7zpIn+Hh8IJBmm9gNx0waJCyCQTyXNe9mUgHG86XC2Jv92DLX6DmPlFtS5uVvvXC1PddHSeVZvNHnAZm2bzhl1jrluUhsK482YIsNpwzUs7iuHdHnALgBc4tcZ5+NPnNtiaawT94xjNx23snu2CmR+y43ehiZmpfAh45nHPxghFKLRtIp5PQptaV/bcptnINlKEnGrMPG2fjGBuzhRmKm8K2G8sm3QT8akRVrMww7jrhRn32Dt0PpSe1mxg4LVhtphv3Y7ZcZtM5WMQr8Vt7efn3CfUNh+r3sY9MDlwDyjb3tqJplU+SQFUKMxDZ8pRT9wDO2Ynr8nHiLi4lfGKajvl6hXe0fBE5gY6C1TKuyQq7xbBxdkTF0y3GNp00d0RkgWlCULC98enm/B5HrPj6HDXvegSHJO2e/VUifWdYmvSiBPhGKJJBiYOmjtovaElx9tTMql9Ui6F637xPjv2qoGbKORV7CsFqxGeE/wC/rxuyS1Dq00IjiM8J3jt0p/Bb7C17fUr6GcXNYfbzjeHay3ktRbyWhs8PkLRweJqw9/dS37Hvcv2eO82IZC7xiU0cfVJmJB4wtO3rvTW+qLpmuDKEWssEAd0e0rt2F1E/hlyzcugTrFD2wkCM7yT/zRnWPf+/gCod8b6ykrslfHsZ38P8O8+/r1f+w7v1dLju7UAYZbdNf05MQNVHvNTxLdv5d8F/t1tZI4Oa0C9J7OI8vcCr19LefMYO3Ccfw/z71EN/U+IY106c4id6drEXXtlz00hxIFk5ynXGk98h/u9xCXryQ/XZchLNuQli4r595DvIa5JpsbYXe/eXnltP4se4F/p1f2mnCvj58rDSvtVLRhAzMWFb3mHyO1NQvc0f5n7zIlGlNkzItek641T26fyNjPVs4BhRtdbvvwYTrF2ffaK4BfzYafyhpcFpdmIxCT3URHb4JeKIdvoEdKUkU5IOAXXtK3E5J0rGshqkbjmLEw0U3lih5m4Y+jK2SvzhhcNgfyvUsuQWGkFSoweEZ54HDJhInrX7OVJfwrgbt7Lh6hVSNx6cEyJW7+tY+wQzuk//5tnwss75LJPdHu8IBvwubnPvx4wOZYMKPhxo6bPvvGaYmz6TZiMV4fziMoes2PTnJwF8NL4cB2YvPG70hzYv2N3MUcPk74RWnKKo56SU3wW9W+bYiJXLeDpEQfadGfT52arbD3tixJir5qA57qcS/YukmjM8idfPPJLT7SKiHPECarPTomSlRphfGWBoGgbqIsT2Q62uKbDam3cOQWbKbH2MG2Rly4BFCA9tWamWizt+1FQ7LnK7fX00xDk/cbF1MJQBxBuo68MV0lNq3wMleOmYNaCfvWMjPSdBfLNVTZkPODbkGXCLcS9RU37MyKCmr4UEJ9890ffXh6ghyM5AyKeAfy7EPP0iMFUYsNGsskOR/lYrbcAAHcHo2q/75cmuLlZzaHI79IDUT6OEXEzR/mkbbpvKCCYwYOhxuJHtru9SKYK7Y6pSzrMJBHbJhynDL3NAjI9pDUbX50PuXkbX+Xm38C9GME6XNF/QOJo2AZn28ZXVxjetZ0YYScGM3NFVNuJEXZiww7P2SHcBUE51YHfipFIsa1tNYIENbHyliSJbNs2edJdnsKYASaqiSNfgpeHF0dCt0+WYA9n7dbITtpxyB046KJ8HY+9KF+L1a3X8Q1Vr2Nv1MN7XD7WszvK/gtXPqx+2BsVXIO7o2ICckHoDoc9u9ayiWMhCSAsFz30ix7mxKZF4C3nISZ9m4EbVLKbnfjvH/6aAIhvtYETerVmZo4gE8eCXp+zOXiRcDbucACamWD7dMY4HpTtQ0JE+0E+JoaohT/58Ne0zPrBsFbZ0bKy/WFV2UEO5lA5mAOhVLY/lMrSj+ZnMbZBOunPlrBnz+oni5U6F/p17mGdt5Z17vZ1Lvg6Q7evVkHVqb39CvaxgvvLCu72FewN8zFEvnxdidvLQZmTmgB+EVfynOAgp+hQ4AU4lt6/TGk/aD+D+wPUH0KSIiGM2QmWoKSPbrHW+wMQAqkCkrss/t4gnzRb3HV2ZNaWoaWXyeEWgKcfr7tyUF6zk+IcsyCNLVZIYRqDYi0nMijWlT/ev19Bo2CETHczNHY77sdxO8k5DnBBTtpRpBV16jJwZ19TPd5qNuHlMYfuD9aH+xzhRdpPkBjX6pIspgUKAExLE0Iv6NCzFMdNihGtseMyoj2fVF4S3SCSqM3HISf11V0DkmjF7Yta91RtC27DjKSsb+u07rsyVkm8wUA7baSjOg3LhXtIzVZWC8YwdZRtuXU7KB59CT9+R0z6opqRx5eLtVB7DJzBHhl3DnFBYT2YXGYKPGxK1IE8WZ8Pctp6No/scq9Bx57S8UY0gbg5YPQZF6MP9QIdtwk2n98KTYicnn1pd97D/eEfzoRaIjQqzkTQt9nYwG2cyaNTf9e4C2fh076VJ9sbkcxIlZpBWyJ1V0pNKRzk9I27WiZ6E3A3WzvIZgZywUN2zgHitQmgno++6w+fUttPp0ussnnpHDNaSpAtwvUvp4LB3Gfj6dZ110xvujaPT79WjDCe/uA7bvj8px7+8gf0qyhdywCCU5/zkt7gEVxtmvp0pdPKxtfCuDFF/UBNNEe4dSVc19+plemmNk4/Ehh9XeBRQMStUS/vcLb/omv73gAP7lfXvpoO2GuRYN2qK+S1rn+h4X3TGuKVFjnkfw574vIY0YaEb/QVRTE6khJEO3J6zjsmqivsydzd2D5OWj2HSp9LdokHOG1fNR//Bx/cr14jcH3e0B+533pO7eDhTGwTvYy1GsoU96bnFP3C6M3r3nRCQTP62zz7GoXh+Hkj0Ncxo2ZAvMcL5b3/VpgUAXXwWTlrs8CY8DmgQVFbRdiTgP6Rd3nj264/Tv9HYIx4g59s3RZeUVu3Ex8v1y280arpVzDsSFUvdt9cqDJV90Lj5+iQWH7dr66R5ascxhe2XIslrL42bigXkQE6p7GIZWeqmIMq4/ezcMgJasR9/ISqr+uJj2NdpwfW9Vuntq7fGljX4/V1RYewpIXhFAWLlrbm1Nl9Mzz/BqYsgCYwGHCt91Oj8NubbXDNopWte70/mD5pdJnuPkEBt/cWJBEl3J+kljDeqBx0EOflroNj/1aepQmhDyhy8TIxPj/wRgK3ERYJudou4yXi06ipbXnIm/lchXxtu28REBklZmvlTjwYzIl6ksUIqOYeRk41969w0jEZxMJ7xTEgEDCyKr9wXrbO1ApNl83awK17o232djlkEyVWi57NoYZc0PgxvmpXEUgXJaFV2VNkTvNd6Gcvlqr3Y/vDXycts2Dx/lxLIL/cQ+4GvC2TElntJ5XPslApfrUzvaFYaWPCIOSufIVH8TGv1P7DTxj/AW7F6f0E9NCYQlMlMQ4EP2GrDK6faxlB7ShYZq4TaF3NTpPRMmVxwgbtkPcl5878G0Cj9VTMTP5XgsChanEmGGgX9wWBArSUQxcEJS694cUmm4/gV7VHS+g0Ekrt0dltGgh/m80lQNUAdEbgztlsrHx7tSW6E3PBG1jKkW9wPXOVXLKupkIH2jHh1j4MTCB+Ic+P1dJQCBPaeU2ZtM7P/gk9l71PkO6Y+YCoeBuVFvcRRN1lew0vUFRZEFj1dYKSE/oLNPQXaIALtHwPAe6M4PZ3KIvPFiF1zazl3Nl78fuv2LFrrqF4AqwlMATIgfkSyjsblS60+2Ha8d1LtjE1BDtUL9bvnK51TvvO6XrninJYAijo07Ks/KJ394dtxM+kpXRXH1ZQ16HDRNjBOtmhrZ1WuyP1Lx2tDRktCpWWDZ3pidJcZ3cQoSrcqAxVLJwBWA6URyqwXUnU0JXEN+GsI4zExVOgbaBONQS4B7UGqNV25WsXZNvluFMCNsHmJIPM7jBVhnIwTDSPeCoQCu4Rf+gOI7QOekrcV9W2cN7qCErL7xwjahvcJfAGHDpafCslNGSuHRIBt8vNWiUZxon2kJodujBMwzQMwzRN0yDlf6H/E/pvIf5TYZRqKRga/sgci45+6goTdVTNFGoq1+46gOFM5ZEcnf0CXykLADWWBYKUgoxJnaH4QCWNynXqmH8MY1XuR+ZcMFMkU3mHZ41FeuBkqkjdXytRM6Tua8TkTt0TQO2l72no9M4p8R9swJkn+6hpm6UbStVIT3nSUyttKDVAeYIfQsJTS0mMcIv3FiOyW1Zqq2wGxiEYjpYnbJfly+aPt6k7pGaH8rjZNE38p5sm1Fo3I34L+DxsNmMm23kIlk24iiFJU3iV+wYQDBtQmzTg/NhxKvsD4kP8yrSq75trf6YTtbuo4et6zj1BD4nY2Z6bd28y2W16HVwDLlTWpu7v1bZOLF+d/HMeUxzrH4ZBNqZrIw6VyH0BpLDofU1ScZq3eeKPI+2YfW2qx3PUbZR8Pv9L0eTqvqC25ZFNmM9GvhbRheoyaoP636/DFcidJ1ZNIStWpbZ2Ola5/wW6aTdStzFX0kXBqmNDfhNKMgfcKOzKpRWrEWzxFzNH2LORQIYmbEaEmURgPGL+mJegZsg06hpMh+ZaVY5vSLMjOMSmVT7qFHd0JAdQJhBhTm+zyq2/dK60z1dC8ynfE0UohC1H/oBzIk4hOCdGq1eVV8Sbh2mNJpX75TkxMopb2qn2p3JMI7WfxnvfeJcGcSC1RrDi1SD7HlSoOtrPuVWuZdUUMtiVlcA3b/Uq+vPNw621TcYK+OzmpZKrXXII4yQvlHvXHz71qN5xOuPxdVFKV/flI+Lk10TXRqZb18G55L58NNhiR+34NfnI6VcNBnZk+t1/+BQ0CI+u/Tl+bQGuwtxXjE7P3/Ba6NBbFV2i9UvpKWoFNWmOylA/ZUXCzMowIoFHvBJ2v0898Y0LdpzBGrIuDtxg4DjnmeP5Ppo4Ruz4dcWoTe6bPqHfXExMz9/wmo6xo3bimnzEqjNqDqlTMugg7YjEC2TnBI0rxNPSKjdxJZLYJ3PuG+/RcOTMh2vjNv1xD19lza4icRS1zmjgphx44gduLu2o6Xk7fF8xuruYsCOv9koajB1YHTdef6aDZtrsETvxWlGz9Ed0qXDRp1xnbdPUFKa0Sc1jECtsJLPFjkzDkSK1Iza6txi9wY5em4/C1E8xZTQfWe4W+ulOizfeMThniLWzYUd+QlJp4Iof8Vd8AyLGGnhEjNgYDpGj/mTq4IzDTm7YUTuSfchcUL6Mrx82LwuUsAujUCM27Mj5Ht8D9p0Xk7sgGwLPzo7T24oOARRyZdsU3MxVSEui5FIFpvndhlxeG3ZlJjRunQbjUeC62KhySFKxVReqKRsDQTZ2U8DGit3dppd9xBTKXTdDbNP5mU5iW0QXCWluQipkcZYAty2O/tHMHO2mLSidrnJ6F+2g2e9rZjd3zLaeN9vNVBoolOAIq8iptBPyN51ivBxZ5AeccHTNMxkda2q1KZU0e5Yo0egwIk229bvUol+t73HZXVzY6EajLoWcctP0pGnUmsSNFrGtRt5sBymu59O4UqVW70iAatC3k3GOZBhL9vGaYvSKTkMIDXv8Z+Y6AE5sg9aF1pCnhy02kJIaxwWU8P01r7Jhc1qbArzQ7BF8e0VhaIgCRC8fSm1NAi00OSKOJoX8APbE0wdGl9oheCzN50OkCOiuyTM1AUDXIiZuDKeN9coOEVFyjxZIyVcBbo7ga68mrgSdFgud3W8wxwjoDqdgIkcQyo6pwkjmHmKgAlrv1WXyYKIniAo5vZR10qXOaxSKElZN3OcoGxmKIYU4GXu5SvQE3nDMIN/Z9F2Bbs4L9DCTGVbymeSpMe6VM5UyxgVz4kRM77bl1RY8ud3Hvv0PfxO8YSXFBqwzgHwr0e35u0XhshD2LXnNwnB83sjPEPdXimeABA6kFjBqPjsS0/pEOKY7yt15i2QioZRLnwNqTsQogtbFDxL29gLZedcJ2nq/nA2ofNpKRyY9y0JwUtgmGlyotw1mWnvHE6t9hInOKQCcgJJ3o1KzxJ4RpGzRaGFOxc0NyHzI1QA6LN8mNkpqm+kxo4N5z8N3lPv82dkDRuAi8YCXdvtKt/923Vv0gzuyuKj79tm5Tr1vBnL2YmgyNe5HZjrKTUDvQ89EN1FGyoDZxYtBjeMVynDnzQheoMy1QAG5j0OwSDFmAaYN3LfPzv5IUtG4j+IjO43FOnIbKBQlURXyyHXpfOTulVUTNYFH/v8jocQNxvokCOtxFBvSxJHbSgBqj8CPED5sIk0/kAsZkCKVbjYWn3xOPiou8TrTuk9xS6dv0tqLYsaFPk/ELlC99qo6Ev62TkW7ZXJxqOhMqaKjsi8ot6ZMWTgjsIn1fShZHWSuAxvOYgrS/0tUtla53bfrbXNWub3+3323GP57AP+mNxmKR1CMuBPqUgTcDKp2tVuYn3MLDyJBfKUtleQ0J7qX+lwoF0GvuutCxVlw8dVuP74pZ5hJcGHLnFvYH2zDx33B5QQhrr9lBHP1aneYb5V1VJW6QKqR8KaLFjfK1OhuzdXu2LKvV7X36wt97pm1NCnPR06ngsLOPCWE/S4TpQEMdb9J5wlAYhWQdH4MpiR6CZ3obguvoV8bDufKv/TfiStX+eDYT94BvGCTy7K7Lb2UGnVBVXHPJbNMylTaCt6yMF+ZNY5ddP2DyNSRvnXEDAsCykFV4ZNA+xq583v0H7qgl68B6ZdbjBI2fQtsOruTzjVpL6eH9SVFsyxnm6CqVlhqV1s4booWRySASC1oMTW++StBvkdUPcAZ7RLbAiG28CMyqMV0+nmJ3A0t24TSuexH0drZSaziAjatzh6BPboTu/k8cxohphvMJecqKBURN7rBXEI4KjkxKw2jPlc0jHhlxAU4JQHWEvOquwSKQhww5ypVdGH1StyLia0svtE6j+FwdlWRuF//83BOtOCRXEwcTGLbu3KmUNDl+/ZyGGpzXX/RX2Bd98PYkRFvvli6vlWy8l5SxFWX8Yv3KduvZ12L5go8C66yQc8tBIAIzjsYEJIwUg060omdaDU6VhKyG5/TiB4Imm/IelJzSXLoEOLVKduZzTu2jZwbu/K2xMU/qnrZJ0zRgeKs4Wc35d0FsGkoMXipIExrnax0bWz6XGXqY0s2qkDGlpyrzOKx8dnA2Bo2cWE5Lp43y4wHHHMuXXOmHFLDzb/BvfhqMc6IqvuSajR5ORCnUwr4cZ64s/Ihrr/7JzXrZnZ0muUCd/Eq7Vex7RI9MnEXXtlzf3a7iHkIyHVwIhQdT+ym6PWxtQNBi6am0GYiJ0hOvcBmLriqR/CaLRT2t2Jq4a0dW5N90kjvuvgJNXRa4hsL/h95Kk+c+NW5YhiObcyOMgU+Im+7TzfzzK6Bn6l4X/T9MBYpM7sC4V5o9/NzBLHtQu8Ln1D6+1HTGY76/4ZGu/HQ0NBojC8mCkZHm6N6dDRUkiQdiu1kaDQdHRoaYnK2v1QznWZ7JJXY4XH36WY7SutHTF0vPtRQ2gThuiheR5rcYnHItdfWv0yWX+49P1DtifLby7Vqj5dfkEBnrP7S6MBLI4iHBthZ4+KpvAE97K4c4c+4htfkw4BDn5OQ8y3FOPAggy12GBfksB2/C7Nz+A4utU14VYxPd1+TN+34dLg7H7dNHlnDeZPvX0H7E/D8YWEJr3afbvbyzJm8DQF4jWBa9lsRsxlaSebcJl978pp82I5PB6h9WGwRedPXCmS5NXI8IiOebWyfypkmXaqVePNoWtnxa4vx8wOGfWINxGsPeOp88iieuM803aebjJwq2lNpntlxuyb7lAEDOOpgNFXbpzpDRLL41Tkb21Gx/ZZN/YwPeVxTNPMhmHjabchL41ewh+CHyv6lshyFdu99sdVTRbM63RvSShFDKkmQ4SEmFcLVlOIS9s8w4TVYjf9oh8D7ddqtFDIpK4cOjbvEWRxoNs4OGHEIUZI/C93+CeTPYvKszQZYaw1+TilCal5/LRwvyVYfQxz2bJI9ZAr4oxdNxhg0rJ69mB5ZIe4vJKNOeoW+2PNSzU4nda/EWYITM5Xu4KLJDhga1vve7rystvCKZKtA6JM2m2iziXoTq+nSVD5/xJQNa5sIx1e1gNPgDWimQ0TMzvapHIJlbS0b7Jmy0UuDLbZjGza22v3w8A/hLFCXdRKoI2SiXqHOZ1DqWN7EnENtUL/vKOW1cL1Rt25VJ7EjWxmlS7/fvrN1yxsbg6t6gFfNPimRvF6ma4Hdb6apf9a6nBqO/utefpSSKm0nKc5p9GYIm6AL+rHd7VOF94i07dmdHcNRNmwb09exie3sBEW1dnYCTpa2iSyHspltY0qV2yRPwS5yCvEE1kQl5Zq2K+VsWU6mGo54TuUp7GuvzIfIINohYRBz+gsQmcym6X/VOmDmCuXsHMNzobsuJEVsOG/DyAbZR3RHksNThTBaREx+Egg8iM9ZKCbUYIO5AgQGYYLKRAhUWHVanxX19Jwyvh2Wb9twh5TqCUj4rGSpHQV2aVSmxhMt4qg1vc1mNE3TX2TPNxgmvrvDeCY3KHOnuHlKofSSu5T5OQJco5twsBnXurKgsUmWx8zunBILTeB9IimKCQuE3ur0I+GyJrhljHLaNWeH1ihtoiCMk0azlbY7Q91seE26mE2oMPm7y/30YwYocsv+9OMr/3Tqb7kEyc+RBbIsILh1y777r/SKP/3rlX/apFb86UfVmXfmdAdyWpV/NxP40kC9rEo+9tJhJH54szYB/U+901gGVzRFY3f/okXmy9ZCEU23rrv2Ln/hiofa+/RrEAED0Vg8fe7yegD/JrRRrV8q4Bo661+EhUe8SW0o13S6S2AcF4yHE8K+vYSKjoX9YP95iEI347PUL0go8Y4imKKBNtjqczECvw0njmFdyC3nD3vE7FACIsLbepX+98lgzby+xkDM2xfOFq31uJvgXYMt8jGEGL+Kt/6w+1wzH7H63YX+WL5W9O0lRzDsDjXzEVxLf910f9XEKTJXDE/lI3Z4az6BA2dtzUfuzbXPP82kqhbIXy5AxFVIbkGOzRE7LMfm4WH3mbMRjz1XJFPupjH3N2fbBByn/vdTLiiPVujfw+oWwzdj451Tol5tlV49kkqqhRQ8DxswGXsLXUnR/54q2hYSR8Q0g5xLrIlizH2JlmcC7fnv0C2iZD7qEOsV4IoUFPDYnT1bjOLlsuZ97o5c94uledu2EN3ZYmjdKHmYbo7LK4GCtBTi3X+w/b79v0xL8Xu8/FOJyIJ4k8NpPr7//Sz3/3zmM+6O+ngoVqABRB6O5gFghmw3p72kmzfwCMoqdzb+v2OKMK8JNEKxZWBTcB+i8PO1kHLs2hK8Mv5xo+y6G68p1mJhJXJsbRk59hOQM30Vl+NQXntXEdMMhIcNijHYUw2bSGZYFk4Y3acpvmNWQeABpjDOE0zaTlH7OoXEk223tueavwQVQGbH3FNqBoZH5NmB6NxE/M+OqRwjj20DqhvEDjHtkA85Sq/OO27epgw5GqLrbUOm3ybkpWx6NZXWuLuH5mznSkydC8ESxDsYxscaJRjZOwHGhCaqBpD2ZADgMpKtPohpfKpISnGOSaOceaPNEIjGsYkHHFcBPUdMsG2gjGtemQeuhXgm9o/e10HpqGsx5NaVBSB1Ush48N3kvEzN2jH3tJrBs21zs+i+7foKXXN2O7DH3J1GSNC2ELq5cEAxZPYXiw5NFQdfPJunbLppO655JeBWkkvEooog26QMsoV2mQqKVKawaZNfKjKbXDlbdLbaFLM3ZGMkkzJbbAbAhXCLp9QtP0kFDhcHmp6GTaH/SF0IJw4U7ej0p3RVNq2Ce6ogKv/h+EU2tkMzU/2vHajAry6GZqZsxw7tmEIcjJ2AlR5Vb4Q6YfLd+aTV7wZrAfNbZ7ZoSla9yb1W/zsgyADZsVcksunYzcs5A6m4gTbY1SK9mEjtIHNv4Uk5GZgf/+6Jm7/8mNe1nsnSpp4GQTsXT+UxNlJcJLZxqYDPy94t9xKgbdzTSiKtGnN5KrC8829w87bttG1PIbh1pw3cr+6cK9IpRPO33by7zqZTzJbM14q0o9x/ouxGGcaF0K4U6daOci0amWKbutbr2eu46DC6GhOJfjdfTztmBxstxjSW1AeJF74kn6QvicoRaocQQddEuK8ivCG6F9v2zimqk3yhAPbHeKVy4Jybtu3+GQyje050gLa9q+hMQSHZhnC3rYcuDnkwmWJc+mA9rJUdmgWrj0hhnDsSv2DX8Ox+8RsLBMq94T5KukU867TsBIFyc5twsa+x8awz3MuIqZstMnE1oqZno3up3AFSMpslnl/ZLKyTdgj34LA8fcPOjq4ut2FsoHDR3bjJGgsYBy96eOa2HBOuPegr5AJ0zV15YL3Yc/FU0ZRQYZzmASR3LHHDNiXsCC9cSutBfXDy/GLvehHYeBuF2U0XqkmbYoV5HAJS8hHkBQhx6HUvJQnwqr/7RU5UsKBZLIhTl7CRqheFb2LJvPabllbaDgvd3D6FptquCVw732JyeSfAo53QfORtalmI/IX2tosgTuncQqfTqaapW5smuRACm/Q7JjPKsXYlLCexjVOfLZIAOhuXW6S9S/KdVrNSzl7RtG3btG0/OGSLaJcXUOdymbfLvPy+ybbdmp5bU0qbGekqe4T6izbXxG2yscPeYpnUU9TQALs0hP+X7NKIjdw6ZKZ3zTnZKoFLL+4o17bBbB7703XTlnwS6F7V1zvyST9+rPgQD1hMGk5XO/n+ve8WV2EerJPvpwLNc1s2XrK5qtnGqnR5tQ47s4u4YnYubwj3lcge6zDb6MA2S8ptxrOvKSwgL/kCgVP6XeUl4v4DOKvf9cE5C7+SFkmls2vs8l6CH31/bZTaSPKcImGts0x95s9HYVZqjNu/61B9dh5MVbEzCO63gywaziw5sZgjqDNbZL0inrXBdlKHtYZsK5kN32LRcGbWBpexQXpG939JcUOQmRaCGLJp/6yI+2cFstIgEqVR/prgRlIlHXVsdlLWGufKvhA6imZ6TpUWuxS4spochz8N8d5Jnwo047r2agHxQUxYKAgByuqpzeYWzdiX0N0ONeUUnDAAG1KFAYQSBhC6czeb9ZbfrgD2jHsf1ALn8uMefHw1BX0wjTS+vdLbESVfPHRpsG7p0roVbDaPagGSdsptoExFVIJH9WZzAGZKuCBE7gATxwI+hWWzjxtpYl4gAUPYEtRluRjvMbYNZruw4AD9/Pk5hlR6N/4NZtNWiYRWm80mgQA6Cwiy5yOsBxSOuYg2m3N91Rls4vM2pLpnXco8Nct1KSXap52DdZ8NKAH5oBpI2tmEWed8+Vahy4nLxgME5U8xHki8EGJrdjFsxUrNAH0gJIfgeSPbX07ogr38Eqe/p7X4Jb26CASKjukWkQmyiGeLEAO7eKoIQ2qkcPaFfQ2SsiLQi1OaDWcR9C+OOvRpEjSKi6eYlBRo/1H93aiHIIrq7Uh8Q8NaevtzwZ6fJQkDR61hOufsDiMGbLtLYAR37ErPWZR9WTOTq3vvmNXZfyWagU8TytTq/dTEISpu+2zZQfZpZBSVVMI2YI7o7EHDxMUf1Gn6Q8ztKJichfHOJdBgEjtDgWdK/7iho3mxwYWL7DLz/fAWuixwtXi1SHqqAJJrILyqYQDYYpM7GEZY/9tYQyhRz/W+K8ygIGFWpcuAOGGVB71uD6Vlxk/sNYmHimehf0EM3tZOAPiHMPs9ZPHVEk1AJ2qdClTP1tDHqQRXFxHCsGKEYUUShhUAMlkAVKBfXWAK2HVEMPSxVcLeagRgJSnjRHxZe9KiQQ/gwgGBS3yodiB9ofxPF8KQrkM2cs/R7Vh2gvf7iXfVfYcCFzIRBnxjYvrGFBHmyfriu2oeQjZi9iCavhFB7Z6D9tN3pR94g631MAFZ/9XFnfK5AJCUYW0w30VtcYKTuQzo6ecJgoMhqGuCETDTTyzqGziHADlhR0eMFysMjfmN0VE5zBFsQ2c9BuCIh1e4UQmx44pVpVsQ5qMIXHgxY4ng9RXXh4x7kH2STNDRUgrDbBSB6PhPZSJkBWXISUVNEelJqEn70HJSFOzDCOyLGdgXkaNaZxsglwXO10UXM0rFsCjwe1cp5n+nzCRk5Yfkl1RGVqLvrfUOn7MEi65W0D8CGvjghGErk3+u7TKmqpituZUgnGcr7wRtQ35Pu+Vna9IfRZJ12fQwdIU8AdytNxvJqT0zJYYH2nRvvdnMTKW3hyaZD30OnEYFcG7cetxl9BGKQB6M36k87pnqCkwmjikCBDC4M3uf2SrD0pwkGIOwhCCOmMTep9bBOIeIcQ5J6SBLXsj48AWsAiIYHIycjAP7oi6Rc7FyeegyyWVDgjGuYc2UANa1rJlKi9a9OeYfsUZb3BWy48/l/t80y+AriOPunvkcZIQ7Ac8AsuB28NFD/tFaknEkjFfrMro9Iwq+TYd1kKZhJrSGWD6R4qDo2PjeYogO8mC3hq7J2xyHgUGlJHHyFCnvcOGKmlMCyYBZGEBbS5xE8RbpFZiuQJwwAttGmjT8kIt6RnqQdFTt3QC4hT63Xvvn6j/RbdQm9xbpDTa9FuxAo7zFylxL0/PZZ006Xn7rxwzj8YLkkOqze8J0vEL+GRXubZJXIyM3yLwhVYDTCHRCzHMeCXRebOk5h3kAHxFuMLsFku0VyLaueIpInp1YkD7IiCAXNG/ZfwtLFM1Zsz1Be4Lv2jYybuw53UW5+DRCFcl2OnUDFN7pblSqZHxYkKBAGhtty9F0mvpMYdlfm/TsihUI1vtpyY7rMjXvFuxERKDMs1XwSBEbxilxFcJROHtziIu+2ga7rHpDFWJIEKJX09dv+f7jEI88C4D+Rzbu9z+U/of9/mtrfP+nVJXo2Q/ki8ancU7fA06un6gKw7khLEL3dUTEXxpKdJIWL7kwe7uxqoQPwPffItRUnN0UFUH2Tpw3cfb/MRlTdquhfcUaH1aa3W4WdVOnlRUeEAztHopI4qtuyqzdy0/nBnOy6SyrT7+lZbmshAzHIMxJHw4oesrvnMLzEu+tymwL+OyTusdM4z7pj0eo34aM0uI9cKEHGXVw9BOPAi1Caeg3V2yD7N3GxtmfwyE3RuLw6tHjYKGqR09AddDeZYPsCNfVTfYojOFDEYj5NnvS2HiGgvAGM0mOMnDt2ez2qBBtTSoRfuRYQbLusXea7ClT5mWXRPWTMIoNPDkLTz4R6nTeJ7xA1tIGZupXSCtPG0a4bkRS9YZr9Og1kPWyoybP+MknPnxSwTm1CTfYFu6DzLayv0FeJaCoCgNsA4lXBjE1kGcg+yzcy5pT4sQpjw5p4ogCecBRLBEVS/Y5nQ8JfnNoh7K/NXCXb2PnIOC4u6QZ28nbtgt/G5V9Xq8rf0cCzJ4zOzpBVbId4QRHtKAzdAnMntG2w0QcIlWkuLtTiWGEVca1hb5Uqqo3JUW6bWdfNoxTIvwkLHpxOG+HkQNyOPtbk+KRoAd1fTtw3E2c8e30RJWb+ICBJlpuLttyWiYkoOu8ti3pP1Ur9KA0KCxXjEgG5aSGnFSbZV8xBEDgkd+NGID9VSPKZtI0O1Lr2ard4YbdAWgCwgfQmz27PaQY1eghiiC0+mKBoc32giN1aht89LaGW/iuVYiD9b8hgbuGeNT+RbI3/SM38HIaiJ8nBvgva+R4ySTCYX3ZDaZ61OSSeL+o7H6cn8NapeUmkK3eHg7Ypsq+qa3upU16PIN+G3j4jN6a/k4g/dhjZgslJ+lms+Ab2I2d8nVDPyMgdgaErOhlx9C//bqXfU0j1iL7ts7+SbPzKvuygbHvAVqfqVFpCxvYkB3idpuehc0Yu4Qi3wYUDkA1cY967ewZuknwg9NXoep6I6Zqpod2Uqkz+xw8PQCy8QAifTHp6lx1ouy5IoSJa/fc3od09g1DRRVe+7xeJ0iMUhBzIp1qI3iOyrL36Z2SbpIme6T+URtMQwCj5FR9ALe0zv7OiEzQb3CDadsw+3szMG4eBaKj8EcBCu42MKplt0frfE/k0x4juonz6IOOA/5P1FwhzPV+2iIaxKVA0g2XdcW9v5VeNEhdQoPvNpy8Ri973BQ62xt4V/Ds/YE8vicsr/y/N6LyyryJHeFM3T4khSIkoXtp7kFMija8pCdxt2/Ejtqo1tq2hCj08cDEc5F8c1zOM6OxcBl6axJMjJhvI7ooHNlN7ynRtJ69I/vQtE23rkdNa7Y7gHtU003s7OjKW6YBntwoqm+bO8UYrl2GA63pxrdXagdhQ2JrZp1Bu7FEYoNLN+xYKEIMc9H05FJtgoqgb/V3pChxCuULqIEC5VLzN9ToA7J9xWLq4Ab/c21MlcMTSETzZfAzASrA4xIvmMyu8uItYGqC7MYg+ysaRHwhUkgI8iMMnXKPqJlO5NHQRNCTX2c6AYSL8nKXT1B4mDJZ8K8Q65y29AToz/Fd/YLeFhRPq5/tqHVeHZ2rUnGk0ns1NUXY0qEEus+6CJMfSoiPyR4KGNMBATT7psamy57RvQrdlPcOA2Au70iUurqEm/cE5Fphm1BmW4fr6129Iiyn3lneFHxJ+5c0y/s1mb1Ywmc46h8chs/jYfiPhqh5L8hh+HFt9EAC5+W2SVzfJlF9m4SD2yRatE2o4sA2EQ92v03CZbbJtIcrkK9QRP9suKWGHcZf61hyYepFARv+gNieR2L7lnm5fqGI7aviarfkVK4IrgwNjcQ7QzCpLFlnTzGibVpClP2z+3MGOCCndHbHp3B2B6lNpk+cCF7bqZ/UktDdJncVatZ6NVX9sEaRuR+Q5fNIls+8gAzh0f9tyfLEiW6dMOdPQpY/oMjnkSL/6QW8lT+/mCKv+97T4+DdHa56dxOBk1+mQYPTyibX0i5CAkxKAkzSPw3UKuTXp7vDnNQv8u8XdC/759VpUC9Lg5iYC1VilfuEulDFJydJfXokqReTJPwfrHIx8dSENM9VX9T4+4UltOnJFkPNnjspiW5UyemRqi5JNTsBGJXvglD1ioQKxbquKYejSjjGp+zPNfaf2/8QlcYBlbgiMZvsfYHIc6aSnQ1k58jLzsLapceCqv72emXbleyM023GIwVsRQgq1bo1GbFIvQSZwv1G2YQTaWyTv8HbRWTjFsVAKP28bJxSpBOXMSVObolfhHpjy9ajBurxWDveq557EuI2XDltz7a9uJ3OFql78U76vHpJl6kbS/y46+bc+OxQoI2idCxjEyw9ka6/qOYIAeFOqLltHZiPbDV2uh9SUOa+Pai81g5iW4H1+iLeIYqpRKuXg6xmsxw7x6vK8SoZL5Slqh99IWDs0sW+AF92waZuDMOkk7T/2asgoKf1N9RHtTHXBieRR5LqTMtuDNZJWVHfi3jiVPZ5A2ghRXyh7EPUpbOJ6sRjzJw/8owNIDS7RyD79s8yf4rapC681GSUPKhkkOAHJ9u/wMn2puBlwQt1soEQr/muCVEPEuKHvweE+GSgyTnsrZPiHk+KtxpPgiDFY5y2r/Pv10pSPLgaKT4qpGh79J/CwCeFFCc8KY57UryVk7+nToqPnjkpPkpSvLUkxQnUPS6k+KiQ4tdJil/T1Qaz+HMW/kz2ZKglKd66iBQP10lxwnf2LJKiXUKKZwkpTnqbs/YDC7M3B8C2h6E6wocGs1qLMbrepQ3wtRP67E/R8vR5a50+D1f0ubekT2PC6yJvu+x7aIg9taTPdkWfQpvN9TVCba33T1MEmiLm2p3VcwYUmzJbPFKS+6G0JF13KkTWkp+b+MCfm/KzV7825eeGYNs0fRktZZpSpoGUdSHdIkQL68GONLTXZ0EnjqC62IY0I1X7IRjYD21GYLD8TF/5aGMgjuahdwpQkmscAeOwfaY3nUQGKrdALoeR2GPxqeRn/ttDnszA0/CHe8IzOMNP69COV94p8UqHtsv6h7WYZc3AGY0RLJWNcDKwC3qWLWXf1LnObgzyuHRrouCVvSVw3qkuFIo9nQPXLDpsSwcSaVxtMHY4VevSLxgdzru3vRPsDZyW3gkq6aZC80ZonshdvG4QWqXcV892n7QApL3K57qZyj5mikD8seaJKCtI5/FMhyptyszZgwxP3n279vZIfHST2R/DcwlgRuXjvbXHAKY/fIsRUHNixpurAHiEbnzSZh/zKgtpjVB5h28xtJwCDgklJbg4xceygX23mKqBA/3HB2qPJ2FCF7QqJmRtnM9VQZ7p800mn7LzTSNl5mpMcK4wi9L0brhhsGfpTy1nOA0sXfsCsZ/+ekB9wOe6sMs04PYKK9dbg74t9UfLnOhBdT9KvDo2saZDRlrhvdPXbbgMrM7+UqaIGEilHIqn675vPDMeX+qZ8bbgtD0zfjM4Tc+MI+KZ8bF/Ia+LJ5Z6XTy9gtfFkQGvi5tOx+viqe+h18Xb6TwOr4uav8VNJrVD/wd7W3RKfwWcjel/CTQNPYfrF99Bf/EdqpR/XkjJ9gR5XW551PSy3wrOXBN4iMfiQQPiWlkTmKx8zyVLNYGHTC87slQTuME8apbIJCa7KeBdh5ee+l65KvRH/fSyd+Kh5fWAh70e8JWDEQgcHX0PqEfpsyM6u83DDt4T9qMSTuK58LaAngteeF/Gc+FbRptBz4XNpr285wL0A79Q+SxsMP/RqhfcZ+GogtMCfHy808JjCvqFpjNvhPl+GeeFeLHzwiFVeS80xXuhWXkvNFf0Xmj6IQEC6STeC/EZeS/8YKe+IDt1VTv6d7lTf7BkL8iSrWqN/sGSfT8u2TMv4H34gyV7QZbsn17Ag1H04sfqC3bYL9hRVH9gQC/+GP8e0r3sVjy8fzWdyodOVS9+lCM4XF+3D525MvJDXLejsm6DevEPaU7dY1QLHtJ+dMvqxd8lK3l00Uoe+G714h+qW/wOLLee/dlYfj2P1vWOB6r1PHYqFr/H6xa/2yqL39sCWvyoq6bFT5ij5Sx+zy6x+Hme8/m1+OkBS51+4S1+CxomP2FWafJ7VonNz7xx0OxnU/erc4Vyh5Toqg4zYVbN8CdV/u9n/PusOrn17weHxff+sCiNaC/EYVHaohaC2ooe8yt63Mjq1WxRX+Hfo+WKHlhtRR85VVvUcY7hWH1FHznzFX2EK3q8XNG6LeoRWdGvcG6Paj+6ZW1RfkWPL1rRQ9+tLeqRk9qiDi1ni+pP0fLLfLy+zIeqZV4IZJlLk8pKbNnKJpXHF5tUbnseTCqr8GlnbFIRPu1UTCpLebQzN6mcAu+12KRyeCWTyiaaVKCtZ9zTgLbeK3Pq2vqw1NZ3PWoGg6DUwPcM3wdiBUcRK/g/vep+Uy13AEC1TV9139fYKx912FACoRJRgS4cxSSchXL/6R5EPYTM48QST9SLHzHUp6LcB4LNJiPMPr/eGeCoB3chrMZvM52929DjMw9O+2XNb9nvBG1NteyGstXbo3Upw1A3EeUk3VCxJwiW1aKR+6bO7gqEHdDlVXbe8gUlJmNpcSFTn6qjP8dyUUqAsRZbySf97CI1Azeb+8RD+keUerm+xCr30EN6g1KbzXYcn6rn9C73sRFHSJEwuweuf8jfKcAAyr28xz+ug5MC5a3KfjfgM+R3MtnvsTgmz8iefXnPQne+5FDLetm9/a2ra0cMVpcWi/u8NKZkJu/FOAgvJcgeNmA8VugaMwQ+3c/EjkZgsl5KHzGakGDmXQjnyBz9UO1xmQEolFDk/i+18GnkTnNfL5vS0sY6d0i543i4sKDnprBWfHpEuX9UQAqA7n/rINuLAw7Y4OFmDwwupjIjaZBAQQ3gvoDHfWtQ+mao9D8q2QT7NBJ6WPKzXUkfmG2TpM/i2Wn6QAgcBdEclIDLWUPcA8nYane540qcQE1Porn/R6AbNbUto4sJTgrPuzh7PzAmW9lXEfCY+nDvGwKmFwDeDIG6VT85tfSpaAqyRr9XMDsIusNNTJ9BY0bR8JxfwybVAjQ5QNv0vW+WwA34VBtA6jatVlVqm0B7XqVEEzOAHETWZB8MiJMeZ3sDZvJt2GYeB4gtjS8NgWLUxFBZTfZBrhdtRi3byL5sPBOc+K8MiVJlo4lvNLFtNApAvRZvkdkdvbyBVjE3MU6Vm0zeKV8b8q8N2Y6HKgMOnFhuQJmETyIEnGbPEM4OtAfb4rkuquH0rn4wfmN9mSqcvrkwo1kNLbja6c/XZvYVbZtUw0MnAcgeoGzFNtk+xTRLtCfaKPv9oIhpJsq+ojlpt0friO2obVJq8ZknfCfxGmMSDQrTXRgAP/sCS8QSjw8Rp+cquV1mJGOhB0O+nIgyOnsyqJuD098cgBioLBZU3/+yQAxo1/KJeARiIBSIAZ39ZyMAA/85KsIBgAENgAGiQ5lsLwAQ4DpKBHMbwPXyHWU4cFunWVel/U3aFT56nTAVbSCwU+l0rDxwp19yfvA68Klyvh5bs8z56hUqqid/3SRP2KP9E/ag6gGtiEdsPHDE4iWybmd+xh7zZ+yZ3BXq+/CuOIUlUN+nS/B3gY7nPdZc1fUDXtxD3z9ppecfDvKEHO1enBTvJYMYmXmbhOScGtx34cuCDaDxzcZKSfciWQ7P1We/68E3wpcFm5YpsQklUq7TRiDnAVav5/w8wXegIS8VTcnY4V50WbhlpZ40pCd4+70AoStbyT7S70S2+EdM3UeCtIiQDhN4v9+Zvffq7G+MfCDukYDpJLIyrX5fQaS1vsYSx/1eLX2eIUtwUPUECwrJKOH1EMHrIbZRv4km7tQL/GI3bQuRCnS6RPe2zPLH7KOB/MtlJnzdT+HPlv4ax7TY448qQfA8LMlBhuoaQUlfzL0Yt9BYyr18R6a73gCn5Hojep8Pfla9XPWvdUPmJA+rPIc8Dc2KXI4wVoKt4kJEtH9SuaeUDaeglfqEck/ys0bWcfclfLZom4zPp5R7Gk/A+PDptvQ2XQWxVzg+bQG6axC2p3QVCkEfQZ1TCoRTQknAPQJK0SkPjFcI9LVP61AorJe4apEh5EUDf1fwUnF1RMelD1IV1/TBSLdWZHk6VDPWmZmGwLzVmZm4z8zES6/6uJrnhodfsg3BAAbaU8XQNJZjaFaqLrUNz9CsVKJB/DGC8oFvQUQ92Iobg+wzTC4oTEQJAMcimkXyBF6eNmEKLV0vV2f9kMWFDBC5v0hgGBuzvSqBaQzWqAMWashj4sY2IVYdtm2ffRLOySObSFB5s/+gxjv1DedDGF/btmu8U1vymKZI50XeqVu+lvnXMtulVlLcXZrkLYniI+HtNgbGXSyM6nmQZjvZ+4I+u9hvPemzYFx7obL6RADGUDjhk3Nl3ZWY4WUb5DIkgneX3hrK5bBgapfDcZxnx+VyeOzs6nJoWG+igT80tQdmnkmMeCQncnT1/V0vgL0JQJ98x72IBqbj/UvAn9DnB1eIm+xrlymIcxbXRSxH8IIWnQzP4AXNM7gprxUthJPZuLovFncOTWSlJ64ST3bx3q6a618b5wdW3tiwuAyuONwesdweTfG/9kf7o5rAgqBS4Pbx9khrXT+uBrqeyPXxqI9fkOtjgWtE2F65PuKtHcn7U7XRSj0bwfuj5XeScv/A++MY/x5V/gbBB14htLddhT+v718hCW6PplwhzMpRXSH7/YF7uOLcPu05t//bKvcpz7m9dhGPxstry6wb5YV2yLM6RcynK3BpdGwm/QhT4ykplAc3kPRRXDgkYNxFFuGlPbdplvmqp7iBKsbnsGd8nk8t0NuC71IL9MDJtEDY/l/1WqCPnVQL9KOrKHfga7dUv9PX6NBikj7qZ2evXsyZk50pWfNb8eVWfTI9zm9wb/yGLrnzW3XF5P6GXok9/w29Mn/+4EmY3P2y1gL3a9LHF6scHi/v37cFK6gcbuurHJgh43S1DjcPKALCUhFQulyfjtZhlaq81mGVEqetdaCfOq+bh05T8RCWigdpfmXFw80DioewVDxIqpJVFQ/s3PK6hw/1pfTm8rqHRl/30HDmjUUDKoJGTQGBh0t0EE3qIB4+Ix0EKlxWEdFcWRER1hQR39J1TXf6x1pHfohJqYiIvCKihneoS7xDr4yIS7xD7fEOA+AdxqKOCOrqCMCe6iIALTBiIJS8zhVqLkFvmQkmsmG6rkQ/jMWDdxEGIhQXxEVLykPmv3kxeUV2YhVVhZhUD+tSTj7eP0IO65Xk5MN6ZTn5FI8Qf+2d4YGovk8PxFNZCfV9uhKlxqIy2rLv3ky4rMbiIDL+PWpOQWNx0JT6CDE5LtVYLC6xVGOx3yzRWBw0p62xeNT0+q0s1lgM/LicxuJRU/KD5gw0FuLbZZZqLILlNBaPmlPTWHxqNY3F/sUaC7HdluzmxxcL0PUL/LQE6JsH5Nnyyoqre/k0BehVqvMC9ColvlcC9G0DAjSO6lOVoevMwGmI0aVLPDKGripG3zwgRoelGC2Y0YvF6CqCReahFKQ51uXYrn4/kj5rQQUUBe9mWa7N7DXS1eZASf7uGRcLcei2AQm8YgxPjUMppel99YPrbuyKu4PlpekFZHp71pyWNL0QlELy3cGq0vTigstJ08fMEml6IThTafpZ0+s3t4I0PVBmOWn62fJke9aciTT9rD9blkjTwXLS9LPmlKXpT60qTe9fLE3vGzjePuOl6UoJX0nTlP5LcfqAXsRG7ONVvE/3vER9QNck6n0rMhJ0bFkkUqMqL1PfVsnUIlgLmVOsRmr770jW+6JB0Xp/5cjMG/oxn0XHllGBhlGADJFkMKB42DQEhCXX8ume0EeaAPSeOz22CdbdMGl1A/wCQwgPaeJDylGYfTpwL5kJfdYjgzcQDtPy6TSNFCma7hO01zcJib8JH+PcWJ9A3GB8yUwnsE1moPYVYy+AfhvgRBobTEZdAHyTW14jsH64TccuAymLlKSRjEgq+CvtwxYT6RzzRiXLFENGvKA+ws/SM1TK4Gn2OZ39FZ/xG0KhmZRBV7/+rSm7/bemnA1mHZssI6crtx2GLkmkX/moPrdL/HgwelZlRWQZoSjhVDUFkUpD5UzqKq0DI2Knf3vP39zzF//9T2/6SyXHQKlMQRRqo0eciexPglx5xAmJ1a0XK33NG3DcgVOo6DAqL5U/CdJLBtsEiTUGcMt9KKwSHQwbBpB/kB0MEO3aqDe/RYk/Ur9ZxWZxHgnv7RRQzKHzcnchwR43SvsXXfLLdIM5nd5kA735i1PpTVj2Zq9Z3Jv3mVpv2tKbnafYm8iNDvTls0v7Ml0tiwuzz8GQEoApCks1mTvYRTLsrwz1mKTjCHJ2avcJtX3KfWVolr35RN9EU+nboBbQLpZwOCvu2tzeLmTe0YWMuOlFQuqHxSXJPh0gXBfFCYuu3abZXJfvCkZBKDqV/vsx3w/KJCYY96cB49+60puknBFnN2mfoeuSotnGsgmiMmjxPZ0q7jsBZJgcaj72LqnOtsSfbQ35dE84kBXplP8naTyGXqb0RDgRTcTJxMREa2JiYmKom01MTIyMTch/SpsgmJjQE42JiWY60Z7oTKQTE8NrRsfTkvQTifwObSM7GLQn05IIa8//ImhP4EpdYQ/CvU60IP6P7MHNZrI9nlL4Z67UsjpnQCk+1ZiRFUY+oRddLDhwcwx9LhN5IC5UQo3bYwAP/O3/+bF7Hv7Kp296hofHYJ84zYkcH2h9lC/8wYfv+Yv7Pn3TkVN4YSTlUp+8uxM7T9LXNadak55lmsJVKxtGZWctqixYprKvmpP1KxOSPXm/2oM1Mbf04sq6qCw8hcpefrJuDZFT7+W1hB6aeA6lu2d/Ezd4+6ny6lOy38V+LOWWuatEn93uDKwKsxbX6Lghd8kzvMOgsnpGz870q2JXJT+NJCDC3egPWyT/8GnOcDTPForHTXtbp8x9JBHESh6FLmXGRRqgeQq225iBzwpDp7o2cZ95SJ+jVqbZkZJmiSTw2EOawbpIuXnIc4UrvNgpX2ylJ1u2V9SWLVpu2ZrcYAPX+eobrCE2j0GK0cs0HZ+MYpJ08DjybryxaierHFWTKx9VUSoXXu3c+2zQDuXpYIdD3+H+VYcd4i80BGrH7iUE9llEOULclad5w8V+vKi70Oxoec0Z8MUgcvCxiDY3TDzx+arU1n4DtvSsFnkSGcEnkc8rEdYsPC3G+/HTZ7yfrhhvaAQOVYx3uBzjLUVOwng3FjPe8tbpMN6NQcYbFTxZZ7zDZRlvKbaE8X5iMeN9RGdP9hnvpxYx3kfgH1F2+yZTzkbJeD91Goz306fNeP8YGO9/O4hC43Z/HClNzw+Q7XbBf85s7I4/LJ8bNnbH/OdBZjsmxEv2eWHIrfB9P3Y6DDkti58/GU/++Co8+WNnyJP/ZnCmPPnjq/DkXzhDnrzszenz5I+vyJMfPglP/qUXlid/ehFPfgQ8+ZMVT36oz5M/tYQnf2IZnvwIePInF/Pkh1bkyZ9elSc/6nnyLb0+T35BxZN7hhyT27DJ9wcrfkF59Tw2yIpXz79w2qy4332bzQUD3PgF/Yv/S2fMjbvjD5XHSuKOPVQeK4k7+lB5rCTu8EPlsbKIN+D95LsGVt3d+nC/tj0P92vb/XC/toWHT6G2Oh+/6kBPi48/2ZSdFh9/QZ+P/9J3ycev2q/T5eNXrezU+PgLTsLHPzHAx/ubVMkZUefjnz4lPv6C54+P/83geeLj9z6s3bnZe3QRL7lKzy1plHz74Yc1sfRA5YdqVH5wFSofLWtopSdbr1Ni4Gu8QVLjDZIab5DUeINVtl2du7+gz91/6V+Qu6+dfn0GvzpNDw8y+Bf0GfwvPd8M/gUVg/90ncE/oskv9xn8p6pSqzP4FwiDv2WWDP6NWnm4PUn5bWCHkABTsArU8SPUk1SYHQn4KA9wbbbzsN5tzc3q03TK64EPNZRkorJD6S7t+wMnb4F/S//jIBsjwSsxwumHkCv9QtXB1EFOjcgTd8DMDPWyJ5EvAuyIyAfvIjhhz8eAZon1abdk+D++KL+5oujbtYIDQDwAa1y3hK8SXLE0BEfwBx4abG/Qn6m9MKa1gayqS0DJwF2vfXx2AykKAjgfBPBOqCYw8Cnn+RvD1F3WK5hGm1Nd0Dp6lBY7Ggvrk5xUS6O8B3rC4N02TiKE92R/ASYngbO4n+O4QMbjMqWguHuIwfY7L+wRA8vprKl3HJTMpcuu6d5A1rTMWGjemEYAbJDMgV/T69I2beNuY/b7gf/yazcu2M0KRQTFtF/k4WBdLRjRiHdS9qz2TCkj/GkMOMeo8+U88Lm9NEyf74/SciGP+KjtlYGiz8OB6p1n4Noi5qujkiJkDwxaYu/aoysf0u8Q0Dt0BQEtvPweSdUrh8w7dA8MpFXuFlZ4vell3wgkyvObZ1Nr8xb8+vWzqbVZ0LSeLbDsW/n3m8oj726U7jXEDik9E6MbTguswy0SlzzrnlCXQUQdeGZ62X10HU42GKJwJzxaU+yDd+DKNG6j0L3u4bFcaEFZcSjOYEagMiq/Elj1sj81gjwJi2Q7TCOGiX+TtswFTtvuQHxoN6pWv4la8ndSZ5n1chFS9AAIp0eKDv0qwDgqBlDBiQ7Tu4fFs2NfWAI9tzabO0NBPbkbcCHnbTavI0YJUiqnXK2UltajpugSlnmzuV7jBbcHW3xB+9+/pvNhm8LNGB+HbAp3F3xs2xSOKF/TecembgM/ZTaFyThv2dR9S/XyNTbFjOQjfQ4nRdAM74ggOw7ImGcC2+K0b5azKPt2YDtWZ9+AnyAM/5pOv7Zdf7bGltklRqrsElqwZoYXv/uEsUP1Zyb7J1rN0YNn/8V6kG4260vP4SaREcVJcCGcK9a45tX5CEVIBvFbA5zXCu0wnGE0TeruDr2e15EJq4lZXAare+cqNRRpFQZRE0sbzHTAg9R0wswxAR+y7O8Cm9n0XDWZ3Rm1zSByKQFmYl9DnNLJst98PFglHixXJ3U+beE0O2QzO+Ac8QSQsdkz0CTxK5Mbfg5IEnACbxOmgVjDPnGut1q16TgDn5iLp3IDhioWENU4tZ3Bl7Z1Iv+SFLEd22KT/t1YcgszV2/V3oot1Ut3lpZesYklUxrQ1YjsstnBZTR2BF9mbLpR/apT2+Z2bQXiT2qHxNtdZhYQ7dnfB+S8BcPIpr2N6j85fTFcYEEAdoioCBnBgjI4w9PrmAsVekQEMQmERERI642QjUo3GESC2Sx7hq6wgK+90/chw3Eczmb/jFQGeJyP8mVGhdmSXRhFYQM/C/oglpKNoXJYOlWwW2aDmeRabTDwE5McR5OAahDAU99Bj3QdOP2Gju73t8EOfedsa2BS1uGY22CyzWYylY+TjBKoTUr9BZmXgd3UX1zU4/sjS5uWABJpatdA8bJSlcHSxTapl+tqTcF9sTKwGtmPBGIK0PadIYiqQfipO8Ne9g8Bf0QmiCYZTIEqNQJrrXs41YaJLaORMFSDiK4uN4BGjdcjY2i6wSxo1Ny1KXg3Qa7K/jGQErgGUw8/c72W9VNOpdyV/aQKZW24PWbKDKWs2prTrNxXt57+cLUpOiQMT7UaG9V/oiCxzD4Kys1X1qOX1FNNtDiLLK0lJKqtWn7mffJxJETgAvUhb0MJ9GPDUBisl5OuBaEF1aH4tuUIgsJxC8e3JssB/z4bXrpM16spaNnQnzYrzIOfBc9koCNO54qLJAsw0ymxuqj6H679xLMFWEHYM30epJTXUBHOANxgHf5t8+8Q/w7zbxd8Ser2hdSudjkLaRm1it68BEm5CQv/BS3ehoKnwfsv9NGu6ZCqnkFJ+4gWnz8fmOrzd9P5l6pMyAyzRSBc9A5Gw+qrCDyWFoHTNpgqVRWxly9s5M6bCefhgo8HqQ2y39dFg/FCdIZU2XPBOpgYNkq3QsgBDTrxg2WKshOBjTBYyR0OY8+spweRw3pynUvsIJm8T31Xowi/x6Pg98BdM7d0IH8ZisK78uKnTKG9TKFFphgtfdPpqj5aeXFnlUCReb81JYKviCAiTGQ1WQL6d9ixoI1QOFGybwThlrpkFGfP4tyMeTQKr94lKLUgQMROZbcaSWWnRLY2EKP9T283pbAEmaCLiixksJtMdmcE2mWAL1OWIOEJVCsgqlkoILAnvdLeYOeKFkSS9PX5/CrYhEoWumh/W+fY5TBK3GKKJo5OamFChBCFNXvrpZFTKY4ARNCY2Yule4h56lk9C5E8e1+UygumJ1kHRHIFSNg7SnGjHjielCgZSTlBrC77VlApZTQNAOjdcV0yqbFNipB9zJ7R2QeidTZkyJyPTEkrGRIiygoyDDk77y/pXdQlmCJM12JHPKt9yM2tppv62BvJlbD/PzNXwgAO1bnAoRp4YvGkhl21HthVfP9+ef9li7UhPGMa5DKKEp1JdgAEfN3HWR/FwaUEE1GJUaQKCHougISp/YbW3NoClvh3Xvw+FtbRDkOPdhj2xW+BTTi4SPze3xe/AZP2eCV+Pyji99Gw3DH76+L3g5X4/YiEmYS97E3hgPj90Zr4vU9XzqvK/TftBVhBaTu5+P1IKWr/elCJ39Uz88ZVJfAHTyKBP3IGEvi+cgDeuBkCjZMP0J2+nssL4+FywjjmVabt6WUJ+WiYl9B1fWH8WCiU/Ex2CsL4LywRxg+fRBg/3BfGD/aF8S2zpSy+qZLF7RJZ/B+8LH5sZVn8xnAVSfgt4VJJuHomkjCWZaTCfT2JJFy9W5fFd/+L9SCF9vJ5kMWfOGNZnHYdyuIk7F8LITdvMFl292nI4k8MyOLeVBQvW+dpyuJHKlk8+ybVjEak3adOIoUb25EXRP5+anX5+4gu61+x9rJcZ3G5F1DmHhQvTyJzP+DBUmqyZV/mFn8Zkbk/NihzNyqZu8EI2kGx+wHfjYYXu389pNj9wPMgdm/wdx0XyYvdH/Ni98dWFbsVO2TTvszd2GyytBK/GwOTUpUeFLg9eCfWNO33QtY0rfWhEraX1HVySfuJQUn7CCTtJ1eXtP9xUNIOS0lbzoVlJG0KTa9/vqTsp15AKfusxVL2017ElCW4alUJ+ymRsM9aLGE/XZewefKcroT9j4FPNFWTsMNSwpZIQDYMCfus51PCrg0f0jVzSK0iXT916tJ1tli6zkrpOnuBpOsXV9L13+rFcjUo4NORhPfvr0M1I5werMn9wcqSW3Ox5Pb4gOR2f7Ci5NYsJbd9AZjQk0huPjedD4EfkNzEx4vn0u2rS243m+xuL7ndzLRjA5JbOOtxcUuJjTy/SGzhgMTWqEts14eVxHZDWCQrSmywM1ZCW7JIaEsqoe2uSmjDC4vltttLzhQcRim3NbzUYRucAFa3WGhrsINfNCU306DIlrcotOW6kkTFATW7PkRuuuwZXZhZ3DU8z9CtIpCOgRnLDmjpfq/Q2bcCyI+yTIJXkMhi+YR6LGcDDtKhs63sd6IKvcBLjI1KYrw/KEljeUb7/qAmMfqov/2B8NlTWs87kiGoaN6q7J8RHgtw47QpgtnRQKS/gyL9/VyV6sqs74ubQnx4e50Nsg+WttRBEyscWgAE4WlUVzTq7axs5oA084pTETJLe/RiOfNvfTbAg9UW9WGgMXxOlIA/bzaPGfkEANt3jskU/ZmIZhs3m2NaENYptB2T2M1O7afDgz+15GPepPPFESQTRIxk0s+tGjP4zD1msN5oL/tIUCQSUdohwj0jSls28cJeK/uNEJkAMLkMbCcGvBwfh2hJLoblvQJu8I2ebcLem3h0EfwAf5KNM0g1CJa9BDUXEfnP+PdP+dcDiHdF9sNHj2+Ij6lAE2ZvC2X4CO7dIIPfxLG3zbwgBsL7ejv4LdwRCTKE6at6tgEljBTo+XufBQaem16aZ6wxNzbz2RjbNvNz0eZt5n0vlVvvz1YkuURYNVQ5wxzhQclz/GfMc/yn2nZtw6YeO/E3iXKKL+vxx+K4ABpTYtu8FXhBNPw10cdwvye0Lfze8RCG3DuJV+Q1hBi3pn9tKpIFMkATcwLJPDse5DwrkOIQ7snI9tHy0hkefDsgQs03tARpY3rw+O3honJHzEA5uOoobz6FYCDmUxR8fwD/9Kognz1hgJbTf6a80GiyZ79fu5cybl2OhqN92IUxOQ/ED2UhnMsngi123JEV8mJLuMWO2Y6XCYwdA8+vs38GvsCdgTj8vEPc3gMiTHddJrdGF1DTokqOrEpZZMyrbQfk0YYdF1lU6cCEUer9iMCGhLUv8F8XhD5xGF6E0AduqJN91XRM3wS6YlkDWfKrqGsCN0yXDHM7+0Bg24Oj4rLizJi0IULSw7zLuzqyXdzVMRjMbt902QXr0+XtOFRkPDtYPLTdyzvKZr7MbNFF74bL3q3xvVtjh7GwGbS5GWvJwnkbU+OLKzxfQ6QEvjNcjkhOqGG7ZtGrw7YJ04W0LkEMm1abP54kXzXhvJuPwC8KAkRKXUPmVD4aSE1kVjM7glXO8jXtyoO76tKwbUkGljVyNo0iTnr0UpYfYTt2VBbInYDI7Obrj4GEMZLWpilbWn+GsWLW8kxY70lZsw8GqR3H4/Fazl+vi90AXex51JpmN0cwXeAfxUSwyuJ2E82TVdl75c7tpXcEOiF/WoXw39+/Nu4XB6SWjURLEVUm/hbV9XQOQK5YY1P/ZqkN/H3+/WDp4oSLoe011V+j3ymlp6/pAvfns6p/XSzRfeJoRPs4OK8BIUTCIOIrPeOfAWk35PKIy0vimvLu4O/1x7g6Gn19asM9qXYQE6ThLw8RhTpKVJOGUFZWyeURgYH0f1BliwPfJ7fI7/MW+aC2gJaiVvaa2iUSegOPXCKR8FYJz6+4Jn3IrJd5OhDdkP69Z1D2NVZiUPYnyKiRyKflGZS9qPHWUGZ2b1hnUPjTnsGfWvLx5AzKA8lKDMoDiWdQnLlqJR5ld1gR2+4QMo7wKA8kfR7ltjqP8kCymEfZTcXxAv8+S972OP8eDSoe5VBQ8SgHgopHeSToZTedhEd5JDgJj/JIsDyPgucr8Sj96VidTWly5kpOhSPcYJ6lrfN40OdUHgmym5fjVPavyqlgthdxKvsadU5lRQblxvCUOIC3hKfGAZTlSg4Ax59wALzQV+cAypdrDMru79fu1RmUd8QVgzK6mEEZ57KTTxlbzKeM1viUUeFTfj20neyB5fiUpORTkmX4lFF2JFrEpoydMptCwCJ/a3W92qhLxJxFbIpkCF+pbMmmJHachqo6m/LAimzKBNiUxLMpScWmJH1tLxCrBIjRDsnhwZe7dijPPL+SVPxKAvBC2sjWWGPRw2JY+rhG+A9wHHZY2B6wBlsJljgssaBUeQz7+qGzQwX5mpJt6drhWiVrPO9kpOougZuEg0lKDubmAQ6mxHgSeKkVeZhhpIV3Kh8hD5Nsowmva4dBAd0BHqaPV9USNZvnYUbAw4xcyvLDwqyMLOJhao/BwwyntanrLq2feFhr+gyj8ahUkzbJHgrAK+tePkaMrHs8G3KslMFxfpc3A47yxxexISQrsiE3mxoLcpRn/2H+fYx/D/GvP/fbogApWZC7g4oFubN2G6zKgtwZDPIgdwYrMyF3BstzIXcGq7Eh/fvh1DkRrzlKy8FvMI/xojgU9JmRO+sXRY0b2b8qN4LJJzdyLBBuJFRuXrQ9Ufb1IP2AVjUPG2rsIu83r5mwB6eVtlHfbz6qQm1QdoMJixL5kxhR8ECQiGdig15MTNFFIKDRMiCgEZFLdS87oEsIz9R70aQ5tTgfl1RPSCJ0Y7BNGIpGdhCG8XRKiY8BuaSvSkF36JN0KfjVKtpU0sUfvoNWCeOO3GG87ThkeIgPeWhYUyAqIBetVh7QYhgwLVEZMcBX5AxGfdmbcam8hQkEseXRE26MTPVXizEO7dLXIntblJ4rH9fJYqrsrRF6sG7w4XtCPkzv80iztoRXFr2a+xFZIc2UdoKtXBivhQvLu8mU2Qeox4PKcH4bPQkaAOsKsruCdVDv4l9xJFAOqvlU1B0M69AyaZuGmXp6nvFolTbZT5cP4HZ6Nv1S/45sUnf4/rDv1pMwgaltin7PK0QrxNY84Zy+J7Savgz+WyEEUqgd1Ilbcja0S5jZgsua3UBtqKwrpvtSsjzvxlr4ZWIa0kYvD8182Yjp5VGVXgdpqpiaIfu1qIgvDaXxt0YF4KP01fQyYxINzHrAWBf0/td4OMapz55j45KG88g3k8dOlYtAlARZP4T2IX8qKtkdSbbUkOFLYfb2yEbZ9RFsaswpAcC/oARGE6tpjNJh9o6IvfIaUp9vKMxVPTcFg40CzwOII10/VUUk2mvWVnAsoHrAAlrZaugMr/O3RP6mAJ0HcqfxbmhUDIbsWo77t0M/7+us2Ke8OtevEX7EFoxmi3BWclyEcu/CNhVm79HruHBWZd/SeEfMGd/SfrWtyd4RAa+YXaJBUGY7u5HdDXPBN0b3SO/Z2+HBwO8unN1sGtXN5n8Vz0JU6+28pKPsN6I0tS2St8QOmR1CGtyjtEiUTefG9/htXHqk/A3TVIahs70h26p/y+4IccM8F0gVfCy7NhG49ETsGIrrgMKC49zPjof201Hlz556iryz5WF2Z8jwrsrPqzGsVZq+EQlZlLvVn6yMeUUqFe6Ki3kFmLLH/c/sgrgDSWQX3NjEXST77ZBnJIpn74XHyJsjf2hmb40wi1YJoIT0cbbwDqs/vspJ2D8DF/3KCcg+EIJB/6BO/6ilmMnuzneC6wm3uL3vxPJg77/3ncbMu1vLH26pfjh0h8neFeIfPwtVYBuWYlrgKrhT3VEsqmxTd/QDpXsVVyL7tci9aIePnsOLnujdi7LrIw6RtKtK+rwhEqRIMnDZjSj37tAd+4BxXz07+6F1JSFJ4feGnp5uC93evezu3r3GPfIZdJcfj95istvD7H2hu1t+v3uvcUfk9/+ftveAamrZHof3OUloAYnY+yH2jl0xMhwLig0bdi9GiEgLEALWK1GxYEVFpYhg74q93Giwd8XelWsDFRNUsGs+Z+YkgLe8937f+rOWZubsqXv27Gm74GCBFZ5J4foM2nz+YAZLTbBkZrD8NoIA8q1gjSBLTAB7l1vyZ9H8WRksn3CGpMbBbVb4WQo/m8Hy684SOA7qrfBsCs/OYIXlnL+Tge2M4hD+eNKaMoemzMlg+YPnSEocvGiF51F4Hq7+PIHj4A0rvIDCP2Ww/I470JEB/IVPOEmSfstgsYYh+fTAmmXOapIlYTXbeYdOp8uStGMBf+QP0lxJq2ku/OmZNdcmmmvTapaPu0xRvprlPxWjnMIz8ccrBI6DumUW+EEKP7ia5S9epQOwmuXnWOFZFJ61muX3XqcoX83yCVb4WQo/u5rl59+nKMdNtsKzKTx7NctnPCBwHMyywu9Q+J3VLJ/4kA7JapY8zAkDQeE5uFGP6ECsZsn7oDAQFJ63muW/UTgO3rHCCyi8ANefQ+A4mGOFf6LwT6tZ/uSfBI6DeVa4js5Q3RqWz3tC4DhYYIXPofCENSyfnU/gc9aw/LcbJIi/brtp/ZpkzZVEc2WsYflCmitpDcvH3aZzag3L771t/ZphzbWJ5spcw8oWSHCML7hDh3wNy28qHlKaLIsmO7iG5effoyO7huUzi0eOJjuL4c/oyK1h+U/FI0fh2bhhz+nIrWF5nZXyEpazmHGRZi5niTgX5mz4O+n7clYq2yTG7JDCMpazmBFi2MrlrJS4JCfcV7ZaLFj5EbbDmF2vFmPVXBD4fS3KWjctZ/E/ur5YeHdbVlxShFiMlxZPht7AAalFENa3wzog0VgZ3rJfxMtIpJhKYHAQLNxw4ALITt0MfcSxAjPCSbXBzRngmEgeuuPXBqkXXt0ZjvrzIoWUzkK+0Fw4fUcGX9KwWIu5hJQAK+0KgniDqLtwz8KboZcTY625uBiOiSTCSxJOhB0C4x2NK0uu8ruBYCZaRB8grMXAPxUDluykFXiXJ5LWxKs57YNuM2Nd3AlisHGaEh2mzwZy+CU5EQfQBhdfFpXua4kKEvb9TxVYkv+HChoJJXh1o4PSBITLMTHFO1OctBw1tMDwOsa7GtVtkbYpmV0stICj8sje1Sx6W6XlPFhpQ/JqIqxgVMraTm7xGO5IZA+pnALdMhy0bBnqk3NU35LYxvbCihEitMqzNFqaYAsgpfNh4+TFWCG6rSW7WlyRFev/Y0WWfP+hol/RL0hvU+MKpZM6AjWKwEOPatLWpfEuEurGm58epdFeogQXsPjqsCUeu3kiPUI/8SJpOyhpJkBMrBIQjyVEUIT6BrcLlsWxgkAJPbaI6BglWcboiIRxFA6SZTBXcKVikiLOjjgtd7UjJuWJqDw++oiDXemmnjZJaI3IcklK5ie+A7bBP2XoOVlkx2ORcGKioCytyrkO0Ls/R84Zn/KcBUsKZbF5O3wkcHXBlifk9iGuDvj9keYqRw6keJMsl+LmuOD/HHjg7Ku5Ook8uXK40/acEy/2robF2kCWxcodyNacj3WV4ftUe3Es58RjnypYMrcXtlFHszmQ0xAW2A1xdcI28IPJi6s9KYdeaUpxAQ6cLJjIsouDXaX4/i5E7oK9p3D2ZGTp/XE5imuZqz1XFpuBcCbxEpfJ2AB+GRZsGAsiLRJgglilxKqCZSc7LZbb4YcjTAb4yMLZBcsl9LbAyt/oMJC7NJrGXkhDRoK1DCe140JG1Rbf/dJXreJKsEMbnnV1xLfUZUjp+HoMn9I4O28nLG1ODMLjV1mJUJPcUXiVdcSGQjCJMCGudiUPMBYzK8FyejHkSs1ZWOlLYqEvsYW+yJOuWFDLwOuGqyNuD8EptndEDm5UaNzd+g5DbxeIi+ziiwOLe2xZltUvtshiau2yjZXyy/4z5QvukeyIG4l/oPzYv1B+WQvlU6p3odXIME3gu238zmUXzMmEJroQqnd1wl4UsCkTO/qq5EBJvQz1xiMh2is6lpNUc8X3eQ7Er1g1V2eBpMoQSdxuxOWQE8/GyB05qfdPWp/B9Il0YjlnzgGTuZRzxP/6VOMY2TVW7miZHPaYvvETj6NrGUzmUh6PqDOpxauavFyIq5Rz5sqRo7gz58SVCSaJ5WWwZ6Uy1ciUcQx2tcfNYDgpmRFlyNsdmalO+D97V0fKKDhn7BmKY2T7WTl2ZcWz5CLKOi9ssHcPB3IudCQCpRYjQw6kUkzcBCmY9IiuCRMilxIFAVd7nIG8MeBW2uO57OhqzzmRBpF7H1IEmaUOfAJ51HPBZCErNUU5e4IYwd6kRBD7pZOTZ6gZPfK+wpKh48pa7BjJzorlEp4NLiOyA5axTkxsvsiVKCDY4EllSycE8cBSMo1l8pI7qOL5K7JO3GLatCN3ujxDVSVxvd3I5MWPUbaWCiidioUN5d9PPxsLkUssRE6nH11mGIzPklMR38uXFYQ5S09Fj1+81ZMVCVv6snqqF1tsP8n24+koLuWmfglTKj+tn43lWZK9BJ/CayRRlaiKe098fHMUQyG9nKAqtZLHimI5LIRJeJUFCfJiHXUQlvYQIutIeRXZ9EpdLa6uOFY6jhHF0hnM/mITzZE64GMsTKYED6LXc0SAGHdQkHwV0UcpsnUi6wmDNQplF8Q84yWVdrZKgtIa4C81AC/mGX5OIkt3/dUwXytRPCtditV5hdc7O/zqRzkSplbaBduSg2P7l8GxpQ5yMTUz/LNElmOq4WGyp4aMJNbpQZzPlRGxLANS7GpOKpANfufF2l2UxAlhO0grwN/0WBpnY30zsEp9482LpC1rR67MHIPl9nTnQ65V7egMJHLTjOAwhuFEPmRVZh1FUmp+qzkDcglvNp+AXk7UcpeEbK49eSIyTVYZOROCdQUk2H6XQAwMWbioLySzcx8iHG1JyvbAq1LJpLxNDJ/FaMhSJyQrAUSRvI4AheJ2ikqXJ/preY4xfM4/lmcTU1zkf1PfAZGlu8T1nbiHkwTjBe+CdJ9EkbzuoKi7kwUXAtyBN9tGchLeQUvScBI+yzZSzvIOWo2G1+nEwRaUYp1fnhX8EP7SFBY3FfMYno3hC/6hvSwv1vJuuAY2hneO1Pxjxxxwac44Icnwa0KJkBC3/RcM6LJE3k7i0hgX/T/BuFTQC8F+Rhjhop5nsaNrhrwnS8kDANDFhr4x2ll0RclT4SOJVf/+H2eBY4lZ4EBmAV15yDwnAjISToSf6h3IYyhn40Ns0Uk5CXakxAgjJ+awxI5g34AnVqlYjsHndYnwAsvwxxlvTCv8Y4Y6ipIQ4pfgghi5HZ/F4H53J3s0FMkxvI2Wz3KO1JSow1okKxRpKi5KJBSF+Qku0dVO0Fd8w5CzGJ+DnSlydnwOE8lnMF5OLN6g0qiO8XJiyDJlbYUEX9IXN8keNwm3i7fRYoap1dB2iSL/2jiR0LhCppeThMcOx0gDxZhMJE1BRBuIbQOQdkpK6FYWMCFlJMCyLIMfVLHyKjV/7eNk50i/CC2ypbRoaWDpppdoOTYqydK6yaDhfsjxG7eNVu7EZ9XCE8BRy+tynDHGbSPlDO+i1Wg0Qq+wCUw7XhzDizDYTkueqOQMLl7DMbwiUqPhs8wQzOsyRRrcewfi0oZuZpzwLOfsNZglaDoyVNwKu4emkjsOlLItD1AiTtILyxFILfTN/2f61okZMXEJz7FyICQAFj04QrJiKpwCJSkVCOEzwSWIFS/plDyZEuQJhDyJ+UBGXoxqlszQYvK0si6gVCmMpKm4FMKRAY+4hBSGvX/ybzDJEaqkYicWqhThTZpNMeXR3SkmJREtjZCRmLMNwRsUES6Q2BDExdvQ4v8bgvJ2oqqiAkFh8peUJChxyUaIShCXiM5OG9L9WhgPLlpepyuASMq5HEtRj+CMDY867oiNMNu6O7ElK2MsKCWUKMKlk4lmLQg/youCpa5QwsEreTXGwhBiaarYurf5nxd7CVnqRZykD1nq8WaUx/K6EroKWOqX8LqISEzl5G6w1LrPWJYClqz7ePEttpTzr+s++39e963FkK0k9eDKsZjS2P9naz+LSY/5pXiXf16KSd3/Wvz/vhCK6ZmFLIRkDWT+I494KaaSTf9GHNK/XQOpMi9pVIkVsAxZAentGhHAxiSElaT6EskoTDDCBomQkqMNue7gWL4znq4s70f5AiMsfswvix/ZZ5IpJrEugEKpTowjebcNt5YgEkrAax5TvOZJhDVP8v9rzePxxYY9bYllYtpZJuavbdJS/kQ3hGLcGJGr01+bJjSvFFey+wtXsivNlexKciX7EpzIqThMDOY64cbaWziTpJgz2Vk5k3VK4+snygaIZGVwiTVJbF2TGE7kjS+GHIm26n8ktQIRI/n35YicmrAhOjk1pGNDmDQmHcpIrEglXL8zXZD8/n09ouyqmClb1iRajLAOhP/NamQrLBecjbAa2QirkaT0aiT5dTXSll6MgO5pSq5wtiWs35cabNu/DLZt6cG2LTnYkhKDbV9qsBkLZQqDbVM82LZ/WYbo1qnE0lNcCcOLiGlngj0LlUt+XX6sB1CssuEKxctPRTz69E2aihYQmT16/33Tcv9NEh20JJKVSnTbksiW0IWd8GtPxczIydwkskRkJIIf9fg5FWW1q1IVzDsnGdljsXRlsZNvfP5mZFfZEncGhEWV8PXNWnx9s9TXt9ji65sVxPxssJifmIr52VAxP5aI+REJRqwgKxLknwS1WZEgAyYq7cSbnuppow3Fjc6njS4jqM/ItjKyNRLpC/zKb5HxyCfPlM5S/mwy8SCP5UGSWCoPJDNi1MgBw7o7AUlD3kilOA2/2l72RMxvS2L5TSR0MInlZ5HQySSWX0hC2Uks/90Ohx4ksfxO8i0vieWTSKgwieXznXFIl8zy+2Q4ND+Z5RdUxKGkZJbfWQ2H1iWzfD7JkZnM8oZyOKRPZvnFjjhUYHm5zV/O4oaRt+kkVlqdNJx2hXcMka2SyAkAd0VayAD/yYKEQgsSPqVYkJCd/CsSPqVQJHxKsSAhO5nlbzxnZLli/kEyyxfQYF4yy89/QYKFySy/jQZ1KSx/gwbnp7D8JxpMSmH5xFwSXJfC8gdpMDOF5c/SoD6F5e/Q4NkUls+jwRu4BBrMSWH5OXkkmJ/C8kk0+MmCksLlLG4meRVPJij5lPIrSrLp6EpfY9qmJC2ymg+nJvjlEqzSjZdcIozrCpxIzpJDASMXc0Bt1YhDCJFi/Q/i+BiolBS5sSt+/7QooLP4wo91AinZ9dDrbhC+kuMPVvIXBwt5WYtje5BimywgPJKROWFjcWzPiajaOlZdIJyTCA3jl0ESZ4jGuGC+/DyWkFghjP83y/hnpFnGX5f66/hnpNHxz0izjL8uleULCHHPT2X5XBJKSmX594RA1+GQCyHaVJbfT8hXn8ryNwlxn01l+U8kxw1cCoHmpLL8SjId8lNZ/msZHPqUyvJLybe4lSy/gYQSVrL8UlLyypUsf7A6Dm1ayfIGAt27kuW3kbxZKy31XlzJ8gUEemcly18keZ+tZHldeTKBVrL8WQL9tpLlZ5JJNSeN5fNI3sQ0lp9H6tCtEKjq23IWd55ImaQSqspI+5WqdKmUqp5goRILouNWCIjOTrcgOjPtV0Rnp1NEZ6dbEJ2ZxvKbKGXr01j+LA2eTWP5fBq8kcbycS/phEhj+ZU0mJ/G8tto8FMay2fRYNwqlr9BgwmrWL6ABleuYvmkVyS4aRXLH6TBvatY/gENZq1ied1rEry4iuUTaPDOKpbPoMFnq1g+kwYLVlnb8G0Vy2fRr3PSWT6bBhPTWT6HBjPSWb6ABrels7wunwQPprN8Ag2eTGf5DBqcYxmAuBUsRgoRk0ojA5Cd/usAZFJ6laqBT7Dgf74F/5+s+M9J/wujE/D/yYr/nHSWv1GDEGY6y18loQRLW+avYHECIvKUTlnMX9qSQ4uURgCfZGlLoqUtSRnWSZfxa1uSMmhbkjKsky6D5TMpOuZjoTkaTLK0JnEFi5MQ0swgrUnK+Atp0kKldYDftMJS98oVLH/YHosVblphqWvlClbqAPiHKEfVBf6gNf22FSwfdwqvr/ijkGEbzbBNyFAH+LPWDPoVLH+SyC2etabX0/T64gruWNNfXMHym2gFd6wZLtIMF4sryLNmeLCC5deQCvKs6R/Q9A+KK/hkTZ+/guUv0go+WTPk0wz5xRXMSbJk+IYzOOMK5iRZ0n+j6b8VV5BkTT8/ieUzTpMKkqwZ5ieRDPOTaAa8ZZFNk+DNWS0qnWIXLCeWZqjyAglS5QWvkvcPxfLSxK6piPpyICZO/05sgrGcH+gekJcFS1FpPwhkA0/8LUFTmEBMGjLuMIGeyfH7jSxegi3pWET5aTl2wdL2FvHsqsKvIApPZG//+VNVrF1CX0SJngkNVSciL0QjROzJr60gG0387bBa2TIJET6jsvvFihKNoaTdG+AY6jsdhKZTeR7BlkgTwdSkmNibE8RngGCRJeZrLH5/sKgaGRgickq3lY7BsgQJ7bRjMP1EVmcp0WRgfbChFCyHMCVSTlUbyA/rVU3CF9tNiZdI61vRbn0hsyMvZFSIm7GgVwQgbU0pguGgGn4vIjLX2xk5ODH82XVEIp4Ie5ctSw4LMjFWxKA733XviE6LO5avw/teOYtdbi6TyEXU4A8RMBBbLG8B9fpBXxBlqSRrFdwW+z6C3dBUiWA3dKWEKNEQl21qOchWUmWWZxAagmGdMOQpWLIl4WwMn2srfBAypZbKJJScLBH03Hm3YCozzQQT66X4KkjLZ79hsEhcRwJhg6UfBT0XQU+C5cPl+FknNiqY1EWs8+DO46f4GF4W4k2sYjGCSoadcBx3JCoV1NMkUc6QLSNqSfZYNwWfUKSyZRLBRh9L7FgdwxdjJCbGxkBtyAfiBCg4RG5vAdhgJy0OwZwE6zYfIxf1DpjaHAQ7OCw980jpmUeM09sHy8WyJHwtA+5gS4ux422JJVk7i5lgZzwdiOp/sY0dRrCxY5FdO1Dabx7GjA3HhFjRYkvQYlOMFokVLRIrWvBrKvVuVxItNha02JREi62AFhGHtTMsKMB2JjhRyc7blu48OfBJSvSsPHCMcFw8hY9raUxVqXQoQz3icSzvQNXHRMKBkrKmcKo6xsqWYeKViwmR0wrEJU+UIgt5H2NobZFWdiqmJ1esNszIRVY8iYgNT5KPWFIQU6tcLCcK5sSCiV9cOt1zE6EdbKAJ+/zC04zEGVmaxKqfFltyXIprFAtZyAjRkwO2FCXG9eC6j5H+caJgOa4L60XSZojxAJFm0PrFQtNCiD8gsNZulUw4UkwYVMiIcQdn6x2KhaRk3xlB9FYupmIJLL41EUl5B1cxj23DQVOQyvGYOtHh5BnBXjInFqxGEQCVWMIop2MFVPaDyghiShe7MvRajDg3oggVUVPS5O1EJFiTpod96QbGOmJWGSmsXBXblnUk7f/MyMU80a9kqZyZiFq4E1H2JqJrYVsWmxGNpWOMz0ZY5pSIWlE4VtXHGiYE90dZqRx7yorFDiwxSohOlJ0ci23grvfCXRAksRhBp34R+wtnIjcif+VOWFT6f+dPiyW/8KclpfnTWYE/YVUYbDIMs6izv7AoDMOWyIKplhjWiQ+memGcPUnM8Mx/z62oXiRRvSGCb/gsalfSrvmJXxkSRUhppiRg439kSxQbJdjSktJs6WxJtkS6jRX5LLypRFf/lTfhTmT9ZfIQsvuvJw/jKibyDMLkYX6ZPBv/T5OHpWLZcihxMQZ0/2ehaetlmbSd1RsvVXAlPtkqBBMzpBwj2yIhzcEfsIDSfVawTyq9xBApfUE6kAmRi3n73gSdHBYY1gSG8FftQ3nHGLmEEBGfYWKCidpxrxCeCe5B+sPG/pyp5mO3m+ObQRxedJnsErCB4hSJYKqYT7gMajkjS5EQK3gJl/EGIVkitYB1x283x/AkCsfRUGzZX8iW/Es2ojcl6OHhcCeig9AUOLYbXTuJ4LjYi25AvCySPZbvsj/YbtI/RPTC0zOYLBOxPEPdHMu2SrDgFhCTtVVpAkwXRBId68tTzUlb3i6EWkYgA1OeE/H5JqYt8RnNUBHPlQUM5WOVg3ng6+NVD1tzCKZK1hhMaqN+C7DrWAmVCyUyYzyQN0TsltCBul8WNWA5nvGqRh1KW9KWSFm5rD3d7osasE3KsIAvzEXE9Cj+aYDz0mCd4qBbcYm0fKJK0YB1c2KElN1pqIFA2CLiHRqzRuwbkMee4wiiiKcEXqzhgW9NeirmBXe4sRg7RKERu9ZhqLYy8atAFSIE60fVy9oS05KcHKseiwVZ48qCY0LGCz/fiqlDQpCOEjb8MrnIqpxch1JDZbrPl2EbXpi2vChFVObZ7nQ/0Zat7Cylh6C2eMdJswDpbHBbto5UWlXQhbGzjA8VCdwukUpb/ROI0ped3OI7EqydkvoKujBionQMHGvBV7Qce24mqiBVqTi1RLZLgt+JqNoMKUqCpzvhwpHVSpbqQFpCDioRpIJ/aZajYBNSLhEAmfjRUfCNjNsg0gaTJJWDBYVZSzL8+NbWibF4KhR74+sFaQojnCLbsMJ0Y7tbDpat6SeZnC01MqLikcHkjgUhgJKf8FwlWMhuwFbG16RUV5VkEhHT9yQtzsVas5QaNGFA8THP0iZiohSICVx6j8u2ZatL8XO/yIIuTlwSXXslhGgEx4AURFljA1YmnNnL466SrQFpDYP7xzkTLtaW5XCKJrzgB5HgG2OfoFfEkf2uIMEt6UNdvnZkWtNFkKwXYtl+AePEBk5TaENUV5pCa/LCZ4OLr4x7g1cc8v5mx7OR5BG1+AOmJ5HgwZaI7/JizrabE9akxkZsmuBFNdKJohxPTTIBGxA0NsBBYc4z1jnDEMxaKElCe2Zj8ZEqO0AWB0xJNlh6SYv90BNKklgUcYBnqZdTS+HYzArpJit03loO1hzgbLyF23PAnRF7FqemJXj9Sz5HVgrW4hlLBlo5QR0xNfEPdUqlvSxzVW7L20VjJ5lYQY2wRLx32EVkpEvMThE5EPLYdgGen8W+ZB1A6m0tywaXRQwIRAqmbMhMd5VI/2am25CSxEJJmKlLixj4f0SwrKdAsl7F9FiCjxGiLNEnQpNEHE6EKQlTZjeyC8JvIG3ZJv83oirmmqV6LU38r7vdzQn+td9MyX4LDaTztUQ72WIKBWtLQWiptYfSFSxjY+UfkhLt4sSyPeRapCm0cbWlswXLaoE7tCGocrWjsdZ0CtkXuxnG896WZJQ7aFxt8SmhKbSWSzVY7gFTRA9iW8aGTC97Or1srFSO5UxKULioBGMQSYk172LOQLUV8DDblK6eVs7Z4upp5ZydBgtN4/lhw9mT+UGsUZmJAibpFGdnjbWWdoB/w8ov41xqplT/55xS7BW20JkYUpEtx8wngd6ASYD/Vk3ail6k5b8TnsfFdHdFlBQdQ+TE0fc6MRHSK60CmCURXs7FUBukNsBBHZDKoDZguYSISCrsQ+7KcFO2c+LtnblZccTLNpStUAzBXdnO2VAolC0H0tp/B7HdztlZ0lQDad1Sfru3c7YUZreds7ekqg5Safo1ZjcDvM5OOqdKtyhtUJhSG67pEq4eGxTo7h6oUcYEaSdCkHpskBoHIjThY5RjgkJxuJtapQmcOEipDrEk91dGKP0xqJ9GFRDkrw0KV3fTaIqLC1OFhWsmgpdqjCZaqZkIPZVq+hsdOhEGjYvWRAUoJ8KgaBX5HaIKUNPQQKU2WkMC0Wr80yec/HhpgkhMORHqhjWvG9C87kRQcJF+YcoJ0LQxx3FuQ90mQFO3oY3dhnJuQ5u6TWjsNoFzmwB9w2NwdcBHB0ZHaaFfeJQ2WqOytFKjitKCKkal1kJYeBj+0QaFaqFneJBa2zsoLEgbZUkZowoNx/31C8WfoUtEkL8FpA3XREar/gagjg4N9YuKUPqr/MarggLH/W3BAoTXhPXTBIVr3N3Dx46NUmmhd5BapdTwWq1G6V9imLRKTaBKCz6aIJVaq8Ro/6ck1hF2dw/QQh/SvegwnzFRKk2Min708dfCeGVoqJ9SixEPYzV0JP2ixoWPjyrRppigKP/w6Cjafi8hVfFn0qMuE/1DixGrDAiKjoKuQRoVSasM7aoMiwhSB7q7K/014VFRv45ElDZo7Fi1CgOUE0PDlQFdwsMiVOoo0kVLolBVjEoTBYRAVZw6OmwMjoYGqUOiQBvkHxIFHpwb15cLa05D+NeNC9dwLThtONfCza2Jm5sbp1EGCPDiUIvmUaDUcmHhUVrOrVkLjn6NgojwaA3wERqIUWEU/1vjxinVAX7hMSqNnwpPhL9Bir9KrVVpMNbDx6g0oORKdQSTqooEBqoitDTUVeVPA0HhUX5jlFEqd3f/UJVSA32UGgjQhEfgtFDX271uH/e6A7m6ERbcKNUBnDpcy01SacLxVIKe0WqI0ga4u6sm+KsicLutow3+JXoDAaqYIBpSctHqIC0XGa3UqjRq/KVPuPrvSDjSLyxI/U8EG6gMUv8ruZIEv5JnKeBfMUk+/4WFCRMxKihQDWql2jJYAg2HKaOi/MJUf/nuHx5GP/dUqktNX8oR/JSaMAtZgUcnSwBTF42GYZ4G2vDw0L9hkxrV2KDQUDLJMBkFhZaYVBpVVFBAtDL0b/qnDteEKf+uPDy6QcpQzA9hnEoZqh33VzSECzj0G6NUB4wPCtCOg4joqHGYZvzHgVKrVfqPw/zw72dnaLg6EMYoo4L8/aK0miB14K8zNYAmhb7RoaEDMXP7FeA/TqkOxAH8C8ox4TEqzo1QpGWGtaATMSSQ4DEE1xeIFx6o28yt91ioi/+NBWVoaLg/7phikAduGImpGkQFTVL5aTl1Q66+uj6HyVkVEMWFKScEhUWHcVHRERHhGq0qgMPp/nZECHZA6a8NilGBVhOtwssQlJzSA5RhEb8QlUapVUEo/i8iPEoFY5WhUaoSY6kOD4pS4Umm+jcWMVYZoPLTBoWp/nWFiQgPVVH208SKsZYc5iycdpyKG6uM0qo0HE3V6b9KNjZc468Cf1xRgErtr/rr2BGuolSTVGF+/uExSk0Qif7NHIrSBvzNFMJff8Whu3uEShMUHlBiGKyfftk3DFFq/cdZgX+DHgFiZdulCCpcrSruuaWCfx4HYUzHhEerA/52FowJVakDMP0GwDhVaMA/bXKitEqtKoAsEqoAjN8orUYZpFYF/BMzDFNO8IuKUJEEv855pTowOlSpEeBkEqn81OHaIH9VAN4gWZgQF9VcowywsqJfoiTyF5aAqTfAL4JihK4DY5QBfmRO4UWmBCX7h0eHhoeN+XWpt3z2Uo0BL41SHaLkuoUFhSi5fkp1gNKy7IwIGwVueK0tVSE3IiRwlIURFBOrZQvJjegp5Cr1pa6SqzuGqxvA1e1hWd6GQT+fgd5DaWeHgAUAffm+0K8P8H2gdxc/vndvgqqe0Jvv2x28+3pBF3Br0bJV6zZt27XvAF2a+Q7yatqeFkJI6beW0ALvEpq2ACUXqlIHasdxHpwbjA/SjmsGYcoJDVo04UKbcKqIqN+atmjesiHXnAsLUjewxJtwUUGBYUo/N/IVp23YkFN04lqqmrbCSZX+44LUKpw9KDRczTXooGrRkgtScwHh0WNCVU24Fs3aqVrjD2NDw5XahtAAbxwbQmelRhOk0vQLD1VFubtHKcMiQlUBDSh1N/z3jWYTrnjxonsBa4pm1qnO4Q6QjgnNbwj9ojUqLiZIo41WhnJjo9Vk8Dl/ZWioKsAVmnCB4VoO3DnVhAiVP+axIPxxWZZQSjL+24y+TA3Wa5eOQwdrznzd/+BCNLn8ju5/TtIiCj+ExpK/Fwj4065SVuYJ/B1XqSdNbUS0rGGe3za/vdZnTD9kKb10vED4be1pjfMb5FLRJ8QAf1Qu7VyA/ufm/NIN4HfUps3Lqv3PzWvapfrrJ20bof/cvIV1hOatqiPVdM0qnRDA0sxW5O+6tXkUKvOk39//UkHOL79uQoWVPS0NsJQL/Kq60gHF+S5dxH/5JK66dImnHXnlQX+/eFA0xSHLL83XQSj3k/A9EQGfUE+aI6b4OSp83vuXX5EdzegjBWBwAyUALAD0swcQAUAbKYAYAE4m+11ipr9AiXe5pfNXvkDjJuyxMW2djj4umpknay83wDltXqF+Muo83D/bfvVS9O7qk/nKvjrUUH6i0aOzK5GoXsRr9aoU1NLXrdHmchGGOQc7LHOEmWhNvS9TEst2R7qu5RqMKbsWxU9u8nve9DVIMWPWD/tms5Ax5kjrbrooQ8UKke7nBs82pOBmdJhrGLlEFNNmYgr6VtV7eoQkEa0zPx++F9KQf9c12buNsYjZ4Fg9+5qvwf2Fwt9v9zTUftUV3aRWa5Cu+6BN6mar0JrlLwbbbZ2GdpTRHdw6RGnY1XeZqUp8hME8aabko6gZ8hm/asLliqNRHf99n2NvRqI8n2o3X3rGoGV39h15uKQ6qq3vZMd8HmAI83W5azusLUooDKrwfXU8+ro9rYF9fBwqeDD54LODUahBw0zY4KgwaKfsbe+fNNDQp3elMUXdexgwzsUVAGwBAA+BPQD0baUJU7VXTSBsJaqF24BodaCqV7RWq/TuHdSuW7duv6Ro12/cxKgg/ygL1G0CwKPyAEMnAOjLA3wrD+Dzh1ISuO0hqty066Cvri9R6odp16RRJiH+GT1RNZfHNp6ksB1ZvlW9DdMURy4UTJpjGyHEFyss+YRfwzXXVrFT7rKewm8W8OZG0rwKOgq39xR+szDtiIV/NgAw4/Ma6NpXDd8aVoCrQ+rDw9ZFMOZ+FiiSlwGf0AX8+/+APx5thQPKU+CurgPX+nQGb5scsH/VDKovuQqva/yAhruqQ57HRihqMx26/tEMVr6Mg731IoCf6ge3FneAgTM6wMrCDjDPLw4afD4Cn2p1hEfmFeCcJIGyzU3gMHwehNUKgytT24L9hfrg5XMAVo1F0PSVHxyuHw3PX5+BTpPfwscOtrBkwFz4GvIKau3yA7tRC8BNNBgmf/OCgq0hwOmvQNvCFHi6uQb8plwMdtVewMxkFWSU94MFnuNAd8cM9aP6gI1NCzg/uAKc2xQFk5+MhpD5WVDlZHe4FHgC7PMewLAZjWBezEnYUH05dN35EKoMuQrrPSQgsTVDq6kIjrfMgySfR/DH7y2hXqcTUDPEBOmffoM2tdwh9t15eDu7BkxJcIXgOlPgpvoLuDUdDxU6doF95U/DiSppsP3kcWjShwdHGAWzfveCp5FNIfV0CrQaA7D32hTYu3EFtPO9Cbc9PsBaWWXoE/MNAtIaQcTtreA/5RNMyhwClSrkQpb3YOh46y5sjGsPdWpfgFtzx8PwQbUBah2Ctw7VoMrlx5DewgxjawZD8hAlbPvaHabG3gG56gC0zIuHF4bRYDp5CULb2sModAMqProNQzs+gkepS+CavAE0mJUHT4b2gdPnW4Ld04qQ8/sFqJTVD97X2AiVc0ZAs3KtYYbLGJjRg4GihSNge2Ys1Hz5Dnr07AKywOuw5eEd2OHXGYKVl8GhwTq4nrwXbDa8g5HjY2Ht8RmgVMyBuVETYOf84RB++wg03eAPhYYLsGCaCeodCwTf893g/N220GDTNTiuXAAu58aDuF55cPFKhZPDTsLZU12hz+7FAJXew40u26Gh93P4flMGcPQb1Ey8CBGXjVDOowjy3+pgT+4JOPOpASyVJMKxSA9oZr8HpN3ewxyXlbCVmwzN9qVD9yXHYXLL5uDoGwaajQkQklsLWlxYDhMr9gR+4hMofBwPeYkr4MmLOEhusQLmvAkBP7+28Mf3MtAjZS8ErguFSE1nWDCqJaRXOAj65/awoEVd+KjtAG6S6uDkyEAvu3HQxDgUum9JAG0uC0du1YGPv28AdQ8NpFc0wcLEDbB38Qe4OrA/XHF4B1xSKyjqNRV2+4+Dhx5+4DlKBDPjY8F3QENoF5AFYXdk0LJHSxjROxr6Rt6AboPUILU/Bo2KgqD82JtQ3zYNRon7wd6O9+FVzCmY/bkSeIf8DjXqH4blQQ3h9MVtsL38IEh4Egxz7sZDE00/EK87CuNtE+G9WwTAt/rwKnITjD3uDQE5nWDFwxmwFq2ALonfwWnWfGjBP4IlHdLgYcR8qHQgF+wed4QK7RrDSF0GDNctBVnZJeCcdwdCdTvhvrkXtE9whmGVY2DM+gqgvPAHnIk/BDLPI3DtnRi8o+vD6/0f4L78D3AovwXi6zWHgBkxYN+xFZRJrAr93bdAjbXHYeebHTCynguEHe8DTSethKzBK0CEZoB9wQdo7DkfwlokQ4e9tuDIVYA7J0ZA0ZKTcHp7L+h7fj1sbHcJXmxuC1uXJMLDzuOgiv8jiJlvgnHzBsC3++1gx+qt8LhCC4Adq8Hx6z0I6DMW3kgOQEOVGwwZbIDuZncI/nwIoo++hwZLH8NWnRuMnf8BxBcqwBe5Ddx9VgM67VkHQ6otgraX7KFv55dQ7ug6aFV7HxRsqQo+qk1w7dh6kCJnGDHhEtT+HAOT54khvpIGTm8YCOHqJ2B6DZDacyicvHcAtow9DDFXrsBVtgbsetsU5icfgxPbx8OsHvfg46gMOK0rhG0FzeFhfgqgkXrIfhQGCWdqQaP7+2FtXXeAnSmwfeBS2D9EDA2b7oVeuqlwz3YjxGwpA5OHrYaKLo3gwYGm8OX5d4i//wPij36HZzGhYLP5G3joImCmugJ8n22GBh62oAxsBY0qz4I+R17BntydsChMDcsCO0ALwwiIu90D3B5XhDNNu0BdZRs4F3EZ3C4cBEPod1gHa0AS+gyGP8wA1/DuMMblGhwaGQcRSm8IGZwDyQMY6OfbDmrePACt3p6Ecmo/GOX2DGY22ww1dp+A1S3bgt2BdfBq1w2o+NEVFgU9g/rm8eAo0sECz6bgcykDuPXJsGfNdWg+ygH2fu4MZe9dgN+PZkPq/WOwtdIROL9mGtgFj4RmvpWgPvhCbPkC+NN2FpSXBsByfgHMPvoI7n1vBCF198Pk+NYgef8DDhlWwbhgH+jZaBP4nBwOTT/p4fbwJCg8swyc+iwAzn0DrBviB+XRLtC1XwYXOQYiH86Cc4/2g2F0EfRRlQXGNgTmZ26D3VnZ0N+3B9T8WgaWaU7AWpuOkOXZBmweTIacbhehb8MvcOv8Wch7z8OUgEeQGnAH7h5tAetWnIDxQ29A0NNTUHCvHBx2V4BXZS/wjfaDa0eKQL3kNGxrNgrKdH0D1T06g/LkbGj4/SXk3noP8innIXxxG7DLOQXm2wtAHfwEMr+fhqV2x2DKKC2EbN8Nl9Rp4KGZDKfLBsPHK5uhYdRj2HfuMByA/vBktxNoD9eB57+PBu2dueBUoQlMq+wIU8cmAtOwIqRPioHv34/C4G4muDu1LeTfLQfzDh+Ckyu+QYtN9eGt+gQknmoLdzYNhr2b9sGVi2XAJb4phA9pDU0Gx0Py5adwizsEIb9tAY9GK6Gs30X4Lu0JfxZ+hYUdw+DJrCbw8kYcfNu7GUzGq9CszTlo3kEJ7V27QrW7Z2HaNwf42jMYmle/AwP3xkHf5PkwSH4RGvk+gKzTt0BaZTlUjTgIQcsCoN7w0YAGGCG2rDMU7isL3y4UQWt9U2itN0LeqIvw8LfRELgwFZa0MsG5SgdBOTQV/hyih/4zTsMdDxk8jOwBTas/hJ2VV4NrEy8Y9v423J2UBKsGZYHPrC8w2OYbPJ+4A+LlbaH9djkELn0AvnlbYHq99nA+NxX6O62D5Fa7YPPtMhAk6QGq3QUQO2cjzOm9Aj5fbQuuS/bA5Ok9IemKK3imP4AH3X3hT607BL7uDD/SHsNvN/xgcuA6OLxtEvh+WAON59QG/rAvDFPbgWujWdCh+wyIf/oCnq+6Ad5fPcE8+CVUdz4Pp4bNhcQvjeH6sVPgfOoK3B++A7qfmgUzu4wB11kdocnERJApZ0Oj3pNB16QqdDG4wJx6CTBBEQ+bTj6D5/cnw0n341Cv8BV8DJwLTksMoFrbGDot3QVHpkhhXf8HUP+hPwT9+RBSEqvApobLYNzlBmD/Zi90Teegb9J5iJjuD1On1AbnQy1hY9FCKD84F1zf2sG+tEYQPrUPrK/SH/Z93grTH9+C5Q+VULEtCyfd02HGmtWgeRMGHRZMgukHN0NIy5HgVX8EQOs3cA3Gw7dCX2CG9YGcSB3w77NAup3xxHtnvIdv2lXr8fNXl+T1SfHz/Da6/8UJHXF8RrWCDgDgydWd1B7H5dOftsXpa7wPavNjemNV9wqBwpGtfZefh8wfnZvFGNw7rtKnfHQ8cuQ7VqN4jBSDfH19fU+hxY0rXfH1XY8qZa8LLFt2mnDkO9vZ1AHne4HqnJxuPmK4jPYVOt62C9mGLvbzurZ19wwU5943Nee2Lz4xHwfptRYFSG2YU9WnY6qiTauvmzt9MKFRD+6sLDc6Uq/UjfdIyTehq2Nnyyb9lqCfGavOq/DUhMp9CGwz4Np8hXZmheuZd03oy8LPtXWX5+kffXjYMCTbhJRnXyj7fhytOJsaXbnbGRNKvt5qxLO1CYoZ70+f9zhqQmGTZ4zakLJC4Rz/OXToPhP6Zvq+pOq+hYqP3TWNl2wzoasrm0d0OuqhWHP1esv8tSYkVSfEtxYF66td/7FzbKoJlTnSvNGAwcv0/Ue4ZDNLTcj3Vd/5Jl0//cUWoVlH5ppQxcKbh2qfW6zPabp5R8p0E9rpO/Ll0+s6Rf+F688mTTKhHkvXv6pQTaef3P93xUGNCXVq+ci3oNYi/asF89t/DjYhw8ByaH78PEX0hfDXI/xNqN7rsjEr7y7X3xgpjssZYUKjm7t7fMxPUWw5NK7F7EEmlNZ+1oXpuYv0Ne5+k/frY0ILTmzoyofPVdyaP2ZORy8T+l38LFMySadY/uD3xd7IhBI3bXr6feFyRfsx0epJ7U3o9x7ad5V/m61AG3b7XG5hQu9yayU17q5TPJzyRNWtsQn9ZheJJh9crp/mX/Tn4zom1GKrfdifH6cr/nxUqyitpgl9MYRXTXXtpE+4ey87trIJ7XVw1ExvN08hFT3bMNPFhBZduBy/pLxaMbi5x+adjia0f2tmn+g+MxQVDrRw+GFjQr21254wnWcpWtzp/S2CMaGen66P6vBwkcJcMWC33TcjEo9Y2FG3dpb+bfoSv1MfjGhcv14X3/Rcor+w2b3dxrdGtLBp/2qfbJP1Y+9IwnbkG9G1tokeeVcj9R/Tn7e+n2tEFapd3lOlSrL++aZyJ5o+NaKw3o029kifqZC3dum94ZERzQ1qMGm0y1J9dd02cbd7RjQivlKPRRuH6hs1++jqcMuIqqV4B6Y2maJfsanf3aKrRlR22/HRb/y7KJrGK0fbXTYiU4BNR/uxyxVDoMYb/rwRTRStvvfnRbUiW3Fs35rTRuTm4owWmpcqHl2/XdDohBFl7pz0x+WEGEX9Rm1v3jMY0ficQa+P1FiqcHr4PXm33ogWro2E1omL9BubpMXsPmRE3muXPrj4aLa+89gra+7tNyK/9s5HTj+aoJ/ukza48V4j+jBycr6Xyyy985JR59ftMqKFt79XlrRZqrhXf1/b7juNSJI6t/mBpMmK72dW3HDZbkT2g6o/+dM/QdFwUI+HtluN6NXpKv1mnmmtOOA1bG69zUbUJiug8YuWiYoertsrhG80ovSYZGXPZ/P19g9iDv253og29TF1PNVqvn6mr3vm1HVGtONl4/gJA+P03ImLrb3WGtHQoYMnPLy8VF9X7ju9/RojCqgyVbdFNkQRtbn3Dd/VRtRA/pvBtGep/lLH2LGrMoxo+qHWs7e7BOsN96TRLhlGZNwcdtAU6K9vXlWl2J1uRP3n5Azq9ECnj0vs//n3dCO64jF8akCtCXqtX35edLoRZf4+L6uncZZeO219j5R0I5r7wrdmyyqz9OcCOw9+nW5E12/Y/3ZhZYICjXrkE5RhRDXW9zn0oOVk/WzmdVT51UYUkhU46Ht+oqLlMTfmzWoj8g29tfXP1yrFmL5X2r5fY0Sdr+xpfmr1HL1LVY9B9dcZUet2Hd/uD1qqL3e5d3L8eiOqaa7iHvebTr/9TG2vqhuNSD1Ec6ffjUT9myVdU+9uMiKYW2ZE4PYERfLYuXfPbDGiva8KjjU/sEBxP6NR5+fbjMice2rl6P0q/fyu+yq23GlEXf3eD5vxYbKi7fgKyTt2GdGMTjU31rJfqj9tXiwdsdeIGtYMnXdw8yj981OXMtsdMKJhhxKmfK4dqncecPZC18NGtOVzobxLlyX6fn0fpU8/YkS9Fo69HXp+pv6w7fmIt1lGVP/y4sbfdkYqEgrWTl980oj+iHL4s821MEXt2k+r+J81In/5GLn41Gy96vmoyWMvGtHNFk+ezqo+T9Gqac/81GwjqvCH/vrVPxbrR9X12C26aUTXWhhXtriYoBi6x63cqrtGtGd4lDouKE5h+D7RN+SREe1NW7ji0uPp+knvrxtCnhrR7FYXloyvOl+x/frw5PQ8I/py92rPRZMT9GP3L2hoazSiwzseDL57wlf/tYLPwTXvjcjzw4ZOZdYl6N2HPV+g+WxErZdub194a5y++29f38WYjajN3KEhT4yL9T1tVrtlSkzo0kM/h9tmreLasV4JNR1NaFvSki9fjyzW29e8PeK4iwntcdzptkMdpVg5YObD1ComlPg9fWTLpwsVk7LNfls5E9o2zP7qopw4Ra+rQ5q9rW9CgVX7tt95yV+xL9cmMay5CY2rsiS0SUigIijB9IBrZ0LX9l2cUXmuTv/lxChfKTKh8C9mNGr7Iv2UeNueTbubkPfm6PY7nBL07+Kd7Gb7mNBG204bZq7VKmav+/qg8lATcpZ7cqsWT9cnzThX8eloE9q25NjNfsMXKma2vC96EWRCvUKYbcPc4xSj9zLvXaNMqJbHXlvXm9P1fqmTW62YYkLnnLp3PNQoXt9wdVF5r1kmdH2O+2jxfq3iA5qX2yzBhCI1af3zT81QzOh95mv/FBMqWHx9kcvHRfp7CevW7FxnQr9raz9J2rFA/zZwYdMeO03IjtvC608sVNQfrjRWO2xCLV9vPpHYOE6x4nBIu8anTMg482qLzQFzFZ7d1CNisk3ozdOOzw63W6gvf3Tl9u/3TSjt0uI+HePHK+4krJp2LNeE4i+O5o9JBireRi5qfPy9CUF7ukNwCzyzdMj7Zp0YeslsGOHW/+fW4iZK6PbabDZfMZRl3tbZk3wOpZ+1eR7te8ogXEYbxuMNiO9NdIHsSK4YHB8uS05OPoc2dgvEOxOD26Oua+t4H0eqTp3Xmc0Gw/lbjRrEReqReVxml9fJhwwzs3d+nD7tALrU7Wp0uQH7DOmPck4UtP6IIOHFxNiLtw21XjYJnlDuIwJwOm4Mv23I2PfFbvS7Dwhy+pd7Wu624ff55WptuPoBwYQG7UccvGW4uveU1HsXjusSfEfdMhx2bN6q++IPCKByTDZ7y1C7s7xyeuQHBAkJs85vumm4W3N9ss+ADwj6iQZ38blpOFln0ZbBrT4g8Aw50e7DDUP5B2khe8pj+KbvG9NuGHqPPD0g4EMRgk3xHZZ0u2HwabJ4X+CdIgQHMzsUvrlueJQw4oL+cBGCiEVdLy+/bphQ9e47ZVoRgowjlWp6XjfMHuzlMlhXhEDnZXry8prhekju5RX+RQhy3NpXS7xmWBq78Und7kUI5tybf8rjmmFGN5vO5kZFCBLqN/zz5VXD4yO778udixB86tE4bNlVw+1Hrbsvel+I4NOhlED+qsGzwaMrXe4UIkgyJWa/yTacXTshy+NIIQLZ/crrU7INc+vmnIhdU4jgoP+AF92zDa3jbtSRzClEUDCrm/z1FYO0aZVql8MKEWRWiu7Z/YphUOUO1+8O/Bl3k3Xquu6yYXjc3q713TH8ZVcn9rLh66cK/D4O5x/fcM3oS4ZdhR73ptv+rC9hmZjJumhY9GPIqEXG9whk8YMbchcNL3tLM+7exPFpCypNu2BofEyWNfrIewTZ1y+ee3LecPBedOM663/CE1yaeXY7b2Cz0y/JF7xHUFBj3PhN5wzVJ8WdGhH9HoFbj6Awx3OGJ223e18e9R5BVrcNXORZg+eNPkkTvTC8/N5Ft84Y6lwwXx7Z/Gf+iDGKg4ozBm+n1dHjK79HMLpdasra04aEDh7tzjLvEWQcGNRCetrAf1r2R9/X7xC41Yn5PeqU4ermKqzDTRw/vmjyg5OGRt8PbPp89B0CuNa/iddJw9ZqjpOqb8bxGfq5mScMbvvKj9YsxXHvkORqJwxFq4cM+fL7OwSe6xIGzT5uMHSskbpn3DsEGRM/HXp/zHCkaNGMtIE43qTu2dHHDB3tzm054PEzzn0cEns5y7Dfc3NjphGG//B+oMgytOQvLp9Y4Wf5ul76I0MMhtRv12pwDC7fc7ldu6MGaY8+3oX5bxF4fvZIqnTEEKRaNKDozlsEGXf6Bn7+wzBl6pCytU+9RTC6OTfxwWHDy3oXtFN2vUWga5B7IuuQYX/VJo7Mqp/5szR7vDYcNByJ2D85c+5POGzbwyw4YNivN9WdOx7H23d7q91vuNeid5sFATj/7LAyv+0zPPSrn3Co/8/yc1Y/Gtljr6H3tZbryiBcf3Cfu632GO59lmnmNcH1n/o0kdttaLEvv4Fb1Z9wbkySV5ldhp2t4+59tcXlXwsO/bLTsCekr7OxqACB5/ieC+5tN1xObzTK5hl+DJv5LF+/1eC6vol/12s/4VkunvGrNxuqJj2ZsjELx9lWQ+dsNFxte3pG850/0+tuBf4Wud7QoVxG0v00HFd5zx251vA4d8DOrfNx+RUCnnqvNnxt0Ld5+mQMfz09S7PKUGVRm/n7gnF8wIC3vimGJp/z1xuH4fi0K2M6LTckNLl6ydsbt2fL/K8Nlhg2by84fbo9jn/mJreYb9jccmI5VQMCH9WmSpyhR9Sr+nUq43j+cZHLBMOyXeVtxHY4XmeivXi0oeqXeh9r5ZgQQELce1M40r5SHq++Gsc7teEfzEbNkqdlyvx/xnXHT669vBRd2m5UfKiL4fHlj6Wnotxyi0VnX+LXzrKX72SuRlt3XZig22FEkMVkj5i7HqU6pq2pqv0J193xnDFyM9qX7DBjsTuODzEF19+OBqeMts9hcPqk50nRmSjpj/HPmfNvEHBOT4sG7kaixVOk75a8weM/72GzvejyyK9jt418gyBryOxhNvtR2qPftjSpj+HBbWLuHUCXmoR4qN/lIxhdvW+XrYcQO3HjmrCjOO70x5kJf6Awu3Zh9eblI+ByW5brcgSJh446kjgUwx9FtnAwoPnpf7TaVy8fgefixhUCsxDKzTfOKHqNIHPJ9Jndj6Fjy+9Hfz/5M+52/pK63nHUoOcsx5rLXiPod2rDbdEJ1MTDdOqJ6jUCWSvFiccn0Lw55wJ7tHuNQDcppO3hk6inWw3XXvavERRcbdBh6Sk01fRuZt79VwgKKte5FHwarek0ukWNna9+rkdj8z95nkEbh15HL6ZjeNWirApn0bwoe5PnkFcIdB8GNXx5FtXvtTWhUZNXCDw/sW3/OIeuvltaLoP5CYcm1d/MO4+qKe7XSb/9EkE2M7L/iAsoYdcZSd0dLxFk6S8GNryIml9e8a7ZzJcIRve42ebDRRTda53x8EgM92p95Ngl1L5Hbtrp1j/hOVcOMvMvoxcDApv7OL1EkFApy973Ckq7bV444EUegoO1XELLZKMpcDH9siEPQfbSMgcjs1GZE0fvZSXnIYiYtSrkRjb6Wqn2lvpaDO/Vanbbq8guZc828MlD0KN2oFPSVeTrocrzbpSHQHcxx/zpKhrNFi5jbPIQjPO/7TfsGmq4Nse/7pNcBJvK27sduoa273swfs/RXASju8g0la+j43VXBG5JzUVQOT+s3vjraIhNpXe2E3MRuO386nPzOnIsd+v++cE/0+c0f2pseQOF7PdhQPYCKUZ0XhzKTlUs29tHBG4vED8KerwyLFBMuJHoBP1eoAPrb83aGLtQsT28ry1EvEC96w4KefVNqdjh/PiHedEL9L3MsN71p07R60/520LmC8Tce9Bj3LG5+g/HRtaE7Beo7FLvtOpohsLjg+S12fQCDWz6pKpYN1WvWzGrDMhy0YCJ9pFjzZMVLi8Dv5mb56I6s4/UewLzFcFlpz02++Sia8xb9WJWrU9YGegMEblIu3LQpchvgfo2Z6d+MS/KRTPERauOHZ2meHGc+2HemYtUARcbVpoaoYdz6I35Si6qPm+ynUan08dUrffSbMpFOz6nhTXIWqDIW7tSDLI81Kr38/7XYuMVi5osrQRueWjae7f9L3/M1a+MamUD/fKQvo0qxGCIV5yO78xBRB6Knlz2vcowTy+eWPTavCgPDbnQaY0a4vWPxXo5ZOYhh1457R/D7/q51Ryfm6/kIUm62SsS5ui7LFz8zWzKQ+0jJmVPnjZDccbvS02QvUSivY9jFnvEKw5N9ioHbi9RDJvUq68uVhFua3xh9nmJmo0x3y2Yukh/1UXxyBz+Eh1uX2/5lukReqe53QrNi14i06aAxdV0s/UezZIemne+RO2WDp+b4zlbP/ar9xvzFUy/qcfsLiNF/5VvOSh4iRxGzKm/Bc3V22R2KwuyV2jwvaHJPcxaxZcPf9iC2ytUOazx3K1H5ysm1lghg36vkNvECQ/P/5ij6NGsqAZEvEL3t97pFMMv0g9oNaw6JLxCLjHH41jDQn0vD59GkPkK+SGzQvw9SH+15o7b5iuv0N6IBJdcj+n6CeL+RrPpFVr7qEyOh02wYoST6r7Z+TU65FCr/Vmb4Yoh57f8MDd/jWooamtrMhP1Dw4vu2v2eY3SG80aJzNP1K9UraoDEa+Rh8+s7G7muQrPirM/mxe9Rp9PHF8+/scUhc8F8TXzztfoZON3xvpmf323kfw185XXyPVVR+MBc6j+sb3/J7PpNRopbbZCxE/TD4zZ96fZOR9VCT6QGHBsnuLpkC9vzc3z0ZvTbgtMPwL0dZ4ZHph98lF093z9OBSn/3ho0BtzeD7KzxlYsHZqnOLmouTX5kX56O2SzwtsZkQpUlzrukJmPhKXqRyw8Ps4/UqvxIfmK/lI8+pM9aNTFypiTn5/ZTblox9z0rd3OLpQ0fhTSkWQvUGRww9tWvx7tKLGR2cncHuD7p2JCEo4Fq846TzxldnnDXL8MfRUuzJD9c9nP2gGEW9QV+djfW7pYvVbpj9whYQ3aOTI74mLpmj1M9iQO+adb9BUpeupGrHzFR26hzaE7Ddo4C7z7lXMHEVRQtfnZtMbFH9xwOlroFYkfth6yexsRNeCmnKeM2L1D88OuG9ubkQBdtXOH4PJClPFzu/MPkbUf2ti5iazRlH2t7l55nAjGnbUtCvqwxC9k3lVWUgwIuas9LcFujh910rrH5t3GtE+rstNG5igWB3rUhWyjWjJyMGjP7H99Cf1h22hwIjKvmgzqqvnTD27YFKR2dmEJItNHVp89dGfmfu8JriZkG/ZqHfbps1VJLaeXmT2MaEuZ27f4NFcRUjvzd/M4SYUPSGpeiE7Rs+f/PyneZEJ9codX3j19/GKqU9zrpl3mlCLtVNSqjDh+lXPxleHbBPate1yL+O0SEWLEzkfzSYTGj47gmknUevVo1WFZucCdM+huvf2qXP1QyfNem9uXoBydn87ERS7Ql/J6dt3s08BGpF4ofUPwwrF9D6XRBBRgC4MfpY1A6Yr8i68+2xeVICqRrc7+tgcplfdc2QgswC9rvdiRyxarG9/fR0D2QXoY3qPiV9+1ym+f7/3xWwqQFkhtyIk4vH65d8PS0H2Fo2RhsXd0C1UjCp8/sXc/C0ytf0e8MWQpribctMJ+r1FO/q5RIyHFEWKr6szRLxFxkdPn3z+vkBRb1D9b+ZFb1GUpuMDN1isGKbo5AKZb9EcRqSbGJusOLCq4SfzlbcocH761pafVXq4MbfQbHqLXo/YmGaIXapYN2ueI8jeIfmI74tDdOkKUZeZInB7h1oZ0l8fNy9VxH3Qm80+75CmWbOpuUyM4q5rwyJz+DukdIyN+eNbrELhvrQ8JLxDjXlWcZ7V6Mv5+5aHzHeIrfWu1XTdEn3HAT9em6+8Q+8e+LSfap6jX779oBQK3qFTvFu//uaZ+p1PJn01O79HaQ1+mxMJ0/Sxftt+mJu/RxUOHECjzIv1gwM3OEK/9+jI9Hny6bHLFK4fv5aFiPfo4k2nk4dBpzjUfNhn86L3qP/G3U3TUKK+87WHYsh8j/5sHxMREjtTMeTc7iLzlfeohYtB5s5OUlTem/nKbHqPMgfsGhsWm6Qo3NmyAsgKUZ2ZVfzafQpUNJzXvRK4FaIu/R9oXjAzFP57l+WafQrR8PjdB4PM8YqcaHGeObwQDXp3PHVX1jJ97rFwk3lRIdI0cn9n75mqEG88+ty8sxB1+93JcMCcqH9UX1YJsgtRp+AHkQFZyfonHgXOUFCIqg+cKY2PXaG42uuBC8iKUNt1YyNV4tGKSfUlFcGtCNm3rH35smG5vnfE/XyzTxG6vVoi0bDx+s2D/Ezm8CLkEnCuzAtDqsJF9qISJBShBNPOaaemzlEs8TgngswilOVocLDj0/X6Kt41ILsINexe92ujaUn6+EkHc82mIiQOeqM7MDVR/+t9hOWeYTS5Z3husBGE4Pr6DktOTn6JJq1rSL6/7NYjdYT3O8MJVG9eY4uQXcYHBHx8IUgrnT30bnqTWwbd4HYN6uz9oiBQHYZuxlC7oYYjV28auI85d+zWVz9CoKMx9ByGDu1WaXzMTUNYv/03142pTaGeGPoSQz81nb296k3DzcDMVc/iXuipZCWpt+gndML4ZX5HbxhyPBouDaompnmB1Iuho6sfn6e8YbgY17tH8zvlaF9zinC9GLpp1iw38Q2Du3T6m/edH9A2Z2HoSwztEeTbe8N1w+jE/rNO7+Jo3gwMjf8A0kq6pJSH3a8bluhO3egzrC6F4lsHfjOGcn8efpJ3zXCn8YHkmpPrUehoUi+GznlUbnj8NQPKvLK//PkKJaAv/wnqSer9iPt75Svf8Joh5t7ABnWGV6T95Ui9GJoUdCzp7FWDeFDuOP3OWgI2SL0Yumnr1pGBVw0Fm6a3Ol2rloCNQlwvhvbY8Xme5Kph7HDJ95Ob6tG8WRga/wmklRKintRZm20oIyqcagxxpNAMDN2Modl7E+t6ZhtimxauOti2QF8MPfdPUB2pF0M9fwurfOiKYbYieWujIU4CNki9n/EIPriwveCyoc7OWSsP1GssYIPUi6EFjdS29S8bZP9fe1ceH0WR/b+dhISkQ0g4AgGEIHLIIXMfitsZERRIAkuy3DIJk0kykoscJEHUKIpEQIIHiiIEwSN44XojYRrClSAaTlFQA8JKEBVZXPCc7dddk5lMZoBdPp/9/fPrGZhOf6vq+169qlevqqd6XELq+OHdWG3IvISK42f3nbHX2TO74aPlm/qyli7zElr97K6Lyz526h5akz2+fKAXWvlrALTpn8RLaNWw4oXb9jiXvb9YvTE5TkFFQusJFSuS6//Z4Mys2ivYkjcp7aqa0GZCN57os7lfg/PM1tHHMpb0r/Wglb8FQCtkXkInXFg1bWK985uDW0M+3zeY9SOZl9DGeHv1/bud4b8evd9Z664rmZfQpuigyld3OaeMTSmsOuqNVv4eAI2XeQltjPu24+GdzswTf19398lo1q5kXkKrXi5QuXY4zROi14xc3dsLbQ6ENp0n3j9I37XfnBqww7lseljV4q/iWasjtIbQij05Q5K2O0eU6dO3Rna71YPWB0KrCW0mtKp3/O9z6pw3pw5MWlj2E/NIMu+f1HL6XJr41DZn++1zuqmW3sBqUuYlNG34ocHvb3WuWBfTfX3FTV5ofSA0QeYltKpx/n2fic4L008vWuGIuNWDVroCoPEyL6FNR9XLzzqd57XrZqSWMOuD0AYX+NgheWEDtzhH4NzgobrBt3rAMwHApp+ItYLju4nTl6XO3OwM3WKdMjnyOlbLhNYQ2jT25tzHNzl3b5h+Wm9mvkxG6wOh1YQ2E1qtPjyq7gNn9qThSTfO7+yFVj4QAK2QeQlNO/Xo/nPvOb8o0tYbn2YeJ03mJTQ+VAjr+a5z8syd6dODmLeS0eZAaILM+yDJ3HPFZ5a3nV93/uXjL2YO9UJrAqHxMi+hFet+MNjfcoavWzZ35vwurJplXhmNEVURbzqXP2ZYsHrqMC+0ckEAtIm+4V4jo3FzvrztVWdiweFT8x7s5YXWB0Jpnc3STKio+deU4pedP6w9rxv9+9BaD1r5UAC0WuaV0T8/fGT1OueGPwf8/H7QzyM8aH0gtILQMw9xfGxZ1HMPrnGeDL9v/oCKG2s94KMP+wfTZNaHSZ9DYT0/fNppfunXJ1KXDmK9hNAGyvr7xlfEZc5VLx341/zeX2/2gGcCgPEy6UKOj42ePbjpfufJhC86CCfiaj3ghgCgvMPgq4UcH0Qnfyzk+GDxRyrsEY6PrSzpGl0hnB7y/MrZu5hfqyCw5hHS4Ikpk+KrhP0XT4ROP+aOSwhtoKz1g/qPeUbQRU7TbKpmrhgENlPWhG8r77JUCymf/TRDjOGYMX8g1kUcH3vTwTcy1wuD/qgtKYpl1qogsGYR2WNNlw1PviLcO2Ba41PlTIcEQutl9Mu9RXteE8IGHbnjfHYPpj6hzTIaKqrPvCHcc0v9+L/ERDFf+z21kkrqb6P33fL0W8JzqztMukvjHnkIrSG0ad/LP9e+LXyWfPTFmbtZr0gjtJ7Q6qeTpjW/K/S+7q4RoQ4mcwKhzYSKZyIO4H1B8/3zNUt7n1XaEGTeR6kypt41U/uh8MUdtTfPiOnHKuMs8RKa9vrS3Xd/JJzKvjikoqozk4rQejnvZm7Kos3Cgdem7dw32h1JEdpMaHzEAvOuLULTqH+8mS0OY1IRWrmYNDpqXn7aKfwRsXb8YZ3bm8q8Mjrwwce6bRXOhw37pOxHFh00fUe8hJ7rd9+QDVsF3UrT7Y+9zGqjmtBmQisWRqbv2yasfeeBPTnPBzO/RmjlEo7vVtV14+/2OqGycFy/V4bvVGojgdAaQjdqF9y6fLtQ9t4fqeULmD+Nl3lldO3JUwN3CLvudZw6rWX6Np0hXkKjl2xJnrxTKLtpxNDFn7rjDkIrl0oyF5Qs7nRup3C876pTS2Pc9iW0htAJtz+8tHKX0G7k8oLoTHcMTmjDUo6PNX/35pbdwr6hzRtSbw1jFUngGQIvHps2rV7Id1VPGXQ+jPk8mfUxqsdHR3z/RIPg6DtpwshC1s+bmomV0Mbpk4+o9wgbjr+WvFTP4kaR0Ho57y2mRxr3CO91Sp26fRyzXzWhzYRGn9v5W/7Hwv4hK3YUnv1J8QNphFYuo1o+uPHWt/YK+o1dLw52sQ6YIPMSGv2tKyrlE0F1wZI2sNM2xQbxhDYs4/jYL0++/vMnQsxjH9m79m1QCoZMS1k3vp3Ta+WngurryIaze3qySj5NtFUc321KUpppTqOwPPn72KOrLjFnSmgNoWnpWcO2NwrNZ0bELu7OwsYKQusJPU1Nbp/Q69yLtqi+rBOlEdpM6KXX9syYvU94IPbFi3ufdQdoMu9yKW/2NNtK5z7h/do7/vr9S+5BS+Yl9IOo3FFd9gtnNo3e9NUjLKxo+pZ4Ca06Nv/clv3ChZAJY39dxYIDkdBmQtMOHP+pywHhgxF9D8w7wQxYTWjl41SRW+ZmzT4g7C79aePevBimEaE1hKq0pRO3HRBm1Ia+l3pLd9Y9ZV5CTx/q907cQeH5pqqzhpPtmUYyL6G752xbOuegUHI4K/yTgcOZK5N5n6CSu61uqj8orD8S0bMyngVZkHkJrTaFvXH9IWHqrowHCrawSWwT7ZurJ7Rxd8rFew4JPybc9cP3r7PgQCS0+QmOr2mXNvXr2kOHhGP29e0H8xFy0V3GAREAeACRADoAiALQkTaYAYgB0AlAZ0oLoCuAWADd2N4hOhLHAd0BxNEmMJfLRf/oWg8APQHcPhaYMlZJ+8o4oBd9F9GLrzeAPj588YyvL+O7nvYopRRrrVaNWdmO7sgvGmNLTrGq1bbs9EIrbbUtLhpjG0W7kZR9SK+MBZYktuRT61v2sdvTc2eVZF4mu7yfqWmsJ6+WkSqZA+d8pwzoNU7Rlb7xcHAsEHzB5WorgyMvK6AMySlWc8t+91Y6ZYxTbMaGGsxIBPoBuIH2yblcLvpH1/oDGEDWHwdcGgdEJgIHvfJ528ydz9tmbnnNHr0deVmX0z6wzF0SFT46yB4DpXYwyMNhcj/NYhSr97JEWKpXcvyBkH3FqzH5+drBFQUTO7pcfxlILTUDwOlgIHogUL2QQ8JtHVGx4hng+M/tSCO9FJfOATDb5XJ98pvL9bjT5XJvqHT9pwe4oOCQdqFh7cPZhQg+skNUx+iYTp27dI3t1j2uR89e1/XuE9/3+n5Xh/8fH+CCQsKCQ9ux+ggCaLecGAKI7QAxFBDDALE9IIYDYgQg8oAYCYgdADEKEDsCYjQgxgBiJ0DsDIhdALErIMYCYjdA7A6IcYDYAxB7AmIvQLwOEHsDYh+ANrq+zQF1QUBdMFAXAtS1A+pCgbowoK49UBcO1EUAdTxQFwnUdQAORAF1HYE6IPIjDpF1QYisC0ZkXQgij5I+X3UKecrXzo3Jiidxb/S2VK/m+KCTybCIqzn+jsSR1pGpUyfInT5xpDX5b0mjJo4ZKZ+njkkaBXZ95PjEREvqKPk8aXzyqFTLxKny+aiUFMsdo1JgqVrD8ZY4RCAujjoVWB3T5krZu8pHHGIi4uLigiPCwCGc7w6Eh/KEh1Ieymk5vobj+0Z5MkR0oMsdyFjhUXKBUeSiLc9VczwXCcvL1Rzfldyz7KMRHinni6S35RCliYblOKUhlx7SUU4TrWwgprdl2VqO5zrB8txaju9N7lf2wQjvJKfpJL/JK/To0QOW/Ws5Psr9F9PPsuAFjue6wLLsBY7vSgODPDogvIucoAu9LbWUJhaW+hc4/kYaROSRBOGxcppY+e3ZlW+5beTto0ZXTISl4kWOd3FB8H3RU7LZC1d+cWkh4uVe7Y+0ffmkOOT12nF1r1b5D3u9dl7dy52XfpSjhuODqibB8uTrHP9LMKf0Xbh3urZjO129d/T+t6O6e1RwjwTu0do9SsezUZlGZPfI4x5t3J79RgCDAQwB6Afl6DdOcROA4eThAagBaCQnoKXt6Mxn0xYFI+1JoC3lAP1COT22Xx6xKJKhrQ60+E5bFywAbqM+TdEFAOqmowHcAeBOAGMAUMBBg04igCQabWinOe0uB/BXABMBpEgjdCqAvwGYBGAyjVi0lx/ANADTaYQFcJfkW2YCsFKU9z/kvwfAfAD3ArhP8mv3w1L1LscHVc+AZf2H/98SgHQAswDYWGRgB5ApBcxZUpSQLU1uHNKM7W6KBqQZcI40N88FkAcgH0ABixQKARQBKAZQAmAugFIpli0DUA5g3mVawv+K309LqN7K8Vs5j9NMn2XLsGcqrrNsypBhBRMcY/KSZYsA/Qvk/z2PBpOflsIMlssM0p8p4T4vZ59TmeHcaYd5pe3PmvvN7DzJ6zyFNZL+TFmw8ztbpbec28bxnwe3BVoXJN+lsLf2AXSkZnr6ouUq+iMdm+2efmm5Qt+Uo9ZMTx+1BPATdGzM9LQSS4CWUswsXsJaC1iLSWctpMjr+pWM479C29Zbf1a+2xizvM4zvM7vvApDTvUq8+oMbzm4k+NXhM+3ebqJxRP+G2jKkGPXZ6bb7MUt0xwbIM5lT3lh+ews33/avRiP3lZcXmAfU0qPsmCTG5V8yT33kB9hYVOmcB/bWgJkkNz0eYF90lGVochUyGS6XPdlbEZbfobdNrd4jM2mVlutubPkx0VZi73k0bAkLbMhWaa8DEWmxIy2Mi3K8MgUYldkmsdkausygAppWvqAH5luL2ojlMzZdAXOMsb5IONcIMnxkDQMPSwNQwulYegRSi8NQ5X+OB3+OVPtgTl9yyhtW4RcxjNXLsPd7qxWR26Bu90dsyvpPTw59JQ3ms7KODU+f3gpw+Nb46zN2VrkSsgM3K7c0+G8ktwCetYSyyaXW9y6XE+aUk+aZ1gaOejOBB6Vhv3FzC5LpKF/qTT0P8bspssEllE7ZvhyKQx4XAoDnmB4Y5Zi1ycZTrOqFVJY8LQUFjwjhQUr6aFIUljwnBQWrJLCguelsGC1FBas8bJRXkmuNcterKwWmB0tyy5WR7G9UFkk8L+K4ukRZqu1pRSvfqJruezdd1dkKXVckeVZftnIzun6iKy2df9BFiwXPuX4Bm59tqJxNdN4rRTYvCAFNuukwGa95MpelAKbl6TA5mVaxJICmxopsNkgBTav+tG4NKDGpW00Lg2ocWlLqynO9q+RKrutRkuyYdm9j+O/4pY4FI1eYxq9LoVeb0gDyJtUihR6vSWFXn+nmTiV5qNFQYnbbvnXYDe5lLZ2KyhpZbeJDmYfh0fLHIdHy0t+tCx2wLLxAMdv4VLvVrR8l2n5nhQ8vk+WlYLHD6UhaZMUPH5EQ74UPNb60bI0oJZXayu5lBZb3XC3fy2aHG21GHE3LJcOcvyzfOpsYIsU1jqZFrRCslWaZGyDvNqB7VJQs0MKanayJVZKv4s2YkuDcL0U3DRIwc0eabLxsTQQ7/XyJfR0yWvuhHIhisHIXh1mt5SvUVmtbgorrWrmF6Znuf0dpR00W9F+N6uVYC/t42crn4mzPWvJCTnAJ1Iw9imrh0YpINsnBWT7paDiAC2nSpOlQ1IgdpjVA6X/TPJ/R6TA5HMpGPtCCsZoJeiYFIR96a8erqFrBlBWNj3p2jVH0bVxdmBdTTkeXU/mAF9JAeLXTNcmX3mvsROq3fIWlBS77bGDyViR07Y1HvOSLSMXOC4FiieYbN/4k+2/6TqsN/TKvTz/pVylV59k/KekofcfdB+EFn/pnhXdiJPivu/oxibdcvVaslbl5ufZy9kQmjhL1apKZKx1fHUkV5Fpsx+ZzuV6Yp2cPEWmH5hMPxJOX4Kgb6PQF39oLKevndEX8aQY8GJgmdQkE3FOyLs8ZxPjvMQ4f6GnAkqx3W8UF0ux3R9SbPcnLXgyl8Nx/jlLWT0Q5/YrcKbmK5xBnMJJawwhHNCOA0I5IIwD2nNAOAdEcAAfmLNFT1P+5TkvMc5IxtmBA6I85ZoVs12jI5NDRU9B7n57OF+xf5U/GfNhWdXE8c9yqwoUCTsyCaM5IMavhNfgYlpL2OJZ5hUoEuoK2kr4ZAEs4nGSMGGOImEnJmFnDujSRsJrdSotEroHd1nC3nMUCY/4kdA0B5aTJ0jCk0zCrkzCWA7o5lfCaxiVW0vYUofbmITz5/jxPHNgWXSS4z9sP6NQkbA7kzCOA3pwQE+PlKZce1FRepa9qFVoo3Vfbe1bzIUsKihsy5pa6Gn/7zDeXoz3Og7ozQF9/PGWevzoqsuUm8Lmo3lszp3utWiQxObI/rBUr8WJIj/4ZIZlsPyB0qWyOXqJ1xKXb5rRDHP4wVLY38VeZfhL49bRVy9fXXxl95XRVx5fGcAWkdJZ+SXsvNBHHztbYCkMkCbJ65qN8YP59wIv/hyf9OVeMpR41b33tRyvdBZ2LYt9FnnpkcLyFrBrdrZ2Mouds2YlL4rZWJp8P3gyuz73MmXczv62XSaNd7361qNvnfnWlW+d+NaHb1346u+rp69evjq4y0ti5xOUVcyPz3L8vMQrxOVgMeDlYlb5SxtzgXgO6MsB13uNrzqrtSg7vdCeYbXll+QVt/iZ9XNBP3XM7+ZUKpVapVFpVTqVXmVQGVUmlVmtUqvVGrVWrVPr1Qa1UW1SmzUqjVqj0Wg1Oo1eY9AYNSaNWavSqrUarVar0+q1Bq1Ra9KadSqdWqfRaXU6nV5n0Bl1Jp1Zr9Kr9Rq9Vq/T6/UGvVFv0psNKoPaoDFoDTqD3mAwGA0mg9moMqqNGqPWqDPqjQaj0Wgymk0qk9qkMWlNOpPeZDAZTSaT2awyq80as9asM+vNBrPRbDKbYVn/I8efD7nSLX80PHtLMoW6trKy9FmOuWq1gerIkWuV1/YceZn5LSsku0uB6HlA6/RGq9WWQ0+yb5WB0l8qBc6WKhbpVQb044AbOKA/BwzggIEcMIgDbuSAwcrzLVDN0g3xSTeUA4ZxwE2cDz9NK4oc/kSQZSgrU7jllVBW9nCfslUcoOYATZuy1Vbr3FxHIP0OepU9pVy5eaTlAB3TJYFd03OAgQNSis2e3wthLU9VLl/3PD+elX1nuZKfjkXlys0pIweY5HLU6pz8LIeN/TaKrKdXepGlN3vSGxx5c9NzHBnW9MKsEvmnedxf8ilXypdvD7B8N3vyaZQHuDMilqeJ5UkpNrfUiVsfzIPlmQscHzzh8eh/A+vUam2v6wYA";async function Be(p){let x=Uint8Array.from(atob(p),g=>g.charCodeAt(0)),n=new Blob([x]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(n).arrayBuffer())}var j=20,Et=200,k,q,P,C,D,ye;function Se(){let p=k._live_values()/8;return k.HEAPF64.slice(p,p+q.length)}function Je(p){k._live_start(p);let x=k.ccall("live_layout","string").trim().split(\`
\`).map(n=>n.split(" "));q={names:{},length:0};for(let[n,g,F]of x)q.names[n]=[+g,+F],q.length=+g+ +F;P=D=0,ye=performance.now(),C=!1,postMessage({fields:q.names,seed:p}),postMessage({frames:[Se()],ticks:P})}function At(){let p=performance.now();if(D=Math.min(D+p-ye,Et),ye=p,C)return;let x=[];for(;D>=j;D-=j)k._live_step(j),P+=j,x.push(Se());x.length>0&&postMessage({frames:x,ticks:P,busy:(performance.now()-p)/(x.length*j)})}onmessage=({data:p})=>{if(p.start!==void 0&&Je(p.start),p.paused!==void 0&&(C=p.paused,D=0,C&&postMessage({paused:C})),p.command){let x=k.ccall("live_command","number",["string"],[p.command])!==0;postMessage({command:p.command,accepted:x,at:P})}};Be(Ze).then(p=>Me({wasmBinary:p})).then(p=>{k=p,Je(1),setInterval(At,j/2)});})();
`;var so={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Ji=.2;function ro(i,t){let e=i===Ji?0:.02;return`attach ${i} ${e} ${e/2} ${(.1+.07*t).toFixed(2)}`}function Xl(i){let{act:t,view:e}=i,n=[...document.querySelectorAll("#controls button")],s=l=>t(ro(l,i.held().length)),r=0,a={attach:l=>s(+l.dataset.attach),cup:()=>s(Ji),hang:()=>t(`hang 1 ${.25}`),command:l=>t(l.dataset.command),pose:()=>t(`pose ${r=(r+1)%4}`),restart:()=>{r=0;for(let l of n)l.dataset.toggle&&l.setAttribute("aria-pressed",!1);i.restart()},toggle:l=>{let h=l.getAttribute("aria-pressed")!=="true";l.setAttribute("aria-pressed",h),t(`${l.dataset.toggle} ${h?1:0}`)}},o={pour:l=>{l&&!i.held().some(({kind:h})=>h==="cup")&&s(Ji),t(`pour ${l?.3:0}`)},push:l=>t(`push 0 ${l?15:0} 0`)};for(let l of n){if(fu(l),l.dataset.hold){pu(l,o[l.dataset.hold]);continue}let h=Object.keys(a).find(f=>f in l.dataset);l.addEventListener("click",()=>{a[h](l),l.dataset.say&&l.getAttribute("aria-pressed")!=="false"&&i.say(l.dataset.say)}),l.closest(".weights")&&mu(l,i.say)}if(gu(n),!e)return;let c=l=>t(`push ${l.toArray().map(h=>h.toFixed(3)).join(" ")}`);xu((l,h)=>c(e.inArms(l,h).setLength(l||h?15:0))),vu(e,(l,h)=>{c(e.inArms(l,h).multiplyScalar(100).clampLength(0,i.get("constrained")[0]?15:40))})}function fu(i){let t=i.dataset.key,e=i.lastChild,n=e.data.toLowerCase().indexOf(t),s=document.createElement("u"),r=document.createElement("span");i.setAttribute("aria-keyshortcuts",t),s.textContent=n<0?t.toUpperCase():e.data[n],r.append(...n<0?[e.data," ",s]:[e.data.slice(0,n),s,e.data.slice(n+1)]),e.replaceWith(r)}function pu(i,t){let e=n=>{i.classList.contains("held")!==n&&(i.classList.toggle("held",n),t(n))};for(let n of["pointerdown","hold"])i.addEventListener(n,()=>e(!0));for(let n of["pointerup","pointerleave","pointercancel","blur","keyup","release"])i.addEventListener(n,()=>e(!1));i.addEventListener("keydown",({key:n})=>{(n===" "||n==="Enter")&&e(!0)})}function mu(i,t){i.addEventListener("pointerdown",e=>{let n=document.createElement("div");n.className="dragged",n.append(i.querySelector("i").cloneNode());let s=({clientX:o,clientY:c})=>{!n.isConnected&&Math.hypot(o-e.clientX,c-e.clientY)<6||(document.body.append(n),n.style.left=`${o}px`,n.style.top=`${c}px`)},r=({type:o,clientX:c,clientY:l})=>{for(let[h,f]of a)removeEventListener(h,f);n.isConnected&&(n.remove(),o!=="pointercancel"&&(document.elementFromPoint(c,l)?.closest("#stage")?i.click():t("Let it go over one of the hands.")))},a=[["pointermove",s],["pointerup",r],["pointercancel",r]];for(let[o,c]of a)addEventListener(o,c)})}function gu(i){let t=new Map(i.map(e=>[e.dataset.key,e]));addEventListener("keydown",({altKey:e,ctrlKey:n,key:s,metaKey:r,repeat:a,target:o})=>{if(a||e||n||r||o.closest("input, select, pre"))return;let c=t.get(s.toLowerCase());c?.dataset.hold?c.dispatchEvent(new Event("hold")):c?.click()}),addEventListener("keyup",({key:e})=>t.get(e.toLowerCase())?.dispatchEvent(new Event("release")))}function xu(i){let t=document.getElementById("scene"),e=new Set,n=()=>i(...[...e].reduce(([s,r],a)=>[s+so[a][0],r+so[a][1]],[0,0]));t.addEventListener("keydown",s=>{s.key in so&&(s.preventDefault(),!s.repeat&&(e.add(s.key),n()))}),t.addEventListener("keyup",({key:s})=>e.delete(s)&&n()),t.addEventListener("blur",()=>{e.size!==0&&(e.clear(),n())})}function vu(i,t){let e=document.getElementById("scene");e.addEventListener("pointerdown",n=>{let{left:s,top:r}=e.getBoundingClientRect(),a=["without","with"].some(l=>{let{x:h,y:f}=i.handAt(l);return Math.hypot(n.clientX-s-h,n.clientY-r-f)<90}),o=n,c=l=>{a?t(l.clientX-n.clientX,l.clientY-n.clientY):i.turn(l.clientX-o.clientX,l.clientY-o.clientY),o=l};e.setPointerCapture(n.pointerId),e.addEventListener("pointermove",c),e.addEventListener("lostpointercapture",()=>{e.removeEventListener("pointermove",c),a&&t(0,0)},{once:!0})})}var Vs=class{constructor(){this.clear()}clear(){this.rows=[]}add(t){this.rows.push({t:t("ticks")[0]/1e3,mean:t("with.mean")[0],deviation:t("with.deviation")[0],truth:t("with.payload")[0]}),this.rows.length>12/.02&&this.rows.shift()}},yu=(()=>{let i=document.createElement("canvas");i.width=i.height=6;let t=i.getContext("2d");t.strokeStyle="#1565c0";for(let e of[-6,0,6])t.moveTo(e,6),t.lineTo(e+6,0);return t.stroke(),t.createPattern(i,"repeat")})();function ao(i,t,e,n){let s=devicePixelRatio,r=i.clientWidth,a=i.clientHeight;i.width!==Math.round(r*s)&&(i.width=Math.round(r*s),i.height=Math.round(a*s));let o=i.getContext("2d");o.setTransform(s,0,0,s,0,0),o.clearRect(0,0,r,a);let c=t.reduce((u,S)=>Math.max(u,S.mean+S.deviation,S.truth??0),.5),l=c>10?5:c>4?2:c>2?1:.5,h=l*Math.ceil(1.05*c/l),f=u=>30+(r-34)*(u-e)/(n-e),d=u=>a-16-(a-22)*Math.max(u,0)/h;o.font="11px system-ui, sans-serif",o.fillStyle="#5b6472",o.strokeStyle="#dde2e8";for(let u=0;u<=h+1e-9;u+=l)o.strokeRect(30,d(u),r-34,0),o.fillText(u.toFixed(l<1?1:0),4,d(u)+4);let m=Math.max(1,Math.round((n-e)/6));for(let u=m*Math.ceil(e/m);u<=n;u+=m)o.fillText(`${u} s`,Math.min(f(u)-8,r-26),a-3);let g=(u,S)=>{o.setLineDash(S),o.beginPath();for(let[A,w]of u)o.lineTo(f(A),d(w))},M=t.map(u=>[u.t,u.mean+2*u.deviation]),p=t.map(u=>[u.t,u.mean-2*u.deviation]);o.save(),o.beginPath(),o.rect(30,0,r-34,a-16),o.clip(),g([...M,...p.reverse()],[]),o.fillStyle=yu,o.fill(),o.strokeStyle="#1f2937",g(t.filter(u=>u.truth!==void 0).map(u=>[u.t,u.truth]),[5,4]),o.stroke(),o.lineWidth=2,o.strokeStyle="#1565c0",g(t.map(u=>[u.t,u.mean]),[]),o.stroke(),o.restore(),o.setLineDash([])}function ql(i,{rows:t}){let e=Math.max(12,t[t.length-1].t);ao(i,t,e-12,e)}var oe=i=>document.getElementById(i),kn=[],Yl,Mu=0;function Su(){return Yl??=new Promise((i,t)=>{let e=document.createElement("script");e.src="logs.js",e.onload=()=>i(new Worker(URL.createObjectURL(new Blob([globalThis.rmeLogWorker],{type:"text/javascript"})))),e.onerror=()=>t(new Error("logs.js is missing beside the page")),document.head.append(e)}),Yl}async function Jl(i,t){let e=await Su(),n=++Mu;return new Promise(s=>{let r=({data:a})=>{a.id===n&&(e.removeEventListener("message",r),s(a))};e.addEventListener("message",r),e.postMessage({id:n,files:kn,program:i,options:t})})}async function bu(i){let t=i.name.endsWith(".gz"),e=t?i.stream().pipeThrough(new DecompressionStream("gzip")):i.stream();return{name:t?i.name.slice(0,-3):i.name,bytes:new Uint8Array(await new Response(e).arrayBuffer())}}var si=({name:i})=>/\.(urdf|xml)$/i.test(i),Ws=()=>kn.filter(i=>!si(i)).map(({name:i})=>i);function wu(i){let t=new DOMParser().parseFromString(new TextDecoder().decode(i.bytes),"text/xml"),e=[...t.querySelectorAll("robot > link")].map(h=>h.getAttribute("name")),n=h=>new Set([...t.querySelectorAll(`robot > joint > ${h}`)].map(f=>f.getAttribute("link"))),s=n("parent"),r=n("child"),a=[...t.querySelectorAll("robot > joint")].find(h=>/revolute|continuous/.test(h.getAttribute("type"))),o=e.filter(h=>!s.has(h)),c=a?.querySelector("parent")?.getAttribute("link")??e.find(h=>!r.has(h)),l=o.find(h=>/^(tool0|.*flange|.*link8|.*ee|.*tip)$/i.test(h))??o.at(-1);for(let[h,f]of[["base",c],["tip",l]])oe(h).replaceChildren(...e.map(d=>new Option(d,d,!1,d===f)))}async function Zl(i){for(let e of i){let n=await bu(e);kn=kn.filter(s=>s.name!==n.name&&!(si(s)&&si(n))),kn.push(n)}let t=kn.find(si);oe("chosen").textContent=kn.map(({name:e})=>e).join(", "),oe("arm").hidden=!t,t&&[...i].some(si)&&wu(t),oe("replay").disabled=oe("check").disabled=Ws().length===0,Ws().length>0&&[...i].some(e=>!si(e))&&await Ql()}function Kl(){let i=kn.find(si),t=oe("options").value.trim();return[...i?["--urdf",i.name,"--base",oe("base").value,"--tip",oe("tip").value]:[],...t?t.split(/\s+/):[]]}function oo(i,t){oe("verdict").textContent=i,oe("output").hidden=!1,oe("output").textContent=t.join(`
`)}async function jl(i,t){oe("verdict").textContent=i;for(let e of["replay","check"])oe(e).disabled=!0;await t();for(let e of["replay","check"])oe(e).disabled=!1}var Ql=()=>jl("replaying ...",async()=>{let i=Ws().at(-1),{code:t,output:e}=await Jl("replay_log",[i,"--json",...Kl()]);if(t!==0){oe("replayed").hidden=!0,oo(`${i} could not be replayed`,e);return}let n=e.filter(o=>o.startsWith("{")).map(o=>JSON.parse(o)),s=n.filter(({type:o})=>o==="estimate"),r=n.filter(({type:o,final:c})=>c||o==="rejected"),a=n.find(({type:o})=>o==="summary");oe("replayed").hidden=!1,oe("replayed").rows=s.map(({t:o,mass:c,std:l,truth:h})=>({t:o,mean:c,deviation:l[0],truth:h?.[0]})),$l(),oo(`${i}: ${a.samples} samples, ${a.estimates} changes of the payload, ${a.rejected} pushes`,[...n.filter(({type:o})=>o==="note").map(({text:o})=>o),...r.map(({t:o,kind:c,mass:l,std:h})=>`${o.toFixed(3)} s  ${c}`+(l===void 0?"":`  ${l.toFixed(3)} +- ${h[0].toFixed(3)} kg`))])});function $l(){let{rows:i}=oe("replayed");i?.length>1&&ao(oe("replayed"),i,i[0].t,i.at(-1).t)}var Tu=()=>jl("checking ...",async()=>{let{code:i,output:t}=await Jl("check_arm",[...Ws(),...Kl()]);oo(["The arm fits: sign, units and frames of its torque can be right.","Sign, units or frames of the torque do not fit the arm.","check_arm does not take these options.","check_arm cannot use these files."][i],t)});function tc(){oe("files").addEventListener("change",({target:t})=>Zl(t.files)),oe("replay").addEventListener("click",Ql),oe("check").addEventListener("click",Tu),addEventListener("resize",$l);let i=t=>e=>{e.dataTransfer?.types.includes("Files")&&(e.preventDefault(),oe("own").classList.toggle("over",t),e.type==="drop"&&Zl(e.dataTransfer.files))};for(let[t,e]of[["dragover",!0],["dragleave",!1],["drop",!1]])addEventListener(t,i(e))}var Cc=0,zo=1,_c=2;var As=1,Ic=2,Gi=3,Qn=0,De=1,xn=2,ui=0,Hi=1,ko=2,Go=3,Ho=4,Pc=5;var di=100,Lc=101,Nc=102,Dc=103,Uc=104,Fc=200,Oc=201,Bc=202,zc=203,Vo=204,Wo=205,kc=206,Gc=207,Hc=208,Vc=209,Wc=210,Xc=211,qc=212,Yc=213,Zc=214,yr=0,Mr=1,Sr=2,Pi=3,br=4,wr=5,Tr=6,Er=7,Qr=0,Jc=1,Kc=2,vn=0,Xo=1,qo=2,Yo=3,Zo=4,Jo=5,Ko=6,jo=7;var Qo=300,fi=301,Vi=302,$r=303,ta=304,Ar=1e3,fn=1001,Rr=1002,Se=1003,jc=1004;var Rs=1005;var Ne=1006,ea=1007;var Dn=1008;var Be=1009,$o=1010,tl=1011,Wi=1012,na=1013,an=1014,on=1015,ln=1016,ia=1017,sa=1018,pi=1020,el=35902,nl=35899,il=1021,sl=1022,cn=1023,_n=1026,Un=1027,rl=1028,ra=1029,$n=1030,aa=1031;var oa=1033,Cs=33776,_s=33777,Is=33778,Ps=33779,la=35840,ca=35841,ha=35842,ua=35843,da=36196,fa=37492,pa=37496,ma=37488,ga=37489,Ls=37490,xa=37491,va=37808,ya=37809,Ma=37810,Sa=37811,ba=37812,wa=37813,Ta=37814,Ea=37815,Aa=37816,Ra=37817,Ca=37818,_a=37819,Ia=37820,Pa=37821,La=36492,Na=36494,Da=36495,Ua=36283,Fa=36284,Ns=36285,Oa=36286;var ns=2300,Cr=2301,gr=2302,Lo=2303,No=2400,Do=2401,Uo=2402;var Qc=3200;var Ba=0,$c=1,Fn="",Ge="srgb",is="srgb-linear",ss="linear",Yt="srgb";var xr=7680;var th=519,eh=512,nh=513,ih=514,al=515,sh=516,rh=517,ol=518,ll=519,ah=35044;var cl="300 es",je=2e3,Li=2001;function Eu(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Au(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function rs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function oh(){let i=rs("canvas");return i.style.display="block",i}var ec={},Ni=null;function hl(...i){let t="THREE."+i.shift();Ni?Ni("log",t,...i):console.log(t,...i)}function lh(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Rt(...i){i=lh(i);let t="THREE."+i.shift();if(Ni)Ni("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function _t(...i){i=lh(i);let t="THREE."+i.shift();if(Ni)Ni("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function es(...i){let t=i.join(" ");t in ec||(ec[t]=!0,Rt(...i))}function ch(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var hh={[yr]:yr,[Sr]:Tr,[br]:br,[Pi]:wr,[Mr]:Mr,[Tr]:Sr,[Er]:Er,[wr]:Pi},mn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},Re=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var vr=Math.PI/180,_r=180/Math.PI;function Ds(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Re[i&255]+Re[i>>8&255]+Re[i>>16&255]+Re[i>>24&255]+"-"+Re[t&255]+Re[t>>8&255]+"-"+Re[t>>16&15|64]+Re[t>>24&255]+"-"+Re[e&63|128]+Re[e>>8&255]+"-"+Re[e>>16&255]+Re[e>>24&255]+Re[n&255]+Re[n>>8&255]+Re[n>>16&255]+Re[n>>24&255]).toLowerCase()}function Wt(i,t,e){return Math.max(t,Math.min(e,i))}function Ru(i,t){return(i%t+t)%t}function lo(i,t,e){return(1-e)*i+e*t}function uh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ul(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Cu(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function _u(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Vt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qe=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let c=n[s+0],l=n[s+1],h=n[s+2],f=n[s+3],d=r[a+0],m=r[a+1],g=r[a+2],M=r[a+3];if(f!==M||c!==d||l!==m||h!==g){let p=c*d+l*m+h*g+f*M;p<0&&(d=-d,m=-m,g=-g,M=-M,p=-p);let u=1-o;if(p<.9995){let S=Math.acos(p),A=Math.sin(S);u=Math.sin(u*S)/A,o=Math.sin(o*S)/A,c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+M*o}else{c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+M*o;let S=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=S,l*=S,h*=S,f*=S}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,s,r,a){let o=n[s],c=n[s+1],l=n[s+2],h=n[s+3],f=r[a],d=r[a+1],m=r[a+2],g=r[a+3];return t[e]=o*g+h*f+c*m-l*d,t[e+1]=c*g+h*d+l*f-o*m,t[e+2]=l*g+h*m+o*d-c*f,t[e+3]=h*g-o*f-c*d-l*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,c=Math.sin,l=o(n/2),h=o(s/2),f=o(r/2),d=c(n/2),m=c(s/2),g=c(r/2);switch(a){case"XYZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"YXZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"ZXY":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"ZYX":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"YZX":this._x=d*h*f+l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f-d*m*g;break;case"XZY":this._x=d*h*f-l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f+d*m*g;break;default:Rt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],c=e[9],l=e[2],h=e[6],f=e[10],d=n+o+f;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-c)*m,this._y=(r-l)*m,this._z=(a-s)*m}else if(n>o&&n>f){let m=2*Math.sqrt(1+n-o-f);this._w=(h-c)/m,this._x=.25*m,this._y=(s+a)/m,this._z=(r+l)/m}else if(o>f){let m=2*Math.sqrt(1+o-n-f);this._w=(r-l)/m,this._x=(s+a)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+f-n-o);this._w=(a-s)/m,this._x=(r+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+a*o+s*l-r*c,this._y=s*h+a*c+r*o-n*l,this._z=r*h+a*l+n*c-s*o,this._w=a*h-n*o-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let c=1-e;if(o<.9995){let l=Math.acos(o),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(nc.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(nc.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,c=t.w,l=2*(a*s-o*n),h=2*(o*e-r*s),f=2*(r*n-a*e);return this.x=e+c*l+a*f-o*h,this.y=n+c*h+o*l-r*f,this.z=s+c*f+r*h-a*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,c=e.z;return this.x=s*c-r*o,this.y=r*a-n*c,this.z=n*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return co.copy(this).projectOnVector(t),this.sub(co)}reflect(t){return this.sub(co.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},co=new U,nc=new Qe,It=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l)}set(t,e,n,s,r,a,o,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=a,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],c=n[6],l=n[1],h=n[4],f=n[7],d=n[2],m=n[5],g=n[8],M=s[0],p=s[3],u=s[6],S=s[1],A=s[4],w=s[7],R=s[2],E=s[5],x=s[8];return r[0]=a*M+o*S+c*R,r[3]=a*p+o*A+c*E,r[6]=a*u+o*w+c*x,r[1]=l*M+h*S+f*R,r[4]=l*p+h*A+f*E,r[7]=l*u+h*w+f*x,r[2]=d*M+m*S+g*R,r[5]=d*p+m*A+g*E,r[8]=d*u+m*w+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8];return e*a*h-e*o*l-n*r*h+n*o*c+s*r*l-s*a*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=h*a-o*l,d=o*c-h*r,m=l*r-a*c,g=e*f+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return t[0]=f*M,t[1]=(s*l-h*n)*M,t[2]=(o*n-s*a)*M,t[3]=d*M,t[4]=(h*e-s*c)*M,t[5]=(s*r-o*e)*M,t[6]=m*M,t[7]=(n*c-l*e)*M,t[8]=(a*e-n*r)*M,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*a+l*o)+a+t,-s*l,s*c,-s*(-l*a+c*o)+o+e,0,0,1),this}scale(t,e){return es("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ho.makeScale(t,e)),this}rotate(t){return es("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ho.makeRotation(-t)),this}translate(t,e){return es("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ho.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ho=new It,ic=new It().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sc=new It().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Iu(){let i={enabled:!0,workingColorSpace:is,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Yt&&(s.r=Cn(s.r),s.g=Cn(s.g),s.b=Cn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Yt&&(s.r=Ii(s.r),s.g=Ii(s.g),s.b=Ii(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fn?ss:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[is]:{primaries:t,whitePoint:n,transfer:ss,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ge},outputColorSpaceConfig:{drawingBufferColorSpace:Ge}},[Ge]:{primaries:t,whitePoint:n,transfer:Yt,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ge}}}),i}var Ht=Iu();function Cn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Ii(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xi,Ir=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{xi===void 0&&(xi=rs("canvas")),xi.width=t.width,xi.height=t.height;let s=xi.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=xi}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=rs("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Cn(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Cn(e[n]/255)*255):e[n]=Cn(e[n]);return{data:e,width:t.width,height:t.height}}else return Rt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Pu=0,Di=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Pu++}),this.uuid=Ds(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(uo(s[a].image)):r.push(uo(s[a]))}else r=uo(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function uo(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Ir.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Rt("Texture: Unable to serialize Texture."),{})}var Lu=0,fo=new U,Oe=class i extends mn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=fn,s=fn,r=Ne,a=Dn,o=cn,c=Be,l=i.DEFAULT_ANISOTROPY,h=Fn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Lu++}),this.uuid=Ds(),this.name="",this.source=new Di(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new Vt(0,0),this.repeat=new Vt(1,1),this.center=new Vt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new It,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fo).x}get height(){return this.source.getSize(fo).y}get depth(){return this.source.getSize(fo).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Rt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Rt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Qo)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ar:t.x=t.x-Math.floor(t.x);break;case fn:t.x=t.x<0?0:1;break;case Rr:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ar:t.y=t.y-Math.floor(t.y);break;case fn:t.y=t.y<0?0:1;break;case Rr:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Oe.DEFAULT_IMAGE=null;Oe.DEFAULT_MAPPING=Qo;Oe.DEFAULT_ANISOTROPY=1;var se=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],f=c[8],d=c[1],m=c[5],g=c[9],M=c[2],p=c[6],u=c[10];if(Math.abs(h-d)<.01&&Math.abs(f-M)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+M)<.1&&Math.abs(g+p)<.1&&Math.abs(l+m+u-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(l+1)/2,w=(m+1)/2,R=(u+1)/2,E=(h+d)/4,x=(f+M)/4,b=(g+p)/4;return A>w&&A>R?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):w>R?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=E/s,r=b/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=x/r,s=b/r),this.set(n,s,r,e),this}let S=Math.sqrt((p-g)*(p-g)+(f-M)*(f-M)+(d-h)*(d-h));return Math.abs(S)<.001&&(S=1),this.x=(p-g)/S,this.y=(f-M)/S,this.z=(d-h)/S,this.w=Math.acos((l+m+u-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Pr=class extends mn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ne,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new se(0,0,t,e),this.scissorTest=!1,this.viewport=new se(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Oe({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ne,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Di(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ve=class extends Pr{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},as=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Se,this.minFilter=Se,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Lr=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Se,this.minFilter=Se,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,c,l,h,f,d,m,g,M,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,M,p)}set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,M,p){let u=this.elements;return u[0]=t,u[4]=e,u[8]=n,u[12]=s,u[1]=r,u[5]=a,u[9]=o,u[13]=c,u[2]=l,u[6]=h,u[10]=f,u[14]=d,u[3]=m,u[7]=g,u[11]=M,u[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/vi.setFromMatrixColumn(t,0).length(),r=1/vi.setFromMatrixColumn(t,1).length(),a=1/vi.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let d=a*h,m=a*f,g=o*h,M=o*f;e[0]=c*h,e[4]=-c*f,e[8]=l,e[1]=m+g*l,e[5]=d-M*l,e[9]=-o*c,e[2]=M-d*l,e[6]=g+m*l,e[10]=a*c}else if(t.order==="YXZ"){let d=c*h,m=c*f,g=l*h,M=l*f;e[0]=d+M*o,e[4]=g*o-m,e[8]=a*l,e[1]=a*f,e[5]=a*h,e[9]=-o,e[2]=m*o-g,e[6]=M+d*o,e[10]=a*c}else if(t.order==="ZXY"){let d=c*h,m=c*f,g=l*h,M=l*f;e[0]=d-M*o,e[4]=-a*f,e[8]=g+m*o,e[1]=m+g*o,e[5]=a*h,e[9]=M-d*o,e[2]=-a*l,e[6]=o,e[10]=a*c}else if(t.order==="ZYX"){let d=a*h,m=a*f,g=o*h,M=o*f;e[0]=c*h,e[4]=g*l-m,e[8]=d*l+M,e[1]=c*f,e[5]=M*l+d,e[9]=m*l-g,e[2]=-l,e[6]=o*c,e[10]=a*c}else if(t.order==="YZX"){let d=a*c,m=a*l,g=o*c,M=o*l;e[0]=c*h,e[4]=M-d*f,e[8]=g*f+m,e[1]=f,e[5]=a*h,e[9]=-o*h,e[2]=-l*h,e[6]=m*f+g,e[10]=d-M*f}else if(t.order==="XZY"){let d=a*c,m=a*l,g=o*c,M=o*l;e[0]=c*h,e[4]=-f,e[8]=l*h,e[1]=d*f+M,e[5]=a*h,e[9]=m*f-g,e[2]=g*f-m,e[6]=o*h,e[10]=M*f+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Nu,t,Du)}lookAt(t,e,n){let s=this.elements;return ze.subVectors(t,e),ze.lengthSq()===0&&(ze.z=1),ze.normalize(),Gn.crossVectors(n,ze),Gn.lengthSq()===0&&(Math.abs(n.z)===1?ze.x+=1e-4:ze.z+=1e-4,ze.normalize(),Gn.crossVectors(n,ze)),Gn.normalize(),Xs.crossVectors(ze,Gn),s[0]=Gn.x,s[4]=Xs.x,s[8]=ze.x,s[1]=Gn.y,s[5]=Xs.y,s[9]=ze.y,s[2]=Gn.z,s[6]=Xs.z,s[10]=ze.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],c=n[8],l=n[12],h=n[1],f=n[5],d=n[9],m=n[13],g=n[2],M=n[6],p=n[10],u=n[14],S=n[3],A=n[7],w=n[11],R=n[15],E=s[0],x=s[4],b=s[8],D=s[12],P=s[1],N=s[5],B=s[9],V=s[13],_=s[2],H=s[6],q=s[10],G=s[14],et=s[3],X=s[7],Q=s[11],$=s[15];return r[0]=a*E+o*P+c*_+l*et,r[4]=a*x+o*N+c*H+l*X,r[8]=a*b+o*B+c*q+l*Q,r[12]=a*D+o*V+c*G+l*$,r[1]=h*E+f*P+d*_+m*et,r[5]=h*x+f*N+d*H+m*X,r[9]=h*b+f*B+d*q+m*Q,r[13]=h*D+f*V+d*G+m*$,r[2]=g*E+M*P+p*_+u*et,r[6]=g*x+M*N+p*H+u*X,r[10]=g*b+M*B+p*q+u*Q,r[14]=g*D+M*V+p*G+u*$,r[3]=S*E+A*P+w*_+R*et,r[7]=S*x+A*N+w*H+R*X,r[11]=S*b+A*B+w*q+R*Q,r[15]=S*D+A*V+w*G+R*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],c=t[9],l=t[13],h=t[2],f=t[6],d=t[10],m=t[14],g=t[3],M=t[7],p=t[11],u=t[15],S=c*m-l*d,A=o*m-l*f,w=o*d-c*f,R=a*m-l*h,E=a*d-c*h,x=a*f-o*h;return e*(M*S-p*A+u*w)-n*(g*S-p*R+u*E)+s*(g*A-M*R+u*x)-r*(g*w-M*E+p*x)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],c=t[2],l=t[6],h=t[10];return e*(a*h-o*l)-n*(r*h-o*c)+s*(r*l-a*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=t[9],d=t[10],m=t[11],g=t[12],M=t[13],p=t[14],u=t[15],S=e*o-n*a,A=e*c-s*a,w=e*l-r*a,R=n*c-s*o,E=n*l-r*o,x=s*l-r*c,b=h*M-f*g,D=h*p-d*g,P=h*u-m*g,N=f*p-d*M,B=f*u-m*M,V=d*u-m*p,_=S*V-A*B+w*N+R*P-E*D+x*b;if(_===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/_;return t[0]=(o*V-c*B+l*N)*H,t[1]=(s*B-n*V-r*N)*H,t[2]=(M*x-p*E+u*R)*H,t[3]=(d*E-f*x-m*R)*H,t[4]=(c*P-a*V-l*D)*H,t[5]=(e*V-s*P+r*D)*H,t[6]=(p*w-g*x-u*A)*H,t[7]=(h*x-d*w+m*A)*H,t[8]=(a*B-o*P+l*b)*H,t[9]=(n*P-e*B-r*b)*H,t[10]=(g*E-M*w+u*S)*H,t[11]=(f*w-h*E-m*S)*H,t[12]=(o*D-a*N-c*b)*H,t[13]=(e*N-n*D+s*b)*H,t[14]=(M*A-g*R-p*S)*H,t[15]=(h*R-f*A+d*S)*H,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,c=t.z,l=r*a,h=r*o;return this.set(l*a+n,l*o-s*c,l*c+s*o,0,l*o+s*c,h*o+n,h*c-s*a,0,l*c-s*o,h*c+s*a,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,a=e._y,o=e._z,c=e._w,l=r+r,h=a+a,f=o+o,d=r*l,m=r*h,g=r*f,M=a*h,p=a*f,u=o*f,S=c*l,A=c*h,w=c*f,R=n.x,E=n.y,x=n.z;return s[0]=(1-(M+u))*R,s[1]=(m+w)*R,s[2]=(g-A)*R,s[3]=0,s[4]=(m-w)*E,s[5]=(1-(d+u))*E,s[6]=(p+S)*E,s[7]=0,s[8]=(g+A)*x,s[9]=(p-S)*x,s[10]=(1-(d+M))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=vi.set(s[0],s[1],s[2]).length(),o=vi.set(s[4],s[5],s[6]).length(),c=vi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),en.copy(this);let l=1/a,h=1/o,f=1/c;return en.elements[0]*=l,en.elements[1]*=l,en.elements[2]*=l,en.elements[4]*=h,en.elements[5]*=h,en.elements[6]*=h,en.elements[8]*=f,en.elements[9]*=f,en.elements[10]*=f,e.setFromRotationMatrix(en),n.x=a,n.y=o,n.z=c,this}makePerspective(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2*r/(e-t),f=2*r/(n-s),d=(e+t)/(e-t),m=(n+s)/(n-s),g,M;if(c)g=r/(a-r),M=a*r/(a-r);else if(o===je)g=-(a+r)/(a-r),M=-2*a*r/(a-r);else if(o===Li)g=-a/(a-r),M=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2/(e-t),f=2/(n-s),d=-(e+t)/(e-t),m=-(n+s)/(n-s),g,M;if(c)g=1/(a-r),M=a/(a-r);else if(o===je)g=-2/(a-r),M=-(a+r)/(a-r);else if(o===Li)g=-1/(a-r),M=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},vi=new U,en=new Qt,Nu=new U(0,0,0),Du=new U(1,1,1),Gn=new U,Xs=new U,ze=new U,rc=new Qt,ac=new Qe,In=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],c=s[1],l=s[5],h=s[9],f=s[2],d=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-a,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Wt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-a,l));break;case"YZX":this._z=Math.asin(Wt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,m));break;case"XZY":this._z=Math.asin(-Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Rt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rc.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rc,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ac.setFromEuler(this),this.setFromQuaternion(ac,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};In.DEFAULT_ORDER="XYZ";var os=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Uu=0,oc=new U,yi=new Qe,bn=new Qt,qs=new U,Ki=new U,Fu=new U,Ou=new Qe,lc=new U(1,0,0),cc=new U(0,1,0),hc=new U(0,0,1),uc={type:"added"},Bu={type:"removed"},Mi={type:"childadded",child:null},po={type:"childremoved",child:null},Te=class i extends mn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Uu++}),this.uuid=Ds(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new U,e=new In,n=new Qe,s=new U(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new It}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new os,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.multiply(yi),this}rotateOnWorldAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.premultiply(yi),this}rotateX(t){return this.rotateOnAxis(lc,t)}rotateY(t){return this.rotateOnAxis(cc,t)}rotateZ(t){return this.rotateOnAxis(hc,t)}translateOnAxis(t,e){return oc.copy(t).applyQuaternion(this.quaternion),this.position.add(oc.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lc,t)}translateY(t){return this.translateOnAxis(cc,t)}translateZ(t){return this.translateOnAxis(hc,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(bn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?qs.copy(t):qs.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ki.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bn.lookAt(Ki,qs,this.up):bn.lookAt(qs,Ki,this.up),this.quaternion.setFromRotationMatrix(bn),s&&(bn.extractRotation(s.matrixWorld),yi.setFromRotationMatrix(bn),this.quaternion.premultiply(yi.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(_t("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(uc),Mi.child=t,this.dispatchEvent(Mi),Mi.child=null):_t("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Bu),po.child=t,this.dispatchEvent(po),po.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),bn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),bn.multiply(t.parent.matrixWorld)),t.applyMatrix4(bn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(uc),Mi.child=t,this.dispatchEvent(Mi),Mi.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,t,Fu),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,Ou,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let c=o.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];r(t.shapes,f)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(r(t.materials,this.material[c]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let c=this.animations[o];s.animations.push(r(t.animations,c))}}if(e){let o=a(t.geometries),c=a(t.materials),l=a(t.textures),h=a(t.images),f=a(t.shapes),d=a(t.skeletons),m=a(t.animations),g=a(t.nodes);o.length>0&&(n.geometries=o),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let c=[];for(let l in o){let h=o[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Te.DEFAULT_UP=new U(0,1,0);Te.DEFAULT_MATRIX_AUTO_UPDATE=!0;Te.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var He=class extends Te{constructor(){super(),this.isGroup=!0,this.type="Group"}},zu={type:"move"},Ui=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new He,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new He,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new He,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null,o=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){a=!0;for(let M of t.hand.values()){let p=e.getJointPose(M,n),u=this._getHandJoint(l,M);p!==null&&(u.matrix.fromArray(p.transform.matrix),u.matrix.decompose(u.position,u.quaternion,u.scale),u.matrixWorldNeedsUpdate=!0,u.jointRadius=p.radius),u.visible=p!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],d=h.position.distanceTo(f.position),m=.02,g=.005;l.inputState.pinching&&d>m+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=m-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(zu)))}return o!==null&&(o.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new He;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},dh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Hn={h:0,s:0,l:0},Ys={h:0,s:0,l:0};function mo(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Ut=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ge){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Ht.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Ht.workingColorSpace){return this.r=t,this.g=e,this.b=n,Ht.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Ht.workingColorSpace){if(t=Ru(t,1),e=Wt(e,0,1),n=Wt(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=mo(a,r,t+1/3),this.g=mo(a,r,t),this.b=mo(a,r,t-1/3)}return Ht.colorSpaceToWorking(this,s),this}setStyle(t,e=Ge){function n(r){r!==void 0&&parseFloat(r)<1&&Rt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Rt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Rt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ge){let n=dh[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Rt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Cn(t.r),this.g=Cn(t.g),this.b=Cn(t.b),this}copyLinearToSRGB(t){return this.r=Ii(t.r),this.g=Ii(t.g),this.b=Ii(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ge){return Ht.workingToColorSpace(Ce.copy(this),t),Math.round(Wt(Ce.r*255,0,255))*65536+Math.round(Wt(Ce.g*255,0,255))*256+Math.round(Wt(Ce.b*255,0,255))}getHexString(t=Ge){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Ht.workingColorSpace){Ht.workingToColorSpace(Ce.copy(this),e);let n=Ce.r,s=Ce.g,r=Ce.b,a=Math.max(n,s,r),o=Math.min(n,s,r),c,l,h=(o+a)/2;if(o===a)c=0,l=0;else{let f=a-o;switch(l=h<=.5?f/(a+o):f/(2-a-o),a){case n:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-n)/f+2;break;case r:c=(n-s)/f+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=Ht.workingColorSpace){return Ht.workingToColorSpace(Ce.copy(this),e),t.r=Ce.r,t.g=Ce.g,t.b=Ce.b,t}getStyle(t=Ge){Ht.workingToColorSpace(Ce.copy(this),t);let e=Ce.r,n=Ce.g,s=Ce.b;return t!==Ge?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Hn),this.setHSL(Hn.h+t,Hn.s+e,Hn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Hn),t.getHSL(Ys);let n=lo(Hn.h,Ys.h,e),s=lo(Hn.s,Ys.s,e),r=lo(Hn.l,Ys.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ce=new Ut;Ut.NAMES=dh;var ls=class extends Te{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new In,this.environmentIntensity=1,this.environmentRotation=new In,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},nn=new U,wn=new U,go=new U,Tn=new U,Si=new U,bi=new U,dc=new U,xo=new U,vo=new U,yo=new U,Mo=new se,So=new se,bo=new se,Rn=class i{constructor(t=new U,e=new U,n=new U){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),nn.subVectors(t,e),s.cross(nn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){nn.subVectors(s,e),wn.subVectors(n,e),go.subVectors(t,e);let a=nn.dot(nn),o=nn.dot(wn),c=nn.dot(go),l=wn.dot(wn),h=wn.dot(go),f=a*l-o*o;if(f===0)return r.set(0,0,0),null;let d=1/f,m=(l*c-o*h)*d,g=(a*h-o*c)*d;return r.set(1-m-g,g,m)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Tn)===null?!1:Tn.x>=0&&Tn.y>=0&&Tn.x+Tn.y<=1}static getInterpolation(t,e,n,s,r,a,o,c){return this.getBarycoord(t,e,n,s,Tn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Tn.x),c.addScaledVector(a,Tn.y),c.addScaledVector(o,Tn.z),c)}static getInterpolatedAttribute(t,e,n,s,r,a){return Mo.setScalar(0),So.setScalar(0),bo.setScalar(0),Mo.fromBufferAttribute(t,e),So.fromBufferAttribute(t,n),bo.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(Mo,r.x),a.addScaledVector(So,r.y),a.addScaledVector(bo,r.z),a}static isFrontFacing(t,e,n,s){return nn.subVectors(n,e),wn.subVectors(t,e),nn.cross(wn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return nn.subVectors(this.c,this.b),wn.subVectors(this.a,this.b),nn.cross(wn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,a,o;Si.subVectors(s,n),bi.subVectors(r,n),xo.subVectors(t,n);let c=Si.dot(xo),l=bi.dot(xo);if(c<=0&&l<=0)return e.copy(n);vo.subVectors(t,s);let h=Si.dot(vo),f=bi.dot(vo);if(h>=0&&f<=h)return e.copy(s);let d=c*f-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return a=c/(c-h),e.copy(n).addScaledVector(Si,a);yo.subVectors(t,r);let m=Si.dot(yo),g=bi.dot(yo);if(g>=0&&m<=g)return e.copy(r);let M=m*l-c*g;if(M<=0&&l>=0&&g<=0)return o=l/(l-g),e.copy(n).addScaledVector(bi,o);let p=h*g-m*f;if(p<=0&&f-h>=0&&m-g>=0)return dc.subVectors(r,s),o=(f-h)/(f-h+(m-g)),e.copy(s).addScaledVector(dc,o);let u=1/(p+M+d);return a=M*u,o=d*u,e.copy(n).addScaledVector(Si,a).addScaledVector(bi,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qn=class{constructor(t=new U(1/0,1/0,1/0),e=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(sn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(sn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=sn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,sn):sn.fromBufferAttribute(r,a),sn.applyMatrix4(t.matrixWorld),this.expandByPoint(sn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Zs.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Zs.copy(n.boundingBox)),Zs.applyMatrix4(t.matrixWorld),this.union(Zs)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,sn),sn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ji),Js.subVectors(this.max,ji),wi.subVectors(t.a,ji),Ti.subVectors(t.b,ji),Ei.subVectors(t.c,ji),Vn.subVectors(Ti,wi),Wn.subVectors(Ei,Ti),ri.subVectors(wi,Ei);let e=[0,-Vn.z,Vn.y,0,-Wn.z,Wn.y,0,-ri.z,ri.y,Vn.z,0,-Vn.x,Wn.z,0,-Wn.x,ri.z,0,-ri.x,-Vn.y,Vn.x,0,-Wn.y,Wn.x,0,-ri.y,ri.x,0];return!wo(e,wi,Ti,Ei,Js)||(e=[1,0,0,0,1,0,0,0,1],!wo(e,wi,Ti,Ei,Js))?!1:(Ks.crossVectors(Vn,Wn),e=[Ks.x,Ks.y,Ks.z],wo(e,wi,Ti,Ei,Js))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,sn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(sn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(En[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),En[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),En[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),En[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),En[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),En[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),En[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),En[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(En),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},En=[new U,new U,new U,new U,new U,new U,new U,new U],sn=new U,Zs=new qn,wi=new U,Ti=new U,Ei=new U,Vn=new U,Wn=new U,ri=new U,ji=new U,Js=new U,Ks=new U,ai=new U;function wo(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){ai.fromArray(i,r);let o=s.x*Math.abs(ai.x)+s.y*Math.abs(ai.y)+s.z*Math.abs(ai.z),c=t.dot(ai),l=e.dot(ai),h=n.dot(ai);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>o)return!1}return!0}var he=new U,js=new Vt,ku=0,pn=class extends mn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ku++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=ah,this.updateRanges=[],this.gpuType=on,this.version=0,this._normalizationScale=t!==void 0?ul(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)js.fromBufferAttribute(this,e),js.applyMatrix3(t),this.setXY(e,js.x,js.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix3(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix4(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyNormalMatrix(t),this.setXYZ(e,he.x,he.y,he.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.transformDirection(t),this.setXYZ(e,he.x,he.y,he.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Cu(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):_u(t,this.array)}};var cs=class extends pn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var hs=class extends pn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var te=class extends pn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Gu=new qn,Qi=new U,To=new U,ci=class{constructor(t=new U,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Gu.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qi.subVectors(t,this.center);let e=Qi.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Qi,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(To.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qi.copy(t.center).add(To)),this.expandByPoint(Qi.copy(t.center).sub(To))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Hu=0,Ke=new Qt,Eo=new Te,Ai=new U,ke=new qn,$i=new qn,Me=new U,_e=class i extends mn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Hu++}),this.uuid=Ds(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Eu(t)?hs:cs)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new It().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ke.makeRotationFromQuaternion(t),this.applyMatrix4(Ke),this}rotateX(t){return Ke.makeRotationX(t),this.applyMatrix4(Ke),this}rotateY(t){return Ke.makeRotationY(t),this.applyMatrix4(Ke),this}rotateZ(t){return Ke.makeRotationZ(t),this.applyMatrix4(Ke),this}translate(t,e,n){return Ke.makeTranslation(t,e,n),this.applyMatrix4(Ke),this}scale(t,e,n){return Ke.makeScale(t,e,n),this.applyMatrix4(Ke),this}lookAt(t){return Eo.lookAt(t),Eo.updateMatrix(),this.applyMatrix4(Eo.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ai).negate(),this.translate(Ai.x,Ai.y,Ai.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new te(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Rt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){_t("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ke.setFromBufferAttribute(r),this.morphTargetsRelative?(Me.addVectors(this.boundingBox.min,ke.min),this.boundingBox.expandByPoint(Me),Me.addVectors(this.boundingBox.max,ke.max),this.boundingBox.expandByPoint(Me)):(this.boundingBox.expandByPoint(ke.min),this.boundingBox.expandByPoint(ke.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&_t('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ci);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){_t("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(t){let n=this.boundingSphere.center;if(ke.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];$i.setFromBufferAttribute(o),this.morphTargetsRelative?(Me.addVectors(ke.min,$i.min),ke.expandByPoint(Me),Me.addVectors(ke.max,$i.max),ke.expandByPoint(Me)):(ke.expandByPoint($i.min),ke.expandByPoint($i.max))}ke.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Me.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Me));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],c=this.morphTargetsRelative;for(let l=0,h=o.count;l<h;l++)Me.fromBufferAttribute(o,l),c&&(Ai.fromBufferAttribute(t,l),Me.add(Ai)),s=Math.max(s,n.distanceToSquared(Me))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&_t('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){_t("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],c=[],l=new Uint8Array(n.count);for(let D=0;D<n.count;D++)o[D]=new U,c[D]=new U;let h=new U,f=new U,d=new U,m=new Vt,g=new Vt,M=new Vt,p=new U,u=new U;function S(D,P,N){l[D]=l[P]=l[N]=1,h.fromBufferAttribute(n,D),f.fromBufferAttribute(n,P),d.fromBufferAttribute(n,N),m.fromBufferAttribute(r,D),g.fromBufferAttribute(r,P),M.fromBufferAttribute(r,N),f.sub(h),d.sub(h),g.sub(m),M.sub(m);let B=1/(g.x*M.y-M.x*g.y);isFinite(B)&&(p.copy(f).multiplyScalar(M.y).addScaledVector(d,-g.y).multiplyScalar(B),u.copy(d).multiplyScalar(g.x).addScaledVector(f,-M.x).multiplyScalar(B),o[D].add(p),o[P].add(p),o[N].add(p),c[D].add(u),c[P].add(u),c[N].add(u))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let D=0,P=A.length;D<P;++D){let N=A[D],B=N.start,V=N.count;for(let _=B,H=B+V;_<H;_+=3)S(t.getX(_+0),t.getX(_+1),t.getX(_+2))}let w=new U,R=new U,E=new U,x=new U;function b(D){E.fromBufferAttribute(s,D),x.copy(E);let P=o[D];w.copy(P),w.sub(E.multiplyScalar(E.dot(P))).normalize(),R.crossVectors(x,P);let B=R.dot(c[D])<0?-1:1;a.setXYZW(D,w.x,w.y,w.z,B)}for(let D=0,P=n.count;D<P;++D)l[D]&&b(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new pn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new U,r=new U,a=new U,o=new U,c=new U,l=new U,h=new U,f=new U;if(t)for(let d=0,m=t.count;d<m;d+=3){let g=t.getX(d+0),M=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,M),a.fromBufferAttribute(e,p),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),o.fromBufferAttribute(n,g),c.fromBufferAttribute(n,M),l.fromBufferAttribute(n,p),o.add(h),c.add(h),l.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(M,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,m=e.count;d<m;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Me.fromBufferAttribute(t,e),Me.normalize(),t.setXYZ(e,Me.x,Me.y,Me.z)}toNonIndexed(){function t(o,c){let l=o.array,h=o.itemSize,f=o.normalized,d=new l.constructor(c.length*h),m=0,g=0;for(let M=0,p=c.length;M<p;M++){o.isInterleavedBufferAttribute?m=c[M]*o.data.stride+o.offset:m=c[M]*h;for(let u=0;u<h;u++)d[g++]=l[m++]}return new pn(d,h,f)}if(this.index===null)return Rt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let o in s){let c=s[o],l=t(c,n);e.setAttribute(o,l)}let r=this.morphAttributes;for(let o in r){let c=[],l=r[o];for(let h=0,f=l.length;h<f;h++){let d=l[h],m=t(d,n);c.push(m)}e.morphAttributes[o]=c}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,c=a.length;o<c;o++){let l=a[o];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,d=l.length;f<d;f++){let m=l[f];h.push(m.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],f=r[l];for(let d=0,m=f.length;d<m;d++)h.push(f[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let l=0,h=a.length;l<h;l++){let f=a[l];this.addGroup(f.start,f.count,f.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ao=new U,Vu=new U,Wu=new It,rn=class{constructor(t=new U(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Ao.subVectors(n,e).cross(Vu.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Ao),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Wu.getNormalMatrix(t),s=this.coplanarPoint(Ao).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Xu=0,Pn=class extends mn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Xu++}),this.uuid=Ds(),this.name="",this.type="Material",this.blending=Hi,this.side=Qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Vo,this.blendDst=Wo,this.blendEquation=di,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ut(0,0,0),this.blendAlpha=0,this.depthFunc=Pi,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=th,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xr,this.stencilZFail=xr,this.stencilZPass=xr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Rt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Rt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let c=r[o];delete c.metadata,a.push(c)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ut().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new rn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Vt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Vt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var An=new U,Ro=new U,Qs=new U,$s=new U,us=class{constructor(t=new U,e=new U(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,An)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=An.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(An.copy(this.origin).addScaledVector(this.direction,e),An.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ro.copy(t).add(e).multiplyScalar(.5),Qs.copy(e).sub(t).normalize(),$s.copy(this.origin).sub(Ro);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Qs),o=$s.dot(this.direction),c=-$s.dot(Qs),l=$s.lengthSq(),h=Math.abs(1-a*a),f,d,m,g;if(h>0)if(f=a*c-o,d=a*o-c,g=r*h,f>=0)if(d>=-g)if(d<=g){let M=1/h;f*=M,d*=M,m=f*(f+a*d+2*o)+d*(a*f+d+2*c)+l}else d=r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d=-r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d<=-g?(f=Math.max(0,-(-a*r+o)),d=f>0?-r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l):d<=g?(f=0,d=Math.min(Math.max(-r,-c),r),m=d*(d+2*c)+l):(f=Math.max(0,-(a*r+o)),d=f>0?r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l);else d=a>0?-r:r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Ro).addScaledVector(Qs,d),m}intersectSphere(t,e){if(t.radius<0)return null;An.subVectors(t.center,this.origin);let n=An.dot(this.direction),s=An.dot(An)-n*n,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,c=n+a;return c<0?null:o<0?this.at(c,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(t.min.z-d.z)*f,c=(t.max.z-d.z)*f):(o=(t.max.z-d.z)*f,c=(t.min.z-d.z)*f),n>c||o>s)||((o>n||n!==n)&&(n=o),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,An)!==null}intersectTriangle(t,e,n,s,r){let a=this.origin,o=this.direction,c=o.x,l=o.y,h=o.z,f=t.x-a.x,d=t.y-a.y,m=t.z-a.z,g=e.x-a.x,M=e.y-a.y,p=e.z-a.z,u=n.x-a.x,S=n.y-a.y,A=n.z-a.z,w=Math.abs(c),R=Math.abs(l),E=Math.abs(h),x,b,D,P,N,B,V,_,H,q,G,et;if(w>=R&&w>=E?(D=c,B=f,H=g,et=u,c>=0?(x=l,b=h,P=d,N=m,V=M,_=p,q=S,G=A):(x=h,b=l,P=m,N=d,V=p,_=M,q=A,G=S)):R>=E?(D=l,B=d,H=M,et=S,l>=0?(x=h,b=c,P=m,N=f,V=p,_=g,q=A,G=u):(x=c,b=h,P=f,N=m,V=g,_=p,q=u,G=A)):(D=h,B=m,H=p,et=A,h>=0?(x=c,b=l,P=f,N=d,V=g,_=M,q=u,G=S):(x=l,b=c,P=d,N=f,V=M,_=g,q=S,G=u)),D===0)return null;let X=x/D,Q=b/D,$=1/D,St=P-X*B,Lt=N-Q*B,J=V-X*H,pt=_-Q*H,vt=q-X*et,Et=G-Q*et,mt=vt*pt-Et*J,Dt=St*Et-Lt*vt,le=J*Lt-pt*St;if(s){if(mt<0||Dt<0||le<0)return null}else if((mt<0||Dt<0||le<0)&&(mt>0||Dt>0||le>0))return null;let Ct=mt+Dt+le;if(Ct===0)return null;let Zt=$*(mt*B+Dt*H+le*et);return(Ct>0?Zt<0:Zt>0)?null:this.at(Zt/Ct,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$e=class extends Pn{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new In,this.combine=Qr,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fc=new Qt,oi=new us,tr=new ci,pc=new U,er=new U,nr=new U,ir=new U,Co=new U,sr=new U,mc=new U,rr=new U,pe=class extends Te{constructor(t=new _e,e=new $e){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){sr.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=o[c],f=r[c];h!==0&&(Co.fromBufferAttribute(f,t),a?sr.addScaledVector(Co,h):sr.addScaledVector(Co.sub(e),h))}e.add(sr)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),tr.copy(n.boundingSphere),tr.applyMatrix4(r),oi.copy(t.ray).recast(t.near),!(tr.containsPoint(oi.origin)===!1&&(oi.intersectSphere(tr,pc)===null||oi.origin.distanceToSquared(pc)>(t.far-t.near)**2))&&(fc.copy(r).invert(),oi.copy(t.ray).applyMatrix4(fc),!(n.boundingBox!==null&&oi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,oi)))}_computeIntersections(t,e,n){let s,r=this.geometry,a=this.material,o=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,m=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,M=d.length;g<M;g++){let p=d[g],u=a[p.materialIndex],S=Math.max(p.start,m.start),A=Math.min(o.count,Math.min(p.start+p.count,m.start+m.count));for(let w=S,R=A;w<R;w+=3){let E=o.getX(w),x=o.getX(w+1),b=o.getX(w+2);s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),M=Math.min(o.count,m.start+m.count);for(let p=g,u=M;p<u;p+=3){let S=o.getX(p),A=o.getX(p+1),w=o.getX(p+2);s=ar(this,a,t,n,l,h,f,S,A,w),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(a))for(let g=0,M=d.length;g<M;g++){let p=d[g],u=a[p.materialIndex],S=Math.max(p.start,m.start),A=Math.min(c.count,Math.min(p.start+p.count,m.start+m.count));for(let w=S,R=A;w<R;w+=3){let E=w,x=w+1,b=w+2;s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),M=Math.min(c.count,m.start+m.count);for(let p=g,u=M;p<u;p+=3){let S=p,A=p+1,w=p+2;s=ar(this,a,t,n,l,h,f,S,A,w),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function qu(i,t,e,n,s,r,a,o){let c;if(t.side===De?c=n.intersectTriangle(a,r,s,!0,o):c=n.intersectTriangle(s,r,a,t.side===Qn,o),c===null)return null;rr.copy(o),rr.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(rr);return l<e.near||l>e.far?null:{distance:l,point:rr.clone(),object:i}}function ar(i,t,e,n,s,r,a,o,c,l){i.getVertexPosition(o,er),i.getVertexPosition(c,nr),i.getVertexPosition(l,ir);let h=qu(i,t,e,n,er,nr,ir,mc);if(h){let f=new U;Rn.getBarycoord(mc,er,nr,ir,f),s&&(h.uv=Rn.getInterpolatedAttribute(s,o,c,l,f,new Vt)),r&&(h.uv1=Rn.getInterpolatedAttribute(r,o,c,l,f,new Vt)),a&&(h.normal=Rn.getInterpolatedAttribute(a,o,c,l,f,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:c,c:l,normal:new U,materialIndex:0};Rn.getNormal(er,nr,ir,d.normal),h.face=d,h.barycoord=f}return h}var Nr=class extends Oe{constructor(t=null,e=1,n=1,s,r,a,o,c,l=Se,h=Se,f,d){super(null,a,o,c,l,h,s,r,f,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var li=new ci,Yu=new Vt(.5,.5),or=new U,Yn=class{constructor(t=new rn,e=new rn,n=new rn,s=new rn,r=new rn,a=new rn){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=je,n=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],c=r[2],l=r[3],h=r[4],f=r[5],d=r[6],m=r[7],g=r[8],M=r[9],p=r[10],u=r[11],S=r[12],A=r[13],w=r[14],R=r[15];if(s[0].setComponents(l-a,m-h,u-g,R-S).normalize(),s[1].setComponents(l+a,m+h,u+g,R+S).normalize(),s[2].setComponents(l+o,m+f,u+M,R+A).normalize(),s[3].setComponents(l-o,m-f,u-M,R-A).normalize(),n)s[4].setComponents(c,d,p,w).normalize(),s[5].setComponents(l-c,m-d,u-p,R-w).normalize();else if(s[4].setComponents(l-c,m-d,u-p,R-w).normalize(),e===je)s[5].setComponents(l+c,m+d,u+p,R+w).normalize();else if(e===Li)s[5].setComponents(c,d,p,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),li.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),li.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(li)}intersectsSprite(t){li.center.set(0,0,0);let e=Yu.distanceTo(t.center);return li.radius=.7071067811865476+e,li.applyMatrix4(t.matrixWorld),this.intersectsSphere(li)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(or.x=s.normal.x>0?t.max.x:t.min.x,or.y=s.normal.y>0?t.max.y:t.min.y,or.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(or)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gc=new Qt,Dr=class i{constructor(){this.coordinateSystem=je,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];gc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Yn),n[s].setFromProjectionMatrix(gc,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Yn),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Zn=class extends Pn{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ur=new U,Fr=new U,xc=new Qt,ts=new us,lr=new ci,_o=new U,vc=new U,Fi=class extends Te{constructor(t=new _e,e=new Zn){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ur.fromBufferAttribute(e,s-1),Fr.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ur.distanceTo(Fr);t.setAttribute("lineDistance",new te(n,1))}else Rt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),lr.copy(n.boundingSphere),lr.applyMatrix4(s),lr.radius+=r,t.ray.intersectsSphere(lr)===!1)return;xc.copy(s).invert(),ts.copy(t.ray).applyMatrix4(xc);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let M=m,p=g-1;M<p;M+=l){let u=h.getX(M),S=h.getX(M+1),A=cr(this,t,ts,c,u,S,M);A&&e.push(A)}if(this.isLineLoop){let M=h.getX(g-1),p=h.getX(m),u=cr(this,t,ts,c,M,p,g-1);u&&e.push(u)}}else{let m=Math.max(0,a.start),g=Math.min(d.count,a.start+a.count);for(let M=m,p=g-1;M<p;M+=l){let u=cr(this,t,ts,c,M,M+1,M);u&&e.push(u)}if(this.isLineLoop){let M=cr(this,t,ts,c,g-1,m,g-1);M&&e.push(M)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function cr(i,t,e,n,s,r,a){let o=i.geometry.attributes.position;if(Ur.fromBufferAttribute(o,s),Fr.fromBufferAttribute(o,r),e.distanceSqToSegment(Ur,Fr,_o,vc)>n)return;_o.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(_o);if(!(l<t.near||l>t.far))return{distance:l,point:vc.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var yc=new U,Mc=new U,Oi=class extends Fi{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)yc.fromBufferAttribute(e,s),Mc.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+yc.distanceTo(Mc);t.setAttribute("lineDistance",new te(n,1))}else Rt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ds=class extends Oe{constructor(t=[],e=fi,n,s,r,a,o,c,l,h){super(t,e,n,s,r,a,o,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ln=class extends Oe{constructor(t,e,n=an,s,r,a,o=Se,c=Se,l,h=_n,f=1){if(h!==_n&&h!==Un)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:f};super(d,s,r,a,o,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Di(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},fs=class extends Ln{constructor(t,e=an,n=fi,s,r,a=Se,o=Se,c,l=_n){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ps=class extends Oe{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Nn=class i extends _e{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let c=[],l=[],h=[],f=[],d=0,m=0;g("z","y","x",-1,-1,n,e,t,a,r,0),g("z","y","x",1,-1,n,e,-t,a,r,1),g("x","z","y",1,1,t,n,e,s,a,2),g("x","z","y",1,-1,t,n,-e,s,a,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2));function g(M,p,u,S,A,w,R,E,x,b,D){let P=w/x,N=R/b,B=w/2,V=R/2,_=E/2,H=x+1,q=b+1,G=0,et=0,X=new U;for(let Q=0;Q<q;Q++){let $=Q*N-V;for(let St=0;St<H;St++){let Lt=St*P-B;X[M]=Lt*S,X[p]=$*A,X[u]=_,l.push(X.x,X.y,X.z),X[M]=0,X[p]=0,X[u]=E>0?1:-1,h.push(X.x,X.y,X.z),f.push(St/x),f.push(1-Q/b),G+=1}}for(let Q=0;Q<b;Q++)for(let $=0;$<x;$++){let St=d+$+H*Q,Lt=d+$+H*(Q+1),J=d+($+1)+H*(Q+1),pt=d+($+1)+H*Q;c.push(St,Lt,pt),c.push(Lt,J,pt),et+=6}o.addGroup(m,et,D),m+=et,d+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Bi=class i extends _e{constructor(t=1,e=1,n=1,s=32,r=1,a=!1,o=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],d=[],m=[],g=0,M=[],p=n/2,u=0;S(),a===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new te(f,3)),this.setAttribute("normal",new te(d,3)),this.setAttribute("uv",new te(m,2));function S(){let w=new U,R=new U,E=0,x=(e-t)/n;for(let b=0;b<=r;b++){let D=[],P=b/r,N=P*(e-t)+t;for(let B=0;B<=s;B++){let V=B/s,_=V*c+o,H=Math.sin(_),q=Math.cos(_);R.x=N*H,R.y=-P*n+p,R.z=N*q,f.push(R.x,R.y,R.z),w.set(H,x,q).normalize(),d.push(w.x,w.y,w.z),m.push(V,1-P),D.push(g++)}M.push(D)}for(let b=0;b<s;b++)for(let D=0;D<r;D++){let P=M[D][b],N=M[D+1][b],B=M[D+1][b+1],V=M[D][b+1];(t>0||D!==0)&&(h.push(P,N,V),E+=3),(e>0||D!==r-1)&&(h.push(N,B,V),E+=3)}l.addGroup(u,E,0),u+=E}function A(w){let R=g,E=new Vt,x=new U,b=0,D=w===!0?t:e,P=w===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,p*P,0),d.push(0,P,0),m.push(.5,.5),g++;let N=g;for(let B=0;B<=s;B++){let _=B/s*c+o,H=Math.cos(_),q=Math.sin(_);x.x=D*q,x.y=p*P,x.z=D*H,f.push(x.x,x.y,x.z),d.push(0,P,0),E.x=H*.5+.5,E.y=q*.5*P+.5,m.push(E.x,E.y),g++}for(let B=0;B<s;B++){let V=R+B,_=N+B;w===!0?h.push(_,_+1,V):h.push(_+1,_,V),b+=3}l.addGroup(u,b,w===!0?1:2),u+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ms=class i extends Bi{constructor(t=1,e=1,n=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,n,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var hr=new U,ur=new U,Io=new U,dr=new Rn,gs=class extends _e{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(vr*e),a=t.getIndex(),o=t.getAttribute("position"),c=a?a.count:o.count,l=[0,0,0],h=["a","b","c"],f=new Array(3),d=new Map,m=[];for(let g=0;g<c;g+=3){a?(l[0]=a.getX(g),l[1]=a.getX(g+1),l[2]=a.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:M,b:p,c:u}=dr;if(M.fromBufferAttribute(o,l[0]),p.fromBufferAttribute(o,l[1]),u.fromBufferAttribute(o,l[2]),dr.getNormal(Io),f[0]=`${Math.round(M.x*s)},${Math.round(M.y*s)},${Math.round(M.z*s)}`,f[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,f[2]=`${Math.round(u.x*s)},${Math.round(u.y*s)},${Math.round(u.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let S=0;S<3;S++){let A=(S+1)%3,w=f[S],R=f[A],E=dr[h[S]],x=dr[h[A]],b=`${w}_${R}`,D=`${R}_${w}`,P=d.get(D);P?(Io.dot(P.normal)<=r&&(m.push(E.x,E.y,E.z),m.push(x.x,x.y,x.z)),d.set(D,null)):d.has(b)||d.set(b,{index0:l[S],index1:l[A],normal:Io.clone()})}}for(let g of d.values())if(g){let{index0:M,index1:p}=g;hr.fromBufferAttribute(o,M),ur.fromBufferAttribute(o,p),m.push(hr.x,hr.y,hr.z),m.push(ur.x,ur.y,ur.z)}this.setAttribute("position",new te(m,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var hi=class i extends _e{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(n),c=Math.floor(s),l=o+1,h=c+1,f=t/o,d=e/c,m=[],g=[],M=[],p=[];for(let u=0;u<h;u++){let S=u*d-a;for(let A=0;A<l;A++){let w=A*f-r;g.push(w,-S,0),M.push(0,0,1),p.push(A/o),p.push(1-u/c)}}for(let u=0;u<c;u++)for(let S=0;S<o;S++){let A=S+l*u,w=S+l*(u+1),R=S+1+l*(u+1),E=S+1+l*u;m.push(A,w,E),m.push(w,R,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(M,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var zi=class i extends _e{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(a+o,Math.PI),l=0,h=[],f=new U,d=new U,m=[],g=[],M=[],p=[];for(let u=0;u<=n;u++){let S=[],A=u/n,w=a+A*o,R=t*Math.cos(w),E=Math.sqrt(t*t-R*R),x=0;u===0&&a===0?x=.5/e:u===n&&c===Math.PI&&(x=-.5/e);for(let b=0;b<=e;b++){let D=b/e,P=s+D*r;f.x=-E*Math.cos(P),f.y=R,f.z=E*Math.sin(P),g.push(f.x,f.y,f.z),d.copy(f).normalize(),M.push(d.x,d.y,d.z),p.push(D+x,1-A),S.push(l++)}h.push(S)}for(let u=0;u<n;u++)for(let S=0;S<e;S++){let A=h[u][S+1],w=h[u][S],R=h[u+1][S],E=h[u+1][S+1];(u!==0||a>0)&&m.push(A,w,E),(u!==n-1||c<Math.PI)&&m.push(w,R,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(M,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var xs=class i extends _e{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],h=[],f=[],d=new U,m=new U,g=new U;for(let M=0;M<=n;M++){let p=a+M/n*o;for(let u=0;u<=s;u++){let S=u/s*r;m.x=(t+e*Math.cos(p))*Math.cos(S),m.y=(t+e*Math.cos(p))*Math.sin(S),m.z=e*Math.sin(p),l.push(m.x,m.y,m.z),d.x=t*Math.cos(S),d.y=t*Math.sin(S),g.subVectors(m,d).normalize(),h.push(g.x,g.y,g.z),f.push(u/s),f.push(M/n)}}for(let M=1;M<=n;M++)for(let p=1;p<=s;p++){let u=(s+1)*M+p-1,S=(s+1)*(M-1)+p-1,A=(s+1)*(M-1)+p,w=(s+1)*M+p;c.push(u,S,w),c.push(S,A,w)}this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function mi(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Sc(s))s.isRenderTargetTexture?(Rt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Sc(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Ie(i){let t={};for(let e=0;e<i.length;e++){let n=mi(i[e]);for(let s in n)t[s]=n[s]}return t}function Sc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Zu(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function dl(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Ht.workingColorSpace}var fh={clone:mi,merge:Ie},Ju=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ku=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,gn=class extends Pn{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ju,this.fragmentShader=Ku,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=mi(t.uniforms),this.uniformsGroups=Zu(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Ut().setHex(s.value);break;case"v2":this.uniforms[n].value=new Vt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new U().fromArray(s.value);break;case"v4":this.uniforms[n].value=new se().fromArray(s.value);break;case"m3":this.uniforms[n].value=new It().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Or=class extends gn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vs=class extends Pn{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new Vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new In,this.combine=Qr,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Br=class extends Pn{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qc,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},zr=class extends Pn{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ri(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function fr(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Jn=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let a;e:{i:if(!(t<s)){for(let o=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=e[++n],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(n=2,r=o);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}a=n,n=0;break e}break n}for(;n<a;){let o=n+a>>>1;t<e[o]?a=o:n=o+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=n[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:No,endingEnd:No}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],c=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Do:r=t,o=2*e-n;break;case Uo:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Do:a=t,c=2*n-e;break;case Uo:a=1,c=n+s[1]-s[0];break;default:a=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-o),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-e)/(s-e),M=g*g,p=M*g,u=-d*p+2*d*M-d*g,S=(1+d)*p+(-1.5-2*d)*M+(-.5+d)*g+1,A=(-1-m)*p+(1.5+m)*M+.5*g,w=m*p-m*M;for(let R=0;R!==o;++R)r[R]=u*a[h+R]+S*a[l+R]+A*a[c+R]+w*a[f+R];return r}},Gr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=(n-e)/(s-e),f=1-h;for(let d=0;d!==o;++d)r[d]=a[l+d]*f+a[c+d]*h;return r}},Hr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Vr=class extends Jn{interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-e)/(s-e),M=1-g;for(let p=0;p!==o;++p)r[p]=a[l+p]*M+a[c+p]*g;return r}let d=o*2,m=t-1;for(let g=0;g!==o;++g){let M=a[l+g],p=a[c+g],u=m*d+g*2,S=f[u],A=f[u+1],w=t*d+g*2,R=h[w],E=h[w+1],x=Qu(n,e,S,R,s);r[g]=ph(x,M,A,E,p)}return r}};function ph(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function ju(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Qu(i,t,e,n,s){let r=(i-t)/(s-t);for(let a=0;a<8;a++){let o=ph(r,t,e,n,s)-i;if(Math.abs(o)<1e-10)break;let c=ju(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-o/c))}return r}var We=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ri(e,this.TimeBufferType),this.values=Ri(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Ri(t.times,Array),values:Ri(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),fr(t.settings)&&(n.settings={inTangents:Ri(t.settings.inTangents,Array),outTangents:Ri(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Hr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Gr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new kr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Vr(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ns:e=this.InterpolantFactoryMethodDiscrete;break;case Cr:e=this.InterpolantFactoryMethodLinear;break;case gr:e=this.InterpolantFactoryMethodSmooth;break;case Lo:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Rt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ns;case this.InterpolantFactoryMethodLinear:return Cr;case this.InterpolantFactoryMethodSmooth:return gr;case this.InterpolantFactoryMethodBezier:return Lo}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;fr(this.settings)&&(bc(this.settings.inTangents,t),bc(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;fr(this.settings)&&(wc(this.settings.inTangents,t),wc(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<t;)++r;for(;a!==-1&&n[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(_t("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(_t("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let c=n[o];if(typeof c=="number"&&isNaN(c)){_t("KeyframeTrack: Time is not a valid number.",this,o,c),t=!1;break}if(a!==null&&a>c){_t("KeyframeTrack: Out of order keys.",this,o,c,a),t=!1;break}a=c}if(s!==void 0&&Au(s))for(let o=0,c=s.length;o!==c;++o){let l=s[o];if(isNaN(l)){_t("KeyframeTrack: Value is not a valid number.",this,o,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===gr,r=t.length-1,a=1;for(let o=1;o<r;++o){let c=!1,l=t[o],h=t[o+1];if(l!==h&&(o!==1||l!==t[0]))if(s)c=!0;else{let f=o*n,d=f-n,m=f+n;for(let g=0;g!==n;++g){let M=e[f+g];if(M!==e[d+g]||M!==e[m+g]){c=!0;break}}}if(c){if(o!==a){t[a]=t[o];let f=o*n,d=a*n;for(let m=0;m!==n;++m)e[d+m]=e[f+m]}++a}}if(r>0){t[a]=t[r];for(let o=r*n,c=a*n,l=0;l!==n;++l)e[c+l]=e[o+l];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,fr(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function wc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}We.prototype.ValueTypeName="";We.prototype.TimeBufferType=Float32Array;We.prototype.ValueBufferType=Float32Array;We.prototype.DefaultInterpolation=Cr;var Kn=class extends We{constructor(t,e,n){super(t,e,n)}};Kn.prototype.ValueTypeName="bool";Kn.prototype.ValueBufferType=Array;Kn.prototype.DefaultInterpolation=ns;Kn.prototype.InterpolantFactoryMethodLinear=void 0;Kn.prototype.InterpolantFactoryMethodSmooth=void 0;var Wr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Wr.prototype.ValueTypeName="color";var Xr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Xr.prototype.ValueTypeName="number";var qr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=(n-e)/(s-e),l=t*o;for(let h=l+o;l!==h;l+=4)Qe.slerpFlat(r,0,a,l-o,a,l,c);return r}},ys=class extends We{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new qr(this.times,this.values,this.getValueSize(),t)}};ys.prototype.ValueTypeName="quaternion";ys.prototype.InterpolantFactoryMethodSmooth=void 0;var jn=class extends We{constructor(t,e,n){super(t,e,n)}};jn.prototype.ValueTypeName="string";jn.prototype.ValueBufferType=Array;jn.prototype.DefaultInterpolation=ns;jn.prototype.InterpolantFactoryMethodLinear=void 0;jn.prototype.InterpolantFactoryMethodSmooth=void 0;var Yr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Yr.prototype.ValueTypeName="vector";var Zr=class{constructor(t,e,n){let s=this,r=!1,a=0,o=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,f){return l.push(h,f),this},this.removeHandler=function(h){let f=l.indexOf(h);return f!==-1&&l.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=l.length;f<d;f+=2){let m=l[f],g=l[f+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mh=new Zr,Jr=class{constructor(t){this.manager=t!==void 0?t:mh,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ms=class extends Te{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ut(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ss=class extends Ms{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Te.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ut(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Po=new Qt,Tc=new U,Ec=new U,Kr=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Vt(512,512),this.mapType=Be,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Yn,this._frameExtents=new Vt(1,1),this._viewportCount=1,this._viewports=[new se(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Tc.setFromMatrixPosition(t.matrixWorld),e.position.copy(Tc),Ec.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Ec),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Po.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Po,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Li||t.reversedDepth?e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,.5,.5,0,0,0,1),e.multiply(Po)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},pr=new U,mr=new Qe,dn=new U,bs=class extends Te{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=je,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xn=new U,Ac=new Vt,Rc=new Vt,Le=class extends bs{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=_r*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(vr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return _r*2*Math.atan(Math.tan(vr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Xn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z),Xn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z)}getViewSize(t,e){return this.getViewBounds(t,Ac,Rc),e.subVectors(Rc,Ac)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(vr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let c=a.fullWidth,l=a.fullHeight;r+=a.offsetX*s/c,e-=a.offsetY*n/l,s*=a.width/c,n*=a.height/l}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ws=class extends bs{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,a=n+t,o=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,a=r+l*this.view.width,o-=h*this.view.offsetY,c=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Fo=class extends Kr{constructor(){super(new ws(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ts=class extends Ms{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Te.DEFAULT_UP),this.updateMatrix(),this.target=new Te,this.shadow=new Fo}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ci=-90,_i=1,ki=class extends Te{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Le(Ci,_i,t,e);s.layers=this.layers,this.add(s);let r=new Le(Ci,_i,t,e);r.layers=this.layers,this.add(r);let a=new Le(Ci,_i,t,e);a.layers=this.layers,this.add(a);let o=new Le(Ci,_i,t,e);o.layers=this.layers,this.add(o);let c=new Le(Ci,_i,t,e);c.layers=this.layers,this.add(c);let l=new Le(Ci,_i,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,c]=e;for(let l of e)this.remove(l);if(t===je)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Li)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,c,l,h]=this.children,f=t.getRenderTarget(),d=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let M=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=M,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,d,m),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},jr=class extends Le{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var fl="\\[\\]\\.:\\/",$u=new RegExp("["+fl+"]","g"),pl="[^"+fl+"]",td="[^"+fl.replace("\\.","")+"]",ed=/((?:WC+[\/:])*)/.source.replace("WC",pl),nd=/(WCOD+)?/.source.replace("WCOD",td),id=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pl),sd=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pl),rd=new RegExp("^"+ed+nd+id+sd+"$"),ad=["material","materials","bones","map"],Oo=class{constructor(t,e,n){let s=n||ee.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},ee=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace($u,"")}static parseTrackName(t){let e=rd.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ad.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let c=n(o.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Rt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){_t("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){_t("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){_t("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){_t("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){_t("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let a=t[s];if(a===void 0){let l=e.nodeName;_t("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(c=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ee.Composite=Oo;ee.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ee.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ee.prototype.GetterByBindingType=[ee.prototype._getValue_direct,ee.prototype._getValue_array,ee.prototype._getValue_arrayElement,ee.prototype._getValue_toArray];ee.prototype.SetterByBindingTypeAndVersioning=[[ee.prototype._setValue_direct,ee.prototype._setValue_direct_setNeedsUpdate,ee.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_array,ee.prototype._setValue_array_setNeedsUpdate,ee.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_arrayElement,ee.prototype._setValue_arrayElement_setNeedsUpdate,ee.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_fromArray,ee.prototype._setValue_fromArray_setNeedsUpdate,ee.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p0=new Float32Array(1);var Bo=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Es=class extends Oi{constructor(t=10,e=10,n=4473924,s=8947848){n=new Ut(n),s=new Ut(s);let r=e/2,a=t/e,o=t/2,c=[],l=[];for(let d=0,m=0,g=-o;d<=e;d++,g+=a){c.push(-o,0,g,o,0,g),c.push(g,0,-o,g,0,o);let M=d===r?n:s;M.toArray(l,m),m+=3,M.toArray(l,m),m+=3,M.toArray(l,m),m+=3,M.toArray(l,m),m+=3}let h=new _e;h.setAttribute("position",new te(c,3)),h.setAttribute("color",new te(l,3));let f=new Zn({vertexColors:!0,toneMapped:!1});super(h,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};function ml(i,t,e,n){let s=od(n);switch(e){case il:return i*t;case rl:return i*t/s.components*s.byteLength;case ra:return i*t/s.components*s.byteLength;case $n:return i*t*2/s.components*s.byteLength;case aa:return i*t*2/s.components*s.byteLength;case sl:return i*t*3/s.components*s.byteLength;case cn:return i*t*4/s.components*s.byteLength;case oa:return i*t*4/s.components*s.byteLength;case Cs:case _s:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Is:case Ps:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ca:case ua:return Math.max(i,16)*Math.max(t,8)/4;case la:case ha:return Math.max(i,8)*Math.max(t,8)/2;case da:case fa:case ma:case ga:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case pa:case Ls:case xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case va:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ya:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Ma:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Sa:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ba:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case wa:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Ta:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ea:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Aa:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Ra:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ca:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case _a:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Ia:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Pa:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case La:case Na:case Da:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ua:case Fa:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ns:case Oa:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function od(i){switch(i){case Be:case $o:return{byteLength:1,components:1};case Wi:case tl:case ln:return{byteLength:2,components:1};case ia:case sa:return{byteLength:2,components:4};case an:case na:case on:return{byteLength:4,components:1};case el:case nl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Rt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Oh(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function cd(i){let t=new WeakMap;function e(o,c){let l=o.array,h=o.usage,f=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),o.onUploadCallback();let m;if(l instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=i.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=i.SHORT;else if(l instanceof Uint32Array)m=i.UNSIGNED_INT;else if(l instanceof Int32Array)m=i.INT;else if(l instanceof Int8Array)m=i.BYTE;else if(l instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,c,l){let h=c.array,f=c.updateRanges;if(i.bindBuffer(l,o),f.length===0)i.bufferSubData(l,0,h);else{f.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<f.length;m++){let g=f[d],M=f[m];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++d,f[d]=M)}f.length=d+1;for(let m=0,g=f.length;m<g;m++){let M=f[m];i.bufferSubData(l,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let c=t.get(o);c&&(i.deleteBuffer(c.buffer),t.delete(o))}function a(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let l=t.get(o);if(l===void 0)t.set(o,e(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,o,c),l.version=o.version}}return{get:s,remove:r,update:a}}var hd=`#ifdef USE_ALPHAHASH
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
#endif`,Md=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Sd=`vec3 objectNormal = vec3( normal );
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
} // validated`,wd=`#ifdef USE_IRIDESCENCE
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
#endif`,Td=`#ifdef USE_BUMPMAP
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
#endif`,Ed=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Id=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Pd=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Nd=`#define PI 3.141592653589793
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
} // validated`,Dd=`vec3 transformedNormal = objectNormal;
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
#endif`,Ud=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Fd=`#ifdef USE_DISPLACEMENTMAP
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
#endif`,Hd=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Vd=`#ifdef USE_ENVMAP
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
#endif`,Yd=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Zd=`#ifdef USE_FOG
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
#endif`,Mf=`#if defined( USE_POINTS_UV )
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
#endif`,Sf=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,bf=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,wf=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Tf=`#if defined( USE_MORPHCOLORS )
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
#endif`,Ef=`#ifdef USE_MORPHNORMALS
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
#endif`,If=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Pf=`#ifndef FLAT_SHADED
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
#endif`,Nf=`#ifdef USE_NORMALMAP
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
#endif`,Df=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Uf=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Ff=`#ifdef USE_CLEARCOATMAP
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
gl_Position = projectionMatrix * mvPosition;`,Hf=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Vf=`#ifdef DITHERING
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
#endif`,Yf=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Zf=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
}`,Mp=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Sp=`uniform sampler2D tEquirect;
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
}`,wp=`uniform vec3 diffuse;
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
}`,Tp=`#include <common>
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
}`,Ep=`uniform vec3 diffuse;
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
}`,Ip=`#define NORMAL
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
}`,Pp=`#define NORMAL
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
}`,Np=`#define PHONG
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
}`,Dp=`#define STANDARD
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
}`,Up=`#define STANDARD
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
}`,Fp=`#define TOON
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
}`,Hp=`uniform float rotation;
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
}`,Vp=`uniform vec3 diffuse;
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
}`,Bt={alphahash_fragment:hd,alphahash_pars_fragment:ud,alphamap_fragment:dd,alphamap_pars_fragment:fd,alphatest_fragment:pd,alphatest_pars_fragment:md,aomap_fragment:gd,aomap_pars_fragment:xd,batching_pars_vertex:vd,batching_vertex:yd,begin_vertex:Md,beginnormal_vertex:Sd,bsdfs:bd,iridescence_fragment:wd,bumpmap_pars_fragment:Td,clipping_planes_fragment:Ed,clipping_planes_pars_fragment:Ad,clipping_planes_pars_vertex:Rd,clipping_planes_vertex:Cd,color_fragment:_d,color_pars_fragment:Id,color_pars_vertex:Pd,color_vertex:Ld,common:Nd,defaultnormal_vertex:Dd,displacementmap_pars_vertex:Ud,displacementmap_vertex:Fd,emissivemap_fragment:Od,emissivemap_pars_fragment:Bd,colorspace_fragment:zd,colorspace_pars_fragment:kd,envmap_fragment:Gd,envmap_common_pars_fragment:Hd,envmap_pars_fragment:Vd,envmap_pars_vertex:Wd,envmap_physical_pars_fragment:ef,envmap_vertex:Xd,fog_vertex:qd,fog_pars_vertex:Yd,fog_fragment:Zd,fog_pars_fragment:Jd,gradientmap_pars_fragment:Kd,lightmap_pars_fragment:jd,lights_lambert_fragment:Qd,lights_lambert_pars_fragment:$d,lights_pars_begin:tf,lights_toon_fragment:nf,lights_toon_pars_fragment:sf,lights_phong_fragment:rf,lights_phong_pars_fragment:af,lights_physical_fragment:of,lights_physical_pars_fragment:lf,lights_fragment_begin:cf,lights_fragment_maps:hf,lights_fragment_end:uf,lightprobes_pars_fragment:df,logdepthbuf_fragment:ff,logdepthbuf_pars_fragment:pf,logdepthbuf_pars_vertex:mf,logdepthbuf_vertex:gf,map_fragment:xf,map_pars_fragment:vf,map_particle_fragment:yf,map_particle_pars_fragment:Mf,metalnessmap_fragment:Sf,metalnessmap_pars_fragment:bf,morphinstance_vertex:wf,morphcolor_vertex:Tf,morphnormal_vertex:Ef,morphtarget_pars_vertex:Af,morphtarget_vertex:Rf,normal_fragment_begin:Cf,normal_fragment_maps:_f,normal_pars_fragment:If,normal_pars_vertex:Pf,normal_vertex:Lf,normalmap_pars_fragment:Nf,clearcoat_normal_fragment_begin:Df,clearcoat_normal_fragment_maps:Uf,clearcoat_pars_fragment:Ff,iridescence_pars_fragment:Of,opaque_fragment:Bf,packing:zf,premultiplied_alpha_fragment:kf,project_vertex:Gf,dithering_fragment:Hf,dithering_pars_fragment:Vf,roughnessmap_fragment:Wf,roughnessmap_pars_fragment:Xf,shadowmap_pars_fragment:qf,shadowmap_pars_vertex:Yf,shadowmap_vertex:Zf,shadowmask_pars_fragment:Jf,skinbase_vertex:Kf,skinning_pars_vertex:jf,skinning_vertex:Qf,skinnormal_vertex:$f,specularmap_fragment:tp,specularmap_pars_fragment:ep,tonemapping_fragment:np,tonemapping_pars_fragment:ip,transmission_fragment:sp,transmission_pars_fragment:rp,uv_pars_fragment:ap,uv_pars_vertex:op,uv_vertex:lp,worldpos_vertex:cp,background_vert:hp,background_frag:up,backgroundCube_vert:dp,backgroundCube_frag:fp,cube_vert:pp,cube_frag:mp,depth_vert:gp,depth_frag:xp,distance_vert:vp,distance_frag:yp,equirect_vert:Mp,equirect_frag:Sp,linedashed_vert:bp,linedashed_frag:wp,meshbasic_vert:Tp,meshbasic_frag:Ep,meshlambert_vert:Ap,meshlambert_frag:Rp,meshmatcap_vert:Cp,meshmatcap_frag:_p,meshnormal_vert:Ip,meshnormal_frag:Pp,meshphong_vert:Lp,meshphong_frag:Np,meshphysical_vert:Dp,meshphysical_frag:Up,meshtoon_vert:Fp,meshtoon_frag:Op,points_vert:Bp,points_frag:zp,shadow_vert:kp,shadow_frag:Gp,sprite_vert:Hp,sprite_frag:Vp},ft={common:{diffuse:{value:new Ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new It},alphaMap:{value:null},alphaMapTransform:{value:new It},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new It}},envmap:{envMap:{value:null},envMapRotation:{value:new It},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new It}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new It}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new It},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new It},normalScale:{value:new Vt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new It},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new It}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new It}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new It}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new It},alphaTest:{value:0},uvTransform:{value:new It}},sprite:{diffuse:{value:new Ut(16777215)},opacity:{value:1},center:{value:new Vt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new It},alphaMap:{value:null},alphaMapTransform:{value:new It},alphaTest:{value:0}}},Mn={basic:{uniforms:Ie([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Bt.meshbasic_vert,fragmentShader:Bt.meshbasic_frag},lambert:{uniforms:Ie([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},envMapIntensity:{value:1}}]),vertexShader:Bt.meshlambert_vert,fragmentShader:Bt.meshlambert_frag},phong:{uniforms:Ie([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},specular:{value:new Ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphong_vert,fragmentShader:Bt.meshphong_frag},standard:{uniforms:Ie([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag},toon:{uniforms:Ie([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)}}]),vertexShader:Bt.meshtoon_vert,fragmentShader:Bt.meshtoon_frag},matcap:{uniforms:Ie([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Bt.meshmatcap_vert,fragmentShader:Bt.meshmatcap_frag},points:{uniforms:Ie([ft.points,ft.fog]),vertexShader:Bt.points_vert,fragmentShader:Bt.points_frag},dashed:{uniforms:Ie([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Bt.linedashed_vert,fragmentShader:Bt.linedashed_frag},depth:{uniforms:Ie([ft.common,ft.displacementmap]),vertexShader:Bt.depth_vert,fragmentShader:Bt.depth_frag},normal:{uniforms:Ie([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Bt.meshnormal_vert,fragmentShader:Bt.meshnormal_frag},sprite:{uniforms:Ie([ft.sprite,ft.fog]),vertexShader:Bt.sprite_vert,fragmentShader:Bt.sprite_frag},background:{uniforms:{uvTransform:{value:new It},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Bt.background_vert,fragmentShader:Bt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new It}},vertexShader:Bt.backgroundCube_vert,fragmentShader:Bt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Bt.cube_vert,fragmentShader:Bt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Bt.equirect_vert,fragmentShader:Bt.equirect_frag},distance:{uniforms:Ie([ft.common,ft.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Bt.distance_vert,fragmentShader:Bt.distance_frag},shadow:{uniforms:Ie([ft.lights,ft.fog,{color:{value:new Ut(0)},opacity:{value:1}}]),vertexShader:Bt.shadow_vert,fragmentShader:Bt.shadow_frag}};Mn.physical={uniforms:Ie([Mn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new It},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new It},clearcoatNormalScale:{value:new Vt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new It},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new It},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new It},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new It},sheen:{value:0},sheenColor:{value:new Ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new It},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new It},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new It},transmissionSamplerSize:{value:new Vt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new It},attenuationDistance:{value:0},attenuationColor:{value:new Ut(0)},specularColor:{value:new Ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new It},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new It},anisotropyVector:{value:new Vt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new It}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag};var za={r:0,b:0,g:0},Wp=new Qt,Bh=new It;Bh.set(-1,0,0,0,1,0,0,0,1);function Xp(i,t,e,n,s,r){let a=new Ut(0),o=s===!0?0:1,c,l,h=null,f=0,d=null;function m(S){let A=S.isScene===!0?S.background:null;if(A&&A.isTexture){let w=S.backgroundBlurriness>0;A=t.get(A,w)}return A}function g(S){let A=!1,w=m(S);w===null?p(a,o):w&&w.isColor&&(p(w,1),A=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function M(S,A){let w=m(A);w&&w.isCubeTexture?(l===void 0&&(l=new pe(new Nn(1,1,1),new gn({name:"BackgroundCubeMaterial",uniforms:mi(Mn.backgroundCube.uniforms),vertexShader:Mn.backgroundCube.vertexShader,fragmentShader:Mn.backgroundCube.fragmentShader,side:De,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=w,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Wp.makeRotationFromEuler(A.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Bh),l.material.toneMapped=Ht.getTransfer(w.colorSpace)!==Yt,(h!==w||f!==w.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,f=w.version,d=i.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null)):w&&w.isTexture&&(c===void 0&&(c=new pe(new hi(2,2),new gn({name:"BackgroundMaterial",uniforms:mi(Mn.background.uniforms),vertexShader:Mn.background.vertexShader,fragmentShader:Mn.background.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=w,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Ht.getTransfer(w.colorSpace)!==Yt,w.matrixAutoUpdate===!0&&w.updateMatrix(),c.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||f!==w.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,f=w.version,d=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function p(S,A){S.getRGB(za,dl(i)),e.buffers.color.setClear(za.r,za.g,za.b,A,r)}function u(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,A=1){a.set(S),o=A,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(S){o=S,p(a,o)},render:g,addToRenderList:M,dispose:u}}function qp(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,a=!1;function o(N,B,V,_,H){let q=!1,G=f(N,_,V,B);r!==G&&(r=G,l(r.object)),q=m(N,_,V,H),q&&g(N,_,V,H),H!==null&&t.update(H,i.ELEMENT_ARRAY_BUFFER),(q||a)&&(a=!1,w(N,B,V,_),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function c(){return i.createVertexArray()}function l(N){return i.bindVertexArray(N)}function h(N){return i.deleteVertexArray(N)}function f(N,B,V,_){let H=_.wireframe===!0,q=n[B.id];q===void 0&&(q={},n[B.id]=q);let G=N.isInstancedMesh===!0?N.id:0,et=q[G];et===void 0&&(et={},q[G]=et);let X=et[V.id];X===void 0&&(X={},et[V.id]=X);let Q=X[H];return Q===void 0&&(Q=d(c()),X[H]=Q),Q}function d(N){let B=[],V=[],_=[];for(let H=0;H<e;H++)B[H]=0,V[H]=0,_[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:_,object:N,attributes:{},index:null}}function m(N,B,V,_){let H=r.attributes,q=B.attributes,G=0,et=V.getAttributes();for(let X in et)if(et[X].location>=0){let $=H[X],St=q[X];if(St===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&(St=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&(St=N.instanceColor)),$===void 0||$.attribute!==St||St&&$.data!==St.data)return!0;G++}return r.attributesNum!==G||r.index!==_}function g(N,B,V,_){let H={},q=B.attributes,G=0,et=V.getAttributes();for(let X in et)if(et[X].location>=0){let $=q[X];$===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&($=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&($=N.instanceColor));let St={};St.attribute=$,$&&$.data&&(St.data=$.data),H[X]=St,G++}r.attributes=H,r.attributesNum=G,r.index=_}function M(){let N=r.newAttributes;for(let B=0,V=N.length;B<V;B++)N[B]=0}function p(N){u(N,0)}function u(N,B){let V=r.newAttributes,_=r.enabledAttributes,H=r.attributeDivisors;V[N]=1,_[N]===0&&(i.enableVertexAttribArray(N),_[N]=1),H[N]!==B&&(i.vertexAttribDivisor(N,B),H[N]=B)}function S(){let N=r.newAttributes,B=r.enabledAttributes;for(let V=0,_=B.length;V<_;V++)B[V]!==N[V]&&(i.disableVertexAttribArray(V),B[V]=0)}function A(N,B,V,_,H,q,G){G===!0?i.vertexAttribIPointer(N,B,V,H,q):i.vertexAttribPointer(N,B,V,_,H,q)}function w(N,B,V,_){M();let H=_.attributes,q=V.getAttributes(),G=B.defaultAttributeValues;for(let et in q){let X=q[et];if(X.location>=0){let Q=H[et];if(Q===void 0&&(et==="instanceMatrix"&&N.instanceMatrix&&(Q=N.instanceMatrix),et==="instanceColor"&&N.instanceColor&&(Q=N.instanceColor)),Q!==void 0){let $=Q.normalized,St=Q.itemSize,Lt=t.get(Q);if(Lt===void 0)continue;let J=Lt.buffer,pt=Lt.type,vt=Lt.bytesPerElement,Et=pt===i.INT||pt===i.UNSIGNED_INT||Q.gpuType===na;if(Q.isInterleavedBufferAttribute){let mt=Q.data,Dt=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,le=Q.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Ct=0;Ct<X.locationSize;Ct++)u(X.location+Ct,mt.meshPerAttribute);N.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Ct=0;Ct<X.locationSize;Ct++)p(X.location+Ct);i.bindBuffer(i.ARRAY_BUFFER,J);for(let Ct=0;Ct<X.locationSize;Ct++)A(X.location+Ct,St/X.locationSize,pt,$,Dt*vt,(le+St/X.locationSize*Ct)*vt,Et)}else{if(Q.isInstancedBufferAttribute){for(let mt=0;mt<X.locationSize;mt++)u(X.location+mt,Q.meshPerAttribute);N.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let mt=0;mt<X.locationSize;mt++)p(X.location+mt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let mt=0;mt<X.locationSize;mt++)A(X.location+mt,St/X.locationSize,pt,$,St*vt,St/X.locationSize*mt*vt,Et)}}else if(G!==void 0){let $=G[et];if($!==void 0)switch($.length){case 2:i.vertexAttrib2fv(X.location,$);break;case 3:i.vertexAttrib3fv(X.location,$);break;case 4:i.vertexAttrib4fv(X.location,$);break;default:i.vertexAttrib1fv(X.location,$)}}}}S()}function R(){D();for(let N in n){let B=n[N];for(let V in B){let _=B[V];for(let H in _){let q=_[H];for(let G in q)h(q[G].object),delete q[G];delete _[H]}}delete n[N]}}function E(N){if(n[N.id]===void 0)return;let B=n[N.id];for(let V in B){let _=B[V];for(let H in _){let q=_[H];for(let G in q)h(q[G].object),delete q[G];delete _[H]}}delete n[N.id]}function x(N){for(let B in n){let V=n[B];for(let _ in V){let H=V[_];if(H[N.id]===void 0)continue;let q=H[N.id];for(let G in q)h(q[G].object),delete q[G];delete H[N.id]}}}function b(N){for(let B in n){let V=n[B],_=N.isInstancedMesh===!0?N.id:0,H=V[_];if(H!==void 0){for(let q in H){let G=H[q];for(let et in G)h(G[et].object),delete G[et];delete H[q]}delete V[_],Object.keys(V).length===0&&delete n[B]}}}function D(){P(),a=!0,r!==s&&(r=s,l(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:D,resetDefaultState:P,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:M,enableAttribute:p,disableUnusedAttributes:S}}function Yp(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function a(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function o(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let m=0;m<h;m++)d+=l[m];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Zp(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==cn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let b=x===ln&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==Be&&x!==on&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Rt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Rt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Rt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),u=i.getParameter(i.MAX_VERTEX_ATTRIBS),S=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:a,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:p,maxAttributes:u,maxVertexUniforms:S,maxVaryings:A,maxFragmentUniforms:w,maxSamples:R,samples:E}}function Jp(i){let t=this,e=null,n=0,s=!1,r=!1,a=new rn,o=new It,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let m=f.length!==0||d||n!==0||s;return s=d,n=f.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){e=h(f,d,0)},this.setState=function(f,d,m){let g=f.clippingPlanes,M=f.clipIntersection,p=f.clipShadows,u=i.get(f);if(!s||g===null||g.length===0||r&&!p)r?h(null):l();else{let S=r?0:n,A=S*4,w=u.clippingState||null;c.value=w,w=h(g,d,A,m);for(let R=0;R!==A;++R)w[R]=e[R];u.clippingState=w,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=S}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(f,d,m,g){let M=f!==null?f.length:0,p=null;if(M!==0){if(p=c.value,g!==!0||p===null){let u=m+M*4,S=d.matrixWorldInverse;o.getNormalMatrix(S),(p===null||p.length<u)&&(p=new Float32Array(u));for(let A=0,w=m;A!==M;++A,w+=4)a.copy(f[A]).applyMatrix4(S,o),a.normal.toArray(p,w),p[w+3]=a.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=M,t.numIntersection=0,p}}var Os=class extends Ve{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ds(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Nn(5,5,5),r=new gn({name:"CubemapFromEquirect",uniforms:mi(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:De,blending:ui});r.uniforms.tEquirect.value=e;let a=new pe(s,r),o=e.minFilter;return e.minFilter===Dn&&(e.minFilter=Ne),new ki(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(r)}},gh=256,Kp=3,jp=20,zh=256,kh=16,Qp=3,$p=new U,tm=new Ut,Ga=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ki(1,10,null),this._boxMesh=new pe(new Nn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:a=256,position:o=$p}=r,c=this._renderer;this._setSize(a);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,d=c.autoClearColor,m=c.autoClearDepth,g=c.autoClearStencil,M=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,M===null&&(t.background=c.getClearColor(tm));let p=new ki(n,s,h);return p.position.copy(o),p.update(c,t),c.autoClear=f,c.autoClearColor=d,c.autoClearDepth=m,c.autoClearStencil=g,t.background=M,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(gh,uh(t))}_fromTexture(t,e){t.mapping===fi||t.mapping===Vi?this._setSize(t.image.length===0?gh:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=xh(t,!1,!1),n=Math.log2(t)-Kp;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=xh(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===fi||t.mapping===Vi?(this._cubemapMaterial===null&&(this._cubemapMaterial=yh()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vh()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=em(),this._integrationMaterial=nm());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/kh);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-Qp)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let c=o>0?Math.log2(e)+.5*Math.log2(6/(zh*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=c,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=im());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function xh(i,t,e){return new Os(i,{minFilter:Dn,generateMipmaps:t,type:ln,colorSpace:is,depthBuffer:e})}function Bs(i,t,e){return new gn({name:i,uniforms:t,vertexShader:Bt.cube_vert,fragmentShader:e,side:De,blending:ui,depthTest:!1,depthWrite:!1})}function em(){return Bs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

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
	`)}function sm(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?a(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===$r||m===ta)if(t.has(d)){let g=t.get(d).texture;return o(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let M=new Os(g.height);return M.fromEquirectangularTexture(i,d),t.set(d,M),d.addEventListener("dispose",l),o(M.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===$r||m===ta,M=m===fi||m===Vi;if(g||M){let p=e.get(d),u=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==u)return n===null&&(n=new Ga(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let S=d.image;return g&&S&&S.height>0||M&&S&&c(S)?(n===null&&(n=new Ga(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function o(d,m){return m===$r?d.mapping=fi:m===ta&&(d.mapping=Vi),d}function c(d){let m=0,g=6;for(let M=0;M<g;M++)d[M]!==void 0&&m++;return m===g}function l(d){let m=d.target;m.removeEventListener("dispose",l);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function rm(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&es("WebGLRenderer: "+n+" extension not supported."),s}}}function am(i,t,e,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let M=r.get(g);M&&(t.remove(M),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,M){return s[M.id]!==void 0||(M.addEventListener("dispose",o),s[M.id]=new WeakRef(M),a.register(M,M.id,M),e.memory.geometries++),M}function h(g){let M=g.attributes;for(let p in M)t.update(M[p],i.ARRAY_BUFFER)}function f(g){let M=g.index,p=g.attributes.position,u=0;if(p===void 0)return;let S=M!==null?M.array.length:p.array.length/3-1,A=p.count>=65535?hs:cs,w=new A(Math.ceil(S/3)*6,1),R=w.array;if(M!==null){let x=M.array;u=M.version;for(let b=0,D=0;b<S;b+=3){let P=x[b+0],N=x[b+1],B=x[b+2];R[D++]=P,R[D++]=N,R[D++]=N,R[D++]=B,R[D++]=B,R[D++]=P}}else{u=p.version;for(let x=0,b=0;x<S;x+=3){let D=x+0,P=x+1,N=x+2;R[b++]=D,R[b++]=P,R[b++]=P,R[b++]=N,R[b++]=N,R[b++]=D}}w.version=u;let E=r.get(g);E&&t.remove(E),r.set(g,w)}function d(g){let M=r.get(g);if(M){let p=g.index;p!==null&&M.version<p.version&&f(g)}else f(g);return r.get(g)}function m(){for(let g in s){let M=s[g].deref();M!==void 0&&c(M)}}return{get:l,update:h,getWireframeAttribute:d,dispose:m}}function om(i,t,e){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function c(f,d){i.drawElements(n,d,r,f*a),e.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,f*a,m),e.update(d,n,m))}function h(f,d,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,m);let M=0;for(let p=0;p<m;p++)M+=d[p];e.update(M,n,1)}this.setMode=s,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function lm(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:_t("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function cm(i,t,e){let n=new WeakMap,s=new se;function r(a,o,c){let l=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=h!==void 0?h.length:0,d=n.get(o);if(d===void 0||d.count!==f){let D=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let m=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,M=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],u=o.morphAttributes.normal||[],S=o.morphAttributes.color||[],A=0;m===!0&&(A=1),g===!0&&(A=2),M===!0&&(A=3);let w=o.attributes.position.count*A,R=1;w>t.maxTextureSize&&(R=Math.ceil(w/t.maxTextureSize),w=t.maxTextureSize);let E=new Float32Array(w*R*4*f),x=new as(E,w,R,f);x.type=on,x.needsUpdate=!0;let b=A*4;for(let P=0;P<f;P++){let N=p[P],B=u[P],V=S[P],_=w*R*4*P;for(let H=0;H<N.count;H++){let q=H*b;m===!0&&(s.fromBufferAttribute(N,H),E[_+q+0]=s.x,E[_+q+1]=s.y,E[_+q+2]=s.z,E[_+q+3]=0),g===!0&&(s.fromBufferAttribute(B,H),E[_+q+4]=s.x,E[_+q+5]=s.y,E[_+q+6]=s.z,E[_+q+7]=0),M===!0&&(s.fromBufferAttribute(V,H),E[_+q+8]=s.x,E[_+q+9]=s.y,E[_+q+10]=s.z,E[_+q+11]=V.itemSize===4?s.w:1)}}d={count:f,texture:x,size:new Vt(w,R)},n.set(o,d),o.addEventListener("dispose",D)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let m=0;for(let M=0;M<l.length;M++)m+=l[M];let g=o.morphTargetsRelative?1:1-m;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function hm(i,t,e,n,s){let r=new WeakMap;function a(l){let h=s.render.frame,f=l.geometry,d=t.get(l,f);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function o(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var um={[Xo]:"LINEAR_TONE_MAPPING",[qo]:"REINHARD_TONE_MAPPING",[Yo]:"CINEON_TONE_MAPPING",[Zo]:"ACES_FILMIC_TONE_MAPPING",[Ko]:"AGX_TONE_MAPPING",[jo]:"NEUTRAL_TONE_MAPPING",[Jo]:"CUSTOM_TONE_MAPPING"};function dm(i,t,e,n,s,r){let a=new Ve(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,c=null,l=null,h=new _e;h.setAttribute("position",new te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new te([0,2,0,0,2,0],2));let f=new Or({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new pe(h,f),m=new ws(-1,1,1,-1,0,1),g=null,M=null,p=!1,u,S=null,A=[],w=!1;this.setSize=function(R,E){a.setSize(R,E),o!==null&&o.setSize(R,E),c!==null&&c.setSize(R,E);for(let x=0;x<A.length;x++){let b=A[x];b.setSize&&b.setSize(R,E)}},this.setEffects=function(R){A=R,w=A.length>0&&A[0].isRenderPass===!0;let E=a.width,x=a.height;A.length>0&&o===null&&(o=new Ve(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}),c=new Ve(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(D=>D.needsDepthTexture===!0);b!==(a.depthTexture!==null)&&(b===!0&&l===null&&(l=new Ln(E,x),r===!0&&(l.format=Un,l.type=pi)),a.dispose(),a.depthTexture=b?l:null,a.resolveDepthBuffer=b,a.storeMultisampledDepthBuffer=b);for(let D=0;D<A.length;D++){let P=A[D];P.setSize&&P.setSize(E,x),b&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(l)}},this.begin=function(R,E){if(p||R.toneMapping===vn&&A.length===0)return!1;if(S=E,E!==null){let x=E.width,b=E.height;(a.width!==x||a.height!==b)&&this.setSize(x,b)}return w===!1&&R.setRenderTarget(a),u=R.toneMapping,R.toneMapping=vn,!0},this.hasRenderPass=function(){return w},this.end=function(R,E){R.toneMapping=u,p=!0;let x=a,b=o;for(let D=0;D<A.length;D++){let P=A[D];P.enabled!==!1&&(P.render(R,b,x,E),P.needsSwap!==!1&&(x=b,b=b===o?c:o))}if(g!==R.outputColorSpace||M!==R.toneMapping){g=R.outputColorSpace,M=R.toneMapping,f.defines={},Ht.getTransfer(g)===Yt&&(f.defines.SRGB_TRANSFER="");let D=um[M];D&&(f.defines[D]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(S),R.render(d,m),S=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var Gh=new Oe,Hh=new Ln(1,1),Vh=new fs(1),Wh=new as,Xh=new Lr,qh=new ds,Mh=[],Sh=[],bh=new Float32Array(16),wh=new Float32Array(9),Th=new Float32Array(4);function qi(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Mh[s];if(r===void 0&&(r=new Float32Array(s),Mh[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function me(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function ge(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Va(i,t){let e=Sh[t];e===void 0&&(e=new Int32Array(t),Sh[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function fm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function pm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2fv(this.addr,t),ge(e,t)}}function mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(me(e,t))return;i.uniform3fv(this.addr,t),ge(e,t)}}function gm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4fv(this.addr,t),ge(e,t)}}function xm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;Th.set(n),i.uniformMatrix2fv(this.addr,!1,Th),ge(e,n)}}function vm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;wh.set(n),i.uniformMatrix3fv(this.addr,!1,wh),ge(e,n)}}function ym(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;bh.set(n),i.uniformMatrix4fv(this.addr,!1,bh),ge(e,n)}}function Mm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Sm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2iv(this.addr,t),ge(e,t)}}function bm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3iv(this.addr,t),ge(e,t)}}function wm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4iv(this.addr,t),ge(e,t)}}function Tm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Em(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2uiv(this.addr,t),ge(e,t)}}function Am(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3uiv(this.addr,t),ge(e,t)}}function Rm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4uiv(this.addr,t),ge(e,t)}}function Wa(i){return i.version===0&&(i.compareFunction=ll,i.needsUpdate=!0),i}function Cm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Wa(Hh):r=Gh,e.setTexture2D(t||r,s)}function _m(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Xh,s)}function Im(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Wa(Vh):r=qh,e.setTextureCube(t||r,s)}function Pm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Wh,s)}function Lm(i){switch(i){case 5126:return fm;case 35664:return pm;case 35665:return mm;case 35666:return gm;case 35674:return xm;case 35675:return vm;case 35676:return ym;case 5124:case 35670:return Mm;case 35667:case 35671:return Sm;case 35668:case 35672:return bm;case 35669:case 35673:return wm;case 5125:return Tm;case 36294:return Em;case 36295:return Am;case 36296:return Rm;case 35678:case 36198:case 36298:case 36306:case 35682:return Cm;case 35679:case 36299:case 36307:return _m;case 35680:case 36300:case 36308:case 36293:return Im;case 36289:case 36303:case 36311:case 36292:return Pm}}function Nm(i,t){i.uniform1fv(this.addr,t)}function Dm(i,t){let e=qi(t,this.size,2);i.uniform2fv(this.addr,e)}function Um(i,t){let e=qi(t,this.size,3);i.uniform3fv(this.addr,e)}function Fm(i,t){let e=qi(t,this.size,4);i.uniform4fv(this.addr,e)}function Om(i,t){let e=qi(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Bm(i,t){let e=qi(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function zm(i,t){let e=qi(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function km(i,t){i.uniform1iv(this.addr,t)}function Gm(i,t){i.uniform2iv(this.addr,t)}function Hm(i,t){i.uniform3iv(this.addr,t)}function Vm(i,t){i.uniform4iv(this.addr,t)}function Wm(i,t){i.uniform1uiv(this.addr,t)}function Xm(i,t){i.uniform2uiv(this.addr,t)}function qm(i,t){i.uniform3uiv(this.addr,t)}function Ym(i,t){i.uniform4uiv(this.addr,t)}function Zm(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Wa(Hh):a=Gh;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function Jm(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||Xh,r[a])}function Km(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Wa(Vh):a=qh;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function jm(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||Wh,r[a])}function Qm(i){switch(i){case 5126:return Nm;case 35664:return Dm;case 35665:return Um;case 35666:return Fm;case 35674:return Om;case 35675:return Bm;case 35676:return zm;case 5124:case 35670:return km;case 35667:case 35671:return Gm;case 35668:case 35672:return Hm;case 35669:case 35673:return Vm;case 5125:return Wm;case 36294:return Xm;case 36295:return qm;case 36296:return Ym;case 35678:case 36198:case 36298:case 36306:case 35682:return Zm;case 35679:case 36299:case 36307:return Jm;case 35680:case 36300:case 36308:case 36293:return Km;case 36289:case 36303:case 36311:case 36292:return jm}}var vl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Lm(e.type)}},yl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Qm(e.type)}},Ml=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],n)}}},gl=/(\w+)(\])?(\[|\.)?/g;function Eh(i,t){i.seq.push(t),i.map[t.id]=t}function $m(i,t,e){let n=i.name,s=n.length;for(gl.lastIndex=0;;){let r=gl.exec(n),a=gl.lastIndex,o=r[1],c=r[2]==="]",l=r[3];if(c&&(o=o|0),l===void 0||l==="["&&a+2===s){Eh(e,l===void 0?new vl(o,i,t):new yl(o,i,t));break}else{let f=e.map[o];f===void 0&&(f=new Ml(o),Eh(e,f)),e=f}}}var Xi=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=t.getActiveUniform(e,a),c=t.getUniformLocation(e,o.name);$m(o,c,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],c=n[o.id];c.needsUpdate!==!1&&o.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&n.push(a)}return n}};function Ah(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var tg=37297,eg=0;function ng(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}var Rh=new It;function ig(i){Ht._getMatrix(Rh,Ht.workingColorSpace,i);let t=`mat3( ${Rh.elements.map(e=>e.toFixed(4))} )`;switch(Ht.getTransfer(i)){case ss:return[t,"LinearTransferOETF"];case Yt:return[t,"sRGBTransferOETF"];default:return Rt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Ch(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+ng(i.getShaderSource(t),o)}else return r}function sg(i,t){let e=ig(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rg={[Xo]:"Linear",[qo]:"Reinhard",[Yo]:"Cineon",[Zo]:"ACESFilmic",[Ko]:"AgX",[jo]:"Neutral",[Jo]:"Custom"};function ag(i,t){let e=rg[t];return e===void 0?(Rt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ka=new U;function og(){Ht.getLuminanceCoefficients(ka);let i=ka.x.toFixed(4),t=ka.y.toFixed(4),e=ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lg(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fs).join(`
`)}function cg(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function hg(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function Fs(i){return i!==""}function _h(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Ih(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var ug=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sl(i){return i.replace(ug,dg)}function dg(i,t){let e=Bt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Sl(e)}var fg=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ph(i){return i.replace(fg,pg)}function pg(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Lh(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var mg={[As]:"SHADOWMAP_TYPE_PCF",[Gi]:"SHADOWMAP_TYPE_VSM"};function gg(i){return mg[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var xg={[Vi]:"ENVMAP_MODE_REFRACTION"};function vg(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":xg[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yg={[Qr]:"ENVMAP_BLENDING_MULTIPLY",[Jc]:"ENVMAP_BLENDING_MIX",[Kc]:"ENVMAP_BLENDING_ADD"};function Mg(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":yg[i.combine]||"ENVMAP_BLENDING_NONE"}function Sg(i,t,e,n){let s=i.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,c=gg(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=vg(e),f=Mg(e),d=lg(e),m=cg(r),g=s.createProgram(),M,p,u=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(M=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Fs).join(`
`),M.length>0&&(M+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Fs).join(`
`),p.length>0&&(p+=`
`)):(M=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fs).join(`
`),p=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==vn?"#define TONE_MAPPING":"",e.toneMapping!==vn?Bt.tonemapping_pars_fragment:"",e.toneMapping!==vn?ag("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Bt.colorspace_pars_fragment,sg("linearToOutputTexel",e.outputColorSpace),og(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fs).join(`
`)),a=Sl(a),a=_h(a,e),a=Ih(a,e),o=Sl(o),o=_h(o,e),o=Ih(o,e),a=Ph(a),o=Ph(o),e.isRawShaderMaterial!==!0&&(u=`#version 300 es
`,M=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,p=["#define varying in",e.glslVersion===cl?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===cl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=u+M+a,A=u+p+o,w=Ah(s,s.VERTEX_SHADER,S),R=Ah(s,s.FRAGMENT_SHADER,A);s.attachShader(g,w),s.attachShader(g,R),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(P){if(i.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(w)||"",V=s.getShaderInfoLog(R)||"",_=N.trim(),H=B.trim(),q=V.trim(),G=!0,et=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,w,R);else{let X=Ch(s,w,"vertex"),Q=Ch(s,R,"fragment");_t("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+_+`
`+X+`
`+Q)}else _!==""?Rt("WebGLProgram: Program Info Log:",_):(H===""||q==="")&&(et=!1);et&&(P.diagnostics={runnable:G,programLog:_,vertexShader:{log:H,prefix:M},fragmentShader:{log:q,prefix:p}})}s.deleteShader(w),s.deleteShader(R),x=new Xi(s,g),b=hg(s,g)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(g,tg)),D},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=eg++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=w,this.fragmentShader=R,this}var bg=0,bl=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new wl(t),e.set(t,n)),n}},wl=class{constructor(t){this.id=bg++,this.code=t,this.usedTimes=0}};function wg(i){return i===$n||i===Ls||i===Ns}function Tg(i,t,e,n,s,r){let a=new os,o=new bl,c=new Set,l=[],h=new Map,f=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,b,D,P,N,B){let V=P.fog,_=N.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?P.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=t.get(x.envMap||H,q),et=d[x.type],X=n.precision;x.precision!==null&&(X=n.getMaxPrecision(x.precision),X!==x.precision&&Rt("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let Q=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,$=Q!==void 0?Q.length:0,St=0;_.morphAttributes.position!==void 0&&(St=1),_.morphAttributes.normal!==void 0&&(St=2),_.morphAttributes.color!==void 0&&(St=3);let Lt,J,pt,vt;if(et){let dt=Mn[et];Lt=dt.vertexShader,J=dt.fragmentShader}else{Lt=x.vertexShader,J=x.fragmentShader;let dt=o.getVertexShaderStage(x),Jt=o.getFragmentShaderStage(x);o.update(x,dt,Jt),pt=dt.id,vt=Jt.id}let Et=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),Dt=N.isInstancedMesh===!0,le=N.isBatchedMesh===!0,Ct=!!x.map,Zt=!!x.matcap,Kt=!!G,zt=Kt&&G.isPMREMTexture===!0,be=!!x.aoMap,de=!!x.lightMap,Fe=!!x.bumpMap&&x.wireframe===!1,re=!!x.normalMap,un=!!x.displacementMap,xe=!!x.emissiveMap,qe=!!x.metalnessMap,Ye=!!x.roughnessMap,Ze=x.anisotropy>0,L=x.clearcoat>0,Je=x.diffuseRoughness>0,ne=x.dispersion>0,ie=x.retroreflectivity>0,ut=x.iridescence>0,fe=x.sheen>0,At=x.transmission>0,Pt=Ze&&!!x.anisotropyMap,T=L&&!!x.clearcoatMap,v=L&&!!x.clearcoatNormalMap,O=L&&!!x.clearcoatRoughnessMap,tt=Je&&!!x.diffuseRoughnessMap,j=ut&&!!x.iridescenceMap,st=ut&&!!x.iridescenceThicknessMap,ct=fe&&!!x.sheenColorMap,Y=fe&&!!x.sheenRoughnessMap,Z=!!x.specularMap,at=!!x.specularColorMap,C=!!x.specularIntensityMap,K=At&&!!x.transmissionMap,W=At&&!!x.thicknessMap,ot=!!x.gradientMap,it=!!x.alphaMap,rt=x.alphaTest>0,wt=!!x.alphaHash,Ot=!!x.extensions,nt=vn;x.toneMapped&&(Et===null||Et.isXRRenderTarget===!0)&&(nt=i.toneMapping);let Tt=zt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Ft={shaderID:et,shaderType:x.type,shaderName:x.name,vertexShader:Lt,fragmentShader:J,defines:x.defines,customVertexShaderID:pt,customFragmentShaderID:vt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:le,batchingColor:le&&N._colorsTexture!==null,instancing:Dt,instancingColor:Dt&&N.instanceColor!==null,instancingMorph:Dt&&N.morphTexture!==null,outputColorSpace:Et===null?i.outputColorSpace:Et.isXRRenderTarget===!0?Et.texture.colorSpace:Ht.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ct,matcap:Zt,envMap:Kt,envMapMode:Kt&&G.mapping,envMapPMREM:zt,envMapMaxLod:zt?Tt.length-1:null,envMapSize:zt?Tt[0].width:null,aoMap:be,lightMap:de,bumpMap:Fe,normalMap:re,displacementMap:un,emissiveMap:xe,normalMapObjectSpace:re&&x.normalMapType===$c,normalMapTangentSpace:re&&x.normalMapType===Ba,packedNormalMap:re&&x.normalMapType===Ba&&wg(x.normalMap.format),metalnessMap:qe,roughnessMap:Ye,anisotropy:Ze,anisotropyMap:Pt,clearcoat:L,clearcoatMap:T,clearcoatNormalMap:v,clearcoatRoughnessMap:O,diffuseRoughness:Je,diffuseRoughnessMap:tt,dispersion:ne,retroreflection:ie,iridescence:ut,iridescenceMap:j,iridescenceThicknessMap:st,sheen:fe,sheenColorMap:ct,sheenRoughnessMap:Y,specularMap:Z,specularColorMap:at,specularIntensityMap:C,transmission:At,transmissionMap:K,thicknessMap:W,gradientMap:ot,opaque:x.transparent===!1&&x.blending===Hi&&x.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:wt,combine:x.combine,mapUv:Ct&&m(x.map.channel),aoMapUv:be&&m(x.aoMap.channel),lightMapUv:de&&m(x.lightMap.channel),bumpMapUv:Fe&&m(x.bumpMap.channel),normalMapUv:re&&m(x.normalMap.channel),displacementMapUv:un&&m(x.displacementMap.channel),emissiveMapUv:xe&&m(x.emissiveMap.channel),metalnessMapUv:qe&&m(x.metalnessMap.channel),roughnessMapUv:Ye&&m(x.roughnessMap.channel),anisotropyMapUv:Pt&&m(x.anisotropyMap.channel),clearcoatMapUv:T&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:j&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:st&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:Y&&m(x.sheenRoughnessMap.channel),specularMapUv:Z&&m(x.specularMap.channel),specularColorMapUv:at&&m(x.specularColorMap.channel),specularIntensityMapUv:C&&m(x.specularIntensityMap.channel),transmissionMapUv:K&&m(x.transmissionMap.channel),thicknessMapUv:W&&m(x.thicknessMap.channel),alphaMapUv:it&&m(x.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(re||Ze),vertexNormals:!!_.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!_.attributes.uv&&(Ct||it),fog:!!V,useFog:x.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||_.attributes.normal===void 0&&re===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:mt,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:St,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(dt=>dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Ct&&x.map.isVideoTexture===!0&&Ht.getTransfer(x.map.colorSpace)===Yt,decodeVideoTextureEmissive:xe&&x.emissiveMap.isVideoTexture===!0&&Ht.getTransfer(x.emissiveMap.colorSpace)===Yt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===xn,flipSided:x.side===De,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ot&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ot&&x.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Ft.vertexUv1s=c.has(1),Ft.vertexUv2s=c.has(2),Ft.vertexUv3s=c.has(3),c.clear(),Ft}function M(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let D in x.defines)b.push(D),b.push(x.defines[D]);return x.isRawShaderMaterial===!1&&(p(b,x),u(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function p(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function u(x,b){a.disableAll(),b.instancing&&a.enable(0),b.instancingColor&&a.enable(1),b.instancingMorph&&a.enable(2),b.matcap&&a.enable(3),b.envMap&&a.enable(4),b.normalMapObjectSpace&&a.enable(5),b.normalMapTangentSpace&&a.enable(6),b.clearcoat&&a.enable(7),b.iridescence&&a.enable(8),b.alphaTest&&a.enable(9),b.vertexColors&&a.enable(10),b.vertexAlphas&&a.enable(11),b.vertexUv1s&&a.enable(12),b.vertexUv2s&&a.enable(13),b.vertexUv3s&&a.enable(14),b.vertexTangents&&a.enable(15),b.anisotropy&&a.enable(16),b.alphaHash&&a.enable(17),b.batching&&a.enable(18),b.dispersion&&a.enable(19),b.retroreflection&&a.enable(24),b.diffuseRoughness&&a.enable(25),b.batchingColor&&a.enable(20),b.gradientMap&&a.enable(21),b.packedNormalMap&&a.enable(22),b.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),b.numLightProbeGrids>0&&a.enable(22),b.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function S(x){let b=d[x.type],D;if(b){let P=Mn[b];D=fh.clone(P.uniforms)}else D=x.uniforms;return D}function A(x,b){let D=h.get(b);return D!==void 0?++D.usedTimes:(D=new Sg(i,b,x,s),l.push(D),h.set(b,D)),D}function w(x){if(--x.usedTimes===0){let b=l.indexOf(x);l[b]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function R(x){o.remove(x)}function E(){o.dispose()}return{getParameters:g,getProgramCacheKey:M,getUniforms:S,acquireProgram:A,releaseProgram:w,releaseShaderCache:R,programs:l,dispose:E}}function Eg(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,c){i.get(a)[o]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Ag(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Nh(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Dh(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function o(d,m,g,M,p,u){let S=i[t];return S===void 0?(S={id:d.id,object:d,geometry:m,material:g,materialVariant:a(d),groupOrder:M,renderOrder:d.renderOrder,z:p,group:u},i[t]=S):(S.id=d.id,S.object=d,S.geometry=m,S.material=g,S.materialVariant=a(d),S.groupOrder=M,S.renderOrder=d.renderOrder,S.z=p,S.group=u),t++,S}function c(d,m,g,M,p,u,S){S.reversedDepth===!0&&(p=-p);let A=o(d,m,g,M,p,u);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):e.push(A)}function l(d,m,g,M,p,u){let S=o(d,m,g,M,p,u);g.transmission>0?n.unshift(S):g.transparent===!0?s.unshift(S):e.unshift(S)}function h(d,m){e.length>1&&e.sort(d||Ag),n.length>1&&n.sort(m||Nh),s.length>1&&s.sort(m||Nh)}function f(){for(let d=t,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:f,sort:h}}function Rg(){let i=new WeakMap;function t(n,s){let r=i.get(n),a;return r===void 0?(a=new Dh,i.set(n,[a])):s>=r.length?(a=new Dh,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function Cg(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new U,color:new Ut};break;case"SpotLight":e={position:new U,direction:new U,color:new Ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new U,color:new Ut,distance:0,decay:0};break;case"HemisphereLight":e={direction:new U,skyColor:new Ut,groundColor:new Ut};break;case"RectAreaLight":e={color:new Ut,position:new U,halfWidth:new U,halfHeight:new U};break}return i[t.id]=e,e}}}function _g(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Ig=0;function Pg(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Lg(i){let t=new Cg,e=_g(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new U);let s=new U,r=new Qt,a=new Qt;function o(l){let h=0,f=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let m=0,g=0,M=0,p=0,u=0,S=0,A=0,w=0,R=0,E=0,x=0,b=0,D=0,P=0;l.sort(Pg);for(let B=0,V=l.length;B<V;B++){let _=l[B],H=_.color,q=_.intensity,G=_.distance,et=null;if(_.shadow&&_.shadow.map&&(_.shadow.map.texture.format===$n?et=_.shadow.map.texture:et=_.shadow.map.depthTexture||_.shadow.map.texture),_.isAmbientLight)h+=H.r*q,f+=H.g*q,d+=H.b*q;else if(_.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(_.sh.coefficients[X],q);P++}else if(_.isSunLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=$,n.sunShadowMap[g]=et;let St=Q.getViewportCount();for(let Lt=0;Lt<St;Lt++)n.sunShadowMatrix[M+Lt]=Q.getMatrix(Lt),n.sunShadowCascade[M+Lt]=Q._cascadeData[Lt];M+=St,g++}n.sun[m]=X,m++}else if(_.isDirectionalLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.directionalShadow[p]=$,n.directionalShadowMap[p]=et,n.directionalShadowMatrix[p]=_.shadow.matrix,R++}n.directional[p]=X,p++}else if(_.isSpotLight){let X=t.get(_);X.position.setFromMatrixPosition(_.matrixWorld),X.color.copy(H).multiplyScalar(q),X.distance=G,X.coneCos=Math.cos(_.angle),X.penumbraCos=Math.cos(_.angle*(1-_.penumbra)),X.decay=_.decay,n.spot[S]=X;let Q=_.shadow;if(_.map&&(n.spotLightMap[b]=_.map,b++,Q.updateMatrices(_),_.castShadow&&D++),n.spotLightMatrix[S]=Q.matrix,_.castShadow){let $=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.spotShadow[S]=$,n.spotShadowMap[S]=et,x++}S++}else if(_.isRectAreaLight){let X=t.get(_);X.color.copy(H).multiplyScalar(q),X.halfWidth.set(_.width*.5,0,0),X.halfHeight.set(0,_.height*.5,0),n.rectArea[A]=X,A++}else if(_.isPointLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),X.distance=_.distance,X.decay=_.decay,_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,$.shadowCameraNear=Q.camera.near,$.shadowCameraFar=Q.camera.far,n.pointShadow[u]=$,n.pointShadowMap[u]=et,n.pointShadowMatrix[u]=_.shadow.matrix,E++}n.point[u]=X,u++}else if(_.isHemisphereLight){let X=t.get(_);X.skyColor.copy(_.color).multiplyScalar(q),X.groundColor.copy(_.groundColor).multiplyScalar(q),n.hemi[w]=X,w++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=d;let N=n.hash;(N.sunLength!==m||N.directionalLength!==p||N.pointLength!==u||N.spotLength!==S||N.rectAreaLength!==A||N.hemiLength!==w||N.numSunShadows!==g||N.numDirectionalShadows!==R||N.numPointShadows!==E||N.numSpotShadows!==x||N.numSpotMaps!==b||N.numLightProbes!==P)&&(n.sun.length=m,n.directional.length=p,n.spot.length=S,n.rectArea.length=A,n.point.length=u,n.hemi.length=w,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=M,n.sunShadowCascade.length=M,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-D,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=P,N.sunLength=m,N.directionalLength=p,N.pointLength=u,N.spotLength=S,N.rectAreaLength=A,N.hemiLength=w,N.numSunShadows=g,N.numDirectionalShadows=R,N.numPointShadows=E,N.numSpotShadows=x,N.numSpotMaps=b,N.numLightProbes=P,n.version=Ig++)}function c(l,h){let f=0,d=0,m=0,g=0,M=0,p=0,u=h.matrixWorldInverse;for(let S=0,A=l.length;S<A;S++){let w=l[S];if(w.isSunLight){let R=n.sun[f];R.direction.setFromMatrixPosition(w.matrixWorld),R.direction.transformDirection(u),f++}else if(w.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(u),d++}else if(w.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(u),R.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(u),g++}else if(w.isRectAreaLight){let R=n.rectArea[M];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(u),a.identity(),r.copy(w.matrixWorld),r.premultiply(u),a.extractRotation(r),R.halfWidth.set(w.width*.5,0,0),R.halfHeight.set(0,w.height*.5,0),R.halfWidth.applyMatrix4(a),R.halfHeight.applyMatrix4(a),M++}else if(w.isPointLight){let R=n.point[m];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(u),m++}else if(w.isHemisphereLight){let R=n.hemi[p];R.direction.setFromMatrixPosition(w.matrixWorld),R.direction.transformDirection(u),p++}}}return{setup:o,setupView:c,state:n}}function Uh(i){let t=new Lg(i),e=[],n=[],s=[];function r(f){h.camera=f,e.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):e.push(f)}function o(f){n.push(f)}function c(){t.setup(e),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function l(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:a,pushShadow:o}}function Ng(i){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new Uh(i),t.set(s,[o])):r>=a.length?(o=new Uh(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}var Dg=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Ug=`uniform sampler2D shadow_pass;
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
}`,Fg=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],Og=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],Fh=new Qt,Us=new U,xl=new U;function Bg(i,t,e){let n=new Yn,s=new Vt,r=new Vt,a=new se,o=new Br,c=new zr,l={},h=e.maxTextureSize,f={[Qn]:De,[De]:Qn,[xn]:xn},d=new gn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Vt},radius:{value:4}},vertexShader:Dg,fragmentShader:Ug}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new _e;g.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new pe(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=As;let u=this.type;this.render=function(E,x,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===Ic&&(Rt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=As);let D=i.getRenderTarget(),P=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ui),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=u!==this.type;V&&x.traverse(function(_){_.material&&(Array.isArray(_.material)?_.material.forEach(H=>H.needsUpdate=!0):_.material.needsUpdate=!0)});for(let _=0,H=E.length;_<H;_++){let q=E[_],G=q.shadow;if(G===void 0){Rt("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let et=G.getFrameExtents();s.multiply(et),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,G.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Gi){if(q.isPointLight){Rt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Ve(s.x,s.y,{format:$n,type:ln,minFilter:Ne,magFilter:Ne,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new Ln(s.x,s.y,on),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=_n,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Se,G.map.depthTexture.magFilter=Se}else q.isPointLight?(G.map=new Os(s.x),G.map.depthTexture=new fs(s.x,an)):(G.map=new Ve(s.x,s.y),G.map.depthTexture=new Ln(s.x,s.y,an)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=_n,this.type===As?(G.map.depthTexture.compareFunction=X?ol:al,G.map.depthTexture.minFilter=Ne,G.map.depthTexture.magFilter=Ne):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Se,G.map.depthTexture.magFilter=Se);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,b);let $=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:b.layers;for(let St=0;St<Q;St++){let Lt=G.getCamera(St);if(q.isPointLight){let J=G.camera,pt=G.matrix,vt=q.distance||J.far;vt!==J.far&&(J.far=vt,J.updateProjectionMatrix()),Us.setFromMatrixPosition(q.matrixWorld),J.position.copy(Us),xl.copy(J.position),xl.add(Fg[St]),J.up.copy(Og[St]),J.lookAt(xl),J.updateMatrixWorld(),pt.makeTranslation(-Us.x,-Us.y,-Us.z),Fh.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Fh,J.coordinateSystem,J.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,St),i.clear();else{St===0&&(i.setRenderTarget(G.map),i.clear());let J=G.getViewport(St);a.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),B.viewport(a)}n=G.getFrustum(St),w(x,b,Lt,q,$,this.type)}G.isPointLightShadow!==!0&&this.type===Gi&&S(G,b),G.needsUpdate=!1}u=this.type,p.needsUpdate=!1,i.setRenderTarget(D,P,N)};function S(E,x){let b=t.update(M);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null?E.mapPass=new Ve(s.x,s.y,{format:$n,type:ln}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,d,M,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value.set(E.map.width,E.map.height),m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,m,M,null)}function A(E,x,b,D){let P=null,N=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(N!==void 0)P=N;else if(P=b.isPointLight===!0?c:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=P.uuid,V=x.uuid,_=l[B];_===void 0&&(_={},l[B]=_);let H=_[V];H===void 0&&(H=P.clone(),_[V]=H,x.addEventListener("dispose",R)),P=H}if(P.visible=x.visible,P.wireframe=x.wireframe,D===Gi?P.side=x.shadowSide!==null?x.shadowSide:x.side:P.side=x.shadowSide!==null?x.shadowSide:f[x.side],P.alphaMap=x.alphaMap,P.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,P.map=x.map,P.clipShadows=x.clipShadows,P.clippingPlanes=x.clippingPlanes,P.clipIntersection=x.clipIntersection,P.displacementMap=x.displacementMap,P.displacementScale=x.displacementScale,P.displacementBias=x.displacementBias,P.wireframeLinewidth=x.wireframeLinewidth,P.linewidth=x.linewidth,b.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let B=i.properties.get(P);B.light=b}return P}function w(E,x,b,D,P,N){if(E.visible===!1)return;if(E.layers.test(P)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&N===Gi)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let _=t.update(E),H=E.material;if(Array.isArray(H)){let q=_.groups;for(let G=0,et=q.length;G<et;G++){let X=q[G],Q=H[X.materialIndex];if(Q&&Q.visible){let $=A(E,Q,D,N);E.onBeforeShadow(i,E,x,b,_,$,X),i.renderBufferDirect(b,null,_,$,E,X),E.onAfterShadow(i,E,x,b,_,$,X)}}}else if(H.visible){let q=A(E,H,D,N);E.onBeforeShadow(i,E,x,b,_,q,null),i.renderBufferDirect(b,null,_,q,E,null),E.onAfterShadow(i,E,x,b,_,q,null)}}let V=E.children;for(let _=0,H=V.length;_<H;_++)w(V[_],x,b,D,P,N)}function R(E){E.target.removeEventListener("dispose",R);for(let b in l){let D=l[b],P=E.target.uuid;P in D&&(D[P].dispose(),delete D[P])}}}function zg(i,t){function e(){let C=!1,K=new se,W=null,ot=new se(0,0,0,0);return{setMask:function(it){W!==it&&!C&&(i.colorMask(it,it,it,it),W=it)},setLocked:function(it){C=it},setClear:function(it,rt,wt,Ot,nt){nt===!0&&(it*=Ot,rt*=Ot,wt*=Ot),K.set(it,rt,wt,Ot),ot.equals(K)===!1&&(i.clearColor(it,rt,wt,Ot),ot.copy(K))},reset:function(){C=!1,W=null,ot.set(-1,0,0,0)}}}function n(){let C=!1,K=!1,W=null,ot=null,it=null;return{setReversed:function(rt){if(K!==rt){let wt=t.get("EXT_clip_control");rt?wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.ZERO_TO_ONE_EXT):wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.NEGATIVE_ONE_TO_ONE_EXT),K=rt;let Ot=it;it=null,this.setClear(Ot)}},getReversed:function(){return K},setTest:function(rt){rt?mt(i.DEPTH_TEST):Dt(i.DEPTH_TEST)},setMask:function(rt){W!==rt&&!C&&(i.depthMask(rt),W=rt)},setFunc:function(rt){if(K&&(rt=hh[rt]),ot!==rt){switch(rt){case yr:i.depthFunc(i.NEVER);break;case Mr:i.depthFunc(i.ALWAYS);break;case Sr:i.depthFunc(i.LESS);break;case Pi:i.depthFunc(i.LEQUAL);break;case br:i.depthFunc(i.EQUAL);break;case wr:i.depthFunc(i.GEQUAL);break;case Tr:i.depthFunc(i.GREATER);break;case Er:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ot=rt}},setLocked:function(rt){C=rt},setClear:function(rt){it!==rt&&(it=rt,K&&(rt=1-rt),i.clearDepth(rt))},reset:function(){C=!1,W=null,ot=null,it=null,K=!1}}}function s(){let C=!1,K=null,W=null,ot=null,it=null,rt=null,wt=null,Ot=null,nt=null;return{setTest:function(Tt){C||(Tt?mt(i.STENCIL_TEST):Dt(i.STENCIL_TEST))},setMask:function(Tt){K!==Tt&&!C&&(i.stencilMask(Tt),K=Tt)},setFunc:function(Tt,Ft,dt){(W!==Tt||ot!==Ft||it!==dt)&&(i.stencilFunc(Tt,Ft,dt),W=Tt,ot=Ft,it=dt)},setOp:function(Tt,Ft,dt){(rt!==Tt||wt!==Ft||Ot!==dt)&&(i.stencilOp(Tt,Ft,dt),rt=Tt,wt=Ft,Ot=dt)},setLocked:function(Tt){C=Tt},setClear:function(Tt){nt!==Tt&&(i.clearStencil(Tt),nt=Tt)},reset:function(){C=!1,K=null,W=null,ot=null,it=null,rt=null,wt=null,Ot=null,nt=null}}}let r=new e,a=new n,o=new s,c={},l=new WeakMap,h={},f={},d={},m=new WeakMap,g=[],M=null,p=!1,u=null,S=null,A=null,w=null,R=null,E=null,x=null,b=new Ut(0,0,0),D=0,P=!1,N=null,B=null,V=null,_=null,H=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,et=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=et>=1):X.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=et>=2);let Q=null,$={},St=i.getParameter(i.SCISSOR_BOX),Lt=i.getParameter(i.VIEWPORT),J=new se().fromArray(St),pt=new se().fromArray(Lt);function vt(C,K,W,ot){let it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(C,rt),i.texParameteri(C,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(C,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let wt=0;wt<W;wt++)C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,ot,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+wt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}let Et={};Et[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Et[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Et[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Et[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),mt(i.DEPTH_TEST),a.setFunc(Pi),Fe(!1),re(zo),mt(i.CULL_FACE),be(ui);function mt(C){h[C]!==!0&&(i.enable(C),h[C]=!0)}function Dt(C){h[C]!==!1&&(i.disable(C),h[C]=!1)}function le(C,K){return d[C]!==K?(i.bindFramebuffer(C,K),d[C]=K,C===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),C===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Ct(C,K){let W=g,ot=!1;if(C){W=m.get(K),W===void 0&&(W=[],m.set(K,W));let it=C.textures;if(W.length!==it.length||W[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,wt=it.length;rt<wt;rt++)W[rt]=i.COLOR_ATTACHMENT0+rt;W.length=it.length,ot=!0}}else W[0]!==i.BACK&&(W[0]=i.BACK,ot=!0);ot&&i.drawBuffers(W)}function Zt(C){return M!==C?(i.useProgram(C),M=C,!0):!1}let Kt={[di]:i.FUNC_ADD,[Lc]:i.FUNC_SUBTRACT,[Nc]:i.FUNC_REVERSE_SUBTRACT};Kt[Dc]=i.MIN,Kt[Uc]=i.MAX;let zt={[Fc]:i.ZERO,[Oc]:i.ONE,[Bc]:i.SRC_COLOR,[Vo]:i.SRC_ALPHA,[Wc]:i.SRC_ALPHA_SATURATE,[Hc]:i.DST_COLOR,[kc]:i.DST_ALPHA,[zc]:i.ONE_MINUS_SRC_COLOR,[Wo]:i.ONE_MINUS_SRC_ALPHA,[Vc]:i.ONE_MINUS_DST_COLOR,[Gc]:i.ONE_MINUS_DST_ALPHA,[Xc]:i.CONSTANT_COLOR,[qc]:i.ONE_MINUS_CONSTANT_COLOR,[Yc]:i.CONSTANT_ALPHA,[Zc]:i.ONE_MINUS_CONSTANT_ALPHA};function be(C,K,W,ot,it,rt,wt,Ot,nt,Tt){if(C===ui){p===!0&&(Dt(i.BLEND),p=!1);return}if(p===!1&&(mt(i.BLEND),p=!0),C!==Pc){if(C!==u||Tt!==P){if((S!==di||R!==di)&&(i.blendEquation(i.FUNC_ADD),S=di,R=di),Tt)switch(C){case Hi:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFunc(i.ONE,i.ONE);break;case Go:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ho:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:_t("WebGLState: Invalid blending: ",C);break}else switch(C){case Hi:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Go:_t("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ho:_t("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:_t("WebGLState: Invalid blending: ",C);break}A=null,w=null,E=null,x=null,b.set(0,0,0),D=0,u=C,P=Tt}return}it=it||K,rt=rt||W,wt=wt||ot,(K!==S||it!==R)&&(i.blendEquationSeparate(Kt[K],Kt[it]),S=K,R=it),(W!==A||ot!==w||rt!==E||wt!==x)&&(i.blendFuncSeparate(zt[W],zt[ot],zt[rt],zt[wt]),A=W,w=ot,E=rt,x=wt),(Ot.equals(b)===!1||nt!==D)&&(i.blendColor(Ot.r,Ot.g,Ot.b,nt),b.copy(Ot),D=nt),u=C,P=!1}function de(C,K){C.side===xn?Dt(i.CULL_FACE):mt(i.CULL_FACE);let W=C.side===De;K&&(W=!W),Fe(W),C.blending===Hi&&C.transparent===!1?be(ui):be(C.blending,C.blendEquation,C.blendSrc,C.blendDst,C.blendEquationAlpha,C.blendSrcAlpha,C.blendDstAlpha,C.blendColor,C.blendAlpha,C.premultipliedAlpha),a.setFunc(C.depthFunc),a.setTest(C.depthTest),a.setMask(C.depthWrite),r.setMask(C.colorWrite);let ot=C.stencilWrite;o.setTest(ot),ot&&(o.setMask(C.stencilWriteMask),o.setFunc(C.stencilFunc,C.stencilRef,C.stencilFuncMask),o.setOp(C.stencilFail,C.stencilZFail,C.stencilZPass)),xe(C.polygonOffset,C.polygonOffsetFactor,C.polygonOffsetUnits),C.alphaToCoverage===!0?mt(i.SAMPLE_ALPHA_TO_COVERAGE):Dt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Fe(C){N!==C&&(C?i.frontFace(i.CW):i.frontFace(i.CCW),N=C)}function re(C){C!==Cc?(mt(i.CULL_FACE),C!==B&&(C===zo?i.cullFace(i.BACK):C===_c?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Dt(i.CULL_FACE),B=C}function un(C){C!==V&&(G&&i.lineWidth(C),V=C)}function xe(C,K,W){C?(mt(i.POLYGON_OFFSET_FILL),(_!==K||H!==W)&&(_=K,H=W,a.getReversed()&&(K=-K,W=-W),i.polygonOffset(K,W))):Dt(i.POLYGON_OFFSET_FILL)}function qe(C){C?mt(i.SCISSOR_TEST):Dt(i.SCISSOR_TEST)}function Ye(C){C===void 0&&(C=i.TEXTURE0+q-1),Q!==C&&(i.activeTexture(C),Q=C)}function Ze(C,K,W){W===void 0&&(Q===null?W=i.TEXTURE0+q-1:W=Q);let ot=$[W];ot===void 0&&(ot={type:void 0,texture:void 0},$[W]=ot),(ot.type!==C||ot.texture!==K)&&(Q!==W&&(i.activeTexture(W),Q=W),i.bindTexture(C,K||Et[C]),ot.type=C,ot.texture=K)}function L(){let C=$[Q];C!==void 0&&C.type!==void 0&&(i.bindTexture(C.type,null),C.type=void 0,C.texture=void 0)}function Je(){try{i.compressedTexImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function ne(){try{i.compressedTexImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function ie(){try{i.texSubImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function ut(){try{i.texSubImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function fe(){try{i.compressedTexSubImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function At(){try{i.compressedTexSubImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function Pt(){try{i.texStorage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function T(){try{i.texStorage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function v(){try{i.texImage2D(...arguments)}catch(C){_t("WebGLState:",C)}}function O(){try{i.texImage3D(...arguments)}catch(C){_t("WebGLState:",C)}}function tt(C){return f[C]!==void 0?f[C]:i.getParameter(C)}function j(C,K){f[C]!==K&&(i.pixelStorei(C,K),f[C]=K)}function st(C){J.equals(C)===!1&&(i.scissor(C.x,C.y,C.z,C.w),J.copy(C))}function ct(C){pt.equals(C)===!1&&(i.viewport(C.x,C.y,C.z,C.w),pt.copy(C))}function Y(C,K){let W=l.get(K);W===void 0&&(W=new WeakMap,l.set(K,W));let ot=W.get(C);ot===void 0&&(ot=i.getUniformBlockIndex(K,C.name),i.uniformBlockBinding(K,ot,ot),W.set(C,ot))}function Z(C,K,W){let it=l.get(K).get(C);c[it]!==W&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,W),c[it]=W)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,$={},d={},c={},m=new WeakMap,g=[],M=null,p=!1,u=null,S=null,A=null,w=null,R=null,E=null,x=null,b=new Ut(0,0,0),D=0,P=!1,N=null,B=null,V=null,_=null,H=null,J.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:mt,disable:Dt,bindFramebuffer:le,drawBuffers:Ct,useProgram:Zt,setBlending:be,setMaterial:de,setFlipSided:Fe,setCullFace:re,setLineWidth:un,setPolygonOffset:xe,setScissorTest:qe,activeTexture:Ye,bindTexture:Ze,unbindTexture:L,compressedTexImage2D:Je,compressedTexImage3D:ne,texImage2D:v,texImage3D:O,pixelStorei:j,getParameter:tt,updateUBOMapping:Y,uniformBlockBinding:Z,texStorage2D:Pt,texStorage3D:T,texSubImage2D:ie,texSubImage3D:ut,compressedTexSubImage2D:fe,compressedTexSubImage3D:At,scissor:st,viewport:ct,reset:at}}function kg(i,t,e,n,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Vt,h=new WeakMap,f=new Set,d,m=new WeakMap,g=new Set,M=new FinalizationRegistry(T=>g.delete(T)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function u(T,v){return p?new OffscreenCanvas(T,v):rs("canvas")}function S(T,v,O){let tt=1,j=Pt(T);if((j.width>O||j.height>O)&&(tt=O/Math.max(j.width,j.height)),tt<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let st=Math.floor(tt*j.width),ct=Math.floor(tt*j.height);d===void 0&&(d=u(st,ct));let Y=v?u(st,ct):d;return Y.width=st,Y.height=ct,Y.getContext("2d").drawImage(T,0,0,st,ct),Rt("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+st+"x"+ct+")."),Y}else return"data"in T&&Rt("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),T;return T}function A(T){return T.generateMipmaps}function w(T){i.generateMipmap(T)}function R(T){return T.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?i.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(T,v,O,tt,j,st=!1){if(T!==null){if(i[T]!==void 0)return i[T];Rt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||Rt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=v;if(v===i.RED&&(O===i.FLOAT&&(Y=i.R32F),O===i.HALF_FLOAT&&(Y=i.R16F),O===i.UNSIGNED_BYTE&&(Y=i.R8),O===i.UNSIGNED_SHORT&&ct&&(Y=ct.R16_EXT),O===i.SHORT&&ct&&(Y=ct.R16_SNORM_EXT)),v===i.RED_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.R8UI),O===i.UNSIGNED_SHORT&&(Y=i.R16UI),O===i.UNSIGNED_INT&&(Y=i.R32UI),O===i.BYTE&&(Y=i.R8I),O===i.SHORT&&(Y=i.R16I),O===i.INT&&(Y=i.R32I)),v===i.RG&&(O===i.FLOAT&&(Y=i.RG32F),O===i.HALF_FLOAT&&(Y=i.RG16F),O===i.UNSIGNED_BYTE&&(Y=i.RG8),O===i.UNSIGNED_SHORT&&ct&&(Y=ct.RG16_EXT),O===i.SHORT&&ct&&(Y=ct.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.RG8UI),O===i.UNSIGNED_SHORT&&(Y=i.RG16UI),O===i.UNSIGNED_INT&&(Y=i.RG32UI),O===i.BYTE&&(Y=i.RG8I),O===i.SHORT&&(Y=i.RG16I),O===i.INT&&(Y=i.RG32I)),v===i.RGB_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.RGB8UI),O===i.UNSIGNED_SHORT&&(Y=i.RGB16UI),O===i.UNSIGNED_INT&&(Y=i.RGB32UI),O===i.BYTE&&(Y=i.RGB8I),O===i.SHORT&&(Y=i.RGB16I),O===i.INT&&(Y=i.RGB32I)),v===i.RGBA_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.RGBA8UI),O===i.UNSIGNED_SHORT&&(Y=i.RGBA16UI),O===i.UNSIGNED_INT&&(Y=i.RGBA32UI),O===i.BYTE&&(Y=i.RGBA8I),O===i.SHORT&&(Y=i.RGBA16I),O===i.INT&&(Y=i.RGBA32I)),v===i.RGB&&(O===i.UNSIGNED_SHORT&&ct&&(Y=ct.RGB16_EXT),O===i.SHORT&&ct&&(Y=ct.RGB16_SNORM_EXT),O===i.UNSIGNED_INT_5_9_9_9_REV&&(Y=i.RGB9_E5),O===i.UNSIGNED_INT_10F_11F_11F_REV&&(Y=i.R11F_G11F_B10F)),v===i.RGBA){let Z=st?ss:Ht.getTransfer(j);O===i.FLOAT&&(Y=i.RGBA32F),O===i.HALF_FLOAT&&(Y=i.RGBA16F),O===i.UNSIGNED_BYTE&&(Y=Z===Yt?i.SRGB8_ALPHA8:i.RGBA8),O===i.UNSIGNED_SHORT&&ct&&(Y=ct.RGBA16_EXT),O===i.SHORT&&ct&&(Y=ct.RGBA16_SNORM_EXT),O===i.UNSIGNED_SHORT_4_4_4_4&&(Y=i.RGBA4),O===i.UNSIGNED_SHORT_5_5_5_1&&(Y=i.RGB5_A1)}return(Y===i.R16F||Y===i.R32F||Y===i.RG16F||Y===i.RG32F||Y===i.RGBA16F||Y===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function x(T,v){let O;return T?v===null||v===an||v===pi?O=i.DEPTH24_STENCIL8:v===on?O=i.DEPTH32F_STENCIL8:v===Wi&&(O=i.DEPTH24_STENCIL8,Rt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===an||v===pi?O=i.DEPTH_COMPONENT24:v===on?O=i.DEPTH_COMPONENT32F:v===Wi&&(O=i.DEPTH_COMPONENT16),O}function b(T,v){return A(T)===!0||T.isFramebufferTexture&&T.minFilter!==Se&&T.minFilter!==Ne?Math.log2(Math.max(v.width,v.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?v.mipmaps.length:1}function D(T){let v=new WeakRef(T);n.get(T).__ref=v,g.add(v),M.register(T,v,v)}function P(T){let v=n.get(T).__ref;v!==void 0&&(g.delete(v),M.unregister(v))}function N(T){V(T.target)}function B(T){_(T.target)}function V(T){T.removeEventListener("dispose",N),P(T),q(T),T.isVideoTexture&&h.delete(T),T.isHTMLTexture&&f.delete(T)}function _(T){T.removeEventListener("dispose",B),P(T),et(T)}function H(){for(let T of g){let v=T.deref();v!==void 0&&(v.isRenderTarget===!0?_(v):V(v))}g.clear(),f.clear()}function q(T){let v=n.get(T);if(v.__webglInit===void 0)return;let O=T.source,tt=m.get(O);if(tt){let j=tt[v.__cacheKey];j.usedTimes--,j.usedTimes===0&&G(T),Object.keys(tt).length===0&&m.delete(O)}n.remove(T)}function G(T){let v=n.get(T);i.deleteTexture(v.__webglTexture);let O=T.source,tt=m.get(O);delete tt[v.__cacheKey],a.memory.textures--}function et(T){let v=n.get(T);v.__depthDisposeCallback&&v.__depthDisposeCallback();let O=T.depthTexture;if(O&&O.renderTarget===T&&V(O),T.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(v.__webglFramebuffer[j]))for(let st=0;st<v.__webglFramebuffer[j].length;st++)i.deleteFramebuffer(v.__webglFramebuffer[j][st]);else i.deleteFramebuffer(v.__webglFramebuffer[j]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[j])}else{if(Array.isArray(v.__webglFramebuffer))for(let j=0;j<v.__webglFramebuffer.length;j++)i.deleteFramebuffer(v.__webglFramebuffer[j]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let j=0;j<v.__webglColorRenderbuffer.length;j++)v.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[j]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let tt=T.textures;for(let j=0,st=tt.length;j<st;j++){let ct=n.get(tt[j]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),a.memory.textures--),n.remove(tt[j])}n.remove(T)}let X=0;function Q(){X=0}function $(){return X}function St(T){X=T}function Lt(){let T=X;return T>=s.maxTextures&&Rt("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,T}function J(T){let v=[];return v.push(T.wrapS),v.push(T.wrapT),v.push(T.wrapR||0),v.push(T.magFilter),v.push(T.minFilter),v.push(T.anisotropy),v.push(T.internalFormat),v.push(T.format),v.push(T.type),v.push(T.generateMipmaps),v.push(T.mipmapsAutoUpdate),v.push(T.premultiplyAlpha),v.push(T.flipY),v.push(T.unpackAlignment),v.push(T.colorSpace),v.join()}function pt(T,v){let O=n.get(T);if(T.isVideoTexture&&fe(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&O.__version!==T.version){let tt=T.image;if(tt===null)Rt("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)Rt("WebGLRenderer: Texture marked for update but image is incomplete");else{de(O,T,v);return}}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,O.__webglTexture,i.TEXTURE0+v)}function vt(T,v){let O=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){de(O,T,v);return}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,O.__webglTexture,i.TEXTURE0+v)}function Et(T,v){let O=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){de(O,T,v);return}e.bindTexture(i.TEXTURE_3D,O.__webglTexture,i.TEXTURE0+v)}function mt(T,v){let O=n.get(T);if(T.version>0&&O.__version!==T.version){Fe(O,T,v);return}e.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+v)}let Dt={[Ar]:i.REPEAT,[fn]:i.CLAMP_TO_EDGE,[Rr]:i.MIRRORED_REPEAT},le={[Se]:i.NEAREST,[jc]:i.NEAREST_MIPMAP_NEAREST,[Rs]:i.NEAREST_MIPMAP_LINEAR,[Ne]:i.LINEAR,[ea]:i.LINEAR_MIPMAP_NEAREST,[Dn]:i.LINEAR_MIPMAP_LINEAR},Ct={[eh]:i.NEVER,[ll]:i.ALWAYS,[nh]:i.LESS,[al]:i.LEQUAL,[ih]:i.EQUAL,[ol]:i.GEQUAL,[sh]:i.GREATER,[rh]:i.NOTEQUAL};function Zt(T,v){if(v.type===on&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===Ne||v.magFilter===ea||v.magFilter===Rs||v.magFilter===Dn||v.minFilter===Ne||v.minFilter===ea||v.minFilter===Rs||v.minFilter===Dn)&&Rt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(T,i.TEXTURE_WRAP_S,Dt[v.wrapS]),i.texParameteri(T,i.TEXTURE_WRAP_T,Dt[v.wrapT]),(T===i.TEXTURE_3D||T===i.TEXTURE_2D_ARRAY)&&i.texParameteri(T,i.TEXTURE_WRAP_R,Dt[v.wrapR]),i.texParameteri(T,i.TEXTURE_MAG_FILTER,le[v.magFilter]),i.texParameteri(T,i.TEXTURE_MIN_FILTER,le[v.minFilter]),v.compareFunction&&(i.texParameteri(T,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(T,i.TEXTURE_COMPARE_FUNC,Ct[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Se||v.minFilter!==Rs&&v.minFilter!==Dn||v.type===on&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");i.texParameterf(T,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function Kt(T,v){let O=!1;T.__webglInit===void 0&&(T.__webglInit=!0,v.addEventListener("dispose",N),D(v));let tt=v.source,j=m.get(tt);j===void 0&&(j={},m.set(tt,j));let st=J(v);if(st!==T.__cacheKey){j[st]===void 0&&(j[st]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,O=!0),j[st].usedTimes++;let ct=j[T.__cacheKey];ct!==void 0&&(j[T.__cacheKey].usedTimes--,ct.usedTimes===0&&G(v)),T.__cacheKey=st,T.__webglTexture=j[st].texture}return O}function zt(T,v,O){return Math.floor(Math.floor(T/O)/v)}function be(T,v,O,tt){let st=T.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,O,tt,v.data);else{st.sort((C,K)=>C.start-K.start);let ct=0;for(let C=1;C<st.length;C++){let K=st[ct],W=st[C],ot=K.start+K.count,it=zt(W.start,v.width,4),rt=zt(K.start,v.width,4);W.start<=ot+1&&it===rt&&zt(W.start+W.count-1,v.width,4)===it?K.count=Math.max(K.count,W.start+W.count-K.start):(++ct,st[ct]=W)}st.length=ct+1;let Y=e.getParameter(i.UNPACK_ROW_LENGTH),Z=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let C=0,K=st.length;C<K;C++){let W=st[C],ot=Math.floor(W.start/4),it=Math.ceil(W.count/4),rt=ot%v.width,wt=Math.floor(ot/v.width),Ot=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,wt),e.texSubImage2D(i.TEXTURE_2D,0,rt,wt,Ot,nt,O,tt,v.data)}T.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Y),e.pixelStorei(i.UNPACK_SKIP_PIXELS,Z),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function de(T,v,O){let tt=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(tt=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(tt=i.TEXTURE_3D);let j=Kt(T,v),st=v.source;e.bindTexture(tt,T.__webglTexture,i.TEXTURE0+O);let ct=n.get(st);if(st.version!==ct.__version||j===!0){if(e.activeTexture(i.TEXTURE0+O),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let nt=Ht.getPrimaries(Ht.workingColorSpace),Tt=v.colorSpace===Fn?null:Ht.getPrimaries(v.colorSpace),Ft=v.colorSpace===Fn||nt===Tt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ft)}e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let Z=S(v.image,!1,s.maxTextureSize);Z=At(v,Z);let at=r.convert(v.format,v.colorSpace),C=r.convert(v.type),K=E(v.internalFormat,at,C,v.normalized,v.colorSpace,v.isVideoTexture);Zt(tt,v);let W,ot=v.mipmaps,it=v.isVideoTexture!==!0,rt=ct.__version===void 0||j===!0,wt=st.dataReady,Ot=b(v,Z);if(v.isDepthTexture)K=x(v.format===Un,v.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,Z.width,Z.height):e.texImage2D(i.TEXTURE_2D,0,K,Z.width,Z.height,0,at,C,null));else if(v.isDataTexture)if(ot.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,C,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,C,W.data);v.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,Z.width,Z.height),wt&&be(v,Z,at,C)):e.texImage2D(i.TEXTURE_2D,0,K,Z.width,Z.height,0,at,C,Z.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,ot[0].width,ot[0].height,Z.depth);for(let nt=0,Tt=ot.length;nt<Tt;nt++)if(W=ot[nt],v.format!==cn)if(at!==null)if(it){if(wt)if(v.layerUpdates.size>0){let Ft=ml(W.width,W.height,v.format,v.type);for(let dt of v.layerUpdates){let Jt=W.data.subarray(dt*Ft/W.data.BYTES_PER_ELEMENT,(dt+1)*Ft/W.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,dt,W.width,W.height,1,at,Jt)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Z.depth,at,W.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Z.depth,0,W.data,0,0);else Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Z.depth,at,C,W.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Z.depth,0,at,C,W.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],v.format!==cn?at!==null?it?wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,W.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,W.data):Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,C,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,C,W.data)}else if(v.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,Z.width,Z.height,Z.depth),wt)if(v.layerUpdates.size>0){let nt=ml(Z.width,Z.height,v.format,v.type);for(let Tt of v.layerUpdates){let Ft=Z.data.subarray(Tt*nt/Z.data.BYTES_PER_ELEMENT,(Tt+1)*nt/Z.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Tt,Z.width,Z.height,1,at,C,Ft)}v.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,at,C,Z.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,Z.width,Z.height,Z.depth,0,at,C,Z.data);else if(v.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Ot,K,Z.width,Z.height,Z.depth),wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,at,C,Z.data)):e.texImage3D(i.TEXTURE_3D,0,K,Z.width,Z.height,Z.depth,0,at,C,Z.data);else if(v.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Ot,K,Z.width,Z.height);else{let nt=Z.width,Tt=Z.height;for(let Ft=0;Ft<Ot;Ft++)e.texImage2D(i.TEXTURE_2D,Ft,K,nt,Tt,0,at,C,null),nt>>=1,Tt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){let nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),Z.parentNode!==nt){nt.appendChild(Z),f.add(v),nt.onpaint=Tt=>{let Ft=Tt.changedElements;for(let dt of f)Ft.includes(dt.image)&&(dt.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Z);else{let Ft=i.RGBA,dt=i.RGBA,Jt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ft,dt,Jt,Z)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ot.length>0){if(it&&rt){let nt=Pt(ot[0]);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,at,C,W):e.texImage2D(i.TEXTURE_2D,nt,K,at,C,W);v.generateMipmaps=!1}else if(it){if(rt){let nt=Pt(Z);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,C,Z)}else e.texImage2D(i.TEXTURE_2D,0,K,at,C,Z);A(v)&&v.mipmapsAutoUpdate===!0&&w(tt),ct.__version=st.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function Fe(T,v,O){if(v.image.length!==6)return;let tt=Kt(T,v),j=v.source;e.bindTexture(i.TEXTURE_CUBE_MAP,T.__webglTexture,i.TEXTURE0+O);let st=n.get(j);if(j.version!==st.__version||tt===!0){e.activeTexture(i.TEXTURE0+O);let ct=Ht.getPrimaries(Ht.workingColorSpace),Y=v.colorSpace===Fn?null:Ht.getPrimaries(v.colorSpace),Z=v.colorSpace===Fn||ct===Y?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let at=v.isCompressedTexture||v.image[0].isCompressedTexture,C=v.image[0]&&v.image[0].isDataTexture,K=[];for(let dt=0;dt<6;dt++)!at&&!C?K[dt]=S(v.image[dt],!0,s.maxCubemapSize):K[dt]=C?v.image[dt].image:v.image[dt],K[dt]=At(v,K[dt]);let W=K[0],ot=r.convert(v.format,v.colorSpace),it=r.convert(v.type),rt=E(v.internalFormat,ot,it,v.normalized,v.colorSpace),wt=v.isVideoTexture!==!0,Ot=st.__version===void 0||tt===!0,nt=j.dataReady,Tt=b(v,W);Zt(i.TEXTURE_CUBE_MAP,v);let Ft;if(v.isDepthTexture){if(rt=x(v.format===Un,v.type),Ot)if(wt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,W.width,W.height);else for(let dt=0;dt<6;dt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,W.width,W.height,0,ot,it,null)}else if(at){wt&&Ot&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,W.width,W.height);for(let dt=0;dt<6;dt++){Ft=K[dt].mipmaps;for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];v.format!==cn?ot!==null?wt?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,ve.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ve.data):Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,it,ve.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ot,it,ve.data)}}}else{if(Ft=v.mipmaps,wt&&Ot){Ft.length>0&&Tt++;let dt=Pt(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,dt.width,dt.height)}for(let dt=0;dt<6;dt++)if(C){wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,K[dt].width,K[dt].height,ot,it,K[dt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,K[dt].width,K[dt].height,0,ot,it,K[dt].data);for(let Jt=0;Jt<Ft.length;Jt++){let Bn=Ft[Jt].image[dt].image;wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,Bn.width,Bn.height,ot,it,Bn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,Bn.width,Bn.height,0,ot,it,Bn.data)}}else{wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,ot,it,K[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,ot,it,K[dt]);for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,ot,it,ve.image[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,ot,it,ve.image[dt])}}}A(v)&&v.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),st.__version=j.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function re(T,v,O,tt,j,st){let ct=r.convert(O.format,O.colorSpace),Y=r.convert(O.type),Z=E(O.internalFormat,ct,Y,O.normalized,O.colorSpace),at=n.get(v),C=n.get(O);if(C.__renderTarget=v,!at.__hasExternalTextures){let K=Math.max(1,v.width>>st),W=Math.max(1,v.height>>st);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,st,Z,K,W,v.depth,0,ct,Y,null):e.texImage2D(j,st,Z,K,W,0,ct,Y,null)}e.bindFramebuffer(i.FRAMEBUFFER,T),ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,tt,j,C.__webglTexture,0,ie(v)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,tt,j,C.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function un(T,v,O){if(i.bindRenderbuffer(i.RENDERBUFFER,T),v.depthBuffer){let tt=v.depthTexture,j=tt&&tt.isDepthTexture?tt.type:null,st=x(v.stencilBuffer,j),ct=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),st,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),st,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,st,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,T)}else{let tt=v.textures;for(let j=0;j<tt.length;j++){let st=tt[j],ct=r.convert(st.format,st.colorSpace),Y=r.convert(st.type),Z=E(st.internalFormat,ct,Y,st.normalized,st.colorSpace);ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),Z,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),Z,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Z,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(T,v,O){let tt=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,T),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(v.depthTexture);j.__renderTarget=v;let st=tt?v.depthTexture.image[0]:v.depthTexture.image;(!j.__webglTexture||st.width!==v.width||st.height!==v.height)&&(st.width=v.width,st.height=v.height,v.depthTexture.needsUpdate=!0),tt?mt(v.depthTexture,0):pt(v.depthTexture,0);let ct=j.__webglTexture,Y=ie(v),Z=tt?i.TEXTURE_CUBE_MAP_POSITIVE_X+O:i.TEXTURE_2D,at=v.depthTexture.format===Un?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===_n)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Z,ct,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,at,Z,ct,0);else if(v.depthTexture.format===Un)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Z,ct,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,at,Z,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function qe(T){let v=n.get(T),O=T.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==T.depthTexture){let tt=T.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),tt){let j=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,tt.removeEventListener("dispose",j)};tt.addEventListener("dispose",j),v.__depthDisposeCallback=j}v.__boundDepthTexture=tt}if(T.depthTexture&&!v.__autoAllocateDepthBuffer)if(O)for(let tt=0;tt<6;tt++)xe(v.__webglFramebuffer[tt],T,tt);else T.texture.mipmaps.length>0?xe(v.__webglFramebuffer[0],T,0):xe(v.__webglFramebuffer,T,0);else if(O){v.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[tt]),v.__webglDepthbuffer[tt]===void 0)v.__webglDepthbuffer[tt]=i.createRenderbuffer(),un(v.__webglDepthbuffer[tt],T,!1);else{let j=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer[tt];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}}else if(T.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),un(v.__webglDepthbuffer,T,!1);else{let j=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ye(T,v,O){let tt=n.get(T);v!==void 0&&re(tt.__webglFramebuffer,T,T.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),O!==void 0&&qe(T)}function Ze(T){let v=T.texture,O=n.get(T),tt=n.get(v);T.addEventListener("dispose",B),D(T);let j=T.textures,st=T.isWebGLCubeRenderTarget===!0,ct=j.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=i.createTexture()),tt.__version=v.version,a.memory.textures++),st){O.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0){O.__webglFramebuffer[Y]=[];for(let Z=0;Z<v.mipmaps.length;Z++)O.__webglFramebuffer[Y][Z]=i.createFramebuffer()}else O.__webglFramebuffer[Y]=i.createFramebuffer()}else{if(v.mipmaps.length>0){O.__webglFramebuffer=[];for(let Y=0;Y<v.mipmaps.length;Y++)O.__webglFramebuffer[Y]=i.createFramebuffer()}else O.__webglFramebuffer=i.createFramebuffer();if(ct)for(let Y=0,Z=j.length;Y<Z;Y++){let at=n.get(j[Y]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),a.memory.textures++)}if(T.samples>0&&ut(T)===!1){O.__webglMultisampledFramebuffer=i.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let Y=0;Y<j.length;Y++){let Z=j[Y];O.__webglColorRenderbuffer[Y]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,O.__webglColorRenderbuffer[Y]);let at=r.convert(Z.format,Z.colorSpace),C=r.convert(Z.type),K=E(Z.internalFormat,at,C,Z.normalized,Z.colorSpace,T.isXRRenderTarget===!0),W=ie(T);i.renderbufferStorageMultisample(i.RENDERBUFFER,W,K,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Y,i.RENDERBUFFER,O.__webglColorRenderbuffer[Y])}i.bindRenderbuffer(i.RENDERBUFFER,null),T.depthBuffer&&(O.__webglDepthRenderbuffer=i.createRenderbuffer(),un(O.__webglDepthRenderbuffer,T,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture),Zt(i.TEXTURE_CUBE_MAP,v);for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)re(O.__webglFramebuffer[Y][Z],T,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,Z);else re(O.__webglFramebuffer[Y],T,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);A(v)?w(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let Y=0,Z=j.length;Y<Z;Y++){let at=j[Y],C=n.get(at),K=i.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(K=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,C.__webglTexture),Zt(K,at),re(O.__webglFramebuffer,T,at,i.COLOR_ATTACHMENT0+Y,K,0),A(at)&&w(K)}e.unbindTexture()}else{let Y=i.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(Y=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Y,tt.__webglTexture),Zt(Y,v),v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)re(O.__webglFramebuffer[Z],T,v,i.COLOR_ATTACHMENT0,Y,Z);else re(O.__webglFramebuffer,T,v,i.COLOR_ATTACHMENT0,Y,0);A(v)?w(Y):v.mipmaps.length>0&&i.texParameteri(Y,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}T.depthBuffer&&qe(T)}function L(T){let v=T.textures;for(let O=0,tt=v.length;O<tt;O++){let j=v[O];if(A(j)&&j.mipmapsAutoUpdate===!0){let st=R(T),ct=n.get(j).__webglTexture;e.bindTexture(st,ct),w(st),e.unbindTexture()}}}let Je=[];function ne(T){if(T.samples>0){if(ut(T)===!1){let v=T.textures,O=T.width,tt=T.height,j=i.COLOR_BUFFER_BIT,st=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(T),Y=v.length>1;if(Y)for(let at=0;at<v.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let at=0;at<v.length;at++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),Y){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let C=n.get(v[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,C,0)}i.blitFramebuffer(0,0,O,tt,0,0,O,tt,j,i.NEAREST),c===!0&&(Je.length=0,Je.push(i.COLOR_ATTACHMENT0+at),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&Je.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Je))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Y)for(let at=0;at<v.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let C=n.get(v[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,C,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&c){let v=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function ie(T){return Math.min(s.maxSamples,T.samples)}function ut(T){let v=n.get(T);return T.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function fe(T){let v=a.render.frame;h.get(T)!==v&&(h.set(T,v),T.update())}function At(T,v){let O=T.colorSpace,tt=T.format,j=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||O!==is&&O!==Fn&&(Ht.getTransfer(O)===Yt?(tt!==cn||j!==Be)&&Rt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):_t("WebGLTextures: Unsupported texture color space:",O)),v}function Pt(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(l.width=T.naturalWidth||T.width,l.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(l.width=T.displayWidth,l.height=T.displayHeight):(l.width=T.width,l.height=T.height),l}this.allocateTextureUnit=Lt,this.resetTextureUnits=Q,this.getTextureUnits=$,this.setTextureUnits=St,this.setTexture2D=pt,this.setTexture2DArray=vt,this.setTexture3D=Et,this.setTextureCube=mt,this.rebindTextures=Ye,this.setupRenderTarget=Ze,this.updateRenderTargetMipmap=L,this.updateMultisampleRenderTarget=ne,this.setupDepthRenderbuffer=qe,this.setupFrameBufferTexture=re,this.useMultisampledRTT=ut,this.dispose=H}function Gg(i,t){function e(n,s=Fn){let r,a=Ht.getTransfer(s);if(n===Be)return i.UNSIGNED_BYTE;if(n===ia)return i.UNSIGNED_SHORT_4_4_4_4;if(n===sa)return i.UNSIGNED_SHORT_5_5_5_1;if(n===el)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nl)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$o)return i.BYTE;if(n===tl)return i.SHORT;if(n===Wi)return i.UNSIGNED_SHORT;if(n===na)return i.INT;if(n===an)return i.UNSIGNED_INT;if(n===on)return i.FLOAT;if(n===ln)return i.HALF_FLOAT;if(n===il)return i.ALPHA;if(n===sl)return i.RGB;if(n===cn)return i.RGBA;if(n===_n)return i.DEPTH_COMPONENT;if(n===Un)return i.DEPTH_STENCIL;if(n===rl)return i.RED;if(n===ra)return i.RED_INTEGER;if(n===$n)return i.RG;if(n===aa)return i.RG_INTEGER;if(n===oa)return i.RGBA_INTEGER;if(n===Cs||n===_s||n===Is||n===Ps)if(a===Yt)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Cs)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Is)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ps)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Cs)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Is)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ps)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===la||n===ca||n===ha||n===ua)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===la)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ca)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ha)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ua)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===da||n===fa||n===pa||n===ma||n===ga||n===Ls||n===xa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===da||n===fa)return a===Yt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===pa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ma)return r.COMPRESSED_R11_EAC;if(n===ga)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ls)return r.COMPRESSED_RG11_EAC;if(n===xa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===va||n===ya||n===Ma||n===Sa||n===ba||n===wa||n===Ta||n===Ea||n===Aa||n===Ra||n===Ca||n===_a||n===Ia||n===Pa)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===va)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ya)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ma)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Sa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ba)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===wa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ta)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ea)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Aa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ra)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ca)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_a)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ia)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Pa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===La||n===Na||n===Da)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===La)return a===Yt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Na)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Da)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ua||n===Fa||n===Ns||n===Oa)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ua)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Fa)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ns)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oa)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===pi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Hg=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Vg=`
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

}`,Tl=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ps(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new gn({vertexShader:Hg,fragmentShader:Vg,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new pe(new hi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},El=class extends mn{constructor(t,e){super();let n=this,s=null,r=1,a=null,o="local-floor",c=1,l=null,h=null,f=null,d=null,m=null,g=null,M=typeof XRWebGLBinding<"u",p=new Tl,u={},S=e.getContextAttributes(),A=null,w=null,R=[],E=[],x=new Vt,b=null,D=null,P=new Le;P.viewport=new se;let N=new Le;N.viewport=new se;let B=[P,N],V=new jr,_=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let pt=R[J];return pt===void 0&&(pt=new Ui,R[J]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(J){let pt=R[J];return pt===void 0&&(pt=new Ui,R[J]=pt),pt.getGripSpace()},this.getHand=function(J){let pt=R[J];return pt===void 0&&(pt=new Ui,R[J]=pt),pt.getHandSpace()};function q(J){let pt=E.indexOf(J.inputSource);if(pt===-1)return;let vt=R[pt];vt!==void 0&&(vt.update(J.inputSource,J.frame,l||a),vt.dispatchEvent({type:J.type,data:J.inputSource}))}function G(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",et);for(let J=0;J<R.length;J++){let pt=E[J];pt!==null&&(E[J]=null,R[J].disconnect(pt))}_=null,H=null,p.reset();for(let J in u)delete u[J];if(t.setRenderTarget(A),m=null,d=null,f=null,s=null,w=null,Lt.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(x.width,x.height,!1),D!==null){let J=D.camera;J.fov=D.fov,J.zoom=D.zoom,J.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Rt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,n.isPresenting===!0&&Rt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||a},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",G),s.addEventListener("inputsourceschange",et),S.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(x),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Et=null,mt=null;S.depth&&(mt=S.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=S.stencil?Un:_n,Et=S.stencil?pi:an);let Dt={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(Dt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),w=new Ve(d.textureWidth,d.textureHeight,{format:cn,type:Be,depthTexture:new Ln(d.textureWidth,d.textureHeight,Et,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:S.stencil,colorSpace:t.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let vt={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),w=new Ve(m.framebufferWidth,m.framebufferHeight,{format:cn,type:Be,colorSpace:t.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(c),l=null,a=await s.requestReferenceSpace(o),Lt.setContext(s),Lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function et(J){for(let pt=0;pt<J.removed.length;pt++){let vt=J.removed[pt],Et=E.indexOf(vt);Et>=0&&(E[Et]=null,R[Et].disconnect(vt))}for(let pt=0;pt<J.added.length;pt++){let vt=J.added[pt],Et=E.indexOf(vt);if(Et===-1){for(let Dt=0;Dt<R.length;Dt++)if(Dt>=E.length){E.push(vt),Et=Dt;break}else if(E[Dt]===null){E[Dt]=vt,Et=Dt;break}if(Et===-1)break}let mt=R[Et];mt&&mt.connect(vt)}}function X(J,pt){pt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(pt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let pt=J.near,vt=J.far;p.texture!==null&&(p.depthNear>0&&(pt=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),V.near=N.near=P.near=pt,V.far=N.far=P.far=vt,(_!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),_=V.near,H=V.far),V.layers.mask=J.layers.mask|6,P.layers.mask=V.layers.mask&-5,N.layers.mask=V.layers.mask&-3;let Et=J.parent,mt=V.cameras;X(V,Et);for(let Dt=0;Dt<mt.length;Dt++)X(mt[Dt],Et);V.projectionMatrix.copy(P.projectionMatrix),V.projectionMatrixInverse.copy(P.projectionMatrixInverse),D===null&&J.isPerspectiveCamera&&(D={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,V,Et)};function Q(J,pt,vt){vt===null?J.matrix.copy(pt.matrixWorld):(J.matrix.copy(vt.matrixWorld),J.matrix.invert(),J.matrix.multiply(pt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(pt.projectionMatrix),J.projectionMatrixInverse.copy(pt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=_r*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&m===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(V)},this.getCameraTexture=function(J){return u[J]};let $=null;function St(J,pt){if(h=pt.getViewerPose(l||a),g=pt,h!==null){let vt=h.views;m!==null&&(t.setRenderTargetFramebuffer(w,m.framebuffer),t.setRenderTarget(w));let Et=!1;vt.length!==V.cameras.length&&(V.cameras.length=0,Et=!0);for(let Ct=0;Ct<vt.length;Ct++){let Zt=vt[Ct],Kt=null;if(m!==null)Kt=m.getViewport(Zt);else{let be=f.getViewSubImage(d,Zt);Kt=be.viewport,Ct===0&&(t.setRenderTargetTextures(w,be.colorTexture,be.depthStencilTexture),t.setRenderTarget(w))}let zt=B[Ct];zt===void 0&&(zt=new Le,zt.layers.enable(Ct),zt.viewport=new se,B[Ct]=zt),zt.matrix.fromArray(Zt.transform.matrix),zt.matrix.decompose(zt.position,zt.quaternion,zt.scale),zt.projectionMatrix.fromArray(Zt.projectionMatrix),zt.projectionMatrixInverse.copy(zt.projectionMatrix).invert(),zt.viewport.set(Kt.x,Kt.y,Kt.width,Kt.height),Ct===0&&(V.matrix.copy(zt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Et===!0&&V.cameras.push(zt)}let mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){f=n.getBinding();let Ct=f.getDepthInformation(vt[0]);Ct&&Ct.isValid&&Ct.texture&&p.init(Ct,s.renderState)}if(mt&&mt.includes("camera-access")&&M){t.state.unbindTexture(),f=n.getBinding();for(let Ct=0;Ct<vt.length;Ct++){let Zt=vt[Ct].camera;if(Zt){let Kt=u[Zt];Kt||(Kt=new ps,u[Zt]=Kt);let zt=f.getCameraImage(Zt);Kt.sourceTexture=zt}}}}for(let vt=0;vt<R.length;vt++){let Et=E[vt],mt=R[vt];Et!==null&&mt!==void 0&&mt.update(Et,pt,l||a)}$&&$(J,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),g=null}let Lt=new Oh;Lt.setAnimationLoop(St),this.setAnimationLoop=function(J){$=J},this.dispose=function(){}}},Wg=new Qt,Yh=new It;Yh.set(-1,0,0,0,1,0,0,0,1);function Xg(i,t){function e(p,u){p.matrixAutoUpdate===!0&&p.updateMatrix(),u.value.copy(p.matrix)}function n(p,u){u.color.getRGB(p.fogColor.value,dl(i)),u.isFog?(p.fogNear.value=u.near,p.fogFar.value=u.far):u.isFogExp2&&(p.fogDensity.value=u.density)}function s(p,u,S,A,w){u.isNodeMaterial?u.uniformsNeedUpdate=!1:u.isMeshBasicMaterial?r(p,u):u.isMeshLambertMaterial?(r(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshToonMaterial?(r(p,u),f(p,u)):u.isMeshPhongMaterial?(r(p,u),h(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshStandardMaterial?(r(p,u),d(p,u),u.isMeshPhysicalMaterial&&m(p,u,w)):u.isMeshMatcapMaterial?(r(p,u),g(p,u)):u.isMeshDepthMaterial?r(p,u):u.isMeshDistanceMaterial?(r(p,u),M(p,u)):u.isMeshNormalMaterial?r(p,u):u.isLineBasicMaterial?(a(p,u),u.isLineDashedMaterial&&o(p,u)):u.isPointsMaterial?c(p,u,S,A):u.isSpriteMaterial?l(p,u):u.isShadowMaterial?(p.color.value.copy(u.color),p.opacity.value=u.opacity):u.isShaderMaterial&&(u.uniformsNeedUpdate=!1)}function r(p,u){p.opacity.value=u.opacity,u.color&&p.diffuse.value.copy(u.color),u.emissive&&p.emissive.value.copy(u.emissive).multiplyScalar(u.emissiveIntensity),u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.bumpMap&&(p.bumpMap.value=u.bumpMap,e(u.bumpMap,p.bumpMapTransform),p.bumpScale.value=u.bumpScale,u.side===De&&(p.bumpScale.value*=-1)),u.normalMap&&(p.normalMap.value=u.normalMap,e(u.normalMap,p.normalMapTransform),p.normalScale.value.copy(u.normalScale),u.side===De&&p.normalScale.value.negate()),u.displacementMap&&(p.displacementMap.value=u.displacementMap,e(u.displacementMap,p.displacementMapTransform),p.displacementScale.value=u.displacementScale,p.displacementBias.value=u.displacementBias),u.emissiveMap&&(p.emissiveMap.value=u.emissiveMap,e(u.emissiveMap,p.emissiveMapTransform)),u.specularMap&&(p.specularMap.value=u.specularMap,e(u.specularMap,p.specularMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest);let S=t.get(u),A=S.envMap,w=S.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(Wg.makeRotationFromEuler(w)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Yh),p.reflectivity.value=u.reflectivity,p.ior.value=u.ior,p.refractionRatio.value=u.refractionRatio),u.lightMap&&(p.lightMap.value=u.lightMap,p.lightMapIntensity.value=u.lightMapIntensity,e(u.lightMap,p.lightMapTransform)),u.aoMap&&(p.aoMap.value=u.aoMap,p.aoMapIntensity.value=u.aoMapIntensity,e(u.aoMap,p.aoMapTransform))}function a(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform))}function o(p,u){p.dashSize.value=u.dashSize,p.totalSize.value=u.dashSize+u.gapSize,p.scale.value=u.scale}function c(p,u,S,A){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.size.value=u.size*S,p.scale.value=A*.5,u.map&&(p.map.value=u.map,e(u.map,p.uvTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function l(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.rotation.value=u.rotation,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function h(p,u){p.specular.value.copy(u.specular),p.shininess.value=Math.max(u.shininess,1e-4)}function f(p,u){u.gradientMap&&(p.gradientMap.value=u.gradientMap)}function d(p,u){p.metalness.value=u.metalness,u.metalnessMap&&(p.metalnessMap.value=u.metalnessMap,e(u.metalnessMap,p.metalnessMapTransform)),p.roughness.value=u.roughness,u.roughnessMap&&(p.roughnessMap.value=u.roughnessMap,e(u.roughnessMap,p.roughnessMapTransform)),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)}function m(p,u,S){p.ior.value=u.ior,u.diffuseRoughness>0&&(p.diffuseRoughness.value=u.diffuseRoughness,u.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=u.diffuseRoughnessMap,e(u.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),u.sheen>0&&(p.sheenColor.value.copy(u.sheenColor).multiplyScalar(u.sheen),p.sheenRoughness.value=u.sheenRoughness,u.sheenColorMap&&(p.sheenColorMap.value=u.sheenColorMap,e(u.sheenColorMap,p.sheenColorMapTransform)),u.sheenRoughnessMap&&(p.sheenRoughnessMap.value=u.sheenRoughnessMap,e(u.sheenRoughnessMap,p.sheenRoughnessMapTransform))),u.clearcoat>0&&(p.clearcoat.value=u.clearcoat,p.clearcoatRoughness.value=u.clearcoatRoughness,u.clearcoatMap&&(p.clearcoatMap.value=u.clearcoatMap,e(u.clearcoatMap,p.clearcoatMapTransform)),u.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=u.clearcoatRoughnessMap,e(u.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),u.clearcoatNormalMap&&(p.clearcoatNormalMap.value=u.clearcoatNormalMap,e(u.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(u.clearcoatNormalScale),u.side===De&&p.clearcoatNormalScale.value.negate())),u.dispersion>0&&(p.dispersion.value=u.dispersion),u.retroreflectivity>0&&(p.retroreflectivity.value=u.retroreflectivity),u.iridescence>0&&(p.iridescence.value=u.iridescence,p.iridescenceIOR.value=u.iridescenceIOR,p.iridescenceThicknessMinimum.value=u.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=u.iridescenceThicknessMaximum,u.iridescenceMap&&(p.iridescenceMap.value=u.iridescenceMap,e(u.iridescenceMap,p.iridescenceMapTransform)),u.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=u.iridescenceThicknessMap,e(u.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),u.transmission>0&&(p.transmission.value=u.transmission,p.transmissionSamplerMap.value=S.texture,p.transmissionSamplerSize.value.set(S.width,S.height),u.transmissionMap&&(p.transmissionMap.value=u.transmissionMap,e(u.transmissionMap,p.transmissionMapTransform)),p.thickness.value=u.thickness,u.thicknessMap&&(p.thicknessMap.value=u.thicknessMap,e(u.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=u.attenuationDistance,p.attenuationColor.value.copy(u.attenuationColor)),u.anisotropy>0&&(p.anisotropyVector.value.set(u.anisotropy*Math.cos(u.anisotropyRotation),u.anisotropy*Math.sin(u.anisotropyRotation)),u.anisotropyMap&&(p.anisotropyMap.value=u.anisotropyMap,e(u.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=u.specularIntensity,p.specularColor.value.copy(u.specularColor),u.specularColorMap&&(p.specularColorMap.value=u.specularColorMap,e(u.specularColorMap,p.specularColorMapTransform)),u.specularIntensityMap&&(p.specularIntensityMap.value=u.specularIntensityMap,e(u.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,u){u.matcap&&(p.matcap.value=u.matcap)}function M(p,u){let S=t.get(u).light;p.referencePosition.value.setFromMatrixPosition(S.matrixWorld),p.nearDistance.value=S.shadow.camera.near,p.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function qg(i,t,e,n){let s={},r={};function a(S,A){let w=A.program;n.uniformBlockBinding(S,w,s[S.id])}function o(S,A){let w=s[S.id];w===void 0&&(g(S),w=c(S),s[S.id]=w,S.addEventListener("dispose",p));let R=A.program;n.updateUBOMapping(S,R);let E=t.render.frame;r[S.id]!==E&&(l(S),r[S.id]=E)}function c(S){let A=i.createBuffer(),w=S.__size,R=S.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,w,R),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(S){let A=s[S.id],w=S.uniforms,R=S.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=w.length;E<x;E++){let b=w[E];if(Array.isArray(b))for(let D=0,P=b.length;D<P;D++)h(b[D],E,D,R);else h(b,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(S,A,w,R){if(d(S,A,w,R)===!0){let E=S.__offset,x=S.value;if(Array.isArray(x)){let b=0;for(let D=0;D<x.length;D++){let P=x[D],N=M(P,!0);f(P,S.__data,b),b+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,S.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,S.__data)}}function f(S,A,w){typeof S=="number"||typeof S=="boolean"?A[w]=S:S.isMatrix3?(A[w]=S.elements[0],A[w+1]=S.elements[1],A[w+2]=S.elements[2],A[w+3]=0,A[w+4]=S.elements[3],A[w+5]=S.elements[4],A[w+6]=S.elements[5],A[w+7]=0,A[w+8]=S.elements[6],A[w+9]=S.elements[7],A[w+10]=S.elements[8],A[w+11]=0):ArrayBuffer.isView(S)?A.set(S.subarray(0,A.length-w),w):S.toArray(A,w)}function d(S,A,w,R){let E=S.value,x=A+"_"+w;if(Array.isArray(E)){R[x]===void 0&&(R[x]=[]);let b=R[x],D=!1;for(let P=0;P<E.length;P++)m(E[P],b,P)===!0&&(D=!0);return D}return m(E,R,x)}function m(S,A,w){if(A[w]===void 0)return typeof S=="number"||typeof S=="boolean"?A[w]=S:ArrayBuffer.isView(S)?A[w]=S.slice():A[w]=S.clone(),!0;{let R=A[w];if(typeof S=="number"||typeof S=="boolean"){if(R!==S)return A[w]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(R.equals(S)===!1)return R.copy(S),!0}}return!1}function g(S){let A=S.uniforms,w=0,R=16;for(let x=0,b=A.length;x<b;x++){let D=Array.isArray(A[x])?A[x]:[A[x]];for(let P=0,N=D.length;P<N;P++){let B=D[P],V=Array.isArray(B.value)?B.value:[B.value],_=Array.isArray(A[x])||Array.isArray(B.value),H=w;for(let G=0,et=V.length;G<et;G++){let X=V[G],Q=M(X,_),$=w%R,St=$%Q.boundary,Lt=$+St;w+=St,Lt!==0&&R-Lt<Q.storage&&(w+=R-Lt),G===0&&(H=w),w+=Q.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((w-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}let E=w%R;return E>0&&(w+=R-E),S.__size=w,S.__cache={},this}function M(S,A){let w={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(w.boundary=4,w.storage=4):S.isVector2?(w.boundary=8,w.storage=8):S.isVector3||S.isColor?(w.boundary=16,w.storage=12):S.isVector4?(w.boundary=16,w.storage=16):S.isMatrix3?(w.boundary=16,w.storage=48):S.isMatrix4?(w.boundary=16,w.storage=64):S.isTexture?Rt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(w.boundary=16,w.storage=S.byteLength):Rt("WebGLRenderer: Unsupported uniform value type.",S),A===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function p(S){let A=S.target;A.removeEventListener("dispose",p),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function u(){for(let S in s)i.deleteBuffer(s[S]);s={},r={}}return{bind:a,update:o,dispose:u}}var Yg=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yn=null;function Zg(){return yn===null&&(yn=new Nr(Yg,16,16,$n,ln),yn.name="DFG_LUT",yn.minFilter=Ne,yn.magFilter=Ne,yn.wrapS=fn,yn.wrapT=fn,yn.generateMipmaps=!1,yn.needsUpdate=!0),yn}var Ha=class{constructor(t={}){let{canvas:e=oh(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:m=Be}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let M=m,p=new Set([oa,aa,ra]),u=new Set([Be,an,Wi,pi,ia,sa]),S=new Uint32Array(4),A=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},R=null,E=null,x=[],b=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,N=!1,B=null,V=null,_=null,H=null;this._outputColorSpace=Ge;let q=0,G=0,et=null,X=-1,Q=null,$=new se,St=new se,Lt=null,J=new Ut(0),pt=0,vt=e.width,Et=e.height,mt=1,Dt=null,le=null,Ct=new se(0,0,vt,Et),Zt=new se(0,0,vt,Et),Kt=!1,zt=new Yn,be=new Dr,de=!1,Fe=!1,re=new Qt,un=new U,xe=new se,qe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ye=!1;function Ze(){return et===null?mt:1}let L=n;function Je(y,I){return e.getContext(y,I)}let ne,ie,ut,fe,At,Pt,T,v,O,tt,j,st,ct,Y,Z,at,C,K,W,ot,it,rt,wt;try{let y={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Tt,!1),e.addEventListener("webglcontextrestored",Ft,!1),e.addEventListener("webglcontextcreationerror",dt,!1),L===null){let I="webgl2";if(L=Je(I,y),L===null)throw Je(I)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ot()}catch(y){throw e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),_t("WebGLRenderer: "+y.message),y}function Ot(){ne=new rm(L),ne.init(),it=new Gg(L,ne),ie=new Zp(L,ne,t,it),ut=new zg(L,ne),ie.reversedDepthBuffer&&d&&ut.buffers.depth.setReversed(!0),V=L.createFramebuffer(),_=L.createFramebuffer(),H=L.createFramebuffer(),fe=new lm(L),At=new Eg,Pt=new kg(L,ne,ut,At,ie,it,fe),T=new sm(P),v=new cd(L),rt=new qp(L,v),O=new am(L,v,fe,rt),tt=new hm(L,O,v,rt,fe),K=new cm(L,ie,Pt),Z=new Jp(At),j=new Tg(P,T,ne,ie,rt,Z),st=new Xg(P,At),ct=new Rg,Y=new Ng(ne),C=new Xp(P,T,ut,tt,g,c),at=new Bg(P,tt,ie),wt=new qg(L,fe,ie,ut),W=new Yp(L,ne,fe),ot=new om(L,ne,fe),fe.programs=j.programs,P.capabilities=ie,P.extensions=ne,P.properties=At,P.renderLists=ct,P.shadowMap=at,P.state=ut,P.info=fe}M!==Be&&(D=new dm(M,e.width,e.height,o,s,r));let nt=new El(P,L);this.xr=nt,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let y=ne.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){let y=ne.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(y){y!==void 0&&(mt=y,this.setSize(vt,Et,!1))},this.getSize=function(y){return y.set(vt,Et)},this.setSize=function(y,I,k=!0){if(nt.isPresenting){Rt("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=y,Et=I,e.width=Math.floor(y*mt),e.height=Math.floor(I*mt),k===!0&&(e.style.width=y+"px",e.style.height=I+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,y,I)},this.getDrawingBufferSize=function(y){return y.set(vt*mt,Et*mt).floor()},this.setDrawingBufferSize=function(y,I,k){vt=y,Et=I,mt=k,e.width=Math.floor(y*k),e.height=Math.floor(I*k),this.setViewport(0,0,y,I)},this.setEffects=function(y){if(M===Be){_t("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let I=0;I<y.length;I++)if(y[I].isOutputPass===!0){Rt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy($)},this.getViewport=function(y){return y.copy(Ct)},this.setViewport=function(y,I,k,F){y.isVector4?Ct.set(y.x,y.y,y.z,y.w):Ct.set(y,I,k,F),ut.viewport($.copy(Ct).multiplyScalar(Ze()).round())},this.getScissor=function(y){return y.copy(Zt)},this.setScissor=function(y,I,k,F){y.isVector4?Zt.set(y.x,y.y,y.z,y.w):Zt.set(y,I,k,F),ut.scissor(St.copy(Zt).multiplyScalar(Ze()).round())},this.getScissorTest=function(){return Kt},this.setScissorTest=function(y){ut.setScissorTest(Kt=y)},this.setOpaqueSort=function(y){Dt=y},this.setTransparentSort=function(y){le=y},this.getClearColor=function(y){return y.copy(C.getClearColor())},this.setClearColor=function(){C.setClearColor(...arguments)},this.getClearAlpha=function(){return C.getClearAlpha()},this.setClearAlpha=function(){C.setClearAlpha(...arguments)},this.clear=function(y=!0,I=!0,k=!0){let F=0;if(y){let z=!1;if(et!==null){let ht=et.texture.format;z=p.has(ht)}if(z){let ht=et.texture.type,xt=u.has(ht),lt=C.getClearColor(),gt=C.getClearAlpha(),bt=lt.r,Nt=lt.g,kt=lt.b;xt?(S[0]=bt,S[1]=Nt,S[2]=kt,S[3]=gt,L.clearBufferuiv(L.COLOR,0,S)):(A[0]=bt,A[1]=Nt,A[2]=kt,A[3]=gt,L.clearBufferiv(L.COLOR,0,A))}else F|=L.COLOR_BUFFER_BIT}I&&(F|=L.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),k&&(F|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&L.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),B=y},this.dispose=function(){e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),C.dispose(),ct.dispose(),Y.dispose(),Pt.dispose(),At.dispose(),T.dispose(),tt.dispose(),O.dispose(),rt.dispose(),wt.dispose(),j.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Dl),nt.removeEventListener("sessionend",Ul),ei.stop()};function Tt(y){y.preventDefault(),hl("WebGLRenderer: Context Lost."),N=!0}function Ft(){hl("WebGLRenderer: Context Restored."),N=!1;let y=fe.autoReset,I=at.enabled,k=at.autoUpdate,F=at.needsUpdate,z=at.type;Ot(),fe.autoReset=y,at.enabled=I,at.autoUpdate=k,at.needsUpdate=F,at.type=z}function dt(y){_t("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Jt(y){let I=y.target;I.removeEventListener("dispose",Jt),ve(I)}function ve(y){Bn(y),At.remove(y)}function Bn(y){let I=At.get(y).programs;I!==void 0&&(I.forEach(function(k){j.releaseProgram(k)}),y.isShaderMaterial&&j.releaseShaderCache(y))}this.renderBufferDirect=function(y,I,k,F,z,ht){I===null&&(I=qe);let xt=z.isMesh&&z.matrixWorld.determinantAffine()<0,lt=cu(y,I,k,F,z);ut.setMaterial(F,xt);let gt=k.index,bt=1;if(F.wireframe===!0){if(gt=O.getWireframeAttribute(k),gt===void 0)return;bt=2}let Nt=k.drawRange,kt=k.attributes.position,yt=Nt.start*bt,Gt=(Nt.start+Nt.count)*bt;ht!==null&&(yt=Math.max(yt,ht.start*bt),Gt=Math.min(Gt,(ht.start+ht.count)*bt)),gt!==null?(yt=Math.max(yt,0),Gt=Math.min(Gt,gt.count)):kt!=null&&(yt=Math.max(yt,0),Gt=Math.min(Gt,kt.count));let ce=Gt-yt;if(ce<0||ce===1/0)return;rt.setup(z,F,lt,k,gt);let $t,jt=W;if(gt!==null&&($t=v.get(gt),jt=ot,jt.setIndex($t)),z.isMesh)F.wireframe===!0?(ut.setLineWidth(F.wireframeLinewidth*Ze()),jt.setMode(L.LINES)):jt.setMode(L.TRIANGLES);else if(z.isLine){let Ee=F.linewidth;Ee===void 0&&(Ee=1),ut.setLineWidth(Ee*Ze()),z.isLineSegments?jt.setMode(L.LINES):z.isLineLoop?jt.setMode(L.LINE_LOOP):jt.setMode(L.LINE_STRIP)}else z.isPoints?jt.setMode(L.POINTS):z.isSprite&&jt.setMode(L.TRIANGLES);if(z.isBatchedMesh)if(ne.get("WEBGL_multi_draw"))jt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Ee=z._multiDrawStarts,Mt=z._multiDrawCounts,Pe=z._multiDrawCount,qt=gt?v.get(gt).bytesPerElement:1,ni=At.get(F).currentProgram.getUniforms();for(let Ae=0;Ae<Pe;Ae++)ni.setValue(L,"_gl_DrawID",Ae),jt.render(Ee[Ae]/qt,Mt[Ae])}else if(z.isInstancedMesh)jt.renderInstances(yt,ce,z.count);else if(k.isInstancedBufferGeometry){let Ee=k._maxInstanceCount!==void 0?k._maxInstanceCount:1/0,Mt=Math.min(k.instanceCount,Ee);jt.renderInstances(yt,ce,Mt)}else jt.render(yt,ce)};function Nl(y,I,k,F){B!==null&&y.isNodeMaterial&&B.setObject(F,y),de===!0&&Z.setState(y,k,!1),y.transparent===!0&&y.side===xn&&y.forceSinglePass===!1?(y.side=De,y.needsUpdate=!0,Zi(y,I,F),y.side=Qn,y.needsUpdate=!0,Zi(y,I,F),y.side=xn):Zi(y,I,F)}this.compile=function(y,I,k=null){k===null&&(k=y),B!==null&&B.renderStart(y,I,k),E=Y.get(k),E.init(I),b.push(E),k.traverseVisible(function(z){z.isLight&&z.layers.test(I.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),y!==k&&y.traverseVisible(function(z){z.isLight&&z.layers.test(I.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Fe=this.localClippingEnabled,de=Z.init(this.clippingPlanes,Fe),de===!0&&Z.setGlobalState(this.clippingPlanes,I),B!==null&&at.render(E.state.shadowsArray,k,I);let F=new Set;return y.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let ht=z.material;if(ht)if(Array.isArray(ht))for(let xt=0;xt<ht.length;xt++){let lt=ht[xt];Nl(lt,k,I,z),F.add(lt)}else Nl(ht,k,I,z),F.add(ht)}),E=b.pop(),B!==null&&B.renderEnd(),F},this.compileAsync=function(y,I,k=null){let F=this.compile(y,I,k);return new Promise(z=>{function ht(){if(F.forEach(function(xt){let gt=At.get(xt).currentProgram;(gt===void 0||gt.isReady())&&F.delete(xt)}),F.size===0){z(y);return}setTimeout(ht,10)}ne.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let no=null;function ou(y){no&&no(y)}function Dl(){ei.stop()}function Ul(){ei.start()}let ei=new Oh;ei.setAnimationLoop(ou),typeof self<"u"&&ei.setContext(self),this.setAnimationLoop=function(y){no=y,nt.setAnimationLoop(y),y===null?ei.stop():ei.start()},nt.addEventListener("sessionstart",Dl),nt.addEventListener("sessionend",Ul),this.render=function(y,I){if(I!==void 0&&I.isCamera!==!0){_t("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;B!==null&&B.renderStart(y,I);let k=nt.enabled===!0&&nt.isPresenting===!0,F=D!==null&&(et===null||k)&&D.begin(P,et);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),I.parent===null&&I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(I),I=nt.getCamera()),y.isScene===!0&&y.onBeforeRender(P,y,I,et),E=Y.get(y,b.length),E.init(I),E.state.textureUnits=Pt.getTextureUnits(),b.push(E),re.multiplyMatrices(I.projectionMatrix,I.matrixWorldInverse),I.isArrayCamera?be.setFromArrayCamera(I):zt.setFromProjectionMatrix(re,je,I.reversedDepth),Fe=this.localClippingEnabled,de=Z.init(this.clippingPlanes,Fe),R=ct.get(y,x.length),R.init(),x.push(R),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let xt=P.xr.getDepthSensingMesh();xt!==null&&io(xt,I,-1/0,P.sortObjects)}io(y,I,0,P.sortObjects),R.finish(),B!==null&&B.updateLights(E.state.lightsArray),P.sortObjects===!0&&R.sort(Dt,le),Ye=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Ye&&C.addToRenderList(R,y),this.info.autoReset===!0&&this.info.reset(),de===!0&&Z.beginShadows();let z=E.state.shadowsArray;if(at.render(z,y,I),de===!0&&Z.endShadows(),(F&&D.hasRenderPass())===!1){let xt=R.opaque,lt=R.transmissive;if(E.setupLights(),I.isArrayCamera){let gt=I.cameras;if(lt.length>0)for(let bt=0,Nt=gt.length;bt<Nt;bt++){let kt=gt[bt];Ol(xt,lt,y,kt)}Ye&&C.render(y);for(let bt=0,Nt=gt.length;bt<Nt;bt++){let kt=gt[bt];Fl(R,y,kt,kt.viewport)}}else lt.length>0&&Ol(xt,lt,y,I),Ye&&C.render(y),Fl(R,y,I)}et!==null&&G===0&&(Pt.updateMultisampleRenderTarget(et),Pt.updateRenderTargetMipmap(et)),F&&D.end(P),y.isScene===!0&&y.onAfterRender(P,y,I),rt.resetDefaultState(),X=-1,Q=null,b.pop(),b.length>0?(E=b[b.length-1],Pt.setTextureUnits(E.state.textureUnits),de===!0&&Z.setGlobalState(P.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,B!==null&&B.renderEnd()};function io(y,I,k,F){if(y.visible===!1)return;if(y.layers.test(I.layers)){if(y.isGroup)k=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(I);else if(y.isLight)E.pushLight(y),y.castShadow&&E.pushShadow(y);else if(y.isSprite){let xt=I.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){F&&xe.setFromMatrixPosition(y.matrixWorld).applyMatrix4(re);let lt=tt.update(y),gt=y.material;gt.visible&&R.push(y,lt,gt,k,xe.z,null,I)}}else if(y.isMesh||y.isLine||y.isPoints){let xt=I.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){let lt=tt.update(y),gt=y.material;if(F&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),xe.copy(y.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),xe.copy(lt.boundingSphere.center)),xe.applyMatrix4(y.matrixWorld).applyMatrix4(re)),Array.isArray(gt)){let bt=lt.groups;for(let Nt=0,kt=bt.length;Nt<kt;Nt++){let yt=bt[Nt],Gt=gt[yt.materialIndex];Gt&&Gt.visible&&R.push(y,lt,Gt,k,xe.z,yt,I)}}else gt.visible&&R.push(y,lt,gt,k,xe.z,null,I)}}}let ht=y.children;for(let xt=0,lt=ht.length;xt<lt;xt++)io(ht[xt],I,k,F)}function Fl(y,I,k,F){let{opaque:z,transmissive:ht,transparent:xt}=y;E.setupLightsView(k),de===!0&&Z.setGlobalState(P.clippingPlanes,k),F&&ut.viewport($.copy(F)),z.length>0&&Gs(z,I,k),ht.length>0&&Gs(ht,I,k),xt.length>0&&Gs(xt,I,k),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function Ol(y,I,k,F){if((k.isScene===!0?k.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[F.id]===void 0){let yt=ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[F.id]=new Ve(1,1,{generateMipmaps:!0,type:yt?ln:Be,minFilter:Dn,samples:Math.max(4,ie.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ht.workingColorSpace})}let ht=E.state.transmissionRenderTarget[F.id],xt=F.viewport||$;ht.setSize(xt.z*P.transmissionResolutionScale,xt.w*P.transmissionResolutionScale);let lt=P.getRenderTarget(),gt=P.getActiveCubeFace(),bt=P.getActiveMipmapLevel();P.setRenderTarget(ht),P.getClearColor(J),pt=P.getClearAlpha(),pt<1&&P.setClearColor(16777215,.5),P.clear(),Ye&&C.render(k);let Nt=P.toneMapping;P.toneMapping=vn;let kt=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),E.setupLightsView(F),de===!0&&Z.setGlobalState(P.clippingPlanes,F),Gs(y,k,F),Pt.updateMultisampleRenderTarget(ht),Pt.updateRenderTargetMipmap(ht),ne.has("WEBGL_multisampled_render_to_texture")===!1){let yt=!1;for(let Gt=0,ce=I.length;Gt<ce;Gt++){let $t=I[Gt],{object:jt,geometry:Ee,material:Mt,group:Pe}=$t;if(Mt.side===xn&&jt.layers.test(F.layers)){let qt=Mt.side;Mt.side=De,Mt.needsUpdate=!0,Bl(jt,k,F,Ee,Mt,Pe),Mt.side=qt,Mt.needsUpdate=!0,yt=!0}}yt===!0&&(Pt.updateMultisampleRenderTarget(ht),Pt.updateRenderTargetMipmap(ht))}P.setRenderTarget(lt,gt,bt),P.setClearColor(J,pt),kt!==void 0&&(F.viewport=kt),P.toneMapping=Nt}function Gs(y,I,k){let F=I.isScene===!0?I.overrideMaterial:null;for(let z=0,ht=y.length;z<ht;z++){let xt=y[z],{object:lt,geometry:gt,group:bt}=xt,Nt=xt.material;Nt.allowOverride===!0&&F!==null&&(Nt=F),lt.layers.test(k.layers)&&Bl(lt,I,k,gt,Nt,bt)}}function Bl(y,I,k,F,z,ht){B!==null&&z.isNodeMaterial&&B.setObject(y,z),y.onBeforeRender(P,I,k,F,z,ht),y.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),z.onBeforeRender(P,I,k,F,y,ht),z.transparent===!0&&z.side===xn&&z.forceSinglePass===!1?(z.side=De,z.needsUpdate=!0,P.renderBufferDirect(k,I,F,z,y,ht),z.side=Qn,z.needsUpdate=!0,P.renderBufferDirect(k,I,F,z,y,ht),z.side=xn):P.renderBufferDirect(k,I,F,z,y,ht),y.onAfterRender(P,I,k,F,z,ht)}function zl(y){let I=0;for(let k of y)k.texture!==null&&I++;return I}function Zi(y,I,k){I.isScene!==!0&&(I=qe);let F=At.get(y),z=E.state.lights,ht=E.state.shadowsArray,xt=z.state.version,lt=j.getParameters(y,z.state,ht,I,k,E.state.lightProbeGridArray),gt=j.getProgramCacheKey(lt),bt=F.programs;F.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?I.environment:null,F.fog=I.fog;let Nt=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;F.envMap=T.get(y.envMap||F.environment,Nt),F.envMapRotation=F.environment!==null&&y.envMap===null?I.environmentRotation:y.envMapRotation,bt===void 0&&(y.addEventListener("dispose",Jt),bt=new Map,F.programs=bt,F.programVariants=new Map);let kt=bt.get(gt);if(kt!==void 0){if(F.currentProgram===kt&&F.lightsStateVersion===xt)return Gl(y,lt),kt}else lt.uniforms=j.getUniforms(y),B!==null&&y.isNodeMaterial&&B.build(y,k,lt),y.onBeforeCompile(lt,P),kt=j.acquireProgram(lt,gt),bt.set(gt,kt),F.uniforms=lt.uniforms;let yt=F.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(yt.clippingPlanes=Z.uniform),Gl(y,lt),F.needsLights=uu(y),F.lightsStateVersion=xt,F.needsLights&&(yt.ambientLightColor.value=z.state.ambient,yt.lightProbe.value=z.state.probe,yt.sunLights.value=z.state.sun,yt.sunLightShadows.value=z.state.sunShadow,yt.directionalLights.value=z.state.directional,yt.directionalLightShadows.value=z.state.directionalShadow,yt.spotLights.value=z.state.spot,yt.spotLightShadows.value=z.state.spotShadow,yt.rectAreaLights.value=z.state.rectArea,yt.ltc_1.value=z.state.rectAreaLTC1,yt.ltc_2.value=z.state.rectAreaLTC2,yt.pointLights.value=z.state.point,yt.pointLightShadows.value=z.state.pointShadow,yt.hemisphereLights.value=z.state.hemi,yt.sunShadowMatrix.value=z.state.sunShadowMatrix,yt.sunShadowCascade.value=z.state.sunShadowCascade,yt.directionalShadowMatrix.value=z.state.directionalShadowMatrix,yt.spotLightMatrix.value=z.state.spotLightMatrix,yt.spotLightMap.value=z.state.spotLightMap,yt.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=zl(E.state.lightProbeGridArray),F.currentProgram=kt,F.uniformsList=null,kt}function lu(y,I,k,F,z){let ht=At.get(y),xt=ht.currentProgram.id+","+F+","+z,lt=ht.programVariants.get(xt);return lt===void 0?(lt=Zi(y,I,k),ht.programVariants.set(xt,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=F,ht.toneMapping=z),lt}function kl(y){if(y.uniformsList===null){let I=y.currentProgram.getUniforms();y.uniformsList=Xi.seqWithValue(I.seq,y.uniforms)}return y.uniformsList}function Gl(y,I){let k=At.get(y);k.outputColorSpace=I.outputColorSpace,k.batching=I.batching,k.batchingColor=I.batchingColor,k.instancing=I.instancing,k.instancingColor=I.instancingColor,k.instancingMorph=I.instancingMorph,k.skinning=I.skinning,k.morphTargets=I.morphTargets,k.morphNormals=I.morphNormals,k.morphColors=I.morphColors,k.morphTargetsCount=I.morphTargetsCount,k.numClippingPlanes=I.numClippingPlanes,k.numIntersection=I.numClipIntersection,k.vertexAlphas=I.vertexAlphas,k.vertexTangents=I.vertexTangents,k.toneMapping=I.toneMapping}function cu(y,I,k,F,z){I.isScene!==!0&&(I=qe),Pt.resetTextureUnits();let ht=I.fog,xt=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?I.environment:null,lt=et===null?P.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Ht.workingColorSpace,gt=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,bt=T.get(F.envMap||xt,gt),Nt=F.vertexColors===!0&&!!k.attributes.color&&k.attributes.color.itemSize===4,kt=!!k.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),yt=!!k.morphAttributes.position,Gt=!!k.morphAttributes.normal,ce=!!k.morphAttributes.color,$t=vn;F.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&($t=P.toneMapping);let jt=k.morphAttributes.position||k.morphAttributes.normal||k.morphAttributes.color,Ee=jt!==void 0?jt.length:0,Mt=At.get(F),Pe=E.state.lights;if(de===!0&&(Fe===!0||y!==Q)){let ae=y===Q&&F.id===X;Z.setState(F,y,ae)}let qt=!1,ni=!1;F.version===Mt.__version?Mt.needsLights&&Mt.lightsStateVersion!==Pe.state.version||z.isBatchedMesh&&Mt.batching===!1||!z.isBatchedMesh&&Mt.batching===!0||z.isBatchedMesh&&Mt.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Mt.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Mt.instancing===!1||!z.isInstancedMesh&&Mt.instancing===!0||z.isSkinnedMesh&&Mt.skinning===!1||!z.isSkinnedMesh&&Mt.skinning===!0||z.isInstancedMesh&&Mt.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Mt.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Mt.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Mt.instancingMorph===!1&&z.morphTexture!==null||Mt.envMap!==bt||F.fog===!0&&Mt.fog!==ht||Mt.numClippingPlanes!==void 0&&(Mt.numClippingPlanes!==Z.numPlanes||Mt.numIntersection!==Z.numIntersection)||Mt.vertexAlphas!==Nt||Mt.vertexTangents!==kt||Mt.morphTargets!==yt||Mt.morphNormals!==Gt||Mt.morphColors!==ce||Mt.morphTargetsCount!==Ee||Mt.numLightProbeGrids!==zl(E.state.lightProbeGridArray)?qt=!0:(Mt.outputColorSpace!==lt||Mt.toneMapping!==$t)&&(ni=!0):(qt=!0,Mt.__version=F.version);let Ae=Mt.currentProgram;(qt===!0||ni===!0)&&(Ae=ni===!0?lu(F,I,z,lt,$t):Zi(F,I,z),B&&F.isNodeMaterial&&B.onUpdateProgram(F,Ae,Mt));let Hs=!1,zn=!1,ii=!1,Xt=Ae.getUniforms(),we=Mt.uniforms;if(ut.useProgram(Ae.program)&&(Hs=!0,zn=!0,ii=!0),F.id!==X&&(X=F.id,zn=!0),Hs||Q!==y){ut.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),Xt.setValue(L,"projectionMatrix",y.projectionMatrix),Xt.setValue(L,"viewMatrix",y.matrixWorldInverse);let ye=Xt.map.cameraPosition;ye!==void 0&&ye.setValue(L,un.setFromMatrixPosition(y.matrixWorld)),ie.logarithmicDepthBuffer&&Xt.setValue(L,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&Xt.setValue(L,"isOrthographic",y.isOrthographicCamera===!0),Q!==y&&(Q=y,zn=!0,ii=!0)}if(Mt.needsLights&&(Pe.state.sunShadowMap.length>0&&Xt.setValue(L,"sunShadowMap",Pe.state.sunShadowMap,Pt),Pe.state.directionalShadowMap.length>0&&Xt.setValue(L,"directionalShadowMap",Pe.state.directionalShadowMap,Pt),Pe.state.spotShadowMap.length>0&&Xt.setValue(L,"spotShadowMap",Pe.state.spotShadowMap,Pt),Pe.state.pointShadowMap.length>0&&Xt.setValue(L,"pointShadowMap",Pe.state.pointShadowMap,Pt)),z.isSkinnedMesh){Xt.setOptional(L,z,"bindMatrix"),Xt.setOptional(L,z,"bindMatrixInverse");let ae=z.skeleton;ae&&(ae.boneTexture===null&&ae.computeBoneTexture(),Xt.setValue(L,"boneTexture",ae.boneTexture,Pt))}z.isBatchedMesh&&(Xt.setOptional(L,z,"batchingTexture"),Xt.setValue(L,"batchingTexture",z._matricesTexture,Pt),Xt.setOptional(L,z,"batchingIdTexture"),Xt.setValue(L,"batchingIdTexture",z._indirectTexture,Pt),Xt.setOptional(L,z,"batchingColorTexture"),z._colorsTexture!==null&&Xt.setValue(L,"batchingColorTexture",z._colorsTexture,Pt));let tn=k.morphAttributes;if((tn.position!==void 0||tn.normal!==void 0||tn.color!==void 0)&&K.update(z,k,Ae),(zn||Mt.receiveShadow!==z.receiveShadow)&&(Mt.receiveShadow=z.receiveShadow,Xt.setValue(L,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&I.environment!==null&&(we.envMapIntensity.value=I.environmentIntensity),we.dfgLUT!==void 0&&(we.dfgLUT.value=Zg()),zn){if(Xt.setValue(L,"toneMappingExposure",P.toneMappingExposure),Mt.needsLights&&hu(we,ii),ht&&F.fog===!0&&st.refreshFogUniforms(we,ht),st.refreshMaterialUniforms(we,F,mt,Et,E.state.transmissionRenderTarget[y.id]),Mt.needsLights&&Mt.numLightProbeGrids>0){let ae=w,ye=0;for(let Sn of E.state.lightProbeGridArray)Sn.texture!==null&&(ae.textures[ye]=Sn.texture,ae.min[ye]=Sn.boundingBox.min,ae.max[ye]=Sn.boundingBox.max,ae.resolution[ye]=Sn.resolution,ye++);for(let Sn in ae)ae[Sn].length=ye;we.probesSH.value=ae.textures,we.probesMin.value=ae.min,we.probesMax.value=ae.max,we.probesResolution.value=ae.resolution}Xi.upload(L,kl(Mt),we,Pt)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(Xi.upload(L,kl(Mt),we,Pt),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&Xt.setValue(L,"center",z.center),Xt.setValue(L,"modelViewMatrix",z.modelViewMatrix),Xt.setValue(L,"normalMatrix",z.normalMatrix),Xt.setValue(L,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let ae=F.uniformsGroups;for(let ye=0,Sn=ae.length;ye<Sn;ye++){let Vl=ae[ye];wt.update(Vl,Ae),wt.bind(Vl,Ae)}}return Ae}function hu(y,I){y.ambientLightColor.needsUpdate=I,y.lightProbe.needsUpdate=I,y.sunLights.needsUpdate=I,y.sunLightShadows.needsUpdate=I,y.directionalLights.needsUpdate=I,y.directionalLightShadows.needsUpdate=I,y.pointLights.needsUpdate=I,y.pointLightShadows.needsUpdate=I,y.spotLights.needsUpdate=I,y.spotLightShadows.needsUpdate=I,y.rectAreaLights.needsUpdate=I,y.hemisphereLights.needsUpdate=I}function uu(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(y,I,k){let F=At.get(y);F.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),At.get(y.texture).__webglTexture=I,At.get(y.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:k,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,I){let k=At.get(y);k.__webglFramebuffer=I,k.__useDefaultFramebuffer=I===void 0},this.setRenderTarget=function(y,I=0,k=0){et=y,q=I,G=k;let F=null,z=!1,ht=!1;if(y){let lt=At.get(y);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(L.FRAMEBUFFER,lt.__webglFramebuffer),$.copy(y.viewport),St.copy(y.scissor),Lt=y.scissorTest,ut.viewport($),ut.scissor(St),ut.setScissorTest(Lt),X=-1;return}else if(lt.__webglFramebuffer===void 0)Pt.setupRenderTarget(y);else if(lt.__hasExternalTextures)Pt.rebindTextures(y,At.get(y.texture).__webglTexture,At.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){let Nt=y.depthTexture;if(lt.__boundDepthTexture!==Nt){if(Nt!==null&&At.has(Nt)&&(y.width!==Nt.image.width||y.height!==Nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Pt.setupDepthRenderbuffer(y)}}let gt=y.texture;(gt.isData3DTexture||gt.isDataArrayTexture||gt.isCompressedArrayTexture)&&(ht=!0);let bt=At.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(bt[I])?F=bt[I][k]:F=bt[I],z=!0):y.samples>0&&Pt.useMultisampledRTT(y)===!1?F=At.get(y).__webglMultisampledFramebuffer:Array.isArray(bt)?F=bt[k]:F=bt,$.copy(y.viewport),St.copy(y.scissor),Lt=y.scissorTest}else $.copy(Ct).multiplyScalar(mt).floor(),St.copy(Zt).multiplyScalar(mt).floor(),Lt=Kt;if(k!==0&&(F=V),ut.bindFramebuffer(L.FRAMEBUFFER,F)&&ut.drawBuffers(y,F),ut.viewport($),ut.scissor(St),ut.setScissorTest(Lt),z){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+I,lt.__webglTexture,k)}else if(ht){let lt=I;for(let gt=0;gt<y.textures.length;gt++){let bt=At.get(y.textures[gt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+gt,bt.__webglTexture,k,lt)}}else if(y!==null&&k!==0){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,lt.__webglTexture,k)}X=-1};function Hl(y){let I=At.get(y);return(I.__readFormat!==y.format||I.__readType!==y.type)&&(I.__readFormat=y.format,I.__readType=y.type,I.__formatReadable=ie.textureFormatReadable(y.format),I.__typeReadable=ie.textureTypeReadable(y.type)),I}this.readRenderTargetPixels=function(y,I,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget)){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt){ut.bindFramebuffer(L.FRAMEBUFFER,gt);try{let bt=y.textures[lt],Nt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Hl(bt);if(yt.__formatReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(yt.__typeReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}I>=0&&I<=y.width-F&&k>=0&&k<=y.height-z&&L.readPixels(I,k,F,z,it.convert(Nt),it.convert(kt),ht)}finally{let bt=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,bt)}}},this.readRenderTargetPixelsAsync=async function(y,I,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt)if(I>=0&&I<=y.width-F&&k>=0&&k<=y.height-z){ut.bindFramebuffer(L.FRAMEBUFFER,gt);let bt=y.textures[lt],Nt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Hl(bt);if(yt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(yt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Gt=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,Gt),L.bufferData(L.PIXEL_PACK_BUFFER,ht.byteLength,L.STREAM_READ),L.readPixels(I,k,F,z,it.convert(Nt),it.convert(kt),0),L.bindBuffer(L.PIXEL_PACK_BUFFER,null);let ce=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,ce);let $t=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await ch(L,$t,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,Gt),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,ht),L.bindBuffer(L.PIXEL_PACK_BUFFER,null),L.deleteBuffer(Gt),L.deleteSync($t),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,I=null,k=0){let F=Math.pow(2,-k),z=Math.floor(y.image.width*F),ht=Math.floor(y.image.height*F),xt=I!==null?I.x:0,lt=I!==null?I.y:0;Pt.setTexture2D(y,0),L.copyTexSubImage2D(L.TEXTURE_2D,k,0,0,xt,lt,z,ht),ut.unbindTexture()},this.copyTextureToTexture=function(y,I,k=null,F=null,z=0,ht=0){let xt,lt,gt,bt,Nt,kt,yt,Gt,ce,$t=y.isCompressedTexture?y.mipmaps[ht]:y.image;if(k!==null)xt=k.max.x-k.min.x,lt=k.max.y-k.min.y,gt=k.isBox3?k.max.z-k.min.z:1,bt=k.min.x,Nt=k.min.y,kt=k.isBox3?k.min.z:0;else{let Xt=Math.pow(2,-z);xt=Math.floor($t.width*Xt),lt=Math.floor($t.height*Xt),y.isDataArrayTexture?gt=$t.depth:y.isData3DTexture?gt=Math.floor($t.depth*Xt):gt=1,bt=0,Nt=0,kt=0}F!==null?(yt=F.x,Gt=F.y,ce=F.z):(yt=0,Gt=0,ce=0);let jt=it.convert(I.format),Ee=it.convert(I.type),Mt;I.isData3DTexture?(Pt.setTexture3D(I,0),Mt=L.TEXTURE_3D):I.isDataArrayTexture||I.isCompressedArrayTexture?(Pt.setTexture2DArray(I,0),Mt=L.TEXTURE_2D_ARRAY):(Pt.setTexture2D(I,0),Mt=L.TEXTURE_2D),ut.activeTexture(L.TEXTURE0),ut.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,I.flipY),ut.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,I.premultiplyAlpha),ut.pixelStorei(L.UNPACK_ALIGNMENT,I.unpackAlignment);let Pe=ut.getParameter(L.UNPACK_ROW_LENGTH),qt=ut.getParameter(L.UNPACK_IMAGE_HEIGHT),ni=ut.getParameter(L.UNPACK_SKIP_PIXELS),Ae=ut.getParameter(L.UNPACK_SKIP_ROWS),Hs=ut.getParameter(L.UNPACK_SKIP_IMAGES);ut.pixelStorei(L.UNPACK_ROW_LENGTH,$t.width),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,$t.height),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,bt),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Nt),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,kt);let zn=y.isDataArrayTexture||y.isData3DTexture,ii=I.isDataArrayTexture||I.isData3DTexture;if(y.isDepthTexture){let Xt=At.get(y),we=At.get(I),tn=At.get(Xt.__renderTarget),ae=At.get(we.__renderTarget);ut.bindFramebuffer(L.READ_FRAMEBUFFER,tn.__webglFramebuffer),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,ae.__webglFramebuffer);for(let ye=0;ye<gt;ye++)zn&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(y).__webglTexture,z,kt+ye),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(I).__webglTexture,ht,ce+ye)),L.blitFramebuffer(bt,Nt,bt+xt,Nt+lt,yt,Gt,yt+xt,Gt+lt,L.DEPTH_BUFFER_BIT,L.NEAREST);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(z!==0||y.isRenderTargetTexture||At.has(y)){let Xt=At.get(y),we=At.get(I);ut.bindFramebuffer(L.READ_FRAMEBUFFER,_),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,H);for(let tn=0;tn<gt;tn++)zn?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Xt.__webglTexture,z,kt+tn):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Xt.__webglTexture,z),ii?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,we.__webglTexture,ht,ce+tn):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,we.__webglTexture,ht),z!==0?L.blitFramebuffer(bt,Nt,bt+xt,Nt+lt,yt,Gt,yt+xt,Gt+lt,L.COLOR_BUFFER_BIT,L.NEAREST):ii?L.copyTexSubImage3D(Mt,ht,yt,Gt,ce+tn,bt,Nt,xt,lt):L.copyTexSubImage2D(Mt,ht,yt,Gt,bt,Nt,xt,lt);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else ii?y.isDataTexture||y.isData3DTexture?L.texSubImage3D(Mt,ht,yt,Gt,ce,xt,lt,gt,jt,Ee,$t.data):I.isCompressedArrayTexture?L.compressedTexSubImage3D(Mt,ht,yt,Gt,ce,xt,lt,gt,jt,$t.data):L.texSubImage3D(Mt,ht,yt,Gt,ce,xt,lt,gt,jt,Ee,$t):y.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,ht,yt,Gt,xt,lt,jt,Ee,$t.data):y.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,ht,yt,Gt,$t.width,$t.height,jt,$t.data):L.texSubImage2D(L.TEXTURE_2D,ht,yt,Gt,xt,lt,jt,Ee,$t);ut.pixelStorei(L.UNPACK_ROW_LENGTH,Pe),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,qt),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,ni),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Ae),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,Hs),ht===0&&I.generateMipmaps===!0&&I.mipmapsAutoUpdate===!0&&L.generateMipmap(Mt),ut.unbindTexture()},this.initRenderTarget=function(y){At.get(y).__webglFramebuffer===void 0&&Pt.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?Pt.setTextureCube(y,0):y.isData3DTexture?Pt.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?Pt.setTexture2DArray(y,0):Pt.setTexture2D(y,0),ut.unbindTexture()},this.resetState=function(){q=0,G=0,et=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return je}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Ht._getDrawingBufferColorSpace(t),e.unpackColorSpace=Ht._getUnpackColorSpace()}};var Zh=.5,Jh=.012,Ya=new U(0,0,1),Kh=.15,Xa=Math.PI/180,Qh=60*Xa,Yi=i=>new vs({color:i}),Jg=Yi("#e8eaee"),jh=Yi("#9aa3b2"),Al=Yi("#5c6675"),Kg=Yi("#3d4653"),jg=Yi("#c9723c"),Qg=Yi("#8a6d3b"),$g=new $e({color:"#b3261e"}),t0=new $e({color:"#6a1b9a",wireframe:!0}),e0=new Zn({color:"#1f2937"}),n0=new Zn({color:"#5b4a2a"}),i0=new $e({color:"#1565c0",wireframe:!0,depthTest:!1});function On(i,t,e,n=20){let s=new Bi(i,i,t,n);return s.rotateX(Math.PI/2),new pe(s,e)}var ti=(i,t=0)=>new U(i[t],i[t+1],i[t+2]);function qa(i,t,e){let n=e.clone().sub(t);i.position.copy(t).addScaledVector(n,.5),i.scale.z=Math.max(n.length(),1e-6),i.quaternion.setFromUnitVectors(Ya,n.normalize())}var Za=class extends He{constructor(t){super(),this.shaft=On(.012,1,t,8),this.head=new pe(new ms(.032,.07,10).rotateX(Math.PI/2),t),this.add(this.shaft,this.head)}show(t,e){let n=Jh*e.length();if(this.visible=n>.012,!this.visible)return;let s=t.clone().addScaledVector(e,Jh);qa(this.shaft,t,s),this.head.position.copy(s),this.head.quaternion.copy(this.shaft.quaternion)}},Ja=class extends He{constructor(t,e){super(),this.believes=e,this.position.y=t,this.rotation.z=Qh;let n=On(.1,.06,jh);n.position.z=.03,this.add(n),this.limbs=Array.from({length:8},(a,o)=>On(o<5?.055:.045,1,Jg)),this.joints=Array.from({length:7},(a,o)=>On(o<5?.068:.055,o<5?.15:.12,jh)),this.flange=new He;let s=On(.05,.02,Al),r=new pe(new Nn(.05,.19,.05),Al);r.position.z=.035,this.flange.add(s,r);for(let a of[-1,1]){let o=new pe(new Nn(.02,.015,.05),Al);o.position.set(0,a*.055,.085),this.flange.add(o)}this.objects=new He,this.flange.add(this.objects),this.belief=new pe(new zi(1,12,8),i0),this.belief.matrixAutoUpdate=!1,this.flange.add(this.belief),this.bag=new pe(new zi(.06,14,10),Qg),this.string=new Fi(new _e().setFromPoints([new U,Ya]),n0),this.target=new He,this.target.add(new pe(new xs(.085,.006,6,28),new $e({color:"#1f2937"}))),this.stream=On(.008,1,new $e({color:"#3b82c4"}),8),this.sag=On(.004,1,new $e({color:"#1f2937"}),6),this.push=new Za($g),this.felt=new Za(t0),this.add(...this.limbs,...this.joints,this.flange,this.bag,this.string,this.target,this.sag,this.stream,this.push,this.felt)}update(t,e,n,s){let r=t("links"),a=S=>[ti(r,7*S),new Qe(...r.slice(7*S+3,7*S+7))],o=new U;for(let S=0;S<8;++S){let[A,w]=a(S);this.limbs[S].visible=A.distanceTo(o)>.001,this.limbs[S].visible&&qa(this.limbs[S],o,A),S<7?(this.joints[S].position.copy(A),this.joints[S].quaternion.copy(w)):(this.flange.position.copy(A),this.flange.quaternion.copy(w),this.target.quaternion.copy(w),this.target.position.copy(A).sub(ti(t("error"))),this.sag.visible=ti(t("error")).length()>.004,this.sag.visible&&qa(this.sag,this.target.position,A)),o=A}let c=ti(t("hand")),l=c.clone().add(new U(.07,.03,.35));this.stream.visible=s,qa(this.stream,l,l.clone().setZ(c.z-.05)),this.bag.visible=this.string.visible=n,n&&(this.bag.position.copy(ti(t("bag"))),this.string.geometry.setFromPoints([c,this.bag.position])),this.push.show(c,e),this.felt.show(c,this.believes?ti(t("force")):new U);let h=t("mean"),f=t("com_covariance");this.belief.visible=this.believes&&t("held")[0]>.5&&Math.max(f[0],f[4],f[8])<Kh*Kh;let d=2*Math.sqrt(f[0]),m=2*f[1]/Math.sqrt(f[0]),g=2*f[2]/Math.sqrt(f[0]),M=Math.sqrt(Math.max(4*f[4]-m*m,1e-8)),p=(4*f[5]-m*g)/M,u=Math.sqrt(Math.max(4*f[8]-g*g-p*p,1e-8));this.belief.matrix.set(d,0,0,h[1],m,M,0,h[2],g,p,u,h[3],0,0,0,1),this.belief.matrixWorldNeedsUpdate=!0}hold(t){this.objects.clear();for(let{mass:e,com:n,kind:s}of t){let r=.05*Math.cbrt(Math.max(e,.05)),a=s==="cup"?On(.045,.03+.06*e,jg):On(r,1.6*r,Kg);a.position.copy(ti(n)),a.add(new Oi(new gs(a.geometry,30),e0)),this.objects.add(a)}}};function s0(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;return t!==void 0&&/swiftshader|llvmpipe|software/i.test(i.getParameter(t))}var Ka=class{constructor(t){this.canvas=t,this.renderer=new Ha({canvas:t,antialias:!s0()}),this.scene=new ls,this.scene.background=new Ut("#f4f6f8"),this.camera=new Le(32,1,.1,10),this.camera.up.copy(Ya),this.azimuth=0,this.elevation=12*Xa;let e=new Ts("#ffffff",2);e.position.set(2,-1,3);let n=new Es(3,15,"#b8c0cc","#dde2e8");n.rotation.x=Math.PI/2,this.arms={without:new Ja(-Zh,!1),with:new Ja(Zh,!0)},this.wall=new pe(new hi(1,1.1,5,5),new $e({color:"#37474f",wireframe:!0})),this.wall.rotation.x=Math.PI/2,this.scene.add(new Ss("#ffffff","#b0b6bf",2),e,n,...Object.values(this.arms)),this.walls=Object.values(this.arms).map(s=>{let r=this.wall.clone();return s.add(r),r}),this.ratio=Math.min(devicePixelRatio,2),this.interval=this.drawn=0,this.resize(),new ResizeObserver(()=>this.resize()).observe(t)}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.look())}look(){let t=Math.tan(this.camera.fov*Xa/2),e=Math.max(.58/t,.98/(t*this.camera.aspect))+.45,n=new U(.15,.18,.45),s=Math.cos(this.elevation);this.camera.position.set(s*Math.cos(this.azimuth),s*Math.sin(this.azimuth),Math.sin(this.elevation)).multiplyScalar(e).add(n),this.camera.lookAt(n),this.camera.updateMatrixWorld()}turn(t,e){this.azimuth=Math.min(Math.max(this.azimuth-.006*t,-1.2),1.2),this.elevation=Math.min(Math.max(this.elevation+.006*e,0),1.2),this.look()}handAt(t){let n=this.arms[t].flange.localToWorld(new U(0,0,.1)).project(this.camera);return{x:(n.x+1)/2*this.canvas.clientWidth,y:(1-n.y)/2*this.canvas.clientHeight}}inArms(t,e){let n=this.camera.position.distanceTo(this.arms.with.position),s=2*Math.tan(this.camera.fov*Xa/2)*n/this.canvas.clientHeight,r=new Qt().extractRotation(this.camera.matrixWorld);return new U(t*s,-e*s,0).applyMatrix4(r).applyAxisAngle(Ya,-Qh)}draw(t,e){let n=JSON.stringify(e);for(let[r,a]of Object.entries(this.arms))a.update(o=>t(`${r}.${o}`),ti(t("push")),t("hanging")[0]!==0,t("pour")[0]>0),n!==this.held&&a.hold(e);this.held=n;let s=t("wall_at");for(let r of this.walls)r.visible=t("constrained")[0]!==0,r.position.set(.4,s[0]+.1,.5);this.renderer.render(this.scene,this.camera),this.adapt()}adapt(){let t=performance.now(),e=t-this.drawn;this.drawn=t,e<1e3&&(this.interval+=(e-this.interval)/10),!(this.interval<45||this.ratio<.6)&&(this.interval=0,this.ratio*=.8,this.resize())}};var eu=["hand is empty","holds it steadily","is being filled","something pushes","payload is changing"],$h=["","attached","exchanged","removed","filled","only a push"],Rl=300,r0=100,Xe=i=>document.getElementById(i),zs=new Worker(URL.createObjectURL(new Blob([Wl],{type:"text/javascript"}))),Cl=new Vs,Il,Pl,$a,hn=0,Ll=1,Qa=0,to=[],ks=[],eo=!0,tu=!1,_l=0,ja=-1,ue=i=>{let[t,e]=Il[i];return Pl.subarray(t,t+e)},nu=i=>zs.postMessage({command:i});function a0(i){eo=!1,nu(i)}zs.onmessage=({data:i})=>{if(i.fields&&(Il=i.fields,to=[],ks=[],_l=0,Cl.clear()),i.frames){for(Pl of i.frames)Cl.add(ue);hn=i.ticks,i.busy&&(Qa+=(i.busy-Qa)*.05),eo&&l0()}i.command&&(i.accepted?o0(i.command,i.at):gi("A Panda is rated for 3 kg: that would be too much.")),i.paused&&au()};function o0(i,t){to.push(`${t} ${i}`);let[e,...n]=i.split(" ");e==="attach"&&ks.push({kind:+n[0]===Ji?"cup":"weight",mass:+n[0],com:n.slice(1).map(Number)}),e==="drop"&&(ks=[])}function l0(){!tu&&hn>=Rl&&nu(ro(1.2,0)),tu=hn>=Rl,hn<Rl?gi("Both hands are empty."):hn<4e3?gi("Both hands were given 1.2 kg. Nobody told the arms."):gi("Your turn: drag a weight onto a hand, or pull at a hand.")}function gi(i){Xe("caption").textContent!==i&&(Xe("caption").textContent=i)}function Ue(i,t,e,n=""){let s=Xe(i);s.dataset.value=t;let r=t.toFixed(e)+n;s.textContent!==r&&(s.textContent=r)}function iu(){let i=ue("with.mean"),t=ue("with.deviation"),e=ue("with.payload"),n=g=>Math.hypot(...g);Ue("error-without",1e3*n(ue("without.error")),1),Ue("error-with",1e3*n(ue("with.error")),1),Ue("mass",i[0],3),Ue("mass-deviation",t[0],3),Ue("truth",e[0],3);for(let g=0;g<3;++g)Ue(`com-${g}`,1e3*i[g+1],1),Ue(`com-deviation-${g}`,1e3*t[g+1],1),Ue(`com-truth-${g}`,1e3*e[g+1],1);let s=ue("with.probability"),r=s.indexOf(Math.max(...s));eu.forEach((g,M)=>{let p=Xe("modes").children[M];p.classList.toggle("likeliest",M===r),p.querySelector("i").style.width=`${100*s[M]}%`,Ue(`mode-${M}`,100*s[M],1," %")}),[...ue("with.force"),...ue("with.moment")].forEach((g,M)=>{let p=Math.max(-1,Math.min(1,g/(M<3?40:4))),u=Xe("wrench").children[M].querySelector("i");u.style.left=`${50+50*Math.min(p,0)}%`,u.style.width=`${50*Math.abs(p)}%`,Ue(`wrench-${M}`,g,M<3?1:2,M<3?" N":" N m")});let o=ue("with.health")[0],[c,l]=ue("with.limit");Ue("health",o,1),Xe("health-word").textContent=o<3?"good":"not explained",Ue("confidence",100*ue("with.confidence")[0],0," %"),Ue("friction",100*ue("with.friction_shows")[0],0," %"),Ue("wall",1e3*ue("with.wall")[0],0," mm"),Xe("limit").textContent=`joint ${c}, ${(l*180/Math.PI).toFixed(0)}\xB0 away`,Qa>0&&Ue("speed",1/Qa,1);let[h,f,d,m]=ue("with.event");ue("with.changing")[0]?Xe("noticed").textContent="something is happening":h>0&&(Xe("noticed").textContent=`${$h[f]}: noticed ${Math.round(1e3*(m-d))} ms after it began`),h>_l&&!eo&&gi(`rme: ${$h[f]}, ${i[0].toFixed(2)} kg.`),_l=h}function su(){requestAnimationFrame(su),Pl&&($a?.draw(ue,ks.map(i=>i.kind==="cup"?{...i,mass:ue("poured")[0]}:i)),!(ja>=0&&hn>=ja&&hn<ja+r0)&&(ja=hn,iu(),ql(Xe("history"),Cl)))}function ru(i,t,e){for(let[n,s]of t.entries())Xe(i).insertAdjacentHTML("beforeend",`<li><span>${s}</span><span class="bar"><i></i></span><output id="${e}-${n}"></output></li>`)}Xe("save").addEventListener("click",()=>{let i=document.createElement("a");i.href=URL.createObjectURL(new Blob([to.join(`
`)+`
`])),i.download=`session-seed-${Ll}-until-${hn}.txt`,i.click()});ru("modes",eu,"mode");ru("wrench",["force x","force y","force z","moment x","moment y","moment z"],"wrench");tc();try{$a=new Ka(Xe("scene"))}catch{gi("This browser draws no three dimensions (WebGL). The numbers are those of the arms all the same.")}Xl({act:a0,get:ue,say:gi,view:$a,held:()=>ks,restart:()=>{eo=!1,zs.postMessage({start:++Ll})}});requestAnimationFrame(su);var au;globalThis.rme={pause:()=>new Promise(i=>{au=()=>{iu();let t=Object.fromEntries(Object.keys(Il).map(e=>[e,[...ue(e)]]));i({ticks:hn,seed:Ll,session:to.join(`
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
