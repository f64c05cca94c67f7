(()=>{var Wl=`(()=>{var Gt=(()=>{var c=typeof document<"u"&&document.currentScript?document.currentScript.src:void 0;return(function(r){r=r||{};var r=typeof r<"u"?r:{},E,V;r.ready=new Promise(function(e,t){E=e,V=t});var we=Object.assign({},r),me=[],pe="./this.program",de=(e,t)=>{throw t},Se=!1,G=!0,F="";function Ie(e){return r.locateFile?r.locateFile(e,F):F+e}var Ce,De,ne,Re;(Se||G)&&(G?F=self.location.href:typeof document<"u"&&document.currentScript&&(F=document.currentScript.src),c&&(F=c),F.indexOf("blob:")!==0?F=F.substr(0,F.replace(/[?#].*/,"").lastIndexOf("/")+1):F="",Ce=(e=>{var t=new XMLHttpRequest;return t.open("GET",e,!1),t.send(null),t.responseText}),G&&(ne=(e=>{var t=new XMLHttpRequest;return t.open("GET",e,!1),t.responseType="arraybuffer",t.send(null),new Uint8Array(t.response)})),De=((e,t,n)=>{var a=new XMLHttpRequest;a.open("GET",e,!0),a.responseType="arraybuffer",a.onload=(()=>{if(a.status==200||a.status==0&&a.response){t(a.response);return}n()}),a.onerror=n,a.send(null)}),Re=(e=>document.title=e));var Je=r.print||console.log.bind(console),O=r.printErr||console.warn.bind(console);Object.assign(r,we),we=null,r.arguments&&(me=r.arguments),r.thisProgram&&(pe=r.thisProgram),r.quit&&(de=r.quit);var _t=4;function Q(e){Q.shown||(Q.shown={}),Q.shown[e]||(Q.shown[e]=1,O(e))}function $t(e,t){if(typeof WebAssembly.Function=="function"){for(var n={i:"i32",j:"i64",f:"f32",d:"f64"},a={parameters:[],results:t[0]=="v"?[]:[n[t[0]]]},u=1;u<t.length;++u)a.parameters.push(n[t[u]]);return new WebAssembly.Function(a,e)}var l=[1,0,1,96],s=t.slice(0,1),f=t.slice(1),b={i:127,j:126,f:125,d:124};l.push(f.length);for(var u=0;u<f.length;++u)l.push(b[f[u]]);s=="v"?l.push(0):l=l.concat([1,b[s]]),l[1]=l.length-2;var d=new Uint8Array([0,97,115,109,1,0,0,0].concat(l,[2,7,1,1,101,1,102,0,0,7,5,1,1,102,0,0])),S=new WebAssembly.Module(d),k=new WebAssembly.Instance(S,{e:{f:e}}),p=k.exports.f;return p}var Te=[],Be;function er(){if(Te.length)return Te.pop();try{P.grow(1)}catch(e){throw e instanceof RangeError?"Unable to grow wasm table. Set ALLOW_TABLE_GROWTH.":e}return P.length-1}function tr(e,t){for(var n=e;n<e+t;n++){var a=se(n);a&&Be.set(a,n)}}var rr=0,j;r.wasmBinary&&(j=r.wasmBinary);var Ge=r.noExitRuntime||!0;typeof WebAssembly!="object"&&h("no native wasm support detected");var q,ie=!1,Ze;function nr(e,t){e||h(t)}function Qe(e){var t=r["_"+e];return t}function qe(e,t,n,a,u){var l={string:function(w){var N=0;if(w!=null&&w!==0){var D=(w.length<<2)+1;N=ce(D),Ae(w,N,D)}return N},array:function(w){var N=ce(w.length);return Ne(w,N),N}};function s(w){return t==="string"?A(w):t==="boolean"?!!w:w}var f=Qe(e),b=[],d=0;if(a)for(var S=0;S<a.length;S++){var k=l[n[S]];k?(d===0&&(d=Ue()),b[S]=k(a[S])):b[S]=a[S]}var p=f.apply(null,b);function Y(w){return d!==0&&xe(d),s(w)}return p=Y(p),p}var ir=1,Fe=typeof TextDecoder<"u"?new TextDecoder("utf8"):void 0;function Ye(e,t,n){for(var a=t+n,u=t;e[u]&&!(u>=a);)++u;if(u-t>16&&e.subarray&&Fe)return Fe.decode(e.subarray(t,u));for(var l="";t<u;){var s=e[t++];if(!(s&128)){l+=String.fromCharCode(s);continue}var f=e[t++]&63;if((s&224)==192){l+=String.fromCharCode((s&31)<<6|f);continue}var b=e[t++]&63;if((s&240)==224?s=(s&15)<<12|f<<6|b:s=(s&7)<<18|f<<12|b<<6|e[t++]&63,s<65536)l+=String.fromCharCode(s);else{var d=s-65536;l+=String.fromCharCode(55296|d>>10,56320|d&1023)}}return l}function A(e,t){return e?Ye(K,e,t):""}function ze(e,t,n,a){if(!(a>0))return 0;for(var u=n,l=n+a-1,s=0;s<e.length;++s){var f=e.charCodeAt(s);if(f>=55296&&f<=57343){var b=e.charCodeAt(++s);f=65536+((f&1023)<<10)|b&1023}if(f<=127){if(n>=l)break;t[n++]=f}else if(f<=2047){if(n+1>=l)break;t[n++]=192|f>>6,t[n++]=128|f&63}else if(f<=65535){if(n+2>=l)break;t[n++]=224|f>>12,t[n++]=128|f>>6&63,t[n++]=128|f&63}else{if(n+3>=l)break;t[n++]=240|f>>18,t[n++]=128|f>>12&63,t[n++]=128|f>>6&63,t[n++]=128|f&63}}return t[n]=0,n-u}function Ae(e,t,n){return ze(e,K,t,n)}function _e(e){for(var t=0,n=0;n<e.length;++n){var a=e.charCodeAt(n);a>=55296&&a<=57343&&(a=65536+((a&1023)<<10)|e.charCodeAt(++n)&1023),a<=127?++t:a<=2047?t+=2:a<=65535?t+=3:t+=4}return t}var ar=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0;function Ne(e,t){L.set(e,t)}function $e(e,t,n){for(var a=0;a<e.length;++a)L[t++>>0]=e.charCodeAt(a);n||(L[t>>0]=0)}var Le,L,K,et,tt,v,rt,nt,it;function Xe(e){Le=e,r.HEAP8=L=new Int8Array(e),r.HEAP16=et=new Int16Array(e),r.HEAP32=v=new Int32Array(e),r.HEAPU8=K=new Uint8Array(e),r.HEAPU16=tt=new Uint16Array(e),r.HEAPU32=rt=new Uint32Array(e),r.HEAPF32=nt=new Float32Array(e),r.HEAPF64=it=new Float64Array(e)}var or=r.INITIAL_MEMORY||16777216,P,Ee=[],Oe=[],We=[],at=!1,ot=!1,st=0;function ft(){return Ge||st>0}function ut(){if(r.preRun)for(typeof r.preRun=="function"&&(r.preRun=[r.preRun]);r.preRun.length;)yt(r.preRun.shift());oe(Ee)}function lt(){at=!0,oe(Oe)}function sr(){ot=!0}function ct(){if(r.postRun)for(typeof r.postRun=="function"&&(r.postRun=[r.postRun]);r.postRun.length;)bt(r.postRun.shift());oe(We)}function yt(e){Ee.unshift(e)}function vt(e){Oe.unshift(e)}function bt(e){We.unshift(e)}var W=0,ae=null,M=null;function wt(e){W++,r.monitorRunDependencies&&r.monitorRunDependencies(W)}function mt(e){if(W--,r.monitorRunDependencies&&r.monitorRunDependencies(W),W==0&&(ae!==null&&(clearInterval(ae),ae=null),M)){var t=M;M=null,t()}}r.preloadedImages={},r.preloadedAudios={};function h(e){r.onAbort&&r.onAbort(e),e="Aborted("+e+")",O(e),ie=!0,Ze=1,e+=". Build with -s ASSERTIONS=1 for more info.";var t=new WebAssembly.RuntimeError(e);throw V(t),t}var pt="data:application/octet-stream;base64,";function ke(e){return e.startsWith(pt)}var T;T="live.wasm",ke(T)||(T=Ie(T));function ge(e){try{if(e==T&&j)return new Uint8Array(j);if(ne)return ne(e);throw"both async and sync fetching of the wasm failed"}catch(t){h(t)}}function dt(){return!j&&(Se||G)&&typeof fetch=="function"?fetch(T,{credentials:"same-origin"}).then(function(e){if(!e.ok)throw"failed to load wasm binary file at '"+T+"'";return e.arrayBuffer()}).catch(function(){return ge(T)}):Promise.resolve().then(function(){return ge(T)})}function St(){var e={env:He,wasi_snapshot_preview1:He};function t(s,f){var b=s.exports;r.asm=b,q=r.asm.memory,Xe(q.buffer),P=r.asm.__indirect_function_table,vt(r.asm.__wasm_call_ctors),mt("wasm-instantiate")}wt("wasm-instantiate");function n(s){t(s.instance)}function a(s){return dt().then(function(f){return WebAssembly.instantiate(f,e)}).then(function(f){return f}).then(s,function(f){O("failed to asynchronously prepare wasm: "+f),h(f)})}function u(){return!j&&typeof WebAssembly.instantiateStreaming=="function"&&!ke(T)&&typeof fetch=="function"?fetch(T,{credentials:"same-origin"}).then(function(s){var f=WebAssembly.instantiateStreaming(s,e);return f.then(n,function(b){return O("wasm streaming compile failed: "+b),O("falling back to ArrayBuffer instantiation"),a(n)})}):a(n)}if(r.instantiateWasm)try{var l=r.instantiateWasm(e,t);return l}catch(s){return O("Module.instantiateWasm callback failed with error: "+s),!1}return u().catch(V),{}}var fr,ur;function oe(e){for(;e.length>0;){var t=e.shift();if(typeof t=="function"){t(r);continue}var n=t.func;typeof n=="number"?t.arg===void 0?se(n)():se(n)(t.arg):n(t.arg===void 0?null:t.arg)}}function lr(e){return e}function cr(e){var t=/\\b_Z[\\w\\d_]+/g;return e.replace(t,function(n){var a=n;return n===a?n:a+" ["+n+"]"})}var I=[];function se(e){var t=I[e];return t||(e>=I.length&&(I.length=e+1),I[e]=t=P.get(e)),t}function yr(){var e=new Error;if(!e.stack){try{throw new Error}catch(t){e=t}if(!e.stack)return"(no stack trace available)"}return e.stack.toString()}function vr(e,t){P.set(e,t),I[e]=t}function Tt(e){return Ve(e+16)+16}function Zt(e){this.excPtr=e,this.ptr=e-16,this.set_type=function(t){v[this.ptr+4>>2]=t},this.get_type=function(){return v[this.ptr+4>>2]},this.set_destructor=function(t){v[this.ptr+8>>2]=t},this.get_destructor=function(){return v[this.ptr+8>>2]},this.set_refcount=function(t){v[this.ptr>>2]=t},this.set_caught=function(t){t=t?1:0,L[this.ptr+12>>0]=t},this.get_caught=function(){return L[this.ptr+12>>0]!=0},this.set_rethrown=function(t){t=t?1:0,L[this.ptr+13>>0]=t},this.get_rethrown=function(){return L[this.ptr+13>>0]!=0},this.init=function(t,n){this.set_type(t),this.set_destructor(n),this.set_refcount(0),this.set_caught(!1),this.set_rethrown(!1)},this.add_ref=function(){var t=v[this.ptr>>2];v[this.ptr>>2]=t+1},this.release_ref=function(){var t=v[this.ptr>>2];return v[this.ptr>>2]=t-1,t===1}}var Ft=0,Yt=0;function zt(e,t,n){var a=new Zt(e);throw a.init(t,n),Ft=e,Yt++,e}function Nt(){h("")}function Lt(e,t,n){K.copyWithin(e,t,t+n)}function Xt(){return 2147483648}function Et(e){try{return q.grow(e-Le.byteLength+65535>>>16),Xe(q.buffer),1}catch{}}function Ot(e){var t=K.length;e=e>>>0;var n=Xt();if(e>n)return!1;let a=(b,d)=>b+(d-b%d)%d;for(var u=1;u<=4;u*=2){var l=t*(1+.2/u);l=Math.min(l,e+100663296);var s=Math.min(n,a(Math.max(e,l),65536)),f=Et(s);if(f)return!0}return!1}var fe={};function Wt(){return pe||"./this.program"}function C(){if(!C.strings){var e=(typeof navigator=="object"&&navigator.languages&&navigator.languages[0]||"C").replace("-","_")+".UTF-8",t={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:e,_:Wt()};for(var n in fe)fe[n]===void 0?delete t[n]:t[n]=fe[n];var a=[];for(var n in t)a.push(n+"="+t[n]);C.strings=a}return C.strings}var ue={buffers:[null,[],[]],printChar:function(e,t){var n=ue.buffers[e];t===0||t===10?((e===1?Je:O)(Ye(n,0)),n.length=0):n.push(t)},varargs:void 0,get:function(){ue.varargs+=4;var e=v[ue.varargs-4>>2];return e},getStr:function(e){var t=A(e);return t},get64:function(e,t){return e}};function kt(e,t){var n=0;return C().forEach(function(a,u){var l=t+n;v[e+u*4>>2]=l,$e(a,l),n+=a.length+1}),0}function gt(e,t){var n=C();v[e>>2]=n.length;var a=0;return n.forEach(function(u){a+=u.length+1}),v[t>>2]=a,0}function _(e){return e%4===0&&(e%100!==0||e%400===0)}function le(e,t){for(var n=0,a=0;a<=t;n+=e[a++]);return n}var $=[31,29,31,30,31,30,31,31,30,31,30,31],ee=[31,28,31,30,31,30,31,31,30,31,30,31];function te(e,t){for(var n=new Date(e.getTime());t>0;){var a=_(n.getFullYear()),u=n.getMonth(),l=(a?$:ee)[u];if(t>l-n.getDate())t-=l-n.getDate()+1,n.setDate(1),u<11?n.setMonth(u+1):(n.setMonth(0),n.setFullYear(n.getFullYear()+1));else return n.setDate(n.getDate()+t),n}return n}function Ht(e,t,n,a){var u=v[a+40>>2],l={tm_sec:v[a>>2],tm_min:v[a+4>>2],tm_hour:v[a+8>>2],tm_mday:v[a+12>>2],tm_mon:v[a+16>>2],tm_year:v[a+20>>2],tm_wday:v[a+24>>2],tm_yday:v[a+28>>2],tm_isdst:v[a+32>>2],tm_gmtoff:v[a+36>>2],tm_zone:u?A(u):""},s=A(n),f={"%c":"%a %b %d %H:%M:%S %Y","%D":"%m/%d/%y","%F":"%Y-%m-%d","%h":"%b","%r":"%I:%M:%S %p","%R":"%H:%M","%T":"%H:%M:%S","%x":"%m/%d/%y","%X":"%H:%M:%S","%Ec":"%c","%EC":"%C","%Ex":"%m/%d/%y","%EX":"%H:%M:%S","%Ey":"%y","%EY":"%Y","%Od":"%d","%Oe":"%e","%OH":"%H","%OI":"%I","%Om":"%m","%OM":"%M","%OS":"%S","%Ou":"%u","%OU":"%U","%OV":"%V","%Ow":"%w","%OW":"%W","%Oy":"%y"};for(var b in f)s=s.replace(new RegExp(b,"g"),f[b]);var d=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],S=["January","February","March","April","May","June","July","August","September","October","November","December"];function k(i,o,m){for(var y=typeof i=="number"?i.toString():i||"";y.length<o;)y=m[0]+y;return y}function p(i,o){return k(i,o,"0")}function Y(i,o){function m(z){return z<0?-1:z>0?1:0}var y;return(y=m(i.getFullYear()-o.getFullYear()))===0&&(y=m(i.getMonth()-o.getMonth()))===0&&(y=m(i.getDate()-o.getDate())),y}function w(i){switch(i.getDay()){case 0:return new Date(i.getFullYear()-1,11,29);case 1:return i;case 2:return new Date(i.getFullYear(),0,3);case 3:return new Date(i.getFullYear(),0,2);case 4:return new Date(i.getFullYear(),0,1);case 5:return new Date(i.getFullYear()-1,11,31);case 6:return new Date(i.getFullYear()-1,11,30)}}function N(i){var o=te(new Date(i.tm_year+1900,0,1),i.tm_yday),m=new Date(o.getFullYear(),0,4),y=new Date(o.getFullYear()+1,0,4),z=w(m),X=w(y);return Y(z,o)<=0?Y(X,o)<=0?o.getFullYear()+1:o.getFullYear():o.getFullYear()-1}var D={"%a":function(i){return d[i.tm_wday].substring(0,3)},"%A":function(i){return d[i.tm_wday]},"%b":function(i){return S[i.tm_mon].substring(0,3)},"%B":function(i){return S[i.tm_mon]},"%C":function(i){var o=i.tm_year+1900;return p(o/100|0,2)},"%d":function(i){return p(i.tm_mday,2)},"%e":function(i){return k(i.tm_mday,2," ")},"%g":function(i){return N(i).toString().substring(2)},"%G":function(i){return N(i)},"%H":function(i){return p(i.tm_hour,2)},"%I":function(i){var o=i.tm_hour;return o==0?o=12:o>12&&(o-=12),p(o,2)},"%j":function(i){return p(i.tm_mday+le(_(i.tm_year+1900)?$:ee,i.tm_mon-1),3)},"%m":function(i){return p(i.tm_mon+1,2)},"%M":function(i){return p(i.tm_min,2)},"%n":function(){return\`
\`},"%p":function(i){return i.tm_hour>=0&&i.tm_hour<12?"AM":"PM"},"%S":function(i){return p(i.tm_sec,2)},"%t":function(){return"	"},"%u":function(i){return i.tm_wday||7},"%U":function(i){var o=new Date(i.tm_year+1900,0,1),m=o.getDay()===0?o:te(o,7-o.getDay()),y=new Date(i.tm_year+1900,i.tm_mon,i.tm_mday);if(Y(m,y)<0){var z=le(_(y.getFullYear())?$:ee,y.getMonth()-1)-31,X=31-m.getDate(),g=X+z+y.getDate();return p(Math.ceil(g/7),2)}return Y(m,o)===0?"01":"00"},"%V":function(i){var o=new Date(i.tm_year+1900,0,4),m=new Date(i.tm_year+1901,0,4),y=w(o),z=w(m),X=te(new Date(i.tm_year+1900,0,1),i.tm_yday);if(Y(X,y)<0)return"53";if(Y(z,X)<=0)return"01";var g;return y.getFullYear()<i.tm_year+1900?g=i.tm_yday+32-y.getDate():g=i.tm_yday+1-y.getDate(),p(Math.ceil(g/7),2)},"%w":function(i){return i.tm_wday},"%W":function(i){var o=new Date(i.tm_year,0,1),m=o.getDay()===1?o:te(o,o.getDay()===0?1:7-o.getDay()+1),y=new Date(i.tm_year+1900,i.tm_mon,i.tm_mday);if(Y(m,y)<0){var z=le(_(y.getFullYear())?$:ee,y.getMonth()-1)-31,X=31-m.getDate(),g=X+z+y.getDate();return p(Math.ceil(g/7),2)}return Y(m,o)===0?"01":"00"},"%y":function(i){return(i.tm_year+1900).toString().substring(2)},"%Y":function(i){return i.tm_year+1900},"%z":function(i){var o=i.tm_gmtoff,m=o>=0;return o=Math.abs(o)/60,o=o/60*100+o%60,(m?"+":"-")+("0000"+o).slice(-4)},"%Z":function(i){return i.tm_zone},"%%":function(){return"%"}};s=s.replace(/%%/g,"\\0\\0");for(var b in D)s.includes(b)&&(s=s.replace(new RegExp(b,"g"),D[b](l)));s=s.replace(/\\0\\0/g,"%");var ve=Ut(s,!1);return ve.length>t?0:(Ne(ve,e),ve.length-1)}function Vt(e,t,n,a){return Ht(e,t,n,a)}var br=!1;function Ut(e,t,n){var a=n>0?n:_e(e)+1,u=new Array(a),l=ze(e,u,0,u.length);return t&&(u.length=l),u}var He={__cxa_allocate_exception:Tt,__cxa_throw:zt,abort:Nt,emscripten_memcpy_big:Lt,emscripten_resize_heap:Ot,environ_get:kt,environ_sizes_get:gt,strftime_l:Vt},wr=St(),xt=r.___wasm_call_ctors=function(){return(xt=r.___wasm_call_ctors=r.asm.__wasm_call_ctors).apply(null,arguments)},jt=r._live_start=function(){return(jt=r._live_start=r.asm.live_start).apply(null,arguments)},Kt=r._live_command=function(){return(Kt=r._live_command=r.asm.live_command).apply(null,arguments)},Pt=r._live_step=function(){return(Pt=r._live_step=r.asm.live_step).apply(null,arguments)},Mt=r._live_values=function(){return(Mt=r._live_values=r.asm.live_values).apply(null,arguments)},ht=r._live_layout=function(){return(ht=r._live_layout=r.asm.live_layout).apply(null,arguments)},Ve=r._malloc=function(){return(Ve=r._malloc=r.asm.malloc).apply(null,arguments)},It=r.___errno_location=function(){return(It=r.___errno_location=r.asm.__errno_location).apply(null,arguments)},Ue=r.stackSave=function(){return(Ue=r.stackSave=r.asm.stackSave).apply(null,arguments)},xe=r.stackRestore=function(){return(xe=r.stackRestore=r.asm.stackRestore).apply(null,arguments)},ce=r.stackAlloc=function(){return(ce=r.stackAlloc=r.asm.stackAlloc).apply(null,arguments)},Ct=r.dynCall_viijii=function(){return(Ct=r.dynCall_viijii=r.asm.dynCall_viijii).apply(null,arguments)},Dt=r.dynCall_iiiiij=function(){return(Dt=r.dynCall_iiiiij=r.asm.dynCall_iiiiij).apply(null,arguments)},Rt=r.dynCall_iiiiijj=function(){return(Rt=r.dynCall_iiiiijj=r.asm.dynCall_iiiiijj).apply(null,arguments)},Jt=r.dynCall_iiiiiijj=function(){return(Jt=r.dynCall_iiiiiijj=r.asm.dynCall_iiiiiijj).apply(null,arguments)};r.ccall=qe;var re;function Bt(e){this.name="ExitStatus",this.message="Program terminated with exit("+e+")",this.status=e}M=function e(){re||ye(),re||(M=e)};function ye(e){if(e=e||me,W>0||(ut(),W>0))return;function t(){re||(re=!0,r.calledRun=!0,!ie&&(lt(),E(r),r.onRuntimeInitialized&&r.onRuntimeInitialized(),ct()))}r.setStatus?(r.setStatus("Running..."),setTimeout(function(){setTimeout(function(){r.setStatus("")},1),t()},1)):t()}r.run=ye;function mr(e){Ze=e,ft()||(r.onExit&&r.onExit(e),ie=!0),de(e,new Bt(e))}if(r.preInit)for(typeof r.preInit=="function"&&(r.preInit=[r.preInit]);r.preInit.length>0;)r.preInit.pop()();return ye(),r.ready})})(),je=Gt;var Ke="H4sIAAAAAAACA+y9eZgcx3UnGEdmHZ3V3dlAA2igcUQmIaCAxtEgLTSagtgdEAnBs+sxdmY/L779Pi0AgaDBAg+QhGR4BoMuiqRclrhWeSxZJdoyCw16VDrMKUuyXaJks0haUlGmrdJdEkGwKGvI0kikyzYll44RF+9FZGZUdgPq2dXs/rNFovO9X9yRkfFeRLyIIEfvuZ0SQmjNevMROkfnjtA5coTNqT907gifAxr+0rkjiTn80bkj1hzidsArggQ+iPJA546k5ubCQPQsPXskGfEEA547d+4cOUJI6KKjPYeZoWeBOxdFee4InzurubPwOHdujhwZmJszEsJcnIMIVJxI2nNzZ8OynAU/Z5FnZyFb7CyAbO4clOGsjiczN9cXL+brLJ074vTjRurkyPBc/49EdUCO0LOQgXOYjbNndX3p4gCP+T17VhcbS2jPKScsMD2LPlX4OV1AVQ5LFS9tJMzQCz+rywahKVQFw5qDigdn9WBYt+zcOfof8O9ZqKhz5Ag7F7zvc1j3c3P0PxiJ0DnWoil+/I63jx0+fOzM0cNHb7vtzmNHTx8/fPzMseOnTt965x2EgLOjnE+fuPvO3yAWICuO337PsbtvPXX6+B2Hbz9++7FTv3n4rbf+OrHBbaXhdvfxe279d8cPnzh+9JSKyj761jvvPk1GVv7G0XtuPXzPHUdP3XPiztOHT919/O23Hv+NXSPH73j7rXffecdhCHbP4V8/fprwK3h1Aq/oCeIeuOf03becvvX244dvIyn+lP2EPUIppVvJCB0enlg1yuhYgrFtlKU55dyy6CpKtzOLUYtwajHK0mm2Y2dyPZ0ku8aS1yYsy7IYtyxrwLIopzRpWdYqa3TMGqEM/ktazLK4ZbHrLIsxZtNfYuz1G1jSonT3hmFqWel1acoYI3QqmUwOJAfFnulB27IHrx8dHYSfeIM3SIYJ5YwQ/JIJZfYKP2lzixBCuA0PShmhhBNObAIeOSGca5YTwmxGCIG8UMIsQoDjhPMVfITQJETJGVNBGGNAU0Z8Qlaz1a679403uMxd7bpucmZWOvu4bXPCIWIvZRHrTelrmGNz7lDikBtXrkzSVNKy4V+CMDbEuc04pyRBrDVOMrEy4SScxMpEeuNNifWJZCI5bNucJsgQT3BrTQJ+6Y2JRCJpE8JShHDKU8mUvSzBbLo8tfx1trOMjKdShKYAAmTZeCrDSSKRGEgMJNKpTIZH9NAA40NYJsjKJnhPQ0BC6YEfgifha8nmLLMTazdnE/bAAKFQxYRxSqFiKYP2YTuOw21uO3aKUE1kUimasTOpFCEpksmofxReEtM/fFkILfIfJcOEE8oYJ/Be8JWAfw6/LSRtWZbN7C1pxpK2bSWTSZ5MWumBdDo9AJkkhA5Tsmxo/xorSU/RT7NPMztJaZ7l8yyRpnNUNh95kjjJ/8hGErcfv/3Ou3+TkZHDh3/j6D23Hz529LbbDh87fefd95DUwG23vv344XtOH737NBnMIHPszttvP3rHzWQord2OnyKug/Tbj972tuP3kBHF3Xb0N+9822mybPXhw7fecfOtdx8/dvrwLW+74xj0CodPH33rbccpSdyOPQb5E+oePnz87rvvuPMwdiDQcXyMpu85ffTYyX979O3HyZN2Bpl/c/ye03fefZw8ZQ8gLzH4X9tDN//mHW+CjL/91ltzt95KPhsht8IvRz5nD/cjOfJ52+2DAGvY6Z5FiaTOYyztZOr20/R++jv0PbRAa/RT9DH6afoZ+lf04/Tj9HH6FP1r+jn6efo5+gX6DP0b+rf0ney32H2swH5GX6P3st9m72LvZg+yP2QfZI+xp9kX2DPsUfoJ+hHrY9Z3rBet71rfs162/sH6R+ufrR9Y/2L9yPqJ9d+s16wL1n+yPmrVrE9Zj1mftj5j/aX1Iv8r63GrbpWsv7Y+a33eetr6gvVx+oz1t9bXrK9b37S+ZT1rPWe1rW9YLesfaJdetC5ZL1hP0xZrsT+xHrX+s1W1/tT6uPUJ65PWi/zPrD+3/sJqsSesJ6wnrU/ST9KnrE/SFvs764vWkxaUrWl9yWqxL1tf0fxXrS9hbN9k32IXGVDPsUuszVrsBfYKe5X9kPVYj/2Y/ZTl+Tv4/bzF3s3fw3+Pv5e/j7+P/z5/P3+I/wH/Q95i87zC/5R/nH+Cf5J/ij/GW+zT/K/4U/yv+Wf553iDP80h9mf43/K/41/kX+Jf4V/nf291rO9bPeunVtd61VLu3+Tf4s/y5/jz/Nv8v1j/1XrF+rH1M+ufrB9a99p5++85/H2Jt9h3+Xf5f8X/vsc/Tr/Pv38F7GX+ssZeuSrW5T/kLZa37rNa7F1W0Wqx37Xea7XY+6zftx6j8Hy/9Rh9mr7XfgDr6RP0E/Rj9mfsT9mP2i32abtm/2e7xR6z/8z+uN1ij9st9pf2E3bRfsJ+wh54/w9XP2E/zimbu4ZI96RPNhI2K4jM5ASRqZxrDxL5yHuZIFmWkey0tHLun1Cf7mZE0JsGCeApRKxZ8JdlJPCak2Q3IwFI3cRNg9QBFnFHEOnmNhJZf5VuJ0TSu26yZmXtVbqv9pfvvfhH73r0+cfnpjiR1VfpPgJE5TKRV7+ecioHTvVXqaTXE+LIFkKMyGZANAKiHRCdVynm4BoiJ7G8gkA0Qj3GBAly8I2ZKZ4VZN9PKgh8a2aKu/1sqp8lsvsqvfEW/H19RhA5lhPEvZfK1g90TtsB0fkB3ffQJ1585gOfePGiChm49AIi/8OoLsCLIHISKqzwXiZLv8egbuu/x+RWqMwJIv/6VZplxEMCyyeIBS+y9ArJuQOC4L9HqeN8gVI2By/pwbd4VBDw++BbBLVmBUbAhA7OrFnBIISg+Pfymy6EIQo6ROBSOhS4lA4pF4wty6wRiu/6qWtz2wiR5ABkKstq16qQ8lmvD296Ct9G/tkNwY4bgE6IqbKco2xOfhVL7hNrFt6/UGUHZ3j54IL5kc8ohu235gS1+axgcvSkRwST6ZNmFohKzGOCCPrmQRJE43gE4hA0jN9ZTeT3XqVBYGhiQca+MsCsOXqOnRPkRoK/7puOhTQht9wFif1phjr7iOPZsvA8dd9ne+waIuv0pE83EsGELYm7XFKPC4avUdiSussFk5+8SHOSvIFC5sluVr1IBYNGUwNC1i/SHDYhwWTDoJsG3QpoWfsRfH/w8RV+SN374H/ZcXLuAxSc9HeV/5n2JLBx1qh6VvWzop9l/SzpZ5HK+o+ooLJCc4LKIs25OUHN76sAPvUn9O3LrTxv8F+YmeJnVESn1OOEoPvwm3nmA/88M8WPyOaPIfYegdjbRMVufFaHjMihzzgYOX8V+AMq2lkjWoD3RPz3gJ+U7Z9AOg1MZ1Il8/0LL/zgS90ft8FDVsUjouS+PANdCaKuERv2Gfr77v4U4hzLCermoIKxqvXr8LgjmGxfpDnfks0f0S0cI7JkQ9MpYUHVIg3vswctovUjyKP7B3QNvO3naE5Wfxx5aQBQMYA6AGUDaAFQM4A2AHUD6ADQCAA2K7ikdw2SKzcd3XIGyf/fcP7HNhxoL/lLNBe2FmwV+LoMIGgy3eegoyhcijea9qVYo2ldijWa5qVYo+lcijWa7qVYo+ldMhuN6qnyz0MZ6hQEmpZcFAjBULPADltLLor/oFP93lH2urnkWaWorIpCMkHcj1Kfy1O/bM2yWWyWzq9a8HBz8tRdfhL6VlusEkkJ+sOZu3ezlFglbEhrleC7mZWhDlDXE0es8mzBQVcRtiCCQ804ggs7J8n1hAjmEUm85DVEdvlJn0FHLb/6frqb3c+gAt+PQobvZg0quMycBN2HyQbN5eR30A1FK/Taz1DBsqxB+zz5jm+D46iwobJpDqIaE4hlhL3vHeV8vk2mmCUgk7uZK2wpcpLIrPtBukbYcm3O/ZAlHFSVTk2xA325qwOFGcu/F8UYB33uQ5bgoBqNqYerHinBvXXqZXW1eOlBo0ntZnmIqwsxNClWtsj5w/6AWOXbb7bmxID7UwqiwtbPAWFnWQqqfEDYWxgoYRnuCNv9IfWosN0fUS+l3qmNymdKDvwKBku5v8PEgKAi5T5BoQ6uJ8MiJQZAEA7n3PcweGsDcgBCnBQD24njO5IIR6QEdT9oO8JGFTPD+hNzzMQcMeD+N+qnfhlShMYEuXTcEoNIhNOXsNOfsEhJehJSOylpDgJbfkoS8NeXvCS2GHCgDcFL3AYVlmWTvi1Td1lzgoth94dUDLs/orndbFvE/5CCv23uP+Fz0ha2I927QOXm6Nu30RMGGhbD7o+p+xPaFxzjdP+ZCr6dTEoOYfkslOYAfhqvvfbaa0n3VSgfkic9O0MdR9gqDdt9lTqqpdYD9YJqfUPzFeBrNBfU6MBGIgZkKqfasj/k/h2Ft5KCj1I4ofbmZBlR35IDseG35wCgH8QRQ2IIPOGXkfNTWZbxLGwQDzGVWWEJS5L/edyzxZAcy3mDYkB+8veZ+yLzuBhwP2xJ4qXYHIeUB83I4Ou0sizjDwsry9w3W7NiGAQu5sICjGTZxhFCfEvOvXmQSJZhDpsVlhw7Lcfe5g9LcgDqJ8tABL9G75L0dG47oVJA/UpsbI4Ydh+xoXnkvNTPycB+azZMNjtCyBqVj2EJbzYDfVAKdVDqpSRxPCuqGn8QolMdw5BAxh+Ep4uVY90tUuN3u3/A4BOBdqjeGeQHXw98yjn3BepzKEyQu+3ElTZIdOJxNst1byqSUE9csAmemoYuXHCZutzyPkYht0noxyrUt0/6XPK3+Y6kOV/1tOxXB6lICi7Z2/yUSIrU/zSO7w+6oB68x18e91PWnEgFvi2Rkvy0+z7blsTxk8KR/HTOd8KUk+ie81LCkamchx/Vv7JmRRL6Q9VVM5FSTVQ4kEPBRHI3q1DVrm1U7n9+BXAoU5V6WLaPUY/Dp+EeJo68sMI9AtJWMFBOdrMyRboG9B8qugF0CTvLnB6B+Ul3PRbCy7JZ879FZABkgeGXzrLsM1Sw7eQpzKVqgpIcGJeJN4MzpCp/tFwm3D+2lfePUf0y+EkpwA+f4MTfHI47br5pkIL4ElmxuazR1OzxmwYteKlYyV2mSHea9zQ5Ns3zXDBTQ+owwcyxbzvGt6AiCjwnNoOsYFDbLZZz7w1rpfl9klNe3HOC6BfcvE0Q2UKXLdxVg9628jiW85NagyCyozCR8+0Q6yosm/NToUKjqmKCEy/7P6p82SuUr/MtEN5hCaOPh8jut6hZwB6wUdnyz9KciIpVADYoUYY7/7ebjBU1me+MSmvRJuNerclA9ZmotUgjIrJ4keZA47eiTyQF71emcn4SuzmCbwSjc9fq70METgScCDr9ggr7oaErFDaFfrBTvPwI5pZgbMF1hvUr5qpKssFIfubmcZENa+LY+AQn07x5kf6CMvzK8itkeCx4O14Wa8/bLAiO8LE5+1tV64Lhv9iMtMhO45wAkRUAtYdy5EGWgM4qugjvQfspAB1Fkr/jF1S2p4YXKRs4E3edSLrr4PMPpylwQu4XV6+PrbxaQ+h7xYTcAtEGrDt7DFPBL9s9Cp/wRao7JR51SgpzjY4KvvLUFG/jO+gpd+i0gg6K4DAdxkig5oQxNRTYJTnfCcH6c6rXOKFTU36KNOcPh37aCizQnD8Qgi0dME/VeCyV8wbZnCp+X7uWx4xmjTNU2Y9mqAN6x9B/5zyRnseyNhJhadXR0gN/S6uOlh74W3rgbxkDfwsH/pYe+Fuxgb8VG/hb/QN/Sw38LTXwtxYO/C0c+Ft64G/1D/yt2MDfig38LTXwt2IDf2uRgb+FA39LDfyt2MDfUgN/q3/gb6mBv9U/8Leigb8FA38L4tOj52gCYFAMySK9zR+COYCcnjICsBGwKWTrAUvEIMQ2BHMAuaBJgo/qj7WPU8hWAvYEsuWAPYJsLWDPqNgDNk9V4gFfgG8ApihE9MnABIWIfy0wOUFwckIYHwpMTYjoE4GJCRF9HDAtYX4cl8wmT3BOQkRfBMxIiPCrgUnf/PMwRn7+F9aFL7taV6M6m/BLe6vPryd/dhGE7OA1RDbtk356IxFJX824J8MZ9yQouqDAgk4OeUnLMssJLDB+iSIN46cyPKHvSKpRFoIHRBq7BS7SE7zCoGdPY+dBAahqgFxPSlSktTBsfr6OrxXxg+qRFWlJd7ONihMiHbTfx7D9pqEtuiK976df+dz7n3u6VMH2m4Y0ypfTyEPW8iwn0rLGcn7CXSPS0I59S6S38BKbwlzUaM5PAVDUQBVGkwAUFABknmEvkgZloeNM8wbSsuvklDhWbE+zLcXmM4ptK7ag2Y5ii5rtKrak2Z5OpfgWLAAHp+eIciMC2mo5YvUrkZXnSM5dIyyR0M0MC1TF/GNRKlFRyrooUHdCpNlZkdxOYPUmDateGPEhqAVNH4FENH0QlswmOIFxWFo28aWXXw2m2pIQRncESYhL9wKY0ikd1JnmJ2SzQ9z32T73EkJNbrX1KkTicrtJwSz0E/Ah+gl46ydEQjUpazs5Yc2KBPRzfkpYW/gBVVRrCz8EiSJ1ELuwCX7E2yQSkPIJkRCbpvkRRyQAPzXNTwGF7TMV9BUA5OG9B51JAuI6A+0RnEo0kI0l7VSkID4UXaMocpCuUhQ7SFco1jTSZYriB+kuxVkupDt0ChoE0m06BW0F6RadgmaEdJNOQQtDukGnoPEhXadTvE7FkNLRUvDYDEU8A0UPBMn3L38pJSYSgcr505kpXmQiAfpWAZ6gcDFVRz2qOnoPZhvKNOcNsVmxSWw6728VW98KKorIhvRmsRnpo96gIwbleUd+ZhA8z4OveXCeL5cfdscklV925buHdA/Um0Ho+TXyhcEbH/oA/L45444JCqrKoFLFKIyrhjVt6spjEZuv6ylxw3mPoFh+9aVYEzxPp2EmG8gCnYY5biCLVCf8qRnhbCdkfJpPigR8Sv6ICFozUi40qxFBoVEu0815BDI3qvK4IvAMmV+pyuCYEYxBniGCPYGOtEc5TE7xSTEiZ08KKmdPhgNLOsEnDb3wZpH9QKAvzR27S/5tRj6+TGTdMWH3K5Bxjx8bke8eQo90go/5+EYcDALUioAqlx++SiQPLpfvX4+RDGAAw1Hmx+V9w+i2DJufJN4yNitQxdsqtp73N4vNYYvRNIVxAzabzWLzUW+ZI5bJbw9Bs9kqtupmg3501twxMRLmfqWOeV6M4ogRm5e/Kcq8NStGxGax6WF/04VpnhUjYqsASogRkUVqzMGVDN8RQ/hmoKG5OX8AWFexqZxvA5tCVgwFryVoZffXUY9KyA7L+cvDxrIcos2o2EdCzM35y1QSoyGWyvkrVDorAwzKLCCf8PS3GK9jS9/reAW+IrFFvVPibxFbdK0AVVbVguBICJYfDuPrPl7+wI0//fA/fvlX3npw5ph83JEXXIxseRhuRVix+FJVbWeAgs+6XDabijUrlotNIvuwn4WaFcvFVgGUK5aLzUilxHKxBSniiOFAcD+JxgWDQX0+WO+vX+THogWqJ2fUypRyLX+0TtTSlPb+IRU8IYsc619XaUZ9nepNZJEVwQcshH5P6p2MIesGn7KLbPh2UiIjJ2HBo0FwxQMr3mhzYlPfG7p/VJbXi03umHovV/b4YibwuOLqHt+1JvA4utSkly016ZGlJk1BE8YOaxioLL5BoARQDlD4NQ0AhR+SDZT+hlKLfkNGz12oY7eYkAULPsbgJQ6E3SRSWXiTSAl4iQNh7zoQdtQD+gPWr24g6F3NCPdAUtB5elsl8eygy0Ihp7sps/vq67I0MBYHRBzIxoFJo9vDpZp/SYfSEr8yTAeoclklEaBCoSrWAJzUXrGLpBN8j781GkmLrX2v8d5B2RwXW5XH2at4/OiofEJ7DN7MPLyZOo2AYj1YVtfAI/VgfT0Qw68FC+wmUIoDxThQiAP5OKDX2FtxvEljGW4YwGP1YN3fDHJK6QGuv0kkJ3g5U1YKwyZQW1ENLyu1AYBqALgaqAXAmAbqASA00AiArAaaATApKKTYyohN56dBXYEmmpRtdEcM8pGUnQg4gEA3Ag4i0IuAQwjkB0PgCAKFCAAVummhWredjKG9lKUHKo7KUXFwGmslKUuDanBxBrmy5uBtQO1otqDYqmaLiq1ptgRMHRlvU1T1H4m3pvfHWlP3o7HWVH06eH2gnZapWvhbvZGIlG+HHYWN1g7+emQnkc3m/A2687dV5y9052+rzt/Tnb+tOn9fd/626kGu0T2IHfUYoaa20UgVBiKvQ/4A8jAiGkT+IPItEowoDiHfJsH02RHkOyTnu3quA9M6BW0TXMo054+hS5kiACOQ5cEIxFZWKn4GgaICYDwzEoxnAIDxzLJgPGMrAxQt9c6o5PQAxcYh7wpAqjiFYeOgGPRZeI4HJcaxc0pZUvhrzXoIh0cNlVIznBJsKqBFc/4aBOD7VRoHdFzH5Kdc+VQ60GpOmeqP/OCAvFcpPNeoEBsnODFDKJVn0RC+CvG6WIhlVw7hqRCDsRAjVw4hVIihWIjMlUNsUCGGYyGWXznEehXCjYUYu3IIJ+YU0yJfWxlokQPxOH44ABIfnNb0O90i/2i1/NyqxZxAEdwi1qoBxbhWIEX22Li/aT4SNrPH5YUNsqxiWA2f2BoRNKDVImhgK8RW0BgFxnDz+EPz7gXqZ8+LLSKIqD0zHy6LlOf9LaBcChv00IfmBXAVKlaK1eEkyJqokU7wFlWNrkEx5ocwQIM6YrVasU6ws9g/3mTN6kT2zXpaP8rfMotL5QtUJk3fMDsfacezx+/SxQXtKRt6GqtjiTafhwwvXqLsBW+TCFbDbqjPi+wFZ5pXE9H4/WEUcQaAKnM9oUbwtUS/YdrBfhYsyYy5sj2q888PBXKnMJTzU9iHp5AvDuX8IeRdJRyGcv4g8mNKPAzl/GHkhZIPQznfQT4L4mEo5w8EQsCY9p5V/TmMuZuJnO+GPbmrevIR3ZO7qidfpntyV/Xko7ond1VPvkL35K7qyVfqntzt1wXdsCd3w558uZEq9ORjuid3dU+e0T25K8Z0H+6KjO69Xei7JZHlBI4LxmKLmGJz3zf3s1XwYW0O+oYre3xyNPDo7nvmX376iRd/rwILCYUkdpbeZuHKwmeJtg1zcSkjqZ5l/awkhYtWM0nhhg0Lvqjyw5dHZ0VwLWMM8imGWXfl33+e5HBSH0r1eXS7P6Hdun+LfIVGwx8j9/LxAfnoMsyvfWWnlVd2WnFlp9ErOy27stPIlZ1QT75y1bcGgqpffvV39P5lMAcTetwa1vIfhz1DdwZTe/iCv1lsEptvHscGIiKvj8z7W7Gb23rz+IUwrereeT1CPzJzXD6xQX5EZcjqV6Saj9fx8+jnszFexPixGO/G+FSMh1F152skJzYJ6m6+3N2AYnFIJGS+FTRAnJdt/RoMv1tEr6ImZMmgywZdMeiqQddCOiynLh7pM1klfaaqJDJR7e/iYCBZB8WrfzrA6FYy/d1Kpr9byfR3K5n+biXT363gVzkhMtCdzYqMmAClPiM2PYQuF9x5Cgp8BroTSeQ/qUmEDOhLEia9kTVH3cKQLXfJe1fL80NqBA5t98pD9adThkdTQN0SeZyUx++Sj66R71BjenupHlcu1eOKpXocXarHZUv1OLJUjxldQWiXk1GVMIGWORlV0G1om5NRhdkyDcYZGZXh7DQvAqM6n2leAgYT3joN9jsZmFBvwzM7DfY6GbFlmjfhuW2aN5hqHHWm2koNnluneZmLhOw+F30MHYNuRzQOfN8S7wjqn+nvCBSfjfEixo/FeDfGp2I8ZKX3nO4IRkFmt0m0vJmQDWCdkK0DOxyyNWAHQ7YK7FDIVoANJogSsDabH5ri5SMiIVttUxIlZPtF5D9MNd/oRN1QvWN0JwZdNeiKQZcNutTpq+XiCWHJ2ZNqRSwhW18nOS8pLClg9JzYTvKHEL+ccP6QE7yQpEjpBTmkXFCfkBoTm+ZBd0ImBVpTUhlQF37et//KWPBJp64+TfdoSl5aF3hM9X8FGPb4XfKPl8ti6Gds8S8FI/vaMvmXoUeYHsEIQEdMmZl7aYX8p7XoDVfYoCaobIOBgAhXkcHQHVaRYeUYl5FhxdAGA2ncbVKiOW9YVjd5jjL8FMNgj4UWpaZxpFoFBxtefwCs7m3wZ4ExqiUGwQS7b1EclrsHwe5brYYPZ1lKe80yclKm9g+CvSx04I5sbUJL19Ymz3EE2MEDgKZnGe7ohyCyehGXse0ss3KhEUu0mA7tD8z2V4LdqbsSLGeTTrAAj2b9DCriY1RwZQu6jTxFlWEyy7Ia1QaiF69iyN8xDPm1GTxE85Momq6KZp1bw20V97Oc+xdgGdjl8EaSHherQnPoVcGWs1Vq0MOHHXeYOCki/2gUTE1bnNlz9CxYAfwra5bPhvslYJWW6S0IeruEz5WZKQmt8m4J9mw1L2LRqXtUUMHcceh3mxepn+gbOKJBkUiEyxLzMr9JljYpu8YebsbRhptgmnMOoprgPYqWmzS03MwztXbT1nxB8x3NFzWvTTZLLLA+Act5D2wl/x/kDw0vrTCHVpBDTFBbXgYZ7Gk+yCDaXhoZROPL/gxy11ObG/PPUzTSxq0sOrdRvnB4e5GWp+EvbAxh8G5tMI22BYGG7jhfY/Bmz11DpFCL7aDJ6NfrHg92L1pgId63e9Fa4u5Fa5Hdi1bf7kgoRwp2kuLGxi0sMwW7b2C0Emh0V9xdiUE97oAHoEd9dII1AM9WcazFEDbGCVtKRgVHM3IK5u9YEr7EknAoCaboeDAu5mD0Dh509jxwlQK7O6eSZGlVrUWqNzQvsk0TJZX8jt4sC2Zu3wMawLYmoLfpkeiNMMzXGZ/D46xv7x9Um3K9BPaXCb3tVmnJHHo5Dh0i2MEGHaJvjfsMGgGVp35V7SMgXhINwanas8TkCO5ZSsGeJSqIto2HPUuTsCN1N8uCpdRutg2mP4hg15PrBJHZnEcFw/4NLe6FNX75K1KflGBaLoM3KWBvAu5N5lmWcT8MzOxJn6ErlGxM71zeTq7xqZlzcFwLM9Xj7gXbR7Xb0h0hvHhG1A442OADuzMQl3uCFKFfJLvZQbWHBO2ucALggKqxPbjfHPLkqjzB1CxkCmzoYJe5cifbyfKFucpcPVeHFuQKRkwDZrZO9WXrkJ+GGWDM2CFoDyL9IbCygqxsI/f4DJKmmPRtgsE2EEEh+TXoHDbhE8G+5WMhdCiAlodQKoD+bQgdCKA3hdCeALomhMYC6LoQyiLE5SiKyDcP0gxzUJyA4/3Uhw9QKQKB/MMWrXZsY6uO7Y/m/d8lD75LKrjP8KuECByPq7Z5VsWqvzeP648NPmLoj3G3HFQnB+XA+dlDlI/MJc4y+FjzNu4gYrPufdS3UDz+a8ytFRrqWWofmWr48JLhj+Wetx0OHgdlg97m85yP7R9Nc3FlMgkWh7gyiZSrzKGyOcHhe9AWhmjfjqZI6AkNjZACG8I8VXSB4lx+EqUQh7+h2SR81IMyqaoE8lxwpngBupCSA9aaJScX2h8WESkaSBmRspOLDB5LGQyWMYIhUjSQAiIFA8kjkjeQHkbdMxLrItKNEDR7cqZ4R2e9nJni5QxYsWFsFSO2KiJVA6khUjOQOiJ1A2kg0jCQJiJNsyyDWJZBoyyI5A2kh6F6RqguIl0D6SDSMZA2Iu1MX3lbmSlY9UO6ODjFi4NQ55hiyUixjEjZQCqIVAykikjVQGqI1Aykjkh9sC8PjcEp3oB0m+jaNPy3EGkZSBuRtoF0EOmY9YNIz0C6iHTN3A5hboeMEiFSMZAyImUDKSFSMpAiIkUDKSBSGOorIwwf80OKrg1N8doQ1Ab6rBthG4g0DKSJSNNAWoi0DKSNSNtAOoh0+vPQHZriXUi3h649w39+GNvYsFEKRAoGUkSkaCAlREoGUkakPNyXbmV4ileGoc7RtWr4ryFSM5A6InUDaSDSMJAmIk0DaSHS6k+3PTzF25BuB107hv8uIl0D6SHSM5A8mpfnXaNOECkYSBGRotuXbsmd4iUXagNdy4b/CiIVA6kiUjWQGiI1A6krQ3cDaSDS6E+36U7xJqTbRte24b+FSMtAOm4ONK5+KZMMpUzSlDLJfikDFtoxSSMLIzlT2oDRbX4kpyUOcD03p6UOcMWRmNiRrZGcFj3g3lZhzyjfHcUpM/ak7Cq2oNneyFWFkOyO5wJBhK91bVwO9cbjcqiwdoEcyq+Ly6He2rgc6q6Ny6HO2rgcaq+Ny6HW2pgcks21uUAWYW7W5QJxhG1uXVwaldbFpVF5XVwaVdbFpVF1XVwa1dbFpVF3XVwaddbFpVF7XVwatdbFpVFzXVwaNdbFpJGsq2K2dDF7igWhhK9tfVwmFdbHZVJxfVwmldbHZVJ5fVwmVdbHZJKsrs8FcgmrZX1cLNXXx8VSY31cLDXXx8VSe31cLLXWx8VSaUNcLBU3xMVSYUNcLOU3xMVSb31cLHXXx8SS7KhigmjCmtmQC6QTVsuGuHCqbogLp9qGuHCqb4gLp8aGuHBqbogJJ9lSSXd10u0NcfnU2RCXT90NcfnU2xCXT3kRl08FEZNPsihygYzC+hdxEVUWcRFVEXERVRVxEVUTcRFVFzERJRsq6bZOuiniUqol4lKqLeJSqiPiUqor4lKqJ2JSSua9XCCpsFq8uKAqenFBVfLigqrsxQVVxYsLqqoXE1SyppJu6qQbXlxW1b24rGp6v1BZ1fUWyKqOZ8qqtmfKqp4Xl1V135RVDd+UVU2/T1a1/D5Z1favLqta2/pkVWdbXFa1t8VlVXfbAlnV2R6XVe3tcVnV2h6XVc3tcVnV2B6XVfXtcVlV294nq7rb+2RVb3tcVuV3xGVVYUdcVhV3xGVVaUdcVpV3xGVVa0dcVjV3xGVVY0dcVtV3xGVVbUdcVlV3xGVVZUefrGrv6JNVnR1xWdXdEZdVvR1xWZXfGZdVhZ1xWVXcGZdVpZ19sqq8My6rKjvjsqq6My6rajvjsqqxMy6r6jvjsio/GZdVvZ1xWdXdGZdVnZ1xWdXeGZdVrZ1xWdXc2SerCpN9sqo4GZdVpcm4rCpPxmVVZTIuq6qTcVlVm4zLqvpkn6xqTMZlVXMyLqtak3FZ1Z6My6rOZFxWdSfjsqo32Ser8rvisqqwKy6rirvisqq0Ky6ryrvisqqyKy6rqrv6ZFVtV1xW1XfFZVVjV1xWNXfFZVVrV1xWtXfFZVVnV5+s6u6Ky6rerrisyl8bl1WFa+OyqnhtXFaVro3LqvK1fbKqem1cVlWujcuq2rW/UFnVunaBrGpea8qqxrWmrGpfG5dVletMWVW9zpRVtev6ZFX9uj5Z1bju6rKq/sY+WdV8Y1xWNd4Yl1WtNy6QVc0b4rKqcUNcVtVviMuq2g1xWVW9IS6rKjfEZVX5hj5Z1bqhT1a1b4jLqs4NcVnVvSEuq3o3xGVVfiYuqwozcVlVn4nLqtpMXFZVZ+KyqjITl1XlmbisKs3EZVVxpk9WNWb6ZFVzJi6rWjNxWdWeicuqzkxcVnVn4rKqNxOXVfnZk6asKtRJXFgVFWRKq5KCTHFVVpApr6oKMgVWRUGmxOooyBRZbQWZMqulIFNoNRVkSq2GgkyxVVeQKbdqCEWCq6v5QHL1VBBTdOWfIHHZVVCQKbyKCjKlV0lBpvgqK8iUX5UnSJ8AqyovpgSrKcgUYXUFmTKsoSBTiDUVZEqxloJMMdbWOQjkWEd5MQVZV0GmJOspyBRl+SdJXJYVFGQKs6KCTGlWepL0ibOy8mLKs4qCTIFWVZAp0WoKMkVaXUGmTGsoyBRqTZ2DQKq1lBdTrLUVZMq1joJMwdZVkCnZegoyRVv+KRKXbYWnSJ9wKyovpiwrKcgUeGQ3K79JEPnIU4GVExGwWQOwylMk51n7qLcGTgYRaz4EZ5QJuu+GgqAP7PuTn33tO1994L9VWuScWHPWRyFjiTX76Fl//Mo+xw2fbEk+1+zjZ/3xfTX2b3DZTIXAvP2cYNZZD46dQzEMdf11dawcNoZvoI3Xq8pOciAwQ3tEbRDs5ydjfDbGixg/FuPdGA8rvmCuGhpV4OGC7qh7H/U4/EniaVkkZ244VwdqRVihHjQXA8wHYMcAHwrANoCGTT62UsPjRwKPTQPU+15J35bKxv+uzkPkMNBWJ3QQWXpWGeuN6daHLFi0cuPML+UlpT9S5UUYykPxYmAjR2TBoPMG3Xs2orsG3THoxkU4e6tPC6kryFRDagoy9ZCqgkxFpKIgUxMpK8hURUoIRbqIOtqEyPxzUWV2gxd5cSHWXQTrXFzYCNqLYK1FsOYCjKvKGYCvvGepZ1k/21zz+tlilxut3ttKrid1SwzsU9sqnvnuzBSvWWGbxsxWdDQdHbyin22mnrPweAO98pel2lVWDKizQgb2PfyuR9/zwDde+t1ZtfGWXU+qliwMgPEIHOMxm/MzG4lsfWU1HoF7DZFldtJPbSSSym878vxQ+HHhGRDfduTvmRA2X5/5CbB4HDVMeEUCTBtXmEa9ALn+yj5oVIzOixVixbxYKVbi5vdR02oxn5KtYTEKVovbyJiflnS/SMu5/XfjiaJtctLnG4lwbrLUIbPqPN+nRtxr5KeFu1FwOZlDB/me9cjOnkRMflK4G5VVlQPh4cQrBkeQyhU5H3iR8639eH4O+ddow7NdWcfQHBzuK9InvTTYykHnm3Y/YguOQcHoMeU+yzACMNQDI3Kdqvs6xbqbCJhftAluX4LNwkaBhaYLT8F+pOfG5XdHofBsTlLwmzX8Hh0kayQJApDuDJxHtibgc73Z4478wnL53UFVe9tJE47rT4BR+iIJKqPrz66EjRfoX86exDe6BK8T/MAS/R1cor9DS/R3ZIn+TizR36kr+ys6hr8zS/SXp0v0WFiqx+JSPZaW6rG8VI+Vq3j80TLYiKM9VpfqsbZUj/Wlemws1WNzqR5bS/XYvorH96w16rGzVI/dpXrsLdVjni3RY2GpHotL9Vi6isdHMvIT42F7XKrHylI9VpfqsbZUj/WlemwsxaMDvXOJq965ZYa4RYyiiDh+l/zOiPzW2rCtxaLt2w9QGZO/tSJsbGyBUO6yhVK5x/rFsvzpiPzi2oXCWTcjfuVSPT4GO+2CZrRUj8WleISjrhPaOA+plNrvH5yfltjChUfhkfXWiMROOuk5wI154+qE9iZTzz3CFs4bKBw7sEYfN6COGRgHFSkQlTac/4QR7FFHpiTw8MBJRR2BgEgdgrBIHYTgSB2APDooRcNjCRLhgWJIl6g+FiARHkyGtDYgRFobFiJ9Rp0AkAgPHEiEB44hrQ8cQ1ofOIa0PnAMaX3oGdL60DOkgzMFMC8MzxpTeWFTcN6YygubgjPHkO5RPOofaX0wGtL6YDSk9cFoqqwMzzNTdcCmeFnTcMJdRdNw8F1V0zU2BdutVP7ZFGzBUuViU7AtywbVtgln9msFG58ljkbS+C3h5QKhlqr2bE1w4a0QKbUZMaVUcltWeM5zYMLZhtOZ1ftuMf3CwSZfD7rwDcoeCw6H6GGW4FxnfTpEVwFwxpQ6HqKjADjlSO1iLHIECjzYx1hQQJ4Hx0TkuSpbiatieOn/nlKINO67MUsQ5V3lugEpqvzWgVQ5rQGp8tgGUuWuBaTKV5NjDYkVN16Hv6/MzE/zKkdEfalNQCo8PESopklXJRScbNqaUUmYx7W2YnwTeGPneQNugpAdDvbKSgeG+XquP/uUolJQHVx3D2NgPAwHUfIba+sf+N7/Unt0Bja7c3UsVIHjTAWO4er88tMY2tW4whv62dTPdsxfS+Md/exylWQvoZ5NWz0b+lm0lb+C5vN2f3w9HU/e0v70s6ifJf0s62dFP6uWiq8Gz/ZaPe3EZXGtnp9Rsbq6tK7gMM+lRq9cltaGZDkiK1E0+SRU2EW1743LZhrYesDWhsIw1ZDE3A3p3A2Dr+HQV90gt4aJdLcEeQWTpBCNctFZmzM3C+tEyushr+vDGHtbQjK/NSQLUTrNiOxNhCTZzWrb9EuHp5FQfRuUbFtu32OlJ3/3lT+9NH+DrqCFUHkhVFoIFRdChQWQyeYhB42t8eLDQmBQwFZENiOyYXjYFpLtiOxEZDciexFZ2B6SxYgsRWQ5IisRWYvIekQ2IrIZka2ILOyIXl5E9iIP3YjsGKlFfqsRWYnIckSWIrITke2IbEVkMyIbRgw7oyqJyEJE5iOyZ8QQofWIrEVkNSIrRgwR2Y3ITkS2I7JlxDAZFT4iSxFZjMhCRLYishmRjYisR2TNiCFqZ/mI7EUeuhHZMWKI/FYjshKR5YgsGR6Gcl5ajPZt9+PR8Q2jF6Z5Z60Tdv5g8BF+/NsiMkLz2yNyMiSrEVqN0HaEtiO0uCMid4VkPULrEdoNUXeL6nmKa2GCSZZY0MG6eD6JrdnC6lzkasvm66H4qAGMKkUH9dSUVkz3KOoIqKgprZhmFXUQVNSUVkzHgAoUU1fBe0CQprSaeUBRoHweVCTopIcUCarqEUWCBntCkaDYnlLkKTgrJhVopxWq6KbSfFOBdlrSdF1pvqlAOy1ouqo031SgnZ5RZEcpsKlA8axruqcU3lSgqDY1DQpsS9Og2LY13VbKbypQSLtBUgwV21SgkOaZzppShFOBElrSdF0py6lAye3gdTepsI2mZi/4K8ITc+f9leEhtvP+qmkVzappFcWqaZXEin4/ee2G2Vo1rbIaxPP0zLw/Nq2KNTatijo2rYq/ot9PQ7vV9ROrceW0ekMrp9XbWTmt3syKafVWVkyrN7JiWr2NlVoBfGpm3l89ja989TQ2gtXT2CxW9Hs4pFwOqscBVYKOzkFVx3xGuc5i/Eph+yOoq2ls0iunsT2vnMbGvMLwsGIaW/WKaWzSK6axMV/OcQreAAz/fP4GaomU4G+g0R5hb6VIh0cfIJVSB5A7emiJFO4FQwr3hzlb+B6PwmPSWwOPrDcu0mIUcp2GYWNWpGEsOSnSMJbcI9KwKVES2VLKUnofnkCUNnW+gwo9oR552u96SsEFqp7lmHNR4xX9rMfcqxpv6Gc75t7UeCeGdzWeZzp9BkeMwyhIdcL9mdCeynDb073vuB/2CYu0oshHIWQVtkULkYI1Ai4cmM5wt8Lh5C/ZOVn1hYkVn3FysrSxD8v/6QjUYnet+0G4vY/sZn94VHCZ3M26a0HQgJIov/lG3V/CEhwckpTQfP0FEna+dDcrH9XqKURRfYFE4sjw10BapQhxfOdJGqqntZ+RHKSN/frPSF/a5c/QvrQLT9FIgYU49G163SdpJCcNOm/4LyId5eFjj7AwD/k2DfNQaNO+PHQ+yPry0HyERZIMaJ2H2iMskusG3TD8t5CO8vDqAzzMQ+MJFuah+QTry0P1tf48lN7JI7Ub4tB5yL+TR1qEQRcN/2Wkozx85qUoD8ULPMxD6QLvy0Ovzfvy0H4pirP+UpSHxktRuk2Dbhn+Oy/15+H+p60wD637rTAPbaCNPNSftPryUMFwKs4C0DoPxaetSNUx6LLhv4p0lIdnPmKHeSi/GOWh8mJ/HgqP2H156H7EjrQgoHUeWh+xI63SoDuG/x7SUR7e+2AizEPn83aYh+7n7b48NB9I9OWhhuFUnCWgdR7KDyYiPc+gq4b/OtJRHi6+HOWh+uFEmIfahxN9eSi91J+H/CtRnO2Xozx0Xo7S7Rp07+XIf+GV/jw88sVkmIfeu5JhHvLvTvblod1ImnnAyYUvwr13DYxARV4BWmem+sVk1EEZdN3w3wW8AGf8Uv3GAHgnLCUHrxOA++GAsKBtA/COfD4/qfivhkmm5f9572pIBi8EKSga76vI37vaEAAw+ZVfrYjSvauhNzf8Vgy6atA1g64bdMOgm0D3LbSnZeteVIKLSSVHZf63F/op/Db6+RKaoLCzIiWtnJ/YTmDPeloJ/vrd9VADAM2Z+M44KBBQEh66hH6FI+n+cVBByKKObP843qcRnrE8i5Wi/Yq6F8yL3Vh3vNF+qVnBOoP6FTiTtUKMipUwyy5WHhv3V4lRsermcX/VeXeeeivESqGolSItewUIowB/VAULs1cul/3RC+qCkS54XCkCtgPsCs3asvZ4UOW2/OTjq3Vrwgtkq4+vhiNjDQ8Ng26CZ6o8tzCgfITqwUnxichfwaDzBk3eQMtPQAKlJ4yXCJcdgesjT2CMD6rRj413Qn0OfFc/F3/ltqx/zsiiQTcNumXQbYPuGnRnkbh7hnv+80axDLpk0MXPL4yjbLhXDLpq0LVFwrUM96ZBNwy6btDtReLofF6NG5P61eS/aNTJ3y30XzDcSwZd/OIi5TLcKwZdNeiaQdcNumHQzS9G7a5l4G2D/i9fDLojW3bRfzB3a8v8V0J/ffOoX4YGU/iKUQiDLht06SsLC1cx3KsGDRO6X1mtmmQDCFlbJLS1m9XB0c2KFNxLAsc4qQukmSzznGeLJJiZcLg9ajtpwXpfBm5xnJzC8wdtPC5/UlFCHXJo40BEKMpVRxvaerI7o2+ARGv5TN8xkHti/GSMz8Z4EePHYrwb41OO4JHJXQZM7jbDHa9wQiPXB5En4ShrSeQ7VAeR1LdZlpgiUzh6QFKNMphavIMFC2+NYLB4lwAQFu/wlqqWBWb4MBJR7SYpEm+gNYhjDS4cJdHWEp7jOCJhenqEQyy4gsf19V+TisIVPKRwBQ8pXMFD6oBaUGDRCh5mFiY6KlzRMP9R1jQI4JKmYbakqGmYRClo+gwu8CB5CheQkIRZkraGYZakpWmYJWlqGmZJGpqGWZK6pmGWpKZpmCWpBrlhuGSQDA6uKmoapkYKmoYpk7ymYSqlp8PCFEtX0zBN0glKy3D5QdUCwyUIlS7DZQiVH4YGbSqfsG6naZgmaWgapk+a8C4pvFNHvdwyfBxtK3y5TC+I46tQi1lItln4JnowPWPr/MO0jY6/A9M5mi7yKV7Sfgp8ihc1nee4FIN5KNs6D20AKraZh5bKQ3DRD9ef66SisqoB2XqOgOvPdUxRrmpAtp5fwLTaQVrlBNh72nDPY1heOMXLxkJydfw1FMBSp+ND/i21VA3Zt9RyNdQCVyfiQyVwtTAOdcDDJMsJR7+zy+Er+ElVLDgIaguvWt4auE9DZakHWaonjO9rzRQcTY3fVTUBWexawSupWeEr6VjhF9W2wk+qZYXfVNMKP6qGpb+qLbxuhVnsQRaNZc58EhKrWB5XOfvtJBytcz0p4LOGJyInZQn16a6aHGUTvGxdxSbiWyvhZEYwNmATvHo1n38xpI1W+Gz4VmCBmZ/OTfB2n5mC/PZq7dcJayf0WjMTuUU+NCg/Gxgx4AlveqtQRs6ehCPJ4AbqB8HItXQpMr0tGnTBoPMG3XvOMOF9juR8W3Owy0ob0Zb/D7z/cIEdb+PSAjve+qUFdry1SwvseKuXFtjxVi4tsOPtvRzawYNu2cCbmy8R4xhddcezJPK7RPNww2xY5IjGKak7wFz4EsnBDXTKoJ7rLWFwA3hSdr+uSujiHRqWu2JebezqDuGtFqMCT2Xr/JrPMEAKu/c/pDlZY6cA2aKatFSI9gWHh/tr9tH79n33E6W/+cj3/uDeP5s794BYs+9ncDn5fXgQKgrHM/fdv48WHvDXqB1iYBYvRsWafesK+772ka995GvkPrHmAX/NvpF37svnSy//7LWHv/ePAfa6dyr5evEn/14juwtizT6n8MBj0UHzmirvnQ+PoS/rElaGdQkzSynTzylRZtES4YFynV+Dbvr/vZLFdtWVrw3bRs1bYKZd9yKb9YiErRwBXY3CV65dEL5o+ITdHXH3kjo9vmqpjQ541JxIKIt9OE/XTxo2+3Cirs8BUFtItK1+7Qi0+Xafsb4Hd2KXXkAMkmgybcEPd0Yat37DjZLRxahwBl3tyBQvvkVfJYl3yWJIWx0vaKtDuG11CLetLEZsbTFiGLBn4KGu4MbdEysFcVddxvJw8Kvz5xZNnoWNLOrW5555oC81T8Klptl2FwzHBVX9LfG50d1yQaPbE8BKcETWVguuvKaW7tVdutexpXsVS/eaXbrXySV6xUvuiaDzPofjiNWd98BasLiBrAusDUseyI4Bm4CFEGQFsElYKkE2C2wKFlCQnQQ2DcsqRPCH3P9EBb0wjV2oFXIHBBF2yB2EJh5yh0BOhdwROHky5E4IItIhd8p5iDN2js+pu3Pry32OvSmcpsjj/RNOz6v+SfmCDcE+XdBD0aCHsuM9lN4GtYS4IWa2IGYWxGzFY2bqY+O7WX25oGaXRx/wabzLQ6yvy0Nkd0HQK3Z57h+HX059/mHBzDTYLyiNG8e23/i//sRbPTvvPkTnnU+8jg3PWWdhA8WI2kBBBM0SspuE+9cE3U6s64k+a5GFu7U5HIaZ2s3wlls1eDuTwfMk4cJshkcgRwcuJnCztqVc4e0z2K5taYXZhuoeU/qrFdh1wqGLlrFL2w7vf7XD212RCm0jrchmEg9dtMx92QmQIAktQTiej8iMjdgcz0dkxkZsLBXs285nYOYYXY1N2VwWBzGKjBEFIkUDySNSMJAeRpQ3kC4iPSMrHUS6/VkB/a0NWSljnBUjhgoiVQOpIlIzkBoidQOpI9IwkAYi0RZsTBd2fpcGoSxDWJZBoyzoP28gXUR6RpwdRLoG0kakYyAtRNr96cJW7CakW8R0S0YqJUTKBlJGpGIgFUSqBlJFpGYgNUSizdeYLuz5LgxBbaBr0/DfRKRlIC1E2gbSRqRj1gkiPQPpINLtTxc2fNch3cow5nzIKB0iFQMpIVI2kCIiJQMpIFI0kDwi0c5rTBc2XfeGlH0e1Ibhv45Iw0AaiDQNpIlIy0BaiLQNpI1Ipz9d2NyNdoFddO0Z/nuIRDurOR4zyIyN1RyPGWTGvmqOxwwyY1s1hwEA1NJwX7qwpbsD6VbQtWr4ryJSM5AaInUDqSPSMJAGIk0DaSLS6k8XNnKXwe6yja4dw38Hka6BdBHpGUgPkWgPNcejA5mxhZrj+YLM2EGtxuLDU7wF6ZbQtWz4LyNSMZAKIlUDqSJSM5AaInUDqSPS6E8XNm0XR6A9jGCHb+yQ5rI5os5db/WHgW3WjREQOWh3r27sWh5qTPP+qLr1Y+TGQ/8xO/7UD/5hZr4MB3c0RvxlN+69+bX5S7//4Zl5vIjREsuicGK5GIm4clnZDS+LYhGjYiSKADw0Rhw4aFtdJQH3uLe+QXL6DmhgmwE7iWwjYLPI1gNWIFsL2DFkqwELUyBkC6/8b8p8mchO4HIA2W7AHkS2F7CHkIW7fPSNVsAWAvYEssWAPYVsOwg7q6R0CidNcLStWM+S5WVwsTuV1S14PDuAcMcqCm1D9Nta3uPUVHRQi71A6sPpxyD3E0riJ3J+Qs9ooxH/mJL9gam2DVs0E30SP4ES/0y47yFvbIcoGNskYMsEXEoBVvbUONeFwmyAEvkUT1JmwVEsFI9RNjUAiocvmxoAlRUnJvWpLGf6pT7VqkHRQJRyUTCQQkzqUzx82ZT6FA9fNqU+xcOXWbD9meIJyyw4ioXi8cqmHkDxeGVTD6B4vLKpB1A8XtnUAyger2zqAVS2Mv16ANW6TiT7qdZ18gaSj8l+qnWdroEoXadjIErXaRtIWxWzpYsJ5yyz4CgWqrWfkpGu0n7KBqK0n4qBKO2naiBK+6kZiNJ+6gbSVEk3dNJKTWkaHpQq0zIQpe60DUSpRB2zomIKAdWKVNfM8FC/EkC1+lIxEKXilA1EqUElA1GqUtFAlDpVMBA4i5kFp69QPHCZBYevUK0G1Q3/Sg1qGIhSg5oGotSgloEopadtIEox6hhITyXd1UnnY5oB1TpNpBlQrfcUDETpRkUDUfpTyUCUjlU2EDh2mQXHrVCtDFUND0oZqhmIUobqBqKUoYaBKGWoaSBKGWoZSEcl3dZJK32oY3hQ+lDXQPIx/YBqfSjSD6jWhwoGovShooHA4cssOGCFapWobHhQKlHFQJRKVDUQpRLVDESpRHUDUSpRw0BaKummTlppRS3Dg9KKIq2B6vPBunDFYw/Pak7l/FRUJyMAuTk/HVUKQmPBdbZYKwiJ4MpbrJYRNdLUd0ZivSA0GVwIjHUzgifB7NH1gh5mT/qJqGJG1NRbzmdR1SAG91Emo8pBLLpdGCsDsU54wzBWGWLt8JZhIimKY8u8w+jmQYLXPPUB6TgwEAecOJCJA4NxwJrge/oBdTJA3NOBOHAwDhyKA0fiwIkIgBvX8XqZzoigwr6etEfgGxnRM7QUTrYOyPyykCxEZDEiS8uMywr9EWNZ5vxa+efLxIi6r3FPn9OfZ+Bqde2UukKoRDzCvlDuFUKxq4Yau0Ko5FVDiSuEGrpqqOwVQrlXDTV5hVDDVw6Fs9xZVjrkwRSgtZuVDgkblUo7y0iWWSMUJmi2kftoeI3IGX1TSXsEJqJfcJg9NwSTVk1b3YVEZPkbBBc+YEGo97yi4cifksbhfKCuxtOgHGt8AHRujcPCQkHjcKFFW+NwzlFe43AxQEvjcGh+7+uKhgPlmxofEWSCd3/NWwbPxmFvOVyXMqEO2YfFKp+5K2BEsgyGGSUbXKG3h/ledBkRLriUlUvXcBkWQ+BSUS49w2VQZMClqlzybuTiiAFwqSmXguGSFilwqSuXouGSFAkcAsEbUit16qL4w1Cjz8PFNrIdgFj7CuuYWEVhXROrKqxnYjWF5Z83sLrCCiZWfB6W+QSR55+Cy+UInlvF3BU3/vvRR9/8wr87PTMPlVw8XFb5XOhUAqfSok5lcCov6lQBp8qiTlVwqi7qVAOn2qJOdXCqH3bUBfJYwbCU6bNo/QguxjoTrR7pq+XVFUVgthKtHeE18cY1MC8gBheU6rUjKuEmIrCZD5JjsOrg/hY2ur9H77DUVOCw/gQ375RfUimWLb3YpPmS5ouaL2q+oPmC5vOaz2u+96Lie1wvTWu+q/nKSwSmAuA+ex2iqmOoar6m+Zrm65qva76h+Ybmm5pvar6l+Zbm25CiDUhbIx3to6P5rua7QRk03wvK2NFltHUdaL6g+aLmi5qHk8lA+thwvBcTlrDd1WsEUUsijdvkwCm557acz3Bl0cdVwG9iHtUU/HZCxrU5VR5efQFePccrKTE1zbqKLWl2TH+bmhX6s9RsVn+Rmp1UUya2/twYXrIJob8ZfoIML+GEKEysqrCqidUUVjOxusLqJtZQWCPCqLpk0nmQUTanj3WyoIO/CS+2E0rBEzQ41QlUNIUz5ODoTONQJxevdBPEfYX6VFD3x9T9CVW4jfiPqMfwPjYiifs95sGUAseaYXNwFxqsGJVXCNv9IvOpmvyggv3KIBO4vYtJelrSux2fuT8BAK5EgiRgBQouE2O4FqVmSARxfwCzFHhvI3H/CO7/Ugzqhzrz7usUi2dDWepsKOenw2z2LNYHXFK3Hw7k8t4M72rS24hS2HsdvkNvEzxOeJvhUaZeFp4t6m2BZ5F5W3GqjHkT8MxzbxvEkfWGUP57w9gsPBceR7x18ChRbzs8m9TbAc8C83bCs868SXj2mLcL4hDeCGoe3jJsad5yeBzy1mO61LsW06XedZgu834JnjXmvR6eXebthjjGvFHUebwV2Hi9lfA46G3AdKk3helSbw+mS71peFaZdz08O8x7A8TheqtQ2/LG8HvwVsPjgCcwXertxXSp90ZMl3o3wLPCvBl4tpk3C3GkvDWo53nj+Il5a+Ex63nwOONJTJZ6+zBZ6r0Jq5p5N2JVM+8msR8otXzrJ+eB2aPWs1PInFIr1on5Mk5cVqhalk6jY5uqlecBNatZYmp12UHHJlMLyJl5MPD2UQLR8/Ag/uAFvBr5POq1+BWf968Bpw4th5YUMC96SOwXa0VyXngiNS+kwHzsE+l58SYBqd4onHlxk1BprEVRRs8LFX3K986LcbHmvL8GNZy+qP1xWAfeL1ZD5AIi36sifyNEfgNGPgORz+rIV6MwDCN3fXFejIlV5/1V4NDrj3wMlpX3i5UQ+QaIfEpFvgcin8bIr4fI36AjX4mqVxj5mL/hPJi9n/dHwSHP+iJfAWuK+8VyiHw9RH6tivw6iPyXMPLXQ+S7deTLIY5mGLnw158Xy8TIeR8Vv0J/5Mtg+nK/cCHydRD5dhX5Doh8J0Y+CZHv0pG7EEcrjDzrrzsPat95fwjVm/7Ih3Ez5n6xCWLfDLFnVexbIPatGPsExL5Nx55ERTSMfdJPnBevExvP+ynUkPpjT8OWTzYrfOM8IDhXZG2MXx3jV8b45THejfHJGH9NjF8T41fF+NEYPxLjh2J8KsbDlxODvBgvYvyGGL8+xq+L8YkYvx9OtkuIxHn489ZBIsbFeEiPibGQXiFWhPQysSykh8VwSKdFOqTJdlKGpZP9+sLMg4qahAWF/SBhCFqrEgULWMxAagzWMZByYXoeqRRMz+9Xpj5wubEr9ov9MG8BF6oCKXIg17jYD/Mw6spZNFqBO54tTaV87JiwByN63QVtWSw0aLncwyq3VHkal0DQsMVC65bLPbhyc8vTylgUrFwsNHW5LCGU21h5WtmUgsmLhXYvlyWQchPlaWV6CvYvFhrBXJZwyi1bnlYWqmAMY6FFzGUJqtwmL+v1kzAaBKtZONoxhRu0iRjCDdpEjOAGbQK7dvLwVJuyiViDm7KJuAa3NhORxA3ZRLi4IZuI5bghm8AW5gY8V+MmbCLW4iZsInzYCi2J92ZH7NdXYL7Z+QPOrLP2HDZTn6keh8Nj1rfKZd/uOwSBCDsy+3jYZ9H3jIZCISvYBRUX1sme82hkh3dD66pwAUoFUErX+DR3h6FiGAwjjvkJYQkqEpJLIhLjOWXvSm4e9xPqAGKRkDZCSNKc5Kf8pIbO4+qQwlIBdsW84+BHJCW/zU+LVJCSoCIF0IBIBtD5/iKqYkPA0zkoCgxtIUTSiCIh0gFX1kmlDP+pPq8DfV6d+1IscXZwTh0gmlL2M2qs/JbAUI+GinpZs1pRr2hWK+pVZGFmMh0NjhWWzfkD0eBYYZM53wmxhsL25PxMiDUVNnvSHwyxlsJgjnIoBNsKhEnK4RDsKBBmKd0Q7OocH5kOLY7V+NEfCf2ASTJM0JGcvywEC5dUwDPToTmzGrv6y0M/JQUWaM4fjQI+qwIGkwDP9lVo6dm+Ci0/21ehFWCjuqziychR1QIb1WAd2KjyGsBG9dYENqqxFrBRXbWBjWqp82xfLcFxyiKqHzhpWUQ1A4cwGzUD5zOLqE7g6GYR1kaWFd4Cl2uL1OXB5FjOBZv9NJbfU18pbinCfsIW9nnfEhbIBC54SDPBkD4Kp9am5XlHfmYQpt7mwdc8OKvD/SSVX3blu4f019RTR/4+v0a+MBgeYgFmisHxXN+fwR094ZHWP1WHAhDBdFfJdVdpq/MrYJ6MwyPlMXi4ng2PMc+SVL5ipJyadceMvKm8WsKaB23m4fDG9+7j5Q+EGweOyccdecEVCZgr7eseLZG44FmwbnzBg6N6Exfg0mJ4MEdlssNi53IX4LZiaxo27Kjc61J1mSNSeLiv02SMn6VzsvsDiuWSPUVYMv9DJGAgX38ZzOJ0TzbNa7dDO3pZDYDbOABWy/SKhjIS2QsYiKD4gmLK5bJgNz6xqvKjZd/4h8fny7qFYvQ3bvubd//No7/zKZhqwrmjINqWGW3XjLYQRaujaqioIuMJGAUoE4OmGU3HjCa/IBow+t9O1JRs92XjSHGDbod0Akb4KHF7tzvOZhLtCOgEOwJ0hOiPKH9fZozOUZwKpid9BjdCw4pA4BG5C+F8IcMpMKoi7r5K3XM4iIcvpnkbjDAYrEN9X9tJnEG2E7B5inzr+6FVBYO+Cro6iE7NwTkQV+12vAm79wOqbTwYtANt/sHU/AKDxqK3kzEwAIe7y1U5dTaZyp2Zf7Ig7yTIO7aqKHMpZMOiuMiGRYFL28WCnDPZBI3D+bpF02e1HPOVCc68n8IB7bwyyUnN+2lU4jTvzoN5BzzLZTVQxAuyU/NqYJdAXWxeDcQcHBHD15uBLzmt7tJ25wX6ysJ8NYy3wcPg/Hl/AJU+mN/GxHBorUbVY5dHOqisXR7flMt+Yv68n0QtEKJKz4uUyMyDWgzKH7TKh7RkR40PEmaQD4EZh+QEJnUAJr/ZBD8IsbDLWroOmgqCHtFBT+igp8KgZ3TQPNVhC1QHdoPARapDl6gOXqZh+ArVEVSDCGpBBGNBBPUggkYQQTOKoBVE0A4i6AQRiCCCbhBBL4ggz8IICkxHUGQ6ghLTEWSDCMpMR1BhOoJqFEEtiKAeRNAIIph03pWgzln4dOWXYKuWRwJZFXU1N8PYiAj2sK86yuhEL9Dlpjkq46iOstAwHpoYsNowHhoZsAlVa6AtA5tUdYAKL0NLeKX4omg5f6Us7FmYhYrOAsgSPn8eIrOV5Tyd4AegFSswrQzoL3+eB6GJK3BA2dHTCTwOSYMMZmUozAyBWDuPEu68uU1A5Yg/DCU+ZeaIXwCoqnN0RiQwfBrCCz7vOzD1gE54JT24DQRuGZw5QEc81gkcWeDI8awnirNTCZHAONPz54UjnPnzvhXPmfUwVH6FmlmzLkC11HTWqqh3Y/oQTwbiETa+s6rOhTrLC3MBXnjgJYFDI4pzY0mRxDgGMI7M/HlVY+YQSOXIfhhSb/flyMYc1XWO8OSpJCY3gMlBbKr+VL46mCgey5VCbwy9cfSWCJOONxx1Hm3YgEAlMlvQNG+AouE8+GGLbz07PZc8B7csZE76ezcSsVfPxytxk0C+EvA9G/lywHcVXwr4juKLAd9WfCHgW8hv4fkjU7xpi72ykMjpFaNgrWivbMFOJhTywZrSXjjqU6/IacOEvbKBUM2E6ghVTaiGUMWEqgiVTaiCUCmCyBZePOzdLPaCXZ06Y2Kv7Azo/YN7ZTkkxc1TvJwWe4HtDqhndUDsxZOdNN8C9xLN+ZP7dIJFmvMnAgYGG7sDBoYjuwIG5jxeHzAwmNmmGXVS195wXW2vLNOcuio8WMo7ADkmObEXltn2yt5ADvJt5/xprcnvlXkHMNhjvD3ECohV7Zx/bYgVEavZOX8qxEqI1e2cvyPEyog17Jy/M8DE3glesqd5d0Dowuti6wLroupC/rziNb2ciJULjCN1GvhynZyIClhzciIqWt3JiahQDScnouI0nZyICtJyciIowi8g27VrF2S73Z/tTl+2u33Z7vVlGyw2o2yDRWeUbbD43BmN0x58i7cblmuSJ/1dG4nYBcW0c/7rcSbulNglXo/TcCcUJcCCF6kxMO1FyoW5O6RSMHeHFBjvil24v+b1ck/43e6SDQ5IgYef7eu38Bb3boZnm3vH4dnh3i3w7HLv1+HZ494JeOYt71Z4NrmXE7v0EcW7xK24Z3+XOIH7+HeJX8e9/bvELbjff5c4jmcA7IJvsGSpcA3gc3jGwOu3kyZsgt4lG1bOn4D41fowkiXc/I1kETd/Y+lgubdrKRqWgjuahoXotqZhibdgKxqWf/OahqXhHmSDQvYd8foJ3oK97Zivlq2eZfBM0eRiF3yO3gTks2T7k9asyk07yiMs3U4qElZ1s4qEBV+hyB5uZkeyG5Wno8qDRxrYjkq3kFTPtg3pNRJYL20bXlnZzskK1W+RgldHTN6E2dmNi/6TijqhcrAbz6oQijqk0t+NZ1W4ijoAqU+I3cFZFSTKyu4sI961kngTkng7YMSUPOlPwYgJ7pTxtkmordmT/uSC2fA1korJCZ5aFHUXRccWRcWiaHZRdDKG8lmxTUyKCTl5G/aje/ouLphWpmj92AQ/EAcOxoFDceCICXjbxATYkE8oG3JJvWk2K7aBpJ+EOw2MMfLl4pUNvgxAzQRC8q0qdDEWuhIPXb9a6FIsdDUeunG10E0eW4+YnOCtRbD2IlhnEay7CNZbBMtbcUz3E1Cb/W7YCIqLYKVFsPIiWGURrLoIVlsEqy+CNWKYA5kvgeXaJJ5XMtHf/sRE/xdzFwBuHBiLAyIOZOOA+WHcFeQDO5VJ1DH+P8kHAHviwGwcOBAHDsaBQ3HgSBw4EQdOxYEzcSBP40hhAVJcgJQWIGW6sOpBzhiDALh5K5w6U21cEm8bg5cDtz1MoFUAzGBMoEkAzGrA+/BhgFUuLzqZiUuk+JJ8CtMa8HZ8HIVP4Nbz+XLcNxVUTZfigOXnRTvpWzraPb6to51FA4UF0VrzOEiEidOFzjAgUtOzCXS+YqppsOOFKUQ2fx5S5hAwIShwSZiNxZme+fPz5ol2hkHwNkfCCtS2cW/aEdOOPz1IQEsrc4+pF+JRMSUmUdcqazKLB00jKXC7EJJjuIsISRdn+JBMwdwfUjjNNyUrNCcmYXHl+kDlmpI9nlPvNFC5JrXKNalVrkmtck1qlWtSq1yTWuWa1CrXFN4FaIspULm6lpgClasDz19HvWcKVK4WPI/jcUlToHI1LBWuB3wOVbWgK52SPSvnT0P8SuVCUqlcSCqVC8sHKlfZVjSoXCVNg8pV1DSoXDVNg8pV1TSoXBVbTIF+UQcbbeMNXady93+R9/YxjmXZfRjfe/yqYlU1+2umamp29r43I6lGVSSrWd1VrCp1N19Pf9R87G5LtuW2Zdm96pbQYE/sntUG6AQLD9d2Eg6iBIwtA+y2kyXZls0AMsIEDpYIbC9lKErZThAmdqSKbQUFw5AIGIbLiYAwgOPN/n7nPL5Hsno+NrH/SQ+meM65591333333XvuueejlpTfAS6xaE8azJk7lIfZnuOwlSJ0SdspdBEUoYugCF0ET8InEqGLLaklM7DQMlurGAz+wKm4u9KIXkp+68nxhLnj15MVmTYDKYyV9FIZswNR/4kpbsSWv+tZbWheSHpqgDwVpGoR48DZoSYFaE3RuqB1RRuCNhRtCtq0TNHYGL+931iB0ehvrNgfm6Lf/LUVThf33CxnSvcsZ1D3nFkXWcc9z0/WvcBv2L3I2cB9hbKTK4KVO0+py+U8tewuUF5zF/EDS2bIdO4ZCD2broOfNTeOH+Mm8LPsJvGTdVP4SbtpbpPcObPOycvYPLFfCtMQmjMh/JFZjCILUSQTReajiBVBYOH1zHNM/JkXN4lnXsIkn3lJk3rmpUz6mZc2c8+8uTCSZwg+XMURsZl7uOohQFj64aqXMkmTwrE0Tn4erkKrbRIPVxGPwMQfrnqOnmn959cfUva2cd60roYHGftjsxsv+zGznt1ctF6DW+iSeeXr5oy5iOc0F/CA5jyezJzDI5mzeBaT/fpHqC0Xiy1ayJe7ZQuGOXDdrMNKogTpMrdtx8dKIv/3HJMzJf//cN5b/e4LN+6gPVu+801vo+IV6A2yK4dnuxCIecBTgFWDx7gsBSo7NsQUfsNYOPpzpAAR8zZMeKew7yLd7u2umg0q/ls/mIWbcmXX4ZXGeTZbNnpprVgkxtgDrdaBhQUv3cU2p4AzB2luAs2VOmus08Lb50VJ1PVgFX8jb1l4kQ2ocPpTmcTE/bE996xW21i4f8Zsoe+31DuUHY635f+es23H/d9z3FxGR7pnyeobH4+SX/Ec4zRNzv8nsQOvsApzDHT1w1XPMvGbP72U+6/+03/+z6+3YdaM8QVVNFd5a1JbuG4sWc3jaiL+Z4KaP0+dJoPNyb6FejapelgTiGFeCGWhwsZ8wQlg11FWA900oTUopHXGWJeAQOt4C/cEy/rWgo3xvp6VPTI/fHTG+HS27VnjbjEh+HD15p//zR8dZvJn/2bz4V6M1rIY8egxPDn2DOMUUg+BDyN4BYTRNKEanyLUpgn1aUIjSvDj7+I0PGzjLWlJ+uZf/nP2fxKlcMo1+owX+IzBCzIh+HBV+LFk4PFyMetWhgloi35tS7WURSRJCUAsP3GQwtJhWDoMqY1LIXh5DB6G1MOQOgqpo5DaKYbglTF4FFKHTiX7Nq75skatLsJRKswyUvR7FyI5SIqSh2lcms2jjt9YqfCrwvrVdTye0xexl0UTtVCMD9pNL/4AXRNRhwdv4nvtbNuCRl2+Tsxkw99YyaAb/8eViv2tyJwy8QG9Fp1scG7BiydZ4O3wAlUhhm3orYZ0HFbYlBB8uIrYyP6cu4shW8THUdp1OoMVU/S7gxWIC1x+8TEV/R4p686BoH1F7wp6qOg9QQeK3hf0SNFHgh4r+kTQoaJPBT1RtGoJPlK8pnj1fxK8rnhN8YbidcWbijcU7yjeVLyreEfxnuJdxfuK9xQ/VLyv+EDxQ8WPFB8ofqz4keJDxY8VP1F8qPhI8RPFq7Y+v+I1xav/sz6/4jXFG4rXFW8q3lC8o3hT8a7iHcV7incV7yveU/xQ8b7iA8UPFT9SfKD4seJHig8VP1b8RPGh4iPFTxSvcjEvivppl1GOiwyBbDaZX3B3PDRrQmw4FW9rTKwLselUPH9MbAix41S8G2NiU4hY+t8ZEztC7DkV79aY2BVi36l4t8MPQ4iHTsV7NyBSxHVfxYYY6sfYY6/wVswUzA7PV3J+qWJykNizW5Ro3Dn8GHceP8tuBj9ZdwE/aXeRy7m7ZJdlKvPWc7E1Kk4xmR2lZVZeg76wYnLZy2bdzO06nZRZN/O7ThO/mV2ngd8FhhFdN4u7Tg2/S4w7uq7HAF0F07tOT8HsrtNXENl0FDS7zkDBtV3nSMHNXec4Zdazb5v1MBXfOjz3w7l0fTLb0/pEtqcFKxNOU+tTIfTi35qWe3AqPN5tt0+f4h6stow9ZnqR/StWKzQazdz8j/7Zf938P3+je+1XYCm1vmYfpb2SH/vALVMUzUMU3Yd8ljP7FW8f8ucGlAhWy+NGHtJVN4WoIc886+bBf/HXn//vv/XvXnsoCoQNv5mueFf5GA9uRabzn/toMWauUgDMmH1oKFFrNd5ycdEwVXH37bIp4w1vwInR26BoaCwwx1pcebSy5fILCpj7Ik7mIeblIebZInX/6pJvVbbtX13CBD/DBCeedVMiC4fRIFvxLpvLuNkPNlrdlInYpZKyxL/zMMYF1N8IV5blcjvyAlovlZU8iwYNYsu1Dif44Pl+sMXrwXxAS45ZgruASBYtGbLEQdlhaqLkJCwZTJaMwpKjyZLq2XHJ8UQJXIMS1NS5SdmXpmRfmh7vS8/IvjTL4e+e5QfhnuMn4p7nR+Ne4GfkXuSH5b6CIc8bWvzouKFtTbSnrsWvmOxkQUMLLpozkwVNLbhg0pMFHS04b1KTBV0tOGeSkwU9LThrEhMFaOzAgZoN3QQD9mP0wjDNrwMadZRF30RQcjxdMgpKhtMl1TktOZkuqQUlo+mSelBSjU+WyH5jKOrHxhz8YefQV3PygJDKJ8dBJywZTZZ0gxK/mhYrwGiPjQtrs4X9cWF9tvBwXNiYKZR29M60PGoZ8RWcgS/tGdmz9M6YnGqX1o3Dbo6T6xBch2fwLZ+RYY2Ojk/c9ygsOZksOQ5LRpMlw7Ckmph80WFJbbJkFJbUJ0rkY6tC41DNZrhu4fQJWlJMqPMBR28eSqJ59gZnniqGMb5tvM4BXufRXMXLG8ssco+E4nzkcbRwgfulqcKhFmY4PlJefLL4RIvnqQ1PUQ8QKR5pMTXInZSXnCxuzIvBAmYMWHFw7eC80ZmveGWYToUzq0c7NattyqggmM/x2tNm3lgawisvOumUyYxJOVWD6hCo6RBArx3OYwigFfoC4hPtOwpLGpMlx2FJc7JkGJZ0JktOwpLuZMkoLOlNllQz45L+ZEktLDmcKJFB0cfj9eczZuOHk3UgmmDFWbNjXPhURHGvvWyxazZFKdLf8JxfuAXlmEtlk7kmVXy3HWaD/gUcoK1nr1AFkL1i1uEu08/iY89WpFJ5FAxi7rx7Sx5CxwLh2pRlJNkjRY8FPVZ0KOhQ0RNBTxQdCTpStHqWaPWsoDVBa4rWBa0r2hC0oWhT0KaiHUE7inYF7SraE7R31hRUq4WZDwvJtn1gCmZj275pCqbgb1a27TKgbfsnSDiEf1XJBPLNC50Xz4Yij5IGs6SjWdLxLGk4SzqZJY1mSdVzM6TaLKk+S2rMkpqzpM4sqTtL6s2S+rOkw1nSYJZ0NE0q4JQnzzgkMSlpWiZPTe26E3tBdT3JHcsopaOU7pjSVUpvTOkppT+m9JVyOKYcKmUwpgyUcjSmHCnleEw5VspwTBkq5WRMOVHKaEwZKaVqB5SqLZTamFJTSn1MqSulMaY0lNIcU5pK6YwpHaV0x5SuUnpjSk8p/TGlr5TDMeVQKYMxZaCUozHlyDYTL+/YlpeX187SC4a2UcpQKSdjyolSRmPKSClVJ6BUHe2sMaWmlPqYUldKY0xpKKU5pjSV0hlTOkrpjildpfTGlJ5S+mNKXymHY8qhUgZjykApR2PKkVKOx5RjpQzHlKFSTsaUE6WMxpSRUqrxcf/EtX/GlJpS6mNKXSmNMaWhlOaY0lRKZ0zpxGV77F0314MdmSwWnHlWZmeeWVJzltSZJXVnSb0Z0prdWfLyvvNBXLbGCOKxAT5332ygChfb1c5Kxb2Kre9KxS2ZDbTJvWk20Fz3DrazKxX3PSdaQ3+lYt5TtcmGf7hSMXfGGBR/N8fY0UqFg1+w45WKuTrGhisVik+CnaxUuFeObHfjOPqgeh+7Ym/Dj/FBkOkeohmk8I6ACfTbhkZYWkdG+0CQq29oTKV1ZLCXkEpYaDfcDBf8iPJize5teLx16bsvRH6oboyNt3fL7Zt7v7T5j//jf+fWtebN3Duv/9N/vP3adZP3Y+95eRzdYb3Omo3ves4LOdB7sGrkJAqW7tUNaQF3D3JK9RkVs84g7NFsnfM6pr54lY2XVTmnY/KLV9l8WZUpHdNfvMrOuMo43OIejqtM6jfxxarEh9kdV5k2cZMOW5nQDyhbCUT+7oYe+8WpbbmE/w9Wt+3ehtmgU3H8M+8IC354QEDufLBqfrBX4clBLGPW7W9RftMDiWBAU4Id2kKUDWRPsSSxmmKyPz6yBJsj1lFsnthTQTITJir451Eerzs88sD+BQKrLZjcsquY3LKqmNxyYAkmt2wqJrd8Isgpt4yz7Y5YE8ktj2yPRkByy45icsuRJZjc8lAxuWVDMbnlI0FOuaV12uEx9ViWiT+QX7wU3TJgf4FFOe9bmHtwsq1XrZXbbX2re9dfyOGn8ze8hzdM7a/430cqho+8vF+t9r+f+hpsQ//cv/i//75Ng6q8//3vX/9KvAzS37XdjfHu8e477ekKaKv1MHDrrFY//tPQY/5xs1H5qzfMv/9nviddG//BcGqz6Va7baybv/XP/snfj3X/1vX2zf/1J3/3b/7dm8PvNdsovPm3fvPd9+7/i//revumeevkzx6v/avvNds3/+zvfP3M7zj/6nqzaeLtv8F7pb/Fn2/96e952BuhXo5XuL5bTeM0X0Bd6joZ42Q8PQrW4Tw+cfzl8MTxl6/j2Le/4cfcm2ES8zDKtXv+zZjfn3vs5d8SxeEZeX+iKNGNFcbtCzEa6Z5BrB3X4tJzE3rdUsW7ikivssS58cjkbW7S8nbfP8SXi5d5BzN52V8wZX/hALYKc5grjAed21W/Kp8c4mzB1MLN0D7MTZmNXCwNLa6ZM3FcgFg4+F32oKhLM5zDxthGxCu3OZlIpIxwM9oGCtsOY7XG3RMcHhpshOkPtoFTgDRvlsJN1qjSiHOSWzN3/M0P2JTyth0LrVJc5IxLICYKwkGx+d7YTKVs5l6Elm3fCeBsXx9i7tM/DkyKcGTSu5Uvl9sPV13LhqtqamwMky23H4iqO7Ztx01ew1dGomTiXN5wxx73yn7clP34wapX5u49Dk25H8c5+5TBwcbYTEYDQmzAL6sV2eMnpWuwdM/elZ9RnnYJieYLeEnFgOvkFnH+aukMwxXKJNGZoY+WSUQ7JWESMM1p05goD6WmKVXCqvKMFHEVMYCDGby3ROFrH+GYeFbwyF3AzxN3ET91y13Cb9Vyz+C3ZrlZVJN2Mfd04xW3HFa/7zcKOpxpinPHXzB3dDjPy3COczg3qY1Ea0PFRrsdGBK5Z81VqrD3xVwl2XbT4UCfN0kZ6KlgjLTaZk4GetiUO999MY5R75VhEJmCR2sqOuZTpuTH34N9ExLgzT3kqofhHNdBn5wY9PMmLYMemrhkU9IBlYJBf2dy0CfhBWjGllEtb268BsfKZv5TB/1881Pf7xwkAZMOHk8GvUnIwyCkrY2QBvHTB39Zc6++ZPCX/DjqOVj1SuPBX5LBn5ge/PPTgz9tUtHBn5IuwuCfvSsHf1k6qPmCUhJwvGwTjwx+mamgp4w3aYAWj7pMmni0cyB5pYPBv49R2o1TSGcYkiWoeNttk4UtWRvRPy1zpt1G3NCmew46T5NpwzXaMovttlmAVrfdNudRfN7cxHi+6aduU6Rvvo68z84LfpieZc61Q0MIlUpfR8CW81P0PH0C1xnjY1++z+yWyeN7kB7KQ1EfgN00faKO03JpT9ChooeCjhQdCFqlVMzJpp42eZCO0rtOR+GT9K7TT0t5Vn7SwdTEzxlypVMBM84Tsj9t8uhJlGT/KFZKXd1KH3pXsXxBB1filsnkzVU5i2S+iH3q2LToKuISCXUwQc0q9WiCuqzU4wmqUepwgrqmVKjc9vmyQd0kVd/ZPE3S8jgpeSuWkDnPZXxB7NVwSiDSQm8pHLw0XPQ7r0fmTks3WYdn2qru4ite18CxShwo8SRKPFTiMErsK/E4Suwp8ShK7CpxECUev16hKaQczR+/zu2hUsWOCj5Sr4PYz1Yo4637jTdQ7OWh1z9MYiznqU6mLh7Oja/jeV6n015HtxnVLxHtKloTtKdoXdC+og1BDxVtCjpQtCPokaJdQY+D/YygQ0X7gp4oeijoSNGBoFXdXh0JWlP0WNC6okNBG4qeCNpUdCRoR9HqG/K8itYE7SlaF7QPlMu6GEnsxRpvyBs4Qe9FbaD5fhpvoOxoVSzvNrR3BG2mtdFAdduv7SalHqGckNKIUEakNCOU6uuVsapBn4GUboTS4VWddEjpktKNUHqk9CKUPin9COWQlMMIZUDKIEI5ucguK2l7gYVGX+t+9RUWH2hTBburvS3YPR1cgt3X3hPskT6QYE/0YQR7qg8imBh7rft9QWuKHgpaV3QgaEPRI0Gbih4L2lF0KGhX0RNBe4qOBO0rWn1Vvg1Fa4IOFK0LeqRoQ9BjRZuCDhXtCHqiaFfQkaI9QcW4a93vC1pT9FDQuqIDQRuKHgnaVPRY0I6iQ0G7ip4I2lN0JGhf0eqyPK+iNUEHitYFPVK0Ieixok1Bh4p2BD1RtCvoSNGeoGLMte73Ba0peihoXdGBoA1FjwRtKnosaEfRoaBdRU8E7Sk6ErSvaHVFnlfR5hsVs5HdVmul2LZdf91cC82ULocmStfHVHiOZmDGjUC1ZsNdN++KZrDoNwcrqkZ8R9SCRb+hJMdsScD1ol9XUtz4Enf9loRc3xVN0Q1xVbgthiVFCbVO4zf3LNCsmzQ7AGqDFS8BIK2xN3Zg68/4EXfNDuQsuC0ttSlDNSGZJdvcgiK4KvQdlkkxppREScXVWQ3tsYONDATyuDnbZqgISlxQg4D5PpxboD9JIFIEwgjtICPsntnxy4+zBRgH/rcrFW9T3CyKcN/36HMRH1thPfnei2zbci156oT4W0S9L5bF+8K4c+KnMW82x/oOmhbBSNw4UIFlYP29SeNuKhPmhTwP2Z9k0THMCXkOcVFIXiY5LeQFyMckZ0lOCXkR2wuS0yQnhbwE8ZXkGMkJIZ+hDz97g3aJsinclYsdQlkxDW7yGcWsA49JCZrENfGWQ39Rv8UQqTfnf+vFk6vz373+MP4tvE8a6bb4fgPzXGyLDD1dDlqoP2Ho/XK3xehANMr9AR1bblrk0g+NbjKPWgywlaWk3HyZAd3L9vgROzp4DBUxIA//3gqCrr3kil2UQ9SBCFTMxQZ/b2UxZnbM3rbdT8nvgtlZsxfomO3Rq4/9L+HQ+IbG4HIImhBcC8HNECyFYDkED0LwbgjeC8H7IfgoBJ+E4NMQrFohXIvA9QjciMDNCNyJwN0I3IvA/Qh8GIEHEfgoAh9H4GEEPonAowhctSPtj8D1CNyIwM0I3InA3Qjci8D9CHyo8OSetejXPHiwyTCKeNgVEDfGeuytv0Xr4isVbzMX++Vvr9ANuPpfnq24eaeMb3LNrn97xT/5J4kPK37Xrph89pKbU7K7YXK4ABoDWibUv72SMRu+8zVWE9tDjWYzW6SP8S9/ewXHRbDqjVXcvB9zc2Z3zR5kPMQO2KBal/5KeZNDPE+v5C9X3C2TM/mKf2xVvH1Eg7saahwsWo3smhxT/e7B1I1D/JnZwyQZGutny20Tf/Edxc6V254TngSEIBy5sA3amjGK/V4knB0UcbsTeq2ma8ky5pg9mK5JIx58npq4nlvGbtJM1aoEtZz8v66lxHpgGbUX1PStz1mTVMEKE2ZsPjyQMKqlcELb+G5Y1MIUXjK41zPjPLzlbZirtz7ai2XNvtmAw0iOnmrqLZXHhHyY1gldZecAOwoxTOz+8UTpMFJqdmESGSkcRS9tfgd3aWTMLqLbYJ+8i5AztAczuwg3I7Se0MwuoswI6VDZmpFhI65KgdWzCcGHqw/3Yr9rmU0uTbtOA2NeH5DT7fgBFTsKsegDaukwUho+oBaOopc2v7PrNL+9YnbVShILv9pEYvFXC0gIAKp+hBCgWyCRFappdw42/p+sMIbNMOXZ6Bm1nNyFOafnoItCyijlxdFVaY3WyDXar6MGm5H1ICjFx+Z0m4zHZRxx2E6SWvtkRdzDnsjPU/mpqgtZTX/r+tvQ30fyc8+sm8Je7C4c0PxhTZxyApvzB3ux+3YZD7ygMQ93EQZKHR4RZUdkxV2E3wm6rLow7rJRZtxlJ5mgy9adYYbqE0xdtUDc3PSPvr2idWz6A6UnEc1B6SnwKD2Nxn47EGg3/WOlo/tPlD5vNv2RwrhX9U+taC6hTb+m8CI6W2EIKw2Fz7A7mn8q6qN0ch0NkwpbnvOc0YzhuHfGAIJea4lQCRZ9hOD3t0AIvoAZQggXM0cZV0IJrtPl3mpLZMJ1CHEQfZ9j8kjT4hRvu/lcpsldWjZZbfEQ7hCklzD9l0VWpWezyKv0eRaZld7Q0v/0k+Ysm3OYOZyzPm0dGO6w6TowdBXDqnaTEVptsb5qN90EQgnSVgRYkjECNhhMsemmEJWQtibA0vT93mAMRkymOmnN3xaVkUZudu2FWCbGNe3oE1kxO5/Ia4DPePeT8NX2Pglfbf+T8NUefjJ+tetO85MVd5GmmJv+QApa9PNGXy606AG+bhIm06JvOHp8vkWv8XVo8VtwJ8dLsVuQGWHYu4htRMZswnSw+cmK2WQQHwK4gYQQlVbgnCumrTMJgdFqkxQYT2NSAuMpTXrsBjqqrmCrs0m5YNfksdeMVVR+8DayOxyTVRmAwtn83USUNeCpRXnq/31mmoftpyzBbeW3V7DbZLBROBL6MQRy2PEHqQrDEZXN7tJ8zNJ/cK3cRkCnEj1wts2VQBfTT0nBAZ1wCN6lEw7Be3TCIXifTjgEH+06QwWf7DonCj7ddUYpsw1TdqCid9nGtAy0pmhd0LqiDUEbijYFbSraEbSjaFfQrqI9QXuK9gXtK3oo6KGiA0EHih4JeqTosaDHig4FHSp6IuiJoiNBR4pW5+R5bX1eQWuK1gWtK9oQtKFoU9Cmoh1BO4p2Be0q2hO0p2hf0L6ih4IeKjoQdKDokaBHih4LeqzoUNChoieCnig6ElT0LleY9MYy2xiNn/B9z1fEOnfbbMMaHn+r/NtJcgP43GznYrXU6hfeCNLO+hISKCPkVsGPueU3Y37VeuxtvBWTWFwQu0uRwL+biEfmlyrupsRyc/NkcHffjPndxGMv91Ys6gq7PnawtV7mFKtnPeuBn25zKnbna7DWeJFxbXyOg5WxpVegpqF91GBlbOtVOwzUN+t+/XBlbMzTOFwZG4E1D4MZc93vHAYz5joVNG7c5Axu1pX2SOOq4pjrsUCuaLeZ5C7H6TwDrBlg88AaATYHrB5gaWC1AHOAVYGt+125B90FmgiIcBwnvRfSTardbmINHEpRP1KUbOOI7kQKDiMFCRaM4r7l7jtls282YdL9oURrnIgftDMdhmlnOgzTznQYpp3pMEw7U2GY3H1TwApXULF8H8cjU+Gf8tP3zU/fNz993/z0ffPT4Z/y0+Gf8tPhn/JT4Z/cckZm9tlcK7szoeWoGZolLc+SzCxpbZa0OUsqTZNmAsiBmjO7jAx0wAMAIGmcO5LMRPCEDIRaQmsI5EhoGeEbCZUgJ+d4Aw0rTvLmjvMIImkuOgcArVoVrp0jePyWVym3lHCuKV4mkKPUFYWSmPirUBITpxZKYuL7QklM/JMgwPmWW2BSdltvMx6qa5SWIIFhzI0FMIzIsfy1w/jeKn5hNFP6cgSJUYTTwTh/J142OQRFM4VQ5IJjZQ6z7abJQWhZMznIKwYJkSCW5iClZE3OMK4zvYER7q8zkG7I+ekKlKk8mHkuTtC5dafM2NwEDyjPErxLQZfgPUa/JnifcawJPnrOdiDYKmZVzPiNSKYAxnAQFW1R4uEUJR5OUTSyRYmHU5RJr7guNgOYrbFOptDyPNZTu5L9stnAwhMz2xuxpi2hhGJCSzMAUFqQLJGsIMtElgUxRIwga0TWBNkksmk2vHVdNxiOzNJlLLoeuQvjRct1sDAivG3UspP5ESLRkoPt8fdC04ZmxPU4Golh1SxMehPDoo1BiRISlIi2u0Y8RaHJRoQNl15iabEWjrm2XUZwzJqFrrdlt+ZMvhClXokGUtEg2IjM3+IYVuGQkX0StAl1ExQeSUkKJcnOIyUllBT7lpS0UNLselLmhDLHN0PKvFDmM+YKUjpkzRU+DF4ZoSzeF6FlvCxCBm+K0Bp3bHIccIVBq6TdItZfoUg7jil3cn3cu3JK0KKK3W7JYnVgrjBxy7r4hltsnBWYwporTOCihfN8lnkUxqXwOCyc46PP6QkCCodhYZo9ldYjABSehIUpdmxKDwJQOAoLk3wPyfA4QOQHhp5KSDyqpESnSkmsqrRErpqTqDTzEue3apkr9rfgU07T3TDGHEOCM0R3kzHKGRxczgjGAT0wdKB9oY5JjxsQydws4hDHLOFQ6AwPhZom25bYT1ao7zAZ3GKRt1jCLc7oLdAMz2kZ58GiFdpRcYiO7YagucwG5lKxfmgmxU8sIkaebj7lra9inxgR+ii1ce5YaGYkBP4VfDifWH7szviLGVx/+I292CcMy7KJ2YA2vxvIWtDSOU0su++1Wzq5CX633dJZTvCDdkunO8HL7ZbOe4KX2i2dAAW/325lcNIn4jQOpRhMfdMUcRLVllOoIrvXS8jEbOkp3TLhFEP1ZwmnGac/TXiuLdbz27lYMxmZqFwLccBs3G+YEPWvg0j9LxHXXSuD4GHkP4ny27RqtB+SI6Uco5dyJJWjmnwZR0I5ai/lmFeO+ks54srReClHkao66eB5XRqKMFptS+cmdSEpmpSuL0UTLDtFOtjSjG0D4gD2JTi4xK4l672G4MV17MjNgXtFkwW7lxC4Y+6xt8mk2z3MH9vQ4TzRBM0S4HKurZ5zjJ4131a3NobAQrIOdT1jUK2FtjqH0foZH6T4bTG25VJbnaoYplI+0Zh/+A8kCBqyX8KukoF9WxQtn3tO27NabpaD3UhDGhh66mwX3H4EWzl1VNObHtlG7ldzdDagwov3oBbrgMkR7JZ7lkNda68HtffD2k+C2pvj2gdB7dVI7U2pnRJpWVIvtNxz4hLmnhc3NPeC+MG5F8X3zn1F/P3cV8XH0F0R9Zf7mjiXuavi0OYui0ed+7p48blfEs9B9w3xVnS/LIoy14ibmuuKa5zriW+e+6b4A7pviQ+i+yOinnN/FL9PkWQWJ9huwlgUOC3E5LMRnS8FK2esGRHkhZzj2iaArADCmftEjiZmZvhO24u/cCF3xiVTU/yFG4dGLCvHxqnnyKeaNOdge3wWs3VWZutxqigjpwjfodk1dg/NF9xqYKVqy8n9CKfWZyWzDAknIJwLNOCtXWeY5unYcmXb/vUETgUk/WEfKuOOXWEcbWzqc29RB4fQ/dja75jimh13i1A5btuQ+Ivb9jdNzuxs208E+1CwRyZnctv2ffn5I/gRD+B7BIcAfz/BY4B3ESEnVsn+nF1mqAyPETNw1gtZ2HOaE1t8bAcjofHQF5MWsPkwWR6NBRGqgwK25APMS0COTUbrkHyASkozjgfzAdKmzMesZD/withumCITAhajCQGLTKiHIk0ICFCS/+2MEwLmEH6TtMJpCQGtyYSAefI7H3r7pjBO0ZfDluNDr2x2TkkIiGeU58aFTFCYg/UIrtiJVFE0+5MJAfOykSF/wUyylicTAsrWisMBajwOk+wDOVAyPIROQ+2BE990WywcbPNjmEt+FPPIj8gc8hbmjzc5d3iYN9xwzuhZLYzM6hzUwzztTmPAG1TxZVTxhlTxJVTxOqtYRhWrYRV9qaI2ruKIVbyGKlZQxatSxSuo4iKruIAqzodVHEoV9Tl5spotJhr80gYWdzwtPh7MDLAotDFY6mlhr9vyTR6RE34fZEqTqaFMDWU6JlM2YMqSqalMTWUakmk5YFomU0eZOsp0QiYTMBkydZWpq0wjMq0FTGtk6ilTT5mqNrcQAdMmmfppOTTv6exgLmX/Q4vzB9bJK9t2Gikhko+94ni24El8mp5wDF7BUErc/3KJkQ3xhuiclwWEktgICK3umoBQw24KmN6lYmKDGvOyQI+wU8jJYrhLzcSG6JfvCQiF8H0BocF9JGB2l6oLyH271FtsUGtetfSeFs8zcrK885gjJ0s7Tz9ysrDTZ57wMp3lCR7QS57gU7rHy60tOsbnZMGhS3xOFiE6w+dkYaIbPGFD/3eCd+n4Lre36PIut7fo7J6TpY9u7tKfkpZQOtSmazvhNfq0E7xHZ3a5v0U3drm/RQf2nCzCdF2XfrXptC4da9NdveinkDS3eOM/qFarxzRcL5qi/984Ff/JRzC3iBN/k+juth3zkzJwvB3MLNk/a51ehV6pVwjvnwNvPSkTDyK97t7483/1L/za3/y1v1u7tsNz3CvbdseGRQgG3rb9qzjqSosdxz6kOjsIx1bws8zrK00pYyHbM2Usa1tQcfrJD90ds2f2cX7nwhmt6CCARVHnRbNlONkzsQ2lm7YsIhvMCAc9DMcWJhjqqzg02mJ3yrfaboqpKF9IW4w7+WG0mVswy5XDK/pJUXoC2VekAIfnZY/vBdYltEbZ8Dc/9HIVPphXNDnR3o6XyYhBxGpbw8rk/PQ3vJ1KZO8Q7sE2fOv2apvPG4RhwQXZyssvsE+7YPlTLnBOu8B8ygXx0y5Yq+CxT78ggQtypji+QGyAgn70B7aMpdhe7C9iPrO37Ua4M3XRuzjZeFeHSZ6jaTyR5XUiSguUxVvL6xywLJDBNJbXj25NoE1MYnmdukoClXflJXLSOBDoLuawvH6l9wS6jxksr5PdI4GeYALL6yzzVCBMD1VL4JrMYPlgiq0rjEmyoTBmuabCmKA6CmNq6SqMSaGncF8msXwwwx4qjBlyoDAmtyOFMS0dK4wJZajwiUxj+WB6HimM2bVqa/tlGssHU1rd1j2CJS4yTZThWWynzK8SPjymCLWvHlHQItV+jNjUDKUYh0dtwhQfeznf+cgtwzAK4ae/RpXutz5y93CcxUP8HYxT/c6f8ZNNy09WfpafQSe84cdhjFTw44jTvMeIAzQdK8fL0WpYCflpvCQn96ZMflO8Nd7yw25swYEJ0j6vcTHxWbcXbcqhYyJMiy19iMLMQ5TJyWfZoUZ8j5NE9Fk25ef+M52lnolxFh9mBw+zEzSugJMC1reDB2N9O1KfPJQ19VAFuc42Eq/2AcV0i8uNhTy0E9NbHl8ewpPgS/w9/GLf4cM7yK647+AzNHn/xK54N7nz8C33Kj+YorfBGfoy3iyy1viJd707UKT6mJG+WcE6QnWV4vbHiHJYeuZZjHb4zLMfetc5tcDx2jbXQX7yTNSP5vqqZz1E7OvrnK7A4ghLx4LaAlyFKI9NnrjwHDO4tz3NY5EnITwN+5nW8nA1g+KKV0JoquuL1LUnP3S3pGOLeIiS73yTMSI3xq9D5n7nmxUXr9f6yL2FsQvwDt0L/+RH7g19Y3s8C/G2Kt41sfC5ZrZMOYycuiXHxGCzvvF5OAu+XXELJufbeOM35I3fQtP0VgUx7HMx9gqoIMgeVtAgmPKE9GZMPvb/5HuLcBpL4yPKw4fzw4o84BbX3AIGc8KUdMTf9mPuNT5sybcfRwY+puwb+rzON72cBmGzzL7JoRFBVNdbwfNyIdyXAtcyt8w+2II4IvshW/bzsS1/Y/amubH0q10XR9fdwEd2wxSl627fWoxNtPuGVHHjJVVYqOIaPqRr5rZUcVmuuMz+g+3RZI/LAlh0C+a6bx/wbnlTMFsUaryyXEyan/zQlIS8p1Xshff1CqZ0wBvmVRC6JS8Jo1O+xPjMyORIfuxdW4RNbAHurZfl1AyOrhioJbUiwGB9R3ejaEqJk4wOqrGz3Tscp15Z2cohWznKNjlIS9JNW/HPcYcMLUXp2NGG9zq+73e924gEZ0nHf+TeABFf2jU8wBZMIHSuLYzn2uBODK8lct8mPCXTPMzR9pXRvrLZ0tcosVhv0PQ/bFVQE+uB2WsrMIaNvy+Lg15oSUHGT5iNx+5lbZ00+Tq+G57jX8MwK1TcG6ZgbknzIk97m2l95FnlIflkJX2yveiT5eTJ9lSP8ilPdl1i5JZOfyasaTfoD2MsOovq6L6sQXzsctQU2CtFsAfe1je8AlygF+FjamMW9SUUcV6yfuTllBOmAC4DOyGjvDrN+75Ft+rwPwTqjWTqiOY8khRjzgSWmMDiExjsBKYJB9OEu9OEe+HdsRj4eKT0whgCy9PpayLHKEqpWdPVONv2wsIYoj/2zFW96atu/JlqtTqI7dhZP+ZexRfr+3Hs2vJU06IDE9v2hUiX/RwDJoIVq/WCldEFOv6+V17kLHIHs704B9svdBjDiJG0NGlpWXeVliUtK+us0pZJW5Z1VWmGNIOHvGrufARx4Kopf8RW8H4Ra6Kvu9H3jMcXYYBt+Aw+R/myn8FnK9/yZ/BZymeiXNjvvfuRb/2iuQqZruBbv+juRYbpzpITs+w45M0d33FzZmvRXnDQ6YKWGEmA0mhpMebblJ5yZouu/jehkI2ZnLsDN/+rprDqXjV75t1vuO8aCmcwaMjj+BZSmbnqWx/d2rZHssWupxGKINxtxwgyzu623Zh7M+Zng+227vhlFwXOgtl8247t2HGshN/wcghOQUuDs2J3cE6sEM6LTcIFsVC4yEM49xUxW3gVPyV3BT9l9zX8HLir+LnrLuPnnvs6fu67X8LPI/cN/Dxxv4yfp67BT9VyXTrWWa6H37rlvonfhuW+xXRbOBEo6olAkScKP8YY75a7ht++5b5NvxXL/XH8DvApFHmS4OD32JKTyKElJ5Anlpw8jiw5caza7hLvb4vjX93GqQ5bYJscQj9QAW4z4USTCvA0zgSK1PflmFQNOoYiVXs5hqlgac8WnXmmzcI+0TUcRBUZbxBrEA6ioGtYYzQqW3z7mFeeZ87zbbMEFak5Aw1p1ig3bDR+FNw/Bu414X4b3D9Obp4KOQE3zDu+DG4Dble4PXC/SW7qgH8k4Mazr4D7NXCvCvcyuF8nN9W9bwTcMCo5C24eZpwX7gvgvkhuanZfFW5ZJ/McZgwMsqFyS5D5tmhsifSCTi+q9IyRaM8wp6PMaa8oAsCGrCfTzNko8wKOCJR5+RTm5Shz1iv6cWU2pzCbKPMFr+gnlHntFOa1MfOGHPXBuEnCnlntlpyxb8hBoyVWUNi14iy82ZKs8yxdltJlLT3AGRLyhbWbzRbOupeFzQibUba77abwVRGtCwDM4ZstnIgbuWJNrljTK+4FV9SCK3oI7QVgSLeZFsww1pj8aYf2GS9CvU8qMHDL4lAmJaZIrLbkWRE+a4LvjHQB7/rkU/iy0hlsVMf6FMa4dAcbffxpjI70whLzp9mfwmjJIzvSDUZfnGGrHe1W6ZAf9Ja8N7QgG7wkYaoGTDUreG14oDN83WISwlfbDF6ecN8L3liaAZU4fpL6crLB6woGhmkH7xPvCm9gZ83+67aX00GKGM5jwVH0+7Ih3Fmze2ALB741w22i3H8N3OE3Ncu9HOXugjv8XGe5s1HuX7W9nchMINw8VNNE5WlJ+SefYMzbEc7YKZyxMScUtG/FxJMYJ69rdmOOKsXgJBa+mvw008FhLdwYSMkG57nw22QksuXglAzemxKbLDj0gg8nKWtyhrVrLsHiWtbpK9t2F6v4JeR43LYPIyt6T+Ah4L8GFWjuzZh/EnvsQY9vKtv2si7nu2t22t2Be+QCldBF6Uko67lDuBLqxq/obJNuixlgoBunGaCoxmkESM24mABu6Ojh+4765f2EmPbsYobcEKe4NXuZdyNo+Cqbkh6+qFWlea+0aPC4dvyE2A2hJSzLilqPqxDLSmyYtFF0fVzPfsIUxfyOjWWxYbFhU3npAVvPsjWWrXGZZdld6oBZtil7wSad2eER8FaQV33T/hag2s96V+i6U35MC/m6WqVsU1JJ47dvuXM09LHcefw2bTeD34HtLtB4x3EX8fvIXaKVDQKGbVNgyYrNlHuWrgC2ew6/R7Z7nhY9jnsBv0/ci6zVcl9hrbDI2KbcsoLfru2+ht9j211lqxx3Gb9P3ddZq+V+ibXCIGObYs6X8duzXUNrJtt12SrH9VgtxK9tillvsVqIX9sUi36UD2u7P8aHtd01Nstx38bvfffH4aAzV+FNLDUTbPNWaqBjExuqgQ4SxvLGaqATZ+mhGuik2iwcqYFOgoUdNdBJyqDEsQE8S96Ewd1bkEJ+hGlozY/CWOPHYPNh1jCbvm3CK8zr4P4SuN8Q7i+D25DbBbcXcPMzvwj2V8D+qrCvgP01sq+CfTlg5zyxBHb4zZmssJ8F+zmynwf7hYCdE82PG6baZZZdss8z9ibZF8C+GLAfp+1vMY28xdGIM/9tfNH0hYGtJv1cxCY3Jg4zyF9xRTzB2/TEQ1lW3GUQPIyuMHwPXryNGHCwxQZEw0dazySZNFcijTWb3pz4yzBCgpdueYsw5Wy+ED8ZL/O87THARQbmeHPtlthpbpoEBEI4UbSwxOP4WhxtvAXxBU1ITt4k2ByyMfkE+BbEJTQpOXyXmnqOvkBzPoSLABl5NzqIq5CmAaVJN+lUk/3LFsMzzLVDg46mumdGuq9qtzxbHJA867mYbwadOLIk5Y9Y+gTdV+MVtoTxEF8lxpd4EbUiSbzw4m0JcrvJXoSgwGdHJ8NCkQ+Y1Cdy+AgWuyOs5kWGXqDwzJqXmnCig/P9gbr4bMCC1hYZU/LjMdZF07MRxq+oQTCaHvc8y16i7WHuLVFsS7a9OSZa9uAnaCjX2G0vw2iUVtNbaHuJFo7FENdyXjcHGabk3KQEguVxIrggcnF69LFse3aTzt6RUuxLkIIIBWuTBQ5oB9jQb9uMUL+Nc8vcts0A9rltW0Lb+1gRfz0E/7qAA9gsdSPwrwrcQKQ+CZzv9wD/JYG7gJtME2VVsj8nhmbq3uk6aq/GqKH36akLQ2M5rOe5X4vL39iW9vh7sPOSqIc5xhCFP1RcpCTbOEStCd+DuNheWKJLToxdx3noyBNFOSr8gbzXjlojwchjoGY/o1jFzfmWm4dJO5OycS8Bb99OWgdEvA0f4rSIQB4XfTibIx7gkrHFrFE+dwbX5HAhynGkgVBeeCk8YLNNidM7y++VSNY7RzNPfAmvt7xls8yInFClLImtHBw8eDW3iLzuLIYcbOZw1Sst77w5H7kqLVelg6uCu52DTV9w1ast74K5wI+Qahtuuk2wT4cQ7GUkqibGt23mzVxLIlSGKctzknHVasseXkwEEXCRCbJYi/EwzzjyrGveIucb3H+l5V00Fzk14P7zjF7MYyZejVmIrGaBScgdafVrvKDlnTFn5KqUXJWiZbJGVkzy6jkSedUZRMic4xQsPQSZCQboOVoqeKvPvCBe7cnHD00IP/jGLfKjO4tis4TOLIplEt5GkfZHzSZqQ0PE1o7NyAkXniMXcDW9xLOx2R/uFZ+61+uwa38FwYteNedkrcxgrVzAkig6gPSn17ABt+En2NvhbH3DrOKwfcMsy4Qzh0P4DUyVd82GuSgTRvmxuSD7y/O7Do4v8jCMz3sbe7HDR3oKcsWvD2MVd0OM5q/4w/8lVjG7WU+YTmVp/mYsMDOo3UPpUaxirvid34wF8duu+A2hdaO0ptB6UVpHaP0orSu0wyitJ7RBlFY9immEgiv+0W/ik+fa+bPjJeppC+AyvCx+O1YJpS54dw6VImsXfDhOlIJVP4wB0w4XQwaN3uYegDbhJSzJ21QgTF8ga2FwwRovELlcr7nHa7787/3Tn+z9Z2/2MYRceDAW7bI5mHWCO5j1zzuY9c87mPXPO5j1zzuY9c87mPXP25htxMZsIzZmG7Ex24iN2UZszDZiY7YR8RlfwJwEWMK0JNY4RfrUOk1ZRIpGHHPgE2Iz83ZLdWvij0rLpwOajYp9IfzQ2LvYFEqILKE+YQfTB44LREttpZ6yl+mLyJQmwl212NNiOMxDzZacpNVYsCYmwzxzlQvqpMP9Dc5BZb1Bs4UnsYMngUcVnoSetHgSR57kQLUSu2y57N4PaOGDU/cDTTNdYJPk7PeAFj4xw8G1KbVwqXtJUFyr1UIUeLEzbr74op7XY6cTmh2KIQ8eJ95q6koEu+gczGNEDohj70rfRNmRiyWkJXtysYW0ZFcu5pBqsCYWkWqxpkaRarKmZpGWGK3BrAhmGpi/iqfNbLbMbL3f0ukF8xqmpQCvC34Y4A3BBwHeFPwowDuCHwd4V/BhgPfuyQ1Hv81pDa1AUklzyVxCFldRfGRXvF02dXcRQk0txQyllniqc2OJDiD0iE9P8AkfneBTmlNtyt6Vb2FTtqB8M5uyUac51absvmlOtSlbappTbco+meZUm7L3pTnVpmxeaU61KRt9mlNtyu6d5lSbsiWnOdWm7LNpTrUpe2eaU23KtpfmVJuiKKA5lXpM0ZxK2m/TLFTab9NQR9pv0y5U2m/TLlTab9MuVNovdqHSfrELlfbbTGAk7beZukjabzNPkbTfZoYiab/N3ETSfptZiaT9NvMRSfttZiKS9tvMQSTtd5h9SNrvMO+QtN9hxiFpv8NcQ9J+h1mGpP0O8wttmkscO4cKpplRiGCWqYQILjOHEEHD5EEE15g1iOAm0wURLDFPEMEyEwQRPGBmIIJ3mRKI4D3mAiJ4n0mACD7aRbhsgk92nZ6CT3edvoIYd4cKY9wNFMa4O1IY4+5YYYy7ocIYdycK04pYYYy7akJgjLuawhh3dYUx7hoKY9w1Fca46yiMcddVGOOupzDGXV9hjLtDhWkDrTDG3ZHCGHfHCmPcDRXGuDtRGONupDDGXTWp7cd4URjjrq4wxl1DYYy7psIYdx2FMe66CmPc9RTGuOsrjHF3qDDG3UBhjLsjhTHujhXGuBsqjHF3ojCimY4URijTaspcWbNf963bjF53xa/RK4f6C//kfwOMmEuDJHaHNDOhcSpcc7jK0jtHVu+WrEc5dfGi7J2WDXJOVnq4G3HbBWpWxQA6FFF6b7ZkA5mj4hV/IMg3W7LLpEMNnDwo08v+OidWLvCX4J4B1M2M6F4QmbWWEhhhWesKDxwmcBT9jMOkjoSPHSZ6JDx0mK0aCpO4S71TI+7GqXKKi4NzJy7O0N24uGQjeseB+LBDYoyLM3bazXBtdxfEUXuR67u7JN7bZ7jGu1lx6T7Ldd49J37e57nWuxf0WeCJDj1XnAt/ixqZw7gXeEwwEs8mo4heoCPFedCOhZYw50g7C9qR0FJGnEDOgDYQWtwskbYI2qHQHLNAWga0vtCw06T7GWi9lI5V9lLtXpORgGTIssPqII0Q/wsRgS4xkxn6855qN2tCrUvvBtS6UBukdgJqQ6hNUrsBtSnUDqk9oV7x+xDIdr1cLvZrlouzgthe7NcgSqxPRfVYn47qsT4d1WN9OqrH+nRUj/XpqB7rU1E9vOJerG9Baol/LKP2QHzEDkWNcihCDgM3txEyFt4VUIN48NgtSvoXfl/+0QQxKcTjCWJKiMMJYlqIJxPEOSGOJoiLQqzZUeKSEOsTxDNCbEwQs0JsThDPCrEzQRQ5GDGzIkQqjHDGxWDa7rzI5ZLgumu5GUrv7isifUsy7HvuqxK6Q5Ji33dXJKiHJMd+5L4m4T5cbhyeuKsSMWBZvrTX5UP9knyhb8in+WX5Jo2OFwbCaIljoPVCNgTQdEB1u/BwNXhhxpjVlrFeGCpPoQQ6+3AVj07vly+b11h4AZqdrMmaCw94zksvmTfMCgvPQ1l0xpwx5x/wsJjeNF8yr7LwXMs7Byd7c+7BKl4I3W6c59RGOiYup8EcSq+bV3hFpuVlJIY39DIm84DnwHTAWTYXyTLfEr1Sl5mtzPwDngDTL2f+uTdvFs28WXy4ilFB95/Mcy+DAAGsbE79g+znns3wcemHqxhpdCC6ACJCnKTkgJwORudBhDNq8uEqRi8dkM6BCNU88qUkII1m5CtBKCNsKugaRHVWnLrZvuLQ7CWbFAV1U5k0qSbFQVlHvBTzIB0pvualmS7mWPFNb85YTYpxOcTya1K6y5mUOduk0JczSYPTuhrABNXwVYcqUCjqRza3PQtNCpQ5M2cWm5QzZdiIe5iEs7gnUFa2RBLO4pFARjZDEs7iqUCb2Aj4sYRvZbxL3DxcWozhcOQRz0aO0+JA3o2Lw2yO2wjP1oZiJ4EXXVfkCQZGQ5G6hS5uKtaw8BY6ijUtvKiuYn0L77Kn2KGF191XbGBBv3+o2ImFUBcDxUYWvogjxao2xs5xcAcbI3eoWMfGID9RrGvjexgFd7Dx6VTjgh3Z3jnKtjkR273zFG/lDo53gRJuTsRy7yKFXHlax3uFci5CojyCkR7jjBz/AhRPw1jFvKKBNn43VoG+jRE5AF/Q0B2Az2uMD8DnNBgI4LMCDwBnBT4EfEbXIMAayKMHWCN+dAEvqOIMsIYJaQKeV8Ub4DmB64DTAtcAp1RxBjip7f+dmAYtvOKfANa4JEPAjrjTGp4BHf9Ci06lzPV5jEiSO3i234lJoGPYE8C1C2sKsjXUnIq4NsEIW5yLJWVnkYLg52Dc8WmVd5Hn6hKl5dH/X9+C6KeK5hKDYcXEs2wHqIbDusTIVkZkSjlVdsVZ13VkbYrL2hQNCLTppiRhhJuWXBDunKR5kOWzY8uy2cdpPfMuuIuSUsFdkswS7hmRPdys5INwz8qSIOvroS0L67EtK+rIluX4xJJ1uGbLAty0ZeXt2bLkDnBez0wO7rIkacCB/dtO2n2In5j78+iyfxirAGN3XPFPgD4kbH5+xxn+DHr4H8UqJsfoYOx8oDvsJ74XoMUx2iAzRmOQhOWKP4B6xjKvQGx9FZrbFagB4+Y1HMyutpsmaZZx1Pp6cIZ+xT+US87gEpqpnZVLzuGS87zkAi65GF7SxyVpZoDE6cu8HHfjpJgH3U2edJslOYVR0SeOyJ0SsGlZd2CdfxiraEw0oM0A3STaCNA1ovUANbJ7C9BlotUAzRId/QNFZXvXC0oPiPYD9C7RwwC9R3QQoPeJHgXoI6LHAfqEaDdAy3IWnYbG60Tjssmx3o45cLfFb/aSOkDCf3YL576xx175rZi54uX8o9+JVcS8PucfHccqbonmyLlcLE1Nsj+IV+h0exyjMzj8COwyTw48e0rtvD2r+N6eVXxvzyq+t2cV39uziu/tWcW3WIjMEtOzpOwsaXmWZGZJa7Ok6WZc4jnpLDE9S8rOkpZnSWaWtDZLOqUZJS8xTTw1WiDUV7Oku7Oke7Ok+7OkR5MkPwV3rjW7mvSt98QYvms9d+cAdCxv/rmbcT5m6jOY1hWwZ1gwBZiBp/CDqFv7NG5K43dAa2uTR6CRYpAYdXQd31ER68KBKZ7iNpz3k7dXGW3o1MIECtdeUhhHoXlJoYPC5ZcU2ijMvqTQQmF6XBh1586vivVynIeoTqstcaSSzNI7DyGfaRGRnTLVDE/zGbPMMamH3t4qoy2ln8N2Ig0jibRJtMZ3+pWmB+VFyuytSppTTXxry26kzMBVElAuvKblxXn0jSy5EjRlFWYfJVOER8Ci5SfNltlbdbeCJN2p2/GPzVbCXOKbHfsNIm9yQcORF8y2Rq/ew/tOINaiW4Aj6XGMIZVNwf++9ZG3vZSK2fgXszNmG+FpcrFHGG3lyOZ++DM8JEL2jxwXtsCD/57nYNetFDmRuk9NGXyfclzDyIsLmwGCazr/KDaONp9V7m6Uuxfl7ke4l5X7MMo9iHIfRbiNch9HuYdR7pMI95pyj6Lc1d+OcNd+O+TeVO76b0e4G1HuZoS7ZMo4AMcFnegF3egFvcgFMa2+H+U+jHIPItwHftJs2x+LZsDShWT7rZgpU7xFLIK8DIgizHX084eJqrhexk0RItyeBPwtQrrbkoC/RZw5XtUUTnAeGUe5zPndZMW7LLF9L4uacF1ioNMtZVHEviUR+86I2DdWE1LsOydi33nO7SKKc7G5EH4ebU7xYpd4cYqcFQPFVyLkZpOTvVgqvjrFb8RkcTnKz1lfbBdXptg3xYjxtYnqmyZs3F/iYtA2F6OU4GD9lUm2AzTt1Una3bZZnqTAln9lknS/bV6bpDzi4SxsTs1Vlam2zZaKU9tmTyWpbbOvQtS2Kaj8tG3yKjoVVYDFgeiB2R7P+N+HvGO2RXjdNhdgUPYc5i+LsA5hzDKJV2bikCgTkCgRdgtS5Hk0rN0y6RZHfF4nIxl4+zLmdK7akpF2VQcZBgrib3+M5WfbaEAwtQAKgngxVGM02GMTqomS2c4+dosIBM6UY0Vv3U/ezqy6RbPOCW4cND6HAwB3249R6VA/HygddhhyD8c+5wTrJKGDGCmGYHu7zlCxbhJaiOp5wZpJaCFOtKyXhBaidh62XvQW3jGXaN29Ph38+V+HutbNm0tYIS6J7bfKkHlxwV1fsODXdomRWdCskjRrYE/XeTRDOZ6hDGcoJzOU0Qyl6kw0tzDd3HWJnLCD9JpT0g/cQk6hDU+hnZxCG51CqyZnabVp2rTU60zh0/Xan2Ezcso9+6fQDk+hDU6hHZ1COz6FNjyFdnIKbXQKrZo6pZ9OodVPoTVOoTVPoXWmaTm/caaCDBB2Jfv7vPVcrO9gHMc5jrHoLlTo/Y6NVt157O29FTN7/jI2aCNJTrjHEPOO5DDZCwXEIK4YfuqOt9r2vgQZZJojKxwH5ksCNJy298auszzFttxuMYtJnu7eeb/0oVmvYP3ZQ+DMfOCr3WKqcUpvDvVHe4ZKkabT9l7djfiw8iuHCfVptZqX1xqP1tpx2tAyrk3UuvayWtdeXmsiWmvX4ZHO5kStmy+rdfPltSajtfYcnhyVzB5MCA8iMV2ir4RvYjV4E975tvfarnP3tH7HDc1eRRfh4K4uwmJYFW/Lt6e7f3nXuYeBFM1CdkrPf1a9zvQLuLDr3P/Metc+s9749CtY3HUefWa9m59Zb2L6JaSgvt+DdjLiBT/zFmpICN6SvvOW2t6K2jJt+fZL+wzedJ/xItBhF2ESNP1k9kt77PRanenuOgPjos+sdfPTa41Pd1aaZkp70McefkpvHSJde0se0JtrQ4U/kN5yPuW5utZndRceDEY2Mw/mfMqDnVqtM/1k8zzg2oO2uGZ/yjigk4i0xcvwYLRu88nin9KE4cufbJ362YQpSEO8pIm3w3x8EMAGtilA+bxpCuJ8k4VA+gokzyXzaoQZ1ssOX1BB7LwtCQm7AI3muQlG73U+LutdNgXzOraMBTH4hhO3eQXq0SWzPFt9V6pPoeZF1Hxhpuah1nzXFLDnb4tz+EW0eAUK3PPmjcl6WfETuShrCmMTccQAh/FC20uI19FC9Dpc1NDOWeOtUmLGbS6i9StQCp83r51yq6dy0YEpIOx9W0T8C2jfMtr3mnkDjuVfmrqSl5bk0jQvTUnodHMB91vG/V6DUnrVrE5fukv5My7K5AUYt5+DDfqr8PF6A95eXxKRf+qyppiQJsQQf3Hi6cX8ju/uningPOY+us6kouNH7OlY+ohdlJYQ7+aiuYguWkEXnZ+6La0YMRro6nAGo+EiRsPK1GiwaZzIymsyKtIYFWcwKi5OjgqbJ81krVt8ojSe6Mz0E3W0sQ2Lz5KeepZjLW5K++bRPlr0v9Jm+PqJ9tFcssBw6+Ys2ObMKzOtGklr5tGa7ERr4jxG5+0OpTXzU60ZojhO68sCnUBMxpydrqNnsw0W2nC2zdj80TbQ9IA3OZKbWNGbWDyZ5k1qNosTU20Y2bx3os1I/pGaecrOgE51uTIZKeUxuDyabfbgmvNWDEKmSphbjLFkuXsMNLUlsY+8/PRm7t9IRh13bzK1z94thhwqIOPV/xCcLmz7w/8uVnH3sZlCoDAqh2MfIHYVUFPwj2MfVrxLa/Y9L+/HDhgFbGhV5HnNpeyHenBm6cGbowdjCT1Ys/VgLq4HZ0k9eEstiK0Dq8mPuwlSBY0o0EXYG58oksWQGCmy7NlqeZKnt5aahOSZsFqNR/IMJoyJLkOli5umnag7R92KOy+7RjcjO0V3QXaH7qLsCN0l2QW6Z2Tn52Zlt4cDQhzJNewd2DoSrts7sIEkXLN3YBtJuGrvwGaS8MjagS0l4RNrBzaWhIfWDmwvc9Bj9JK0wEiJsiLIM2FL7JBEW3UamtmUppM5nNd2krTASMEhJ4kpMk6HHNG8JKB5MQ4+YotHeU2Pdh9J2n0AbCQRRM0/TlSyj2EmEAQgw0j4KsNeZeRVbb/t3NeGb7/t3NN2nySQsGYYq/g1J/sXLPcS1KFwwfRPHKW9Bj3oAg87qyk57d1+2xkld5zqgtzZvW52uDvbi4QHfTPm988+9i7zcAtxY7dMwexRO/Jv5INyt8we+mJvrG7IM7LZZSNR306WBIRod0bA7K5zrODyrtPICmh2nYGCa7tO7ayAsGPWGkq7TlcvK+86QwUPdp2mXnZ31zlS8N6uU9ca7u86VeV9tOv0FEROQgWf7jodvQx2zMcKw465oXXAjrmm7LBj7isMO+aRwrBj7uq1sGMeKgw75qbWAzvmuvIzZKnCsGOuKj/smHsKw475RGHYMXe0HtgxN/Ra2DEPFIYdcy1oP+yDFYYd80hh2s9rPbBjbgbtxxqhMOyY60H7MYsrDDvmql4LO+beWXPZP1mquCVz2e8vVdyvYXRiVsd8+qGb59yY/KbEcKSzYTQZtK3f0Z6fQtQpxKHdC4K8i9exFcRw87ZCnq1TeZzPwRP/HDyJz8GT/CyejPlaEMn+O57z3DjmWphuNqaRWXBe5EymIb9GPoijEnku6liceIa6vwPP7msaHTDoQN9P3fHu3tL2+BIycctYVAePIxDOtnmax/kcPPHPwZP4HDzJz+JBmJL4+ywn9w2kN0coxzukJCreOwHlXVLiiACplPdIcSrezYDyPil2xbsdUD6I9Jb7FVPADsv+FjsXvONzwQ+9q9o6tCwqPpm7TBP0FbniqtbFYwoEnDW3+YCvmQ8ChttTDDeV4f2A4eYUwy1leC9guDXF8I4yvBswvDPFcEMZ7gQMN6IMcK/fYpcbHVYtGVd+8G6uRsbTc8/iw7Z5BXcPt0O+2+E7/GCS6WbIdDNken+S6VbIdCtkem+S6Z2Q6Z2Q6d1Jphsh042Q6c4EE0LKJSQc5J6oziTeMgJTylA47RTc2zKF26ucufKm8NVFBof8iLlUOBHK5htjJpwVzGX/2J5U2WVw2W2GPg0ujFyD48KS7O4vY3dvt1s43nkyrsjGlBlRAO55+SDWMQKgennhrLDyPioH6wsxnkY0S/caGvrYzethUNO1zZYfe08iklMaFm3i9XACsr8TiQkVqDAGH8sRfDNprpvr6046GtLgutyUMaJe4kPY9sTT5brfcKBkHoiS+bLfXarcoMnWZb8Tgs0QbIRgfQwyK/rSD34jdha9JT/BNUn6eQ+aUl2QzGW/tqRvZvrjpj4l9aGc9UQWKamlEC5UWsle5KPitXbFK01eUpq6pDR9ifPFL4l/8UsSX/yS5Be8JHP6nDLuwnGHBZPKTK9GvmYd76dd+hnXOT/kdfEf8rrED3ld8oe5jjExH7t7Js8PFZYCtSW6pRGuL9EtTQJ8L9EtjXBziW5pEkB8iW5phLtLdEsj3FvihseeSHB02R9m6JoafKL9TIUzzShTUfPKy/5hpuLtmct+dSGkDTJ4lsvY3IxpRxnsni5jWzumHWcYZddvLFS80phaz1Q8HxNChLORgTRw2e9FaM1MxbuDVkVonUzFexetWqh4V8fUbqbivYd2LVS8dwKqufy2c5LZcXoZgTsLO04tgyfJVLz30frFindrXMdovuJ9gNLFindzTD2Zr3hfQelCxbs9pg7nK95dlEafdb7ifQ1l0X6ar3g/iSdYrHg/FfbofMX7fXjWxYr3+8fU/nzF+wN4lsWK99Njam++4v1BPPdixbsXPu98xftD6KHFSvRpjxd2nKN5gRuLO05nHjzzFe8P4wkWK97PhP09X/H+CJ5gseL9bPhm5iveH8UzLFa8Pzam1uYr3n084WLF+/qYWp2veD+H975Y8R5EWzFY3HFGcxIyuo/hmzElDk2aZ19lCHuCtzmQacB9D+CA4AMOe5p4s4rDpV2nuWDeATzkdTc56Mn80wCPCH6dn0h43WBp1zlaMLd4a3L8ft6a4B/jrUPmI3wqi+aneBNy/CxvEnIc4wBj0fwMqwvJQ3x7S+iGVMW9KV8UY+UjkcBVhKG/bW6Zq0Gc7hP4JJUYXs3Bbx36oRI8mBL42XST+Il5KdcyV92SUzY3EcP+QyPiKudkxNR+hzle7DbiavcRjAVAndr7dxAqIcHfTWhTLDE/bmpW05umpFKdROopYSEs+Um4g14FfBVygp0wt8YLAHPHMnr4dRp8aGp0dBtcb45S5rIhWofnTT0doIdAD8doFX441bkA7QHtjdEToCdzKhCxP7MGm1A1w7lrLqu5zj1zWU147mPbqkbJl801tUe+bHxCNcSrv0GwDvAOwQbAdwk2Ab5HsGNNShjlSfSpjOxeBqbTBGsZZla9bL7G6/sA7xI8BPgVggOAHxA8Avg+wWOAf4jgCOAfJFi1zWXzB6ThAH+fNBzgT0rD7ck2daeaPLSkZUfzO9Cxy5Q3v4NxMsHXRJV/WNoH8I9IqwH+UXkWgPcJ9gD+HMGuLVWO5nagcp+o8sjGTJWo4Dv3y4+zf9C3XJ/iGSI45QOhrobFO0Cq2JgGyMiueIUAQT6OawGCMGCliCh4bEeG4VchGd+Qe2t0/WObGx2GvMbICkqR8wDhJIY24pyPS2EzRoW5L1G3lVhHqrsRqPEItQ9q1UFM8gj1BNSakxmP1NJ4pG6OR+raeKSa8UhdNpdNSY3NZPq2d5z0p0m26f8PBNv0F5Zr019YrE1/Yak2/YWF2vQXlmnTX1SkTf/QEm36hxNo0z+cPJv+4cTZ9A8nzaZ/SGH2q3LUQfNX+iYSzNIxkeAyvRIJGrokElyjPyLBTTojEizRE9HHvtc3X8WQ/2qwvcXcgExA1/0sZNuaA9nWR7Y3O5rTHXmYLpvr4UFVw9HjwstQiDcdWjIq1nGg3DtRrOvg4GWkGE7gOS0Q6zs4yKkpdujA/qHuIP+6qlGvmz25IwyNtxAqaKKnl0F0pogGxPgUcQ3ExBQRxsg8EYwSSyCmpogIgyS+S/mAOFb6c2uAZXhvQgKYOFWToGSX/f5ZWJLmaYjWSUiU3uNzlWxBj8sumR2/n6zguEwOwOifBpfeTkJIJyR1QeoqaURSD6Sekqo8T+vTF1hJNZIOQTpUUp2kAUgDJTVIOgLpKGF2mLiqpMkkr76lbvN+zO9joLjXzDZMvmspz+apRNt14H2EsxrMup1kRLmLMyMY87mWUzbXIKfBecTYZk+SDPG0RlSjRjKCtMUMgEi2LZYLTBmy3BarCiKmLbYVRNbaYqpgiey3Be1RglETVXLj21ig/qnq4HO4xuxWN4AjyxVwq+LeBm5Brxq2+apfwpw4xEHnv752b8m0K99YW6xSLLAMgEGDS2t/JBWJ612J9YEdBNgI2N0A66IL7gUYO+T+RIfw2dzLmnCt4C9+6F6Pmv/E3JJvmYKXf+zd8p2PvEtMQ4P8RtfHqn/JhNwMzXDkBuaS5i7z5x97khlt4lLI+ctycQnHtwGUHkPjqpvN8eKY9xel2qvhKYP93GCSKfgneEM3p44bHFmu7MnjhpvmJp2/jIPlLKLrM3E9bJCnh0LUTD+1dydQqsokccpTb/n2+zMPjNEZXFWCa8IlY9FRQSnZGcry1FWTfVDwE+8vaiqqPXOL+cdMQc5CxRRq8UO3FLW5wtPgg7zJtT668k/KSXuYtQr+wp3gGWhXHb50c9lcilw7OSIk/1VU1z6Wn8ZNt55HWhM2xINe9iavCufb6bYEvOiriRvTx0IuGje5FL4xtDnCe2dCKBm3bEtWyMlp3FyjY4FokcuP4SXRtCBtk57GB/guiDjqTwuIk34tz9I25zaoVQdyLMEReQmehLzLtFd5h1QH0i/BIS8jeOzgMoJHzvgyQ5ulG2SIQ3wmeBRHDQQHcdRA8DCOGgj24+Ma1kTqJ28CojjBwwQqI9hPoDKCvQQqI9hNoDKCncS4sk1IJphdJF+sxFxBhiQnEkcSk5c9iVen8L41VT6FlyfR8MOXvXwYtfLrnDin7n44dbfaFH44dbfaFH4wiaZffndaD9Snbj+Yul19Ch9M3a4+hd+dRLOfcfvG1O2Ppm7XmMKPpm7XmMLvTaLLn3H75tTtj6du15zCj6du15zC70+i5jNu35m6/XDqdp0pfDh1u84U/mgSXfuM23enbn8ydbvuFH4ydbvuFP5kEt38jNv3pm4/mrpdbwofTd2uN4U/nURLn3J7cb7oWhWzbXb8UbKS/bfoEu5K6FiX4WIRtmFbsvLA9dyN0ykdxmB0WX8uriQtCQOTfC5eJC0NiRl/Lh4kLQ2KaT8X75GW5gtPPBfPkZbmDHeei9dIKwjg+Vw8Rlo08d2W2Wrb/osp+Nw7j72byPngN1KQ/nISQBzCXA7++si6VjD73jqysRVEuPcuITjcJfFVuySBKi5JoAp4Erq0NzNunI6CboKOgW7SFPzYfuxvw5q1gNhxlxBtrmAKudhh2Y/dAbFf9u741nsfeVt7scNyYP1IIckJgipkTvNq+86u04W9HmLlbOGFFNaQBQw7pkvZPx7ccctcMlurvC3u5d7JGGqb+mX5HUHmOrlaQcgwXP39qzh9jEG6ukObQFPwOysV96q4hcFEw1zye9aH3vXKmn3swOrhgzjstNbFeMxCdjUYQR5DUWKuV+CXWZK787r9inc9+ydMwVw3N/26Vck+gXDQd7B9Hc+Gd6+1KdIVmJm3mngWhnP9+GEYz1XDTBe0I6/7eI99pF0LKv9IcnGOrlYQiyWWUW8yc0fyVbNV+pjHToViVkEv/YYfc6/jgfUlIbunuYN8m+tIlrovgrR7ydwZJ0tdR7JUdBXy/lzyGRTVrvCekFPMlvRdxbuDr99smetEgTxAKts7mMNOJTfjp5KPElNk97q5hESol8w6xMp1c1UEn31JhBptxClN4NUWrlbJd1/FpjFXPczK+AuLsMG9nv1F6f9fL7P3f70c9Op7eqn05jf9mHvH3IQF6i9Z5ibGXpUmU+am/0tW5QclVauS/bdpjGgq7nWn7CfcS1rx/nt0T7yDDM4Fc3ONVTCEsVT+J+TXvQb7Qeex985bMftjbHL0aliMXMNyg79Z2pldR+EC1YmtNsjLP/hYq5KGZguZgkg0puDX+vSgBjXLkMrX4IhR8OshfVm4N03Bb4RUg4DK19a5z2uGZMRwvqYJbwp+JyzYlHjKbkYH410OxmvmHXbNE//jsdx/8jH35jIy9/3YB95PLsKaJF0RZrPvO9+kFea+ZFvaR7Lun/Jj7gdmn4Nz33zgf/yLFe8GNhh5uXTdu6qjG0ZI8NMwH5ifwuU3kOwU1nBf4TaEqmdcgsNEGvsUzLo/in1Y8YcGtBt8pHcDzaK5gXTAwSUlbn3MDfP+FNcWsptuma9AdP+K+ZoMvXxc77ill2sy0+CO+LqHZrKmjPkAo/gDHD59FQqbj92S+clF+rZucRLj824Fu11rch9ZMFvj0S4pqdsPJpOV/oqxXriO2XJLGd2VBV/KOxALXGji38nFeo541fJ2nBf2w43bwg/GahnnyxiSzzymkCCy/EwSiBExz6BiWxZk7Rk0bEaQzWdQsK0JUnqGeGWbQDTGCHx0Stjlc4xc9mPvcas1b65ycMhzI+G1TEhbmGLaz5ruPFMcbCEeJdA5KMqA1ommoUwDWiOagsINaJVokplGthAhE2gCijugJ0TjGIwVb19Sz5o9My8efdpwfRh9QH1o7Qh0juQGdPOTqoxIh4YzkxuqqtxUCIayvDsXgvM0W4qzK5JywFB6xmy7aD8+S2AJkxRsDRiidxAzwFLw2+E0ACxt5gTLApuDFxInFGDzZkGwGLAF7RBRO9ITMng1bpxaR/s74gAD540mvSGMJPEITcZVKFAL8e8Elkw/0f55Ge/riGISiYb+8QNJF+z8fHTlvKGjAOcz6R2ErNvSo5pjgtzvnii4zLh1BA2D1hFcY8Q6gpsMV0ewxFh1BMu7sopdo5lzR8G7jMZM8B6jMRO8z2jMBB8xGDPBJ4zFTPApQzETrEooZsI1CcXMxtdhfq9ww9pBKGbC2ORXEwJ3rB2EYibctXYQipnyjrmhsy7kh2trdiwUIYI+C2SNycXPR2pYU/JjX42XjfNcrIK1iylncML9GifXGzI3c3J9XzOs39W5x3vXWJOzVBvzWxfW+12LbNY3vHeF9ysB77tj3q+EvDqt3sC0esO8L/PU16ITnV9PoGjmhjfG5xkFUwrXeW8rWOkzhifxmaZZX3UxFe4fML8tnj/jYsbuOxJJBkb0WOrTlew3AuCbUN0WcrG/XYYhYi72d8rfuBUvYwmfe+xdeotKsL3Y32EHpr11Kp0h0waQSLuQddfsuLuOVq6TZNZXIbynM+aSWd+2q7b8/kvbXFqz/6XNRV9yxWwFWWOa/GJDcDkETQiuheBmCJZCsByCByF4NwTvheD9EHwUgk9C8GkIVq0QrkXgegRuROBmBO5E4G4E7kXgfgQ+jMCDCHwUgY8j8DACn0TgUQSu2pH2R+B6BG5E4GYE7kTgbgTuReB+BD6MwIMIfBSBjyPwMAKfROBRBK46kfZH4HoEbkTgZgTuROBuBO4pjA2lWX/bKe3g5I/g5g7OA/8f0t4FTI6rOhftXTX9mtZoWqOZ0Ujjx6ptyRp5LHkUbM2MZaQpWZbkt/yQLdvYSLZs5JZsy8Y4TuLghgAeAoQO4dFWANe0cOgkEDov6Jw83ISAGwi4k5vcdJLzHRqTL+mTQNL3JieZ795zL1f/WruqdktjyPmuPn3Ta/+19q5Vu3bt53owOTWLU0ImaRZnh0xOzOJojcn8LM7cmMzM4jBuGt4Gj9F2TLGbrvy2zG/b/HbMbxc5j83iRI/TDaTVS/EqDJozdVP8gVn0+0wenEW/z+ThWfT7TB6ZRb/P5PFZ9PtMnppFv8/ks7Po96f9hROWjJ0BI5v5bZnf5oDI1jOy1pBWPEaIrKbQupqFq3ym0YeXDV2V/pzpQPp5psvS/zNdknFhu9+DIQCQRd4CPluHRRUKWEsaAc1vy/w2kyJg1whUTRoBzfWGuQnswMopoWEHVjI07MAWDd1RbEPGdFuxDdl22FnpOSAtFmq7301i/nT2VTQFANkQazKRNGUkMb9Bykhk0i3z2zS/DXPHOizb0qYKYdlm6Cos2wwdwLItBalSBf1mrkjHSJWCquO07JQD6LB9w3S4X87ZYRjXNretpY2Y5jcwv+W0Edekm+a3kUagVaxQZIcd9yhKshffoQsBwdlLw5hiWrRKWMA0xlPUbChgGqsUVKwB2mloQKJi4/IazizcxW/3axmjkb0dkdhCMojJckTip5QxUmfM02QgbpbFrbuSY1mkr5lkL4NBHBVugG4GGpWodQMg6NtBrnQDtDPQr0SlG6CVKejbudLduNLdWWihbfdr2fgRYjKIyXJMlrL20yxmzVNkIbZT8K5DuBen4B3CMTj8F/nDJ70b+mflvu/SNj19AseL+3jdcR1N0w0rHC9OY6E2zeoM2qd9Zs3nrzqhrwyPF+Os2o+OF/3oeNGPjhf9844XZQ/EH5ZiD4kKUXS8eB1Uh54u6Fv+U6eLt9At/5nTRZ+2edN07kPrO0jRHeGJ34oPfWV4umg/Lyl+Ks7l43RxHynaFyP585CJc3L1V8E2OV3k482rfUXbTmA6eidt865kzStV0Ffiffr2ASMe6M6BBX5+VJplGHTOAeM07rB6f/gYKG5f/NrpOvJtm6G+NsEp/9wDxmlMWiPp+YAxlCYWRE+TYuEq7FnOHDCeI0vIi+rqu3GFa09sdkKR/filXUf7bN47Qt5+ya4MDxhDKyvZXtzDOpv8c1B+DvCZv3xfDMzJz4z8TOEDRcHRJ+pEWoTbOfbA1dFn6hT0lWEC8Qv8MNFUBX1dmEBchX1hAvEUbggTiKNwS1SAKug7oqJVQd8Z3VQV9KGo6ERB3xUVnSjou62uohhOIpRJm19shWYK+nCYr+5AhftNRnF6O8dEeBOcQXcHTO+ooLc9FzH0ZC8ySnd5G2H7FreTNCWqgr6P3hyXCGVes4DlPk9hhNoTpQOFAWr7FrediqRPSNga2d5vObK/34Bx+3Yc22IywN5HsIWMAKJvoWtjARMYca6PBUxgwLkxSncSGG9uitKI13ETym2lBZgr6PuN5iySM7wBFiWnMBgcjJKEoeC2KDmBgeD2KJnHMLB9i9vMmGfqOnIs0XHkXKLn4GACHsDh5OLYLHvCcEV/ZbsM1PAuIprEcP5xpWjpYrf36lC9+Aqj8cn+KaZD9eIrzFtljxP3hOrF7DqBPaFsl+kK+8G4LtQevoL2hdrDVxidZPYRcUuoPXyFefXsg0VaBTtNEU1e9pShjG+K+0Ld3StMa2CnFNIQ2FuGtAF2BXIo1C2+gu4MNY6vMMrH7D8ClaFmxeVE0niIEJVh9gchr59dSsibZ+cT8tLZ2YW8b/bCIYrO7FzkrlD/mG+wwPrH4rMChYpBQhOkNIcGSGkKdZDSDGogpQlUQcrrD0CKqUTZlfITvFC4wsz9r8C+Wgu/V3Dc+QxdkX8G4zkCpWM1/iY4fDV77QM5WYB/3Sy7t0fL7t3hmns71tw4U9g+aQrLnbuhj14RZ0dY4H9zAd4o/CRdYcaNhTf7ifxP6jdNetuxofF2b39OFHT0tL+4ix1pS+i46XCnW3Yxp2ma5mTvYzdOoUQpE1lwitSVs6R4P/Bl7VRkg7m4u0AOri4mK7EJQLh5O437TOjdMo+YnnJG9ZxsFcBT4W6NQI3uMeOt99jkPE4RpnFooN/E5oLaEWUnsfo9nx2jBk4ThD0v7PkfyV6K2CeEfeJHspcjdhJ2+pHsQcQ+JexTP5IdZxV6Guwzwj6jTWT4Fdh5Y8d7E+31W9gDou1+is8iaf+kN007/NKrCVG3i8+Z+zU7MitdePIcrYhzrky84RV6wytTb3hlZsUr+Ax2+O1XE2aavMMPvgrXKn6VbcmMG02w4AGNAuUVpn/eBl34DNRrthnnEXmhJrDhvc24jiChprAlvs04jpgRao59pkJf6QrZ6ZcImuI74oBQB6EuuM14jjgs1BGoCW4zfiOOC3UKfqS2Ga8RzwqF3dSiEhq7qYuGhtOIkqHLEphxW+g0IjB0VQIzbgudRtQMXZfAjNtCpxENQzclMOO20GlEy9BtCcy4LXQa0TF0VwIzbgudRvQMvSzd/7bQaUTRMfI77CRmW+g0omTosgRm3BY5jTB0VXwqbQudRtQMXZfAjNtCpxENQzfFJZDIL4EZRX5xJCXyi2a1yC9ukER+Ccwo8otrIpHfZY1qkd/lUUHklxA3Ir9rtMivkOB3gaGrrtEjv0KC39UMXXeNJvkVEiquYWiEimsaGqHiWoZGqLi2oREqrmNohIrrGrrn8oGAyO/yiYDIP8BHAiL/AJ8JiPwDfCgg8g/wqYDIP8DHAiL/AJ8LiPwDfDAg8g/wro/IP8BHAyL/AJ8NiPwDfDgg8g/w6YDIP8CnAyL/AJ8OiPwDHKhR5B/gQI0if5IDNYr8SQ7UKPInOVCjyJ/kQI0if5IDNYr8SVbtFvmTrNMt8id5U0jkT7IWt8ifZPVtkT/Jetsif5IVtkX+JAdqFPmTbBEr8ifZIlbkT7JFrMifYotYkT/FFrEif4otYkX+FFvEcl8UpHibiOlqireOdoie+rxbvYV2+LVvI8aIPBA6u7pJ1026YdINk26adNOkWybdMum2SbclzXGL9s+7vZtph7/8LcRH8cuvRhGzd/jFbzMW2NiiYFUbKwlWs7GyYHUbCwRrxNhWX3wX4eazfjsJbSYESzaOqnA5fxJ3eE1Cs5ySXn/RJI9LsmiSRyS5/G1JHpZkzyQPSrJrkgfEf/ZWngh2bmGntWsxWk7TT+BMZUeOFrDOQoQQ2mFCoO/w1YnVAyqRUGyLsIPmEYbkLxPiQZq77HkTiatkyDx32PMmFldgSOLuet5E46oZcgadtbNA81sTDRVH9kBgZ0XqQRPV41wgfy4wcS5A5wJT5wIzEXAUTz6PJ/6yksgwWELt2OFcIOFb/iJR+DzNYKfv83vofe+RoC87djhTdLkE7bxqyiHxEu8g6OeoZpUzRJbEWRIH97wK+h9XSSzu86cvl8tTsu5a5rTEOOCQ6pkV2DPCnhf2vGHngOr5Fdjzwj4h7BOGfQLsEyuwTwg7CTsZdgI7rcBOwj4l7FOGfQrsUyuwTwn7jLDPGHYOxTmzAjtCjmKLcKNEP/fSHLvaS3F0a08iXnsOR8H2XI6M7Q1wsGvMia5BwTPT7ikcml8DoWam3eM4T78Gzz8z7R7Grs81qLuZafcgPHlcg3qfmXYPBJ6LBMJg8sQHGgXXoB5mpt0jQc5LUoIS025xtc5Q5rTGKfwAZR+a1PjNQPbmWynht77Dk9gEfBPIht7AaZ3h2B0ZhAyU6IJoAgm/Dd4dlIBTDuMR6XRfIA4HlSO8HfBupwR8eZiNyNNcfYrch/qaVsLvgvcqSsAFiPm4+qICSlQQ4e19h+NsJ+A5RLwpJU9zABElYQUpSamQdxm885SAwxHwpih1WicpDZ+YiEsIh5eGd8opH/Zm6BqaD1fc19Dl4Tr8GroqXJ1fY1aRdZA7ZPEJcjpc3V9DiS1u861Y9DsLlPDPfCVR2JpIDCzQNdhvQo1/P1Hwe/+m8u/kNoCX1DrJM7xrUMffN/GTOpLuhOmupLthuqfoGmwNoU5QYjMBDSfpARN+p8P9OVqBv2zo1Xhz3xV6GIIYPItiDZ2jhF80PIMQx+CrcBtDD6G1GJ4xv/0/FKuB+h0hXL8rxABdg51xfrGlf0ZrMCauABYBTJuwClehzoqPmw0axDa4Cmo3cEvpVthvbRDotHS8mQq36sc57MsqaIUOQR0Usbh0vsKhga+CLR20QFy4/xvgwAtaVdi9KUcUvorysIeHzRvHHU74yz8I31LCb/+3hGmFCb/6XRM7JOF3DOyCJYa7Bh7AQ70eRXVJcARlaXQJv/56xL9s4DTyhvyo9O8InsEn872IfdHADiX85vfC4gPK+j2uZZ2vUM5fFjpboUG/+O9M5/DQawgPUf9uFAAl4XfDBAQuxwJDzGYoJoRbjoSDSNXvRRFVEn47FkQPQsqaFIpXlvA7JuEiUZJSxI9jwm+YZArXeiaR5goIpFD4dk34LZNw+B6jtAreG4eg8DNG/GQjlaUlb5wfL7Afr2U/XrH/8Wr243X6Hq9kP17DquckbrwaNx6WG6+Fu17ctmHftmffNui/bcu+bfF79m1r9m07Vq0iQsjSkreO71S279S077T83b47Ve07tfsecNG+U916wBF8KINwUL7krUf58pHT2sAbw1Oa5Ejg5fHh1Y/QmsAbpZHT3gZac9qbpLWnPXxBvR9IhwA5uobmejY0hGj/IO6IWj+IO6LmD+KOqJNn8gKwC3khxDAcF3FvmfcuZlke83KW4pqlSxiTQ+4C3EwviX7LMOWXxI/fahpDDCnuWZyXvOQ5/nAGKHnGQ2TdJBQbFX6UdS+MTRct6WRfHpNa+MICGkiG1i/hjaVp3RJeVorGoc9qcuxaqATaOd/lFhskOznWrnNOa6i37z39Iv793u7KEuXO0AXB3v/5q//Hn9/84MzuSqBTcYJWB95qSkPmCqXPyXVhX660lWs48IYpQxdLj5npz9eXK2PlyoaqfJGvsN0V7RiVPhefrbeKhlgdKvCGMEUv6B3GJXwCu669xygB5cYufjPzbge/8NOC3+F5t4Xf7LzbfIyuoiEOWiqhFmmVzDrnedwYlDnlPI8qI/DEvIomKoFMHdG1X0VrMUAMcqhHniHKAMCezYdog6BTCGSVo2twUkEz5jkP7qZrcDRCB2hmyklMOZk1FyaI5wrNk6zy1TxJifw6cK1CLMe/cJ2J59TzvvI2OAskvTDa6Zxeu6RX0SpucJjbK0ylMYryxE2P8oUlTGXM1bxejYwH9BijS5i5mEsTehiXDupxRpd0mtLmEmn+RA/rdYwuYeJnLk3pNbh0RE8wuqSzlDWXZvQILh3X6xlF+GoHl7JAZ868yNGdE9Pu1JkXtSszPI7tnJh2iaEUyIkzL+pBcmkQB8YRVxKX8sw1ADLTx7UKUGKljNFxMr6r9YipeSbwRmgCcabPBN4aWoe4c2fQJ40jovQZNOIxTBjP4CMYRcM8g4a3llYxlUOzG8FOXwIxY49QAuFiD0tbOyhN7wAlEB92gRI4DJrzE96GHG3IPaPc50nlf11pxz91/cACB6F0/BwMHBx4Fjj1pB7IfyzpuZSgAR+eUJ59Ctv/CXLhXjpBzg4H+qugrkb791xyroNlCHoWh2dteHBjdJIYzuWHE7mrkFNhbp3/dZU/k9Rqi5OY5fIUVnSJKSeBu6g9grIv69ydSj0v+XAw4ZCzNZHTyp942p94h584oN1JXIEesjuJQp2oUMcu1OkrdFap5/1MPqFV/uNJUv73/0+FB1P+QIES+X9X+U8A/eS/GrTxr8ofyKtE7oeOUs+haJka8DwbiQwnMpLIcyIviQlOTEiCOEGSmOLEFMgZ1LScFSeiw+OEnCYn5Gw5ISfN/HNEfvDmXS5kJg5Q1Hv+Idtj4ZP+X074S6tJ5Se4acZX/F8c9/9qiJ9ErmVWupaRa/mVruXl2sRK1ybkGq10jeTa1ErXpuTazErXZvITuY9OOpc+l3n+koQfqBN680ZeE317PZYM5S+tDx2GJfyeYCUb6wq2aGMdwYo21hZs+Yt23lcZq35pfUFPmV2lhN8TtPal9YUIWxasbmPF19YXYn2ShB/IxSVztck5GnaORcGaNlYSrGVjZcHaNhYI1rGxqmBdG6sJ1rOxenN9wbsMj/Gl9QW2I7mMtsI4Y0uBtnAcD2a8jLbg47q8QNN0uQ3mVwInVgKpcE6ZW+HAZav/dwkZUv3Sa/K4f2Q/rmD1P7JeTSBYw8aqgjVtrCZY2S6vLlhgYw3BqjbWFKxmY1W3oLfIlsiUhLbbIkaQm0EQPvrNOLbO02Y2b6DNOCVP0GZ/Kg4gTJuR+SDsQUgyigYy+m5OzpjkKUnOmWRZna+/JD7lmeRSMbLAaCQjyTxbCYg8U+iYnDPaNVKeRmIA06UpjLbxbLOiBwNLEwruUacw6A5VAhDH9YUW65pAT8BOEwVjgjjFasrruNCq0qst1uGAuKSa0iNSVF3piyyGXKAvtpKTgZTXUzrF5S0rvda6njflFR09KuUtOto6EdTpQHtW8gJTXsPB8nuKdYrXW9fHTHktR2+Q8tqO1hbDeKAvgW4v78Bupiw/tSOGGqsQHdviXRXQmkBnMUnniN0IBxTQiMUxFFAu0BstZDVc/bOHO4TnHrWujASUDvQmC1kL3gx411cCK0pkRY8GNB7o9SLoIgRN0mBAItAaCLSOhgOS22/oq35KUf7sWopvdmlfRVKGxgKSosel6CKK5mm6lK7owkogUWpcPLHcQ9FFlUAPW4WtQxSDVMXcSRFVAp1n9WkXDyS3UaQrgRX0E5F6cZq5GXY4WCTQJs5ivz/Mpo/TZlrDgXICupQ5xvvaNSZNqBAHqyhczvc3UNzlMG2mCXBczBwXBHRJX6vDVGszThLWgGkDM6UDGuSZPQpfF5Apao6LmuRC8hw4Fg+wOqC1Z2uUw86CH6+Es4yhrL1r/nHru178xJNvfpm391HAQAVleCJwH8MpLtCp0Ea+yMXa1w9wfeSMgPYVytFmqIF5W2gzm1leRptxOOxlaDPHN59G+pTn4Oe4l6XNUHjytiJ52BvEz0EvxxWBnnCENvszBe9y4FPeWuc5EAc0T7Bbrh6NmnN+oVLRa9jZEEcOWUNpdEODFQ8LsVzFy3GMem8E+7sVD0ZY2YqHfd+1FW8trcl5Lm1mzz9TtBk+cbahj4RG42Wywzctm3tbeV9P9qpT2C/ACajeEH0qLMfAsYHneJatkzRU8YYoKTdL0ljFw0x8VcVbxQGYvBy2ZCteigaS5OS8YRkAxiXS6QR2OHCsqidp0r5BEjdIkjqjV0tZq+WhVtN4xRun1XLX1fL4CDblTVAySSrn5VGBGX2Btx7L74dgeETpswtn3jJwdXqpQunAW58DW95Lk0PDWGYMn10oyLKm4WrEtHYCL81ME95qUpQHU57UGeK1WTNiWs2LvNJr4ReVWThjrWDIWsxgScQP4dBwxcPknuvMkYdwpLIcvMNhWktOxRvBuEUuAmfLi3e9NfLq3TOIvo1srmQbJhfZXLmBKyWPABzhhyDvQnIoX/HWkSMV6kgVOnhjLvefXt5h4z++lWKjO9gsYhxjViWlYhrNuyJcjJL7oyPy8nyrBD/aOBqdgxczRhfiYcadBXziD6HwdRxeG8kzOiXlpETytZBjLaXkjil5xjGAYzlrVjjtBl9ar1NLekKcnKnK2Q4WjQxLCE/JdProTxyauexX37R779ZrL/in13ds4HzF6EV1dj+kt0yiNW0ZWODAW16Sg3B5AxyVy1sT7/jE448Xd3xe3M16cUf9BptSlo1lPNx5a1e0x7Q2sFavaLsZ996ei4UlNFNa2L4LWusL+jIsZ3kGiNQ09ll4SozUVlqPFKJe6VGYTNLoQ5PeKG3Ba9mKgGA4bd3MZ6SYe27mI1KeY3YwWU+aoyDQq4Rugc6YuR/otWZuCHrIzB1BD5ipNOismReCds1UHPSgkRx0zsgNeo2Z6oMeNksB0GNmIfG19QXKm4UG6BFztAR61BxJgTY10wZt6qUFer2RH7Qy93ptfcF5bkXf9ogMYV2AG9yzbSawdwQ5eAT2EWFwKlPZQGGb6BNZxWuyVuKEVrwm62SsOa6Cuqsrq1oFXdeBkKaCdgy9h72G8k9efngXe7Cgk2Y9zL6aU9biuIjjHDh7TpMTLwcGC9qhgXgpMFjA4V+Y5u9lcN5tYWe2nS1QKprQd7IFSkapbrZA6Xilly3wUtm8mmyBMvGCYbAQSliPSLaCGeSNDT+BkyxURMJvx7ytPt4mnqUzWCDFZmAswWDBeo7eYCF+Cjj0BuecpIq5AimxuTI1lePLB6JHPj7vltDgy7kCkqdM85TUs6bhSqpo2kpNkosmWZdkySQbkiybZFOSgUm2JFk1ybYkaybZkWTdJLuSbJhkT5JNk1yWZMski6s42Q4btCQ7JlmSZNcky5LsmWQgyWWTrEqy6JjnleSiSdYlWTLJhiTLJtmUZGCSLUlWTbItyZpJdiRZN8muJBsm2ZNk0ySXJdkyyeKQPK9JLkqyY5IlSXZNsizJnkkGklw2yaoki6Zvqkly0STrkiyZZEOSZZNsSjIwyZYkqybZlmRNkjIrmXc72A/uyqWG4exJsmmSy5JsmWRxtTysSS5KsmOSJUl2TbIsyV7Y1UpymZNKVGpy773Svfh557n0Oy9J+MV24oTObEwQtONd7EhfSpdWyMX2xBA2rU2SCnp1mETIeSzJzaWZgh62OOcK2ok5A28T72R2Vf6XFU7iwX5JqIKO9FRBbwz10JGmgs6GyuhITxT0YOgvG+l8QedCV9pIZwp6VXhQnqZUeIbO5BzrvIPLdANVRy4cYBV5Jg+y4jyTh9kVNpNHWEGdyeOsto5CYD+hRDaXARiJ5EPVeAAwIVkTKsgDgIHJSKgmD6CoCnptqCwPAEYVo6HKPN/wFKvMp9mV9hiAKps9phFeRY8DqBkgcAt6HYC6AbD9MgGgYYCaW9DrATQNUHcLegOAlgEabkFPAmgzkIL5oncZfkuON43fouNdjt9l5W3Fb095m/HbVd4UfjvK2wLPEKwBmfabbkFfQFuk9JZb0BfSlCTabkFfRJslAUdJF9NWSXTdgia6XBLLbkF7NC2JnlvQmi7jBG1ixcq0XxooIJNiXy9pkndShXsKeRsBSHkPZZDyBkogpe4XQUqtF1NRrS8nIWQaY9NfSYCMNMYUCR+ZxmBj+0Bnuc+HMFylcUizaV4eerBAhmzFZDMmGzFZj8laSKawxryUR2RvE6XD2/18QyxI07SJNlU4RGKaLjVHWsXdFS1wN0WjyHkprVqpgGpcQH3lAnopWisF5FYqoBYX0Fi5gOUUjUgBgysVUI8LaK5cQDFNa6SA7EoFNOICWisXsJimvBSwcaUCmnEB7ZULKKX5lM+7lC5ZqYBWmtJ+Yqcq5vAFrjPnO2m/PR42HbYoxdVSzkxv0n5nPCK7Mdkbj7LX1hX2/N/V+h9+9L9++hth25qIrtaj+xjZOyvLXoZwXeTz28q06eL6+H4T5zXgxfhqEJOl9ecxVuOrjZisnc/YjK92YrJ1PmM3vlrcEMt4PuNifLW04byrQXy1GpPNDdFEOe3Xzs/VCFlT/rve/Z6MfPPf3FCQFFd6awPqsRz1DRcUKMmuCFhMSWWkq0pKH38BHuVC5OpI7Y+hc8joTTQWmqqO0yYaDxPraBOtCxMTtIkmwsR62kTrw8QG2kQbwsQkbaLJMHEBbaILwsSFtIkuDBMX0Sa6KExcTJvo4jBBtIkoTGjaRDpMeLSJvDCBECUJv3sRT7kzMouWyXfnIsxi5ELezMUvKtBQNPUuXlyg1SaFVYm3mYbxM4UcU94WHKnOu8HFmN9cXJDBI+GXLi7I0JHwyxcXZOBI+NWLeRV1AZx3Q1PmT4rKfGcJv3xNQTt+WhLBNWD86zeDEfpxxf+L7VW+kjLLji5n5LNYvwlaSb4WxuihcEXSLqpoddKxcvSYNnJA0+WDr8dydD6lCqEY3U+pSA7ctvm3qk+M2utxoaXXYzHKr6uCHg5vHbwei1G1ctRfj8VAaX/xFSeSovrDWIraD/ulKP2h0yfFMueTMtugjRSdrzjRfbsW3bP4i3/i9MnwyZfdSIZex4lkWO44fTK0P+32ydB4OToc9wPQRobqy25035pF1y3+JtOxDH/3voFIhvofu5EMjT92+2QIigN9Miy+MBCV2UUZRobe+wai+y5bdNHiLzEdy/C5bixD8TMDkQyLnxnok6H73X4ZWt24zFo3lqHeje/bsOimxd/u9svwb19PRjI035uMZGiBtmSofSXZJ0P5G8mozGWUYWQofiMZ3XfRoksWf2KHE3wDX1yVQb+YNoVW/yxZ0CmwZSglmxr4SayT1BzxtRkBdwt4RMDDAr5NwEUlaFEJ/GH5hY4u41WDf8mkWyb9HcPXNr9FR64vm+svmHTgyPWq/Ca+YPCmwVsG/yuD9wy+bPAfGrzsCh7Ib+KzruANgzcN/ppJ98z1rsH/w+DlAcFLA4K/JL8wCWK8bvBXDd41eMfg/2LwUlLwxaTgnzDpmqRhrsP4KwZvm/Q/mOsdgxdTpt5T5n2kTL0b/EsGrxm8ZfDvGLxt8GWDv5A27yNt6j9t6t3gVYM3Df5XBm8ZvGfwHxp8mVdnGdMiU/5nM+LfFYu4TDTMN2KG12KGZszQjRn+I2boxQylbMTwUjZiiLyKpPx6zPBqzNCIGToxw7/EDN2YYXEwYvjEYMRQGowYajHDKzFDPWZoxwz/EDN0YoZiLmL4cC5iWMxFDNWY4UsxQy1maMUM34kZ2jHDcszwwqqIobgqYghWRQxfiBmqMUMzZvirmKEVM/Rihh/GDMsxQ3kobg9DcXsYittDzPBazNCMGboxw3/EDL2YobQ6bg+r4/awOm4PMcOrMUMjZujEDP8SM3RjhsXhuD0Mx+1hOG4PMcMrMUM9ZmjHDP8QM3RihmI+bg/5uD3k4/YQM3wpZqjFDK2Y4TsxQztmWI4ZXlgTt4c1cXtYE7eHmKG6xtoeTvw/r2OQca9O/E8mEjucZRB7np91e0ygJ+RL7/1e0pSR8D9k0R+z6E9Z9MsW/bnv8QiaMHvSy98zJdeZsOOzfY9nmX9nDZAWXbLoskUHFl216K5Fd0D3LVcSfnsFrLUC1lwBa6yA1VfAaudifsLLXZLwZ07oVRsTlAknGjqLaUXvAspiTYQYTDvljAOGsd4m1mf1LmWNV2+Asn4ze87SNsvOpPohdv79EtvqZbHGJewoVoC0nRCJ1Zi1uYptl24K19n4NCt7RqwdnvPrmZOYf3QvQVTlHLtPGGSve7JW5iZ4YQEbFSVX9m8GsS2L7Re/vBFHKptoU6wJbbIsXligS4VsbixAzHNYVsHSMuUHFxYom78czXhTAZVxmAbRe0/LfZaT5iFoEzZr8oHsqKbZVO9S2rT3Tfzve2Zpr7kCjk2yUkUOitc5439nlT8DOzWXMn4VW2S8SmpRgdMFvznJ22YOZaac3gWY1SUps8VdvsC0wWvAWLzQ0hFjZNFC6oyULKTBSNlCmowEFxb8ZopvmPBLX0kA615S8JvKYMt/wlhrk6WmKFDTgroCNSyoI1DdgtoC1Syo+FWG2pssMZrfZCy43BKj9i3GFrdZ6nICFS0oEGh5awyVBepZUEmgrgXVBSpts8Qo/oWIdqUlRvcv5Tl3WM8pUN2C2gLVLKglUNWCmgIFFtQTqLnDEqP+X0W0N1tiBP9NnnOX9ZwC9SyoJFDXghYF6lhQUaC2BVUFKu62xOj9nYgGnxKRHO2/lwd9NWE9qWBVG2sKFthYQ7CyjdUFK9lYRzAYS8fSVH8gEn7blqb0L/K8r1m5FwXr2FhRsLaNLf+zNHMb6wnWtLGy5O29ZkvT+R8i4v8eSzO05+d//zPFz3/8T1975XnkXE1uHtadzg4n+LMkDe/5lT9rtb73+Z9734KRE9sEAxhPMzjz4fPp1SrJSuThmS3bK4jCtjI+OsQUQVS1lfHRIYYGUM0SuwIobTHFPjqYWhD1emW8czB1UBTwlfHOwdQRUdFXxjsHU+ydgyn2zsGU8c7BtPHOwbTxzsG08c7BtHjngAzsA8ulAWjrOjgPRjpJTqix6opCfKoA5SUbzBfA71AyBAcQuHHA/z3XGLco6T17sGDCRqDC3/xWI/Dhebd4GPXeTuASfmKVZcFKNlYWrGxjgWCBjVUFq9pYTbCajdUFq9tYQ7CGjTUFa9pYS7CWjbUFa9tYR7COjXUF69pYT7CejS0Ltmxjxb9mDD+xyrdgizZWEqxkY2XByjYWCBbYWFWwqo3VBKvZWF2wuo01BGvYWFOwpo21BGvZWFuwto11BOvYWFewro31BOvZ2LJgyzZW/Bupv7+x60+wRRsrCVaysbJgZRsLBAtsrCpY1cZqgtVsrC5Y3cYagjVsrClY08JIbU207r060boX9SbX23aejmAdG+sK1rWxnmA9G1sWbNnGin8r9fa3dr0JtmhjJcFKNlYWrGxjgWCBjVUFq9pYTbCajdUFq9tYQ7CGjTUFa9pYS7CWjbUFa9tYR7COjXUF69pYT7BehPkJL8md6vLfJgrQjI96VQbcuFsdQLf6FLpVN+5WAeZXAieekr7WDcEkvHcm/b9IhH3tFrd8dNYtHzX2uKiN77Ilt9kEFww/8axVsJqNVQWr2lggWBBhuXe7jnp+7DmoNgWI1u5gcIHpKEdvT+F3UUGhFAMTtDyn3Weh3omD2kH8HId6J0K8r8LPYY8NdQ56q/FzwBvGz4KXx8+ct0ZMnUbYzgealFDhHGVrIW+MDYq8cbY5gkIna9Ly0OqKS1dy/SrcwbHp1URFrK7WVQKxuBqviLHVWEXsrEbZEpitrNYyNEMjwjtHaxhYgBk0pGRjemE+COt6PAcNCfMR2FTiMRGhCU+NMA3C+ywsqLleoKnOFcXB6KXuoNTOlQmdeK5dNswNAl7DuFjDuH6SndL91oDKPM9PmsWqTQ8U2BHAQEG7po04UELh6QpTPF1hiqcrTGG64ie8jAsLvqmCTlEGLXagcLbaprCaGwgbXIoGMA1IYhqQtsH8SuDESiAVUPBADGZgupPx/7s0Yhaol+IDdaaXU3w2znQxzcfcTC+m+cSa6VKaD5+ZLqf5MJfpID2Ps3+mq+l5bI8yXUvP40Se6XqaPUoz3UjP45yc6WZ6HkfeTLfS89hCZbqdnnfbhu6k592Oobuw3jV0Lz3v9gy9nJ7HNqvDLqld/A1fDPusdvE3QkqMlCykzEjZQgJGAgupMlK1kBojtQjJos1kZd2bezXvZJ8ffA6Gu43/bT07TTSant6AsWBjs/XaK+sLfJTZ+vs1BTZeb11VQCuBI4+tib/74npYC7EBcOeL6/3e3yVPFvziXIHS+e1YSzPsOeSifHIggrMDWI4c371+iI9ArkY5lMn/BCXyU6xSpvUg65JphDqCNtjX1nvD/oDv+g6lNH+5+IyPoR+dlsZs/O+Kyey0NOtzMLIxnZzkCElqa6KproMNK74quD5WWxNE7nX72SIq5N/7rT/Fv+/vPnbdEH9dXKtTQmXYghJUHvN6aFIiMcGaZKAIU3umpjC1Z2oGU3um5jC1VzQQeus7LvABzO6ZOojZPVOHeXLP5BGe2zN5nKf2TJ7imT2Tz7IbJyaL4naP6UVxu8d0SdzuMV1mt3uITaJwgNVUpKL9LCycukq0ajvgH2bnLArqyC2VgxY7q+KjAlVYgftA9oVUfIhNfBUUmlEauw7lEDQOd8/uPvi12Zr4hvIT+5+6OvEN9ozjO/sAftOA3wQ4SLkllN1RccxBcF4/qXNwBijv9evsmyo5lKBBEWTJ7IH99e5jnpPzFeX2BuO3fAybYsfImQT3gOdg6D47x8ERinLYttl53nd9Re51MBZ2+fn2Q5XZxUOLKS+U/AaXXqTBvT8z+hv7v/vTH91d0XzXA9zyorA7mYWKzkH+Y5PHBhZ8xx8QSSd9R55ycpWD+hSbYET80gjtY8yCz46CbDZvBislLWZJ58+ORUEQ6fSLNR/ujUVioHPn2PlhHOJloGWal3vpjF4jYxjWkwHEzFWW9NB5ecv8WhsqoDUy1vGqM6jo1bS6shSXOPTSGT0iIx2vMwNajRIreoiGKkuW9R0XPEhrKvKoudPstCCgkYo869Bp/F3NcD6wZF770hnJEwR7b69f9N5/uu3yhWNeMuenKDkEE3JuTEPKT8D3kyL36gTBEDz6dp3o23Xsb9eJvl0n+nad6Nt1om/Xib5dx/52nejbdaJv14m/XSf+dp3423Xib9eJv13H+nYd69t1rG/XCb9dSl435KziLwxP6ie9ZE6+VZgUJa9OwMhdie5zXkhoRSN8l5pyEuy/IcFuAbgPnncbX1vP+rPf5p/ut9cHdjfIbN1X10tfXb8EJi9M1i6B2Q2T1Utgx8JkcAmsV5gsX1LxVgtZuqTi5YVcvKTirfGV57oIG2TmbWw4DR3ZQUbmMIHz65eIrxa28RnEWBcCw7SKgWoIwOUGgCAE2EAKg2oIrKY8A6UQyNMaBhZDYE043xo0c2woIGvKIXIoaoj1kzUNI7JomK5rWoXIo2G6pmkIkUnDdFXTakQuDdOBpjwim4bpsqY1S/Pu8lfX58zIbcbqA+yHOOF32aJ4i1t7Zb3Z7BMT4+XG+niy3xas+GXL7Lgj2KKN9YxZ9CuWufOyMYu2sWJLzKIjLPfnrko9Z3bG+MOC5a4yA3RGD3CC5+95ncTsVvHYDKcdKb5G/I3pNCfYmcGURvyyQBa4LneCMAZG51eB+du0uyDefdC7wrEPdszYddW0e1hyZsKcR0zO4ybnqSjnsyZnUZmsi0ry5sO8JWUyl5XJHagoe1WZ/LUwf93knwjzN8L8zTB/K87fDvN3wvxdk5/C/L0w/3KYv+hE+Rcdk7/kmPxlR/JPhfkDx+SvOiZ/Lc5fD/M3wvxNk38m9z4sKJznfWnYTnRwhLhwGwRdduKhlK16WHtfzB9ik8VjOS+JiSLH3LZLETOCviJE6V8sJqwSPJULJWmtKMmie74kDVdMLfokSYkk7fMlKZ0vSdMV6wxbEieSpLOiJOUVJGm5YtbRJ0laJOmeL0lwviRtVyxBbElg3wbn6hkpqHd+QdXzC+q4YkNiFzSQo4z/vcQNlHyS1JOUepKcJyn9JLlP0sCTuY/8veNe9fwvq+cUzB/yJ/SFG3nPiVWWcOsp5/uvJ/U6EN3Xkwd4jr+Oh5Hvv568JOH30if02o28Ogi+kdTjNO5//7V0YcpJ6AvgtetkAT54ONPUyYKoPK3DSMTXoL2oVX6a1tC6rYnM1YnyUSHXX5140ZAbrk6cPkpr7YPXTro/3T4n3Ton3Twn3TgnXUda9GrWmlBEa00oIv4tmd9F81s0v91zyqkZfDlFazyX1iHgp2OqBm55ECTbm4YR3N8kTug8W8GVcuzia17OkScYK44yNosuei2TcPrSE3IXRgYhb0FfL+Q+DAVC7sdIIeT17IjJuxEdOkzvKOG/tgFjxyQfs4Z31zedruQryrudbqLr6foK7af9FdpH+9CX3EK3VGgX7aoENEdzFZqlWQ4yebpCN55Brlt4Y2KYz4+z/nKyoMdE+iyOc7Un8rvgoFsg0AJloTuMkVfvOp2vqArN0WxFo+S8z5zx0bQegaJ72zEz38t2Cx9r0QcSo6ffMQ2+hSyfU8+ac+pRyrL1CPR4owl0RfPTjIYutvi0Wo/QrMXRdyO2ietzfcbH4/KoWh5yIj7advOXQ1s57+0Tk4P9rOLsXc8KxHgj2Aq7iR92gG6nXaF17isVrpCb6Ea6vqJR73gds7QvYHHwd846+8ZD6DmapbmHJoO8Lw6Xhv3k0wU94i9PGPeOKZxF0whU3VEHj/C/f34FT8gPoUP1az/hjbgLlKIR8zobukB4k82LCqHic9ZvGrBlgy0DtmNwBIdEI/4Yz6lS/uImcKT8nsy69JxRGNhYICZHpRJTftEwdjeaRiKMwaYCGbK9UTga/RzlmKPEZcxFd6mFdxF9A361o+wbEM9uavQr5qXjfZuqLEBTfmsicd1Q7BgJn+PWxGsb8PdduacG0KCXJ+VDzcXNYpc0i9n/H81i7jTNnrEbBN43GsQuNAgk8HfWahCz5kuiuWNoEDkaxtRy2ChDTBhliK2J8lEeLhUo38FOSAphP3xnH8JzeFlE4Jw7oUc4cKeL0z1+j7wnp7xZ/M7hs+Zd4F34XfD28c6c8vbj94B3PW/OKe9G/B7EU+HhbsHPEe92/Bz37sLPKe9u/Dzr3cfbf8p7K434zVlWoJ+Z5YbUkNSUpOqSIknVJDUhqepsrHg/4gezsX4+tPO9P1fgmTPKRCN+LSbrEUl/jmh9szTCo8EcjdBb4yBX824ZyH02UgJyt40sArnLRopAbreR5VkaoVtspAfk7KsO5t0uyOtpfzDvdkDuo13BvNsGefZ7D+bd1iyN+K1J3hRUBT1qVFm4e62qk3pYLqMfnYPp3CgNswHeBPf9Y2G3JmVMRKpmCycMb+nH8yISlDCXfzwzIkWlmBmWg8PiEbWfOVS6MxuZ3HGgMfIzjZ30JgxfNowhN4dhxku5CzyCeLO+8obdhbA0f+ykHvXH2G4wCjFmSqCxOJ6XQCkaPY9pNGaaDQJvloYR8WvYdGkj8l2PnaQs89GsPApQmrCgFJ4n5Y8h0q+5WRjjeZZjPNsPTCN+ebbgXeQnvNTZSVnpHxMndG6jKTfHrvXzN+qNHAMHN/cuxQmSlFdV+m3eHZTy0u4CvY3uqHh3+Mrb7C6YRgK3LGMn9WWolClKR8+bpRRNxc+apTRd1nfxMiv6WRB4d9BmVMRmI3HOL74JNohjJ01F0x2ih8UwXWphaTxpWqrCpXQotncH10NUUVIqm3WhXUtIlUnelM744ydxcJE1lcEN4Y7+CQBnpazlUe2OM3IKsRb7vxlU2xRlEAHvEsOc8WvqZMHb6sOybdJLUYbbndxDXlCaWXC7t9kTgXhcuAPiUZZv4WXpUl8hUEy8f2kKS8d1zX5nKkveHXSJl83RpdcNJdwFuiO+7dhJ85o0fIyED2YK0JdxbrirqLJDmwwXlcW7yZKJRidZwnvSHfS2M+za4lI8/aWU9rJ91Z6jSVyY5NrRmehddIYK3jDl/HK64I1Szq+m4Aso5xeTcOOTgzmrt41yCOTmXUE5dDXeDLw0J6WOu+PwBpTzg2TBw6srjRe8zZTzWwMFbzvl/MZYwfsJ8LvwLZTzu6M4jcjBiNcbwH1HC94q8Ds4t8j5jbVw6ZPzi07BW005vzdS8NaDn58q55dHCl4GciUK3gbU55qCdzG/0F6+YJqmi9jXmGpOYnDWV+ZvQQHDBZrkqedYqF+UQ7xTulLy5m+mHMw/eyn8rQ6fXZBXhwVaZqgGqGagYhp/64DqBlpkqAGoYaASQ01ATQOVGWoBahkoYKgNqG2gKkMdQB0D1RjqAuoaqM5QD1DPQA2GlgEtG6jJUBGOp4p5gVoMLQJaNFCboRKgkoE6DJUBlQ3UZSgAFBiox1AVUNVAywzVANUMVMywwIDqBlpkqAGoYaASQ01ATQOVGWoBahkoYKgNqG2gKkMdQB0D1RjqAurm0fBS8N4+iSmznjD7YjkOZ7uDJqHmqb0IbaegPzUJdVCtI7SVKuhBmuSZ9aYQpUmoROlJca+fohxdybPBQdw9w+bAPBImkc6zl5FAgqPksJ+2I/YFnDNxHyTNz5Dg6oALMS45B4VxvtEMp8omNcWpkkkRpxZNaoJTRZPiuoFeunFWn6PcFrfHkyrU4hrvDq66Nd7b+HWt8X6S39Ea71naQBfzRG1KKMKNmJrATZjK4wZMcRQspriWLoXu7QzEZopLYYpLYYpLYYpLYYpLYSphJGyNeD/FL3/E+2l+4yPez/BrHvGeo9W03pTNFJfNFJfNFJfNFJfNlMxjaMpIyBSXwhSXwhSXwhSXwhSXwlQo4fJa72e5wY967+RWPuo9z0171CsqGqBVhpUpzs4UF8kU34YpvjVTLM5llLYpvsoU52CKS2GKS2aK78YUPx6+nzHv5xW/7zHvF5iojXkvMlEf804jZPlPmDsxxXdiiu/EFN+JKb4TUzLHo83mTkxxKUxxKUxxKUxxKUxxKUyFFdkc936ZZWqNe59koj3u7eKXPu7to0sQWIdLZ4pLZ4pLZ4pLZ4pLZyosvbzO2891sc67nqtinXcj18Q67ybu1ca8W/h1jnm38+sc9+7i1znu3c3SjXr3sXCj3ltZtlHvIZZt1DvG5a71nuRy13pPcblrvbdzBa/1fo4fZnmN9x4miiPeLJc84s1Rjp7lxjLC7gVz9JM0F+AUK0dv48UBzlfuoPcodio4I46TZsTGcEYcJ83sMf3Sc/RzYFtWlKOfobcHHFItRz9NTwV8iJujn6InAw7AdoUUdIUUdIUUdEVYUFHRsYADkeXoeXoo4PhkOXonvTXgsGU5+lm6L5BoZlLQNilomxS0LSzotKK7A47qlaMXFd0VcLSvHP2CotsDjgKWo59XdEvA0cEul7Iul7Iul7IuD8vaRzcFHCQrR7tkXQXyk4quDzimVo5+WfEiq52kLVLSFilpi5S0xZTEUwCZS12E6QRSMlvI30oT6B5LHMfVA7nIpAZZZHITyGUONDvJXSmTV9JoqNc8RsPhbONNmHi9yazYed5upoOhsYLLluuim3uRUfthitV+mGK1H6ZYS5kp1lJmirWUmWItZaZYS5kp1lJmirWUmWItZaZYS5kp1lJmirWUmWItZaaMljLTRkuZaaOlzLTRUmZatJR5fPpHjnW1ERN5118DrWIsihpz1tZFznnObFi4+1gtAWrc2NGI9jQYV1sTLx713f1QSsDm+8XevJhETskPyc+EbX/rGmtc3BzavCHdtuiWRTctumHRdYvuWfSyRUO7N6QXLbpk0WWLrlp0zaLrFt2w6KZFt+x7/Y0lg0UvWzw9i+5adMe+l5W3btE1i65adGDRZYtmxdf5yENhuI0linCsoWto1hw2NGs0z8eHHXqe5it6Xi6y6rWhayGNPb0UmtCLR2leGkT+6rhlSCviwzXhYYdk+Zc5JhriO+d3ogRna2J8YAFbpTREQ/6/mfOOMXPewZ6jjCJcqJSXipTyUpFSXipUyhOKv06m+Otkir9OpvjrZIq/Tqb462SKv06m+Otkir9OpvjrZIq/zpRssvHXmZL9PP46U7KZx19nSnby+OtMyTaesSFImX2EEaPtKvsKw7Gya1ZsCEYLNEyjNhjaEAyHoNkeNjYEQxRWoCP7jWxN4LA1gWusCRzLmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawFnBmsBZwZrAWcGawOEOTjsyLkbnf2FPaDrCWbg/hg5Bfx84G/aB2PaHxqjO+p2LCt4YjtuCi707/YQ37Cc8jQPO9Sd0ciNU19trsYVXEidByXg/7k6rs99Nuyv66TN697zbhRfl3fNuzfwuj66UCZ09Z3qv4lyNUeFeNL+ttdBXxPKVHA0ne3nSztZEy4l343o/9LgzT/rt1QUvg2gRzgk9uDFBgwhvEonMKuyBg7skKHZsS7tZ+6WyhJ+qox+o6CPo6M/lyAvHAh0RouZU9MPzVrAMYZuoLHk7fcXbtjsp7c+c5A51ggbDLVJsEu4Md0+lxxyknchbdyr61nkrxoYowu5euUh6gyIH7CIbTkW/Zd4KzSFq8m9Q5NQbFJm0i2w6FX3bPPM+MO/OxXumO+0646p6IKwqfUNFPzHvLqxUMbghwVp4Jrqllw4Pu5xz6+fwvHvA73NXvGLV/MhC3XNr6N559+CPLXTqRxc6cG4d+RjKB+mGeeuw+bw6epZukDqqO/pARd8z7z7LH5/zIx7pyI+rJzzSUcwKzn0m50c805EfV1F4pkM8vxikA1BzfOOnqik6II/VcPSeir4ZmpD8XO6PkKCk3vDBHKhceXspI4Log3RbHMM90PfzSjdD96NZZugg+edcXcbVQ3RbhY7SWyp0D91aoRvoYYsLUeuuxZQrQzvpYEXvBPPNYD5At/bx6Qd5YpWhazELzNCDmAKidB+l34vSD6P0J84v/TiX7qPge1Hw4fMKLpuCF6TgA5QhH5LcC0kOQ+wn6OEKPUBH+kvn4mckbwZVEL+PvbQHirx7UcweeoudD5ka5o7Et/Jxq3txq8O41RO41QPn3ApT2QztBe8eurevPJ8jwGfIx4Q2Q7fhnm+B6LdC9Ich+hE6UiF0+f2F8g4oaucQaucoauee/trZzWq2qOhDqOijqOh7UNE39BeFOTI3hcOUwRDyLAt7CMIe7RN2N4eoZx7Y9dBBOmQ3m90ceZ4vLyoWbSdEuxmiHei7Jev84iY7cZObz71J29ykJjfZad9kJ4e0z9BO1g9GGXtRxh67DN6wQc695+QsOQwfrPQdaZviuooG/cDBSjuJPej2avxtrV2aZxKJDkNtQB0DdRnqAOoyBAWkHU4jzXR7NaLGOTH9P8eYrq8q7HCWhW6kCzucfxO66RR2OL0xKbrHRXdRdM/cbZmhHqBlAxWH+QIgkEgsMlQchQqugUoMLQIqGajMUAlQ2UABQ2VAIP3eWCF/p/QgnukovbdI5+sdlYHK2yPTAO9a0+fcIP2Z94QxizuIk27yHhGDtr1iAXcvF6K8A2Iz9wB4Jrz7xdrtQTGPO2Ls627Gxbzniw3crWI0dxjglHdcrOUeFfM6dlee8W4TM7kTMn3xDonL1N1S7Z5HWS9Dii0h0jhknuC5j7tAg3DzRBlKiyEc3z3I70GrSGL1lhaO/LXcA+tR6BZM0KC/vLrArkK6KZ4oIU2jWBgOTrsdxkYxe9SbLN6ewbGC3GjhywbvKDjjjfFiWvCyU9CXWPgi43wr2Ii1HKFhI7boCg0bsYahYSO2bGi2ERsQGjZiXUPDRixICg0bsbahYSNWSgkNG7GmoTtis8Z0V2zNmDY2YsNsvTUodmJQ0OpIspiR2oKf8VGudn/mJAawej6cs8vFCagzNM4BNwFsngNuBNg6B2RtiPY54CUAOxYIt+qjLFctaZ3Vp40ahuMssO1gGooY8oadUBHjYe8eknnCw3RPxbvHKGII17CfhiJGGl72Y50DUwJlYtUCgdKWIkbIZCli3BME3j39ihjSaNN+GrMDPuW+R56I4VAV4x5RFwyfah+HMlTsInP/kEuD/L5y/AYRbKebEWiZoWoWHXZWoOIq5gLUNdAiQ1VE9akOClQSLkBdA5WFKweunECBcAHq5sxnJp/YHXp0a6LhDinyfCxPsB5ZNZALaynUILkHmhNcGN6q30JsRT2Mc3Io2+T3kUeS4r/5AyigNME9PCIjSKeM4rG1zD1gfRX3gBC8PChQg6EAUGCgJkPhE0cduun0y4Nxp8+06fSD5H+i029x0TUUXTN3azNUB1Q3UIehBqCGgboMNQE1DdRjqAWoZaBlhtqA2gYqDnGJgDqDtJsOYYF5gq6la+k2OoGVT0XfRocxyJJPtwKgw3QbYJ8ewMSC7qcHGT4CmB4gHxfvpycwlaFHaC9fvJcvYqq5RE/Q/WB5hG7ALIGO06PMUmCWm5nlAFjoBnrkLGNFixQMM/kWLkq4GTjKt39LdJ+CwE9UluhWwsUH+eJevsh38w6aEe6Qu0Danzmp0/LCsEvAwzilCxpel/Z+6Ae/G/zH12q72DJNzp4ddt/bf0WC1PKVfP8ViVjLVyb6r0jUWr5C/Vckci1fmeq/wtFrSeMD1j6rukiLEvHfeMEvA/k9ZiB/2AzkH1RmJP+EMkN5oMxYvqTMYF4xxlreGbEa8z4j5l/ey8qM5L8ill3eZ5UM4lWxFPN+1Zh2eb8mZmjel5SM4HWxOvN+T8zHvP8iBmve7yszbv+B4gad967mTzLvXcPNfNh7M38Ow96CzNK862TO453k1p733sUZg7x3B38Ew97b+GMZ9n5S5nDeszIj8n6KC8h7P81fc977Gf5Chr3n+MbD3s/KBM97p0yXvOc5fx6H1PhG8zgixgeUxxEx7j2MI2KeueGImCdUOKBFKXkc0ELuvLeL5YUeLG4/7O2XmZ13PYsx7N3IReS9m1jsvHcLi5v3bufbD3t3ybTPu5ulGPbuMzs4ae7XemPQwMBsxerd9HD+bnueVnNknlZ3ZCrWcLybTfO41VT/YX49p70H+LWclslZ/rTMziZOy/SMTnun+PWdlgnewmnvHfzeT8vU7OBpmZstqtMeh4h59rTMy4rqtPdu03ZOe49JMzvtPS4N77T3PmXs9Qcpw/MCRwz18TnSrRVM5rGnR8Dep7COYPdodDNvI+DSBC49hiuPY+HFlwO6t6L3yvU8rhdw/d0KDCewkBCugG6o6APClgHbI2B7FFzHwfUOOhCxBnRtRe+RHuEBsJ0C2xGwPQi2+2mP6TWY+XBFdPFYv0w+3eFw0cH6YYPyCnk7MSOvECbhZfPCSuaFLZoXVjQvbFnJC+speWFdJS+sqOSFPSvv65S8ruPyto7Iyzps3pW8qgPyohbkPc2ZtzQj76ij5BW1lfc+xlvK+xATTeU9wy1JeR8O+4RS2H2UpWdR3gvKONNYNJad3vuNuaf3gbCjeMl0DL9oupqPmB7ll0wH8lHTUXxMbF29j6uomeh0gUNVD0u/rXfSL6qK+Fn36TiCD8JSby+9pISe0AeoZGjSe+h+Iaf0tXRDhTtZh3bSR1SFfHq0EtBeerAS0AEqI88eerwS0LVnF/+mo95Jv8ScBeY8wpwvCOf7FLPeXDG9/U76KLOeYNZTzLoorB8S1lsrZsjYSR9j1ncr5n2Eed8vvM8w6+GKGXd20seZ9THmfAdzfkA4PyylPlAJzmt/1mI3SJ632K0mz1vs1pLxYpfnNPYCd1Gdt9jNxNMenuqYac+iOm+tW0+et9ZtJM9b6zaT5611W8nz1rrt5Hlr3U7yvLVuN9m/1u1b+WPetLZ/5Y9509rzlva85DdPzvT/wpOHGwiYfq3tX/hjXry2f+EPhY61/Qt/KLCs7V/4Q41xtH/hH5gjAmvhD9WU0f6FP6a9o+G0SKSWR/pxk4o/VGYY+SNlxpVXwmlFI5xWfFm+eUeW8h0lWwpVJVsIp2RkmpN+LiE7BV3l/XHYiXwlnIP8iekYvmrmIF8L+5tXzRykaXqMr5s5yDfCruWbpgv5UzMH+Zbpar5t5iCvma6lFc5B/kzxW4xjlHHVUNZfXIu/XUR68DOF/F3mxY3x1pdU6TjvUMmkfpy3l+S1reMtJ3mrY7wzynR1XKzcuZ2N8/6svNN184hdJHnHecOT6do4bx1K6xznHVt54evm4a1c8o7zFqCsbMZ5907a3Dhv1UlrWDePEEiSd5x35mTZM84bcfJc47zrJs+1bh5xkiTvOG/SyZponLfd5LnGea9NnmvdPIIpXUt7z46qlfzLMHHxaQ/tlMRD9F4csXnH6Gn8PCmeY6UBZBFKA+S9OGfrXuAdkA0enMwD/rCSraFTYuGMIQl21BiRxvD7Ev+S9wB+sK80hoGsxGjG8/GT946IGdK7ldhAe0+xxbX3drGNhiYaLLGhiMZW094s22h788g25b3DDNdj8lnzrpIyw3aKGzvvVJUc7378Ljre0/gtOt4j+F1W3nH89pT3KH67Sjaxiso7gd9nvcck7s/j+DnuvZef+Ij3DH4OYzhNQdhF/j2AwTQF4T7Av3MYQlN45I/wb0dhDE3x6P1RJloKo2iKR++PM9FQ3qeYqCvv00zUlPfrTFSV9zkmAuV9nomy8n6DiZLyvsDEovJqSrbmflPJxt9vKdnc+23zsn5HyUv8XfMSv4jhewxREE/qLFRIHMoWdFaG799UFbz6jN4jI2kW4/e1VDP0hL6BPm1o0jfzyJvF+H2rDIrQKtlJv6WwQ7woIyBG3Bvo15G4GeN1QLdi2BddlJ3028z7fuF9jHk/J7wfFd6nZQgH7+8w7weE93Hm/bzwfkx4H5ExHLy/y7y/KLzvVcz8G8L8cWE+LqM4mL/IzB8R5meY9wvC+ynhfVSGcYVhXJmDNPRD3AzRHNEMs9IkNdf2Yans+82rfdq82UfMiz1u3uuj5rUWzFs9YV7qY6ZRPi6NUprhKWmGx00zPGKa4WHTDA+aZnjANMMF0wznTCucMY1wyrRBMk1wwrTAvPdpaRpZtulU9FEOoMurgRQ3jwpJSRm9p0JSeF5fC8tdueOEvqFCIgTpmyskck3pW0M/Corux5T9MObon1bEWT+lzs796OMK5xYfU3Rr6K1B0SKvM15Q4H5GmN/LzI+D97GQFc5HToCzAMZHhfE4+B4B39Mh30Ro+sTvzxpVcaqEnjOjMXtNQuKb6Qj5lbOPGSB9QN9KDyJ9raSP6xcU77qcfd5AP1bhjZokKuMj3JLOjhYz+rDwHtQsEchTehHiB/o4NzTOMqF/Se45pyE+8CRi3p+QLM/q90uWp3GOxDlIf1RyLOj7yQh4RD/CN7mBBy2l0eD14xXLu02gn+k3W/pFZUUO/4Cim+lD6uzKLtDvU3QKq6kP44iUygrz7YBPlOTgDQdAQXAm0HvpTtpLdz40CcpyVMTosUl9J91ZeUkfoHdU9J34iqz7/boK6AVbgA9brpcq+hTdSR+xL39I0WFCIY9a4OdUQIs21zsCzf3BL9ngxxQVOOsJC/wNFdD7ba6Pq0B/wQZqaP5W+lNouijmEQv8TYUWaQGfVoH+LRv4bWW/g1i75JmX9O+oM7qs6DGL+zG6k1dNT1vY7yp63Eo+EwQVjfewpL/YHy4XH97NMWeAl3or8XpLn31j1FfFeNmHbeYPKXoUL5beEdjwO2gvPsqCjZUUr90DQqVhrYS6sRk+rrAHWQkI1fEpqzrsukDLeoyO2/keo71nu3viRzxOx23vT19UL+lPqzNn2wmdos/bRepTtBe9NaGq6ThqpqKfpqcrS+e2eL7h7yo6gOWoPoARJKjox0/rx86SqD1plWcb+jkVJQ2tHw+opEia0TkZDqAvk5aBK30PjbdApwjaBxglg4AeF4Efp8ftx33mJf2SOqOfQQ1h++Njqu8Gn2LnLvQ4npI/jg+pypL+wDnt4ZBoCTxMD9Nt9BlFO+kPVEWfqizRy4qeoN9XBDpQFf2OyhKdUXSUviRYXRGgT6iKhsoDVRR9UNFbqCqXf1Uuf1ahbS1V9CH82UlLCufdtJt+T9j+i7D9mrDRryg6VFkC107eYcZffZCuqaDsQ7jHQeHiC4fozRVaoE8gM+50SEQ8KAUyyz0VOkmBondA3ntErkPydAfl9sz2cIWuoz9Atf++oocrS3hIcFeF+zPC/XuG+4NK3G/upKsrwZL+BO8hnp3K0BN0kO6o0CF6G471f7JCPwVdgWcpzvAuhRxP8LxeQQHgIP0MMjyHDD9boeeR4Z1Whp8G/1Ge13NbeAsdol9Q4H5RVWAr8HAF9gmSgQ7Sz6Nz20lFvs9beG2gKnQbHaJ9yLS/Qjciy/Vxjl2c4ZOc4TZeHCioNhyi25Hhrgrdhwx3xxlu4Qw3gX83L3r4gr4He34YHOdpNtA7sa9C71Ew5tAHMbzS2+mpQB/iOaN+ONAfBDd2UOhm7PYdqegjPI96t6IHKxp7Oi/gMj1Q0Q9UAv2CWtKB3W0uKZKar3PNJ8X9EVdV01RVkh0gET9Vm58qye6PIG4FIxlvI+3EvJQO8mbSIZ6S6jMq0J/BVZbvMO8bPcr7TIsQKNCPLum+fnQxFKYbCtMLhVmOhSk6Rhj4UmJhSuwCSb/MwvwSC1NgYU6wMJjz6l9Rgf4srrIwBRbmBAvzfhGmsKTtgfOEEaXsGFHglolFqTqRKLVQlHooSkNEeT+L8lEW5X4W5REWhacLVRXoX+VJH0S5n0V5hEV5r4hy/5I+jB4t0AfinuoD6iX9yBn9XgWuD6nT+tcUPX1aP033ntb3ko/uhTVOZIuNDmMyE+gbsKOn/Qp6g5tldLaHI31nEOib0VliCkbHT+vD2ORdxIC2t0K4ujcI6BlMyOjx0/pWTPwO0GNnmc4+ZgXzDdpLz6CnuLNC1wYycbsZne+tQJ4+O1miPej992BaxQPDnRDuWsxx9lTI52Kinruzu4KKexj1dkZxxf2KwqddVRbTK7yzffYToCPc3h48+7rpAVS0zfJBqd/PKK7gz+KDQMf1AH+A+M4q6Ap3VgLpx9AODlWCYCkI6HcUFl8YvfIvx19LQI/kX1bBEj0Z30Vfy8eJxyzkBugh0W76Q4X/u+nb3Kr/TKGylug1jAgtVNcSfVlx50zfxIjwp4J9i7tHavALWaJXFb2CAeHrcvUbcrWpRJEL/ekfK/ojRbfRV4Xja8LxJ8xBX+E+F9MSDAQ+WusfKdqLTHySubuClvyKooNg3S039OVEMqCj1FC0B3e7TYrcLcL6ck5JT9CXMdh9S/EB5DeE7WvC9pphQ/3y49OdeGzI9qfC/3Xh/6rwf1v4+5uC5aCDHsKbwb8lbyfWhK31OFrYCTclMC0IjsJD7SePcmQD7EIGR9nmA8YcPTHmEEsEms5fAyMXca7NZkaIVneUXRfSdP7NG0LfKNrxEzfZngBmeVfQV096Ked5EPv6rvoJuf7OJ71RaFb0XWIXPKG/BsdXT4lX62Ho4wyzPg5bukBjXJ00+wRzWPJHV8RXheM78D81Ak2JERoVlUh/7GTOcyjFxlWiv6F5I1I2KqMCvNkcagslu2HJrB6u9xlvM//6SiWg2b1r/nHru178xJNvfvmlvd/a+fwjnw7+HeY7Z/KfVtbbmad9e3/qv1+6PfO55zhX/+UlPbs3+ON/+n9vPPA78xSTxybzLysYAdWOwp8N7QoCNuBhs68BqG8ktiY6amChzwxn1FiRZCMznGxkhpONzHCykRlONjLDyUZmONnIDCcbmeFkIzOcbGSGk43McLKRGU42MsPJRmY42cgMJxuZ4WQtM5ysZYaTtcxwspYZTjY2w8HWq2LFe3+u4E1gt814fWHdfuhlpULLnJHYubwj8eGHYZkzYoN5DvmRikEFyxwVW+aMxqZNkWVOqs8yJwVPv/BIT9k3+I5wZTr/Zm/OWaAUfzPuOd/MPN6ui29m2HkeRN83My/fjItvZsRPeK51KRaR3T+kTI245tuhFLfxUJtN/Hq5b3hlPgjYGMwpeC4pfD2KRowxJr4el4bx9UT3FDemcMXeUex33IkK8uZzNMdRi8Uvjp41H9Eu+yOaX/kjmj/nI5qlXfZHNH/uRzQff0Tz/R9RAJ/PeVYCciUK1gbKw9OGNJLQrjQfvt7GxeC+mD2ZR0Gs8n6bkUUL6TBSspAuI3HoqzzcLiGaVhNl9viqFQYr79cvBWRFwcr7wRSgOAhW3i8z0rSQEiMNC1lkpG4hRUZqFlJlxIp/lfd721iky637t2f4ObfF+VqMFC2kyUgc+yrvNxjpWUidka6FdBixAl/lxV+VHfcq75fm+dl2WM/GSN1CiozULGR5jl+nhfQYCSykzLmsiFd5v7ObRXqzdf/mlxP8cLushxOoZ0F1gboWVBOoY0FVgdoW1BLICniV98tNxuyAV3m/+A0GrYBXeX/564xVbawnWGBjXcHKNtYRrGRji3IPO+BV3m+1RMJv29LU/1ye9zUrd02wjo1VBWvbWCBYy8bKgjVtrCGYHfAqL3Z6bl/Aq9BiNS+2zHmxZc6LLXNebJnzYsucl1jCeX/hhFjbMnBAfg7Kz2H5OSI/p+TnWfkpKvldNL8l81s2v6bAlkk2zW/D/NbNb838VsPiHFO8+V02eM/8ds1vJyzP8NXNb838Vs1vYH7LDuVXtCRu4sIsH8nxb1tZjDAoCxkDJQzH5WeG4C6YO08/EW1Qn2cRPMYWwdZEbg5mcJMndHZjwk97I8aHXno/++3KkmtcLPLRA8uHIR7HUQ5MmFsmtezCt2HbpIKk3scHjJxqpvR+PlLlVC+tr+cD06zE3MXhwI18IgqgMSiOPvnIE0BXPH/ewmeaAEpDDNzONZSV4KwA7uKT2qzERAVwNx/FAlhcw8B9fNYKoMYzCP1WPkwFIC5J9UN8WgqgOMbAMT4OBVAdZ+BJfkEAWusYeIr1uAEss185/XYT6TLlB+w7VP+cmnc7gjTZ+aJ+j5p3u474dsQ0NmC/pezIlF2aYjXH/k1vpBsrAd1EN1XEventdLvs/9yF/Ze76e5KQPfRfRV6K721Qg/RQ5z1GB2r0JP0ZIWeoqewsH87vb1CP4ctlwp2Xt4jm0iBnu1zE5pFK8pTVj5OflcJPX9anDZkcXB+A82KkTlm3mfshelcAI+SIzgiGfHXYA7CGthjJ72xcPbO7Wce031vyF3AZpD4wYsXEfDmOXYSytLwhToU6Van+vWqUzQEd5fWxeFzvd/JUsIoXUN0GoKDMsdydSeo8a7HkLNAQ3iAIX/MUrke2z/kwrZLpgN4HAzL3oQMj54nw5SnZaDwNpk+2ttoukdvkmeDNBR5kGNPejkXnyEcAg77qRv1yHWU8tPXwwubSMbe+uS5uPPKEbOkhCW+ShJyuqYMQ/INGNoOFiRu7LRu2E/fyq7thmUaLl3kmLGbHwm9IdKYdaXlFPSQlV52YSofp4Mk7OklPRp5VHQiaiiiRmJ/ixE1Sl6Uw4tyeFEOL8rhRTl0lENHOXSUQ0c5dJRjU5RjU5RjU5RjU5RjU5RjY5RjY5RjY5RjY5RjY5RjMsoxGeWYjHJMRjkmw3drrAGt9spfRP7GDeRKjF7ArUlsD8x58+xA/agoN9SPwsyZ28BRrPt5w2Ce5pZodolXByvsCsyH+wJYp5q4IguyXl3tJhzl5FbOp6acTx4dWJBBRrOTgznR5jBa1lC2EM0Lo+SmTOSPsjIKcspE9QiUUa6Dp3zbwIsEO2JjU4Idt7EZwU7Z2Jxgz9rYgnHGoGzwgDwCn7wPsTuZIfavx970UpSQr1Wz53o9C7t2HnTEAhom96vCZB7JRpTMILkYJRP9tnsvWged8zRL8w9NygIsci9qOiCJjERuftd5r9a8uVVuLvaKuw97JHg3thNH7xbYS606oZ2NCWlOXpYSWvm9iwp6CCf2d9EQtA3uxk/Cu8/UBbRoSVEcbCW/B0mZBJiKYJfVUgnsCFkqwNuFsXaV8fMd1qlmR8biQzjlL280Dr/Zj7X4Emb/2SBvEkfYIG+HX4BkQcbRCwv5m+ATYKBgUP6bvxm+EhT69ile889iUJw7OyjSLoyJ+/oNVOdO035We0sGohSrZ+G3ehZnHlBqFbjF8D7AN7Li20AgCrOA9wO+nTegBG4wfD3gm1jfTeA6wzfS7DlWoKJJF+ibzuhZ2lURNZZZ2lcRJZVZ2l8RFZRZur4i+iUoBA3jFnFqftOZwPv/uHsXGLmy9DzsPupdXdXVT3az2eQ5l5zd5nJmtyXZZFcPye47Gg45O6vJeAXv0lknyxGZiK4hYM7sysvdnV3WSjJSEgynAgtwzVjy3r4tAWUkSApxApQDByoEgVFW5Lg2MpBy4iClHT8atgOUA8MoJLY28/3/f+89t5vNHTlxEIQE+p7znXP/Ove8z3/+x5upXgK7DZiWY6c+6s1Y/+C3vo8fqkRmrh3ILnsVlYK6JyB1jYX5QtqzSXSK6DSOzhCdxdGmE9KGTaItRFtxtI1o24GViFN+rI8cfeQYnCzh8CQ0OgmNTyE9AekJSB+dfGl6EpqdhJrus0m33JAU9xyy2n7spc5JKDgJdU8h3QPpHkj3T740OAkNT0KjU0iPQXoM0pOTLx2dhKYnodlxyPUH5Ya6ZlzC7DDcL4s1c9fvJcFuEgySYCcJtkFNfUlotyj2ZYk1KfYVic1KvHmLOGmwN4JJp+KPNxsyP9g8P2BOvnbIs2zzAqufxkBXEVCLgRGLVa3FwMwjQAkg4lyR8bMFsQLUnoOT5lOY8WK1hKw2ffg2+Up1yUlqZF5qhai45CQ1NmllhKemCaz/2YKoa5AlUdeIaTaCLRV4jp+cb6hrtT1kBMTnwiafymmtIL463zLk5JYhJ7cMcVFFV8W+hO9t2tEPwPKR8RMOuwirfxifZpPJyIETB1iG967RjEaqHJjgckl3WjuBqGOIzXt2m64SGihvB37acledX8PThnHdq06bwledP8dYB1gyC3UxZUHRye/ZJ3p0/yQ0OAkNT0Kjk9D4JDQ5CR2dhKbHIdtvwUDylmPhwiCviltOxiugH+fhZwj8/LyK4lBWuWvE74Xg7SfxhyFYBUn8cQg+fxJ/EoLbn8SbqK+mbSAtIC0TaQNpm0gHSMdEAiCBiUQtkSA9ID0T6QPpm8gAyMBEhkCGJjICMjKRMZCxiUyATEwkWuoSJFrtEiRa8Iz6kTXPqB9Z9k5psGgZNCoLSMdEAiCBiXSBdE2kB6RnItHyaVQWkIGJDIEMTWQEZGQiYyBjE4lWT6OygByZyBTI1ERmQGYm0sSi03TNypLF0+hMQNom0gHSMZEASGAiXSBdE4nWTqN+gPRNZABkYCJDIEP3eOMVo8pC8ggvREi0jibIBMjERI6AHJnIFMjURGZAZibSzKCyMgbSAtIykTaQtol0gHRMJAASmEgXSNdEekB6JtIH0jeRAZCBiQyBDE1kBGRkImMgYxOZAJmYyBGQIxOZApmayAzIzESaWdRP1qwfIC0TaQNpm0gHSCeLfZhNByBLv4t9ms3y6/omVm+wPvj44pA49jyfWxwsft4yn1wcf2aJ76A3MGtbDW+NTy+Of2SJI6E3Metb7MuHDjOwZ/YCIl/CqmE1vEuIfBmritXwNugERr4bvYsIf/XjRWmHFeP0/Y/XrO0GzSP6gXIS+RnmBB94O3zC9d4LeanbYnH6gpLTufc1JDxgOfQ8o23bewD0PqMXGe3Y3n2gX2V0g9HA9r4a0qaL0EuMdm3vKyFtzAh9gdGe7X05pM0boR6jfdv7EtAvMqoZHdjeF4G+yegao0PbexPoFxhdYXRke18A+gajy4yObe+NkI5LAZvW2GFHdt7rIR2n2GcHo0e2dzuk41bAt+077NrOe42uLBmtMDqzvZtA3xXZfXVT1Y3D+7WQXWny2e0xhW6H7HKTz273KPRGyN458THssRMfy148URlgT9iy092hEHa52xTCDneLQl+lk6JNjcUONNGYLLt+TX0tZOH4a+q9MNKC1ZfJdbaeE9MpRd/S22AH/AvrHS9D9lPIT8mLxNmNmLPX9S7Mrbj76rraDfWub+v1mDlbVetgzp4Fc/ZCYgtDVVVRXUj4r1VVUGdTiWeTxN0g0LtqHczZdWF2Zdj6X8FwTrJLDuYFVy8aYOzpgRiXhZijunvCN4mzH1HIgC1be4Mc6vqd8wKoXO0u4psNNRftijNw5qnPcjZ9wbd01d1XVd/5ul5XF1SVpVsKpHqxi3WjY+vreLZtfQPPlq338Wza+haeT/QjPB5Dx70A1YufxeOe/nk87upv4PGWfoLHHf1NPPb1t/DY0d/GY1u/j8eW/g4eSn8XjzX9FA/Say+AffOr9LT0n7fFA81ZVVTrXGs5drHDcweJh+IVlgUFEdVkaE09padS36UbBPwqpE5RCPU+Z96BQCrKqL5Fzzvqm3wXga9QTwi7q77Bme9B0hXfDLFX1AEJuHLmJ+pRyNWkboVcb4rcaFJVQnSX6hbCvVTZEKaNTGiZShiqikhVInAhfV5fx7N3Sd8g99Ln9T6e3Uv6FrmePq8f4RlcQotkrrizTf2z5G/6kv55PKeb+htE6JJ+gufRpv4mEbqkv4XnZFN/mwhd0u/jOd7U3yE6F/V38Rxt6qdE5yKZxr/iDjfRPKB0EVYHMlfcwSasDoDWRVgdyFxx+5uwOgBqF2F1AOXf1DeJ3EX9GpV/U98mahf161T+Tf0G0bqov6Ay7PWZTArv0sdsEtWLB5i6EOHT2a56Q32BsECwmtpVt9XrhHUFW1O7cNlFWE8wpXYhT/zrNqF9QbfULmyef8joQNBttQuL53+e0aGgO2pXPVVNBkcC7qtd9R31XcLGgt1Ru+rb6n3CJoK9pXbVN9W3CDsS7K7aVd9QTwibCnZP7cJnDGEzwR6qXfVIfY9/uHmewcdqV+2rW4S1BHuidtV1dYOw9nmV8WdnyBNalmcGVVdzNIOh8ddBaz0CCwS2ALZisEZgG2A7BtcI7ADsxKAisHsWbRD/0BaBPYC9GNwmsA+wH4M7BA4ADmJwn8DRBip7IwLvEDgGOI7BtwicAJzE4F0CjwAexeA9AmfnULnnIvAhV8gmKmQzAh9zhQBsxeATrhCA7U3fonVlHRdPVZmnG95ZXLF6BVVXOVXl9aIQscVlLl+XyYy2ZkVVl3aS3MUo91nczVJ6jmbthnfhWI4C7fQSChdOUJitJRTAbTxJofNjKARnG95ZoQCGmZTybEIB+9Czx78iTl/H7BYvkzzK0QRwcTB7NxqamA7gCiH4WjSqMFF8HYPv69G4wIz0CxgpvxBNBmg1eE1ovhcNZnRC0Ol+LRqJ6EKgM/p6NJbw66Az+4VoAkFDg07rvWj4o9+CTu9r0ehFrwOd8dej4Ydf/zP49T8TTTroG6DTfi+aMNDVQaf/tWjEo6OCzuTr0ZDFr4NO688ki33/Ii/26GMq448XwSNrMo8sw9Mjqe5neOqtu60VDo83625vlcOzzbo7PsPhYJP0+jM8edfdtuSfbNbdvuRvnq+7E8nf3SSl/wxP/3W3I/mPNuvuQPK3ztfdI8nf2ySLABleP+puIPmnm3V3KPnb5+vu9Ay+riLfyJ9Ge5j+XIN3Msk+ZlgWLmHGHyXBcRKcJsFZEmzOxcFOEgySYDcOkqRL+eOn6Z22zPjRMXwieHsujbeOxXtz8clG00o2ned1+2ie1+1xVdbtUZXX7WGV1+1Bldft0SKv28NFXrcHi7xu9xd53e4u8LodLPC63Vngdbu9wOt2sybr9mxe/6ptTlH9cqOh6qrKm8OGd5b1enZppFbBryxILpoTzrIeRTwbVHGuK0Y5LnCOsRuqC8kMh3asIvHCFW6CTZkTvF31jfBAkAIh19XPxwhL0NxQPxseqCqdOaucQvg+Nl4HyS8UUFLaDe6qR+GBuq5uhQfqBraEB2of+0Ejc9HI/JQyf5cyf4fyvm9mrRpZv01Zv0VZv0lZn8RZy5S1yjXQzIaqemy+y2BzzxnXI8txvL/P+P0SWM+U6GHxo3XNu06rjncrpBXN26WVybsRHhCAfQoWIG+fone9XXwxhbFZuRGq62r/YyCQK2zkYQpEtyZ0HzPdQkz3DtNdE7pPDLpvpel+yFfhyMQkiPC2EK4x4a2Y8EMmvCOE1wzCj48XuMZ015jCda4AprvNdO/EdAtM967Q3THo1k4UeI0Jb/EbRPieEN73pEIjwjtKqpwJ3zEIq+MF3me6d5gC0bWE7j1PKjSie1dJlTPdhwbd/RMFvsOEHzIJIqyEsOVJhUaEnyipciZcMAjfO17gt5hugSlc5wpgusqTCo3orimpcqa7ZdC1ThT4LhNW3GbXuUJuxX2UutwNo6NSDe3HLXDLqPw0YcWE95nEda6QW3EnpS53w+ipVEP7cRPcMmo/VRNbTPceU7jOFXIr7qPU5W4YHZVqaD9ugVtG5acLvM2ELSZxnWvgVtxJqX5uGD2VamA/boJbRu2nCrzDdLf5hevch27FfZS+94bRUam+9uNZ5JYxgRh0vesfgrvjcPXxuJBeJN30RlSlUV+9wVX2SCaSG2o3nkNufHzyVbcwE1ORHzLdxzIupBdJL70RVWnUVW9wjT2SeSSh+zBN90PvFphUDldg0nMxN8hA4Dp6FPfWfa6Fjw/t/Bv7KplG9nF+36V1BfWxC1YYXQFiFbohByXKiR3qx78R8A870m7cJcODwLt+yHMu7UkRKXCkRhFMbjcopBheo8gaR7YossWRbYqgI+1TaJ/hHYrscOQORe5w5C2KvMWRuxS5y5F7FLnHhtduKAcHw0P+xFsUehwX66HK+O2ioaqAw87l6JwYmSUVkM+JkWFSAfmcGJkmFZDPiZFR0fqH+isUrwgroVsRVkJQEVZCpyKshHZFWAmtirASmhVmJczmmJUwnWNWwtEcsxImc8xKGM+BlQCDpvqrtIOa0/dpBzWnH9AOak6/S9fr23y9XiCvk8Q3f08VyK3kBWZ7F8h75IvM9i6Qa0myELWLQ9cmrdsW2DTkLqxA7kwvk3/JDBm2+Rr9mq2/RJ9q6y/Tt9u6TqUBoy2jCn73fMP7LOkATfMEjC40vM8R0C4QMFMN748Q0GMg8BreTxEwYmB4seH9UabBQO98w7tKwIyJji80vCwBHc7R1A2vRECfga7HVwR1d8zA6CJfE9TdGQP983xVUIfDUACTC3xdUIfXTwAtzVcGdXcg5fD42qDuThgYX+Srg7rbLBIwOM/XB3W4HAVwdIFvNOrwGwqgrflOoe4OpRxegy4WyFwwleMi3y7U3VYRrI8AxpN2oQr0y8yEKgvzrMyb8KDMm/BOWTbh7TJvwltl3oQ3y7wJn5V4Ez4t8Sb8qCTMsxJvwscl3oSPSrwJH5Z4Ez4o8Sa8X9Lk2gEOws/62a9769xZsGv8Ds4u+YZab3jrtKxAk36d9lRhoH4WwZoHeep9BLGVICnDqvqu2g3VtxRy/TwJXN9SN9jeT1U9Rdq3Ke0blPaI0+BNswnuo3qfEp9Q4vdsTsURH+d38R7C5aKC+kF0DkMXj5jO03yj9ifUZfUVxmv/tsooowsbndfotkaHNbqq0UmN7ml0TKNLGp3R6IZGBzS6ntHpjO5mdDSjixmdy+hWcYeKvp0PrPLt0fHut+Mq+KL6cqD31ZvqS4G+dbzNC9TkXz3Z5LeTJv9LdtLmv2ofa/T7aLvXqe1+3abG+/N20uwPkPoGpd6kxA/spN3fReIXKPE1SvzwtGaHXOVnqbT6c8J0mOYbXpWuBx7heNO2MWKqdD/ws3g2bf3zeD7R38DjsX6Cx0P9TTzu6W/hcVd/G4+34AUW1wPfwWNffxePHf0Uj20cVqu4H3gTD6W/iMea/hIeNf1lPAr6Gp2w9I67rz6r1kkSqqp+Xn1OrZOhprMk5B+qn8V5DHsY6uFnaYsHExlnpUZJMreqvgXR/2+CI6+egEH/DcVpPMbqofoOpWHAqG9LGir7i0h7k9KaxNl/Komo7B3SJ6DELyPtS5IWnwm5rgsknVvlhSE5Nxb8aQT3UvAsgvspuHlJ4EEKbkXwMAW3I3iUgjsRPE7BQQRPUnA3go9ScC+Cpym4H8GzFDyI4KZjwsMIbqXgUQS3U/A4gjspeBLBQQo+iuBuCp5GcC8FzyK4n4KbL0T1nYJbETxMwe0IHqXgTgSPU3AQwZMU3I3gIwN+Ue3zbhPaN5a6oG7hMad+yebb4PfIpawlU9dl3tvVXlQvqheF9dq1D+L9qsX97YBJXRCgz8Acb6Kpjx0w9aIAQwa20bG3U65Tia+XeE5F0xXZdSqaq8hqOGiiIjtPRYGK7D0VRSmy+1QUosj+U/HzRXagih8usgdVVG2RXaiiOovsQxVVWGQnqqi2IntRRdcsshtVdMci+1FFFyyxI1V0uxJ7UkV5S+JJlXa/4kmVNr3iSZX2uuJJlba4JBiWYwa4XLZgTm3/C3KsarOtZVFcW8IVrvOStQwFBNLIc0UjTzTqpvI8kudEnmM8hc94tHcNPYul/3Erbov2W44uxe1IY8lOaSzZ2nm2xtI8aywt41J8TdSLrpAcgi3OHOg0MG8qMFHi8nM1lqD+TtpTyjY0lhg1NZZiHSVyIcsCqSu3Kw7ufUk3KrJyT/ECmxMMSK6OkBpZsXQCEugiZI1MCmYCkiQiRJEGXxYXCllGtkjfDz7cZzlGtskwIX6qW4ByIS6iIW3wjy32VEclL5Fr4Nobmf1INWz+mGrYjnJI+qCudkK949t6Oa5oWy2jole4ohPpA5u0i+K6hCOhlVTiSpK4EwR6Ry2jopdjfxzNnxLhA9EN22F/HASL/hVjp8ke7BBvMlEWI6r9M2SFdgPXDr6tL7rQryn6q4/AT7alKog/u5M2u0WvKruRyPjsHPK999IbFYuFNtgUoc5L5qLfsx81tCYltYvaUUWShObf4F5RoCy00psaf4YOKHRJVPF1/IS2oY70rqlKEhErJHVN+8bwQO+ovLbLZGjA3Vc7yc+uPJJmovNQ9GFCgI5E4QF2p1028EqkxIaBw9ov/Er0m9gloCpYWUrPq4K2U9VeVheRcDElB6JK/qQC7byS38k39Au+pVeocqa1hjSzq1b4TGvTYXS59iYclMyTB86LICSqzCVyrL3M79Z+Rtyw5MhPyjy6/ry4YSGoB6gnUDNPbnsA9QVqETQANBCoTdAQ0FCgDkEjQCOBAoLGgMYCdQmaAJoI1CPoCNCRQH2CpoCmAg0ImgGaCTQkqAkXGM0aQyOCWoBaAo0JagNqCzQhqAOoI9ARQQGgQKApQV1AXYFmBPUA9QRqFqjAgPoCtQgaABoI1CZoCGgoUIegEaCRQAFBY0BjgboETQBNBOoRdAToqAa3NjncZ9jE5bgoWu8lf5JjuyXgY+RjdJzDnGQTE0TH6CiH5cEmBsilCIXq2LmGt0HxYU6V1DLxPsgFU4HObSIJV8LsvJb4Lylhbo79mVBpVXI/Tt9gUXVgXibK1E9ZOR9KXzlyxXqmQYsbnMJDRJ6dwl9UduQUPo9gS/zD25FT+EsIRk7h7cgp/LJ6IdL9LyovGiYrGH0rqZ2NfcwpvBs7hXdjp/Bu7BTejZ3Cu7FTeDd2Cu/GTuHd2Cm8GzuFd2On8G7sFN6NncK7sVN4N3YK78ZO4d3YKbxrOIV3DafwruEU3jWcwruJU/hS5BQ+x9qaWXOJE83fcqLTd4r+xelWnsqmMRlRBUx0zHSymkQGWPbYEb3vvLahb8ZWoHK+9YUKCmm/q6FhZ7+WeepbWZWD0Ro4s0gs07Ctnlxs3WkRbNVFwwpNjuzTOKfap8nBPk0umtvnZYMD+zQ5VWTrTrnIwsCEjVin7dK4ouyatvL0mhiouf2vYaDmNXVT3Q4P/jCWaWDroPc2FiF17SAow6QFqcJcslRdX3P21QJVM2TR2NoTvuyaWlXnuPGuuN23A28Hhe78IEtrvYWNRecHWbWE7ZG15QS/k/UwKv+52eq1urL87u9kG5TNH1lsV8OfMTS2Gn5AgxAyj9c+iDcU06cPVBK+/x7LROTUArRarURTKw69DbnXwrMS3kVK7dSUtVNT1KkpW6embJ+asnNqyv6pKXdOTXnr1JS7p6bcOzXl4akpj09NeXJqiqGsfDypdXpS+/SkzulJwbOT6EABJt2+zpWxjI0t6A/T+kUzA80d2OnnnH3loD+f0q9+jpMKpyfVTk9aOz1JnZYE30Nu+sP0Dk/YBlLn6dxAbvLUYiCv8VJgILdpmTCA12kFMYA3aHExgC/QumMAb9KSZABfpNXKAL5EC5kBfJnWOAP4Cs2FBvBVWhkN4D4tmgbwgNZTA3iXlloDeI9WYQP4Gi3QBvBLZDfMaGX9y7Zvxyr0tEA46aon0yDsPsgAMbOzKyEDvBlACSPdBuq1AMoY6WZQtwNNutxGS6jXA02K3EZjqDcCTVrcRnuoLwSadLWNJlFvQqvaSbWK+mKgSdXbaBiwqb9Ed4kG9uVAk7cuo3nUVwIoc6RaSH01gFJHqpHU/QDKHal2Ug8CKHmkmkq9G0BXJdVa6r1Av0eXpQb2tUB/jW5TDeyXbLracVLtpn7Zpose0SRnBusv28Zi8Eu2OVF8zYy8Z0beNSMPzMh9M/JVM/IVM/JlM/IlM/JFM/KmGfmCGXnDjLxuRm6bkdfMyE0zUjcjO0aEZjVsnU906mN971g3Odai6aqHKLtRz6SZms7cPBa/m45up6OF00i/y6540rlbx+L30tGddLT2XNr9Y7Tax+IP09H9dHTtubQHx2h1jsUfp6N30lF1Km1ezfoF7EWLvBdFK8f7NI88x3RhyPMMvDoG2Ph138Zi+PsW7CxazvvYq/3mD7IeLHpiE/pRVu8oMgppqXodcVXnFccqezAIek3tPNjgBAtvdD/KekCvqZ37nrOB5wGyHShnoxbaicl3mESsI7uz7zwlIy3WS9a//GG26li2W1aW3/oo26Af9tsfZRtl4gqW1YLfQWEdZ1+d2XIslHf6Q4xxdeYla432nv7T5JuhDU6K2jglXHX++Q9RzCV2bzxDmf3m38dmM3JsbPktibck3pZ4W+IdiXckHkg8kHhX4l2J9yTek3hf4n2JDyQ+kPhQ4kOJjyQ+kvhY4mOJTyQ+kfiRxI/yHvFRrdh2wbn9w7rb/yibmMWxfevzmX214H/4+7QFWvA/QKCW1J//6wBysoXXZ3xLL1B9eud85x2sjmgIdUYt+M7XG/5IDMA60uNWcXJQ59A8q9QUuS3Hul2x6NcrVce28mW1+pL1wduq9pJl3a7YczkCPnxbFV+yrNcqWTS53fAWlH0HXdr2c5+vUHe06UT5mz/I4jPerLhmGW10HNu33/EWcOzLgca7ukI+keQ0coYKq1d9Wy/4lj7n7vMPOWpB2eqMWuVPig8rNHIA2yfg+xsev+F88je0DfoNvaDO4fR4TrEPvAp6MBeAC+j9ocoBfiVawzZbw3gP4/bBrYoNW6QIe9fUGRU1Fk0Ongxpr44D4UEthPYdPWnE6jqNbN5C/77VwKRgETUKqQWUQGp4wSiGh8GqV6mj/FPEF7Yc66qDb13Fw+JrCX/wUdR7zU5rldUSrp7pwiTuvTJfuJbt0IRh7yKuLLoo+WFWbcKs0ByV5gdZcAVcOflbL1n/6odZfQZJsx9m9YLaVFSYTbXpw39yhsojxmwvNBSKeUZt1naQY8uZo+sI0LaFOrrmHBXCOVYImhTbmGmuuK2Psg92rT94VtGcf7NFc+A7/AzX2Y9+mK1Y0Ty/QDMmT/TX1AKsAb8fLylZHjarDg2N18i64gJGFg0qh+YCm4eR4uHznndOLaglZSv1jG4LZV6l1NKJhAcbHr9z7uQ7N099Ry/hOkVdo86pbkpA16OBBevBnhux3Fcz70vRuMjeH7KEqV/Lqnr51b/1u/j3T/dCsEysK26TFkuL3Jqh1DbTSQ9DT5ZgGll1YpawpavsO2RT+1/ZbxD/ZCkeDuB+Rnu62V68ifvU4MHGfX0Gfc6VPqfO7KL3PGcERLZk/lC9i8pl3X5WJ2PKyv58Jum6YAT6llZIPPph1rcwX6Ov+JZeMoysX7T8ifWOd+4SrBNans0dUsHEn01WRT/Koq+dwzcodY5NN55ju6rn2K6qzTP+qlK+9QXPvYX7N+noS7z1WX1WG6AF9I5a0rjXWaXFDlwqXi645T3nlBl05z4KaOkzmPTkPefrDeXQLObbn9eOWtCWcqjTUYYzlGEJGZZQc0tK0Vx/bssp6IUy9cg+5j0sCVGre8QI6H+UTW61NhR/0cIzepVDfci9zbJLvY+ytPl+G/b0UH/BD7JgkDJ3YUD7wOZH2SC5ottPDgf7Dzb0Dq46McVfaOgl34or6lk/vUr1Eh00FG7KViO+LDTOqVtsHFC9LUWLjVqtXcFgpP7jrRrtgpGzSgsxFRvq67L+4LaaOolWZaVQ2Q2P9i9JM2CRWYi7BV1fwqwnTunMFq7Lmd133+XNDD4Od23veDnf/bfINub775LNcXz7KvosfXv0tUop7gcHtHdGgv3e6WnOc9LcU9IsP9PQ6CsZ9BWXp68zdLdsR+XwR7DasKpWMTvsHPDWz8Zrsls6w6/JZ5MXhCUYQkyZ0UMzJ14QnGMJvqVXzd/0FvxB04blJ9/+mQzaeYGKccW1qHl2ypQ3ro4fn93CRG2pVUzUqzJRR2M3+VkroYO5cQeb4jSdnZjR/YB5wRb6wD//YdZb8K07dNKdfZRtUJc+KomVP7A20dsgl/YasTM1blos3GNjSthqNLjzGffK70MZmYqGcToiy7ofBIfJIC2Dq4Me3PBW/dYG386v+j36UbTWLBt6MHcXhlGbeZbcKNl0VqD7hFYZ9WL7R2sNfYbKomsXLX+/AVPG2B/67UwDU+ZR7jbtxayrTidHT+sv4RioFq46Rznw0gtis9DypwUxVWj5RwUxVWj5k4LYJ7T8MQffRAVz8IvJZT3b1YBx3oPv669gmSvor+IxhJlF9nt6n6cKhw8FFknhLUD2LubW771N7VMxeBE/V7HVgikvQJkSBv9v/xzWD1tXsDY1XrI6dKp1uKHI+jFmObWADgdjda7Jx4udy+0/3f9NPhAtkKlAzoWmkJzePkwm1lGUoXsAFxzJ7QlMWtbVzQcbZHv0EJcdC5DX4k0yzr9WWXqFt0B7DhRnieVIXSq3quxanZyqqQXpfmQKdaERs5Kme3TZBmEVNulcPzwwRCiMCnuwEWKLbKn69w/jHIVkBi/s399I8EGCDx5sUN+LazaAJRAXxic9aoEHaocFQRfUl2Bo+StR/JqqH8KMMzEdzU6LdeKi5dfe8SxINYmdlajqLpFJb1gtyamvkk1nMvNMBp8DMf4MY9ABmYYmI9FBEHw/fPVf/pV/9j/8zM/d2zs0OkXSI/bub3g3Az6pwMxoHfTr6tph/MPTPVU3cvP4hpMPON/gzoYWLOBPLQjwWMMfRcEt/NmGqyN9m+5t2CztFk8aT/TrNCvS3acf5GDPjQzwvaZehx3L24G6GcblXkvaZc1sl7WkXdY+bpfw1Q8/oH97YS20xcYgsVwg4YSBXCAxkfsbXHhmsGwYglKwaq4WohtZS4R3LL/WiBpmnIv5iWv7RvD0Uh0vVNysKgnS22w+5pfRRlEQo2IMIx3777Ccm+3/x6UGJihMbF0KOtgFQa/zkuXbWNU3ubiq/L/5ztzT6vuYqlrr+J5X/9nDj1r/5ezv33yQobOfP/q9rGzUkhUu7+yLnx/0y3hhyyKGqT056vrTX+Ql5Q/sd33nNfJfY/vNX0qWlUqZ8ser2Sd7Rfz94GLYy6ksL8J5vhKNftxJU7pNfkyc45QqSVeumB0/MV5r2LF9sKGraOzpKZU16JfjyjI3AJXYRVJSdUZquhaPJYiNb7NSJ/8od7KGpv8o95xK/SSvfLJKTVGKKvUYpVMrVVVVRVWlGrFsnqjI96kie7+x8P9GRY5+d+5krUx+d+45FflJXvlkFZmiFFXkMUo/tiKzqhqfkH87NNybgtnwvXWZWf7m3qF3CqnQq2BL8g+yvIeyrriz5nrgVet4gm/7vXUw65Bp+DtlzkRCRN68MHKRIUcZ+v/ZgtjXpwwVljuax4ehrZvr4I1X1TzPrjVVUbUHG17twJvnAg3eG6gk+GBDfkJVVe3AqyZ5qmYeKSlKUDuIvhK5KmauClOCqX8ugpfd4K9DuVSWtpCqcn9D2e/47i/407+ffdTwJ1wt2BP5zV+hiiAlxWpSl5DG+N76h7XQPojr9U/sG8H7G6pKRmGwIcviNL7KBrW5qqn6UYdEVyocYVRbBXXl4VnFE8czXUOFUmgeVkdXsQ+qMkI551XNNBntVVhD0u+tNrwM3hWNyRqFuuCmHlUbni325v1JteHlowjc2pejyKja8OYkQv5Pqh8/DesL0yoM21Uht9rO137DBj+bqo2r0PHbqw2VEUE2x++sNuAwSczcV+pusArB+Mtud/Wa20K5ZhXQGllkesPxx3myVpuTaCuP0+j4e+uxSAuVqpnn5wxtTS9ddc5RcFZpXHVI9xPvXnWWKdhEsMYZcg1wWxAcVhtXnQJbQivBBRdNNzAvQ57qK7GBbJbDiZfJDC+TFuxUkyQyttOuHCaTpSc0KWT2VUlBgq1S+3fAzRn9XlZnyD0Y2jbzZsUmWWxdmbPKZJcMktgnixAtPnERgn+UbWhIU7vHypHM1s8tx6BffkY5Cqly1E6WI5q743K0f7f87HIkk91zy9H7jYVnlKMm5YhUJWBSPCe9vazKNJwP2VphPonQDi2KOP50Ra7rEmh2EmquHofIoHuVYhgFZO18haJHK+jMdAeb96oHqnJ42laijgFTTflPIUKziqoe1vGgaLNK0ab8TIujLYm2OdqWaIejHYkGHA0k2uVoV6I9jvYk2udoX6IDjg4QrYpeNY+m8WoS/jscHqw2rjojDhcaV53flSyAh6tMcJwnguM8RyccneQx2jA3idVUquiaysB0Ks6Oh2ylEJI8SuJrHFdRXHF8K4pvcXw7im9zfCeK73B8P4rvc/xOFL/D8bei+FscvxvF73L8XhS/x/GHUfwhxx9H8cccfxLFn3C8aUdA02akFSMtQdox0rajc1+EdAQJYiQQpBsjXUF6MdITpB8jfUEGMTIQZBgjQ1ulGmhkp1poJC+M4xfGgkxiZCLIUYwcCTKNkakgsxiZCdJ04spypLJipCVIO0bagnRipCNIECOBIN0Y6QrSi5GeIP0Y6QsyiJGBIMMYGQoyipGRIOMYGQsyiZGJIEcxciTINEamgsxiZCZI043rx5X6iZGWm268tptqvLa80Ilf6AgSxEggSDdGuoL0YqQnSD9G+oIMYmQgyDBGhoKMYmQkyDhGxoJMYmQiyFGMHAkyjZGpILMYmQnSzMSVlZHKipGWIO0YaQvSiZGOIEGMBIJ0Y6QrSC9GeoL0Y6QvyCBGBoIMY2SYOTbyMtx4GakseWFMZr6osgSZxMhEkKMYORJkGiNTQWYxMhOkmY2QZlYqK0ZagrRjpC1IJ0Y6ggQxEgjSjZGuIL0Y6QnSj5G+IIMYGQgyjJGhIKMYGQkyjpGxIJMYmQhyFCNHgkxjZCrILEZmgjRzcf3kpH5ipCVIO0bagnRipJPj5VZXeRXGvh6Ls67xmg1JECzlepFXeL3EC79e5v2AXuFtgl7l3YN3RpzwjPMNeISORZIsdUZV2IwWxQtqleMFJYvuCsfj9XaZ4/F6u8TxeL1d5Hi83i5wPF5vaxyP19t5jsfrbZXjd1QWe7usX7pNN0OzCgouDLYKa8fRt+bVmSDZGbXzajVIdkadvFoJkp1RkFfLQbIz6ubVUpDsjHp5tRgkO6N+Xi0Eyc5okFekTCTRYV6R4pVER3lVDWhnlJNDSnT+8IfzDTmosEQ9/fIqnR8HuUbtT3Ib91b1PDbK/yQLqAZ74jXSWrsCe4CWH4zKjdqfhNJnLcTZL+UDCIfEK27rV9a9+dBbUPOhqr5a+h8PH98o/cW90FukhhZLZFDf8Wy1gD04H8M8OJuKVH4sv2MczmaUF5r2tdBbClWaUpdSl/Bz8fuOP1hg+pUUOlzgvGm0RxTmqc29aipptMCMgcrxX21KglFqcFdaqw3S3Cs0dAGVsa+rFy1/kH/Hc6E346HTN8AhcvZh3uItYwf+W9/3ouNxbRCS8QtvPpHu+/dxhKklnjLVfKCq/x7AAg2l2l+yQVvlpX1JTgaVFp9ewge4gJ2nD62qeTAoku2/sdvf8M4ceMn+f4Tbj6qSo75eAxdr/kNvSdUOvYVYD+WYEkpVzR8gw+IpGQ685dSpalEtJg4XwWvWS6ry6ks/fe6f/PDq2b3QW1EVtYD/6Vyv/rGrf+enbrX+7l7orYZqyYguqEWoYB4afKdVtQDEW1ALcHS/qBbVCj4IVzKoTq9GFVM7vWJItAFdTVUPInaQZVn3vcyGV4sbhyqsRhVWA32DlspsQGDDpZbKRoPThbHUqOF00TyK3SKF3DPY6Bf4tWc3NatUHXrrrHqWxZGgcuhVWf8sixNB5dATJbQsDgSVQ2+BNdGyOA9UDr1FVkfL4jhQOfSWWSctS6eByqG3xJppWToLVA69FdZPy9JJoHLorbKWWpbOAZVD7yzrqp1R8wfevFoPSQ8gYLW1eVWl+N2AlddoOoEmQcAqbPNoEagaBKzINq8WKf44YHW2ebVM8ScBK7XNq6WQ1RkCUW2bVyuhaFOJgtu8Wg1ZLSIQNbd5dTZk1YmAjixrqnIA/mWoweGqhRq9fiHUaMvFUC/A2XioF1VFLYV6Gf41Q3RTtRpq9M+zoV5VFbUe6nXf0nlSMONmooWOhr6XUevKVXlZQrwKmcPi2SZLbhSIEZZCJ4RWj6FHhNaOoVNCF46hM0IXj6GQH8jQQmqiLUKXjqFtQleOobASnKWlmqYr9sCA9TLvl1hFUq3R0e/ULlyM9LvgVCpPuoU0e55YtyJNMC9LP5XMmuJ9rBZdwh1PmZ2agrn92SndxdNSmkunpYxPTektn5bSWjktZfLsFFo3sJWqnqIf5PhN8g98anLr+cnt5yd3np8cPD+5+/zk3vOT+89PHjwvOZvWOKoAMDWOqgBMjaN5AKbGUQ2AqXG0AMDUOFoEYGocLQEwNY6WAZgaRyvpvhySLDJYkVkaKOzXzZT+rwS6gl5hahtUA10FZmo3zAd6HpipTVELNJnEMJU3FgK9QH7fDGwx0IvkHM7AlgK9RB7kDGw50MtkhMPAVgK9ku61oVoN9KpwSGVWWDU0RFZM1YhlM7JkRhbNyIIZqZmReTNSNSOVY5ov2ErPa+KG9udl7zvP55vuPJ9vgnk+33Tm+XzTnufzTWuezzfNeT7fzKokaIabpCvu+HvrWAlnVbpYmsiNyUrdbc4TciTIct1tMTIVZKnuthmZCbJYdzuMNH+RkYW6GzDSEqRGthmAtAWZJ9MMQDqCVMkyA5BAkAoZZoDyQ/cX12MdW0S/t97ARceweo11DyjuT6sNuQ6x/CFDRwY0YGhiQH2GxgbUY2hkQCiPqsiOH+GqqFwgHN3iIVzjMOpBLXAYtaQWOYw6VEui/oDwsqhGILwiahMIr4qKBuhko5OQ5Q9bKBo45aJyIfFp9K7EZxKfSLwp9CCiANsB8llTiRY4OpNojaO4d0J0TW61VuFU8X/N2J95n7mAusScR11m1icc3ZChtQqLqlXpxKHnWTClxoxCCD2COakXmTuql5gjq5dZzG2FjtV6lU6/+gzzEvUa8y/1OjNO9Vlm2uoNloY7R2dvvUlHZH2e2Y36ArM4tWK2qtbM19Uey8ZcpAO6vkTnaP0CcyT1p5gLqj/NnFe9xaxffZnZzfozdIzXV4i7rV9U7GHYc+k0z6pgXoZY3SF5mq15WWZLc3TNyzHnmKPKyzM/l6NbMHdBHukouu0VmSvKnqTI0kCoMurFMFBZ9ZkwUDl1OQxUXm3B4Yv6dBioovpUSGbikPsScr9AuS9Sbo9ya8qtKPcFttOH3JvIfZ5yn6PcG5T7LOVep9xrbLcPuVeR+wzlXqHcy5R7iXIvUu4FNuSH3PPIXaPcVcpdodxzlLtMuUt0w1v+T+Zs56liRWa+cbbFPgWrKfPv22KfgpWQ+XttsU9BIbJPQSGyT2H5++8o299/x6RKViooRFYqKERWKihEViooRFYqKERWKihEVios7hS0lbe4mWkTb/FAoO27xf2bNu4Wd1vaalrcG+l+weJORjcLLE1t052CCEHTbYLF44XuESweBnRpYHHvpusCizstXRRY3LHoisDigUqXAxaPP7oW4PI7dCHA5XfoKoDL79AlAJffIfY/l98hxj+X3yGWP5ffIWY/l98hNj+X3yEGP5ffIdY+l98hpj6X3yF2PpffIUY+l98hFj6X3yHmPZffIbY9l98lhj2X3yVWPZffJb48l98ljjyX3yVePJffJS48l98l/juX3yXOO5ffJZ47l9+NxCTBbSc+O5ffJQ47l98l3jqX3yWuOpffJX46l98lTjqXPwMeOmu8jDIwbYMn5GKcW5WoX2WIq87flSF+On9Xhjjp/F0Z4qHzd2WIe87flSG+OX9Xhjjm/F0Z4pXzd2XAJafNAXQG4Ct3lGGVxlaGze3gmcgauLRK1DhUuMaj87Lby1yT37rsdjPXpAyX3SBzTcp22R1mroEjT+FB5pqU4bLbz1yjskE7apQpS8VmwI3nyulkuXI62XTlTDLEn+cKzxBnnis8Qzx5rvAMceO5wrPEh+eKzRIHnis2C957qhI6Wa6EiVTC5HglbF8jg9fuZXfrGtnBdi+76hrZynZp5Vx7dmXhIzvQb8SHDXP8YcNc+sOCLDH6uUWzxOLnFs0Sc59bNEtsfW7RLDH0uUWzxMrnnpolJj5XaJbY91xxWWLcc8VliWXPFZclZj1XXJbY9FxxOWLQc8XliDXPFZcjpjz3yByx47n8ubobSLibq7tdCfdydbcn4X6u7vYlPMjV3UFu3qj/IWJwrwz7RUG2Edn4pvob5srl/2rTWXpae/8iZMbJqR4crxRiXymDQsNzogj0jbNRpJdk6ibBoGD6VukUHNItHpS8ZTz7JW81YQ0+oEKOWEgfPOcxB1dUJpFtWj7kV4elUCwEL6uVUMz3LqvVkAwAW/4kIXMUkXHUMvZoFCUZ/Ky8bMXv9vBusywvWJDGZzIZencWvTss0At6lShopA2L8VsDDkIOvs/BNWyDOQgJti4HUe8BBzdIaquoz/H46JRiYkFJiBm1sEq1AFFaLo58/ZlQzB/zZ3XwMeO4WDCRqc9ILUyKp9TCmagWpvziJj6bg+elFo6KSS1YXG7vHMmO4Q5iRhJj8xjf0dd5G4mRLwucCErjSvDOmmltSeO68tbNtI6kcZV6a2ZaIGlc894ZM60radxA3oqRBmWcxKrdsjrPLboZ6mVY7BwX5OCQgVaEnC0UfepArlssiGV5jkp94Yig1IeNCUp9z4Sg1GccEZQq/ZSglVQFktSfdQVGrc26Y1g0PFI1JynTEymBpMxOpHQlpVk8ntKTlNaJlL6ktI+lYBEC2zJ71elnKNYuk5YXmdd2IPaWURnoo0DsDcF+hsTeEDwqkNgb8XJYpbYMPi6NkjLYkBbY2Fnjm8oNLw/0CUlZRd9TBmPNIqZ2zviYMkziWcTbLhhfUobLI4tY3MUEHpQbXol6vE226QQelhsee5e3Scor6gZw6EOWEWySB4u6QhkO0S0SgKkY3aHc4Hs007Cz5R+VYXHPIlGYeaNblBtejSZCW9USeFaGBphFwjALCdyca3iLrJ8KK2dxR5qDmplFEjFLic+mQsNz4+t9d8vBXb9HTHbengciHURcdt6lByIeRGx23qwHIh9EfHbeswciIER2jHjrHoiEkEu1RDv4QESEXKoh2sgHIiPkUu3YicFXggYiKhSIlJBLtUK7+4C29wSNREgoENEgl2qD9vqByAa5VBO05Q9EOMgl4SDa+QciHeSSdBAdAAIRD3JJPIjOAYHIB7kkH0THgUAEhFwSEKJTQSASQi5JCNHhIBARIZdEhOiMEIiMEGsH0VEhECEhl4SE6MQQiJSQS1JCdHAIREzIJTEhOj8EIifkkpwQHSMCERRySVCIThMBHSdiB2bTPWyuaIhGQ/W/zSRjdcBhBP96JhmstCGmgZos7jRiUyx8AiNRyDSWYoALxn640hgboE5jbDQyjbHsZRpjEc00VqHxmMaqNBjT2DyNxDRWo2GYxhZoDKaxRRqAaWyJRl8aoznw2Dgk6Sgeg2EyBuWgHCZDUI7LYTIC5dAcJgNQjs5hMv7kAB0mw0+O0WEy+uQwHSaDT47UYTL25GAdJkNPjtdhMvLkkB0mA0+O2mEy7uTAHSbDTo7dYTLq5PAdJoNOjuBhMubkIB4mQ06O42Ey4uRQHiYDTo7mYTLe5IAeJsNNjulhMtrksB4mg02O7GEy1uTgHvLJHWdj2j8eVdgvi6Y9ycClzd+0It7Sz9Bc79JGclah+wHaSuLYTPvIZlV8qdNOcuzqc5jgq+LOZpNmeVefx9pbZX8v+gLAIxf6+n4HUvUANcCpqz16o6IvYkWtykI2c3khOz68PKWD48NQqQvB8eF6Xm0Gx4f1ObURHB/+Z9V6cHyaWFNnjmFZtaJWj2Ew4HoxhU0qPJawxFYarE6X8TuFRu1LfAbRyzSHKYfz1f5ducTFlebOIy8LxZgBXRlKxiw3VJjsI1jABBmy5BMplxYkkYRaKmGcJKylEiZJgkolHCUJW6mE6QL2XZSwHSbbrtSNLNn96Fa9rL9Dqj6D9YZsIbETKXnLIlg+ZPyooCJkxMhUcgo6ZnSWRieMNosp9IjRVhqdMto2UYvErq463SovIT3abfWqLPlkcYPR3ypLP1k1+DSYFsBK/3DZzj5l3gfz44UV//9BTidpmzdJeQBmYj0H5/Em3ao7jdiQMC7EvUwDHnFMsPYscO1ZoGqAspOAOT/b8HL+37CkT/z/nvkh5c+R+Wguf67ujiQ8zpGmKpc/R8rEXP5c3T2S8DRXh0F0Ln+O3ANw+fN1KPZw+fN1SAJy+fN1iAFy+fN1yABy+fN1CABy+fN1SP9x+fN1iP5x+fN1yP1x+fN1CP1x+fN1SPxx+fN1iPtx+fOkvMDlz5PmApc/X4edci5/npwxcfnz5GGJy18gt0mW3yqg87UKUR+x/DYhbQPpENIxkICQwEC6hHQNpEdIz0D6hPQNZEDIIEHoewvMXKBjty0mCeT0RMjYQCaETAzkiJAjA5kSMjWQGSGz9O82i+Qeis62qJOiUSeEtA2kQ0jHQAJCAgPpEtI1kB4hPQPpE9I3kAEhAwMZEjI0kBEhIwMZEzI2kAkhEwM5IuTIQKaETA1kRsjMQJolmp5KCdIipGUgbULaBtIhpGMgASGBgXQJ6RpIj5CegfQJ6RvIgJCBgQwJGRrIiJCRgYwJGZdSLT4p1d1JibmEsYkQqRlCpgYyI2RmIM0y1UzZqBlCWgbSJqRdTv1up1x3O2XmVqBOjPxdQroG0iOkZyB9QvoGMiBkYCBDQoYGMiFkUk7u4ceEjBMES+aofM0dESsdbrJh8Q+seg6mGepH5TocYxM7AnVl/NaMkJmBNOeoruaMuiKkZSBtQtoG0iGkEyGp24Rgjrml4JGQgZfy/4O3CcGcLJDdubrbnaPqGFfi6uBgujp6c3W3N4fmoUL3jc8YEDIwkCEhQwMZETIykDEhYwOZEDIxkCNCjgxkSsjUQGaEzAykWaHGqBiNQUjLQNqEtA2kQ0jHQAJCAgPpEtI1kB4hPQPpE9I3kAEhAwMZEjI0kBEhowgx7zXGFbrX6NF39ubS9xrjSrn8d8861feLT9lgyQpUnVXmKmxFMbJ2iT7mfAN2UF+ymmXvDBn74ikCEnmv/nH69w/2QkP03SvW3SlxyDeT2ePU3FLz55Np5cdkbZ1P5psfk7V9PpmIfkzWzvlkhnpe1jhCg+zVt3/yj29/5q/8NJkDKhyyFEaNmbAfnxsPQpAKn1lf6WrKsh6HJXNe/OKza8+otCwrfFgyNSYvTp/zYit6cYvn0dSLs+e82I5e3ObpNvXiM+vZqN4s65pYMh8nL7ZOfTEbnTF45qa3yhB6DePFA7Fjr9ExFQYDveWGRzd1MMpmaQjnwh8X5GVyzE5qFtlpkc6rZZVT2QMvK3ymKIHOliofJ0yRQL42vTzeiMTcfzsMvSyu/HL8opczDCkVVFYV7m94WZX7kCMPNlT+QHLU9w8DJp9TxcBQasjCsCh+PitM6CAPweNMwher7/+mmAOFIT02ehMZS5xu0gVVkfRykpFbq7sDmFQYbjTk2EfTCMeUTLEc25LplWPbMrVybEemVcTic2A5vo0Tuzf/BY+MOBYcetkDcjmSoVbKSCst+YMN2DzLkgW3UOXYcVqN6zIMPLLmu+TPNhoqR+aDc9+PzTiF1Bwqf/BBEKrsoZdPdAzyKT1u/B5Et8XAGA7R55QLDb21D4LYDsk0Vebf/O1DWGzIHei8yrxk1bwlqsg8+iCO+hvgbW+UyWZFFkwvsJj65xriBFCBsKJ3/OY5dB16cznWkone6+O9QfzelvFe63nvDfDeMH5v23iv/bz3hnhvFL+3Y7zXed57I7w3lve44Y1Xg+e9Osark/gn7xjvdc+hY9N7mRPvTc7x8kNmjDLcOGIvhRpHGFNJXxqdRV+iHjQsRJPEB/LOX9kLDtWSGKs7nnDwAQ/ENdNeRkEtwXadtwTJM3RHL6dW1RpxvQwLLUJO5e6f6GpijrdJMozjaJRk9kO+fWtlvGyIYU4rhZEchoHOi83FaFh3zzdoeCz5248a6LuDLM+I8AeZBHscNDXSCB8nWUZJcHgyt8rzHBxPLWzebAkdeRMGPqaw9wHhSdn2UUNOqXn5mvDonJc1RJ+LyeQQj8/sB1gA+Z3CB6Q6VAoPvFyc2Uos16nMhlcOVSxh3cS08HEp4SIrVGWVDQ+8EoJYVoLg+17u0CvDbE5J5Q69OVUIYeeBvrioinitQNlKh9484llVUHlkzUNhCfS88oEqHXoL4YHOqayaC705lVfF0FskvARSBTUfYm5Y+JgayRce6IJaVHMHuqjKqnagS2T1RZd5D6bXXdgCjFcn6u5qGT6PyXZlOYxWGpVV62rZ32kg31ny+WWmrZJ2CzqdKrKu6LI6ExMkWgUzP1HImwi9m+N3zUYuRwe22lVM92sk3yw7R7iYqu1a3yurNTZNRoi1CyvK5EFEw9zuP/7gF//WX/jv/vavvXbN7ZAhfMhCkWX7fTGR6y2xqfUlGB5dJuuqSz4s+rye2X/1H/+5oP4nbl7+G2SozIVh2SUYIV09loBp40JD27KY2MqNTYiS7eIcQY4J5QmyTahAUBIv0jgs0mIdLdpZlZdn7v6GhjpCBv4BMrBImlGrqDQ+cz29Cuv7CC+TfdLEhIpY6ISZKYOMDTJssE4tU937T7UTE+Ka63zEn7sU2WnBV2fI0nxE37MbsVHQlOFkx7fehEFMlWFzvZnIrhUZcb7FluNd/jFXO7HxlqWoIzwVJwGwTgfb8qnG7X50vLV/kOWjxx/88FgKmfyGuFP/+DstcjtgvWwftxNONpmpOFcRUitkvRn2ULkiVthW84paiWw1i41m17fUSm0HKWKc2YXchCt9703yXynmme3I9rPzDHpx6zFdXFU9h+4dqrIVGhflX15yMk9zEBnbfsfLXkJLZP+0hg2V0p/WOREsL0a220X08G3PqWYty3YdSCb6g9+30KI6LyLlZb5nZAn4ng09nVdsHOGzytm11ozFSBUPYvPFCehsqKK4UPu9vRATrSoZW6WNJOzAiJVYnXzrtwMoeM7FZ51X/9TmH/+Z2i9cAMHQmztIXivjxTIpnmfxQR+8vWtd5uCHb+9anyEDCWQVAc+sv9aofUWVU5Z1sq80mxn+pjLR8enTnvFiWcHAtSJZO2QvcvbMKdmJcrMAnkZWlSDpncWSbB3LSxmZ4iv/8vf+xl/8X/5mp7t3jSi7p1Hm1ijiF3KpsrinFj1nFp0/MavmEjOheP9ZL0YOuGC6Ov7yEv+adfqvVdyUGm3F5dpoNhUXwOICVH5sAWDUnz+3xK2qnbgT+sc64av983/2n/yx/l/ek470eI+7Bzpn0rVK1F2os9Ai66CfZFUOPecZBaCx4rJ59Q/fpgksrgfpMPYp9YBpOW/UG2fMxh1w+fRqV27F+cP0tH/THWjOKTtP/WMe1WDW66xPE9r0nGfTJHkWfiTepT2kSw5OojU2NrlYTNyDvP+uLhxLiGwxim9IGytsVxwM014LmPMMzH4GlgKK8NZDbuYyMBKQw1qaUwWxwSirZ/RO145eojdsvCErlWxZirG6+f2y0Sdf+T+7/f/61/7eX/7fpQky3OSfdG6KW1LI/Dc/riWjSWZLZV/F6XH5P/3be3HJlLPx/B5KrDtKfjH5zf+cfvOZvTLL1v+zr3z4V//h737wV//h36PDCg3nk/PanF0+vgEf7cXmaSXwa3tcNx5MwNM+wnndczdgRvc1L7fhzR2oYjR49w69orHiGCehV/+P7zb++tf/wsOEvHI3Qq94YGzrP0a8CnbHNBWW4t83FyFjaaGVTzJ9fS/0yLroaxsHupRafsj5abmczEkuN3hJRcuS8wma3YJvHu0mI36O33V96/aPG/Q/bnZw9mkSqqSdgVO/aTWbg/TUVPkEUxNPnWz3EI2E1QEtd8uY6qK+9Ds/rv8KMawzMSHffq1ysgGKJz7A+URTV/wTVNz4N5xP9huZT7i+Zv1t7MJ+JeM47+fA4G5XeBvGIgyxfKYA+7F0pohF3IllM0U64q1YMlOEJO6abGERl7hnYiI48dDERITisYntiACEie1HSl8meIeceeRJITrvlx6pHHtLz8MBO4WVTQwBuNb13Z/JvE98ACernLIp+rIifnltCD2U5FgPa+0wxgJTmLZfeoTViH0QkeIhXAXQKctVTqgd3zbKASrwz5GJHcaTMEMUw8E6I2XlRDuJfbwwBIF2VB4meKOiFVQGn8cUlMMSURlVNOLCXCE7RFni/BCv0yFep03+WETEJ4u7GnSFkpN9WsCGPHC4K2RhWcHy2w7ZKc0qNxGQ8sAgAIO+43Bvm9j87NpGxtp+kvExp+/ww1JOPKEdeo6YbvmMMbnZmL2E8fTX9pS9QZRCXaS2L/jbjzzwev1trIpoizzLvBkiThnwBpCYT4tXgSsX4bUUPrTiF9ZSCaMkQaUS2AYHJWwZxi4KqOGCnxM/DbDuTOcj99X3/oOfefAPndt7oXJDYpDWuIpIPqkAu7whS81ZXlkRd8aNFwm8A0cEMO9Lzzl5lu5vgNtSxqtlorrNgwk1kFFlVQJZ0xoH5JMkpUhWjIyUoRW9ZEFV1g29+VT6yExXIUwxGaljM3ULpygzla2TzCknhbJ1ksoxdCqWTNLoTKyepFG2TlI7hrJ1ktIxlK2TzIGlZaAdm8uQRgOby5BGuzaXIY32pAxptC9lSKMDKYObrnkpQxodSRnS6FjKkEYnUoY0eiRlSKNTKQNa0UsXb/bMymg6z6qMlvOsymg7z6qMjvOsygicuCBbxwrSdZ5VkN4zC9J/ZkEGzyzI8GRBMBUGDqbC4aedwtMypsLJy+94BZiZEWvRiVt3GrrsA5rMKNCoY/GGcxgRGM24ZeTkBbivqMFs0QJZj1LzYRAcBl5igcIwRvFgQ6+qgj9dbuiSKvjDpYauqIIfLDZ01d1XBZaZUkW1WntFFfzWIoT1iozXfloV6Aaq6HfcR1BpKfidRRbUqKk8RAPLquC3FyPZjbwqXHZbixT01xqqGl2C59FHyZExR1WJpCBaLgfXrkHdl4K1a9ACpmDhGpSDKQg+FYKFK25nhXSAxe1Fno2Cz4ckX39IDVIEu3cOn/ByQ0w55GEPYP7jYtAViq4B2NELeGzrRZpw9TJNyHqJJmzyz1SmCkKVlHkxVGV2xZwnxY35EFlHNloiTwofCxQY2DAZlSdFkWUK9GwYicqTgsmZFN8f/0iAGXN8OVqS/fZPNtQcVfgVt7XI0seFK257EYseBUeLpG5M4eEiqTNTeLBY52otXHH7i6SOTeHeIq2vFO4u0hpL4WCR1lmu2kUsrRRsLpG4IoVniyQOSeHpIolbUvhokXRZKTxZJCVdCo8XSTuZC79EIopc+iUSLeSfWiKRwDx1PxRjifdME452l7gh7YZXjC9DSg7OqSU//0jPSR2Voj1TTc+rEq3nNTUf6nnZM3GuvJ9/5JX9PC278daI03KqlGyPGCqq8rFMpQSBgZuAupK5h/Inaxgl+UdCjXudwGouwWAfXL4Ky3gJ4RK+0GX1ktkG1eYalH/WAPntC1yQK26wDtWbdUK7XoROgE4YHbwQ5z2LvGcJHW/FeYFOGJ1eifPiVjXYILT1uTgv0MkG+Py3K9Bs4K+hUaWytVf1ylwm6qrFaEs4jy0hOQKuNXR0HTz9kZ5PVEd/9IBY5MeoqUyg50GuOd/gNL/l0lwxL0MwHyfiFUy7243aLWghjHKw+KgW4DUh9Ss1taBq5Otwnp/sRbRWFq5WTa+AF1MgZeTUjxZIVzjLz7Y8W/JsynOW4ec0g0p2jO1tIWbMTcge4ELo8fgoKB4b9Jy5RkZsbynjMo3lAlQ9W/IcOTJP5+Oyog4K/jSDvyMHFYGpKPdq8KP/8INfPdgYBDCSqGpq6f6Gt5KqlBVVUytUKUv85EpZgXFBqUw6/+VobmU5ibyY66AQCbFTiITYKURC7BQiIXYKkRA7hUiInUL7OG1RiMTXKUTi6xQi8XUKkfg6hUh8nUIkvk4hMtRBITHUQWEx1EFhMdRBYTHUQWEx1JHjuZhmvhxP0KRglONZm1SLcjyVk1JRjud3UifK8aRPikQUFkMdFBZDHRQWQx0UFkMdFBZDHVx+NtTB5WdDHVx+NtTB5WdDHVx+NtTB5WdDHVx+NtTB5WdDHVx+NtTB5WdDHTn0F68I04DwRCZtXKT7RLQxhaiNKURtTCFqYwpRG1OI2phC1MYUojamELUxhaiNKURtTCFqYwpRG1OI2phC1MZFNqxIbVxkZU9q4yJreVIbF1m9k9q4yHqd1MZFVuikNi6yJie1cZFVOKmNi6y7SW1cZKVNauMia2tSGxdZTZPauMj6mdTGRVbMpDYuskYmtXGRVTGpjbn83MZcfm5jLj+3MZef25jLz23M5ec25vJzG3P5uY25/NzGXH5uYy4/G2Ph8rMxFi4/G2Ph8rMxFi4/G2Ph8rMxFi4/G2Ph8rMxFi4/G2Ph8rMxFi4/G2Ph8rMxFi4/G2Ph8rMxliLuswfurjVwpa+ztgX3dda24L7O2hbc11nbgvs6a1twX2dtC+7rrG3BY5W1LXIw0gWtC+bS0UPxY40fNX4U+GHxg7VvDOAOP97ix11+3OPHY3484QcsCNG6Ic+2PDvyHMlzKM+BPPvy7MmzG9FxhK48Z4JP5Xkkz0lET/L15dmTZ1eegTzJCtCiWPFZFAtBi2J9aFksGy2zGtEyBvwSHMdiwSULwLQ8+yMHFjJLtEzRFKNKtdeEg5Zjo6PQ7us4eh5b9Qlc9pTponUBz8d6kXbwehmPHb2kSnTyyPPJg9RsySJ/ngRxyv6kJmYWiDGgyv6YgVXmI6iyP6qJzJFFDJiyP2QgQ6ctAIOamHGwiKdTxq6FbT7g+HV8n34g3X1enQlVDcayFiCSsqgyoVpSayHkSo6/k1jQlNCf2g/JTQvxOrEdL9ZuR6xClpMr8bysqCo9MlCe8zu5hkdGyTIh2ygno2TZkCVgySZZDadCkmslm2QLIcuqkkUyWPAiAVQySMbWqrfZHNliKCcQV5Gw107IglH7+EbwZkGWDLy9hc8UK2hkAO6eGKZ+yCQKEYnHQuKJkGjaMY2WLUTadkSlYwuZwGY6tYhO1xZCPVso9RNKg4jSMKY0iiiNhdJaRGkSUTqKKE0TSrOIUtOJKLUcodR2mJKKKHUcoRQ4QqnrxJR6jlDqx5QGEaWhUAKjukROMKzEBkiJfGCgFwpTvEQuMKyooxBwRMCaMMVL5AADfV044iXyf4HRQL9S4jFI45H+1u6w8uI2//xBzNITT0BUhoOYnZegkwgFKy+BjyJ4lIKnETxOwbMInqTgpnuQMO0SuBXB0xTcjuBZCu5EMPh2CRxEcCsFdyO4nYJ7EdxJwf0IDlLwIIK7KXgYwb0UPIrgfgoeR/AgBU8ieJiCjyJ4lIKnETxOwbMInqTgZuYgYeIZ9R3B0xTcjuBZCu5EMFh4Rn1HcCsFdyO4nYJ7EdxJwf0IDlLwIIK7KXgYwb0UPIrgfgoeR/AgBU8ieJiCjwims/3LkL1bKf/BnJPjSw0Y1SfDVLS85vnZk2dXnoE8O/Js5xUtPZPz3hzpcxKX0p+epzWnHJJeJ2Oz82Khm5gnjDUvsEHVkPU8/SPKo0uQkrdw9pxl6exJ7PIQu+wMZFXeQoNc4MO5AvMTafcUWJtzai6EsYow+L43xzYXLGE3aNjAqVLeh/T7NbZmwEXpcFGQOmYMtwuwXQHr+1XMh8SSIx4l/UAQhF6JFFqpUG15wo0JnnDKgmdLnuQzJ+NPcw2+Lqm9rpzYeqQTW490Yp1qJ9apdmKdaifWqXZinWon1qmmEB1VnFib2om1qZ1Ym9qJtamdWJvaibWpndhupGPYjXQMu5GOYTfSMexGOondSHJLwhMJaWKTZTTEC4nWdJ4u0LxiQxVU0QRrDeTPqkKiX+3iqvGvket2/AwEVK4603MwSH6uwVzm2ku40d+1Om/zTVLtxlmTH82XRsEFyIGouQcb3pwhMxAyen9DJ8aQ9VwSLOFynKRisiw6mIVnUtd5igB5xwXTJQtnpJB6yYrUS1QF2UiaBbYkdoiHaAd0faWywOVuboeP/JJSCgJdglBUQ2cjD6NFuZFceVSG+Cf77SYHKrCdgDtGslMTEdCl8r/2eC7LeCYth+l5GrizGJidp1FLI5mA5gVvnoYxPv3k+IUwN9F8iwZsmQYzBNcvyLAsyxCu8QVACWLVMn6vuO0LeoGGd1kGb0ktRIOXDUddoMlmzEA8aOUewbhYQMX83x+57j4upLlfe3lJy/IEwgxRcqmeQychZ6AI4qY55//Bj370ozz3EtyU51WJiapsciF/heWrI+7sARFNZbXf85zj+Z1j+aXnFNBzCtxzyspCuT75j5aNvDl/bLH4VfmQf2Eulv6EjxKI0IPtdqDnUrIByob0S/9tKCL+vtUQmUl2T1D+rc86V99fJPmKwjveTXaWGlzQLk83mlW+9DZ7+oSvim2VNY4gXhY+Mu5v6J+EDuP/ZDX0a+qmP8w09E+rm/4k39Cvqpt+4Db0bXXT7+ca+o66ibVfv65u+u1sQ38+GeXb7j5essGKfUX9ZO0VZM3gKukVxms/rW7CSCfulEMt4ujqFT8LZak1w2D+dO8+BK1fsv72WXYG/AqN0evY7+Hb1Ct+v/Co4b0MTQhe8viHX/YD6DzWXkQ93FXXRWVbXYeVh5C0FbD83CTLWSzS9rLfudQgN7wl5Yp07kd7dA/Ol+GlB7EpmPX90HPTMjGuuuk3s1Q2yysFXr72W7YuqJf97gsN7+VEPKv0cdtCDuowSHzGePDemVX5FJY/8ArwJRN7ijnEterL0cngplG5+GKqXFSsunnZndrEkr6O8JF9jbLfvOxObOJMf169Ht223VG3o+Cr6qdF/ZhCpH5MIVI/phCpH1PIEppsdrVVoP6dRxWpwgcfpopNLOSSyiqqGfdQk1j+TRhm9VyuDPfQyxqfjumW/EY9Jn27x9xZdFY50v4vKxfr9MuKVChgI/Ztci2N7u++4+1estSuP3Ua+rp6zXsZi4e+5Vva537o3YA5kjoJfi+pupgjr5Mt8xU8W7ZexbMJpZo6jIev4fFYr+PxUJ/F457ewOOuPofHW3oTjzv6PB77+gIeO1rhsa01Hlvaw0Ppi3jAEnkdVsxfwKOgP4UHr3bXlU93QreUz4tdnfVDKCPsfdOL6gUC1mD1G2Rh8jugpC3lEbRNlr9RDqUI2FcX6HkHZr8l81uwA47vICPg+C61QcBDeKHBV8MWOOd9Ak4G1QvYHFRRajXktLYNzzZUmbjYpNqFdfDoEtPHTOb7GZrJdnF+0XvqBh1vrjPnhfc19CKcVGSYGKyXZvgH4Jgiwz8bks1TKkoI26NUulCvcehxqNc59DDUZzl0L9QbHLob6nMceivUmxy6E5L5UNRRqC9waCfUikPbodYc2gq1xyEV6oscWgv1JQ7VQv0Chwqh/hSHrFDnfFv77r5ailqWv7ceNe8+8zf0Eiw4qX36ajixWOEY2CF6Ra1yDJbl9ao6wzGwT/QZtcaxJ2Gg19Q6Rx6HgV5XZznyMAz0WbXBkXthoDfUOY7cDQN9Tm1y5K0w0JvqPEfuhIE+ry5wZD8M9AWlOLITBlopzZHtMNBaeRzZCgPtqYscUWGgL6pLHFkLA31JvcCRWhjoF9SnOFIIA/0pleOIFQY6F3UWvkDdA3M2sNUeGIwdPFdox7wH46ctPM/QznoPTn2eqD21jiljT53FFmdPbWA/tKfOYaO0pzaxc9pT57Gl31MXsMffUwqTyZ7SOAXsKQ/Hgj11EeeEPXUJB4c99QJOEnvqUzha7CnSWd5N5vQbonO+Cx5HCBXZrq12FQEtN/QKdIsgQNMlObV+DMyc0HPp/uFlbNmvKxcELbDwrkez/cuYsm5A/iykRAEVwEIaZOXNlyOG0S5+Ymh/SEVGeISw4GOEaxyeILzG4SOEFYenCG9xeIbwNoebzoeoNwq3EN7ncBvhOxzuIPwWhwOE73K4i/A9DvcQfsjhPsKPOTxA+ImUH+GmLR+ASEsiY0TaEpkg0pHIESKBrXZp/r+O+d/dNyZVczTm8IJF0xbXYl0RVOBJlypSoBpBzHsTiGdF5r4JxBMu898E2iKIOXACbfM8TSJ0Au0QtEPiqALt8+RN0qgC3eF5HLKoEfQWQezJTKC7PLOTMzOB7hHE/swEesjTPbk0E+gxz/y09gr0hCB2bCbQx5MPT8FscVXQli1LAxtdFbTNaGR3VdCOLUsGm14VNLBl/WDrq+mVAyNMy8DSeR5PtM3axlDAKOAh5RWpn9mey3qVL4OdKRkKKgb334nAfAxi7EC22WVPnS8TF1NyEdWeQXWYpGUTsmPrWT82SdDk14i9GVPAGDCoT81fjtHZM6mDw3mSestOUx8Y1Nv2s6h37GdRB4+Tasagvuu3XRw+YtU54if4+XeqZcuJ/tkO5HNuxPah4GpFDHOxt5VZjr2tjLLsbWVss7uVpqtfZOcG+qXY3hS8zIihL/1Ztn+mP8c24PRPiLeYn2KXEfqPsJsE/Udj+1VwTiOGw/RVtqSmr7E1Ob0jDmoy7HxCHNVk4Kgmso1eiw2Rsd+aSY4d1/Sz7LlmYLPnmiPxXNPOwHNNZE59AZY5CmJOnay7sSObXpY92fRtdmUziVzZZODKJrLAvsgG0tirzSjHXm26WXZr07PZr83YYcc2zQwc28hu97qcewqHnovnFM7qIstgtMQc2eyXZpqn6MRmvzTDHEXHNvulCXg9GtlemX1aUHRoe3Ps3oOiA9uryP3McVE2L2e4MIXvvSyJwn28SVUF7FiLH+9gVfnj/a2aw962oi6dJLHIV1wBe+AFCYjVYcda+Hj/qorYzJax253DVreizp8kwZdfPH8zCYjoYfNawL1dEVvbMva+c3AOWVFrJ0mwc1We75kExP3UVZC4BhI7ILEMEksgkTlJgu/ZeH1gElWQ+CxIfA4kfgIk/ihI/BGQ+KmTJNgjLK8nTOLTIfkGUgV1GSQ+AxIvgcSLIHHlJAm+JKT1J9nMoKtwT6kp9/D7yUEuPKQbW1vd4BWUFtZkUriubvByOrBxXs5Fc0QvyeTC+ymjfRNdiNCBidYidGii8xE6MtFqhOKqg5Z/8jfK6A2sIDf4DhVK7DIyap+ngyiC+oZv6d2Eg5FYS9CJ4ZKUTl4SLD+T05moFenE4ZtOZG91oi5o8koTh3L600kw8Y2nLyfBzyTBK0nwxST4UhL8bBL8nLuvbqjdqK3gy4r2SGCj0F2k+lygP6dcVC2uKD8b6M9yrO+E6qVAv8Qx3Gi+GOgXOdZ1QnUl0Fc4hhvQzwT6MxzDxejlQF/mWNsJ1VagtziG69RPB/rTHGs64uiPYrh9JVeAFJva4iyQYritJXeCFMMlLjkcpNjYFpeEFMPV71yg5zg2tD8eFYEuy/fZosrI32d/PHYCXZDvsz8eToHOy/fhmhhmUnbRmXblbGLzOnlDZtfssRkuf2y6Khybe4rHJpLysVlh7tgQryTjleI8BfBm0Wa3W3a0U7RpBNH9BW0TbRpndItBe0SbRiPdZdAGEfFPU5x3h4hvUZy3hohfpjjvCxH/DMV5U2izu7K0CX7MPGkL/JiQ0gb4Meml7e9jBkzM76ePWR4djk7OTD+BAUyfHfVlmp2u0xFK/YTZ40MvnhleptlJMqG9BO2baCFCByZajHeAJlqO0JGJzsX7QhOtxPtCE63G+0ITnY93hCZai3eEJroQ7wgdA12Md4Qm+ul4L2iiW/Fe0EQvx3tBE/1MhHZN9Epcvyb6Yly/JvpSXL8m+tm4fh1jnv9cNM8ng7CstnFFsy3sZUzst9UryPCKiM3cxJ7vkqW2y//RkrP61ME1bXPzHS9/yWIdbTLXRfdMK4/gej66A+ja3hp80pDC3Zo6E+ozvk33DXy776qCv/LIy/or8LqeqN1hSnUSqXCXDB8niU4SC9WZABwcvl2QWSWP/qcy0CZkKuBwWBGsKgnm7EcKeCtk65EMmICKi9sSMoUS6eR1bXITXi6T8iJ5c/Vzb3iFW8r186+/C91f/gEXv8sFJNG2sqI8Oc6TpKo8pU8cyZA9JUMrA2MmLvysrsi1GyxJx9+6/46yyBYmNhEW2cLc4ZCCfUwKrUEsj0I1MKgpVACDmkKicjK0YmNI0CqpNci8GdUENGym1juefSmqRtsf/fdWo/YGtTvKrItkZsRsdzfd7iVD/76Edi+j3eeMdncw1g2NSlzqpRLLx9u9hHYvRauJ/3+x965Bll3ZWeA5+zzuKx83X5W3Kuuxz1FJSr1KKaldyuput/I0klyNX8XjR00EzFRbRY+4JWYkuQ2FqXEl2ESkscOTxIwhJezQubcMTnuwJz0242TGxknYxjmD6U7AESTQmLRNMEmPH2m3gWQw7tH3rbXP2Ter1DKGZhyMMyrq7r3Ofr/32mt9a+057ffI63clO7XLeU/tck5g5k50sTNr61LdmUfD7C6gYWT8GvT+qdeI7a1NISJzo28ajGpNv16C5+/Jk9jMl/Pxdg7qFuhPGAFl4KTYCl/rZxNFkLVsE6rbmaEmK/KQARozCKXrfMSR+oQyj1dim3wMWWQGShEYWb7KJhOL67amFYzhIJu348DOab1EZJn5Otu517SbaFvAVUwToGkBYLBQCacDtg+SMugbYyNZZCSKy9PO2949PuxBZSNr2TgzI83eoWpm1hwd7WFx9CtBn9fQ3V8O+rxRlr8U9Hk5PP6/gz7uecXeZ4M+7p8wusD7Z9noZ3OqdBTCdLiOCegG8f3L4Lkrb3e/CpdVWiY/fAi57srTTlgcp9BUYdzuV1oxBkPwG2ddSozn8Bq4DdK2ktZI2gFpR0nrJO2CtKukDZL2QNpTUknSPkj7Stok6QCkAyVtiUFUkA6VtC13UZCOlLRD0jFIx0raJWkVZ6nVrpD2SFoDaU1J+yStg7SupAOSNkDaUNIhSSVIpZKOBOoHpE0lHZO0BdKWklZ5T94GaVtJayTtgLSjpHW5TYO0q6QNkvZA2lNSSdI+SPtK2iTpAKQDJW2RdAjSoZK2SToC6Qjj6SiFxqEpNs7186a+1IXFYYrtyhTr5/r5eEU9SLGAmWLtXD+fqKj7KaRqDd5U81OOKiIiuaF/LwUH4bMBBlXQfdIKg6BfG6MiT2CzXxuW4kP0Vp8WRtTqFsrer3UlpWH6wt8or3h5cNgW+wnH8ky9xk/Xzqna2a2dk7UzLAQj/rNBv9hNvVkh8xp57dEnoPCT/e5X2ybgpjcaz9P2TvhYtE7nBJxrdJ6Cc7UhgM7hY9Fx+jyNi8y5LBI76+agavEp4CW2EV2dsDALpFtaQXCnlQ3ctLIMkVaWIdLKMkRaWYZIK8sQqbMMQYvsAmGQVjYh0somRFrZhEgrmxBpZRMirWxCpJX129Szfpt61m9Tz/pt6lm/TZ0UExa+g6OAMHVFAwJH2PhXz4F5+ANJ2L6j+vf/sIYqwqtusJCl1CnJ3R27uTLMGubOiDxS08Yv/sl/8cgzzb9654XhzTzkIQQvq60RiGCD90/Dm4dt3mOIvDWA+E9q42EWi25/hTDXeDun5+YCr4C0zuwVIjF3rMup50GfaE5XaaC9yqmXtwcdiPO8e8MAeimAEAV+7uYCgOjedpB25TAjet9y3vYyS73MrMdZ0Myu0Sp8lZnNxwedrKnQqB4a9JiMgHiUOiEjZEwGD0o4GgXDbEJG4JgMyXiEoSUDNratFz/Bv3/+wlDAGOwJHEsZdbHt+AEpYNUYyVQFoRMKOEGvLAVIb94EYi89aKY89YuZyEht2BFqQ0ZyPEptykhPZOg3ZKY0ZWLFtu0XDhUlhuVI4W53frJpzN25O2JSr8bVBBAiet2jxGKkz6MkYs3Po6jZP48i5gE9Aq3YvO4RiOr5qkeg9NYNj0BhsusegWJ71zwCjfxd9Qg077fiEWjYb9kj0KTfkkegMb9Fj0AzftYj0IBfzyPQPmrXI9D2Z9MjUE0j8Ag4fBuOUiN3+3C04W1UiqCT3/bQGo2F1eARycIJR3vApqUAAfqdIKyfETgYZQ6NwMY4JKyR3qDE4CgMjTKdRuBqlC0VjnSLMK7CkZ4R1lY40jnC/ApH+kfYY+FIFwkDLRzpJWGxhSMdZWdKefLw+srOQgxhBNpsaOdKefzwesyeKuUhxOs0O1/yCO0upEHH1peLj9tTtfsNO+d7Zn3PjO+Z9j1TvqfreyZ9z4TvGfc9Y76n43vavqfle5q+p+F7Ut+T+J7Y90Sep3MvCQ0NQskZnsK3ufAe8hS2lmhSNFLDYTr0g2Lx5Cc8fZ6gLN9HWbl1koKXyxOkvftJ+/eTDu4nHd5POrqfdHw/SYxKjZDW7iet30/auJ9U3k/avJ+0dT9p+37Szv0k8PkCAd8QUshLFg7Gi6+d+AQzbifjd++j9O6j2JNZ2PS+lBchwJye7LYTpOP7SeV95beGCnMesDNkHQfY9ZwCUud7E5PcTe5YCS6SuqlaVVDUrmJrvi+qaHsdNb1M8C4acG3AHl1MJGo5RECKe7mfN52UL/fdJ6LX3VkjJvulo7BdvIM0nKw7uEHyggomXUe28DE5WLR5ugE3qSXlGpetPRat3BvihDLtq+KEDuzr4oTq6m1x7kQ84MZ44HS5QHga2VDZsa2H25YeeMd5CEbD2RSQ4A4aCmqoivxfcpkH8Ownwf047IkkugCfZxFOd2iA9gO4IdInb9l2eS/vvDWgdDwiwf6zSMp2cBjwQdK3tHRUIfXoUCW10dsURQps522KIPGmprYtuIvpm8SNUvsbBV5bkFrFToo2FilaVBr2MyLog5oVb+GE9qdWWIvpIRR+fDzwl1UAh50MENYohj/2ccFGDh1Tdj3Ka4zJIcob0UJup/O3zpozd6K7DKpskbWHxfQCjP9d1JFD5ojIEphi/aIKBphi+6K+8pti/WGVJjbF4UV9vTfF0UP6FG9UVDibsabYEecsqBINiHpHF51Z9+L4IbXSboryohpZN8XuRTWybopSouEifnxRzambYvWi2mY3xeZFFRswxZ44z6IvKYmCq/7aRWU0U3okeXdebwmlFCX2PIVJRI+0ixd/U6w+XJP28OpvIK0sdh7OUZsbZ+IejvILw9KmlBFt2PlhaZt2bMj7waoEOoVApxnoDAPNMVBnWGIuQ/vQxnhvSiAUalM7y0BTDNQellgJjiTQxJAP6gjUZaBxBmqJoRZoOqpx5FguGW0G5TViDG/f54al6ooGYs80VtaFVQw8o8LijEfeBz80hDsiYC/CP2Eg1e79wiIu3huwZNvEpaQnbho5seLu4VqyKG6Ly8iSuBfzVmXOkbfNtqxivAx2ZG3DOn/BRr6xR0FSuC6ua7LMCZLCq+K6IYucICncFtfreocXKIU1da66K7xiKWyoez3UlU+xFDbVXQpmQuCwFLZDohKel1mKkVk1ytcIl9pae15OMYbicEnpGimmwjFO4q6pSFnGMdw1GLqRNcc53LUcg13FKVzbTyjXcAZHE644ynWcwNmQHXsep9LzRaLYQecZiuW2oVdCQAzSXinQP+jYDmGLoYRzJ8RrriG0U2tI0l5IfF2OTWrH5DEXW14jedTXjIUHdKFmTlGL0vMKRFlXFX4DUW+nCJeqeKeq3d2oFLubqtPdcurcbdXk7ugIDia9QXrqizZI3fDMdVvGAM3H6yEKfoMbpPlkPUzzbj1Q86l6qAIcpxqs+Yw/XAGHUw/YfE6GLM85F9zADf7zGbeOcgODyTUvKa/i1ugamZTXcWd0TU3KbdwYXYOTskp5CtfusbDTcF90zR8LuwzXxaoXYmFs4bpYdUYs/CdcF6suIQ0yE3OldMxvc9aV1bSrJp3MP067ataV1bSD4yDE5iThDkNITRiIj0D7FK5jwrOhBYztanJrBsIRhvbupyXYhoH0lqFx+1k6Ng12tfLEzOblVys3JTNbIEEuCH7IBcEPueDhhxwousa+/u7pL1E2Tr3v3C/d5HdTXxYBq2e3RTaITn5B2ZXmIL6uyJBcZWMQTleERq5bBxJxQ8VEXmVD4GSKdgAnBM1ANolrhvdaVupFxVtSEm9JSb0lpTG6pDS9JaU1uqS0vSWl4y0pY96SMu4tKRPekjLpLSldf0mZGllSpkeWlBl/F8xn/X0Qo7peUfJ5f03Je7+dVcUDcHDLigfh4NYVWXtOrCuy/Pjriiw//roia4+/rsja468rsvb464qsPf66ImuPv67I2jOyrsjiM7KuyOozsq7I6jO6rsjyM7quyPozuq7I+rNR0baq9aesaNvV+rNZ0SDxBXNjYVn1WSzrCenbYSm9N7pesSfEoH0vO/OFV68zbvU6Xa1eiVu9UndkaLj1ac+dI/arc8SBO0ccugXtSBc0t3yNu+VLV7Q1oyvaOlY0XbymXBYlljRdv2RF28KKJh+3saaxdAaSryideffE/wVXuTk1z/1eK9UZXalOu5Uq0ZUq1UNKwy1Hi3puWXLnlmU9t6zo0nXVVZxL1bguVbp23dC161UVdHtd68y1atqtVTMqgiZVDp2qGtnFqDKZya7KxHX4jXFj7jYgJbQ+pmAOMFNcY/jFIxDVeCHA/Dvq4K3hSrStv6sdLyAw/EST9Eq028aHK9G6/u63bFysRX2wosglimEnuXsNCsNUlsa3pPv78GZ62ayNoUfw5bJZ9dz/Y0T3cad/2ayLew3mc75V3KtwrylUjTBA9JVVDLnRJBko+0rpknUCyoFSeqAcgnKoFAvKEShHSlkkcwCUY6UsgbLaKFXLnZ0Mngsoa0pZAWUdlHWlXCW3BpQNpVwDpQSlVMp1MotA2VTKDQKtg7KllFdpjQ2UbaW8TjYPKDtKuU3Da6DsKkU4QHsg7SlpjaR9kPaVtE7SAUgHStog6RCkQyWVJB2BdNRw6EVsJZCOlbRF0ipkRVeb0uXd3y8K//umfgvkGBrtPMAMPChE3ZwADXhgGlX9AE3wwDRQnvWmhDh+YBoIsachVqMHpdFCGi0JsfagEHsIsddyQ1mANnORsIjyVLCSREVh1Ygywg7skLCjRFdhRZQSgrxm63sc/puCXt5RFPNmjWbO35b+NvQ3fcVZYDr6MEXZS7I5KNFbElCPwrslkRPgbJdcKCniW8u+dio53LFS5bgi6KT/gTwGsl18p8ZAJWiXsiK1XYzOyaawZLG6qp1Wo3Oz675chbA950skqu1lybkSEe4Lzp4Les0FXcMeNNCXWkwjBuZ8ti7wdRd4nYE5S7BLDQjzMWQmW4zHWb/o4t2oylPF22M8ZmxgPk9ffjE3mQAXiSWXwKsugbJKYL9KYJ0JsDAG8rbSXjWgGnTn0xrWNIc5xNpvg4VKc//o8zYi2mkqv6Kq3uxUwf+LlXsvfu33fuSbPnR+aQcmDqHmjrfoaAQ1FUiskk7DTyeq0ln78SqdFabjBls6kk6KoafppHU6aUcsCcbUBIx5wAK2QMR1TJYNwZ3fMfzQsOmLnej7vv6z/8Ov/hj7aJVq9g3v9Qk7XWUf6vMdvJ7CrPnFwEadX+uY+G4Lu99ReitPxVSHTbrXbFosQ+Ys7P4+vIoXy/3L5hAv8uayOdDfz6T8tIsNaV/ch3D/jLgP4N5LraGUCgd9Kbg9qYpniLA8/RSicGh4qco5yBGZ/uscsaXg+UCGhSOxFFQfSLJwYJWC7QN5Fh6hS0H4gVQLZUJKwfmhbAsPz6XA/VDAhWfnUlB/KOXCo3Mp4D8UdeHJuRQMIMq78OBcChRQyqXeOJF5ErZIEJl5ErZDOTWXig+UsldNLTVP0m6owiuKFpRyTplabp6k/VBlQXgMJukglCNzyVMwSYehnFBLAbbFmtv9/TYtdiJIDirMMV+PdtK8w6ZJ8zH6k3yc/iSfoD/OJ+mP8y79UV4/zHpvtDcXCAzUfUV+J/V3Qn/H9XdMfzsjC3CbKynhO9tcSlfFOQ5qQucEqOKkpGJMJ4UDxTlVEjo5IPIda9r9A5mRER3auPu0TYVZjHE5EGTjiLftJ6KVgeAb4z7LcTkQlOOIR9onomsDwTrGzZbjciCIx7jdclwOBPcY11uOy4GgH/N1zsiS3xZ4piaE9CKlN7nOGVn5OxKgWxkW5S6gAa5iHeRgiIa4nSFk/bjITUBDXnMh13CloKuMhri/IY6tQM64F2ic6y7OehVnF3cQujajIa56iL0IfJymxl50sW9UZati71Wx13CFoWsL1j8knSXF9AxkY9B0XnXplFU6+1U661U6u7gK0bVdPRWneKUVUUjo0TTogoZNiy5oDiR0QQsnVnny0EZ0QXMnVSFIQtGspzFFf3ZTkbrZSUXYZjsVGZutVERrNlORqClTEaTZSLOubPO8KvG6uRdxxaYYzToPSHvy+Lqe8MO0QC4RMU3R0wjKBHi2UpDVFEOt3vyYSoIVf9qbgSdWfIG9hawo1vfOemSiu+kdroRJsfxaNQxDGZ4EPIgwPHX0KSdqwGNwNBSr4JE3PHmB0ABXuYmHMjybErLnh+y5kNdcyDVci+kqBS4Bcawfx7o4112c9SqOnFJ40nZzK8LwrGMvutg3qrJVsfeq2HJW4fHcTcEIw7NunCWXzqsunbJKZ79KZ71KR44sFH2V4ani4aleqY2A5Z7pfG7cjN9N1Gzp2MX6NHv0Y5z69/IpsggM4eObdszSD/iJGSxP6ge2xCyWJ/UDfIJMOfWjc6e4YxaHpp9NiF3go7N5KvhshN5q4+dWPkngrW94g++bvT7E1FR2BdLnVItpUoMijzGDY9vgY/H0sBYLxs2m+eZ7f4+AtRURcitPbEcE6dvUKok+mUdVhswRT5826mP4TPvWVfyij5sVO/kS7ZVHeDyX8tOK74k6ZG2FEmtXdUiK3fN+SWe8kibF3nmUscEauc/JiYooaJhWZPxBFUEWdUVmvkgVObrgV2R2pCLHF05UZPa3VRFkUVdk9otUkY3Mr0h3pCJldqIi3d9WRZBFXZHuF6kiO7lfkamRiuzmJyoy9b4VIQTZyZogj7omU35NKrGziG/jujJOy3EjV2XBiOI3+m3GVtS1c57B9Iq6XlO7NXWjpk7VVJGcmqB5FjuGjYWw2r76bFehtz0N2q7Cc3tKtF2F8Pb0aLsK8+2p0k7grbNrqzycSq2Xh9Oq9fJwirVeHk631svDqddOEGm7zsOp2Xp5OE1bLw+nbOvl4fRtvTycyu0EHlK8PJzqrZdHrX3r5VIr4Hr51Dq4Xk61Gu4EHmq8vNytYiQ3d68Yyc3dLEZy2wZx+0RuO6FwTsbESuR3JMbcfeaObJQiGrtjRBx224gI7JYRsddNI6KupRHx1g2TKSq3iLGuGRFdXTUirnociojqUShYHYeK1XEQClbHfgisDuKHLCgSyFnF9BhB59gKBZ1jMwQ6BzHkMmk3geRYDwWSY00hOVZDgeS4DUQOYMg9yi4W6JMbgnxyXYBPrgnuyVWBPVkB6gkw5AhzsiQoJ4tQc8VTBLFOekBrhKYDEU+aAngSZF8irzyU7YvsJagh8kgXKqgU020CjoMZdXMyjJh3L28OLQsDQ22lZfEWYVqP5V3KOzWe+5eArf8BMKSeE5bTs2DmP0NOPk7t9mnbqQHkH0XoRxD6YQl9EaEfYugcoTMXGgr+FqEvIPR5CX0Ooc8y9AJCn3GhgeN+GqH5ujAvoU8h9BxDzyL0jAsNrPZphJ5CaJWfmEToCYYGBDIgix0eu6pZ8nTW+XQYRndt0P0IdWdlqcXaFnJ9DbBWxMVxu88Ft7KeEhflWF+lc2j6cbzvpBDgPZroOwMh8G50+85uB8E9p/rOnAa8h9P0Hqh3fZberVi823P0ribiPThF717iHTPbqn00RR2cf9cwM3eiu1zQ5is8CLxBz8uD1pzgOlA03Ng5wXWg8Dh9wHWgeDl9wHWgADp9wHWgiDp9YFBRiJ2+Y4fPQN+Rw2eg79DhM9AHXAcK09O379Aa6NtzaA307Tq0Bvrwykepfvq2HXYDfXgppG4AfXhLpPrAPFpoXl/wA3kkCYnrYGw09BH5jQrIOkB+gwHl4fEbjC3vNdfgpd57yjUYbxUYP/wt35SmxWWBmhdqk9aoqc0VtUdrIOcWuI0H/nH6r6mKDe7C1P4o5eWWj4OB22rgF7OBss/AP0W/bDLwT9Mvmwv8M0PRUeHOUkumhmJIVOxMnMBjmC2CbJ7FdWOJwtin7Ck5NXgjbsgW5sFgjuLZGgjtrNRtn5o46o5PTR1116c2HHXPpzYddd+nthz1wKe2HfXQp3Yc9cinjjnqsU8dd1TgMVTUCUdd86mTjrruU7uOuuFTpxy19KnTjgo8hjkMcelBUv1B3vmR2EwIGMLegtpk7q7kY7R83qw1xqkfvxW+lhvSwQE2/Rz2GnngvNX9S2HWLEIb3eLpt0HzaVCFziag9PgGMFqgKA5E61YkidsW9OdjVXOHobbgbSC7ZMbiltm0ZLRBYspNuwnodUfFrAA1MA1jGxrddh0lrhXs0/o83VTN89TFaLsYsW8BuV2xo6n57RS5xSif6oF7AD4sXD5lxz284g8PR2S3p965l3XRKjHr1imiN/L2e9QgFdH5gEXNjO49ti2FiIrpW4X58gfEBdZ37OLGOEqPpBaDKXOC0jsRyxSxV99R9AAZDKKjCuyGvQWwjMY6fzky8d05xzKag/FplIZbm2hMbgD/mKIzmRroytoiZgP4HRyJxiiPA6AeHIkmKLWD4YIjUZd7JsB/cCSapvWwbIZyQdkseanZHFms2SnRi5wXXcyeKH+eJvs2O0NOTbaALlDhFzXWDShyLkxk5SwMhd17RoShu8D+In+3NxS+7jwlC8jSPTUUVu6chF3GXRelwzKJwtppEVlA+bG0RipdxephLUZtsUaj8pBulrC3sayzebDes73I2pMmpJy7cqnk/CBSFGU5Agfh4WtQcKWzWXVTXCSvcUes6/07tKcS9lRS91Tyn09P+Z3juk166n9OzRN3krt6qTitl4ozeqlY0EvFWb1UnJNLxXm5VFyQS4WVS0Uml4pcLhUPyaXiolwqHpZLxSNyqXhULhWLcql4TC4Vj8ul4gm5VDwpl4qnONGXMNGfwdn3WTFHb09DyTWyZ6i4bBegzhrZs0PCZp0bEkvr/JAAWxegpRpZOyT4VjYkIlc+JEzXQ0Nid10cEtDr4SFRvh4ZEvrr0SHxwBahSwoQIowp+zj0RgEzhDFlnwQINICEsl4REuAMp7un7TNubSfI2dMyii4p3HIMwE57SeGWEz6/XlK4ZVi0pY9wy3j4pY9wyzSDCB/gllvg6cADuOW27YgHcMsdGN2GB3DLY7C1DQ/glsdhYhsewC1PwLI2PIBbnoRBbXgAtwwLDvQAbnnKTosHcMvTdkY8i4oaTY9V0Gh6eooZTU9XIaPpaSpiND0BEaOfxjB8uhLrerafX7Ix7/qXoCe9gd+UrIJLUJhew2+TTIZLUDS6bS9BK+p1ewnKUq/aS5YCgpcsJZIvQXv8mr0EE7dX7SXbxSH2kp3C2fYSTMkt2UtAeF60lwDwbO0l4Dv37CXAO3ftJeDdNO0lgDsHdgklXdIJ80tQTTvlP1TjDYrPeV8lunQtvOHY552yXQPe3vNOG68Jb/d5p67XhrcpzzyRe/DBqwHGDlLufgXUGmGhQjAdsphjxsDIgOjVYYvlOavNswRhHAbC926qvzsQGxQN9fcGYmKzpX4LP45RCjTVwKrdlpo1/IW7owv3mC7c47pwT+jCPSkLd1cW7ilZuKdl4Z6RhXtWFu45WbhPycI9Lwt3Txbu07Jwn5GFe0EW7rOycJ+Thfu8LNwXiiALOfNCMXScQ2jNhkXympxU8pbCX1GZr/QsXlzQjqtXedz7I45Vy1y6uPxHZCWxDJZLMUu1OLQs5NKwtCz0MtgAEYUlWKWrssazltdgiS8SO3VsBNqpiyjqyiZ6nQmz0SAxL20J7kAkawFYBJFIr45JBwBkM3IW6spykFtBN2n1rRWpn5DPjzq5aKOQGC3yiFSb4BCr0MQMUqN/sknoK13nLyVm6Y65q8yxljLH2soc6yhzbEyZY+PKHJtQ5tikMse6yhybUubYtDLHZpQ5NqvMsTlljp1S5ti8Msd6yhw7rcyxM8ocW1Dm2Flljp3Tfey87mMXdB+zuo9luo/lso89JPvYRdnHHpZ97BHZxx6VfWxR9rHHZB97XPaxJ2Qfe1L2sadkH7sk+9jTso8tyT72jOxjz/Js8QFhiFkwJD5ARtlz3CUItYpbLTR24OrmCTq9A3cPLLM2XDZvAGD1OfDGmsIrAut4FoyCGXAHwGOi5T/lMpHHpDylEOMWgzYG04rh5hHuFMLNuXDgWkMQCwD8mA2JcMFSTIQGZkHT8b9C+wjCPYxwFyXcQwiXI1zmwoFX/iTCPYFwj0u4xxBuEeEedeHAZn8W4Z5BuCUJ9zTCXUK4p1w4tGHYzz+gvLH/Dwfnlg7OTR2c/4kOT/uhDMy9UEbmbihDcyeUsbkd/ocOztGhCShNGZr23dVPxyZFrGVo2kfFafMGj7AyOMHVdGihTw1tTJMgCQ/PqV0c1cF0KKOXEC5nONH6fIzhpp1Cp0MnfRrhHmK4swz3OMPNOO1Qh2q6hHAXGe4cwz3BcLMMNz6s0FCfQbiHGe48w817iqQTwwpF9VmEe4ThLjBcj+FOMdzk0B+c1LTr/Jk4DO/iXRv/8hCuGC7K+4++TQQUvvJeJkjaFcgxkHaVtCeQYyDtKWlfIMdCaiML6UAgx0A6UNKhQI6BdKikI4EcA+lISccCOQbSsZJWxYyccWKnAeUTOGFKWo4WE19iVA6kdSVtiG05kDaUVIqJOZBKJW0amZwlrUqTtGVk3pY0Lk3StpEpXdLGtLSXkdnuJGMDSjlwIShpOFjaywhKeEnD09JeRjDLSxock/YygoBe0gy1tJcRSPWSur/SXkYw2kvqDEt7GQF9L6lrLO0ViQAxhXc7/6IZjt+xQREUfzPqfmeYATqTDyJmFPIwsOadnNx3DxbB3AOJ6tBiYXcI1YimVTEXMxTGr1jYHQrXVyzsDoXlKwZ2hwpqQAO7Q05Lir6Dz/le5Vi5vxzrWo6rZDqTE53HkHmicsFV+XhN5K17Qk+EMywy8/L8RnoqHGKRnBdzyaS3hFMs8vPkTQu9zZdJ3nyRd26sGQ4ENeK9KoCgJ2uwoTVYYzK9vCmpQYKGRhS0gakFJII9DVfo1H3vqEaQiO40XOFb7vuYageJSE7DVaLtvht5zBSlQorsAK9qoL0RnaxM9A4ad2ekMtG9XOyZByp0FFBdVuo0zsIixQ5StCIktatFgghcXWSEGnOhJgS6QSWIxuuCI5RxoeIrut6sGi1+SlGkDuWLIAT+npWAjfCRSiQ0xB6oxFMgGwfrMs7ipSwe0p2glFPCgYagKtzkFTJlITtsSA2bXNFVaccVtUXBqDHK8U1Qck+GUHqywOk7GKI7IwVO76Eht1yrs8BLeepas820yYsnmIAbUg1RvZFFNNLWaot0IUcxO14HwYNHNEzuQYjUjexodGTDbH3HBp2jaHS74Wz09hzIi14TuEPaboS86HXx3+A7zUBEAjj7ApEXfVX8r/OdZiDCANRcwTvNQIQAqnm5Gg5UBKCaY2sgrSlpXXYKkNaVtCE7BUgbSiplpwCpVJJYkdwEaVNJW7JTgLSlpG3ZKUDaVtKO7qwD3VOr6bIL0q6S9nRnHeieKjOAO+tA91TuprKzDnRP5W4qO+tA91TuprKzDnRP5W4qO+tA91SZPNxZB7qnVjNgDaQ1Ja0b2VkHuqdyN5WdFe1l7utxv7N9URDaIvTkQNDZvhAIOtuXAEFn++If6Gxf7IN9PSr0wb4eFflgX48KfLCvR8U92Nejch7s61EpD/b1qIzH/x9PUZ1PjYdP3xFOyYzTTxYuyaLwWqyiRgrPhA9AOOgnwjpJ5fTflNN/S07/bbkndOSeMCb3hHG5eUzIzWOSsp9yD1oSceKm8G96wJcRdBrwuoqg2IoUTGLanhrkp+Ttes42BlCIxdnFR3WbtLN2apDPckGeG5Zvq87suI9WZ2e5wchnvAy3fRw8fm3qV5xCJn1kOh73J+yp4eBtVbsd80Hv+Lmjn6kR3PLx9PSyIJ+vjeQMW7eCGGNTSkjnNU7cMJ/Cuj6O72NDosSU0L+ZHuanSw8TMkMJPFlpAEEiTgtxcOHNU8SZH3hxcEHqerhvQ0jseb54YKcQYgGNOwMW0hkkdLbMH2IL7Uaj1ZhGDucG+UVu3vl5v3w0hzMF3WjoKTSGeW9gz5b5IyzCvI3frSQYUwtqcaYjWV0o80eZ1caJrE4jvJf8oiQflzYZ2Atl/hjT7dnYr+/jTIrwO22UZWB7JQrxBCKf89qO6rDWj3qO6SXINyltG+VsoZxNKedMmZ9h4tuSeGznWaELZb6AxE9D6X0JZZsp8yeZlrXn/QzOM/qaRE9QtrhE4ClEn/fKlvixrBar5xOfYlLYdtC7Nn17mD+DHnl7mD/rt9mlIUsaA8cdJY2RVTUaVqmqZ0+XpZ0Z5OmwLN/W4yoyXGLhEqTQq1ENV4f5tJ0uS3t2ADtH4/YZe9HP8bSkcoOJNLxYDUAyoRQDsKXa9tnRePO0YmSfZm/1JBGImbRgeWmMF/1JK2NyLyL9YdAfIV0GUCn0RdAfI11GAxGbWjD7Mcar/aSVjtwR+oLYHgJdemhd6FOgW9KlubGl20kwHlrEyrHaYhtCT0CfFotMpL9KckOtNY1ZrRWRXFGrDms1obXaj0h/WKxLgS612hT6IuiPkS61IlhVE7XqsFYTWqtdoS+A/iTpUqsNoU+J6SnQpVY4lXgAlFgHTmElnBsOSoe+NiEmn2LE1UoTv6Azsu6eQhdqtDWJliDaNKJpm0BypzmyHp/CYNBY1xmpgUi0b6UtBnbT7JWo2/lRY6K7iXvNXxpRACnN+yiAbJr3UQBZccoRW+Z9FEAqVZHbToti27yP/kelM7JaaV5sVZoXO8bX/6jrtHif9kitcbJdxT4Ma72NB2trlKKt8fnYNO6aO0ICTjnxaiHkksV4zPGQWynM1sgjGwPMkxbnAQAoMjZiFtzHAbTGBs7IQeceLCO3VQ8l7GcNA0kb2mIwFCVnevoYRY1PvNc2KysJbSd+bZD33MvjAeV2ivANycjZSFDdNIy0OnJCIwkSP+pnAWVSXqahBS+qa+L3iIra0HDKyZyiBwYPtKQimNIQRzFLY/CpZFyn1eAhqm4SSh01YUReDEjYSEyitNnaBPhsetY5PBstwwEaOi1CqV6bIgiEz/QjBJ600YBBzBcMAnUx4D8Xs1odLUnV7/fqLdobAwuiFRf28bRehLeywEbjgRNLEruYnR+E8ED8O1l44OnCfDJ7Bs/yQIX8HSs8sKTCA0snhAeWfld44MHCA/okH+uS6IQsfocKEKiogwgQ/M0opPRzIAJG0MuJKEOYyyYzrK1VRALFIKSmSsATg0FIXRVcJ9aCkHoqnU5EBSFZFUEnWIKQRAg4EvgDIYkcMEnLShJRYJJWlCTSwJHgPwhJBIIjwXkQknAeIkFzEJIwHyIBahCS8B8igV4QkrAgSHpdScKFIOm2koQREQkqgdIcLyJSmIlQRaRKBcoVPAmhOo5EpGgRoYpOCVMiUgiIUOWohC8xIt62mphUZFjtrTy6GFjzVBBAFPFluKaK6OU3sgRKjbC483PBa/1iZzXsI0yjiG7lzeLz4RuFoaWhl7AbArH/qeA3fz4ZDyi1CWXIn09s+GXj3FW3f6HC9l65mcWV5VsFBw2eCn7j55OJKAgNOIFV3ASF6Y7HY0lNfdnGb4xHY7FHGYdWFwv01fGKK4fpSGQzFjkX5Ma+djyEKcvkJaLjLprDn0/yuFjmls4ap0X88jjbY4Z1SWw6DvEDVsU8Fcy9lKE0TwWf//kEYoFPRE1oHLcQ9SWGTG6xMP8u/PLxoJLWyNrgV1fYJQcvqOmOf/PCi3/np/H36y8gk5cXhKE0vJfYdoc4Fq2ObXn9sLcaUg6EvJVfSJRnBA7NLyRljYXsoQqv3FwYvDJOA2qPBZPPB/N0mebzpiuu4HlD+xRFCGSKn0/oJjZ3sfl3kz7Ak3Ck+KtwR4+Z+Hl6f0i9Y+L9EfXOivfH6V0MFi4HBAGHt0UNOpxHLwadz5qwcWfUYMNNURDfMC9eoDGTh1bu5cpW8ijKZ/QokTCoPIrg7oQeJRFWl0dJhR/mUWo2hMeRuLmQN8A8EIsjtDwCExvJzQXIYduYGDnGRjcXINJvzc2FnDOPGuyVcxGut4d56N0wRdmdb0E2LEvRgR/xbo96d0a9u6PevdrrDG+cXbmX2LDT+ddnTHJ3DrP9oKHQJGCzxkR85rCCYqVO8KYcCkXSKhLdjUUTj1JQ9aTYuqAA1x7AVLHZoMSYTYpt/dyobBcVW9XHnfs/bjf6uSS8WyfMj7S79hOrYX/RBDiRNrFvhrB1cxC6mdx0l5xIYhgNFrhgRFqnWaTN/zN5dyIFgtcB4FPYNAKtpPkh0UplUNc+xeaFfvdKRwUXWoAsD2W7yzo2Ff4swX3k1gRLNZ2hwGEwg9xcNvsNQmoQ7WTIJZnQLz/TYKCdBiBe6L5sflpo+6DtNgAM0+jnScUnT9Af1W1xKIIA1Z1wKAIE1YVvKIIHlQr/UAQWnH9JXlQr//JQtDedf2UoqpvOf3UoepvOf20oTHrnvz4UJr3z3xgKk975Xx0Kk975Xx8Kk975bw+FSe/8q2gs8ugdZQ2UNZ+yDsq6T9kAZcOnuEavKZugbPqULVC2fMo2KNs+ZQeUHZ+yC8ouu+VBHbSHz3t+hH1Q9n3KASgHPuUQlEOfcgTKkU85BuXYp6zivk0GfdVYoKz5lHVQ1n3KBigbPqUEpfQpm6Bs+pQtULZ8yjYo2z5lB5Qdn0KOwK5P2QNlz6fsg7LvUw5AOfAph6Ac+pQjUI58yjEoxz5lFegRxCSLa5gOiii8R+et4/O6H2EDlA2fUoJS+pRNUDZ9yhYoWz6FQBbbPmUHlB2fsgvKrk/ZA2XPp+yDsu9TDkA58CmHoBz6lCNQjnzKMSjHPmU1HhIIyGssUNZ8yjoo6z5lA5QNn1KCUvqUTVA2fcoWKFs+ZRuUbZ+yA8qOT9kFZTc+2XmJayx83kMER9kHZd+nHIBy4FMOQTn0KUegHPmUY1COfcpqMiSWUk1ZA2XNp6yDsu5TNkDZ8CklKKVP2QRl06dsgbLlU7ZB2fYpO6Ds+JRdUHZ9yh4oez5lH5R9n3IAyoFPOQTl0KccgXLkU45BOfYpq+mQCFRe+4Cy5lPWQVn3KRugbKSUfMhbAh2Wzw15miawWH4KrI2WwI7l82BwtASULO+BzUHP7fw0eB10v56fAcOD7lfzBXA96L6RnwXrg+7r+TnwP+i+ls8OsxleBGaphycng6TYw7EppnGB0M4ohrQ7yuyTOn2CekDq1AnqIandE9QjUidPUI8DEb8dpa5SVHr8BHWN1LET1HVSOyeoG6Izp6CGQTmi+xzXlRbOTtaiudzUzuLgNcbFciDc5tSe45V/gIMQ0L/O8ro/gNwRHoYWeNUfQMwI2F9neM0fAEgL0F+necUfQJYHyF/EYFwaAOAKwF/zvNoPAMSzbFN7itf6AXB4AAI4xyv9ALA+V1Gsbh5TqqmuUEwpprzNApIXEYN5BEzF2LEiYnCQhrBO7DgRMKcHqC+WlIyIGLykYT7Bwoq+OxhKw3yS5SUbAnqCwAxikcmFiMFaGuZTLDWZEDH4S3i9iiul5EUzS4VPqHI1ZJCBvRJ67JVoBO1DkS59tA+FuPTRPhTK0kf7UMBKH+1DsSh9oA9Fl/SBPsheiUaAPsheiUaAPsheiTygjxFN+pSGa2xEO3eoc6h1DquJJVNqpO/EX/ec+Ot+E3/da+Kv+0z8dY+Jv+4v8de9Jf66r8Q/Wp2Xx3GM9yZG0KHuwUHjd3UPflf34Heo7oHoRjeDYmuieyPofCAM7xbNbpCH3b8AzaNf/DVyfMIi7tug+xdB+pnPKenXPxcWcTcMOj+QmuTuJHgKW+Gt3FwMYOLnm/4pOIHholn9pyFwI4rosgFqaFgcfwbPV5fNB+hb+1lolV82QBiNLpsngUNw2QB/1MC+3mVDYE51z9K5CeZUl87F/mUzRtcGiDA61Ox3v4ZfJFL3DGmkdF+Bpa7PhGrQKiyO/0nYr+SGDj4Tyjw8+ichbRCFxZGEzWsZHhhVvfXDL/7G9/zq3/vKr7n2wtADMW9Ukozf5TGNXlmgdEFjSCOtSu6tuIiXdioWzcWVcggo5mL1Z5mrHR/kU0NFxGhBwcC2INegmBkdqAjYziCfEXl9ijUhGIAnh3mz+71QQW523w4J8IE1M58lkmVOm7fNCuj56AXbHOTjw7w7zOcUVRVMixznpO67e5nCt07aiYHAtOKYNT7MJ7DPjZHVMVDo1Tk7OxBsV8ERBWRr03bs+LvpDR0YK55wqI3wKj1j0LYgZKwbJDo6dDxo5y/VzkW+gvb6eXjZEJI1vGy+S8bJOsZBGVaj4zvCesxgKGGgdG/amq939IJtDCgCooSPrAxHutVODZ1x3OmhSE5ARUPkSBra3PxtDkWoi57uUMWw6OsJn8IAneNi0PnGiIYr9a5ihK0WqsAj509MsCFBQRFeDqV0hU1TKuRvwBcVF87W4ZbrcE0J163DLdbhVupwXQkncgl1vrbOd3lYKnSwy7dZ52vrfCWc9fJt1vnaOl8Jt+jl263zXazzXRmWCkHs8u3W+S7W+Uq4ZS/fbp3vYp2vhFvp/KM0atxJ7obfIGoMibMPIxjhgutExfN3KjnmrQ+/EuOh4o5ZsY23cmPTt/LIJm9BE1ZwrR0D+AGWCIMAwvsjtp+HWfPFz/PvV+5mzr5JPCrtH1Uhbo6bM9bU3pfGaygZoPHgOcNY83Evxyzio0cW4VuEQICqBgp3PBQmcVK5UucqyzKL8ZYavzMEaIgZNbwC6+F59KMf/bz7C77xo39arSR+PviDHF1v5fFogNUqwHWRJLBxCe5q/KP5xEft2nfnrWJ1defz0S078d352JsM0v0LIYK0ivN/vDBv5OM2coHbxYU//mbWgcXEAhk03sjbduK7EY3s3k5hbk2YIIw6L/aeevEP/tustTJWu3fGjHP/mxds9FdsyyXSsmNvvjQenjEQPUF5Gi/HyINO8Jk7RfTJYu9xrM91gpKIC8WYq7Zv21/9xkvj5oy5A5DEegy09XPrY+PAA4lsfO+t7l8IO5kzkNeZiOIgRH+9PRbXFbDRi40/NPvcI39l8CPlAL3q+aualehnFvLocbGN2bFRB2O7rJRqAmvetmbUUvErCznE74NKP+eer51z70rUneyIhaXmqE3MQKg9W+vhQhrq33+Ba9YTvvuFFrhmPeG7X2iBa9YTvnvfAtd74AK3eN8C13vgArd43wLXe+ACt3jfArdU57v8hRa4pTrf5S+0wC3V+S7fv8B9Ngmju/Kwi1MZOsroT1d+cGDqAqomwJnOSP8aG8hRS05vP8wmAYTN3x0nLmcRdj8hhF+eAQbmZ8J+97+WAbX3mbAK/d0TXmjeQ7yPP33G+1gtYvUkCZ8K/tpnwoUq/N9/v/DF+mf4aFVH+cysX9rtX8fwKDb5c68K9M1j71uOLb8c39h9v3L8wMlyfPrU+0X5X05G2Wi/X5QfPBllb/r9ovzQySh/rS6YWbHmyWCmCK5CjK1o8lSNhzTgOgg4qymaHwxmGBOSa2Gx8ctBH+/7H/3Xf+/v/vi/+r7v/N8uPR9AZCz4YCC2Zpv97qvm7kjCiUtYUkxcip08LDbPPxUEHwxiGxbfdX4xCC6z1MEHg4SGupCan9aiaXa/n6nwEfkXWmFTx3pTXjXHIDiEgd21TV24Fg2FEzrYhIveJ4ve1xXB1TzF+23Y/Z/CvIWL/OsfiwnhLJJwSdH+SuJpxShrE7WnCFxSdPvF62/kne63J1mCMy6W9dXbbzI/m+Ay0rTxZTPWsTEAwWwb2lgLNhYYKMrKsamQJpDUu/eSM8pEWzTdLLEx6hBD+Omy6SFNG98qoq+7bGZx+uDTBH6aKG8MdPYmpndsmzSUvWgClCGRqa0tgGB4lx8jNO5s/7KJURlWK9bthymH+Any5FYx+8fyDpG/ir/z1g/+8+BjNLOBbK18bBXhJ/M23jO/fKH4aQSxreKf//Rbz31swcX5anBGitnX8lb32xMYIyhmX4PgYkyBA3AKCbrV0SLHsk51pOQMNoYit2y7zwfX2X5GgcKXx40NiUqVFrO3kCB+/j1Tja2ARDRsC8Eatn3ZxLAfwluuTQQuLSxmb+E+W7RuPRkEMgShoMQhGGehS6Zjkywcizrd/yroFPfmcKd+YModG8YrNkT0jm1Wo7rpRjXHQVCMocLgYGYppijh4sgDzONbeUOglBtF9HV5YluYrhF+4txgnHwFzkK4TiNk9HU4p34VJk4W2FCndEa+oaYa3crDIvi9lGONLOBZbMip3sJ+EFtmZyChJlyuvNG/RURIPLY0buUNgVYL+Y4vuB3NfhbaBnqhYSEiBCg43NVim8QiNBZ9HQDwkGL3O0Iehm7leMe3NH3V/Q4cAFmLFs8OqBfMoYecbAaDEUJOwa08KszXwaARhyFOc5ALPcap7mMLeQi5Tony1RgzRfTJ7rcnSRHgMAxNxuBW3payANCuUdx+AxLIDdaT3R59MkvePbmxeagL4mZxA1UEIgvhMFMdLWRrem2QCqicUTg8rAtN1xQtzO/AwsgOh9OYGRk9Ta5vk53uZND5Y2F016wUi93vC3MsKrEuQlER34IsCtKJxsNOEXeDPOr+jcRGxf6vhUUCNo2lmaBAZPEMbUw2xdVV5WsMhO4n+ISGgnz6aTNx9wPk6zT0BLFovvUPY2WEpedjmFvrngd4EJoPkmPFbtTPx8R2J38W5cfKT09+uvIDhoZLMI+K3b91WjBgewT53nNeS+++8y7Se+C8S7ataUmu7Y++8+e+/7//s//g//rzK8ioDesk7aIHw3AbPxdAOjEo9g6Cvm13LyD/YvUADAXk2aY5nrMMnsWodSISMhFZtkTG2TCC7nMYCq4PWaeRSgYTEeicaLCdFwzaTMzomswSdRaMU9ocz3LFGHpYAIQeEYW3R5mmyRaZpskeEzvd2eNiFTN7QhCJnhS4oadEa+0SkzLZ02KDPFsSUb/sGcEtelZAiZ4TtbkPMCWTfQl+j8Psstgyz55XLKRlQTm6Iop5HxSVuw8xRZN9WHB2sy8Vm+jZRxQ46QXBRFoRdb1C1PU+ypqa7PdweYbdrg5ZtS37IVj2Erl9opcP7QfxyrcEnZ0rcN0A36u0y3DDaujQPg/nDt77SnsZ7iM89wFAGQUDC0xuAi37UeiyFdDrWKEtQ/sCIOs+QgyML4VCx4ftjOOBtuwHEPo5hH5WQj+D0AJ39zRC/x4XGm+DlxD6KYR+UkI/gdCPM/RjCL3oQvdsyz6K0I8g9MMSOkfojKEtQl9woa1t2fMIfQ6hz0roBYQ+zdDzCN1zoRct9+OO6lBQ/n8tevFPzX7/l/3c13/TCyVlGMT20Ah1R6nHI9RjpW7FPnUrFurhCPVQqWXiU8vEuq2ccF7cXot9g65OObcJzFW9xqcU0MJrDrqe6IKJs9RGhTNCBybORFsJlqcDBkycNbYyFwDCHdLE6FqZzwrw4BGJYlGtfHfMyPDlGJNnnnfHTjUECIUoBVlWBEPa7S0VglDy2aXxS5k0VlLcNPZUPe4IpNhVcMQpxTt0yZQumb0qmVWjyWxVyXQlmZ4mc1WTuV0ls+mS2a+SWXPJbFfJ9CQZq8k4WMbVsEpny6VzUKWz7tLZqdKxks6ipnNd01mr09l26RxW6Wy4dHardBYpwLYWkX9fOZu1s1s7oeoTFWE2CRlajJhWNWI6eFmGs5uPK3FWnpu/hiomLTHekMA6SqQ4aZ0+I0V2XAlxXyKEEMHlzfe3FrL3Ww5pf8shF/t5Iso6LmSiIWMBeGPIiSL5WDZpJzDlJ4r0ZUaeKNLXcqnuF07h4zhvwMpGcfdrocIzToS8fZN3bXeA/75GKAf3UQ7voxzdRzm+j7IajVKkX7s2T54K9gyylwW7K2i6+wbv4pj9+TR+Nk0+hWc3wthMA7R5KB9W8in8bJl81s5K8SwjdvNTw4GYxRhKmNv5LH62DaCbpdwStJfPDAeWyV3NgeoyC/znoQTfCvM57jEmn8eDHvFwGM3mp120a/kCM0soVHJ2OMBzB5Jg1MMwn8fvrsnP4a2PIBlMYjE/75K4nl9wSayFuWUpUNownxoO7DyUDYd4iEHFGZBOfDuLOlorBCiKwxzJwC6QfEHIc8OBPUUt8hl+PM2P5+XjKSixz9gZdMycnavcs3a2ckMr2bmn7XTlZqeqewyKIzCHNCtWkubEeBLV48egW7Jox6BUAn3MYisB1nEbMiwXlcG0ncjvjv7u6++B/m7h1+Mwbip97wR994T/MIlWut8Y2maxC/0Z7B0Zt5BeNsv9IZujubUkW6C15iQ7SxNoSXaO5tOSbJ7mz5LsPG1IJ1mPRtCS7AJNriXZadqLSjJy/iylo4vyZwM+EU533w7zmZpxPzPIYTFvC3DB093vDUd06k95qvLvDtsyz65EJUJOKdDAJjynKCVlbEa5JzNijGzI1I8TxpkeUHrKoNdp1HudHgpi8U3tKCZoMex3XTa/SM9l889ieRlLIOrvuQ/EvQ1Dk5uN2v1d4l6HJHIp7oMYL2zi3gR9AxeDjQZe2Jjxt8q3I6S75qX1TR591Utr03M/ID/GfVB+YJmQ00yuicpsxovmqmJhitQLmcIix1IzmRMVnHHhbB1uuQ7XlHDdOtxiHW6lDteVcIFCbbp8bZ2vYzLX+fbqfG2dr2My1/n26nxtna9jMtf5LtX5Ltf5OiZzne9Sne9yna9jMtf5LtX5Ltf5KpNZRo30WbErgvR8cG9SSCO2Z2zXXgBo6GnIRxB2ND8jcjoPAXsBn87jE+2H5w+JSM9Fu2AJWTqLU/EcP10UoPXttC+Zds+okfpUxHwwqVOR8ME8TkW4B1M3RcWBDJo3BdBOWOjbNyjQi7fknYNALpQb4t91fpgAZpZyb4Q4gcsTBn9dplvqRq7b6ka2O1Gt3FTsRby4Yxt0N/cmbu6R3Nyb+BAWf3vcihxDsQM7osVy9xM2kit5XTBIS7lCZ7MMLqou2ze0pOB27//LUG9YQXGotAOhwWBFsfpzQjsU2rQ7Fcd2FjaGin2JA2TXoDhyHuCjrElMd/6FjBYiHPgRjv0I636ELni8Mk74cqDlfiJa/8OD6kFnBzXZ+CeMNqieb3ZBLStqz4bFZybqlGCwL5IkYKsvlngw0xfLyw6sc8UU0Cl+fUHi/VHonRXHvxSAPa764vu/FPTVoCW8e87bldHhvMLHFt6GEd6GPKKAQf5tc65cYfFt07ZBFkf3j0J5vTgUBsY7UtRGsf5Tzt+lf7vy9+g/qPwo+VtdLXmxH2BINcExa+qQimVINTGkYnyIwZFb/6nT0rONYuOnlHnSpLd03i69Wz9V8WEYcRsRLT/t/FTFhIF376cqJgy8+867LBEPEBGc07d6Ni5a9SgulrXM5r3KbCSF/U9VZT741EiZDz81UuajT/llLo4/VfGOwmIIi4mJN4fQnKufrpILi++RkagPVY1izf/4ufnRj+v+xx+f8T568iTFhoQaSLBvH3tQME/FrNj79Gl9m0H4fzw7mueBn2e5UH9sFIefPg1NKDIfG8UvSjLbMoriH3aj6+jTVfvAe/xpr32+pa1jyYbFL80LD49D9s/jwwE9ZNNlTazv3xfmjZfGo3dbYqTnGtpzEd8fCOYkXdd8IroqvdakAaeuuK5LXzWfiG7I6Go+Eb0qA6v5RPQ6JfKKb+3auGjUXdf9xjCL8R+6dHOMa99DNig25QwGeyLFgZAvUhNtLBMlyv8ym0Wy+2PZWWieSZBzNii2NOacbRaHQp6H+pk4z9ug2P5Zt942iyMhYzjviPMCVmENMW2bxbGQT8NKlTgtlgsNMWWbxSovaNkpGxd7EiLD+qIhzthmsSYh8sLqNIlHp0mjmiYAz8ntmUGe2zM2G+Rn7Bmb31zIz9hTOMefslPWDnijOnVzIZ/CdWCQn7bTwLmZttP29M2FfBqMpUHeszP2PI/4tndzIZ/BVWSQz9s5e27Ai9T8zYV8zl7EPeCi7dqHeMezF28u5F3s0oP8ITtrFwa8nz10cyHHBjL7St5cYLi5m3kkrpmbeSKu6Zt4eYNr6mbeEteZm3mbkyCu9BYrkTl1zDpH1zmalXCFZzemuWCjBZss4MmttWDbC8KN/3ttGxcGU8etBkXJJ2HZg4b6QCz7z7DYqny7N4Zlqa/IOq1/edqfpsGiWfvDeRzfwdj8VIBZ+cOVqnPQkSh/+pQXBSqQ4OyTW2/ArTc1t/6LQfwT8nyw9MV4PqCrpzImNipi7yHhW2IT3u3gIWE1VB1zHDeAZCmSiBS4Mp7AFQUZG2/lCQSsMMyTV6Bs2/Q8IkmFlyN1NZyrLPN4BACmgcPsO8M8uUcsieRe1mS8LIUlt7V/5SyVqXmyYr2iqIGyYqOiOJiCFu50MYC6xutB18IlMBnkLduE4kBjmE8oEkFqx6huAFpHwQ/atjMQgIMGIULzNvUPEDceCFrBhB0fKCwCTbgD5yBh8AbFKVfoTwV72tKjwNHEmLlsbtuoKP9VeNl80jleAzTnZfO6/ACgwElSAr8gvGz+EL6InOV1Og/h/IN08rHkGp5nAkpR4qwDOCX8rurvbfl5XX5elZ8bsIRK0ce/EZn4jrlbhHzS5LkztvEAgmfgLqhFNOMTuicJvZMEe5KweJKwdJJwdRSaFELqeWXe++4rSlsGHI/GWNHYRQpt/8oS+MehUF9F/DiRhKJPkNflZYF3w9o7HnpCda9gyjWyFEvIapo3iubLhG5tUAt/NaXzIJAnc9GsCXX+CQqi6NOEOv/osqJFg5YQDiyaQHRnwmK5n4c8vi7btFi5ZUO12pHC1X0+uiqu3vPRNbgWjb1srgMvqGPTzk8modgX3VP1hQ1VXzgIVX0hFPWF10V7IRDlhWXRXdhX3YVSdRcOVXdhS3UXbovqQlM0F1ZEceHAiOLCphHFhaMTigurqrjQFb2Fq6K2cGhEbWHLiNrCsaot7KjawpraGe2J3sI10Vs4MqK4sG1Ec2HVjILTrys4vRXlheuivHBsRHthx4j6wpoR/QU+x4kKxTOi5PCsKEc8Z3URjFSMywgwPbWiS1kLE9VVLkVqO1V9YXqBUS8KvPQCblg0auldyluq4qoGERXy/TlCvj9DyPclQr4/TVTIS8PStoC5JvDaAPaxMRHaEkLSOwD7RYZ+lKEfGaoxRuAGVbDzDzF0ztAZQ1uGvjBU+UPAEtmY8PQO9H6Boc8w9GmG7jmx9wgvXzFh7BM+haV8aHAQ+dMMPeVE4iNAWMbE7k8gYG5TgOPbBlZEAd6HDAlXx86bQSUM6UzOONFHMTlTSz+KyZkanlxMztQI5WJypgYph96aj1MOxbUr0VJntx2euyO46tmcgLxnpwT/PZsXKIusJyAX2WkBssjOCOyrnGP3MFkI8JqdFbSPbFbganGY5dicEmBaYJiqAg8RbgGchYlB7ItrkCnB0B0jfG42QdTcbJLygxnBMJoZmQnAV4W8Yibg4VmH0oaZgFVnYtk4iyClBV7Fd4aC0RFUwtK0S6kS0ZGCwocVaqrifxNK3Oliw9ajqokb4iasirPhNO1helJBAIDkLSpmKPhIpimxqAURG2IZkMgmEPZVG45CqWPfTe2kYKAi/KQogUMCZUKQT0GdcKrqKWDGabRsOMjHnEI91FKxt5PaGio8L1BCYtowGw7yZFiDCVcmQFFa6LM1NRTBs4GljaWexY5ZbAAa1OWO78nJo23P26aWW/BbGdOpqbftNM1D6OcJ+TztVOyBQdrUmgi6Kz5POUSANiwGa5UEyNVoLfYqgGKvFk07SzUXBm9pcKkO0OBRxfbNhbz5DrRB90eq07yXw3pGPgvlKFedllYHxxtNwinbz9oZ23D1amm9bIK3c4SbcYgBs3bBNlwFW1pBgJtKuMawtuawaryqtGAb2cUbc/GmNJ7Usom2QLO8spC33gFAOyASvJPgvRyg9PmsPW07rk5jrk5TWifIhGlaDjdg1vagLuMiTLgI0y7CjERoDGsDDzt+6Tt23o67BCZcAtMugRlNQKrRwiC2HTt2cyHvvANV3MORanTu5R00wCk77iox4Sox7Soxo5XAOVuSbDjMAy52XuHG7ZztupQmXUqpS6ntUko0JSllB0j8eEd9ZeEdsFo72wkQgyK+FkH6ysiBmoppEbAgiyZE3SL/eeiqd/7yDPAWzVt5uKAGKABD/UDZ2fRlCeKd9Ea+J/p9+T2+x/p96T2+R/p98T2+G/1u3+N7qN9xmYCwGhbiYrboeafMmwu4kgqqIo0fbISE6YOkoQ0FX3GMIniQN7ShnDjDOjxuIc52R6JZie2OPJXLh1rvAJLponhhvwNwpUviXVTLGMtsaWfGQ+FFeQh7R/DXwmK52AlGS68lMSw5OISUkRSh/0Ql/lMn7m8bKpbfFJl87PyiBdR2Kk/loKNQsVG3Rp7KsGNFRJAoGl9RoXQdveA3C16QjTUlLVtj39VQ1z4yRIs+FfwfKwsjhU+s6QBgpvPZ2ER3Q1yFV/q8CQeLZmcFsrcELuI14aM8mUd6tNeW6ekQ59Feu2Kx6oWlqgOWte0dD24J/LHTgDWC2n6kxgvEEkFsTffr0ed+kJMB/lRHyzbOo5JYtOnKlV2wo9gDoRxRU3kgEmXyyr9Ku2+8ljkS7IuHYnZCw+DsyhtXFQQQVlKPOlSEnnMrykeGN51Vid0V0TFJXqI0NIwXdv8bkgjSZhOSbLJw2TQdLt3OCgU6qVNM1KnwtT45nred6WAGukqhzaAIuoCnDbu3Xaf9R+6yJ6KV/yj9xcl1Meh8Lg2bd6nHiofqvYf63skHHen0fYqUqLPmieh2xd1ZDSv2zlpY8XfWQym+wRlTym9wzJQK4HE9lLmO9MMr0TJu+CKlHBbRG1mrkONieKuIANAXFnfewNEUqrhEFmz0qfufiCxPLPaoleuUQJ77zbwhhps9YvdBxN6bJ6JHRdyH6hsMNTedTeiWGEmR7N8r652GYAVHxJDNU9uSyMFTwe5FIgibp4K/bgTy7/PhG5RgagBi9gHVT96jCYrduT6RjlNCDETSIOTifLJovklDBCCHb+ZN963Jb/3qm7nvWx0veo942iwpmiX1m4WzQouxO1cXxUVjgwj2QdUgnIgXsWCwIV4ibCLvB1fH1Y5jzIZAe3w1OZCjAwCNAJblNrB6i4D2O+segeXp+wZD+qDBkD5oMHjR33MwyNLgBkRKOBEVtELhgO3dB+OhApCO3FIhbdD5TMNMyAK/Gt4ii4uLRd7kOBBADIXVc0sOEIOAZILhoo/D4RtZuwjEhPmXsZ1+kwqKtA8viCBdKygwr/WLQxpqNWIxVMGgZUNnsgwM8bhKMu7Edxhrz4ygLye2I63R5ni2XUnXVLkxO0nE9B3MtDPErEY6pbJ4cX+DSprNIryVj70Ur2A4iMLJN7zB0Q7u4/GH+xXSSSitTeFRndE07DqUkqZU5e/brtwkDar0WwoLwG6OV1ZREJ9tJ/YzpFmiPkqjchQPSghFN19F3EFzKxsvgB3QpArKmG1DCyF8I5uQGHE+iWqzt4lqAp34cfRmhNp3BNVcu41RUDSKyI70bGK10zz0cPSkRlHDt2oU1gulvdpAlRuuVyfiFdehEl3Rxl2OaAHXv3XntjHS23ayiL6KqVT9q4ua1G5M5nQTcxo78EHUzyKtJaUowtf62pgKknJFj+9Y1RLve3Lyu3mf79EX+G4w19EOMdohPrHCPbhY61iEQkRT47M6u3/RhMldK1sG4i2ag6hfHH+pqnIxsNEZH0OhR1ohgcaNLmXbtNBrE2vyVDxGTSUDgRWM2Ac/q9Blq013sdpzl6otd7k6WZv6CZZfrsqx2vAJ9pq4rguIseET7A1xvSqQxYZPsK9bdyi4XR8KCEuspwKCEZvHovXweYEgNo9FG+HzAjxsHovK8HkcsOneDJ/HCYXurZD3tjSPpL20T7jw3bpsdgg23L3T+dy0mbzb0sMyFExEr0/UBqauRMcvQIZl5ZZKkMrjzdoO4KlwRJ3R1xwl9PJZIWwowcKMDwilEhbVxk+xqYSlfF5BT3dWcsPDYn1RqAX6spnaOVs752rnqdo5H63YaSua5JQcnAKYB89gSXFwWoRkiDE+ZZNi3xGAMw7CniMAaxyEXUcA3jgIO44AzHEQth0BuOMgbDlCz54mYdMRTqtugWgqgYOEIdWGLOESbAiJ/s2caOWcEl2deYzTtuVpt21Py6Gy3f2TBLVdEc5muSKczo0V4XyuryjnckU4mqsrwrE8fiGb6ogt8K0VYbmQczFD5QeIqkJSDIzgU+AMz4MzXJbvwGoWD/EOt+PDRdj9E3nyweBvr1jcCOrmPw3FHsNXSAGchlb6zkqeuHMa+l5V1Mdy8m7xUsExotzixQHeLDiMlGIHeL3gSFNKb4CHDA5GpXQHeNPAcFVCcyCvG8cvCAs662GdxNHHpjwhNGk1XZYInBEsec9HEepNOSfwZSjlNKR1bko5QZyOMk60z20IwmineUyPeellsIRhkiEh0wIHWA0rD9kY1/JUzh2pO3fgYATIu6adYqmq3akh20ksmyZLH+vZYkrstk9R17T55nuH0Z2qVXArD2Q1GEOJEFu3K5drtT9JQv4ZRI/nos+pHZqgToIaHN7KJ+QMEosG7ze8wUMm9PtwBmlqHWPJEAspDnzNkdxoI2Mo5W5YLT5OIe8V3tThjYSPUd3YVTfVxS8+kXHoH0beMzFUg+eRBOeRSZtk2NYm7DgOHuEbmfC0bAAd3ltiLYX1hMXJSTlZfoP0ecudRWIpgEN5BifJ623pxGZ1ypCe1ShqiyTWw1jz5FlEqzwmVe7WZxGJ7kzTaI7eWaRZd/I49uVxLJ9yFqn6OZJRKrWbkLNIgrPIGLg2kdyuWmKcQmZVw22Wam2kURvli+VQ0pCAqQRsuIDpaEDzWw0Y/VYC6nmlhfNK1VaB6pVKyYv1pK+NXpe+AsjTk4vIu7rp5FgU+FmSn0X5sfLTk5+u/DTlR+5DbOLwP3znq509boK6FNQbIe5G2AjNyY3QnNwIzcmN0JzcCM3JjdCc3AjNyY3Q+BuhXmhkMYlkI4xkI4xkI4xkI4xkI4xkI4yssn2wEZKf+ttr+A5uJt0/qSZCV2SjyLkj4mV3pXKuiVP4a+s1fUPpfESuyZsuuNs1o2LLQC7DtoVr9P2xSe6mdwQ3M6FEQqpsMlqBiHnefSoIxuVuTTYx9Mzy1qhERaSSU8cviMkP2efF1ofs/apGJm+e8sXKKUGUyRbl6KBKgjxOUBCc0usr+RielSCUno8DwAx4C+1XFmrDB1KMtm29Q+GuFcADjnkWviCT9pbjJa586fCPMHQbb1lAlBSxEJGKuk9q8+jHbLQg+1vrXtaxbCgISOiwSZVpuGh6eHR1YJ6xa0Tqg3stGcjij8vEC32FxJQbXd4eEF2KS2o+Bgw4CEe18Jg2WlNo4bQ9q4+sn1T9RC3x3Ji3bEermH7hKrayjquXSs97tpU6u1HYuquiXaljaPt8VV1sI6zBhACixiAQBv5bLlXuwuSxWR3XRJZ2vUkyOdzTum/iyllxVuLCXBWmya2cu0CDu0BI7om55W0ELWUymCLqc0ti/gCnqe6n4GbzThkqa2YrfAVmHGKqnD2IXMYPJO8nJ8hZtbInWNkrplnjJTUAVhfiAUVgbH9Zb7g7kwu1XksbfWKc1q+7XysXpp9YoSDRT1SN+ns1KhvzkzZVyazvMSa+27kDEy5V46auC/RYDNEBdxYm21JPwRANcOdfyBW4ky9kBfTMK3IG2ysiaHD8QtZVw0EyPICkndPi61GkKqfHEZ4vobuKd3hZLNZivEfi0SWmQAd0TmlrNGJXtOSMG/GMG420yl/GcfMtiP4V4csiXtiw4fCPvDEeUrk2xnNko4SZDh47Fz7BcUMGZ/ryuAHQMaZwx8adfzhpGnev3BFjE+Yl8nF7rIQAS1q1CNF+90KxKHruEJIqlvp5Ki1EKayGtBAeOfKmNhHxskSaGVf6bIq38Wxa2OsZz/QHEPwwFL3isX/PiO3apqiwrYhG221RZNsKRYHtEPCthqJXGRXfTJYLaiTvFVezh+SOn12kgguwCQxlrR5h1pCHMpTFoohLT7ThrmWPCTcge5yqMMAoMJS1elIeGbKnmDfkonBRys6Q9ZA9Lc8JGcVjdiEdZSjv8izzNtlzzNtkH+CFSzT2bmRfIi8P2WVWGqgFhlIzy8zbZFeYt8k+KNJgtPW7JGp+r2YfkreK7MOsPFAMDEVtPsIimIzXsNUoW7GhijWG9izGxIcgzfBhCA4BQqADNAEIFL2AR/YVGswt87Mqk7KACF+CCJclwvOIsMwIVxDhgxphQUxbnEH4pxF+ScI/g/DPMvxzCP8BDX9GTGOcRvjHEP5xCf8Ewj/J8E8h/CUNf1pMa/QQ/iGEvyjhH0b4Rxj+UYRf1PA9Mc0xj/DnEP68hL+A8JbhM4TPNfy8mPboIjzxkacl/AzCzzL8HMKf0vCtymI70ZV5OJgXVGdqfgnj8/RQbhAQBuPtY2HIsz8kxUoaupoEP1mA5OSRPxSRUaxL6SdxZViNb+k9qS15tgSbE8zc687b5S3qhvP2hmAfveq8dgjm0evOuzgE6+i28y4NwThid9O/PATfaI1YhTKE5nU0n9MZdV4MS1/QYWplkmY6YzgL1yKZ8JQBMyqdyCl9UcfnwzJLH9EZw9m4Hsn6sK6zcj2UadmVablnZFpek1m5p7NyI5LlZENn50Yos7Mns3PfyPS8LrNzX2dnGcniU+osLUOZpVYm6YEZmaUHOks3I1mqNo3M1s1QZuuiTNZDTFZOz7O6RnGabkWysG0Zma5bOl2XZLYe6Wx9PVvRNarAONC3YnbKtkKV521ZUfRFuiNrm8J7jkn3laW+PI/L+iG45/mErGT6ts3F5HYN3VliVJ9Sma4WUA/a9sMwDPulAJ/+CBMdty/AbHUBBOmVE1HrITSLqM8j6jKiXtGoH0TUDyHq2RNRq8E4Q2PFiPkcYn5AYy4g5mXE/JITMatRPY2YTyHmJcQ8ozGfRsxnEHPpRMxqekwh5qKYzRVjxoz5OGI+iZhPnIhZzbMuzTUj5kOIeVFjPjykPWE7aR85EbOasPOIeQ4xzyPmBY1pETNHzOxETMz8DoXY2kMKHJU1M5GL1MyQzMSS3EQyE3V96fxKw5i7oR5Bm7khUFVQsekUZdJUCLgirKtos6ZC6y1FTFcRIU2FQivyubXQb4WYi+wdQ9u9yhgFdJQMr3oZXqszvO5neKPO8FUvw9frDG/7GTqGuZfhaljnuBZ6WYqUgeS5EfqZlmGd62boZbsV1vluhyczXh/NeMfLeNfPeM/LeH8k4wMv40M/4yMv4+P7Mt44UWPj1dj4NTZejc1IjY1XY+PX2Hg1NiczLk/U2Mt41894z8t4fyTjAy/jQz/jIy/j4xMZc1Py6hj5dYy8OkYjdYy8OkZ+HT2Z9e2oyopvfrgm5GFmKKViw4oF4A9uU8lZB/4QNJW4deAPEFNJXQd+95lK+DrwG9dUMthqFqNYAv6aFoy7cNwRONLAxpQE/+XYmLvNOyI7FmBpdfoVq2GlYLEWVhoW62GlYrERVjoWZVgpWcgUWAZUIWGOaRorhc1DPHoVwYfCbUMAvMRdk1OKZEBwIYAJ6r2H+vIm2yQ3rOGk1GkiTwTU5Xwkwukki1w6Jd+cUDrpIo8uwUUWneTlauejVKNeKgXCENdnVwPaZ2iL6kJH9B7GRGliXM7YE6KuMSmqHt26Ti2tldr/9SqzPByo4V6UiVadO+JZHA7UcC8qMRyo4V5UbzhQw72o9nCghnvRHsOBGu5tiI3o7mht6paHhdxN/Ha0u8a0B8e1Uye0nye167syGLra+JOu5Se02cerNh/TBu+41m5rU7fqE4YMhE5nc8xMyKsmWCZjFwORXuTIS+qRl9QjL6lHXlKPvKQeeUk98hKVKNuCkxJKRfBlvurRm3n6weCvG5uS+U9AQ1zBIeADFhSkezpk7AELMXoHJu/IZP9ggFELYX7edrZMLa2iPZ6QnZ0DK8Gm3ihusOPTevNMvc0zrTfP1N8803rzTL3NM603z9TfPDmKoTBVP/GTPWmT7n8nqEACdk7kHnlBFAgeviMKzpy8JsKzEeY9nFQAVhTmp6mVAniiECq2Q8ULWoDiSlkCthttAB5U4uTAyC2jzFebX6OP8d2JVwRKfEFyJJSGVykjiu02it6bnDB86UyhZX3C3xz1156oZGFoqyMLnWjTeC3Mwx4KZUZuhy6SCKMhhlhDd8JQiY24boGNdbaCexu+koccCDSiOQZVVrzVYNBIK5BZRLm4qSLMJlSEy01+lSaW9X9OeNNddACX+HllYls0PZfx0xJkCY2OnnYtLsvlJAvQz6bNip1CeSbQ4N1CgHubI40+gUafUVGVcS2SEzkDH4gjF4JiHUHUQs+ARaqmSW0KyTL5NkJt3kfVXsG6I4QTPTOOnhm3M/oIJj0j+VelYrEE2Svty4XF7yrI4+Rt25Ukpm1gJ6v5Fg3zSOTeJiG4EtWKrbosxi8TVizsZxMykrMFGdzZGRnw2WmZA1lPJkY2L3MlOyXzJyPc1e3MiIUjGQf+VItggUamGpxuqjnyupLdVHP00gu+WZO3XPD3m2p8v33wdGv7060I+Eh6csqpDYRqylX+5qi/9pzo2AAdG7gJ1Lx/ymmk+6Zcc2TKdeyYMmS/15hITHOvRmpYR1nllCzaPN13Dwoqh0zskWNDeKqw4qseRdSoMsJSpR6TEa4qNYGMsFWpNCPi7DFVS4zwVqkSYoS9SqOaeHfcgnxssWP65NfGym8NnXxy7OXPsCdD/amOV0Z80/3p9SvDPJFztLOxzFWI9om7bzhpLO+9wBSrEdpqIzbtu607Cq86qYCpXcVCnVJ402lFLJ1R0NZZhWGdE2BVaOfrZjZJA2R6fJkgnxorWCzHFxw4aPRtiQeOKfHg+DJlp8WD4wseL+nB8QUPl/Tg+IJHS3pwfMGDJT04vpxyPGcFC45wHOF7QPeKSFBNXRGpqmk18T6jBuBnVSJrTqW0Tl2JbotJ9d2LmCmGyzNkkyFASlkPSlVQJoAyILVwRANiAdik8GjecYIpeUueqRKsPm33MM+XhGotbcuzlbz7A+ew+SbCq5hiUxa1dt8TIKA0RAeiAR23X42JhRCRLGHOKhk5kh/eImWdVNkAHACyhpMDkQbs/GrTTN4d5ywSuR8byL51wH1LryliGynIp0uRG5sZQRAASp5omEy7Q+DMPXB/AA7QxYMf5H+6wulnIHgm+JZsZ0TQHg8EkwzX6+fdKlyvn0+NhKu1SkXBFg8Iaa1aqredpb5oAMuZXonLfdEDltO9ElduQRu4ULkj+dVPuwH6CyrT5C8oFXYseda/Rk6DUmHHkkf/62Q6KBV2LHkTuEHugwAPfFTFGVFJO8nGHeTTb18R7FZgqSQCuuKewTGU8cY5ByiS6SuRGn3TABgKiN1liFMMsag0yDse8MVVEKxEPHaHq8R0hYLwG5DyPeIoIjwtoQ+OQ/nd09/dsAY+2PTc3yVuZ1gK7q1QLEvB7SxLRbQsdVeYRQRVEwuU1qpUDN7IByJy6AyoPxFdH4iIYVNGNqBvB+DFY+q0lPLqIKdUnU45IMsO8B4AG2Adpdwe5AsCwDimlNVwgHN6AGVAJa2Fg/zcSA9h5AG8ZZadMyGgN1WvzEqvnEevUPCB/OjZuldmtFdmCS0pvTLztiBAcTbNiJz2jN8T/0n6YFo6QJp/TtpeWn5eml0avSctLu19WhpbmvqMtLO08oI0sTTwWW1dadtz2rBcf6JilbIUa6LldZ/9GyLOCuJFuGh6tIUzJMCC6rFR61pOv031LQ1HTeJo/IAhvFh2JNbycNRATh2rOxJrcSTWynDUXE4dSzW8RkpoR0pYG885WcLeSAntSAlrUzonS9gbKaEdKWFtWOdkCZdGSrg8UsLazM7JEi6NlHB5pIS10Z2TJVwaKeHySAmdCZ7fNA+wg0RrQAHQKX/XxtsX2cbb94VhdEdQ7GPBpU8ECB93rVD2W5G/b4qr+TyRHgyBUHoCXrMoP0vysyw/V+Xnmvxc50ZbqU4vrtyDBXJogCdUb85TYVHQpAjBCfK4VBuCkA3kZ9v5B8a07phvsCowAKn1rEnx9myMIutZi4LqWZsi7pCusKGqDwDFBXy4x4h7G+AygdS7UqFJrSEQiiIPgGGQp4rMkXrgsqk1wDcyHqmhtpixhqYldHyvwi3AFxMOZmQkkRI30etSlGVpIGNTOTnY1JoB3mcDG7Otb4urSeQguAQ8CMy5HYiztMGJgiVMnoYDZeYFYOJRibfJ0zC/r6sfyERg9q2Gnb/WC5O7xdG3maeC4KV45aGgKLu38uBiUKz9ZiiSjuu/GdI2TLEBR3Hc7n5nmMXF1jcb+b75zSNww0Gx7b7sOMeec+yeDLvvvhw4x/63qePwZNiD6su3Gd+cBcta/MjZYro7TGTYbejvOn6/84f+/D/+3L/9+5994Xlg8gcf/bmf/PbPHvzQxs/82N3nce8KPvqnt3/wV3/yz/741ru5rMK//2t7P/mLn/qVH37heRiwD4rVR9nqR3AfP0L3IdxH4j6A+1Dc+1TwEfce3Pvi3uUjQAK41PWkXyvcf33wLb/x//zcDIE2YUu22I373T+jiFE7sfxu6+8Wfn/iV775B3/0Bzb/VyBAw/89e//4L/6LjX/0KdSmBOFf/rlf/FvH/+yXfwiEDWS7JcVfZxHEvQZ3Ke5VuDfEfQy9s3WtLtxr4j6E+4hor1tx35n3+7EX//e//53/L2/vAl/XUd2Nzsze+zy0z9HZ8vNI8mP2tpPIiZ2Ylx98gDSq7dgxIQ4N4XH7/RoaSnPPSVvLmNTcKpZCHCMSQkwIRXEpHB0DMTSmhtJGpQQrCRTzVkMo5tFWhRTM4ysq0K8mlOj6v9bsxzmSU2jvd5OfdWbPnpk9jzVr1lqzHpe8+8+fxA3GOHX/rJN2f8bRYvDLf/zm22/707d+H7054/CLafy+ZfJnZ75z+pEzeHEaGV/9+g8Ofe/o4cf7NyMkgxh84t2PP/KNv7jri/2bcZsizAx35STSZzh9nMKWcLqB9GlOjyM9ZYeN9KQdNqUL5LTWSYbRv+3vZm592eVPFLEKk4jeQs7Z42GM2l6fU1pYsPv01/s3g+UXg9/5yJcO/fBdb0Inz+L5Fz9/fPaR73zo7/s3Q1QgBj/wncMfuffYF79Cw4eL1CN9DBtIj3H6NNKjnJ5C+hz3dhLpWTtqpM/aUVP5DvRzVmVG8bOvP2e3+mgJozij8Pa4SkfRQG+e+sUHvv25f3nvD/s3494uHQ16dwQZ577w/vf89dQP/pa2BjJO/Md9o2/50iNYlFE8f+q7X7tj7Ovv/iQKnINoZ4r7PYv0JKfPIn2S0zN0x8TpM0g37PiRHrfjJ/+9Pu0NlQGud7/zzrvf8Cc/AXCdk7Q3ZGZv2N9J+wvcN/jIez742C8e/taj6B2Q4OD77vjgE0/96cf+hjYHMuaeHP/E+M8/8tV+ssYSZpa7AMxoznIa2NHMcBq+28wZTh8A1HByLzrTF6Nic6RMG0Nm1uIvHvvNtz/vg0/RxqC+nxVp329IzsbBj739w0dO/vPEN/r5xHzrz6ZOf+qj3/pqP5+jX/vLL5+b/NuvT6L7A5nx9dNpaxrrqAswjR/nZB96w0lwyGPrrK9eYUbXWT+9wpzriw92c6azxoxt2vMnJ370e7/95u/2E9tMIoHgjZIEHaflzdDhrFlMJlMLPWmOPw2FUTqw8NiwjwV+PEmPiKlnPWFLc46yyMYOJUbnuMJNXGHMPu7lxyP28QA/jtMjhIFxe2Qw57AWrhmPj5IjyfnzVjV49M+/gyhsT9BRcro9Y6o9YzLN+CZlnGzPON6e0WjPGH+rGpx8+L5vvvvOD32JMo60Z4y1Z4y29+Pc3W0Zs+0ZZ9szZu5Wgz889k//9rezT03zIdueMd2ecfrutq5PtWdMtmecbM84frca5OfPf43noz1jvD3jSNrGkzwf7Rmj7Rnn3tKWMfuWmEyY/vQUkwfzcmbm5ZyZlzM9L+f0vJypeTmTSc7ofZxzcl7O8Xk5jSRn9oOcMz4v58i8nLF5OaNpy0c559xd7Tmzac477fwkOVO2PzNpmXvt/KQ599j5mdfO6bvUIMHQ8ck32vmZlzM5L+fkXWrQwsConZ95OY15OePzco7cpQYf/su/e+qv/uJzt9v5uUsN3vHVTz/6g2O3vcnOz7wy5+5Ug599013fP/qFfyfKQ5jZO9vLnL1TDR7+1zMf+ubddz/NG2pekTOZHKJAp+9MdtRpbvd0e5GpO9Xgm9/388Of+Kf3HqKMyfYSJzMf5kaOtxdp3KkGx79+pPkXp07/lPdUmvEfvKfutEhv7E41+Phjn//Zp//sL2+juqPxm3NvThuxkxBjysab1SCdSHd97e85irFpBLW1AiwCvFgIH8S23y3M25+WccRHZFmXtv4/QWukBKnydJ6lyg7H8VTBYcmyrtN5UuJv+BR245N5ElWN5WqR2qTgUwSmJR/Hr9qkJvntNAJcnMykH+T0eJ6DYyA9mefgGCQEs8ExHNPIc1h7h+MOVDl5Jmd9NF7mzOSsc8fLnLM5y65d5szmEtYMt0M55s0g4LIMHqRbeebTcHWS38ryX4QAxNVKLiRjnMlcWLRXLT6Vy4UluoLJhWWKKpULO+0VTIVbYiWZMYSmRj4CrpsjdIMK27jLnJOUM845ZOZzOte0SoHgZ312WQcPj7rD6hj77LWxwo7ICnAZRP4eGw14NhNsf8Pr5Joqe7cKwjwLm1nIwiovx2XoWa+kOTLNQeA6xS5HoVs4BgdUObpmUdqD4gYuyn2yQmqSi0BY6eBSYq+G14ciPFQFOg/PaBNQpIQ+ELzI6Q4839BqXeOYaTiG9v/VU87ISgIx6zY5ay+mE8syM1C38tzYjizDThZSy7NMbl+bb7Q0jHxXmlySJqtkfOhlIut0cGQdnyPrlOi2huPLfFJa0GbZbKG2SU2lycl4c3DWNKS7JzPpBzk9LlMJ8KRMJcAnYwmwaUgAvMPC2KjM5nkki4WcYoAfjsioQq4PWMOYYi2u5LiIBY7XuIpv/oocwnA1FjK+9csHH8T6O/C2DLFJHku7ujkRaTYCzGta7FXNCcTvgex7BRZ1pc41J6KITQPziH2Sg1kKNODZ1/Mq5BSaDThGg/R8JWqtOA+tDThSK9BdY5Vip5S3slenbljiN9mRYImt93AlAF/6PbDHx6sleLU4thWAw/1eXYX663Jo5C+DRj6bHcA+t0LCFBdyGxKmeOa0oC92kvNL+vIofvVW8IMuYhDR1W9E18EupCwz+C3QtbGLzTCtuOEjjq6EXVqHgS6Gi3RnuFiH8L8fLtXlcJmOwuU6B9UCuuVMQZ5uvD+6WgUjFwHkZ5bVo/xa6PSMBzFapUiS1Zsjn3NJny9ghfdJaC/kzWxnTfs11vIWUS/roEYrrWZqtIrd7K5ukj9XX3djLXp0b5P8vfp6NRRNVupuvpnka0Tbw7zpq4WLKOwBqbWkJnDhyjS5Kk2uzvgcSJM9abLXGdA+hpPLDOe4tIrvki16JqF9wePKWf3FtXwNcxGcQucpG646ndShRNUaOPQ1cNsD3wyrdFVf1IzWNaJV7KVhta7qtc1ofSNazYpTJ3P8AQ01nGit7iVQgby4qpc1o4t0jwUrZCxtRpfo7gbfSiG8b1jiIYQVrJyqRx5rtSHWc6QYaxQvc/bi9usM8MhZWYsW6+I6Z1RuJm0bXM4tQcYYZyB5gNhqj5jiIu5+mAsKA3jcouiXdJ3YYgS5RpgjkkOAe7Cx7NIcQ5AudegoLrPFUxlS1BX4GQg1fgrhxfjR4aX42RJeprv44qwIkFnaxEMVDwg5h4eNeKhGpLXUYcb8WtTBN6uwHluqL8amuxTb7zIqwc7kA3pXxbsVeKftu4CEsAVgxjEJ806YkBU3qUN4KG9So5S5SQ3z4wFcGMKJO/3cjB9c0MKfe4FUiGqb1GsoOYvkDQiMQR7b6QvXcSN7+GcnN/JiWL3hq2Uqjzf0cdsEdaDAHSiwH/gD/KUAr7A8NOez8JxizsgazX9wUNPFfbryM6RF4PFCwy2Vx0BQ4CRxvtAiTZa7x4fiJSFEzG94MT0SulJmWhFgCTZzOavYzmXUCTfQhNsIb9b4bFaxQcuYEz6L5pwNcWasldk5xZYrR5xwk17MQTqWcEQQj+xZqhzsDvpOVWyVpVrr52Itn8e+SDYRhtVNLhLgtn+FvpwXeyMKPItNxfRSLqIv1pfi7WWovoFdmUTL6C3itlPUd08HCJvpYe0DfirxEyKSebw2Z1SafoLTU6q2SU1zGsfu5zl5BtmnccadVgAH+sonJbc4ZX8nZdrcx5EuWWBERRRYkrYVpEVLlDytahx2vkCAUQJRYK+ySRNgqV7G2LUEFQb7hrD18vTNFkwvWVuUsPmqekX85rRIXi1Pc6fT3KrWce6ZNHdpmjuTbUE3o+UTjOKW6aV6RTOq6uUwzmlwYdJW53YntM1En7Rexs8aII07X4QGKiLG8VmCTNJM5qt9pTutHIqUQjw8kryIdD868Bjwo67pRUkMNUZFilER2XBtYLupy2MlDobmV7B11kYG4p0MwzeEm0hZIKwi2JGXnBLLraP5pTjoSM1PIIAmaQrwQbEckYa7m7oXoSiJ1OHzYjmguBenZRX5FzPqn3bssbEUJ+lqrKDu1s9FseehDd4Sm+OTZDUHc0OZy1FmI8rwrtjCh8symPmswjf0pejGZejoBtb7jLbyRxvKfrQbFkAX6x6KnHmFXg1ToktAj+luvQ5WkeffNBrRFfAZ1AsTo7U42nXYiEKMBlFz1iI6c29zohFFzYkJe0XaC+S9gsou18/WK7nqaoq2uR4mk93U7rMxVREa7+YvoyNrGtEabgnD6QGW1/iAXq6fo1fx91Y2J3QPbKjW0acb0XPQnTUIDl3luhgmMKkd5hYExu6hOJ804lUUevTZCF2NGY8w4yFmfA3PeCMZyFbEzsZAVvKYVlPg0OfA5nQp1bwcNTei5rPimtzxzTBb7aXwoTSGlRRb9AoYp/LqRFidEKuzJq4p4tDUTDNJMxPYIEjSnOEkBVeYDsIrQDF0cqQjUDKdNnBS3pzmZB+oEk6uQ3QxTq5HGDJOXnqeJjvOycsAipzcgOBpnLzc5MJOkw874BEHhJZkSop00YMotFu2025Z7IUVdn9cFNOdNcQdRnDYJlRtjkNfnGIzXNKcmAh7SJM9WoMJioDEfWIQl+uL8LaX1H6itXh7CfbPUg0YC1fqi7DWa/UlNKPr8KIPx0M36biu0hGgJEQjehkiMSxlMmI9vV6tL8Gkr0FbbGG2DEa/S5MTJKzqTpO/mdxozgg4PcRpCRU7BVsYqJydEbWwSFgkRGSyvhospYFEYYJqttRg52l0LVyiLzoa9ulLjobrdHQ0XA/POuw0T3s1sg9YSSczEeTxxArs6RzpA9D8kDfmqp1Pn4ocl8AV5PIGmz1HCs6Wp2GPEfmbdSd/oTv2aBMp1qy1CEBaanglU8Or2Op1td038dsqv302v0XQjU5yraX0iqN6LaB5DfZFSHQYNuElvMHWNxuY8ovw8grYONLqobxGEIxmozFBodOVXguEtQbYLyS7RL0MRzptzuWIt9HgeOzK0tjcsULUzYtIsISNzbS8pOkpRH0MLgSm685jCIvEGRpFtLHJmCu0bE5zgsPPL2eIC1HDRzvP4njzepnuI+S1xqJAeh2cx4KNhu7mb3EngM/t3EVr8BVqtZdBrRD18LmglxFKoc738hCnHHItGe8ouNqKT8IVqTWW0mTEzFGV6DTM6Uuo09ZxURU5EeeAhUaVJbGTNVY4YXXIinWaJBrRZVwVrhX0ojR7HWdvQfbiNPvyrVYLMsqxqhxnX8rZIC9ybJTO+X2cP035QZq/gfPPUH4xzV/P+UxkxHZ+wkJ2Z8ztjXrg9vTG7Mw8KzMzvLIcaipzyK7Jlu/Jlu/Nlk/Ox5XZ8quy5VdnyycHTTVb/tnZ8s9Jy3cYWQ874AwDQLsMXPu/RWrxSIE0bMuW9zONYo0UW1ysQKd2gjeD+h8t1LSzztnIPJ6zzunb7JzLc1JvdmZtsrrZOWuTwWZnxiYLm50zNombVUqSrdMY6M0GN72H+clxftrJT0fwZAbq9hrPM8cp44xILtY8M1qkGictQ3qOGzguk67Cm+UsvjTOJU/bkkf4cco+jvHjJD3KDWKmi9RNph0rz0CwggAaoGZLbZNCxAuarKgAcj9POHmNMLNF9qaTZ24VgdSZBkeaPEzl4VrI0TlWUCq2qJBw7kb+4SBPLCHMseZSjjWXcnw7m+M4XblsEzdw7l7+OcA/MIqzrjHo94j9Hbe/MK7LNtKw+Sft76T9nbK/p+3vtP09Y3/PtrUzY/Nn7e85+zuqbH/s7xH7O25/j6u2/tj8k/Z30v5O2d/T9nfa/p6xv2fb2pmx+bP295z9HbXLMWZ/j9jfcaetH/Ddm9+kJpH/Jtxzsb4HVvlbOQrJ17FJPcgZn3Mow9+kjjsmT9LInDnu1IJ75YVaiSvPr/N2mD8V6XgGVBEIke/iIlTtO2pQiLXK+aQTCx94vnkWHAWWSMAU+VzGT8qUdAebRi2QX923UJtuLSwS/siZ2SKxTrqT1GKhA434y81YtMR+wwpki6w4ylOe/YcVyCZZcZyoPHsRK5BpsuJIU3n2JlYgE2XFsary7FSscBmOK8XRrvLsXKxwGZRzFMfLkmZ8kY30Kc2RRTYypzRjnOzFPf4iG0NUmnNdlFyhpZntsnFDEX6sK1wNB9fkrJt8TBdqupt2uC7UyN0P+KECFBtX0e9e8nJCQ5OgKgpk4I7oWAWyP++hrGnFkbIbsQty6APsgM1KRsrY/mHybkiXPLBiwenerSV1w5ztYrItWtmciHqP6u5jUfV+SH2IXo9WvIZcOh/vYtHiUd2ru0HR9r4fXFa1mdwRNI6Bv+h9/0RY9XVeVxE4tDv+aP5m9mgaGzHzIZPX3RhRge2a7fJSFts02wOKs6ps5mwXl7LYwlnbtaWsPjZ6tktLWWzwvLHB0e9It777/qhb9+hu3fOa3rBVq0L3bPvrh7/6tX8c/sYLb4RJFdxNRmXzpLiyzEfeNMyNPDu1zLQQMHu86OCpp/ONrXw+xSCB3DPIPcO555LcGeTOcC4DFXLPIvcs544lubPIneXcI0nuOeSe49zxJHcU8zlaoNyzXVCVz5N8plGEqnx+jTBBPSrzUU0OwiHHBdqh0zNfiwoIK0yXHFBZLtDq0wqBbPNp3WIBcBWWIQUiZXlZC2SurEloHuVoqbgkiXwKZLYs6ASMKrREXI208cUx/g6k85SBaEfdrIdPGvoDx/ixBFkEYYMmv9jZbFjbiRK/GJXH2AN2R/AWCUtySKYqTDvitXOsxdSC6pxW8eesQcCUst+zZhyUOaaaXBwB+OxHc/ajHFejjFvGjuBu2HsGJBqlkLOM57zLnMkS3C+WIKor1SKL6ZKd4SF8cGRxXSZ3Os6tZnPPxLk6mzsT5/Zlc8/GuRuTXJh3n85jUTtj0gyROKISnvv4eTKPpeokKg3PJ/O1KMBz1RJUecjaY1GWh+voaFEi6fKsCGwcxM6RPBmJoScJPTaWJ4N99DnJG83DtIhGl+Sdy5GDX8xDkjebI4kyZizJO5vDKGlu4zxIlydLm50ZispGNlKxt+h+iP2wF3PA/8epADgEh6GC/ArAeJ9fgEfI85uifTPJb8AlWEjK2TdT/Ib4BH5Ttm9O56z7TLqSwJuCfTPNb84Ke0pUSZSHN2ds35EH29k8Ms9KzoQ1yyJbcNbmBXB0avPO2byqrhIng7xRxXkajsJs3pjN69NV4pCQd8TmbUR0Mps3rhh3aHuhAyjI4e90vsbUfiNnV9qrRX6yNuM53P14ZsarRaUk90gOF0CeOePVokoKF7latBRNerUoSCEjV4tgJnnaq0VdKWx4tWg51tyrRYtaVt3b7Mx68arTzM16yczZRV6enTm7vMuyM2cXdml25uySLsnOnF3MxdmZa1vGcdWyjMcJ7A6kq+iR+kPDuoGwywicQZljmXX0oFpBn5HpQnqsK2GdRNiVxLFEmQ2ZLiVOJYZ5mVnLc3SFwyuarOUMWZynq3iGbvDS9ZumC7x05U5LrFy6ZjDJW6bT1YJN53I9b51OynidyPKbKbID8TItZ/8B8czQMi1L8saSZVqa5NG80DItSfJoWmiZFid5NCu0TB1J3nEZL5NH7oUsBWqXySMvQ5YCtavkkbchS4HaRfLIwZClQO0aeeRoyFKgdok88jdkKVC7Qh7RfZS3JbNAFOGCVyleH7sye3FbY/V1PbsaN+DaiFKvQPBDSu1BuERK7UznHo5AziEQSsyrsAYaX/VE+Xm5RxxGvHTbSLvVYex8VtqMs4pR+PGczfi8YjxP+kxYdpWEd6ez+DjtjE3qXIl/+aZptpTcNDVUctN0rpTeNN0pdXuv2/uLng7U8VV08SR3EZ2b9ShJx4/tp4670mm70vkrdUUwJRYrLTO1FustM0UXqy4z1RdrLzNlGCswM/WYGCfJdc7ZLosAyxC7vM9XcuRSUpYoxGKX4y7ighVg/qpIJ2dLLXgTlLvF8wUsBLhIcFcWtE/mJ8j9AqLezjoZ+J7EC8hKEJ4AFj/nnAykT9Hbk/ZtcSsMLFKYP01vJ+3b3FaYYqTQP01vp+zbjq0w2kj3wRl6e9q+9bfCvCPdETP0dtq+hfmPfduQ0KiZsn2cJKWgM/bpOGkFnbZPU6QWNGOfTkoolU3bp9MSHuvOOhQdIvWwjBjgnS1PQctTueWp0vLUlTy9ukzOdKyi4B180Urx1Scdvrd1cOmKQEWTTi3iOITkcrFkA2CXbUjrThukumLDTgcc/5mja89Kjq59zkbXHlUcXXtMcXjtI4rja48rDkExJTnA9mnJAbanbYDtMzbA9owNsH1WcoTtI5J53HHJIbYbkkNsH7chtk/aENuTNsT2DRxi+yYOsb2XL4EO2ADbkgNsj9kA2xs5vvYWjq89wPG1d3J47T0cXRvuYz0z61idPIF4jS4b1uascxmQ01DYIgczoKKjgvUuQ0R6NSqyWSlRzVGH9TcDYjnyyVtTRhJ6KRQJL4OS1npNrWyAQt/l0K26QielY1HpWpS+CKUv5tKXoHQfSq9LSwf2hm4VSq9Gac2lQ5SOUHpNWrpqbTKrKN2N0j1cuhelV6D0yrS0FZRzgNbFKL2ESy9F6WWxTpgt3WftM0soXUbpTi5dQekApbvS0sxGA1u4bJE47rKd4hGXbRLH3DBHZ57LpornnDBPBWYdBJM2px2omZXYe8AULaHPDwTwusNaB24lAyhNXuPFMSAQGDvB9pDNdifI1PMYsBIsosjdGFvmUqxq8IIcafkYhaIlv3HwPw5O0NMC6NqGmxDMCeZ4sRW77hHMCXJ0XfqK0NZxX55DdTe5FDGAHEL4GHNY2Nzg+zwzUwCafpcj86kJsLRO8awdcAGp9XThwv4bnMQ22GWvEOx5wbPZN/EVWwPpvcSGNJrs6I7hXlg2kr3EcYdddljh2VsKLC5TMtYdb1yHvckldYJMncDWCbhONanDbueSOtVMnaqtU+U6OqnDzi2SOjpTR9s6muv0JXXY90VSpy9Tp8/W6eM6G5M67BojqbMxU2ejrbPRb5RVecShwJ5XkqMPabXFhHXFFseBTyPAp7Hf06jvabx3Vq2WNhqXsGE9bcs7Wala2jhclHoF28hKG4eLUhSHi1IUh4tSFIdLMMokAlgw2rR2rpLDcx6xacTnHLdpBOhs2DQidB63aYToPGnTCGk4adNT0trc0pFAwcwFHwsU/Fvw0UAKXYKPh61kAMdHBPFVgo8h4qcEH0XER3H/FfFP3H9FfBP3XxG/xP1XxCdx/xWF1+b+KyLNuP+KnANx/9VWMiTk45AcHnH/FTk84v4r0lLl/ivSXOX+K9Jm5f4r0nDl/ivSeuX+K9KE5f470I712bptzIkD5+To6nrLzTXexfdDUZFUFb2r3QGT06rO0S/zRpI7f6eeCYJZsLEJAhvBmR3I39+g3cs/Af9U72/gtGefUzaWQCF23OjqPLkvSpqhRqg8eZyy4Sls9ADVEhqrUnIoKgDVIZUAyW7vM5lwuCTtODw7DpUdR54K03AccqNUgKv7m7PD2cI/e/nnuLy/ASqGx4PAnJET98/j8Kw5jiPoUnsOt8fjqrSNy7p87IJf8kZUuZF2dIVu4CuILMaKBFbSS+FKQRTDQwM5hnMV5s6NBO44cxSICM6RPErB/VMHO7lEsCbSnUII87ACJ0uYK6gMkx8yxJ4Qybzk4tgTeRqAx0DC9AqHaKEgJmiLknvT5HHJaVqNbBjDYrzgTuxoLGk4aZaXEJVYwB37GQt0ZSIM/AwB+9tlSUPk+Kz7wbQJNBX6JqcFtEQ6dPAejjuVM+7VNKiDiONKIcM6bdhan5xJRQqxIpUuWzEZuUSyk6R2lUUSnUMYdaX1tZWnrtvopDbwCXyWaofOxNZsGpfiWBjET9pIGp2AlqQtxYHX0kp+7ECnktHutvGVqHPebvJpKHmx0D+PLr4w0hiefd7qXhIeq+sYi6bh5yrxUsWZtpMIPZpOPkUc5lYSPUQqjhArbNc5EhJwjlzpb1L3Of4JJXPDmXO3yq6OFDm72MPe7z16YHfNQQRDmQn4XqhSUBHQMPJY/Mzepay3Ew+/r4BfTaJlJDUD0wxqweWD2LXkTfzMrqis5xNq4Ya4hXE4KkRiWlp3KOcJJUTk4JjwkoknS1ElB7ayPlqorZssYdWgmOHU2Jm4sfPEFrdw2raq6LqOGxh1juFAb50uChQQ+5PWdtLYoXSfnTV2Kb3xP521gDPHZJO/d362GtxljDrtM81bkMybPBY/E4HmMnXKbe2BQ2VegngiuaGbkkkrxJPGtK4l2oQlcuy8BLY9dt2cXds+2+DGZL5EPF+CoG650GK9WEz2beRHENZtWvg9C+fj7xMltZRN34J61AN/arCagtJYuASmIDpnRnb0hksRB07nKb1Mu+bAEKyFQojl3d81aj8csrD/WSgNhr3YzftDKET4FKluCKEjsRtXat+MvE7na2FVFxHQvYIfQfFjrAfbxbqsl9IdY6jg/9MZ0EsQofJmvYLUyMjfcOVmXcZTWNIV3WGcffFzJz2r5LmLnmXynIl3tkarUCxo5KHhYjJ9XJsmL0qTUZq8OE1ekib70uQ67cfOCNfRckerIN3cAuIfHGyIpwP81BetxhPU6MhVTqTxeE42G+E63aep4kYK4QEzjCbCehRJ/a6hqeQsSvZBeRZPfXHJm+KSx5OSZ1HyEuig4knHJW+ISzaSkjMoebGOCNa471XuXsB9fwU/ae77uO37Ru77GdSO9EX8nSD+zp74O0eS70yj5EV6LZcsxCV3xiXHkpKnUXIttPXszQ2XHIhLjiYlp1ByDdlFhlBZGFU1iutDgjUfnid1n76oEWp9sV6DkpfotdDNXKejRhjBhXVQC3O6Ez/dOtBdtRA0ySJ2VpvX/ovLoDpW4oa5CNehYUn7RGmxNQ3MP0LZPndhpHUyH6HWq5Mhh6szowrX6F4/7NRVJgwiusWJVlnXyqxSH1rnTLZJGU8xu4qybct4Otnllv2IjKeOPD3hazB2oJBGA/UQrmUVNL4sCbeIFSISv0Cjes1EqvG3SK9KX6xmzedurtGVvtATdInFb7M1Iq7RAZqoQ7vsEdTV3s5WlJDTbthJKKETKKEQo4TOFCV0tO7eVToXinT/rWLvVRZoCPVaUCMvVBZAhTUQslCu4w1C7qnsthLWbmij3ah2R4erUlgbqLeBGgiXoEZOjRlyDIFLKPVyjgrJJHBLJ8NVughQKjJEEV2DG93lvCpV4+wi4PiVR0Y91TXqqeZN4aKndrk70sVZNaE74lWDu+GoMybPWadCO/zUQ/fj/hekLIzEJ4Ji6lIB/XfAQR6kSrC9Bg1NPJXgeZDkrF5RtFpnwIbRw1V2Hq5Nb7Z6ypal90l8JAmzZ16AQ1HMRJAr0laqsmN7Ep6vtmCrYD0QVMC6beVR+Z/pUH3su1fXI/TeXUtyygJsHrVn8jt7o2XICKLizdFyg4sKtQtuT0GyBGGeeMegLPRywKenUUSC8kY8zlXQCatH+chdi1kIOJ5tUAtOyMjbXpb0ALWxvHHr2sOlRh7ZDp2bYOiKN0fVlo+6UVdYoo92lQUABB+tLvDREn2yK/tJF2279pMlfJKiJpbsJ92wyzej98D3lpFD8DL7H29VZnRUw9vWT98Kfwu3oSvuZiVQjg3wcWnxYnfEuJ4591bVp4SZkb9n1C1G7Y8cA+LBvarXD7upXLjG5MNFBBtFk9eLKYSKLl7VGxb0GsKyehH+7ewN11oCocCg1gFl+VB3w6UY1+q+qjfq0R218CKEi9QdjEQivTZcYp2HFxBft9e4ute4O3tDX5f14lq4VPdyk0uMi387e6MVRuoVRl7VG16sVyBC7yVGECrqyQYTn+3XUnfqpbVopcnfHDl6ZQxfx8INeoXuNCOvi8DnY1f0cUjjddrVfg2yclgQA/QuY7S2SneEqymg4Go05trGIkdvIFFYk3SU1YC+lL21w2rXVvX0etbyB7ddQVSeK61jf4c98UZar9euXsV+zXWiVRLHd77Ae3BAoaMr2FcV3cf7at12CiDqcNjLyNXr4WqUa7qJZspqjGy1vojxoEUjF9vADtB+BL0J86OQhgCoi6D5CAG5Lgf3ISKbX48sWklqSO1jul291ORvTmrmqaYTvE1m23Yzbed0XkdQc9Q9MPfX5eCI9LHWdVg4W9fuV1mc3Y1DSXDPi3pxLaqY/EvKQi9m84wKGEpoZ9YjVy/Trl62szdy53XUsdgm7mBBu20ddLK9K8EoG9yjGTGCeufoZaTdRlTLIl2sh4t0JVqMDEmcb9XcNiqJMYdxeW/kUPRW49atrws1oJenRfI6mF+E1JPXiopv3EBETvAJLOyZH0vjBVL8dzO/W1TRiBo2+TD/jOh0EaNT/+ZocRs67YRfeDWgO2n2CbMtXgCzFS067bwgOi0m6LSYoNNOoFP/5mhJGzqtWHRaKQu9hD+65ILotPIrodPK/zl0upTR6SpCpTgw89onLLoKWDTNWA01v3qkCXu2YtSlKSpdehVOuQ5gzwwq7YZTDCCnNVoz5lmrV1PgBiCeLg4zX4+WG1cvJwRLQWBqYc/5Q5C+EBgX/3b2Ro6BzBAI9iIrQF02D7P2aA/YWtajFYxeV6To9RLaYb3ci6ruICEP9FVDVw0n9CAJInt0lSVKri0frQSySgOPRRcDNe+wJQt6Jam2Xsz5Ks4PkB8g30csP+3a7kSuvoQvpC6eaKa6vTraacOcE3Vx0TzU10Ox3vWaBEl0wymKXqYLejleOUCC8/FfFqsVqYYTvCODVtYyQiElSGqurAvaIYQSAN0FZlh31SF+1F3Ael0x1luaYj3DCqR+PcrTWcMayejtIu3iLF4I3cH2K9/SNWC8d1wI4xUXwHjQeF9Ui5yr2FxMXGUR3ZIsoqssiOgWp0WKuvP/Z0T3Dld2ggRm8UgZqZdQeB4FmYRLwsw6HhYxSewzSVyiYBZd8HzP4Qugz6993mudUNyHev8+fq7YZ2WfA/ss7fNiu5cFx6aPwMR2JErkrOda0ItjyhkPAT8E9FDhhyoJqsN8HKrEBjPIgwXOxbHtyztthIMy0/wI0QLJ6FAYxKMFg4GhlnioXUT5h3wLYdRukHwUIyXMAV1B10KXdJmHgjjQFIGGqJlFlkGgeAdRB9AXC6tj7xAkOOZYH2z0jOdgXzw4fq7ui8eHADsUTNjFiCoYUaUtqIv9mP1U/CGEYeEoxCQiYJImSGJVIbOFQfInlPQznNHwEI0fFw0tc+NSjBOanzLPj7MLtKYa0GVcTejSzaEH8w8It7HKunO7nRO+cMrbSc/0FVm4VpD7suxSnKsyuUGS62Ryq/G1hb3esZy63xIixX5//tft7cWCwVKs+N5O0ZzjOMNqRB7U4uEoN6jHHjBzc3Nz+aHzGGZ0dKrh4h5GJM4ftXi/Fg8PzsX/idsT85w5cX0vYsyqEe2aubkfPe3QeY2z/cfOrrIyI7j3IlHN/aFQw1Tqc3O21NzcOzl5nmVsJHHUGzoRGQ40joXCiJLjG/iYEguUgSkFBVExc3N3j+KyxahM0XOZouf6m62VjBN6afh2cczHx3xE5tOiSfFnoIDA/2+74uba+m0fbZ5qbjv6i3946YZ/OHGq0dz2u0f3/9mPT/45kkPL1jz9N0MfR/KTPxi///77P3Oq0YQ9sU7b6Pp69O3nnzjS39z2g/Ita3f/4Qf6G81t175wuvHa8oeR/D394k99YftDSM7dLu5du+tRJMsvw39f6W80wXXzdOFir9GcqPjkgClyzZFLbfwweqFdc5IyJrSYmIjEUU3WbL/eS5cl/r3w850e+jzcjH63MxG56Wt3QjsTUPbA/9uOLP1cd0M+9aLmtj+49pFlNz9yPUb8Yuri+/obkParJkcjQukntox94ntPHX+4ue2TH/7ow+/+l/BFjea2Ey991+g1B+/9RAOWwkJLWPX7j1edJSPusDy4RpiNZP0HehBXTQ9HPYDRyImh1DNPPfEwrbVGXv+Q+flja3cQ4fkfH7mLX/QMildSvGOs/gC5jm1EYtuzbvytnld/dPphCkZLEYL0sok0d6uDyzan5PnZmv2Zmi9csOYLqeZI6JRcf/6ni1NpAzMLfnqGP624gUzNgUzNBT89w58+GDq4j/bMX7/lX3kCPPPxn381Tv7HRz436u4oq9a+bRwZ/toi6ttn73v7A2/r/F5b35JcfMHJTgvVHMjUfOGCNblvt/KoPPPzx54cpXha82aoOzNDswvO0Cz3wm2foe7MDM0uOEOz3IvheIaeeuzJN7u7y3RRL7bdfvozv7vxN59MUMOWX4sx0ZbHGtGyBHiaDbhcSda7GVUnom6LIr936sZQqRG97P54DxncpS/7IHAM8OQBn4JxKQJYCTpwWYrKokyrIXRlsh8NlwO5JR/qfw1TWLKWbaP/P2vDp1jl1YlIsDDDM0tuQXiFhwefC9xfGaqbLoQJQynUvMGOUcAobdm21+11Lr+z+9j/ILcLjFFsW7q1kWdDlNzNfUb0deohV0VbaPyRXfqio7f/4VZo5i1vaYs7KSZ0Ff7FmMMbHZ2ay1/DoKKF/abUOFdBLqNQT3ww5ZNj6eQj4tAp4PLQwdU5xW8KakwHQ3uhdZlEZpkeYvgh6LExtkwzRBQoh8WrLt11u0QqoxsaCCpVX6XTB92y31URrbfKdCDrg+vVTOYZ6wvspMtmzFge80cF8qYDvZfq74L0p9u73qjL3HQzNEbuuwy8epEZHw/8ml8zgihgkEUO9BDrRLq45AkO4cdYLKtwTZmya0Sb7DeNy2p9SjzkZ0gJqyZiJc8FU62HJeJSiiD40RtoMYKECohwCrL6MaJE0hS/xnOWeUE6DMrORdwzDf2P/SzQEo0w8WKRhCWlydPCmqjtsHoaWJftUAO4Qhfq4WKzET+LdMF0Q8ZUxLYjej8xPxS0gA5fp7448pmoy5kZp0bzUFMjAJF49V/UjJa3gsvyFnBZHhd8BN2OngG0mAFzrT4Qj315ZqA8y/i2LgUfkJFIOjHV33yXTeqp5jN+hEJclB+aCO3hqUZ0CcNcup1Qj9qPUKPfJD1SxSFWlF70+kjpRfvrEYlNoIkSlrWrF78eC1iCEIXr9alvOmb56/2oE+wpNJ0MFKtFQje8thyLgyzNHOj50xv5TH1jw4YdaoTF9uh+AV4y0QS+C97Yhf2BkT75WcnO0YBeWhZowQkVkQhLOpUUykeWDJXfMlJXu30Y19AmJfgyBaFxDVisDAU0EQoaTUD3F+kLLMUEEU3ppuW4b2pAO5HSRebU4xHKekTDxCfdfXAjo4vEWFPw1xLF96SNVLBVgB8ix1YBJDOxy8jD5X3IJYvarWfKwV6hRswn7yBIPiMbh5ZlIV21zL5mj67ZbZgGH/5v70YSlnYQ4mPloKou1AmIEyz6WncgGfGvuMsi9dCvtMsYL5Sk/8y4PlRYDz/bK/gWFn66+oXzq4+tBFyB89EhmVlOe5Hi8WchG7PctNiznmFB9r6oiQlkx522GUUuV1Xk1sNKZknYZZBiDUkzOyVsaFSF2H2t66GLL6HriMou8l1EcOKV2U9AQ9Z0JV0gl48gHB9YvSwIOHxi8LgwKu65bSOGiobtP515YCU6yTFqjmLZ09aRhI4tOC1YXTtXZjva1hh2w0kXhr9lkx8KOTp1KEAo/jqf/kf55Iey9lE6/bVTZwJAapG+2+oUfLKchsDbv5/iGRF7A/mq02xqZ9vwV770qud/7Z9f2Nz2g3dddud3/vlV5/kQvNx269Mffvm3V376Rc1tX3n1I90NeSk4m/efC7q6um7rbzQQC0mLJvb0dhJKO9prbttFnM+nToGTaVR8ZsBSVgq3Pc2JppYT2o3L9jcbE/6npVQjrBQk14IzFg9nGXF1nqV5LzHHKTQq8+5HjoKtRhjGZBWDdzJ/DcpJWYKpLHos/id5QTCOiK+djpDK8VkhCsoKqJl9NjK4Xx4tqdYiR2mOW8r4oaD4jVBm8m9zpTOCL7PUgEx1VI8WNBe4yeI+vM44EL4TdqCUFhz3XmXS7DFLwRGMeL4QsSzD6qE6QxDpK43LeMIzjhmGyGJK7OKbOTNQi6CWyG30KcEHGsQ+kIVSqgBbBkqVYI9GqQBGapRaAss1SlXhPIZSK+B3hlJ6k9KcWrtJreVU3ybVx6n1m9R6Tm3cpDZy6rmb1HM5tWWT2sKpF2xSL4i1PxT7TPSuZgVj7V5Tli29t5IgyIUipV2MnOgq4+7KTBvJXCN394VnklLy+UJySj1fKE45zxdO+1fi3iAw8IXXI6YLhX8WYdt4mXeUmfuCEmfdEC7cX786AYw/lj0EFwQOOEO5FsZCgg3m0VIIcQCNrEuqtpex5eZ3pZ6o7BpniOcHYY2JT3KGeATby54W9njG0Si1qtmGbC0SEl5tJWwK00nmo6oWg5Fxdlst8LJ168atZdsCkkSPk6ac9oWExjbxEvhApklbOOkTUbaZMUaEf/0fKwW5naIhkdUFivN0G1nnR0XqKvxS8Q+5EbevHaOSgvmkoEMwFOcXKd8ILerGGYpIy1yaOTlkbnvjocLNkeSYlAokyTC9V1Qb2S7XdvBU4B940yvY18qUkoLdScEq/yzhn4B/4G4vSKotSVLVJLUibgq9H4IHHZpXjXbliUFc7AUHCXFj9tkt+2ZSUfU2k5apt5mURD0OIaN5ujXaWL3bQvcDBcdNpKV5kkTlUklUzKFmaMljOmdW3WLU0EMNks/Nzf0pizmRPPXtVqQuJmhDiETUuO3BZWLR333/3Cea25686bVr3tb8AxxD13R/9RvXXvonSC7+qxX/961feALJm76x5I0f+72p/kZGxqhf3Rz8tXdNf6K5LehZEX3mf4YQIVbqX/5kNL0fyY99cdPLXvy+k0gWv/n1L7zhD76GZCoXJTOJublTTzu7dX5QvHJoe0t3NbSeGxMVPznjbF78fKrRmLDD/tFtED+pYXr4UnKajT71xGP9KWUGEYjQyf/b+vN/1LHl1KtPNbf94B3vfOWmS5vo3w/7XvTC8RtJuvqkvnb0s7/5BHL/9bHJnw88/lXkXv3n954Qd38duVte/++fmHzljZD8ZppdufR5L7/urrH+5rYVf39t/dH/dReKrn7ejd+94eIpJB/43nu+9hs3fgTJ5/z+D+6dveqfkFzz7X+pvvZFf906RRMlmSESxf1YuuYxkm975od/+ccsdRMtn/+NR4/+zY8aa6aa2378+JMv/+2XXjfVaG77yJ9+/ge/sfh3kHxt1Hfowy9+DZJ3H/vckx0br0Hy4u+eNO6qi5C84XUfe3LZc7+DsT7vNeUbFj330CnERm/9ym8d3f8vP/7Rh041t739qp1v/dGVPQON5rb1H9r5L8f6/i8klzh7Xx5O/z9I3tT3w7D7skNIDvXc+ZXyuj9EMvxu7aWl570ayTfdsvfhv3r/cwYalrxIF2jLN//4JVsOTjW33fvKy2uvdo+ge30/fv3isR/ejuT4//rUr/3PJTSUV93/my8rPvosJP/hjkf3fuzt30P/r/r9s1sX6P+239owNPitvZummttu/O57vrv/+K3oxnf+xz9+sfvHx5CsrX3LTQ/NHUeyeu2fVH+gxpHseE9v9KHf2I/kkWtXXnzX9S8aaPhhLL/+1iktHybB0N7bT5FMfyJo0ik4AcxNpJ/QbnZ5G0FTNrU85kfpRQSoK+yG3kpKP6cv6Y2/SkpL0Sktj+IYJMqWTAtl0w9SxlIEwXtkS8ZeZNzp0r2MOqiGWe6di0VrkWs+k6+bfjooQ48vPE7nCczSnleQ++bCrnJKHaau1A5cC7rRNXOVHfNq5YjMNiJoyIpvRDCBn5OPcOTVppmkVCQbGNhEJM3pR2wIWTNlU6JBm5iwWBOBzTjfzNBvo0kGM2ds5nScqR6Ocg8Yd7+ZpSE2HmWGR8AxK86H448KWPTr3OCGw8PQhd9O6ITHVLh9D3xoxuMb67/1FILdn/9ULMEVI82S9GlJYOoVl5ztH+aSGE4jSqfiRndYu3GpwmbHGr3GZu0BXLKlNu7ZOYz4nkdMZC+mtDPRaDRasVwqRej1dMJqBqLpV3ydTwbg+//sOe6wpLOe/k8gIsMkeOap6bvfyHT3Be/nyp5d3qQjOHC2/WjrU08PXn544DWgqRPkPdIk1P3YN888jes77ZkPf+rROZApaOSV7gDu4bbd8oI3PO9HW7//Qlj9bBNi5unBy79zqlFSMMZJ3j6cfdvfsOz4tqffeNlvX7n03xN5O86P9zci2cqnyyz77z0UyeSbzZBImuSzzYZPJ6eaiMAATTD5S+fyk2CVoOfCkv7M9VbmXk/LbRseK/7eQ7+48xPNbVtf+p3Dn/3SNO6oHvrGB9/d/cUlQFd3vOzp7oZ8Fc6An4IZ7Jo4lT0OkquyAjGFzYnImUj8dIA2b04cw0Wgtz2+ugM7OGF5RTXR1GrifEYoLcMG3ZVORyipiFKeSDueHrGVVCA1ferG5CqFyzXiKmKqydT2RJS9Ye23ZEm+dmLwuYdPgR83Wy3zNpEZV6bOzAgu6lSTnJLu6E1hupIehGYur706NRk5E9RYg8h+p5FpVXtm8dW959Ew30SWhBXs4/r1n1wnNyxHFFFahRiI/73/Vobt9zwqXwH3eqlzyGszAufMlCQUhX1umPML3iDUpWXTnHmc0JnbjLwGmaHy/aeVESBA+pcZqSnTsClhxjlljtBvA/6PlRlLXo/a1+cez7yefTx+ffZxiw7T14JkAvTbIPMjnQO6aOA6XRcGN449EOXN7Jysm/eMHryaxp3Z4XvITWpQj/LJmLdaW/ZkRo5V/MxkzYlry3DpPTqqhrZranoIf65kVit4r8zM4MZfaz4c12w4t0JMlrT0k/5bo+Lgc9/0wEPnKe2GHWJxcAPwkhgy7v4obya/TJgceDFvTvIDQnIkh9Htt57Cm28LvqTOm0mbbEaiEbnxokg+OKbt9J1+3B4cwkzZrEk7oziMTj4er9vxeOZB+dO0NhjevuC0E/OhR9h1mHbezw59P0v32huoP8zQ93MZKHt12e0h8G2Zcs/I/UBdn83vKkNz8VO/+OzTf3hNObWXAIdIJPZcfnfZ8VvOEWl7Zb71iYtwrbPkFjOXh3UtVThqCcvsNrXY0ML9BBccdXf3ankMsvA8gU3ldnrRPwQZ0pxTOzGoDx86ldYLhc495FOsa0bYTZ3dQdDEiGQrGm1GLtBnM0q5l23v+ZsD08Wjj/U3t/3Zgbeu/NTQ54E03afeef/994PNIHSActte+qJ/XPSvj/Y3t/2D87k/es2OT6PcK98e3bd21+NIvp0kZf/c3yBH406K/bVqNGhFcV4K/1yHUxx2DuYs3dXFSgNaPhyVQDpFi4h4Wmw+UYCL7bmDu7HsPr2qmLlK3bxx7zVDEMwPysNReVDeGu+x339VhusJlfYzSKesdHkP/hB/CcryOu2jgaTQ3lfwptKyESpINJI3s9iGqRSeJlCXBvvH9rSUuW5Hb6gAJ2i3rVu0M6hLJBtVR+GOJDgujUQlX5cGxSvLSndlBIfHKMwO3NjaRqkmKkVBvPu5o5iVobCiAyN3mEX7cYWTRTshqZXPHbz6GWdnsXmYSFMJMjjz7vreFGz5c4vMaLDr/CBvi4tcdyXRoRPcHaJIuc+VzL0MYacFyB1gKhIMlpAzcPupCBrq3IHpD74PiKuUwUB2vQrDGfaglOAxb3/Uac79hLBSlPIHfLSYqZ/QGeI0I68Z5XWJ8WHBnPwJI55OM/ZTiwKL4C+0fwpHfdTRAH5TQHF5iE8mGrpDs2A5chpNXTCTSQtHbAvkr0URFrP0AyxzIb8TZpZLm7M/STDjjM0685MYMwozbfNOx3kNnH3q4XienGYUbwzaMZ2W3YAbp/l8BusTBRZEO8FyhBVc/dEqWegKkqULeDlJVJ+bAPnj4YZpAsa350lkTaaMlt34ZZmN/yK34SfcRqWd26gk3IavgxPDxHGUSOmPcUsnSen9DOtR+k9Zj7TIbP9wVLJch0Ncx/0tbEdnC9vRqTvb2Y60qdHRkdtPZU6hjCQiwSs39jKMOTFTwrAGe+eJZ2ZDQqw4i/Z5zUrJ0IBcuvid8l+iiDkZgYwwARtp5iBR7DFQQ/zzwm4kxSCSWtZPHI7UoLxVn9+v4qVUyJCk+PY9vb5/XOKaTZrRwksysDYz0qSrhrkKGF9JR6EkkXBbgV8spz+7es3TFRQBrJnbDlyVQRo3OFx0cu9uausz+RoXbC8wexP92d1r7q3UQpJ9yIRYbvqfa724GbjgxQ3fxtB9TWbCjQjul6wcoVL1FkHXaCS5/k+vbegKJhSltqucULTc3PBlDn+o5TonpFAz9vJmBHc3AqwHCd3ZQHKDENvLrEgaSSsdR36k7DUBeeaFkblD4uD6kBm97Y2HDgzxtTTExDhUlBb1CiqqDcLqz9QiuigkwarUou7nhDl0j/KPXy59O6d+rPfX/r8W5qewBjFj91AHcgZRy/2aOTCE311Qj3duieQtEY8EOu6vM3JI883A/kiZyXtInB9JMvIEvMEkBsLpk/eoWqR2cOvw1qGdP4DCAAlacCuMmyJ3kyr4pHQPIyzj7INgW2r4yaI7JiORUypBCnOEO1m4Govv2gXdj32xP2K5+r4hmxiCeB9nSukWEwxF4pZIGu8WUxiKHC324QMYkrrFuEOR3Id28CwhYG59lsnz/BFjoOJCA41ydqgiHqrgobIxLKxr4sHSBRE17mkXigvSvvBqcBgtdIEcoDu3RNBLpc+FrnkXzUYo1Qg0kbW3P/LIEgd98HRuH4nwaa77VMEPcTxIjtlGtwASU48fD91Ca3RRj0mmj5ZKvnkLTzgZGpF60v+ReYVCxeTbeE4VlvzAkHbpIg93VGqAbarEdrZqWhKJ7aRnmJSkqyepnd2R0xsS9tNOLyQarDuBrVUldzCqT5UicqiiaOnMOI1vF/gNjx1pYo1KdG+1xPo+pO8q7kHZoZAxoYMd6MDRELiJuCCMCemt9qi4Nf3AXHZAiuNqYU6N7KZLIL8WCbijcOM5hiI6IX7XjCpC96s1K/QA4cOE+haa99Gn+2smoBkX+7FHzOjMasrBjO8Hu21GRyuUo4YiZ7+p3IJp3qedffBpIffDX4dZWsMS7DMraj6MFGi+LUrIZ9fD2U6KOYL1j0hdzsClvrylrvNm9Y7e/Va5wkmXI6flNazXoXORZBtp7TByFbyEOWi7aGVWots1zJazoxfcei+rxexPMJrQ3j7ug2eUzicbXWMCsCAX2u+OhUsFuHS0SuHSAdw5KVy2PMvkOQuXxOcC7JyBLODltNwFVSKIyhj0PCQ8lAkixx3RDqWX+AQN1puUtIhMu3XMkwfwJM/4AE/4I0KqDTwzKKRUBKfbAp5eAp5eBjxzWkSqBTwZeC00AzxzDJ6FDHYVOA4S3EL27EBJwTXuQIIbCFsw3mJtgBhlCS0tykrwGyDnXfco+hAaMHxzi6MxqRKxN0JuJEaRpQ706j7uFWwakabbUbopNY17FP5Rn9EVh69PZdKVGMGKuDkLwVfUooIaMTP3oq47YM5SAv384b1qcAQmi0/eqwZHG4kF48y9SvumBGNIc+aDX/mg9zqyc7zXjuqTcWJU+xEF7BVa1iMIk3HvXzRT9IVIugNmkpOkWFbUztXlDi11cVe5w0czsKd0h8p0hx8PDrVO36tIxVOyOyHy6eXQnNW0ZHkHgQybvAUfBlkxsqPsaS/MYTA0SdgiUqsh0mbFdbVWNd48tTCHIzl3DeTa5mnGOl7cbZF2WyJKk6Pl1WWI+Jxd5Zyvc/icgHmVLOWhxqbqOj8UJe24XEJR17nPO4BIQ8FqbSNQb3DNxprOXV0WdjUixHrN1Ws0k6CBuTGri5H3tQw+LM3IlcQQw/bK5huhc/Xgw7IHCu3sQWvkyrJHbG/oUYFQQeVeIV/RpOMfjFHdfaTN6MUdl9oLPiyhdIkf7J4R6NkL+6PV1fwDPIDI41eXpY+JspOFqSKo+Dg/CoDwx++lTSwsTbrQGiu7xuyg06vBwiBZXdwHjFugN6SkcHUv0OO4Pb4Jxs3n71Ua5Afa5FP9+D3KjCDx4D3KQj6enrCQ6xCpuj+SRNxA6geShjey+TiyKE3u2YTR5CPsPqJ1+nCoHIBqY36IVFMKNZMf6o2ggGl3KQEaazfIDKZQNdO3SbnmvfcoMxv3iPiQDaJkCkOk9EJKF1Kra0ilAmZ2qEKNmgNa2q/K+KuCO42+WczBYcVEnZYCeyYhrhb+voznV6vd2XnVin0A0iplSWjH7kRxpfVSFYky2KlkHDg2nmkDYz8lWzgUJeELSzSSsLAPBqc1VveYP89kMmfxnGMOaMe+d5L3OfjAqkEpEmRSDlQqps9tmyaHgZWIAya5HRwPfBDs4COBKwGHH7lAJWDdGgE4VScPs8YZMpKuR0HwFGjPz5EJeg6zRSdBhrLd0YNu4igUlqK2zIk5qD3mHxQxOjgRBZG0IHIpkFRRQZE0l5yjOUuhZw5P0mPK4VRkX7jkMTFInwxz6NgQcLrIB2hSlA5QwQeoLBOyoN1MPvXij6+IZEw6UE0aO6+nKksQfJboMwe1TEZUNIFZAq9igc7t6K3Z8kTqKs1R1+jYZiYQ6jzUZpWGTkSx4BdL0he6AMzo4AfLQQtiDg5hodxkJ0KNh7e3Y9fFIZ4vYTVAl1r+ELbucn8kE0ZDaocYDeZ0iNEATgRXF3MYLi8Vcx9AxKtJRxY4lj/2S1K2inj7hLJVKWWrYsrWaaFsQbTRx1dod1BsxozF6wLKJqa8SWISM09vIRLD22dJGAZuqFKxgiCIX0HEr2DiV7DhK2uWS0sZOjuILl15C50/kkpBO22oRtGX6aMEPNkPoK92vjB7QPTPjGG9epSPMSysViOPAwfknxnDEg6+JIMoLqkTojBXEAFNYoxdvZFnetGIZ6bvVesUzZ4HLEbpAnJtWO+FTpv4WNGeqdZCPl3yCSmGSXFrrL+8i4L0ag8zRhRwDJ9wkS3rUc4OxqMv6FyMOQChzkIQitWEJCGBUDUfQh2LN2KFOItMJEVnKrkMoZJBJpcAam5hQCWGKwVU54KA6mQANTcPUCUDagqhzi8BoY6OT1ULobmFINRJITTm0nI7ym4bhDoLQ2jmA+iknS+7lbUVgbiJQKEADhHIyuWirpV65JkG93z2mCL4rVVnlFyFvmJXo+DHlL8g1VnaC+K/TPs7PkRiZiPqChLqgdFlnO0BYzstGFt783G2Lli5TsEi7Dwh7DwQtjcPYecxIO8CCNu7AMImYW2FlBqZu0p5JK+VRyJ1jGSQLl6rZPQgbey62e0i/9sIXTFCT09S0vLmA5W3S7JP5C+7T1yyaU/2iZvuEzfeJ3LePlG8T1Q7QrfBMninuMlOcXXB7pSYU7U7RV5wp7jkfzneKZLIb+wUN90pbrxTcphDMlzMZT+AbtqpUpY+cTKkiMPTqRjsFYN9LB/0GGKJTulgCFULQKhiCGWcbyG0mIpYlY+YmGaJ7gB8KsAnFyX49BCfs2rlAARuFj497nwCn14Mn14rfKp2+FTz4VMl8Km01XWWiXSX4fOZ5JoAUpZq6tx/JtcULNe0JKHLP6lc04nlmpIpeZphX/uxwP7zJZknVXtS/zZkIyrY4UokzYGhSNSg0IABEFeSGE0w7wbFZiuqIYZQ0tlmx3El37HQNlQsGafdmM/Quy5LJuU8ejfPi+n4MTqVMW3AQk14HLFiTScRa1o06sTbkyyfltRAnRCsctTr+Mla/II1CfOA+5aiDuhdyQJYN5Vn+jq3vSzjj6+I3AQ2paV3paUo2+ldNxlRjsAzl4Anl99ehqUhDnsLnpIYJVJfj08hAk9JnqhYvT09/0BA0PWKgR0FrTnTIVpaukJlWBXFrAo8ymvPiuJQXQ7xvpNGWYWVRsIGNWI5eYZ3EpYNSttOVr/sJDKvRApG6iytjJVqY6zmt5jtraTrGXvbYmHLuyBsec8IW6odtngWGbasTNJJZJIylUkuAGZeC+x4/9+AmYj78V8AM9UCZl4WzGQCZt4FwMyzYCZawcxfaFEyCy4TqKv4zwx3fsIIiwuez+7889n9lc7nCo5nmZ6X8SlNFwrEZKWntLRncnpKuxe4UEAv6EJB4pQGSsyc0oT7JU7phA9mq6SUorVkR0rROpaideNj1LU7WtA5LemclnxOSzI+ZjdpkWvPabGDbldX3sImPlSK7FdSitZhijbzgQXOaTdzTrtt57SbOadJonac4Y1OgBGterGofqMAX0kkl5fBCUn7dQDS85QCrfhqxCAgBt+0Sty0givB0UM4qABRiSKChjkZ7BHcC6kesnbSivY8mUI7dSszNXL/1RBpEtyDI4QHVxS4hk5sB70McER5oJOGtLPPKCsB8HA+K3tc50HUuol0QAUn6Uo/n8GCFvEpuri8uqwWbrLAX7WCBiLhE5lgwd6O5jOY8Ei21V1lpWy3Xbp9uFC3454qpoKtwb1KWEmmlamqiqsqruok4zTsvMppIxjcuJdYlJxRQ2U4gTswhD4WNWkhFGEzy0Il3sx5QJBiFrWUwcQKb0qROw8TlxJkpWIJQAyNebq6JK/LVDl3ZfKBFBMT911iCtRi4jzQq4rRK8VLVikmzjEmRkQ3jCpbFLIw3GglmLhkMbElRakfWUxs1447IXTuwpg4Q4/mgYm5PGHiHNOj4KUi+HOhoQTcZpVmYUlEtnn0Yknywo+5JVrdYry68NXRsroZEGiHHt8CPdWxYBNDvh+cREV4Vnb9yCX3WoUaNjS7yMS+rJCMyQybAwnJ6BlnqFd75sAQ3CXiatrb3QsrTYpdoF3/rpLMjTCh6LEWBsBLMXUZm+QKdiUha/YWToElSmlKFR8dsbZF27kvSAiq3SvL6kI0pYiPecGlnUSC3QJcTsqyMHCJFogRbcDlxMCVHPOq5ZhXCx/zKu7HwsD1jMe823LMi+wx7yTHvIiBy4mBi09zYYFL8YslMY+oLDWpLDUpEw6CXMzxqS4SpoYlJZV2zRaWL6CVhUlJ0UZKSntRkjYsfkVSUrSRkgu0iEta21tF5w/DmGolJdUFSEn1jKRkZvDPTEo+M4wRKelaORSTkvFTCmOI5KEYxpKiBGMuw5j6ZUjJXxLGfnlScgEY8xIE1gJj/kKLklnwFOSIlJwPdEklv1XUoxJSUraSkmp/pDKSUSYlWbOPSEllpW8xDWnldExfEimpKOQYyORWgQ8JPVNSUv3SpKSKSUnFAh+VJSWVvQlbwe6UUlIyS0iqhQlJwVDvtgh8FBGSymquLERIksBHMSFpNVEuQEhmPkDGUDxTgmaK6UgZX33QnAqmIxMBBchz338plmj8p5IvvYVxajD+VszdKbrjlVf3AtH2CxPspyvwgKAOtbgTsCxMqMsR34XHRUdIJKQ/LMn/EQV0lGTPvm+T2kl4j/AtYX1Dt8l9am2XJ3p87uoKji4X8FEkjTvE6vdG76PvsI11n1qPPxtJF6TAywU+tHe/Wf16/5VSXuDjpDG4QIuALtc2HBEXIZj9Enx5uhHRj43wC0KL4F2qx19Kssb77N5xa8EHXC3gh1UEk/bMtZOhhV+EZu1I8DAbimpJcY0xyuyrKSldqznprhXsO0Z7Lyb8wSclnya5Xdbj5txcntc5p506x/VU2quTbNaUakQ2QGhYC6ZkMCXpJhYNsWtwJ3hE2jNYI/ZuydoGU7jOvi5BeqE7KD6aEzwKZwJwnUZKk8Q1g9L3SNPNZYmW5/cl6rRqLV9RUXM7Q1ZgW8v+JJxev0uQA73EkYTvd2AWq/tN9fUAnxH/CpH0ZW2XgPKDO5CufQlyWgpCLdYLEXxK0rpAW5VrfySdSi+ZShdO/0F98ESuiHLWUI6bsF97bpdjVS04vIX13FBSHsSANNHQ2FPk0gqRr0s1Dn9NE4zmtWyZYM6ssV8El1qkGSwpn91b08S4/ibMyQjmhT3D2nsze2mVuPWI/UcYAW3vHoavEgkQa8FDUgt/cTx1pgTCsBZ8VtL0Bp+VAMp5rz8v/Ybi+dK8chQ0mwxaMsW+zgCUyWLHWQDGPrWTbUTSl31qZzBNh2pbtmtG9RDdQphqre0bRxXlBn8rycFQlXYVQEfL4HFWPC7Ugi9LSMvxbe0GT5CsxDOjU0I7wVdk8HcsPAm+KnsIOlHoDOW1fMvkgq+xQnjbKJ8vWFXYuFRAkdtrP48J/Lr0H1MtMN4yk32qSiQyBbARjI8EO/XIzveXpDvQXnHnAlmYPkAffNgrUr0usKOQ1k8G34BGUvsLI9F7FXeHVCLaKtKUzHsRfEku/IJWbkoMXeht2pH5b7k3vsUCvg8Q++gfqeA7isKttYNIlQCfi/EmYONSGXxTGvk6QqJwS/730qKMS4DvFRxgUbzhAhGVQ0bur10hhZZDRlzpacf3y7biPwBDE+qlNv2Knb1Ay33BHyvCJn0q2J68wBbuEoK+HBxRWgZH1OvQlUvppCFZJ1XZkSwkIy6wbRZFPfcZivZxUfaFQ2JRWylPfdzhv9BWrrJG2wquLFvxFvtpohbI4RFtYrTyUdmyvxWfs7QBRfBFSakNgu4MsdlaAYI2ZVAz5+7DgtlNqAU2pKsVdiM5ZaELzD7VBodw7FKzGLFPre/KiR5qjY7L1oJ9akVmx8Xr/yCDiV3/s7T+HXYZv2exmbTaa32q1OWJZJW/n13ls3z2Bm/D4r2NF++SX2Lx+pTwn/XLrZzLK4caaJmPbcEUOL46I81I8I+Sr3uIPWjv/kZ0/+XWA1NcV43QtUtEGrQrdth7MJWsOt96OfT5anI578/7Vm/i00JieoN/k6nxSF6wVJd/S/6rWrFc8B+SmXR4DBXBL2SPdjgsYuKHS2hJShqYCBG8FTAjni8qRFpXasE9Kt78y8nuLbmYTkhSyletlBdo3HgLVjXBtb+BFoPiX1kFQlbHxKVszaILHNmYF99f1NJ7MjR9XurbY62wU2/7keiqKFNKvUVRt+9rISmIcLkPXh1//2oyCXFNB9vzuhi79WeLp3eQrUwueIcXOcEfQZsgF7yTlAqCcUU3E5qUxhwtMUkt7qLo/PJ4HqFkzfPIFEPFDyqCqNBkeG6FtP94pU0HJPR4N0IrZmTd09L3n8Q46FQWwc9kBHXDhOZEX+qRR7T+UzKMi4DSc0g5QNV3W7LN0bIOeWfwHo+uJoL/LSMJSkgEDRjAO8G/Q0ZqQcABHUq9j6nF2JkH1gDA3gJhKlMvhh4yomIvc3jbyVyoMp3J27eq9IABhtggfJO/xe9k0LZGXf5vW2ACNtod7+PqJrWeZEwbxEbSnbSnAQrtigsVmFZGXvBjvgahp+AaLl5ilF3xzYjflDG+vsCH4uauoZtdbNXWz4BpsV/SMhhVvLQbTTDEEv5HZVwMX8VGj6n3heo/SlGH0V9FZwL1sZNVeQV9vde/U8miBXBnLZCOxVa8LCUoIkBT1EtGtYJI8qRbuCRg2R4xeTBT6VPrwwI/FSl4XgSt5vd6BDhPyeDndIcE0OnQKviZ1B214CfIy+l8PfipZU8QX6pYr2HmLDEd0/7aAfUtzPpa8EbWM1sfLyHPptE1tE5CB+3Va5nFo1kJZlgKEYwqP2QpDqHDtW1EngzuVvOYmHcqJUecg+RhkJwG7o5pYFrlwRHSOnVNdSjyrKvvHVBN2zHENNJ62mke+SoL/resPxjmrH62djodJSQu4HkocHFImLb+YJgnRVT7zSWUAVl2mCcFoOFIDYpfpwMn9zLScC8MscPyPeiCbYvuu11aNepKlcVJcf8L/Ec9UKN+0oShdPx+CflSxFJJrR4IfopNCb8SQhfAyLbOHrDIArPnicAV/gos0mzMReta8G6vJ+agmWk5rHDQWCpRrWN3oYSp+1TQtVT4z6edZr75TpZlxEJHS3iefWfKSBVqwWEAqXmB5ZToA29WC3JFb1bz8+5UMW1BHdhlaYvnC9/SJ+zzz19vNz9p2GsJOjWzlcT2ih8fykbOK/y9ZyrcJWKBBDZglyNac9Z3OQnBc7/yiZXzr8EJYGNq0dnIJkv+jl7PdPi2ONpn2QS76tmHIzl+5YIuICNPHqZZUQuOu9gxjNS2a7kvolts2q5yyB0I7gDJ8fskBDKz47wsfaqPPffR1SIRu3XSWmaidm3NSgw0+2rscukM1wLf+wDhH42rDBS1vxvt7wvol8Uv71JW/MKd5eWnwRm9QwtTrBtv1z7/ShZQyc3O3oxAyY2c+oObnQOM7HA9IPfQbnLqD2r5cr6WfyAVEd7kv1kpB36+BrRY5+yN3D3bIXlbx024TDGuj1T9weHIe/lQYoMu1wozQh8QwV9Idt1oKjVD5XWXJ4wkXmqDqOBjllIDj8O3NOsZo7tk1Tw4wqOQm9RNbA6mZf3B4c3OAZKZeINymBG3G0oemZP2F1hCe7eyiXn9wVcSp+w+QMrbRKlxkzQMJ24XhzNLYUEHUJg1xUKcjXXTscvfI8m1pWOmBKMNxwzUThwO1aBgU22HqWLnROQehj8AOAE+MXaIZMHuYWurvZkc+KvNTsEfIW+ZyfmkhTqosUkGrXN6ELOrXw8nnup1kToxKLT6nUiZvxW14JjSzjondnozJe4w7x4FLXNicOPh4Rjgh8iNCmT46xzh84ddyOn4UGgfkOIBjYVy0BrX84DsQA5jxCcid+wQhDbaHWOAyQ7oMx3KG6lgRDOCaUrXOsLovx1xjLR7R9ZNAExJk/dRaVCPIVYUfAuZuTk5hNsOYPkkIwLFI+vmjaMHryE1Ynq6bfQghcuQe5LWyO1G4u9kam5OXKezT9f2kimqzdGHwg4cQM6epLvcgGppQM1rwM00oB02/ZctH7rj0B6eWPza/Jm5ORF2EMw4vu7IlD5ks0lxS81rRmr/EAObVu3NLdCU7Q192bYad8Q+xr5T+l9B92nTAlxtif6V9kT53jfovMntPzEMV0+VenBMmUDn67CwXOe8Il4vb52zhxRV4sauJ9nVQJ1CzeFfeU9U7H2DLtq2ityWzutiHVdM1NzOsIyfAWxQZ7DCzmqenqvcjovbQT0WuQejLu0j5WtpfQZF8uBwVBnUh6NFOEgPDkedetF1J+BwJi5ROhghdL1/cDhapMuDlcPaGXzW2KFocVzA0WikrCu66zpsF10Z1GOHhqMurXQwODrqHooqB6Nl2telg8NRoBcP6jF2snEIXTs4HC2GpODgcLRkUB8ejpYPh5LMRRD3bm5O1K1qoXswqmpfVw4OR66uXneCHHSjSV+7150Yhqv0g8MaMT2XXndClzGOYRT18dLRlYPkww8VlHa4p4p6Cgk5fVnFDS3WS64/oQO97Dr8XXz9ieFhFF/CA3O1QjFXl3XX9Sd0l16OArZ25CYY5fY922mPIbAZcEHnYP9Y6Gh3UOLL/WPAKwoPkh6U7hyUh8NOoK1BefhQSDr0c3MSDjMWAnLpq4PQsn8xvPbpXD0qmFF5jQVOioSzsaY7YcFk5gS4zWNgE3WN6F77FHCJQvA+xfJrm1znbMSfLYcGxUtPIKXxJzh0KOxEog9/qkBj3joHpo3eOo7okmIrnQMmPeTrDuztzj0wYnjl+T8p9mIUAAwmh2EMet2J4bCDJqql2B2HaB4VnxBkOz8ob09rZFBoB1CzZ2YERdAuKucgceezoh4VMqiUPR0xbpR7omIb1vMyc31rnB4dHblOe3uoy86geGnid5NKRflMuet19unaXqDWovZaUKH3TLjU1ZIdYzt7Wj5zXcvTPAzqMr7y2tFeBs2RkMi5o/0cueMQEEzoDuKQL/baj7d87Y5De+jWxyNE6ugcIKNMzd1OQdDc27kDeLWHOAhkh25yEGvnOlyW0J9re6OOXlKXVrqjN8qlZxw5TUJeemiF8F+anGDF7aSoPSNqsC+if/kF0aMJENy3qAvrnJvCPH5uCCm+laM7oOGWHpyhS3FMdIEQuEOIxdXunqij9w26w7bakbTaUQ99NPcKBEcH7gZLNugAMb5w7FA8re4hcknqHNYesunEz90RKnVQO4PO4chBUMp61EGhVDvMnNhNO9cdJDAvMPp3zajUHYTsC9jN6FcHNmhhnbOFP78RfwbwZydt1kOwKZKZXuS1N+gcZq2KONqCc2uEiXNvpWU5cWvk2lPNQRdIyTveEs71ZakLQBseRTRsnxhTqkcd6GARE0PT3cc90+zHVmpnGIHgCWPnh1MMCS9LOOkG5e3aHezHRMmxQ4dCj2IbhkVgyjEoPOVaSB64/7BYUbZgRXeQJWwI5kiBzylCZJFxSgGoDr0vAhnShJLVitTFup1QgT8B/lR5JkMPDwXSuRp8IfrnjB0iJ5LeAyZP4Y93nxiOvOtPYP3HUtTXQahPy0PD1gV+0bikbMISQJfGHEntDeP0BBajbQLfJuRmwslQmgUzS+jsKamcgyoVNoLSfThyFiS3RguJQ7kfzYlXEHZ5wWE6btyxZDJfMEyCs4wDyVcRcqOSTlqSZpeK7okpaw+gpJ0HfoeOE7hH+h3bUHBdb5Qzz6IZprPBpbMhQ2a/5Rzs4vlwIF+vrqV/z+PVzDofYlxOZPY3pILXUCPpclEA/coLouzr25ArCHDUaJ2qXEuNXHsNodUhIKpD2BekWQdExx5yyXuKVtch69fxBygeOXcQcgXsVPy41PXIe5ktJVpLsTLfJ+3gRpj9mj84t6WrbltXYYb5q8wF8XXZYSk7LBKlYDzKjkdqZQdje6XVy+xrkXlNBKf/PJHhZNKdwLwIXJJmuJB9tPhgd15DTsYyQrUW/k3Bxb/Q8nciGbNsaj7LJpllA0ZPmTQH0GPlvtsT0T74KZJYA5Fmz7/gAQut5DdlnUNO2ux4LAx+UnEz04Kk4sT1jY4SGnKxC0ivPW5zbk4E71faBS6kH02hIebmKBKGw2QtnbIu3WMvUNcxv5izf+H1bI6iCrrrnCo3GFiG2dw2OnIVifQG6q3tbLU92MkVBqgHPx09uJt6cPecqFlshINlfk3HnL3tVv67u9ccfZpuIFwcO9TcxpAQmWREgAHVsAyoKfDezqC7zoFCi3ZxtK4V/uslPLOCmz+IVTg4rB3iTZhFUfSc8hUplxJ5g3qMa0SoMcxNxIVtJn/Tix2iOmDeoU4zWVHeSCfgbFrN46r9LCVQ+n/ZexNoua7yTHTvfaaqOlW3ztUdrWuHfU7EenKwHKU7kY2BWPumdTV4THBoVtZbnfTw3mLVdRKuMG7eiqx7CcYoCQmK7c4zBBvhOLGdWKBOGNyJiWVjQB1MoiQQ1B03CI9KmEQGkImDnr/v3+fUqTtpwCb0W5jFVdWpffb4773/8fuXitidVQXq5hkJ1K0Bbq61GhPY+XYF6k5foG4tkYSXkY4hNtQl4g7YgM7ADdtZRbguf9K2tZjp7IjYPNV/34vRK1XfGhSrD5ozEKsPwZX8eUH4oFlGpj7APGpMW2jTq4vG1P9jG76mRiVUN3rAk2dl95s8xb8HTE6Bap/p9bUT6sYi68vD5f458PQDv/iPypobnj+3VfZ+CFl7TW+ax8o95oZp0J5/vmB6eHobhcDnxau9lArxHnaVlDmue3hB3t+D9+X5Uc13T2j/7nG99N3D9XeP6erdg/LukfLdw8u8e6D+7qH+u8z7JU/vL98/wPendX3IwF6a7t5UH+5xVavyHoqO+3TB+b1NQ36mpG6m9Wv276raW9C9aW3r85bYJtB48tjsxquvL4YBzUuxdI8uur5PC+zTrqI1/cyX1A3FCI+XCmMTazdRid5QPFA/0qbkXYyJkqQFyd+27NA1lIDfhPLDKG+705fu2bVrF0Y8jLItKk7a1+y3Q3a4UpzY0fLjMLQsqAdag9Zu/G3vLtbYlh0uVS7QLwyJOqKLDzfheRdvDNlK1TJih/GaoTamS00NEtiPTX9Lfl+ze1cxzreq9rrI9Li7GLItu4aaE8M2W14dAxWUbdk2WFgONLQtr+6gpqMrfR5HGsndWCI7Ao2LHMbpa/ZLOUNNCabX3rSLYnlNHVIeXn0VGb1YbYbF1NM/xOV67Q1UgxUajPcNeYvQT6qXx7j/bxDE/6Okn0uhPNHYcJQPilpVG1nV61jVzxRpv6qTrMrqfMxO5KPTyqY3pHlNu7LcMVRqV3ZQ+6Jvsim1NK2lKo68TRRnwTx4x/zl/bOQSjymWQUSFPQquGvH7KiNsRsqhUxgqQXcXJAL2Va0SfvnBxdT1+Ip2hYkVo5uI29MfVOhr+EQQ6tvQF5zKnQCm00Hfv/wSyRf2l51UmgbYm2D11gAfoWv2Q9lSgZONfvxqf2QSbCEhVl0zF9jycuzINQ/BZlb8+NTc/u9To2vVmx87R3l32kUIT6F8o5ocGznxrxTU+J0hPE/bMAvfDY24XyAm3tBi9jjbaFykmT3el+Y2n3e5NfqguYiA3Q6REAQQGkhwDVvvHpKLrLmjVenKdQORORv1F4CFljCEHXPo9Fr8Hcwq5iGIpRZoL4gOyA6sLyUekTyNYtppWix64v4Y7aZSIFmdq+hTg83KfqX3QuvWC3aFTlFhVsjm4iDSRp9vTQah7utjvx2wdVfsnUH/+hg+cbrihbbPaGIPH9+8DMgnmRLtUMD21zuvdcWzeq9RPTWQWqb1XD6p2teu8Trj1uw4jOLpNltWza9AdPxmv1IOMCM4U1MpldHyN4YHOt6GavNQ+B3NLE1QuwKqgarbym3qYYcG8OaiDYZf0Fj+uJ2oRJp5U1K4GXzRDCW7TrYgYulAxu9xF5jVBAEIhpetJnHZQ8CdvPGollNwzU+3TLEojzxKlw5LMLabNrYnVA9m4i41F+Pj17q+7JN+rJ5UV/egjmWl8TAFPYNTHKjrlPp3/3rYHg+2a13fT+Mc0Vnnbj4GzHfhTguDW2w7rF3asJOIknvYf+5GyDzMF06mcrwdVslUo4+GApeqYJLnL3XpIXJ3gPnZKehlmErL5sF6LGCOxpiJtyGGSSaXrU6jy+evdfkJvVYZ5F7Z6N3AfPZ2Z0zoeRWiS8rnU1PqypmYyki19jqkdIicR2LXAPu3gABsJELJVcOHqVWg+kYF3oljhWs5wx8CcTrGFkc7fi0erXYtbcsKcds3pHPDtj3eNptW7//Y0otzN/6QBGUeNO0RIaz+PoNCXHZP33OTaWEcvBSKnGC2jNeYmLAfI6ZQnGFUsu4vDyt8rHFYvUvnVRerL4xzcdtx46Bgjp2nDJvZRfty9i2g7NvDP+ofLxtSpeViCFSzD3rjg5Xa7WVgA2R02e3VsxL6bG0bTQUKq2Nd2veuJXXAeuManVGvs6oTpnup+fcEQZcdWhGQzgqsrQHshxLqtG+mnCwGgZOzgdCfhuFeC7c2gnrr0vIxMDrAllUq9/pvL2oUB61TSTPMQWRDw/wzTqd08qzldklJ6f1Dfnkafe6iNzGGdmW7b7B9dJ8HFuLQ7E7vfYywgnRdK3tpO4Lt9rQfUHNuviqOeY/uRAuCWnHsDtj+aQoFT6rZmH1cC/fMUXAkrHp5N/Ssyl24XXeIjY2fS6Vkzhmo+wuQy9fuxZ7p+zRP/OwowOygbLbgCsy4IbW4p/1xTh/x+cMfybthD0H6hyQdH6OEPgEGUhszgbN8bji6q0snPStgF07P7gaf15bq2hbfo7TeQMfN+cT6LfelY9x5lafba7fwNq5C/MInGWbuXJhgDo/eL2cJdrXxVMiZDQfqzP8mhKyHccTvpJ34WE0rbJ99HHEfd/6cIVDf2d2D/v+M/kE/nmdzDfXYCwfZ1bx8Lo8tuOwvo1PN35Ccu76Bf/pOXe4RLXI/sA8f9z1VSI/0QnEK0x63kEij2mVT/i+TCMIdlrl477AqzvUCgiAOvrOHxEEyaU/vny3Xy/dfhO6PWnHbDo1bW6y47um7Q3FmFM2m93/kx7H4BHvkQvRtCVUBPHTQLzE33v09Ly/Gx/0yjWDWxC/7WWJ25YpARFS+rCHmrbMPa5n77Nj/5ZqHmTVRmSx2xf0QCh9gj354DyoBs/6xPW7hqEre6WwZbX74LyrthV6ypJM7wmsnsKrY9jIPJNvC4SC9wb5BLiK6/DGlTsB6nsll2u3HbPZfTdM213F5N1F5CTn+5Tt2knb3f9qQOd9jQnAjVsIytk5P9gT5JMcYZCv9apWd9T0+pm+9mobIb87FwOseDmxxw2n7SirOca/h41sxSOmmMx+j49OmHwK/x43uD4MFTgxBjC3xU+WIpe7FafMtrm5Iupl96F66GfWWvbtIGs6ZGS59kq7B/jwfmPHLafKUCOz1k5OKztho6lpZc+x0ZRfYnlnH98RqtrLv7cZefe40MCCzIlUup9fjuuCa3RCF2Vvt9SpjROmZTHH7s7ex5eOeno5BnoZoMzDfco8KG0eJt0d0X268XR5QH4/yN8PLfkdyhZp5X6d5mM2sRO4mhPc0LiMDwT+Np6U2zjLx9txWu1EtYgR6SAj7hqLYI1WntogbyOi2d+Dez8uqm6nbNdmvWJkNh+tbjojN52Rm07iyvEPb7rI3+GhcIJBWi8gN12wqBAyyUTynJd9GQjHmw5XS+Jv92Cz3yBmflGti5vV/vXCVDcdnWfVJrMXXMbG2bxh15jdi9JQGHfhDAFWG655RUcxvNsDbgHwAqfWOA9/+twGW3KNoH8co/m4jd1zXTDzQ3b8bjQxM5UPAc887tkYoQiFtk3E80loU+vants4G9lGipBTjZmn7ZMRzM2ZwkzlTQH7jWWTbiQ+NcJqFmYYd70w4x57h86H0jOaDQy8NswW863bMTtuk6l8DOK1uK399Jz7mNrqY9XbuAcmB+4BZdtbOtG0yicpgAqFeehMOeqJe2DH7OSufIyIi1sYr6i2Ua5e4R0NT2RuoHNBpbxLovJuEVycvXHBdIuhTRfdHSFZUJogJHx/fLoJn+cxO44Od933XY5j0navnyqxvlNsTRpxIhxDNMnAxEFzB603tOR4e0omtU/KpbD7Z/fbsVcP3EQhr2JfKViN8PzgZ/DndUtuGVptQnAc4fnBa5f+DH6DrW2rX0E/uag53Ha+OVxrIa+1kNfa4PERig4WVxv+7lnyO+5dtsd7twmB3DUup4mrT8KExBOevnWtt9YXTdcEV45YY4E4oNtTasfuJvLPkGteCXWKHdpGEJjhHfynOcO6D/YHQL0z1ldWYp+M5yD7e4h/D/Dv/dp3eJ+WHt+jBQiz7K7pz4kZqPK4nyK+fRv/LvDvHiNzdFQD6j2ZRZS/F3j9Wsqbx9mBE/x7lH+Paeh/Qhzr0pkj7EzXJu6Ga3tuCiEOJDtPudZ44jva7yUuWU9+uC5DXrIhL1lUzL9HfA9xTTI1xp569/bJawdZ9BD/Sq/uN+VcGT9XHlbar2rBAGIuLnzLO0RubxK6p/nz3GdONKLMnhG5Jl1vnNo2lbeZqZ4FDDO63vrFx3CKteuzVwQ/mw87lTe8LCjNRiQmuY+K2AY/VwzZRo+Qpox0QsIpuKZtISbvXNFAVovENWdhopnKEzvMxB1D185emze8aAjkf5VahsRKK1Bi9IjwxOOQCRPRu2YvT/pTAHfzXj5ErULi1oFjSty6rR1jh3BO//nfPBte1SGXfbLb4wXZgM/Nfv96wORYMqDgR4yaPu+mXcXY9JsxGdeE84jKHrNj05ycBfDS+LAbTN743WkO7N+xu5mjh0nfCC05xVFPySk+i/q3TjGRqxbw9IgDbbrz6HOzRbae9kUJsVdNwLe6nEv2LpJozPInXzzyS0+0iohzxAmqz06JkpUaYXxlgaBoG6iLE9kONrumw2pt2DEFmymx9jBtkZcuARQgPbVmplos7ftRUOy5zu3z9NMQ5P3GZdTCUAcQbqWvDFdJTat8DJXjpmDWgn71jIz0nQXyzXU2ZDzg25Flwi3EvUVN+zMigpq+FBCfeteHf608QI9GcgZEPAP4dyHm6RGDqcSGjWSTHY3ysVpvAQDuDkfVfj8oTXBzs5ojkd+lh6J8HCPiZo7ySdt0X1NAMIMHQ43Fj2x3W5FMFdodV5d3mEkitk04Thl6mwVkekhrNr4+H3LzNr7Ozb+BezGCdbii/4DE0bANzraNr68wvGs7McJODGbmiqi2EyPsxIYdnrNDuAuCcqoDvxUjkWJbW2sECWpi5S1JEtm2bfKkOz2FMQNMVBNHvgAvDy+OhO6ALMFeztptkZ2045A7cNBF+Voee1F+Dla3XsfXVL2OfVEP73H5WM+eKPuvXPmw+mFfVHAN7omKCcgFoTsa9uw5lk0cD0kAYbnooV/0MCc2LQJvOQ8x6dsM3KCS3ezkf//gVwRAfIsNnNCrNTNzBJk4HvT6nM3hS4WzcUcD0MwE26czxomgbB8SItoP8jExRC38yQe/omXWD4e1yo6VlR0Mq8oOczBHysEcCqWyg6FUln44P5exDdJJf7aEPXtuP1ms1LnQr3Mv67ytrHOPr3PB1xm6A7UKqk7t61dwgBXcX1Zwj69gX5iPIfLlq0rcXg7LnNQE8Eu5kucHhzlFRwIvwLH0wWVK+0H7GTwYoP4QkhQJYcxOsAQlfXSLtd4fgBBIFZDcZfH3Bfmk2ex225FZW4aWXimHWwCefrzuykF5zU6Kc8yCNLZYIYVpDIpzOJFBsbb88f6DChoFI2S6h6Gx23A/jttJznGAC3LSjiKtqFNXgjv7iurxVrMJL485dH+wPtznCC/SfoLEuFaXZDEtUABgWpoQekGHnqU4YVKMaI0dlxHt/bjykuh6kURtPg45qa/uGpBEK25f1Lqna1tw62ckZX1bp3XflbFK4g0G2mkjHdUZWC7cQ2q2slowhqmjbMut3U7x6Av48Xkx6fNqRh5fJdZC7TFwBntk3PnEBYX1YHKZKfCwKVEH8mR9Pshp69k8ssu9Bh17Sscb0QTi5oDRZ1yMPtQLdNxG2Hx+PTQhcnr2pd15D/eHfzgTaonQqDgTQd9mYwO3YSaPTv9d4y6ZhU/7Fp5sb0QyI1VqBm2J1F0pNaVwkNM37nqZ6I3A3WxtJ5sZyAUP2TkHiNdGgHo++s4/eFptO5MuscrmFXPMaClBtgjXv4oKBrPfxtOt3bumN96Qx2deK0YYT7/vHW/97Cce/uJv6VdTupYBBKc/5yW9wSO42jT16UqnlY1vgHFjivqBmmiOcOtKuK6/UyvTTW2cfigwenfgUUDErVEv73B28NIb+t4ADx5UN1xDB+xzkGDdqqvlta5/oeF90xrilRY55H8Oe+LyGNGGhG/0FUUxOpISRDtyes47Jqqr7anc3dg+Tlo9h0q/lewUD3Davmo+/g8+eFC9RuD6vKE/cr/+LbWdhzOxTfQy1mooU9ybv6XoF0ZvXvfmkwqa0d/m2dcoDMfPG4G+jhk1A+I9Xijv/bfCpAiog8/KWZsFxoTPAQ2K2irCngT0j7zbG992/nH6PwJjxBv8VOu28Mraup38aLlu4U1WTb+SYUeqerH7lkKVqboXGj9Fh8Ty60G1S5avchhf2HwDlrD62nhruYgM0DmDRSw7U8UcVBm/n4NDTlAj7hMnVX1dT34U6zo9sK7fOL11/cbAup6orys6hCUtDKcoWLS0NafO7lvg+TcwZQE0gcGAa72fGoXf3mKDXYtWtu71/mD6lNFluvsEBdy+W5FElHB/klrCeKNy0EGcl9sNx/4tPEsTQh9Q5OJlYnx+4A0EbiMsEnK1XclLxKdRU1vzkDfzBQr52vbcKiAySszWyp18MJgT9SSLEVDNPYycau5f4aRjMoiFd4tjQCBgZFV+4bxsnakVmi6btYFb+0bb7O10yCZKrBY9m0MNuaDxY3zdziKQLkpCq7KnyJzmu9DPXixVH8T2h79OWmbB4v15DoH8cg+5G/C2TEpktR9TPstCpfjVzvSGYqWNCYOQu/KVHsXHvEr7Dz9q/Ae4Faf3E9BDYwpNlcQ4EPyELTK4fq5lBLWjYJm5TqB1NTtNRsuUxQkbtF3el5w7828AjdZTMTP5XwkCh6rFmWCgXdwXBArQUg5dEJS49K0vMdl8BL+qvVpCp5FQaq/ObtdA+NtkLgeqBqAzAnf+JmPl2zWW6E7MBW9gKUe+wXXMVXL52poKHWjHhFv7IDCB+IU8P1ZLQyFMaOc1ZdI6P/sn9Vz2HkG6Y+YDouJtUFrcRxB1l+0zvEBRZUFg1dcJSk7oL9DQX6ABLtDyPQS4M4Lb36EsPluE1DWzlgtm78Pvb7Jju3ZRPAHWEhgC5MB8KeWdDUoX2v0A7fjupVuZGoIdqhfrd07XOqd953S9c0U5LAEU9GlZVn7Ru/vDNuJn0lK6qw8rqOvQYSLsYJ3s0JZOq92R+peO1oaMFoVKy4bO9ERprrM7iVAVblCGKhbOACwHyiMV2K4kauhK4ptw1hFG4rIp0DZQpxoC3INaA9Rqu/K1C7LtctwpAZtgc5JBZneaKkM5GCaaRzwVCAX3iD90pxFaBz0l7stqazhvdQSl5fPHiNoKdwm8AYeOFt9KCQ2Za4dEwO1ys1ZJhnGiPaRmhy4J0zANwzBN0zRI+V/o/4T+W4j/VBilWgqGhj8yx6Kjn7rCRB1TM4WayrXbDTCcqTySo7Nf4EtlAaDGskCQUpAxqTMUH6ikUblOHfOPYazK/eCcC2aKZCrv8KyxSA+cTBWp+2slaobUfYWY3Kl7Aqi99D0Nnd4xJf6DDTjzZB82bbN0Q6ka6SlPemqlDaUGKE/wQ0h4aimJEW7xvmJEdstKbZXNwDgEw9HyhO2yfNn88TZ1R9TsUB43m6aJ/3TThFrrZsRvAZ+HzWbMZDsPwbIJVzEkaQqvc18DgmEDapMGnB87TmW/T3yIN02r+r654Sc6UbuLGr6q59wT9JCIne25efdmk92u18I14BJlber+Xm3txPLVyT8XMsWx/gEYZGO6NuJQidznQAqL3tckFad5myf+ONKO2demejxH3QbJ5/O/FE2u7nNqax7ZhPls5GsRXaKupDao/303rkDuPLFqClmxKrWl07HK/S/QTbuRug25ki4KVh0b8ptQkjngRmFXrqhYjWCzv5g5wp6NBDI0YTMizCQC4xHzx7wENUOmUddgOjTXqnJ8Q5odwSE2rfJRp7ijIzmAMoEIc3qrVW7dFXOlfb4Smk/7nihCIWw58gecE3EKwTkxWr2qvCLePExrNKncz8+JkVHc0k63P5VjGqn9DN772js1iAOpNYIVrwbZ96BC1dF+zq1yLaumkMGurAS+eatX0Z9vHm6trTJWwGc3r5Bc7ZJDGCd5odw7/+DpR/X2MxmPr4tSutqfj4iTXxNdG5lu7YZzyf58NNhsR+34rnzkzKsGAzsy/a4/eBoahEfP+Sl+bQGuwuwvRqfn3/pa6NBbFV2i9SvoKWoFNWmOylA/ZUXCzMowIoFHvBZ2v0888bWLt5/FGrIuDtxg4DjnmeN5P00cI3Z8dzFqk/3TJ/Vbionp+be+pmPsqJ3YlY9YdVbNIXVKBh2kHZF4gez8oHG1eFpa5SauRRL7ZM597Tc1HDnz4dq4TX/cw9dZs7NIHEWtsxq4KQee+IGbKzpqet4O7y9G9xQTduQar6TB2IHVcdONZztops0esROvFTVLf0RXCBd92nXWNk1NYUqb1DwGscJGMpvtyDQcKVI7YqP7itG32tEb8lGY+immjOYjy91CP95p8cY7DucMsXY27MiPSioNXPEj/opvQMRYA4+IERvDIXLUn0wdnHHYyQ07akeyD5iLy5fx9YPm5YESdmEUasSGHbnI43vAvvMSchdkQ+DZ2XF6a9EhgEKubJuCm7kOaUmUXKrANL/HkMtrw67MhMatM2A8ClwXG1QOSSq26hI1ZWMgyMZuCthYsbvH9LIPmUK53TPENp2f6SS2RXSRkOYmpEIWZwlw2+LoH83M0W7agtLpOqd30g6avV8zu7ljtvW82W6m0kChBEdYRU6lnZC/6RTj5cgiP+CEo2uezehYU6tNqaTZs0SJRocRabK136UW/Wp9j8vu4sJGNxp1KeS0m6YnTaPWJG60iG018mY7SHE9n8GVKrV6RwJUg76dinMkw1iyj7uK0as7DSE07PGfmOsAOLENWhdaQ54etthASmocF1DC99e8yobNaW0K8EKzR/DtFYWhIQoQvXwotTUJtNDkiDiaFPID2BNPHxhdaofgsTSfD5EioLsmz9QEAF2LmLgxnDbWKTtERMm9WiAlXw24OYKvXUNcCTotFjq732COEdAdTsFEjiCU7VOFkcw9xEAFtN41ZfJgoieICjm9gnXSpc5rFIoSVk3c5ygbGYohhTgZe7lK9ATecMwg39n0nYFuzgv0MJMZVvKZ5Kkx7lUzlTLGBXPiREzvtuXVFjy53Ue++Q9/E7xhJcUGrDOAfCvR7fm7ReGyEPYtec3CcHzeyM8Q91eJZ4AEDqQWMGo+OxLT+kQ4pjvK3XWrZCKhlEufA2pOxCiC1sUPEvb2Atl51wraer+cDah82kJHJj3LQnBS2CoaXKi3DWZae8cTq32Eic4pAJyEkneDUrPEnhGkbNFoYU7FzQ3IfMjVADos3yY2Smqb6XGjg3nPw3eU++x52QNG4CLxgJd2+1p38A7dW/SDe3JxUffN83Kdet8M5OzF0GRq3A/OdJSbgN6HnoluooyUAbOLF4MaxyuU4S6cEbxAmWuBAnIfhWCRYswCTBu4b56X/ZGkonEfxkd2Gov15O2gUJREVcgj16XzkbtPVk3UBB75/4+EEtcb65MgrMNRbEgTT95eAlB7BH6E8GETafqBXMKAFKl0k7H45HPyUXGJ15nWfYpbOn2z1l4UMy70eSJ2guq1V9WR8Ld2Ktotk4tDRWdKFR2VfUG5NWXKwhmBTazvQ8nqIHMd2HAWU5D+H6KytcrtuUNvnbPK7fP/HrjV8N9D+De92VA8gmLEnVRXIOBmULWr3cL8nFt4EAniK22pJKc52b3C50K5FHrVnZcozoKLr3cH8U05w0yCC5vn3MLBYCs+HgiuIghx/S0jmKvXu6N8q6yjqtQFUo2EN126uFGmRndrrnfHl329qr1fX+hzz5xDk/J85HQqKOzMU0LY7zJRGsBQD5p0ngAkVgFJ54dhSqKX0Mnu1nAX/dpwOFf+pf9eXLnKB8d/7E7gBZtclt1t7qXUqAuqivtWMsukTKWt4G0L85VZ4/ilNz6ITB3pL4+YYUFAOawqfBJoXyN3UY/+Qxf38jUg/XKLUcKmb4FNZ3fQuSbt5fSwvrxoluVsE1TVCkvtagvHTdHiiAQQqQUtpsY3fyXI94iqBzijXW5bIMQWfkQGtZhOPy+Vu6Flm1A6l/0oWjs6iVVcwKbV2SOwR3diN59nTiPEdL25/AIFpSLiRtebywlHJSdmpWHUF4iGEa+MuACnJMBaYl51l0NRiAPmAqWKLqxeiXsJsZXFN1rnMRzOrisS90t/Hs6JFjySi4mDSWx7Z84UCrp8314FQ22u6y/6C6zrfgA7MuLNF0vXt0hW3suLuOoyfvE+ZQf1rGvRXIFnwXU26LmFABDBeQcDQhJGqkFHOrETrUbHSkJ243Ma0QNB8w1ZT2ouSQ4dQrw6ZTuzece2kXNjZ96WuPhHVS/7mCk6UJw1/OymvLsANg0lBi8VhGmtlZWujU1foEx9bMkGFcjYkguUWTw2PhsYW8MmLizHxfNmmfGAY86la86UQ2q4+Te4l1wvxhlRdV9ejSYvB+J0SgE/zhN3bj7E9Xf/pGbdzPZOs1zgLl6l/Sq2XaJHJu6Sa3vuz+4QMQ8BuQ5OhKLjid0UvT62dCBo0dQU2kzkBMmpF9jMBdf1CF6zmcL+FkwtvLVja7KPG+ldFz+hhk5LfGPB/yNP5cmTvzBXDMOxjdlRpsBH5G33yWae2TXwMxXvi74fxiJlZlcg3AvtfnqOILZd6H3hE0p/P2o6w1H/39BoNx4aGhqN8cVEwehoc1SPjoZKkqRDsZ0MjaajQ0NDTM72l2qm02yPpBI7PO4+2WxHaf2IqevFhxpKmyBcG8VrSZObLQ659jn1L5Pll/suClR7ovz2Cq3a4+UXJNAZq780OvDSCOKhAXbWuGwqb0APuzNH+DOu4TX5MODQ5yTkfHMxDjzIYLMdxgU5bMfvxuwcvZNLbRNeFePT3dfkTTs+He7Jx22TR9Zw3uT7V9P+BDx/WFjC690nm708cyZvQwBeI5iW/VbEbIZWkjm30deevCYftuPTAWofFltE3vS1AllujRyPyIhnG9umcqZJl2ol3jyaVnb8hmL8ooBhn1gD8doDnjqfPIon7lNN98kmI6eK9lSaZ3bcrsk+YcAAjjoYTdW2qc4QkSx+Yc7GdlRsv2VTP+FDHtcUzXwIJp52G/LS+NXsIfihsn+pLEeh3btfYvVU0axO94a0UsSQShJkeIhJhXA1pbiE/TNMeA1W4z/aIfB+nXYrhUzKyqFD4y5xFgeajbNDRhxClOTPQrd/FPmzmDxrkwHWWoOfU4qQmtdfC8dLssXHEIc9m2QPmQL+6EWTMQYNq2cvo0dWiPsLyaiTXqEv87xUs9NJ3atwluDETKU7uGiyQ4aG9b63Oy+rzbwi2SoQ+qTNJtpsot7Earo0lc8fMWXD2ibC8VUt4DR4A5rpEBGzs20qh2BZW8sGe6Zs9LJgs+3Yho2tdj8w/P04C9SVnQTqCJmoV6qLGJQ6ljcx51Ab1O87SnktXG/UrVvVSezIFkbp0u+372zd8sbG4Loe4FWzj0skr5fpWmD3m2nqn7Wuooaj/7qXH6WkSttJinMavRnCJuiCfmx321ThPSJte3ZHx3CUDdvG9HVsYjs7QFGtHZ2Ak6VtIsuhbGbbmFLlNspTsIucQjyBNVFJuabtSjlblpOphiOeU3kK+9qr8iEyiHZIGMSc/gJEJrNp+t+0Dpi5Qjk7x/Bc6K4LSREbztswskH2Id2R5PBUIYwWEZOfBAIP4nMWigk1WG+uBoFBmKAyEQIVVp3WZ0U9PaeMb4fl2zbcLqV6AhI+K1lqR4FdGpWp8USLOGpNb5MZTdP0Z9nz9YaJ7+40nskNytwpbp5SKL3krmB+jgDX6EYcbMa1ri1obJLlMbM7psRCE3ifSIpiwgKhtzr9ULisCW4Zo5x2zdmhNUqbKAjjpNFspe3OUDcbXpMuZhMqTP7ucj/9sAGK3LI//cjKP53+Wy5B8nNkgSwLCG7dsu/+K73iT/965Z82qhV/+iF19p0504GcUeXfzgS+LFAvr5KPvWwYiR/eok1A/1PvNJbBFU3R2N2/aJH5srVQRNOt3Tfc7S9c8VB7j34NImAgGounz91eD+DfhDaq9XMFXENn/Yuw8Ig3qQ3lmk53CozjgvFwQti3l1PRsXAQ7D8PUehmfJb6BQkl3l4EUzTQBlt8Lkbgt+HEMawLueX8YY+YHUpARHhbp9L/Phmsmde7DMS8A+Fs0VqHuwneNdgiH0GI8at56w+7zzTzEavfVeiP5OeIvr3kCIbdkWY+gmvpr5vur5o4ReaK4al8xA5vySdw4JxT85F7S+3zjzOpqgXylwsQcRWSW5Bjc8QOy7F5dNh96jzEY88VyZS7ecz9zXk2Acep/8OUC8qjFfr3sLrF8M3YeMeUqFdbpVePpJJqIQXPwwZMxr5CV1L0f6CKtoXEETHNIBcQa6IYc1+g5ZlAe/47dIsomY86xHoFuCIFBTx2580Wo3i5rPmAuzPX/WJp3rYtRHe2GFo3Sh6mm+PySqAgLYV49x9tv2//N9NS/B4v/1QisiDe5HCaj+9/L8v9X5/6lLuzPh6KFWgAkYejeQCYIdvNaS/p5g08grLKnYf/b58izGsCjVBsGdgU7EcUfn4OpBx7TgleGf+IUXbtTbuKc7CwEjl2Thk59qOQM30VV+FQPufuIqYZCA8bFGOwpxo2kcywLJwwuk9TfMesgsADTGGcJ5i0HaL2dQqJJ9vunJ5r/hxUAJkdc0+rGRgekWcHonMT8T/bp3KMPLYNqG4QO8S0Qz7kKL0+77h5mzLkaIiutw2ZfpuQl7Lp9VRa4+4emrOdazF1LgRLEG9nGB9rlGBk7wQYE5qoGkDakwGAy0i2+CCm8akiKcU5Jo1y5o02QyAaxyYecFwF9BwxwbaBMq55bR64FuKZ2D96Xwelo67FkFvXFoDUSSHjwXeT8zI1a8fcM2oGz7bOzaL7tusrdM3ZbcAec3cZIUHbQujmwiHFkNmfLTo0VRx+yWyesumm7bjmtYBbSS4XiyqCbJMyyBbaZSooUpnCpk1+rshscu1s0dliU8zekI2RTMpsthkAF8LNnlI3/xgVOFwcaHoaNoX+I3UhnDhQtKPTf6OrsmkV3FMFUfkPJy61sR2amep/7UAFfn0xNDNlO3Zo+xTiYOwErPSoegPUCZPvyietfhdYC5jfOrNFU7LqTe6z+t8DQQbIjr0ikU3Hbl7FGUjFDbTBrhbpZURqB5l7C0/KycD8+HdP3vLFx7yu9WyWNvU0CNq5bCqPsZHiIrGNKwR8XvZuuZcAbeOeURJp1ZjLU4HlnX+Dm7dtp217CsGtO2zgfmHHXJFOIZq/7ebdbptOMVsyXyvSjnL/mbIbZRgXQrtSpFs6yrVoZIpt6lqvZ6/josPoakwk+t18Pe2YHWy0GNNYUh8kXviSfJy+JCpHqB1CBF0T4b6K8IboXmzbO6aoTvKFAtgf45XKgXNu2rb7ZzCM7luiA7TtnUVnCgrJNoS7rT10cciDyRTj0gfrYa3s0CxYfUQK49yR+AW7hmf3S95YIFDuDfsp6RbxrNOyEwTKzW3Exb7GxrPOcC8jpm62yMTViJqeDe5lcgdIyWyWeH5ls7BO2iHcg8Py9A07Orq63IaxgcJFd+NGayxgHLzo4Znbcky49qCvkAvQNXfmgfViz2VTRVNChXGaB5DcscQN25SwI7xwBa0H9cHJ88u860Vg460UZjdeoiZtihXmcQhIyUeQFyDEode9giTAq/6e73OiggXNYkGcupyNVL0ofBNL5rXftLTSdljo5rYpNNV2TeDa+RaTqzoBHu2A5iNvU8tC5C+0t00EcUrnFjqdTjVN3do0yYUQ2KTfMZlRjrUrYTmJbZz+bJEE0Nm43CLtnZLvtJqVcvaKpm3bpm37wSFbRLu8gDpXybxd6eX3jbbt1vTcmlLazEhX2SPUX7S5Jm6jjR32FsuknqKGBtilIfy/ZJdGbOTWIjO9a87JVglcellHubYNZvPYn64bN+eTQPeqvt6ZT/rxY8WHeMBi0nC62sn37nuXuArzYJ18LxVontuy8ZLNVc02VqXLq3XYmZ3EFbNzeUO4r0T2WIfZRge2WVJuM559TWEBeckXCJzS7ywvEfcfwVn9rg/OWXhTWiSVzq6x03sJfvi9tVFqI8lzioS1zjL1mT8fhVmpMW7/vkP12YUwVcXOILjfDrJoOLPkxGKOoM5skfWKeNYG20gd1hqyrWQ2fItFw5lZG1zJBukZ3f8lxQ1BZloIYsim/bMi7p8VyEqDSJRG+WuCG0mVdNSx2SlZa5wrB0LoKJrp+VVa7FLgympyHP40xHsnfTrQjOvapwXEBzFhoSAEKKunNplbNWNfQncH1JRTcMIAbEgVBhBKGEDoLthk1ll+uxrYM+49UAtcwI978fEaCvpgGml8e5W3I0q+eOjSYN3SpXUr2GQe1QIk7ZRbT5mKqASP6k3mEMyUcEGI3CEmjgV8CstmHzXSxLxAAoawJagrczHeY2zrzTZhwQH6+dNzDKn0bvzrzcYtEgmtNpmNAgF0LhBkL0JYDygccxFtMhf4qjPYxOdtSHXP2pR5apbrUkq0TzsH6z4bUALyQTWQtLMRs8758q1ClxOXjQcIyp9iPJB4IcTW7GTYipWaAfpASA7B80a2v5zQBfv4JU5/T2vxS7qmCASKjukWkQmyiGeLEAO7bKoIQ2qkcPaFfQ2SsiLQi1OaDWcR9C+OOvRpEjSKy6aYlBRo/1H93aiHIIrq7Uh8Q8NaevsLwJ6fKwkDR61hOufsTiMGbLtTYAS370zPX5R9WTOTq3v3mNXZfyOagU8TytTq/dTEISpu+2zZQfZJZBSVVMI2YI7o7EHDxMXv02n6/cztKJichfHOJdBgEjtDgWdK/7iho3mxwYWL7DLz/fAWuixwtXi1SHqqAJJrILyqYQDYYpM7GEZY/9tYQyhRL/C+K8ygIGFWpcuAOGGVB71uD6Vlxk/sNYmHimehf0EM3pZOAPiHMPs9ZPHVEk1AJ2qdClTPltDHqQTXFxHCsGKEYUUShhUAMlkAVKBfXWAK2LVEMPSxVcLeagRgJSnjRHxZe8qiQQ/gwgGBS3yodiB9ofxPF8KQrkM2ct+i27HsBO/3E++s+w4FLmQiDPjGxPSNKSLMk/XFd9Y8hGzE7EE0fSOC2n0L2k/flX7gDbbWwwRk/VeXdcrnAkBShrXBfBe1xQlO5jKgp58nCA6GoK4JRsBMP7Gob+AcAuSE7R0xXqwwNOY3RkflMEewDZ31GIAjHl7hBiXEjitWlW5BmI8icOFljCWC11dcHzLuQfZJMkFHSykMs1EEouM/nYmQFZQhJxU1RaQnoSbtQ8tJUbAPI7AvZmBfRI5qrW2AXBY4X5dexigVw6LA712lmP+dMpOQlR+SX1IZWYm+d453+JwlWHS1gv4R0MAHJwxbmfxzbZcxVcVsza0E4TxbeCdoG/J72i0/W5P+EJKsy6aHoSvkCeBuu8VITu2ZKTE80KZ72y1mZiq9IzTJfOhz4DQqgHPj1uEuo49QBPJg/E7lcc9UV2AycUwRIIDBndl7zBYZluYkwRiEJQRxxCT2PrUOxjlEjHNISgdZ8kLGhy9gFRDB4GDkZBzY53WJnIuVy0OXSS4bEoxxDWumBLCuZc1UWrTuyzH/iDXa7K6WHX8B9//GWQZfQRx3987nICPcCXgGkAW3nY8e8o/OIRlHwni1rqTbM6Lg23RYB2kaZkJriOUTKQ6Kjo3vK4boIA92a2hX3uY4DAwqJYmTp0h5hwtX1JwSSAbMwgDaWuIkirdIr8Z0BeKEEdg20qThh1zUM9KDpKNq7wbALfS59do/Vf+JbqM2ua9I32rTG8AONMpbrMy1ND2ffdqk4+W3fswwHi9IDqk+uydMxyvln1Hh3iZ5NTJyg8wbUgU4jUAnxDznkUDnxZaec5gH8BHherNHINleiWzriqeI5NmJBemDjAhyQfOW/XewRNGcNdsTtCf4rm0l48ae012Ui08jVJFso1M3QOGd7kalSsaHBQkKpLHR1hxNp6nPFJb9tUnPq1iBYJ2fluyELlPzbsZORATKPFsFjxSxYZwS1yEchbM3h7jo622w06o3VCGGBCG6hr5+y/cfh3jkWQD0P7Jxv/+h9D/s919b4/s/papEz34gnzc+jXP6m+Dk+omqMJy3hkXovoqI+CtCiU7S4iUXZr9mrCrhA/D91wk1FWc3R0WQ/QbOmzj7f5mMKbvN0L5ijQ8rze4wi7qp08oKDwiGdg9FJPFVN2XW7uWnc7051XSW1aff0LJcVkKGYxDmpA8HFD3l86fwvMR7qzLbAj77pO4x07hP+uMR6rcho7R4D1ziQUYdHP3Eo0CLUBr6zRXbIHuXsXH253DIjZE4vHr0OFio6tETUB20d9oge5Lr6iZ7FMbwoQjEfJs9ZWw8Q0F4vZkkRxm49mx2R1SItiaVCD9yrCBZ99hvmOxpU+Zll0T1kzCKDTw5F08+Fup03ie8QNbSBmbqTaSVZwwjXDcgqXrDNXr0Gsh62TGTZ/zkEx8+peCc2oQbbAv3QWZb2d8grxJQVIUBtoHEK4OYGsgzkH0a7mXNKXHilEdHNHFEgTzgKJaIiiX7jM6HBL85tEPZ3xq4y7excxBw3F3SjO3kbduFv43KPqvXlr8jAWbPme2doCrZjnCCI1rQGboEZs9q22EiDpEqUtzdqcQwwirj2kJfKlXVm5Ii3bazLxrGKRF+Eha9OJy3w8gBOZz9rUnxSNCDur4dOO4mzvh2eqLKTXzAQBMtN5dtOS0TEtB1XtuW9J+qFXpQGhSWK0Ykg3JSQ06qzbIvGQIg8MjvRgzA/rIRZTNpmh2p9WzV7nDDbgc0AeED6M2e3RFSjGr0EEUQWn2ZwNBm+8CROrUVPnpbws181yrEwfrfkMBdQzxq/yzZm/6RG3g5DcTPEwP8lzVyvGQS4bCu7AZTPWpySbxfVHY/zs9hrdJyE8hWbw8HbFNlX9dW99ImPZ5Bvw08fFZvSX8nkH7sNbOFkpN0k1nwDezBTvmqoZ8REDsDQlb0suPo30Hdy76iEWuRfVNn/6TZeZV90cDY9wCtz9SotIUNbMgOcXtMz8JmjF1CkW89CgegmrhHvXb2LN0k+MHp61B1vRFTNdNDO6nUmX0Gnh4A2XgAkb6YdHWBOln2XBHCxLV7bt9DOvuaoaIKr31WrxUkRimIOZFOtRE8R2XZe/QOSTdJkz1S/6j1piGAUXKqPoBbWmd/Z0Qm6De43rRtmP29GRg3jwLRUfijAAX3GBjVsjuitb4n8mmvEd3EhfRBxwH/J2quEOb6IG0RDeJSIOmGy7ri3t9KLx2kLqHBdxlOXqOXPW4Kne0LvCt49t5AHt8bllf+3xtReWXexI5wpm4fkkIRktC9LPcgJkUbXtKTuNs3YEdtUOfYtoQo9PHAxHORfHNczjOjsXAZemsSTIyYbyO6KBzZTe8p0bSevSP70LRNt7ZHTWu2J4B7VNNN7OjoylumAZ7cKKpvmzvEGK5dhgOt6ca3VWoHYUNia2adQbuxRGKDSzfsWChCDHPR9ORSbYKKoG/1d6QocQrlC6iBAuVS8zfU6AOyfcVi6uAG/3NtTJXDE0hE82XwMwEqwOMSL5jMrvLiLWBqguymIPsrGkR8IVJICPIjDJ1yj6iZTuTR0ETQk19nOgGEi/Jyl09QeJgyWfCbiHVOW3oC9Of47n5BbwuKp9VPdtRar47OVak4Uul9mpoibOlQAt1nXYTJDyXEx2QPBYzpgACafV1j02XP6l6Fbsp7hwEwV3UkSl1dzs17EnKtsE0os7XD9fWuXhGWU+8obwq+pP1LmuX9msxeJuEzHPX3DsMX8DD8R0PUvBflMPyoNnoggfNy2ySub5Oovk3CwW0SLdomVHFgm4gHu98m4TLbZNrDFchXKKJ/Mtxcww7jr3UsuTD1ooANv0dsLyCxfcO8Qr9YxPZlcbVbcipXBFeGhkbinSGYVJass6cY0TYtIcr+2f0ZAxyQ0zq749M4u4PUJtMnTwav7dRPaknobpO7CzVrvZqqflijyNz3yPIFJMtnX0SG8Nj/tmR58mS3TpjzpyDL71HkC0iR//Qi3sqfXUyRu7/z9Dh4d4er3t1E4OSXadDgtLLJDbSLkACTkgCT9E8DtQr59enuKCf18/z7Od3L/nl1GtTL0iAm5hKVWOU+pi5R8alJUp8ZSerFJAn/B6tcTDw1Ic0L1Oc1/n5uCW16ssVQs2+dkkQ3qOTMSFWXpJqdBIzKt0GoekVChWJd15TDUSUc41P25xr7zx18iErjgEpckZhN9p5A5DlTyc4GsnPkZWdh7dLjQVV/e52y7Up2xuk245ECtiAElWrdmoxYpF6CTOF+o2zCiTS2yd/g7SKycYtiIJR+XjZOKdKJy5gSJ7fEL0K9sWXrUQP1eKwd71XPPQlxG66ctmfbXtxOZ4vUvWQHfV69pMvUjSV+3O45Nz47FGijKB3L2ARLT6Trz6s5QkC4k2puawfmI1uNne6HFJS5bw8rr7WD2FZgvT6Pd4hiKtHq5SCr2SzHzvGqcrxKxgtlqepHXwgYu3SxL8CXXbCpG8Mw6STtf/YqCOhp/Q31YW3MDcEp5JGkOtOym4K1UlbU9yKeOJV91gBaSBFfKPsAdelsojrxGDPnjzxjAwjN7hHIvv2zzJ+iNqkLLzUZJQ8qGST43sn2L3CyvTl4efBinWwgxF3fNiHqQUL84HeAEJ8KNDmHfXVS3OtJ8TbjSRCkeJzT9lX+/UpJiodXI8VHhRRtj/5TGPikkOKEJ8VxT4q3cfL31knx0bMnxUdJireVpDiBuseFFB8VUvwqSfErutpgFn/OxZ/Jngy1JMXbFpHi0TopTvjOnktStEtI8VwhxUlvc9Z+YGH2lgDY9jBUR/jQYFZrMUbXu7QevnZCn/0pWp4+b6vT59GKPveV9GlMuDvytsu+h4bYU0v6bFf0KbTZXFcj1NY6/zRFoClirt25PWdAsSmzxSMluR9KS9J1p0JkLfm5iQ/8uSk/e/VrU35uCLZN05fRUqYpZRpIWRfSLUK0sB7sSEN7fS504giqi21IM1K1H4KB/dBmBAbLz/SVjzYG4mgeeqcAJbnGETAO22d68ylkoHIL5HIYiT0Wn0p+5g8f8mQGnoY/3BuexRl+Rod2vPJOiVc6tF3WP6zFLGsGzmiMYKlshJOBXdCzbCn7us51dlOQx6VbEwWv7G2B8051oVDsmRy4ZtFhWzqQSONqvbHDqVqbfs7ocN69/TfA3sBp6TdAJd1UaN4IzRO5i9cNQquU+/J57uMWgLTX+Vw3U9lHTBGIP9Y8EWUF6Tye6VClTZk5e5DhyXvu0N4eiY9uMvtjeC4BzKh8vK/2GMD0R281AmpOzHhzHQCP0I2P2+wjXmUhrREq7+ithpZTwCGhpAQXp/hYNnDgVlM1cKj/+FDt8SRM6IJWxYSsjYu4KsgzfZHJ5FN2kWmkzFyNCc4VZlGa3gM3DPYs/TfLGU4DS9e+QOynvxRQH/CZLuwyDbi9wsr1y0HflvpDZU70oLofJV4dm1jTISOt8N7p6zZcBlZnfylTRAykUg7F07XfNZ4Zjy/1zHh7cMaeGb8anKFnxpPimfGRfyGviyeWel08s4LXxZMDXhc3n4nXxdPfQa+LX6PzOLwuav4WN5vUDv3/2NuiU/or4GxM/2ugaeg5Wr/4DvuL70il/PNCSrY3yOtyy6Oml/16cPaawCM8Fg8bENfKmsBk5XsuWaoJPGJ62ZNLNYHrzaNmiUxispsD3nV46envlKtCf9TPLHsnHlleD3jU6wFfNRiBwNHR94B6lD47orPbPezgvWE/KuEUngtvD+i54IX3ZTwXvmG0GfRc2GTay3suQD/wM5XPwnrzn6x60X0Wjik4LcDHxzstPKagX2g680aY75dxXogXOy8cUZX3QlO8F5qV90JzRe+Fph8SIJBO4b0Qn5X3wvd26ouyU1e1o3+bO/V7S/aiLNmq1ujvLdl345I9+yLeh99bshdlyf7pRTwYRS9+vL5gR/2CHUP1hwb04o/x7xHdy27Dw/tX06l84HT14sc4gqP1dfvA2SsjP8B1OybrNqgX/4Dm1D1GteAR7Ue3rF78nbKSxxat5KFvVy/+gbrF79By69mfjeXX81hd73ioWs/jp2Pxe7xu8bu9svi9PaDFj7pqWvyEOVrO4vfcEouf5zlfWIufHrDU6Rff4regYfITZpUmv+eU2PzMGwfNfjZ1vzBXKHdEia7qKBNm1Qx/UuX/fsa/T6tTW/++d1h85w+L0oj2YhwWpS1qIait6HG/oieMrF7NFvUl/j1Wruih1Vb0kdO1RZ3gGI7XV/SRs1/RR7iiJ8oVrduiHpEV/RLn9pj2o1vWFuVX9MSiFT3y7dqiHjmlLerIcrao/hQtv8wn6st8pFrmhUCWuTSprMSWrWxSeXyxSeX2F8CksgqfdtYmFeHTTsekspRHO3uTymnwXotNKkdXMqlspEkF2nrGPQ1o670yp66tD0ttfdejZjAISg18z/B9IFZwFLGC/9Or7jfWcgcAVNv0Vfd9jb3yUYcNJRAqERXowlFMwlko95/uRdRDyDxOLPFEvfiThvpUlPutYJPJCLPPr3cFOOrBXQir8dtMZ+/W9/jMg9N+UfNb9jtBW1Mtu75s9Y5obcow1I1EOUnXV+wJgmW1aOS+rrO7A2EHdHmVXbh8QYnJWFpcyNSn6ujPsVyUEmCsxVbycT+7SM3AzeY+9pD+QaVeoS+3yj30kF6v1CazDcen6jm9031kxBFSJMzuhesf8ncKMIByr+jxj+vgpEB5q7LfDfgM+Z1M9nssjskzsmdf0bPQnS851LJedl9/6+raEYPVpcViv5fGlMzkfRgH4aUE2cMGjMcKXWOGwKcHmdjRCEzWy+gjRhMSzLwL4RyZo++vPS4zAIUSitz/pRY+jdxp7qtlU1raWOuOKHcCDxcW9NwU1opPn1TuHxWQAqD73zLI9uKAAzZ4uMkDg4upzEgaJFBQA7gv4HF/OSh9M1T6n5RsggMaCT0s+dmupA/MtkrSZ/HsNH0gBI6CaA5KwOWsIe6BZGy1O90JJU6gpifR3P8j0I2a2pbRxQQnheddnL0XGJOt7MsIeEx9uPdbA6YXAN4MgbpVPzm19KloCrJGv1cwOwi6w81Mn0FjRtHwnF/DJtUCNDlA2/S9b5bADfhUG0DqNq5WVWqbQHtepUQTM4AcRNZk7wuIkx5n+wJm8m3YZh4HiC2NrwiBYtTEUFlN9j6uF21GLdvIvmg8E5z4rwyJUmWjiW80sW00CkC9Fm+R2e29vIFWMTcxTpWbTd4pXxvyrw3ZjocqAw6cWG5AmYRPIgScZs8Qzg60B9viuS6q4fTufjB+Y12ZKpy+uTCjWQ0tuNrhz9dm9iVtm1TDQycByB6gbMU22TbFNEu0J9ooe39QxDQTZV/SnLQ7orXEdtQ2KbX4zBO+g3iNMYkGhekuDICfA4ElYonHh4jTC5TcLjOSsdCDIV9FRBmdPRXUzcHprw5ADFQWC6rvf14gBrRr+UQ8AjEQCsSAzv6LEYCB/xIV4QDAgAbAANGhTLYPAAhwHSWCuQ3gevmOMhy4rdOsq9L+Ju0KH71WmIo2ENipdDpeHrjTL70oeB34VDlfj69Z5nz1ChXVk79ukifssf4Je1j1gFbEIzYeOGLxElm3sz9jj/sz9mzuCvVdeFecxhKo79Il+LtAx/Mea67q+iEv7qHvH7fS8w8GeUKOdh9OineTQYzMvE1Cck4N7rvw5cF60PgmY6Wk+z5ZDs/VZ7/rwTfClwcblymxESVSrtMGIOcBVq/n/DzBd6AhLxVNydjhvu/KcPNKPWlIT/D2uwFCV7aSfajfiWzxj5i6DwVpESEdJvB+n5+9d+vsb4x8IO6RgOkksjKtfl9BpLW+xhLH/W4tfZ4hS3BY9QQLCsko4fUQweshtlG/iSbu1Iv9YjdtC5EKdLpE9zbP8sfsw4H8y2UmfN2/wZ/N/TWOabHHH1WC4HlYksMM1TWCkr6YezFuobGUe3leprvRAKfkRiN6n/d9Wr1C9a91Q+YkD6s8hzwNzYpcjjBWgq3iQkS0f1y5p5UNp6CV+phyT/GzRtZx9wV8tmibjM8nlHsGT8D48OnW9HZdBbFXOD5tAbprELandBUKQR9BnVMKhFNCScA9AkrRKQ+MVwj0tU/rUCisl7hqkSHkRQN/V/BScXVEx6UPUhXX9L5It1ZkeTpUM9aZmYbAvNWZmbjPzMRLr/q4mueGh1+yDcEABtpTxdA0lmNoVqoutQ3P0KxUokH8MYLygW9BRD3YipuC7FNMLihMRAkAxyKaRfIEXp42YQotXS9XZ/2QxYUMELm/SGAYG7O9KoFpDNaoAxZqyGPixjYhVh22bZ99Es7JI5tIUHmz/6DGO/UN50MYX9u2a7xTW/KYpkjnRd6pW76W+dcy26VWUtxdmuQtieIj4e02BsZdLIzqhZBmO9l7gj672G896bNgXHuhsvpEAMZQOOFTc2XdlZjhZRvkMiSCd5feFsrlsGBql8MJnGcn5HJ47LzqcmhYb6KBPzS1B2aeSYx4JCdydPX9XS+GvQlAn3zHfR8NTCf6l4A/oS8KrhY32dcuUxDnLK6LWI7gBS06GZ7BC5pncFNeK1oIJ7NxdV8s7hyayEpPXCWe7OK9XTXXvzYuCqy8sX5xGVxxuD1iuT2a4n/tj/ZHNYEFQaXA7ePtkda6fkINdD2R6+NRH78g18cC14iwvXJ9xFs6kvenaqOVejaC90fL7yTl/oH3x3H+Pab8DYIPvEJob7sOf17fv0IS3B5NuUKYlaO6Qg76A/doxbl90nNu/6dV7hOec3vtIh6Nl9fmWTfKC+2IZ3WKmE9X4NLo2Ez6EabGU1IoD95K0kdx4ZCAcRdZhJf23MZZ5que4gaqGJ+jnvF5IbVAbw++TS3QA6fSAmH7f9lrgT5ySi3QD62i3IGv3VL9Tl+jQ4tJ+qifnX16MWdOdqZkzW/Dl9v0qfQ4v8K98Su65M5v0xWT+yt6Jfb8V/TK/PmDp2ByD8paC9yvSR9frHJ4vLx/3x6soHK4va9yYIaMM9U63DKgCAhLRUDpcn0mWodVqvJah1VKnLHWgX7qvG4eOkPFQ1gqHqT5lRUPtwwoHsJS8SCpSlZVPLBzy+sePtCX0pvL6x4afd1Dw5k3Fg2oCBo1BQQeLtFBNKmDePisdBCocFlFRHNlRURYU0R8Q9c13ekfax35ISalIiLyioga3qEu8Q69MiIu8Q61xzsMgHcYizoiqKsjAHuqiwC0wIiBUPI6V6i5BL1lJpjIhunaEv0wFg/eRRiIUFwQFy0pD5k/9GLyiuzEKqoKMake1aWcfKJ/hBzVK8nJR/XKcvJpHiH+2jvLA1F9lx6Ip7MS6rt0JUqNRWW0Zd+9mXBZjcVhZPx71JyGxuKwKfURYnJcqrFYXGKpxuKgWaKxOGzOWGPxqOn1W1mssRj4cTmNxaOm5AfNWWgsxLfLLNVYBMtpLB41p6ex+MRqGouDizUWYrst2c2PLhag6xf4GQnQtwzIs+WVFVf38hkK0KtU5wXoVUp8pwTo2wcEaBzVpytD15mBMxCjS5d4ZAxdVYy+ZUCMDksxWjCjF4vRVQSLzEMpSHOsy7Fd/X4kfdaCCigK3s2yXJvZa6SrzYGS/N0zLhbi0O0DEnjFGJ4eh1JK0wfqB9c92BX3BMtL0wvI9PacOSNpeiEoheR7glWl6cUFl5Omj5sl0vRCcLbS9HOm129uBWl6oMxy0vRz5cn2nDkbafo5f7YskaaD5aTp58xpS9OfWFWaPrhYmj4wcLx9ykvTlRK+kqYp/Zfi9CG9iI04wKv4gO55ifqQrknUB1ZkJOjYskikRlVepr69kqlFsBYyp1iN1PbPS9YHokHR+mDlyMwb+jGfRceWUYGGUYAMkWQwoHjYNASEJdfy6d7QR5oA9J47PbYJ1t0waXUD/AJDCI9o4kPKUZh9MnAvnQl91iODNxAO0/LpNI0UKZruY7TXNwmJvxEf49xYn0DcYHzJTCewTWag9hVjL4B+G+BEGutNRl0AfJNbXiOwbrhNxy4DKYuUpJGMSCr4K+3DFhPpHPNGJcsUQ0a8oD7CT9MzVMrgafYZnf0Vn/EbQqGZlEFXv/6tKbv9t6acDWYdmywjpyu3HYYuSaRf+ag+t0v8eDB6VmVFZBmhKOFUNQWRSkPlTOoqrQMjYqd/e+/f3PsX//1Pb/5LJcdAqUxBFGqjR5yJ7E+CXHnECYnVrRcrfc0bcNyBU6joMCovlT8J0ssH2wSJNQZwy30orBIdDBsGkH+QHQ4Q7dqoN79ZiT9Sv1nFZnEeCe/tFFDMofNydyPBHjdK+2dd8vN0gzmT3mQDvfmL0+lNWPZmn1ncm/eYWm/a0psdp9mbyI0O9OXTS/syXS2LC7PPwJASgCkKSzWZO9xFMuwvDfWYpONJ5OzU7mNq25T70tAse/Oxvomm0rdBLaBdLOFwVty1ub1dyLyjCxlx04uE1A+LS5J9MkC4LooTFl27jbO5Lt8VjIJQdCr992O+H5RJTDDuTwLGv3WtN0k5I85u0j5D1yVFs41lE0Rl0OJvdqq47wSQYXKo+di7pDrbEn+2NeTTveFAVqTT/p+k8Rh6udIT4UQ0EScTExOtiYmJiaFuNjExMTI2If8pbYJgYkJPNCYmmulEe6IzkU5MDK8ZHU9L0k8k8ju0jexw0J5MSyKsPf+LoD2BK3WFPQj3OtGC+D+yBzeZyfZ4SuGfuVLL6pwBpfhUY0ZWGPmEvu8ywYGbY+hzmcgDcaESatweA3jgb//Pj9z78Jc+efOzPDwG+8RpTuT4QOujfOH3P3jvX+z/5M1PnsYLIymX+tTdndhxir6uOd2a9CzTFK5a2TAqO3dRZcEylX3ZnKpfmZDsqfvVHqyJuaUXV9ZFZeFpVPaKU3VriJx6L68l9NDEcyjdPfubuMHbT5VXn5L9LvZjKbfMXSX67HZnYFWYtbhGxw25S57lHQaV1bN6dqZfFbsq+WkkARHuRn/YIvmHT3OGo3m2UDxu2ls7Ze4jiSBW8ih0KTMu0gDNU7Ddxgx8Whg61bWJ+9RD+ny1Ms2OlDRLJIHHHtIM1kXKzSOeK1zhxU75Yis91bK9srZs0XLL1uQGG7jOV99gDbF5DFKMXqbp+FQUk6SDx5F3441VO1nlqJpc+aiKUrnwaufep4N2KE8HOxz6DvevOuwQf6EhUDt2LyWwzyLKEeKuPM0bLvbjRd2FZkfLa86ALwaRg49FtLlh4onPVqW29BuwpWe1yJPICD6JfF6JsGbhGTHej5854/1MxXhDI3CkYrzD5RhvKXIKxruxmPGWt86E8W4MMt6o4Kk64x0uy3hLsSWM9xOLGe8ndfZUn/F+ehHj/ST8I8pu32zK2SgZ76fPgPF+5owZ7x8G4/3vBlFo3J6PIqXpRQGy3S74z5mN3YmH5XPDxu64/zzIbMeEeMk+Kwy5Fb7vh8+EIadl8bOn4skfX4Unf+wsefJfDc6WJ398FZ78c2fJk5e9OXOe/PEVefKjp+DJv/Di8uTPLOLJnwRP/lTFkx/p8+RPL+HJn1iGJ38SPPlTi3nyIyvy5M+sypMf8zz55l6fJ7+44sk9Q47Jbdjku4MVv7i8eh4bZMWr5587Y1bc775N5uIBbvzi/sX/hbPmxt2Jh8pjJXHHHyqPlcQde6g8VhJ39KHyWFnEG/B+8l0Dq+5ue7hf296H+7Xtebhf28LDp1FbnY9fdaBnxMefasrOiI+/uM/Hf+Hb5ONX7deZ8vGrVnZ6fPzFp+Djnxjg4/1NquSMqPPxz5wWH3/xC8fH/2rwAvHx+x7W7oLsN3URL7lKLyhplHz70Yc1sfRA5UdqVH54FSofLWtopadar9Ni4Gu8QVLjDZIab5DUeINVtl2du7+4z91/4V+Qu6+dfn0GvzpNjw4y+Bf3GfwvvNAM/sUVg/9MncF/UpNf7jP4T1elVmfwLxYGf/MsGfybtPJwe5Ly28AOIQGmYBWo40eoJ6kwezLgozzAtdnOw3q3NTerT9Mprwc+1FCSicoOpbu07w+cvAX+Lf1Pg2yMBK/ECKcfQq70S1QHUwc5NSJP3AEzM9TLnkK+CLAjIh+8k+CEPR8DmiXWp92S4f/IovzmiqJv1woOAPEArHHdEr5KcMXSEBzB73tosH1Bf6b2wZjWBrKqLgElA3ej9vHZDaQoCOB8EMA7oZrAwKec528MU3dZr2AabU51QevoMVrsaCysT3JSLY3yHugJg3fbOIkQ3pP9BZicBM7ifo7jAhmPy5SC4u4hBtvnX9grBpYzWVPvOCiZS5dd032BrGmZsdC8MY0A2CCZA7+i16Zt2sbdhuz9gf/yizct2E0KRQTFtF/k4WBtLRjRiHdS9pz2TCkj/GkMON+oi+Q88Lm9NEyf743SciGf9FHbKwNFX4gD1TvPwLVFzFfHJEXIXhi0xN61V1c+pM8T0Dt0BQEtvPxeSdUrh8w7dA8MpFXuVlZ4o+llXwskyvPr51Fr8zb8+tXzqLVZ0LSeLbDsL/Pv15VH3t0g3WuIHVJ6JkY3nBZYh1slLnnWPaGuhIg68Mz0sv10HU7WG6JwJzxaU+yDd+DKNG6D0L3u4bFcaEFZcSjOYEagMiq/Elj1sj81gjwJi2Q7TCOGiX+dtswFTtueQHxoN6hWv4la8ndSZ5n1chFS9AAIp0eKDv0qwDgqBlDBiQ7Te4bFs+NAWAI9tzaZu0JBPbkHcCEXbjKvI0YJUiqnXK2UltZjpugSlnmTuVHjBbcXW3xB+9+/ovNhm8LNGB+HbAp3F3xs2xSOKF/Recembj0/ZTaFyThv2dR9Q/XyNTbFjOQjfQ4nRdAM74ggOwHImGcD2+K0b5KzKPtmYDtWZ1+DnyAM/5pOv7Zdf7bGltklRqrsElqwZoYXv/uEsUP1Zyb7J1rN0YPn/sV6kG4y60rP4SaREcVJcCGcK9a45vX5CEVIBvFbA5zXCu0wnGE0TeruCb2e15EJq4lZXAarexcoNRRpFQZRE0sbzHTAg9R0wswxAR+y7O8Cm9n0AjWZ3RW1zSByKQFmYl9DnNLJst98PFglHixXJ3U+beE0O2QzO+Ac8QSQsdmz0CTxK5MbfgZIEnACbxOmgVjDPnGut1q16TgDn5jLpnIDhioWENU4tZ3Bl7Z2Iv+SFLEd22KT/t1YcgszV2/V3oot1Ut3lpZesYklUxrQ1YjsstnOZTR2BF9mbLpB/YJTW+d2bgHiT2qHxNtdZhYQ7dnfB+S8BcPIpr0N6j87fRlcYEEAdoioCBnBgjI4w9PrmAsVekQEMQmERERI642QjUrXG0SC2Sx7lq6wgK+9y/chw3Eczmb/jFQGeJyP8mVGhdmSXRhFYQM/C/oglpKNoXJYOlWwW2a9meRarTfwE5McR5OAahDAU99Bj3QdOP2Gju73t8EOPX+2NTApa3HMrTfZJjOZysdJRgnUJqX+gszLwG7qLy7q8f2RpU1LAIk0tWugeFmpymDpYpvUy3W1puC+WBlYjexHAjEFaPuuEETVIPzUXWEv+4eAPyITRJMMpkCVGoG11j2casPEltFIGKpBRNeXG0CjxhuRMTRdbxY0au7aFLybIFdl/xhICVyDqYefuVHL+imnUu7KflKFsjbcHjNlhlJWbc0ZVu6rW0d/uNoUHRGGp1qNDeo/U5BYZh8F5eYr69FL6qkmWpxFltYSEtVWLT/zPvk4EiJwgfqQt6EE+rFhKAzWyUnXgtCC6lB863IEQeG4heNbk+WAf58Nr1im69UUtGzoT5sV5sHPgmcy0BGnc8VFkgWY6ZRYXVT9D9d+4tkCrCDsmT4PUsprqAhnAG6wDv+2+XeIf4f5twu+JHUHQmpXu5yFtIxaRW9eiqTchIX/nBZvQ8HT4P0X+mjXdEhVz6CkfUSLz58PTPX5u+n8S1UmZIbZIhAuejujYfV1BB5Li8BpG0yVqorYyxc2chfOhPNwwceD1AbZ+3XRYLwQnSFV9q1gLUwMG6RbIeSABp34wTJF2cnARhis5A6HsWfW04PIYT25ziV2kEzeJ76tUYTf4VHwe+B2zS0dyF+GovCuvPgpU2gvU2iRKUZL33S6qo9WXtxZJVBk3m9NieArIogIE1lNloD+HXYsaCMUTpTsa0G4uS4ZxdlzODdjHo3Cq3cJSi0IELFT2W1GUtkpka0NxGj/06+ZUliCTNBFRRYy2M0muysC7TLAlylLkPAEqhUQ1SwUENiTXmlvsHNFCyJJ+vp8fhVsQiULXbS/qXPschglbjVFE0cntTAhQojCmr31isipFEcAImjM7GXSPcQ89ayehUievSdK5QXTk6wDIrkCJOwdpbhRDxxPSpSMpJwgVpd9I6iUMpoGAPTuhC6Z1NgmRcg+Zs/q7LeitTZkyJyPTEkrGRIiygoyDDk77y/pXdQlmCJMz8GOeE77kJvbTDf1sTeSK+Hgf2GuhAEcqguAQzXwxOJJDbtqHbCr+P798v7LF2tDeMY0yGUUJTqT7AAI+LqPsz6Kg0sJJqISo0gVEPStABKm9htac2sLWOLfefH7eFhHOww92mHYF78FNuHwIvH7YF/8Bkza45X4/aCI38fCcsccrIvfD1bi9yMSZhL2sjeHA+L3h2vi9wFdOa8q94faC7CC0nZq8fuRUtT+paASv6tn5o2rSuAPnkICf+QsJPAD5QC8cTMEGicfoDt9PZcXxsPlhHHMq0zbM8sS8rEwL6Hr+sL48VAo+dnsNITxn1kijB89hTB+tC+MH+4L45tnS1l8YyWL2yWy+D94Wfz4yrL4TeEqkvDbwqWScPVMJGEsy0iF+3oKSbh6ty6L7/kX60EK7eULIIs/cdayOO06lMVJ2L8YQm5eb7LsnjOQxZ8YkMW9qShets4zlMWfrGTx7OtUMxqRdp8+hRRubEdeEPn76dXl7yd1Wf+KtZflOovLvYgy96B4eQqZ+wEPllKTLfsyt/jLiMz9kUGZu1HJ3A1G0A6K3Q/4bjS82P1LIcXuB14AsXu9v+u4SF7s/ogXuz+yqtit2CGb9mXuxiaTpZX43RiYlKr0oMDtwTuxpmm/F7Kmaa0PlbC9pK5TS9pPDEraT0LSfmp1SfsfByXtsJS05VxYRtKm0PT6F0rKfvpFlLLPXSxlP+NFTFmC61aVsJ8WCfvcxRL2M3UJmyfPmUrY/xj4RFM1CTssJWyJBGTDkLDPfSEl7NrwIV0zh9Qq0vXTpy9dZ4ul66yUrrMXSbp+SSVd/61eLFeDAj4ZSXj/wTpUM8LpwZrcH6wsuTUXS26PD0hu9wcrSm7NUnI7EIAJPYXk5nPT+RD4AclNfLx4Lt2xuuR2i8nu8ZLbLUw7NiC5hbMeF7eU2Mjzi8QWDkhsjbrEdmNYSWxvDYtkRYkNdsZKaEsWCW1JJbTdXQlteGGx3HZHyZmCwyjltoaXOmyDE8DqFgttDXbw86bkZhoU2fIWhbZcV5KoOKBmN4bITZc9qwszi7uG5xm6VQTSMTBj2SEt3e8VOvtGAPlRlknwChJZLJ9Qj+VswEE6dLaV/U5UoRd4ibFRSYz3ByVpLM9o3x/UJEYf9XcwED57Sut5RzIEFc1blf0zwmMBbpw2RTA7Foj0d1ikv5+qUl2ZdX1xU4gPb6+1Qfa+0pY6aGKFQwuAIDyN6opGvZ2VzRySZl55OkJmaY9eLGf+rc8GeLjaoj4MNIbPiRLw503mMSOfAGD7G2MyRX8motmGTea4FoR1Cm3HJXazU/vp6OBPLfmYN+l88SSSCSJGMunnVo0ZfOYeM1hvtJd9KCgSiSjtEOGeEaUtm3hhr5X9SohMAJhcBrYTA16OjyO0JBfD8l4BN/hGzzZh7008ugh+gD/JhhmkGgTLXoKai4j8Z/z7p/zrAcS7Ivvho8c3xMdUoAmzt4cyfAT3rpfBb+TY22ZeEAPhfb0N/BbuiAQZwvR1PduAEkYK9Py9zwIDz00vzTPWmBub+WyMbZv5uWjzNvO+l8qt82crklwirBqqnGGO8LDkOf4z5jn+U227tmFTj534q0Q5xZd1+GNxXACNKbFt3gq8IBr+muhjuN8b2hZ+73gIQ+6dxCvyGkKMW9K/NhXJAhmgiTmBZJ6dCHKeFUhxCPdkZPtoeekMD74ZEKHma1qCtDE9ePxr4aJyT5qBcnDVUd58CsFAzKco+N4A/ulVQT57wgAtp/9MeaHRZM99t3YvZdy6HA3H+rALY3IeiB/KQjiXTwSb7bgjK+TFlnCzHbMdLxMYOwaeX2f/DHyBuwJx+HmHuL0HRJjuukxujS6gpkWVHFmVssiYV9sOyKMNOy6yqNKBCaPU+xGBDQlrX+C/Lgh94jC8CKEP3FAn+7LpmL4JdMWyBrLkl1HXBG6YLhnmdvZbgW0PjorLijNj0oYISQ/zLu/qyHZxV8dgMLt902UXrE+Xt+NQkfHsYPHQdq/qKJv5MrNFF70bLnu3xvdujR3GwmbQ5masJQvnbUyNL67wfA2REvjOcDkiOaGG7ZpFrw7bJkwX0roEMWxcbf54knzZhPNuPgK/KAgQKXUNmVP5aCA1kVnN7AhWOcvXtCsP7qpLw7YlGVjWyNk0ijjp0StYfoTt2FFZIHcSIrObrz8GEsZIWpumbGn9GcaKWcszYb0nZc3eF6R2HI/Hazl/vS52PXSxF1Jrmt0SwXSBfxQTwSqL2000T1Zl75Y7t5feGeiE/GkVwn9//9q4XxyQWjYSLUVUmfhbVNfTOQC5Yo1N/ZulNvD9/Pu+0sUJF0Pba6q/Qr9TSk9f0QXuz+dU/7pYovvE0Yj2cXDuAiFEwiDiKz3jnwVpN+TyiMtLYld5d/D3+mNcHY2+PrXhnlLbiQnS8JeHiEIdJapJQygrq+TyiMBA+j+ossWBH5Bb5P28Rd6nLaClqJXdVbtEQm/gkUskEt4q4fkV16QPmfUyTweiG9K/9wzKgcZKDMrBBBk1Evm0PIOyDzXeFsrM7gvrDAp/2jv4U0s+nppBeSBZiUF5IPEMijPXrcSj7AkrYtsTQsYRHuWBpM+j3F7nUR5IFvMoe6g4XuDf58jbnuDfY0HFoxwJKh7lUFDxKI8EvezmU/AojwSn4FEeCZbnUfB8JR6lPx2rsylNzlzJqXCE681ztHWeCPqcyiNBdstynMrBVTkVzPYiTuVAo86prMig3BSeFgfwtvD0OICyXMkB4PgTDoAX+uocQPlyjUHZ893avTqD8o64YlBGFzMo41x28ilji/mU0RqfMip8yi+FtpM9sByfkpR8SrIMnzLKjkSL2JSx02ZTCFjkb62uVxt1iZiziE2RDOErlS3ZlMSO01BVZ1MeWJFNmQCbkng2JanYlKSv7QVilQAx2iE5PPhy1w7lmedXkopfSQBeSBvZGmsselgMSx/XCP8BjsMOC9sD1mALwRKHJRaUKo9hXz90dqggX1OyLV07XKtkjeedjFTdJXCTcDBJycHcMsDBlBhPAi+1Ig8zjLTwTuUj5GGSrTThde0wKKA7wMP08apaombzPMwIeJiRK1h+WJiVkUU8TO0xeJjhtDZ13aX1Ew9rTZ9hNB6VatIm2UMBeGXdy8eIkXWvZ0OOlzI4zu/yZsBR/vgiNoRkRTbkFlNjQY7x7D/Kv4/x7xH+9ed+WxQgJQtyT1CxIHfVboNVWZC7gkEe5K5gZSbkrmB5LuSuYDU2pH8/nD4n4jVHaTn49eYxXhRHgj4zclf9oqhxIwdX5UYw+eRGjgfCjYTKzYu2J8q+GqS/pVXNw4Yau8j7zWsm7MFppW3U95uPqlAblF1vwqJE/iRGFDwQJOKZ2KCXEVN0EQhotAwIaETkUt3LDukSwjP1XjRpTi3ORyXVE5II3RRsFYaikR2GYTydUuJjQC7py1LQHfk4XQp+oYo2lXTxR++kVcK4J+803nYcMjzEhzw0rCkQFZCLVisPaDEMmJaojBjgK3IGo77sLbhU3sYEgtjy6Ak3Rqb6q8UYh3bpa5G9PUovkI9rZTFV9ssRerB28OFvhnyY7vdIs7aEVxa9mvtBWSHNlHaCrVwYr4ULy7vJlNkHqMeDynB+Kz0JGgDrCrK7g7VQ7+JfcSRQDqr5VNQdDOvQMmkbh5l6ep7xaJU22U+XD+B2ejb9Qv+ObFJ3+N6w79aTMIGpbYp+zytEK8TWPOGc/mZoNX0Z/LdCCKRQ26kTt+RsaJcwswWXNXsrtaGyrpjuK8jyvAtr4ZeJaUgbvTw082UjppdHVXodpKliaobsF6MiviKUxn85KgAfpa+nlxmTaGDWA8a6oPe/yMMxTn32HBuXNJxHvpk8dqpcBKIkyPohtA/5U1HJnkiypYYMXwqzX4tslN0YwabGnBIA/AtKYDSxmsYoHWbviNgrryH1+YbCXNVzUzDYKPA8gDjS9VNVRKK9Zm0FxwKqByygla2GzvA6f1vkbwrQeSB3Gu+GRsVgyK7luH879PO+1op9yqtz/RrhR2zBaLYI/z/a3gOsqaR7HD73JqEFJKKuXS+xd+yKkeFaUGyoK5ZVFyNEpAUIAetKVCwoKioqVbB3xd6iwd4Ve1fWiooJKtg1nzNzE8At7/v+vufP82hm7pl65syZdkoI9XEhpusufpsSy9KYamTgOJB9YHAe+pzxgRFGm2NlCyTYXjFpEnkQpNiWzSTNFbtS+8a4eYTeZfOxBAOJ8+KQdqyddWUToFSyEBcrvPMSOpLNlUilnAMhb6o7xHpT0iBzlLxIWKp2ZYUWJ5Chxy5/xVIp7QYjyxKTukrHZCvFeIX5LqJFkM901tpSc+m29B0DyDjgxNSOc4l3PFy/tCIIvKe0i7ya9KNstZiod1nlvOzKMyCVRmOHLMAnC5yV6LxiVypkVvQmSwBraXFJmDSBigNRzS4sxkbFRWRrxIRH4uSydCwxMl0iME3ZHAnGIgfUoARtY4hcEFht+y+csIQH/gQlCJCtEuMN+lZGetABiCe71UvxrkfsyWctxcOD5376UpaN5ZMtgCQr4NZKVpYixj8CFqyKbXgoulBzFWSm8vl4UOk05fNXWcSryEjIpkn4Wt6C9hzOKBA9X0sWJyFdJLQLFvqcIaGWIskGTjYTp0sV84WrWP51TVmdahZCoonTxQI9ZYj5rCzS3Kwslj9+ATeXBPOTWNlysSxTzK+n8PVZLP+EwnGw0ArPpnB9Fm0+vy+LpSZYsrNYfjNBAPlWuFKQJSaAXUst+XNo/pwslk88RVLj4GYr/DSFn85i+dWnCRwH9VZ4LoXnZrHCcs7fysJ2RnEIfzxuTZlHU+Zlsfy+MyQlDp63wvMpPB9Xf5bAcfCaFV5I4R+zWH7rLejEAP7CJx4nSb9msVjDkHy6Z80yewXJkriC7bJVp9PlSNqzgD/y+2iu5BU0F/70xJprPc21fgXLx12kKF/B8h9LUE7h2fjjJQLHQd0SC3wfhe9bwfLnL9MBWMHys63wHArPWcHyu65SlK9g+UQr/DSFn17B8gl3Kcpxk63wXArPXcHyWfcIHAdzrPBbFH5rBcsn3adDsoIlD3PCQFB4Hm7UAzoQK1jyPigMBIXnr2D5rxSOg7es8EIKL8T15xE4DuZZ4R8p/OMKlj/+J4HjYL4VrqMzVLeS5fMfETgOFlrhsyk8cSXL5xYQ+OyVLP/1Ggnir5uvW78mW3Ml01xZK1m+iOZKXsnycTfpnFrJ8rtuWr9mWXOtp7myV7KyeRIc4wtv0SFfyfLrS4aUJsuhyfatZPmEO3RkV7J8dsnI0WSnMfwJHbmVLP+xZOQoPBc37CkduZUsr7NSXuJSFjMu0sylLBHnwpwNfyd9X8pKZevFmB1SWNZSFjNCDEtfykqJS3LCfWUrxIKVH2E7jNn1CjFWzQWB39emrHX9Uhb/o+uLhXe3Y8WlRYjFeGnxZOgNHJBaBGF9O6wDEo2V4S37RbyMRIqpBAYHwcINBy6A7NTN0FccKzAjnFQb3IIBjonkoQd+bZB64dWd4ag/L1JI2SzkC82F03di8CUNi7WYS0kJsNJuIIg3iHoI9yy8GXo7MdaaS4rhmEgivCThRNghMN7RuLLkKr87CGaiRfQBwloM/FMxYMlOWoF3eSJpLbya0z7oNjDWxZ0gBhunKdVh+mwgh5+SE3EAbXDJZVHZvpaqIHH3/1SBJfl/qKCxUIJXdzooTUG4HBNTvDMlSStQQwsMr2O8q1PdFmnb0tnFQgs4Ko/sXd2it1VWzoOVNiKvJsIKRqWs7eQWj+GORPaQyinQLcM+y5ahATlH9SuNbWwvrAQhQqs8y6KlKbYAUjYfNk5eghWi21q6qyUVWbH+P1ZkyfcfKvoZ/YL0NjWuUDapI1CjCDz0rC5tUxbvIqFuvPnpWRbtpUpwAYuvDlvisZsn0iP0Ey+StofSZgLExCoB8VhCBEWob3C7YFkcKwiU0GOLiI5RsmWMDkkYR+EgWQ5zBVcqJini7IjTclc7YlKeiMrjo4842JVu6mmThNaILJekZH7iO2Ab/FOOnpNFdjwWCScmCsrTqpzrAr37c+Sc8SnPWbCkUB6bt8NHAlcXbHlCbh/i6oDfH2muCuRAijfJcilujgv+z4EHzr66q5PIk6uAO23POfFi7+pYrA1kOazcgWzN+VhXGb5PtRfHck489qmCJXN7Yxt1NJsDOQ1hgd0QVydsAz+YvLjak3LolaYUF+DAyYKJLLs42FWK7+9C5C7YewpnT0aW3h9XoLiWudpz5bEZCGcSL3WZjA3gl2PBhrEg0iIBJohVSqwqWHayk2K5HX44wmSAjyycXbBcQm8LrPyNDgO5S6Np7IU0ZCRYy3BSOy5kVG3x3S991SqpBDu04VlXR3xLXY6Ujq/H8CmNs/N2wtLmxCA8fpWVCDXJHYVXWUdsKASTCBPialf6AGMxsxIspxdDrtSchZW+JBb6ElvoizzpigW1DLxuuDri9hCcYntH5OBGhcbdre8w9HaBuMguuTiwuMeW5Vj9YossptYu2lgpv/w/U77gHsmOuJH4B8qP/Qvll7dQPqV6F1qNDNMEvtvG71x2wZxMaKILoXpXJ+xFAZsysaOvSg6U1MtRbzwSor2iYzlJdVd8n+dA/IpVd3UWSKockcTtTlwOOfFsjNyRk3r/oPXpTN9IJ5Zz5hwwmUs5R/yvb3WOkV1h5Y6WyWGP6Rs/8Ti6lsNkLuXxiDqTWryqyyuEuEo5Z64COYo7c05cuWCSWF4Oe1YqV51MGcdgV3vcDIaTkhlRjrzdkZnqhP+zd3WkjIJzxp6hOEa2h5VjV1Y8Sy6irPPCBnv3cCDnQkciUGoxMuRAKsXETZCCSY/omjAhcilREHC1xxnIGwNupT2ey46u9pwTaRC59yFFkFnqwCeSRz0XTBayMlOUsyeIEexNSgSxXzo5eYaa0SPvKywZOq68xY6R7LRYLuHZ4HIiO2AZ68TE5otciQKCDZ5UtnRCEA8spdNYJi+5gyqZvyLrxC2hTTtyp8szVFUS19udTF78GGVrqYDSqVjYUP799LOxELnEQuR0+tFlhsH4LD0V8b18eUGYs+xU9PjJWz1ZkbClL6unerHF9pNsD56O4jJu6hcxZfLT+tlYniXZS/EpvEYSVYlquPfExzdHMRTS2wmqUSt5rCiWw0KYhFdZkCAv0VEHYWkPIbKOlFeRTa/U1eLqimOlYxlRLJ3B7E820RypAz7GwmRK8SB6PUcEiHEHBclXEX2UIlsnsp4wWKNQdk7MM15SaRerJCitAf5SA/BinuFnJ7F0118d87VSxbPSxVidV3i9s8OvfpQjYWqlXbAtPTi2fxkcW+ogF1Mzwz9JYjmmOh4me2rISGKdHsT5XDkRyzIgxa7mpALZ4HderN1FSZwQtoO0EvxNj6VxNtY3A6vUN968SNqxduTKzDFYbk93PuRa1Y7OQCI3zQgOYxhO5ENWZdZRJKXmt1owIJfwZvMx6O1ELXdJyObakyci02SVkTMhWFdAgu13CcTAkIWL+kIyO/clwtGWpGxPvCqVTsrbxPA5jIYsdUKyUkAUyesIUChum6hseaK/lucYw+f9Y3k2MSVF/jf17RVZuktc34l7OkkwXvAuSPdRFMnr9ol6OFlwIcAdeLNtJCfhHbQkDSfhc2wj5SzvoNVoeJ1OHGxBKdb55VnBD+FPTWFxUzGP4dkYvvAf2svyYi3vhmtgY3jnSM0/dswBl+aME5IMPyeUCAlx23/CgC5H5O0kLotx0f8TjEsFvRDsZ4QRLup5Fju6Zsh7spQ8AABdbOgbo51FV5Q8FT6QWPXv/3EWOJaaBQ5kFtCVh8xzIiAj4UT4qd6BPIZyNj7EFp2Uk2BHSowwcmIOS+wI9g14YpWK5Rh8XpcIL7AMf5TxxrTCP2SooygJIX4JLoiR2/E5DO53D7JHQ5Ecw9to+RznSE2pOqxFskKRppKiREJRmJ/gEl3tBH3F1ww5i/F52JkiZ8fnMZF8FuPlxOINKo3qGC8nhixT1lZI8CV9SZPscZNwu3gbLWaYWg1tlyjyr40TCY0rYno7SXjscIw0UIzJRNIMRLSB2DYAaaeklG5lIRNSTgIsyzL4QRUrr1Lz1z5Odo70i9AiW0qLlgaWbXqplmOjkiytmwwa7occv3HbaOVOfE5tPAEctbwuzxlj3DZSzvAuWo1GI/QKm8C048UxvAiD7bTkiUrO4OI1HMMrIjUaPscMwbwuW6TBvXcgLm3oZsYJz3LOXoNZgqYTQ8WtsHtoKrnjQCnb8gAl4iS9sRyB1ELf/H+mb52YEROX8BwrB0ICYNGDIyQrpsIpUJpSgRA+E1yKWPGSTsmTKUWeQMiTmA9k5CWoZskMLSFPK+sCSpXCSJpKSiEcGfCIS0hh2Psn/xqTHKFKKnZioUoR3qTZlFAe3Z1iUhLR0ggZiTnbELxBEeECiQ1BXLwNLf6/IShvJ6oqKhAUJn9JaYISl26EqBRxiejstCHdr43x4KLldbpCiKScy7EM9QjO2PCo447YCLOthxNbujLGglJCiSJcOplo1oLwo7woWOoKpRy8kldjLAwhlqaJrXub/3mxl5ClXsRJ+pKlHm9GeSyvK6GrgKV+Ca+LiMRUTu4Gy6z7jGUpYMm6jxffEks5/7rus//ndd9aDNlKUg+uHIspjf1/tvazmPSYn4p3+eelmNT9r8X/7wuhmJ5ZyEJI1kDmP/KIF2Iq2fRvxCH92zWQKvOSRpVaAcuRFZDerhEBbExCWEmqH5GMwgQjbJAIKTnakOsOjuW74OnK8n6ULzDC4sf8tPiRfSaZYhLrAiiU6sQ4knfbcGsJIqEEvOYxJWueRFjzJP+/1jweX2zY05ZYJqadZWL+3CYt5U90QyjGjRG5Ov21aULzynAlu79wJbuyXMmuNFeyL8WJnErCxGCuE26svYUzSUo4k52VM1mnNL5+omyASFYGl1qTxNY1ieFE3vhiyJFoq/5HUisUMZJ/X47IqQkbopNTQzo2hElj0qGMxIpUwvW70AXJ79/XI8quSpiyZU2ixQjrQPjfrEa2wnLB2QirkY2wGknKrkaSn1cjbdnFCOiepvQKZ1vK+n2Zwbb9y2Dblh1s29KDLSk12PZlBpuxUKYw2DYlg237l2WIbp1KLT0llTC8iJh2JtizULnk5+XHegDFKhuuULL8/IJHn75JU9ECIrNH77+vW+6/SaJ9lkSyMoluWhLZErqwE37tqZgZOZmbRJaIjETwox4/+xdZnWpUBfPWcUb2UCxNL3Hyjc/fjOwyW+rOgLCoUr6+WYuvb5b6+hZbfH2zgpifDRbzE1MxPxsq5scSMT8iwYgVZEWC/JOgNisSZMBEZZ1401M9bbShpNEFtNHlBPUZ2SZGtlIifYZf+S0yHgXkmdJZyp9OIR7ksTxIMkvlgWRGjBo5YFgPJyBpyBupFKfhV9jLHon5zcksv56E9iWz/EwSOp7M8vNJKDeZ5b/Z4dC9ZJbfRr7lJ7N8MgkVJbN8gTMO6VJYfrcMhxJSWH7eLziUnMLy26rj0OoUli8gObJTWN5QAYf0KSy/0BGHCi0vtwVLWdww8jadzEprkIbTrvCOIbLlEjkB4K5IixjgP1qQUGRBwsdUCxJyU35GwsdUioSPqRYk5Kaw/LWnjOy5mL+XwvKFNJifwvIJz0iwKIXlN9OgLpXlr9FgQirLf6TB5FSWT3pOgqtTWX4fDWansvxpGtSnsvwtGjydyvL5NHgNl0CDeaksPzufBAtSWT6ZBj9aUFK0lMXNJK/iKQQlH1N/RkkuHV3pK0zblKRFVvPh1AS/XIJVuvGSS4RxXYETyVlyKGDkYg6orRpxCCFSrP9BHB8DlZIiN3Yl758WBXQWX/ixTiAlux563Q3CV3L8wUr+4mAhL2txbA9SbJMFhEcyMidsLI7tORFVW8eqC4RzEqFh/DJI4gzRGBfMl5/FEhLLhPH/ahn/rAzL+OvSfh7/rAw6/lkZlvHXpbF8ISHuhDSWf05CyWks/44Q6GocciFEm8byewj56tNY/joh7tNpLP+R5LiGSyHQvDSWTyfToSCN5b+Uw6GPaSy/mHyLS2f5tSSUmM7yi0nJ6eksv68GDq1PZ3kDge5KZ/nNJG9OuqXe8+ksX0igt9JZ/jzJ+ySd5XUVyQRKZ/nTBPo1neVnkEk1O4Pl80nepAyWn0vq0C0TqOrrUhZ3nkiZpBGqysr4map0aZSqHmGhEgui45YJiM7NtCA6O+NnROdmUkTnZloQnZ3B8uspZeszWP40DZ7OYPkCGryWwfJxL+iEyGD5dBosyGD5zTT4MYPlc2gwbjnLX6PBxOUsX0iD6ctZPvklCa5fzvL7aHDXcpa/R4M5y1le94oEzy9n+UQavLWc5bNo8Mlyls+mwcLl1jZ8Xc7yOfTr7EyWz6XBpEyWz6PBrEyWL6TBzZksrysgwX2ZLJ9Ig8czWT6LBmdbBiBuGYuRQsSkMsgA5Gb+PADZlF6lauATLfhPsOD/oxX/eZl/YXQC/j9a8Z+XyfLXahLCzGT5yySUaGlLwjIWJyAiT5mUxfylLXm0SGkE8MmWtiRZ2pKcZZ10WT+3JTmLtiU5yzrpslg+m6IjAQvN0WCypTVJy1ichJBmFmlNctZfSJMWKq0L/PpllrrTl7H8AXssVrh+maWu9GWs1AHwD1GOqgf8Pmv6zctYPu4EXl/xRyHDZpphs5ChLvCnrRn0y1j+OJFbPG1Nr6fp9SUV3LKmP7+M5dfTCm5ZM5ynGc6XVJBvzXBvGcuvJBXkW9Pfo+nvlVTw0Zq+YBnLn6cVfLRmKKAZCkoqmJ1syfAVZ3DGFcxOtqT/StN/Lakg2Zo+IZnls06SCpKtGRKSSYaEZJoBb1lkUyV4c1abSqfYBcuJpRmqvECCVHnBq/T9Q4m8NLFrKqK+HIiJ078Tm2As5we6B+RlwVJU1g8C2cATf0vQDMYTk4aMO4ynZ3L8fiOLl2BLOhZRflqOXbC0g0U8u5rwK4jCE9nbf/5UDWuX0BdRomdCQzWIyAvRCBF78qsqyUYRfzusVrZEQoTPqOx+iaJEEyht9wY4hvpOB6HpVJ5HsCXSVDA1KSb25gTxGSBYZIn5GovfHyyqRgaGiJzSbaVjsCxRQjvtGEw/kdVZSjQZWB9sKAXLIUyOlFPVBvLDelWX8CV2U+Il0gZWtFtfyOzICxkV4mYs6BUBSNtQimA4qI7fi4jM9RZGDk4Mf3o1kYgnwt7ly5PDgkyMFTHoznf1W6LT4o7l6/C+V85il5tLJHIRNfhDBAzEFstbQL1+0BdEWRrJWhW3xb6vYDc0TSLYDU2XECUa4rJNLQdZOlVmeQKhIRjWGUMegyVbMs7G8M9thQ9CprQymYSSUySCnjvvFkxlpplgYr0UXwVp+dzXDBaJ60QgbLD0g6DnIuhJsHy4HD/rxEYFk7qIdR7cefwUH8PLQryJVSxGUMmwE47jjkSlgnqaJMoZsiVELcke66bgE4pUtkQi2OhjiR2rI/hijMTE2BioDflAnAAFh8jtLQAb7KTFIZiTYN3mI+Si3gFTm4NgB4elZx4pPfOIcXr7YLlYloyvZcAdbGkxdrwtsSRrZzET7IynA1H9L7Gxwwg2diyya3vL+s3DmLHhmBArWmwJWmxK0CKxokViRQt+TaXe7UqjxcaCFpvSaLEV0CLisHaGBQXYzgQnKt1527KdJwc+SameVQSOEY6LJ/BxLYOpJpUOZahHPI7lHaj6mEg4UFLWFE5Vx1jZEky8cjEhclqBuPSJUmQh7yMMrS3Syk7F9OSK1YYZuciKJxGx4UnyEUsKYmqVi+VEwZxYMPGLS6d7biK0gw00YZ9feJqROCPLkFj102JLj0tJjWIhCxkhenLAlqLEuB5c9xHSP04ULMd1Yb1I2gwxHiDSDFq/WGhaCPEHBNbarZIJh0oIgwoZMe7gbL1DsZCU7BsjiN7KxVQsgcW3JiIp7+Aq5rFtOGgGUjkeUyc6nDwj2EvmxILVKAKgEksY5XSsgMp+UBlBTOliV4ZeixHnRhShImpKmrydiARr0vSwL13LWEfMKiOFlati27GOpP2fGLmYJ/qVLJUzE1ELdyLK3kR0LWzHYjOisXSM8dkIy5wSUSsKx6r6WMOE4P4wK5VjT1mx2IElRgnRibKTY7EN3PXeuAuCJBYj6NQvYH/iTORG5K/cCYtK/+/8aaHkJ/60qCx/Oi3wJ6wKg02GYRZ1+icWhWHYElkw1RLDOvHBVC+MsyeJGZ7577kV1YskqjdE8A2fRe1K2zU/9jNDoggpy5QEbPyPbIlioxRbWlSWLZ0uzZZIt7Ein4U3lerqv/Im3Imcv0weQnb/9eRhXMVEnkGYPMxPk2fd/2nysFQsWw6lLsaA7v8sNG29LJO2t3rjpQquxCdbpWBihpRjZBslpDn4AxZQussK9kmlFxgipS9IBzIhcjFv34egk8MCw5rAEP6yfSjvGCOXECLis0xMMFE77h3CM8E9SX/Y2B8z1XzkZgt8M4jDCy6SXQI2UJwqEUwV84kXQS1nZKkSYgUv8SLeIKRIpBaw7ujNFhieTOE4Goot+wvZUn7KRvSmBD08HO5MdBCaAcd2p2snERwXe9ENiJdFssfyXXaQ7S49KKIXnp7BZJmI5Rnq5li2SYIFt4CYrK1GE2C6IJLoWF+eak7a8nYh1DICGZiKnIgvMDHtiM9ohop4phcylI9VCeaBb4BXPWzNIZgqWWMwqY36LcCuYyVULpTIjPFA3hCxW0IH6n5Z1JDleMarOnUobUlbKmWV8vZ0uy9qyDYtxwK+MBcR06P4pyHOS4N1S4JuJSXS8okqRUPWzYkRUvagoYYCYYuId2jMGrFvQB57jiOIIp4SeLGGB74N6amYF9zhxmLsEIVG7FqHodrKxK8CVYgQrB/VKG9LTEtycqx6LBZkjasIjgkZL/x8K6YOCUE6Utjwy+Qiq3JyXUoNVeg+X4ZteGHa8qIUUYVne9D9RDu2irOUHoLa4R0nzQKks8Ht2LpSaTVBF8bOMj5UJHCLRCpt/U8gSl92covvSLB2Suor6MKIidIxcKwFX9Fy7LmZqIJUo+LUEtl2CX4nomozpCgJnu6EC0dWL12qA2kJOahEkAr+pVmOgk1IuUQAZONHR8E3Mm6DSBtMklQJFhRmLcnw41s7J8biqVDsja8XpKmMcIpsywrTje1hOVi2oZ9kcrbMyIhKRgaTOxaEAEp+wnOVYCG7IVsFX5NSXVWSSURM35O0OBdrzVJm0IQBxcc8S5uIiVIgJnDpPS7bjq0hxc/9Igu6OHFpdO2SEKIRHANSEGWNDVmZcGaviLtKtgakNQzuH+dMuFg7lsMpmvKCH0SCb4x9gl4RR/a7ggS3pC91+dqJaUMXQbJeiGV7BIwTGzjNoC1RXWkGbcgLnw0uvgruDV5xyPubHc9GkkfUkg+YnkSCB1sivsuLOdvuTliTGhuxaYoX1UgninI8NckEbEjQ2BAHhTnPWOcMQzBroSQJ7ZmNxUeqbC9ZHDAl2WDpJS32Q08oSWJRxAGepV5OLYVjMyukm6zQeWs5WHOAs/EWbs8Bd0bsWZKaluD1L/kcWSlYi2csGWjlBHXE1MQ/1CmV9rbMVbktbxeNnWRiBTXCEvHeYTuRkS41O0XkQMhj2wV4fpb4knUAqbe1LBtcFjEgECmYsiEz3VUi/ZuZbkNKEgslYaYuLWbg/xHBsp4CyXqV0GMpPkaIslSfCE0ScTgRpiRMmd3JLgi/gbRjm/7fiKqEa5bptTTpv+52dyf4134zpfstNJDO11LtZEsoFKwtBaGl1h5Kl7GMjZV/SEq1ixPLdpJrkWbQ1tWWzhYsqwXu0JagytWOxtrQKWRf4mYYz3tbklHuoHG1xaeEZtBGLtVguQdMET2JbRkbMr3s6fSysVI5ljMpReGiUoxBJCXWvEs4A9VWwMNsU7Z6Wjlni6unlXN2Giw0jeeHDWdP5gexRmUmCpikU5ydNdZG2hH+DSs/jXOZmVLjn3NKsVfYImdiSEW2FDOfRHoDJgH+a3Vpa3qRVvBWeB4X090VUVJ0DJETR9+rxURIr6wKYI5EeDkXQx2Q2gAHdUEqgzqA5RIiIqmwD7krw03Zwom3dOFmxhEv21C+UgkEd2ULZ0OhUL4CSOv8HcR2C2dnSVMdpPXK+O3ewtlSmN0Wzt6SqgZIpZlXmB0M8Do76eyq3aO0QWFKbbima7h6TFCgu3ugRhkTpJ0AQeoxQWociNCEj1aODgrF4e5qlSZwwiClOsSS3F8ZofTHoP4aVUCQvzYoXN1doykpLkwVFq6ZAF6q0ZpopWYC9FKq6W906AQYNDZaExWgnACDolXkd4gqQE1Dvyq10RoSiFbjn77h5MdLE0RiyglQL6xFvYAW9SaAgov0C1OOh2ZNOI5zG+o2Hpq5DW3iNpRzG9rMbXwTt/Gc23joFx6DqwM+OjA6Sgv9w6O00RqVpZUaVZQWVDEqtRbCwsPwjzYoVAu9woPU2j5BYUHaKEvKGFVoOO6vXyj+DF0jgvwtIG24JjJa9TcAdXRoqF9UhNJf5TdOFRQ49m8LFiC8Jqy/Jihc4+4ePmZMlEoLfYLUKqWG12o1Sv9Sw6RVagJVWvDRBKnUWiVG+z8lsY6wu3uAFvqS7kWH+YyOUmliVPSjj78WxilDQ/2UWox4GKOhI+kXNTZ8XFSpNsUERfmHR0fR9nsJqUo+kx51neAfWoJYZUBQdBR0C9KoSFplaDdlWESQOtDdXemvCY+K+nkkorRBY8aoVRignBAargzoGh4WoVJHkS5aEoWqYlSaKCAEquLU0WGjcTQ0SB0SBdog/5Ao8ODcuH5cWAsawr9uXLiGa8lpw7mWbm5N3dzcOI0yQICXhFq2iAKllgsLj9Jybs1bcvRrFESER2uAj9BAjAqj+N8aN1apDvALj1Fp/FR4IvwNUvxVaq1Kg7EePlqlASVXpiOYVFUk8KsqQktD3VT+NBAUHuU3Whmlcnf3D1UpNdBXqYEATXgETgv1vN3r9XWv9ytXL8KCG6U6gFOHa7mJKk04nkrQK1oNUdoAd3fVeH9VBG63dbTBv1RvIEAVE0RDSi5aHaTlIqOVWpVGjb/0DVf/HQlH+oUFqf+JYAOVQep/JVeS4GfyLAP8KybJ57+wMGEiRgUFqkGtVFsGS6DhMGVUlF+Y6i/f/cPD6OdeSnWZ6Us5gp9SE2YhK/DobAlg6qLRMMzTQBseHvo3bFKjGhMUGkomGSajoNBSk0qjigoKiFaG/k3/1OGaMOXflYdHN0gZivkhjFUpQ7Vj/4qGcAGHfqOV6oBxQQHasRARHTUW04z/WFBqtUr/sZgf/v3sDA1XB8JoZVSQv1+UVhOkDvx5pgbQpNAvOjT0V8zcfgb4j1WqA3EA/4JydHiMinMjFGmZYS3pRAwJJHgMwfUF4oUH6jV36zMG6uF/Y0AZGhrujzumGOSBG0ZiqoZRQRNVflpO3YhroG7AYXJWBURxYcrxQWHRYVxUdEREuEarCuBwur8dEYIdUPprg2JUoNVEq/AyBKWn9EBlWMRPRKVRalUQiv+LCI9SwRhlaJSq1Fiqw4OiVHiSqf6NRYxRBqj8tEFhqn9dYSLCQ1WU/TS1YqwVhzkLpx2r4sYoo7QqDUdTdf6vko0J1/irwB9XFKBS+6v+OnaEqyjVJFWYn394jFITRKJ/M4eitAF/M4Xw159x6O4eodIEhQeUGgbrp5/2DUOUWv+xVuDfoEeAWNl2GYIKV6tKem6p4J/HQRjT0eHR6oC/nQWjQ1XqAEy/ATBWFRrwT5ucKK1Sqwogi4QqAOM3SqtRBqlVAf/EDMOU4/2iIlQkwc9zXqkOjA5VagQ4mUQqP3W4NshfFYA3SBYmxEW10CgDrKzopyiJ/IUlYOoN8IugGKHrwGhlgB+ZU3iRKUXJ/uHRoeFho39e6i2fvVSjwUujVIcoue5hQSFKrr9SHaC0LDvDw0aCG15ry1TIDQ8JHGlhBCXEatlCcsN7CbnKfKmn5OqN5uoFcPV6Wpa3YdDf51fvobSzQ8ACgH58P+jfF/i+0KerH9+nD0FVL+jD9+sB3v28oCu4tWzVuk3bdu07dISuzX0HeTXrQAshpPR7K2iJdwnNWoKSC1WpA7VjOQ/ODcYFacc2hzDl+IYtm3KhTTlVRNTvzVq2aNWIa8GFBakbWuJNuaigwDClnxv5itM2asQpOnOtVM1a46RK/7FBahXOHhQaruYadlS1bMUFqbmA8OjRoaqmXMvm7VVt8IcxoeFKbSNoiDeOjaCLUqMJUmn6h4eqotzdo5RhEaGqgIaUuhv9+0azKVeyeNG9gDVFc+tU53AHSMeE5jeC/tEaFRcTpNFGK0O5MdFqMvicvzI0VBXgCk25wHAtB+6canyEyh/zWBD+uBxLKDUF/21An6cE67WLx6J9tWa8GrBvPppUcWuPPydqEYXvR2PI3zME/ElXKSvzBP6Wq9STpjYiWtYwz68b3lzpO7o/spReNl4o/LbxtMb5tXKp6CNigD8sl3YpRP9zc37qBvBb69Dm5dT55+Y161rj1aN2jdF/bt78ukLzlteVarrllE0IYGlma/J31do8CpV50u/vfqog76dfN6HCKp6WBljKBX55PenAknwXzuO/AhJXXbjA04689KC/nz0omuKQ5Zfm6yiU+1H4noSAT6wvzRNT/BwWPu/6y6/Ijmb0kQIwuIESABYA+tsDiACgrRRADADHU/wuMNOeoaTb3OKE9Gdo7PidNqZN09CHBTPyZR3kBjijzS/ST0JdfvPPtV+xGL29/ChB2U+HGsmPNX5wOh2J6ke8Ui9PRa183RpvqBBhmL2v4xJHmIFW1v88Oal8D6TrVqHh6PKrUPykpn/kT1uJFNNnfrdvPhMZYw616a6LMvxSKdL9zOBZhlTcjI5zDCMWiWLaTkhFX6t5T4uQJKHV5qe/7YIM5N9tZe4OYyxi1jrWyL3ia3B/pvD32zEVdVh+STex9Uqk6zFovbr5crRy6bPBdpumoq3ldPs2DVEatvdbYqoaH2EwT5wh+SBqjnzGLR9/8ZdRqK7/7k+x1yNRvk/16y88Y9CSW7sP3V9UA9XRd7ZjPg00hPm63LYd1g4lFgVV+rYiHn3ZktHQPj4OFd6btO/JvijUsFE2rHVUGLSTd3XwT/7V0LdP5dHFPXoaMM7FlQBsAQAPgT0A9GutCVN1UI0nbCWqpdvAaHWgqne0Vqv07hPUvnv37j+laN9/7ISoIP8oC9RtPMCDigBDxwPoKwJ8rQjgc1ApCdx8H1Vp1m3QF9cXKO391CvSKJMQ/4QeqVrIY5tMVNiOqNi6/tqpikPnCifOto0Q4gsVlnzCr+GKa+vYybdZT+E3B3hzY2l+JR2F23sKvzmYdsTCPxsAmP5pJXTrp4avjSrB5SEN4H6bYhh9NwcUKUuAT+wK/gO+w8EHm2Cv8gS4q+vClb5dwNsmD+xfNocaiy7Dq5rfodH2GpDvsQ6K206DbgebQ/qLONhVPwL4KX5wY2FH+HV6R0gv6ghz/eKg4adD8LF2J3hgXgbOyRIo38IEDr/NhbDaYXBpSjuwP9cAvHz2wvIxCJq99IMDDaLh6atT0HnSG/jQ0RYWDZwDX0JeQu3tfmA3ch64iQbDpK9eULgpBDj9JWhXlAqPN9SE35ULwa76M5iRooKsin4wz3Ms6G6ZoUFUX7CxaQlnB1eCM+ujYNKjURCSkANVj/eAC4HHwD7/Hgyb3hjmxhyHtTWWQrdt96HqkMuwxkMCElsztJ6C4GirfEj2eQAH/2gF9Tsfg1ohJsj8+Du0re0OsW/PwptZNWFyoisE150M19Wfwa3ZOKjUqSvsrngSjlXNgC3Hj0LTvjw4wkiY+YcXPI5sBmknU6H1aIBdVybDrnXLoL3vdbjp8R5WyapA35ivEJDRGCJubgL/yR9hYvYQqFzpOeR4D4ZON27DurgOULfOObgxZxz8NqgOQO398MahOlS9+BAyW5phTK1gSBmihM1fesCU2FsgV+2FVvnx8MwwCkzHL0BoO3sYia7BLw9uwtBOD+BB2iK4Im8IDWfmw6OhfeHk2VZg9/gXyPvjHFTO6Q/vaq6DKnnDoXmFNjDdZTRM78lA8fzhsCU7Fmq9eAs9e3UFWeBV2Hj/Fmz16wLByovg0HA1XE3ZBTZr38KIcbGw6uh0UCpmw5yo8bAt4TcIv3kImq31hyLDOZg31QT1jwSC79nucPZ2O2i4/gocVc4DlzPjQFy/Irh4pcHxYcfh9Ilu0HfHQoDK7+Ba1y3QyPspfLsuAzj8FWolnYeIi0ao4FEMBW90sPP5MTj1sSEsliTBkUgPaG6/E6Td38Fsl3TYxE2C5rszoceiozCpVQtw9A0DzbpECHleG1qeWwoTfukF/IRHUPQwHvKTlsGjZ3GQ0nIZzH4dAn5+7eDgt3LQM3UXBK4OhUhNF5g3shVkVtoH+qf2MK9lPfig7Qhukhrg5MhAb7ux0NQ4FHpsTATtcxYO3agLH/5YC+qeGsj8xQTzk9bCroXv4fKvA+CSw1vgkltDce8psMN/LNz38APPkSKYER8LvgMbQfuAHAi7JYNWPVvB8D7R0C/yGnQfpAap/RFoXBwEFcdchwa2GTBS3B92dboLL2NOwKxPlcE75A+o2eAALA1qBCfPb4YtFQdB4qNgmH07Hppq+oN49WEYZ5sE79wiAL42gJeR62HMUW8IyOsMy+5Ph1VoGXRN+gZOMxOgJf8AFnXMgPsRCVB573Owe9gJKrVvAiN0WfCbbjHIyi8C5/xbEKrbBnfNvaFDojMMqxIDo9dUAuW5g3Aqfj/IPA/Blbdi8I5uAK/2vIe78oPgUHEjxNdvAQHTY8C+U2sol1QNBrhvhJqrjsK211thRH0XCDvaF5pNTIecwctAhKaDfeF7aOKZAGEtU6DjLltw5CrBrWPDoXjRcTi5pTf0O7sG1rW/AM82tINNi5LgfpexUNX/AcQkmGDs3IHw9W572LpiEzys1BJg6wpw/HIHAvqOgdeSvdBI5QZDBhugh9kdgj/th+jD76Dh4oewSecGYxLeg/hcJfgst4HbT2pC552rYUj1BdDugj306/ICKhxeDa3r7IbCjdXAR7UerhxZA1LkDMPHX4A6n2Jg0lwxxFfWwMm1v0K4+hGYXgGk9RoKx+/shY1jDkDMpUtwma0J2980g4SUI3BsyziY2fMOfBiZBSd1RbC5sAXcL0gFNEIPuQ/CIPFUbWh8dw+squcOsC0Vtvy6GPYMEUOjZrugt24K3LFdBzEby8GkYSvgF5fGcG9vM/j89BvE3/0O8Ye/wZOYULDZ8BU8dBEwQ10Jvs0yQ0MPW1AGtobGVWZC30MvYefzbbAgTA1LAjtCS8NwiLvZE9we/gKnmnWFesq2cCbiIrid2weG0G+wGlaCJPQJ/HY/C1zDe8Bolyuwf0QcRCi9IWRwHqQMZKC/b3uodX0vtH5zHCqo/WCk2xOY0XwD1NxxDFa0agd2e1fDy+3X4JcPrrAg6Ak0MI8DR5EO5nk2A58LWcCtSYGdK69Ci5EOsOtTFyh/5xz8cTgX0u4egU2VD8HZlVPBLngENPetDA3AF2IrFsKftjOhojQAlvLzYNbhB3DnW2MIqbcHJsW3Acm777DfsBzGBvtAr8brwef4b9Dsox5u/pYMRaeWgFPfecC5r4XVQ/ygItoOug5L4DzHQOT9mXDmwR4wjCqGvqrywNiGQEL2ZtiRkwsDfHtCrS/lYInmGKyy6QQ5nm3B5t4kyOt+Hvo1+gw3zp6G/Hc8TA54AGkBt+D24ZawetkxGDf0GgQ9PgGFdyrAAXcFeFXxAt9oP7hyqBjUi07C5uYjoVy311DDowsoj8+CRt9ewPMb70A++SyEL2wLdnknwHxzHqiDH0H2t5Ow2O4ITB6phZAtO+CCOgM8NJPgZPlg+HBpAzSKegi7zxyAvTAAHu1wAu2BuvD0j1GgvTUHnCo1halVHGHKmCRgGv0CmRNj4Nu3wzC4uwluT2kHBbcrwNwD++H4sq/Qcn0DeKM+Bkkn2sGt9YNh1/rdcOl8OXCJbwbhQ9pA08HxkHLxMdzg9kPI7xvBo3E6lPc7D9+kveDPoi8wv1MYPJrZFF5ci4OvuzaAyXgZmrc9Ay06KqGDazeofvs0TP3qAF96BUOLGrfg111x0C8lAQbJz0Nj33uQc/IGSKsuhWoR+yBoSQDU/20UoIFGiC3vDEW7y8PXc8XQRt8M2uiNkD/yPNz/fRQEzk+DRa1NcKbyPlAOTYM/h+hhwPSTcMtDBvcje0KzGvdhW5UV4NrUC4a9uwm3JybD8kE54DPzMwy2+QpPJ2yFeHk76LBFDoGL74Fv/kaYVr8DnH2eBgOcVkNK6+2w4WY5CJL0BNWOQoidvQ5m91kGny63A9dFO2HStF6QfMkVPDPvwb0evvCn1h0CX3WB7xkP4fdrfjApcDUc2DwRfN+vhCaz6wB/wBeGqe3AtfFM6NhjOsQ/fgZPl18D7y+eYB78Amo4n4UTw+ZA0ucmcPXICXA+cQnu/rYVepyYCTO6jgbXmZ2g6YQkkClnQeM+k0DXtBp0NbjA7PqJMF4RD+uPP4GndyfBcfejUL/oJXwInANOiwygWtUEOi/eDocmS2H1gHvQ4L4/BP15H1KTqsL6Rktg7MWGYP96F3TL5KBf8lmImOYPUybXAef9rWBd8XyoOPg5uL6xg90ZjSF8Sl9YU3UA7P60CaY9vAFL7yvhl3YsHHfPhOkrV4DmdRh0nDcRpu3bACGtRoBXg+EAbV7DFRgHX4t8gRnWF/IidcC/ywHpFsYT753xHr5ZN63Hj19dstdHxY/z26gB58d3wvHp1Qs7AoAnV29iBxyXT3vcDqev+S6o7fdpTVQ9KgUKR7YOXX8cMr93aR5jcO+0XJ/6wfHQoW9YjeIhUgzy9fX1PYEWNql8ydd3DaqcuzqwfPmpwpHvdBdTR5zvGap7fJr5kOEi2l3keNMuZDM639/ryqYd01Gce7+0vJu++MR8FKRXWhYitWF2NZ9OaYq2rb9s6PzehEbeu5VeYVSkXqkb55FaYEKXx8ySTfw9UT8jVp1f6bEJVXgf2HbglQSFdkalq9m3Tejz/E91dBfn6h+8v98oJNeElKefKft9GKU4nRZdpfspE0q52nr4k1WJiunvTp71OGxCYZOmj1ybukzhHP8pdOhuE/pq+rao2u75ig89NE0WbTahy+ktIjof9lCsvHy1VcEqE5KqE+PbiIL11a9+3zYmzYTKHWrReODgJfoBw11ymcUm5PuyX4JJ119/vmVozqE5JvRL0fX9dc4s1Oc127A1dZoJbfMd8eLxVZ1iwPw1p5MnmlDPxWteVqqu008a8Idin8aEOrd64FtYe4H+5byEDp+CTcjwawWUED9XEX0u/NVwfxOq/6p8TPrtpfprI8RxecNNaFQLd48PBamKjfvHtpw1yIQyOsw8N+35An3N21/l/fua0Lxja7vx4XMUNxJGz+7kZUJ/iJ9kSybqFEvv/bHQG5lQ0vr1j7/NX6roMDpaPbGDCf3RU/u2yu+zFGjtDp+LLU3o7fPayU166BT3Jz9SdW9iQr/bRaJJ+5bqp/oX//mwrgm13GQf9ueHaYo/H9QuzqhlQp8N4dXSXDvrE2/fyY2tYkK7HBw109rPVUhFT9bOcDGhBecuxi+qqFYMbuGxYZujCe3ZlN03uu90RaW9LR2+25hQH+3mR0yXmYqWt/p8jWBMqNfHqyM73l+gMP8SsMPuqxGJh8/vpFs1U/8mc5HfifdGNLZ/7/Ovey3Sn9vg3n7dGyOa32xA9Y+2KfoxtyRhWwuM6Eq7JI/8y5H6D5lP29x9bkSVql/cWbVqiv7p+grHmj02orA+jdf1zJyhkLdx6bP2gRHNCWo4cZTLYn0N3WZx9ztGNDy+cs8F64bqGzf/4Opww4iqp3oHpjWdrF+2vv/t4stGVH7z0VGv/bsqmsUrR9ldNCJTgE0n+zFLFUOg5mv+rBFNEK248+d5tSJXcWT3ypNG5ObijOabFyseXL1Z2PiYEWVvm3jwYmKMokHjdtfvGIxoXN6gV4dqLlY43f+WskNvRPNXRUKbpAX6dU0zYnbsNyLvVYvvnX8wS99lzKWVd/YYkV8H50MnH4zXT/PJGNxklxG9HzGpwMtlpt550cizq7cb0fyb36pI2i5W3Gmwu12PbUYkSZvTYm/yJMW3U8uuuWwxIvtBNR796Z+oaDSo533bTUb08mTV/jNOtVHs9Ro2p/4GI2qbE9DkWaskRU/XLZXC1xlRZkyKsteTBL39vZj9f64xovV9TZ1OtE7Qz/B1z56y2oi2vmgSP/7XOD137Hwbr1VGNHTo4PH3Ly7W15P7Tuuw0ogCqk7RbZQNUURt6HPNd4URNZT/bjDtXKy/0Cl2zPIsI5q2v82sLS7BesMdabRLlhEZN4TtMwX661tUUyl2ZBrRgNl5gzrf0+njkgZ8+iPTiC55/DYloPZ4vdavID8604iy/5ib08s4U6+duqZnaqYRzXnmW6tV1Zn6M4FdBr/KNKKr1+x/P5eeqEAjH/gEZRlRzTV9999rNUk/i3kVVXGFEYXkBA76VpCkaHXEjXm9woh8Q29s+vOVSjG636V271YaUZdLO1ucWDFb71LNY1CD1UbUpn2nN3uCFusrXOyTEr/GiGqZq7rH/a7TbzlVx6vaOiNSD9Hc6n8tSf96Ube02+uNCOaUGx64JVGRMmbO7VMbjWjXy8IjLfbOU9zNatzl6WYjMj8/kT5qj0qf0G33L622GVE3v3fDpr+fpGg3rlLK1u1GNL1zrXW17RfrT5oXSofvMqJGtULn7tswUv/0xIXs9nuNaNj+xMmf6oTqnQeePtftgBFt/FQk79p1kb5/vweZ0w4ZUe/5Y26Gnp2hP2B7NuJNjhE1uLiwyddtkYrEwlXTFh43ooNRDn+2vRKmqFPncVX/00bkLx8tF5+YpVc9HTlpzHkjut7y0eOZNeYqWjfrVZCWa0SVDuqvXj64UD+ynscO0XUjutLSmN7yfKJi6E63CstvG9HO36LUcUFxCsO3Cb4hD4xoV8b8ZRceTtNPfHfVEPLYiGa1PrdoXLUExZarv6Vk5hvR59uXey2YlKgfs2deI1ujER3Yem/w7WO++i+VfPatfGdEnu/Xdi63OlHvPuzpPM0nI2qzeEuHohtj9T1+//I2xmxEbecMDXlkXKjvZbPCLVtiQhfu+zncNGsVV470TqzlaEKbkxd9/nJood6+1s3hR11MaKfjNret6ihF+sAZ99OqmlDSt8wRrR7PV0zMNftt4kxo8zD7ywvy4hS9Lw9p/qaBCQVW69dh2wV/xe7nNklhLUxobNVFoU1DAhVBiaZ7XHsTurL7/PQqc3T6z8dG+kqRCYV/NqORWxboJ8fb9mrWw4S8N0R32OqUqH8b72Q3y8eE1tl2XjtjlVYxa/WXe1WGmpCz3JNbvnCaPnn6mV8ejzKhzYuOXO//23zFjFZ3Rc+CTKh3CLN5mHucYtQu5p1rlAnV9thl63p9mt4vbVLrZZNN6IxTj077G8frG60orug104SuznYfJd6jVbxHc583TzShSE3GgIIT0xXT+5z6MiDVhAoXXl3g8mGB/k7i6pXbVpvQH9o6j5K3ztO/CZzfrOc2E7LjNvL6Y/MVDX5TGqsfMKFWrzYcS2oSp1h2IKR9kxMmZJxxueWGgDkKz+7q4TG5JvT6cacnB9rP11c8nL7l210TyriwsG+n+HGKW4nLpx55bkLx50fxRyS/Kt5ELmhy9J0JQQe6Q3ALPLV4yLvmnRl6yWwY7jbgx9biOkrs/spsNl8ylGfe1N2ZcgZlnrZ5Gu17wiBcRhvG4Q2I73V0juxILhkc7y9JSUk5g9Z1D8Q7E4Pbg26r6nofRarOXVabzQbD2RuNG8ZF6pF5bHbXVyn7DTNyt32YNnUvutD9cnSFgbsNmQ/yjhW2+YAg8dmE2PM3DbVfNA0eX+EDAnA6agy/acja/dlu1Nv3CPIGVHhc4abhj4QKtddefo9gfMMOw/fdMFzedULqvR3HdYm+I28YDji2aN1j4XsEUCUml71hqNNFXiUz8j2CxMSZZ9dfN9yutSbFZ+B7BP1Fg7v6XDccr7tg4+DW7xF4hhxr//6aoeK9jJCdFTF8/bd1GdcMfUacHBjwvhjB+viOi7pfM/g0Xbg78FYxgn3ZHYteXzU8SBx+Tn+gGEHEgm4Xl141jK92+60yoxhB1qHKtTyvGmYN9nIZrCtGoPMyPXpxxXA15PnFZf7FCPLcOlRPumJYHLvuUb0exQhm30k44XHFML27TRdz42IEiQ0a/fnisuHhoR135c7FCD72bBK25LLh5oM2PRa8K0LwcX9qIH/Z4NnwwaWut4oQJJuScl/nGk6vGp/jcagIgexulTWpuYY59fKOxa4sQrDPf+CzHrmGNnHX6kpmFyEonNld/uqSQdqsavWLYUUIsitH9+pxyTCoSsert3/9EXeTde62+qLht7hd3Rq4Y/iLbk7sRcOXj5X43RzOP67RylEXDNuLPO5Ms/1RX+ISMZNz3rDg+5CRC4zvEMjiBzfizhte9JFm3b6O41PnVZ56ztDkiCxn1KF3CHKvnj/z6Kxh353oJnXX/IAnujT37H7WwOZmXpDPe4egsObYcevPGGpMjDsxPPodAreeQWGOZwyP2m3xvjjyHYKc7mu5yNMGz2t9kyd4YXjFXQtunDLUPWe+OKLFj/wRoxX7FKcM3k4rosdVeYdgVPu01FUnDYkdPdqfZt4hyNo7qKX0pIH/uORgv1dvEbjVjfkj6oTh8oaqrMN1HD+6YNK944bG3/au/3T4LQK4MqCp13HDpuqOE2tswPHp+jnZxwxuuyuO0izGce+QlOrHDMUrhgz5/MdbBJ6rEwfNOmowdKqZtnPsWwRZEz7uf3fEcKh4wfSMX3G8ab3To44YOtmd2bjX40ec+zAk9mKOYY/nhiZMYwz/7n1PkWNoxZ9fOqHSj/J1vfWHhhgMaV+v1OQYXL7nUrv2hw3Snn29iwreIPD85JFc+ZAhSLVgYPGtNwiybvUL/HTQMHnKkPJ1TrxBMKoFN+HeAcOL+ue0k7e/QaBr+PxYzn7DnmpNHZnlP/LnaHZ6rd1nOBSxZ1L2nB9w2LyTmbfXsEdvqjdnHI536P5Gu8dwp2WftvMCcP5ZYeV+322479cgcf+AH+XnrXgwoucuQ58rrVaXQ7j+4L63W+803Pkk08xtius/8XECt8PQcndBQ7dqP+Dc6GSvctsN29rE3flii8u/Ehz6eZthZ0g/Z2NxIQLPcb3m3dliuJjZeKTNE/wYNuNJgX6TwXVNU/9uV37Ac1w841dsMFRLfjR5XQ6Os62Hzl5nuNzu5PQW236k190I/D1yjaFjhazkuxk4rvKeM2KV4eHzgds2JeDyKwU89l5h+NKwX4vMSRj+alqOZrmh6oK2CbuDcXzgwDe+qYamnwrWGIfh+NRLozsvNSQ2vXzB2xu3Z2PCl4aLDBu2FJ482QHHP3GTWiYYNrSaUEHVkMBHtq0aZ+gZ9bJB3So4XnBU5DLesGR7RRuxHY7XnWAvHmWo9rn+h9p5JgSQGPfOFI60L5VHa6zA8c5t+XuzUPOUqdky/x9x3dHjqy4uRhe2GBXv62F4fMUjmWnoeYWFotMv8Gtn+Yu3slegTdvPjddtNSLIYXKHz1mD0hwzVlbT/oDrbnlOH7EB7U5xmL7QHceHmIIbbEGDU0fZ5zE4ffLT5OhslHxw3FPm7GsEnNPj4l93INHCydK3i17j8Z97v/kudHHElzGbR7xGkDNk1jCbPSjjwe8bmzbA8OC2MXf2ogtNQzzUbwsQjKrRr+um/YidsG5l2GEcdzp4avxBFGbXPqz+3AIE3PNWFboeQuKhIw8lDcXwB5EtHQwoIfNg6931CxB4LmxSKTAHoecFxunFrxBkL5o2o8cRdGTp3ehvx3/E3c5eUNc/ihr2mulYa8krBP1PrL0pOoaaephOPFK9QiBrrTj28BiaO/tMYM/2rxDoJoa0O3Ac9XKr6drb/hWCwssNOy4+gaaY3s7Iv/sSQWGVuheCT6KVnUe1rLnt5Y/1aEzBR89TaN3Qq+jZNAyvVpxT6TSaG2Vv8hzyEoHu/aBGL06jBr03JTZu+hKB50e23cEz6PLbxRWymB9waFrj9dyzqLribt3Mmy8Q5DIjBgw/hxK3n5LU2/oCQY7+fGCj86jFxWVvm894gWBUz+tt359H0b1XGw+MwHCvNoeOXEAdej7PONnmBzzv0j4m4SJ6NjCwhY/TCwSJlXPsfS+hjJvm+QOf5SPYV9sltFwumgznMy8a8hHkLi63LzIXlTt2+E5OSj6CiJnLQ67loi+V62xsoMXw3q1ntbuM7FJ3bgaffAQ96wQ6JV9Gvh6qfO/G+Qh05/PMHy+jUWzREsYmH8FY/5t+w66gRqvy/Os9eo5gfUV7t/1X0Jbd98btPPwcwaiuMk2Vq+hovWWBG9OeI6hSEFZ/3FU0xKbyW9sJzxG4bfvic/0qcqxw4+7ZwT/S57V4bGx1DYXs8WFA9gwphndZGMpOUSzZ1VcEbs8QPxJ6vjTMU4y/luQE/Z+hvWtuzFwXO1+xJbyfLUQ8Q33qDQp5+VWp2Or88Lt5wTP0rdywPg2mTNbrT/jbQvYzxNy513PskTn690dG1ILcZ6j8Yu+MGmi6wuO95JXZ9Az92uxRNbFuil63bGY5kD1HAyfYR44xT1K4vAj8am7xHNWddaj+I0hQBJef+tDs8xxdYd6oF7JqfWJ6oDNEPEfa9EEXIr8G6tuenvLZvOA5mi4uXn7k8FTFs6Pcd/O250gVcL5R5SkRejiDXpsvPUc15k6y0+h0+phq9V+YTc/R1k8ZYQ1z5inyV6WLQZaPWvd5OuBKbLxiQdPFlcEtH01957bnxfc5+vSo1jbQPx/p26pCDIZ4xcn4LhxE5KPoSeXfqQxz9eIJxa/MC/LRkHOdV6ohXv9QrJdDdj5y6J3X4SH8oZ9T3fGp+VI+kmSavSJhtr7r/IVfzaZ81CFiYu6kqdMVp/w+1wLZCyTa9TBmoUe8Yv8krwrg9gLFsMm9++liFeG2xmdmnxeo+Wjz7cIpC/SXXRQPzOEv0IEO9ZdunBahd5rTvci84AUyrQ9YWF03S+/RPPm+edsL1H7xb3PyPGfpx3zxfm2+hOk37YjdRaQYkP6Gg8IXyGH47AYb0Ry9TXb38iB7iQbfGZrS06xVfH5/0BbcXqIqYU3mbDqcoJhQc5kM+r9EbhPG3z/7fbaiZ/PimhDxEt3ddKtzDL9AP7D1sBqQ+BK5xByNYw3z9b09fBpD9kvkh8wK8bcg/eVaW2+aL71EuyISXZ57TNOPFw8wmk0v0aoH5fI8bIIVw51Ud83Or9B+h9odTtv8phhyduN3c4tXqKaijrYWM0F/78CS22afVyiz8cyxMvMEfbpqeV2IeIU8fGbmdjfPUXj+MuuTecEr9OnY0aXjvk9W+JwTXzFve4WON3lrbGD213cfwV8xX3qFXF92Mu41h+of2vt/NJteoRHS5stE/FT9rzG7/zQ7F6CqwXuTAo7MVTwe8vmNuUUBen3SbZ7pe4C+7hPDPbNPAYruUaAfi+L0H/YPem0OL0AFeb8WrpoSp7i+IOWVeUEBerPo0zyb6VGKVNd6rpBdgMTlqgTM/zZWn+6VdN98qQBpXp6qcXjKfEXM8W8vzaYC9H125paOh+crmnxM/QVkr1Hkb/vXL/wjWlHzg7MTuL1Gd05FBCUeiVccd57w0uzzGjl+H3qifbmh+qez7jWHiNeom/ORvjd0sfqN0+65QuJrNGLEt6QFk7X66WzILfO212iK0vVEzdgERcceoY0g9zX6dbt5x3JmtqI4sdtTs+k1ij8/8OQVUCuS3m+6YHY2oitBzTjP6bH6+6cH3jW3MKIAu+pnj8AkhemXLm/NPkY0YFNS9nqzRlH+9zn55nAjGnbYtD3q/RC9k3l5eUg0Iua09Pd5ujh9t8prHpq3GdFurut1GxivWBHrUg1yjWjRiMGjPrL99cf1B2yh0IjKP2s7spvnDD07b2Kx2dmEJAtNHVt+8dGfmvO0FriZkG/5qLebp85RJLWZVmz2MaGup25e49EcRUifDV/N4SYUPT65RhE7Ws8f//SneYEJ9X4+rujyH+MUUx7nXTFvM6GWqyanVmXC9cufjKsBuSa0ffPF3sapkYqWx/I+mE0m9NusCKa9RK1Xj1IVmZ0L0R2HGt5bpszRD5048525RSHK2/H1WFDsMn1lp6/fzD6FaHjSuTbfDcsU0/peEEFEITo3+EnOdJimyD/39pN5QSGqFt3+8ENzmF51x5GB7EL0qv6zrbFoob7D1dUM5BaiD5k9J3z+Q6f49u3OZ7OpEOWE3IiQiMfpl347IAXZGzRaGhZ3TTdfMbLo6WdzizfI1O5bwGdDhuJ26nUn6P8Gbe3vEjEOUhWpvq7OEPEGGR88fvTp2zxF/UENvpoXvEFRmk733GChYpiiswtkv0GzGZFuQmyKYu/yRh/Nl96gwITMTa0+qfRwbU6R2fQGvRq+LsMQu1ixeuZcR5C9RfLh3xaG6DIVoq4zROD2FrU2ZL46al6siHuvN5t93iJN8+ZTnjMxituujYrN4W+R0jE25uDXWIXCfXFFSHyLmvCs4iyr0Vfw960I2W8RW/tt62m6RfpOA7+/Ml96i97e8+kwxTxbv3TLPikUvkUneLf+A8wz9NseTfxidn6HMhr+PjsSpupj/TZ/N7d4hyrt3YtGmhfqBweudYT+79ChaXPl02KXKFw/fCkPEe/Q+etOxw+ATrG/xbBP5gXv0IB1O5ploCR9lyv3xZD9Dv3ZISYiJHaGYsiZHcXmS+9QSxeDzJ2dqKiyK/ul2fQOZQ/cPiYsNllRtK1VJZAVobozqvq1/xioaDS3R2VwK0JdB9zTPGOmK/x3LXlu9ilCv8Xv2BdkjlfkRYvzzeFFaNDbo2nbc5bonx8JN5kXFCFNY/e39p5pCvG6w0/N24pQ9z+cDHvNSfoHDWSVIbcIdQ6+FxmQk6J/5FHoDIVFqMavM6TxscsUl3vfcwFZMWq3ekykSjxKMbGB5BdwK0b2repcvGhYqu8TcbfA7FOMbq6QSDRsvH7DID+TObwYuQScKffMkKZwkT2rDInFKNG0beqJKbMVizzOiCC7GOU4Ghzs+Ey9vqp3TcgtRo161PvSeGqyPn7ivudmUzESB73W7Z2SpP/5PsJyzzCK3DM8NdgIQnD9fIelpKS8QBNXNyLfX3TvmTbc+63hGKo/t4lFyC7rPQI+vgiklU/vfzut6Q2DbnD7hnV3fVYQqA5DN2Co3VDDocvXDdyHvFt2a2ocItBRGHoGQ4d2rzwu5rohrP+e66tH16FQTwx9gaEfm83aUu264Xpg9vIncc/0VLLy/2vvyuOiOLL/twFFaES8QNQoxltjnJuZxGwzMd6ArrDxjANyTuSSQ9C4CdFEJWrEmBhNjGI0iZjLbA6jEXsUL/ACQeNGY9DVjbiaGFdXcxi2X3cNMwwz6q6fz/7++fWMTtPfqvq+V6/q1avqqR6Z94aEFuS/ZtlZK9b9of8KaxcfJS9kXkLjuu5eHF8rHnohcuTgk+0VXetuEC+hmxYsUPnUio/w86788/HTisw2QusJHWn9U+S7NWLcq39csO+TMCVvCaFF/wIfUrjqjW9H1IivFO6tjZrUW0Fp1cFcSmjY2e3nLh4TTw7currbM30UNE7mJXTRmfaTi46JwpajX3So7OiE1ntCI2Tem6Tv0V/N/Y+Js76J6ddrcrCib5jMS+gq665VB6pFn9jvU3d83J3VhsxL6Kb335+aUi1e3TRPu697d1Yb14mX0JEf/by4RbWYPLnF7T2b+ih5bYQW3QIfUpxzrteGKjHQ+/qzP8wIUNASQksJrfrs1d4RVeJzg66v/dJwdYcDrfCEFsq8hEZMS++07ai4cMjq9wdMaM1qQ+b9mSx4+uCHV4+IvT5esGZrn4GsNmReQq8OyPDte0QMahBixw4OYbUh8xJqGzujx9TDYpfUyq+Wb+/BWrrMS2jJG/tvLjsk6l5Ylzp2dl8ntOgXD2jdP4mX0OJBuQt2HxSXbV2s3hIdqqA2QisItRVGV/yzUkwuPiwkRG9X2lUJofWEbjnXfUfPSvHSruGnE5f0LnOgRb96QAtlXkLHXV8zeXyF+LfaXT5/rR7A+pHMS2hVWFLJcwdEv19OPSeW2etK5iW0Lsir6P394sTRMdnFp5zRot88oGEyL6FVod+3ObFPTD73lw1Pnw9i7UrmJbT4vSxVw17RNC5o3dC13ZzQek9o3TXivU36rv/bhT57xWVTfIsXnwljrY7QUkILD6YNjNojDinQx+8KCHnMgVZ4QksIrSe0uFvYbzPLxUdi+0YtKPiJeSSZ93dqOd1vjX9tt9hqz8wQ1dJerCZlXkLjBh8fsHWXuHJD204bCx92Qis8oREyL6HFVXOf/domXp9ycdFKq/9jDrSowQMaJvMSWndKvfyyKF7Tbpgam8esD0IrG8AHD8zw7btTHIKrAx7SDXjMAV7yANb9RKyFHB9im7IsdtoOseVOy8QJAQ+wWia0lNC60Y+kv7JdPLB5ykW9ifkyGa3whJYQWk9oifrEsPIvxdQnB0f1n9veCS163gNaKPMSGnfhpWNXvxC/ydFWhL/OPE6czEtoWEvBt8vn4oRp++KneDFvJaP1ntAImXceydxl5dfmT8Xv2v986JtpDzmhpZ7QMJmX0MINPxiSPhH9NiybNW1uB1bNMq+MtrWp/D8Wl79smL920iAntGi+B7SOvuFeKqOhM799/H0xMuvEhTnzujqhFZ5QWmcz1xNq0/xrYu574g/rr+mG//ZQmQMtesEDWiLzyujv2xau3SBu/r3Pja1eN4Y40ApPaCGhl17g+OCCwDfnrRPP+z07t09h/zIH+NKL7sE4mfVF0ue4b5dtr4umd39ZEbu0H+slhFZS1t+2bLItE9e8W/Ovud2+2+EAL3kAw2TSBRwfHDRjQN1z4vmIb1oL50LLHOBmD6C8w+DMAo73opPbCzje2/YjFbaQ44OL8joGFQoXB761esZ+5tcKCSxdSBqsmPhkWLFw7Oa5llNO2+MSQispa0W/3qNWCbqAyZrtJcwVg8B6yhrxfdFT5hIh5uufptracsyYPxDrIo4Pfrj2o+SNQr/bZXk5wcxahQSWLiJ7rOuw+dVNwp/7TK56bTbTIYLQChn99nDOwQ8E334nR1xL7czUJ7ReRlva1Jc+Ep55tGLsH9oGMl97hVpJEfW34dWPvv6J8Oba1k8+pbGPPISWElpX/d6Nsk+Fr6NPvTPtAOsVcYRWEFryetTk+s+Fbg88NaSllckcQWg9obZL/jXYKmiuvFW6tNtlpQ1B5n2JKmPSU9O024RvRpQ9MrVtT1YZl4mX0LgPlx54+ivhQurNgYXF7ZlUhFbIeXdwExftEGo+mLyverg9kiK0ntAw//mm/TuFumF//zjVNohJRWjRYtLolGn5RVG47b9+7Amd3ZvKvDLad97LIbuEa76DjhT8yKKDun8QL6FXez47cPMuQbfa+MTL77HaKCG0ntDCBQHx1buF9Z89fzDtLW/m1wgtWsLxIcUdt/yWVC4UZY/puWnwPqU2IggtJXSLdv5jy/cIBV/cjp09n/nTMJlXRtefv9B3r7D/z9YLF7VM37pLxEto0JKd0RP2CQUPD3lo8VF73EFo0VJJ5qy8xe2u7hPO9lhzYWlbu30JLSV03BMvLi3aL7QYujwrKNkegxNauZTjg03/+HjnAaH6ofrNsY/5sook8BKBN09PnlwhZDaUTOx3zZf5PJn1ZarHl4ZcWVEpWHs8OW5oNuvndfXESmjVlAkn1QeFzWc/iF6qZ3GjjdAKOe+jxoVVB4Uv2sVO2jOG2a+E0HpCg67u+zXzkHBs4Mq92Zd/UvxAHKFFy6iWa7c89slhQb+l480BDawDRsi8hAZ93xAYc0RQXTfH9W23W7FBGKGVyzg++NvzH944IrR9+aukjj0qlYIh01LWLZ+mdV19VFB9F1B5+WAXVskXibaY40MmRsUZZ1YJy6OvBJ9ac4s5U0JLCY2LTxm0p0qovzQkeHEnFjYWElpB6EVqctVC16vvJAT2YJ0ojtB6Qm99cHDqjGrh+eB3bh5+wx6gybzLpbypkxNWi9XC1rIRf7zyrn3QknkJ/TIwfViHY8Kl7cO3n1nIwoq674mX0OLTc6/uPCZc9xk3+pc1LDiwEVpPaFzN2Z861AhfDulRM+ccM2AJoUWvUEXunJUyo0Y4kP/TlsMZbZlGhJYSqtLmj99dI0wta/lF7KOdWPeUeQm9eLznZ6G1wlt1xZcN51sxjWReQg/M3L10Zq2QdyLF70jfwcyVybwrqOSQtXUVtcLGk/5disJYkAWZl9ASo+9HDx4XJu1PfD5rJ5vE1tG+uQpCqw7E3HzmuPBjxFM/XPmQBQc2QutXcHxpi7hJ35UdPy6cTtrYagDvLxfdYQzgD4AHEACgNYBAAG1ogxmAtgDaAWhPaQF0BBAMIITtHaIjcgzQCUAobQJraGigf3StM4AuAJ4YDUwcraTdNAboSt9FdOLrBqC7C18Y4+vB+B6kPUoxuVqLRWNStqNbM3NGJUTHWNTqhNT4bAtttc3NGZUwjHYjKfuQNo0GlkQ25lPrG/exJ8WnT89LvkN2eT9T3WhHXi0jVTJ7zvlZAdB1jKIrfeOhdjTgfb2hobkM1owUjzJEx1hMjfvdm+iUOEaxGRtqMDUS6AmgF+2Ta2hooH90rTeAPmT9McCtMUBAJFDrlM/ZZvZ8zjazy2ty6G3NSLmT9p5l7hCp8NFB9ugrtYN+Dg6j/WkWw1i9F0TCXLKa42t8qnPXYsJbZQMKs8a3aWj4Q19qqYkALnoDQX2BkgUcIh5vg8KVq4CzN1qQRnopLp0JYEZDQ8ORXxsaXhEbGuwbKhv+0wOcl7dPi5a+rfzYBX8+oHVgm6C27dp36Bgc0im0c5euD3TrHtbjwZ73hv8fH+C8fHy9W7Zg9eEF0G45mw9gawHYWgI2X8DWCrD5ATZ/wMYDtgDA1hqwBQK2NoAtCLC1BWztAFt7wNYBsHUEbMGALQSwdQJsoYCtM2DrAti6ArYHAFs3wNYdoI2un3JAuRdQ7g2U+wDlLYDylkC5L1DeCij3A8r9gXIeKA8AylsDNYFAeRugHAj4ikNAuRcCyr0RUO6DgFOkz5l2Pq+52rkqWvEk9o3e5pK1HO91Phpm21qOHxE51DI0dtI4udNHDrVE/ylq2PhRQ+Xz2FFRw8CuDx0bGWmOHSafR42NHhZrHj9JPh8WE2MeMSwG5uJ1HG8OhT9CQ6lTgdUxba6Uvat8hKKtf2hoqLe/Lzj48Z0Av5Y84S0pD+U0n13H8T0CHRn8W9Pl1mQsv0C5wEBy0eY3SzieC4D5vRKO70juWfbR8AuQ8wXQ23yc0gTBfJbSkEv3aSOnCVI2ENPbvGw9x3PtYH5zPcd3I/cr+2D4tZPTtJPf5BU6d+4M87H1HB9o/4vpZ57/NsdzHWBe9jbHd6SBQR4d4NdBTtCB3uYyShMMc8XbHN+fBhF5JIFfsJwmWH47duWbHx/6xLDhheNhLnyH4xs4L7i+6CnZ7IW7v7g4H9udXq1ONn+5pDju9Np7b68m+U84vfbd28uel36Uo5TjvYqfhPnVDzn+Z29O6buw73RtwXa6Ou/o/W9HdfuoYB8J7KO1fZQOY6Myjcj2kcc+2tg9e38AAwAMBOgH5eg3TvEwgMHk4QGoAWgkJ6Cl7ejMZ9MWhXDak0BbygH6hXJ6bL88YlEkQ1sdaPGdti6YATxOfZqiCwDUTYcDGAFgJIBRACjgoEEnEkAUjTa005x2lwP4I4DxAGKkEToWwJ8APAlgAo1YtJcfwGQAU2iEBfCU5FumAbBQlPc/5H8GwFwAfwbwrOTXnoO5+HOO9yqZCvPGbf/fEoB4ANMBJLDIIAlAshQwp0hRQqo0ubFKM7anKRqQZsBp0tw8HUAGgEwAWSxSyAaQAyAXQB6AWQDypVi2AMBsAHPu0BL+V/xuWkLJLo7fxTmcZvz0hMSkZMV1FkwcOChrnHVURrRsEaB3lvy/49Fg8tNSmMHSmUF6MyXs57PZ5yRmOHvaQU5pe7Pm/gg7j3I6j2GNpDdTFux8ZJP05qu7Of6v3s2BpgXJdymSmvoAOmKTHX3RfA/9kY4dSY5+ab5L35Sj1mRHHzV78BN0bEl2tBKzh5aSyyyex1oLWIuJZy0kx+n63YzjvkKb11tvVr7dGNOdzhOdzkfegyEnOZV5b4Y31+7j+JV+cxMc3cTsCP8NNGVIS9Inxyck5TZOcxIA2yz2lBeWL4nl+0+7F+PRJ+TOzkoalU+PsmCTG5V8yT73kB9hkaBM4Q4lNAbIILnp8zr7pKM4UZEpm8l0p+7L2MITMhOTEmbljkpIUKstlvTp8uOiLLlO8mhYksbZkCxTRqIiU2Ric5kWJTpk8klSZJrDZGruMoBCaVr6vBuZnshpJpTMWXcXzgLGOY9xzpfkeEEahl6UhqEF0jC0kNJLw1CRO06re87YJM+crmXkNy9CLmPV3cuwtzuLxZqeZW93p5OU9A6eNHrKG01nZZwanzs8n+FhTXHW5hIa5YpI9tyu7NPhjLz0LHrWEssml5vbtFxHmnxHmlUsjRx0JwMvScP+YmaXJdLQv1Qa+l9mdtMlA8uoHTN8uRQGvCKFASsYXpWi2PVVhtOsaqUUFrwuhQWrpLBgNT0USQoL3pTCgjVSWPCWFBaslcKCdU42yshLt6Qk5SqrBSZr47KLxZqblK0sErhfRXH0CJPF0liKUz/RNV527rsrU5Q6LkxxLL9sYed0fUhK87r/MgXm60c5vpLbmKpoXMI0Xi8FNm9Lgc0GKbDZKLmyd6TA5l0psHmPFrGkwKZUCmw2S4HN+240zveocX4zjfM9apzf2GpyU91rpEptrtGSVJgPVHP8GW6JVdHoA6bRh1Lo9ZE0gHxMpUih1ydS6PUXmolTaS5aZOXZ7ZZ5H3aTS2lut6y8JnYbb2X2sTq0TLM6tLzlRstcK8xbajh+Jxf7tKLl50zLL6TgcStZVgoet0lD0nYpePyKhnwpeCxzo2W+Ry3v1VZyKY226vW0ey3qrM21GPI0zLdqOf4NPnYGsFMKa0WmBa2Q7JImGbshr3ZgjxTU7JWCmn1siZXS76eN2NIgXCEFN5VScHNQmmwckgbiw06+hJ4ued+dUC5EMRjZq/WMxvI1KovFTmGhVc3M7PgUu7+jtP1mKNofYLXi7aR92AzlM3KGYy05Ig04IgVjR1k9VEkBWbUUkB2TgooaWk6VJkvHpUDsBKsHSv+15P9OSoHJX6Vg7BspGKOVoNNSEPatu3q4j67pQVnZ9KRrxzRF16oZnnU1pjl0PZ8GnJECxO+YrnWu8t5nJ1Tb5c3Ky7XbYy+TsTCteWs87SRbYjpwVgoUzzHZ/uZOtv+m67De0DX9zvy30pVefZ7xX5CG3r/TfRBa/KV7VnQjTor7/kE3NumWq9OStSo9MyNpNhtCI6ermlSJjDWNr06mKzLtcCPT1XRHrJOWocj0A5PpR8LpSxD0bRT64g+N5fS1M/oinhQD3vQsk5pkIs5xGXfmrGOctxjnz/RUQCm2+5XiYim2uy3Fdr/TgidzORznnjOf1QNx7rkLZ2ymwunFKZy0xuDDAS04oCUH+HJAKw7w4wB/DuA9czbqacy8M+ctxhnAOFtzQKCjXJNitvt0ZHKo6CjI3m9PZCr2L3YnYybMa+o4/g1uTZYiYRsmYRAHtHUr4X24mKYSNnqWOVmKhLqs5hK+mgWz7SxJGDFTkbAdk7A9B3RoJuH9OpVGCe2Duyxht5mKhCfdSGicCfP5cyTheSZhRyZhMAeEuJXwPkblphI21uFuJuHcmW48z0yYF53n+G2tpmYrEnZiEoZyQGcO6OKQ0pielJMTn5KU0yS00dqvNvUtpmwWFWQ3Z43NdrT/zxhvV8b7AAd044Du7njzHX50zR3KjWHz0Qw25453WjSIYnNkd1is0+JEjht8AsMSWX5P6WLZHD3PaYnLNc1whlndYDHs71ynMtylsevoqperLq6yu8roKo+rDGCLSPGs/Dx2nu2iTxJbYMn2kCbK6VoC4wfz71lO/Gku6Wc7yZDnVPfO19Kc0pnZtRT2meOkRwzLm8WuJbG1k+nsnDUreVEsgaXJdINHs+uz7lDGE+zvhDukca5X13p0rTPXunKtE9f6cK0LV/1d9XTVy1UHe3lR7Hycsop56DLHz4m8S1wOFgPeKWaVv7QxCwjjgB4c8KDT+KqzWHJS47OTEi0JmXkZuY1+ZuMs0E8d8wc4lUqlVmlUWpVOpVcZVOEqo8qkVqnVao1aq9ap9WqDOlxtVJs0Ko1ao9FoNTqNXmPQhGuMGpNWpVVrNVqtVqfVaw3acK1Ra9KpdGqdRqfV6XR6nUEXrjPqTHqVXq3X6LV6nV6vN+jD9Ua9yaAyqA0ag9agM+gNBkO4wWgwhavC1eGacG24LlwfbggPDzeGm4wqo9qoMWqNOqPeaDCGG41Gk0llUps0Jq1JZ9KbDKZwk9Fkgnnjjxx/zedut/xR+caj0RTqJhQUxE+3zlKrDVRH1nSLvLZnzUjObFwhOZAPBM0BmqYPt1gS0uhJ9k0yUPpb+cDlfMUiXQuAnhzQiwN6c0AfDujLAf04oD8HDFCeb4ESlm6gS7qHOGAQBzzMufDTtCLH6k4EWYaCAoVbXgllZQ92KVvFAWoO0DQrW22xzEq3etKv1qnsibOVm0daDtAxXSLYNT0HGDggJtfk+L0Q1vJUs+XrjufHs7JHzlby07FotnJzKpwDjHI5anVaZoo1gf02iqynU3obS29ypDdYM2bFp1kTLfHZKXnyT/PYv+QzWylfvj3A8j3iyKdRHuDOiFieOpYnJtfUWCd2fTAH5lXXOd573CtB/wYHfE2sz+0GAA==";async function Pe(c){let Z=Uint8Array.from(atob(c),E=>E.charCodeAt(0)),r=new Blob([Z]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(r).arrayBuffer())}var U=20,qt=200,H,R,B,J,x,be;function Me(){let c=H._live_values()/8;return H.HEAPF64.slice(c,c+R.length)}function he(c){H._live_start(c);let Z=H.ccall("live_layout","string").trim().split(\`
\`).map(r=>r.split(" "));R={names:{},length:0};for(let[r,E,V]of Z)R.names[r]=[+E,+V],R.length=+E+ +V;B=x=0,be=performance.now(),J=!1,postMessage({fields:R.names,seed:c}),postMessage({frames:[Me()],ticks:B})}function At(){let c=performance.now();if(x=Math.min(x+c-be,qt),be=c,J)return;let Z=[];for(;x>=U;x-=U)H._live_step(U),B+=U,Z.push(Me());Z.length>0&&postMessage({frames:Z,ticks:B,busy:(performance.now()-c)/(Z.length*U)})}onmessage=({data:c})=>{if(c.start!==void 0&&he(c.start),c.paused!==void 0&&(J=c.paused,x=0,J&&postMessage({paused:J})),c.command){let Z=H.ccall("live_command","number",["string"],[c.command])!==0;postMessage({command:c.command,accepted:Z,at:B})}};Pe(Ke).then(c=>je({wasmBinary:c})).then(c=>{H=c,he(1),setInterval(At,U/2)});})();
`;var so={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Ji=.2;function ro(i,t){let e=i===Ji?0:.02;return`attach ${i} ${e} ${e/2} ${(.1+.07*t).toFixed(2)}`}function Xl(i){let{act:t,view:e}=i,n=[...document.querySelectorAll("#controls button")],s=l=>t(ro(l,i.held().length)),r=0,a={attach:l=>s(+l.dataset.attach),cup:()=>s(Ji),hang:()=>t(`hang 1 ${.25}`),command:l=>t(l.dataset.command),pose:()=>t(`pose ${r=(r+1)%4}`),restart:()=>{r=0;for(let l of n)l.dataset.toggle&&l.setAttribute("aria-pressed",!1);i.restart()},toggle:l=>{let h=l.getAttribute("aria-pressed")!=="true";l.setAttribute("aria-pressed",h),t(`${l.dataset.toggle} ${h?1:0}`)}},o={pour:l=>{l&&!i.held().some(({kind:h})=>h==="cup")&&s(Ji),t(`pour ${l?.3:0}`)},push:l=>t(`push 0 ${l?15:0} 0`)};for(let l of n){if(fu(l),l.dataset.hold){pu(l,o[l.dataset.hold]);continue}let h=Object.keys(a).find(f=>f in l.dataset);l.addEventListener("click",()=>{a[h](l),l.dataset.say&&l.getAttribute("aria-pressed")!=="false"&&i.say(l.dataset.say)}),l.closest(".weights")&&mu(l,i.say)}if(gu(n),!e)return;let c=l=>t(`push ${l.toArray().map(h=>h.toFixed(3)).join(" ")}`);xu((l,h)=>c(e.inArms(l,h).setLength(l||h?15:0))),vu(e,(l,h)=>{c(e.inArms(l,h).multiplyScalar(100).clampLength(0,i.get("constrained")[0]?15:40))})}function fu(i){let t=i.dataset.key,e=i.lastChild,n=e.data.toLowerCase().indexOf(t),s=document.createElement("u"),r=document.createElement("span");i.setAttribute("aria-keyshortcuts",t),s.textContent=n<0?t.toUpperCase():e.data[n],r.append(...n<0?[e.data," ",s]:[e.data.slice(0,n),s,e.data.slice(n+1)]),e.replaceWith(r)}function pu(i,t){let e=n=>{i.classList.contains("held")!==n&&(i.classList.toggle("held",n),t(n))};for(let n of["pointerdown","hold"])i.addEventListener(n,()=>e(!0));for(let n of["pointerup","pointerleave","pointercancel","blur","keyup","release"])i.addEventListener(n,()=>e(!1));i.addEventListener("keydown",({key:n})=>{(n===" "||n==="Enter")&&e(!0)})}function mu(i,t){i.addEventListener("pointerdown",e=>{let n=document.createElement("div");n.className="dragged",n.append(i.querySelector("i").cloneNode());let s=({clientX:o,clientY:c})=>{!n.isConnected&&Math.hypot(o-e.clientX,c-e.clientY)<6||(document.body.append(n),n.style.left=`${o}px`,n.style.top=`${c}px`)},r=({type:o,clientX:c,clientY:l})=>{for(let[h,f]of a)removeEventListener(h,f);n.isConnected&&(n.remove(),o!=="pointercancel"&&(document.elementFromPoint(c,l)?.closest("#stage")?i.click():t("Let it go over one of the hands.")))},a=[["pointermove",s],["pointerup",r],["pointercancel",r]];for(let[o,c]of a)addEventListener(o,c)})}function gu(i){let t=new Map(i.map(e=>[e.dataset.key,e]));addEventListener("keydown",({altKey:e,ctrlKey:n,key:s,metaKey:r,repeat:a,target:o})=>{if(a||e||n||r||o.closest("input, select, pre"))return;let c=t.get(s.toLowerCase());c?.dataset.hold?c.dispatchEvent(new Event("hold")):c?.click()}),addEventListener("keyup",({key:e})=>t.get(e.toLowerCase())?.dispatchEvent(new Event("release")))}function xu(i){let t=document.getElementById("scene"),e=new Set,n=()=>i(...[...e].reduce(([s,r],a)=>[s+so[a][0],r+so[a][1]],[0,0]));t.addEventListener("keydown",s=>{s.key in so&&(s.preventDefault(),!s.repeat&&(e.add(s.key),n()))}),t.addEventListener("keyup",({key:s})=>e.delete(s)&&n()),t.addEventListener("blur",()=>{e.size!==0&&(e.clear(),n())})}function vu(i,t){let e=document.getElementById("scene");e.addEventListener("pointerdown",n=>{let{left:s,top:r}=e.getBoundingClientRect(),a=["without","with"].some(l=>{let{x:h,y:f}=i.handAt(l);return Math.hypot(n.clientX-s-h,n.clientY-r-f)<90}),o=n,c=l=>{a?t(l.clientX-n.clientX,l.clientY-n.clientY):i.turn(l.clientX-o.clientX,l.clientY-o.clientY),o=l};e.setPointerCapture(n.pointerId),e.addEventListener("pointermove",c),e.addEventListener("lostpointercapture",()=>{e.removeEventListener("pointermove",c),a&&t(0,0)},{once:!0})})}var Hs=class{constructor(){this.clear()}clear(){this.rows=[]}add(t){this.rows.push({t:t("ticks")[0]/1e3,mean:t("with.mean")[0],deviation:t("with.deviation")[0],truth:t("with.payload")[0]}),this.rows.length>12/.02&&this.rows.shift()}},yu=(()=>{let i=document.createElement("canvas");i.width=i.height=6;let t=i.getContext("2d");t.strokeStyle="#1565c0";for(let e of[-6,0,6])t.moveTo(e,6),t.lineTo(e+6,0);return t.stroke(),t.createPattern(i,"repeat")})();function ao(i,t,e,n){let s=devicePixelRatio,r=i.clientWidth,a=i.clientHeight;i.width!==Math.round(r*s)&&(i.width=Math.round(r*s),i.height=Math.round(a*s));let o=i.getContext("2d");o.setTransform(s,0,0,s,0,0),o.clearRect(0,0,r,a);let c=t.reduce((u,M)=>Math.max(u,M.mean+M.deviation,M.truth??0),.5),l=c>10?5:c>4?2:c>2?1:.5,h=l*Math.ceil(1.05*c/l),f=u=>30+(r-34)*(u-e)/(n-e),d=u=>a-16-(a-22)*Math.max(u,0)/h;o.font="11px system-ui, sans-serif",o.fillStyle="#5b6472",o.strokeStyle="#dde2e8";for(let u=0;u<=h+1e-9;u+=l)o.strokeRect(30,d(u),r-34,0),o.fillText(u.toFixed(l<1?1:0),4,d(u)+4);let m=Math.max(1,Math.round((n-e)/6));for(let u=m*Math.ceil(e/m);u<=n;u+=m)o.fillText(`${u} s`,Math.min(f(u)-8,r-26),a-3);let g=(u,M)=>{o.setLineDash(M),o.beginPath();for(let[A,w]of u)o.lineTo(f(A),d(w))},S=t.map(u=>[u.t,u.mean+2*u.deviation]),p=t.map(u=>[u.t,u.mean-2*u.deviation]);o.save(),o.beginPath(),o.rect(30,0,r-34,a-16),o.clip(),g([...S,...p.reverse()],[]),o.fillStyle=yu,o.fill(),o.strokeStyle="#1f2937",g(t.filter(u=>u.truth!==void 0).map(u=>[u.t,u.truth]),[5,4]),o.stroke(),o.lineWidth=2,o.strokeStyle="#1565c0",g(t.map(u=>[u.t,u.mean]),[]),o.stroke(),o.restore(),o.setLineDash([])}function Yl(i,{rows:t}){let e=Math.max(12,t[t.length-1].t);ao(i,t,e-12,e)}var oe=i=>document.getElementById(i),kn=[],Zl,Su=0;function Mu(){return Zl??=new Promise((i,t)=>{let e=document.createElement("script");e.src="logs.js",e.onload=()=>i(new Worker(URL.createObjectURL(new Blob([globalThis.rmeLogWorker],{type:"text/javascript"})))),e.onerror=()=>t(new Error("logs.js is missing beside the page")),document.head.append(e)}),Zl}async function Jl(i,t){let e=await Mu(),n=++Su;return new Promise(s=>{let r=({data:a})=>{a.id===n&&(e.removeEventListener("message",r),s(a))};e.addEventListener("message",r),e.postMessage({id:n,files:kn,program:i,options:t})})}async function bu(i){let t=i.name.endsWith(".gz"),e=t?i.stream().pipeThrough(new DecompressionStream("gzip")):i.stream();return{name:t?i.name.slice(0,-3):i.name,bytes:new Uint8Array(await new Response(e).arrayBuffer())}}var si=({name:i})=>/\.(urdf|xml)$/i.test(i),Ws=()=>kn.filter(i=>!si(i)).map(({name:i})=>i);function wu(i){let t=new DOMParser().parseFromString(new TextDecoder().decode(i.bytes),"text/xml"),e=[...t.querySelectorAll("robot > link")].map(h=>h.getAttribute("name")),n=h=>new Set([...t.querySelectorAll(`robot > joint > ${h}`)].map(f=>f.getAttribute("link"))),s=n("parent"),r=n("child"),a=[...t.querySelectorAll("robot > joint")].find(h=>/revolute|continuous/.test(h.getAttribute("type"))),o=e.filter(h=>!s.has(h)),c=a?.querySelector("parent")?.getAttribute("link")??e.find(h=>!r.has(h)),l=o.find(h=>/^(tool0|.*flange|.*link8|.*ee|.*tip)$/i.test(h))??o.at(-1);for(let[h,f]of[["base",c],["tip",l]])oe(h).replaceChildren(...e.map(d=>new Option(d,d,!1,d===f)))}async function ql(i){for(let e of i){let n=await bu(e);kn=kn.filter(s=>s.name!==n.name&&!(si(s)&&si(n))),kn.push(n)}let t=kn.find(si);oe("chosen").textContent=kn.map(({name:e})=>e).join(", "),oe("arm").hidden=!t,t&&[...i].some(si)&&wu(t),oe("replay").disabled=oe("check").disabled=Ws().length===0,Ws().length>0&&[...i].some(e=>!si(e))&&await Ql()}function Kl(){let i=kn.find(si),t=oe("options").value.trim();return[...i?["--urdf",i.name,"--base",oe("base").value,"--tip",oe("tip").value]:[],...t?t.split(/\s+/):[]]}function oo(i,t){oe("verdict").textContent=i,oe("output").hidden=!1,oe("output").textContent=t.join(`
`)}async function jl(i,t){oe("verdict").textContent=i;for(let e of["replay","check"])oe(e).disabled=!0;await t();for(let e of["replay","check"])oe(e).disabled=!1}var Ql=()=>jl("replaying ...",async()=>{let i=Ws().at(-1),{code:t,output:e}=await Jl("replay_log",[i,"--json",...Kl()]);if(t!==0){oe("replayed").hidden=!0,oo(`${i} could not be replayed`,e);return}let n=e.filter(o=>o.startsWith("{")).map(o=>JSON.parse(o)),s=n.filter(({type:o})=>o==="estimate"),r=n.filter(({type:o,final:c})=>c||o==="rejected"),a=n.find(({type:o})=>o==="summary");oe("replayed").hidden=!1,oe("replayed").rows=s.map(({t:o,mass:c,std:l,truth:h})=>({t:o,mean:c,deviation:l[0],truth:h?.[0]})),$l(),oo(`${i}: ${a.samples} samples, ${a.estimates} changes of the payload, ${a.rejected} pushes`,[...n.filter(({type:o})=>o==="note").map(({text:o})=>o),...r.map(({t:o,kind:c,mass:l,std:h})=>`${o.toFixed(3)} s  ${c}`+(l===void 0?"":`  ${l.toFixed(3)} +- ${h[0].toFixed(3)} kg`))])});function $l(){let{rows:i}=oe("replayed");i?.length>1&&ao(oe("replayed"),i,i[0].t,i.at(-1).t)}var Tu=()=>jl("checking ...",async()=>{let{code:i,output:t}=await Jl("check_arm",[...Ws(),...Kl()]);oo(["The arm fits: sign, units and frames of its torque can be right.","Sign, units or frames of the torque do not fit the arm.","check_arm does not take these options.","check_arm cannot use these files."][i],t)});function tc(){oe("files").addEventListener("change",({target:t})=>ql(t.files)),oe("replay").addEventListener("click",Ql),oe("check").addEventListener("click",Tu),addEventListener("resize",$l);let i=t=>e=>{e.dataTransfer?.types.includes("Files")&&(e.preventDefault(),oe("own").classList.toggle("over",t),e.type==="drop"&&ql(e.dataTransfer.files))};for(let[t,e]of[["dragover",!0],["dragleave",!1],["drop",!1]])addEventListener(t,i(e))}var Rc=0,zo=1,_c=2;var As=1,Pc=2,Vi=3,Qn=0,De=1,xn=2,ui=0,Gi=1,ko=2,Vo=3,Go=4,Ic=5;var di=100,Lc=101,Nc=102,Dc=103,Uc=104,Fc=200,Oc=201,Bc=202,zc=203,Ho=204,Wo=205,kc=206,Vc=207,Gc=208,Hc=209,Wc=210,Xc=211,Yc=212,Zc=213,qc=214,yr=0,Sr=1,Mr=2,Ii=3,br=4,wr=5,Tr=6,Er=7,Qr=0,Jc=1,Kc=2,vn=0,Xo=1,Yo=2,Zo=3,qo=4,Jo=5,Ko=6,jo=7;var Qo=300,fi=301,Hi=302,$r=303,ta=304,Ar=1e3,fn=1001,Cr=1002,Me=1003,jc=1004;var Cs=1005;var Ne=1006,ea=1007;var Dn=1008;var Be=1009,$o=1010,tl=1011,Wi=1012,na=1013,an=1014,on=1015,ln=1016,ia=1017,sa=1018,pi=1020,el=35902,nl=35899,il=1021,sl=1022,cn=1023,_n=1026,Un=1027,rl=1028,ra=1029,$n=1030,aa=1031;var oa=1033,Rs=33776,_s=33777,Ps=33778,Is=33779,la=35840,ca=35841,ha=35842,ua=35843,da=36196,fa=37492,pa=37496,ma=37488,ga=37489,Ls=37490,xa=37491,va=37808,ya=37809,Sa=37810,Ma=37811,ba=37812,wa=37813,Ta=37814,Ea=37815,Aa=37816,Ca=37817,Ra=37818,_a=37819,Pa=37820,Ia=37821,La=36492,Na=36494,Da=36495,Ua=36283,Fa=36284,Ns=36285,Oa=36286;var ns=2300,Rr=2301,gr=2302,Lo=2303,No=2400,Do=2401,Uo=2402;var Qc=3200;var Ba=0,$c=1,Fn="",Ve="srgb",is="srgb-linear",ss="linear",Zt="srgb";var xr=7680;var th=519,eh=512,nh=513,ih=514,al=515,sh=516,rh=517,ol=518,ll=519,ah=35044;var cl="300 es",je=2e3,Li=2001;function Eu(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Au(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function rs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function oh(){let i=rs("canvas");return i.style.display="block",i}var ec={},Ni=null;function hl(...i){let t="THREE."+i.shift();Ni?Ni("log",t,...i):console.log(t,...i)}function lh(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ct(...i){i=lh(i);let t="THREE."+i.shift();if(Ni)Ni("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function _t(...i){i=lh(i);let t="THREE."+i.shift();if(Ni)Ni("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function es(...i){let t=i.join(" ");t in ec||(ec[t]=!0,Ct(...i))}function ch(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var hh={[yr]:yr,[Mr]:Tr,[br]:br,[Ii]:wr,[Sr]:Sr,[Tr]:Mr,[Er]:Er,[wr]:Ii},mn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},Ce=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var vr=Math.PI/180,_r=180/Math.PI;function Ds(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ce[i&255]+Ce[i>>8&255]+Ce[i>>16&255]+Ce[i>>24&255]+"-"+Ce[t&255]+Ce[t>>8&255]+"-"+Ce[t>>16&15|64]+Ce[t>>24&255]+"-"+Ce[e&63|128]+Ce[e>>8&255]+"-"+Ce[e>>16&255]+Ce[e>>24&255]+Ce[n&255]+Ce[n>>8&255]+Ce[n>>16&255]+Ce[n>>24&255]).toLowerCase()}function Wt(i,t,e){return Math.max(t,Math.min(e,i))}function Cu(i,t){return(i%t+t)%t}function lo(i,t,e){return(1-e)*i+e*t}function uh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ul(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ru(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function _u(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Ht=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qe=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let c=n[s+0],l=n[s+1],h=n[s+2],f=n[s+3],d=r[a+0],m=r[a+1],g=r[a+2],S=r[a+3];if(f!==S||c!==d||l!==m||h!==g){let p=c*d+l*m+h*g+f*S;p<0&&(d=-d,m=-m,g=-g,S=-S,p=-p);let u=1-o;if(p<.9995){let M=Math.acos(p),A=Math.sin(M);u=Math.sin(u*M)/A,o=Math.sin(o*M)/A,c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+S*o}else{c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+S*o;let M=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=M,l*=M,h*=M,f*=M}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,s,r,a){let o=n[s],c=n[s+1],l=n[s+2],h=n[s+3],f=r[a],d=r[a+1],m=r[a+2],g=r[a+3];return t[e]=o*g+h*f+c*m-l*d,t[e+1]=c*g+h*d+l*f-o*m,t[e+2]=l*g+h*m+o*d-c*f,t[e+3]=h*g-o*f-c*d-l*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,c=Math.sin,l=o(n/2),h=o(s/2),f=o(r/2),d=c(n/2),m=c(s/2),g=c(r/2);switch(a){case"XYZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"YXZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"ZXY":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"ZYX":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"YZX":this._x=d*h*f+l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f-d*m*g;break;case"XZY":this._x=d*h*f-l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f+d*m*g;break;default:Ct("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],c=e[9],l=e[2],h=e[6],f=e[10],d=n+o+f;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-c)*m,this._y=(r-l)*m,this._z=(a-s)*m}else if(n>o&&n>f){let m=2*Math.sqrt(1+n-o-f);this._w=(h-c)/m,this._x=.25*m,this._y=(s+a)/m,this._z=(r+l)/m}else if(o>f){let m=2*Math.sqrt(1+o-n-f);this._w=(r-l)/m,this._x=(s+a)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+f-n-o);this._w=(a-s)/m,this._x=(r+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+a*o+s*l-r*c,this._y=s*h+a*c+r*o-n*l,this._z=r*h+a*l+n*c-s*o,this._w=a*h-n*o-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let c=1-e;if(o<.9995){let l=Math.acos(o),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(nc.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(nc.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,c=t.w,l=2*(a*s-o*n),h=2*(o*e-r*s),f=2*(r*n-a*e);return this.x=e+c*l+a*f-o*h,this.y=n+c*h+o*l-r*f,this.z=s+c*f+r*h-a*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,c=e.z;return this.x=s*c-r*o,this.y=r*a-n*c,this.z=n*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return co.copy(this).projectOnVector(t),this.sub(co)}reflect(t){return this.sub(co.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},co=new U,nc=new Qe,Pt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l)}set(t,e,n,s,r,a,o,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=a,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],c=n[6],l=n[1],h=n[4],f=n[7],d=n[2],m=n[5],g=n[8],S=s[0],p=s[3],u=s[6],M=s[1],A=s[4],w=s[7],C=s[2],E=s[5],x=s[8];return r[0]=a*S+o*M+c*C,r[3]=a*p+o*A+c*E,r[6]=a*u+o*w+c*x,r[1]=l*S+h*M+f*C,r[4]=l*p+h*A+f*E,r[7]=l*u+h*w+f*x,r[2]=d*S+m*M+g*C,r[5]=d*p+m*A+g*E,r[8]=d*u+m*w+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8];return e*a*h-e*o*l-n*r*h+n*o*c+s*r*l-s*a*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=h*a-o*l,d=o*c-h*r,m=l*r-a*c,g=e*f+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/g;return t[0]=f*S,t[1]=(s*l-h*n)*S,t[2]=(o*n-s*a)*S,t[3]=d*S,t[4]=(h*e-s*c)*S,t[5]=(s*r-o*e)*S,t[6]=m*S,t[7]=(n*c-l*e)*S,t[8]=(a*e-n*r)*S,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*a+l*o)+a+t,-s*l,s*c,-s*(-l*a+c*o)+o+e,0,0,1),this}scale(t,e){return es("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ho.makeScale(t,e)),this}rotate(t){return es("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ho.makeRotation(-t)),this}translate(t,e){return es("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ho.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ho=new Pt,ic=new Pt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sc=new Pt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Pu(){let i={enabled:!0,workingColorSpace:is,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Zt&&(s.r=Rn(s.r),s.g=Rn(s.g),s.b=Rn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Zt&&(s.r=Pi(s.r),s.g=Pi(s.g),s.b=Pi(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fn?ss:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[is]:{primaries:t,whitePoint:n,transfer:ss,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ve},outputColorSpaceConfig:{drawingBufferColorSpace:Ve}},[Ve]:{primaries:t,whitePoint:n,transfer:Zt,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ve}}}),i}var Gt=Pu();function Rn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Pi(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xi,Pr=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{xi===void 0&&(xi=rs("canvas")),xi.width=t.width,xi.height=t.height;let s=xi.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=xi}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=rs("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Rn(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Rn(e[n]/255)*255):e[n]=Rn(e[n]);return{data:e,width:t.width,height:t.height}}else return Ct("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Iu=0,Di=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Iu++}),this.uuid=Ds(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(uo(s[a].image)):r.push(uo(s[a]))}else r=uo(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function uo(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Pr.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ct("Texture: Unable to serialize Texture."),{})}var Lu=0,fo=new U,Oe=class i extends mn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=fn,s=fn,r=Ne,a=Dn,o=cn,c=Be,l=i.DEFAULT_ANISOTROPY,h=Fn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Lu++}),this.uuid=Ds(),this.name="",this.source=new Di(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new Ht(0,0),this.repeat=new Ht(1,1),this.center=new Ht(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Pt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fo).x}get height(){return this.source.getSize(fo).y}get depth(){return this.source.getSize(fo).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Ct(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ct(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Qo)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ar:t.x=t.x-Math.floor(t.x);break;case fn:t.x=t.x<0?0:1;break;case Cr:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ar:t.y=t.y-Math.floor(t.y);break;case fn:t.y=t.y<0?0:1;break;case Cr:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Oe.DEFAULT_IMAGE=null;Oe.DEFAULT_MAPPING=Qo;Oe.DEFAULT_ANISOTROPY=1;var se=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],f=c[8],d=c[1],m=c[5],g=c[9],S=c[2],p=c[6],u=c[10];if(Math.abs(h-d)<.01&&Math.abs(f-S)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+S)<.1&&Math.abs(g+p)<.1&&Math.abs(l+m+u-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(l+1)/2,w=(m+1)/2,C=(u+1)/2,E=(h+d)/4,x=(f+S)/4,b=(g+p)/4;return A>w&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):w>C?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=E/s,r=b/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=b/r),this.set(n,s,r,e),this}let M=Math.sqrt((p-g)*(p-g)+(f-S)*(f-S)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(p-g)/M,this.y=(f-S)/M,this.z=(d-h)/M,this.w=Math.acos((l+m+u-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ir=class extends mn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ne,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new se(0,0,t,e),this.scissorTest=!1,this.viewport=new se(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Oe({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ne,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Di(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},He=class extends Ir{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},as=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Me,this.minFilter=Me,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Lr=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Me,this.minFilter=Me,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p)}set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p){let u=this.elements;return u[0]=t,u[4]=e,u[8]=n,u[12]=s,u[1]=r,u[5]=a,u[9]=o,u[13]=c,u[2]=l,u[6]=h,u[10]=f,u[14]=d,u[3]=m,u[7]=g,u[11]=S,u[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/vi.setFromMatrixColumn(t,0).length(),r=1/vi.setFromMatrixColumn(t,1).length(),a=1/vi.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let d=a*h,m=a*f,g=o*h,S=o*f;e[0]=c*h,e[4]=-c*f,e[8]=l,e[1]=m+g*l,e[5]=d-S*l,e[9]=-o*c,e[2]=S-d*l,e[6]=g+m*l,e[10]=a*c}else if(t.order==="YXZ"){let d=c*h,m=c*f,g=l*h,S=l*f;e[0]=d+S*o,e[4]=g*o-m,e[8]=a*l,e[1]=a*f,e[5]=a*h,e[9]=-o,e[2]=m*o-g,e[6]=S+d*o,e[10]=a*c}else if(t.order==="ZXY"){let d=c*h,m=c*f,g=l*h,S=l*f;e[0]=d-S*o,e[4]=-a*f,e[8]=g+m*o,e[1]=m+g*o,e[5]=a*h,e[9]=S-d*o,e[2]=-a*l,e[6]=o,e[10]=a*c}else if(t.order==="ZYX"){let d=a*h,m=a*f,g=o*h,S=o*f;e[0]=c*h,e[4]=g*l-m,e[8]=d*l+S,e[1]=c*f,e[5]=S*l+d,e[9]=m*l-g,e[2]=-l,e[6]=o*c,e[10]=a*c}else if(t.order==="YZX"){let d=a*c,m=a*l,g=o*c,S=o*l;e[0]=c*h,e[4]=S-d*f,e[8]=g*f+m,e[1]=f,e[5]=a*h,e[9]=-o*h,e[2]=-l*h,e[6]=m*f+g,e[10]=d-S*f}else if(t.order==="XZY"){let d=a*c,m=a*l,g=o*c,S=o*l;e[0]=c*h,e[4]=-f,e[8]=l*h,e[1]=d*f+S,e[5]=a*h,e[9]=m*f-g,e[2]=g*f-m,e[6]=o*h,e[10]=S*f+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Nu,t,Du)}lookAt(t,e,n){let s=this.elements;return ze.subVectors(t,e),ze.lengthSq()===0&&(ze.z=1),ze.normalize(),Vn.crossVectors(n,ze),Vn.lengthSq()===0&&(Math.abs(n.z)===1?ze.x+=1e-4:ze.z+=1e-4,ze.normalize(),Vn.crossVectors(n,ze)),Vn.normalize(),Xs.crossVectors(ze,Vn),s[0]=Vn.x,s[4]=Xs.x,s[8]=ze.x,s[1]=Vn.y,s[5]=Xs.y,s[9]=ze.y,s[2]=Vn.z,s[6]=Xs.z,s[10]=ze.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],c=n[8],l=n[12],h=n[1],f=n[5],d=n[9],m=n[13],g=n[2],S=n[6],p=n[10],u=n[14],M=n[3],A=n[7],w=n[11],C=n[15],E=s[0],x=s[4],b=s[8],D=s[12],I=s[1],N=s[5],B=s[9],H=s[13],_=s[2],G=s[6],Y=s[10],V=s[14],et=s[3],X=s[7],Q=s[11],$=s[15];return r[0]=a*E+o*I+c*_+l*et,r[4]=a*x+o*N+c*G+l*X,r[8]=a*b+o*B+c*Y+l*Q,r[12]=a*D+o*H+c*V+l*$,r[1]=h*E+f*I+d*_+m*et,r[5]=h*x+f*N+d*G+m*X,r[9]=h*b+f*B+d*Y+m*Q,r[13]=h*D+f*H+d*V+m*$,r[2]=g*E+S*I+p*_+u*et,r[6]=g*x+S*N+p*G+u*X,r[10]=g*b+S*B+p*Y+u*Q,r[14]=g*D+S*H+p*V+u*$,r[3]=M*E+A*I+w*_+C*et,r[7]=M*x+A*N+w*G+C*X,r[11]=M*b+A*B+w*Y+C*Q,r[15]=M*D+A*H+w*V+C*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],c=t[9],l=t[13],h=t[2],f=t[6],d=t[10],m=t[14],g=t[3],S=t[7],p=t[11],u=t[15],M=c*m-l*d,A=o*m-l*f,w=o*d-c*f,C=a*m-l*h,E=a*d-c*h,x=a*f-o*h;return e*(S*M-p*A+u*w)-n*(g*M-p*C+u*E)+s*(g*A-S*C+u*x)-r*(g*w-S*E+p*x)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],c=t[2],l=t[6],h=t[10];return e*(a*h-o*l)-n*(r*h-o*c)+s*(r*l-a*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=t[9],d=t[10],m=t[11],g=t[12],S=t[13],p=t[14],u=t[15],M=e*o-n*a,A=e*c-s*a,w=e*l-r*a,C=n*c-s*o,E=n*l-r*o,x=s*l-r*c,b=h*S-f*g,D=h*p-d*g,I=h*u-m*g,N=f*p-d*S,B=f*u-m*S,H=d*u-m*p,_=M*H-A*B+w*N+C*I-E*D+x*b;if(_===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/_;return t[0]=(o*H-c*B+l*N)*G,t[1]=(s*B-n*H-r*N)*G,t[2]=(S*x-p*E+u*C)*G,t[3]=(d*E-f*x-m*C)*G,t[4]=(c*I-a*H-l*D)*G,t[5]=(e*H-s*I+r*D)*G,t[6]=(p*w-g*x-u*A)*G,t[7]=(h*x-d*w+m*A)*G,t[8]=(a*B-o*I+l*b)*G,t[9]=(n*I-e*B-r*b)*G,t[10]=(g*E-S*w+u*M)*G,t[11]=(f*w-h*E-m*M)*G,t[12]=(o*D-a*N-c*b)*G,t[13]=(e*N-n*D+s*b)*G,t[14]=(S*A-g*C-p*M)*G,t[15]=(h*C-f*A+d*M)*G,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,c=t.z,l=r*a,h=r*o;return this.set(l*a+n,l*o-s*c,l*c+s*o,0,l*o+s*c,h*o+n,h*c-s*a,0,l*c-s*o,h*c+s*a,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,a=e._y,o=e._z,c=e._w,l=r+r,h=a+a,f=o+o,d=r*l,m=r*h,g=r*f,S=a*h,p=a*f,u=o*f,M=c*l,A=c*h,w=c*f,C=n.x,E=n.y,x=n.z;return s[0]=(1-(S+u))*C,s[1]=(m+w)*C,s[2]=(g-A)*C,s[3]=0,s[4]=(m-w)*E,s[5]=(1-(d+u))*E,s[6]=(p+M)*E,s[7]=0,s[8]=(g+A)*x,s[9]=(p-M)*x,s[10]=(1-(d+S))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=vi.set(s[0],s[1],s[2]).length(),o=vi.set(s[4],s[5],s[6]).length(),c=vi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),en.copy(this);let l=1/a,h=1/o,f=1/c;return en.elements[0]*=l,en.elements[1]*=l,en.elements[2]*=l,en.elements[4]*=h,en.elements[5]*=h,en.elements[6]*=h,en.elements[8]*=f,en.elements[9]*=f,en.elements[10]*=f,e.setFromRotationMatrix(en),n.x=a,n.y=o,n.z=c,this}makePerspective(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2*r/(e-t),f=2*r/(n-s),d=(e+t)/(e-t),m=(n+s)/(n-s),g,S;if(c)g=r/(a-r),S=a*r/(a-r);else if(o===je)g=-(a+r)/(a-r),S=-2*a*r/(a-r);else if(o===Li)g=-a/(a-r),S=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=S,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2/(e-t),f=2/(n-s),d=-(e+t)/(e-t),m=-(n+s)/(n-s),g,S;if(c)g=1/(a-r),S=a/(a-r);else if(o===je)g=-2/(a-r),S=-(a+r)/(a-r);else if(o===Li)g=-1/(a-r),S=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=g,l[14]=S,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},vi=new U,en=new Qt,Nu=new U(0,0,0),Du=new U(1,1,1),Vn=new U,Xs=new U,ze=new U,rc=new Qt,ac=new Qe,Pn=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],c=s[1],l=s[5],h=s[9],f=s[2],d=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-a,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Wt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-a,l));break;case"YZX":this._z=Math.asin(Wt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,m));break;case"XZY":this._z=Math.asin(-Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Ct("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rc.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rc,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ac.setFromEuler(this),this.setFromQuaternion(ac,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pn.DEFAULT_ORDER="XYZ";var os=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Uu=0,oc=new U,yi=new Qe,bn=new Qt,Ys=new U,Ki=new U,Fu=new U,Ou=new Qe,lc=new U(1,0,0),cc=new U(0,1,0),hc=new U(0,0,1),uc={type:"added"},Bu={type:"removed"},Si={type:"childadded",child:null},po={type:"childremoved",child:null},Te=class i extends mn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Uu++}),this.uuid=Ds(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new U,e=new Pn,n=new Qe,s=new U(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new Pt}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new os,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.multiply(yi),this}rotateOnWorldAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.premultiply(yi),this}rotateX(t){return this.rotateOnAxis(lc,t)}rotateY(t){return this.rotateOnAxis(cc,t)}rotateZ(t){return this.rotateOnAxis(hc,t)}translateOnAxis(t,e){return oc.copy(t).applyQuaternion(this.quaternion),this.position.add(oc.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lc,t)}translateY(t){return this.translateOnAxis(cc,t)}translateZ(t){return this.translateOnAxis(hc,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(bn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Ys.copy(t):Ys.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ki.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bn.lookAt(Ki,Ys,this.up):bn.lookAt(Ys,Ki,this.up),this.quaternion.setFromRotationMatrix(bn),s&&(bn.extractRotation(s.matrixWorld),yi.setFromRotationMatrix(bn),this.quaternion.premultiply(yi.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(_t("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(uc),Si.child=t,this.dispatchEvent(Si),Si.child=null):_t("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Bu),po.child=t,this.dispatchEvent(po),po.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),bn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),bn.multiply(t.parent.matrixWorld)),t.applyMatrix4(bn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(uc),Si.child=t,this.dispatchEvent(Si),Si.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,t,Fu),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,Ou,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let c=o.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];r(t.shapes,f)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(r(t.materials,this.material[c]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let c=this.animations[o];s.animations.push(r(t.animations,c))}}if(e){let o=a(t.geometries),c=a(t.materials),l=a(t.textures),h=a(t.images),f=a(t.shapes),d=a(t.skeletons),m=a(t.animations),g=a(t.nodes);o.length>0&&(n.geometries=o),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let c=[];for(let l in o){let h=o[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Te.DEFAULT_UP=new U(0,1,0);Te.DEFAULT_MATRIX_AUTO_UPDATE=!0;Te.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ge=class extends Te{constructor(){super(),this.isGroup=!0,this.type="Group"}},zu={type:"move"},Ui=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ge,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ge,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ge,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null,o=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){a=!0;for(let S of t.hand.values()){let p=e.getJointPose(S,n),u=this._getHandJoint(l,S);p!==null&&(u.matrix.fromArray(p.transform.matrix),u.matrix.decompose(u.position,u.quaternion,u.scale),u.matrixWorldNeedsUpdate=!0,u.jointRadius=p.radius),u.visible=p!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],d=h.position.distanceTo(f.position),m=.02,g=.005;l.inputState.pinching&&d>m+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=m-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(zu)))}return o!==null&&(o.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ge;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},dh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Gn={h:0,s:0,l:0},Zs={h:0,s:0,l:0};function mo(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Ut=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ve){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Gt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Gt.workingColorSpace){return this.r=t,this.g=e,this.b=n,Gt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Gt.workingColorSpace){if(t=Cu(t,1),e=Wt(e,0,1),n=Wt(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=mo(a,r,t+1/3),this.g=mo(a,r,t),this.b=mo(a,r,t-1/3)}return Gt.colorSpaceToWorking(this,s),this}setStyle(t,e=Ve){function n(r){r!==void 0&&parseFloat(r)<1&&Ct("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Ct("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Ct("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ve){let n=dh[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Ct("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Rn(t.r),this.g=Rn(t.g),this.b=Rn(t.b),this}copyLinearToSRGB(t){return this.r=Pi(t.r),this.g=Pi(t.g),this.b=Pi(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ve){return Gt.workingToColorSpace(Re.copy(this),t),Math.round(Wt(Re.r*255,0,255))*65536+Math.round(Wt(Re.g*255,0,255))*256+Math.round(Wt(Re.b*255,0,255))}getHexString(t=Ve){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Gt.workingColorSpace){Gt.workingToColorSpace(Re.copy(this),e);let n=Re.r,s=Re.g,r=Re.b,a=Math.max(n,s,r),o=Math.min(n,s,r),c,l,h=(o+a)/2;if(o===a)c=0,l=0;else{let f=a-o;switch(l=h<=.5?f/(a+o):f/(2-a-o),a){case n:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-n)/f+2;break;case r:c=(n-s)/f+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=Gt.workingColorSpace){return Gt.workingToColorSpace(Re.copy(this),e),t.r=Re.r,t.g=Re.g,t.b=Re.b,t}getStyle(t=Ve){Gt.workingToColorSpace(Re.copy(this),t);let e=Re.r,n=Re.g,s=Re.b;return t!==Ve?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Gn),this.setHSL(Gn.h+t,Gn.s+e,Gn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Gn),t.getHSL(Zs);let n=lo(Gn.h,Zs.h,e),s=lo(Gn.s,Zs.s,e),r=lo(Gn.l,Zs.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Re=new Ut;Ut.NAMES=dh;var ls=class extends Te{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pn,this.environmentIntensity=1,this.environmentRotation=new Pn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},nn=new U,wn=new U,go=new U,Tn=new U,Mi=new U,bi=new U,dc=new U,xo=new U,vo=new U,yo=new U,So=new se,Mo=new se,bo=new se,Cn=class i{constructor(t=new U,e=new U,n=new U){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),nn.subVectors(t,e),s.cross(nn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){nn.subVectors(s,e),wn.subVectors(n,e),go.subVectors(t,e);let a=nn.dot(nn),o=nn.dot(wn),c=nn.dot(go),l=wn.dot(wn),h=wn.dot(go),f=a*l-o*o;if(f===0)return r.set(0,0,0),null;let d=1/f,m=(l*c-o*h)*d,g=(a*h-o*c)*d;return r.set(1-m-g,g,m)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Tn)===null?!1:Tn.x>=0&&Tn.y>=0&&Tn.x+Tn.y<=1}static getInterpolation(t,e,n,s,r,a,o,c){return this.getBarycoord(t,e,n,s,Tn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Tn.x),c.addScaledVector(a,Tn.y),c.addScaledVector(o,Tn.z),c)}static getInterpolatedAttribute(t,e,n,s,r,a){return So.setScalar(0),Mo.setScalar(0),bo.setScalar(0),So.fromBufferAttribute(t,e),Mo.fromBufferAttribute(t,n),bo.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(So,r.x),a.addScaledVector(Mo,r.y),a.addScaledVector(bo,r.z),a}static isFrontFacing(t,e,n,s){return nn.subVectors(n,e),wn.subVectors(t,e),nn.cross(wn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return nn.subVectors(this.c,this.b),wn.subVectors(this.a,this.b),nn.cross(wn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,a,o;Mi.subVectors(s,n),bi.subVectors(r,n),xo.subVectors(t,n);let c=Mi.dot(xo),l=bi.dot(xo);if(c<=0&&l<=0)return e.copy(n);vo.subVectors(t,s);let h=Mi.dot(vo),f=bi.dot(vo);if(h>=0&&f<=h)return e.copy(s);let d=c*f-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return a=c/(c-h),e.copy(n).addScaledVector(Mi,a);yo.subVectors(t,r);let m=Mi.dot(yo),g=bi.dot(yo);if(g>=0&&m<=g)return e.copy(r);let S=m*l-c*g;if(S<=0&&l>=0&&g<=0)return o=l/(l-g),e.copy(n).addScaledVector(bi,o);let p=h*g-m*f;if(p<=0&&f-h>=0&&m-g>=0)return dc.subVectors(r,s),o=(f-h)/(f-h+(m-g)),e.copy(s).addScaledVector(dc,o);let u=1/(p+S+d);return a=S*u,o=d*u,e.copy(n).addScaledVector(Mi,a).addScaledVector(bi,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Yn=class{constructor(t=new U(1/0,1/0,1/0),e=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(sn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(sn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=sn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,sn):sn.fromBufferAttribute(r,a),sn.applyMatrix4(t.matrixWorld),this.expandByPoint(sn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),qs.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),qs.copy(n.boundingBox)),qs.applyMatrix4(t.matrixWorld),this.union(qs)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,sn),sn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ji),Js.subVectors(this.max,ji),wi.subVectors(t.a,ji),Ti.subVectors(t.b,ji),Ei.subVectors(t.c,ji),Hn.subVectors(Ti,wi),Wn.subVectors(Ei,Ti),ri.subVectors(wi,Ei);let e=[0,-Hn.z,Hn.y,0,-Wn.z,Wn.y,0,-ri.z,ri.y,Hn.z,0,-Hn.x,Wn.z,0,-Wn.x,ri.z,0,-ri.x,-Hn.y,Hn.x,0,-Wn.y,Wn.x,0,-ri.y,ri.x,0];return!wo(e,wi,Ti,Ei,Js)||(e=[1,0,0,0,1,0,0,0,1],!wo(e,wi,Ti,Ei,Js))?!1:(Ks.crossVectors(Hn,Wn),e=[Ks.x,Ks.y,Ks.z],wo(e,wi,Ti,Ei,Js))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,sn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(sn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(En[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),En[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),En[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),En[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),En[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),En[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),En[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),En[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(En),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},En=[new U,new U,new U,new U,new U,new U,new U,new U],sn=new U,qs=new Yn,wi=new U,Ti=new U,Ei=new U,Hn=new U,Wn=new U,ri=new U,ji=new U,Js=new U,Ks=new U,ai=new U;function wo(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){ai.fromArray(i,r);let o=s.x*Math.abs(ai.x)+s.y*Math.abs(ai.y)+s.z*Math.abs(ai.z),c=t.dot(ai),l=e.dot(ai),h=n.dot(ai);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>o)return!1}return!0}var he=new U,js=new Ht,ku=0,pn=class extends mn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ku++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=ah,this.updateRanges=[],this.gpuType=on,this.version=0,this._normalizationScale=t!==void 0?ul(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)js.fromBufferAttribute(this,e),js.applyMatrix3(t),this.setXY(e,js.x,js.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix3(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix4(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyNormalMatrix(t),this.setXYZ(e,he.x,he.y,he.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.transformDirection(t),this.setXYZ(e,he.x,he.y,he.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ru(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):_u(t,this.array)}};var cs=class extends pn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var hs=class extends pn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var te=class extends pn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Vu=new Yn,Qi=new U,To=new U,ci=class{constructor(t=new U,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Vu.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qi.subVectors(t,this.center);let e=Qi.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Qi,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(To.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qi.copy(t.center).add(To)),this.expandByPoint(Qi.copy(t.center).sub(To))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Gu=0,Ke=new Qt,Eo=new Te,Ai=new U,ke=new Yn,$i=new Yn,Se=new U,_e=class i extends mn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Gu++}),this.uuid=Ds(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Eu(t)?hs:cs)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Pt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ke.makeRotationFromQuaternion(t),this.applyMatrix4(Ke),this}rotateX(t){return Ke.makeRotationX(t),this.applyMatrix4(Ke),this}rotateY(t){return Ke.makeRotationY(t),this.applyMatrix4(Ke),this}rotateZ(t){return Ke.makeRotationZ(t),this.applyMatrix4(Ke),this}translate(t,e,n){return Ke.makeTranslation(t,e,n),this.applyMatrix4(Ke),this}scale(t,e,n){return Ke.makeScale(t,e,n),this.applyMatrix4(Ke),this}lookAt(t){return Eo.lookAt(t),Eo.updateMatrix(),this.applyMatrix4(Eo.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ai).negate(),this.translate(Ai.x,Ai.y,Ai.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new te(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Ct("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Yn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){_t("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ke.setFromBufferAttribute(r),this.morphTargetsRelative?(Se.addVectors(this.boundingBox.min,ke.min),this.boundingBox.expandByPoint(Se),Se.addVectors(this.boundingBox.max,ke.max),this.boundingBox.expandByPoint(Se)):(this.boundingBox.expandByPoint(ke.min),this.boundingBox.expandByPoint(ke.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&_t('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ci);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){_t("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(t){let n=this.boundingSphere.center;if(ke.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];$i.setFromBufferAttribute(o),this.morphTargetsRelative?(Se.addVectors(ke.min,$i.min),ke.expandByPoint(Se),Se.addVectors(ke.max,$i.max),ke.expandByPoint(Se)):(ke.expandByPoint($i.min),ke.expandByPoint($i.max))}ke.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Se.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Se));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],c=this.morphTargetsRelative;for(let l=0,h=o.count;l<h;l++)Se.fromBufferAttribute(o,l),c&&(Ai.fromBufferAttribute(t,l),Se.add(Ai)),s=Math.max(s,n.distanceToSquared(Se))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&_t('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){_t("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],c=[],l=new Uint8Array(n.count);for(let D=0;D<n.count;D++)o[D]=new U,c[D]=new U;let h=new U,f=new U,d=new U,m=new Ht,g=new Ht,S=new Ht,p=new U,u=new U;function M(D,I,N){l[D]=l[I]=l[N]=1,h.fromBufferAttribute(n,D),f.fromBufferAttribute(n,I),d.fromBufferAttribute(n,N),m.fromBufferAttribute(r,D),g.fromBufferAttribute(r,I),S.fromBufferAttribute(r,N),f.sub(h),d.sub(h),g.sub(m),S.sub(m);let B=1/(g.x*S.y-S.x*g.y);isFinite(B)&&(p.copy(f).multiplyScalar(S.y).addScaledVector(d,-g.y).multiplyScalar(B),u.copy(d).multiplyScalar(g.x).addScaledVector(f,-S.x).multiplyScalar(B),o[D].add(p),o[I].add(p),o[N].add(p),c[D].add(u),c[I].add(u),c[N].add(u))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let D=0,I=A.length;D<I;++D){let N=A[D],B=N.start,H=N.count;for(let _=B,G=B+H;_<G;_+=3)M(t.getX(_+0),t.getX(_+1),t.getX(_+2))}let w=new U,C=new U,E=new U,x=new U;function b(D){E.fromBufferAttribute(s,D),x.copy(E);let I=o[D];w.copy(I),w.sub(E.multiplyScalar(E.dot(I))).normalize(),C.crossVectors(x,I);let B=C.dot(c[D])<0?-1:1;a.setXYZW(D,w.x,w.y,w.z,B)}for(let D=0,I=n.count;D<I;++D)l[D]&&b(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new pn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new U,r=new U,a=new U,o=new U,c=new U,l=new U,h=new U,f=new U;if(t)for(let d=0,m=t.count;d<m;d+=3){let g=t.getX(d+0),S=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,S),a.fromBufferAttribute(e,p),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),o.fromBufferAttribute(n,g),c.fromBufferAttribute(n,S),l.fromBufferAttribute(n,p),o.add(h),c.add(h),l.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(S,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,m=e.count;d<m;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Se.fromBufferAttribute(t,e),Se.normalize(),t.setXYZ(e,Se.x,Se.y,Se.z)}toNonIndexed(){function t(o,c){let l=o.array,h=o.itemSize,f=o.normalized,d=new l.constructor(c.length*h),m=0,g=0;for(let S=0,p=c.length;S<p;S++){o.isInterleavedBufferAttribute?m=c[S]*o.data.stride+o.offset:m=c[S]*h;for(let u=0;u<h;u++)d[g++]=l[m++]}return new pn(d,h,f)}if(this.index===null)return Ct("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let o in s){let c=s[o],l=t(c,n);e.setAttribute(o,l)}let r=this.morphAttributes;for(let o in r){let c=[],l=r[o];for(let h=0,f=l.length;h<f;h++){let d=l[h],m=t(d,n);c.push(m)}e.morphAttributes[o]=c}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,c=a.length;o<c;o++){let l=a[o];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,d=l.length;f<d;f++){let m=l[f];h.push(m.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],f=r[l];for(let d=0,m=f.length;d<m;d++)h.push(f[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let l=0,h=a.length;l<h;l++){let f=a[l];this.addGroup(f.start,f.count,f.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ao=new U,Hu=new U,Wu=new Pt,rn=class{constructor(t=new U(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Ao.subVectors(n,e).cross(Hu.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Ao),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Wu.getNormalMatrix(t),s=this.coplanarPoint(Ao).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Xu=0,In=class extends mn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Xu++}),this.uuid=Ds(),this.name="",this.type="Material",this.blending=Gi,this.side=Qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ho,this.blendDst=Wo,this.blendEquation=di,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ut(0,0,0),this.blendAlpha=0,this.depthFunc=Ii,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=th,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xr,this.stencilZFail=xr,this.stencilZPass=xr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Ct(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ct(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let c=r[o];delete c.metadata,a.push(c)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ut().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new rn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ht().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ht().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var An=new U,Co=new U,Qs=new U,$s=new U,us=class{constructor(t=new U,e=new U(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,An)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=An.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(An.copy(this.origin).addScaledVector(this.direction,e),An.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Co.copy(t).add(e).multiplyScalar(.5),Qs.copy(e).sub(t).normalize(),$s.copy(this.origin).sub(Co);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Qs),o=$s.dot(this.direction),c=-$s.dot(Qs),l=$s.lengthSq(),h=Math.abs(1-a*a),f,d,m,g;if(h>0)if(f=a*c-o,d=a*o-c,g=r*h,f>=0)if(d>=-g)if(d<=g){let S=1/h;f*=S,d*=S,m=f*(f+a*d+2*o)+d*(a*f+d+2*c)+l}else d=r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d=-r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d<=-g?(f=Math.max(0,-(-a*r+o)),d=f>0?-r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l):d<=g?(f=0,d=Math.min(Math.max(-r,-c),r),m=d*(d+2*c)+l):(f=Math.max(0,-(a*r+o)),d=f>0?r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l);else d=a>0?-r:r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Co).addScaledVector(Qs,d),m}intersectSphere(t,e){if(t.radius<0)return null;An.subVectors(t.center,this.origin);let n=An.dot(this.direction),s=An.dot(An)-n*n,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,c=n+a;return c<0?null:o<0?this.at(c,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(t.min.z-d.z)*f,c=(t.max.z-d.z)*f):(o=(t.max.z-d.z)*f,c=(t.min.z-d.z)*f),n>c||o>s)||((o>n||n!==n)&&(n=o),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,An)!==null}intersectTriangle(t,e,n,s,r){let a=this.origin,o=this.direction,c=o.x,l=o.y,h=o.z,f=t.x-a.x,d=t.y-a.y,m=t.z-a.z,g=e.x-a.x,S=e.y-a.y,p=e.z-a.z,u=n.x-a.x,M=n.y-a.y,A=n.z-a.z,w=Math.abs(c),C=Math.abs(l),E=Math.abs(h),x,b,D,I,N,B,H,_,G,Y,V,et;if(w>=C&&w>=E?(D=c,B=f,G=g,et=u,c>=0?(x=l,b=h,I=d,N=m,H=S,_=p,Y=M,V=A):(x=h,b=l,I=m,N=d,H=p,_=S,Y=A,V=M)):C>=E?(D=l,B=d,G=S,et=M,l>=0?(x=h,b=c,I=m,N=f,H=p,_=g,Y=A,V=u):(x=c,b=h,I=f,N=m,H=g,_=p,Y=u,V=A)):(D=h,B=m,G=p,et=A,h>=0?(x=c,b=l,I=f,N=d,H=g,_=S,Y=u,V=M):(x=l,b=c,I=d,N=f,H=S,_=g,Y=M,V=u)),D===0)return null;let X=x/D,Q=b/D,$=1/D,Mt=I-X*B,Lt=N-Q*B,J=H-X*G,pt=_-Q*G,vt=Y-X*et,Et=V-Q*et,mt=vt*pt-Et*J,Dt=Mt*Et-Lt*vt,le=J*Lt-pt*Mt;if(s){if(mt<0||Dt<0||le<0)return null}else if((mt<0||Dt<0||le<0)&&(mt>0||Dt>0||le>0))return null;let Rt=mt+Dt+le;if(Rt===0)return null;let qt=$*(mt*B+Dt*G+le*et);return(Rt>0?qt<0:qt>0)?null:this.at(qt/Rt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$e=class extends In{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Qr,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fc=new Qt,oi=new us,tr=new ci,pc=new U,er=new U,nr=new U,ir=new U,Ro=new U,sr=new U,mc=new U,rr=new U,pe=class extends Te{constructor(t=new _e,e=new $e){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){sr.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=o[c],f=r[c];h!==0&&(Ro.fromBufferAttribute(f,t),a?sr.addScaledVector(Ro,h):sr.addScaledVector(Ro.sub(e),h))}e.add(sr)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),tr.copy(n.boundingSphere),tr.applyMatrix4(r),oi.copy(t.ray).recast(t.near),!(tr.containsPoint(oi.origin)===!1&&(oi.intersectSphere(tr,pc)===null||oi.origin.distanceToSquared(pc)>(t.far-t.near)**2))&&(fc.copy(r).invert(),oi.copy(t.ray).applyMatrix4(fc),!(n.boundingBox!==null&&oi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,oi)))}_computeIntersections(t,e,n){let s,r=this.geometry,a=this.material,o=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,m=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,S=d.length;g<S;g++){let p=d[g],u=a[p.materialIndex],M=Math.max(p.start,m.start),A=Math.min(o.count,Math.min(p.start+p.count,m.start+m.count));for(let w=M,C=A;w<C;w+=3){let E=o.getX(w),x=o.getX(w+1),b=o.getX(w+2);s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),S=Math.min(o.count,m.start+m.count);for(let p=g,u=S;p<u;p+=3){let M=o.getX(p),A=o.getX(p+1),w=o.getX(p+2);s=ar(this,a,t,n,l,h,f,M,A,w),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(a))for(let g=0,S=d.length;g<S;g++){let p=d[g],u=a[p.materialIndex],M=Math.max(p.start,m.start),A=Math.min(c.count,Math.min(p.start+p.count,m.start+m.count));for(let w=M,C=A;w<C;w+=3){let E=w,x=w+1,b=w+2;s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),S=Math.min(c.count,m.start+m.count);for(let p=g,u=S;p<u;p+=3){let M=p,A=p+1,w=p+2;s=ar(this,a,t,n,l,h,f,M,A,w),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function Yu(i,t,e,n,s,r,a,o){let c;if(t.side===De?c=n.intersectTriangle(a,r,s,!0,o):c=n.intersectTriangle(s,r,a,t.side===Qn,o),c===null)return null;rr.copy(o),rr.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(rr);return l<e.near||l>e.far?null:{distance:l,point:rr.clone(),object:i}}function ar(i,t,e,n,s,r,a,o,c,l){i.getVertexPosition(o,er),i.getVertexPosition(c,nr),i.getVertexPosition(l,ir);let h=Yu(i,t,e,n,er,nr,ir,mc);if(h){let f=new U;Cn.getBarycoord(mc,er,nr,ir,f),s&&(h.uv=Cn.getInterpolatedAttribute(s,o,c,l,f,new Ht)),r&&(h.uv1=Cn.getInterpolatedAttribute(r,o,c,l,f,new Ht)),a&&(h.normal=Cn.getInterpolatedAttribute(a,o,c,l,f,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:c,c:l,normal:new U,materialIndex:0};Cn.getNormal(er,nr,ir,d.normal),h.face=d,h.barycoord=f}return h}var Nr=class extends Oe{constructor(t=null,e=1,n=1,s,r,a,o,c,l=Me,h=Me,f,d){super(null,a,o,c,l,h,s,r,f,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var li=new ci,Zu=new Ht(.5,.5),or=new U,Zn=class{constructor(t=new rn,e=new rn,n=new rn,s=new rn,r=new rn,a=new rn){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=je,n=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],c=r[2],l=r[3],h=r[4],f=r[5],d=r[6],m=r[7],g=r[8],S=r[9],p=r[10],u=r[11],M=r[12],A=r[13],w=r[14],C=r[15];if(s[0].setComponents(l-a,m-h,u-g,C-M).normalize(),s[1].setComponents(l+a,m+h,u+g,C+M).normalize(),s[2].setComponents(l+o,m+f,u+S,C+A).normalize(),s[3].setComponents(l-o,m-f,u-S,C-A).normalize(),n)s[4].setComponents(c,d,p,w).normalize(),s[5].setComponents(l-c,m-d,u-p,C-w).normalize();else if(s[4].setComponents(l-c,m-d,u-p,C-w).normalize(),e===je)s[5].setComponents(l+c,m+d,u+p,C+w).normalize();else if(e===Li)s[5].setComponents(c,d,p,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),li.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),li.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(li)}intersectsSprite(t){li.center.set(0,0,0);let e=Zu.distanceTo(t.center);return li.radius=.7071067811865476+e,li.applyMatrix4(t.matrixWorld),this.intersectsSphere(li)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(or.x=s.normal.x>0?t.max.x:t.min.x,or.y=s.normal.y>0?t.max.y:t.min.y,or.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(or)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gc=new Qt,Dr=class i{constructor(){this.coordinateSystem=je,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];gc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Zn),n[s].setFromProjectionMatrix(gc,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Zn),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var qn=class extends In{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ur=new U,Fr=new U,xc=new Qt,ts=new us,lr=new ci,_o=new U,vc=new U,Fi=class extends Te{constructor(t=new _e,e=new qn){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ur.fromBufferAttribute(e,s-1),Fr.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ur.distanceTo(Fr);t.setAttribute("lineDistance",new te(n,1))}else Ct("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),lr.copy(n.boundingSphere),lr.applyMatrix4(s),lr.radius+=r,t.ray.intersectsSphere(lr)===!1)return;xc.copy(s).invert(),ts.copy(t.ray).applyMatrix4(xc);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let S=m,p=g-1;S<p;S+=l){let u=h.getX(S),M=h.getX(S+1),A=cr(this,t,ts,c,u,M,S);A&&e.push(A)}if(this.isLineLoop){let S=h.getX(g-1),p=h.getX(m),u=cr(this,t,ts,c,S,p,g-1);u&&e.push(u)}}else{let m=Math.max(0,a.start),g=Math.min(d.count,a.start+a.count);for(let S=m,p=g-1;S<p;S+=l){let u=cr(this,t,ts,c,S,S+1,S);u&&e.push(u)}if(this.isLineLoop){let S=cr(this,t,ts,c,g-1,m,g-1);S&&e.push(S)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function cr(i,t,e,n,s,r,a){let o=i.geometry.attributes.position;if(Ur.fromBufferAttribute(o,s),Fr.fromBufferAttribute(o,r),e.distanceSqToSegment(Ur,Fr,_o,vc)>n)return;_o.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(_o);if(!(l<t.near||l>t.far))return{distance:l,point:vc.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var yc=new U,Sc=new U,Oi=class extends Fi{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)yc.fromBufferAttribute(e,s),Sc.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+yc.distanceTo(Sc);t.setAttribute("lineDistance",new te(n,1))}else Ct("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ds=class extends Oe{constructor(t=[],e=fi,n,s,r,a,o,c,l,h){super(t,e,n,s,r,a,o,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ln=class extends Oe{constructor(t,e,n=an,s,r,a,o=Me,c=Me,l,h=_n,f=1){if(h!==_n&&h!==Un)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:f};super(d,s,r,a,o,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Di(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},fs=class extends Ln{constructor(t,e=an,n=fi,s,r,a=Me,o=Me,c,l=_n){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ps=class extends Oe{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Nn=class i extends _e{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let c=[],l=[],h=[],f=[],d=0,m=0;g("z","y","x",-1,-1,n,e,t,a,r,0),g("z","y","x",1,-1,n,e,-t,a,r,1),g("x","z","y",1,1,t,n,e,s,a,2),g("x","z","y",1,-1,t,n,-e,s,a,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2));function g(S,p,u,M,A,w,C,E,x,b,D){let I=w/x,N=C/b,B=w/2,H=C/2,_=E/2,G=x+1,Y=b+1,V=0,et=0,X=new U;for(let Q=0;Q<Y;Q++){let $=Q*N-H;for(let Mt=0;Mt<G;Mt++){let Lt=Mt*I-B;X[S]=Lt*M,X[p]=$*A,X[u]=_,l.push(X.x,X.y,X.z),X[S]=0,X[p]=0,X[u]=E>0?1:-1,h.push(X.x,X.y,X.z),f.push(Mt/x),f.push(1-Q/b),V+=1}}for(let Q=0;Q<b;Q++)for(let $=0;$<x;$++){let Mt=d+$+G*Q,Lt=d+$+G*(Q+1),J=d+($+1)+G*(Q+1),pt=d+($+1)+G*Q;c.push(Mt,Lt,pt),c.push(Lt,J,pt),et+=6}o.addGroup(m,et,D),m+=et,d+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Bi=class i extends _e{constructor(t=1,e=1,n=1,s=32,r=1,a=!1,o=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],d=[],m=[],g=0,S=[],p=n/2,u=0;M(),a===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new te(f,3)),this.setAttribute("normal",new te(d,3)),this.setAttribute("uv",new te(m,2));function M(){let w=new U,C=new U,E=0,x=(e-t)/n;for(let b=0;b<=r;b++){let D=[],I=b/r,N=I*(e-t)+t;for(let B=0;B<=s;B++){let H=B/s,_=H*c+o,G=Math.sin(_),Y=Math.cos(_);C.x=N*G,C.y=-I*n+p,C.z=N*Y,f.push(C.x,C.y,C.z),w.set(G,x,Y).normalize(),d.push(w.x,w.y,w.z),m.push(H,1-I),D.push(g++)}S.push(D)}for(let b=0;b<s;b++)for(let D=0;D<r;D++){let I=S[D][b],N=S[D+1][b],B=S[D+1][b+1],H=S[D][b+1];(t>0||D!==0)&&(h.push(I,N,H),E+=3),(e>0||D!==r-1)&&(h.push(N,B,H),E+=3)}l.addGroup(u,E,0),u+=E}function A(w){let C=g,E=new Ht,x=new U,b=0,D=w===!0?t:e,I=w===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,p*I,0),d.push(0,I,0),m.push(.5,.5),g++;let N=g;for(let B=0;B<=s;B++){let _=B/s*c+o,G=Math.cos(_),Y=Math.sin(_);x.x=D*Y,x.y=p*I,x.z=D*G,f.push(x.x,x.y,x.z),d.push(0,I,0),E.x=G*.5+.5,E.y=Y*.5*I+.5,m.push(E.x,E.y),g++}for(let B=0;B<s;B++){let H=C+B,_=N+B;w===!0?h.push(_,_+1,H):h.push(_+1,_,H),b+=3}l.addGroup(u,b,w===!0?1:2),u+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ms=class i extends Bi{constructor(t=1,e=1,n=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,n,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var hr=new U,ur=new U,Po=new U,dr=new Cn,gs=class extends _e{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(vr*e),a=t.getIndex(),o=t.getAttribute("position"),c=a?a.count:o.count,l=[0,0,0],h=["a","b","c"],f=new Array(3),d=new Map,m=[];for(let g=0;g<c;g+=3){a?(l[0]=a.getX(g),l[1]=a.getX(g+1),l[2]=a.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:S,b:p,c:u}=dr;if(S.fromBufferAttribute(o,l[0]),p.fromBufferAttribute(o,l[1]),u.fromBufferAttribute(o,l[2]),dr.getNormal(Po),f[0]=`${Math.round(S.x*s)},${Math.round(S.y*s)},${Math.round(S.z*s)}`,f[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,f[2]=`${Math.round(u.x*s)},${Math.round(u.y*s)},${Math.round(u.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let M=0;M<3;M++){let A=(M+1)%3,w=f[M],C=f[A],E=dr[h[M]],x=dr[h[A]],b=`${w}_${C}`,D=`${C}_${w}`,I=d.get(D);I?(Po.dot(I.normal)<=r&&(m.push(E.x,E.y,E.z),m.push(x.x,x.y,x.z)),d.set(D,null)):d.has(b)||d.set(b,{index0:l[M],index1:l[A],normal:Po.clone()})}}for(let g of d.values())if(g){let{index0:S,index1:p}=g;hr.fromBufferAttribute(o,S),ur.fromBufferAttribute(o,p),m.push(hr.x,hr.y,hr.z),m.push(ur.x,ur.y,ur.z)}this.setAttribute("position",new te(m,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var hi=class i extends _e{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(n),c=Math.floor(s),l=o+1,h=c+1,f=t/o,d=e/c,m=[],g=[],S=[],p=[];for(let u=0;u<h;u++){let M=u*d-a;for(let A=0;A<l;A++){let w=A*f-r;g.push(w,-M,0),S.push(0,0,1),p.push(A/o),p.push(1-u/c)}}for(let u=0;u<c;u++)for(let M=0;M<o;M++){let A=M+l*u,w=M+l*(u+1),C=M+1+l*(u+1),E=M+1+l*u;m.push(A,w,E),m.push(w,C,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(S,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var zi=class i extends _e{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(a+o,Math.PI),l=0,h=[],f=new U,d=new U,m=[],g=[],S=[],p=[];for(let u=0;u<=n;u++){let M=[],A=u/n,w=a+A*o,C=t*Math.cos(w),E=Math.sqrt(t*t-C*C),x=0;u===0&&a===0?x=.5/e:u===n&&c===Math.PI&&(x=-.5/e);for(let b=0;b<=e;b++){let D=b/e,I=s+D*r;f.x=-E*Math.cos(I),f.y=C,f.z=E*Math.sin(I),g.push(f.x,f.y,f.z),d.copy(f).normalize(),S.push(d.x,d.y,d.z),p.push(D+x,1-A),M.push(l++)}h.push(M)}for(let u=0;u<n;u++)for(let M=0;M<e;M++){let A=h[u][M+1],w=h[u][M],C=h[u+1][M],E=h[u+1][M+1];(u!==0||a>0)&&m.push(A,w,E),(u!==n-1||c<Math.PI)&&m.push(w,C,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(S,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var xs=class i extends _e{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],h=[],f=[],d=new U,m=new U,g=new U;for(let S=0;S<=n;S++){let p=a+S/n*o;for(let u=0;u<=s;u++){let M=u/s*r;m.x=(t+e*Math.cos(p))*Math.cos(M),m.y=(t+e*Math.cos(p))*Math.sin(M),m.z=e*Math.sin(p),l.push(m.x,m.y,m.z),d.x=t*Math.cos(M),d.y=t*Math.sin(M),g.subVectors(m,d).normalize(),h.push(g.x,g.y,g.z),f.push(u/s),f.push(S/n)}}for(let S=1;S<=n;S++)for(let p=1;p<=s;p++){let u=(s+1)*S+p-1,M=(s+1)*(S-1)+p-1,A=(s+1)*(S-1)+p,w=(s+1)*S+p;c.push(u,M,w),c.push(M,A,w)}this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function mi(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Mc(s))s.isRenderTargetTexture?(Ct("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Mc(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Pe(i){let t={};for(let e=0;e<i.length;e++){let n=mi(i[e]);for(let s in n)t[s]=n[s]}return t}function Mc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function qu(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function dl(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Gt.workingColorSpace}var fh={clone:mi,merge:Pe},Ju=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ku=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,gn=class extends In{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ju,this.fragmentShader=Ku,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=mi(t.uniforms),this.uniformsGroups=qu(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Ut().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ht().fromArray(s.value);break;case"v3":this.uniforms[n].value=new U().fromArray(s.value);break;case"v4":this.uniforms[n].value=new se().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Pt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Or=class extends gn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vs=class extends In{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new Ht(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pn,this.combine=Qr,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Br=class extends In{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qc,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},zr=class extends In{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ci(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function fr(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Jn=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let a;e:{i:if(!(t<s)){for(let o=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=e[++n],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(n=2,r=o);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}a=n,n=0;break e}break n}for(;n<a;){let o=n+a>>>1;t<e[o]?a=o:n=o+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=n[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:No,endingEnd:No}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],c=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Do:r=t,o=2*e-n;break;case Uo:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Do:a=t,c=2*n-e;break;case Uo:a=1,c=n+s[1]-s[0];break;default:a=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-o),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-e)/(s-e),S=g*g,p=S*g,u=-d*p+2*d*S-d*g,M=(1+d)*p+(-1.5-2*d)*S+(-.5+d)*g+1,A=(-1-m)*p+(1.5+m)*S+.5*g,w=m*p-m*S;for(let C=0;C!==o;++C)r[C]=u*a[h+C]+M*a[l+C]+A*a[c+C]+w*a[f+C];return r}},Vr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=(n-e)/(s-e),f=1-h;for(let d=0;d!==o;++d)r[d]=a[l+d]*f+a[c+d]*h;return r}},Gr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Hr=class extends Jn{interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-e)/(s-e),S=1-g;for(let p=0;p!==o;++p)r[p]=a[l+p]*S+a[c+p]*g;return r}let d=o*2,m=t-1;for(let g=0;g!==o;++g){let S=a[l+g],p=a[c+g],u=m*d+g*2,M=f[u],A=f[u+1],w=t*d+g*2,C=h[w],E=h[w+1],x=Qu(n,e,M,C,s);r[g]=ph(x,S,A,E,p)}return r}};function ph(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function ju(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Qu(i,t,e,n,s){let r=(i-t)/(s-t);for(let a=0;a<8;a++){let o=ph(r,t,e,n,s)-i;if(Math.abs(o)<1e-10)break;let c=ju(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-o/c))}return r}var We=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ci(e,this.TimeBufferType),this.values=Ci(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Ci(t.times,Array),values:Ci(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),fr(t.settings)&&(n.settings={inTangents:Ci(t.settings.inTangents,Array),outTangents:Ci(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Gr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Vr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new kr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Hr(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ns:e=this.InterpolantFactoryMethodDiscrete;break;case Rr:e=this.InterpolantFactoryMethodLinear;break;case gr:e=this.InterpolantFactoryMethodSmooth;break;case Lo:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ct("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ns;case this.InterpolantFactoryMethodLinear:return Rr;case this.InterpolantFactoryMethodSmooth:return gr;case this.InterpolantFactoryMethodBezier:return Lo}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;fr(this.settings)&&(bc(this.settings.inTangents,t),bc(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;fr(this.settings)&&(wc(this.settings.inTangents,t),wc(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<t;)++r;for(;a!==-1&&n[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(_t("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(_t("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let c=n[o];if(typeof c=="number"&&isNaN(c)){_t("KeyframeTrack: Time is not a valid number.",this,o,c),t=!1;break}if(a!==null&&a>c){_t("KeyframeTrack: Out of order keys.",this,o,c,a),t=!1;break}a=c}if(s!==void 0&&Au(s))for(let o=0,c=s.length;o!==c;++o){let l=s[o];if(isNaN(l)){_t("KeyframeTrack: Value is not a valid number.",this,o,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===gr,r=t.length-1,a=1;for(let o=1;o<r;++o){let c=!1,l=t[o],h=t[o+1];if(l!==h&&(o!==1||l!==t[0]))if(s)c=!0;else{let f=o*n,d=f-n,m=f+n;for(let g=0;g!==n;++g){let S=e[f+g];if(S!==e[d+g]||S!==e[m+g]){c=!0;break}}}if(c){if(o!==a){t[a]=t[o];let f=o*n,d=a*n;for(let m=0;m!==n;++m)e[d+m]=e[f+m]}++a}}if(r>0){t[a]=t[r];for(let o=r*n,c=a*n,l=0;l!==n;++l)e[c+l]=e[o+l];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,fr(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function wc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}We.prototype.ValueTypeName="";We.prototype.TimeBufferType=Float32Array;We.prototype.ValueBufferType=Float32Array;We.prototype.DefaultInterpolation=Rr;var Kn=class extends We{constructor(t,e,n){super(t,e,n)}};Kn.prototype.ValueTypeName="bool";Kn.prototype.ValueBufferType=Array;Kn.prototype.DefaultInterpolation=ns;Kn.prototype.InterpolantFactoryMethodLinear=void 0;Kn.prototype.InterpolantFactoryMethodSmooth=void 0;var Wr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Wr.prototype.ValueTypeName="color";var Xr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Xr.prototype.ValueTypeName="number";var Yr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=(n-e)/(s-e),l=t*o;for(let h=l+o;l!==h;l+=4)Qe.slerpFlat(r,0,a,l-o,a,l,c);return r}},ys=class extends We{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Yr(this.times,this.values,this.getValueSize(),t)}};ys.prototype.ValueTypeName="quaternion";ys.prototype.InterpolantFactoryMethodSmooth=void 0;var jn=class extends We{constructor(t,e,n){super(t,e,n)}};jn.prototype.ValueTypeName="string";jn.prototype.ValueBufferType=Array;jn.prototype.DefaultInterpolation=ns;jn.prototype.InterpolantFactoryMethodLinear=void 0;jn.prototype.InterpolantFactoryMethodSmooth=void 0;var Zr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Zr.prototype.ValueTypeName="vector";var qr=class{constructor(t,e,n){let s=this,r=!1,a=0,o=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,f){return l.push(h,f),this},this.removeHandler=function(h){let f=l.indexOf(h);return f!==-1&&l.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=l.length;f<d;f+=2){let m=l[f],g=l[f+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mh=new qr,Jr=class{constructor(t){this.manager=t!==void 0?t:mh,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ss=class extends Te{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ut(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ms=class extends Ss{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Te.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ut(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Io=new Qt,Tc=new U,Ec=new U,Kr=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ht(512,512),this.mapType=Be,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zn,this._frameExtents=new Ht(1,1),this._viewportCount=1,this._viewports=[new se(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Tc.setFromMatrixPosition(t.matrixWorld),e.position.copy(Tc),Ec.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Ec),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Io.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Io,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Li||t.reversedDepth?e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,.5,.5,0,0,0,1),e.multiply(Io)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},pr=new U,mr=new Qe,dn=new U,bs=class extends Te{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=je,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xn=new U,Ac=new Ht,Cc=new Ht,Le=class extends bs{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=_r*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(vr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return _r*2*Math.atan(Math.tan(vr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Xn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z),Xn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z)}getViewSize(t,e){return this.getViewBounds(t,Ac,Cc),e.subVectors(Cc,Ac)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(vr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let c=a.fullWidth,l=a.fullHeight;r+=a.offsetX*s/c,e-=a.offsetY*n/l,s*=a.width/c,n*=a.height/l}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ws=class extends bs{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,a=n+t,o=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,a=r+l*this.view.width,o-=h*this.view.offsetY,c=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Fo=class extends Kr{constructor(){super(new ws(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ts=class extends Ss{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Te.DEFAULT_UP),this.updateMatrix(),this.target=new Te,this.shadow=new Fo}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ri=-90,_i=1,ki=class extends Te{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Le(Ri,_i,t,e);s.layers=this.layers,this.add(s);let r=new Le(Ri,_i,t,e);r.layers=this.layers,this.add(r);let a=new Le(Ri,_i,t,e);a.layers=this.layers,this.add(a);let o=new Le(Ri,_i,t,e);o.layers=this.layers,this.add(o);let c=new Le(Ri,_i,t,e);c.layers=this.layers,this.add(c);let l=new Le(Ri,_i,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,c]=e;for(let l of e)this.remove(l);if(t===je)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Li)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,c,l,h]=this.children,f=t.getRenderTarget(),d=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=S,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,d,m),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},jr=class extends Le{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var fl="\\[\\]\\.:\\/",$u=new RegExp("["+fl+"]","g"),pl="[^"+fl+"]",td="[^"+fl.replace("\\.","")+"]",ed=/((?:WC+[\/:])*)/.source.replace("WC",pl),nd=/(WCOD+)?/.source.replace("WCOD",td),id=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pl),sd=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pl),rd=new RegExp("^"+ed+nd+id+sd+"$"),ad=["material","materials","bones","map"],Oo=class{constructor(t,e,n){let s=n||ee.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},ee=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace($u,"")}static parseTrackName(t){let e=rd.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ad.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let c=n(o.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Ct("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){_t("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){_t("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){_t("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){_t("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){_t("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let a=t[s];if(a===void 0){let l=e.nodeName;_t("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(c=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ee.Composite=Oo;ee.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ee.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ee.prototype.GetterByBindingType=[ee.prototype._getValue_direct,ee.prototype._getValue_array,ee.prototype._getValue_arrayElement,ee.prototype._getValue_toArray];ee.prototype.SetterByBindingTypeAndVersioning=[[ee.prototype._setValue_direct,ee.prototype._setValue_direct_setNeedsUpdate,ee.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_array,ee.prototype._setValue_array_setNeedsUpdate,ee.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_arrayElement,ee.prototype._setValue_arrayElement_setNeedsUpdate,ee.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_fromArray,ee.prototype._setValue_fromArray_setNeedsUpdate,ee.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p0=new Float32Array(1);var Bo=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Es=class extends Oi{constructor(t=10,e=10,n=4473924,s=8947848){n=new Ut(n),s=new Ut(s);let r=e/2,a=t/e,o=t/2,c=[],l=[];for(let d=0,m=0,g=-o;d<=e;d++,g+=a){c.push(-o,0,g,o,0,g),c.push(g,0,-o,g,0,o);let S=d===r?n:s;S.toArray(l,m),m+=3,S.toArray(l,m),m+=3,S.toArray(l,m),m+=3,S.toArray(l,m),m+=3}let h=new _e;h.setAttribute("position",new te(c,3)),h.setAttribute("color",new te(l,3));let f=new qn({vertexColors:!0,toneMapped:!1});super(h,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};function ml(i,t,e,n){let s=od(n);switch(e){case il:return i*t;case rl:return i*t/s.components*s.byteLength;case ra:return i*t/s.components*s.byteLength;case $n:return i*t*2/s.components*s.byteLength;case aa:return i*t*2/s.components*s.byteLength;case sl:return i*t*3/s.components*s.byteLength;case cn:return i*t*4/s.components*s.byteLength;case oa:return i*t*4/s.components*s.byteLength;case Rs:case _s:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ps:case Is:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ca:case ua:return Math.max(i,16)*Math.max(t,8)/4;case la:case ha:return Math.max(i,8)*Math.max(t,8)/2;case da:case fa:case ma:case ga:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case pa:case Ls:case xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case va:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ya:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Sa:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Ma:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ba:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case wa:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Ta:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ea:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Aa:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Ca:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ra:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case _a:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Pa:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Ia:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case La:case Na:case Da:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ua:case Fa:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ns:case Oa:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function od(i){switch(i){case Be:case $o:return{byteLength:1,components:1};case Wi:case tl:case ln:return{byteLength:2,components:1};case ia:case sa:return{byteLength:2,components:4};case an:case na:case on:return{byteLength:4,components:1};case el:case nl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ct("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Oh(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function cd(i){let t=new WeakMap;function e(o,c){let l=o.array,h=o.usage,f=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),o.onUploadCallback();let m;if(l instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=i.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=i.SHORT;else if(l instanceof Uint32Array)m=i.UNSIGNED_INT;else if(l instanceof Int32Array)m=i.INT;else if(l instanceof Int8Array)m=i.BYTE;else if(l instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,c,l){let h=c.array,f=c.updateRanges;if(i.bindBuffer(l,o),f.length===0)i.bufferSubData(l,0,h);else{f.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<f.length;m++){let g=f[d],S=f[m];S.start<=g.start+g.count+1?g.count=Math.max(g.count,S.start+S.count-g.start):(++d,f[d]=S)}f.length=d+1;for(let m=0,g=f.length;m<g;m++){let S=f[m];i.bufferSubData(l,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let c=t.get(o);c&&(i.deleteBuffer(c.buffer),t.delete(o))}function a(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let l=t.get(o);if(l===void 0)t.set(o,e(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,o,c),l.version=o.version}}return{get:s,remove:r,update:a}}var hd=`#ifdef USE_ALPHAHASH
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
}`,Vd=`#ifdef USE_ENVMAP
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
#endif`,Gd=`#ifdef USE_ENVMAP
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
#endif`,Yd=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Zd=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,qd=`#ifdef USE_FOG
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
#endif`,Vf=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Gf=`#ifdef DITHERING
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
#endif`,Yf=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,qf=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
}`,Vp=`uniform vec3 color;
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
}`,Gp=`uniform float rotation;
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
}`,Bt={alphahash_fragment:hd,alphahash_pars_fragment:ud,alphamap_fragment:dd,alphamap_pars_fragment:fd,alphatest_fragment:pd,alphatest_pars_fragment:md,aomap_fragment:gd,aomap_pars_fragment:xd,batching_pars_vertex:vd,batching_vertex:yd,begin_vertex:Sd,beginnormal_vertex:Md,bsdfs:bd,iridescence_fragment:wd,bumpmap_pars_fragment:Td,clipping_planes_fragment:Ed,clipping_planes_pars_fragment:Ad,clipping_planes_pars_vertex:Cd,clipping_planes_vertex:Rd,color_fragment:_d,color_pars_fragment:Pd,color_pars_vertex:Id,color_vertex:Ld,common:Nd,defaultnormal_vertex:Dd,displacementmap_pars_vertex:Ud,displacementmap_vertex:Fd,emissivemap_fragment:Od,emissivemap_pars_fragment:Bd,colorspace_fragment:zd,colorspace_pars_fragment:kd,envmap_fragment:Vd,envmap_common_pars_fragment:Gd,envmap_pars_fragment:Hd,envmap_pars_vertex:Wd,envmap_physical_pars_fragment:ef,envmap_vertex:Xd,fog_vertex:Yd,fog_pars_vertex:Zd,fog_fragment:qd,fog_pars_fragment:Jd,gradientmap_pars_fragment:Kd,lightmap_pars_fragment:jd,lights_lambert_fragment:Qd,lights_lambert_pars_fragment:$d,lights_pars_begin:tf,lights_toon_fragment:nf,lights_toon_pars_fragment:sf,lights_phong_fragment:rf,lights_phong_pars_fragment:af,lights_physical_fragment:of,lights_physical_pars_fragment:lf,lights_fragment_begin:cf,lights_fragment_maps:hf,lights_fragment_end:uf,lightprobes_pars_fragment:df,logdepthbuf_fragment:ff,logdepthbuf_pars_fragment:pf,logdepthbuf_pars_vertex:mf,logdepthbuf_vertex:gf,map_fragment:xf,map_pars_fragment:vf,map_particle_fragment:yf,map_particle_pars_fragment:Sf,metalnessmap_fragment:Mf,metalnessmap_pars_fragment:bf,morphinstance_vertex:wf,morphcolor_vertex:Tf,morphnormal_vertex:Ef,morphtarget_pars_vertex:Af,morphtarget_vertex:Cf,normal_fragment_begin:Rf,normal_fragment_maps:_f,normal_pars_fragment:Pf,normal_pars_vertex:If,normal_vertex:Lf,normalmap_pars_fragment:Nf,clearcoat_normal_fragment_begin:Df,clearcoat_normal_fragment_maps:Uf,clearcoat_pars_fragment:Ff,iridescence_pars_fragment:Of,opaque_fragment:Bf,packing:zf,premultiplied_alpha_fragment:kf,project_vertex:Vf,dithering_fragment:Gf,dithering_pars_fragment:Hf,roughnessmap_fragment:Wf,roughnessmap_pars_fragment:Xf,shadowmap_pars_fragment:Yf,shadowmap_pars_vertex:Zf,shadowmap_vertex:qf,shadowmask_pars_fragment:Jf,skinbase_vertex:Kf,skinning_pars_vertex:jf,skinning_vertex:Qf,skinnormal_vertex:$f,specularmap_fragment:tp,specularmap_pars_fragment:ep,tonemapping_fragment:np,tonemapping_pars_fragment:ip,transmission_fragment:sp,transmission_pars_fragment:rp,uv_pars_fragment:ap,uv_pars_vertex:op,uv_vertex:lp,worldpos_vertex:cp,background_vert:hp,background_frag:up,backgroundCube_vert:dp,backgroundCube_frag:fp,cube_vert:pp,cube_frag:mp,depth_vert:gp,depth_frag:xp,distance_vert:vp,distance_frag:yp,equirect_vert:Sp,equirect_frag:Mp,linedashed_vert:bp,linedashed_frag:wp,meshbasic_vert:Tp,meshbasic_frag:Ep,meshlambert_vert:Ap,meshlambert_frag:Cp,meshmatcap_vert:Rp,meshmatcap_frag:_p,meshnormal_vert:Pp,meshnormal_frag:Ip,meshphong_vert:Lp,meshphong_frag:Np,meshphysical_vert:Dp,meshphysical_frag:Up,meshtoon_vert:Fp,meshtoon_frag:Op,points_vert:Bp,points_frag:zp,shadow_vert:kp,shadow_frag:Vp,sprite_vert:Gp,sprite_frag:Hp},ft={common:{diffuse:{value:new Ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Pt},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Pt}},envmap:{envMap:{value:null},envMapRotation:{value:new Pt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Pt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Pt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Pt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Pt},normalScale:{value:new Ht(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Pt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Pt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Pt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Pt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0},uvTransform:{value:new Pt}},sprite:{diffuse:{value:new Ut(16777215)},opacity:{value:1},center:{value:new Ht(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Pt},alphaMap:{value:null},alphaMapTransform:{value:new Pt},alphaTest:{value:0}}},Sn={basic:{uniforms:Pe([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Bt.meshbasic_vert,fragmentShader:Bt.meshbasic_frag},lambert:{uniforms:Pe([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},envMapIntensity:{value:1}}]),vertexShader:Bt.meshlambert_vert,fragmentShader:Bt.meshlambert_frag},phong:{uniforms:Pe([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},specular:{value:new Ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphong_vert,fragmentShader:Bt.meshphong_frag},standard:{uniforms:Pe([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag},toon:{uniforms:Pe([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)}}]),vertexShader:Bt.meshtoon_vert,fragmentShader:Bt.meshtoon_frag},matcap:{uniforms:Pe([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Bt.meshmatcap_vert,fragmentShader:Bt.meshmatcap_frag},points:{uniforms:Pe([ft.points,ft.fog]),vertexShader:Bt.points_vert,fragmentShader:Bt.points_frag},dashed:{uniforms:Pe([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Bt.linedashed_vert,fragmentShader:Bt.linedashed_frag},depth:{uniforms:Pe([ft.common,ft.displacementmap]),vertexShader:Bt.depth_vert,fragmentShader:Bt.depth_frag},normal:{uniforms:Pe([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Bt.meshnormal_vert,fragmentShader:Bt.meshnormal_frag},sprite:{uniforms:Pe([ft.sprite,ft.fog]),vertexShader:Bt.sprite_vert,fragmentShader:Bt.sprite_frag},background:{uniforms:{uvTransform:{value:new Pt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Bt.background_vert,fragmentShader:Bt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Pt}},vertexShader:Bt.backgroundCube_vert,fragmentShader:Bt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Bt.cube_vert,fragmentShader:Bt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Bt.equirect_vert,fragmentShader:Bt.equirect_frag},distance:{uniforms:Pe([ft.common,ft.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Bt.distance_vert,fragmentShader:Bt.distance_frag},shadow:{uniforms:Pe([ft.lights,ft.fog,{color:{value:new Ut(0)},opacity:{value:1}}]),vertexShader:Bt.shadow_vert,fragmentShader:Bt.shadow_frag}};Sn.physical={uniforms:Pe([Sn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Pt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Pt},clearcoatNormalScale:{value:new Ht(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Pt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Pt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Pt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Pt},sheen:{value:0},sheenColor:{value:new Ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Pt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Pt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Pt},transmissionSamplerSize:{value:new Ht},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Pt},attenuationDistance:{value:0},attenuationColor:{value:new Ut(0)},specularColor:{value:new Ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Pt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Pt},anisotropyVector:{value:new Ht},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Pt}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag};var za={r:0,b:0,g:0},Wp=new Qt,Bh=new Pt;Bh.set(-1,0,0,0,1,0,0,0,1);function Xp(i,t,e,n,s,r){let a=new Ut(0),o=s===!0?0:1,c,l,h=null,f=0,d=null;function m(M){let A=M.isScene===!0?M.background:null;if(A&&A.isTexture){let w=M.backgroundBlurriness>0;A=t.get(A,w)}return A}function g(M){let A=!1,w=m(M);w===null?p(a,o):w&&w.isColor&&(p(w,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(M,A){let w=m(A);w&&w.isCubeTexture?(l===void 0&&(l=new pe(new Nn(1,1,1),new gn({name:"BackgroundCubeMaterial",uniforms:mi(Sn.backgroundCube.uniforms),vertexShader:Sn.backgroundCube.vertexShader,fragmentShader:Sn.backgroundCube.fragmentShader,side:De,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=w,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Wp.makeRotationFromEuler(A.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Bh),l.material.toneMapped=Gt.getTransfer(w.colorSpace)!==Zt,(h!==w||f!==w.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,f=w.version,d=i.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null)):w&&w.isTexture&&(c===void 0&&(c=new pe(new hi(2,2),new gn({name:"BackgroundMaterial",uniforms:mi(Sn.background.uniforms),vertexShader:Sn.background.vertexShader,fragmentShader:Sn.background.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=w,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Gt.getTransfer(w.colorSpace)!==Zt,w.matrixAutoUpdate===!0&&w.updateMatrix(),c.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||f!==w.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,f=w.version,d=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function p(M,A){M.getRGB(za,dl(i)),e.buffers.color.setClear(za.r,za.g,za.b,A,r)}function u(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,A=1){a.set(M),o=A,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(M){o=M,p(a,o)},render:g,addToRenderList:S,dispose:u}}function Yp(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,a=!1;function o(N,B,H,_,G){let Y=!1,V=f(N,_,H,B);r!==V&&(r=V,l(r.object)),Y=m(N,_,H,G),Y&&g(N,_,H,G),G!==null&&t.update(G,i.ELEMENT_ARRAY_BUFFER),(Y||a)&&(a=!1,w(N,B,H,_),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function c(){return i.createVertexArray()}function l(N){return i.bindVertexArray(N)}function h(N){return i.deleteVertexArray(N)}function f(N,B,H,_){let G=_.wireframe===!0,Y=n[B.id];Y===void 0&&(Y={},n[B.id]=Y);let V=N.isInstancedMesh===!0?N.id:0,et=Y[V];et===void 0&&(et={},Y[V]=et);let X=et[H.id];X===void 0&&(X={},et[H.id]=X);let Q=X[G];return Q===void 0&&(Q=d(c()),X[G]=Q),Q}function d(N){let B=[],H=[],_=[];for(let G=0;G<e;G++)B[G]=0,H[G]=0,_[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:H,attributeDivisors:_,object:N,attributes:{},index:null}}function m(N,B,H,_){let G=r.attributes,Y=B.attributes,V=0,et=H.getAttributes();for(let X in et)if(et[X].location>=0){let $=G[X],Mt=Y[X];if(Mt===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&(Mt=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&(Mt=N.instanceColor)),$===void 0||$.attribute!==Mt||Mt&&$.data!==Mt.data)return!0;V++}return r.attributesNum!==V||r.index!==_}function g(N,B,H,_){let G={},Y=B.attributes,V=0,et=H.getAttributes();for(let X in et)if(et[X].location>=0){let $=Y[X];$===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&($=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&($=N.instanceColor));let Mt={};Mt.attribute=$,$&&$.data&&(Mt.data=$.data),G[X]=Mt,V++}r.attributes=G,r.attributesNum=V,r.index=_}function S(){let N=r.newAttributes;for(let B=0,H=N.length;B<H;B++)N[B]=0}function p(N){u(N,0)}function u(N,B){let H=r.newAttributes,_=r.enabledAttributes,G=r.attributeDivisors;H[N]=1,_[N]===0&&(i.enableVertexAttribArray(N),_[N]=1),G[N]!==B&&(i.vertexAttribDivisor(N,B),G[N]=B)}function M(){let N=r.newAttributes,B=r.enabledAttributes;for(let H=0,_=B.length;H<_;H++)B[H]!==N[H]&&(i.disableVertexAttribArray(H),B[H]=0)}function A(N,B,H,_,G,Y,V){V===!0?i.vertexAttribIPointer(N,B,H,G,Y):i.vertexAttribPointer(N,B,H,_,G,Y)}function w(N,B,H,_){S();let G=_.attributes,Y=H.getAttributes(),V=B.defaultAttributeValues;for(let et in Y){let X=Y[et];if(X.location>=0){let Q=G[et];if(Q===void 0&&(et==="instanceMatrix"&&N.instanceMatrix&&(Q=N.instanceMatrix),et==="instanceColor"&&N.instanceColor&&(Q=N.instanceColor)),Q!==void 0){let $=Q.normalized,Mt=Q.itemSize,Lt=t.get(Q);if(Lt===void 0)continue;let J=Lt.buffer,pt=Lt.type,vt=Lt.bytesPerElement,Et=pt===i.INT||pt===i.UNSIGNED_INT||Q.gpuType===na;if(Q.isInterleavedBufferAttribute){let mt=Q.data,Dt=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,le=Q.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Rt=0;Rt<X.locationSize;Rt++)u(X.location+Rt,mt.meshPerAttribute);N.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Rt=0;Rt<X.locationSize;Rt++)p(X.location+Rt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let Rt=0;Rt<X.locationSize;Rt++)A(X.location+Rt,Mt/X.locationSize,pt,$,Dt*vt,(le+Mt/X.locationSize*Rt)*vt,Et)}else{if(Q.isInstancedBufferAttribute){for(let mt=0;mt<X.locationSize;mt++)u(X.location+mt,Q.meshPerAttribute);N.isInstancedMesh!==!0&&_._maxInstanceCount===void 0&&(_._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let mt=0;mt<X.locationSize;mt++)p(X.location+mt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let mt=0;mt<X.locationSize;mt++)A(X.location+mt,Mt/X.locationSize,pt,$,Mt*vt,Mt/X.locationSize*mt*vt,Et)}}else if(V!==void 0){let $=V[et];if($!==void 0)switch($.length){case 2:i.vertexAttrib2fv(X.location,$);break;case 3:i.vertexAttrib3fv(X.location,$);break;case 4:i.vertexAttrib4fv(X.location,$);break;default:i.vertexAttrib1fv(X.location,$)}}}}M()}function C(){D();for(let N in n){let B=n[N];for(let H in B){let _=B[H];for(let G in _){let Y=_[G];for(let V in Y)h(Y[V].object),delete Y[V];delete _[G]}}delete n[N]}}function E(N){if(n[N.id]===void 0)return;let B=n[N.id];for(let H in B){let _=B[H];for(let G in _){let Y=_[G];for(let V in Y)h(Y[V].object),delete Y[V];delete _[G]}}delete n[N.id]}function x(N){for(let B in n){let H=n[B];for(let _ in H){let G=H[_];if(G[N.id]===void 0)continue;let Y=G[N.id];for(let V in Y)h(Y[V].object),delete Y[V];delete G[N.id]}}}function b(N){for(let B in n){let H=n[B],_=N.isInstancedMesh===!0?N.id:0,G=H[_];if(G!==void 0){for(let Y in G){let V=G[Y];for(let et in V)h(V[et].object),delete V[et];delete G[Y]}delete H[_],Object.keys(H).length===0&&delete n[B]}}}function D(){I(),a=!0,r!==s&&(r=s,l(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:D,resetDefaultState:I,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:S,enableAttribute:p,disableUnusedAttributes:M}}function Zp(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function a(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function o(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let m=0;m<h;m++)d+=l[m];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function qp(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==cn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let b=x===ln&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==Be&&x!==on&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Ct("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Ct("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Ct("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),u=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:a,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:S,maxCubemapSize:p,maxAttributes:u,maxVertexUniforms:M,maxVaryings:A,maxFragmentUniforms:w,maxSamples:C,samples:E}}function Jp(i){let t=this,e=null,n=0,s=!1,r=!1,a=new rn,o=new Pt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let m=f.length!==0||d||n!==0||s;return s=d,n=f.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){e=h(f,d,0)},this.setState=function(f,d,m){let g=f.clippingPlanes,S=f.clipIntersection,p=f.clipShadows,u=i.get(f);if(!s||g===null||g.length===0||r&&!p)r?h(null):l();else{let M=r?0:n,A=M*4,w=u.clippingState||null;c.value=w,w=h(g,d,A,m);for(let C=0;C!==A;++C)w[C]=e[C];u.clippingState=w,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=M}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(f,d,m,g){let S=f!==null?f.length:0,p=null;if(S!==0){if(p=c.value,g!==!0||p===null){let u=m+S*4,M=d.matrixWorldInverse;o.getNormalMatrix(M),(p===null||p.length<u)&&(p=new Float32Array(u));for(let A=0,w=m;A!==S;++A,w+=4)a.copy(f[A]).applyMatrix4(M,o),a.normal.toArray(p,w),p[w+3]=a.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=S,t.numIntersection=0,p}}var Os=class extends He{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ds(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Nn(5,5,5),r=new gn({name:"CubemapFromEquirect",uniforms:mi(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:De,blending:ui});r.uniforms.tEquirect.value=e;let a=new pe(s,r),o=e.minFilter;return e.minFilter===Dn&&(e.minFilter=Ne),new ki(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(r)}},gh=256,Kp=3,jp=20,zh=256,kh=16,Qp=3,$p=new U,tm=new Ut,Va=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ki(1,10,null),this._boxMesh=new pe(new Nn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:a=256,position:o=$p}=r,c=this._renderer;this._setSize(a);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,d=c.autoClearColor,m=c.autoClearDepth,g=c.autoClearStencil,S=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,S===null&&(t.background=c.getClearColor(tm));let p=new ki(n,s,h);return p.position.copy(o),p.update(c,t),c.autoClear=f,c.autoClearColor=d,c.autoClearDepth=m,c.autoClearStencil=g,t.background=S,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(gh,uh(t))}_fromTexture(t,e){t.mapping===fi||t.mapping===Hi?this._setSize(t.image.length===0?gh:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=xh(t,!1,!1),n=Math.log2(t)-Kp;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=xh(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===fi||t.mapping===Hi?(this._cubemapMaterial===null&&(this._cubemapMaterial=yh()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vh()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=em(),this._integrationMaterial=nm());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/kh);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-Qp)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let c=o>0?Math.log2(e)+.5*Math.log2(6/(zh*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=c,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=im());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function xh(i,t,e){return new Os(i,{minFilter:Dn,generateMipmaps:t,type:ln,colorSpace:is,depthBuffer:e})}function Bs(i,t,e){return new gn({name:i,uniforms:t,vertexShader:Bt.cube_vert,fragmentShader:e,side:De,blending:ui,depthTest:!1,depthWrite:!1})}function em(){return Bs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

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
	`)}function sm(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?a(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===$r||m===ta)if(t.has(d)){let g=t.get(d).texture;return o(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let S=new Os(g.height);return S.fromEquirectangularTexture(i,d),t.set(d,S),d.addEventListener("dispose",l),o(S.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===$r||m===ta,S=m===fi||m===Hi;if(g||S){let p=e.get(d),u=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==u)return n===null&&(n=new Va(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let M=d.image;return g&&M&&M.height>0||S&&M&&c(M)?(n===null&&(n=new Va(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function o(d,m){return m===$r?d.mapping=fi:m===ta&&(d.mapping=Hi),d}function c(d){let m=0,g=6;for(let S=0;S<g;S++)d[S]!==void 0&&m++;return m===g}function l(d){let m=d.target;m.removeEventListener("dispose",l);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function rm(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&es("WebGLRenderer: "+n+" extension not supported."),s}}}function am(i,t,e,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let S=r.get(g);S&&(t.remove(S),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,S){return s[S.id]!==void 0||(S.addEventListener("dispose",o),s[S.id]=new WeakRef(S),a.register(S,S.id,S),e.memory.geometries++),S}function h(g){let S=g.attributes;for(let p in S)t.update(S[p],i.ARRAY_BUFFER)}function f(g){let S=g.index,p=g.attributes.position,u=0;if(p===void 0)return;let M=S!==null?S.array.length:p.array.length/3-1,A=p.count>=65535?hs:cs,w=new A(Math.ceil(M/3)*6,1),C=w.array;if(S!==null){let x=S.array;u=S.version;for(let b=0,D=0;b<M;b+=3){let I=x[b+0],N=x[b+1],B=x[b+2];C[D++]=I,C[D++]=N,C[D++]=N,C[D++]=B,C[D++]=B,C[D++]=I}}else{u=p.version;for(let x=0,b=0;x<M;x+=3){let D=x+0,I=x+1,N=x+2;C[b++]=D,C[b++]=I,C[b++]=I,C[b++]=N,C[b++]=N,C[b++]=D}}w.version=u;let E=r.get(g);E&&t.remove(E),r.set(g,w)}function d(g){let S=r.get(g);if(S){let p=g.index;p!==null&&S.version<p.version&&f(g)}else f(g);return r.get(g)}function m(){for(let g in s){let S=s[g].deref();S!==void 0&&c(S)}}return{get:l,update:h,getWireframeAttribute:d,dispose:m}}function om(i,t,e){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function c(f,d){i.drawElements(n,d,r,f*a),e.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,f*a,m),e.update(d,n,m))}function h(f,d,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,m);let S=0;for(let p=0;p<m;p++)S+=d[p];e.update(S,n,1)}this.setMode=s,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function lm(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:_t("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function cm(i,t,e){let n=new WeakMap,s=new se;function r(a,o,c){let l=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=h!==void 0?h.length:0,d=n.get(o);if(d===void 0||d.count!==f){let D=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let m=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,S=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],u=o.morphAttributes.normal||[],M=o.morphAttributes.color||[],A=0;m===!0&&(A=1),g===!0&&(A=2),S===!0&&(A=3);let w=o.attributes.position.count*A,C=1;w>t.maxTextureSize&&(C=Math.ceil(w/t.maxTextureSize),w=t.maxTextureSize);let E=new Float32Array(w*C*4*f),x=new as(E,w,C,f);x.type=on,x.needsUpdate=!0;let b=A*4;for(let I=0;I<f;I++){let N=p[I],B=u[I],H=M[I],_=w*C*4*I;for(let G=0;G<N.count;G++){let Y=G*b;m===!0&&(s.fromBufferAttribute(N,G),E[_+Y+0]=s.x,E[_+Y+1]=s.y,E[_+Y+2]=s.z,E[_+Y+3]=0),g===!0&&(s.fromBufferAttribute(B,G),E[_+Y+4]=s.x,E[_+Y+5]=s.y,E[_+Y+6]=s.z,E[_+Y+7]=0),S===!0&&(s.fromBufferAttribute(H,G),E[_+Y+8]=s.x,E[_+Y+9]=s.y,E[_+Y+10]=s.z,E[_+Y+11]=H.itemSize===4?s.w:1)}}d={count:f,texture:x,size:new Ht(w,C)},n.set(o,d),o.addEventListener("dispose",D)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let m=0;for(let S=0;S<l.length;S++)m+=l[S];let g=o.morphTargetsRelative?1:1-m;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function hm(i,t,e,n,s){let r=new WeakMap;function a(l){let h=s.render.frame,f=l.geometry,d=t.get(l,f);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function o(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var um={[Xo]:"LINEAR_TONE_MAPPING",[Yo]:"REINHARD_TONE_MAPPING",[Zo]:"CINEON_TONE_MAPPING",[qo]:"ACES_FILMIC_TONE_MAPPING",[Ko]:"AGX_TONE_MAPPING",[jo]:"NEUTRAL_TONE_MAPPING",[Jo]:"CUSTOM_TONE_MAPPING"};function dm(i,t,e,n,s,r){let a=new He(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,c=null,l=null,h=new _e;h.setAttribute("position",new te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new te([0,2,0,0,2,0],2));let f=new Or({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new pe(h,f),m=new ws(-1,1,1,-1,0,1),g=null,S=null,p=!1,u,M=null,A=[],w=!1;this.setSize=function(C,E){a.setSize(C,E),o!==null&&o.setSize(C,E),c!==null&&c.setSize(C,E);for(let x=0;x<A.length;x++){let b=A[x];b.setSize&&b.setSize(C,E)}},this.setEffects=function(C){A=C,w=A.length>0&&A[0].isRenderPass===!0;let E=a.width,x=a.height;A.length>0&&o===null&&(o=new He(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}),c=new He(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(D=>D.needsDepthTexture===!0);b!==(a.depthTexture!==null)&&(b===!0&&l===null&&(l=new Ln(E,x),r===!0&&(l.format=Un,l.type=pi)),a.dispose(),a.depthTexture=b?l:null,a.resolveDepthBuffer=b,a.storeMultisampledDepthBuffer=b);for(let D=0;D<A.length;D++){let I=A[D];I.setSize&&I.setSize(E,x),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(l)}},this.begin=function(C,E){if(p||C.toneMapping===vn&&A.length===0)return!1;if(M=E,E!==null){let x=E.width,b=E.height;(a.width!==x||a.height!==b)&&this.setSize(x,b)}return w===!1&&C.setRenderTarget(a),u=C.toneMapping,C.toneMapping=vn,!0},this.hasRenderPass=function(){return w},this.end=function(C,E){C.toneMapping=u,p=!0;let x=a,b=o;for(let D=0;D<A.length;D++){let I=A[D];I.enabled!==!1&&(I.render(C,b,x,E),I.needsSwap!==!1&&(x=b,b=b===o?c:o))}if(g!==C.outputColorSpace||S!==C.toneMapping){g=C.outputColorSpace,S=C.toneMapping,f.defines={},Gt.getTransfer(g)===Zt&&(f.defines.SRGB_TRANSFER="");let D=um[S];D&&(f.defines[D]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(M),C.render(d,m),M=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var Vh=new Oe,Gh=new Ln(1,1),Hh=new fs(1),Wh=new as,Xh=new Lr,Yh=new ds,Sh=[],Mh=[],bh=new Float32Array(16),wh=new Float32Array(9),Th=new Float32Array(4);function Yi(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Sh[s];if(r===void 0&&(r=new Float32Array(s),Sh[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function me(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function ge(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Ha(i,t){let e=Mh[t];e===void 0&&(e=new Int32Array(t),Mh[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function fm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function pm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2fv(this.addr,t),ge(e,t)}}function mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(me(e,t))return;i.uniform3fv(this.addr,t),ge(e,t)}}function gm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4fv(this.addr,t),ge(e,t)}}function xm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;Th.set(n),i.uniformMatrix2fv(this.addr,!1,Th),ge(e,n)}}function vm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;wh.set(n),i.uniformMatrix3fv(this.addr,!1,wh),ge(e,n)}}function ym(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;bh.set(n),i.uniformMatrix4fv(this.addr,!1,bh),ge(e,n)}}function Sm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2iv(this.addr,t),ge(e,t)}}function bm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3iv(this.addr,t),ge(e,t)}}function wm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4iv(this.addr,t),ge(e,t)}}function Tm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Em(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2uiv(this.addr,t),ge(e,t)}}function Am(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3uiv(this.addr,t),ge(e,t)}}function Cm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4uiv(this.addr,t),ge(e,t)}}function Wa(i){return i.version===0&&(i.compareFunction=ll,i.needsUpdate=!0),i}function Rm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Wa(Gh):r=Vh,e.setTexture2D(t||r,s)}function _m(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Xh,s)}function Pm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Wa(Hh):r=Yh,e.setTextureCube(t||r,s)}function Im(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Wh,s)}function Lm(i){switch(i){case 5126:return fm;case 35664:return pm;case 35665:return mm;case 35666:return gm;case 35674:return xm;case 35675:return vm;case 35676:return ym;case 5124:case 35670:return Sm;case 35667:case 35671:return Mm;case 35668:case 35672:return bm;case 35669:case 35673:return wm;case 5125:return Tm;case 36294:return Em;case 36295:return Am;case 36296:return Cm;case 35678:case 36198:case 36298:case 36306:case 35682:return Rm;case 35679:case 36299:case 36307:return _m;case 35680:case 36300:case 36308:case 36293:return Pm;case 36289:case 36303:case 36311:case 36292:return Im}}function Nm(i,t){i.uniform1fv(this.addr,t)}function Dm(i,t){let e=Yi(t,this.size,2);i.uniform2fv(this.addr,e)}function Um(i,t){let e=Yi(t,this.size,3);i.uniform3fv(this.addr,e)}function Fm(i,t){let e=Yi(t,this.size,4);i.uniform4fv(this.addr,e)}function Om(i,t){let e=Yi(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Bm(i,t){let e=Yi(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function zm(i,t){let e=Yi(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function km(i,t){i.uniform1iv(this.addr,t)}function Vm(i,t){i.uniform2iv(this.addr,t)}function Gm(i,t){i.uniform3iv(this.addr,t)}function Hm(i,t){i.uniform4iv(this.addr,t)}function Wm(i,t){i.uniform1uiv(this.addr,t)}function Xm(i,t){i.uniform2uiv(this.addr,t)}function Ym(i,t){i.uniform3uiv(this.addr,t)}function Zm(i,t){i.uniform4uiv(this.addr,t)}function qm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Wa(Gh):a=Vh;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function Jm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||Xh,r[a])}function Km(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Wa(Hh):a=Yh;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function jm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||Wh,r[a])}function Qm(i){switch(i){case 5126:return Nm;case 35664:return Dm;case 35665:return Um;case 35666:return Fm;case 35674:return Om;case 35675:return Bm;case 35676:return zm;case 5124:case 35670:return km;case 35667:case 35671:return Vm;case 35668:case 35672:return Gm;case 35669:case 35673:return Hm;case 5125:return Wm;case 36294:return Xm;case 36295:return Ym;case 36296:return Zm;case 35678:case 36198:case 36298:case 36306:case 35682:return qm;case 35679:case 36299:case 36307:return Jm;case 35680:case 36300:case 36308:case 36293:return Km;case 36289:case 36303:case 36311:case 36292:return jm}}var vl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Lm(e.type)}},yl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Qm(e.type)}},Sl=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],n)}}},gl=/(\w+)(\])?(\[|\.)?/g;function Eh(i,t){i.seq.push(t),i.map[t.id]=t}function $m(i,t,e){let n=i.name,s=n.length;for(gl.lastIndex=0;;){let r=gl.exec(n),a=gl.lastIndex,o=r[1],c=r[2]==="]",l=r[3];if(c&&(o=o|0),l===void 0||l==="["&&a+2===s){Eh(e,l===void 0?new vl(o,i,t):new yl(o,i,t));break}else{let f=e.map[o];f===void 0&&(f=new Sl(o),Eh(e,f)),e=f}}}var Xi=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=t.getActiveUniform(e,a),c=t.getUniformLocation(e,o.name);$m(o,c,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],c=n[o.id];c.needsUpdate!==!1&&o.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&n.push(a)}return n}};function Ah(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var tg=37297,eg=0;function ng(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}var Ch=new Pt;function ig(i){Gt._getMatrix(Ch,Gt.workingColorSpace,i);let t=`mat3( ${Ch.elements.map(e=>e.toFixed(4))} )`;switch(Gt.getTransfer(i)){case ss:return[t,"LinearTransferOETF"];case Zt:return[t,"sRGBTransferOETF"];default:return Ct("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Rh(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+ng(i.getShaderSource(t),o)}else return r}function sg(i,t){let e=ig(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rg={[Xo]:"Linear",[Yo]:"Reinhard",[Zo]:"Cineon",[qo]:"ACESFilmic",[Ko]:"AgX",[jo]:"Neutral",[Jo]:"Custom"};function ag(i,t){let e=rg[t];return e===void 0?(Ct("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ka=new U;function og(){Gt.getLuminanceCoefficients(ka);let i=ka.x.toFixed(4),t=ka.y.toFixed(4),e=ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lg(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fs).join(`
`)}function cg(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function hg(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function Fs(i){return i!==""}function _h(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Ph(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var ug=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ml(i){return i.replace(ug,dg)}function dg(i,t){let e=Bt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Ml(e)}var fg=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ih(i){return i.replace(fg,pg)}function pg(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Lh(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var mg={[As]:"SHADOWMAP_TYPE_PCF",[Vi]:"SHADOWMAP_TYPE_VSM"};function gg(i){return mg[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var xg={[Hi]:"ENVMAP_MODE_REFRACTION"};function vg(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":xg[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yg={[Qr]:"ENVMAP_BLENDING_MULTIPLY",[Jc]:"ENVMAP_BLENDING_MIX",[Kc]:"ENVMAP_BLENDING_ADD"};function Sg(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":yg[i.combine]||"ENVMAP_BLENDING_NONE"}function Mg(i,t,e,n){let s=i.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,c=gg(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=vg(e),f=Sg(e),d=lg(e),m=cg(r),g=s.createProgram(),S,p,u=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(S=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Fs).join(`
`),S.length>0&&(S+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Fs).join(`
`),p.length>0&&(p+=`
`)):(S=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fs).join(`
`),p=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==vn?"#define TONE_MAPPING":"",e.toneMapping!==vn?Bt.tonemapping_pars_fragment:"",e.toneMapping!==vn?ag("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Bt.colorspace_pars_fragment,sg("linearToOutputTexel",e.outputColorSpace),og(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fs).join(`
`)),a=Ml(a),a=_h(a,e),a=Ph(a,e),o=Ml(o),o=_h(o,e),o=Ph(o,e),a=Ih(a),o=Ih(o),e.isRawShaderMaterial!==!0&&(u=`#version 300 es
`,S=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,p=["#define varying in",e.glslVersion===cl?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===cl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let M=u+S+a,A=u+p+o,w=Ah(s,s.VERTEX_SHADER,M),C=Ah(s,s.FRAGMENT_SHADER,A);s.attachShader(g,w),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(I){if(i.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(w)||"",H=s.getShaderInfoLog(C)||"",_=N.trim(),G=B.trim(),Y=H.trim(),V=!0,et=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,w,C);else{let X=Rh(s,w,"vertex"),Q=Rh(s,C,"fragment");_t("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+_+`
`+X+`
`+Q)}else _!==""?Ct("WebGLProgram: Program Info Log:",_):(G===""||Y==="")&&(et=!1);et&&(I.diagnostics={runnable:V,programLog:_,vertexShader:{log:G,prefix:S},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(w),s.deleteShader(C),x=new Xi(s,g),b=hg(s,g)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(g,tg)),D},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=eg++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=w,this.fragmentShader=C,this}var bg=0,bl=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new wl(t),e.set(t,n)),n}},wl=class{constructor(t){this.id=bg++,this.code=t,this.usedTimes=0}};function wg(i){return i===$n||i===Ls||i===Ns}function Tg(i,t,e,n,s,r){let a=new os,o=new bl,c=new Set,l=[],h=new Map,f=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,b,D,I,N,B){let H=I.fog,_=N.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,V=t.get(x.envMap||G,Y),et=d[x.type],X=n.precision;x.precision!==null&&(X=n.getMaxPrecision(x.precision),X!==x.precision&&Ct("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let Q=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,$=Q!==void 0?Q.length:0,Mt=0;_.morphAttributes.position!==void 0&&(Mt=1),_.morphAttributes.normal!==void 0&&(Mt=2),_.morphAttributes.color!==void 0&&(Mt=3);let Lt,J,pt,vt;if(et){let dt=Sn[et];Lt=dt.vertexShader,J=dt.fragmentShader}else{Lt=x.vertexShader,J=x.fragmentShader;let dt=o.getVertexShaderStage(x),Jt=o.getFragmentShaderStage(x);o.update(x,dt,Jt),pt=dt.id,vt=Jt.id}let Et=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),Dt=N.isInstancedMesh===!0,le=N.isBatchedMesh===!0,Rt=!!x.map,qt=!!x.matcap,Kt=!!V,zt=Kt&&V.isPMREMTexture===!0,be=!!x.aoMap,de=!!x.lightMap,Fe=!!x.bumpMap&&x.wireframe===!1,re=!!x.normalMap,un=!!x.displacementMap,xe=!!x.emissiveMap,Ye=!!x.metalnessMap,Ze=!!x.roughnessMap,qe=x.anisotropy>0,L=x.clearcoat>0,Je=x.diffuseRoughness>0,ne=x.dispersion>0,ie=x.retroreflectivity>0,ut=x.iridescence>0,fe=x.sheen>0,At=x.transmission>0,It=qe&&!!x.anisotropyMap,T=L&&!!x.clearcoatMap,v=L&&!!x.clearcoatNormalMap,O=L&&!!x.clearcoatRoughnessMap,tt=Je&&!!x.diffuseRoughnessMap,j=ut&&!!x.iridescenceMap,st=ut&&!!x.iridescenceThicknessMap,ct=fe&&!!x.sheenColorMap,Z=fe&&!!x.sheenRoughnessMap,q=!!x.specularMap,at=!!x.specularColorMap,R=!!x.specularIntensityMap,K=At&&!!x.transmissionMap,W=At&&!!x.thicknessMap,ot=!!x.gradientMap,it=!!x.alphaMap,rt=x.alphaTest>0,wt=!!x.alphaHash,Ot=!!x.extensions,nt=vn;x.toneMapped&&(Et===null||Et.isXRRenderTarget===!0)&&(nt=i.toneMapping);let Tt=zt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Ft={shaderID:et,shaderType:x.type,shaderName:x.name,vertexShader:Lt,fragmentShader:J,defines:x.defines,customVertexShaderID:pt,customFragmentShaderID:vt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:le,batchingColor:le&&N._colorsTexture!==null,instancing:Dt,instancingColor:Dt&&N.instanceColor!==null,instancingMorph:Dt&&N.morphTexture!==null,outputColorSpace:Et===null?i.outputColorSpace:Et.isXRRenderTarget===!0?Et.texture.colorSpace:Gt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Rt,matcap:qt,envMap:Kt,envMapMode:Kt&&V.mapping,envMapPMREM:zt,envMapMaxLod:zt?Tt.length-1:null,envMapSize:zt?Tt[0].width:null,aoMap:be,lightMap:de,bumpMap:Fe,normalMap:re,displacementMap:un,emissiveMap:xe,normalMapObjectSpace:re&&x.normalMapType===$c,normalMapTangentSpace:re&&x.normalMapType===Ba,packedNormalMap:re&&x.normalMapType===Ba&&wg(x.normalMap.format),metalnessMap:Ye,roughnessMap:Ze,anisotropy:qe,anisotropyMap:It,clearcoat:L,clearcoatMap:T,clearcoatNormalMap:v,clearcoatRoughnessMap:O,diffuseRoughness:Je,diffuseRoughnessMap:tt,dispersion:ne,retroreflection:ie,iridescence:ut,iridescenceMap:j,iridescenceThicknessMap:st,sheen:fe,sheenColorMap:ct,sheenRoughnessMap:Z,specularMap:q,specularColorMap:at,specularIntensityMap:R,transmission:At,transmissionMap:K,thicknessMap:W,gradientMap:ot,opaque:x.transparent===!1&&x.blending===Gi&&x.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:wt,combine:x.combine,mapUv:Rt&&m(x.map.channel),aoMapUv:be&&m(x.aoMap.channel),lightMapUv:de&&m(x.lightMap.channel),bumpMapUv:Fe&&m(x.bumpMap.channel),normalMapUv:re&&m(x.normalMap.channel),displacementMapUv:un&&m(x.displacementMap.channel),emissiveMapUv:xe&&m(x.emissiveMap.channel),metalnessMapUv:Ye&&m(x.metalnessMap.channel),roughnessMapUv:Ze&&m(x.roughnessMap.channel),anisotropyMapUv:It&&m(x.anisotropyMap.channel),clearcoatMapUv:T&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:j&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:st&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:Z&&m(x.sheenRoughnessMap.channel),specularMapUv:q&&m(x.specularMap.channel),specularColorMapUv:at&&m(x.specularColorMap.channel),specularIntensityMapUv:R&&m(x.specularIntensityMap.channel),transmissionMapUv:K&&m(x.transmissionMap.channel),thicknessMapUv:W&&m(x.thicknessMap.channel),alphaMapUv:it&&m(x.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(re||qe),vertexNormals:!!_.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!_.attributes.uv&&(Rt||it),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||_.attributes.normal===void 0&&re===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:mt,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:Mt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(dt=>dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Rt&&x.map.isVideoTexture===!0&&Gt.getTransfer(x.map.colorSpace)===Zt,decodeVideoTextureEmissive:xe&&x.emissiveMap.isVideoTexture===!0&&Gt.getTransfer(x.emissiveMap.colorSpace)===Zt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===xn,flipSided:x.side===De,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ot&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ot&&x.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Ft.vertexUv1s=c.has(1),Ft.vertexUv2s=c.has(2),Ft.vertexUv3s=c.has(3),c.clear(),Ft}function S(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let D in x.defines)b.push(D),b.push(x.defines[D]);return x.isRawShaderMaterial===!1&&(p(b,x),u(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function p(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function u(x,b){a.disableAll(),b.instancing&&a.enable(0),b.instancingColor&&a.enable(1),b.instancingMorph&&a.enable(2),b.matcap&&a.enable(3),b.envMap&&a.enable(4),b.normalMapObjectSpace&&a.enable(5),b.normalMapTangentSpace&&a.enable(6),b.clearcoat&&a.enable(7),b.iridescence&&a.enable(8),b.alphaTest&&a.enable(9),b.vertexColors&&a.enable(10),b.vertexAlphas&&a.enable(11),b.vertexUv1s&&a.enable(12),b.vertexUv2s&&a.enable(13),b.vertexUv3s&&a.enable(14),b.vertexTangents&&a.enable(15),b.anisotropy&&a.enable(16),b.alphaHash&&a.enable(17),b.batching&&a.enable(18),b.dispersion&&a.enable(19),b.retroreflection&&a.enable(24),b.diffuseRoughness&&a.enable(25),b.batchingColor&&a.enable(20),b.gradientMap&&a.enable(21),b.packedNormalMap&&a.enable(22),b.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),b.numLightProbeGrids>0&&a.enable(22),b.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function M(x){let b=d[x.type],D;if(b){let I=Sn[b];D=fh.clone(I.uniforms)}else D=x.uniforms;return D}function A(x,b){let D=h.get(b);return D!==void 0?++D.usedTimes:(D=new Mg(i,b,x,s),l.push(D),h.set(b,D)),D}function w(x){if(--x.usedTimes===0){let b=l.indexOf(x);l[b]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){o.remove(x)}function E(){o.dispose()}return{getParameters:g,getProgramCacheKey:S,getUniforms:M,acquireProgram:A,releaseProgram:w,releaseShaderCache:C,programs:l,dispose:E}}function Eg(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,c){i.get(a)[o]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Ag(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Nh(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Dh(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function o(d,m,g,S,p,u){let M=i[t];return M===void 0?(M={id:d.id,object:d,geometry:m,material:g,materialVariant:a(d),groupOrder:S,renderOrder:d.renderOrder,z:p,group:u},i[t]=M):(M.id=d.id,M.object=d,M.geometry=m,M.material=g,M.materialVariant=a(d),M.groupOrder=S,M.renderOrder=d.renderOrder,M.z=p,M.group=u),t++,M}function c(d,m,g,S,p,u,M){M.reversedDepth===!0&&(p=-p);let A=o(d,m,g,S,p,u);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):e.push(A)}function l(d,m,g,S,p,u){let M=o(d,m,g,S,p,u);g.transmission>0?n.unshift(M):g.transparent===!0?s.unshift(M):e.unshift(M)}function h(d,m){e.length>1&&e.sort(d||Ag),n.length>1&&n.sort(m||Nh),s.length>1&&s.sort(m||Nh)}function f(){for(let d=t,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:f,sort:h}}function Cg(){let i=new WeakMap;function t(n,s){let r=i.get(n),a;return r===void 0?(a=new Dh,i.set(n,[a])):s>=r.length?(a=new Dh,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function Rg(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new U,color:new Ut};break;case"SpotLight":e={position:new U,direction:new U,color:new Ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new U,color:new Ut,distance:0,decay:0};break;case"HemisphereLight":e={direction:new U,skyColor:new Ut,groundColor:new Ut};break;case"RectAreaLight":e={color:new Ut,position:new U,halfWidth:new U,halfHeight:new U};break}return i[t.id]=e,e}}}function _g(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Pg=0;function Ig(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Lg(i){let t=new Rg,e=_g(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new U);let s=new U,r=new Qt,a=new Qt;function o(l){let h=0,f=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let m=0,g=0,S=0,p=0,u=0,M=0,A=0,w=0,C=0,E=0,x=0,b=0,D=0,I=0;l.sort(Ig);for(let B=0,H=l.length;B<H;B++){let _=l[B],G=_.color,Y=_.intensity,V=_.distance,et=null;if(_.shadow&&_.shadow.map&&(_.shadow.map.texture.format===$n?et=_.shadow.map.texture:et=_.shadow.map.depthTexture||_.shadow.map.texture),_.isAmbientLight)h+=G.r*Y,f+=G.g*Y,d+=G.b*Y;else if(_.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(_.sh.coefficients[X],Y);I++}else if(_.isSunLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=$,n.sunShadowMap[g]=et;let Mt=Q.getViewportCount();for(let Lt=0;Lt<Mt;Lt++)n.sunShadowMatrix[S+Lt]=Q.getMatrix(Lt),n.sunShadowCascade[S+Lt]=Q._cascadeData[Lt];S+=Mt,g++}n.sun[m]=X,m++}else if(_.isDirectionalLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.directionalShadow[p]=$,n.directionalShadowMap[p]=et,n.directionalShadowMatrix[p]=_.shadow.matrix,C++}n.directional[p]=X,p++}else if(_.isSpotLight){let X=t.get(_);X.position.setFromMatrixPosition(_.matrixWorld),X.color.copy(G).multiplyScalar(Y),X.distance=V,X.coneCos=Math.cos(_.angle),X.penumbraCos=Math.cos(_.angle*(1-_.penumbra)),X.decay=_.decay,n.spot[M]=X;let Q=_.shadow;if(_.map&&(n.spotLightMap[b]=_.map,b++,Q.updateMatrices(_),_.castShadow&&D++),n.spotLightMatrix[M]=Q.matrix,_.castShadow){let $=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.spotShadow[M]=$,n.spotShadowMap[M]=et,x++}M++}else if(_.isRectAreaLight){let X=t.get(_);X.color.copy(G).multiplyScalar(Y),X.halfWidth.set(_.width*.5,0,0),X.halfHeight.set(0,_.height*.5,0),n.rectArea[A]=X,A++}else if(_.isPointLight){let X=t.get(_);if(X.color.copy(_.color).multiplyScalar(_.intensity),X.distance=_.distance,X.decay=_.decay,_.castShadow){let Q=_.shadow,$=e.get(_);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,$.shadowCameraNear=Q.camera.near,$.shadowCameraFar=Q.camera.far,n.pointShadow[u]=$,n.pointShadowMap[u]=et,n.pointShadowMatrix[u]=_.shadow.matrix,E++}n.point[u]=X,u++}else if(_.isHemisphereLight){let X=t.get(_);X.skyColor.copy(_.color).multiplyScalar(Y),X.groundColor.copy(_.groundColor).multiplyScalar(Y),n.hemi[w]=X,w++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=d;let N=n.hash;(N.sunLength!==m||N.directionalLength!==p||N.pointLength!==u||N.spotLength!==M||N.rectAreaLength!==A||N.hemiLength!==w||N.numSunShadows!==g||N.numDirectionalShadows!==C||N.numPointShadows!==E||N.numSpotShadows!==x||N.numSpotMaps!==b||N.numLightProbes!==I)&&(n.sun.length=m,n.directional.length=p,n.spot.length=M,n.rectArea.length=A,n.point.length=u,n.hemi.length=w,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-D,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=I,N.sunLength=m,N.directionalLength=p,N.pointLength=u,N.spotLength=M,N.rectAreaLength=A,N.hemiLength=w,N.numSunShadows=g,N.numDirectionalShadows=C,N.numPointShadows=E,N.numSpotShadows=x,N.numSpotMaps=b,N.numLightProbes=I,n.version=Pg++)}function c(l,h){let f=0,d=0,m=0,g=0,S=0,p=0,u=h.matrixWorldInverse;for(let M=0,A=l.length;M<A;M++){let w=l[M];if(w.isSunLight){let C=n.sun[f];C.direction.setFromMatrixPosition(w.matrixWorld),C.direction.transformDirection(u),f++}else if(w.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(u),d++}else if(w.isSpotLight){let C=n.spot[g];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(u),C.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(u),g++}else if(w.isRectAreaLight){let C=n.rectArea[S];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(u),a.identity(),r.copy(w.matrixWorld),r.premultiply(u),a.extractRotation(r),C.halfWidth.set(w.width*.5,0,0),C.halfHeight.set(0,w.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),S++}else if(w.isPointLight){let C=n.point[m];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(u),m++}else if(w.isHemisphereLight){let C=n.hemi[p];C.direction.setFromMatrixPosition(w.matrixWorld),C.direction.transformDirection(u),p++}}}return{setup:o,setupView:c,state:n}}function Uh(i){let t=new Lg(i),e=[],n=[],s=[];function r(f){h.camera=f,e.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):e.push(f)}function o(f){n.push(f)}function c(){t.setup(e),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function l(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:a,pushShadow:o}}function Ng(i){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new Uh(i),t.set(s,[o])):r>=a.length?(o=new Uh(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}var Dg=`void main() {
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
}`,Fg=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],Og=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],Fh=new Qt,Us=new U,xl=new U;function Bg(i,t,e){let n=new Zn,s=new Ht,r=new Ht,a=new se,o=new Br,c=new zr,l={},h=e.maxTextureSize,f={[Qn]:De,[De]:Qn,[xn]:xn},d=new gn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ht},radius:{value:4}},vertexShader:Dg,fragmentShader:Ug}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new _e;g.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new pe(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=As;let u=this.type;this.render=function(E,x,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===Pc&&(Ct("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=As);let D=i.getRenderTarget(),I=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ui),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let H=u!==this.type;H&&x.traverse(function(_){_.material&&(Array.isArray(_.material)?_.material.forEach(G=>G.needsUpdate=!0):_.material.needsUpdate=!0)});for(let _=0,G=E.length;_<G;_++){let Y=E[_],V=Y.shadow;if(V===void 0){Ct("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let et=V.getFrameExtents();s.multiply(et),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,V.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||H===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Vi){if(Y.isPointLight){Ct("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new He(s.x,s.y,{format:$n,type:ln,minFilter:Ne,magFilter:Ne,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new Ln(s.x,s.y,on),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=_n,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Me,V.map.depthTexture.magFilter=Me}else Y.isPointLight?(V.map=new Os(s.x),V.map.depthTexture=new fs(s.x,an)):(V.map=new He(s.x,s.y),V.map.depthTexture=new Ln(s.x,s.y,an)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=_n,this.type===As?(V.map.depthTexture.compareFunction=X?ol:al,V.map.depthTexture.minFilter=Ne,V.map.depthTexture.magFilter=Ne):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Me,V.map.depthTexture.magFilter=Me);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,b);let $=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let Mt=0;Mt<Q;Mt++){let Lt=V.getCamera(Mt);if(Y.isPointLight){let J=V.camera,pt=V.matrix,vt=Y.distance||J.far;vt!==J.far&&(J.far=vt,J.updateProjectionMatrix()),Us.setFromMatrixPosition(Y.matrixWorld),J.position.copy(Us),xl.copy(J.position),xl.add(Fg[Mt]),J.up.copy(Og[Mt]),J.lookAt(xl),J.updateMatrixWorld(),pt.makeTranslation(-Us.x,-Us.y,-Us.z),Fh.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Fh,J.coordinateSystem,J.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,Mt),i.clear();else{Mt===0&&(i.setRenderTarget(V.map),i.clear());let J=V.getViewport(Mt);a.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),B.viewport(a)}n=V.getFrustum(Mt),w(x,b,Lt,Y,$,this.type)}V.isPointLightShadow!==!0&&this.type===Vi&&M(V,b),V.needsUpdate=!1}u=this.type,p.needsUpdate=!1,i.setRenderTarget(D,I,N)};function M(E,x){let b=t.update(S);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null?E.mapPass=new He(s.x,s.y,{format:$n,type:ln}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,d,S,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value.set(E.map.width,E.map.height),m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,m,S,null)}function A(E,x,b,D){let I=null,N=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(N!==void 0)I=N;else if(I=b.isPointLight===!0?c:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=I.uuid,H=x.uuid,_=l[B];_===void 0&&(_={},l[B]=_);let G=_[H];G===void 0&&(G=I.clone(),_[H]=G,x.addEventListener("dispose",C)),I=G}if(I.visible=x.visible,I.wireframe=x.wireframe,D===Vi?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:f[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=i.properties.get(I);B.light=b}return I}function w(E,x,b,D,I,N){if(E.visible===!1)return;if(E.layers.test(I)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&N===Vi)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let _=t.update(E),G=E.material;if(Array.isArray(G)){let Y=_.groups;for(let V=0,et=Y.length;V<et;V++){let X=Y[V],Q=G[X.materialIndex];if(Q&&Q.visible){let $=A(E,Q,D,N);E.onBeforeShadow(i,E,x,b,_,$,X),i.renderBufferDirect(b,null,_,$,E,X),E.onAfterShadow(i,E,x,b,_,$,X)}}}else if(G.visible){let Y=A(E,G,D,N);E.onBeforeShadow(i,E,x,b,_,Y,null),i.renderBufferDirect(b,null,_,Y,E,null),E.onAfterShadow(i,E,x,b,_,Y,null)}}let H=E.children;for(let _=0,G=H.length;_<G;_++)w(H[_],x,b,D,I,N)}function C(E){E.target.removeEventListener("dispose",C);for(let b in l){let D=l[b],I=E.target.uuid;I in D&&(D[I].dispose(),delete D[I])}}}function zg(i,t){function e(){let R=!1,K=new se,W=null,ot=new se(0,0,0,0);return{setMask:function(it){W!==it&&!R&&(i.colorMask(it,it,it,it),W=it)},setLocked:function(it){R=it},setClear:function(it,rt,wt,Ot,nt){nt===!0&&(it*=Ot,rt*=Ot,wt*=Ot),K.set(it,rt,wt,Ot),ot.equals(K)===!1&&(i.clearColor(it,rt,wt,Ot),ot.copy(K))},reset:function(){R=!1,W=null,ot.set(-1,0,0,0)}}}function n(){let R=!1,K=!1,W=null,ot=null,it=null;return{setReversed:function(rt){if(K!==rt){let wt=t.get("EXT_clip_control");rt?wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.ZERO_TO_ONE_EXT):wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.NEGATIVE_ONE_TO_ONE_EXT),K=rt;let Ot=it;it=null,this.setClear(Ot)}},getReversed:function(){return K},setTest:function(rt){rt?mt(i.DEPTH_TEST):Dt(i.DEPTH_TEST)},setMask:function(rt){W!==rt&&!R&&(i.depthMask(rt),W=rt)},setFunc:function(rt){if(K&&(rt=hh[rt]),ot!==rt){switch(rt){case yr:i.depthFunc(i.NEVER);break;case Sr:i.depthFunc(i.ALWAYS);break;case Mr:i.depthFunc(i.LESS);break;case Ii:i.depthFunc(i.LEQUAL);break;case br:i.depthFunc(i.EQUAL);break;case wr:i.depthFunc(i.GEQUAL);break;case Tr:i.depthFunc(i.GREATER);break;case Er:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ot=rt}},setLocked:function(rt){R=rt},setClear:function(rt){it!==rt&&(it=rt,K&&(rt=1-rt),i.clearDepth(rt))},reset:function(){R=!1,W=null,ot=null,it=null,K=!1}}}function s(){let R=!1,K=null,W=null,ot=null,it=null,rt=null,wt=null,Ot=null,nt=null;return{setTest:function(Tt){R||(Tt?mt(i.STENCIL_TEST):Dt(i.STENCIL_TEST))},setMask:function(Tt){K!==Tt&&!R&&(i.stencilMask(Tt),K=Tt)},setFunc:function(Tt,Ft,dt){(W!==Tt||ot!==Ft||it!==dt)&&(i.stencilFunc(Tt,Ft,dt),W=Tt,ot=Ft,it=dt)},setOp:function(Tt,Ft,dt){(rt!==Tt||wt!==Ft||Ot!==dt)&&(i.stencilOp(Tt,Ft,dt),rt=Tt,wt=Ft,Ot=dt)},setLocked:function(Tt){R=Tt},setClear:function(Tt){nt!==Tt&&(i.clearStencil(Tt),nt=Tt)},reset:function(){R=!1,K=null,W=null,ot=null,it=null,rt=null,wt=null,Ot=null,nt=null}}}let r=new e,a=new n,o=new s,c={},l=new WeakMap,h={},f={},d={},m=new WeakMap,g=[],S=null,p=!1,u=null,M=null,A=null,w=null,C=null,E=null,x=null,b=new Ut(0,0,0),D=0,I=!1,N=null,B=null,H=null,_=null,G=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,et=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=et>=1):X.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=et>=2);let Q=null,$={},Mt=i.getParameter(i.SCISSOR_BOX),Lt=i.getParameter(i.VIEWPORT),J=new se().fromArray(Mt),pt=new se().fromArray(Lt);function vt(R,K,W,ot){let it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(R,rt),i.texParameteri(R,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(R,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let wt=0;wt<W;wt++)R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,ot,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+wt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}let Et={};Et[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Et[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Et[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Et[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),mt(i.DEPTH_TEST),a.setFunc(Ii),Fe(!1),re(zo),mt(i.CULL_FACE),be(ui);function mt(R){h[R]!==!0&&(i.enable(R),h[R]=!0)}function Dt(R){h[R]!==!1&&(i.disable(R),h[R]=!1)}function le(R,K){return d[R]!==K?(i.bindFramebuffer(R,K),d[R]=K,R===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),R===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Rt(R,K){let W=g,ot=!1;if(R){W=m.get(K),W===void 0&&(W=[],m.set(K,W));let it=R.textures;if(W.length!==it.length||W[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,wt=it.length;rt<wt;rt++)W[rt]=i.COLOR_ATTACHMENT0+rt;W.length=it.length,ot=!0}}else W[0]!==i.BACK&&(W[0]=i.BACK,ot=!0);ot&&i.drawBuffers(W)}function qt(R){return S!==R?(i.useProgram(R),S=R,!0):!1}let Kt={[di]:i.FUNC_ADD,[Lc]:i.FUNC_SUBTRACT,[Nc]:i.FUNC_REVERSE_SUBTRACT};Kt[Dc]=i.MIN,Kt[Uc]=i.MAX;let zt={[Fc]:i.ZERO,[Oc]:i.ONE,[Bc]:i.SRC_COLOR,[Ho]:i.SRC_ALPHA,[Wc]:i.SRC_ALPHA_SATURATE,[Gc]:i.DST_COLOR,[kc]:i.DST_ALPHA,[zc]:i.ONE_MINUS_SRC_COLOR,[Wo]:i.ONE_MINUS_SRC_ALPHA,[Hc]:i.ONE_MINUS_DST_COLOR,[Vc]:i.ONE_MINUS_DST_ALPHA,[Xc]:i.CONSTANT_COLOR,[Yc]:i.ONE_MINUS_CONSTANT_COLOR,[Zc]:i.CONSTANT_ALPHA,[qc]:i.ONE_MINUS_CONSTANT_ALPHA};function be(R,K,W,ot,it,rt,wt,Ot,nt,Tt){if(R===ui){p===!0&&(Dt(i.BLEND),p=!1);return}if(p===!1&&(mt(i.BLEND),p=!0),R!==Ic){if(R!==u||Tt!==I){if((M!==di||C!==di)&&(i.blendEquation(i.FUNC_ADD),M=di,C=di),Tt)switch(R){case Gi:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFunc(i.ONE,i.ONE);break;case Vo:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Go:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:_t("WebGLState: Invalid blending: ",R);break}else switch(R){case Gi:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Vo:_t("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Go:_t("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:_t("WebGLState: Invalid blending: ",R);break}A=null,w=null,E=null,x=null,b.set(0,0,0),D=0,u=R,I=Tt}return}it=it||K,rt=rt||W,wt=wt||ot,(K!==M||it!==C)&&(i.blendEquationSeparate(Kt[K],Kt[it]),M=K,C=it),(W!==A||ot!==w||rt!==E||wt!==x)&&(i.blendFuncSeparate(zt[W],zt[ot],zt[rt],zt[wt]),A=W,w=ot,E=rt,x=wt),(Ot.equals(b)===!1||nt!==D)&&(i.blendColor(Ot.r,Ot.g,Ot.b,nt),b.copy(Ot),D=nt),u=R,I=!1}function de(R,K){R.side===xn?Dt(i.CULL_FACE):mt(i.CULL_FACE);let W=R.side===De;K&&(W=!W),Fe(W),R.blending===Gi&&R.transparent===!1?be(ui):be(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),a.setFunc(R.depthFunc),a.setTest(R.depthTest),a.setMask(R.depthWrite),r.setMask(R.colorWrite);let ot=R.stencilWrite;o.setTest(ot),ot&&(o.setMask(R.stencilWriteMask),o.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),o.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),xe(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?mt(i.SAMPLE_ALPHA_TO_COVERAGE):Dt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Fe(R){N!==R&&(R?i.frontFace(i.CW):i.frontFace(i.CCW),N=R)}function re(R){R!==Rc?(mt(i.CULL_FACE),R!==B&&(R===zo?i.cullFace(i.BACK):R===_c?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Dt(i.CULL_FACE),B=R}function un(R){R!==H&&(V&&i.lineWidth(R),H=R)}function xe(R,K,W){R?(mt(i.POLYGON_OFFSET_FILL),(_!==K||G!==W)&&(_=K,G=W,a.getReversed()&&(K=-K,W=-W),i.polygonOffset(K,W))):Dt(i.POLYGON_OFFSET_FILL)}function Ye(R){R?mt(i.SCISSOR_TEST):Dt(i.SCISSOR_TEST)}function Ze(R){R===void 0&&(R=i.TEXTURE0+Y-1),Q!==R&&(i.activeTexture(R),Q=R)}function qe(R,K,W){W===void 0&&(Q===null?W=i.TEXTURE0+Y-1:W=Q);let ot=$[W];ot===void 0&&(ot={type:void 0,texture:void 0},$[W]=ot),(ot.type!==R||ot.texture!==K)&&(Q!==W&&(i.activeTexture(W),Q=W),i.bindTexture(R,K||Et[R]),ot.type=R,ot.texture=K)}function L(){let R=$[Q];R!==void 0&&R.type!==void 0&&(i.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function Je(){try{i.compressedTexImage2D(...arguments)}catch(R){_t("WebGLState:",R)}}function ne(){try{i.compressedTexImage3D(...arguments)}catch(R){_t("WebGLState:",R)}}function ie(){try{i.texSubImage2D(...arguments)}catch(R){_t("WebGLState:",R)}}function ut(){try{i.texSubImage3D(...arguments)}catch(R){_t("WebGLState:",R)}}function fe(){try{i.compressedTexSubImage2D(...arguments)}catch(R){_t("WebGLState:",R)}}function At(){try{i.compressedTexSubImage3D(...arguments)}catch(R){_t("WebGLState:",R)}}function It(){try{i.texStorage2D(...arguments)}catch(R){_t("WebGLState:",R)}}function T(){try{i.texStorage3D(...arguments)}catch(R){_t("WebGLState:",R)}}function v(){try{i.texImage2D(...arguments)}catch(R){_t("WebGLState:",R)}}function O(){try{i.texImage3D(...arguments)}catch(R){_t("WebGLState:",R)}}function tt(R){return f[R]!==void 0?f[R]:i.getParameter(R)}function j(R,K){f[R]!==K&&(i.pixelStorei(R,K),f[R]=K)}function st(R){J.equals(R)===!1&&(i.scissor(R.x,R.y,R.z,R.w),J.copy(R))}function ct(R){pt.equals(R)===!1&&(i.viewport(R.x,R.y,R.z,R.w),pt.copy(R))}function Z(R,K){let W=l.get(K);W===void 0&&(W=new WeakMap,l.set(K,W));let ot=W.get(R);ot===void 0&&(ot=i.getUniformBlockIndex(K,R.name),i.uniformBlockBinding(K,ot,ot),W.set(R,ot))}function q(R,K,W){let it=l.get(K).get(R);c[it]!==W&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,W),c[it]=W)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,$={},d={},c={},m=new WeakMap,g=[],S=null,p=!1,u=null,M=null,A=null,w=null,C=null,E=null,x=null,b=new Ut(0,0,0),D=0,I=!1,N=null,B=null,H=null,_=null,G=null,J.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:mt,disable:Dt,bindFramebuffer:le,drawBuffers:Rt,useProgram:qt,setBlending:be,setMaterial:de,setFlipSided:Fe,setCullFace:re,setLineWidth:un,setPolygonOffset:xe,setScissorTest:Ye,activeTexture:Ze,bindTexture:qe,unbindTexture:L,compressedTexImage2D:Je,compressedTexImage3D:ne,texImage2D:v,texImage3D:O,pixelStorei:j,getParameter:tt,updateUBOMapping:Z,uniformBlockBinding:q,texStorage2D:It,texStorage3D:T,texSubImage2D:ie,texSubImage3D:ut,compressedTexSubImage2D:fe,compressedTexSubImage3D:At,scissor:st,viewport:ct,reset:at}}function kg(i,t,e,n,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ht,h=new WeakMap,f=new Set,d,m=new WeakMap,g=new Set,S=new FinalizationRegistry(T=>g.delete(T)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function u(T,v){return p?new OffscreenCanvas(T,v):rs("canvas")}function M(T,v,O){let tt=1,j=It(T);if((j.width>O||j.height>O)&&(tt=O/Math.max(j.width,j.height)),tt<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let st=Math.floor(tt*j.width),ct=Math.floor(tt*j.height);d===void 0&&(d=u(st,ct));let Z=v?u(st,ct):d;return Z.width=st,Z.height=ct,Z.getContext("2d").drawImage(T,0,0,st,ct),Ct("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+st+"x"+ct+")."),Z}else return"data"in T&&Ct("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),T;return T}function A(T){return T.generateMipmaps}function w(T){i.generateMipmap(T)}function C(T){return T.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?i.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(T,v,O,tt,j,st=!1){if(T!==null){if(i[T]!==void 0)return i[T];Ct("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||Ct("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=v;if(v===i.RED&&(O===i.FLOAT&&(Z=i.R32F),O===i.HALF_FLOAT&&(Z=i.R16F),O===i.UNSIGNED_BYTE&&(Z=i.R8),O===i.UNSIGNED_SHORT&&ct&&(Z=ct.R16_EXT),O===i.SHORT&&ct&&(Z=ct.R16_SNORM_EXT)),v===i.RED_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.R8UI),O===i.UNSIGNED_SHORT&&(Z=i.R16UI),O===i.UNSIGNED_INT&&(Z=i.R32UI),O===i.BYTE&&(Z=i.R8I),O===i.SHORT&&(Z=i.R16I),O===i.INT&&(Z=i.R32I)),v===i.RG&&(O===i.FLOAT&&(Z=i.RG32F),O===i.HALF_FLOAT&&(Z=i.RG16F),O===i.UNSIGNED_BYTE&&(Z=i.RG8),O===i.UNSIGNED_SHORT&&ct&&(Z=ct.RG16_EXT),O===i.SHORT&&ct&&(Z=ct.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RG8UI),O===i.UNSIGNED_SHORT&&(Z=i.RG16UI),O===i.UNSIGNED_INT&&(Z=i.RG32UI),O===i.BYTE&&(Z=i.RG8I),O===i.SHORT&&(Z=i.RG16I),O===i.INT&&(Z=i.RG32I)),v===i.RGB_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),O===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),O===i.UNSIGNED_INT&&(Z=i.RGB32UI),O===i.BYTE&&(Z=i.RGB8I),O===i.SHORT&&(Z=i.RGB16I),O===i.INT&&(Z=i.RGB32I)),v===i.RGBA_INTEGER&&(O===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),O===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),O===i.UNSIGNED_INT&&(Z=i.RGBA32UI),O===i.BYTE&&(Z=i.RGBA8I),O===i.SHORT&&(Z=i.RGBA16I),O===i.INT&&(Z=i.RGBA32I)),v===i.RGB&&(O===i.UNSIGNED_SHORT&&ct&&(Z=ct.RGB16_EXT),O===i.SHORT&&ct&&(Z=ct.RGB16_SNORM_EXT),O===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),O===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),v===i.RGBA){let q=st?ss:Gt.getTransfer(j);O===i.FLOAT&&(Z=i.RGBA32F),O===i.HALF_FLOAT&&(Z=i.RGBA16F),O===i.UNSIGNED_BYTE&&(Z=q===Zt?i.SRGB8_ALPHA8:i.RGBA8),O===i.UNSIGNED_SHORT&&ct&&(Z=ct.RGBA16_EXT),O===i.SHORT&&ct&&(Z=ct.RGBA16_SNORM_EXT),O===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),O===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Z}function x(T,v){let O;return T?v===null||v===an||v===pi?O=i.DEPTH24_STENCIL8:v===on?O=i.DEPTH32F_STENCIL8:v===Wi&&(O=i.DEPTH24_STENCIL8,Ct("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===an||v===pi?O=i.DEPTH_COMPONENT24:v===on?O=i.DEPTH_COMPONENT32F:v===Wi&&(O=i.DEPTH_COMPONENT16),O}function b(T,v){return A(T)===!0||T.isFramebufferTexture&&T.minFilter!==Me&&T.minFilter!==Ne?Math.log2(Math.max(v.width,v.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?v.mipmaps.length:1}function D(T){let v=new WeakRef(T);n.get(T).__ref=v,g.add(v),S.register(T,v,v)}function I(T){let v=n.get(T).__ref;v!==void 0&&(g.delete(v),S.unregister(v))}function N(T){H(T.target)}function B(T){_(T.target)}function H(T){T.removeEventListener("dispose",N),I(T),Y(T),T.isVideoTexture&&h.delete(T),T.isHTMLTexture&&f.delete(T)}function _(T){T.removeEventListener("dispose",B),I(T),et(T)}function G(){for(let T of g){let v=T.deref();v!==void 0&&(v.isRenderTarget===!0?_(v):H(v))}g.clear(),f.clear()}function Y(T){let v=n.get(T);if(v.__webglInit===void 0)return;let O=T.source,tt=m.get(O);if(tt){let j=tt[v.__cacheKey];j.usedTimes--,j.usedTimes===0&&V(T),Object.keys(tt).length===0&&m.delete(O)}n.remove(T)}function V(T){let v=n.get(T);i.deleteTexture(v.__webglTexture);let O=T.source,tt=m.get(O);delete tt[v.__cacheKey],a.memory.textures--}function et(T){let v=n.get(T);v.__depthDisposeCallback&&v.__depthDisposeCallback();let O=T.depthTexture;if(O&&O.renderTarget===T&&H(O),T.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(v.__webglFramebuffer[j]))for(let st=0;st<v.__webglFramebuffer[j].length;st++)i.deleteFramebuffer(v.__webglFramebuffer[j][st]);else i.deleteFramebuffer(v.__webglFramebuffer[j]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[j])}else{if(Array.isArray(v.__webglFramebuffer))for(let j=0;j<v.__webglFramebuffer.length;j++)i.deleteFramebuffer(v.__webglFramebuffer[j]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let j=0;j<v.__webglColorRenderbuffer.length;j++)v.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[j]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let tt=T.textures;for(let j=0,st=tt.length;j<st;j++){let ct=n.get(tt[j]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),a.memory.textures--),n.remove(tt[j])}n.remove(T)}let X=0;function Q(){X=0}function $(){return X}function Mt(T){X=T}function Lt(){let T=X;return T>=s.maxTextures&&Ct("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,T}function J(T){let v=[];return v.push(T.wrapS),v.push(T.wrapT),v.push(T.wrapR||0),v.push(T.magFilter),v.push(T.minFilter),v.push(T.anisotropy),v.push(T.internalFormat),v.push(T.format),v.push(T.type),v.push(T.generateMipmaps),v.push(T.mipmapsAutoUpdate),v.push(T.premultiplyAlpha),v.push(T.flipY),v.push(T.unpackAlignment),v.push(T.colorSpace),v.join()}function pt(T,v){let O=n.get(T);if(T.isVideoTexture&&fe(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&O.__version!==T.version){let tt=T.image;if(tt===null)Ct("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)Ct("WebGLRenderer: Texture marked for update but image is incomplete");else{de(O,T,v);return}}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,O.__webglTexture,i.TEXTURE0+v)}function vt(T,v){let O=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){de(O,T,v);return}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,O.__webglTexture,i.TEXTURE0+v)}function Et(T,v){let O=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){de(O,T,v);return}e.bindTexture(i.TEXTURE_3D,O.__webglTexture,i.TEXTURE0+v)}function mt(T,v){let O=n.get(T);if(T.version>0&&O.__version!==T.version){Fe(O,T,v);return}e.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+v)}let Dt={[Ar]:i.REPEAT,[fn]:i.CLAMP_TO_EDGE,[Cr]:i.MIRRORED_REPEAT},le={[Me]:i.NEAREST,[jc]:i.NEAREST_MIPMAP_NEAREST,[Cs]:i.NEAREST_MIPMAP_LINEAR,[Ne]:i.LINEAR,[ea]:i.LINEAR_MIPMAP_NEAREST,[Dn]:i.LINEAR_MIPMAP_LINEAR},Rt={[eh]:i.NEVER,[ll]:i.ALWAYS,[nh]:i.LESS,[al]:i.LEQUAL,[ih]:i.EQUAL,[ol]:i.GEQUAL,[sh]:i.GREATER,[rh]:i.NOTEQUAL};function qt(T,v){if(v.type===on&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===Ne||v.magFilter===ea||v.magFilter===Cs||v.magFilter===Dn||v.minFilter===Ne||v.minFilter===ea||v.minFilter===Cs||v.minFilter===Dn)&&Ct("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(T,i.TEXTURE_WRAP_S,Dt[v.wrapS]),i.texParameteri(T,i.TEXTURE_WRAP_T,Dt[v.wrapT]),(T===i.TEXTURE_3D||T===i.TEXTURE_2D_ARRAY)&&i.texParameteri(T,i.TEXTURE_WRAP_R,Dt[v.wrapR]),i.texParameteri(T,i.TEXTURE_MAG_FILTER,le[v.magFilter]),i.texParameteri(T,i.TEXTURE_MIN_FILTER,le[v.minFilter]),v.compareFunction&&(i.texParameteri(T,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(T,i.TEXTURE_COMPARE_FUNC,Rt[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Me||v.minFilter!==Cs&&v.minFilter!==Dn||v.type===on&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");i.texParameterf(T,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function Kt(T,v){let O=!1;T.__webglInit===void 0&&(T.__webglInit=!0,v.addEventListener("dispose",N),D(v));let tt=v.source,j=m.get(tt);j===void 0&&(j={},m.set(tt,j));let st=J(v);if(st!==T.__cacheKey){j[st]===void 0&&(j[st]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,O=!0),j[st].usedTimes++;let ct=j[T.__cacheKey];ct!==void 0&&(j[T.__cacheKey].usedTimes--,ct.usedTimes===0&&V(v)),T.__cacheKey=st,T.__webglTexture=j[st].texture}return O}function zt(T,v,O){return Math.floor(Math.floor(T/O)/v)}function be(T,v,O,tt){let st=T.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,O,tt,v.data);else{st.sort((R,K)=>R.start-K.start);let ct=0;for(let R=1;R<st.length;R++){let K=st[ct],W=st[R],ot=K.start+K.count,it=zt(W.start,v.width,4),rt=zt(K.start,v.width,4);W.start<=ot+1&&it===rt&&zt(W.start+W.count-1,v.width,4)===it?K.count=Math.max(K.count,W.start+W.count-K.start):(++ct,st[ct]=W)}st.length=ct+1;let Z=e.getParameter(i.UNPACK_ROW_LENGTH),q=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let R=0,K=st.length;R<K;R++){let W=st[R],ot=Math.floor(W.start/4),it=Math.ceil(W.count/4),rt=ot%v.width,wt=Math.floor(ot/v.width),Ot=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,wt),e.texSubImage2D(i.TEXTURE_2D,0,rt,wt,Ot,nt,O,tt,v.data)}T.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Z),e.pixelStorei(i.UNPACK_SKIP_PIXELS,q),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function de(T,v,O){let tt=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(tt=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(tt=i.TEXTURE_3D);let j=Kt(T,v),st=v.source;e.bindTexture(tt,T.__webglTexture,i.TEXTURE0+O);let ct=n.get(st);if(st.version!==ct.__version||j===!0){if(e.activeTexture(i.TEXTURE0+O),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let nt=Gt.getPrimaries(Gt.workingColorSpace),Tt=v.colorSpace===Fn?null:Gt.getPrimaries(v.colorSpace),Ft=v.colorSpace===Fn||nt===Tt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ft)}e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let q=M(v.image,!1,s.maxTextureSize);q=At(v,q);let at=r.convert(v.format,v.colorSpace),R=r.convert(v.type),K=E(v.internalFormat,at,R,v.normalized,v.colorSpace,v.isVideoTexture);qt(tt,v);let W,ot=v.mipmaps,it=v.isVideoTexture!==!0,rt=ct.__version===void 0||j===!0,wt=st.dataReady,Ot=b(v,q);if(v.isDepthTexture)K=x(v.format===Un,v.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,q.width,q.height):e.texImage2D(i.TEXTURE_2D,0,K,q.width,q.height,0,at,R,null));else if(v.isDataTexture)if(ot.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,R,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,R,W.data);v.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,q.width,q.height),wt&&be(v,q,at,R)):e.texImage2D(i.TEXTURE_2D,0,K,q.width,q.height,0,at,R,q.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,ot[0].width,ot[0].height,q.depth);for(let nt=0,Tt=ot.length;nt<Tt;nt++)if(W=ot[nt],v.format!==cn)if(at!==null)if(it){if(wt)if(v.layerUpdates.size>0){let Ft=ml(W.width,W.height,v.format,v.type);for(let dt of v.layerUpdates){let Jt=W.data.subarray(dt*Ft/W.data.BYTES_PER_ELEMENT,(dt+1)*Ft/W.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,dt,W.width,W.height,1,at,Jt)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,q.depth,at,W.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,q.depth,0,W.data,0,0);else Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,q.depth,at,R,W.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,q.depth,0,at,R,W.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],v.format!==cn?at!==null?it?wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,W.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,W.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,R,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,R,W.data)}else if(v.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,q.width,q.height,q.depth),wt)if(v.layerUpdates.size>0){let nt=ml(q.width,q.height,v.format,v.type);for(let Tt of v.layerUpdates){let Ft=q.data.subarray(Tt*nt/q.data.BYTES_PER_ELEMENT,(Tt+1)*nt/q.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Tt,q.width,q.height,1,at,R,Ft)}v.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,q.width,q.height,q.depth,at,R,q.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,q.width,q.height,q.depth,0,at,R,q.data);else if(v.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Ot,K,q.width,q.height,q.depth),wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,q.width,q.height,q.depth,at,R,q.data)):e.texImage3D(i.TEXTURE_3D,0,K,q.width,q.height,q.depth,0,at,R,q.data);else if(v.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Ot,K,q.width,q.height);else{let nt=q.width,Tt=q.height;for(let Ft=0;Ft<Ot;Ft++)e.texImage2D(i.TEXTURE_2D,Ft,K,nt,Tt,0,at,R,null),nt>>=1,Tt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){let nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),q.parentNode!==nt){nt.appendChild(q),f.add(v),nt.onpaint=Tt=>{let Ft=Tt.changedElements;for(let dt of f)Ft.includes(dt.image)&&(dt.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,q);else{let Ft=i.RGBA,dt=i.RGBA,Jt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ft,dt,Jt,q)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ot.length>0){if(it&&rt){let nt=It(ot[0]);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,at,R,W):e.texImage2D(i.TEXTURE_2D,nt,K,at,R,W);v.generateMipmaps=!1}else if(it){if(rt){let nt=It(q);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,R,q)}else e.texImage2D(i.TEXTURE_2D,0,K,at,R,q);A(v)&&v.mipmapsAutoUpdate===!0&&w(tt),ct.__version=st.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function Fe(T,v,O){if(v.image.length!==6)return;let tt=Kt(T,v),j=v.source;e.bindTexture(i.TEXTURE_CUBE_MAP,T.__webglTexture,i.TEXTURE0+O);let st=n.get(j);if(j.version!==st.__version||tt===!0){e.activeTexture(i.TEXTURE0+O);let ct=Gt.getPrimaries(Gt.workingColorSpace),Z=v.colorSpace===Fn?null:Gt.getPrimaries(v.colorSpace),q=v.colorSpace===Fn||ct===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,q);let at=v.isCompressedTexture||v.image[0].isCompressedTexture,R=v.image[0]&&v.image[0].isDataTexture,K=[];for(let dt=0;dt<6;dt++)!at&&!R?K[dt]=M(v.image[dt],!0,s.maxCubemapSize):K[dt]=R?v.image[dt].image:v.image[dt],K[dt]=At(v,K[dt]);let W=K[0],ot=r.convert(v.format,v.colorSpace),it=r.convert(v.type),rt=E(v.internalFormat,ot,it,v.normalized,v.colorSpace),wt=v.isVideoTexture!==!0,Ot=st.__version===void 0||tt===!0,nt=j.dataReady,Tt=b(v,W);qt(i.TEXTURE_CUBE_MAP,v);let Ft;if(v.isDepthTexture){if(rt=x(v.format===Un,v.type),Ot)if(wt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,W.width,W.height);else for(let dt=0;dt<6;dt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,W.width,W.height,0,ot,it,null)}else if(at){wt&&Ot&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,W.width,W.height);for(let dt=0;dt<6;dt++){Ft=K[dt].mipmaps;for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];v.format!==cn?ot!==null?wt?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,ve.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ve.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,it,ve.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ot,it,ve.data)}}}else{if(Ft=v.mipmaps,wt&&Ot){Ft.length>0&&Tt++;let dt=It(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,dt.width,dt.height)}for(let dt=0;dt<6;dt++)if(R){wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,K[dt].width,K[dt].height,ot,it,K[dt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,K[dt].width,K[dt].height,0,ot,it,K[dt].data);for(let Jt=0;Jt<Ft.length;Jt++){let Bn=Ft[Jt].image[dt].image;wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,Bn.width,Bn.height,ot,it,Bn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,Bn.width,Bn.height,0,ot,it,Bn.data)}}else{wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,ot,it,K[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,ot,it,K[dt]);for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,ot,it,ve.image[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,ot,it,ve.image[dt])}}}A(v)&&v.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),st.__version=j.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function re(T,v,O,tt,j,st){let ct=r.convert(O.format,O.colorSpace),Z=r.convert(O.type),q=E(O.internalFormat,ct,Z,O.normalized,O.colorSpace),at=n.get(v),R=n.get(O);if(R.__renderTarget=v,!at.__hasExternalTextures){let K=Math.max(1,v.width>>st),W=Math.max(1,v.height>>st);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,st,q,K,W,v.depth,0,ct,Z,null):e.texImage2D(j,st,q,K,W,0,ct,Z,null)}e.bindFramebuffer(i.FRAMEBUFFER,T),ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,tt,j,R.__webglTexture,0,ie(v)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,tt,j,R.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function un(T,v,O){if(i.bindRenderbuffer(i.RENDERBUFFER,T),v.depthBuffer){let tt=v.depthTexture,j=tt&&tt.isDepthTexture?tt.type:null,st=x(v.stencilBuffer,j),ct=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),st,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),st,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,st,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,T)}else{let tt=v.textures;for(let j=0;j<tt.length;j++){let st=tt[j],ct=r.convert(st.format,st.colorSpace),Z=r.convert(st.type),q=E(st.internalFormat,ct,Z,st.normalized,st.colorSpace);ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),q,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),q,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,q,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(T,v,O){let tt=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,T),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(v.depthTexture);j.__renderTarget=v;let st=tt?v.depthTexture.image[0]:v.depthTexture.image;(!j.__webglTexture||st.width!==v.width||st.height!==v.height)&&(st.width=v.width,st.height=v.height,v.depthTexture.needsUpdate=!0),tt?mt(v.depthTexture,0):pt(v.depthTexture,0);let ct=j.__webglTexture,Z=ie(v),q=tt?i.TEXTURE_CUBE_MAP_POSITIVE_X+O:i.TEXTURE_2D,at=v.depthTexture.format===Un?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===_n)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,q,ct,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,at,q,ct,0);else if(v.depthTexture.format===Un)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,q,ct,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,at,q,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ye(T){let v=n.get(T),O=T.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==T.depthTexture){let tt=T.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),tt){let j=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,tt.removeEventListener("dispose",j)};tt.addEventListener("dispose",j),v.__depthDisposeCallback=j}v.__boundDepthTexture=tt}if(T.depthTexture&&!v.__autoAllocateDepthBuffer)if(O)for(let tt=0;tt<6;tt++)xe(v.__webglFramebuffer[tt],T,tt);else T.texture.mipmaps.length>0?xe(v.__webglFramebuffer[0],T,0):xe(v.__webglFramebuffer,T,0);else if(O){v.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[tt]),v.__webglDepthbuffer[tt]===void 0)v.__webglDepthbuffer[tt]=i.createRenderbuffer(),un(v.__webglDepthbuffer[tt],T,!1);else{let j=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer[tt];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}}else if(T.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),un(v.__webglDepthbuffer,T,!1);else{let j=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ze(T,v,O){let tt=n.get(T);v!==void 0&&re(tt.__webglFramebuffer,T,T.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),O!==void 0&&Ye(T)}function qe(T){let v=T.texture,O=n.get(T),tt=n.get(v);T.addEventListener("dispose",B),D(T);let j=T.textures,st=T.isWebGLCubeRenderTarget===!0,ct=j.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=i.createTexture()),tt.__version=v.version,a.memory.textures++),st){O.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0){O.__webglFramebuffer[Z]=[];for(let q=0;q<v.mipmaps.length;q++)O.__webglFramebuffer[Z][q]=i.createFramebuffer()}else O.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(v.mipmaps.length>0){O.__webglFramebuffer=[];for(let Z=0;Z<v.mipmaps.length;Z++)O.__webglFramebuffer[Z]=i.createFramebuffer()}else O.__webglFramebuffer=i.createFramebuffer();if(ct)for(let Z=0,q=j.length;Z<q;Z++){let at=n.get(j[Z]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),a.memory.textures++)}if(T.samples>0&&ut(T)===!1){O.__webglMultisampledFramebuffer=i.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let Z=0;Z<j.length;Z++){let q=j[Z];O.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,O.__webglColorRenderbuffer[Z]);let at=r.convert(q.format,q.colorSpace),R=r.convert(q.type),K=E(q.internalFormat,at,R,q.normalized,q.colorSpace,T.isXRRenderTarget===!0),W=ie(T);i.renderbufferStorageMultisample(i.RENDERBUFFER,W,K,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,O.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),T.depthBuffer&&(O.__webglDepthRenderbuffer=i.createRenderbuffer(),un(O.__webglDepthRenderbuffer,T,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture),qt(i.TEXTURE_CUBE_MAP,v);for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0)for(let q=0;q<v.mipmaps.length;q++)re(O.__webglFramebuffer[Z][q],T,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,q);else re(O.__webglFramebuffer[Z],T,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);A(v)?w(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let Z=0,q=j.length;Z<q;Z++){let at=j[Z],R=n.get(at),K=i.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(K=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,R.__webglTexture),qt(K,at),re(O.__webglFramebuffer,T,at,i.COLOR_ATTACHMENT0+Z,K,0),A(at)&&w(K)}e.unbindTexture()}else{let Z=i.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(Z=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Z,tt.__webglTexture),qt(Z,v),v.mipmaps.length>0)for(let q=0;q<v.mipmaps.length;q++)re(O.__webglFramebuffer[q],T,v,i.COLOR_ATTACHMENT0,Z,q);else re(O.__webglFramebuffer,T,v,i.COLOR_ATTACHMENT0,Z,0);A(v)?w(Z):v.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}T.depthBuffer&&Ye(T)}function L(T){let v=T.textures;for(let O=0,tt=v.length;O<tt;O++){let j=v[O];if(A(j)&&j.mipmapsAutoUpdate===!0){let st=C(T),ct=n.get(j).__webglTexture;e.bindTexture(st,ct),w(st),e.unbindTexture()}}}let Je=[];function ne(T){if(T.samples>0){if(ut(T)===!1){let v=T.textures,O=T.width,tt=T.height,j=i.COLOR_BUFFER_BIT,st=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(T),Z=v.length>1;if(Z)for(let at=0;at<v.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let at=0;at<v.length;at++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let R=n.get(v[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,R,0)}i.blitFramebuffer(0,0,O,tt,0,0,O,tt,j,i.NEAREST),c===!0&&(Je.length=0,Je.push(i.COLOR_ATTACHMENT0+at),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&Je.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Je))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let at=0;at<v.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let R=n.get(v[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,R,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&c){let v=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function ie(T){return Math.min(s.maxSamples,T.samples)}function ut(T){let v=n.get(T);return T.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function fe(T){let v=a.render.frame;h.get(T)!==v&&(h.set(T,v),T.update())}function At(T,v){let O=T.colorSpace,tt=T.format,j=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||O!==is&&O!==Fn&&(Gt.getTransfer(O)===Zt?(tt!==cn||j!==Be)&&Ct("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):_t("WebGLTextures: Unsupported texture color space:",O)),v}function It(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(l.width=T.naturalWidth||T.width,l.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(l.width=T.displayWidth,l.height=T.displayHeight):(l.width=T.width,l.height=T.height),l}this.allocateTextureUnit=Lt,this.resetTextureUnits=Q,this.getTextureUnits=$,this.setTextureUnits=Mt,this.setTexture2D=pt,this.setTexture2DArray=vt,this.setTexture3D=Et,this.setTextureCube=mt,this.rebindTextures=Ze,this.setupRenderTarget=qe,this.updateRenderTargetMipmap=L,this.updateMultisampleRenderTarget=ne,this.setupDepthRenderbuffer=Ye,this.setupFrameBufferTexture=re,this.useMultisampledRTT=ut,this.dispose=G}function Vg(i,t){function e(n,s=Fn){let r,a=Gt.getTransfer(s);if(n===Be)return i.UNSIGNED_BYTE;if(n===ia)return i.UNSIGNED_SHORT_4_4_4_4;if(n===sa)return i.UNSIGNED_SHORT_5_5_5_1;if(n===el)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nl)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$o)return i.BYTE;if(n===tl)return i.SHORT;if(n===Wi)return i.UNSIGNED_SHORT;if(n===na)return i.INT;if(n===an)return i.UNSIGNED_INT;if(n===on)return i.FLOAT;if(n===ln)return i.HALF_FLOAT;if(n===il)return i.ALPHA;if(n===sl)return i.RGB;if(n===cn)return i.RGBA;if(n===_n)return i.DEPTH_COMPONENT;if(n===Un)return i.DEPTH_STENCIL;if(n===rl)return i.RED;if(n===ra)return i.RED_INTEGER;if(n===$n)return i.RG;if(n===aa)return i.RG_INTEGER;if(n===oa)return i.RGBA_INTEGER;if(n===Rs||n===_s||n===Ps||n===Is)if(a===Zt)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Rs)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Rs)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===la||n===ca||n===ha||n===ua)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===la)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ca)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ha)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ua)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===da||n===fa||n===pa||n===ma||n===ga||n===Ls||n===xa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===da||n===fa)return a===Zt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===pa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ma)return r.COMPRESSED_R11_EAC;if(n===ga)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ls)return r.COMPRESSED_RG11_EAC;if(n===xa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===va||n===ya||n===Sa||n===Ma||n===ba||n===wa||n===Ta||n===Ea||n===Aa||n===Ca||n===Ra||n===_a||n===Pa||n===Ia)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===va)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ya)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Sa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Ma)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ba)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===wa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ta)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ea)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Aa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ca)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ra)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_a)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Pa)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ia)return a===Zt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===La||n===Na||n===Da)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===La)return a===Zt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Na)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Da)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ua||n===Fa||n===Ns||n===Oa)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ua)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Fa)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ns)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oa)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===pi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Gg=`
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

}`,Tl=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ps(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new gn({vertexShader:Gg,fragmentShader:Hg,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new pe(new hi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},El=class extends mn{constructor(t,e){super();let n=this,s=null,r=1,a=null,o="local-floor",c=1,l=null,h=null,f=null,d=null,m=null,g=null,S=typeof XRWebGLBinding<"u",p=new Tl,u={},M=e.getContextAttributes(),A=null,w=null,C=[],E=[],x=new Ht,b=null,D=null,I=new Le;I.viewport=new se;let N=new Le;N.viewport=new se;let B=[I,N],H=new jr,_=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let pt=C[J];return pt===void 0&&(pt=new Ui,C[J]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(J){let pt=C[J];return pt===void 0&&(pt=new Ui,C[J]=pt),pt.getGripSpace()},this.getHand=function(J){let pt=C[J];return pt===void 0&&(pt=new Ui,C[J]=pt),pt.getHandSpace()};function Y(J){let pt=E.indexOf(J.inputSource);if(pt===-1)return;let vt=C[pt];vt!==void 0&&(vt.update(J.inputSource,J.frame,l||a),vt.dispatchEvent({type:J.type,data:J.inputSource}))}function V(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",et);for(let J=0;J<C.length;J++){let pt=E[J];pt!==null&&(E[J]=null,C[J].disconnect(pt))}_=null,G=null,p.reset();for(let J in u)delete u[J];if(t.setRenderTarget(A),m=null,d=null,f=null,s=null,w=null,Lt.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(x.width,x.height,!1),D!==null){let J=D.camera;J.fov=D.fov,J.zoom=D.zoom,J.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Ct("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,n.isPresenting===!0&&Ct("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||a},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return f===null&&S&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",V),s.addEventListener("inputsourceschange",et),M.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(x),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Et=null,mt=null;M.depth&&(mt=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=M.stencil?Un:_n,Et=M.stencil?pi:an);let Dt={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(Dt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),w=new He(d.textureWidth,d.textureHeight,{format:cn,type:Be,depthTexture:new Ln(d.textureWidth,d.textureHeight,Et,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let vt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),w=new He(m.framebufferWidth,m.framebufferHeight,{format:cn,type:Be,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(c),l=null,a=await s.requestReferenceSpace(o),Lt.setContext(s),Lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function et(J){for(let pt=0;pt<J.removed.length;pt++){let vt=J.removed[pt],Et=E.indexOf(vt);Et>=0&&(E[Et]=null,C[Et].disconnect(vt))}for(let pt=0;pt<J.added.length;pt++){let vt=J.added[pt],Et=E.indexOf(vt);if(Et===-1){for(let Dt=0;Dt<C.length;Dt++)if(Dt>=E.length){E.push(vt),Et=Dt;break}else if(E[Dt]===null){E[Dt]=vt,Et=Dt;break}if(Et===-1)break}let mt=C[Et];mt&&mt.connect(vt)}}function X(J,pt){pt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(pt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let pt=J.near,vt=J.far;p.texture!==null&&(p.depthNear>0&&(pt=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),H.near=N.near=I.near=pt,H.far=N.far=I.far=vt,(_!==H.near||G!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),_=H.near,G=H.far),H.layers.mask=J.layers.mask|6,I.layers.mask=H.layers.mask&-5,N.layers.mask=H.layers.mask&-3;let Et=J.parent,mt=H.cameras;X(H,Et);for(let Dt=0;Dt<mt.length;Dt++)X(mt[Dt],Et);H.projectionMatrix.copy(I.projectionMatrix),H.projectionMatrixInverse.copy(I.projectionMatrixInverse),D===null&&J.isPerspectiveCamera&&(D={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,H,Et)};function Q(J,pt,vt){vt===null?J.matrix.copy(pt.matrixWorld):(J.matrix.copy(vt.matrixWorld),J.matrix.invert(),J.matrix.multiply(pt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(pt.projectionMatrix),J.projectionMatrixInverse.copy(pt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=_r*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&m===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(J){return u[J]};let $=null;function Mt(J,pt){if(h=pt.getViewerPose(l||a),g=pt,h!==null){let vt=h.views;m!==null&&(t.setRenderTargetFramebuffer(w,m.framebuffer),t.setRenderTarget(w));let Et=!1;vt.length!==H.cameras.length&&(H.cameras.length=0,Et=!0);for(let Rt=0;Rt<vt.length;Rt++){let qt=vt[Rt],Kt=null;if(m!==null)Kt=m.getViewport(qt);else{let be=f.getViewSubImage(d,qt);Kt=be.viewport,Rt===0&&(t.setRenderTargetTextures(w,be.colorTexture,be.depthStencilTexture),t.setRenderTarget(w))}let zt=B[Rt];zt===void 0&&(zt=new Le,zt.layers.enable(Rt),zt.viewport=new se,B[Rt]=zt),zt.matrix.fromArray(qt.transform.matrix),zt.matrix.decompose(zt.position,zt.quaternion,zt.scale),zt.projectionMatrix.fromArray(qt.projectionMatrix),zt.projectionMatrixInverse.copy(zt.projectionMatrix).invert(),zt.viewport.set(Kt.x,Kt.y,Kt.width,Kt.height),Rt===0&&(H.matrix.copy(zt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Et===!0&&H.cameras.push(zt)}let mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){f=n.getBinding();let Rt=f.getDepthInformation(vt[0]);Rt&&Rt.isValid&&Rt.texture&&p.init(Rt,s.renderState)}if(mt&&mt.includes("camera-access")&&S){t.state.unbindTexture(),f=n.getBinding();for(let Rt=0;Rt<vt.length;Rt++){let qt=vt[Rt].camera;if(qt){let Kt=u[qt];Kt||(Kt=new ps,u[qt]=Kt);let zt=f.getCameraImage(qt);Kt.sourceTexture=zt}}}}for(let vt=0;vt<C.length;vt++){let Et=E[vt],mt=C[vt];Et!==null&&mt!==void 0&&mt.update(Et,pt,l||a)}$&&$(J,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),g=null}let Lt=new Oh;Lt.setAnimationLoop(Mt),this.setAnimationLoop=function(J){$=J},this.dispose=function(){}}},Wg=new Qt,Zh=new Pt;Zh.set(-1,0,0,0,1,0,0,0,1);function Xg(i,t){function e(p,u){p.matrixAutoUpdate===!0&&p.updateMatrix(),u.value.copy(p.matrix)}function n(p,u){u.color.getRGB(p.fogColor.value,dl(i)),u.isFog?(p.fogNear.value=u.near,p.fogFar.value=u.far):u.isFogExp2&&(p.fogDensity.value=u.density)}function s(p,u,M,A,w){u.isNodeMaterial?u.uniformsNeedUpdate=!1:u.isMeshBasicMaterial?r(p,u):u.isMeshLambertMaterial?(r(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshToonMaterial?(r(p,u),f(p,u)):u.isMeshPhongMaterial?(r(p,u),h(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshStandardMaterial?(r(p,u),d(p,u),u.isMeshPhysicalMaterial&&m(p,u,w)):u.isMeshMatcapMaterial?(r(p,u),g(p,u)):u.isMeshDepthMaterial?r(p,u):u.isMeshDistanceMaterial?(r(p,u),S(p,u)):u.isMeshNormalMaterial?r(p,u):u.isLineBasicMaterial?(a(p,u),u.isLineDashedMaterial&&o(p,u)):u.isPointsMaterial?c(p,u,M,A):u.isSpriteMaterial?l(p,u):u.isShadowMaterial?(p.color.value.copy(u.color),p.opacity.value=u.opacity):u.isShaderMaterial&&(u.uniformsNeedUpdate=!1)}function r(p,u){p.opacity.value=u.opacity,u.color&&p.diffuse.value.copy(u.color),u.emissive&&p.emissive.value.copy(u.emissive).multiplyScalar(u.emissiveIntensity),u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.bumpMap&&(p.bumpMap.value=u.bumpMap,e(u.bumpMap,p.bumpMapTransform),p.bumpScale.value=u.bumpScale,u.side===De&&(p.bumpScale.value*=-1)),u.normalMap&&(p.normalMap.value=u.normalMap,e(u.normalMap,p.normalMapTransform),p.normalScale.value.copy(u.normalScale),u.side===De&&p.normalScale.value.negate()),u.displacementMap&&(p.displacementMap.value=u.displacementMap,e(u.displacementMap,p.displacementMapTransform),p.displacementScale.value=u.displacementScale,p.displacementBias.value=u.displacementBias),u.emissiveMap&&(p.emissiveMap.value=u.emissiveMap,e(u.emissiveMap,p.emissiveMapTransform)),u.specularMap&&(p.specularMap.value=u.specularMap,e(u.specularMap,p.specularMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest);let M=t.get(u),A=M.envMap,w=M.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(Wg.makeRotationFromEuler(w)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Zh),p.reflectivity.value=u.reflectivity,p.ior.value=u.ior,p.refractionRatio.value=u.refractionRatio),u.lightMap&&(p.lightMap.value=u.lightMap,p.lightMapIntensity.value=u.lightMapIntensity,e(u.lightMap,p.lightMapTransform)),u.aoMap&&(p.aoMap.value=u.aoMap,p.aoMapIntensity.value=u.aoMapIntensity,e(u.aoMap,p.aoMapTransform))}function a(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform))}function o(p,u){p.dashSize.value=u.dashSize,p.totalSize.value=u.dashSize+u.gapSize,p.scale.value=u.scale}function c(p,u,M,A){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.size.value=u.size*M,p.scale.value=A*.5,u.map&&(p.map.value=u.map,e(u.map,p.uvTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function l(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.rotation.value=u.rotation,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function h(p,u){p.specular.value.copy(u.specular),p.shininess.value=Math.max(u.shininess,1e-4)}function f(p,u){u.gradientMap&&(p.gradientMap.value=u.gradientMap)}function d(p,u){p.metalness.value=u.metalness,u.metalnessMap&&(p.metalnessMap.value=u.metalnessMap,e(u.metalnessMap,p.metalnessMapTransform)),p.roughness.value=u.roughness,u.roughnessMap&&(p.roughnessMap.value=u.roughnessMap,e(u.roughnessMap,p.roughnessMapTransform)),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)}function m(p,u,M){p.ior.value=u.ior,u.diffuseRoughness>0&&(p.diffuseRoughness.value=u.diffuseRoughness,u.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=u.diffuseRoughnessMap,e(u.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),u.sheen>0&&(p.sheenColor.value.copy(u.sheenColor).multiplyScalar(u.sheen),p.sheenRoughness.value=u.sheenRoughness,u.sheenColorMap&&(p.sheenColorMap.value=u.sheenColorMap,e(u.sheenColorMap,p.sheenColorMapTransform)),u.sheenRoughnessMap&&(p.sheenRoughnessMap.value=u.sheenRoughnessMap,e(u.sheenRoughnessMap,p.sheenRoughnessMapTransform))),u.clearcoat>0&&(p.clearcoat.value=u.clearcoat,p.clearcoatRoughness.value=u.clearcoatRoughness,u.clearcoatMap&&(p.clearcoatMap.value=u.clearcoatMap,e(u.clearcoatMap,p.clearcoatMapTransform)),u.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=u.clearcoatRoughnessMap,e(u.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),u.clearcoatNormalMap&&(p.clearcoatNormalMap.value=u.clearcoatNormalMap,e(u.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(u.clearcoatNormalScale),u.side===De&&p.clearcoatNormalScale.value.negate())),u.dispersion>0&&(p.dispersion.value=u.dispersion),u.retroreflectivity>0&&(p.retroreflectivity.value=u.retroreflectivity),u.iridescence>0&&(p.iridescence.value=u.iridescence,p.iridescenceIOR.value=u.iridescenceIOR,p.iridescenceThicknessMinimum.value=u.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=u.iridescenceThicknessMaximum,u.iridescenceMap&&(p.iridescenceMap.value=u.iridescenceMap,e(u.iridescenceMap,p.iridescenceMapTransform)),u.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=u.iridescenceThicknessMap,e(u.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),u.transmission>0&&(p.transmission.value=u.transmission,p.transmissionSamplerMap.value=M.texture,p.transmissionSamplerSize.value.set(M.width,M.height),u.transmissionMap&&(p.transmissionMap.value=u.transmissionMap,e(u.transmissionMap,p.transmissionMapTransform)),p.thickness.value=u.thickness,u.thicknessMap&&(p.thicknessMap.value=u.thicknessMap,e(u.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=u.attenuationDistance,p.attenuationColor.value.copy(u.attenuationColor)),u.anisotropy>0&&(p.anisotropyVector.value.set(u.anisotropy*Math.cos(u.anisotropyRotation),u.anisotropy*Math.sin(u.anisotropyRotation)),u.anisotropyMap&&(p.anisotropyMap.value=u.anisotropyMap,e(u.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=u.specularIntensity,p.specularColor.value.copy(u.specularColor),u.specularColorMap&&(p.specularColorMap.value=u.specularColorMap,e(u.specularColorMap,p.specularColorMapTransform)),u.specularIntensityMap&&(p.specularIntensityMap.value=u.specularIntensityMap,e(u.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,u){u.matcap&&(p.matcap.value=u.matcap)}function S(p,u){let M=t.get(u).light;p.referencePosition.value.setFromMatrixPosition(M.matrixWorld),p.nearDistance.value=M.shadow.camera.near,p.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Yg(i,t,e,n){let s={},r={};function a(M,A){let w=A.program;n.uniformBlockBinding(M,w,s[M.id])}function o(M,A){let w=s[M.id];w===void 0&&(g(M),w=c(M),s[M.id]=w,M.addEventListener("dispose",p));let C=A.program;n.updateUBOMapping(M,C);let E=t.render.frame;r[M.id]!==E&&(l(M),r[M.id]=E)}function c(M){let A=i.createBuffer(),w=M.__size,C=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,w,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(M){let A=s[M.id],w=M.uniforms,C=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=w.length;E<x;E++){let b=w[E];if(Array.isArray(b))for(let D=0,I=b.length;D<I;D++)h(b[D],E,D,C);else h(b,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(M,A,w,C){if(d(M,A,w,C)===!0){let E=M.__offset,x=M.value;if(Array.isArray(x)){let b=0;for(let D=0;D<x.length;D++){let I=x[D],N=S(I,!0);f(I,M.__data,b),b+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,M.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,M.__data)}}function f(M,A,w){typeof M=="number"||typeof M=="boolean"?A[w]=M:M.isMatrix3?(A[w]=M.elements[0],A[w+1]=M.elements[1],A[w+2]=M.elements[2],A[w+3]=0,A[w+4]=M.elements[3],A[w+5]=M.elements[4],A[w+6]=M.elements[5],A[w+7]=0,A[w+8]=M.elements[6],A[w+9]=M.elements[7],A[w+10]=M.elements[8],A[w+11]=0):ArrayBuffer.isView(M)?A.set(M.subarray(0,A.length-w),w):M.toArray(A,w)}function d(M,A,w,C){let E=M.value,x=A+"_"+w;if(Array.isArray(E)){C[x]===void 0&&(C[x]=[]);let b=C[x],D=!1;for(let I=0;I<E.length;I++)m(E[I],b,I)===!0&&(D=!0);return D}return m(E,C,x)}function m(M,A,w){if(A[w]===void 0)return typeof M=="number"||typeof M=="boolean"?A[w]=M:ArrayBuffer.isView(M)?A[w]=M.slice():A[w]=M.clone(),!0;{let C=A[w];if(typeof M=="number"||typeof M=="boolean"){if(C!==M)return A[w]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(C.equals(M)===!1)return C.copy(M),!0}}return!1}function g(M){let A=M.uniforms,w=0,C=16;for(let x=0,b=A.length;x<b;x++){let D=Array.isArray(A[x])?A[x]:[A[x]];for(let I=0,N=D.length;I<N;I++){let B=D[I],H=Array.isArray(B.value)?B.value:[B.value],_=Array.isArray(A[x])||Array.isArray(B.value),G=w;for(let V=0,et=H.length;V<et;V++){let X=H[V],Q=S(X,_),$=w%C,Mt=$%Q.boundary,Lt=$+Mt;w+=Mt,Lt!==0&&C-Lt<Q.storage&&(w+=C-Lt),V===0&&(G=w),w+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((w-G)/Float32Array.BYTES_PER_ELEMENT),B.__offset=G}}let E=w%C;return E>0&&(w+=C-E),M.__size=w,M.__cache={},this}function S(M,A){let w={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(w.boundary=4,w.storage=4):M.isVector2?(w.boundary=8,w.storage=8):M.isVector3||M.isColor?(w.boundary=16,w.storage=12):M.isVector4?(w.boundary=16,w.storage=16):M.isMatrix3?(w.boundary=16,w.storage=48):M.isMatrix4?(w.boundary=16,w.storage=64):M.isTexture?Ct("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(w.boundary=16,w.storage=M.byteLength):Ct("WebGLRenderer: Unsupported uniform value type.",M),A===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function p(M){let A=M.target;A.removeEventListener("dispose",p),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function u(){for(let M in s)i.deleteBuffer(s[M]);s={},r={}}return{bind:a,update:o,dispose:u}}var Zg=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yn=null;function qg(){return yn===null&&(yn=new Nr(Zg,16,16,$n,ln),yn.name="DFG_LUT",yn.minFilter=Ne,yn.magFilter=Ne,yn.wrapS=fn,yn.wrapT=fn,yn.generateMipmaps=!1,yn.needsUpdate=!0),yn}var Ga=class{constructor(t={}){let{canvas:e=oh(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:m=Be}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let S=m,p=new Set([oa,aa,ra]),u=new Set([Be,an,Wi,pi,ia,sa]),M=new Uint32Array(4),A=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},C=null,E=null,x=[],b=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,N=!1,B=null,H=null,_=null,G=null;this._outputColorSpace=Ve;let Y=0,V=0,et=null,X=-1,Q=null,$=new se,Mt=new se,Lt=null,J=new Ut(0),pt=0,vt=e.width,Et=e.height,mt=1,Dt=null,le=null,Rt=new se(0,0,vt,Et),qt=new se(0,0,vt,Et),Kt=!1,zt=new Zn,be=new Dr,de=!1,Fe=!1,re=new Qt,un=new U,xe=new se,Ye={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ze=!1;function qe(){return et===null?mt:1}let L=n;function Je(y,P){return e.getContext(y,P)}let ne,ie,ut,fe,At,It,T,v,O,tt,j,st,ct,Z,q,at,R,K,W,ot,it,rt,wt;try{let y={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Tt,!1),e.addEventListener("webglcontextrestored",Ft,!1),e.addEventListener("webglcontextcreationerror",dt,!1),L===null){let P="webgl2";if(L=Je(P,y),L===null)throw Je(P)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ot()}catch(y){throw e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),_t("WebGLRenderer: "+y.message),y}function Ot(){ne=new rm(L),ne.init(),it=new Vg(L,ne),ie=new qp(L,ne,t,it),ut=new zg(L,ne),ie.reversedDepthBuffer&&d&&ut.buffers.depth.setReversed(!0),H=L.createFramebuffer(),_=L.createFramebuffer(),G=L.createFramebuffer(),fe=new lm(L),At=new Eg,It=new kg(L,ne,ut,At,ie,it,fe),T=new sm(I),v=new cd(L),rt=new Yp(L,v),O=new am(L,v,fe,rt),tt=new hm(L,O,v,rt,fe),K=new cm(L,ie,It),q=new Jp(At),j=new Tg(I,T,ne,ie,rt,q),st=new Xg(I,At),ct=new Cg,Z=new Ng(ne),R=new Xp(I,T,ut,tt,g,c),at=new Bg(I,tt,ie),wt=new Yg(L,fe,ie,ut),W=new Zp(L,ne,fe),ot=new om(L,ne,fe),fe.programs=j.programs,I.capabilities=ie,I.extensions=ne,I.properties=At,I.renderLists=ct,I.shadowMap=at,I.state=ut,I.info=fe}S!==Be&&(D=new dm(S,e.width,e.height,o,s,r));let nt=new El(I,L);this.xr=nt,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let y=ne.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){let y=ne.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(y){y!==void 0&&(mt=y,this.setSize(vt,Et,!1))},this.getSize=function(y){return y.set(vt,Et)},this.setSize=function(y,P,k=!0){if(nt.isPresenting){Ct("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=y,Et=P,e.width=Math.floor(y*mt),e.height=Math.floor(P*mt),k===!0&&(e.style.width=y+"px",e.style.height=P+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,y,P)},this.getDrawingBufferSize=function(y){return y.set(vt*mt,Et*mt).floor()},this.setDrawingBufferSize=function(y,P,k){vt=y,Et=P,mt=k,e.width=Math.floor(y*k),e.height=Math.floor(P*k),this.setViewport(0,0,y,P)},this.setEffects=function(y){if(S===Be){_t("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let P=0;P<y.length;P++)if(y[P].isOutputPass===!0){Ct("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy($)},this.getViewport=function(y){return y.copy(Rt)},this.setViewport=function(y,P,k,F){y.isVector4?Rt.set(y.x,y.y,y.z,y.w):Rt.set(y,P,k,F),ut.viewport($.copy(Rt).multiplyScalar(qe()).round())},this.getScissor=function(y){return y.copy(qt)},this.setScissor=function(y,P,k,F){y.isVector4?qt.set(y.x,y.y,y.z,y.w):qt.set(y,P,k,F),ut.scissor(Mt.copy(qt).multiplyScalar(qe()).round())},this.getScissorTest=function(){return Kt},this.setScissorTest=function(y){ut.setScissorTest(Kt=y)},this.setOpaqueSort=function(y){Dt=y},this.setTransparentSort=function(y){le=y},this.getClearColor=function(y){return y.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(y=!0,P=!0,k=!0){let F=0;if(y){let z=!1;if(et!==null){let ht=et.texture.format;z=p.has(ht)}if(z){let ht=et.texture.type,xt=u.has(ht),lt=R.getClearColor(),gt=R.getClearAlpha(),bt=lt.r,Nt=lt.g,kt=lt.b;xt?(M[0]=bt,M[1]=Nt,M[2]=kt,M[3]=gt,L.clearBufferuiv(L.COLOR,0,M)):(A[0]=bt,A[1]=Nt,A[2]=kt,A[3]=gt,L.clearBufferiv(L.COLOR,0,A))}else F|=L.COLOR_BUFFER_BIT}P&&(F|=L.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),k&&(F|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&L.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),B=y},this.dispose=function(){e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),R.dispose(),ct.dispose(),Z.dispose(),It.dispose(),At.dispose(),T.dispose(),tt.dispose(),O.dispose(),rt.dispose(),wt.dispose(),j.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Dl),nt.removeEventListener("sessionend",Ul),ei.stop()};function Tt(y){y.preventDefault(),hl("WebGLRenderer: Context Lost."),N=!0}function Ft(){hl("WebGLRenderer: Context Restored."),N=!1;let y=fe.autoReset,P=at.enabled,k=at.autoUpdate,F=at.needsUpdate,z=at.type;Ot(),fe.autoReset=y,at.enabled=P,at.autoUpdate=k,at.needsUpdate=F,at.type=z}function dt(y){_t("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Jt(y){let P=y.target;P.removeEventListener("dispose",Jt),ve(P)}function ve(y){Bn(y),At.remove(y)}function Bn(y){let P=At.get(y).programs;P!==void 0&&(P.forEach(function(k){j.releaseProgram(k)}),y.isShaderMaterial&&j.releaseShaderCache(y))}this.renderBufferDirect=function(y,P,k,F,z,ht){P===null&&(P=Ye);let xt=z.isMesh&&z.matrixWorld.determinantAffine()<0,lt=cu(y,P,k,F,z);ut.setMaterial(F,xt);let gt=k.index,bt=1;if(F.wireframe===!0){if(gt=O.getWireframeAttribute(k),gt===void 0)return;bt=2}let Nt=k.drawRange,kt=k.attributes.position,yt=Nt.start*bt,Vt=(Nt.start+Nt.count)*bt;ht!==null&&(yt=Math.max(yt,ht.start*bt),Vt=Math.min(Vt,(ht.start+ht.count)*bt)),gt!==null?(yt=Math.max(yt,0),Vt=Math.min(Vt,gt.count)):kt!=null&&(yt=Math.max(yt,0),Vt=Math.min(Vt,kt.count));let ce=Vt-yt;if(ce<0||ce===1/0)return;rt.setup(z,F,lt,k,gt);let $t,jt=W;if(gt!==null&&($t=v.get(gt),jt=ot,jt.setIndex($t)),z.isMesh)F.wireframe===!0?(ut.setLineWidth(F.wireframeLinewidth*qe()),jt.setMode(L.LINES)):jt.setMode(L.TRIANGLES);else if(z.isLine){let Ee=F.linewidth;Ee===void 0&&(Ee=1),ut.setLineWidth(Ee*qe()),z.isLineSegments?jt.setMode(L.LINES):z.isLineLoop?jt.setMode(L.LINE_LOOP):jt.setMode(L.LINE_STRIP)}else z.isPoints?jt.setMode(L.POINTS):z.isSprite&&jt.setMode(L.TRIANGLES);if(z.isBatchedMesh)if(ne.get("WEBGL_multi_draw"))jt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Ee=z._multiDrawStarts,St=z._multiDrawCounts,Ie=z._multiDrawCount,Yt=gt?v.get(gt).bytesPerElement:1,ni=At.get(F).currentProgram.getUniforms();for(let Ae=0;Ae<Ie;Ae++)ni.setValue(L,"_gl_DrawID",Ae),jt.render(Ee[Ae]/Yt,St[Ae])}else if(z.isInstancedMesh)jt.renderInstances(yt,ce,z.count);else if(k.isInstancedBufferGeometry){let Ee=k._maxInstanceCount!==void 0?k._maxInstanceCount:1/0,St=Math.min(k.instanceCount,Ee);jt.renderInstances(yt,ce,St)}else jt.render(yt,ce)};function Nl(y,P,k,F){B!==null&&y.isNodeMaterial&&B.setObject(F,y),de===!0&&q.setState(y,k,!1),y.transparent===!0&&y.side===xn&&y.forceSinglePass===!1?(y.side=De,y.needsUpdate=!0,qi(y,P,F),y.side=Qn,y.needsUpdate=!0,qi(y,P,F),y.side=xn):qi(y,P,F)}this.compile=function(y,P,k=null){k===null&&(k=y),B!==null&&B.renderStart(y,P,k),E=Z.get(k),E.init(P),b.push(E),k.traverseVisible(function(z){z.isLight&&z.layers.test(P.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),y!==k&&y.traverseVisible(function(z){z.isLight&&z.layers.test(P.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Fe=this.localClippingEnabled,de=q.init(this.clippingPlanes,Fe),de===!0&&q.setGlobalState(this.clippingPlanes,P),B!==null&&at.render(E.state.shadowsArray,k,P);let F=new Set;return y.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let ht=z.material;if(ht)if(Array.isArray(ht))for(let xt=0;xt<ht.length;xt++){let lt=ht[xt];Nl(lt,k,P,z),F.add(lt)}else Nl(ht,k,P,z),F.add(ht)}),E=b.pop(),B!==null&&B.renderEnd(),F},this.compileAsync=function(y,P,k=null){let F=this.compile(y,P,k);return new Promise(z=>{function ht(){if(F.forEach(function(xt){let gt=At.get(xt).currentProgram;(gt===void 0||gt.isReady())&&F.delete(xt)}),F.size===0){z(y);return}setTimeout(ht,10)}ne.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let no=null;function ou(y){no&&no(y)}function Dl(){ei.stop()}function Ul(){ei.start()}let ei=new Oh;ei.setAnimationLoop(ou),typeof self<"u"&&ei.setContext(self),this.setAnimationLoop=function(y){no=y,nt.setAnimationLoop(y),y===null?ei.stop():ei.start()},nt.addEventListener("sessionstart",Dl),nt.addEventListener("sessionend",Ul),this.render=function(y,P){if(P!==void 0&&P.isCamera!==!0){_t("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;B!==null&&B.renderStart(y,P);let k=nt.enabled===!0&&nt.isPresenting===!0,F=D!==null&&(et===null||k)&&D.begin(I,et);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),P.parent===null&&P.matrixWorldAutoUpdate===!0&&P.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(P),P=nt.getCamera()),y.isScene===!0&&y.onBeforeRender(I,y,P,et),E=Z.get(y,b.length),E.init(P),E.state.textureUnits=It.getTextureUnits(),b.push(E),re.multiplyMatrices(P.projectionMatrix,P.matrixWorldInverse),P.isArrayCamera?be.setFromArrayCamera(P):zt.setFromProjectionMatrix(re,je,P.reversedDepth),Fe=this.localClippingEnabled,de=q.init(this.clippingPlanes,Fe),C=ct.get(y,x.length),C.init(),x.push(C),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let xt=I.xr.getDepthSensingMesh();xt!==null&&io(xt,P,-1/0,I.sortObjects)}io(y,P,0,I.sortObjects),C.finish(),B!==null&&B.updateLights(E.state.lightsArray),I.sortObjects===!0&&C.sort(Dt,le),Ze=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Ze&&R.addToRenderList(C,y),this.info.autoReset===!0&&this.info.reset(),de===!0&&q.beginShadows();let z=E.state.shadowsArray;if(at.render(z,y,P),de===!0&&q.endShadows(),(F&&D.hasRenderPass())===!1){let xt=C.opaque,lt=C.transmissive;if(E.setupLights(),P.isArrayCamera){let gt=P.cameras;if(lt.length>0)for(let bt=0,Nt=gt.length;bt<Nt;bt++){let kt=gt[bt];Ol(xt,lt,y,kt)}Ze&&R.render(y);for(let bt=0,Nt=gt.length;bt<Nt;bt++){let kt=gt[bt];Fl(C,y,kt,kt.viewport)}}else lt.length>0&&Ol(xt,lt,y,P),Ze&&R.render(y),Fl(C,y,P)}et!==null&&V===0&&(It.updateMultisampleRenderTarget(et),It.updateRenderTargetMipmap(et)),F&&D.end(I),y.isScene===!0&&y.onAfterRender(I,y,P),rt.resetDefaultState(),X=-1,Q=null,b.pop(),b.length>0?(E=b[b.length-1],It.setTextureUnits(E.state.textureUnits),de===!0&&q.setGlobalState(I.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,B!==null&&B.renderEnd()};function io(y,P,k,F){if(y.visible===!1)return;if(y.layers.test(P.layers)){if(y.isGroup)k=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(P);else if(y.isLight)E.pushLight(y),y.castShadow&&E.pushShadow(y);else if(y.isSprite){let xt=P.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){F&&xe.setFromMatrixPosition(y.matrixWorld).applyMatrix4(re);let lt=tt.update(y),gt=y.material;gt.visible&&C.push(y,lt,gt,k,xe.z,null,P)}}else if(y.isMesh||y.isLine||y.isPoints){let xt=P.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){let lt=tt.update(y),gt=y.material;if(F&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),xe.copy(y.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),xe.copy(lt.boundingSphere.center)),xe.applyMatrix4(y.matrixWorld).applyMatrix4(re)),Array.isArray(gt)){let bt=lt.groups;for(let Nt=0,kt=bt.length;Nt<kt;Nt++){let yt=bt[Nt],Vt=gt[yt.materialIndex];Vt&&Vt.visible&&C.push(y,lt,Vt,k,xe.z,yt,P)}}else gt.visible&&C.push(y,lt,gt,k,xe.z,null,P)}}}let ht=y.children;for(let xt=0,lt=ht.length;xt<lt;xt++)io(ht[xt],P,k,F)}function Fl(y,P,k,F){let{opaque:z,transmissive:ht,transparent:xt}=y;E.setupLightsView(k),de===!0&&q.setGlobalState(I.clippingPlanes,k),F&&ut.viewport($.copy(F)),z.length>0&&Vs(z,P,k),ht.length>0&&Vs(ht,P,k),xt.length>0&&Vs(xt,P,k),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function Ol(y,P,k,F){if((k.isScene===!0?k.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[F.id]===void 0){let yt=ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[F.id]=new He(1,1,{generateMipmaps:!0,type:yt?ln:Be,minFilter:Dn,samples:Math.max(4,ie.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Gt.workingColorSpace})}let ht=E.state.transmissionRenderTarget[F.id],xt=F.viewport||$;ht.setSize(xt.z*I.transmissionResolutionScale,xt.w*I.transmissionResolutionScale);let lt=I.getRenderTarget(),gt=I.getActiveCubeFace(),bt=I.getActiveMipmapLevel();I.setRenderTarget(ht),I.getClearColor(J),pt=I.getClearAlpha(),pt<1&&I.setClearColor(16777215,.5),I.clear(),Ze&&R.render(k);let Nt=I.toneMapping;I.toneMapping=vn;let kt=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),E.setupLightsView(F),de===!0&&q.setGlobalState(I.clippingPlanes,F),Vs(y,k,F),It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht),ne.has("WEBGL_multisampled_render_to_texture")===!1){let yt=!1;for(let Vt=0,ce=P.length;Vt<ce;Vt++){let $t=P[Vt],{object:jt,geometry:Ee,material:St,group:Ie}=$t;if(St.side===xn&&jt.layers.test(F.layers)){let Yt=St.side;St.side=De,St.needsUpdate=!0,Bl(jt,k,F,Ee,St,Ie),St.side=Yt,St.needsUpdate=!0,yt=!0}}yt===!0&&(It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht))}I.setRenderTarget(lt,gt,bt),I.setClearColor(J,pt),kt!==void 0&&(F.viewport=kt),I.toneMapping=Nt}function Vs(y,P,k){let F=P.isScene===!0?P.overrideMaterial:null;for(let z=0,ht=y.length;z<ht;z++){let xt=y[z],{object:lt,geometry:gt,group:bt}=xt,Nt=xt.material;Nt.allowOverride===!0&&F!==null&&(Nt=F),lt.layers.test(k.layers)&&Bl(lt,P,k,gt,Nt,bt)}}function Bl(y,P,k,F,z,ht){B!==null&&z.isNodeMaterial&&B.setObject(y,z),y.onBeforeRender(I,P,k,F,z,ht),y.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),z.onBeforeRender(I,P,k,F,y,ht),z.transparent===!0&&z.side===xn&&z.forceSinglePass===!1?(z.side=De,z.needsUpdate=!0,I.renderBufferDirect(k,P,F,z,y,ht),z.side=Qn,z.needsUpdate=!0,I.renderBufferDirect(k,P,F,z,y,ht),z.side=xn):I.renderBufferDirect(k,P,F,z,y,ht),y.onAfterRender(I,P,k,F,z,ht)}function zl(y){let P=0;for(let k of y)k.texture!==null&&P++;return P}function qi(y,P,k){P.isScene!==!0&&(P=Ye);let F=At.get(y),z=E.state.lights,ht=E.state.shadowsArray,xt=z.state.version,lt=j.getParameters(y,z.state,ht,P,k,E.state.lightProbeGridArray),gt=j.getProgramCacheKey(lt),bt=F.programs;F.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,F.fog=P.fog;let Nt=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;F.envMap=T.get(y.envMap||F.environment,Nt),F.envMapRotation=F.environment!==null&&y.envMap===null?P.environmentRotation:y.envMapRotation,bt===void 0&&(y.addEventListener("dispose",Jt),bt=new Map,F.programs=bt,F.programVariants=new Map);let kt=bt.get(gt);if(kt!==void 0){if(F.currentProgram===kt&&F.lightsStateVersion===xt)return Vl(y,lt),kt}else lt.uniforms=j.getUniforms(y),B!==null&&y.isNodeMaterial&&B.build(y,k,lt),y.onBeforeCompile(lt,I),kt=j.acquireProgram(lt,gt),bt.set(gt,kt),F.uniforms=lt.uniforms;let yt=F.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(yt.clippingPlanes=q.uniform),Vl(y,lt),F.needsLights=uu(y),F.lightsStateVersion=xt,F.needsLights&&(yt.ambientLightColor.value=z.state.ambient,yt.lightProbe.value=z.state.probe,yt.sunLights.value=z.state.sun,yt.sunLightShadows.value=z.state.sunShadow,yt.directionalLights.value=z.state.directional,yt.directionalLightShadows.value=z.state.directionalShadow,yt.spotLights.value=z.state.spot,yt.spotLightShadows.value=z.state.spotShadow,yt.rectAreaLights.value=z.state.rectArea,yt.ltc_1.value=z.state.rectAreaLTC1,yt.ltc_2.value=z.state.rectAreaLTC2,yt.pointLights.value=z.state.point,yt.pointLightShadows.value=z.state.pointShadow,yt.hemisphereLights.value=z.state.hemi,yt.sunShadowMatrix.value=z.state.sunShadowMatrix,yt.sunShadowCascade.value=z.state.sunShadowCascade,yt.directionalShadowMatrix.value=z.state.directionalShadowMatrix,yt.spotLightMatrix.value=z.state.spotLightMatrix,yt.spotLightMap.value=z.state.spotLightMap,yt.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=zl(E.state.lightProbeGridArray),F.currentProgram=kt,F.uniformsList=null,kt}function lu(y,P,k,F,z){let ht=At.get(y),xt=ht.currentProgram.id+","+F+","+z,lt=ht.programVariants.get(xt);return lt===void 0?(lt=qi(y,P,k),ht.programVariants.set(xt,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=F,ht.toneMapping=z),lt}function kl(y){if(y.uniformsList===null){let P=y.currentProgram.getUniforms();y.uniformsList=Xi.seqWithValue(P.seq,y.uniforms)}return y.uniformsList}function Vl(y,P){let k=At.get(y);k.outputColorSpace=P.outputColorSpace,k.batching=P.batching,k.batchingColor=P.batchingColor,k.instancing=P.instancing,k.instancingColor=P.instancingColor,k.instancingMorph=P.instancingMorph,k.skinning=P.skinning,k.morphTargets=P.morphTargets,k.morphNormals=P.morphNormals,k.morphColors=P.morphColors,k.morphTargetsCount=P.morphTargetsCount,k.numClippingPlanes=P.numClippingPlanes,k.numIntersection=P.numClipIntersection,k.vertexAlphas=P.vertexAlphas,k.vertexTangents=P.vertexTangents,k.toneMapping=P.toneMapping}function cu(y,P,k,F,z){P.isScene!==!0&&(P=Ye),It.resetTextureUnits();let ht=P.fog,xt=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?P.environment:null,lt=et===null?I.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Gt.workingColorSpace,gt=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,bt=T.get(F.envMap||xt,gt),Nt=F.vertexColors===!0&&!!k.attributes.color&&k.attributes.color.itemSize===4,kt=!!k.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),yt=!!k.morphAttributes.position,Vt=!!k.morphAttributes.normal,ce=!!k.morphAttributes.color,$t=vn;F.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&($t=I.toneMapping);let jt=k.morphAttributes.position||k.morphAttributes.normal||k.morphAttributes.color,Ee=jt!==void 0?jt.length:0,St=At.get(F),Ie=E.state.lights;if(de===!0&&(Fe===!0||y!==Q)){let ae=y===Q&&F.id===X;q.setState(F,y,ae)}let Yt=!1,ni=!1;F.version===St.__version?St.needsLights&&St.lightsStateVersion!==Ie.state.version||z.isBatchedMesh&&St.batching===!1||!z.isBatchedMesh&&St.batching===!0||z.isBatchedMesh&&St.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&St.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&St.instancing===!1||!z.isInstancedMesh&&St.instancing===!0||z.isSkinnedMesh&&St.skinning===!1||!z.isSkinnedMesh&&St.skinning===!0||z.isInstancedMesh&&St.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&St.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&St.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&St.instancingMorph===!1&&z.morphTexture!==null||St.envMap!==bt||F.fog===!0&&St.fog!==ht||St.numClippingPlanes!==void 0&&(St.numClippingPlanes!==q.numPlanes||St.numIntersection!==q.numIntersection)||St.vertexAlphas!==Nt||St.vertexTangents!==kt||St.morphTargets!==yt||St.morphNormals!==Vt||St.morphColors!==ce||St.morphTargetsCount!==Ee||St.numLightProbeGrids!==zl(E.state.lightProbeGridArray)?Yt=!0:(St.outputColorSpace!==lt||St.toneMapping!==$t)&&(ni=!0):(Yt=!0,St.__version=F.version);let Ae=St.currentProgram;(Yt===!0||ni===!0)&&(Ae=ni===!0?lu(F,P,z,lt,$t):qi(F,P,z),B&&F.isNodeMaterial&&B.onUpdateProgram(F,Ae,St));let Gs=!1,zn=!1,ii=!1,Xt=Ae.getUniforms(),we=St.uniforms;if(ut.useProgram(Ae.program)&&(Gs=!0,zn=!0,ii=!0),F.id!==X&&(X=F.id,zn=!0),Gs||Q!==y){ut.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),Xt.setValue(L,"projectionMatrix",y.projectionMatrix),Xt.setValue(L,"viewMatrix",y.matrixWorldInverse);let ye=Xt.map.cameraPosition;ye!==void 0&&ye.setValue(L,un.setFromMatrixPosition(y.matrixWorld)),ie.logarithmicDepthBuffer&&Xt.setValue(L,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&Xt.setValue(L,"isOrthographic",y.isOrthographicCamera===!0),Q!==y&&(Q=y,zn=!0,ii=!0)}if(St.needsLights&&(Ie.state.sunShadowMap.length>0&&Xt.setValue(L,"sunShadowMap",Ie.state.sunShadowMap,It),Ie.state.directionalShadowMap.length>0&&Xt.setValue(L,"directionalShadowMap",Ie.state.directionalShadowMap,It),Ie.state.spotShadowMap.length>0&&Xt.setValue(L,"spotShadowMap",Ie.state.spotShadowMap,It),Ie.state.pointShadowMap.length>0&&Xt.setValue(L,"pointShadowMap",Ie.state.pointShadowMap,It)),z.isSkinnedMesh){Xt.setOptional(L,z,"bindMatrix"),Xt.setOptional(L,z,"bindMatrixInverse");let ae=z.skeleton;ae&&(ae.boneTexture===null&&ae.computeBoneTexture(),Xt.setValue(L,"boneTexture",ae.boneTexture,It))}z.isBatchedMesh&&(Xt.setOptional(L,z,"batchingTexture"),Xt.setValue(L,"batchingTexture",z._matricesTexture,It),Xt.setOptional(L,z,"batchingIdTexture"),Xt.setValue(L,"batchingIdTexture",z._indirectTexture,It),Xt.setOptional(L,z,"batchingColorTexture"),z._colorsTexture!==null&&Xt.setValue(L,"batchingColorTexture",z._colorsTexture,It));let tn=k.morphAttributes;if((tn.position!==void 0||tn.normal!==void 0||tn.color!==void 0)&&K.update(z,k,Ae),(zn||St.receiveShadow!==z.receiveShadow)&&(St.receiveShadow=z.receiveShadow,Xt.setValue(L,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&P.environment!==null&&(we.envMapIntensity.value=P.environmentIntensity),we.dfgLUT!==void 0&&(we.dfgLUT.value=qg()),zn){if(Xt.setValue(L,"toneMappingExposure",I.toneMappingExposure),St.needsLights&&hu(we,ii),ht&&F.fog===!0&&st.refreshFogUniforms(we,ht),st.refreshMaterialUniforms(we,F,mt,Et,E.state.transmissionRenderTarget[y.id]),St.needsLights&&St.numLightProbeGrids>0){let ae=w,ye=0;for(let Mn of E.state.lightProbeGridArray)Mn.texture!==null&&(ae.textures[ye]=Mn.texture,ae.min[ye]=Mn.boundingBox.min,ae.max[ye]=Mn.boundingBox.max,ae.resolution[ye]=Mn.resolution,ye++);for(let Mn in ae)ae[Mn].length=ye;we.probesSH.value=ae.textures,we.probesMin.value=ae.min,we.probesMax.value=ae.max,we.probesResolution.value=ae.resolution}Xi.upload(L,kl(St),we,It)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(Xi.upload(L,kl(St),we,It),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&Xt.setValue(L,"center",z.center),Xt.setValue(L,"modelViewMatrix",z.modelViewMatrix),Xt.setValue(L,"normalMatrix",z.normalMatrix),Xt.setValue(L,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let ae=F.uniformsGroups;for(let ye=0,Mn=ae.length;ye<Mn;ye++){let Hl=ae[ye];wt.update(Hl,Ae),wt.bind(Hl,Ae)}}return Ae}function hu(y,P){y.ambientLightColor.needsUpdate=P,y.lightProbe.needsUpdate=P,y.sunLights.needsUpdate=P,y.sunLightShadows.needsUpdate=P,y.directionalLights.needsUpdate=P,y.directionalLightShadows.needsUpdate=P,y.pointLights.needsUpdate=P,y.pointLightShadows.needsUpdate=P,y.spotLights.needsUpdate=P,y.spotLightShadows.needsUpdate=P,y.rectAreaLights.needsUpdate=P,y.hemisphereLights.needsUpdate=P}function uu(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(y,P,k){let F=At.get(y);F.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),At.get(y.texture).__webglTexture=P,At.get(y.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:k,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,P){let k=At.get(y);k.__webglFramebuffer=P,k.__useDefaultFramebuffer=P===void 0},this.setRenderTarget=function(y,P=0,k=0){et=y,Y=P,V=k;let F=null,z=!1,ht=!1;if(y){let lt=At.get(y);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(L.FRAMEBUFFER,lt.__webglFramebuffer),$.copy(y.viewport),Mt.copy(y.scissor),Lt=y.scissorTest,ut.viewport($),ut.scissor(Mt),ut.setScissorTest(Lt),X=-1;return}else if(lt.__webglFramebuffer===void 0)It.setupRenderTarget(y);else if(lt.__hasExternalTextures)It.rebindTextures(y,At.get(y.texture).__webglTexture,At.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){let Nt=y.depthTexture;if(lt.__boundDepthTexture!==Nt){if(Nt!==null&&At.has(Nt)&&(y.width!==Nt.image.width||y.height!==Nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");It.setupDepthRenderbuffer(y)}}let gt=y.texture;(gt.isData3DTexture||gt.isDataArrayTexture||gt.isCompressedArrayTexture)&&(ht=!0);let bt=At.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(bt[P])?F=bt[P][k]:F=bt[P],z=!0):y.samples>0&&It.useMultisampledRTT(y)===!1?F=At.get(y).__webglMultisampledFramebuffer:Array.isArray(bt)?F=bt[k]:F=bt,$.copy(y.viewport),Mt.copy(y.scissor),Lt=y.scissorTest}else $.copy(Rt).multiplyScalar(mt).floor(),Mt.copy(qt).multiplyScalar(mt).floor(),Lt=Kt;if(k!==0&&(F=H),ut.bindFramebuffer(L.FRAMEBUFFER,F)&&ut.drawBuffers(y,F),ut.viewport($),ut.scissor(Mt),ut.setScissorTest(Lt),z){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+P,lt.__webglTexture,k)}else if(ht){let lt=P;for(let gt=0;gt<y.textures.length;gt++){let bt=At.get(y.textures[gt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+gt,bt.__webglTexture,k,lt)}}else if(y!==null&&k!==0){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,lt.__webglTexture,k)}X=-1};function Gl(y){let P=At.get(y);return(P.__readFormat!==y.format||P.__readType!==y.type)&&(P.__readFormat=y.format,P.__readType=y.type,P.__formatReadable=ie.textureFormatReadable(y.format),P.__typeReadable=ie.textureTypeReadable(y.type)),P}this.readRenderTargetPixels=function(y,P,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget)){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt){ut.bindFramebuffer(L.FRAMEBUFFER,gt);try{let bt=y.textures[lt],Nt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Gl(bt);if(yt.__formatReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(yt.__typeReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}P>=0&&P<=y.width-F&&k>=0&&k<=y.height-z&&L.readPixels(P,k,F,z,it.convert(Nt),it.convert(kt),ht)}finally{let bt=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,bt)}}},this.readRenderTargetPixelsAsync=async function(y,P,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt)if(P>=0&&P<=y.width-F&&k>=0&&k<=y.height-z){ut.bindFramebuffer(L.FRAMEBUFFER,gt);let bt=y.textures[lt],Nt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Gl(bt);if(yt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(yt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Vt=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,Vt),L.bufferData(L.PIXEL_PACK_BUFFER,ht.byteLength,L.STREAM_READ),L.readPixels(P,k,F,z,it.convert(Nt),it.convert(kt),0),L.bindBuffer(L.PIXEL_PACK_BUFFER,null);let ce=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,ce);let $t=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await ch(L,$t,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,Vt),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,ht),L.bindBuffer(L.PIXEL_PACK_BUFFER,null),L.deleteBuffer(Vt),L.deleteSync($t),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,P=null,k=0){let F=Math.pow(2,-k),z=Math.floor(y.image.width*F),ht=Math.floor(y.image.height*F),xt=P!==null?P.x:0,lt=P!==null?P.y:0;It.setTexture2D(y,0),L.copyTexSubImage2D(L.TEXTURE_2D,k,0,0,xt,lt,z,ht),ut.unbindTexture()},this.copyTextureToTexture=function(y,P,k=null,F=null,z=0,ht=0){let xt,lt,gt,bt,Nt,kt,yt,Vt,ce,$t=y.isCompressedTexture?y.mipmaps[ht]:y.image;if(k!==null)xt=k.max.x-k.min.x,lt=k.max.y-k.min.y,gt=k.isBox3?k.max.z-k.min.z:1,bt=k.min.x,Nt=k.min.y,kt=k.isBox3?k.min.z:0;else{let Xt=Math.pow(2,-z);xt=Math.floor($t.width*Xt),lt=Math.floor($t.height*Xt),y.isDataArrayTexture?gt=$t.depth:y.isData3DTexture?gt=Math.floor($t.depth*Xt):gt=1,bt=0,Nt=0,kt=0}F!==null?(yt=F.x,Vt=F.y,ce=F.z):(yt=0,Vt=0,ce=0);let jt=it.convert(P.format),Ee=it.convert(P.type),St;P.isData3DTexture?(It.setTexture3D(P,0),St=L.TEXTURE_3D):P.isDataArrayTexture||P.isCompressedArrayTexture?(It.setTexture2DArray(P,0),St=L.TEXTURE_2D_ARRAY):(It.setTexture2D(P,0),St=L.TEXTURE_2D),ut.activeTexture(L.TEXTURE0),ut.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,P.flipY),ut.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,P.premultiplyAlpha),ut.pixelStorei(L.UNPACK_ALIGNMENT,P.unpackAlignment);let Ie=ut.getParameter(L.UNPACK_ROW_LENGTH),Yt=ut.getParameter(L.UNPACK_IMAGE_HEIGHT),ni=ut.getParameter(L.UNPACK_SKIP_PIXELS),Ae=ut.getParameter(L.UNPACK_SKIP_ROWS),Gs=ut.getParameter(L.UNPACK_SKIP_IMAGES);ut.pixelStorei(L.UNPACK_ROW_LENGTH,$t.width),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,$t.height),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,bt),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Nt),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,kt);let zn=y.isDataArrayTexture||y.isData3DTexture,ii=P.isDataArrayTexture||P.isData3DTexture;if(y.isDepthTexture){let Xt=At.get(y),we=At.get(P),tn=At.get(Xt.__renderTarget),ae=At.get(we.__renderTarget);ut.bindFramebuffer(L.READ_FRAMEBUFFER,tn.__webglFramebuffer),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,ae.__webglFramebuffer);for(let ye=0;ye<gt;ye++)zn&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(y).__webglTexture,z,kt+ye),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(P).__webglTexture,ht,ce+ye)),L.blitFramebuffer(bt,Nt,bt+xt,Nt+lt,yt,Vt,yt+xt,Vt+lt,L.DEPTH_BUFFER_BIT,L.NEAREST);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(z!==0||y.isRenderTargetTexture||At.has(y)){let Xt=At.get(y),we=At.get(P);ut.bindFramebuffer(L.READ_FRAMEBUFFER,_),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,G);for(let tn=0;tn<gt;tn++)zn?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Xt.__webglTexture,z,kt+tn):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Xt.__webglTexture,z),ii?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,we.__webglTexture,ht,ce+tn):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,we.__webglTexture,ht),z!==0?L.blitFramebuffer(bt,Nt,bt+xt,Nt+lt,yt,Vt,yt+xt,Vt+lt,L.COLOR_BUFFER_BIT,L.NEAREST):ii?L.copyTexSubImage3D(St,ht,yt,Vt,ce+tn,bt,Nt,xt,lt):L.copyTexSubImage2D(St,ht,yt,Vt,bt,Nt,xt,lt);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else ii?y.isDataTexture||y.isData3DTexture?L.texSubImage3D(St,ht,yt,Vt,ce,xt,lt,gt,jt,Ee,$t.data):P.isCompressedArrayTexture?L.compressedTexSubImage3D(St,ht,yt,Vt,ce,xt,lt,gt,jt,$t.data):L.texSubImage3D(St,ht,yt,Vt,ce,xt,lt,gt,jt,Ee,$t):y.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,ht,yt,Vt,xt,lt,jt,Ee,$t.data):y.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,ht,yt,Vt,$t.width,$t.height,jt,$t.data):L.texSubImage2D(L.TEXTURE_2D,ht,yt,Vt,xt,lt,jt,Ee,$t);ut.pixelStorei(L.UNPACK_ROW_LENGTH,Ie),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,Yt),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,ni),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Ae),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,Gs),ht===0&&P.generateMipmaps===!0&&P.mipmapsAutoUpdate===!0&&L.generateMipmap(St),ut.unbindTexture()},this.initRenderTarget=function(y){At.get(y).__webglFramebuffer===void 0&&It.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?It.setTextureCube(y,0):y.isData3DTexture?It.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?It.setTexture2DArray(y,0):It.setTexture2D(y,0),ut.unbindTexture()},this.resetState=function(){Y=0,V=0,et=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return je}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Gt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Gt._getUnpackColorSpace()}};var qh=.5,Jh=.012,Za=new U(0,0,1),Kh=.15,Xa=Math.PI/180,Qh=60*Xa,Zi=i=>new vs({color:i}),Jg=Zi("#e8eaee"),jh=Zi("#9aa3b2"),Al=Zi("#5c6675"),Kg=Zi("#3d4653"),jg=Zi("#c9723c"),Qg=Zi("#8a6d3b"),$g=new $e({color:"#b3261e"}),t0=new $e({color:"#6a1b9a",wireframe:!0}),e0=new qn({color:"#1f2937"}),n0=new qn({color:"#5b4a2a"}),i0=new $e({color:"#1565c0",wireframe:!0,depthTest:!1});function On(i,t,e,n=20){let s=new Bi(i,i,t,n);return s.rotateX(Math.PI/2),new pe(s,e)}var ti=(i,t=0)=>new U(i[t],i[t+1],i[t+2]);function Ya(i,t,e){let n=e.clone().sub(t);i.position.copy(t).addScaledVector(n,.5),i.scale.z=Math.max(n.length(),1e-6),i.quaternion.setFromUnitVectors(Za,n.normalize())}var qa=class extends Ge{constructor(t){super(),this.shaft=On(.012,1,t,8),this.head=new pe(new ms(.032,.07,10).rotateX(Math.PI/2),t),this.add(this.shaft,this.head)}show(t,e){let n=Jh*e.length();if(this.visible=n>.012,!this.visible)return;let s=t.clone().addScaledVector(e,Jh);Ya(this.shaft,t,s),this.head.position.copy(s),this.head.quaternion.copy(this.shaft.quaternion)}},Ja=class extends Ge{constructor(t,e){super(),this.believes=e,this.position.y=t,this.rotation.z=Qh;let n=On(.1,.06,jh);n.position.z=.03,this.add(n),this.limbs=Array.from({length:8},(a,o)=>On(o<5?.055:.045,1,Jg)),this.joints=Array.from({length:7},(a,o)=>On(o<5?.068:.055,o<5?.15:.12,jh)),this.flange=new Ge;let s=On(.05,.02,Al),r=new pe(new Nn(.05,.19,.05),Al);r.position.z=.035,this.flange.add(s,r);for(let a of[-1,1]){let o=new pe(new Nn(.02,.015,.05),Al);o.position.set(0,a*.055,.085),this.flange.add(o)}this.objects=new Ge,this.flange.add(this.objects),this.belief=new pe(new zi(1,12,8),i0),this.belief.matrixAutoUpdate=!1,this.flange.add(this.belief),this.bag=new pe(new zi(.06,14,10),Qg),this.string=new Fi(new _e().setFromPoints([new U,Za]),n0),this.target=new Ge,this.target.add(new pe(new xs(.085,.006,6,28),new $e({color:"#1f2937"}))),this.stream=On(.008,1,new $e({color:"#3b82c4"}),8),this.sag=On(.004,1,new $e({color:"#1f2937"}),6),this.push=new qa($g),this.felt=new qa(t0),this.add(...this.limbs,...this.joints,this.flange,this.bag,this.string,this.target,this.sag,this.stream,this.push,this.felt)}update(t,e,n,s){let r=t("links"),a=M=>[ti(r,7*M),new Qe(...r.slice(7*M+3,7*M+7))],o=new U;for(let M=0;M<8;++M){let[A,w]=a(M);this.limbs[M].visible=A.distanceTo(o)>.001,this.limbs[M].visible&&Ya(this.limbs[M],o,A),M<7?(this.joints[M].position.copy(A),this.joints[M].quaternion.copy(w)):(this.flange.position.copy(A),this.flange.quaternion.copy(w),this.target.quaternion.copy(w),this.target.position.copy(A).sub(ti(t("error"))),this.sag.visible=ti(t("error")).length()>.004,this.sag.visible&&Ya(this.sag,this.target.position,A)),o=A}let c=ti(t("hand")),l=c.clone().add(new U(.07,.03,.35));this.stream.visible=s,Ya(this.stream,l,l.clone().setZ(c.z-.05)),this.bag.visible=this.string.visible=n,n&&(this.bag.position.copy(ti(t("bag"))),this.string.geometry.setFromPoints([c,this.bag.position])),this.push.show(c,e),this.felt.show(c,this.believes?ti(t("force")):new U);let h=t("mean"),f=t("com_covariance");this.belief.visible=this.believes&&t("held")[0]>.5&&Math.max(f[0],f[4],f[8])<Kh*Kh;let d=2*Math.sqrt(f[0]),m=2*f[1]/Math.sqrt(f[0]),g=2*f[2]/Math.sqrt(f[0]),S=Math.sqrt(Math.max(4*f[4]-m*m,1e-8)),p=(4*f[5]-m*g)/S,u=Math.sqrt(Math.max(4*f[8]-g*g-p*p,1e-8));this.belief.matrix.set(d,0,0,h[1],m,S,0,h[2],g,p,u,h[3],0,0,0,1),this.belief.matrixWorldNeedsUpdate=!0}hold(t){this.objects.clear();for(let{mass:e,com:n,kind:s}of t){let r=.05*Math.cbrt(Math.max(e,.05)),a=s==="cup"?On(.045,.03+.06*e,jg):On(r,1.6*r,Kg);a.position.copy(ti(n)),a.add(new Oi(new gs(a.geometry,30),e0)),this.objects.add(a)}}};function s0(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;return t!==void 0&&/swiftshader|llvmpipe|software/i.test(i.getParameter(t))}var Ka=class{constructor(t){this.canvas=t,this.renderer=new Ga({canvas:t,antialias:!s0()}),this.scene=new ls,this.scene.background=new Ut("#f4f6f8"),this.camera=new Le(32,1,.1,10),this.camera.up.copy(Za),this.azimuth=0,this.elevation=12*Xa;let e=new Ts("#ffffff",2);e.position.set(2,-1,3);let n=new Es(3,15,"#b8c0cc","#dde2e8");n.rotation.x=Math.PI/2,this.arms={without:new Ja(-qh,!1),with:new Ja(qh,!0)},this.wall=new pe(new hi(1,1.1,5,5),new $e({color:"#37474f",wireframe:!0})),this.wall.rotation.x=Math.PI/2,this.scene.add(new Ms("#ffffff","#b0b6bf",2),e,n,...Object.values(this.arms)),this.walls=Object.values(this.arms).map(s=>{let r=this.wall.clone();return s.add(r),r}),this.ratio=Math.min(devicePixelRatio,2),this.interval=this.drawn=0,this.resize(),new ResizeObserver(()=>this.resize()).observe(t)}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.look())}look(){let t=Math.tan(this.camera.fov*Xa/2),e=Math.max(.58/t,.98/(t*this.camera.aspect))+.45,n=new U(.15,.18,.45),s=Math.cos(this.elevation);this.camera.position.set(s*Math.cos(this.azimuth),s*Math.sin(this.azimuth),Math.sin(this.elevation)).multiplyScalar(e).add(n),this.camera.lookAt(n),this.camera.updateMatrixWorld()}turn(t,e){this.azimuth=Math.min(Math.max(this.azimuth-.006*t,-1.2),1.2),this.elevation=Math.min(Math.max(this.elevation+.006*e,0),1.2),this.look()}handAt(t){let n=this.arms[t].flange.localToWorld(new U(0,0,.1)).project(this.camera);return{x:(n.x+1)/2*this.canvas.clientWidth,y:(1-n.y)/2*this.canvas.clientHeight}}inArms(t,e){let n=this.camera.position.distanceTo(this.arms.with.position),s=2*Math.tan(this.camera.fov*Xa/2)*n/this.canvas.clientHeight,r=new Qt().extractRotation(this.camera.matrixWorld);return new U(t*s,-e*s,0).applyMatrix4(r).applyAxisAngle(Za,-Qh)}draw(t,e){let n=JSON.stringify(e);for(let[r,a]of Object.entries(this.arms))a.update(o=>t(`${r}.${o}`),ti(t("push")),t("hanging")[0]!==0,t("pour")[0]>0),n!==this.held&&a.hold(e);this.held=n;let s=t("wall_at");for(let r of this.walls)r.visible=t("constrained")[0]!==0,r.position.set(.4,s[0]+.1,.5);this.renderer.render(this.scene,this.camera),this.adapt()}adapt(){let t=performance.now(),e=t-this.drawn;this.drawn=t,e<1e3&&(this.interval+=(e-this.interval)/10),!(this.interval<45||this.ratio<.6)&&(this.interval=0,this.ratio*=.8,this.resize())}};var eu=["hand is empty","holds it steadily","is being filled","something pushes","payload is changing"],$h=["","attached","exchanged","removed","filled","only a push"],Cl=300,r0=100,Xe=i=>document.getElementById(i),zs=new Worker(URL.createObjectURL(new Blob([Wl],{type:"text/javascript"}))),Rl=new Hs,Pl,Il,$a,hn=0,Ll=1,Qa=0,to=[],ks=[],eo=!0,tu=!1,_l=0,ja=-1,ue=i=>{let[t,e]=Pl[i];return Il.subarray(t,t+e)},nu=i=>zs.postMessage({command:i});function a0(i){eo=!1,nu(i)}zs.onmessage=({data:i})=>{if(i.fields&&(Pl=i.fields,to=[],ks=[],_l=0,Rl.clear()),i.frames){for(Il of i.frames)Rl.add(ue);hn=i.ticks,i.busy&&(Qa+=(i.busy-Qa)*.05),eo&&l0()}i.command&&(i.accepted?o0(i.command,i.at):gi("A Panda is rated for 3 kg: that would be too much.")),i.paused&&au()};function o0(i,t){to.push(`${t} ${i}`);let[e,...n]=i.split(" ");e==="attach"&&ks.push({kind:+n[0]===Ji?"cup":"weight",mass:+n[0],com:n.slice(1).map(Number)}),e==="drop"&&(ks=[])}function l0(){!tu&&hn>=Cl&&nu(ro(1.2,0)),tu=hn>=Cl,hn<Cl?gi("Both hands are empty."):hn<4e3?gi("Both hands were given 1.2 kg. Nobody told the arms."):gi("Your turn: drag a weight onto a hand, or pull at a hand.")}function gi(i){Xe("caption").textContent!==i&&(Xe("caption").textContent=i)}function Ue(i,t,e,n=""){let s=Xe(i);s.dataset.value=t;let r=t.toFixed(e)+n;s.textContent!==r&&(s.textContent=r)}function iu(){let i=ue("with.mean"),t=ue("with.deviation"),e=ue("with.payload"),n=g=>Math.hypot(...g);Ue("error-without",1e3*n(ue("without.error")),1),Ue("error-with",1e3*n(ue("with.error")),1),Ue("mass",i[0],3),Ue("mass-deviation",t[0],3),Ue("truth",e[0],3);for(let g=0;g<3;++g)Ue(`com-${g}`,1e3*i[g+1],1),Ue(`com-deviation-${g}`,1e3*t[g+1],1),Ue(`com-truth-${g}`,1e3*e[g+1],1);let s=ue("with.probability"),r=s.indexOf(Math.max(...s));eu.forEach((g,S)=>{let p=Xe("modes").children[S];p.classList.toggle("likeliest",S===r),p.querySelector("i").style.width=`${100*s[S]}%`,Ue(`mode-${S}`,100*s[S],1," %")}),[...ue("with.force"),...ue("with.moment")].forEach((g,S)=>{let p=Math.max(-1,Math.min(1,g/(S<3?40:4))),u=Xe("wrench").children[S].querySelector("i");u.style.left=`${50+50*Math.min(p,0)}%`,u.style.width=`${50*Math.abs(p)}%`,Ue(`wrench-${S}`,g,S<3?1:2,S<3?" N":" N m")});let o=ue("with.health")[0],[c,l]=ue("with.limit");Ue("health",o,1),Xe("health-word").textContent=o<3?"good":"not explained",Ue("confidence",100*ue("with.confidence")[0],0," %"),Ue("friction",100*ue("with.friction_shows")[0],0," %"),Ue("wall",1e3*ue("with.wall")[0],0," mm"),Xe("limit").textContent=`joint ${c}, ${(l*180/Math.PI).toFixed(0)}\xB0 away`,Qa>0&&Ue("speed",1/Qa,1);let[h,f,d,m]=ue("with.event");ue("with.changing")[0]?Xe("noticed").textContent="something is happening":h>0&&(Xe("noticed").textContent=`${$h[f]}: noticed ${Math.round(1e3*(m-d))} ms after it began`),h>_l&&!eo&&gi(`rme: ${$h[f]}, ${i[0].toFixed(2)} kg.`),_l=h}function su(){requestAnimationFrame(su),Il&&($a?.draw(ue,ks.map(i=>i.kind==="cup"?{...i,mass:ue("poured")[0]}:i)),!(ja>=0&&hn>=ja&&hn<ja+r0)&&(ja=hn,iu(),Yl(Xe("history"),Rl)))}function ru(i,t,e){for(let[n,s]of t.entries())Xe(i).insertAdjacentHTML("beforeend",`<li><span>${s}</span><span class="bar"><i></i></span><output id="${e}-${n}"></output></li>`)}Xe("save").addEventListener("click",()=>{let i=document.createElement("a");i.href=URL.createObjectURL(new Blob([to.join(`
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
