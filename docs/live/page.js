(()=>{var Wl=`(()=>{var En=(()=>{var l=typeof document<"u"&&document.currentScript?document.currentScript.src:void 0;return(function(r){r=r||{};var r=typeof r<"u"?r:{},j,x;r.ready=new Promise(function(e,n){j=e,x=n});var de=Object.assign({},r),be=[],ye="./this.program",Te=(e,n)=>{throw n},he=!1,U=!0,w="";function Se(e){return r.locateFile?r.locateFile(e,w):w+e}var Ye,Le,te,Ne;(he||U)&&(U?w=self.location.href:typeof document<"u"&&document.currentScript&&(w=document.currentScript.src),l&&(w=l),w.indexOf("blob:")!==0?w=w.substr(0,w.replace(/[?#].*/,"").lastIndexOf("/")+1):w="",Ye=(e=>{var n=new XMLHttpRequest;return n.open("GET",e,!1),n.send(null),n.responseText}),U&&(te=(e=>{var n=new XMLHttpRequest;return n.open("GET",e,!1),n.responseType="arraybuffer",n.send(null),new Uint8Array(n.response)})),Le=((e,n,t)=>{var u=new XMLHttpRequest;u.open("GET",e,!0),u.responseType="arraybuffer",u.onload=(()=>{if(u.status==200||u.status==0&&u.response){n(u.response);return}t()}),u.onerror=t,u.send(null)}),Ne=(e=>document.title=e));var Pe=r.print||console.log.bind(console),z=r.printErr||console.warn.bind(console);Object.assign(r,de),de=null,r.arguments&&(be=r.arguments),r.thisProgram&&(ye=r.thisProgram),r.quit&&(Te=r.quit);var $n=4;function E(e){E.shown||(E.shown={}),E.shown[e]||(E.shown[e]=1,z(e))}function er(e,n){if(typeof WebAssembly.Function=="function"){for(var t={i:"i32",j:"i64",f:"f32",d:"f64"},u={parameters:[],results:n[0]=="v"?[]:[t[n[0]]]},f=1;f<n.length;++f)u.parameters.push(t[n[f]]);return new WebAssembly.Function(u,e)}var m=[1,0,1,96],o=n.slice(0,1),s=n.slice(1),p={i:127,j:126,f:125,d:124};m.push(s.length);for(var f=0;f<s.length;++f)m.push(p[s[f]]);o=="v"?m.push(0):m=m.concat([1,p[o]]),m[1]=m.length-2;var T=new Uint8Array([0,97,115,109,1,0,0,0].concat(m,[2,7,1,1,101,1,102,0,0,7,5,1,1,102,0,0])),h=new WebAssembly.Module(T),O=new WebAssembly.Instance(h,{e:{f:e}}),y=O.exports.f;return y}var Me=[],Qe;function nr(){if(Me.length)return Me.pop();try{R.grow(1)}catch(e){throw e instanceof RangeError?"Unable to grow wasm table. Set ALLOW_TABLE_GROWTH.":e}return R.length-1}function rr(e,n){for(var t=e;t<e+n;t++){var u=oe(t);u&&Qe.set(u,t)}}var tr=0,J;r.wasmBinary&&(J=r.wasmBinary);var Ue=r.noExitRuntime||!0;typeof WebAssembly!="object"&&B("no native wasm support detected");var A,ae=!1,Ze;function ar(e,n){e||B(n)}function Ee(e){var n=r["_"+e];return n}function Ae(e,n,t,u,f){var m={string:function(d){var g=0;if(d!=null&&d!==0){var L=(d.length<<2)+1;g=le(L),Ie(d,g,L)}return g},array:function(d){var g=le(d.length);return ge(d,g),g}};function o(d){return n==="string"?I(d):n==="boolean"?!!d:d}var s=Ee(e),p=[],T=0;if(u)for(var h=0;h<u.length;h++){var O=m[t[h]];O?(T===0&&(T=Ke()),p[h]=O(u[h])):p[h]=u[h]}var y=s.apply(null,p);function H(d){return T!==0&&ke(T),o(d)}return y=H(y),y}var ur=1,we=typeof TextDecoder<"u"?new TextDecoder("utf8"):void 0;function He(e,n,t){for(var u=n+t,f=n;e[f]&&!(f>=u);)++f;if(f-n>16&&e.subarray&&we)return we.decode(e.subarray(n,f));for(var m="";n<f;){var o=e[n++];if(!(o&128)){m+=String.fromCharCode(o);continue}var s=e[n++]&63;if((o&224)==192){m+=String.fromCharCode((o&31)<<6|s);continue}var p=e[n++]&63;if((o&240)==224?o=(o&15)<<12|s<<6|p:o=(o&7)<<18|s<<12|p<<6|e[n++]&63,o<65536)m+=String.fromCharCode(o);else{var T=o-65536;m+=String.fromCharCode(55296|T>>10,56320|T&1023)}}return m}function I(e,n){return e?He(F,e,n):""}function qe(e,n,t,u){if(!(u>0))return 0;for(var f=t,m=t+u-1,o=0;o<e.length;++o){var s=e.charCodeAt(o);if(s>=55296&&s<=57343){var p=e.charCodeAt(++o);s=65536+((s&1023)<<10)|p&1023}if(s<=127){if(t>=m)break;n[t++]=s}else if(s<=2047){if(t+1>=m)break;n[t++]=192|s>>6,n[t++]=128|s&63}else if(s<=65535){if(t+2>=m)break;n[t++]=224|s>>12,n[t++]=128|s>>6&63,n[t++]=128|s&63}else{if(t+3>=m)break;n[t++]=240|s>>18,n[t++]=128|s>>12&63,n[t++]=128|s>>6&63,n[t++]=128|s&63}}return n[t]=0,t-f}function Ie(e,n,t){return qe(e,F,n,t)}function _e(e){for(var n=0,t=0;t<e.length;++t){var u=e.charCodeAt(t);u>=55296&&u<=57343&&(u=65536+((u&1023)<<10)|e.charCodeAt(++t)&1023),u<=127?++n:u<=2047?n+=2:u<=65535?n+=3:n+=4}return n}var ir=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0;function ge(e,n){X.set(e,n)}function $e(e,n,t){for(var u=0;u<e.length;++u)X[n++>>0]=e.charCodeAt(u);t||(X[n>>0]=0)}var Xe,X,F,en,nn,c,rn,tn,an;function Ge(e){Xe=e,r.HEAP8=X=new Int8Array(e),r.HEAP16=en=new Int16Array(e),r.HEAP32=c=new Int32Array(e),r.HEAPU8=F=new Uint8Array(e),r.HEAPU16=nn=new Uint16Array(e),r.HEAPU32=rn=new Uint32Array(e),r.HEAPF32=tn=new Float32Array(e),r.HEAPF64=an=new Float64Array(e)}var or=r.INITIAL_MEMORY||16777216,R,je=[],ze=[],Ve=[],un=!1,on=!1,sn=0;function fn(){return Ue||sn>0}function mn(){if(r.preRun)for(typeof r.preRun=="function"&&(r.preRun=[r.preRun]);r.preRun.length;)cn(r.preRun.shift());ie(je)}function ln(){un=!0,ie(ze)}function sr(){on=!0}function vn(){if(r.postRun)for(typeof r.postRun=="function"&&(r.postRun=[r.postRun]);r.postRun.length;)dn(r.postRun.shift());ie(Ve)}function cn(e){je.unshift(e)}function pn(e){ze.unshift(e)}function dn(e){Ve.unshift(e)}var V=0,ue=null,D=null;function bn(e){V++,r.monitorRunDependencies&&r.monitorRunDependencies(V)}function yn(e){if(V--,r.monitorRunDependencies&&r.monitorRunDependencies(V),V==0&&(ue!==null&&(clearInterval(ue),ue=null),D)){var n=D;D=null,n()}}r.preloadedImages={},r.preloadedAudios={};function B(e){r.onAbort&&r.onAbort(e),e="Aborted("+e+")",z(e),ae=!0,Ze=1,e+=". Build with -s ASSERTIONS=1 for more info.";var n=new WebAssembly.RuntimeError(e);throw x(n),n}var Tn="data:application/octet-stream;base64,";function Oe(e){return e.startsWith(Tn)}var M;M="live.wasm",Oe(M)||(M=Se(M));function We(e){try{if(e==M&&J)return new Uint8Array(J);if(te)return te(e);throw"both async and sync fetching of the wasm failed"}catch(n){B(n)}}function hn(){return!J&&(he||U)&&typeof fetch=="function"?fetch(M,{credentials:"same-origin"}).then(function(e){if(!e.ok)throw"failed to load wasm binary file at '"+M+"'";return e.arrayBuffer()}).catch(function(){return We(M)}):Promise.resolve().then(function(){return We(M)})}function Mn(){var e={env:Ce,wasi_snapshot_preview1:Ce};function n(o,s){var p=o.exports;r.asm=p,A=r.asm.memory,Ge(A.buffer),R=r.asm.__indirect_function_table,pn(r.asm.__wasm_call_ctors),yn("wasm-instantiate")}bn("wasm-instantiate");function t(o){n(o.instance)}function u(o){return hn().then(function(s){return WebAssembly.instantiate(s,e)}).then(function(s){return s}).then(o,function(s){z("failed to asynchronously prepare wasm: "+s),B(s)})}function f(){return!J&&typeof WebAssembly.instantiateStreaming=="function"&&!Oe(M)&&typeof fetch=="function"?fetch(M,{credentials:"same-origin"}).then(function(o){var s=WebAssembly.instantiateStreaming(o,e);return s.then(t,function(p){return z("wasm streaming compile failed: "+p),z("falling back to ArrayBuffer instantiation"),u(t)})}):u(t)}if(r.instantiateWasm)try{var m=r.instantiateWasm(e,n);return m}catch(o){return z("Module.instantiateWasm callback failed with error: "+o),!1}return f().catch(x),{}}var fr,mr;function ie(e){for(;e.length>0;){var n=e.shift();if(typeof n=="function"){n(r);continue}var t=n.func;typeof t=="number"?n.arg===void 0?oe(t)():oe(t)(n.arg):t(n.arg===void 0?null:n.arg)}}function lr(e){return e}function vr(e){var n=/\\b_Z[\\w\\d_]+/g;return e.replace(n,function(t){var u=t;return t===u?t:u+" ["+t+"]"})}var S=[];function oe(e){var n=S[e];return n||(e>=S.length&&(S.length=e+1),S[e]=n=R.get(e)),n}function cr(){var e=new Error;if(!e.stack){try{throw new Error}catch(n){e=n}if(!e.stack)return"(no stack trace available)"}return e.stack.toString()}function pr(e,n){R.set(e,n),S[e]=n}function Zn(e){return xe(e+16)+16}function wn(e){this.excPtr=e,this.ptr=e-16,this.set_type=function(n){c[this.ptr+4>>2]=n},this.get_type=function(){return c[this.ptr+4>>2]},this.set_destructor=function(n){c[this.ptr+8>>2]=n},this.get_destructor=function(){return c[this.ptr+8>>2]},this.set_refcount=function(n){c[this.ptr>>2]=n},this.set_caught=function(n){n=n?1:0,X[this.ptr+12>>0]=n},this.get_caught=function(){return X[this.ptr+12>>0]!=0},this.set_rethrown=function(n){n=n?1:0,X[this.ptr+13>>0]=n},this.get_rethrown=function(){return X[this.ptr+13>>0]!=0},this.init=function(n,t){this.set_type(n),this.set_destructor(t),this.set_refcount(0),this.set_caught(!1),this.set_rethrown(!1)},this.add_ref=function(){var n=c[this.ptr>>2];c[this.ptr>>2]=n+1},this.release_ref=function(){var n=c[this.ptr>>2];return c[this.ptr>>2]=n-1,n===1}}var Hn=0,qn=0;function gn(e,n,t){var u=new wn(e);throw u.init(n,t),Hn=e,qn++,e}function Xn(){B("")}function Gn(e,n,t){F.copyWithin(e,n,n+t)}function jn(){return 2147483648}function zn(e){try{return A.grow(e-Xe.byteLength+65535>>>16),Ge(A.buffer),1}catch{}}function Vn(e){var n=F.length;e=e>>>0;var t=jn();if(e>t)return!1;let u=(p,T)=>p+(T-p%T)%T;for(var f=1;f<=4;f*=2){var m=n*(1+.2/f);m=Math.min(m,e+100663296);var o=Math.min(t,u(Math.max(e,m),65536)),s=zn(o);if(s)return!0}return!1}var se={};function On(){return ye||"./this.program"}function Y(){if(!Y.strings){var e=(typeof navigator=="object"&&navigator.languages&&navigator.languages[0]||"C").replace("-","_")+".UTF-8",n={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:e,_:On()};for(var t in se)se[t]===void 0?delete n[t]:n[t]=se[t];var u=[];for(var t in n)u.push(t+"="+n[t]);Y.strings=u}return Y.strings}var fe={buffers:[null,[],[]],printChar:function(e,n){var t=fe.buffers[e];n===0||n===10?((e===1?Pe:z)(He(t,0)),t.length=0):t.push(n)},varargs:void 0,get:function(){fe.varargs+=4;var e=c[fe.varargs-4>>2];return e},getStr:function(e){var n=I(e);return n},get64:function(e,n){return e}};function Wn(e,n){var t=0;return Y().forEach(function(u,f){var m=n+t;c[e+f*4>>2]=m,$e(u,m),t+=u.length+1}),0}function Cn(e,n){var t=Y();c[e>>2]=t.length;var u=0;return t.forEach(function(f){u+=f.length+1}),c[n>>2]=u,0}function _(e){return e%4===0&&(e%100!==0||e%400===0)}function me(e,n){for(var t=0,u=0;u<=n;t+=e[u++]);return t}var $=[31,29,31,30,31,30,31,31,30,31,30,31],ee=[31,28,31,30,31,30,31,31,30,31,30,31];function ne(e,n){for(var t=new Date(e.getTime());n>0;){var u=_(t.getFullYear()),f=t.getMonth(),m=(u?$:ee)[f];if(n>m-t.getDate())n-=m-t.getDate()+1,t.setDate(1),f<11?t.setMonth(f+1):(t.setMonth(0),t.setFullYear(t.getFullYear()+1));else return t.setDate(t.getDate()+n),t}return t}function xn(e,n,t,u){var f=c[u+40>>2],m={tm_sec:c[u>>2],tm_min:c[u+4>>2],tm_hour:c[u+8>>2],tm_mday:c[u+12>>2],tm_mon:c[u+16>>2],tm_year:c[u+20>>2],tm_wday:c[u+24>>2],tm_yday:c[u+28>>2],tm_isdst:c[u+32>>2],tm_gmtoff:c[u+36>>2],tm_zone:f?I(f):""},o=I(t),s={"%c":"%a %b %d %H:%M:%S %Y","%D":"%m/%d/%y","%F":"%Y-%m-%d","%h":"%b","%r":"%I:%M:%S %p","%R":"%H:%M","%T":"%H:%M:%S","%x":"%m/%d/%y","%X":"%H:%M:%S","%Ec":"%c","%EC":"%C","%Ex":"%m/%d/%y","%EX":"%H:%M:%S","%Ey":"%y","%EY":"%Y","%Od":"%d","%Oe":"%e","%OH":"%H","%OI":"%I","%Om":"%m","%OM":"%M","%OS":"%S","%Ou":"%u","%OU":"%U","%OV":"%V","%Ow":"%w","%OW":"%W","%Oy":"%y"};for(var p in s)o=o.replace(new RegExp(p,"g"),s[p]);var T=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],h=["January","February","March","April","May","June","July","August","September","October","November","December"];function O(a,i,b){for(var v=typeof a=="number"?a.toString():a||"";v.length<i;)v=b[0]+v;return v}function y(a,i){return O(a,i,"0")}function H(a,i){function b(q){return q<0?-1:q>0?1:0}var v;return(v=b(a.getFullYear()-i.getFullYear()))===0&&(v=b(a.getMonth()-i.getMonth()))===0&&(v=b(a.getDate()-i.getDate())),v}function d(a){switch(a.getDay()){case 0:return new Date(a.getFullYear()-1,11,29);case 1:return a;case 2:return new Date(a.getFullYear(),0,3);case 3:return new Date(a.getFullYear(),0,2);case 4:return new Date(a.getFullYear(),0,1);case 5:return new Date(a.getFullYear()-1,11,31);case 6:return new Date(a.getFullYear()-1,11,30)}}function g(a){var i=ne(new Date(a.tm_year+1900,0,1),a.tm_yday),b=new Date(i.getFullYear(),0,4),v=new Date(i.getFullYear()+1,0,4),q=d(b),G=d(v);return H(q,i)<=0?H(G,i)<=0?i.getFullYear()+1:i.getFullYear():i.getFullYear()-1}var L={"%a":function(a){return T[a.tm_wday].substring(0,3)},"%A":function(a){return T[a.tm_wday]},"%b":function(a){return h[a.tm_mon].substring(0,3)},"%B":function(a){return h[a.tm_mon]},"%C":function(a){var i=a.tm_year+1900;return y(i/100|0,2)},"%d":function(a){return y(a.tm_mday,2)},"%e":function(a){return O(a.tm_mday,2," ")},"%g":function(a){return g(a).toString().substring(2)},"%G":function(a){return g(a)},"%H":function(a){return y(a.tm_hour,2)},"%I":function(a){var i=a.tm_hour;return i==0?i=12:i>12&&(i-=12),y(i,2)},"%j":function(a){return y(a.tm_mday+me(_(a.tm_year+1900)?$:ee,a.tm_mon-1),3)},"%m":function(a){return y(a.tm_mon+1,2)},"%M":function(a){return y(a.tm_min,2)},"%n":function(){return\`
\`},"%p":function(a){return a.tm_hour>=0&&a.tm_hour<12?"AM":"PM"},"%S":function(a){return y(a.tm_sec,2)},"%t":function(){return"	"},"%u":function(a){return a.tm_wday||7},"%U":function(a){var i=new Date(a.tm_year+1900,0,1),b=i.getDay()===0?i:ne(i,7-i.getDay()),v=new Date(a.tm_year+1900,a.tm_mon,a.tm_mday);if(H(b,v)<0){var q=me(_(v.getFullYear())?$:ee,v.getMonth()-1)-31,G=31-b.getDate(),W=G+q+v.getDate();return y(Math.ceil(W/7),2)}return H(b,i)===0?"01":"00"},"%V":function(a){var i=new Date(a.tm_year+1900,0,4),b=new Date(a.tm_year+1901,0,4),v=d(i),q=d(b),G=ne(new Date(a.tm_year+1900,0,1),a.tm_yday);if(H(G,v)<0)return"53";if(H(q,G)<=0)return"01";var W;return v.getFullYear()<a.tm_year+1900?W=a.tm_yday+32-v.getDate():W=a.tm_yday+1-v.getDate(),y(Math.ceil(W/7),2)},"%w":function(a){return a.tm_wday},"%W":function(a){var i=new Date(a.tm_year,0,1),b=i.getDay()===1?i:ne(i,i.getDay()===0?1:7-i.getDay()+1),v=new Date(a.tm_year+1900,a.tm_mon,a.tm_mday);if(H(b,v)<0){var q=me(_(v.getFullYear())?$:ee,v.getMonth()-1)-31,G=31-b.getDate(),W=G+q+v.getDate();return y(Math.ceil(W/7),2)}return H(b,i)===0?"01":"00"},"%y":function(a){return(a.tm_year+1900).toString().substring(2)},"%Y":function(a){return a.tm_year+1900},"%z":function(a){var i=a.tm_gmtoff,b=i>=0;return i=Math.abs(i)/60,i=i/60*100+i%60,(b?"+":"-")+("0000"+i).slice(-4)},"%Z":function(a){return a.tm_zone},"%%":function(){return"%"}};o=o.replace(/%%/g,"\\0\\0");for(var p in L)o.includes(p)&&(o=o.replace(new RegExp(p,"g"),L[p](m)));o=o.replace(/\\0\\0/g,"%");var ce=kn(o,!1);return ce.length>n?0:(ge(ce,e),ce.length-1)}function Kn(e,n,t,u){return xn(e,n,t,u)}var dr=!1;function kn(e,n,t){var u=t>0?t:_e(e)+1,f=new Array(u),m=qe(e,f,0,f.length);return n&&(f.length=m),f}var Ce={__cxa_allocate_exception:Zn,__cxa_throw:gn,abort:Xn,emscripten_memcpy_big:Gn,emscripten_resize_heap:Vn,environ_get:Wn,environ_sizes_get:Cn,strftime_l:Kn},br=Mn(),Jn=r.___wasm_call_ctors=function(){return(Jn=r.___wasm_call_ctors=r.asm.__wasm_call_ctors).apply(null,arguments)},Fn=r._live_start=function(){return(Fn=r._live_start=r.asm.live_start).apply(null,arguments)},Rn=r._live_command=function(){return(Rn=r._live_command=r.asm.live_command).apply(null,arguments)},Dn=r._live_step=function(){return(Dn=r._live_step=r.asm.live_step).apply(null,arguments)},Bn=r._live_values=function(){return(Bn=r._live_values=r.asm.live_values).apply(null,arguments)},Sn=r._live_layout=function(){return(Sn=r._live_layout=r.asm.live_layout).apply(null,arguments)},xe=r._malloc=function(){return(xe=r._malloc=r.asm.malloc).apply(null,arguments)},Yn=r.___errno_location=function(){return(Yn=r.___errno_location=r.asm.__errno_location).apply(null,arguments)},Ke=r.stackSave=function(){return(Ke=r.stackSave=r.asm.stackSave).apply(null,arguments)},ke=r.stackRestore=function(){return(ke=r.stackRestore=r.asm.stackRestore).apply(null,arguments)},le=r.stackAlloc=function(){return(le=r.stackAlloc=r.asm.stackAlloc).apply(null,arguments)},Ln=r.dynCall_viijii=function(){return(Ln=r.dynCall_viijii=r.asm.dynCall_viijii).apply(null,arguments)},Nn=r.dynCall_iiiiij=function(){return(Nn=r.dynCall_iiiiij=r.asm.dynCall_iiiiij).apply(null,arguments)},Pn=r.dynCall_iiiiijj=function(){return(Pn=r.dynCall_iiiiijj=r.asm.dynCall_iiiiijj).apply(null,arguments)},Qn=r.dynCall_iiiiiijj=function(){return(Qn=r.dynCall_iiiiiijj=r.asm.dynCall_iiiiiijj).apply(null,arguments)};r.ccall=Ae;var re;function Un(e){this.name="ExitStatus",this.message="Program terminated with exit("+e+")",this.status=e}D=function e(){re||ve(),re||(D=e)};function ve(e){if(e=e||be,V>0||(mn(),V>0))return;function n(){re||(re=!0,r.calledRun=!0,!ae&&(ln(),j(r),r.onRuntimeInitialized&&r.onRuntimeInitialized(),vn()))}r.setStatus?(r.setStatus("Running..."),setTimeout(function(){setTimeout(function(){r.setStatus("")},1),n()},1)):n()}r.run=ve;function yr(e){Ze=e,fn()||(r.onExit&&r.onExit(e),ae=!0),Te(e,new Un(e))}if(r.preInit)for(typeof r.preInit=="function"&&(r.preInit=[r.preInit]);r.preInit.length>0;)r.preInit.pop()();return ve(),r.ready})})(),Je=En;var Fe="H4sIAAAAAAACA+y9e5hcV3Unuh/nVFX3qe4+LXVLJbUe+xwbqaTWoyUParUR7t7CCGXuzUR35n65ujMfVzKyHLnkh2wLokyEugA7UyFcqCQkFITE1S0SKmA8FV4psInLNoHiOYUCpoJfBSFQhFcRbFKACVdr7X3O2XW6JXrmY+7955Y+9Vnrt/de+3H22WvtN7npntspIYQ+aB06Tufp/HE6T46zefWHzh/n80DDXzp/PDGPPzp/3JpH3A54RZDAB1Ee6Pzx1Px8GIiep+ePJyOeYMALFy5cIMcJCV202AuYGHoeuAuRyAvH+fx5zZ2Hx4UL8+T44Py8ERGm4gIIUDKRtOfnz4d5OQ9+ziPPzkOy2HkA2fwFyMN5LSc9P98nF9N1ns4fd/pxI3ZyfGS+/0eiMiDH6XlIwAVMxvnzurx0doC3kVWZxvwhcF65q1DzOlsq9ZbK1IARHUMv/LzOEeSOQgEwLC8obnBWD4Ylyi5coK/Fv+eheC6Q4+xC8JYvYInPz9PXGpHQedaiKX7yjtdkjh07ce6mYzfddtudJ246e/LYyXMnTp45e+uddxACzo5yPnvq7jt/k1iAjJ+8/Z4Td9965uzJO47dfvL2E2d+69irbv0NYoPbGsPt7pP33PqfTx47dfKmM0qUfdOr7rz7LBld85s33XPrsXvuuOnMPafuPHvszN0nX3Pryd/cM3ryjtfceveddxyDYPcc+42TZwm/glcn8IqeQPbgPWfvvuXsrbefPHYbSfGP2Q/Zo5RSup2M0pGRybVjjGYSjO2gbIBTzi2LrqV0J7MYtQinFqNsYIDt2p3cRKfInkySW/jj1iClScuy1lpjGWuUMviXtBi4WGyvZTHGbHodY/9mM0talL548wi1rIGNA5QxRui+ZDI5mBwS0/uHbMsemhkbG4KfuN4bIiOEckYIfrmEMnvcT9rcIoQQbsODUkYo4YQTm4BHTgjnmuWEMJsRQiAtlDCLEOA44XycjxKaBJGcMRWEMQY0ZcQnZB1b57ovOfBSl7nrXNdN3jA750hu25xwEOylLGIdHLiGOTbnDiUOedmaNUmaSlo2/E8QxoY5txnnlCSItd5JJtYknISTWJMYuPbGxKZEMpEcsW1OE2SYJ7i1PgG/gWsTiUTSJoSlCOGUp5Ipe1WC2XR1avWLbGcVmUilCE0BBMiqiVSak0QiMZgYTAyk0mke0cODjA9jniApWxi3rGEgIffAD8OT8A1ka5bZiQ1bswl7cJBQKGLCOKVQsJRBzbAdx+E2tx07Ragm0qkUTdvpVIqQFEmn1X8KL4npH74shJb5R8kI4YQyxgm8F3wl4J/DbxsZsCzLZva2AcaStm0lk0meTFoDgwMDA4OQSELoCCWrhl++3krSM/Qh9hCzk5TmWT7PEgN0nsrmux4jTvIP2Gji9pO333n3bzEyeuzYb950z+3HTtx0223HTpy98+57SGrwtltfc/LYPWdvuvssGUojc+LO22+/6Y6byfCAdjt5hrgO0q+56bZXn7yHjCrutpt+685XnyWr1h07dusdN99698kTZ4/d8uo7TkB7cOzsTa+67SQliduxrSDvpu6xYyfvvvuOO49h0wFNxl/QgXvO3nTi9H+46TUnycN2Gpl/f/Kes3fefZJ8zB5EXmLwv7GHb/6tO14GCX/Nrbfmbr2VPBIht8IvR+r2SD+SI4/abh8E2GP2wL9YlEjqfJQNOOmP2o/TCwX6u/T19P30A/SD9EP0w7RGH6AP0I/Qj9G/oXX6KK3Tj9NP0L+ln6R59jr2M/p61qM/pj+lb2D3svvY77A/Zm9jH2SPs4+zT7AKfR99l/UX1jNW2/oH6x+tb1rfsr5tfdf6vvUD64fW89a/WD+2/tQqW39uvd/6gPVB60PWh62/ttq8Zn3E+qj1B9bfWI9Yj1qPWx+3HqCfsD5p/Teraf2d9UXrS9aXra9YX7AuWd+i/0SfsFrWk9bj9BK7xN5tVay/tN5jvdd6wHqf9aDV5v/Vqlp/ZV1iD1kPWQ9bD9IH6cesB+kl1rA+ZT1sQd4+bX3GusQ+a31O85+3PoPS/o59kT3BgPoya7GvsEvsSdZh32Nd9s/sn9lz7EfsJ+wF9q/sEruP/y7/v/mb+Vv4W3iR/z5/K/8j/sf8EnsnX+Tv5Q/w9/EH+Qf4B/kl9iFe4x/jf8Mf4XX+GH+cg/RP8E/yBv8U/wz/HG/yp62vWd+w/tn6kfVP1vcs5f53/Iv8S/zL/O/5U/xZ6+tWx3rO6lnfsbrWT62fWE9z+PtVfon9A/8H/nX894/8AfoN/o0rYN/k39RY56rYP/Euv8R+wn/GL7F7rTdal9jvWW+2LrG3WEXrgxSev299kD5O32z/nEJK30ffR//C/rD9AbtiX2Ifst9v/6V9iX3Q/q/2A/Yl9hH7Evtr+yH7jfZDl/8O3v/hdQ/Zf8Mpm7+GSPe0T64lbE4Qmc4JIlM51x4i8l1vZYJkWVqys9LKue+mPt3HiKAvHyKApxCx5sBflpHAa06SfYwEIHUTLx+iDrCIO4JIN3ctkfXn6E5CJL3r5dacrD1HD9Y+9tan/uyNDz77yPw0J7L6HD1IgKhcJvLq11NO5cCp/hyV9HpCHNlCiBHZDIhGQLQDovMcxRRcQ+QU5lcQECPUIyNIkIIvz07zrCAHf1pB4Cuz09ztZ1P9LJHd5+iNt+DviVlBZCYniPvbsvW8Tmg7IDrP04Pv+MA3Pvv2D3zjKRUwcOkFRP5HUVGAF0HkFJRX4a1Mlv6QQdHW/5DJ7VCWk0R+/DmaZcRDArMniAXvsfQ9knMHBcH/Feo4n6aUzcM7etMrPSoI+H3TKwW15gQKYEIHZ9acYBBCUPx7+UUXwhAFHSJwKR0NXEpHlQtKyzJrlOKrfnxvbgchkhyGRGVZba8KKZ/0+vCmp/Ad5IduCHbcAHRCTOXlAmXz8ouYc59Yc/D6hco7OMO7BxdMj/ysYtgha15Qm88JJsdOe0QwOXDaTAJRkXlMEEFfMUQCMY5HQIagoXxnHZHffo4GgaGGBQn73CCz5ukFdkGQGwn+ui87EdKE3HIXRPZXaeocJI5ny8Kz1H2L7bFriKzT0z69lggmbEnc1ZJ6XDB8jcKW1F0tmPzgUzQnyUsoJJ7sY9WnqGBQaWpAyPpTNIdVSDDZMOimQbcCWtZ+DJ8ffHuFH1H3te5rZcfJufOA628q/6/ah8CaWaPqWdXPin6W9bOkn0Uq6z+mgsoKzQkqizTn3iyo+W0VwKf+fL52uYrnDf7Ts9P8nBJ0Rj1OCXoQP5jPvv2Hs9P8uGz+BKT3CEhvEyXd+KaOGsKhvTgSOX8R+MNK7JwhFuD9Ef9t4Kdk+6cQTwPjmVLRfOfiV5//QvcnbfCQVXJEFN2lWWhGEHUNadhe6I+7+wLIzOQEdW+GAsai1u/C445gsv0UzfmWbP6YbuMoyJINTaeEBUWLNLzMHlSH1o8hje4f0fXwqp+mOVn9SeSlAUDFAOoAlA2gBUDNANoA1A2gA0AjANic4JLeNUSuUG90tRki/3+t+Z9ba6Cy5J+hubCqYJXAd2UAQX3pPg1NROGZeI1pPxOrMa1nYjWm+UysxnSeidWY7jOxGtN7xqwxqo3KPwt5qFNQZVpnUSAEQ5MCm2qtsyj+h+b0H29iL5pPnlcWytooJBPE/XPqc3nmV6w5Nod10vk1Cx5uTp65y09Cq2qLtSIpwXA4d/c+lhJrhQ1xrRV8H7PS1AHqeuKItZ4tOBgpwhZEcCgZR3Bh5yS5nhDBPCKJl7yGyC4/7TNoouUX30b3sXsZFODbUL3wfaxBBZfp02D0MNmguZz8OrqhUoX2+rNUsCxr0D5PvuPb4DgmbChsmgNRGYFYWtgHX1/O59tkmlkCErmPucKWIieJzLpvo+uFLTfk3AVLOGgjnZlmh/tSVwcKE5Z/KyowDobcgiU42EQZ9XDVIyW4t1G9rK5WLD2oNKl9LA+yuiChSbGwRc4f8QfFWt9+hTUvBt0fUdATtn4OCjvLUlDkg8LexsD6SnNH2G6XelTY7g+pl1Lv1EarMyUHfxWDpdwCE4OCipT7EIUyuJ6MiJQYBBU4knN/l8FbG5SDEOK0GNxJHN+RRDgiJaj7NtsRNtqWadYfmWNG5ohB91+on/oViBEqE6TScf+AgRDh9EXs9EcsUpKehthOS5qDwJafkgT89UUviS0GHahD8BJ3QIFl2ZRvy9Rd1rzgYsTtUjHi/pDm9rEdEd+l4G+H+x18TtnCdqR7F9jaHH37NnrCQCNixH2Ous/TvuAo0/0uFXwnmZIcwvI5yM1h/DR+/vOf/zzpfg/yh+Rpz05TxxG2isN2v0cdVVPrgWFBtaWh+QrwNZoLSnTwWiIGZSqn6rI/7DYovJUUfJTCCe02J8uI+pYckIbfngOAfhBHDIth8IRfRs5PZVnas7BCvJWpxApLWJL8rxOeLYZlJucNiUH5wT9mbpt5XAy6Fy1JvBSb5xDzkCkMvk4ry9L+iLCyzH2FNSdGQNtiKizASJZdO0qIb8n5VwwRydLMYXPCkpmzMvNqf0SSw1A+WQb69+f0LknP5nYSKgWUr8TK5ogR989sqB45L/ULEnDImgujzY4Ssl6lY0TCm01DG5RC65N6KUkcz4qKxh8CcaphGBbI+EPwdLFwrLtFauJu948YfCJQD9U7g/Tg64FPOec+SX0OmQlSt5O40gZ1TjzO5rhuTUUSyokLNslTM9CECy5Tl2veAxRSm4R2rEJ9+7TPJX+170ia81VLy35tiIqk4JK92k+JpEj9LxP4/qAJ6sF7/JUJP2XNi1Tg2xIpyc+6b7FtSRw/KRzJz+Z8J4w5ie45LyUcmcp5+FH9W2tOJKE9VE01EylVRYUDKRRMJPexClX12kaz/hcXAIc8VamHeXuAehw+Dff/JI68OO7+R9C2goFxso+VKdI1oN+p6AbQJWwsc7rv5SfdTZgJL8vmzH/L6ABIAsMvnWXZw1SwneRxTKWqgpIcnpCJV4AzxCp/vFom3Ptt5f0Bql8GPy0F+OGTnPhbwx7HzS8foqC+RFZsLWs0NXfy5UMWvFQs5C5TpDvDe5rMzPA8F8y0kDpMMLPT247xLSiIAs+JraArGJR2i+Xc3w4KpfkdklM+3HOC6PfbvE0Q2UKXbdxVvd228pjJ+UltQBDZUZjI+XaIdRWWzfmp0J5RJTHJiZf9n5W97PLZ63wFVHeYwejTIbL7FWrmrwdslLX8kzQnolwVgA0ylObO/3CFsaIK8/UxaS1bYdyrVRgoPRO1lqlCRBafojmw963oA0nB65WpnJ/ERo7gC0Fx7gb9dYjAiYATQadfUmbfPXyFzKbQDzaJlx/BkBL0LLhOsH7DXBVJNujBz948IbJhSZyYmORkhjefor+kBH9v9RUSnAnejpfF0vO2CoI9e6zN/nZVu6DbL7YiLbIzOBZAZAVA7aEceZAloLOKLsJ70H4KQEdC8nf8kvL2+MgyeQNn4m4USXcjfP3h8ASOw/3yyvWja65WEfpeMSG3gNiAdedOYCz4Zbv/CT7hp6huk3jUJinMNdop+MpT07yN76Cn3KHNCtongj106CGBkRNKaiiwS3K+E4L1p1WrcUrHpvwUac4fCf20FVigOX8wBFs6YJ6q3lgq5w2xeZX9vnotTxjVGkemsu9NUwesjuH/nvEhPXhlXUuEpa1GS/f5LW01WrrPb+k+v2X0+S3s81u6z2/F+vxWrM9v9ff5LdXnt1Sf31ra57ewz2/pPr/V3+e3Yn1+K9bnt1Sf34r1+a1l+vwW9vkt1ee3Yn1+S/X5rf4+v6X6/FZ/n9+K+vwW9PktkKc7zlHff0gMyyK9zR+G7n9ODxUB2AjYFLL1gCViCKQNQ/c/F9RH8FH9ifZxBtlKwJ5Cthywx5GtBew5JT1g81RFHvAF+ABgdEJE3wuMTYj4pwLjEgTHJYTxlcCohIi+DxiTENGXASMS5pfxjFnfCQ5HiOhzgMEIEX4yMNKbfxa6x8/+0trvVVdrZ1RLE35mr/L59eRDT4GGHbqGyKZ92h+4loikr4bZk+EwexJsXLBdwRyHtAzIMssJzDB8iGIAek5lKgaw3Uiq/hWCh8UANglcDEzyCoNWfQAbDgpAVQPkelKiYkArwuYn6/hWET+iHlkxIOk+dq3ihBgIqu9HsfoOQFV0xcDBF/7uE297+lOlClbfAYijfDmOPCQtz3JiQNZYzk+468UAVGPfEgPbeIlNYypqNOenAChqoAr9SAAKCgAyz7ARGQBDoePM8AbSsuvklCpWbE+zLcXm04ptK7ag2Y5ii5rtKrak2Z6OpfhKzAAHp6eJciMCqmo5YvUbkZWnSc5dLyyR0LUMM1TF9GNWKlFWyjorUHZCDLDzIrmTwIzNAEx0oeCjUAqaPg6RaPoIzJJNcgI9sAHZxJdefi4YZEtCGN0OJEGWbgQwpjM6qDPDT8lmh7hvsX3uJYQa1mrrmYfE5XqTgsHnR+E79BPw1k+JhKpS1k5yypoTCWjm/JSwtvHDKqvWNn4UIkXqCLZgk/y4t0UkIOZTIiG2zPDjjkgAfmaGnwEK62cqaCoAyMN7D9qSBMg6B/URnEo00Isl7VSkoD0UXaOocZCuUtQ6SFcoljTSZYraB+kuxfEtpDt0GioE0m06DXUF6RadhmqEdJNOQw1DukGnofIhXafTvE7FsLLPUvDYClk8B1kP9Mh3Ln8pJSYSgbn5wuw0LzKRAFurAE8wtpgqox5V7bwH4wxlmvOG2ZzYIrYs+NvF9leBeSKyIb1VbEX6Jm/IEUNywZEPD4HnRfC1CM6L5fL9bkZSecmVvzesG6DeLELPrpdfHbrxHW+H39/PuhlBwUwZUmYYhS7ViKZNOzkTsfm6Hgw3nPcLivlXX4o1yfN0BsawgSzQGRjdBrJIdcQfmRXOTkImZviUSMCn5I+KoDYj5UK1GhUUKuUqXZ1HIXFjKo3jgWdI/BqVB8cUkIE0g4D9gX20XzlMTfMpMSrnTgsq506HfUo6yacMm/BmkX17YCvNn7hLfi4tH1klsm5G2P3GY9zjA6Py94bRI53kGR/fiINBgBoPqHL5/qsIedNq+bZNKGQQAxiOMj8h3zCCbquw+knirWJzAs277WL7gr9VbA1rjKYp9Bmw2mwVW2/yVjlilfzaMFSb7WK7rjboRyfNzYjRMPVrtORFMYa9Raxe/pYo8dacGBVbxZb7/S0XZ3hWjIrtAighRkUWqYyDcxi+I4bxzUBFc3P+ILCuYlM53wY2hawYDl5LUMvuraMZlZAdlvNXh5VlNYhNK+mjIebm/FUqirEQS+X8cRXPmgCDPAtIJzz9bcbr2Nb3Or4HX5HYpt4p8beJbbpUgCqrYkFwNATL94fyuo+U337jC3/5g0u/+qojsyfkI4686KKw1WG48bBg8aWq0k4DBZ91uWxWFWtOrBZbRPZ+PwslK1aL7QIoV6wWW5FKidViG1LEESOB4n4MFxQMBeX5pnp/+SKfiaamHptVc1LKtfzeOlGTUtr7u1XwhCxyLH9dpGn1dao3kUVWBB+wEPo9qXeSQdYNPmUX2fDtpERaTsFUR4PgXAcWvFHnxJa+N3TvmCxvElvcjHovV/b4jXTgcfzqHt+4PvA4ttKoV6006tGVRk3BEMYGawSoLL5BoARQDlD4NQ0ChR+SDZT+hlLLfkNGy12oY7OYkAULPsbgJQ6GzSRSWXiTSAl4iYNh6zoYNtSD+gPWr24waF1NgfshKmg8ve2SeHbQZKGS082U2Xz1NVkayMQBEQeycWDKaPZwkuZfBkJtiV8ZxgNUuayiCFChUCU1AKe0V2wi6STf72+PetFie99rfN2QbE6I7crj3FU8vndMPqo9Bm9mEd5MnUZAsR5MqGvgXfVgZj1Qwz8PptZNoBQHinGgEAfycUDPrrfieJPGEtwwgI/Wgxl/M8gZZQe4/haRnOTldFkZDFvAbEUzvKzMBgCqAeBqoBYAGQ3UA0BooBEAWQ00A2BKUIixlRZbFmbAXIEqmpRtdEcM0pGUnQg4jEA3Ao4g0IuAowjkh0LgOAKFCAATummhWbeTZHCNlKU7Ko5KUXFoBkslKUtDqnNxDrmy5uBtQOlotqDYqmaLiq1ptgRMHRlvS1T074nXprfFalP3vbHaVP1U8PrAOi1TNeW37loiUr4dNhQ2rnPwNyE7hWw252/Wjb+tGn+hG39bNf6ebvxt1fj7uvG3VQtyjW5B7KjFCC21a41YoSPyIuQPIw89oiHkjyDfIkGP4ijybRIMnR1HvkNyvquHOjCuM1A3waVMc34GXcoUAeiBrA56ILZan+KnESgqAPozo0F/BgDoz6wK+jO2Wnqitd45FZ3uoNjY5R0HpIojGDZ2isGehedEkGPsO6fUGgp/g1kOYfeooWJqhsOBTQW0aM5fjwB8v8rigIbrhPyIKx8fCKyaM6b5I/90UL5OGTzXqBDXTnJihlAmz7IhfBXiRbEQq64cwlMhhmIhRq8cQqgQw7EQ6SuH2KxCjMRCrL5yiE0qhBsLkblyCCfmFLMif74msCIH4zJ+NAgaH5zW9zvdIv9snfzE2uWcwBDcJjaoDsWENiBF9sSEv2UxUjZzJ+XFzbKsJKyDT2y9CCrQOhFUsHGxHSxGgRJunnjHovun1M8uiG0iENSeXQynRMqL/jYwLoUNdug7FgVwFSrWiHXhIMj6qJJO8hZVla5BUfI7MECDOmKdmqtOsPPYPr7cmtORHJzztH2Uv2UOJ8mXmEyavmFuMbKO507epbML1lM29JSpY462LkCCl89R9qK3RQQzYTfUF0X2ojPDq4mo/34/qjgDQJO5nlA9+Fqif0nakX4W1pAZY2X7VeOfHw70TmE456ewDU8hXxzO+cPIu0o5DOf8IeQzSj0M5/wR5IXSD8M530E+C+phOOcPBkrAGPWeU+059LmbiZzvhi25q1ryUd2Su6olX6Vbcle15GO6JXdVSz6uW3JXteRrdEvu9tuCbtiSu2FLvtqIFVryjG7JXd2Sp3VL7oqMbsNdkdattwtttySynMB+QSY2gSm29n1z/7oWPqytQdtwZY+PjQUe3YOf/ZcXPvCNP6zAPEIhiY2lt1W4svC3RK8Kc3EmI6meZf2sJIWL62WSwg0rFnxR5fsv986K4FpGCfJxhkl35T98kuRwTB9y9Ul0uzeh3bqfQ75Co+6PkXr5yKB8cBWm176y05orO41f2Wnsyk6rruw0emUntJOvXPStwaDoV1/9Hb1tFYzBhB63h6X852HL0J3F2O6/6G8VW8TWmyewgojI67sW/e3YzG2/eeJiGFf1wKLuoR+fPSkf3SzfoxJk9RtSzUfq+Hn089kYL2J8Jsa7MT4V46FX3fkSyYktgrpbLzc3YFgcFQmZbwUVEMdlW78O3e8W0TOoCVky6LJBVwy6atC1kA7zqbNH+harkr5FqiRanNrfxEFHsg6GV/9wgNGspPublXR/s5Lub1bS/c1Kur9Zwa9yUqShOZsTaTEJRn1abHkHulx030nBgE9DcyKJ/Gc1iJAGe0nCoDeyZq9bGLrlLvm6dXJhWPXAoe5euav+qZTh0VRQt0Qep+TJu+SD6+XrVZ/eXqnHNSv1OL5Sj2Mr9bhqpR5HV+oxrQsIl+SkVSFM4qKctMroDlyWk1aZ2TYDCzPSKsHZGV4ERjU+M7wEDEa8fQaW7qRhQL0Nz+wMLNVJi20zvAnPHTO8wVTlqDNVV2rw3D7Dy1wkZPfp6GPoGHQ7orHj+8p4Q1B/uL8hUHw2xosYn4nxboxPxXhISu9p3RCMgc5uk2h2MyEbwDohWwd2JGRrwA6FbBXY4ZCtABsMECVgajY/PM3Lx0VCttqmJkrI9jeQ/0uq+UYnaobqHaM5MeiqQVcMumzQpU5fKRdPCUvOnVYzYgnZeoLkvKSwpIDec2InyR9F/HLE+aNO8EKSIqUn5JBywXxCKiO2LILthEwKrKakWjpd+EXf/vcywSeduvow3YMp+czGwGOq/yvAsCfvkn++WhZDP5nlvxQU9qVV8mOhRxgeQQFgI6bMxH1zXP7zBvSGM2xQElS2YX2ACCeRYYk7TCLDxDHOIsOMoQ1Lo3GTSYnmvBFZ3eI5asmnGIG1WLiW1FwWqSbBYfWuPwjr7W3wZ8EyVEsMweLrvjlxmO0eghXfajJ8JMtS2muWkdMydWgIVspCA+7I1hZc49ra4jmOgBXwAOCyszR39EMQWX0Kp7HtLLNy4QKWaC4d6h8s2F8DK07dNbBmNukE8++4oJ9BQTxABVerQHeQx6laksyyrEb10tCnrrKEv2Ms4dcL4EHMTyMxXSVmo/t+3FBxL8u5fwUrQbsc3kjS42JtuBB6bbDNbK3q9PARxx0hTorIPxuDRaZPcGbP0/OwCODfWnN8LtwpAbO0TG8+0BslfK4WmJJwRd4twVat5lOYder+J0EFcyeg3W0+Rf1EX8cRFxOJRDgtsSjzW2RpCy5p7OEuHL1kExbmwIAUm+Q9ims2abhmM8/U1E1b8wXNdzRf1LxerFliwdoTWDLvwTLJ//Hk4ZJLK0ygFSQQ49NrLoP09TQfpA9XXRrpw2WX/enjrqe2M+afpbg4G7ew6MRGycLO7VO0PAN/YUMIgzdrw5JoWxCo5o7zJQbv9cI1RAo11Q52jH657rFgv6IFK8P79itaK9yvaC2zX9Hq2w8J+UjB3lHcyriNpadh1w30VQJ77or7KTGoxx3wAPSYj04wA+DZSsYGDGGjTNhKMiY4Lh+nsOwdc8JXmBMOOcEYHQ96xRwWu4MHnTwPXKXAxs6pJNmAKtYi1TuYl9mYiXpKfl1vj4UFbt8GGsC2JqCt6ZHojTBM1zmfw+O8bx8aUttwvQS2lgm90VbZyBzaOA7NIayADZpD35rwGVQCKs/8mto/QLwkLgCnaq8Sk6O4VykFe5WoIHpNPOxVmoI9qPtYFpZJ7WM7YPCDCHY9uU4Qmc15VDBs3XClvbAmBNNflGBaK4M3KWBPAm5G5lmWdi8CM3faZ+gKOcvorco7yTU+NVMOjhtgnHrC/VPbR6Pb0s0gvHhG1M432NgDuzIQl/uDGKFVJPvYEbV3BBddYff/sCqx/bjBHNLkqjTBwCwkChbQwbZy5U52ktVLU5W+eqqOLkkV9JcGzWSd6UvWUX8Axn8xYUehPoiBd8MSK0jKDnKPzyBqilHfJhhs/xAUol+PzmEVPhXsVD4RQkcDaHUIpQLoP4TQ4QB6WQjtD6BrQigTQNeFUBYhLsdQQb5iiKaZg8oEHO+lPnyAygwItB/WaLVHG2t1bEc07/8uefBdUsF9hl8lCHA8rurmeSVVf28e1x8bfMTQHuMuOShODqaB88TbKB+dT5xn8LHmbdw5xObc1/ocdeO/U4kNF+lxtX1M1XtICX5k7p/YDgePQ7JBb/OtnI/VP+dbeloyCetycFoSKVethcrCssxsuOYxGa5DSoarjJCC9YN5qugCxYH8JOogXJoaLpmEb3pIJlWJQJoLzjQvQAtScnKX7aGSkwvXHhYRKRpIGZGyk4sWO5bSGCxtBEOkaCAFRAoGkkckbyA9FN0zIusi0o0QSG7HmeYdnfRyepqX07CEDaVVDGlVRKoGUkOkZiB1ROoG0kCkYSBNRJpmXoYwL0NGXhDJG0gPQ/WMUF1EugbSQaRjIG1E2um+/LbS0zDlh3RxaJoXh6DMMcaSEWMZkbKBVBCpGEgVkaqB1BCpGUgdkfpQXxoaQ9O8AfE20bVp+G8h0jKQNiJtA+kg0jHLB5GegXQR6ZqpHcbUDhs5QqRiIGVEygZSQqRkIEVEigZSQKQw3JdH6DvmhxVdG57mtWEoDfRZN8I2EGkYSBORpoG0EGkZSBuRtoF0EOn0p6E7PM27EG8PXXuG//wI1rERIxeIFAykiEjRQEqIlAykjEh5pC/eysg0r4xAmaNr1fBfQ6RmIHVE6gbSQKRhIE1EmgbSQqTVH297ZJq3Id4OunYM/11EugbSQ6RnIHkXy8Q1ygSRgoEUESm6ffGW3GlecqE00LVs+K8gUjGQKiJVA6khUjOQOiJ1A2kg0uiPt+lO8ybE20bXtuG/hUjLQDpuDgyuPiWTDJVM0lQyyX4lA4uzY4pGFkZzprKBBbf50ZxWOMD13JxWOsAVR2NaR7YAQc0D7m0V9pzy3VGcWsGelF3FFjTbG72qDpLdiVygh/Ctboirod5EXA0VNixRQ/mNcTXU2xBXQ90NcTXU2RBXQ+0NcTXU2hBTQ7K5IReoIkzNxlygjbDKbYwro9LGuDIqb4wro8rGuDKqbowro9rGuDLqbowro87GuDJqb4wro9bGuDJqbowro8bGmDKSdZXNls5mT7Ggk/C1bYqrpMKmuEoqboqrpNKmuEoqb4qrpMqmmEqS1U25QC1hsWyKa6X6prhWamyKa6XmprhWam+Ka6XWprhWKm2Oa6Xi5rhWKmyOa6X85rhW6m2Ka6XupphWkh2VTdBMWDKbc4FywmLZHNdN1c1x3VTbHNdN9c1x3dTYHNdNzc0x3SRbKuqujrq9Oa6eOpvj6qm7Oa6eepvj6ikv4uqpIGLqSRZFLlBRWP4irqHKIq6hKiKuoaoirqFqIq6h6iKmoWRDRd3WUTdFXEm1RFxJtUVcSXVEXEl1RVxJ9URMScm8lwsUFRaLF9dTRS+up0peXE+VvbieqnhxPVX1YnpK1lTUTR11w4urqroXV1VN75epqrreElXV8UxV1fZMVdXz4qqq7puqquGbqqrp96mqlt+nqtr+1VVVa0efqursiKuq9o64quruWKKqOjvjqqq9M66qWjvjqqq5M66qGjvjqqq+M66qajv7VFV3Z5+q6u2Mq6r8rriqKuyKq6rirriqKu2Kq6ryrriqau2Kq6rmrriqauyKq6r6rriqqu2Kq6rqrriqquzqU1XtXX2qqrMrrqq6u+Kqqrcrrqryu+OqqrA7rqqKu+OqqrS7T1WVd8dVVWV3XFVVd8dVVW13XFU1dsdVVX13XFXlp+Kqqrc7rqq6u+OqqrM7rqrau+OqqrU7rqqau/tUVWGqT1UVp+KqqjQVV1XlqbiqqkzFVVV1Kq6qalNxVVWf6lNVjam4qmpOxVVVayquqtpTcVXVmYqrqu5UXFX1pvpUVX5PXFUV9sRVVXFPXFWV9sRVVXlPXFVV9sRVVXVPn6qq7YmrqvqeuKpq7ImrquaeuKpq7YmrqvaeuKrq7OlTVd09cVXV2xNXVfm9cVVV2BtXVcW9cVVV2htXVeW9faqqujeuqip746qqtveXqapae5eoquZeU1U19pqqqr03rqoq15mqqnqdqapq1/Wpqvp1faqqcd3VVVX9pX2qqvnSuKpqvDSuqlovXaKqmjfEVVXjhriqqt8QV1W1G+KqqnpDXFVVboirqvINfaqqdUOfqmrfEFdVnRviqqp7Q1xV9W6Iq6r8bFxVFWbjqqo+G1dVtdm4qqrOxlVVZTauqsqzcVVVmo2rquJsn6pqzPapquZsXFW1ZuOqqj0bV1Wd2biq6s7GVVVvNq6q8nOnTVVVqJO4rioqyFRWJQWZ2qqsIFNdVRVk6quKgkyF1VGQqbHaCjJVVktBps5qKshUWg0FmVqrriBTbdUQivRWV/OB4uqpIKbmyj9K4qqroCBTdxUVZCqvkoJM7VVWkKm+Ko+SPv1VVV5MBVZTkKnB6goyVVhDQaYOayrIVGItBZlarK1TEKixjvJi6rGugkxF1lOQqcnyj5G4KisoyNRlRQWZyqz0GOnTZmXlxVRnFQWZ+qyqIFOh1RRkarS6gkyV1lCQqdOaOgWBUmspL6ZWayvIVGsdBZl6rasgU7H1FGRqtvzjJK7aCo+TPt1WVF5MVVZSkKnvyD5Wfpkg8l2PB+ubiIBtGoBVHic5jx+k3noOc9vr3w3nkgl68IaCoPcdfN+/funrX7zvZ5UWuSDWn/dRyXCx/iA9709c2eeE4ZOtyOf6g/y8P3Gwxv49zpmpEJi2XxDMOu/BUXOohqGsn1BHyWFl+DKu7npOrZAcDBagvUttDeznp2J8NsaLGJ+J8W6Mh9leWKgaLqjAAwXdMfe1nuW+Fg/EyD9JcuZGc3WIVoQV6kFlMcB8AHYM8B0B2AbQWIuPddTw+J7AY9MA9X5X0reVsvEf1QmIFvSy8WAOIktPqjV6GV31kIWFrJZxzJfyktJfqPIiDMuh+FSwNI7IgkHnDbr3ZER3Dbpj0I2n4LitPhOkriDTBqkpyDRCqgoyrZCKgkwzpKwg0w4pIRQZIupAEyLzT0dl2Q3e41NLse4yWOeppXWgvQzWWgZrLsHUGTtiED7xnqWeZf1sc83rZ4tdrrF6Syu5ntQtMXhQ7ab47Ldmp3nNCis0JraixXR08Ip+tpl6zsHjJfTKn5WqVlkxqI4IGTx4/xsffMt9X/7m78+p/bbselK1ZGEQVo3A6R1zOT99LZG1z6/DM2+vIbLM8FAZSeXXHLkwHH5ZePTD1xz5hyaEtddnfgIWOo4ZK3dFAlY0jptreQFy/TV90JgYWxTjYnxRrBFrcM/7mLlYMZ+SrRExBosVd5CMn5L0kEjJ+UN34xGibaKOjXJejkufBFjkbk4+PupeIx8S7rV4nhI6yLdsQnbuNGLyg8K9Vi2nciA8HHLF4MxROZ7zgRc5n8OqnZQk/w4X7+xUy2JoDk7zFanTXgqWyEHLm3LfZQsLg8Jax5T7JYYC4DgrWDuuY3VfpFh3C3HUeVKwawn2CBsZFpouPA7bkJ6ekN8ag8yzeUnBb9bwe9MQWS9JEIB0Z+EIsvUBn+vNnXTkp1fLbw2p0ttJmnAyfwLWoi8ToVpr/bdrYL8F+pdzp/GNrsDrJD+8Qn9HVujv6Ar9HV+hv1Mr9Hfmyv6KjuHv3Ar95ekKPRZW6rG4Uo+llXosr9Rj5Soef7wK9t9oj9WVeqyt1GN9pR4bK/XYXKnH1ko9tq/i8S0bjHLsrNRjd6Ueeyv1mGcr9FhYqcfiSj2WruLxXWn5gYmwPq7UY2WlHqsr9Vhbqcf6Sj02VuLRgda5xFXr3DJD3CLGUEWcvEt+fVR+ZUNY12Ji+7YBVDLyv4yHlY0tUcpdtlQr91i/WpYvjMr/tmGpctbViF85V49kYINdUI1W6rG4Eo9wtnVCL8tDKqW2+QfHpiW2ceFReGS99SKxm055DnAZb0Idyd5k6rlf2MJ5CYXTBtbrUwbU6QITYCIFqtKGY59QwH51UkoCjwycUtRxCIjUUQiL1BEIjtRhSKODWjQ8jSARniOGdInq0wAS4XlkSOulg0jrJYVIn1Mb/xPhOQOJ8JwxpPU5Y0jrc8aQ1ueMIa3POkNan3WGdHCUAKaF4RFjKi1sGo4ZU2lh03DUGNI9imf7I63PQ0Nan4eGtD4PTeWV4TFmqgzYNC9rGg62q2gazrurarrGpmGXlUo/m4adVypfbBp2Y9lg2jbhkH5tYOOzxHF1NH5LeJtAaKWqrVqTXHjjYkDtQRxQJrktKzznOTDabMN5zOp9t5h+4bAYX3e68A3KHgvOhOhhkuAkZ30oRFcBcLSUOhWiowA43EhtXixyBAo82L5YUECeB6dD5LnKW4mrbHip/55ciBRutzFzEKVdpboBMar01oFUKa0BqdLYBlKlrgWkSleTYwmJ8Ruvw9/fzS7O8CpHRH2pTUAqgAzgd1nTpKsiCs4zbc2qKMxDWlsxvgm8seG8AVc/yA6HvRrKBobB+uC0xJSiUngSqm4eMrB8G86ftG6sbbrv2/9b7cFZ2ONuqdOgChyHKbAPV+eXn0bXrsYV3tDPpn62Y/5aGu/oZ5erKHsJ9Wza6tnQz6Kt/BU0n7f75fW0nLyl/elnUT9L+lnWz4p+Vi0lrwbP9gY95mTJ4gY9OKOkujq3eBuQG2zYlaUNIVmOyEokJp+EAntKbXezZHMA2HrA1obDMNWQxNQN69SNgK+R0FfdILeHkXS3BWmF1UghGqWisyFn7hHWkZQ3QVo3hRJ720Iyvz0kC1E8zYjsTYYk2cdqO/RL39F/OnB9B+RsR+7gR0uP/f73/uqZxRt0AS2Fykuh0lKouBQqLIFMNg8paGyPZx8mAYMMtiKyGZENw8OOkGxHZCciuxHZi8jCzpAsRmQpIssRWYnIWkTWI7IRkc2IbEVkYVf08iKyF3noRmTHiC3yW43ISkSWI7IUkZ2IbEdkKyKbEdkwJOyOiiQiCxGZj8ieISFC6xFZi8hqRFYMCRHZjchORLYjsmVImIoyH5GliCxGZCEiWxHZjMhGRNYjsmZIiOpZPiJ7kYduRHYMCZHfakRWIrIckSXDwzDs4x3r2+ZnRac2jF2c4Z0NTtj4w2KP8OPfEZERmt8ZkVMhWY3QaoS2I7QdocVdEbknJOsRWo/Qboi621TLU9wAA0yyxIIG1sVjSWzNFtblIldbNl+M25jBAhhThg7aqQPaMN2vqONgog5owzSrqCNgog5owzQDVGCYugrer45eVmbmYUWB8XlEkWCTHlUkmKrHFQkW7ClFgmF7RpFn4IiYgcA6xWOXtXVa1nRDWb4DgXVa1HRNWb4DgXWa1zRYp+cU2VEG7EBgeNY13VMG70BgqDY1DQZsS9Ng2LY13VbG70BgkHaDqNi0OsNZG6R5ppOmDOGBwAgtabqujOWBwMjt4P02A2EdTc1d9MfDg3IX/TXh2bWL/toZJWbtjBKxdkZFMd7vJ6/dMFlr9YnTgZxPzS76GX1GdUYfXZ3RJ1qP9/tpaLe6fmIxrplRb2jNjHo7a2bUmxmfUW9lfEa9kXF1HrdYow3Ax2cX/XUz+MrXzWAlWIeHTYcWovZwVLkcUY/DKgcdnYKqlnxOuc6hfGWw/RmU1QxW6TUzWJ/XzGBlHjc8jM9grR6fwSo9PoOV+XKKU/AGoPvnWy+hlhgQ1ktotDfYWwMXboWHTDm6G4mUqw6idvQuMKRwZ5izje/3KDymvPXwyHoTIiXGINUp6DZm4bwq+PJS0JfcjzewwMfbUsZS6iAePJQybb4jCj2lHnna73pGwQWqnuWYc1HjFf2sx9yrGm/oZzvm3tR4J4Z3NZ5nOn4mUrICvSDVCPcnQnsqM2HJ173+XtggLFKKIu+FkFXYDy30ueDCgeEMdzvg37BzsuqLPuzTTk6Wru3HHhyFUuxuUKUoP/uWVdpYTMnyZ0ZzMqnoymfQ39+/VPsr/O4qPCUpofkmhKPKbwtlyPxG7XbvDyKZrQdWhTLbD6zqk1n/p36ZhR9EMos/6Jf58KXVoczim1eHMktAGzJ7n1ndJ7MO4bTMBsqIZD73gbFQZuP7kczm9/tlVt831iezB+G0zPwHx/pkPvBH46HM/BfGQpmFL4z1yey8ebxPZhXCaZk1lBHJ/PqPIpm194+HMuvvH++TWe72y+z8KJLZ/VG/zHe21oQyu3+4JpTZA9qQ2frCmj6ZZQinZVZQRiTzix9ZG8qsPB/JrD7fL7P4gbV9MlsQTstso4xI5pv+JBPKbD+xNpTZeWJtn8zGWzN9MosQTsssoYxI5sdfiGSWaplQZrmW6ZOZ/1G/zPYLGW05pWTToBsvRHG1Ihy/9p9lQNDPMrmDBTgwlqoQPfD1OzBBqUV0AbgXTpvSQAeA1+fz+SnFF3+WiZoMWfpZFPufKproGCsYY9XwUDPoukE3DLpp0C2D/rqRtTbgfbO2Kdn5GRZRMRkU+33rlvgp3YdW1xdwMQM7LwaklfMTOwnsfNbnqNTvrofqBMww4jsToI2g+KzQJfQrHEkPTYA+I8s6skMTYDWETWtxDt+E9ivqXjDIcmPd8cb6m+Aalh8UsMBhkXExJtbAkK1Yc2LCXyvGxNqbJ/y1C+47qTcu1ghFrYFP/L51OXAGwB9TwcLklctlfwzPZ0zJPHhcIwK2d++6HESjTm+UjYfW6eK35ccfWqctXLx+tP7QOrBaDQ8tg+4YdBsCUhWwa+A9FAjv05b5hyO8YNBFgyYvoeWHIdLSw8aLxVvfhS3f9TC+2Tcp89rGq4YeBd/VR+PVwJb1RyOxDYNuGnTLoNsG3TXozjKye4Z7/jEjWwZdMujiY0tllA33ikFXDbq2TLiW4d406IZB1w26vYyMzmOqY5LUHZP8p40y+dRS/wXDvWTQxU8vky/DvWLQVYOuGXTdoBsG3fx0VBdbBt426H9UtKp26F92gs5W+3Ohv76Bv89Bhel8znjZBp3/vFF3P7dMQRjuRYMm15Pq59epKln5PFbgzy8Nbe1jZXB0s+rqGDgeSF1JzGSZ5zxbJGEdgwWXEu0kLZhQSsPNgFPTeK6djcewTylKqMPzbLR0haJcdWSerUdT0/pWQVyLne47XnB/jJ+K8dkYL2J8Jsa7MT7lCCta0JWGBV1b4dZQOPnP0gdcJ+GIZEnk65WFndQ3JJaYIlNoniKpzFimZodgRNxbLxjMDiUAhNkhvP2oBUuw6mDqqnqTFImX0BrIWI8zE0lcyQfPCTR5me5/WyAFp4gsfavUlKJwiggpnCJCCqeIkDqsRqxZNEWEiYWedIUrGjrYZU2DLi5pGrrjRU1DL72g6XM4g4DkGZyhQBK64W0NQze8pWnohjc1Dd3whqahG17XNHTDa5qGbng1SA3DMelkcCRSUdPQ9y5oGvrkeU1DX72nw0Ifvqtp6Id3gtwyHN9WpcBwjFvFy3CcW6WH4YoplU6YGNI09MMbmob+eRPeJYV36qiXW4aPo22FL5fpGVd8FWq2BMk2C99ED/r/tk4/jAto+R0YL9B0kU/zkvZT4NO8qOk8x7F+TEPZ1mloA1CxzTS0VBqCC2Qs/blOKSqrKpCtO6GW/lwzinJVBbJ1BxbjagdxlROwntCGuwPD/ML5UDZmkqtjlSEDljp1HdJvqblQSL6l5kOhFLg6aR0KgauZVygDHkZZTjj6nV0OX8FPqmLBEUPbeNXy1sM9DSpJPUhSPWF8X+un4chj/K6qCUhi1wpeSc0KX0nHCr+othV+Ui0r/KaaVvhRNSz9VW3jdStMYg+SaMyj5ZMQWcXyLJWy303CqS3XkwI+a3jSblKWcPKjqxQCm+Rl6yqT7l9ZAyf+wWw2m+TVq/n862G9KoLPhW8FZjD52dwkb/fNg8uvrdN+nbB0Qq81M5Jb5DuG5N8Gs+R4dpjeiJKWc6fhsCu40/hNsIqy9Ey0trNo0AWDzht072ljjejTJOfbmnNf6+tFmuX/C2/VW7JOtPHMknWi9WeWrBOtPbNknWj1mSXrRCvPLFkn2vtuuMgajMQG3gX8DDFOZ1W3Bksiv0U0D5eWhjmOaBzyuAOWoz5DcnCxmVqtben9RnCldFJ2n1A5dPFqBu6OL6pdQ91hvCxhTFhwxFHn132GAVLYur+T5mSNnQFkm6rRUiHaF5xJ7a8/SN9w8FsfKH3mPd/+k9d9aP7CfWL9wX+F267fgOdrom4894Z7D9LCff56tf0I1lyLMbH+4MbCwS+950vv+RJ5g1h/n7/+4OjvHMznS9/915/f/+0fBNiLfkep16d++tsa2VcQ6w86hfs+Gp1frqnygcXwdPOyzmFlROcwvZI8/YIcpZfNEZ5U1vl1aKX/38tZbMtWeW9YN2rekmXAdS9aEx2RsE8goKtR+MreJeGLhk/YOhB3L6lDyauWWkWPZ5iJBC4Ih1Na/aSxJBzOafUtANT2BL0UvHYcqny7by24h5cQfhUxiKHJ9AJxuInQuEca7ikUVnTP5TZeOz7Ni6/UFxTC9gi1tNxWx9bZ6mhnWx3tbKsFCbZekGCsj07DQ13qjCvz1wjirr2M5eE4UefDFk2eh00S6h7hnnlMLDXPV6XmquAurEsWVLW2xOdGY8sFjc7kh0Voo7K2TnDlNbVyr+7KvWZW7lWs3Gt25V6nVugVb00ngi76HA65VZeoA2vB2DmyLrA2jKgjmwE2AePsyApgkzASj2wW2BSMzyM7BewAjNoTwd/hwj1CF2ewBbVC7rAgwg65I1DDQ+4oaKmQOw4nGobcKUHEQMidcd7BGbvA59WFrPXVPsfGFE7p4/HmCSDdPClfUMl9uqSBokEDZccbKKpskRXIBslsiWQWSLbikpk+mmgfq68W1Gzx6H0+jbd4iPW1eIjsKwh6xRbPvT/8cuqL9wtmxsF+SXHcmNl54//+U2/d3KL7VrrovP9FbGTeOg/r80dP+xytD5olZB8J90YJupNY1xN1hh8LNwJzOGMxtY/h1amq53YujccUwiXMDM/VjQ7yS6h9wMoVXj4zD/Ozw8P87PAwPzt+mJ8dHuZnh4f52cZhfrZxmJ+99DC/BOiPhNYfuCkXzoANTRTclAvny0YIGtrONM+n1bZe6LpH+325LA6hiLQhApGigeQRKRhIDwXlDaSLSM9ISgeRbn9SwHprp9V+1svd64ohoYJI1UCqiNQMpIZI3UDqiDQMpIFItLsX44VNxaUhyMsw5mXIyAv6zxtIF5GeIbODSNdA2oh0DKSFSLs/Xtjl2xxS+1KhnI1YSoiUDaSMSMVAKohUDaSKSM1AaohE+3oxXthOXBhW21ahNAz/TURaBtJCpG0gbUQ6Zpkg0jOQDiLd/nhhL3Ed4q2MYMqHjdwhUjGQEiJlAykiUjKQAiJFA8kjEm3qxXhhP29vWG1RhdIw/NcRaRhIA5GmgTQRaRlIC5G2gbQR6fTHC/uGqyNqYyqUj+G/h0i0aRe3pULKDaSASNFAioiUDKSESLRhF+OF3cKdEbUdFcrZ8F9FpGYgNUTqBlJHpGEgDUSaBtJEpNUfL+wRLrtqEyqUhuG/g0jXQLqI9Aykh0i0PZfjmXTM2J3L8eA6ZmzOxXhhZ3AL4i2ha9nwX0akYiAVRKoGUkWkZiA1ROoGUkek0R8v7AcujkJ9GMUG39h8y2VzVB3n3eoPAzt4G6OgcXBVt7oGanVoMC36Y+oqidEbj/5BduLx578/u1iGS9cbo/6qGw/c/PPFZ/74L2cXF9Si01VROLFajEZcGa8h5GJVJEWMidFIAHhojMJ17FTdTwB2eevLJKcvFga2GbBTyDYCNotsPWAFsrWAzSBbDVgX2G288n+AJQ4uncDlMLLdgD2CbC9gjyILF8Toa5KALQTsKWSLAXsG2XYQdk5p6RSOmGBfW7GeJcur4LZwKqvb8NRvAOHiTlTahuq3tb7HcanoDBB7idaHU3VB7yeUxk/k/IQezsYl4hml+4OFwDZsAEz0afwEavxz4ar6vLHYvmAswocF+XDTAazhpsaRIRTGApTKp3hCLwtO+aB4PK9pAVA81Ne0AKisODGtT2U53a/1qTYNigaijIuCgRRiWp/iob6m1qd4qK+p9Ske6suCzbUUT+5lwSkfFI/tNe0Aisf2mnYAxWN7TTuA4rG9ph1A8dhe0w6gspXutwOotnUi3U+1rZM3kHxM91Nt63QNRNk6HQNRtk7bQNoqmy2dTTi/lwWnfFBt/ZSMeJX1UzYQZf1UDERZP1UDUdZPzUCU9VM3kKaKuqGjVmZK0/CgTJmWgShzp20gyiTqmAUVMwioNqS6ZoKH+40Aqs2XioEoE6dsIMoMKhmIMpWKBqLMqYKBwBm/LDjYg+JBviw414NqM6hu+FdmUMNAlBnUNBBlBrUMRBk9bQNRhlHHQHoq6q6OOh+zDKi2aSLLgGq7p2AgyjYqGoiyn0oGomyssoHAcb4sOMmDamOoanhQxlDNQJQxVDcQZQw1DEQZQ00DUcZQy0A6Kuq2jlrZQx3Dg7KHugaSj9kHVNtDkX1AtT1UMBBlDxUNBA71ZcHZHVSbRGXDgzKJKgaiTKKqgSiTqGYgyiSqG4gyiRoG0lJRN3XUyipqGR6UVRRZDVQPeXXh3kA8gheWqqWiMhlVe8r9gahQEMoEd6RiqYyqXea+ExWLPsBXX0SI5YLQVHDLLJaNOql3vy6XUbVZ3E9EBYMQXHDIoqJBDC45TEaFg1h0ZS0WBmKd8NpaLDLE2uHVtURSVMeWeTHOzbDxPQ4MxIHBOODEgXQcGIoD1iTf3w+ofedxT4fjwJE4cDQOHI8DpyIArvHGW0s6o4IK+3rSHoVvZFSPz1I4Mjkg86tCshCRxYgsrTJuwPNHjTmZhQ3yw6vEqLoEcH+f04fTcF+3dkpdIVQiLrAvlHuFUOyqoTJXCJW8aihxhVDDVw2VvUIo96qhpq4QauTKoaiHUy+lox6MAFr7WOmosNGotLOMZJk1SmGAZgd5Aw1vpzinL8Boj8I4dNth9vwwjFk1bXXFDpHlLxOc9oDpoN6ziobzZEoah6NnuhofAONY44Ngc2scphUKGoeLEtoahyN08hqHA+dbGofD2HtPKBoOKm9qfFSQSd79dW8VPBvHvNVwC8ekOrwdpqp85o5Dj2QVdDNKNrhCaw/DvegyKlxwKSuXruEyIobBpaJceobLkEiDS1W55N3IxRGD4FJTLgXDZUCkwKWuXIqGS1IksAsEb0jN06nbx49BiT4L96XIdgBi6SusY2IVhXVNrKqwnonVFJZ/1sDqCiuYWPFZOJJJELnwONxYRvBIJOaO3/jbYw++4qv/+ezsIhRy8VhZpXOpUwmcSss6lcGpvKxTBZwqyzpVwam6rFMNnGrLOtXBqX7MUbeSYwHDRKbPwtkjuG7pXDR3pK8rVxffwJKVaOYIrx43bhf5KmJw6aWeOaKwTAr6eH4QG4M5B/d1WOf+Ab3DRFOBw+wT3OdS/qaKsWzpqSbNlzRf1HxR8wXNFzSf13xe871vKL7H9bS05ruar3wTZ8fgjnQdoqolVDVf03xN83XN1zXf0HxD803NNzXf0nxL822IEW9lb2uko310NN/VfDfIg+Z7QR47Oo+2LgPNFzRf1HxR83DmFSgfGw7AZLAOxF23XhA1IdK4TQ6ekftvy/kMpxV9C0r97zGNagB+JyETPscPIQ+vvgCvnuM1hxibZl3FljSb0Z+mZoX+KjWb1R+kZqfUiImtvzaGFzdC6L8Pv0CGFzuCCBOrKqxqYjWF1UysrrC6iTUU1ogwqi4udN7EKJs3zgwifWcGCbrkyCDBljsxyMWLwgRxO9SngrrPUfd5qnAb8R9Sj+EtX0QS9x+ZByMKHEuGzcMNWzBfVB4Xtvsp5lM19kEF+9UhJnDvEJP0rKR3Oz5znwcAbtqBKGD+Ca6oYkQtM0jhlKr7fRikwLsAiVuCW6UU84sOHnJeGGFz57E84OqzQ3Dak/cKeFdT3rWohL0X4Tv0tsDjlLcVHmXqZeHZot42eBaZtx1Hypg3Cc8893aAjKw3jOrfG8Fq4bnwOO5thEeJejvh2aTeLngWmLcbnnXmTcGzx7w9IEN4o2h4eKuwpnmr4XHU24TxUm8vxku96zBe5v0beNaY92J4dpm3D2RkYE0GPMax8npr4HHE24zxUm8a46XefoyXejPwrDLvenh2mPcSkOF6a9HY8jL4PXjr4HHYExgv9Q5gvNR7KcZLvRvgWWHeLDzbzJsDGSlvPZp53gR+Yt4GeMx5HjzOeRKjpd5BjJZ6L8OiZt6NWNTMe7k4BJSavPWTi8DsV7PZKWTOqPnqxGIZxy0rVE1KD6Bjm6p550E1qFliam7ZQccmU9PH6UVY8O2jAqIL8CD+0EW8bncBzVr8ihf8a8CpQ8vhMgoYFj0qDokNIrkoPJFaFFJgOg6KgUXxMgGx3iicRfFyoeLYgJqMLgglPuV7C2JCrF/w16OB0yfan4BZ4ENiHQgXIPyAEv5SEH4DCp8F4XNa+DrUhaFw1xcLIiPWLvhrwaHXLzwDk8qHxBoQvhmETyvh+0H4DAq/HoS/RAtfg5ZXKDzjb16AZfAL/hg45Fmf8HGYUjwkVoPwTSB8rxJ+HQj/Nyj8xSB8nxa+GmQ0Q+HC37QgVonRBR/tvkK/8FUwenlIuCB8IwjfqYTvAuG7UfgUCN+jhbsgoxUKz/obF8DqW/CH0brpFz6CO/0OiS0gfStIzyrp20D6dpQ+CdJ3aOlJtEND6VN+YkG8SFy74KfQQOqXPgD7Cdmc8I3DZuDQig0xfl2MXxPjV8d4N8YnY/w1MX59jF8b48di/GiMH47xqRgPX04M8mK8iPGbY/ymGL8xxidi/CE4Ni0hEgvw51VDREyIiZDOiExIj4vxkF4lVoX0iBgJ6QExENJkJynDzMkhfQ3jEUVNwXzCIdAwBFeqEgULmMtAKgPTGEi5MDqPVApG5w+phT5wYa4rDolDMGwB13QCKXKg17g4BMMw6iJTXLIC9wZbmkr52DBhC0b0tAuuZLEm1a3uKeWWKs/gDAgua7FwbcvlFly5ueUZnCjBNS4WLnS5rCGUW6Y8g3MquODFwlUvlzWQchPlGZx+wdUvFi6BuazhlFu2PIMzNbgUxsL1MJc1qHKbumzWT0FnEFbMwrmBKdz9S8Qw7v4lYhR3/xLYxZOHp9rxS8R63PFLxDW4b5aIJO72JcLF3b5ErMbdvgT2xzbguQ53+BKxAXf4EuHDPltJvFc44pC+WPEVzp9wZp2359V96ky1OBwec75VLvt23w57Iuxo0cf9Pou+Z1wmFLKCXVSysEz2L+AKO7xvWBeFC1AqgFK6xGe4OwIFw6AbccJPCEtQkZBcEpGYyKm1ruTmCT+hjrYVCWkjhCTNSX7GT2poASeHFJYKsCumHTs/Iin5bf6ASAUxCSpSAA2KZAAt9GdRZRsCns1BVqBnCyGShoiEGAi4so4qZfhP9Xkd7PPqvCHFEueH5tXplCm1ekZ1lV8ZLNOjoaFe1qw21Cua1YZ6FVkYmByI+sYKy+b8wahvrLCpnO+EWENh+3N+OsSaCps77Q+FWEthMEQ5HIJtBcIY5UgIdhQIg5RuCHZ1io/PhKuNVf/RHw39wHJkGJ8jOX9VCBaeUQHPzYRLmVXf1V8d+ikpsEBz/lgU8EkVMBgDeLKvQEtP9hVo+cm+Aq0AG5VlFY/djYoW2KgE68BGhdcANiq3JrBRibWAjcqqDWxUSp0n+0oJzuoVUfnAMb4iKhk44dcoGTj8V0RlAucCi7A04MJ3uLIZ9q3LTM6F9foDmH9PfaUehxlraCdsYS/4lrBAJ3DBQ5oJhvRN3gBcE7/gyIeHYORtEXwtgrM6OU5SecmVvzesv6aeOk/22fXyq0PhCQmwSDE4++k7s7ibJzwu+QW145wIpptKrptKG5tKGLD2ODxSHoOH69nwyHiWpPJ7RsypOTdjpE2l1RLWIlgz94fXiHcfKb893DRwQj7iyIuuSMBQaf8BJCJx0bNg2viiZwsOD+iQJy56zFGJ7LDYmc8FuAPXmoHNOir1Oldd5ogUnhzrNBnj5+m87D5PMV+ypwhL5n+EBHTk69+FVXG6JZvhtduhHn1XdYDbRK1Sh7qkaMgjkb2AAQHFryqmXC4LduOjays/XvXl7z+yWNY1FMXfuOMzv/eZB9/8ERhpwrGjQGzLFNs1xRYisVpUQ4mK1k5AL0CtMGiaYjqmmPwSMbDifydRI7Ld7xrnVRt0O6QT0MNHjdu73XG2kmg7QCfYDqAFoj+i/F1ijM5THAmmp30G9wzDhEDgEbmL4XAhwyEwddW97D5HXVyviJ9O8zboYTB9ub1azIhsJ2DzFPnWd8JFFQzaKn3dfXTR/SSv3Y73K/eep3qJB4N6oFd/MDW+wKCy6K1kDJZ/w43YKp86mUylzkw/WZJ2EqQda1WUuBSyYVZcZMOswFXgYknKmWyCxeE8YdGB81qP+WoFzqKfwg7tolqRk1r0B9CI07y7CKs74Fkuq45iEk26RdWxS6Attqg6Yg72iOHrTcOXPCDQq7so0FcWhquhvw0ehhYX/EE0+mB4GyPDrrXqVWcu93TQWLvcvymX/cTigp9EKxBEDSyKlEgvglkMxh/UyndozY4WH0TMIB0CEw7RCYzqMIx9s0l+BKSwy1a6DpoKgh7XQU/poGfCoOd00DzVYQtUB3aDwEWqQ5eoDl6mYfgK1QKqgYBaICATCKgHAhqBgGYkoBUIaAcCOoEAEQjoBgJ6gYA8CwUUmBZQZFpAiWkB2UBAmWkBFaYFVCMBtUBAPRDQCARMOW9MUOc8fLryC7BNyyOBroqampuhb0QEu99XDWV0XBTYcjMcjXE0R1m4LB6qGLB6WTxUMmATqtTAWgY2qcoADV6G6+CV4YuqZeFKSdi/NAkVnQTQJXxxAYTZat08neSHoRYrcEAtn7/8eR6BKq7AQbWKnk7yoyIVgAxGZSiMDIFaW0ANt2BuElAp4vdDjs+YKeIXAarqFJ0TCQw/AOEFX/QdGHpAJ3XT+eKCGAzc0jhygI5wag06ssCR40FCFEenEiKBMgcWF4QjnMUF34qnzLofCr9CzaRZF6FYajppVbS7MX6QkwY5wsZ3VtWpqEEqEpgK8MIDLwnsGlEcG0uKJMoYRBnpxQVVYmYXSKXIvh9ib/elyMYU1XWK4CgdlMZQGkdpqvxUujoYaYmJlEihN4beOHpLhFHHK4467DSsQGASmTVohjfA0HA6FYtvPz8zn7wAR/inT/sHriXigB6PV+omgXwl4Hs28uWA7yq+FPAdxRcDvq34QsC3kN/G88enedMWB2QhkdMzRsFc0QHZgm1MqOSDOaUDcI6knpDT6xIOyAZCNROqI1Q1oRpCFROqIlQ2oQpCpQgi23jxmHezOADL6tQ5EwdkZ1BvHjwgyyEpbp7m5QFxANjuoHpWB8UB3Jiv+Ra4l2jOnzqoIyzSnD8ZMNDZ2Bcw0B3ZEzAw5vHigIHOzA7NqGOgDoTzagdkmebUDdTBTN5hSDHJiQMwzXZA9gZzkG47589oS/6AzDuAwf7inSFWQKxq5/y9IVZErGbn/OkQKyFWt3P+rhArI9awc/7uABMHJnnJnuHdQaEzr7OtM6yzqjP5i7LX9HIili9YG6njwJfr5ESUwZqTE1HW6k5ORJlqODkRZafp5ESUkZaTE0EWfgnJru1dkux2f7I7fcnu9iW715dsWLAZJRsWdEbJhgWfu6N+2pte6e2D6ZrkaX/PtUTsgWzaOf/FOBJ3RuwRL8ZhuFOKErCAF6kMrOxFyoWxO6RSMHaHFKzdFXtwe82L5f7wu90jGxyQAg8/2xdv4y3u3QzPNvdOwrPDvVvg2eXeb8Czx71T8Mxb3q3wbHIvJ/bo82/3iFtxv/4ecQr38O8Rv4H7+veIW3Cv/x5xEvf/74FvsGSpcA3gc3i+wIt3kiZsgN4jG1bOnwT5an4YyRJu/EayiBu/MXcw3du1FA1TwR1Nw0R0W9MwxVuwFQ3Tv3lNw9RwD5JBIfmOePEkb8G+dkxXy1bPMnimuOJiD3yO3iSks2T7U9acSk07SiNM3U4pEmZ1s4qECV+hyB5uZEeyG+Wno/KDxxnYjoq3kFTPtg3xNRJYLm0bXlnZzskK1W+RgldHTL0ck7MPJ/2nFHVKpWAfnlMhFHVUxb8Pz6lwFXUYYp8U+4JzKkiUlH1ZRry9kniTkni7oMeUPO1PQ48JLizxdkgorbnT/tSS0fD1koqpSZ5aFnWXRTPLomJZNLssOhVD+ZzYIabEpJy6DdvR/X2n4s+olWj92CQ/HAeOxIGjceC4CXg7xCQsIZ9US8gl9WbYnNgBmn4KDsw3+siXs1c2+DIANRMIyVep0MVY6Eo8dP1qoUux0NV46MbVQjd5bD5iapK3lsHay2CdZbDuMlhvGSxvxTHdTkBp9rthJSgug5WWwcrLYJVlsOoyWG0ZrL4M1ohhDiS+BAvXpvCsksn++icm+7+YuwBw40AmDog4kI0D5odxV5AObFSm0Mb4/yQdAOyPA3Nx4HAcOBIHjsaB43HgVBw4EwfOxYE8jSOFJUhxCVJagpTp0qIHPWN0AuBap3DoTNVxSbwdDF4OXCUwiasCYARjEpcEwKgGvA8fOljl8rKDmThFii/JpzCsAW/Hx174JG48XyzHfVNB1XApdlh+kdgp39Ji9/u2FjuHCxSWiLUWsZMIA6dLnaFDpIZnE+h8xVgHYBkvDCGyxQWImUPAhKDAJWE0Fkd6FhcWzRPujPXAOxwJM1A7JrwZR8w4/swQASutzD2mXohHxbSYQlurrMksnmKMpMDdQkhmcBMRki6O8CGZgrE/pHCYb1pWaE5MweTK9YHJNS17PKfeaWByTWmTa0qbXFPa5JrSJteUNrmmtMk1pU2uabxozhbTYHJ1LTENJlcHnr+Bds80mFwteJ7Eo5KmweRqWCpcD/gcmmpBUzote1bOnwH5yuRCUplcSCqTC/MHJlfZVjSYXCVNg8lV1DSYXDVNg8lV1TSYXBVbTIN9UYcl2sYbuk6lrpBQzyYEobicNGgzp9EexvS0o1Qqo0ulHY0uJJXRhaQyupDsRjlSRhempJBwYIWWuG4CKoNs8pw3oxJRS6pnMRE2mNOymMipZjOwwlBILemIaTD1z4i9O0jmr326CCMvCJ0TwJxTTJ4ihxVnGkdSgC1otqjYomZLii1ptqzYMhV7BYP6W3t0HawZfXQdmxd7ZfnhddhcHPVcbCm9UWxBvVViUtk63mr8ZL0x/Ia9cWwNvDVoO3nKsPIG0erysJ3KeGm017wheMBCZrDpvBEweqY8Do+sZ8FDePb/Q967xjiSZelhjAi+MpmZxXp1Z3X29NyI7t3N3kyS+ajKZGZuVTGq65H9mJma1auk3ZVqtmrWJVZbrh7Nj7YxUBPQjs0FVgatB8Aqr90ka9emgZVNGDKGMCQNV7uwU7uWwB/yblrSGoQgrAgIglL2AqYBjcb9fecEI0hm9WNs6Y+r0clzzj1x48aNG/eee+554GfZTeIn66bwk3bT3Ca5c2aNk5exeWK/FOa4M2dC+AOzGEUWokgmisxHESuCwMLrqeeY+FMvbhJPvYRJPvWSJvXUS5n0Uy9t5p56c2FkzxB8uIIjYjP3cMVDcLD0wxUvZZImhWNpnPw8XIFW2yQeriAcgYk/XPEcPdP6b64/pOxt47xpTQ0PMvZHZi9e8mNmLbuxaL0Cr9Al89I3zBlzEc9pLuABzXk8mTmHRzJn8Swm+40PUFsuFlu0kIl12xYMc+CaWYOVRBHSZW7HDgPj+3/omJwp+v+n887K954zqNGa2fadb3vrZa9AZ5A9OTzbg0DMA54CrBo8RmUpUNmxLpbw68bC0Z8jBYiWtx4JwR/2XaTbvb0Vs07Ff/OTWbghV3YcXmmcp7NloxfWikVijD3Qah1YWPDSPWxzCjhzkOYm0Fyps8o6Lbx9XpREXQ9W8DfyloUXqWYKpz+VSUzcH9tzz2q2jIX7Z8w2+n5bnUPZ4Xhb/h86O3bc/0PHzWV0pHuWrL7x8Sj5Nc8xTsPk/H8aO/QKKzDHQFc/XPEsE7/5x5dy//1/8S//5fUWzJoxvqCK5ipvTWoL14wlq3lcLcR/Maj589RpMticHFioZ4Oqh1WBGOSFUBYqbMwXnAD2HGU10E0TWoVCWmeMNQkHtIa3cE+wrG8t2Bjva1nZI/PDR2eMT2dbnjXuFhOCD1du/rXf/fFhJn/2bzce7sdoLYsRjx7Dk2PPMM5P9BD4MIKXQRhNEyrxKUJ1mlCbJtSjBD/+Nk7Dwzbekpakb/5Xf8X+z6IUTrlGn/ECnzF4QSYEH64IP5YMPF4uZt3KMLvpll/dVi3lFjJwBCCWnzhIYekwLB2G1PpmCF4eg0ch9SikjkLqKKS2t0Lwyhg8DqlDp5x9E9d8WaP2bsFPKkxhseV3L0QSXGxJkp9xaTaPOn7jUplfFdavjuPxnH4Le1k0UQvF+KDV8OIP0DURdXjwJr7fyv6KBY26fJ2YyYa/cSmDbvztS2X7O5E5ZeIDeiU62eDcghdPssDb4TmqQvza0FkNuR6ssCkh+HAFsZL9OXcPQ3YLH0dxz6n+ziVU8TuXIC5w+cXHtOXXSVlzDgVtKHpX0Lai9wTtKHpf0K6ijwTtKfpE0CNFPxS0r2jFEvxY8ariA8Vrig8Vryt+onhD8ZHibcUr/4vgHcWrincVryneU7yu+JHiDcX7ircVP1a8o/hA8a7iQ8V7ip8ofqT4SPG+4hVbn1/xquIDxWuKDxWvK36ieEPxkeJtxSt/T59f8ariXcVrivcUryt+pHhD8b7ibcWPFe8oPlC8q/hQ8Z7iJ4ofKT5SvK94hYv5lqif9hjheIvhj80Gk9ftjYfmUIh1p+xtj4knQmw4Zc8fE0dCbDtl78aYiOjIZoNL/1tjYlWIXafs3RoTa0LsOWXvdvhhCPHIKXtvB0SKuO7L2BBD/Rh77BXeiJmC2eX5Ss4vlk0OEnt2mxKNO4cf487jZ9nN4CfrLuAn7S5yOXeX7JJMZd5aLrZKxSkms+O0zMqr0BeWTS572ayZuT2nnTJrZn7PaeA3s+fU8bvAEKJrZnHPqeJ3iTFH1/QYoKNges/pKpjdc3oKIlWLgmbP6Su4uuccK7ix5wxSZi37plkL87ytwXE/nEvXJlMJrU2kElqwMuE0tTYVQC/+nWm5B6fC49126/Qp7sFK09hjpufZptUMjUYzN//Sv/gfGv/X/9S59muwlFpbtY/TXtGPveeWKIrmIYoeQD7LmYOydwD5cx1KBKvpcSMP6aqTQtCQp5518/C/+5vP/o/f+4+uPRQFwrrfSJe9q3yMB7ci0/nPf7AYM1cpAGbMATSUqLUSb7q4aJgquwd2yZTwhtfhw+itUzQ0FphjTa48Wtly6TkFzAMRJ/MQ8/IQ82yRun99ybfKO/avL2GCn2GCE8+aKZKFw6ifLXuXzWXc7JONVidlInappCzx7zyMcQH11sOVZbnUiryA5gtlJc+iQYPYcq3BBz54vk+2eF2YD2jJgCW4C4hk0ZIhSxyUHaUmSk7Ckv5kySgsOZ4sqZwdlwwmSuAalKCmzk3KvjQl+9L0eF96RvalWQ5/9yw/CPccPxH3PD8a9wI/I/ciPyz3JQx53tDiR8cNbXOiPTUtfslkJwvqWnDRnJksaGjBBZOeLGhrwXmTmizoaME5k5ws6GrBWZOYKEBj+w7UbOgmGLAP0AvDNL8OaNRRFn0TQclgumQUlAynSypzWnIyXVINSkbTJbWgpBKfLJH9xlDUj/U5uMPOoa/m5AEhlU+Og3ZYMpos6QQlfiUtVoDRHhsXVmcLe+PC2mzh0biwPlMo7eieaXrUMuIrOANX2jOyZ+meMTnVLq0Zh90cJ9cRuI7O4Fs+I8MaHR2fuO9xWHIyWTIIS0aTJcOwpJKYfNFhSXWyZBSW1CZK5GOrQONQyWa4buH0CVpSTKjzAUd3HkqiefYGZ54KhjG+bbzOPl7n8VzZyxvLLHKPhOJ85HG0cIH7panCoRZmOD5SXnyy+ESL56kNT1EPECkeaTE1yO2Ul5wsrs+LwQJmDFhxcO3gvNGeL3slmE6FM6tHOzWrZUqoIJjP8drTZt5YGsErLzrplMmMSTlVg+oQqOoQQK8dzWMIoBX6AuIT7TsOS+qTJYOwpDFZMgxL2pMlJ2FJZ7JkFJZ0J0sqmXFJb7KkGpYcTZTIoOjh8XrzGbP+o8k6EE2w4qzaMS58KqK411602DUaohTprXvOL9yCcsylsslckyq+1wpTDf8CDtDWsleoAsheMWtwl+ll8bFny1KpPAoGMXfe3SUPgWOBcG3KMo7ssaIDQQeKDgUdKnoi6ImiI0FHilbOEq2cFbQqaFXRmqA1ReuC1hVtCNpQtC1oW9GOoB1Fu4J2z5qCarUw82Eh2bEPTcGs79g3TcEU/I3yjl0CtGP/FAlH8K8qmkC+ea7z4tlQ5FFSf5Z0PEsazJKGs6STWdJollQ5N0OqzpJqs6T6LKkxS2rPkjqzpO4sqTdLOpol9WdJx9OkAk558gxDEpOShmXy1NSuObHnVNeT3LaMUtpK6YwpHaV0x5SuUnpjSk8pR2PKkVL6Y0pfKcdjyrFSBmPKQCnDMWWolJMx5UQpozFlpJSKHVAqtlCqY0pVKbUxpaaU+phSV0pjTGkopT2mtJXSGVM6SumOKV2l9MaUnlKOxpQjpfTHlL5SjseUY9tMvLyBLS8vr52lFwxto5ShUk7GlBOljMaUkVIqTkCpONpZY0pVKbUxpaaU+phSV0pjTGkopT2mtJXSGVM6SumOKV2l9MaUnlKOxpQjpfTHlL5SjseUY6UMxpSBUoZjylApJ2PKiVJGY8pIKZX4uH/i2j9jSlUptTGlppT6mFJXSmNMaSilPaa047I99q6b68GOTBYLzjyXZmeeWVJjltSeJXVmSd0Z0qrdXvLyvvNeXLbGCOKxDj73wKyjChfb1falsnsVW99LZbdo1tEm96ZZR3PdO9jOXiq77zjRGnqXyuYdVZus+0eXyubOGOtfKpubY+z4UpmDX7DBpbK5OsaGl8oUnwQ7uVTmXjmy3Y3j6IPqfeyKvXU/xgdBGnWIZpDC2wIm0G/rGmBpDenSA0Gutq4hldaQHl0iKmGhXXczXPAjyotVu7vu8dbF7z0X+aGyPjbe3iu1bu7/8sY/+U//w1vXGjdzb736z//JzivXTd6PvePlcXSH9Tpr1r/nOc/lQO/BipGTKFi6V9alBdw9yCnVZ1TMOoOoR7N1zuuY+uJV1l9U5ZyOyS9eZeNFVaZ0TH/xKtvjKuNwi3s4rjKp38QXqxIfZmdcJdKppMNWJvQDypYDkb+zrsd+cWpbNvH/4cqO3V0363Qqjn/mHWHBDw8IyJ0PVswnexWeHMQyZs3+DuU3PZAIBjQl2KEtRNlAdhVLEqsqJvvjY0uwOWJtxeaJfShIZsJEBf88yuM1h0ce2L9AYLUFk1t2FJNbVhSTW/YtweSWDcXklk8EOeWWcbbdEWsiueWx7dEISG7ZVkxuObIEk1seKSa3rCsmt3wkyCm3tE47PKYeyzLxB/KLl6JbBuwvsCjnfQtzD0629arVUqulb3X/+nM5/HT+lvfwhqn+1/4PkYjhAy/vVyq9H6a+BtvQv/KvfvAPbBpU5f0f/vD6V+IlkH7HdtfHu8e7b7WmK6Ct1sPArbNS+egvQo/558x6+a/fMP/xL35fujb+yXBqselWq2Wsm7/3L/7pP4h1/s711s3/7ev/7G//zs3h9xstFN78O7/79jv3/9X/fb1107xx8pcHq//m+43Wzb/8B9848wfOv7neaJh462/xXunv8Oc7f/H7HvZGqJfjFa7vVsM4jedQl7pOxjgZT4+CdTiPTxz/anji+Fev49i3t+7H3JthhuwwyLV7/vWY35t77OXfEMXhGXl/oijRjRXG7XMxGumcQawd1+LScxN63WLZu4pAr7LEufHI5G1u0vL2wD/Cl4uXeQczeclfMCV/4RC2CmnMFcaDzu2qX5FPzkvCa/7hipsx67lYGupbeBuBM+uJAmTZgxYixTgO62PjEK/U8lIw06C2J9yFwtUwAWMOYzXH/RKcGhrsgOkItg71f1pvFoe/4jqM5aDQiHM+WjV3/I332J7Sjh0LbVJcJCFPwpkQzk9svDc2UimZ9PPQru3jAM729EnSn/5pYOKGfkTvVrpcaj1ccS0bjqpzY1OYbKn1QBTdsR07bvIauzISIhOn8ob79bhX8uOm5McPV7wS9+7IKAl8ceISqN/Xg5S4QTiIdfiKNSM7fJmqV7Fwz96VH1GeVgnJxnP4SMWA62QWcf1q6tzD8CaR3LuR3mjRdigPHaYplsNr8wwMcRURf4MJu7tEWesA0Zd4NPDIXcDPE3cRPzXLXcJvxXLP4LdquVlUk3Yx1XTiEMEO/HoB2rSrVDNT7RQeeFDrIYY4d/wFc0cH87wM5iQHc4O6SMwSoVqj1ZKF88GKezYc2/MmIWM7pSNirtkyczK2w1ve+d7zcTh6r4SuSmHApaLDPGWKfvwd2DIh0d3cwxWqpZNcnznOExPjfJ6ml15axnkoHayaYjDO70yO8wQc7ow+g5dsenPhKyqZ+U8d5/ONiBtgJI0ybariZg7rsUkHzyjj3MTliZDz1EYMg+Tp472kAVpfMN6LPus5XPGK4/FelPEenx7v89PjPW1S0fGeki7CeJ+9K8c7QwaYeIPOgzHgYuEaGe8J1UenPnO8H2BgduIUwxloZAlK3FbLZGEt1kJ4T8ucabUQGLThnoNW02RacH62zGKrZRagt221zHkUnzc3MWZv+qnbFNobryLTs/OcH59nmXOt0NRB5c5XEZLl/BQ9T6+/NUbxOJBPMrtt8hjz0iV5qOIDsJOm19MgLZd2BR0qeiToSNG+oBXKvZxQammTB+k4vee0FT5J7zm9tJRn5ScdTD/8giE5OmUw48Qge9fk0ZMoyd7DWqjrV/F97yoWKGjZitwUmby5KqeNTAhxQC2aFl1F5CGh9ieoWaUeT1CXlTqYoBqlDieoq0qFUu2ALxvUDVL1nc3T6CyPs5A3YgmZ5lxGEMRuDOcAIg90l8LRStNEv/1qZLq0dBt1dKalCi2+4jWNDKvEvhJPosQjJQ6jxJ4SB1FiV4nHUWJHif0ocfBqmcaOcvg+eJUbQKWKpRS8oF4FsZctU4pb8+uvodjLQ3N/lMRYzlNhTG073BdfxfO8Sre8tm4kKl8i2lG0KmhX0ZqgPUXrgh4p2hC0r2hb0GNFO4IOgh2LoENFe4KeKHok6EjRvqAV3UAdC1pVdCBoTdGhoHVFTwRtKDoStK1o5TV5XkWrgnYVrQnaA8qlW8wg9mP11+QNnKD3olbOfD/111B2vCK2devaO4I20tpooLqx13aTUotQTkipRygjUhoRSuXV8liZoM9ASidCafOqdjqkdEjpRChdUroRSo+UXoRyRMpRhNInpR+hnFxklxW1vcBCs641v/ISiw+1qYLd1d4W7J4OLsHua+8J9kgfSLAn+jCCfagPIpiYc635PUGrih4JWlO0L2hd0WNBG4oOBG0rOhS0o+iJoF1FR4L2FK28LN+GolVB+4rWBD1WtC7oQNGGoENF24KeKNoRdKRoV1Ax31rze4JWFT0StKZoX9C6oseCNhQdCNpWdChoR9ETQbuKjgTtKVpZludVtCpoX9GaoMeK1gUdKNoQdKhoW9ATRTuCjhTtCirmWmt+T9CqokeC1hTtC1pX9FjQhqIDQduKDgXtKHoiaFfRkaA9RSuX5HkVbbxWNuvZHbVHiu3YtVfNtdAQ6XJohHR9TIVvaAaG2ghFa9bdNfO26P62/IFYeLqWeUsUf1v+sZIcsy0R1bf8vpLixpfA6rckpvqe6IJuiDPCbTEd2ZJY6jRvc88CzbpJsxsxJ02AmNYAG7vYZTBIxF2zC5ETvklLLYpRjYaHiBJmzsQRAtOBUsMyKQaOklCouDqr8Tt2TUpcl+LmbIvxICh0QdcB5vvwYIGSJIFwEIgVtIucr/tm1y89zhZgwde7VPY2xJdiCz76Hh0r4mNTqyfff579Fcu15MET4lQRdbFYFhcL486JM8a82RgrNWg/BEtw40DPlYGJ9wYtuKkxmBfyPOR9kkWRMCfkOQQ/IXmZ5LSQFyATk5wlOSXkRewrSE6TnBTyEiRYkmMkJ4R8ho767A0aH8reb08udghlxf63wWcUWXlP9lbJFomr4hKH/qISi3FQb87/3vMnV+e/d/1h/Dt4n7TEbfL9Bja42MwburMcNlF/wtDF5W6TIYBoefsJ3aQM/WDu09mMvjCPmoyilaWw3HiRldyLtvIRYzm4BW3R4vnvX0JktRdcsYdySDuQgrZysc7fv7QYM7tmf8fupeR3weyu2gv0vvbousf+l5hnfENjcDkETQiuhuBGCBZDsBSChyF4NwTvheD9EHwUgk9C8MMQrFghXI3AtQhcj8CNCNyOwJ0I3I3AvQh8FIH7Efg4Ag8i8DACn0TgUQSu2JH2R+BaBK5H4EYEbkfgTgTuRuBeBD5SeHKfuuVXPbipyTCKuNEVEBzGeuytvUET4CtlbyMX+9UfLNPXt/Pfni27eaeEb3LVbvxg2a/808T7Zb9jl00+u+nmlOyumxwugKqA5geNHyxnzLrvfI3VxPZRo9nIbtGR+Fd/sIwzIZjuxspu3o+5ObO3avczHgIErFN3S6ekvMkhaKdX9JfL7rbJmXzZH1hl7wAh366GWgaLpiF7JsdsvvuwZ+MQf2r2MUmGFvnZUsvEn3+s2LlSy3NCdX8IwlsLO6HtGcvX70di1kHftjehvmq4lqxkjtmHfZo04sHnqYlLumXsBm1RrXJQy8n/61qKrAfmT/tBTd/5nDVJFawwYcY2wn2JlVqMaLe+FxY1MYUXDe711DgPb3nr5uqtD/ZjWXNg1uEVkqM7mrpE5TEhH6V1QlfxOcCOQwwTuz+YKB1GSs0e7B4jhaPopY2PcZd6xuwhhA22ynuIK0OjL7OHmDJC6wrN7CGUjJCOlK0RGTbijxSYNpsQfLjycD/2zyyzwaVpz2ljzOsDcrodP6BixyEWfUAtHUZKwwfUwlH00sbHe07nB8tmT00hsfCr4SMWfzVzhACgWkYIAboLElmhknbnYJ7/3UsMVDNMeTZ6Rs0j92Cz6TnoopAySnlxdFVaQzJyjfYbqMFm+DwISvGxzdwGg24ZR7yyk6TWv3tJfMCeyM+H8lNRP7Gq/tb0t66/j+Tnnlkzhf3YXXiZ+aNfFM+bwLD8wX7svl3CAy9oYMM9xHpSr0aE0hFxcQ8xdoIuqyyMu2yUGXfZSSbosjVnmKEGxWz4x78YSJwb/vAHy1rHhj9QetJs+CdKT4FH6Wk0VukWeJSO7q/8m2U93d7wqwrjXjWFF+BrofAiOlthCCtthc+wOzqChZ/ohj+QmzY95xlDFsM774wBBNXWEqEizPYIwblvgRAc/jKEEBNmjjKuxAtco1+91ZLwg2sQ4iD6PsPkkaZZKd5245lMk3s0X7Ja4gbcJkhXYDopi6xK92WRV+nYLDIrXZ6l/+kMzVk25zA7OGd9GjQwpmHDdWDNKtZTrQbDsNpiYtVquAnEC6RBCLAkAwGsM2Jiw00h9CANSoCl6eC9zkCLmEx10pq/LVojDc/s2guxTIxr2vC7l7jUdb8rrxOO4b3vhq/2SGG82r7CHEYKU6jsfPeSu0h7yw1/IAVNOnOjLxeadPNeMwmTadIBHD0+36Rr+BrU9034jOOl2E3IjLDeXcQ2ImM2YB/Y+e4lswGlzJAAbiBxQqUVONOKaetMQmC02iQFxtOYlMB4SpMe+3pWf7CMrc4G5YI9k8d2M1ZW+cFbz+5yTNZkACrnHySirAFPfYLntzPTPGw/ZQnsLBs/WMaGkxFF4S3oxxCtYdfvp8qMOVQye0vzMUv/wX9yB1GbinSz2TFXAnVMLyUFh/S0IXiXnjYE79HThuB9etoQfLTnDBV8suecKPjhnjNKmR3YqwMV1csOpmWgVUVrgtYUrQtaV7QhaEPRtqBtRTuCdhTtCtpVtCdoT9EjQY8U7QvaV/RY0GNFB4IOFB0KOlT0RNATRUeCjhStzMnz2vq8glYVrQlaU7QuaF3RhqANRduCthXtCNpRtCtoV9GeoD1FjwQ9UrQvaF/RY0GPFR0IOlB0KOhQ0RNBTxQdCSqqlyvMbGOZHYzGX+L7ni+LCe6O2YHJO/5W+Led5AbwmdnJxaqplS+8EaQx9SaSJCOuVsGPuaXXY37FeuytvxGTgFsQu4uR6L4bCDrmF8vuhgRsc/NkcPdej/mdxGMv90Ys6u+6NlZ7xF/k+crjbWryhbMxFQ7zFezVn2dcG6okVcXAnCvQ1MAWKFDRwKCr+puBBmfNr/3mpbHFTv03L40tvRq/GcyYa377N4MZM2dwj47UJW2qiNOtxwJhbLWYvy7HWTwDrBFg88DqATYHrBZgaWDVAHOAVYCt+R25h8gzCHYwiJPeVTqUJqlWq4GlbyhFvUhRsoXDuRMpOIoUJFgwivuWe+CUzIHZgLn2+xKJcSI20O50iKXd6RBLu9MhlnanQyztToVYcg9MAQtbQaXxAxyMTIV2yk/fNz993/z0ffPT981Ph3bKT4d2yk+HdspPhXZySxmZ0GfzqOzNhI2jQmiWtDxLMrOk1VnSxiypOE2aCQ4Has7sMerPIVX/QNI4cSSZOd4JGciyhFYRpJHQMkIzEipCPM7xBhoynOSNXecRJNFc9NMHWrHKXDKP4XFbWqG4UsSJpniQQHxSNxMKYOKLQgFMHFYogIlfCwUw8T2C3OZbboH51m29zXiorlJIguCFMTeWuzAix2LXLmN3q9SF0UyhyxEkRslNB+P8nXjJ5BDwzBRCSQtOkzlMshsmB1ll1eQgphgkO4I0moNwkjU5w5jN9PRFKL/q70g35Px0GTpUHsk8Ewfn3JpTYtxtgocUYwnepXxL8B4jWxO8zxjVBB89YzsQSBWTKSb6eiQLAOMziGZ2S2LdbEmsmy1RxG5JrJstmeu21sQ8AJM0lscUWp7HMmqXs18261hvYmZnPdawJUxQTGhpBvdJC5IlkhVkmciyIIaIEWSVyKogG0Q2zLq3pssFQ41ZunpFlyF3YbxWuQ7WQ4SujVptMvdBxGAh2BV/P7RiaETciqNRFlbMwqSnMKzVGHAoIQGHaJdrxAsUCmxEz3DpAZYWS+CYa9slBL6sWuh6WzZpzuQLUeqVaJAUDXCNqPtNjmGVCRm1J0F7TzdBmZGUpFCS7DxSUkJJsW9JSQslza4nZU4oc3wzpMwLZT5jriBdQ9Zc4cPglRHK4n0RWsbLImTwpgitcqMmpwBXGJBK2i3S/BVKsuN4cSfXx70rhwNNatbtpixWh+YKk7Ksid+3xcZZgZmrucLkLFo4z2eZR2FcCgdh4RwffU4PDlA4DAvT7Km0av5ReBIWptixKdX/o3AUFib5HpLhKYCIDQwrlZBYU0mJPJWSOFRpiUo1JxFn5iWGb8UyV+zvwF+cZrlh/DiG+2b47QbjjzPwtxwNjIN1YOhA6ULVkp4yIEq5WcTZjVnCWdAZngU1TLYlcZ2sUM1hMrjFIm+xhFuc0VvQlsppGufBohWaTHGIjo0RobDMBpZRsV4od/ETi0iP4WdoIl+kt7aC7WFE1qOwxrljoZGR8PZX8OH8kuXH7oy/mP71h9/aj/0SQ65sYDagPe86MhI0dU4Tq+17raZOboLfbTV1lhP8sNXU6U7wUqup857gxVZTJ0DB77eaGZzxiRSNsygGSt8wWziAasnh0xa710vIxGzp4dwy4RTD8GcJpxmDP014riWW8Tu5WCMZmahcCzG+bNxvmBCtr4Mo/C+Q0l0rg8Bg5D+J8tu0WbQfkiOlHKMXciSVo5J8EUdCOaov5JhXjtoLOeLKUX8hxxYlWungeV0atkxCV4wtRkyUrk3p+rJlgmVni86ztFhbhziA7QjOK7FZyXqvIDBxDRtxc+he0UTA7iaCcsw99jaYT7uL+WMHqpsnmntZglfOtdQrjpGx5lvqssbwVkjEoW5lDJi10FLHL1o244MUnyzGrVxqqcMUQ1DKJxrzj/6hBDhDZkvYUTJob5Oi5TPPaXlW081ysBtpSB1DTx3pgtuPYCWnTmh602PbyP2qjs4G1HPxHlReHTLxgd2ELeeac19rrwW198LaT4LaG+Pa+0HtlUjtDamdEmlJ0io03XPi7uWeFxcz94L4uLkXxa/OfUl8+dyXxX/QvSRaL/cVcRxzV8RZzV0Wbzn3VfHQc78kXoHua+KJ6H5Z9GOuERc01xW3N9cTvzv3dfH1c98Q/0L3x0Qr5/44fj9EAlkcXLsJY1HgtBBvz0bkvRTcOrBmRJDncnxrmwCyAghH7RP5l5h14eOWF3/uQu6MSxam+HM3DkVYVk6LU8+QKzVpzsGy+Cxm66zM1uM0UEYODz6mUTV2D43n3GpgpWrJgf0Ih9VnJWsMCScgnAsU3809Z5jmodhyecf+rQQOAyS1YQ+a4rZdZoxs7OVzb1DFhrD82NHvmq1VO+5uQdO4Y0Pi39qxv21yZnfHfiLY+4I9MjmT27Hvy8/P4ke8e+8RHAL8owQHAO8i+k2snP1Zu8QwGB6jYeCIF7Kw5zSiNrfozHwk7B36YtLYNR8mwqOZIMJwUMCWXH95CbaxwUgckutPSWnG6GCuP1qT+ZiV7AfeFrYbZovJ/raiyf62mCwPRZrsD6Ak9tsdJ/vLIbQmaYXTkv1Zk8n+8uR33vcOTGGcfi+HLcf7XsnsnpLsD88oz40LmXwwR7sR531vN1LFljmYTPaXl40M+QtmkrU0mexPtlYcDtDecZhkf07OkQzPntNQe+CgN90Swwbb/ATmkh/HPPJjMoe8gfnjdc4dHuYNN5wzulYTI7MyB60wD7nTGPAGVXwZVbwmVXwJVbzKKpZRxUpYRU+qqI6rOGYVr6CKS6jiZaniJVRxkVVcQBXnwyqOpIranDxZ1RbLDH5pfYs7niYfD9YFWBRaGCy1tLDXbPkmj8mJ4CtkSpOprkx1ZRqQKRswZcnUUKaGMg3JtBwwLZOprUxtZTohkwmYDJk6ytRRphGZVgOmVTJ1lamrTBWbW4iAaYNMvbSclXd1djCb2e9anD+wTl7ZsdNI95B87G2NZwsewKfp5cbAFAyTxP0vlxjZEK+LqnlZQOiGjYBQ5q4KCO3rhoDpPSom1qkoLwn0CDuFnCyGe9RMrIta+Z6A0APfFxCK20cCZveouoDct0e9xTqV5RVL72nxGCMnyztPN3KytPPQIycLO/3hCS/TEZ7gIT3gCX5I13e5tUWn95wsOHR3z8kiREf3nCxMdHEnbOjbTvAundrl9hbd2eX2Fh3Zc7L00YVd+lNSDkqH2nRbJ7xKf3WC9+ioLve36KIu97fonJ6TRZhu6dKvNh3SpWNtuqJv+SkkxN268Z9UKpUBTda3zJb/Pzpl/8kHsLKIE3+d6N6OHfOTMnC8Xcws2V+2Tq9Cr9QrhPcvgbeWlIkHUVz3bvy1v/6f/8bf/o3fqV7b5fHtlR27bcMQBANvx/51nHClxXzjAFKdHYRaK/hZ5uyVppSwkO2bEpa1bag4/eT77q7ZNwc4tnPhaLblIDjFls6LZttwsmfSGko3LVlE1pntDXoYji1MMNRXcWi0xOKUb7XVECNRvpCWmHXyw2gxb2CWK4e35SdF6QnkQJECnJmXPb4XGJXQCGXd33jfy5X5YN6WyYn2drxMRuwgVloaMibnp7/l7ZYje4dwD7buW7dXWnzeIMQKLsiWX3yBfdoFy59ygXPaBeZTLoifdsFqGY99+gUJXJAzW+MLxPQn6Ee/b8tYiu3HfgXzmb1j18OdqYvexYHG2zpM8hxN44ksrxNRWqAs3lpe54BlgQymsbx+dKsCbWASy+vUVRSotCcvkZPGoUB3MYfl9Su9J9B9zGB5neweCfQEE1heZ5kPBcL0ULEErsoMlg+m2JrCmCTrCmOWayiMCaqtMKaWjsKYFLoK92QSywcz7JHCmCH7CmNyO1YY09JAYUwoQ4VPZBrLB9PzSGHMrhVb2y/TWD6Y0mq27hEscY5poAzPYjslfpXw3jFbUPvqEQUNUe3HiDvNMIlxeMsmzNZjL+c7H7gl2EMhtPTXqNL9zgfuPk6xeHa/i3Gq3/lTfrJp+cnKz/JT6ITX/ThskAp+HDGY9xlNgBZjpXgpWg0rIT9tluTA3pTIb7Zujbf8MBdbcGB5dMBrXEx81u1Fm3LomAijYksfojDzECVy8ll2qRHf5yQRfZYN+bn/VGepp2KTxYfZxcPsBo0r4KSA9e3iwVjfrtQnD2VNPVRBrrONxKJ9QDHd4nJjIcfsxPSWx5eH0CP4Ev8Qv9h3+PALssvuW/gMTd4/scveTe48fMu9yg9my1vnDH0ZbxYZafzE294dKFJ9zEjfLmMdobpKcfsjRDAsPvUsRjJ86tkPveucWuBUbZvrID95KupHc33Fsx4irvV1TldgcYSlbUFtAa5ClMcmT1x4BgzcbU/zWORJCE/dfqq1PFzJoLjsFRF26voide3J991t6dgtPETRd77N+I/r49chc7/z7bKL12t94N7C2AV4h56Ef+ED94a+sX2ehXjbZe+aGPZcM9umFEZF3ZbTYbBZ3/o8nAXfLrsFk/NtvPEb8sZvoWl6q4LY87kYewVUEGQGK2iAS3lCOi4mH/t/4Z1FuIul8RHl4a75flkecJtrbgGDOWGKOuJv+zH3Gh+26NuPIwMfU/YNfV7n215OPV0tc2ByaEQQsfVW8LxcCA+kwLXMLXMAtiBGyEHIlv18bMvfmr1pbiz9atfF0XU38JHdMFvSdbdvLcYm2n1DqrjxgiosVHENH9I1c1uquCxXXGb/weRossdlAdxyC+a6bx/ybnlTMNsUarySXEyan3zfFIW8r1Xsh/f1CqZ4yBvmVRC6JS8Jo1O+xPjMyORIfuxdW4QpbAGerJfl1Aw+rRioRTUewGB9S3ejaEqRk4wOqrGb3Vscp15J2UohWynKNjlIi9JN2/HPcYcMDUTp0tGCbzq+77e924jyZknHf+DeABFf2jU8wDYsH3SuLYzn2uBODJ0lct8GfCTTPMzR9pXQvpLZ1tcocVZv0OI/bFVQE+uBtWszsIGNvyuLg15oSUHGT5j1x+5lbZ00+Tq+G57jX8MwK5TdG6ZgbknzIk97myl75FnlIflkRX2y/eiT5eTJ9lWP8ilPdl3i3xZPfyasaTfoCWMsuonq6L6sAXrsUtQC2CtGsAfe9re8ArydF+FdamMW9SXMcF4yeuTllBOmAC6DNiFbvHrI+75FD+rwPwThjWThiOYzkvRhzgSWmMDiExjsBKYJh9OEu9OEe+HdsRj4eKT0whgCy4fT10SOUZRStaarcXbshYUxRE/smau601fd+MVKpdKP7dpZP+ZexRfr+3Hs2vJU06IDEzv2hUiX/TyDIYIVq/WCldEFOv6uV1rkLHIHs724BdvPdRjDdpG0NGlpWXeVliUtK+us0pZJW5Z1VWmGNIOHvGrufABx4KopfcBW8H4RO6ZvuNH3jMcXYYBt+Aw+R/myn8FnK9/yZ/BZymeiXNjvvf2Bb/15cxUyXcG3/ry7Hxmmu0tOzLLjkDd3fcfNme1Fe8FBpwtaZNAASqPFxZhvU3rKmW169d+EQjZmcu4uPPqvmsKKe9Xsm7e/5b5tKJzBoCGP41tIZeaqb31wa8ceyRa7lkbUgXC3HSPIGLo7dn3u9ZifDbbbuuOXXRQ4C2bjTTu2a8exEn7LyyH0BC0NzordwTmxQjgvNgkXxELhIg/h3JfEbOFl/BTdS/gpua/g59Bdwc9ddxk/99xX8XPf/RJ+Hrmv4eeJ+2X8fOga/FQs18Vv1XI9/NYs93X81i33DabSwonAlp4IbPFE4ScYv91yV/Hbs9w38XtkuT+J3z4+hS2eJDj4HVhyEjm05ATyxJKTx5ElJ44V213i/W1x+avZONVhC2yTQ5QHKsBtJpNoUAGexpnAFvV9OSZMg45hi6q9HCNSsLRri84802Jhj+gqDqK2GEsQaxAOoqBrWGWkKVtc+pgznmfO8y2zBBWpOQMNadYoN2w0fhzcPwHuVeF+E9w/SW6eCjkBN8w7vgxuA25XuD1wv05u6oB/LODGs18C9yvgXhHuZXC/Sm6qe18LuGFUchbcPMw4L9wXwH2R3NTsvizcsk7mOcwYA2Rd5ZYgq+2WsSWOCzp9S6VnjER7hjkdZU57WyIArMt6Ms2cjTIv4IhAmZdPYV6OMme9LT+uzOYUZhNlvuBt+QllXj2FeXXMvC5HfTBukpBmVqspZ+zrctBoiRUUdq04C280JaM8S5eldFlLD3GGhFxgrUajibPuZWEzwmaU7W6rIXwVRsPZFSv4RpMRXOSKVbliVa+4F1xRDa7oImwXgCG9ZZoww1hlYqdd2mc8D/U+qcDALYtDmZSYIrHaomdF+KwJvjPSBbzrk0/hy0pnsFFt61MY49IdbPTg0xgd6YUl5kazP4XRkkd2pBuMvjjDVjvardIhn/SWvDe0IBu8JGGqBExVK3hteKAzfN1iEsJX2whennDfC94Yeikl4yepLycbvK5gYJhW8D7xrvAGdlftv2l7OR2kiM88FhxFvy8bwt1Vuwu2cOBbM9wmyv03wB1+U7Pcy1HuDrjDz3WWOxvl/nXb243MBMLNQzVNQp6WdH7yCca8XeGMncIZG3NCQftGTByIcfK6atfnqFIMTmLhoslPMx0c1sJRk5RscJ4Ld01G8loOTsng4UCKCQ694Lop0b7kDGvPbMLQWtbpKzt2B6v4JvI37thHkRW9K/AQ8N+ACjT3esw/iT32oMc35R17WZfzvVU77e7CK3KBSugt6Uko67lDuBLqxq/obJNuiRlgoBunGaCoxmkESM24mACu6+jh+4664/2UmPbsYYZcF1+4VXuZdyNo+Cobkvp9S6tK815p0eBx7fgpsRtCS1iWFbUeVyGWFdkwaaPo+rie/ZTZEvM7NpbFhsWGTeWlh2w9y1ZZtspllmV3qQNm2YbsBRv0YYcjwBtBzvQN+zuAqj/nXaHHTukxDeNrapWyQ0kljd+e5c7R0Mdy5/HbsN0Mfvu2u0DjHcddxO8jd4lWNogOtkOBJSs2U+5ZegDY7jn8HtvueVr0OO4F/D5xL7JWy32JtcIiY4dyyyX8dmz3FfwObHeFrXLcZfx+6L7KWi33S6wVBhk7FHO+jN+u7RpaM9muy1Y5rsdqIX7tUMx6g9VC/NqhWPTjfFjb/Qk+rO2uslmO+yZ+77s/CW+0uTJvYqmZYIu3UgMdm9hQDXSQDJY3VgOdOEuP1EAn1WLhSA10Eixsq4FOUgYljg3gUPI6DO7egBTyY0wxa34cxho/AZsPs4rZ9E0TXmFeBfeXwP2acH8Z3IbcLri9gJuf+UWwvwT2l4X9EthfIfsK2JcDds4TS2CHu5zJCvtZsJ8j+3mwXwjYOdH8pGEaXWbQJfs842qSfQHsiwH7IG1/hyniLY5GnPnv4IumCwxsNeneIja5MfGTQSywK+IA3qIDHsqy4iXT9JLiAcP34MVbiPkGW2xAGkIs1aKrHihiBenNiZsMAyN46aa3CFPOxnNxj/Eyz1oe41pkGOWw1RQ7zQ2TgEAIJ4omlngcX4t/jbcgLqAJybebBJtDNiaWAN+CeIImJT/vUkPP0RdozocoESAjp0Yb4RTSNKA06QZ9abINi1EZ5lqhQUdDvDKj3Vexm54tfkee9UzMN4NOHFmSzkcsfYLuq/IKW6J3iIsSw0o8j1qRJJ578ZYEsN1gL0JQ4LOjk2GhyAdM6hM5fASL3RFW8zxD5084ZM1LTTjRwfl+Xz171mFBa4uMKbnvGOKi4dkI27elsS8aHvc8yx7C8jVw5rUuBpFzTKLswT3QUK6xW14GLwRHBgstL9HcY7b7OTOvm4MM021uUALB8jgRTBB5Nj26VrY8u0Ef70gp9iVIL4SC1ckCB7RDbOh3bEaf38G5ZW7HZnD63I4tYet9rIi/FYJ/U8A+bJY6EfjXBa4jKJ8Exfe7gH9V4A7gBlNAWeXsz4qhmXp1uo7aqzEw6H066MLQWA7ree7X5PI3tqUdfB92XhLgMAdr3iai3sVFSrKNQ9Sa8D2Ii+2FJbrkxNhjnIeOPFGUo8JP5L1W1BoJRh59NfsZxcpuzrfcPEzamXCNewk6+aZ1QMRb8OBMiwjkcdGHjzniIi4Zu6mhT0XijLdkuBDlONL4J8+9FB6w0aLE6Z3l90ok652jmSe+hFeb3rJZZrxNqFKWxFYODh68mltEXncWQw42c7jqpaZ33pyPXJWWq9LBVcHdzsGmL7jq5aZ3wVzgR0i1DTfdJtinQwj2MhIzE+PbNvNmrinBKMN05DnJpmq1ZA8vJoKN516Sya9Yi/EwzzjyrKveIucb3P9S07toLnJqwP3nGZmYx0y8GrMQWc0CE4w70upXeEHTO2POyFUpuSpFy2SNqZjk1XMk8qozCIY5xylYeggyEwzQc7RU8FaejgM9nnz00ITwg2/dIj+6c0tsltCZW2KZhLexRfujRgO1oSFia8dm5IQLz5ELuBpe4unY7A/3ik/d61XYtb+EmEUvm3OyVmawVi5gSRQdQPrTa1iHt/ATCSj6yKybFRy2r5tlmXDmcAi/jqnyrlk3F2XCKD02F2R/eX7PwfFFHobxeW99P3b0SE9Brvi1YazsrovR/BV/+L/GymYv6wnTqSyN340FZgbVeyg9jpXNFb/9u7EgctsVvy60TpTWEFo3SmsLrReldYR2FKV1hdaP0irHMQ1McMU//l188lw7f268RH3YBLgML4vfj5VDqQtOnUOlyNoFH44TpWDVD0O/tMLFkAGhd7gHoE14EUvyDhUI0xfIWhhcsMoLRC7Xa+7xmi9/959/vftfvt7DEHLhwbhll8zhrBPc4ax/3uGsf97hrH/e4ax/3uGsf97hrH/e+mwj1mcbsT7biPXZRqzPNmJ9thHrs42Iz/gC5iSuEqYlscbZoiut05BFZMuIYw58Qmxm1W6qbk38UWn5dEizUbEvhB8aexebQomMJdQn7GD6wHGBaKqt1IfsZfoiMl2JcFcs9rQYDvNQsyknaVUWrIrJMM9c5YIa6XB/g3NQSW/QaOJJ7OBJ4FGFJ6EnLZ7EkSc5VK3EHlsuu/dDWvjg1P1QU0gX2CQ5+z2khU/McHBtSC1c6l4QHNhqNhHhXeyMG8+/qMP12OmEZodiyIPHiTcbuhLBLjoH8xiRA+LYu9I3UXbkYglpyZ5cbCEt2ZWLOaQarIlFpFqsqVGkmqypWaQlRmswK4KZBuavrdNmNltmtu7v6fSCeQ3TUoDXBD8K8Lrg/QBvCH4c4G3BBwHeEXwY4N17csPR73NaQyuQMNJsmk1kaBXFR/aSt8em7i1CqKmmmH3UEgd1bizRAYQe8ekJPuGjE/yQ5lQbsnflW9iQLSjfzIZs1GlOtSG7b5pTbciWmuZUG7JPpjnVhux9aU61IZtXmlNtyEaf5lQbsnunOdWGbMlpTrUh+2yaU23I3pnmVBuy7aU51YYoCmhOpR5TNKeS9ts0C5X22zTUkfbbtAuV9tu0C5X227QLlfaLXai0X+xCpf02kxNJ+22mJZL228xBJO23mX1I2m8z75C032bGIWm/zVxD0n6bWYak/TbzC0n7HWYWkvY7zCkk7XeYTUja7zCPkLTfYQYhab/D3EEbZpNj50jBNLMFEcwyTRDBZeYHImiYGIjgKjMCEdxgKiCCReYAIlhi8h+Ch8z6Q/Au0/0QvMc8PwTvM8EPwUd7CJRN8Mme01Xwwz2npyDG3ZHCGHd9hTHujhXGuBsojHE3VBjj7kRhWhErjHFXSQiMcVdVGOOupjDGXV1hjLuGwhh3bYUx7joKY9x1Fca46ymMcXekMG2gFca4O1YY426gMMbdUGGMuxOFMe5GCmPcVZLafowXhTHuagpj3NUVxrhrKIxx11YY466jMMZdV2GMu57CGHdHCmPc9RXGuDtWGONuoDDG3VBhjLsThRHHdKQwgphWUubKqv2qb91m0LorfpVeOdRf+Cf/O2CEWuonsTukmQmNU+Gaw1WW3jmyejdlPcqpixdl77RskHOy0sPdiNsuULMqBtChiNJ7oykbyBwVr/gDQb7RlF0mHWrg5EGZXvbXObFygb8E9wygbmRE94KYrNWUwAjIWlO47zA5o+hnHCZsJDxwmMSR8NBhJmooTOIu9U71uBunyikuDs7tuDhDd+Liko2gHYfiww6JMS7O2Gk3w7XdXRBH7UWu7+6SeG+f4RrvZsWl+yzXefec+Hmf51rvXtBngSc69FxxLvxNamSO4l7gMcEAPBsMHnqBjhTnQRsILWHOkXYWtGOhpYw4gZwBrS+0uFkibRG0I6E5ZoG0DGg9oWGnSfcz0LopHavspeq9BgMAyZBlh9VAGiHsFwIBbTJLGfrznmo3q0KtSe8G1JpQ66S2A2pdqA1SOwG1IdQ2qV2hXvF7EMj2vFwu9huWi7OC2H7sNyBKrE1F9VibjuqxNh3VY206qsfadFSPtemoHmtTUT28rf1Yz4LUEv9IRu2h+IgdiRrlSIQchmxuIVIsvCugBvHgsbvFAC8MRJXzjyeISSEOJogpIQ4niGkhnkwQ54Q4miAuCrFqR4lLQqxNEM8IsT5BzAqxMUE8K8T2BFHkYITKihCpMMIZF8Nou/Mil0vy6o6FuDfQZL0k0rckur7nviyhOyTh9X33kgT1kMTXj9xXJNyHy43DE3dFIgYsy5f2qnyoX5Iv9DX5NL8s36TR8cJAGE1xDLSey4YAmg6obhcergQvzBiz0jTWc0PlKZRAZx+u4NHp/fJl8woLL0CzkzVZc+EBz3npJfOaucTC81AWnTFnzPkHPCymN82XzMssPNf0zsHJ3px7sIIXQrcb5xm1kY6Jy2kwh9Kr5iVekWl6GYneDb2MyTzgOTAdcJbNRbLMN0Wv1GHWKjP/gCfA9MuZf+bNm0UzbxYfrmBU0P0n88zLIEAAK5tT/yD7mWczalz64QpGGh2ILoCIECcpOSCng9F5EOGMikQ/SXVAOgciVPOJhysY531Ec9EtBjcVdA2iOitO3WxPcWj2kg2KgrqpTDK1UV9x46UMlMHHiq96aaaHGSi+4c0Zq0ExLocQfg1KdzmTMmcbFPpyJmlwWlcFmKAavuJQBQpF/cjmtmehQYEyZ+bMYoNypgwbcQ+TcBb3BMrKlkjCWTwSyMhmSMJZfCjQBjYCfizhWxlvk5uHzcUYDkce8WxkkBYH8k5cHGZz3EZ4tjYUOwm86JoiTzAw6orULHRxQ7G6hbfQVqxh4UV1FOtZeJddxY4svO6eYn0L+v0jxU4shLroKzay8EUcK1axMXYGwR1sjNyhYm0bg/xEsY6N72EU3MHGp1OJC3Zse+co2+ZEbPfOU7yVOzjeBUq4ORHLvYsUcuVpHe8lyrkIifIIRnqMMzL4BSiehrGyeUkDbfyzWBn6NkbkAHxBQ3cAPq8xPgCf02AggM8K3AecFfgI8BldgwBrII8uYI340QG8oIozwBompAF4XhVvgOcErgFOC1wFnFLFGeCktv8PYhqr8Ip/AljjkgwBO+JOa3gGNPiFJp1KmcdzgACSu3i2P4hJfGPYE8C1C2sK8jRUnbK4NsEIW5yLJR3nFgXBz8G469Mq7yLP1SVKy6P/v74F0U9tmU0Gw4qJZ9kuUA2HtcnIVkZkSjlVdsVZ13VkbYrL2hQNCLThpiRVhJuWLBDunCR4kOWzbcuy2cNpPTMuuIuSTMFdkpwS7hmRPdysZIJwz8qSIOvrkS0L68CWFXVky3J8Ysk6XLVlAW7YsvJ2bVly+zivZw4Hd1nSM+DA/k0n7T7ET8z9JrrsH8XKwNgdV/wToA8Jm2/uOsOfQQ//41jZ5BgdjJ0PdJf9xPcCdGuM1smM0RikX7ni96GescxLEFtfhub2EtSAcfMKDmZXWg2TNMs4an01OEO/4h/JJWdwCc3Uzsol53DJeV5yAZdcDC/p4ZI0szvi9GVejrtxUsyD7gZPus2SnMKo6BNHwE4J2LSsO7D2P4qVNSYa0EaAbhCtB+gq0VqAGtm9Begy0UqAZomO/qGisr3rBqWHRHsBepfoUYDeI9oP0PtEjwP0EdFBgD4h2gnQkpxFp6HxOtG4bHKst2sO3R3xm91UB0j4z27j3Df22Cu9ETNXvJx//AexspjX5/zjQazsFmmOnMvF0tQk+/14mU63gxidweFHYJd4cuDZU2rnnVnF986s4ntnVvG9M6v43plVfO/MKr7FQmSWmJ4lZWdJy7MkM0tanSVNN2OT56SzxPQsKTtLWp4lmVnS6izplGYUvcQ08dRogVBfzZLuzpLuzZLuz5IeTZL8FNy5Vu1K0rfeEWP4jvXMnQPQtrz5Z27G+YhJz2BaV8CeYcEUYAaewg+ibh3QuCmN3z6trU0egUa2gqSno+v4jrawLhyarVPchvN+8vYKow2dWphA4eoLCuMoNC8odFC4/IJCG4XZFxRaKEyPC6Pu3PkVsV6O8xDVabYkjlSSGXjnIeQzWSKS86Ua4Wk+Y5Y5JvXQ219htKX0M9hOpGEkkQ5zYcZiv9bwoLxImf0VD5YZCU1qa8tupMTAVRJQLrym6cV59I0MuBI0ZQVmH0Wzlf2mV1i0/KTZNvsr7naQgDt1O/6R2U6YTb7Zsd8gciIXNAp5wexo0Op9vO8EYi26BTiSDmKMpGwK/g+tD7ydpVTMxr+YnTE7CE+Tiz3CaCtFNvfDn+EhEZJ+5LiwBR789zwHu26lyInUfWrK4PuU4xpGXlzYCBBc0/7HsXGQ+axyd6Lc3Sh3L8K9rNxHUe5+lPs4wm2UexDlHka5TyLcq8o9inJXfj/CXf39kHtDuWu/H+GuR7kbEe6iKeEAHBe0oxd0ohd0IxfEtPpelPsoyt2PcB/6SbNjfySaAUsXkp03YqZE8RaxCPIyILZgrqOfP0xUxfUybrYgwu1LnN8tSHfbEud3C2eOVzV5E5xHxlEuc34nWfYuS0jfy6ImXJPQ53RLWRSxb0nEvjMi9o3VhBT7zonYd55zu4jiXGwuhJ9Hi1O82CVenCJnxUDxpQi50eBkL5aKL0/xGzFZXI7yc9YX28VLU+wbYsT4ykT1DRM27le5GLTMxSglOFh/aZLtEE17eZJ2t2WWJymw5b80SbrfMq9MUh7xcBY2p+aqylQ7ZlvFqR2zr5LUjjlQIWrHFFR+2jF5FZ22VIDFgeih2RnP+D+EvGN2RHjdMRdgUPYM5i+LsA5hzDKJV2bikCgTkCgRdgtS5Hk0rNU06SZHfF4nIxl4BzLmdK7alpF2VQcZBgrCbn+E5WfHaEAwtQAKgngxVGM02GMDqomi2cl+091C/G8mG9vy1vzk7cyKu2XWOMGNY8XncADg7vgxKh1q5wOlwy5D7uHY55xg7SR0ECPFEGxvzxkq1klCC1E5L1gjCS3EiZZ1k9BCVM/D1ovewrtmk9bda9PBn/9tqGvdvNnECrEptt8qQ+bFBXdtwYJf2yYjs6BZRWlW356u83iGMpihDGcoJzOU0Qyl4kw0tzDd3DWJnLCLxJpT0g/cQk6hDU+hnZxCG51CqyRnadVp2rTU60zh0/Xan2Ezcso9e6fQjk6h9U+hHZ9CG5xCG55COzmFNjqFVkmd0k+n0Gqn0Oqn0Bqn0NrTtJxfP1NG4ge7nL3preViPQfjOM5xjEV3oUzvd2y0as5jb/+NmNn3l7FBG0lawn2MuKojqUv2QwExiCuGn5rjrbS8L0EGmebICseh+ZIAdaflvbbnLE+xLbeaTF6Sp7t33i++b9bKWH/2ETgzH/hqN5lXnNKbQ/3RvqFSpOG0vJf3Ij6s/MphQn1arebFtcajtbadFrSMqxO1rr6o1tUX15qI1tpxeKSzMVHrxotq3XhxrclorV2HJ0dFsw8TwsNITJfoK+GbWAnehHe+5b2y59w9rd9xQ7Nf1kU4uKuLsBhW2dv27enuR6ITDKRo8rFTev6z6nWmX8CFPef+Z9a7+pn1xqdfweKe8+gz6934zHoT0y8hBfX9PrSTES/4mbdQRSrwpvSdt9TyLqkt07Zvv7DP4E33GS8CHXYRJkHTT2a/sMdOr9WZ7q4zMC76zFo3Pr3W+HRnpWmmtA997NGn9NYRErU35QG9uRZU+H3pLedTnqtjfVZ34cFgZDPzYM6nPNip1TrTTzbPA659aIur9qeMAzqJSFu8DA9GazafLP4pTRi++MnWqJ9NmII0xEuaeCtMwwcBrG+bApTPG6YgzjdZCKQvQfJcMi9HmGG97PAFFcTO25KQsAvQaJ6bYPRe5eOy3mVTMK9iy1gQg284cZuXoB5dMsuz1Xek+hRqXkTNF2ZqHmrNd00Be/6WOIdfRIsvQYF73rw2WS8rfiIXZU1hbCKOGOAwXmh5CfE6Woheh4vq2jmrvFVKzLjNRbT+EpTC580rp9zqQ7no0BQQ9r4lIv4FtG8Z7XvFvAbH8i9NXclLi3JpmpemJHS6uYD7LeN+r0ApvWJWpi/do/wZF2XyAozbz8EG/WX4eL0Gb68vicg/dVlDTEgTYoi/OPH0Yn7Hd3fPFHAecx9dZ1LR8SP2dCx9xC5KS4h3c9FcRBddQhedn7otrRgxGujqcAaj4SJGw6Wp0WDTOJGVV2VUpDEqzmBUXJwcFTZPmslas/hEaTzRmeknamtj6xafJT31LAMtbkj75tE+WvS/1GL4+on20VyywHDr5izY5sxLM60aSWvm0ZrsRGviPEbn7Y6kNfNTrRmiOE7rywKdQEzGnJ2uo2uzDRbacLbF2PzRNtD0gDc5lptY0ZtYPJnmTao2ixNTbRjZvHeixUj+kZp5ys6ATjW5Mhkp5TG4PJpt9uGa80YMQqZKmNuMsWS5+ww0tS2xj7z89Gbu30lGHXd/MrXP/i2GHCog0dXfC04Xdvzh/xwruwfYTCFQGJXDsfcQuwqoKfiD2Ptlb3PVvufl/dgho4ANrbI8r9nM/oIenFl68ObowVhCD9ZsPZiL68FZUg/eUgti68Bq8uNuglRBIwp0EfbGJ4pkMSRGiix7tlqe5OmtpSYheeapVuORPIMJY6LLUOnipmkn6s5Rt+LOy67RzchO0V2Q3aG7KDtCd0l2ge4Z2fm5Wdnt4YAQR3J1exe2joRr9i5sIAlX7V3YRhKu2LuwmSQ8snZhS0n4xNqFjSXhobUL28sc9BjdJC0wUqKsCPJM2BI7JNFSnYYmNKXpZA7nte0kLTBScMhJYoqM0yFHNC8JaF6Mg4/Y4lFew6PdR5J2HwDrSQRR8weJcvabMBMIApBhJHyVYa8y8qp23nTua8N33nTuabtPEkhYM4yV/aqT/WuWuwl1KFww/RNHaa9AD7rAw85KSk57d950Rsldp7Igd3avm13uzvYj4UFfj/m9s4+9yzzcQtzYbVMw+9SO/Dv5oNxts4++2B+rG/KMbHbZSNS3kyUBIdqdETC75wwUXN5z6lkBzZ7TV3B1z6meFRB2zFpDcc/p6GWlPWeo4OGe09DL7u45xwre23NqWsP9PaeivI/2nK6CSEWo4Id7Tlsvgx3zQGHYMde1DtgxV5Uddsw9hWHHPFIYdswdvRZ2zEOFYcfc0Hpgx1xTfoYsVRh2zBXlhx1zV2HYMZ8oDDvmttYDO+a6Xgs75r7CsGOuBu2HfbDCsGMeKUz7ea0HdsyNoP1YIxSGHXMtaD9mcYVhx1zRa2HH3D1rLvsnS2W3aC77vaWy+zWMTszqmE/fd/OcG5PflhiOdDaM5oC29Tva91OIOoU4tPtBkHfxOraCGG7edsizfSqP8zl44p+DJ/E5eJKfxZMxXwsi2X/sOc+MY66FWWZjGpkF50XOZPbxa+SDOCqR56KOxYmnqPtjeHZf0+iAQQf6fuqOd/eWtseXkInbxqI6eByBcLbN0zzO5+CJfw6exOfgSX4WD8KUxN9lOblvIKs5QjneISVR9t4KKG+TEkcESKW8Q4pT9m4GlHdJscve7YDyXqS33K+YAnZY9nfYueAdnwu+713V1qFlUfHJ3GWaoK/IFVe1Lh5TIOCsuc0HfMW8FzDcnmK4qQzvBgw3pxhuKcM7AcOtKYa3lOHtgOGtKYYbynAnYLgRZYB7/Ta73Oiwasq48oN3czUynp55Fh+2xSu4e7gd8t0O3+F7k0w3Q6abIdO7k0y3QqZbIdM7k0xvhUxvhUxvTzLdCJluhEx3JpgQUi4h4SD3RXUm8ZYRmFKGwmmn4N62Kdxe4cyVN4WvLjI45AfMpcKJUDbfGDPhrGAu+wN7UmWXwWW3Gfo0uDByDY4Li7K7v4zdvd1q4njnybgiG1NmRAG47+WDWMcIgOrlhbPMynuoHKzPxXga0Szda2joYzevh0EN1zbbfuwdiUhOaVi0idfDCcj+OBITKlBh9D+SI/hG0lw319ecdDSkwXW5KWNEvcCHsOWJp8t1v+5AydwXJfNlv7NUvkGTrct+OwQbIVgPwdoYZDL0pU9+I3YW3SU/wTVJ+nkfmlJdkMxlv7qkb2b646Y+JfW+nPVEFimppRAuVFrJfuSj4rV22StOXlKcuqQ4fYnzxS+Jf/FLEl/8kuQXvCRz+pwy7sJxhwWTykyvRr5mHe+nXfoZ1zk/4nXxH/G6xI94XfJHuY4xMR+7+ybPDxWWAtUluqURri3RLU0CfC/RLY1wY4luaRJAfIluaYQ7S3RLI9xd4obHnkhwdNkfZuiaGnyivUyZM80oU1bzysv+Uabs7ZvLfmUhpPUzeJbL2NyMaccZ7J4uY1s7pg0yjLLr1xfKXnFMrWXKno8JIcJZz0AauOx3I7RGpuzdQasitHam7L2NVi2UvatjaidT9t5BuxbK3lsB1Vx+0znJ7DrdjMDthV2nmsGTZMreu2j9Ytm7Na5jNF/23kPpYtm7OaaezJe9r6B0oezdHlOH82XvLkqjzzpf9r6Gsmg/zZe9r+MJFsveT4c9Ol/2/giedbHs/dExtTdf9v4YnmWx7P3xMbU7X/b+BJ57sezdC593vuz9SfTQYjn6tIOFXed4XuD64q7TngfPfNn7U3iCxbL3M2F/z5e9n8UTLJa9nwvfzHzZ+9N4hsWy92fG1Op82buPJ1wse98YUyvzZe/n8d4Xy96DaCv6i7vOaE5CRvcwfDOmyKFJ8+yrDGFP8DYHMg247wHsE3zAYU8Tb1ZxtLTnNBbMW4CHvO4mBz2Z/zjAY4Lf4CcSXtdf2nOOF8wt3pocf5S3JvhneOuQ+RifyqL5ad6EHD/Hm4QcAxxgLJqfYXUheYhvbwndkCq7N+WLYqx8JBK4ijD0t80tczWI030Cn6Qiw6s5+K1BP1SEB1MCPxtuEj8xL+Va5qpbdErmJmLYv29EXOWcjJjabzHHi91CXO0egrEAqFF7/xZCJST4uwFtiiXmxw3NanrTFFWqk0g9RSyERT8Jd9CrgK9CTrAT5tZ4AWDuWEYPv06DD4uxf9htcL05TpnLhmgNnje1dIAeAT0aoxX44VTmArQLtDtGT4CezKlAxP7MGmxC1Qznrrms5jr3zGU14bmPbasaJV8219Qe+bLxCVURr/4GwRrAOwTrAN8m2AD4DsG2NSlhlCbRD2VkdzMwnSZYzTCz6mXzNV7fA3iX4BHArxDsA3yP4DHAdwkOAP5JgiOAf4JgxTaXzR+ThgP8I9JwgF+XhtuTbepMNXloScuO53ehY5cpb34X42SCr4Eq/5S0D+DPSqsB/ml5FoD3CXYB/jzBji1VjuZ2oXKfqPLYxkyVKOM790uPs1/3LdeneIYITvlAqKti8Q6QCjamATKyy14hQJCP41qAIAxYMSIKDuzIMPwqJOMbcm+Nrj+wudFhyGuMrKAUOQ8QTmJoI875uBQ2Y1SY+xJ1W4k1pLobgRqPUHugVhzEJI9QT0CtOpnxSC2OR+rGeKSujkeqGY/UZXPZFNXYTKZve9dJf5pkm/7/QLBNf2G5Nv2Fxdr0F5Zq019YqE1/YZk2/UVF2vSPLNGmfzSBNv2jybPpH02cTf9o0mz6RxRmvypHHTR/pW8iwSwdEwku0yuRoKFLIsFV+iMS3KAzIsEiPRF97Ht981UM+a8G21vMDcgEdN3PQratOpBtfWR7s6M53ZGH6bK5Hh5U1R09LrwMhXjDoSWjYm0Hyr0TxToODl5GiuEEntMCsZ6Dg5yqYkcO7B9qDvKvqxr1utmXO8LQeBuhgiZ6ehlEZ4poQIxPEVdBTEwRYYzME8EosQhiaoqIMEjiu5QPiGOlP7cGWIb3JySAiVM1CUp22e+dhSVpnoZo7YRE6R2cK2cLely2aXb9XrKM4zI5AKN/Glx62wkhnZDUAamjpBFJXZC6SqrwPK1HX2AlVUk6AulISTWS+iD1lVQn6Rik44TZZeKqoiaTvPqGus37Mb+HgeJeMzsw+a6mPJunEi3XgfcRzmow67aTEeUuzoxgzOdaTslcg5wG5xFjm31JMsTTGlGNGskI0hIzACLZllguMGXIckusKoiYlthWEFltiamCJbLfNrRHCUZNVMmNb2OB+qeKg8/hGrNb3QCOLFfArbJ7G7gFvWrY5qt+EXPiEAed//bavS3TrnxjLbFKscDSBwYNLq39kVQkrncl1gN2GGAjYHcDrIMuuBdg7JD7Ex3CZ3Mva8K1gr/4vns9av4Tc4u+ZQpe/rF3y3c+8DaZhgb5ja6PVf+SCbkRmuHIDcym5i7z5x97khlt4lLI+ctycRHHtwGUHkPjqhuN8eKY9xel2qvhKYP9zGCSKfgneEM3p44bHFmu7MnjhpvmJp2/jIPlLKLrM3E9bJCnh0LUTD+1dydQqsokccpTb/v2uzMPjNEZXFWEa8KmseiooJTsDGV56qrJPij4iXcXNRXVvrnF/GOmIGehYgq1+L5bjNpc4WnwQd7kWh9d+SflpH3MWgV/4U7wDLSrDl+6uWw2I9dOjgjJfxXVtY/lp3HTrWeR1oQN8aCXvcmrwvl2ui0BL/pq4sb0sZCLxk0uhm8MbY7w3pkQSsYt25YVcnIaN9foWCBa5NJjeEk0LEjbpKfxAb4NIo760wLipF/Ls7TNuQ1qxYEcS3BEXoInIe8y7VXeItWB9EtwyMsIDhxcRvDYGV9maLN0gwxxiM8Ej+OogWA/jhoIHsVRA8FefFzDqkj95E1AFCd4lEBlBHsJVEawm0BlBDsJVEawnRhXtgHJBLOL5IuVmCvIkORE4khi8rIn8coU3rOmyqfw0iQafviylw+jVn6DE+fU3Y+m7ladwo+m7ladwg8n0fSL707rgdrU7ftTt6tN4f2p29Wm8LuTaPYzbl+fuv3x1O3qU/jx1O3qU/i9SXT5M27fmLr9YOp2jSl8MHW7xhR+fxI1n3H79tTth1O3a0/hw6nbtafwR5Po6mfcvjN1+5Op23Wm8JOp23Wm8CeT6MZn3L47dfvR1O26U/ho6nbdKfzDSbT4KbcX54uOVTY7ZtcfJcvZf48u4a6EjnUZLhZhG3YkKw9cz904ndJhDEaX9WfiStKUMDDJZ+JF0tSQmPFn4kHS1KCY9jPxHmlqvvDEM/EcaWrOcOeZeI00gwCez8RjpEkT3x2ZrXbsX0nB59557N1Ezge/noL0l5MA4hDmcvDXR9a1gjnw1pCNrSDCvbeJ4HCb4qu2KYEqNiVQBTwJXdqbGTdOR0E3QcdAN2kKfuwg9ndhzVpA7LhNRJsrmEIudlTyY3dA7JW8O771zgfe9n7sqBRYP1JIcoKgCpnTvNo+3nM6sNdDrJxtvJDCKrKAYce0mX0U3HHbbJrtFd4W93LvZAy1Tb2S/I4gc51cLSNkGK7+4VWcPsYgXd2hTaAp+O1LZfequIXBRMNs+l3rfe96edUeOLB6eC8OO601MR6zkF0NRpADKErM9TL8Motyd153UPauZ/+sKZjr5qZfs8rZMoSDnoPt63g2vHutRZGuwMy8lcTTMJzrRw/DeK4aZrqgHXndx3vsIe1aUPljycU5ulpGLJZYRr3JzB3JV81W6WMOnDLFrIJe+r4fc6/jgfUlIbunuYN8m2tIlnoggrS7ae6Mk6WuIVkqugp5fzZ9BkW1y7wn5BSzLX1X9u7g6zfb5jpRIA+QyvYO5rBTyY34qeTjxBTZvW42kQh106xBrFwzV0XwOZBEqNFGnNIEXm3hapV8D1RsGnPVwqyMv7AIG9zr2X9f+v+3Suz93yoFvfqOXiq9+ef8mHvH3IQF6i9b5ibGXoUmU+am/8tW+ZOSilXO/gc0RjRl97pT8hPuplZ88A7dE+8gg3PB3FxlFQxhLJX/Wfl1r8F+0HnsvfVGzP4Imxy9GhYj17Dc4G+WdmbXUbhAdWKzBfLyJx9rRdLQbCNTEInGFPxqjx7UoGYZUvkaHDEKfi2kLwv3hin49ZBqEFD52hr3eY2QjBjO1zThTcFvhwUbEk/ZzehgvMvBeM28xa4p+x+N5f6Tj7g3l5F54Mfe876+CGuSdFmYzYHvfJtWmAeSbekAybp/2o+575kDDs4D857/0Z8vezewwcjLpWveVR3dMEKCn4Z5z/w0Lr+BZKewhvsKtyFUPeMSHCbS2Kdg1vxR7P2yPzSg3eAjvR1oFs0NpAMOLily62NumHenuLaR3XTbfAWi+1fM12To5eN6x229XJOZBnfE1z00kzVlzHsYxe/h8OmrUNh85BbN1xfp27rNSYzPux3sdq3JfWTBbI9Hu6Skbj2YTFb6a8Z67jpm2y1mdFcWfClvQSxwoYl/KxfrOuJVy9txXjgIN24Ln4zVEs6XMSSfekwhQWT5qSQQI2KeQsW2LMjqU2jYjCAbT6FgWxWk+BTxyjaAaIwR+OgUscvnGLnsx97hVmveXOXgkOdGwmuZkLYxxbSeNtx5pjjYRjxKoHNQlAGtEU1DmQa0SjQFhRvQCtEkM41sI0Im0AQUd0BPiMYxGMvegaSeNftmXjz6tOH6MPqA+tDaEegcyQ3o5idVGZEODWcmN1RVuakQDGV5dy4E52m2FGdXJOWAofiU2XbRfnyWwBImKdgqMETvIGaApeC3w2kAWNrMCZYFNgcvJE4owObNgmAxYAvaIaJ2pCdk8GrcOLWO9sfiAAPnjQa9IYwk8QhNxlUoUAvxjwNLpp9qfVPG+xqimESioX/0QNIFO9+Mrpw3dBTgfCa9i5B123pUMyDI/e6JgsuMW0fQMGgdwVVGrCO4wXB1BIuMVUewtCer2DWaObcVvMtozATvMRozwfuMxkzwEYMxE3zCWMwEP2QoZoIVCcVMuCqhmNn4GszvFa5buwjFTBib/EpC4La1i1DMhDvWLkIxU94xN3TWhfxwbdWOhSJE0GeBrDG5+PlIDWuKfuyr8ZJxnolVsHYx5QxOuF/j5HpD5mZOru9qhvW7Ovd4bxtrcpZqYX7rwHq/Y5HN+pb3tvB+JeB9e8z7lZBXp9UbmFZvmHdlnvpadKLzawkUzdzwxvg8o2CK4TrvbQcrfcbwJD7TMGsrLqbCg0Pmt8XzZ1zM2D1HIsnAiB5LfbqcfT8A/hxUt4Vc7O+WYIiYi/126Vu34iUs4XOPvc03qATbj/02OzDtrVHpDJk2gETahay7asfdNbRyjSSztgLhPZ0xm2Ztx67Y8vuvbbO5av9rm4u+5IrZDrLGNPjFhuByCJoQXA3BjRAshmApBA9D8G4I3gvB+yH4KASfhOCHIVixQrgagWsRuB6BGxG4HYE7EbgbgXsR+CgC9yPwcQQeROBhBD6JwKMIXLEj7Y/AtQhcj8CNCNyOwJ0I3I3AvQh8FIH7Efg4Ag8i8DACn0TgUQSuOJH2R+BaBK5H4EYEbkfgTgTuKowNpVl70ynu4uSP4MYuzgMJru7ilJCg2cXZIcHlXRytEczu4syNYHoXh3FriDb40GxCxD5y5Levv8f6O9DfIa58uIsTPeI94NbH4S4MljNdrf5wF/M+wbu7mPcJ3tvFvE/w/i7mfYKPdjHvE3yyi3mf4Ie7mPfX/NLjSBsHcW2b/vb19ygubTvRtnaAW1wjpK1aadfaRah8wpjD6wq3ZT4n3JB5nnBd5n/CNVkXNv0TOAKAUqUK+JM+rFhBAzsJbaD+9vX3KCENHGqD2gltoJb39CbwA6snBYYfWE1h+IFVFR5Y9CEjfGzRh2wTflZeEZQ+G7XpDxOQnz55FUdCANgTbzJpaVJbor+NpLZI8b7+Hunv/0Pau0DJcVXnwn2qu6d7pjUzPdJoNCNZ8j4lyYw9ljwGWzMjyZJKliX5Jcu2ZAs/sGQLW27JINkGDDioeYQMj4SG8GgrgGtKQDoPSIfX7QQCDSTQvEwnN4/OY5E2ZCV9cwO3/z/38ve6f1by69v7VNfpmTHkrl9La2qfr/bZderU6fPcj6p5YgWWbSlThbBsM3QJlm2G9mHZ1odS9eXcG7giHVOqPqg6TslOOYAm2zdMhfvlnB2GcQ3z2HLKFNNcfXMtpkxxTbpmrtUUAq1ihSI77HhGXpLt6AktFBCc7RSMKaZEq4QLmMJ4ipoNC5jCKgUVa4BGChqQqNhIXtWZgbv4a71y2mhkX4tIbCHpR2SxS+JSSJtSp83bpFHcfi5uJS45OlL6skm20xjEUeEGaKWhUYlaNwCCvh3mSjdAIw39SlS6AerpnHsXV3o8qvT4DLTQrvXK/dErRKQfkcWILPTbbzPfb96iH8V2cvomhHtxcvoojsHhv8gbPqNv6Z2Ve16ctrpTp3G8uJ/XHTfRFN2yzPHiFBZqU6zO4Hq036z5vBWn3evC48Uoq+t1jxe97vGi1z1e9JYcL8oeiDcsYo+KClH3ePEmqA49nXMP/adOFw/Rof/M6aJHW/UULX5p925SdHd44rfsS18Xni7a70uK34pzeThd3E+K9kdIdgkyvihXbxVsldNFPt7c7inaehrT0SO0VV/Hmlcq516H7+nZB4x4oSOJPfz+qDTLMGjRAeMUnjB0IHwNiNsffXa6iTzbZqinTXDKW3zAOIVJa7f0fMAYliYqiDtFigsXsGc5c8C4qCwhL6qr58EB157Y7IRF9qKPdhPtt3nvDnl7S3ZdeMAYWlnJ9uJe1tnky2G5HOQzf/l9MTArl2m5TOIHCsHdn6jT1SK8lmMPbO/+TJ2ce12YQPwCL0zUVM69KUwgrsL+MIF4CreECcRRONQVoHLu3V3RKuce6T5U5dyjXdGxnHtPV3Qs595rdRX5cBKhTNpcsRWazrnHwnwVByrcrzCK09dyTIRXwBl0K2F6RwW97dkuQ1v2IrvpFm8jXHtlvJk0ElXOvZ9uiCRCmdcsYLnPUxih9nbTvsIAde2V8UZft/QxCVsj2/t1R/b3qzBuvxbHtpgMsPcRbCEjgOgDdGNUwBhGnJujAsYw4NzaTTdjGG9u66YRr+M2yK2nBJjNuQ8azVkkp3kDrJucxGBwuJskDAV3dpPjGAju6iazGAauvTJeS5t3ajlyLNF05Fyi7eBgAh7AcUpwcoY9YcRFf+VaGajhXUQ0ieH84zrR0sVu7/ZQvfgao/HJ/immQvXia8xXZY8TrwzVi9l1AntCuVamK+wH46ZQe/ga2h9qD19jdJLZR8ShUHv4GvPp2QeLtAp2miKavOwpQxnfFPeHurvXmNbATimkIbC3DGkD7ArkaKhbfA0dCTWOrzHKx+w/ApWhZsTlRNJ4iBCVYfYHIZ+fXUrIl2fnE/LR2dmFfG/2wiGKzuxc5J5Q/5gfsIf1j8VnBYSKQUINpDSHKkhpChWQ0gzKIKUJlEDK5/dBiqlEMS7yY7xQuMbM/a/Bvlod12s47nyarsmexXiOQOlYjb8CDl/NXnsiIwvwb5tl97XdZffucM19LdbcOFO4dp0Rllm8oY9eEWdHWOB/dw+8UXhJusaMG3tu8GLZc+4r1ulrsaHxlD6QEQUdd8qb38WOtCV03FS40y27mFM0RbOy97Ebp1CilIksOEVqyVlStB/4SdcJZIM5vztHDu7OJ4PIBCDcvJ3Cc8bd3TKPmJp0Rt1Z2SqAp8LdLgI1xk8ab70n183hFGEKhwbuK9hc0HVE2UmsfpeyY9TAaYKwZ4U9+3PZC132cWEf/7nsxS47CTv9XHa/yz4p7JM/lx1nFe4U2KeFfdo1keGXYeeNHf0K2ufVsQdE13p9fBZJB9bpKdrmFb4VE3W76Jy5V7MjvdyNc4u0IhbdGX/JO/SSdyZf8s70snfwM9jmNb4VM9PkbZ7/J3Ct4pXYlsy40QQLXtAoUF5j+uet0IVPQ71mq3EekRVqHBveW43rCBJqElviW43jiGmhZtlnKvSVrpGdfomgKb4jDgp1GOqCW43niGNCHYea4FbjN+KUUGfhR2qr8RrxjFDYTc0robGbOm9oOI0oGLoogRm3hk4jfEOXJDDj1tBpRNnQFQnMuDV0GlE1dE0CM24NnUbUDd2QwIxbQ6cRTUO3JDDj1tBpRNvQHen+t4ZOI/KOKb/DTmK2hk4jCoYuSmDGrV2nEYYuiU+lraHTiLKhKxKYcWvoNKJq6Jq4BJLyS2BGKb84kpLyi2a1lF/cIEn5JTCjlF9cE0n546xRLeWP86gg5ZcQN1L+uNEiv0aC3/mGLsWNHvk1EvyubOhK3GiSXyOh4qqGRqi4mqERKq5uaISKaxgaoeKahkaouJah23E+EJDyx/lEQMqf4CMBKX+CzwSk/Ak+FJDyJ/hUQMqf4GMBKX+CzwWk/Ak+GJDyJ3jXR8qf4KMBKX+Czwak/Ak+HJDyJ/h0QMqf4NMBKX+CTwek/AkO1CjlT3CgRil/kgM1SvmTHKhRyp/kQI1S/iQHapTyJzlQo5Q/yardUv4k63RL+ZO8KSTlT7IWt5Q/yerbUv4k621L+ZOssC3lT3KgRil/ki1ipfxJtoiV8ifZIlbK38cWsVL+PraIlfL3sUWslL+PLWK5L/L7eJuI6VIfbx1tEz31uXjpEG3zyi8gxoi8EDq7iklXTLpq0lWTrpl0zaTrJl036YZJNyTNcYsOzMXbt9M2r/N9xEfxit/qRsze5uVfYMy3sXnBSjZWEKxsY0XBKjbmC1aNsC2e+C7Cw2e8RhLaTAiWbBxV4Xb2UTzhBxKa5az0+vMmeUqSeZM8LsnOC5I8Jsm2SR6WZMskD4r/7C08EWweYqe1qzBaTtHLcaayLUN7sM5ChBDaZkKgb/PU6aGEisUU2yJsozmEIfmLmHiQ5i57zkTiKhgyyx32nInF5RuSuLueM9G4yoacRmft7KG5LbGqiiJ7ILCzIvWwieqxGMguBsYXA7QYmFwMTHeBE3jzObzx15REhsESats25zIJ3/LnsdynaRo7fZ/eS+98hwR92bbNmaSrJWjn9ZMOiZd4B0E/R11WOUNkSZwlcXDP66H/cb3E4l46fbla3pJ119IXJMYBh1RPL8OeFvassGcNOwdUzy7DnhX2cWEfN+zjYB9fhn1c2EnYybAT2GkZdhL2SWGfNOyTYJ9chn1S2KeFfdqwcyjO6WXYEXIUW4SbJPq5TnHsat3H0a21RLzWDkfB1nGOjK0THOwac6KdEDw9FT+LQ/OdKNT0VPwUztN34v2np+LHsOuzE3U3PRU/DE8eO1Hv01Pxg76OI4EwmDzxgUbBTtTD9FT8uJ/RSYpRbCqeH3LTlL7g4hQ+Qf2PrHNxTaPstYco5tX/niexMfgmkA29xAU3zbE70ggZKNEF0QRiXgO82ygGpxzGI9KFnkAcDipHeJvgvZZi8OVhNiIvcPUpij/S07RiXgu811MMLkDMj6snKqBEBRHe9t9znO0YPIeIN6XkBQ4goiSsICWpL+TtgHeOYnA4At4+6rvgJikFn5iISwiHl4Z30ike09O0k+bCFfdOujpch++k68PV+U6ziqyA3CaLT5BT4ep+J8WujNcewqLf2UMx7+I3YrktsVhiD+3EfhNq/F9iOa/9P1X2GW4D+Ej1MzzD24k6/hcTP6kp6WaYbkm6FabbinZiawh1Aom1GDScpAeMec0m9+doBV7H0EP4ci8KPYyCGLwfYg2doZiXNzwDKI7BV+Axhh5EazE8q73G/1KsBuo1hYh7LSEStBM74/xhCz9FazAmrgDmAUyZsArXo87yrzEbNIhtcD3UbuCWMh6w31rfd1PS8aYDbtWv4bAvK6AVOgh1UMTicrMBhwa+HrZ00AKJw/1fggMvuCpg96YcUfh6ysIeHjZvHHc45nV+En6lmNf4Ycy0wphXetHEDol5TQPHwRLBLQMn8FI/6kZ1iXEEZWl0Ma/yoy5/x8Ap5A35Uel/L3gaP5kfd9nnDexQzKv9OBTvU7/X5lp2swFlvI7Q/QENePmfMZ3BS48QXqLyYjcASsxrhQkUuBgVGMWshcVE4TrdwqFIpR93I6rEvEZUEHcApSyLUHyymNc0iTgSBZEifhxjXtUk+3CvbRIprgBfhMK3a8yrm4TDzxilFfDeOAiFn9XEb7YyWFjQY/x6vv16dfv18r2vV7Zfr9nzegX79apWPSfx4CE8eFgevAruevHYqv3Ytv1Yv/exdfux+R/bjy3bj21atYoIIQsLeg0/qWg/qWY/qfNiz5NK9pMaPS84bz+pYr3gSvxQBuCgfEFPQL78yGmVr1fjLU1ypa+z+OFVjtOIr0dp5QW9lkYu6HW06oLGL6j9E+kQUI6WobmeDY1CNH4SdUT1n0QdUe0nUUfUzDJ5GdiFXI9iGI4N3Ftm9eVclid0xlJcs3QJI3IwvgduphdEv2WYsgvix2+IViOGFPcszvM6ucgfToKSFzUi6yah2KhwUdazMDZtWHCTPXlMas/v7UEDSdPEAr5YitYs4GP10Rj0WU2OXXsC33WWutxig2Qnw9p1zgUX6u37LjyHf3+wO1igzEW6zN/3b7/1f/3Z7Q9P7w58ty9K0JCvhyiFMgeUWpRrfU+ulJVr2NfDlKbLpcdM9+bryZW2cvWHqnxdX2G7A9cxKn1x/Gz1ChpkdShfD2KKnnO3GZfwMey6tp+gGJQbW7im5+JNXOGnBdfhuXgd1/65eO0Jup4GOWiphFqkFTLrnONxY0DmlHM8qqyEJ+YVNB74MnVE1349rcIAMcChHnmGKAMAezYfpLWCTiKQVYZ24qSCps17Ht5NO3E0QgdpetKJTTrpkfUx4rlC7QyrfNXOUCy7BlwrEMvxz+PO+LPqvKf0WmcPSS+MdjrrrlpwV9AKbnCY2ytMpTGK8sTNHeUbC5jKmLtZdwgZD7qrGV3AzMXcGneHceuwO8bogpuilLlFLv9Ej7lrGF3AxM/cmnRHcOu4O87ogttP/ebWtLsSt065E4wifLWDW/1Apy8+x9GdY1PxyYvPuXGZ4XFs59hUnBjqAzl+8Tl3gOI0gAPjLlcSt7LMlQCZ7uFaASi2XMbucTJ+VxOIqXnR1ytpHHGmL/p6hNYg7txF9EljiCh9EY14NSaMF/EjGEXDvIiGt4pWMJVBs1uJnb4YYsYepxjCxR6TtnZYmt5BiiE+7B6K4TBo1ovptRlam3m9ip8nlf2kch3v7M2JPRyE0vEyMHBw4Fng7Dk3kX1fUscpRgkPnlCeeRLb/zGKw710jJxtDvRXQW1H+9dxcm6CZQh6FodnbXhxY3QSG85kh2OZ65FTYW6d/aTKfizpqiud2AzLU1jRxSadGJ6i9grKvqwzR5Q6L/lwMOGQsyWWcZU3/rQ3/jovdtCNr8Md6CHH10Go0xXq2EKdHqEzSp330tmYq7KFJCnvX/5vhRdTXiJHsWxbZd8P9KP/atDqvyovkVWxzH84Sj0L0TI14Hk2EmlOpCWR5URWEuOcGJcEcYIkMcmJSZDTqGk5K451D49jcpock7PlmJw08+W4XPDl4yxkOgpQ1D7/iO2x8Jz3F+PewhCp7Dg3zeiO9/4x768G+U3kXnq5e2m5l13uXlbujS93b1zu0XL3SO5NLndvUu5NL3dvOjue+d9jTur8Fc9ujHm+Ou2qTbwm+vYElgylz02EDsNiXlsw38ZaghVtrClYwcYags335P06Y5XPTeTcuNlVinltQaufm8h1sY5gNRvLf2ciF+mTxLyy3Fwwd7/BOep2jnnBGjZWEKxpY0XBWjbmC9a2sZJgHRsrC5b/vIVVvjGR05hQzX9+IqeT8T0IeA/jjEQOM4iQ0aEEflx9OaxNbTC7HDi+HEi5RTJTcOCS8v4hJkOqV/jORI4XCc0/tF/4O1K9f2h9HF+wuo2VBGvYWFmwki2vIljZxqqCVWysJljVxkrxnJvApkia4jLZS2BvBDrTCd57G8esCV2BQv8LOwuOvq28ySiEMDouDH4r0DFwxkmMZ+wegpPTJnlWkrMmWcRivL9Xg4ntB1acNPr/6Jb6LyK0fFqSWSRNeeLomvovwoiES3kBiQwvP3m8jQ7G3FE/arsQAI7jLuYkcQyymyzWYd+9nAZYFoeQiLOicpaFlpQVWTFwBzGLj7PC8loRVVHuZothte9eYSVdX+S1lTvC8jrKXWfdHzLy8o57mcibd9yXWQxjvmsdBLobjbyq465keTXHtY4Q3fVGXt1xtchrOO6VFsMG370Kphq8B6toFb91P2owTWsC3wrpGLhrfBrGQmsAES+y4JgIfCueY+CO+7Tad6csZAL2ICPgxUTvMuvOWp/GfPdqC1nnc0wbShMFPmnrzmU+bfBdkoLOo6AraNQnKdCwhAwZ9Eker3uqn0ZoyCd52JaeiqSVtN4nEb1BROcheoADx7D0NG0KfHcFLFsHeKXLz0jT5sB3By1hWZ8G8JbypDS9LPDdIYikAbyQPCZNVwa+u97KNuLjPFPRKjxgwqerOYv9/Vb6mBspXuTSah+REQKfNvS0a0ybUCH9mDjj9lBvA8VTjpGiy8FxBXNs9OmqnlaHyZbCWcIwmDQzjfk0ynN7CM/6ZETNsiiXhQxx6Fi8wIRP6y7VKAeeBT8+CWdZD1n7Rv55y1uf+8i5Gz7JG/wQkAkgY1IK3MNwlgX2BzTFN1msff8g18dqU0D7Dgw9oIWU4AmBecH0notuv/Xbj+aw61zu62IcAgsd2jS66n7OzKHsgM3a2Lhge05b2IRg0DKLwLUCNnrAdQI2e8DLpIaxTED4ZulAEQVkkBQraEWs67nDhv32BrAUlR7CtaCw4YJjcD2Ma17pLK7P6BFczmpeR+S/M6FXRSbJu4GVPzeBRc5qsybigFkx7OTQKGWCS2s2P9AZ51la1Q0f/Qi0CvppMNAr+LeqV/HPW49yj6BXUz8NB3qQ+mko0EP7ttx42X//0ba1u6Vg41KurJQrrVdy8B7MwBPRQIJ9hLiW+TN3+RgoUC0HcavRvZUNb61Ci4nhBDi8NR7egkddte/Ey49OX/Vbr9ith63th4iM4t3qKBiujn6mOuq0dNRV66jb09GAoKPuUq9Z1qIvmoPqkYhc2SUzegyTBUy/hszmPugxoeugB81YDnq1GetBj5q5AOhVZnIEer0Z50FfZiZXoM1mfBH0WjM5A73CTN5AT5jJHehxMzX82kSO1pipI+i0OVgAnTVlBj1iygx6pSkz6AFzuAB6Aw0HPBVw05ShNGVOrnONvPnvTOScZ6OtmIGeWcJa6wYNBO4ApbET0sOCYFcXM9R/UX53vsJmwEf6Vfo8vCvEwpl3M23PY9AJxGXtIn1JSFPOdQxtGplphtJQY+yaN2lWPeyRt89aAuWxaQ+XvilyoinfAH7eiWi6N5DDxCRM8892YC5ex/5boz9Hfd1JW7M/R8luqtWfo1Q0n+/PcYdhPld/jtLRpHAgF5aw0iXZ1mGAl69eDOcV/Dv0GhFvvYe3hndpDuRIsbEPl2AgZ71HeyAXvQXcNoNzVlL5TI570O7t+QzfPth95VNz8QKmzsVMDsmzpslK6hnTmCWVV6adS3LeJCuSLJhkVZJFk6xJ0jfJuiRLJtmQZNkkm5KsmGRLklWTbEuyZpIdSdZNMr+Ckw2TnJdk0yQLkmyZZFGSbZP0JdkxyZIkoTXE7yvJeZOsSLJgklVJFk2yJknfJOuSLJlkQ5Jlk2xKsmKSLUlWTbItyZpJdiRZN8n8oLyvSc5LsmmSBUm2TLIoybZJ+pLsmGRJktAy4veV5LxJViRZMMmqJIsmWZOkb5J1SZZMsiHJsiT5XaE6hF2/ltyqGs62JGsm2ZFk3STzQ/KyJjkvyaZJFiTZMsmiJNsm6UuyE+9OHTbFMn92bfzy886zqbdsjHn5Ruy0m94UI+hAY83jXkFXBBTHInQQY7VJUs4dCpM+T+8nw1uYy1icsznXjTh9vZn3q1oq+yGF81awbwwVjZGezLmbQm1jpCnn9ocqx0iP59yB0Csy0tmcmwkdJiOdzrkrwuPQFPWFJ6VMzrJmM7hMN1By5MZBVoRm8jCrRzN5jB0eM3mc1ZCZPMXKyRACLXklZYszAFOA4VABGgAMBbKhGjQAmBGMhMrQAPIq564MVaIBQHV+VagYzQ88y4rRKXaYPAqgxMZtKQTRcFcDKBvAj+fcMQAVA2CJvQZA1QDleM4dB1AzQCWecycA1A1QjefctQAaDPTBSE1fhWvB0VO45h19Na4dpbfg2lb6Zbi2lJ7Etan0lbD/Zz23lFeL59x1dKVIr8dz7mU0KYlGPOeup5dJAu5wNtAWSbTiOfdyuloSnXjOJZqSRDueczVdxQnazOpzKa+QyCGTYo8eKZJvUoITAvkaPkj5DkWQ8gUKIKXu50FKref7urXeSaKQKYxNfyVhEFIYUyRIYAqDje3pmsu9FMJwlcJW/GbZpWkM5MiQ9YisRWQ1IisRWQ7JPkysr+ARWW+mVPi4d1fFTjBFm2lzwIHwUnSFObjI7w5cgVt9tAo5r6AVywkoRQIqywto99FKEZBZTkA5ElBdXkCnj0ZEwMByAiqRgNryAvIpyoqA/uUEVCMB9eUFzKdoWARsWk5ALRLQWF5AIcXrFn0FbVxOQD1FKS+2Q+Uz+AWuMbv4Ka8xFjYdthvE3ULGTG9SXnOsS7Yisj3WzV5ek9v7/5Yqf/TBv/v4d8K2Nd69W+k+x5S9uXzZiyhci0O8N5Rp0/mJ6HnjSxrwfHTXj8jCxBLGUnS3GpHlpYy16G4zIutLGVvR3fzaqIxLGeeju4W1S+760d1SRNbWdifKKa+8NFc1ZO3z3vq2d6TlN//dtTlJcaXX16Iei92+4bIcJdngnIspqbR0VUnp4y/Dq6xHrqbU/ig6h7S7mUZDg8TVtJlWh4kx2kxjYWINbaY1YWKcNtN4mJigzTQRJtbSZlobJtbRZloXJi6jzXRZmFhPm2l9mNhAm2lDmLicNtPlYULTZtJhgmgzUZhAIIqY19rAU+60zKJl8t3cgFmM3MiaufiGHA12p975y3M0ZFIuTN1fxosTPYkck/pKHJzNxf3LMb+5PCeDR8wrXJ6ToSPmFS/PycAR80qX8yrqMrhohj7EH+eV+Z3FvOLOnOt4KUn4O8H41zeAEVpQ+f/NVgnf6DPLjhoyKuGtsxAvvx7MmKL924uR1PrHVC4U2viY6kqFkMrfqh6h+R9FQud/ZAmFysPnv+F0hc7/RyS08B+9QttfdnqEVpDPCK2yDBGKe//yiXhXZrXpdGXWmk6PzNLH4z0y28hnZHZYRiTzE+9MdGV2vhbvysx/Pd4js/kfvTJLyGdklllGJPPv/imSWb6Y6MqsXEz0yCy+mOiR2fynSGbrn3plfvDbya7M1juSXZlt0JbM+teTPTL9bye7K84iZBj5JQsvW7IrTHv5VPg96smc24f+N019sjjHRY1Japb43rSAuwQ8LuAxAR8VcF4JmlcC/5pcoVHIeMngXzTpukn/0PA1zDXvyP2Ouf9Ok/YduV+Sq/qMwWsGrxv8Lw3eNnjH4P9u8GJccF+u6lNxwasGrxn8BZNum/stg//M4MWE4IWE4B+XKwwYGK8Y/JsGbxm8afCfGryQFHw+KfiHTbosaRgXMP4VgzdM+h/N/abB832m3vvM9+gz9W7wLxq8bPC6wX9o8IbBOwZ/Z8p8j5Sp/5Spd4OXDF4z+F8avG7wtsH/3eAdXmWkzVDf532KHSsokF13C31eNWJ4IWKoRQytiOFnEUM7Yij0dxk+3t9l6PpA6PMqEcM3I4ZqxNCMGH4aMbQihvmBLsOHB7oMhYEuQzli+ErEUIkYGhHDP0YMzYghn+ky/FqmyzCf6TKUIoYvRgzliKEeMfwwYmhEDJ2I4Z0rugz5FV0Gf0WX4TMRQyliqEUMfxkx1COGdsTw7xFDJ2IoDkbtYTBqD4NRe4gYXogYahFDK2L4WcTQjhgKQ1F7GIraw1DUHiKGb0YM1YihGTH8NGJoRQzzw1F7GI7aw3DUHiKGr0QMlYihETH8Y8TQjBjy2ag9ZKP2kI3aQ8TwxYihHDHUI4YfRgyNiKETMbxzJGoPI1F7GInaQ8RQGrG2OWO/+iNMT+LbY+9lIrbNmQex9/xMPM8EeoIXcetDP0qKO1qKeR+z6E9a9Kct+gsW/eUf8YAWM3ur8z82kmv8CGsyXOVSFH5sjZEW7Vt0yaLLFl2x6I5Ft0H3TLtjXmsZrLkM1lgGqy+D1ZbBqosxL6YzG2Pe9Gl3xaYYpcP5pNuPGUT7MurH3B4RY3bIXj3M+PRmOVq6Qo6WEtTv1foXLdH62fVNL8Suip9ny6J+rNUIO2MBkIYTIpHSpWvuYvug1Yf7bCrXL3sfrMua8SrpM5h/tDYiBmyGjb0H2EeYrPm4Ca7PYcFdiMs+xAC2F7GN4BU34WhgM22O9DZNlvn1ObpCyNqmHIq5iGUF7ML6PH99jvqzV6MZb86hMo7RAHrvKXlOJ2legjZj0yHry85gig2LrqDN+17B/35slqguV8DJdXwAnIGaaMZ4C1nhTcOqJk5pr4StHp7t1ynH6ZxXW8fbPw6lJ532ZZioJSl9ZbxzmWmbO8GYX2/pszAybyEVRgoWUmWkaCE1Rvz1Oa/Wxw+EZlEMWGtjzqspg3X+mLH6ZkupSqCaBbUEqlpQU6CKBTUEKltQ/k8Yamy2ilH7LmP+1VYxyt9nbH6rpdojUN6CfIE6WyKoKFDbggoCtSyoIlBhq1WM/J9L0a6zitH6C3nPbdZ7ClSxoIZAZQuqC1SyoJpAvgW1Bapts4pR+Tsp2g1WMfwfynvust5ToLYFFQRqWdC8QE0LygvUsKCSQPndVjHa/yBFgwV8txyNf5QX/VbMelPBSjZWE8y3sapgRRurCFawsaZgMO2MSlP6iZTwBbs0hf8h7/sDK/e8YE0bywvWsLHOT6WZ21hbsJqNFSVv+wd2aZr/S4r4l1FpBve++0ufyH/6w9/7wVfPm/eAu+Z4FgZpzjanXE/S0N5P/Wm9/uNPv/2de0whsDZPYFBN4wADZxr/Y1AlWe81PIDkg3/RMVXGrYBoT4t2qTJuBUQ3GrokogoNLROm2K0AU3tEI1gZhwJMHRadYWUcCjB1XLSKlXEowBQ7FGCKHQrERGuC1X9ioknBWkYx0a5g1aiYaFyw+grT4lAAZWC3PXFKQMHQweEm0klyQhW7uOjw9ioPxllHGfxOpDyYQKy5hPcHcaOPr6QLbcPoArtaCn+zW0yBj83F88fQSBox3MIl0rIUrGBjRcGKNuYL5ttYSbCSjZUFK9tYRbCKjVUFq9pYTbCajdUFq9tYQ7CGjTUFa9pYS7CWjbUFa9tYR7COjeX/mjFcIi1VweZtrCBYwcaKghVtzBfMt7GSYCUbKwtWtrGKYBUbqwpWtbGaYDUbqwtWt7GGYA0bawrWtLGWYC0bawvWtrGOYB0by/+N1N/f2PUn2LyNFQQr2FhRsKKN+YL5NlYSrGRjZcHKNlYRrGJjVcGqNlYTrGZhpLbE6vdtj9XvQ73J/YadpylY08ZagrVsrC1Y28Y6gnVsLP+3Um9/a9ebYPM2VhCsYGNFwYo25gvm21hJsJKNlQUr21hFsIqNVQWr2lhNsJqN1QWr21hDsIaNNQVr2lhLsJaNtQVrdzEvxvraMa/ztzEo8iW7vSoD8ahbTaBbfRLdajzqVgFmlwPHn5S+Nh6CSTgcTHp/Hgv72ivjxRMz8eIJYzaJWnvRGjpLgpVszBfM72KZt8UddX71s9C/8RE42mE1vSSuBaX7cJ1XOoVrXuk0rs9o1u87qwdwOaUzuBzXK3A5ptlm4LAewuWgHsZlj87iMqtHxOpiJZsc6FVslaBH2XBBr2bbBj3G5g96DSsE6XEeMuPiXZLiXgmeqdgKZDwQAxCo/LLxx1ggdh+rAzH5GGWjRDb4WMXQNK0U3lkovqJYUJBFKdmuV5gPw9AX70GDwnwcurV4Teh/4q3hMV54n4HKJ9cLTE25ojguttQdLFO5MmENx7XLNoK+zwuUOBYocS/J/rE+m1Dp8/ym/ViSuYkc2yQnIpsHh9XKMQ1hiqchTPE0hClMQ7yYTsN2AMoQfZQ2BgRxJFOUCBtSn1gRJDG8p2wwuxw4vhwYWhF0wTSsCNLef5PGyQVq9/GpL9OdPj7AZTqf4rNYpudTfKzKdCHFJ6RMF1N84si0n5rDATXTpdQc9j6ZLqfmcGzMdCXFzm2ZrqbmcJjLdC01h3NZpuupOeyPMt1IcYxxppupuXjT0C0YEhq6nZqLtw3dSc1hD9Vh77hx/A0/DLvPjeNvFykwUrCQIiNFC/EZ8S2kxEjJQsqMlLtIP9pMvyxqM78z4GTOp5+FDaH/wgT7bzM2NHxGVf3SRI6P2fL/MJJjU9r69Tmd4hgdsS2x//nZCVgrsAli+7MTXv4fkmdyXn42R33Za2GIwjC6A4ilBJ6c2AYMqq/xmwfZpGs75FAq+3KKZSdZ3cl12RSv4C7g8GsqXvnahFj71r42odncsPW1ief1kJfw4p5DSZd/w/hBn0RPOSXN2jgFFTu+KWngizCyMTe+DpFBYCq5JTZ7E5vTqdsTnCRybto/6EDPWm1zZkl192+wUDgmypCHSUERFHrasNvLOHsobsTcOqgiMaz1HIVye4Rt7xT0T49B/vbYHLwmsDGeF9/vppFzuxc78KTbvz22nWFnP8AdDA5sj+1g3fPBBV4M+JYZr+fcvM4dnIsflreacxP4YOnBGK3gQiyYrZ6/3n1SxzOeosF9/tihD2Hv5yTF1+Hl8YFmxcjwJjjM2BKjA4nznvLi5KxLsuUgDYtN54qF52jFvjePfubAi2/64O7AXUFD6AjZqHMQXeHzXd30wB1EiU+uO3nToPIcL0GJdZ5DA+syGp3WkOjXD4tafXx7jP2TCOUltUP9N/HXQH1D7dnZHkuINvlBsZCRlRL0qNWkE2PrWIlF2yM7I5pw8+5cvPq1CVZk+zZfWt+e8Pd9/3v49y+72SQH4NcnpGFWNgZ6RMxFyxsDvVLI0kaohTPpb4QyOJPFjYEeErKwMdDDQs5vDHTWU9qJ76ERtnaMP51jOzUoq61gBLGYE15lo5jG6xHCcxJeOQRWsjVpwiuFwCoaZMAPgUEaYqAYAkM0zEAhBIYpy8B8CGTRWnFqPWDmB/jVuTSCQG2oIVYUdGklArmF6YpLqxDoLUyXXRpEILgwXXJpCIHiwrTv0jACyYXpokvZhbl4pzqRMVtupj86yG4fY16LzbeujFe/NGF2K8Seq/OlCXjJYCtVryFY/suWjVdTsHkbaxsbtC9ZtmUdY4NmY/nvig1aF8v8WVz1PWtW9dzbuHFu3Nz1pN0EJ3iOknWTGMEV9zqwke4LxNIBfY6b4gTbjk66CBfjy+Q8zr8UGOdjxR8gWg/iPLMzBbRs+FHAD5w9hUzFj0nOdJjzuMl5yuQ82835jMmZVybrvJK82TBvQZnMRWVy+6qbvaRM/nKYv2Lyj4f5q2H+Wpi/HuVvhPmbYf6WyU9h/naYvxPmzzvd/POOyV9wTP6iI/knw/y+Y/KXHJO/HOWvhPmrYf6ayT+deScmTc55Txq20935RhietYJ2nKiTZPV6VqMVPWTTn2X3BCczOolRkUOc2lJEn7dHhGjfiuqyJUGrTFiS+rIlmY8vLUk1LjrPPSXpk5I0lpaksLQktbioSdslcbolaS5bkuIyJanHRb+6pyQpKUlraUn8pSVpxEUl2y5JnDuDhE6LoPZSQaWlgppxUea2BSUylPZ+HLuFkudInaO+c+Sco9Q5ip+jxLnMP/yVE7/+/EfVswp6yNnT7mWbeL28zSl/m7/rpPNvLybdNSA6LyYP8oRmDY8r//ZicmPMa6dOuys38VSo/O2ku5pWe997IZWbdGLuOni8OZODNwTONHkmJzobazA08T2oEbkqO0VZWrMllt4eK54QcmJ77DlDrt0eu3CCVtonR81Ub7qxKF1flK4tSlcXpStIi2LAShP5YaWJ/MDXgrnOm2veXFuL5JQN3ukjeBtbg/hqKVM1eohWIiapnoQ1yt/ETrur2BylkGGPKrNyEDbBWH6UsRl00auYhPestpC7MDIIeSf6eiH3o88W8gC6dCFvYb8X+hA6ftjAUMz7wVqMHev4nCh8unvHhSD7UaXvpTvoFroloAN0IKD9tB99yZ10Z0C7aFfg0xzNBTRDMxzT60JAhy4i1528+BrmA7CM10nm3DEpfQbnUayHrufIAQfdiQLtoQyU+NjIbdeF7EdVQHM0E7iQnPWYk8/W+HDHHYHOa8MxxmVX7RY+Vmf1JSRCrx8A/BYyfNA2gx37TVDfzrAaNxRPuzZqgctvMxp6NEnjuM0doRmLo+dBbJzS42mGD7bkVTfJS07gbI7PqcjJXg3lwKzez8/QB1ijUN9CXB+H2EOIvoNfNkH30q7Q5u6rAVfIHXSIbglc1Ds+xwzt97k4+DtnHd7hJdw5mqG5R9b5WU/8Wwx7yadz7ojXGTfetPgwjUagc4o6eJT//fSreEN+CTfUdvRieiS+h9I0Yj5n1c0RvmRtQy7UQMx4NQPWbbBuwEYEjmCDe8RbzXOqtDe/GRxpry2zLndO6n1+U46YHJVKTHt5w9jaZBqJMPqbc2TIxibhqPZyFCOOAsuY6z6lHD4lzQem/GlZ+5O/i6nRb5iPju9tqjIHldUtsdhNg5EfCvwct8R+sBZ/35p5MoEG3VknP9RM1Cx2SbOY+f/RLOYu0MxFu0Hge6NB7EKDQAJ/Z6wGMWN+STR3Eg0iQ8OYWg6b09wJOc11tsSKJ3hsUaA85wCWR/Cy7jn7B8OD+ersaXeE46Q5OJng72i2tGZkS2rO7HTtko2q/WYD7IBsX91i9sUOyabWHbLFdadseN0r21+vlM2w+2Rr7FVmp+wkjXi1mRzUU6dnuCFVJTUpqYqkSFJlSY1LqiSprKR8SbGiLCu7/lcFnlmjDTHilSOy0iXpvyI40gyN8GgwSyN0MoopMhcvAnmVjRSA3Gcj80BeaSN5IPfaSGeGRuhOG2kDufSp/bl4C+QtdMCfizdB7qdd/ly8AfLS792fi9dnaMSrr8th+0Pl3FFzFs/da0mdcYflNvrRWViojNIwW8JwH8DNzpcfKWSEOt9pWDsLb+EX8yLwhjAXfzEzTKbTzAwTnmHxMtfLHGoNGQ0E7jjQGPmdVp/RE4YvE4bsmcMww9t2GEH0jKf0MNaWIs1bfcYd9VajjOluRBcjgcai8CkCpWl0CdNoxDTj+3qGhhFgZdh0aSPyu159hjLMRzPyKkBpwoLSeJ+0txqBFc3DwpCaMxxS035hGvGKMzm9/tKErPDPsdPuwCYjc4C9GGdvdac43EASNbIZB4oiq6TcV+u7KMnV8Wq6K9B3eUpfwVuaJV5eXoEKuRIV8jKrQjKUpJdF7wm73Ct7bl4Z3bzL9/VddAUq4QpT2gEv/wpTC0l55btY10Vg2mxhdjU4YRWUlL6L6yCJu8muVLatQJsW7/XEu28Jb+wMNmYzpjK4EdzVO/hzVspYzmvuuijHrasQZSiBansZ78ppbZgTXlmdyektHuxKECE+wW1OniEfJ80seNyr7UlANCbcheJRhh+hM7TZU/DJb9kti7B0VNfwaBsLFvRdpOEZa7MEw74reuzqM+YzuVewWo+8mBHgXsm56QpUIV15aSnOojL4NhmSvXGTJXwm3UWvvsiRMzfj7TdTWvdWe4YIN8jsWXa/RXMwp4dpAJHp9SgNeKW+nL4KnziZ01tpADZl+hroHzk5PU0D6Gb0tTSAySDXcWssp7fQgOcncxryCmM5mCJ59UROv5wGvOrqnI6DP57TV4J/NKfTeE48p1fguaM5PQh+Bxu0A151VU6/DM93cnqcBrz2ypxeC35+qwGvuDKnEyhXLKc3oD5Hcnojf9B2NmeapoMwo5hmEgZm97rsbRAwnCPiaedYqBwxgNBydJ3kzd4C+3Nsz+NvafjSYrw0LFCHoTKgsoHyKfytAKoYaJ6hKqCqgQoM1QDVDFRkqA6obiCfoQaghoFKDDUBNQ1UZqgFqGWgCkNtQG0DVRnqAOoYqMZQHj788lmB6gzNA5o3UIOhAqCCgZoMFQEVDdRiyAfkG6jNUAlQyUAdhsqAygbKp7nAgCoGmmeoCqhqoAJDNUA1AxUZqgOqG8hnqAGoYaASQ01ATQOVGWoBamXR8PrgKJcwXXYnzJ7YAEcO3EYEHTXX7aKNPpwTEXTZjPEs0Hpfzu0n4ln11SFKBFUOl8STcR8N0HU8E+zH09NsUufL6dAAttL6wvQ2pMfhATt0uzhgXGxLmt9B9Ar7/DmRPABtV37QNKeKJjXJqYJJEafmTWqcU3mT4rqBUq3xCzxAA1fG2zyhQi2O6Lu46kb0q/lzjein+RuN6NfRBtrIk7RJoQgPYmocD2EqiwcwxQFHmOJa2gyXAtMoNlMshSmWwhRLYYqlMMVSNnfdEaAdrNSv54+/Ur+Bv/hK/Qx/5pX6jTROa41splg2UyybKZbNFMtmimUn6WWmhEyxFKZYClMshSmWwhRLYSosYWeVfhM3+FH9Zm7lo/pZbtqj+pdwPmA4meLcTLFEpvgpTPGTmeLSXAnly4jiu0xxDqZYClMsmSl+GlP8dvj5rNa/rPhzr9bvZaK8Wj/HRGW1vqDo5Ww0hicxxU9iip/0cmOElhWKn/TyrpOIDF1hnsQUS2GKpTDFUphiKUyxFKbCeqyN6d/gMtXH9EeZaIzpXfzNx/R+0ghhwNKZYulMsXSmWDpTLJ2pUHpxjT7AdbFG38JVsUYf4ppYo+/gTm21vpO/5mp9L3/NMf1K/ppj+j4u3ah+FRduVJ/kso3q13DZRvVrWe4q/U6p41X6V6SOV+l5qeNV+leZ6IzoX2Miv1LPsPCVeo4G6HXcXFayJ6cBeprmfJzADdCreWmwhwboLvo1xf6brhX/JdeKidS14r/EBJcboDfSr4KtA0dYz9A86DboN9CvgG6Bfj29E3RT0bTImhZZ0yJrOpT1S/Ran+O+DNCz9Bqfw8EM0JvppM9RYgboTfQqX0KKiZxrRM41IueaUM4FRff5HERlgJ5T9Eqfg6sM0HsV3etz0JUB+mVFd/oSjEVkbRVZW0XW1lDWfrrD55gkA7RL1lUgP6roFp9DmAzQbyheZDWSdJVIukokXSWSrjKSeBog86n1mFIgJTOG7O00gS6ywGHzXJDzTG4CmWfyapAdjutH3J0yeR2NhoqZYzQczjgQyNx9hVmx89zdTAkjbev1XdWG9V3VhvVd1Yb1XdWG9UbDkinWsGSKNSyZYg1LpljDkinWsGSKNSyZYg1LpljDkinWsGSKNSyZYg1LpoyGJdNGw5Jpo2HJtNGwZFo0LHl2+M8cWmQKk3nHG4FGJBZF1Vlr6wJ+qmTDIr6fz5qhgqrZQ65/ObYntsSeO4Ft+PBku3jCg54lyOdOePH9g7AW5vwHcA6dNqtUCXfJF5LLuFyyckmTw+qJwu6w+mJI1y26ZtFVi65YdNuiOxYNdcWQnrfogkUXLbpk0WWLrlh01aJrFl23n/U3VhksumPxtC26ZdFN+1lW3opFly26ZNG+RRctmjX5ZrrOyAJ3lmYDd9boieCmoVkV0tCsojkTnYD0ZGJdUkOXQxobfWlpDDRLM9ntGdOcKHIInrYWcqbZ7F9Hkwixmd0BAaktsdX2anAGO6nQA/D+3ByHjJnjkHTXW5McoOLHyxT/eJniHy9T/ONlin+8TPGPlyn+8TLFP16m+MfLFP94meIfL1P842WKf7xM8Y9XdNPw403LHhz/eNOy3cc/3rTs9fGPNy0bffzjTcsun1GPTputBuwfu6lwb2o40nWCA4Z0zh3N0TCN2mA2B/4UDYeg2T026tFDFFZgSrYjWVFazP8doyidshSlU8soSqeWUZROLaMonVpGUTq1jKJ0ahlF6dQyitKpZRSlU8soSqeWUZROLaMonVpGUTq1jKJ0ahlF6dQyitKpZRSlU8soSqeWUZROLaMonVpGUTq1jKJ0ahlF6dQyitKpZRSlU8soSqeWUZROLaMonVpGUTq1jKJ0ahlF6dQyitKpZRSlU8soSqeWUZROLaMonVpGUTq1jKJ0ahlF6dQyitKpZRSlU8soSqe423NTMkh2jwdlUM1uh7d5ik7awu4PpyFQY2WNueaGHFwa8ih8txfTw15Mb8KJ58Rpt28T222uwr5eQdx39EWbdHdbHf1u2h245y66u+firdXUR7vn4mVz7YwulwkdPWfKK85VHRXueXOtr3L2iKHopUqbzmXJTWyJ1Z1og679H5r78T6vMZTTONn2ndNu/yYoDmatArMLUd/BM2KWJ2PaDTwdLOBSctwHA/chdOyLObLCsYceEqLsBO7Dc5arcmEbDxb0Dk/xTu4OSnvTZ1gBdZz6uxvH4Ag3VKWH7KcdyFtxAve2OcvDOft1pt3Li6SXEJmwRVadwL1/znKMzh6fX0rk5EuITNoia07gHp5j3gfn4rPRwLnDrjOuqgfDqnJvDtwn5uJ7lqsYPJD6c1AkCh+p0+HZl7O4fo7OxQ+icVqPXa5qfq7Q+OIaOjYXP/wLhU7+fKGJxXXkYejup5vnrLPnJXX0DN0sdVRx3IOBe89c/Bn+6Tk/55WO/6J6wisdxyxg8Ts5P+edjv+iisI7HeH5RD8dhDnuS79VWdFBea2q4+4N3FsRDJDfK/5zSlBQL/liCWhg6X2UlIK4t9PhKIKu7z7AK98kPTDH2zq3k7fobgd3j9DhgI7T/QHdQ7cFdDM9bHEhZtCNmGIlaQfdHrg7wHwrmA/SbT187gmeSCXpxjneJjoxx/tGR8iD9GOQfhTSn1gq/RRL9yD4GAQfXSK4aATvEcEHKUkeSnIMJTmKYj9BDwf0ID3UK53FT0te7FjdHn2PfbQ3WAjcfRCzl+638yFT1TyR+FEeHnUMjzqKRz2BRz246FGYuiZpH3j30rEeeR7H302Shwlskg7jmfej6Leh6A+j6A/RQwGhw+8VypuiqJ0jqJ3jqJ17emtnN8eZREUfQUUfR0Xfg4q+uVcU5sTcFI5REgPIM1zYIyjs8Z7C7uYAwcyTV9xsjtjNZjfH/eXb84qLtgNFuxVFO9jzSLZNx0N24CG3Ln5IwzykLA/ZYT9kBwcUTtIODmgMGfsgY68tg7dvkHPfopwFh+Hbg54TbiOupajf8x0svPuwLd0Ywt869F5BItFkqAGoaaAWQ01ALYagj7TNqaaYbgwhZo8T0f+2munKitw2pyN0NZXb5vxPoWtObpvTXi2i2yy6BdFt87QOQ21AHQPlh/kGIJBIzDOUH4VGroEKDM0DKhioyFABUNFAPkNFQCC99upc9pD0INp0lPp+6Xz1cRmo9F6ZBugbTZ9zs/Rn+glc80rfzs4J9SM8NOt9uBzWx1iI0ge5S9cPgmdcP8DzAX0Cl4P6IVzmlb4VN7Pak+ANt/FAqY8CnNSP8uisH8PlmD7Frs70YZ6f6Mdl+qKPsCcAvVuqXbuEQJVKJ2ADg3PncZ77wNEB3NbApp/DOMjT/exetIokbFjSwpG9UQxmRqFqMAHPDUO5HM41Wn1ifNEZytEoFoL9U/EmY6OYPbpXW7xtg2PFOGXhHYM3FVxSRjhsYYAXHXinjPB5xvlRMIupO0LDLGY+LjTMYqqGhllMx9BsFpMQGmYxLUPDLMZPCg2zmIahYRZT6BMaZjE1QzfFTIfplpjXMG3MYobZYKVfTGOgr9WUZD4ttQX/v6Nc7d70GQxglWxkx4KbE9BuqC4CrwZYWwROAawvAglgYxGoATYtEO6OR7lcEmXZzONSRisj4UALIeGloJchXzgR6mU8rO+hBI/SD9M9gb7H6GUI17CXgl5GCmbTkRqCkWCUCFjbQCBbLyNksvQy7vF9fU+vXoY02rSXwuyAD77vkTdq2ZoZ94j2YPhW2EY0x96pA4NxxCWZircz/AUR56yVFqjDUKkfHXa/QPkVzAWoZaB5hkoD4BoQqCBcgFoGKgpXBlwZgXzhAtTKmJ+Z/MT2uaNbYtX4oCLXw/IE65EViUxYS6FCyT1QpmBh+KpeHZGt3GEcnUP3JnsTuSQp/ps9AAGFce7h4bFcOmWIx04z94CVFdwDouDFAYGqDPmAfAPVGArfuNuhm06/OBB1+kybTt9P/ic6/TqLLkN02TytwVAFUMVATYaqgKoGajFUA1QzUJuhOqC6gToMNQA1DJQfZImAmgO0m45gefk43Ug30mF6HCufwD1MRzHIkke3AaCjdBiwRw9iYkEP0AmGHwJMD5KHmw/QE5jK0CO0j28e45uYai7QE/QAWB6hmzFLoEfpMWY5xSy3MstBsNDN9MglxsCVUjDM5P0sSrgZOM6Pv7/7nFMCPxEs0G2Emyf45j6+yU/Tt5sR7o74HtrkTZ9x0/LBYJzLwzilcy60tvb96k++4P8/3yzvCjiohi+Wt2mo4vbckRCBfCfbe0fiBfKd8d47EjOQ71DvHYkbyHcme+9w7EDahB/wJq+PuwFuUVL8l17wy0B+jxnIHzYD+buVGck/osxQ7iszli8oM5gHyozmFyV0kv6EkoH8k8qM5J9SMpT/ppJBvKRkFP8tZYbx31YygP8XJSN4RWIp6T9QMnj/oZJh+0vKjNtfVtygs/rPmChm9XZu58N6J/8ehvUNMk3Te2TSo2/i5p7VHE7Az+q38I9gWN/FP5Zh/WqZw+mnZUakX8f5s/r1/GvO6jfwL2RYP8MPHtZvlAmefpNMl/SbOX9WP8s/0az+Jf75ZHF6jAcP4/SY5204PebpFE6PISOLs1sUOouzW5Q2q3fx04f1fpnY6QNcimF9C8vI6kNc6qy+g0ub1Xfy04f1vTLr06/kUgzr+8wGTpq7tfbqHAfeTtudmzucvdOeppUdmaZVHJmJVR19q2kdt5naP8pf54J+kL/KBZmbZS/I5Gz8gszO6II+y1/vgszv9lzQT/JnvyAzs8MXZGo2ry7oU9w+Lsi0LK8u6PPSci7o09LILugz0uwu6LcqYyzfT0meFSRgmZxmFUq6LcBUPibGxWl6q8IqgpUr6VbeRIiJMXKaTuPOGSy7+LZPxwJ3n9zP4v4p3D+P+49jFSFMPt0cuAeFC79/egRcj4HrUXA9SQe7rD7dGLh7pTt4EGxnwfYQ2E6A7QHaa7oMZj4aiHk+K6HJ73Y4XHGwvli/fEDeSUzKB0QAs6L5XAXzuebN58qbz9VR8rnaSj5XS8nnyiv5XM/I1zorH+uUfKvj8qmOmS8lH+qgfKY98pVm5RtNyxdqKvlADaXfyr/RutLvYaKm9FPcjJR+X9gfFMKuoyi9itJvkx+20m9noqj0O5goKP2usJN43nQK7zfdzAdMb/LrpvP4oOkkPsTXmP6w6jYSN41+O03D0me7O+j9ij9U2vXoUcQkhtHePnpeCT3uHqSCocndSw8IOeneSDcH3MEmaAd9QAXk0WOBT/voRODTQSoiz146E/h046WFv+mkd9CvM+cp5nyIOd8mnG9VzHprYHr6HfRBZn2cWc8y69uF9T3Celtghosd9CFmPc+sjzDrO4T1KeY8GpghZwd9mDlPM+eTzPku4XyfCH0w8Je0Pmud6yeXrHNLySXr3HIyWufydMZe28K37KJ1bjqa8fAsx8x45tWSZW4luWSZW00uWebWkkuWufXkkmVuI7lkmdtMLlnmtpK9y9yeRT+mTKt6F/2YMq1asqrn1b55c6b/D9483DvAzGtV75ofU+JVvWt+qHas6l3zQ5llVe+aH0qNo71rft+cDVhrfiipjPau+THjHQ1nRFJqeaVfNJ/4I2WGkK8oM6Z8NZxRVMMZxdfkJ+/IKr6pZDehpGT34KyMSrPSy8Vkk6Cl9NfDPuQb4fTjj02/8Cdm+vHNsLv5lpl+1EyH8W0z/fhO2LN81/Qg3zPTj++bnuYFM/34gelZ6uH0408Vf8UobBBXDWW8+VX427osx/ezh82HW827XlKlY7w5JfP5Md5Zks+2hneb5Kuu5k1RpktjvKsoDXCMt2blm66ZQzgRyTvGe51Ml8d411Ba5xhv1soHXzPHjpc57xjv/smiZow37qTNjfEunbSGNXOISiJ5x3hTTlY8Y7wHJ+81xhtu8l5r5hC6RPKO8f6cLIfGeMdN3muMt9nkvdbMIb7JjbTv0pgaZJ9X+lXk0V7aIYmTlFe4vobO4fJaWBZdlpMGkIF3e5DHYODWukwflL2dopLdnPcp2RU6a8LDvZX9AcxiQBrD9Xm+kn4QF2wpjWEcKzCa1h4uWf2QGCSdF2NoKKjB9hr6aRKDbl7cDUA9TYLR/Zp4HdCzyDipnzTD9Zj8sHlLSZlhO8XNnbepCo5+ANd5R5/DNe/oR3DtKP0orm2lH8O1pWQHK6/047g+o0/jclafweWUzvM7H9dP4XIM42kKxX07Xw9iNE2hcO/i6yzG0BRe+gN8bSoMoikevj/IRF1hGE3x8P1hJqpKf4yJitIfZ6Ks9O8wUVL6d5nwlf40E0WlP8NEQenfY2Je6bKSfbnfV7Lr91klO3ufM5/r80o+4xfMZ/wixu8xhCY742bY9wxlcm5Gxu/fVwE+ftrdK0NpBgP4jVQ29Lh7M33c0OTeykNvBgP4bTIsTlKKdtBnFbaH3y5jIIbcm+l3kLgVA7ZPt2HcxxAO3s8x7zuE9zTz/q7wflB4z8kYDt7PM++7hPcM835aeD8kvI/IIA7eLzDv+4U3r5j5M8L8YWF+VMZxMH+RmT8gzE8x7+8J78eE9zEZyBUGcmVO0dATcTNEc0QzzJhQQFzbR6WyHzCf9pz5so+YD/uo+a6Pmc96ynzVx81HPW0a5RlplNIMz0ozPGWa4XHTDI+ZZnjYNMODphnuMc1w1rTCadMIJ00bJNMEx00LzOqPS9PIsH2nIsz8KMOLgRQ3j4BEUtrdG5AIz7o3wopXnjju3hyQFILcWwOSck26t4U+FRQ9gCn7UczRP66Is35MXZr80YcVDi0+pOi20HODorfzMuNtCtxPCXOemc+A93TICsckj4PzFBgfE8ZHwfcI+M6FfOOhGRR/P2tcxZES+s60i+lrH0p8Kz1EXnDpNX2kD7q30Qmkb5T0KfdtirdcLr2v754OeJemD5XxAW5JfXDNclR4D7tcIg7x474dxffdR7mhcZZx99flmbMuig+8D8GGH5csz7jvkCzncIjEOcj9oOTY4z5ApoDH3Uf4ITfzsKVcNHj30i8kilLsu0/1mjG9X1khW9+l6FZ6j7q0sPPdtyo6i9XU+3A+SkWFCbfPx0ly6obTH9+/6Lv76G7aR3c/sg6U5Z+G0ZPr3Lvp7uB59yA9Gbh341dkPe93lE9vswvwPuVbqbN0N33Avv0eRUcJQh6zwN9VPr3d5nrSd7k/+HUb/JCiU5z1cQv8jPLpHTbXh5Xv/p4NlNH8rfTH0HQh5hEL/H2FFmkBH1e++1kb+Jyyv0GkWPLU8+7n1UW3qOi0xX2a7uZl0zkL+4KiM1byKd8PXHyHBfeLqveL4iNGnD4+6m3ECy730hejnirGxz5qM79H0WP4sPSkb8NP0j78KE/ZWEHx2t0nVBoWS6gbm+HDChuQgU+ojo9Z1WHXBVrWaXrUznea9l3q7olf8VF6NFiI6uuL6nn34+ripXZCZ+nTtkj3LO1Db02oanoUNRO45+hcsLC4xfMDv6DoINaj7kGMIH7gnrngnr5EovakVV5q6IsqShpaL+5TQZE0o0UZDqIvk5aBOz0vja9AZwmqBxglfZ/OSIHP0Bn7dZ963n1eXXSfQg1h++NDqucBH2NHL3QGb8k/jveoYMF916L2cERUBB6mh+kwfULRDvqyCtyzwQJ9UtET9CVFoH0VuE8GC3RR0XH6L4JVFAH6iApc6DtQoOjdiu6nktz+Lbn9mwptayFwj+DPDlpQOOym3fQHwvaHwvbbwkafUnQkWADXDt5exl/3dtoeQPYRPON24eIbR2hnQDfQR5AZTzoiRbxdBDLLPQHdRL6iJ1Hee6RcR+TtbpfHM9vDAe2hL6Pav6To4WABLwnuknB/Qrj/wHC/W4m7wR30ZyrwF9yPyNahgqLB7fSWgI7QXTjUf3VAr4OmwNMU5cghwxM8s1c4/b+d3gD+Z8D/xoDeDP43WfyvB/9xntlzW7ifjtAvK3C/VwWwUng4gH2CZKDb6ZcC5HoWue7ntYEK6DAdoV3Isj+gW5DhQMT/UcUZfoNf5DCvDhTUGo7A5cY9dG9A9yHHK6Mcd3CGQ+DfzasevuHegx0/jI2zMPpwd2BjhX5VwZzDvR3DK/2Kgg2He4Rnje7DvvtuZKDzUEY4Tw8F7kM8jzpPJwIXezpvU3SeHgzcBwPffZtacH2701xQJNVe4WrvE0dIXFE1U1F97AqJ+KUa/FJ97AgJpQ0wjvEu0g7MSul23ks6whNS96Ly3U/gLsp2lHeNHuNdprcrbNe4jy24PZ3o28OytMKytMOydKKy5B1TFjhV4rIU2BeS+0kuy69zWU5xWR7nsmDC635K+e5v4i7KcorL8jiX5R1SllMLrj1oPm5KUnRMSeCeiUtScrolKYclqYQlqUpJ3sEl+SCX5AEuySNcEp4qlJTv/hZP+M5jBxUleYRLkpeSPLDgHkVn5rsHo07qXep595GLbl6B6z3qgvvbis5dcM/RsQvuMfLQs7CmiWyv0VHMY3z3ZuzmuV6AjuBWGZjtkci92/fdW9FPYvZFj15wj2J/9+0Yy/YFhLv7fJ+ewlyMzlxwb8Oc7yCdvsR06S0DTDVoHz2FTuLugG70Zc52K/rd24CcuzRPor3o+PdiRsVjwt0o3I2Y3uwNyGMx3U67uTtAvT2MaruouN4+pfCrLimL6avY077U9OkhbmsnLn1rehDVbHO8m2v3E4qr9zfVpfpFj/Ug//TwCwvQB+4IfOnA0AiOBL6/4Pv0eYVVF4at7PPRD8WnR7LPK3+BXhs9xL2RDxFfYyE3Q/uIdtMfKfzfTS9wi/5ThapaoB9gKKijshboa4p7ZfouhoLvCfZ97hepyp9jgb6l6KsYCb4td78jd2tK1LfQkX5d0VcUHaY/EY5vCscfMwd9gztbzEcwAnhoql9RtA+Z+Pxyd4Bm/FVFt4N1tzzQk3NIn45TVdFePO2wiNwthfXkdJKeoK9hlPu+4mPH7wjbN4XtB4YN9cuvT3fjtVG27wn/t4X/T4T/BeHvbQiWTw46iS+Dfwt6B1Z+9QmcKeyArxIYEPgn3NQ256MnCEFesQHpn4C9B5ts1MVkQ+wNaDK7k+9MZm9YG/pCcVNe7DY2IVLnNIxH1P7EeS+G0KVvOadHvZhOGVc6oe+FlKeeFA+8w1CkGWZFGjZOgWq3OmPW+LNYrnfviM+JlOfAj9QIVBxGaJQXtylv9ZmMTlGajaQoxR4BeEuDF7JOV4CegUdZdtzrhJJZPdvdb7zG/OtXA59m9o3885a3PveRczd88vl9399x/tGP+z+DN5mL2aKyKniW9u9743+74tr07z7LuXpvL7gz+/yv//d/v/Xg5+GUJiRPrss+r9yZuXj5BPzS0C7fX6EyYprF5llsyDWUVHEnHoPjsy2xpkrs6bGeGTXGH5mu9Uymaz2T6VrPZLrWM5mu9Uymaz2T6VrPZLrWM5mu9Uymaz2T6VrPZLrWM5mu9Uymaz2T6VrPZLrWMxnLeiZjWc9kLOuZjGU9k4msZ7CNqrBjkfFmc3rCuCPOcPtJiXqVCg1qRkh1lfY5krs7DIOaERvM5sCvIjANg5p0ZFAT1qmyDGpUj0ENu2WFj2zKvOQPI4Mfhp6DlR3/MhwvdpttCTWLXXEHv5Nh5zyI/T13vZjcf8s5PeLFtGPdiorIjh1U10Gz/JJItnJmZUdG3GNx9Sx/Z9b39Sxcw+Y0fI84OMYcMSaW+C05NIzfUveZ4pwUPnabCh8JvykjSM9maI5Df4q3G3fG/KR22T+p2eV/UrOLflIztMv+Sc0u/knNRj+p2d6flL8imaFVrMvjSHAel6NRSBsJjUV7vi58ICE2TwdfGtGJHCs4j+LgQ44VnEfB5QGM7SykyEjRQtivlR2cR3FQJMeOzaMQlAf2hpujfDVGahZSZaRqIRVGKhZSZqRsIQ1GrKg8CuF4UKSrrefPb+V32xrlyzOSt5DOFm77WyKkzUjbQlqMtCykwHKscDwKcXhQpOus51e38btts96NkYqFlBkpW0iJkZKF+Iz4FlJjxIrDoxCAB0W6wXp+Zxe/2y7r3RhpW0iLkZaFNBlpWkiDkYaF5HdzPe62no/IOyiTFYBHceQdvF4UMEdx5B28oI35gvk2VhSsaGMFwQo2VhHMDsCjOPIOSviCXRpE3sHL/sDK3RSsaWMNwRo2VhesbmM1wWo21hbMDsCjOPIOimgF4BF7qVlaJebHq8T8eJWYH68S8+NVYn68SmKbrvL2nBY7WQYOyuWwXI7J5bhczsrlGbnklVznzbVgrkVzNQLrJlkz16q5Vsy1bK6lUJxjxJtrx+Btc22ZazOUZ/gq5lo215K5+uZadGgVzVqmYeLfbi5ew40ZPlfja0NZjLbdr883MF7zZZpWwcHpEis2aFKqSeejJ+D8G6EM+PzL13N83CWHX77exWddcvLl6/18vianbb4+EI5PiK6UPpNjN0JsMscDCbvrdWfxOxhkXda5AL/KFUzvAl0Vej/oeaEP9FolPGft4sLH3+zJdWYKGbmxjHR0M+Rkd5HD1XviUvuP8XzXTGVXxDOR+z9Ywzt4edtjlb4TmuArTrupTTEZUnSGYq5CjGl3CMcRr6QhHKXch0tMv8qL6aH4Hrbvhb/xrqDsXiS5EtLm5dk3p7w7e3yUV9e74A5yhXFo6tBQ6Ae0tNl4Nk17nU3Gsyk77BSniewoFOQd4vET5L2wcEzCXRY7XszeDOvGRM6g/Dd7C6w+VY6G4JvWTdMMvRKuSO+Dv9NXBbS/1/Rm7gId4BPBpC9nhu4MHHTOYF8Hh0MC1xneD/gQnzEmfDlPBHwA8L08Qxe4yvAtgO/gEyWBKwwfoplF9i1yaOm7d1x0Z2hXIMbhM7Q/EIPxGToQiBH5DN0SiGE5hKBh3CneW++46Os7aQitZMh4mEixAv1Q19Kd7uxqVn7yeTxoqBt7HIpZ7hD1QKUlEM3IyW3Ap/wm2Uay3U12kOx0k3kn4CN4k5xHcr6bLCBZwCqn/BIPq4CjAo7q0hLWlkL1pVDjJUQ3IboJ0a2lmdpLoc5SKB9fXvR8PGCThBS7p12UqbgU8pdCpZcQXYboMkRXlmaqLoVqS6H6S4huQHQDoptLM7WWQu2lUGcx5HjVTOS2IRY6h3W8Ssa4bXUQITgkSxHpR2QxIguQRq80suc5dZ9J5Tn1KpPqDIiPRqgpcOetpNMZ8hrrc6Z/UNI/oEOeYVeCQ17+8hzr0XWBEjGQ7QJ1zcB4F+i4DJABzFl16OVlxPgzKKxAJL3Ijwk8mVw4wbGrHA5aFXrHWM0ZHA5a1fXIYdFt24PH38agtOMnWWknXDLUYQDuiNE2zWR3gxEQ3/fyMjXhYYH3GGTTRJlNE2U2TbpFNRq3ahNPCVX4ALhrsB6R4uNpmr3QHdKjficFx9TwduvOcOeVEo3UGdYsNS1nfAlCixAlLjcVb6vk3PQ2p4jQGultzgdxVXAauM0pML3Nea9gRWBRh1NC71SCiLJa0ngrS6HqUqi2FKovhRpLoeZSqLUUai+GlDcPx4+TTgzbJUnKTDoJ6MnGKInYCWJKGaaPBWLYGKaPB2K0GqZPBWJmGqbPBmIPGaafCcQiMkznUV9s/hgi80DmbaQApGAjRSBFG/GB+DYSfokIKQMp20gFSMVGqkCqNlIDUrOROpC6jTSANGykCaRpI+GoFiHhwBYh4dhm1Y8Z3qz6MSPcS3ywcMSzKgtI0UZ8IL6NlICUbKQMpGwj4UhpVRaQqo3UgNRspA6kbiMNIA0bCQdKq7KAtGykDaRtIx0gHRvJY3zJx+3KMuOk1ZiAFGykCKRoIz4Q30ZKQEo2Eg6TVv0AqdhIFUjVRmpAavHFHy8TVhZu15EhRMIhM0KaQJo20gLSspE2kLaNdIB0bCSfQGUlLGQeyLyNFIAUbKQIpGgjPhDfRkpASjZSBlK2kQqQio1UgVRtpAakZiN1IHUbaQBp2EgTSNNGWkBaNtIG0raRDpCOjeSTqJ+kXT9A5m2kAKRgI0UgRezmw1U1r27eidEAXq4zslBJsX/sEVmqpFivbFjWKCmMfu6orFJSXidmAiIcQrcdy7kTslJJea2YiY5wJ7r9mAQo4IULvLBcjcQrMWzEcu4UEvdhWInlXOLV1qVhZ89pV4M+eWlUms25SdCvYQcn3JHo11IqOg2UhfOCOychcdxfUYEMdpOhZv+crGTdeb7zWqMbL3BBua8F+hpBtaBF5b4G6ElBSVBfuScDnmIxOiVoSbmvCngaxujVgpaVe1/AUzVGNwlaUe4rgd4rqCtoVbn3Ar1T0AlBa8q9E+gdgo4JWlfuHUAPCToqaEO5hwJeHPliIjwn8XncWwJePIkrckFbyj0Q8OJKgqIL2lbuft6zFXRI0I5ydwF9pzJ6iLSLZu21Oo+XyizVzjJ1gMdYZZZqx5k6xOOy4reZ48BqeFuJrYbawDmFMhPbWaYwqZ1mChPaSaZO8sJQ8deSOGH4mqKHN0M8MqeZ/BVlZhPpnN54ab40CW/LYgUOA99prP9/FjvtxtkUnD2wX0VO6H29pNydejssx+N7aCdtD/R2T3HQSTmjGKRx+BtfC3/jGyKzXhqkDG2I7HcHKUlre26ujW5u9329ncaxWz9ujHvj4rgoabld3y5BIQWnqyyw69yaPY53HaXr7Uu8riNqnUiIYyszeysOA+JecYMBKJ29C+n1OVoRzo3jCFOm1wqb3uDF9GB8Dw16ztMazm4H5byP5zV6u8x49E6ZC+kbZJak98j8Sd/E8yqd4+mWfgvPwuDNHWqkr+Y5m36ap3L6dbgc1K/HZY9+Ay6z+hlcpvUbcZnUb8KF9JtxGdfP4gLLvCR2a35ZEXcU71XGs/5aytC41FlaQgdIV8JKLsgCnRefZdAvMTJOz/KV6M18OI5n0psYmqY3Cu8s1GpQQujYoMDQpjHMh+l1jB2jp4X5ONR18MbQ3UEF0FtCwc9QLpAqopsCqTPi4GBcjXRDIPUKbSSuaNoexQm11UlpEIlBk0DEzA16J0fC3KRv4GiaG/QejpK5Sd/EkTY36BxH0Nyk38JRLNfruzi65ib9ao5wuV4/zXI26ddx9Mv1+vUsZ5N+A0fGXK+fYTmb9Bs5auZ6/SaWs1G/mSNqrtfPspyN+pc42uZ6fBoI2gibScTiXA+bSYjaCJtJROpcD5tJCNsIm0mUfr3exdI26v1c+vX6AEvbqG/h0q/Xh1jWRn0HxWUGwzuj2/ld1rPUjQvotpBgew/aTofoDsZ8g2VpOx34/7h79xjJrvNO7D7q1qOrq7v63TM9j3PuDMkeDods6jHd1ZqZ7ktxyBFtSSMnXlH6Qxia48VskZCGMiXT9kjsbCy7FrCVCtaBi1xhdfu2A5QRI+hknUVtsAsVgsQoe73rgtdAysEGKdOO0pGzSW3+CAqJtZv5fd937z23pntEZ3eTYIdg33N+59xT5573+c75fp96hbC2YKtqG2ZICDsUTKlt8Kl+xya0I+i62sY9qfcZ7Qq6obbB4vorjPYE3VLb6oH6BmF9wXbVtvp59QuEDQS7pbbVO+rnCBsKdlttq6+rnyXsSLBX1bZ6W32NsJFgd9Q2qPAJGwt2T22ruvomYXvnGLuvttWuuklYQ7B31La6pq4T1jyn3GC8QrZdPB4R1JaappELNX8KaZ2KwSKBDYCNBKwS2ATYTMBVAlsAWwmoCGyfRg0kP7RO4CHAwwTcILADsJOAWwR2AXYTcJfA/hrKei0GbxE4ADhIwNsEDgEOE/BVAo8AHiXgHQLHZ1C2Z2LwHhfIWRTI2Ri8zwUCsJGA73CBAGyeDdiI8SrOvisyPtf900F7GdwR4L6s8DzhxfJvGcNXZRijdVlZbUk9SexyHPt00F/h8CKN1nX/3EQMj5Z5aQrnHklhvJqmALHioym0fkQK4em6f1pSgGRMcnk6TQGr0NOTX5GEr2JkS6ZH7uOogrdQBW/FHRODwc+gS/9M3KkwTLyNrvd23C0wHH0NHeVr8VCAWvsqau2rcVdGI0Q67Z+JOyKaENLpvx13Jfw60hl/LR4+UNFIp/HVuPOj3SKdw5+JOy9aHdIZvB13P/z61/HrX4+HHLQNpNP8ajxcoKkjnc7PxB0eDRXpDN+Ouyx+Hek0vp5O8p0LPMmjjSk3GMxDQrbHEjKXB0dSQXR54K25jSV2D87W3MNldo/P1tzBCrvDs6Sf6PLQXXObEn94tuZ2JP7euZo7lPjts6S86PLgX3NbEv/obM3tSvzGuZp7JPEPz5Jmo8uTR80NJf7obM3tSfzmuZo7WsHXVeQb+dNo7dKZrvMKJl2/9MoiI3SDfuocpM5R6hynzr3pxNlKnWHqbCdOOuwrP3ya9vbKjB9N4EPBm9NZvDHhP5xOtjWa5rHRLM/ZR7M8Zw9meM7uz/Cc3ZvhObs7w3N2f57n7N48z9ndeZ6zO/M8Z7fneM4O53jObs3xnN2c4zl7r8pz9nhWf8s2B6hOuV5XW6rCS8K6f5qvJm9TP61AVulJLBoRTvN90GQsqGBLV45jnOMYAzdS59LxDbVYQeC5y1wBZ2VE8LfV29G+IB4h19RPJwhb+ruufiLaVxXablY4hPBd9c1oP/0BDxmlReC2qkf76pq6Ge2r61gJ7qtd9Q0zbtmI+4Di/gLF/XmK+nNm1IoR9R2K+rMU9esU9WtJ1DJFrfD373mRqkyMdTks6Dniakx8w2t6N+hMQemdAn1MfDSn+ddoxvFvRjSb+ds0K/nXo30CsELB5OPvkvdVfxsfTG4sU65H6prafQiEwnOCOJwCpVuVdO9zusUk3Vuc7qqk+46R7u1suu+zzjoicRKU8IYkXOWE15OE73HCW5LwqpHw/ckMVzndVU7hGhcAp7vB6d5K0i1yuq9KultGutVHMrzKCa/zG5TwHUl415cCjRPeUlLknPAtI2E1meFdTvcWp0DpWpLuHV8KNE73VSVFzuneM9LdfSTDtzjhe5wEJawkYcuXAo0TfkdJkXPCRSPhO5MZvs3pFjmFa1wAnK7ypUDjdFeVFDmnu26kaz2S4Vc5YcV1do0L5GbSRqnJXTcaKpXQblIDN43CzyasOOFdTuIaF8jNpJFSk7tutFQqod2kCm4apZ8piXVO9w6ncI0L5GbSRqnJXTcaKpXQblIDN43Cz2Z4gxO2OIlrXAI3k0ZK5XPdaKlUArtJFdw0Sj+T4S1Od4NfuMZt6GbSRul7rxsNlcprNxlFbhoDiJGuf+19yHRyXHzcL6QVSTO9Hhdp3Favc5HVZSC5rraTMeT6wx2vuomBmLJ8j9O9L/1CWpG00utxkcZN9TqXWF3GkTTde9l03/dvQjSV4wJMWy7GBukIXEb1pLXucil8U4aSXZWOIrvYtm9jUkFpbEP8laOVqX+dc2RJRKxNH/5CyD+bk1rjBhnth/41tt3Gq1F4iuypkgdD23VyKYZXybPKnnXyrLNngzxoRrvk2mV4izxb7LlFnlvsuU2e2+x5lTyvsucOee4wccx1lcOW8IA/8Sa57ifZuqfcoFlKLmjyzutCvEOMOdUE5B1izKomIO8QY141AXmHGDOibb2vv0T+iogQ2hURIYQVESG0KiJCaFZEhNCoiAhhr8IihPE0ixBG0yxCOJpmEcJwmkUIg2mIEMDGpu/S4mlaf5kWT9P6K7R4mta/xEfoG3yE7pEZLZKX/7KtPDKUdY7l3R7Zw3qa5d0eGcsiifU2Nlxnad62IJ6h66weGWi7QBazXFLNb7A0xNZfoK+19Rfp821N24EupGuu8oL2ubr/LF1+HhUI6J+v+88R0CwSMFZ1/3kCDhkI/br/MQL6DPQu1P2PchoMHJ6r+x8nYMyJDs7X/asEtDjGnq77eQI6DLT9ul8iYMBA/wKfFtTcMQOdc3xiUIMNNADD83xqUIMhMwANzScHNbcr+fD59KDmDhkYXOAThJq7VyKge45PEWqwogbg6DyfJNRgCg1AU/NpQs3tST78Oh0pEN0h5eMC65bX3EYJco8QxA/buAP9bZY/lUVqVuYVeFjmFXirzCvwZplX4I0yr8D3yrwCH0/xCnw0xSvwoymRmk3xCnwwxSvw/hSvwHtTvALvTvEKvDOlvxFYGtZOTwfe2/4qtxUsGn8e25ZCXa3W/VWaVSL1dbVKS6ooVD8BZ9XfikK1CydWEqR7XlG/AF3Hn1WI9dMKEW6q60xYUFEPEPYOhb1NYXUOK6qK+gbCfo7CvkZh3+Qw7O2xcRfmc84VZTMI4w0Y2ncsZR4V6tV/R11QX2K8+u8qVxnN12i4RpM1GqvRTI0GajRNo1EazdFoiEYTNBqf0eyMBmc0NaORGc3LaFhGk0oaU/ztvFOVb4/3dd9LiuDz6ouh3lWfU18I9c3JGi9Shd99tMJfTiv8b9lpjX/LnqjyL6PqXqGq+45NdfcrdlrpX0HoZyj0BgW+Z6e1/ksQNavPUuhLFPq+fUK94+rks5Rd/ZyIG0aFul+hA4E6NjdNW38Tz4atfwLPPVv/NJ7v6LfxuK+/hsc9/XU87uifxeNV/Q4et/XP4XFL/zweu/oX8NjSD/DY0N/AY11/Dg+lP4/Hqv4CHlX9RTyKepN2Vxoz4rNqla46VdRPq+fUKtFMQMz0sPDUT2AvhvUL2vdpWt1Fqg4XlScRhlTUz+I26tchhFdfg0z+bcVh3L+2oF+LMPQW9Y6Eoag/j7DPUdg3EPZAwlDSNdJkorAvIuwLEpbsBrmcPbpwW+EZId0xerA3zvBhBh7HcCcD710UuJuBGzHcy8DNGO5n4FYMDzJwGMPDDNyO4aMMfBjDowzcieFxBu7G8J5jwr0YbmTgfgw3M/AghlsZeBjDYQY+iuF2Bh7F8GEGHsdwJwPvPRGXdwZuxHAvAzdjuJ+BWzE8yMBhDA8zcDuGjwz4abXLK81v23ieUzdrZILxV20+/v1lm63jWTJyXeCVXfUZ9bR6WkSubXs/Wa1a3OL2ObFzAnQYmOYFNLWyfU6/LECPgQ007Y2METiS56U24FB5JTYChworsRU4VFKJzcAhQyW2A4eslNgQHDJRYktw+PkSm4LDD5fYFhwKt8TG4FCgJbYGh0IssTk4FFyJ7cGhcZbYIBwaZIktwqERTrFJODS8KbYJh/xOiU04WvuKTTha8opNOFrpik04WuDSdbAiC77lkAUjavP/IBNxNjNFigGuBRzZFq5Yi7ldUUZwRRlBlAlG8jyS51CeAzxFvni0s4m2RXcg6RTchvWaNaISxek7DsGX6f5jfAi+pTeVrQvuLqyHsQ3yVPETRthjK+SnVCE5555VtvBQ015gVhUMlmsEPmJ5nNU/RcpfxB176IAqO2NmHKhYNmcIuq1+IVgCu7XcOF16ueLgpFfsrzNBL/mJTLSDRt6xGakCOXJCusZFyCqQVi6k+0OEKCA9DwcJHiPrQMawSDvOM7IBpI2fahdBHY6j59i+OYzsUM5LYt88x7ziS2/qWeXEnOJU0DWVo9sGW6oW6Vpg68WkoG21iIJe5oJObxuAIskoaNzKW84EGnbgayH0PRZR0IsJlThsRdNlA6ESrzGVOMFq1sBOumtQI7lkxqJ2adK6uSbr5mWxbm5LUbCJ+yxpCL2qbMO6ee2Az7rJujld0jhFJ9+6IJHLbN3ch+0UpXVOlemqM/8GtwovsW6+dbx1c9LvVOVP4Se0DbsqWevmkpiXljWtFaN9XVMFbZdJudLdVbX0ZxOD8bTziT9MEqDNT7SPFWmbCeooKRt1Y6scq7fwK/FvYp3A1s1h9UXPKk/bmWIvK81G3817H6pE1s0vqhJZN38msPQyFQ4shZfEUvgyb2hJ1dFfrP44uNVn66zn6JdjLa4SmQhd5HerrwiDfJ4o3sVSODPIExRbCmcG+QJZHBBL4cwgT1BsKZwZ5AmKLYUzgzxBsaVwZpAnKLYUXmITB2SUQCyFl9jSAfHMi6XwEhs8oAyLpfAS2z2gDIul8BKbP6AMi6XwEltBoAyLpfASG0OgDIul8BLbRKAMi6XwEptGoAyLpXAuL4JiS+FcXgTFlsK5vMhodmwpnMuLoNhSOJcXQbGlcC4vgmJL4VxeBMWWwrm8CIothXN5ERRbCi+RpXCP1WF9LQp/JbIUnmO1Wb+QoLAUforVaxP74SWyFD7Larj+5RhlBezUUnhJLZLcg6xHFGmvJpffShidT6XU6yWMzQkVuwe/Ss/F6RssKg6xFF7idsp6idDqypPVuJU6TW4wb4uL8WzeVis7Nm9bgLMhlm7t2LztZThj87Z2bN52UT0Tqz2W1cW4myyj9y1nVjb2hHlbJzFv6yTmbZ3EvK2TmLd1EvO2TmLe1knM2zqJeVsnMW/rJOZtncS8rZOYt3US87ZOYt7WSczbOol5W8cwb+sY5m0dw7ytY5i3dVLztqXYvG0x6K/VL1pezN5Ac8UmGW8op0p7J2hdnExVUTYV6EXXL1Ui0+lsEiud77BJ3cB5aU3fSPgtbOa3sKG3v46H8FvYUNQHFXeqjc/8BHbCbzEHoeqcoXlvk05+4USdfAzq2o518mepXdikk2+rdea3sGMVyiGxjU7o4kM7/zVWljF4Ll4SpfyX/x8o5b+kbqiXo/2/jDY+dE0PX8MkpDb3wzK0eUkB5iKMjFSpiDFtMbsFvmpLLak1rrjLbvs1YRFo9z2a5y2s39p9T81jaWStO4e/6/nokX9k1ni1pqyg87tenaIFfYvViYPG7xE0sOpBSB0Q9xu33vNjDavRu3dV6n79q3wPoqiqKGMrVcNKXK+h2IvHBbyFkOqJIasnhqgTQ9ZPDNk4MWTrxJDdE0NunRhy+8SQV08MuXNiyL0TQ+6fGPLOiSEmoeFEUOPkoObJQa2Tg8Ljg2gzAfncri6ir5Lx7RmeuzSbAbbf0g6aFEYUtOcT2tVPcVDx5KDqyUGrJwepk4JgNKGQ/TC9ySSvBlJjulcDucEDl4G8xBSwBkLqwUbFaVIMNupYk0qw0Rw0af0aLQe6AJlGpkld2GiP0AnINF3oBWRaOXQDMh0CCgKZvgMtgUw3g6pAptBI3yFTwjjDKWSqA8cwhUzd4XCgkKlo/W07sOmacSG+W+xkS584ini2NMAadmJOtg7UDSjgO9lqUC9BD9/J1oR6OdQv03xtYK+E+hWazQ3sM6H+DM31BvbZUH+WVgIG9jloTTuZilGfD/XnaRVhYF8I9RdojWFgXwz1F2kFYmBfCvWXaLIysLuhvkurFwP7cqi/TGsbA/tKqL9CKx8D+yU7RI05mRpTv2yHqDUnU2uQYqHmnEzNqV+16WjHydQe2ARx0CMbJpazfts2ZoVftc0Ro5Hx/XLG90sZ31dMz5dNz13T8yXT80XT8wXT83nT8znT81nT8xnT84rpedn0vGR6bpiemunZNDw0wmEJ/UjrnmiEE+1lomqzpY9r7EZRO5dNc6nRI21+onlOtKRsdWeTfotWUBNpNSb8d7Leray3+ti0OxNpNSf897Le3ax39bFpdyfSak3472e9t7JedWLaPLN1ipA3zLDQDbWcrNl8Wom2X1NbagWGqUKorLdfw8T4JxaEL5bzAOu23+57PtjMrMvu4Qee3lSQBykLMqPDDzxV49nHKvtbiig9Xl/jADK73fnA8zexolRbd31njdaW8OwrZ636HTslrgUdVA3RnV3nXSJVs65Yv/KBN+NYNijVgtYHXp1+OAg/8OplUKFYZVUNWsis4+yqlXXHQn73PkA3VytXrFVahwbvpt+8TruQK5aF3cJV5xcpm/NsobHxpx4shv8pFp6xbUYraIm/If5Q/E3xt8XfEv+h+EPxd8TfFn9X/Ifi74m/I/6++LviH4i/J/6h+PviPxL/QPwj8Q/FPxb/UQHreyzL44Z/Zveg5vY+8BIiu4frIOuV3K6qBu//CS2HqsF7cMyl5Rd8B0BRlvN6JbB0lcrTXwucNzBNoiLUiqoGztv14FDI7xxpcUvYRag1VM8SVUVx3bFerlj06+UZx7YKZbVEttvnrljWyxV7Ok/A+6+pmSuW9VLFQ5Xbdb+q7Fu8zcq/UqHmyDvL3+5ji2d9puKaebTRcOzAfsOvYvtXRBpvsXA83pmsUGb1UmDramDpNXeXf8hR0DpbUUv8ScnGhXoOYPsR+PU1n99wPvwb2kb6dV1Va9hFrqki9dgyWjBngDPo/6XyAbklasM2a8N4D/327s2KPe2Uye1vqRUVVxYNDr50ab8G5sP9Kg6Z+Uk9VteoZ/Ny+k8sFiRTaixSriIHUsJVIxs+Oqteooby+/BX1x3rqoNvXcLD4g1z0P8gbr1mo7XKah4H0HRwkrReGS9cy3ZowLC34VcWHaD8iafOgD9omnLT9yAdcIUyw7pi/eoHnl5BUOMDT1fVGUWZOaPOBDABmaP8CJHf+bpCNlfUmeoWYqw703QsgbRtSR1Nc5oy4UxkggbFEMhlt/WBd3fb+vYHx2TN+TebNQdNf4XL7D/4wKtY8ThfpRGTB/otVQUT4oNkSvG42yw51DVeyu2i96NnUadyaCywuRud5+7zVX9NVdW8stX5Y5qtv0kB848E3F3z+Z21R9+5ceI7el5Ra6TGifsO5NC1uGOBhRRkHixJX8o9kKxxlv2/ZA4zv+apWvnFf/T7+Pe/7ERlXUMZNmmytMg4C3JtczrZbujLFEw9q0aCE6a08t4Ap2jwQ/vHSJYyn3QHYtuSOhnvJIu4J7t3117XK2hzrrQ5tbKN1vOYHhCTxvylWhfly3r5uEbGKSsbs0jcdCEQDCx9HoHjP/ECC+M12kpg6XlD1nfBCobWG/4aiZss3+YGef4mxhYiWvvAQ1tbwzcotcbUcmtMLbfG1HI2j/hL6nxg/bhfuIlzOGno87z0WTquDlADelPNa5zvLNFkB4kVTxdc875zwgi6+ToyaOkVDHrynvN2XTk0igX2K9pRVW0phxodRVihCPOIMI+Sm1fnaaxfW3eKulqmFtnDuIcpIa51n4QCvQ+89HRrTfEXVY9pVSwRdV9e45tPH3i0+H6NDqCsq6gkZ1cVWNLQZUNIH3hhIl2zdtPNwe7dNb0JYlMM8efrej6wkoI67qeXqFzijYbaVZtqKZbPqk207l/9wFvbp3KbjycbtVS9jM5I7cdfMuoFPWeJJmLKttpSN2T+geCVGok+X1bnUdh1n9YvaTVgkqkmzYKOMbdglWoTZHIQD9dk8x64b/FiBh8HgtY3/GLgfhYHocGDt3RBvn0JbZa+Pf7a8+o8t4N9WjsjwP7qyWHOY8LcE8KsIFfXaCs5tBUhxluhM2Y7zkfQB2XDkloiiqd9XvrZeE1WSyvCp8efTWy28yAuzvDloZpTNltnIiCw9JL5m3416O7ZdSym7U/nUM9VysZl16Lq2SxT3KQ4fnR0CwO1pZYwUC/JQB333fRnrTQdjI2bWDRn09lMBN53WS5soQ384geeXw2sW7TTbfypV6cmfTRFujdEgniP6RHvMC/ifbpRZuE8G0PCOilG3TC20HdzD8BJR1mjfrqApN4LD9JOWoZ4By247i8FjTU+pV8KDulHUVtjjxkhoyiuM9+SkyWb9gq6iNyWUS52cLSKZTnyoucuWMFu3Z+/SOvDoJmrY8g8yr9MazHrqtPK09P6W3nUQ/Wqc5THdqAo5IRWMCoKJ6EF69zM9mHBkDvTe1jBgJ2fQwGz8/PpoT1TanxBfSHa/67+Eqa5or6LRw98imy/7cs8VNDqbEZZdBuvijt4ieR+5zWqn7Ihi/ipiq2qWItmIqXC/u/9FOYPW9Oav37FauX5hIUqqiqEjLaqosGBla5gCvQSEzm77+7+Bm+IqsQJyLFQFRLT3wU3Yg1Z6bkgHamlpygRvOrG3TVsZrcOcPBRxc0tXiTfXaMVqh3niAjEqnV/ha+TupRvVd62WnlVZXJrvcWnJNV6Ikoa7ZABL1xaqfI1ioP9dHy2jAK7uxZhA2+pGsgOUzay1Pn6Wop3U7x7d43aXlKyIUhAiGXSpxr4itrk66BV9QX1lUh9KfZvqdoBKD9J+mg2WswTF6yg+oZv4XaTUKzERXeRWE1xCJZXd9UXwVP5eRgJ+RwYUUL1WfVZ3GV9JQrVy+plnGG9BJnGd6MX/+I3//kffvqn7uwcGI0ibRE7r6/5N8KUT7SG9HGXIvlhXDIxYnP/3rOp0PlTqQaL+FMNQzxW8UeRcx1/NmC1Qb9MZzjMqbrOg8Y7+hUaFYltOwjziUnjlxTRYr4cqhtRku/VtF5WzXpZTetl9WG9RC++/x7924mq37GJL9ZikQtuOhWVhdayqWqvr3HmWcCyxoyAmCyDAgaCKueK+Epp9rOCaj2umEE+kSeu7hrOk3M1mamkWlXqpLeZOOYXUUexE5kb5NV8sPsG33ezg/9kqo4BiliUyelgFQTNzotWYGNWP8PZPV/+Z4Ez/e7MAwxgv3gK3/PiP7/3p43/YvxnN+7maO8XDP/Qk4VaOsMVnF3ha0e7TCY2Dz4M7elWNxj9dZ5S/oX9VuDgrlkFp0L/fjqtVMoUP5nNPtwrwtaex4yWVx5PwgU+Ho1/3MmmBOFIBSyP2ZQqaVOumA2/kg4JFWNI0DOo7L1vnVBYf7ecFJa5AKgkVPdp0Rmh2VKcCAgsnZ8s1O/njymh/yn/uEL9EK98yEI1U0oKNZvSiYWqZlRFzUgx4jj6kYJ8wAX5/tz/KwX5e9PHlMo/nH5cQX6IVz5kQZopJQWZTelHFqSnZpId8vciw0gbhA0/XJWR5Xd3DvwTkor8ChYqf+bxGurheqPxw9XQn6nhCbntD1chrKNIvTJHcsi2wawIchEhzxF+a44j5ClChW/qzOLDUNeIaKsZNcujK273V++u+dV9f5Yz1P1qV6XOu2vyE2pGVfdjHmLEmTHjSE6Rg+p+/JWIVTFjVTilPK6MUBZ8b42/DvlS3hqTTL2+puw3Avdrwd6feW/WgxEXi8bHNb91CgWBb084kUc7dDPjh6vvV79j7yfl+oVdw/n6mpohUhgsyDzsxpff8J2LlhQ1FT/KkNKVAocbxVZBWfl4zuCJ7ZmuokDJNYvGtFz3XTQGIBRzVlVNbmi/ciAsucu4gTarxK+q5Govgx12pu7bMSXsEPZ4Yw+M85ZjT3+m7k+LhyjgZx4+DfaF0QyIYmdwf7VZqP66rfNSbFyETtBcrqucXGhzgtZyXbmxT1Vqbojr084lt7286TaQr3EFafXZorQTDArEVZsXb6OA3ejRD1eT6y2Uq70CP8eoa3rpqnOGnONK/apDt8Pw7lVnkZx7cFY5Qr4OaQucPVgtLz6MWazrqcDSLg03oJfBdTm/kjBh852cZJrM8TRpgZCarkFVFBEX0GYynXoiM4XcrprCVXZVqX4e0pzhH3o6h8vsNuo295mKTXf0dGXaKhMfGW78HZMFmXzSLHwf2xxkfjIfyWj9+Hz83fIx+Shm8lE9Jh8ydqf5+L3yCflIBrvH5+P9uWPyUZV8xCoTDk6bpLWL0gR7eAsiHlqhxR4HFoD9CWj8KLS3PAnh13oz5EMvgPdoibxHS2jMdAZb8Gf2VeXgpKVEDR1mxrxVzQmNK2rmoIYH3yecIe+e/EyDvQ3xNtnbFG+LvS3xhuwNxdtmb1u8h+w9FG+HvR3xdtnbhXdGblpybxosp+4/Ynd3uX7V6bO7WL/q/L5EAdxb5gQHBUpwUGDvkL3DAnobxibhTKWCrqociFPdy651wPyEtpD8WAfMXGgLdZF1wJyGtlAQWQfMdmgLlZB1wDyItlACWQfMkGgL0ZF1wNyJthAWWQfMqmgL8ZB1wHyLthAIWQfMxGgLLZJ1wByNttAbWQfM3mgLTZF1wLyOttANWQfM+MgbJQH2bEYaCdIQpJkgTTve98VIS5AwQUJB2gnSFuQwQQ4F6SRIR5BugnQF6SVIz1aZCurbmRrqywuD5IWBIMMEGQpylCBHgowSZCTIOEHGguw5SWE5UlgJ0hCkmSBNQVoJ0hIkTJBQkHaCtAU5TJBDQToJ0hGkmyBdQXoJ0hOknyB9QQYJMhBkmCBDQY4S5EiQUYKMBBknyFiQPTcpH1fKJ0Eabrbymm6m8pryQit5oSVImCChIO0EaQtymCCHgnQSpCNIN0G6gvQSpCdIP0H6ggwSZCDIMEGGghwlyJEgowQZCTJOkLEge7mksHJSWAnSEKSZIE1BWgnSEiRMkFCQdoK0BTlMkENBOgnSEaSbIF1BegnSy030vBxXXk4KS14YsG7hAdElc2ElyFCQowQ5EmSUICNBxgkyFmTPi5E9TworQRqCNBOkKUgrQVqChAkSCtJOkLYghwlyKEgnQTqCdBOkK0gvQXqC9BOkL8ggQQaCDBNkKMhRghwJMkqQkSDjBBkLspdPyicv5ZMgDUGaCdIUpJUgrTxPt3qGZ2Gs6zE54wYI5mw9x1O5nucZXi/wxK8XeT2gl3iZAO1DrB78FWKbpQkaCr3JlSRLragKU2mRv6iW2V9UMukusT+ZbxfZn8y3C+xP5tt59ifz7Rz7k/m2yv5kvp1lfzLfzrD/VqwiN0Uqcliox2pyvOUXS5WNgloJ05VRs6CWw3Rl1CqopTBdGYUFtRimK6N2QS2E6crosKDmw3Rl1CmouTBdGXULipSKxNsrKFLAEm+/oGZCWhnlZZMS7z+C3mxdNip8u55+eZn2j918vfpXuI4Pl/UskB94gCBMDKtkbfEy+ACtoPuPy/XqX4HyZxU0yDMZYz/YJD7sXt865c9G/pyajdTMi1P/7cH961O/vhPhfB9771CWt5TsHK5X8TbMr0YcQS5ZGZuzMcWtYrMd+QuRyqbUptAF/FzyvhN05zj9SgbtzXHcLHpIKcxSnfszmaD+HAsGKpO/uicBRq4hXWksQy2E9mZFFMaunrlgBd0CEVKrvI9GX4eEyCES5dvGCvw//q4fb4+rXaYH9WfT231/le4FpcbC1GyoZn4aYJG6UvU/spE2+N+pfumeDAot2b1Ed3EAO0sfOqNmIaBIl//Gan/NX9n30/V/H6cfM0q2+noVUqzZ9/0FVT3w5xJ9lAlllBk1u48I8ydE2PcXM7uqeTWfmheGrFkvqMqLVz555s8/uHp6J/KXVEXN4b9srBc/d/WPPnqz8cc7kb8cqQXDO6fmoYp5YMidltUcEH9OzcFq77yaV0v4IBzJoDj9KhVM9eSCoasNaGpqZj8WB1mW9bqfW/OrSeVQgVWpwKpI30hL5dZwYcOlmvLizumCLDWuOF0yt2KoMVetYKFf5NeOr2psSbGhO0XK/kxUXTnwaXfkMl115cAnZTSXWasrB/4cxk+XyasrB/48hk+XCawrB/4iRk9XeKwrB/4CRk9X6KwrB/4SRk9XOK0rB/4yRk9XqK0rB/5pjJ6uWlGz+/6sOkXsT7eJeM5FAZL/1RBbFpeHE/dhLkNsWeCfI/89og6Df57890NsWeBfJP87IbYs8C8wWy9ulGLzombVElP1Amkwssw8vUCajJxmSisgLVutqso+5JeRhoSrGmm0+rlIoy7nIz2nKmox0vOqohYivagqailCM1XLkUb7PB3pZVVRpyIyhAvleleqiSY66vp+ToEdWbTnLL8SGfqPZEOBBGEZdEjozAR6RGh1Ah0ROjeBjgmdn0BxfyBHE6mJNghdmECbhC5NoGAJ9miqTrU2RXt/Sph9V2nrd2ITLsW6XsoNurjeRxNX8dF5K9YKEzLOdNQUk1pVSHrzx4SMTwzB2H58SHv+pJC9hZNCBieGHC6eFNJYOilkeHwIzRtYSs2coCvkBHuz9ZPVlpyg8fjg5uODW48PDh8f3H588OHjgzuPD+4+LtjLah9ViOXfAGaI/t8AZskwgAFUyWKAAcyRNQEDmCczAwawQPYHDGCRTBMYwFK2LUd6ObBJFOlRR3mTONnM2/+VUFfQKkxtg5lQzwAztRtmQz0LzNSmqIa6CsxU3pgL9RwwUy9nPtTzwEytnIVQLwAzdXIWQ70IzNTIWQr1UrbVRmo51MsiIZVRYdnQEFkyVSMWTc+C6Zk3PXOmp2p6Zk3PjOmpTGi+YCk9q0ka2pmVte8s72/as7y/CWd5f9Oa5f1Nc5b3N41Z3t/szfL+Zjyjl+loDwu+ox+uYiYcz9DB0khOTJZq7t4sIWNBFmtug5G9f8HIQs1tMtIQZL7mthhpCjJXc0NGWoJUiaMBSCjILFE0AGkLMkMMDUAOBakQQQOUHzr/YjXRt4X3h6t1HHT0ZjZZ94D8wWgmNhBsBQOGjgyoz9DQgHoMDQyoy1DfgJAfVZEVP9wzonIBd3yKB3eV3SgHNcdulJKaZzfKUC2I+gN+ZlFUI+BeErUJuJdFRQPxvXgnZAWDXzxVZ0m5qFyIfxS/K/6x+Efi35P0cEUBHALyWTiEh7fI3oZ4q+xtindVTrWWYT3xf8jZTz9gKaCeYsmjLrPoEwZuiG6twlfVZmjHoWf5YkqVBYV6joWTep6lo3qBJbJ6ka+5LdG2Wi/T7levsCxRr7L8Up9iwak+zUJbvca34c7Q3lufpS2yPsfiRn2eRZxasVhVa5brap/vxlygDbq+SPto/QRLJPWTLAXVT7HkFQr6xH55icXN+mnaxuvLJN3WzyiLjzNd2s2zKhhYKmDAISTlLTBZEFM5eVf9PEuO2aug3U+W78i77hdZ5MreDb/EUlG2IoUF8+VI5dQzsOyino5ClVeXolAV1HoUqqJ6KgpVST0ZEV8cYl9E7Cco9gWK7VNsTbEVxT7PdH2IfRaxz1HsMxR7jWKfptinKPYq0/ch9jJir1DsJYq9SLEXKPY8xZ5jPj/EnkXsKsWeodgVij1NscsUe4pOeMu/NW077ypWauYTZ1t4KlhlmX/fFp4KVkjm77WFp4JcxFNBLuKpsILdN5Qd7L5hpkpsFeQitgpyEVsFuYitglzEVkEuYqsgF7FVWNwoaClvcTXTIt7ijkDLd4vbNy3cLW62tNS0uDXS+YLFjYxOFixuH3SmIJeg6TSBb1nbdI5gcTegQwOLWzcdF1jcaOmgwOKGRUcEFndUOhywuP/RsQDn36EDAc6/Q0cBnH+HDgE4/w6J/zn/Dgn+Of8Oifw5/w4J+zn/Don5Of8OCfg5/w6J9jn/Dgn1Of8OifM5/w4J8jn/DonwOf8OCe85/w6J7Tn/LgnsOf8uieo5/y7J5Tn/LknkOf8uyeI5/y5J4Tn/LsnfOf8uSd45/y7J3Dn/bnxNEtJ2krNz/l2SsHP+XZKtc/5dkqpz/l2Sp3P+XZKkc/5zkKGzxks/5zu4h97P4V6Mc7MSt6scSdX5u3IkT+fvypEknb8rRzJ0/q4cSc/5u3IkN+fvypHEnL8rR7Jy/q4cpOS0OIDOQGBtW/0cqzQ2crizYdMzvWvg0ixRZVdxk3vnJfcwtym/dclt5zYlD5fcMLcpebvk9nKbkMiTu5vblDxccju5TcobtKP6ubIUbA7SeC6clseF0/KyhTPMkXyeCzxHknku8BzJ5LnAcySN5wL3SA7PBeuRBJ4L1oPsPVMILY8LYSiFMJwshI1Npvi75K5vMu/fJVdtMhkgzZyrxxcWPrIF/UZ8WC/PH9bLZz8s9EjQzzXqkYifa9Qj4T7XqEdifa5RjwT6XKMeifK5pXokxOcC9Uh8zwXnkeCeC84jkT0XnEfCei44j8T0XHB5EtBzweVJNM8FlyehPLfIPInjOf/5mhuKu52vuW1xH+Zr7qG4O/ma2xF3N19zu/lZo/x78MG4MniMQq8eM31T+fXy5fJ/edZZeLf64ALujL/h5y5aKhf0imIgJRd0i3XfiT3QN/Ziz2EaqZ06w8SJRwsMGxaIkf1F0hie8pdT0eBdymSfL+lD5jxg55LKpXebFg/41d5URETBkGMsRcTiC+dyRDzAVjBMkzmKk3HUIpZw5I2YeIpftpJ3D/HuXllesHAbn5PJ0bvj+N1ekV7Qy5SCRlivlLzVZecKFpzsxLW1Q3aewpKXnSj3kJ1rJEEv6TPcP1pTSWLhlCRmlMIylQKu0nJ25OtX+OvjMmnhYwZJtkCVqVekFIalE0phJS6FEb94Fp/NznNSCkeltBQszrd/Bs8xziDGuDG2N4v+HX+dv8b382T9LmFcCP5pM6wpYVxW/ikzrCVhXKT+qhkWShiXvL9ihrUljCvIXzLC1DJdShR2u0V1jmv0bKQXwYI4KMrGIQetCNlbKPrUrhy3WLiW5Tsq84V9gjIfNiAo8z1DgjKfcURQJvcjgpYyBUi3/qzL4LY2y45h0fDIlJyEjB4JCSVk/EhIW0L2SpMhhxLSeCSkIyHNiRBMQhBbeledTo58zTJpeR2hsTq49pZTOeij4NobnJ0cXXuD86hI194stsUDZcsy5LjUS8icjwUxtmd8Uxl6GBak2QXje8oQrFkk1M4bH1PGJX6LZNtF40vKdb9EP8YX3QTuluv+FLV4W02lcK8ME0kWXXspG80ARn3oNqZN98HiplAGo6+VpXi2gmG5zudoHZsspcdNogzmPYuuwswazaIMVS+L7sNUU3hcrvtz1NVt0JrF8N409MlIPxUq1klDmq77C9SQbLWQVBYUJdzkeN9dd3DW75OQnZfnodwOIik7r9JDuR5EYnZerIdyP4jk7LxmD+WCkEslRUv3UG4IMRE2reBDuSLEJNi0kA/ljhATYNsp8ast5Ne0rA/llhATX9PqPqTlvS2k17TID+VqEBNe01o/lLtBbszZNgQ0FOhIrgiFcjuISa5pAxDK9SAmuKZ9QCj3g5jcmrYDoVwQYmJr2hWEckOISa1pcxDKFSEmtKY9Qih3hJjMmrYKoVwSYiJr2jGEckuISayZcU6uCTGBNe0fQrknxOTVtI0I5aIQE1fTbiKk7UQuvkI72tl0pYvGXfW/zqV9tctuOP9+Lu2stCCmjppO7tRjMyJ8AuOrkFksIwAXjDVtshgTRWaxKeqYWYzvXmYxvqKZxSrUH7PYDHXGLDZLPTGLVakbZrE56oNZbJ46YBZboN6XxWgMnOiHdDuK+2CU9kHZKEdpF5TtcpT2QNk0R2kHlK1zlPY/2UBHafeTbXSU9j7ZTEdp55MtdZT2PdlYR2nXk+11lPY82WRHaceTrXaU9jvZcEdpt5Ntd5T2Otl8R2mnky14lPY52YhHaZeT7XiU9jjZlEdph5OteZT2N9mgR2l3k216lPY22axHaWeTLXuU9jXZuEe8c8femNaPRxWxik5rkq5Li79RhU2aYC2J3TItJMcVttmCpSS2zbSO3Jup+8VkJTlw9RkM8DN8ORyrOGyk9TnMvTN1H30EevrYUWuFqXRGrN9ogCNX+/RGRV/AjDojE9nY5Ylssnv5SoeT3VCp8+Fkdz2nzoaT3fqMWgsnu/9pdSqcHCZW1coE5qkltTyBgcj1QgYbVrgvYYqt1FmdLhe0ivXqbd6D6EUaw4i+u5OrV1+VQ1wcaW696XtQjOnSkaFE9LiionQdwRdMEMEjy0j57EUSCahmAgZpwGomYJgGqEzAURqwngkYzWHdRQEbUbrsypzIEu9He8b3gi1S9emeqssSEiuRKX9RLpb3GD8qqhjpMzKSmIIOGB1n0SGje6UMesRoI4uOGG2aKDOTX3XaMzyFHNJq63CGbz4xzRRBnRm+/WRVL6kcFrYXrfL7i7b3Lss+WB4vovj/H0o6Sdt8j5QH8lAddrAf36NTdacuP+TSgbifq6scm8iMwepx4OpxoKojZScF84FX9/PB71jSJv6tF35I/vNEI835z9fcvrgHedJU5fznSZmY85+vuUfiHuVrIEbn/OfJTADnv1CDYg/nv1DDTUDOf6GGa4Cc/0INdwA5/4UaLgBy/gs13P7j/BdquPrH+S/UcO+P81+o4dIf579Qw40/zn+hhut+nP8CKS9w/gukucD5L9TAV875L5BNJs5/gQwtcf6LZD3JChpFNL5GMW4jVtAkpGkgLUJaBhISEhpIm5C2gRwScmggHUI6BtIlpJsi9L1FFi7QttsWSgLZPREyMJAhIUMDOSLkyEBGhIwMZEzIOPu7eyWyEkV7W5RJySgTQpoG0iKkZSAhIaGBtAlpG8ghIYcG0iGkYyBdQroG0iOkZyB9QvoGMiBkYCBDQoYGckTIkYGMCBkZyJiQsYHsTdHwNJUiDUIaBtIkpGkgLUJaBhISEhpIm5C2gRwScmggHUI6BtIlpGsgPUJ6BtInpG8gA0IGU5kaH07V3OEUSwkTihApGUJGBjImZGwge2UqmbJRMoQ0DKRJSLOc+d1Wuea2yiytQJkY8duEtA3kkJBDA+kQ0jGQLiFdA+kR0jOQISHDsnGmT8ggRTBl9subbp9E6TCTDcY/iOrZmRWoH5VrMIxN4giUlfFbY0LGBrI3TWU1bZQVIQ0DaRLSNJAWIa0YyZwmhNMsLYWMhAheyv8aTxPCaZkg29M1tz1NxTGoJMXBzmxxHE7X3MNpVA9lumN8RpeQroH0COkZSJ+QvoEMCBkYyJCQoYEcEXJkICNCRgYyJmRsIHsVqoyKURmENAykSUjTQFqEtAwkJCQ0kDYhbQM5JOTQQDqEdAykS0jXQHqE9AykT0g/RsxzjUGFzjUO6TsPp7PnGoNKufzHp52ZB6V3mbBkCarOKncVXFGMrF6kjzlXBw/qFWuv7K8Q2RcPEbiR9+JP0r//cScyrr77pZo7Ign52XT0ODG2lPy5dFj5EVEb59Lx5kdEbZ5LB6IfEbV1Lh2hHhc18VAne/G1j/zkxtO/+UmiAyoe8C2MKgthH+4b9yMkFR1bXtli8liPw5IxL3nx+NIzCs1jhQ9Lhsb0xdFjXmzEL67zOJp5cfyYF5vxixs83GZePLacjeL1WNfEkvE4fbFx4otevMfgkZveKuPSa5RMHvBNvEbb1AXsIBZhOqhXZGNEGpdzYZcL92XyLE7aK7HxIl1QiyqvvH3fEzlTHEB7S1VIAkYIIDubfgFvxNfcvxdFvocjvzy/6OcNIqWi8lTx9TXfU/n32XN3TRX2JUZt9yDk5POqFBpKDd7ruV36eU+E0GEBF49zqVystvsbpGuxgF3tApPe8LfXg9FZOqAqkV5O2nOrNbcLSoXeWl22fTSMsE/JEMu+dRle2bchQyv7tmRYhS/ZB5aT0zjhvflt7hmJLzzwvX2dhwUxqqWc1NJC0F2r+8uw7cVCBDagVuWyjEKf2HwXgvFaXeUhGDzMfzehcYqoOlRh/70wUt6BX0h1DAoZPW4rtibFBGPYRJ9RLjT0Vt8LEx6SUSbPv/G9AzA25Pd1QeWuWFV/gQqygDaIrf4aZNtrZeKs8CD0goipc4bOemAaGwkreifYO4OmQ28uJloy8XsdvNdN3ls33ms87r0u3usl720Y7zUf914P7/WT97aM91qPe6+P9wbyHle88Wr4uFcHeHWY/OQt4732GTRsei/3yHvDMzz9EI1RjitH+FKockQwlbal/mm0JWpBvWI8SLwn7/zmTngAyy4LxwXsv8cdcdXkyyiqBXDX+Qu4eYbm6OfVslolqZfB0CLJqfzrjzQ1oePdozuMg7iX5HYjPn1r5HwvQjenmcIIjqJQFwJLL7hpt26fq1P3WAg23iSj212PR8QcRBWJ85CdpkYa4YM0Sj919h6NrQo8BidDC9ObLaAhnwXBxwh8H7g8Kcs+qsgRVS8fEx6d8T3j6nMpHRyS/um9hwmQ3ym+R6pDU9G+n08iWylzncqt+eVIJTes9zAsPMylKqqpSJWVF+37U3BiWgnD7/r5A78M2pwplT/wp1UxAs8DfXFJlfBakaJNHfiz8MP2YQFRC1BYQnp+eV9NHfhz0b7OK09NR/60KqhS5M8TPoWkimo2wtgw9zA1ul+4r4tqXk3v65Iqq+q+niLWF1xfxRpMn3JBEJ7MTmxodFGd4jlKlaN4poFZPLUYbNURDzZ8kXYatkzaLWtkE4x1RRfVSpIgpVU041MKBROhd/P8rlnJ5XjDVr2K4Z7vN8vKUblXrOq29e+V1SpTkxFibYNFGWL8ogbd7g/e++v/6G/+wz/4tZc23TYR8eLOEzHb7wpFrr/AVOsLIB5dJHbVhQCMPp/K7b74g18Ja1+4cel3iKjMBbHsAkhIlycCMGycr5MdqxypqroJhShxF+cJckyoQJBtQkWCUn+J+mGJJut40vZUQZ7519c01BFyde2qHBhJc2oZhcZ7rnevgn0f7kXiJ00pVIShEzRTRjI2kmHCOrVIZR+8q50kIS659gf8uQsxTwu+OkdM83H6vl1PSEEzxMlOYH0GhJgqx3S9uZjXikicbzJzvMs/5monIW9ZiBvCu2IkAOx04JbPVG7ng8na7nu89fj2ZEgY8zD3JkNanPwn7EmecOJkpuxchUstEXuzsxsXxBJzNS+ppZirWTia3cBSS1VY51oScmYX9yZcaXufITuWQs9sx9zPzjHpJbXH6eKo6jHp3mJebeoX5W/NO7l3PVwZ23jD9y6iJryvaHCoTH1F5+VieSnmbperh6/5zoxnWbbr5MpyjXxKboaX+YxRTyvvBRvbdk8529aqMQGp0n5CWZyCzpoqifm0f7IT+ZVoX8gkb38vVOV9NZ1sYV78a2d/8tPVr53HOxj50kF66iHiT5E+uYd8vvfatnWJne+/tm09TbwHRHaApxes1qs/qaYyhDneC3t7Oc72FKUTUO6PebGs3Jv0gsXRSxw9d0J0SnmvCFGFB90JqP8+nGmtibjVn6RtcZJqhVO1TsxEHPOFv/gnv/Pr//3vtto7m/SGe1I+uJpKyE8+k3P3xN/IV9zkd7g8PFVOqULx+jHvgVeff2yKa0A7SZsIJtrEi51z3/rzz3X+9o5U+n1ULma1ktkMuGqpYmmec1Cnnsqjlo/JADVXlxnO33+NxpCkXMv8zfYJ30x2nqGBFn+1nf3qxRO/uqzcivOXaRX/pqtv2ik77wYTBs7ArHU6oDElMcF4GqYc3qJlnEs2RuJpLmE9LKUWOh68pYsTATEdIplpJEOKbKYRswktd4A5x2D2MVgGKMFgjobF0hz09POYzvJseKOsCjKBxe+07fglesPGGzJZyKqhlGh8v1422uQL/1e78w9+7Z/+7f9dqiDHVf5hx5GkJiWZ/+pH1WQ8IKwr70Vs4Bb/0z/YSXKmnLXHt1AeJhD8TPqb/zn95snjRFV5L7z/d77/++/9ne//U9ov0Mjy6Bg0bZcn18D9nYQhVhy/tsNl44OFnaZy51O+uwYm25f8PNgFVSnuvDsHfsmYAIzNyIv/5zfrf//tv3kvTV65a5Ff2jdW1g8RfxoL1DxG3Knk99MIzpoxDdAEJJHe3ol8Ivh8aW1fp0O9Ik7Nl9Z0uZyOSS5X+JQqyxTifIhqt2AeR7uTIzbm9pd/VKf/UaODUP9PZ+1yU7tp7KnMwDT9IQYmHjiZeBBVVMG64V/ab900Brq4Jf3ej2q9khgOGpKEAvulyqPFX3ok+86HGriSn6DsJr/hfLjfyH3Iuc0LNrAM+hs5x3mQh4S5WeF1EN8hSC5ICrCbXI+Uewm3ksuRcj3hdnI1Um4pvGrKZeW+wh0Tk5sL90xM7jDcN7EtuYFgYrux1pUJ3iJrGgXSSC4EU2+qPJstL8ASOrmVTTvyIQZT99O5B7QRdzzllM27J2y2PA9Pni+isCEmYkMBF6UdTL2JuYiNAJHmH7j6aZvjKifSTmAb+UAqMJCRSyy3022C2IedbU7yyoF26ns4LYShdsQ4jGStqHL4PE5BOXwlKadKhl+kG0QE5JHohYSNDgkbySK9LXdsPByWoClMOd67RayIQ4ebggdqAytoOkQU6ik3vaHkY4cOCXnL4dY2tPnZto2I1d004n0O3+KHpZxkODvwHeFOedoY2mAROSb0/ns7yl6jlCJdorovBhtv+hC2BhuYE1EXbP7YvOCUw+YcgYXs/SaIxWK8msF7VvLCaiagnwaoTACTYFDAusE2UUQJF4O8GEoAvTJtUNwXv/rLn777feflnUi5EUkoq1xEdEGoCGLciK+tWX5ZkXjETaYIvOO7YE95fY2e0/Kcen0N4o4yXi1TqhvcmVACOVXGFiHK0HfggpCElIhGyAjpWfFLFnRV3cifzYT3zXAVgQvJCB2YoeuRP5UJZXqQaeVkUKYHqUygI6ESyaJjoR3JokwPUp1AmR5kagJlepBpyJQMtGVzHrJoaHMesmjb5jxk0UPJQxbtSB6yaFfy4GZLXvKQRfuShyw6kDxk0aHkIYseSR6y6EjygFr0s9kbH1sYe85xhdFwjiuMpnNcYbSc4wojdJKMrE9kpO0cl5HDYzPSOTYj3WMz0ns0IxgKQwdDYfd5p/juczQUPs9DYU7omlPr59R12SCzUONY8e3fM+hP6M045uPgWdiPmAGP0Cy0oCvQfA4PwhPZ8RfBmTMFI5certRo5K1VrOtpTCpB9yKMLxXVYvUFMOPQNdAi49VPIuZMXRWDlgtKDpzRlDDIF+PrEnlc0JsCeU4KKe+Su1fk0NW6mo6PovNoqGRXmL2qQHcRGi47VzehdEvO6iZ0cclZ3ISKLjmtTWju5ol3qUyauCIAzVOhgYsHt3oPQr5qCxv17ts+TjjB8Akmr5ko1WXxguFGXU0JCQPYRkAwwoccQisiTCJCHiJ8IUwHskqmoUpUgiizEs+WqsRWk/OkWlGh0b1v43fzpJIxS46urXiq6Nhge8qTmscCOdq2ms9I5vGPvgeTQEnmbC/oPYW8+1QYuMdmcbk0ipgVyYkbZGOX3d0iKRyTu1OscZF7l93DIilMk7tdpAmY3GGRJmFyt4o0EXOxFzH3knNcpAuF5B4V6cIiuY+KdCGS3MMiaZuSe1AkNVpy94ukP8yZL9ElQs59iS7/8U+V6NJeni7VIRslvr05ZG9YMmbGQlwo5TrRm2/UaTeNLtOp1v0ylmk9R8+jtXQdvUCnJw5uPRMVxBKebQc6jkRCsYJnCxQROSJuOIVnw9Gn8dxz9BqeY1ufwXNk67N4HtnQDiSCh/N09GJrRecuYInIES+FT79v6wv0+7a+SL9v6yfo9239JP2+rZ+i3wdRRI7ILy7R74MoIkeEEZfxfEc/g8d9fQWPe/pZPO7o5/B4VW/gcVs/T0dv+iN47OqP0tmf/hgdHeqP08mjvkoHl3oTj1W9hUdV1/Ao6m3qXvoT7q7KqyJdm86pFVWiFROvkHw3Usu0JsKotUSroIcjVhiqRVr4YLZfoJUOZvZ5Wtr4cxE16g2VU2cxjZxBT1lT9Npp9JFT6B+rSuKtq5y6gHg+4mmOpxDvPOKdi+MplVOXEG8d8Z7ieE8i3hOIdzGOt6py6jnEexbxrnC8ZxDvMuI9HceDIt7HEe9jiPdRjvcRxHse8TbieFgufwLxthGvxvG2EG8T8a7G8SZWcjRw0PF4kdvu/xfN9FCaaVuaaSjNtCXNtCnNtCHNdE+a6TvcSu9zI73HbfQON9FXuYXe5hZ6i1voLrfQLW6hA5ubaN/mNtqzuZF2bW6lHftftZmWM41UfTySRsr0JtRKmbuEGqnaYKfyq8RLws0UpCPcTF11FRMtCFJmiPhkVj0fhapKVCZzoCjhZurCCFJFXaZ4FyneRyjeGsVbjKSZumoL8Z6heE9QvI9SvDMUbymSZuqqGuJdoXhPUryPUbyzFG85kmbqqm3Ee5biPUXxFMU7R/FWImmmrvoE4j1H8dYpnqZ45yneahQeM6xihUCNNWi4mLllX1wICm/qnMxFCa3fjK6oAm1sQdunK4FNEk2OlQ8Kb/qloIAlQzHdo3IKasrYxBJUlF2oGamURqqExAlGBl2SiRGTcTEovKkKvIGtCOMfdF7kNxlLPjIX566YZbeVDbyUAk+0NJlehNrgRYYaBPUA9QRqEtQH1CcIPw4FXo/L8qrTK6TuX/TI3Xq+ftXZYzdi/0WOnD3Q+Y9znHCLEh4g4YH8VkjQENBQoDZBR4COBDokaARoJFCHoDGgsUBdgvaegLLmEwz1CGoAagjUJ6gJqCnQgKAWoJZAQ4JCQKFARwS1AbUFGhF0COhQoDFBHUAdgfZKlDtAXYEaBPUA9QRqEtQH1BeoRdAA0ECgkKAhoKFAbYKOAB0JdEjQCNDoCZBI5up+QfQQc6og+sAFWr/lUlXcHIaNrs3jGKviEtSzeYhjVVyC+jaPfqyKS9DA5oGRVXEJGto8VLMqLkFHNo/irIpL0MjmAZ5VcQka2zz2syouQXsOTwusiktQw+EZg1VxCWo6PJmwKi5BLYfnGVbFzYmhvlyqiktQ2+HZiVVxCTp0eOJiVVyCOg7PaayKy+Xl8HTHqrhcXgQlqrhUXgT1AfUFGhA0ADQQaEjQENBQoCOCjgAdCTQiaARoJNCYoDGgsUB7LpWXGxIVEPpiR/NAdNntPgXCZw+3ZQXZeyr0Z7ELWkviPAlWXS8YrSRxngz9OVCdLiZxngj9BQwEc0mcJ0Kf2BTbMzLU+K4hwjeZikGyOy+GiBbkOSfPqjwNQ0XxccE1kgLFI1iFCLepu1eIirvLTvBu7z1JTnBud9kJloi9p8hJ5A9PycDKm8UX/cIVq+vmHnCPUWVlVZ+jWnc1LQEPXU0LwLar56gZuTBUDSolPUuNz2U2yranmVz3eb3I7UEvcXvVy9x59Aq9Z+tVPO/oUzRh69PchPUa9zp9hvxY+RSwKjlHM7w+z71NK0oT654CFis+LQX0BcoZVj0FJnHDWkE/icc9/RQtIvQ6Hhv6Eo0onn6ahqTn9WUadDz9DNXk8/oKfYSnn6WBbUM/R/E8vUGjy4Z+nuJ5+iM0AG3oj8rYSeHj3D7lz41AWUgzxoz6qPrIPq1u9yNQG/aBzqrn1ca+ehKoekLNIGyWlKI8VVXPqWf31QUK8xGmNK4wRSBPHCLGnLqintlX5ynGOYpxFjHUGVVFvDlSo/LUvLqsnt5XpyneKYq3SvFWEA8E00QsTXs2Ty2oReXuq0sU+ymKfZFiK4q9htgwTx3tR6SO5UE0w4vgoO+QdIDbkARVb8rBKEUhhUFS6205uoId/dDWM3i2YX+rhGVpla0zzeGxBT5SkmPkWY5BmvRkYCNPa8RSMGSzo/MsZlSlYMCAy1JJVQr6DBD1ziqAXlXIVCwS/JaCLgOkvIzrYdh7MhULhDmTm/p9EmAUiV+ZxXHE7FwFefMCqPCwapt4JyXEFddf243wKVVaBWLvXqy+FJ81xKs3KFDKHGbLQqpQ9x3Zu5HFAUe2b3Sf3Ul2cHRL3ZFNHN08d3gfF/J1cof3cnxFnMgF5+ONDlaaOPrBYhMnPvhEHPQgWWJvvI1PFU5D4m+8IzTz99I9FSVxX5J4R5LYs5M0GrYk0rTjVFq2JBPa6R7OFbV+TujQlpQ6aUrdOKVeklI/Tmlgp7tGV1T0OaWjOKVRmtI4TmnPiVNqOJJS00n3qa6o23NKoSMptZ0kpUNHUuokKXXjlHpOvDOmWYM0kGNCH4+UEh6Ccr7mka5B3EjIr6gRy+maR5oBMP/KJ2seXfh/CFL6Hl18pb5If6svsw4yjVHF/eRcgAkr6Mf3kyOBFFzdT08DUlTtp2cAKbq+n8r+U3RjP5X5p+jWfirzT9Hd/VTmn6K39lOZf4re3k9l/in66n4q80/RO/upzD9F7+2nMv8Uvb+fyvxT9J39VOafonv2fir0T+FGDHcycDOGuxm4FcO9DBzGcD8Dt2N4kIEPY3iYgTsxfJSBuzE8ysC9GB5n4H4M7zkmPIjhRgYexnAzAx/FcCsDj2I4zMDjGG5n4D1nPxX9G+Udw50M3IzhbgZuxXAvA4cM48cLzLY9KvCy5qjA3NrDAlNqDwrMpN0vMF92r8DLIwt/dklesWdH1e/a2pWNBS3jI141U8AiyFQwXyxgvoCYCSwsfC4gRwR8OhCmxiN4cVv9ro052pxg9pOrZP+yjJwH4fO49Fsp/4MpJ8+HuaO8MOLhBOMoz8+hPAfy7MuzJ89uHoRXl93hOb9MCuwQzljB6JycdZAiO2NjxmYiUmhnbO+8HHqwYntwRHH0lMoFCifKY49OlHGuA0Y8TBxT0qDoTY0pYIbC4MJl73IEkpwo/K5fjoiyIGhyVPBtzVLUVfr1aSZ+4Yy0OCNTkWyXylS26UFMXPjTalrSD8PInyL9fcoTbCThCYtPeDbl2XH5SbbGcrCqrXLVW8pJCGudhLDWSWgcnITGwUloHJyExsFJaBychMaBXLu47uAkBA5OQuDgJAQOTkLg4CQEDk5C4OAkVLWOQVXrGFS1jkFV6xhUtU5KVUuWkDAGFpj8gcgY4S+mRA0FXruUWAxkgNU64nuqmFI6uFjw/D2XVjyOsnEh76ozOgMbCGfqfK5WvYIbTNtW6zU+O69eP22ewAl72Xnce1Plu2t62rgjFek5XPihe37ehPHjKdzl82D82HXehSNj/HgqsDj8m2/RkYSXCaIlbVwQXnyHDyQ2W1jWcbbKkIa17TflTsIW71okZCoMNU7fnLr2YtPGJVn4Lb1Zxr1zonxny00+jas0zjtJAnqq/K+jP192R+cynfmyOz6X6cmX3b3zcTee7LtQIKHkLOrIZerIUJY5L923nHTfaTWH/++u+dzRoNTBvfiy2zwvXbgsXXgq7cLMWneeujz136nH9V8Uzr9i/80FozwOgP9407n6YJ6uRRXf8G+wkeHwvHa5z7CS05beYAu5sPGyoXLGWt/HajH3+pr+CHR//zurrl9SN4Jerq4/qW4Ew0Jdv6huBKFb1y+rG0EnX9e31A3MvfpT6kbQ9Or6lbTVbbi7eMnGFfcX1EeqLyBqDifALzBe/aS6gd0nroJEOsfX1dULgQclw1XD0MRo53UoKFyx/uA0G9F+gZrYNdrHY2/1QtApvln3a9AgYntW/MO1IISucPUZlMOr6ppQHahrYEdhPVFMWzdIzMXHurWgdbHO5quVKzfc/3SHrq/IHZa7CYXSqd3IkJnQVTZX3Qj2PMqb5VdCP4+5s6hqQfuJul8zTHBjVsypyoExXfoVug6Vz2D5fb8IG0yJhaUDbOBq8SL8hlG4+GIqXBSsunHJHdmb4Ae+BveRvUnRb1xyh/Ym6IRfUZ+Kz8dvqZdj54vqk6K2Ty5S2ycXqe2Ti9T2yWVJmkxX3CiSFe48ikgV33s/k+2H3wsRek5RybgHmhiab0Aq4btcGO6BnzM+nSypY8y8r3JkkYgai84pR+q/plxMNjWVI5N2UHQgk+xo/u4b/vZFS20HI6eur6mX/BrGPo3NfcDt0L8OGp9PkATmlPoEyXhO49kEM/8nqL+cwXMPUp1P4BzqHB739Xk87mmFxx2t8XhV+3jc1hfwuKUv4rGrn8BjSz+Jx4Z+Co91vY6H0pfwWNVP41HVl/Eo6mfw4DOPayqgE4SbKuCx+hOsaUUR6TgHL4JTH+mop+mpcOYUUtC6Widogw5pkA/1JAG76gl63sKpkUS+rS4Q9iodVOG7lCbgnlL0vI9jG477jjoXcbmAdJ8KCmdJIZedWou4MGH2iUoXp1zx1YIAAoMgyNG8sY39g95R12l7cY31HHlyphcjfUp5nFikT7OzaUd6jZ0NO9Jn2LlnR/osO9+J9Dl23Y/0eXbdi7Ri151Ia3a9GmmfXbcjfYFdtyJ9kV27kX6CXVuRfpJdG5F+il3rkV5nl4ogmqMaiCCcozqJIJ6jaoogoKMqjXQhsHXg7qpTcc3y934irt5dliToUwqfuktfHerTao19EDzoNXWGfbDIoM+os+yDoEKfVefY904U6nPqPHvuR6E+rxR77kWhVkqz504Uaq189rwahdpXF9hzOwr1BXWRPbeiUF9UT7BnNwr1E+pJ9mxFoX5SPcWejSjUT6l19qxHoV5Xl9ijolBfUk+zZzUK9dPqMnuqUagvq2fYU4xC/QwWXfBY0E+NGwsft+2oU8SeuKNO0xJvR63Rsm9HnaGl4I46S8vDHXUOK8YddR5Dxo5SWFPuKI1F5o7yMXvvqAtYhu6oi1iX7qgnsFDdUU9iMNlRT2Epu6NobbujLmGxu6Oexhy/oy5jZbCjnsGSYUeR7vh2OqZfJ66GnNqGyD8CFUDbVtuKAAhXi3ROI8CeS9dLOwkwdiLfpQVEDevOa8pFgpafi2jIpO5Tw5B1XZVULqJAARXAYhZUefhrsXBmGz/Rs9+nLMPdh1vwAdxVdg/hXmX3EdyK3SO419k9hnuD3XvO+yg3cjfg3mV3E+5b7G7BfZvdIdyvsrsN9x12H8J9j90duO+zuwv3O5J/uPds+QB4GuIZwNMUzxCelniO4AlttU3j/zWM/+6uMaiavbGAFywatrgUP6EIKvKgSwUpUJUgFnQJtMojMcm6BOKxk8VdAvGgzBIvgTZ4nKbzf4G2CNqiW+QC7fLgTZfIBbrF4ziukMfQbYLYAqBAr/LITkYABbpDENsBFOgeD/dkClCg+zzy09wr0DsEsUFAgR4OPjwEM1OxoA1bpgYmKxa0yWjMVyxoy5YpgymLBQ1tmT+YtTg7c6CHaelYOs/9iZZZG+gK6AXcpfwStTPbd1kfuQYBokQoqgTcfSMG8wmIvkP3LNjCbY1EhxKLUj00Uu2lYbk02YF13I8NUzT9NRIrJimgDxipj8xfTtDxsalDuPho6g07m3rXSL1pH5d6yz4udYgYqWSM1LeDpovNR6JySpvioPDGTNly4n+2A2WE6wmvGiwnCaEdG08a59l6Ut9j80kDm+0n7blsP6md01cSnjZYZxKCPP0s8wbq55g7UT8vVpY+yqZW9MfYvIj+eML7BqNOQrinrzIDod5kFka9JYadPDbawjabWjnYbIptClQTAj+24DTMswmnjsc2nLo2G3E6EiNOzRyMOMVmCObAaMNva2ZFZJNOhx7bdKLLemRIhq06NXKw6hRbLphnYkE28NTPs4GntscGng7FwNPAYQtPezn9jLJltXtN9j3FA9/Fc2TD0pMw6tEUc2SzeadRgbxDm+059fLkHdhszyn0yNuH2h7ZgiFvz/bLbBaHvF3bn5aTkMkLpn7BMP0Lm5U5iBXzDxepqogVa+nhClZNPVzfqjLWttPq6UeTmOfDpJAtVyMJXG3FirX4cP2qSljMTmG1W8ZSd1pdfDQJPkvi8ZuTwDVZLF6LDxezqoSl7RTWvuWHC181rc49mgQbJebxnpPAlVvc3irialYJ966msAouwy7r9AQNBiUhh10hm9RGEri+q55FEs8hieeRxMeRxMeQxEcfTYItKfN8wkngdi/O94o43yvhfG9KXUESq0hi5dEkcnyuhvknXcygqXBLqSr34LvpRi46IFmSra7zDEoTazooXFPXeTrt2tgvF+Ix4jCN5OI0ltGOic7FaNdEqzHaM9HZGO2b6EyM4qiBpn+gOUavYwa5zoeVIH+gfqGvB5beToUWudSZT52m7qwhVkud5dSZqv/p1DaiTm0m6lStV6c2FnVqe1GnNhl1aqtRpzYcdWraUa+4u+q62o6LHKbcaKkDaQid8alcqOlyHx/95UOdZx9OBIuhLrKv6YgKLvlwjghxHftwEFAOdZl9OHacDvU0+0a22MYkH44pySom+XB6SfYwyTewxRIm+ejMEzYwydezxfol+XBESnYvydexxeIl+XCkyrYu4cNJ60qoV9Q26nY7mGO9JZ62rstgtzIx4CxPjB5LE0PB4kS/XpjopPMTPW4u7T7k53GB1242W4+z44WbTY2UZOK0aoN/mvy8ZIO/TH5er8E/RX5erMFfIj+v1OAvkp+XafAzMRyv0WhEiAxLEtndik97jEc7+Co6BWU3bkvUya/RTkStmi0uohKW5cFhGgnlLGjHRJditGuii8lCykQXYrRvovPJ8spE55LllYlWk+WVic4mCysTnUkWViY6nSysHAMtJwsrE51KllQmWkqWVCZaTJZUJpqPUZwiJsNaLh7W0kZOwrN/Kwaw1JnawtVXUuezqfO5xw52vcxg180Mdp3MYHeYGezamcEuzAx2GCTTwQ6DZDrYYZBMBzsMkulgN84MdqPMYHeUGeyGmcFukBns+pnBrhcPdskguRrq1XSQvBLqK+kg+Wyon00HyedC/VzcfpaOGySfmxgkn50YJK9MDJKrE4PkysQguTwxSC5NDJKLE4PkwsQgOT8xSM5NDJLViUFydmKQnJkYJKcnBsnyxCA5FU2Y25Fh1rC2IwOtYWxHhlrD1o4MtrJp/XCD7fOPHWyfnxxsnzt2sH322MH2yrGD7eqxg+3KsYPt8rGD7dKxg+3isYPtwrGD7fyxg+3csYNt9djBdvbYwXbm2MF2+tjBtmwOto8O4ofHDuKdYwfx7rGDeO/kQXyJuU02YGx8Q47EcOfpJfUCIrwgd+puYJ960VIb5f9wwVl+18HNiL2zb/iFixaTwZBSAR3tLr2pKzhv5rbStv1V2J8j3f7Vh5WrVwKbdCX4RpCrisHSm74XLNV929Dwx5DqpHoPLhk5SAOd1IfBCKNREUfBRRlVCmh/KgfiAk5FrTBBAcGqkmLObqzrv0S8zkRWhlRcnF0T7Vms/t+29QrUJMrEk0CW24P8j/nFm8oNCp96CyQj/AMufpczSHqvZUVx8hwnDVUFCh86EsE7IUIjB+IyFzbVY50PWI1IvnX3DWUR7zVuC1jEe73FLgUubHKtgtiCXFUcqpGriEM1chHJSwHio5j48LQqBFXW1aKSuGAFw5H1hm9fjIvRDvr/2KpXf4zqHXnWJaIUM+vdzdb7lEH0M4V6L6Pep416d9BLDPIGnKNnAsuT9T6Fep+KZ5Og8VGpd9eod4FjhocVg+FhiSllJ6o4NmEfp9pdQcH01lAw3H4d1P7ym2THQ4qCr75mz2HpVeXU0yF45YDVcxbAX4crC+A8A99QRSJ7waH9Zl3PQNlWFXEvXDtEmoHf4AaaoyhkENGkITNWM7i8obxP4Sc0VHRttCyTHYISy6VlTRavon29oirgySvdJBa5lfRnl96UaiI7QvGHSQJkRijahzJym8zhFSkpB3XjKJcHGX4l/k21olYPSG0cer66pHLayRR7mfSVSFPQaO12MPrfrDqJznr/q1UnKVj4z6w6CbTGf27VIZsK+j+w6iTaO6rUIdcDs7BeCixdppIcV+vSJixV5jN7B0f0/lT1xyFgmyVOyAv41R4fR9vBOF9XU/xu9RXFht9IThVbkmRDeWSKvAOoI1CDoC6grkBNgnqAegK1COoD6gsUEjQANBCoTdAQ0FCgQzZ+DuhIoA5BI0AjgboEjQGNBeoRtIe11F6VoT5BDUANgQYENQE1BRoS1ALUEuiIoBBQKNCIoDagtkBjgg4BHQq0R7K9DqCOQA2CuqSEIVCTJYCAegK1COoD6gsUEjQANBCoTdAQ0FCgQ4KOAB0J1CFoBGiE9jTK4wK5E7TO1v2i3C6wg6M8pisnaJ6t+5UEHeYxgDlB42zdn0nQQR6sAQ7ugfjLMcp3s3yH/P08pJ4/sNCorOozioWa9VRZnwWX9dSIJF2eOayTNTG5cY6811NaBi6YOstkw5rxG9Rsg4FHbXkhHePnU+dc6qymztnUaQdsD+YHVj3o5Y1ewf0av9UnHxuAma1XP62KMC3RKmySnT37ktsk5wycDXIuw7lXYOMN9iV3nN8kQ2JL8U94ajHug2WMA+WY3BrTiIxOGJiZvjWfmNvIJ/bu84kVqHxiBSqfWIHKJ1ag8okVqHxsBQquXWZLyif2n/KJ/ad8Yv8pn9h/yif2n/KJ/ad8Yuk+b1i6zxuW7vOGpfu8Yek+H18fxMA3HFlESRsUcNMPE//eWRx4/GeePfVAqH7+OOVExE0Uaw07TygtxBvr4m6kC86DzEXAosq9+HP/85PPF3/rwU5017dpEYLbIKWMOQAHdzYc2nmo4gHF8Ev7uHGHM16dYxqhhE228L5PnrtrOER3oSxRMjLhOQ9U/EurhghAfukW/rSSX1r1p/bLGrfSChGYykF6zFSzd9dACfF+TF8bRpqYerf8KePH8saPKV2Z/LHb+BMmP6b8yn5ZF4UG3bD8MM0tIJdFZ7iFTHPjQQ6zr6CZzXALnOYmmVO5SQsNWJ28+Ffp3/d3IuZ9UhOc1dzqcqpsRqQ7jYXMj8ZqEnSxEJeh8iDk94tg5ycPisnPm9n0uKUWVAYtcEvOZdEit3SPm36Be0qRO1ZOTZmZw4cSX3Umc++U/5ui47y79IDN56Yc2tplO7sGkmODvAbiseVeAxETvwbCpoANgK5W3jcAYvC+ZwB0WfKOAdD9zVcNgAh2bhsAGfS9ZQBkynfXAMiI75YBkJ7KhgGQ4d51AyCFLGUAZKx31QBIIatqAKSQVTQAUsiyDACLb4daqcN7eztb8MoN+XKmWfYsxbKzxa+8kA8lzRpgCVeWUO5ho0S/zzDPifArw1AXU25maoMFYRnGOxGHZZjxRChmZ6oFW1lSMTJqhsVldqZyWGhmZ+qHRWd2popYgGb/3+y9a3Ql2VUmGHEi4t64Lyn0vpLycSIyq+pmZWWW6mGlsmycimxXkW5oyB/MWjmzoCdNJaycm0WvrMKms5mElAcDcpUfooFGVQ1U3JsGy+7GLbANgrax/ALZGCOMpy1MQctujxHGgMCGlg3YU9/e+0Sce5VV5Wbas1i9Wj90z9lx3u+zz97f7uklZqO5PR3FzDS3p6+YpdaDoSqMNbenx5i95vZ0GjPZigupU9PF5eIVuuBdvuJRPWZ7Rm3PiO0Ztj1DtieyPYO2Z8D2NGxP3fbUbE/V9lRsT2h7yranZHsC2+PbHs/y1G4GriLjj3yGJ6n3hHkPSQl2Fcl8uCdGQmXoO2mr/xPENfooc/so81f6KZC26CNt7idt7Sdt7yft7Cft7ift7SexAcke0uJ+0tJ+0vJ+UraftLKftLqftLaftL6fBD6fwzhfTHLpkoWDceuRvk8w2dofP9pHae6j6P4sdGlfyq1ce8nutj7S3n5Stq/8WpE2rWXEAfLZHex6Rj+x9tZABTeC65qDk+pHUhILSgIQmq6yynwJ5uNxkxacUDLWXobtWZ+sTvAhAooTc+2ELX9UZd897l01Zw3CtoFmASGE0h2kbJRMwA0KRTbdAZz1BT6V4GBRpdMNuEkVLleDt3YCZOA9n2AR5FAAKQs+NQBSweMDLoANPDrgAl3AM7msuJxN5nI+dLityIG3QYdgNBywrw61DQrlakmXxMpPRss8QOZfCe7HTpOVP9jISezhdIcGqN6CG8J98qSuZjeT2pMd0k1BpBq0FUi6v4bDgG0QZVVKt+n20jdA954i8UlH154isUm6qYkdK9rFhGN/MZP+RoEZJKEL+0lVYx8Gkv+oNGxleUDAUPM2qnzDMRWWYlpQyK9oOPayCjiX/gBuAZf8nlewHQTXMGWXvKQAs+6ivB5BcNRqv3FATV33blBQYYss3sZmlmDo96iMHGKOsPyTSpeOijCTSteOimSSSpduE501le4cFYkjle4eEfEhJeoN8YhWgFJg+SuVLnM0gPfuMnUM12aONq5VmjF1ElaL2TkF6m2izKbSPaZi51xgZxMr/1ERlFLpJjsPoC9Jeg5X/cWjwmgmibfg2Xm9ypQMpHWIJKl0yyJtuAmsHSzcVpA2IamkoGHBNp0OEuoczsRNHOWBh1QitKMy0Il0qOtduh8scKBxBJqkQFMUaIwC1boZ5vKeokDDCDRCgUYp0BAFqnYzrAS7HGgAgQYpUESBGhSowkbZdhTXnCBX6JJRpaB0jahDXudgNxNNcodtl/vCutACt6tEwYXiEe+DPpSZO0LukPknFEhU/59fLM96+OVsQ1xKmuwmg2aa3U1cS1rs1riMzLC7lVRy081022SdSL4M1nhtwzp/WHu2YWePLvYX2HWelzmPLvaX2XWRFzmPLvbX2HVV7vAe3ewXxblgrvAeX+2Xxb3kysrn8dV+Rdy42q+Ke8XFakIAyId4lmJk5o3yncyl1lof4lOMIhHeIDON5BMcAU7ipqmIModjuGkwdCPVHOdw03IU7BxO4dJ+TDmPMziacN5QLuAETg1Z04dwKj2UBgLufIhCUbm1a5UQaMZkm3zVxRulIvigMnQ0FGn3hkTbcDE04dp0CcifxiYpoyW+YAr5ctSXjJkHdLhgTpHmteVlNNRIAAEcxr4gfWUBgCgJ9kM5h30IBfGhYsAeqoLzUJMR7Axag3T86zZIzfBMZFvGAAUgihmi4DeYQQrYEzNMAXBiBipATMxQBURJPliTEXu4JqP2gE3GeMjSOeewGbjO/zjj1lAuYjCZ5iXKZdwaTSMT5SrujKapiXINN0bT4ERZIMEy0+4+s9NwXzTN7zO7DNfFvBd8Zmzhuph3hs/8J1wX8y4h2grJYXDH/ANnXZZPu3zS8fyjaZfPuiyfdnBsu9icONwOoboqQt0a4HB7BOuqCGIrkuQWFYQjFAFqDXOwZQV5CkXoWaPkWFHY1bK+mU2XX6kci84dZrxg+mnyT8Q/IdtQ2lb8uyW/m/K7gc1t/AXnfmYmv5n6vAhoObu1qEFk8jOgPzcHQfkzbMw5agxC7mehjwvcFDj6iZjIZWoInExFruSayJssuKYZnmtZKRYVa0kJrCWlZC0p5d4lJbSWlErvklK1lpSataTUrSWlYS0pA9aSMmgtKZG9pAz1LCnDPUvKiL0LYmwX+yBGdbGiJBP2mpI0/yGrigXxYpYVC+XFrCu89vStK7z82OsKLz/2usJrj72u8Npjryu89tjrCq899rrCa4+9rvDa07Ou8OLTs67w6tOzrvDq07uu8PLTu67w+tO7rvD6s5zTVvP1J8tpa/n6s5LTIPEF06JulveZz+sJ0dfcjHuvd72inognqY/iqedfvabM6jWZr16BWb1K5shQNuvTpjlHbOXniG1zjtgxC9quLGhm+WqY5UtWtEUlK9oSVjRZvIZMFhmWNFm/eEVbxYrGH9ewplHpFMTPFKH5NZ9/lWN23nOvVFOyUk2alSqQlaokh5SyWY5acm6ZMeeWOTm3zMvSdc5UnJaqhixVsnZdlLXrsgiyXZU601o1bNaqERFB4yoTQ1gE6ZZdkbjLXFNlrGi1PwndxnWYvUvf68GKJsRsULFE9YpHOFo9nZDBDYuFom6CRFcnxurqohnFcApMFORGU5rkEYMpmjxiKaVFHjGRMkOeGW4V9EXnucoxv78cS56x2OIYmKnE73Y0q0meM9ZbfEZJI3rAKwA1tM9wakQv8TpA7e4z7hrRK7waUD8QfYbpVZIapC4gQxcwbtFhDtNzVQBB+2uwLDVYdNkgRciplbuwFupxVr6sGNy5ZVPokvlek9WD+7xsCl8x3+uykvBQKJtKVM13RauKywcQyKvR21ZHesPrr4z3NBp3vacy3k3QMqnMhst2F0KuU4MKixRrSBEgCeXTzLAhNSzdKIqMUHUTaoDZPKzqxaG44AilTCifEEoJ40yKj0etDmFmdOj17TkrsaD6KgGTl6ZHFNtsCLkuDSpeiYqHdAc09RENNARlRDW7kCUqZI0aUsIGhGNK0GlSVDwldgjjo0PQH2YIlfoLXHoaQ3S9p8CwF3vaWzWtTgWeYbO+LSpChYpQpyIM5EOqTIXeYMAcT1oLCEEIrEzHyyC49YgGdM26V4xsr3dkA4Skpp3akqe8G6XrhPETEBK2x0wLl7WdyRK6x5iAvtBDKg5ak8cJAkR2gMgEOEfNilHPitMI2bRDNk3I8ybkokutjpnAutWIo+042sS5YOIs5XHoVE6uFa/Lt0MPDOsidsvEvpiXLY+9mcdeVNTYEBnxugwz4+GZo2icGZPOZZNOlqezlaezlKezwQMNMifM/Ra5rJLsZUpwLGtfaKhGbhu0frSwRLb7HoJavJkM0d6sCD0zJHgbxbrqI1jaxQ9F9FGs7uKHpjqdhsWPzh0i5Kd0R7XjATa+u3sgKbH91BIQiqr4uZIM+vO6BEQiMBabsAtiHo0g9kXyqCGJLiY+BHd8XSYu7bBlPANGo8LHnvu7B0Qij4CJkkDXWIKtSuKc3isTL8+QcgTPUXttDJ9h24KKXfSGmteDD5JRcA9cay4/mcrtqwMBK6EO1bwOQbpxyC7pSI8ZkM1DKGOZamQ+B30VYXlaU5HGrSqCLIqKjHydKrJ72K7IaE9F9g73VWT0H1QRZFFUZPTrVJHl2K5I1FORLO6rSPQPqgiyKCoSfZ0qsp7YFRnqqchG0leRoResCOEV9dcEeRQ1GbJrkr/3esSUlpVxmE7vXiIS/R69e8m3EZ1TFw9aVslz6lJBjQrqckEdKqj8ZAlx2STSdWwsBHZr661EAohrqa5EAppraa9EAqxrKbBEAr5r6bAM4MAZ6TwPo8ti5WHUWaw8jEaLlYdRarHyMHotAzgPWnkY/RYrD6PiYuVhtFysPIyii5WH0XUZwDHNysPovFh5FGovVi6F5ouVT6H8YuVU6L8MsFmLPC8D3tCT2wqIK325rYK42pebQbvvyc3g3dfZEuRPB0rduOc6b5Qsk7KuWA5lTbHsyapieZMVxTImmWK5kmUVC1guy48sKpYZWVAsJ7LnsmzIrkAR7LgMRbDtMizAFgCjGGxgWmADDggAwEFR5T8kevmHxey2FgvdMbcbq/4vuaz6vyiq/wsuq/5fg+Y/AKdI2/8yK/tfZF3/C6zqf541/c9B0R+AUycY4I0wEWYYEqEV0wVMMzBCE9BuEDEkeISQ0RGc+EXMXqFHdU+fxAGcjnR0dwxguQahk1JXU0a4xGSZprybSQhDNi4bY8s0Fa8F83lU3pmkZmCWPf0i3Kfvx2X6Pn4AuBe36HvoCj2D+/PdumZwnT1AC3X17Qh9G4c+itBHKHSC0LEJDa07jdCHEfoQhz6I0Aco9DRCT5nQ0JmbRGi61k9w6HGEHqPQowg9YkJraCsh9BBCy8PFIEIPUGhggdK9wRgQYkUBOp3Vfsd1vRvaiV5KSiu81GJtc2l9dbBW+OletU0LbuLJ45ifZvW2PIuRecdG27D/4d0dIO+ueJcj8q6L/cz1IfIueezdGSbvtniXRsm76rN3bYy8CwF7t8fJuxlYx8yqiP0OkfDrz3nKvzFmTv1jsBGKl3YqHUubLgPvjtiOULCkUV1lFiWUKjGq68TLjBvE3oQ2JUb1IDFBoT+JUT1ErFJoTGJUjxBPFTqSGNVjxHyFViRG9QTLsTZZcHaSmLjxFB224+nUIT0YJ7dTSqiJxPGi0/g0PTyH9O6L+ABqQHJ4OEbqeC/O6FMLz8TInl6HURwcV1A6nL9QWD3M7B6UH/umJ5xpqh7YPagtnohReUbKpebA0y81D/hG1F6E58pNSDICctHgIcAcKIE+N6o0lm4SMf1qK3k3+WnwSFyiCW3q/Y+0pwLqqaDoqeB/nJ6yO8d0G/fUu3w1wHp9m9NiyTiaT+pkKSgslJ9I1WvVfSRRRIcCjWonjXTFpSPclegn3ThMXe1dofNkWXt0THXb8QDk9x9Fr0HnqZybEiRLgmOPAPKTVYkgcvUUujVWGve2UJMxQodw//mENQAVJS8dZZ1DSkOJ9aOkpCND8QtdsVJxQg1FiapkYlRNDN+2G1w1MViJyegksVFCUWmydNGpcMmQblhwoS/p9oghDT19M47QKj7VrZZ6jybV56hBiaXAHCpqrKSvdJUL4aXDV1L1TbeIC7hY38T1cTjtSc0Hm6OP0uyLpVLfqm+vIhwPBla3wFTfnIZGQr32H0rq+PXghpwqJuVUMSWnimk5VRyQU8VBPlUc4lPFYT5VaD5VxHyqSPhUcYRPFUf5VHEbnypu51PFHXyqaPGp4hifKu7kU8VxPlXcxaeKE7RNzGCU3YPN714xdDHZJS39KVIZ0NNd0tI/AOlxTx/skpb+oS6p5x/ukl6+7pJCftwlTfwEEuCePtIlTfyjXVLBv61Luve3d0np/o4uadu3uqRmf6xL+vV3dkmx/niXNOrv6pIq/Ylu3ExdghbAtedufU87N46tXX03r0EnBZwR5rE8fVLAGaGAQT4CZyzpMvsInLEMxgZ8BM4YgmMLH8AZK7jUwQNwxqqusQfgjDVY1oUH4Ix1GNSFB+CMDRjugAfgjAMwnwsPwBkHYTUXHoAzRnqIPQBnHNLD7AE447AeYQ/AGcloCjwAZxzVY+wBOOOYHmcPwBnH9QR7AM44oZvsAThjU9+N8Xl3/qBybzs5CRzWzNUnoaGwjN8S3RVOQlVhEb8h3TJOQsTvmj4JecSr+iTEFC/rk5qe5k5qkgU4Cb2N8/qkHsQ96aSOcIM6qYdwXjqph3HrOqlHcNo6qUdxRDupx3CuO6nHcRg8CU3TUJ/UTcyrGZR0RpbbP4NQ6LgBmC8dxcW8RceC6JtZirWiPdLfFTHXMrzNU0YONoQ3OmUEZavwkv1ZBy7nlJFzZYsvrXb0cggUl8jiDLSpYp/GjAIkMUu0YkWgG26Vlj5SoOow4ysUP9u5KDNif8mYuKjQ9Z9UquDHqi8q3mXs+VWuWdne9muy7ddl22/Itj8g2/4gb/sRb/tDvO0P87Y/wtv+KG/7Y7ztj/O2P8HbfpO3/Une9qd425/mbf8Ab/sHeds/xNv+YRiop5nnskm+xGuTefpAjOolFVE8JzHarDDkjpM+dVxxRsDB36OxqimXCKd/j+6SVAZNGzmVqgW7nx5NDE2FnsM9wCOQRarSOT4hUC3PdzVVGvZjqBHIfoxHj8zURFcpYWo0yKpwW5KlHV4LcEfw+N24zh0ANC7PWI7Jsk6iWa+w0taa5bNh6F6HMrnKuJeRdiRzkQvAbmNdMA6NDUE+YpQEEHzXc90bYM+SQTmX+eWOWJVz2CTJedZfJFRzGCO5wP6LpJfTYVYDcasdNkBymf1XSbOnw0wGerd02OjINdEwdVk7qCOshfwhjGyNLAppyWU9o46wFZir7oiNkWUhZS5rLHWEm0CXaZDItsiKkFZdfh/vCCeBruD8NN4RPgI/hDliT2RdSPymRbZENoS0SSSyI7IppC0ikQ2RLSFtE4nsh2wLaYdIZDtkR0i7RCK7IbtC2iMS2QzZE9ICPfGQvZAFJe1FJLIVsiikJSKRnZAlIS0TiWyELKt9PW53ts1iIkB0i7+EzraZS+hsm7OEzrbZSuhsm51Efd3LTKK+7mUlUV/3MpKor3vZSNTXvfwj6ute7hH1dS/viPq6l3NEfW3zjaSvud8z6XHqa+73THqc+pr7PZMep77mfs+kx6mvud8z6XHqa+73THqc+pr7PZMep77mfs+kx6mvud8z6XHqa+73THqc+pr7newk1j7acO++zgvwiBE44sW3xUu4FjVQXorpGIw1OOAVucQnt5BPbhU+uVX5jFfjM16dz3hsX4t5ajBYjjcl5pjBbjkse/G20ITAOIubYwtNnXTVE+nQYT3eScZZTmpMlzuQcIGAga2mNahH9VAnGaVX07Fu9pQIwTRs9TOAzeiafIZoTtVWbKOvoXyFqMCgrWpGEtwDgLZ5SuRo6rYWG32uyWcS8anYCnL0OZTP53tyZhTJgHEgYdcsKRS/uskQHl8b+F7vktg3wDD1cDeZzCwlzxglKFTEMmh2Ik4FcSAvl5QQZ6JjxUnIrm7JyiuwdLy6id/RQ2wZWA/iEjyAa3SWHMiSI9RCG15vNWDpJznYSY7SC3tyyC7fbVQ+CDvdrUv42uzoA1lyOxVhQvvPVhL73TT6aAT7HGV1OEvuoKyW+7Ka7NgGKLKkxcn7mQ46+nCWHKN0m9q363snJUXy9FWUpaObGQpxHJEPWm2H5+9E21EPUnoB8g0yXUU5KyhnyOUcyZIpSnyNE/f1BFXocJZMI/FJSLHNoGwjWXIXpaX1ITuDQxR9kaMHKJufIfAQok9YZQvsWFqK1bSJJygpbDvoXV16qpvcgx55qpvca7fZyS6V1AcwC0rqI6t8NCyQnQs9mWV6pJOUuln2lMiUIMMZKlyAFJqFmuJCNxnWw1mmD3QAttrQ9+ijdo6TnMpFSqRsxSpDxwKl6ADntarv7Y03gbSa+m7qrSYnAtm/CrBb62R7YFDzmNz0iE74rWyNmgdQxvQW6MeIzqOBVDAqDBl7kOjcketMp/F4F9G5h5aYPgS6Jjo3N7Z0PQj8M0JZr2tpsWWmB6APgy5tcJnIZZAnQJZakWo2alWjWg1IrbY8ot8G+u3GgvZTIphC+Lc1qtWA1Iq0T0LUqka1GpBabTB9GnS27M21Wmb6EOia6FwrnEosjVKsA+NsAbKTGXWqAcad9RFXKk0CibWedXccXSjRFjlagGjDjHNL0SA9GfasxwRCK7EuUKQyIk0wLC1FAvNv9LQX1d6tlHcjMCzmmR7Bkky9gGDJinoBwZJ5I3Sxql5AsCQXQblmpDPW1AvIleSyKAu5RMdqLtGxrmy5kqJOrX1SKYUky1oee8ct5EFuLQWSsRTIV31VvqGuMwnAI6SADlZf7LM5dQsAEgysxNM+tHPJahM0+pjTSCyQmq3Yp5V2DGpR7SaMOVVFvsVtx2UFfiOBK5FZY2aLyR0XkmlgPyaFJfaqedZVyHvsoYZD3MvUfZQzMqBHogqKkWaZcSfUI47vtWOHOHMPEXKSFdU08XNERW0ICa0/J++WwR0pKbPnyuxIR2PHGNfSTpFWmQ5RRZMQ7zVU8yQGQHgYjHFWpdYmjd3QgtuyQNe6HTR0KXW5elXiBZI+rB3BsXiuHQqinjcIUBcA6JCOSnWkJHm/3yy2aGsMTLMNNLcNjl3qXokd7TUcw5xlcP7a28GT9P8x8yTvTtUr43vA7YOa5z9anuSM8CRn+niSM/+TJ3lrnqRw+nxZEg3v9h8pX1I4qMyXfK/nejf4AQylhryPRy8pCW8y3QJ+iqzFh0IK5WXdxxbHpEgexH3sZUxqyqu3j72KSVqetn1sQExiCRcizQiJJVyINCcklnAh0ryQWMKFSOeExBIuRDovJOY8EOmCkJj5QKSLQmL+A5EuC4lZEES6KiTmQhDpmpCYEUEkcB/kqY55EURdNFTDjiDqkqEajgRRlw3VMCWImhmq4Uv0vLl+0VclfsnTVxLvqKPVCcfB+/hDcA2l3kOPxgGZuHPTtU85j7TT9QW3jTDl1LuShOlX3UdTRdCBD2I3BATPCecNnw4aDr1dOS218OlAu9/YoF1149M5WMf8pdjPzW+Itq9zwnndp4MBz3EVxHXzuAEKEzX8elBQH9L+ow2v7luUBqTFqEDf6s+bcqgaR1Z1z7jwQPa9DRd4+sGDpO7eUnufChI/naMtnWpcSv2HGtQeI5CEexC8SjRGDQm/8dMB3qePeyFM5VUQHIJp5TS4QgX4e/ebGk7O+I2rECT3r+cEwd/60pmX/fZH8PfFM5T6NDORujcDXa2R7blKTVestt9ccImlTJylTwfCJwK/5dNBVgAaWNAA85emOw+TiT91zB045Y6TS4WnVMQu55QikKnUbc+iEchNABvp2ibsjs4qHCPeBbd3TPmnyPsB8dbZ+xHxjrL34+S92z3wYpcwTeCtkDQezqBHndrnlFu+3ou6dMm/zlyilx0mRLIj8zcTYSVZFOEtWhSPmVIWxWfOlUUJmL1lUUrMA7MoBevB4kJcmoYFVqCSATaM4MOAkxVcmmajk5emacHzLk0D11OrS9MJzTZ0Yyl3tuB6qpu41q2SerBEShrazci72utd6/Wu93o3er2bhdegZx2Yvxlot1b7r1MquDGGGb5d5scjYrL6DNuAYQUhTZnUIR8E+dHGY7CxlvJ7Kah6kK4eFpQKYE9iZYEY50qZHp90kK7J53IOQJiu5h/X939cK7cTTnijSJg+EnjqBxbcdks5OIWG2CtdANZtu2b2huZi43EMJcEcE4zgUgjbcO1DwbMTySEMwBK0l4Gc8uGgnWaEIcgSrhTUtE+6crgdna6J1FwFuCMub3FxTZeYJwu7uHJTAtxcjW47Jc4gUbNqC+OoyhB9XVqGS1rNqo+XKdB6uT2rNsk9qz7CtC3QNmAAeKPcToKcNx6gP/IbYpelQ/N7YJdFQ/NLXpflQnN1gC7Lgxr/DKs65f65LkuCGv98l8VAjf9cl2VAjf98lxnzxn+hy4x547/YZca88V/uMmPe+K92mTFv/Ne6zJg3/gU0FvHlDWURlEWbsgTKkk1ZBmXZpphGLygroKzYlFW3Kxx5Q1kDZc2mrIOyblM2QNmgbrlVB23i86YdYQuULZuyDcq2TdkBZcem7IKya1P2QNmzKQu4YxNTPm8s1RWefN5YoCzZlGVQlm1KBkpmU1ZAWbEpq6Cs2pQ1UNZsyjoo6zaFuAAbNmUTlE2bsgXKlk3ZBmXbpuyAsmNTdkHZtSl7oOzZlAVooix4dvuAsug9V+ct4fOSHWEZlGWbkoGS2ZQVUFZsyiooqzaFlGLWbMo6KOs2ZQOUDZuyCcqmTdkCZcumbIOybVN2QNmxKbug7NqUPVD2bMqCj8by7cYCZdGmLIGyZFOWQVm2KRkomU1ZAWXFpqyCsmpT1kBZsynroKzblA1QNvz+zgtMY+HzJiIYyhYoWzZlG5Rtm7IDyo5N2QVl16bsgbJnUxYCNFZgURZBWbQpS6As2ZRlUJZtSgZKZlNWQFmxKaugrNqUNVDWbMo6KOs2ZQOUDZuyCcqmTdkCZcumbIOybVN2QNmxKbug7NqUPVD2bMpCCe1TstsHlEWbsgTKkk1ZBmW5RCqJSYWhbpOxLp2mCQM3GQc7o8LguMkEmBoVRs1NmmBtkOdaMgn+BrmvJlNgcpD7cjINTge5LyYHwO4g94XkIHge5D6fjHbjEYh56lGSQOSTQZBu4tjkE0KQq0cECMIcZbaIOtxH3SbqUB91h6hRH3WXqIN91D2iDvRRF0jqotFHXSRqvY+6RNRaH3WZpQVB9QvJR5Gj9otKMzcnrhDmfUmP4uBVp8Wywxzmkj5I1/wODkKAkj1AV/wONArxGDRN1/sO9H+bAK6iq30HaAYajz10re9AybalS3g+O+7NdIBiMKNLeKU77s11oNQ3p0t6nK7yHej0zeuSHqNrfAcqgudQrCjxSd24qJBP6sVJlQpI/AcfDCNA4vqG/eCDa9SFiQHDfQAmrgcb575hPvjgH3WTASosy86DidRNBqm8xHqAhCT0D6nIxHnwwU7qJkNUamI8+OAp4cXKN3wHp6VGSdQVMsVlHmRgqbgWS8Xr0RwilorXozlELBWvR3OIWCpej+YQsVS8Hs0hYql4PUpDxFLxepSGiKXi9SgNEUvF61EaIpaKZykN9Ujllwh9TnsEVos6u1JnN59YPKV6+o79Rc+xv+g39he9xv6iz9hf9Bj7i/5if9Fb7C/6iv291XmogWO8NTGcGokxbZdxyf23gZq5rm6Ikk9FlHyqouRTEyWfuij5NETJZ0CUfAZFyScSJZ8hUfIZFiWfEVHyGRUlnzFR8umxQ7opyj8bwtJeF5b2mrC0V4WlvSIs7UyUf5ZF+WdJlH8WRflnQZR/rjFf+yrztS8zX/si87UvMF/7PPO1zzFfe5752nPM155hvnaLNX80a/40WfMnYs2fkDV/nPhe4i/ez4o9ekArfT89r91HjGW8693HIAuwNAklnwCyazW4m1D9qcKlE3rrvI/U51nnBaN5FIN0BI+H0JXJskJbhnRlRDfGhfgdZO98KN9QuAmEG0e4MRMOc4jm1GGEO8ThDiLcAYSbNuEw/W5HuNsQ7iiHO4JwCcLFJhxm7l0Idxzh7uRwxxCuhXB3mHCY9Pci3D0IN8Ph7ka4kwh3woRDG7rt5H6ehLXQSVcHov/Nqd3vujfSMHISN8LhJP38XxHHx039tnaiHwPp418Q0he/4KZ+5Dq1Xyyp4MYgeAqr7pVEHXWA0/ea/wzun9tSC/8ZpmhV6s2qOQD1p3vP4MlqVt1PvsU/gjz9rJoB52RW3aUVbr0tqPoDJHdWLbuFe5ScK2BOReRstWdVnVzLIAI5MGxH305fOFI0RTSiRN8BuM1nXEGldNO9P3TbuazQ9jMuz8PdP3QJSNBNdzlsUsjtABn9yq+87O/e8pcf+2ffef5MtxDnzHlGu2feZDGNHp4miYJyl5DWhdycNxFPrucsmqPzWRf2atOFP6JcdaOTDHUFS7ECpEZdgSyDQL7UgAKpa51kpMu6BoS6D/BEXPSTMHoTdGHC6CegIqNozUxG8bGZEHB9mNQL/YKwkzS6SdRNxogFrYhpkeCcFD27lxHXW+lBPUCylAoLrm50kwHsc3VidbCIpNJjepTkL5HCIHG4ASVR041n0+syzxqECmSLcPlXVIuoSytpPkhkdMh4kM6fKZwtevlsthN3Vq0gRXdWvYnHyRLGQebmo+On3WLMYChhoET/XBd8vd0zutwhsQ8hvHS+29OteqhrEO6HuywtUdYjXZYdKUtz02/YZUEu8kRdEb0iX5P5FAoIyEed2g95hD4tdxXFbDVXhBxp/vikuMjAVMzLIfgMZtPwFCb2Jwm9cThdhJsrwoUcLirCtYpw80W4iMOxLEKRry7ynevyklXkGxb56iJfDqetfMMiX13ky+FaVr5RkW+ryHe+y0t0kW9U5Nsq8uVwc1a+UZFvq8iXw83XPlnyyteDG+4PMr5QYEDe8IzeFR1R0oB6OgcYWX3Jwz4eJ66reV1+MlG69GTi6eBJCNWToYScAXxL40pA1ekx4NCNw5d9lf7+4kZu99LvheHx8hCXGmpKq8L7YKOwzxf7WuEJQ2n1Ctuck0cPHbGHbx4C1aBFDy37LjOJg9xVMq4sy2LYDdP+012oS6le9DSYAEm8d5/9qvlzfujsqwXq+KvOt9HoejLxewMs5AEusPSA9jNwV/13JwNn9eKbk0q6sLD+Ve+KHnhzUn+MgkRLLoJU0kPfl6pHk4b2TOBqevj7HotrgD1OkUH50aSqB96MaMTuraXqyoByXK/2suaJl33b38aV+XrhXq8r4/7SGe39vK6YRCq6/tiDDXdKQdwE5SnDsluVneAz11LvlenmnVifiwQ5EROKYi7otq5+66MPNtSUug7AhWIMVOVz5eUNaEJ52r/5ZLTk1mKDclsb8HzHRX89VfeLCmjvZeVvH73v9p/vvCvroFctf16zDP1Mhdy9kwGua9qrYWxnOdqVo9VTWvWaG3h4OlE3BVKcgLNu2rBZN0970WCNYRLDXmBrh6lNXYj0QwLqv32BC4sJHz3fAhcWEz56vgUuLCZ8tG+Ba95ygWvtW+Cat1zgWvsWuOYtF7jWvgVupsh37vkWuJki37nnW+Bminzn9i9wnwtc7wY/5uJUho5S8hPxDw5MEZT0HJzpFPev0g4ftfj09ivUJFDe+90GYXykbnSRCX8OO2lrz7jt6BU8oDafcfPQbx6wQtM9xPr4kSnrY76IWVbmTjjvfMadzsP/3guFT5eeoUerIsozo3Zp176I4ZGu0M/NPNBr6y9YjlW7HD8UvVA5frG/HL8z/kJRfqk/ynL1haK8vT/K5vALRXlHf5R3FgWDzb+7nJHUOUeGLEM6VeMhDSpiDPSi0vABZ4RixmRMbxk29HztnP2vH/vd9//NL/zMr5085UBMzHnAYcD4sB19p7rRk3BgEuYUA5NiLXHTlUMnHOcBx9du+qZDLceZpVI7DzgBoW0iNTutlgqjFUqFHpH/S8UNZayH/KpZh7AQBnakQ1m4WooEEmrYhNPmK9Pmq1LnXFLC+60b/ZybVHCRv/pyn+CgWPotSKv/jDSJfZQ1RO1J7C1Io3Z69dGkFr0xiAOccbGsL1x7jPLTAS4jofZnVb2mfahCw1ibLk1rnxVgST6Omiokq2e6Ev1MMCVMtJaK4kD7qIMPgadZ1USa2r+Seq+aVaM4fdDTBH5ClNfXIbT4FNgjIVm7aCkHZQh4aksLIBje5esEszPanlU+KkPV8mX7oZRd/DhJcCUd/Z6ErKeV0t9+8u2fdZBZibLV/LGSuq9MYFKr+k3T6UcQRFfSz37kyftePm3ifCs4I+noI0klemOQVHUtHX0Ewoo+CRyAU0jqxjUpss/rVI1LTsHqKHJFV9v04DrajkmI8KGG0i7BI5TS0StIED//jan6mvXNyrqCYGVdnVU+rFnRLVcHrCjupqNXcJ9NK1fuchweglBKoiHox65JpqaD2K17teh/dWrpzTHcqW+Zck27/rx2Eb2mw3xUh2ZU0zhw0joqDA5mXCKznGQiFTzAxL+SlBmWqZx6r0oCXcF09fDjJwrj5JtxFsJ1GiG9V+Gc+i2YOLGjXZnSMfENJVXvSuKmzj8l2VVPQ9NTuzTVK9gPfE3ZKUilMZcrKbev4Gav8dhSvpKUWancpXd8VgEM27Gry+iFsoZYEJTgcVfzdeCzoJj3Kqj+I8Xo37h0GLqS4B0fHaTd6N/gAEi1qNDZAfWCTROXJpvCYIRgk3Ml8VL1qgSjAsMQpznIgu7hVPfy6cSFLCdH+VaMmdR7ZfTGIEgdHIYBMehcSapcFqjyl9Nrj0LquEz1pG73XhkHz57cqHlI/8PM4jKqCOVOnK11SUZLbk1Q2qDE6vRKgACwLoSmKSqY34520CLo+7rqGT0hrW+DtWjQqX2P691Q82krerObYFHxZRHyUh8Whnyk4zXcWupHTuJFa4H20q2/ctMAbBpI+EipyBWy2J3KbRwSDkN0kZ7QUJCP3K0GbtxPfJ2ynCBa6nXfgZUR5hr2PPCEDkEPGc0HabF0w2sndQbgpp8W/2j+afJPxD9gaJgEEy/deO8k48k0CTBs03g1ebeMt0XebeOd0VVJi3Otnn368be98Yc/8cc/No+MqulcW1fTZhtGiz7lQCLRSTe3YTozOoz804VtMBSQJ8LOqgMUPPZR64AlZDxi2ZKS7bJiReEdl1WEiXXqiTQwKRcfZK21Q4xnEzMWvoo1IdiAcUqGQ+JE1JVvY13k21nJ7Q5KU8UtSlPFx9jYRnwnQ1vHx1m5+S7WXD7BmmonKSkV382GROIZFu+L72EV6HtZv/k+VpW7n1JS8Yvwu+fGs2yQJD4latVzrDB9mpXxHmA1uxdTiip+CWP2xN/Ahk3il4oO9hlWr55nFb2UVfTOUk1V/E9oeV702rpGrNqKfjFsMbOsPiGhdfUDeOWbgZ7Oabgugu+V6Tm4Af3d1afgXMd7X6Zn4d7Fcx/AmFAwsMD4JlDRZ6G/lkKXY54AifUZYKe8lJBUvgFKHC/RI4YHWtH3I/R9CH0vh74HoRl35W6E/icmNN4GTyL0CYS+i0MfR+g7KfQxhG6Z0E1d0Xcg9O0IfRuHThA6ptAaoQ+b0FpX9CGEPojQBzj0NEJPUugJhG6a0C1jzZT1Jkjmf9F72f85+rZv/NT3v+ZMRjIMRF3voa4Lda+HuifUVd+mrvpM3emh7gg1C2xqFmizlRMyAG2v6ZZCV5dobpOOf/4aXyIBLbzmoOsJ5ibAtYcedBIGs7kIUsRvOmB5GoSaAJcnetlJGAlnnWiaX3eSUUbA2SVii594nh0zPHxpjPEzz7NjJx8ChMnDBZkTKB0C388EC4fz2SAEa540mlNcUXq8GHeE6BMJSs+QAO+YZDKTzGaezIKSZFbzZCJOpinJnJNkruXJrJhktvJkFk0ya3kyTU5GSzIGH2jBzdNZNels5+ksmXTW83Q0p9OSdC5IOotFOmsmnZ08nWWTzkaeTosE2BY94t/nzrBwRoXTJ5vxbjwIGVqMmEo+YmAmvANnlDSEOMrPzd9JaiUVBoIMgLTqCeQCWUQDSHBDCH6bI7gQwaWb79cWsvk1h9Rfc0iYEmQFHRMykJA+Y0VQyIE0eHk8qAcw5QfS0kMUeSAtPZJwdZ8/hVfgvAHEzvTG90Jtp0FgG1sqiXTUwb/vZMr2PsrOPsruPsrePsqC10vhfo10EpxwNhWy5wU7YhyhLYV3ccz+ZBg/KyoZwrMbCqSHddTtdPnDfDKEn1WVjOpRLp6miFEy3u0wxGaXw1xLRvGzppIxPcbl5qDNZKTb0ZTcuQRw66N6CLEo+KqbjNEeo5IJPOihchxNJ5Mm2vlkmjILSKjkQLeD5w4kQVF33GQCvxsqOYi3PkKvpiRaySGTxIXksEli0U00lSIgw2FD3Y6egIJhFw8xqDgFJCe+HUAdtWYClMMBbdrR00Q+zOSxbkePk+b4CH2cpI+H+OM4FNdH9Ag6ZkyP5e5RPZq7oYls3MN6OHdTp4q7DmURQCuPMuLyGAMxj7Pl8QgTvg5FEuhgpqsBUJ6qKdufJgbTWsC/6/K7Jb/b8ruKX4vDuCL0zT76Rp9/J/Dmox/QYboBlRlsHTHtIM14lLYHmIODCBUsuUEoKj5Alh+C+CBZZQhg9w2iUfEhsgMRwPgbxKniw2QqIoDhOIg8xcT40yQcnWZ/5NAL4XD0E24yUvDtRzrJEPZRwNYNR29ye9Toxy3t+GdHbZbEp70MIYcEW2AFnnESklI6JrEnzIfeWCRVhTjDHRKeUuh0MsyxRB6Sw6IntV2fwPMABT6rPk+eWfUZnx/Ggvas2rHc2+xeK7Vn1Uq5cL+J3UsQRM7Yve3jgY3dK6Av416wXMYDG2X8Ov62i3QXrbReY9EXrLRWLPct8qO4t8oPHBNiNBPTREQ2/ZY6J6g6LPRCPGEWYyl4zIHIzZhwugg3V4QLOVxUhGsV4eaLcBGHcwS0x+Sri3wNj7nIt1nkq4t8DY+5yLdZ5KuLfA2Puch3psh3rsjX8JiLfGeKfOeKfA2Puch3psh3rshXeMw8arjP0g2Wo6f39pBkNHw9pSN9GPBDkxCPIACjZIrFdI4AbgGfDuET2QBJjrBEz1E9rQn8aBSHYjJ4lBxlhLm1UpszjabE0EyJpXwwqUss4IN5XGLZHkxdMs8DjKEkFPNvxEFfu0jyvHhKXt92+D65zP4N4888yZKvjZAmMHmueOxGpqviRq5r4ka2616hz5RuenRvxy5oLu4hLu4eX9xDfHDT32poFmNI173oJ910LrqoPb6RFwWDsJQpNBm/JFVyqpOUFMzurb925YLlpDtC22baEGgLn2LaDtOGzaHY16OAK063OA4wopx013gAibLIMc3xFyJaiLBtR9izIyzZESKweHmc0MOBlPu4t/Qdnfw9Zx01Wf5DitbJX282QM1yalO76TMDRUrA/vc4CcD++xwPiP8+P+wA6Nsn+Zz0i9Mc72GomqV7f+aAOy4q4lt/5rQJC40eg9JN4414dBgvs7GZtaGYtcFvKOCPv2HMlMtN3zCsy8ThiB6Gvnq6w/yLp7mo5XTpfcYfkX8t9zfJv537UfInIyl5uuVgSIVgmIUypHweUiGGlI8PPhhyS++b5J4tp8vvE95JSN7MeCPyrr4vZ8NQxDVE1PRp/X05DwbezfflPBh4t4x3jiNuIyIYp082tZ9WilGczkmZ1XOVWXEKWx/Ky7z9oZ4y73yop8y7H7LLnO59KGcduWkXxhcCaw6hORc+nCfnpm/hkSjvVOV00f74hYnej0v2x/ePWB8tcZJ0mUN1ONhP1m8VzNIwSzc/PClPMwj/B6O9eW7beWbTxcdyuvPhSShCEe+xnH6ek1njUeT/ihldux/O2wfevQ9b7fNEVcaSdtM/m2AWHg3ZH8OHbfIQly4Osb6/2U3KDza8Z1uip+fK0nMePT/kJlJ94P+d414LCQs6YtcF7quQTKRqdl3mgRWSidQZ7aavi7Sflouui34g9qMfiNGhK3Va+Y7AyjifwACjmm4z+SipodVj1qD85/EoEt2qxwegdsZBDsIYucQc02G6UxfTv366xs5DsE3+R2a1DdPdulgE9tN1dh7GGiwhhnWY7tXFvrCfbrBTY7GQEEM6TBcaYozYTzc5RIzVRUJM6TBd5BBJqmWS+L2TpJxPEqDlJHqqkyR6SsedZEpP6eTSdDKlx3GIH9dDWnfoOjV+aToZwl2gk0zqYQDbDOthPXlpOhkGV6mTNPWIPkTne928NJ2M4B7SSSb0mD7YoVvUxKXpZEwfxSXgqI70Ebrg6aOXppMIe3QnOaJH9XSHLmdHLk0n2D5GH07CaQo3dinx2DVyKQnYNXwJz25wDV1KKuyaupRUaQr4udJiLi8njlHjiIwjzCUrLLjccFp70zqYxntbZVpXp5kV/7Gq9lOFiWPWgjSj92DegbryOsy7TzddzX0bF7tZJk/IMqn/fNiepE5LLX5H4vvXMTY/6mBO/kqu2+zUOMqrx60o0H8EW59Y9QqselWw6r8exH/JbwczX4+3A3I1RcBEe6lvvSI84Sv3Rg2vCAuuKJXjsBGK5T2RtlKWtBVJMZafTAJIV2GYBw9D0za0PCxGhWcjcZWNC4bzehBfyjjKPt1NgpsEHhHcjEOKF5cACb/4N66IZrBwuZMu5RQWL3fS5ZxicAkquNH5QOZqFIOugitg0EkqOoTWQLmbDAj0QEnXSdcAtJqgHVR1rcOIBmUy3JVUSfkAcf0OwxMM6EZHcBB0TYANAgpeJlnKefKXgODNQAgBGwYXUJlZdU17afY37qx6pXE8AoNZs+oq/wCRwIhRArDAnVXfji8sZHmBnDtwfhs56aXkPN5mHBKhxEkH+En4XZDfa/xzlX8u889FmFQhucdf95R/Xd1IXXrPpFOnr/0OpM7AWiDpO6WVTYj6Cc1+gu4ntPoJM/2Ec70GwyChnpj5unvjYaHNAX9HYsxL7LQEVX8T9KuvgDZ9HvEVBB3kfTcxuqws8GhYeBuuJVH3MKZcOS4RbkEpKafhQ2RQrUwq+Aslcm47/F7OajWuzD+GPWRlGlfmH7k0q9CgJZj9iiZgxRk3nWsnLh1e53QJdl9dQf8twRWd8s6xq3nKOw9XS+lZdQEAQTVdqn0wcNlQyaboLiyL7sK2K7oLLusuXGXVBYc1F+ZYcWFLFBcyUVzYEcWFVVFcuMZ6CyGrLcyz1sK2Yq2FFcVaC7t9WgsLorUQsdLCOdZZ2FGss7CqWGdhT3QW1kVnYVEMljRZaeE8Ky3sKtZaWFOstrCgWG9hw2XFhSWXNRc0ay5cYM2FPcWqC+uKdRcWFSsv0Fsc60/cwxoO97JmxH1aFkFPZLhoHfRZJTrjtTAQReWMRbZLoixMXp2URXuXvDACyOq05J1JKqLfmomhX31vV/v6vm6mA31PF5iCQA0u67sJBvJkN9MVgKyJiWBAtfkEyRYAwk2XCM6trFsU+g4KfXtXLOMCKEj7+jYKfYRCJxQ6ptCaQh/uivAhcIi0D6A3HegDFHqaQk9R6EkK3TQy7x6evXyYRdABvYOV6JUBwtcZwbVlhH4n8vAeMCt9MoIQkI3SEuwe6DJWRIjnUGhaKp3aY04uCWmgq43cI0NXF6KPDF1dGA1l6OrCbihDVxemQ6G0ZlsPhdbaaW+mtlF1DxKmxYIXj9GZQsVkwnUdT8qEYxE3GeGCTd0uqHiKcV75HLuJyUKIrvEBhvqIRxmfFodZGptDjEQL0FLR3iFIWyBlYWIQ8MV5CJRg6JKV+4vxAMHkxoMkPBgTEkYYEysBgKpkcpdNesZkh7cVswnJmE0kxR5EtMCp+CmXATqcXFIassRGHNoTU61uDpMqVjnJwKdRxFa6YXTEFYEmLLCzbNTslQ4NAgDsa7J+GQrek2mJjeaSnUrIZEAcm8xTntNur4FT7LslPcigpwg/yBrgED8ZYKhTUAeMnnoJxj/JdEa3k9SNNj10UrG3E7XSFTxeQIT4ZEmj20mCboEevOBapYUyWyihyKQlLFxiqadi+1RsoBkU5fZv8smjqg/pUMrNgK0U0+ioV/WwDqUCNCHo87DRrwfoaCg1YThXfB4ycABVmB6SKjFyq5JabOaIxFYtQj1KOi4UvCLBuTqw0YoqVi9NJ+HTUAXd6qlOeDMJoUEyCs0oU52KVAfHG0nCaNqP6hFdNvWqSL10QLYQu1CGEbiAUT2ty6aCFakg0Ew5XNnAHDBeTFGVCowsmXh1E29I4nEtQ7QFmuXh6aTyNMymAh/BOgneTGAqNhnVk7pm6lQ3dRqSOkEgTNIyoAGjugldGRNhwEQYNhFGOELZQCDQ+mGVvqYndMMkMGASGDYJjEgCXI0KBrGu6fql6aT2NPRwd3qqUbuZ1NAA47phKjFgKjFsKjEilcA5m5MsG8ADWuyswjX0mI5MSoMmpZJJqWpSCiQlLmUN9nHxiPrw9NNgtNbWAsAFefRUBNErxQdq0krzAP6YhpBz8+y3oXPW+auooJuGVxJ3WsxCA3f6loKzpYc4iHXS6/keyPe55/juy/eZ5/juyffWc3xX8l0/x3dXvuMyAUk1LMTpaNq0TpmXpnElZRhFMkm87BIuH8QMtcuAinWSv4OwoXb5xOkW4XELMRa1A8mKLWonJb58iE1tQJe22Aur2sAnnWFvS+xVz1FLG+PagidKh7CnGXDNTefSdae39FISRSUHf5AEJFniPxBx/5KR9ddlkckPWSAfOz+rAFWNvlPWqQk2rBc9VmjLYMfyCD4iLX9zDtG1e8ZuFjwfK60y7B8klSKhzr+0ixY94Xxofrqn8IFWNaDL1D7nK++Gi6vwfJtuwk5Lrc9D8JZQi+iacJZO5p4c7aVlmjLE6WgvXdHKe2Em74A5aXvDgZsBf2wSmEbQ2ffEWgGbHvC1il6JPreD9Ad4VU3K1nDEdD3dyGjOMnCUsZPYZKJPBijoUmb8C66Yfm/lpHWX9ciLMEos0BdBgF/F9ShCeeg5s6K8tHvJ2HremGcFk+BBEoWGEZToMpEIoU0HRNLB9KwKDRDd+jxJc5JCMUFOuY+0id/5mLGYRIHOkcSmkzrR9+FMFz1mOu2/c5cd9+b/u/QXTa6jTu0LJTe8QUqseKbePNK2Tj7oSKPsk5YIZlYd967l3J0FN2fvLLo5f2fJ5eIrnDG5/Iot+rXYueLyXEf67mlvDjd8FlF2U+/RuJLycdG9knpA5HPT6zCyjK97BCVYbpPif2DMxRLSgXCdAjahXGZ7VRYxuhWx+VhfdC/12XqsD/s3YgqrwqbLOfvnynq9zODAHoHGJiVd4cjOCWfjKEEGqxPOryrG+/uq+yiJL5WBKXuL6gfP0QTpxliboI1LhC/gcYOwads0fIwsD4DsPpaE5ltI39r5N7XvWxHPe4540iwlNEvJbhaaFVKMjbGiKCaay/aqCfXXNAhNxKNYMKghHiTMR7ofnGuIPRifGgLt8a3EgewdAGgEsCzXAM4rtoOLHoGFtX2DoXSrwVC61WCwoj/nYOClwQyIEmGJiJQVCgcw7zYYDzlitGeWCm6D2jNlNcAL/IJ7hVhctFgkIY0DRsMQTD2z5AAuCDAmGC7yNAzb46nDltu+kdrpK6SdSGbxGA4k0gwB80g73SGDT4otDwn6M2/olCwFhmxcLhbX9x026mLVb3ycxrOOOF2V50bZcSKqbXCljTlAMfbDlcV7+6OkoRnCinrdMhkdwmQ0Sfrh3fUl7RzmhA0BJiQ5KjOaDER1uaQl0uNv64hvkgpV+prC9tpXZ4hnXfPtDD2yRojSiBTFrRJC0dW3EOiguhI3UgAHhKR/UtdVqCC4j8YDHMNPBlFt6m2CNIFCfOMbyaKhGMwuk/QEGVRFFBSN5GN7ejbQ0mkWXDh6UqKIAS0xLmWFkl4to8pl06sD/rzpUI4u8OImR7SA6d+ic6sY6VU9mHrfQqnk/SuLGteuznM6xJzGDrzttWNPakkyFO4jbWlMQUg5Lcd3rGqB9T3o/65e4Lv3PN9hkZDawUc7+H0r3K2LtRQY04lixEpm9+eVG9zQvGUgXktte+107xtEj4sCK5nxPrR5uBUCqNvIUrZGlr50oFVSYo8Sk2uAXwUj9tbPKuTS+abbyvfcmXzLnctP1qp4gKUv5/hYregB9jy7LjBqsaIH2IvsuswYxYoeYK9qcyi4VhwKCIdYTgWEPqyOeUvuKcYcVse8ZfcUIw2rY17mnsIBm9wr7imcUMi96tK9rZR43F7SJ7TwXZlV64QuHH1f7QvDavBGRQ7L0C5hpT7WGRg67e2dgQTL/BURH+XHm8V1YFPhiDoirzlCaCajTFgWgobdHhAyIbTEqE+6IoSZZEIQT9fnE0WHxeKiUIjzxSOFc7RwjhXO8cI54c3rYc1q5G22+gmVNJzBgnR7kkVkCFR8SAfpliEAWByETUMAuDgIG4YAgHEQ1g0BIOMgrBkCgMZBWDWEpp4kwoohTIpiAaspgYOEIVWFJOEMjAax8s0Yq+SMs6LOBMZpVdNpt6on+VBZjb6XEG3nmbOZzTOnc3meOZ9L88K5nGeO5sI8cyz3zsRDNbYpuDrPLBfiXIyQ5gPkVCEnBkbwODjDE2ww92mYyaJDvAHteEnqRo8mwQPOb81r3AiK5p+EVo+iV0hGmIZK+vp8EphzGvpe9NPrCfFu8VJBY0S4xa0O3ixoGAlFd/B6QSNNKM0OHjJoMAol6uBNA8NVCGGHXzf2zjALOm6Sedw1F6sRTgghWV/kJQJnBE28510P9SYpJ/BlSMapS1b+SMYJwnQk4UR2/hQhMOphOqb7dOmlYAGFCbqEl+YYtGqYdYjrtJaX+NxRMucORyzuhnqISpXvTmXeTnzeNKn0vpwthtj+4xApmoaPPXcY2akqKW3lDq8GdZQIsWW7Mrnm+xMnZJ9B5HgeiCVp6tAAdWLIYPdKMsBnEJ/Vd3/wUTpkQrkPZ5BQ6uhzhlhIceALe3IjoxhdLndZS/FxCnmu8KoIrzi8j+r6prolWfz8voxd+zDynImhGnQeCXAeGdRBjG1tQDdw8HAfjZmnpR0o8F5h8yhUT6UbepBPlj/IfV4xZxGfC2AgnsFJsnqbOzHMTxncsxJFjI/4chgL+88iUuU6VzkqziIc3diikRyts0hYdHID+3IDyyefRfJ+9niUcu0G+CwS4CxSB9fG49tVha1R8Kwqm81SzIuUCyt8Ph9KyhywxAHLJmCpN6D6WgN6X0tAOa9UcF7J28oRpVIueboUtKXRi9L7hclpOrmwtKuZToZFgZ8Z/mnxj+afJv9E/BPyD9+HqInd/+87X+Fs0iYoS0GxEeJuhI1Q9W+Eqn8jVP0boerfCFX/Rqj6N0LVvxEqeyOUCw0vJh5vhB5vhB5vhB5vhB5vhB5vhJ4Wtg82QuKn/sMaHuayveh7xSboPG8UCe2IeNmdz52L7GT+2lJBXxY6PSIX5BUT3OyaXrqqIJehq8w1epuvghul6wyaGZBEQknYZGT2wafz7gnHafDdmtjEUDJLKr0SFZ5ITu2dEav3tM+zcQ/e+0WHjN88+YvmUwJrkrX46CAagnScIDFwkl2fT+p4VoJIetIAehnAFqoPTxdWD7gYVV15moS75oENWLdMekEm7UnDS5z/hu53Uegq3rIAJ8liISwVtU9mc/c92pvm/a1yM65paigISMiwKQnTsKWaeHQ1SJ6+aURSBrda0uHFH5eJM23Bw+QbXVLtELQULalJHQBwEI6q4DGtt6ZQwalaZh6pflz1vlriuTGp6JpUsfT8VazENVMvkZ23jCnVNjy3ckNEu0qGoW3zVWWx9bAGE/4PqQsCXuD/oKXKXJgsNqvhmvDSLjdJSg73tOgRXDlzzoqfqnPMNLmS0C5Qpl3AJe6JumJtBBVhMqjUa9OWRPkDmSa/n4KbTXdKV1gzq+7DsOHgk77ZrciZf0vyVtBHjvOVPcDKnjPNyg+Kxa+iELcoAsW2l/WyuTOZUEuFtNF3N1y6QX0PX5g+ME+CRB/IG/WfSlRqzH+hSyKZ9Ral/Bu167DZkjduyXSBHIshOmDOwsS2lFMwRAPM+RdyBebkC1kBOfOynMHaPAsa7J2JI7EUtCa2r/dgVgK6u57om+55eL6E4ire4XmxWPTxHolHF58EOqBwSsZFPeqKCp9xPTrjej2t8nM4bj4J0b/UfYjFC8va7X7Xow2XNGt9PEeWM9jooGPn9HfTuCEGZ+mhhgLKMaZwTfu13x9U5Runr7OlCfUg8XGbbMCbmJtazEFUn71QtFjJHUJS6Uw7KXELkRRWmVsIjxxJKE1EYFkszYwrfTxEt/F4mNnrMZ3ptyH4oUj0io79m4qN1YaswDbP+mzXWI1t1WX1tR1gtyoSvYpJ7U3FCUNG0r3iXHyE7/jxUVJvATCBIlmr2ylryEMpksUiEZcm68Kdj48xNyC+kxRhAFCgSNbqLn5kiE9Q3pCLwkUpniLWQ3w3PyfEJB6zAekoRfIu91LeKr6P8lbx/XThYn29i/GL+OUhnqVKA7JAkdTMHOWt4tOUt4ofYGkwMu47w0p+l+MX81tF/BKqPCAMFInavJSKoGK6hi148bx2RazR1QcwJl4MaYaXQHAI+AE1QAlAoOgMHtnnyUJulhwQmZRpRHgRIsxyhFOIMEcRTiPCAxJhmu1aTCH83Qg/w+HvQfh7Kfx9CH+/hJ9iuxiTCH8M4e/k8McR/i4KfwLhT0r4Sbar0UT4Iwh/lMPfhvC3U/g7EL4l4Ztsl2MC4Q8i/CEOfxjhNYWPET6R8BNs1yNCeAJHHubwIwg/SuHHEH5cwldyE+0ErUyHgwmGdCa9L2Z8Tnb5BgFhMLp9THfp7A9JsYwsWw2Cn8wocvzI77LIKNal0itxZVjwr8g9qcp5VhiYE8zcC8Yb0S3qovE2u2AfXTZe3QXz6KrxtrpgHV0z3pkuGEfU3eSf64JvtEhAhTyEJmQ0H5QZdYgtSR+WYap5ksYyY2gWLno84UkGTIl0Ik3pozI+b+NZervMGJqNSx6vD0syK5dcnpYRT8tNxdPyPM/KTZmVyx4vJ8syO5ddnp1Nnp1biqfnBZ6dWzI7M48Xn0xmaebyLNU8SbdVzyzdllm64vFStaJ4tq64PFtbPFl3MFlpeh6QNYqm6arHC9uq4um6KtN1hmfrrszWq/G8rFEpxoG8FVOnrAlOeVLlFUVepGu8tgm2Z527L8vk5bnB6weDnicDvJLJ2zYtJtcK3M4Mo3pcZLoqgDyo6pfAEuw3AHn6pZRoQ5+BneoU8NHzfVGLITSKqKcQdQ5RT0vUBxD1xYh6oC9qPhhHyDoxYt6HmPdLzGnEnEXMF/XFzEf1MGKeQMyTiDklMe9GzHsQc6YvZj49hhCzxXZy2XoxxbwTMe9CzON9MfN5FpF9ZsQ8gphHJeZtXTIgrAf17X0x8wk7gZgHEfMQYh6WmBoxE8SM+2Ji5tdIiK3aJYGjrGAm0iI10iVmYkbcRGImyvpS+4uyUjfc6yL0kChCqXJyNp1ATKoc/paFdQVqVuVQvRmL6QocpMohaFk+txD6zeFykb1haJtXGSVojpzhOSvD80WGF+wMLxYZXrYyvFpkeM3O0DDMrQwX3CLHRdfKkqUMOM9l1840c4tcV1wr21W3yHfN7c94qTfjdSvjDTvjTSvjrZ6Mt62Md+yMd62M9/ZlvNxXY2XVWNk1VlaNVU+NlVVjZddYWTVW/RlnfTW2Mt6wM960Mt7qyXjbynjHznjXynivL2PalKw6enYdPauOXk8dPauOnl1HS2Z9zcuzojc/XBMSN1YkpaLdnAVgD26Vy1k79hBUubi1Yw8QlUtdO3b3qVz42rEbV+Uy2GITI50B+JoUjHZhv8ZYpI72SRL8z32lboTXWXbMwdJq9CsW3FzBYtHNNSyW3FzFYtnNdSwyN1ey4CkwB5xCwjgmu1glGDzEo1fqvNhdU4R+F5hrcolEMiC44MDm9OaRNr/JhsQNKxspdbKPxwLqfD5i4XQis1w6Sb4ZoXSiszw6B2dZdCLP5TsfSTXKpZLxC3F9NjUg4wxVVl2osd5DnZUmGnzGHmB1jUFW9YiKOlWkVmLw16rMXLcjlnpRJjLjXGNPq9sRS72oRLcjlnpRvW5HLPWi2t2OWOpFe3Q7Yqm3zEaho97aFC0Pk7gr+K1Jd9WlBxvSqQPSz4PS9REPhkgaf9C0/IA0eyNv87o0eM20dlWaulKcMHgg1GordTXAr5pgmdSPOiy9SCMvKEZeUIy8oBh5QTHygmLkBcXIC0SibBVOklBKnW+0VY8eS0oPOL+qdImY/4RmiCs4BHzAgoJ0T40YewBC9J6GvTtisj/gYNRCmJ9uO6uqkFaRHg+InZ0AKUGXrFFcpo4vFZtnydo8S8XmWbI3z1KxeZaszbNUbJ4le/OkUQyFqeKJn9iTOoj+JUMCMdI5wfbwCyLj79A7IoPM8WsiPMtu0sRJBUhFbjJJWinAJnKhYtsVsKBpKK5kGTC70QbgQQVGDoy4ZSTzVaWv3svp3YmuCCTxBckRlxtepIxIbLecNh+jCUMvnSXoWPf5w15/4fEyKgwZ6ohdI9rUKIR5qIdcnpFrronEwmiIwebPjTBUoD1at8DGOpBjvXUfTlwaCGRBsw5VVrzVYNBwKxCziOTihlI3HhARLjP5RZqY1/8x5k1H6ABa4ieEia3R9LSMT3KQGTQ6etq0OC+Xg1SAdjys5vUQyjOABo9SRu0Nexp9AI0+IqIqDSmSETkDH4hGLgTFagynhZ4Bi1TskuoSJMv4Ww813EeVXsG6w4S+nmmgZxp6RB7BuGc4/7xUVCyG9Sq1+cJidxXkcZKqjjiJYe3owXy+ed3EY7m3QQiueIViqyyL/kOEKea24wEeyfE0D+54igd8PMlzIG7yxIgneK7E4zx/YsK6uhYrNm/E48Ceah7Mz/BUg9NMNUNeErKZaoaeWcFXCvKqCf5CU43eb2893ar2dEsdeiTtn3JiACGfcrk/7PUXnr6OddCxjplA4f4pJ5H2TbmwZ8rVdF0Ysm9VymNb3AueWNURVjlJFq1Mts2DgsghE/LIniJwKjfnq+56pFGlmKVKekyKuaqkCaSYrUpKMyzO7pNqiWLeKqmEKGavkkVNvDuuQj42XVdt4tf6wm91jXyyb+VPYftDvapmlRHfZH+6erqbBHyONgaWaRUi48TRFSONZb0XqHTBQ1st+6p6o3JdsFUHBS01EiDUIcE2HRa40hFBbB0VDNYxRlWFdr5sZoNkfUyOLwPEp8YK5vPxBQcOsvg2QweOIfbg+DKkh9mD4wseL8mD4wseLsmD4wseLcmD4wseLMmD48u44TkLUrCH4wi9B0SnWYJq6DRLVQ2LTfcRsfg+KhJZYyKlNX7au8Y21DeOYqYoWp4hmwwBUpL1IKkKkgkgGZBCOKIMsQBsUng0rxnBlKTCz1QBVp+qeZinl4R8La3ysxW/+wPkMHwM4UVMMeRFrdq2BAhIGqIG0YCa2a/qbB6EJUsoZ5GM7MkPb5G8TopsAA4AcdnIgXAD1v4yVIM3GjSLWO5HO7xvbdO+JdcUNozkJMMZy42N9CAIACKPNUyGzSFw5Ca4PwAHiPDgB/mfiDn9FAieAXpL1iMsaI8HgkEK12wnUR6u2U6GesIVWqWsYIsHhFKhWiq3nZk2awDzmV6Ic23WA+bTvRDnr0AbOBW5I/6VTxsO+gsq08RfECqMWNJZ/zxxGoQKI5Z09L9ATAehwogl3QQuEveBgQfOijgjKqkHqXE7yfBTpxm4FVgqAYOumGdwDGW8cY4BimT4tCcW3yQAhgJiRxRinEK0hAZ5x216cWX8KhaPXadVYjhHQfg7SPnu0igibFqCPthz+XdTfjfcAvhgxXK/id3GqhTcqy6blYLbmJXyyKzUv2JmEUGqsflJrUUqBm/kHRY5NNbTj3sXOixiGPLIBu5tB7x4TJ2KUC53EpKqkykHWNkO3gNgAKwmlGudZJrRF+tCWXA7OKc7UAYU0qLbSQ729BBGHsBbRqlzBhj0Ju+VUe6VQ+gVEnwgfvRo0Ssj0iujhCvJvTLyFOM/0WwaYTntEbsn/n/pg2HuAG7+MW57bvkJbnZu9Ca3OLf3JDc2N/UUtzO38jQ3MTfwAWldbtuD0rC0/njpAslSLLKW1z7jNwQ3y4gXbks1yRBOlwAWRI+NtK759BuKb6bbaw9H4jsUwoqle2LNdXut4xSxop5YrZ5Y891eWzlFLNHw6imh7ilhYTmnv4TNnhLqnhIWdnT6S9jsKaHuKWFhVae/hDM9JZzrKWFhY6e/hDM9JZzrKWFhcae/hDM9JZzrKaGxv/MVdQsjSGQKyAE25f808PZ1NvD2C67rXWcIe59B6QNGwcddy+X9luXvQ3aFpwjpQREQSpPBa1r8M8M/c/xzjn/O888F2mhz1enW/E2YH4cGeEDqzUmJWRRkT4TACRI/EwOCkA2kz7r2CaUq19UPahEYgNR6HJJ4e1wnkfW4QoLqcZVE3CFdoV1RHwCKC/hwxwj11sFlAqlHXKFBqSEQijwLgKGTlASZo2RBy5a0Ar6RskhlMcSMNbSUQcf3HNwMfDFgYEZ6EslwE73ARZnjBlK6xCcHXdKqg/dZR/vU1tfYFRJyEFwMHgTm3DrEWargRMEMJp2GHWHmOWDikRJvSKdh+r4kfiATgdm34Nbe1nSDG+nuG9QJx3nQnz/ipFl0JXGOOuniV1yWdFz6ikuGYdJlONK9avRTbuynq69V/H3ltT1Yw066Zr6sG8emcWz0h90yX7aNY+sN4tjpD7udf3mDsm1ZUFnTdx1Ih6OfDnjYLcvvEn5/5h0/9gdf+Nvf+9yZUwDkd85+6oM/+bntdyx//D03TuHe5Zx99drb//KDP/z+1WdzWYB/6682P/j5j/7Fr5w5Bev1TrpwB7X6Ltx7t5N7B+5ddm/DvcPuLVLwYfcm3Fvs3qBHgABgqUtBu1C4/37nib/78qdGCGYThmTTDb8dXefCr/v8uya/q/j9wF+89u3v/sWVXwb6M/xv2fyDn/qT5U9+FJXJQPjrxz//G3uf+fN3gLCMXFe59EtUAnYvwp2xewHuZXbvQe1sSWoL9yK7d+DeJajXVb9tTPu952X/8fd+5o6ffftn8ICxTKXf8fLSb3vaOft7//a1P/Tqf/eGz6EwWx5/2MTv69a+tPXZjfdu4cMGCJ/45J++5k+e+pGPnTkFawzO2Y//7Mfe+wfvfOKjZ07hLcVJt7kkq3BvsXuFLJawO4N7g93LcK9LreFek1qTOyTAWi+vxZmX/aftH/hfTn68gj5Yg+EWwmWXWixIofeUdmTM/eYnz5zCfd85+9lf+p3XfP6nfxRl3IH/7//2Y7vv/ezb/vDMKfAJnLNv+eyP/NK/vvnR/5tqD3TUpRYPDLgX2b0B9wK71+He48Kuwb0rlYZ7RypN4aso5q6yKvGlT973TeoddVRiS+HrisorkaEwX/77t/yX3/rzN33+zCm82RWVQeGWQNj77Z9/+j+u/+nv0rQA4Rf+7icWXvc770WXLMD/wT/+/R9e/OTPfgAB9sDWWedi78K9xu4duFfZvU3vS+zegjuT6sO9LNUn5N4azQtljayf/anHX/+vfuYLGFl7Ls0Lt5gXAqi2Jr9Y9s6+9+m3vv/v3/3p96FwWP/O/twPv/XjX/53v/YbNDFA+Opnln99+W9/6RNnSBHLSXe5BFgU0x12Y2FMt9kN2LZ0i93XMGTYeRVlaZlVOF1q0KRwrZ545/v/9x9/0Vu/TJOCir7j5EW/mO+KZ3/tx39xafX/6fzBGd4r3/Cl9Y0PvuPTnzjDO+jv//Lv7a397ifXUPp5q3pnaJ9Ns2NUAijFL7OzhcKwE3fjxWOC0eukC8cEn9dJ91pmS0+3Btp8pS0K/pnOX/yL73rtH5+hCzMxA6LrxOHYcB+B8GZbljC3UM1z05WvQFKUdip4M/GG7F0lLyzpCQC2m+4RiZTrEGLhqxzhMkdYFO9V9i6J9xp7l8kLLqBJjzTlPBa/TZfNHrKUbzxvUGefevtnYXvt47SHbPQT1vsJawXhGSKs9hNW+glZP2H5Ders2rt/4pmfffxtv0OEpX7CYj9hob8ce6/vI+z2E3b6CduvV2c/f/NTf/27u1/e5N21n7DZT9h4fV/R1/sJa/2E1X7CyuvVWfZ/5Pe5PfoJy/2EpSKNz3B79BMW+gl7r+sj7L7OnA82f3OdzwX7KNv7KFv7KJv7KBv7KOv7KGs5ZeEnmLK6j7Kyj5LllN23MmV5H2VpH2VxH2WhSPkppuw90U/ZLSg/Je2TU9alPNtFmH8t7VNQ3ijtsy+djSfUWRpDK2v/l7TPPsraPsrqE+qsjIEFaZ99lGwfZXkfZekJdfbdv/yfvvyr7/ytH5L2eUKd/eFP/Ob7/vTmq39U2mdfmL3H1dkP/+gTn3vqt/8rHTqcdPfx/jA7j6uzP/KXW2975vWv/wpPqH1BtiwKHT03H89n1Aanu9EfZP1xdfa1P/e3P/Lrn3rTa4iw1h9i1cqYE1npD5I9rs4uf3Kp+873bHyR51RB+DueU4/Lorf4uDr7sfd/5Eu/+R9++dUUd8F82XttkYg0glkps9eqs7QhPfH7f8i2i9Msah91cDcAfIVTwym7NumkP/4V19h5BEmwbGufgrhIHezkzTKzkz223qmiBZeZXBtlkt7PamRt4wNl4lEtltqJmlUAE4FOybvwq2bVGn/dhF2LVcv979m9XGabGHCvldkmBnG/xCaGl2ZlNmbvsbmBJju3SgLOeNzbLgmq43FvpyT3tOPebim/k+FZqMSXMnC25GYHtlaZL2h4MymfZsYvDP/hTaUUkxbOWimuyBtLjcKV4jq9vZTiBtmSKsUD8vYyyCmxdMwiDFKDDjPr6RI9nUIp7ri3SpRlppB+z0apK9KAuMjWGKsO0I66KsLFNYZrHGQEshBYQQT0mGWANHNY8Yb7yU+bDGsVxWXmMjN3hWVdVtw4EDjSEunkwFydYqxRCBUuAnmqRO8rSgeQ2MALeY3Uj7qEDQj1HLxGXNWAe6gAmirSZUCidSBBCUEgwMfpKvwXe9VqvHQTiNC1vwyUd+MgDTHBS7YVxXSuUpbOXxFGrlEgs+6RYaFyZlFbfaBohfH4ocI5WjibpHUYWAZ1qmxQp8YGder0TMNmZT7gytBmpmzYnlXrhXPNTA4mbYKtu2q5/z27l92C9bvmFqzfVcP6TTMXA95jLmzSYL08YsKCQTHPniU3GSTMAxYtJguLB9kaYshWGg/xk1+FDRceRkea575y9Cb0vweYZfBLyujaw91Ooln7r6ypsw91OzDbA6b3AXTqQV3qdpKEdQLLMHlSgj4KRN8Z5PkQKGE3AyIa2OYHEevAs6M1A4JaSI+MTTKZ0jjNcE6TUMHvMoJgndX28BYACP0pKOLj0yg+jRglAeDsT+sm5F4nIIo/DlF81jeAYu4gcVF8MGyIixKkGw7lOECol5TzAn71adwFfZgeojffhN6BfbBXtvEb0nuxj8mwqTjhJU8PxkNax5GuxMN6IB7RMYD34zHdiMd1Ek/oEmQK6HmzGPL01P1Lh1V04zYM+e3xK0n5KIR5liOzrJL9yOYjSY2pJMgXsaT7GsQWyunuQFvX2ize7STTLHyaHBSR1OQQ4+se7hKQa01Poi+m9HSXgF5r+jAkTA7qSX6S5PdDKWE5bbXjYbJ2QPIshe5bfLBwHiqchy2wgcI5VTinvXldQ3VKVnVWXJF4d1mVZw1iF1yvkgguHuX3l9uABl0mMjA6vQJJoimaDa0MzzwAZTikm/q2bnIsSw4xPMNh3dRHu8ldWXKYJaZWS5yBhvxNclRP01ABo7ipx7vJbXpKhhUIY93kDj2Z8XMUjPrGda5CPIieU1eSgMXZYOE5UbxqVI57V/HstYV1ZMdtJyO6csxbcE+RmA1e5UZBWGQCnNfoTh3QjbiCRx++BcURoLbI5iW9I/ZoPx5x0iWXDX8HUK4c0mw5kF5zaCtusKpTA+zTA/iZjzV+wvh2/Oj4TvzMxcf1EL+YVTBkxrrwNOGBoTl4ZuBpJiSuVE0Xa+2kyk+qUBsb07dj0t2J6XecQjCKfETfmvh2AN+0fIuI+xpiZVx0odcJ3bHKrHoNPI1ZtUDEWXWdvdfwUgj0dvp5BD94mQWQe0iyQ+1ZdYmcu3BehEUMgmqnHL6NEznPP+c4kW+GuhtybVB4fKHMJQkqQMgFCBkA/hrnFH2/DtE71OS7QExJt9w2NX8EUcbA7vhtkh4IuJ8BRxXwGAjZSRdfSI/mvT1Vg8AlrYdo3vh28tJqpdJNRePKYfWWHcX6LQtefILaW+y6idLZrmJFlkUvvoeanBVwtkW7bE+xxsqSF8/qETbOMcqWQALSY2myhTvIOTUxU8a01vejK1/EGCSztMDqLgeJ8Mp/QJ/kvp5BgHtYRUyPcRB9u74TX48j+gmGMEnG6SuMtZOp90BHsJUZoOsj9tXZBztkAXfNlircH2f3umrPqk12Y9f9CDu3QN7AFrehMBoolw+4nOK6/K65RXLvgrsuYxEREWC0SCsqgtbJuaHabGs+xLio40ggL9gkADCmx3ltrUNyQb7QWj1RfJlD65KSRR1Tr6kPmC8bTv5poqBuFtSm1oa6VVDHCuq2nYLuJhMdXuDG9Zg+0E2aegI6ORkHJiF1TrejhYgyaT3Ofo0Rjade2AOqwK7xDg1MEkjmF32lB4QJRbIgAbzELSKRjyq8EXt1Ww/nhtN4IVK8EJHq1glWlzppZDd4MF9gpawZHsPneAhfjGdJRiBuwsJRkO8RE4IvP4ZtjqT7HBjNJAEB3iYmYF14squnYX6SDjq8W0xgEE9jr2yCfjsv/JuebBpj2EcPowf1pL4fwV6ENHhGnDL7yGG24IYwJxFmBmF4Uszx1jIO7Z5DyEPfiWIcR0FPsLhncpozzZRkOgnFn9v1FFnLvFsfhgbRHTiN6Ul9DMqQz37JsuRuQAVNQ7PoKDZ2HWdJjNrAWM5RWGSe7nayJOl2OvIyOo2l+wCFndD36oMc9TBZ2LwLmpKTlO69aKoEiU9yzijIkSw5wimhOlNY4zUy0BP6Pn2I8zvY7egpqE4do6yz5D4U5wgMQjc5LqqJhVSqOQdj2FNk25NqfIjMjd4Lc9Vo8QQtHqPFj3CLZ3lFTsNeNipykOt0mIyF3gdV0zGKeRIxZxDznv+Xt3cBk+uozkWrau/dr909vUfSjFrTslV7S7ZHWDZDAvLjAJrq6GnZWDbCGG7Oh4kJ8e1WEo0QjrgZzYzRWJnwsmIISIJATyvBOmAlguS71iEYDa9EvBIdAgeRcBMFHFACgQmQG10HPFf/WrUfPTMSdnLPtT9N71273rVq1Vqr1iMuyR2/CdaqdQoZSmO4iuKJPh82qbw6EVYnxOqsjkuKOBw1U0zSnA9s7CNpzvEjxVQ4G4TPB73QwwGOQMf02HhJeXOGHwdBk/DjWoQU48d1iD3Gj8+7RJEd58frAYr8eAMipvHjjSYX9ph8WIIjHJBZkukoUkEPotBu2R67ZbEXVtr9cU1MdTYRaxgBYTvQsDkONXEKyXBdZ3o6HCAF9mg1JigCDveJPVyur8HXOmn7RGvw9Trsnz4NGAuv0tdgrdfo62hG1+LDIE6HFaTaerWOACUhKtH9CMDQx0TEOvq8Sl+HSV+NutiwrB+2vn3JARLWdI/J7yLvmecFfB3isIRmnYIJDDTNzolmWCQsEiIc2WATBtJAorA8NTc3Yd5pdDNcpq85Gg7q646Ga3V0NFwHhzrsK097TTILuIoOZiLH44kV2NM5UgOg+SEnzDU7nz5lOS6BK8jTDTZ7jvSaLUfDjiLyu3QPt7AidmQTKVaotQhAWlr4KqaFr2Zj11V238Rfa/z15/grYm30kEctpVce1WsAzauxL0KiwrAJr+MNtq7TxpRfg4/Ph2kjrR7ya8S+6LTb0xQuXek1QFirgf1CMkfU/TjRaXMuR5iNNsdgV5bC5o4VohW8iARL2NhMyUuankI0yOBCYLr2EoawSJyhUURDHcZcoWVyOtMccn45Q1yIEj7qeQHHmNf9epCQ12qLAulzcAkLttt6BbfFnQA+t3MXrUYrVGudQa0QDfC5oPsJpVDn6zzEGYc8SsY7Ch624pNwZWqEpTTZLnMwJToNc/o66rT1V1RDSsQpYKBRZFnsW431TFgLsmp9JYl2dD0XhUcFvSRNXsvJNyN5aZp84y1W+THKsYYcJz+Pk0Fe5NgWndMHOf0spQdp+g2cfo7Si2n6Ok5nIiM27xMWsntiXm/CA6+nh7Iz84LMzPDKcoSpzCG7Opt/IJu/ns2fnI9XZfNfnc2/Kps/OWhq2fw/l83/82n+kpGtsAQfGADafvDs/xqppeMFUqytWM7PtItN0mdxsQI92gkOgPifKDS1s9YZYg7PWesM3uRczPOjvsmZtY+1m5wL9jG4yTlvHws3OefsIy5V6ZFMnKZAbra56h3MTR7mt638dghvZrhlL/E8c5wSzonkWs0zE0UqcdKyoxe5guMy6SqcWM6ipcOc84zNeYhfZ+zrFL+eold5gzjfS1omZx0rzUCMggCKn+bm5nqFQBc0WVEB1H6ecPJqYWaL7EQnz7wqgqczCY5nciyVh0chR+dYL6nYpTnCqUP8w7GdWD6YY4WlHCss5fhqNsfhuXLZKu7j1N38s49/YAtnPWLQ7yH7e9j+wqYuW0nbpp+0v6fs74z9PWN/z9rfc/b3wrx6ztv0Wft70f5OKNsf+3vI/h62v8fVvP7Y9JP295T9nbG/Z+zvWft7zv5emFfPeZs+a38v2t8JuxxT9veQ/T3szOsHXPbm16tTSP8t3HKxogdW+Zs5isRXWq8e54QvOJTgr1fHHZMnWWTOHHeawdvk5WqJCy8s83ZYPRXpeAZUEQiRy+IiNOxLTejBWp18UoWF6zvfvAD+AcskXop8zuMnecq6xBZRi6TX9ixWp9sMi4Q/cma2SKyT7iFtWKg+I+hyJxYssbuwApkgKw7ulGe3YQUyRVYcHirPzsMKZJGsOMBUnp2IFcgyWXGIqjz7Eitcj+NKcZCrPPsUK1wPrRzFYbKkObzEBviU5tASG5BTmil+rOMWf4kNHSrNxV56XKmlme214UIRdaw3XAW/1uSjm1xLF5p6Be1wXWiSlx/wQwXoM15Nv7vJuQkNTYKqKJBdO4JiFcjsfICSzioOj92OPY9DG2AzTFUyMsb5DZNTQ7rigfEKTvcVWlI3zIVeJtuiqzrTUf2oXnEsqh2BzIfo9Wjl68iT8/FeFiwe1XW9AhRt/YPgsmqd5IagfQz8Rf2D02HN13ldQ7zQFXGj+V3syDS2XeZDJq9XYEQFNme2y0tJbMpsDyhOqrF1s11cSmLDZm3XlpIG2dbZLi0lsZ3zUJuD3pFK/Yoj0Qo9oFfogdfVw26dCj2w8U+f/NrX/270b15yPyyp4GUyqpinxJYKH3lnYWXk2allpoWA2eNFB099Nt++hc+nGCSQeg6p5zj1YpJ6HqnnOZWBCqkXkHqBU6eS1FmkznLqoST1IlIvcurhJHUC8zlRoNQLvdCQz5N4pl2Ehnx+tTBBK6rwUU1+wSHFBdqh0zPfjAqIJUxXHNBULtDq0wqBbPNp3WLxbw0GIQUiZXlZC2SlrElkHuVoqTgniXwKZK0s6ASMqrREXIyU8MUxbgeyeUpAkKMVrH5PivnDx/i1DFkEYYMOf9jaaVuTiTJ/mJDH2PF1KTgoYUAOwVSVaUd8do51WVhQmTMqbs7aAcwo25613qDEKdXh7Ii7ZxvN2UY5nEYFd4yl4Ldg5hmQZJQizTKe8653TpXhdbEMSV25GVlMl+wMD1GDI4vrMqln49RaNvVcnKqzqefj1MFs6oU4dShJhVX3mTwWtScmzRCAIyrjfZDfT+WxVD1EpeH9ZL4ZBXivWYIqD0l7LMrycBkdLUkkXZ4VgR0GsXMoT7Zh6ElCj03lyU4ffU7SJvKwKKLRJWkXc+TXF/OQpM3mSKCMGUvSLuQwSprbOA3C5VPlm5zzFIyNTKNiJ9EbIPbDXswB/x+nDOAQHIYKcicAm33+AB4hz1+K9ssp/gIuwUJSzn6Z4S/EJ/CXiv1yJme9ZtKFBL4U7Jez/OWCsKdEjUR5+HLO9h1pMJnNI/GC5EQYsSyxGWdtWgD/pjbtok2r6RpxMkibUJym4R/Mpk3ZtEFdIw4JaYds2hCCktm0w4pxh7bXOYCCHP6ezTeZ2m/n7Ep7zchP1uZwDjc/njnvNaNyknooh+sfz5zzmlE1hYtcM+pDlV4zClLIyDUjWEee8ZpRbwobXjNajjX3mtGSrlX3bnJmvXjVaeZmvWTm7CIvz86cXd7+7MzZhe3Lzpxd0mXZmbOLuTQ7c/OW8bDqWsbjBHb70lX0SPmhbb0/2GUEzqDEqcw6elCsoGZkupAea0pY3xB2JXEsUWJbpkuJU4lhXmbW8iLd4PCKJmt5ngzN01U8R/d36fqdpeu7dOXOSKxcumawxOvX6WrBlHO5XrBOJ2W8TmTwzRTZvniZlrPbgHhmaJn6k7SpZJn6kjSaF1qmZUkaTQst09IkjWaFlqmUpB2X8TJ55FXIUqB2mTxyLmQpULtKHjkZshSoXSSP/ApZCtSukUf+hSwFapfIIzdDlgK1K+QR3UdpN2cWiAJb8CrF62NXZjcua6yurmdX4z7cGtHTvYh5SE87ECWRnramcw//HxcR/yTmVVj/jG96ovyC1EMOI166a6Td6jB2viBtwgXFKPx4ziZ8UTGeJ20mLLtKorrTWXycdsZ6dbHMv3zRNFtOLpraKrloulhOL5ompZ7f6/n9RU+HW2gVXTzJXUTnZj16pOPH9lPHXemxXel5Tl0RTInFGstMrcVKy0zRxXrLTPXFqstMGcbay0w9JjZJcq1zodciwArELr/vKzn+PFKVKMRil+MuwoEVYPWqSCPn5mbwEBS7xa0CpgGcJXg4C9on89PkdQHBbmedDHyfwgfIShCVAIY+F50MpM/Q15P2a/EWGFakMH+Gvp6yX3O3wAQjhf6z9HXGfi3dAmONdB+co69n7Ff/Fph1pDviPH09a7/C6sd+bUvo08zYPp4ilaBz9u046QSdsW8zpBR03r6dlFApO2vfzkg4qrvgUFCI1LEyQn/3dL0FXW+Vrrdq11tv8vbaCvnQsWqC4wQ8FFX9lMO3tg6uXBGe6JTTjDj6IDlaLNuw1xUbyLrHhqau2mDTAUd95pjas5Jjal+0MbUnFMfUnlIcVPuQ4qjahxUHnpiRHFb7jOSw2mdtWO1zNqz2eRtW+4LkuNqHJLO4hyUH1m5LDqx93AbWPmkDa5+ygbXv48DaD3Bg7d18B7TPhtWWHFZ7yobVHuKo2jdzVO1hjqq9lYNq7+CY2nAa65lZxyrkCURpdNmcNmddyoCahrYWuZUBER0VrE8ZotFrUZGNSYlojkrWywxo5cgnH00ZQejzoEV4PTS01mmq5QZo890Ixarn6yR3LCldg9zXIPe1nPs65B5E7rVp7sBe0F2N3KuQW3PuELkj5F6d5q5ZS8wacq9A7gHOXUfulch9VZrbysk5LOtS5F7GufuQuz9WCLO5B61VZhm5K8jdw7mryB0gd2+am7loIAuX7RAPu2ydeMhlS8QpN8zRkeeygeJFJ8xThlkHIaTNGQc6ZmX2GTBDS+jzCwG8LlmbwFvI8EmTr3hxDPgDRk6wOGRj3Wky8DwGpARLKHIyxva4FKEarCDHVz5GAWjJWxy8joMR9LQAtrZBJgQzgjlebMUOewQzghxTl1oR2rrry3OA7g7nIv6PAwcfYwYLextsn2fOF4Cl3+fIfGr4K60rPGv9W8DTOrpvYa8NTmIR7LIvCPa34NnkB/iGrY3n3cSFtDvs3o7hXlgukn3DcYdddlPh2UsKLC4TMtYJb1yGfcglZYJMmcCWCbhMLSnDzuaSMrVMmZotU+MyOinDLi2SMjpTRtsymssMJmXY40VSZjBTZtCWGeQyQ0kZdoiRlBnKlBmyZYb8dkVVxp1RHK9byL2HtKpiwjpgi6O/p3Hf04jvaaz3NMo761VLG4NL2GCetuatrFEtbfQterqXLWOljb5FTxR9i54o+hY9UfQtwSiT6F/BaNNat0oOynnIPiMq52H7jLCcbfuMuJzH7TMCc560zwhkeMo+z0hraUtHAoUwF3wsUMhvwUcDqXMJPh5uIdM3PiKIrRJ8DBE7JfgoIjaK+6+IfeL+K2KbuP+K2CXuvyI2ifuvKKg2918RZcb9V+QSiPuvbiELQj4Oyc0R91+RmyPuvyIVVe6/IrVV7r8iVVbuvyL1Vu6/IpVX7r8iNVjuvwPVWJ8t26acOFxOjm6ub97V5F18BFqKpKfo3eEOm5xWLY55mTeSnPg7rUzoy4KNSBDYuM3sNv5Im3Yv/wT8UzvSxmnPnqZsBIFC7K7R1XlyWpRUQ5VQfvIzZYNS2JgBqisgVrXsUCwAKkMaAZKd3WcS4WZJ2nF4dhwqO448ZabhOOQ8qQAH97uyw7mZf3bzz3F5pA0qhseDcJyRE/fP46CsOY4e6FJ9DtfH46rOG5d19NgLb+TtqHo/7egqXcBXEU+M9QisoJeClIImhl8GcgfnKsydGwlcceYo/BBcInn0BKdPJXZtiRBNpDqFwOVhFa6VMFfQFybvY4g4IZJ5ycURJ/I0AI+BhOkVDsxCoUtQFz3uTh+PS36m1cgGLyzGC+7E7sWSipNqeQlRiOXbsXexQFenw8DP0K+/XJE0RI7Kuhc8m0BVoW9yWkBJpKSDD3C0qZxx76BBjSF6KwUK67HBan1yIRUpRIhUumKlZOQIyU6S2lYRSUwOYdQW62ErT123MUltuBN4KtUOnYndyTQuxREwiJ208TN6AC1JXYrDraWF/NhtTjWj2m2jKlHnvO3kyVDyYqF/Ht17YaQxPPu81b0kKFbvMZZMw7tV4puKE20nEXA0nXyKM8y1JGqIlB2BVdioczwk4Bzf4q9X73L8E0rmRjPnbo0dHClycbGDfd579MJOmoMIVjLT8LhQo1AioGHksfidfUpZHycefu+FN02iZSRVA7sMqsHlg9i15E38zg6orL8TquG+uIbDcE+Ih7PSOkG5RCghDgdHgpdMPFmKKjmwlfXMQnU9YAmrNkUKp8rOxZVdIra4hjO2VkW3dVzBhHMMB3r3dFF4gNiLtLaTxm6kB+2ssSPpoZ85awEnTskOt3dpttrcZYw67TPNW5DMmzwWvxOB5jJ1ynXtgBtlXoJ4IrmiB5JJK8STxrSuJdqEJXLsvAS2PnbYnF3bQVvhUDJfIp4vQVC3XGixTiwl4zbyHgjTNi38gcXT8fcrZdXHdm9BKxqAFzWYTEFnLFwGOxCdM+Ob62Efor/pPD33a9fsG4GpUAipvPurRu2FGxb2OgudwbCO3bw3hD6ET/HpRhAwErvxKu2b8TfofDOs6SLCuFfxIyhqjPVbu1RXdB9dMYYKXj+dYb0McSl36ZWkRUZehqu7dAVvYVlXdck4e+L3HnpXyXsvvcvkPRPlbLVWoVjUwkPDsWT6uiZ9vCZ9jNLHa9PH69LHwfRxrfZjF4RrabmjqyHcvBnEPzjYEG/7+G0wWoU3aNGRg5xI4/Wi7LTDtXpQU8EhCtwBG4wOgnkUSfuurSnnLHIOQncWb4NxzgfinMeTnBeQ8zqooOJNxznvi3O2k5znkfNaHRGscd9r3L2A+34vv2nu+2Hb9yHu+zmUjvQ13E4Qt7MjbudQ0s5Z5LxGr+GchTjn1jjnVJLzDHKugbKevbjhnMNxzokk5wxyriajyBAaCxOqSdF8SK7mw9+kHtTXtEOtr9WrkfM6vQaqmWt11A4jOK4OmmFO9+BnhQ50bzMETbKEXdTmtX97BVTHVbhgLsJhaFjWPlFabEoD249Qzp+7MNI6mY9Q61XJkMNVmVGFq3XdD3t0jQmDiC5xoqutQ2XWqA+tSyZbpYynmB1E2bplPJ3saMs2IuOpI/9OaA2mDhTIaLgVwqGsgsKXJeGWsD5E4g1oQq+eThX+luir0w+rWPF5BZfoTT/oabrD4q/ZEhGXKIEmKmmX/YC62tvajRJy2g17CCX0ACUUYpTQk6KEUvfuvVrnQpHuv6vZZ5UFGkK9FtTI95QFUGGtgyyU63iDkFMqu62ENRoashvV7ujw6hTWhlvzQA2ES9AkV8YMOYbAJZR6OceCZBK4q5Ph1boIUCoyRBFdgwvd5bwqNeNsI+B4ziOjnuom9VTzpnDRU7vcpXRxrp7WpXjV4GQ46onJc1ap0A6/DdD1uP8lKQvj8YmgmLpUQP8luMWDVAmG16ChiacSPA+SXNQrilHrDNvgebjJzsOh6S6rpmxZep/ER5Iwe+YDOBTFTAQ5IO2mKkubkqB8zUVrBeuBUALWWSuPyv9cSQ2yx17ditB7dw3JKQsweNSeyW+tR/1ICKLirmi5wT2F2gZnpyBZgjBPvGNQEXo54NPTyCJBeSMK59VQCWtF+chdg1kIOIpt0Awek5G3qSLpBVpjeeO2tIc7jTySHTo3wdAVd0W1rkbdqDcsU6O9FQEAQaO1RRotU5O92SZd1O3aJstokmIllm2Tbtjrm4lH4HHLyBH4lv3JO5SZmNDwsfXjd8DZwkPoinuTEsjH1ve4s7jdHTeuZy6+Qw0qYc7LXzPqQaP2Ro4B8eDeVvfDFZQvXG3y4RKCjaLJ66UUOEUXb6uHBb2asKxegn9b6+EaSyAUGNRK0JUP9Qo4EuNSK26rRwO61AyvQZBIXWIkEuk14TLrMryAqLp14+q6cbfWQ19X9NJm2KfrXOUy4+Lf1nq00ki90sjb6uG1eiXi8l5nBKGigWwI8dkNWuoe3deMrjL5XZGjr4rh61h4g16pe8z4GyLw+dgVgxzIeK12td+ErBzmwwC96xmtXa1L4SoKI7gKlbm2ssjRN5AorEMqympYP499tMNk1xb19DpW8ge3XUUsni3Wnb/D/ncjrddpV1/N3sx1olQSR3W+zHdwQKGjq9hXVT3I+2rtJgob6nCwy8jV6+BglEu6iWLKKoxslb6G8aBFI9facA5QfgS9CeujkIYAqIug+AgBua4E70AcNr8VWbSSlJDax3S7us/kdyUl81TSCd4qs3W7mbpzOq8jaDnqAdj660rwFuljrVswb7YO3W+zOHsFDiXBPS/qpc2oavIvqwi9lK0zqmAooZzZilzdr13dv7UeuQs66lhsE3ewoN15HXSyvSvDIhvcoxk3gnrn6H5SbiOqZYkutsIluhotRYIkzrdmHpqQxJjDsrweORSz1bgt6+hCDevlaZa8DhZmIe3kNaLqGzcQkROcwsKe+6E0XiDFfzbxO0UVjatRkw/zV0SnSxid+ruipfPQaQ+8wath3UOzT5ht6SKYrWjRac9l0WkxQafFBJ32AJ36u6Jl89Bp1aLTakXoZdzossui0+pzQqfV/3XotI/R6dWESnFg5rVPWPRqYNE0YRW0/FqRJuzZjVH7UlTadxtOuRKwZwaVroBHDCCn1Voz5lmjV1G4BiCeXg4u34qWG1cvJwRLoV+a4cClQ5BaCIyLf1vrkWMgMwSCvcYKUPsXYNYB7QFby1a0ktHryhS9Xkc7rM69qOkSCXmgrhq6ajShB0kQOaBrLFFybf7oKiCrNNxYdC1Q82abs6CvIs3WazldxekB0gOk+4jgp13bncjV1/GF1LXTnVS1V0dbbXBzoi6uWYD6BijCu16dIIkV8Iii+3VBL8cnB0hwIf7LYrUilXCCRzJoZQ0jFNKBpOoquqAdQigB0F1gRnVvC+JH3Qus1xtjvb4U6xnWH/VbUZ7OGlZIRm+XaBdn8WLoDqZf+a6uAeM9cjmMV1wE40HhfUkzcm5jazFxm0V0y7KIrroooluaZinqnv+fEd3vurIHJDCLRyp4ehkF5VGQSbgkzGzhZQmTxD6TxGUKYdELf/cctADq/NrnvdYDvX1o9+/h96p9V/Y9sO/Svi+1e1lwRPoITGwp0SFnNdeCXhpTzngJ+CWglyq/1EhQHebjACU2hEEeLHAujmhf2WrjGlSY5kdgFkhGR8IgHi0YDAy1zEPtJco/5FsIo7aD5KPIKGEO6AqqFrqsKzwURH+muDNEzSyxDAJFOYhKQF8srI5dQ5DgmCN8sM0z3oM98eD4vbYnHh/C6lAIYRcjqmJE1XmhXGxjtqm4IQRf4djDJCJgkiZIIlQhsYtB8qeV9DOc0egIjR8XDV1z41JkE5qfCs+Psw20phrWFVxN6PKu0IP1B4TbWGXds8nOCV845e2kZ/qKJFwryD1ZdilOVZnUIEl1Mqm1+NrCXu9YTt3vCoxi21/Yur29WDREihXf2ymacxxnVI3LMS2ejHINPfWYmZubm8uPXMIwExMzbRf3MCJx/KjFB7V4sjEX/ycOJNY5c+KeOiLLqnHtmrm5Hzzj0HmNs/2HzraKMuO49yJRzZFQqFHK9YU5m2tu7j38eIllbCfR09s6ERkOt4+Fwoiy4xs4mBKL5IElBYVOMXNzb5/AZYtRmawXM1kvbuh0FzJO6KVB28UxH435iMenRYeizkABgf/f+PxdzXUb/6RzurPx6E//9u4b/vbE6XZn468e3ftHPzz5x3gc6V/9zJ+NfByPn/nu4SNHjnzudLsDc2Kd1tH719G3bj1xaENn43crD67Z/pv/bUO7s/Gul5xtv77yETz+mr79s1/a9AQe5w6IR9ds+xQeK6/Af1/d0O6A6+bpwsVeuzNd9cn7UuSaQ8+zUcPog3bNSUqY1mJ6OhJHNRmzvbxOlyX+o/DunR76PNyMerczHbnpZ3daO9NQ9sD/Gw/1fWFFWz790s7G37jrk/27PnkPRnw7dfEPNrQh7VcdjkGE3F+5eeoT//j08Sc7Gz/zkT958v3fD1/a7mw8cff7Ju4ce/QTbRgKCy1h1O9/ueYsG3dH5dhqYYbI+A/0IK6anowGAKORE0OpZ57+ypO01hppG0bMv396zWYiPH/y0bfyh4GGeBVFOcbqD5PT2HYkNr7g/l8aeO2fnH2SQtBSXCDdP52m3uLgss0pe3625IZMyZcsWvIlVHI8dMquv7Dp4kxawflFmz7PTSuuIFNyOFNy0abPc9NjoYP7aM/86dv+hSfAMx//96/Fjz/56Bcm3M0V1d23ofHRry+hvn3+Xe987Hd6/nFe35JUtOBkp4VKDmdKvmTRkty3/Twqz/z7p5+aoChaC2ZoRWaGZhedoVnuhTt/hlZkZmh20Rma5V6MxjP09Kef+m13e4Uu6sXGA2c+96tDr3kqQQ03/0KMiW7+dDvqT4Cn04bHlWS9O1FtOlphUeQ/nr4/VGpc9x+J95DBXXr/h4BjgCf3+RSCSxHAStCB/SkqizK1htCVyTYaLgdySxra8DqmsGQzW8eGn1WHTxHKa9ORYGGGZ5Y9iKAKTzZeCNxfHWmZXgQHQy6UvM+OUcAmrX/jG3Y7N75lxbH/Ql4XGKPYunR3JT8HUfIK7jNirlMPuSjqQuWf3KavOXrgN2+BZt7yrrq4k2Ja1+BcjDm8iYmZufydDCpa2DalxrkKchmZBuKDKZ8cSyc/KSZPA5eHDq7OKWpT0GQ6GNoL3cskMsv0BMMPQY+NrGU6IWI/OSxedemu2yVSGd3QQFCp9iqdPuiWbVdFtN4q04GsA67XMplnrCOwky5bMWN5zLsL5EwHei+1XwXpT7d39ajXPLALGiPvuh68epEZHw/8mt80gihgkEUO9BBbRLq45AYOQcdYLKtwTZmya0Sb7DXt65uDSjzhZ0gJqyZiJc8FU2uFZeJSiiD40RtoMYKECohwCrL6MaJM0hS/yXOW+UA6DMrORdwzDf2PvSzQEu0wcWKRBCOlydPCWqhttnoaWJdNUAN4vi60wqVmCD9LdMGsgIypiG1H9H5ifShoAR2+Tr098pmoy5nzTpPmoanGASLx6r+0Ey3vBpflXeCyPM74SXQ7ugJoMQPmWn0gHvvyzEB5ltG2LgfHZCSSTsxs6LzPPuqZzhUbocAWlSemQ3t4qnFdxjD7NhHqUXsRYPQbpEeqOLCK0kveGCm9ZG8rIrEJNFHCinb10jdiAcsQonC5QfUNxyx/ox/1gD2FppOBYrVI6IbXV2JxkKWZA71weiOfqW9s2LCkxllsj+4X4CITVaBd8MYuzA+M9MnNSnaOhnVfRaAGJ1REIizrUVIoH0kyVH7XSF3tDmJcI+uV4MsUBMQ1YLEyFNB0KGg0Ad1fpB+wFNNENKWblqO9qWHtREoXmVOPRyhbEQ0TTbp74EVGF4mxppCvZYrqSRupYIsAP0SOLQJIZmKXkYfL+5BzFrXbyuSDuUKTmE/eQZB8Rjb6LMtCepuZfc3uXLPbMA05/J/ejSQsLRHiY+Wgmi60CIgTLPp6dzgZ8XPcZZF64jntMsYLZelfGdeHCuvhZ3sFx8LCT1e/cGn1sZWAK3A+OiQzy2kvUjz+LGRjljsWe7YyLMjul3Ywgey101ajyN+qitxWWM0sCXsMUqwhaWZnhA2IqhCxr3s9dPFldB1R3UauiwhOvAq7CWjLpq6mC+TyEYTjA6uXBQGHTwweF0bFPbd1xFDRtv2nMw+sRA95Rc1RBHvaOpLQsQWnRYtrZ0u2o/Mqw2446cLut2LyIyHHpA4FCMWX8+l/lE9+KGsfpdNfOy0mAKQW6bdbnIJPhtMQePtHKIoRsTeQrzqdjnY2jn71L19969f/4SWdjd993/Vv+fY/vPoSH4KPG/c/85FXfuuqP39pZ+NXX/vJFW35PHA2H7wY9Pb2PrSh3UYEJC062NObSCjtaK+zcRtxPp89DU6mXfWZAUtZKdz2dKY7Wk5rN867odOe9v9cSjXOSkFyDThj8WSWEVeXWJrfJ+Y4hUZl3v/Jo2CrEXwxWcXgd5i/BuWkLMFUEQMW/5O8IHgUcV57HCGV47NCFJQVUDL7bmTwTnm0rLqzHKU57srjh4KiNkKZyX/Ilc44WmapAVnqqAEtaC5wk8V9eINxIHwn7EBPWnC0e5V5ZodZCn5gxK1CxLIMq4fqjECkrzQu4wnPOGYUIosZsY1v5sxwM4JaItcxqAQfaBD7QBZKTwXYMtBTGeZo9BTARo2elsFwjZ5q8B1DTyvhdoae9Hql+WnNerWGnwbXq0F+WrdereOnofVqiJ9euF69kJ9uXq9u5qcXr1cvjrU/FLtM9O5gBWPt3lmRXb23kiDIhSKlXYyc6CrjbstMG8lcI3f75WeSnuStQvKTulUofnJuFc78VuLeIBzw5dcjpguFfwHB2niZN1eY+4ISZ8sQLtzbuiMBjN+VAwQXBA44Q7kUxkKCDebRUghxAI2sS6o2VbDlFnallajsGmeE5wfBjIlPckZ4BJsqnhb2eMbRKLVq2opsKRIS3mElbArTSdajqhmDkXG2Wy3wivXqxrVl6wKSRI+Tqpz5CwmNbeIl0ECmSps56RNRtpkxRoR//R8qBbmdoiGR1QWy83Qb2eJXReoq/FHxD/kQt58do5KM+SSjQzAUpxcp3QgtWsYZiUjLXJo5OWIeevNkYVckORKlAkkySt8VlUayy6UdvBX4B870CvazMuUk44okY41/lvFPwD/wthckxZYlT7XkaWVcFXo/Agc6NK8a9coTDVzsBWOEuDH77JP9JlJR9W4iLVPvJlIS9Th+jObp1qhj1XYL3Y8VHDeRluZJEpVLJVExh5qhJY/pnLn6QaNGnmiTfG5u7sMs5sTj6W91I3UxTRtCJKLGjY/3iyX/858ufqKz8akHXr/6dzq/gWPozhVf+5u7nvd7eFz631f+7/u/9BU8PvA3y978sV+b2dDOyBj1azuNX3jf2U90NgYDK6PP/dcQIsRq668+E53di8eP/cX6V9z+ByfxWPzGX3/pTb/xdTymclEyk5ibO/2Ms13nG+JVI5u6uquh9dyervrJGWfT4vfT7fa0HfYPHoL4SY3Sy18mp9nE01/59IaUMoMIROjk/40b8u8u3Xz6tac7G7/7u+951frnddC/7w2+9CWH7yfp6lP6ronPv+YrSP2XT5/69+Evfw2pd/zxoyfE2/8aqTe/8d8+cepV90Pym6n2qr4XvXLnW6c2dDau/L/uan3qn9+KrKtedP937rt2Bo+P/eMHvv6L938Ujz//6999dPa2v8fj6m99v/b6l/5p9xRNl2WGSBRHsHSdYyTf9sz3/s/3stRNdDX/i586+mc/aK+e6Wz84ZefeuUv371zpt3Z+NEPf/G7v7j0V/D4+mhw8iO3vw6Pbz/2hadKQ3fi8drvnDTu1dfg8b43fOyp/hd+G2N90esq9y154eRpRETvbuWXju79/g9/8IenOxvfedvWd/xgy8Bwu7Nx3R9u/f6xwf8Nj8uc3a8Mz/4feHxg8Hvhiusn8Tgy8JavVtb+Jh7D7zTvLr/otXj8rQd3P/nfP/jzw21LXqQLdPM33vuym8dmOhsffdWNzde6h9C9wR++cenU9w7g8fA/f/YX/usyGsqrj7zmFcVPvQCPf/vwp3Z/7J3/iP7f9usXblmk/xt/6YaRxjd3r5/pbLz/Ox/4zt7j+9GNb/+Xv/uLFT88hsfmmrc98MTccTzW7vq92nfVYTyWPlCP/vAX9+Lx0F1XXfvWe1463PbDWH79zdNaPkmCod0HTpNMfzp4H52C08DcRPoJ7WaXtx28T3a0POZH6UUEqCvshno1pZ/Tj/TFv1pKS9EpLY/iGCTKlkwLZccPUsZSBMER2ZWwGwlvceleRo2pUZZ752LRWuSaz+VbZgMdlKHHFx5n8gRmac+rSP3twrZKSh2mntT23QW60TVz1c0LSuWIzDYiOCqrvhHBe/Fz8pMcb7VjTtFTJNsY2HQkzZlP2sCxZsY+iTZtYsJiHcQ043Rznn7bHTKYOWcTz8aJ6sko95hx95pZGmL7U8zwCPhlxflw/FMCBv0617jh4Ch04TcROuExFQ7sgAvNeHxTG/afRoj7S03FElwx3ilLn5YEpl5xztkNo5wTw2lH6VTc745qN85VuMmxRq+xVXsAj2ypiXt2DiO+5xHT2Ysp7Uy32+1uLJdKEeqeTljNQHT8qq/zyQB8/x88xx2VdNbT/wlEZJgEzzx99u1vZrr7svdzFc8ub9IRHDgbf3DL0880bjw4/DrQ1AnyHu8Q6v70N849g+s77ZmPfPZTcyBTUMmr3GHcw2188MVvetEPbvmnl8DqZ6MQ559p3Pjt0+2ygjFO8vXJ7NcNbcuOb3zmzdf/8pa+f0vk7Tg/PtiOZDefLrPsv/dEJJM2OyGRNEmznbZPJ6eajsAATTP5S+fyU2CVoOfCkv7M9VbmXk/LjTd8uvhrT/z0LZ/obLzl7m8f/PxfnsUd1RN/86H3r/iLZUBXD7/imRVt+WqcAT8GM9g7fTp7HCRXZQViCjvTkTOduOkAbd6ZPoaLQG9TfHUHdnDa8opquqPV9KWEUFqGDborPY5QUhGlPJ12PD1iq6lA6uzp+5OrFM7XjouImQ5T29NR9oZ1gyVL8s0TjRcePA1+3NximbfpzLgyZc6P46JOdcgn6eZ6CtPV9CA0c3nttajKyJmmytpE9jvtTK3aM0vvqF9Cw3wTWRZWsI/r1793ndyoHFdEaRViIP63DfsZtj/wKXkvvOulviHvygicM1OSUBT2vW0uLXibUJeWHXPuy4TO3E7ktckMle8/rYwAYdH/ipGaMm37JMxhfjKH6LcN98fKTCWfJ+zni1/OfJ79cvz5wpctOkw/C5IJ0G+bzI90Duiijet0XWgMTT0W5c3snGyZD0yM3UHjzuzwHeQlNWhF+WTMt1hb9mRGjlX9zGTNibsq8Og9MaFGNmmqegR/tjCrFbxfZmZw6Bc6T8Yl285+iMmSmn60YX9UbLzwtx574hKl3bZDLDZuAF4SI8bdG+XNqb8iTA68mDcn+QXxOJLD6MD+0/jyLcGX1Hlzyj52ItGO3HhRJB8cZ+30nfmyPTiEmbFJp+yM4jA6+eV43Y7HMw/Kn6a1zfD2JWc+MR96hF1Haef9P5P/lKV77Q3Ub2bo+7kMlL224g4Q+HZNuWfkXqCuz+e3VaC5+Nmffv6Z37yzktpLgEMkEnsuv73i+F3niLS9Mt/8xDW41ln2oJnLw7qWChy1hGV2m1psaOF+mjNOuNvrWh6DLDxPYFM9QB82jECGNOc0TzT0wcnTablQ6NwTPkW4ZoTd0dkdBE2MSHaj0U7kAn12opR72fiBP9t3tnj00xs6G/9o3zuu+uzIF4E03affc+TIEbAZhA6Qb+PdL/27Jf/yqQ2djX/rfOHdr9v858j3qndG71qz7ct4fCdJyv5hQ5v8jDsp9teq3aYVxXkp/IslpzjqjOUs3dXLSgNaPhmVQTpFS4h4Wmo+UYCH7bmx7Vh2nz5VzVy1Zd68+84RCOYb8mBUacj98R779VdnuJ5QaT+DdCpKV3bgD/GXoCx3ah8VJJl238ubSst2qCDRSL7MYhumUniaQF1ubJja0ZVn5+Z6qAAnqHdet2hnUJdINqqOwh1J0JFGopCvyw3xqorSvRnB4TGKsQMvtrZSKolCURDvfu4oZmUkrOrAyM1myV5c4WTRTkhq5XNjd1xxdpaaJ4k0lSCDM9/uqadgy80tMRPBtkuDfCjOsnML0aHv5e4QRcp9rmbuZQg7LULuAFORYLCMlOEDpyNoqHMHzn7oD4C4yhkMZNerMJphD8oJHvP2Rj3m4o8IK0Upf8BHi5n5EZ0hTifyOlFelxkfFszJHzHi6TFTP7YosAj+QvuncdRHpTbwmwKKy0N8Mt3WJc2C5chpd3TBnEpqOGRrIH8tirCYpR9gmQv5nTCznNtc+FGCGc/bpHM/ijGjMGdt2pk4rY2zTz0Zz5PTieKNQTumx7Ib8OK0kM9gfaLAgmgPWI6wiqs/WiULXUGydAEvJ4nqc9MgfzzcME3D+PYSiazJlNGyG8+W2fgPcht+wm1U53Mb1YTb8HVwYpQ4jjIp/TFu6SEpvZ9hPco/k/VIs8xuGI3KlutwiOs40sV29HSxHT26Zz7bkVY1MTF+4HTmFMpIIhK8cn+dYcyJmRKGNdg7T1+ZDQmx4iza5zUrJ0MDcunlb8p/mSLmZBwywgRspJmDRHHAQA3xjwvb8SgaeNSydeJgpBpyv760X8XdlMmQpPjAjrrvH5e4ZpNmovCyDKydH+/QVcNcFYyvpKNQkkh4XoafLqc/2+rmmSqyANbMQ/tuyyCN+xzOemr3dqrrc/kmZ5yfYfYB+rO9bh6tNkOSfciEWO74X+i+uBm+7MUN38bQfU1mwo0I3ilZOUKl6i2CrtFIcv0zr23oCiYU5XlXOaHournhyxxuqOs6J6RIM/byZhx3NwKsBwnd2UDyBiE2VViRNJJWOo70SNlrAnLMCyNzh8TBrREz8dCbJ/eN8LU0xMQ4VJQWrSoKqhuE1Z9pRnRRSIJVqUXLzwkz+Yjyj98ofTunfqz3N/9/LcyPYQ1iph6hDuQMIpb7TbNvBL/boB7vPBjJByMeCXTc32DkiOabgb2RMqceIXF+JMnIE/AGkxgIp08+opqR2sy1w1uHdn4DCgMkaMGtMG6K3PWq4JPSPYywjLMHgm2p4SeL7piMREq5DCnMIe5k4Q4svmsXdC/2xd6I5ep7RuzDCMT7OFPKD5pgJBIPRtJ4D5rCSORosQcNYEjqQeOORHIP6sG7hIC5+10m7wtHjIGKyw00ytmhiniogofKxrCwrokHSxdEVLmnXSguSPvBa8JftNAF8n/uPBhBL5WaC13zPpqNUKpxaCJrb2/kkSUO+uDp3B4S4dNcD6qCH+J4kByxjW4BJKYePx66hdrooh6TTI2Wy755G084GRqRetL/knmFQsWp3+E5VVjyfSPapYs83FGpYbapEpvYqmlZJDaRnmGSk66epHa2R049JOynnTokGqw7ga1VI3cwalCVI3KoomjpzGEa3zbwGx770cQaleneapn1fUjtKu5BxaGIMaGDHejA0RC4iTgjjAnpq/YouzX9wFyWIMVxtTCnx7fTJZDfjATcUbjxHEMRnRC/ayYUoftVmhV6gPBhQv0gzfvEMxuaJqAZF3uxR8zE+VWUghnfC3bbTExUKUWNRM5eU30Q07xHO3vg00Luhb8O09fEEuwxK5s+jBRovi1KyGfXw9lEijmC9Y9IXc7Ao758sKXzZtXm+l6rXOGky5HT8k7W69C5SLKNtHYYuQpewhy0XbQyV6HbTcyWs7kObr3OajF7E4wmtLeH++AZpfPJRteYACzI5fa7Y+FSAS4drVK4dAB3TgqXXe8yec/CJfG5ADtnOAt4OS23QZUIojIGPQ8PHvIEkeOOa4eel/kEDdablLSITLstzJMH8CTH+ABP+CPC0zzwzKCQchGcbhd4egl4ehnwzGkRqS7wZOC10AzwzDF4FjLYVeA4SHAL2bMDJQV3usMJbiBswXiLtQFilCW0tCgrwW+AnPc9oqghVGD45hZHY1IkYm+EXEmMIssl9Opd3CvYNOKZbkfpptS0H1H4R31GVxy+PpVJV2IEK+LqLAQ/vxkV1Lg5/yjKusPmAj2gn997VDXGYbL41KOqMdFOLBjPP6q0b8owhjTnPvTVD3lvIDvHR+2oPhM/TGg/omi9QstWBGEy7v2LZoZaiKQ7bE7xIymWFbVzR6WkpS5uq5R8VAN7SnekQnf48eBQ6syjilQ8JbsTIp9eDs1ZU0uWdxDIsMlb8GGQFeObK572whwGQ5OELSK1GiFtVlxXa9XkzdMMcziSc3dCrm2eYazjxd0WabclgjQ5Wt5RgYjP2VbJ+TqH5gTMq2Q5DzU21dL5kSipx+UcirrOfd4MRBoKVmsbh3qDa4aaOndHRdjViBDoNddq0kyCBubKrC5G3tcy+LA041uIIYbtlU03QudawYflABTa2YPW+JaKR2xv6FGGUEHlXiFd0aTjH4xR3T2kzejFHZfaCz4soXSJH+yecejZC/uj1R38AzyAsON3VKSPibKThakiqPg4vwqA8McfpU0sLE262Boru8bsoNNrwsIgWV3cBxy2QG9ISeGOOtDjYXt8E4ybLz6qNMgP1Mmn+vFHlBnHw+OPKAv5ePuKhVyHSNW9kSTiBlI/kDS8kc3HkUTP5J5NGE0+wt5FtM4gDpV9UG3Mj5BqSqFp8iP1CAqYdpcSoLF2g8xgCtU0g+uVa37/EWVm4x4RH3KDKJvCCCm9kNKF1OpOUqmAmR2KUKVmn5a2VRm3KrjT6JvFHBxVTLRoKbBnEuJq8fZlPL9abc/Oq1bsA5BWKUtCO3Ynii3WS1UkKmCnknHg2LjSBsZ+SrZwKMrCF5ZoJGHhIAxOm6zusXCeyWTO4jnH7NOO/e4k33PwgdWEUiTIpByoVEyfO2+aHAZWIg6Y5HZwPPBBsJmPBC4EHH7oMoWAdZsE4FScPMwaZ8RIuh4FwVOgPT9HJug5zBadBBnKdvMAuomjUFiK2jInZkx7zD8oYnRwIgoiaUHkUhypooIiaS45R3OWQs8cnqTHlMOpyL5wyWNikL4Z5tCxIeB0kQ/QJCsdoIIPUFkhZEG7mXzqxY2vjGRMOlBJGjuvp6pIEHyW6DNjWiYjKprALINXsUDnNtebNj+Rukpz0DU6tpkJhDoP1VmjoRNRLPjDsvSDLgAzOvjBctCCmLERLJSb7ESo8fD2duy6OMTzJawG6FLLH8LWXe6NZMJoSO0Qo8GcDjEawIng6mIOw+WlYu4DiHgV6cgCx3Jjz5KyVcTbJ5StSilbFVO2ThdlC6KNGl+p3Ya4CTMWrwsom5jyJolJzDy9jUgMb48lYRi4oUrFCoIgfgURv4KJX8GGr6xZLi1l6GwmuvSqB+n8kZQL2mkjTQq+TI0S8GQbQF/tfGH2gOivjGG9VpSPMSysViOP4wbkr4xhCQdfl0EU17UIUZjnEwFNYoxt9cgzdVTimbOPqrWKZs8DFqPnAlJtUO/FTpv4WNGeqTVDPl3yCSmGSXGbrL+8jWL0ag8zRhRwDJ9wkS1bUc4OxqMWdC7GHIBQZzEIxWpCkpBAqFoIoY7FG7FCnEUmkoIzlV2GUMkgk0sANbc4oBLDlQKqc1lAdTKAmlsAqJIBNYVQ51lAqKPjU9VCaG4xCHVSCI25tNzmijsPQp3FITTTADpp58tuZW1FIG4iUCiAQwSycjmra6UeeabBPZ89pgj+atUZJRehVuxqFPyY8hekOkt7QfyHaX/Hh0jMDKGsIKEeGF3G2R4wttOFsbW3EGfrgpXrFCzCzhPCzgNhewsQdh4D8i6DsL3LIGwS1lZJqZG5q5RH8rp5JFLHSAbp4rNKRg/Sxq6b3S7yP43QFSP09CQlLW8+UHm7JPtEPtt94pJNe7JP3HSfuPE+kQv2ieJ9ouYjdBsrg3eKm+wUVxfsTok5VbtT5GV3ikv+l+OdIon8xk5x053ixjslhzkkw8VctgF0006VsvSJkyFFHJ5OxWCvGOxj+aDHEEt0SokhVC0CoYohlHG+hdBiKmJVPkJimmW6BPhUgE/OSvDpITxnzcoBCNwsfHrc+QQ+vRg+vW74VPPhUy2ET5XAp9JW11km0l2GzyvJNQGkLNXUuZ8l1xQs17Qkocs/qVzTieWakil5mmFf+7HA/otlmSdVe1L/NmQjKtjhSiTNvpFINKHQgAEQV5IYTTDvBsVmK6ohhlDS2WbHsYXvWGgbKpaM027MZ+hdlyWTcgG9m+fFdPwYncqYNmChJjyOWLGmk4g1LRp14u1Jlk/LmqBOCFY56HX8Zi1+wZqEecB9V1YH9K5kAaybyjN9ndtUkXHjKyM3gU1p6V1pKcr59K6bjChH4JlLwJPzb6rA0hCHvQVPSYwSqa/HpxCBpyRPVKzenp5/ICDoesXAjoLWnOkQLS1doTKsimJWBR7ltWdFcSguR3jfSaOswko7YYPasZw8wzsJywaldSerX3ESmVciBSN1lm7GSs1jrBbWmO2tpOsZe9tiYcu7LGx5V4QtNR+2eBYZtqxM0klkkjKVSS4CZl4X7Hj/34CZiPvxHwAz1QVmXhbMZAJm3mXAzLNgJrrBzF9sUTILLhOoq/pXhjs/YYTFZc9nd+H57D6n87mK41mm52V8StOFAjFZ6Skt7ZmcntLuZS4U0Au6UJA4pYESM6c04X6JUzrhg9kqKaVoLdmRUrSOpWjd+Bh17Y4WdE5LOqcln9OSjI/ZTVrk2nNabKbb1aseZBMfykX2KylF6zBFm2lgkXPazZzT7rxz2s2c0yRRO87wRifAuFZ1LKrfLsBXEsnlZfCYpP06DOl5SoFWfTVuEBCDb1olblrBleDoIRxUgKhEEUHDnAz2CO6F1ABZO2lFe55MoZ2WlZkaufcOiDQJ7sERwoMrMtxJJ7aDXgY4ojzQSSPa2WOUlQB4OJ+VPa7zIGrdRDqggg/RlX4+gwUt4lN0cXlHRS1eZYFbtYIGIuETmWDB3o7mM5jwULbWbRWlbLddun24XLfjniqmgq3BvUpYSaaVqaiKiyou6iTjNOy8yplHMLhxL7EoOaNGKnACt28EfSxq0kIowmaWhUq8mfOAIMUsajmDiRW+lCN3ASYuJ8hKxRKAGBrzdHVJXpepcG5L0kCKiYn7LjMFajFxHuhVxeiVwiWrFBPnGBMjohtGlc0KWRhutBJMXLaY2JKi1I8sJrZrx50QOnd5TJyhR/PAxJyfMHGO6VHwUhH8udBQAq6zRrOwLCLbPPqwLPngx9wSrW4xXl346uha3QwIzIce3wI9lbFgE0O+H3wIBeFZ2fUjl9xrFZrY0OwiE/uySjImM2r2JSSjZ5yRuvbMvhG4S8TVtLe9DitNil2gXf+tZZkbZ0LRYy0MgJdi6jI2yRXsSkI27S2cAkuU0pQqPjpibYt5574gIah2t1TU5WhKER/zgnM7iQS7C7iclGVh4BJdECPmAZcTA1dyzKuuY14tfsyruB+LA9cVj3m365gX2WPeSY55EQOXEwMXn+bCApfiD8tiHlFZalJZalImHAS5mONTXSRMDUtKqvM1W1i+gFoWJyXFPFJS2ouStGLxHElJMY+UXKRGXNLa3io6fxjGVDcpqS5DSqorkpKZwV+ZlLwyjBEp6Vo5FJOS8VsKY4jkoRjGkqwEYy7DmHo2pOSzhLFnT0ouAmNegsC6YMxfbFEyC56CHJGSC4EuKeR3i3pUQkrKblJS7Y1URjLKpCRr9hEpqaz0LaYhrZyO6UsiJRWFHAOZ3C3wIaFnSkqqZ01KqpiUVCzwUVlSUtmbsJXsTiklJbOEpFqckBQM9W6XwEcRIams5spihCQJfBQTklYT5TKEZKYBMobimRI0U0xHyvjqg+ZUMB2ZCChAnvv+3Viiwz+WfOktjNOE8bdi7k7RHa+8ow5Eu0GYYC9dgQcEdSjFnYBlYUJdjvsuPC46QuJB+qOS/B9RQEdJ9ux71quthPcI3xLWN3SbPKjW9HpiwOeuruTocgEfRdK4I6x+b/QeaodtrAfVOvwZIl2QAi8X+ND6XrPqjf6rpLxM46QxuEiNgC7XVhwRFyGY/RJ8eTqE4MdG+AWhRfBuNeD3kazxXXbvuM3gmKsF/LCK4KP2zLWToYVfhGbtePAEG4pqSWGNMcrspxkpXas56a4R7DtGe7cT/uCTkk+T3DbrcXNuLs/rnNNOi+N6Ku21SDZryk0iGyA0bAYfk8HHJN3EoiJ2De4EfyrtGawRe7dsbYMpXOdgryC90M0UH80JPg5nAnCdRkqTxDWD0vdI081liZbnDybqtGoNX1FRdVtDVmBbw/4knLrfK8iBXuJIwvdLmMXaXlN7I8Bn3H++SPqypldA+cEdTte+DDktxaAW64QITktaF2ircumPplPpJVPpwuk/qA+eyJVRzhrKcRW2tRf2OlbVgsNbWM8NZeVBDEgTDY09RS6tEPi63OTo1zTBqF7LrgnmxCb7RXCpRprBsvLZvTVNjOuvx5yMY17YM6y9N7OXVolbj9h/hBHQ9h5g+CqTALEZfERq4S+Np86UQRg2g89Imt7gMxJAueDzn0m/rXi+NK8cxcwmg5ZMtq8wAGWS2HEWgHFQbWUbkfTjoNoafJ4O1XnJrpnQI3QLYWrNeW28S1Fq8AVJDoZqtKsAOloGX2TF40Iz+JKEtBxtazf4C5KVeGZiRmgn+EsZnGXhSfA/5ABBJzJ9mdK62jK54K9YIXzeKG8VrCpsXMqgyO21n8cEfkX6n1ZdMN41k4OqRiQyBbARjI8EO/XIzvfnpDs8v+DWRZIwfYA++LBXpHpdYEch3U0GX4VG0vwPRqL3Ku4OqUTMK0hTsuBD8Dm5+AdauRkxcrmvaUcWfuXe+BYL+D5A7E/erYLzisKtzQeRGgE+Z+NNwMalMvif0sg3EBKFW/KvSYsyrgO+V3CARfGGC0RUjhi5t/l8KbQcMWKLpx3fr9iC54ChCfVSnX7Vzl6g5Z7gdxVhk0EVbEo+YAv3CkEtB29RWgZvUW9AV55HJw3JOqnI5mQhGXGBbbMo6oVXyDrIWdkXDolFbaE89XGz/xJbuMYabSu5sOzGW+yniWogh0e0iVHLn8iu/a34nKUNKIIzkp5uEHRniM3WDRC0KYOmufguLJjdhFpgQ7paYTeSUxa6wBxU8+AQjl2aFiMOqnW9OTFAtdFx2Z1xUK3M7Lh4/R9nMLHr/01a/5Jdxm9ZbCat9tqgKvd6Ilnlp7Kr/E0+e4O3YvHeyot33bNYvEEl/Bc8u5VzeeVQAjXzsS2YAkerfy3NePB1ydc9xB7M7/4Quv9K64EpLqvG6dolIg3alZvtPZhKVp1vvRxqvpZczvsL2qonPi0kpjf4gUyNR/KCpbr8W/Zf3Y3lgv9bMpMOj6Ei+Dc5oB0Oi5j44RJakpIGJkIEU4AZcauoEmldbQa/reLNv5zs3pKL6YQkpXTVTXmBxo23YE0TXPs30GJQ/CurQMjqmLiUbVp0gSMb8+L7S7p6T4amL0p9e6wRduptPxJdFWXKqbco6va7ukgKIlzeAa+Ov34HmYS4psT2vC7Gbv3Z4u0RspXJBY94kRNQjOdc8DukVBA8quhmQpPSmKMlJqnLXRSdXx7PI5SseR6ZYqj6QVUQFZoMz62S9h+vtClBQo9v47RiRrY8LX3/KYyDTmUR/EhGUDdMaE70pRV5ROv/WIZxFlB6DikHqNZ2S7Y5WrYg7wyOeHQ1EczKSIISEsFRGMA7wb9ARmpBwAEdSr2PqcXYmQfWAMDeBWEqUy6GHjKiYi9z+NrDXKgyPcnXKZUeMMAQNwjf5B/0exi0rVGX/8sWmICNtsf7uLZerSMZ0w1iiHQn7WmATNviTAWmlZEWfI+vQegtuJOzlxllV30z7ndkjK8v01Bc3Z10s4ut2t0MmBbbkpbB05KXdsgEIyzh/7iMs6FVbPSYel+s/Mcp6jD6q+hMoD72sCqvoNbr/luULFoAd9YA6VhsxctShiICNEW9ZFQriSRPuoVLApbtEZMHM5VBtS4s8FuRgudF0Gp+v0eA82MZ/CvdIQF0SloFP5K61Az+GWk5nW8F37fsCeJLFVtNzJwlpmPaXzugvoVZ1wx+wnt3XbyEPJtGN1E7CR2012pmFo9mJfhrlkIET5MjRCdGh2vmEXky+C21gIl5j1Jy3BkjD4PkNHB7TAPTKjfGSevUNbWRyLOuvjdDNW3zCNNI62ineeSrLJiVrcfDnNXP1k6Po4TEBTwPBS4OCdO2Hg/zpIhq21xGCZBlh3lSABqNVEO8nA6c3CtIw70wwg7Ld6ALti6673Zp1agrNRYnxf0v8B/1WJP6SROG3PH3ZeRLEUsltXos+D42JfxKCF0AI9s9e8Aii8yeJwJX+CuxSLMxF62bwWFvIOagmWmZUDhoLJWo1rK7UMLUgyro7RP+rbTTzDfew7KMWOhoCc8L70kZqUIzmACQmhdbTokaOKAW5YoOqIVpkyqmLagD2yxtcavwLX3CPv/8dXbzk4a9lqBTM1tJbKr68aFs5ILM37pS5l4RCySwAXsd0Z2yrtdJCJ53Kp9YOf9OnAA2phadjWyy5G+ue6bk2+yon2UT7KpnD47k+JMLuoCMPHmYZmUz6LjYMYzUNmm5J6JbbNqucsQdDuak8P1fJyGQmT3MyzKoBtlzH10tErHbIq1lJmrXNK3EQLOvxl6XznAt0N4xwj8aVxnIan+H7O+L6ZfFL+9WVvzCneXlp8EZvVkLU2wZb9sefwsLqORNzu6MQMmNnNbjNzn7GNnhekDuoN3ktB7X8pV8Lf9YKiJ8wP9tpRz4+RrWYq2zO3J3bILkbS1X4TLFuC5SrcdHI++VI4kNulwjzDg1III/kuy60VSbhvLrXk8YSbzUDaKKxiylBh6Hb2nWMUZ3yaq5Mc6jkOvVA2wOpmXr8dGbnH0kM/EacpQRtxtKHpmT9hdYQnv72cS89firiFN2HyPlbaLUuEoahhPXi8OZpbCgAyjMmmIhzlDLlLb5OyS5tnTMjGC04Zjh5omDoWoINtV2mCp2TkTuQfgDgBPgE1OTJAt2D1pb7ZvIgb+6ySn44+QtMzmftFBjGpukYZ3Tg5hd9UY48VRviNSJhtDqVyJl/odoBr+ntLPWiZ3ezIiHzfsnQMucaAwdHI0BfoTcqECGv9YRPjfsQk7Hh8L8ASke0FQoG9a4ngdkB3IQIz4RuVOTENpod4oBJjugz5WUN17FiM4Lpild6whjwwHEMdLuw1k3ATAlTb5H5YaeQqwo+BYyc3NyBLcdwPJJQgSKR7bMmyfG7iQ1Ynp7aGKMwmXIHUlt5HYj8XcyMzcndurs2111MkW1KXoyLOEAcnYk3eUKVFcFakEFbqYC7bDpv+xq6OHJHTyx+LXp5+fmRFgimHF8XcrknrTJpLilFlQjtT/JwKbV/OoWqcr2hlq2tcYdsa+x75QN99J92lkBrrZM/8o7onz9TTpvcntPjMLVU7UV/J4ygc63YGG51rk3Xi9vrbODFFXiyu4h2dVwi0LN4V9lR1Ssv0kXbV1FrkvndbGFKyaqbmtYwc8wNqjTqLKzmmfmqgdwcdvQU5E7FvVqH0++ltZnUCTHRqNqQx+MluAgHRuNevSSnSfgcCbOUR6LELreHxuNluhKo3pQO40XTE1GS+MMjkYlFV3VvTuxXXS1oacmR6NerXTQmJhwJ6PqWNSvfV0eG40CvbShp9jJxiS6NjYaLYWkYGw0WtbQB0ej5aOhJHMRxL2bmxMtq1rojkU17evq2Gjk6trOE+SgG1X62t15YhSu0sdGNWJ69u08oSsYxyiy+vjo6OoY+fBDAaUd7qminkJCTi2ruKKletk9J3Sg+3fi79J7ToyOIvsyHpirFbK5uqJ77zmhe/VyZLClIzfBKAd2bKI9hsBmwAU9jQ1ToaPdhkTLG6aAVxReJL0o3dOQB8MeoK2GPDgZkg793JyEw4zFgFz6agxa9rfDa5/OtaKCmZB3WuCkSDhDTd0DCyYzJ8Bt/h7YRN0kute+BZyjEHxAsfzaPq51hvDn5smGuPsEnjT+BJOTYQ8eBvGnBjTmrXVg2uit5YguKbbSOWDSSV+XsLd7dsCI4VWX/qTYi1EAMJgchTHozhOjYYkmqivbw5M0j4pPCLKdb8gDaYkMCi0BNXvmvKAI2kXljBF3PitaUSGDStnTEeNGuSMqzsN6Xmau98fPExPjO7W3g7rsNMTdid9NyhXlM/nu0dm3u+pArUXtdaFC70q41NWSHWM7O7qa2dn1tgCDuoyvvPloL4PmSEjkPDz/HHl4EggmdBs45It123hXaw9P7qBbH48QqaNzgIwKVXeAgqC5B7gD+LSDOAgkh25yEGtnJy5L6M9d9ahUJ3VppUv1KJeeceQ0CWnpoRXCf2lyghU3kaL2edGEfRH9yy+KHk2A4L5FXVjrPBDm8XNfSPGtHF2Chlt6cIYuxTHRBULgDiEWV7s7olL9Tbpkay0ltZZaoY/q7kVwdOBusGQNB4jxJVOT8bS6k+SS1DmoPSTTiZ97OFRqTDsN52DkIChlKypRKNWSmRPbaee6DQLzAqN/10xIXSJkX8BuRr9K2KCFtc7N3PwQ/gzjz1barJOwKZKZXuS113AOslZFHG3B2R9h4tz9tCwn9keuPdUcdIGUvOMt4dxTkboAtOFRRMP5E2PKraiEDhYxMTTdg9wzzX5spXZGEQieMHZ+NMWQ8LKEk64hD2i3sQETJacmJ0OPYhuGRWDKKSg85bpIHrj/sFhRdmFFt8ESNgRzpMDnFCGyyDilAFSH3heBDGlCyWpF6mLLTqjAnwB/ajyToYeXAulcNV6C/jlTk+RE0nvM5Cn88fYTo5F3zwms/1SK+kqE+rScHLUu8IvGJWUTlgC6NOZIam8UpyewGG0T+DYhNxNOhtIsmFlCZ09L5YypVNgISvfJyFmU3JooJA7lfjAn7iXs8uKDdNy4U8lkvniUBGcZB5KvJuRGOZ00J80uZd0RU9YeQEk7j/0KHSdwj/QrtqJgZz3KmRfQDNPZ4NLZkCGz33YRdvF8OJCvV9fSv5fwamadJxmXE5n9N1LBa6iRdLkogH7lZVH2PfOQKwhwlOieqlxXidz8EkKrSSCqSewL0qwDomMPueQ9RaudSHo5/gDFI+VhQq6Anaof57oHaa+wuUR3Llbm+4wd3DizXwsH53Z11Z3XVZhhPpe5IL4uOyxlh0WiFIxH2fFIrexgbK+0eoX9LDKfieD0XyQynEy6E5gXgUvSDBeyhxYf7M7ryMlYRqjWxb8puPgXWv5KJGOWTS1k2SSzbMDoKZPmAHqs3HdTItoHP0USayDS7PkXTFtoJb8pax1y0mbHY2HwM4qrOStIKk5c38QEoSEXu4D02uM65+ZE0FbaBS6kH02hIebmKBKGw2QtnbIu3WMvUtYxP52zf+H1bI6iCrprnRpXGFiG2Tw0MX4bifSGW9313GJ7sJULDFMPfjwxtp168PY50bTYCAfLwpKOufDQfv67vW6OPkM3EC6OHapuKCREJhkRYEBNLANKCny3M+iudaDQol0crWuE/0YJz6zg5sewCmOj2iHehFkURe8pX5FyKZHX0FNcIkKJUa4izmwTuU0vdojqgHmHOs2pqvLGewBnZ9UCrtrPUgLlhSx25YoMdfE5MdSlLmqudCUisPKfZagrKUNdWsAJL8Idg23IcsQVkAGVrhO2cgXmOv4kdWk+0Vlhtrmelrds9OWqL3Wz1TPqObDVZ6BKfokRnlGL8NQnKY4ahS3U/o6oUH+TLtiaCglTXWjCnzxVdkqFPn5PqpAYqrZqptIJMRkFKT8c75+T3/74m/9VaLX/Et4WwX8Dk3VINRuEVo6r/Q3Ank2fUE2kHiYm8BJ7dYi4QpTDruI8s7KJAlx+CuU5/bykshelLTsrF5Y9my17QSZlZ7jsubjs2UXKnsyWPZOWpbhfnHoqLn+SyjdkdsjwvdSoHswOd1ZkqjxOrGNbRjS/hyX4Z+LUVUPec2I0aW9CNhtSZ+ctr4vwxhPm1BiK7o564ZqX2NIpGVVtnyaoT6NRqfGd74n90VJCL4mPTazd8oT1huCB5CNl4ryjPhaSlMD565Lu2Ukc8D7k70V+XW1smBodHcWIe5G3RIKT8s4Tukf3JoITvSx+7IWUBfVAalAaw9/yWLREl3RvLHKBfKGHxRFVPBxEehUlenQialmqe1FMkTSmSpIaBLDvazzD35eMjUb9VCppr4pIj2NRjy7pJSQ5UdRmyYpjIILSJV0GCUsDdXXJijtI0lHlPvcjjOQYlkgvhcSFkbF/zwnOp0hSgunVB0eJLc+IQ2LklYrISItVB1hM2XgBLde9+0kMFkkQ3vvDErl+Es0wh/N/P3v8P0/wswHCE4kNR/xBlKlqiKp6gKq6L/LTquaoKi3DPr08XNYQ2t/vhxnpymJoKJau3EbSF3lQ+ySlKS0UcYRl8uLMPg8eGb89xYUkxKMwq/AEBbkKzto+vUznsBsSgYyjSQo4HBEVsjUqE+yvdW4mWYuFaB0RsNLohujElAcjuZOG6Gq5H3HNSaDj6KDh2P1DLx6/lK3oJJLaxdo692g4/HLvOQFhSgBKNbirfgI8CZYwUvPQ/E5NtDxlhPgnIuJW3VUfOWFlalQ0IeMzZYQtU4hcPLlchiU4ujIZVjJCnAoT/mcV6IWv5ZQ77uDknpDM9ti7UMYkwTGrC5M5z4v0mhzQtMhwOu3CIAhOacHAFSd31PkgK07u8H2IHcgjfyFTCL7A8mSibmk00hpsY1YxDZHLs0DyguBDLAMLY66HOV81H1aiEnV9Hn1MbeY5QzE4pkimh5MU/QuOQStWsnSFsShTa0QmAjFxo7u50Zw7pqVntwuO/pism/nTmbjEA1GJ2r0oyPP8Wuc+AE9+U7JDHV1crNy9UTEpl2e5tePrYjKcFLuGmUM8m1zCLT5FkVRjuqT9/ZiOe04g4ABFDC9iMq04gvdG91gHeaw6dOG/o4it4WJXkGgwefNpm0rwsTncJqJNsr+gy/T57UIkUgqLxIHHzZMHY96u3R24mTswZDn2DKECIxCW8KLNMBf3wKFuTkbFZBp22nDLYIvCvBXhMrJwM7Opc+aiaOo8s0vpenx6g+3LVu7L8Ly+HMAccyG+YHLTCyY+UdcI/4c/7/SO58fk6GpczkWVNazir/j6zgW6VHQHa75xRJLbSQTpPWufqw4iD5NKJ4UyfGALW8qRDoaAVir7JQ7eq/xIBUegnGwkxDLUyvUtOD0WUEeDzYS5YTMCTV+xOutfPHivCpVvfZ155kihuY7i2ek9m12OrZLbHiubPquqKBpL5JnCFuspzWPVMc8UoO4NJwDaMy7HykGSryWIjn6GV/JjhdtzMnxxWOsYURx1f0O8nO+1Ny3IR9G8PRsdMNV4GtOlj/6CEBPj7/p45MT+pukm0m3h9d/YxOVEY8XBmEOZ2UBCHCeTRocYX2D+hCKF4gglKePi/LQI++az1b89JyxbPemH/bqi+wBBFd1PPG9yL5ry2LoC3NeHHxH2l1WssuKRiRTFnjXne5O12kIOGzwj/2NrRXEprS9t7fW4Qkpl1ZqHttBxQHV6mTo9W6eXhUzzmhFzjgyuKnSNBnNURGl3eDkWVCNtNW53NWQ4Oe4w+A0x8Ny4peJmi7PJRFdxdlmUqd/IsDwvU+iVlcfpmALPmgfYZo0M6ZZnC0WXrDXk/rD2rHsdeWZoM2/LcnrhuiHsx9aioeg9VnrpAUMUTWkbQfeNW7Rr/l60TO7OEYp/ciNUEvyKou70hTUWKnxNtHDrYW65rU4OS/oa+VeSZlPOuHvtjVhfYyUJJ4FmveD9irR89QD2TtyjnxKyIwVkBWG3AlWkQA0N4Gcw6qfveA7wp6aX6xUQ5wCkwxUM4MuJgMTmLNB1PI64bCsTc7YVkGtrnR34c2+moq3hCiPDAh6Hw+XotxwN+2jmrjzbtH5da2duDD1QlmWKlYsLqLXObsYl0tZFWMIlaz6qTtGrTy7bgZ7wSrQLIaOGCI6SjiPO+9ITiR/6TtChvt8XLsfPAzzftAZ9YT9FFXf3hjndj9u3/kbhbo65axf8NSPmbOzVIjihLqG7VCRyd8VhrTDueQWBPBoiXG770oARbEOE/TbDyyskFWAH6ug7fYQRJC397OLd3s3d3odu13Sf9usNdVD3jzb0/qjPCB20TrzC+jH4jNXIBWtaYigC+6nAXuLvcdkYt2fjaStcUzgF8e0Q5Ti8SA6wkNyHKZK0BeabsvW47nsliXkQVRuWxabtNAEoKcDOnR4H1CAtBa7fV2S6cogza6q2DeVdsTWSdU1getzRso6ifdjIhJMPOwzBh5xwOaiKvSjxsj1w6vsyWq4x3aeDx/c39GhUeyzyDMd8r+uqrunqiZfDdd6/UABwZSaceHbWOlNOWKMROuGAFbWa86qZRvo6JLWH+O60GCDF44mdVTRt56maC/T3rOKteE5FteAPKOmiCuv4nVU4PhQJcHIYwMgmO1mCqNwtwDJbR0Yirxl8ENVDPjOgqW8zVNMZxct1iNs9SYmnlO7XNFWKJDIDutYQern26g2hV2ivbpeYy/BiHqe/h+jvYcVlZxkGJnhOuNLH6GVWRrRGF2UU93ZTFtpowiQvZt9jAVd+3sLLBcBLF2SeTSFzhts8S3B3TqZwY+HyJH+foe9nFnyHsIVbOSX9sE/n9XIczXmc0DiMTzr2NK7xaRyE/eWcn+xEMY8QqSAi7hINY41S6GsnLMOi2Z6Dh/6MRd1G6KoOmtHSVrgsOekUn3SKTzq2K8cPnXSePcNdpgQdP5uBTzpnXiZEkvE4nQ772BCOTjocLXl7ujvDdoOo8Xm1zm9W2uKRSk46Up4V69UhUBlDrbCgl6ixeWEolLlxMzlYLZjiHRVB5t3W4RYcXgBr9RPyJ51bZ1MoYfQPNBr265z5SRXEfI/ufwxNbK6HPfBnnmvqHEwRIqmLsOdj06bSrqYZanm64MPkVGLm6e6TLJiLmyNVD4vs7DfHm3SI/FPDrGZiM9ldT2w233hEhj3+c5oNDDwzzBLFW9d9ul/n62Ef2GtWW3vNiPms2GJt1cs4B2pd54DQ5U0VryHCGjGgDGHWdSajevJ7oPt0bTTsI4+Lm8heUWwlvvoyZSQ0kWkDrQSU0lnixWcL+8U5lIso3KKr/Xlnh0skKF1BsPl+f6MInec+3Y8OV83VtwNN6uqD9djXt4+tSZc4HtAQXcngioOuO+j2hm5y7H1KwLXX+FAY+9UTuu/lXSeRS0exrRSkhrvWuQ9/HlhwytCtjQuKw13r3LvwM+gNam1r9gh6xbzmcNrZ5nCsuXSsuXSsdaMPl2WwONrwd2rBd5y71B6du0Uw5KZwO11xpSBMLvGYpi/tsrf1UdEUQZXD1phdHJDak6/7HiPPPz2m+DKIU3TPVnIC03sb/RQ3U90z6QBI7oz15ZVo83hmqL9n6O9J+ntK2g63Jff4uGRHmHF3VTonqqvKWTtFVPow/Z2gv1OK5+i8hKv3fAtW/pbhtWvJJWepAxfp73n6e0FC/uMCrXNnzlFnqjpv9u9qmjpMHAjsLORqZYHvfNpLHLIW/HBcunTIunTIomL6e872EMckhcaYynavzcVmKOsZ+nuS/p5S8VwpO1fWrbRd1YgMiGlxoVteIc/tRXLd8/+y9y7QdhzlmWhV9XPv3vvsPjpHD+vYUN0Ra0QiEWVuIjsGgkoTSZZlYSZhsrKy7pqZzMy9K2tv53GE8GStGJ9DMEZMzKABxwgwIAtnbGYMKAnBDuEhGwNKECBIMlGCbB8TA8rwsIgJKIljXb7vr+7d+7z0wCbMXZjFUe/u6up6/FX1P7+/9atcZ040osyeEbkWXW+cumqq6DBTPQsYZnS99SsnsYt1mqNXBr9cjDtVpF4WlM9GJCY5j8rYBr9Sjtm0T0hTRjoh4RRc07YRk3e6TJHVInGtAUw0U0Vix5m4Y+y6wXVF6kVDIP+rzDIkVr4CJUafCE/cDpkwEa1r9YtkOARwN+8XY9QqJG4dOKbErdvRNXYM+/Rn/+bvw2u75LLP9vo8IFP43Lzbvx4wOZZ0KPgJo7ZedvMN5cqtr8RgvDScQVT2SrtyKwdnFrw0Lm4Ek7fqrqwA9u/Ku5ijh0nfCC05xV5PyS4+QP07ppjIVQt4esSOttxl9LnZJktP+6KE2KsH4Kkex5KtiyQas3rki0d+6olWEXGMOEDN0alQsjIjjK9MEBRtI3VxIDvBFtdymK2NV0/BZkqsPQxb5KVLAAVIS63ZXk+W9u0oKfbsdQc9/aSCvJ/uohaGOoBwB31lOEtqqypWonKcFMxaMKyekZG+sUC+2WtDxgPegiwTbjbuz/u03yMiqOkrAfGLb7n3v1Yb6Fwke0DEPYB/Z2PuHjGYSizYSBbZXFSsbLQWAODueFSv9yPyCS5uVnMi8qv0aFSsQo+4mKNijW25byggmMGDocHiR7Z3VZlMldqdVtd0mUkiti04Thl6mwVkekhrNr6+GHMzNt7rZl7GtRjBOlzTf0DiSG3K0bbx9TWGd2MlRliJwfbpMmqsxAgrMbXj03YMZ0FQDXXgl2IkUmx7R4MgQU2svC1JIju2Q550j6cwZoCJGuLIo/Dy8OJI6A7LFOznqB2I7Bq7CnIHNrqoWMttLyouwew26/iGatZxMOrjPU4f69kX5f+TMx/WDw5GJefg7qhcDbkgdHNh315i+YnTIQkgrCY99JMeFsSmReAtxyEmfZuRE1Sym5394z/4ugCIb7OBE3q1Zvs0QSZOB/0hZ3P8RcLZuLkANLOa36czxpmg+j4kRHw/KFaKIWr2T/7g61pG/XjYqOxUVdmRsK7sODtzourM0VAqOxJKZdm9xaWMbZBG+r0l7NtLh8lipc7ZYZ37WeeBqs59vs5ZX2foDjcqqBt1cFjBYVZwX1XB3b6Cg2GxEpEvjytxezkuY9IQwF/EmXxucJxDdCLwAhxLH1mktO+0H8EjAeoPIUmREFba1SxBSR/NYq33BSAEUgUkd5n8g0GxxmxxN9qJga1CS18sm1sAnn5V05WD8ppdI84xs/Kx+QopDGNQXsKBDMq11cP7jihoFIyQ6T6Gxl6F83GVXcMxDnBArrGTSCvq1IvBnX1d9Xmq2YSHxzSaP1ofznOEF2k/QGJca0qyGBYoADAsLQi9oEPPUpwxGXq0wq6SHu3/uPKS6HqRRG2xCnLSUN01IonW3L6odc/XtuDWb5eU9R2dNX1XVtYSbzDynQ7SUV2A5cLdrwa11YIxTF1l227tTopHj+Lhd8SkR9R2uX2tWAu1x8AZbZFxzyUuKKwHaxYZAg+bEnUhTzbHg5y2HhSRXew16NgzOt6IJhAnB4w+q8ToQ71A122Czee/hSZETs+htDvj4f7wD0dCLRAaFUciGNpsbOA2bi+i83/XuCsH8Gnfxp3t5UhmpCrNoK2QumulphQOCvrGXS8DvQm4m+2dZDMDOeAhOxcA8doEUM9jb/79L6mrLqRJrLK1e5oZLSXIFuH611LBYN5t463tG2/YuukVRXzhtaKH8db3vP7Vf/GJB77yTv2zlK6lA8H5j3lFb/AIrhdNc7iyrcrGr4BxY4r6gYZojnDrWrhuvtMo08tsnL0/MPrGwKOAiFujXtzh7MiLXjH0BvjIEfWKl9IB+xIkWLfqJfJaz7+Qet+0VLzSIof8z2FfXB4j2pDwi76iKEZHUoJoR05Pe8dE9RJ7Lnc3fh87rZ5GpU8le8QDnLavho//Rz5yRP2cwPV5Q3/k/ttTaic3Z2Kb6EWs1VCmuFc+pegXRm9e98qzCprRd3DvS0vD/vNEoK9jTs2AeI+Xynv/LTEoAurgs3I2RoEx4dNAg6K2irAnAf0j7/LGtz0fzv4yMEa8wc81b7MvaMzb2Y9W8xbebNXWFzDsSNUv9l5VqipV92z6C3RIrH4eUTfI9NUO47NbXoEprH+mr64mkQE6FzCJVWPqmIM64/eTcMgJGsR95qxqzuvZj2Jet47M67fPb16/PTKvZ5rzigZhSkvDIQrmTW3DqbP3Knj+jQxZAE1gMOJa74dG4dmrbHDDvJlter1/JPui0VW6+wQF3MFbkUSUcH+SWsJ4o3LQRZyXuxGO/du4lyaEPqDIxcPE+PzAGwncRlgk5Gp7MQ8Rn0ZN7ShCnswbFPK17btVQGSUmK2VO/uRYFrUkyxGQDX3AHKquX+JnY7JIGZvF8eAQMDI6vzCRfV1plZouXxgA7f25bbV3+OQTZRYLXpQQA05q/Ew3runDKSJktCqaikyp/kmDLMXS9VHsPzhr5NVWbB4fl5CIL/CQ+4GPC2TClntXymfZaFW/Gpn+mOx0saEQchV+QKP4mNeqP3FTxl/Abfi7D4CemgMoamTGAeCn7BNOjfMtYygdhSsMtcJtK5mo8lomao4YYN2yvuSc2fmZaDRZipmJv+rQOBQtTgTjHwX5wWBArSUQxMEJS579bNNPhPBr2q/ltBpJJTar/M3aSD8bTbXAFUD0BmBe+5mY+XXSy3RnZgL3sBSjnyD65ir5Jq1DRU60I4Jt/ZeYALxB3l+zJaGQpjQziuqpHV+9M/q6fzNgnTHzAdExduotLiPIOouf4vhAYoqSwKr/pKg5IT+AA39ARrgAK3eQ4A7I7j9GcrigzKkrpm1bBjcg+e/blfecAPFE2AtgSFADsznUN7ZqHSp3Q/Tju+es4OpIdigZrFh43Sjcdo3TjcbV1bdEkBBn5Zl6Re9uz9sI34kLaW7ZreCpg4dJsIu5smObeu2O12pf2FvbchoUai0bOhMX5TmOr+dCFXhRmWoYuEIwHKgPFKB7Umihp4kvgkHjjASu6ZA20CdSgW4B7UGqNX25GcPZNtjvzMCNsHmJJ3Mbzd1hnIwTDSPeCoQCu4Tf+h2I7QOekrc19SOcMbqCErL72wjagfcJfAGHDrafCsjNGShHRIBd6rFWicZxo52vxqMXRlmYRaGYZZlWZDxv9D/Cf2vEP+pMMq0FAwNHzLHoqOfusJAnVLbSzVVaHcjwHCmiki2zmGBr1YFgBrLAkFGQcZkzlB8oJJGFTpzzD+Gvir3o9Mu2F4mU0WXe41FeuBkqszc55WoGTL3dWJyZ+6vgdpL39PQ6aunxH8whTNP/rumYxYuKNUgPeVJTy21oNQI5Ql+CAlPLSQxwi3eU07IalnqW9VnYByC4WhxwnZ5sWj+eJu5E2owVsStlmnhP90yoda6FfFXwPthqxUz2c79sGzCVQxJmsK97htAMEyhNknh/Nh1Kr+H+BC/vlU1180rfqYbdXqo4XE97f6aHhKxs303415p8jfptXANuFJZm7kn1I5uLD+d/PM8pjjWPwyDbEzXRmwqkXsYpDDvfU1ScZqneeK3I+2YfW2qz33UbZR8Pg8pmlzdw2pHEdmE+WzkZxldqV5MbdDw9404ArnyxKopZMWq1LZu1yr3EOimk2ZuY6GkiYJVxw/5RSjJHHCisCm7a1Yj2OIPZvawbyOBDE34GRFmEoHxiPmwqEDNkGnUpUyH5tp1jm9IsxPYxLaqYtIpruhINqBcIMKc3mGVW7d7urLP10LzeZ8TZSiELVv+iHMidiE4J0bLV1XUxFuEWYMmlfvVaTEyilva+bandkwjtV/Ae994swZxILVGsOTRIOseVKi62o+5Va5t1RQy2FWVwDdv+SqG483Nrb1D+gr47NZuydUuOYSxk5fKvfn3v3RM77yQ/vi6KKWrdxcT4uTXQtMmtrZvhHPJu4vJYIudtKtuKCYuvGowsBNb3/L7X4IG4dglv8CfbcBVmHeXk1tnXv3z0KG3a7rE13fTU9QKatI0laF+yMqEmZVhRAKPeB3sfp/4629csfMi5pB1seMGHcc+zxzP76aJY8KuurGctMm7t57VrypXb5159c91jZ20q28oJqy6qM8hdUoOHaSdkHiB/LlB+hLxtLTKrb4OSeyTafeNt2o4chbjjX6bYb/H91qzp0wcRa2L6ripOp74jpvdXbV1xo6/u5zcV662Ey/1Shr0HVgdN990sZ1m2uwJu/rnRc0y7NFu4aLPu87GomkoTGmTmkEnllhIZoud2ApHisxO2OiecvLVdvIVxSRM/RRTJouJxU6hf91t88Q7DecMsXamduKnJJUGjvgJf8SnEDFWwCNiwsZwiJz0O1MXexxWcmon7UT+HnNF9TJ+vtf8ZKCEXZiEGjG1E5d7fA/Yd55N7oJsCDw7u07vKLsEUCiU7VBwM3uRlkTJoQpM87sNubwO7MpMaNy+AMajxHGxURWQpGKrrlRTNgaCbOymgI0Vu7tNPz9sSuVu3E5s05nt3cS2iS4S0tyEVMjiLAFuWxz9o+3TtJu2oXTa6/Qe2kHzd2lmN3fMtl60Oq1MPlAqwRFWkVNZN+QznaG/7FnkO5ywd62L6R1rancolbT6lijRaDAiTXYMm9SmX61vcdVcHNhoRtqUQs770/SkSRufxIkW8Vtp0eoEGY7nCzhSpVbvSIBq0LZzcY5kGCv28YZy8iXdVAgNa/xnprsATuyA1oXWkKeHX0yRkhrbBZTwwzmvs2FzWFsCvNDqE3x7SWFojAJEvxjLbEMCLTU5IvYmg/wA9sTTB3qX2TF4LM0UY6QI6K7JM7UAQNcmJm4Mp411yo4RUXK/FkjJnwXcHMHXXkpcCTotljr/PYMxRkB3OAUTOYJQdk6VRjL3EAMV0HovrZIHEz1BVMjZbtZJlzqvUSgrWDVxn6NsZCiGlOJk7OUq0RN4wzGDfAfZmwPdmhHoYSYzrOUzyVNj3Au318oYF0yLEzG92xZXW3Dndh/6h2/+TfCypRQbsM4A8q1Ct+dzi8JVIaxb8pqlYf+8kZ8h7i8UzwAJHMgsYNR8diSm9YmwTXeVu/NWyURCKZc+B9SciFEEXxc/SNjbS2TnXSto68NyNqDyaRsdmfSAheCksEM0uFBvG4y09o4nVvsIE11QADgLJe9GpQbEnhGkbNFoYUzFzQ3IfMjVADqs3iY2SmZb2WmjgxnPw3eV+4vL8vcbgYvEDR7anevckbfr/rwH7rH5Rd0/XFbozPtmIGcvuiZD4350e1e51dD70DPRra4iZcDs4sWgwfEKZbjnbRe8QBlrgQJyH4VgkaHPAkwbuH+4LP8DSUXj7sUlG43JeuxtoFCURFXII9ej85G7R2ZN1AQe+f8PhBLXG+uTIKzDVmxIE4+9rQKg9gj8COHDItL0A7mSASlS6WZjceVz8lFxideZ1n2KSzp7pdZeFDMu9Hki9oDqtVfVkfB3dGvarZKLQ0VnKhUdlX1BtTRlyMLtApvYXIeS1UHGOrDhAEOQ/QtR2Vrl9r1d75i2yh30/x6+1fDfo/g3e4OheATFiDurdiPgZlS1q93szLSb/QgSxNfaUklOc7a32+dCeRH0qnuuVBwFF1/vjuCXcoaZBGe3TLvZI8EOXB4OriUIcfMtI5ir17s5vlXVUVfqAqlGwpteNP+jTI3uVlzvTi/6el37sL7Q5565hCblmcjpTFDYmaeEsN9VojSAoX7AZDMEILEKSDo/DlMSvYTO9naEN9CvDZtz7V/6i+LKVd04/a8OAS/YFDLtbks/o0ZdUFXcU8mASZkqW8FrZmdqs8bpF930EWTqyP7LhBkXBJTjqsYngfY1cpf36T90Rb9YAdKvlhglbPoW2GxwNZ1rsn5BD+trylZVzrZAVe2w0q62sd2UbfZIAJHa0GJq/PJHgvyOqHqAM9o1tg1CbOMhMqjFdPp5jpwNbduC0rlqR9m+uptYxQlsWZ1/GPbobuxmitxphJiuN9dsUFAqIm50vbmGcFSyY9YaRr1BNIx4ZcIF2CUB1hLzqLsGikJsMBuUKnuweiXu2cRWFt9oXcRwONtbJu61nw2nRQseycHEziS2s6dgCgVdvW+vhaG20M0X/QHWcz+MFRnx5Iul6dskK+81ZVw3GU+8T9kRPXBtmitwL9hrg76bDQARXHTRISRhpBp0ohs70Wp0rSRkNz6nET0QNN+Q+aTmkuTQJcSrU7Y7KLq2g5wbe4qOxMUfU/38I6bsQnGW+tHNeHYBbBpKDB4qCNNaKzPd6JveoEyzb8lGFUjfkg3KzO8b7430LbWJC6t+cb9ZpD/gmAtpmjNVl1I38zL37OvFOCOq7mvq3hRVR5zOKODHReIuLcY4/+4f1cBt39ltVRPcw6u0X8W2R/TIxF15Xd995u0i5iEg18GJUHQ8sZui18e2LgQtmppCm4ucIDn1Apu7YG+f4DVbKOxvw9DCWzu2Jj9ipHU9PEIN3bb4xoL/R57Ks2d/Y7och2Mbs6NMgY8oOu6TrSK3K+BnKt4XQz+MecrMnkC4l9r9u2mC2Pag94VPKP39qOkMJ/1/Y5O9eGxsbDLGDxMFk5OtST05GSpJkg7FdjI2mU2OjY0xOdufqu3dVmcik9jhVe6TrU6UNbeYpl58LFXaBOHaKF5Lmtxiscl1Lmn+WFP9uOfyQHVWV7+er1VnVfUDCXRWNl+aHHlpAvHQADtLd00VKfSwewqEP+MYXlGMAw59WkLOt5SrgAcZbLHjOCDH7aq7MDpzhzjVNuFRsWpr7+eKll21NdxXrLItblnjRYvvv4T2J+D5w8ISXu8+2eoXuTNFBwLwCsG0HH5FzGb4SjLtNvnak58rxu2qrQFqHxdbRNHytQJZboVsj8iIZ9OrpgqmSZdqJd482qrsqleUqy4PGPaJORCvPeCp884x3HGfarlPthg5VXamsiK3q+yK/H4DBnDSwWiqrprqjhHJ4jembWwnxfZbfepnfMjjirJVjMHE0+lAXlr1ErYQ/FDVvkymo9Tu9mdbPVW26t09la+UMaSSBBkeYlIhXE0pLmH9jBNeg9X4SzsG3q/baWeQSVk5dGhcJc5iQ7Nx/oARhxAl+bPQ7J9C/iwmz9psgLWW8jqjCKl5/LWxvSTbfAxx2LdJ/kemhD962WKMQWr1YBc9skKcX0hGnfRLvcvzUq1uN3MvxF6CHTOT5uCgyR8wNKwPvd15WG3hEcmvAqFPvtnCN1uoN7GaLk3V/Q+b6sPaJsLx1V/AbvAyfKZLRMzuVVMFBMvGXKZsmbLRjwRbbNemNrba/fD4D2EvUC/uJlBHyEC9QF3OoNSVRQtjDrVB87yjlNfG8UbdulXdxE5sY5Qu/X6HztZtb2wM9vYBr5ofkUheL9O1we63sszfa19LDcfwdS8/SkmVdZIM+zRaM4ZF0AP92N5VU6X3iLSdwdVdw16mtoPh69rEdq8GRbWv7gYcLG0TmQ5lc9vBkCq3Se6CXeQQ4g6siUrKtWxPytmqnAw1HPGcKjLY115YjJFBtGPCIBb0FyAymc2yP9Q6YOYK5ew0w3Ohuy4lRWw4Y8PIBvlh3ZXk8FQhTJYRk58EAg/icxaKCTVYb14CAoMwQWUiBCrMOq3Pinp6DhnfDqu3bbhTSvUFJHwgWWongV0aVanxRIs4aU1/s5nMsuyX2fL1honvbjeeyQ2q3CluhlIoveR2Mz9HgGN0EzY249rXlTQ2yfSYwdVTYqEJvE8kRTFhgdBanb0/XNQEt4hRTrvWYGyF0iYKwjhJW+2s0x3r5eMrsvlsQo3J31vs0Y8boMgt+ugnln50/m+5BMnPkQWyKiC4dYu++y/1ko/+r6UfbVJLPvoxdfGNudCOXFDl380A/kigfrJOPvYj48g19SptAvqfeqexHK5oisbu4UGLzJft2TLa2r7xFXf5A1c81N6hfw4RMBCNxdPnLq8H8G9CG9X+lRKuoQP/Iiw84k1qQzmmsz0C4zhrPJwQ1u01VHTMHgH7z00UuhmfpX5WQol3lsEUDbTBNp+LEfht2HEM60JuOb/ZI2aHEhAR3tap7I/XBCtm9A0GYt7hcFC21+FsgncNlsiHEGL8szz1x92ft4oJq99S6g8Vl4i+veIIxt2JVjGBY+nzLfe/WthFpsvxqWLCjm8rVmPDuaThI/eqxvW/ZlJVC+QvFyDiKiS3INvmhB2XbXNu3H3qMsRjT5fJlHvDSvc3l9kEHKf+D1MuqLZW6N/D+hTDL2Pjq6dEvdquvHoklVQbKXg+aMBkHCx1LUX/B6po20gcEdMMsoFYE+VK9ygtzwTa87+hW0TJYtIh1ivAESko4LG7bFBO4uWq5sPuUKGHxbKiY9uI7mwztG6SPEyvwOGVQEFaCfHuP9ph2/5fpqX4nzz8M4nIgnhTwGk+vu8Olvt/PvUpd6jZH4oV+AAiDyeLADBDtlfQXtIrUtyCsspdhv/vnCLMawKNUGwZ2BS8G1H4xSWQcuwlFXhl/BNG2bU331BegomVyLFLqsixn4Kc6au4FpvyJXeVMc1AuJlSjMGaSm0imWFZOGF0n6b4jlEFgQcYwrhIMGhXi9rXKSSe7LhL+q71K1AB5Hal+5LaDsMj8uxAdG4h/mfnVIGexzaF6gaxQ0w75EOOsuuLrpuxGUOOxuh6m8rw24S8lM2up9IaZ/fYtO1eh6FzIViCeCfD+FijBCN7J8CY0ER1B7K+dABcRrLNBzGtmiqTSpxj0ihnXm5zBKKxb+IBx1lAyxETbFOUca3risC1Ec/E9tH7OqgcdS263L6uBKROBhkPvpscl6mBXem+rLbj3o7pAZpve75C1xpcBewxd6cRErRthG7OHlUMmf3lsktTxfFnD4qMn27ZrmtdB7iV5BqxqCLINqmCbKFdpoIikyFs2eRXytwm1w3K7jabYfTGbIxkUmaLzQG4EG7xlLrlX1GBw8mBpie1GfQfmQvhxIGiXZ39tK7LZnVwTx1E5S/OvMjGdmz71PBnFyrw68ux7VO2a8d2TiEOxq6GlR5Vb4Q6Yc1bijVWvwWsBcxv3UHZkqx6aw5a/YtAkAGyY79MZNGxmddyBDJxA03Z1DLbRaR2kLm38GQcDIyPf/fsG79y0utaL2ZqM0+DoJ1dU0WMhRSXiU13C/i8rN1qLQHaxn1ZSaRVOl1kAss78zI3YztO284UgluvtoH7jauny2wK0fwdN+NutNkUsyXztTLrKvefKbtRhnEhtCtltq2rXJtGpthmrv1rbHVcdhldjYFEu1u/RjtmFwstxjBW1AeJF74kH6cviSoQaocQQddCuK8ivCGaF9vO1VNUJ/lCAeyP8VLlwDm3bMf9ExhG95ToAG1nT9mdgkKyA+FuRx9NHPNgMuUqaYP1sFZ2bABWH5HC2HckfsGu4N797JeXCJR72bsp6ZbxwGlZCQLl5jbhYF9h44EzXMuIqRuUubgaUdOz0f2InAFSMh8Qz6/6LKyTdgzn4LjcfdnVXV0fbuNYQOG8s3GTNRYwDl708Mxt1Scce9BXyAHoWnuKwHqxZ9dU2ZJQYezmASR3THFqWxJ2hBd203rQ7Jzc3+VdLwIb76Awu+lKtcZmmGFuh4CU/DDyAoTY9Hq7SQI86u9+lhMVLGgWE+LUNfxI3YrSf2LBuA4/LV/pOEx066opfKrjWsC1819Mru0GuHU1NB9Fh1oWIn/he1eJIE7p3EKn062HqdcYJjkQApsMGyYjyr72JCwnsen5jxZJAI2NqyXS2SP5TutRqUavbNmObdmO7xyyRXSqA6h7rYzbi738vsl23Iq+W1FJmznpKv8w9RcdzonbZGOHtcUymaeosRF2aQz/r9ilCRu5tchM71rTslQCl+3qKtexwaCI/e66aUuxBuhe9c9DxRrff8z4GDdYDBp2V7vmjoNvEVdhbqxr7qACzXNbNl6wuOrRxqz0eLSOO7OHuGJ2ukiF+0pkjXWZbXRkmSXVMuPe1xIWkId8icAp/ebqEHH/EZzV//DBObO/npVJrbNL93gvwXvvaPRSG0meUyasdcDUZ35/FGalwbj9Ypfqs+fBVBU7g+B+O8qiYc+SHYs5grqDMu+X8cAGV5E6rDVkW8ls+C+WqTMDG7yYH6Rn9PBJhhOCzLQQxJjNhntFPNwrkJUGkShp9TTBiaQqOura/JysNfaVwyF0FK3suXVa7ErgyhtyHP6k4r2TfSnQjOs6qAXEBzFhoSAEKKunNptbNWNfQvd2qCmn4IQB2JA6DCCUMIDQbdhs1ln+egmwZ9w7oBbYwMv9uHwpBX0wjTS+vdDbESVfPHRpsG7pyroVbDbHtABJO+XWU6YiKsExvdkchZkSLgiRO8rEsYBPYdn8Q0Y+MSOQgCFsCerFhRjv0bf15iphwQH6+e+mGVLp3fjXm03bJBJabTabBALoUiDIXo6wHlA4xiLabDb4qnPYxGdsSHXP2ox5ahZrUka0TzsN6z4/oATkg2og+c4mjDrHy38Vupy4+niAoPwpxgOJF0JszR6GrVipGaAPhOQQPG9k+ysIXXCQP+Lsf2otfkkvLQOBomO6RWSCLONBGaJju6bKMKRGCntfONQgKSsCvTil2XCAoH9x1KFPk6BR7JpiUlKg/UfNd6M+gijqtyPxDQ0b6e03gD2/VBIGTlrDdM757UYM2HaPwAju3JM9d172Zc1Mru72lVbnv080A58mlKnVh6mJQ1Tc8dmyg/xjyCgqqYRtwBzR+R8aJi6+W2fZDzG3o2BylsY7l0CDSewMBZ4p+3CqoxmxwYXz7DIzw/AWuixwtni0SHqqAJJrILyqYQDYfJM7GEZY/zuYQyhRN3jfFWZQkDCrymVAnLCqjV53xrIq4yfWmsRDxQPoXxCDt60bAP4hzH8HWXy1RBPQiVpnAtWzLfRxKsH1ZYQwrBhhWJGEYQWATBYAFehXZ5kCdi0RDH1slbC3GgFYScY4EV/WnrNo0Ae4cEDgEh+qHUhbKP/ThTCk65CN3FN0O5aV4P1+4j1N36HAhUyEAd+YmL4xZYRxsr74noaHkI2YPYimb0RQu6eg/fRNGQbeYGk9QEDWf7mrW90XAJIqrA3mu6gjTnAylgE9/TxBsDMEdU3QA2b6iUV9A+cQICfs7IrxYomuMb8xGiqbOYJt6KzHABzx8Ao3KiF2HLGqcgvCeJSBC3cxlgheX3GzyzgH2SbJBB0tpDCMRhmIjv98BkJmULqc1NQUkZ6EmrQPLSdFwT6MwL6YgX0ROaq1NgW5zHK8XrSLUSqGRYHfu0wx/5wyk5CV75KfUulZhb53iXf4HBAsup5Bfwto4KMDhqVM/rmxypiqYtBwK0E4zzaeCdqG/J31qmtrsh9DknVZ9DB0hdwB3IE3GsmpvX1KDA+06R54o9k+lb09NMlM6HPgpDXAuXHrcJbRRygCeTB+p/a4Z6orMJnYpggQwODO/M1mm3RLc5BgDMIUgjhiEvuQWkfjHCLGOSSVgyx5IePDFzALiGBwMHIyDuwRXSHnYuaK0OWSy4YEY1xqzZQA1rWtmcrK9j0Fxh+xRlvcS2TFb+D63zRg8BXEcfeumQJkhDMB9wCy4Hby1v3+1iUk40gYr/aL6faMKPgOHdZBmoaZ0FKxfCLFQdm18T3lGB3kwW6N3VB02A8Dg0pF4uQpMp7hwhW1pgSSAaMwgraWOIniLbOXYLgCccIIbAdp0vCgEPWMtCDpqsa7AXALfW69zi80H9Ft1Cb3lNmrbfYKsANpdYpVuZa2zuSfNtmq6tcwZhi3ZyWH1JDdE6bjBfLPpHBva3g0MnKDzBtSBTiNQCfEPBeRQOfFlp5zGAfwEeF6s08g2V6AbOuKu4jk2YkF6YOMCHJB85T9t7BE0Zw16AvaE3zXdpBxY8vpLsrJpxGqTK6iUzdA4Z3uRZVKxocFCQqksdGOAp/OMp8pLP9zk11WswLBOj8s+d/qKjXvFqxERKDM8KvgkSJ+GLvEXoSjcPSmERd9vQ32WPWyOsSQIEQvpa/f4u3HJh55FgDtj2w8bH8o7Q+H7dfW+PZPqTrRs+/IXxqfxjl7Kzi5YaIqdOdsUIbucUTE7w4lOkmLl1yY7zNWVfAB+P1bhJqK81uiMsj3Y7+J8//GZEz5GwztK9b4sNL8gJnXTJ3VVnhAMHT6KCKJr3oZs3YvPpzrzbmGs6o++7aW6bISMhyDMNf4cEDRU35nF56ReG9VZVvAtU/qHjON+xq/PUL9NmaUFu+BKz3IqIOjn3gUaBFKQ7+4Yhvktxob55+EQ26MxOH1rZNgoepbD0F10Nljg/xhzqtb06cwhosyEPNt/oix8XYKwuvNGnKUgesM8gNRKdqaTCL8yLGCZN3J20w+Z6q87JKofg2MYiN3LsWdj4U6m/EJL5C1NMVI/Tpp5VHDCNeNSKqeurRPr4G8n3/BFDmvfOLDLyo4p7bgBtvGeZDbdv7XyKsEFFVhgG0g8cogphR5BvJPw72sNSVOnHLrc5o4okAecBRLRMWSf0YXY4LfHNqx/DEDd/kOVg4CjnsLPmO7Rcf24G+j8s/qtdVzJMDsO7OzG9QlOxF2cEQLOkOXwPwJbbtMxCFSRYazO5MYRlhlXEfoS2WqflNSpNtO/kXDOCXCT8KiF4czdhw5IMfzx0yGW4Ie1PPfgeNu4oz/Tl9UuYkPGGjhy61Fv5xVCQnoOq9tW9pP1Qo9KA0KyxEjkkE1qCEH1eb5lwwBELjl9yIGYH/ZiLKZNM2GNFq2bHO4YHcCmoDwAfRmzw+EFKPSPqIIQqt3CQxt/hZwpE7tgI/etnAL37UKcbD+GRK4a4hHnV8mezPccgMvp4H4uWOA/7JGtpdcIhzWVc1gqkdNLonni8p/D/vnuFZZtQhkqXfGA35T5ae11f2sRY9n0G+Km0/obdl/D6Qd+82gVLKTbjaz/gP7sFL+xtDPCIidASEr+vn/RvuO6H5+SiPWIv+mzv9Os/Eq/6KBse+DtD5To9IRNjCVFeL2mb6FzRirhCLfehQOQDVxn3rt/Am6SfDC6b2ouvkRU3+mj+9kUmf+GXh6AGTjg4j0xaCrDeps1XJFCBPX6buD9+v8K4aKKrz2Wb1WkBilIMZEGtVB8ByVZe/QV0u6SZrskfpHrTepAEbJrvpBnNI6/6oRmWD4wfWmY8P8a2ak39wKREfhtwIU3GdgVMsPRGt9S+RqvxHdxPPog44N/k/UdCnM9RHaIlLiUiDphst74t7fzl40Sl1Cg/DI53V+0pQ6f0vgXcHztwZy+51hdeQ/YUTllXsTO8KZekNICkVIQvcjhQcxKTvwkl6Ds30jVtRGdYntSIjCEA9MPBfJN8fVODMaC4ehtybBxIjxNqKLwpbd8p4SLevZO7IPLdtya/vUtOa/GcA9quVWX93VtbdMCp7cKKpvW1eLMVy7HBtay626qlY7CBsSWzNwBt+NJRIbXLphw0IRYpiLpi+HagtUBH2rPyNFiVMqX0CNFKimms9Qow/I9hWLqYML/LPamDqHJ5CIZqrgZwJUgMclXjCZXeXFW8DUBPlskB+nQcQXIoWEID/C0Cn3oNrejTwamgh68nR7N4BwUR3ucgWFh6mSBf86sc5pS0+A/hzfNSzobUHxVvVvumqtV0cXqlIcqeweTU0RlnQoge4DF2HwQwnxMfkfBYzpgACan9ZYdPkTul+jm/LcYQDMtV2JUlfXcPGehVwrbBPK7Ohyfr2rV4Tp1FdXJwVf0v4lzfJ+Tga7JHyGvf7BZvg0boaPG6LmPSOb4Ue10SMJnBdbJnFzmUTNZRKOLpNo3jKhigPLRDzY/TIJF1kmWz1cgfyEIvrfhFsa2GF82sSSCzMvCtjwB8T2NBLbN8zz9TNFbF8TV7sFu3JNcFVoaCTeGYJJZck6e4oRbdMCohzu3Z8xwAE5r707Po+9O8hssvXs2eDnu82dWhK62+SuUg2sV1M1N2sUmf4BWT6NZPnEM8gQnvo/lizPnu01CXPmHGT5A4p8Giny757BU/kv5lPkjd97ehw9u8Nlz24icPLHVtDgVmWTV9AuQgJMKgJMsk8HahnyG9LdHAf1Ef59WPfzby9Pg3pRGsTAXKkSq9zH1JUqPjdJ6gsjST2fJOH/YJWLiacmpLlBPaLx9+EFtOnJFl3Nz5yTRDeq5MJIVVekmv89YFS+C0LVSxIqFOu6oRyOauEYV/knNdafO3I/lcbMf+AlZpO/ORB5ztSys4HsHHnZWVi77HRQ199Zp2ynlp2xu233SAHbEIJKtW5DRiwzL0FmcL9RNuFAGtviM3i7iGzcphgIpZ+XjTOKdOIypsTJLfGT0PzYovWokXo81o73queahLgNV07btx0vbmeDMnPPvpo+r17SZerGCj/uxmm3ajAWaKMoHUvfBEtPpOtH1DQhINxZNb2jC/ORrftO90MKyly3x5XX2kFsKzFfj+AdophKtHrVyXo0q76zv6rqr5L+QlmqhtEXAsYuTRwK8FUTbOZWopt0kvaPvQoCelp/Qt2rjXlFcA55JKn3tHw2WCtlRX0v4olT+WcNoIUU8YXy91CXzk/UOx5j5vyWZ2wAodk9CNl3uJf5XdQmTeGlIaMUQS2DBD/Y2f4ZdrZ/hE/ZM7SzgRBv+K4JUY8S4nu/B4T4xUCTczjYJMX9nhSpDp/zpHiaw/Y4/369IsXjy5HiMSFF26f/FDq+RkhxtSfFVZ4UD3Dw9zdJ8djFk+IxkuKBihRXo+5VQorHhBQfJyl+XdcLzOLPpfizpi9drUjxwDxSnGuS4mrf2EtJinYBKV4qpLjG25y171iY/5MBtj0M1REuUma1FmN0s0nr4Wsn9DkcosXp80CTPudq+jxY0acx4Y2Rt10OPTTEnlrRZ6emT6HN1roGobbX+bsZAk0Rc+0u7TsDis2YLR4pyX1X2pKuOxMia8vjFi74uCWPvfq1JY9TwbZp+TJayrSkTIqUdSHdIkQL68GONLTXl0InjqC62IY0I9XrIRhZDx1GYLD89qHy0cZAHC1C7xSgJNc4AsZh+8zecA4ZqFoChWxGYo/FVcXPfOB+T2bgafjgneFF7OEXtGnHS6+UeKlN2+XDzVrMsmZkj0YPFspG2BnYBD3gl/LTutD5bFDElVsTBa/8lYHzTnWhUOyFbLhm3mZbOZDIx9V6Y8cztTZ72Ohwxt1yG9gbOC3dBirpZULzRmieyF08bhBapdzXLnMftwCk3etz3Uzl95oyEH+sGSLKCtJ5vL1LlTZl5vwPGZ687+3a2yNx6dbk98FzCWBG1e2DjdsApp+71QioOTHjzV4AHqEZH7f5vV5lIV8jVN7crYaWU8AhoaQEF2e4rD5w+FZTf+Do8PbRxu01MKELWhUTsqaXc1aQZ/pyk8tVfrlJM2auxgAXCqMon953m7EiDmY/vZjhNLB07QvEfvqqgPqAP+/BLpPC7RVWrpuCoS31x6qc6EF9Pkq8OhaxpkNGVuO909dtvAqszj8lQ0QMpEoOxd213zeeGScXembcHFywZ8Zrggv0zHhMPDM+9M/kdfHQQq+LR5fwunh4xOvilgvxupj7Hnpd7KPzOLwuGv4Wt5jMjv3/2NuiW/krYG/MfjfQNPTMNQ++4/7gO1Er/7yQkv+XoGjKLcdMP/+t4OI1gSe4LR43IK6lNYHJ0udcslATeML084cXagLXm2NmgUxi8lsCnnV4ae575aow7PWji56JJxbXA855PeALRyMQ2Dv6HlCPMmRHdP4mDzv4znAYlXAOz4WbA3oueOF9Ec+FbxttRj0XNpvO4p4L0A/8+9pnYb35T1Y94z4LpxScFuDj450WTiroF1rOvBzm+0WcF+L5zgsnVO290BLvhVbtvdBa0nuh5bsECKRzeC/EF+W98IOV+oys1GXt6N/lSv3BlD0jU7asNfoHU/b9OGVPPIPn4Q+m7BmZsr97BjdG0Yufbk7YnJ+wU6j+6Ihe/CT/ntD9/A24ed9yOpX3na9e/BR7MNect/ddvDLyfZy3UzJvo3rx92kO3UmqBU9o37tF9eJvlJk8NW8mj363evH3NS1+Rxebz+FoLD6fp5p6x6P1fJ4+H4vfyabF701BZfG7OaDFj7pqWvyEOVrM4vfkAouf5zmfXoufHrHU6Wfe4jerYfITZpUmvyeV2PzMy0fNfjZzvzFdKndCia5qjgmzGoY/qfL/POPfn6lzW/9+sFl87zeLyoj2TGwWlS1qNmjM6Gk/o2eMzF7DFvVV/j1VzejR5Wb0wfO1RZ1hH043Z/TBi5/RBzmjZ6oZbdqiHpQZ/SrH9pT2vVvUFuVn9My8GT3x3dqiHjynLerEYrao4RAtPs1nmtN8op7m2UCmuTKpLMWWLW1SOTnfpPKm4Ls3qSzDp120SUX4tPMxqSzk0S7epHIevNd8k8rcUiaVTTSpQFvPuKcRbb1X5jS19WGlre951AwGQamR3zl+j8QKTiJW8K+86n5TI3cAQLXNUHU/1NgrH3WYKoFQiahAF45iDZyFCn/1TkQ9hMzjxBIPNYs/bKhPRbm3BZtNTph9/nx7gK0e3IWwGu9gOnu3vs97Hpz2i5q/8oNBR1Mtu7766oFobcYw1E1EOcnW1+wJgmW1aORO6/yOQNgBXR1lz1u8oMRkLCwuZOpTdQzHWA5KCTDWYiv5uB9dpGbgYnMfu1//qFLP19dY5e6/X69XarO5Ctun6ju9x31owhFSJMzfCdc/5O8UYADlnt/nH9fFToHyVuV3BryH/E4m/x0Wx+AZWbPP71vozhdsank//+/DpasbWwxmlxaLu7w0pmQk70E/CC8lyB42YDxW6NLtBD49wsSORmCyfoQ+YjQhwcw7G06TOfqhxu0qA1AoocjDJ43waeROc49Xn9LyjbXuhHJncHN2Vk9PYa549zHl/k4BKQC6/22jbC82OGCDh5s9MLiYyoykQQIFpcB9AY97U1D5ZqjsPylZBIc1EnpY8rM9SR+Y75Ckz+LZaYZACOwF0RyUgMtZQ9wDydhq97gzSpxATV+iuf8y0GlDbcvoYoKTwvMuzt8KjMl2/mUEPGY+3PusYXoB4M0QqFsNk1NLm8qWIGsMWwWzg6A73ML0GTRmlKnn/FKb1BPQYgdty7e+VQE34KrRgcxtWq6qzLaA9rxMiRZGADmIrMnvDoiTHudvCZjJN7WtIg4QWxrvDoFi1EJXWU1+N+eLNqO2TfMvGs8EJ/4nQ6JU9dHEfzSxHXwUgHptniKDnf0ixVcxNjF2lVtM0a1eG/OvjdmuhyoDDpxYbkCZhE8iBJxmyxDODrQH2+a+Lqrh7K5hMH66rkoVTt9cmNGshhZcXe3311b+JW1bVMNDJwHIHqBsxTa5aopplmhPtFH+rqCMaSbKv6Q5aAeitcR21DaptPjME3418RpjEg0K010YAD//I7BELPH4EHG2Qcnpsl0yFnow5GuJKKPzR4KmOTh73QjEQG2xoPr+VwViQLu2T8QjEAOhQAzo/PVGAAZeH5XhCMCABsAA0aFM/hYAIMB1lAjmNoDr5WurcOCOzvKeyoaLtCd89FphKjpAYKfS6XS14W59zuXBL4FPlf319IpF9levUFF9+evWcIc9Ndxhj6s+0Iq4xcYjWyxeIut28Xvsab/HXsxZob4Pz4rzmAL1fToFfxvoeMZjzdVNP+rFPbT941Za/t6gSMjRHsROcTsZxMjM2CQk55Ry3YU/GawHjW82Vkq6Z8l0eK4+v9ODb4Q/GWxapMQmlMg4TxuBnAdYvb7z4wTfgVReKluSscM968XhlqVakkpL8PbtAKGrvpIfHjYin/8QQ3c4yMoI6TCB9/ud0btd539t5IK4RwKmk8jMtIdtBZE22hpLHPftWtq8nSzBcdUXLCgko4TXQwSvh9hGw0+0cKZe4Se7ZduIVKDTJZq3ZcCH+e8G8i+nmfB1P40/W4ZzHNNijz+qAsHzsCTHGaprBCV9Pvdi3Gy6kHv5jkx3kwFOyU1G9D7v+TP1fDU81g2ZkyKs8xxyNzRLcjnCWAm2igsR0f5x5b6kbDgFrdTHlPsirzWyjrtHcW3xbTI+n1Duy7gDxod3d2Rv03UQe43j0xGgu5SwPZWrUAj6CJqcUiCcEkoC7hFQik55YLxSoK99WodSYb7EVYsMIQ8a+LuCl4rrLTqufJDquKb3RLq9JMvTpZqxycykAvPWZGbiITMTLzzq43qcUw+/ZFPBAAbaU83QpIsxNEtVl9nUMzRLlUiJP0ZQPvAtiKgHWzEb5J9gckFhIioAOBbRLFIk8PK0CVNo6Wa5JuuHLC5kgMj9RQLDmA76dQLTGKxRFyzUmMfEjW1CrDos2yH7JJyTRzaRoPLW8EaDdxoazsfQv47tNHinjuQxzZDOi7xTr3ot96/ltketpLi7tMhbEsVHwtttDIy7WBjV50Ga7eZvDobs4vDryZAF49wLlTUHAjCGwgmfmyvrLcUML/pBTkMieHfZgVAOh1nTOBzOYD87I4fDycvqwyG13kQDf2hqD8wMkxhxS05k6xr6u14BexOAPvmOexYNTGeGh4DfoS8PXiJusj+/SEHsszguYtmCZ7XoZLgHz2ruwS15rWwjnMzG9Xkxv3H4RF554irxZBfv7fpzw2Pj8sDKG+vnl8ERh9MjltOjJf7Xfms/pgksCCoFbh9Pj6zR9DNqpOmJHB/HfPyCHB+znCPC9srxEW/rSt6f+hvtzLMRPD/afiUp902eH6f595TyJwgueITQ3rYXf35teIQkOD1acoQwK0d9hBzxG+5czbl90nNu/7dV7hOec/v5eTwaD68tAzfJA+2EZ3XKmHeX4NLo2Ez6EabGU1IoN84acjm5zEHeB8ZdZBFe2nebBsxXPcUFVDM+c57xeTq1QDcH36UW6P3n0gJh+X/Za4HuPacW6MeWUe7A126hfmeo0aHFJDvmR+egns+Zk52pWPMD+HFAn0uP81tcG7+lK+78gK6Z3N/SS7Hnv6WX5s//8BxM7gdkrgXu12RfmK9yOFmdvzcHS6gc3hTUKgdmyLhQrcPrRhQBYaUIqFyuL0TrsExVXuuwTIkL1jrQT53HzR9doOIhrBQP8vmlFQ+vG1E8hJXiQVKVLKt4YOMW1z28byiltxbXPaRD3UPqzMvLFCqCtKGAwM0FOogWdRAfvCgdBCpcVBHRWloRETYUEd/QTU139mGtI9/FpFJERF4R0cA71BXeoVdGxBXeofZ4hwHwDmNRRwRNdQRgT3UZgBYYMRBKXucaNZegt8wEE9kwW1uhH8biwTsPAxGKC+KiJdUm8wEvJi/JTiyjqhCT6pyu5OQzwy1kTi8lJ8/ppeXk89xC/LF3kRui+j7dEM9nJtT36UxUGovaaMu2ezPhohqL48j4d8ych8biuKn0EWJyXKixmF9iocbiiFmgsThuLlhjccz0h1+Zr7EYebiYxuKYqfhBcxEaC/HtMgs1FsFiGotj5vw0Fvcvp7H4wHyNhdhuK3bzo/MF6OYBfkEC9OtG5NnqyIrrc/kCBehlqvMC9DIlvlcCNHmZWoDGVn2+MnSTGbgAMbpyiUfG0GXF6NeNiNFhJUYLZvR8MbqOYJFxqARp9nUxtmvYjmTIWlABRcG7VZXrMHuNNLU1UpLPPeNiIQ4NR9Iwl9LeBUL4MhxKJU0fbm5cd2NV3B0sLk3PItPbk+aCpOnZoBKS7w6WlabnF1xMmj5tFkjTs8HFStNPmv7wc0tI0yNlFpOmn6x2tifNxUjTT/q9ZYE0HSwmTT9pzluavn9ZafoD86XpwyPb26e8NF0r4WtpmtJ/JU4f1fPYiMM8ig/rvpeoj+qGRH14SUaCji3zRGpU5WXqNwWVTC2CtZA5xWqktv+OZH04GhWtP1A7MvOEPumz6NgqKtAwCpAhkgwGFA+bVEBYCi1X7wx9pAlA77nSY5tg3g2TVqfgFxhC+DlNfEjZCvOPBe4520Of9cjgDYTDtH06TSNFypb7GO31LULib8JlXBjrE4gb9C/Z3g1sixmofcVYC6DfFJxIut7k1AXAN7ntNQLrxjt07DKQskhJGsmIpILj2octJtI45o1KFimGjHhBs4efpmeolMHd/DM6P857/IVQaCZl0PXTx0zV7MdMNRrMOramipyu3XYYuiSRftWt5tgu8ONB71mVFZFlgqKEU/UQRCoLlTOZq7UOjIjd+jv7/+Zdn/vjT7/hT5VsA5UyBVGoaZ84E/mDQaE84oTE6jaLVb7mKRx34BQqOozaS+XBILtm9JsgsXQEt9yHwirRwfDDAPIP8j8JEO2aNj+/RYk/0vCzip/FfiS8t1NAMYfOy92FBHtcKJ1fdsmv0g3mQlqTj7Tm2Pm0Jqxac9DMb807TKM1HWnN1efZmshNjrTl0wvbsrWeFhfmn4EhJQBTFFZqMne8h2TYXx3rM0nHY8jZqd3H1FVT7qtjA7bmY0MTTa1vg1pAu1jC4ay4a3N5u5B5R2dz4qaXCakfFpck/1iAcF0UJyy6dpsGha7eFYyCUHQqw/djvh9USUzQ748Bxr99nTdJOSPObvJ9hq5LimYbyyKIqqDFt3bruO8EkGGyqfnYu6Te2xK/t6Vy9c5wJCvSef9P0niM/aTSq8PV0eo4Wb16dXv16tWrx3r56tWrJ1aulv+UNkGwerVena5e3cpWd1Z3V2erV4+vmFyVVaSfSOR3aNP8T4LOmqwiwsb9Y0FnNY7UJdYg3OtEC+L/yBrcbNZ0VmUU/pkrtarOGVCKTzVmZIaRT+hZuwQHbpqhz1UiD8SFSqhxZyXAA3/nrz70rge++sk3/D03j9E2cZgT2T7w9Um+8Ht/8K7PvfuTb3jsPF6YyDjV527u6qvP0dYV51uTHjBN4bKVjaOyS+dVFixS2dfMudqVC8meu12d0ZqYW3p+ZT1UFp5HZc8/V7PGyKn3i0ZCD008h8rdc7iIU55+qjr6lKx3sR9LuUXOKtFnd7ojs8KsxQ06TuUseYJnGFRWT+jB9mFVbKrkp5EERDgb/WaL5B8+zRm25kGpuN10dnSr3EcSQazkVugyZlykAZq7YKeDEfgzYehUzybuU/fr56qlaXaiolkiCZy8XzNYFyk3T3iucIkXu9WL7exc0/aCxrRFi01biwts5DhffoGlYvMYpRi9yKfjc1FMko1uR96NN1adZJmtas3SW1WUyYHX2Pc+HXRCuTva4NA3eHjUYYX4Aw2B2rF7DoF95lGOEHftaZ662PcXdZeaDa2OOQO+GEQOPhbR5oaJJz5bl9o2/ICtPKtFnkRG8DXI55UIaxZeEON98sIZ70drxhsagc/VjHe4GOMtRc7BeKfzGW9560IY73SU8UYFjzQZ73BRxluKLWC8H5rPeD+s80eGjPfcPMb7YfhHVM2+xVSjUTHecxfAeD96wYz3j4Px/rejKDRu30eR0vTyANluZ/11bmN35gG5Tm3sTvvrUWY7JsRL/llhyK3wfT9+IQw5LYufPRdPfnIZnvx/XSRP/prgYnnyk8vw5CcukievWnPhPPnJJXnyvzoHT/75Z5Ynf3QeT/4wePJHap78c0OefG4BT/7QIjz5w+DJH5nPk39uSZ780WV58lOeJ9/SH/LkV9Q8uWfIMbipTb4/WPErqqPnf42y4vX9ExfMivvVt9lcMcKNXzE8+D9/0dy4O3N/ta0k7vT91baSuFP3V9tK4ubur7aVebwBzyffNLDq7sADw9r2PzCsbd8Dw9pmHziP2pp8/LIdvSA+/lxDdkF8/BVDPv7z3yUfv2y7LpSPX7ay8+PjrzgHH//QCB/vT1Ile0STj3/0vPj4K54+Pv41wdPExx98QLsN+W/rMl5wlG6oaJR8+9wDmlh6oPITDSo/vgyVT1Y1tLNzzdd5MfAN3iBp8AZJgzdIGrzBMsuuyd1fMeTuP//PyN03dr8hg1/vpn81yuBfMWTwP/90M/hX1Az+o00G/2FNfnnI4M/VpZZn8K8QBn/LgAz+zVp5uD1J+W1gh5AAU7AK1PEj1JNUmD8c8FYR4NjsFGGz2ZqL1afplNcDH2ooyURlhdJd2rcHTt4C/5b9p1E2RoJXYoTTjyFX+pWqi6GDnBqRJ+6CmRnr548gXwTYEZEP3khwwr6PAc0T69NuSfd/Yl5+c0XRt2cFB4B4ANa4XgVfJbhiWQiO4Pc8NNjBYDhSB2FM6wBZVVeAkoG7Sfv47BQpCgI4HwTwTqgHMPAp5/mMYeou75dMo82hLmkd/QItdjQWNgc5qadGeQ/0hMG7HexECO/JYZ+3CZzF/RjHJTIeVykFxd1DDLbfeWG/GFguZE6946BkLl10Tg8GMqdVxkLz8iwCYINkDjyl12Yd2sbdxvxdgf/xmzfP2s0KRQTFdFjkg8HaRjCiEe+k/FvaM6WM8Kcx4LlGXS77gc/tpWH6fGuUVRP5mI/aXhoo+nnYUL3zDFxbxHz1BUkRsh8GLbF37de1D+l3COj1uoaAFl5+v6TqlU3m9boPBtIqdysrvMn0868EEuX5rcuotXkNnj5+GbU2s5rWs1mW/S/8+y3lkXc3SvNSsUNKy8Toht0C83CrxCUP3F+rF0NEHbln+vlddB1O1huicCfcWjOsg9fjyDRuo9C97uO2HGhBVXEozmBGoDJqvxJY9fKjRpAnYZHshFnEMPFv0ZY5y2H7zUB8aDeq9vATjeTvpM4q6+U8pOgREE6PFB36WYBxVAygghMdZnePi2fH4bACem5vNneGgnpyN+BCnrfZ/BIxSpBSOeNsZbS0fsGUPcIybzY3abzg9mOJz2r//JQuxm0GN2NcjtkM7i647NgMjiindNG1mVvPq9xmMBkXbZu5b6t+scJmGJFiYsjhZAia4RkR5H8LyJgnAtvmsG+WvSj/ZmC7VudfgZ8gDP+aTr+207y3wlbZJSbq7BJasGbG57/7kLFjzXsm/ztazdGCb/2ztSDbbNZVnsMtIiOKk+BsOF2ucK3riwmKkAzitwY4rzXaYbid0TSZuzv0el5HJqwhZnEarO5vUGos0ioMohamNtjeBQ/S0AkzxwR8yPKvBja32Qa1Jn971DGjyKUEmIl9DXFGJ8vh5+PRKnFjsTqp8+kIp9klm9kF54g7gIzNn4AmiT+Z3PAzQJKAE3iHMA3EGvaJc73VqkPHGfjE7JoqDBiqWEBU48x2R1/a0Y38S1LEdm2bn/TvxpJbmLl66+8t+aVm6e7C0kt+YsGQBnQ1IrtsdnIajZ3Aj+0226h+w6kd03u2AfEns2Pi7S4jC4j2/GsBOW/BMLJZf6P6z07vggssCMCOERUhJ1hQDmd4eh1zokKPiCAmgZCICFnzI2SjsvUGkWA2z5+gKyzga9/u25BjOw4H+beRygC3i0m+zKgwW7ELkyhs4GdBH8RKsjFUDkujSjbLrDdrOFfrDfzEJMfRGkA1COCpb6BHug6cfllXD9ubskHf2dtSDMpabHPrTb7ZrMnkcg2jBBqD0nxBxmVkNQ0nF/X49sjUZhWARJbZFVC8LFVlsHCyTeblusan4L5YG1iNrEcCMQX49p0hiCol/NSdYT//esCHyATRIoMpUKVGYK11H7vaOLFlNBKGahDR9dUC0KjxJmQMzdabWY2aezYD7ybIVfnjgZTAMZh5+JmbtMyfcirjqhwmVahqw+mxvcpQyqqtucDKfXXr6A/XGKLPCcNTz8ZG9Z8pSCyyjoJq8VX16AX11AMtziILawmJaqsWH3mffBwJEThBQ8jbUAL9+GEoDNbJTteG0ILqUHzHYgRB4biN7VuT5YB/nw13L9L0egjaNvS7zRLj4EfBMxloiNOF4iTJBGzvVlhdVP2PNx5xbwFWENbMkAep5DVUhD0AJ1iXfzv8O8a/4/zbA1+SucMhtas9jkJWRa2iNc9BUm7Cwp/Q4m0oeBo8/0If7ZqNqfoelLQPavH584GpPn83nX+pyoTMMCgD4aJ3MhpW7yXwWFYGTttgqlJVxF6+sJF73vZwBi74uJHZIH+XLlPGC9EZUuVngrUwMWyUZoWQA1I68YNlivK/D2yEzkrucBh7Bp4eRA7ry3EusYNk8j7xXfUi/B73gr8Dd8P0wo78aSgK79qLnzKF9jKFFplisvJNp6v6ZO3FndcCRe791pQIviKCiDCRN2QJ6N9hx4I2QmFHyb8ShFuaklGcfwv7ZsytUXj1HkGpBQEidip/g5FUdkpkawMx2j/aZyphCTJBDxVZyGC3mPztEWiXAb5MWYKEJ1CtgKgGUEBgTXqlvcHKFS2IJOkb8vl1sAmVLHTR/qYusMphlPivpmxh66QWJkQIUdiwt+6OnMqwBSCCxgx2SfMQ89S3egCRPH9zlMkLpi9ZB0RyBUjYaytxoxk4nlQoGUk1QKwu/0ZQK2U0DQBo3d/qikmNbVKGbGP+hM7fFq21IUPmfGRKVsuQEFGWkGHI2Xl/Se+iLsEUYXYJVsS3tA+5eYPpZT72RnIlHPlt5koYwaHaAByqkTsWdxrYVeuAXcX375P3f3K+NoR7TEouo6zQmWQFQMDXQ5z1SWxcSjARlRhF6oCgMwEkTO0XtObSFrDEv/Xi9+mwiXYYerTDcCh+C2zC8Xni95Gh+A2YtJO1+P0REb9PhdWKOdIUvz9Si98PSphJ2M//cVT8vrchfh/WtfOqch/QXoAVlLZzi98PVqL2a4Na/K7vmZcvK4F/5BwS+IMXIYEfrjrgjZsh0Dh5A80Z6rm8MB4uJoxjXGXYHl2UkE+FRQVdNxTGT4dCyX+fn4cw/u8XCONz5xDG54bC+PGhML5lUMnim2pZ3C6Qxb/pZfHTS8vis+EykvArw4WScH1PJGFMy0SN+3oOSbh+tymL/+Y/WwsyaC+fBln8oYuWxWnXoSxOwn6ScvN6k+eHLkAWf2hEFvemonjROi9QFn+4lsXz01QzGpF2584hhRvblRdE/p5bXv5+WFf1L1l7Va47v9wzKHOPipfnkLnf78FSGrLlUOYWfxmRue8dlbnTWuZOGUE7Kna/3zcj9WL3q0KK3e9/GsTu9f6s4yR5sfteL3bfu6zYrdggmw1l7nSzybNa/E5HBqUuPSpwe/BOzGk2bIXMadZoQy1sL6jr3JL2Q6OS9sOQtB9ZXtJ+fFTSDitJW/aFRSRtCk2/9nRJ2XPPoJR96Xwp+1EvYsoU7F1Wwp4TCfvS+RL2o00JmzvPhUrYjwc+0VRDwg4rCVsiAflhSNiXPp0SdqP7kK6ZQ2oZ6Xru/KXrfL50nVfSdf4MSdfPrqXrx/R8uRoU8MlIwvuPNKGaDwfCjt4XLC25teZLbidHJLf7giUlt1YluR0OwISeQ3Lzuel8CPyI5CY+XtyXDiwvub3O5Ie85PY6ph0bkdzCgcfFrSQ28vwisYUjElvalNieCmqJ7WxQJktKbLAz1kJbMk9oS2qh7Y5aaMML8+W2AxVnCg6jkttSL3XYlAPA6uYLbSkb+Jem4mZSimxFm0JboWtJVBxQ86cC5KbLn9ClGeCs4X6GZpWBNAzMWP6Alub3S51/I4D8KNMkeAWJTJZPqMdyNmAnHRrbzg9GNXqBlxjTWmK8L6hIY3FG+76gITH6qL8jgfDZU1rPOJIhqGjGqvzbCI8FuHHWEsHsC4FIf8dF+vuFOtWVWTcUN4X48PZaG+R3V7bUURMrHFoABOFpVNc06u2s/MxR+cwLzkfIrOzR8+XM/+2zAR6vl6gPA43hc6IE/HmzOWnkCgC2t62UIfpjEc02bjbwJQXCOoW20xK72W08mht91JbLokXni8eQTBAxkskwt2rM4DN30mC+8b38cFAmElHaJcI9I0rbNvHCXjt/dYhMABhcBrYTA162jxO0JJfj8l4JN/i0b1uw9yYeXQQP4E+ycTtSDYJlr0DNRUT+DP9+mn89gHhPZD9cenxDXGYCTZjfHEr3Edy7Xjq/iX3vmBlBDIT39VXgt3BGJMgQpvf2bQoljBTo+3OfBUbum35W5KyxMDb32Rg7Nvdj0eFp5n0vlVvn91YkuURYNVQ54+zhcclz/BnmOf60tj2b2sxjJ76GKKf4sQ5/LLYLoDEltsNTgQdE6o+JIYb7O0PbxvOuhzDk2km8Ii8VYtyWfd7UJAtkgBbGBJJ5/rdBwb0CKQ7hnoxsH20vneHGNwMi1HxFS5A2hge394Xzyj1sRsrBVUd58ykEAzGfouBbA/in1wV57yEDtJzhPeWFRpN/6/u1eRnj1mVrODWEXVgp+4H4ocyG08XqYItd5cgKebEl3GJX2q6XCYxdCZ5f598GvsDbA3H4ea24vQdEmO65XE6NHqCmRZUcWZWxyEqvth2RR1O7SmRRpQMTRpn3IwIbEjZ+wH9dEPrEYXgeQh+4oW7+ZdM1QxPokmUNZMkvo67VOGF6ZJg7+dsC2xntFacVe8YaGyIkPSx6PKsj28NZHYPB7A1Nlz2wPj2ejmNlzr2DxUPbu7arbO7LDMoeWjdetW6Fb90KO46JzaHNzVlLHs7YmBpfHOHFCiIl8J3xqkeyQ43bFfNeHbctmC7k6xLEsGm58eNO8mUTzriZCPyiIEBk1DXkThWTgdREZjW3E5jlvFjRqT246yaN27ZkYFkhe9Mk4qQnd7P8BL9jJ2WC3FmIzG6meRtIGBNZY5jyhfXn6CtGrciF9V4jc3Z3kNlVuL2qkfPX62LXQxf7PGpN89dFMF3gH8VEsMridBPNk1X5bXLm9rNDgU7In9Yh/PcNj437xAGpbSPRUkS1ib9NdT2dA5Ar1tjMv1lpA9/Lv++pXJxwMHS8pvoU/U4pPZ3SJc7PJ9XwuFig+8TWiO9j47wBhBAJg4if9Ix/AqSdyuERV4fEDdXZwefN2zg60qE+NXVfVDuJCZL6w0NEoa4S1aQhlJVVcnhEYCD9H1TZZscPyynyXp4i79EW0FLUyt7QOERCb+CRQyQS3irh/hU3pA8Z9SpPB6Ibsic8g3I4XYpBOZIgo0YiV4szKAdR44FQRvZg2GRQ+Gj/6KO2XJ6bQflgshSD8sHEMyjO7F2KR9kX1sS2L4SMIzzKB5Mhj/KmoMGjfDCZz6Pso+J4ln+fJG97hn9PBTWPciKoeZSjQc2jPBj081vOwaM8GJyDR3kwWJxHwf2leJThcCzPprQ4chWnwh6uN0/S1nkmGHIqDwb56xbjVD6wLKeC0Z7HqRxOm5zKkgzKbHheHMArw/PjAKpyFQeA7U84AB7oy3MA1csNBuU3v1+b12RQXh/XDMrkfAZlFaedfMrK+XzKZINPmRQ+5VWh7ebvX4xPSSo+JVmET5lkQ6J5bMrK82ZTCFjkT62eVxv1iJgzj02RDOFLla3YlMSuoqGqyaa8f0k2ZTXYlMSzKUnNpiRDbS8QqwSI0Y7J5sGXe3asyD2/ktT8SgLwQtrIVlhj0cJyXNq4QvgPcBx2XNgesAbbCJY4LrGgVHmM+/qhs0MFxYqKbenZ8UYlKzzvZKTqHoGbhINJKg7mdSMcTIXxJPBSS/Iw40gL71QxQR4m2UETXs+OgwJ6IzzMEK+qLWo2z8NMgIeZ2M3y48KsTMzjYRq3wcOMZ42h6y2sn3hYK4YMo/GoVGtskv9RAF5Z94uVxMh6l2dDTlcyOPbv6mTAVn5yHhtCsiIb8jrTYEFOce+f49+T/HuCf/2+3xEFSMWC3B3ULMidjdNgWRbkzmCUB7kzWJoJuTNYnAu5M1iODRmeD+fPiXjNUVZ1fr05yYPiRDBkRu5sHhQNbuQDy3IjGHxyI6cD4UZC5WZE2xPlfxNk79Sq4WFDjV3k/eY1E/Zgt9I2GvrNR3WoDcquN2FZIX8SIwoeCBLxTGzQXcQUnQcCGi0CAhoRuVT38wd0BeGZeS+arKAW56OS6glJhGaDHcJQpPmfwDCeTSnxMSCX9DUp6E58nC4Fv1FHm0q6+LlDtEoY99gh423HoRVAZ6qYUmtKRAUUotUqAloMA6YlqiIG+Irswagv/yccL69kAkEsebSECyNXw9lijEOn8rXIb46yDXK5ViZT5TdFaMHa0Zu/HfJm9m6PNGsreGXRq7kflRnSTGkn2Mql8Vq4sDqbTJV9gHo8qAxndtCTIAVYV5DfEayFehf/iiOBclDNZ6LuYFiHlkHbNM7U0zOMR6u1yX64fAC304Ps0eEZ2aLu8K3h0K0nYQJT2xL9nleI1oitRcIx/e3Qavoy+F+lEEipdlInbsnZ0C5hBiWnNT/LeCmZVwz3brI8t2Iu/DQxDWnaL0IzU33E9IuoTq+DNFVMzZA/GZbx7lA+flNUAj5KX08vMybRwKgHjHVB658UN7PMZ8+xcUXDReQ/U8ROVZNAlASZP4T2IX8qKvnNSLKlhgxfCvN9kY3yp0LY1JhTAoB/QQWMJlbTGKXD/LURW+U1pD7fUFioZm4KBhsFngcQR7phqopItNesreRGD6oHLKCVpYbG8Dh/ZeRPCtB5IGcaz4a0ZjBk1bLf7wj9uK+1Yp/y6lw/R3iIJRgNynAgOS5COXdhmwrz39ZrOXFW5d/QeEfMGd/QfratyV8bAa+YTaJBUEY7n2Vzw0LwjdE80nu+Dx4M/O3CwWaT1iebfyqehajW23lJR/mroyyzbZK3xA6ZnUIaXKO0SFSfLoxv8c2ceqT8DbNMuqHzt4T8VvNXfnuIE+ZMIFXwtqzaRODSE7FjKM4DCguO8zA7Hr6fTSq/9zRT5F0mN/O3hwzvqv280nHsry9HQhblDvidlTGvSKXCVbGLR4CpWjy8ZhPEHUgiu+DGJu4i+TtC7pEont8Gj5F/Cv2mmd8UYRStEkAJaeOg9A6rP7HMTjjcA+c95QDkbwNtwQrxR23FTHZ33gauJ9ziDt6G6cHav/02Y2bcgerBrfWDE4dM/sYQ//hRqAPbMBVbBa6CK9WdwqTKMnWn3lm5V3Em8idD96ydPnoOL3qid8/KnwrZRdKuqujzbChIkWTg8tnIPSu/NXSn32nc1y7Lf2htRUhS+LbQ09ObQnfwIJt78KBxD34KzeXlqVtNfiDM3xy6u+X53QeNe0ye4/J0/fywPP/gQWm+u++gEQiWwweNu4cDwHunD3lfYj54323V+0fk/SMHjdv/CZbG5T3186Py/OhB4+48yue4/GD9/Lg8P37Q+OPcnTgInFFc4eaDdck5KTl30Lj7/pglcXmsfn5Knp/C5/+Ez3H5Z/Xz0/L8zEHj3nNCPV8r3HH7H2TRJw8aRBjy1sn6lX138JX9d5it75mdnT0SXW4Ubrr75K0Dd8hbuPVY/dbd8tbddxh306dlyO8w7sxwyOX5Ydz8DJ/jcva3q+f3yfP77jDu2GdlAu4wbl/9/Ig8P3KHce/7UxnyO4zbXz8/Ks+P3mHcLZ+XIUeT6+fH5fnxO4w7eJLPcXmkfn5Cnp+4w7hbH5IpucPQMOcnQp7PoVEPy0TcYWgf9BMhz0/dYdyT8hyXJ+rnp+X5aXx/js9xOVc/PyPPz9xh3IOP8jkuT9XPZ2WFzh4y7tQX+ByXp+vn++T5/kPGHf8qn+87ZNyTf8ZL3L3nz+u7B+q3DshbBw8Z901568Ah4276C1lTh4x731/Udw/Wb90tbx0+ZPLXRPjlTp+QKT9k3N3DKZViR6TYfYeMu+WvZGYPGXd4OHNS7CiePyYzd8i4M8OZk+fH0bAvyswdMm62prz9txlsXGzmbYbuXNjZcJ99v81k+aEQ26E8O3ibwUaIZ7ffZjKmJOfum7819Cg/nh3Gdv3WEKG5yu/3z5at9e7bDP4v50u1d282YdOFOMTRskWLBk7xK95ZP0UMyMsRDF/xizhGpkPxwLCq7zUcqICc+lm1O5zxmxGK7u3/qFZWTzu1A9aGbDtOd20lnxcrGX2Fd+QtlH++hpLGIIq54SVgsp9W3r0h2OH1LO6s2tXV9ZeH1Vg9TeelyAZICAyOpjBU5W9THiY6EANEXY1aqhpVvc5WgMsLsmfhNJc+zL5L14c7BwbgNI0Oi9mgVPOK0x1gb3+oLBrta+MD+//ggj5QFT/HB37Y17B9m0zKBuWVY6GMux4WnRCgBe1m9c4piW3JfqL5euhbYMUfeedUFbc16udhsufSauJPMPGyTssqY3iHvofipyAsw+9VLMO/oBz14uZoAy9sOCC+VVtGh2UDEEBG3wM4+XBUGNva7OrwQ/WoX+CHqvfO8aH5w++9twVcYbRoRwkoglNXTWU/Pjrugf82mJ+rRoe9UcMKVeXqSJix29F7RG65ILtcNWECQqISMGMJHUUkN3jaz5/S3qFExJZA5ugN1Rx9KNIdL0iOYVcoxE0ysCmTlhcpIeXpKg/RJ+wXwtRLk3xrgkpJyvUJHXCMf8ZETg5SB5dwQhSMy6d665To/jq2Bymv55EUxgFvB5GgWAHkibI1KNqwP8pbExRIwSSXGZqzAn/aTtnWVNENttgJdLpluy7cOQW3NpV/wJRtsuZupsihT22FM7brkFMFnrm7gFEnr7UpDcFhd1B0gYHfp8W1xXpEpZmhgrbN+/RlD/tFBv3doFyB7Cm2xZkV/fGEjHVetOw4YCB6/N1QJgMAf8yoWFcDWXmAebfKqA7BSvMjYZnCcAQygMhi034Zibag3t9kGqhLkzItX4YzYarpFBwXzmoC3a9YtYYfQUIbZ4oOtNRjrB3qMUhpNt3Zhbc5AeFhlY38l8qOt8p2ABQCEtGDIm0KMBXMSr8UxVAhcBY1fUUVfYUVfdGkG/qwDJwbRQft4ZgC74iCmziNX1nbYUS7wBTZQ8VBlR47/0CdFzuooNY+HdeUP7405fv0SCnTSCxB+TMLKH+8onyh+hXymRw0Ad027Fxp3+a+iStI9UUXWRQAZZKKVaktpD4m2XgiRq/MGhtNFdDntZlXbKroeZIaoyfuNqYc6jpzfdmx2c7v0Pqr9O7prrE92waZZ7aD/++esjo/ZspOtThaoG+YeDrFGMg8c5jRHr+yfaqcGBSZ7dkJiuI927VjfRYux5BZaWyKS6bTL1pohrYZV8QYbXdcqV38aRUd2ShsD5mhrM4PmxKprJyhIqpeFzGye7QpF3boUFqBDLX5URA3BwWkx1gTPSgzBggULbxAGwNa2cJa7hQt22WDqPdhFVylbbefRr0VIIt8ZInaFgfG401G3u1XFqfTAqNH+4rh1NnxCscofyAsI2f6Y0GqjK4XJuCLCgYgxFhUiSwIZmBplqkWL3VQw/Ub1At3SJspdbpOS6gkvruNixfGqKT6gNBp6BnKxZdfXBF5VBG5LD85ZjTGs7kUoZcf986co0vxp+Zlq+eJBKSvOlN9WGE/5YexHMORNPVv0CPvy/fNjDN8vbFP4YxkqMRa9J45vq2M0GBXV60VlDwTzFg4YXKvqgahHMaoK3+0D+jrKHsVmd6sqFJdWZP9kg5mZAWbeZhoHUnAp6tNprEHiXqODsTooPd8DcQoRdaJ54lGRGH+sdDp7Vm2tfYElS+oBV9QLnTa7bvVCNc/hX2tUb3J3ohwXm+9S2H1kx0J1CpdSJqTkyyYnEQS5IKatXvsVmP1FKapJUBGUb08mHxuLDAGVpeWJGAH2cDOi+guIXESdjtbqRbpcXZTXNsMaq9vMC/RZpNSZdbply3hfKhWTWUF0m9a+4Qx2gbX8lQ2nSAT+K0f1aqM3NmzH1W7uoLcFZG53uLoMs1TptQDxApEwO/yxKB5cEkupLO93XSOroqaq3AqNYu6+Hp3RO/hUeeLNR6+aNrN8qGv7r3BaH3Bwvo617u5JeuLrx9WeT7fuzeousvUd+FV3QjjAi5o9kww7WbvC3Z0q7Hwz9vubDJtI9feyzI2ckeS6dK49t49e9zsbNivhhQxv874PITzmmLQVOwxzlzvTi/RXuPCvW4TvmCud73pPUt2rI3aeijIF+YXjHxBtH3eCMweCXZ2w9ERD56REc98XAjyjGivqHcGia417ckZDQBKDhuxMaZVrChNhQ9Hdfz9kqug01gFba4COXm4zukgE9kApvo2jaE2vpZYdJmNkEhJ+5kLLTx2PL6BIyqVsRryeuQtsNo9oHeCVtwjWhJFRST+CBXpMnVHNPq9gzzai6atdvFed6Q3vafxjbpK46t8fFhV4KvCfoIai9THK35NUxZzc0imaFM3p6fdQb29a8Cgys9Zvb2reUzVrYigpB82qYUmoV0u3osNc+8eaVcwvbBxgW/cN/WubuSQcIwNDEEm0UYVSAOBDcB2Ro3YytN6MBYpY4yGQRXBqwJ/fW037cgd36JEaLFq4GjTGy0HqKSRb3PS0I8SNu54b9l1R56NBdDZ62bnehjxZLrUbsXePXv2+F4BAjN14fUuwON0L01UpUb1e6x2L5jes8cdOav6bvZwsAe9bzOljTAzXaxy29qDLWHP87W4WyE9tHjutIWyKwNUYKNd8CPIKvp256bv2VCHTAlvTalIAqqKgyPJhuKcopqUqkj4ut8gVhzpQp66QZ6K5En4QF0Oh9pwhQ7Js966lFCln8nHh7X8f7S9B1gTTdQ2fLKEZkCxdw1YQAQBuxgZ1oJdbNgVIoROgBCwS8SKoqCgdMEuVuwtuNjFCtgVFStFTJBi1/zO7AbQ5/H53vf7r4/r0szuPTNn5syZM7O755whGhnwiOuSyvDpn/R7LHJEKlmzE61U6uBNml6t5LG7UyxKOmxtRIz4Qn0/vEHRwRWSGIK4ej22+v+JQA03Zl1FOYHC4q9bV6D4dRuhU0e4dNjZqUe63x7zoZGcVijKIZjVXEa/SQ93GBseddwRPW62DTWm6hLjaVlKJFEH104mWk1F+KO8jq/AFOoc8Eq+GmNjCL4gmV+zt/lfL/a6ZKnXEeqOJks93ozS2F5Xl10FtPR1aUVQMJZy8m7wt3Wfp10KKLLu48W3NlLOf6771P/1ul9TDdlKsie4CiksadT/s7WfwqLH+6P6Rn9fignt/6z+f78Q8tlnFrIQkjWQ93/UESV81rLpv4RD8K9rIOvMSxpVZwWsT1ZA9u0aMcDGIoSdpMYQyygsMNwGiYiSkR553SGk6IF4ulK0K6sXeNzix/tj8SP7TDLFdGsWQK5WY54R+W4bWFODDlcDXvN4tWueLrfm6f7/WvNo/GLDkG2JdmIaaCfmn22Ss/qJ3RDycWN0TI3/2TSueb9pJYN/aCWD37WSQV2tZFhHExnXpknAXGPcWEOtZtKt1UwGNZqpZkrj10+sGiCWlb511iR+zZrEE+oMxy+GjIi36v9R1Mp1eLr/vRyRpyYciM6MDaSjR5Q0Fh1WkdQwlWj9geyC5Prf6xGrrmqVsnZNYqvh1oHAf1mN9LnlQqjHrUZ63Gqk+/tqpPvnaiT/fTECdk9Td4XTrxP9/rfB1v/HYOv/Ptj6dQdbt85gG/422DytZHKDrVc72Pr/WIbYrVOdpaeWCI/WIaGdCfe0Uq775/JT8wCKXTZMoXb5aYZHn/0mzZoWEJs99v33be37b5LppDaTyW+Z8rSZ9IlcGHC/hqyZGXkyL9HRXpiQC/xRj17VzKRDK9YF8+FFnskjviCl9pBv/PzNM7lO1XlnQFRUnbO+Ke1Z3xR71jdfe9Y3xZn56WEzPz5r5qfHmvlRxMyPWDBiB1kdzv6Jc5vV4WzAdH4/xJt9qmcbzdQ2uoxtdH3OfcZkB88kRVfwFn/l19p4lJHPlA0E9NVEcoI8tgdJoFh7IJNizBozwNhQYyB5yDdSAc5DbzE0KeDT+xIoejdJnUyg6BUkdTGBoteRVG4CRf8wwKmCBIo+SO4VJ1B0AklVJVB0WQOcUiRS9DETnIpKpOi1zXAqIZGiD7bGqe2JFF1GSmQmUjTTGKeUiRS93ginyrVfbss2Ubhh5Nt0AiVoQxrOdoU28jNJ0DUjAO6KoIoH9GctE6q0TPicpGVCbuKfTPicxDLhc5KWCbmJFH33Dc/kBZ8uSKTocjZZnEjRUW9JsiqRovexSUUSRd9lk1FJFP2ZTSYkUXRcEUluT6Lok2wyM4mir7JJZRJFP2STV5MouphN3sU1sMnCJIpeVUySZUkUncAmP2tZUrWJws0kX8UTCUs+J/3Jklx2dAXvsGyzIq1TEz6cDcFvpotduvGSS4xxTUGoY0aRhwKeGV8IbKwavh8RUuz/QQ4+BtZKiryxq/3+qXVAp/ALP8oYBGTXw77uBu4uefzBTv58X64spT3YHgQ4JgtwH8nInNDTHmwv1GHd1rHrAtGcxGgYfxkk1zziMc6FL7+GLSTiufH/rh3/9FTt+CuS/xz/9FR2/NNTteOvSKbociLcUckUXURSCckUXUkEdDtONSJCm0zRx4n4KpMp+h4R7qvJFP2ZlLiLayFoYTJFp5DpUJZM0d/q49TnZIqOJfeWpVD0TpKKSaHoWFJzSgpFn2yDU7tTKJoh6NEUit5HymanaOneSKHocoI+TKHoG6Ts6xSKVjQhEyiFoq8S9HsKRS8nk2pVKkUXk7JxqRS9htBQxHNS9X0ThTtPrEySiVSlp/4pVYpkVqpeYqMSLaOXxXOMzk3TMjoz9U9G56axjM5N0zI6M5Wid7OSrUyl6Kts8moqRZexybupFL2shJ0QqRSdwibLUil6H5v8nErR2Wxy2WaKvssmYzZTdDmbTNlM0QmlJLl7M0WfZJNHN1N0AZvM3kzRinckeWMzRcewyYebKTqdTb7eTNGZbLJ8c00bvm+m6Gz27qo0is5lk3FpFF3IJtPTKLqcTe5Lo2hFGUmeTKPoGDZ5MY2i09nkKu0ALIunMFOImVQqGYDctD8HIJOVV4EU6Bgt/6O0/P9cw//CtH8oOo7/n2v4X5hG0XfbEsFMo+g8korRtiUqnsIZiMlTGqti/tGWQrZKQRDQCdq2xGnbkpBeM+nS/2xLQjrbloT0mkmXTtGZLDuisNEcm0zQtiYunsJZiGimk9YkpP9DNNlKBR2B3h2vpZ0ST9GnDbFZ4e54La2UeEpQD/APcY7qBPTJmvz74il62SW8vuKbXIF9bIF9XIGOQF+tKaCMp+iLxG7xak1+JZtfWUvgYU3+G/EUvZsl8LCmwA22wI1aAsU1BQriKXorIVBck7+AzV9QS+BzTf6yeIq+wRL4XFOgjC1QVktgVYK2wHdcoAEmsCpBm/87m/97LYGEmvxRCRSdfpkQSKgpEJVACkQlsAXwlsXkGx9vztqz1ikGvmYk0gzrvECSrPOCU933D7X20iSuqQ57lgMJcfpvZhM87fMDuwekTXwF6PdzEMgGnpy3BNYwl4Q05NnDXPaZHH+/MVmqiyPpaE352XoMfAV9tebZrbhfzhSe2N7+/VYr7F3CfhElfiZsqg0xeSEeIXxHeltTk2nkvB1KbhKtS4zPWNv9WkeJrlA37g0IeezZ6cA1nbXn4WKJWHGhJvkk3hxnPgOEixQJX6M99webqpGBISan7LbSyNdktS7baSNf9hZZnQXEk4FyxoFSsB3CwmAz1rWB/FBOrXXp2rgpS3UF5jVsr/lCZkC+kLFG3Dwte3UABD1ZieAJoTX+XkRsrnfxzMCYR1/dTiziibF3w4bkYcGEjx0x2J3v9gri02KP7evwvteMwkduRuua6bABf4iBAV8beQvYUz/YL4gmG0nRlrgthqO5uKEbdbm4oZt0iRMNObJNagYmm1hnltfg74exARh5BdpiG3AxHl2kz93gCm38rRBXc6wu5+dO2/qyNtM8XxK9FL8KktO573nYJK4/QShfwSfOz4Xzk6DoQDP8WSc8xJfQItF5cOfxp/gw2sRvOImKxeNcMgy4x3Ej4lLBnjRJnDNMoolbkiH2TcFPKAKTaF0uRh9F4lidwS/GyBUfBwPVIzfIIUC+fmaGWkAPH9JSz1eoi32bz5AX9fWwtNXj4uBQ7DOPgH3m4eP8hr5mfJMN+LUM2IM+W40BrU8iyRpowwQ3wNOBuP7XxtjhcTF2tLZrJ34/Nw9zRk/I86thiz5hi14tW3Rr2KJbwxb8NZU93a4uW/S0bNGryxZ9ji06QuydoWUBjjMh1Knbef3fO08e+HTr9KwJCHnc4yKDH9fiea0Egik89kQ8IUXXY93HdLgHSlY1BbKuY5RJNBZeMz4RcpYAv+4TpY5WvM/wWGrBNeqUzz65YrdhnplODZ90SAxPUo5EUuCzUbkooY6vkM+F+MW1s3tuYrSDAzThM7/wNCPXPJN43Rr/tPC641JLkc8VISPEPjngSFF8TAfTPkP6J9TxNcO0sF8k2ww+HiDSDJY+n2uaHzkPCGqo11gmZNUKBmtkxLOHBjXvULQiZfKJx5nemvFZswQKvzXREdD1TPk0jg0H1iAww2NqzA4nzePiJQv5XNQoArAWS5jl7FgBa/vB2ghiSeeb8tjXYuRwI5ahOmwoafLtRIeLJs0+7At28mpGrMZGCjtXhfemjEj7K3lmfJr4V1KsnZkOG+FOh1VvOuxa2JvCYUTD2THGz0bY5pSYWrE4dtXHHiaE9ycpgRk+KSscH2CJWUJ8ogzMsNkG7vpI3AXOEovH+dRHU39oJvJG5J/aCZtK/+/10xrdP/RT1O/66Tynn7ArDA4ZhlXU+T9UFMZwJDJf1ksM+8T7sn5hQkOSmUfz/ufaivWLJK43xPANP4sa1I1rfuFPhcQy5HelxHHjf6mWWG7UUUtRv6ul83XVEuk2duTT6qY6Xf1P3YQ7kf2PyUPE7n88eXimfGLPwE0e3h+TZ8v/1eShWLNsM6jzYgzY/Z9Wpmtelgn61JzGyzq4kjPZmvqSMKRCnsl2XdIcfAMbKN2juPikgps8YqXPWQfy/Mz4tOEowk4hNhiWefnReYb+tFGYmS4RIjpdzfMlbscj/Wie7zDSHyr810zVnHtgg98M4nT0LbJLwAGK43S5UMV0zC2QmvFM4nRJFLyYW3iDEKsr0MKK8w9sML6BxfGlP47szxWL/aMY8Zvi/PBwegDxQbAGITWEXTuJ4Tjfid2AOGkte7T3TY5RQwRndNgXno6+ZJkIp3nsMccmO3Sx4RaQkLWt2AxYLogGwf7yrOekPm3gx0ZGIAPTRKhDl6l5vcmZ0TzWxDOlnMfqsRa+NNDmeNXD0Rx8WSdrDBNq7LkF+OhYXdYulNiM0UC+IeJjCeuxxy/rWFBCmufUmj1QWpu3Ts4WDQ3Z7b6OBWVVnwL8wlyHhB7FPxa4LJvsWJu0ra2RrZ+4UlhQtsY8LudQNmXBCbYOOR0aq0Z8NiCNT44jjCInJdB8GQ10T9JTPs0dhxuOuUMcGvHROjzWW5mcq8A6RHDRj9o01CehJYVm2PWYz9kat+AOJuQ54c+3fPZAQhDM5Db8JmY6Nc7JHVlpaMHu801wDC8sW06sRLSgqaHsfqI31aKBgH0I6o13nGwRIJ317U11FAhacb4wBtrxYU0Cd+kKBD3+BrHyZWCmPTsSajolcOF8YfjE6RiElJZfoWb45GbiCtKKNafWNdmri78TsW4zpCpdPN2JFg5uXbfWeqQl5EEliBD4j2YZcTEhzXQ5YA/+6MidjYzboCP3JVla+HIOs9ps+ONbb2Oe9qRC/nD8ekGQxOOeIntR3HSjhmofLHuyt0zMqN9GRqd2ZLC4Y0MIYMWP+1zFRci2oFrg16SsryoppENC35O8uBRVU+S3QeMGFD/madtEQpQCCYHLvselelNtBPhzv46WXUJ+XXYd0CVCwx0MyEKsarSgTLhn9ia4q2RrQFrDw/0TNiBarDclxDmsaO4cRMJvzH3CXh0h2e9yFty6o9kjX/vzerKLIFkv+CaZHMdJDBxr6EVcV6yhJ/nCp4erb4F7g1cc8v3NgKaCyUfU2htYnnS4E2yJ+S7NF+oPMcae1DiIjRVeVIONWZbjqUkmoAVhowVOcnOeVzNneISzWknSZXumpz0j1eQQWRywJOlh6yU5PoeeSJKu1hEHaIo95VRbOQ6zQrpJcZ2vqQd7Dgj1hnNvzwF3hu9Ym5utwek/yhlRAqipnqctwBInrCOhJv5CUyAYqZ2rZvq0QSg+JBM7qBGViPcOe4mNdJ3ZqUMeCGkcuwDPz9qzZOuBYHhNXXq4LhJAIJgLZUNmuqmu4F9muh6pic/VhJW6oJoH/48ElnLkRNapVh7r6DEilHX6RGSSmMPpYEnCkjmE7ILwN5DelNX/nVDVas3fei2I+x93e4gx/Ge/eXX7zTWQna912knVSijUtBS4ltb0UBBP8fRq9IdunXYJ+Sb7yWsRa+hlqs/OFmyrBfbQi7DK1IC96slOIcPaY4bxvNcnBc3qyUz18VOCNfQ0E8iw3QOWiGEktowemV6G7PTSq5FybGdSR8J16igGHQGJ5l2rGVhvBTzMer+TZ4kL9TF5lrjQQIaNpvH80BMakvlBolFpiAMm6ZTQoOaqp6Af/BdX/hjn32ZKm7+XFOBTYasakEAqJjFY+cSwb8B0gf7eWtCDfZFWVsF9HuezuyvipGjkZ0YO+t7MJ0Z6v7sAntblvpzzoQMI9EAIHUFgAh0A2yUEBbPGPuRdGW7KfiF//0DhimXklG1o2LQWwV3ZL9RjUWjYGAQd/g3R3y800OZpDYJOv53bvV+oz2IG+4WG2lxtQCCIz+cd4QGtMBDkthgSIvcJEMsDZYMCpZ4+Xvb2XjJxmI98HvhIPX2kOBEkC5wtnu3jj9NDpBKZ17yJYqmfNru7OEjsjqGxMomHj7vcJ1A6RCarrS5AEhAomwdOktmyULFsHowQS9nfUP95MNE7VBbiIZ4HE0Ml5HeyxEPKpiaI5aEykgiV4p/RgeTHSeZDrsTzoFOATScPm07zQCQMdg0QzwXrrkKh0HaK7Vywtp3S1XaK0HaKte3crrZzhbZzYUxgGCYHdKhXaIgcxgaGyENlEm0rZZIQOUjCJFI5BAQG4B+5j78cRgT6SOWjfAJ85CHanGES/0DcX1d/fBsGBfm4ayF5oCw4VPIvgDTU3981JEjsLnGdI/Hx8v7XijmElgWMlfkEyuztAz09QyRyGOUjlYhltFwuE7vXGSa5WOYlkYOzzEcilYsx2/+WpWaE7e095DCadC80wHl2iEQWJmFvOrvLYY7Y399VLMeMB08ZO5KuId6Bc0LqtCnMJ8Q9MDSEbb8Tl6v2NunRoHnu/rWMFXv4hIbAYB+ZhOQV+w8WBwT5SL3s7cXussCQkD9HIkTu4+kplWBAPM8/UOwxKDAgSCINIV3UZvKXhElkIUAEVCKUhgbMxpf+PlK/EJD7uPuFgIPQVjhGGGDDpvCvrTBQJrQTygOFdra2Vra2tkKZ2IPDa1N2NiEglgsDAkPkQttudkL2bggEBYbKgA6SQZgEs/i/Guctlnq4BoZJZK4SPBH+hSnuEqlcIsNcD5wtkYFY+FtHsKhKSGKCJEjOpgZL3NmET2CI62xxiMTe3t1fIpbBaLEMPGSBQTgvdBpu32m0facJwk5BWt6IpR5CaaBcOF8iC8RTCUaESiFE7mFvL5nrLgnC7a4ZbXCv0xvwkIT5sCmxMFTqIxcGh4rlEpkU3xkdKP03EQ52DfCR/k1gvcQ+0v8UV5LhT/H8DfwnJ8ntf6gwbiKG+HhJQSqWageLk+EAcUiIa4DkH/fdAwPY2yPE0t+mL6sRXMWyAK1YgcMAbQJLF3sZgHUayAMD/f9FTcoknj7+/mSSYTHy8a8zqWSSEB+PULH/v/RPGigLEP9bfXh0fcT+WB+Ct0TsL/f+JxsCOR66zhZLPeb4eMi9ISg0xBvLjLs3iOVysbs31of/Pjv9A6VeMFsc4uPuGiKX+Ui9/pypHmxWGBPq7z8BK7c/AXdvsdQLJ/AviGcHhkmEtkQitTPMjp2Ifl6Ej36YnhdeeKBTN9tRntAJ//MEsb9/oDvumGiiA24YuZJYhPjMl7jKhdIuQnOpuRCLs8QjRBggnusTEBogDAkNCgqUySUeQpzvX0eEcAfE7nKfMAnIZaESvAxB3Sk9XhwQ9IdQycRyCfjj/4ICQyTgKfYPkdQZS2mgT4gETzLJf6kIT7GHxFXuEyD5zxUmKNBfwqofqxqOdRdizSKUe0uEnuIQuUQmZHMN+B9l8wyUuUvAHRPykEjdJf8cO6JVxFKSK8DVPTBMLPMhl/8yh0LkHv8yhfDdP3lobx8kkfkEetQZhppbf+wbJovl7t414L+wh0Nq1PZvAhUoldT2XEvg7+PAjenswFCpx7/Ogtn+EqkHll8P8Jb4e/xtkxMiF8slHmSRkHhg/obIZWIfqcTjb8owQDzXNSRIQjL8OefFUq9Qf7GMw8kkkrhKA+U+7hIPvEHSKiFhiI1M7FGjiv64JBf/UAlYej1cg1iOsOvAbLGHK5lTeJGpI8nugaH+gQGz/1zqtbedJLPBSSaW+omFQwJ8/MTCsWKph1i77EwPmAm2eK39jaBwup/XTK0iqBVW7RZSOH0EV+q3O53Ewk6zhZ08hJ2GaZe3qTDWecLwKWxnJ4MWgDH0GBg7GujRMGqQKz1qFGHVCBhFjxkKw8c4wSCwteveo2ev3n369oNB3VwmOln3ZSshojSrO9jhXYK1HYiF/hKpl9xb6CC0hTk+cu9uECCea2FnJfS3EkqCQmZZ29l07yK0EQb4SC2011bCEB+vALGrLbmL83bpIhQNEHaXWPfAWcXu3j5SCS7u4x8oFVr0k9h1F/pIhR6BobP9JVZCu259JD3xDU//QLG8C1jgjWMXGCiWyXwksrGB/pIQe/sQcUCQv8TDgpXuLv+90bQS1i5e7F6gJke3mqkuxB0gHeOa3wXGhsokwjAfmTxU7C/0DJWSwRe6i/39JR6mYCX0CpQLwV4omRskccc6Frg/YTbQz4QCy2z0dbGvUh7rjU62W/5u3Ml1aEGTA0NfzJejpET8dwp5kr+3COjLpgLKxBHoh6YCRza3CrG1TXX8nvEhf/TssUhb/+/X5dxvT8eaa3qnmUDnM+IBfdZMMFCb4X/RHO6PvZ+BgD7QgW1edoe/N896UJt3L3tbov9z89Z15Jq3uaNANjj794wA2mb2IH93aprHoiaO7P3KPwgU/vFryxFs4ahtgLZeoDd3EoyvLXfzBv4rI9eSmzdptiOlDuzvVweWTcuQ9pct14+r9zN3Pw4BHdNZUMhn+XOWu330H786BmxBZwEADzdQF4ACgLGGADoA0EsAwAeAi4muN3kRb1HcI2FsVMpb5D33iJ56bwT6FL282KSvGQM58uIq5QI0cJp7ruGWWFSR9zJKPEaBuphdsHx2NQXpdA56J92chLq72FpmNA5iVp3st9EIlqOtnb8ujGs4FCkGN7aY3XAbilxgtag4YisSLV3x07DbCqQKy+o5RBHCNGsabJ8zaSWThJvRbzUzY4NOWK95Seh7q+ERQbpxaLvmzbSjkIrcB2/NPawKR7ydRm1y810Y+7cid9fDS1DfzbcV83tsRYqhE3dLu21GWze9nWSwdwk6UF9xcu9kMXNozEZ1y8ggRjN/ue4nnW7Iec7mubeauaGO7se+hN8LRsXOre+VOIahjQ+PZT3d0AZ1UA4w4H0ZzwS4NHqkP7U3iqnyafpjSyT6tj/VwjByGSovWHDy9ckQZNElE3YaiRj5wqN93RMmMKNHNZ9dPXQYg3nObwqgDwB4CAwBYEwPWYCkr2QuUSchdrbjQ6VekpGhcrl4+CifPkOGDPkjR5+x3vNCfNxDtKjtXIBnTQCmzAVQNgH43gTA+YxY12vfU9TCevDEb6YlKPnjknxBiJq7/oJeSmzMwrvOF+nPaNKj884loqzr5fNX6Qdx1+tF2nLcL5Nv2iN84SPKkfvNBlpjKShuqmBxQ0fuNxvLDp/7pwcAS79shcFjpPC9S1PIm2wOT3tWw+wn2SBK3Ah0zCBwH/cTzjzbCyfEl8Be2hHyRw+E4XqFYFjaDdpsyIN3bX9Cl0NtoNhhF1T3ioDBZ7pBSskyONo5COjFrnB/fT+YsLQfpFT1gzWuy8DiSxZ8bt8fnmnioUGCLjS0UUO9aWsgoH0A3F7cGwyvm4OT8wnY7InAutQVTpuHwpt3V2DAgg/wqZ8+bBi/Gr75lUL7Q65gMHMt2OpMggXfnaB8rx8Ilbehd1USvMpoC7PE68Gg9VtYniiB9CausNbRGxQPNWAeMhr09Ozg2qSmkLM7BBa8dAO/qGxoeXEo3PS6AIbFBTB1qSWsCbsIO9tsgsEHn0LLyXmww0EXdPU10GMxgvPdiyHB+RmcWdQdOg+4AO381JD2eRb0am8P4RXX4MPKtrAwxhR8Oy6Ee9KvYGs9B5r2HwTHmlyGCy1TYf/F82A1mgYjmAkrFjnBq2BrSL6cBD1mAxzNXwhHd8VDH5d78MDhI2wzaQGjw76DR6olBD3YC+4LP8P8zMnQvGkRZA+fBP3vP4Jdy/pCxw7X4f7qOTBtYgeA9qfgQ73W0PLWc0iz04BnO19InCyGfd+GwuLwh2AmOQHdiyPhLeMG6os3wb+3IcxEd6HZswcwpf8zeJa8AfLNLMBiRTG8nDIaLl/rDgavmkHhouvQPHssVLbdBS0Kp0O3xj1haaPZsHQYD6rXTYf9meHQrqQCho0YBCZed2DP04dwwHUg+IpvQT2L7XAn8Sjo7ayAGXPCYdv5pSAWrYLVIXPhYNQ0CHyQBdY73aGKuQ5rl6ih8zkvcLk2BK496g0Wu/PhvHgtNMqZA/zOTaCRUzJcnHoRrl4aDKMPrwdoXgl3B+2HLsPfwI97JgBnv0O7uBsQdEsFjR2qoeyDAo4UXYArny0gVjcOzgU7QDfDIyAYUgmrGqXAXuEC6HYsDYZuOA8LutuAkUsAyHbFgF9Re7C7vgnmNRsB9LyXUPU8Eorj4uHl22WQaBcPq977gatrbzjzoz4MSzoKXtv9IVg2ENbO7A5pTU+C8o0hrLXrBJ/k/cBWtw0YG/FgpIE3WKmmwNA9MSAvoiDrfkf4tGgnSIfJIK2ZGtbF7YSj6z9C3oRxcLteBQgTekD1yMVw2N0bnjq4guNMHVgeGQ4u47tAH49sCHhoAt2HdYfpo0JhTPBdGDJRCgLDc2BZ7QNNPO+BuX4qzOSPhaP9n0Bp2CVY+aU5DPdbBG3NT8Mmny5w+cY+2N9kIsS89IVVjyLBSjYW+NvPwhz9OKi0DQL4bg6lwbvB8/xw8CgcAPFPl8I2FA+D4n6A8YoosKOfwYZ+qfA0KAqanygCg+f9oWmfrjBDkQ7TFLFg0nADNCh+CP6Kg/BEMxL6xjSAqS3CYPaOpiC+fgauRJ4CE8csyK/gw/BQc3h3/CM8MTsD9ZrsgcjONuCxNAwM+/eA+nGtYJz9Hmi77TwcfH8AZnRuBAHnR4P1/BTInhQPOmgpGJZ/hK6OURBglwj9juqDkbApPLwwHao3XITL+0fCmGs7YFefm/A2ozfs3RAHTwd6Q0v3ZxAWpQbvNePh+5M+cGDLXnje1A7gwBYw+vYYPEZ7wnvdE9BFYguTJzEwVGMPvl9OQejZSrCIfQ57FbbgGfUR+NebwlczPXj0ui0MOLIdJreOht43DWHMwBJofHY79OhwDMr3tAJnyW7IP7cDBKgBTJ97Ezp8CYMFa/gQ2VwGl3dOgEDpS1C/A0geMQUuPj4BezxPQ9jt25BHtYVDH6whKvEcXNg/B1YMewyfZqbDZUUV7Cu3gadlSYBmKCH3WQDEXGkPlk+Ow7ZO9gAHk2D/hFg4PpkPXayPwkjFYnisvwvC9tSHBVO3QLNGllBwwhq+vvkBkU9+QuTZH/A6zB/0Mr6DgyIIlkubwo+VGrBw0AexVw+wbLECRmeVwpGigxAdIIWNXv3AjpkOyx4MA9vnzeCK9SDoJO4FOUG3wPb6SWD8f8B22Aq6/q9h2tN0MA0cCrMb5cOpGcsgSDwc/CYVQuJ4Hox16QPt7p2AHh8uQmOpK8y0fQ3Lu2VA28MXYEv33mBwYjuUHroLzT6ZQrTPazDXzAEjHQWsdbQG55vpINyRCEe23gGbmfXg6JeB0PDxdVh0NheSn5yDvc2z4NrWJWDgOwO6uTQHc3CB8Cbl8EJ/BTQReMAmei2sPPsMHv+wBL9Ox2FBZE/QrfwJp5jN4O3rDCMsd4PzxWlg/VkJD6YlQNWVjWA8ei0I7XfC9smu0AQdAkXfjXBDyIPgpysg59lxYNyqYbSkIfD0/SAqcx8czs6FcS7DoN23+rBRdgG26fWHbMdeoFewAAqH3IAxXb7C/WtXobiShoUezyDZ4yE8OmsH2+MvwJwpd8Hn1SUof9wYTtuLwKmFE7iEukJ+VjVIN1yGfd1mQv3B76GNw0AQX1wJXX6UQNH9SjBbeA0C1/cCg8JLoHmwFqS+LyHzx2WINTgHC2fKwW//YbgpTQUH2QK43NAXPt3OgC4hz+FYzmk4AePg5WFjkJ/uCG8WuYH84WowbmoFS1oYwWLPOOB1aQZp88Pgx4+zMGmIGh4t7g1ljxrDmtOn4GL8d7DbbQ4fpBcg7lJveLh7EhzdfQxu36gPjSKtIXByT7CaFAmJt17BfeEp8Ju1BxwsU6Ch6w34IRgBL6q+wbr+AfByhRWU3F0G349mgFqVB9165YBNPzH0NR0MrR9dhSXf68G3Eb5g0+YhTDi6DMYkRsFEsxtg6VIA2Zfvg6DlJmgVdBJ8NnpA52lugMarILxhA6g61hC+X6+Gnkpr6KlUQfHMG/B0lht4rUuGDT3UkNP8JIinJMOLyUoYt/QyPHQwgafBw8C6zVM42GILmFo5wdTKB/BofgJsnpgNziu+wiS97/Bm3gGINOsNffebgVdsAbgU74GIzn3hWlEyjDPeDok9DkHGg/rgozsMJIfLIXzVLlg1Kh6+5PUG0w1HYEHECEi4bQqOaQVQMNQFXsjtwevdQPiZ+hxm3XWFBV7b4fS++eDycSt0XdUB6NMuMFVqAKaWK6Df0KUQ+eotvNl8F4Z/cwTNpBJo0+AaXJq6GuK+doU75y5Bg0u34cm0AzD00gpYPmg2mK7oD1bz4sBEvBIsRy0AhVUrGMQ0glWdY2CuKBJ2X3wNb54sgIv256FzVSl88loNxhsYkGzrCgNiD0HWQgFsH1cA5k/dwefFU0iKawm7u2wE71sWYPj+KAxOE8KYhGsQFOEOixd2gAanusOu6nXQZFIRmH4wgGOplhC4eDTsaDkOjn3ZCxHP78Omp2Jo1puCi/ZpsHTrFpC9D4B+a+dDxMkM8Os+A5zMpwP0fA/5MAe+V7kAb+poKAxWAF2ZDYL9PEe8d8Z7eOvBcodfv4oEp8+iX89vbuNuzO2Pr5e2Lu/36zHXUdhpfl98bRbxqjfO37bSp9fPiK6SoU29uEe2voN+PWT+HNgtjLHvv1mZ9MkoK+sHdp94jkQTXVxcXC6h9V2b33Zx2YGa5273athwCffId3Wguh8u9xZ1vBihyWJuoWNVRg8M/PahG2Od8vceXoqW2Y9JLnzggp+Yz4Mg364cSZlVrZz7J4t69fiWMeCjGs0seJjS2C1YKVbMcUgqU6M8z5Um82fFKJeHS4ubvlKjxh+9eo3PjxLJlze9k/lIjb6u+9JBcWuN8tnHp138ctVIfPWteMwnN9HV5NAWQ66oUeKdHtNfb4sRLa28fM3hrBoFLFg6c2dSvKhB5Bf/KcfU6Lv6x4ZWx9aJPg2Vdd2wT43yUmyCBpx1EG3Nu9O9bJsaCaQxkT11fJWt7/w86JmsRvWzbCzHT9qoHDe9US4vVo1cSsdEqRVjlTfs/LOzVqtRs6p7pzrkrFcWWmccSIpQo4MuM0pe3VGIxq3bcTVhvhoNi91R2rS1Qrlg3CLRSZkaDej+zKW8fbSydG1U3y++asRMaIyiIteIQq8Hvpvurkad3zUMS3m0SXl3Bn9Z4XQ1crOxd/hUliTac8rbbuVENUrtu+J6RFG0su2j72ZjR6vR2gs7B9OBq0X3o2av6u+kRov4rzN15ytEmwoWrR+O1Chu9+5XP9ZtEvWdHSqd31eNFg2TV7SYtVKEdh52vmWnRhVF7RO6DlWIni58KRnSVY1mGQSjBSc3KZe4V7943lGN7PYaBrz4FCF68ax9dWo7NfrKBLZKNh2gjHn0ODe8hRodrWcki+izRiTQeb1zeSM1ir5+K3JDE6loko1DxkEjNTq+N3N06OiloqYn7Or91FOjUfJ9L3kDV4jsHo76HsRToxGf78zs9zRapGnmcdjguwrxp6/rr9i2QvkhbYPrpY8q5D125I33IzYor2fY99n1QYXWWY9r/Vk/Uen5UDfgQJkK5feOcyjOC1Z+SnvT80mRCjVtfetIy5aJyje7G1+wfqVCAaMsdw1LWy4y69lo1M5nKrTax2K+W6NYZRvFPv6Qxyo0PbL5sOhdU5SW3T6Z1ruvQq2ThnslWy1Uxu8e+6g6T4Ua7jvv9t59kMg6UuxmcEuF1B56/Q09N4kmQ9v39DUVmqez5fGLG1JRrujcsa2XVci2UQO0ThMrenbnQbnlBRXKPDj/zK2YMJG5Ze97jxkVmlM48V1W21iR8dMfiYeVKrRuWzD0jItW7rJKDTt8SoWGb4stuPFspXKg5+2tj4+rkGvfBlmXn81VRjinTup6VIU+zlhQ5tRohbLBhpnXth9SoXUPfrTQ7RUremx+rPfQgyqkm7za5kTCAtGPK/F3G+1XIcOJbV6+cI8RdZk47Kn+XhUqvdxy7PIrPUUnnKau7pyhQr2yPbq+7R4nGma6v2ngLhVKC0sUj3gdpTQsCDv1YocK7R6t7n+pR5RyuYt95uLtKnSgpGvk3AnLlMILN3o6bVOhKVMmzX16K1bZycwlou9WFfJouVixx2SyKCRj1F2XLSpkYTaLUR+JVd7sH+65OV2FIk71XLm/ka+SeSwIbZSuQqqMgJNqL3elTSuJ6HCaCo1bVThxQIFCuSxu3JdFaSp022HaYo/2c5Vy17Li0DQVyly0JnuEaoVSvmTHsKQ0FVr91qVd95YrlDleAye9S1OhO3cNZ11PiRGhmc+cfdJVqO2O0acKui9QruS9C2myRYX8sr0m/iiLE3U/Z8t7v0WFXPzv733xTiKaPeZ278qtKjTw9hGbS1tWKRu1cphovl2Fevbp/+G4T6yy8a1RiZE7VKidpqX9slkK5f4rHZxa7VIh6WTZw7F345TvNwxOfrRbhWB1/ele+2NEiZ6rH13Zo0JHS8vP2ZxYK3qSbjnwzT4V0hRdSnE7LlFGDT7WrPtBFRrsWjl16ccFot5zmiYeOKRCSwe029XeMFZ5WbNeMP2oCnVp57/mZMZM5ZtLNzP7nFChqadiFn7p4K9sMP7q9cGnVWjPlyqzQYM2KMeOeZYWkaVCI9d5PvC/tlx5Wv9a0IdsFTK/tb7r94PBopjybRHrL6rQmZB6L3rlB4g6dHjV0v2qCrmbzTbjX1qplLyZucDzhgrds3v5akWbNaIe1iPKknNVqOkZ5Z28M+uVMzs5HNa5p0L5dqoUuxsxoilHbBtvfqRCR6aFSJf5LBMxP+a5+D1ToaOp6+JvPo9Qzq+8w/i9UqGVPa5vmNMqSrT/zrTEtGIV+voob0T0ghil5/G1XfRVKnT6QMGkRxdclN+aOp/cWqlCjh93Dqi/PUZpP/XNWtkXFeoZu79v1X1v5dBZ3yrCNCrUa/UUv5eq9coReltsM3XV6OZT13oPNHJR/rmRMe2M1Ghfwoav37LWKw3bPZh+vpEaHTE6aHtAGiJKGb/8aXJLNYr7kTaj+6t1ovm5Gte9QjXaN9UwL7pwmWhk3uRuH8zVyKvVmL4Hb7qLjhXpxQXYqJF3yw3+Vn5eIp8YdYGwjxrlH7uxtMVqhfLrhZkuAqRGgV81aOb+aOXCSP0R1kPVaHhGaN8DxjHKikhjg5XOarRLf8DO5dvkopXbvxW0mKJGDcwchZvXRygTluY0e+WmRvs2nLs3dto60fLuT3Te+qjRSD/evqn2y0RuR3mVpiFq1N7hqL7pvQila/KCHvEL1SjHeGj/U5aRyi5bqps4rVCjO6vs3fjH5aKPaE1Rtxg1Cpaljiu7tFS0dNSVb+OS1Kh8/Z3oRp+ilY9jtm89uF2NFsk7vEw4sFb5wWud9bCDamQg3EMrL6wTmU8Tq1qfVqPu7zIuxHVdJoo/7den6yU1Ui3Ps8vwWC1yHCKdHparRu9f9X99us86ZZOzKft/PFGj1JvrR/ePnCN6GLN5ybkiNYq84Uaf050g+hAc3fV8pRpBX3aHYOt1JXZyZbcBPPYlMzPddtyvrcU9FDPknUajuc005H3oeCQxB6Vd1XsT6nKJ4V5GM3PwBsTlHrpOdiS3GaOnGxMTE3PQriFeeGfC2D4bvK3j8PNIMmDgdo2GYa7dt7RYFqxEGu/MQe8STzHLcw9+ilhyAt0ckhfaePwxJu1Z4YXynp8QxLydF37jAdO+xMp3buNPCMD4vCrwAZN+7KuBW8VHBIXjGr9q/IBZFNW4/c68jwjmWvSdfvI+k3f0kmD4IXytiHGZeZ85bWTTY+j6jwigRVgudZ/pMNCsRVrwRwQxMSuu7b7HPGq3I9F5/EcEY3UmDXK+x1zsGL1nUo+PCBz9LvT5eJdpUpDqd6QJxnf/2JV6lxk14/J4j4/VCHZH9tsw5C7jbLX+mNfDagQnM/tVvb/DPIuZfl15uhpBUPTgW5vuMHNbPaoQp1YjSM9q3s7xDrNyklOjSYpqBAon9cuSfOaOX9GtePdqBIW2fVvH5TOx4btedhpajWDV46hLDvnM0iF6AzWW1QhizLu8KMljnmcdfmLWoBrB52FdAzbmMQ+e9RwaXVmF4POpJC86j3G0eHZ70MMqBAnquNz3uczVbXOzHbKqEJg8abEjKZdZ3anwQvjWKgQn3ce/HZrL9Fx2t6PuqioE5SuGmL27zQisW7a+FVCFILN56Iiht5mJLfrdeTTh17WtyYDB228x05YdHWxuj/GSwcbULebb56b0MSEuP6fLVrebzKEqh8cR+r/oxWzk87JvMNE/J8+MVlUiMImc1EV4gykZJUh/dA9fL1nbfMl1pus5k2y3rEoEuXdu5Ly8xpx8HNq1445feEyjbo5DrjFUbtpNs7WVCMrbes/ZncO0mb/s0vTQSgS2w3wCjHKYl733D781sxJB9pCdwuCrjOPd0QnznDDe5Gj0/StMx+uaWzNsfpUPmi06KbrCDDfeEjqnRSUCtz7JSdsuMzH9HPpc5VUiSD8x0U5wmaE/bzwz5l0FAtuOYYtCLjF5GS2pevfw9fnoBQUXGcsfJ3Z/OVuBAPLHWTldZPa2NprfJgNfL1WuzrzA2B5r4iaLxdfD/RJbX2Cqt0ye/HVRBQLH7TETV55nmP5tk494VyBIn/f5VOU5Jqs6emnqBHxt1emq2zmmv0HOnhMOv66FnyaH38pmjjtmdOVZYvzn8AJRNtOdvrFpXtNf9StGKrMmM0zy9/y2Qh6u33GTQZ+zjGDY6OFVZR8QOH5xSGiexfhIosdXP/yAIP3hGK8vZ5iFiyc37HDpAwI3G+G8gtNMSefr8oWHPiBQWBRdyD7FHG9lZcTb/Kt8tuyI086TTFbQ8QWZq3/hsO8Ib+0J5rhS3Wn1HHzdd8gH+XHmsd2oXms9cPmVAfVnHWOeuprHnBr3q/7CLc9mDDvKjMrvvr0+wvR9Rz/qcYR5/MVEtsYK07/0eZ7wMGN3rMzCttUvXDg7wan+IeZgz2WPv+nj+vN9/b8eZI74jWmgqi5H4DhnxNrH+5lbaZYz9V7jj2HLX5cp9zKmO6zcB+f/wrMbOUZuyWBaJbxcuCsbX1M9pqzaxeT1vrzU5uCv/Ir7XrOCdzD9GqcnPEnF15Lhq2dsY54XjT+4NwrX39Tj1fAtzDeLMTZpCzD+LiJbtplpGd0r6pgvvh4//oNLEmP1pWyHaiq+XnJ79oBNTIxV3s3hw3F79kR9s9jAZOwvv3y5L77+IlxgF8VkdJ/XWGJB8Jm9Wi5jhoWUmndsga/Lzus0mstsPNREj2+ArzvOM+S7Ma2+dv7UvlCNAGKWVaoDkbxUfL7NFnw9oBddsBJ1S1ySaeL+61px/uK2W7Ho5n6V6GMnjEc2OZeWjIoar9e5WoK/dja89TBzC9p76PpcxQEVgmxe7vTVO1CyUerWVvJfuOKh49IZGehYYr2l6+3x9WS1r/l+NCnJzbCQh/MnvEkIzUQJZ+a84V17j0Bo/Kp6wmGks36hoGLDezz+a552O4puzfjmuW/GewTZk1dO1TuOUp/N2mNljnHfXmGPT6CbVn4O0ooyBG5txgzaewpR83ZtDTiLr43PXJl7BgUY9AnovKYMgbCoe+NBWYg/ZWZW3BSMPwu2q8egqLQzPY51LkPguL5rU69shIrKVEur3yHI3BCxfOg5dG7Tk9AfF39d2167Ke18HlmMWGHUbuM7BGMv7XygcwFZOagvvZS8Q2DSQ3Th+QW0ZlWO17A+7xAo5vv1Pn0RjbBtazrS8B2C8jyLfrGX0GJ1xfLiJ6UIylt0vOl7GW0d4GbX9mDpr/XIs+yz4xW0a8od9DYC462qs5teRWtCDNWOk0sRKD5O7FJyFZmP3BtjaVWKwPEz1ftMDsqriG2czvuFg1Wb92uuodaiJx3THpQgyOXNGDf9Ooo5dEW304ESBNnKG15dbiCbW/EV3ZaXIHAbdq/XxxsodOR21ekZGHfqmXXuJuo7rCj1cs9feOHtk7yoW+jteC8bZ+MSBDHNsw1dbqPUB5p1498WIzjZvpF//Vy0EG6k3WKKEeTG1j8ZnIvqXzj7ODuxGEHQis1+d3PRt+Yd9pjLMT6yx8reecgg6cg+cC5GMKyDl3FCHnJxkBQPtyxGoLhRqPmch9yoqo08vWIE3u4PXKfmoy7bCt07vSxCsLuJoe2pfLT/WMGcI2eLELgNMpG1uIPOd4r32pNchKBFWUDnOXfQZL3mFfrzihDYHvzmfO8OMmp8/8m1Sb/yF9q8UnW/i/yOO/PA5C0STR+43p9aLNp4dLQO2L5F9EwYVsqsFc29G2cMY9+iEzvur9gVvk60P3CMPgS9RaM6TfQr/S4WHWjw/Kcm+i36UX/qKPPFC5XKS+76kPkW8R4XDPM+t1r58dyMdpD7FjWMHZ7aBi0VOXzUfadRv0UTrF+24isWKxXxK+qDSREaP88w2FOzQNSoxOu7xqYIdVyZ1fklRIl8Gy55rnEuQvm8D9L1lFQZk+LVAIKKkDxl4s3g717KXlcXf9VEF6Gl/OrN584uEb09L/ypOViEJB43ujRfHKSEHPRec7sItVmzwECmUCjDWnUu0aiL0IEvqQEW2WtFxdtS+GBSjHqMejMuPzxSFG0V2xxsi9GSStvjJT9XK1NCeujB2GKk7CXxY5hI0eXIgUIIKkahCxpWSpg1Sv686nea6GI0+fqArVKIVD7nK80gsxjVG1nY9zksUq5ubfRGc7sY6aZpnIJhlXLQuvXfNepi1Ddofu6CJUtFV1y/tgOTEqRz9HnYeodI0akFTo3BtgSFUQkjxyjCRYH6qrca5xLUbbbmUfniaGVeI9EzTWAJOt2386Y9EUFK49VDqjTRJUi922N9a8VKpUO3hKeagyWoT+y01YWOK5We34a/19zG8pt8zuAWEo1L+SCE8hJUb/oq8z1otVIvc0hDMClFkx5PSRymkYu+fjyjD7alqEVA19V7z0aJ5rWNN4Gxpch23tyn136uEg3rVt0WgkrRk70PB4TR0crxPaa2gZhS1Cjs/DKKWacc6eBsCZmlyBVpRPwfPsq8dgceaG6XoqNBMY2KHCKUc/njVBp1Kdr2rH6hg56vaLqx5ImmwTt0ql77vlf1pokmX9vzU2PzDrUVdZC3481TFpze+Ejj/A6lWa7wNtHMU6ZINneEoHfIwXlF7hDNapFjs5VfNNHv0JcL5zfN+blQ5Hydn685+A5d7FqhMte4K4fMoPM1t98h09L+qhMaf+VzQ/fPGvU7NEPQLV6HXqKcEHbshaZBGWrpeyLO49wa0avJXz9obMrQ+8u2a9U/PZQdXzMFGucyFDq0TOmNlik/nZr4XhNYhsoKJ5RvW7xMdC868Z0mugx92PBlrd7SEFGSaSdTyCxD/PotPNb98FamOMU91dwuQ7LSK23OLl4nCrv4o1SjLkM/V6Xt73d2najr56RmYPIeBU87tXv9olBR208NjMH2PXp8Jcgn5lyk6GKDeaUa5/fI6OeUS33qT1G+WVnQDYLeo8ENzo2+rwhX7okoMIWY92jGjB9x0QvlyqWU30PNwfdosdj0UtvwKFG/of5dIPc9mnBIc3gzb5WoOmbwG436PYq8Mf5yPkhFcR/33tQ0UKF8H2uh49Jw5dOr459obFTIw6D1tXOwQKRuNrBC46xC4/bGZe7WyEQNZ60u1gSq0NSz6kMhHycrjTWbG0KMCvGuCmatVSxTDm6+47nmoAodEw66pwdzRVvCG7WCXBXaMGOS22dqrPKi8rQ+lKtQw7e9Zg52XK6k1s6v1jRQI9316n5235yVV1a/aQe2auTSMKRi35LVorieEdUaZzUadOXBXRqtFvmNyviuCVSj0LkJbaqo2Ur64pcXmmg1Glk0pypv0RzR4leF+ZqDamS3bWFSS16gcvPrOW0gV40O7bs1UrUkWGR3ofCTRq1G01YG8froSpVSN0mVpkE5elyvzfD9i1crp8xfUamxKUeFh79f8AmPVzY3/v5D41yOpsdd7/mTiRdFjL6pA0Hl6Pqk19lLIUJUfL3iiya6HLUK7XP2uSZAKXlsxIPMcvSu89sD4Wi9su+d7TzILUef0obN+7pIIfrx4/FXjbocZfvdD9Llz1Fu+nFaACYf0GxBwLK7inWimVVvvmpsPiB17x8eX5lU0aOke8Yw9gM6MLZR0BxIEiW5mDaAoA9I9ezVyy8/1oo6TzT/ron+gEJk/QtsYb1oqmhAI8j8gFbxdBTzwhNFJzZ3+ay5/QF5RaXt7f5FooS7q6s06g/o3fRdqUx4rGj7ijVGYFKBzKb/WO+nSBPpDFquA7YVqAeT9u68Jla07KNSo3GuQLJu3RYX8cJEj0y7VGsCK5DYKDzszPdwkcg+tgnEVKCuNCW6RsmUjd1dmkBmBaLaV/SIUGxQ9h//853mdgWqKHDuu1izSrlp/0kBlFegS7Tt2HGa5cqDL+d/0zSoRKkWs1YFwxJluOu+nxqbStT0xAk0U7NeOclrpxGMrURZEWvMIsI3ikw/fWsIQZXoxj3ji6dBITplM/WLJroSjdt12DoVxSkH5j/lQ2YletE3LMgvfLlocs7has3tSmTXiDGxp+aLWhzNLNWoK1Hm+EOeAeEJoqqD3ZuCSRXquLyla5/PXqIua4Y2B9sqNGhcgewtb6nI/ejGIo1zFZoWefikjyZSVBjKL9YEVqGJFeeTD2VvVBadC1RroquQzNK+wtAxWcTfdfaN5mAVGrLImDmhiVM+MzdpDrlVaIBvQbBHdqLypUN5AyivQm0mLBdEhseL8kYWNAKTatR7u2ewhO8mmm+u2wxsq5Fh9w63bjGblKOCnpRpnKvRgy26ujIqUpkx0VWtCaxGjTxy6r9lkkWNTN42h5hqFKM+uOTS4lWiDQ45OpBZjbKNmHoGdJpS2XJ4W8itRl2GdvpmuSRBGTn/ZJFGXY34Pu8VJxbHKf98H6F9z+BG3jO8YfQ4I7gxLlMTExNL0PztXcj9kiHDkqcPr2AuoM5rumqN7NI/IqAjq0DQ/Oqpigir+4xiUh+Ljke/igiqwGgGRg2mMFl59xjhp8KHBjvaZBHUDaM5GJ0ypPmcsHtMwNjj97bP7sCijhgtwehn65X7W91j7nllbn697K2StagkdKt/oXPnbHQ9e5cpdOgS69Oaz5YFQhejbm3OrxHfZW4sGzXM5mFjtq+F1ZguRnevWGHLv8vYCyLeVw4sYNucjdESjA7zcRm18w7jFjduxeVDQrZsOkYjP4KguSIh6enQO8wGxaW7o6d2YlH81oHOwKjwxemXxfnMw64nEtst6MyiboQuRlc9azwtMp9BmbePN7nWtA5a8jfUkdD9hPt7+xvdJZ8JezzBouO0Zmx/hYQuRhN8ziVczWP4E4u8lQfbc9wgdDG6e+/eGV55TPnuiB6X27fnuFGF6WJ02IEva3TzGM9puj8u7u7Mls3GaORnEDSPCXnZcVsuU1+narHKz4hF0zGagdHco3GdHHOZcOuqzSd7lytr0Zy/oQpCF6OOswJanLrNrBQl7rWcbMxxg9D9gkew4Pr+8ltMx4MrUk507spxg9DFaLmlVN/8FmOiQROdbZpz3CB0MZrt7Gc64ybT2vvamfWnTTlJJ3Qxmp505VP0DabnsjRv53nmddDIr39BCysxXYzGWMtXnL/ORJ9YY5c5piWLZmM0B6PZijE5ldcYz5ibyH3MaVau0jFagtHMl+2VHa4xpeecCjyiOmXVopHf/oIqCF2Mjq1KmTY+h3l19xz/UZ4lN48IXYzmCiXp4VcZw69PwpksLa8IXYwWmlCRe68wU0ZMkMU8qYtGfv8LKiR0MZrbsqjB/cuM58vD23xfm3ByRehiNGZXkK3mEtNvrEnaoM3t6qAlf0MLKzDdH7i/W1696XyJiZ6uH7PmmZCTOoxmYFRx3b/r6IuMaG4v8Tmj5gNq0Zy/oekYLcFoTDvh9+ALjP1E89Er5n7gNBKh+xNLTvvP4zeeZwwuBje3XduR4yShi1E3m3uWJ84xm7Y1bLFd0a0OmvM31JHQxWhM7sLFD7KZqunFqzb51BtQi0Zq/oIKCV2MFj6xW1/GMBU9ts2YGMqNPmD0mgYEzbpK9c3PMiIot7TqaTmgFiz9C1j4AVNV8ATNs6dHT5ylZPTOuk6ZbNSW4zJGMzBaOMI+YMNp5uqe6cW9+nG6jKA5f0PTMVqC0XS7+0MunGS8J9mM7rKwcR00cslfUAWhi1G3N6vzy48zj0N65PSJ5zSOG6GLUaEe0m99jJk867J4OsVpK4KW/A11JHQjcJtbb3pAH2GeN/5y4/Esqzpoxt9QIaGLUcU2VW/JIcZwW3TYrIVNODYTugRtmG1b7yCzfl3vpZunWtdBI5f+BS3EFu4ZBG0Z/HTgXmZU0P038yPa1EFz/obi92x0CUazu3+cIt/FqLZU9HT6bpVVi0Yu+wuaTugS9OeplZu3MXt+dq4+QVWLatGcv6EKjJYu4wmaza2fHJHGvDZcvLCzoktWLbh6+b+DboTqctyfe/qtT8Uz/XZ+jZ241oKbJRi9hot+z9ydHc2k7LzzcWG758pasPQvoJAQXcETNDPxsywMZ147PjZGL1tm1YJ7/gISD4NnK3gCCid+rOAJdLLVuLKVPEGzyNCmJgpU3DU10e8Kp9cUGMxYiXsQO2WSMAblf3qpN71Auy/B6DVcNMei0/AE1NNoWvfT6ZwqBgyW4KKORZEz6XQ04cGHGdkNedxgqjDVVTxBs253D3huRxY/skJDmnGjpcBgxio8HmlN9sTtRos6T8vdOI/rgyNGcwj69GbI9X1I3+Lh0ArvVlz3MVpCUL1su9IDaEH/HGeHhvU5XfseS0kknm9Oef3jD6HkzcaTZnbXrjwYzcBoYd6u6qwj6MGYJztmXeVmhRtGczCaHj96Wskx1K7tTJGeD9dmR4yWYDS7tN4dOIG6v0/NWNuujJUhIHRXY2ZMnTmrxyn0eGiW/YyGHThmlGG6GHXbv/aq7xn0xvtTV0VMY65VGM0hZZW8KauU6M6+aZfznLQ7KYyWYFRYb2m/K2dR4ZC3B72zrblWYTRyDe7Rk37rixn0o94W5/s9tdqU0CWoecS65udQhb71rblqbndQ+A7TxWh5h8Vd95xDPRP7Dl63i+NGOkZLMKpYYSTOO4+2HF1y3T9Vh9NrGI2M4gmaxzTN/C65gCJlIzvstrnMcsMRoxkYzeyxdMD6i2ju8R8T5y3l9KmQ0CXoltdvzC+hK4t83hT34PpbWIrpYtQk6uyYyZfR3G4iqzW3tfsOjEau/dXmoNA1jcovoxemKW/WNtSOL0YzMDp28PK1kVeQ7qD1QSae2j04Rq+t5Qma9Xt38OxVlGdVsmfiAH2OkRgsxeCngmnTclCgJn2KRYU+p/MI1XWYj6tF72OvIR/TSWMHybh5XliCqWI0d/rkh3bX0Z4X+8as7cXtG7MxmkPK9u+7Mvc6Ot5o4tSLI7nxS8doCUZNyi9/C7yB8rtuuiQr+8DqATeMRkZjLt/NHHDoJuqV2fSTpYabgI6ELkZNijT1J9xCtlW0m3mj8+wYCDF6LZonaPb09f7qW6jhujOSpqbX2IqBkMVFM4/4t0m8jWyfG10ru96aY3IxJhvDEzSfMtqtb3AuWj/mfbMnKZ85ZYrRDIy6ib2sL+aiklJRszUtuG2jAqM5GC3GIpeH2pTvcK9vyk0iN4yWYPTzvusz/PLQkmY7Pt1M0m7QCN31v8p6T3NPZPLQiayh497v1C5ahC5GT9YPGNIkH5Wedjr9bCW3rSgswnQxGlOwsPxsPqrijx3xNYXbHGRjtASjbndefGhyB50Umd6Z/5IbwHSMRm7AjDwb5uV3B12d8yHzprQh1yOMZmDUtsec8efvoBlZescn9m/BTU9CF6PF9zocbXkXpRbGlPV+bcD1iNDF6NXg82uD76LQ+16Gt8xtOFVG6MbimptvLsy5i7Y/rNc6UshtsoDQxWh6X/0DZvfQ1CseS4LOcg+xhdhvLgejuVcnfFpwD6kdZ6re7+c2B9kYLYnlCTJ03aY+z7p3DxVIthtYCuqRqpuMBKgHAAIAMAIAYwCoDwANsIMZADQEgEYA0BjnBYCmANAMAJpzvkP4b9RIgBYA0BI7gWk0GvwP32sFAK0BYPAIgCkj2Ly7RwK0wbaIdei1A4D2f9ATcvRMOXpm2EdpgryHq2v3fqwbuk9gyHD3MRNc7ezcvcUyV+xiKw8Z7j4EeyOxfki7RwBEjaopZ9erxn9dIg6YHer5H8WJP1PhiNqyPTiibOG/lzw6F6DNSLav2OLh7ggAnSqN5p9t8JF6/bUNYya49qvxc/+tTx4j2THjlhqYMQqgAwB0xH5yGo0G/8P3OgFAZzz6IwE+jwQwGgVwt065umOmLVd3zLTt7Vfbbx+p13/1/u9tbjKKpYf/8HiY/5IDi1oafbVRLIZwfJ87Cuj0RJ7gDj9Pvhkmp2ZZKoLGN9BoHMyxpHoAQLHO/9fetUfHUZXx382rTSZJ09CWppRSHpWXwM6+F/mjQwm05yShNuFRRddks0m32U22ySabVNT6QlSUilgrVEhrkYOK4gMVeQ0sYEGE8rQoYovVf+QIx4PHcjga7zfzzc7s7OQBOQf/cWZPdjL3u9/jPr7vd+/svQM0nQ5MXiOw9sJF2LFrN3Dkn9VkUUji0m0ABqampp56e2rqhgenpqwFlVPv9ICoqKyqrlmwsJZv1Cn1DY2LmhY3H7dk6bLjl7esOGHliatOWn3yKafOLf1/fEBUVC2orKnm8qgAaLWcXgXo1YBeA+gLAH0hoNcCeh2gK4BeD+gNgN4I6IsAvQnQFwN6M6AfB+hLAH0poC8D9OMBfTmgtwD6CkA/AdBXAvqJgL4K0E8CaKHrTwVQqAAKlUChCihUA4UaoLAAKCwECrVAoQ4oKEChHig0AM81AoVFQAGov1egvlCB+kIl6gtVqP8D2fNKc9U33PV8sMP0JNYCb23yFqFUHO2Apt8ilEva1sXXdW3eaHT6tnXxjsvaWzdtWGdcd21obwXfX3dpW5vW1Wpct1/a0dqlbdpsXLd2dmqXtHZC23mrULQW1KGlhToVuIxpcaXhXY2jBYvrWlpaKusWQKBWWQ7U1iiUXkN5KKd25FahnNxoZ6hroNsNVFm1jQbDRnLR2s2TQhH10G6fFMpScs+Gj0ZtvZGvnj7aC0TTBO0I0ZBLr1pk0DSZC4jpo12/VyiiGdrNe4Wyityv4YNR22zQNBsf8gorVqyA9uxeoTRa/7F92mf3CUUsgXb9PqEspcBgRAfULjEIltBHu59olkF7fJ9QzqQgYkQS1C4zaJYZH3s1vnbhuotaL96xCdqO24QyJSrgPml3bD4x+yk+VqXPdC48VH66KF5wnI/O7SzJ/6LjfGxup5WXXsZxh1Aqdl4O7cY7hfJWpTD7LqyVrtW80tW5ovfdRnUrKliRwIrWVpRezVGZIrIVeaxoY3n2MwGcBeBsgF4kR+82xbkAziMPD0AF4JdOIEDL0dln0xKFCK1JoCXlAL2ZnLbrNyIWIRla6kCT77R0QQNwIfVpQhcAqJteDOASAOsBbABAgIOCThuAdoo2tNKcVpcD+CCATQA6ZYTuAnAZgMsBXEERi9byA/gQgA9ThAXwEelbPgogTijvPZT/cQBXA/gEgE9Kv/YpaDvvFkrF5FXQ9t/z/5YAdAPoAZBgZJAE0CcBc79ECVvk4CYlR2xbCQ3IEXBajs0zAAYBDAHIMlIYBjACIAdgFMAYgLzEsuMAJgBsn6ElvFfyPVrC5ENCeUjYTrO7J9Gb7DNd5/iVZ5+T3ZjaMNhh1AiwJmv8tbcEM3ZJ4QrLcIWsYSOs6wn+3swVZ9Ge46Bdw839fL5ud1x3ciNZw8aCr9eX0GtvPCyUlyrLE0oZGU8pkqU+gI6uPrsvanPoj3Tcl7T7pTZL3zRQa5/dR7Vp/AQdd/XZrUSbpqXkuMZHubWAW0w3t5ARx/3ZKse7QMvLbQ3ztyqjx3Hd67heP4eK3OzgObeK155/TCi7aq9O2N1Es+F/mIYM6WSorzuRzBWHOQlAH+NdXjhfkvO90+7FckKJ3EQ2uSFPW1nw4MZn3LLGHsYWFglzCPdkogiQQXrT95v8TcfOXlOnYdZppu7L0iKJod5kYiy3IZFQ1Xg802NsExXPOfTxM0lxNGToNNhr6tTWW67Ttb22TlVJU6ftrFO5ywB2yGHppz10umikTClD5uFZZI6zzM+wzM9KPT4nw9DnZRi6RoahLxC9DENf9JKZ8pbZlZxepptHvpyFwWP37DysdhePpzJZq929nDTpbTlp2t2NhrNGOjU+r/Q8p68uTec2lyjqtbZv+nZlDYcHRzNZ2mOJsxl8c6V8bZq8TbObaQzQ3Qd8SYb9L3O9XCdD/1dk6P8q11uwD7ie2jGnf03CgBskDPg6px/sN+v1Rk6nUdUuCQu+KWHBbgkLvkWbIklYcLOEBXskLPi2hAW3SFhwq6OOBkcz8f5kzpwtiKWK0y7xVC45bE4SeM+i2D0iFo8XuTj6SbB429l3d/WbZbyj355+uYuv6f4F/eVl/8t+aG8+LZQnxP4tpsWTbPFeCWz2SWDzHQls9ktXdpsENt+VwOZ2msSSwOYOCWy+J4HN9z0szk9rcb7M4vy0FueLrSa3xdsi35Zyi67bAu3AM0J5RVyXMi36AVt0p4ReP5QB5EfERUKvH0vo9RMaiRM3lxXZUavehuZRbwaX8nrLjpbU26YU10/KtjKdsq085mFlLgXtrueE8oDo2mpaeTdb+XMJHn9BNSvB4z0yJP1Kgsd7KeRL8Hi/h5X5aa2ca10ZXIp1ddpWbysOp8qtuGArtGPPC+UmpWsAeEDC2gfZCpoheUgOMh6GMduBRySoeVSCmsd4ipXof00LsWUQflyCmyckuPmNHGw8KQPxbx2+hHaVnHcnNJiYFUb11TBQ5O/3xeOWiDjNag4Nd/db/o5ozxgwrT/ApVLpsH71gPndNmDPJa9NA09JMPY0l8NBCciekYDsWQkqnqPpVDlYekECsRe5HIj+d9L/HZLA5CUJxn4vwRjNBL0sQdgfvcphHl1zGmONqidbl6ZNWw8OTG9rNG3bejQNvCIB4p/Y1sNufefZCVVL3+xozqqPR1nHHeny1viyQ7feDHBEAsVXWbc/e+n2broO94aVmZnlH8uYvfooy/+LDL1/pecgNPlLz6zoQZzEfX+jB5v0yNUxZe3LDA0mJziEtvX4SorESCvFV4cypk73eej0RsbGOulBU6e/s06vUzr9CIJ+jUI//KFYTj87ox/iSQz4r+l1UkknkrlxcGaZh1nmMZb5Fu0KKLHd24SLJbb7t8R2/6EJT3Y5QnjLzHM5kMxHZpHZNWTKrBCmTJpjqBJAtQBqBLBAAAsFUCuAOgEo08ss2hkdmlnmMZZZzzIbBNBo842Z1TZPR2ZARZuR1W9fHDLrf6eXjkPQ9hwWyk1iT9bUcBFr2CSAxZ4azsPFlGpY9Czbs6aGwWy5hjdmoelHSMO120wNm1nD4wSwpEzD+TqVooZWcDc0XLXN1PCQh4bRbdCOvkoaHmUNl7KGywRwvKeG84jKpRoWy/Bh1vDqbR6eZxu0a48K5Z6FVw2bGi5nDVsEsEIAJ9haRjPJkZHu/uRICbQJWHdLfUtsmFHBcLnUrmG7/f+M5a5kuScKYJUATvKSm7f96J4Z+HbyeHSQx9zdjkmDdh4je6V1OSYnRjzSr+C0Xs4/HV0Xj9FHHVNcbpqLOS3lkdbJ/+ccPLxoLBvddrltcevu1tGtj1sH8CRSN/Mf5ethlz1JnmAZnoam3XEvwfLB/j3rkJ920U84dBh1lL3zXtpBp/G9fv4ecdjRyXmzfC/Jcyc9fM3NypgUSzDNkEd6B98fm4HHRfx/YgYaZ7m6y9FdZu6ycpeJuzzcZeG2322n2y63DRa/dr7eaM5iPvmaULa3zYLLwRhwJsxq/GhjDFgtgJMFcIojvgbj8ZEt3cPJ3nhiaHQwV/Qz+8dArzhWDgifz6f6/L6AL+gL+cK+iC/qi6k+VVX9akANqiE1rEbUqBrz+/yq3+8P+IP+kD/sj/ij/ljAF1AD/kAgEAyEAuFAJBANxIK+oBr0BwPBYDAUDAcjwWgwFvKF1JA/FAgFQ6FQOBQJRUOxsC+shv3hQDgYDoXD4Ug4Go5FfBE14o8EIsFIKBKORCLRSCzqi6pRfzQQDUZD0XA0Eo1GYzFfTI35Y4FYMBaKhWORWDQWg7b/daH8o2q2R/544qYPdBDUTYyPd/ekxlQ1TGWUysSNub3UYN9QcYbkQB5o2g6U0kfi8USadrAvyUD0x/LAa3mzRlaOA6cK4DQBrBHA+wRwugDOEMCZAjjL3N8Ck0x3tovu/QI4RwDnCpd8GlaMpLxUMHQYHzdlGzOhzPs8F2+fAFQB+Mt4q/H4WCY1nX3PO3hfOWE+PAoIIMi2rOV7IQGEBdCZi9nvCeGW55sw7tv7xjPv9RNmfjqunTAfTkUEEDX4qGp6qD+V4HeiGHY66HWmj9n04dTgWHc61RvvHu4fNV7JY/3IZ8Lkbzwe4Hzn2/n85sbtLIjzHOY8nblYsUwse7Ad2u43hVK58Yam/wLadhWsvs0GAA==";async function Re(l){let Z=Uint8Array.from(atob(l),j=>j.charCodeAt(0)),r=new Blob([Z]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(r).arrayBuffer())}var K=20,In=200,C,N,Q,P,k,pe;function De(){let l=C._live_values()/8;return C.HEAPF64.slice(l,l+N.length)}function Be(l){C._live_start(l);let Z=C.ccall("live_layout","string").trim().split(\`
\`).map(r=>r.split(" "));N={names:{},length:0};for(let[r,j,x]of Z)N.names[r]=[+j,+x],N.length=+j+ +x;Q=k=0,pe=performance.now(),P=!1,postMessage({fields:N.names,seed:l}),postMessage({frames:[De()],ticks:Q})}function _n(){let l=performance.now();if(k=Math.min(k+l-pe,In),pe=l,P)return;let Z=[];for(;k>=K;k-=K)C._live_step(K),Q+=K,Z.push(De());Z.length>0&&postMessage({frames:Z,ticks:Q,busy:(performance.now()-l)/(Z.length*K)})}onmessage=({data:l})=>{if(l.start!==void 0&&Be(l.start),l.paused!==void 0&&(P=l.paused,k=0,P&&postMessage({paused:P})),l.command){let Z=C.ccall("live_command","number",["string"],[l.command])!==0;postMessage({command:l.command,accepted:Z,at:Q})}};Re(Fe).then(l=>Je({wasmBinary:l})).then(l=>{C=l,Be(1),setInterval(_n,K/2)});})();
`;var so={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Ji=.2;function ro(i,e){let t=i===Ji?0:.02;return`attach ${i} ${t} ${t/2} ${(.1+.07*e).toFixed(2)}`}function Xl(i){let{act:e,view:t}=i,n=[...document.querySelectorAll("#controls button")],s=l=>e(ro(l,i.held().length)),r=0,a={attach:l=>s(+l.dataset.attach),cup:()=>s(Ji),hang:()=>e(`hang 1 ${.25}`),command:l=>e(l.dataset.command),pose:()=>e(`pose ${r=(r+1)%4}`),restart:()=>{r=0;for(let l of n)l.dataset.toggle&&l.setAttribute("aria-pressed",!1);i.restart()},toggle:l=>{let h=l.getAttribute("aria-pressed")!=="true";l.setAttribute("aria-pressed",h),e(`${l.dataset.toggle} ${h?1:0}`)}},o={pour:l=>{l&&!i.held().some(({kind:h})=>h==="cup")&&s(Ji),e(`pour ${l?.3:0}`)},push:l=>e(`push 0 ${l?15:0} 0`)};for(let l of n){if(fu(l),l.dataset.hold){pu(l,o[l.dataset.hold]);continue}let h=Object.keys(a).find(f=>f in l.dataset);l.addEventListener("click",()=>{a[h](l),l.dataset.say&&l.getAttribute("aria-pressed")!=="false"&&i.say(l.dataset.say)}),l.closest(".weights")&&mu(l,i.say)}if(gu(n),!t)return;let c=l=>e(`push ${l.toArray().map(h=>h.toFixed(3)).join(" ")}`);xu((l,h)=>c(t.inArms(l,h).setLength(l||h?15:0))),vu(t,(l,h)=>{c(t.inArms(l,h).multiplyScalar(100).clampLength(0,i.get("constrained")[0]?15:40))})}function fu(i){let e=i.dataset.key,t=i.lastChild,n=t.data.toLowerCase().indexOf(e),s=document.createElement("u"),r=document.createElement("span");i.setAttribute("aria-keyshortcuts",e),s.textContent=n<0?e.toUpperCase():t.data[n],r.append(...n<0?[t.data," ",s]:[t.data.slice(0,n),s,t.data.slice(n+1)]),t.replaceWith(r)}function pu(i,e){let t=n=>{i.classList.contains("held")!==n&&(i.classList.toggle("held",n),e(n))};for(let n of["pointerdown","hold"])i.addEventListener(n,()=>t(!0));for(let n of["pointerup","pointerleave","pointercancel","blur","keyup","release"])i.addEventListener(n,()=>t(!1));i.addEventListener("keydown",({key:n})=>{(n===" "||n==="Enter")&&t(!0)})}function mu(i,e){i.addEventListener("pointerdown",t=>{let n=document.createElement("div");n.className="dragged",n.append(i.querySelector("i").cloneNode());let s=({clientX:o,clientY:c})=>{!n.isConnected&&Math.hypot(o-t.clientX,c-t.clientY)<6||(document.body.append(n),n.style.left=`${o}px`,n.style.top=`${c}px`)},r=({type:o,clientX:c,clientY:l})=>{for(let[h,f]of a)removeEventListener(h,f);n.isConnected&&(n.remove(),o!=="pointercancel"&&(document.elementFromPoint(c,l)?.closest("#stage")?i.click():e("Let it go over one of the hands.")))},a=[["pointermove",s],["pointerup",r],["pointercancel",r]];for(let[o,c]of a)addEventListener(o,c)})}function gu(i){let e=new Map(i.map(t=>[t.dataset.key,t]));addEventListener("keydown",({altKey:t,ctrlKey:n,key:s,metaKey:r,repeat:a,target:o})=>{if(a||t||n||r||o.closest("input, select, pre"))return;let c=e.get(s.toLowerCase());c?.dataset.hold?c.dispatchEvent(new Event("hold")):c?.click()}),addEventListener("keyup",({key:t})=>e.get(t.toLowerCase())?.dispatchEvent(new Event("release")))}function xu(i){let e=document.getElementById("scene"),t=new Set,n=()=>i(...[...t].reduce(([s,r],a)=>[s+so[a][0],r+so[a][1]],[0,0]));e.addEventListener("keydown",s=>{s.key in so&&(s.preventDefault(),!s.repeat&&(t.add(s.key),n()))}),e.addEventListener("keyup",({key:s})=>t.delete(s)&&n()),e.addEventListener("blur",()=>{t.size!==0&&(t.clear(),n())})}function vu(i,e){let t=document.getElementById("scene");t.addEventListener("pointerdown",n=>{let{left:s,top:r}=t.getBoundingClientRect(),a=["without","with"].some(l=>{let{x:h,y:f}=i.handAt(l);return Math.hypot(n.clientX-s-h,n.clientY-r-f)<90}),o=n,c=l=>{a?e(l.clientX-n.clientX,l.clientY-n.clientY):i.turn(l.clientX-o.clientX,l.clientY-o.clientY),o=l};t.setPointerCapture(n.pointerId),t.addEventListener("pointermove",c),t.addEventListener("lostpointercapture",()=>{t.removeEventListener("pointermove",c),a&&e(0,0)},{once:!0})})}var Hs=class{constructor(){this.clear()}clear(){this.rows=[]}add(e){this.rows.push({t:e("ticks")[0]/1e3,mean:e("with.mean")[0],deviation:e("with.deviation")[0],truth:e("with.payload")[0]}),this.rows.length>12/.02&&this.rows.shift()}},yu=(()=>{let i=document.createElement("canvas");i.width=i.height=6;let e=i.getContext("2d");e.strokeStyle="#1565c0";for(let t of[-6,0,6])e.moveTo(t,6),e.lineTo(t+6,0);return e.stroke(),e.createPattern(i,"repeat")})();function ao(i,e,t,n){let s=devicePixelRatio,r=i.clientWidth,a=i.clientHeight;i.width!==Math.round(r*s)&&(i.width=Math.round(r*s),i.height=Math.round(a*s));let o=i.getContext("2d");o.setTransform(s,0,0,s,0,0),o.clearRect(0,0,r,a);let c=e.reduce((u,S)=>Math.max(u,S.mean+S.deviation,S.truth??0),.5),l=c>10?5:c>4?2:c>2?1:.5,h=l*Math.ceil(1.05*c/l),f=u=>30+(r-34)*(u-t)/(n-t),d=u=>a-16-(a-22)*Math.max(u,0)/h;o.font="11px system-ui, sans-serif",o.fillStyle="#5b6472",o.strokeStyle="#dde2e8";for(let u=0;u<=h+1e-9;u+=l)o.strokeRect(30,d(u),r-34,0),o.fillText(u.toFixed(l<1?1:0),4,d(u)+4);let m=Math.max(1,Math.round((n-t)/6));for(let u=m*Math.ceil(t/m);u<=n;u+=m)o.fillText(`${u} s`,Math.min(f(u)-8,r-26),a-3);let g=(u,S)=>{o.setLineDash(S),o.beginPath();for(let[A,T]of u)o.lineTo(f(A),d(T))},M=e.map(u=>[u.t,u.mean+2*u.deviation]),p=e.map(u=>[u.t,u.mean-2*u.deviation]);o.save(),o.beginPath(),o.rect(30,0,r-34,a-16),o.clip(),g([...M,...p.reverse()],[]),o.fillStyle=yu,o.fill(),o.strokeStyle="#1f2937",g(e.filter(u=>u.truth!==void 0).map(u=>[u.t,u.truth]),[5,4]),o.stroke(),o.lineWidth=2,o.strokeStyle="#1565c0",g(e.map(u=>[u.t,u.mean]),[]),o.stroke(),o.restore(),o.setLineDash([])}function ql(i,{rows:e}){let t=Math.max(12,e[e.length-1].t);ao(i,e,t-12,t)}var ot=i=>document.getElementById(i),kn=[],Zl,Mu=0;function Su(){return Zl??=new Promise((i,e)=>{let t=document.createElement("script");t.src="logs.js",t.onload=()=>i(new Worker(URL.createObjectURL(new Blob([globalThis.rmeLogWorker],{type:"text/javascript"})))),t.onerror=()=>e(new Error("logs.js is missing beside the page")),document.head.append(t)}),Zl}async function Jl(i,e){let t=await Su(),n=++Mu;return new Promise(s=>{let r=({data:a})=>{a.id===n&&(t.removeEventListener("message",r),s(a))};t.addEventListener("message",r),t.postMessage({id:n,files:kn,program:i,options:e})})}async function bu(i){let e=i.name.endsWith(".gz"),t=e?i.stream().pipeThrough(new DecompressionStream("gzip")):i.stream();return{name:e?i.name.slice(0,-3):i.name,bytes:new Uint8Array(await new Response(t).arrayBuffer())}}var si=({name:i})=>/\.(urdf|xml)$/i.test(i),Ws=()=>kn.filter(i=>!si(i)).map(({name:i})=>i);function Tu(i){let e=new DOMParser().parseFromString(new TextDecoder().decode(i.bytes),"text/xml"),t=[...e.querySelectorAll("robot > link")].map(h=>h.getAttribute("name")),n=h=>new Set([...e.querySelectorAll(`robot > joint > ${h}`)].map(f=>f.getAttribute("link"))),s=n("parent"),r=n("child"),a=[...e.querySelectorAll("robot > joint")].find(h=>/revolute|continuous/.test(h.getAttribute("type"))),o=t.filter(h=>!s.has(h)),c=a?.querySelector("parent")?.getAttribute("link")??t.find(h=>!r.has(h)),l=o.find(h=>/^(tool0|.*flange|.*link8|.*ee|.*tip)$/i.test(h))??o.at(-1);for(let[h,f]of[["base",c],["tip",l]])ot(h).replaceChildren(...t.map(d=>new Option(d,d,!1,d===f)))}async function Yl(i){for(let t of i){let n=await bu(t);kn=kn.filter(s=>s.name!==n.name&&!(si(s)&&si(n))),kn.push(n)}let e=kn.find(si);ot("chosen").textContent=kn.map(({name:t})=>t).join(", "),ot("arm").hidden=!e,e&&[...i].some(si)&&Tu(e),ot("replay").disabled=ot("check").disabled=Ws().length===0,Ws().length>0&&[...i].some(t=>!si(t))&&await Ql()}function Kl(){let i=kn.find(si),e=ot("options").value.trim();return[...i?["--urdf",i.name,"--base",ot("base").value,"--tip",ot("tip").value]:[],...e?e.split(/\s+/):[]]}function oo(i,e){ot("verdict").textContent=i,ot("output").hidden=!1,ot("output").textContent=e.join(`
`)}async function jl(i,e){ot("verdict").textContent=i;for(let t of["replay","check"])ot(t).disabled=!0;await e();for(let t of["replay","check"])ot(t).disabled=!1}var Ql=()=>jl("replaying ...",async()=>{let i=Ws().at(-1),{code:e,output:t}=await Jl("replay_log",[i,"--json",...Kl()]);if(e!==0){ot("replayed").hidden=!0,oo(`${i} could not be replayed`,t);return}let n=t.filter(o=>o.startsWith("{")).map(o=>JSON.parse(o)),s=n.filter(({type:o})=>o==="estimate"),r=n.filter(({type:o,final:c})=>c||o==="rejected"),a=n.find(({type:o})=>o==="summary");ot("replayed").hidden=!1,ot("replayed").rows=s.map(({t:o,mass:c,std:l,truth:h})=>({t:o,mean:c,deviation:l[0],truth:h?.[0]})),$l(),oo(`${i}: ${a.samples} samples, ${a.estimates} changes of the payload, ${a.rejected} pushes`,[...n.filter(({type:o})=>o==="note").map(({text:o})=>o),...r.map(({t:o,kind:c,mass:l,std:h})=>`${o.toFixed(3)} s  ${c}`+(l===void 0?"":`  ${l.toFixed(3)} +- ${h[0].toFixed(3)} kg`))])});function $l(){let{rows:i}=ot("replayed");i?.length>1&&ao(ot("replayed"),i,i[0].t,i.at(-1).t)}var wu=()=>jl("checking ...",async()=>{let{code:i,output:e}=await Jl("check_arm",[...Ws(),...Kl()]);oo(["The arm fits: sign, units and frames of its torque can be right.","Sign, units or frames of the torque do not fit the arm.","check_arm does not take these options.","check_arm cannot use these files."][i],e)});function ec(){ot("files").addEventListener("change",({target:e})=>Yl(e.files)),ot("replay").addEventListener("click",Ql),ot("check").addEventListener("click",wu),addEventListener("resize",$l);let i=e=>t=>{t.dataTransfer?.types.includes("Files")&&(t.preventDefault(),ot("own").classList.toggle("over",e),t.type==="drop"&&Yl(t.dataTransfer.files))};for(let[e,t]of[["dragover",!0],["dragleave",!1],["drop",!1]])addEventListener(e,i(t))}var Rc=0,zo=1,_c=2;var As=1,Pc=2,Gi=3,Qn=0,Nt=1,xn=2,ui=0,Vi=1,ko=2,Go=3,Vo=4,Ic=5;var di=100,Lc=101,Dc=102,Nc=103,Uc=104,Fc=200,Oc=201,Bc=202,zc=203,Ho=204,Wo=205,kc=206,Gc=207,Vc=208,Hc=209,Wc=210,Xc=211,qc=212,Zc=213,Yc=214,yr=0,Mr=1,Sr=2,Ii=3,br=4,Tr=5,wr=6,Er=7,Qr=0,Jc=1,Kc=2,vn=0,Xo=1,qo=2,Zo=3,Yo=4,Jo=5,Ko=6,jo=7;var Qo=300,fi=301,Hi=302,$r=303,ea=304,Ar=1e3,fn=1001,Cr=1002,St=1003,jc=1004;var Cs=1005;var Dt=1006,ta=1007;var Nn=1008;var Bt=1009,$o=1010,el=1011,Wi=1012,na=1013,an=1014,on=1015,ln=1016,ia=1017,sa=1018,pi=1020,tl=35902,nl=35899,il=1021,sl=1022,cn=1023,_n=1026,Un=1027,rl=1028,ra=1029,$n=1030,aa=1031;var oa=1033,Rs=33776,_s=33777,Ps=33778,Is=33779,la=35840,ca=35841,ha=35842,ua=35843,da=36196,fa=37492,pa=37496,ma=37488,ga=37489,Ls=37490,xa=37491,va=37808,ya=37809,Ma=37810,Sa=37811,ba=37812,Ta=37813,wa=37814,Ea=37815,Aa=37816,Ca=37817,Ra=37818,_a=37819,Pa=37820,Ia=37821,La=36492,Da=36494,Na=36495,Ua=36283,Fa=36284,Ds=36285,Oa=36286;var ns=2300,Rr=2301,gr=2302,Lo=2303,Do=2400,No=2401,Uo=2402;var Qc=3200;var Ba=0,$c=1,Fn="",Gt="srgb",is="srgb-linear",ss="linear",Ze="srgb";var xr=7680;var eh=519,th=512,nh=513,ih=514,al=515,sh=516,rh=517,ol=518,ll=519,ah=35044;var cl="300 es",jt=2e3,Li=2001;function Eu(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Au(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function rs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function oh(){let i=rs("canvas");return i.style.display="block",i}var tc={},Di=null;function hl(...i){let e="THREE."+i.shift();Di?Di("log",e,...i):console.log(e,...i)}function lh(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ce(...i){i=lh(i);let e="THREE."+i.shift();if(Di)Di("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function _e(...i){i=lh(i);let e="THREE."+i.shift();if(Di)Di("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function ts(...i){let e=i.join(" ");e in tc||(tc[e]=!0,Ce(...i))}function ch(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var hh={[yr]:yr,[Sr]:wr,[br]:br,[Ii]:Tr,[Mr]:Mr,[wr]:Sr,[Er]:Er,[Tr]:Ii},mn=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},Ct=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var vr=Math.PI/180,_r=180/Math.PI;function Ns(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ct[i&255]+Ct[i>>8&255]+Ct[i>>16&255]+Ct[i>>24&255]+"-"+Ct[e&255]+Ct[e>>8&255]+"-"+Ct[e>>16&15|64]+Ct[e>>24&255]+"-"+Ct[t&63|128]+Ct[t>>8&255]+"-"+Ct[t>>16&255]+Ct[t>>24&255]+Ct[n&255]+Ct[n>>8&255]+Ct[n>>16&255]+Ct[n>>24&255]).toLowerCase()}function We(i,e,t){return Math.max(e,Math.min(t,i))}function Cu(i,e){return(i%e+e)%e}function lo(i,e,t){return(1-t)*i+t*e}function uh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ul(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ru(i,e){if(e.constructor===Float32Array)return i;let t=ul(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function _u(i,e){if(e.constructor===Float32Array)return i;let t=ul(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var He=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=We(this.x,e.x,t.x),this.y=We(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=We(this.x,e,t),this.y=We(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(We(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(We(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qt=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let c=n[s+0],l=n[s+1],h=n[s+2],f=n[s+3],d=r[a+0],m=r[a+1],g=r[a+2],M=r[a+3];if(f!==M||c!==d||l!==m||h!==g){let p=c*d+l*m+h*g+f*M;p<0&&(d=-d,m=-m,g=-g,M=-M,p=-p);let u=1-o;if(p<.9995){let S=Math.acos(p),A=Math.sin(S);u=Math.sin(u*S)/A,o=Math.sin(o*S)/A,c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+M*o}else{c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+M*o;let S=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=S,l*=S,h*=S,f*=S}}e[t]=c,e[t+1]=l,e[t+2]=h,e[t+3]=f}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],c=n[s+1],l=n[s+2],h=n[s+3],f=r[a],d=r[a+1],m=r[a+2],g=r[a+3];return e[t]=o*g+h*f+c*m-l*d,e[t+1]=c*g+h*d+l*f-o*m,e[t+2]=l*g+h*m+o*d-c*f,e[t+3]=h*g-o*f-c*d-l*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,c=Math.sin,l=o(n/2),h=o(s/2),f=o(r/2),d=c(n/2),m=c(s/2),g=c(r/2);switch(a){case"XYZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"YXZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"ZXY":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"ZYX":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"YZX":this._x=d*h*f+l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f-d*m*g;break;case"XZY":this._x=d*h*f-l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f+d*m*g;break;default:Ce("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],c=t[9],l=t[2],h=t[6],f=t[10],d=n+o+f;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-c)*m,this._y=(r-l)*m,this._z=(a-s)*m}else if(n>o&&n>f){let m=2*Math.sqrt(1+n-o-f);this._w=(h-c)/m,this._x=.25*m,this._y=(s+a)/m,this._z=(r+l)/m}else if(o>f){let m=2*Math.sqrt(1+o-n-f);this._w=(r-l)/m,this._x=(s+a)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+f-n-o);this._w=(a-s)/m,this._x=(r+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(We(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,c=t._y,l=t._z,h=t._w;return this._x=n*h+a*o+s*l-r*c,this._y=s*h+a*c+r*o-n*l,this._z=r*h+a*l+n*c-s*o,this._w=a*h-n*o-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let c=1-t;if(o<.9995){let l=Math.acos(o),h=Math.sin(l);c=Math.sin(c*l)/h,t=Math.sin(t*l)/h,this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+a*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(nc.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(nc.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,c=e.w,l=2*(a*s-o*n),h=2*(o*t-r*s),f=2*(r*n-a*t);return this.x=t+c*l+a*f-o*h,this.y=n+c*h+o*l-r*f,this.z=s+c*f+r*h-a*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=We(this.x,e.x,t.x),this.y=We(this.y,e.y,t.y),this.z=We(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=We(this.x,e,t),this.y=We(this.y,e,t),this.z=We(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(We(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,c=t.z;return this.x=s*c-r*o,this.y=r*a-n*c,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return co.copy(this).projectOnVector(e),this.sub(co)}reflect(e){return this.sub(co.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(We(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},co=new U,nc=new Qt,Pe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,c,l)}set(e,t,n,s,r,a,o,c,l){let h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=c,h[6]=n,h[7]=a,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],c=n[6],l=n[1],h=n[4],f=n[7],d=n[2],m=n[5],g=n[8],M=s[0],p=s[3],u=s[6],S=s[1],A=s[4],T=s[7],C=s[2],E=s[5],x=s[8];return r[0]=a*M+o*S+c*C,r[3]=a*p+o*A+c*E,r[6]=a*u+o*T+c*x,r[1]=l*M+h*S+f*C,r[4]=l*p+h*A+f*E,r[7]=l*u+h*T+f*x,r[2]=d*M+m*S+g*C,r[5]=d*p+m*A+g*E,r[8]=d*u+m*T+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],c=e[6],l=e[7],h=e[8];return t*a*h-t*o*l-n*r*h+n*o*c+s*r*l-s*a*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],c=e[6],l=e[7],h=e[8],f=h*a-o*l,d=o*c-h*r,m=l*r-a*c,g=t*f+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return e[0]=f*M,e[1]=(s*l-h*n)*M,e[2]=(o*n-s*a)*M,e[3]=d*M,e[4]=(h*t-s*c)*M,e[5]=(s*r-o*t)*M,e[6]=m*M,e[7]=(n*c-l*t)*M,e[8]=(a*t-n*r)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*a+l*o)+a+e,-s*l,s*c,-s*(-l*a+c*o)+o+t,0,0,1),this}scale(e,t){return ts("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ho.makeScale(e,t)),this}rotate(e){return ts("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ho.makeRotation(-e)),this}translate(e,t){return ts("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ho.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ho=new Pe,ic=new Pe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sc=new Pe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Pu(){let i={enabled:!0,workingColorSpace:is,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Ze&&(s.r=Rn(s.r),s.g=Rn(s.g),s.b=Rn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Ze&&(s.r=Pi(s.r),s.g=Pi(s.g),s.b=Pi(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fn?ss:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[is]:{primaries:e,whitePoint:n,transfer:ss,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Gt},outputColorSpaceConfig:{drawingBufferColorSpace:Gt}},[Gt]:{primaries:e,whitePoint:n,transfer:Ze,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Gt}}}),i}var Ve=Pu();function Rn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Pi(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xi,Pr=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{xi===void 0&&(xi=rs("canvas")),xi.width=e.width,xi.height=e.height;let s=xi.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=xi}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=rs("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Rn(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Rn(t[n]/255)*255):t[n]=Rn(t[n]);return{data:t,width:e.width,height:e.height}}else return Ce("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Iu=0,Ni=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Iu++}),this.uuid=Ns(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(uo(s[a].image)):r.push(uo(s[a]))}else r=uo(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function uo(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Pr.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ce("Texture: Unable to serialize Texture."),{})}var Lu=0,fo=new U,Ot=class i extends mn{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=fn,s=fn,r=Dt,a=Nn,o=cn,c=Bt,l=i.DEFAULT_ANISOTROPY,h=Fn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Lu++}),this.uuid=Ns(),this.name="",this.source=new Ni(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new He(0,0),this.repeat=new He(1,1),this.center=new He(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Pe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fo).x}get height(){return this.source.getSize(fo).y}get depth(){return this.source.getSize(fo).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ce(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ce(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Qo)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ar:e.x=e.x-Math.floor(e.x);break;case fn:e.x=e.x<0?0:1;break;case Cr:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ar:e.y=e.y-Math.floor(e.y);break;case fn:e.y=e.y<0?0:1;break;case Cr:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Ot.DEFAULT_IMAGE=null;Ot.DEFAULT_MAPPING=Qo;Ot.DEFAULT_ANISOTROPY=1;var st=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],h=c[4],f=c[8],d=c[1],m=c[5],g=c[9],M=c[2],p=c[6],u=c[10];if(Math.abs(h-d)<.01&&Math.abs(f-M)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+M)<.1&&Math.abs(g+p)<.1&&Math.abs(l+m+u-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(l+1)/2,T=(m+1)/2,C=(u+1)/2,E=(h+d)/4,x=(f+M)/4,b=(g+p)/4;return A>T&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):T>C?T<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(T),n=E/s,r=b/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=b/r),this.set(n,s,r,t),this}let S=Math.sqrt((p-g)*(p-g)+(f-M)*(f-M)+(d-h)*(d-h));return Math.abs(S)<.001&&(S=1),this.x=(p-g)/S,this.y=(f-M)/S,this.z=(d-h)/S,this.w=Math.acos((l+m+u-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=We(this.x,e.x,t.x),this.y=We(this.y,e.y,t.y),this.z=We(this.z,e.z,t.z),this.w=We(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=We(this.x,e,t),this.y=We(this.y,e,t),this.z=We(this.z,e,t),this.w=We(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(We(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ir=class extends mn{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Dt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new st(0,0,e,t),this.scissorTest=!1,this.viewport=new st(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Ot({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Dt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ni(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ht=class extends Ir{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},as=class extends Ot{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=St,this.minFilter=St,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Lr=class extends Ot{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=St,this.minFilter=St,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Qe=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,c,l,h,f,d,m,g,M,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,c,l,h,f,d,m,g,M,p)}set(e,t,n,s,r,a,o,c,l,h,f,d,m,g,M,p){let u=this.elements;return u[0]=e,u[4]=t,u[8]=n,u[12]=s,u[1]=r,u[5]=a,u[9]=o,u[13]=c,u[2]=l,u[6]=h,u[10]=f,u[14]=d,u[3]=m,u[7]=g,u[11]=M,u[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/vi.setFromMatrixColumn(e,0).length(),r=1/vi.setFromMatrixColumn(e,1).length(),a=1/vi.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let d=a*h,m=a*f,g=o*h,M=o*f;t[0]=c*h,t[4]=-c*f,t[8]=l,t[1]=m+g*l,t[5]=d-M*l,t[9]=-o*c,t[2]=M-d*l,t[6]=g+m*l,t[10]=a*c}else if(e.order==="YXZ"){let d=c*h,m=c*f,g=l*h,M=l*f;t[0]=d+M*o,t[4]=g*o-m,t[8]=a*l,t[1]=a*f,t[5]=a*h,t[9]=-o,t[2]=m*o-g,t[6]=M+d*o,t[10]=a*c}else if(e.order==="ZXY"){let d=c*h,m=c*f,g=l*h,M=l*f;t[0]=d-M*o,t[4]=-a*f,t[8]=g+m*o,t[1]=m+g*o,t[5]=a*h,t[9]=M-d*o,t[2]=-a*l,t[6]=o,t[10]=a*c}else if(e.order==="ZYX"){let d=a*h,m=a*f,g=o*h,M=o*f;t[0]=c*h,t[4]=g*l-m,t[8]=d*l+M,t[1]=c*f,t[5]=M*l+d,t[9]=m*l-g,t[2]=-l,t[6]=o*c,t[10]=a*c}else if(e.order==="YZX"){let d=a*c,m=a*l,g=o*c,M=o*l;t[0]=c*h,t[4]=M-d*f,t[8]=g*f+m,t[1]=f,t[5]=a*h,t[9]=-o*h,t[2]=-l*h,t[6]=m*f+g,t[10]=d-M*f}else if(e.order==="XZY"){let d=a*c,m=a*l,g=o*c,M=o*l;t[0]=c*h,t[4]=-f,t[8]=l*h,t[1]=d*f+M,t[5]=a*h,t[9]=m*f-g,t[2]=g*f-m,t[6]=o*h,t[10]=M*f+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Du,e,Nu)}lookAt(e,t,n){let s=this.elements;return zt.subVectors(e,t),zt.lengthSq()===0&&(zt.z=1),zt.normalize(),Gn.crossVectors(n,zt),Gn.lengthSq()===0&&(Math.abs(n.z)===1?zt.x+=1e-4:zt.z+=1e-4,zt.normalize(),Gn.crossVectors(n,zt)),Gn.normalize(),Xs.crossVectors(zt,Gn),s[0]=Gn.x,s[4]=Xs.x,s[8]=zt.x,s[1]=Gn.y,s[5]=Xs.y,s[9]=zt.y,s[2]=Gn.z,s[6]=Xs.z,s[10]=zt.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],c=n[8],l=n[12],h=n[1],f=n[5],d=n[9],m=n[13],g=n[2],M=n[6],p=n[10],u=n[14],S=n[3],A=n[7],T=n[11],C=n[15],E=s[0],x=s[4],b=s[8],N=s[12],I=s[1],D=s[5],B=s[9],H=s[13],_=s[2],V=s[6],q=s[10],G=s[14],te=s[3],X=s[7],Q=s[11],$=s[15];return r[0]=a*E+o*I+c*_+l*te,r[4]=a*x+o*D+c*V+l*X,r[8]=a*b+o*B+c*q+l*Q,r[12]=a*N+o*H+c*G+l*$,r[1]=h*E+f*I+d*_+m*te,r[5]=h*x+f*D+d*V+m*X,r[9]=h*b+f*B+d*q+m*Q,r[13]=h*N+f*H+d*G+m*$,r[2]=g*E+M*I+p*_+u*te,r[6]=g*x+M*D+p*V+u*X,r[10]=g*b+M*B+p*q+u*Q,r[14]=g*N+M*H+p*G+u*$,r[3]=S*E+A*I+T*_+C*te,r[7]=S*x+A*D+T*V+C*X,r[11]=S*b+A*B+T*q+C*Q,r[15]=S*N+A*H+T*G+C*$,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],c=e[9],l=e[13],h=e[2],f=e[6],d=e[10],m=e[14],g=e[3],M=e[7],p=e[11],u=e[15],S=c*m-l*d,A=o*m-l*f,T=o*d-c*f,C=a*m-l*h,E=a*d-c*h,x=a*f-o*h;return t*(M*S-p*A+u*T)-n*(g*S-p*C+u*E)+s*(g*A-M*C+u*x)-r*(g*T-M*E+p*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],c=e[2],l=e[6],h=e[10];return t*(a*h-o*l)-n*(r*h-o*c)+s*(r*l-a*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],c=e[6],l=e[7],h=e[8],f=e[9],d=e[10],m=e[11],g=e[12],M=e[13],p=e[14],u=e[15],S=t*o-n*a,A=t*c-s*a,T=t*l-r*a,C=n*c-s*o,E=n*l-r*o,x=s*l-r*c,b=h*M-f*g,N=h*p-d*g,I=h*u-m*g,D=f*p-d*M,B=f*u-m*M,H=d*u-m*p,_=S*H-A*B+T*D+C*I-E*N+x*b;if(_===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/_;return e[0]=(o*H-c*B+l*D)*V,e[1]=(s*B-n*H-r*D)*V,e[2]=(M*x-p*E+u*C)*V,e[3]=(d*E-f*x-m*C)*V,e[4]=(c*I-a*H-l*N)*V,e[5]=(t*H-s*I+r*N)*V,e[6]=(p*T-g*x-u*A)*V,e[7]=(h*x-d*T+m*A)*V,e[8]=(a*B-o*I+l*b)*V,e[9]=(n*I-t*B-r*b)*V,e[10]=(g*E-M*T+u*S)*V,e[11]=(f*T-h*E-m*S)*V,e[12]=(o*N-a*D-c*b)*V,e[13]=(t*D-n*N+s*b)*V,e[14]=(M*A-g*C-p*S)*V,e[15]=(h*C-f*A+d*S)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,c=e.z,l=r*a,h=r*o;return this.set(l*a+n,l*o-s*c,l*c+s*o,0,l*o+s*c,h*o+n,h*c-s*a,0,l*c-s*o,h*c+s*a,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,c=t._w,l=r+r,h=a+a,f=o+o,d=r*l,m=r*h,g=r*f,M=a*h,p=a*f,u=o*f,S=c*l,A=c*h,T=c*f,C=n.x,E=n.y,x=n.z;return s[0]=(1-(M+u))*C,s[1]=(m+T)*C,s[2]=(g-A)*C,s[3]=0,s[4]=(m-T)*E,s[5]=(1-(d+u))*E,s[6]=(p+S)*E,s[7]=0,s[8]=(g+A)*x,s[9]=(p-S)*x,s[10]=(1-(d+M))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=vi.set(s[0],s[1],s[2]).length(),o=vi.set(s[4],s[5],s[6]).length(),c=vi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),tn.copy(this);let l=1/a,h=1/o,f=1/c;return tn.elements[0]*=l,tn.elements[1]*=l,tn.elements[2]*=l,tn.elements[4]*=h,tn.elements[5]*=h,tn.elements[6]*=h,tn.elements[8]*=f,tn.elements[9]*=f,tn.elements[10]*=f,t.setFromRotationMatrix(tn),n.x=a,n.y=o,n.z=c,this}makePerspective(e,t,n,s,r,a,o=jt,c=!1){let l=this.elements,h=2*r/(t-e),f=2*r/(n-s),d=(t+e)/(t-e),m=(n+s)/(n-s),g,M;if(c)g=r/(a-r),M=a*r/(a-r);else if(o===jt)g=-(a+r)/(a-r),M=-2*a*r/(a-r);else if(o===Li)g=-a/(a-r),M=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=jt,c=!1){let l=this.elements,h=2/(t-e),f=2/(n-s),d=-(t+e)/(t-e),m=-(n+s)/(n-s),g,M;if(c)g=1/(a-r),M=a/(a-r);else if(o===jt)g=-2/(a-r),M=-(a+r)/(a-r);else if(o===Li)g=-1/(a-r),M=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},vi=new U,tn=new Qe,Du=new U(0,0,0),Nu=new U(1,1,1),Gn=new U,Xs=new U,zt=new U,rc=new Qe,ac=new Qt,Pn=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],c=s[1],l=s[5],h=s[9],f=s[2],d=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(We(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-We(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(We(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-a,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-We(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-a,l));break;case"YZX":this._z=Math.asin(We(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,m));break;case"XZY":this._z=Math.asin(-We(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Ce("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return rc.makeRotationFromQuaternion(e),this.setFromRotationMatrix(rc,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ac.setFromEuler(this),this.setFromQuaternion(ac,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pn.DEFAULT_ORDER="XYZ";var os=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Uu=0,oc=new U,yi=new Qt,bn=new Qe,qs=new U,Ki=new U,Fu=new U,Ou=new Qt,lc=new U(1,0,0),cc=new U(0,1,0),hc=new U(0,0,1),uc={type:"added"},Bu={type:"removed"},Mi={type:"childadded",child:null},po={type:"childremoved",child:null},wt=class i extends mn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Uu++}),this.uuid=Ns(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new U,t=new Pn,n=new Qt,s=new U(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qe},normalMatrix:{value:new Pe}}),this.matrix=new Qe,this.matrixWorld=new Qe,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new os,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return yi.setFromAxisAngle(e,t),this.quaternion.multiply(yi),this}rotateOnWorldAxis(e,t){return yi.setFromAxisAngle(e,t),this.quaternion.premultiply(yi),this}rotateX(e){return this.rotateOnAxis(lc,e)}rotateY(e){return this.rotateOnAxis(cc,e)}rotateZ(e){return this.rotateOnAxis(hc,e)}translateOnAxis(e,t){return oc.copy(e).applyQuaternion(this.quaternion),this.position.add(oc.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(lc,e)}translateY(e){return this.translateOnAxis(cc,e)}translateZ(e){return this.translateOnAxis(hc,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(bn.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?qs.copy(e):qs.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ki.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bn.lookAt(Ki,qs,this.up):bn.lookAt(qs,Ki,this.up),this.quaternion.setFromRotationMatrix(bn),s&&(bn.extractRotation(s.matrixWorld),yi.setFromRotationMatrix(bn),this.quaternion.premultiply(yi.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(_e("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(uc),Mi.child=e,this.dispatchEvent(Mi),Mi.child=null):_e("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Bu),po.child=e,this.dispatchEvent(po),po.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),bn.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),bn.multiply(e.parent.matrixWorld)),e.applyMatrix4(bn),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(uc),Mi.child=e,this.dispatchEvent(Mi),Mi.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,e,Fu),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,Ou,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let c=o.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];r(e.shapes,f)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(r(e.materials,this.material[c]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let c=this.animations[o];s.animations.push(r(e.animations,c))}}if(t){let o=a(e.geometries),c=a(e.materials),l=a(e.textures),h=a(e.images),f=a(e.shapes),d=a(e.skeletons),m=a(e.animations),g=a(e.nodes);o.length>0&&(n.geometries=o),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let c=[];for(let l in o){let h=o[l];delete h.metadata,c.push(h)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};wt.DEFAULT_UP=new U(0,1,0);wt.DEFAULT_MATRIX_AUTO_UPDATE=!0;wt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Vt=class extends wt{constructor(){super(),this.isGroup=!0,this.type="Group"}},zu={type:"move"},Ui=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Vt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Vt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Vt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){a=!0;for(let M of e.hand.values()){let p=t.getJointPose(M,n),u=this._getHandJoint(l,M);p!==null&&(u.matrix.fromArray(p.transform.matrix),u.matrix.decompose(u.position,u.quaternion,u.scale),u.matrixWorldNeedsUpdate=!0,u.jointRadius=p.radius),u.visible=p!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],d=h.position.distanceTo(f.position),m=.02,g=.005;l.inputState.pinching&&d>m+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&d<=m-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(zu)))}return o!==null&&(o.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Vt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},dh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vn={h:0,s:0,l:0},Zs={h:0,s:0,l:0};function mo(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ue=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Gt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ve.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Ve.workingColorSpace){return this.r=e,this.g=t,this.b=n,Ve.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Ve.workingColorSpace){if(e=Cu(e,1),t=We(t,0,1),n=We(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=mo(a,r,e+1/3),this.g=mo(a,r,e),this.b=mo(a,r,e-1/3)}return Ve.colorSpaceToWorking(this,s),this}setStyle(e,t=Gt){function n(r){r!==void 0&&parseFloat(r)<1&&Ce("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ce("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Ce("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Gt){let n=dh[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ce("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Rn(e.r),this.g=Rn(e.g),this.b=Rn(e.b),this}copyLinearToSRGB(e){return this.r=Pi(e.r),this.g=Pi(e.g),this.b=Pi(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Gt){return Ve.workingToColorSpace(Rt.copy(this),e),Math.round(We(Rt.r*255,0,255))*65536+Math.round(We(Rt.g*255,0,255))*256+Math.round(We(Rt.b*255,0,255))}getHexString(e=Gt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ve.workingColorSpace){Ve.workingToColorSpace(Rt.copy(this),t);let n=Rt.r,s=Rt.g,r=Rt.b,a=Math.max(n,s,r),o=Math.min(n,s,r),c,l,h=(o+a)/2;if(o===a)c=0,l=0;else{let f=a-o;switch(l=h<=.5?f/(a+o):f/(2-a-o),a){case n:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-n)/f+2;break;case r:c=(n-s)/f+4;break}c/=6}return e.h=c,e.s=l,e.l=h,e}getRGB(e,t=Ve.workingColorSpace){return Ve.workingToColorSpace(Rt.copy(this),t),e.r=Rt.r,e.g=Rt.g,e.b=Rt.b,e}getStyle(e=Gt){Ve.workingToColorSpace(Rt.copy(this),e);let t=Rt.r,n=Rt.g,s=Rt.b;return e!==Gt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Vn),this.setHSL(Vn.h+e,Vn.s+t,Vn.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Vn),e.getHSL(Zs);let n=lo(Vn.h,Zs.h,t),s=lo(Vn.s,Zs.s,t),r=lo(Vn.l,Zs.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Rt=new Ue;Ue.NAMES=dh;var ls=class extends wt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pn,this.environmentIntensity=1,this.environmentRotation=new Pn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},nn=new U,Tn=new U,go=new U,wn=new U,Si=new U,bi=new U,dc=new U,xo=new U,vo=new U,yo=new U,Mo=new st,So=new st,bo=new st,Cn=class i{constructor(e=new U,t=new U,n=new U){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),nn.subVectors(e,t),s.cross(nn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){nn.subVectors(s,t),Tn.subVectors(n,t),go.subVectors(e,t);let a=nn.dot(nn),o=nn.dot(Tn),c=nn.dot(go),l=Tn.dot(Tn),h=Tn.dot(go),f=a*l-o*o;if(f===0)return r.set(0,0,0),null;let d=1/f,m=(l*c-o*h)*d,g=(a*h-o*c)*d;return r.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,wn)===null?!1:wn.x>=0&&wn.y>=0&&wn.x+wn.y<=1}static getInterpolation(e,t,n,s,r,a,o,c){return this.getBarycoord(e,t,n,s,wn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,wn.x),c.addScaledVector(a,wn.y),c.addScaledVector(o,wn.z),c)}static getInterpolatedAttribute(e,t,n,s,r,a){return Mo.setScalar(0),So.setScalar(0),bo.setScalar(0),Mo.fromBufferAttribute(e,t),So.fromBufferAttribute(e,n),bo.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Mo,r.x),a.addScaledVector(So,r.y),a.addScaledVector(bo,r.z),a}static isFrontFacing(e,t,n,s){return nn.subVectors(n,t),Tn.subVectors(e,t),nn.cross(Tn).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return nn.subVectors(this.c,this.b),Tn.subVectors(this.a,this.b),nn.cross(Tn).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;Si.subVectors(s,n),bi.subVectors(r,n),xo.subVectors(e,n);let c=Si.dot(xo),l=bi.dot(xo);if(c<=0&&l<=0)return t.copy(n);vo.subVectors(e,s);let h=Si.dot(vo),f=bi.dot(vo);if(h>=0&&f<=h)return t.copy(s);let d=c*f-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return a=c/(c-h),t.copy(n).addScaledVector(Si,a);yo.subVectors(e,r);let m=Si.dot(yo),g=bi.dot(yo);if(g>=0&&m<=g)return t.copy(r);let M=m*l-c*g;if(M<=0&&l>=0&&g<=0)return o=l/(l-g),t.copy(n).addScaledVector(bi,o);let p=h*g-m*f;if(p<=0&&f-h>=0&&m-g>=0)return dc.subVectors(r,s),o=(f-h)/(f-h+(m-g)),t.copy(s).addScaledVector(dc,o);let u=1/(p+M+d);return a=M*u,o=d*u,t.copy(n).addScaledVector(Si,a).addScaledVector(bi,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},qn=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(sn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(sn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=sn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,sn):sn.fromBufferAttribute(r,a),sn.applyMatrix4(e.matrixWorld),this.expandByPoint(sn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ys.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ys.copy(n.boundingBox)),Ys.applyMatrix4(e.matrixWorld),this.union(Ys)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,sn),sn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ji),Js.subVectors(this.max,ji),Ti.subVectors(e.a,ji),wi.subVectors(e.b,ji),Ei.subVectors(e.c,ji),Hn.subVectors(wi,Ti),Wn.subVectors(Ei,wi),ri.subVectors(Ti,Ei);let t=[0,-Hn.z,Hn.y,0,-Wn.z,Wn.y,0,-ri.z,ri.y,Hn.z,0,-Hn.x,Wn.z,0,-Wn.x,ri.z,0,-ri.x,-Hn.y,Hn.x,0,-Wn.y,Wn.x,0,-ri.y,ri.x,0];return!To(t,Ti,wi,Ei,Js)||(t=[1,0,0,0,1,0,0,0,1],!To(t,Ti,wi,Ei,Js))?!1:(Ks.crossVectors(Hn,Wn),t=[Ks.x,Ks.y,Ks.z],To(t,Ti,wi,Ei,Js))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,sn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(sn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(En[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),En[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),En[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),En[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),En[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),En[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),En[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),En[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(En),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},En=[new U,new U,new U,new U,new U,new U,new U,new U],sn=new U,Ys=new qn,Ti=new U,wi=new U,Ei=new U,Hn=new U,Wn=new U,ri=new U,ji=new U,Js=new U,Ks=new U,ai=new U;function To(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){ai.fromArray(i,r);let o=s.x*Math.abs(ai.x)+s.y*Math.abs(ai.y)+s.z*Math.abs(ai.z),c=e.dot(ai),l=t.dot(ai),h=n.dot(ai);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>o)return!1}return!0}var ht=new U,js=new He,ku=0,pn=class extends mn{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ku++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=ah,this.updateRanges=[],this.gpuType=on,this.version=0,this._normalizationScale=e!==void 0?ul(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)js.fromBufferAttribute(this,t),js.applyMatrix3(e),this.setXY(t,js.x,js.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.applyMatrix3(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.applyMatrix4(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.applyNormalMatrix(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.transformDirection(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ru(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):_u(e,this.array)}};var cs=class extends pn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var hs=class extends pn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var et=class extends pn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Gu=new qn,Qi=new U,wo=new U,ci=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Gu.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Qi.subVectors(e,this.center);let t=Qi.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Qi,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(wo.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Qi.copy(e.center).add(wo)),this.expandByPoint(Qi.copy(e.center).sub(wo))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Vu=0,Kt=new Qe,Eo=new wt,Ai=new U,kt=new qn,$i=new qn,Mt=new U,_t=class i extends mn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Vu++}),this.uuid=Ns(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Eu(e)?hs:cs)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Pe().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Kt.makeRotationFromQuaternion(e),this.applyMatrix4(Kt),this}rotateX(e){return Kt.makeRotationX(e),this.applyMatrix4(Kt),this}rotateY(e){return Kt.makeRotationY(e),this.applyMatrix4(Kt),this}rotateZ(e){return Kt.makeRotationZ(e),this.applyMatrix4(Kt),this}translate(e,t,n){return Kt.makeTranslation(e,t,n),this.applyMatrix4(Kt),this}scale(e,t,n){return Kt.makeScale(e,t,n),this.applyMatrix4(Kt),this}lookAt(e){return Eo.lookAt(e),Eo.updateMatrix(),this.applyMatrix4(Eo.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ai).negate(),this.translate(Ai.x,Ai.y,Ai.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new et(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ce("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){_e("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];kt.setFromBufferAttribute(r),this.morphTargetsRelative?(Mt.addVectors(this.boundingBox.min,kt.min),this.boundingBox.expandByPoint(Mt),Mt.addVectors(this.boundingBox.max,kt.max),this.boundingBox.expandByPoint(Mt)):(this.boundingBox.expandByPoint(kt.min),this.boundingBox.expandByPoint(kt.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&_e('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ci);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){_e("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let n=this.boundingSphere.center;if(kt.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];$i.setFromBufferAttribute(o),this.morphTargetsRelative?(Mt.addVectors(kt.min,$i.min),kt.expandByPoint(Mt),Mt.addVectors(kt.max,$i.max),kt.expandByPoint(Mt)):(kt.expandByPoint($i.min),kt.expandByPoint($i.max))}kt.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)Mt.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Mt));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],c=this.morphTargetsRelative;for(let l=0,h=o.count;l<h;l++)Mt.fromBufferAttribute(o,l),c&&(Ai.fromBufferAttribute(e,l),Mt.add(Ai)),s=Math.max(s,n.distanceToSquared(Mt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&_e('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){_e("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],c=[],l=new Uint8Array(n.count);for(let N=0;N<n.count;N++)o[N]=new U,c[N]=new U;let h=new U,f=new U,d=new U,m=new He,g=new He,M=new He,p=new U,u=new U;function S(N,I,D){l[N]=l[I]=l[D]=1,h.fromBufferAttribute(n,N),f.fromBufferAttribute(n,I),d.fromBufferAttribute(n,D),m.fromBufferAttribute(r,N),g.fromBufferAttribute(r,I),M.fromBufferAttribute(r,D),f.sub(h),d.sub(h),g.sub(m),M.sub(m);let B=1/(g.x*M.y-M.x*g.y);isFinite(B)&&(p.copy(f).multiplyScalar(M.y).addScaledVector(d,-g.y).multiplyScalar(B),u.copy(d).multiplyScalar(g.x).addScaledVector(f,-M.x).multiplyScalar(B),o[N].add(p),o[I].add(p),o[D].add(p),c[N].add(u),c[I].add(u),c[D].add(u))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let N=0,I=A.length;N<I;++N){let D=A[N],B=D.start,H=D.count;for(let _=B,V=B+H;_<V;_+=3)S(e.getX(_+0),e.getX(_+1),e.getX(_+2))}let T=new U,C=new U,E=new U,x=new U;function b(N){E.fromBufferAttribute(s,N),x.copy(E);let I=o[N];T.copy(I),T.sub(E.multiplyScalar(E.dot(I))).normalize(),C.crossVectors(x,I);let B=C.dot(c[N])<0?-1:1;a.setXYZW(N,T.x,T.y,T.z,B)}for(let N=0,I=n.count;N<I;++N)l[N]&&b(N);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new pn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new U,r=new U,a=new U,o=new U,c=new U,l=new U,h=new U,f=new U;if(e)for(let d=0,m=e.count;d<m;d+=3){let g=e.getX(d+0),M=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,M),a.fromBufferAttribute(t,p),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),o.fromBufferAttribute(n,g),c.fromBufferAttribute(n,M),l.fromBufferAttribute(n,p),o.add(h),c.add(h),l.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(M,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,m=t.count;d<m;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),a.fromBufferAttribute(t,d+2),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Mt.fromBufferAttribute(e,t),Mt.normalize(),e.setXYZ(t,Mt.x,Mt.y,Mt.z)}toNonIndexed(){function e(o,c){let l=o.array,h=o.itemSize,f=o.normalized,d=new l.constructor(c.length*h),m=0,g=0;for(let M=0,p=c.length;M<p;M++){o.isInterleavedBufferAttribute?m=c[M]*o.data.stride+o.offset:m=c[M]*h;for(let u=0;u<h;u++)d[g++]=l[m++]}return new pn(d,h,f)}if(this.index===null)return Ce("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let c=s[o],l=e(c,n);t.setAttribute(o,l)}let r=this.morphAttributes;for(let o in r){let c=[],l=r[o];for(let h=0,f=l.length;h<f;h++){let d=l[h],m=e(d,n);c.push(m)}t.morphAttributes[o]=c}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,c=a.length;o<c;o++){let l=a[o];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,d=l.length;f<d;f++){let m=l[f];h.push(m.toJSON(e.data))}h.length>0&&(s[c]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(t))}let r=e.morphAttributes;for(let l in r){let h=[],f=r[l];for(let d=0,m=f.length;d<m;d++)h.push(f[d].clone(t));this.morphAttributes[l]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let l=0,h=a.length;l<h;l++){let f=a[l];this.addGroup(f.start,f.count,f.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ao=new U,Hu=new U,Wu=new Pe,rn=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Ao.subVectors(n,t).cross(Hu.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Ao),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Wu.getNormalMatrix(e),s=this.coplanarPoint(Ao).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Xu=0,In=class extends mn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Xu++}),this.uuid=Ns(),this.name="",this.type="Material",this.blending=Vi,this.side=Qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ho,this.blendDst=Wo,this.blendEquation=di,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ue(0,0,0),this.blendAlpha=0,this.depthFunc=Ii,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=eh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xr,this.stencilZFail=xr,this.stencilZPass=xr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ce(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ce(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let c=r[o];delete c.metadata,a.push(c)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ue().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new rn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new He().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new He().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var An=new U,Co=new U,Qs=new U,$s=new U,us=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,An)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=An.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(An.copy(this.origin).addScaledVector(this.direction,t),An.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Co.copy(e).add(t).multiplyScalar(.5),Qs.copy(t).sub(e).normalize(),$s.copy(this.origin).sub(Co);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Qs),o=$s.dot(this.direction),c=-$s.dot(Qs),l=$s.lengthSq(),h=Math.abs(1-a*a),f,d,m,g;if(h>0)if(f=a*c-o,d=a*o-c,g=r*h,f>=0)if(d>=-g)if(d<=g){let M=1/h;f*=M,d*=M,m=f*(f+a*d+2*o)+d*(a*f+d+2*c)+l}else d=r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d=-r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d<=-g?(f=Math.max(0,-(-a*r+o)),d=f>0?-r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l):d<=g?(f=0,d=Math.min(Math.max(-r,-c),r),m=d*(d+2*c)+l):(f=Math.max(0,-(a*r+o)),d=f>0?r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l);else d=a>0?-r:r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Co).addScaledVector(Qs,d),m}intersectSphere(e,t){if(e.radius<0)return null;An.subVectors(e.center,this.origin);let n=An.dot(this.direction),s=An.dot(An)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,c=n+a;return c<0?null:o<0?this.at(c,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return l>=0?(n=(e.min.x-d.x)*l,s=(e.max.x-d.x)*l):(n=(e.max.x-d.x)*l,s=(e.min.x-d.x)*l),h>=0?(r=(e.min.y-d.y)*h,a=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,a=(e.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(e.min.z-d.z)*f,c=(e.max.z-d.z)*f):(o=(e.max.z-d.z)*f,c=(e.min.z-d.z)*f),n>c||o>s)||((o>n||n!==n)&&(n=o),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,An)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,c=o.x,l=o.y,h=o.z,f=e.x-a.x,d=e.y-a.y,m=e.z-a.z,g=t.x-a.x,M=t.y-a.y,p=t.z-a.z,u=n.x-a.x,S=n.y-a.y,A=n.z-a.z,T=Math.abs(c),C=Math.abs(l),E=Math.abs(h),x,b,N,I,D,B,H,_,V,q,G,te;if(T>=C&&T>=E?(N=c,B=f,V=g,te=u,c>=0?(x=l,b=h,I=d,D=m,H=M,_=p,q=S,G=A):(x=h,b=l,I=m,D=d,H=p,_=M,q=A,G=S)):C>=E?(N=l,B=d,V=M,te=S,l>=0?(x=h,b=c,I=m,D=f,H=p,_=g,q=A,G=u):(x=c,b=h,I=f,D=m,H=g,_=p,q=u,G=A)):(N=h,B=m,V=p,te=A,h>=0?(x=c,b=l,I=f,D=d,H=g,_=M,q=u,G=S):(x=l,b=c,I=d,D=f,H=M,_=g,q=S,G=u)),N===0)return null;let X=x/N,Q=b/N,$=1/N,Se=I-X*B,Le=D-Q*B,J=H-X*V,pe=_-Q*V,ve=q-X*te,Ee=G-Q*te,me=ve*pe-Ee*J,Ne=Se*Ee-Le*ve,lt=J*Le-pe*Se;if(s){if(me<0||Ne<0||lt<0)return null}else if((me<0||Ne<0||lt<0)&&(me>0||Ne>0||lt>0))return null;let Re=me+Ne+lt;if(Re===0)return null;let Ye=$*(me*B+Ne*V+lt*te);return(Re>0?Ye<0:Ye>0)?null:this.at(Ye/Re,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$t=class extends In{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Qr,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},fc=new Qe,oi=new us,er=new ci,pc=new U,tr=new U,nr=new U,ir=new U,Ro=new U,sr=new U,mc=new U,rr=new U,pt=class extends wt{constructor(e=new _t,t=new $t){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){sr.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=o[c],f=r[c];h!==0&&(Ro.fromBufferAttribute(f,e),a?sr.addScaledVector(Ro,h):sr.addScaledVector(Ro.sub(t),h))}t.add(sr)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),er.copy(n.boundingSphere),er.applyMatrix4(r),oi.copy(e.ray).recast(e.near),!(er.containsPoint(oi.origin)===!1&&(oi.intersectSphere(er,pc)===null||oi.origin.distanceToSquared(pc)>(e.far-e.near)**2))&&(fc.copy(r).invert(),oi.copy(e.ray).applyMatrix4(fc),!(n.boundingBox!==null&&oi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,oi)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,m=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,M=d.length;g<M;g++){let p=d[g],u=a[p.materialIndex],S=Math.max(p.start,m.start),A=Math.min(o.count,Math.min(p.start+p.count,m.start+m.count));for(let T=S,C=A;T<C;T+=3){let E=o.getX(T),x=o.getX(T+1),b=o.getX(T+2);s=ar(this,u,e,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),M=Math.min(o.count,m.start+m.count);for(let p=g,u=M;p<u;p+=3){let S=o.getX(p),A=o.getX(p+1),T=o.getX(p+2);s=ar(this,a,e,n,l,h,f,S,A,T),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(a))for(let g=0,M=d.length;g<M;g++){let p=d[g],u=a[p.materialIndex],S=Math.max(p.start,m.start),A=Math.min(c.count,Math.min(p.start+p.count,m.start+m.count));for(let T=S,C=A;T<C;T+=3){let E=T,x=T+1,b=T+2;s=ar(this,u,e,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),M=Math.min(c.count,m.start+m.count);for(let p=g,u=M;p<u;p+=3){let S=p,A=p+1,T=p+2;s=ar(this,a,e,n,l,h,f,S,A,T),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function qu(i,e,t,n,s,r,a,o){let c;if(e.side===Nt?c=n.intersectTriangle(a,r,s,!0,o):c=n.intersectTriangle(s,r,a,e.side===Qn,o),c===null)return null;rr.copy(o),rr.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(rr);return l<t.near||l>t.far?null:{distance:l,point:rr.clone(),object:i}}function ar(i,e,t,n,s,r,a,o,c,l){i.getVertexPosition(o,tr),i.getVertexPosition(c,nr),i.getVertexPosition(l,ir);let h=qu(i,e,t,n,tr,nr,ir,mc);if(h){let f=new U;Cn.getBarycoord(mc,tr,nr,ir,f),s&&(h.uv=Cn.getInterpolatedAttribute(s,o,c,l,f,new He)),r&&(h.uv1=Cn.getInterpolatedAttribute(r,o,c,l,f,new He)),a&&(h.normal=Cn.getInterpolatedAttribute(a,o,c,l,f,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:c,c:l,normal:new U,materialIndex:0};Cn.getNormal(tr,nr,ir,d.normal),h.face=d,h.barycoord=f}return h}var Dr=class extends Ot{constructor(e=null,t=1,n=1,s,r,a,o,c,l=St,h=St,f,d){super(null,a,o,c,l,h,s,r,f,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var li=new ci,Zu=new He(.5,.5),or=new U,Zn=class{constructor(e=new rn,t=new rn,n=new rn,s=new rn,r=new rn,a=new rn){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=jt,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],c=r[2],l=r[3],h=r[4],f=r[5],d=r[6],m=r[7],g=r[8],M=r[9],p=r[10],u=r[11],S=r[12],A=r[13],T=r[14],C=r[15];if(s[0].setComponents(l-a,m-h,u-g,C-S).normalize(),s[1].setComponents(l+a,m+h,u+g,C+S).normalize(),s[2].setComponents(l+o,m+f,u+M,C+A).normalize(),s[3].setComponents(l-o,m-f,u-M,C-A).normalize(),n)s[4].setComponents(c,d,p,T).normalize(),s[5].setComponents(l-c,m-d,u-p,C-T).normalize();else if(s[4].setComponents(l-c,m-d,u-p,C-T).normalize(),t===jt)s[5].setComponents(l+c,m+d,u+p,C+T).normalize();else if(t===Li)s[5].setComponents(c,d,p,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),li.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),li.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(li)}intersectsSprite(e){li.center.set(0,0,0);let t=Zu.distanceTo(e.center);return li.radius=.7071067811865476+t,li.applyMatrix4(e.matrixWorld),this.intersectsSphere(li)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(or.x=s.normal.x>0?e.max.x:e.min.x,or.y=s.normal.y>0?e.max.y:e.min.y,or.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(or)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gc=new Qe,Nr=class i{constructor(){this.coordinateSystem=jt,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];gc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Zn),n[s].setFromProjectionMatrix(gc,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Zn),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Yn=class extends In{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ue(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ur=new U,Fr=new U,xc=new Qe,es=new us,lr=new ci,_o=new U,vc=new U,Fi=class extends wt{constructor(e=new _t,t=new Yn){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Ur.fromBufferAttribute(t,s-1),Fr.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Ur.distanceTo(Fr);e.setAttribute("lineDistance",new et(n,1))}else Ce("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),lr.copy(n.boundingSphere),lr.applyMatrix4(s),lr.radius+=r,e.ray.intersectsSphere(lr)===!1)return;xc.copy(s).invert(),es.copy(e.ray).applyMatrix4(xc);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let M=m,p=g-1;M<p;M+=l){let u=h.getX(M),S=h.getX(M+1),A=cr(this,e,es,c,u,S,M);A&&t.push(A)}if(this.isLineLoop){let M=h.getX(g-1),p=h.getX(m),u=cr(this,e,es,c,M,p,g-1);u&&t.push(u)}}else{let m=Math.max(0,a.start),g=Math.min(d.count,a.start+a.count);for(let M=m,p=g-1;M<p;M+=l){let u=cr(this,e,es,c,M,M+1,M);u&&t.push(u)}if(this.isLineLoop){let M=cr(this,e,es,c,g-1,m,g-1);M&&t.push(M)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function cr(i,e,t,n,s,r,a){let o=i.geometry.attributes.position;if(Ur.fromBufferAttribute(o,s),Fr.fromBufferAttribute(o,r),t.distanceSqToSegment(Ur,Fr,_o,vc)>n)return;_o.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(_o);if(!(l<e.near||l>e.far))return{distance:l,point:vc.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var yc=new U,Mc=new U,Oi=class extends Fi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)yc.fromBufferAttribute(t,s),Mc.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+yc.distanceTo(Mc);e.setAttribute("lineDistance",new et(n,1))}else Ce("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ds=class extends Ot{constructor(e=[],t=fi,n,s,r,a,o,c,l,h){super(e,t,n,s,r,a,o,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ln=class extends Ot{constructor(e,t,n=an,s,r,a,o=St,c=St,l,h=_n,f=1){if(h!==_n&&h!==Un)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:f};super(d,s,r,a,o,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ni(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},fs=class extends Ln{constructor(e,t=an,n=fi,s,r,a=St,o=St,c,l=_n){let h={width:e,height:e,depth:1},f=[h,h,h,h,h,h];super(e,e,t,n,s,r,a,o,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ps=class extends Ot{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Dn=class i extends _t{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let c=[],l=[],h=[],f=[],d=0,m=0;g("z","y","x",-1,-1,n,t,e,a,r,0),g("z","y","x",1,-1,n,t,-e,a,r,1),g("x","z","y",1,1,e,n,t,s,a,2),g("x","z","y",1,-1,e,n,-t,s,a,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new et(l,3)),this.setAttribute("normal",new et(h,3)),this.setAttribute("uv",new et(f,2));function g(M,p,u,S,A,T,C,E,x,b,N){let I=T/x,D=C/b,B=T/2,H=C/2,_=E/2,V=x+1,q=b+1,G=0,te=0,X=new U;for(let Q=0;Q<q;Q++){let $=Q*D-H;for(let Se=0;Se<V;Se++){let Le=Se*I-B;X[M]=Le*S,X[p]=$*A,X[u]=_,l.push(X.x,X.y,X.z),X[M]=0,X[p]=0,X[u]=E>0?1:-1,h.push(X.x,X.y,X.z),f.push(Se/x),f.push(1-Q/b),G+=1}}for(let Q=0;Q<b;Q++)for(let $=0;$<x;$++){let Se=d+$+V*Q,Le=d+$+V*(Q+1),J=d+($+1)+V*(Q+1),pe=d+($+1)+V*Q;c.push(Se,Le,pe),c.push(Le,J,pe),te+=6}o.addGroup(m,te,N),m+=te,d+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Bi=class i extends _t{constructor(e=1,t=1,n=1,s=32,r=1,a=!1,o=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],d=[],m=[],g=0,M=[],p=n/2,u=0;S(),a===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new et(f,3)),this.setAttribute("normal",new et(d,3)),this.setAttribute("uv",new et(m,2));function S(){let T=new U,C=new U,E=0,x=(t-e)/n;for(let b=0;b<=r;b++){let N=[],I=b/r,D=I*(t-e)+e;for(let B=0;B<=s;B++){let H=B/s,_=H*c+o,V=Math.sin(_),q=Math.cos(_);C.x=D*V,C.y=-I*n+p,C.z=D*q,f.push(C.x,C.y,C.z),T.set(V,x,q).normalize(),d.push(T.x,T.y,T.z),m.push(H,1-I),N.push(g++)}M.push(N)}for(let b=0;b<s;b++)for(let N=0;N<r;N++){let I=M[N][b],D=M[N+1][b],B=M[N+1][b+1],H=M[N][b+1];(e>0||N!==0)&&(h.push(I,D,H),E+=3),(t>0||N!==r-1)&&(h.push(D,B,H),E+=3)}l.addGroup(u,E,0),u+=E}function A(T){let C=g,E=new He,x=new U,b=0,N=T===!0?e:t,I=T===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,p*I,0),d.push(0,I,0),m.push(.5,.5),g++;let D=g;for(let B=0;B<=s;B++){let _=B/s*c+o,V=Math.cos(_),q=Math.sin(_);x.x=N*q,x.y=p*I,x.z=N*V,f.push(x.x,x.y,x.z),d.push(0,I,0),E.x=V*.5+.5,E.y=q*.5*I+.5,m.push(E.x,E.y),g++}for(let B=0;B<s;B++){let H=C+B,_=D+B;T===!0?h.push(_,_+1,H):h.push(_+1,_,H),b+=3}l.addGroup(u,b,T===!0?1:2),u+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ms=class i extends Bi{constructor(e=1,t=1,n=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,e,t,n,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var hr=new U,ur=new U,Po=new U,dr=new Cn,gs=class extends _t{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(vr*t),a=e.getIndex(),o=e.getAttribute("position"),c=a?a.count:o.count,l=[0,0,0],h=["a","b","c"],f=new Array(3),d=new Map,m=[];for(let g=0;g<c;g+=3){a?(l[0]=a.getX(g),l[1]=a.getX(g+1),l[2]=a.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:M,b:p,c:u}=dr;if(M.fromBufferAttribute(o,l[0]),p.fromBufferAttribute(o,l[1]),u.fromBufferAttribute(o,l[2]),dr.getNormal(Po),f[0]=`${Math.round(M.x*s)},${Math.round(M.y*s)},${Math.round(M.z*s)}`,f[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,f[2]=`${Math.round(u.x*s)},${Math.round(u.y*s)},${Math.round(u.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let S=0;S<3;S++){let A=(S+1)%3,T=f[S],C=f[A],E=dr[h[S]],x=dr[h[A]],b=`${T}_${C}`,N=`${C}_${T}`,I=d.get(N);I?(Po.dot(I.normal)<=r&&(m.push(E.x,E.y,E.z),m.push(x.x,x.y,x.z)),d.set(N,null)):d.has(b)||d.set(b,{index0:l[S],index1:l[A],normal:Po.clone()})}}for(let g of d.values())if(g){let{index0:M,index1:p}=g;hr.fromBufferAttribute(o,M),ur.fromBufferAttribute(o,p),m.push(hr.x,hr.y,hr.z),m.push(ur.x,ur.y,ur.z)}this.setAttribute("position",new et(m,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var hi=class i extends _t{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),c=Math.floor(s),l=o+1,h=c+1,f=e/o,d=t/c,m=[],g=[],M=[],p=[];for(let u=0;u<h;u++){let S=u*d-a;for(let A=0;A<l;A++){let T=A*f-r;g.push(T,-S,0),M.push(0,0,1),p.push(A/o),p.push(1-u/c)}}for(let u=0;u<c;u++)for(let S=0;S<o;S++){let A=S+l*u,T=S+l*(u+1),C=S+1+l*(u+1),E=S+1+l*u;m.push(A,T,E),m.push(T,C,E)}this.setIndex(m),this.setAttribute("position",new et(g,3)),this.setAttribute("normal",new et(M,3)),this.setAttribute("uv",new et(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var zi=class i extends _t{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let c=Math.min(a+o,Math.PI),l=0,h=[],f=new U,d=new U,m=[],g=[],M=[],p=[];for(let u=0;u<=n;u++){let S=[],A=u/n,T=a+A*o,C=e*Math.cos(T),E=Math.sqrt(e*e-C*C),x=0;u===0&&a===0?x=.5/t:u===n&&c===Math.PI&&(x=-.5/t);for(let b=0;b<=t;b++){let N=b/t,I=s+N*r;f.x=-E*Math.cos(I),f.y=C,f.z=E*Math.sin(I),g.push(f.x,f.y,f.z),d.copy(f).normalize(),M.push(d.x,d.y,d.z),p.push(N+x,1-A),S.push(l++)}h.push(S)}for(let u=0;u<n;u++)for(let S=0;S<t;S++){let A=h[u][S+1],T=h[u][S],C=h[u+1][S],E=h[u+1][S+1];(u!==0||a>0)&&m.push(A,T,E),(u!==n-1||c<Math.PI)&&m.push(T,C,E)}this.setIndex(m),this.setAttribute("position",new et(g,3)),this.setAttribute("normal",new et(M,3)),this.setAttribute("uv",new et(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var xs=class i extends _t{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],h=[],f=[],d=new U,m=new U,g=new U;for(let M=0;M<=n;M++){let p=a+M/n*o;for(let u=0;u<=s;u++){let S=u/s*r;m.x=(e+t*Math.cos(p))*Math.cos(S),m.y=(e+t*Math.cos(p))*Math.sin(S),m.z=t*Math.sin(p),l.push(m.x,m.y,m.z),d.x=e*Math.cos(S),d.y=e*Math.sin(S),g.subVectors(m,d).normalize(),h.push(g.x,g.y,g.z),f.push(u/s),f.push(M/n)}}for(let M=1;M<=n;M++)for(let p=1;p<=s;p++){let u=(s+1)*M+p-1,S=(s+1)*(M-1)+p-1,A=(s+1)*(M-1)+p,T=(s+1)*M+p;c.push(u,S,T),c.push(S,A,T)}this.setIndex(c),this.setAttribute("position",new et(l,3)),this.setAttribute("normal",new et(h,3)),this.setAttribute("uv",new et(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function mi(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Sc(s))s.isRenderTargetTexture?(Ce("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Sc(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Pt(i){let e={};for(let t=0;t<i.length;t++){let n=mi(i[t]);for(let s in n)e[s]=n[s]}return e}function Sc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Yu(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function dl(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ve.workingColorSpace}var fh={clone:mi,merge:Pt},Ju=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ku=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,gn=class extends In{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ju,this.fragmentShader=Ku,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=mi(e.uniforms),this.uniformsGroups=Yu(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Ue().setHex(s.value);break;case"v2":this.uniforms[n].value=new He().fromArray(s.value);break;case"v3":this.uniforms[n].value=new U().fromArray(s.value);break;case"v4":this.uniforms[n].value=new st().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Pe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qe().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Or=class extends gn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vs=class extends In{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new He(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Qr,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Br=class extends In{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qc,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},zr=class extends In{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ci(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function fr(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Jn=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kr=class extends Jn{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Do,endingEnd:Do}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],c=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case No:r=e,o=2*t-n;break;case Uo:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(c===void 0)switch(this.getSettings_().endingEnd){case No:a=e,c=2*n-t;break;case Uo:a=1,c=n+s[1]-s[0];break;default:a=e-1,c=t}let l=(n-t)*.5,h=this.valueSize;this._weightPrev=l/(t-o),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=e*o,l=c-o,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-t)/(s-t),M=g*g,p=M*g,u=-d*p+2*d*M-d*g,S=(1+d)*p+(-1.5-2*d)*M+(-.5+d)*g+1,A=(-1-m)*p+(1.5+m)*M+.5*g,T=m*p-m*M;for(let C=0;C!==o;++C)r[C]=u*a[h+C]+S*a[l+C]+A*a[c+C]+T*a[f+C];return r}},Gr=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=e*o,l=c-o,h=(n-t)/(s-t),f=1-h;for(let d=0;d!==o;++d)r[d]=a[l+d]*f+a[c+d]*h;return r}},Vr=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Hr=class extends Jn{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=e*o,l=c-o,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-t)/(s-t),M=1-g;for(let p=0;p!==o;++p)r[p]=a[l+p]*M+a[c+p]*g;return r}let d=o*2,m=e-1;for(let g=0;g!==o;++g){let M=a[l+g],p=a[c+g],u=m*d+g*2,S=f[u],A=f[u+1],T=e*d+g*2,C=h[T],E=h[T+1],x=Qu(n,t,S,C,s);r[g]=ph(x,M,A,E,p)}return r}};function ph(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function ju(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function Qu(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=ph(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let c=ju(r,e,t,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-o/c))}return r}var Wt=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ci(t,this.TimeBufferType),this.values=Ci(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ci(e.times,Array),values:Ci(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),fr(e.settings)&&(n.settings={inTangents:Ci(e.settings.inTangents,Array),outTangents:Ci(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Vr(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Gr(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new kr(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Hr(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ns:t=this.InterpolantFactoryMethodDiscrete;break;case Rr:t=this.InterpolantFactoryMethodLinear;break;case gr:t=this.InterpolantFactoryMethodSmooth;break;case Lo:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ce("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ns;case this.InterpolantFactoryMethodLinear:return Rr;case this.InterpolantFactoryMethodSmooth:return gr;case this.InterpolantFactoryMethodBezier:return Lo}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;fr(this.settings)&&(bc(this.settings.inTangents,e),bc(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;fr(this.settings)&&(Tc(this.settings.inTangents,e),Tc(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(_e("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(_e("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let c=n[o];if(typeof c=="number"&&isNaN(c)){_e("KeyframeTrack: Time is not a valid number.",this,o,c),e=!1;break}if(a!==null&&a>c){_e("KeyframeTrack: Out of order keys.",this,o,c,a),e=!1;break}a=c}if(s!==void 0&&Au(s))for(let o=0,c=s.length;o!==c;++o){let l=s[o];if(isNaN(l)){_e("KeyframeTrack: Value is not a valid number.",this,o,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===gr,r=e.length-1,a=1;for(let o=1;o<r;++o){let c=!1,l=e[o],h=e[o+1];if(l!==h&&(o!==1||l!==e[0]))if(s)c=!0;else{let f=o*n,d=f-n,m=f+n;for(let g=0;g!==n;++g){let M=t[f+g];if(M!==t[d+g]||M!==t[m+g]){c=!0;break}}}if(c){if(o!==a){e[a]=e[o];let f=o*n,d=a*n;for(let m=0;m!==n;++m)t[d+m]=t[f+m]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,c=a*n,l=0;l!==n;++l)t[c+l]=t[o+l];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,fr(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bc(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Tc(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Wt.prototype.ValueTypeName="";Wt.prototype.TimeBufferType=Float32Array;Wt.prototype.ValueBufferType=Float32Array;Wt.prototype.DefaultInterpolation=Rr;var Kn=class extends Wt{constructor(e,t,n){super(e,t,n)}};Kn.prototype.ValueTypeName="bool";Kn.prototype.ValueBufferType=Array;Kn.prototype.DefaultInterpolation=ns;Kn.prototype.InterpolantFactoryMethodLinear=void 0;Kn.prototype.InterpolantFactoryMethodSmooth=void 0;var Wr=class extends Wt{constructor(e,t,n,s){super(e,t,n,s)}};Wr.prototype.ValueTypeName="color";var Xr=class extends Wt{constructor(e,t,n,s){super(e,t,n,s)}};Xr.prototype.ValueTypeName="number";var qr=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=(n-t)/(s-t),l=e*o;for(let h=l+o;l!==h;l+=4)Qt.slerpFlat(r,0,a,l-o,a,l,c);return r}},ys=class extends Wt{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new qr(this.times,this.values,this.getValueSize(),e)}};ys.prototype.ValueTypeName="quaternion";ys.prototype.InterpolantFactoryMethodSmooth=void 0;var jn=class extends Wt{constructor(e,t,n){super(e,t,n)}};jn.prototype.ValueTypeName="string";jn.prototype.ValueBufferType=Array;jn.prototype.DefaultInterpolation=ns;jn.prototype.InterpolantFactoryMethodLinear=void 0;jn.prototype.InterpolantFactoryMethodSmooth=void 0;var Zr=class extends Wt{constructor(e,t,n,s){super(e,t,n,s)}};Zr.prototype.ValueTypeName="vector";var Yr=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,f){return l.push(h,f),this},this.removeHandler=function(h){let f=l.indexOf(h);return f!==-1&&l.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=l.length;f<d;f+=2){let m=l[f],g=l[f+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mh=new Yr,Jr=class{constructor(e){this.manager=e!==void 0?e:mh,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Jr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ms=class extends wt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ue(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ss=class extends Ms{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(wt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ue(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Io=new Qe,wc=new U,Ec=new U,Kr=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new He(512,512),this.mapType=Bt,this.map=null,this.mapPass=null,this.matrix=new Qe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zn,this._frameExtents=new He(1,1),this._viewportCount=1,this._viewports=[new st(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;wc.setFromMatrixPosition(e.matrixWorld),t.position.copy(wc),Ec.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Ec),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Io.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Io,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;e.coordinateSystem===Li||e.reversedDepth?t.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,.5,.5,0,0,0,1),t.multiply(Io)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},pr=new U,mr=new Qt,dn=new U,bs=class extends wt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qe,this.projectionMatrix=new Qe,this.projectionMatrixInverse=new Qe,this.coordinateSystem=jt,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xn=new U,Ac=new He,Cc=new He,Lt=class extends bs{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=_r*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(vr*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return _r*2*Math.atan(Math.tan(vr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Xn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Xn.x,Xn.y).multiplyScalar(-e/Xn.z),Xn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Xn.x,Xn.y).multiplyScalar(-e/Xn.z)}getViewSize(e,t){return this.getViewBounds(e,Ac,Cc),t.subVectors(Cc,Ac)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(vr*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let c=a.fullWidth,l=a.fullHeight;r+=a.offsetX*s/c,t-=a.offsetY*n/l,s*=a.width/c,n*=a.height/l}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ts=class extends bs{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,a=r+l*this.view.width,o-=h*this.view.offsetY,c=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Fo=class extends Kr{constructor(){super(new Ts(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ws=class extends Ms{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(wt.DEFAULT_UP),this.updateMatrix(),this.target=new wt,this.shadow=new Fo}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Ri=-90,_i=1,ki=class extends wt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Lt(Ri,_i,e,t);s.layers=this.layers,this.add(s);let r=new Lt(Ri,_i,e,t);r.layers=this.layers,this.add(r);let a=new Lt(Ri,_i,e,t);a.layers=this.layers,this.add(a);let o=new Lt(Ri,_i,e,t);o.layers=this.layers,this.add(o);let c=new Lt(Ri,_i,e,t);c.layers=this.layers,this.add(c);let l=new Lt(Ri,_i,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,c]=t;for(let l of t)this.remove(l);if(e===jt)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Li)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,c,l,h]=this.children,f=e.getRenderTarget(),d=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let M=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),n.texture.mipmapsAutoUpdate=M,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(f,d,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},jr=class extends Lt{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var fl="\\[\\]\\.:\\/",$u=new RegExp("["+fl+"]","g"),pl="[^"+fl+"]",ed="[^"+fl.replace("\\.","")+"]",td=/((?:WC+[\/:])*)/.source.replace("WC",pl),nd=/(WCOD+)?/.source.replace("WCOD",ed),id=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pl),sd=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pl),rd=new RegExp("^"+td+nd+id+sd+"$"),ad=["material","materials","bones","map"],Oo=class{constructor(e,t,n){let s=n||tt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},tt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace($u,"")}static parseTrackName(e){let t=rd.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ad.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let c=n(o.children);if(c)return c}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ce("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"materials":if(!e.material){_e("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){_e("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){_e("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===l){l=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){_e("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){_e("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){_e("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){_e("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let a=e[s];if(a===void 0){let l=t.nodeName;_e("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){_e("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){_e("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(c=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};tt.Composite=Oo;tt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};tt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};tt.prototype.GetterByBindingType=[tt.prototype._getValue_direct,tt.prototype._getValue_array,tt.prototype._getValue_arrayElement,tt.prototype._getValue_toArray];tt.prototype.SetterByBindingTypeAndVersioning=[[tt.prototype._setValue_direct,tt.prototype._setValue_direct_setNeedsUpdate,tt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[tt.prototype._setValue_array,tt.prototype._setValue_array_setNeedsUpdate,tt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[tt.prototype._setValue_arrayElement,tt.prototype._setValue_arrayElement_setNeedsUpdate,tt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[tt.prototype._setValue_fromArray,tt.prototype._setValue_fromArray_setNeedsUpdate,tt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p0=new Float32Array(1);var Bo=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var Es=class extends Oi{constructor(e=10,t=10,n=4473924,s=8947848){n=new Ue(n),s=new Ue(s);let r=t/2,a=e/t,o=e/2,c=[],l=[];for(let d=0,m=0,g=-o;d<=t;d++,g+=a){c.push(-o,0,g,o,0,g),c.push(g,0,-o,g,0,o);let M=d===r?n:s;M.toArray(l,m),m+=3,M.toArray(l,m),m+=3,M.toArray(l,m),m+=3,M.toArray(l,m),m+=3}let h=new _t;h.setAttribute("position",new et(c,3)),h.setAttribute("color",new et(l,3));let f=new Yn({vertexColors:!0,toneMapped:!1});super(h,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};function ml(i,e,t,n){let s=od(n);switch(t){case il:return i*e;case rl:return i*e/s.components*s.byteLength;case ra:return i*e/s.components*s.byteLength;case $n:return i*e*2/s.components*s.byteLength;case aa:return i*e*2/s.components*s.byteLength;case sl:return i*e*3/s.components*s.byteLength;case cn:return i*e*4/s.components*s.byteLength;case oa:return i*e*4/s.components*s.byteLength;case Rs:case _s:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ps:case Is:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ca:case ua:return Math.max(i,16)*Math.max(e,8)/4;case la:case ha:return Math.max(i,8)*Math.max(e,8)/2;case da:case fa:case ma:case ga:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case pa:case Ls:case xa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case va:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ya:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Ma:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Sa:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ba:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Ta:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case wa:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Ea:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Aa:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Ca:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Ra:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case _a:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Pa:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Ia:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case La:case Da:case Na:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Ua:case Fa:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ds:case Oa:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function od(i){switch(i){case Bt:case $o:return{byteLength:1,components:1};case Wi:case el:case ln:return{byteLength:2,components:1};case ia:case sa:return{byteLength:2,components:4};case an:case na:case on:return{byteLength:4,components:1};case tl:case nl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ce("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Oh(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function cd(i){let e=new WeakMap;function t(o,c){let l=o.array,h=o.usage,f=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),o.onUploadCallback();let m;if(l instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=i.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=i.SHORT;else if(l instanceof Uint32Array)m=i.UNSIGNED_INT;else if(l instanceof Int32Array)m=i.INT;else if(l instanceof Int8Array)m=i.BYTE;else if(l instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,c,l){let h=c.array,f=c.updateRanges;if(i.bindBuffer(l,o),f.length===0)i.bufferSubData(l,0,h);else{f.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<f.length;m++){let g=f[d],M=f[m];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++d,f[d]=M)}f.length=d+1;for(let m=0,g=f.length;m<g;m++){let M=f[m];i.bufferSubData(l,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let c=e.get(o);c&&(i.deleteBuffer(c.buffer),e.delete(o))}function a(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let l=e.get(o);if(l===void 0)e.set(o,t(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,o,c),l.version=o.version}}return{get:s,remove:r,update:a}}var hd=`#ifdef USE_ALPHAHASH
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
#endif`,wd=`#ifdef USE_BUMPMAP
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
#endif`,Cd=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Rd=`#if NUM_CLIPPING_PLANES > 0
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ef=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,tf=`#ifdef USE_ENVMAP
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
#endif`,Tf=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,wf=`#if defined( USE_MORPHCOLORS )
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
#endif`,Cf=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Rf=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
#endif`,ep=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,tp=`#ifdef USE_SPECULARMAP
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
}`,wp=`#include <common>
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
}`,Cp=`#define LAMBERT
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
}`,Rp=`#define MATCAP
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
}`,Be={alphahash_fragment:hd,alphahash_pars_fragment:ud,alphamap_fragment:dd,alphamap_pars_fragment:fd,alphatest_fragment:pd,alphatest_pars_fragment:md,aomap_fragment:gd,aomap_pars_fragment:xd,batching_pars_vertex:vd,batching_vertex:yd,begin_vertex:Md,beginnormal_vertex:Sd,bsdfs:bd,iridescence_fragment:Td,bumpmap_pars_fragment:wd,clipping_planes_fragment:Ed,clipping_planes_pars_fragment:Ad,clipping_planes_pars_vertex:Cd,clipping_planes_vertex:Rd,color_fragment:_d,color_pars_fragment:Pd,color_pars_vertex:Id,color_vertex:Ld,common:Dd,defaultnormal_vertex:Nd,displacementmap_pars_vertex:Ud,displacementmap_vertex:Fd,emissivemap_fragment:Od,emissivemap_pars_fragment:Bd,colorspace_fragment:zd,colorspace_pars_fragment:kd,envmap_fragment:Gd,envmap_common_pars_fragment:Vd,envmap_pars_fragment:Hd,envmap_pars_vertex:Wd,envmap_physical_pars_fragment:tf,envmap_vertex:Xd,fog_vertex:qd,fog_pars_vertex:Zd,fog_fragment:Yd,fog_pars_fragment:Jd,gradientmap_pars_fragment:Kd,lightmap_pars_fragment:jd,lights_lambert_fragment:Qd,lights_lambert_pars_fragment:$d,lights_pars_begin:ef,lights_toon_fragment:nf,lights_toon_pars_fragment:sf,lights_phong_fragment:rf,lights_phong_pars_fragment:af,lights_physical_fragment:of,lights_physical_pars_fragment:lf,lights_fragment_begin:cf,lights_fragment_maps:hf,lights_fragment_end:uf,lightprobes_pars_fragment:df,logdepthbuf_fragment:ff,logdepthbuf_pars_fragment:pf,logdepthbuf_pars_vertex:mf,logdepthbuf_vertex:gf,map_fragment:xf,map_pars_fragment:vf,map_particle_fragment:yf,map_particle_pars_fragment:Mf,metalnessmap_fragment:Sf,metalnessmap_pars_fragment:bf,morphinstance_vertex:Tf,morphcolor_vertex:wf,morphnormal_vertex:Ef,morphtarget_pars_vertex:Af,morphtarget_vertex:Cf,normal_fragment_begin:Rf,normal_fragment_maps:_f,normal_pars_fragment:Pf,normal_pars_vertex:If,normal_vertex:Lf,normalmap_pars_fragment:Df,clearcoat_normal_fragment_begin:Nf,clearcoat_normal_fragment_maps:Uf,clearcoat_pars_fragment:Ff,iridescence_pars_fragment:Of,opaque_fragment:Bf,packing:zf,premultiplied_alpha_fragment:kf,project_vertex:Gf,dithering_fragment:Vf,dithering_pars_fragment:Hf,roughnessmap_fragment:Wf,roughnessmap_pars_fragment:Xf,shadowmap_pars_fragment:qf,shadowmap_pars_vertex:Zf,shadowmap_vertex:Yf,shadowmask_pars_fragment:Jf,skinbase_vertex:Kf,skinning_pars_vertex:jf,skinning_vertex:Qf,skinnormal_vertex:$f,specularmap_fragment:ep,specularmap_pars_fragment:tp,tonemapping_fragment:np,tonemapping_pars_fragment:ip,transmission_fragment:sp,transmission_pars_fragment:rp,uv_pars_fragment:ap,uv_pars_vertex:op,uv_vertex:lp,worldpos_vertex:cp,background_vert:hp,background_frag:up,backgroundCube_vert:dp,backgroundCube_frag:fp,cube_vert:pp,cube_frag:mp,depth_vert:gp,depth_frag:xp,distance_vert:vp,distance_frag:yp,equirect_vert:Mp,equirect_frag:Sp,linedashed_vert:bp,linedashed_frag:Tp,meshbasic_vert:wp,meshbasic_frag:Ep,meshlambert_vert:Ap,meshlambert_frag:Cp,meshmatcap_vert:Rp,meshmatcap_frag:_p,meshnormal_vert:Pp,meshnormal_frag:Ip,meshphong_vert:Lp,meshphong_frag:Dp,meshphysical_vert:Np,meshphysical_frag:Up,meshtoon_vert:Fp,meshtoon_frag:Op,points_vert:Bp,points_frag:zp,shadow_vert:kp,shadow_frag:Gp,sprite_vert:Vp,sprite_frag:Hp},fe={common:{diffuse:{value:new Ue(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Pe},alphaMap:{value:null},alphaMapTransform:{value:new Pe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Pe}},envmap:{envMap:{value:null},envMapRotation:{value:new Pe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Pe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Pe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Pe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Pe},normalScale:{value:new He(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Pe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Pe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Pe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Pe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ue(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ue(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Pe},alphaTest:{value:0},uvTransform:{value:new Pe}},sprite:{diffuse:{value:new Ue(16777215)},opacity:{value:1},center:{value:new He(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Pe},alphaMap:{value:null},alphaMapTransform:{value:new Pe},alphaTest:{value:0}}},Mn={basic:{uniforms:Pt([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.fog]),vertexShader:Be.meshbasic_vert,fragmentShader:Be.meshbasic_frag},lambert:{uniforms:Pt([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,fe.lights,{emissive:{value:new Ue(0)},envMapIntensity:{value:1}}]),vertexShader:Be.meshlambert_vert,fragmentShader:Be.meshlambert_frag},phong:{uniforms:Pt([fe.common,fe.specularmap,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,fe.lights,{emissive:{value:new Ue(0)},specular:{value:new Ue(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Be.meshphong_vert,fragmentShader:Be.meshphong_frag},standard:{uniforms:Pt([fe.common,fe.envmap,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.roughnessmap,fe.metalnessmap,fe.fog,fe.lights,{emissive:{value:new Ue(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag},toon:{uniforms:Pt([fe.common,fe.aomap,fe.lightmap,fe.emissivemap,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.gradientmap,fe.fog,fe.lights,{emissive:{value:new Ue(0)}}]),vertexShader:Be.meshtoon_vert,fragmentShader:Be.meshtoon_frag},matcap:{uniforms:Pt([fe.common,fe.bumpmap,fe.normalmap,fe.displacementmap,fe.fog,{matcap:{value:null}}]),vertexShader:Be.meshmatcap_vert,fragmentShader:Be.meshmatcap_frag},points:{uniforms:Pt([fe.points,fe.fog]),vertexShader:Be.points_vert,fragmentShader:Be.points_frag},dashed:{uniforms:Pt([fe.common,fe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Be.linedashed_vert,fragmentShader:Be.linedashed_frag},depth:{uniforms:Pt([fe.common,fe.displacementmap]),vertexShader:Be.depth_vert,fragmentShader:Be.depth_frag},normal:{uniforms:Pt([fe.common,fe.bumpmap,fe.normalmap,fe.displacementmap,{opacity:{value:1}}]),vertexShader:Be.meshnormal_vert,fragmentShader:Be.meshnormal_frag},sprite:{uniforms:Pt([fe.sprite,fe.fog]),vertexShader:Be.sprite_vert,fragmentShader:Be.sprite_frag},background:{uniforms:{uvTransform:{value:new Pe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Be.background_vert,fragmentShader:Be.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Pe}},vertexShader:Be.backgroundCube_vert,fragmentShader:Be.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Be.cube_vert,fragmentShader:Be.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Be.equirect_vert,fragmentShader:Be.equirect_frag},distance:{uniforms:Pt([fe.common,fe.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Be.distance_vert,fragmentShader:Be.distance_frag},shadow:{uniforms:Pt([fe.lights,fe.fog,{color:{value:new Ue(0)},opacity:{value:1}}]),vertexShader:Be.shadow_vert,fragmentShader:Be.shadow_frag}};Mn.physical={uniforms:Pt([Mn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Pe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Pe},clearcoatNormalScale:{value:new He(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Pe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Pe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Pe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Pe},sheen:{value:0},sheenColor:{value:new Ue(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Pe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Pe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Pe},transmissionSamplerSize:{value:new He},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Pe},attenuationDistance:{value:0},attenuationColor:{value:new Ue(0)},specularColor:{value:new Ue(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Pe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Pe},anisotropyVector:{value:new He},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Pe}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag};var za={r:0,b:0,g:0},Wp=new Qe,Bh=new Pe;Bh.set(-1,0,0,0,1,0,0,0,1);function Xp(i,e,t,n,s,r){let a=new Ue(0),o=s===!0?0:1,c,l,h=null,f=0,d=null;function m(S){let A=S.isScene===!0?S.background:null;if(A&&A.isTexture){let T=S.backgroundBlurriness>0;A=e.get(A,T)}return A}function g(S){let A=!1,T=m(S);T===null?p(a,o):T&&T.isColor&&(p(T,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function M(S,A){let T=m(A);T&&T.isCubeTexture?(l===void 0&&(l=new pt(new Dn(1,1,1),new gn({name:"BackgroundCubeMaterial",uniforms:mi(Mn.backgroundCube.uniforms),vertexShader:Mn.backgroundCube.vertexShader,fragmentShader:Mn.backgroundCube.fragmentShader,side:Nt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=T,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Wp.makeRotationFromEuler(A.backgroundRotation)).transpose(),T.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Bh),l.material.toneMapped=Ve.getTransfer(T.colorSpace)!==Ze,(h!==T||f!==T.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=T,f=T.version,d=i.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null)):T&&T.isTexture&&(c===void 0&&(c=new pt(new hi(2,2),new gn({name:"BackgroundMaterial",uniforms:mi(Mn.background.uniforms),vertexShader:Mn.background.vertexShader,fragmentShader:Mn.background.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=T,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Ve.getTransfer(T.colorSpace)!==Ze,T.matrixAutoUpdate===!0&&T.updateMatrix(),c.material.uniforms.uvTransform.value.copy(T.matrix),(h!==T||f!==T.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=T,f=T.version,d=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function p(S,A){S.getRGB(za,dl(i)),t.buffers.color.setClear(za.r,za.g,za.b,A,r)}function u(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,A=1){a.set(S),o=A,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(S){o=S,p(a,o)},render:g,addToRenderList:M,dispose:u}}function qp(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,a=!1;function o(D,B,H,_,V){let q=!1,G=f(D,_,H,B);r!==G&&(r=G,l(r.object)),q=m(D,_,H,V),q&&g(D,_,H,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(q||a)&&(a=!1,T(D,B,H,_),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function c(){return i.createVertexArray()}function l(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function f(D,B,H,_){let V=_.wireframe===!0,q=n[B.id];q===void 0&&(q={},n[B.id]=q);let G=D.isInstancedMesh===!0?D.id:0,te=q[G];te===void 0&&(te={},q[G]=te);let X=te[H.id];X===void 0&&(X={},te[H.id]=X);let Q=X[V];return Q===void 0&&(Q=d(c()),X[V]=Q),Q}function d(D){let B=[],H=[],_=[];for(let V=0;V<t;V++)B[V]=0,H[V]=0,_[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:H,attributeDivisors:_,object:D,attributes:{},index:null}}function m(D,B,H,_){let V=r.attributes,q=B.attributes,G=0,te=H.getAttributes();for(let X in te)if(te[X].location>=0){let $=V[X],Se=q[X];if(Se===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(Se=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(Se=D.instanceColor)),$===void 0||$.attribute!==Se||Se&&$.data!==Se.data)return!0;G++}return r.attributesNum!==G||r.index!==_}function g(D,B,H,_){let V={},q=B.attributes,G=0,te=H.getAttributes();for(let X in te)if(te[X].location>=0){let $=q[X];$===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&($=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&($=D.instanceColor));let Se={};Se.attribute=$,$&&$.data&&(Se.data=$.data),V[X]=Se,G++}r.attributes=V,r.attributesNum=G,r.index=_}function M(){let D=r.newAttributes;for(let B=0,H=D.length;B<H;B++)D[B]=0}function p(D){u(D,0)}function u(D,B){let H=r.newAttributes,_=r.enabledAttributes,V=r.attributeDivisors;H[D]=1,_[D]===0&&(i.enableVertexAttribArray(D),_[D]=1),V[D]!==B&&(i.vertexAttribDivisor(D,B),V[D]=B)}function S(){let D=r.newAttributes,B=r.enabledAttributes;for(let H=0,_=B.length;H<_;H++)B[H]!==D[H]&&(i.disableVertexAttribArray(H),B[H]=0)}function A(D,B,H,_,V,q,G){G===!0?i.vertexAttribIPointer(D,B,H,V,q):i.vertexAttribPointer(D,B,H,_,V,q)}function T(D,B,H,_){M();let V=_.attributes,q=H.getAttributes(),G=B.defaultAttributeValues;for(let te in q){let X=q[te];if(X.location>=0){let Q=V[te];if(Q===void 0&&(te==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),te==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let $=Q.normalized,Se=Q.itemSize,Le=e.get(Q);if(Le===void 0)continue;let J=Le.buffer,pe=Le.type,ve=Le.bytesPerElement,Ee=pe===i.INT||pe===i.UNSIGNED_INT||Q.gpuType===na;if(Q.isInterleavedBufferAttribute){let me=Q.data,Ne=me.isInterleavedBuffer===!0?me.stride:me.itemSize,lt=Q.offset;if(me.isInstancedInterleavedBuffer||me.isInstancedBufferAttribute){for(let Re=0;Re<X.locationSize;Re++)u(X.location+Re,me.meshPerAttribute);D.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=me.meshPerAttribute*me.count)}else for(let Re=0;Re<X.locationSize;Re++)p(X.location+Re);i.bindBuffer(i.ARRAY_BUFFER,J);for(let Re=0;Re<X.locationSize;Re++)A(X.location+Re,Se/X.locationSize,pe,$,Ne*ve,(lt+Se/X.locationSize*Re)*ve,Ee)}else{if(Q.isInstancedBufferAttribute){for(let me=0;me<X.locationSize;me++)u(X.location+me,Q.meshPerAttribute);D.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let me=0;me<X.locationSize;me++)p(X.location+me);i.bindBuffer(i.ARRAY_BUFFER,J);for(let me=0;me<X.locationSize;me++)A(X.location+me,Se/X.locationSize,pe,$,Se*ve,Se/X.locationSize*me*ve,Ee)}}else if(G!==void 0){let $=G[te];if($!==void 0)switch($.length){case 2:i.vertexAttrib2fv(X.location,$);break;case 3:i.vertexAttrib3fv(X.location,$);break;case 4:i.vertexAttrib4fv(X.location,$);break;default:i.vertexAttrib1fv(X.location,$)}}}}S()}function C(){N();for(let D in n){let B=n[D];for(let H in B){let _=B[H];for(let V in _){let q=_[V];for(let G in q)h(q[G].object),delete q[G];delete _[V]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let B=n[D.id];for(let H in B){let _=B[H];for(let V in _){let q=_[V];for(let G in q)h(q[G].object),delete q[G];delete _[V]}}delete n[D.id]}function x(D){for(let B in n){let H=n[B];for(let _ in H){let V=H[_];if(V[D.id]===void 0)continue;let q=V[D.id];for(let G in q)h(q[G].object),delete q[G];delete V[D.id]}}}function b(D){for(let B in n){let H=n[B],_=D.isInstancedMesh===!0?D.id:0,V=H[_];if(V!==void 0){for(let q in V){let G=V[q];for(let te in G)h(G[te].object),delete G[te];delete V[q]}delete H[_],Object.keys(H).length===0&&delete n[B]}}}function N(){I(),a=!0,r!==s&&(r=s,l(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:N,resetDefaultState:I,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:M,enableAttribute:p,disableUnusedAttributes:S}}function Zp(i,e,t){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),t.update(l,n,1)}function a(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),t.update(l,n,h))}function o(c,l,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let m=0;m<h;m++)d+=l[m];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Yp(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==cn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let b=x===ln&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==Bt&&x!==on&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",h=c(l);h!==l&&(Ce("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ce("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ce("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),u=i.getParameter(i.MAX_VERTEX_ATTRIBS),S=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),T=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:a,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:p,maxAttributes:u,maxVertexUniforms:S,maxVaryings:A,maxFragmentUniforms:T,maxSamples:C,samples:E}}function Jp(i){let e=this,t=null,n=0,s=!1,r=!1,a=new rn,o=new Pe,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let m=f.length!==0||d||n!==0||s;return s=d,n=f.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){t=h(f,d,0)},this.setState=function(f,d,m){let g=f.clippingPlanes,M=f.clipIntersection,p=f.clipShadows,u=i.get(f);if(!s||g===null||g.length===0||r&&!p)r?h(null):l();else{let S=r?0:n,A=S*4,T=u.clippingState||null;c.value=T,T=h(g,d,A,m);for(let C=0;C!==A;++C)T[C]=t[C];u.clippingState=T,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=S}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(f,d,m,g){let M=f!==null?f.length:0,p=null;if(M!==0){if(p=c.value,g!==!0||p===null){let u=m+M*4,S=d.matrixWorldInverse;o.getNormalMatrix(S),(p===null||p.length<u)&&(p=new Float32Array(u));for(let A=0,T=m;A!==M;++A,T+=4)a.copy(f[A]).applyMatrix4(S,o),a.normal.toArray(p,T),p[T+3]=a.constant}c.value=p,c.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,p}}var Os=class extends Ht{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ds(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Dn(5,5,5),r=new gn({name:"CubemapFromEquirect",uniforms:mi(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Nt,blending:ui});r.uniforms.tEquirect.value=t;let a=new pt(s,r),o=t.minFilter;return t.minFilter===Nn&&(t.minFilter=Dt),new ki(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},gh=256,Kp=3,jp=20,zh=256,kh=16,Qp=3,$p=new U,em=new Ue,Ga=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ki(1,10,null),this._boxMesh=new pt(new Dn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=$p}=r,c=this._renderer;this._setSize(a);let l=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,d=c.autoClearColor,m=c.autoClearDepth,g=c.autoClearStencil,M=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,M===null&&(e.background=c.getClearColor(em));let p=new ki(n,s,h);return p.position.copy(o),p.update(c,e),c.autoClear=f,c.autoClearColor=d,c.autoClearDepth=m,c.autoClearStencil=g,e.background=M,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(gh,uh(e))}_fromTexture(e,t){e.mapping===fi||e.mapping===Hi?this._setSize(e.image.length===0?gh:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=xh(e,!1,!1),n=Math.log2(e)-Kp;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=xh(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===fi||e.mapping===Hi?(this._cubemapMaterial===null&&(this._cubemapMaterial=yh()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vh()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=tm(),this._integrationMaterial=nm());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/kh);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-Qp)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let c=o>0?Math.log2(t)+.5*Math.log2(6/(zh*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=c,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=im());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function xh(i,e,t){return new Os(i,{minFilter:Nn,generateMipmaps:e,type:ln,colorSpace:is,depthBuffer:t})}function Bs(i,e,t){return new gn({name:i,uniforms:e,vertexShader:Be.cube_vert,fragmentShader:t,side:Nt,blending:ui,depthTest:!1,depthWrite:!1})}function tm(){return Bs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

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
	`)}function sm(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?a(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===$r||m===ea)if(e.has(d)){let g=e.get(d).texture;return o(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let M=new Os(g.height);return M.fromEquirectangularTexture(i,d),e.set(d,M),d.addEventListener("dispose",l),o(M.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===$r||m===ea,M=m===fi||m===Hi;if(g||M){let p=t.get(d),u=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==u)return n===null&&(n=new Ga(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let S=d.image;return g&&S&&S.height>0||M&&S&&c(S)?(n===null&&(n=new Ga(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function o(d,m){return m===$r?d.mapping=fi:m===ea&&(d.mapping=Hi),d}function c(d){let m=0,g=6;for(let M=0;M<g;M++)d[M]!==void 0&&m++;return m===g}function l(d){let m=d.target;m.removeEventListener("dispose",l);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function rm(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&ts("WebGLRenderer: "+n+" extension not supported."),s}}}function am(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){c(g.target)}function c(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let M=r.get(g);M&&(e.remove(M),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function l(g,M){return s[M.id]!==void 0||(M.addEventListener("dispose",o),s[M.id]=new WeakRef(M),a.register(M,M.id,M),t.memory.geometries++),M}function h(g){let M=g.attributes;for(let p in M)e.update(M[p],i.ARRAY_BUFFER)}function f(g){let M=g.index,p=g.attributes.position,u=0;if(p===void 0)return;let S=M!==null?M.array.length:p.array.length/3-1,A=p.count>=65535?hs:cs,T=new A(Math.ceil(S/3)*6,1),C=T.array;if(M!==null){let x=M.array;u=M.version;for(let b=0,N=0;b<S;b+=3){let I=x[b+0],D=x[b+1],B=x[b+2];C[N++]=I,C[N++]=D,C[N++]=D,C[N++]=B,C[N++]=B,C[N++]=I}}else{u=p.version;for(let x=0,b=0;x<S;x+=3){let N=x+0,I=x+1,D=x+2;C[b++]=N,C[b++]=I,C[b++]=I,C[b++]=D,C[b++]=D,C[b++]=N}}T.version=u;let E=r.get(g);E&&e.remove(E),r.set(g,T)}function d(g){let M=r.get(g);if(M){let p=g.index;p!==null&&M.version<p.version&&f(g)}else f(g);return r.get(g)}function m(){for(let g in s){let M=s[g].deref();M!==void 0&&c(M)}}return{get:l,update:h,getWireframeAttribute:d,dispose:m}}function om(i,e,t){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function c(f,d){i.drawElements(n,d,r,f*a),t.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,f*a,m),t.update(d,n,m))}function h(f,d,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,m);let M=0;for(let p=0;p<m;p++)M+=d[p];t.update(M,n,1)}this.setMode=s,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function lm(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:_e("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function cm(i,e,t){let n=new WeakMap,s=new st;function r(a,o,c){let l=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=h!==void 0?h.length:0,d=n.get(o);if(d===void 0||d.count!==f){let N=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();let m=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,M=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],u=o.morphAttributes.normal||[],S=o.morphAttributes.color||[],A=0;m===!0&&(A=1),g===!0&&(A=2),M===!0&&(A=3);let T=o.attributes.position.count*A,C=1;T>e.maxTextureSize&&(C=Math.ceil(T/e.maxTextureSize),T=e.maxTextureSize);let E=new Float32Array(T*C*4*f),x=new as(E,T,C,f);x.type=on,x.needsUpdate=!0;let b=A*4;for(let I=0;I<f;I++){let D=p[I],B=u[I],H=S[I],_=T*C*4*I;for(let V=0;V<D.count;V++){let q=V*b;m===!0&&(s.fromBufferAttribute(D,V),E[_+q+0]=s.x,E[_+q+1]=s.y,E[_+q+2]=s.z,E[_+q+3]=0),g===!0&&(s.fromBufferAttribute(B,V),E[_+q+4]=s.x,E[_+q+5]=s.y,E[_+q+6]=s.z,E[_+q+7]=0),M===!0&&(s.fromBufferAttribute(H,V),E[_+q+8]=s.x,E[_+q+9]=s.y,E[_+q+10]=s.z,E[_+q+11]=H.itemSize===4?s.w:1)}}d={count:f,texture:x,size:new He(T,C)},n.set(o,d),o.addEventListener("dispose",N)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let m=0;for(let M=0;M<l.length;M++)m+=l[M];let g=o.morphTargetsRelative?1:1-m;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function hm(i,e,t,n,s){let r=new WeakMap;function a(l){let h=s.render.frame,f=l.geometry,d=e.get(l,f);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function o(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var um={[Xo]:"LINEAR_TONE_MAPPING",[qo]:"REINHARD_TONE_MAPPING",[Zo]:"CINEON_TONE_MAPPING",[Yo]:"ACES_FILMIC_TONE_MAPPING",[Ko]:"AGX_TONE_MAPPING",[jo]:"NEUTRAL_TONE_MAPPING",[Jo]:"CUSTOM_TONE_MAPPING"};function dm(i,e,t,n,s,r){let a=new Ht(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,c=null,l=null,h=new _t;h.setAttribute("position",new et([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new et([0,2,0,0,2,0],2));let f=new Or({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new pt(h,f),m=new Ts(-1,1,1,-1,0,1),g=null,M=null,p=!1,u,S=null,A=[],T=!1;this.setSize=function(C,E){a.setSize(C,E),o!==null&&o.setSize(C,E),c!==null&&c.setSize(C,E);for(let x=0;x<A.length;x++){let b=A[x];b.setSize&&b.setSize(C,E)}},this.setEffects=function(C){A=C,T=A.length>0&&A[0].isRenderPass===!0;let E=a.width,x=a.height;A.length>0&&o===null&&(o=new Ht(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}),c=new Ht(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(N=>N.needsDepthTexture===!0);b!==(a.depthTexture!==null)&&(b===!0&&l===null&&(l=new Ln(E,x),r===!0&&(l.format=Un,l.type=pi)),a.dispose(),a.depthTexture=b?l:null,a.resolveDepthBuffer=b,a.storeMultisampledDepthBuffer=b);for(let N=0;N<A.length;N++){let I=A[N];I.setSize&&I.setSize(E,x),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(l)}},this.begin=function(C,E){if(p||C.toneMapping===vn&&A.length===0)return!1;if(S=E,E!==null){let x=E.width,b=E.height;(a.width!==x||a.height!==b)&&this.setSize(x,b)}return T===!1&&C.setRenderTarget(a),u=C.toneMapping,C.toneMapping=vn,!0},this.hasRenderPass=function(){return T},this.end=function(C,E){C.toneMapping=u,p=!0;let x=a,b=o;for(let N=0;N<A.length;N++){let I=A[N];I.enabled!==!1&&(I.render(C,b,x,E),I.needsSwap!==!1&&(x=b,b=b===o?c:o))}if(g!==C.outputColorSpace||M!==C.toneMapping){g=C.outputColorSpace,M=C.toneMapping,f.defines={},Ve.getTransfer(g)===Ze&&(f.defines.SRGB_TRANSFER="");let N=um[M];N&&(f.defines[N]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(S),C.render(d,m),S=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var Gh=new Ot,Vh=new Ln(1,1),Hh=new fs(1),Wh=new as,Xh=new Lr,qh=new ds,Mh=[],Sh=[],bh=new Float32Array(16),Th=new Float32Array(9),wh=new Float32Array(4);function qi(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Mh[s];if(r===void 0&&(r=new Float32Array(s),Mh[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function mt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function gt(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ha(i,e){let t=Sh[e];t===void 0&&(t=new Int32Array(e),Sh[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function fm(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function pm(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mt(t,e))return;i.uniform2fv(this.addr,e),gt(t,e)}}function mm(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(mt(t,e))return;i.uniform3fv(this.addr,e),gt(t,e)}}function gm(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mt(t,e))return;i.uniform4fv(this.addr,e),gt(t,e)}}function xm(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),gt(t,e)}else{if(mt(t,n))return;wh.set(n),i.uniformMatrix2fv(this.addr,!1,wh),gt(t,n)}}function vm(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),gt(t,e)}else{if(mt(t,n))return;Th.set(n),i.uniformMatrix3fv(this.addr,!1,Th),gt(t,n)}}function ym(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),gt(t,e)}else{if(mt(t,n))return;bh.set(n),i.uniformMatrix4fv(this.addr,!1,bh),gt(t,n)}}function Mm(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Sm(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mt(t,e))return;i.uniform2iv(this.addr,e),gt(t,e)}}function bm(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mt(t,e))return;i.uniform3iv(this.addr,e),gt(t,e)}}function Tm(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mt(t,e))return;i.uniform4iv(this.addr,e),gt(t,e)}}function wm(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Em(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mt(t,e))return;i.uniform2uiv(this.addr,e),gt(t,e)}}function Am(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mt(t,e))return;i.uniform3uiv(this.addr,e),gt(t,e)}}function Cm(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mt(t,e))return;i.uniform4uiv(this.addr,e),gt(t,e)}}function Wa(i){return i.version===0&&(i.compareFunction=ll,i.needsUpdate=!0),i}function Rm(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Wa(Vh):r=Gh,t.setTexture2D(e||r,s)}function _m(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Xh,s)}function Pm(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Wa(Hh):r=qh,t.setTextureCube(e||r,s)}function Im(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Wh,s)}function Lm(i){switch(i){case 5126:return fm;case 35664:return pm;case 35665:return mm;case 35666:return gm;case 35674:return xm;case 35675:return vm;case 35676:return ym;case 5124:case 35670:return Mm;case 35667:case 35671:return Sm;case 35668:case 35672:return bm;case 35669:case 35673:return Tm;case 5125:return wm;case 36294:return Em;case 36295:return Am;case 36296:return Cm;case 35678:case 36198:case 36298:case 36306:case 35682:return Rm;case 35679:case 36299:case 36307:return _m;case 35680:case 36300:case 36308:case 36293:return Pm;case 36289:case 36303:case 36311:case 36292:return Im}}function Dm(i,e){i.uniform1fv(this.addr,e)}function Nm(i,e){let t=qi(e,this.size,2);i.uniform2fv(this.addr,t)}function Um(i,e){let t=qi(e,this.size,3);i.uniform3fv(this.addr,t)}function Fm(i,e){let t=qi(e,this.size,4);i.uniform4fv(this.addr,t)}function Om(i,e){let t=qi(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Bm(i,e){let t=qi(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function zm(i,e){let t=qi(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function km(i,e){i.uniform1iv(this.addr,e)}function Gm(i,e){i.uniform2iv(this.addr,e)}function Vm(i,e){i.uniform3iv(this.addr,e)}function Hm(i,e){i.uniform4iv(this.addr,e)}function Wm(i,e){i.uniform1uiv(this.addr,e)}function Xm(i,e){i.uniform2uiv(this.addr,e)}function qm(i,e){i.uniform3uiv(this.addr,e)}function Zm(i,e){i.uniform4uiv(this.addr,e)}function Ym(i,e,t){let n=this.cache,s=e.length,r=Ha(t,s);mt(n,r)||(i.uniform1iv(this.addr,r),gt(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Wa(Vh):a=Gh;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function Jm(i,e,t){let n=this.cache,s=e.length,r=Ha(t,s);mt(n,r)||(i.uniform1iv(this.addr,r),gt(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||Xh,r[a])}function Km(i,e,t){let n=this.cache,s=e.length,r=Ha(t,s);mt(n,r)||(i.uniform1iv(this.addr,r),gt(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Wa(Hh):a=qh;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function jm(i,e,t){let n=this.cache,s=e.length,r=Ha(t,s);mt(n,r)||(i.uniform1iv(this.addr,r),gt(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||Wh,r[a])}function Qm(i){switch(i){case 5126:return Dm;case 35664:return Nm;case 35665:return Um;case 35666:return Fm;case 35674:return Om;case 35675:return Bm;case 35676:return zm;case 5124:case 35670:return km;case 35667:case 35671:return Gm;case 35668:case 35672:return Vm;case 35669:case 35673:return Hm;case 5125:return Wm;case 36294:return Xm;case 36295:return qm;case 36296:return Zm;case 35678:case 36198:case 36298:case 36306:case 35682:return Ym;case 35679:case 36299:case 36307:return Jm;case 35680:case 36300:case 36308:case 36293:return Km;case 36289:case 36303:case 36311:case 36292:return jm}}var vl=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Lm(t.type)}},yl=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Qm(t.type)}},Ml=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},gl=/(\w+)(\])?(\[|\.)?/g;function Eh(i,e){i.seq.push(e),i.map[e.id]=e}function $m(i,e,t){let n=i.name,s=n.length;for(gl.lastIndex=0;;){let r=gl.exec(n),a=gl.lastIndex,o=r[1],c=r[2]==="]",l=r[3];if(c&&(o=o|0),l===void 0||l==="["&&a+2===s){Eh(t,l===void 0?new vl(o,i,e):new yl(o,i,e));break}else{let f=t.map[o];f===void 0&&(f=new Ml(o),Eh(t,f)),t=f}}}var Xi=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),c=e.getUniformLocation(t,o.name);$m(o,c,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],c=n[o.id];c.needsUpdate!==!1&&o.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function Ah(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var eg=37297,tg=0;function ng(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var Ch=new Pe;function ig(i){Ve._getMatrix(Ch,Ve.workingColorSpace,i);let e=`mat3( ${Ch.elements.map(t=>t.toFixed(4))} )`;switch(Ve.getTransfer(i)){case ss:return[e,"LinearTransferOETF"];case Ze:return[e,"sRGBTransferOETF"];default:return Ce("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Rh(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+ng(i.getShaderSource(e),o)}else return r}function sg(i,e){let t=ig(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rg={[Xo]:"Linear",[qo]:"Reinhard",[Zo]:"Cineon",[Yo]:"ACESFilmic",[Ko]:"AgX",[jo]:"Neutral",[Jo]:"Custom"};function ag(i,e){let t=rg[e];return t===void 0?(Ce("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ka=new U;function og(){Ve.getLuminanceCoefficients(ka);let i=ka.x.toFixed(4),e=ka.y.toFixed(4),t=ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lg(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fs).join(`
`)}function cg(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function hg(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function Fs(i){return i!==""}function _h(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ph(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var ug=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sl(i){return i.replace(ug,dg)}function dg(i,e){let t=Be[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Sl(t)}var fg=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ih(i){return i.replace(fg,pg)}function pg(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Lh(i){let e=`precision ${i.precision} float;
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
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var mg={[As]:"SHADOWMAP_TYPE_PCF",[Gi]:"SHADOWMAP_TYPE_VSM"};function gg(i){return mg[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var xg={[Hi]:"ENVMAP_MODE_REFRACTION"};function vg(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":xg[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yg={[Qr]:"ENVMAP_BLENDING_MULTIPLY",[Jc]:"ENVMAP_BLENDING_MIX",[Kc]:"ENVMAP_BLENDING_ADD"};function Mg(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":yg[i.combine]||"ENVMAP_BLENDING_NONE"}function Sg(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,c=gg(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=vg(t),f=Mg(t),d=lg(t),m=cg(r),g=s.createProgram(),M,p,u=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(Fs).join(`
`),M.length>0&&(M+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(Fs).join(`
`),p.length>0&&(p+=`
`)):(M=[Lh(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fs).join(`
`),p=[Lh(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+h:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==vn?"#define TONE_MAPPING":"",t.toneMapping!==vn?Be.tonemapping_pars_fragment:"",t.toneMapping!==vn?ag("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Be.colorspace_pars_fragment,sg("linearToOutputTexel",t.outputColorSpace),og(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Fs).join(`
`)),a=Sl(a),a=_h(a,t),a=Ph(a,t),o=Sl(o),o=_h(o,t),o=Ph(o,t),a=Ih(a),o=Ih(o),t.isRawShaderMaterial!==!0&&(u=`#version 300 es
`,M=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,p=["#define varying in",t.glslVersion===cl?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===cl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=u+M+a,A=u+p+o,T=Ah(s,s.VERTEX_SHADER,S),C=Ah(s,s.FRAGMENT_SHADER,A);s.attachShader(g,T),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(I){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(T)||"",H=s.getShaderInfoLog(C)||"",_=D.trim(),V=B.trim(),q=H.trim(),G=!0,te=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,T,C);else{let X=Rh(s,T,"vertex"),Q=Rh(s,C,"fragment");_e("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+_+`
`+X+`
`+Q)}else _!==""?Ce("WebGLProgram: Program Info Log:",_):(V===""||q==="")&&(te=!1);te&&(I.diagnostics={runnable:G,programLog:_,vertexShader:{log:V,prefix:M},fragmentShader:{log:q,prefix:p}})}s.deleteShader(T),s.deleteShader(C),x=new Xi(s,g),b=hg(s,g)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let N=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(g,eg)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=tg++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=T,this.fragmentShader=C,this}var bg=0,bl=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Tl(e),t.set(e,n)),n}},Tl=class{constructor(e){this.id=bg++,this.code=e,this.usedTimes=0}};function Tg(i){return i===$n||i===Ls||i===Ds}function wg(i,e,t,n,s,r){let a=new os,o=new bl,c=new Set,l=[],h=new Map,f=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,b,N,I,D,B){let H=I.fog,_=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=e.get(x.envMap||V,q),te=d[x.type],X=n.precision;x.precision!==null&&(X=n.getMaxPrecision(x.precision),X!==x.precision&&Ce("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let Q=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,$=Q!==void 0?Q.length:0,Se=0;_.morphAttributes.position!==void 0&&(Se=1),_.morphAttributes.normal!==void 0&&(Se=2),_.morphAttributes.color!==void 0&&(Se=3);let Le,J,pe,ve;if(te){let de=Mn[te];Le=de.vertexShader,J=de.fragmentShader}else{Le=x.vertexShader,J=x.fragmentShader;let de=o.getVertexShaderStage(x),Je=o.getFragmentShaderStage(x);o.update(x,de,Je),pe=de.id,ve=Je.id}let Ee=i.getRenderTarget(),me=i.state.buffers.depth.getReversed(),Ne=D.isInstancedMesh===!0,lt=D.isBatchedMesh===!0,Re=!!x.map,Ye=!!x.matcap,Ke=!!G,ze=Ke&&G.isPMREMTexture===!0,bt=!!x.aoMap,dt=!!x.lightMap,Ft=!!x.bumpMap&&x.wireframe===!1,rt=!!x.normalMap,un=!!x.displacementMap,xt=!!x.emissiveMap,qt=!!x.metalnessMap,Zt=!!x.roughnessMap,Yt=x.anisotropy>0,L=x.clearcoat>0,Jt=x.diffuseRoughness>0,nt=x.dispersion>0,it=x.retroreflectivity>0,ue=x.iridescence>0,ft=x.sheen>0,Ae=x.transmission>0,Ie=Yt&&!!x.anisotropyMap,w=L&&!!x.clearcoatMap,v=L&&!!x.clearcoatNormalMap,O=L&&!!x.clearcoatRoughnessMap,ee=Jt&&!!x.diffuseRoughnessMap,j=ue&&!!x.iridescenceMap,se=ue&&!!x.iridescenceThicknessMap,ce=ft&&!!x.sheenColorMap,Z=ft&&!!x.sheenRoughnessMap,Y=!!x.specularMap,ae=!!x.specularColorMap,R=!!x.specularIntensityMap,K=Ae&&!!x.transmissionMap,W=Ae&&!!x.thicknessMap,oe=!!x.gradientMap,ie=!!x.alphaMap,re=x.alphaTest>0,Te=!!x.alphaHash,Oe=!!x.extensions,ne=vn;x.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(ne=i.toneMapping);let we=ze?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Fe={shaderID:te,shaderType:x.type,shaderName:x.name,vertexShader:Le,fragmentShader:J,defines:x.defines,customVertexShaderID:pe,customFragmentShaderID:ve,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:lt,batchingColor:lt&&D._colorsTexture!==null,instancing:Ne,instancingColor:Ne&&D.instanceColor!==null,instancingMorph:Ne&&D.morphTexture!==null,outputColorSpace:Ee===null?i.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:Ve.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Re,matcap:Ye,envMap:Ke,envMapMode:Ke&&G.mapping,envMapPMREM:ze,envMapMaxLod:ze?we.length-1:null,envMapSize:ze?we[0].width:null,aoMap:bt,lightMap:dt,bumpMap:Ft,normalMap:rt,displacementMap:un,emissiveMap:xt,normalMapObjectSpace:rt&&x.normalMapType===$c,normalMapTangentSpace:rt&&x.normalMapType===Ba,packedNormalMap:rt&&x.normalMapType===Ba&&Tg(x.normalMap.format),metalnessMap:qt,roughnessMap:Zt,anisotropy:Yt,anisotropyMap:Ie,clearcoat:L,clearcoatMap:w,clearcoatNormalMap:v,clearcoatRoughnessMap:O,diffuseRoughness:Jt,diffuseRoughnessMap:ee,dispersion:nt,retroreflection:it,iridescence:ue,iridescenceMap:j,iridescenceThicknessMap:se,sheen:ft,sheenColorMap:ce,sheenRoughnessMap:Z,specularMap:Y,specularColorMap:ae,specularIntensityMap:R,transmission:Ae,transmissionMap:K,thicknessMap:W,gradientMap:oe,opaque:x.transparent===!1&&x.blending===Vi&&x.alphaToCoverage===!1,alphaMap:ie,alphaTest:re,alphaHash:Te,combine:x.combine,mapUv:Re&&m(x.map.channel),aoMapUv:bt&&m(x.aoMap.channel),lightMapUv:dt&&m(x.lightMap.channel),bumpMapUv:Ft&&m(x.bumpMap.channel),normalMapUv:rt&&m(x.normalMap.channel),displacementMapUv:un&&m(x.displacementMap.channel),emissiveMapUv:xt&&m(x.emissiveMap.channel),metalnessMapUv:qt&&m(x.metalnessMap.channel),roughnessMapUv:Zt&&m(x.roughnessMap.channel),anisotropyMapUv:Ie&&m(x.anisotropyMap.channel),clearcoatMapUv:w&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ee&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:j&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:se&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:ce&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:Z&&m(x.sheenRoughnessMap.channel),specularMapUv:Y&&m(x.specularMap.channel),specularColorMapUv:ae&&m(x.specularColorMap.channel),specularIntensityMapUv:R&&m(x.specularIntensityMap.channel),transmissionMapUv:K&&m(x.transmissionMap.channel),thicknessMapUv:W&&m(x.thicknessMap.channel),alphaMapUv:ie&&m(x.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(rt||Yt),vertexNormals:!!_.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!_.attributes.uv&&(Re||ie),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||_.attributes.normal===void 0&&rt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:me,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:Se,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(de=>de.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:ne,decodeVideoTexture:Re&&x.map.isVideoTexture===!0&&Ve.getTransfer(x.map.colorSpace)===Ze,decodeVideoTextureEmissive:xt&&x.emissiveMap.isVideoTexture===!0&&Ve.getTransfer(x.emissiveMap.colorSpace)===Ze,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===xn,flipSided:x.side===Nt,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Oe&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&x.extensions.multiDraw===!0||lt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Fe.vertexUv1s=c.has(1),Fe.vertexUv2s=c.has(2),Fe.vertexUv3s=c.has(3),c.clear(),Fe}function M(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let N in x.defines)b.push(N),b.push(x.defines[N]);return x.isRawShaderMaterial===!1&&(p(b,x),u(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function p(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function u(x,b){a.disableAll(),b.instancing&&a.enable(0),b.instancingColor&&a.enable(1),b.instancingMorph&&a.enable(2),b.matcap&&a.enable(3),b.envMap&&a.enable(4),b.normalMapObjectSpace&&a.enable(5),b.normalMapTangentSpace&&a.enable(6),b.clearcoat&&a.enable(7),b.iridescence&&a.enable(8),b.alphaTest&&a.enable(9),b.vertexColors&&a.enable(10),b.vertexAlphas&&a.enable(11),b.vertexUv1s&&a.enable(12),b.vertexUv2s&&a.enable(13),b.vertexUv3s&&a.enable(14),b.vertexTangents&&a.enable(15),b.anisotropy&&a.enable(16),b.alphaHash&&a.enable(17),b.batching&&a.enable(18),b.dispersion&&a.enable(19),b.retroreflection&&a.enable(24),b.diffuseRoughness&&a.enable(25),b.batchingColor&&a.enable(20),b.gradientMap&&a.enable(21),b.packedNormalMap&&a.enable(22),b.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),b.numLightProbeGrids>0&&a.enable(22),b.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function S(x){let b=d[x.type],N;if(b){let I=Mn[b];N=fh.clone(I.uniforms)}else N=x.uniforms;return N}function A(x,b){let N=h.get(b);return N!==void 0?++N.usedTimes:(N=new Sg(i,b,x,s),l.push(N),h.set(b,N)),N}function T(x){if(--x.usedTimes===0){let b=l.indexOf(x);l[b]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){o.remove(x)}function E(){o.dispose()}return{getParameters:g,getProgramCacheKey:M,getUniforms:S,acquireProgram:A,releaseProgram:T,releaseShaderCache:C,programs:l,dispose:E}}function Eg(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,c){i.get(a)[o]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Ag(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Dh(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Nh(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function o(d,m,g,M,p,u){let S=i[e];return S===void 0?(S={id:d.id,object:d,geometry:m,material:g,materialVariant:a(d),groupOrder:M,renderOrder:d.renderOrder,z:p,group:u},i[e]=S):(S.id=d.id,S.object=d,S.geometry=m,S.material=g,S.materialVariant=a(d),S.groupOrder=M,S.renderOrder=d.renderOrder,S.z=p,S.group=u),e++,S}function c(d,m,g,M,p,u,S){S.reversedDepth===!0&&(p=-p);let A=o(d,m,g,M,p,u);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):t.push(A)}function l(d,m,g,M,p,u){let S=o(d,m,g,M,p,u);g.transmission>0?n.unshift(S):g.transparent===!0?s.unshift(S):t.unshift(S)}function h(d,m){t.length>1&&t.sort(d||Ag),n.length>1&&n.sort(m||Dh),s.length>1&&s.sort(m||Dh)}function f(){for(let d=e,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:f,sort:h}}function Cg(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new Nh,i.set(n,[a])):s>=r.length?(a=new Nh,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function Rg(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new U,color:new Ue};break;case"SpotLight":t={position:new U,direction:new U,color:new Ue,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new Ue,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new Ue,groundColor:new Ue};break;case"RectAreaLight":t={color:new Ue,position:new U,halfWidth:new U,halfHeight:new U};break}return i[e.id]=t,t}}}function _g(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new He};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new He};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new He,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var Pg=0;function Ig(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Lg(i){let e=new Rg,t=_g(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new U);let s=new U,r=new Qe,a=new Qe;function o(l){let h=0,f=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let m=0,g=0,M=0,p=0,u=0,S=0,A=0,T=0,C=0,E=0,x=0,b=0,N=0,I=0;l.sort(Ig);for(let B=0,H=l.length;B<H;B++){let _=l[B],V=_.color,q=_.intensity,G=_.distance,te=null;if(_.shadow&&_.shadow.map&&(_.shadow.map.texture.format===$n?te=_.shadow.map.texture:te=_.shadow.map.depthTexture||_.shadow.map.texture),_.isAmbientLight)h+=V.r*q,f+=V.g*q,d+=V.b*q;else if(_.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(_.sh.coefficients[X],q);I++}else if(_.isSunLight){let X=e.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=t.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=$,n.sunShadowMap[g]=te;let Se=Q.getViewportCount();for(let Le=0;Le<Se;Le++)n.sunShadowMatrix[M+Le]=Q.getMatrix(Le),n.sunShadowCascade[M+Le]=Q._cascadeData[Le];M+=Se,g++}n.sun[m]=X,m++}else if(_.isDirectionalLight){let X=e.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=t.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.directionalShadow[p]=$,n.directionalShadowMap[p]=te,n.directionalShadowMatrix[p]=_.shadow.matrix,C++}n.directional[p]=X,p++}else if(_.isSpotLight){let X=e.get(_);X.position.setFromMatrixPosition(_.matrixWorld),X.color.copy(V).multiplyScalar(q),X.distance=G,X.coneCos=Math.cos(_.angle),X.penumbraCos=Math.cos(_.angle*(1-_.penumbra)),X.decay=_.decay,n.spot[S]=X;let Q=_.shadow;if(_.map&&(n.spotLightMap[b]=_.map,b++,Q.updateMatrices(_),_.castShadow&&N++),n.spotLightMatrix[S]=Q.matrix,_.castShadow){let $=t.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.spotShadow[S]=$,n.spotShadowMap[S]=te,x++}S++}else if(_.isRectAreaLight){let X=e.get(_);X.color.copy(V).multiplyScalar(q),X.halfWidth.set(_.width*.5,0,0),X.halfHeight.set(0,_.height*.5,0),n.rectArea[A]=X,A++}else if(_.isPointLight){let X=e.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),X.distance=_.distance,X.decay=_.decay,_.castShadow){let Q=_.shadow,$=t.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,$.shadowCameraNear=Q.camera.near,$.shadowCameraFar=Q.camera.far,n.pointShadow[u]=$,n.pointShadowMap[u]=te,n.pointShadowMatrix[u]=_.shadow.matrix,E++}n.point[u]=X,u++}else if(_.isHemisphereLight){let X=e.get(_);X.skyColor.copy(_.color).multiplyScalar(q),X.groundColor.copy(_.groundColor).multiplyScalar(q),n.hemi[T]=X,T++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=fe.LTC_FLOAT_1,n.rectAreaLTC2=fe.LTC_FLOAT_2):(n.rectAreaLTC1=fe.LTC_HALF_1,n.rectAreaLTC2=fe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=d;let D=n.hash;(D.sunLength!==m||D.directionalLength!==p||D.pointLength!==u||D.spotLength!==S||D.rectAreaLength!==A||D.hemiLength!==T||D.numSunShadows!==g||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==x||D.numSpotMaps!==b||D.numLightProbes!==I)&&(n.sun.length=m,n.directional.length=p,n.spot.length=S,n.rectArea.length=A,n.point.length=u,n.hemi.length=T,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=M,n.sunShadowCascade.length=M,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-N,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=I,D.sunLength=m,D.directionalLength=p,D.pointLength=u,D.spotLength=S,D.rectAreaLength=A,D.hemiLength=T,D.numSunShadows=g,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=x,D.numSpotMaps=b,D.numLightProbes=I,n.version=Pg++)}function c(l,h){let f=0,d=0,m=0,g=0,M=0,p=0,u=h.matrixWorldInverse;for(let S=0,A=l.length;S<A;S++){let T=l[S];if(T.isSunLight){let C=n.sun[f];C.direction.setFromMatrixPosition(T.matrixWorld),C.direction.transformDirection(u),f++}else if(T.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(u),d++}else if(T.isSpotLight){let C=n.spot[g];C.position.setFromMatrixPosition(T.matrixWorld),C.position.applyMatrix4(u),C.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(u),g++}else if(T.isRectAreaLight){let C=n.rectArea[M];C.position.setFromMatrixPosition(T.matrixWorld),C.position.applyMatrix4(u),a.identity(),r.copy(T.matrixWorld),r.premultiply(u),a.extractRotation(r),C.halfWidth.set(T.width*.5,0,0),C.halfHeight.set(0,T.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),M++}else if(T.isPointLight){let C=n.point[m];C.position.setFromMatrixPosition(T.matrixWorld),C.position.applyMatrix4(u),m++}else if(T.isHemisphereLight){let C=n.hemi[p];C.direction.setFromMatrixPosition(T.matrixWorld),C.direction.transformDirection(u),p++}}}return{setup:o,setupView:c,state:n}}function Uh(i){let e=new Lg(i),t=[],n=[],s=[];function r(f){h.camera=f,t.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):t.push(f)}function o(f){n.push(f)}function c(){e.setup(t),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function l(f){e.setupView(t,f)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:a,pushShadow:o}}function Dg(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new Uh(i),e.set(s,[o])):r>=a.length?(o=new Uh(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var Ng=`void main() {
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
}`,Fg=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],Og=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],Fh=new Qe,Us=new U,xl=new U;function Bg(i,e,t){let n=new Zn,s=new He,r=new He,a=new st,o=new Br,c=new zr,l={},h=t.maxTextureSize,f={[Qn]:Nt,[Nt]:Qn,[xn]:xn},d=new gn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new He},radius:{value:4}},vertexShader:Ng,fragmentShader:Ug}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new _t;g.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new pt(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=As;let u=this.type;this.render=function(E,x,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===Pc&&(Ce("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=As);let N=i.getRenderTarget(),I=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ui),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let H=u!==this.type;H&&x.traverse(function(_){_.material&&(Array.isArray(_.material)?_.material.forEach(V=>V.needsUpdate=!0):_.material.needsUpdate=!0)});for(let _=0,V=E.length;_<V;_++){let q=E[_],G=q.shadow;if(G===void 0){Ce("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let te=G.getFrameExtents();s.multiply(te),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/te.x),s.x=r.x*te.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/te.y),s.y=r.y*te.y,G.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(G.camera._reversedDepth=X,G.map===null||H===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Gi){if(q.isPointLight){Ce("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Ht(s.x,s.y,{format:$n,type:ln,minFilter:Dt,magFilter:Dt,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new Ln(s.x,s.y,on),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=_n,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=St,G.map.depthTexture.magFilter=St}else q.isPointLight?(G.map=new Os(s.x),G.map.depthTexture=new fs(s.x,an)):(G.map=new Ht(s.x,s.y),G.map.depthTexture=new Ln(s.x,s.y,an)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=_n,this.type===As?(G.map.depthTexture.compareFunction=X?ol:al,G.map.depthTexture.minFilter=Dt,G.map.depthTexture.magFilter=Dt):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=St,G.map.depthTexture.magFilter=St);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,b);let $=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:b.layers;for(let Se=0;Se<Q;Se++){let Le=G.getCamera(Se);if(q.isPointLight){let J=G.camera,pe=G.matrix,ve=q.distance||J.far;ve!==J.far&&(J.far=ve,J.updateProjectionMatrix()),Us.setFromMatrixPosition(q.matrixWorld),J.position.copy(Us),xl.copy(J.position),xl.add(Fg[Se]),J.up.copy(Og[Se]),J.lookAt(xl),J.updateMatrixWorld(),pe.makeTranslation(-Us.x,-Us.y,-Us.z),Fh.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Fh,J.coordinateSystem,J.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)i.setRenderTarget(G.map,Se),i.clear();else{Se===0&&(i.setRenderTarget(G.map),i.clear());let J=G.getViewport(Se);a.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),B.viewport(a)}n=G.getFrustum(Se),T(x,b,Le,q,$,this.type)}G.isPointLightShadow!==!0&&this.type===Gi&&S(G,b),G.needsUpdate=!1}u=this.type,p.needsUpdate=!1,i.setRenderTarget(N,I,D)};function S(E,x){let b=e.update(M);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null?E.mapPass=new Ht(s.x,s.y,{format:$n,type:ln}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,d,M,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value.set(E.map.width,E.map.height),m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,m,M,null)}function A(E,x,b,N){let I=null,D=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)I=D;else if(I=b.isPointLight===!0?c:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=I.uuid,H=x.uuid,_=l[B];_===void 0&&(_={},l[B]=_);let V=_[H];V===void 0&&(V=I.clone(),_[H]=V,x.addEventListener("dispose",C)),I=V}if(I.visible=x.visible,I.wireframe=x.wireframe,N===Gi?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:f[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=i.properties.get(I);B.light=b}return I}function T(E,x,b,N,I,D){if(E.visible===!1)return;if(E.layers.test(I)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Gi)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let _=e.update(E),V=E.material;if(Array.isArray(V)){let q=_.groups;for(let G=0,te=q.length;G<te;G++){let X=q[G],Q=V[X.materialIndex];if(Q&&Q.visible){let $=A(E,Q,N,D);E.onBeforeShadow(i,E,x,b,_,$,X),i.renderBufferDirect(b,null,_,$,E,X),E.onAfterShadow(i,E,x,b,_,$,X)}}}else if(V.visible){let q=A(E,V,N,D);E.onBeforeShadow(i,E,x,b,_,q,null),i.renderBufferDirect(b,null,_,q,E,null),E.onAfterShadow(i,E,x,b,_,q,null)}}let H=E.children;for(let _=0,V=H.length;_<V;_++)T(H[_],x,b,N,I,D)}function C(E){E.target.removeEventListener("dispose",C);for(let b in l){let N=l[b],I=E.target.uuid;I in N&&(N[I].dispose(),delete N[I])}}}function zg(i,e){function t(){let R=!1,K=new st,W=null,oe=new st(0,0,0,0);return{setMask:function(ie){W!==ie&&!R&&(i.colorMask(ie,ie,ie,ie),W=ie)},setLocked:function(ie){R=ie},setClear:function(ie,re,Te,Oe,ne){ne===!0&&(ie*=Oe,re*=Oe,Te*=Oe),K.set(ie,re,Te,Oe),oe.equals(K)===!1&&(i.clearColor(ie,re,Te,Oe),oe.copy(K))},reset:function(){R=!1,W=null,oe.set(-1,0,0,0)}}}function n(){let R=!1,K=!1,W=null,oe=null,ie=null;return{setReversed:function(re){if(K!==re){let Te=e.get("EXT_clip_control");re?Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.ZERO_TO_ONE_EXT):Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.NEGATIVE_ONE_TO_ONE_EXT),K=re;let Oe=ie;ie=null,this.setClear(Oe)}},getReversed:function(){return K},setTest:function(re){re?me(i.DEPTH_TEST):Ne(i.DEPTH_TEST)},setMask:function(re){W!==re&&!R&&(i.depthMask(re),W=re)},setFunc:function(re){if(K&&(re=hh[re]),oe!==re){switch(re){case yr:i.depthFunc(i.NEVER);break;case Mr:i.depthFunc(i.ALWAYS);break;case Sr:i.depthFunc(i.LESS);break;case Ii:i.depthFunc(i.LEQUAL);break;case br:i.depthFunc(i.EQUAL);break;case Tr:i.depthFunc(i.GEQUAL);break;case wr:i.depthFunc(i.GREATER);break;case Er:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}oe=re}},setLocked:function(re){R=re},setClear:function(re){ie!==re&&(ie=re,K&&(re=1-re),i.clearDepth(re))},reset:function(){R=!1,W=null,oe=null,ie=null,K=!1}}}function s(){let R=!1,K=null,W=null,oe=null,ie=null,re=null,Te=null,Oe=null,ne=null;return{setTest:function(we){R||(we?me(i.STENCIL_TEST):Ne(i.STENCIL_TEST))},setMask:function(we){K!==we&&!R&&(i.stencilMask(we),K=we)},setFunc:function(we,Fe,de){(W!==we||oe!==Fe||ie!==de)&&(i.stencilFunc(we,Fe,de),W=we,oe=Fe,ie=de)},setOp:function(we,Fe,de){(re!==we||Te!==Fe||Oe!==de)&&(i.stencilOp(we,Fe,de),re=we,Te=Fe,Oe=de)},setLocked:function(we){R=we},setClear:function(we){ne!==we&&(i.clearStencil(we),ne=we)},reset:function(){R=!1,K=null,W=null,oe=null,ie=null,re=null,Te=null,Oe=null,ne=null}}}let r=new t,a=new n,o=new s,c={},l=new WeakMap,h={},f={},d={},m=new WeakMap,g=[],M=null,p=!1,u=null,S=null,A=null,T=null,C=null,E=null,x=null,b=new Ue(0,0,0),N=0,I=!1,D=null,B=null,H=null,_=null,V=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,te=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(te=parseFloat(/^WebGL (\d)/.exec(X)[1]),G=te>=1):X.indexOf("OpenGL ES")!==-1&&(te=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),G=te>=2);let Q=null,$={},Se=i.getParameter(i.SCISSOR_BOX),Le=i.getParameter(i.VIEWPORT),J=new st().fromArray(Se),pe=new st().fromArray(Le);function ve(R,K,W,oe){let ie=new Uint8Array(4),re=i.createTexture();i.bindTexture(R,re),i.texParameteri(R,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(R,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Te=0;Te<W;Te++)R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,oe,0,i.RGBA,i.UNSIGNED_BYTE,ie):i.texImage2D(K+Te,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ie);return re}let Ee={};Ee[i.TEXTURE_2D]=ve(i.TEXTURE_2D,i.TEXTURE_2D,1),Ee[i.TEXTURE_CUBE_MAP]=ve(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[i.TEXTURE_2D_ARRAY]=ve(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ee[i.TEXTURE_3D]=ve(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),me(i.DEPTH_TEST),a.setFunc(Ii),Ft(!1),rt(zo),me(i.CULL_FACE),bt(ui);function me(R){h[R]!==!0&&(i.enable(R),h[R]=!0)}function Ne(R){h[R]!==!1&&(i.disable(R),h[R]=!1)}function lt(R,K){return d[R]!==K?(i.bindFramebuffer(R,K),d[R]=K,R===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),R===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Re(R,K){let W=g,oe=!1;if(R){W=m.get(K),W===void 0&&(W=[],m.set(K,W));let ie=R.textures;if(W.length!==ie.length||W[0]!==i.COLOR_ATTACHMENT0){for(let re=0,Te=ie.length;re<Te;re++)W[re]=i.COLOR_ATTACHMENT0+re;W.length=ie.length,oe=!0}}else W[0]!==i.BACK&&(W[0]=i.BACK,oe=!0);oe&&i.drawBuffers(W)}function Ye(R){return M!==R?(i.useProgram(R),M=R,!0):!1}let Ke={[di]:i.FUNC_ADD,[Lc]:i.FUNC_SUBTRACT,[Dc]:i.FUNC_REVERSE_SUBTRACT};Ke[Nc]=i.MIN,Ke[Uc]=i.MAX;let ze={[Fc]:i.ZERO,[Oc]:i.ONE,[Bc]:i.SRC_COLOR,[Ho]:i.SRC_ALPHA,[Wc]:i.SRC_ALPHA_SATURATE,[Vc]:i.DST_COLOR,[kc]:i.DST_ALPHA,[zc]:i.ONE_MINUS_SRC_COLOR,[Wo]:i.ONE_MINUS_SRC_ALPHA,[Hc]:i.ONE_MINUS_DST_COLOR,[Gc]:i.ONE_MINUS_DST_ALPHA,[Xc]:i.CONSTANT_COLOR,[qc]:i.ONE_MINUS_CONSTANT_COLOR,[Zc]:i.CONSTANT_ALPHA,[Yc]:i.ONE_MINUS_CONSTANT_ALPHA};function bt(R,K,W,oe,ie,re,Te,Oe,ne,we){if(R===ui){p===!0&&(Ne(i.BLEND),p=!1);return}if(p===!1&&(me(i.BLEND),p=!0),R!==Ic){if(R!==u||we!==I){if((S!==di||C!==di)&&(i.blendEquation(i.FUNC_ADD),S=di,C=di),we)switch(R){case Vi:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFunc(i.ONE,i.ONE);break;case Go:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Vo:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:_e("WebGLState: Invalid blending: ",R);break}else switch(R){case Vi:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Go:_e("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vo:_e("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:_e("WebGLState: Invalid blending: ",R);break}A=null,T=null,E=null,x=null,b.set(0,0,0),N=0,u=R,I=we}return}ie=ie||K,re=re||W,Te=Te||oe,(K!==S||ie!==C)&&(i.blendEquationSeparate(Ke[K],Ke[ie]),S=K,C=ie),(W!==A||oe!==T||re!==E||Te!==x)&&(i.blendFuncSeparate(ze[W],ze[oe],ze[re],ze[Te]),A=W,T=oe,E=re,x=Te),(Oe.equals(b)===!1||ne!==N)&&(i.blendColor(Oe.r,Oe.g,Oe.b,ne),b.copy(Oe),N=ne),u=R,I=!1}function dt(R,K){R.side===xn?Ne(i.CULL_FACE):me(i.CULL_FACE);let W=R.side===Nt;K&&(W=!W),Ft(W),R.blending===Vi&&R.transparent===!1?bt(ui):bt(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),a.setFunc(R.depthFunc),a.setTest(R.depthTest),a.setMask(R.depthWrite),r.setMask(R.colorWrite);let oe=R.stencilWrite;o.setTest(oe),oe&&(o.setMask(R.stencilWriteMask),o.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),o.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),xt(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?me(i.SAMPLE_ALPHA_TO_COVERAGE):Ne(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ft(R){D!==R&&(R?i.frontFace(i.CW):i.frontFace(i.CCW),D=R)}function rt(R){R!==Rc?(me(i.CULL_FACE),R!==B&&(R===zo?i.cullFace(i.BACK):R===_c?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ne(i.CULL_FACE),B=R}function un(R){R!==H&&(G&&i.lineWidth(R),H=R)}function xt(R,K,W){R?(me(i.POLYGON_OFFSET_FILL),(_!==K||V!==W)&&(_=K,V=W,a.getReversed()&&(K=-K,W=-W),i.polygonOffset(K,W))):Ne(i.POLYGON_OFFSET_FILL)}function qt(R){R?me(i.SCISSOR_TEST):Ne(i.SCISSOR_TEST)}function Zt(R){R===void 0&&(R=i.TEXTURE0+q-1),Q!==R&&(i.activeTexture(R),Q=R)}function Yt(R,K,W){W===void 0&&(Q===null?W=i.TEXTURE0+q-1:W=Q);let oe=$[W];oe===void 0&&(oe={type:void 0,texture:void 0},$[W]=oe),(oe.type!==R||oe.texture!==K)&&(Q!==W&&(i.activeTexture(W),Q=W),i.bindTexture(R,K||Ee[R]),oe.type=R,oe.texture=K)}function L(){let R=$[Q];R!==void 0&&R.type!==void 0&&(i.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function Jt(){try{i.compressedTexImage2D(...arguments)}catch(R){_e("WebGLState:",R)}}function nt(){try{i.compressedTexImage3D(...arguments)}catch(R){_e("WebGLState:",R)}}function it(){try{i.texSubImage2D(...arguments)}catch(R){_e("WebGLState:",R)}}function ue(){try{i.texSubImage3D(...arguments)}catch(R){_e("WebGLState:",R)}}function ft(){try{i.compressedTexSubImage2D(...arguments)}catch(R){_e("WebGLState:",R)}}function Ae(){try{i.compressedTexSubImage3D(...arguments)}catch(R){_e("WebGLState:",R)}}function Ie(){try{i.texStorage2D(...arguments)}catch(R){_e("WebGLState:",R)}}function w(){try{i.texStorage3D(...arguments)}catch(R){_e("WebGLState:",R)}}function v(){try{i.texImage2D(...arguments)}catch(R){_e("WebGLState:",R)}}function O(){try{i.texImage3D(...arguments)}catch(R){_e("WebGLState:",R)}}function ee(R){return f[R]!==void 0?f[R]:i.getParameter(R)}function j(R,K){f[R]!==K&&(i.pixelStorei(R,K),f[R]=K)}function se(R){J.equals(R)===!1&&(i.scissor(R.x,R.y,R.z,R.w),J.copy(R))}function ce(R){pe.equals(R)===!1&&(i.viewport(R.x,R.y,R.z,R.w),pe.copy(R))}function Z(R,K){let W=l.get(K);W===void 0&&(W=new WeakMap,l.set(K,W));let oe=W.get(R);oe===void 0&&(oe=i.getUniformBlockIndex(K,R.name),i.uniformBlockBinding(K,oe,oe),W.set(R,oe))}function Y(R,K,W){let ie=l.get(K).get(R);c[ie]!==W&&(i.bindBufferBase(i.UNIFORM_BUFFER,ie,W),c[ie]=W)}function ae(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,$={},d={},c={},m=new WeakMap,g=[],M=null,p=!1,u=null,S=null,A=null,T=null,C=null,E=null,x=null,b=new Ue(0,0,0),N=0,I=!1,D=null,B=null,H=null,_=null,V=null,J.set(0,0,i.canvas.width,i.canvas.height),pe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:me,disable:Ne,bindFramebuffer:lt,drawBuffers:Re,useProgram:Ye,setBlending:bt,setMaterial:dt,setFlipSided:Ft,setCullFace:rt,setLineWidth:un,setPolygonOffset:xt,setScissorTest:qt,activeTexture:Zt,bindTexture:Yt,unbindTexture:L,compressedTexImage2D:Jt,compressedTexImage3D:nt,texImage2D:v,texImage3D:O,pixelStorei:j,getParameter:ee,updateUBOMapping:Z,uniformBlockBinding:Y,texStorage2D:Ie,texStorage3D:w,texSubImage2D:it,texSubImage3D:ue,compressedTexSubImage2D:ft,compressedTexSubImage3D:Ae,scissor:se,viewport:ce,reset:ae}}function kg(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new He,h=new WeakMap,f=new Set,d,m=new WeakMap,g=new Set,M=new FinalizationRegistry(w=>g.delete(w)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function u(w,v){return p?new OffscreenCanvas(w,v):rs("canvas")}function S(w,v,O){let ee=1,j=Ie(w);if((j.width>O||j.height>O)&&(ee=O/Math.max(j.width,j.height)),ee<1)if(typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&w instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&w instanceof ImageBitmap||typeof VideoFrame<"u"&&w instanceof VideoFrame){let se=Math.floor(ee*j.width),ce=Math.floor(ee*j.height);d===void 0&&(d=u(se,ce));let Z=v?u(se,ce):d;return Z.width=se,Z.height=ce,Z.getContext("2d").drawImage(w,0,0,se,ce),Ce("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+se+"x"+ce+")."),Z}else return"data"in w&&Ce("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),w;return w}function A(w){return w.generateMipmaps}function T(w){i.generateMipmap(w)}function C(w){return w.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:w.isWebGL3DRenderTarget?i.TEXTURE_3D:w.isWebGLArrayRenderTarget||w.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(w,v,O,ee,j,se=!1){if(w!==null){if(i[w]!==void 0)return i[w];Ce("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+w+"'")}let ce;ee&&(ce=e.get("EXT_texture_norm16"),ce||Ce("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=v;if(v===i.RED&&(O===i.FLOAT&&(Z=i.R32F),O===i.HALF_FLOAT&&(Z=i.R16F),O===i.UNSIGNED_BYTE&&(Z=i.R8),O===i.UNSIGNED_SHORT&&ce&&(Z=ce.R16_EXT),O===i.SHORT&&ce&&(Z=ce.R16_SNORM_EXT)),v===i.RED_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.R8UI),O===i.UNSIGNED_SHORT&&(Z=i.R16UI),O===i.UNSIGNED_INT&&(Z=i.R32UI),O===i.BYTE&&(Z=i.R8I),O===i.SHORT&&(Z=i.R16I),O===i.INT&&(Z=i.R32I)),v===i.RG&&(O===i.FLOAT&&(Z=i.RG32F),O===i.HALF_FLOAT&&(Z=i.RG16F),O===i.UNSIGNED_BYTE&&(Z=i.RG8),O===i.UNSIGNED_SHORT&&ce&&(Z=ce.RG16_EXT),O===i.SHORT&&ce&&(Z=ce.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RG8UI),O===i.UNSIGNED_SHORT&&(Z=i.RG16UI),O===i.UNSIGNED_INT&&(Z=i.RG32UI),O===i.BYTE&&(Z=i.RG8I),O===i.SHORT&&(Z=i.RG16I),O===i.INT&&(Z=i.RG32I)),v===i.RGB_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),O===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),O===i.UNSIGNED_INT&&(Z=i.RGB32UI),O===i.BYTE&&(Z=i.RGB8I),O===i.SHORT&&(Z=i.RGB16I),O===i.INT&&(Z=i.RGB32I)),v===i.RGBA_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),O===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),O===i.UNSIGNED_INT&&(Z=i.RGBA32UI),O===i.BYTE&&(Z=i.RGBA8I),O===i.SHORT&&(Z=i.RGBA16I),O===i.INT&&(Z=i.RGBA32I)),v===i.RGB&&(O===i.UNSIGNED_SHORT&&ce&&(Z=ce.RGB16_EXT),O===i.SHORT&&ce&&(Z=ce.RGB16_SNORM_EXT),O===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),O===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),v===i.RGBA){let Y=se?ss:Ve.getTransfer(j);O===i.FLOAT&&(Z=i.RGBA32F),O===i.HALF_FLOAT&&(Z=i.RGBA16F),O===i.UNSIGNED_BYTE&&(Z=Y===Ze?i.SRGB8_ALPHA8:i.RGBA8),O===i.UNSIGNED_SHORT&&ce&&(Z=ce.RGBA16_EXT),O===i.SHORT&&ce&&(Z=ce.RGBA16_SNORM_EXT),O===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),O===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function x(w,v){let O;return w?v===null||v===an||v===pi?O=i.DEPTH24_STENCIL8:v===on?O=i.DEPTH32F_STENCIL8:v===Wi&&(O=i.DEPTH24_STENCIL8,Ce("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===an||v===pi?O=i.DEPTH_COMPONENT24:v===on?O=i.DEPTH_COMPONENT32F:v===Wi&&(O=i.DEPTH_COMPONENT16),O}function b(w,v){return A(w)===!0||w.isFramebufferTexture&&w.minFilter!==St&&w.minFilter!==Dt?Math.log2(Math.max(v.width,v.height))+1:w.mipmaps.length>0?w.mipmaps.length:w.isCompressedTexture&&Array.isArray(w.image)?v.mipmaps.length:1}function N(w){let v=new WeakRef(w);n.get(w).__ref=v,g.add(v),M.register(w,v,v)}function I(w){let v=n.get(w).__ref;v!==void 0&&(g.delete(v),M.unregister(v))}function D(w){H(w.target)}function B(w){_(w.target)}function H(w){w.removeEventListener("dispose",D),I(w),q(w),w.isVideoTexture&&h.delete(w),w.isHTMLTexture&&f.delete(w)}function _(w){w.removeEventListener("dispose",B),I(w),te(w)}function V(){for(let w of g){let v=w.deref();v!==void 0&&(v.isRenderTarget===!0?_(v):H(v))}g.clear(),f.clear()}function q(w){let v=n.get(w);if(v.__webglInit===void 0)return;let O=w.source,ee=m.get(O);if(ee){let j=ee[v.__cacheKey];j.usedTimes--,j.usedTimes===0&&G(w),Object.keys(ee).length===0&&m.delete(O)}n.remove(w)}function G(w){let v=n.get(w);i.deleteTexture(v.__webglTexture);let O=w.source,ee=m.get(O);delete ee[v.__cacheKey],a.memory.textures--}function te(w){let v=n.get(w);v.__depthDisposeCallback&&v.__depthDisposeCallback();let O=w.depthTexture;if(O&&O.renderTarget===w&&H(O),w.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(v.__webglFramebuffer[j]))for(let se=0;se<v.__webglFramebuffer[j].length;se++)i.deleteFramebuffer(v.__webglFramebuffer[j][se]);else i.deleteFramebuffer(v.__webglFramebuffer[j]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[j])}else{if(Array.isArray(v.__webglFramebuffer))for(let j=0;j<v.__webglFramebuffer.length;j++)i.deleteFramebuffer(v.__webglFramebuffer[j]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let j=0;j<v.__webglColorRenderbuffer.length;j++)v.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[j]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let ee=w.textures;for(let j=0,se=ee.length;j<se;j++){let ce=n.get(ee[j]);ce.__webglTexture&&(i.deleteTexture(ce.__webglTexture),a.memory.textures--),n.remove(ee[j])}n.remove(w)}let X=0;function Q(){X=0}function $(){return X}function Se(w){X=w}function Le(){let w=X;return w>=s.maxTextures&&Ce("WebGLTextures: Trying to use "+(w+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,w}function J(w){let v=[];return v.push(w.wrapS),v.push(w.wrapT),v.push(w.wrapR||0),v.push(w.magFilter),v.push(w.minFilter),v.push(w.anisotropy),v.push(w.internalFormat),v.push(w.format),v.push(w.type),v.push(w.generateMipmaps),v.push(w.mipmapsAutoUpdate),v.push(w.premultiplyAlpha),v.push(w.flipY),v.push(w.unpackAlignment),v.push(w.colorSpace),v.join()}function pe(w,v){let O=n.get(w);if(w.isVideoTexture&&ft(w),w.isRenderTargetTexture===!1&&w.isExternalTexture!==!0&&w.version>0&&O.__version!==w.version){let ee=w.image;if(ee===null)Ce("WebGLRenderer: Texture marked for update but no image data found.");else if(ee.complete===!1)Ce("WebGLRenderer: Texture marked for update but image is incomplete");else{dt(O,w,v);return}}else w.isExternalTexture&&(O.__webglTexture=w.sourceTexture?w.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,O.__webglTexture,i.TEXTURE0+v)}function ve(w,v){let O=n.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&O.__version!==w.version){dt(O,w,v);return}else w.isExternalTexture&&(O.__webglTexture=w.sourceTexture?w.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,O.__webglTexture,i.TEXTURE0+v)}function Ee(w,v){let O=n.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&O.__version!==w.version){dt(O,w,v);return}t.bindTexture(i.TEXTURE_3D,O.__webglTexture,i.TEXTURE0+v)}function me(w,v){let O=n.get(w);if(w.version>0&&O.__version!==w.version){Ft(O,w,v);return}t.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+v)}let Ne={[Ar]:i.REPEAT,[fn]:i.CLAMP_TO_EDGE,[Cr]:i.MIRRORED_REPEAT},lt={[St]:i.NEAREST,[jc]:i.NEAREST_MIPMAP_NEAREST,[Cs]:i.NEAREST_MIPMAP_LINEAR,[Dt]:i.LINEAR,[ta]:i.LINEAR_MIPMAP_NEAREST,[Nn]:i.LINEAR_MIPMAP_LINEAR},Re={[th]:i.NEVER,[ll]:i.ALWAYS,[nh]:i.LESS,[al]:i.LEQUAL,[ih]:i.EQUAL,[ol]:i.GEQUAL,[sh]:i.GREATER,[rh]:i.NOTEQUAL};function Ye(w,v){if(v.type===on&&e.has("OES_texture_float_linear")===!1&&(v.magFilter===Dt||v.magFilter===ta||v.magFilter===Cs||v.magFilter===Nn||v.minFilter===Dt||v.minFilter===ta||v.minFilter===Cs||v.minFilter===Nn)&&Ce("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(w,i.TEXTURE_WRAP_S,Ne[v.wrapS]),i.texParameteri(w,i.TEXTURE_WRAP_T,Ne[v.wrapT]),(w===i.TEXTURE_3D||w===i.TEXTURE_2D_ARRAY)&&i.texParameteri(w,i.TEXTURE_WRAP_R,Ne[v.wrapR]),i.texParameteri(w,i.TEXTURE_MAG_FILTER,lt[v.magFilter]),i.texParameteri(w,i.TEXTURE_MIN_FILTER,lt[v.minFilter]),v.compareFunction&&(i.texParameteri(w,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(w,i.TEXTURE_COMPARE_FUNC,Re[v.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===St||v.minFilter!==Cs&&v.minFilter!==Nn||v.type===on&&e.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let O=e.get("EXT_texture_filter_anisotropic");i.texParameterf(w,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function Ke(w,v){let O=!1;w.__webglInit===void 0&&(w.__webglInit=!0,v.addEventListener("dispose",D),N(v));let ee=v.source,j=m.get(ee);j===void 0&&(j={},m.set(ee,j));let se=J(v);if(se!==w.__cacheKey){j[se]===void 0&&(j[se]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,O=!0),j[se].usedTimes++;let ce=j[w.__cacheKey];ce!==void 0&&(j[w.__cacheKey].usedTimes--,ce.usedTimes===0&&G(v)),w.__cacheKey=se,w.__webglTexture=j[se].texture}return O}function ze(w,v,O){return Math.floor(Math.floor(w/O)/v)}function bt(w,v,O,ee){let se=w.updateRanges;if(se.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,O,ee,v.data);else{se.sort((R,K)=>R.start-K.start);let ce=0;for(let R=1;R<se.length;R++){let K=se[ce],W=se[R],oe=K.start+K.count,ie=ze(W.start,v.width,4),re=ze(K.start,v.width,4);W.start<=oe+1&&ie===re&&ze(W.start+W.count-1,v.width,4)===ie?K.count=Math.max(K.count,W.start+W.count-K.start):(++ce,se[ce]=W)}se.length=ce+1;let Z=t.getParameter(i.UNPACK_ROW_LENGTH),Y=t.getParameter(i.UNPACK_SKIP_PIXELS),ae=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let R=0,K=se.length;R<K;R++){let W=se[R],oe=Math.floor(W.start/4),ie=Math.ceil(W.count/4),re=oe%v.width,Te=Math.floor(oe/v.width),Oe=ie,ne=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,Te),t.texSubImage2D(i.TEXTURE_2D,0,re,Te,Oe,ne,O,ee,v.data)}w.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Z),t.pixelStorei(i.UNPACK_SKIP_PIXELS,Y),t.pixelStorei(i.UNPACK_SKIP_ROWS,ae)}}function dt(w,v,O){let ee=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(ee=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(ee=i.TEXTURE_3D);let j=Ke(w,v),se=v.source;t.bindTexture(ee,w.__webglTexture,i.TEXTURE0+O);let ce=n.get(se);if(se.version!==ce.__version||j===!0){if(t.activeTexture(i.TEXTURE0+O),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let ne=Ve.getPrimaries(Ve.workingColorSpace),we=v.colorSpace===Fn?null:Ve.getPrimaries(v.colorSpace),Fe=v.colorSpace===Fn||ne===we?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Fe)}t.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let Y=S(v.image,!1,s.maxTextureSize);Y=Ae(v,Y);let ae=r.convert(v.format,v.colorSpace),R=r.convert(v.type),K=E(v.internalFormat,ae,R,v.normalized,v.colorSpace,v.isVideoTexture);Ye(ee,v);let W,oe=v.mipmaps,ie=v.isVideoTexture!==!0,re=ce.__version===void 0||j===!0,Te=se.dataReady,Oe=b(v,Y);if(v.isDepthTexture)K=x(v.format===Un,v.type),re&&(ie?t.texStorage2D(i.TEXTURE_2D,1,K,Y.width,Y.height):t.texImage2D(i.TEXTURE_2D,0,K,Y.width,Y.height,0,ae,R,null));else if(v.isDataTexture)if(oe.length>0){ie&&re&&t.texStorage2D(i.TEXTURE_2D,Oe,K,oe[0].width,oe[0].height);for(let ne=0,we=oe.length;ne<we;ne++)W=oe[ne],ie?Te&&t.texSubImage2D(i.TEXTURE_2D,ne,0,0,W.width,W.height,ae,R,W.data):t.texImage2D(i.TEXTURE_2D,ne,K,W.width,W.height,0,ae,R,W.data);v.generateMipmaps=!1}else ie?(re&&t.texStorage2D(i.TEXTURE_2D,Oe,K,Y.width,Y.height),Te&&bt(v,Y,ae,R)):t.texImage2D(i.TEXTURE_2D,0,K,Y.width,Y.height,0,ae,R,Y.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){ie&&re&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Oe,K,oe[0].width,oe[0].height,Y.depth);for(let ne=0,we=oe.length;ne<we;ne++)if(W=oe[ne],v.format!==cn)if(ae!==null)if(ie){if(Te)if(v.layerUpdates.size>0){let Fe=ml(W.width,W.height,v.format,v.type);for(let de of v.layerUpdates){let Je=W.data.subarray(de*Fe/W.data.BYTES_PER_ELEMENT,(de+1)*Fe/W.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ne,0,0,de,W.width,W.height,1,ae,Je)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ne,0,0,0,W.width,W.height,Y.depth,ae,W.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ne,K,W.width,W.height,Y.depth,0,W.data,0,0);else Ce("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ie?Te&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ne,0,0,0,W.width,W.height,Y.depth,ae,R,W.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ne,K,W.width,W.height,Y.depth,0,ae,R,W.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{ie&&re&&t.texStorage2D(i.TEXTURE_2D,Oe,K,oe[0].width,oe[0].height);for(let ne=0,we=oe.length;ne<we;ne++)W=oe[ne],v.format!==cn?ae!==null?ie?Te&&t.compressedTexSubImage2D(i.TEXTURE_2D,ne,0,0,W.width,W.height,ae,W.data):t.compressedTexImage2D(i.TEXTURE_2D,ne,K,W.width,W.height,0,W.data):Ce("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ie?Te&&t.texSubImage2D(i.TEXTURE_2D,ne,0,0,W.width,W.height,ae,R,W.data):t.texImage2D(i.TEXTURE_2D,ne,K,W.width,W.height,0,ae,R,W.data)}else if(v.isDataArrayTexture)if(ie){if(re&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Oe,K,Y.width,Y.height,Y.depth),Te)if(v.layerUpdates.size>0){let ne=ml(Y.width,Y.height,v.format,v.type);for(let we of v.layerUpdates){let Fe=Y.data.subarray(we*ne/Y.data.BYTES_PER_ELEMENT,(we+1)*ne/Y.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,we,Y.width,Y.height,1,ae,R,Fe)}v.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,ae,R,Y.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,K,Y.width,Y.height,Y.depth,0,ae,R,Y.data);else if(v.isData3DTexture)ie?(re&&t.texStorage3D(i.TEXTURE_3D,Oe,K,Y.width,Y.height,Y.depth),Te&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,ae,R,Y.data)):t.texImage3D(i.TEXTURE_3D,0,K,Y.width,Y.height,Y.depth,0,ae,R,Y.data);else if(v.isFramebufferTexture){if(re)if(ie)t.texStorage2D(i.TEXTURE_2D,Oe,K,Y.width,Y.height);else{let ne=Y.width,we=Y.height;for(let Fe=0;Fe<Oe;Fe++)t.texImage2D(i.TEXTURE_2D,Fe,K,ne,we,0,ae,R,null),ne>>=1,we>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){let ne=i.canvas;if(ne.hasAttribute("layoutsubtree")||ne.setAttribute("layoutsubtree","true"),Y.parentNode!==ne){ne.appendChild(Y),f.add(v),ne.onpaint=we=>{let Fe=we.changedElements;for(let de of f)Fe.includes(de.image)&&(de.needsUpdate=!0)},ne.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Y);else{let Fe=i.RGBA,de=i.RGBA,Je=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Fe,de,Je,Y)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(oe.length>0){if(ie&&re){let ne=Ie(oe[0]);t.texStorage2D(i.TEXTURE_2D,Oe,K,ne.width,ne.height)}for(let ne=0,we=oe.length;ne<we;ne++)W=oe[ne],ie?Te&&t.texSubImage2D(i.TEXTURE_2D,ne,0,0,ae,R,W):t.texImage2D(i.TEXTURE_2D,ne,K,ae,R,W);v.generateMipmaps=!1}else if(ie){if(re){let ne=Ie(Y);t.texStorage2D(i.TEXTURE_2D,Oe,K,ne.width,ne.height)}Te&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ae,R,Y)}else t.texImage2D(i.TEXTURE_2D,0,K,ae,R,Y);A(v)&&v.mipmapsAutoUpdate===!0&&T(ee),ce.__version=se.version,v.onUpdate&&v.onUpdate(v)}w.__version=v.version}function Ft(w,v,O){if(v.image.length!==6)return;let ee=Ke(w,v),j=v.source;t.bindTexture(i.TEXTURE_CUBE_MAP,w.__webglTexture,i.TEXTURE0+O);let se=n.get(j);if(j.version!==se.__version||ee===!0){t.activeTexture(i.TEXTURE0+O);let ce=Ve.getPrimaries(Ve.workingColorSpace),Z=v.colorSpace===Fn?null:Ve.getPrimaries(v.colorSpace),Y=v.colorSpace===Fn||ce===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);let ae=v.isCompressedTexture||v.image[0].isCompressedTexture,R=v.image[0]&&v.image[0].isDataTexture,K=[];for(let de=0;de<6;de++)!ae&&!R?K[de]=S(v.image[de],!0,s.maxCubemapSize):K[de]=R?v.image[de].image:v.image[de],K[de]=Ae(v,K[de]);let W=K[0],oe=r.convert(v.format,v.colorSpace),ie=r.convert(v.type),re=E(v.internalFormat,oe,ie,v.normalized,v.colorSpace),Te=v.isVideoTexture!==!0,Oe=se.__version===void 0||ee===!0,ne=j.dataReady,we=b(v,W);Ye(i.TEXTURE_CUBE_MAP,v);let Fe;if(v.isDepthTexture){if(re=x(v.format===Un,v.type),Oe)if(Te)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,re,W.width,W.height);else for(let de=0;de<6;de++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,0,re,W.width,W.height,0,oe,ie,null)}else if(ae){Te&&Oe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,we,re,W.width,W.height);for(let de=0;de<6;de++){Fe=K[de].mipmaps;for(let Je=0;Je<Fe.length;Je++){let vt=Fe[Je];v.format!==cn?oe!==null?Te?ne&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je,0,0,vt.width,vt.height,oe,vt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je,re,vt.width,vt.height,0,vt.data):Ce("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Te?ne&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je,0,0,vt.width,vt.height,oe,ie,vt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je,re,vt.width,vt.height,0,oe,ie,vt.data)}}}else{if(Fe=v.mipmaps,Te&&Oe){Fe.length>0&&we++;let de=Ie(K[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,we,re,de.width,de.height)}for(let de=0;de<6;de++)if(R){Te?ne&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,0,0,0,K[de].width,K[de].height,oe,ie,K[de].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,0,re,K[de].width,K[de].height,0,oe,ie,K[de].data);for(let Je=0;Je<Fe.length;Je++){let Bn=Fe[Je].image[de].image;Te?ne&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je+1,0,0,Bn.width,Bn.height,oe,ie,Bn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je+1,re,Bn.width,Bn.height,0,oe,ie,Bn.data)}}else{Te?ne&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,0,0,0,oe,ie,K[de]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,0,re,oe,ie,K[de]);for(let Je=0;Je<Fe.length;Je++){let vt=Fe[Je];Te?ne&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je+1,0,0,oe,ie,vt.image[de]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+de,Je+1,re,oe,ie,vt.image[de])}}}A(v)&&v.mipmapsAutoUpdate===!0&&T(i.TEXTURE_CUBE_MAP),se.__version=j.version,v.onUpdate&&v.onUpdate(v)}w.__version=v.version}function rt(w,v,O,ee,j,se){let ce=r.convert(O.format,O.colorSpace),Z=r.convert(O.type),Y=E(O.internalFormat,ce,Z,O.normalized,O.colorSpace),ae=n.get(v),R=n.get(O);if(R.__renderTarget=v,!ae.__hasExternalTextures){let K=Math.max(1,v.width>>se),W=Math.max(1,v.height>>se);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?t.texImage3D(j,se,Y,K,W,v.depth,0,ce,Z,null):t.texImage2D(j,se,Y,K,W,0,ce,Z,null)}t.bindFramebuffer(i.FRAMEBUFFER,w),ue(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ee,j,R.__webglTexture,0,it(v)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ee,j,R.__webglTexture,se),t.bindFramebuffer(i.FRAMEBUFFER,null)}function un(w,v,O){if(i.bindRenderbuffer(i.RENDERBUFFER,w),v.depthBuffer){let ee=v.depthTexture,j=ee&&ee.isDepthTexture?ee.type:null,se=x(v.stencilBuffer,j),ce=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ue(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(v),se,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,it(v),se,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,se,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ce,i.RENDERBUFFER,w)}else{let ee=v.textures;for(let j=0;j<ee.length;j++){let se=ee[j],ce=r.convert(se.format,se.colorSpace),Z=r.convert(se.type),Y=E(se.internalFormat,ce,Z,se.normalized,se.colorSpace);ue(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(v),Y,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,it(v),Y,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Y,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(w,v,O){let ee=v.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,w),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(v.depthTexture);j.__renderTarget=v;let se=ee?v.depthTexture.image[0]:v.depthTexture.image;(!j.__webglTexture||se.width!==v.width||se.height!==v.height)&&(se.width=v.width,se.height=v.height,v.depthTexture.needsUpdate=!0),ee?me(v.depthTexture,0):pe(v.depthTexture,0);let ce=j.__webglTexture,Z=it(v),Y=ee?i.TEXTURE_CUBE_MAP_POSITIVE_X+O:i.TEXTURE_2D,ae=v.depthTexture.format===Un?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===_n)ue(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ae,Y,ce,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ae,Y,ce,0);else if(v.depthTexture.format===Un)ue(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ae,Y,ce,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ae,Y,ce,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function qt(w){let v=n.get(w),O=w.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==w.depthTexture){let ee=w.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),ee){let j=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,ee.removeEventListener("dispose",j)};ee.addEventListener("dispose",j),v.__depthDisposeCallback=j}v.__boundDepthTexture=ee}if(w.depthTexture&&!v.__autoAllocateDepthBuffer)if(O)for(let ee=0;ee<6;ee++)xt(v.__webglFramebuffer[ee],w,ee);else w.texture.mipmaps.length>0?xt(v.__webglFramebuffer[0],w,0):xt(v.__webglFramebuffer,w,0);else if(O){v.__webglDepthbuffer=[];for(let ee=0;ee<6;ee++)if(t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[ee]),v.__webglDepthbuffer[ee]===void 0)v.__webglDepthbuffer[ee]=i.createRenderbuffer(),un(v.__webglDepthbuffer[ee],w,!1);else{let j=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,se=v.__webglDepthbuffer[ee];i.bindRenderbuffer(i.RENDERBUFFER,se),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,se)}}else if(w.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),un(v.__webglDepthbuffer,w,!1);else{let j=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,se=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,se),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,se)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Zt(w,v,O){let ee=n.get(w);v!==void 0&&rt(ee.__webglFramebuffer,w,w.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),O!==void 0&&qt(w)}function Yt(w){let v=w.texture,O=n.get(w),ee=n.get(v);w.addEventListener("dispose",B),N(w);let j=w.textures,se=w.isWebGLCubeRenderTarget===!0,ce=j.length>1;if(ce||(ee.__webglTexture===void 0&&(ee.__webglTexture=i.createTexture()),ee.__version=v.version,a.memory.textures++),se){O.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0){O.__webglFramebuffer[Z]=[];for(let Y=0;Y<v.mipmaps.length;Y++)O.__webglFramebuffer[Z][Y]=i.createFramebuffer()}else O.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(v.mipmaps.length>0){O.__webglFramebuffer=[];for(let Z=0;Z<v.mipmaps.length;Z++)O.__webglFramebuffer[Z]=i.createFramebuffer()}else O.__webglFramebuffer=i.createFramebuffer();if(ce)for(let Z=0,Y=j.length;Z<Y;Z++){let ae=n.get(j[Z]);ae.__webglTexture===void 0&&(ae.__webglTexture=i.createTexture(),a.memory.textures++)}if(w.samples>0&&ue(w)===!1){O.__webglMultisampledFramebuffer=i.createFramebuffer(),O.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let Z=0;Z<j.length;Z++){let Y=j[Z];O.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,O.__webglColorRenderbuffer[Z]);let ae=r.convert(Y.format,Y.colorSpace),R=r.convert(Y.type),K=E(Y.internalFormat,ae,R,Y.normalized,Y.colorSpace,w.isXRRenderTarget===!0),W=it(w);i.renderbufferStorageMultisample(i.RENDERBUFFER,W,K,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,O.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),w.depthBuffer&&(O.__webglDepthRenderbuffer=i.createRenderbuffer(),un(O.__webglDepthRenderbuffer,w,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(se){t.bindTexture(i.TEXTURE_CUBE_MAP,ee.__webglTexture),Ye(i.TEXTURE_CUBE_MAP,v);for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)rt(O.__webglFramebuffer[Z][Y],w,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,Y);else rt(O.__webglFramebuffer[Z],w,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);A(v)?T(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}else if(ce){for(let Z=0,Y=j.length;Z<Y;Z++){let ae=j[Z],R=n.get(ae),K=i.TEXTURE_2D;(w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&(K=w.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(K,R.__webglTexture),Ye(K,ae),rt(O.__webglFramebuffer,w,ae,i.COLOR_ATTACHMENT0+Z,K,0),A(ae)&&T(K)}t.unbindTexture()}else{let Z=i.TEXTURE_2D;if((w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&(Z=w.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Z,ee.__webglTexture),Ye(Z,v),v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)rt(O.__webglFramebuffer[Y],w,v,i.COLOR_ATTACHMENT0,Z,Y);else rt(O.__webglFramebuffer,w,v,i.COLOR_ATTACHMENT0,Z,0);A(v)?T(Z):v.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}w.depthBuffer&&qt(w)}function L(w){let v=w.textures;for(let O=0,ee=v.length;O<ee;O++){let j=v[O];if(A(j)&&j.mipmapsAutoUpdate===!0){let se=C(w),ce=n.get(j).__webglTexture;t.bindTexture(se,ce),T(se),t.unbindTexture()}}}let Jt=[];function nt(w){if(w.samples>0){if(ue(w)===!1){let v=w.textures,O=w.width,ee=w.height,j=i.COLOR_BUFFER_BIT,se=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ce=n.get(w),Z=v.length>1;if(Z)for(let ae=0;ae<v.length;ae++)t.bindFramebuffer(i.FRAMEBUFFER,ce.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ce.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ce.__webglMultisampledFramebuffer),w.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ce.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ce.__webglFramebuffer);for(let ae=0;ae<v.length;ae++){if(w.resolveDepthBuffer&&(w.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),w.stencilBuffer&&w.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ce.__webglColorRenderbuffer[ae]);let R=n.get(v[ae]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,R,0)}i.blitFramebuffer(0,0,O,ee,0,0,O,ee,j,i.NEAREST),c===!0&&(Jt.length=0,Jt.push(i.COLOR_ATTACHMENT0+ae),w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&Jt.push(se),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Jt))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let ae=0;ae<v.length;ae++){t.bindFramebuffer(i.FRAMEBUFFER,ce.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,ce.__webglColorRenderbuffer[ae]);let R=n.get(v[ae]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ce.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.TEXTURE_2D,R,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ce.__webglMultisampledFramebuffer)}else if(w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&c){let v=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function it(w){return Math.min(s.maxSamples,w.samples)}function ue(w){let v=n.get(w);return w.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function ft(w){let v=a.render.frame;h.get(w)!==v&&(h.set(w,v),w.update())}function Ae(w,v){let O=w.colorSpace,ee=w.format,j=w.type;return w.isCompressedTexture===!0||w.isVideoTexture===!0||O!==is&&O!==Fn&&(Ve.getTransfer(O)===Ze?(ee!==cn||j!==Bt)&&Ce("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):_e("WebGLTextures: Unsupported texture color space:",O)),v}function Ie(w){return typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement?(l.width=w.naturalWidth||w.width,l.height=w.naturalHeight||w.height):typeof VideoFrame<"u"&&w instanceof VideoFrame?(l.width=w.displayWidth,l.height=w.displayHeight):(l.width=w.width,l.height=w.height),l}this.allocateTextureUnit=Le,this.resetTextureUnits=Q,this.getTextureUnits=$,this.setTextureUnits=Se,this.setTexture2D=pe,this.setTexture2DArray=ve,this.setTexture3D=Ee,this.setTextureCube=me,this.rebindTextures=Zt,this.setupRenderTarget=Yt,this.updateRenderTargetMipmap=L,this.updateMultisampleRenderTarget=nt,this.setupDepthRenderbuffer=qt,this.setupFrameBufferTexture=rt,this.useMultisampledRTT=ue,this.dispose=V}function Gg(i,e){function t(n,s=Fn){let r,a=Ve.getTransfer(s);if(n===Bt)return i.UNSIGNED_BYTE;if(n===ia)return i.UNSIGNED_SHORT_4_4_4_4;if(n===sa)return i.UNSIGNED_SHORT_5_5_5_1;if(n===tl)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nl)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$o)return i.BYTE;if(n===el)return i.SHORT;if(n===Wi)return i.UNSIGNED_SHORT;if(n===na)return i.INT;if(n===an)return i.UNSIGNED_INT;if(n===on)return i.FLOAT;if(n===ln)return i.HALF_FLOAT;if(n===il)return i.ALPHA;if(n===sl)return i.RGB;if(n===cn)return i.RGBA;if(n===_n)return i.DEPTH_COMPONENT;if(n===Un)return i.DEPTH_STENCIL;if(n===rl)return i.RED;if(n===ra)return i.RED_INTEGER;if(n===$n)return i.RG;if(n===aa)return i.RG_INTEGER;if(n===oa)return i.RGBA_INTEGER;if(n===Rs||n===_s||n===Ps||n===Is)if(a===Ze)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Rs)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Rs)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===la||n===ca||n===ha||n===ua)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===la)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ca)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ha)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ua)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===da||n===fa||n===pa||n===ma||n===ga||n===Ls||n===xa)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===da||n===fa)return a===Ze?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===pa)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ma)return r.COMPRESSED_R11_EAC;if(n===ga)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ls)return r.COMPRESSED_RG11_EAC;if(n===xa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===va||n===ya||n===Ma||n===Sa||n===ba||n===Ta||n===wa||n===Ea||n===Aa||n===Ca||n===Ra||n===_a||n===Pa||n===Ia)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===va)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ya)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ma)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Sa)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ba)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ta)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===wa)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ea)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Aa)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ca)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ra)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_a)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Pa)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ia)return a===Ze?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===La||n===Da||n===Na)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===La)return a===Ze?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Da)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Na)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ua||n===Fa||n===Ds||n===Oa)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ua)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Fa)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ds)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oa)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===pi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var Vg=`
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

}`,wl=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ps(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new gn({vertexShader:Vg,fragmentShader:Hg,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new pt(new hi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},El=class extends mn{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",c=1,l=null,h=null,f=null,d=null,m=null,g=null,M=typeof XRWebGLBinding<"u",p=new wl,u={},S=t.getContextAttributes(),A=null,T=null,C=[],E=[],x=new He,b=null,N=null,I=new Lt;I.viewport=new st;let D=new Lt;D.viewport=new st;let B=[I,D],H=new jr,_=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let pe=C[J];return pe===void 0&&(pe=new Ui,C[J]=pe),pe.getTargetRaySpace()},this.getControllerGrip=function(J){let pe=C[J];return pe===void 0&&(pe=new Ui,C[J]=pe),pe.getGripSpace()},this.getHand=function(J){let pe=C[J];return pe===void 0&&(pe=new Ui,C[J]=pe),pe.getHandSpace()};function q(J){let pe=E.indexOf(J.inputSource);if(pe===-1)return;let ve=C[pe];ve!==void 0&&(ve.update(J.inputSource,J.frame,l||a),ve.dispatchEvent({type:J.type,data:J.inputSource}))}function G(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",te);for(let J=0;J<C.length;J++){let pe=E[J];pe!==null&&(E[J]=null,C[J].disconnect(pe))}_=null,V=null,p.reset();for(let J in u)delete u[J];if(e.setRenderTarget(A),m=null,d=null,f=null,s=null,T=null,Le.stop(),n.isPresenting=!1,e.setPixelRatio(b),e.setSize(x.width,x.height,!1),N!==null){let J=N.camera;J.fov=N.fov,J.zoom=N.zoom,J.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Ce("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,n.isPresenting===!0&&Ce("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||a},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",G),s.addEventListener("inputsourceschange",te),S.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(x),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ee=null,me=null;S.depth&&(me=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=S.stencil?Un:_n,Ee=S.stencil?pi:an);let Ne={colorFormat:t.RGBA8,depthFormat:me,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(Ne),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),T=new Ht(d.textureWidth,d.textureHeight,{format:cn,type:Bt,depthTexture:new Ln(d.textureWidth,d.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ve={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),T=new Ht(m.framebufferWidth,m.framebufferHeight,{format:cn,type:Bt,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}T.isXRRenderTarget=!0,this.setFoveation(c),l=null,a=await s.requestReferenceSpace(o),Le.setContext(s),Le.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function te(J){for(let pe=0;pe<J.removed.length;pe++){let ve=J.removed[pe],Ee=E.indexOf(ve);Ee>=0&&(E[Ee]=null,C[Ee].disconnect(ve))}for(let pe=0;pe<J.added.length;pe++){let ve=J.added[pe],Ee=E.indexOf(ve);if(Ee===-1){for(let Ne=0;Ne<C.length;Ne++)if(Ne>=E.length){E.push(ve),Ee=Ne;break}else if(E[Ne]===null){E[Ne]=ve,Ee=Ne;break}if(Ee===-1)break}let me=C[Ee];me&&me.connect(ve)}}function X(J,pe){pe===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(pe.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let pe=J.near,ve=J.far;p.texture!==null&&(p.depthNear>0&&(pe=p.depthNear),p.depthFar>0&&(ve=p.depthFar)),H.near=D.near=I.near=pe,H.far=D.far=I.far=ve,(_!==H.near||V!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),_=H.near,V=H.far),H.layers.mask=J.layers.mask|6,I.layers.mask=H.layers.mask&-5,D.layers.mask=H.layers.mask&-3;let Ee=J.parent,me=H.cameras;X(H,Ee);for(let Ne=0;Ne<me.length;Ne++)X(me[Ne],Ee);H.projectionMatrix.copy(I.projectionMatrix),H.projectionMatrixInverse.copy(I.projectionMatrixInverse),N===null&&J.isPerspectiveCamera&&(N={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,H,Ee)};function Q(J,pe,ve){ve===null?J.matrix.copy(pe.matrixWorld):(J.matrix.copy(ve.matrixWorld),J.matrix.invert(),J.matrix.multiply(pe.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(pe.projectionMatrix),J.projectionMatrixInverse.copy(pe.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=_r*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&m===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(J){return u[J]};let $=null;function Se(J,pe){if(h=pe.getViewerPose(l||a),g=pe,h!==null){let ve=h.views;m!==null&&(e.setRenderTargetFramebuffer(T,m.framebuffer),e.setRenderTarget(T));let Ee=!1;ve.length!==H.cameras.length&&(H.cameras.length=0,Ee=!0);for(let Re=0;Re<ve.length;Re++){let Ye=ve[Re],Ke=null;if(m!==null)Ke=m.getViewport(Ye);else{let bt=f.getViewSubImage(d,Ye);Ke=bt.viewport,Re===0&&(e.setRenderTargetTextures(T,bt.colorTexture,bt.depthStencilTexture),e.setRenderTarget(T))}let ze=B[Re];ze===void 0&&(ze=new Lt,ze.layers.enable(Re),ze.viewport=new st,B[Re]=ze),ze.matrix.fromArray(Ye.transform.matrix),ze.matrix.decompose(ze.position,ze.quaternion,ze.scale),ze.projectionMatrix.fromArray(Ye.projectionMatrix),ze.projectionMatrixInverse.copy(ze.projectionMatrix).invert(),ze.viewport.set(Ke.x,Ke.y,Ke.width,Ke.height),Re===0&&(H.matrix.copy(ze.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Ee===!0&&H.cameras.push(ze)}let me=s.enabledFeatures;if(me&&me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){f=n.getBinding();let Re=f.getDepthInformation(ve[0]);Re&&Re.isValid&&Re.texture&&p.init(Re,s.renderState)}if(me&&me.includes("camera-access")&&M){e.state.unbindTexture(),f=n.getBinding();for(let Re=0;Re<ve.length;Re++){let Ye=ve[Re].camera;if(Ye){let Ke=u[Ye];Ke||(Ke=new ps,u[Ye]=Ke);let ze=f.getCameraImage(Ye);Ke.sourceTexture=ze}}}}for(let ve=0;ve<C.length;ve++){let Ee=E[ve],me=C[ve];Ee!==null&&me!==void 0&&me.update(Ee,pe,l||a)}$&&$(J,pe),pe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pe}),g=null}let Le=new Oh;Le.setAnimationLoop(Se),this.setAnimationLoop=function(J){$=J},this.dispose=function(){}}},Wg=new Qe,Zh=new Pe;Zh.set(-1,0,0,0,1,0,0,0,1);function Xg(i,e){function t(p,u){p.matrixAutoUpdate===!0&&p.updateMatrix(),u.value.copy(p.matrix)}function n(p,u){u.color.getRGB(p.fogColor.value,dl(i)),u.isFog?(p.fogNear.value=u.near,p.fogFar.value=u.far):u.isFogExp2&&(p.fogDensity.value=u.density)}function s(p,u,S,A,T){u.isNodeMaterial?u.uniformsNeedUpdate=!1:u.isMeshBasicMaterial?r(p,u):u.isMeshLambertMaterial?(r(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshToonMaterial?(r(p,u),f(p,u)):u.isMeshPhongMaterial?(r(p,u),h(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshStandardMaterial?(r(p,u),d(p,u),u.isMeshPhysicalMaterial&&m(p,u,T)):u.isMeshMatcapMaterial?(r(p,u),g(p,u)):u.isMeshDepthMaterial?r(p,u):u.isMeshDistanceMaterial?(r(p,u),M(p,u)):u.isMeshNormalMaterial?r(p,u):u.isLineBasicMaterial?(a(p,u),u.isLineDashedMaterial&&o(p,u)):u.isPointsMaterial?c(p,u,S,A):u.isSpriteMaterial?l(p,u):u.isShadowMaterial?(p.color.value.copy(u.color),p.opacity.value=u.opacity):u.isShaderMaterial&&(u.uniformsNeedUpdate=!1)}function r(p,u){p.opacity.value=u.opacity,u.color&&p.diffuse.value.copy(u.color),u.emissive&&p.emissive.value.copy(u.emissive).multiplyScalar(u.emissiveIntensity),u.map&&(p.map.value=u.map,t(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,t(u.alphaMap,p.alphaMapTransform)),u.bumpMap&&(p.bumpMap.value=u.bumpMap,t(u.bumpMap,p.bumpMapTransform),p.bumpScale.value=u.bumpScale,u.side===Nt&&(p.bumpScale.value*=-1)),u.normalMap&&(p.normalMap.value=u.normalMap,t(u.normalMap,p.normalMapTransform),p.normalScale.value.copy(u.normalScale),u.side===Nt&&p.normalScale.value.negate()),u.displacementMap&&(p.displacementMap.value=u.displacementMap,t(u.displacementMap,p.displacementMapTransform),p.displacementScale.value=u.displacementScale,p.displacementBias.value=u.displacementBias),u.emissiveMap&&(p.emissiveMap.value=u.emissiveMap,t(u.emissiveMap,p.emissiveMapTransform)),u.specularMap&&(p.specularMap.value=u.specularMap,t(u.specularMap,p.specularMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest);let S=e.get(u),A=S.envMap,T=S.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(Wg.makeRotationFromEuler(T)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Zh),p.reflectivity.value=u.reflectivity,p.ior.value=u.ior,p.refractionRatio.value=u.refractionRatio),u.lightMap&&(p.lightMap.value=u.lightMap,p.lightMapIntensity.value=u.lightMapIntensity,t(u.lightMap,p.lightMapTransform)),u.aoMap&&(p.aoMap.value=u.aoMap,p.aoMapIntensity.value=u.aoMapIntensity,t(u.aoMap,p.aoMapTransform))}function a(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,u.map&&(p.map.value=u.map,t(u.map,p.mapTransform))}function o(p,u){p.dashSize.value=u.dashSize,p.totalSize.value=u.dashSize+u.gapSize,p.scale.value=u.scale}function c(p,u,S,A){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.size.value=u.size*S,p.scale.value=A*.5,u.map&&(p.map.value=u.map,t(u.map,p.uvTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,t(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function l(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.rotation.value=u.rotation,u.map&&(p.map.value=u.map,t(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,t(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function h(p,u){p.specular.value.copy(u.specular),p.shininess.value=Math.max(u.shininess,1e-4)}function f(p,u){u.gradientMap&&(p.gradientMap.value=u.gradientMap)}function d(p,u){p.metalness.value=u.metalness,u.metalnessMap&&(p.metalnessMap.value=u.metalnessMap,t(u.metalnessMap,p.metalnessMapTransform)),p.roughness.value=u.roughness,u.roughnessMap&&(p.roughnessMap.value=u.roughnessMap,t(u.roughnessMap,p.roughnessMapTransform)),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)}function m(p,u,S){p.ior.value=u.ior,u.diffuseRoughness>0&&(p.diffuseRoughness.value=u.diffuseRoughness,u.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=u.diffuseRoughnessMap,t(u.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),u.sheen>0&&(p.sheenColor.value.copy(u.sheenColor).multiplyScalar(u.sheen),p.sheenRoughness.value=u.sheenRoughness,u.sheenColorMap&&(p.sheenColorMap.value=u.sheenColorMap,t(u.sheenColorMap,p.sheenColorMapTransform)),u.sheenRoughnessMap&&(p.sheenRoughnessMap.value=u.sheenRoughnessMap,t(u.sheenRoughnessMap,p.sheenRoughnessMapTransform))),u.clearcoat>0&&(p.clearcoat.value=u.clearcoat,p.clearcoatRoughness.value=u.clearcoatRoughness,u.clearcoatMap&&(p.clearcoatMap.value=u.clearcoatMap,t(u.clearcoatMap,p.clearcoatMapTransform)),u.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=u.clearcoatRoughnessMap,t(u.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),u.clearcoatNormalMap&&(p.clearcoatNormalMap.value=u.clearcoatNormalMap,t(u.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(u.clearcoatNormalScale),u.side===Nt&&p.clearcoatNormalScale.value.negate())),u.dispersion>0&&(p.dispersion.value=u.dispersion),u.retroreflectivity>0&&(p.retroreflectivity.value=u.retroreflectivity),u.iridescence>0&&(p.iridescence.value=u.iridescence,p.iridescenceIOR.value=u.iridescenceIOR,p.iridescenceThicknessMinimum.value=u.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=u.iridescenceThicknessMaximum,u.iridescenceMap&&(p.iridescenceMap.value=u.iridescenceMap,t(u.iridescenceMap,p.iridescenceMapTransform)),u.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=u.iridescenceThicknessMap,t(u.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),u.transmission>0&&(p.transmission.value=u.transmission,p.transmissionSamplerMap.value=S.texture,p.transmissionSamplerSize.value.set(S.width,S.height),u.transmissionMap&&(p.transmissionMap.value=u.transmissionMap,t(u.transmissionMap,p.transmissionMapTransform)),p.thickness.value=u.thickness,u.thicknessMap&&(p.thicknessMap.value=u.thicknessMap,t(u.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=u.attenuationDistance,p.attenuationColor.value.copy(u.attenuationColor)),u.anisotropy>0&&(p.anisotropyVector.value.set(u.anisotropy*Math.cos(u.anisotropyRotation),u.anisotropy*Math.sin(u.anisotropyRotation)),u.anisotropyMap&&(p.anisotropyMap.value=u.anisotropyMap,t(u.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=u.specularIntensity,p.specularColor.value.copy(u.specularColor),u.specularColorMap&&(p.specularColorMap.value=u.specularColorMap,t(u.specularColorMap,p.specularColorMapTransform)),u.specularIntensityMap&&(p.specularIntensityMap.value=u.specularIntensityMap,t(u.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,u){u.matcap&&(p.matcap.value=u.matcap)}function M(p,u){let S=e.get(u).light;p.referencePosition.value.setFromMatrixPosition(S.matrixWorld),p.nearDistance.value=S.shadow.camera.near,p.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function qg(i,e,t,n){let s={},r={};function a(S,A){let T=A.program;n.uniformBlockBinding(S,T,s[S.id])}function o(S,A){let T=s[S.id];T===void 0&&(g(S),T=c(S),s[S.id]=T,S.addEventListener("dispose",p));let C=A.program;n.updateUBOMapping(S,C);let E=e.render.frame;r[S.id]!==E&&(l(S),r[S.id]=E)}function c(S){let A=i.createBuffer(),T=S.__size,C=S.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,T,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(S){let A=s[S.id],T=S.uniforms,C=S.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=T.length;E<x;E++){let b=T[E];if(Array.isArray(b))for(let N=0,I=b.length;N<I;N++)h(b[N],E,N,C);else h(b,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(S,A,T,C){if(d(S,A,T,C)===!0){let E=S.__offset,x=S.value;if(Array.isArray(x)){let b=0;for(let N=0;N<x.length;N++){let I=x[N],D=M(I,!0);f(I,S.__data,b),b+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,S.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,S.__data)}}function f(S,A,T){typeof S=="number"||typeof S=="boolean"?A[T]=S:S.isMatrix3?(A[T]=S.elements[0],A[T+1]=S.elements[1],A[T+2]=S.elements[2],A[T+3]=0,A[T+4]=S.elements[3],A[T+5]=S.elements[4],A[T+6]=S.elements[5],A[T+7]=0,A[T+8]=S.elements[6],A[T+9]=S.elements[7],A[T+10]=S.elements[8],A[T+11]=0):ArrayBuffer.isView(S)?A.set(S.subarray(0,A.length-T),T):S.toArray(A,T)}function d(S,A,T,C){let E=S.value,x=A+"_"+T;if(Array.isArray(E)){C[x]===void 0&&(C[x]=[]);let b=C[x],N=!1;for(let I=0;I<E.length;I++)m(E[I],b,I)===!0&&(N=!0);return N}return m(E,C,x)}function m(S,A,T){if(A[T]===void 0)return typeof S=="number"||typeof S=="boolean"?A[T]=S:ArrayBuffer.isView(S)?A[T]=S.slice():A[T]=S.clone(),!0;{let C=A[T];if(typeof S=="number"||typeof S=="boolean"){if(C!==S)return A[T]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(C.equals(S)===!1)return C.copy(S),!0}}return!1}function g(S){let A=S.uniforms,T=0,C=16;for(let x=0,b=A.length;x<b;x++){let N=Array.isArray(A[x])?A[x]:[A[x]];for(let I=0,D=N.length;I<D;I++){let B=N[I],H=Array.isArray(B.value)?B.value:[B.value],_=Array.isArray(A[x])||Array.isArray(B.value),V=T;for(let G=0,te=H.length;G<te;G++){let X=H[G],Q=M(X,_),$=T%C,Se=$%Q.boundary,Le=$+Se;T+=Se,Le!==0&&C-Le<Q.storage&&(T+=C-Le),G===0&&(V=T),T+=Q.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((T-V)/Float32Array.BYTES_PER_ELEMENT),B.__offset=V}}let E=T%C;return E>0&&(T+=C-E),S.__size=T,S.__cache={},this}function M(S,A){let T={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(T.boundary=4,T.storage=4):S.isVector2?(T.boundary=8,T.storage=8):S.isVector3||S.isColor?(T.boundary=16,T.storage=12):S.isVector4?(T.boundary=16,T.storage=16):S.isMatrix3?(T.boundary=16,T.storage=48):S.isMatrix4?(T.boundary=16,T.storage=64):S.isTexture?Ce("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(T.boundary=16,T.storage=S.byteLength):Ce("WebGLRenderer: Unsupported uniform value type.",S),A===!0&&(T.boundary=16,T.storage=Math.ceil(T.storage/16)*16),T}function p(S){let A=S.target;A.removeEventListener("dispose",p),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function u(){for(let S in s)i.deleteBuffer(s[S]);s={},r={}}return{bind:a,update:o,dispose:u}}var Zg=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yn=null;function Yg(){return yn===null&&(yn=new Dr(Zg,16,16,$n,ln),yn.name="DFG_LUT",yn.minFilter=Dt,yn.magFilter=Dt,yn.wrapS=fn,yn.wrapT=fn,yn.generateMipmaps=!1,yn.needsUpdate=!0),yn}var Va=class{constructor(e={}){let{canvas:t=oh(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:m=Bt}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let M=m,p=new Set([oa,aa,ra]),u=new Set([Bt,an,Wi,pi,ia,sa]),S=new Uint32Array(4),A=new Int32Array(4),T={textures:[],min:[],max:[],resolution:[]},C=null,E=null,x=[],b=[],N=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,B=null,H=null,_=null,V=null;this._outputColorSpace=Gt;let q=0,G=0,te=null,X=-1,Q=null,$=new st,Se=new st,Le=null,J=new Ue(0),pe=0,ve=t.width,Ee=t.height,me=1,Ne=null,lt=null,Re=new st(0,0,ve,Ee),Ye=new st(0,0,ve,Ee),Ke=!1,ze=new Zn,bt=new Nr,dt=!1,Ft=!1,rt=new Qe,un=new U,xt=new st,qt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Zt=!1;function Yt(){return te===null?me:1}let L=n;function Jt(y,P){return t.getContext(y,P)}let nt,it,ue,ft,Ae,Ie,w,v,O,ee,j,se,ce,Z,Y,ae,R,K,W,oe,ie,re,Te;try{let y={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",we,!1),t.addEventListener("webglcontextrestored",Fe,!1),t.addEventListener("webglcontextcreationerror",de,!1),L===null){let P="webgl2";if(L=Jt(P,y),L===null)throw Jt(P)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Oe()}catch(y){throw t.removeEventListener("webglcontextlost",we,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",de,!1),_e("WebGLRenderer: "+y.message),y}function Oe(){nt=new rm(L),nt.init(),ie=new Gg(L,nt),it=new Yp(L,nt,e,ie),ue=new zg(L,nt),it.reversedDepthBuffer&&d&&ue.buffers.depth.setReversed(!0),H=L.createFramebuffer(),_=L.createFramebuffer(),V=L.createFramebuffer(),ft=new lm(L),Ae=new Eg,Ie=new kg(L,nt,ue,Ae,it,ie,ft),w=new sm(I),v=new cd(L),re=new qp(L,v),O=new am(L,v,ft,re),ee=new hm(L,O,v,re,ft),K=new cm(L,it,Ie),Y=new Jp(Ae),j=new wg(I,w,nt,it,re,Y),se=new Xg(I,Ae),ce=new Cg,Z=new Dg(nt),R=new Xp(I,w,ue,ee,g,c),ae=new Bg(I,ee,it),Te=new qg(L,ft,it,ue),W=new Zp(L,nt,ft),oe=new om(L,nt,ft),ft.programs=j.programs,I.capabilities=it,I.extensions=nt,I.properties=Ae,I.renderLists=ce,I.shadowMap=ae,I.state=ue,I.info=ft}M!==Bt&&(N=new dm(M,t.width,t.height,o,s,r));let ne=new El(I,L);this.xr=ne,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let y=nt.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){let y=nt.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return me},this.setPixelRatio=function(y){y!==void 0&&(me=y,this.setSize(ve,Ee,!1))},this.getSize=function(y){return y.set(ve,Ee)},this.setSize=function(y,P,k=!0){if(ne.isPresenting){Ce("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=y,Ee=P,t.width=Math.floor(y*me),t.height=Math.floor(P*me),k===!0&&(t.style.width=y+"px",t.style.height=P+"px"),N!==null&&N.setSize(t.width,t.height),this.setViewport(0,0,y,P)},this.getDrawingBufferSize=function(y){return y.set(ve*me,Ee*me).floor()},this.setDrawingBufferSize=function(y,P,k){ve=y,Ee=P,me=k,t.width=Math.floor(y*k),t.height=Math.floor(P*k),this.setViewport(0,0,y,P)},this.setEffects=function(y){if(M===Bt){_e("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let P=0;P<y.length;P++)if(y[P].isOutputPass===!0){Ce("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy($)},this.getViewport=function(y){return y.copy(Re)},this.setViewport=function(y,P,k,F){y.isVector4?Re.set(y.x,y.y,y.z,y.w):Re.set(y,P,k,F),ue.viewport($.copy(Re).multiplyScalar(Yt()).round())},this.getScissor=function(y){return y.copy(Ye)},this.setScissor=function(y,P,k,F){y.isVector4?Ye.set(y.x,y.y,y.z,y.w):Ye.set(y,P,k,F),ue.scissor(Se.copy(Ye).multiplyScalar(Yt()).round())},this.getScissorTest=function(){return Ke},this.setScissorTest=function(y){ue.setScissorTest(Ke=y)},this.setOpaqueSort=function(y){Ne=y},this.setTransparentSort=function(y){lt=y},this.getClearColor=function(y){return y.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(y=!0,P=!0,k=!0){let F=0;if(y){let z=!1;if(te!==null){let he=te.texture.format;z=p.has(he)}if(z){let he=te.texture.type,xe=u.has(he),le=R.getClearColor(),ge=R.getClearAlpha(),be=le.r,De=le.g,ke=le.b;xe?(S[0]=be,S[1]=De,S[2]=ke,S[3]=ge,L.clearBufferuiv(L.COLOR,0,S)):(A[0]=be,A[1]=De,A[2]=ke,A[3]=ge,L.clearBufferiv(L.COLOR,0,A))}else F|=L.COLOR_BUFFER_BIT}P&&(F|=L.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),k&&(F|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&L.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),B=y},this.dispose=function(){t.removeEventListener("webglcontextlost",we,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",de,!1),R.dispose(),ce.dispose(),Z.dispose(),Ie.dispose(),Ae.dispose(),w.dispose(),ee.dispose(),O.dispose(),re.dispose(),Te.dispose(),j.dispose(),ne.dispose(),ne.removeEventListener("sessionstart",Nl),ne.removeEventListener("sessionend",Ul),ti.stop()};function we(y){y.preventDefault(),hl("WebGLRenderer: Context Lost."),D=!0}function Fe(){hl("WebGLRenderer: Context Restored."),D=!1;let y=ft.autoReset,P=ae.enabled,k=ae.autoUpdate,F=ae.needsUpdate,z=ae.type;Oe(),ft.autoReset=y,ae.enabled=P,ae.autoUpdate=k,ae.needsUpdate=F,ae.type=z}function de(y){_e("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Je(y){let P=y.target;P.removeEventListener("dispose",Je),vt(P)}function vt(y){Bn(y),Ae.remove(y)}function Bn(y){let P=Ae.get(y).programs;P!==void 0&&(P.forEach(function(k){j.releaseProgram(k)}),y.isShaderMaterial&&j.releaseShaderCache(y))}this.renderBufferDirect=function(y,P,k,F,z,he){P===null&&(P=qt);let xe=z.isMesh&&z.matrixWorld.determinantAffine()<0,le=cu(y,P,k,F,z);ue.setMaterial(F,xe);let ge=k.index,be=1;if(F.wireframe===!0){if(ge=O.getWireframeAttribute(k),ge===void 0)return;be=2}let De=k.drawRange,ke=k.attributes.position,ye=De.start*be,Ge=(De.start+De.count)*be;he!==null&&(ye=Math.max(ye,he.start*be),Ge=Math.min(Ge,(he.start+he.count)*be)),ge!==null?(ye=Math.max(ye,0),Ge=Math.min(Ge,ge.count)):ke!=null&&(ye=Math.max(ye,0),Ge=Math.min(Ge,ke.count));let ct=Ge-ye;if(ct<0||ct===1/0)return;re.setup(z,F,le,k,ge);let $e,je=W;if(ge!==null&&($e=v.get(ge),je=oe,je.setIndex($e)),z.isMesh)F.wireframe===!0?(ue.setLineWidth(F.wireframeLinewidth*Yt()),je.setMode(L.LINES)):je.setMode(L.TRIANGLES);else if(z.isLine){let Et=F.linewidth;Et===void 0&&(Et=1),ue.setLineWidth(Et*Yt()),z.isLineSegments?je.setMode(L.LINES):z.isLineLoop?je.setMode(L.LINE_LOOP):je.setMode(L.LINE_STRIP)}else z.isPoints?je.setMode(L.POINTS):z.isSprite&&je.setMode(L.TRIANGLES);if(z.isBatchedMesh)if(nt.get("WEBGL_multi_draw"))je.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Et=z._multiDrawStarts,Me=z._multiDrawCounts,It=z._multiDrawCount,qe=ge?v.get(ge).bytesPerElement:1,ni=Ae.get(F).currentProgram.getUniforms();for(let At=0;At<It;At++)ni.setValue(L,"_gl_DrawID",At),je.render(Et[At]/qe,Me[At])}else if(z.isInstancedMesh)je.renderInstances(ye,ct,z.count);else if(k.isInstancedBufferGeometry){let Et=k._maxInstanceCount!==void 0?k._maxInstanceCount:1/0,Me=Math.min(k.instanceCount,Et);je.renderInstances(ye,ct,Me)}else je.render(ye,ct)};function Dl(y,P,k,F){B!==null&&y.isNodeMaterial&&B.setObject(F,y),dt===!0&&Y.setState(y,k,!1),y.transparent===!0&&y.side===xn&&y.forceSinglePass===!1?(y.side=Nt,y.needsUpdate=!0,Yi(y,P,F),y.side=Qn,y.needsUpdate=!0,Yi(y,P,F),y.side=xn):Yi(y,P,F)}this.compile=function(y,P,k=null){k===null&&(k=y),B!==null&&B.renderStart(y,P,k),E=Z.get(k),E.init(P),b.push(E),k.traverseVisible(function(z){z.isLight&&z.layers.test(P.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),y!==k&&y.traverseVisible(function(z){z.isLight&&z.layers.test(P.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Ft=this.localClippingEnabled,dt=Y.init(this.clippingPlanes,Ft),dt===!0&&Y.setGlobalState(this.clippingPlanes,P),B!==null&&ae.render(E.state.shadowsArray,k,P);let F=new Set;return y.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let he=z.material;if(he)if(Array.isArray(he))for(let xe=0;xe<he.length;xe++){let le=he[xe];Dl(le,k,P,z),F.add(le)}else Dl(he,k,P,z),F.add(he)}),E=b.pop(),B!==null&&B.renderEnd(),F},this.compileAsync=function(y,P,k=null){let F=this.compile(y,P,k);return new Promise(z=>{function he(){if(F.forEach(function(xe){let ge=Ae.get(xe).currentProgram;(ge===void 0||ge.isReady())&&F.delete(xe)}),F.size===0){z(y);return}setTimeout(he,10)}nt.get("KHR_parallel_shader_compile")!==null?he():setTimeout(he,10)})};let no=null;function ou(y){no&&no(y)}function Nl(){ti.stop()}function Ul(){ti.start()}let ti=new Oh;ti.setAnimationLoop(ou),typeof self<"u"&&ti.setContext(self),this.setAnimationLoop=function(y){no=y,ne.setAnimationLoop(y),y===null?ti.stop():ti.start()},ne.addEventListener("sessionstart",Nl),ne.addEventListener("sessionend",Ul),this.render=function(y,P){if(P!==void 0&&P.isCamera!==!0){_e("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(y,P);let k=ne.enabled===!0&&ne.isPresenting===!0,F=N!==null&&(te===null||k)&&N.begin(I,te);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),P.parent===null&&P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),ne.enabled===!0&&ne.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ne.cameraAutoUpdate===!0&&ne.updateCamera(P),P=ne.getCamera()),y.isScene===!0&&y.onBeforeRender(I,y,P,te),E=Z.get(y,b.length),E.init(P),E.state.textureUnits=Ie.getTextureUnits(),b.push(E),rt.multiplyMatrices(P.projectionMatrix,P.matrixWorldInverse),P.isArrayCamera?bt.setFromArrayCamera(P):ze.setFromProjectionMatrix(rt,jt,P.reversedDepth),Ft=this.localClippingEnabled,dt=Y.init(this.clippingPlanes,Ft),C=ce.get(y,x.length),C.init(),x.push(C),this.info.render.frame++,ne.enabled===!0&&ne.isPresenting===!0){let xe=I.xr.getDepthSensingMesh();xe!==null&&io(xe,P,-1/0,I.sortObjects)}io(y,P,0,I.sortObjects),C.finish(),B!==null&&B.updateLights(E.state.lightsArray),I.sortObjects===!0&&C.sort(Ne,lt),Zt=ne.enabled===!1||ne.isPresenting===!1||ne.hasDepthSensing()===!1,Zt&&R.addToRenderList(C,y),this.info.autoReset===!0&&this.info.reset(),dt===!0&&Y.beginShadows();let z=E.state.shadowsArray;if(ae.render(z,y,P),dt===!0&&Y.endShadows(),(F&&N.hasRenderPass())===!1){let xe=C.opaque,le=C.transmissive;if(E.setupLights(),P.isArrayCamera){let ge=P.cameras;if(le.length>0)for(let be=0,De=ge.length;be<De;be++){let ke=ge[be];Ol(xe,le,y,ke)}Zt&&R.render(y);for(let be=0,De=ge.length;be<De;be++){let ke=ge[be];Fl(C,y,ke,ke.viewport)}}else le.length>0&&Ol(xe,le,y,P),Zt&&R.render(y),Fl(C,y,P)}te!==null&&G===0&&(Ie.updateMultisampleRenderTarget(te),Ie.updateRenderTargetMipmap(te)),F&&N.end(I),y.isScene===!0&&y.onAfterRender(I,y,P),re.resetDefaultState(),X=-1,Q=null,b.pop(),b.length>0?(E=b[b.length-1],Ie.setTextureUnits(E.state.textureUnits),dt===!0&&Y.setGlobalState(I.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,B!==null&&B.renderEnd()};function io(y,P,k,F){if(y.visible===!1)return;if(y.layers.test(P.layers)){if(y.isGroup)k=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(P);else if(y.isLight)E.pushLight(y),y.castShadow&&E.pushShadow(y);else if(y.isSprite){let xe=P.isArrayCamera?bt:ze;if(!y.frustumCulled||y.intersectsFrustum(xe)){F&&xt.setFromMatrixPosition(y.matrixWorld).applyMatrix4(rt);let le=ee.update(y),ge=y.material;ge.visible&&C.push(y,le,ge,k,xt.z,null,P)}}else if(y.isMesh||y.isLine||y.isPoints){let xe=P.isArrayCamera?bt:ze;if(!y.frustumCulled||y.intersectsFrustum(xe)){let le=ee.update(y),ge=y.material;if(F&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),xt.copy(y.boundingSphere.center)):(le.boundingSphere===null&&le.computeBoundingSphere(),xt.copy(le.boundingSphere.center)),xt.applyMatrix4(y.matrixWorld).applyMatrix4(rt)),Array.isArray(ge)){let be=le.groups;for(let De=0,ke=be.length;De<ke;De++){let ye=be[De],Ge=ge[ye.materialIndex];Ge&&Ge.visible&&C.push(y,le,Ge,k,xt.z,ye,P)}}else ge.visible&&C.push(y,le,ge,k,xt.z,null,P)}}}let he=y.children;for(let xe=0,le=he.length;xe<le;xe++)io(he[xe],P,k,F)}function Fl(y,P,k,F){let{opaque:z,transmissive:he,transparent:xe}=y;E.setupLightsView(k),dt===!0&&Y.setGlobalState(I.clippingPlanes,k),F&&ue.viewport($.copy(F)),z.length>0&&Gs(z,P,k),he.length>0&&Gs(he,P,k),xe.length>0&&Gs(xe,P,k),ue.buffers.depth.setTest(!0),ue.buffers.depth.setMask(!0),ue.buffers.color.setMask(!0),ue.setPolygonOffset(!1)}function Ol(y,P,k,F){if((k.isScene===!0?k.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[F.id]===void 0){let ye=nt.has("EXT_color_buffer_half_float")||nt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[F.id]=new Ht(1,1,{generateMipmaps:!0,type:ye?ln:Bt,minFilter:Nn,samples:Math.max(4,it.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ve.workingColorSpace})}let he=E.state.transmissionRenderTarget[F.id],xe=F.viewport||$;he.setSize(xe.z*I.transmissionResolutionScale,xe.w*I.transmissionResolutionScale);let le=I.getRenderTarget(),ge=I.getActiveCubeFace(),be=I.getActiveMipmapLevel();I.setRenderTarget(he),I.getClearColor(J),pe=I.getClearAlpha(),pe<1&&I.setClearColor(16777215,.5),I.clear(),Zt&&R.render(k);let De=I.toneMapping;I.toneMapping=vn;let ke=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),E.setupLightsView(F),dt===!0&&Y.setGlobalState(I.clippingPlanes,F),Gs(y,k,F),Ie.updateMultisampleRenderTarget(he),Ie.updateRenderTargetMipmap(he),nt.has("WEBGL_multisampled_render_to_texture")===!1){let ye=!1;for(let Ge=0,ct=P.length;Ge<ct;Ge++){let $e=P[Ge],{object:je,geometry:Et,material:Me,group:It}=$e;if(Me.side===xn&&je.layers.test(F.layers)){let qe=Me.side;Me.side=Nt,Me.needsUpdate=!0,Bl(je,k,F,Et,Me,It),Me.side=qe,Me.needsUpdate=!0,ye=!0}}ye===!0&&(Ie.updateMultisampleRenderTarget(he),Ie.updateRenderTargetMipmap(he))}I.setRenderTarget(le,ge,be),I.setClearColor(J,pe),ke!==void 0&&(F.viewport=ke),I.toneMapping=De}function Gs(y,P,k){let F=P.isScene===!0?P.overrideMaterial:null;for(let z=0,he=y.length;z<he;z++){let xe=y[z],{object:le,geometry:ge,group:be}=xe,De=xe.material;De.allowOverride===!0&&F!==null&&(De=F),le.layers.test(k.layers)&&Bl(le,P,k,ge,De,be)}}function Bl(y,P,k,F,z,he){B!==null&&z.isNodeMaterial&&B.setObject(y,z),y.onBeforeRender(I,P,k,F,z,he),y.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),z.onBeforeRender(I,P,k,F,y,he),z.transparent===!0&&z.side===xn&&z.forceSinglePass===!1?(z.side=Nt,z.needsUpdate=!0,I.renderBufferDirect(k,P,F,z,y,he),z.side=Qn,z.needsUpdate=!0,I.renderBufferDirect(k,P,F,z,y,he),z.side=xn):I.renderBufferDirect(k,P,F,z,y,he),y.onAfterRender(I,P,k,F,z,he)}function zl(y){let P=0;for(let k of y)k.texture!==null&&P++;return P}function Yi(y,P,k){P.isScene!==!0&&(P=qt);let F=Ae.get(y),z=E.state.lights,he=E.state.shadowsArray,xe=z.state.version,le=j.getParameters(y,z.state,he,P,k,E.state.lightProbeGridArray),ge=j.getProgramCacheKey(le),be=F.programs;F.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,F.fog=P.fog;let De=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;F.envMap=w.get(y.envMap||F.environment,De),F.envMapRotation=F.environment!==null&&y.envMap===null?P.environmentRotation:y.envMapRotation,be===void 0&&(y.addEventListener("dispose",Je),be=new Map,F.programs=be,F.programVariants=new Map);let ke=be.get(ge);if(ke!==void 0){if(F.currentProgram===ke&&F.lightsStateVersion===xe)return Gl(y,le),ke}else le.uniforms=j.getUniforms(y),B!==null&&y.isNodeMaterial&&B.build(y,k,le),y.onBeforeCompile(le,I),ke=j.acquireProgram(le,ge),be.set(ge,ke),F.uniforms=le.uniforms;let ye=F.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(ye.clippingPlanes=Y.uniform),Gl(y,le),F.needsLights=uu(y),F.lightsStateVersion=xe,F.needsLights&&(ye.ambientLightColor.value=z.state.ambient,ye.lightProbe.value=z.state.probe,ye.sunLights.value=z.state.sun,ye.sunLightShadows.value=z.state.sunShadow,ye.directionalLights.value=z.state.directional,ye.directionalLightShadows.value=z.state.directionalShadow,ye.spotLights.value=z.state.spot,ye.spotLightShadows.value=z.state.spotShadow,ye.rectAreaLights.value=z.state.rectArea,ye.ltc_1.value=z.state.rectAreaLTC1,ye.ltc_2.value=z.state.rectAreaLTC2,ye.pointLights.value=z.state.point,ye.pointLightShadows.value=z.state.pointShadow,ye.hemisphereLights.value=z.state.hemi,ye.sunShadowMatrix.value=z.state.sunShadowMatrix,ye.sunShadowCascade.value=z.state.sunShadowCascade,ye.directionalShadowMatrix.value=z.state.directionalShadowMatrix,ye.spotLightMatrix.value=z.state.spotLightMatrix,ye.spotLightMap.value=z.state.spotLightMap,ye.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=zl(E.state.lightProbeGridArray),F.currentProgram=ke,F.uniformsList=null,ke}function lu(y,P,k,F,z){let he=Ae.get(y),xe=he.currentProgram.id+","+F+","+z,le=he.programVariants.get(xe);return le===void 0?(le=Yi(y,P,k),he.programVariants.set(xe,le)):(he.currentProgram=le,he.uniformsList=null,he.outputColorSpace=F,he.toneMapping=z),le}function kl(y){if(y.uniformsList===null){let P=y.currentProgram.getUniforms();y.uniformsList=Xi.seqWithValue(P.seq,y.uniforms)}return y.uniformsList}function Gl(y,P){let k=Ae.get(y);k.outputColorSpace=P.outputColorSpace,k.batching=P.batching,k.batchingColor=P.batchingColor,k.instancing=P.instancing,k.instancingColor=P.instancingColor,k.instancingMorph=P.instancingMorph,k.skinning=P.skinning,k.morphTargets=P.morphTargets,k.morphNormals=P.morphNormals,k.morphColors=P.morphColors,k.morphTargetsCount=P.morphTargetsCount,k.numClippingPlanes=P.numClippingPlanes,k.numIntersection=P.numClipIntersection,k.vertexAlphas=P.vertexAlphas,k.vertexTangents=P.vertexTangents,k.toneMapping=P.toneMapping}function cu(y,P,k,F,z){P.isScene!==!0&&(P=qt),Ie.resetTextureUnits();let he=P.fog,xe=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?P.environment:null,le=te===null?I.outputColorSpace:te.isXRRenderTarget===!0?te.texture.colorSpace:Ve.workingColorSpace,ge=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,be=w.get(F.envMap||xe,ge),De=F.vertexColors===!0&&!!k.attributes.color&&k.attributes.color.itemSize===4,ke=!!k.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),ye=!!k.morphAttributes.position,Ge=!!k.morphAttributes.normal,ct=!!k.morphAttributes.color,$e=vn;F.toneMapped&&(te===null||te.isXRRenderTarget===!0)&&($e=I.toneMapping);let je=k.morphAttributes.position||k.morphAttributes.normal||k.morphAttributes.color,Et=je!==void 0?je.length:0,Me=Ae.get(F),It=E.state.lights;if(dt===!0&&(Ft===!0||y!==Q)){let at=y===Q&&F.id===X;Y.setState(F,y,at)}let qe=!1,ni=!1;F.version===Me.__version?Me.needsLights&&Me.lightsStateVersion!==It.state.version||z.isBatchedMesh&&Me.batching===!1||!z.isBatchedMesh&&Me.batching===!0||z.isBatchedMesh&&Me.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Me.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Me.instancing===!1||!z.isInstancedMesh&&Me.instancing===!0||z.isSkinnedMesh&&Me.skinning===!1||!z.isSkinnedMesh&&Me.skinning===!0||z.isInstancedMesh&&Me.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Me.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Me.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Me.instancingMorph===!1&&z.morphTexture!==null||Me.envMap!==be||F.fog===!0&&Me.fog!==he||Me.numClippingPlanes!==void 0&&(Me.numClippingPlanes!==Y.numPlanes||Me.numIntersection!==Y.numIntersection)||Me.vertexAlphas!==De||Me.vertexTangents!==ke||Me.morphTargets!==ye||Me.morphNormals!==Ge||Me.morphColors!==ct||Me.morphTargetsCount!==Et||Me.numLightProbeGrids!==zl(E.state.lightProbeGridArray)?qe=!0:(Me.outputColorSpace!==le||Me.toneMapping!==$e)&&(ni=!0):(qe=!0,Me.__version=F.version);let At=Me.currentProgram;(qe===!0||ni===!0)&&(At=ni===!0?lu(F,P,z,le,$e):Yi(F,P,z),B&&F.isNodeMaterial&&B.onUpdateProgram(F,At,Me));let Vs=!1,zn=!1,ii=!1,Xe=At.getUniforms(),Tt=Me.uniforms;if(ue.useProgram(At.program)&&(Vs=!0,zn=!0,ii=!0),F.id!==X&&(X=F.id,zn=!0),Vs||Q!==y){ue.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),Xe.setValue(L,"projectionMatrix",y.projectionMatrix),Xe.setValue(L,"viewMatrix",y.matrixWorldInverse);let yt=Xe.map.cameraPosition;yt!==void 0&&yt.setValue(L,un.setFromMatrixPosition(y.matrixWorld)),it.logarithmicDepthBuffer&&Xe.setValue(L,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&Xe.setValue(L,"isOrthographic",y.isOrthographicCamera===!0),Q!==y&&(Q=y,zn=!0,ii=!0)}if(Me.needsLights&&(It.state.sunShadowMap.length>0&&Xe.setValue(L,"sunShadowMap",It.state.sunShadowMap,Ie),It.state.directionalShadowMap.length>0&&Xe.setValue(L,"directionalShadowMap",It.state.directionalShadowMap,Ie),It.state.spotShadowMap.length>0&&Xe.setValue(L,"spotShadowMap",It.state.spotShadowMap,Ie),It.state.pointShadowMap.length>0&&Xe.setValue(L,"pointShadowMap",It.state.pointShadowMap,Ie)),z.isSkinnedMesh){Xe.setOptional(L,z,"bindMatrix"),Xe.setOptional(L,z,"bindMatrixInverse");let at=z.skeleton;at&&(at.boneTexture===null&&at.computeBoneTexture(),Xe.setValue(L,"boneTexture",at.boneTexture,Ie))}z.isBatchedMesh&&(Xe.setOptional(L,z,"batchingTexture"),Xe.setValue(L,"batchingTexture",z._matricesTexture,Ie),Xe.setOptional(L,z,"batchingIdTexture"),Xe.setValue(L,"batchingIdTexture",z._indirectTexture,Ie),Xe.setOptional(L,z,"batchingColorTexture"),z._colorsTexture!==null&&Xe.setValue(L,"batchingColorTexture",z._colorsTexture,Ie));let en=k.morphAttributes;if((en.position!==void 0||en.normal!==void 0||en.color!==void 0)&&K.update(z,k,At),(zn||Me.receiveShadow!==z.receiveShadow)&&(Me.receiveShadow=z.receiveShadow,Xe.setValue(L,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&P.environment!==null&&(Tt.envMapIntensity.value=P.environmentIntensity),Tt.dfgLUT!==void 0&&(Tt.dfgLUT.value=Yg()),zn){if(Xe.setValue(L,"toneMappingExposure",I.toneMappingExposure),Me.needsLights&&hu(Tt,ii),he&&F.fog===!0&&se.refreshFogUniforms(Tt,he),se.refreshMaterialUniforms(Tt,F,me,Ee,E.state.transmissionRenderTarget[y.id]),Me.needsLights&&Me.numLightProbeGrids>0){let at=T,yt=0;for(let Sn of E.state.lightProbeGridArray)Sn.texture!==null&&(at.textures[yt]=Sn.texture,at.min[yt]=Sn.boundingBox.min,at.max[yt]=Sn.boundingBox.max,at.resolution[yt]=Sn.resolution,yt++);for(let Sn in at)at[Sn].length=yt;Tt.probesSH.value=at.textures,Tt.probesMin.value=at.min,Tt.probesMax.value=at.max,Tt.probesResolution.value=at.resolution}Xi.upload(L,kl(Me),Tt,Ie)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(Xi.upload(L,kl(Me),Tt,Ie),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&Xe.setValue(L,"center",z.center),Xe.setValue(L,"modelViewMatrix",z.modelViewMatrix),Xe.setValue(L,"normalMatrix",z.normalMatrix),Xe.setValue(L,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let at=F.uniformsGroups;for(let yt=0,Sn=at.length;yt<Sn;yt++){let Hl=at[yt];Te.update(Hl,At),Te.bind(Hl,At)}}return At}function hu(y,P){y.ambientLightColor.needsUpdate=P,y.lightProbe.needsUpdate=P,y.sunLights.needsUpdate=P,y.sunLightShadows.needsUpdate=P,y.directionalLights.needsUpdate=P,y.directionalLightShadows.needsUpdate=P,y.pointLights.needsUpdate=P,y.pointLightShadows.needsUpdate=P,y.spotLights.needsUpdate=P,y.spotLightShadows.needsUpdate=P,y.rectAreaLights.needsUpdate=P,y.hemisphereLights.needsUpdate=P}function uu(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return te},this.setRenderTargetTextures=function(y,P,k){let F=Ae.get(y);F.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),Ae.get(y.texture).__webglTexture=P,Ae.get(y.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:k,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,P){let k=Ae.get(y);k.__webglFramebuffer=P,k.__useDefaultFramebuffer=P===void 0},this.setRenderTarget=function(y,P=0,k=0){te=y,q=P,G=k;let F=null,z=!1,he=!1;if(y){let le=Ae.get(y);if(le.__useDefaultFramebuffer!==void 0){ue.bindFramebuffer(L.FRAMEBUFFER,le.__webglFramebuffer),$.copy(y.viewport),Se.copy(y.scissor),Le=y.scissorTest,ue.viewport($),ue.scissor(Se),ue.setScissorTest(Le),X=-1;return}else if(le.__webglFramebuffer===void 0)Ie.setupRenderTarget(y);else if(le.__hasExternalTextures)Ie.rebindTextures(y,Ae.get(y.texture).__webglTexture,Ae.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){let De=y.depthTexture;if(le.__boundDepthTexture!==De){if(De!==null&&Ae.has(De)&&(y.width!==De.image.width||y.height!==De.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ie.setupDepthRenderbuffer(y)}}let ge=y.texture;(ge.isData3DTexture||ge.isDataArrayTexture||ge.isCompressedArrayTexture)&&(he=!0);let be=Ae.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(be[P])?F=be[P][k]:F=be[P],z=!0):y.samples>0&&Ie.useMultisampledRTT(y)===!1?F=Ae.get(y).__webglMultisampledFramebuffer:Array.isArray(be)?F=be[k]:F=be,$.copy(y.viewport),Se.copy(y.scissor),Le=y.scissorTest}else $.copy(Re).multiplyScalar(me).floor(),Se.copy(Ye).multiplyScalar(me).floor(),Le=Ke;if(k!==0&&(F=H),ue.bindFramebuffer(L.FRAMEBUFFER,F)&&ue.drawBuffers(y,F),ue.viewport($),ue.scissor(Se),ue.setScissorTest(Le),z){let le=Ae.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+P,le.__webglTexture,k)}else if(he){let le=P;for(let ge=0;ge<y.textures.length;ge++){let be=Ae.get(y.textures[ge]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+ge,be.__webglTexture,k,le)}}else if(y!==null&&k!==0){let le=Ae.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,le.__webglTexture,k)}X=-1};function Vl(y){let P=Ae.get(y);return(P.__readFormat!==y.format||P.__readType!==y.type)&&(P.__readFormat=y.format,P.__readType=y.type,P.__formatReadable=it.textureFormatReadable(y.format),P.__typeReadable=it.textureTypeReadable(y.type)),P}this.readRenderTargetPixels=function(y,P,k,F,z,he,xe,le=0){if(!(y&&y.isWebGLRenderTarget)){_e("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ge=Ae.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xe!==void 0&&(ge=ge[xe],Array.isArray(ge)&&(ge=ge[0])),ge){ue.bindFramebuffer(L.FRAMEBUFFER,ge);try{let be=y.textures[le],De=be.format,ke=be.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+le);let ye=Vl(be);if(ye.__formatReadable===!1){_e("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ye.__typeReadable===!1){_e("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}P>=0&&P<=y.width-F&&k>=0&&k<=y.height-z&&L.readPixels(P,k,F,z,ie.convert(De),ie.convert(ke),he)}finally{let be=te!==null?Ae.get(te).__webglFramebuffer:null;ue.bindFramebuffer(L.FRAMEBUFFER,be)}}},this.readRenderTargetPixelsAsync=async function(y,P,k,F,z,he,xe,le=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ge=Ae.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xe!==void 0&&(ge=ge[xe],Array.isArray(ge)&&(ge=ge[0])),ge)if(P>=0&&P<=y.width-F&&k>=0&&k<=y.height-z){ue.bindFramebuffer(L.FRAMEBUFFER,ge);let be=y.textures[le],De=be.format,ke=be.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+le);let ye=Vl(be);if(ye.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ye.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ge=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,Ge),L.bufferData(L.PIXEL_PACK_BUFFER,he.byteLength,L.STREAM_READ),L.readPixels(P,k,F,z,ie.convert(De),ie.convert(ke),0),L.bindBuffer(L.PIXEL_PACK_BUFFER,null);let ct=te!==null?Ae.get(te).__webglFramebuffer:null;ue.bindFramebuffer(L.FRAMEBUFFER,ct);let $e=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await ch(L,$e,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,Ge),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,he),L.bindBuffer(L.PIXEL_PACK_BUFFER,null),L.deleteBuffer(Ge),L.deleteSync($e),he}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,P=null,k=0){let F=Math.pow(2,-k),z=Math.floor(y.image.width*F),he=Math.floor(y.image.height*F),xe=P!==null?P.x:0,le=P!==null?P.y:0;Ie.setTexture2D(y,0),L.copyTexSubImage2D(L.TEXTURE_2D,k,0,0,xe,le,z,he),ue.unbindTexture()},this.copyTextureToTexture=function(y,P,k=null,F=null,z=0,he=0){let xe,le,ge,be,De,ke,ye,Ge,ct,$e=y.isCompressedTexture?y.mipmaps[he]:y.image;if(k!==null)xe=k.max.x-k.min.x,le=k.max.y-k.min.y,ge=k.isBox3?k.max.z-k.min.z:1,be=k.min.x,De=k.min.y,ke=k.isBox3?k.min.z:0;else{let Xe=Math.pow(2,-z);xe=Math.floor($e.width*Xe),le=Math.floor($e.height*Xe),y.isDataArrayTexture?ge=$e.depth:y.isData3DTexture?ge=Math.floor($e.depth*Xe):ge=1,be=0,De=0,ke=0}F!==null?(ye=F.x,Ge=F.y,ct=F.z):(ye=0,Ge=0,ct=0);let je=ie.convert(P.format),Et=ie.convert(P.type),Me;P.isData3DTexture?(Ie.setTexture3D(P,0),Me=L.TEXTURE_3D):P.isDataArrayTexture||P.isCompressedArrayTexture?(Ie.setTexture2DArray(P,0),Me=L.TEXTURE_2D_ARRAY):(Ie.setTexture2D(P,0),Me=L.TEXTURE_2D),ue.activeTexture(L.TEXTURE0),ue.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,P.flipY),ue.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),ue.pixelStorei(L.UNPACK_ALIGNMENT,P.unpackAlignment);let It=ue.getParameter(L.UNPACK_ROW_LENGTH),qe=ue.getParameter(L.UNPACK_IMAGE_HEIGHT),ni=ue.getParameter(L.UNPACK_SKIP_PIXELS),At=ue.getParameter(L.UNPACK_SKIP_ROWS),Vs=ue.getParameter(L.UNPACK_SKIP_IMAGES);ue.pixelStorei(L.UNPACK_ROW_LENGTH,$e.width),ue.pixelStorei(L.UNPACK_IMAGE_HEIGHT,$e.height),ue.pixelStorei(L.UNPACK_SKIP_PIXELS,be),ue.pixelStorei(L.UNPACK_SKIP_ROWS,De),ue.pixelStorei(L.UNPACK_SKIP_IMAGES,ke);let zn=y.isDataArrayTexture||y.isData3DTexture,ii=P.isDataArrayTexture||P.isData3DTexture;if(y.isDepthTexture){let Xe=Ae.get(y),Tt=Ae.get(P),en=Ae.get(Xe.__renderTarget),at=Ae.get(Tt.__renderTarget);ue.bindFramebuffer(L.READ_FRAMEBUFFER,en.__webglFramebuffer),ue.bindFramebuffer(L.DRAW_FRAMEBUFFER,at.__webglFramebuffer);for(let yt=0;yt<ge;yt++)zn&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ae.get(y).__webglTexture,z,ke+yt),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ae.get(P).__webglTexture,he,ct+yt)),L.blitFramebuffer(be,De,be+xe,De+le,ye,Ge,ye+xe,Ge+le,L.DEPTH_BUFFER_BIT,L.NEAREST);ue.bindFramebuffer(L.READ_FRAMEBUFFER,null),ue.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(z!==0||y.isRenderTargetTexture||Ae.has(y)){let Xe=Ae.get(y),Tt=Ae.get(P);ue.bindFramebuffer(L.READ_FRAMEBUFFER,_),ue.bindFramebuffer(L.DRAW_FRAMEBUFFER,V);for(let en=0;en<ge;en++)zn?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Xe.__webglTexture,z,ke+en):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Xe.__webglTexture,z),ii?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Tt.__webglTexture,he,ct+en):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Tt.__webglTexture,he),z!==0?L.blitFramebuffer(be,De,be+xe,De+le,ye,Ge,ye+xe,Ge+le,L.COLOR_BUFFER_BIT,L.NEAREST):ii?L.copyTexSubImage3D(Me,he,ye,Ge,ct+en,be,De,xe,le):L.copyTexSubImage2D(Me,he,ye,Ge,be,De,xe,le);ue.bindFramebuffer(L.READ_FRAMEBUFFER,null),ue.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else ii?y.isDataTexture||y.isData3DTexture?L.texSubImage3D(Me,he,ye,Ge,ct,xe,le,ge,je,Et,$e.data):P.isCompressedArrayTexture?L.compressedTexSubImage3D(Me,he,ye,Ge,ct,xe,le,ge,je,$e.data):L.texSubImage3D(Me,he,ye,Ge,ct,xe,le,ge,je,Et,$e):y.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,he,ye,Ge,xe,le,je,Et,$e.data):y.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,he,ye,Ge,$e.width,$e.height,je,$e.data):L.texSubImage2D(L.TEXTURE_2D,he,ye,Ge,xe,le,je,Et,$e);ue.pixelStorei(L.UNPACK_ROW_LENGTH,It),ue.pixelStorei(L.UNPACK_IMAGE_HEIGHT,qe),ue.pixelStorei(L.UNPACK_SKIP_PIXELS,ni),ue.pixelStorei(L.UNPACK_SKIP_ROWS,At),ue.pixelStorei(L.UNPACK_SKIP_IMAGES,Vs),he===0&&P.generateMipmaps===!0&&P.mipmapsAutoUpdate===!0&&L.generateMipmap(Me),ue.unbindTexture()},this.initRenderTarget=function(y){Ae.get(y).__webglFramebuffer===void 0&&Ie.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?Ie.setTextureCube(y,0):y.isData3DTexture?Ie.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?Ie.setTexture2DArray(y,0):Ie.setTexture2D(y,0),ue.unbindTexture()},this.resetState=function(){q=0,G=0,te=null,ue.reset(),re.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return jt}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ve._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ve._getUnpackColorSpace()}};var Yh=.5,Jh=.012,Za=new U(0,0,1),Kh=.15,Xa=Math.PI/180,Qh=60*Xa,Zi=i=>new vs({color:i}),Jg=Zi("#e8eaee"),jh=Zi("#9aa3b2"),Al=Zi("#5c6675"),Kg=Zi("#3d4653"),jg=Zi("#c9723c"),Qg=Zi("#8a6d3b"),$g=new $t({color:"#b3261e"}),e0=new $t({color:"#6a1b9a",wireframe:!0}),t0=new Yn({color:"#1f2937"}),n0=new Yn({color:"#5b4a2a"}),i0=new $t({color:"#1565c0",wireframe:!0,depthTest:!1});function On(i,e,t,n=20){let s=new Bi(i,i,e,n);return s.rotateX(Math.PI/2),new pt(s,t)}var ei=(i,e=0)=>new U(i[e],i[e+1],i[e+2]);function qa(i,e,t){let n=t.clone().sub(e);i.position.copy(e).addScaledVector(n,.5),i.scale.z=Math.max(n.length(),1e-6),i.quaternion.setFromUnitVectors(Za,n.normalize())}var Ya=class extends Vt{constructor(e){super(),this.shaft=On(.012,1,e,8),this.head=new pt(new ms(.032,.07,10).rotateX(Math.PI/2),e),this.add(this.shaft,this.head)}show(e,t){let n=Jh*t.length();if(this.visible=n>.012,!this.visible)return;let s=e.clone().addScaledVector(t,Jh);qa(this.shaft,e,s),this.head.position.copy(s),this.head.quaternion.copy(this.shaft.quaternion)}},Ja=class extends Vt{constructor(e,t){super(),this.believes=t,this.position.y=e,this.rotation.z=Qh;let n=On(.1,.06,jh);n.position.z=.03,this.add(n),this.limbs=Array.from({length:8},(a,o)=>On(o<5?.055:.045,1,Jg)),this.joints=Array.from({length:7},(a,o)=>On(o<5?.068:.055,o<5?.15:.12,jh)),this.flange=new Vt;let s=On(.05,.02,Al),r=new pt(new Dn(.05,.19,.05),Al);r.position.z=.035,this.flange.add(s,r);for(let a of[-1,1]){let o=new pt(new Dn(.02,.015,.05),Al);o.position.set(0,a*.055,.085),this.flange.add(o)}this.objects=new Vt,this.flange.add(this.objects),this.belief=new pt(new zi(1,12,8),i0),this.belief.matrixAutoUpdate=!1,this.flange.add(this.belief),this.bag=new pt(new zi(.06,14,10),Qg),this.string=new Fi(new _t().setFromPoints([new U,Za]),n0),this.target=new Vt,this.target.add(new pt(new xs(.085,.006,6,28),new $t({color:"#1f2937"}))),this.stream=On(.008,1,new $t({color:"#3b82c4"}),8),this.sag=On(.004,1,new $t({color:"#1f2937"}),6),this.push=new Ya($g),this.felt=new Ya(e0),this.add(...this.limbs,...this.joints,this.flange,this.bag,this.string,this.target,this.sag,this.stream,this.push,this.felt)}update(e,t,n,s){let r=e("links"),a=S=>[ei(r,7*S),new Qt(...r.slice(7*S+3,7*S+7))],o=new U;for(let S=0;S<8;++S){let[A,T]=a(S);this.limbs[S].visible=A.distanceTo(o)>.001,this.limbs[S].visible&&qa(this.limbs[S],o,A),S<7?(this.joints[S].position.copy(A),this.joints[S].quaternion.copy(T)):(this.flange.position.copy(A),this.flange.quaternion.copy(T),this.target.quaternion.copy(T),this.target.position.copy(A).sub(ei(e("error"))),this.sag.visible=ei(e("error")).length()>.004,this.sag.visible&&qa(this.sag,this.target.position,A)),o=A}let c=ei(e("hand")),l=c.clone().add(new U(.07,.03,.35));this.stream.visible=s,qa(this.stream,l,l.clone().setZ(c.z-.05)),this.bag.visible=this.string.visible=n,n&&(this.bag.position.copy(ei(e("bag"))),this.string.geometry.setFromPoints([c,this.bag.position])),this.push.show(c,t),this.felt.show(c,this.believes?ei(e("force")):new U);let h=e("mean"),f=e("com_covariance");this.belief.visible=this.believes&&e("held")[0]>.5&&Math.max(f[0],f[4],f[8])<Kh*Kh;let d=2*Math.sqrt(f[0]),m=2*f[1]/Math.sqrt(f[0]),g=2*f[2]/Math.sqrt(f[0]),M=Math.sqrt(Math.max(4*f[4]-m*m,1e-8)),p=(4*f[5]-m*g)/M,u=Math.sqrt(Math.max(4*f[8]-g*g-p*p,1e-8));this.belief.matrix.set(d,0,0,h[1],m,M,0,h[2],g,p,u,h[3],0,0,0,1),this.belief.matrixWorldNeedsUpdate=!0}hold(e){this.objects.clear();for(let{mass:t,com:n,kind:s}of e){let r=.05*Math.cbrt(Math.max(t,.05)),a=s==="cup"?On(.045,.03+.06*t,jg):On(r,1.6*r,Kg);a.position.copy(ei(n)),a.add(new Oi(new gs(a.geometry,30),t0)),this.objects.add(a)}}};function s0(){let i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;return e!==void 0&&/swiftshader|llvmpipe|software/i.test(i.getParameter(e))}var Ka=class{constructor(e){this.canvas=e,this.renderer=new Va({canvas:e,antialias:!s0()}),this.scene=new ls,this.scene.background=new Ue("#f4f6f8"),this.camera=new Lt(32,1,.1,10),this.camera.up.copy(Za),this.azimuth=0,this.elevation=12*Xa;let t=new ws("#ffffff",2);t.position.set(2,-1,3);let n=new Es(3,15,"#b8c0cc","#dde2e8");n.rotation.x=Math.PI/2,this.arms={without:new Ja(-Yh,!1),with:new Ja(Yh,!0)},this.wall=new pt(new hi(1,1.1,5,5),new $t({color:"#37474f",wireframe:!0})),this.wall.rotation.x=Math.PI/2,this.scene.add(new Ss("#ffffff","#b0b6bf",2),t,n,...Object.values(this.arms)),this.walls=Object.values(this.arms).map(s=>{let r=this.wall.clone();return s.add(r),r}),this.ratio=Math.min(devicePixelRatio,2),this.interval=this.drawn=0,this.resize(),new ResizeObserver(()=>this.resize()).observe(e)}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;!e||!t||(this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.look())}look(){let e=Math.tan(this.camera.fov*Xa/2),t=Math.max(.58/e,.98/(e*this.camera.aspect))+.45,n=new U(.15,.18,.45),s=Math.cos(this.elevation);this.camera.position.set(s*Math.cos(this.azimuth),s*Math.sin(this.azimuth),Math.sin(this.elevation)).multiplyScalar(t).add(n),this.camera.lookAt(n),this.camera.updateMatrixWorld()}turn(e,t){this.azimuth=Math.min(Math.max(this.azimuth-.006*e,-1.2),1.2),this.elevation=Math.min(Math.max(this.elevation+.006*t,0),1.2),this.look()}handAt(e){let n=this.arms[e].flange.localToWorld(new U(0,0,.1)).project(this.camera);return{x:(n.x+1)/2*this.canvas.clientWidth,y:(1-n.y)/2*this.canvas.clientHeight}}inArms(e,t){let n=this.camera.position.distanceTo(this.arms.with.position),s=2*Math.tan(this.camera.fov*Xa/2)*n/this.canvas.clientHeight,r=new Qe().extractRotation(this.camera.matrixWorld);return new U(e*s,-t*s,0).applyMatrix4(r).applyAxisAngle(Za,-Qh)}draw(e,t){let n=JSON.stringify(t);for(let[r,a]of Object.entries(this.arms))a.update(o=>e(`${r}.${o}`),ei(e("push")),e("hanging")[0]!==0,e("pour")[0]>0),n!==this.held&&a.hold(t);this.held=n;let s=e("wall_at");for(let r of this.walls)r.visible=e("constrained")[0]!==0,r.position.set(.4,s[0]+.1,.5);this.renderer.render(this.scene,this.camera),this.adapt()}adapt(){let e=performance.now(),t=e-this.drawn;this.drawn=e,t<1e3&&(this.interval+=(t-this.interval)/10),!(this.interval<45||this.ratio<.6)&&(this.interval=0,this.ratio*=.8,this.resize())}};var tu=["hand is empty","holds it steadily","is being filled","something pushes","payload is changing"],$h=["","attached","exchanged","removed","filled","only a push"],Cl=300,r0=100,Xt=i=>document.getElementById(i),zs=new Worker(URL.createObjectURL(new Blob([Wl],{type:"text/javascript"}))),Rl=new Hs,Pl,Il,$a,hn=0,Ll=1,Qa=0,eo=[],ks=[],to=!0,eu=!1,_l=0,ja=-1,ut=i=>{let[e,t]=Pl[i];return Il.subarray(e,e+t)},nu=i=>zs.postMessage({command:i});function a0(i){to=!1,nu(i)}zs.onmessage=({data:i})=>{if(i.fields&&(Pl=i.fields,eo=[],ks=[],_l=0,Rl.clear()),i.frames){for(Il of i.frames)Rl.add(ut);hn=i.ticks,i.busy&&(Qa+=(i.busy-Qa)*.05),to&&l0()}i.command&&(i.accepted?o0(i.command,i.at):gi("A Panda is rated for 3 kg: that would be too much.")),i.paused&&au()};function o0(i,e){eo.push(`${e} ${i}`);let[t,...n]=i.split(" ");t==="attach"&&ks.push({kind:+n[0]===Ji?"cup":"weight",mass:+n[0],com:n.slice(1).map(Number)}),t==="drop"&&(ks=[])}function l0(){!eu&&hn>=Cl&&nu(ro(1.2,0)),eu=hn>=Cl,hn<Cl?gi("Both hands are empty."):hn<4e3?gi("Both hands were given 1.2 kg. Nobody told the arms."):gi("Your turn: drag a weight onto a hand, or pull at a hand.")}function gi(i){Xt("caption").textContent!==i&&(Xt("caption").textContent=i)}function Ut(i,e,t,n=""){let s=Xt(i);s.dataset.value=e;let r=e.toFixed(t)+n;s.textContent!==r&&(s.textContent=r)}function iu(){let i=ut("with.mean"),e=ut("with.deviation"),t=ut("with.payload"),n=g=>Math.hypot(...g);Ut("error-without",1e3*n(ut("without.error")),1),Ut("error-with",1e3*n(ut("with.error")),1),Ut("mass",i[0],3),Ut("mass-deviation",e[0],3),Ut("truth",t[0],3);for(let g=0;g<3;++g)Ut(`com-${g}`,1e3*i[g+1],1),Ut(`com-deviation-${g}`,1e3*e[g+1],1),Ut(`com-truth-${g}`,1e3*t[g+1],1);let s=ut("with.probability"),r=s.indexOf(Math.max(...s));tu.forEach((g,M)=>{let p=Xt("modes").children[M];p.classList.toggle("likeliest",M===r),p.querySelector("i").style.width=`${100*s[M]}%`,Ut(`mode-${M}`,100*s[M],1," %")}),[...ut("with.force"),...ut("with.moment")].forEach((g,M)=>{let p=Math.max(-1,Math.min(1,g/(M<3?40:4))),u=Xt("wrench").children[M].querySelector("i");u.style.left=`${50+50*Math.min(p,0)}%`,u.style.width=`${50*Math.abs(p)}%`,Ut(`wrench-${M}`,g,M<3?1:2,M<3?" N":" N m")});let o=ut("with.health")[0],[c,l]=ut("with.limit");Ut("health",o,1),Xt("health-word").textContent=o<3?"good":"not explained",Ut("confidence",100*ut("with.confidence")[0],0," %"),Ut("friction",100*ut("with.friction_shows")[0],0," %"),Ut("wall",1e3*ut("with.wall")[0],0," mm"),Xt("limit").textContent=`joint ${c}, ${(l*180/Math.PI).toFixed(0)}\xB0 away`,Qa>0&&Ut("speed",1/Qa,1);let[h,f,d,m]=ut("with.event");ut("with.changing")[0]?Xt("noticed").textContent="something is happening":h>0&&(Xt("noticed").textContent=`${$h[f]}: noticed ${Math.round(1e3*(m-d))} ms after it began`),h>_l&&!to&&gi(`rme: ${$h[f]}, ${i[0].toFixed(2)} kg.`),_l=h}function su(){requestAnimationFrame(su),Il&&($a?.draw(ut,ks.map(i=>i.kind==="cup"?{...i,mass:ut("poured")[0]}:i)),!(ja>=0&&hn>=ja&&hn<ja+r0)&&(ja=hn,iu(),ql(Xt("history"),Rl)))}function ru(i,e,t){for(let[n,s]of e.entries())Xt(i).insertAdjacentHTML("beforeend",`<li><span>${s}</span><span class="bar"><i></i></span><output id="${t}-${n}"></output></li>`)}Xt("save").addEventListener("click",()=>{let i=document.createElement("a");i.href=URL.createObjectURL(new Blob([eo.join(`
`)+`
`])),i.download=`session-seed-${Ll}-until-${hn}.txt`,i.click()});ru("modes",tu,"mode");ru("wrench",["force x","force y","force z","moment x","moment y","moment z"],"wrench");ec();try{$a=new Ka(Xt("scene"))}catch{gi("This browser draws no three dimensions (WebGL). The numbers are those of the arms all the same.")}Xl({act:a0,get:ut,say:gi,view:$a,held:()=>ks,restart:()=>{to=!1,zs.postMessage({start:++Ll})}});requestAnimationFrame(su);var au;globalThis.rme={pause:()=>new Promise(i=>{au=()=>{iu();let e=Object.fromEntries(Object.keys(Pl).map(t=>[t,[...ut(t)]]));i({ticks:hn,seed:Ll,session:eo.join(`
`),numbers:e})},zs.postMessage({paused:!0})}),resume:()=>zs.postMessage({paused:!1}),ticks:()=>hn,handAt:i=>$a.handAt(i)};})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
