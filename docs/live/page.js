(()=>{var Wl=`(()=>{var Ct=(()=>{var c=typeof document<"u"&&document.currentScript?document.currentScript.src:void 0;return(function(n){n=n||{};var n=typeof n<"u"?n:{},Z,z;n.ready=new Promise(function(e,t){Z=e,z=t});var he=Object.assign({},n),pe=[],de="./this.program",Se=(e,t)=>{throw t},We=!1,C=!0,O="";function Me(e){return n.locateFile?n.locateFile(e,O):O+e}var Ge,Ue,re,De;(We||C)&&(C?O=self.location.href:typeof document<"u"&&document.currentScript&&(O=document.currentScript.src),c&&(O=c),O.indexOf("blob:")!==0?O=O.substr(0,O.replace(/[?#].*/,"").lastIndexOf("/")+1):O="",Ge=(e=>{var t=new XMLHttpRequest;return t.open("GET",e,!1),t.send(null),t.responseText}),C&&(re=(e=>{var t=new XMLHttpRequest;return t.open("GET",e,!1),t.responseType="arraybuffer",t.send(null),new Uint8Array(t.response)})),Ue=((e,t,r)=>{var i=new XMLHttpRequest;i.open("GET",e,!0),i.responseType="arraybuffer",i.onload=(()=>{if(i.status==200||i.status==0&&i.response){t(i.response);return}r()}),i.onerror=r,i.send(null)}),De=(e=>document.title=e));var Ie=n.print||console.log.bind(console),j=n.printErr||console.warn.bind(console);Object.assign(n,he),he=null,n.arguments&&(pe=n.arguments),n.thisProgram&&(de=n.thisProgram),n.quit&&(Se=n.quit);var _t=4;function E(e){E.shown||(E.shown={}),E.shown[e]||(E.shown[e]=1,j(e))}function $t(e,t){if(typeof WebAssembly.Function=="function"){for(var r={i:"i32",j:"i64",f:"f32",d:"f64"},i={parameters:[],results:t[0]=="v"?[]:[r[t[0]]]},u=1;u<t.length;++u)i.parameters.push(r[t[u]]);return new WebAssembly.Function(i,e)}var l=[1,0,1,96],o=t.slice(0,1),s=t.slice(1),y={i:127,j:126,f:125,d:124};l.push(s.length);for(var u=0;u<s.length;++u)l.push(y[s[u]]);o=="v"?l.push(0):l=l.concat([1,y[o]]),l[1]=l.length-2;var S=new Uint8Array([0,97,115,109,1,0,0,0].concat(l,[2,7,1,1,101,1,102,0,0,7,5,1,1,102,0,0])),W=new WebAssembly.Module(S),g=new WebAssembly.Instance(W,{e:{f:e}}),d=g.exports.f;return d}var we=[],Re;function en(){if(we.length)return we.pop();try{J.grow(1)}catch(e){throw e instanceof RangeError?"Unable to grow wasm table. Set ALLOW_TABLE_GROWTH.":e}return J.length-1}function tn(e,t){for(var r=e;r<e+t;r++){var i=oe(r);i&&Re.set(i,r)}}var nn=0,L;n.wasmBinary&&(L=n.wasmBinary);var Ce=n.noExitRuntime||!0;typeof WebAssembly!="object"&&Q("no native wasm support detected");var B,ae=!1,Xe;function rn(e,t){e||Q(t)}function Ee(e){var t=n["_"+e];return t}function Be(e,t,r,i,u){var l={string:function(h){var F=0;if(h!=null&&h!==0){var U=(h.length<<2)+1;F=ce(U),Ae(h,F,U)}return F},array:function(h){var F=ce(h.length);return Fe(h,F),F}};function o(h){return t==="string"?A(h):t==="boolean"?!!h:h}var s=Ee(e),y=[],S=0;if(i)for(var W=0;W<i.length;W++){var g=l[r[W]];g?(S===0&&(S=be()),y[W]=g(i[W])):y[W]=i[W]}var d=s.apply(null,y);function q(h){return S!==0&&He(S),o(h)}return d=q(d),d}var an=1,Oe=typeof TextDecoder<"u"?new TextDecoder("utf8"):void 0;function qe(e,t,r){for(var i=t+r,u=t;e[u]&&!(u>=i);)++u;if(u-t>16&&e.subarray&&Oe)return Oe.decode(e.subarray(t,u));for(var l="";t<u;){var o=e[t++];if(!(o&128)){l+=String.fromCharCode(o);continue}var s=e[t++]&63;if((o&224)==192){l+=String.fromCharCode((o&31)<<6|s);continue}var y=e[t++]&63;if((o&240)==224?o=(o&15)<<12|s<<6|y:o=(o&7)<<18|s<<12|y<<6|e[t++]&63,o<65536)l+=String.fromCharCode(o);else{var S=o-65536;l+=String.fromCharCode(55296|S>>10,56320|S&1023)}}return l}function A(e,t){return e?qe(Y,e,t):""}function ke(e,t,r,i){if(!(i>0))return 0;for(var u=r,l=r+i-1,o=0;o<e.length;++o){var s=e.charCodeAt(o);if(s>=55296&&s<=57343){var y=e.charCodeAt(++o);s=65536+((s&1023)<<10)|y&1023}if(s<=127){if(r>=l)break;t[r++]=s}else if(s<=2047){if(r+1>=l)break;t[r++]=192|s>>6,t[r++]=128|s&63}else if(s<=65535){if(r+2>=l)break;t[r++]=224|s>>12,t[r++]=128|s>>6&63,t[r++]=128|s&63}else{if(r+3>=l)break;t[r++]=240|s>>18,t[r++]=128|s>>12&63,t[r++]=128|s>>6&63,t[r++]=128|s&63}}return t[r]=0,r-u}function Ae(e,t,r){return ke(e,Y,t,r)}function _e(e){for(var t=0,r=0;r<e.length;++r){var i=e.charCodeAt(r);i>=55296&&i<=57343&&(i=65536+((i&1023)<<10)|e.charCodeAt(++r)&1023),i<=127?++t:i<=2047?t+=2:i<=65535?t+=3:t+=4}return t}var fn=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0;function Fe(e,t){P.set(e,t)}function $e(e,t,r){for(var i=0;i<e.length;++i)P[t++>>0]=e.charCodeAt(i);r||(P[t>>0]=0)}var Pe,P,Y,et,tt,m,nt,rt,at;function Ve(e){Pe=e,n.HEAP8=P=new Int8Array(e),n.HEAP16=et=new Int16Array(e),n.HEAP32=m=new Int32Array(e),n.HEAPU8=Y=new Uint8Array(e),n.HEAPU16=tt=new Uint16Array(e),n.HEAPU32=nt=new Uint32Array(e),n.HEAPF32=rt=new Float32Array(e),n.HEAPF64=at=new Float64Array(e)}var on=n.INITIAL_MEMORY||16777216,J,Ze=[],je=[],Ne=[],it=!1,ft=!1,ot=0;function st(){return Ce||ot>0}function ut(){if(n.preRun)for(typeof n.preRun=="function"&&(n.preRun=[n.preRun]);n.preRun.length;)vt(n.preRun.shift());fe(Ze)}function lt(){it=!0,fe(je)}function sn(){ft=!0}function ct(){if(n.postRun)for(typeof n.postRun=="function"&&(n.postRun=[n.postRun]);n.postRun.length;)yt(n.postRun.shift());fe(Ne)}function vt(e){Ze.unshift(e)}function mt(e){je.unshift(e)}function yt(e){Ne.unshift(e)}var N=0,ie=null,K=null;function ht(e){N++,n.monitorRunDependencies&&n.monitorRunDependencies(N)}function pt(e){if(N--,n.monitorRunDependencies&&n.monitorRunDependencies(N),N==0&&(ie!==null&&(clearInterval(ie),ie=null),K)){var t=K;K=null,t()}}n.preloadedImages={},n.preloadedAudios={};function Q(e){n.onAbort&&n.onAbort(e),e="Aborted("+e+")",j(e),ae=!0,Xe=1,e+=". Build with -s ASSERTIONS=1 for more info.";var t=new WebAssembly.RuntimeError(e);throw z(t),t}var dt="data:application/octet-stream;base64,";function ge(e){return e.startsWith(dt)}var w;w="live.wasm",ge(w)||(w=Me(w));function xe(e){try{if(e==w&&L)return new Uint8Array(L);if(re)return re(e);throw"both async and sync fetching of the wasm failed"}catch(t){Q(t)}}function St(){return!L&&(We||C)&&typeof fetch=="function"?fetch(w,{credentials:"same-origin"}).then(function(e){if(!e.ok)throw"failed to load wasm binary file at '"+w+"'";return e.arrayBuffer()}).catch(function(){return xe(w)}):Promise.resolve().then(function(){return xe(w)})}function Wt(){var e={env:Te,wasi_snapshot_preview1:Te};function t(o,s){var y=o.exports;n.asm=y,B=n.asm.memory,Ve(B.buffer),J=n.asm.__indirect_function_table,mt(n.asm.__wasm_call_ctors),pt("wasm-instantiate")}ht("wasm-instantiate");function r(o){t(o.instance)}function i(o){return St().then(function(s){return WebAssembly.instantiate(s,e)}).then(function(s){return s}).then(o,function(s){j("failed to asynchronously prepare wasm: "+s),Q(s)})}function u(){return!L&&typeof WebAssembly.instantiateStreaming=="function"&&!ge(w)&&typeof fetch=="function"?fetch(w,{credentials:"same-origin"}).then(function(o){var s=WebAssembly.instantiateStreaming(o,e);return s.then(r,function(y){return j("wasm streaming compile failed: "+y),j("falling back to ArrayBuffer instantiation"),i(r)})}):i(r)}if(n.instantiateWasm)try{var l=n.instantiateWasm(e,t);return l}catch(o){return j("Module.instantiateWasm callback failed with error: "+o),!1}return u().catch(z),{}}var un,ln;function fe(e){for(;e.length>0;){var t=e.shift();if(typeof t=="function"){t(n);continue}var r=t.func;typeof r=="number"?t.arg===void 0?oe(r)():oe(r)(t.arg):r(t.arg===void 0?null:t.arg)}}function cn(e){return e}function vn(e){var t=/\\b_Z[\\w\\d_]+/g;return e.replace(t,function(r){var i=r;return r===i?r:i+" ["+r+"]"})}var M=[];function oe(e){var t=M[e];return t||(e>=M.length&&(M.length=e+1),M[e]=t=J.get(e)),t}function mn(){var e=new Error;if(!e.stack){try{throw new Error}catch(t){e=t}if(!e.stack)return"(no stack trace available)"}return e.stack.toString()}function yn(e,t){J.set(e,t),M[e]=t}function wt(e){return ze(e+16)+16}function Xt(e){this.excPtr=e,this.ptr=e-16,this.set_type=function(t){m[this.ptr+4>>2]=t},this.get_type=function(){return m[this.ptr+4>>2]},this.set_destructor=function(t){m[this.ptr+8>>2]=t},this.get_destructor=function(){return m[this.ptr+8>>2]},this.set_refcount=function(t){m[this.ptr>>2]=t},this.set_caught=function(t){t=t?1:0,P[this.ptr+12>>0]=t},this.get_caught=function(){return P[this.ptr+12>>0]!=0},this.set_rethrown=function(t){t=t?1:0,P[this.ptr+13>>0]=t},this.get_rethrown=function(){return P[this.ptr+13>>0]!=0},this.init=function(t,r){this.set_type(t),this.set_destructor(r),this.set_refcount(0),this.set_caught(!1),this.set_rethrown(!1)},this.add_ref=function(){var t=m[this.ptr>>2];m[this.ptr>>2]=t+1},this.release_ref=function(){var t=m[this.ptr>>2];return m[this.ptr>>2]=t-1,t===1}}var Ot=0,qt=0;function kt(e,t,r){var i=new Xt(e);throw i.init(t,r),Ot=e,qt++,e}function Ft(){Q("")}function Pt(e,t,r){Y.copyWithin(e,t,t+r)}function Vt(){return 2147483648}function Zt(e){try{return B.grow(e-Pe.byteLength+65535>>>16),Ve(B.buffer),1}catch{}}function jt(e){var t=Y.length;e=e>>>0;var r=Vt();if(e>r)return!1;let i=(y,S)=>y+(S-y%S)%S;for(var u=1;u<=4;u*=2){var l=t*(1+.2/u);l=Math.min(l,e+100663296);var o=Math.min(r,i(Math.max(e,l),65536)),s=Zt(o);if(s)return!0}return!1}var se={};function Nt(){return de||"./this.program"}function G(){if(!G.strings){var e=(typeof navigator=="object"&&navigator.languages&&navigator.languages[0]||"C").replace("-","_")+".UTF-8",t={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:e,_:Nt()};for(var r in se)se[r]===void 0?delete t[r]:t[r]=se[r];var i=[];for(var r in t)i.push(r+"="+t[r]);G.strings=i}return G.strings}var ue={buffers:[null,[],[]],printChar:function(e,t){var r=ue.buffers[e];t===0||t===10?((e===1?Ie:j)(qe(r,0)),r.length=0):r.push(t)},varargs:void 0,get:function(){ue.varargs+=4;var e=m[ue.varargs-4>>2];return e},getStr:function(e){var t=A(e);return t},get64:function(e,t){return e}};function gt(e,t){var r=0;return G().forEach(function(i,u){var l=t+r;m[e+u*4>>2]=l,$e(i,l),r+=i.length+1}),0}function xt(e,t){var r=G();m[e>>2]=r.length;var i=0;return r.forEach(function(u){i+=u.length+1}),m[t>>2]=i,0}function _(e){return e%4===0&&(e%100!==0||e%400===0)}function le(e,t){for(var r=0,i=0;i<=t;r+=e[i++]);return r}var $=[31,29,31,30,31,30,31,31,30,31,30,31],ee=[31,28,31,30,31,30,31,31,30,31,30,31];function te(e,t){for(var r=new Date(e.getTime());t>0;){var i=_(r.getFullYear()),u=r.getMonth(),l=(i?$:ee)[u];if(t>l-r.getDate())t-=l-r.getDate()+1,r.setDate(1),u<11?r.setMonth(u+1):(r.setMonth(0),r.setFullYear(r.getFullYear()+1));else return r.setDate(r.getDate()+t),r}return r}function Tt(e,t,r,i){var u=m[i+40>>2],l={tm_sec:m[i>>2],tm_min:m[i+4>>2],tm_hour:m[i+8>>2],tm_mday:m[i+12>>2],tm_mon:m[i+16>>2],tm_year:m[i+20>>2],tm_wday:m[i+24>>2],tm_yday:m[i+28>>2],tm_isdst:m[i+32>>2],tm_gmtoff:m[i+36>>2],tm_zone:u?A(u):""},o=A(r),s={"%c":"%a %b %d %H:%M:%S %Y","%D":"%m/%d/%y","%F":"%Y-%m-%d","%h":"%b","%r":"%I:%M:%S %p","%R":"%H:%M","%T":"%H:%M:%S","%x":"%m/%d/%y","%X":"%H:%M:%S","%Ec":"%c","%EC":"%C","%Ex":"%m/%d/%y","%EX":"%H:%M:%S","%Ey":"%y","%EY":"%Y","%Od":"%d","%Oe":"%e","%OH":"%H","%OI":"%I","%Om":"%m","%OM":"%M","%OS":"%S","%Ou":"%u","%OU":"%U","%OV":"%V","%Ow":"%w","%OW":"%W","%Oy":"%y"};for(var y in s)o=o.replace(new RegExp(y,"g"),s[y]);var S=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],W=["January","February","March","April","May","June","July","August","September","October","November","December"];function g(a,f,p){for(var v=typeof a=="number"?a.toString():a||"";v.length<f;)v=p[0]+v;return v}function d(a,f){return g(a,f,"0")}function q(a,f){function p(k){return k<0?-1:k>0?1:0}var v;return(v=p(a.getFullYear()-f.getFullYear()))===0&&(v=p(a.getMonth()-f.getMonth()))===0&&(v=p(a.getDate()-f.getDate())),v}function h(a){switch(a.getDay()){case 0:return new Date(a.getFullYear()-1,11,29);case 1:return a;case 2:return new Date(a.getFullYear(),0,3);case 3:return new Date(a.getFullYear(),0,2);case 4:return new Date(a.getFullYear(),0,1);case 5:return new Date(a.getFullYear()-1,11,31);case 6:return new Date(a.getFullYear()-1,11,30)}}function F(a){var f=te(new Date(a.tm_year+1900,0,1),a.tm_yday),p=new Date(f.getFullYear(),0,4),v=new Date(f.getFullYear()+1,0,4),k=h(p),V=h(v);return q(k,f)<=0?q(V,f)<=0?f.getFullYear()+1:f.getFullYear():f.getFullYear()-1}var U={"%a":function(a){return S[a.tm_wday].substring(0,3)},"%A":function(a){return S[a.tm_wday]},"%b":function(a){return W[a.tm_mon].substring(0,3)},"%B":function(a){return W[a.tm_mon]},"%C":function(a){var f=a.tm_year+1900;return d(f/100|0,2)},"%d":function(a){return d(a.tm_mday,2)},"%e":function(a){return g(a.tm_mday,2," ")},"%g":function(a){return F(a).toString().substring(2)},"%G":function(a){return F(a)},"%H":function(a){return d(a.tm_hour,2)},"%I":function(a){var f=a.tm_hour;return f==0?f=12:f>12&&(f-=12),d(f,2)},"%j":function(a){return d(a.tm_mday+le(_(a.tm_year+1900)?$:ee,a.tm_mon-1),3)},"%m":function(a){return d(a.tm_mon+1,2)},"%M":function(a){return d(a.tm_min,2)},"%n":function(){return\`
\`},"%p":function(a){return a.tm_hour>=0&&a.tm_hour<12?"AM":"PM"},"%S":function(a){return d(a.tm_sec,2)},"%t":function(){return"	"},"%u":function(a){return a.tm_wday||7},"%U":function(a){var f=new Date(a.tm_year+1900,0,1),p=f.getDay()===0?f:te(f,7-f.getDay()),v=new Date(a.tm_year+1900,a.tm_mon,a.tm_mday);if(q(p,v)<0){var k=le(_(v.getFullYear())?$:ee,v.getMonth()-1)-31,V=31-p.getDate(),x=V+k+v.getDate();return d(Math.ceil(x/7),2)}return q(p,f)===0?"01":"00"},"%V":function(a){var f=new Date(a.tm_year+1900,0,4),p=new Date(a.tm_year+1901,0,4),v=h(f),k=h(p),V=te(new Date(a.tm_year+1900,0,1),a.tm_yday);if(q(V,v)<0)return"53";if(q(k,V)<=0)return"01";var x;return v.getFullYear()<a.tm_year+1900?x=a.tm_yday+32-v.getDate():x=a.tm_yday+1-v.getDate(),d(Math.ceil(x/7),2)},"%w":function(a){return a.tm_wday},"%W":function(a){var f=new Date(a.tm_year,0,1),p=f.getDay()===1?f:te(f,f.getDay()===0?1:7-f.getDay()+1),v=new Date(a.tm_year+1900,a.tm_mon,a.tm_mday);if(q(p,v)<0){var k=le(_(v.getFullYear())?$:ee,v.getMonth()-1)-31,V=31-p.getDate(),x=V+k+v.getDate();return d(Math.ceil(x/7),2)}return q(p,f)===0?"01":"00"},"%y":function(a){return(a.tm_year+1900).toString().substring(2)},"%Y":function(a){return a.tm_year+1900},"%z":function(a){var f=a.tm_gmtoff,p=f>=0;return f=Math.abs(f)/60,f=f/60*100+f%60,(p?"+":"-")+("0000"+f).slice(-4)},"%Z":function(a){return a.tm_zone},"%%":function(){return"%"}};o=o.replace(/%%/g,"\\0\\0");for(var y in U)o.includes(y)&&(o=o.replace(new RegExp(y,"g"),U[y](l)));o=o.replace(/\\0\\0/g,"%");var me=bt(o,!1);return me.length>t?0:(Fe(me,e),me.length-1)}function zt(e,t,r,i){return Tt(e,t,r,i)}var hn=!1;function bt(e,t,r){var i=r>0?r:_e(e)+1,u=new Array(i),l=ke(e,u,0,u.length);return t&&(u.length=l),u}var Te={__cxa_allocate_exception:wt,__cxa_throw:kt,abort:Ft,emscripten_memcpy_big:Pt,emscripten_resize_heap:jt,environ_get:gt,environ_sizes_get:xt,strftime_l:zt},pn=Wt(),Ht=n.___wasm_call_ctors=function(){return(Ht=n.___wasm_call_ctors=n.asm.__wasm_call_ctors).apply(null,arguments)},Lt=n._live_start=function(){return(Lt=n._live_start=n.asm.live_start).apply(null,arguments)},Yt=n._live_command=function(){return(Yt=n._live_command=n.asm.live_command).apply(null,arguments)},Jt=n._live_step=function(){return(Jt=n._live_step=n.asm.live_step).apply(null,arguments)},Kt=n._live_values=function(){return(Kt=n._live_values=n.asm.live_values).apply(null,arguments)},Qt=n._live_layout=function(){return(Qt=n._live_layout=n.asm.live_layout).apply(null,arguments)},ze=n._malloc=function(){return(ze=n._malloc=n.asm.malloc).apply(null,arguments)},Mt=n.___errno_location=function(){return(Mt=n.___errno_location=n.asm.__errno_location).apply(null,arguments)},be=n.stackSave=function(){return(be=n.stackSave=n.asm.stackSave).apply(null,arguments)},He=n.stackRestore=function(){return(He=n.stackRestore=n.asm.stackRestore).apply(null,arguments)},ce=n.stackAlloc=function(){return(ce=n.stackAlloc=n.asm.stackAlloc).apply(null,arguments)},Gt=n.dynCall_viijii=function(){return(Gt=n.dynCall_viijii=n.asm.dynCall_viijii).apply(null,arguments)},Ut=n.dynCall_iiiiij=function(){return(Ut=n.dynCall_iiiiij=n.asm.dynCall_iiiiij).apply(null,arguments)},Dt=n.dynCall_iiiiijj=function(){return(Dt=n.dynCall_iiiiijj=n.asm.dynCall_iiiiijj).apply(null,arguments)},It=n.dynCall_iiiiiijj=function(){return(It=n.dynCall_iiiiiijj=n.asm.dynCall_iiiiiijj).apply(null,arguments)};n.ccall=Be;var ne;function Rt(e){this.name="ExitStatus",this.message="Program terminated with exit("+e+")",this.status=e}K=function e(){ne||ve(),ne||(K=e)};function ve(e){if(e=e||pe,N>0||(ut(),N>0))return;function t(){ne||(ne=!0,n.calledRun=!0,!ae&&(lt(),Z(n),n.onRuntimeInitialized&&n.onRuntimeInitialized(),ct()))}n.setStatus?(n.setStatus("Running..."),setTimeout(function(){setTimeout(function(){n.setStatus("")},1),t()},1)):t()}n.run=ve;function dn(e){Xe=e,st()||(n.onExit&&n.onExit(e),ae=!0),Se(e,new Rt(e))}if(n.preInit)for(typeof n.preInit=="function"&&(n.preInit=[n.preInit]);n.preInit.length>0;)n.preInit.pop()();return ve(),n.ready})})(),Le=Ct;var Ye="H4sIAAAAAAACA+y9e5hcR3UvWo+9u3u6e2b2zOgxetfelqXWuyWjGY0Bz5Qwxjnn5MT3nPvl6rvflysZWxy7ZWzZFsTJ0dE0YJPmkaQJCTROwK2xDR1s+JoASfMwbmwIjTGheRgaLMttINBAIE0S4iYYfLVW1d5VvSU5c+7l3L/ugNVr/WrtVY9du9aqvatWkWtvfzUlhNCPOK84Qhfp4hG2uEiO0EUCBF08wheBh3/p4pHEIv7RxSPOIuJuyCuChBJECdDFI6nFxegiepKePJI0PMELT506dYocIZCplax1n8IinFTsKaP4FP6eBPbUqUVyJL24aGWEpTgF1yp1SLqLiycjvSfV78mTum4n4ZqTmM5OQjHZSQDZ4imo00mtN7u4OJSPUkUXj2SGcas05Mj44vAfMW1CjlAswClsYigMw7KoOp5URVTEybBVTyrZRV05VWZHVW3EyoShCD+p6wF1oqfw/kKrQaNDsvph2KLs1Cn6P/Dfk9Aop8gRdiq816foKdVQ/8PKhC6yDk3xoze/dvrw4evuuPbwtTfddMt11544evjoHdcdPX7ixltuJgSSMyr5xA233fK7xAFk5dFX337dbTceP3H05sOvPvrq647/3uFX3vjfiAtpq6y0247efuPvHz18w9FrjytV7rWvvOW2E2Ri1e9ee/uNh2+/+drjt99wy4nDx287+tobj/7u3omjN7/2xttuufkwXHb74f929AThFxHNhKIoBLrTt5+47VUnbnz10cM3kRT/qvtld4IxxnaSCTY+vmvlJGXTCUp3MzrCGeeOw1ayjdyhDnUchzKHUM4cymiSjkzu2TSdpNxJOytJ3nEYB4m9ScE2ErJpOuk4jgOJzkqHTO5LOhOMwv+SoIk7Dr3McSilLnsRpft9mnQYm/HHmeOMbBhhlFLCZpPJZDo5GhyYG3Udd/TyyclR+AtefMkoGSeMU0IYgf8YdVdtTrrcIYQQ7sIPY5QwwgknLgFBTgjnmuWEUBfHg6RDGaEOIcBxwvkqPkFYElRyStUllFKgGSWbCVlD13jeS156hUe9NZ7nJecXZOYgd11OOCi+JOUQ52Ujl9KMy3mGkQy5cvXqJEslHRf+SxBKxzh3KeeMJIizNpNMrE5kEpnE6sTIlpcnRCKZSI67LmcJMsYT3FmbgL+RLYlEIukSQlOEcMZTyZQ7laAuW5FasdXNTJF1qRRhKYAAmVqXynKSSCTSiXRiJJXNckOPpSkfwzpBUXKUO84YkFB74Mfgl/D1ZNt26ibWb9uecNNpwqCJ4cYzaFhGob+4mUyGu9zNuCnCNJFNpVjWzaZShKRINqv+Y3CTqP7Dm4XQBf7HyDjhhFHKCdwXvCUgz+FvBxlxHMel7o4RSpOu6ySTSZ5MOiPpkZGRNBSSEDbOyNTYVWudJD1OP8E+wdwkpUVWLLLECF2ksvm+R0gm+SdsIvHqo6++5bbfY2Ti8OHfvfb2Vx++7tqbbjp83YlbbrudpNI33fjao4dvP3HtbSfIaBaZ62559auvvfl6Mjai044eJ14G6ddee9Nrjt5OJhR307W/d8trTpDJNYcP33jz9TfedvS6E4df9Zqbr4NR4vCJa19501FKEq/GEYQ8RL3Dh4/edtvNtxzGAQUGkk/SkdtPXHvdsf967WuPkq+4WWT+y9HbT9xy21HyVTeNvMTLv+aOXf97N78MCv7aG28s3HgjecIgN8JfgXzdHR9GCuQbrjcEAdZxRwYOJZJmPs5GMtm2+036p/Q99B5aoS36efoY/QJ9nP4dfYQ+Qr9Ev0q/Rr9Ov0G/Tr9Fz9An6VP0Heyd7O2swv6I/TF7G3sXu5v9OfsL9iD7AHuMfZN9i51hn6KP0o87n3T+xflX5+fOL5xfOs87r3Pf4N7l/oH7Jvct7h+6f+x+2Plr5xNOy/m885jzBedx54vOv/K/c77ktJ2a8zXnCecbzjedbzmP0DPOU87fO99zfuD80PmR82On73zf6TnP0yL7B+cnzk+db9Ie67GHnE85DztN59POI86jzmecf+Wfdf7W+ZzTY192vux8xfkM/Qz9qvMZ2mNnnaedrzhQt67zjNNj33a+o/nvOs+gth+wH7J/YED9mP2E9VmP/ZT9it3J38hLvMTfzN/Ky/xP+J/yHvtzfg+/l9/H7+f38/fy9/H38wf4g7zH/oo3+Kf5I/xR/hn+ef4Y77Ev8L/jX+Vf40/wr/MO/yYH7Wf4U/wsf5o/w7/Dv8f/2Rk4zzkl961u0b3TVek/4D/kP+I/5v/I/4n/zPk351fOm90/cl/vvtF9m1t2/5nDv8/yHvs5/zn/N/zfL/gj9Dn+3EWwX/JfauxXL4gVnTc6PVZ23u702N1O1emx0859To/d77zXeYzC7/ucx+g36X3un2E7PUofpZ90H3c/737K7bEvuC33YbfHHnM/6z7i9tiX3B77ovtlt+p+2f2ym/7JYO2X3Yc5ZYuXEOkdC8hmwhYEkdmCIDJV8NxRIv/0nUyQHMtKdkI6Be8hGtAZRgR9+SgBPIWIswByOUZC0YIkM4yEIPUSLx+lGWARzwgivcJmIuvP0l2ESHrry50FWXuWHmw89Kdn3vPmDz798OIsJ7L6LD1IgKicI4rqb6CSymFS/Vkq6eWEZGQLIUZkMyQaIdEOic6zFEtwCZF5rK8goEaon2lBwhJ8Y36W5wQ5+IsaAt+an+XeMJsaZonsPkuvfBX+fX1eEDldEMR7G5WtgS5pOyQ6A3rw7g9/7/F3ffh7Z9SVYUovJPoD0xYgIojMQ4MN3sFk6R0M2rb+Dia3Q2PuIPIjz9IcIz4SWD9BHLiRlZ+QgpcWBP/7FM1kHqOULcJNeuvv+FQQkH3r7wjqLAhUwIS+nDkLgsEVguK/5+50KbqipK8IUyqHwpTKIZWC2nLMmVD3+tF9hZ2ESHI1FCrHGvvUlfJJfwhv+wrfSf7Zi8CeF4KZCFN1OUXZovwM1jwgzgLcf6HqDslw8yEFyyM/qRh2lbMoqMsXBJMrjvlEMDlyzC4CUZn5TBBBXzFKQjUZn4AOQSP9mTVEPvksDS+GLhYW7Ktp5izSU+yUIFcS/Ou/7LqIJuRVt0JmH8rSzEGS8V1Zepp697s+u4TIJj0W0M1EMOFK4k1J6nPB8DYKV1JvSjD5kTO0IMmLKRSezLD6GSoYdJoGELJ5hhawCwkmWxbdtuhOSMvac/D8wcM3GFDv7fB/2csUvD+jkKSfq36RKSGBnbNB1W9d/9b0b1X/VvRvmcr6c1RQWaMFQWWZFrzfF9R+vkogqR+hb5/r5UWLf2x+lt+hFB1XPzcIehCfmcff9c/zs/yIbP4StA8IaO8Spd16rA5ZymHMuMYkfw34q5XaBUstwAcM/yPg87L9K8inhfnkVTb/cO8zP/ty/9+6IJBTeoTJ7ivzMJQg6lnacMzQz3f3edA5XRDU+31oYGxqfTt8nhFMds/QQuDI5nN0G0dFjmxoOiUcaFqk4X4OoEe0noMyeg/QtXC3n6IFWf2lEWkBULGAJgBlC+gAULOALgB1C+gB0AgBtiC4pLeOkot3Hd1zRsn/33H+13Yc6C/Fs7QQ9RbsFXi7LCDsMv2nYKAonY13mu7ZWKfpnI11mvbZWKfpnY11mv7ZWKcZnLU7jRqpik9DHZoUDJq2XBQIwdCzwAFbWy6K/8Gg+uNr2aWLyZPKUVltrmSCeJ+gAZfHf8NZYAvYLTO/5cCPV5DHbw2SMLa6YrVISvAf7rhthqXEauFCXqsFn2FOlmaAupxkxGrfFRx8FeEKIji0TEZw4RYkuZwQwXwiiZ+8hMg+PxYwGKjlZ+6mM+xOBs1zNxoZPsNaVHCZPQa+D5MtWijIr2EamlYYtR+nguVYiw4JBZnAhcQVwgVttACqpgViWeEefH21WOySWeYIKOQM84QrRUESmfM+QNcKV64veH/jiAy6Ssdn2dVDpasDhQXrvwPNGAd/7m8cwcE1mlY/nvpJCe5vUDerr83LADpNaoYVQVf3nXSGtSk2tigE40FarA7cVziLIu29lYGpcPVvWrg5loImTwt3GwMnLMszwvXeyHwqXO9NzE+pe+qi85mS6d/Ey1Lee5hICypS3pcptMHlZFykRBoM4XjBu4fBXUvLNFxxTKR3kUyQkURkREpQ7wNuRrjoYmbZcGYZO7OMSHt/yILUb0CO0JmglBmvxkCJyAxlnBnOWKQkPQa5HZO0ABc7QUoSkBvKXhJXpDPQh+Am7oQGy7F84MrUrc6i4GLceyMT496bWGGG7TT8GxnI7fRej795V7gZ6d0KLjdH6cBFIbxoXIx7b2beW9jQ5ajTewMTfBfJSw7X8gWozdX4aDz//PPPJ707wc1A8pjvZmkmI1yVh+vdyTKqpzZD94Jqf0PzNeAbtBC2aHozEWmZKqi+HIx5ZynclRQ8lCITeW+ZHCPqWcqANnz2MgDoH5IRY2IMhPDJKASpHMv6DnaI9zNVWOEIR5L/tM53xZicLvijIi3vexfz/pX5XKS9jzmS+Cm2yCHnUVsZPJ1OjmWDceHkmPcKZ0GMg8HFUjiAkRzbPEFI4MjFV4wSybIswxaEI6dPyOnXBOOSXA3tk2Nggp+nt0p6orCLUCmgfSV2towY9z7iQvco+Kl/pwBXOQtRtrkJQtaqcoxLWphhWRiDUuiDUj8lScZ3TNMEo6BODQxjAplgFH49bBznNpFad5v3AINHBPqhumdQHrw98CgXvJ/SgENlwtLtIp50waITn7MFrkdTkYR24oLt4Kk5GMIFl6lzPe9BCqVNwjhWo4F7LOCSvybISFoI1EjLfmuUiqTgkr0mSImkSP3HdXj/YAgawH38jXVBylkUqVDaESnJT3j3u64kmSApMpKfKASZKOckphf8lMjIVMHHh+o/OAsiCeOhGqqZSKkuKjJQQsFEcobVqOrXLjr3/34DcKhTnfpYtwepz+HR8G4hGXnvSu84WFvBwDmZYVWKdAPov1B0C+gKDpYFPQMLkt5GrISfYwv2/y5gA6AIDJ90lmOfpILtIo9iKVUXlOTqdTLxCkiGXOXPp2TC+6irxB+k+mbwY1KADN/BSbA1mndc//JRCuZL5MTWqkZTC0dfPurATcVG7jNFenN8oMnpOV7kgtkeUo8JZs99uzG+Aw1R4gWxFVwCBq3dYQXvbVGrtP+BFJSI90dUEH2H2zcJIjuYtI17atbbVZLThSCpXQgiewoThcCNsL7CcoUgFXk0qi12cOLn/ldVMHeRCva+BdbbVNE8PkT2v0XtGg6ANZUrPkkLwtSrBGxYpSzP/D/uNI7pNN9dIZ0LdhrvhToNtJ+NOhfoRkSWz9AC+PyOeUhScINlqhAkcaAjeEtQnbdePyEiTCKQRDDp11TZ941dpLIplMFh8dxP+HYJZhdcF1jfY66aJBfO5eevXydyUUtct24HJ3O8fYb+mgr8k6mLFHg6vDt+DlvP3yoIzvGxPwfbVe+CFwBiK9IiN4dvBYisAagFqkZAVoDOKboM90HLlIA2Soo3/5rq9uj4BeoGycTbIJLeBnj+oxcV+Eru19euH1/1Qh1h6BYT8ipQG7LewnWYCz7a3q3wCJ+helTiZlRSmGeNVPCUp2Z5F+/BQKXDqBWOUAQn6jBLAkcn0tRSYJ8UgkwENp9So8YNOjclU6aFYDyS6SqwRAtBOgI7+sIiVTOyVMEfZYuq+kP9Wl5ndWt8R5V7IEsz4HmM/U++KdJvspzNRDjaeXT01N/RzqOjp/6Onvo71tTfwam/o6f+Tmzq78Sm/s7w1N9RU39HTf2d86f+Dk79HT31d4an/k5s6u/Epv6Omvo7sam/c4Gpv4NTf0dN/Z3Y1N9RU39neOrvqKm/Mzz1d8zU34GpvwP69PzZvAIYFWOyTG8KxuAtQEG/NAKwEbIpZOshS8QoaBuDtwCFsEuCRPWXWuI4spWQvUHlEbJHkK2F7B1Ke8gWqco85EvwDMBLCmEeGXhFIeJPC7yeIPh6QlgPCrycEOYRgVcTwjwc8GLCfjjO2l2e4FsJYZ4IeCchoqcGXvsWn4ZZ8tO/tiF88oWGGjXYRE/aKwN+OfnoGTCyo5cQ2XaPBSObiUgG6p17MnrnngRXF1xY8MqhLCOyygoCK4xPohiBGVQVfmHsSKp5FoJXixEcFrgY2cFrDEb2ERw8KAB1DZDLSYWKEW0M259r4m1F/Br1kxMjks6wzYoTYiTsvx/H/jsCfdETIwef++rfvvOpz1dq2H9HII/quTyKULQiK4gR2WCFIOGtFSPQjwNHjGzjFTaLpWjQQpACoKyBOswnASgpAMgiw1FkBJyFXmaOt5CW/UxBmWPFDjTbUWwxq9iuYkua7Sm2rNm+YiuaHehcyr+DFeCQ9BRRaURAX60aVt8SWXuKFLy1whEJ3c2wQnUsP1alZqpS1VWBthNihJ0UyV0Evt+MwHcvVHwIFGv6CNw5TV8DH812cAIzsRHZxptefjZ82ZaEa/RAkARdehTAnI7rSzNz/AbZ7hHvfjfgfkKo11td/R0ica7fpOA99KfhQQwScNdvEAnVpZxd5AZnQSRgnAtSwtnGr1ZVdbbxQ5ApUtfgELaDH/G3iATkfINIiC1z/EhGJAA/PsePA4X9MxWOFQAU4b6Hg0kCdN0B/RGSKjS0jRWdVKZgPhTdoGhykK5TNDtI1yi2NNJViuYH6T7F91xI9+gsdAiku3QW+grSHToL3QjpNp2FHoZ0i85C50O6SWd5k4ox5aOl4GcrVPEOqHpoSP7h3JNSYSIRupzPzc/yMhMJ8LdK8AsOF1NtNKBqoPfhfUOVFvwxtiC2iC2ng+1i+yvBRRG5iN4qtiJ9rT+aEaPydEZ+chSEl0BqCZKXqtV7vGlJ5Vc8+ZYxPQIN5hF6eq18ZvTKu98Ff9+c96YFBVdlVLliFCZW45q2feVpwxab+qW4lXxAUKy/elKcHbxI5+BdNpAlOgdvuYEsU53xx+ZFZhch6+Z4XiTgUQomRNibkfKgW00ICp1yUnfnCSjcClXGlaEwFH6VqkPGVjANZQYFB0If6YBKyM/yvJiQC8cElQvHopkl3cHzll94vci9K/SXFq+7VX4xKx+eFDlvWrjDDmRc8MEJ+ZYxFKQ7+HSAdySDlwC1MqSq1XteQMlbp+Q7N6KSNF5gJcriOvmGcUybxO4niT/JFgS6eNvF9tPBVrE16jGapjBvwG6zVWy91p/MiEn57THoNtvFdt1tUEYXzZsWE1HpV2nNS2IFzhixewVbTOGdBTEhtoot9wRb7p3jOTEhtgughJgQOaSmM/gtI8iIMbwz0NG8QpAG1lNsqhC4wKaQFWPhbQl72Z1N9KMSsscKwVTUWaZAbVZpn4gwrxBMqixWRFiqEKxU+awKMaizgHLCb7DNuh3bhm7HT+ApEtvUPSXBNrFNtwpQVdUsCE5EYPWeSF//4eq7rnzuL3/6ld985TXz18mHM/JeD5VNRdetjBoWb6pq7SxQ8FhXq3ZXcRbElNgicvcEOWhZMSW2C6A8MSW2IpUSU2IbUiQjxkPD/QguLxgN2/OtzeH2RX7afKJ6ZF59m1Kp1QeaRH2c0uLvU5cnZJlj++smzaqnU92JHLIifICF0PdJ3ZNpZL3wUfaQje5OSmRlHj55tAh+88CGt/qc2DJ0h+5cIasbxRZvWt2Xiwt+LxsKrnxhwTevDQVXLDfryeVmPbHcrCl4wjhgjQOVwzsIlAAqAxQ+TWmg8EFygdLPUOqCz5A1cpeaOCwmZMmBhzG8ielomEQqB3cSKQE3MR2NrulooE7rB1jfunQ4utoKD0BWMHj62yXx3XDIQiOnhyl7+BoasjQwHQdEHMjFgbw17OHHmmdHImuJTxnmA1S1qrIIUaFQpTUE81oUh0i6gx8ItpuZtNg+dBtfNyrb68R2JbjwAoIPrJCf1oLhnVmCO9OkBig3ww/rGrivGX5hD83w8+EndhuoxIFyHCjFgWIc0F/ZO3G8TWMFblnAx5vhl3/7kuPKD/CCLSK5g1ezVeUwbBFJWUM3vKrcBgDqIeBpoBEC0xpohoDQQCsEchpoh0BeUMixkxVbTs+BuwJdNCm7mI4YlCMpewa4GoG+Aa5BYGCAQwgURyPgCAIlA4AL3XbQrdtFpnHFlKMnKhlVovLoHLZKUlZG1eTiDuSqmoO7Aa2j2ZJi65otK7ah2QowTWT8Labp3x/vTe+M9ab+A7HeVP98ePvAO61S9elvzWYiUoEbDRQurncINiKbRzZXCDbpwd9Vg7/Qg7+rBn9fD/6uGvwDPfi7agS5RI8grhkxIk9ts5UrTEQuRf5q5GFGNIr8Nch3SDijOIR8l4Svz44g3yOFwNPvOjCv49A3IaVKC8E0plQpAjADmQpnIK5apxJkESgrAOYzE+F8BgCYz0yG8xlXLUHRVu8OlZ2eoLg45V0JSB1fYbg4KQZ/Fn7XhTXGuXNKraUI1tvtEE2PWiqndvRKsK2ADi0EaxGA51d5HDBwXSc/5slHR0Kv5rjt/sh3p+XrlMNzibpi8w5O7CuUy3PBKwJ1xaWxKyYvfoWvrhiNXTFx8SuEumIsdkX24ldsUleMx66YuvgVG9UVXuyK6YtfkYklxbzI51eFXmQ6ruNf02DxIWntcNKr5HvWyL9dfaEkcAS3ifVqQrFOO5Aid926YMuSMTYLR+W9m2RVaVgDj9haEXagNSLsYCvFdvAYBWq4ft3dS96HaZA7LbaJUFF3fin6LFJdCraBcylc8EPvXhLA1ahYJdZEL0HWmk66g3eo6nQtiprvxgtaNCPWqG/WCXYSx8eXOws6k4MLvvaPiq9awI/l57lMmr5iYcl4xwtHb9XVBe8pFwlNN7FGW09DgS9co9y9/hYRfg27orkkcvdm5ng9Yebv96CJswB0mZsJNYNvJIaXpl0zzMJaMutd2QE1+BfHQrtTGisEKRzDU8iXxwrBGPKeMg5jhWAU+WllHsYKwTjyQtmHsUKQQT4H5mGsEKRDI2C99l5Q4znMuduJQuBFI7mnRvIJPZJ7aiSf1CO5p0byFXok99RIvlKP5J4ayVfpkdwb9gW9aCT3opF8ysoVRvJpPZJ7eiTP6pHcE9N6DPdEVo/eHozdkshqAucF07GPmGLr0DP3q9XwYG0Nx4aLCz6yIhT0Dj7+7HMf/t7ba/AhoZTEwdLfKjxZ+izRq8M8/JSRVL9V/VtLCg/XzSSFF3UseKKq95ybnZUhtYoa5KMMi+7J73yOFPClPtTqc5h2Z0Kn9b+IfI2a6Y9VevlwWn5wEsvrXjxp1cWTVl48acXFkyYvnjRx8ST0ky/e9J102PRTL3yP3jkJ72Aiwe1RK98fjQz9ecztnnuDrWKL2Hr9OuwgwojetxRsx2Fu+/Xr7o3yqr9kSc/Qj8wflZ/eJN+vCuQMO1Lth5v4eAzzuRgvYvx0jPdifCrGw6y69wQpiC2CelvPDTfgWBwSCVnshB0Q38t2fhum3x2iv6ImZMWiqxZds+i6RTciOqqnrh4ZWrRKhharErNIdXiIg4lkExyv4dcB1rCSHR5WssPDSnZ4WMkODyvZ4WEFn8odIgvD2YLIih3g1GfFlrsx5V7vryg48FkYTiSR/6ReImTBX5Lw0htZe9YtLNtyq3zdGnl6TM3Aoe9efKr++ZQlaBuoVxnBvDx6q/zgWvl6Nad3lyu4armCK5cruGK5gpPLFZxYrmBWNxAuzMmqRtiBS3OyqqI7cXFOVlVm2xwszsiqAufmeBkYNfjM8QowmPH2OVjAk4UX6l34zc3Bgp2s2DbH2/C7c463mOocTab6SgN+t8/xKhcJ2X/KPAw9i+4aGie+vxMfCJqfHB4IFJ+L8SLGT8d4L8anYjwUZfCUHghWgM3uEvN5MyFbwGYitgnseMQ2gB2N2DqwYxFbAzZ8QZSAb7PFsVlePSISstO1LVFCdr+H/F9Szbd6Zhhq9qzhxKLrFl2z6KpFV3pDrVy+QThy4Zj6IpaQna+Tgp8UjhQwe07sIsVDiJ/LuHgoE96QpEjpD3JIeeA+ITUttiyB74RMCrympFpCXfr3nv2fTIePdOqFX9N9MCXPbggFU8NPAV579FZ5/5QsRzLTF35SUNkTk/KhSBBej6AC8BFTduG+v1L+03oUwy9s0BJUdmGBgIi+IsNSd/iKDF+O8TMyfDF0YYk07jep0II/Livb/Ixa+inGYT0Wrim1l0eqr+CwijdIw7p7F+QcWI7qiFFYhD30URw+d4/Cym/1NXw8x1JaNMfIMZm6ahRWzMIAnpHNbbjWtbnNz2QErIQHAJeeZXlG/wgi62fwM7abY04hWsRiPqZD/4OF+6tg5am3CtbOJjPhB3hc2M+gIR6kgqvVoDvJo1QtTWY51qB6iejjL7CUv2Mt5dcL4UHNL4yavlKzwWvhxoo7WcH7HCwN7HO4I0mfi9XRgujV4aaz1WrSw8cz3jjJpIh8zwpYbPotztxFehJWAfwHZ4EvRDsm4Cst05sQ9IaJgKuFpiRalfeqcNdW+wxWnXq3CiqYtw7G3fYZGiSGJo64oEgkos8SS7KXk8VtamHjALfj6KWbsDTnj+A9ENvBBxTXbtJo7WaRqY83Xc2XNN/TfFnzetFmhYXLT2DxvA+LJf9fFBCXXjqmiE5YRMxRr70MSzjQfFhCXH1plRCXXw6XkHu+2uBYfJriQm3czqKLawqGE9wztDoH/0JPYXB3XVge7QoCXT2TeYLBvT11CZFCfW4HX0bfYO814Q5GB1aJD+1gdJa5g9G5wA5GZ2iHJNQjBbtJcXPjNpadhR04MF8JfbqL7rDES32eAQGgVwSYBF8BfFfpWI9XuKgTtpWsEByXklNYAo814cusCYeaYI4ZH2bGHBa+g4Aung+pUuCAl6kl2Yhq1jLVm5ovsFUTbZX8mt4wCwvdngQawLYmYLwZEHNHGJbrjoDDz8nAvWpUbcz1EzhiJvTWW+UncxjnOAyJsBI2HBIDZ13AoBNQefy31F4C4idxMThV+5aYnMB9SynYtwSLo1PRvqU87EqdYTlYKzXDdsILECLY5eQyQWSu4FPBcITDVffCWSeYfqYE05YZxKSA/Qm4P5nnWNb7GDALxwKGqVCzab17eRe5JKB2ySFxPbyrXud92A3Q8Xb0UAg3nhG1Cw42+cAODcTlgTBHGBnJDLtG7SPBlVf4CuBq1WIHcM85lMlTZYKXs1AoWEUHO81VOtlFps4vVfaFS3XovFLBnCltF+v4ULEOBSPwDhgLdgj6gxh5H6yzgqLsJLcHDLKmmPVNgsFWEEEh+7WYHHXhG8K9y9dF0KEQmoqgVAj91wi6OoReFkEHQuiSCJoOocsiKIcQlyvQSL5ilGZZBg0KJN5JA3gAlSsQWkDs0WrXNvbq2B5pPvxc8vC5pIIHDJ9KUJDxueqbJ5VW/bz5XD9s8BDDgIw75qA5ObgHmecfo3znYuJkAh7WonssGIWH1Xs7DTgayP+sShst1eNqL5nq+FAUfMq8D7kZDoKebNGbgmQhGIFtK7gQF79NjoAji98mkcJvkyPQ2ZPwPOg1hiPgVeFiJBTCpUZIwSpCWLkGdIni23xcOwev48zCSQ8eak8mVZNAmUuZWV6CIaSSKZxziiqZQrQCsYxI2UKqiFQzBbPksZLFy7LWZYiULaSESMlCiogULWSAqgdWZn1E+gaB4vYys7yni17NzvJqFtaxobaapa2OSN1CGog0LKSJSNNCWoi0LKSNSNuuyyjWZdSqCyJFCxngVQPrqj4ifQvpIdKzkC4i3exQfTvZWfjuh3R5dJaXR6HNMceKlWMVkaqF1BCpWUgdkbqFNBBpWEgTkeboUBlao7O8Bfm2MbVtyXcQ6VhIF5GuhfQQ6dntg8jAQvqI9O3SjmFpx6waIVKzkCoiVQupIFKxkDIiZQspIVIaG6ojTCCLY4pujM3yxhi0Bko2rWtbiLQspI1I20I6iHQspItI10J6iPSGy9Afm+V9yHeAqQNLvjiOfWzcqgUiJQspI1K2kAoiFQupIlIdH8q3Nj7La+PQ5phat+QbiDQspIlI00JaiLQspI1I20I6iHSG8+2Oz/Iu5NvD1J4l30ekbyEDRAYWUvSwTTyrTRApWUgZkbI3lG/Fm+UVD1oDU6uWfA2RmoXUEalbSAORhoU0EWlaSAuR1nC+bW+WtyHfLqZ2LfkOIh0L6XkFfyRuZUYiKzNiW5mRYSsjie/FLI0sTRRsawNrgIsTBW1xgBt4BW11cNH1RMzsyA4gaHogvauuvUNJ9xSnFrKPyL5iS5odTLygEZL9dYXQEOFtXR+3Q4N1cTtUWn+eHSpuiNuhwfq4Heqvj9uh3vq4Hequj9uhzvqYHZLt9YXQFmFpNhRCc4R9bkPcGlU2xK1RdUPcGtU2xK1RfUPcGjU2xK1Rf0PcGvU2xK1Rd0PcGnU2xK1Re0PcGrU2xKyRbKpqdnQ1B4oFo4S3bWPcJpU2xm1SeWPcJlU2xm1SdWPcJtU2xmySrG8shHYJm2Vj3Cw1N8bNUmtj3Cy1N8bNUndj3Cx1NsbNUmVT3CyVN8XNUmlT3CwVN8XN0mBj3Cz1N8bMkuypaoJpwpbZVAitEzbLprhxqm+KG6fGprhxam6KG6fWprhxam+KGSfZUVn3ddbdTXH71NsUt0/9TXH7NNgUt09FEbdPJRGzT7IsCqGNwvYXcRNVFXETVRNxE1UXcRPVEHET1RQxEyVbKuuuzrot4laqI+JWqiviVqon4laqL+JWaiBiVkoW/UJoqbBZ/LihKvtxQ1Xx44aq6scNVc2PG6q6HzNUsqGybuusW37cVjX9uK1q+79WW9X3z7NVPd+2VV3ftlUDP26rmoFtq1qBbavawZCt6gRDtqobvLCt6uwcslW9nXFb1d0Zt1X9nefZqt6uuK3q7orbqs6uuK1q74rbqtauuK1q7orbqsauIVvV3zVkqwa74raquDtuq0q747aqvDtuqyq747aqujtuqzq747aqvTtuq1q747aquTtuqxq747aqvjtuq2q7h2xVd/eQrertjtuq/u64rRrsjtuq4p64rSrtiduq8p64rarsGbJV1T1xW1XbE7dV9T1xW9XYE7dVrT1xW9XcE7dVxXzcVg32xG1Vf0/cVvX2xG1Vd0/cVnX2xG1Ve8+QrSrlh2xVOR+3VZV83FZV83FbVcvHbVU9H7dVjXzcVjXzQ7aqlY/bqnY+bqs6+bit6ubjtqqXj9uqfj5uqwb5IVtV3Bu3VaW9cVtV3hu3VZW9cVtV3Ru3VbW9cVtV3ztkqxp747aquTduq1p747aqvTduqzp747aquzduq3p7h2xVf2/cVg32xm1VcV/cVpX2xW1VeV/cVlX2xW1Vdd+Qrarvi9uq2r64rWrs+7Xaqs6+82xVe59tq1r7bFvV3Re3VbXLbFtVv8y2VY3LhmxV87IhW9W67IVtVfOlQ7aq/dK4rWq9NG6rOi89z1a1r4jbqtYVcVvVvCJuqxpXxG1V/Yq4rapdEbdV1SuGbFXniiFb1b0ibqt6V8RtVf+KuK0aXBG3VcX5uK0qzcdtVXM+bqsa83FbVZ+P26rafNxWVefjtqoyH7dV5fkhW9WaH7JV7fm4rerMx21Vdz5uq3rzcVvVn4/bqsF83FYVF47ZtqrUJHFjVVaQba0qCrLNVVVBtr2qK8g2WDUF2RarpyDbZHUVZNusjoJso9VWkG21WgqyzVZTQbbdaiBkDFdf86HlGqhLbNNV/DSJ266SgmzjVVaQbb0qCrLNV1VBtv2qfZoMGbC6ErEtWENBtglrKsi2YS0F2UasrSDbinUUZJuxri5BaMd6SsQ2ZH0F2ZZsoCDblBUfIXFbVlKQbczKCrKtWeURMmTOqkrEtmc1BdkGra4g26I1FGSbtKaCbJvWUpBt1Nq6BKFV6ygR26x1FWTbtZ6CbMPWV5Bt2QYKsk1b8VESt22lR8mQcSsrEduWVRRkGzwyw6ovE0Te92i4zokI2K4BWO1RUvD5Qerv5/B9e//7IE6ZoAevKAl618EP/OqJ737trl/WOuSU2H8yQCPDxf6D9GQwc3HJGUuSLUty/0F+Mpg52GD/BT+bqSuwbP/OZc5Jfz/EOAMzDG39dRVaDjvDN3CV17+olZLhNtHmfWqL4DCfj/G5GC9i/HSM92I8fPGFBavRogoxClHbVnhvp34S/sGYDk+Sgr3lXIXUMlipGXYXCyyGYM8C7w7BLoDWqnzspZbg+0PBtgXqna9kaFNl6//EIoskTLRVjA4iK0+qFXjTuvchOxQ3SJa0SEo/pEpEWM5D+Uy4So7IkkUXLXrwpKH7Ft2z6NYZAuE4bC+kqSDbDWkoyPZD6gqyHZGagmxPpKog2xWpIGR8ERXchMjiU6Yx++GNPHM+1r8A1jtzfifoXgDrXABrn4clD+roOORyMnDUb1X/drnm9W+HiVG19hnZpiNGD6qNFY//YH6WNxyztRoKW9Nqevrymv7tMvW7AD8vphd/slS/yolRFS1k9OA9b/7gH9/1je+/bQGfJ1gNUndkKQ2LR0YuIXKhEIxvPuc1fmoVIM4lRFbZsSCzmUgqv52Rp8eihwujQHw7I99uQ9h9AxYkYM3jHmsRr0jA4sa8vawXIC/YNwTtEXuWRF7kl8Q+sQ+3v++x1y0WU7IzLvbAusWdZDpIS3qVSMvFq25TQUgIBmoVSQwoK0UBg6rKRye8S+QnhLdZuDJfUDFw/3gjsgvHEJMfEd5mtaoqCddDzCvGFkRSriwEBJd8BhwW76Ql+c+4hmeXWh1DCxDgV6SP+WlYLQeDb9r7uCtcvBSi1KW8HzFUgIu52hiXHXL1LlWst4XAduIuwQ1MsF3YqrDQdOlR2JH01Dr5gxVQebYoKcjmLNlrR8laScILSH8eIpKtDfnCYOFoRj42JX8wqlpvF2lDyP4ELEu/QIZq2fVnV8HWC5SXC8fwji5DdAe/eply1yxT7tAy5Y4sU+6GZcodv7hcOWPJ3bFMuSJdpmBpuYLl5QpWlitYXa5g7QUEfz4JW3G0YH25go3lCjaXK9harmB7uYKd5Qp2X0Dwj9db7dhbrmB/uYKD5QoW2TIFS8sVLC9XsPICgvdl5YfXRf1xuYK15QrWlyvYWK5gc7mCreUIZmB0rnA1OnfsK14l9qCJOHqr/O6E/Nb6qK/F1A7tCKhNyz9YGXU2dp5R7rPzrfKADZtl+dyE/NL6842z7kb84rV6eBr22oXdaLmC5eUIZlS0NFych1QKA4dFEdQS27jw98NPzp8RiT0077vATfsQJItcTtpM/R4QjnBfTPPCETMYalHsx1CLMFszptKBCFCo4IDakJzA8IF5RR1RkQoSGMhMKOoaFZ8ggWHOIDRBIgxlooupQ4ohXaEqqiXQOjQZ0noBIdJ6YSHSuNwQKQw5gJQOOYa0DjmGtA45hrQOOYa0DnuGtA57hrSOKqDKwjDamCoLm4WIY6osbBaijiE9oBjuH2kdGg1pHRoNaR0aTdWVYUQz1QZsllc1DTHuapqG0Hd1TTfYLGy4UuVns7AJS9WLzcLGLAdc2zbLqLvZ0Xe1wnGRND5L4A86kZeqdm3t4MLPi4zajpg5qI9JqfGCP4YbxSFAs7rfHaZvOKzJ15uK8Q7KAQs3JQ6wSBDaWYek6ysAokypnVY9BUCcI7VxscwRKPFwIldSQJGHgSKKXNWtwlU1fPd/phYqhvmYqcGYMGVXpW5Bjqq8TSBVSRtAqjJ2gVSl6wCpytXmKu58/srL8O+r80tzvM4RUU9qG5AaIBl8Lhua9FRGYWzTzrzKwg7Y2onxbT4ccrXF8cHfwXNzvMej573Po0FgwKORoejEosFCsPuKgxu4OL6hcPSea8ee0lWTOvys/m3o31ZMrqnxtv7twEazblq/7nFkYyQi64YcpCKynwp3zspehNo5dLXmnv7t698B5FQ0V5cMWTZkxZBVk2l3oyngBlNAQ7Y9o2zCKDNkb31E9g05WG/0btcvhBzZ2Bmh5R0RWTJkb6NRZsjm9ohsGbK93VwGzSzPqG14DrwalxBE2PsAxeCHpX3RRcVdBXt/MRZ1Z1S+/s7CwY9XHnnbTz50dukKXb3zoe75UOd8qH0+1Dofap4PlU1pK4asGpJcTsrQd1tZqGaf6FqXd5kW3WVUGLJqyJoh64ZsGLJplLUM2jZkx5BdQ/YM2TcaBgYt7jbd1JBlQ1YMWd1teqEhW0agaciGIeuGrBmyuMcUx6B9Q/YM2TVkx9JrNFT3mPIasmzIkiFrhuwaDR2Dtg3ZMmTTkA1D9gzZN+TAkMW8KYMhy/ko44pBq4asGbJuyIYhm0ZD35A9I9A1ZMeQbUO2rIz3muLsNYU0ZMmQRUMOLL1GQ8sINA3ZMGTdkDVL7z7THwzaN2TPkF1DdkIyA0EI3JDOFYJsSItCMBHS04VgKqQhcqSmQ9s8GDU5G7JnyCIEXRFhEEoHQ7pMatONbTZWCJLRiQ8OfEiMGsOQrZBMYZigOVWT0QJuf1cc7A9IRlxtzNwrQ1bGorqnrDCKDnyGi9rdkHVDwvr8jP4S7+DafFMFWJdvKtBVkgd0SwBnYv45so9Ay4p478DS4HD8HoxBuSpMl6s6gVFdXM121gyl1vYV/LTymvYo5xB9+4x25g9EzjzEnFDOPMSBVc48RPpM6JjFK4wzT9TlB+D2prRrrjFw2K9RJPjxhxQJ7v0RRYLXf4MiYTJwXJHHIcJOJvToa1TRbTVbyIQefUXTTTVbyIQefUnTdTVbyIQe/R2K7CmnPxM6601ND9QkIRM6921Ng9Pf0TRMBrqa7qoJQyZ04vthVgwnA5nQiS8yXTQ1eciEjntF0001wciEE4MeHhOUiSZ9qYV7g3wUZ3gp2BeF/l0KLptTai6bUyoum1NZ5IdlijoNi3XZnCpqqOfz80vBi+ZUtV40p6r6ojlV/fywTEunNfUvNuO+OXWH9s2pu7NvTt2Z/Jy6K/k5dUfyc+pu7NNO86PzS8HeObzle+ewE+ydw26RHxY4pFKuESn4IaoGPV2CutZ8hxJaQP2NjXf96H9rvAfaCqKZYJHy6ieH+o1AHuI+oYZp9eOpnxTcAZgyB+6LqSMyMD82G6v9fSIdxYBI62i7KRGG4fUUpWN7juk9dWPb+AF/P/zk/Rn4yflUpMUeKHUaptoQHHRGRQvdD49iGp55SWRHuXjpgxi3KW17x9co9Ab1U6TDqccVXKLqtxpLLmu8pn+bsfS6xlv6txtLb2u8F8P7Gi8ynT8TaVljkeUYLoQWqsLJaq97/Z2wt1qkFUUegCvrsBdXxTxwxZjY420TaVmtOgUJgfkQgL2QHXIsyMI3Bj8J8ey8YK/Yu4THnQWr4c29ZkUhmA7ZahUkc2FSvhBMWZIHCkHOSFb9vEjL8qdScF5S7VLZoxDeHT5z5AvBNhXWkOFnj1wh2K7mt4oXhWCHmt4qfroQ7FSzW8V7hWCXmkJT5FOFYLea0SGv5s6aPKAaSiTDsbfGVMLV+LIAyWvwXQGSh/BVAZJH8E0BkjfMQlQXUFI1ARc5AhUTcFEBEKNxRTjBBwBiNK4MJ/gAQIzGVeEEHwCI0aji13V1hsfx/CcXp/5rAajpGI0VXgjWARAGbazyQrAegIYGarwQbACgqYE6LwQbAWiFcR55IdgEQFsDTV4IBAAdBGCVGhxmmITR29+Pi9iYPwO/A+rPwm+f+gfgt0f9OfjtUv9y4cKTWXTgSA1eCHxxudLe5oUgEHOK6fBCcIlQr8NklxeCzWJWMT1eCC6FpxmYAS8EW+CZBqbPC8FWocqKYyNkUXbgsxj2qbXC1b5PLSFc/RqiCqS6DxUg1R0oA6navgSkavViImr1gQuFTMIg8g2mj7wcpLXn4Mp+OvYd14VJZRzqwgmS8F0uP6cqnS4ITbYN2TJk05ANQ9ZDElYY+nvR8fLzwg2ze3NTxYBz8QUrRgx0xV79tqcIQzXCvYRYA1fuFbsvpKBmFDQurKCfwDhJ/l6x60IK6kZB88IKBgmMreTvFTsvpKBhFLQurKCYxHhM/l6x40IKmkZB+8IKSkkVsn6v2H4hBS2joHNhBeUkxn3y94ptF1LQTsK5ly+mRfgw25nWcwZX1ldHZM2QnVVhh8LBHq4pZ7QX7MruqojsGbK/KrxcF7R74YJWoCTdacsKunIwbTROn9dbi2ui1IohS2vOE6ya1IYha+cLNk1qx5Ct8wW7JnVgyN75gsW1pmBrz0utmNSqIZtrC0EyKuX5VzVC0WRkRV356NqCtqRY5LXWVMDFHYiJMNo57j5M6PUzrn6l2F0PVVlvRXpbCyNBKshjDNUleJrXiTwGTUVmvchjIFVkNoi82BAyG0UeA8Eis0nkMY4sMkLkMQwtMr7IYxRbZAKRxyC4yFwi8hhDF5nNIo+RdJG5VOQxSC4yW0VebA2ZLSIvtoQM+AUp3FcXHo6Q0i5cZ6NI4Qa38BCFFG6AWx3GYMUNctOay23jxKf4Hlg5c/BtJQW2orIJAo9sKqhRP4Vb7/YrEvblUUVWN+H7q/Xwmm5MpOQni1Q/PilZfkkhmJJJxVReAoLffCkIJqAQP1cxL1U0sZRswoVUybZQiSxuAOHVIiX/5RmjtfVuWgiVtt9NI62gpP4kHVI6eMYoLX7bUjotUvLBR1mktPi8UVp6flhp75NsSGkdrtNKG6hDKYW0797HI52NLot0NrtsSGf1PXxIZw+u0zr7qMPo/Is3OpHO/qd5pHPwaT6ks/P8sM4qXKd11lCH0fm17xudtXudSGf9XmdIZ/kZZ0hn5/tGZ/f7wzrf+nk30tm904109oC2dLYecYd0Vj7vhq82ZBl0aP1VC69ZuutIy2IyvB9tF47UI5eTlBqzPfwhKxV3QB3hnFfgSxV4RIGHFHhUj/X6tGcIzg3wH6pfmDggXtP4RzXf1vxTWq6jf8ERxqVjOv0uzYOre1A7uYB/QOMtjbc1/oTG+xofaPyXGq9whVfVL7mfK7yp8ZbGv6j5vk7vafxnGq84Ci87Cn+3+uVNjTc0/lmN9zTe1fiPNV52FV5yFf5nmq8rnjc0/pDGO5r/e53e1Th4etjuCX0/ErrdNf5Rjdc13tb4UxrvaHyg8buS+n4kdfsndbtrvKbxlsaf0Hhb432N/1LjA8ArqchTuB+/xiBZTRnLZgS+aARaRqBnBH5mBPpGoDwSCbx7JBKojBgDbwQ+awSaRqBrBH5sBHpGoJSOBP4sHQmU05FA3Qg8ZAQaRqBjBP7eCHSNQDETCfxhJhIoGVeqZgQ+agTqRqBtBJ4yAh0jMDACd2UjgWLWOBzZSOADRqBmBFpG4Akj0DYCfSPwSyMwMAKVUdMfRk1/GDX9wQh80Qi0jEDPCPzMCPSNQHnM9Icx0x/GTH8wAp81Ak0j0DUCPzYCPSNQGjf9Ydz0h3HTH4zAQ0agYQQ6RuDvjUDXCBQ90x880x880x+MwEeNQN0ItI3AU0agYwQGRuCuCdMfJkx/mDD9wQjUQoEUjhrfhsPb+eXkTiTOGZ0iEAcXZ/ngGRdleB8I+YffdrWOlPwzi363Rd9v0R+w6I98Gw0aUZny4ne05ibmZTnDDSxF6TuWjbToikVXLbpm0XWL7lt0D+ghtzsluxfAOhfA2hfAWhfAmhfAGnFMEn/FJUTmjwUrNxORDf3JYAI8iP56MaGd9tKL0eJDfHzH3wO/02ri7flwcltrJPZZeAK/lw9DOD+7B1/xTsD6JwGvw5YA6bAQsV4269RgD87UJ8Avbrjqt+RwON9shWykbgL/o3cJLPNfgUfWT6p1bmKPctUxgsqkWgYFwOQO3uL+XniIN8OpHnuil+Pt+SV9CUQ+2avfRWwuQDFjIithX4GL4U4mPNBVuxQ//xwSkzB671D5DFxdCbEHpvleVb0OhFcGQO7R76a/M7+ExQ2wAa5fh+fvrIBNjyv0pseVMg8rmsdEFmLPP6C8fQjjAHxBttbhu54pkc2x/npw1BLwfWiwXvfNl4BgcUMhmoTUEClZSB2RsoU0EKlYSBOR6oaCbCUww5TazJOF5pctqrH+ZxBrX2qu7CmoZUFdBTUtqKOghgW1FVS3oIGCOpdaxWh+AbHqTqsYtS8iVtptLq0qqGhBFQUNdhmorKC+BZUU1LOguoLKu61iDL6qivYiqxjdJ1Q9Z6x6KqhhQW0F1S2opaCaBTUVVLWgnoJaM1YxcHNIVpZfahWjclbV8wqrngrqW1BJQT0LKiqoa0EY/joL21hNyyqp4rxVjN53VdHgfIWoHO3vqYp+jlg1VVjNxpoKq9pYQ2EVG6srrGxjHYU14PCGqDTVH6sS/p1dmtI/qvp+ybq6qLCujQ1+ompsY32FtW2sp7CWjZWVvv6X7NJ0fqaK+HVTmtUH3/yJ+4ofeMfjX4IzqrEeRVoQY95OkZJshtXarpg++N4vt9vf+cAb3rigCwFzbAeMahZPItgM3ztKS2PRe4G1Ii3ve8O4nr+l5eBTY3pumJbFh8esuWFadp8bs+aGaVmD66iSraOOcL6Zlme+a3TWq+ORzkZ1fEhn5ez4kM7ud43O3neHdf7p33qRzt7rvEhnH2hLZ/thb0hnBa7TOquow+h8/H0Tkc7qd4zO2neGdZZOTwzpbMN1WmcHdRidd75pMtLZ+cxEpLP7mYkhnc3XTw7pLMF1WmcZdRidn/yh0Vl+72Sks/LeySGdg+8M62z+0Ohs/XBY5798YSrS2fqDqUhnG2hLZ/2zU0M6B3Cd1ll8fGpI54MfWBHpLP7A6Cz9YFhn770rhnTW4Tqts4E6jM7v/tHKSGfjsRWRzuZjK4Z0Vksrh3T24Dqts486jM6/6Bud/QdWRjoHD6wc0tn5wbDORn+l9tHSsmbR1b7Jq27hHaBLcBYgVUAbgDfChjMt0QLgTjhIRANNAF5fLBbziv+kpbqlDmbr9ldC/forC8GYbIvw47DsA+LKjkHI5eQ5FCYzbAAEOrQ/BaT0U1PMskVXLLpq0TWLrlt0A+ghNzItmz/FZuuHzdYanC/THqBMDxe5sJMiI51CkNhFqDlR6sqmHy5yFU1YqRB+zq1/bEG1gmsDRIwNs2nZ7a8swMoTAq6fnmmozxB4DvQ+WK/T7a/M+Htin4p/ulLsEXmxD73OfdetCy4TeXHZ9euCy057f0X9PWKfUNQ+qO5gZQGSAYCvCXBZ9AG/Wq0GeTx6Ky0bILhPhGwd2D2adWTvgVXRip7vPrAqWj9FZlj3gVWwOscSGFh06UFDFx9cpc8ncmTZwisProqW8VQtvGbRdYsmL6bNByHTBoBh0yjb48jPoDb5Vtes6+18CKTbH1oVu9OO7H7IqO1ZdN+iBxZd/CtDly269Ffn665Y6VWLrll0w6LrF9DRtNJbFt226M4FrhtY6X2L7ll016KLHz5fR+nD2JCVZLik6uNWm3zsfPmald6w6PrHL1AvK71l0e2Pm77VsfCuRf+9otWCRJSXvXBhV/ehSM7OsvMQdIDeQ1ajWHTxU1bFHrpAQ1jpZYuGd5WfWqWXjgMhK586/2pnhlUh0cuJDBxNvhlC2jjqGIgqL/iOGIF9pkm2INgu0oENP+NwKHwe3kEjlVMn9jq4gianqGlYS4OUB+trkErBO2ykYI0hDErjQydBHYjx+Rifi/Eixk/HeC/GpzIiafbcj8Oe+61iRDBYC5LUZ5GOSPWR5vXqS9oIHJrg4aIRJFO4XgRJtVSEwe4dXLYAH5oY7N6ZAnDanzmnC94KQ/s1WSFIqn4zIqZeTBugYz8uBhnBYAvwO4OrRphe65cELbhmASncwoMUbuFBCrfwIIVbeJDCLTxJwcwWHiwsrNqrcUXDYr6qpsG2VjQNS//KmoYVgSVN34HLTJA8jm/tkYRlG10Nw5qOjqZhwUdb07AapKVpWCrS1DSsI2loGhaZ1MPSMHx7PxKeXFHWNKzzK2ka1v8VNQ3rAgf6Wlgv2Nc0rPnrhbWFjTtaHtb/1TQN6//qmob1fw1Nw/q/pqZhzV9L07AWsA33ksI9zaibW3UhQpMT3Vymd8ThrVC7WZDssuhODGCtoavLD2sQtf4erE3UdJnP8oqWKXH8EqHagc/ykqvKUHV1GboA1Fy7DB1VBkf7Mkn9uOYVlVMdyNEL3pL6cZ1WlKc6kKMXy2Fe3TCvagICPriFwDH1xWM8sJIcBxSsgAO5IVly1F41KL6j9qtBK3DIEMk+VzvjoA14lGU1kdH3zMElNnDHHDgJYhuvO/5+SXBcUl9FRmQzYT1f+2dhUQk+V/UEFLHvhLek4US3pOdET1TXiR6pjhM9U20neqhajn6qtvGmExVxAEW09jkVk5BZzfGTqmRvSkJs/ctJCX8buJ5jRFZwnU9fGQS2g1edYK+1h3Dv0KbIb62Cw5n2etMgWX8hyb8Zg12re71pvhDdFdhhxk8UdvAut6+U316jZTNR60SiDTuTV8m7R+VntagDr80c/dpsXC4cgzNJxMgMeytEuYC3IGHsjbJFlyy6aNGDp6wYHk+RQuBoDsKs6Sga1f8LwlicPS+QR+vseYE8mmfPC+TROHteII/62fMCedTOnhfIY/DjKBAOeH2tmyDAxllira8geFqQJPIHRPPln1hVNjROGW6GeCFnScGfCiPqJHVMOHinOiL7X1c19PDlJvdWLqnIbv2xglr9k4SjKHq/HTC8YAUO739BC7LBjgOyTXVpqRAtBQejBfsP0jcc/MGHK194/4/+/HUfXTx1l9h/8FfPP/988g24Sg2N4x1vuPMgLd0V7Fch4iAujtgr9h/cUDr4xPufeP8T5A1i/13B/oMTbzxYLFZ+/Kvn7/nRT0Ps0jcq+3rmF/9dIzMlsf9gpnTXx81Zs5qqvmQpOom2qmtYG9c1HF9Onf6dGo1fsEZ4okzvt2GY/v+uZrGwetH+KAyVG4/T0vRN0BpDwuvfkK6b62v7zru+bElCeKd4ekUdIFt3VKQjPGtGTKmQPXCkXjBiBe2BQ/WCJAAqhpQO1tM4An2+OxStB05GkZVnEIMs2kyH8Kk+pQLhhGUCNgoBBIfQNI7M8jIMGrWnVAwrFfzHUecLOeocTkedw+molQ+O3pZiRbDJws8MHJ+jwietEsRbfQ4rwtlvmb92aPIkRLKaU8+0faYftQ/Do3bclj5EjhFUjbck4NZwywU1ByhDmIAJ2VgjuBJNLV/UW77o9PJFxfJFc8sXzS9TlGBzCboUcDiRENkUsA6s1EfWA9aF9fvITgObgFX9yApgk7DuH9kcsCnYDYBsHtgR2CNABL/b+2sq6L1zOIQ6EXe1IMKNuGsEEYmIOySISEbcETh6KuJuABsWccczd3PGTvFFgQcMNqcCjqMpHKfE4+MTQHp8UlLgbwX0vBGKhiOUGx+hqHKYlqEbNLPzNLNQsxPXzPQREjOsOSWoPeTRuwIaH/IQGxryEJkpCXrRIc/7aPTkNJfuEczOg/2a8rhyeteV//sv/DULS9776VLmw5ey8UXnJERQmjgWcPQ/aI6QGRIFsBN0F4GX9ipcK4vCtXI4DSs1w4oUSByM7sjigVIDgsct4nFZ4YlLCYzW6qhUuPtMOHh7hQqaEDrMbuQwu3DqkmOFaXXhyE48dQmFMAwCUjo4AtI6aIKLpy45dmDWBFiQhLYgGDoVTuuLnBQMnQpHARoEfe3MLC9mVfBVmL2bqKxclkdRRdZSgUjZQoqIlCxkgIqKFtJHZGAVpYdIf7go4L91syrq6LkZds3SUEOkbiF1RBoW0kCkaSFNRFoW0kLExGDFfCH0a2UU6jKGdRm16oLyRQvpIzKwdPYQ6VtIF5GehXQQ6Q7nC7FY26Mqeii0s5VLBZGqhVQRqVlIDZG6hdQRaVhIAxETfRXzhaCvpTEVXBRaw5JvI9KxkA4iXQvpItKz2wSRgYX0EOkP5wsRX5uQb20cSz5m1Q6RmoVUEKlaSBmRioWUEClbSBERE3oV84Woq4MxFUgUWsOSbyLSspAWIm0LaSPSsZAOIl0L6SLSG84XorvWx1X4UGgfS36AiAmtisFDoeQWUkKkbCFlRCoWUkHEhFXFfCGma29cBQ2Fdrbk64g0LKSBSNNCmoi0LKSFSNtC2oh0hvOFSK5VT4UKhdaw5HuI9C2kj8jAQgaImCCqHM8OYlYMVY4HDDErhCrmC/FbO5BvBVOrlnwVkZqF1BCpW0gdkYaFNBBpWkgTkdZwvhC1tTwB/WECB3wrRCqX7Ql18mpn+BqIs9qaAJMDL+xwxCfBVOQxLQUr1MHfE1ce+pPcukd/9o/zS1XBd/DWRDB55Uuuf37p7Dv+cn7pNH7BEJPmOjElJgxXxUUrXEwaLWKFmDAKQKA1kYGTNtVp0uCYd76hP5QfQLYdsnlkWyGbQ7YZsgLZRshOI1sPWQ/Ybbz2f4ArDim9MOVqZPshew2yg5A9hCx8REf2CLKlkL0B2XLIHke2G167oKx0yoSTUKzvyOqkdz+ci1nZieezAuiyBWW0LdPvansPGyaYidTunmf1qUii3U8oi58oBAn9RlvFY4oCJuEbbYzRmBiy+Am0+HcooTu0mdfbq0uaLqld0C7s4YMwO8bkJ8HkJ7XJp3iUIgtjsVM8R9H2ACievmh7ABRWng5bfQorRYesPtWuQdlClHNRspBSzOpTPH3RtvoUT1+0rT7F0xdZGP+U4hGLLIzFTvF8RdsPoHi+ou0HUDxf0fYDKJ6vaPsBFM9XtP0AKjvZYT+Aal/H2H6qfZ2ihRRjtp9qX6dvIcrX6VmI8nW6FtJV1ezoasJBiyyMxU6191Ox8lXeT9VClPdTsxDl/dQtRHk/DQtR3k/TQtoq65bOWrkpbUtAuTIdC1HuTtdClEvUsxsq5hBQ7Uj17QKPDTsBVLsvNQtRLk7VQpQbVLEQ5SqVLUS5UyULgcMYWRh+neKJiyyMvk61G9S05JUb1LIQ5Qa1LUS5QR0LUU5P10KUY9SzkIHKuq+zLsY8A6p9GuMZUO33lCxE+UZlC1H+U8VClI9VtRA4d5GF8dapdobqloByhhoWopyhpoUoZ6hlIcoZaluIcoY6FtJTWXd11sof6lkCyh/qW0gx5h9Q7Q8Z/4Bqf6hkIcofKlsInL7IwgjrVLtEVUtAuUQ1C1EuUd1ClEvUsBDlEjUtRLlELQvpqKzbOmvlFXUsAeUVGa+B6s8vfQ+axIP5XcqEBqHoDzmwq3zENApC02EkNmwVhEQhyJhmmVAzzSBr2gWhfCEYNV0GIP0BkaJb5MBh2AnTMAhBuBJmmgaxNjEhu6lsIdYhhWDMNAZiPaJeM+smQwxeH3oKkxTNMThF5iXSKBGpODASB9JxIBMHsnFgNA44O/iBYUCFBo4LXR0HrokDh+LAkThwgwF8N6POl+9NCCrcy0l3Ap6RcCU+haMtQ7I4GZElQ5YNWQlJR3mR5rPM6fXyryfFhDeN9RxK+uus/PS6MCl1kasScYVDV3kXuYq94FXTF7kq+YJXiYtcNfaCV+UucpX3glflL3LV+MWvor4DLwIrh3x4BejMsMoh4aJT6eYYyTFngsELmp3kDTQ6R/wOfVR5dwJeRD+TYe7iGLy0arvHAroZo8d/g+CHjwR4yU8rOgmvyjUOBwT0NQ5nAZQ1ngafW+PwYaGkcTjRuqtxOHW5qHE4GbijcTg1d/B1RcNhCG2NTwiyg/d/25+E39ZhfwrOS9+hTtmFj1UB81bCjGQSphkVF1JhtIf3vZgyITxIqaqUvpUyLsYgpaZSBlbKqMhCSl2lFD2TkhFpSGmolJKVMiJSkNJUKWUrJSkSOAWCO6S+1OFajvJhaNGn4WR72Q1BbH2F9WysprC+jdUVNrCxhsKKT1tYU2ElGys/DQdnCCJPP0oKalaGpb3yv6/44Cue+f0T80vQyOXDVVXO85MqkFS5YFIVkqoXTKpBUu2CSXVIql8wqQFJjQsmNSGpeRgmJD2opf6Uea5TRN+PBNWhpNTXI2CPq7fPFJetmG9HFNfWmHPgn0GsRaNvRzRc1BiE2TH46uC9Ezvdd1AcPjWVOHx/YlCY76scq47+2KT5iubLmi9rvqT5kuaLmi9qfvA9xQ+4/jSt+b7ma9+HT9WA1PQVda2hrvmG5huab2q+qfmW5luab2u+rfmO5jua70KOLiBdjfS0RE/zfc33wzpofhDWsafr6Oo20HxJ82XNlzUPR5OA9XHhnDKIBut6a9YKoj6JtG6S6ePywE2FgOGXxcCBVv8mllG9gt9FyLqA45NQhFtfglvPd/CUfjI06ym2otlp/WxqVujHUrM5/URqNq9embj6cWOyir1FVr8ZPYJM1hRWs7G6wuo21lBYw8aaCmvaWEthLYNR2cZvjW9llC3qcx0cGOAxji+c6wAOnqDhsQ7goimcIbdwDKHwVAfvWEDgau9XNKCCem9m3luYwl3E38R8xiFYMJHE+wVEy3EFx5Zhi4Kqr+XVlcL1nmYBVS8/qGC/OcoExipjkp6Q9LZMAHrhWBx4RL23wB0m2xiZZfgtSr0hEcTD7d1eAXP+oAsPLDLoH+rCe5cqFg+HcNThEJnnxtnCSWyPMj0WXAUncvivgHuV9zejFfYvxXvob4GfG/yt8FOlfg5+O9TfBr9l5m/HV2XM3wG/Re7vBB05fwztvz+O3cL34OeIvwF+KtTfBb9t6u+G3xLz98Bvk/l5+B0w2JsGMfUm0PPwJ7Gn+VPwc8jfiPnCqmTIl/qXYb7MfxH8NiAmEYco5P4M6Jj2V6DP46/Ezuuvgp9r/E2YL8QrgnwhXhHkC/GKOAR09y+H3x7zXww6PH81elv+ND4P/hr4udoXmC/1X4L5Uv+lmC/1r4DfGvPn4bfL/AUM8uGvRT/PX4ePmL8efhZ8H37u8CVmS/2DmC31X4ZNzfwrsamZ/3JxFVDq822QXALmgPqenULmuPpinYAYXJA7VZ+lRzCxS9WX57R6q1lh6utyBhPbTH1AzkJQriBAC0RPww8JRu8V9JzrcRr9WnyKTweXQFKPVqOVFPBe9JC4SqwXySXhi9SSkALLcVCMLImXCcj1SpFZEi8XKo/1aMroaaHUpwL/tFgn1p4O1qKHM6Q6WAffga8Sa0C5AOUvUcpfCsqvQOXzoHxBK1+DxjBS7gXitJgWq08HqyFhMKx8Gj4rXyVWgfJNoHxWKT8AyudQ+eWg/MVa+Sp0vSLl08Gm02KlWHE6WAEJRTakfCV8U7xKTIHyjaB8n1J+GSh/ESrfD8pntPIp0NGOlItg42kxKSZOB+j4lYaVT8Lry6uEB8o3gPJdSvluUL4HledB+V6t3AMdnUh5LthwGty+08EYujfDyscxsuBVYgto3wrac0r7NtC+HbXvAO07tfYkOqKR9nyQOC0uFZtPByn0kIa1j0D8QrYgAutAAAgsvj7Gr4nxq2L8VIz3Ynwyxl8S49fG+NUxfkWMn4jxYzE+FePhyYlBfowXMX5TjN8Y4zfE+ESMvwqOtkmIxGn455WjEE1oXURPi+mIXilWRvSkmIzocTEe0SNiJKLJLlKFTydXwWeFA/DdAKk8fFC4CiwMwdWqRMECPmYgNQ3fMZDy4PU8Uil4PX+VWuoT8BnmiavEVfDeYoZlkRQFsGtcXAXvYWiOkUAtWskxJ3A0lQpwYMIRjOjvLriWxcEFLedGWJWWqs7hJxBc2OLg6pZzI7hK86pz+KUEV7k4uNTlnIVQadPVOfyogkteHFz3cs4CqTRRncPvL7j+xcFFMOcsnErLVefwUw0uhnFwRcw5C6rS8uf8+jzMBimGYiEihdFGiRjDaKNETGC0USJWYIRRIlZjhFEi1mKEUSIuwTidRCQxuigRHkYXJWIKo4sSsQojihKxBiOKErEeI4oSEUBcT0n8V2TEVfAhYzMRr8j8OWfOSXcRu2nA1IjD4WchcKrVwDWvSnBK5JplH/cEzDzPuFAoYgW7V+nCNjlwGhfZweSA6qbwAEqFUEq3+Bz3xqFhGEwjrgsScFSGSEguiUisK6j1ruT6dUFCnUAoEtJFCElakPx4kNTQafw6pLBUiF207Dj5EUnJbwpGRCrMSVAIwHBTkBbJEDo9XEVVbbjwRAGqAlNbuCJpqUiIkZCr6qxSlnxqSDQ9JJp5Q4olTo4uqhPEUmr9jJor/064UI9GjnpVs9pRr2lWO+p1ZOHN5IiZHCssVwjSZnKssHwhyERYS2EHCkE2wtoKWzgWjEZYR2HwjnIsArsKhJeU4xHYUyC8pfQisK9LfGQuWnGs5o/BRCSDe7Cp7BMMbqBB3KtNd/A75qLlzGruioFH9bxFgRBnc4W58El1YfgS4MmhBq08OdSg1SeHGrQGrGnLOrCmGRvAmhZsAmsar4XnKJq2BNa0WAdY01ZdYE0r9Z4caiU4T1GY9oGjFsX/Td7bB7mVZfdheO/hqxvdTfCjOU02Z+a+t6NdcPHRaGIaDXTPkHgcktMzu7LoqjjFlKMK16RWNDhScUb7BxNNaZBYtqF4o0IsuQqk48wDWkogZ53AW0oWsaQdyOVy4NpyBUnsFWJbMbRxJJQtRZCjKkNVsjfzO+e8DwBNzqyVxH+EU9M459xz77v3vvvux7nnw+8ZRGEM9AwCNCq/TxC7UXm9kdLrP2hB8BH/+DC5VU1etCHMQvtN/kpNA1fWmCciKtKywiqMNcFQhgfrSif4S+YKDBBaCfuX1yF6a4OrjWSO7mNr9v+ctP/ChnxNM475948v2r+x7nlkhpqiG5/jt6+RRY8X0/IP2cNtSOkyVRoyVUZoqoTE2jTwEzd1/CTNCH62zLCt2f9n4MnxSnIrUDeua1iF29jNfGi5romnHzlPPMOBe/ZHCfs4qaKQlc5Nj2EVPTbDuDc+NiPKwA8O5NFjU09wJSf6QmDOugExZRkGO1x7adVUT6g4RfdLDHXdeF/7wB7PNGqXPWEgbE8ZwEG+D5t+XWaystH7EYyj3+ED8DjEiuoYSwyjjSF75iIooPEbjDiOo/Qbv/pC5w/O/NrvftR2ZIRS8Tcy3/oL3/qvf/q/h6iJZEdusaNgsdNgsXW/WClqwEX5yhM4BbCKwTBYzCRYTG2pGCj9Z0Mskp3+TiCmaAAee3AUJ3xacWc/kkh8LuRbBExciwApkPhCzPf3dV37QCNRsPbQ0l8JYfz7jIQde/JCnURgGhc8/hda8qf5FI9PZvgOjhg6LqJ+WxQlHhM6cdGaRvjotz21Ch2TFeY6lMdCuATK6v0IRhVGgSh56BgIov+hs4BBx2gRezIdGuCeh/2Q1FOX6gVbEFqufcitPQ0sv3pxQr3GJAn1GrP18XSpluqu20NsOhLfDmsr78tSZrEWTtuK05m2zVo58ba1Qvs4wZNtaHjg13H4rBijXV2bz3ZR2o61+SyWoEMxPuA1fMwriliTbUVcKYisceQGw3q7Za3Svg8ibnoYna75YL318WGH9msfH3Ecx4q2W1aMNoIoaqWt4mqtjZ0x9n8YmE9lcadNHx6sox6KKo7HKXrUEeTfetq4jVL0jzfqkjXuZr0rWR9I1kde1seStaZJ3rommZNu5oYmuZuaZHc0L39HkwK6bgE9t4Att4C+W8DALWDoFzByCxi7BUzcApRbwNQtYOYWUNO9Auq6FNDQpYCmLgWk3AIcXQro6FJA1y+g5xbQdwsYuAXkE/9xVEu8j6/X/p9grWWG3OXKn23u43gUUvqHFs+V3o6QtnNlg/bjtCPVPd14DDGgohuPQQY0yr2GDTPQGPcB7Xl1UobnvS+tLq1nVaG0XIWOVAHLidFuobAIK89raeMIo5iJK6xD//HneRtDnImrrEqvwf1S3CXqEMxoaYrmFm63aJFrBS0FuEbGh2jxo2CNjGOQulKjxypK+VeQXxltKwHpAyXVsJVF2qqbtkbCA0qsaypOibqbaFDsAo0EVFEVpTJX2i2VUIl2ywov1iz8ITq/owWrFj5Gt/Skal3aetPzUc4aylERemddqUUPtYhSLcBiuCxROh1pJB6LqRiVsUplrLVb3GPBUxDXKPIhnj6eq1GEatSXGk3wuBg9bpUeh9K4/7heE3poU1dxFSc2ndgMYot6j14cOByTzhtA2BUFR1DZGGCvkeh/K2x8/v3yB7GfQKTltYfW66+E1Osiknf9mb8uEnt2RB8h3HHxKeNNF58w3nDxMeN1Fx8Rftmo3d03hhH1ul2PVuXSyL0uet0ewZiJ1nn3Wul1e7hSlUs50U14HS7U5O7OI/WJ1A2SekTqBEldIjlBUodITZ8Uumw0/j3zvnodqnXsPuJ1jvrFoOOB6v6+4ayo18kJ5yr/dlfV62SfL/gI6fDvn78uD4Rv/7SL4Lyx7yI4kVxxEYg9ii6C80xGEI488bp3tfY64glgZ5Osurd5b6LGoap6HTdtr8P3POodqVoHspl/HW4v0fhI1cp6tDrRupGqVfBoDaL1IlWr5NGaROtHqlbOozlEG0Sq1o5LU6+njWakbExXlTRemi0NlqZKIz+peUOzqhbaBf1IeQa93ERV+Q3sJarKb1o/UVV+owaJqvKbM0xUld+QUaKq3Cb8P1Dt3pWlao/nqz2Zq/Z0rtqzuWpDadOvNpQ6/WpD6XPHP6p99QfNfdzYxB5aV14JqStoZqRqFUkY90hdUUWSxD1gSEGJl6AtaPcSlIT4jqA4xHcEQX9XXSETm6Jd8r7bK4jVoIoIKel+tsXLxsgw7+N3bJg/hN+JYX4Zv1PD/GH8zgzzAX5rYfNP43domFV1hRz9RtQV9afJbP+KekCm/FfUD5N5/xX1ZTL5v6J+iNwAXME32AxzvgHwKrkZKGZDQ9hBX7EH4aqVRvl8RUxgk+y/CWyQ/Te1Dje+0zDDuA2eCIy76LHAuOWtRxjGDXBNYNwOz1ANDdVPqGLaGMG8/Yo4Er4i3gWu4PTVBO5EqmYa9WxGrHy4wrUZ+3XE7W2eQVzsphjEna9icEb27ARO/fZMuD3k1SCS4OfWY/w7juB5gyj1yziCV+ZEquwn8SLnqccSKn+TqrNP9/55hh5wDfbJXYVi6A4/f5/cVSQZOsLT02rfD1LlVWU/pYfMgh0y03bIzCF2TPyhdYBDE+LKmxkbvVV5aOWXBOIXbU3l00b8RGryROrWiVR1IjV1IjW/QDUqKqPyKm3n36G5sDQXvLjE2mjztLRxtEi4vUi4s0i4GySYGZWGGnma1chtzSzpFZXBSp9HXOPAMfnj5jkB3AGhFyR44J/i3I2F3J3F3P3n5W4u5O4u5h48L/fQWLiSyKeN0Qm08Qm0yQm06Qm02Qm0WniRJvMEenM+jQZB4wRa8wSacwKtcwKtewKtdwKtfwJtsEBLoPJNKK/lyWVJen78IcpJfG5wpec/FiJsLRLUIiG1SJiL2u3WgyaVPO0x/o3UA4TSIqGySDhaJNxeJNxZJNxdJDxYJDxaJDxeJNS0RUp9idJYojSXKI623PVYZwKHgC9jUOtzY9wOmRkdLwcRn9OkGAAJRpq0AiDVwPuwcMBynBPlmXRLSi/J0iDWwNux6BSeJuvztrPIrSmNJaZ0YPmkYvNWWIotWREptkI6CkvFhtt0SITsdDkZByKW0EYp+ZlPXYEqL6SIeruFJxvIGFUasBgEsiTpabfaQcd1AZ3gTMLGJVRm2ywlVClhldZD2KU5hqnzCzE1daDytNd6wFAKOyyCFHZYBG1hh0VQEjusA1yQ5iVICpHJ2usAm3+Vx+1K2d1wHSDaFr9Rd8OVlw1XXjZcedlw5WXDlZcNV142XHnZcB1IRIQDbLh6YXWADVcXvz9MG60DbLgc/P4QbbQOsOFqhDlfH3iVfDm5E+mB3Q9XrRLK5w0XgbzhIpA3XNS+Lm+yCO7wJotgbLhGAg94k0VwnzdZBPd4s3ZAmxYoaQfezy7Xbhjh3yaya2V4XXJnzANow3Etx34tecvFdactF4G85SKQt1wETv0W8ZaLajJETZSudrcxFBC1zCxxJWox/h1FvOnywB5FqjxpunswKqQWS6gDHAlKqpAJbX3D0tqQBBGpooBUGDki5IiR24TcZuQOIXcYuUvIXUYeEPJAFZSOMTv66+edMv7qH6iC3f/aeZoi7phJmh3N0zRrmmdUmvc35ln6TM1z9N2amzQDmOdpv2TyZspcpZ2WSXPTlrlGezRzHT9QYMY+zjyFjU7eNPCTMsP4UWYEP1tmFD9JM4afuBmnA4+5otI0YSmdLuo3vJf9JXXKh99V60FkLYgkgshqENECCBS8nliGCj+xwiryxIqo6BMrqmJPrJiKP7HiauWJteLxKx+8v42bYbVyf9uK49b2/rYVU1EVw200Lnzub0OSrSL3t+GGQIXvb1uGXGX9wrX7tN/Wcc2UFn2DhP6BKoUrdkilk3vr2kVYg26o819Sp9Qm2qnOoYHqLFqmzqBJ6jTaopJfehelZUOhdS1hh2i/CAzzXlqloRyxix3lXlEPe4Ih+/cNtad27f/LeHv7G8cmPManVck2vmJlqtYOGYFk+c4si00w3evsQJnBIncsOyTgyLAGfEZpuPEzOAGO8jLKf5Lfd4Fut7LbFNTNirQ+nnkdzomIgxnIOJ8sp82eWSoWBg+7J8UaUKygrFkcbXZwz8DVjaC6XGadytTw9ilTFGXd28bfwFtmXoQZ3Dm5VSoy93wcyS2t1VYanp9QJfR9SYxCqcPxtuzfN4p62P59w9xLyEi3NF5xw94o+XnLUIaj9ux/EjqydrahhYGuvr9taSp849/eyH79r/zu715rQ5sZ4wviZ1rZtXkJYVppvIKHRTP8J92SP02ZKoEDyaGGcvIkbkgxRN5dCEpiskrTYiaX4URWmKkISmGakhkjzX6A0ngLdxhL2tqajvGeTu7Rh0EfPjrDu5RtW5rXLcoH72/f+Evf/uwkkTv9Tef+QYguqDDi0WNoOc4JEkjgf7l2H/gkgFdBmC0SauEFQn2R0FgkNIMEO/wWLsH9Ot7kmsRv/Bc/o/+nQQpNuUraeI7a6L4g5YP3t5kfCwWaByfBiQSGdcGP+V6wG1kP5MhJBT8we8Hu+6l9nzr1qVOf6uR8cNcDhz516FNrfgW8mOcFP5h9gePYiN23OrC7MU8uemB3YlWr5CJOrGrtCkIxoGL825DfekwV/JDmBT8MTcEPaV6gkOZltSuSiAKFNN9VJQ9HSPNXZacFvOdn7fvgwAdhklsWKVuBLHJ3PQzWuK96mBfWvOCHNS/4wXAO7HoscOta8KPgFPy45gU/rnmBDGEPLhtOTGqyUQ00BBawfjPGzNoT1gmjfUGnjA4E9UKaF+ZDmhfmQ5oX5kOaF5IF9OfXz1dpgsNWomtYpClRgCgBj/3rnMjqH23HCt/DKA3cRrgfxUft5Nc1XGjwRIlFpf718wn04t84X9XfD0zvc3PZxeC8j2sjyjzPAnuTYxQFr8C+vSCie2t+VXzw/jY8UNsrZgmzRwHzVKls1H/pPIbLL53Hfo12QvyWm0RJG0eMOoLeljEg6B1Gu4LeZbQn6ANG+4I+YnQg6GNGh4LWNBl6gtcFHwveEHwieFPwqeCO4DPBO4LXfpnxruB1wXuCNwTvC94UfCC4I/hQ8I7gI8G7go8F7wk+Ebwv+FTwgeAzwYeC13Rpv+B1wceCNwSfCN4UfCq4I/hM8I7gtV+R9gteF7wneEPwvuBNwQeCO4IPBe8IPhK8K/hY8J7gE8H7gk8FHwg+E3woeI32VQWW/pXJz3SBnFCrPMV5LnlDc8JExHr256gpExHv2Z+qZkxEzOc3PCJ8VKs87cJuesQ6ExH7+S2P2GAi4j+/7X8YTEQM5y+4RDptmC9AHvEZLAIPrZ1XsJtK4RRaqlpZu1RVWRyakmVsnG6bK/g5MlfxUzET+CmZa/jJm+u0AzU3dKx82JCls6EUSa4xnY3ivESmILCtqmzyQKXVShmx9NJqtYyIx2mVoEi3abVGrlzTap1i/KahaFvDL9/DdAWMlxFkmMBkGeGCCdwqI/AvgaqMkHwEpsrGSMB82RjHVNoeB1yeYAuKPTXP7TukEZlzkcpD61BgjgtJP3n+QXu88HdpxMcLXFHVVlXabq5WrYo6lMUgjetK61DlPLyzWrX2VNbFKZDgikrboxWv1LEPTlaqqiIvMG1PV6rq0MNmK1W152F9v1a9uVp1V+kd+4tdGkH5XN7hHO8ALUDk653LRkVqsFoN1H66WvXrThebO3QRAQxXmjt0QUFdw9gD4dySVS6NG01/HUtjzfdXubRNwTAkdU1L+EtEesGBZPj9xe0/FCI8QVP75OXl3nZL6R7TcfIbWstXmU7c+E9+5791/sXf7l79eegJplP6KG69Zoe+aFboRJbDiewQx5SsOqxaeBM4q+Q/PmBYJMPCIaMLx+7GE0u7cfTf/PLTf/5r/8HV+yw7yyD6o7VHzbh3M7CU/ql310Nqj85BCbzeIZ2AauGWiUyTWNU81Cuqgm8rAxcqVoZOSEqjsdCiVV8K26oc0znrkE9VOZx2cjjt6Hz4/NmErVWL+s8msLguMcGELa1eIxb6gHvrVeuauoaHpdP4EANa2bTTThB9FarohF/2V/WtSjvwAlrPPDJYGunysCZjGvs+t33pND54L2VAKek0Pn2jTSySMqQUA2mD2FzKyE8ZzqeM/ZTRfMrETxnPpcAwLkJCajPK4pkYi2finnjmFItnkjTxmKdpKjLP0ORknqXpyjxHE5i5SVOaeR5Dnh6o0XRHcp3WXH1mknxeJecTsLtGwqY6NZ9Ql4RzKj6f0JCEsyo2n9CUhDMqOp/gSMJpFZlLQGWHBiTM6CaYb4zRC5M4fR24TEJaoKCpmzJeTJm5KZPFlNqKpEwXU+puymwxpeGm1MLzKXzsnrDkvbkCa3BMu84KNxCH0/lx0PFTZvMpXTfFrsVZBzaQ2PMS68uJfS+xsZw48BKbS4lcD2etZZGAPZ02OmswTV/jo7uzprIiWk0rg7o5TFxdcHXXUK81Htbo6PB8pfyU6XzKwE+ZzacM/ZRaZP6T81Pq8yljP6Uxl8If2wRVnawlaMeAi1dcEKD2qy5HbxV29avUGxskHMAwxreN1+muolZOaWqdRAVIzgUqIIlrJDZYSJxIIk1pzZgVnk+eSvIqvYcYicMCyTNJpsuTTsyKzidjU3CVvVLwjiDHbil4O3AIrUF/ZrVIRVNr0/TO+tQ5vjGJq1WliQO7q3wdE1MJj5SVOwAZAnUeAgP0Gi3sQzxYXkB4rn4jP6U5nzL2U5z5lImf0plPmfop3fmUmZ/Sm0+pJbyU/nxK3U8ZzKXwoOijef3VhMr86+0ysTXBipPSQ7TwyRbFtJ+12DkOywably3jyzchIzZJ5qpsLuIbbT8C55dxd5xOHpIkLHmo0jAW66xjDllnWVWCm4LRTWPWSVhwnAyEWrdOfpT7gg4YHQg6ZHQo6IjRkaBjRseCThidCDpldCrojNGZoLUNQmsbjNYZrQvaYLQhaJPRpqAOo86G2sHclFI7GOdYSIq6UjsqU9QvIZaVHa8W9S2CUh9vSs4RBKvCpHJ3OMcy4W74mx4h9ZZJ/WXSYJk0XCaNlknjZdJkmTRdJs2WSbVTS6T6MqmxTGouk5xlUmeZ1F0m9ZZJ/UXSDtxn5cgPT4hTHE3lcGWBXSteqcZvpqMpoXSE0vUoXaH0PEpPKH2P0hfKwKMMhDL0KEOhjDzKSChjjzIWysSjTIQy9ShTocw8ykwoNd2l1HSm1D1KXSgNj9IQStOjNIXieBRHKB2P0hFK16N0hdLzKD2h9D1KXygDjzIQytCjDIUy8igjXc29vLHOLy8nnSUZJroSykQoU48yFcrMo8yEUjNcSs2QzvIodaE0PEpDKE2P0hSK41EcoXQ8SkcoXY/SFUrPo/SE0vcofaEMPMpAKEOPMhTKyKOMhDL2KGOhTDzKRChTjzIVysyjzIRSC3v9E5b+8Sh1oTQ8SkMoTY/SFIrjURyhdDxKJ8wHZOu6ui5nhSYvFzTzbC7PPOeXZ55lUmOZ1FwmOUuklN5IWDnb+GKYD8dwYpMBn3moMijCxIG1cb5q7qkMHmy+pjKok3lDZVBd8xYOtJtV88gIltA5X1VHItfI2N3zVRjMC9Y7X1U3PKx/vqpe87DBeV8ekrGH533JScYenfclJ3LgDeMOkO65cC62MnaIGmLXL5MfL9reMxhB76bEw1janqaq7lZukhKfYml7nBKXYliIUyadsNMB8UVKb1y26NF73zjmHcQo5VkulCvtGwdfzX/np//9m1edG9k3Lv2z7xQvXlM5O/S2lcMdNlbsNZX5hmUc8832vW3FV7Iw8xiluAZ0fuDr2k8omMqEi1ayEVwqc1XWvO+9yNr6M4pckTXzey+y/qwiYzLyv/ciG16RYZiF3veKjMqXc/l7KhIfZtMrMq7CKu7XMiIf0HrV3fTXL8v9d1il1Z69i/+Ptot647LKkFF9+BOfCPMVmP9g53lvW318WqF7m1BCpfX3aWaQ6yB3QNMedqIzkY+QPcGihNUF4xPySGNshQ+bgq0S9piRxJx+Fv5ZtCNvGHThhBMMdqE6Y/zIrmD8yJpg/Mihxhg/0hGMH/mIkRMeGaa6G6xKx48c6RZpwMlBWTB+5ExjjB85EIwf2RSMH/mAkRMeqZ2kRUGSLE2F7/EvXoocGnDCwKKcszXMPVDxkFypSrstb/Xg2jFrARi/Yt2/rur/pf1dhCJ518rZtVr/u7EfgGL0z/zev/x7OmkT5uzvfvfa94crIH1LNzPe+fH2G+3FAkhR8b5r1lyrffBnIMn8UZWp/rXr6s/95EfcteGPh1Obqq6120q78Wu/80/+Xqj7N6+1b/yvf/y3vvmtG5OPnDYSb/zNb7/19t3f+4Nr7RvqlelfHKf+1UdO+8Zf/M0vnfpN419dcxwVbv8KPSv+Pv28/2c+snA6Qrk0XuH6QXOU4RxDYGoaCWUkLNGJkOHsXb3/rH/1/rPXoP/QvGyHzBtep5u+l3fz7GdCdn/loZV7JcSyEn5/LCqRoxXG7TFrTzXX4GvK1GjpuQHJ7l7VqsCmhZc4MxyYvNUNUjs/tB18uXiZtzCTv2avqdfstSMo7cQxVygLUreKPaLFoG1F4TXi/raZUJlsKA4BLkztwJm0WASyZUEOESM/JhlPS8qqtK0Y9JVI3uOfQ2FnG4FWk9JaXr+4d7YKZ2Cygszg6iUuDwvDWDcDTVGINMI0H6XULTv/RarPa0U95CtnIQogHNPEyN0FVd7ytLUqKn7sK3V+6MLJvrQk/vxPAxM3JCTytMqrlfb9bVPTYai94umEJSvteyzqDhX1sJJrmUBh61BPUXRiD1uv2WH1mh0+2rZYbB3WK4Svz2WBAD6j4vPuUDIwlGwFzvg8VaewcC8/lT6iHKnnRJ1jGAiGgMtkFrB7bMncQ+59/N4IKjG1SYkuBymm2qv6eXPkGKUCAyV3wnYStNc6hPcxuhx4YK7h55G5jp+GZm7gt6aZp/Bb18wkiombmGq6YWy5Du1pGvK0CgmaD2lD4z+TBvMeBvMte03dksG8yoM5SoPZIWkkZglfsNFu88J5b9s87Y/tVRXhsR2TEbHSaqsVHtv+I29949iLx2BV0FUxDLhYcJjH1J4dfhtKfTEVg1ofCaajtD7TOI/MjfNV0ju24jzO/d1BSu254/zW/DiPwNpUSRusaMta8V9RRa0+d5yvOgEbWBUOjnMUuIL1WMXdNvI4V2FukRmm8R73nrYw3l8TD8XPGO97NpVztE3vjMf7Ho/38OJ4X10c73EVC473GHcRxvvyU2m8v4buUWGHLGdDwFm9OzDeIyKRjn3ieD/EwOyGaRtOjnY2IMZtt1USapNt+LfV1Kl2G55xHfMM5Joq0Yblv6bW2221Bsltu63OIvmsuoExe8OO3eJN+4Wq2sSGCB+fpakzbV/RRHZ0F+CS6OwCPUcmr2nyYnPIn2SyrHIY89wlOQjjXbAbJ5O/cZyz9hidCDpgdCbokNEa7XtpQmnEVQ6kUbxsdASexstGP87pSf6Ju9MPfcGQ3RhVMOPOIPkjKoeeREryR7EWyvpVeseqYIGCnG2PjkEqpypVC0cgiohySFI0SarA8xZTe3PUpFD7c9QtoQ7mqEqowzlqSqgQqh3SywY1T1R5Z6ukfZnDbcgroQhPcya0Bek0hpsA3g84CX+0ko6u3bgQmC41OUZ119oi0KJXTBcN7hhL2z0hjoLErhCHQWJHiIMg0RFiP0hsCrEXJA4uVEnrlxUfBhfoAChUVhmEieSFBOsimId44jrOyGm7u0oXHjC1NnPoA3t2EdmgKABldYzxPRIlkxw+UjaGF9CkC2Sr2pEDxpjRrqATRnuCThntCzpjdCBo7SKhQ0HrjI4EbTA6FrTJ6MQ92DA6FbTD6EzQLqM1OVj1GK0L2me0IeiA0aagQ0YdQUeMdgQdM9oVdMJoT9Apo32geBV7rJpyEJpd5DczRA8Elf/pvc0uIq2/VeUDunQHo05caglUDvxSUaJMApQRUaYBypgoswBlQhQWMkiliVIPUBpE6cR9SpMo3QDFIUovQOkQpR+gdIkyCFB6RBkGKKMz1GUlqS8wX9kubU84+UiqythtGU6M3ZHRdJawu9J7jD2QBjH2SBrD2GNpCGOsZJe2O4zWBe0y2hC0x2hT0D6jjqADRjuCDhntCjpitCfomNG+oBNGB4JOGR0KOmN0JGjtHH8bgtYZnQjaYHQqaJPRmaAOo6xUl7Y7jNYF7TLaELTHaFPQPqOOoANGO4IOGe0KOmK0J+iY0b6gE0YHgk4ZHQo6Y3QkaG2T2ytondGJoA1Gp4I2GZ0J6jDKSnRpu8NoXdAuow1Be4w2Be0z6gg6YLQj6JDRrqAjRnuCjhntCzphdCBobbuqKklslJ+nH3YY0A+r/Gvrh10V7amkuio6YnF1VVVEo+rEXUCa74/pM5yIIY6zWjamAndWy8ZshR0hJPkn7rpF+KMqfh3+kRW/QkV9tqVsX+Prmq/tdd2jwv48oXZgavdKSGXMtHqLhamvcmiGt1ngWmJp7BssR/sCh2oo2DVWgzbXSRvc3ICiJSs/m1F1k/VyCvZMSElW3jRPQyMyaRr4iZswa/N1pkmhOmSttEml8ICu2kmlEKDRJpXCA2UoBE+Itq0oruaxif34UO+oGG1YLa3t4ByEHfQGDjmn2g7tYB0rDl/ME5QQh+TJUFF1GhwJ4liFJA8cU/fJcJIFwizGeuuqrA7sYayafJVtynoxGH8Q2KVDD4EdcnlEoBPDAYDAZgwHJwIbsTJZAh5AU0LUeLvnq1aebcMK8DNikaFY2NOZe/TRcfLrmqm5r4KMxIImY1tsMqbMFTYuW1V5TzZFimCwbFEGxJUJ1DpPFikk+Fll8ipaQGSWB60weQWtIfIWkeNMXkPLiJwkcozJ62glkeNEjjJ5Ay0mcojIESafImcj5AWET+8HnM8gKMn68w7gLT7tHPDpONomYooteg+gCggxJHlyvrH6a8ePXl/9xrX74fdxsCFNdhhCqQ1Xhx3iGEWWeUctlB9RZK13u0UezEhzvUXjiUz67pKtLJn1PWiRH8AkHXecZ2k6PksYE1B4hD+pAlkMfPM8fEM+I0cZ6diXYh9byIa63zy/DhvZMtQl6OerMXWQ0r8aI+8RFpkeU9+z20Z6Ox645YPKB1M+mPfBkg9WfPDIB2/74B0fvOuDD3zwkQ8+9sGa5sP1ANwIwM0A7ATgTgDuBuBeAO4H4EEAHgbgUQAeB+BJAJ4G4FkArumB+gfgRgBuBmAnAHcCcDcA9wJwPwAPBJ4XNRTsyUtwpsLjKGAIfAgvI/pDq/QK6eRfqVr5bOgPp5vkq6De3qiaOejNfzNeNXcoEEM+pc+mm1bGXvl+8KiM/V3tXTvyo1bWnv6V8DtVu6tXoehjR955iKRkEV8zZSJxyGy6ic39jsol98m9BDb8fzjdVPlkifwk/OF0E7d+UI0PVc2cHTL3cDU3xP0ftG0hnSf7y5zag1tia9feqppZoFV7rFWtMpxaXvXlSBqp/+AWBxHLd6CzSF/AE1hlJgIWL8lKW4WPPxTsTKVtGf6Fjg/CMBVn3eySdvNHAa+ckKiW5wSUjqnxImqoHeggciXufZqSaHOmKd0hfWOt6pYy/SOXskvlQMVtxy3p/U9ZEhdBBUaUpwc+ZG/QuwH55Tf8pBZm912y+XyijPs3rYy6evPdg1BSlVUGBnAk59wT688cXQDF5ZZADkIuNvIxqDbjxB5InQRSWbc1kDgLZnU+9G6BHL5ZSMsVAxXbdWk9pmGf65IGwuYEhg2bXrrq68oH72/fPwj9lgYHOWQpUfu9TYYHPAf7DRRs5GPBBkrqJJDqN1ASZ8Gszodlo/57m566K92Qs3Kr6auyst4jg4Z3njXJrLQWN1fgQmW2WWUNXUv3zrdt1sul+9WeT5nFrIh3vhXlx7w9Qgm6oj0X7jhpJeaVHT4FsRMDlbUlh7NNVVKHB6GOBi8Cdne2yVJuzwbg3kHor2owrPm9TdECyNtTUrLgZubtgaSAa4aULDc1bw8lxfh4Bqr9wSaPfzOOSkoKmlxHSoX3p3l7LCmrmBKRsie7VXsiKZi2mkjZ5UBjeXsqKWswKkIKjCPNM6iPpKzDsggpV9l9QN6u/fPNqucLYDLbNM+pkj3DbZb/VeXtHudvWfCjUOcsbWsTPYXSXnXFiiV7qsFIQFcbbWtDnRXiRKtattKxD15XZ4SI+fO60tVa21pTp4U4gkhQ6SrRthIqKUQYiN8i14zWqjolxIFWtY7oVcLWX4h9rWq9Qbb7lqFiQuxpVesm/PVCFBxlInyVti1dnWuRjtqrapO1aDfwU4ZWaAhhOPCzp0grs6JIC2JHkQQ3y557xV49D2fOExpDYf8jPAj9AsYCFqm0yqmS3dGqyddpfPV4fC3xOk54kfnwIHSH8kynm3zsu6tKqpQN/VXtIPRAlej8Q05hS6QnQ+5dS6QkQ45aS6QhA5erqkSKQk9hEX6TR10J2/Ku9hSzbFyVlM3pFVUiO4+nsBIvkVLNU5iJp0m1T2+bYVYDAMgSWwKjfG0OUGMvOgBj7GIHoMH+dwDG1cpTU7c1M0u+U2GRkmWNH/J465Bnbp3VC9uOGYH/WNZBbDtmlNx6ZMhxLlaYGGMNYDEKq5Vhf7vwK85YDVhcZTHnZ+3VN8MVVbLjkGmxC3+TYzaVcGXqYBKIlNGUkoqW0Y4SXnQdvzFylVrC+3+sSggH8UilzQzGbqhK3tSyHFWq/EpItjPWnmxwinrn70Q4tfIKFqDmS1X9fbWXDdUS1lXc++yRFtoqptMbf4L+/R/X2gGdA1y9TF5Ue/b0xSrMgVbdyfdEbhq+9oxYp5+GtfYSWGefhrVOrLXEp2BtEGv9E1k9hCS0N7505U/kP/8Lb1xDl8RxuMFlIjqNCmq1eQU6qb/mu4kybqk9WXO9jCf3XqDTKKNSe7JG+xmnz8mILqSMuG3sLmScPSdj3c2YV3uyA/AzntjPge6ljCW1JxsGP2P9mRmxMaODp9qT3UWrneBtSwY677JtWchmYIzio7F2scEdxOUSWVOHKqN2q3S2Y/VhGOzs8rq3i+nX80/ScxN0tcv+SSQBZhW7JLax8BG7+9nhR21M3Tt2N8oZPRdb0IwIe3o2+lPXNYYyWp7O1DGrQsFVlRPYfWvYx+6S9gk/HE4Odmi76GX9ObrnlDkj9mbYbXvVnrzIuwCaNPwvN1k2ett4C9tVGnT8ggaMKcaGjKUYGzGWZ2zMWImxCTBP5u5bP4quxy/yl+FhzrGltUzdDuH4pPbUjrylrN3bxu0bWwjCZxdeFLS7d2nDxN5hsvZ0GxsmukPxdpj9Nr0OZbSeQOHnOGBzGTT/F08sGoYE76f30kbnkkpjq7P1xDEDQolAnX+O5EeW3sLKkA0lrSx1pIExuJc2pttO2ZhuJ9Qerd5llLhndy+5Hm8UClaUx55tY+hQzl2xCfHzdZGv5+VLBfLVLj0nXw/5+l6+fCBf/Xn5+sg38PKVAvkaz8s3QL6h5BMfln7W5vOyDpF15D3yKJDPuYSBTfl2lvKNLvHyQ5YrO/xy2Bzz77Bwz1gYS4OLGEs0ggbe2eaJZ8LpHMNo/OxJCa0n/CFWXOWz2TUIp7MQuVtZtukJYeI6VBUszUHplRSn9HtLQy2Bg9xBqJYglW73KwlXUNIeFK9hQaXxDDkOJLexPcBybfiftfNSlT6PLCl47eCClGfEHVydemCXwaAqINFHPsvQBwfL3K4dqze1wJ1oyMxiIF/yLNPNq9BcXpd4D3v2hF6vFUGzxpcC4rl2INJTQGb3BAsg5wk/uQcvRQiLoCvfQbr/Ve5sk3jaTalhWsC5iY5JMXjjIwmnGxXG0o+tGHbeUTjCh8N4a7WlRNfJi8ryoRU9thLAScwLVjibp/KsWEtFjxHVAQFrVBz6OgbUdjaIDgeAKgy376ah1tmXYLTdMsNqQ8VbZkTF1FrLjMKFfMuMqYzdWauarxoV3Km4qxMNd7WrXhXr7FjbXWkUtvy7cHOwW7WwvUXZftohufgmS+dIu8VngategVRWOMhPJRhBCuXVOW/wJWOw4kokk3wN0/1WVeXsCV8479EUeBD6DxOqwsFAiRI6CP3579AmG2pce9f/6ZP/6O/+zLf+x5+9tW8434mwpXj9OxHSI9pL6Z1hxMraITiyytrGu+Yu3PuiCg9t461w5cY//apT/neuXv7bJKpKQ5coa7//rnm4kIBp4+WqmZHFBOoIxnt27zdC71TTRudLlk4kPUgyiKQFSWEi+XiEvsPIvSXlWPfbJiFBGNLDHTuMDj9Ep9F20P6gqM9+Awuu2g1X6JuVou1BTZNNTrAYDcWwdr/apb63PzBzXkHcc853ItTcrB36IuzuqdUsfXTLtzJVu1fT8BXaEZIz2v9S+8I6FHIoCGxG7VDrIGf028oqU3sqzQ9Lm7mEOA9WWXcgfFDU/xAVwbXY14aR+Zfb/c4CwRkS60Hozy2mNIkQ2jf6iymN71CeQ+0nXZYptXwvpde+E6HqFAGpMuqwplfcjiirPUjzy6psr0GxjHuG+iSkyslrSEnpa1IC7I557P2xddohZkN/9jsRMyPPMXMnlOe9PS43pzLPK/eIuqzM30Ue8z3JcelCcbqpSnZNR7AaeEKCm72EOoA1NrmzrqjSxmpIk39w07UPh+AlciCyr4ruBqsf44Qj8iFC4G268CPwDl34EXiXLvwIfEA3dwQ+ois6Ah/T5dw+agCUFRj2IRIDWhe0wWhD0CajTUEdRh1BO4x2BO0y2hW0x2hP0D6jfUEHjA4EHTI6FHTE6EjQMaNjQSeMTgSdMjoVdMboTNDaCrdXl/YyWhe0wWhD0CajTUEdRh1BO4x2BO0y2hW0x2hP0D6jfUEHjA4EHTI6FHTE6EjQMaNjQSeMTgSdMjoVdMYoKzAUKW6ypvYxGn+K3vdqleVB+2ofF6r4W6O/nShdzj1V+9lQPbb9PV/SkbHyFTteNfMY3uKwJ/NKSPy4q6KVtku4QEnDDa15IBxFig+NGXyHhErY1WQXPaNnF11CZxddQmcXXUJnF11CZxdcQps7c84VUWm1Ay+rC+6oDxaffbD47IPFZx8sPvtg0R31waI76oNFd9QHC+6ozVIi6NgscPX/LBdnpFlq+F7XnIWwM3B1FjlOmDppEozg1Km0bZEjkBXa6Jqr7AEkQUpWZow9gETZO8gafirmekCdYYM9hZwKqDMk2aPI6YA6w5k5NYaIKpKkrGAPOb1tITQSqzPEKahnEXYFiOVJkEG6wUVSQtBZERfuoNcIOdOGboND0jbS1SWlBor7FFan2qS34JC2A1QdWpBDFuF9FbfcYZjRREWnYcXVaUhR/ciVAe2V8hTIQuXQrb9EPaaKdhyaDXmasp+ysPXjb73ylO/uMV8/5dt9zNdP+f4f8/VT1hDAfP2UdQgwXz/lh5Bmif4+Ps1mICrgTfY9n4d0H68hzF5zo+w1N8bucuPsPJdu5EldOoM679vNGGp+gIlPryZfVuSdJqT2MyFHZ6/BIabF6eAVZyRJSJKRLUK2GFGEKEZShKQYyROSVxkL3WVmSTkxbGky3wQnDvOUN7uYBmawkHgdDwdjIQYMFlyR9Ee+VrfzrEO/OjXvOwnWO0XWECliYEbxo8wYfqAJUkQvruAnbq7iJ2Tq7BC3rqHrdVL7nXMr6FPnvKdKtCuSKpEEWFzuWBEaa5EWCZDZhzkNZqJE2b85KDGmxNhpOihxpohDdVBWmLLCrl9BWWXKKhwj6WUO8kEXbFsMJcscDoQkPymGFLtiLZLEp8T9Y7B2aZ3rzVcJpL115Em2pte83mUtmxapqOhQUNHJeSsppRWpG8mkapX6wnJ1Gv3EVWrLaqvtGR+O/cQVavqKaOCERPldEuPUU3HRrCHFLz8xRh0bE/0a0gPzE6P0HqKiZRNSrsNiVq6imSzK81+MZ7w4z2Ur7CtpVVTkNNgvwoMWH0XDrjN5iv1FsbgcCkZGUcBY0cZzHYmhAxmodyh1HApZRrHCHLX+8TylNtQG68602eGz5h40iTcG3jjxroCXH0E2VEZLGffWtcScyDrtnZ8hYEy6liKhvm8hQp9YYL0/2XLEKm7jlsFPK9KKQnPHKRiulclLbzob+inNDr3pfTHDa/ffOwj9FEdMwWxA9o0ZhCdsyZzGcpA7dJLO04wD/Ha7JbMc40ftlkx3jFfaLZn3RNLcbskEyPjdditByl2077Ewp2OsQaFLo2s7noHRvTCWUgRHJSwf4BjF5EsSHKeAfHGCV9psKbyfDTnRwERlanD+reN5kwjrSJB44Rn7KlNLwGM48U+D/HJkvE8cMeGYPZMjKhy16LM4wsJRfybHqnA0nskREY7mMznydHPNHbwqS0MetsJt7tyoLCR5ErVwx7rLTp7cCZEQMCMqlvsQt2F7mbQuIkpRI0bhxs0iApn976GqeQVRVVceWvlXKFwy5o993NQ9Qoy5f+yuKStt8RJCLrNX2+LCg2ZuROUUNxs0na61xREGTbfrbUd8VNB8vNEWBxI0X5+iTzRkD/5BiGKmdbUWXwXBz36LtpRPIVfSWmaSBrviijQx9MSxiPv4GXQuxSmHPHSEy2pxYcGPgrokPyNOjv0pCqLegm0b/Pdz6Q239L5f+tQt3fFKH7ql1wKlO1x6iPahHGOxZZ5h9xfmWXa5YZ5jnx/mJvsZMc+zbxPzBfanYl7gS07zIjvSMLfZeYe5xd5DzEvsscR8kb2kmC+xZxbzZb4ONRW75DBNdgNiWuyHxPwM+z4xX2F/K+b38SWs+Vn8PjY/pwxogJoRpZmY5TU44tfhkj8GM3esGQHkmJUhdeVCmgshZvNcPGYKwfhh2wofm9h8hjkqc/jYDGO8J1n3MvbUimMROIOJ+jS2jkmerb2w0IpVbT4kkRIOD84xnTKwUrV52znDR3CaQ8iybi0IZ0AIM2ESJ3WzrWpR/1sR6IJiPS3qfWh9dPQqB8zSHlpZkkYg9l4B57CSKqT0sFmA6K2oP1ZZVSjqX1FZVSrqjxh7h7EHKquyRf0u//y7+IEOWlG/Q+AE4L9F4BjgbQjVQ9Xke5DQ8IKfZX1JnBMsw3HmN3SwRfX3bx9606IY/+U8lM2msPTSMaTVdv2LYRmmdbpFk4aQaJXeAilJhrG2TgI3qwDpvSrYhh1She2q3Knf37YKACkpQiQCtaptPLJKQmqhR4S249KeWXnUDvzGO9ah2nGfpLK4oXjHqqiSS2rNt5HbTWEUcFuaVSVU9x2rFCiioA5dzJFH7Xj8O2qetTLHCjFqTWPhFOQtNEySP8ZqxIoUOeO4w4TWZLzNasK6+hzmks9iHvk+nkNewfzxGZo7LMwbpj9n9LQWRmZthdZFaIzGMeAVingZRbzERbyIIi5REVsoYtsvos9F1L0iRlTERRRxAUW8wEWcRxGbVMQ5FHHWL2LARTRWuGV1nfWc6UsbarT3a1HzoKqLRaGNwdKIM3tD529yRJxwR0lMcWJqClNTmMbElHSZksTkCJMjTBNi2nKZtoipI0wdYZoSk3KZFDF1hakrTDNiSrlMKWLqCVNPmGo6beBdpjwx9eOsWdqT2UFdSf5ljeYP2mcX9ThiP0YfWgVvtshCTTVOumOsTcRXwHGG7mLBzvIig2Gb5WUGS3uWlxms91leaLAJIDCO40VWro8rDD3ASSHLiyEUeLK8HCK6Q5aXQ6gTZXlBRCCarNxiP2KoAiUXgh6R2gs/k1Vhsry8k3pMlpd2UpnJ8sJOajRZuQXvCHhE2lYEPiZXYPxojZyAZXnBIfdfWV6EyPFXlhcmcvmVlYv0sYC3yckXP14j9178eI0ce2V56SOXXtyfOjnz4g7VyY1XVi7jmwLeIcdd/HyNXHbx8zVy1pXlRZjcdHG/6uSgiztWJ9dcBTsGr3WF63++VquNyQAH7vn/hlG1H70Lt3dhwj9D6EFRD9lRHjgW3l8h2dZOLkJySg7mPQZvI8oTD8K7HFz/S3/tL//qN3/1W/Wr+ywsKeodHXrRGHhF/WvQ4IuzsjMUsoe6OP4mf29FPS5VqWAh21MVLGu7RkUd2tF3zJLaU4fQ0qKLoQKJFQsyL6pdRZM9yRdpd9PmRSRDod9hAEhjCxMM2e3R0GizpR291bbDxnH0QtpszkYfBiYffBJYOayCHSUFg0Mgh4LskF2yRe8FKtiksp2x8+9Y2So7siuoLLvyOOHuM7PdFr+aWTv+nlUKXj37Z7CMrd3ablN7XaeTyJCsPjuDflKGredkME7KoJ6TIXxShlQVzT45QwQZsqrgZYBqtZVx+9Ee6jyWQgeh/wzzmV7Um75kk7RLcMNyS4ZJjkaTN5HlZCKKM5TEW8vJHLDFkMI0lpOPLsVQHpNYTqauEkOVMr9EmjSOGLqNOSwnX+kdhu5iBsvJZPeAoUeYwHIyyzxmCNNDTWO4zjNYzp1iGwJjkmwKjFnOERgTVEdgTC1dgTEp9ATu8ySWc2fYgcCYIYcCY3IbCYxpaSwwJpSJwFOexnLu9DwTGLNrTZf68zSWc6e0hi5nBI3NBB2koS26UaGvEt4MVAHifw5K8IQsuvSH5i5dkBXsMLwHRVThoUW3xhVYD6hd2/gBukd+/11zT26CDVXCOJXv/InDtwcO3xk4fFMAtcsMrnEz7jXuHt+/QsOhQpe3XjGs4mK4Gv58V64qfEVauOkd+WFcsWZAT/+Q8piY+LRb6zrtQz0iYoto0oidpUZUiJPaUkLwNiht+XciVPs8/9x9IrPUE7ZgoMaUbAqmJ5XbgUkJlVcSLRKNGpV/p+rq7cw3aofz6Yojo9yjbbpGy41m6on56S2HLw+uGPEl/j5+ce6w4SdBr5pv4DNUOXuqV60jOnnYmnmVPpiClaEZ+lW8WYSntSNvWW9BkGpjRvpKFesIiasE1z+AXWXpiaWRfeUTS79vXaOpBU6mdHUN5EdPWPyorm1b2n2oklyj6QosBrN0NIgtwLUT5NGJJ8w8Y4ropS/yaMQTYZ6m/kRKub+dQHLVIsuya+ska4++Y+5yxxbQiLJtfIU84me818Fzv/EV9jSovWveZNUmW3uTPKv8xLvmdU/vZweLhCiBmJp6Te3CT4Ybo2OX7/PApr33aTh3bL1q7qisreONX+c3fvPmesh91I5o8mPs7aAAN0z4jrj85xbqFVW2ow/tn3h7He4z4viIcqpMXzA1cJfW3B0M5ogqy4i/YYfM16ixZVt/GBj4mLKv+4pc2YDSZhaVcIOK3HTbSwvhISeYmroJnSzOFAgoALbkp2Pbem/5oVlv9ytdF0bXXcdHdl0VuOtu3GSFAq/e17mI688oQkMRr5E3LnWDi3iVc7xK/Vd6Z7HHeQEsmDvqmq0f0dNyagfqbZjkKpyZaHb0HVVmsutYcs9/rrWjyqylkJON0E1+SRid/CWGl0YmjeSH1mvrULrZgTbOq6yLDh8/GKhl0GWwviGnUVSlRJOMDCrP7cgbNE6tirBVfLZKkG1+kJa5m3bDn+IJCXbsApODNnx14ft+y7oBv9cad/y75nUQ8aW9hgZA/6gic+2ON9e6TyILFd735RHKK06XOVK/CupXEd0d9Sp1jbpO9rN+rdySqBzYhrVci7HwF3hxkIwaJyTsiMo8NF+V2nGVr+G7wSZXvYZhtlM1r6sddZOrF2jtDYrfy23lRlLLytKyvWDLstyyPZGjPKdl1zgiSPnkNmFNEw+vGqmTyeh+VRyW6pWgvZxVDmD3rN33rB14f1oPqSMsKCHY3uMnx6E+cxzqM4eLGHJimzR112OYbWvkUcr/D17mA+E5g8GNOZa4MYdF5rDwHJZLG5VFwtEi4fYi4Y7/dCwGNpoUX/MgsDxezBO4RhFKXVssxijqa2seRJ6plnL1FnNd/8larTYM7etJO2RexRdr22Gc2nIkpkUHRuDHPFASKdmCFav1mpaQBTr8BauyTrPIm5jtWcFQP5ZhfGtdY1qcaHFed4WWJFqS11mhbRFti9dVoSmiKTTyqnrrXWwHrqrKu1QLel5A0+FLZvA9o/m8GaA6fAKfIXzJT+DThW/rE/g04VNBLpz3br1raz+mrmJPt2NrP2buBYZpacMIaXqYtE5sw8yq3XV9zUCnM1omJ2q0Gy2vh2yddk9ZtUsqe0cQyIZUFkpk6KSdbfOq2lO33jNvKdqcQeM/h+tb7MrUVVt792ZRn/ERuxEn5TbvtB0ikKKKFPXmCpv+8HFbTvx8igLnjspf1kP7ehgr4XtWFq74CmzaR8ocotpxFj8IHFPAt7uJH8T8LeDa9AX8lMwL+KmYF/FzZG7j57a5hZ875iX83DVfxM8D8yX8PDJfxs9jU+GnppkmfuuaaeG3oZmfwW9TM1+huNq4ESjIjUCBbhQ+h9+eZqbw29fMy/gdaObn8TvEp1CgmwTSShlrJimgTDQzgt8prhEKOOuYMXq+DpcddANxip6v41aHaqCrLLzekQBcp9CGDgnA47gTKJC8L0vR0yFjKJBoL0se+ii1p7PMHDooBfKvDrE3LqIK5FsdaxAuoiBrSJHnXZ3NRuF+ge+cV3ELjPynICFNKuGGjsZnwf05cKeY+zK4Py8aL2vQgRFuqHe8DG4FbpO5LXB/hrhJBvx9LjfafgHcF8G9zdxb4L5E3CTufcnlhlLJaXDTZcZZ5j4H7k3iJsnuC8zN62SOhhmpsWZk31JwQ8Qpnf1aotMLsnvGSNSXmONB5rhV4A1AhteTReZkkHkNVwTCvHUC81aQOWkV7LAwqxOYVZD5nFWwI8KcOoE55TFn+KoP3kvYxTO03Q3uzQzficOlCd5hCXfhTstix6psWEapW5J6hDukUtp43HacFu7At5hNMZsStttth/lqpJxQYqNHp0UeLTlHinOkJMcdN0fdzdGDG2MAE7Itb0HTIkURn0ukn3Hsy31irrJbEpcyMVZFomJLlnYcNBkI8p3iLqCnPnoOX5I7gyrV0Z7DGObuoEqPn8docC9sgLGpP4dR4yYb3A1KXpyiWhvSrdwhH/cWvzfUIOm+JGaquUx1zX1taBAFRq+wOQO9Wsd9ecx9x31j6CUOkc5G5TRa5HW5A0O13feJd0VGyCn9l3UrK4OUrE7cjSPL9/lAWErpPbD5A19b4lZB7l8Et/9NLXNvBbm74PY/12XuZJD7a7pVCswEzE2XahLsMs6msvwJhqwSc4ZO4Ax5nDui1k0m6HFcjTRXSKTo3sTC3wl9mnH3shZeT4iSdO9z4fuEPBtvubdk8IBCFOVeesEPCns/5jusA3UF6rK8TheLeher+BV7BtIgsKL3GJ4A/kVdTHyhXws5vqK4NbycH6T0uFmC85s1EkIXuCchrKcTQtGXjRdltokTmPRk47jOEtE4Lq1YMk5XUywXlxUnaFSiXqfNAB6bpH5zAG7R0whU9CpJ3EusVFScnhVnCR6tHZRGAvskpSVZrEerEKWVqGJcR5b10Xr2uiqIJSkqS8mKkhVVlbIeUe0pLUVpKVpmKe02yYApLc9nQYdUW6C6DYWTlP7VHzTz+vuA6j9oFclhTOUhaTk3RCtln3Yqcfz2NXOFFH00cxW/jm4m8DvUzTVS3jHMdfw+MDdIywbekvdpw5JknSnzNOls6+YZ/I508yxp9BjmOfw+MjepVM08T6VCI2Of9i0X8NvVzYv4HevmNtXKMLfw+9i8RKVq5otUKhQy9mmb8zJ+e7qpSJtJN02qlWFaVCy2X/u0zXqFisX2a5+2RZ+lxurm56ixupmiahnmZfzeNT8Po/OVKj1E44CZWpseJQo6OmETUdAxMPj2aZfFoe4pdSAKOrE2Jc5EQSdCiR1R0InyoMS1AUwAPgOFu1ewC/k+RaV+Fsoan4POh0phNr2s/BzqErhfBPdLzP0yuBVxm+C2XG76zDfBfh7sLzD7BbBfJPZtsG+57DRPbID9FNiTzH4a7GeI/SzYz7nsNNF8HuxQRoafMbCvUpwBYl8D+7rLPo7r76tiNtTUaDTizn8fXzQZLUBXkwwSWCc3xJYN8I1cZG9KbTbH3MeHT3YNsK4jmwV6Dxasy2LkAAGQuFSOYbk3iMJakNYKGzaQmzEr3rLWocrpHLNBg5V42sbWF0Hs4PW93WJVTOiOrbbJc0YLS3xf9KhHurXGDlNIKwYPW0U9wUah9sC3RjZ60A4Hx4Yj9+hrpM4Hd2sgn3LoDj6BPSiqFHfI+iH532nk42yl7St0ODh/zndfTYeNIlmKWNpTVt90O3GmcYBT1vRxu69OOXRSKWqzUQlpaR4HtUgix1a4zQE98tSL2ChQ23WyXpQGRqVFBjVBo+7wizlOkHsXmNCsckm40cH9/lBje4yMKtoTnfeY7DiQHMZBT96i8w15knMsOvNsWXBT7uDOK8MKkSswU4ctJW9iEM8SBpRkpm6tta1Iq0zmeCtqVQ4HH6fSbJkhTd0F5+oGyjToKGPpDnlECqTiXAKzeYdU8ecSDNCOcKAv6hSNax/3ltmiTsG6skWdw3hR0La/5YO/zOAQOkvdAPw1hpvwysVBwuCVpaj/HMNdwA4FxdWqyfdY0UyceJiG6KtRoIS75GoHisZ8WU/3fi1a/jwDjPFH0PNih+9Z0kKGrUaYd0m6MggVxYoY72/CrHuhsSw54vlXoktHulHkq8KP93vtoDYSlDyGovYzC1XNrK2Ry+Yihf+mswT8+3XiMiDCbbj2ifMWyKJFHx6Z4Cd+Q+ktCQXhGtDycCGUxpF4EyTLW63ttGnHaZ2m75WQpHWG1DzxJVxqWVtqi+IPQJSywbpy8KpCuemISPlOY8hBZw65zress+psIFecc8XdXO7TzkCnz831Qss6p87RR0hiGzp0K/ecjk2wleAYAhjfOhntsnN++rrpY6ZzPKF0hmcVQefYilI4YCpFWWvkcJOQlLVO8w2ef6FlbapNmhrw/FWK1ELXTJQbsxCxqjXovmJmR66LlKFlnVKnOFeMc8XYiWdbZjXkXiEi5TqF4AArNAVzD2HPBAX0LGkqWNtPPMf30w/uKx++995N4kd3FlhnCZ1ZYM0kvI0C6R/BlnyVKsK6dlSNLHOhHVmXy7EiT3zF8g/u+yp/8qxL0Gs/D2+iL6gzvFYmsFauYUlkGUD8+SVk2L8NBVh4oDJqG5ftGbXFE84KLuEzmCpvqww8KB2Ruwp1js+XZ8sGbkZzCVVUOStzEBo8kFuQot2YhKpmBpN/ERPm3w9V1UHSYqYTWZxvh1w1g/odpI5CVVW0O98OuR6ri3aTad0gzWFaL0jrMK0fpHWZNgjSekwbBmm1UUjs8Yv26Nv45Gnt/EFviXrcArilivb410NVf9cFs6OJUHjtOoIhklCw6jsBe35vMaQAOft0BiCd8BKW5H0SICxm4LXQzZCiDLwvlzx3KM/Lf/af/fHef/6ZPoaQGbY1s6BX1Jvzdnl492/Om+YJKblM2lomqWVSapmUXyBlliuRWa5EZrkSmeVKZJYrkVmuRGa5EuEFPMsyRBYtsjZOgez9DIcXkYJiwxzYhOjkzqYlsrUs3ZiT5tObaTaCgX4hvJ9T7+JQSBrtIaY+og6GHyxeIFqiK/WYepncr1P4RuauadTTrDhMl5otvkmrU0KKVYbpzpUzNIieV1kyDqrIA5wWWqK7LSE/PVgiaaVsuc5hqAHsTPhN0vDB6f1N0vDBrfub4utmh6rEd79vio8bGlx5LoWWumcES9FaLUS8Yj1j5/h7NZG1XOMSUjtkRR40J9xyZCUiR5pQj+F9QBhn1wS9pAxfb951EZhGPnCRZJvVIUVhjTUiRWNNlCJFZU3UItmJE9RecatbwPxVOGlm03lm6/2aTC+Y1zAtuXiD8YGLNxkfurjD+MjFO4yPXbzL+MTFe3f4gbNfp2kNtbDgrPSKumL3jSoLPpIXrAOq6gE5TK3H4I3E0chDN5n33EUHEPSAWk/gI2o6gY9JnSrPZ1d6C3k+gtKbYQshVqfK8+mb1KnyfKQmdao8n5NJnSrPZ19Sp8rz4ZXUqfJ80Cd1qjyf3kmdKs9HclKnyvM5m9Sp8nx2JnWqPB97SZ0qz4ICUqcSiylSp+L666QWyvXXSVGH66+TXijXXye9UK6/TnqhXH/WC+X6s14o11+nYK1cf53CtHL9dYrJyvXXKRor11+nOKxcf50isHL9dYq9yvXXKeoq11+neKtcf4MirXL9DYqxyvU3KLoq19+guKpcf4MiqnL9DYqlmldXaOwMBIxT9FQCkxQ2lcAtipdKoKJAqQSmKEIqgXkKjUpgiWKiElihYKgEHlEUVAJvU/hTAu9Q3FMC71LAUwIflBE4iMBHZaMn4OOy0RcQ424gMMbdUGCMu5HAGHdjgTHuJgJj3E0FJi1igTHuahGGMe7qAmPcNQTGuGsKjHHnCIxx1xEY464rMMZdT2CMu77AGHcDgUkHWmCMu5HAGHdjgTHuJgJj3E0FxribCYxxV4tK/TFeBMa4awiMcdcUGOPOERjjriMwxl1XYIy7nsAYd32BMe4GAmPcDQXGuBsJjHE3FhjjbiIwxt1UYMRvmAmM4A21mCqm9Eu2dovcQRftOlnlkPzCnv5vgOH6dBjF6ZDUTEg5FaY5tMqSdQ6v3uyYh01ayDoIRy0+IGd5pYe5ER27QE3KNoAMimj37rT4AJklwSv+YCPvtPiUSQY1MPKgPT2fr7Os5QJ7CTozgJpPsOwFsSjqMYYRiKIh8NCgcPUsnzEohD3BY4PC2hM8wRdMNtaNsElyp2aYLbCdMNted8ImSZ66YTaBhu/ZN9mGHTvGMIepjZsJWtvNNRIImuu0vpsbJA40T9EabyZJHGiepnXePEPSQPMsrfXmOWkLLNEh5wrTwt8iicwgbLkWE+Qyhew/Pz4yYpN6FrQx0yLqDNFOgzZiWkyxEcgp0IZMC6sNoq2DNmCaodaIlgCtzzScNMn8DLReTMYq9VL9jkMuW3jIUoc1QJrBZS9ct1yhqM3ozzsi3awztcG961IbTG0SteNSm0x1iNp1qQ5TO0TtMbVo97EhO7Cy2dCvaibuCkIHoV/FViK94C4jveguI73oLiO96C4jveguI73oLiO94C7DKhyE+hp2LeEPeNQesY3YgMUoA97kUKiaNgzDYV1BTnoLikNltNnQPEvufH1ilInjOWKMiZM5Ylw8Es4R2fEuOSf2ietMrOtBIpuc24054ikmNueISSY6c8TTTOzMEcVJYneOSAIj3HFR+CB26VHTzE2OLsS+PR6b53n3bZ6hoEjmCxyoyDxLRwPzAgcqMs/RwcC8yIGKTDo4PDIpbmze3OIv7RJ/qC/yF/oSf5ov8zepZLxQHKYWGwZqx3wggKQDotu1+9vuC1NKbbeUdqxIeAoh0On722g6Wb+8rC5S4jlIdpIqqc7do3tespJ5SV2gxLMQFp1Sp9TZe3RZTNY0L6oXKPFMyzoD+3p15t42XgiZ3RhPSRppwEenN5QuqfOUI9GyEhy1CHIZlbhH98BkgLOlNolltcVypS5F8VWr9+gGmOxyVp9aq2pdrar1+9sYFWT+k3hqJeAggApbEfsg/amlk1vg+P1tjDQyIDoHIjybxPiCnAyMzoIIY1QEPo2KAdIZECGaj9zfxjgfagn+SuCADIcKMg0icVaYZLN9wSHZizq0FZRDZZRCvQ4FV1ZMQRg8EjxlxSlc5ljwvLVCzkod2FrGleHQ7i6rYuq0Q5u+rIoq3NbVAUZIDF8zSAQKQf1Mp2PPmkMbyqxaUesO7TN52LB5GPuLv8NQko9EadrgPWBI8WEoTdu7xwzlcRCwQxFbS1hX6PBwZT2Ey5EHdDeC+HYwIO+G2WA2S8cIS5eK4iSBF90Q5BEGRlOQhoYudgRrangLHcEcDS+qK1hfw7vsCTbQ8Lr7gg01yPcHgk01uLoYCjbT8EWMBKvpGDtj9wk6Ru5EsI6OQT4VrKvje5i5T9Dx6dTCjI106wztbbO8bbfO0vaWn2BY52iHm+VtubVJm1xurWGdp31uMRuqP4CSXhEqKuMvQ/A0CVXVeV4vZr8VqrLH8qI9BXyO4QngswyPAZ9heAT4NMNDwEmGB4BPyRoEeEMEX4DXRTAGeE0EZ4ATIlgDvCqCN8ArDDcAxxmuA46J4AxwVOr/m6Gqikj9AYel/oANNqdVdAc0/nJLPJwc45uECh/a9psI1wE35VDXLfCaAl/edaPKpk1QwmbjYu2YgxnFq5+KsWSTVt4m3asXyUvLg/+/vgWWTxXUlctGcp/QFOxfrlw24oQCInFKWuI7sHJYmj1Q0doU5rUpwssXO+Bhly9jjX2+zDR2+tLQefns6Lxs9nX2gjXSzXUOIscusCa4rqe9B/u/aurmaV4SeH0d6LywjnVeUWc6L8dTjdfhus4LsKPzytvTeckd4r6eYteZWxyWDhf2l424eR8/IfOH0GX/MFQFRt1RtKdA7xOsfmjfmPxJ9PA/ClFsNMUsdaAlCZVWtBtACx7aJGaMRjfsZNEeQjyjqfPYtr4Aye0FiAHD6iIuZrfbjoqqLVy1XnLv0Iv2gLOcQhZSUzvNWc4gy1nKcg5ZNv0sfWSJU7R73L6s8nU3borpotuhm261wbcwsvUJw8UibreyoS05gXX+YahKrSkR6rhontCmi5L7LbvhoopPby5KLrvsmouSMy979g8E5eNdz009IrTvorcJHbjoHUKHLnqX0JGLPiB07KKPCO26aIXvouOe/92LCbnWK6k3zX22m70iBpCwn93FvW+IffkXraw9+s1QldXrs/ZoHKqaZVJHzmZDcZIk28NwlYxuxyEyBocdgV6hmwNLXxA77y8LvveXBd/7y4Lv/WXB9/6y4Ht/WfDNGiLLxPgyKblM2lomqWVSapm0WI0r7K54iRhfJiWXSVvLJLVMSi2TTqhGyYosEsUn9xLr0TLp9jLpzjLp7jLpwTzJjsGcK6XXorb2NivDd7Wn5gqAjmatPjUTxgcUBJpCTuHMsEZOx80YuSs2DXAOMNsekrZSVBVUDo5GCkE/3LdVAevCkSqcYDacs6O3tnHnd3JiBImpZySGkaiekWggcesZiToSk89I1JAY9xKD5ty5bdZeDtMlqtFqsx+pqAOX1qvY5FPweAQrjzn+bT75LDNU7L61t03eluJPoTsRh5IEnMN5T/p5B3FkVEztbZNH44jvvxinEWj9aeRVLRzI07LCdPUNp8e668i8pMqqkPxxa2dds6NqV+1tm7vishihzD9QuxF1hd6sZzcYVmnyN4z1dkftc+gSWBmVOBiBuQND0jH5N4RpxHe1d639jVhIx7+QnlD7cE+TDT3AaKsEDveTP0mXRIigl6WFzbXgv2MZOHULhW+k7pKkDLZPWVrDJK5A1nZcBHk6/yjkhWRKCnc3yN0LcvcD3FvCPQhyD4PcowC3Eu5xkHsS5J4GuFPCPQty1349wF3/dZ87L9yNXw9wN4PcToC7pCq4AEeGTjBDN5ihF8gQkuL7Qe5BkHsY4D6yo2pf/4AlA5osJPuvhMhfvlWAL4IcD4gC1HXk84eKKptehlUBW7g9DmBVwO5ul8NXFXDneJUDVpHxCElEISHMUtSNV70ArBATpiXWKrB13vZt8LbvFG/7PDEhbfvO8LbvLM3tvBWnxeac/3m0aYpnvcTNBXKSFRTPB8iOQ5M9ayq+sMCvWGVxK8hPsz7rLl5YYM+zEuPFueId5Vfu52gxaKvNIMW9WD8/z3aEqr0wT7vdVlvzFOjyX5gn3W2ri/OUB3Q5C51TdVX2VPtqV7ZT+2pPdlL7EpZ3S+0j0C7tn/ZVTrZOBdnA4kL0SO17M/53sd9R+7x53VfnoFD2FOov69AOIZ9l7K9MhbGjjJBr1yg2lDFsKB2n3VLxFo34nExGPPAOeczJXLXLI+2qDDIMFDhK/gDLz74Sh2CaG1XAd/PocBSBqKtteVuV1X7yx80CPDaTy7qClbajtxLbZkGlaYLzvHtncQFg7tshEjo0zrpChxK53MO1zxnGOlHIIGaCwdle2ZgI1o1CClE7y5gThRRiKmm9KKQQ9bPQ9SJr4ZK6Qtrd6UXPyv9viGvNnLqCFeKKeFbmPWSOTXDTaxrs2q6QZxZUq8TVGuqLZY6WKOMlymSJMl2izJYoNWPBEfRCddPsOaGEcBkLux+YhZxAm5xAm55Am51Aq0WXafVF2uKu11jAF8vVP0Fn5IRn9k+gDU6gDU+gjU6gjU+gTU6gTU+gzU6g1WIn9NMJtMYJtOYJNOcEWmeRlrWbp6oI8KdXk7etdDbUNzCOwzSOseiuVcn6HQethvHQ2qOgaVs4oM04fvgeBZczOH7dnr9BdP2KURg6w9puWy9iD7LIkWSOI/UiA02jbb1UNrYW2LbaLQqomiNz75xdekelqxxTLF7lnTe5OoP/Fd69GRwESZFQxDHa1gvlgA0ru3fWTy5VPbvUcLDUjtGGlDE1V2rqWaWmnl1qJFhq16ArnfxcqflnlZp/dqnRYKk9g26O4D9quxww9IYbjLknHalt901YZ9vWxbJx+6R+xwMRg5cXYfepJtxiaIjSqy92/1bZuIOBFAzVe0LPf1K5xuILOFc27n5iualPLDe8+ArWy8aDTyw3/4nlRhZfQgzi+z1IJwNW8Etvoa7hUpb7ztpoWxdEl2nX1p/ZZ7Cm+4QXgQ7bhErQYsv0Z/bYyaUai911CspFn1hq/vmlhhc7K05qSnuQxw6e01sDOMNvcQOtlTZE+EPuLeM57epqn9RdaBiUbJYaZjynYScWayy2bJUuuPYgLa7rzxkHZCTCdbESdDHa0Kll4edUYfLslqVJPhtRO1wRK6rCweCWBl2G7UD4nFc7bHyTxIb0PHaeG+qFuSBaxN/RKN5StE36f+o0uFfUmTlG6xI1l8rdUjvqEo6MO6zwDSNudR7i0Q21tVx8l4uPoeR1lHxuqeSJlHxb7eDM32bj8E3U+AIEuGfVS/PlUsGPOFNS7Xgq4qGQikB5oW1F2OpoLZgPmZrSOSl6VIzVuNUman8BQuGz6uIJj3rMmY7UjoqhYNrin0P9tlC/i+olGJa/uJCTspY4a5yyxtrsNP0cnreF512EUHpbbS9mLdP+M8zC5DUot5+BDvoLsPF6CdZeL/KWfyEbB2IkCwWcROZaz+p39O7uqB3cx9xF16lYcPywPh2lPqAuiqOLTqGLNtFFF9BFZxceS1qMGA1k6nAKo2ETo+HCwmjQSTmRCq/zqIhjVJzCqNicHxU63TQTa0OjFsXRolOLLepIZZsatSW+0JaxJDtcv1XUjzT6z7Pn+rn6kbrkDrlbV6fBtqLOL9VqxrVZRW2Sc7UJ0zU6PW7AtVldqM0EyWHSvtwhIxCVUKcXy+jpVAcNdTjdJt/8wTqQ6gE9ZMQPCYbFw9lsKg+p65QcWajDTKdnR9rkyT9QMt2yk0OnBueMzoWWrRnSNB0hGI3qKyFsMmWHuUs+ljRzjxxN7bLvIxKkzB1tcouHudziYS63eJjLLR7mcou6N7kF3RtzbyGM5k1yObSD0ER/171d2Lcn/0Ooah7iMAVHYSQcRtguilsGP0Lj0DtV60pKv2Pl7NAReQGbaFVur7qSfF8uzjS5eDPkYiwiF2u6XMyF5eIsKhdvsTXWdaBicl43YVdBShToIpyNp4IkMSRmgmxZumie5MhaS1RC0CV0/S9I3iLHhQkSuphx0hM1V0i2Yq7yqdFM8EnRXOPTobnOJ0Jzg0+B5ik++ZlJPu3hghBXck19H7qOBDf0fehAElzX96EbSXBN34fOJMEzbR+6lARPtX3oWBI80fahe5mFHKMXJQ2MGAsrJO4hWzRRzAmWabBPcodUJ7O4r+1ESQMjBoOcKKbIMBnksOQlAsmLMvARa3SV51ik9xElvQ+AzSicqNnjSDX541ATcB2QYST8MXJ7leBXtX/ZuCsV379s3JF6TyMIWDMJVe26kfyvNPMKxKEwwbSnhtAuQg66RpedtRjf9u5fNmbRfaO2xk82r6kSnc72Au5BPxOy+6cfWq/S5Rb8xu6qHbVH0pH/Tz4ocxfRQKvWniduyJFns1cVe32bbjCIrd0pBpNlYyzgVtloJhlUZWMoYKps1E8zCD1mKaFUNrqSrVI2JgIelQ1Hst0uGyMB75SNhpRwt2zUhPdB2egJiOBxAj4uGx3JBj3mscDQY25KGdBjrgs79Jj7AkOPeSYw9Ji7khd6zBOBocfsSDnQY24IP7ksFRh6zDXhhx5zT2DoMU8Fhh5zR8qBHnNT8kKPeSgw9Jjrbv2hHyww9JhnApP+vJQDPWbHrT/WCIGhx9xw649ZXGDoMdckL/SYe6fVq/Z0o2qW1at2f6Nq/gBGJ2Z1zKfvUBjCHTv6FfbhuBCUlRy87cjYuUUhEHM4WvHJlq2ONdeHm7Xr8+yeyGN8Cp7wp+CJfAqe6CfxJNQPuJ7sP7SMp8qgiKVB4xmofiDOzlwMM/Ua8WE7yp7ngobFkSco+0NYdr8m3gHdDrTt2JvW7ZtSH5tdJiLU9m7QA+FynRd5jE/BE/4UPJFPwRP9JB64KQl/gdKJ+7rKEZN5RJRI1XrDpbxFlDA8QArlbaIYVeuGS/kCUfSqdculfDHQW+b3qx2csPT3ObZsmYKL8r3gO9ZVqR1qFtw+qdsUJuj7OcdVKYuuKeBwVt2iBl5UX3QZbi0w3BCGL7gMNxYYbgrD2y7DzQWGN4ThLZfhjQWG68Jw5DJcDzLAvJ4DwEtUXYqgq1eU7b6bq4Hx9NTSqLF+PGxpYqBx9A6/OM90w2e64TN9YZ7pps9002d6e57pDZ/pDZ/prXmm6z7TdZ/paI4JLuUiblzYqIRM3DH+b/bePUiu7LwPu49+Ts+jMQBmZ6YHmO9eYHcHmMXMYIjFzOA1c7EAdvZJ8CVBLwvUwqzNBaTC0rRr42yMpkTJXbac6thR2ECF2jsN0mlLstKUkkqLqrI6kVNqMnq0bbnckpyoV1SlWpHotGSKapdVZvD7vnPvPd0YLrmU7VRSmT/mfud3nvf0uefxne8Be4EXZCjsdwvunqbVawWeuVZo9dUJNg75BvtS4YlQDt8YM/GsQGe8rjXMsssh2zU2fRpm1PLgunBTTvdncLq3qnu43rkbFWRhytQYgM+6K6GtYxhAdVckpc+FN1E4kj4U4WlYs3QuoKG3nRV1GRQ4Fp32jBfFIjnvhoWbuB1PQNbbmk2okIXRvidX8EGKtuGCOaObNNiWStlG1DfQIay6oumy7VVsMJnbwmQ+49Un/csssnXGq8VkEJOVmCxHJB6lyUdPTc6iMekleU2Sfn4WnFK1INEZrzSpfpnRj5v5Kek7ctejLVJSymq8UKlCntU+Ks5r+e7WcJatkSxbo1ns954l8d6zJN97ltR7zJLbf06JujDqsHBSeaxXta9Zjff9sn6TfPa3mS/xbeZLfpv5Ut9OPraJedt5llb4Q4WkQGmS1dKYLk+yWpoY+J5ktTSmg0lWSxMD4pOslsZ0fZLV0phuTPKBxxpycHTG6+VYNTX8RJs5n2eaQc5X4pVnvFbOd5+lM15xPMbaObzLGRxuIqyTw+npDI61EdbNsZVdrzLuu1sRWs75rocJQUtZyWE3cMZraFiQ891dtErDajnffQGtGvfdSxFaz/nui2jXuO8+F6J05oTdz23YjZzQtfENu5TDm+R89yW0fsJ3r0ZlDMZ892XETvjulQjtj/nuK4gd991rEdob893riNXfdcx33484vZ/GfPcDeIMJ3/1g3KNjvvshvOuE7344QptjvvsRvMuE735HhDbGfPc78d4Tvnsjft8x3/0u9NCEr79td3zD7owJXZnYsGtjSDPmu9+NN5jw3e+J+3vMd78XbzDhu98X/zJjvvuX8A4Tvvv9EVoa892beMMJ3/1ohBbHfPcH8LtP+O5reivaExv2ICsmo5sYvjna4qHJ4tmX2IQ9k9d4ILMA9w2QbSZf42HPIt5cRGtyyw7G6TnQPc53hQc9J/4OkB0mP8qfSJyvPblld8bpKlfNKT7MVTP5/Vx1nLiDT2WCPsiVcIrv40riFF1cYEzQ93BxMdzDtzeJbkj7zhX5othWPhwJXIIZ+mt0lS6Fdrr70EnaYvNqNp5l8Ie2oMGUxGPNSeFhuGnHpEsOWMBXYMP+Dsl2ledk2NR+jn28WFXY1W7CGAuIMnPvn4OphCQ/18BNMUX8OFBeTa/QltrViaWeLSyEW14K6qCXQF/CPsFK0tVoAWDfsWw9fJsFPthtMzs66ED1ppOmM8TBMjRvypkw2EKwFQWL0MMpZsNgA8FGFOwj2M+qDRH3Z55wCFViONfpjBLXuUFnlAjPTRxblVDyGbqg5JHPkMdUCfbqLzNZBrnLZAXkC0wGIF9ksmYO7zB2hoNvyshu5CA6zWQpx55Vz9D7OX8T5HUmWyBfYbIN8mUmOyBfYrIL8ruYHID8TiaLFp2hj0jDQX5IGg7yA9Jwa7hN9ZEm90xpWWdsAzx2mfLGNjBOhtIFKPK7pX0gv1daDfIvybuAvMlkA+QPMFm3pMhBdgMs96EiOxZmqqTvXHo0j+3cZmbws8y3Eq7VKjOOMLIDS+n7rUKAbYXlnthmPXaUIGpWVex+sMOhOEE+TLCDa3QQdUvpE65CTC9OORum3A1TvgmLaiAaFt+gIwvpWSjMcj3MUjTDPHV8VEw1LaWSuQr5v/idlsLcN8LcpSh3I8rdgz9XploWH5cVi0025ZfoNFbhnzbnPdPxeGcL41cr4X64hH1PGCjiTB8GBpbvroYBuDK5EAZgQW1L20V3Le0LfhWHisvysynHBF2Lz4hsLRwfZRgLdxGwxNGzYCI+ioW4Hd81eGKwXIFleAkcAE1oaBNo0YY5dw3tAy3Zuegj34w+8rXoI1+KPnKKPvJZOkNbSk5PVj5rw86826Eg8+/hTJB5z0eCzHs+EWTe84Eg857PA5n3fBzIvNfTQObbPgxkvr2zQObbOwpkvr2TQObbOwhkvs1zwKtyS8SSw6zWyWSedTqZnGWFTiaJtTmZXGJVTibXWI+TyU1W4vTAMvDoVQz5V0POAOYGOFHa9vI4FpRsHAs8OMrTzg0FdmF1hrbjO76KrW5az2BKDWwWAlWhmo0pt69CdRtT6ECFILzA0wKHmjbuwEoq1LIhOlK24bpeLSfb9KzUiKXhNKwsDfX0LEB7BCSAiRFwCWByBIQcN1+m6uAmwPQICAtSova1EoLRfQmfqrCDeXZo8zR0ISn23M54zQMQwl1hGb5aUgwcd6f9/Bl107hOm14z5eOmUe4OWbUP2tC1pEB9huqA6goaMNQA1FBQka8im6xGraASQy1ALQWVGWoDaiuowlAHUCdJm+zza0v54bx0XFkc8AyviYHiXKANSMuX0q7FFzpVx4biFq65MOvWUhpfHNdtkIN0THuHLmCLC70bsuhZ8c/EF13CVSZxplIVCQoO5Ksi9MHeVmarIpDCAaqKWAoHlqoi5WHKtvk0GG9JNjipNr38a4wz665o43O4wI7BLiMMB2EIm75zDWETLOm4zZe8TcyJPePOf8h2n5ZpV76xqgj0mEjSRmiTVkVRAv5YEqpWDjUR2g1DA4Suh6E6uuBGGOIOuTnUIfxuzhnlq27Vm7jjbOuSU4az5Zm06q7cdq969hvuOnvwgWuo7ejWRJxIB7EEk1RA68rtmzd22xWnckNZcUSalczY80VUJqKiooMgWhxXvAkp9lJ8QWM9IEwyq14fv9CVkZsaW5Yra/im5gpdYb05srGcaWxSSqh7Gnl78JJp9K3d3ZAfLZPEPm992rNeeuyFMTrDXFvYFK+TyToeCsk/hsyO5Brug1Uv+dKE8uL1LF1l1220KtfIIkU2ccfZ0sXV8Db4IK/wWq+v/MP7pGcxa61648+H78Ai6fGPTmdoXcs7PCLEdZh+TRHtn6Kmmw+01sQNccHSvsK54vl2tC1hWvTVUMWsniKZoiZvxb8Y2qyl3R3alEQtOy0r5PA0ThdYJ0MY8Du3oWASmNhtM57BB/gCQEhJZISEkISKz7NY0zWgRRv7WCYHnJbJfpx2lkV9nmPUxu6XyR5nY7JrIxuTHTvKRizudZkTJLB9ZrKTQAlMthMogclWAiUw2UxEJSzJrp/TJrEVZ7KVRGFMNpMojMlGEoUxWU+iMCZryaiwNexMMLuIq10xVwPnUrZmghOTlzUcLo6Em+ZI/Eh4ZzgYf/jCBokNfn6UJ86R2lsjtZVGwq2R2koj4d3hYOYb186CF+WR6tsj1ZVHwu2R6soj4evDwfw3qb4yUn1npLrKSLgzUl1lJHxjODj7TaoPRqrvjlQXjIS7I9UFI+Gbw0H6JtXXRqrvjVRXGwn3RqqrjYRfHw4ufZPq6yPV90eqq4+E+yPV1UfCd4eDa9+k+sZI9YOR6hoj4cFIdY2R8JvDwc13qV70VuqmTxu06Q1Sfv4/Z216R6zuOmxpFxYvNsShEbT2nQTr80OOjrX9H4gWzp5Y0Ek9EAWcPWVNNPFAlG/2lD1R64Eo3uwpV+vJB6J0s6fcrdsPROFmL7R9+kCUbfZYOnpDZquz1n+ThrkC+7Z7Be4yvEoau79TYnsdm7lTMHUAh3WrdN5dhiO7Vdncu+uwq7cuan7rYuNjXWx8QAnTYVE9chKsY+kkWafSSdGqZ5w3vghB4FWY3VuHob5VWj1ltHY843mAzR131zNffMM9fc5o7YSCo7xJskN7FLn9FALf3rLrEHWEmaHT+EFWlyzFGVvP/42wxtO0TqcLXC3qcnZzxNym5o48Bxexx7row9oacn/9Ii5uDeyudlmckla92pzvXBKNOki30LrXMO+42/6S1bUhMPJyAqzCZZG7M+GYDvKjXTBKaNsHc3BLaud85313O3+PVmmbrnhl088XeXfQtHF+jabD65eqvKdbZa/GxeT92BTuvVuxLVxlontV9eS2hx+yCZd1YemfNMWR6eCiD0M2Rk6p4tGuOPvmdqkX7do+b7RWVd4fxnZxG++sfif4RqVdeCtdhqvZ87KXdtbhWFK5ml2Gq1n0Flid6x6blLV8rhRbFTot3ee7u8ybPE3bHETgNTgC3sU0ti8cJPaFO8kR2NmmdbiRXadl7CyX6ZLsfc6LG1m9Efs0gXObyK02v+fVzilKVY59Wn5sAr27nf8RU36Cf7zDP8A/3gn79UWVV/rzU+jPXboCCd4fN+kKBmCRRc7oivfjpv8opmj6+R81WZqTfGfb3vGSzroq+vyLrN+5CxfYq3RlictgXq8Uf0+ezgUIYNq33eeOG9Y9HHVUbojcXMCig/95FtTbRuQ4MxX3qoBnH32yRfHjcxqulhgkWvVKTVZBB5pnm9QXwDle9coxPiup12jVq8QowSL1hWU+7QUxDCPYF5THoFWvFkesiUFqJ6cG5HUekBfoOe6boundi7b//Xt8RJfRed4zXnY/MAF5nIwvqem8Z3+C5VjPi7+q83B3/kHPcF6m8zxAz9PL3r2/4ruXcc5YkazL7iU1wiHGBU0Xepk+iOyX4S4W8oSv8GmEOdDIgutYFpdapWVvYNzxvR4Bu8zv9ELIYKTLcKgcZtniExBdppdGUp2Gf9jT9Ap28K/Q+2X4rSRUjadVduUONqwRn3iPhkvK0csYyS/j+u5V8G3uOVv0gQnWDj7Ncxm/7+nw0GsOHydX6XQ04sWpd/W1YXevnyPzoWPTaWcrpw5n4dfyHHYHDhjyz50yGrboJXN1PDecj89v448G6w5u6DEm77vshIMDs/fFBRsH6D44bbMSWLoPRhtJYO0++GxLEti8D4tvawgoKy3QctrEYZ/HyBnPeJFPXGN0iQeHvDdchsukdBrTTPV+4Iyxk4jTsOiJYBb8MgTLHMyAp4ZgiYNp8N0QLHIwxb5aTsPGKIJJ8O8Q7HMwgcHou+fFeS89S2OiE6karl5GvaB6adUR6BzxruisDHM0tA6NZycn5lg56ZiMt/RONibHWPArwV2RknuGzfvsrxjtx3eJUJJSElpCCPZPOEQIpaH5xPMAQhnKSiiPUBZ6XDyjIDRG4xIyEBpXHSLcR9YlDX8aJ8HMR+ttUSGC+kvA+iQkblBioXu1N1Ay9m+HsmAXqn9Zxvsy7MBo9uTvvSYOl+2/rK+fl9UowDVNZgNG/06rG5suk3zs7Styli3/MUls9o/JJbb5x+QaG/xjcpOt/TG5syUr2QUWFK8p8jrbs2byBtuzZvIm27Nm8nU2Z83kXbZmzeSbbMyayaIYs2a6JMasufFlKDAoumJuwJg10zjrF5NC18wNGLNmum5uwJg1b3vospp2eRdxYcky4o1E2GnhlmN4AfTgXZe2POPVxA7ZD0SwWvUx7zZ4xn0/z66XZXLm2fUl5aT+upp83BfIHJ6mqpjg6lCAqJuczPy4+4KkfSVM+0KU9pU4rZpXL2NevUwvyUT1fn2m88pJRD1W4eXoXmOVtrTF3j0dLvc5YmmGXEDLBQeT4fld9hGMDsg5mLObtljjgSIClvsMtlch9Skw2bEt/uIOxDlPGV/a+fjVxA7W8extd/0488POGV/iPsy4y8x/xvY2pGTji23vkpVwltHQZYZouYB9fCZH67R81ipa8vxzi9aXrD+3eOUXjzunQ987AX+1MTkbkxSTSzG5FpObMbkTk7sxeT0mb8TkzZh8PSbvxuSbMVk0Y7qk0WWNrmh0oNE1ja5rdEOjmxrd0ui2Rnc0uqvRPY3ua/RAo4uW1n6NLmt0RaMDja5pdF2jGxrd1OiWRrc1uqPRXY3uaXRfowcaXbS19mt0WaMrGh1odE2j6xrdUDTOlrR8wt7cwCUgk2sbuBpkcmkDF4ZM0gauEZmc3cAtG5P5DVy/MZnZwL3cMmw23qJ1bLRbtjzb6tlRz6569pDz1gYu9zjcRNh8Oz6PQfCjoYrf3cDcz+T1Dcz9TN7YwNzP5M0NzP1Mvr6BuZ/JuxuY+5l8cwNz/7K3c1trYzeh2qaebfVsJaRtfdXWOsImrxPSVlVow9yAwwGmMY9XFF2TOZ3pQOZ6piuyBjBdlrVh3etDnQJIibnBj/qwaIYNrCdVA9WzrZ6tpDSwpxpUS6oGqvimqgTadJWU0NCmKysa2nQlRXdN1sRjumOyJt46tNXcLSBtbtS610tiD/Xop2gJALIpOnnS0pRqiXoGKdUiFW6rZ0s9m6rGBvQD06oLoR+o6Br0AxUdQD8whValfPcSd6SlWpWCwOiyMM0BdFlLZDlknXN2qBd2VLX1tGqmegbqWUmr5qpwSz2babirxSlFmO2ooyjBflxDDw1Eyn4aKinLImDCDUxjSUXPhg1M46SCjlVAJw05UnRsXF7T2oDR/XWvnlFy7evwZxeSQUxWIhKPcka1OqPeJoPmZrm5DVtyDKT1dRXsZ7COo8MV0MtALhW9rgC4zrvOna6ATgZSquh0BbQzvvtB7nQ77nR7A7J86149G79CTAYxWYnJclZ/m1JWvUUWzbZ85yqc5li+8xHciMMKlDd1x3lxeGfueTatuMu3cdN4jc8eV2mZXtznpnEZh7VllmxwPbqmzn3e+G33THjTGGd1veim0YtuGr3optF77KZReCHelBT7EZEmim4ar0KK6BO+++q3dNH4Kr36rVw0erTiLNPoS7sfIpM+FF7+7fvSZ8KLRv19yeS34lweLhqvkUnXYiT/GDI7kmu4C1bkopFvOp/1TFq5jR3ph2nFOcNCWKbvnsHv6el3jXihDyd2+P3RaZp61chd4zJqmHw+fA0Udy3+2ekqebrm1dCY4JA3ete4jH1r1Hq+awxbEzfEXSaTG1dl+3zqrnGkLWFadNdQxVXuPdF8CpvsxT/aVbqmp/1QmHa4ZWfCu8ZQV034jJdZ8pUf1+Wxy9f/8n0xsCmPNXks4QNFwdEnakUChevsweHZ6DO1fPdMGIAXCC8MtEzfvRoG4J3iWhiAV4oXwwC8UbwaFWD67oeiok3f/XBUqem7H4mKNnz3O6KiDd/9Tm2qKIabCFOF1RMs0Yzv3gjzNSwIwp9W4ufr7FniNExq9xJqdjQh/b4VJegLTzIK95iVsH7C7iZViabvfg9dikuESLQ6xPKcZ2KFuhyFAxML1PoJu5OKWm+I8x/h9LctYfU3YSJgHTe42AywDRfwkuGG9XvpubiBBlacF+IGGlhwXorCXQPrzctRGF5PXka57bQAm777fUr+GME1ZoJFwSUsBtejIGEp+EAUnMVC8MEomMcysH7CbmXUO/UsuaHoWnJF0bdwRwE76jAVcmuD7YnYIsqyLgs1bLSIPDZMqJwRWWcc3J4NhbRXlfAnW/lYDoW0V9WvynY7visU0mYDFGxPZl22K2xN5Goog71K10IZ7FUl2c2WNl4NZbBX1U/PlmxkVLDpGZGHZnsjprLw8T2hBPSqGg1s2kMGAtsckTHABlU+Ekpor9KHQ7ntVSXCzVY40BnmhhjuSCo7GyJ4zVY15Odnwxzyy7MJD/nR2WSI/N5sy0TExdlEy3eEUtxcwQ5LcYvlDxQqah0tkDIcmiBlKDRAyjCog5QhUAMpP38AUhROKraUb/BBYVXt/VfBW2vjiWMyXxDlf8zEgg5/8ziOn4bdXMVxT+TkBP5Fde5ej87d2+Ghex2HblwurBfC0nKPMfYxMeImCWf8/3UHZj28JK2qpWPnomfk/6bpni446+Br/BVnNyfyOu6yV7rEJsnFCd9yyPEWbuYyLdOWsEC2cSklMprIgjulntwsxXzBz7kiwX3aK277ZCG2lKzGyhQhE3cZ9cy627KXWF6yDrlbwi6AzcdtFy4v7VvK7vGtwhauE5Zxe+CeZsVL1xLZJ9Gffjw5Vg5cK0jyvCTPv2vycpR8VpLPvmvySpScJDm9a/IgSr4kyZfeNTkuLdxlJF+T5GvSNfsmZ+aOc5queG1wgmjdS/HVJO0WnGXa8Mq/Yoj0XXztPCzokdkv4o0RIYmRmNlvGEPfMGbpG8as7RuDL2HD6/yKobbKG17wv8BIjVdjrTxlkBRJ8IJKnnJVzdErEI3PQNpmRZnhyAs1C8b3ijLCQUItgTW+okxwrAm1ydZnIb60Khx/8UUqVjh2hboO6cEVZYPjhlA3ITW4oixwvC7UXVjkWlH2N94UClzVoik0uKolRcP8RlnRFXFxuRKa3wgUXRMXlyuh+Y26ohvi4nIlNL/RVHRLXFyuhOY32oruiIvLldD8RlfRPXFxuRKa3+greiBLwEpofqNoqfZbbG5nJTS/UVZ0RVxcrkTmNxRdE+tUK6H5jbqiG+LiciU0v9FUdEuMK0n7xcWltF9Mckn7RdBa2i8GpaT94uJS2i9GnqT9NgtYS/ttXhmk/eIsSNpvK6HyVXEjGCi6Ziux8lVxI1hXdMNWguWr4nSvqWg43WspGk732oqG072OouF0r6toON3rKbpv88WAtN/mmwFpf4KvBqT9Cb4bkPYn+HJA2p/g2wFpf4KvB6T9Cb4fkPYn+IJA2p9gzo+0P8FXBNL+BN8RSPsTfEkg7U/wLYG0P8G3BNL+BN8SSPsT7PJS2p9gl5fS/iS7vJT2J9nlpbQ/yS4vpf1Jdnkp7U+yy0tpf5IlvaX9SRbxlvYnmTEk7U+yULe0P8nS3NL+JItxS/uTLL8t7U+yy0tpf5J1i6X9SdYtlvYnWbdY2p9i3WJpf4p1i6X9KdYtlvanWLeY56IgxawipmspZh9tiNj6ll17lTa8+q/DW4u8ECa7hgo3VLipwk0VbqlwS4XbKtxW4Y4KdyTMHqCe37L7r9CGN/g1eJrxKr8S+R7f8Iq/zligYyXBajpWFqyuYxXBGjoWCNaMsVOeWIFC5ZteJwnhJridVia/EJ1/CzX8hji5uSuzfkkFX5dgUQVvSnDw6xK8IcG+Cl6XYE8Fd8US+SneDHZfZfO/B7FaLtP7cLOykaMdnLXga4U2lDP5Dc+8PZkwDcNk1YQNOgeHLv/cEFvcPGWfUz7NyorM84R9Tnk1CxRJPF2fU37N6opcw2Rt7dC5U0bTjH2kwEW2SeYPKP8oo0B+FJgdBWgUWBoF1iLgo3jzc3jj/8kUHzs4Rm2ctRbEEc5vGv4/pDVw+/7hZfqxT4n7nI2z1hI9I+5Pzy5ZJPb2LbhPPeSyBBp8dOI+id2knoUgyFnxav749uUZeUsWZcs8EG8R7Jw+s0/yjCTPS/K8Ss6u6fP7JM9L8llJPquSzyL57D7JZyU5SXJSyQnJaZ/kJMmXJPmSSr6E5Ev7JF+S5GuSfE0lZ6ema/skh/NWsAmPix95J81ewJ0U+wl3xHe4Y7E/ccdmH+NOgt2GY090EQWvLdt3cXl+EY1aW7Zfx736Rbz/2rJ9A5yfi+i7tWX7OmyiXES/ry3bu4FjIwCHorzxgWTBRfTD2rJ9M8g5STLIWLaLk26GMg9c3MYnKPtawcUzg7a3vp8Mr/27vIk1YOVBmHqJB26GvaBk4HxR/DRiCBheB2k3yIB5E2Vb6sGQSxMLnSNpu0i7Tgasoihm5APuPpPs14aGluH1kPYsGTCmoj6uIf+K4l9F0vZ/lz2WG7DBInapkg/YFYspDhopSakw7QBpz5EB0y1Im6LUAzdJaVgXhYdHmA5VaZesyg1njS7SufDUfZGeCc/iF+lseEK/qE6SDZAbcgAFuRye8C+SccJufT8O/tYOGd7DXzb8U4aR2KGL4Dmhx//I8L3un5n5/4JvfS/iV2rf4S3eRXTyHylXVF0Jd8NwT8K9MNw36SL4Q+gUFNkyIOokU6Dhdbs8oWMYeANFT+Kne0foKbRE4VkUq+gcGV5RpRlDcxQ+jmoUPYHhotIc9loDk8VCvbYQttcRIkEXwR7nX7b8rzAclMorgBKAZeWh4iw6rfhDiksDNxFnIX8DC592lU0AB4Gblpk3U+Vh/UPsQWccUqITEA+FWzM3X2Uvy2ehWwdxEBuWFBPsw8I1q2wplp0zn6U8TAuw1jYmFMMbfCX8mQyv878bahgaXu0d5YbF8LoKtpEkhnsKTuClfi9ykGOwM2oZdYbX+L0o/UDBaeQN06PTf1fwDL6ZL0fJSwq2yPBaXw6LDyjrdbmX3XyVcl5P6GyVxry+0Dm89AHCSzTeiXzJGF4vDKDBlbjBaGYrbCYaN4gahybVvhw5pzG8TtwQdwytrEuh+MkMr6sCNgJlKUVMYhpeUwVTiOurQJo7IJBCYSbX8NoqYHEdh2gchjAnIPlzmPjNpqt7e84Mv16gv15bf73i8OvV9dfrDr1eWX+9ptbPSVQ8iYqnpOKDsHyMapt6tX292mC42rZebfHLerV1vdqu1qtwtrK35zzBNVX0mlp6TYN3hmqq6TV1hl6wpNfU0F5wGh/KGGy97zlzKF8+cjoYOIfxlio4HTh5fHiNm3QgcA7R9ANnng48cAp08IGDL6j/FZkQ0I6eormfFY1GdL4ST0Ttr8QTUesr8UTUzTO5gORCHkEzVIqjPFvmnUVuyw86OU2CTRMqjMkJewcWu/dEyGWK8ntiEnGSDsMdF88s1ttOcsS0UIKSDx04KU5CwtHEw9TqwuJ0dM9NDuVRoZ3/bgcDJENze/jF0vTEHn6sFM1AslXluLRTDVzrcetlrKBs5VjMznrgQtz9yoP7+PuF7eoe5R7SQnDlz//BH//TV35gbbsauKk4QJOBM0lptLlK6ZFcR4ZypbVcU4EzRRlalBkzM5xvKFdGy5UNZfois2vbVddSsn02PltnnCZYKipwJrBH990NZV3fAOu1/4NkQMqxh2dmy+7iCZM3eE5t2W08s1t26wfpLE2w/1fxWknjsu3c4nVjTDaVW7yqTMOo9TjNVgPZO2JqP0sHsUCMsddM3iLKAsBG4idoXtAl+ATL0UVcV9Caes/r23QR9yP0PK0tWcaSlTlwxCDeLLTusORX6w4Z+SeQahxuMX/TtmbfMu95pjNv7ZDMwhinm+7BPXecxnnAYXNvYi+NVZR3bu4hjtjDXkbF5t1JZNx1DzO6h62Lipp1pxB13Z1hdM9NU1pFkcuf6A33CUb3sPNTUUvuAUTddGcZ3XOzlFVRa+40ol535xiFJ3ALUVmgaw/vs6NsY9leenjftWWLx26yjWWbGEqBnH143x0jm8ZwaxylSiIqz6kSIDNDqcYBGftljO6U8V3NwT3pw8CZplm47H4YOAfoCbjwe4g5aQbOuR9iEB/GjvEhPoJDGJgPMfAO0jhTOQy7abD6DLjfvUkGPO/ekLF2XYbeLhlwtbtDBm6ENj3Dmc/RfO6vmfY9MvO/aLqWd/eFxA7787S8HLQdLFgauPuGm8h/LunYZFDCg1GZNz+OKwCDbFjqNsg6a0GQFdQ5jH/HJusqNEUws7DVFHZSqJRQjKlcfsrIPYucJjbX+V808z+fdM0TlrHB5Zk40hlLloFazMuCslnw3IdN857kw+WERdYpI+ea3uwnvNm/6hm7rl1ADASS7QIKtaJCLb1Qa6jQDdO852Xyhmvm/36STO9f/qmJFzO9hE9G/ses/H8L9Me/ptD610wvkTeN3Nct03wLRcvWgDfaCGQ4kJFAngN5CcxyYFYCxAGSwBIHlkCuoaflwtiIbpANuVI25ILZkOtmftyUB355mwtZi3099e+9pht/fMP757Pe3iSZ+VkemnGM91/OeP9igt9E4jL7xWUkLr9fXF7iZveLm5U42i+OJG5pv7gliVvbL24tP5v7qRkrfe+pt44ZXmDeds3j+EUrX5jBkaHzcCa0vWZ4ZcHaOlYSrKVjRcGaOjb4BcYaQ3l/nrHewxnftRVbyfDKgvYfzvgRVhFsoGPBF2b8WKjE8LoSuadiJUfxs1qOmmAlHasLVtaxhmAVHWsKFuhYS7CajrUFq+tY5+dnfIc3VJ+d8Z0kjDtRGloaCR87iDChRQl8XCkfh1MdzO8Hzu4Hkj9SZhoGXdLe7xuypHr1L8z4fEjo/5T+wurH/intx2kK1tWxlmA9HavZvpsAFyNDtmzOEmBmQNQ5wcyyWexy8OmamC+hIMGOx01vKfaejIkGi9U4PmTOuIT1h807cHBNBe9KcFMFKzg9Z4fFjljwf/yWEtzHNJJ96B6Umm1MJNmHrmqPjakk+xDaH9zKBwjk+LjI62N8k+UeCuKxhgKQ4qaLPYSNRfG4lnQqcBdpjMti7xk2SxfnudCaqTmVrLoT2HXbLGU8L0U1TPdJLcHhwH1KC7qBlNc33QNc3sB0C1r8pCqvaLkLUl7Jcp/WEswErnZz5x5T5TUtd5rLa1mudufnHlHltS3XkfI6lntCS3A0cE9Cx4KZpiYd5LfOogcz9EQ10LxZVt0nAprCwWgMzj7ySDFXDTRXllV3NqDDgbusIXNQ5DiAtNiYLWgx8wHNBO4zGlII2J0PZYiqATlazEJARwOXpKElNHScDgUkDZoSbykTAUn1zlD30wGaDEgqOzXUkTRNRwKSoo9K0UUUPcY+c7j0DB2vBu44NFPH+GTKdWToyWrgTmiF5QMaw1tKTRl6uhq4kyiSxvBCUk2GTlQD94iW7UCAC0iTDqKCuYCe4Sz67zcdYC9j8qGUDgdwClEN6OjQuMY2Bx2SxUYX0ZPDAxS13CCTFpHiKU5xLKCTQ6MOmyMTzP8pJHI40UxAh3gvjsLzAamiNrkolwuZZK+5eIG5gAqPepR97iI9fhLOcgRlXTnwf5765P1Pv3Hxc8yRRwG5KspYkgYPJbjLBWartMyRXKwev8v9cVg1UI+BfgZEhxK8gKsXzOw8dLPatx/vOQsuz3UGe//ChLaGqTXLmdmLH7BNHZsVbOe2hs0JBtGwGJwXsDMEFgTsDoEL0sPY1sNztUygcIAyQSZLVcVJj/BkD/3ro0hSMZ1JPMsmGCS4t3am8CyaTh7PN50DeNx1eN8ffGHGORhrFG8D6z6cwaHksDrDsK8wA5wXOkS56qMzVlB1ctZbdDDynP0axACyNFF1xvlbdQ7y5+0c4hnBOUxZmqo6E5SlyaozeeXUcwt/+Htn57elYbPSrry0K+NMs98i7JgT8UKCc7/tyH6Xp3wsFOiWXUR1oqh8GHUQIwYvE0XNhlEwJmxe+ej6R9ZO/oP3bTtTGrsgJmNXv07sB9iJP1MnnrSceKp24mnPiRcEJ54unSf2VcWL94zOgZicjsicM4NdDzYhk4q7/XMzPs0orjjoCcVNB31YceFBH1KbFdAH1WYG9BG12QG9oDZDoBX3vAF6Xm2mQI+rzRboObUZAz2rtnKgn1BbPdAZoYug86rNn5/x6YBqM+hp1WbQY0KXkP4oTVV5K+BmKEcZyt0quKq82hdmfOutmHUyNrRLmNciaKzqjlEGnIuhJPDz9TBH2Yfy3QUmDu/Vgp16a/qe/TeOGV5/7babO27wrsJlxUIb27JxdeGAIPnuRBgMeAFdCqPWfHdSS7npu1NxyoAvZliBDmeuNd+dUaYjEVzy3SeU/UgEyXdnlRFJBGd9d05ZkjT46OnOK3OS6vhWUAx2gyzFWccBCYHNDTl8ib4Jn5QA7/JhCdR1Pi+BusFHJlA35dRk8aXuXc4Occ98KAQJoGj67oFQFBIAxGenQ4FIABChPRiKRQKAGO2hUDgSAGRQD4cXKFzfXYhbMgXVlbpC6yIwyTRUXZqKhiBlS9FQB2krGroiHUVDk6SraGiY9BQNzZO+oqGRMlD0QMQdmYYcaEnRUOyoKBo6HWWLD+TWtXNGDWSS5WcMOhxKPBp0KJR4NOhgKPFo0HRot9agA6Hd2vDd6yDzoQCn4ZUT2FH/CzFzbrCWyQKZ3uwdr+z4rhlt2c1zRjP96Lir+xpIo32sGzVICZnZsPsgF3hUbkEHhdtdU89APSvqWVbPknoW01h37jopXn4wnsMK/1ZThCsN1sZl6R6DQhZlcbvqChzYlBdWcWG/ArpxAf39C6jZdEAKmN+vgF5cwGD/Auo2TUsBc/sV0I8LKNr7FtCw6aAUMLtfAYO4gNL+BTRtOiQFPLFfAcVEVEB5/wJaNh2WAmb2K6CE6wHjvNkCD752OOQtecVDETk4GJG1g8qtnAHkS8hTP6gE+gyvEZPNKI9qXWX/1rVxVVFHtV5HZFaZCdNNy7Ojnm3U1Doc1/SI1AYvL1VxbC8mO48n7MexpZmIHDyesBzH1mKyMvNYwnoc23g8thXHtmOy/ITvWlGDY7zzeAF9rZWPx5aeiGL/3hO+98kf/lTmLC4KhOKfqvJEZL1ynqCeYnjdeZ9s/sTxE9ky8/CcIRF5VfW8T+MxC2fepwkVmjzBNy5TJ/iyxT5hL+GuxatQ/IYFn46qNhZ8OiJVQYatgPFV8GlRdW4BzfuDRPzzB4SuPOJTIto4yoARw9SGVzzikyJbCxFZXohz5HeqfG0jhrANr1PwSUg8AjShFre1Tv7lv/fpr//yV//H3/37ql8bxNyJFEx+Ym6tPa302Q2v/jRHnVDTbPBPjCiq9k+MobjKv43jgn87HFf+nBnFVT5nDsWVfiOOK//GcFzx38RxpX8zHDeoWlFc8aE1FNf/1Thu8KvDcb2vxXH9rw3HdQM7iusF9lBc50txXPdLw3Htr8Zxna9yXPlY/CMPKgkyLv/+H//Nn/g7n/8//iUsu3+a72LvJ+LvU6PLGl3R6P6nedH7UTNs7WcS0RzV+UyUjmeRzySGF70eADTx9z+T8Axn8pjhrd1288cNysFaV/j7u1NI00/RlEKL/Br2Dk3RpFdM3vHdcfiqIJMmWaZ+Ql3YYACKZpx5yjDcAzj8jMMvyOW/K4Ptv8ZgwwFmnCaYCZTgZXOCPWgmaZy9bUxDJCe+PqvCxIlB42qp5fIwyWopEJ+48j7++/J2lUvq53zrLTrgWfCAwFvOiWVVF0zMJ2Lvyms71QBtmjpl9FNoch6SfuNekPZpKn8qXBETWJzzgZPIiffeVOAmSD5SMCBfK+TYFMIkrvQmlXpX3luDCJQl/Zs/iR+s/iXD18O1rw6Hg580h8KV1nC498s28ym/YkcwInLeJxPnjT9NUQ4WkiYo59nnjD9LSRJnknLen6bAlM3B9rCLYz8OmV7ed/Ke6YzDzIkMnSl5cIjCA2JeAzPCQuM9UpCiHCXlQJCqsoMoFZ5101X26anC5IJ/2Ugxh9JJ0IRneIMkD2K+1uWbj5zMWTg1OFnKsU9mcC5zlJXfkG+m33bF1q2NO48xPgcl+Hokx/57WUZR1brpIqZkcZi9kLJpFGUmhTmn7DxYbrwDnj4rKWlHMynPXkKeZfVs2PLkTew4tGG8wYk7PmbQR50fpHzK5Zdp8tGSZPquBRMe1ilcvrPNFsOrVB59sEUnvmRAeEDxJQHC/ThcRLgXh7tCDj6doJzXx/jK/W+WmeTrrZDBzfwCuUoylfqAXJLKJZKp1AfkCnSLj1GmUh9gitUHmNqRiz9TFAdAM+cmQSnw8y1fcXKSZIXc9YScuWwfN+46mN8PnN0PJB8lWzGYAlc/FXH1Mb30UzxFGRjeZPJ3sIJQjkM5FcpzKK9Chzl0WIXmOTSvQoscWlSh4xw6zqHc120rcy+L66K2edtNHoe5NCOcLAyyZUpMoA1uWoTFEl4x7bspkRBLeKW072ZERCzhldO+mxVxjwSbGhwTeY8kpp0ETztG/hQl8Z3k8QADKAl20DQe5BykMZoCucTsxixN0kGmMjTBLEUDfnOZ+WjAjS7lmeLyDbLzq5Tg6RuA1zLlojV8D9SPlUt2TzbGsK1ms/8IA8wT4Zi24TsJG+ImfG1k+3wPHI0QW10bWfFlEMD8fuDsfiD5I2WOXhsZPLiS0I09buT+r4n/SN+XUNfl6t1UijlM3ZTLeVMp5jDFijlMsWKOIczMLWFBmJFijiFMzy1hPJiRYg7TopjD3zVUYG1KRN81wtp3bct3PXwHZ8t3Pfy1JuDCIeH9gh2OmiWrv3DW6kN2abDAX9aCn19XDb6xZRdvYN7rGIjCI74aFaysYxXBKjoWCBboWE2wmo7VBavrWEOwho41BWvqWEuwlo61BWvrWEewjo51BevqWE+wno71Bevr2ECwgY4Vf4sxPCKsJFhJx8qClXWsIlhFxwLBAh2rCVbTsbpgdR1rCNbQsaZgTR1rCdbSsbZgbR3rCNbRsa5gXR3rCdbTsb5gfR0bCDbQseJvS//9tt5/gpV0rCxYWccqglV0LBAs0LGaYDUdqwtW17GGYA0dawrW1LGWYC0NwzrY/u5zRvu70W8S39HzdAXr6lhPsJ6O9QXr69hAsIGOFX9H+u139H4TrKRjZcHKOlYRrKJjgWCBjtUEq+lYXbC6jjUEa+hYU7CmjrUEa+lYW7C2jnUE6+hYV7CujvUE6+lYX7B+hHkGiz0Y3uB3eLeUjGZVBuyR7dLHMa3a+hplefn9wNmPy1wbLVxJGO9Ier8Z7YxO2JWPbtiVjyrpY/TaO4YmvSBYTccCwYIIy/1swhx7Sy14zM104S0bogWQ5nFhcxjrHsvvQBgTSx8L7LipqlzNQULHZQ91vAayVA5k1LEMshiOm5VCNhHahOCAyV7AYCEtx4FdBHbdcbYzLePd5uUR23UsjmzdEGsjRNixMmJ3j3WRq83wwoird14W+W6ZF0WIKPCKCKFIXg5VDZmwhsBUVdTMsI66qSppmKqWphlX0zJVPe2onk5YTzespxfWkw/r6Yf1DKJ6ipaqp2SpespWXE/FUvUEVlhPzVL11C1VT8NS9cyG9TQtVU/LCutph/V0wnq6Wj29sJ5+VM8grKdoq3pKtqqHcrW08e9/e8ROUGLt5f/HN0lCK+1lQwbFllzCmJH2siFDY0suYcxIe9mQ0bEllzBmpL1syBDZkksYM9JeNmR8bMkljBlpL0v7RXtZ2i/ay9J+0V6W9ov2srTfUrcvZqS9LO0X7WVpv2gvS/tFe1naL9rL0n7RXpb2i/aytN9Sp2Ez0l6W9lvqqsKMtJel/ba6QDAj7WVpv63Y+makvSztF+1lab9oL0v7RXtZ2i/ay9J+0V6W9ov2srRftJel/aK9LO0X7WVpv2gvS/tFe1naL9rL0n7RXpb2i/aytF+4BNJ+0V6W9ov2srRftJel/aK9LO0X7WVpv2gvS/tFe1naL9rL0n7RXpb2i/aytF84FtJ+0V6W9rP2cu6Pk1by3hjOst3EbTdxXEnTyhE2hWOhnAgh3a+OuPYO4Sg0dsdNM7fPWLZ7aYdln7tph8WhO2koRS3b7bTDkt2ttMNCzM00lKKW7UbaYcHtetphKe1aWrQmgrRzwDMcC0c9nLUgJyhOTA9wq9rw8mPwlC8i3NWAuICb0FQweMrnCmTK5zrfxDxlRFO+IVM+NxNTPrc7mvINxaXxxnj9TCKQFG/zLJyomsX/82tQ+sMiaIdS9xzOM0uL1w8OzzI7jOd5DhOzw3g+5vASs8NY3p7Da8zvYkkgDm8yY4slhTi8w4wsliTi8C7COwEOjhy+jvBugJmRw8wYu84iShy+ycJ9LNTE4ddZlI/FoDh8lyX6WHCKw28ifDfAvMnhIssNvsmyVwyUGCiaIgDGUJmhkiniZgxVGCqbIirHUMBQBVBFQTVTxAUDnmEZqpsiOBjwRMtQwxShQbFYy1DTFOnBgKddhloMNQE1WUimm8DpvZKyrHsX3pLJRon82CJaM7BEtqZvOdMyeUHmhw0hHZJJzjksE5+IDLUsqB6x0adZmTSdOZlInXmZXJ2CTLjOgkzCzhGZmEUEqWQ5izKBOySTuuPIRO+4Mvk7x2RBcI7LIuE8KQuH85QsJs7TssA4S7LoOCdkIXJOyuLkLMuC5TyjRJ5OKZGnFSXytKpEntZE5Om0iDyt86LpvI9XUecML6vOs7zOOmdFvmqDN2jOJi/Qzhav2M45XsKd87ymOxdEaumiSC1dEqmlbd4XODu28MqWwCqjWexh5fNmWapklZ4Q9Q/YrJ4RXY80tNpYtSNTpUOiyZHlD/2g6G6MVWlaVDVyVQguomWP9ovEv+2OOwHFJrTdnQx3KpQgF3xkh21jE3jBi9CsO0pS8BEwgxeg0UYFiDXOQ0lmjiajHVWCnkH+Zc5/EvlPIP+Syv808j/F+Z9E/uPIfyzKn6cEnUX+Zzn/GeR/H/Kvq/ynkX+N868i/wryn4ryw5L4DvJvc/5LyH8R+S+o/OeR/xzn30L+TeTfiPIbIUOPZ7jcD9uWee/wW9hnB/BYbfGISeJZNkWOoWQ6LNZQNB3e/L/pZEXKYQyP150cHjedcTxuOCxhf92Z5J27M8W7eYePCZvOAdFRmOajgHOQTwjOIT41OIf5JOHM8PHCeUIEKGbViGGDjI9GTg2GnFhnYrYq6hIQuGVViZmqaEkcroqCxCHuDFaPOMjQGk1L2k2InaJZEE9FK1kLVhJfh1os3uNRpzFwE12I14T0Jd4ahtYl7Zu4OuB+QfdzR7FDbuk7XDRwZ+K34t6V+4V9foOfS5iZe/ymWa+RueMmfNbgTcQaAhavL/jxmeLtNFO8nWYK22nPcDI4QEFYKkUZJW5vI5imRMRJF5n7JLh4aR3M7wfO7geGMvcRmAHzNOP9gZxBuUF9qLKlhB6ktiBjw3QxLXIyvFqk+UKP6XKa5WmYrqRZxobpIM1yN0zX0iyLw3Q9zfI5TDfSbA+W6WZ6C7ZgmW6lt2Aflul2egtCFUx30uzcnOluegvCF0z3oHan6H56y+4repDegtVYiw3K2vgf/jBscdbG/wgpM1LWkAojFQ0JGAk0pMZITUPqjNQjJIsxkxVGfK41Zo3fy7wFjbvgH82wuTOlccJ67d2fnvFZ6qH+m5M+K542+hmfGeu1dR+jxOILjM8+nIHSAEp5OOMmvOwrfJ+R4Cut5A+5ltf/TOKO73XO+Mx8SN65jaj8WQozsbZf8HAG16dpSuU3uDxwzz/7cIYy+U0y8kvYcPWOurxP6x/dk51g5/MzDqve9T4/I3vB0s/NvO1MeQnP9ixKupbiNhi3wC1ZljGvjGyKStyyjP4RjHTMtQvwtiEX0ptXWTPNxFuapwwi6+q1CQsi0OZZa5PM6Kb8l+5B6M8UlSkTcpkQoZ7csndy1g7ZqpiXJsy4GBZIjr2kvcZqbCZET2+g/HPGFgwQsF6bZ19zs8h5zjOe/7g7ds44x7B1DeB5BnPnjPPITpN7vAYHmkasZ71QgKTudXmrLTfBSiATBvRKH03Ce0pV9be2bzl2zjNp8kow8+pPQHf1FtkFvDx+oE3R17vq8kafnk/c80zPJquQZCU8WUOX3Im9+zRx5T879LPPv/PX/6vtqjtBU49mTFl0J7GuvB2JjVfdSbT4VuHW1QnTs7wEJQqeRblCzsGMNiWi73mReLfPGWzrQygv6Vg0dpV/DfQ3JJKtc0ZCBL13RXlFbksg4mwuWQYPPXHzOlR2Tux79I5u2d3Pz/BB4Av8KH1hJrjya7+Kvz/aZm0ZgD8/IwOzQlVnWs4SZYKYNpMlgqg2k0WqOpNCDharzpSQ/cWqkxeyt1h1DngmH2amWX7T/oTPKl/Y4Ewwssn3hBUSLXNnGkq4uBEMgYN0iIFSCByiSQaKITBJUwwMFhUwBVUOSnj9EMjTAQZ6IXBg+IzD711bpOm9LbuFHuKD2CId3Nuym2G4skiH9rbsRhguL9Lk3pZdD8OlRZqCD7UwXFykPHysheHBUToAH2yfn8nROGofV5PVLptQNLwea1adsLs/PaNkxUTVqvIzMzA4oaRoBAt+RlPd6gpW07G+UtP6aV3/TrC+jhV/UbTqIiz3T20z9a6MziE+pzAz9+d0DrE5hxmWa4r7tlkV3tuO2CXAyFa8t+tV4bvdqA4zIm+qnK+rnHejnG+qnEVTZS2Z1WHmYjlkLj467EruwIyy10IuZj3M31D5Y6ZhmL8V5m/H+Tth/m6Yv6fy037MzYi3GebXuZsRa5PzL0VM2JBpCQ5nUnE4w/yNMH8zzN9S+ddyP4YdlXXP44HYtCLNfbi2mRd0YMWTJEu+gzdh88C2YoG6WzkniZWSvYfqpfCIt4eKYC4Hl1DWS3DMXNiS9r4tKdmPt6TJ5VSGW5KSlnQeb0n58Za0uIRgqCVW1JLuvi2p7NOSNpdTG25JWlrSe7wlweMt6XAJ9aGW2DlMBgknIwX1Hy+o9nhBXS6oMVRQIkcZ78vGi5R8g8w3KPUGWW9Q+g2y36DEG7nSj5jWE/eOv4UFwzPJvM1NrCRclrqq8JbYnbtVQOxLBeeAbIq6n0mgwlOGgRXZOAVZOXfMM55/A/qVaMwB3h/ZHPkOBOk4SuEu7z28QIpX8r83t6MVlMYKeElLbcH6FV695x9bmAaVUARusP0aNhOG98eVBKZGLM5zenpTSRHGKlyDbdmAGFCe70N+yGAXh2EbDwjKhn2gBJ267Y4fNzQFHc9wxqDvcZLFXZDPzbCQk5vyyn9i+s60tYMjBmTrppVMGoTQUiys6abQTIjdecFJCJO0RVVpmpIeaoOIYQZRlMkvU0r5X5Quf34CJvIzIplosajNNGqKN0AGn21wgIKITZot6rCB8JSol9FcNX9Z2EWaSOAcF5OIirHeCn9jtqQwVyUuKS5jRDgQuZlHyocYZ56mQwEgSEVgO5/2aTp/iuZ5sQjYRgLNQ9GlO+az+bh5rgeF0/ytQi5/mTJYGTNKusZiWUHUlfQqJ5UcZ5LdRZxUX8MXt7VuWLYDuh8pr2Z2bomIL3t3c678J0c+8kr+r3790q033MmCUxCZX8RFOmavwTOZZ952stY9OS6mvPLTbNQG4+/Tiaq7CBn2eDCHOavu/K2ridgfs7NIGcfyuO2Lmr3/Oc/MOakrjaM/+ocfaPyk1vZ0wVnwTHZSyBWnvYZUXHhAkcpYkbKe9YKbLaCV1wqBEoUTzUAaaUGBLMdG/Sn4LUjRHBUCZw7b9bTXlbIXHsTqtEXiYi0pthQWuzBa7MJQkQt4JQubapsnQW571istSaexJB+Xc3S0nKNkO+mhso6q5mW9epi9EmY/Mpr9yFDWI2hGwknn0IWAX0nseAYWCJ5V0pMJwzQtdu/GXYL3pLRnXnuDJt9w2CpJ79OJK1P/7B/9wi/99c9uv4b5eNq6h6yUueZmJwzPpMxVSn0cX8w1st8oyLEOX7nY60hHEo+5/EkYdclMyIfJcDQHTBjvcQqIXlnTPy1s2Z3PJOS7qJ9Uss78XdROqndx5mFRBc05awUnKUmLNPdwyx6coCQVmCyeVO2HF0J+VwyqCTA0MlcnzHk80U3a5/QG6V8R0mTYUA+laD7uvAmWnWOh3txZ67OofIFrLJ3kXyPJHxdLgWZ4SqTUWat2Up4/g+dRTl4GeYTJykl4Mk0p0WA3rVdXwG/kJa4V+HfgBDlVXlgOv1viea4rLJC7B4LFXGfm6gSboGHR4rNW/SR3btSgoUxhkpz8ks5BSnqDE76u+rmwrxboUW16iMlYV9txcPEDmcoNuYdKRuLnOSV+nhsSP8c5adoPRw+k0Q/RROguZm7I4lSO5nCy8qxP+EuWwYy0Ki0EojuMSDDUqvRk4D4pUseM5Kt0PHCPi7wxI7PQuXZdES1mhKp0LHCPYZurkKUqOYHrYOOqkLUqUeASjqQK2azSYuAu4gZHITtV1qLHHY5CdqH2DpXl3RxNYF2YEAYhM2sO0ZgI2g8ZX8FXmaCDNKa/KOVgE0S0rBNiDiIHj7XyqgmxCJGDt1p51YQYhcjBT628KiMEhPbkVRlZArK0J6/KyBqQtT15VUY2gWzuyasysgNkZ09elZFdILt7/Ko4t+Z8vgnw81chljrr05gXpO74EoUfmy8j+ceH8D4EWF9kwl2gI1XnCC3Q0apzlBZoseos0gJR1SFaIKfqOLRAx6rOMVogt+q4tEDHq85xWqAnq86T+E6rzoInttBU+XIlYXOcfs33pAqH13zHVTi85nNVOLzmO6bC4TWfo8LhNR+pcHjNt6jC4TXfURUOr/mOqLBc86nxMQa+UyL6CJy5cSNn5GgMsWPRJSbeK8cdjK2O9Gr4EXmmk+UBhu1H7o7I2sIuydzIKJOfSTM/M/dQ+JQZOAuyvLE7YPNjhZpUiS2vY9zxncMeRJuzuExwbB7tzP1OcyxqOqJ/udoWFMwpsrl0x6Ypz3xDXxJZNyCvnO5cZ42/Kuz0TWIxmxKP1nNc2dgddaWMj+d6+CYqL4teV/cwnAKTxjAroBQbnntsUg57JEtYHRbgh6zpMYXXnaK0LMLYGo9JBvBqcU2icV24F3JKrDjhNWyoYiSghJEFqyYn/dbN+c5hSnidnO/M4NI55ztP2Ds0KZvBw/KYkccT8kiwGzTNBt+xmHRjMrbX4jypTd3YI/BMau8/kx5EX8jkMkZTsgOeAIveOYJOK6edo3iW0s6i6Nc4hOcg5Tg0Fu6QMUSxPR7Ln6IjfCMeOEfoKN+VB85RWuRb9MBZJOL79cAhctjSRODws5dzjuHZzTkunp2ccxzPds55ki9+c84CtHLm6Eg4P/ckfDScwbsSXgzn+I6EKVwF2hJ2wnWilcsN3dN4rALkNTKacHwCju48AwITvCDxRJ3icQU9Xs1QDX9EBymFvnRt9GY67M0x7s05DL4yenWMe/MonkX06hj3JlE67s0x7s102JuzUW/mo97MRL1poDdZrbhAc6rz5whtcNI51XmO6sxjqnNd1dnHuU/4B9hzn6ZC1V3asntQhTpCx/fcp4Cc2LK7QI6Su+eeBLK8BTd+CVqkY3vuM0BObcGvYIKInD13Bcj8FjwMpqPVwDmCgFosnKMIqLXEWURALTXoh2glchwE1ELlHENArWOOi4Ba5pzjCKhV0HlSznm8SMrkT/POHC8Ajcz/2xaA5PM8o7dSvr4IQM0oQQUagzSPmETFhVyAPQFmH45qxFGDFO87BmFUM44qpnmTUkyrqFYcVUrzjqYURrXjqHKatz/lMKoTR1XSvFeqhFHdOCpI84cbhFG9OKqW5m+4Fkb146h6mj/nehg1iKMaaf6yG2FUMRdFNdP8kTfDqFIc1UoH7hpfHEpUOY5qpwP3NN8jSlQljuqkA3edrxUlKoijuunAfR/fMkpULY7qpQP3DF86qt8rjuqnA/dZvoNUv1ccNUgH7lm+klS/VxxVzATu6tajR/h7xVGlTOBubD16hL9XHFXOBO7mFrxSqt8rjqpkAndr69Ej/L3iqCATuOe2Hj3C3yuOqmUC9/zWowd+K4adC5Sgp+lElc4HHIHQcpXOBaqEp+lUlbYCVdXT4JzgU+A2PUVLVdoIVOOfQimrgbzlsl3POKuMLlfpbKC65SmU9myg+u8plHYmUB19EqW9L1C/yEmUth6on+4kSjkdqN/4JErBB9qS0DwWBzVqnkEpTwZqeD2DUo4Hahw+g1LcQA3YZ1DKsUCN7GdQihOoT2AFpWCKKEvoBA4K6qNaQSlHA/X1raCUI4H6TFdQylygvuenUcoqFehCFRzwekYWCz4dyJY6JVtqXjhcO/+8zHbOrCwMc2oPPCvTnzvGEgM0JtujkDemtMmwSVKQzIUM5RUk0yFDswqSGZEhUpBMigwtKUjmRYbWFCRTI0ObCpLZkaEdBckEydCugkbmSFbE5ffERVoSu79Efi1c2orJcH5UvcloKRlOjarHGS0nw1lR/SqMVpLhhKh+OUaDZDgXql+X0VoynAbVCGC0ngxnQDVKGG0kw8lPjSRGm8lw3lOjjdFWMpzy1IhktJ0MZzs1ahntJMOJTo1sRrvJcI5To18W/mQ4vakvhNF+MpzZ1FfE6CAZTmrqS5P+TYXzmfoapX9T4VSmvljp31Q4i6k5TPo3FU5gagaQ/k2Fc5eaJaR/U+G0pWYS6d9UOGOp2Ub6NxVOVmpGkv4VtJ7hLykXbu3VaUodBnAoaOV8tWngfWB+l3Lhns6mhPjihtXphPjiVmSeXSczmWHPyUwabIVGmMhZbC9/mnUvoaRpKQ1NPm64U0oCBIeDjZBdDM5N/eQog0Yp+Ddt5qNr7JUZxV6ZGdXunxHtfvcwXriS9h1o+ZbTvjNGKaiwOuiNYhra5SnWKp8aPj7IrvcbHiCydJj59RWwz9O83S3gWUo7C3gW07ILHKSco5QdYq+npWdC9vpS4MxTgW9eA6dAC3whGzgLdEQx37EftngXfFR9+jjgwimECCCmYcALM1BB5qYFmbWOyHx2FDPdlGzBpsKZb0K2YBNhOCdbxFwYHgOnsYppSMIJmkc4ocLDpwliSWsn+837zxpuN+bjKTH62oYRZN7ZTgjQUUBedresUmDJrnhMgJ4C5GCwx8oF3L/xr0ST+VUY0IOQWFrN/tnwnbJSn0Ay+2elRoFk9s9KnQLJ7J+VWgWS2T8rO3mBZPbPyk5fIJn9s3ISEEhm/6ycFASS2T8rJwmBZPZn6LqCRBiaoRsKEnlohm4qSESiGXpdQSIVzdBdBYlgNENvKkhEoxkqmgoLpaMZLYVoKCDNaDlEQxlpRishGopJMxqEaCgpzWgtRENhaUbrIRrKSzPaCNFQZJrRZogqqWmySAYhPp+2mKO2iEMdsUetQl0xSK1CPbFIrUJ9MUktowhS/Kaff2HkAxgyk2F5TTh/zPH1QJv9tUS3CW7K6/6J6XOEYgeG94yUFDMAsA9Q4vAJe8DuelNeWYWLaQlXVLikwoEKl1W4psIVFa5zmJXh1XSc8pp/zlikIwGs9u8Yq4yHUiYpLxCorEEVgUoaVBaoqEElgQa5GKoLFIzrzfikxc2Y0pvxI4xVDmjNEKisQRWBShpUFqioQSWBBnmtGQIFB/Rm/Jg045DejJI0Y0ZrhkBlDaoIVNKgskBFDSoJNDisNUOgYEZvxt+WZszpzfg70oyC1gyByhpUEaikQWWBihpUEmgwrzVDoKCgN6MszTiqN+PvSjNIa4ZAZQ2qCFTSoLJARQ0qCTRY1JohUEB6M35CmnFMb8anpRlPas0QqKxBFYFKGlQWqKhBJYEGx7VmCBQ8qTfjgTRjKWqGdqPH+xO5xFcL12cSuF7qn/RZ1gBSCvzlj7GsgWvnL8nVprrgPDCZNCzTTiRZzafzmYQ7F11N32JJWL7o04yIzsOsxDHDq9u33dRxg1KXxSsyPwP1rKhnWT1L6llUz4EFbjlawJw+NkxhYSNk+TCrYYHX2x4XVz18nWNhVlDBHQTl8IzgJoK1KLiGoDA1EFxCsBEFCcFiFITwu9fKhkGIscPTmgpCGN3rZMKgUaX5IPoTM7spsQOSjvon/xx+bGwyIMQLP4ZXIAhRNu/T/P3Y8QmwihnKex7aqQYsrpMWNnf62gSMvKdecLLSKSIAic3XPFl8+52jLHt3wAzqZiI3H/MoeGDd16RMCzRPhdcKLm+h5qv8Jkp0vj7FeaHVwRmL9rea8ZDKeF0ylr7ljHMq4w3JWP6WMx5VGW9Kxsq3nPGYyvi6ZAy+5YxLKuNdyVj7ljLydlQWYJZZzHtbdquSGE/klHAQzg+s7RcV9vBtTaIkFgCev/Kzne//a+8/+rFtiknUeOVvd+8t/9bnTwMPyVuFqjMvpvEwDNy4HKdgvSUmphyWTCu4T135T//gqdOZn3lru3rLTV+Vr3xe3CBF4xiHIb7wdB5G0e6RvZwzxywgZx5beGzTuRfmqPDA5cCtQsASMiVpyDGtIXPWW6Sq60t1R0ery0t1Eu0e3cs5C+jnqoPuxrUkBH4WbhXcBZp7wNI/C68Vgio7lSpLjce1GhfiGgdS4+JojbNSo0S7i3s5h2jcY/t9Rb7Wo3E+fID7GZgcKFTdp7EHHmehJLGnhvMKGPo1JHkaO71xWsIWeJyexE4PaY8pEap/Bjtsx+hYlWWYZFuJeFePd8mtUgGG67G35qoItxALuJS9VXCJFh64HEAHuAtVcIn7Jjdlgc19DxCYQ2CONZzHYVC5wSmwER8ndq+Ako/rFaNO1MLW7i16Kh7z5LzGh6jwhnmc5mOhMHIeugVR+IH2j7sgQr9HqvFaxXbRI4vpD9256l6VxsPjw7gcQmumHDwD0z1apTBJuCdXiQYqUd90F+NEAyQaRIluylk27x6Jk8ixRCWom3SUtMhwi6+iixYt6tFFK1D9WBA9Jjkq68XLEUclaIwUH54VVHRppPiSJR0eD1WW55wXd2S9eedIjn+sI8h0FJdxi7RYhZk1jEKsRhUYqppnW2v87CXkWVbPhi3PLs7BQQobhHEnheXcMxxMT/VjIqKY9HoLsSBBElZIBVNHBtwtyYrNcZgmlU2oeP5kQxyZMEEWMkGcIBsnyH+zBDDQ8S5V5GCuIxfamQqbWcvL5XzSK40NXc5Pqq2GXM1bknT0mvYqi1mVwCt67II+LRf0aVzQT/FS7SRUYrmCd/J8BzbpZCnNqgtchdxdZ9QlveHOv9slffoF1OBY4LgOX9JLWRmaUhf1Bh8u+Yo9AW9uE+FFfVjp2B3KyMU8BDHDt1L53Zxc1qdwsM+Fd/UW7uotygpbTHKENULSUu7qwQx2JiCmGGpSqbv6SZFZSItQQqgF3rNxMZ+EPwJmcgFbQgFJGFdMP9pNzyJXEuYTE9xpsEKnxiDlhAtoMbc9lX8eO+EkXo/3PeGOOOmt+axYD9N1azBvCOZHEtzggJ2CM7KJfw0gDYXs4F8TSFMhu/jXAtJSyHX8awNpK+QG/nWAdBRyE/+6QLoKeR3/ekB6CrmLf30gfYW8iX8DIAOFFE3+D055MSVQiaESoJKCygyVAZUVVGGoAqiioIChAFCgoBpDNUA1BdUZqgOqK6jBUANQQ0FNhpqAmgpqMdQC1FJQm6E2oLaCOgx1AHUU1GWoC6iroB5DPUA9BfUZCm8SJmC0XNgJabaQzuQkG0hnMsE21JlMgsuX8t3QPL0dcj+TXukYRokNg4DcqcfYMCDz3qRjGRDOm3QrA8J3k05lQLhu0qXHQuOBSzkZhvLZ2GIiMBzM9SSY2ha4Itc3mLuTZMv44PokQ4P5eYE3N5hRlDxhr/GpkKbCw2CGsuGIz+EjyymeD0/V8uGHXB1b5GNycoA9rgTWIU7fqiTEdKEn28I5tS0sqMX8X/8SbD149YEp0xV2t2NwJqwHy8PB5teGgv0/HQoGw8H2V4eCxeFg/V8P1/sncTAWh47+4v3E21d+7fy9j/1k8DWIVD/M/6wZm3/GvjTc8+LlRqL33Lkrwf/8h//upd3/foti8lYh/z9gyTbGrZzy14C9Ow8u7nHuZ8trpdVaGXa9JUPunNGbQOoJNootY9PyipMcLKlgSYJlFSxLUEa6BRI8uD7KqUwqyfhwMFhe7YAvB8BwUFhwZQ8F2YgRZnklRsoaUmSkpCGDaVbG1ZA+IzH3zPIqnEtjnlmwbC6HSK3+Wa7/gFY/I2UNKTJS0pDBE1y/hvQZidlmllfhXBrXzILxbzmLavUf4fpntPoZKWtIkZGShgx4u1PUkD4jMb/M8iqcS2OXWdAQkCOtVr/L9Re0+hkpa0iRkZKGDByuX0P6jMSMMsurcC6NT2Z5tSd9ORlr9T/N9ZNWPyNlDSkyUtKQwVNcv4b0GYk5ZJZX4Vwag8zyaid9OWBr9T/D9T+p1c9IWUOKjJQ0ZLDM9WtIn5GYNWZ5Fc6lccYsr7bqyzk9rr8Ps7GXVRb4sMiEgW7Kd1NhoJPy3WwYaKd8V0kFslX9FvTrwQ2bxzGqhlBBzsDuAT4Fiy1mQfvz7MHOcOfFIrOgg3nfTfIRtsorJhvNF9u0c2xVIDTYDJsPfBmmrgNYXxEjgcWTnUWy+PQp1wOLfCCUU+PbbqHKFrowkNj5i7NAFt+zye0BjoF83pAWlQvhlViV7VoB5aMEz7M4TwQBnyj47Cd14HAxx7sHblkrKc9+Qp4V9Wza8uxZbMK0BhOxYHwtyyozL679FmSZgbyczKHQcVI/lfqR1M+jfphv+pOM/hijP4P+A+RiC9kW3+ChnAz3fYH7XuvuQtTdQ/wGjfmjGA+s2/Q29+hN0n6CQnSBE/0Ec3IVVAg7f+7dOp+P/X/xzve6lQSuZ/lXECH2tMjHG25BLfpH9EUfNiJSsvDCzEMyIosxWU9EZNeOyHJMNq2I7JsRGcTk9b/YWl6gI++6lhfitbzw+FqOKSJUDZODbwoH3+xtN8P6cRmvZEM+mU2rg5kL+cSUwODkytEx4w0yvs8nUbHZ0cTdHAN5AcoJn7nYgO7ippWp18UESYbt590Vqig28JgumeqiOSP28yqW0LCf11Y07OeVbKFhP6+paNjPG0TS07Iv5HbwzbjF1kzSd5xJvkpUp8KB7TBrs2k7BWHjOgt4tmFqKcUml47i2TWdRWaBmg7heddx8Nh0jrGSn+tiVuPb9wzZXvoOWXJkxE08ZVVV+Pm5LsxhXBnGOteGT4GrA1uD68O3wBVCqhg1QpoYVQrbzK3GfPg5sdZt06Q6p2pmYdLXxL4EM9Wfn7CSlI2ks0W6EwbvM8t2MxPzFZhs8X+5EmeynZFfS66iOdCRrOq2lwNdSaVYRRzoSSpATQX1JZUdsOm+NNt+Y/GN9mcSLEibhS6Pddu14SDsMjvnssWHgC0+BGxxQ2eLDwFbpkq4BYN4R4HPy5acA2SwwiMkpb3ShO8eyL+Mn4v5aAkq8EXGIKHug0JWSP/rzApZiHRjq+7CMJfEOmX0lb5t5NSQFWXZzovBRhJDazs1KzK3U7ciezsNKzK401TkEttHZHJNDXmbTVh2mAwNWHZVxC7Pe0xeZ+uITN5g44hM3uQOZvJ19dnY/EGWFfkmG0YUczomG0YUczomG0YUczomG0YUczoms9HEnE748dnyIbYUjQ+xrWgYsuwoGoYsu4qGIcueomHIsq/ojnzEYk7HZMOIYk7HZMOIYk7HZJaemNMx1UpgiyHLQNEwZFlTNAxZ1hUNQ5YNRcOQZVPRMGTZUjQMWbYVDUOWHUXDkGU3IX5eoSPK93gwZQMJKKQpgOWIibVw5S1eKj+1XY0vOZwCuy7OemuQvfHaUDImHvQGf9lKJtLrxBGZoYhuHJEfiujFEbNDEf04goYiBnHEkhahuFkpJUcRWD7hszmQf5kWsH64BYhKxWzBhb1HKM0F7pxijP//4/7/6+N+YZ9xv8Cs9jloqRdobu/+g/zPxa5OAwyReSgog0lggeme8epZvp33emDFzDFTdVw48mxByfeS72frUcoYwCUm4aQmfymX+1t/ZtrP3lt9y4QXyfxtd1bsjp61al9kCxtL1lffSboHQPTfSe5yQQfYws9X30mCkZG+7U4eZ6tTtS8m3YN00PvVX0+zVOETXuMdqGzklOTA0h3fq7eTvnsARoI4zgsWfdfMP0M5OnDKyJwzKh8Vcu6ccV+R8+eMBx99tH/XvCV108Phzki4PRJujYSbI+FGWs4HNfUM1LOinmX1LKlnUT17I+XUFT5IUc5J0AEvw87WuWucPE2yaOYxrMa/bdx2x/hXEy0GZ0vsKkwdVy7vRDKfXd6B3MDhUMiL+CGFfA4/pJBwO98R0oPNHiEvYWO+6eDKsgVNbzK8X5mHdYlCqBjPtbuXH1TzP2c65+gyXaJLVfLIgyXDbZwknqPnYMrwYjWgDdqAQUMIswdvP6jSzkPkeo5t5Il21Yw3SKrT5gWaYbZ6WtrPfmnoOTRoh2a81rxo1F/E+IYhxAtVFyXnv5dTNjJ3fHfa6x3DZc4MG1cRQZKT25IuutkRSyXD/lKRo2U7F2jaqxyH0O+MV7blDK2ZSuC3iRSJpr3WcVR2QUsxVBFf3g9JgE6D+SOvmpSXnAKXdtoL4DAufxqnuLyzLSdWTw6Fl3iNcrjRN5zL/LIJOkcXw1PHL1W5Qy7TDl2quuh3/BwXaDvg5uD/RnxRyi+Bf3ThViHIf68YAUh5yU9g7enPiiUR9MMRyC8PZtlcxMf471/9Et6QX4J/sapYx8+yYY+s+jmbrk/4JVtHfZUEAQW2dbCtwE4MZuFuJOsd5iVwGkwaQoX9Y/Lbb0i/l477tKGcS6ETp8G74YS942qQSMLgSZ8U2TkuKZrDKSpxijKXsRHVUg9rmWZOF/+0on7OqtvSo7+sfnRm1EpX+l5zXoy7aGZYNmCi5Ffm8f+TuY8nMKD7BflQc/GwuCjD4sJfYFhsPKALD/UBgd8bA+IiBgQC+H9BGxAX5EvaoAuvYUDkhs9wU+L2LHHKqHyUTSiZoGDcBXd6sJ5jXZtgHwkQUN+87WaP4wtLwE8M/45iZdi5xuaQnU2xMOxcYWvIzvNiXRgqRWKXli0LOxfZFrKzzSaQHY8tHzuX2OCxs8N2jvHGsGD6nFg1ds7hamLDhwA+31pkvaaEliTUkBBJqC6hWQnVJJSXUCAhdi8JcX7nY0iyqYy4ZL16TDYikj62YVc2hHUUQK75XMxg2LIrQJ7TkTKQyzpSArKjI0Ugl3RksEFZ8nSkD2SbLuLmCuQGXcC9Fsjn6QpuvUBu0jXciW1Q1mvDl6S4B/JaBXWbnoQ91v+bu3cBjuw6z8T6PvrdAHowwAyABjDn3BlSICnKY8km0JghgTucFx+SKFuPkSx7h+LY4Ta5G4qmXUwVs8RWrWMktba7vE7YpC3rosdO2hUnhfJmK+08zN514m0prnXH60qQbFyGKMeFcuJ16xEvauONM9/3n3vv6QZAjVLZqlSmatDnfOfcc88978f/f3+Qk2CsjtcawQQOHmjpeIoj/0S6SkUaU+bL8zAIL3Gb3zluPxMn3PrOkQckzEBkGE+Wy/f8aORcTK0jXN+zRrs3y2+axTW5xMvGGtFr+rrK6ry3iTJp6+uho3MQOpfUwtmXAy+cRR7zyTW3SUFNxEjbQN6RSDB9lkS6HkX6OtSE0ZdkQCuK/sPsyyaeui6fAjS+5r4uWwReYc9CJ1SSzsenBtcpfGd/sCqGrdWGnri3HGv+aUakIplmLuz/k0yj+kLwPSR+r0iJ+KoiaXWcYE2vqoopjtW2Xg0dPU39WbEXNY0COYMCmbW+FeIds+l3ZlVenRkJPJMGrkYRx2cXc/OsUZfY+ogphYp88qpIMhKOi2F1vBj8uAg6jl5lGQgXYZJql5Zi+zUjbuGJDnd4huIWWVMYbASro1M/H1VZS95ilfIWM+FpyFvMoNhm1QyECwom8ky467zcoCzqlPJ0Rc2wzck7pHLyjMI2d7zAxSoYZdQMBC5mdPYoK4JJLJ+WNS1Bt3f0qirobEKNsJq+djbhR5gmAZZ8mEkgOCMiF9M81jojMherKou6yaqKiFDII/E71apaG+NHyI4UuygCaI+lE8wkdbE/0dAXlSgefS/ElnMNfQFVnG3oB1Qu3PMa+kFIKroN/QEZZvQKRE2zUsYHZxo4GQyjLFhwc7g+09MqFw78Bk4Kw95sAyeF4aEHcoVceDADSY5c2PEaODkMWzMNnBxiw6MriH8aZAy5cMtt4CQR14s4SUQz11OIP93QUPeHjIhGeZ5q6IAVOqw2TNP01UOyyPQwLQcPV+8ggSmcMmLR+eFUSHuYa6iH5dnqF2CpEoIEPE6cguTDlECH/LsLaNdAW3n87QLqGmibUA9Qz0BNQn1AfQO1CA0ADQwUEdoDtGegDqF9QPsG2iV0AOjAQF1CQ0BDA/UIHQI6NFCf0BZkFbaqAg0IbQPaNtAeoSagpoH2CbUAtQx0QCgCFBloSKgDqGOgQ0K7gHYNtFVghgF1DbRNqAeoZ6AmoT6gvoFahAaABgaKCO0B2jNQh9A+oH0D7RI6AHRQRcPLNYJHcOO41Ag+kojR467vg7h1XGoE35eguPR7FDePS43g+xMUt38fwu3jUiN4LEZx97jYCMS2dT+ncuphrgM/hLcX1IfiWfBR+Kvq0dj/Qfjn1Adj/yPwK/VI7Oc3kBkvFpzJoZeZi++L9MWX5yv0xRfnir740nyOvvjCnGWTXJYX4HvIG3I5hVI8pVdZdKf0GqvrlF5nHZ3Sl5RWAZdoK+JSeBFdc3gJXVW8gK4CEqdLjNuqGS72LoqLqdDFVOhiKnQxFbqYCl0Zk8PBtL7Myp/Wj7PGp/UTrOZpvQGhV5M2XUybLqZNF9Omi2nTxbQratbkkC6mQhdToYup0MVU6GIqdMU5PDytN9ngZ3TIVj6jr7Bpz+gn1ZJaNjHp4tN0MUW6+Ba6+Ga6mJszKm+7GEoXn6CLqdDFlOkS7hq4+HXoPrOaigadWX2NtT2Lxc8jXndW38BdsHkLXXwLXXwLXXwLXXwLXbK0U9PmLXQxFbqYCl1MhS6mQhdToSsuw/4ZfZO1fUY/xdo+o59mbZ/Rz6iCWjBp08W06WLadDFtupg2XXHarbP6WZbCWf1RlsJZ/TGWwln9cQ5ns/o51uOs/gTr8Yz+AdbjGf2DzNuM/iTzNqM/xbzN6E8zbzP6M0z3tL7FdE/rzzLd0/pzLN3T+oeY7in9eaY7rX+Y6U7rH1E5dYltZJoakzm1rn6E6pQ5taZ+mBdLObWqPk9FzBW51lmRa50VudZZMdfiakP9kIg259QT6nMRBb1z6nH12Yh6qDl1WUGIet9RH5B0PiDpfEDS+UCczpPqMxEPe3Pqivp0xDPgnArVpyKeDOfUpvpkxPPiByWdByWdByWdB+N0bqgfjHhwmlPX1Q9EPE/NqWvqExGPWXPqqoKa6K6vHpB0HpB0HpB0HojTeUZ9XMQhc+pp9TGRlcypp9RHRZAyp26qZ0XK8oKkc0HSuSDpXDDpcMKXlRO0qUHhkpO1QfVH1UcwGIp81ffBKZJX3w+nyGQ9BqeoOnocOOl8WH1v2Bd5rg+ri/Ha4iEssx4yO3Ou0s3iz+zlQM+UWBicMJYm6KoKP9yEsTRBlxI+uAljuI2ui8L/NmEMt9G1KXxvE8ZkG1002UYXTbbRRZNtdNFkG1002UYXTbbRZUy20W1MttFtTLbRbUy2+ULnBd0HrCubf5rBYcT3CI/ZKdihxfant2YdUZTdN0ZUzHhIMZl1fS/j+LTmjFVeVpjR9Toee/t5sSyQnG7A2i2cbz8fetdJikaa4Bu4X8xabK4r8qPkZ05+qvJTAAnYXsbsUH0akY3dA8vdt9w9y9213EPLfWi5YTQ2dm9b7qblblnujuXetdxdy92z3H3LPbDf9T9bebDch1acoeU+sNz79rusZ7uWe9dydyx3ZLlblpv2VNdTMYygruptkN2wMBBo3DRIa9w0lLueclCPPESLvsa9G7srJGKtQpPKlZN3nNOBRMylaM/USB5WzVliy1VT2M/uO/LbcayIeG8c8RUJX5OfjKqnt5dBPTnNts1HgADaAaNuotmnnJqc+OlVHIKoanjx5QBEMeFFHGuscocd5JNjTKNstmYCeelp4TzcWTV3nhYuBzmr5s7TChikAWokYI+mUlfNnWdyiF7FiFY1d574FHKd1tX61Vd/+qN3/sS9sdFW6+025aKloHhGWpDKCkXICvcOwRNq3ZTX3+EzwbpaV0+8UONvaH4ff6F2N3gc0UO1wVSFmyCLEvBwkoZkn7AyCOloE7LaDjZHQvqZ+CFIaQfr7eDKSPjADlft4MmR0D07dKUdPD4Sus/QUNVH0AOiT4yhQ6KbY+gh0Stj6BYtgz85hm4TfXwMbTqSh9URtOVIHkbRyJE8jKJih/zKGLpr8jCKdk0eRtGeycP6aMmbPIyiA5OHUXTP5GEU3Td5GEUPTB5G0aHJA2oxGM3e4bGFseUeVxjb7nGF0XSPK4yWe1xhRG6SkZWxjHTc4zKye2xGusdmpHdsRvpHM4LjoMjlbbHMpjA0lKg9jo1PoXe9ps6jiVY/VcmSGn7f8TdVVVXDPzD3vhPm3rdIGUphJ/HN6oWuqnCR+Gb1QpcS5hHfrF7ouig8I75ZvdC1Kawivlm90PWccIj4ZvVC121hDPHN6oWuV4QfxDerl6JcNhgyED9ZvRTlUsMQf/jJ6qUo1xlC8sFDLhxIrzUo+JfluTM6iCsmpZ34ZD6nnMR4lHLA3uKNGI8GWG0gvpOCWdycZcPf9IQjS8Vl6shVDJZKsFi9iJccLjaqHxZbRjAurYqsjYHUhjynzlc/zZDz1c/oJ7AwQiqBH2aetQ8x6xUaZ3S+qD33TTiuj4QKj7wf/q0vUtHPt4LSLPIUzjEl4ofOq7iNUA7tw62JObYIg3ebxXN8SD2KdF35oSs6cTzSzJlV8uzLuFr3sGZM3ql8Hon6lPUDRZSbJKTrZSWXa0IYFKzLUjHYtGVV68dLi9bHpEXX1aYtLVoflxatp9Ki9TFpUXSWEk4w+dlc3Zdw4CmNJF7wl+Lq7Z1D7HMI3lqKxdZL4R6RbQvZJ9K0kAMirRTBvdfh4qrXR5pDhkZLjXg/Ugq7DwI6SAXvS2G0QsuqD6Sptoj0LaRJpGch20S6FrJFZNdCOkT2HrDeP/wQs/RB6/17F/mdH0qfGxDZspA+kcNHU6RHZGghXSIHFrJPpPkh6/28MIQptfT9zTq/7THr24h0LWSLyK6FHK6xOi1kSCSykBaf6j9mvX9/g1l63Hp//x9m+HFPWB8n0NCCugIdWNCuQPsW1BFoz4IGAm1tWLlo9Yn1/9uMlY+trxLc/ccZ6yu/QqxjY0PBIhs7EKxlY/uCNW1sW97R/ccZKzeDgeTwn9i56f6+fO/vWU/vCrZvYx3B9mwsEmxgYy3B+jbWE2z4e3ZusBlDFv+HNDey36yrkmwcS7JxLMnGsSQbx5JsHPmzdi/tzZdkh0Pgpvw8Jz+35Oe2/LwiP6/Lz5Yjv9vmt2l+W+bXJDgw3r757ZnfrvndNb+dODnXJG9+Dw0+NL8H5nc/Ts/E65rfXfPbMb+R+W25qqTq1s5pnct3yiSW1DpVFvi751gR7R1bxABM2/y5CFvRMnimq5F4DeKXMZf90vMwngftWhrTisTC7U2xsRVphm2K6a1IX6HFL7HMFekn46kKK6nCyw1e/8AaOm+ZA5q7CurKCXcneGv3RBsTr9DHbMLdE/cVuLfF/eSoQoLN9LGO3dALNX4rOQzMwowXwDGDYPWWkIfvPn+vD2Qec38J07qPybvilVOhDZHUcHDm8c7z9kz9BC6PKy8F+QsZmV8ghRY44cEyhaCq+gp3XfpJEVBZN0WQxzWzo7Ip/cwPwysEeOb79Zqqms/XV1XVfL2+oarm48knK0UZVCFqI0I9VahfiVBMFZJWIrNWRWmLGEwVoloiA5MP+1DKVlXMU9XnVT7c8hsG5d/qFyCoS/4tcO9V1RqK/yoE1W5g2r88UvzB1Xdkp9rLRvjZc4K1dnBDrUGsDWxvAg8IXwa8QSl6n3Cf8CrgTXK4Cdwj/DjgkPRyAncJb6i1MZUUJuhEQXg3WFM3qNGDXF+mclCV9/VYFMP1OKndqgqJoG08oa6qq20V3kWrthuKynNfkU3W6uqJqz/zZ/8g+he/s/vEr34ZL8rGglh57jWyagTqHIHUGvJJyrgDJ/aSM26YeA/hPUy8W26bygnGuw3vduJtuqKilOfW5biXdRGjixi9oznsH4UGR6G9E5LeR9L7rpHpHntoeBQ6PApteccnve21ebCdF7nC0YdaR6HoKNQ5IeldJL2LpLtHH+odhfpHocEJSe8h6T0kvX/0oYOj0PAodDgO+SC5VqlQRDu4KnC33FDGuZs6O6kzSp2t1NlEauqKSXubvieNb4u+deM7LDXUmogsOhy/HRl0suHeUsOMD46MDxiTKfqAzfy5BrTnCgkAvdsq7l1jYKAJzCXAYUBAGQAy1YGTHNvz3BotoWKOrd95Xjvl9EA63LOONmcZ2VfOembwOaxbrLADyz20j2H/WYbUI6JwGG8iBjgH9SH1u9xQ69XPIiIghodbskrxMTUK2/SKGz0fOJxLfH7CY270fJzNS+YQtAIWFxwqmRcEheQVl6qfFXWjgqq/k8zu6dhTgFQxRBWDSxzACtjUzqhLaiZuKgUYrR5D1BhSUZfkp8C988xjbgscOTOPub+A3wrOYh5zm3Q/5v5dwVrAtqENdUn02No8li3wZGpWXRIjJPLC7lGodxTqH4UGR6G9o9D+UejgKDQchyo8TcqvuBkcoDgqv+L6FFcWE6R1WjuO/bfatF2c+G9TYzT1v9jG0in1v9LGuUfqf72N04/Uv4Xy2nIsZBvIto00gTRtpAWkZSMRkMhG4ppIkV0guzbSdUSrNUV6QHo20gfStxESoA5shCSoezZCItR9G4lnthSJJ7cUiec3q3zMFGeVTzzLHV9h8axnFRaQlo1EQCIb6QDp2MgukF0biWdLq7CA9GykD6RvIwMgAxvZA7JnI/FkaRUWkAMbGQIZ2sghkEMb2cIcs+XZhWXmSqsxAWnaSAtIy0YiIJGNdIB0bCSeKq3yAdK1kR6Qno30gfS98crLx4WF4AEeiJF42kyRfSD7NnIA5MBGhkCGNnII5NBGtvw2tZNSZBvIto00gTRtpAWkZSMRkMhGOkA6NrILZNdGukC6NtID0rORPpC+jQyADGxkD8iejewD2beRAyAHNjIEMrSRQyCHNrKVRflk7fIBsm0jTSBNG2kBaWXvzS64xcAYq2HQExcdELnUN6HJ7DSCGjxPQRvbERFL/TRMiToiW6mvQ9c10wiKsusp8F4mJ/ueglzdyM6nwNsdo/NS4EXQlGx6CiL1LNueAi+YsrLxKeAeqio7nwJuq1zRAijgYs+RbVAhFWG9pC61g0s7wTVSxzm4erokfKSRGG1nwLYTrCNgsy3K6YI2HdxzXbq3cZUrOkFbDu7FLqlQ0KygkROEQDfaxqbENeHLCzaAPi7olKC7Du64LkEFQVjYrwkvHW4yLhkdCuUJ2nOCy0BvtI3gGtG+E9wAerVtOMyJDpzgKtA1Qc8Iyk2buqSuCzot6L4TXAf6tKA1QQ+c4GmgTwm6IOjQCZ4CelPQWUEPneAm0CuCVtRN66K2zbXM61iVqKc4i1b4MuHlQ2aEAPASt2q36LraFjbHS9zm3aQL27xNurDNW6ML27yLdG2Qk7vCyqhTkgyVJXSKqExhfLzEhW+BrifNOqJA5jTwn3mqorOGfO8Mdv9/kYmN9OZjQfH8iKB4nqvmRFA8lwiKF0RyvghB8apyEnHlgmXXLUPT3qo4ElgcFxQfkZZ35VrfScWa5Vo8xkdExc0S24iKO2Oi4okg+UQGpyEmBRfnmVUS37pha9kAaqb6YwnfzlZM7NI9L2bgWstCs1cgWYP7ms6pKpeeL8vJj6NXZa2j12QVpNdlfaQvycpJX+aKSj/OhZYcO72oN7gsk2MnKLxgESfHTjf1kzyL0ld5CKWv0Qq9vk4b9foG7dZrnlvN6ado4V4/Tav3+hnFYeFZVDKvwHJxMc5gN2lynFHP0t59QT3Tjvj8vb7B5O71BqaO9h8xaOVed+Tr0ankTOxaW07Krrbl/OxJMiPIydoVYrcwYvDzePoFaroN/r6CAUbivn5vpJDigZIVy0tdaktY08EBDcsUZycsZAwhEU3EJ0oCvmGcINeheNxHvOay5kXR7gW9zgujZX2JNJ8X9GWSbC7rx0n3eUE/QUaCJU2i0NYFvUmGzyUdMp0L+grJ8Zf0k0zngr5K6vwlfY3pXNDXSay/pG8wnfP6Jmn3l/RTTOe8fhq//SX9DNM5r5/Fb29Jf5TpnNcfI2nnkv440zmvn2O+l/QnmM55/QPM95L+QaZzXn+S+V7Sn2I65/WnwdmG+uSh6Cq/giyl3fM7GKrg4SGeWlWfUp8mFhmsqlbVD6pPEusYbE6tqk+oHyC2azClVtXH1XPEugZbUavqo+pjxHoGu6hW1TPqWWJ9g62pVfWUeprYwGDQXrihbhLbM9hNtaquqevE9g32nFpVT6qrxA4MdkutqlBdITY02G21qjbUJrFDg72oVtXj6gliW8uCvaJWMcgS2zbY69B2UOvEmsuGFWwGm2ghVasb5T/UNsw1bc3HYIHgNsDtBKwSbAJsJuAcwRbAVgIqgp0FlH3yohWCuwB3E/AiwS7AbgKuEewB7CXgJsFBDWVdi8GbBPcA7iXgcwT3Ae4n4C2CBwAPEvA2wUOYzTpcjMEXpUBgzWprKQZfkQIBuJ2Ar0uBAGwugfiG+hXea6BW5XgMxc/OGdxY11VBzci84KR0rByzc2bg4hIsr+qmngoS21YPOyvhM+ZgoDoWw+GKLk2heiSFw7k0BRwiHk2h9R1SiBYg0yAp4BzM5LKYpoD1ZnH8K5Jwo4hppkPp3aiCL6IKvhh3SQwDP47O/ONxp8IA8Rq63mtxt8AQ9BPoKD8RDwKotVdRa6/G3RiNEOl0fjzuiGhCSGfwWtyV8Hakc/gT8cCBikY626/GXR/tFuns/njcedHqkM7ea3H3w9t/Em//yXiwQdtAOs1X4+ECTR3pdH887vBoqEhn/7W4y+LtSGf7J9NJvXteJnWa+XTDPRqa3orJtzgs1r390+LuLtW97Vlx7y3Vvd0zhppmqe7tnRV3tFT3Dkz83lLda5r4+0t1r2viby3XvX0Tv7NU94Ymfn+p7rVM/IOlutcz8beX696Bib8Li40m/mCp7kUm/nCp7vVN/OZy3RuexddNmG+UT+NapVtpyIolXa/0y42EXy517qXOYeo8TJ1blcTZSp1R6uwkTt7wle/92rQIZcEPxvB9gzcro/j2mH+3kuxgNGew4ZTM0wdTMk/vTco8PZiUebo/KfN0b1Lm6cG0zNP9aZmne9MyT3enZZ7unJJ5Ojol83TrlMzTzVMyT29VZZ4+nNLP2ONTt9xocFjiCpBbvG1HDBmaQ0nHxOKAUORRTDoUcPOWj2NUJcae1yYrmxneUIkFBPLwWRagBdFXVGF7xyDCRrqmNhMkT2RdbbR3zMayICHEsTHYSV+ARTLHVEyK7R1eKO2odfVMe4f7FCtq3or6FKPeZNQbjHrdjlqwol5j1KuM+iSjXkmilhm1IJ8PY32FsZGOpu4lYi5WeJUVPI1oBFkJDGieHDNawJ9XgsuG2m2Vc1KwDlJzT9YmmHqCS/Tegua7CcISZb2t1tSle0BktrSIIykw3apJ9xVJt5Cke1PSnTPpvm6l+9xouu8IuS8iSRJM+KJJuCoJryQJvygJr5mE56yEXxnPcFXSnZMU1qQAJN2Lku7NJN2CpHvLpLtmpVs9kuE5SXhFnmDCt03Cm4Ep0DjhNWWKXBK+aSWsxjO8KenelBTWhAlQ0r0dmAKN072lTJFLui9a6W4eyfBNSfhFSYIJK5NwJjAFGif8ujJFLgkXrIRvj2f4OUm3ICmsSQFIuiowBRqnO6dMkUu6K1a6mSMZviUJK6mzNSmQy0kbZZNbtxoqS+hSUgOXrcIfTVhJwpuSxJoUyOWkkbLJrVstlSV0KamCy1bpj5TEiqR7W1JYkwK5nLRRNrl1q6GyhC4lNXDZKvzRDF+UhDOSxJqUwOWkkbJ81q2WyhK4lFTBZav0RzK8JulelAfWpA1dTtoov3fdaqgsr0vJKHLZGkCsdIO1d3B+k5Xik35hWpFpputxkcZtdV2K7HEzkKyr1WQMWb+3x1WXMQ4zyy9Kuq+YfmFakWml63GRxk11XUrscTOOpOm+OJruO8FlHENlpQDTlouxwXQEKaPHk9Z6SUrhCTOU4BwpHkVwCqVWMaegNFZx1JUVGfx1yVHGRKSo9LqQela5KkXpSoNs70SBuSmVtSg8hgJdLlUxtK3TZWjO5WrVkKCv0LMS0+zDg2Z0ia7NmGsfnrWYVB+emzGfPjzPxVT68NyKWfThIZf+i3pdZY36Oz7xMl2vJNl6UQw1paKZ2ORMxPvDVgkbvFIMyv4wAhgloOwPOwA7CSj7w12AuyVVf0f/EP0TcmjQmZBDg2hCDg1aE3Jo0JyQQ4PtCTk02JqQQ4PDihwaDCtyaHBQkUOD/YocGuxVcGjwiDeo6M9z0VTRP8xFU0X/CBdNFf3XeE9+Ru7JHao583D6NkSXluSiXH9GBIvlDPuWcqjLbPiNHCpBe3Ii7lJjzaH+/AQVmvFWRz8v9kr0Z8UCi/6cmEfRdeYGR2gQee4sy6E7bc8CGJyTw3oajQVwqOTAnnaTAUSBHNrXQZ8JoH++ESxKGgLArtMSgUNJdO9cI1gm0JIYW7oRnCPQFaATNAJFYE+AwflGoCUNAbrLjSAgsCXA/rlGcEHY+QTY1o3gAQI9k4+gETwoJHsC7J1vBB+QNIoEesuNYIXAtsQ4ONcIHibQEaCpG8FDBPomH0EjeITAgcnH+UbwQUkDrDDrkf6CWoXM8wss8bI5HCvLojsqy6K7VZZFd7Msi+7tsiy6t8qy6D4syaJ7WJJF90HJHI6VZNG9V5JF96Aki+5+SRbdvZIsursl/bShkSqG2deCnDQUrBRvYKeSB9ELL1IwHD5JHfhgrR2pDaq/B/V2JKquWD7QVkJB3YTCwlVcCVAvJlKXFcOgwvsUwq4xLGTY4xIGpd6nEXadYVcY9oSEJeyMWXM2jVwxm2EU77nQuOOD5GG+Uf031IT6IcGrLypXWY3XarZWg7WaqtVIreZpNUyrSVqN0WqGVgO0mp7V6KzmZjU0q4lZjctqVlaDSppS/O2yOTXfHm/l3k2K4Jb6XKQvqc+oz0b68niNF1jhnz9a4T+YVvjH0wp/ZqzCfxgV90lW3HOsuGfTCv8RhH2KYZ9g2EfTCv9rCPs0w36AYR87ocIhFDnNfOpZc7QwzDcC0iPjso6H/U8IjTLu63jYv0myZVzZCWcVSJj1k/i5jUtBHPZfw89zuDzEYf8N0v7ixhGH/U/RoiBuGXHY/xlaENS3aDlQf5Z0z/pzlLDRd7iX0j9KKrYchZgKalPNxsxuKMs65BSLslpBwy5yLQeZxqIpStoVKairEDWFIhA6AeUVJUw6Vh0ykwhDN1HXTBjK+RbCPsOwpxH2lAlDOf8owu4w7HMI+6wJy4xa5XYoTVswprgK6UnZMIZ3R+DDGO6OwFsXDNwbgbdjuD8CN2N4MAK3YnhvBI5ieH8E7sTwwQi8G8PDEbgbw4cjcC+Gt1wb7sfw9gg8iOHmCLwXw60ReD+GoxH4IIY7I/AwhndH4MMY7o7AWw/E5T0Cb8dwfwRuxvBgBG7F8N4IHMXw/gjcieEDC54SabCsekFuri/LlfIX5G76tnreHLZguJqQNRzo9ajpI21uJ1mXZqS17UhKVQN0BfBkqcwWtiOp5w3QF+AMmvWZEV19ntulqvqouKLo6qOyiqKsjwoqirY+MlQUdX1kpSj6+shEURT28fqiaOzjxUVR2UfBFkVnH4VZFKV9FGBRtPZRaEVR20fDLIrePhpjURT30QBLormPRlcS1X3kt2RU97nKNar7XNwa1X2uaY3qPpeyFPCakQNuc5mC0bT5F9Tkr4giIbTE3Eczpw2x94y/aTQNPKNpYDQFhub3wPzum989/P78W3/129/+z//oPwCdqytSjdQ6c0GfWiMxIVnoZ1/WeeQuudyuY4HJy+36va2OXhf2MHO5PaE8XG5P4XI7a11uT+AIOr2/nkjuo+PAqTRwPYr0OsyyQw/booLj1bbhql9PqOCc+Jp23b7YtpjkZ29MuLjONebqYuPtpAYaMQpOcqAiekhEwayi0APBILkfUSKoKARBxdTmGJEVIIegCDrMCXKRpsnxqk7BSA1UYsI5Lyac8wzhHOnmKEVQOEaKIHu8FIEjUgQTKOiptGhRHHZZOjYVHwMn3leKwCN5V3ZciMDAxkSdYAmpni/KHSfLEChvnG5uhnRzFUM355iiOI5ujo8q5wjdXEXo5gxLH1jWtGsiV4RubhpyB2pG51WFrVXeIS0kez90c46qgG6uoiHqOkY3ZxLLWq14OqabcyGeXIjp5pLXJjyGYuHPfFhs4W8isfDXcWQXvMP9oIuqzsfsccJQNzVGN1cQsr2sdkaKvSwsfDOj1H8e6eZmwcKVb+gzsIHIwgF1m2eo2ybiHSy2nrnqHeWRuk1WG5VYRcsTJhd5tvoFGeSHtMURU7cROiQUU7cR2sqTt9tQtxHaJhRTtxFqEoqp2wi1CMXUbYQiQjF1G6EOoZi6jdAuoZi6jVCXUEzdRqhHKKZuI9QnFFO3ERoQiqnbCO0RiqnbCO0TiqnbCB0QiqnbpLwIxdRtUl6EYuo2KS8eqsbUbVJehGLqNikvQjF1m5QXoZi6TcqLUEzdJuVFKKZuk/IiFFO3eaRuyyo504jJwDxSt+XNqYWboKBumzJHHtMJCuq2gjnuiMmgPHMWUoup20BrhJOOgpyLWSsVnoxNJVYB5BgzuTIyB8TZhEEjOSaNqds8aaeidBg4bLsOOxQEoMBC5GCZRBaiGeUkVt7gFBaiaTiFhWgBTmEhqsEpLEQ5UDeLTmNFzcbdBAY4g4mRlY0zxkLkJyxEfsJC5CcsRH7CQuQnLER+wkLkJyxEfsJC5CcsRH7CQuQnLER+wkLkJyxEfsJC5CcsRH7CQuRbLES+xULkWyxEvsVC5KcsRF7MQkRi1guZ7Ii82TqNupRTbbwT9Cionnes1n3ZVpI3SnypaphOCYETM9rCfBS612t6M6ZeDpww8+wElw9f1EVhVnkzzKDB/60vag8qMInGvXAQOEbznqM5mfoS7XqHevfuiXr3GNS1E+vde2YjB717RxXJ1SQlFFDGXgTVR/TtoYH/PFRfWOVSI1FwxSjeP/n/QPEe5Ne4fvwuNO6hSLr7PMhV1PpOVIaqLlVayGddZhFDrkwYLPBVdXVaGZMFj3id58GrnXnEiwZZzvMZLCqiQVZNYmlkrB2gR/6BXePVT8L4+leyDUaLrTpmwq2vEtpLzDpCbrH+drKYGL55R6XuF14VeYe8KlOmL1WuSlzPU8jvuIAvUurvxJC5E0PUiSErJ4ZcPDFk7cSQzRNDbp4Y8tyJIbdODLl9YsiLJ4a8cmLI6yeGbDknBm2fHNQ8Oah1clB0fBCUn3ko9zmdR18lJ1pJ5i6uLfMYN3w0KYwoaM8ntKsvSFDh5KDqyUFzJwepk4LCFV4u2B8GGuPRUtBrYqjYQtbFmrGFXBKTxxZCswxWxQkhv1XHUKgdaQ56gzdHFkCbzlYj06Trsdqj6FJbTVe0qq1Wrq/yCssCrvGqywKu8yLMAm7wys0CaEnaKmD9FO/XLOBp3r5ZwDNcbljAs6EjhsR5ZPIyCVPsglerkXD222Wv1qKY5t8C17EF9kdrQF3CcbA/WgnqciTmAKx6UI9HYhPAqgr1RGRMAljYRiRGA6wKUZuR2Ayw6kSFkVgVsKpFXYnEqIBVM+rJSCwMWJWjrkZivcCqH3Ut0te4cLGw65EYPbBqSd2IxOSBVVHqZqRvcklkYU9F+ikumCzs6Ug/zeWUhT0T6We42LKwZyNcE8pRgRyqPmvNAs/YA8TTtucp23PT9tywPddtzzXbc9X2PGl7rtie0PZs2p4N2/OE7Xnc9ly2PZdsz7rtWbM9q5aHoxmWy9UfktGvSwEmMRifR2gyr4tcU+d5VYe5TwUJgDq8Ttj5mrBIum9gbv/1QTYAq1XmEa/zXlavqjUxBoLY72XVmoxQmXJQh0kcVX+hJgG0EbP7XjZYVQip3wn8Glw78OwovzZuywlbqPey7qb7JukqM49m/s572Uk343hlGOd5L9vgi8PWe9lGmaSFZVUOW8is724qGFJCfg+/hpYBY0lzXKuEb6bfvMKV6qOZDFaUj7l/+TVkcxK73rq39fUsTL5+HYsTbHrrYhPI+LeNv2X8TeOPjL9l/B3jj4x/1/g7xt81/l3j7xl/1/j7xt8z/oHx941/z/gHxr9v/HvGf2D8+8Y/NP6DvNA/ZhKSkcXNu3Wv9162nNCJOmHmaX9TlcN3vsYpsxy+DYeXll/4SwDysRWnU2FGl1mewdnQfQnjKSpCnVLl0H2tEe4aEjTftLjTWGmqs6ie06wKqB3emMjw7e6k62TyZXUa3KSw8525MeFUcgTeeV6VHs1krk9ky8Y8u3JuylI89/QEm6PsPn59gG1A5mMTnp1HBw3HCZ2XgjK2CHmk8UXtki/ErF5PMbP6dOhoEGGe9TblRb4qK0edUqflk5LFLXsOYOcI/EItkCf8+39CO0i/ocvqLHYaZ+UUSblowZIByWDwXeUDZ1uoDceuDes59FtYlqy4ZZF0qatTKq4sDg6B6dIB5LHWdqq/AQl2/rLH6jX2bFlyfS0jHARMjS5VpvK/lHDZygatnunTbCiwkBaUV9zMYy6+9TR+MrKpCvvvxa3XbrSZsprEBSUP15PWa8YLL+O4HDCcdfhVhofrX8uqOZDHVJibQRY7SM+QJWQezfzUe1lNs25b72V1Wc0pZmZOzYWVxmOuz/wkNtoUsnlKzVU3EGPF5Ymdg7QdkzqaZoWZcMcywUGx9R4pepvvZe+sZ/6d947JmvuvN2sumvgpKbOffi87kYnH+TJHTBno67Ds/Kz/RjK7ZKXbnHbZNa77m+j96FnsVD7HAke60bx0n1eDs6qsJpWj5o9ptsEqAyaPBNypBfLM2aPPrJ/4jJ5UbI1snGrdOPRa3LHMFt6X09bT/hsma5Ll4LvM4cjbsmqtnJpzLes1lOE2J0tY1qainHIkndFuGJgpmD1rjZtr4TPKvkSGyX/lPMP99mTSHXBSFq8FDjeSyf/B3p3aC/oU2pxn2pw6tY7W8z49IKYL+a5aF/OVuXFcI5OUlYNZJG66ODQKYZtdjCaGGYzXYUZPWmdB5zPhfualYJ7HEZnAkcZ49hrGFR42vZdFO5tH/pWaF16xeeEVmxdesbMydzky6J/2Nk0Ln5Q1z+njCh9Fr1fVpMbhP+LM8zhD5gmp8sA/YehcfQG5y+hTGO3Mc+5rDeVz+Aqdp7WvyjqjfLY2RjjFCJOIMIkim+RMiNAVt4C+Q61zLJisa4431CrUuct2/ZfrXve9rPnWAM2jfMLHrWEyfAyV4m6iiJ6dMKQS3JC/l43Sd22m68jNOzVeZ0TnGnoS3JZhBiWqTnhTkGGJxGtSULKi9uXYTq2iQf/Ue9naDktsMp5fVKb6QfQ/NpnAzjQ6S4ZzL3OOMysz5eA8jm1Dny2rs+o0Ip1+1sfoX6/+A+in+hzY0TW5ewu9L8oiJcygLlCz2dCDBVA/fAMLAfnI02iPbAPxJ51VZ6Wad7gmRoDz6slh7vuEeSeEZUK/odEUfDQFc2t0iveLTpyPsA8N/NPqNCWtd2RJ5+Axswo6ZUjS5LPJVjqpstdGbsfw7QlXqT8WYKo2eWNQDrtbDmz8hc5HfVRlmZmAyXbUwGpZaufV+46ewfCLc9LTGIBPM8NZ6RGnTS/T5bjjIqPluNummcqkb8F4CAOgY29ZTcbfO3JemEGSf/m1bFAOMze5K9r6ehYUqk54UBIro6KfvC76yZdEaXkN7Rz3nBgNVqgZs67WRjrkmlpj1tAjxbTo29HdlCeujL2/ctTpRnA63KrJ7e1pWP9EJZ5+xDvMGsuF7bg+g4y5cXC4P2C73C6j1Jxwfw5L8XnqtZ/PhJuN4NQFrglhgB5D5UHuBtdfmcfcVo6/mV/MoZbKj7kHOVhNpaqNvoTdQCGxpXpQSAyo7hdSq6kFQzuXCQfiDNPLXJ7UBVeg9fJlfZWWRvU1/PQLoskNW4goek9WZCWVoYRWmXJZSTrPs34mrX3rFyYcVbbvkxkpPQR+9wuYMxw9ifmo8WimlZOTd1ZU2TDxOaqM5igcZNZhz3AjEtfmm5u/IpugsmGAy4oIf/yeYBOUhGvISt/bCdaSet/faLfhVet3atjA1u/iQLwMaR5ZGN+pcVXqxDnCOgPZcUW20GO+1eR6poW7LWPkliZxVbmRHDsMeeAWgTBOLNGu3d2xJgOrwO7UhC9RrX35bhKjkA7hhc0XaineS/HeHeHQT0o2gqx8FpyCAWvgRkxhUVZXoBJ/NfbX1dpd3GrwaMputJggxFxy5kJGJrGWk1zVXyCVJS5HwHNB87m0p7sJYo6IZnWNPV0aIb1E3fjoy+2rf/lr3/j9j37h9sZdq1GkLWIDpPeR7E7u1FCr+7D9Ur+bvHi4odas2DFHAQtdPpU1WMCfahThZw5/FJ0r+HMxiqK2kBpcFM6DFRk0XtePc8wk0zKsSwdGROqSsIlfjsDyGWd2Lq2XObte5tJ6mbtXL21j6ODtDRq9FVOtPGYBn0ReZdBaVtXaCzXJvByq1IT/DbNlmMdAUJZcpeplmbDaiCtmL5ecPc1tWs6TczWeqaRaVerk07F9ApU6kbm9nDoVbr4kclBO+B+XGhigKORGp5vB6mgfV1GhA1Pec5Ld+fJfrbln36i8SQPdnW/M0lavGePfbad9m0vtb8yafH5l427gWCOW1QLaIDIl9aKubrbx2P5wFpfow1kMh8PZRjCnECWK/AZizJEi2zHnKAivMbwXTcqgXmME2IV3THIBCI28O7UAxsv9O7XA3QnMjNt7tadSJ6JI/XrK3Qm8NI5nx/Eke3PKQSwnjeXYsZhFrWpYvof78iHIRlCryZcBVDUxc+2/UFNzLwVzofeT4fBLPjhev+Rj9dqPJhso/adIBYShrH/IpFAOgZsWauYRb+sbszBVvZMU8Gc3LecLtXu55agBJr0pY0ddCsgxZck0TbnD7XGH5PHsxFEufrHkA7u5Epen5sLWlFQCEcb0lG+TiwYOBY7mwuZUI1jAs+LHNe3durc9peaMrXL+7pvfPfM7ML99/FrKu8O8mgsP8xCLGuaq/4mjtSkeKaq5cDjZSIxmzYWHkw1Vi30Kl/FT2Co95G1PrXoHk4iRQ1qDDDW3+cphjtuuw1zjMbdA5zDHLRic/XyD+7Jwe6qhl8OMrt0rWfVSsHghgx1YhhYdl1UNPV+fB1TQC/jx9bkwo5e8TRWoJSx/lRgu+Kj/plLh3Gvh3E+E7mvh3gqWYdkww31GMK/O0yK6qkkTCZRa4lDXeccXE9OOmo+lN5aQor+pzimHkvsE8cDhQy83gvlwV0ht3XtrmI44PTUfRuL01XzYEifWhE1x5u4tD7fFmb+369sSZ0HNg30SzqKaD4fiLEG+Q82HB4F0yoU4C4BL9IsUIfxF+quU6Ya/QP8c5b/hz9OvKCsOf47+FWoJwp+lX+yqwO/Tv0alPPg9+jepEAq/S/9N2CYro/wbwZK5t6jBU6Otaax3lyGv7iSMtTwIWMTwuIg18M9OcrdlduwLsl5XC2ZxvBDu/VbRrIXb2lELYf+3ilgs6yX3zRD+3/2tIhKYyCyEpr543U+T3cN3C2HmRlnPq0Vs/qtqUS2Gi43H3BkBCglQUYthtaHVeXSCl4Ia2l6wgFN3SRItZ4kqHcphDcz7m2oBdHLzbC0GXWDj5AJRYYc9jx8/3U2qOPsikjAfDt8tGJvjqqbmw95PT8bCBJhTakqFu39YaFQ/WcaAfFNT12RTe/hZ0z5+LuosflZ0Dj9K5/Ezpwv4qeoifgpsSDVmc6QRlYw/bkRF448bUcH440aUN/64EeWMP25EWeOPG5Fv/HEj8ow/bkSu8ZtGVMOwcCGDSllxF9GIFtBIFnC80v3ZyY9NOGxL2qlkypmyWgwVYs+lo/ccxP4CZycZ0WHNxFpYUotnDlciMBymHEvC099EQC+PEQ83FhiScZOhffx2YEF3DjcfOoffVl4zoWZeF/C7nddF/G7ldQkVh8nWuRu4FMSdkxAAEMPOC7BNoFiHY07SAlCowzEnLwGQr8MxJ28HkKvDMSfZApCtwzEn+QXg1+GYkw8B4NXhmJMvBODUvV4e65EeBJdlVulCElicu4WG8sXZKTRUVpwRbFOLswXT12YyKjRUQZzbhYYqinOr0FAlmZ1cKkElI30hnQr8dCrIyJg/f4ErIhmJtSuTArX2NA4rMxgJgxp68ryqSVoYiEJ0pWqDG+/qy1gJJSlYz+7/bubYh52xh7vHPbz3F/f3cO+4hwfgi7mPh/vHPdz/6v093OoW0ocLcbZ7/n0VWHTcw4M/9e/rzZ3jHu7/Qva+Ht497uHeb93fw93jHu4e3MfDGKExL7mj89L8CfNSDSoIXDTIQF4bmZdcVUvmpQXOS7XReWnh6JxUQ14lk/NmTpqXOSkGKmpOLzDPepG51svnM2Ev/1KwxMPkGjKMOYp6rsl3tJULGh1OQosIreHHmoQWRyehmj0JLYHIUtXGJyKBF81kxJfqc2XMhy0sY5eoRJfF77ajc/jdcnQev6/rAn5e0UX8vKhL+LmtK/i5pR3FSfU5mUoxQ+0EHIOWlMOZayeYqNMuboXz2U5QqdM4bomz3A4GVFjI5TSndgKq2iwpTn4rOxhMV9SS4pR4cQdD6UW1pDhRru1gIF1TS4rT5+YOhtFNtaQ4qd7cwSB6U+bzGpd+yCtKQZ8PMzqADsXES8G5C1LOyyjnRfxY5bw8Ws6Ldjmfw85aLdrlrM5RFHgxbG5PxtKDKHuJuhwvBDysRoNwkHk5WGwEy3FK1I+OxWLcTR6/LUMd9ZaNFQS7bWNVwV60sTnBXrExJdjrNrYiWCIHRPCigNsj4JqAzRFwU8DWCHhTBZj6g1AEO8494h3kjBXF9Y22ngSybyNTQPZspApkYCOngPRtZBpIz0ZOA+nayAyQXRuZBdKxkTNAolxQtrCzYUYvsqIWUVGoprOq3KYecCQ1c8b4Zem1rGaNX5Zey2rG+GXptYw7evpl6bWspo1fll7LuG2mX5Zey6pq/LL0WlZTxi9Lr2U1afxceikuthbDEg5Z4qZpDlrKPGg5T9g00+YE1l010sdjnSMdo/o0tKJX3Htb6Mxd2C/DuIhtBc6lVa6tSd3b1jnuTXAOrIptXeBOBqLOqtKGKKOaaOsKV4pY7qP/LZvxF3vAgWwKcHOwKHuSxWQ5S265RVUZQ5tES2Noi2hxDI2IFsbQDtH8GLpLNDeGdolmx9AeUX8MBfk8FsGetSg3e6fS9QmMjbW4FjxZ8i6FvTxPkHCvxkqrYbqqWStkzGralejzZoWMZbGtXsT15xTPQfb8RvUlrrSiIs4fsBCdwvTdRkCbM6d1CIFzjUe8weFs4LUDfqV7tfQ/3n3l8dJbG+0gJ8dGkawBh0wQgkd7cpoQ+OZcyYj3WGcMh4zLk6V2kG+r0ZQ6DGUFJM/Phb2SpO+MoP2SxB1Fd5mCxx1H4I4EDUrm3GX8rVsmwMo1lswHkw1dQylsUkUR8zGWrTpY4PSwyAlhAUws6f7iV78cH5Vlqj2p7cCLkuAf45F/aiBJeZFyfxTgnFqQ6cFMwMm04FJNNJ30uYPx+IUuT+lO2AIFlR2c6hlkgMN/V5ljKT2B+cZ7J8gr/26QTcT0x2T0XeXtIELuhAg7QSFdVPkwVx43vv132zhqRd83o+XCRjsoUjkwm5gjMrGufuKxP/jIte3/aaMdlNoqb3mz90aTHVW4ax2UllQWCO492jtoiDlVxAdBIRDFyUNLc2x5fMHoCj4+zzPL+KAyk8m8ECzhxNO3C8xngflI30pLLdV0BX0ONbUQT+rzGFPiitNqfM85ryrQhZmTx46vajWP990Nyjx3QOO5ZTaXBfHeNpu+qnhfNJvCOfG+YjaNSryvm13mini3HLPJvCj+bcdsS9fE33TMvnVT/C36JzFpzGOo3Qk8zCTz9xZxZN6aRwHSD9Pyt+j36b8dQcMH/iz9L5I7Cf4c/a9E0PaBv0D/6xF0fuDP07+FI5Yth0iRyDaQbUFKRJpAmoJMEmkBaTlQ9N0B2V9be+qEuakgc1NeJqWiTFFmbpqUuanc5nU75vZ5U01mRgL/+5JCXcUzZ+C0eWBkBvs9RuAJiIXuE3XH0AOi/hg6JJodQw+J5sZQTJBLcn6zNDpBLsnYuDQ6QS7J2c/S6ASZnhAJmiwTsDCbVxNUEj+xCatYBQYHW5y2NIZb6RdzYb/QoNesdbXmwInTmfwJOgQ4RimcHLb9PmHN9wlrvU9Y9D5hnfcJ232fsO77hPVOCtPVZ67FUcwZVQHTNl4lZ1WdgpxVRQU5q2oV5KyqWZCzqu2CnFVtFeSs6jA5q8qEPbmDQj/nWU0m7BukSC4aIAODFEgzA2TPIHlS4vCCxiA5st0AOTBIlkQ2QIYG8clRA+TQIB75dIBsfdPcopAqB8i2QRyy4OCKovnN2UTJCt5vzDZwDdGnXmQm7Br/0Ph3jf/A+DvGv2/8kfHvGX/L+AfGjwwoc2GG7OFcK2MyL+dm8mlycCYfLidnUixydCaFpmIBaLgLRjga7qIRnIa7ZIS08S72lngBLrczuISZk6z1jLdqvtx4C+bDjdfc30RTsAD9R77z8BtingYDG2hOIKhC2q6KYcCfEOGRSeGjn5Kr4qpYsNGnxISOnhazPfq0oc+fEcGTWeGyPyPk92dFd1DPiZUdPS+WffSCqDrpmsinLAoP/pIQ5y+LHRx9TgzxYO6kvKEWg0M6kNvq88Khf0FI9x8QUzn6QTHPoz8g9oH0itgk0g8ZNv+HhYD/EWHs/6AiAwhv6mIO7wKmeVBqR/BVoXNM8lh652DsmSaN6FXQPabVIXpXoF5MW0D0XsQKh+Z6uFfDtegjbeWrD7YjlVUPtyOVUw+1I5VXK+1IFdQH2pEqqgfb3Okh9gXEfoCxzzN2wNiasRVjnxM+JcReQuxlxl5k7BpjLzD2PGPPCcMSYp9B7LOMPcvYM4x9mrGnGfuUcC4h9hRiVxl7krEnGLvC2GXGLvFytPzrFcfF/bZjNIpF20zScYxGseiSSb4do1FM14qUk2M0iumiRnEm3HxJOeHmS3aq1CsWA1qYiMR0FtYeYjQLqw4xl4X1hhjKwkpDTGRhjWGMY3F1YcxicV1hDGJxRWFMYXEtYYxgcfYz5q9o/coYvqLdK2PyioweRi6Rtq6MmStauTIGrmjfypi2omUrY9SKNq2MOStaszKGrGjHypiwogUrY7yKtquM2SparTI2qmiiylinonEqY5eKZqmMRSoapDK2qGiKylihohEqY3+K5qeM5SkanjI2p2hyyliborEpY2eKZqaMhSnymBjbUjQtZaxK0aiUsSdFc1LGkhQNSRkbUjQhZaxH0XiUsRtFs1HGYhQNRhlbUTQVZaxE0UiUsQ9F81DGMlQsuAQzULQCZQxA0f6TMf1Ey0/G6BNtPhlzT7T2ZAw90c6TMfEEC08idz7wsanCL+lfrk3E7cqnzSdj7onWnoyhJ7K6GBNPtPBkjDvRtpMx60SrTsagE+05GVNOtORkjDjBhhNZeSDAG2bWMwNfFIu2fVEWx69nJgNXeZw0quIqrErvfMjb9VfNux7yOv6qycNDXuSvmrw95PX9VdiLorvnr5o8POR1/VXmDToKA79sCtaH4SgpnFZWCqeVHS2cfZ+mpIwVKRqRMvajaD7KWI6i4ShjM4omo4y1KBqLMnaiYCZqpBBaWSmEfVMI++OFcHEVBPhwrcDIM10Kdp7pmoNI9rGFhY9sQcsIH9bPyYf1c6MfFmHtYzLXwWWdce9m696ucXezda9r3L1s3esZdz9Ldh9pqdm6NzDuvWzd2zPu/Wzd2zfug2zdOzDuYbbuDY37MFv3Do17CwphOVNwubq3bdzNXN1rGncLKzjjjnDjaNydXN3rGPduru7tGnc3V/e6xt3L1b1ebsoq/z58MGxJFtFsI2ZfZfn1c+XyfzHl5t8svwFZ+QLNGYEKv5Cw1/eg6Bd7oPXnxZ7dNFIndUYFm+2+VXCp4dcrBQX8dktBKT2tuMNMDkpG4CIT7pWMGIYlFlS4K4/2S23D41hQxbYhWSwooBGaw36azEGcjKMQMqS3LZQg8nAmeXYXMbbK5oEM5GMlGZfPHsbP9gt8QJeYgkZYv5g81RMnSrorzgqWf+KcwJJXnJOoCnFOUWWnqKtG+7CUJBaVTGJWKZRYChBuk+yYry+3DUmlfFYLcfaSbIHUjAoALJ/iCaVQjkthKA+ewmeLc9qUwkExLQVRNSoGVYpelSHphvwflBsUwpKvC6ZSMyQZGE5gmBRCMGmHHZowKatgwg7bqkiYFGlQscO2TZiUfFC2w5omTCpIloAmDMLDj3itCk4mKlxmsUZPtXUBHGt78d25Czllsz9Q/NQOPrWDT91llke+sEto5MN6hEa+p09o5DMGhEZyv0eoOFKAs/ygR0A9apedwEbmeqTkzkjI8EjItgk5PBLSNCFbxfGQlgnZPhISmZDmWIgbdin81/UaImDqQm6h+jdkDNAFkoIi52J+xG9U/6YIjJPdDLxiay8HHtinOpNQljQPeMKL3Kb+dswWaSKIVSEroJsGVEcCemnA3EhAPw1QIwGDNGBlJGBvEt9fMJaGnDFT83JYQy24ZjnwwjXyaXXONExVQpG5FBSMweNdwQ8KKka6ggxNTIP2BD0cRfuCbhVH0IGg26PonqBNGwU7EzRdm2WjYS0dBY2+RUisSVB+DzzHoK8qqxwkF0Xa0KVVxXgaWLEmCtUIfGtOmJOfqvxgeGmWzJyRCbcTJ8kMSzIyBjnlmzUDh8fAV17i75TIPxX7KW9ZlHEwTnU/dR4UG6QBNB0LhOSJ77DYoLy16cBxVrJWjnZLbIngsZPP5qQVJz4YyX2/JNOScrmiycjMZOV8WGqk+aatbfchb018sMPthpsvJcEw0+0+5N2UMt0v4CjhZ2ec7Juy9pNYcMVryf9v7fSo/4KjUU9MxLhYj8CfVW7DvMhj2QY+6LiyNlg9Dpw7DlQNpOymYC7MgtnwdzKmL/7/fvFn8p8j4ZnkP1f3Bsa9l6PsvOQ/R/UGyX+u7h0Y9zBXh9iw5D9HOTrJf54idJL/PKXnJP95Cs5J/kVmTvKfp7ic5D9PSTnJf55CcpL/POXjJP95iMaZ/OfrkJaW/OfrkKCW/OfrkKqW/OfrkLSW/OfrkL6W/OcpbCj5z/NYVfJf4IFqhsJyDv4mfb1JpGkhLSItC4mIRBbSIdKxkF0iuxbSJdK1EMr94a/dvfoFWVxx2eEYJSmzHiCyZyH7RPYt5IDIgYUMiQwt5JDI4eh7t4okMefcjjIpWmVCpGkhLSItC4mIRBbSIdKxkF0iuxbSJdK1kB6RnoX0ifQtZEBkYCF7RPYsZJ/IvoUcEDmwkCGRoYUcEjm0kK0Sh6dSimwT2baQJpGmhbSItCwkIhJZSIdIx0J2iexaSJdI10J6RHoW0ifSt5ABkYGF7BHZK43U+H6p7u2bXVKitFhP5yOzXaonc5JjNkH1ZF5yzIapnkxMjtk3mZIh0iyPvLdVlpVEGDE0suJ3iHQsZJfIroV0iXQtpEekZyF9In0L2SeyX24k0+gekb0UwZQ5KK96Ax4lwHAbeEdoCoPO0QOFg3Idptq4p0FZWe86JHJoIVsVllXFKisi2xbSJNK0kBaRVoyMnKZEFdktYrdFgxbl/xdPU6KKFMFgIikCcY4WQadS9zrc3jKju1bWaS8Nf9NKItKzkD6RvoUMiAwsZI/InoXsE9m3kAMiBxYyJDK0kEMihxayNcEqmbCqhMi2hTSJNC2kRaRlIRGRyEI6RDoWsktk10K6RLoW0iPSs5A+kX6M2Gc5gwme5XT4VZ3K6FnOYKJc/tuLbvGN3JuiNnmKAt2thQb4lh7N9PPBNLkFZBCgYMWn+O9/3Whbcka4UjyALO9wPh0fToxtynk+HTi+Q9SthXRE+Q5RtxfSoeY7RG0upGPQ+0VNPOxGV5//8KcuPvxrT1IFmRIsNOaMTVh+B7ImfvvYwhoto6yYfsZGLX3q+HKziisrhqKxkbOeGr7PUyi5rNiUzkDIHxK7yYOH7/PgdvzgRVn7jDx4bPFapZoVo9UZszhKH9w+8cFsvHmQZRSfKlM8KJkV4Bt7jPt+8JEEU6DK3coaU0lZVSVDNi4Ceb87EXazxnJSTsHmepYCxAgYxgG+mlJZlUsCOmQjnuL9OJ6IRYrepUjRRHjgyoNB1tLZBgNv4QWIIGXfEc+dmsrtmBj1zbuRZCir8pElQOa/4G8yX34kL9/zwIk/kaqO1zd/xbANga5D9GtjLpaDedFPEx1bnuHxgrMQZBOdT8g8+SO6NYO8nIN/lVxsrLObpqbQmuODxH9rU85cr/z9P/ndt//+n/zuN0D8ny/LA8+lDwzv64Fb6QOH9/XA7fSBLe9+HngxfWD7vh54JX2geV8PvJ4+0LIfIGHR2BPJaazRRP7PNtS0/4bKZpPddo/iG3MNs+Xm5CY+ZSY28a2YSU18F82EJr41M5nBl+7B0QLKyXuju0F2h/wpE+w2E6bbTIa9OdhDzdL2Bi6MyS1flcbdjgIKQkzCTrPySYDlfjnm/Hm3LSY9cjtvR22VhYxh0thyI40tM0JnHWb01AiXQ8Fk81fevQtt2uyOzoF2zdVVKhhOIa+TJLs/9I057QncpRl72xO4qzMGuSdwR2gsdk+ghsxB2wQtm8hp3ATNsMiR3QRtxsi53gQN3Mjh3wSF7XhCaGv1mn9vo/Oh8HbnhYM/0r6qglSGBq0nQUfeRmkZOdQJlVU+j8+nUA5ThmSDcyzZqyakGIzqOIvBnGumFQVj2zKw4bbFDIlvm2d+bSO6qybDqHpcwM7bMqqdsjWJC2oy3DaZnaQqLbiyyQSRtZTVJTlfZY/WozJ7XLGXdRaesw3Z5KZrHCL29naXiL297RLp2RteIn0L6RNJNrmGVq3PgW4v7mf+Jj4Ch41ukG1TTBWTsRXcbkc0VzLppeNntEAydzUZXnyZtdnLytSD9pA6d8Vptwbie2mUQersH42tcjLZJWM4izDcyzeUUwURyi7klMIDs0JjD1jPfCWvTgkRAZFMMLGe2f+SD85YGcDf+5JPpScXnoyhTTt4yw+yV//4cOf3t9/+zY0XkiG+ECXgj5mow7dSWeY72kWtuuuZr33Jlxc665k/hjvstXg+32r5Motf/aOP/8xbf3P6zykTnAmbBs+ZvvzaRjvAkn/b4PmER6ONxYhBCwZ9bkMmhbf8oJRCI/r05SgKjIRWt4UrYeVf/Zd/q/Ffvfb3Xtxoq9xVvnXmTzbaqhyZm5s4wvZGOyirXEIHAQFlWch9ZKOtCpa7dPXnP/9/Pfkv/+zPN8a6fd2LeOdfVNmE0PxX79a9ActmF2XjW19YUfmrP/0ffearH/5v/nzjanf5p/63T3R/OSVexROKdD2JYDUWDTvIS8weYUfumMh/felTH63+xF89cadmhT7iRerthG3lTi0oJgUY4YPkDQ8f/SCmjIyjaH7uH/0fK5//ud9H0VjlGiFH/+zf+1c/+i/++M83VHEH6R2VeEzTEz5TkW3H4kU+5t/daEuXfQSFSIrUCe4rWJGyKpMyFD17yRYV7YXg1U8vgLF+Yk1Ie8xaIdn0kwLz/jTQyO3tHhuYH2lWo4GJS6bCssrIINrceesfwmgSW4WfitCvZ4bM3tbbfmMkJt7wDeS5YEfmavu4qN9E1Px41OZxUb+FqLnxqK3jon5bCs2OWv7Fkpt7o4wt4MWXgrIhyMgHHsbzqqHHcNFpOyO+3dQXRSi9kdCeFYrheyRwYD8affmddmx7YOPqj/Hfn2ywLQUFELfJZOi+oQqmbaWaB9XfAKGqRQgSvnXWKO0tJPG+r4cUyjqPBG7oKZicp0B5MfTUlP+GcrMK59VF4dE6i7yBU6RdjsGgFG7lZXOhSiRuOcUJ01Neu3qFKW1lYQwQZ3JBRZWgeJf0O/nqilkMyKCdCSoYfkuQFtMuTMqXsOIvUU8JJoEsjQu8hXuBSLQtC9gRBZPKteLwFZOJ2RP0LqYi5fr1DUjQ52FqgV83UoAQp69IyeJDfPCQIzV+rXynm6oVXdxsR9UroBosUIHehwzNMHeNbL24/w4jzmePMsfaA/sU9OS0X06S5/LZiwKqvzB16MBUr0hnL5KpazLszaIm/U2FhUpfWHekdfzzd/EQ3x9k27w9KPAcl+Aw35ZSOoiRwxgZCmK2wgY8NOC2DeI0F2DTBrcN2LLBpgEjG2wZsGODOEeE+phsAQs8KTXOIYPcNmo6ayrtt03VRxIlMknu2kl2DNi1wUHZgCL5ETcaHPYa576JIRvyJAaOWY3zwMTYNTFcgXFc6poTxowqNsJm3N1SMr8sW17gj7Q9qfo8mv5bZ/H3K/lX/TdUCcvlR7xMVmXL7ygf/bTtvhE3x+/QDJGJ774RHt/4ytUr5dgWqSzMyuFF3Jf+3CnXfzP7hgyOWYo6Zf9NnTOi0MWY89cIyz0fuJPZTMbxXL9sBJ9LRpa5LCKmuqKyV5xVGtZ21zNz1lpbFXdU0ZTaP7Wma+XWgomdeFJ/N1LlHVVJDqLMouDcxr1o7aC8kz5WwoOlHTHvnQGX9XrmIXG+8/x65mHYsMngD3+z4Vyj+tet+R074OyVrS1fMltiOiHzfMyDZeVd4wMZiV6U6P4J0XlCmUSekMiZE9OOY175y3/6O2/94VdanY1VPuGdlLyUeREfkBvJkHfiO3ITXvIe+cysiqeWGVGpPuY5kCvLy0pSsNpNKjgcq+B0ISh1+QrqLCjvqKJdu1JjrC+dl1byMA6MUHnHZIBtzxOa23eevwYK8qRcy/LNzgnfjA6Um8ikX+3c71eXlTfh3n9l/+uvvopbdt8Mxyyh4EhmISTfdGKraQF83l+kaUWPRPPOS6H3lM1SWkxp2t/4oi6MBcAoMQUTYntOnthzoj4O9NqAucdgzjHYCFDEKppWpHzYecqBjTWnCkKrmicbayZ5puPED4ndKTwBaZzAi/lbi1d//r978+a7//ajGy+UsTcEyz3MR8Vt07fb5sGGWar/prXvcGpBcSfeM70bfXfjSFLl/2en+1//wv/yy//oO1U5hpqtAp+5yp3cf/p7G4kap3Jr79+UZTxB8AfTd/4G33ls83VwN5UVoSI2roKMP5mx6OwkaQeO85PsJI3jFzakYAIX7QkUVO5TgVeD+dPrQU76eLIruxsUrTHfOmpJtl0phaFXaweVHV1UnNyKyevsycEa8jnFJJHaAUSPnOu1HV0cmRZoxaxUTmeiohl1TP1w0PmOVSxNyhsfbpQXZm58p5EAWojvO2TI+IcumqM5z79yaFFkvFl99Ts1K5MOrilZGW6cWuhcnzhaYMVRM6LZK1vufY0/yXtU+gL3/l7g3+f8lJUFyS8od+6NypvuG7LkGLZ8sYjSb/lvp6bKaIkCDXrY8q/+6d+N6p994qHfkVUblNScRrURzI+GqnnumiSpwE3x1HmnVsbunVe+2MrG503hQPbrb6fkjG/eSWWRxXIaX739S6559TdaPt5IGdUBXqgMU6U2OhAZximb133Tft3e/b5u63fi133Tet3eCa/7Zvq6b9mv27/f1x3+efy6b1mv2z/hdd9KX/dt+3UH9/u64dueed23rdcdnPC6b7f8MhgQHENvf7QWzaFccuIhHEt42tRcAN3i6pNqXjS8jTp3Bsx+YwFNCXCPBLQkwDsSEEmAfySgIwHZIwG7EpA7EtClVLkCEROPV/U5XtbUKGG/97bf0Aql94t+Q2vwOzoNHaTTPPN8U0+Q+k5PkhFPT5EoT1fJn6dPkVZPT5NtT58mCZ+eITefnmV29BkSyizj8H6pAa6kQ19NkJqi50PZvcY7iyk6Bp6q0tHy1Ck69l01TUfHVafpGDpqho6uo2bp2HLUmePuJgJQkSihoFxSWmTd7wZn0zlnSZGhUpXv7gSpPSw1N0LqXIqo0eBApbx8N9IwbH0Wq41lLDOWZZfkvqHcxFQkNgyLZEwxC91/vnFvgaLcL6dEuIWUxo/E0E5KDO1YxNBX//dPIIX/fkM2vyUWaVu5d69uyT3RRhvNevxlx9/bwz4mYxasbDmqcjedu8/hLp96k+wtmGMiJeeuFM49dhDaPq638GA3WDBDj1xod76d4Y22NML0tcL8m78rBCPOTrIEaws/pfTcXdW48vfE6Pp/uIG8QD/f4X3Ao+jTwbwcpTZVgwuYst2SZYIIajJF8NyUw7vyU9bFT/ZU6rxTI7lyzrKF6vKe6hstP1jgnjw5nU3HfSTnpMk548ll41S+ydnKTU9708H8O6WRj9P4VpJGN0lj//7SKDCNefN4L3n8IH3cSx/3xh/3+Lg7QsEP873u3TpuLlRNzrRVI55jH14wRaep9L7Fw1dGz6gFRt79aqYRT4sPM9I2z31NpKTIpBXFM5rEbPIwOY35LRMz+mWnEU9GEhN3NpB1jmN+28Rs9RmT88jDCzSOIquKb7RojTJdX6R1zmYEU01lsmRL/G+a+Gq+EQ6lk8jnxU+peblqE7887oJkOw07lLC6d/AlXFMvSMpf+5KkPDojbyVVZ3phdKQbSsGaUkORVB+W0pBeZy7JeKV071fggy/5ojQzfMuPCbTr8Libauw2zUnvzEZOvxx+z9rLDV2zjsRo3bGmFjAdzIOUI3rbN2TTIJkKu79ovHcjkpugIIP5sHVWFgLgQpTzxbehyq5yd2pXa9/zhxdyf/vf3wADstNWeBIEu+ABSW7Z2fwytF+RPU4+IYRSPy9Sv5pHySys4zYxvcxLC5W1efCW3wgWRF2BPwWR/jt8y2+Y2zsKarT8O8HCtWDeUKuk9jAotCK3C7IQMxWwxwqQxRKgE3jTQSexj6ic1GvKufp5Xlv9EQohqR6VOl+oqewLkvXfplrR/p95jWAR/XKR9QRiaHRY9lTSb79FJVjWYDDPatLqnrcri4WanhfLF6C7RtF13EZQg3YsBHJqoKPs+vzN/Jd+Wa50dYCah+Yp1icF/OkXpNLmzYV27NtLfVEEMvqR0AMrFGTEI4GH9qMjVgt0usVMaiKZCVUNdxHnakFBFWBLI4sxwBjNCNQ8j+KxrLGqRIxmLFvcSDCaIXPYiNEMZ9xoxjIoPhuPZrrs0or9PlgwRNwLqoamu+vE1M3HGs3ICd3N5ksmEj7Ykr8CIdQC7lRAdOTZNjNAtpW/U1POjsrdxRoJ5EppHwcPdpyfYEktKNUIzsto5DDXank90/XVArgbL6glmu1Ylh5MhvIFs9LKfferncAxN5Dn/E11wVqmGZG43N2dkyRrLJ4v1HxqS6Ot8iJ5siz8eOAhEiZsjBDzMkIkr9J5dcKRhC6oc1hf1ISls5mNK+PnNn8F3bGZtWj3TzR4AAOgWKpxFYY/MHOxCBHIRZq5WISE4qKYuRCC7IEvtNl9n+IaIBrPascMoQ3w4MVU3nlVUOf8N5STVYsSmrad6ma73E4yNZdWx5xdHXNpdRxn/YIsMou4GAHJFhij1hpiIEDanxmQpWGmw69aTIxNZDAefD3HX3c/xzno0czXvwQ6chHgCBZe5aHJ17/kY+cGg4apBfrEzsW8de2/UNuxDP2Uf3varb4xjTvcff+lYFYucVs1nFDadmt/NSgql1xrU2o27LsYRWfDXR9bpdnw0GnoJTUb7nsNvaxmccSpz6lZGLLRSgbol7CweSk8fOhvBJqzHOj+Z0FKpUB/N1V9EulAU0vNCV69qmYh7cfbG7kwkQvQGVkxzGGMCbuzDbvLvyCLj7fOxnFwCTuNQ2H7Vsl9Q81YN0XT5O1GLPfYuyIwF/Kadmb80kg+YCa5NfKR5ZaT3hfNGF1xw0wn10b+nVrcheY32xZTHadaV82GWx5flgn8KPBgFiybZIIaztNpd/Hv1bkqKv9ulF7OQowUpJcjmLcTZEfs1d413y5Xv7PUkk2qAt8lVVFgTajZh7zIWQVfxwzcLQeTOeGmswp6D6XOxaxfy6QKpXMRnETUClg0VEZz4qJWwKIhMCqIK2PSFPqQPRjO4P87NZV9+50jxna1r4qKxeTe1UXU1CykPQNXisS9GxStAkCdsEFpTwWmZcxwfhaOpxlO2rzHDDP6zHmoEL4UzFzIqJlkeJQ2Gpx9xKveDVwYQ+s6vAW9pWYU/T2H8iS3Y38fmyLoKRr/QMbsV2L/nkMRk9fTNjUDCuhpdZb0cOdF3IFMa8E8hBY17h/nIbKos+JaA6EdXRdBZkfXCmgD6FJtbsfnIagIPX+4quBepavQ1hPiyrT1JJZ1HmRwzicDYuCCEFDo707j/REObpULK2CbbQy6OfGsQUAO+w94LrYjSE2IZ6Ud6QJOj+FRbRwPlMUz1450WVXEU21HuqImxFNoR3pCTYon045wnCJjpCg6T6OebqppRTrnaUWS52lFgsNpRd7Dabl5nMbp8pyaVqSUnlYkmp5Wk5R0RespBCVURAZ/CnfBGproVjvKRYxqUG6LDByeNeBcUCEoTL4GVMEEQaHzNeBKMElQOH0NeDEoEBRiXwOugRPVidl9DbgZ5AgKxa8Bb0JM0Yl5fg34XOARFLJfL221+DJprlXl3v1y2ova+F6p0LZUZVsqsS3Vh1Y0iZ9JVAzaSgU/FVQgWlMJPyXm4Iy0kWm21NOqpM6qM9KGXkSZno7LdJoUiaeZgo3uE62MoQdEJ8bQIdHJMfSQaGEMFeuD+TF0m2huDG0SzY6hoEicFr7LZLQ8g8Z4xjTGZGiOYDdWnQ3nGvq0msGH6oVQjvTmkwJSC3HBoHOxeafpTsfNH5C0t+m4ewCS1jYddx9A0tam4+4FSFradNz9AEk7m467JyBpZdNx9wUkbWw67t6ApIUZ6CYhaV+mCMQWzIxQwM+A3y2Pnxd1Dj+3dRY/t3DBkUyj07ALEZxRZ0yv23cCiLfsmArLJ2EuaF5NhdloLkabNpqP0ZaNFmIUuo+sE1gCdxrVp9QMGscFcG4UI12F3ehIn1Jz+K65RFBZJ2cMqjpiwRnrHR+Pnyr/vmdY0OT7HH4fJD6814JcbKVPeWIsEXwfYhByZTwItAZjyNoRZPOlcaSfORJpcBTaOwrtH4UOjkLobVwWxhA1SMGyGq68PBYEAo7x56tHkLkjiBp/hcodSXkF19q58a8cgw6PQmD7HkvcpcR2umyE2Gl7xyhniOj9L2Zd902oszE6Fgu+qH5TPjjRkS7QF2suV+mLNYnn6Is1exV9sabtCn2x/utF+mKtVEOL4EPcKlFr9RM1zZv0xTqMz5Gxz2srH/LoMWPJgat8o98TUf50yzHSRs6jmcykl3EdN5FIFbH+W3KQcTs9ffJEI35EsMcUhjlVQrfmU6+PpgUyBq/uvTgFU34iC6q9I1HG3q68d4TQwVPe26kk8d0A+G1l19bbtB8BSr9EVnOznWzRIuVDQSEui608/mJtj3JqqxwJhqeOfj4/DgcXWRy/UPacb36fT0jynDU7EebLTWVN5UQjJZp+3t9UeSvMSX3vPs/L17iIsWlJTpUHGxTxk6yXyz9Tdf03PwzhskFGpMsyVDkx5JBUEFLimjNklNQLuiiulaSNebFKEDVfpG15sSrQcwLfFOoNj3Qct6UJDXNyOpZJbcDJTslNZkL0l54Lbm7Sjk7iN3L0FElQdBU/z+lT+Om7ehq/h+AX9Sn8NoNf3In5mDzO4Gfg6rOsThCM+pTzmcdvVS/g57au4WfP1Yv43Xb1En67OD3ycdt2Dj8vaoWffVdr/DZdHeC35+jz+FX6An5e0Q9IJ9IP4rcFglGf/Kcr+F3RD+Hndf0wv83Vj/DbXP1B5tPRj+L3ov4Qs+vo7+HHufoiP87V38uMOvrD+F3TH2F+Hf19jO7p75fmqh9jTmkSGheKa8ywo+uUlMBonqMiBOCbbQx5haDI7OKYL4dla4lfYbxzQZkF4opXBRW+l3KiN1VWFdQabt3qbdCsr7YjVVaPtSNVUd/f5hIAMT6CGN/HGB9mjO9ljIttrhsQ40OI8T2M8ShjfJAxHmlzsYEYDyHGw4yxwhgfYIwHhTYVMS4gxgOMcZ4xAsbQbSNKVFDnEEMxxjJjLDHGotCjIsYCYtQYY54x5hjjrFCiIsYsYpxhjBnGOM0Y00KDihjVttCiqpKaYoxJxpgwOqsqZiiai8CfPCcIqZJUFJSkB2aNlu9KBGL3FUGowXsxgpWbi4JQO3ctghmcNUFWaHsgAgf7/83euwbZkWTnYbeyqu773q5+X6DxyCo0MBeDAdCYmcU05oWu4cwslktyIZsRRtgiheXACvhiFMYsdynQRggtk7ZbEi03LSuiZyx76hb4aFGk3OSKweaKj1bo4XaYIlvUD7fpJdW7VtAtWku2wxbZtGWu5/tOZj0uHktRXotmGDHTN/NUVlZWVdbJzJPnfN+SSBYguZZguXhNJIuQXE+iMflW/XMut+tuJFEg36x/DkUByh6NX3Fv8i3WoFyA+aVrMhHxGBfHvnKDt4mvCZEo+F5SzQ/4LozDmt/wvVTXpWOniR6TvpvqQHpnqsdtFzShHTVMp2oWn4ooXL4xDuT6IvLgfCyodXYcDOvaM1AVUBoWsC/AkNoy6HEefKMFPc4zLsfQGWaUhd6wWH2zGBOkQC8bWaFuDM4DdIkBvYA+sbh+cxjcpcAxSCU5hbKSPI7xXsqeyAZ06Jp4TQoYNXwD36ZBzEghuImv02L+JZDcjjhatnLJXXyjBmRCJPeiDq5iJFFogGQbH30Gugl4YN3id9HmF9FBz46mDPJsAx9Fkx9Fi5jBbX4aHXT8aNJA1eKTwOKt8M1Ms9BEmkQTBtu2Af+DJhGCW/xA2rrOQt2UHZZguC49DRrwWWgSYhhfmG7DG6GDbxkeB12ZMnXRR29zKwGpu0yRFvdeJlx2suSKJNEjK+TztgfWnPzMJBev58mN7NTEoh3jI6bePKyar2C5Zj+DlZr5DlZr5kNYq+FkUlDtyaOAAqDJgBcgfLVpAtGoA4oXaBVgkizM2rZ+yUBR49Pm0l9Ovc4VP8U3uM5n8qYEW6PxQ8F+2wHrcGuolPegdR+mm7j5Lo2FLqesCqGFsAkBRxUWIQDMAvMSwLewCyF2GVYhDtVt/B4AEVxxqO7i93o4JqDZAWJrQ4/ayIub72p3QE0CrmbtmGuBxIEXw/Pm1UDiwMvRdxXXA5EEL6jbqVwRDi68JDoLron+VUX/ynxTqmYWrH25arVAGt1kcA+dWKFnlG95rRkhhuj2Vus/91TngcKMKaneiRqYMQWfjJrwjYwhAyOu3JuKW+/Kwk3uekwRkQQHnPfCOvx/dYCHEjvYu1Px7331q1+tiWcw9msRjo/XoNXALvPH9BhWF2jjZx5zJBzTbqwGsMPEJHU3nrh1XPVJ1YVj2EMdyxalB69KJLmHlVNLj30o2Ij1T7LlzXfxdm1T63IvHa3YYgsiqNsDCZimyjW3jfuNEVwn91u4wahqXgY9ILAst7nizT6tVH7jNdx4zTotd4o3HrkjFbjFCmBn7w7AewU+KvkoGlKLwk2pzEbjZSwCDVBfzVd0s/Ujrpq+7z8QUPmuANKPCZh9IED448KZPiFA8pOCQj8lCPZF9PtKOEvuwKNoMficomNmn76bkgF6DAY2+GvhMwIIKLYcJ2Bgc/Uk2EdcPQVTraunYVkDZDsJsmbTsAOHCZdMQNxStP3AJWswx/CemGZh9ydLhDXNMmNNs8xY0ywzYpptSAam2QYYtJDpGTstM4Gx0zJTN3ZaZiq005q9QYtBeQyU2yTW64l9tif22Z7YZ3tin+2J52pPk9yvBzNtoHsw04IKolPYFqOJqfV/+VRy8ER070TVeeDtLWCTwgs+Dj1uthkqGfhQJQMfqhRwrw2EEWL5cHoN76tOZYmlDl4AOkGL6yG8AHSCDhdNYZerKHRadIKA66xwnAuvcIIDSTgZV6yK1HXRVJPse3xLAig6IegAiR43kAGBgREYE2gBmWkZxAFBIcAIK9AELQNX0BQIAxnH+pkm5BswUy7fTLkAjOrH24gOD+u6Kmio/YFWwXlt7CJYPAxFw1YwhcXqYSjjYwUTWCwfhjJWc7jD+mEoU16OeVXwMF5xNRQFAszdJV2L/Xfhfi4P2d7+NXmyS/JkF+XJLsiT7cuT1fJke/JkA3my9XBSHvCUecDASGlQXeHutBf77+oa8w4VhSuwjElho3tKGlN6F5P2XUyYdzFu3kWQv4sx8y669l10zLtom3fRyt8FqSqxhLfgvvJitDKfRg2GJ7yRcrhwpfKDoq6dAeIti++vGm+5GOP/vOc490sEFpXcWkWjCScefH8ZkUM2/wgyJohsHtLLqCQ4H5FliyxayItRuEY/Y7TIriHG49I1xHhcuoYYj0vXEONxRdg2CtcQXqnSNYRaqnQNYZcqXUMIpkrXEI6pilB4FK4hXFOla1i6qdJVLONU6TqWdKp0Jcs7VRF+kMK1EhxJnPLV1iFcH7naBoQbI1fbhHBz5GpbEG45rS85jvvADNxgCGX0udIe13Jk/3Ztx3BpSDEi6RgUBUYkHYOinhFJx6BIG5F0DIr6RiR9gqIFI5I+QdGiEUmfoGjJiKRPUHTNiKRPFJGMW3/ZU+pB8z57TI4cAAvcOXepIKDj2GJB4LN3FgRV9uCCgC58uiDgkr1XEHBSHxQEBCgucDaFxCSoFARto/Yy875Tarh2EzGnFtqO7QaSzxSar3368ZXuQFcTiRst3ISuYRR3Sveh6xjMndKtmDiv0t2Ih7ZTuiHdSiTQtHBPup1w0liYRbVzO6bO/YU//V4h+vPT7+lGMVMvZmrFTLWY8YsZr5gp2E7fa/39SeU86HMaP34n8uZpCe/CRxWbJ8E3y3LZCoNvwZzpsjqEcwyPgHg5S36fSYOvfEXSh97gsvpeSdcHl9Uykoozz3PuNpCot1sioQ1kB5IdI6EJZBeSXSOhndLi1lNC6+M+JPtGQoviASQHRkIz4SEkh0ZC098ygOSX2yJZ4uoUkhUjucZlKiSrRnKd61UDP0/JDdopIUmM5CZNkpCsG8ltWh8h2TCSuzQbQrJpJPdoM4Vky0iWHT4giLaNaIWiHYh2jGiVol2Ido1ojaI9iPaMKKFoH6J9I1qn6ACiAyPaoOgQokNYSZbrg+BTeG/n3O0ukNfOuSvdiKb/7Y5YSVc6YiDdbospdKUtFtLtVpR37EIfvzWHbSrdfEd+W+a3YX7r5rdmfqvvzOVrMaymbG/xddO+KF+37CPydQNScldqaOZtScL/bqXLJMz92125Oem0wfVIna9sud596azo+MGLeB6bZh2/Ydb1666s8xNX1v1rrtgBVl1RJgshDRvrviz3t5Us91eUrPd3nDCQ9xOOs6OAoAFztElZEE2xLhVO82QnnJH3G86yn4U9dnZhANPhUeR2QQDGfhEeE8PCcX4jwgAG+7xYHTR7cxjykxL6ryA8xa4ZzvPLE/qveniGX4vY5hNfbPNrvhjnV32xzq/4Yp1f9mGdp4Zjv/GGbItLb53tGpbN+ox+bqhPG2pR4kADeeCUPjfUEaQ6xM4z/Xd2cayuT+pnh/oEjx0nW+kx7ELTo2cPJRr6qD471EdYoscSsyihZ7AvncKKtI9yTT2l+0M9yXITLDfOcgHK6THdQOkmsaY9jaVYZ6ifYel5ltYsPcfS0yitu7qZDlMiUnvwNhadGO8oumVJ51FyKPhj1HZGSIUY/Gu6IjOHwhTTM7ZsO7/0jCXbTi49Y8e2M0vPWLHttNIzNuy+WbIULnnoDYJ/XVYTVH9YjSzI9reTvbRgmO2A58LeMN8Ez6V6mO8Q59L+MN8Kz6ULw3w3PJcuDvMN8Vy6NMz3xHPptWG++ZxLrxspPFBy6Q0jXSlJbxrpakl620jXStK7w3xfO5feM9L1knTZMeKNknjFijdL4lUr3iqJ16x4uyROrHinJF634t2SeMOK90riTSveL4m3rPigJN624sOSeMeKl1VRvGvFKyXxnhWvlsT7VrxWEh9YcVISH1rxekm8rOzzLolXrHizJF614q2SeM2Kt1XmucANRoo9cnr6bFst5EC3Xws50O3VQg50u7WQA91OLeRAt12TMYGrlCWx0Dop/Epp8t1yKFHGLMsDHU2YgBaMtQ3dQFgBbeg1XSMjYJUoeVjz5h6WrAXuqrpTGEWxKs6gLL7aQsvjZBz2Nx9OFgv31QMhm5OJ6pZhqtxUMiHdUMJUua4E6zBRYqhbU2KpW1ViqlsxZJXLSox1h4as8sCQVe47Yq/bc8Rgt+sIX+WOI3yV246MVluGr3LT8FVuOEJYue4IY2XiyIC15ghl5aojlJUrhrJyuUxZeVcoK2/LmHVTGCtvCGHldeGrvCZ0lUvCVrkobJUL4XMy0J6XIfSCDJIXZThckAHwklgen+e640XhfKHT5Iv0b3mBpgIYkV4g0SUsFi+Q5BKvs4V0L+Kmxwskt8SbfoG8linNSnBBnILbwSQ8Yyb4uvU4Xn0AO/+YNuXgv3gU5Y6gXE/KzaLcDMpN23JwftQodxLlTkg5jJscNjl6sRw8J8+g3GmUm5dyp1AuQrnQloPb5XModw7lnpVyZ1Guj3LP2HLw2Xwe5S6h3IKUu4hyF1DuvC2HZ+gMohfjKpeg/wo754bpnOumcyamc66ZzrlqOueK6ZzLpnPek755V7rmbemZN6Vj3pB+eV365TXpl0vSLxelX+460jF3DJPqtmFS3TJMqpvOv2znLHdN/VxquiY3LaVvclNSuiZdA6RvcrNROie0kXROV58H8GxIptKj1Et9MpWOk6m0mZrO6cItwaMbgc/9T8vEOmEZTaVzuvoiyp0qsKo+W+BJbaemc7p6AeXmWe44y51juSmW66Smc7r6Us7peoLlZllumuW6qemcrn4e5c6w3EmW67HcDMuNpcXOKZtD/4HnOA+ApIH/IkLVAPQhoulI3pUYkBwxHMlrpPlIRNuOvOGEG7+CpuDIy0+4YSyBdo70i4QbzRJo50hPTbgDKsgBjnTihFFPEgjpSP9OSGNK0aEjXT8hmylFy0q+ioSkphStKPlgEnKbUrSq5FtKSHFK0ZqSzywh06kj0K3yBSYkPKVoXcnHmZD3lKINJd9tQvpTijaVfNIJWVDleSn52hOSocrzUqIIEnKiyvNSwoyakBpVnpcSgtSEDKnyvJTwpCYkSpXnpYQuNSFfqjwvJaypCWlT5XkpIU9NyJ4qz8sVDlU8L7f1T+pO5z6Cg+K/5WL/EhCBDt2KyxElFa0+FCC2gg+degiRpV+F1zTg5Sybk1ZpTujEjOV0YsbSOjFjmZ2Y4ce/xOCX4ZPasfRoOyz16zXZb6jIeDVEq9ycDUrT2tcTuZ9zQ4lci7yaM0WJvC/yRs4bJfIFkTdhPqYO5bUZADQUh9An3QCKjt6BJaxdYTU9IZIMIizLfDqXygPO+YZ1zTa6ao+3ihzEchyNb9jj7SIvsRzHTTTtcUWLM790ztaGnKMNzdtwR2/G/RAPd6t0M+7DqMC4u82b0XIzvajDxqLGFmoEJGGtSHGsO3mTUaptS3WL5MdSShqOUsqW8q4YfbOsTPOrXNxiEjrkzPOJNwFK5NJN+DlVMCiSZeCoSIQGmldl81pcKPMdsaPlbMrFRlbZyBYfpCnrXzFaacs2tcFVd1u3WWU360LV0QZXP0QX3So1uPoQD9LyGW+zwQtR1T7NJutWrNtj3dKlamy0aKZl1zwtzNuHWnoxX7zpBI/v0YjhJl+y6dluuWeDWLmlK61VV7kPqve5xe1zLJf9K6FxTsU9wyWjmvaMvM7mkNvZxKm6ZFfLCgS2wDU+VjI/G8Bdl5RrWcmeLXndllxx+NTJEM1vG+fo4jnannPDnrOanbPt8ImSUzqVLTsX/uX52X179s2sbdnZO9nZK4oPm3zU/HxRz0Lx4SzYem7bepKsnt2sntWsnm3paGS1Tgv8jlWzgaiMBaf1D12ndt8wr5tNwdRocjPZFz2ezfdFk5spv2hymfUnRpXLzN+ocvLZ22mx2YRaTMWCtpRa2gdgkwufg64JTQPmK6RfEFbR22nuaCWkCVLFPVPFspPVAS/CmrwmW8uaY6pJHDvjN/WsO6aiDcfUtJnXtGVr2s5q2rE17Tp2jWFq2rM17duaDvKaDm1Ny8rWtKJMTavKrmpMTWvK1JQoU9O6ymraUKamzaymLVvTtqmp3/orCDq4dN8sOdpmydExS46uWXKMmSVHYJYc42bJMWGWHJNmyTFllhzTZskxY5Ycs2bJ0TNLjiNm7n/UzP3nzNz/mJn7Hzdz/xNmaXLSLE20WZqEZmkSmaXJKbM0mTdLk9OyNDkjS5NnZGnSl6XJWVmaPCtLk3OyNHlOlibnZWlyQZYcF2XJsSBLjkuy5HhelhwvyJLjRVlyfMz4qC1QTV2gmXNRtuQqiJs7LyQn1VTzQhikk0Tz2j18AWyMRvfXbF4/amJJiVZELduhXf0xIPa/iGXkC5o1PA8DySUsT/QCjCcXdct+QS6ttfoMSp+W0vMofYqlI5QObWlsx2qUPonSJ6T0cZQ+xtJzKH3UlsZOLezLNC/TupwkNC/TDpzoKZSetKWxiYuFfL6Mp4NDHd4NDbo2NFOOi2W/ElkQ/zlPKaF8Wu3YqAPHODRyy9wIlqQfJNl08pp0kCSbUl6XnpNk08obRQgmM7u8WZSZSebtoswQid4tyhYNDWhRZoiolp2i8JoL+oyacYluvmv80nQtnjZpODXSXAgW0W/Gjgu+Pl+rVtGxedp4aTig/mwa/BRHTM9hHc8CzncNMhVZvy3gGtOLBUGFoYqdQjtQC6x+XubzRs6XzOeNMNjVwkGn4FGnVZLQgUTlTauLt6bUIKHOmfOMyWfeQ8DCzF0nFYmBABIaOWYD2AdX2Xyl9TePq8aDZ7gPe0m6gqHd9cGsGKLgWn0AzGJ4Uke1WA/IH+PHW/Pw2WrItia3g5Lg27TPLS5AhbFE8O2ooDvQjXjNfRdPNhhEQNpcrVsyPfgxRU3tA37birR/1gUUKI72BrptScuqMGjrVpbVHZ6xgilTjd5iyyYZMJSdyfpLWIkxWXkJ67Qq3OlXW1ysmIlCVTjG4eIM90NB3BaA+M9GcO3eJW43HDaBOG0Zm/cWBro5kBhkP95+BrmIXldbjlRRhQJGb2Zyx4E/C5O7AmzH9J7DJTjT+w5XwkwfOFyQMn3ocJHH9PJHa68tk15RV9xDk15VV+Coy/SauuLum3SC9YQv6XVFMlqmNxRJZJneVCR/lcYrkrZK6xXJVqX5ihtXRDXnPRhQ8D3J7jFbwtD2Db/iZgBfVrO1L31EDrWCbzF9idJ4xcWbNR90La69C1dIPtla5jUbdnUtbNCBtSvB7lX2SJSqxjW4AdbQpRr5xyU16Gbh66Oo/phC9bxQN0HAehVfYdV8hdL4RlwzbmrZ2+fWrv0au6Un4dnWNewX2eUXaTSPeVTolct1/N2ah71iXkQrFG1DtG1EqxTtQLRDES4OjwhfnuVltV3L09/rM712CW4Qkkbpf+4xSaeJQ08qXmPFu6h411wroWgPoj0jWqdoH6J9I9qg6ACiAyPapOgQokMj2qJo+TSsHqdFtE3RCkQrRrRD0SpEq0a0S9EaRGtGtEdRAlFiRPsUrUO0bkQHFG1AtGFEhxRtQrRpRMsNtg6iLSNaoWgbom0jWqVoB6IdI1qjaBeiXSNKKNqDaM+I1inah2jfiDYoOoDo4LT2uW36Kb6PzVA64zl365kkGtN+nJywkuVngFrvxytzWZkzCai74oPZrMyZJBrXfrw7lZU5nSAYPt4az8qcTqIJtqxruls0lftNTBX9Jrq6qyfekd9J8ztufgP+urpryo2V/Ca6esr24q6esK+8qyftU+7qcUjPMImt5y1J0ij2DJNjkD6TKQwMKNejmvGb4FPTLfpN1Og3MYnfDTecwO+6G47jN3HDAL9rLtzT6Tcxxnv3wym+1kvhNOTbKpzB7wrCE2tmP6nG+fAR/N4Mj+KnH86xFoQn1ji7Ps48ZtU1zIBP4keHGj+7mFPXOIeO8AubfQ3T3Xm2DDPqGubJZ/AThM/gBzPqGibBZ/GzED7LXgXvB3TLS+Fz7Hh+eJ5v8lJ4gTfhhxfZuRfCBZbzw0vsYQvh8yznhy+wEy6EL5rvh+XgPlGTlX+X7hO+HtMv6heG+izMEyki0nZqdEZ/Xl+CqwKMFmcQt0CTxS6OBXpBX4QDA46dYohEBBtFiui1PZQY1xf0eTg3oMRJljhBw8dxHaDcON0nfD2hn4OTxhzLHWW5IyzXQzk9q8dReoKjkK8n9bSeGupnWbrP0qdZOmTpYyitZ/SEdZ/w6T7Bcce6T0gfMoeCP2aw3WVoqtKZvM4VWRej/h6CXutcMbn4vRsGnAyE4/hZDCfNXKcqc52GbjBKBtPOBXLD7AnrzYSYg0AIIoIpMSCCokME02IeBd+GCGZohITA0OrM0rQKgWHdoQPHKCUTootWXcRuAU12DCFbCEvQAYLDJvUslg+90XNyV2aT+neWUtyKeIdg+tQI/oSdKNthnt8nnqWfeZ34I14n/ojXiT/ideKPeJ34I14nfsnrpHTJkteJX/I6MRgCfsnrJBcWvU5yadHrJJcWvU5yadHrJJcWvU5yadHrJJcWvU5yadHrJJcWvU5yadHrJJcWvU5yadHrJJcWvU5yacnrJBeXvE5yccnrJBeXvE5yccnrJBeXvE5yccnrJBeXvE5yccnrJBeXvE5yccnrJBeXvE5yccnrJBeXvE5yccnrJBeXvE4Kz7vodVJ43kWvk8LzLnqdFJ530euk8LxF7NPrhOP+QU1Gwv0aItbodRLwxmvhOJ9LDSqNXiccUSv4s5Tir/E6mUJ6y6FE8YDxOpnWE9A4k4gUHccubqIDhGGTzkhzGYXVVtnrpGa9TqYLc5BRr5MuZkSX4HXSbf1sU1Uf1LF4PagaJ2IsXver8rtnfnfN74753Ta/W1XZP9o9AYtvUqVHXiXe53wr6qRX3HUrOxBZN73ibljZocjG0ivuJqD99pgPEQ0MJOb40AeagvZoi4HK8ySSpBIvn7QR0PTug/oD8yZ9dGD1Tz6MWil3v+IVKQo/0zEW7YnfYMpIA2nI6knhEEm57wFZB4GYXM7iUduHjz0NqT9JaCxfq0qbtnz53ffkd9X8brryy+1OhN0NtBfc1AIpyDgXGuBwb8qw2QaS6l0habyQ2GpJ9a+QXF7IaxcktYilMVNLV7gn4RCm4pqkrmNnkKkbeBpM3cTuH1O3sd/H1F2sqpm6h7gQ2UZxuL0nm9ACVC+7z4JNL9vOAkcv+81EoEcbqANrHP4jn6zpDm0WFsKlxrEnasjqsSAEPg5imDLS0mrsYoz8aZeDpNIOaGguq4NjWsWHx8hpfmwQPA/X/Jcra5/GroB2g3/jaNGmEjFCYe0k2F506xYg7Js5gHg4juhOstv4ceWbiiw2TeB4+AgPddUDJN4uHY0rcvzPvEdaG790iLMg+yB8y1yDudAipjrSrBYW0esO1sFRDUdqhSPNBLEJCINF+CIX0Lph5grT78J5zBWMRJ+zLOpV6nmVVQB+kv8Hvudz7v6J0sd8zj04UfqSz7mHJ+xnPPrtYt//hGwI4UNu8UPGBv5J8/m2ss+3rcfx/625SD605EN+kjfoDHHSfMIt8wk380+YMSmrJ/nJ8/ttPu37bYlN91/m+/XiA4TNtv6Hl9RlgQxdrd+JXjeQoSclvmXFMTEt4YJWeLp34S2jvcL0MCKm4ztzMN7HO79SGYRv69fjbW8QfoN+Pd6rDcI39etx4g7Cj+vX483qILymXyfG6Cf06/GqPwi/Me91C+4STiKM6Bv6+eDbUNSDifENkQffrl/HgoXgP5aERL9B8ND93uPAQ/+bo7JR+wa72Ktc+mE6/ka8WX93EF2Jl49TuXbMha/EyXHAf16SaP1XDWiFfvWce+inGEpT+OC9Tg+ZiO/oSrw2L7CgHe3myKRsIxGHO7fmkgJE6Miut6tfJ2n9qxxwkqiKsbOur8TrpwfRlXz/toNR0dOdEg5oh+bfaklWHUb1EWxQN9VX7CT89cLD3XPMw8WD1a+fdQ+ACurrV5HeJyooxXtABfX0N+pPWLPrNf1xm3xTf4MJ12WK4bpMMVyXKYbrMlUxdZ5zD+BAUYf9Fv/fmtP1x6GCIoziVQFFFxaT17GQJY4qQsofRl4RFbQDDStRLowaZGcJEWot7/+KAPheEcZFB1x9hI5F93fvRC/PV/TL8YEahK/qt6MrhL59K66EsfTD6DVsZL9iPPheMR58rxgPvleMB98rxoPvFfHge0U8+F4RD75XxIPvFfHge0WsAa+IB98r4sH3injwvSLREK/A2tDHjw7P4qcXPoufIDyHn3r4HH7EVPqqjml4fEvHoqtf4XwtZUFi9+BEfY6Cnn6WvxrecwkP9XWfogW66qEd+gwFS/o0f6/BS84Uvq5PUXaDnni4Lx1ScFtr/t6F85uUvQdEEz4XfTyVBwWPvESenZ5L5WEC0oRPF16DFnImxhozjj2OGy9j/RBe1a9xefGqsJLL4MwT0/CI9qWyNDwqyVUnDeckueKk4TFJLjtpeFyS99LwhKTupuFJSd1OQy2pm2kYSupGGkaSup6GpyR1LQ3nJbWUhqcltZiGZyS1kIbPSKqfhn1J6TQ8K6leCrsO30kKyw5fUwrbDl9pyujrmHCT5s3K/b5iX++S7KWHRzRudUmQesKjek5y2HoP5/Qxya0gd0wflxy26sPjcNtF7l6ahCf0ScncTZPwJPYskbmdJqHWoWRupkkYInoGmRtpEkb6lGSup0l4Cs69yAC7YB6hN8gAu+C0PiMZYBecweYpMsAueEb3JQPsgr4+KxlgF5yFCzAywC54Vp+TDLALzunnJAPsgucw6UKmQiQE01nESn9VH6EL1VV9lFO8q3qO076r+hinglf1cU4Pr+oTmDFe1SehMq5qjTnlVR1iknlVRxi9r+pTmIZe1fOYl17VpzFRvarPQJlc1c9gKntVc257VZ/FZPeqfhZj/FV9DjODq/o5TBmuajrOvJzr9NeIUuvpl+EtSMebdUe/rClYEfeZrUywLL4xm5ngUBzqNhx9BfPOV7WLCitwF3nVavsrUFmvARMn5UEj1BDWy0JdRf6KNc68jEtsOx+wyUjvIG3ku0gHkt5DuifpfaS1pA+Q7kv6EOkFSS+rD/DcmF5BeknSq0hfk/Qa0tclnSB9Q9LriiB+TG8owvUxvYn0XUlvIX3PtB/pZcfcADIrJrOLzKrJ7CGzZjL7yCSOfpn6/1Xof3epoFSLX2MNJ1SotuQpvqIpqovS5YM0ooAiMXQZUU80MW1dRiS6U8xdRiRKWSxeRrQgeprb5ka0SJGEaBvRkihvbpob0TXR4wzRNqLrFEnEvhHdEM3OiH0jukmRROwb0W1R94zYN6K7ovk59hrRPYokWN+IPlI+ooIlWt9IVxwzNEi4vpGuitTG6xvpmmOGDAnYN9LEMeOHBOuXRw5i+5kPK6zK98Rp1gI+BXwF8klFDfYzJzIYtldgQDQF6joTLt2xwmomxLfTx6wE+b6+QtOhKcVaNwq1bufHvLza3crjLraXS/Or0ayY1YBvoFD7QfHKmfTwsbXDuPho7StOufatQu2rzuNqX3MeVztMjHwyhdpfBpnAvBBqCY4pVq9x7U63VVH2n6PgfPGadgwEKzyhLFIpnaEOq+IMteOXg4CWXXGGWvfgdAQXBsGicwxlt/ggHVTFCWnbF/ejHUccjw6VeB4lXvgxbFo3DGadY1jAw8t0uKqGL9Ghyg8XjYOVuJspE9vhwQEr3mgYI49jiMXFHWuvKu5Ym764Y20Zd6x9ZcKQPLhjxesNg4znGK5ycc7arYpz1oYvzlmbxjlrT4lz1ooH76w4aRgwPYfWPokFqYqr1rovvlobJhZkV4m31rIHdy0z233VrHvqDyMXvwdO5OEhNmRf/FVo+4j+cAc1ZveAx4aHUWV214nE389ndgdktWiLy+y2E7XE457ZLSdqG1/AUTY7g6NuUdyxnp0AotgzwC7sw+3uLExaz2FdfA4r5GcfrWKihPmOKsZRRYgqIlRxClWcQRWnUcX8o1WMlxDiUUWAKuZQxTFUcRxVaFRxElWceLSKoIQnjyoIjXYZVbyEKhZRxVFUcQRV+I9WMVZCn3fpQayrCImpI96lgSCVpv4YqniRIWKPVtEtYdWjiklUMZXmOJoE/CRmIGE2H6nCy5Ht88nMqwI08yrWGG4ZmJ62JEe/JiMoB9ZcKbyqX5PhFHQLrkX+fpn7DaYQwLWMdLMoHbfSraI0sNLtonTMSneK0q6VYquBwz9hVkT6GkaQ12R/q61a8l2Er8WV8OXcaJHjW4S5e3iJMbpgVsuTBYa+PLwy7ObJsTyZ432E43lyIk9O5sncah5O58mZPAlos9f0y/aRE3jsZXkxV+jlKlAmLp4QnF8JWMIcfGIJS8LcqjKAJMzBk5ZQJMxhI4AgJMzB8ZbwI8wdOPCpAUoUcnDUHUsAFoUc/HcDwLcztwsEUqC4Mwev34kECFLIbTupnkwAJIUcnISnknBKcptOqqeTcFpycCqeScIZycHXeDYJZ/XLeLcvx+MGUI7D1mtG2c2OKJyZEe0xPaIKpka+68mRj3Ri5IsbLxFDkPezwAmBrlqkg0AnzZkgkBeyCpmyIS+MFjJfQ77JvEzWkG8wLzM15MUxXKZpyIsPuczRqBFSsZ5zflZerURcYzz6gffwUbC5ti/xI3+VKxHdK/a4lE/YTA828kJ4zka6WZROW+lWUTqVTaSK0kkr3SlKJ7LpVVE6nk2vitIgm14VpWPZxKoo7WYTq6K0nU2sVEHayiZWRWkzm1IVpY1sSlWU1rMpVVFatVLsImZqzbNqLe/kNJ79kVBgeTIHRwrP58kLefLiU5XddknZbZWU3WZJ2W2UlN16SdklJWUHJZkrOyjJXNlBSebKDkoyV3aHJWV3UFJ2+yVlt1dSdrslZbdTUnbbVtllSrKXhL1cSZ5PwvO5kryQhBdyJXkxCS/a/jP9OCV5cURJXhhRkudHlGRvREnOjijJmRElOT2iJKdGlOTkiJKcGFGS4yNKMhhRkmMjSrI7oiTbI0qyNaIkm0UlWVCzdgGbK1q7eM1VrV245srWLFp/f8r20lOV7aVRZXvxscr2wmOV7fnHKtveY5Xt7GOV7cxjle30Y5Xt1GOV7eRjle3EY5Xt+GOVbfBYZTv2WGXbfayybT9W2baKyvZRJb7xWCW++VglvvVYJb79ZCU+LUC4C7qTIG6GW2LwefoT+g0UeMO4Yb2Odep8RS+0vn9SzQhK8vLxO1ENW3uyzBbkXxVPvxt2dMUSVKw7UQ+IT4xl6AGqdjZ2GPQgHkGursfT70Z+PI3Y/zyiASpV5e7SbgbrLAdVnoMygjaqYyu4brRKDf1PewjUkFr0rARkUKw7uUwt2diGabL9CZbd9Mc7gDT2SbFowx3WnXCWUNGMC3Hpzlf9ZFR/S7tx7RPvgZlNLuDiutJA4fjWLFOVMvlRXePxPWUK+E8osOK1gNYN8GrrKs6IP3uvS3d05ay78BK9BSpn3f5L2DNHSr/kLkiq95Lbl1SATTWm6thUY6qCTbUazEcxfMi4RV2LgwEZMvkkQP94ULkTOfP2MTrxzi9WBsE7fO9oM0ARBVU8e+9u+b03s/eudBPvvYX33i68d4WvpBCsgn300sHW6Htv4r037WgSr7xg3rtbeO9GbH3oZwsRLdMf95YefcUWK9zWujWLB7M9hwcj/Re0zfEMYcCVeRTiPlneh+WpWg1yFTxrIKgnAbsNlwWGwDgDxPCxsB9vOO8Owm5cCRu6DgcqwkbKNaSDeixC58wi9U5hNqMYhvsJXCJUiBdAz8o9sU1lXv6sdVfgsmd1B0zkjbc6AECezS87/a55TVGTgatyY6aCqCWY3k0C8bVgqkZVCu9GaVeUjJxir6lnde8heWQRzQA0olCVHntL13GgXu7tTnzwW5UBTWfbv1kZ0AqWfKUyoEHr8H+pgBjRiXd+ozKgaW+/M4Bdj7xr03ElbPFJHgYD0ycquiV79gpb9FEzuAUD2xhueP8Urrot29Ek7NJNOTf4Di1AFRK3CV/yjTERLUsEJ0SbRrRC0RY9zo1oVWJPIdo2ojWKdiDaMaKEol2Ido1onaI9iPaMaIOifYj2jWiTogOIDoxoi6JDiA6NaFvCVjGXWg5EtEPRCkQrRrQrAbcQrRrRHkVrEK0Z0T5FCUSJER1QtA7RuhEdUrQB0YYRLdO2twnRphGtSOgr/faNaFUsgBBtG9GaBO1CtGNECUW7EO0a0TpFexDtGdEGRfsQ7RvRJkUHEB2gPx1UCcgcrx0fRHXjXeDE+1Vi6MarxwdRJ5PuVaHAVLxyfBB1M+luFV7aCn4g0YyVim9WpJjfqcLq+RsVdKpKcMkEMQ/gDi2zXzFcDnQ7x+lF6wc5cC+9aDYHjDMzE2Y8mIHYZPFgsmuw28a7PvvyZK7jJ/LkeJ4M8uRYnnTgFy31xdvVwlch3zWutcMci22MDYJ/G5FuZ921Gm6/g+Qqk10kV5icQXKZSYXkYRXJJhiE5RK+nrLfYAt6oGVp9zCMGO0ExYwCEm0nPuFV4z7IVCB+4FXjPsiUFt/vqnEfZGpBIkarxn2QqSWJDq0a90GmrguwSNW4DzJ1U8BDqsZ9kKm7AjJdNe6DTBn3QaaN+yDTxn2QaeM+yLS4D0Lx7R2AykNX4ho8/TDwLx/HhseP+07zvqFd/znLv/5fXSWP2xxWnohPbmVs4WlYU/dLjoB17b353f/kzKX6j96/mt6KHE5C4A2Sr9ExESKoLDE8E11/yBJRY9gii4CXkmrX5865wJ3WPoiYuTWHTXSXcAGFRvjqvrZX6hVMAOZK1wRa1F6pFzWHLUDZ6RrgmeHKVtWEVL01B/6IDyy+akISBRClNgsXqxYupsPO6MWuC7CovZiOOsMWMJ9xNwU7NdBVrgnFSFFq+JcMVRNaWD4F3czQ2LQNLKb20mKksfCWNN78k/z36yCVB1gIYTkKZnLpdZ5uFQvSp7FWuqgJhvbpWAhnqKqu35pD+OgHETN4TFG12ExfempNl6Q16cleWVqXnu5L16/Jl2KI5TzdLDaODNfV0ulY6rb+bl2pB9P3BQV9FLx7zRlF7151RuG7V5xR/O5lZxTA+94ogPfdUQDv26MA3jdHAbxvFAG8CUJfEHRGsce7o9jjY6PY48Eo9vj4KPb4xCj2+OQo9vjUKPb49Cj2+Mwo9vhsAXuca3un/OAz8PHis8/Qx4uPP4MfL76BDH+8+BIyAPJ7jwEgv/sYAPLbjwEgv/kYAPIbowDkTum1YClLPIwiuDrNZSPg6jSajYCr03Q2Aq5OA9oIuDrNaCPg6jSmjYCr06Q2Aq5Ow9oIuDrNayPg6jSy5QvSSkvPFsDVZ4oI6NPFzFQxM1nMTBQz48VMUMyMFTPdYqZTzLSLmX8lWO+/IOx6pZ5c/vBHPtmRj23kMynFqH1a2BjKhZdH8jfK2YVytv6kqt8TUody6ZWR/M1ydrGcDZ5a9+ZIXasj+dvl7FI523tq3Vsjda2N5O+Ws9fKWf3EulsPfcuRzBUZYxiexpFMRfb/KY7kEdHho6Jl5xHRyqOi1UdFa4+KkkdF64+KNh4VbT4q2npUtP0IaTKXzH/ESZ8TX/kP/Jz0OfIRiLNWoGGuGqJKg20Tr7QZ6yLMK/C1DGRiiU5Zl/iqDAz9rp0vEiXb8oHKl1CzgUILhJKQ+IIKSLFuyMwSk8MmZ6iwCDakNYYu1BMskJvawEebiZ0gb9yV5IohTAa4tnvFEDYcuvYqJKVpG8aaplmgNMyipcOFDFmmqwZXgISzG1VdjfePC8s0hmrDn+zFez0J4NmZFOJkRUyru1HzMRYteRPv62byMGq9P2R8EU4CG6ZEaLQwoSsyL2+Y1gFUsCgnFCEomUlT2frAUOi00XslKINIbA2zj5NTe8fLc4Yv2kZveBK9QcroNGHQuqOWCoPfrU5GGG2ama2AhPS5USJ99kcLOFmBR5mfV92sKJifGynRDXadVuvvHVNH77sPWNSYtlZO8xnDIrE3b3oODVziw6bi1XnjkKbizXnjXabi1dMm7lDF+/PGa0zFB6eMC5gyISrhpFZAUBAfOhWvyWmg1zuYN4SrKj48ZQhXVZzMGz5VFW/PGz5VFSenTUCiig/nDSOripfnDSOritfnjbObinfmDeEq2Tk3HJprVuYz6tRNJ/I/+po35nNe1C24lal4tyDadiKQFi6fzkU78DZTiJIR+tTjBgDVw06jRQY+RuTdWYv4i292WQrNoNARFjpagPFtpeT2PVQsNIFCkyw0VcYiJn+DFOqi0BgLBSzUYaFGSibhfSV3vot4FS4UmyzKpWAbPlfHDfFbYAlMPWN+0gYiSpkgJZ5H+xUP1MTCxXRdbGAsZCL+n+5aWdi8N3TjWFhawnF4olvKcSwtLek4FpSWdhw3VyAeF+BFoR7HE7xmtPvJnIK88jgKcsOoa2i/aJy5K6nbht+Lxpllw0J7z3J5iXlm1aRXrBnGFfNMYtJrjqXoEvPMhkmvO9AmBO06kfGz57PX75CdBq31CZm7KLph+4l9SMLtg9WUfVTC7YOllH1geI28c6yl7JMTeh+spMzzM/Q+WEfhES5ZyQ2sovggW/oEVhYnhEMuroQnWIrt1k6hhesOwOCETqfKxKYjoHDCCyAsroTLTIQWxtC47joSUAjQ1i2HNg9ZrpkLix3vZG5gZPR8IavbFsTBsAyuCnka2mPAQwXBspaBV9YNbmXDQlY2DVply/Tgylihk8583Tqp7Z6RGZbRQcHcbbsobEa2kwIJxXZT4JrYjgrsEttVgUySdVYwMefdFeTNeYeNpqXLcnZz0nbcyh+dfmsloB9P7OMVWiqs/O1DFloqrPvtoxZaKqz67QM3tFRY9NvnbmipsOa3j9/QUmHJn70Fw0uFJX/2MgwxFZb82SsxzFRY8suL+QN+dUn22WUfnXx//Oyyry7JPjvyKTsYnKTcviVQPnBIUa+ItT4mfByKNMpC7QQHF9I2EfheEUZ9UqiXFZxlFCHTp1PjsZt/2TRgmJsT98eTAvfHn578BPJT/2hKxn1v+d01vzvmF+DGeuZrfvuJ/fjtpy9KQJu5W58PxHz8AkIpj4Pwkx3x6+HDcAydNIGAA1PNTePqc5sPAjNT4xt0z/gMLTv2MTxJreRKpaBS/IJKqRZUSq2sUuoFldIoq5RmQaW0CiqlXVApnYJK6RZUylhBpQRFlTJeUikTJZUyWRwF0bfzcRC9Otco0WxRp0S9P4hWKZJDGbVS5IcyekV0z4heEfVT1Cuifop6RXRPUa+I7inqFdE9Rb0iuqeoV0T3FPWK6J6SXhHlU9Iron1KekW0T1mviPop6xXRP2W9IvpnLZNtZPonyWSbmf5Zz2Tw2hNe0eydeaJPLLWovL2yvuKbCI/wHYVHn669jlrtdSTTXr7VXlU7ZahZ/bRj5xG72Txiz84j9q1COzAKzaqvjlVfRqOtKKPRVqHRjPIat5dIoNKM/hKNtgGNJgc3odMM5fystE6BYONpWm7a4G0/SVMdNZrqiNVUfmqBykVP1aw66msLqm3mLYtm3rJkVNc1e+NUVR2jqozuuml0123jjHjX3DN11YTVVZPGjVBuWaDOp43boPGaTBx7y9Bord9pqM4DH55eC3ei9nxOe3jw88QMfxgRO3xfEWWtrtuaeYScTmDdYfKIJ53EB23yCDidwtds8ohIDQjgEu+rAUnl6VEWVePKN3VgTnHeC5sKZNzOnaj7lreE5X8V8CJYYfYG2OwxNkP4cNC5rE4/JLDeNrAhx+X6eJpvrgPxtv6ZJx83nPNAGYl83RJ3lCZ9s8AnnV2QV4yEch6vdjzNduPRxvwGOmpJo+1wp8rbj9zoPRAlBffQzO7Bj7dPFFs6UWipH++cQBtrvCN72B+5EXGOszfSedyN4BL5jUx8nW7k4GTxRiZLN3J4cuRGJv9AN4JL5Dcy+XW6kbWweCNTpRtJwpEbmfoD3Qgukd/I1NfpRrai4o0EpRvZjkZuJPiaN0LwkdE7wTXyOwmKd5KZ+11aJwxq8rjwkEbGEdelI405NqEz6Uouncylq7l0Kpeu5dIgl+6fAgh0faDHgk/odrwAf4pfAne2rgQ36OEpt4JzHba/ggmFFx82B7whssSLP2HSHhj7A3LbnYFdZyF70GX2wGTXAma3DLj21jizq65k9yeY3TPZ1SlmNzzJbk4zu+xLdm+G2R2/wAXRND4y4/QU+UFXeQ+mLTXHNADEYdJk68Q1Yw3gMJzfIRqBmCNNmQuGpK6/F5LJ/m5IYvvbIYnub4bkvb+BYANgjoxzTorwAmCOTHLyioACYI5Mc5aLEAJMIWbF6aMnXiZHOFsOj9JOFc7FFTqNVjIQc0IMcWpBQ9acEJXTwIbzEdWI6mChQ+0wzCU81Ic9DpenGQ7NIU4lxtVJYRXH5N4Uvg7l7ZolAG8P4yruFrY43DxMcFL2HmxsfDwYoPm8CH4mj5DGWMMGIl1AhnqBHsn8TguOvJxdtdaz1+TF/rthVchXzX3/IX1TvnDM52/K/6Pzpoovx742eVM/46muOMHvzBmag+DfjNpE467nnsL0i95w3o0U5fA2VYOoE687VJF3gr/mhPXY0e4d6uuadjkMOIOwC2e39/DW4CBcgyuwK5XrBj5gz7g3R9jR+gCvNVR6zMPEJ+AuVwFMvgt/XjeeEgd91qEMwnhU1YGVeLljdTUfAerG47hqz2jaM7wiqUDTniEev9aBV3DKjf9vIXCLjYvGdaeArfVqWtrvGf/wYRjgqXi8t1bsvhc1n3AHvGG5ujMIlXlXuimNcOOJO7H65GPOBbaaZ88F2XC5Ng9blCOS3shZKvYK91v2GpfOIL6J+NR35uC+127911V17r7/4P9F1sYFCdTvS5y+ljD9nkTpBxKkXxdKlUp4nsPEAnrZJQx+zwshhT6SMqTtKP3r9FzKkLZjcLVy9fGUIW0nUsaynUwZxKZTRq+FKcPWIrhLufpUyrC1+ZTxaqdTBqqdSRmh9kzK0LR+ypi0symD0Z5NGYV2LmX42XMp487Op2EvdhiHh2nFRX1pkDFnaEdfFB10wSAZeUSZvmCQjOCtyByRjKq6JjkiGYGNgDkiGdWBQ4EckIwamDQhAySjpm5JBkhG4NpmBkhGbd2RDJCMOsAcRwZIRl09JhkgGY3pQDJAMgr0uGSAZDSuJyQDJKMJPSkZIBlNgmkVGSAZTelpyQDJaFrPSAZIRjN6VjJAMprVPckAyainL6J/XsxWrs8PogsALUscfQHufGv4rdLGcAF+fSv4rdM2cQF7qff0BWz83tUXsB98W1/QtIFc0DS6XoCT43V9QY/BnHJBB7CzXNDjmC9d0BOwzFzQk1jpXdBcAF7Q01gXXtAzWC5eQFhGXV/QPXxXC2jpglG3X8Ge+4xFY63OY+Lb57QguCVOAg3tMtjFeBHUkO29ZN0M6sgGL1k/hCay5ACpIFV5yboRCKJ2fxB8Gv4aVUJOw/U49NhnFPD7xGEAGoEzyCZVH72Nh7KwrJu8gELXBN62avGgCd0t/sfIQ+ubeKgaxvym3FmtOOy3zLDfNsN+xwz7XTPsj8mwH8iwPy7D/oQM+5My7E/JsD8tw/6MDPuzMuz3ZNg/IsP+URn252TYPybD/nEZ9k/IsH8S7DX88hyhvYjcAblrfENcETVMlBb9FTIkvaukK+KLy+cIYC9y2Vc1rxKAwsgliBHboDmQs1V9sAe7/DA0G70IMiOXiES8pWsyQ+BdXk81bxp0Y3wIN0FP7NKax0d0lxXzoWFTQJ4loDFd0QUgOnLFQNeWFwDoCtcSjSXJMNLihN8YaC3uL2Qcr5uPqwZfEoYSCNVbjm4p1CYMbTE8Hb5hCBL0zK96qvZA3aePUwKXfbpuYtwPPeEvKYROYzSLXO3BE4p4p/CjkGkH9WGr6E6hla7YeJ/WQ8CgNg0jnTMIawqTD4YlKa4HWZ/p8OCSxFwkyjhMbIAiloFRJZ5+u1PhVCZ23pML2XAh43YDG2N+ss94ITnfHYQVDtNvM+aocKolyXvCqbgbxhCOXsl9bPGKaamM1Yb8KJ4KKxaWVlfyumr0fMgfCSdidTFDSZSeRAc2+bTpHVUvBKoVwhXTIR50NXbk9pqcGND3qHhCgc4J5H5ienpKEfgrwxU6njK3Y1qSvfeHebRXoQ/MCXqwM8DwHTt3wop2OxU7UxNYq9bnMUHx/jBPUC7G6rPhJQz9cK75QztBWTATlIWRCcrC/z9BefwExQz7ntGhdiL3h3SSYqZTMkn5W67jPpDVMFoN45rLZVUkhKFpHrjlYv1QN6K64Qr0sEAWUWAo/jyslUXUMzx+HpbNItKGrM/D8llEgnNA0YIRCdQBRYtGJGgHFC0ZkQAeUHTNiATzgKLrRiSwBxTdMCJBPqDophEJ+AFFt41I8A8oumtEAoFA0T0jEhQEioB9YNbtgoRA6YqVWjQESlet1CIiULpmpRYVgdLESi2cX8kA83OeqsqOh74TufMVrc5XKjCWvY3UeOy+/V7oExzaiTe/VHl3EG8uOwOUqcXunagef9V5L1YMun0LoyGCV85X/qMv+50KF7KVvjr8kq+dj3c4qm59OXNzX7oVehlwnfGxqpyvfO+X/a5bcRQIdrNzfTQm6HhtP5e+rb33Om7bK0g6MM2yQZ/ylmw7VEtOVm3XprBa/s6OAyQq/y06GfbVwZf8yIsX35Z2rnzZl+iYLUeCYpIv+2H7zd+68n/83hsXfvvnswRpZYOfdKKGEf36zye4yOScrsbe23O6gUnuHTbq95xPIF85X/mPv+zPRZ3CM91edjhvBMkk9mIzJ8ml3F9y6dbc8B3CXKuzlc5LlWmmVP0lFUiq8pJioFXsDC7jdpimW3K8sQPs/csKE4K/gbR7VnkvMfszJtuW7N8x2SnJ/gKz5yvHXq7QyxjZDo3Y4BWer7T+s5bjPsCbK0UV5Dve8jjrTz4UPPlQ78mH9JMP9Z98aOHJhxaffGjpyYeuPekQPPaCT8IKVYkPz2LPoIK40ZCTPZi5nLgSKngVviU1/aF4eFgQkly3EL9ActxyPhnJXy9nnxxdQgLfcuHDkbrWR/I3ytmnhJcQArFcenkkvzFS+c1yNnhq5bsjla2M5DdHKr9dzvaeWvneSGWrI/mtkcrvlrP6qZXvj1S2NpLfHqn8Xjnbf2rlByOVJSP5nZHKl0fyC0+t/XCktvWR/O5IbSsj+cWn1r7sjvSPkdr3RmpbHckvPbX2lZHaN0dq3x+pbW0kf+2JtQtH/aY7CP4tUTGgPahow4zS+hVFEvTzlYp3Xzu+qLeTjJA+tfQwckQV5gIlajMXuKIlcoEnGiUX+KJ9ckFVNFUuyAPdCjFvt+bABYP4aAQwM5AZEbv+rTmhv7g1xwmke2sOCCNa3ZqLOHsBD4mXJbeZ/CCNnPyhJCQX8SKlVaqdhNn9cvagnD0sZ5f9UnYlz1oleWzpYav1Y75yHrStXc6fB5iO4vvoqwoZjN78T77yk8nv/L2N11PtvMOt4b6qwEPoWkgW+qVQaH5hx8AqkNHYfcQAME6bZPQIUMAqsMr5BYikSGaPi3ioqjKEk1dSJV8gigzhT7LOZ8ozh/BP2aiS9xEVDuGVtYk8L6CHcNzaQp7X7Q/h2rWNPJuzMITz1w7ybOXiEO5hu8iz8UtDOJDtIc97ujaEi9l+FQ2shwph2H0lg+Bb8LonO8bYQ+0H3wjLhjwqdJp6GjrgwMPSs6qbWLLCoz9s6KpuY8la1R0sWasgp23rqh7HkhXxAeCt1VUGQuOasBIpWXrGOxVOepZpJ6nCWzJbhkhomau7I9JVSjsj0jVK2yPShNLWiFSQnZoj0g1KGyPSTUGBGpFuUTo2IpWQM/rBVvIdJwbINt/uYDYPJhpluXBr7UqLm6xiV/vFjnPxvhg9J603pRg8+2I21QanQMyf3HpCj/PFCloVY0RdjBENMUY0xWzRErNFW8wWHTFwdMXAMSbdd0rsHNJFxRTbQzSMxNLAbB1X4g3XuL5P6JlhNCNOoNO6NoT7Hia0xTjiMbg3DKOpdKi72Df9wHj4dYrx0UBD0y1zGH6HzWLkNY/WzVH4QI4VY6EZntIF9toHxkmwXQyz5uGWOUz/xUYxgpuH6+bw9dKVBebYF6BikLVFeWRyGo0PAVyA4+2UXwDQmvVEGh0pqLgoRAvGCzrPg9Ocjy3dKp2BoyrOmR0WzgGpSFCINE7h3VLIeUM9jhJzeLiTsAYfRUXHkugUn9C2W74NUNFFx4fRPAEYohPF9p1m++DJeZHfXdQb6mNJdIZNmNXeRzcJG/Mc3tEkbMu81MkkeoaXWhu51JFhkSEpifpSvZdof6hPJtFZ1tvTXvF+n2VVDBZqoi1D3UvQiHM4+Xjh2QGiIdLFU4+zPh/X9RPdRDsbaGdd2jmZREdZ+aZU7ulZ3tDJJJpD5UfgoruAtk0m0XOsS+sTxQuc4OkrcrqPtnkJCo/j9NlC2/ziWdo0q1cUnmdVu+iBAW7lgzS6hDfyQRo9X3xmF1K21ANyGFrq4VJZb1gmEZM+kiR6chhV0yT5wLjb4oILbJyPGnp5HP1yGk3oiSTRx4ZAA+/oS3q+eMUjUstNVlIrnFVDABlaMQQQeVM/Xz5vFnX19EW+rZ5UAsfmBsDF2yTHGdPSJ3dcygkwfoZy6UCJyPuQn6VcegPjyxqCaX6ccnmRWyJnf3yOcnlDqyIfh1xTLo97D09mDACdpAFpa/PE1kTuQz4BuXkGtymuQTwLsbkrYofgrlq8q665q12X8tOQn6Fc7mpd5H3Iz1Iud8XQujruqsW76pq72hb5HOTPUS53tSbyccg15XJX+2h9t6RkZ6AJp9NhYmNFuwKM7uFcc9P0tm6V9O4MXqE5bUVO83HahACx8zS4htdL+pgo6easGzyphpNmBTedJ8H+NHXFDVr/ha8W7qsHspKUAWlLyYi0qWRI2lAyJq0rGZQSJaPSmhLoi1UlcBcrSiAulpWB9ncEyuLAkXFr3xHIij2nzIpAKmthKjhiOAeOGvaAOUMFcExWsrJNkBhOgjXHcBI4slOw4shWwbIjewX3ZK/gruwV3Ja9gpuyV3BD9gquy17BNdkrWJK9gkXZK1iQvYI+qBowLl+QcfmijOALMoJfkhH8eT7QF+NFQA5ghqhfZBT4CzTW4yW+gBAxdvEXECDmY3OwhXTvIy2hm0jpiB37BURyYOwx+LJTiIeeRE+Z0DxtHM7fjFkZ06YccGmPotwRlOtJuVmUm0G5aVsOeLYa5U6i3AkpdxzljqHcnC0HHNwzKHca5eal3CmUi1AutOWAffYcyp1DuWel3FmU66PcM7YccHefR7lLKLcg5S6i3AWUO2/L4Rk6g+hF8T1s1SvxRje4W2m96DgP4npQiZzgh7BL/MV/RtubE3sDXQl+GKK/89tG9I9/24m9wKm0fryq/AdjWFlsOHciNV9BxOn3/iMyB/bV8j8CMYaK3cuKHJ/x4RcxXbysXmRu5dfgsHRZgQnUvayeA7P0ZQWGUAWQh8uKzJwmPcXkOsyEAZP9wWXVZmoNQsTA1gfBZ3hETgqOUkZJ8J0IHP+iY+KrnfjwV51BNjHc+6Ij3+HBrzoMiXXiAykb5ZM0LBDu/NSb//yv/q+//M3fcf1qmu+XZ+vGg6s/UJinvDPH4aOWEvfJiHtL9sQLW9kqbX4pScGeES//Gq+qO8OPxlcTFdxAzLFuYOAywQstxDPr1jCaTGVqTQwwWdXoNKoHX4CzYT34EfggKpycRlNcUkVcKdWjdu7AVR9GnTQK0mg6EerUpm6lUVc3dJBGY4kQsI7p7lBoV1u6oTtp1P3omG7rZho1h4ZmFVTsQtLa1GOJELLWSUXbStPE8K9iK6ybJkLcyliElPsXWScxvcP0B/PyF/Jkn7vJvUHkXFbrZG69rH5A+skq+kHiZL3jrzh5n0FXQkcJPqvztf3B1Y9m7BzjjeD1pbT0WvV4avG2JlIZGmt6MpWJQs08bv7WU5m1MxOkZp7NXC+Ve8e6ar7S+h6X6Cl9VeESW5bHDtKygc8sPS4q3FaijwVpzR3u5SVmR507U7aczsst5uXqUi7Iy/Xzckt5uUDKEVKhnl9X59ddTEVl5det59fV+XWlnC5ct55fV+fXlXL9wnWD/Lr9/LpLqajo/LpBft1+fl0pt1i4bpBft59fV8ottX6l6tbu+w+cP8NHAzQTsdSS4pOno1ekSfJhZA1gG6++42HD575a0rX3I6Wr70eu9t+H1xJh2zIj0GOhXrV6GJXg5NKw/uZX+e+3HmQo/F4B00Q9jNysxK2OOqpVnn2rk6OFg+IS20JKq08XwWVdbh6FLo65KNQKuYDXXip2Ij9LVW0qSZIQKMba+zCFmU6V4wABSBi5P/vGV+2/yve88WcNaMdXK9/K3vV+5JULLGcFbohHhvYSuGR4Pxt139ArPxw14uXlra+6d3T3h6P2Z1gk+CEHRRrxie+K1XvgVrWFm/HJ7/pM2AKAR4wL1N6Lmrr7wziN23GtWN3pqorjtt7snX/zW//PsLHUztNbbWXTv3tVuz+kG7aShm5/5q2Oc1TBhQftqQFnuinJj3ccuLZ+Nt46D/2cVyiV2FI8c1kPdPNT773VUUfVfUSM5H2gaQ43PtGBq6mrvYfvBz/ktEKL19Dqul7Fwfv6oO3lN6DdN2t/fOqFMz80/JlkiLdayGd3luA9s5F75wWqpaXdFvq2idNktJv6wPBzF4cp9VAsGIyDQ6YumYCZYKwlAb/1MkRLRaQ9nW+eYLr7L67g6vkHHzxNwdXzDz54moKr5x988IiC6z1WwfUfUXC9xyq4/iMKrvdYBdd/RMEt5NddfJqCW8ivu/g0BbeQX3fxUQX3G77jPpANcszK8KKU+QnkBxOmAF7QFczplLxfpSsy1ZLZ20/xkcA7+h90GKQUO8F3ieA3gdq8+UVnEPxp6VA7X3Sy0j/cLZTmOqRw8BeOFg5mSqyAeX2+8pNfdOay8v/wa5WPV7/I3f38lC9OFVu7/jvoHvEafx5mhf5c+2u2Y6PYju8JvlY7fny0Hb8087VO+YnRU9aaX+uUz4+esjPxtU75G6On/GTeMOwFPFeZjCvXCKtf56y6r+oRfHAlUk3F9ZcrkzwzJLT3GhC9PV1543d++R/87d/+sf/yCxdeqsD1roIdd0dm4vfUg1LFvq1YavRtja3IiddPnK9UXq6AYO4HTvQrlctsdeXlik/bOGor1tVX9eDnWAu38/+nhlM3fb0uPAdtOGChYwe6bhRXX9HJo4VBOO59Nu59Lq5ci6rYw3GCv+lEDbiX3P2Ex6hW8Sj04+Y3M1TDQ1vruHu6EvpxMIjvvhe1gh/0Q2wmtKDWl+99htfTPhYjde1dVu2W9hBrAuhoXZ3TnkQY0OeQj6pODGbdCD7vH2W7I6+vgpA7Ee3QgxPZZdVDndq7E7ufu6ymMPuABvXwU0d7PV2Hm7SCtbZOtLa+qqANvnza5gmgGDwk2owTnBpcVmTU5m15ZvhhzQ5+KpF/J576UxGxnKvx33//879ewcWqvKyWg43Y+WyE7Y7mJ+fiX0AR3Yh//Rfef+ETc/acT3Xgqj31btQIftCPmroVT70LB1CPrh8ggGM8R8s02RM91ZKWs1gbTW7oJqDnq/HUIKRj5tsdpR3Gn1XjqTuoED//grV6Whx6a7qBYjXdvKw87NBwlat9icRx4qk7WM/GjTvPVSrSBbFTxC7ohY6tpqX90Gm7reDfrbTih9NYUz+25pZ2vCXt4PSWrme9um57NftBJW7jhivoDlWSBJCwAah9kXcnqklcaS12Pxf5uoHP1cWPFyn0k2/CXAjLaZR0P4d56rfgwwkr2jGfNJLgHhX/3TuRE1e+kf7AroYrvXb4qTcwHnial8OmLcCc4TleG9zByl5X0FvuRDWJ2nHoRC8+1vVB6Oga3kJNw9UKUUZYq3na98T5zv0cYqtQY/CjDidDdyLnLfQXuKwHP4oJIO+iwbkD7gvofA4/NoXOCGexyp3IjdXnwC7JbojZHPxrDzGr+8Rc5MA/Vk75FPpM7H42+EHfjyuYDGOnrXInakpbECtVi++9B0/uGu+Tr939bOh/NHPj46Gx337FNdwivOfJMV81vSXDNjfPoCrxSspEWkEv1O2jaOD7rugKngjefVuVek+d+m2sFYxVWn+KLktxP/hZJ4JS8YwScmMPCJke6nE7Tiv2gkrkBr/oazfe/mdO7MNMA18r0yqm6uLKqDLEdQa6Bd+lfdOvf+mi6j54kXadmplB9NX3fRs0I4DHDl3YhE5gQxmPDx548bY7iNoCJcOfvvxo+enJTyA/MGjYCiM33v/xGQnY7THi+cBmNbOHNttndvknZiy8YtPUJVdtvvHhn//r/+l/+N//z9+/hAs148WBbsa9AfZEv1TBNmUl3tkDkH9wEtePl/dgUMA1UfayOsbioYe79iV+xaXJllEMa0oiMfYdicGg6dQ1HtaM3jguW5QnJGA4FFQnFWqGCMNwSgi8MDLxIKcl2OOM7Gg+wzpV2GedKjwrsHHhswLSEp6T6JHnJDTkvGxLXmBVKrwokHjhgrhMhpckxuR5CSB5QfZFX2RNKvwYfg+d8LJA64UvmbiVRYlIuSI7ry/LnuorrFGFr0pQdPiaQPSFr5sgl6sSv7Ik+7Gx7Me+wTtV4TdQPa+4A92iqbahXwEzjMQ/YN0dpPplOP4vYFPmClI3YfdK9CLSALFJ9UtIbjkRAk4vI33gRDOp/hiSiYIJTFYCDf0GNitjGO6XCK2hryI49XWGqr4Gi/2retLaQBv6RZR+AaWfl9KXUFoCWy+i9DfY0oFuwAMZNtSJVD8npc+h9LMsfRal+7Z0Tzf0Myh9BqVPS+kIpUOW1ih90pbWuqFPoPRxlD4mpedQ+ghLz6J0z5buW26FqgSikJvAffPfn/rrH//Sv/e9VxOCIFK6VZJuGelhSXpopBteUbrhiXS/JN030sQvShNf26GcoVccXuNdhVdd5bfNICqMS75J1elmTTZcxhH7WPbAzZo7igwS9rHCgZs1mHuzEGAfiyd4WieRhBpvUabpap1EUxJifEBhn87WyUd9Rrov+xi9rZOP+k7WBRj0LA1ZNLHKhJFKTLCxXGebWCzy0WipcV3pmbzfMWQ6MGHQ4yay2VaT2Gp2smqWlalmI6smkGp6ppprppp7WTXrtprdrJoVW81mVk1PqtGmGhuAvexk9WzYevayelZtPVtZPVrq6Zt6bph6VvJ6Nm09+1k9a7ae7ayePjoNFAAWlVmynieDPOmRwcohsAx7TCPrMSAtGiIZRB0jnGI3Gn4HQ3UagmThAyrGNTFthPYdald3jMAbyAkO6C+48v39lez9vkvq33dJQGFL0JMt6ZuSngTjsWQ39j8RjukuPvluXH2bJ3fj6ruR3O7Ta/g05htqSY/FD74ToVAdRjPuqijQwRB/vkMke49I9h+RHDwiOXxEsuyWJfJeAx355ys79DYThR1IoPauSqOAX380gZ91FY1j2w0N0hPg8EvlwFI0jp8NFU3pKWme5olBNJMO9TioAVMpcy+aws+miqb1tLRbivaiyXSoWd21qJcOBW8kleIbTjTNMUZFs9jQw83JaTo6Yk+7Hs3xYj5x146lQ2x3oAqeuu9Es/jdVtFx7PXhaUgV/eiEreJGdNJWseJEmq3wCYE7ng71LHaTU2zE4MZZkEkcO4Z71FoE8AQCgNFQz1F8UsTT6VDP0E2ICCv6CA+ekIMz8FKa1JN4MdN6OktP6aksDbcTm57QE1maL9Wk2wjAAULUlABHTQue1IzwIBEdqo3gHGy4xxs+wuibsbDh0MC06cvvlvndNb975ncDvwUL47qR74zIt0fy+767FPwlR9fjbcQhYewIOYT0wimOD0A2JvH9HMHD/PAYQcz88DgBxnxAGJ9zt/3wBCHNfOAYn3M3/fAkUc98YCCfc/f9kJY/XccUJk5+rcItwongR5xoMjfcTw6j8YSejEpPBF9wSk5TMwVfqI+6bRKF9IlUetx4kq0j89ETXcZveMVdYzUjZ11xD32eMzG84q6gxCQ8mCavuKvMXHEPzMbrgUd4kv4g8i6rf8rMZfWPPdkZ8weX1X4hvSfpzergslqv5ekfkPRqDRtskt7zsMMm6XXI17AwWKthh40X/j45doB6Vwp1fW9Bvlyoa72Qfsz1eO7jrgeTCS3NtJp4EsXl9dU1E7fM4CyGLku4lZsbmX2J78rK6bzcYl6uLuWCvFw/L7eUlwukXMWERdvr6vy61sicX7eXX1fn17VG5vy6vfy6Or+uNTLn113Ir7uYX9camfPrLuTXXcyva43M+XUX8usu5tc1RmbpNfLO4u0Kqb244V6nk4anj+pAn0SA9xH4RzBEPDqKB+XpU3Cuw6ETOEQ4u+jUFZqp5vWcZnj5FGbFxO6M5sWDdJNeo+s+tvYFM7GK5ylQiYS0FXTEKp4KkztEmkQUd1Q3SMY0oW/eBEo295K39iqyoFyT/LbNJ665pKwb4U5gr7nuShoX3TBpXHXTpHHZLTcPEot3XC7cMQzalXsdK3dXVu514aD87zpa/BjiLTf4a068GHwXPbGDn3PyhoFoyDaaOO71gfi6b940LYW1e/vQMSusSrxvZDsiG4ds+Usi2xXZhJ0Ve3pKB+DPkHMQhV+JD2wGDrArcqad/3p6kifsFU84LJ6wWjwBvH0/IP2EOwem3efc1W8bZhs6W7iTtV/lacNs+2Yb0iST9uCk0s1rAoahK1UAvtCT84Bc6MnODqDKPDroxP/7nJz33YgCiw+/UoF53MTd736lMiDaBHeD4h2bDaR32KzYscW2ocS2IZsoMJD/xWnbLif+ixO6RhNH8N0AAYhXxIDxoTS1Fm9k+YD53SzfY3758zaPlr8fmJbHuxV0qTosZnXTpTzpUnV0KQ8HPFjkNn5iRt5sLd60xpM6s1s2GzC78xOZHYYn7uJEzUN7P5EZYZA9yI0wyB7a7KKcuPz5GRJzx+/3tBc38l4cL5o2qye1WUkNhz+dtXn5C6U2r3yh1ObVLxTbHK99IbMdOXEK+Ei/8A3hcSZ5dU78V6Unmo2qWrxePPi/zZYPbhQP/u3JwsGCP0m8KaWGUuwvtx9XrBBmEu98YcbszaD8/zhVvuZe8ZrJXH6wFu9/YWYAg5zHgv9UqtmUXuT9lO1dB/nzQfaw+Hz+QtP0Je3EX5kVGx677PfjwB4zNNOFdej3n3Wi2lsdl4TDhTdXM2/O5f5DhvbvAWHlmry1OtH2AkndkHdVJ9q/ltRt6Vh1ov0vaCf+vkB7cS1/dcFfckIPf/BK19vUfacQwSBzMEBVxXsinmcAcTucYwjst4dTqHa3HR4DI4gUOY4oB3PmtK7H+23DY+HFm5I8gYiHX7P6th4ftA29hRdvSfIktLApMaHr8WHbkGV48bYkNdSFKTGu6/FyxzBrePGOlAihX0yJo7oer0iJKNbmM/HKn0kt+0zgHR3po8Mo0kd1OIyO6qM6ujUXHdUzmMfP6HGth1xRzdyai8axHBhGR/QEHJkn9IQ+cmsumoBhaRj19KQ+wSm+7t2aiyaxFBlGs3paHx9yITV7ay6a1vNYB8zrQJ/iGk/P35qLAozSw+iUntJzQ67PTt2aizCATL0T1edYbvpW5Epq8lbkS2riFnbekBq/FTUkdfRW1ORH4GWhS5nLnElM2USwlHFGZpHGBY+2Oe3OaX8OW26NOd2cE2v8Lze1Fyt8OlYbxKvcEpYxKDUbxDL+pHGS5bZvpklidpHNZ/2bE8XPtNJXK98Wed599M1frOCr/KmcGa0lp/zZmcIp8UaNln1a6xWs9Sq31n89hH9atg8Wvh7bB0wZwlZsJHiFjYS/4CnnQYs09I6J1cd0o25gpI3DlSo4XNGRsfZ+5MPBCt3cJ0tpvZB5aPkqbapmU0CBLgHpgNnU+zCN/IfE5PAfMljLfxhWGeXMyQ+9R0zk0vLvWongPVTilUxi4R4aWNOBazNzDj24qhtYBPrDqKHraYToq6hrEB0QFBY1yTcatQyIRFO3hgIUUdMN1NQEQaiHc72hoD50dWdo4CV0y+BF+CxeozvlEvOIPzP4Er6w3BisnsvqHiBWf9e5rD5rE++Cnemyuis/AHqwnpTAgXAuqz+OI+JneYPJfSS/lUlullzXLgPkPiuuP/CXx++y+b0nP3fl57b83MSmDV0ff85V3n31IHa4pcl5p6e9IRzPYF2gA57SqigIRgW9UYEeFfRHBQujgmsj3O8w79jv9eDBO0a2CFgjc8aSOTuuIrzRFv0quKHc7MRPE5HJ/ZO0dRUugX3DAteUU3CqewefXE3iAZerUS2uE8uBeFOX1XKVyb2KbJkTEohPCZ1IwtzQQ5ji98cUCZOZ6osF1jGEyWB+XhxEDqevi7oKEgPHIKxVkQpecq9JqveSex2pvtKX1Q3gLrV0tfV3fefSfYlZF7/pNRO+sOeY8AVHwhfuSvRCxfB2SuzCroldSEzswr6JXdgwsQv3DNumRC4sSeDCnpLAhXUlgQsHI4ELyyZwIZC4hWsStrCvJGxhQ0nYwqEJW9gyYQsrjsQt9CRu4brELRwoCVzYVBK5sKwkdGHbkdiFVUeCF7QEL9yQ4IVDJdELW0rCF1aUxC9wO05CKC5JkMPzEhzxgjZK0DVuXNSDJHC9LQD5QeRLEIZke1FVYjkkqyOheleS7UdCum6yC1FDosTTxLBW6OdT7ekX0kT7+hJZpBZIVHWRYX8X0kQ3EFRj+C4QmuMxBMdHyI6uMnynpvss/QxLn0kNzQPwl7SnT7P0KZaOWDpkac3SJ1Pjfwh4J+0hsEf75OaqkqerRtxZwd9vwBRgyLCw8+WRvcvnVphl4Zpk6QmWHrcu8S5iFD0CzfoE3K+SiAskW4bYCz4k1I6tz1QyZ0gLD2hdHwUeMPd+FHjAQPI9iUrOnCm1RCXLoyA9AKOSDRcgbC+MSr7iLrS2m85xsigvu8ICvK2E/HcLu8oV9poeV8FKeBuWVXiU5RyZx+44wi+8i/4uEC9TQkaKySz75riQfAoxMQN4SIQqkDDXhI75uvAp3xCO5JtChHxb6I+XhJ+5LlTOgVAx94SiWQugTF+olBeEHhnI5U5cga3ixxyJ0K9kztJwJ7Ye0e6HkRLixqBAFIiQfZVGKiUrGxZnnZThbUi2IJVkLSWvA6MHxLEeSS/lCrOIdSIXrQoDhJsO4XXBcH31IQhHrmmn5FytMO5W9ZgEuaL8WMoNVHigdCW0FdJuyvA0SOEy1BJpO2VQJAPBObZT2kBZh1KfwzmlvkQAOCVmWrQW9Oh1U4ok4lqx2R6b7bHZgE3K2+09lJlHU5/QddNuCdDlmSmtWo5u6gldNzfAD4KHEcOwo3h4nB+FOdyWwwh2WJXDx02gNw835DDuYsfcxVbxLup6imEuLN4wxeV2vHQY4RaboDX/kPH4pdupP4xAqBdNITjK3k7D3A6mN6aKlNY5BGpNkmLPlOvachNSDqEZu4rl5nTN3mDD3CCiV6UcutSaMi9EFW6loY/qlj2vbc8bN+fJXdbxLPBY3pmLGh+C3yZRxXtqPIwa2sc9HdEte09te0/j5p7gE2bqSmlqRKN7CJexJ3TtCRP2hEk5Aa3fM63fKra+pWd1x1bQtRVM2AomTQVyGw10Yt3S7VtzUetDQCnsl26j9TBq4QHM6I69ia69iQl7E5PmJjDPlirRuHXXPFq30LiOntaBrWnM1lS1NTVtTb6pSVrZSoeYhunOO3MfwtTa+mkfOCEud4vgfaVkQs3ANHKTxnW4urnF7aFrhflXfoNOXL8TOXMaCiggzsBjfWerb0uRwkyvdNw3xxefcNwzxxeecNw1x/tPOK7Mcf2E4445jsUEnNWgiOOpuFeYZd6aw5JU0ClT0OSsOYQ7hKehdgSnsk0XPPgbakdmnE5eHqsQGSBT4ZJzzfiYCpGca4bHVFjkXDM6psIf55rBMRXyOJfzTg6PqVDyscD1DwXHzokX461KufWmJYoth4WQPpKOYcgUj/+qdffXNeOWXxeffIz8EgXUtCFPybBl2bGCAvpOiCGLyCdOXPsm737eVwrPBVvISqsEA4hbgNe5/nqKR3q+8t8uzZVa7+v/m713j6/jqu7FZ++ZOQ/NOdLRyz6S/NgzthM5jhMBwY9AIo1qO3ZCSODSNvTX+2logF9+R25rGTd1b51IIQEEJFQJpCgukHOOCwhKqHg1gmKskKSIt0pDEY+2gqZgHgVBW6oGiK+/a615nCM70Pb2/vWzP/bZs2fv2e+11157rfXVhMrr/dDR9pjCWXioQkdhq1/PDUH5ltyB0DlhmFhzW3h76ZqyzHHi7WUs+uNhGIhHYJd0fiSEG4CArAd+fBesCifBbkLaJI7RpdeRjU06TXOK15MKJmpXtASKiQ5ltGzp1o08rPPBjNcy+fmlc1n0PK4Eyqg/jgKuFZ3M4jRaEJWSJHBkI1BqcSq7njgVmrmy/lLyKaQut+aH2MzE3UsK0fA1XbqNonx43zMuRRm3b4fORS7+5oZIp5PMigmuQx2skNBzQkWe6SnVflLctEKrdBdmjMJ7Gbn/w+O2zR76PzRotMg2W94/Z1SOodpxYb2wqZLigDCakd1PmCEvvpogVkXKA4RVEfMAYFXkPJOKG6AZptJwEOgp/RwESOUAB2fUbnsXTvqsraxCe9TPh8w2qpHQhsNDFR4bBYsKk1x4FZzLVgiswo2gb8g3p0ifXIaDyjI2QCqydK7I8uGm7HboMBKOA1/jAjuQJ0dIUvz5ip7Lsu9lm3zyBhmT58zWdmt+M3lk1tutD5OWSxZ+E0mTKQuXvedovnueLgjnuyvkEyhDPoFs7hCG6Qlzh8njDKLV4SAXvcvRu0r8Tq96l+Szz5NPuiWDbsmku4WWhlRjvjupSpRNMfYWOVWOOoRW42ZQDeqIveRSk84J+4vie9uhjkB/XEeSyMYJgE6A6HIWvo8FBykZEaBZrJoMmXNNhsy5JkMq+3knA9OHaEJgLDKiX0aVAzZPBQKI2CG3HZEL7gPva1ndynR+XI2QqIvIRZCjeUCnFod9V8d0h1x5gXDoISOXxEBTg38oBK+ifnqKDBUJggTTNItrVyAcoddOk3N9zV7exbk2b+z0WUoMNblYQ67pPfBA4AOrEUiN5jO8deG7Oi6NiuOP6ErktjuCXhHH6txY3LyPkrFmDqhwhRT8VQ7wV6T0B0HscyuEnuJS71BvkxKprGhyxl/nmmbIpL9iSnyi1GjSL5S2ESuOPWgbz0kXaBPyC2oj+hTn+hCqrsFj5kI94hdD+BDIkSlKwbTAGkGN+q2cwwna0GwabfaeaVpM8SpCjxHwryzpURB4FbKgaqQq2zCyrrEjyPvYGztGUrIIWIE48k+lklHNosnZaFRbnaFoQDm7eG+PSkQPROObDG4LZnqLaQvt59NX4vEVosatK/CazmFNYxtesiu+La0kbQp1sCKdKc6/dgsbD6rmpt67ze/1z3lvP817oL9QPzjoB6eJwp27WpNuBFMjgAGyuv9JK3fM8JaBfP16ya6EK1eISRcl1rLiHRj2cC+4sLwRUjZLqArwjxdk+EELvAV84kIge+7rFQqZeNPtj/fcgXjL3RVz2Dq5iqU3+5m91nQVez2HbmCn0JquYm/k0M3sAlrTVewhEzEFRxOmgNw8C1dAzp31VntS7WSXznqrPaV2siNnvdWuqp1gtCk8rXaCRaHwjKLzWyawub9kTIjwjezQc+S8uXSX8n7codvG8sI0w9KEDfzYfqB9t70yiFuboRFRJRV/eXNWhVVEO8VVnkSUAWlJXvIkwsBhGznIk4h+8eYWTkvEAJBXhVcPNLGMyYEh0ezzO5NgVxLsTsENJ8G19pDpMGxSXmGIJZingQlzw6Ue1pYhp+3txg0Xowg4bkfEQhQB5+2ImI8i4MAdEXNRBJy4I2I2ioAjd0TMRBFl00MR01FEjxgZsMkSREmYUy1QKhyAtzg2xOlm85w1bLSzFhO1xRDD22J6mKtsKb2WxADTQyzjrA6xzHNqiGWgk0Miwxxi2eb4EMsuVwb9do8RXGaGWPhCMoxOMoOA0ip0xiASXgMZ8VqGJ3ugutueJV4+8uDx3FCVXqMC93Lr00MGJ4NkAHpg46PpQpJ9eMNAfW4ocCNWDaMv1uqFgMS4uLSgWSKC4/4ari9oIkmMqeEig+aaxJRruNOg6SgxpRquNzBhJSJX44uOlUGWRvtlQiObVSBIYBJyBHYzK4i9464hMfSyjYaTyhNENKTwVCdQFVJ4gmYdqTsRrAp4dfJtBE7dofMvJSMHnZNunRxvgvXI7I3AKgtEzjPMemQi1sMSgLOcaadaxRtUlncUh/dNqr0j7EU7w+20Czzl+dPIZpUPaTe3mCAUUCPklh0rKjXeovhDaTZEOHRXgPtoQF20ySKbXgGnBZfHxry3jRKfCVM/sCE5aaPDBYKWgufLNZRGsCN1rnfWSPXBiJwvvU7Sa07voLlO1NyM0D+nqWCV5kfO+zE0g1gSFyxJm3HJZ3erKYL3UKM+i7eMBXPeEQagoXZqUzRtzFzexmOej9gRhysQCDAShEqp0eZBzMWMBo+sZBF4lwiqNNfMjkiTC9zkUsKOcHYB/4xKTLEjuWSQi9iaiyCgzI7E42zzLOXWtTI74oIdKUB+Y/MBKy9OV2lVZaP9UgBcsoS3TXyDw3xJlhNmOGE2SphpTKh/0YT2L5JQWJZ86KT6yhITU655OOlWpNOT2jtpf6u+FtXXaDlFcgr8DPBPP/8Y/inzT4l/cvzDRyLqYvVf3/uSYJm2QSEFyVaI4xG2Qt28FermrVA3b4W6eSvUzVuhbt4KdfNWqNNboZxpmJjYvBXavBXavBXavBXavBXavBXaRmQ/2ApJtPqf63igE9rYRkm+MzPEO0VAeyJueYfi4AQHBTM8iZ+SeLpQTqKno+TRvmmHMxo6GqaFJUfvdbQ7ljlGkk94FBjPAOib5GWErOEQz7vdsop8viaRMWzOEhwI1q6wRYtqZVBQRmmnZ/wU3v3FpIzvP4cEcpT4hLqAjhLzIAaDxFCQUjhpsg8FBVwxQUE9KMKZGXwvtNzUF7Q0VqPF5B8gRa8huAospNw5Qj/t/kioOHRF/WWUugX3Wp7J11lFhDWkVmlwLp8ydh9vcPkTvmeoo6AsIfMmI8LDfl3GBWy/7qJjrhN1ItmGp3rSYuqPA8UgrYZ8dKoLWmrkaYpoalCAPzgoSuVxsdbYUljktKRc/FL7uOlNrcTVY5A3njQx8/RNzPteDK/KmvQpvCrvM7bKj4maVyaSbacFrEJtbRBhcgdE1oPwNjAmvqFXi1sj0QkTdzlO0vdwWCu9EofOOFHghHo/i05GAtoIsrQRKJKh6JHUXpAXUYMO7QrtSlQDuKqJT6kQbNPJUomAZkbdBMfuDhmgnSu66pwzetFtivZj4u6CuMeis+xegVVLKnGOKlDuNGXPRienKNVkonv08iJLrO9QfGx6dIj0ih6Nu/VqyUvdeSeYK9bUepfWzph3DNA4cfdmolEQ3hiqBBFDTOJLYYWhKhAxwdAziNhf6A4I48t6B7NDrHiwMuiXBJBpVvAGV5yAXHwv22KCumILZvC4Q6DBZI7qCGjwpEMKHrBBJefSNg1Gnhldmxhdu6Ff3g6e836oAoZqH6sbZo2qv2y0qMjY1sH1ZLYK1/3Ee/a9nGYOCToz+4q6oDyCvPWM4325TWfHdhOhzAV6L8lzywyaSEJOw8BSUJgiu0/uIRUOMCgw8SW7BMeuSDceQU66SHzwW+yMfJdPaOuH/A4Ws/vE2C9BEUSTKhbx/guanZXn2KRtiC3cjrJh24xig7bTcOeqSRXLJ0M47QfsRZIOF/v9TXzW9zeTwQt8FWjSvbqAioZ+lCbdrH72/E/Wcdf7W1kq4F9EpjHwWaBJ9+pivmzwt1PZ0JMi2IBeEkH4l/K1gk/qMvPQltKk//JMKlv7z6KytX8ZYw6QBd+N/rP5BsLfQY2GFwNNWjS7qGzt76aytX85a4e1MW4Bmf3d7D+H7yz851Lj4dVAk+rNlVQF7dNZbNz2h4wSNUdl1mFOPAfaDc9lZOoroCdwJSkYDeLSfYg8pFeDdaKj0ocMz0aGHZxhJzLsogy7keFyydAH6Qqcy7bVzaVIP8Dpn4H0z6T0z0L6yyR9L+QyyvQg/Vakv4jTb0P6iyn9dqS/RNL3QKKjTBnpNyH9Zk6/BekvoPQXIn2/pC9DFqTMWqRfj/QbOP1GpDeU3kf6QNKvhRRJmRLStyN9B6fvRPouSt+N9GskfR7yJ8U3yAzsbcEWjLh+WIKxALSH8a1JOSwrKOWE2bqODYkmVRvkyuxYji/9FauQgi5ljuDcMO6MyGGphcvMs69OCHVviB5LdJS6MXos1yFFujl6NHXIkA5Fj/11SJCORo8DdciPaLgZIKMO8dEEXdHxFFors3m9rKgNjCSwUaap4UXqy4qhVThh84InnTAt2oq0pDfL/NzCq/QCWTG0Gidtpg+TsionFS/LEi/LBc3L8npelQuyKqdsJidTsjqnFK/OMq/ORc3L8wZenYuyOqs2E5+qrNKq4lVqeJEu6YZVuiSrdNpmUjWtebVOK16t/bxYT2Ox0vJcJzSKlumMzYRtRvNynZHlOsCrdVlW6yF/SGhUiHkgF8c0KLO2XDa3MEWR62mPaZu4+yzw8FWrcg1dZPrBYEJBK1MyuegmYnI0ceUJpBsed5oH3dA0eC48gV8BZ9RX0keLZhA4BSE8Sg81ZU2mUBey7kTWXci6W7JejqzPQdZ1TVnjydhJ3umR81nIeZnk7EPOHcj57Kac8azuQM7tyHkJcvZKzkuR8xnIOdCUM14e7cjZz37S2Xs95bwIOS9Gzm1NOeN1ViL//Mi5CTk3S84tdXIgb9rMBU054wW7FjnXI+cG5NwoOQ1yBsjpN+XEyvdIqa2lTgpI1USkSESqs04ixSrJFEmkKPTF+0FW6zF1TDQgAk2Oq6xYVideJ3XsEZeVd8X7rI6991ZZbVc8ROrYKy3r6yZKwLEHXRQfybWj2xktDh65wP2pAq9PCrwhXeCNSYE3pwo8lBR4NF1gJDdPFTiukhInVKpIVjfgMqdUutCqSkqdVqliZ1RS7qxqLniyseC5VMHz6YIXUgUvNhS8lCr4dLrg5VTBK6sKnmpqsU61WKdbrFMt1g0t1qkW63SLdarFurngalOLUwXPpwteSBW82FDwUqrg0+mCl1MFrzQVTJtSqo12uo12qo12QxvtVBvtdBtTOuyzdlwU3f3hmBAoX5O6ilGxGCA9uXWsd22lp6CO1a+t9ATRsRa2lR4+HStjW+nO1bFONkeD5fZVVDHahR2P3ZNaxiHN8O87Wo/ljrEumQXSGtlbjKvY4GJCxRYXkyo2uZhSsc1FVcVGF7wEdhE0lE2FzEBDOU8ivkxoPUfNanKI50ZH5QypZkCBwQK098KmCt/N5kgklo201uvgiVhhnfkjVlanaNZTJ024SEmd4lk/nZOzbjpF74p3vnqEeB7kxKUhDtBRCwiv4fw4SiW2+cixzQfOLHGb8tIqwVVONWZXvSaAyKgToWV7/NBfrwkgMhpRrwkgMppXrwkgMppdrwkgMvqjXhNA5Cxjb5caW5P0PJCHp/HryXAVZASLMqitMs5tMvQlngwl6fy2qOdbpduLcZ8XpMO9qLdbpKvzCYfBE8Hz3l3QrXy5CbFJYbPF2ow089xk5rnJzHOTmecmM89NZp6bzDxXdMtmECRNpdC6Km2KdDjIXG59WJsM3QCQg0McwaHoAzEUtHw8Eu7BN6L9AGBVSNJ+uYVZC+V+Ou3M6ERrRUbcJZl2AN8JJpOaxVka+EyyeWZSm2cm2Twz6c0zk2yemdTmmUk2z0x686RZDAOq5KqfRJTGLd2t2E0Qez8nVz58kcg+eeg6kR3P8aUiHqZUUAarAu9FKughMxX4K1Kwua2LA6E+WLJUq/DjjU6AGMqNFMJIZEbKXy301j5At090RiDVL6iQKO55UTciPd5sWD5MK4YuPDMwu256zjU+Jw92lSpD4B2+inSciolWDw2R4iU5q6JMrJWGHAwzH2lFucYmwgVJ1rrY/1v9pkDRTCA42AJsW3Fjg1nDvUDSIlKQaw+V3yq6XNHqF/Vi3gC6WUBdwgAQjV8rkmyDric63sNJBtDpGOqox5letlEFKn6HHjLtqE8rOrwUsiffXEOnt6LTO0VnpShVinTPIAiiqQuNMY9dbBH2XZ4dbcHYNAMVM37XEJtbFSujAsLDEU0jU8TIFE2nXIXxyHD5ca2oWuzqK1PhE0t6qKCYE7SYEn+iA+hN8YKz64HNCnBt0GCxE0tXoYvOPvIzpip+K89kv48nt9/LE97v4TXgl3lh+Gt5rfhreP345P/qqK8Zwo/nQcNas4FJw2sNwWitRdGTEh2ttSi+mko+nUTPRMl/3lqja9xzr7eW9HoLLborbV5zgooQr7n4Odf4nDw0jayFkbWiFZRbveYk06o1l2tYc54piEj2Qa3tMU17hS1QOyIwJx2j6Z5KdK0gOsnkjWRFk8MqFUtWl22ysdIsVCXLJs1yVbIN0ixYJTMa1m93yNhEs3SVjEQ0C1gJogzXjzPQlA3ndIUkto5IXFWsq+ykKkCJm5NBYVmnJNjLkQ33od1A/iNeOsJeJULkULbbVaSalbo40OG4je6acnTLWP6Y+FxtEy+qJXGQ2i4+TzvEjWmneHLtEt+s3extFSb7sqO1wSF0xMO0krAaVMxhHgZcRyv5WyKuo50fwMO0mw5+AA+Da0x6AA+DK0x6AA+D60t6AA+Dq0t6AA+zJhI8iwdhGzwJXQuUdrM6VftuVrHq2M1qV527WRWrS9SzukVla81u+yjj1c9vxmLRRKKhqAxtUtL6IP0K0g4gbZBETSILBQFsVLg+9yIVlSDP91UuKFBLdEVP9wkxPW3h+yvWAIDzw9xhpBedxRwTtpZKSpWA9CI8KAl40Z5VYNgQ1jGhkkVNsqE8XEoyrRQtAXABfjbSCOEO9P45p9vGirSQWAPIWLx3LVkC6ql4IyUj3Y4q65B1NrgVgOs8NjvpiDjBzhMQAcFjQAk3f9AEKrG4nxLhoZVulU0na93jlqCN0pUrQSlOV64E7Q3pElNTtrrFLUImsTeVI89Ahc2CmbGXyF0VNg5mFl8ih0ZgIhyKBhL/RritFsYLdtQkZJDYBQsjARMdEjdI7KJVCYj/v4EkDxK7ZGE/g50ziSDYG8Gw6DaikaaNOrcWdBzfzQ5d4WDFZU8s0YU4pjIuO7vhn6Rjty1IcJIAUwG5S5RiDaXolzgoPy7R1Su7tWJd2TmiEh2xa4SfQuV3mWYR+awlfwgrin8X5HdeJd4QplPhP+FwhDaF8IxiuCmEI7gpm+Cm/lCxyIhcre2nqhojCjK4La+x/qFo2cDXao31DXM8teEQtwaJPNZOXmJurgWkYidrDv5ma7gVADKYJzFHa0Efu2UsSMy4qoFbt2AiKFETqhasbxgiTD24dOmi0WllVzjxsHTxsGzAsJAOBEmlu5Jh6ZRh6SKHkzwsncfZLxQtp07W2u5MD8X/nUHo4BHg/u/mzueuX8v9zr1e5i7nDu/h3ua+7uWO5m7u4z7mHl4n3cudu156liiQHY6TWsUE236tgsUhR7TsCEP16zJB5NTJ74KYtzGKeV2oDT0N1BuRciS/RSlSuUxDrl31RtycJFepIVd/Q66heiOKTpJLrL4aamgaaphg6jTXsNxQQ9NQwwRhp7mG5YYamoYaJng7zTUcaKjhroYaJug7zTUcaKjhroYaJlg8zTUcaKjhroYaRsg8T+lzwCNZApS+//+Hfvvvhn57UCn7GDu3d9hdfYwbbhnFOy6r4+c4lNtJDiA0+Ucps0+bfv4Z4J9d/LOff67nnxtoq40tqvuHTgSKjJuhQ0CuB1hSQUgj5LMgcKoCLQg9QXptvC9pnT+mbzOiNwAddj9Hyu5+gRTY/TyprfstpPAOJQujxJoAzl0gjttK7nAtnCgI4Zgb1CYthOMiO+WXoRZkxGFHGoA7YzTcHulUVLYWtLKzi+zZ2sL0F8jkWfaH0Rp5H2n4SBXn0Ru4Kru4g7TJMO9gMkbXGIHcob4+yqEcORRCiH0KQUY3B4reIji/eQE9bxFc9YLY9uYE5Dgv8NA5Afj1wA97Hyordyxcukdvt6y9ztAmK6yWRgJrsxWujGvWehy/XRNkTDiBQLjSUnpQ+U5YvUveT93V4IXYCqejNzNRYC4KzDannY/eLESB+XsksNicdiF+c49Oo1xQXcOPrgs7Su93edpNye8kft/6wXu++s8/+evvDO6Eq35r+OuP3fedpQ9OPX5qbCfOXtbw7bMf+OFjr3pk5mwp43he/NHCY9/73A8eGtxpr0CGf3or9foy2fJw+DTCixxeQniBw4sIz3N4AeE5Ds/TXYALL6qTbiWxw/9f1ut/+uTXO8n/JiBmw3mnUrpXHEnNOfw7K78z+H30B6/9wMn3Tf85HEPj+V0LX33zt6e+8jm0poqIf33d9/5y5YnvfxARUyh26iKqwiTCkxyeQHiCw+MIj3N4hczQpLkIL0tzKUxOYGecSoT6d2rPX/z1Wy982weewEXGFFX/tJ1Uf8k21vBf//Fr77j9T9/wHdQGMNnkyBq/d83+++I35x9exAsg1Q9/6SvfvfPbx1/9hcGdQGqwhh9/2xce/uqHXv+5wZ24VLHCea7iDMJzHAa+djjLYSCIhzMcBhx9OC3NRrgqzab0OfJla8fNGNzzN0u3/vIlj+cxCrMAdSGf7VEzxqXWAO2WafeJrwzuJGjy4W++//N3fu8tr0ElAVw//LOffGH54W++928Hd0JeYA2/65uvfv+9Jz73RWo+PKeucE0WEF7mMFC/w9McBq55uMThWfLDKq0mJ6zSaoTHW1DPZZ1qxb9/5VnX6A8W0IpFjbfTOmlFFbV58mfv+odPf/9Pvje4kyDF49agdkBOH1757Dse+Iu57/4VLQ1EPPjTN43f9fmHMSjjeH7sW19+1cRX3vYoEqzQNdI2niwIVzkMVPJwisPAXQ8nOQzI+3CCwwsIj3N4ntz6erQ2dGpyve3Nr7v799/6z5hcK4rWhkqtDfmdlV/QvuGHH3j3Iz87+Y2Po3YggsNvf9W7H3/yTz/yl7Q4EHHmiamPTf3k/V8aJOMsK1zkKoAyhgscnqDqcBgu3cI5Dh/F7ODgIUy1bREpDieLtDBUaiw+9MhvvPHZ736SFgbV/bSV1P3GeG8c/sgb3zc584+1rw7yjvmGf5+bf+yD3/jSIO+jX/7zv16Z/auvzKL6Q6n2DdJuG05cTFWArfw4B/vRV1wxnJGXt4kLXys8vU3c91rh0rZoYw8XWyt8tE1q/kTtB7/9std+a5AOziQUKN2rSNQxrw5CmbMilEwlBnsqnLod6qO0YREWoTzm+LFKj4DaEwfZKjxNUWRyR0DTkuFmzrAij4f4cfyV/HiUHyfoERLB6HtkP2ezQm44EW0l4/H+c48ePv6BbwKc7XHaSmabI2aaI6aTiK9RRLU5Yqo5YrI5YuIePTx78k1fe9vr3vt5ihhvjliZbIpYnmyqx+nmiKXmiMXmiIVJPfy9E1//179afnKBN9nmiLnmiNnJpqrPNEdMN0dUmyOmJvUwP3/my9wfzRETzRHjyTee4P74w6aI5eaI080RS38YsQkLn5hj9mBVzMKqmPlVMXOrYmZXxcysipmOY8bfxDHVVTFTq2Im45jld3PMxKqY8VUxK29ojlmOY8aPc8zpVTFLScybpX/imDmpz0KS5l7pnyTmD6V/Vn1n9g16mObQ9OwrpX9WxUyviqm+QQ/LHBiX/lkVM7kqZmJVzPgb9PDJP/+bJz/8oU/fIf1ztx5+1Zc+8fHvnrj9NdI/dzenOX23Hv7Ua17/neOf/TfiPKxwaVWaxbv18Kt/uPjer91991O8oFYlmU/FEAc6d3e8oub5u7PNSWbu1sOvfftPXv2xr//JnRQx3ZyimiqYPzLVnGTybj089ZXJ+odOzf8Lr6kk4qe8pu4Wordylx7+wiOf+fdP/Nmf3055lyNyePqu5CPSCdGrybv0MO1Ir//y3zK4cVgtVTZbOCLAqYXlgdn2eqzwjtt1BASJKPF0630dyiMFyJUXsixXthneU5f+SLGwaz5L2vxVj9A4Hs2SrGoiUwn0Dg0XI7Ay+Sh+9Q49y28XgHsxkwq/h8NTWcbMQHg2y5gZJAUTzAw7rGYZ7d5mOIIyBxcz4rpxm72UEZ+P2+zTGTmubbOXM/HRDFdEGT6bQcAlBzxIt7J8TsPlSXY3S4CBDIjLlYxPdjmzGT8vly0epcv4BbqEyfhFApvK+K1yCdPGX2JdmQkgViMeOOzhJN2jwk5umz1DMVMcQxY/85m66AbiPOuxJzs4fjQtomrssTPHNvZPloMbIXIDWa3C4ZnFpjg8Tk5YZqdXJT/L4mYWsrDmy7TyXXFWmiErHeDZafZEChXDCfilytBFizYu9DdwXe6RQVKdPAfCYAfXEocMnEDk4biqZLJwmFaDPiXUguBczrTg+cZGQxs7XIC/aO+HrrbH1tMUE2/KadsxE1uZhUMjItCNbMpSx8lcYoWWiu1vcpmWoMu3J8GuJFgmQ0Q3BbjTwoA7HgPuFOi+hmFnHlUytVk4m6vs0HNJcDZaHBy1APHuTCr8Hg5PqUQEPKsSEfBMJAIOqwoT3mZhbFBkUz2SxUJOMcQPkypoI08IrGhMEIzrGS4xxzCOG/juL8/IhhsxkNG9X7b0EYy/DSfMEJtkMbQb67XAsEFg1tBgb6jXAOsD4fc6DOp6k6nXgoDNBLOARMnAOgWK8OwCegNicvUq/KVBfL4eudadna1V+FfL0W1jmSBVirvZy1MP7PLr7F+wwIZ8uBOAi/1eWOfjVRdedUYmA/DD32fK0IJdC8X8NVDMZ+sD2Oq2kTDFgdyGhCluOG9Ria3kE5NKHsev2Y3zoANoIrr/DehO2IGUZQm/Obo7drAYFjR/eNI2bX67MX7J5P0O0+p3Gh9u+f1uU/TXmMBfazJQMKB7zmTK07X3hzbq0tgWTPmlNSNBdjNUe6ZKEVklgMnywcDjWFLrK7He+yx0GLLhcmvFeBVW9raCPlZFDdaLgmqwgb3vbqyTm1fP9GAsek1fndzAemYj1E3Wmx6+m+SLRKlhNuyv+B2EhkDKLYk1nL8+CW5IghtT/geSYG8S7LOHjIfmZFLNmVai/67YsGcWOhjcroyoMW7me5gt8BWdpWh48LQT9xJlsXPor+K6B54aNpiy2VIPtlaDDeyzYaMpm8314OJqsJH1p2YyXICBMk6w2fTRVIG8uGzW1IMtplemFSK668GFpqfK11JA/fUL3AS/DSOnRwKXldsAAR1ophr5bfYhXH8tgo6cVpWg0+S32uNqJ+nc4HquCxETHIHgUTpWu3QozuPyh09BfgkOuAgUky4UG+whN1nhpGJkcBfmlu2GoQXpUoe24iIbPhUhRV2HnyHf4CfnX4Af41+En13+NtPON2d5TJnuOh7KeAASHR4G8FAOSHepJZzwKkEL363CiKzbXIBFdxGW3zZKwT7mS/SujHfr8M7IuxIJYXOgjBMKlp6wJMvv0HfiobhDj1PkDn2MH4/ixhC+3ennIH5wRQs37zlSJKrs0C+l4DKCNwIvgxy5Uwkv4o9czz/7+SPPg/EbSi1SeryhwuUTVIEcVyDH7uGPckmlSeicTWL9YiDhRyVcVBXq/9IbSAqeHvolUiRweaThpsrlWZDjIB19oU0aj3evBwVMoojoYP8CeiR6pcMFTTPLYnOX05rtXcZtfzv1uCC/iRHasmbDlgnbfwZ1OhvkLIm12YpmC5ZJ299hOhm8o4uRQlyyaykzCB7UnspYK93GmMswmM9mzyQ7iMSaOicp4cJ/nbmER3sACZ7BJmOmm5OYC8xFeLsN2bezY5NgDb0FnjuhwbumBDhNF4Nf4qcCPwGpzOXBWdRJ+HEOz+nKDr3AYey7n+HgIqLnscnNa8wHKuVRxV+ck99ZlXzuowgXZDYiIxJ0Jd8qJUkLFJzXFYajz9HMKIArkMtsUgboNmuYvBagxSBviFyvTd7sQveS1UUBq69s1kVv5q341dokdiGJLRsTxS4msd1J7FL6C6YerK0xjVtjus26elA2a2GkU+XEpLXO360ZiUSdjFnDzwZTGpe+QCfKA/v4NM1M0lDmy31tWkUQRXohLh5JYETqHy14LPGjqZiOGFuNaZFmWkS2XNvZfuqSSI+DZ/MNbKU1wJN4P8/hG/0dpC7gl4Gp5MbbxFpxQN+NnY60/SwAa5KuAO8Ua4FA3FM3fYCoJF6HN4y1mMV92C7LiL+Aaf+CLftGN7bSjRhB02MuQ7Jn4xu8JHZGW8lGBnlDmkuQZgBpeFXs4t1lDcx9NqAMcxGqsQ0V3c7qn8FuLrSqpdAeWAJdYHoJUfNSsxEmRReCITM9ZiusI8++qVaDS+FBqA+mRpuxtxu/GvhoDdB0NgO1ua9eqwZBvVaTO9I+UO91lHateaZZz1k3EgrnxTCd7KHvPhNdFeDjPVwyKrKpGmziL6E5vSDzBgWYteZZZgOXt75eM72wpdpKRVeDZ6E6mwAaXea8aCZIqTRzFwCzewn/k1q8gSBJnwlIa/R4gB730eObuMercUN2A1MbDVnPbdpIgKLPgu1pN+W8BDkHkPMZUU6u+E6Yr/YRrCi1YT1hjl4KI1UenQCj42N0NkU5rQiympkmFS6VBBxJhYscJNCFhZJ/KViGVkZAAivTKoBK2XCeg/1gSzi4FUBpHLwYQGYcvAgQXhzchqnIwe1A5eLgJWHGbw2zfgvc44DTUsxKkU56KfBlybbKksVaWCfrY0vEeFaARwzQ2DqUbaahNk6YDRfWazW/lzTag03ooABE3KMT4lqzBW/7SPEn2Iy3F2L9dBvMMX+92YKx3mwupB7dihf92B56SNN1gwkwS3x8xKwBQkM38xEX0+uN5kJ0+iZ8iy3N1sD4tzveQfyyaQ2zB8mt5pIFJ4jYLaFlp2ETA62zRavi54mK+EAs66/AYhpEFKao4a4K7D1DU/G7zJbjfr+58Li/1QTH/YvhZoed6Bm3QnYC62lnJo486lgLazpDCgHUP+SluSz96VGSaQVaQf5vsNgzpOcshxr2HpE9aFq5hJ7IvU2gWb9WCIASdng9s8Mb2Pp1o6yb6G2Z3z6T3wKMo5X8bGmz7rjZjNm8CevCJ0YMi/BCXmAX16vo8i14eSlsHWn0kN4AHKNerdYIUl2bzSBYm0D9fLJPNGuwpdPiXAscjirjtGthsrliuaCHB5HmEhY2M/OKuicX9PN0oWm69SyFECLOs9EKBupMuXw559RrDEu/lmecjxwevvMMxqE3a0w/Ea9NQgLpdeksFaxWTQ+XxZUAPZe+CzahFPpqH0+1XNDL+4JZQySFKt/HTZyzydVktKLgdyvaCdclVlnakDEzoy3RbpgxF1KlxYtRGTEBx+AMjSxdkcc11jhhjcg28aBkVYNtnBUuFkxHEr2Vo3chujOJvmS3KEIGGVaW4+iLOBrsRYaN0zm+n+MXKL6UxG/n+EWKzyfxF3M8MxmRvZ8lM7s1Ou6NuzjumYF0zzwj1TM8sgxBldpkN6XT96bT96XTx/vj+nT6Den0G9Pp442mnE7/zHT6ZyXpW0I14rfAKQYm7Roc2/810J1jOVKyLcrhL6zmK6TZ4mAEWo1duh/c/3iuYuyt9gAf8uytdv9OeyXLQbPTXpZgead9WoKlnfaSBHM77UUJ4mqVgmTzNAF+s8qfvp4PlFP8tJ+fJvEUDo3IPZ4bTlPEohXfrLnheJ5yzMiJdIU/MK3iqsK75TJKmuKU85Jykh/n5HGCH2fpUW23ltpJ32TBFoEGQAxK0AENd1V2aCBhUGcFObD7WaLJm6xwOc+edbJ8XAXAOvPgCJO7qSzcDNkmwxpK+QYdEo4d4B8Gf2IRYYZVlzKsupTh69kM43dl0p+4kWMP8c9R/oFxnLjIoN9J+Z2SXxjZpT9SlfgZ+Z2V3zn5nZffBfldlN/TTd9Zkvhl+V2R33Et9ZHfSfmdkt9p3VQfiZ+R31n5nZPfefldkN9F+T3d9J0liV+W3xX5HZfhmJDfSfmdspvqAV++2R16FvGvwUUXK3xglL+RIai+lh36PRzxaZsivB162g6zJI7MhNN2pVRX5/tKlHl1nhOwgsrT9oxZRVOIfBnnoW3fUoFGrOjnk1IsHOJ54TPgNbBAEqbA4zRenKZgWthC6hzx5cPn+qZT8fNEPzLhcp6OTqaV9GKhBQ1c5nokW2IfYjmySdaM/pRlX2I5sk3WjB+VZY9iOTJR1oxAlWXPYjkyVdaMYZVlB2O5bdiuNKNgZdnRWG4btHM042ipcKpDEEBVONkhiJ0qnOBgH67qOwRbVIUr7RRch+v9dsETBSxZu78RDq/JeTf5nM5VTA+tcJOrkNsfnIdy0GzcQL+HyNsJNU2Bq8iRoTtQs3Jkh95LUQuaEbSrkUtyKATsg9lKSszYXDC5OqRbHhiyYHfvMYqqEZ5uZ7YtWF+vBX3HTc+JoHw/xD7ErwfrXkounqfbWbZ43PSZHnC0fe/AKatcjy8Jqidwvuh7R80veyZrygAU7YkKzR5k96aRMTNvMlnTgxbl2L5Zhpei2LZZNiiOKrO5swwuRbGls5Gxpah+Nn6WoaUoNnweqDIqHmnX99wf9Jhe02N6X9rnN6pVmN49f3HyS1/++2NfveImGFbB92RQDJ+wrirylrcAiyNXupYPLTSZXR50nKkXstXdvD9FUwKxi4hd5NiVOHYJsUscy5MKsacRe5pjJ+LYZcQuc+xkHLuC2BWOnYpjx9Gf4zmKPd0OZfksyWeqeSjLZzdZYWkkKPJWTQ7DIcgF2aHdM1sJcoAbplsO6CznaPRphMC2eTRukQS4DOOQHLGyPKw5Mls2JDUPMjRUnJJEPjkyX7ZoBwzaaIg4G6njWye4HIjnKQIoSD2siE8q+kMn+LEAWQRRgzq/2F+vivVEgV+MqxPsEbul9BYFi3JIptqYd8Rr+0SDsQXlmddRcWIRMKelPDHkoMgJXefkAOaTQjNSKONsFHHN2FJ6K8w+SyQbJShapnPuNnu2AFeMBYjqCpVAKF28MlzACgdC61KxC1FsOR27GMWadOxSFNufjj0dxQ7EsTDzns9iUFsj1gzIHEEBz/38PJvFULUSl4bnmWwlKOG5LAxVFsL2SJTl4j466IglXa6IwKbA7ExmyU4MNYn5sYksGe6jznHceBbWRdS6OG4lQ95+0Q9x3HKGJMrosTjudAatpL6N4iBdni3stJcIrY3MpCLf0YMQ+2EtZkD/pykBTgg2zwryLwAjfn6BM0KW3+TlzSy/wSlBZlJG3szxGzon8JuivJnPiCtNupPAm5y8WeA3py3ZJcokysObRak74mBBm0XkacWRMGfpkITLEleC11OJW5G4sinTSQZx45rjDByGSdyExPWbMp2QEDcpcQNALZO4Kc20w8iNDmZBBv8vZCvM7VczMtJuJfDisZnK4PLHDZfcSlCIYyczuAFyw0W3ErQl8yJTCbrxSbcSlJKZkakEsJScdytBezI33EqwFmPuVoKOhlF3d9rLbjTq1HPLbtxzMshr0z0nw7sm3XMysN3pnpMh7Ur3nAxmZ7rnmoZxSjcM4zRNu6PJKLqk/1AVdxAyjKAZFDmRGkcXuhVUjEoG0mVlCXEWISOJbYkiqyoZSuxKPOdVaixX6A6HRzQeyyUyPE9GcZGu8JLxW6AbvGTk5hVGLhkzWOWtMclowaxzrVk1TjMqGiey/2aO7Gg0TGvZjUDUMzRMa+K4iXiYuuM46hcapq44jrqFhqkzjqNeoWFqieOmVTRMLrkZEg5Uhsklb0PCgcooueR1SDhQGSSXHA0JBypj5JLDIeFAZYhc8jskHKiMkEt8H8XtSg0QIV7wKEXjIyNzCLc1orDrymjciGsjCt0AUEQKXQ8YRQrtT/oeDkFWAIwSnVVYBY2veoLsqthJmwkvXTfSarWZOp9WEnFaMwmfzkjEZzTTeVJowrDrGPad9uJpWhk79EqBf/mmabkQ3zRVdXzTtFJIbpqOK9Nc6+b6oqZDIygVVZzhKqJyyy4FafuRepqoKq1Sldb/UFUs5sQirWXm1iLFZeboIt1l5voi9WXmDCMNZuYeY+sktdU+3S4EsAixy9s9rcYuIm2JXCR2mXYAFJaDBawmpZxdldKbod1tXW7BRICTlP44PbVnsjVywgA03GU7Nb9n8QKyEmAVwORnxU7N9Dl6OyNv87thYZHM+Xl6OytvM7thi5HM/gV6OydvW3bDaiNZB4v0dl7eerth35GsiCV6uyBvYf8jb6sKKjVzUsdZ0gpalKdpUgual6c50gtakqcZBa2yBXmaV/Bcd9omqIjE2zKwwVsbnkoNT8WGp7aGp/b46SVFcqojmoL38UUr4a7P2nxva+PSFcBFs3YlYHhCcr1YEGDsokBdtwp4dZvAUZcYF5pRt5cVo26vCOr2uGbU7QnNsNuTmnG3pzTjUcwpBt6eVwy8vSDA24sCvL0kwNunFSNvTyo+404pht6uKobenhbo7RmB3p4V6O0bGXr7ZobePsSXQEcFeFsx8PaEAG8PMO72LsbdHmLc7f0Mu309o27DjawbLtuilGcBxtFhy9qM+JgBOw2NLfIzAy46yImTGWLSy0Ge7UqJaw5axO0MmOXAI69NKUnoRdAk3AYtrYsNfWU7NPougXLVpSZOHYlKNyP1FqS+gFNfiNT9SL01SV2SG7oNSL0RqQ2n9pE6QOpNSeqyGGWWkboHqXs5dR9Sr0Pq9UlqEZQzcGsnUndx6m6kXhMphUnqfjHQLCB1EalbOXUbUpeQuj1JzcdoUAuHTRKnHDZUnHTYKHHC8TO05zlsq7hi+1lKsGwDZDqct6FnVmAHAnM0hB4/0IQ3LWIeuJssoAx5kLdOgIDA2gnGh2y3WyNbzxOgSjCJIrdjbJpLGNY4CzIC8wmCqCX/cfBFjpOgayyQa8GesPgkmOHB1uzBx+KTIKPuUimWEQd+WYbwrnMqOgAytPAJPmFhcePc54ZLOZDpt9gqm9gAK3GOJ4bAOYQupgsXduFgx8bBDjuGYOcLrkTfzFdsVYQP0TGkWmeHdzzvLTlGsrc4rrDDPitcuaXA4DInI255ozzsVS7OU0rlKUmeEucpx3nY/Vycp5zKU5Y8Zc5j4jzs3yLOY1J5jOQxnKc/zsPuL+I8/ak8/ZKnn/MMxHnYO0acZyCVZ0DyDHjVoi6O2cewv15Fvj6UqItZ4pItwodPkOETTPgEDT7BgWfdaiXoXJYAfcqX97NWtRJcLgrdwEaySnC5KES4XBQiXC4KES6XxSSTGGCLyaYYuiqG65yUMPA6pyQMwM6qhIHYOS1hQHbOSBgQh7MSnlNidEtbAoGcW7wtECi4xVsDKXRZvD3sJgs43iLoXGXxNkTnKYu3IjpHcf01nZ+4/prOTVx/Teclrr+mcxLXXxPsNtdfE2vG9dfkIIjrr3eTJSFvh+T2iOuvye0R11+TmirXX5PqKtdfkzor11+TiivXX5PaK9dfkyos19+GeqzH5m0TdoSik6Gr610HK7yK74emIukqutc6Q2HG6BFGw8yGihz72yMpUMycoBSUBNmZHcnfX6XVyz8l/infX8Vuz56nBFUgFzlwdEyWPBjFn6GPUHryOyVQFYIjoBtwstoKNsEDUB5SCVDs/j4VCZ9LStrhSjt0uh1ZSkzNscmTUg4u7w+mm7OLfw7xz7S6vwouhtsDoM7AjurnMlxrhnEFHfqezd/jdrU1tUtcP7bDP3k1aLuJVnQb3cC3AWeMFQlE0kvwpWCK4aKB/MM5Gn3nBBbuODOESgT/SC6F4AGqhZ1dArmJdKcAbe63wc8S+go6w+SNDCgUVtwvmQiFIksNcHmSML/CcC0EaIJvUfBQEpxWHKbRSMMa5qMBtyN3Y/GH48/yECITC7gjb2Ml01bzS16KgX1ZUVETGa/1CA5tFj7le2HGWNASaTGlBxiEKhM611KjbgOuK+GHtQqMrUf+pAIN7EhtiiImI69I0kn6QNGKcTqsUF8l7rayVHVBKxUQFPguNTbtiY3R1C7NqBh0nhRMjVbMlvhbmlHYkkxe5EKnLaXeLWBLVDn3GnJtqHiwUD+XLr7Q0mg+e7zU3Rgrq/0Ei6bh6ip2VMWRUklAkSadTwjE/JVYD5GSA26FDTvHfJqcY1d5O/SbbO9BrTLHUvtumb0dafJ2cT17wXfpgd02lwJYytTgfKFM8CLgYdSJ6JkdTIm7Exe/N8C/JvEyij4D2wz6gsMbsSPsTfTM3qjE9Ql94cboC1PwV4jAghJ/KGcZJSBzMFa8YuZJOKp4w9bipIW+dbMwVlUCEqePLUYfO8ts8Rfm5auaruv4A+P2CWzojd1FgAGRX2kjncaOpful19i19MDP7bUSR06oOpd3treqXGW0Oqkz9Vsp7jd1InomBs1h7pS/dT0cK/MQRB3JH7o57rRc1GnM6wrTZgmTI/1Sku+xC+f02PbLBwfi/rKi/rJo1q21jHWx1UkGbuRNEOZtxvJ6zx2P/x8v6G62fSuNBL1wqQazKSiN+V2wBTGZcGxfn98NUDiTpfAa44RHR2Eu5EMs7/xWqI/AIwv7oYXSoN+H1XzEh0KER7B1owCSxGpcb7xw7BUmW/HLJg+U9zb8WIQjI55sO03RdNMdo6/hBtQeMl0ArDxo1pEaGfkdbjtoinjyC6bNtIT24ei5lZ51/NxOzyp+ToGfbTLat85p5WHgaDJ53JwEtyTBIAlekAQvTIL9SXCr8SJ/hFtpuIMNkG7uAvOPE6yPp6P81B9sxBPU6MhXTmDwuKLqVX+r6TeUcYCgPGCHUQe8R57U76qGUi4jZT+UZ/HUH6W8OUo5Hac8jZQXQgcVTyZKeWOUshqnXELKC0xAc43rXubqlbjuN/CT4bpPSd0HuO6LyB2YLVxOKSrn+qicybicBaTcYjZzylyUcn+UciJOOY+Um6GtJzc3nHIoSjkep5xDyk1kGOlDZWFcVwjfhwRrHpxPmn6zpeobc4HZhJQXms3QzdxqgqofwJV1qeJnTCt+ekzJtFd88CQd7LM2a7znFcF1rMcNcx4ORP2C8YjTYnMa2H/4qrnv/MCYuD98YzbGTfY3plrlbzJ9nt9qyswYBHSLE2wQF8usUu+Ldyb5pIq6mH1FybdV1J3sc0sKUVHXkasnlAZjB4I2Ghrx4WFWQ+NLWLgOVoiIHQONm021ROOvw2xIXmxkzeceztGevDA1usTit+kcAedoAU/UYhx2CuoYd38jScgYx28lktAKkpCLSEJrQhJaGlfvBpPxrWT9bWD3VTJpiPTKVCM3VDJBLbEQklluogVC/qlkWVliODQgC1VWtL8hmWtDI01TDYxLqUK+jXnmhDRdfGXWMkQks8ANlfQ3mDymUp5nFPE1uNFdy6NSDu0DNDn+wy2jmpoK1dTwonBQUxnulmRwNtRMSzRq8DoctEbsOetUGJufeul+3PusUrmxaEfQzF1qkP8WeMiDVAnoP+Ch6UxlcT8oclqvCbrWHhJIPVxlZ+Hd9KDoKcuR3iPxkSLKnnqBE4rmQwR5I23kKlv2xlB9lXN+FUcPgAuI51ZulffJFt3PHnzNSIDaO5tJTpmD0aNxw+z+vmANIkpB/mCwNsRFhT4Az6dgWUp+ls6OpaJl1mJ+ugZJFDhvgHNugE7YSJANnM3ohRKD25YqpZMqcPcWFT1AbSwbOiPGxaVGFtE27Zs40OUPBuWGQp2g3S9Qoe1FCxMEhZbPUWiBimxPF+ng244UWUCRhKBYkCIdv90Ll8n5VqhG4Wj2e/focHzcwN3WE/fA4cLtqIqzU1tIxxb4uLR4njMWOm54+h4Y3odL6rdDfUuojwR2CObBubrP83sonb8pzPodNDfyYdZ0EpSKyV/d5+fMJqKypgP/9vf5m4VByPFUa4GyvG964FOMc/Vc3Rf0mpaKvwXQkaaFiUhgNvtd4kM8B7DdvtAxfaGzv8/3TNF0Vvxu08ef7Aod/NvfF6wLlVkXqqv7/AvMOsD1XhhaRIp609jiy4NGmVbTXQnWh9mDgW3WR/PrhL/drDOt4dgrApzzsSr6Gd94q3GMV4GsHCbEmHrbmKxtMC3+RoIW3IiPOfKxwDbbSRRWJx1lPWQuYqftMNuVrK65mLX8cdpuAzrPVeLg32ZnvIExFxvHbGD35ibWKonAns/zHicg3zZtWFdtpp/X1da9BCZqMwRm4JiL4WyUczqxZspGtGyj2cJ0UMjIBQLwAO1H8JswP/KpCZh1ATQfISA3xdKfAJnNGwmErMQ5lPHQ3Y7pDrMH45xZymmXair9bSf17YzJmgBqjqYX9v6mWKoqD2M9AhNn8fB+tdDsHmxKFtc8bzorQVuYfX7RMp1sntGGAyW0M0cCx6wxjlmzvy9wVlXUFmoTVTBnnKYK2unaFWCVjdNjOBZaVDvbrCHtNuJaOkx+xO8wbUEnIhSdfMvh7eOKDuawLu8LbEJyDZ0RcXahh8zaJEnWlFYnIfXkzVabFzolK7BLn8PAzv+rCt2Ssv6rkd/K62BMHwuzfvZpyWkHk1PvYNDZRE5b4R1eD5lW6n2ibJ3noGx5Iaet5yWn+Zic5mNy2gpy6h0MuprIaZuQ07aiZbq40K7zktO2/xA5bfvvI6fdTE43ECnFhpk1HlHRDaCiScRGqPmNBIaoZyNF7U5IaffV2OVaQD1TpLQHXjFAnDYZw5Rns9lI+A0gPO2MOT8SrA0ds5YILIHBVPzes5sglVAKHfzb3xfYIWSGILBbRIC6ZhVl7TUuqLUaCdYxeV2XkNcLaYX1cS3KpoWEPNBX9R19LOYHSRDZa8osUXIkfbAexCoBIAsuAGneJylzZj2ptl7A8TqKLyG+hHgPmH7GkeoEjrmQL6QuqNUT3V4T7BfMc+Iutqwifb0E/G42xUSiB15RzBqTM2vxygYRXE3/0lQtTzns0ttTZGUzExRSgqTPFU3O2ERQSiB3pfCYaR+B+NG0g+q1R1SvO6F6ISuQeiNBlvYa1khGbTuMg734XOQOtl/ZhqqB4r39fBQvfw6KB433jkpgX83mYtbVQui60oSu7ZyErjNJkjet/5cJ3X2OagULzOKRIkLPJ5geDZmEQ8LMETx0MEvsMUtcIEiLdji/ZwQD6PMbj9daKxT3od5/mJ/b5FnLc0melTx3ylq2GKg+wCG2JVYiZz3XnOmMOGc8lPihRA9t/FAmQbWfjRBLBM8giyNwJgK6L+4XkIMi8/xAaoFkdNQvRa3FAQNNLXBT24nz9/kWItTXgOUjqBQ/A3IFXQtTMEVuChChCYiGuJkOOSAQ5EHQAvLFwurIPQQJjhnxg42e8Vw6HDWOn8uHo/YBZ4dAhR20qA0tamvCdpHCpKioIKCxMBoxiQiYpSnFmFWIbDggeTWtvNTJ6NgotR8XDQ194xDSCfVPkfvHPgBeUw+ZIq4mTOGg78L8A8JtjLJp3St9whdOWen0VF0RhWsFdTh9XIpidSq2FMfaqdhydG0h1ztyUvcagFKk/NWly+3FOSFTRHwvXXTGtu1jekzdZqyTQWbYTLwzPHPmzJns6FkKMz4+V3VwD2PF3h+N9Q5jnRw+E/2x7ojNc85Yv9IHrFk9ZpzwzJkfPGXTfo29/Uf2gaIOx3DvRaKa+31LH6NUnz4jqc6ceTMHzx4ZqzGmetXEIsOh6gnfCq2C7YVwMmWdIw1MKQhJJTxz5u5xXLaEOpV0JZV0ZbDemCm0fTeBcrdOeCjMA0KfseqEQgMFBP6759KDlYv3fLB+qr7n+M/+7oXb/+7BU9X6nt86fuTPfjTzAQRH12x66i9HP4rgo9+duv/++z95qlqHPbFJvtH+leAfLn9wcrC+57vFWzZf8wfvGqzW97zgioXqy4vvQ/C3zfMe++zehxA8c4d17+YDH0ew+Mv488XBah2nbu4uXOxV67U2jzwwYdy2C44YvTBOWKWImrFqtcA6bsia7X/00WWJdy8cfSebPjc3pd9t1wInee3UjF2Dsgf+7pns/nRPVT15ZX3P773g4TUHH/4VtPh5VMW3D1Yh7dd1xiRC6sd3TXzs209On6zvefR9Hzz5tu/7V1brex584VvGr7vt3o9VYSlsGQWrfu8LZbtrzDmmbttkhQNk/Qd+EFdNJ4NezNHAjmapGz75+Ekaa4O4wdHwJ49s3keM50/f/3p+0TtsvZhwjzH6Q+Q7thpYe55x02/2vuSDCycJlJZwgsyaWhK728Zlm11wvXTOwVTOK86Z8wrKOebbBcdbXXR+LvnA0jmLXuKiNX8glXMolfOcRS9x0bf5Nu6j3fAv7vohd4AbfvQnX4qCP33/p8edfUXdWLeBsWNf7qC6fepNb3znPa3fbqpbHIsS7HS3UM6hVM4rzpmT63Yrt8oNf/LIE+MEq7Wqh3pSPbR8zh5a5lo4zT3Uk+qh5XP20DLX4ljUQ08+8sRrnWuKdFFv7blj/pO/NfAbT8SkYdcvRZRo1yPVYE08eepVuFyJx7selGtBj5DIb5+6ydd6zKy5P1pDIe7S17wbNAZ08qhHkFyaJqwCH7gmIWVB6qs+dGXShfprQdziggZfyhyWqqS/MfjzvuERZnm5FlgszHDDrluAr3By+DLQ/rbRkbAdYGFIhZw3ShstGKWt2fOKQ/Ylr+s58Rxyu8AURb5lGj/yTIiSe7jOQGGnGnJWfAsff/iA2XL8jj/YDc28tQ3f4kpaNVOGgzE+4Y2Pz53JXsdTxVhSpjLYV8EuI1FvtDFl421p5mHrzlOg5b6Nq3OCcCpVmA+G9kLjMFmpYXqI5w/NHsHZCus+gKBsFq86dNftEKuMahgQqER9lXYfVEvK1QGNt05VIO2E6yXM5oXiDGzGYTNmDE/4RznypgO9l/JvgfWn27u+oD28+SA0Ru68BGf1PB98XJzXvEpoEQcMtsiGHuIIsS4OuYIDCBmLZTWuKZPjGvEmR8LJSyr92nrIS7ESoiYikudcWB7xC3RKyYPhR22gxQgWqkSMUymtH2MVSJriVbjPUi9Ih0FLX0Q1M9D/OMICLavqx14sYnhS6jxjiYnaPtHTwLjshRrApSY34neGA/jpMLmwBzKmPJYd8fux+aFFA2jzderzAo+Zuky4ZFeoHyp6DFMkGv0r68HaxumytmG6rI0SPoxqB08ztfgA5og+ELd9baqh3Mso2xRKH1aBFVdibrD+FgmaufrTFkIYF8WHar5snnrMFNDM7r1EevQRQI5+jfRINWOsaNPxu4E2HUdGAhKbQBPFLxrHdP4uBrAAIQrn69dfs8O1v+sFrTieQtMphGK1FfMNLy9G4iDhmUtmdfcGHnPfWLB+ix5jsT2qn4ObTHwC5eJs7MD+IFQe+VlJ99GQ6S5a+ILta2IRulq1srSHKOVrr6GljnH60a7RHdriyxRA5IY4YqU4oJpvUWtKdH+RvMBQ1IhpShYtQ7/pIWMH2uT5pB61UI0E1EwU6RyGGxmTp4M1gcAWCOaTFlJOsoA+BLZkwUxmZpeJh8PrkFPmjTOSSgd7hQodPnkFQfIZCB4ty0LaK6l1zS5d08swASH+L69GEpa2EOFj5aCyyY3QJI6p6MudobjF/8FVFuiH/kOrjOlCQXlPT+t9jfHw0rWCc2HLS0Y/d3b0sZRAK7A/2iQzyxg30Nz+9MxGL9eFeo6kjiCHrqyjA9lzp3xGk89VHTgjfltqSNhlkGYNyXDpEUsQUjXg+xrHw+SfT9cRbQfIdxHNE7fIfgKqqmLakgFyeAvC9oHRS08Bm3cMbhdaxTWXb0Szoir1pz0PR4lW8oyaIUx7WjqKyLFMp3NmN/ZV6Yo2fQyrYcaB4W8xzI76jFLtW2AU/wfv/sd554ey9nHa/Y09wgyAMlbybred88hyGgJv734CNKLjDeSrdr1u7D3Hvvj5X7v8y/94RX3Pd9+y7XXf/MdfO3sOwcs9tz71vl/9h/WfuLK+54svebinqi7CyeYdK6X29vbbB6tVgCEZq441vZeE0rZx63sO0MnnsVM4yVTbPD6AJUcp3PbUa3WjasaJ0g7WqzXvE0rpMVYKUptxMrZOpg/i+uyR5k/ocJzMRh2+7eHjOFYDiTEexdI7+XwNzkkLw1S0eoX+k7ygNA3c11bbUtr2WCEKygrImX4OVeld6nhBNyY5Tn3ckMbzLYJwhDKTd7uj7DGUzFIDMtXRvcaivsBNFtfhFaEN4TtRBwoZyydtWZ0Ks8csDUcw1uWWFckyRA/VHoVIXxtcxhOdscNjEFnMWQf4Zi4cqgRQS+Rv9GuLNzSIfSALpVAOtgwUKsAejUIlGKlRqAuWaxQqw3kMhdbB7wyFzA5tOLR5h97Mof4dup9DF+/QF3NoYIce4NBlO/RlHNq1Q+/i0HN36OdG2h+afSa617KCsXGuK6qG2oskCHKhQBsHLSe+KnQOpLqNZK6Bc835e5JC6nJLcUhfbmkO2ZdbdnMpUW0AD3z+8Yj4Qss7Ddw2HuZ9RT59QYlzJCRaeGTk2nhi/KnqpXlB0wF7KOdCW0iwwWe0ZIbYmI2sS6r3FrHkVldlJFbZDe1R7h+AG9M5yR7lFuwtusaS7RlbozK6Ih+SXCQkvFYkbBrdSeajuhJNo9C+RrTAi+LWjb+W/haIJGocf8puHkhobNNZAgWkPimJ4zoRZ5tqY0D01/uR1pDbaWoSWV0gOXd3qEb4UZO6Cr/U/EN+xOW1Heo4YTZOaNMciuLzFB9axhoJ7dGAtMxVeEaNhre/8s7cwUAxKqUGS3KM3mvKjWiHc9t4yvEPvOnl5LUOC3HCnjhhmX+6+KfEP3C3V4qzdcWhchxaF30KtR+FBx3qV4PvqgeHcbFXuo0IN3qf/bLvJBVVdydpmbo7SUnUZQwZw91t8I2N18jsfmfOdmJpaZYkUZlEEhWdUFO85AmTCTfcEurRh6oknztz5k9ZzIngqX9oJOpWjRaEFYsa97xnjdXxN99Z+Vh9zxM3v3zTPfXfwzZ0Xc+XvvqCi96KYOeH1/1/t372cQRv/mrXKz/y23OD1ZSM0bykPvxLb1n4WH1PqXdd8Mn/6UOE2Dby148GC0cQ/Mjndvzy894+g2D+a1/57O//3pcRTOSiZCZx5sypp+xrTHbYevHo3obqGmg9V2ttXrzHSVz0fKparUmzf3A7xE/6GD18Pt7Nxp98/JHBhDODCMQy8d89g9k/atl16iWn6nu+e9+bX7zjojrq973+K6+Yuomkq0+YF4x/6jceR+wPH5n9ydAXvoTYaz9w74PW3V9B7K7f/bePzb74Jkh+U59d3/3sX33R6ycG63vW/e0LRj7+T69H0o3PvulbN14wh+A7v/3Al3/9pvcj+Kzf+e69y1d/HcFN//D98suv/IvGLqoVVIpJtO7H0NVPkHzbDb/353/MUjerofhf//jxv/xBddNcfc+PvvDEr77shS+aq9b3vP9PP/PdX+/8fxF8edB/5/ue91IE7z7x6SdaBq5D8IJvzYTOhi0I3viKjzyx5rJvoq3Pfmnxxo7L7jwFhPTGUn7z+JHv/+gH7z1V3/PGq/e/4QdX9Q5V63sufu/+75/o/38Q7LIP/aq/8L8QvLn/e37PtjsRHO193ReLW/8AQf9blRcWnv0SBF9zy6GTH37Hs4aqwl4kA7Tra3/8/F23zdX33PviSyovcSZRvf4f/W7nxPfuQHDqnx77pf/ZRU35tft/45fzH38Ggn/3qo8f+sgbv436X/07p3efo/57fnP76PA3Du2Yq++56VsPfOvI9K2oxjef8/ef6/nRCQQrm++6+aEz0wiWX/DW8nf1FIItD/QF7/31IwhOvmD9Ba//lSuHqp4fya+/ccqokyQYOnTHKZLp10rvp12wBspNrJ9lnPTwVkvvV3WjTnhBchEB7gqroa8t4Z+Tl/TG26CUcHTaqOPYBomzJdNCVfdKycHSKpX+TDVEHELE6xy6l9G36WMs985EorXACT+ZHQkHaaP0Xb7wmM/SNEtq3obY1+YOFBPuMHGldvQF4Bud8EzbvlW5MsRmh1ZpRrV5oVV6H36qjzL0aj2cplCgqmhYLVDh7KOCIRvOSMiq0iImKlaHFSbHhwv0W62Twcy8RM5FkfpkkHln6BwJl6mJk4/xgceCY1bsD1OPWbDoN5nh7a8+Bl34vUROuE25O66HD82ofRODt54C3v3ZoiIJrjVWLyiPhgSmXlHK5cFjnBLNqQZJV9zkHDNOlCq30xaj18isvQSXbImNe7oPA77nsWrpiylj16rVaiOVS6QIfa6Jj5olq+61eSYbN8Dz/tG1nWOK9nr6G8+I1CHBDZ9cuPuVzHef936u6MrwxhXBhrPnB7uffGr4klcPvRQ8dUy8x+pEuh/52uJTuL4zbvi+xz5+BmwKPvJiZwj3cHtuee7vP/sHu79zBax+9ljW0lPDl3zzVLWgYYwTvz2ZfjtYleP4nqdeue1lV3X/Wyxvx/7xjmqgGs/pKn38dx8KVFxm3SeWJi62XvVo59S1AAegGrO/tC8/gaMS9FxY0p+63krd6xm1Z/sj+d9+6Gev+1h9z+4XfvPVn/r8Au6oHvrqu9/W87kukKtX/fJTPVX1a9gD/gWHwfbaqfR2EF+V5ehQWK8Fdi320wHevF47gYtAd290dYfjYE3OirpWN7p2NsJXcmCD7kqrbWmliVOuJRVPtti2RCC1cOqm+CqF01WjLNZcnbntWpC+YR0UtiRbeXD4slefwnk83C2Ht1qqXak8S2O4qNN1ckq6ry+Z023JRhieyRp3hD4Z2DX6WJXYfrua+qpxw85r+86SYb6JLFgi2Mf169cdO3NMjWnitHLRJP63wVt5bj/wcXUD3OslziFfkBI4p7ok5ijkuRqeHfAqkS6j6uH8F4mcOfXArZIZKt9/iowAeDp/w0RNh5MSssIJDoXj9FuF/2Mdrnwxer3MofD0F1Ovl+LXi/J6IXltkUyAfqtkfmQyIBdVXKeb3PDAxDuDbLh8Ro2ED4zfdi21O7XCryc3qaWRIBu3ebfYssc9cqLNS3XWGesFRbj0Hh/Xo3sNfXoU/13FR63SB1WqBwd+qX4yylm1b4WYLP7SPw/eGuSHL3vNOx8KdDgpTcwPbwddskZD50iQDaf/hig56GI2rPIDMDnizeiOW0/hzTctvqTOhtMSrAdWNXCiQVG8ccxJ981+UTYOK5yRqGnpUWxG1S9G4zYV9Tw4f+rWKs+3z9rNzLzvEnU9Rivv3+/8TprvlRuoP0jx92dSs+wlRaeXpm9Dl7uhOgLS9ansgSI0Fx/72aee+oPriom9BE6IxGKfyV5TtL2GfURJrcJvfGwLrnW6bgnPZGFdSxmOC2OZXqZCDWXe1zjhuHNNn1EnIAvP0rRpu4NeDI5ChnTGrjw4bF5956kkn2+ZzEMegV0zwa6b9AqCJkagGsloPXBAPutBcnrZ88BfHl3IH39ksL7nz46+Yf1jo58B0XSefPP999+PYwaRA6Tb88Ir/77jhx8frO/5O/vTf/TSfZ9Auhe/MXjT5gNfQPCNJCn7x8EqORq3E+pvdLVKI4r90vJWWuz8Mfu2jPBd7aw0YNTJoADWKegg5qkz/FgOLrbP3HYNht2jV23hmbaR8JWHrhuFYH5YvTooDqtbozX2O7+WOvX42ngpolPUpng9/qPzJTjLFxkPH4gTHbqBF5VRVV9DohG/WcYyTKTw1IGmMDw4cX1Dmhft6/M15gm+21QtWhlUJZKN6uNwR1KaVaFCJs8Uhq0XF7VpTwkOTxDODtzYykcpJzIFpWj1c0XRK6N+mymFal/YcQRXOGmy45Na+Znbrn3a3ukMTxJrqsAGp979Sl8ybbm4jnC8dOBsI2+PkrzoKuJD38fVIY6U69yWupch6nQOdgeUigSDBcQM3XEqgIY6V2Dh3W8H4SqkKJCMV+5Y6nhQiOmYewRO2X9MVClIzge8tYQzP6Y9xK4Hbj3ImgLTw1xY/TETntZw5cdCAvM4XxjvFLb6oKUK+qZB4rIQn9SqpsWwYDmwq3X4jo2/MP5v/AXy16KJign/AMtcyO+scIlTh4s/jinjgkTN/ziijFY4J3GzUVwVe58+GfWTXQ+ihUErplWOG3DjtPqcwfpEJZmirThy+G24+qNRktlVioeuxMNJovpMDeyPixumGoxvz7LIhkwZ5bjxix42/pOnDS8+bbQ1nzba4tOGZ0oPHqMTR4GU/pi2tJKU3ksdPQo/9+iRJFkePBYU5NRh06nj/oZjR2vDsaPVtDYfO5JPjY+P3XEqtQulJBExXbmpj+eYHR1KeK7B3rn29McQHyPOon0es0LcNBCXdn6nvedrOpyMQUYYTxsVnoFEsTeEGuIHctcgaA0jaNTIg68O9LC61Zxdr9YLKVFIkuI7ru/zvGmFazYVjueen5prS2N1umo404aDr6KtUJFIuCnBz9bSfwf6wqfakARzLbz96NUponGjzUlnD11D3/pktsIJmxMs30z/XdMX3ttW8Un2oWJmue59uvHiZui8Fzd8G0P3NakOD63SuxQrR+hEvcWiazSSXP/caxu6gvGtQtNVjm813NzwZQ4X1HCd4xPUjFzejOHuxsLRg4TubCC53bL2FlmRNFAiHUd8oOWagDzzwsjcJnHwyGg4fvsr7zw6ytfSEBNjU9HGGmlDRr3dEv2ZSkAXhSRYVcYa8TJW+C/3aG/6EuVJn3qR3l/zX2OF/wJrkHCF7DGCTAjYcq8SHh3F7wGox9u3BOqWgFsCHfdXhGrU8M3AkUCH0/eSOD9QZOSJ+QaTGAinq/fqSqD38dfhrcPYvweFARK04FYYN0XODp3zSOkeRlihfRiCbWXgJ4vumEKFmEIBUpjxe6mSuWsx+I4M6BGsiyMBy9UPj0pgFOJ97CmFW8LSaGDdEqjQvSXMjQa2sQ6jADRJ3xI6o4E6jO/gWUHA3Pis4ufVLUZDrfM1NMhIU62oqRY3lY1hYV0TNZYuiOjjrnGguKDkhVuBw2jL5MgBun1LAL1UKs53wruoN3ylx6CJbNwjgUuWOKiDazKHSYRPfd2vc56P7UExZhvdAih0PX5cVAtfo4t6dDIVWih44U95VpChEakn/bf0KxQqpt/Efaox5EdHjUMXebij0kNsU2XtZaumrsDaS3qGcUq6elLGviaw+3yifsbug0SDdSewtMrkDkb360JADlU0DV04QV14AOcNlx1pYowKdG/VJb4PqVzNNSjaBBnj21iBNhwN4TQRJYQxIb01LiUX0w/0ZQukOI6xwlNj19AlkFcJLLijcKI+hiI6EX4nHNdE7jcaVugBwYcJ9S3U7+NPDVbCEvW4dQRrJBxf2kgx6PEjOG6H4+NtFKNHA/tI2HYLuvmwsQ/Dp4U6An8dYXcFQ3A4XFfxYKRA/S0kIZseD3svKeZYrH9E6nIhXOqrW0ZMNty4r++IKFfYyXBkjLqO9TpMJlBsI21sJq4WD2EG2i5Gh+tR7Qp6y97Xh9N6H6vFHIkpmmXcw1wHN9QmGy90gw7AgJxvvdsyLzXmpW10Mi9tzDs7mZcNzyp+Ts9LOudi2tlD6YmXMeoAVIkgKuOp5yLgIk0psJ0xY1O4y6PZIN6klBAy44ygn1xMT/KMj+kJf0QINU3PFAkp5HHSbZiebjw93dT0zBgr0A3TkyevzGZMzwxPz1yKulrYDmLaQvbsIEml684OQkQbiFow3WJtgIhkWUYJyYrpG2bOXfdqKggfCPnmFltjnCVgb4T8kYhEFlpQqzu5VrBpRJhuR+mmNJy8V+Mf1RlVsfn6VMVViQisFX1OZvCllSCnx8KF+5DXGQoXKYB6fu0+PTwGk8XH79PD49XYgnHhPm28sABjyHDx3V98t/sKsnO8T1r1wSgwbryAEHsto0YCCJNx758PZ6iEQDlD4TQHSbEsb+xriy1GmfyBYouHz8Ce0hkt0h1+1Djkmr1Pk4qnYndC5NPLpj6rGMXyDpoybPJWehhsxdi+omtcP4PGUCdhiSijR0mbFdfVRld48VT8DLbkzHWQa4dPMdVxo2pbSbUVUJpso64tQsRnHyhmPJNBcRbMq1QhCzU2PWKyo0H8HYdTaKo613kfCKlvsVrbGNQbnHCgYjLXFi0ZjQBgr5mRCvUkeGD+mOhiZD2jSg+rcOwqOhDD9kriQ8tkRkoPq14otLMHrbGrii4de32XEvgaKvca8Zo6Hf9gjOocJm1GN6q4Mm7pYQWlS/xg9YxBz96SH6Ov5R/QAUCPX1tUHjpKOgtdRbPiPfxoYQq/5z5axJbwpOcaYy1jzA463QosDOLRxX3AhEz6kJQUru0DeZyQ7ZvmePjR+7QB+4Fv8q4+da8OxxB4y71aZj6eHpWZaxOreiRQxNxA6geWhhdy+B5EUZjcs1mhIR9hWI2ZsB+bylGoNmZHSTUlVwmzo30BFDBlldJEY+0GlaIUuhL279BO+KZ7dbgU1YjOIdutQpgbJaUXUrpQRl9HKhUws0MW+mh41CgpVUWlWlxp1E0oB8OKWSM0FFgzMXN17vJV1L9GX5PuV6PZByCNUpqFtmUlWleJl6rAKuI4FbcD28bTLWCsp3gJ+1bB8ixhGklY2A+D0wqre6zuZzKZEzpnh0eNLe/t+H0GPrAqUIoEm5QBl4ruc5q6yebJSswBs9w2tgfeCPbxlsCZQMPHz5MJVLdCE5yyk4fZ0B4NFV2PguHJ0Zo/QyboGfQW7QQpznZfL6qJrdASjloOJ+FtxuXzg6aDDnZEi1haMLkEJJXXUCTNxPtoRjj01OZJekwZ7IrsC5c8JpaSp5BP6FgQcLrIG2iclDZQizdQVSRiQauZfOpFha8LVMQ6UE5qO4+nLiowfML0hbcZFbcoH5bCLngVK5nMvr6KpCdWVxtGXaNtmw+BUOehb5ap6cQUW/yiK3lhcqCMNn4wHDQg4W2jGCgnXolQ4+Hlbcu42HTmi48a4EvlfAhbd3UkUPFBQxmbDhp80qGDBmgiTnXRCcPhoeLTBwjxRtKRBY3lwn5BzlbT2T7mbHXC2eqIs7UbOFswbVT4OuMMWzvRY9G4gLOJOG+SmESHp5/eAxbDPSwsDE9uqFKxgiCYX4uYX4uZX4sNX1mzXAlnaO8jvnT9LbT/KEoF7bTRCqEvU6E0edIFoK7SX+g9EPqnp7DuSJCNKCysVgOXgQOyT09hiQZfmCIUF44QoQgvJQaaxBgH+gI37MNH3HDuPr1VU++5oGIUziFWYL3PtdtE24pxw3LF590lG7Ni6BSnwvrLBwik17joMeKAo/kJF9lqJMhIY1wqwWQiyoEZap9rhmI0IUmIZ6hePUNtoRuRQpwQE0XoTAWHZ6jiKZOJJ2rm3BOVDlzJRLXPO1Ht1ETNrJqoiidqMkPtX2CG2ibaVWWGZs41Q+1khkantMy+otM0Q+1zz9BUAaik9JcsZSMiECcWKORwQgSxcjipI1KPLPPgrsceUyx+K+qMirNQKTIaOS/i/C1SnaW1YP2neX/bg0gsHEBei4R6OOgyzXZBse0Gim3c1TTb5ESukxOCnSWCnQXBdlcR7Cwa5J6HYLvnIdgkrG0jpUY+XSVnJLfxjETqGHEjHbzWcevB2si4yXJR/2WCrpmgJzspaXnzhsrLJV4n6hddJw7ZtMfrxEnWiROtE7VqnWheJ7qZoAtYBq8UJ14pjsnJSolOqrJS1HlXikP+l6OVooj9xkpxkpXiRCslgz4kw8VMugBUU7pKC39ip1gRm7tT87TXPO0j+aDLM5b4lBaeofocM1TzDGWaLzM0n4hYtQdMzLDLtGB+asxPTkrz0wU+Z1nkADTdZH66XPl4frrR/HQb56dunp969fzU8fzURnSdVSzd5fn5dHJNTFKWaprMz5NrWizXFJbQ4Z9ErmlHck3FnPz/Zu9doO266nrhOed67Mfa++x1kpOT0+xW5lrG4YkkGLzaQgWbuTUnrz4ChFod3/jUe72fjL2rckLoV4cn5xxsGoPoNXoVClYM+GjVHoyAUhRslIL1Gq7Bi5KrKEEF6lUhIkrEyvn6+/3nWnvt80iTQr3eb5Axss/ea80113z85//94AonNikU9mdbukZXe7p/O8aIKkm4kmt392yu+nBowAQolZRBEyK7wbHZq2ooEGrSNj+PPWJj4TE0ohnnaaxV+N1QNJN6Fb9bk80MkgKd6oI3EKUmMo54tWZQqjU9Gg2K48nIp4k+uBPCqlS9Ln75iF+IJlkNcD/SNAC/q0UBGw71mYmNd7d18fJr87CETe35Xe05ypX8bljOKCZ4xiV4SvvdbUQagth78NQUlOi+XlAhgqdmJipxbx/SPzAQNK84xFFwz4UPsdrzFaYiqhgRVZBR3kZeFYfH9aycO+2Md1g5WYpBJws9eUV2Ul4MGvZd7n47KHVepRaM7iyjgpVZIVit7rE6Wk3zjLe2eNiK1oWt6LKwZVbClqyiwJbXSQalTlIPdZJrgFk0AjvRFwfMVDGOpwFmZgTMoiqY6RLMonXALPJgpkbBLFlrUyobrkuo6ySXh7ukFITVuvQ5XE2fw6uizx2QZz2klwWVpkGBQtaQSmtPk4dUOlzHoIBR0KCgQaWBEitUmrhfg0qXcrBEJQ05Ws92DDnawHO0YUFGQ3+iFem0Jp3WQqc1g48lTVoeejqtZmhdve4uCfFhK8avDDnaQDjaygvWoNNhhU6HK+h0WKHT1Kjdxz2X+OQFa7rY1ORUHbmSqJfX6bs1z+suaM+HHGgnMQsOBTHE0qphaYVUAtJDHFSHqsSQoRFJBmcEdiGzhdFO1vDMMxQ6GHidqdNHboFKk3APiRAZXNHgNlLsAKNMQaIi8EmzNjjsjNcARKDPxpPrGpjasNQOmPQMTfq1Chb0iM/QcHlL26zdZV3e6hUNZOFLnWDdW0drFUy4WO11X9sYP+yQ1of1hl2M1AgX7APuTSlKCq/MR03xqJFHg3KeTpJXBSsYhrAYJTYldma2jSRwd89ijA1LL4QGYmZFqSSHuQYIMiKitiqY2OBOKw9XYeJWiaxMoQEooLFG0yWzLvPheE/5giEmpvTdEg7UY+Ia0Ksp0CvrJZshJo4FE6OiG2ZVbQpdGCxaJSZueUzsWVGOo4qJ/d7JIJSN18fEFX60Bkws7YmJY+FHIUvlyOfCqaTS5xRXYSJnbB5vTJQ3kkJa4u42it1Fro6R3a2AwEroSTzQ8xkPNgXkJ+kZPIjMymGSh0yvVe/jQEuKTJzLDnVMbs7dXbKMkQtmuzZyd88iXSJM09GBLqI0WbvAhslrWjpeEEYxEi8MgJcR7rIIyVWSSkL3vRXOQCQa8pSmIB2Ft8UKuq+oBLXhnrZZj6dUBZlX0jooNdgjwBUMRRYBLjUCMWoFcAUFcJVk3oyQebM2mTfFONYGrsuS+XCEzKsqmQ9KMq8K4AoK4BJqrjxwGbkxUciIxnOTxnOTupQgmGJOqLoqhRrRlHRWeraIfgG9rM1KqhWspPaGkmHH6ipZSbWClVyjRxhp/WgN6Y/AmBllJc06rKS5LCtZmfzlWcnLwxhZydDroYSVLH4NYQyVPIzAWNmUMBYKjJkrYSWvEMaunJVcA8aiEoGNwFiy1qZUNnwIcmQlVwNd+VAyquoxJSupR1lJcyQ3Fc2osJLi2UdW0njtW8FDej2d8JdkJQ1LjoFNHlX4UOk5ZCXNFbOSpmAljSh8TJWVNN4Sdq2kUxqyklVG0qzNSCqB+nBE4WPISBrvubIWI0mFjxFG0nuirMNIVl7AYChZKcWVEj5SF6YPrqkSPrJUUIA9T5IXY4tOfFaL0Vu5oI/gbyPSnaGNV9/SBaK9Sbn0CE3gKaEOT8kgEFlYcpcLSYiMi4HS+KKTOc38RyzoqBnPfvh6s5d4j/iWWN/Rmjxtto5HaksiQ71WqsulQoq0C2fF/d7Zw3yPxFhPm+342ElfkLpsF+TQ7hH3rFcm36L1Oi+nx+AaPQK6Qt9xTilCifilxHi6E9WPnUrqyqr0IbMl2YQjc/G1/uyE/fSdoVXIw6rSxzzN9YthVdKAZ+1C+n4JFLWadY0xy+qtM1qH3nMy3Kokd4yNbib+EEop1CTe5zNuLi/XZJ9jGwykrqex0YC6Wdfqk22A0rCfntPpOU1LLDqS1OBB+gHtabBF7d2Wjw1muc7pcUW/0BnWRwvSP0QyAaROo9MkpWZw+hE93ULRaEXJdOlOa7aKiYrd7c3EgW2r5JMIusm4YgK9MpFEkjSxilNH3NQrAT4LyVercixbxxWcH8Jdw71vQU/LItRqu1LpH2nuC7xV5em3DpcyKpcyRNJ/cB+ykNfmsQ+Uky782752PPCuFlLewmduaJkIakAuNDz2DFNaofJ1qy/lr7nA6N7qkQWWi33JixCyR65gyySS3poLEybXY00WsC6SGdbbzbzRqkzrUeSPcAre3lsEvlpUIPbT39VWJRuLpXMtMIb99E80lzf9Ew2gXHX7wzo5ZWS9rOwci2YzoKXS7H8JAFUuSeIsAOO02SsxIsOb02ZveoFEdcXl0C3aWVoh3FR/xTt+yfBq+lHNBENTPFUAHavTvxDH43o//UsNbTnebcP0r6gridziGWWD9GM6/bgoT9JP6C2ETjR6nNdG3uXi9K/FIXzFLG9U4irsQjYwTHud1LCA/0sn7zEjMD6yktNmiiwyC9gowUdKknpU1/sjOty18sG9a1zC8gH6kMPe0PW6LolCRl+Z/g08klbecBqjN8Vw6BKx4kEuyaob6Uf02je4c2fU7Hp3hwNZfVdGk3gskCQAsZ97vUn/ybDc2koQmSLgSzM5BBJcqtO/1U6/gkgUacn/TnuU8ZXA9wYJsFhvuE6mctbpI/2v1srqWaf2RDZIkrZ/8JPA0ES97DPp+NVLrT6c/rIhNpk26e7yBo7wuFJ8c3rKWJ2eMq/AUL6KlIa6Tj4yU26kIC6IbR5Ffe1lmk5LU8mFQ7Wof6jGMc4kL/QPT4lH27XysB7FW5KniT0w4REPMXp5ux4530boLA+gSv9c89sORZshDtsoQPBQpn33+OuwYf4QWoUDGVqD08ikLDRgTpsVcIjELn2PEafN9vFYbWFvJJejDafNtZUTV+z//QImfv8vcf+bfhv/2WMz7b3Xpk1rPFLlLn+uusuXhPamb8LmvUk27yuvYPOmjUqee2U7F8rO4Qn0LGRbCQeOt17UbiH9lBZzD8WDlcPfieF/s8/AVDxrFmh2yelBe+2Mt4OZctfF6hXw9VOlcT5Z9a5umdNCY3nTe80weKSmRKsrf1vJt45iufSHjQjpyBiq0h+BPlDKIpZ5uJTVdNLAQqj0jYAZdaPqkLXu9NOfMcXh38y4t9IwXbKkvG5GOS/wuMURnLKE62QHN4P1r7wDobhjwijb9+gCJBvrkiQbRkbPQNOvG+b22Kr80vtxlL4qxrWG2aI47J8YYSnIuPwcsjp+7y0MCQldU+J5Q8zd57PFr59nrEyc/nyUB+kvwJsgTh+gU0H6oKFlwtJpLLAaizSSLor0K5J1hJO1rKNwDJ0k7ShyoeX0wg69/2SnXRMaetxb4I45PYisTpK/wjxIlVX6apPD3bDkOTGWQR6R1/8hkxVNwOkFdA4wgwOebQusHkDfmf5KRNNEetzkGpyQSk8jAD5IfxBcqAeBAHwoR19wi0UyD+wBgH0EwkzluQJ6GEQlWeZwd0ykUOPGyrtvNEMCAwyxQyWudlcyJqDtg7qS/+yBCdjoQHGOp64326lj2qF20nfSUwM02lc0qguvjGvpD5ik/JXeJs1bgrI7iVtI3qwLfL3Oi4rubqNlF0d19DUQWvybrE5PGtnanS6dFQ3/H+qiGd6Kg15w72s9/4esOozxGtIEjnFMXHkV395NfsjohgfwYCuQjsdWsi0tOCLAUzQqZ3UtWfJyWDASiG6PQh7CVKbN9qwuvxosnpfDq/ntEQHnh0z6GmycAeg0rUlfbWyzn97DI2Jrg/SYkQmhvlRj0MfKeWa64P1tAO5bue399MfFz2x7sYWyms720TuVDjYa9Cubx1VJL4oWIj1pkky0OESHW1cweTr9abNKiHmdMXohmGeGQSYNPFDwwNzl3gK9TkM3NZtHPtX3DFzTZmaFR9rOkxYxV1l63AweymLvn22DscAoDQO8TAUpDolpBw9lNTqi+ndO8AJ02VmNDkBzuempl5DgxC+lh3t9VhKWH8QQfF+0d4fcNQ5lStRJxfjr8mEe6HOcXDC0Lu5PMJcitkpb80B6DAcPeSWUrUOQHV09YJE1Vi9SaaiSa7FJF17npWjbT98SbSkkaBFaXmtAaDyXaLZJulBi6mmTjk+q5EaeNHf2DaLLKJSOnvE8/4ahIFXvp68FkLoXeEmJL3i9WVMqer1Zfe0NpuAtOIB9nre4USWeP5Gcf8l2f/jpYW81+NTKUVK7O0lBlJ1e1fifL9d4XBUKCRzA8UCNXtk+HpQMzy+ahKJcchsogK+pRdooIUvJTDdyzcQ3R/+im5BUPYdBkotbIfgCBnnKNN21/fThECdGkNpuqw/ntGLzuOrZcFf6k2A5vpdKIHfhp2Rbps20ZO6jaZHM7oBey8LUbu17jYGVXI3jIWn4k0zgtcIvThsLUwaa+r87/d8X8K+oXx4yXv0ig5Xt5+ScnbHKNQYu2nc42SMKKn1D8PKKQinMg8FDNwR3C7KDeUAf5GkKBg9Z/c1iln9gqCJ8WfJqYwLk+dpl1bbg5Xl4cDc0b9uki1A4xu25GTw0l0ffPFvGoOutyi3wBSp9r5bUja7Td2xvxyPlNGWpHaqDl3lODTKOWGm2C0YPGdXcW5BZ6OvNyyQczOrBQ3M3BHdTZxL19Jwg7jDTMrNgOF5gCRsdlRDzwUPfQkk5fIDO2+TUpEtOIyj6BXEWLSz4AJZZM6LE2TlwzX3JQc3UloE7owRtBG5Xf+l4ZnpKQrUD4YqDpTw8brWD9D5YOnGMuuDwuI/VvoEJ/M0NQT1ZYLbMkj5ZZeYtDknPJ6eHU8GzXokknuYVuVnqKWu+KzfuA6qfvs3YYFtQJL05o+51b1wEL7PU23l8rgD4WaZRgQ5/W6ASeXEIPZ0QhZUTMjKhE5nu+eB6mZCfyHHMeCkPTxyD0saGJwRgqhP6vaaJFjqY0QUlPGXoE2HcdA/qGNnw3mqaAISSlvfzVs+eQK0o5BZyy8t6FtYOYPnyQg6ORw/cDyzO30Y3Yv561eI8y2Xog2VvTLtR5js5s7ysDtnqrxd1GYrqr9hjWRMEKDhYDlc6MCMdmFUdhJUObCCh/3rkRfceOygLi7/++oXlZZU1CTNBYpuV1sf8ZTpumVXdaJscE2CzZmV3a3TlR8M3+16LgfifRe6Um+6gPe2cglTb4v/WwbzW/T5bc/GRpTmkeuoM0rcZl9raABGW24I7iv2KtgUH6ahSdHY7dVe7Biw1h//tg3mj+3224ftqSF+2ZhsDmJjY3d6sjT+7cECDXkeS1Xx+uXMPDLc9eyIP5/Nxm+BbYrXPGZTr+bm807PH8w0gpPNz+ZjdcGgJCWeKFq35HKXrk/m5fINt9zrHbdB77olj+caiQWDRSdt27PghHBfb6dkTx+bycWts2ltcDI/lnfl80ia2NT+Xp3Zjz56QJBvHMLT5uXwjNAXzc/lEzx6fyzfPZZrhIqh7t7ysBt61MJzPp2xiO/NzeWinDi0xQTe6TGx4aGkOqdLn5yxqem46tGTbmMccmia4GdjOPHP44QFjAxmp4UihIeebTdHRRjtx+5JN7eQhfG68fWluDs0nZGKhNWgW2rYdv33JjtvNaOCfzsMSo9xzcDfPGAqbAReM9W46kQU27Gm8+aYTwCsGPzR/GDvW08ezMaCtnj5+LKMP/fKyRsKMtYBcJ2YeXvY3I2ufjQd53S3q2zxwshLOzr4dQwSTW1aQNt8GMdH2yff6X6m0qKe/ZkR/7b9uC3bi43nHeurFS/hm8ZEeO5aN4cs0PqaAxqJtAUIbo21S0WWIrWwMTHossU2c7bGDCGL4lic/hthLUAAwmJ5DMOihpbmsyYUaaXbvMa6jEQrB2Pmevmf4RAWFNoGaI3dBsYJ2wwTzlM4vqkFer6BSyXQkuFEfzBsrsF5UWeujxffFxYVDNjrIIQc99eIy7yZb5bVKu9tt9deLukCtDRuNoMLocrg0tFoSYwcHR15zaOTXKgwaCr6KVqK9Cpqjkii4dyUdufcYEEwW9kDkG13/8pG33XvsIK0+ERFpYGNARpvd3cMiaOE9MgDcOkgJApezsCTENjgEYwk/XtTNm126Sxvb7ObxkMYxaRKuDYlWhvylJQVr7Kaj9gXVR3wR/9fWRI8uRXHfhq1vC16W1fDn2zPWtwpsEx5uQ8KZhaxjYutE4AERS2jDg3mz+3226Xttlr02B1mC7u5AcXTgbohkvQCI8YUnjhXLGh5jStLguI1wmRQ/vjczZt4GveB4HqAo5SBvspRq0y2rAzy5YY9gXhf0H7pFbZtE9nWcZoyriQNa3xY8T16/Ex+78LGXh/UYYop0ZRQ1G/WC4+JVUVRbCI7mWLjwKLdl6WgeeqoWYAh08i6ORHB7W9s60EbEioYrF8a1BnkTA2xgYbjc0zIyK3lstQ3mUAieGLs2N8SQyLIEStfT99iwdxMWSp84diyLWNswawBTnoDDUzzC8iD9h8eKegQrhj3RsKGYIwufs0JkQ3BKHagOo28AGXJBGbWibWPgF1ThI8XHlKxkFuFHnT5XvRdifMGJY0wiGT3gaix/fGBpLo9uX8L+nxiiviZRn9XH5nwK/IYL6WwiGsCQc861jeZAPYHFeEyQ24RpJoIKp1l3F4nOPqdNMG+GykZwuu/OgzXZrcV6mVDuU8vqDmKXFxwnuQlPlIv5gjkqzioJJL+VyI0tg2FLri6bHiw46wigZIMHvovkBOmRvst3lB7q5rF7LleYtCEkbaiw2T98CXHxQhyY6zX0/O+TeLWyz8cEl5PN/lNtkDXUaRoXFdCvXhdl374CuYIBxxOjSxWPPBGvfEJZcwyI6hjOBT3rgOgkQy6zp1hzCJdegg+geFy5l8gVsNNJila349pLfSs12kqc+R71k1sQ8Wv15MKRoYYrhoowzKtZC8p11WkZPy2qUjAf4+ejrfGT8aOy5qX+tqrcJsOZfJ2qSDLDkyCyCFKSVqSQw9x8iDvfySRjFaXaiPxmkOJfWf1duS5ENrNaZNMisgGjD4W0ANDj9b67S9U+5ClqrIFIq/QvfYeHVuZN2RYwSZufj4fBR410c05RK06pb3GRaCjEKaBfe9Hn8rJKf93YELiQfyxLQywvsxJGIGwtqWxIO/YazwbuX5f9J7KeLbOqYLgtmJIOUy8wu1ctLuynSm/XYLSf5/sR7JUHdnEEn1mcP8AR/Miy6ntsBMKy+snAPf6qo/J5oOve8HlaIEKQHXa3MyMi04IIMKE+tgFPKtz3KxhuC+DQYkOQ1q0qeaVGZlZI8/PYhfk5G1A2ERHF8PdQrhhKKXnUsyfkiRxPzEkXRWN/Ud4ZFQlRAwjvcKd5uGOihTHA2TmzSqpOqpxAa7WI3b6sQN24KoG6OcLNNS/HBLa/UIG6PRSom6sk4TWkY4gNVYm4DTagPUJh25cRrotb2jZXMp1tEZu7w+e9GL1e981RsfqMuQqx+jG4kj8pCJ8xa8jUp1lHjWULbXIwr3e/z9Z9T/VSqK73kU+enT1ssgR/T5uMAtUp0x9qJ9SxPB3Kw8X5Of3xd/3APyprjj6Jt1X6CISsk6bfI1p50BztAfb89UXTx9X7KAQ+KV6dpFSI53CqpM1F3ccD8vwJPC/XL2g+e0n7Zy/q1c+eqz77uC6fPSPPni+ePbfGs6erzz42fJZ1v+Tqw8Xzp/l8T1enjNxLvc7x6nQvqkqXD1J0PKVzru99GvIzJXXT07cvzZXvW9T9nrbVdavZBrLxZLGZx6Mvz8eRmpdi6Qmdd/yYFjmmubzZ+8TfqqP5RqKXMscm9m5zKXpD8UD9SIuSd75JlCRNSP62accOUQK+G+3H0d52ejedmJubw4zH0bZJxUnr0JIds+Ol4sROFF/HoWVBP9AaNOfx2ZrPN9imHS9ULtAvjIk6ooMvx3G9gyfGbKlq2WjH8ZihNqZDTQ0K2G/qfV7ub5ifyyf5VPm+Dio9zudjtmk3UHNi+M6mV8dABWWbtgUWlhMNbdOrO6jp6MiYJ1FGch5bZDdC4yLIOLl9SdoZakqwvPb4HMXyijqkQF5DFRm9WG2KzdS953K77jhKNViuwXgfzZpM/aT6WQz6f1Qy/l8g/NwE5YnGgaN8kFe62smuXsauvj1Phl0tsyurs012czbRUzY5mmQV7cpaaKjQruyn9kUftwm1NM3VKo6sxSzOkvPgRxduHuJCKvFYZhWZoKBXAa3dZCdsjNNQKmQCSy3grpxcyN68RdjfFjyPuhYP0TYnsHJ2O0kx9fFcH+IUQ6uPoq45FTqBTXuBPz/8EcmPlled5NqG2NvgdouEX+HtS1CmpOBU0xd1lyCTYAtzswLNH7Lk5dkQ6p+czK15UXd2yevU+GjJxleeUf6Zeh7iWyjPiAbHto9l7YoSpy2M/zkDfuFDsQkXAlDuRS1ij7eFCiZJ3+l9YSr0vMGfJYHmJiPpdIiAICSlhQDXOHawK4SscexgkkDtwIz89cpDyAVWY4i659HoNfjrWFUsQx7KKlBfkJ4RHVhWSD0i+ZqVsJI3OfQV/DHfWZMGjfSdhjo9UFKML30nnCC0aFcEiwq3RjYRiEle+nJ5aRzOWx354wLSX7B1Z37zTPHEy/Im33tJMfP8tuDbATy13eUJDWxjrefuyBvlczXRWweJbZTTGWLXrELEq5ebsOKziqSZt02bHMVy3L6EggOsGN7AYnp1hJyN0blOy1xtFiJ/RwNHI8SpoGqw/JXwmGrIsTGsiXgn4y9oTF/5XqhEmlmDEnjxemYwluM6OoDnyQB2eom9wqggCEQ0vHhnFhcjCDjMY3mjXIZDvtwyxKKs5lW4gizCymra2F1SfVsTcWm4H++5yY9lr4xl14qx3IM1lofEwBQODUxCUbeq5NP/IRhfqM3ruS+HcS5vbxUXfyPmuxDo0tAG687er5l2EkV6z/jvnQCVh+nSyVKGL9sjkXL0wVDwSpW8xOmvmiQ36a/AOdlpqGX4lmcPkPRYwR0NMRNuxwwKTV+2O59fPP1Vk5nE5zqL3Ovr/e2sZ2cPz4RSWyU+UDibXlFXrMaSR66+x2dKi8R1LHJ1uHsjCYCNXCi1cnApsRpMx6TAK/NYwXrOwJdAvI5RxdFO9tRLxK69e1U7VvOOfHXAocfTvG2+9RuVWlz4iXflQZFvmpbIcICfn5UQl6XeNccLCeXMTVTiBJVrJGJiwHyClUJBQqllXFueVtmmlWL1q5eVF6uPJdmkbdtNgKC2naTMW9pFhzK2bQP3bcIflU22TOGyEjFEirVn3YXxcq/2MGFD5PTT2yvWpfS5tG00FiqtjXdr3rmH5IB9RpU+I99nVIVM922z7jwDrto0oyEcFVXaA9mOVd1o30042g0DJxcCAb+dAjzP2dMOq49LyMTI45KyqNK/01lrRaMsaplIrmMJIh8e4F/rdEYrzx5Wl5zq6aPZ1BWPOo/czhk5lq2hwfWmbBJHi1Oxh732MgKGaLjmPkL3c/bY0H1UDVx82yzrnzwHLglJ23A4m7IpUSp8SA1g9XDP399lwpJNvdo307MpduERbxHb1LuWykmg2Sh9u6GXr92Cs1OM6F+J7OiAbKDsNuCKDLihLfgznU/yPr6n+Jiym+01UOcApLNrBMA3k4HE4azTHA8SV33L4rJ/C9i1bcFBfNxR6Whvdo3TWR1fd2WbMW49l23iyl1+tbl/I3vnnpNF4CxbrJULA9S24OWCS7Tvi1giZDQfuzP8mTBlO9ATfpJ3ITLqqfQ0fRxB75vvKPPQvzl9mGP/9mwz/rxM1pt7sCmbZFXx8EgW20lY3yZ79RdLzV2/4d82684VWS3S95gn0d1QJfLidiBeYTLyNgp59FS22Y+lhyDYnsomfYOXtKkVkATqGDtvIgiSW39x7WG/XIZ9N4Y9ZTfZpNszx+3kXM8ezTc5ZdPB0kt9HoNHvUcuRNOmQBHETwPxEp8P6t6Cp42PeOWaARXEvZNscd8aLSBCyhhOUNOWur/Qg4fspm+mmgdVtRFZ7E4FfQDKEGCXH1kA1ODaELh+wzB05aQ0tuz2FJx31d5cdy3B9MHA6i4e3YSDTJx8XyAQfDLINoOrOIInbj2MpL63crvm7SabPnS0Z+fyqQfyyEnN967t2CnbWXoJUuf9PQuAG7cYFKuzLTgRZFOcYZBt8apWd8H0h5W+Tmobob47NwOseLGwFw2X7QK7eZyf54wcxfMmn0p/k5cumayLvxcNyIehAifGBGZ3+8VS5HL3AMvsnZ3No376LnQP/cwWy7GdYU+PGdmuk/Le07z4sLGTlktlqJHZYqd6ym62Uben7DU26votlmdO8ZkH+XmSn/cZefaiwMCirIl0+m7+uKhz7tElnRej3V2FNi6Yls3c9ED6W3zogoeXxwEvI5B5bgiZZ+Sd5wh35/UQbjxcnpb7Z3j/sVX3oWyRtzysk2yTrdnNIM01UGgQ49OBp8ZTQo3TbLIVJ+VJVCsYkTYq4m6wCNZoZokNshYimj0dPPk+UXU7ZTs27ecbB9lESemMUDojlE7iyvGHlC7yNDwUTjBIqg2E0gUrGqGSTCTXSeyLQDhSOpCWmqfuwS5/QMzCil5Xvlb7x3NTUjo6z6rrzUlwGTsHWd1uMPMrylAY95wZJlitu8YtbcXwbp9wCwkvgLUmifzpcxvszjSC/oFGs0kbuyc6YObH7OQDeMVMNxuzoTsZ922MUIRc2wbi+SS0qXln3+0cRLaeIORUY+Vp+2QEc2MmN92sIcl+YzmkO5mfGmE1izOMu16ccR/+UZ2NJVe1Gph4ZZpN1lu3m+ykrXWzTRCvxW3t22bde9UeH6veAh2YGqEDyrZ2t6OeyqYogAqE+dSZguqZ98BuslNz2SZmXNzNeEW1l3L1Os9oeCLzAF0LKCUtiQraInlxTsY5yy2GNllBO0KyoDRBSPj+ZK8Bn+dNdhID7rgvuxlo0nbu6ha5vhMcTRpxIqAhmmRg4qC5g9YbWnK8PSWV3qeEKMx/95Ld9JIRShSSFPtOwWqE24Jvx8fLVlEZWm1CcBzhtuCO1bfBb/Bte6sk6KUrXgdq518HshaSrIUka6PoIxQdLEgbPk+sug+6y/eR7jYgkLv6zTRxDUGYKfGEp2/e6a31ecM1wJUj1lhSHNDtKbGbHmDmnzHXuBXqFDu2l0lgxvfzT2OGfZ8ZToB6Z+yv7MQpmc8Zjvcxfp7m58PaD/iUlhE/qCURZjFcM1wTM9LlRb9EfPo+fi7y84SRNbqgkeq9NkCUvxd4/V7Kkxc5gEv8vMDPxzX0PyHQugzmPAfTsTV39M6+6yLEgWDnIdcaD3wXhqMEkfXgB3IZksiGJLLomJ/n/QhBJlka49JPVYZ3Sh6TkTzGz9P8fNgUa2X8Wvm00n5XcwYQc3PhW95m5vYGU/c0vpfnzIlGlNUzIteg641Te7tZi5Xq2cCwoutP/M2HgcVa1dXLg+/Oxp3K6l4WlNdGBCahR3lsg+/Jx2y9z5SmjHRCwSm4pu1mTt7ZvI6qFjXXGMBE081qdpyFO8buHNyZ1b1oiMz/KrEMiZW3QInRZ4YnokMWTMToGv2sNlwCuJv3szFqFWpuKzimmtu6p23sGPD0B/76n8Pb2uSylzt9Esg6fG6W/OMBi2PJhIKvM6p33fG5fFPvVViMQ+ECorI32U09Ls4ieGl8mQeTN/lAkiH376YHWKOHRd+YWrLLWXcFiw/Q/54uC7lqSZ4ecaINdx19bnbL0dO+KVPslQvw+Q7XkqOLJBqzuOWbR37rma0i4hpxgaqrU2TJSowwvrJBULSN9MWFbAW7XMNht3bs78Jmylx7WLbIS5dIFCAjtWam3Cztx5FT7DniTnr4qUvm/foBamGoAwj30FeGu6R6KtuEzkEpWLVg2D0jI/1gkfnmiA0ZD/jDMeuMxP0Vr/Y4IoKavhAQP/aGd/yXAoFeiAQHRMQB/FyMiT1iMJU4sJEcsgtRtqkyWiQAd+ei8ryfkVfwcLOb85E/pY9F2SRmxMMcZVO24f5eIYMZPBgqLH5kO3vzWjfX7qK6uc1KErFtwHHK0NssINNDWLPxXdmYW7DxEbfwCp7FCNbhEv4DAkfd1rnaNr6rzOFdOYkRTmIwM5tHlZMY4STW7fisHQMtCIqlDvxRjESKbe6pACSgiZ03pUhky7bIkx72EIaVOhlVxJGPwsvDiyOhOy1bcJKrdl9kp+wk5A4guijbQrQXZddgd6t9/L2q9nEq6uM5bh/7ORGlv82dD8sbp6Kce/BglG+GXBC6C2HfXmP5ioshASAsNj30mx5mzE2LwFuuQ0z4NiMUVKqbLf/er31SEojvtoETeLVmZpZJJi4G/SFnc+4m4WzchQAws5nvpzPGpaB4PyREvD/INokhavG//dontaz6ubDS2eNFZ2fCsrNznMz5YjKPhdLZmVA6S96RXcvYBhmkxy1h3147LBYrfS4O+zzJPu8r+jzh+1z0fYbudKWDclCnhh2cZgcPFx086Ds4FWabEPnyKSVuL+dkTSoC+E3cyW3BOS7R+cALcGx9Zo3WftJ+Bc8E6D+EJEVA2GQ3swUlfQyLvT4cABAIFZDcZfNPBdmU2eXm7caBLUJLbxXkFoCnn6y6clBes1PiHLMoL1upkMIyBvk1XMgg31LcfPiMgkbBCJieYGjsXtDHSTvFNQ5AIKfsBMqKOnUruLNPqj6pmq2ReMxi+KP9gZ4jvEj7BRLjWlWSxbJAAYBlaUDoBRx6luKSSTCjDXZSZnTyfcpLotMiidpsEnLSUN01IomW3L6oda/UtuCmZ6RkfUsnVd+VTaXEG4y8p4VyVFdhuXC/rQal1YIxTG1lm27LPopHH8XNJ8Wkj6gZuXybWAu1z4EzOiLjtjEvKKwHU2ssgU+bErUhT1bXg5y2HmSRXesx6NgTOt6IJhCUA0afSTH6UC/Qdjth8/mx0ISo6TmUdhd8uj/84UqoVUKj4koEQ5uNDdyOmSy68meNu3EAn/bdxGyvRDEjVWgGbZGpu1RqSuMgo2/cXbLQO5F3s7mPbGYgBB6yc4YkXjuR1PPs69/2cbX3aobELhu3zLKipQTZIlz/NioYzJKNe835ud7Oo1l89b1ihnHvLT9674d+93f+5mf1SyhdywSCK1/zAt7gEVwemupyJT1l46MwbnSpH6iI5gi3LoXr6jOVNp3ExsmvB0bPBz4LiLg16rUdzs7cdHToDfDIGXX0EB2wr0GBdasOymMd/0Dd+6bVxSstcqj/HPbF5TGiDQm/6CuKZnQkZRLtyOlZ75ioDtqncnfj+4Fp9Sw6/XztsHiA0/ZV8fF/5JEz6nZJ1+cN/ZH7sc+rfUTOzG2i17BWQ5niXvV5Rb8wevO6Vy0raEZ/jbivnhvOnxSBvo4pNQPiPZ4r7/23zqJIUgdflbOyCowJn0U2KGqrmPYkoH/kA974dvi3kv8ZGCPe4E+1b4svqOzb8nuKfQuPW9V7AcOOVPlg555cFaW6F+vfSofE4ucZNSfbVzqML+46ii0sf9bvLTaRATpXsYnFYMqYg7Li9xNwyAkqwH1pWVX3dfk92NfeyL5+9sr29bMj+3qpuq8YELY0N1yiYMXWVpw6O/fA829kyQJoAoMR13q/NAr37rHB3IqdrXq9P5J8zOii3H0NDdzJ16GIKNP9SWkJ443KQRtxXm4ejv27iUtrTH1AkYvExPj6wDuYuI1pkVCr7VYSEV9GTe3JQlLm7Qr12i69VpLIKDFbK7f8SDAr6kk2Y0I19zuoqea+BpiOxSAuvlEcAwJJRlbWF86Kt7O0QsOlAxu4La+0jf5hh2qizNWiBxnUkIsaN+Mjh/NAhigFrYqRonKaH8KwerF0fQbHH/46SVEFi/TzGibyy3zK3YDUslZkVvtG5asslIpf7Ux/LFbamDAIeSpf4LP4mBdq/+UbjP8Ct+LkYSb00FhCUxYxDiR/wm6Z3LDWMoLa0bCoXCepdTUHTUbLFM2ZNmifPC81dxZeARitlmJm8b8iCRy6FmeCkfeCXjBRgJZ2GIJkiUvufZZJFyL4VZ3UEjqNglIndbqkkeHvenMzsmogdUbgtl1vrPw6ZJndibXgDSzlqDe4lbVKbt5SUaEj2zHTrb1Xb/E/yPNjtzQUwkztvKEoWudXf1nPpr8ime5Y+YBZ8XYoLe4jiLpLTxsSUHSZM7HqyyRLTugJaOgJaAACWjyHAHdGcHsayuaDPKSumb1sHzyE+3fbTXNzFE+QawkMAWpgfgXlnR1K59p9Fe347iv2sDQEB1RtNhycrgxO+8Hp6uDyYlqSUNCXZVn/Qe/uD9uIX0lL6a46raCqQ4eJsI19smO7281WW/pfPVsbMloUKi0bOtMXpblO38oMVeEOZahi4QrAcqB8pgLbkUINHSl8Ew4c00gc6AK2kXWqLol70GuAXm1HfnYAth3OO2HCJticZJLpW01ZoRwME80jHgoEgvvMP/RWI7AOeKq5v1N7wgWrIygtn0Qjag/cJfAEHDqafCphashMOxQCbhWHtSwyDIz222owdmOYhEkYhkmSJEHCf6H/CP2vEP9UGCVaGoaGN1lj0dFPXWGhHlczuepm2s0jGU43iwR1Dhv8bdEAWWPZIEgoyJjEGYoPVNKoTCeO9ccwV+W+etYFM3mtm7WJayzKA9e6eeL+VImaIXGfZE7uxP0lsvbS9zR0en9X/AfrcOZJf9e0zOoDpSqgpzzoqfUOlBqBPMkfQsBTq0GM6RYfyjfKaVnvXcVrYByC4WhtwHZptmb9eJu482owlsWNhmngn26YUGvdiPgr4PWw0YhZbOe3YdmEqxiKNIVH3N8jg2EdapM6nB/bTqW/w/wQd/dU9dwcfXE7anXQw6f0rPtLekjEzvbdgnuVSZf0FrgG3KisTdw/qD3tWH46+fMcljjWXwWDbEzXRiCVyP05QGHF85qg4jSpec2jI+1Yfa3bJx51O6Sez58pmlzdn6s9WWRrrGcjP/PoRnUrtUHD3/MggTx5YtUUsGJXane7bZX7M8BNq564HZmSIUquOr7IH0Ip5gCKwqHcUrIawS5PmDnDvo0kZWiNrxFhpiZpPGLezIqkZqg06uosh+aaZY1vSLMbgcR6Kptwiic6EgSUSoowp/dY5bbeMlvY50uh+YrpRB4KYAvKH3FOBBaCc2J0+a6yEnizMKnApHLfOytGRnFLu9LxlI5phPareO6j92sAB0prBOuSBjn3gELV1n7NrXJNq7qoYFd0At+8y3cxXG8it+YemSvSZzdukVrtUkMYmDxX7vVv+/hZve9q5uP7opSulrKN4uTXwNA29przcC5ZyiaCXXbCTs5lG6++azCwG3tveNvHoUE4e8238mcT6SrMUj7RW7j3DujQmyVc4u230FPUStakWSpD/ZLlNVZWhhEJPOKdsPv97l/+/fP2PY09ZF+cuMHEgedZ43mJJo6NdnI+n7C1pd6yviff3Fu49/a2sRN281y20aqn9TqUTkmhg7QbJV4g3RbUD4qnpVVu850oYl+bdR99o4YjZzZembcZznv8iDWH85qjqPW0Jm6Kidf8xM0tbdVbsONL+cSJfLPdeMgraTB35Oo4fuzpTpplszfazXeImmU4o1uEi77iPiuHpqIwpU1qAZNY5yCZXXZjD44Uid1oo4fyiXvtxNFsAqZ+iikT2ca1qNCL2k1SvItwzhBrZ91u/AYppQESv9GT+DpEjA3wiNhoYzhETnjM1AaOw0mu2wm7MX3UPK94GD/fa54fKGEXJqBGrNuNN/j8HrDvPIvcBdkQeHa2nd6Tt5lAIVO2RcHNHEFZEiVEFTnNHzTk8lqwK7OgcfMqGI8c5GKHyiBJxVbdqLo2RgbZ2HWRGyt2D5p++j6TKzc/w9ymCzPtmm0yu0hIcxNKIYuzBLhtcfSPZmZpN21C6XTE6cO0g6aPaFY3d6y2njVajURekCvJI6wip5J2yHs6wXw5s8hPuMbZNZ7O7NhTs0WppNG3zBKNASPSZM9wSE361foRF8MFwcYw6lUp5IpfTU+aeuWVoGgR31XPGq0gAXm+CpIqvXpHAnSDsT0V50iGsWAf5/KJg+26ABrO+Itn20ic2AKsC6yhTg/fWEdJaqALKOGHe15Ww+ayNiTxQqPP5NvrCkNjFCD62VhiKxJorskRcTYJ5AewJx4+MLvEjsFjaSEbI0RAd02eqYEEdE3mxI3htLFV2TFmlDypJaXkS5BujsnXDjGvBJ0Wc50+ZrDGCOgOuzCRIwhlXzc3UrmHOVCRWu9QUTyY2RNEhZzcwj7pUuc1CnmRVk3c5ygbGYohuTgZe7lK9ATecMwg30Hy+kA3FiT1MIsZlvKZ1Kkx7oUzpTLGBbPiREzvtrXVFsTc7t2f+8xfB69YT7EB6wxSvhXZ7XnfonHRCOeWvGZuOD9v5GeI+wvFM0ACBxKLNGq+OhLL+kRA023lfuJ1UomEUi59Dqg5EaMI3i5+kLC356jOu0WyrQ/b2YDKp910ZNIDNoKTwh7R4EK9bbDS2jueWO0jTHRGAWAZSt4dSg2Ye0YyZYtGC2sqbm7IzIdaDYDD4mnmRklsI7lodLDgefi2ch+6Lj1rJF0kLpBot+50p9+k+ytuuL9a2dR97rpMJ943AzV7MTVZGvfVM23lNkPvQ89Et7mIlAGziweDCscrkOGeMyP5AmWtJRWQew8EiwRzlsS0gfvcdenvSyka9w585aCxWR88BQhFS3SFOnIdOh+5+2XXRE3gM///vkDitLG+CMJWoGJDmPjgqSIBtc/AjxA+HCJNP5AbGZAinV5vLL75mnxUXOJxlnXv8kgnr9Lai2LGhb5OxGFAvfaqOgL+nnYJu0VxcajoTKGio7IvKI6mLFk4I2kTq+dQqjrIWgc2HGAJkq8Ula1V7tIpvWfWKnfyTfL31OsM/z6Mv8mPG4pHUIy4ZXULAm5GVbvaLS7MusVHUCC+1JZKcZrlzi2+FspN0KsevlFxFVx8lzuDX8oZVhJc3DXrFs8Ee/D1dHAbkxBXnzKSc/Uud4FPFX2UnbpAupHwpptWvpSl0d2Gu9zFNR8vex/2F/raM9fQpLwQOZ1IFnbWKWHa76JQGpKhnjPJAhOQWIVMOl8LUxK9hJY7e8I5+rUBOZf+pd8hrlzFhYvf+GbkCzaZbLvb1U+oUZesKu7ztQGLMhW2gh9cXCjNGhdvOvYIKnUkP7TRjEsGlHOqzE8C7WvkbujTf+h5/WwDQL84YpSw6Vtgk8F+Otck/Ywe1jfnjaKdbQCqmmGhXW0C3eRNzkgSIjWhxdT45UmC/I6oeoAz2s22CUBs4iYqqMV0+vkKoQ1N24DSuRhH3tzfrlnFDWxYnX4Q9uh27Bay1GmEmE6bm7crKBURNzptbmY6KsGYpYZRbxcNIx7Z6AJgSSRriUnqboaiEAhmu1J5B1avmnsWcyuLb7TOYjicHclr7tUfCGdFCx4JYeJkarZ1OGMJBV08b2+DoTbT1Qc9Aeu4r8KJjEj5Yhn6bqnKe3Mel0PGHe9TdkYPXJPmClwLjtig7xYDpAjO2pgQijBSDbqxHTvRarStFGQ3vqYRPRA0n5D9pOaS4NBmilenbHuQtW0LNTcOZy2Jiz+r+ukfmbwNxVndr25C2oVk01BikKggTGuL7HRlbnq7MtW51XaoQOZW267Myrnx2sjc6rbmwmJexDdrzAcccyZDc6aYUt0tvMI96y4xzoiq++ZyNlkxEacTCvhxVnPXZmPcf/cvauBm9rUbxQZ38CjtV7HtMHtkzd14Z9898iYR8xCQ6+BEKDqe2HXp9bG7DUGLpqbQpiInSE29wKYuONJn8ppdFPZ3Y2nhrR1bk/6xkdF1cAs9tJviGwv+H3Uql5e/fzYfh2Mbq6N0wUdkLff7jSy1G+BnKt4XQz+MFcrMjqRwz7X7tlkmse1A7wufUPr7UdMZTvh/YxOdeGxsbCLGDxMFExONCT0xESopkg7Fdm1sIpkYGxtjcbb/oWbajdbGRGKHJ93vN1pRUkUxVb34WF1pE4RbongLYXKXBZJrXVP9MVX8eOiGQLU2F7++XqvWZPEDBXQ2VR+aGHloI+KhkeysfqCb1aGHPZwh/BlkeEM2jnTosxJyviufRD7IYJcdB4Ect5MPYHXO/Ty32tZIKiZ7nduzhp3shSeySdsgyhrPGnz+IO1PyOcPC0t4l/v9Rj9LnclaEIA3SE7L4VvEbIa31GbdTt977fZs3E72AvQ+LraIrOF7RWa5DYIeURHP1vd2M5ZJl24l3jzqKTt5NJ+8IWDYJ/ZAvPaQT51XzuKKe3/D/X6DkVN5q5tkqZ20G9IPGTCAEw5GU7W32x5jJovvn7WxnRDbb/GqF/uQxw15IxuDiafVgrw0eZAjBD9UjC+R7ci1u/9ZVnfzRond6/KWPIZUUkOFh5hQCFdTiks4P+NMr8Fu/Fc7Bt6v3WomkEnZOXRoPCXOAqHZOD1vxCFESf0sDPsbUD+LxbOuN8i1Vuf3hCKkJvlrAr3UdvsY4rBva+kHTA5/9LzBGIO61YMD9MgKQb9QjLrWz/UBz0s12u3EvRC4BBgzkeGA0KTnDQ3rQ293EqtdJJF8KzL0yTsbeGcD/daspktTcf2DpnixtjXh+Mo3ABu8Aq9pMyNme283g2BZ2cs6R6Zs9Oxgl23buo2tdl81/hXABerWdg3qCFmoF6gbGJS6KWtgzaE2qNI7SnlNkDfq1q1q1+zG3YzSpd/v0Nm66Y2NwZE+0qumfyyRvF6ma4LdbySJv9a8jRqO4eNefpSWKmnVEuBpjGYMh6AD+LGdvd3ce0Ta1mB/23CWddvC8rVtzbb3A6Ka+9sBF0vbmmyHsqltYUmV2ylXwS5yCXEF1kQl7Rq2I+1s0U6WGo54TmUJ7GsvzMbIINoxYRAz+gswM5lNkndqHbByhXJ2luG50F3nUiI2XLBhZIP0fbotxeGpQpjIIxY/CSQ9iK9ZKCbUYNocBIBBmKAyEQIVdp3WZ0U9PZeMT4fF0zbcJ636kiR8IFVqJ5C7NCpK44kWccKa/vVmIkmS7+bIpw0L373VeCY3KGqnuAVKofSSu4X1OQKQ0Z1AbMY178xpbJLtMYP9XbHQBN4nkqKYsEAYrU5+PVzTBLeGUU67xmBsg9ImCsK4Vm80k1Z7rJOOb0hWsgllTv7OWre+1iCL3Jq3vm79W1f+lKuh+DmqQBYNJG/dms9+jV731n9Y/9ZOte6t56qnP5irnchVdf6FLOCzA/X8svjYs8e1SpJ7tAnof+qdxlK4oikau4eEFpUvm4t51GvOH33AE1zxUPsZfTsiYCAai6fPA14P4J+ENqr5PTlcQwf+QVh4xJvUhkKmk8OSxnHR+HRCOLc3U9GxeAbsP5EodDO+Sv2ihBLvy4MuDbTBbl+LEfnbgHEM+0JtOY/sEbNDCYgZ3raq5Pemgg0Les5AzDsdDvLmVtAmeNfgiLwbIcYvIdUfd3/UyDZa/YZcvzu7RvTtBUcw7s43so0gS3/acH/cABaZzce72UY7vjvbDIRzTcVH7p7K9xexqKpF5i8XIOIqJLcgaHOjHRe0eWHcvf86xGPP5rWu+/FN7q+vszVwnPo/dl1QoFbo38OSiuGXsfH+rqhXm4VXj5SSaqIEzx8aMBmncl1K0f+RKtomCkfENINsZ66JfJP7KC3PTLTnf0O3iJbZhEOsVwASKVnAY3fdIJ/Aw0XPp92bMz1slmQt20R0Z5OhdRPkYToZiFcNCtJCiHf/yQ7H9v+wLMUvk/gnEpEF8SaD03z88JvY7j+///3uzdX5UKzACxB5OJEFSDNkOxntJZ2sjktQVrnr8H9fl2lea9AIxZaBTcESovCzayDl2GuK5JXx1xlltxyfy6/Bxkrk2DVF5Ng3QM70XdwGpHzNA3lMMxAu1inG4EzVbU0qw7JxjdF9muI7VhUAHmAJ46yGRdsval+nUHiy5a7pu8b3QAWQ2k3u42oGhkfU2YHo3ED8z75uhpnHtg7VDWKHWHbIhxwld2Vtt2AThhyN0fW2Lstva+SlbHIXldag3WOztn0nls6FYAnifQzjY48SjOydAGOmJionkPRlAuAyart9ENNkN68V4hyLRjnzSpsiEI1zEw847gJGjphgW0cb17gzC1wT8UwcH72vg8JR12LKzTtzpNRJIOPBd5Pr0h3YTe4TagbX9swOMHzb8R26xmAvco+5nzMCgraJ0M3FxxRDZr87b9NUce5Zgyzhqxu27Rp3It1K7WaxqCLItlYE2UK7TAVFIkvYsLXvyVNbu3OQt3fbBKs3ZmMUkzK7bIqEC+EuD6m7vpEKHG4OND11m0D/kbgQThxo2tbJN+mybVIG95RBVP7LpZtsbMdmusOfbajA78rHZrq2bcf2dREHYzfDSo+ud0CdMPWGbMrqN4C1gPmtPcgbUlVv6pTV34EMMsjs2M9rcug4zNu4Aom4gdY51Dw5wEztAHNv4Um4GFgf/+zyf/2bD3td69PZ2sTDIGDnQDeLcZDivGbrt0jyeTm7xVlCahv3CSWRVvXZLJG0vAuvcAu25bRtdRHcut8G7vv3z+ZJF9H8Lbfg5m3SZbVkPpYnbeX+X8pulGFcCO1KnuxuK9ekkSm2iWu+nKOO8zajq7GQGHfj5bRjtnHQYixjAX2QeOFL8j76kqgMoXYIEXQNhPsqpjfE8GLb2t+lOsk3CmB/jNdrB865YVvuX8Ewus+LDtC2DuftLhSSLQh3e/oY4phPJpNPyhisT2tlxwZg9REpDLwj8Qt2A3H3s16ZI1DuFUuUdPN44LScBEnl5naCsG+w8cAZnmXE1A3yVFyNqOnZ4Z4tNEBapgPm8yteC+ukHQMdHJerr9jf1iVxG8cBClfQxp3WWKRx8KKHZ26LOYHsQV8hBNA1DmeB9WLPgW7ekFBhYPMAkju2uG4bEnaEB26h9aA6Obl+wLteBDbeQ2F2541qyibYYaJDpJT8IOoChEB6nVsIAiT1D36ZExUsYBYb4tTNfEk5ity/YtW6Dl8tb2k5bHRjbxevarkG8tr5N9Zuawe4tB+aj6xFLQszf+F9e0UQp3RuodNpl8vUqSyTEITA1oYDkxXlXDsSllOz9StfLYIABhsXR6R1WOqdlqtSrF7esC3bsC0/OVSLaBUEqH2brNutXn7faVtuQ99tKKTNlHCVfpD6ixb3xO20scPZYpvEQ9TYCLs0hv8Fu7TRRm4LKtO7xqwclcAlB9rKtWwwyGKPXXfuyqaQ3av8+eZsys8fOz5GBItFA3a1U2869QZxFSZinXoTFWie27LxqsNVrjZ2pUPSOu7MYeYVs7NZXbivmpyxNquNjhyzWnHMiPsawgKSyOcInNKvL4iI+0/grH7JB+cs3p3ktVJnVz/svQTf8abKLLWR4jl5jb0OWPrM40dhViqM23e0qT57DkxVsTMI7rejLBpwlmAs1ghqD/K0n8cDG+wldFhryLaS2fBvzOvODGxwK19Iz+jhnQQUgsy0AMSYTYa4Ih7iClSlQSRKvbhbA0VSBRy1bfqUrDXwyukQOopGsq0si10IXGlFjsNHXbx3ko8HmnFdp7Qk8UFMWCgZApTV3evNT2jGvoTujVBTduGEgbQhZRhAKGEAodt+vdlq+esgcs+4n4FaYDu/nsTXQxT0wTTS+PZCb0eUevHQpcG6pQvrVnC9OaslkbRTbpoyFbMSnNXXm8dgpoQLQuQeY+FYpE9h2/R/GHnFgqQEDGFLULdmYrzH3KbNXmHBkfTz22YZUund+KfNzt0SCa2uNzslBdC1yCB7A8J6AOFYi+h6s913ncImvmBDqnu2JKxTs9aQEmb7tLOw7vMFSpJ8UA0k79mJVed6+bdClxMXLw8QlN9lPJB4IcTWHGbYipWekfSBKTkknzeq/WVMXXCKP+Lkl1G613uQSCo6lltEJcg8HuQhJnagm4chNVLAfeFQg6SsCPTilGbDAYL+xVGHPk2SjeJAl0VJke0/qj4b9RFEUT4diW9oWClvvx3s+bVSMHDCGpZzTt9qxIBtD0sawX2Hk20rqi9rVnJ192+yOv09ZjPwZUJZWn1YmjhExy1fLTtI/xQVRaWUsA1YIzr9A1YQhgtO8uWs7Sg5OXPjnUugwWTuDAWeKfmtuo4WxAYXrrDLLAzDW+iywN0iaZHyVAEk10B4VcMAsJUmdzCMsP63sIdQom73viusoCBhVoXLgDhhFYhet8aSouInzprEQ8UD6F8Qg7e7HSD9Q5j+Jqr4aokmoBO1TiRVz+7Qx6kEd+URwrBihGFFEoYVIGWyJFCBfnWRJWC3MIOhj60S9lYjAKuWME7Et7VP2TToI7lwwMQlPlQ7kLFQ/qcLYUjXIRu5z9PtWE6C9/uJD1d9hwIXshAGfGNi+sbkEdbJ+uaHKx5CNmL1IJq+EUHtPg/tpx/KMPAGR+t3mJD1aw60i+uSgKQIa4P5LmqJE5ysZUBPPw8QnAyTutYwA1b6iUV9A+cQZE7Y1xbjxTpT02RclrWAAINt6KzHABzx8Ap3KAF2kFhVuAVhPfLAhQcYSwSvr7g6ZdBBjkkqQUerIQyrkQei47+ShZAdlCnXSmiKCE8CTdqHlhOiYB9GYF/MwL6IHNUWWwe4LHK9bjrAKBXDpsjfe5lm/j5lJgErPyW/pTKzIvveNd7hc8Bk0eUO+kvIBj66YDjK5J8rp4ylKgYVtxKE8+wmTdA25O+kU3y3JnkuiqzLoYehKyQGcCdea6Sm9kxXDA+06Z54rZnpJm8MTW0h9DVw6mWCc+O2gpbRRygCeDB+p/S4Z6krMJlAU0wQwODO9FfMbpmW5iLBGIQtBHDEBPYhtI7GOUSMc6gVDrLkhYwPX8AuIILBwcjJOLCP6CJzLnYuC10qtWwIMMbVrelKwrqmNd0kbz6UYf0Ra7TLHZQTv53nf+eAwVcQx90vLmQAI9AEXEOSBbePl37bX7qGYBwJ49W8lW7PiIJv0WEdoGlYCa0ulk+UOMjbNn4oH6ODPNitsbmsxXkYGFQKECdPkZCGC1fU6EpKBqzCSLa1mpMo3jw5iOUKxAkjsC2UScONTNQzMoJaW1WeDZC30NfWa31r9RbdRm3toTy51yZHwQ7UCypW1FrqLaR/ZZLJ4tcwZhiXF6WG1JDdE6bjBfJnQri3KZJGRm6QeUOpAKcR6ISY5yyS1Hmxpecc1gF8RDhtTkhKtheg2roiFpE6O7Fk+iAjglrQpLL/NyxRNGcN+pLtCb5re8i4ceR0F+Xm0wiV1/bSqRtJ4Z3uRIVKxocFSRZIY6M9GV6dJL5SWPo3JrmuZAWCrX5Z0hOmKM27CycRESgLfCt4pIgvBpY4gnAUrt4s4qLvssFhq15RhhgyCdEh+vqtPX4g8cizABh/ZOPh+EMZfzgcv7bGj7+rykLPfiKfMr6Mc/JT4OSGhaownZ8M89B9ChHxt4QSnaTFSy5M32isKtIH4PebmGoqTt8c5UH6C8A3cfoAizGlDxraV6zxYaXpW8yKYeqktMIjBUOrjyZS+KqTsGr32ss5bZ5qOYvuk89q2S4rIcMxAHPKhwOKnvJJLLwg8d6qqLaA776oe8wy7lMePUL9NmaUFu+BG32SUQdHP/Eo0CKUhv5wxTZIf8nYOP0oHHJjFA4vL30aLFR56R+gOmgdtkH6Ge6rm+pTGMOXPBDzbfqPxsYzFISnzRQ5ysC1Bulboly0NYlE+JFjBci6s6836T+Zoi67FKqfglFs5Mq1uPLeUCcLvuAFqpbWsVJ3E1Y+axjhugNF1euu3qfXQNpPL5ks5Tdf+PBjCs6pDbjBNkEPUttM/xl1lZBFVRhgG0i8MoCpjjoD6V/BvazRFSdOufS4Zh5RZB5wFEtExZJ+TGdjkr85tGPp5wzc5Vs4OQg47qx6jW1nLduBv41KP6G3FPdRALPvzL52ULZsRcDgiBZ0hi6B6auNbbMQh0gVCWh3IjGMsMq4lsCXSlT5pJRIt630XwzjlJh+Eha9OFyw46gBOZ5+ziS4JNmDOv49cNytOePf0xdVbs0HDDTw5saab06KggR0nde2KeOnaoUelAaNhcSIZFAsashFtWn6hGECBKL8TsQA7H81omwmTHMglZFddjg8sPuQmoDpA+jNnr4lpBhV7yOKILT6gKShTU+DI3VqD3z0doe7+KxViIP191DAXUM8an032Zshyg28nAbgJ8YA/2WNoJdUIhy2FsNgqUdNLon0RaWPAX+OG5UUh0COems84DtVetxY3U8a9HgG/NZx8dVmd/ILgYzjpBnkSjDp9WbRvwAkIF029DNCxs6AKSv66SK+nNH99PMasRbpD5n0NYaDV+m/GBj73kXrMzUqLWED63JC3AnTt7AZ45RQ5JtG4wBQE/ep105fjYRcAb84fQRdV19iytf08Z5E+kw/Bk8PJNl4FyJ9sehqu1ouRq6YwsS1+u7kozp9VUBFFR77hN4imRilIdZEBtVC8ByVZT+j90u5SZrsUfpHTZu6JIwSrPouUGmd/oBPAzJ84bRp2TC9JxiZN1GB6Cg8KkDDEwZGtfQt0RY/Evl20ohu4jn0QQeC/29qNhfm+gxtEXXmpUDRDZd2xL2/mdw0Cl0Cg79kuHj1fvppk+v0dOBdwdNfDeTyO8OC5P+DEZVX6k3sCGfqDFNSKKYkdM/OfBKTvAUv6SnQ9h04UTvUNbYlIQrDfGDiuUi+OS7WmdFYIIbemgQTI9bbiC4KKLvhPSUa1rN3ZB8atuG29KlpTe8L4B7VcJv3t3XpLVMHT24U1beN/WIM1y4FQmu4yb2l2kHYkNiagTN4byyR2ODSDQcWihDDWjR9IaoNQBH0rZ5GihInV76BGmlQbDXvoUcfkO07FlMHD/gHtDFlDU9kIloogp+ZoAI8LvMFk9lVXrxFmpogfW2QfpwGEd+IEBIC/JiGTrlH1Uw78tnQRNCTuzPtAMJFQdzlGxQepigWfDdzndOWXkP25/iBYUNvC4p76qVttcWrozNVKI5U8pCmpghHOpRA94GLsPihhPiY9AMBYzoggKbHDQ5d+mrTL7Obku4wAOa2tkSpq5t5eJch1wrbhDZ72txf7+oVYTv1/oJS8CHtH9Js7/dkcEDCZzjrLyHDLyIyvFcqLz8jyPA92uiRAs5rHZO4ekyi6jEJR49JtOKYUMWBYyIe7P6YhGsck55PVyA/oYh+abirkjuMd6u55MLEiwI2/BKwfRGB7QeDr9fPFLD9nbjarcLKJcAVoaGReGdITipL1tlDjGibVgHlEHd/zCAPyBXh7vgKcHeQ2FpveTm4o13F1FLQ3dYeyNXAejVVFVmjyeyXwPKLCJavfgYZwsf/jwXL5eVOFTAXngIsvwSRX0SIfM0zSJU/tBIi5//t4XGUdoeXpd3MwMkfPcBgT9naUdpFCIC1AgBryX8P1GXAbwh3F7ioH+Hnn+t++iOXh0G9JgxiYW5UNavce9WNKn5qkNRXB5J6JUjC/8EqFzOfmoDmdvURjc8/XwWbHmwx1fS/PCWI7lC1qwNVXYBq+qPB874g1KnXBVQo1nVFORyVwjG+pR/VOH/u9KNUGgdU4orEbNJfCUSeM6XsbCA7R152FtYuuRiU/be2KtsqZWdgtxmfKWA3QlCp1q3IiHniJcgE7jfK1riQxjZ4D94uIhs3KQZC6edl44QinbiMKXFyq/lNqL5szX7USD8+1473queZhLgNV07bty0vbieDPHHP2k+fVy/psnRjkT9uftZNDsYCbRSlY5mb5NIT6fojapYpINyymt3ThvnIlnOn+yEFZZ7bc8pr7SC25divj+AZZjGVaPVikuVqFnPnfFUxXyXzhbJUDaMvJBm7DHEowBdDsInbhGnSSdrf9ioI6Gk9hXqHNuZo8BTySK3Eaelrgy3SVtT3Ip44lX7CILWQYn6h9FHq0vmKEuMxZs6jPGMDCM3uUci+Q1zmsaitVYWXioySBaUMEnwJs/1vwGw/Fjw/eKYwGwBx7gsGRD0KiO/9NwDEjwWanMOpKiie9KB4n/EgiBW6yGX7FD8/WYDiucuB4lkBRdun/xQmPiWguNmD4qQHxfu4+CeroHj26YPiWYLifQUobkbfkwKKZwUUP0VQ/KQuD5jFx7X4mOrLVAtQvG8FKF6oguJmP9hrCYp2FSheK6A45W3O2k8sTP9rgNz2MFRH+FJnVWsxRleHNA1fO4HP4RKtDZ/3VeHzQgmfpwr4NCacj7ztcuihIfbUAj5bJXwKbDa2VgC1udVfTRBoiphrd23fGUBswmrxKEnup9KUct2JAFlTbjfwhbcbcturXxtyuy65bRq+jZY2DWlTR8m6kG4RooX1yY40tNfXQieOoLrYhjQjlechGDkPLUZgsP3MUPloY2QczULvFKCk1jgCxmH7TH78KWSg4ghkgozEHotvBT/zS496MANPwxvvDJ8GDr8qpB2vf1Li9ZC2S4fIWsyyZgRHYwarZSNgBg5BD/im9LjJdPraIIsLtyYKXunrAued6kKB2KtBuGYFsi0cSOTlatrY8URtSf7c6HDBPXEf2Bs4Ld0HKOkkAvNGYJ6Zu0huEFql3N9d595nkZD2iK91003fb/JA/LEWmFFWMp3HM22qtCkzp3/A8ORLp7S3R+Krm0r/OzyXkMyouHzyTcPLSEx/7nVGkpozZ7w5goRHGMb7bPp+IyoLeRtT5Z17naHlFOmQ0FKCixN8LV5w6nWmfMHDw8sPVy5PwYQu2apYkLV+A3cFdaZvMKl8S28w9YSVq7HAmcIqyqsvgQZwZMk3rWU4DSxd+wKxn74+oD7gjzqwy9Th9gor1xuCoS31uUVN9KCkjxKvjkOs6ZCRlPne6es2XgRWp38pS8QcSIUciqtb/t14Znx6tWfG/cFVe2b8dHCVnhkfFM+Md/9v8rr4h9VeF59dx+viMyNeF2++Gq+Lf/o39Lp4I53H4XVR8bd4s0ns2P+PvS3ahb8CcGPyq4GmoedClfCd84TvfKn880JKeirIqnLLWdNP3/QFaALPEy2eMwCu9TWBtfXpXG21JvC86aefWa0JnDZnzSqZxKRvFlqHh/7p38pVYTjrz65JE8+vrQe84PWALxyNQODs6HtAPcqQHdHpkk87+M5wGJXwFJ4L9wf0XPDC+xqeC5812ox6LlxvWmt7LkA/8O2lz8K0+U6rnnGfhccVnBbg4+OdFj6soF9oOPNKmO/XcF6IVzovnFel90JDvBcapfdCY13vhYafElIgPYX3Qvy0vBe+dFKfkZN6WTv6F3hSv7Rlz8iWXdYa/aUt+/e4Za9+Bunhl7bsGdmy1zyDiFH04herG3bBb9jjGOhjI3rxD/PzvO6nD+Liw5fTqbz9SvXij3MGF6r79vanr4x8O/ftcdm3Ub342zWX7sNUC57XfnZr6sV/UXby8RU7+dgXqhd/e9Xi99ha+zlcjbX38/Gq3vGxcj8vXonF79NVi99SafG7P6DFj7pqWvyEOVrL4vfEKouf5zm/uBY/PWKp08+8xW9Rw+QnzCpNfk8osfmZV46a/Wzivn82V+68El3VBRbMqhj+pMv/84x/H1RPbf37ErL4t0cWhRHtmUAWhS1qMajs6EW/o5eM7F7FFvW3/Hy82NHHLrejj16pLeoS53CxuqOPPv0dfZQ7eqnY0aot6lHZ0b/l2j6u/ezWtEX5Hb20YkfPf6G2qEef0hZ1fi1b1HCJ1t7mS9VtPl9u82Ig21yYVNZjy9Y3qXx6pUll6YtgUrkMn/a0TSrCp12JSWU1j/b0TSpXwHutNKlcWM+kspMmFWjrGfc0oq33ypyqtj4stPUdnzWDQVBq5HeK3yOxghOIFfwTr7rfWakdgKTaZqi6H2rslY86rCtJoRJRgS4cxRSchTL/7Z2IeghZx4kt/qHa/DOG+lS0e1twvUmZZp8/3x4A1YO7EFbj11jO3k33ec0np/0XzV/prwctTbXsdPHWt0RbEoah7mSWk2S6ZE8QLKtFI3fcpO8IhB3QBSl7ztoNJSZjdXMBU1+qY7jGQiglwFiLreR9fnVRmoGHzf3ao/qrlfp6fbNV7lcf1dNKXW/2An2qvtOH3bs3OqYUCdN3wvUP9TslMYByX9/nh2sDU6C9VelvBLyG+k4m/U02x+IZObNf37fQna9Camk/fdfw6OoKisHu0mLxbi+NKVnJhzAPppeSzB42YDxW6OozTHx6hoUdBRm6Z9NHjCYkmHkXw1kyR19euVxUAAolFHl4pxI+jdpp7lPFq7S8Y4s7r9wlXFxc1LNd7BWv/pVy/6iQKQC6/92jbC8QHHKDh9f7xOBiKjNSBgkQVEfeF/C4bwgK3wyVfKeSQ3Bao6CHJT/bkfKB6R4p+iyenWaYCIGzYDYHJcnlrGHeA6nYag+7S0qcQE1forn/Z6DrFbUto4uZnBSed3H6q8gx2Uz/FQGPiQ/3/smA5QWQb4aJutWwOLWMKW9IZo3hqGB2kOwOb2b5DBoz8rrn/Oq2Vm5AgxO0DT/6RpG4Ad8qE0jczst1ldgGsj1fpkUDK4AaRNakvxUwT3qcng5YybduG1kcILY0viVEFqMGpspu0t/iftFm1LT19F+MZ4Jr/idDolTx0pp/ac228FIk1GuSigz29bM63oq1iYFV3myydvHYmH9szLZ9qjLkgRPLDSCT6ZOYAk5zZAhnR7YH2yReF9Vw8sAwGL++tSgVTt9cmNGshhZc7ff4tZE+oW2DanjoJJCyB1m2Ylvb22WZJdoTbZQ+EuQxzUTpE5qL9pZoC3M7alsrtPisE76f+RpjAg0a010YCX7OBJYZS3x+iDjZroS6zEjFQp8M+TZmlNHpPwZVc3DyIyMpBkqLBdX33yspBrRr+kI8kmIglBQDOv15IwkGfj7Kw5EEAxoJBpgdyqSnkQABrqPMYG4DuF7+TBEO3NJJ2lHJ8JB2hI/eIkxFCxnYqXS6WCDc3lfcELwMfKrg14sb1sCvXqGi+vLppohhHx9i2HOqj2xFRLHxCIrFQ2Tdnj6Ovehx7NOhFerfIa24gi1Q/0634NOBjhd8rrly6I95cQ9jf5+Vkb83yGrkaE8BU9xPBjEyC7YWknOq89yFzw+mAePXGyst3ZfJdniuPv0Nn3wjfH6wc40WO9Ei4T7tQOY8pNXrO79O8B2oy0N5Qyp2uC+7Ndy13kjqMhI8fT+S0BVvSd83HES68iaW7n1Bkkcoh4l8v0+u3v06/WcjX5j3SJLp1GRnmsOxAkgrY40ljvt+LWOeIUtwTvUlFxSKUcLrIYLXQ2yj4SsaoKnP85vdsE1EKtDpEsPbNeDN9HcD+cttZvq6b8LHruEex7TY40MVSfB8WpJzDNU1kiV9Jfdi3GJ9NffypEx3zCBPyTEjep+3fFB9vRqSdUPmJAvLOofEhmZdLkcYK8mt4kJEtL9PuY8rG3ahlXqvch/jd42q4+6j+G7xbjI+v6vcJ3AFjA+v7kl+WpdB7GUen5YkuqszbU/hKhQCPoIqpxQIp4SWSPeIVIpO+cR4uaS+9mUdcoX9ElctMoQkNPB3BS8Vlyg6LnyQyrimt0S6uS7L06aascrM1CXNW5WZiYfMTLya1MflOtd9+iVblxzAyPZUMjT1tRia9bpLbN0zNOu1qDP/GJPygW9BRD3YitcG6Z9RsylMRJEAjk00m2Q1eHnaGkto6Wq7KuuHKi5kgMj9RZKGsT7olwVMY7BGbbBQYz4nbmxrzFWHYztkn4Rz8plNJKi8MbxQ4Z2GhvMxzK9lWxXeqSV1TBOU8yLv1CkeS/1jqe1QKynuLg3ylsziI+HtNkaOu1gY1edAmm2nvxIM2cXh22tDFox7L1BWXQikMRRO+Km5ss56zPCaL+Q21CTfXXJfKMRh0VSIwyXgs0tCHD58XUkc6tabaOAPTe2BWWARI6LkmqCuob/r82BvQqJPPuO+jAamS0Mi4DH0DcFBcZO9Y42GwLMgF7Gg4EUtOhni4EVNHNyQx/ImwslsXNKLlYPDK9LCE1eJJ7t4b5evG5KNGwIrT0yvbAMSB+oRC/VoiP+1R+1nNRMLAkqRt4/UI6kM/ZIaGXpNyMdZH78g5GORe8S0vUI+4t1tqftTvqOZeDaC9KPpT5JynyH9uMjPx5WnIPhCEkJ72xF8vHxIQmqgHg0hIazKUZKQMx7hXig5t9/0nNv/ZZV7h+fc7ljBo5F47Rq4CRK0857VyWNeXYdLo2Mz4UeYGg9JoVz4SYI+mguHhBx3kUV4ad/tHLBedZcHqGR8LnjG54upBbo/+AK1QGefSguE4/+vXgv0/qfUAj33Msod+Nqt1u8MNTq0mCRn/eqc0is5c7IzBWt+H37cp59Kj/Mano3X6II7v0+XTO5r9Hrs+Wv0+vz5HzwFk3tO9lrS/ZrkL1aqHD5d0N/7g3VUDktDlQMrZFyt1uFnRxQBYaEIKFyur0brcJmuvNbhMi2uWutAP3WSmw9cpeIhLBQP8vr1FQ8/O6J4CAvFg5QquazigYNbW/fw9qGU3lhb91Af6h7qzrwyr0NFUK8oIHBxlQ6iQR3EHz4tHQQ6XFMR0VhfERFWFBE/aKqa7uS3tI78FGuFIiLyiohKvkNd5Dv0yoi4yHeofb7DAPkOY1FHBFV1BNKe6jwALDBiIJS6zmXWXCa9ZSWYyIbJliL7YSwevCtyIEJxwbxotQLJ/IYXk9dlJy6jqhCT6gVdyMmXhijkgl5PTr6g15eTrxCFeLL3NBGi+neKEK9kJ9S/050oNBal0ZZjN2ImXFNjcQ4V/86aK9BYnDOFPkJMjqs1FitbrNZYnDGrNBbnzFVrLM6a/vAtKzUWIzfX0licNQU/aJ6GxkJ8u8xqjUWwlsbirLkyjcWHLqexOLdSYyG224LdfM9KAbpKwK9KgP7ZEXm2IFlxSZevUoC+THdegL5Mi38rAXppRIAGqr5SGbrKDFyFGF24xKNi6GXF6J8dEaPDQoyWnNErxegygkXWoRCkOde12K7hOGpD1oIKKArejaJdi9VrZKiNkZa87xkXC3FoaUQCLxnDK+NQCmn6dBVx0ZHkwWBtaXoRld6eMFclTS8GhZD8YHBZaXplw7Wk6YtmlTS9GDxdafoJ0x++bh1peqTNWtL0EwVme8I8HWm6wC2rpOlgLWn6CXPF0vSHLitNn1spTZ8eQW/v99J0qYQvpWlK/4U4/ZhewUacJik+rfteon5MVyTq0+syEnRsWSFSoysvUy+VMrUI1gLmFKtR2v5Jyfp0NCpanysdmUmhP+yr6NgiKtAwCpAhkgwGFA+buiRhybR8e2foI02Q9J4nPbY17Lth0eo6+AWGED6umR9SUGH6p4H7ipnQVz0yeALhME1fTtNIk7zh3kt7fYMp8Xfia5wZ6wuIG8yvNtMObIMVqH3HOAuA3zo4kfq0SakLgG9y02sEto636NhlIGURkjSKEUkHH9c+bLEmg2PdqNoazVARL6jOEKHWxrfB1fRjOv04r/EXQqFZlEGXdz9nimF/zhSrwapjU0XkdOm2w9AlifQrLlXXdpUfD2bPruz/x9x3wEdRbY2fKVuS2ZBJqALq7ApSJBCKEUNkGJQAIsWCHeOSLJCebDaxoBLpKEIElN6DglQVFDWYKKAoiIANFRAVNSomUaoK8n/n3Duzu4FQ3vfe//vwZ/bO3DrnnnvuOfeewkSW+iRKGGCBwAaKDIaoGNapA1nE9lxW8vOKPR/snPYJMDJgHqagFaozg/xMqF9JbuAeJ5itbmgxU9fciYo7qBTKzjAsLZWvJOWW8D4RxZxhfsu5KSywMxjqGB35S+pBCa1dnaHd9wCmjxTsFqhbpEeM9zYAvZjjmZfxIgbYo4XiyjYcuaQGcymjUcNG893FjEY2R7NIrD2ahWLIaFxsNDdf5GhsRoOwsRw6eyw9rWkxZPUHvEiRkCmSzWMyY1c0BsM+XC+DgnQcwpidgrEV+jQzDtfLpNFsDV7RWOdteCwgGHZmDqcxdW1a3oZMcUeLVfKb7nEQ9uONi0P9WkJzXSxObtEFIz7TLZh1mY8CmZ2pBOvbqb5kBjHB7/4a3fhHZvErKUNkym6sfzJdZyGaNTtbBDbTaHFulGX37UCXYYyocds7h0XbHJy2OVnqDTksKtJF/8fCeNS7HoTGcmNbY7ujcePGkY0bN25cL1pt3Lhx/YaN2T8QRElq3Fho7GzcOEJp7Goc1Vhp3DgmtkEjxUR9B7P8ljWnelByNVFMJAx5/53kaoxbah1rENXr2CkI/8PWYILYxNVIIeGfYqWazRkiYgoPNSayGcZ4Qlf0Y37g8sn02QzkgXahzNTY1RCdBy77atOKdw9vn/YnEY/wMRGYHYx8YO8NqMIrG1bsWb192qGLqFBfoam+8HAb33yBscZebEtCJoUpPG9jMdhY81qNSedo7DfxQuNSGcpeeFyu8JYotnTtxqKxMfkiGut2oWHVI049wx0S0EMgfw6mumdwETtp9wNz6wO23tn9MSt3jr2KnWe7osJmhaIWh+Cxk+0lk0TiD12o0pyZHGyKhsri07AARLg3cmKLwT94mDMkzZkeIHLj6h1lxj5iFsTAXsmGQhEX6QKaqKDLhRDYwhg6iNYcxqYtQhuoG2frmzhLngR2bBHIWBdDbm7jXGEdFaPMipHKhaYtKWTabOeatghaYGHb+fkXmJPdeYRjjHCOru0XwhiHEk6OuBqvHVyO85CqJnWTKpvCNrwQundIcsnsbfiAZT7g4FaHK4RvaGiobTdakmOfWpjDkNvSNHcadv692LZHoIGa25yIfDEiOfKxaG0uUuCJn6xSvYIdaKZmNZMnMSJ4E4zn5WCsmXxJjPcfl854n7AYbzwRqLQYb/lcjDcrcgHG21mb8Wa1LoXxdoYz3tjAsVDGWz4n482KncV4H6nNeB8V1GNBxvt4Lcb7KOpHmMNeIprQMBnv45fAeJ+4ZMa7CzLeD4R7oTFObsWQptdJGO22hqdVzW5U8rRTsxsHeTqc2baTixf1J8aQa4zv63IpDDndLP50IZ78j/Pw5If/TZ58vvTv8uR/nIcnr/o3eXJzNJfOk/9RJ09ecwGe/Pf/Lk9+ohZPfhR58mMWT14Z5MmPn8WTHzkHT34UefJjtXnyyjp58hPn5ckrOU/eIyPIk3e1eHLOkCNwnZrj/wYr3tXceg6Hs+LW+6pLZsX56ksQu4Zx412DG//v/zY3blRuMcmKwzi4xSQrDmPvFpOsOIxdW0yyUos3oP2JDw1ZdWPi1mBrxVuDrZ0Maa3mYloL5ePP+6GXxMdfCGSXxMd3DfLxv/8P+fjzjutS+fjzNnZxfHzXC/DxR8L4eL6TAqMRoXz8iYvi47v+5/j4+dJ/iI8v2SoY7dSVgsd+1lbazsRR4tt3bRXIlx5i+batQSyv2Fo3ljcwW4hULjRfF8XAh/AGjhDewBHCGzhCeIPzLLtQ7r5rkLv//X+Ruw+hfkEG36KmNeEMftcgg//7f5rB72ox+CdCGfyjAvHLQQb/uFXq/Ax+V8bg98gkBn+8ANzdHgv5LeI9BDMwRVaBzvjR1JOwUD0q0Su3hNumyy2HDlugxcrDdLLqEjc1ZMFE2QoldWk+HlTyZu7flLRwNoYZr9jRnL4exkpPhCgEHcqpNuKJo5CZqZehHsN4EciOMPlgBTknzOA2oKpD42G32OdfWyu+OZDoG60xPwDkD0ATjWjTfRXzK6bIyBG8wl2DLZKCkFqEl2ku9KwqmA4lJWOswO2znRiiQELlAwm1EywASjzkPOWRmbqhZngojDaB2kO3oyfpxo4uC0OB7LCmBrgGuoOMd11IidC8R/0OmRwHKotzGNs9GPHYDCnI1D3Yhe2/KpSwC5ZLmVOuOMgil55zThdJbE7NiIVioWJDhw0scuA/QlPFRXfjRpxaLvGH0eOLtQTAIsyLabDIHqlpiDGiyLST1MkiZ0rJwp8uA9qIcB2jBzy2l4BXny/bFHMiD3Gr7bodRbdHgsqVZ1C1hV1fnWQhQkrwQovdd5UIlg7pvxBoqmC5gGa8fAkL1cuIzFQhAxlIDYwZ1OBYMUN9UmZWnscvp1ObCZhbfTmd2hQLdHtWTGWfor/HgXvejWPDc7J7SDYydumG1ALnYQazS840vocBKKKGvRMz1E2kOuxoLZIXbgeRVgXXwVTcMkUjjuG9kIGv2YYmmQ3LTBlMZK4yLL0SvNVTD4jM8yTeSLpkxUZm4sfpLrOYwDZLYjq0cRAZ7CIk+Dthpxn1span6DAnnNxTtMxnAS9H2QUo8xMtK8tjmGbHOtl09ByZIJbKzOvJcnQX0j5BHEE+SjCkskKzpdBN60nRE01umRPEsQJWMEpwiRcLPP8fwR2jKahmjMl6moLqLph0aQoqovwjuKM0xWhNKVVT8MrYHakpxgnIcMdqCkLEXT/I4ShoNEN7hKROlD2iOgldUNPGzmiR+pSsRWmC+iSFDrU1pXdHRc0V+i5WM6NL1LeiSwjM10xM7bpHRK1e6DtRfZosC3EEk//XRqAkiC1MzeEI8ozIlASL5XxPrBFR5K5PIiQZ8Wsi+nm1vB3KyWRNoxjLZX7OaxATFiJm0TRoQkY7gHo2AWTJFoFTKyVHIQ8SciZMMSZQh0wdLWuqprSDJup6m0sM91xKDmbsvAW7QkqWwe7t4U3ii3O1SWc+LsZpRhGbGYWcI75Bl7HqJBH3cBfFPmSRfkVSAneRmwbyNcwD5/JbKxcpzqBOTL9mbhEZKjtzompXtKjwSr2jbLwSK6JFaZHUJa9rZ7GFKVav1V+dPYWWjjq7dJ1dnAVSiVSNiF0W+9I0ilp9fEjWlDgYaUDvfH8v9PijaPWYtjuDLLpoV8fIxHkLLDKkkhEHDxlCP1SBRQTQ6pFXBJWcBamoDE9axzRRMveIwK4EZPKIoIR2QmyU0lpESzBNVSeJ/Uk/SOVNYoMGaHKm+ozslum1uwFVJqswzWQXGmBhEfUsSAfRlGxEOhxmg/LQsMTWYhOaq9Yi6omxGEdN0FUDc3jKB8g9XUuGUBAlBMfrpAH9i7Y5EShNkcy1FtUEsYnCkk3ISiAEKKEVGFzCVlNwcrEdPh42tYrpQEJRtFg8eKmrSensyRYVLteFdIXqi9YFq8jWIzlikrDvUhmRyknup0rlDHWsTJkYCSKCGEzmqlRkbq2FDKRqMeRbRsCAoQIiUZG5AARscazgEfG3WMCWozUFeTfmuUodJ7MSuA0q3P3MWIHNHxig0KoMBlUwW8PdI9mMUEpNa+IlNs6ba0H6cCEgqhSI4bFmIw4eIkHiHOtIMhef2Y5wVjsWoJmyyNmtyOTVFs4NeR58HAMi0AQFXd7KzNCPOsYDgxaM0kWi0ILNYfHe50IIEo4jkXwLxHKgfp8m9z/H0C0QRGoypzZ1wIFDgTMZOBBDcANNEpuA5CjTVxcd/ceEZBFtQV9BuGaCPIgpr2FDSANwB4uivy76W4/+xtDfaORLFGOdTKer0QQFxbRaxdG0xKDc5Ba+SmDahsyfBu1/Mrd2VeqB9Q4PabcITOePG6by+N2k/EtHmSgzZHokxkX3JWtYIUCOxxSPZAia1Mw8qrBz+UKzGe2T5VGogo8vFE1SywWPk+yFSBkS1ClyU7xiiGPDklEOcJISP7JMNnWqrNnwY1nscLzsyeT4wOSwDLadM9tBYvLe/x99hfz/+SvoWTIeyz/7Qz6R2YG3pcVPMoXAZQqByRQNTN10UlVvYGlxq5ZAoXK9NWCCLxNBmDChhsgSeP6O91h4GgFIUdQnZblHqGRkVycjB2En0sh49WhySs08QNgNUJeLLJQdMNlaRDGaZy0QTWEJZYJobEhDGWyJqK63Ie6SgS+FLMGAJ3i0gkiViQcQuCb5oT2tXHYKwoL0Bfl8y9iEDllIRfsp0Y2rHC8lSkVPBJJOOoWR0YRIDrlv7W8zQEESgBY0YmY/Njy0ecrQhEwUydW1NoVVEDNY1AEmuaKTsIWmuBFqOO4wvWQ4TABRc+oE2TqUEegCAEc3UTSZVLvm8Mg0RnWSqL5qa6rJZDLHLVMUS4ZEEaUOGUZwy5a+JFdRZ8YUsnIZrojJIje5WS5GK9z2hsVKWDeLYiWE+aFqh36owt5o+CbEd1UL9F1F9Zez+tfXPg0hGuMkLsNjemdiKwAFfCHoZ70BEi5gPhGBXYpYBkFTZJQwBb6gBVrazFniH1z8rpFDvR3K3NuhHBS/mduEXbXE74qg+I1u0v6wxO9yJn5XyuaKqQgVv8st8XsLMzORM9Rnw8Xv10PE73WCpbwKxpsCF2CZl7YLi99bTFF7kmSJ39Y7sfC8Enj5BSTwLf+GBL7O/AB+uSmjN056gcMJnnNxYVw+lzCOcGVgO3FORK6U3abruqAwXiMzTP5TvQhh/MGzhPGDFxDGDwaF8V1BYbxHpimLx1uyuHaWLH6Uy+I1dcviz59PEp4pny0JW++YJIzTUt/y+3oBSdiqGyqLz/pfG4GCp5f/AVn8yL8ti9O9DsnihNjTSG5uLarqxkuQxY+EyeL8qsh+zjYvURY/asni6njiVUQm7R6/gBQualGsApO/j59f/j4qmO3X2bpZLqp2uf+izB0uXl5A5t7BnaWEyJZBmZvpyzCZ+6NwmdtpydxOsqANF7t38GE4udg9m4ndO/4DYndrvtfRJHGx+yMudn90XrEbaECaEpS5nQmiqljitzMMKFbpcIGbO+/EOVWCo2BzqoSMwRK2z2rrwpL2kXBJ+yhK2sfOL2mPC5e0ZVPSZnThHJI2SdV5/ykp+/h/UcpuXlvKPsFFTDYFgfNK2MeZhN28toR9IlTCJspzqRL2OJkHmgqRsGVTwmaWgNQxStjN/5MSdsjno3RNMaTOI10fv3jpWq0tXaumdK3+l6TrKy3p+i+htlyNGLDdxsz7K0JdNa+TGDu6UapbcouoLbn9ESa5bZTqlNwiTMltnYRM6AUkNx6bjpvAh0luTMeL6NKa80tuS0V1I5fcllLYsTDJTc7kfnFNiY14fiaxyWESmzNUYpshWxLbc7LHUafEhveMltDmqCW0OSyh7XVLaMMKteW2NSZnihyGKbc5udShOQkA1Fxtoc1JA6y2hDYniWzuSBLa3IIliTIFVHWGjLHp1EmiR8zEvYZic+KwPBIbGDJj6l6BDT/DI6gT8B6dTxPzV+Bgk8UD6lE5TaKPNHCwkeprNst7AZcYnZbEuFEyUePcjPZGKURi5FZ/FRLjs5sJwiiD0BCxaJQG6jNoHovOjZUIJpidlJj0V8Gkv3utUFdii6C4yZAPazfVJPVt8y41/IoVFVrQEQTHUcHCUX7PSt1sZN0kXYyQad5H15Yzf+HRAHdZS5SbgdpR5wSY8+cEcZ/IUujA9vmGDETfMNEsLkGsEZiHdRLaapjtZlRI1sHwrEiWdEeQ8sUhDCaINpKOYGxVOxmfGftEnG/sT31P8jiYRWkUebgni9JIzcGFvUh1royRABC4ZNhOPuAZ+dhLN8meGFbPg2rwzgwtAu97Hdy7CGagPklcMoYaRJbddGrOROSP6e9O+ssdiEcz2Q+T3L8hJhXmmlCdJ7PPR+Pe1uzj4+nbXeIo5jEQta/7IL+Fe4QDI4QJgQzNiYcwrEAG3/epQNh7MUNxq9SiW9RUHo3RpakcFi7azbjuJRgtOG3FIJdoVo1HOTH0hbtYnOOPKc7xTkGL1pyawn0nzicvp/jQAv9oSC7QG5NDc9GuQBuEk28TQR/ub8haJOZHcReGtHYc/CDPyZCxl/K1aKEsegaIQJigZK5OlN1EKzDEIaono4ppJJfO8MVTMnmoeVJkRtoIHny9oHa5o2JYOVTVAX59ioIBuz7Fgi9LqJ9uFaR3R3A+Qt4BFxpFdfL/1eEpZLfOSENl0O1CQ0YPmB5KsZzvbiz10BoZxApxsUXuoTXUorhMIGoNkecX1GdkLUpdLzGFn4VM7V0iD9PRhsp2jWh0Nc2Okm0aKFSkIT+2DZNHnVojJouCIImyTeF6RMiGyCEPqL/OPPQxheFaHvqQG4pST4tRYvAKtM6yIsqSp7GtxrjDRBPD7FJflTRX+FfRtCLNaKLJaJIuu6Npr7Zp0bhX25HBjA5eXUYj6xNNu2M9j0q0g4rLWvTAKNBUXibTE42jizFHF8tHF6vF4MSqeJqrUiuqPEqz04kvbuHuWPKUQHVizC9iFCpGi61VNUaLwKsL1jszYog/H/yIkpwW5VHGKBvyi8wDhEJnDaoB7gYSa4mYVVWrj7OsumNdlga3NaQYLZJFYIlltKkB2kk36E/l61M/WgM2QcYZFJmNUaGv0RNGfSUETOrZ7av4rQg1t8pY7yZszt6WFK0Rvm4UEvOXn8W2xrPY9nRqqi614dUF/gAFggUNdzd28qSBuortuRnKEklwEH9qmfBvDG4bG5kCUqRmY6cUNuuKP5KO60k5AGPFiprCa5qngWvp7xpTxQk3Bhc/qf6H9E5JevpH8OD+eQqC28VZZ59IGrF/JJyPISLYGIOIj6QZPwlDbzrZ5mE3N4nHzL2D8kNf49bhDJ6nOo0foC/5BHHyzYOJQlHAjiaZKysN2OZhQwaS/8EmI+nD17FdZC3tImsEDV1L0ansYyGbiMwveNgmYmO8lYPolz1E+mBQN+N0oHWDcoQzKOucdTEoFQ6MqOFgqXMzKIuwxVkyg+wiOZRBoayS8KxIlrwwg1LmqItBKXNwBsUQA3XxKBNlC9kmyijjMB6lzBHkUVaH8ihljto8ykQ6OC6mv6eItz1Jfysli0fZK1k8yjbJ4lG2SBnqkgvwKFukC/AoW6Rz8yj4vi4eJQiO87MpEQQ5k1OhL2wtnqK7zpNSkFPZIqlLz8Wp7Dovp4LQrsWprHOGcip1MijPXxwHMFO+OA7ALGdyAEj+GAdAG/r5OQCzcgiDMuv/6vBCGZSpdotBaVCbQWlE0058SsPafEqDED6lAeNTZiOfsuNcfIrD5FMc5+BTGtBAbLXYlIYXzaaQwyK+a0XzY6No8phTi01hEcLrKmuyKQ6tEV1UhbIpO+pkUxojm+LgbIrDYlMcwdNe9FjFHDFq9RjxoMrRWj23yvkVh8WvONB5Id2RxWqihiP0xLAxxjL+AzkOLYaxPcga9CJniTHMFpSOPGJ4+3hmhw24Y022JVqLCWkklvNOIms6mhw3MQ7GYXIwS8M4GNPHE3MvVScPE4Nh4Q1w1ycextGbrvCitRjEgOgwHiboryqSHbNxHqY+8jD1+1P5GMas1K/Fw4S8Rh4mRgkBXfTZ7ZM/rNggwyhyr1RNNIe6W0JeWchwNyQfWSs4G1JjyuBIv82dAUn5H7XYEEIrYkOWiiEsSCXR/oP0dx/93Ut/Od13sQMQkwVZLlksSGnIbnBeFqRUCudBSqW6mZBS6dxcSKl0PjYkuD9cPCfCT44U8+Nbi/too9grBZmR0tCNIoQb2XVebgSBT9xIjcS4ERmMUey0x6aekZSlAoRo2NCJnY3rzQsUsAeplaDZgnrzNsvUBsu2FmWP6fmTfEShBgKzeCbfoP3Ip2gtJ6C2czgBtZHnUiFD3SuYLjwVrkWjuMlZ4Hss1BMGEXpe6s0YCqd6EC/GlWbAdAzwSyfWsILGtg9IpWCkZW3KwsXvWka3EqLx6TKR3x3LZB7CTR6cmuhBqwA3O9VyS3RjKFFYItNigKowGoztqdNxU5lJAQRxyeNIaGGoEJwtsnFwmboW6jyb0o4lm7LJBHWODUfQNPzlSpleKqu5p1nNdK/MztWMDmyGBAppx3wre0R+Ciebe5NoRh+gczw8MhzVmzQJnOisS1Jfl5ri8S7+MkUCMPBoXmHHHWTWITCgxccQbEeRPZp1mszBxQ24DSFT+Ta4R0bQ2eHLclCtx0EBTLUIdr7HD0Qtj61uB8F0pawJpMvAnzwMQTzQl87ENeJs6F5CzPTQtKrP0Wkom1cEd39ieV7CueDTRGFInRluWRxldiJmuG1WeB0MU0WhGdRpNo+9v8w6n2PzoPsooYi0zCiIBkJdIlsXHP00Io52hUfP0ewmDrttvBu33QBzEshLAps/NO3D+KnYyCwbi5Yqk/mSrC6waTZ1hg3v1CimBDr8k0zHaOzW1I6lZXWhjUbFT0h5vCHZDaGxKcjYSOI8AFOkC4aqsLHTa2rNQ9+CWI9uATW21HAwtJ3PtPGdAvFcYnsa7Q1Oi8Fgq5a+e4PM4d5UY/dT/DiXzxFm4hK0ZXrkTBbjQmb7Lt5NyepKoSlNnAbqBFqv7DpjgjnbmqgutKG/YhoSXQgyaKvP03BlN/NvjMMjfFcXoAYDPRtyZoLotHY2nss0C7FZfs9LeKTOtSmKFknozWyHxL4MNWiN0o2E2bVb5COeR1OPIX9lRWGfIajrZOor9El9RcYdZorMmqDXbNU6mLt0B7vHAJoHLMz8OAej42H/SgPgtCc0RN7l7KW6XibzLkvPyxmDy7cQA7KAMZFTVrJ5xVAqtCr60RYgmiMOpmkITB2IWXahGhtTF1E3yEQjsbi6CjVGpts40VTn2BCKGjCHEmyMmR6usHrteShhkAbWyiUAqK/KyKC/LShvRQJFspsxG7keuYdRMhunB9f+5NmiOMqYaGaMtTK2LRPVFTL+cChYhm04FT2ZuwpaqcZenFS2TI29L5jqVTQT6jSbcUVfbj2HFTnSG1eoM2z0iYS7YOLnczbmKZIYOPV5LPeSbBx8QTR+u1y9qqmJSKzwKpnj02rZKFlKwy1ZKhrrd+FwKbl3pqiukdW1sjGL5c9aKhqfsnxMHrTyF7H8VUvZ8I3lS0XmgmXRUtGYRwCgdweXcV1iyiidbdZfx+qv+1e14g+pNCbnWfkbWf7GpaIxYzvlY3KVlV/B8iuWinw7N7YtRT+jmMKX662Su1jJXUtFY/kOKonJMit/L8vfi91/RPmY3GLlH2T5lUtFY81e6CYAvjGK36eih5eKaGFIr3ZYVU6yKsWlYs81xcXFFbbrRMCXxnJWa2Ipq4WvPrVqzSplIC8VjaMc5KWiURkEOctfhC/3UD4ma6z85Sx/ealolH3KJqBUNE5a+etY/rpS0Sj9nIG8VDSKZ1kgZ/kbS0Xj1H4G8lKRtDc5yFl+RalolHxD+ZhcZ+VvY/nbSkVj7EE2JaUiXczxiWD5u3BQLB+TFVb+Xpa/t1Q0Dn/LJqJUNLZZ+QdZ/kHs/3vKx+QuK7+S5VeWisb6Q5SPyb1Wfg3Lr8GXP1A+Jg9a+SdZfvEy0aiopvyTOJQvKIlv5+213k60ak1k675kmWgcYrUmLhONo1+yNbVMNEq/st6WWLVmsVqLlonqfBs+GQe/ZlO+TDRmWcWWs2LrWLHly0Tj1D42s8tEY1Fw5lixjZj/I5u5ZaJRGZw5ll+BA/uJzdwy0aix8otni0i4aJizRVLnQsqG7+nbZ4uKulFGcsjySmaLSAgxb/JsUaGQ5ER91Zdl7uWHs8NIrl+W0TQXOL2/kpHWWbNF/J/tLybtThDlUBViGbeWHgI7gQPqhSvrO9EGpBCN4U1+EbeRfJlpYGiQwU84sAHi1M9Af3kUJ0ZYNJDRQQBNyDegN942KMm4uwsai+dFjYRXoTesFpbvJuAhjYhWzCFaAqJyE3D1Bqk3P2cxzkC/KMHqOdiMJuST8pJNkzAgMHI0bpGO8nsBdxMtsQsIqxmoqxkwq9MokMuTlCtwN2ffULNSsDZ3Agw6pwn5YHZt4IFaxUkdIJARPCwK/9aQDoo3XlIHZvELdNCWt5Dci01KO+CHYzKDuxAsWp85WhCMYqFvM2bbolwbWl3mI9CYPnLfZqbdVrieh6i0oVsTvoMxLWunR+ARw12ke8j0FBjLsM1kGVqRHDUgFNroLywIED6qHuFgaYceQMLroXPyIFTItjX0U4MdWVC/xI7MehfoqDb4ufY2c64QXtQFzCmCAX2aKV3C4S7xvpH56RMO9pAWYsGM1eGgiN0GaY+wV4akXAehbgJk8kpAEUtIUYTFBndmqDNErlDCxBaJzdFyc4422QQXFyTrIVVwMzVJSXNS0HK3k1zKk6o8ij5yhpsx9WxIfDSSeUhK6xPPgO34U4/JyZLTQJVwclEQw7qKbgHs7M+lRaOUF809KcSgezsUCdyx6HnCE5HpjsT7R1arPgmkyCR7FBxOLP6JNECLaOaOknpo9fGjI7QoQ+7bDNXaQN0leiKJNTdGuVU8T42QR2lRBsZUQc3cfuijjlWLJGkIFXYz3VHoAz+DblwjqB12pKlgA5GamkG67HKGW8Hzu0xPLEZP0SJoZtn5cX0Ga9UdocWgG4hoeg45TEYH+PVEsAsmIE0NMK5WabNMsJzq57LHiRdHiAYosmjODI+NnRZY9I1NA52lsTIRvAzNhGhOJ/PjQrPqwLNfdqsV7AQD2hii24Wn1PWodTweQylNc/aNQm1zcgiPt7I23pPHxW9lXegoBFFEyHQ7QwUY081KhocdDLmZOwsLv2wmfskmftGVrszNMnDfcLtwPART9HdEghtTGk+07mHY6QKFyA4eHJjhsdVdVlxsyXS1ttNuYX5M3ZjPwyM5KYxEHZg/6izMjzExn2F9LOtGRZzAs22853JmaCofYixhvTsKoyigKxMnu1WKZKhej0XjsZH1SrGo2Zq58TwvkuKKNXNHc5SqR5q4vSjkUJQhFnlcmtL3X7g+RuifHyVq0VokormiufD//s00Qf1O9LjMxRGB+I1XPC53PURzxcAZjaZekpt56me6FS1aq0+ieLQWpdXLoMKeehhZqV4zWjKuDHcEDkPQFFoR9ejujlZqFP6JcLsYodCiMTKUJqjviR4MZWWIdBBlrQs7RveIJLnQRQqlppOhSOoUkZuAgqhHtiZCpkchAwF3BFagOwYcZQSuZZc7QouiAdG5DzVBqzTSKKFLvVhECzVsiWoRBBjub9LG1X7Z4jQE5kaP7ldEmjotxvRjpO6VPTZDzKgnOUEUrIWJ7ovcZIBgx0XlYAuCIrCEljEXL51BBdevZC3cIG466UzXEJipJPbbixYvXkY5zA4YnsqcoTz38rObSG4zkZwtP7bNCAjP0KWI5/IxXJkzfCl2rxWtnnYk9PRlRaqXTd9P6nu4HOWwMPXThLD6rH9xlCFS9RA6hXskmUo0xa+nGN8ag1BmvyhoyrzkidIoTUB2E2mVCQRP0EYd+NaeSbqOjFYR06u4zVBXmqiMEKRRbAWLtXyiuVgAPsEkMiE0iB3PkQIxfiDXfJXYpRSxTrSfCGhRqH4tG0KyovS0NEFZD3BWD2DIhmCcfF5kXH8zpGshzYvKdDTn5bd3Trz1YxQJsZV9giN0chxnTY6DBchFbBaMT2eKmtAMpymCOTKyWcuDgs/Vk0RRAAVDzSkcbfCeF627GIoTYkcqDeEcX6yMtVt3BpbWNzIvtgTRSUdmrgxPBON86FjVyVYg6U0LPGCMoEkDaVcWXZLC3G91EMBjM86c2Qz9opjnLhsx1z0MgTYyJ8lfmWgrYEP/XRwZBNq4WCykM9H9STnaLCr2wV0ptKhhLzIqBD9tdbxYSKaebxRTJm9urRTennR2e64i42Cd7dmLgk1eTH+vS+bnUug7uU+UDeGCXFDxSSnfKN4o9Y4yYcHzI40zjnzNZkQGqIxmMyoc+R7RiAz4/UZxsZxhghRtfg2RxyGsNRQRh4o0xhCLjJo6xisacsCIxx7EIiM631/nh0Via9FYkCrULmjjBXHstSBQXCH1jZLDIS79VyCucLsQjDMi8IN6Q8RA1wLdJyt0AQBss2F3jE7TVpSuCg/YLPv7OleBK2QVRNIqYDsPrXNSkLFpEl7VR9JlqGYfSL7oFM2GgZQEPnOyhho73L+BQV6pRE1Aed3Gb2AF412hL+KK8Y3AAkXZCPlt2JDgcRoVAn53b+LR9HxNMOwBoyI63x/Sh9WkyJusDjYl8aaQnmCLbie3V/xNIFnMOIjBFDWncVDINxYJyVEiMqjssVhIjhJom7JGYcND+uCQInBIOC7DHkCCGfCzcUn5Zw9O4oM7KvSLshkYcIwGKCOa2OJAYgNE3wA0TluIbWWNkFnPBqIoCnihisarzP31wCini73hI3IwXDQHGD70kJGjU0mR9U2Tht/hwTtue8ATZVRciQvAFTCKD0YjxB35HsGIDfj9fv5V6ALTachFhoTZzgBdUXkEbN6vCUZSvt9vVJyBDKN4neTHr4+kkDaMmYnCVa5F+JEk+LsJTN0Kw0MzzZ1IhtnmBZSk2fqhHoFi4rdxYfwulgWZQsJrogcIBcC0gyOUlZlyCoRiKhDiCxkhyIpbOkNPIQQ9gdCT3AcKniCoRVqhQfS0SBcwrOQzWR1shSgy4IzbqDGM/mn8hihHWMnUTkyslJBJswcxj3GniEoSa43QSNYcmcigSNgg+RDE5u2s+YtBqL5RzFSUIxSivy0UoeTQQUghyCWx1Wmnz78S4RAbMIqLayCfUS5XGPbwYGw46/ghdr7aekeJoZ0JJkgJEyVsnRaa1RBeyksZihtCArzSrTEqQ8jKXNnibS55s7fRVi9ptv601SMzaqC+ro3tAmb/NqM4Lx+xnM4Gw/Z9wdwKRNr3cfMNeso5774v/tv7vtUMsZIsgqsmIqaJ/7W9X0TUE2o1H1v3Vkx9n7f5S98IZSaz0EZIe6BwQRrxs8w0m86HHMo590BmzEuDCtkB69EOyE7XSAEbUQiNpAaQZhQiDGeQCJVcdjru0ESjJy5X0UhhdEHgm59Qa/MjPpOWmM3aAHmrUYKL7m1zrRYk3gLueUJwz7PxPc/2P9rzDDzYiGAjMRem01yYtccUYPSJMYQyDkZyR509ND68MKrkPIsqOcOpkjOUKkWEUKKoYJoc5kbhYCNMymQLUianRZmsJY3HT4wMkGZlRsieJFt7kqBJffFgyEXWqhdEtRpJsJ1/OyKpCR3ReZgjHTsRaUQdRkgsoBLV78k2pJTz70eMXAWJsrknsWb4PpB7jt3IwbcLzc53IzvfjWzhu5Gt9m4UCN+MgPE0oTucI8T7fdhkO86abEf4ZDtCJ9sWMtkRYZMtmJjJJ9senGzHWdsQY51Ctp5gJ4IhkWtngp6J5bba248lgKLJhhuC208jihT5Pte+cDElCn5H8YN5/k2FlpuF1LBCP5mFHIQXTv4bwdTMSDI/I5kPKj3gpZ4xsZF6VVNmgrntfUGtlpV5wSDfKH8L6rdiyJkBkaiQWN+iGetbZLG+ZTPWt8jV/Oyo5iczNT87U/MTSc2PNBjRQFbi+k/cbFbiOmBSeBBvJtWzQZcHB72PDboeN59R3xLUV2zKj3jLb+p47KNrymjF2DiPIsijPshckekDqf8gaDyAeb2jgMrQHamCZYzFEeofsjFvrmgsp9TyuaIxnlLr54rGFEpVzBWN005M7ZgrGmvp3d65ojGLUofmisbhaEzVzBWNDSqmTs0VjWcaYWriPNFY2wxTM+aJxmGqsWieaJTXx9SqeaLxrAtTB82b232zRRwY3U3PFZXmNHD2KYYrU11j81AGfopyVACj0gTCIRMIlfNNIFTMqw2EyvkMCJXzTSBUzBONLZWCekI2dswTjYMsuXeeaJxiyUPzRGPez5SswbIseWqeaFSy5MT5ojH2F0rOmC8ay1ly0XzR2MiSq+aLxjaW3DhfNPay5Jb5olHJkrvmi8ZJltw3XzQm/krJShMkh2aLOEy6FZ9HIKmcXxskFWx2lV8RtxlKS5b7cOaC32NDk27cckkZ1w2a5BFJKBA8sgbMV42cSUiK9h/kvwKYlhSd2AXvP00DdDSpRq1fhbgedtwN/C2JP2jkL2fwuqIZ2B4U9MkC/JKM1oTdDGyvScxsHU0XiHKS0jDeDNKzQBbj3H35h6ghYc7/YXP+SxaZ818zv/b8lyxi81+yyJz/mvmiUUPIfWq+aPxEqYkLROMIIegMTMUS0i4QjdcIfVctEI3PCLk3LhCNk1RjywLRqKHcXQtEYx4th30LROPvepiqXCAa0+nd0QWi8QKliheKxnRqefJC0djYHFOzFopGOeWWLhSNVVR33UKz37KFolFDudsWisYOqvvpQtEobkALaKFobKPcwwtFYxwtqpMLRaOS6o5dJBpPUx81JlYdni3ix5OWyXzCqpJFtbGqhi0X5TtUKjEBfdQEdMUSE9CLFtUGdMUSBuiKJSagFy0SjVkMs1ctEo2NLLlxkWjsY8kti0TjKEvuWiQakw+zBbFINOaxZOUi0VjHkkcXicYWlixeLBoHWXLyYtGY+BslZy0WjeUsWbpYNHaw5LrFolHDkmWLRaO4ipLbFotGCUt+ulg0FrHkwcXWGA4vFo117O3JxaJRwZJjl4jGLpYsWSIaB1ly3hLRqGHJ5UtEo7iakuuXiEYJS540J+DobBGBQmpSi2gCKpbUnoBFDF+VHDCK53D4n7IInQX/XUvOInQc/pUW/HctEY1PLyfEXCIauylVPIeP5dRsEQuQytMSRmLOGssu1qSSB8ZEcyxj5/CxTFxqLbqzxjJxKRvLxKXWolsiGosYOE4tEY1VLDnRHM3YOSIWIdRko5m49CzU5KNpAcasOWbfk+eIxpsRqFY4a47Z1+Q5ohIJ+EPGUS3BWG6VnzdHNI7S/ooveYV5rMI8XqEFGButCqvmiMYW0lvcaJVfxcqvCnawzSpfNkc0Zm2jDrZZFcpYhbJgB3utCjvmiMYS6mCvVX4HK78j2EGlVX7fHNEoYx1UWhX2sQr7gh2ctCocniMaO6Kxg5NW+cOs/OFgBxPnmuVPzRGNkg+og4lzzQqnWIVTvAKyLOqzNmTOrmTaKc4MD3maYcYLlGTGC8mh5w9BfWnyayqxWA7k4vRcahOCKT8wHtBQMxQ9PA4CMfAUbwni4GFyaSgkwsNMJsf7G3W2DT3pmKr8rB1nhtLVVM9uyn+5Kjzp3tb9qilal7AbUbIzYanmpPJCFiFyD2NpQzWP4u2IAXWZjZTPmO5+0FDiGgj1ewOawGKnAx860+fhvkTacVeTMvmb4+ozQFAUyX2NGfcHVdVoYkjllLGVrgx1kY19tCuDvaLdWSFLBnEgOkpBPYTH8j3MtIF+xORmNiPoN2W2TWllgd26IXPSDRlT4hZM8EoASheGEYIGzfC+iHSuNwkeiBKMjS+SRjwpe8fEkLCgymiIwTjfGcfIpiUR9euQ7/WIGHJzmc0jMYc/pGAgm563gEX9YDeI6kqqehmOJaI/9xu60sb9hq6ykRENhWzL8YC6ihmzHIKsTMy7AXO+B7PacqwmGD85+AteaWVYJd7yChu3czfiM5jOtJBB3kvxKChgVNQIqBLXjXLEDOUEt3PhdhKikevBa51RBRnUF3nnwY/Hq/giQ83sS16xBG6S4eTiuItMKlikSTLOUJeRWVIE2qaghKKoy2zcR59Ifqx248EYPcnoDNROLygIUEamJ8LMsGOQlsgMzYa2zbvpoD4SsS2S+8ERmcyjMJlHxvIRGR5ZXY7HMpAIDtaM03CQJ1mn6SY4GpcDmf4HfewI3MeOqbv2enjcPISMXRMyLbA4CCz2IFhsFlhsFljwNpVFtwsFi90Eiz0ULA4OFklD6wwTBOhnQpNCP94R/vEk8NlCvqwBkEEvFvgMxbXVQlNFuVtgEfE00Yhk5mMSFygZacplpmOiugyR1yMTkrMO5FCJUjLRe7fAesu3yKnMJFc0GxY9kgUniXx4Uj3ypCAzr1yiJmVoMnfxi61P4GItXmNImRRsEpcZPQvqaptlnzYqdF6CPcq8Cs0QkxzQU5SM/WDfu+n7NCnDg32hXSQbhowTRMNg/ct8aJkUDwis3i3NhE1BxGBKRkIiRFtnKCZKqc+IXPXWIzO1BBFPTSTFiHTLBvqGgzhQPDinUWw6DYH7S9Zk7jWKMpjGEoKczRUw3Q+mI4iYLrsFdixGwY0YQCXmSpruTiTuTZoJ+8oLgjVjlo4UGleNShBdNP5Jokc2yL5SZHpmEvNwJzHyJrG9MEFEN6Kj2ByjbIQ6p6RqxfLRVB8tTAj2O0XFg5GyRmEASwQJ2UQ5Pai2gZ/eDz+Ba2IJ3KZ+qliLMtGJyNnUCVWlL50+LbbVok9LwunTXk6f0BQGXYYhidpbi0RhHnoiy2BWYmgTn8HswrQIKiwYwsVTK2YXSaY3pPiGsqgz1K/55toEiQEknChxaFwiWWLQCCFLS8LJ0t5QskSfjYZ8Jm0K+dTz0ib8iIqzFg+h3UUvHsEtkz4DXzxCrcXz+r+1eESmlu2BkIMxYPyfidPWYZlynRWNlxm4Uky2hhnkhlQT1DdtNBx8gQpKv4rcP6nykUBa+lw7UMj0yEbELQRODRWG/cMzjd0RWYaryGMjJDJK/hAyyOy4X6YhZPSh7xFH/Wulnnnniw54MojpqTuJS0AHxS/ZuKtio2Qn5HgE9SUbecEr2YkMwgqbYmYXv/tFB8xfzvLxMQs9+/NqK2pVI7spboeH6RvIBiEONBbvC60W0Ug3mTEgyaZmj/le3S72Ut6S2IFnjwzaJkYZAgtzrL5lQ8UtIJe1TVkBxAvSREd7eWY56TCcmcwzAk1MA00y9v0hJFDMaIGpeE4+IjA61iTDAKMV7nrozSGDGVljNvXG4hZg6Fgb0wslnTED6A4RwxJGsvDLUmtRM4TkZiygtFk2pGSTmAjG7kutxXb1RMADc4lcj+JPa6zLki2Cyfhgi6x9MqVoLcZHCbxkb5ZqzRFboujQSBoxNqCBkeMIUBQpwZD9Bhhd6Etlg4fDHYXQIYNGDK0jMGtliqvADCK496PmMQ5yLal50PRY5rrGTXhgQiEZr29lFpAQlCGc4Vc9kmWc3IJhQxPG56vowwtxK5lhRBND7M34iQSxSbTChKAE5DhZFaCPzUgQWyhKU24L4zTnh6kEbrIpSue6shh+OT1m7EiwPkoZzG1hZDI6Bk004VXowcjNZArSlKlT29R3bHhPxMxmqCkbLneiwvnNQluNpJGQoJJHHZxnWC7uE9Jj4xkVeOnIYyPjGKRABhVpksENZs1iePmWECWYkQrlvni8oMwRuBR5rciXm9jbFCy7sFeqRwybGSk4M4juqAgBDP34dRX3kN1abILHpMxWlSpJ5PqeymIt0aoSNml8QlHMM8dELkqBXOCyc1wxQWyu4HW/ZIJLk0PBtcVGSMMDA7IsRhpbiyqX2RvgpxJrQKMR8Pu0aKJiCaKGJdoZPA4iwRuhT+CVNOJ3uQa3rT8L+dpN6MI2QdovZPU9DnHygRMH15LpShx0oRs+OzbfBL8Gdxy6f3MaYj5dogZfID5JPIItqe8asuboFYWW1JKSILbDTTU/ioEclyYtwNYExtaY5GtesNaMQJA1McnGvsxuxkhV36fNATHJjtpLAYxDT5hkMw1xwBBZlFOzcXSzQp8p8o+32kHLAc3el5+eA36M3CNYmrWQfJ56LlEBq3nBrMA6J9CRq4k6+lSUfuZa9TgMZyEGyUQDNSKJyDu8QzrSIatTIoHQQN8FuD6DsWQjQelrtWXHtsiBQD53ZUMr3W1TzrHS7dSSzFtCoq4cE+C/hLBiD46yyUF8DKFjhJQh30Q4SepwEmISYmYv4oLwDiRBbPfvIVWQaoZ9tTLjoj+7VxSc97uF0O/mA2TrNWScYhBDwRop8JFaX6jMFAW7RT9sIePSZHUzHYvEwbVuB1stqKsFiXAtgcrtZE9d2BKKCIYZxnXvoIqeSL/bgVJCHHTxKH7Ue0CM6EO+Zey0vCLY8rJbWI56JiEYLoUQBkkhb95BysCsFXCa7eHds841B3bPOtecflSaxvVh1yJofZA3qjNkgEkfpTmtpy7K9XA+qNSa57CV0rzumgpGhT0aTY5U1BeQ+BSzEzAbGKeaKZ3ZQdq+Y/x6XGbcFRkpujI9FOh7vUxKeuEmgLts/OZchqtAsYMGLUBR4SpAvYS8fKbsQ2dlOJTVmry6pzZ+LEXZhphGwRz8lNWaneVCTANQrjpXjmO15jTLNAOlZVjc7tWag+U5V2sRZqnmoCgTPhM2CGAUO5VdTXoVBNKzvYFc/425OcPShycmDvd7i9IDj0B6zrD0HEzk+XOHeoemZ2G6V47PP/yRO7w5mWbxVG+eNxWzBvl9aempgfTcnF5+f7C5bF92rv8RSPYN9Rd6/Y/Azd4c9luY9QjcMaLQX5DmfQTuKPTR712+tByWut0bKPRTojAHf/rn0k+yP52evI9Ay+wOLdM6tHwEkrT8lGzvwxB3jaZp8XfHPwxx8XdfE3+3Fn93XPzD18Q/rMU/DANyi7A7MAqHFxYEYFBuQaDQ7zNH6fcVBMBX5MsJQHZuNv4E0rMCcHNuek7glvTs9ECBWbLIl5WL35uSha/hxrz0VDMrkOvPL/SdIyOnMCsrpSDPm+pLeciXPnzEORvmOYY/e5A/PdefmJg7bFiBLwC3pOf4vH4jEPB7U0OmKeD1D/cFYKA/3ZcT8CLY6ypizXBiYloA+tPnFWYPHFrg8xf52MuBqQF4yJuVleINIOBhmJ/NZErBiNyHCkLGVJRekJpbWMDGn8xLBV/TF934SGpWELDetPTCArgp3e+jst6sm7zZeek5wxMTvan+3IKC2jNREEgfNizHhxneR7JyvWk35mbn+XIK6BPNQlm+Ip+/AAhBfVpOYfZQfMxKz8ksgEB6amYBdNfitQFadgeWwt94LdevddQCuVrH+Ph28fHxmt+bxvODqY4dCsAb0LJzCwJafPuOGntbAHm5hX4w8vxQ5EMQn29wI7w5aSm5RT5/ig8XwjmAkurLCfj8CPXcoT4/eLWwD0FU9VHidl9egKVu8qWyRHpuQcpQb4EvMTE1y+f1Q3+vH9L8uXlYFlr2TWzZP7Hl7VrLPBM23pw0LSc3oD3q8+fiUoKbC3OgIJCWmOh7ONWXh+O2ZhtSQ74G0nxF6Szl1Qpz0gNafqE34PPn4Jv+uTnnQuH8lOz0nLoQdrg3Pee86EoFaqNnWObZkKTXZ5EwvhAL0ofnQI43x5wsjsPZ3oKClGzfWe9Tc7PZ65u9OWHLl1GEFK8/20Qr6H6DmUDsYo/ZSNMgkJubdQ4y6fcNS8/KokWGaJSeFbKo/L6C9LRCb9Y5vi8n15/tPVd7OLvp3iykhzDC580KjDgbDLkchilDvTlpD6WnBUZAXmHBCMSZ1BHgDQS8qSOQHp57dWbl5gyHod6C9NSUgoA/PWd47ZWaxorCgMKsrNuRuNXOSB3hzRmOCfwF79DcIp8WTxhprrCObCFmDic4ZmJ/w3HjgZbt428ZBi3x/2HgzcrKTcUPS7qjOw6MnnytC9If9aUEtJw2WqucVhqisy+tQMv2PpyeXZitFRTm5eX6A740Dcudc0YIOuBNDaQX+SDgL/ThNgShS/o2b3ZeLaTyewM+yMI/ebkFPhjmzSrwhcxlTm56gQ8Xme98JGKYN82XEkjP9p13h8nLzfIx8tPOglgnDSmLFhjh04Z5CwI+v8ZK3XBRxYbl+lN9kIodpflyUn1nzx1RFW8OlcpOSc0t8vrT6fEca6ggkHaOJYRva8MwMTHP50/PTQuZButVLb7hLm8gdYSVeQ7w8ByLbIchVG6OL/jlZgd1zwOf06G5hTlp51wFQ7N8OWmIv2kwwpeVVheTUxDwBnxptEn40hC+BQG/Nz3Hl1YXMcz2PpxSkOejArXXvDdneGGW18/zaRH5UnJyA+mpvjRkkEwipBV08HvTLFJU65EeziIJiL1pKXkMImwfGOpNS6E1hZtMCCan5hZm5WYPrb3Vm6+TfUMh2e/NyfRqvbLTM73aIG9Omtfcdu7LHgLxuNeGdajdlzl8iEkIgshqspDafTfzWmFvWnq1lkO1lmlayz7m9nYPDBp4e9+72cfeBWYGDDAGwKD+YPSHW25MMW65hUB1M9xiDOgNfQckw40Q37FT5y7XJlzX9Xq4sf3gO5LjurJGCJUe6AQdkUuI6wheLcuXMzwwQuuuxcND6YER7SHb+3Drju20rHaaL6/ggbiOHTq10Tpo2ek5rc3ndlpB+vBsb0o8vcWybdpoSTdonXxxnbGoN3VEeo4Pq6dn5eZora/3deykpedoabmFQ7N87bSO7a/zdcEXw7JyvYE20BoZxzbQ0+v3p/v8g3KzfAWJiQXe7LwsX1prht1tzs9ottOCmxfjBawS7a2lruEH0Ifx4beBQYV+n1aU7g8UerO0YYU5NPlaqjcry5fmhnba8NyABoma7+E8XyrSWOD/tAowDmjKm8JNFZFfLM27IbJaH9lgTe9vHx2rn1rx+57+Qwfp3b4Z+MzMnNHWe7PqxivG/Xrrxin8fUCfMxv/vaHX9b4z/fvEematqD2sgfB/rF6a1V9d7Q2jfz/qYHzuUUS1BxiVHqUHK13FW7+nh/kVZuvhzzX8t0sP69l47SpFOqkLYOy8SulZo1/ycPg/9n6FDsbbLdjwdrWoe3hxNzb/9buEtvqFh7egJR/empaK/6aK8IIm9MbWCW32/kitDg7W+o3nHTbpYQ7grycyygLTR+hgrLlauS1Y76Md+O8wPfs++shgH/JLd/b7V3dzPOHYcz1v9yR/P0MHo6SV8pkw7f5/bvzrt2rrc2rDxfz1dhoc33ZFZ/3rp077ThyqPiu/djlz+BNevOvDTlvM8g9av+bwpr57rPX9U/dYs0s/DX60nlk7E61fs77ZPq2V2GpdAAARAGQAkMA42Vr5R2Jz/zZva/1Zv5KTffNABQDrN7GxNgZFYBsA1yqsvS2zUz4SRv+oz/hSmz553o/6iIdftVevHK2fmDquUu3qKYcPApVHy0bqPe9N3RWxeLr+x+7vJnsHFOttPJvbHtg2T5euzvs1Z8EcnUBTP6984sbrn3PBOH3J1X89NiOmt158U/3WQ2OW6pNGtnu8cvQSPWnM+H8i2o/Xq4o2delVXFDeqGF+4gd3Tiifg8O4/qny+6dJRdc+Mkc/1bTv6DzbDL30zA/3rof5eupNS3a9UjVKF15wNd+1Z3B54o9JqSmvPKl3XfBx8aOdl+jFve9YntN+gb7k+R/vdK58Ul9Tr3jjyru85S8PeK76skl55WceHWc7IbXXBz604OGdjR7UW6Ru+HPUZ/l65cBmn/3co0h/bu+GTfunNdevKrvBKfx5W3n24NgvHfck6CVH0xueXjxJ/3v1/NYRk8bqNftGbjy0sUBv3WYdvOBKKg88tr5r6qzby/vf0njosd59yhHmWY0AHACAUxABAAM6+7N9XX0PE+0u6Bh/W2HOcF+/wkDA2/eW9Ot69epVq8R1g0Y8UpCeWmDmLnoEILkRwLZHAFo0AkhrBEZxnPLgwLe8tuGr9utN4m6642/3z/rc40/uUQqq+fOf+ne+Dp5R1zya5Li/QeerX3gyadP2mkcnOvL487NJZj3+W77H3XnUY1+KPfhvBRjVcUplw2KWH9GD/1ZIHBfxf/u/cHLMn0vgpgE5cKpNQ9h9VyvY3+UYDP26ApJmPwdGyY2Qeus/8NaBlfC6dysk5rSAPf17Ql/7QYj4pT00n7Ybfr38H2jzcnOo7P4iHLt2NNz0VnuY9/NYWH91HhhPpMDnz14Pt4+5HuYdvR6eThkLrf/cBCev7AYHzsyE6Fk2iOlQDZH3Pg3ZV2bDx08kQMT2VpA88HVYMEyHuF9S4M1WhfDDr+/DDSN/hxPXO2DabU/B35m/wJUvp4BzyDMQL90JI08lQ83KTNDKPoaEo3Pg+xWXwwPeZ8HZ7EcYN9sHixqkwDM9RkDx3jPQqqA/2O0d4cM7G8IHywtg5HcPQubkCrhsS2/4aPhmiKjcB/eMaQtPF22BF5o/Dzet3Q+X3bUblnW3gc1xBjo/ocO7nSph1sAD8NbjneDqGzbDFZnVsPDkA3DtlYkw6o8P4fcJl8NjJW7IaPEYfJbzF8THPQQNu90IGxq8B5svmw+rt7wL7fob4IIhMP7xZPg+Pw7mvjcHOg8FWL/nMVj/4ky4bvBn8EX347BUbQL9i05B2vy2kPfFSkh97CQ8uu4uaNzwJ6joeyd0+/xLeHFsV2hx1Xb4/KmH4N47rgK48g34PbIZXLbzG1jY8QwMuyIDZt/lhVV/94YnRu0Fj+916FQ5CX4sfxCqt3wEWQkRMET/FBod+ALu7nYADsydBns8raH1+Er47u7+8N6HncD5fSM4+Ph2aFwxCI5c/iI0OXgftK/fBcbEDoUxfQQ4NuU+WL1uFFzx8x/Q5+YbQR3+Cby0fy+sSekJGd6dENm6FD6ZvR7sL/wB9z80Cpa+Owa8SRPhqYKHYe3keyH3i00Q90IqHC3fDs88WQ1XvzMcBn/YCz78MgFaL98D73qfgdgPHgL56gYQmzwXttyzBbZtvQn6v/IsQOMj8OmNq6FN3x/g9GcqwNun4IoZOyBvZxXU734MDv9eDK/+tBneP9kapttmwDv53aF9xKug9DoCE2PnwUptJLTfsBB6T3sXRnbqAK7B2eB/sQQyf7oSOm5/Hh5pdDMYj3wHR7+ZBJUzZsJ3P46F2R1nwsTfMiElJQHeOl0P+sxZD8NLsyDf3xOeGdIJFjbcCGU/RMAzHVvCicD1EG9rDlEuAfo5R0C7qruh90slEPhJhE2ft4ATj78AOX38sLBRNUyZ8QKsf/Y47L79Vvg48g/QZnWGY/2egFdSR8D+7inQY4gE4yaNgsG3tYHr0ioge68Knfp0gvtuKYQB+Z9CrztyQIl4B9oeS4cGwz6DVo75MEQeBOu7fQ2/FG2FCX82hr6Zj8Plrd6E59PbwHs7VsHqBndAyXcZMPHLSdDOPwjk0rfhIccMOBKfB3CqFfySvxyGvdsX0g7eADP3j4Gl+ky4ccZpiBo/GToaB2Da9fNhf95kaPz6T+D8phs0vO4auL94EdxbPB3UmGkQXbkXsorXwtdn+kHXkmi4p0kRDF3WELzb34L3J70Bao9NsOcPGfoWtoJfXzsOX3vegsgGL8GkqztA2pgiiOjWGerNaAq3Jr4Ely99F9b+tgbuvzoWst/tD3GPzoOKO2eCpI+BiJrjcE2PyZDdcTZcv94BLq0h7N18HxybtgXeW90PBny4DF687iP4cUUCrJw2A/b3HAGXpR6AosnVMOLp2+DU19fBmsUr4ZuGHQHWLAbX319BWv9h8JvtdWjji4e77iyH3mcSIePPN6Dw7SPQevo3sLI4HoZNPg7y9obwl8cOXx66HG54tRTuajYVEj6KgAE9f4b6b5dC56s2QM1LTWGgbznseWcZKHo03PfwR3DVn0Uw8mkZJjX2w3sv3A65Od9B9a8Ac2++G7Z89Tq8NOxNKPr4Y9gtXg4v/x4Hk2e/A5tXPwTj+3wFJ4YsgveKj8Kqmg6w//Ac0O8vg10HsqHk/Suh7devwdKWiQBr58Dq26fDa3fJ0CZuPfQrfgK+crwIRS/Vg5H3LIZGsW1h3+tx8NcPp2HS1//ApLdPw6GiLLCvOAXdi/NgXE5DOD3hDLTu7gDv8M7Qtsl46L/pF3j1p7UwNTsHnht+PXQsvw/GftEH4r9pBO/H3QgtvdfCB3k7IX77RijPOg2lsARsWYfg3v2LwJ3bG4bG7oE37h8Led6+kHnnQZh9mwCDBl8HV3z2OnT+fQvUz0mBIfGHYFz7FXD5K5thcacEcL5eCr+8/Ck0OuGGqemHoNWZh8AlFcMzPeJg4EeLQFs2G15d8gl0GBIJ6//sCTFfbYfH394Fc79+B1Y23gQfLnkSnBn3Q/vBjaEVDIZRDWrgW8d4aKCkwfPGMzDh7QPw1em2kNnyNRg5qQvYjvwDb5QvgBEZA+Hmtsth4JZ7Ie5kGXxx7yw4+v5zENX/GdASX4DSu1Kggf4yFHd9DnZoAuTvHw8fHHgNyh88Bv19MSA4MmHyulXwSsUuuHVwH7ji73rwnH8zLLV3g4oe14J930g42GsHDGjzF3z+4TaoPGLAY2kHYG7aXvjy7Y5QOnMzPHT3p5D+/Vao+ao+vJmYBMlNkmFwYQrs2XQMcqa9B6vaD4F6N/0Gzbv3BO+WCdDm9M/w0+dHwPPYh5D77LXgPLgVznzxDORkfAfrTr8H053vwGNDApC5+hX4KGc+dPePhPdiMuDExyugTcE3sOGDN+F1uBW+eyUKAm+2gB8efxACe5+CqIbt4MkmLnhi2AwQ2jSChY8WwenTb8OdvarhyycS4PCX9eHpN9+ALTNPQcflreD3nM0wY2sC7F1+J6xfvgE+3lEPYifFQe5dXaDdnZNg9s7v4XPtDch84CXo3nYexKTsgNPKzfDt0b9hSrds+G58O/j507Fwav0KqK7aDe2v/QA6XO+Fru6boNmX2+DJU5Hw980Z0KH5Xrh9/VgYMHsy3OHZAW0H74OK9z4H5bLnoWneRkh/Lg2uvvdB0G+rglEx0XB0Qwyc2n4MupTFQZeyKqgcsgP2P/AgDJ8yF6Z1roYPGm8E791z4du7yuDWMe/B3u4q7M/vA3HN98PaJovB3S4Z7jnyBXz56CxYcEcFDBz/F9xpPwU/PLIGJnkSoOtqDwyfvg8GV74Eo6/uCh/+NBdujSqF2Z1fhhVf1IN0Wx/wvVIDoya+CBNvmQl/7k4A97RXYeTom2HWx27osXAf7Os9GL4NJMLwX3vCP/O/gQc+TYGRw0vhzVWPwuDjS+CaiVeB8eZguCfHCe624+H63mNg0vc/wg8LPoW+f/eAM3f+DM2jP4St9zwFM/66Bj55ZytEb/0Yvr53DfTeOh7G3TgU3OO7QbtHZoDqnQBtbxkJxe2awo3lsTDx6hJ4OGkSLN9yCH74eiRsSXwXrj76C5wY/hRETSsH39Jr4IbpL8OmxxQovXUftNqfCunf7oc5My6D5W2egxE7W0PEb+vhpoUaDJj1IeSNToUnHrsKot/oBC8emwIN7vwJ3L87YcP8tpD7RH9YdtmtsOHPlTD6m8/h+f1eaJQgwpbEhTBmyWLw/5YN1z/zKIzeuAIyO90Pya3uA+jyG+yBh+DU0cEg3NMfDuYXg/H9ZlBWCz2QdyZ58aZA93/9Fs9KPpn0L/n0wVt3PNwNn8c0q7keAHpoLR/tis+e0d8nYPnLj6Rf+8/oa3y9Gw7nImnXGwH++qdn+6LyxG4LyuaccG3adBrtVb7Rk+4YPHjw4K36s9c0/njw4GV6412lw2NinuSy6rae1ddjvR/1FltGn9lUvlPfcNT1hTNzlb5jUPKela+M0ccmDph78IvBKMNvBWVPxxo9p3xi04Hd5iZd2/nvFTccr9aH7Ns7r/6D+WXe4oe6zzlcre8eNkF99IGSsnGjciobfl+t1z8+/Nrb9kxOCoxr+Mm6L6v1v6b8eVXxzqfLDhzf3yZzV7Xu3fajd8CJB5O2zS1s0uv9an32J53vO7S0JGnMkfc+7P52tZ49csyQF+bMTIqe9GfW3Ruq9VPVp6c13TAl6URv/zXTVlXru+d1yLvh7e5JS3Z/0unw0mpdySmZ1EXKKGv2yT9rh82t1utt6tD2tjufK7v1vthdwvRqffAvAyZXFw8q29Exq2LTU9V6o6OfvXHVB8+WHYxbsWbO6Gp97eD7f/7+k+KkW6cs2zbr0Wq9z/RlvzRsVlw28tbHkzb6q/UbOh0YXHPl1LJfnpnc9c+Mar389vr65ElPJxVuz/31vtRq/epfY4rmffl82af3y2MP3letP9ghsfuJw3OSXnpjRMcJd1Tr87uO3z76p6lll395yjOof7X+zOYXbjJyn0r6fPLQid2Sq/XH5UPrbI8WJz2/7/Fn++rV+ozly78/PeX5pK5DC3Me7VqtP94n8EeTByYk6S+8MnBnx2r9j5+unHVN7+Kk/Y995+t1TbX+gDNfH7nx+bInU499+02Lar3jyojsb0+MTvr2wJXH5l9Rrf9Vntt0rvuGspIvv9o1qkm1vj7S5R993dNJinTohXGx1frU7TsnTWuQk3Rnh+4r1rqq9ddWrutf2H9MUsPXO0b+Y6/Wbwms+k7oOT6p495bTuUJ1frNJz8Zcv3+qUlnGqW94jxVpcv3TelWvHR82e8Lp6VsPV6ljxjUb8dvN08r274i8boXf6/Sp8Td2uykY3bZsL227DWHq/Q9CTO6V+7OLzux8IcuX/9UpTdstvPVyy6bXfbD8vqb476v0rNvaftin4XjkjxdYm954UCV/lR660cfjJ1e1rx4ldzrqyr9vkmN+0x98e6ytu1PuCM/r9Kbzek7fG67x8pmLh/05bHdVXrMqncf/C31xqS4Sd4HnTur9Oo0e7eIYc8n3QWX/2Z8WKU/Ii3+6tsdOUm7kt7ZsOS9Kj0+NlqfcmZ60oFPvqhpu7lKX7f20bd2lhQltWqb8NlX5VX6Qwfv+HXT5dOTovafnv1KWZU+ZWk+dJkxtezFdvOLXnmjSu+7dPq+HQcmlPUc9vGSr16r0lO6Rm9678DDZaMHzr/zmvVV+vH7Rx5Ojh1fFj1tyIelL1fpU7443cR27fSkr1ptSOi9tkq3zX2qw+uzRiadfn/mp7Grq/SIO5p/921qSVKbO/rsd6ys0n9577JB497vkvR68j1PXb2iSr+2Iu2aHzvNSOrjXt0w98UqfWHRbO/NhyaXRewreuPbZVX68v7V3bZ2nlw2bnDiuidKq/Q1P18z6eHbx5Zpm3d0SV5apd99950P7985vaylZ/Dorkuq9LTLnih+Sb0rqWDFLZ8OXlylt/Y8UF796vSyj7qNGrZgUZU++o0uE1bHZpSVf6UUxi6q0qtWZG+sHp5a1qGpL+mVhVX6rRMP3nHDvuKysTNu/fPxhVX6x93vfSLtyofLAimHKwsXVunrHn+64uaq8WWBJ5f1mbOwSn/qx8FXdLpsfNkHw3ve+evCKv2TTyMe2D6vJEkfcmBg+qIq/fJl/d/Y12lk2QTh14IGi6v0zIrhd5w+PCOp0zvxwm+Lq/TBWZ+v/PZXX9LQAR8nHFlSpff8+NUOWxdPLItt2v2OVqVVepfruv3+Wvr0svo7b5k9aVmVfsWZyxLHPlBctvr9q5Kbvlil59zl3zvo0xllv027ae6Xy6t0eKrefcNXlyTNHvbUl++/VKWv/6XmnQ6vP5P09aK2PX9YVaWf+WnrvAdf85VNvmlDo05rq/SbUo7cM+b4yKSEhxrOXvNylT7mhitevDJietl7Z55V7ltfpbe5IuvpjSuGlP2w9aN1171epd/zRsljf16VVRZ927btN71Zpb/051HPjTdOKxs04MDC0Zuq9H5Thn2R9eG4sjcdH+b9XlGlt9r57DWn1uYnldQsHf3slir9rYLIb6/dk5101VXfX5a6rUpP9Qz1yFsnlPl+GDJy2I4q/bOO330/vvnTSZ3jbj48d1eV3vCtsk92v/Vs2ZCW3V+RPqvS93SsmtdxR0nS3a/G11/wZZX+6r0FOWPTxyaVn35kcOaBKn39/CkzP/pmdNmjRz4pz/y+Sp/Qefu0h5pOTlr9yb2zF1ZW6X99ufvmqSNLyoa99kwbR1WV/uaafXd+uXlw2d8NB25ccqRK73H8hRvqlZaUJd7zwzP+P6v0LtNXdz36+Yiy3g/8/UfRmSr92qfuzvyu6tmym+2L49fZqvWP9qdEfnEmkLTnnX4lV7iq9VWzpv3196ZnyyKu+OK+d2Or9Vdda+PX5BQkzbtt3P65l1XrM04vvL/T91OSHt11JmWlVq2vuidi99SDY5P67b6r/e+tqvXhTQd0XftRatKGn+wzsjtU6yMum5bVLnN4UnpJ9T7tump9z4YdY5o8VVz21+YhgxW9Ws/964w+ZPXUsscmOW6O612t911R2HVNVEnZH5OinBMGVusvOm54YdzSQNKE0r/3Nbm7Wo/29NAWPDu6bNaYDxp9/2C1vmraO58NundK0rhOX0s/plfr/TKFVfckjk16cL1wxF1QrV/Zfb3D/dnospS5IzvPfKxa/yCqd7c32k4qa7P4WIPk8dX6JxMTH5RfCyQd15/+qX1JtZ7vn3/r4a1jksbc8v7ft86p1mue/WRq7ImpZV+VlC5ZW1qtPx646rtZa54p+334lLg+a6t1p/aSUbZ5SlKre71Vzd6s1jv9umLzjGvGJs18M/O6a7ZW61XjdndckfZUUo9eOfcV7arWf/u+26E3r5tS1uDteatPf12tz//o2f7dJj2UtLdkwZPv/FStT9rxoPGO7fak3/OnXvPukWodujIOIX74+9PvOtL+BoEdopffF3/rv1iLz/SSXr+eOXPm4/IY4fcWr87+QF+4zf5D4eCt5fywvfwhZEAGf6ZvJ47k43LX/udmz579gf5ir+HImZTHH7hpaYu+7+q+G3qWnjlTXv7h523/X3vfGRZFErV7GhCEIRsQI64BA8oMmd3RYlZRWUFQWCMKCAiIZBAwMWIEVAYzRlx1zYprRAd7EFRMSFRBVNZVcg4qpr5dPT2CCLv7ffs89/650+h09VtV7zkVTp2q7uoZsTZIjCjv5AlViSnkuuxz76JXX0EPrXPCesy4RB58UZJeb/IOgag0MurBE3JQhcHiiB7vEIDazdqAJ2TSpQ/dXRvfIiiZ3uOvHk/IlZt6DPo95y2CiBEW864+JnMu3uLYnMdhoejX+Y/Ja6qGxpMT3iKAPkuz5R6TQ37+oc/BoLcIRKL1944XkIUDjybaz3iLwEF+5gT7AjJjaPzJmcZvEVj5ppu/zSd7Fu/3vdAT48c/H9ufT9o6357h8bYFwfEYy63W+aS9QcIlr6ctCK4mWzbX5JEvRPPui6+1IAiMn5i1M4+M6FvY6La/BUFSqs5Aqzxyw8xJ2jOFLQiEk+peVeSSeb5lWbvcWxCUcC36bc8lt0UdezVscguCjUWbbo3PJddYK/5MjWpBINIf+WdFDvky9Y9nP2i0IHg/ZbTfjhzyyQuTyfFNzQjep+zxEuSQViNePJrwtBnB7rrt2TXZZObhCMn41GYEms/6HN2TTcYOK0mP+q0ZwVX3GaWTs0mTtflDu21sRlC/3vqHqkckZ4xuvyy/ZgTJOmG/TH5EOvWxzCt0pMNczXETj2SRc9denKj/I8YrJqrJZZEf3/cSXNLD6cNH/ub6kDzfPL4oWonmE+1QICQPyPgvs+bH1zYh0IyZOVLvAVlhy0kqLMDh1Zt1Vt8nR6dpSlxTmxBk5z24++oeebUobPTQozQu0h5rZX2PlMs++PCHzU0I6gd4hx+/S/ZftvbWvLAmBNwpPn6qd8lXZmdssuY3IZBY/64XlEla5dvtjpyE8Z4X4x/fIYfep7KcDen0gQv5V/l3SBu1Q2HhfZoQuJrv3XP4NimyHG+eSTQhSLrixOPcJgXvd1yfVtWIgDt06cqQW2TOCV05lQIcvhm/vDiDHPX5yvHWG40IIHe6waQM8lQ/1WX9T+DwGnFscjrJvdTTNXgbDtv4JvZLJ1sOzZr1YWUjAqsjIqcNN0nypwF7L3g3IkiKfJ/SlEamtsSv2e+IwwbDMl3TyJ+63z15ZTwd1ns3KypLQl62OjGaGIXxLzbFfAlpJHiwM7IXnb9wqjh1Fknu/ZQ7QI/A+Vvt7G5+g+RMsbNprm5AYNU6frdOKunjGT+j5WkDgqSn07xar5MrVs3SGnKrAYGroV5k8TWyYvj90BXnGxAIR5SlS1LIy30NVIkDdHpJ8IVJv18lUwMvL0+OpXE4fYHYfIW8LK4bFhuOwxbWDaGXySKerelmD5x+g5/6gkvkcxd9Ucp0Ov+SQy+cp1wkbXONjqgjzL/YrtD4AlnUqhkcZ4D5b72P1PuD5F2qHsHtS+N6C3dPUj9PnjNZW/RRCeefu3jJh3PkBd9pGrUt9Qiswn/ZXHSGzDo4ar7ia3yzb93ravEpcvBRA/eJuTQu0baKOXSC7Lv71YpjEhyWM5698RiZY3Z7jeE5Or7wsdeCoKOkZY+k3c/247CnTazzYfJl2Yxzpzbh/Ht5/GVziPw4YprhweUYr4qWBB8gdeNNN11ajMMzZjT8uoc0aK0+WjsHh1c/WjhuJykyyHloY4PlObnp44it5Ikz9bdvW+Bwq95y3ibyhFFkD88RDD7fVHctOSWkUn9oHxyuvimvHUHuON9TUaE7Dg+NVFZwJft+GP5uUAm+2yha21QXgEIr3W72P4TD40wFxRvQ2MTVyZrudFh4M+Nw1jb08Ewt/+0wjMf0TDu4F5X1SJDPrMB3c7WyniYfQqfO348Qnq1FICGy58UeRXtV9//WN5TGhU+t1jifQJcSVdYk/IjDs+oW659BM/e4KpcQOP7uN7vDktHu6+FviHs1CPTU/mpx/APJJ6zgNG6twfUf93zsRZTl/HHRaecaBJJZG+YoXkb7Xyw4aaCP8cWmS4uuoIcGvuP9G6sRuPafNuFUCpKLPPab3w0cVrt+J+I68utu7jc8rhqBXplRjwmpSGH2/NTtszH+IoinQqJNB68bXxpejcAqYXQvLwlCZdW1a1qqECRvjV43OQ2l7XwW9jmDDnPvPfQffhON+GW96sAdVQgcbv3+RD4dGYyvu/XKswqBpjE//WU6itt412uKeRUC4TJfs2sZ6BfugMFTlasQ1OeMsNx2C62qa1xX/qwSQX2foQ8X30a/jXPlDThXSY9Hi6rfW91Bx2bnodJojPdtkfTKRHEhynVWsyoRCN86jazIRPpTT4lGGVQisHovZ3b9Lspp3NYjiaBxMOhfE3cP9eM/G3rwSQWCbMJ5+rz7SHT+TrdhZysQSMQPvEY+QIZZuxrHrqtA4DqlwPTtAxQ29UjtNWeMTzJJTXuILKaU7b9tQuMlj64Sm7JQ6QwvQ3u1CgQiHYnyr4/Q/ifUlhml5QiuDtJeop6NVsCDg1lkOYLsbepXg7KRevqNIkliOYLA9Qd887PRR50hJ/VDMT7VeINZDuq+58JpsC9HMGWIl9ruHPTreM9ym1HlCIQPSqj3OchVrnkHoViOwNv9icucXDTycIn7sFdlCI73VOam5KIzl4rDL9woQ+A6QTO4Tx66OWyX18m9ZQj6VPsND89DsxR1GpUiyxBwz320L8hDqj0eP7s3k45fYvhXrVE+8r1sT4BmKeLP+zlhidwq/o6LdvLALUWC+TClktzMj8jfrgYOpejK0cfrj0Vt4Z8JmKYEgaXIdpiTb+UnN/5ZjZdfqPhS9Fl9jq3+qhVi8S13JUguRURR8RTvtFjx2zTngZBdirS22ezvj9bwx7/tVkXVlSLHMa/6KghXiYW71quDZhmaEakctIhazteu8PpEGZahoRtSh7+CTfzFWqtfUvZlKJdo8E+Q8xeL9nlpQGAZCt3n9DDok5fYNHPVByq+DK1RaDmQdmM1v/Sm3hfqXBny9HgwUmdVoBjuohrqURnqH7e8e7BQKF7ad3gFVVeGzrbu9xsh2cwvP7xPATTLkbHtm+m5UTH8eINtOsAtR6ubuJcrvsSK94UYK4JDORKbevqSZAz/dszPehBYjsKWazV5knFihciWKiq+HM26P+43f4gRv1QQ/wDJ5UhlaonFS1gpju2n+oZ6VI66HaQmBcFG8YQtCZ+ounJkEbgse/nqNfw7Lh8GgmYFkr/4cmnC+Bh+yvJJPYBbgZbK7Z46TRjFD1CqLaXsK9DYhVRh/ap4cY42/wUVUIGuWQzfeTI6UKwWa91MxVeguuMeCf2EG8Tjx+5+Tp2rQObb5saWWG0QL/poU0M9wu13b1r3LMSfvq9BD+orkMq8jfonUaxYMdlaCzQr0cyi2YlTqFD+h7fXlYBbifr4jY49dWMTP3LALk1wqETcyIjn975s5E8Z2zIAAivRs1NPxy0VxItnGM/pD6JKpL305lo5cot46nj7UZBciVwQxVf47CPOGXj2CfWoEl0MFGmXjY8WRyhMr6XqKtHhF+ol4xUX8+epeT6jNKpQisogi0zFufxZ905+oQyr0AD+kNCBRKS4+NqOQsq+Ch0ctd5bk4oU7/M8MBQCq9B4+/XZ1lQs36r3hlYqvgq1pt/cGf5lBd/+vkIuda4KZYxurNWn3MXWzoJc6lEVGlz5U+0Vaon4pbL7e6quCjlzxu6SF6wWOy699CelUY10F1/Z7pEWx/9r1ocGyrAa1dzmbq774iEe+pospuyrUdjkarE3Wit+l+JUQwVUo+oSx/rDq9byC+ITq6j4atSwtXWz4poQ/p7BwwZDcjVSUO/jseWzt3jfpO3PqUfVKLjyTv8bq7bwl2Z8rqTqqtGXjQfPWN7Ywh/9fk9v0KxBQXNTjiesDOMPeKehBtwaVHQn0EeUFsPP0IispOxrkOqX2bfM1WeL32woHguBNWiiRprdY2GU+GR08WAQ1SBn58/b41eEitfI+T6lztWgVW6Dbw2I2sS3nLxkJGTXIMfz1B8HiI38FtHEN1RdDYp5MON2Lvjzt7899ZDSqEW5PmP0rNZEiZ9nznhGGdYij+797qXBcn5d758bKftaNP3U9uTjVDBfa0FsORVQi+bcqDsf8naWWI06oAWiWkRkchZsFq4VT9Q5+pI6V4su6U0oUIQI/qEo7b6QXYu2Os90fS/nIM4QX1OC+lqkVWo6f6LVOrHc5mUtlEYd6pZQZ8n7aC++E/tmIHDr0K9aIY2nV8fyt5tEt1D2dWjCnSf5AhTL97U98YkKqENhEbv7N8stFAsyWv+k4uvQ1LLw5pyV4fxVf5XkUufqEO/wij26RID4wOvw/pBdh86fzppauzqIz0sveUfV1aG5GwIJ827+Yn9Xz2ZKox4VqfS3ObMqVjx72fomyrAelfzxKd0napdYR+3TZ8q+Hs3bft/kC7mLH233UB4C69H9ma8layCaX36/sZWKr0d9w8xvvKT8xJ5FqgQk16Oq4aVno1CC2CLvCAHZ9ejdwSmRH1YK+Z8/F32g6uqRxPdxYDeFcPHOz9c4oNmAFnL81uYLt/DnN7/5QBk2oDqzzx4fyP38wj0FauDQgM46aAeGwx7+nl8Ha0BgA6p98der1s+b+cOd9D9R8Q0oJPinYi4k8Ofwx2lDcgPaSMgLI6MS+VcOjHxPPWpAXpsOnjJq9RRDfmwzVdeAquYd209GbeMfWR+nCpqN6Id5nxN8hQf58hPWyQO3ERmTB6tuUtv4a9+KKcq+EQWPHbuqjFjKLxw8soUKaERuqlFLr3+K4vN/3NYTRI1otECOf08uWNzD/deekNyI5AY1GkcLt4p/mvGlinrUiBqL7S1WURvFO89c5UB9I7ol4DpMp9aJz71a9pHSaEL7RyzYGASrxVEup79Qhk2o15UraD6VIJ7p9bsqODSh1Oi4H6KjdvAHv/uoBYFN6EGBWsY1EPJTDOe0UvFNaPqxP8bsR9vFP+c+V4DkJvSnxdJA36h1/Fl3/2ihHjUhnjap+aPcMn6fi8mVVF0TSp5xfpFf1G5+8zmjXqDZjIau03Uxf+/FHxk3WQe4zWjC9OLgUmIN3/3ijjLKvhnNjfnjqg8Vwy8JUyinApqRU+PNveclO8RlaQF1VHwzCh71Y6Oy1V6+wrEbb6hzzch6pRp5hdoufqGvqQPZzWjc4uIgD0mi+NX4eg2ob0b9HddxYqJ28XOmFmuDZgsyO7IoyFPBlb9Mv1tv4LYgZaMhWVnkTrFt4LNqyr4FPTnUrVuwXIz4hJNLHRXQgrQ97qqXknv52pqlOiBqQaK6c6tvrdrI3zr+rjwktyCJKqnSXXBQLNa1GQDZLWjk5GEfR63eLY5ZdrWMqmtBCj41wiurtos7rkfI1hlcmXWGN6Qi+5DftF/nJCYmVqBlR0Yy1yusp+ydZ9NIpqPhcaNlDxEmvUUgaH0LHJ3MlMZog8ekcKb5iKEXP/AZVIjRxHfA0ek+m0zNKSD13pU87X60fyqDumI0BaOzrXXClxaQfg6XC44sHCJFrTBaiNH3Yzac6VtAFnglH3i9tlQsfXKU4cVoRPgOlxv5ZMn4kdt8+ilI0wLD+x44Oq79b8a55ZMP1tpOMXzaQ6prSQvmxejx9eu5Cvnkj5zomqafi6UySzBaiNEpPr/a/p5Hum6fvv72eT1p2iSMtmJUuHvP88l55FbhrXy7OcOkKF51ECS2AkdH789rr8pzyaejryQOXD5ciroyvBjd+KLH3JhcEiU/utzzXq92aGFXqBXDi9GIRx8FI3PJpUWOI4bO7S3VV4/h/QAcnd0+abszc0gFpzJv8blBbGkwvBg9fuqUs1cOWX882vj2oEFsaTRjXoxOOdsa1y2HXDS32+eM48OlaSUYbcWoKOTV0MPZpLp886paX1UpmoTRxI/A0cm+uH2YVTYZNab5wFWzenEbmtIVKmR4MWq1wK9PyiNyAz/x1KhZamxpMLwYdS2+f6Y+ixx6bv2+K8NHs6XB8H4Cjk79KH8l/SxSk0JO9oY6bGkwvBiV2PsOdn5I9vO+dz3h2mC2pTO8GE3ac+dd/APSZO1Bb/tI/XZoa1doSRPm/YxLY0zo+pv3yfgrcbzkabpSVILRFIxKhNPuNt0jF4keIvdp16TtKgmjhRhNfjVIPOQeWZk2qdhj07DUNrS1K1TI8H6hS9Khed/cGXfJv/LTFApzRrH9iOHFaLaeZ1JUJqn84VkUmSorK4YXoyWacjGn7pCzf3EMFj1rj7Z2heoxvBTOWbdM4/FtctGrPw4vfq3JtiuGF6OiY4Fc6hZp6aB5cMKBge3Qwq7QkkbMi9HkQ3+9GX6LjJ+nJIp7oce2OowmCgmOjvD+ktF2GSQ/wtQtTVVnXBua0hWahNFCjIoG6n0KSid/dNK3Wx/RwFokhhej9YPez9hxk+yeEaTD3TyULUmGdzXB0XE1LBh1JY3ceVirzxHh2HZoSleoFcOLUVH2ilVPJGTzvPKNO31UxrWhrV2hegxvNJ1zyTNeQjVJNhofdnYKY2sfMHotmuD0Hu2vpH+D5EP9KAOTUePawKIuwJIGzIrzlcyLd1ogJhVvuMyepTqALWWMJq7BrL/86Lf1Gpl5cl65qSVryxg0pSs0CaOFGE3iPbZOv0p6zzS0G7miRzu0tStUyPCuxeX4Jja3/jJZFGJ813wXa3FcGV6M6ikipX6XyFkLbrvNk2OtFYMWdoVaMbwYLem384ngAvmyR+uDogUG7dDEdV2gegwvRoWHa808z5PKh+OXLljRky1mhpdBtSRclXNkwhazNQfmjGmHtnaFluAn+BPXY1Q36PnPp0jbwMdvlkX3b4emdIXidTZBIUYlRm9nhx4jaw81mkz6ZJDahrZ2hSYxvBsw+iVlw4HD5Mkvw1uuyLXw29CUrlAhRos2EJzeEep7ow+Sr5VXrRguHJnaBn7oAnRlWDdifQqU+qXsIi1//7DNafMItpdg9NpGgtP7U/JxSTy57/e8tysGvhS3gUVdgHoMKQY1fUeVRJGvrYrU0Cvd1DZwT0znILODIiuG4Mjhk5oYgiMvqcOZ4fgxYb00hah89P5E3zusXRNiMDEWa7Bt9kw9Ecp990pxXrHML8HotViC0/vuiGE2u5GJ6lyja0msKQYMFuKkVmUx8wVJyPFJg7NEi2Arsxaz4qRj888uOoJGfE4NC+nN1pYQg4lxuD4O9jy5/ThaOXxu9o5IVgcrjKYw6POHIfdPI6URTyc3evdl1cdoIYMqSniVZ9Hyn+7aj9dSZ21tDW4lGHWdlPPTrvNo7wG1mfONZCMPRhM34V6Rc6wl9QJ6Mu3Z0QWZbK9wxWgKRpN22c2tuIQGDpjPV/RhZbbCaCFGJZUqeXAFGdXsP7F5YLW0DQHDi1GrOfMXGKegosmpPzprDWELoxrzbsZSndmcufg6euP9brRQ1IOVCqMpGLUSE7M3ilHe6bm3cybJPCmMFmJUT2WN5Z0bqMS69Jy3ZAwrFUZbNzPW1DKhnESfVQ7ZPzaRWVOGdwtG9aO36KShRqUxWRF1rHdQUoV5MVo/ZNXok2nIJNFi4pZjbGkkYbQQo8L1qm45N9Ghi6vvL9kvz9o1jLZiVNQr+ZNnOooJnjrkuOFtaWlYYTQxnuDoJBuvGZeQgSIuf3aKXMPaUz2Gl0EPvX6jfwvdWenzptyY1bekEvNiVHPTjWmzbqOIsXyDuEcyvwOjrRgNDIvTrr+N/hy8781mLVn9YjRRRHB0HCau2xxzB3WbkBCouUjmg2P0mojg9LasOncjE+UYVJx0GqfEFiQGizD4rnju3LsogEqaPaJRibV5DCvOtySWX7PtHvIZPNNhQjDbz0sqMGsCzZo9b9ZT3n108s/T0zabsn6jBKMpGC35yWJD9n10WdtpTsZUtv6SMFqIUc362x8DHqDc0TtvBVc3SO2AK0ZbMSrKTx53/iEyTe71bhTFdkArhncrTltGqTtmIW6zwFVf+6a0DvQwem0rwen9/PWZliykteW6Z6/B96QZA0OLkyZfWNI/8RHivlS9V32/H1vI5ZgWo7PtXC2CslHCtJrez/a9Z40pRhO34cbs5jUmIxtVVPJ7x/Vh3UYhRlMwWo6bXA7qX3/UXX0w24lcMVqI0fen7zv75qDVvY++e7hH5qAxvBj1nuueSOagK6mTp9f8Lhu0GN7tBEfnqrqfdc9cVHlt0rUXG1i3oqQM82JUVLyi/kYualZw+OXDPtY5kGC0EKOueX829MxDV/mD85a9YiswCaOtGNW8sdTLNw9lhjckP/TXYjXCaOIOuqy4xuEzbuYh51TFy04/9WG7J8OL0fKCIRd189H+ElG12evurEYML0Yzg25uDspHYY+9lLP0DVlTxvAyOescKLmbj448VekXo8c6WcDw7sTmyELp7A8FaM4dj9WBN9hJbAneF5iC0exMx3fLC1Cd1fzamjOscyDBaOFOgnOim+ucl6kFBajY80j3URwVJuu1tgAqAMABAFUAUAMAdQDQwBvoAEALALQBoAcA9ASAXgDQGwB02P1D+CO2BegDALp4kxtFUfgfvtYXAPoBwMWpAJlT2U12dgD98bOI7fgGAsCgDnx6LN9glu8HvE/JMdTYxcXIUrrv3ycgxMZ9mqMLj+fu7Rbsgvc0h4bYuFvjHUnSvUh9bAE+2X1NxzP9+sIATze/hWGL/iY5s6fJwbYtrTFLKk3cdcqhywA22Up1xU88TLQFkG+mqO9l8PH36lKGaY4ull9fLPCNTvm20jpjhxp4YAcwBACG4r1yFEXhf/jaMAAYjjc32gF42wGssAOYaNeWrn2dydK1rzOZvJZtevv4e/2d9l3LvNZOysdsSbUD0AeAEW0cFrLXhliz5V5uBwLRPoKTp5ATegBm7U8dJQycoUFR4/VxS/UAgHJ5AE19gKT1BFj9rAHCnbsB/mzphjUypf3SIADwpSgq6yNFbSUpSrbDkvqffoCQk1fopqjUXZm9oMJRVVPX0NTS7tGzV2+dPrp9+/UfMHCQ3uAfhvw7/P/xBwg5BSV5xW5secgB4N1yEgUASTcAiSKARAlA0h1AogwgUQGQcAAkqgASNQCJOoBEA0CiCSDRApBoA0h6AEh6Akh6AUh6A0h0ACR9ACS6AJK+AJJ+AJL+AJIBAJKBAJJBAHgj7wUCIF0OIF0eIF0BIL0bQLoiQLoSQHp3gHRlgHQVgHQOQLoqQLoaQJ46QLoGQDqA6nUCVNPlQDVdHlTTFUD1GdbnhbbCjo71bOUgtSSyHfUC0SGCI+fkAILkQwRnsu0ElwlOcxyYTm87wWXar3bWM2wmMOdONnbMZXw+wd7WVuBkzZzb2U+zdhLMmMOcWzs6CiZbO4JA+BvBEeiCCujq4k4FbBnjDZaMdWU+uqCloqurK6+iBAQoc/oAKCtyMK6I0+CUgpzfCM5g9bYEKmr4shquLGV1JkN1bKIFcYcJDqEKgl2HCU4vbJ4ZGw3Kqkw6VfwnuIXjaIIgB8fBJl1Bg4mjKd0gjf8EFI6jDYK4IwRnIDa/jA0GZW0mjjbzh61C3759QXDzCMFRl4VY/QRNRwgO0RME1BGC0wsPDMzoAMo9mQg98Z/gzFGCQ/QGQcpRgjMSDyLMSALKvZk4vZm/ttcfCH6eMNF6Ur0jCOqPERyKkIOOB34dOXvAPx+Eq4Lk747uT78/OsQoaHfc+nfHN+kftztu/7tDllYOBA2nCA4xGwRrkwlOq7xsw7Vso2s3dqNr+029/9tBXTYoyAYC2WAtG6T12EEZD8iygUc22MgM+0gAGAUAowHwD/fh35KFsQBgiAckAOABgBFtA4zxbnvWZOMdCuZ4SwLeMQ+Afwke/zwCM2BhRwbvdMBr73jnggAAfsZdGg+wAIB76SQAmEwPOFMAwAYAfgEA7HPgcccODzZ4szneYA4A0wFgBgA4AoATAPwKADMBYBYAzMavKgCAuQAwDwCcAWA+bVoWAIALdvL+L/IvpwfMFQCwEgBW0WYtCgTCqwRHTnMBCLaL/39LAHADgIUA4M46Bp4AsIj2l71oJ8Gbntv40BO2xdgZwNve6am5HwD4A0AAAASyjkIwAIQAQCgAhAHAUgAIp13ZCACIBIBlf9MS/m/xd9ISRBkEJ41os5luC909PBdJLWfE7NFjAh18bPynMTUCMCyQ+b/tFWzMW2nYCvNjK2QYq4TsPJL9nsNWnCzumHZxh7HN/Uf23K7duSPbSIaxygJ7PuWb+IKSWwSnUP574NuM8MfD61sbgD8ZXm19UfAv+iP+GHi19UvBP/RNxmn1auujgi7sBDOJ825rJYIuWkooW+NhbGsBtsW4sS0kpN31f6qczgv0+3IbxuYvq4yF7c492p1P+RcVOaddnv+u4gUZdwnOTuVqj7ZuImjz/s3wjGGJp+kiN3fP0K+zHA8AboSUaImnNJ0nm+5/2r1YHlP30MhAT5tw/DYLdm7DZS7Jph545jHNUzqD43t+9Y8By42/PTyl37Iac2crUvAP3ZdlM3cP8PB0Xxpq4+7O47m4+C1kXsvlEtpOHiM2ytfJECPTC1YmcScyvW8nUygr0zJWpu9NBoCQnpWu7kSmiSHfCcVwOiz6e85yljOa5VyDVxToYWgdPQytp4ehDfQwtJEehmI64/TpnDPjbzg75hH+fRZMHt29/jEPWbtzcfHxC5S1O1svafw2niX4bXp4NsvggV3g4Swu+hZn25z7V7mSvbpuV7LZsH+YXyB+pxWbjMn39bf5tsUJb4vT3Vsah1nV8QKIpYf9OLZeNtFD/2Z66N/C1tsRL4B42gUQsXgC7QZspd2AbSxu5SOt1+0sjidVO2m3YBftFuym3YJE/M4n2i3YS7sF+2i3YD/tFhyg3YKD7erIP8zPxcszVLpYYOnzddXFxSfUM1i6RtD5Ikpbj7B0cfmaS7t+YvL1cvu+q+gjLeN677bVFz0f6Tm+ftr7+7If4QOC17kE5x7Rc7FU4yRW40O0Y/Mb7dgcxqVFm7KjtGPzO+3YHKNTHacdmxO0Y3OSdmxOdaJxeJcah3+ncXiXGod/bTWvfTrXKMnne40++YDgaj7BeUF8YjU6zWp0hna9ztIDyDna9UqmXa/ztOv1B56I4xW6DloEhsnqLeA/1BuTy/f1Fhj2Tb3dXMzWz+I2LYsXt2npvfh7LV8vBkHSY4Jzg8jwlWp5idXyMu08XsEvbKOdxxR6SLpGO4/X8XoX7TymdqJleJda/tu6YnL5WlfbfTvXwsH3ey1O+4Kg/AnB2cPJWAJwg3ZrSVYLvECSRk8ybgKz2AEZtFNzi3ZqbrMrrDj+Hdzv6UH4Lu3c3KOdm/t4NZAeiB+2syX4LZ7/uRMymUgrDNfXyiVf8zfiurjIKFzwomZAsJuXzN7huLuXSLW3WCLVXr6d9qIl0m/xkral5GQ/gCzaGXvElkM27ZDl0A5ZLu1U5NEOWT49WSqgHbHHbDng+E9oZ+wp7ZgU0s5YEe2M4YWgYtoJe95ZOfyHrtmFskzVY13X+Ul1tfLrWtfjfm26OvkDvKAdxJesriUd5f2PnZAnkzcwLFRWH6b+rI30+7412vq3yZbvD/An7Si+YmX7qzPZ/jddh+0Nm/z/nt87QNqrX7P8b2iXqxTfBsE+B75lhe/D0X5fFU6P77i2W7Hm+gX4e0ayQ6jtQu43RcJg3/pXUwKkMhkEfC+Ta0Cbr1PMylTLylSH77DjZyDwwyj4uR/8FBV+6gw/h0f7gO+6lomHZcKckn/gdAiUcr5nOVtp/+4D7dt9xJae9u0+077dF7zeyZocguicM5wtB8xpEvj3nBkspxwh5cRrDAoEQDcCQJEAUCIAuhMAygSACgHA6Zrzq57H/4HTO0jKqcpyqhEA6m35Wkqr7T8aMsZVbMtI1m8nBUnrn5ksdJQxCASb/iI4ewjVYKmEGqyEmgSAVqcS/gcT862EXy1LJSvhkU4kVAgGQfJrLGEyK6E2K2EPAqDndxL+V6PyVULZ4M5IuCVYKuGU4O8lPB4Mgvw3WEKnEKmEvVgJexMAOp1K+B9G5W8l/FqGRiFSCas7kdA2BATvSwlOSvcHrIR9WAl1CYC+BEC/Nikt/DxDQty8PEO+cW2MZVe/tS0nWNbtId+zZoS0tf+hoVLe/izvAAJgIAEwqDPe8DY7qhradb6O7HzUn51zu7VbNLBj58idYU7tFidCOsFnsZgHm76reE7sHD2s3RJXxziTWMynE8yRDYe2y6OzODIdO+rVUZeOsneUsaM8HWUAdhHJjc0/jD0P7qCPJ7vAEtxFHLt219xZfmDte2A7/iUd4ke2kyGsXdm3v7akXTwBe82L/Q5pp4cjmzaQvebJrp0sZM/ZTsIsirmzcQI6waex15f+TR4T2bD738RpX64dy7FjmXUsq45l0rE8OpZFR/076tlRr446yPKzk43R0lVMcR3BWSb+B78cWB/w73xW5pXEEQB6BMBgAuCHduOriYtLiLdbsKeHi3tAmH/oVzvTMwLwT0pzMgkul8vjGnGNuSZcU64Z15xrwbXkcXk8nhHPmGfCM+WZ8cx5FjxLI64Rz8jIyNjIxMjUyMzI3MjCyNKYa8wzNjI2NjYxNjU2MzY3tjC2NOGa8EyMTIxNTExMTcxMzE0sTCxNuaY8UyNTY1MTU1NTM1NzUwtTSzOuGc/MyMzYzMTM1MzMzNzMwszSnGvOMzcyNzY3MTc1NzM3N7cwt7TgWvAsjCyMLUwsTC3MLMwtLCwsLbmWPEsjS2NLE0tTSzNLc0sLS0sQbG8kOI0K/3THH+7t+WkadnXdIyLcFvos5fHMcBn5+Lkwa3s+/osCvq6QWNBdQ7gc4Nv45i4u7kvwLwZ8kwDH944EcGa706ZIgCEEwFACYBgBMJwA0CcARhAAIwmAUQT70ull0nijO8QzIADGEABjiQ78eFoR4tOZCIwM5ZFSbmYllM3bsEPeXAKARwAYfZc3z8VlqZ9PV/pNXNaWd+Yy6c0jYwLAhNUlmb1mSgCYEQCOoZZtv8vCtrykZcz1tvf0s3lfXSZNz7z4epn05pQ5AWDB5MPjLQnw8nFnf4OG0bNdfO5yaXzLtvhmPv5L3Zb4eLi4BXuFMT+BJHvGZ7k0f+b2AJvux7Z0RtIX5bNEbBoHNo1jqOXXMpHpE7gcBBvf4Udlt2n+H81ODNeaMAcA";async function Je(c){let X=Uint8Array.from(atob(c),Z=>Z.charCodeAt(0)),n=new Blob([X]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(n).arrayBuffer())}var b=20,Bt=200,T,D,R,I,H,ye;function Ke(){let c=T._live_values()/8;return T.HEAPF64.slice(c,c+D.length)}function Qe(c){T._live_start(c);let X=T.ccall("live_layout","string").trim().split(\`
\`).map(n=>n.split(" "));D={names:{},length:0};for(let[n,Z,z]of X)D.names[n]=[+Z,+z],D.length=+Z+ +z;R=H=0,ye=performance.now(),I=!1,postMessage({fields:D.names,seed:c}),postMessage({frames:[Ke()],ticks:R})}function At(){let c=performance.now();if(H=Math.min(H+c-ye,Bt),ye=c,I)return;let X=[];for(;H>=b;H-=b)T._live_step(b),R+=b,X.push(Ke());X.length>0&&postMessage({frames:X,ticks:R,busy:(performance.now()-c)/(X.length*b)})}onmessage=({data:c})=>{if(c.start!==void 0&&Qe(c.start),c.paused!==void 0&&(I=c.paused,H=0,I&&postMessage({paused:I})),c.command){let X=T.ccall("live_command","number",["string"],[c.command])!==0;postMessage({command:c.command,accepted:X,at:R})}};Je(Ye).then(c=>Le({wasmBinary:c})).then(c=>{T=c,Qe(1),setInterval(At,b/2)});})();
`;var so={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Ji=.2;function ro(i,t){let e=i===Ji?0:.02;return`attach ${i} ${e} ${e/2} ${(.1+.07*t).toFixed(2)}`}function Xl(i){let{act:t,view:e}=i,n=[...document.querySelectorAll("#controls button")],s=l=>t(ro(l,i.held().length)),r=0,a={attach:l=>s(+l.dataset.attach),cup:()=>s(Ji),hang:()=>t(`hang 1 ${.25}`),command:l=>t(l.dataset.command),pose:()=>t(`pose ${r=(r+1)%4}`),restart:()=>{r=0;for(let l of n)l.dataset.toggle&&l.setAttribute("aria-pressed",!1);i.restart()},toggle:l=>{let h=l.getAttribute("aria-pressed")!=="true";l.setAttribute("aria-pressed",h),t(`${l.dataset.toggle} ${h?1:0}`)}},o={pour:l=>{l&&!i.held().some(({kind:h})=>h==="cup")&&s(Ji),t(`pour ${l?.3:0}`)},push:l=>t(`push 0 ${l?15:0} 0`)};for(let l of n){if(fu(l),l.dataset.hold){pu(l,o[l.dataset.hold]);continue}let h=Object.keys(a).find(f=>f in l.dataset);l.addEventListener("click",()=>{a[h](l),l.dataset.say&&l.getAttribute("aria-pressed")!=="false"&&i.say(l.dataset.say)}),l.closest(".weights")&&mu(l,i.say)}if(gu(n),!e)return;let c=l=>t(`push ${l.toArray().map(h=>h.toFixed(3)).join(" ")}`);xu((l,h)=>c(e.inArms(l,h).setLength(l||h?15:0))),vu(e,(l,h)=>{c(e.inArms(l,h).multiplyScalar(100).clampLength(0,i.get("constrained")[0]?15:40))})}function fu(i){let t=i.dataset.key,e=i.lastChild,n=e.data.toLowerCase().indexOf(t),s=document.createElement("u"),r=document.createElement("span");i.setAttribute("aria-keyshortcuts",t),s.textContent=n<0?t.toUpperCase():e.data[n],r.append(...n<0?[e.data," ",s]:[e.data.slice(0,n),s,e.data.slice(n+1)]),e.replaceWith(r)}function pu(i,t){let e=n=>{i.classList.contains("held")!==n&&(i.classList.toggle("held",n),t(n))};for(let n of["pointerdown","hold"])i.addEventListener(n,()=>e(!0));for(let n of["pointerup","pointerleave","pointercancel","blur","keyup","release"])i.addEventListener(n,()=>e(!1));i.addEventListener("keydown",({key:n})=>{(n===" "||n==="Enter")&&e(!0)})}function mu(i,t){i.addEventListener("pointerdown",e=>{let n=document.createElement("div");n.className="dragged",n.append(i.querySelector("i").cloneNode());let s=({clientX:o,clientY:c})=>{!n.isConnected&&Math.hypot(o-e.clientX,c-e.clientY)<6||(document.body.append(n),n.style.left=`${o}px`,n.style.top=`${c}px`)},r=({type:o,clientX:c,clientY:l})=>{for(let[h,f]of a)removeEventListener(h,f);n.isConnected&&(n.remove(),o!=="pointercancel"&&(document.elementFromPoint(c,l)?.closest("#stage")?i.click():t("Let it go over one of the hands.")))},a=[["pointermove",s],["pointerup",r],["pointercancel",r]];for(let[o,c]of a)addEventListener(o,c)})}function gu(i){let t=new Map(i.map(e=>[e.dataset.key,e]));addEventListener("keydown",({altKey:e,ctrlKey:n,key:s,metaKey:r,repeat:a,target:o})=>{if(a||e||n||r||o.closest("input, select, pre"))return;let c=t.get(s.toLowerCase());c?.dataset.hold?c.dispatchEvent(new Event("hold")):c?.click()}),addEventListener("keyup",({key:e})=>t.get(e.toLowerCase())?.dispatchEvent(new Event("release")))}function xu(i){let t=document.getElementById("scene"),e=new Set,n=()=>i(...[...e].reduce(([s,r],a)=>[s+so[a][0],r+so[a][1]],[0,0]));t.addEventListener("keydown",s=>{s.key in so&&(s.preventDefault(),!s.repeat&&(e.add(s.key),n()))}),t.addEventListener("keyup",({key:s})=>e.delete(s)&&n()),t.addEventListener("blur",()=>{e.size!==0&&(e.clear(),n())})}function vu(i,t){let e=document.getElementById("scene");e.addEventListener("pointerdown",n=>{let{left:s,top:r}=e.getBoundingClientRect(),a=["without","with"].some(l=>{let{x:h,y:f}=i.handAt(l);return Math.hypot(n.clientX-s-h,n.clientY-r-f)<90}),o=n,c=l=>{a?t(l.clientX-n.clientX,l.clientY-n.clientY):i.turn(l.clientX-o.clientX,l.clientY-o.clientY),o=l};e.setPointerCapture(n.pointerId),e.addEventListener("pointermove",c),e.addEventListener("lostpointercapture",()=>{e.removeEventListener("pointermove",c),a&&t(0,0)},{once:!0})})}var Hs=class{constructor(){this.clear()}clear(){this.rows=[]}add(t){this.rows.push({t:t("ticks")[0]/1e3,mean:t("with.mean")[0],deviation:t("with.deviation")[0],truth:t("with.payload")[0]}),this.rows.length>12/.02&&this.rows.shift()}},yu=(()=>{let i=document.createElement("canvas");i.width=i.height=6;let t=i.getContext("2d");t.strokeStyle="#1565c0";for(let e of[-6,0,6])t.moveTo(e,6),t.lineTo(e+6,0);return t.stroke(),t.createPattern(i,"repeat")})();function ao(i,t,e,n){let s=devicePixelRatio,r=i.clientWidth,a=i.clientHeight;i.width!==Math.round(r*s)&&(i.width=Math.round(r*s),i.height=Math.round(a*s));let o=i.getContext("2d");o.setTransform(s,0,0,s,0,0),o.clearRect(0,0,r,a);let c=t.reduce((u,M)=>Math.max(u,M.mean+M.deviation,M.truth??0),.5),l=c>10?5:c>4?2:c>2?1:.5,h=l*Math.ceil(1.05*c/l),f=u=>30+(r-34)*(u-e)/(n-e),d=u=>a-16-(a-22)*Math.max(u,0)/h;o.font="11px system-ui, sans-serif",o.fillStyle="#5b6472",o.strokeStyle="#dde2e8";for(let u=0;u<=h+1e-9;u+=l)o.strokeRect(30,d(u),r-34,0),o.fillText(u.toFixed(l<1?1:0),4,d(u)+4);let m=Math.max(1,Math.round((n-e)/6));for(let u=m*Math.ceil(e/m);u<=n;u+=m)o.fillText(`${u} s`,Math.min(f(u)-8,r-26),a-3);let g=(u,M)=>{o.setLineDash(M),o.beginPath();for(let[A,w]of u)o.lineTo(f(A),d(w))},S=t.map(u=>[u.t,u.mean+2*u.deviation]),p=t.map(u=>[u.t,u.mean-2*u.deviation]);o.save(),o.beginPath(),o.rect(30,0,r-34,a-16),o.clip(),g([...S,...p.reverse()],[]),o.fillStyle=yu,o.fill(),o.strokeStyle="#1f2937",g(t.filter(u=>u.truth!==void 0).map(u=>[u.t,u.truth]),[5,4]),o.stroke(),o.lineWidth=2,o.strokeStyle="#1565c0",g(t.map(u=>[u.t,u.mean]),[]),o.stroke(),o.restore(),o.setLineDash([])}function ql(i,{rows:t}){let e=Math.max(12,t[t.length-1].t);ao(i,t,e-12,e)}var oe=i=>document.getElementById(i),kn=[],Yl,Su=0;function Mu(){return Yl??=new Promise((i,t)=>{let e=document.createElement("script");e.src="logs.js",e.onload=()=>i(new Worker(URL.createObjectURL(new Blob([globalThis.rmeLogWorker],{type:"text/javascript"})))),e.onerror=()=>t(new Error("logs.js is missing beside the page")),document.head.append(e)}),Yl}async function Jl(i,t){let e=await Mu(),n=++Su;return new Promise(s=>{let r=({data:a})=>{a.id===n&&(e.removeEventListener("message",r),s(a))};e.addEventListener("message",r),e.postMessage({id:n,files:kn,program:i,options:t})})}async function bu(i){let t=i.name.endsWith(".gz"),e=t?i.stream().pipeThrough(new DecompressionStream("gzip")):i.stream();return{name:t?i.name.slice(0,-3):i.name,bytes:new Uint8Array(await new Response(e).arrayBuffer())}}var si=({name:i})=>/\.(urdf|xml)$/i.test(i),Ws=()=>kn.filter(i=>!si(i)).map(({name:i})=>i);function wu(i){let t=new DOMParser().parseFromString(new TextDecoder().decode(i.bytes),"text/xml"),e=[...t.querySelectorAll("robot > link")].map(h=>h.getAttribute("name")),n=h=>new Set([...t.querySelectorAll(`robot > joint > ${h}`)].map(f=>f.getAttribute("link"))),s=n("parent"),r=n("child"),a=[...t.querySelectorAll("robot > joint")].find(h=>/revolute|continuous/.test(h.getAttribute("type"))),o=e.filter(h=>!s.has(h)),c=a?.querySelector("parent")?.getAttribute("link")??e.find(h=>!r.has(h)),l=o.find(h=>/^(tool0|.*flange|.*link8|.*ee|.*tip)$/i.test(h))??o.at(-1);for(let[h,f]of[["base",c],["tip",l]])oe(h).replaceChildren(...e.map(d=>new Option(d,d,!1,d===f)))}async function Zl(i){for(let e of i){let n=await bu(e);kn=kn.filter(s=>s.name!==n.name&&!(si(s)&&si(n))),kn.push(n)}let t=kn.find(si);oe("chosen").textContent=kn.map(({name:e})=>e).join(", "),oe("arm").hidden=!t,t&&[...i].some(si)&&wu(t),oe("replay").disabled=oe("check").disabled=Ws().length===0,Ws().length>0&&[...i].some(e=>!si(e))&&await Ql()}function Kl(){let i=kn.find(si),t=oe("options").value.trim();return[...i?["--urdf",i.name,"--base",oe("base").value,"--tip",oe("tip").value]:[],...t?t.split(/\s+/):[]]}function oo(i,t){oe("verdict").textContent=i,oe("output").hidden=!1,oe("output").textContent=t.join(`
`)}async function jl(i,t){oe("verdict").textContent=i;for(let e of["replay","check"])oe(e).disabled=!0;await t();for(let e of["replay","check"])oe(e).disabled=!1}var Ql=()=>jl("replaying ...",async()=>{let i=Ws().at(-1),{code:t,output:e}=await Jl("replay_log",[i,"--json",...Kl()]);if(t!==0){oe("replayed").hidden=!0,oo(`${i} could not be replayed`,e);return}let n=e.filter(o=>o.startsWith("{")).map(o=>JSON.parse(o)),s=n.filter(({type:o})=>o==="estimate"),r=n.filter(({type:o,final:c})=>c||o==="rejected"),a=n.find(({type:o})=>o==="summary");oe("replayed").hidden=!1,oe("replayed").rows=s.map(({t:o,mass:c,std:l,truth:h})=>({t:o,mean:c,deviation:l[0],truth:h?.[0]})),$l(),oo(`${i}: ${a.samples} samples, ${a.estimates} changes of the payload, ${a.rejected} pushes`,[...n.filter(({type:o})=>o==="note").map(({text:o})=>o),...r.map(({t:o,kind:c,mass:l,std:h})=>`${o.toFixed(3)} s  ${c}`+(l===void 0?"":`  ${l.toFixed(3)} +- ${h[0].toFixed(3)} kg`))])});function $l(){let{rows:i}=oe("replayed");i?.length>1&&ao(oe("replayed"),i,i[0].t,i.at(-1).t)}var Tu=()=>jl("checking ...",async()=>{let{code:i,output:t}=await Jl("check_arm",[...Ws(),...Kl()]);oo(["The arm fits: sign, units and frames of its torque can be right.","Sign, units or frames of the torque do not fit the arm.","check_arm does not take these options.","check_arm cannot use these files."][i],t)});function tc(){oe("files").addEventListener("change",({target:t})=>Zl(t.files)),oe("replay").addEventListener("click",Ql),oe("check").addEventListener("click",Tu),addEventListener("resize",$l);let i=t=>e=>{e.dataTransfer?.types.includes("Files")&&(e.preventDefault(),oe("own").classList.toggle("over",t),e.type==="drop"&&Zl(e.dataTransfer.files))};for(let[t,e]of[["dragover",!0],["dragleave",!1],["drop",!1]])addEventListener(t,i(e))}var Rc=0,zo=1,Pc=2;var As=1,Ic=2,Vi=3,Qn=0,De=1,xn=2,ui=0,Gi=1,ko=2,Vo=3,Go=4,_c=5;var di=100,Lc=101,Nc=102,Dc=103,Uc=104,Fc=200,Oc=201,Bc=202,zc=203,Ho=204,Wo=205,kc=206,Vc=207,Gc=208,Hc=209,Wc=210,Xc=211,qc=212,Yc=213,Zc=214,yr=0,Sr=1,Mr=2,_i=3,br=4,wr=5,Tr=6,Er=7,Qr=0,Jc=1,Kc=2,vn=0,Xo=1,qo=2,Yo=3,Zo=4,Jo=5,Ko=6,jo=7;var Qo=300,fi=301,Hi=302,$r=303,ta=304,Ar=1e3,fn=1001,Cr=1002,Me=1003,jc=1004;var Cs=1005;var Ne=1006,ea=1007;var Dn=1008;var Be=1009,$o=1010,tl=1011,Wi=1012,na=1013,an=1014,on=1015,ln=1016,ia=1017,sa=1018,pi=1020,el=35902,nl=35899,il=1021,sl=1022,cn=1023,Pn=1026,Un=1027,rl=1028,ra=1029,$n=1030,aa=1031;var oa=1033,Rs=33776,Ps=33777,Is=33778,_s=33779,la=35840,ca=35841,ha=35842,ua=35843,da=36196,fa=37492,pa=37496,ma=37488,ga=37489,Ls=37490,xa=37491,va=37808,ya=37809,Sa=37810,Ma=37811,ba=37812,wa=37813,Ta=37814,Ea=37815,Aa=37816,Ca=37817,Ra=37818,Pa=37819,Ia=37820,_a=37821,La=36492,Na=36494,Da=36495,Ua=36283,Fa=36284,Ns=36285,Oa=36286;var ns=2300,Rr=2301,gr=2302,Lo=2303,No=2400,Do=2401,Uo=2402;var Qc=3200;var Ba=0,$c=1,Fn="",Ve="srgb",is="srgb-linear",ss="linear",Yt="srgb";var xr=7680;var th=519,eh=512,nh=513,ih=514,al=515,sh=516,rh=517,ol=518,ll=519,ah=35044;var cl="300 es",je=2e3,Li=2001;function Eu(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Au(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function rs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function oh(){let i=rs("canvas");return i.style.display="block",i}var ec={},Ni=null;function hl(...i){let t="THREE."+i.shift();Ni?Ni("log",t,...i):console.log(t,...i)}function lh(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ct(...i){i=lh(i);let t="THREE."+i.shift();if(Ni)Ni("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Pt(...i){i=lh(i);let t="THREE."+i.shift();if(Ni)Ni("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function es(...i){let t=i.join(" ");t in ec||(ec[t]=!0,Ct(...i))}function ch(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var hh={[yr]:yr,[Mr]:Tr,[br]:br,[_i]:wr,[Sr]:Sr,[Tr]:Mr,[Er]:Er,[wr]:_i},mn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},Ce=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var vr=Math.PI/180,Pr=180/Math.PI;function Ds(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ce[i&255]+Ce[i>>8&255]+Ce[i>>16&255]+Ce[i>>24&255]+"-"+Ce[t&255]+Ce[t>>8&255]+"-"+Ce[t>>16&15|64]+Ce[t>>24&255]+"-"+Ce[e&63|128]+Ce[e>>8&255]+"-"+Ce[e>>16&255]+Ce[e>>24&255]+Ce[n&255]+Ce[n>>8&255]+Ce[n>>16&255]+Ce[n>>24&255]).toLowerCase()}function Wt(i,t,e){return Math.max(t,Math.min(e,i))}function Cu(i,t){return(i%t+t)%t}function lo(i,t,e){return(1-e)*i+e*t}function uh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ul(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ru(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Pu(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Ht=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qe=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let c=n[s+0],l=n[s+1],h=n[s+2],f=n[s+3],d=r[a+0],m=r[a+1],g=r[a+2],S=r[a+3];if(f!==S||c!==d||l!==m||h!==g){let p=c*d+l*m+h*g+f*S;p<0&&(d=-d,m=-m,g=-g,S=-S,p=-p);let u=1-o;if(p<.9995){let M=Math.acos(p),A=Math.sin(M);u=Math.sin(u*M)/A,o=Math.sin(o*M)/A,c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+S*o}else{c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+S*o;let M=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=M,l*=M,h*=M,f*=M}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,s,r,a){let o=n[s],c=n[s+1],l=n[s+2],h=n[s+3],f=r[a],d=r[a+1],m=r[a+2],g=r[a+3];return t[e]=o*g+h*f+c*m-l*d,t[e+1]=c*g+h*d+l*f-o*m,t[e+2]=l*g+h*m+o*d-c*f,t[e+3]=h*g-o*f-c*d-l*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,c=Math.sin,l=o(n/2),h=o(s/2),f=o(r/2),d=c(n/2),m=c(s/2),g=c(r/2);switch(a){case"XYZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"YXZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"ZXY":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"ZYX":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"YZX":this._x=d*h*f+l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f-d*m*g;break;case"XZY":this._x=d*h*f-l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f+d*m*g;break;default:Ct("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],c=e[9],l=e[2],h=e[6],f=e[10],d=n+o+f;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-c)*m,this._y=(r-l)*m,this._z=(a-s)*m}else if(n>o&&n>f){let m=2*Math.sqrt(1+n-o-f);this._w=(h-c)/m,this._x=.25*m,this._y=(s+a)/m,this._z=(r+l)/m}else if(o>f){let m=2*Math.sqrt(1+o-n-f);this._w=(r-l)/m,this._x=(s+a)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+f-n-o);this._w=(a-s)/m,this._x=(r+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+a*o+s*l-r*c,this._y=s*h+a*c+r*o-n*l,this._z=r*h+a*l+n*c-s*o,this._w=a*h-n*o-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let c=1-e;if(o<.9995){let l=Math.acos(o),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(nc.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(nc.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,c=t.w,l=2*(a*s-o*n),h=2*(o*e-r*s),f=2*(r*n-a*e);return this.x=e+c*l+a*f-o*h,this.y=n+c*h+o*l-r*f,this.z=s+c*f+r*h-a*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,c=e.z;return this.x=s*c-r*o,this.y=r*a-n*c,this.z=n*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return co.copy(this).projectOnVector(t),this.sub(co)}reflect(t){return this.sub(co.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},co=new U,nc=new Qe,It=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l)}set(t,e,n,s,r,a,o,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=a,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],c=n[6],l=n[1],h=n[4],f=n[7],d=n[2],m=n[5],g=n[8],S=s[0],p=s[3],u=s[6],M=s[1],A=s[4],w=s[7],C=s[2],E=s[5],x=s[8];return r[0]=a*S+o*M+c*C,r[3]=a*p+o*A+c*E,r[6]=a*u+o*w+c*x,r[1]=l*S+h*M+f*C,r[4]=l*p+h*A+f*E,r[7]=l*u+h*w+f*x,r[2]=d*S+m*M+g*C,r[5]=d*p+m*A+g*E,r[8]=d*u+m*w+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8];return e*a*h-e*o*l-n*r*h+n*o*c+s*r*l-s*a*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=h*a-o*l,d=o*c-h*r,m=l*r-a*c,g=e*f+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let S=1/g;return t[0]=f*S,t[1]=(s*l-h*n)*S,t[2]=(o*n-s*a)*S,t[3]=d*S,t[4]=(h*e-s*c)*S,t[5]=(s*r-o*e)*S,t[6]=m*S,t[7]=(n*c-l*e)*S,t[8]=(a*e-n*r)*S,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*a+l*o)+a+t,-s*l,s*c,-s*(-l*a+c*o)+o+e,0,0,1),this}scale(t,e){return es("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ho.makeScale(t,e)),this}rotate(t){return es("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ho.makeRotation(-t)),this}translate(t,e){return es("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ho.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ho=new It,ic=new It().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sc=new It().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Iu(){let i={enabled:!0,workingColorSpace:is,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Yt&&(s.r=Rn(s.r),s.g=Rn(s.g),s.b=Rn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Yt&&(s.r=Ii(s.r),s.g=Ii(s.g),s.b=Ii(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fn?ss:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[is]:{primaries:t,whitePoint:n,transfer:ss,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ve},outputColorSpaceConfig:{drawingBufferColorSpace:Ve}},[Ve]:{primaries:t,whitePoint:n,transfer:Yt,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ve}}}),i}var Gt=Iu();function Rn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Ii(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xi,Ir=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{xi===void 0&&(xi=rs("canvas")),xi.width=t.width,xi.height=t.height;let s=xi.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=xi}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=rs("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Rn(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Rn(e[n]/255)*255):e[n]=Rn(e[n]);return{data:e,width:t.width,height:t.height}}else return Ct("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},_u=0,Di=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:_u++}),this.uuid=Ds(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(uo(s[a].image)):r.push(uo(s[a]))}else r=uo(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function uo(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Ir.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ct("Texture: Unable to serialize Texture."),{})}var Lu=0,fo=new U,Oe=class i extends mn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=fn,s=fn,r=Ne,a=Dn,o=cn,c=Be,l=i.DEFAULT_ANISOTROPY,h=Fn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Lu++}),this.uuid=Ds(),this.name="",this.source=new Di(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new Ht(0,0),this.repeat=new Ht(1,1),this.center=new Ht(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new It,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fo).x}get height(){return this.source.getSize(fo).y}get depth(){return this.source.getSize(fo).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Ct(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ct(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Qo)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ar:t.x=t.x-Math.floor(t.x);break;case fn:t.x=t.x<0?0:1;break;case Cr:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ar:t.y=t.y-Math.floor(t.y);break;case fn:t.y=t.y<0?0:1;break;case Cr:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Oe.DEFAULT_IMAGE=null;Oe.DEFAULT_MAPPING=Qo;Oe.DEFAULT_ANISOTROPY=1;var se=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],f=c[8],d=c[1],m=c[5],g=c[9],S=c[2],p=c[6],u=c[10];if(Math.abs(h-d)<.01&&Math.abs(f-S)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+S)<.1&&Math.abs(g+p)<.1&&Math.abs(l+m+u-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(l+1)/2,w=(m+1)/2,C=(u+1)/2,E=(h+d)/4,x=(f+S)/4,b=(g+p)/4;return A>w&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):w>C?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=E/s,r=b/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=b/r),this.set(n,s,r,e),this}let M=Math.sqrt((p-g)*(p-g)+(f-S)*(f-S)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(p-g)/M,this.y=(f-S)/M,this.z=(d-h)/M,this.w=Math.acos((l+m+u-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},_r=class extends mn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ne,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new se(0,0,t,e),this.scissorTest=!1,this.viewport=new se(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Oe({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ne,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Di(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},He=class extends _r{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},as=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Me,this.minFilter=Me,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Lr=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Me,this.minFilter=Me,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p)}set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,S,p){let u=this.elements;return u[0]=t,u[4]=e,u[8]=n,u[12]=s,u[1]=r,u[5]=a,u[9]=o,u[13]=c,u[2]=l,u[6]=h,u[10]=f,u[14]=d,u[3]=m,u[7]=g,u[11]=S,u[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/vi.setFromMatrixColumn(t,0).length(),r=1/vi.setFromMatrixColumn(t,1).length(),a=1/vi.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let d=a*h,m=a*f,g=o*h,S=o*f;e[0]=c*h,e[4]=-c*f,e[8]=l,e[1]=m+g*l,e[5]=d-S*l,e[9]=-o*c,e[2]=S-d*l,e[6]=g+m*l,e[10]=a*c}else if(t.order==="YXZ"){let d=c*h,m=c*f,g=l*h,S=l*f;e[0]=d+S*o,e[4]=g*o-m,e[8]=a*l,e[1]=a*f,e[5]=a*h,e[9]=-o,e[2]=m*o-g,e[6]=S+d*o,e[10]=a*c}else if(t.order==="ZXY"){let d=c*h,m=c*f,g=l*h,S=l*f;e[0]=d-S*o,e[4]=-a*f,e[8]=g+m*o,e[1]=m+g*o,e[5]=a*h,e[9]=S-d*o,e[2]=-a*l,e[6]=o,e[10]=a*c}else if(t.order==="ZYX"){let d=a*h,m=a*f,g=o*h,S=o*f;e[0]=c*h,e[4]=g*l-m,e[8]=d*l+S,e[1]=c*f,e[5]=S*l+d,e[9]=m*l-g,e[2]=-l,e[6]=o*c,e[10]=a*c}else if(t.order==="YZX"){let d=a*c,m=a*l,g=o*c,S=o*l;e[0]=c*h,e[4]=S-d*f,e[8]=g*f+m,e[1]=f,e[5]=a*h,e[9]=-o*h,e[2]=-l*h,e[6]=m*f+g,e[10]=d-S*f}else if(t.order==="XZY"){let d=a*c,m=a*l,g=o*c,S=o*l;e[0]=c*h,e[4]=-f,e[8]=l*h,e[1]=d*f+S,e[5]=a*h,e[9]=m*f-g,e[2]=g*f-m,e[6]=o*h,e[10]=S*f+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Nu,t,Du)}lookAt(t,e,n){let s=this.elements;return ze.subVectors(t,e),ze.lengthSq()===0&&(ze.z=1),ze.normalize(),Vn.crossVectors(n,ze),Vn.lengthSq()===0&&(Math.abs(n.z)===1?ze.x+=1e-4:ze.z+=1e-4,ze.normalize(),Vn.crossVectors(n,ze)),Vn.normalize(),Xs.crossVectors(ze,Vn),s[0]=Vn.x,s[4]=Xs.x,s[8]=ze.x,s[1]=Vn.y,s[5]=Xs.y,s[9]=ze.y,s[2]=Vn.z,s[6]=Xs.z,s[10]=ze.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],c=n[8],l=n[12],h=n[1],f=n[5],d=n[9],m=n[13],g=n[2],S=n[6],p=n[10],u=n[14],M=n[3],A=n[7],w=n[11],C=n[15],E=s[0],x=s[4],b=s[8],D=s[12],_=s[1],N=s[5],B=s[9],H=s[13],P=s[2],G=s[6],q=s[10],V=s[14],et=s[3],X=s[7],Q=s[11],$=s[15];return r[0]=a*E+o*_+c*P+l*et,r[4]=a*x+o*N+c*G+l*X,r[8]=a*b+o*B+c*q+l*Q,r[12]=a*D+o*H+c*V+l*$,r[1]=h*E+f*_+d*P+m*et,r[5]=h*x+f*N+d*G+m*X,r[9]=h*b+f*B+d*q+m*Q,r[13]=h*D+f*H+d*V+m*$,r[2]=g*E+S*_+p*P+u*et,r[6]=g*x+S*N+p*G+u*X,r[10]=g*b+S*B+p*q+u*Q,r[14]=g*D+S*H+p*V+u*$,r[3]=M*E+A*_+w*P+C*et,r[7]=M*x+A*N+w*G+C*X,r[11]=M*b+A*B+w*q+C*Q,r[15]=M*D+A*H+w*V+C*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],c=t[9],l=t[13],h=t[2],f=t[6],d=t[10],m=t[14],g=t[3],S=t[7],p=t[11],u=t[15],M=c*m-l*d,A=o*m-l*f,w=o*d-c*f,C=a*m-l*h,E=a*d-c*h,x=a*f-o*h;return e*(S*M-p*A+u*w)-n*(g*M-p*C+u*E)+s*(g*A-S*C+u*x)-r*(g*w-S*E+p*x)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],c=t[2],l=t[6],h=t[10];return e*(a*h-o*l)-n*(r*h-o*c)+s*(r*l-a*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=t[9],d=t[10],m=t[11],g=t[12],S=t[13],p=t[14],u=t[15],M=e*o-n*a,A=e*c-s*a,w=e*l-r*a,C=n*c-s*o,E=n*l-r*o,x=s*l-r*c,b=h*S-f*g,D=h*p-d*g,_=h*u-m*g,N=f*p-d*S,B=f*u-m*S,H=d*u-m*p,P=M*H-A*B+w*N+C*_-E*D+x*b;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/P;return t[0]=(o*H-c*B+l*N)*G,t[1]=(s*B-n*H-r*N)*G,t[2]=(S*x-p*E+u*C)*G,t[3]=(d*E-f*x-m*C)*G,t[4]=(c*_-a*H-l*D)*G,t[5]=(e*H-s*_+r*D)*G,t[6]=(p*w-g*x-u*A)*G,t[7]=(h*x-d*w+m*A)*G,t[8]=(a*B-o*_+l*b)*G,t[9]=(n*_-e*B-r*b)*G,t[10]=(g*E-S*w+u*M)*G,t[11]=(f*w-h*E-m*M)*G,t[12]=(o*D-a*N-c*b)*G,t[13]=(e*N-n*D+s*b)*G,t[14]=(S*A-g*C-p*M)*G,t[15]=(h*C-f*A+d*M)*G,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,c=t.z,l=r*a,h=r*o;return this.set(l*a+n,l*o-s*c,l*c+s*o,0,l*o+s*c,h*o+n,h*c-s*a,0,l*c-s*o,h*c+s*a,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,a=e._y,o=e._z,c=e._w,l=r+r,h=a+a,f=o+o,d=r*l,m=r*h,g=r*f,S=a*h,p=a*f,u=o*f,M=c*l,A=c*h,w=c*f,C=n.x,E=n.y,x=n.z;return s[0]=(1-(S+u))*C,s[1]=(m+w)*C,s[2]=(g-A)*C,s[3]=0,s[4]=(m-w)*E,s[5]=(1-(d+u))*E,s[6]=(p+M)*E,s[7]=0,s[8]=(g+A)*x,s[9]=(p-M)*x,s[10]=(1-(d+S))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=vi.set(s[0],s[1],s[2]).length(),o=vi.set(s[4],s[5],s[6]).length(),c=vi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),en.copy(this);let l=1/a,h=1/o,f=1/c;return en.elements[0]*=l,en.elements[1]*=l,en.elements[2]*=l,en.elements[4]*=h,en.elements[5]*=h,en.elements[6]*=h,en.elements[8]*=f,en.elements[9]*=f,en.elements[10]*=f,e.setFromRotationMatrix(en),n.x=a,n.y=o,n.z=c,this}makePerspective(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2*r/(e-t),f=2*r/(n-s),d=(e+t)/(e-t),m=(n+s)/(n-s),g,S;if(c)g=r/(a-r),S=a*r/(a-r);else if(o===je)g=-(a+r)/(a-r),S=-2*a*r/(a-r);else if(o===Li)g=-a/(a-r),S=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=S,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2/(e-t),f=2/(n-s),d=-(e+t)/(e-t),m=-(n+s)/(n-s),g,S;if(c)g=1/(a-r),S=a/(a-r);else if(o===je)g=-2/(a-r),S=-(a+r)/(a-r);else if(o===Li)g=-1/(a-r),S=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=g,l[14]=S,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},vi=new U,en=new Qt,Nu=new U(0,0,0),Du=new U(1,1,1),Vn=new U,Xs=new U,ze=new U,rc=new Qt,ac=new Qe,In=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],c=s[1],l=s[5],h=s[9],f=s[2],d=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-a,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Wt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-a,l));break;case"YZX":this._z=Math.asin(Wt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,m));break;case"XZY":this._z=Math.asin(-Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Ct("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rc.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rc,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ac.setFromEuler(this),this.setFromQuaternion(ac,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};In.DEFAULT_ORDER="XYZ";var os=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Uu=0,oc=new U,yi=new Qe,bn=new Qt,qs=new U,Ki=new U,Fu=new U,Ou=new Qe,lc=new U(1,0,0),cc=new U(0,1,0),hc=new U(0,0,1),uc={type:"added"},Bu={type:"removed"},Si={type:"childadded",child:null},po={type:"childremoved",child:null},Te=class i extends mn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Uu++}),this.uuid=Ds(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new U,e=new In,n=new Qe,s=new U(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new It}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new os,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.multiply(yi),this}rotateOnWorldAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.premultiply(yi),this}rotateX(t){return this.rotateOnAxis(lc,t)}rotateY(t){return this.rotateOnAxis(cc,t)}rotateZ(t){return this.rotateOnAxis(hc,t)}translateOnAxis(t,e){return oc.copy(t).applyQuaternion(this.quaternion),this.position.add(oc.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lc,t)}translateY(t){return this.translateOnAxis(cc,t)}translateZ(t){return this.translateOnAxis(hc,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(bn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?qs.copy(t):qs.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ki.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bn.lookAt(Ki,qs,this.up):bn.lookAt(qs,Ki,this.up),this.quaternion.setFromRotationMatrix(bn),s&&(bn.extractRotation(s.matrixWorld),yi.setFromRotationMatrix(bn),this.quaternion.premultiply(yi.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Pt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(uc),Si.child=t,this.dispatchEvent(Si),Si.child=null):Pt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Bu),po.child=t,this.dispatchEvent(po),po.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),bn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),bn.multiply(t.parent.matrixWorld)),t.applyMatrix4(bn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(uc),Si.child=t,this.dispatchEvent(Si),Si.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,t,Fu),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,Ou,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let c=o.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];r(t.shapes,f)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(r(t.materials,this.material[c]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let c=this.animations[o];s.animations.push(r(t.animations,c))}}if(e){let o=a(t.geometries),c=a(t.materials),l=a(t.textures),h=a(t.images),f=a(t.shapes),d=a(t.skeletons),m=a(t.animations),g=a(t.nodes);o.length>0&&(n.geometries=o),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let c=[];for(let l in o){let h=o[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Te.DEFAULT_UP=new U(0,1,0);Te.DEFAULT_MATRIX_AUTO_UPDATE=!0;Te.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ge=class extends Te{constructor(){super(),this.isGroup=!0,this.type="Group"}},zu={type:"move"},Ui=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ge,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ge,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ge,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null,o=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){a=!0;for(let S of t.hand.values()){let p=e.getJointPose(S,n),u=this._getHandJoint(l,S);p!==null&&(u.matrix.fromArray(p.transform.matrix),u.matrix.decompose(u.position,u.quaternion,u.scale),u.matrixWorldNeedsUpdate=!0,u.jointRadius=p.radius),u.visible=p!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],d=h.position.distanceTo(f.position),m=.02,g=.005;l.inputState.pinching&&d>m+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=m-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(zu)))}return o!==null&&(o.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ge;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},dh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Gn={h:0,s:0,l:0},Ys={h:0,s:0,l:0};function mo(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Ut=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ve){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Gt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Gt.workingColorSpace){return this.r=t,this.g=e,this.b=n,Gt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Gt.workingColorSpace){if(t=Cu(t,1),e=Wt(e,0,1),n=Wt(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=mo(a,r,t+1/3),this.g=mo(a,r,t),this.b=mo(a,r,t-1/3)}return Gt.colorSpaceToWorking(this,s),this}setStyle(t,e=Ve){function n(r){r!==void 0&&parseFloat(r)<1&&Ct("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Ct("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Ct("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ve){let n=dh[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Ct("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Rn(t.r),this.g=Rn(t.g),this.b=Rn(t.b),this}copyLinearToSRGB(t){return this.r=Ii(t.r),this.g=Ii(t.g),this.b=Ii(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ve){return Gt.workingToColorSpace(Re.copy(this),t),Math.round(Wt(Re.r*255,0,255))*65536+Math.round(Wt(Re.g*255,0,255))*256+Math.round(Wt(Re.b*255,0,255))}getHexString(t=Ve){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Gt.workingColorSpace){Gt.workingToColorSpace(Re.copy(this),e);let n=Re.r,s=Re.g,r=Re.b,a=Math.max(n,s,r),o=Math.min(n,s,r),c,l,h=(o+a)/2;if(o===a)c=0,l=0;else{let f=a-o;switch(l=h<=.5?f/(a+o):f/(2-a-o),a){case n:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-n)/f+2;break;case r:c=(n-s)/f+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=Gt.workingColorSpace){return Gt.workingToColorSpace(Re.copy(this),e),t.r=Re.r,t.g=Re.g,t.b=Re.b,t}getStyle(t=Ve){Gt.workingToColorSpace(Re.copy(this),t);let e=Re.r,n=Re.g,s=Re.b;return t!==Ve?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Gn),this.setHSL(Gn.h+t,Gn.s+e,Gn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Gn),t.getHSL(Ys);let n=lo(Gn.h,Ys.h,e),s=lo(Gn.s,Ys.s,e),r=lo(Gn.l,Ys.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Re=new Ut;Ut.NAMES=dh;var ls=class extends Te{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new In,this.environmentIntensity=1,this.environmentRotation=new In,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},nn=new U,wn=new U,go=new U,Tn=new U,Mi=new U,bi=new U,dc=new U,xo=new U,vo=new U,yo=new U,So=new se,Mo=new se,bo=new se,Cn=class i{constructor(t=new U,e=new U,n=new U){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),nn.subVectors(t,e),s.cross(nn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){nn.subVectors(s,e),wn.subVectors(n,e),go.subVectors(t,e);let a=nn.dot(nn),o=nn.dot(wn),c=nn.dot(go),l=wn.dot(wn),h=wn.dot(go),f=a*l-o*o;if(f===0)return r.set(0,0,0),null;let d=1/f,m=(l*c-o*h)*d,g=(a*h-o*c)*d;return r.set(1-m-g,g,m)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Tn)===null?!1:Tn.x>=0&&Tn.y>=0&&Tn.x+Tn.y<=1}static getInterpolation(t,e,n,s,r,a,o,c){return this.getBarycoord(t,e,n,s,Tn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,Tn.x),c.addScaledVector(a,Tn.y),c.addScaledVector(o,Tn.z),c)}static getInterpolatedAttribute(t,e,n,s,r,a){return So.setScalar(0),Mo.setScalar(0),bo.setScalar(0),So.fromBufferAttribute(t,e),Mo.fromBufferAttribute(t,n),bo.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(So,r.x),a.addScaledVector(Mo,r.y),a.addScaledVector(bo,r.z),a}static isFrontFacing(t,e,n,s){return nn.subVectors(n,e),wn.subVectors(t,e),nn.cross(wn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return nn.subVectors(this.c,this.b),wn.subVectors(this.a,this.b),nn.cross(wn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,a,o;Mi.subVectors(s,n),bi.subVectors(r,n),xo.subVectors(t,n);let c=Mi.dot(xo),l=bi.dot(xo);if(c<=0&&l<=0)return e.copy(n);vo.subVectors(t,s);let h=Mi.dot(vo),f=bi.dot(vo);if(h>=0&&f<=h)return e.copy(s);let d=c*f-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return a=c/(c-h),e.copy(n).addScaledVector(Mi,a);yo.subVectors(t,r);let m=Mi.dot(yo),g=bi.dot(yo);if(g>=0&&m<=g)return e.copy(r);let S=m*l-c*g;if(S<=0&&l>=0&&g<=0)return o=l/(l-g),e.copy(n).addScaledVector(bi,o);let p=h*g-m*f;if(p<=0&&f-h>=0&&m-g>=0)return dc.subVectors(r,s),o=(f-h)/(f-h+(m-g)),e.copy(s).addScaledVector(dc,o);let u=1/(p+S+d);return a=S*u,o=d*u,e.copy(n).addScaledVector(Mi,a).addScaledVector(bi,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qn=class{constructor(t=new U(1/0,1/0,1/0),e=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(sn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(sn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=sn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,sn):sn.fromBufferAttribute(r,a),sn.applyMatrix4(t.matrixWorld),this.expandByPoint(sn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Zs.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Zs.copy(n.boundingBox)),Zs.applyMatrix4(t.matrixWorld),this.union(Zs)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,sn),sn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ji),Js.subVectors(this.max,ji),wi.subVectors(t.a,ji),Ti.subVectors(t.b,ji),Ei.subVectors(t.c,ji),Hn.subVectors(Ti,wi),Wn.subVectors(Ei,Ti),ri.subVectors(wi,Ei);let e=[0,-Hn.z,Hn.y,0,-Wn.z,Wn.y,0,-ri.z,ri.y,Hn.z,0,-Hn.x,Wn.z,0,-Wn.x,ri.z,0,-ri.x,-Hn.y,Hn.x,0,-Wn.y,Wn.x,0,-ri.y,ri.x,0];return!wo(e,wi,Ti,Ei,Js)||(e=[1,0,0,0,1,0,0,0,1],!wo(e,wi,Ti,Ei,Js))?!1:(Ks.crossVectors(Hn,Wn),e=[Ks.x,Ks.y,Ks.z],wo(e,wi,Ti,Ei,Js))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,sn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(sn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(En[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),En[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),En[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),En[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),En[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),En[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),En[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),En[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(En),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},En=[new U,new U,new U,new U,new U,new U,new U,new U],sn=new U,Zs=new qn,wi=new U,Ti=new U,Ei=new U,Hn=new U,Wn=new U,ri=new U,ji=new U,Js=new U,Ks=new U,ai=new U;function wo(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){ai.fromArray(i,r);let o=s.x*Math.abs(ai.x)+s.y*Math.abs(ai.y)+s.z*Math.abs(ai.z),c=t.dot(ai),l=e.dot(ai),h=n.dot(ai);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>o)return!1}return!0}var he=new U,js=new Ht,ku=0,pn=class extends mn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ku++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=ah,this.updateRanges=[],this.gpuType=on,this.version=0,this._normalizationScale=t!==void 0?ul(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)js.fromBufferAttribute(this,e),js.applyMatrix3(t),this.setXY(e,js.x,js.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix3(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix4(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyNormalMatrix(t),this.setXYZ(e,he.x,he.y,he.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.transformDirection(t),this.setXYZ(e,he.x,he.y,he.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ru(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Pu(t,this.array)}};var cs=class extends pn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var hs=class extends pn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var te=class extends pn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Vu=new qn,Qi=new U,To=new U,ci=class{constructor(t=new U,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Vu.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qi.subVectors(t,this.center);let e=Qi.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Qi,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(To.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qi.copy(t.center).add(To)),this.expandByPoint(Qi.copy(t.center).sub(To))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Gu=0,Ke=new Qt,Eo=new Te,Ai=new U,ke=new qn,$i=new qn,Se=new U,Pe=class i extends mn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Gu++}),this.uuid=Ds(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Eu(t)?hs:cs)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new It().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ke.makeRotationFromQuaternion(t),this.applyMatrix4(Ke),this}rotateX(t){return Ke.makeRotationX(t),this.applyMatrix4(Ke),this}rotateY(t){return Ke.makeRotationY(t),this.applyMatrix4(Ke),this}rotateZ(t){return Ke.makeRotationZ(t),this.applyMatrix4(Ke),this}translate(t,e,n){return Ke.makeTranslation(t,e,n),this.applyMatrix4(Ke),this}scale(t,e,n){return Ke.makeScale(t,e,n),this.applyMatrix4(Ke),this}lookAt(t){return Eo.lookAt(t),Eo.updateMatrix(),this.applyMatrix4(Eo.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ai).negate(),this.translate(Ai.x,Ai.y,Ai.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new te(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Ct("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Pt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ke.setFromBufferAttribute(r),this.morphTargetsRelative?(Se.addVectors(this.boundingBox.min,ke.min),this.boundingBox.expandByPoint(Se),Se.addVectors(this.boundingBox.max,ke.max),this.boundingBox.expandByPoint(Se)):(this.boundingBox.expandByPoint(ke.min),this.boundingBox.expandByPoint(ke.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Pt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ci);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Pt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(t){let n=this.boundingSphere.center;if(ke.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];$i.setFromBufferAttribute(o),this.morphTargetsRelative?(Se.addVectors(ke.min,$i.min),ke.expandByPoint(Se),Se.addVectors(ke.max,$i.max),ke.expandByPoint(Se)):(ke.expandByPoint($i.min),ke.expandByPoint($i.max))}ke.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Se.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Se));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],c=this.morphTargetsRelative;for(let l=0,h=o.count;l<h;l++)Se.fromBufferAttribute(o,l),c&&(Ai.fromBufferAttribute(t,l),Se.add(Ai)),s=Math.max(s,n.distanceToSquared(Se))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Pt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Pt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],c=[],l=new Uint8Array(n.count);for(let D=0;D<n.count;D++)o[D]=new U,c[D]=new U;let h=new U,f=new U,d=new U,m=new Ht,g=new Ht,S=new Ht,p=new U,u=new U;function M(D,_,N){l[D]=l[_]=l[N]=1,h.fromBufferAttribute(n,D),f.fromBufferAttribute(n,_),d.fromBufferAttribute(n,N),m.fromBufferAttribute(r,D),g.fromBufferAttribute(r,_),S.fromBufferAttribute(r,N),f.sub(h),d.sub(h),g.sub(m),S.sub(m);let B=1/(g.x*S.y-S.x*g.y);isFinite(B)&&(p.copy(f).multiplyScalar(S.y).addScaledVector(d,-g.y).multiplyScalar(B),u.copy(d).multiplyScalar(g.x).addScaledVector(f,-S.x).multiplyScalar(B),o[D].add(p),o[_].add(p),o[N].add(p),c[D].add(u),c[_].add(u),c[N].add(u))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let D=0,_=A.length;D<_;++D){let N=A[D],B=N.start,H=N.count;for(let P=B,G=B+H;P<G;P+=3)M(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let w=new U,C=new U,E=new U,x=new U;function b(D){E.fromBufferAttribute(s,D),x.copy(E);let _=o[D];w.copy(_),w.sub(E.multiplyScalar(E.dot(_))).normalize(),C.crossVectors(x,_);let B=C.dot(c[D])<0?-1:1;a.setXYZW(D,w.x,w.y,w.z,B)}for(let D=0,_=n.count;D<_;++D)l[D]&&b(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new pn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new U,r=new U,a=new U,o=new U,c=new U,l=new U,h=new U,f=new U;if(t)for(let d=0,m=t.count;d<m;d+=3){let g=t.getX(d+0),S=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,S),a.fromBufferAttribute(e,p),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),o.fromBufferAttribute(n,g),c.fromBufferAttribute(n,S),l.fromBufferAttribute(n,p),o.add(h),c.add(h),l.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(S,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,m=e.count;d<m;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Se.fromBufferAttribute(t,e),Se.normalize(),t.setXYZ(e,Se.x,Se.y,Se.z)}toNonIndexed(){function t(o,c){let l=o.array,h=o.itemSize,f=o.normalized,d=new l.constructor(c.length*h),m=0,g=0;for(let S=0,p=c.length;S<p;S++){o.isInterleavedBufferAttribute?m=c[S]*o.data.stride+o.offset:m=c[S]*h;for(let u=0;u<h;u++)d[g++]=l[m++]}return new pn(d,h,f)}if(this.index===null)return Ct("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let o in s){let c=s[o],l=t(c,n);e.setAttribute(o,l)}let r=this.morphAttributes;for(let o in r){let c=[],l=r[o];for(let h=0,f=l.length;h<f;h++){let d=l[h],m=t(d,n);c.push(m)}e.morphAttributes[o]=c}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,c=a.length;o<c;o++){let l=a[o];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,d=l.length;f<d;f++){let m=l[f];h.push(m.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],f=r[l];for(let d=0,m=f.length;d<m;d++)h.push(f[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let l=0,h=a.length;l<h;l++){let f=a[l];this.addGroup(f.start,f.count,f.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ao=new U,Hu=new U,Wu=new It,rn=class{constructor(t=new U(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Ao.subVectors(n,e).cross(Hu.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Ao),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Wu.getNormalMatrix(t),s=this.coplanarPoint(Ao).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Xu=0,_n=class extends mn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Xu++}),this.uuid=Ds(),this.name="",this.type="Material",this.blending=Gi,this.side=Qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ho,this.blendDst=Wo,this.blendEquation=di,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ut(0,0,0),this.blendAlpha=0,this.depthFunc=_i,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=th,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xr,this.stencilZFail=xr,this.stencilZPass=xr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Ct(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ct(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let c=r[o];delete c.metadata,a.push(c)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ut().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new rn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ht().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ht().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var An=new U,Co=new U,Qs=new U,$s=new U,us=class{constructor(t=new U,e=new U(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,An)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=An.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(An.copy(this.origin).addScaledVector(this.direction,e),An.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Co.copy(t).add(e).multiplyScalar(.5),Qs.copy(e).sub(t).normalize(),$s.copy(this.origin).sub(Co);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Qs),o=$s.dot(this.direction),c=-$s.dot(Qs),l=$s.lengthSq(),h=Math.abs(1-a*a),f,d,m,g;if(h>0)if(f=a*c-o,d=a*o-c,g=r*h,f>=0)if(d>=-g)if(d<=g){let S=1/h;f*=S,d*=S,m=f*(f+a*d+2*o)+d*(a*f+d+2*c)+l}else d=r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d=-r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d<=-g?(f=Math.max(0,-(-a*r+o)),d=f>0?-r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l):d<=g?(f=0,d=Math.min(Math.max(-r,-c),r),m=d*(d+2*c)+l):(f=Math.max(0,-(a*r+o)),d=f>0?r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l);else d=a>0?-r:r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Co).addScaledVector(Qs,d),m}intersectSphere(t,e){if(t.radius<0)return null;An.subVectors(t.center,this.origin);let n=An.dot(this.direction),s=An.dot(An)-n*n,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,c=n+a;return c<0?null:o<0?this.at(c,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(t.min.z-d.z)*f,c=(t.max.z-d.z)*f):(o=(t.max.z-d.z)*f,c=(t.min.z-d.z)*f),n>c||o>s)||((o>n||n!==n)&&(n=o),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,An)!==null}intersectTriangle(t,e,n,s,r){let a=this.origin,o=this.direction,c=o.x,l=o.y,h=o.z,f=t.x-a.x,d=t.y-a.y,m=t.z-a.z,g=e.x-a.x,S=e.y-a.y,p=e.z-a.z,u=n.x-a.x,M=n.y-a.y,A=n.z-a.z,w=Math.abs(c),C=Math.abs(l),E=Math.abs(h),x,b,D,_,N,B,H,P,G,q,V,et;if(w>=C&&w>=E?(D=c,B=f,G=g,et=u,c>=0?(x=l,b=h,_=d,N=m,H=S,P=p,q=M,V=A):(x=h,b=l,_=m,N=d,H=p,P=S,q=A,V=M)):C>=E?(D=l,B=d,G=S,et=M,l>=0?(x=h,b=c,_=m,N=f,H=p,P=g,q=A,V=u):(x=c,b=h,_=f,N=m,H=g,P=p,q=u,V=A)):(D=h,B=m,G=p,et=A,h>=0?(x=c,b=l,_=f,N=d,H=g,P=S,q=u,V=M):(x=l,b=c,_=d,N=f,H=S,P=g,q=M,V=u)),D===0)return null;let X=x/D,Q=b/D,$=1/D,Mt=_-X*B,Lt=N-Q*B,J=H-X*G,pt=P-Q*G,vt=q-X*et,Et=V-Q*et,mt=vt*pt-Et*J,Dt=Mt*Et-Lt*vt,le=J*Lt-pt*Mt;if(s){if(mt<0||Dt<0||le<0)return null}else if((mt<0||Dt<0||le<0)&&(mt>0||Dt>0||le>0))return null;let Rt=mt+Dt+le;if(Rt===0)return null;let Zt=$*(mt*B+Dt*G+le*et);return(Rt>0?Zt<0:Zt>0)?null:this.at(Zt/Rt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$e=class extends _n{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new In,this.combine=Qr,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fc=new Qt,oi=new us,tr=new ci,pc=new U,er=new U,nr=new U,ir=new U,Ro=new U,sr=new U,mc=new U,rr=new U,pe=class extends Te{constructor(t=new Pe,e=new $e){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){sr.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=o[c],f=r[c];h!==0&&(Ro.fromBufferAttribute(f,t),a?sr.addScaledVector(Ro,h):sr.addScaledVector(Ro.sub(e),h))}e.add(sr)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),tr.copy(n.boundingSphere),tr.applyMatrix4(r),oi.copy(t.ray).recast(t.near),!(tr.containsPoint(oi.origin)===!1&&(oi.intersectSphere(tr,pc)===null||oi.origin.distanceToSquared(pc)>(t.far-t.near)**2))&&(fc.copy(r).invert(),oi.copy(t.ray).applyMatrix4(fc),!(n.boundingBox!==null&&oi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,oi)))}_computeIntersections(t,e,n){let s,r=this.geometry,a=this.material,o=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,m=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,S=d.length;g<S;g++){let p=d[g],u=a[p.materialIndex],M=Math.max(p.start,m.start),A=Math.min(o.count,Math.min(p.start+p.count,m.start+m.count));for(let w=M,C=A;w<C;w+=3){let E=o.getX(w),x=o.getX(w+1),b=o.getX(w+2);s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),S=Math.min(o.count,m.start+m.count);for(let p=g,u=S;p<u;p+=3){let M=o.getX(p),A=o.getX(p+1),w=o.getX(p+2);s=ar(this,a,t,n,l,h,f,M,A,w),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(a))for(let g=0,S=d.length;g<S;g++){let p=d[g],u=a[p.materialIndex],M=Math.max(p.start,m.start),A=Math.min(c.count,Math.min(p.start+p.count,m.start+m.count));for(let w=M,C=A;w<C;w+=3){let E=w,x=w+1,b=w+2;s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),S=Math.min(c.count,m.start+m.count);for(let p=g,u=S;p<u;p+=3){let M=p,A=p+1,w=p+2;s=ar(this,a,t,n,l,h,f,M,A,w),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function qu(i,t,e,n,s,r,a,o){let c;if(t.side===De?c=n.intersectTriangle(a,r,s,!0,o):c=n.intersectTriangle(s,r,a,t.side===Qn,o),c===null)return null;rr.copy(o),rr.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(rr);return l<e.near||l>e.far?null:{distance:l,point:rr.clone(),object:i}}function ar(i,t,e,n,s,r,a,o,c,l){i.getVertexPosition(o,er),i.getVertexPosition(c,nr),i.getVertexPosition(l,ir);let h=qu(i,t,e,n,er,nr,ir,mc);if(h){let f=new U;Cn.getBarycoord(mc,er,nr,ir,f),s&&(h.uv=Cn.getInterpolatedAttribute(s,o,c,l,f,new Ht)),r&&(h.uv1=Cn.getInterpolatedAttribute(r,o,c,l,f,new Ht)),a&&(h.normal=Cn.getInterpolatedAttribute(a,o,c,l,f,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:c,c:l,normal:new U,materialIndex:0};Cn.getNormal(er,nr,ir,d.normal),h.face=d,h.barycoord=f}return h}var Nr=class extends Oe{constructor(t=null,e=1,n=1,s,r,a,o,c,l=Me,h=Me,f,d){super(null,a,o,c,l,h,s,r,f,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var li=new ci,Yu=new Ht(.5,.5),or=new U,Yn=class{constructor(t=new rn,e=new rn,n=new rn,s=new rn,r=new rn,a=new rn){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=je,n=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],c=r[2],l=r[3],h=r[4],f=r[5],d=r[6],m=r[7],g=r[8],S=r[9],p=r[10],u=r[11],M=r[12],A=r[13],w=r[14],C=r[15];if(s[0].setComponents(l-a,m-h,u-g,C-M).normalize(),s[1].setComponents(l+a,m+h,u+g,C+M).normalize(),s[2].setComponents(l+o,m+f,u+S,C+A).normalize(),s[3].setComponents(l-o,m-f,u-S,C-A).normalize(),n)s[4].setComponents(c,d,p,w).normalize(),s[5].setComponents(l-c,m-d,u-p,C-w).normalize();else if(s[4].setComponents(l-c,m-d,u-p,C-w).normalize(),e===je)s[5].setComponents(l+c,m+d,u+p,C+w).normalize();else if(e===Li)s[5].setComponents(c,d,p,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),li.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),li.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(li)}intersectsSprite(t){li.center.set(0,0,0);let e=Yu.distanceTo(t.center);return li.radius=.7071067811865476+e,li.applyMatrix4(t.matrixWorld),this.intersectsSphere(li)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(or.x=s.normal.x>0?t.max.x:t.min.x,or.y=s.normal.y>0?t.max.y:t.min.y,or.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(or)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gc=new Qt,Dr=class i{constructor(){this.coordinateSystem=je,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];gc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Yn),n[s].setFromProjectionMatrix(gc,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Yn),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Zn=class extends _n{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ur=new U,Fr=new U,xc=new Qt,ts=new us,lr=new ci,Po=new U,vc=new U,Fi=class extends Te{constructor(t=new Pe,e=new Zn){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ur.fromBufferAttribute(e,s-1),Fr.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ur.distanceTo(Fr);t.setAttribute("lineDistance",new te(n,1))}else Ct("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),lr.copy(n.boundingSphere),lr.applyMatrix4(s),lr.radius+=r,t.ray.intersectsSphere(lr)===!1)return;xc.copy(s).invert(),ts.copy(t.ray).applyMatrix4(xc);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let S=m,p=g-1;S<p;S+=l){let u=h.getX(S),M=h.getX(S+1),A=cr(this,t,ts,c,u,M,S);A&&e.push(A)}if(this.isLineLoop){let S=h.getX(g-1),p=h.getX(m),u=cr(this,t,ts,c,S,p,g-1);u&&e.push(u)}}else{let m=Math.max(0,a.start),g=Math.min(d.count,a.start+a.count);for(let S=m,p=g-1;S<p;S+=l){let u=cr(this,t,ts,c,S,S+1,S);u&&e.push(u)}if(this.isLineLoop){let S=cr(this,t,ts,c,g-1,m,g-1);S&&e.push(S)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function cr(i,t,e,n,s,r,a){let o=i.geometry.attributes.position;if(Ur.fromBufferAttribute(o,s),Fr.fromBufferAttribute(o,r),e.distanceSqToSegment(Ur,Fr,Po,vc)>n)return;Po.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Po);if(!(l<t.near||l>t.far))return{distance:l,point:vc.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var yc=new U,Sc=new U,Oi=class extends Fi{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)yc.fromBufferAttribute(e,s),Sc.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+yc.distanceTo(Sc);t.setAttribute("lineDistance",new te(n,1))}else Ct("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ds=class extends Oe{constructor(t=[],e=fi,n,s,r,a,o,c,l,h){super(t,e,n,s,r,a,o,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ln=class extends Oe{constructor(t,e,n=an,s,r,a,o=Me,c=Me,l,h=Pn,f=1){if(h!==Pn&&h!==Un)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:f};super(d,s,r,a,o,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Di(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},fs=class extends Ln{constructor(t,e=an,n=fi,s,r,a=Me,o=Me,c,l=Pn){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ps=class extends Oe{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Nn=class i extends Pe{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let c=[],l=[],h=[],f=[],d=0,m=0;g("z","y","x",-1,-1,n,e,t,a,r,0),g("z","y","x",1,-1,n,e,-t,a,r,1),g("x","z","y",1,1,t,n,e,s,a,2),g("x","z","y",1,-1,t,n,-e,s,a,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2));function g(S,p,u,M,A,w,C,E,x,b,D){let _=w/x,N=C/b,B=w/2,H=C/2,P=E/2,G=x+1,q=b+1,V=0,et=0,X=new U;for(let Q=0;Q<q;Q++){let $=Q*N-H;for(let Mt=0;Mt<G;Mt++){let Lt=Mt*_-B;X[S]=Lt*M,X[p]=$*A,X[u]=P,l.push(X.x,X.y,X.z),X[S]=0,X[p]=0,X[u]=E>0?1:-1,h.push(X.x,X.y,X.z),f.push(Mt/x),f.push(1-Q/b),V+=1}}for(let Q=0;Q<b;Q++)for(let $=0;$<x;$++){let Mt=d+$+G*Q,Lt=d+$+G*(Q+1),J=d+($+1)+G*(Q+1),pt=d+($+1)+G*Q;c.push(Mt,Lt,pt),c.push(Lt,J,pt),et+=6}o.addGroup(m,et,D),m+=et,d+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Bi=class i extends Pe{constructor(t=1,e=1,n=1,s=32,r=1,a=!1,o=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],d=[],m=[],g=0,S=[],p=n/2,u=0;M(),a===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new te(f,3)),this.setAttribute("normal",new te(d,3)),this.setAttribute("uv",new te(m,2));function M(){let w=new U,C=new U,E=0,x=(e-t)/n;for(let b=0;b<=r;b++){let D=[],_=b/r,N=_*(e-t)+t;for(let B=0;B<=s;B++){let H=B/s,P=H*c+o,G=Math.sin(P),q=Math.cos(P);C.x=N*G,C.y=-_*n+p,C.z=N*q,f.push(C.x,C.y,C.z),w.set(G,x,q).normalize(),d.push(w.x,w.y,w.z),m.push(H,1-_),D.push(g++)}S.push(D)}for(let b=0;b<s;b++)for(let D=0;D<r;D++){let _=S[D][b],N=S[D+1][b],B=S[D+1][b+1],H=S[D][b+1];(t>0||D!==0)&&(h.push(_,N,H),E+=3),(e>0||D!==r-1)&&(h.push(N,B,H),E+=3)}l.addGroup(u,E,0),u+=E}function A(w){let C=g,E=new Ht,x=new U,b=0,D=w===!0?t:e,_=w===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,p*_,0),d.push(0,_,0),m.push(.5,.5),g++;let N=g;for(let B=0;B<=s;B++){let P=B/s*c+o,G=Math.cos(P),q=Math.sin(P);x.x=D*q,x.y=p*_,x.z=D*G,f.push(x.x,x.y,x.z),d.push(0,_,0),E.x=G*.5+.5,E.y=q*.5*_+.5,m.push(E.x,E.y),g++}for(let B=0;B<s;B++){let H=C+B,P=N+B;w===!0?h.push(P,P+1,H):h.push(P+1,P,H),b+=3}l.addGroup(u,b,w===!0?1:2),u+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ms=class i extends Bi{constructor(t=1,e=1,n=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,n,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var hr=new U,ur=new U,Io=new U,dr=new Cn,gs=class extends Pe{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(vr*e),a=t.getIndex(),o=t.getAttribute("position"),c=a?a.count:o.count,l=[0,0,0],h=["a","b","c"],f=new Array(3),d=new Map,m=[];for(let g=0;g<c;g+=3){a?(l[0]=a.getX(g),l[1]=a.getX(g+1),l[2]=a.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:S,b:p,c:u}=dr;if(S.fromBufferAttribute(o,l[0]),p.fromBufferAttribute(o,l[1]),u.fromBufferAttribute(o,l[2]),dr.getNormal(Io),f[0]=`${Math.round(S.x*s)},${Math.round(S.y*s)},${Math.round(S.z*s)}`,f[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,f[2]=`${Math.round(u.x*s)},${Math.round(u.y*s)},${Math.round(u.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let M=0;M<3;M++){let A=(M+1)%3,w=f[M],C=f[A],E=dr[h[M]],x=dr[h[A]],b=`${w}_${C}`,D=`${C}_${w}`,_=d.get(D);_?(Io.dot(_.normal)<=r&&(m.push(E.x,E.y,E.z),m.push(x.x,x.y,x.z)),d.set(D,null)):d.has(b)||d.set(b,{index0:l[M],index1:l[A],normal:Io.clone()})}}for(let g of d.values())if(g){let{index0:S,index1:p}=g;hr.fromBufferAttribute(o,S),ur.fromBufferAttribute(o,p),m.push(hr.x,hr.y,hr.z),m.push(ur.x,ur.y,ur.z)}this.setAttribute("position",new te(m,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var hi=class i extends Pe{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(n),c=Math.floor(s),l=o+1,h=c+1,f=t/o,d=e/c,m=[],g=[],S=[],p=[];for(let u=0;u<h;u++){let M=u*d-a;for(let A=0;A<l;A++){let w=A*f-r;g.push(w,-M,0),S.push(0,0,1),p.push(A/o),p.push(1-u/c)}}for(let u=0;u<c;u++)for(let M=0;M<o;M++){let A=M+l*u,w=M+l*(u+1),C=M+1+l*(u+1),E=M+1+l*u;m.push(A,w,E),m.push(w,C,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(S,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var zi=class i extends Pe{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(a+o,Math.PI),l=0,h=[],f=new U,d=new U,m=[],g=[],S=[],p=[];for(let u=0;u<=n;u++){let M=[],A=u/n,w=a+A*o,C=t*Math.cos(w),E=Math.sqrt(t*t-C*C),x=0;u===0&&a===0?x=.5/e:u===n&&c===Math.PI&&(x=-.5/e);for(let b=0;b<=e;b++){let D=b/e,_=s+D*r;f.x=-E*Math.cos(_),f.y=C,f.z=E*Math.sin(_),g.push(f.x,f.y,f.z),d.copy(f).normalize(),S.push(d.x,d.y,d.z),p.push(D+x,1-A),M.push(l++)}h.push(M)}for(let u=0;u<n;u++)for(let M=0;M<e;M++){let A=h[u][M+1],w=h[u][M],C=h[u+1][M],E=h[u+1][M+1];(u!==0||a>0)&&m.push(A,w,E),(u!==n-1||c<Math.PI)&&m.push(w,C,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(S,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var xs=class i extends Pe{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],h=[],f=[],d=new U,m=new U,g=new U;for(let S=0;S<=n;S++){let p=a+S/n*o;for(let u=0;u<=s;u++){let M=u/s*r;m.x=(t+e*Math.cos(p))*Math.cos(M),m.y=(t+e*Math.cos(p))*Math.sin(M),m.z=e*Math.sin(p),l.push(m.x,m.y,m.z),d.x=t*Math.cos(M),d.y=t*Math.sin(M),g.subVectors(m,d).normalize(),h.push(g.x,g.y,g.z),f.push(u/s),f.push(S/n)}}for(let S=1;S<=n;S++)for(let p=1;p<=s;p++){let u=(s+1)*S+p-1,M=(s+1)*(S-1)+p-1,A=(s+1)*(S-1)+p,w=(s+1)*S+p;c.push(u,M,w),c.push(M,A,w)}this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function mi(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Mc(s))s.isRenderTargetTexture?(Ct("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Mc(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Ie(i){let t={};for(let e=0;e<i.length;e++){let n=mi(i[e]);for(let s in n)t[s]=n[s]}return t}function Mc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Zu(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function dl(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Gt.workingColorSpace}var fh={clone:mi,merge:Ie},Ju=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ku=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,gn=class extends _n{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ju,this.fragmentShader=Ku,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=mi(t.uniforms),this.uniformsGroups=Zu(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Ut().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ht().fromArray(s.value);break;case"v3":this.uniforms[n].value=new U().fromArray(s.value);break;case"v4":this.uniforms[n].value=new se().fromArray(s.value);break;case"m3":this.uniforms[n].value=new It().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Or=class extends gn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vs=class extends _n{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new Ht(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new In,this.combine=Qr,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Br=class extends _n{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qc,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},zr=class extends _n{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ci(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function fr(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Jn=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let a;e:{i:if(!(t<s)){for(let o=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=e[++n],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(n=2,r=o);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}a=n,n=0;break e}break n}for(;n<a;){let o=n+a>>>1;t<e[o]?a=o:n=o+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=n[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:No,endingEnd:No}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],c=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Do:r=t,o=2*e-n;break;case Uo:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Do:a=t,c=2*n-e;break;case Uo:a=1,c=n+s[1]-s[0];break;default:a=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-o),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-e)/(s-e),S=g*g,p=S*g,u=-d*p+2*d*S-d*g,M=(1+d)*p+(-1.5-2*d)*S+(-.5+d)*g+1,A=(-1-m)*p+(1.5+m)*S+.5*g,w=m*p-m*S;for(let C=0;C!==o;++C)r[C]=u*a[h+C]+M*a[l+C]+A*a[c+C]+w*a[f+C];return r}},Vr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=(n-e)/(s-e),f=1-h;for(let d=0;d!==o;++d)r[d]=a[l+d]*f+a[c+d]*h;return r}},Gr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Hr=class extends Jn{interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-e)/(s-e),S=1-g;for(let p=0;p!==o;++p)r[p]=a[l+p]*S+a[c+p]*g;return r}let d=o*2,m=t-1;for(let g=0;g!==o;++g){let S=a[l+g],p=a[c+g],u=m*d+g*2,M=f[u],A=f[u+1],w=t*d+g*2,C=h[w],E=h[w+1],x=Qu(n,e,M,C,s);r[g]=ph(x,S,A,E,p)}return r}};function ph(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function ju(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Qu(i,t,e,n,s){let r=(i-t)/(s-t);for(let a=0;a<8;a++){let o=ph(r,t,e,n,s)-i;if(Math.abs(o)<1e-10)break;let c=ju(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-o/c))}return r}var We=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ci(e,this.TimeBufferType),this.values=Ci(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Ci(t.times,Array),values:Ci(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),fr(t.settings)&&(n.settings={inTangents:Ci(t.settings.inTangents,Array),outTangents:Ci(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Gr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Vr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new kr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Hr(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ns:e=this.InterpolantFactoryMethodDiscrete;break;case Rr:e=this.InterpolantFactoryMethodLinear;break;case gr:e=this.InterpolantFactoryMethodSmooth;break;case Lo:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ct("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ns;case this.InterpolantFactoryMethodLinear:return Rr;case this.InterpolantFactoryMethodSmooth:return gr;case this.InterpolantFactoryMethodBezier:return Lo}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;fr(this.settings)&&(bc(this.settings.inTangents,t),bc(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;fr(this.settings)&&(wc(this.settings.inTangents,t),wc(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<t;)++r;for(;a!==-1&&n[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Pt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Pt("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let c=n[o];if(typeof c=="number"&&isNaN(c)){Pt("KeyframeTrack: Time is not a valid number.",this,o,c),t=!1;break}if(a!==null&&a>c){Pt("KeyframeTrack: Out of order keys.",this,o,c,a),t=!1;break}a=c}if(s!==void 0&&Au(s))for(let o=0,c=s.length;o!==c;++o){let l=s[o];if(isNaN(l)){Pt("KeyframeTrack: Value is not a valid number.",this,o,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===gr,r=t.length-1,a=1;for(let o=1;o<r;++o){let c=!1,l=t[o],h=t[o+1];if(l!==h&&(o!==1||l!==t[0]))if(s)c=!0;else{let f=o*n,d=f-n,m=f+n;for(let g=0;g!==n;++g){let S=e[f+g];if(S!==e[d+g]||S!==e[m+g]){c=!0;break}}}if(c){if(o!==a){t[a]=t[o];let f=o*n,d=a*n;for(let m=0;m!==n;++m)e[d+m]=e[f+m]}++a}}if(r>0){t[a]=t[r];for(let o=r*n,c=a*n,l=0;l!==n;++l)e[c+l]=e[o+l];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,fr(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function wc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}We.prototype.ValueTypeName="";We.prototype.TimeBufferType=Float32Array;We.prototype.ValueBufferType=Float32Array;We.prototype.DefaultInterpolation=Rr;var Kn=class extends We{constructor(t,e,n){super(t,e,n)}};Kn.prototype.ValueTypeName="bool";Kn.prototype.ValueBufferType=Array;Kn.prototype.DefaultInterpolation=ns;Kn.prototype.InterpolantFactoryMethodLinear=void 0;Kn.prototype.InterpolantFactoryMethodSmooth=void 0;var Wr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Wr.prototype.ValueTypeName="color";var Xr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Xr.prototype.ValueTypeName="number";var qr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=(n-e)/(s-e),l=t*o;for(let h=l+o;l!==h;l+=4)Qe.slerpFlat(r,0,a,l-o,a,l,c);return r}},ys=class extends We{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new qr(this.times,this.values,this.getValueSize(),t)}};ys.prototype.ValueTypeName="quaternion";ys.prototype.InterpolantFactoryMethodSmooth=void 0;var jn=class extends We{constructor(t,e,n){super(t,e,n)}};jn.prototype.ValueTypeName="string";jn.prototype.ValueBufferType=Array;jn.prototype.DefaultInterpolation=ns;jn.prototype.InterpolantFactoryMethodLinear=void 0;jn.prototype.InterpolantFactoryMethodSmooth=void 0;var Yr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Yr.prototype.ValueTypeName="vector";var Zr=class{constructor(t,e,n){let s=this,r=!1,a=0,o=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,f){return l.push(h,f),this},this.removeHandler=function(h){let f=l.indexOf(h);return f!==-1&&l.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=l.length;f<d;f+=2){let m=l[f],g=l[f+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mh=new Zr,Jr=class{constructor(t){this.manager=t!==void 0?t:mh,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ss=class extends Te{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ut(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ms=class extends Ss{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Te.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ut(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},_o=new Qt,Tc=new U,Ec=new U,Kr=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ht(512,512),this.mapType=Be,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Yn,this._frameExtents=new Ht(1,1),this._viewportCount=1,this._viewports=[new se(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Tc.setFromMatrixPosition(t.matrixWorld),e.position.copy(Tc),Ec.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Ec),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){_o.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(_o,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Li||t.reversedDepth?e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,.5,.5,0,0,0,1),e.multiply(_o)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},pr=new U,mr=new Qe,dn=new U,bs=class extends Te{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=je,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xn=new U,Ac=new Ht,Cc=new Ht,Le=class extends bs{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Pr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(vr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Pr*2*Math.atan(Math.tan(vr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Xn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z),Xn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z)}getViewSize(t,e){return this.getViewBounds(t,Ac,Cc),e.subVectors(Cc,Ac)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(vr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let c=a.fullWidth,l=a.fullHeight;r+=a.offsetX*s/c,e-=a.offsetY*n/l,s*=a.width/c,n*=a.height/l}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ws=class extends bs{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,a=n+t,o=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,a=r+l*this.view.width,o-=h*this.view.offsetY,c=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Fo=class extends Kr{constructor(){super(new ws(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ts=class extends Ss{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Te.DEFAULT_UP),this.updateMatrix(),this.target=new Te,this.shadow=new Fo}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ri=-90,Pi=1,ki=class extends Te{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Le(Ri,Pi,t,e);s.layers=this.layers,this.add(s);let r=new Le(Ri,Pi,t,e);r.layers=this.layers,this.add(r);let a=new Le(Ri,Pi,t,e);a.layers=this.layers,this.add(a);let o=new Le(Ri,Pi,t,e);o.layers=this.layers,this.add(o);let c=new Le(Ri,Pi,t,e);c.layers=this.layers,this.add(c);let l=new Le(Ri,Pi,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,c]=e;for(let l of e)this.remove(l);if(t===je)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Li)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,c,l,h]=this.children,f=t.getRenderTarget(),d=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=S,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,d,m),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},jr=class extends Le{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var fl="\\[\\]\\.:\\/",$u=new RegExp("["+fl+"]","g"),pl="[^"+fl+"]",td="[^"+fl.replace("\\.","")+"]",ed=/((?:WC+[\/:])*)/.source.replace("WC",pl),nd=/(WCOD+)?/.source.replace("WCOD",td),id=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pl),sd=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pl),rd=new RegExp("^"+ed+nd+id+sd+"$"),ad=["material","materials","bones","map"],Oo=class{constructor(t,e,n){let s=n||ee.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},ee=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace($u,"")}static parseTrackName(t){let e=rd.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ad.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let c=n(o.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Ct("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){Pt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Pt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Pt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Pt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Pt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Pt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){Pt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let a=t[s];if(a===void 0){let l=e.nodeName;Pt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Pt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Pt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(c=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ee.Composite=Oo;ee.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ee.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ee.prototype.GetterByBindingType=[ee.prototype._getValue_direct,ee.prototype._getValue_array,ee.prototype._getValue_arrayElement,ee.prototype._getValue_toArray];ee.prototype.SetterByBindingTypeAndVersioning=[[ee.prototype._setValue_direct,ee.prototype._setValue_direct_setNeedsUpdate,ee.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_array,ee.prototype._setValue_array_setNeedsUpdate,ee.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_arrayElement,ee.prototype._setValue_arrayElement_setNeedsUpdate,ee.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_fromArray,ee.prototype._setValue_fromArray_setNeedsUpdate,ee.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p0=new Float32Array(1);var Bo=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Es=class extends Oi{constructor(t=10,e=10,n=4473924,s=8947848){n=new Ut(n),s=new Ut(s);let r=e/2,a=t/e,o=t/2,c=[],l=[];for(let d=0,m=0,g=-o;d<=e;d++,g+=a){c.push(-o,0,g,o,0,g),c.push(g,0,-o,g,0,o);let S=d===r?n:s;S.toArray(l,m),m+=3,S.toArray(l,m),m+=3,S.toArray(l,m),m+=3,S.toArray(l,m),m+=3}let h=new Pe;h.setAttribute("position",new te(c,3)),h.setAttribute("color",new te(l,3));let f=new Zn({vertexColors:!0,toneMapped:!1});super(h,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};function ml(i,t,e,n){let s=od(n);switch(e){case il:return i*t;case rl:return i*t/s.components*s.byteLength;case ra:return i*t/s.components*s.byteLength;case $n:return i*t*2/s.components*s.byteLength;case aa:return i*t*2/s.components*s.byteLength;case sl:return i*t*3/s.components*s.byteLength;case cn:return i*t*4/s.components*s.byteLength;case oa:return i*t*4/s.components*s.byteLength;case Rs:case Ps:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Is:case _s:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ca:case ua:return Math.max(i,16)*Math.max(t,8)/4;case la:case ha:return Math.max(i,8)*Math.max(t,8)/2;case da:case fa:case ma:case ga:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case pa:case Ls:case xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case va:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ya:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Sa:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Ma:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ba:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case wa:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Ta:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ea:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Aa:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Ca:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ra:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Pa:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Ia:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case _a:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case La:case Na:case Da:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ua:case Fa:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ns:case Oa:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function od(i){switch(i){case Be:case $o:return{byteLength:1,components:1};case Wi:case tl:case ln:return{byteLength:2,components:1};case ia:case sa:return{byteLength:2,components:4};case an:case na:case on:return{byteLength:4,components:1};case el:case nl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ct("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Oh(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function cd(i){let t=new WeakMap;function e(o,c){let l=o.array,h=o.usage,f=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),o.onUploadCallback();let m;if(l instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=i.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=i.SHORT;else if(l instanceof Uint32Array)m=i.UNSIGNED_INT;else if(l instanceof Int32Array)m=i.INT;else if(l instanceof Int8Array)m=i.BYTE;else if(l instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,c,l){let h=c.array,f=c.updateRanges;if(i.bindBuffer(l,o),f.length===0)i.bufferSubData(l,0,h);else{f.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<f.length;m++){let g=f[d],S=f[m];S.start<=g.start+g.count+1?g.count=Math.max(g.count,S.start+S.count-g.start):(++d,f[d]=S)}f.length=d+1;for(let m=0,g=f.length;m<g;m++){let S=f[m];i.bufferSubData(l,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let c=t.get(o);c&&(i.deleteBuffer(c.buffer),t.delete(o))}function a(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let l=t.get(o);if(l===void 0)t.set(o,e(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,o,c),l.version=o.version}}return{get:s,remove:r,update:a}}var hd=`#ifdef USE_ALPHAHASH
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
#endif`,Pd=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Id=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,_d=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
vec3 nonPerturbedNormal = normal;`,Pf=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,_f=`#ifndef FLAT_SHADED
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
}`,Pp=`#define MATCAP
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
}`,_p=`#define NORMAL
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
}`,Bt={alphahash_fragment:hd,alphahash_pars_fragment:ud,alphamap_fragment:dd,alphamap_pars_fragment:fd,alphatest_fragment:pd,alphatest_pars_fragment:md,aomap_fragment:gd,aomap_pars_fragment:xd,batching_pars_vertex:vd,batching_vertex:yd,begin_vertex:Sd,beginnormal_vertex:Md,bsdfs:bd,iridescence_fragment:wd,bumpmap_pars_fragment:Td,clipping_planes_fragment:Ed,clipping_planes_pars_fragment:Ad,clipping_planes_pars_vertex:Cd,clipping_planes_vertex:Rd,color_fragment:Pd,color_pars_fragment:Id,color_pars_vertex:_d,color_vertex:Ld,common:Nd,defaultnormal_vertex:Dd,displacementmap_pars_vertex:Ud,displacementmap_vertex:Fd,emissivemap_fragment:Od,emissivemap_pars_fragment:Bd,colorspace_fragment:zd,colorspace_pars_fragment:kd,envmap_fragment:Vd,envmap_common_pars_fragment:Gd,envmap_pars_fragment:Hd,envmap_pars_vertex:Wd,envmap_physical_pars_fragment:ef,envmap_vertex:Xd,fog_vertex:qd,fog_pars_vertex:Yd,fog_fragment:Zd,fog_pars_fragment:Jd,gradientmap_pars_fragment:Kd,lightmap_pars_fragment:jd,lights_lambert_fragment:Qd,lights_lambert_pars_fragment:$d,lights_pars_begin:tf,lights_toon_fragment:nf,lights_toon_pars_fragment:sf,lights_phong_fragment:rf,lights_phong_pars_fragment:af,lights_physical_fragment:of,lights_physical_pars_fragment:lf,lights_fragment_begin:cf,lights_fragment_maps:hf,lights_fragment_end:uf,lightprobes_pars_fragment:df,logdepthbuf_fragment:ff,logdepthbuf_pars_fragment:pf,logdepthbuf_pars_vertex:mf,logdepthbuf_vertex:gf,map_fragment:xf,map_pars_fragment:vf,map_particle_fragment:yf,map_particle_pars_fragment:Sf,metalnessmap_fragment:Mf,metalnessmap_pars_fragment:bf,morphinstance_vertex:wf,morphcolor_vertex:Tf,morphnormal_vertex:Ef,morphtarget_pars_vertex:Af,morphtarget_vertex:Cf,normal_fragment_begin:Rf,normal_fragment_maps:Pf,normal_pars_fragment:If,normal_pars_vertex:_f,normal_vertex:Lf,normalmap_pars_fragment:Nf,clearcoat_normal_fragment_begin:Df,clearcoat_normal_fragment_maps:Uf,clearcoat_pars_fragment:Ff,iridescence_pars_fragment:Of,opaque_fragment:Bf,packing:zf,premultiplied_alpha_fragment:kf,project_vertex:Vf,dithering_fragment:Gf,dithering_pars_fragment:Hf,roughnessmap_fragment:Wf,roughnessmap_pars_fragment:Xf,shadowmap_pars_fragment:qf,shadowmap_pars_vertex:Yf,shadowmap_vertex:Zf,shadowmask_pars_fragment:Jf,skinbase_vertex:Kf,skinning_pars_vertex:jf,skinning_vertex:Qf,skinnormal_vertex:$f,specularmap_fragment:tp,specularmap_pars_fragment:ep,tonemapping_fragment:np,tonemapping_pars_fragment:ip,transmission_fragment:sp,transmission_pars_fragment:rp,uv_pars_fragment:ap,uv_pars_vertex:op,uv_vertex:lp,worldpos_vertex:cp,background_vert:hp,background_frag:up,backgroundCube_vert:dp,backgroundCube_frag:fp,cube_vert:pp,cube_frag:mp,depth_vert:gp,depth_frag:xp,distance_vert:vp,distance_frag:yp,equirect_vert:Sp,equirect_frag:Mp,linedashed_vert:bp,linedashed_frag:wp,meshbasic_vert:Tp,meshbasic_frag:Ep,meshlambert_vert:Ap,meshlambert_frag:Cp,meshmatcap_vert:Rp,meshmatcap_frag:Pp,meshnormal_vert:Ip,meshnormal_frag:_p,meshphong_vert:Lp,meshphong_frag:Np,meshphysical_vert:Dp,meshphysical_frag:Up,meshtoon_vert:Fp,meshtoon_frag:Op,points_vert:Bp,points_frag:zp,shadow_vert:kp,shadow_frag:Vp,sprite_vert:Gp,sprite_frag:Hp},ft={common:{diffuse:{value:new Ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new It},alphaMap:{value:null},alphaMapTransform:{value:new It},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new It}},envmap:{envMap:{value:null},envMapRotation:{value:new It},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new It}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new It}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new It},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new It},normalScale:{value:new Ht(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new It},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new It}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new It}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new It}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new It},alphaTest:{value:0},uvTransform:{value:new It}},sprite:{diffuse:{value:new Ut(16777215)},opacity:{value:1},center:{value:new Ht(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new It},alphaMap:{value:null},alphaMapTransform:{value:new It},alphaTest:{value:0}}},Sn={basic:{uniforms:Ie([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Bt.meshbasic_vert,fragmentShader:Bt.meshbasic_frag},lambert:{uniforms:Ie([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},envMapIntensity:{value:1}}]),vertexShader:Bt.meshlambert_vert,fragmentShader:Bt.meshlambert_frag},phong:{uniforms:Ie([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},specular:{value:new Ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphong_vert,fragmentShader:Bt.meshphong_frag},standard:{uniforms:Ie([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag},toon:{uniforms:Ie([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)}}]),vertexShader:Bt.meshtoon_vert,fragmentShader:Bt.meshtoon_frag},matcap:{uniforms:Ie([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Bt.meshmatcap_vert,fragmentShader:Bt.meshmatcap_frag},points:{uniforms:Ie([ft.points,ft.fog]),vertexShader:Bt.points_vert,fragmentShader:Bt.points_frag},dashed:{uniforms:Ie([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Bt.linedashed_vert,fragmentShader:Bt.linedashed_frag},depth:{uniforms:Ie([ft.common,ft.displacementmap]),vertexShader:Bt.depth_vert,fragmentShader:Bt.depth_frag},normal:{uniforms:Ie([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Bt.meshnormal_vert,fragmentShader:Bt.meshnormal_frag},sprite:{uniforms:Ie([ft.sprite,ft.fog]),vertexShader:Bt.sprite_vert,fragmentShader:Bt.sprite_frag},background:{uniforms:{uvTransform:{value:new It},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Bt.background_vert,fragmentShader:Bt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new It}},vertexShader:Bt.backgroundCube_vert,fragmentShader:Bt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Bt.cube_vert,fragmentShader:Bt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Bt.equirect_vert,fragmentShader:Bt.equirect_frag},distance:{uniforms:Ie([ft.common,ft.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Bt.distance_vert,fragmentShader:Bt.distance_frag},shadow:{uniforms:Ie([ft.lights,ft.fog,{color:{value:new Ut(0)},opacity:{value:1}}]),vertexShader:Bt.shadow_vert,fragmentShader:Bt.shadow_frag}};Sn.physical={uniforms:Ie([Sn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new It},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new It},clearcoatNormalScale:{value:new Ht(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new It},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new It},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new It},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new It},sheen:{value:0},sheenColor:{value:new Ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new It},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new It},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new It},transmissionSamplerSize:{value:new Ht},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new It},attenuationDistance:{value:0},attenuationColor:{value:new Ut(0)},specularColor:{value:new Ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new It},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new It},anisotropyVector:{value:new Ht},anisotropyMap:{value:null},anisotropyMapTransform:{value:new It}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag};var za={r:0,b:0,g:0},Wp=new Qt,Bh=new It;Bh.set(-1,0,0,0,1,0,0,0,1);function Xp(i,t,e,n,s,r){let a=new Ut(0),o=s===!0?0:1,c,l,h=null,f=0,d=null;function m(M){let A=M.isScene===!0?M.background:null;if(A&&A.isTexture){let w=M.backgroundBlurriness>0;A=t.get(A,w)}return A}function g(M){let A=!1,w=m(M);w===null?p(a,o):w&&w.isColor&&(p(w,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(M,A){let w=m(A);w&&w.isCubeTexture?(l===void 0&&(l=new pe(new Nn(1,1,1),new gn({name:"BackgroundCubeMaterial",uniforms:mi(Sn.backgroundCube.uniforms),vertexShader:Sn.backgroundCube.vertexShader,fragmentShader:Sn.backgroundCube.fragmentShader,side:De,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=w,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Wp.makeRotationFromEuler(A.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Bh),l.material.toneMapped=Gt.getTransfer(w.colorSpace)!==Yt,(h!==w||f!==w.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,f=w.version,d=i.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null)):w&&w.isTexture&&(c===void 0&&(c=new pe(new hi(2,2),new gn({name:"BackgroundMaterial",uniforms:mi(Sn.background.uniforms),vertexShader:Sn.background.vertexShader,fragmentShader:Sn.background.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=w,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Gt.getTransfer(w.colorSpace)!==Yt,w.matrixAutoUpdate===!0&&w.updateMatrix(),c.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||f!==w.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,f=w.version,d=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function p(M,A){M.getRGB(za,dl(i)),e.buffers.color.setClear(za.r,za.g,za.b,A,r)}function u(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,A=1){a.set(M),o=A,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(M){o=M,p(a,o)},render:g,addToRenderList:S,dispose:u}}function qp(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,a=!1;function o(N,B,H,P,G){let q=!1,V=f(N,P,H,B);r!==V&&(r=V,l(r.object)),q=m(N,P,H,G),q&&g(N,P,H,G),G!==null&&t.update(G,i.ELEMENT_ARRAY_BUFFER),(q||a)&&(a=!1,w(N,B,H,P),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function c(){return i.createVertexArray()}function l(N){return i.bindVertexArray(N)}function h(N){return i.deleteVertexArray(N)}function f(N,B,H,P){let G=P.wireframe===!0,q=n[B.id];q===void 0&&(q={},n[B.id]=q);let V=N.isInstancedMesh===!0?N.id:0,et=q[V];et===void 0&&(et={},q[V]=et);let X=et[H.id];X===void 0&&(X={},et[H.id]=X);let Q=X[G];return Q===void 0&&(Q=d(c()),X[G]=Q),Q}function d(N){let B=[],H=[],P=[];for(let G=0;G<e;G++)B[G]=0,H[G]=0,P[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:H,attributeDivisors:P,object:N,attributes:{},index:null}}function m(N,B,H,P){let G=r.attributes,q=B.attributes,V=0,et=H.getAttributes();for(let X in et)if(et[X].location>=0){let $=G[X],Mt=q[X];if(Mt===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&(Mt=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&(Mt=N.instanceColor)),$===void 0||$.attribute!==Mt||Mt&&$.data!==Mt.data)return!0;V++}return r.attributesNum!==V||r.index!==P}function g(N,B,H,P){let G={},q=B.attributes,V=0,et=H.getAttributes();for(let X in et)if(et[X].location>=0){let $=q[X];$===void 0&&(X==="instanceMatrix"&&N.instanceMatrix&&($=N.instanceMatrix),X==="instanceColor"&&N.instanceColor&&($=N.instanceColor));let Mt={};Mt.attribute=$,$&&$.data&&(Mt.data=$.data),G[X]=Mt,V++}r.attributes=G,r.attributesNum=V,r.index=P}function S(){let N=r.newAttributes;for(let B=0,H=N.length;B<H;B++)N[B]=0}function p(N){u(N,0)}function u(N,B){let H=r.newAttributes,P=r.enabledAttributes,G=r.attributeDivisors;H[N]=1,P[N]===0&&(i.enableVertexAttribArray(N),P[N]=1),G[N]!==B&&(i.vertexAttribDivisor(N,B),G[N]=B)}function M(){let N=r.newAttributes,B=r.enabledAttributes;for(let H=0,P=B.length;H<P;H++)B[H]!==N[H]&&(i.disableVertexAttribArray(H),B[H]=0)}function A(N,B,H,P,G,q,V){V===!0?i.vertexAttribIPointer(N,B,H,G,q):i.vertexAttribPointer(N,B,H,P,G,q)}function w(N,B,H,P){S();let G=P.attributes,q=H.getAttributes(),V=B.defaultAttributeValues;for(let et in q){let X=q[et];if(X.location>=0){let Q=G[et];if(Q===void 0&&(et==="instanceMatrix"&&N.instanceMatrix&&(Q=N.instanceMatrix),et==="instanceColor"&&N.instanceColor&&(Q=N.instanceColor)),Q!==void 0){let $=Q.normalized,Mt=Q.itemSize,Lt=t.get(Q);if(Lt===void 0)continue;let J=Lt.buffer,pt=Lt.type,vt=Lt.bytesPerElement,Et=pt===i.INT||pt===i.UNSIGNED_INT||Q.gpuType===na;if(Q.isInterleavedBufferAttribute){let mt=Q.data,Dt=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,le=Q.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Rt=0;Rt<X.locationSize;Rt++)u(X.location+Rt,mt.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Rt=0;Rt<X.locationSize;Rt++)p(X.location+Rt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let Rt=0;Rt<X.locationSize;Rt++)A(X.location+Rt,Mt/X.locationSize,pt,$,Dt*vt,(le+Mt/X.locationSize*Rt)*vt,Et)}else{if(Q.isInstancedBufferAttribute){for(let mt=0;mt<X.locationSize;mt++)u(X.location+mt,Q.meshPerAttribute);N.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let mt=0;mt<X.locationSize;mt++)p(X.location+mt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let mt=0;mt<X.locationSize;mt++)A(X.location+mt,Mt/X.locationSize,pt,$,Mt*vt,Mt/X.locationSize*mt*vt,Et)}}else if(V!==void 0){let $=V[et];if($!==void 0)switch($.length){case 2:i.vertexAttrib2fv(X.location,$);break;case 3:i.vertexAttrib3fv(X.location,$);break;case 4:i.vertexAttrib4fv(X.location,$);break;default:i.vertexAttrib1fv(X.location,$)}}}}M()}function C(){D();for(let N in n){let B=n[N];for(let H in B){let P=B[H];for(let G in P){let q=P[G];for(let V in q)h(q[V].object),delete q[V];delete P[G]}}delete n[N]}}function E(N){if(n[N.id]===void 0)return;let B=n[N.id];for(let H in B){let P=B[H];for(let G in P){let q=P[G];for(let V in q)h(q[V].object),delete q[V];delete P[G]}}delete n[N.id]}function x(N){for(let B in n){let H=n[B];for(let P in H){let G=H[P];if(G[N.id]===void 0)continue;let q=G[N.id];for(let V in q)h(q[V].object),delete q[V];delete G[N.id]}}}function b(N){for(let B in n){let H=n[B],P=N.isInstancedMesh===!0?N.id:0,G=H[P];if(G!==void 0){for(let q in G){let V=G[q];for(let et in V)h(V[et].object),delete V[et];delete G[q]}delete H[P],Object.keys(H).length===0&&delete n[B]}}}function D(){_(),a=!0,r!==s&&(r=s,l(r.object))}function _(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:D,resetDefaultState:_,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:S,enableAttribute:p,disableUnusedAttributes:M}}function Yp(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function a(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function o(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let m=0;m<h;m++)d+=l[m];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Zp(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==cn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let b=x===ln&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==Be&&x!==on&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Ct("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Ct("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Ct("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),u=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:a,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:S,maxCubemapSize:p,maxAttributes:u,maxVertexUniforms:M,maxVaryings:A,maxFragmentUniforms:w,maxSamples:C,samples:E}}function Jp(i){let t=this,e=null,n=0,s=!1,r=!1,a=new rn,o=new It,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let m=f.length!==0||d||n!==0||s;return s=d,n=f.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){e=h(f,d,0)},this.setState=function(f,d,m){let g=f.clippingPlanes,S=f.clipIntersection,p=f.clipShadows,u=i.get(f);if(!s||g===null||g.length===0||r&&!p)r?h(null):l();else{let M=r?0:n,A=M*4,w=u.clippingState||null;c.value=w,w=h(g,d,A,m);for(let C=0;C!==A;++C)w[C]=e[C];u.clippingState=w,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=M}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(f,d,m,g){let S=f!==null?f.length:0,p=null;if(S!==0){if(p=c.value,g!==!0||p===null){let u=m+S*4,M=d.matrixWorldInverse;o.getNormalMatrix(M),(p===null||p.length<u)&&(p=new Float32Array(u));for(let A=0,w=m;A!==S;++A,w+=4)a.copy(f[A]).applyMatrix4(M,o),a.normal.toArray(p,w),p[w+3]=a.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=S,t.numIntersection=0,p}}var Os=class extends He{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ds(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
	`)}function sm(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?a(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===$r||m===ta)if(t.has(d)){let g=t.get(d).texture;return o(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let S=new Os(g.height);return S.fromEquirectangularTexture(i,d),t.set(d,S),d.addEventListener("dispose",l),o(S.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===$r||m===ta,S=m===fi||m===Hi;if(g||S){let p=e.get(d),u=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==u)return n===null&&(n=new Va(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let M=d.image;return g&&M&&M.height>0||S&&M&&c(M)?(n===null&&(n=new Va(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function o(d,m){return m===$r?d.mapping=fi:m===ta&&(d.mapping=Hi),d}function c(d){let m=0,g=6;for(let S=0;S<g;S++)d[S]!==void 0&&m++;return m===g}function l(d){let m=d.target;m.removeEventListener("dispose",l);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function rm(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&es("WebGLRenderer: "+n+" extension not supported."),s}}}function am(i,t,e,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let S=r.get(g);S&&(t.remove(S),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,S){return s[S.id]!==void 0||(S.addEventListener("dispose",o),s[S.id]=new WeakRef(S),a.register(S,S.id,S),e.memory.geometries++),S}function h(g){let S=g.attributes;for(let p in S)t.update(S[p],i.ARRAY_BUFFER)}function f(g){let S=g.index,p=g.attributes.position,u=0;if(p===void 0)return;let M=S!==null?S.array.length:p.array.length/3-1,A=p.count>=65535?hs:cs,w=new A(Math.ceil(M/3)*6,1),C=w.array;if(S!==null){let x=S.array;u=S.version;for(let b=0,D=0;b<M;b+=3){let _=x[b+0],N=x[b+1],B=x[b+2];C[D++]=_,C[D++]=N,C[D++]=N,C[D++]=B,C[D++]=B,C[D++]=_}}else{u=p.version;for(let x=0,b=0;x<M;x+=3){let D=x+0,_=x+1,N=x+2;C[b++]=D,C[b++]=_,C[b++]=_,C[b++]=N,C[b++]=N,C[b++]=D}}w.version=u;let E=r.get(g);E&&t.remove(E),r.set(g,w)}function d(g){let S=r.get(g);if(S){let p=g.index;p!==null&&S.version<p.version&&f(g)}else f(g);return r.get(g)}function m(){for(let g in s){let S=s[g].deref();S!==void 0&&c(S)}}return{get:l,update:h,getWireframeAttribute:d,dispose:m}}function om(i,t,e){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function c(f,d){i.drawElements(n,d,r,f*a),e.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,f*a,m),e.update(d,n,m))}function h(f,d,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,m);let S=0;for(let p=0;p<m;p++)S+=d[p];e.update(S,n,1)}this.setMode=s,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function lm(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:Pt("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function cm(i,t,e){let n=new WeakMap,s=new se;function r(a,o,c){let l=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=h!==void 0?h.length:0,d=n.get(o);if(d===void 0||d.count!==f){let D=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let m=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,S=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],u=o.morphAttributes.normal||[],M=o.morphAttributes.color||[],A=0;m===!0&&(A=1),g===!0&&(A=2),S===!0&&(A=3);let w=o.attributes.position.count*A,C=1;w>t.maxTextureSize&&(C=Math.ceil(w/t.maxTextureSize),w=t.maxTextureSize);let E=new Float32Array(w*C*4*f),x=new as(E,w,C,f);x.type=on,x.needsUpdate=!0;let b=A*4;for(let _=0;_<f;_++){let N=p[_],B=u[_],H=M[_],P=w*C*4*_;for(let G=0;G<N.count;G++){let q=G*b;m===!0&&(s.fromBufferAttribute(N,G),E[P+q+0]=s.x,E[P+q+1]=s.y,E[P+q+2]=s.z,E[P+q+3]=0),g===!0&&(s.fromBufferAttribute(B,G),E[P+q+4]=s.x,E[P+q+5]=s.y,E[P+q+6]=s.z,E[P+q+7]=0),S===!0&&(s.fromBufferAttribute(H,G),E[P+q+8]=s.x,E[P+q+9]=s.y,E[P+q+10]=s.z,E[P+q+11]=H.itemSize===4?s.w:1)}}d={count:f,texture:x,size:new Ht(w,C)},n.set(o,d),o.addEventListener("dispose",D)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let m=0;for(let S=0;S<l.length;S++)m+=l[S];let g=o.morphTargetsRelative?1:1-m;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function hm(i,t,e,n,s){let r=new WeakMap;function a(l){let h=s.render.frame,f=l.geometry,d=t.get(l,f);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function o(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var um={[Xo]:"LINEAR_TONE_MAPPING",[qo]:"REINHARD_TONE_MAPPING",[Yo]:"CINEON_TONE_MAPPING",[Zo]:"ACES_FILMIC_TONE_MAPPING",[Ko]:"AGX_TONE_MAPPING",[jo]:"NEUTRAL_TONE_MAPPING",[Jo]:"CUSTOM_TONE_MAPPING"};function dm(i,t,e,n,s,r){let a=new He(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,c=null,l=null,h=new Pe;h.setAttribute("position",new te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new te([0,2,0,0,2,0],2));let f=new Or({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new pe(h,f),m=new ws(-1,1,1,-1,0,1),g=null,S=null,p=!1,u,M=null,A=[],w=!1;this.setSize=function(C,E){a.setSize(C,E),o!==null&&o.setSize(C,E),c!==null&&c.setSize(C,E);for(let x=0;x<A.length;x++){let b=A[x];b.setSize&&b.setSize(C,E)}},this.setEffects=function(C){A=C,w=A.length>0&&A[0].isRenderPass===!0;let E=a.width,x=a.height;A.length>0&&o===null&&(o=new He(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}),c=new He(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(D=>D.needsDepthTexture===!0);b!==(a.depthTexture!==null)&&(b===!0&&l===null&&(l=new Ln(E,x),r===!0&&(l.format=Un,l.type=pi)),a.dispose(),a.depthTexture=b?l:null,a.resolveDepthBuffer=b,a.storeMultisampledDepthBuffer=b);for(let D=0;D<A.length;D++){let _=A[D];_.setSize&&_.setSize(E,x),b&&_.needsDepthTexture===!0&&_.setDepthTexture&&_.setDepthTexture(l)}},this.begin=function(C,E){if(p||C.toneMapping===vn&&A.length===0)return!1;if(M=E,E!==null){let x=E.width,b=E.height;(a.width!==x||a.height!==b)&&this.setSize(x,b)}return w===!1&&C.setRenderTarget(a),u=C.toneMapping,C.toneMapping=vn,!0},this.hasRenderPass=function(){return w},this.end=function(C,E){C.toneMapping=u,p=!0;let x=a,b=o;for(let D=0;D<A.length;D++){let _=A[D];_.enabled!==!1&&(_.render(C,b,x,E),_.needsSwap!==!1&&(x=b,b=b===o?c:o))}if(g!==C.outputColorSpace||S!==C.toneMapping){g=C.outputColorSpace,S=C.toneMapping,f.defines={},Gt.getTransfer(g)===Yt&&(f.defines.SRGB_TRANSFER="");let D=um[S];D&&(f.defines[D]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(M),C.render(d,m),M=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var Vh=new Oe,Gh=new Ln(1,1),Hh=new fs(1),Wh=new as,Xh=new Lr,qh=new ds,Sh=[],Mh=[],bh=new Float32Array(16),wh=new Float32Array(9),Th=new Float32Array(4);function qi(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Sh[s];if(r===void 0&&(r=new Float32Array(s),Sh[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function me(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function ge(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Ha(i,t){let e=Mh[t];e===void 0&&(e=new Int32Array(t),Mh[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function fm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function pm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2fv(this.addr,t),ge(e,t)}}function mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(me(e,t))return;i.uniform3fv(this.addr,t),ge(e,t)}}function gm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4fv(this.addr,t),ge(e,t)}}function xm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;Th.set(n),i.uniformMatrix2fv(this.addr,!1,Th),ge(e,n)}}function vm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;wh.set(n),i.uniformMatrix3fv(this.addr,!1,wh),ge(e,n)}}function ym(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;bh.set(n),i.uniformMatrix4fv(this.addr,!1,bh),ge(e,n)}}function Sm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2iv(this.addr,t),ge(e,t)}}function bm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3iv(this.addr,t),ge(e,t)}}function wm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4iv(this.addr,t),ge(e,t)}}function Tm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Em(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2uiv(this.addr,t),ge(e,t)}}function Am(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3uiv(this.addr,t),ge(e,t)}}function Cm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4uiv(this.addr,t),ge(e,t)}}function Wa(i){return i.version===0&&(i.compareFunction=ll,i.needsUpdate=!0),i}function Rm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Wa(Gh):r=Vh,e.setTexture2D(t||r,s)}function Pm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Xh,s)}function Im(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Wa(Hh):r=qh,e.setTextureCube(t||r,s)}function _m(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Wh,s)}function Lm(i){switch(i){case 5126:return fm;case 35664:return pm;case 35665:return mm;case 35666:return gm;case 35674:return xm;case 35675:return vm;case 35676:return ym;case 5124:case 35670:return Sm;case 35667:case 35671:return Mm;case 35668:case 35672:return bm;case 35669:case 35673:return wm;case 5125:return Tm;case 36294:return Em;case 36295:return Am;case 36296:return Cm;case 35678:case 36198:case 36298:case 36306:case 35682:return Rm;case 35679:case 36299:case 36307:return Pm;case 35680:case 36300:case 36308:case 36293:return Im;case 36289:case 36303:case 36311:case 36292:return _m}}function Nm(i,t){i.uniform1fv(this.addr,t)}function Dm(i,t){let e=qi(t,this.size,2);i.uniform2fv(this.addr,e)}function Um(i,t){let e=qi(t,this.size,3);i.uniform3fv(this.addr,e)}function Fm(i,t){let e=qi(t,this.size,4);i.uniform4fv(this.addr,e)}function Om(i,t){let e=qi(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Bm(i,t){let e=qi(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function zm(i,t){let e=qi(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function km(i,t){i.uniform1iv(this.addr,t)}function Vm(i,t){i.uniform2iv(this.addr,t)}function Gm(i,t){i.uniform3iv(this.addr,t)}function Hm(i,t){i.uniform4iv(this.addr,t)}function Wm(i,t){i.uniform1uiv(this.addr,t)}function Xm(i,t){i.uniform2uiv(this.addr,t)}function qm(i,t){i.uniform3uiv(this.addr,t)}function Ym(i,t){i.uniform4uiv(this.addr,t)}function Zm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Wa(Gh):a=Vh;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function Jm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||Xh,r[a])}function Km(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Wa(Hh):a=qh;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function jm(i,t,e){let n=this.cache,s=t.length,r=Ha(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||Wh,r[a])}function Qm(i){switch(i){case 5126:return Nm;case 35664:return Dm;case 35665:return Um;case 35666:return Fm;case 35674:return Om;case 35675:return Bm;case 35676:return zm;case 5124:case 35670:return km;case 35667:case 35671:return Vm;case 35668:case 35672:return Gm;case 35669:case 35673:return Hm;case 5125:return Wm;case 36294:return Xm;case 36295:return qm;case 36296:return Ym;case 35678:case 36198:case 36298:case 36306:case 35682:return Zm;case 35679:case 36299:case 36307:return Jm;case 35680:case 36300:case 36308:case 36293:return Km;case 36289:case 36303:case 36311:case 36292:return jm}}var vl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Lm(e.type)}},yl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Qm(e.type)}},Sl=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],n)}}},gl=/(\w+)(\])?(\[|\.)?/g;function Eh(i,t){i.seq.push(t),i.map[t.id]=t}function $m(i,t,e){let n=i.name,s=n.length;for(gl.lastIndex=0;;){let r=gl.exec(n),a=gl.lastIndex,o=r[1],c=r[2]==="]",l=r[3];if(c&&(o=o|0),l===void 0||l==="["&&a+2===s){Eh(e,l===void 0?new vl(o,i,t):new yl(o,i,t));break}else{let f=e.map[o];f===void 0&&(f=new Sl(o),Eh(e,f)),e=f}}}var Xi=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=t.getActiveUniform(e,a),c=t.getUniformLocation(e,o.name);$m(o,c,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],c=n[o.id];c.needsUpdate!==!1&&o.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&n.push(a)}return n}};function Ah(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var tg=37297,eg=0;function ng(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}var Ch=new It;function ig(i){Gt._getMatrix(Ch,Gt.workingColorSpace,i);let t=`mat3( ${Ch.elements.map(e=>e.toFixed(4))} )`;switch(Gt.getTransfer(i)){case ss:return[t,"LinearTransferOETF"];case Yt:return[t,"sRGBTransferOETF"];default:return Ct("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Rh(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+ng(i.getShaderSource(t),o)}else return r}function sg(i,t){let e=ig(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rg={[Xo]:"Linear",[qo]:"Reinhard",[Yo]:"Cineon",[Zo]:"ACESFilmic",[Ko]:"AgX",[jo]:"Neutral",[Jo]:"Custom"};function ag(i,t){let e=rg[t];return e===void 0?(Ct("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ka=new U;function og(){Gt.getLuminanceCoefficients(ka);let i=ka.x.toFixed(4),t=ka.y.toFixed(4),e=ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lg(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fs).join(`
`)}function cg(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function hg(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function Fs(i){return i!==""}function Ph(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Ih(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var ug=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ml(i){return i.replace(ug,dg)}function dg(i,t){let e=Bt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Ml(e)}var fg=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function _h(i){return i.replace(fg,pg)}function pg(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Lh(i){let t=`precision ${i.precision} float;
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
`)),a=Ml(a),a=Ph(a,e),a=Ih(a,e),o=Ml(o),o=Ph(o,e),o=Ih(o,e),a=_h(a),o=_h(o),e.isRawShaderMaterial!==!0&&(u=`#version 300 es
`,S=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,p=["#define varying in",e.glslVersion===cl?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===cl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let M=u+S+a,A=u+p+o,w=Ah(s,s.VERTEX_SHADER,M),C=Ah(s,s.FRAGMENT_SHADER,A);s.attachShader(g,w),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(_){if(i.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(w)||"",H=s.getShaderInfoLog(C)||"",P=N.trim(),G=B.trim(),q=H.trim(),V=!0,et=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,w,C);else{let X=Rh(s,w,"vertex"),Q=Rh(s,C,"fragment");Pt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+_.name+`
Material Type: `+_.type+`

Program Info Log: `+P+`
`+X+`
`+Q)}else P!==""?Ct("WebGLProgram: Program Info Log:",P):(G===""||q==="")&&(et=!1);et&&(_.diagnostics={runnable:V,programLog:P,vertexShader:{log:G,prefix:S},fragmentShader:{log:q,prefix:p}})}s.deleteShader(w),s.deleteShader(C),x=new Xi(s,g),b=hg(s,g)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(g,tg)),D},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=eg++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=w,this.fragmentShader=C,this}var bg=0,bl=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new wl(t),e.set(t,n)),n}},wl=class{constructor(t){this.id=bg++,this.code=t,this.usedTimes=0}};function wg(i){return i===$n||i===Ls||i===Ns}function Tg(i,t,e,n,s,r){let a=new os,o=new bl,c=new Set,l=[],h=new Map,f=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,b,D,_,N,B){let H=_.fog,P=N.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?_.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,V=t.get(x.envMap||G,q),et=d[x.type],X=n.precision;x.precision!==null&&(X=n.getMaxPrecision(x.precision),X!==x.precision&&Ct("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let Q=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,$=Q!==void 0?Q.length:0,Mt=0;P.morphAttributes.position!==void 0&&(Mt=1),P.morphAttributes.normal!==void 0&&(Mt=2),P.morphAttributes.color!==void 0&&(Mt=3);let Lt,J,pt,vt;if(et){let dt=Sn[et];Lt=dt.vertexShader,J=dt.fragmentShader}else{Lt=x.vertexShader,J=x.fragmentShader;let dt=o.getVertexShaderStage(x),Jt=o.getFragmentShaderStage(x);o.update(x,dt,Jt),pt=dt.id,vt=Jt.id}let Et=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),Dt=N.isInstancedMesh===!0,le=N.isBatchedMesh===!0,Rt=!!x.map,Zt=!!x.matcap,Kt=!!V,zt=Kt&&V.isPMREMTexture===!0,be=!!x.aoMap,de=!!x.lightMap,Fe=!!x.bumpMap&&x.wireframe===!1,re=!!x.normalMap,un=!!x.displacementMap,xe=!!x.emissiveMap,qe=!!x.metalnessMap,Ye=!!x.roughnessMap,Ze=x.anisotropy>0,L=x.clearcoat>0,Je=x.diffuseRoughness>0,ne=x.dispersion>0,ie=x.retroreflectivity>0,ut=x.iridescence>0,fe=x.sheen>0,At=x.transmission>0,_t=Ze&&!!x.anisotropyMap,T=L&&!!x.clearcoatMap,v=L&&!!x.clearcoatNormalMap,O=L&&!!x.clearcoatRoughnessMap,tt=Je&&!!x.diffuseRoughnessMap,j=ut&&!!x.iridescenceMap,st=ut&&!!x.iridescenceThicknessMap,ct=fe&&!!x.sheenColorMap,Y=fe&&!!x.sheenRoughnessMap,Z=!!x.specularMap,at=!!x.specularColorMap,R=!!x.specularIntensityMap,K=At&&!!x.transmissionMap,W=At&&!!x.thicknessMap,ot=!!x.gradientMap,it=!!x.alphaMap,rt=x.alphaTest>0,wt=!!x.alphaHash,Ot=!!x.extensions,nt=vn;x.toneMapped&&(Et===null||Et.isXRRenderTarget===!0)&&(nt=i.toneMapping);let Tt=zt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Ft={shaderID:et,shaderType:x.type,shaderName:x.name,vertexShader:Lt,fragmentShader:J,defines:x.defines,customVertexShaderID:pt,customFragmentShaderID:vt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:le,batchingColor:le&&N._colorsTexture!==null,instancing:Dt,instancingColor:Dt&&N.instanceColor!==null,instancingMorph:Dt&&N.morphTexture!==null,outputColorSpace:Et===null?i.outputColorSpace:Et.isXRRenderTarget===!0?Et.texture.colorSpace:Gt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Rt,matcap:Zt,envMap:Kt,envMapMode:Kt&&V.mapping,envMapPMREM:zt,envMapMaxLod:zt?Tt.length-1:null,envMapSize:zt?Tt[0].width:null,aoMap:be,lightMap:de,bumpMap:Fe,normalMap:re,displacementMap:un,emissiveMap:xe,normalMapObjectSpace:re&&x.normalMapType===$c,normalMapTangentSpace:re&&x.normalMapType===Ba,packedNormalMap:re&&x.normalMapType===Ba&&wg(x.normalMap.format),metalnessMap:qe,roughnessMap:Ye,anisotropy:Ze,anisotropyMap:_t,clearcoat:L,clearcoatMap:T,clearcoatNormalMap:v,clearcoatRoughnessMap:O,diffuseRoughness:Je,diffuseRoughnessMap:tt,dispersion:ne,retroreflection:ie,iridescence:ut,iridescenceMap:j,iridescenceThicknessMap:st,sheen:fe,sheenColorMap:ct,sheenRoughnessMap:Y,specularMap:Z,specularColorMap:at,specularIntensityMap:R,transmission:At,transmissionMap:K,thicknessMap:W,gradientMap:ot,opaque:x.transparent===!1&&x.blending===Gi&&x.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:wt,combine:x.combine,mapUv:Rt&&m(x.map.channel),aoMapUv:be&&m(x.aoMap.channel),lightMapUv:de&&m(x.lightMap.channel),bumpMapUv:Fe&&m(x.bumpMap.channel),normalMapUv:re&&m(x.normalMap.channel),displacementMapUv:un&&m(x.displacementMap.channel),emissiveMapUv:xe&&m(x.emissiveMap.channel),metalnessMapUv:qe&&m(x.metalnessMap.channel),roughnessMapUv:Ye&&m(x.roughnessMap.channel),anisotropyMapUv:_t&&m(x.anisotropyMap.channel),clearcoatMapUv:T&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:j&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:st&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:Y&&m(x.sheenRoughnessMap.channel),specularMapUv:Z&&m(x.specularMap.channel),specularColorMapUv:at&&m(x.specularColorMap.channel),specularIntensityMapUv:R&&m(x.specularIntensityMap.channel),transmissionMapUv:K&&m(x.transmissionMap.channel),thicknessMapUv:W&&m(x.thicknessMap.channel),alphaMapUv:it&&m(x.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(re||Ze),vertexNormals:!!P.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!P.attributes.uv&&(Rt||it),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||P.attributes.normal===void 0&&re===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:mt,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:Mt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(dt=>dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&D.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Rt&&x.map.isVideoTexture===!0&&Gt.getTransfer(x.map.colorSpace)===Yt,decodeVideoTextureEmissive:xe&&x.emissiveMap.isVideoTexture===!0&&Gt.getTransfer(x.emissiveMap.colorSpace)===Yt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===xn,flipSided:x.side===De,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ot&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ot&&x.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Ft.vertexUv1s=c.has(1),Ft.vertexUv2s=c.has(2),Ft.vertexUv3s=c.has(3),c.clear(),Ft}function S(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let D in x.defines)b.push(D),b.push(x.defines[D]);return x.isRawShaderMaterial===!1&&(p(b,x),u(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function p(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function u(x,b){a.disableAll(),b.instancing&&a.enable(0),b.instancingColor&&a.enable(1),b.instancingMorph&&a.enable(2),b.matcap&&a.enable(3),b.envMap&&a.enable(4),b.normalMapObjectSpace&&a.enable(5),b.normalMapTangentSpace&&a.enable(6),b.clearcoat&&a.enable(7),b.iridescence&&a.enable(8),b.alphaTest&&a.enable(9),b.vertexColors&&a.enable(10),b.vertexAlphas&&a.enable(11),b.vertexUv1s&&a.enable(12),b.vertexUv2s&&a.enable(13),b.vertexUv3s&&a.enable(14),b.vertexTangents&&a.enable(15),b.anisotropy&&a.enable(16),b.alphaHash&&a.enable(17),b.batching&&a.enable(18),b.dispersion&&a.enable(19),b.retroreflection&&a.enable(24),b.diffuseRoughness&&a.enable(25),b.batchingColor&&a.enable(20),b.gradientMap&&a.enable(21),b.packedNormalMap&&a.enable(22),b.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),b.numLightProbeGrids>0&&a.enable(22),b.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function M(x){let b=d[x.type],D;if(b){let _=Sn[b];D=fh.clone(_.uniforms)}else D=x.uniforms;return D}function A(x,b){let D=h.get(b);return D!==void 0?++D.usedTimes:(D=new Mg(i,b,x,s),l.push(D),h.set(b,D)),D}function w(x){if(--x.usedTimes===0){let b=l.indexOf(x);l[b]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){o.remove(x)}function E(){o.dispose()}return{getParameters:g,getProgramCacheKey:S,getUniforms:M,acquireProgram:A,releaseProgram:w,releaseShaderCache:C,programs:l,dispose:E}}function Eg(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,c){i.get(a)[o]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Ag(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Nh(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Dh(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function o(d,m,g,S,p,u){let M=i[t];return M===void 0?(M={id:d.id,object:d,geometry:m,material:g,materialVariant:a(d),groupOrder:S,renderOrder:d.renderOrder,z:p,group:u},i[t]=M):(M.id=d.id,M.object=d,M.geometry=m,M.material=g,M.materialVariant=a(d),M.groupOrder=S,M.renderOrder=d.renderOrder,M.z=p,M.group=u),t++,M}function c(d,m,g,S,p,u,M){M.reversedDepth===!0&&(p=-p);let A=o(d,m,g,S,p,u);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):e.push(A)}function l(d,m,g,S,p,u){let M=o(d,m,g,S,p,u);g.transmission>0?n.unshift(M):g.transparent===!0?s.unshift(M):e.unshift(M)}function h(d,m){e.length>1&&e.sort(d||Ag),n.length>1&&n.sort(m||Nh),s.length>1&&s.sort(m||Nh)}function f(){for(let d=t,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:f,sort:h}}function Cg(){let i=new WeakMap;function t(n,s){let r=i.get(n),a;return r===void 0?(a=new Dh,i.set(n,[a])):s>=r.length?(a=new Dh,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function Rg(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new U,color:new Ut};break;case"SpotLight":e={position:new U,direction:new U,color:new Ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new U,color:new Ut,distance:0,decay:0};break;case"HemisphereLight":e={direction:new U,skyColor:new Ut,groundColor:new Ut};break;case"RectAreaLight":e={color:new Ut,position:new U,halfWidth:new U,halfHeight:new U};break}return i[t.id]=e,e}}}function Pg(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ht,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Ig=0;function _g(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Lg(i){let t=new Rg,e=Pg(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new U);let s=new U,r=new Qt,a=new Qt;function o(l){let h=0,f=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let m=0,g=0,S=0,p=0,u=0,M=0,A=0,w=0,C=0,E=0,x=0,b=0,D=0,_=0;l.sort(_g);for(let B=0,H=l.length;B<H;B++){let P=l[B],G=P.color,q=P.intensity,V=P.distance,et=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===$n?et=P.shadow.map.texture:et=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=G.r*q,f+=G.g*q,d+=G.b*q;else if(P.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(P.sh.coefficients[X],q);_++}else if(P.isSunLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,$=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=$,n.sunShadowMap[g]=et;let Mt=Q.getViewportCount();for(let Lt=0;Lt<Mt;Lt++)n.sunShadowMatrix[S+Lt]=Q.getMatrix(Lt),n.sunShadowCascade[S+Lt]=Q._cascadeData[Lt];S+=Mt,g++}n.sun[m]=X,m++}else if(P.isDirectionalLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,$=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.directionalShadow[p]=$,n.directionalShadowMap[p]=et,n.directionalShadowMatrix[p]=P.shadow.matrix,C++}n.directional[p]=X,p++}else if(P.isSpotLight){let X=t.get(P);X.position.setFromMatrixPosition(P.matrixWorld),X.color.copy(G).multiplyScalar(q),X.distance=V,X.coneCos=Math.cos(P.angle),X.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),X.decay=P.decay,n.spot[M]=X;let Q=P.shadow;if(P.map&&(n.spotLightMap[b]=P.map,b++,Q.updateMatrices(P),P.castShadow&&D++),n.spotLightMatrix[M]=Q.matrix,P.castShadow){let $=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.spotShadow[M]=$,n.spotShadowMap[M]=et,x++}M++}else if(P.isRectAreaLight){let X=t.get(P);X.color.copy(G).multiplyScalar(q),X.halfWidth.set(P.width*.5,0,0),X.halfHeight.set(0,P.height*.5,0),n.rectArea[A]=X,A++}else if(P.isPointLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),X.distance=P.distance,X.decay=P.decay,P.castShadow){let Q=P.shadow,$=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,$.shadowCameraNear=Q.camera.near,$.shadowCameraFar=Q.camera.far,n.pointShadow[u]=$,n.pointShadowMap[u]=et,n.pointShadowMatrix[u]=P.shadow.matrix,E++}n.point[u]=X,u++}else if(P.isHemisphereLight){let X=t.get(P);X.skyColor.copy(P.color).multiplyScalar(q),X.groundColor.copy(P.groundColor).multiplyScalar(q),n.hemi[w]=X,w++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=d;let N=n.hash;(N.sunLength!==m||N.directionalLength!==p||N.pointLength!==u||N.spotLength!==M||N.rectAreaLength!==A||N.hemiLength!==w||N.numSunShadows!==g||N.numDirectionalShadows!==C||N.numPointShadows!==E||N.numSpotShadows!==x||N.numSpotMaps!==b||N.numLightProbes!==_)&&(n.sun.length=m,n.directional.length=p,n.spot.length=M,n.rectArea.length=A,n.point.length=u,n.hemi.length=w,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-D,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=_,N.sunLength=m,N.directionalLength=p,N.pointLength=u,N.spotLength=M,N.rectAreaLength=A,N.hemiLength=w,N.numSunShadows=g,N.numDirectionalShadows=C,N.numPointShadows=E,N.numSpotShadows=x,N.numSpotMaps=b,N.numLightProbes=_,n.version=Ig++)}function c(l,h){let f=0,d=0,m=0,g=0,S=0,p=0,u=h.matrixWorldInverse;for(let M=0,A=l.length;M<A;M++){let w=l[M];if(w.isSunLight){let C=n.sun[f];C.direction.setFromMatrixPosition(w.matrixWorld),C.direction.transformDirection(u),f++}else if(w.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(u),d++}else if(w.isSpotLight){let C=n.spot[g];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(u),C.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(u),g++}else if(w.isRectAreaLight){let C=n.rectArea[S];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(u),a.identity(),r.copy(w.matrixWorld),r.premultiply(u),a.extractRotation(r),C.halfWidth.set(w.width*.5,0,0),C.halfHeight.set(0,w.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),S++}else if(w.isPointLight){let C=n.point[m];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(u),m++}else if(w.isHemisphereLight){let C=n.hemi[p];C.direction.setFromMatrixPosition(w.matrixWorld),C.direction.transformDirection(u),p++}}}return{setup:o,setupView:c,state:n}}function Uh(i){let t=new Lg(i),e=[],n=[],s=[];function r(f){h.camera=f,e.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):e.push(f)}function o(f){n.push(f)}function c(){t.setup(e),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function l(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:a,pushShadow:o}}function Ng(i){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new Uh(i),t.set(s,[o])):r>=a.length?(o=new Uh(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}var Dg=`void main() {
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
}`,Fg=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],Og=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],Fh=new Qt,Us=new U,xl=new U;function Bg(i,t,e){let n=new Yn,s=new Ht,r=new Ht,a=new se,o=new Br,c=new zr,l={},h=e.maxTextureSize,f={[Qn]:De,[De]:Qn,[xn]:xn},d=new gn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ht},radius:{value:4}},vertexShader:Dg,fragmentShader:Ug}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new Pe;g.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let S=new pe(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=As;let u=this.type;this.render=function(E,x,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===Ic&&(Ct("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=As);let D=i.getRenderTarget(),_=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ui),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let H=u!==this.type;H&&x.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(G=>G.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,G=E.length;P<G;P++){let q=E[P],V=q.shadow;if(V===void 0){Ct("WebGLShadowMap:",q,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let et=V.getFrameExtents();s.multiply(et),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,V.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||H===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Vi){if(q.isPointLight){Ct("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new He(s.x,s.y,{format:$n,type:ln,minFilter:Ne,magFilter:Ne,generateMipmaps:!1}),V.map.texture.name=q.name+".shadowMap",V.map.depthTexture=new Ln(s.x,s.y,on),V.map.depthTexture.name=q.name+".shadowMapDepth",V.map.depthTexture.format=Pn,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Me,V.map.depthTexture.magFilter=Me}else q.isPointLight?(V.map=new Os(s.x),V.map.depthTexture=new fs(s.x,an)):(V.map=new He(s.x,s.y),V.map.depthTexture=new Ln(s.x,s.y,an)),V.map.depthTexture.name=q.name+".shadowMap",V.map.depthTexture.format=Pn,this.type===As?(V.map.depthTexture.compareFunction=X?ol:al,V.map.depthTexture.minFilter=Ne,V.map.depthTexture.magFilter=Ne):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Me,V.map.depthTexture.magFilter=Me);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();q.isPointLight!==!0&&V.updateMatrices(q,b);let $=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let Mt=0;Mt<Q;Mt++){let Lt=V.getCamera(Mt);if(q.isPointLight){let J=V.camera,pt=V.matrix,vt=q.distance||J.far;vt!==J.far&&(J.far=vt,J.updateProjectionMatrix()),Us.setFromMatrixPosition(q.matrixWorld),J.position.copy(Us),xl.copy(J.position),xl.add(Fg[Mt]),J.up.copy(Og[Mt]),J.lookAt(xl),J.updateMatrixWorld(),pt.makeTranslation(-Us.x,-Us.y,-Us.z),Fh.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Fh,J.coordinateSystem,J.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,Mt),i.clear();else{Mt===0&&(i.setRenderTarget(V.map),i.clear());let J=V.getViewport(Mt);a.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),B.viewport(a)}n=V.getFrustum(Mt),w(x,b,Lt,q,$,this.type)}V.isPointLightShadow!==!0&&this.type===Vi&&M(V,b),V.needsUpdate=!1}u=this.type,p.needsUpdate=!1,i.setRenderTarget(D,_,N)};function M(E,x){let b=t.update(S);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null?E.mapPass=new He(s.x,s.y,{format:$n,type:ln}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,d,S,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value.set(E.map.width,E.map.height),m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,m,S,null)}function A(E,x,b,D){let _=null,N=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(N!==void 0)_=N;else if(_=b.isPointLight===!0?c:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=_.uuid,H=x.uuid,P=l[B];P===void 0&&(P={},l[B]=P);let G=P[H];G===void 0&&(G=_.clone(),P[H]=G,x.addEventListener("dispose",C)),_=G}if(_.visible=x.visible,_.wireframe=x.wireframe,D===Vi?_.side=x.shadowSide!==null?x.shadowSide:x.side:_.side=x.shadowSide!==null?x.shadowSide:f[x.side],_.alphaMap=x.alphaMap,_.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,_.map=x.map,_.clipShadows=x.clipShadows,_.clippingPlanes=x.clippingPlanes,_.clipIntersection=x.clipIntersection,_.displacementMap=x.displacementMap,_.displacementScale=x.displacementScale,_.displacementBias=x.displacementBias,_.wireframeLinewidth=x.wireframeLinewidth,_.linewidth=x.linewidth,b.isPointLight===!0&&_.isMeshDistanceMaterial===!0){let B=i.properties.get(_);B.light=b}return _}function w(E,x,b,D,_,N){if(E.visible===!1)return;if(E.layers.test(_)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&N===Vi)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let P=t.update(E),G=E.material;if(Array.isArray(G)){let q=P.groups;for(let V=0,et=q.length;V<et;V++){let X=q[V],Q=G[X.materialIndex];if(Q&&Q.visible){let $=A(E,Q,D,N);E.onBeforeShadow(i,E,x,b,P,$,X),i.renderBufferDirect(b,null,P,$,E,X),E.onAfterShadow(i,E,x,b,P,$,X)}}}else if(G.visible){let q=A(E,G,D,N);E.onBeforeShadow(i,E,x,b,P,q,null),i.renderBufferDirect(b,null,P,q,E,null),E.onAfterShadow(i,E,x,b,P,q,null)}}let H=E.children;for(let P=0,G=H.length;P<G;P++)w(H[P],x,b,D,_,N)}function C(E){E.target.removeEventListener("dispose",C);for(let b in l){let D=l[b],_=E.target.uuid;_ in D&&(D[_].dispose(),delete D[_])}}}function zg(i,t){function e(){let R=!1,K=new se,W=null,ot=new se(0,0,0,0);return{setMask:function(it){W!==it&&!R&&(i.colorMask(it,it,it,it),W=it)},setLocked:function(it){R=it},setClear:function(it,rt,wt,Ot,nt){nt===!0&&(it*=Ot,rt*=Ot,wt*=Ot),K.set(it,rt,wt,Ot),ot.equals(K)===!1&&(i.clearColor(it,rt,wt,Ot),ot.copy(K))},reset:function(){R=!1,W=null,ot.set(-1,0,0,0)}}}function n(){let R=!1,K=!1,W=null,ot=null,it=null;return{setReversed:function(rt){if(K!==rt){let wt=t.get("EXT_clip_control");rt?wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.ZERO_TO_ONE_EXT):wt.clipControlEXT(wt.LOWER_LEFT_EXT,wt.NEGATIVE_ONE_TO_ONE_EXT),K=rt;let Ot=it;it=null,this.setClear(Ot)}},getReversed:function(){return K},setTest:function(rt){rt?mt(i.DEPTH_TEST):Dt(i.DEPTH_TEST)},setMask:function(rt){W!==rt&&!R&&(i.depthMask(rt),W=rt)},setFunc:function(rt){if(K&&(rt=hh[rt]),ot!==rt){switch(rt){case yr:i.depthFunc(i.NEVER);break;case Sr:i.depthFunc(i.ALWAYS);break;case Mr:i.depthFunc(i.LESS);break;case _i:i.depthFunc(i.LEQUAL);break;case br:i.depthFunc(i.EQUAL);break;case wr:i.depthFunc(i.GEQUAL);break;case Tr:i.depthFunc(i.GREATER);break;case Er:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ot=rt}},setLocked:function(rt){R=rt},setClear:function(rt){it!==rt&&(it=rt,K&&(rt=1-rt),i.clearDepth(rt))},reset:function(){R=!1,W=null,ot=null,it=null,K=!1}}}function s(){let R=!1,K=null,W=null,ot=null,it=null,rt=null,wt=null,Ot=null,nt=null;return{setTest:function(Tt){R||(Tt?mt(i.STENCIL_TEST):Dt(i.STENCIL_TEST))},setMask:function(Tt){K!==Tt&&!R&&(i.stencilMask(Tt),K=Tt)},setFunc:function(Tt,Ft,dt){(W!==Tt||ot!==Ft||it!==dt)&&(i.stencilFunc(Tt,Ft,dt),W=Tt,ot=Ft,it=dt)},setOp:function(Tt,Ft,dt){(rt!==Tt||wt!==Ft||Ot!==dt)&&(i.stencilOp(Tt,Ft,dt),rt=Tt,wt=Ft,Ot=dt)},setLocked:function(Tt){R=Tt},setClear:function(Tt){nt!==Tt&&(i.clearStencil(Tt),nt=Tt)},reset:function(){R=!1,K=null,W=null,ot=null,it=null,rt=null,wt=null,Ot=null,nt=null}}}let r=new e,a=new n,o=new s,c={},l=new WeakMap,h={},f={},d={},m=new WeakMap,g=[],S=null,p=!1,u=null,M=null,A=null,w=null,C=null,E=null,x=null,b=new Ut(0,0,0),D=0,_=!1,N=null,B=null,H=null,P=null,G=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,et=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=et>=1):X.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=et>=2);let Q=null,$={},Mt=i.getParameter(i.SCISSOR_BOX),Lt=i.getParameter(i.VIEWPORT),J=new se().fromArray(Mt),pt=new se().fromArray(Lt);function vt(R,K,W,ot){let it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(R,rt),i.texParameteri(R,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(R,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let wt=0;wt<W;wt++)R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,ot,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+wt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}let Et={};Et[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Et[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Et[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Et[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),mt(i.DEPTH_TEST),a.setFunc(_i),Fe(!1),re(zo),mt(i.CULL_FACE),be(ui);function mt(R){h[R]!==!0&&(i.enable(R),h[R]=!0)}function Dt(R){h[R]!==!1&&(i.disable(R),h[R]=!1)}function le(R,K){return d[R]!==K?(i.bindFramebuffer(R,K),d[R]=K,R===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),R===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Rt(R,K){let W=g,ot=!1;if(R){W=m.get(K),W===void 0&&(W=[],m.set(K,W));let it=R.textures;if(W.length!==it.length||W[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,wt=it.length;rt<wt;rt++)W[rt]=i.COLOR_ATTACHMENT0+rt;W.length=it.length,ot=!0}}else W[0]!==i.BACK&&(W[0]=i.BACK,ot=!0);ot&&i.drawBuffers(W)}function Zt(R){return S!==R?(i.useProgram(R),S=R,!0):!1}let Kt={[di]:i.FUNC_ADD,[Lc]:i.FUNC_SUBTRACT,[Nc]:i.FUNC_REVERSE_SUBTRACT};Kt[Dc]=i.MIN,Kt[Uc]=i.MAX;let zt={[Fc]:i.ZERO,[Oc]:i.ONE,[Bc]:i.SRC_COLOR,[Ho]:i.SRC_ALPHA,[Wc]:i.SRC_ALPHA_SATURATE,[Gc]:i.DST_COLOR,[kc]:i.DST_ALPHA,[zc]:i.ONE_MINUS_SRC_COLOR,[Wo]:i.ONE_MINUS_SRC_ALPHA,[Hc]:i.ONE_MINUS_DST_COLOR,[Vc]:i.ONE_MINUS_DST_ALPHA,[Xc]:i.CONSTANT_COLOR,[qc]:i.ONE_MINUS_CONSTANT_COLOR,[Yc]:i.CONSTANT_ALPHA,[Zc]:i.ONE_MINUS_CONSTANT_ALPHA};function be(R,K,W,ot,it,rt,wt,Ot,nt,Tt){if(R===ui){p===!0&&(Dt(i.BLEND),p=!1);return}if(p===!1&&(mt(i.BLEND),p=!0),R!==_c){if(R!==u||Tt!==_){if((M!==di||C!==di)&&(i.blendEquation(i.FUNC_ADD),M=di,C=di),Tt)switch(R){case Gi:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFunc(i.ONE,i.ONE);break;case Vo:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Go:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Pt("WebGLState: Invalid blending: ",R);break}else switch(R){case Gi:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Vo:Pt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Go:Pt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Pt("WebGLState: Invalid blending: ",R);break}A=null,w=null,E=null,x=null,b.set(0,0,0),D=0,u=R,_=Tt}return}it=it||K,rt=rt||W,wt=wt||ot,(K!==M||it!==C)&&(i.blendEquationSeparate(Kt[K],Kt[it]),M=K,C=it),(W!==A||ot!==w||rt!==E||wt!==x)&&(i.blendFuncSeparate(zt[W],zt[ot],zt[rt],zt[wt]),A=W,w=ot,E=rt,x=wt),(Ot.equals(b)===!1||nt!==D)&&(i.blendColor(Ot.r,Ot.g,Ot.b,nt),b.copy(Ot),D=nt),u=R,_=!1}function de(R,K){R.side===xn?Dt(i.CULL_FACE):mt(i.CULL_FACE);let W=R.side===De;K&&(W=!W),Fe(W),R.blending===Gi&&R.transparent===!1?be(ui):be(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),a.setFunc(R.depthFunc),a.setTest(R.depthTest),a.setMask(R.depthWrite),r.setMask(R.colorWrite);let ot=R.stencilWrite;o.setTest(ot),ot&&(o.setMask(R.stencilWriteMask),o.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),o.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),xe(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?mt(i.SAMPLE_ALPHA_TO_COVERAGE):Dt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Fe(R){N!==R&&(R?i.frontFace(i.CW):i.frontFace(i.CCW),N=R)}function re(R){R!==Rc?(mt(i.CULL_FACE),R!==B&&(R===zo?i.cullFace(i.BACK):R===Pc?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Dt(i.CULL_FACE),B=R}function un(R){R!==H&&(V&&i.lineWidth(R),H=R)}function xe(R,K,W){R?(mt(i.POLYGON_OFFSET_FILL),(P!==K||G!==W)&&(P=K,G=W,a.getReversed()&&(K=-K,W=-W),i.polygonOffset(K,W))):Dt(i.POLYGON_OFFSET_FILL)}function qe(R){R?mt(i.SCISSOR_TEST):Dt(i.SCISSOR_TEST)}function Ye(R){R===void 0&&(R=i.TEXTURE0+q-1),Q!==R&&(i.activeTexture(R),Q=R)}function Ze(R,K,W){W===void 0&&(Q===null?W=i.TEXTURE0+q-1:W=Q);let ot=$[W];ot===void 0&&(ot={type:void 0,texture:void 0},$[W]=ot),(ot.type!==R||ot.texture!==K)&&(Q!==W&&(i.activeTexture(W),Q=W),i.bindTexture(R,K||Et[R]),ot.type=R,ot.texture=K)}function L(){let R=$[Q];R!==void 0&&R.type!==void 0&&(i.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function Je(){try{i.compressedTexImage2D(...arguments)}catch(R){Pt("WebGLState:",R)}}function ne(){try{i.compressedTexImage3D(...arguments)}catch(R){Pt("WebGLState:",R)}}function ie(){try{i.texSubImage2D(...arguments)}catch(R){Pt("WebGLState:",R)}}function ut(){try{i.texSubImage3D(...arguments)}catch(R){Pt("WebGLState:",R)}}function fe(){try{i.compressedTexSubImage2D(...arguments)}catch(R){Pt("WebGLState:",R)}}function At(){try{i.compressedTexSubImage3D(...arguments)}catch(R){Pt("WebGLState:",R)}}function _t(){try{i.texStorage2D(...arguments)}catch(R){Pt("WebGLState:",R)}}function T(){try{i.texStorage3D(...arguments)}catch(R){Pt("WebGLState:",R)}}function v(){try{i.texImage2D(...arguments)}catch(R){Pt("WebGLState:",R)}}function O(){try{i.texImage3D(...arguments)}catch(R){Pt("WebGLState:",R)}}function tt(R){return f[R]!==void 0?f[R]:i.getParameter(R)}function j(R,K){f[R]!==K&&(i.pixelStorei(R,K),f[R]=K)}function st(R){J.equals(R)===!1&&(i.scissor(R.x,R.y,R.z,R.w),J.copy(R))}function ct(R){pt.equals(R)===!1&&(i.viewport(R.x,R.y,R.z,R.w),pt.copy(R))}function Y(R,K){let W=l.get(K);W===void 0&&(W=new WeakMap,l.set(K,W));let ot=W.get(R);ot===void 0&&(ot=i.getUniformBlockIndex(K,R.name),i.uniformBlockBinding(K,ot,ot),W.set(R,ot))}function Z(R,K,W){let it=l.get(K).get(R);c[it]!==W&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,W),c[it]=W)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,$={},d={},c={},m=new WeakMap,g=[],S=null,p=!1,u=null,M=null,A=null,w=null,C=null,E=null,x=null,b=new Ut(0,0,0),D=0,_=!1,N=null,B=null,H=null,P=null,G=null,J.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:mt,disable:Dt,bindFramebuffer:le,drawBuffers:Rt,useProgram:Zt,setBlending:be,setMaterial:de,setFlipSided:Fe,setCullFace:re,setLineWidth:un,setPolygonOffset:xe,setScissorTest:qe,activeTexture:Ye,bindTexture:Ze,unbindTexture:L,compressedTexImage2D:Je,compressedTexImage3D:ne,texImage2D:v,texImage3D:O,pixelStorei:j,getParameter:tt,updateUBOMapping:Y,uniformBlockBinding:Z,texStorage2D:_t,texStorage3D:T,texSubImage2D:ie,texSubImage3D:ut,compressedTexSubImage2D:fe,compressedTexSubImage3D:At,scissor:st,viewport:ct,reset:at}}function kg(i,t,e,n,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Ht,h=new WeakMap,f=new Set,d,m=new WeakMap,g=new Set,S=new FinalizationRegistry(T=>g.delete(T)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function u(T,v){return p?new OffscreenCanvas(T,v):rs("canvas")}function M(T,v,O){let tt=1,j=_t(T);if((j.width>O||j.height>O)&&(tt=O/Math.max(j.width,j.height)),tt<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let st=Math.floor(tt*j.width),ct=Math.floor(tt*j.height);d===void 0&&(d=u(st,ct));let Y=v?u(st,ct):d;return Y.width=st,Y.height=ct,Y.getContext("2d").drawImage(T,0,0,st,ct),Ct("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+st+"x"+ct+")."),Y}else return"data"in T&&Ct("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),T;return T}function A(T){return T.generateMipmaps}function w(T){i.generateMipmap(T)}function C(T){return T.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?i.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(T,v,O,tt,j,st=!1){if(T!==null){if(i[T]!==void 0)return i[T];Ct("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||Ct("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=v;if(v===i.RED&&(O===i.FLOAT&&(Y=i.R32F),O===i.HALF_FLOAT&&(Y=i.R16F),O===i.UNSIGNED_BYTE&&(Y=i.R8),O===i.UNSIGNED_SHORT&&ct&&(Y=ct.R16_EXT),O===i.SHORT&&ct&&(Y=ct.R16_SNORM_EXT)),v===i.RED_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.R8UI),O===i.UNSIGNED_SHORT&&(Y=i.R16UI),O===i.UNSIGNED_INT&&(Y=i.R32UI),O===i.BYTE&&(Y=i.R8I),O===i.SHORT&&(Y=i.R16I),O===i.INT&&(Y=i.R32I)),v===i.RG&&(O===i.FLOAT&&(Y=i.RG32F),O===i.HALF_FLOAT&&(Y=i.RG16F),O===i.UNSIGNED_BYTE&&(Y=i.RG8),O===i.UNSIGNED_SHORT&&ct&&(Y=ct.RG16_EXT),O===i.SHORT&&ct&&(Y=ct.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.RG8UI),O===i.UNSIGNED_SHORT&&(Y=i.RG16UI),O===i.UNSIGNED_INT&&(Y=i.RG32UI),O===i.BYTE&&(Y=i.RG8I),O===i.SHORT&&(Y=i.RG16I),O===i.INT&&(Y=i.RG32I)),v===i.RGB_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.RGB8UI),O===i.UNSIGNED_SHORT&&(Y=i.RGB16UI),O===i.UNSIGNED_INT&&(Y=i.RGB32UI),O===i.BYTE&&(Y=i.RGB8I),O===i.SHORT&&(Y=i.RGB16I),O===i.INT&&(Y=i.RGB32I)),v===i.RGBA_INTEGER&&(O===i.UNSIGNED_BYTE&&(Y=i.RGBA8UI),O===i.UNSIGNED_SHORT&&(Y=i.RGBA16UI),O===i.UNSIGNED_INT&&(Y=i.RGBA32UI),O===i.BYTE&&(Y=i.RGBA8I),O===i.SHORT&&(Y=i.RGBA16I),O===i.INT&&(Y=i.RGBA32I)),v===i.RGB&&(O===i.UNSIGNED_SHORT&&ct&&(Y=ct.RGB16_EXT),O===i.SHORT&&ct&&(Y=ct.RGB16_SNORM_EXT),O===i.UNSIGNED_INT_5_9_9_9_REV&&(Y=i.RGB9_E5),O===i.UNSIGNED_INT_10F_11F_11F_REV&&(Y=i.R11F_G11F_B10F)),v===i.RGBA){let Z=st?ss:Gt.getTransfer(j);O===i.FLOAT&&(Y=i.RGBA32F),O===i.HALF_FLOAT&&(Y=i.RGBA16F),O===i.UNSIGNED_BYTE&&(Y=Z===Yt?i.SRGB8_ALPHA8:i.RGBA8),O===i.UNSIGNED_SHORT&&ct&&(Y=ct.RGBA16_EXT),O===i.SHORT&&ct&&(Y=ct.RGBA16_SNORM_EXT),O===i.UNSIGNED_SHORT_4_4_4_4&&(Y=i.RGBA4),O===i.UNSIGNED_SHORT_5_5_5_1&&(Y=i.RGB5_A1)}return(Y===i.R16F||Y===i.R32F||Y===i.RG16F||Y===i.RG32F||Y===i.RGBA16F||Y===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function x(T,v){let O;return T?v===null||v===an||v===pi?O=i.DEPTH24_STENCIL8:v===on?O=i.DEPTH32F_STENCIL8:v===Wi&&(O=i.DEPTH24_STENCIL8,Ct("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===an||v===pi?O=i.DEPTH_COMPONENT24:v===on?O=i.DEPTH_COMPONENT32F:v===Wi&&(O=i.DEPTH_COMPONENT16),O}function b(T,v){return A(T)===!0||T.isFramebufferTexture&&T.minFilter!==Me&&T.minFilter!==Ne?Math.log2(Math.max(v.width,v.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?v.mipmaps.length:1}function D(T){let v=new WeakRef(T);n.get(T).__ref=v,g.add(v),S.register(T,v,v)}function _(T){let v=n.get(T).__ref;v!==void 0&&(g.delete(v),S.unregister(v))}function N(T){H(T.target)}function B(T){P(T.target)}function H(T){T.removeEventListener("dispose",N),_(T),q(T),T.isVideoTexture&&h.delete(T),T.isHTMLTexture&&f.delete(T)}function P(T){T.removeEventListener("dispose",B),_(T),et(T)}function G(){for(let T of g){let v=T.deref();v!==void 0&&(v.isRenderTarget===!0?P(v):H(v))}g.clear(),f.clear()}function q(T){let v=n.get(T);if(v.__webglInit===void 0)return;let O=T.source,tt=m.get(O);if(tt){let j=tt[v.__cacheKey];j.usedTimes--,j.usedTimes===0&&V(T),Object.keys(tt).length===0&&m.delete(O)}n.remove(T)}function V(T){let v=n.get(T);i.deleteTexture(v.__webglTexture);let O=T.source,tt=m.get(O);delete tt[v.__cacheKey],a.memory.textures--}function et(T){let v=n.get(T);v.__depthDisposeCallback&&v.__depthDisposeCallback();let O=T.depthTexture;if(O&&O.renderTarget===T&&H(O),T.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(v.__webglFramebuffer[j]))for(let st=0;st<v.__webglFramebuffer[j].length;st++)i.deleteFramebuffer(v.__webglFramebuffer[j][st]);else i.deleteFramebuffer(v.__webglFramebuffer[j]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[j])}else{if(Array.isArray(v.__webglFramebuffer))for(let j=0;j<v.__webglFramebuffer.length;j++)i.deleteFramebuffer(v.__webglFramebuffer[j]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let j=0;j<v.__webglColorRenderbuffer.length;j++)v.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[j]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let tt=T.textures;for(let j=0,st=tt.length;j<st;j++){let ct=n.get(tt[j]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),a.memory.textures--),n.remove(tt[j])}n.remove(T)}let X=0;function Q(){X=0}function $(){return X}function Mt(T){X=T}function Lt(){let T=X;return T>=s.maxTextures&&Ct("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,T}function J(T){let v=[];return v.push(T.wrapS),v.push(T.wrapT),v.push(T.wrapR||0),v.push(T.magFilter),v.push(T.minFilter),v.push(T.anisotropy),v.push(T.internalFormat),v.push(T.format),v.push(T.type),v.push(T.generateMipmaps),v.push(T.mipmapsAutoUpdate),v.push(T.premultiplyAlpha),v.push(T.flipY),v.push(T.unpackAlignment),v.push(T.colorSpace),v.join()}function pt(T,v){let O=n.get(T);if(T.isVideoTexture&&fe(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&O.__version!==T.version){let tt=T.image;if(tt===null)Ct("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)Ct("WebGLRenderer: Texture marked for update but image is incomplete");else{de(O,T,v);return}}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,O.__webglTexture,i.TEXTURE0+v)}function vt(T,v){let O=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){de(O,T,v);return}else T.isExternalTexture&&(O.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,O.__webglTexture,i.TEXTURE0+v)}function Et(T,v){let O=n.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&O.__version!==T.version){de(O,T,v);return}e.bindTexture(i.TEXTURE_3D,O.__webglTexture,i.TEXTURE0+v)}function mt(T,v){let O=n.get(T);if(T.version>0&&O.__version!==T.version){Fe(O,T,v);return}e.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+v)}let Dt={[Ar]:i.REPEAT,[fn]:i.CLAMP_TO_EDGE,[Cr]:i.MIRRORED_REPEAT},le={[Me]:i.NEAREST,[jc]:i.NEAREST_MIPMAP_NEAREST,[Cs]:i.NEAREST_MIPMAP_LINEAR,[Ne]:i.LINEAR,[ea]:i.LINEAR_MIPMAP_NEAREST,[Dn]:i.LINEAR_MIPMAP_LINEAR},Rt={[eh]:i.NEVER,[ll]:i.ALWAYS,[nh]:i.LESS,[al]:i.LEQUAL,[ih]:i.EQUAL,[ol]:i.GEQUAL,[sh]:i.GREATER,[rh]:i.NOTEQUAL};function Zt(T,v){if(v.type===on&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===Ne||v.magFilter===ea||v.magFilter===Cs||v.magFilter===Dn||v.minFilter===Ne||v.minFilter===ea||v.minFilter===Cs||v.minFilter===Dn)&&Ct("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(T,i.TEXTURE_WRAP_S,Dt[v.wrapS]),i.texParameteri(T,i.TEXTURE_WRAP_T,Dt[v.wrapT]),(T===i.TEXTURE_3D||T===i.TEXTURE_2D_ARRAY)&&i.texParameteri(T,i.TEXTURE_WRAP_R,Dt[v.wrapR]),i.texParameteri(T,i.TEXTURE_MAG_FILTER,le[v.magFilter]),i.texParameteri(T,i.TEXTURE_MIN_FILTER,le[v.minFilter]),v.compareFunction&&(i.texParameteri(T,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(T,i.TEXTURE_COMPARE_FUNC,Rt[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Me||v.minFilter!==Cs&&v.minFilter!==Dn||v.type===on&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");i.texParameterf(T,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function Kt(T,v){let O=!1;T.__webglInit===void 0&&(T.__webglInit=!0,v.addEventListener("dispose",N),D(v));let tt=v.source,j=m.get(tt);j===void 0&&(j={},m.set(tt,j));let st=J(v);if(st!==T.__cacheKey){j[st]===void 0&&(j[st]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,O=!0),j[st].usedTimes++;let ct=j[T.__cacheKey];ct!==void 0&&(j[T.__cacheKey].usedTimes--,ct.usedTimes===0&&V(v)),T.__cacheKey=st,T.__webglTexture=j[st].texture}return O}function zt(T,v,O){return Math.floor(Math.floor(T/O)/v)}function be(T,v,O,tt){let st=T.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,O,tt,v.data);else{st.sort((R,K)=>R.start-K.start);let ct=0;for(let R=1;R<st.length;R++){let K=st[ct],W=st[R],ot=K.start+K.count,it=zt(W.start,v.width,4),rt=zt(K.start,v.width,4);W.start<=ot+1&&it===rt&&zt(W.start+W.count-1,v.width,4)===it?K.count=Math.max(K.count,W.start+W.count-K.start):(++ct,st[ct]=W)}st.length=ct+1;let Y=e.getParameter(i.UNPACK_ROW_LENGTH),Z=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let R=0,K=st.length;R<K;R++){let W=st[R],ot=Math.floor(W.start/4),it=Math.ceil(W.count/4),rt=ot%v.width,wt=Math.floor(ot/v.width),Ot=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,wt),e.texSubImage2D(i.TEXTURE_2D,0,rt,wt,Ot,nt,O,tt,v.data)}T.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Y),e.pixelStorei(i.UNPACK_SKIP_PIXELS,Z),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function de(T,v,O){let tt=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(tt=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(tt=i.TEXTURE_3D);let j=Kt(T,v),st=v.source;e.bindTexture(tt,T.__webglTexture,i.TEXTURE0+O);let ct=n.get(st);if(st.version!==ct.__version||j===!0){if(e.activeTexture(i.TEXTURE0+O),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let nt=Gt.getPrimaries(Gt.workingColorSpace),Tt=v.colorSpace===Fn?null:Gt.getPrimaries(v.colorSpace),Ft=v.colorSpace===Fn||nt===Tt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ft)}e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let Z=M(v.image,!1,s.maxTextureSize);Z=At(v,Z);let at=r.convert(v.format,v.colorSpace),R=r.convert(v.type),K=E(v.internalFormat,at,R,v.normalized,v.colorSpace,v.isVideoTexture);Zt(tt,v);let W,ot=v.mipmaps,it=v.isVideoTexture!==!0,rt=ct.__version===void 0||j===!0,wt=st.dataReady,Ot=b(v,Z);if(v.isDepthTexture)K=x(v.format===Un,v.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,Z.width,Z.height):e.texImage2D(i.TEXTURE_2D,0,K,Z.width,Z.height,0,at,R,null));else if(v.isDataTexture)if(ot.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,R,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,R,W.data);v.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,Z.width,Z.height),wt&&be(v,Z,at,R)):e.texImage2D(i.TEXTURE_2D,0,K,Z.width,Z.height,0,at,R,Z.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,ot[0].width,ot[0].height,Z.depth);for(let nt=0,Tt=ot.length;nt<Tt;nt++)if(W=ot[nt],v.format!==cn)if(at!==null)if(it){if(wt)if(v.layerUpdates.size>0){let Ft=ml(W.width,W.height,v.format,v.type);for(let dt of v.layerUpdates){let Jt=W.data.subarray(dt*Ft/W.data.BYTES_PER_ELEMENT,(dt+1)*Ft/W.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,dt,W.width,W.height,1,at,Jt)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Z.depth,at,W.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Z.depth,0,W.data,0,0);else Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Z.depth,at,R,W.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Z.depth,0,at,R,W.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],v.format!==cn?at!==null?it?wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,W.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,W.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,R,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,R,W.data)}else if(v.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,Z.width,Z.height,Z.depth),wt)if(v.layerUpdates.size>0){let nt=ml(Z.width,Z.height,v.format,v.type);for(let Tt of v.layerUpdates){let Ft=Z.data.subarray(Tt*nt/Z.data.BYTES_PER_ELEMENT,(Tt+1)*nt/Z.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Tt,Z.width,Z.height,1,at,R,Ft)}v.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,at,R,Z.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,Z.width,Z.height,Z.depth,0,at,R,Z.data);else if(v.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Ot,K,Z.width,Z.height,Z.depth),wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,at,R,Z.data)):e.texImage3D(i.TEXTURE_3D,0,K,Z.width,Z.height,Z.depth,0,at,R,Z.data);else if(v.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Ot,K,Z.width,Z.height);else{let nt=Z.width,Tt=Z.height;for(let Ft=0;Ft<Ot;Ft++)e.texImage2D(i.TEXTURE_2D,Ft,K,nt,Tt,0,at,R,null),nt>>=1,Tt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){let nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),Z.parentNode!==nt){nt.appendChild(Z),f.add(v),nt.onpaint=Tt=>{let Ft=Tt.changedElements;for(let dt of f)Ft.includes(dt.image)&&(dt.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Z);else{let Ft=i.RGBA,dt=i.RGBA,Jt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ft,dt,Jt,Z)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ot.length>0){if(it&&rt){let nt=_t(ot[0]);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}for(let nt=0,Tt=ot.length;nt<Tt;nt++)W=ot[nt],it?wt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,at,R,W):e.texImage2D(i.TEXTURE_2D,nt,K,at,R,W);v.generateMipmaps=!1}else if(it){if(rt){let nt=_t(Z);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,R,Z)}else e.texImage2D(i.TEXTURE_2D,0,K,at,R,Z);A(v)&&v.mipmapsAutoUpdate===!0&&w(tt),ct.__version=st.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function Fe(T,v,O){if(v.image.length!==6)return;let tt=Kt(T,v),j=v.source;e.bindTexture(i.TEXTURE_CUBE_MAP,T.__webglTexture,i.TEXTURE0+O);let st=n.get(j);if(j.version!==st.__version||tt===!0){e.activeTexture(i.TEXTURE0+O);let ct=Gt.getPrimaries(Gt.workingColorSpace),Y=v.colorSpace===Fn?null:Gt.getPrimaries(v.colorSpace),Z=v.colorSpace===Fn||ct===Y?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let at=v.isCompressedTexture||v.image[0].isCompressedTexture,R=v.image[0]&&v.image[0].isDataTexture,K=[];for(let dt=0;dt<6;dt++)!at&&!R?K[dt]=M(v.image[dt],!0,s.maxCubemapSize):K[dt]=R?v.image[dt].image:v.image[dt],K[dt]=At(v,K[dt]);let W=K[0],ot=r.convert(v.format,v.colorSpace),it=r.convert(v.type),rt=E(v.internalFormat,ot,it,v.normalized,v.colorSpace),wt=v.isVideoTexture!==!0,Ot=st.__version===void 0||tt===!0,nt=j.dataReady,Tt=b(v,W);Zt(i.TEXTURE_CUBE_MAP,v);let Ft;if(v.isDepthTexture){if(rt=x(v.format===Un,v.type),Ot)if(wt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,W.width,W.height);else for(let dt=0;dt<6;dt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,W.width,W.height,0,ot,it,null)}else if(at){wt&&Ot&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,W.width,W.height);for(let dt=0;dt<6;dt++){Ft=K[dt].mipmaps;for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];v.format!==cn?ot!==null?wt?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,ve.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ve.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,it,ve.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ot,it,ve.data)}}}else{if(Ft=v.mipmaps,wt&&Ot){Ft.length>0&&Tt++;let dt=_t(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Tt,rt,dt.width,dt.height)}for(let dt=0;dt<6;dt++)if(R){wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,K[dt].width,K[dt].height,ot,it,K[dt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,K[dt].width,K[dt].height,0,ot,it,K[dt].data);for(let Jt=0;Jt<Ft.length;Jt++){let Bn=Ft[Jt].image[dt].image;wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,Bn.width,Bn.height,ot,it,Bn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,Bn.width,Bn.height,0,ot,it,Bn.data)}}else{wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,ot,it,K[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,ot,it,K[dt]);for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];wt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,ot,it,ve.image[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,ot,it,ve.image[dt])}}}A(v)&&v.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),st.__version=j.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function re(T,v,O,tt,j,st){let ct=r.convert(O.format,O.colorSpace),Y=r.convert(O.type),Z=E(O.internalFormat,ct,Y,O.normalized,O.colorSpace),at=n.get(v),R=n.get(O);if(R.__renderTarget=v,!at.__hasExternalTextures){let K=Math.max(1,v.width>>st),W=Math.max(1,v.height>>st);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,st,Z,K,W,v.depth,0,ct,Y,null):e.texImage2D(j,st,Z,K,W,0,ct,Y,null)}e.bindFramebuffer(i.FRAMEBUFFER,T),ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,tt,j,R.__webglTexture,0,ie(v)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,tt,j,R.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function un(T,v,O){if(i.bindRenderbuffer(i.RENDERBUFFER,T),v.depthBuffer){let tt=v.depthTexture,j=tt&&tt.isDepthTexture?tt.type:null,st=x(v.stencilBuffer,j),ct=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),st,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),st,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,st,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,T)}else{let tt=v.textures;for(let j=0;j<tt.length;j++){let st=tt[j],ct=r.convert(st.format,st.colorSpace),Y=r.convert(st.type),Z=E(st.internalFormat,ct,Y,st.normalized,st.colorSpace);ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),Z,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),Z,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Z,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(T,v,O){let tt=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,T),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(v.depthTexture);j.__renderTarget=v;let st=tt?v.depthTexture.image[0]:v.depthTexture.image;(!j.__webglTexture||st.width!==v.width||st.height!==v.height)&&(st.width=v.width,st.height=v.height,v.depthTexture.needsUpdate=!0),tt?mt(v.depthTexture,0):pt(v.depthTexture,0);let ct=j.__webglTexture,Y=ie(v),Z=tt?i.TEXTURE_CUBE_MAP_POSITIVE_X+O:i.TEXTURE_2D,at=v.depthTexture.format===Un?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===Pn)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Z,ct,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,at,Z,ct,0);else if(v.depthTexture.format===Un)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Z,ct,0,Y):i.framebufferTexture2D(i.FRAMEBUFFER,at,Z,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function qe(T){let v=n.get(T),O=T.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==T.depthTexture){let tt=T.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),tt){let j=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,tt.removeEventListener("dispose",j)};tt.addEventListener("dispose",j),v.__depthDisposeCallback=j}v.__boundDepthTexture=tt}if(T.depthTexture&&!v.__autoAllocateDepthBuffer)if(O)for(let tt=0;tt<6;tt++)xe(v.__webglFramebuffer[tt],T,tt);else T.texture.mipmaps.length>0?xe(v.__webglFramebuffer[0],T,0):xe(v.__webglFramebuffer,T,0);else if(O){v.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[tt]),v.__webglDepthbuffer[tt]===void 0)v.__webglDepthbuffer[tt]=i.createRenderbuffer(),un(v.__webglDepthbuffer[tt],T,!1);else{let j=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer[tt];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}}else if(T.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),un(v.__webglDepthbuffer,T,!1);else{let j=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ye(T,v,O){let tt=n.get(T);v!==void 0&&re(tt.__webglFramebuffer,T,T.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),O!==void 0&&qe(T)}function Ze(T){let v=T.texture,O=n.get(T),tt=n.get(v);T.addEventListener("dispose",B),D(T);let j=T.textures,st=T.isWebGLCubeRenderTarget===!0,ct=j.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=i.createTexture()),tt.__version=v.version,a.memory.textures++),st){O.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0){O.__webglFramebuffer[Y]=[];for(let Z=0;Z<v.mipmaps.length;Z++)O.__webglFramebuffer[Y][Z]=i.createFramebuffer()}else O.__webglFramebuffer[Y]=i.createFramebuffer()}else{if(v.mipmaps.length>0){O.__webglFramebuffer=[];for(let Y=0;Y<v.mipmaps.length;Y++)O.__webglFramebuffer[Y]=i.createFramebuffer()}else O.__webglFramebuffer=i.createFramebuffer();if(ct)for(let Y=0,Z=j.length;Y<Z;Y++){let at=n.get(j[Y]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),a.memory.textures++)}if(T.samples>0&&ut(T)===!1){O.__webglMultisampledFramebuffer=i.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let Y=0;Y<j.length;Y++){let Z=j[Y];O.__webglColorRenderbuffer[Y]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,O.__webglColorRenderbuffer[Y]);let at=r.convert(Z.format,Z.colorSpace),R=r.convert(Z.type),K=E(Z.internalFormat,at,R,Z.normalized,Z.colorSpace,T.isXRRenderTarget===!0),W=ie(T);i.renderbufferStorageMultisample(i.RENDERBUFFER,W,K,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Y,i.RENDERBUFFER,O.__webglColorRenderbuffer[Y])}i.bindRenderbuffer(i.RENDERBUFFER,null),T.depthBuffer&&(O.__webglDepthRenderbuffer=i.createRenderbuffer(),un(O.__webglDepthRenderbuffer,T,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture),Zt(i.TEXTURE_CUBE_MAP,v);for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)re(O.__webglFramebuffer[Y][Z],T,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,Z);else re(O.__webglFramebuffer[Y],T,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);A(v)?w(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let Y=0,Z=j.length;Y<Z;Y++){let at=j[Y],R=n.get(at),K=i.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(K=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,R.__webglTexture),Zt(K,at),re(O.__webglFramebuffer,T,at,i.COLOR_ATTACHMENT0+Y,K,0),A(at)&&w(K)}e.unbindTexture()}else{let Y=i.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(Y=T.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Y,tt.__webglTexture),Zt(Y,v),v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)re(O.__webglFramebuffer[Z],T,v,i.COLOR_ATTACHMENT0,Y,Z);else re(O.__webglFramebuffer,T,v,i.COLOR_ATTACHMENT0,Y,0);A(v)?w(Y):v.mipmaps.length>0&&i.texParameteri(Y,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}T.depthBuffer&&qe(T)}function L(T){let v=T.textures;for(let O=0,tt=v.length;O<tt;O++){let j=v[O];if(A(j)&&j.mipmapsAutoUpdate===!0){let st=C(T),ct=n.get(j).__webglTexture;e.bindTexture(st,ct),w(st),e.unbindTexture()}}}let Je=[];function ne(T){if(T.samples>0){if(ut(T)===!1){let v=T.textures,O=T.width,tt=T.height,j=i.COLOR_BUFFER_BIT,st=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(T),Y=v.length>1;if(Y)for(let at=0;at<v.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let at=0;at<v.length;at++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),Y){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let R=n.get(v[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,R,0)}i.blitFramebuffer(0,0,O,tt,0,0,O,tt,j,i.NEAREST),c===!0&&(Je.length=0,Je.push(i.COLOR_ATTACHMENT0+at),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&Je.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Je))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Y)for(let at=0;at<v.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let R=n.get(v[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,R,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&c){let v=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function ie(T){return Math.min(s.maxSamples,T.samples)}function ut(T){let v=n.get(T);return T.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function fe(T){let v=a.render.frame;h.get(T)!==v&&(h.set(T,v),T.update())}function At(T,v){let O=T.colorSpace,tt=T.format,j=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||O!==is&&O!==Fn&&(Gt.getTransfer(O)===Yt?(tt!==cn||j!==Be)&&Ct("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Pt("WebGLTextures: Unsupported texture color space:",O)),v}function _t(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(l.width=T.naturalWidth||T.width,l.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(l.width=T.displayWidth,l.height=T.displayHeight):(l.width=T.width,l.height=T.height),l}this.allocateTextureUnit=Lt,this.resetTextureUnits=Q,this.getTextureUnits=$,this.setTextureUnits=Mt,this.setTexture2D=pt,this.setTexture2DArray=vt,this.setTexture3D=Et,this.setTextureCube=mt,this.rebindTextures=Ye,this.setupRenderTarget=Ze,this.updateRenderTargetMipmap=L,this.updateMultisampleRenderTarget=ne,this.setupDepthRenderbuffer=qe,this.setupFrameBufferTexture=re,this.useMultisampledRTT=ut,this.dispose=G}function Vg(i,t){function e(n,s=Fn){let r,a=Gt.getTransfer(s);if(n===Be)return i.UNSIGNED_BYTE;if(n===ia)return i.UNSIGNED_SHORT_4_4_4_4;if(n===sa)return i.UNSIGNED_SHORT_5_5_5_1;if(n===el)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nl)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$o)return i.BYTE;if(n===tl)return i.SHORT;if(n===Wi)return i.UNSIGNED_SHORT;if(n===na)return i.INT;if(n===an)return i.UNSIGNED_INT;if(n===on)return i.FLOAT;if(n===ln)return i.HALF_FLOAT;if(n===il)return i.ALPHA;if(n===sl)return i.RGB;if(n===cn)return i.RGBA;if(n===Pn)return i.DEPTH_COMPONENT;if(n===Un)return i.DEPTH_STENCIL;if(n===rl)return i.RED;if(n===ra)return i.RED_INTEGER;if(n===$n)return i.RG;if(n===aa)return i.RG_INTEGER;if(n===oa)return i.RGBA_INTEGER;if(n===Rs||n===Ps||n===Is||n===_s)if(a===Yt)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Rs)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Is)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===_s)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Rs)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Is)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===_s)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===la||n===ca||n===ha||n===ua)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===la)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ca)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ha)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ua)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===da||n===fa||n===pa||n===ma||n===ga||n===Ls||n===xa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===da||n===fa)return a===Yt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===pa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ma)return r.COMPRESSED_R11_EAC;if(n===ga)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ls)return r.COMPRESSED_RG11_EAC;if(n===xa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===va||n===ya||n===Sa||n===Ma||n===ba||n===wa||n===Ta||n===Ea||n===Aa||n===Ca||n===Ra||n===Pa||n===Ia||n===_a)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===va)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ya)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Sa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Ma)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ba)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===wa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ta)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ea)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Aa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ca)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ra)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Pa)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ia)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===_a)return a===Yt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===La||n===Na||n===Da)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===La)return a===Yt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Na)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Da)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ua||n===Fa||n===Ns||n===Oa)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ua)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Fa)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ns)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oa)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===pi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Gg=`
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

}`,Tl=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ps(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new gn({vertexShader:Gg,fragmentShader:Hg,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new pe(new hi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},El=class extends mn{constructor(t,e){super();let n=this,s=null,r=1,a=null,o="local-floor",c=1,l=null,h=null,f=null,d=null,m=null,g=null,S=typeof XRWebGLBinding<"u",p=new Tl,u={},M=e.getContextAttributes(),A=null,w=null,C=[],E=[],x=new Ht,b=null,D=null,_=new Le;_.viewport=new se;let N=new Le;N.viewport=new se;let B=[_,N],H=new jr,P=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let pt=C[J];return pt===void 0&&(pt=new Ui,C[J]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(J){let pt=C[J];return pt===void 0&&(pt=new Ui,C[J]=pt),pt.getGripSpace()},this.getHand=function(J){let pt=C[J];return pt===void 0&&(pt=new Ui,C[J]=pt),pt.getHandSpace()};function q(J){let pt=E.indexOf(J.inputSource);if(pt===-1)return;let vt=C[pt];vt!==void 0&&(vt.update(J.inputSource,J.frame,l||a),vt.dispatchEvent({type:J.type,data:J.inputSource}))}function V(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",et);for(let J=0;J<C.length;J++){let pt=E[J];pt!==null&&(E[J]=null,C[J].disconnect(pt))}P=null,G=null,p.reset();for(let J in u)delete u[J];if(t.setRenderTarget(A),m=null,d=null,f=null,s=null,w=null,Lt.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(x.width,x.height,!1),D!==null){let J=D.camera;J.fov=D.fov,J.zoom=D.zoom,J.updateProjectionMatrix(),D=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Ct("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,n.isPresenting===!0&&Ct("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||a},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return f===null&&S&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",V),s.addEventListener("inputsourceschange",et),M.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(x),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Et=null,mt=null;M.depth&&(mt=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=M.stencil?Un:Pn,Et=M.stencil?pi:an);let Dt={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(Dt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),w=new He(d.textureWidth,d.textureHeight,{format:cn,type:Be,depthTexture:new Ln(d.textureWidth,d.textureHeight,Et,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let vt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),w=new He(m.framebufferWidth,m.framebufferHeight,{format:cn,type:Be,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(c),l=null,a=await s.requestReferenceSpace(o),Lt.setContext(s),Lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function et(J){for(let pt=0;pt<J.removed.length;pt++){let vt=J.removed[pt],Et=E.indexOf(vt);Et>=0&&(E[Et]=null,C[Et].disconnect(vt))}for(let pt=0;pt<J.added.length;pt++){let vt=J.added[pt],Et=E.indexOf(vt);if(Et===-1){for(let Dt=0;Dt<C.length;Dt++)if(Dt>=E.length){E.push(vt),Et=Dt;break}else if(E[Dt]===null){E[Dt]=vt,Et=Dt;break}if(Et===-1)break}let mt=C[Et];mt&&mt.connect(vt)}}function X(J,pt){pt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(pt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let pt=J.near,vt=J.far;p.texture!==null&&(p.depthNear>0&&(pt=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),H.near=N.near=_.near=pt,H.far=N.far=_.far=vt,(P!==H.near||G!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),P=H.near,G=H.far),H.layers.mask=J.layers.mask|6,_.layers.mask=H.layers.mask&-5,N.layers.mask=H.layers.mask&-3;let Et=J.parent,mt=H.cameras;X(H,Et);for(let Dt=0;Dt<mt.length;Dt++)X(mt[Dt],Et);H.projectionMatrix.copy(_.projectionMatrix),H.projectionMatrixInverse.copy(_.projectionMatrixInverse),D===null&&J.isPerspectiveCamera&&(D={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,H,Et)};function Q(J,pt,vt){vt===null?J.matrix.copy(pt.matrixWorld):(J.matrix.copy(vt.matrixWorld),J.matrix.invert(),J.matrix.multiply(pt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(pt.projectionMatrix),J.projectionMatrixInverse.copy(pt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Pr*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&m===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(H)},this.getCameraTexture=function(J){return u[J]};let $=null;function Mt(J,pt){if(h=pt.getViewerPose(l||a),g=pt,h!==null){let vt=h.views;m!==null&&(t.setRenderTargetFramebuffer(w,m.framebuffer),t.setRenderTarget(w));let Et=!1;vt.length!==H.cameras.length&&(H.cameras.length=0,Et=!0);for(let Rt=0;Rt<vt.length;Rt++){let Zt=vt[Rt],Kt=null;if(m!==null)Kt=m.getViewport(Zt);else{let be=f.getViewSubImage(d,Zt);Kt=be.viewport,Rt===0&&(t.setRenderTargetTextures(w,be.colorTexture,be.depthStencilTexture),t.setRenderTarget(w))}let zt=B[Rt];zt===void 0&&(zt=new Le,zt.layers.enable(Rt),zt.viewport=new se,B[Rt]=zt),zt.matrix.fromArray(Zt.transform.matrix),zt.matrix.decompose(zt.position,zt.quaternion,zt.scale),zt.projectionMatrix.fromArray(Zt.projectionMatrix),zt.projectionMatrixInverse.copy(zt.projectionMatrix).invert(),zt.viewport.set(Kt.x,Kt.y,Kt.width,Kt.height),Rt===0&&(H.matrix.copy(zt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Et===!0&&H.cameras.push(zt)}let mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){f=n.getBinding();let Rt=f.getDepthInformation(vt[0]);Rt&&Rt.isValid&&Rt.texture&&p.init(Rt,s.renderState)}if(mt&&mt.includes("camera-access")&&S){t.state.unbindTexture(),f=n.getBinding();for(let Rt=0;Rt<vt.length;Rt++){let Zt=vt[Rt].camera;if(Zt){let Kt=u[Zt];Kt||(Kt=new ps,u[Zt]=Kt);let zt=f.getCameraImage(Zt);Kt.sourceTexture=zt}}}}for(let vt=0;vt<C.length;vt++){let Et=E[vt],mt=C[vt];Et!==null&&mt!==void 0&&mt.update(Et,pt,l||a)}$&&$(J,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),g=null}let Lt=new Oh;Lt.setAnimationLoop(Mt),this.setAnimationLoop=function(J){$=J},this.dispose=function(){}}},Wg=new Qt,Yh=new It;Yh.set(-1,0,0,0,1,0,0,0,1);function Xg(i,t){function e(p,u){p.matrixAutoUpdate===!0&&p.updateMatrix(),u.value.copy(p.matrix)}function n(p,u){u.color.getRGB(p.fogColor.value,dl(i)),u.isFog?(p.fogNear.value=u.near,p.fogFar.value=u.far):u.isFogExp2&&(p.fogDensity.value=u.density)}function s(p,u,M,A,w){u.isNodeMaterial?u.uniformsNeedUpdate=!1:u.isMeshBasicMaterial?r(p,u):u.isMeshLambertMaterial?(r(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshToonMaterial?(r(p,u),f(p,u)):u.isMeshPhongMaterial?(r(p,u),h(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshStandardMaterial?(r(p,u),d(p,u),u.isMeshPhysicalMaterial&&m(p,u,w)):u.isMeshMatcapMaterial?(r(p,u),g(p,u)):u.isMeshDepthMaterial?r(p,u):u.isMeshDistanceMaterial?(r(p,u),S(p,u)):u.isMeshNormalMaterial?r(p,u):u.isLineBasicMaterial?(a(p,u),u.isLineDashedMaterial&&o(p,u)):u.isPointsMaterial?c(p,u,M,A):u.isSpriteMaterial?l(p,u):u.isShadowMaterial?(p.color.value.copy(u.color),p.opacity.value=u.opacity):u.isShaderMaterial&&(u.uniformsNeedUpdate=!1)}function r(p,u){p.opacity.value=u.opacity,u.color&&p.diffuse.value.copy(u.color),u.emissive&&p.emissive.value.copy(u.emissive).multiplyScalar(u.emissiveIntensity),u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.bumpMap&&(p.bumpMap.value=u.bumpMap,e(u.bumpMap,p.bumpMapTransform),p.bumpScale.value=u.bumpScale,u.side===De&&(p.bumpScale.value*=-1)),u.normalMap&&(p.normalMap.value=u.normalMap,e(u.normalMap,p.normalMapTransform),p.normalScale.value.copy(u.normalScale),u.side===De&&p.normalScale.value.negate()),u.displacementMap&&(p.displacementMap.value=u.displacementMap,e(u.displacementMap,p.displacementMapTransform),p.displacementScale.value=u.displacementScale,p.displacementBias.value=u.displacementBias),u.emissiveMap&&(p.emissiveMap.value=u.emissiveMap,e(u.emissiveMap,p.emissiveMapTransform)),u.specularMap&&(p.specularMap.value=u.specularMap,e(u.specularMap,p.specularMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest);let M=t.get(u),A=M.envMap,w=M.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(Wg.makeRotationFromEuler(w)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Yh),p.reflectivity.value=u.reflectivity,p.ior.value=u.ior,p.refractionRatio.value=u.refractionRatio),u.lightMap&&(p.lightMap.value=u.lightMap,p.lightMapIntensity.value=u.lightMapIntensity,e(u.lightMap,p.lightMapTransform)),u.aoMap&&(p.aoMap.value=u.aoMap,p.aoMapIntensity.value=u.aoMapIntensity,e(u.aoMap,p.aoMapTransform))}function a(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform))}function o(p,u){p.dashSize.value=u.dashSize,p.totalSize.value=u.dashSize+u.gapSize,p.scale.value=u.scale}function c(p,u,M,A){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.size.value=u.size*M,p.scale.value=A*.5,u.map&&(p.map.value=u.map,e(u.map,p.uvTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function l(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.rotation.value=u.rotation,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function h(p,u){p.specular.value.copy(u.specular),p.shininess.value=Math.max(u.shininess,1e-4)}function f(p,u){u.gradientMap&&(p.gradientMap.value=u.gradientMap)}function d(p,u){p.metalness.value=u.metalness,u.metalnessMap&&(p.metalnessMap.value=u.metalnessMap,e(u.metalnessMap,p.metalnessMapTransform)),p.roughness.value=u.roughness,u.roughnessMap&&(p.roughnessMap.value=u.roughnessMap,e(u.roughnessMap,p.roughnessMapTransform)),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)}function m(p,u,M){p.ior.value=u.ior,u.diffuseRoughness>0&&(p.diffuseRoughness.value=u.diffuseRoughness,u.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=u.diffuseRoughnessMap,e(u.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),u.sheen>0&&(p.sheenColor.value.copy(u.sheenColor).multiplyScalar(u.sheen),p.sheenRoughness.value=u.sheenRoughness,u.sheenColorMap&&(p.sheenColorMap.value=u.sheenColorMap,e(u.sheenColorMap,p.sheenColorMapTransform)),u.sheenRoughnessMap&&(p.sheenRoughnessMap.value=u.sheenRoughnessMap,e(u.sheenRoughnessMap,p.sheenRoughnessMapTransform))),u.clearcoat>0&&(p.clearcoat.value=u.clearcoat,p.clearcoatRoughness.value=u.clearcoatRoughness,u.clearcoatMap&&(p.clearcoatMap.value=u.clearcoatMap,e(u.clearcoatMap,p.clearcoatMapTransform)),u.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=u.clearcoatRoughnessMap,e(u.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),u.clearcoatNormalMap&&(p.clearcoatNormalMap.value=u.clearcoatNormalMap,e(u.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(u.clearcoatNormalScale),u.side===De&&p.clearcoatNormalScale.value.negate())),u.dispersion>0&&(p.dispersion.value=u.dispersion),u.retroreflectivity>0&&(p.retroreflectivity.value=u.retroreflectivity),u.iridescence>0&&(p.iridescence.value=u.iridescence,p.iridescenceIOR.value=u.iridescenceIOR,p.iridescenceThicknessMinimum.value=u.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=u.iridescenceThicknessMaximum,u.iridescenceMap&&(p.iridescenceMap.value=u.iridescenceMap,e(u.iridescenceMap,p.iridescenceMapTransform)),u.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=u.iridescenceThicknessMap,e(u.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),u.transmission>0&&(p.transmission.value=u.transmission,p.transmissionSamplerMap.value=M.texture,p.transmissionSamplerSize.value.set(M.width,M.height),u.transmissionMap&&(p.transmissionMap.value=u.transmissionMap,e(u.transmissionMap,p.transmissionMapTransform)),p.thickness.value=u.thickness,u.thicknessMap&&(p.thicknessMap.value=u.thicknessMap,e(u.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=u.attenuationDistance,p.attenuationColor.value.copy(u.attenuationColor)),u.anisotropy>0&&(p.anisotropyVector.value.set(u.anisotropy*Math.cos(u.anisotropyRotation),u.anisotropy*Math.sin(u.anisotropyRotation)),u.anisotropyMap&&(p.anisotropyMap.value=u.anisotropyMap,e(u.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=u.specularIntensity,p.specularColor.value.copy(u.specularColor),u.specularColorMap&&(p.specularColorMap.value=u.specularColorMap,e(u.specularColorMap,p.specularColorMapTransform)),u.specularIntensityMap&&(p.specularIntensityMap.value=u.specularIntensityMap,e(u.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,u){u.matcap&&(p.matcap.value=u.matcap)}function S(p,u){let M=t.get(u).light;p.referencePosition.value.setFromMatrixPosition(M.matrixWorld),p.nearDistance.value=M.shadow.camera.near,p.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function qg(i,t,e,n){let s={},r={};function a(M,A){let w=A.program;n.uniformBlockBinding(M,w,s[M.id])}function o(M,A){let w=s[M.id];w===void 0&&(g(M),w=c(M),s[M.id]=w,M.addEventListener("dispose",p));let C=A.program;n.updateUBOMapping(M,C);let E=t.render.frame;r[M.id]!==E&&(l(M),r[M.id]=E)}function c(M){let A=i.createBuffer(),w=M.__size,C=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,w,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(M){let A=s[M.id],w=M.uniforms,C=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=w.length;E<x;E++){let b=w[E];if(Array.isArray(b))for(let D=0,_=b.length;D<_;D++)h(b[D],E,D,C);else h(b,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(M,A,w,C){if(d(M,A,w,C)===!0){let E=M.__offset,x=M.value;if(Array.isArray(x)){let b=0;for(let D=0;D<x.length;D++){let _=x[D],N=S(_,!0);f(_,M.__data,b),b+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,M.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,M.__data)}}function f(M,A,w){typeof M=="number"||typeof M=="boolean"?A[w]=M:M.isMatrix3?(A[w]=M.elements[0],A[w+1]=M.elements[1],A[w+2]=M.elements[2],A[w+3]=0,A[w+4]=M.elements[3],A[w+5]=M.elements[4],A[w+6]=M.elements[5],A[w+7]=0,A[w+8]=M.elements[6],A[w+9]=M.elements[7],A[w+10]=M.elements[8],A[w+11]=0):ArrayBuffer.isView(M)?A.set(M.subarray(0,A.length-w),w):M.toArray(A,w)}function d(M,A,w,C){let E=M.value,x=A+"_"+w;if(Array.isArray(E)){C[x]===void 0&&(C[x]=[]);let b=C[x],D=!1;for(let _=0;_<E.length;_++)m(E[_],b,_)===!0&&(D=!0);return D}return m(E,C,x)}function m(M,A,w){if(A[w]===void 0)return typeof M=="number"||typeof M=="boolean"?A[w]=M:ArrayBuffer.isView(M)?A[w]=M.slice():A[w]=M.clone(),!0;{let C=A[w];if(typeof M=="number"||typeof M=="boolean"){if(C!==M)return A[w]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(C.equals(M)===!1)return C.copy(M),!0}}return!1}function g(M){let A=M.uniforms,w=0,C=16;for(let x=0,b=A.length;x<b;x++){let D=Array.isArray(A[x])?A[x]:[A[x]];for(let _=0,N=D.length;_<N;_++){let B=D[_],H=Array.isArray(B.value)?B.value:[B.value],P=Array.isArray(A[x])||Array.isArray(B.value),G=w;for(let V=0,et=H.length;V<et;V++){let X=H[V],Q=S(X,P),$=w%C,Mt=$%Q.boundary,Lt=$+Mt;w+=Mt,Lt!==0&&C-Lt<Q.storage&&(w+=C-Lt),V===0&&(G=w),w+=Q.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((w-G)/Float32Array.BYTES_PER_ELEMENT),B.__offset=G}}let E=w%C;return E>0&&(w+=C-E),M.__size=w,M.__cache={},this}function S(M,A){let w={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(w.boundary=4,w.storage=4):M.isVector2?(w.boundary=8,w.storage=8):M.isVector3||M.isColor?(w.boundary=16,w.storage=12):M.isVector4?(w.boundary=16,w.storage=16):M.isMatrix3?(w.boundary=16,w.storage=48):M.isMatrix4?(w.boundary=16,w.storage=64):M.isTexture?Ct("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(w.boundary=16,w.storage=M.byteLength):Ct("WebGLRenderer: Unsupported uniform value type.",M),A===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function p(M){let A=M.target;A.removeEventListener("dispose",p),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function u(){for(let M in s)i.deleteBuffer(s[M]);s={},r={}}return{bind:a,update:o,dispose:u}}var Yg=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yn=null;function Zg(){return yn===null&&(yn=new Nr(Yg,16,16,$n,ln),yn.name="DFG_LUT",yn.minFilter=Ne,yn.magFilter=Ne,yn.wrapS=fn,yn.wrapT=fn,yn.generateMipmaps=!1,yn.needsUpdate=!0),yn}var Ga=class{constructor(t={}){let{canvas:e=oh(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:m=Be}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let S=m,p=new Set([oa,aa,ra]),u=new Set([Be,an,Wi,pi,ia,sa]),M=new Uint32Array(4),A=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},C=null,E=null,x=[],b=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let _=this,N=!1,B=null,H=null,P=null,G=null;this._outputColorSpace=Ve;let q=0,V=0,et=null,X=-1,Q=null,$=new se,Mt=new se,Lt=null,J=new Ut(0),pt=0,vt=e.width,Et=e.height,mt=1,Dt=null,le=null,Rt=new se(0,0,vt,Et),Zt=new se(0,0,vt,Et),Kt=!1,zt=new Yn,be=new Dr,de=!1,Fe=!1,re=new Qt,un=new U,xe=new se,qe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ye=!1;function Ze(){return et===null?mt:1}let L=n;function Je(y,I){return e.getContext(y,I)}let ne,ie,ut,fe,At,_t,T,v,O,tt,j,st,ct,Y,Z,at,R,K,W,ot,it,rt,wt;try{let y={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Tt,!1),e.addEventListener("webglcontextrestored",Ft,!1),e.addEventListener("webglcontextcreationerror",dt,!1),L===null){let I="webgl2";if(L=Je(I,y),L===null)throw Je(I)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ot()}catch(y){throw e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),Pt("WebGLRenderer: "+y.message),y}function Ot(){ne=new rm(L),ne.init(),it=new Vg(L,ne),ie=new Zp(L,ne,t,it),ut=new zg(L,ne),ie.reversedDepthBuffer&&d&&ut.buffers.depth.setReversed(!0),H=L.createFramebuffer(),P=L.createFramebuffer(),G=L.createFramebuffer(),fe=new lm(L),At=new Eg,_t=new kg(L,ne,ut,At,ie,it,fe),T=new sm(_),v=new cd(L),rt=new qp(L,v),O=new am(L,v,fe,rt),tt=new hm(L,O,v,rt,fe),K=new cm(L,ie,_t),Z=new Jp(At),j=new Tg(_,T,ne,ie,rt,Z),st=new Xg(_,At),ct=new Cg,Y=new Ng(ne),R=new Xp(_,T,ut,tt,g,c),at=new Bg(_,tt,ie),wt=new qg(L,fe,ie,ut),W=new Yp(L,ne,fe),ot=new om(L,ne,fe),fe.programs=j.programs,_.capabilities=ie,_.extensions=ne,_.properties=At,_.renderLists=ct,_.shadowMap=at,_.state=ut,_.info=fe}S!==Be&&(D=new dm(S,e.width,e.height,o,s,r));let nt=new El(_,L);this.xr=nt,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let y=ne.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){let y=ne.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(y){y!==void 0&&(mt=y,this.setSize(vt,Et,!1))},this.getSize=function(y){return y.set(vt,Et)},this.setSize=function(y,I,k=!0){if(nt.isPresenting){Ct("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=y,Et=I,e.width=Math.floor(y*mt),e.height=Math.floor(I*mt),k===!0&&(e.style.width=y+"px",e.style.height=I+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,y,I)},this.getDrawingBufferSize=function(y){return y.set(vt*mt,Et*mt).floor()},this.setDrawingBufferSize=function(y,I,k){vt=y,Et=I,mt=k,e.width=Math.floor(y*k),e.height=Math.floor(I*k),this.setViewport(0,0,y,I)},this.setEffects=function(y){if(S===Be){Pt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let I=0;I<y.length;I++)if(y[I].isOutputPass===!0){Ct("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy($)},this.getViewport=function(y){return y.copy(Rt)},this.setViewport=function(y,I,k,F){y.isVector4?Rt.set(y.x,y.y,y.z,y.w):Rt.set(y,I,k,F),ut.viewport($.copy(Rt).multiplyScalar(Ze()).round())},this.getScissor=function(y){return y.copy(Zt)},this.setScissor=function(y,I,k,F){y.isVector4?Zt.set(y.x,y.y,y.z,y.w):Zt.set(y,I,k,F),ut.scissor(Mt.copy(Zt).multiplyScalar(Ze()).round())},this.getScissorTest=function(){return Kt},this.setScissorTest=function(y){ut.setScissorTest(Kt=y)},this.setOpaqueSort=function(y){Dt=y},this.setTransparentSort=function(y){le=y},this.getClearColor=function(y){return y.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(y=!0,I=!0,k=!0){let F=0;if(y){let z=!1;if(et!==null){let ht=et.texture.format;z=p.has(ht)}if(z){let ht=et.texture.type,xt=u.has(ht),lt=R.getClearColor(),gt=R.getClearAlpha(),bt=lt.r,Nt=lt.g,kt=lt.b;xt?(M[0]=bt,M[1]=Nt,M[2]=kt,M[3]=gt,L.clearBufferuiv(L.COLOR,0,M)):(A[0]=bt,A[1]=Nt,A[2]=kt,A[3]=gt,L.clearBufferiv(L.COLOR,0,A))}else F|=L.COLOR_BUFFER_BIT}I&&(F|=L.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),k&&(F|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&L.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),B=y},this.dispose=function(){e.removeEventListener("webglcontextlost",Tt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),R.dispose(),ct.dispose(),Y.dispose(),_t.dispose(),At.dispose(),T.dispose(),tt.dispose(),O.dispose(),rt.dispose(),wt.dispose(),j.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Dl),nt.removeEventListener("sessionend",Ul),ei.stop()};function Tt(y){y.preventDefault(),hl("WebGLRenderer: Context Lost."),N=!0}function Ft(){hl("WebGLRenderer: Context Restored."),N=!1;let y=fe.autoReset,I=at.enabled,k=at.autoUpdate,F=at.needsUpdate,z=at.type;Ot(),fe.autoReset=y,at.enabled=I,at.autoUpdate=k,at.needsUpdate=F,at.type=z}function dt(y){Pt("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Jt(y){let I=y.target;I.removeEventListener("dispose",Jt),ve(I)}function ve(y){Bn(y),At.remove(y)}function Bn(y){let I=At.get(y).programs;I!==void 0&&(I.forEach(function(k){j.releaseProgram(k)}),y.isShaderMaterial&&j.releaseShaderCache(y))}this.renderBufferDirect=function(y,I,k,F,z,ht){I===null&&(I=qe);let xt=z.isMesh&&z.matrixWorld.determinantAffine()<0,lt=cu(y,I,k,F,z);ut.setMaterial(F,xt);let gt=k.index,bt=1;if(F.wireframe===!0){if(gt=O.getWireframeAttribute(k),gt===void 0)return;bt=2}let Nt=k.drawRange,kt=k.attributes.position,yt=Nt.start*bt,Vt=(Nt.start+Nt.count)*bt;ht!==null&&(yt=Math.max(yt,ht.start*bt),Vt=Math.min(Vt,(ht.start+ht.count)*bt)),gt!==null?(yt=Math.max(yt,0),Vt=Math.min(Vt,gt.count)):kt!=null&&(yt=Math.max(yt,0),Vt=Math.min(Vt,kt.count));let ce=Vt-yt;if(ce<0||ce===1/0)return;rt.setup(z,F,lt,k,gt);let $t,jt=W;if(gt!==null&&($t=v.get(gt),jt=ot,jt.setIndex($t)),z.isMesh)F.wireframe===!0?(ut.setLineWidth(F.wireframeLinewidth*Ze()),jt.setMode(L.LINES)):jt.setMode(L.TRIANGLES);else if(z.isLine){let Ee=F.linewidth;Ee===void 0&&(Ee=1),ut.setLineWidth(Ee*Ze()),z.isLineSegments?jt.setMode(L.LINES):z.isLineLoop?jt.setMode(L.LINE_LOOP):jt.setMode(L.LINE_STRIP)}else z.isPoints?jt.setMode(L.POINTS):z.isSprite&&jt.setMode(L.TRIANGLES);if(z.isBatchedMesh)if(ne.get("WEBGL_multi_draw"))jt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Ee=z._multiDrawStarts,St=z._multiDrawCounts,_e=z._multiDrawCount,qt=gt?v.get(gt).bytesPerElement:1,ni=At.get(F).currentProgram.getUniforms();for(let Ae=0;Ae<_e;Ae++)ni.setValue(L,"_gl_DrawID",Ae),jt.render(Ee[Ae]/qt,St[Ae])}else if(z.isInstancedMesh)jt.renderInstances(yt,ce,z.count);else if(k.isInstancedBufferGeometry){let Ee=k._maxInstanceCount!==void 0?k._maxInstanceCount:1/0,St=Math.min(k.instanceCount,Ee);jt.renderInstances(yt,ce,St)}else jt.render(yt,ce)};function Nl(y,I,k,F){B!==null&&y.isNodeMaterial&&B.setObject(F,y),de===!0&&Z.setState(y,k,!1),y.transparent===!0&&y.side===xn&&y.forceSinglePass===!1?(y.side=De,y.needsUpdate=!0,Zi(y,I,F),y.side=Qn,y.needsUpdate=!0,Zi(y,I,F),y.side=xn):Zi(y,I,F)}this.compile=function(y,I,k=null){k===null&&(k=y),B!==null&&B.renderStart(y,I,k),E=Y.get(k),E.init(I),b.push(E),k.traverseVisible(function(z){z.isLight&&z.layers.test(I.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),y!==k&&y.traverseVisible(function(z){z.isLight&&z.layers.test(I.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Fe=this.localClippingEnabled,de=Z.init(this.clippingPlanes,Fe),de===!0&&Z.setGlobalState(this.clippingPlanes,I),B!==null&&at.render(E.state.shadowsArray,k,I);let F=new Set;return y.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let ht=z.material;if(ht)if(Array.isArray(ht))for(let xt=0;xt<ht.length;xt++){let lt=ht[xt];Nl(lt,k,I,z),F.add(lt)}else Nl(ht,k,I,z),F.add(ht)}),E=b.pop(),B!==null&&B.renderEnd(),F},this.compileAsync=function(y,I,k=null){let F=this.compile(y,I,k);return new Promise(z=>{function ht(){if(F.forEach(function(xt){let gt=At.get(xt).currentProgram;(gt===void 0||gt.isReady())&&F.delete(xt)}),F.size===0){z(y);return}setTimeout(ht,10)}ne.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let no=null;function ou(y){no&&no(y)}function Dl(){ei.stop()}function Ul(){ei.start()}let ei=new Oh;ei.setAnimationLoop(ou),typeof self<"u"&&ei.setContext(self),this.setAnimationLoop=function(y){no=y,nt.setAnimationLoop(y),y===null?ei.stop():ei.start()},nt.addEventListener("sessionstart",Dl),nt.addEventListener("sessionend",Ul),this.render=function(y,I){if(I!==void 0&&I.isCamera!==!0){Pt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;B!==null&&B.renderStart(y,I);let k=nt.enabled===!0&&nt.isPresenting===!0,F=D!==null&&(et===null||k)&&D.begin(_,et);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),I.parent===null&&I.matrixWorldAutoUpdate===!0&&I.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(I),I=nt.getCamera()),y.isScene===!0&&y.onBeforeRender(_,y,I,et),E=Y.get(y,b.length),E.init(I),E.state.textureUnits=_t.getTextureUnits(),b.push(E),re.multiplyMatrices(I.projectionMatrix,I.matrixWorldInverse),I.isArrayCamera?be.setFromArrayCamera(I):zt.setFromProjectionMatrix(re,je,I.reversedDepth),Fe=this.localClippingEnabled,de=Z.init(this.clippingPlanes,Fe),C=ct.get(y,x.length),C.init(),x.push(C),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let xt=_.xr.getDepthSensingMesh();xt!==null&&io(xt,I,-1/0,_.sortObjects)}io(y,I,0,_.sortObjects),C.finish(),B!==null&&B.updateLights(E.state.lightsArray),_.sortObjects===!0&&C.sort(Dt,le),Ye=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Ye&&R.addToRenderList(C,y),this.info.autoReset===!0&&this.info.reset(),de===!0&&Z.beginShadows();let z=E.state.shadowsArray;if(at.render(z,y,I),de===!0&&Z.endShadows(),(F&&D.hasRenderPass())===!1){let xt=C.opaque,lt=C.transmissive;if(E.setupLights(),I.isArrayCamera){let gt=I.cameras;if(lt.length>0)for(let bt=0,Nt=gt.length;bt<Nt;bt++){let kt=gt[bt];Ol(xt,lt,y,kt)}Ye&&R.render(y);for(let bt=0,Nt=gt.length;bt<Nt;bt++){let kt=gt[bt];Fl(C,y,kt,kt.viewport)}}else lt.length>0&&Ol(xt,lt,y,I),Ye&&R.render(y),Fl(C,y,I)}et!==null&&V===0&&(_t.updateMultisampleRenderTarget(et),_t.updateRenderTargetMipmap(et)),F&&D.end(_),y.isScene===!0&&y.onAfterRender(_,y,I),rt.resetDefaultState(),X=-1,Q=null,b.pop(),b.length>0?(E=b[b.length-1],_t.setTextureUnits(E.state.textureUnits),de===!0&&Z.setGlobalState(_.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,B!==null&&B.renderEnd()};function io(y,I,k,F){if(y.visible===!1)return;if(y.layers.test(I.layers)){if(y.isGroup)k=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(I);else if(y.isLight)E.pushLight(y),y.castShadow&&E.pushShadow(y);else if(y.isSprite){let xt=I.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){F&&xe.setFromMatrixPosition(y.matrixWorld).applyMatrix4(re);let lt=tt.update(y),gt=y.material;gt.visible&&C.push(y,lt,gt,k,xe.z,null,I)}}else if(y.isMesh||y.isLine||y.isPoints){let xt=I.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){let lt=tt.update(y),gt=y.material;if(F&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),xe.copy(y.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),xe.copy(lt.boundingSphere.center)),xe.applyMatrix4(y.matrixWorld).applyMatrix4(re)),Array.isArray(gt)){let bt=lt.groups;for(let Nt=0,kt=bt.length;Nt<kt;Nt++){let yt=bt[Nt],Vt=gt[yt.materialIndex];Vt&&Vt.visible&&C.push(y,lt,Vt,k,xe.z,yt,I)}}else gt.visible&&C.push(y,lt,gt,k,xe.z,null,I)}}}let ht=y.children;for(let xt=0,lt=ht.length;xt<lt;xt++)io(ht[xt],I,k,F)}function Fl(y,I,k,F){let{opaque:z,transmissive:ht,transparent:xt}=y;E.setupLightsView(k),de===!0&&Z.setGlobalState(_.clippingPlanes,k),F&&ut.viewport($.copy(F)),z.length>0&&Vs(z,I,k),ht.length>0&&Vs(ht,I,k),xt.length>0&&Vs(xt,I,k),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function Ol(y,I,k,F){if((k.isScene===!0?k.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[F.id]===void 0){let yt=ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[F.id]=new He(1,1,{generateMipmaps:!0,type:yt?ln:Be,minFilter:Dn,samples:Math.max(4,ie.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Gt.workingColorSpace})}let ht=E.state.transmissionRenderTarget[F.id],xt=F.viewport||$;ht.setSize(xt.z*_.transmissionResolutionScale,xt.w*_.transmissionResolutionScale);let lt=_.getRenderTarget(),gt=_.getActiveCubeFace(),bt=_.getActiveMipmapLevel();_.setRenderTarget(ht),_.getClearColor(J),pt=_.getClearAlpha(),pt<1&&_.setClearColor(16777215,.5),_.clear(),Ye&&R.render(k);let Nt=_.toneMapping;_.toneMapping=vn;let kt=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),E.setupLightsView(F),de===!0&&Z.setGlobalState(_.clippingPlanes,F),Vs(y,k,F),_t.updateMultisampleRenderTarget(ht),_t.updateRenderTargetMipmap(ht),ne.has("WEBGL_multisampled_render_to_texture")===!1){let yt=!1;for(let Vt=0,ce=I.length;Vt<ce;Vt++){let $t=I[Vt],{object:jt,geometry:Ee,material:St,group:_e}=$t;if(St.side===xn&&jt.layers.test(F.layers)){let qt=St.side;St.side=De,St.needsUpdate=!0,Bl(jt,k,F,Ee,St,_e),St.side=qt,St.needsUpdate=!0,yt=!0}}yt===!0&&(_t.updateMultisampleRenderTarget(ht),_t.updateRenderTargetMipmap(ht))}_.setRenderTarget(lt,gt,bt),_.setClearColor(J,pt),kt!==void 0&&(F.viewport=kt),_.toneMapping=Nt}function Vs(y,I,k){let F=I.isScene===!0?I.overrideMaterial:null;for(let z=0,ht=y.length;z<ht;z++){let xt=y[z],{object:lt,geometry:gt,group:bt}=xt,Nt=xt.material;Nt.allowOverride===!0&&F!==null&&(Nt=F),lt.layers.test(k.layers)&&Bl(lt,I,k,gt,Nt,bt)}}function Bl(y,I,k,F,z,ht){B!==null&&z.isNodeMaterial&&B.setObject(y,z),y.onBeforeRender(_,I,k,F,z,ht),y.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),z.onBeforeRender(_,I,k,F,y,ht),z.transparent===!0&&z.side===xn&&z.forceSinglePass===!1?(z.side=De,z.needsUpdate=!0,_.renderBufferDirect(k,I,F,z,y,ht),z.side=Qn,z.needsUpdate=!0,_.renderBufferDirect(k,I,F,z,y,ht),z.side=xn):_.renderBufferDirect(k,I,F,z,y,ht),y.onAfterRender(_,I,k,F,z,ht)}function zl(y){let I=0;for(let k of y)k.texture!==null&&I++;return I}function Zi(y,I,k){I.isScene!==!0&&(I=qe);let F=At.get(y),z=E.state.lights,ht=E.state.shadowsArray,xt=z.state.version,lt=j.getParameters(y,z.state,ht,I,k,E.state.lightProbeGridArray),gt=j.getProgramCacheKey(lt),bt=F.programs;F.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?I.environment:null,F.fog=I.fog;let Nt=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;F.envMap=T.get(y.envMap||F.environment,Nt),F.envMapRotation=F.environment!==null&&y.envMap===null?I.environmentRotation:y.envMapRotation,bt===void 0&&(y.addEventListener("dispose",Jt),bt=new Map,F.programs=bt,F.programVariants=new Map);let kt=bt.get(gt);if(kt!==void 0){if(F.currentProgram===kt&&F.lightsStateVersion===xt)return Vl(y,lt),kt}else lt.uniforms=j.getUniforms(y),B!==null&&y.isNodeMaterial&&B.build(y,k,lt),y.onBeforeCompile(lt,_),kt=j.acquireProgram(lt,gt),bt.set(gt,kt),F.uniforms=lt.uniforms;let yt=F.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(yt.clippingPlanes=Z.uniform),Vl(y,lt),F.needsLights=uu(y),F.lightsStateVersion=xt,F.needsLights&&(yt.ambientLightColor.value=z.state.ambient,yt.lightProbe.value=z.state.probe,yt.sunLights.value=z.state.sun,yt.sunLightShadows.value=z.state.sunShadow,yt.directionalLights.value=z.state.directional,yt.directionalLightShadows.value=z.state.directionalShadow,yt.spotLights.value=z.state.spot,yt.spotLightShadows.value=z.state.spotShadow,yt.rectAreaLights.value=z.state.rectArea,yt.ltc_1.value=z.state.rectAreaLTC1,yt.ltc_2.value=z.state.rectAreaLTC2,yt.pointLights.value=z.state.point,yt.pointLightShadows.value=z.state.pointShadow,yt.hemisphereLights.value=z.state.hemi,yt.sunShadowMatrix.value=z.state.sunShadowMatrix,yt.sunShadowCascade.value=z.state.sunShadowCascade,yt.directionalShadowMatrix.value=z.state.directionalShadowMatrix,yt.spotLightMatrix.value=z.state.spotLightMatrix,yt.spotLightMap.value=z.state.spotLightMap,yt.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=zl(E.state.lightProbeGridArray),F.currentProgram=kt,F.uniformsList=null,kt}function lu(y,I,k,F,z){let ht=At.get(y),xt=ht.currentProgram.id+","+F+","+z,lt=ht.programVariants.get(xt);return lt===void 0?(lt=Zi(y,I,k),ht.programVariants.set(xt,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=F,ht.toneMapping=z),lt}function kl(y){if(y.uniformsList===null){let I=y.currentProgram.getUniforms();y.uniformsList=Xi.seqWithValue(I.seq,y.uniforms)}return y.uniformsList}function Vl(y,I){let k=At.get(y);k.outputColorSpace=I.outputColorSpace,k.batching=I.batching,k.batchingColor=I.batchingColor,k.instancing=I.instancing,k.instancingColor=I.instancingColor,k.instancingMorph=I.instancingMorph,k.skinning=I.skinning,k.morphTargets=I.morphTargets,k.morphNormals=I.morphNormals,k.morphColors=I.morphColors,k.morphTargetsCount=I.morphTargetsCount,k.numClippingPlanes=I.numClippingPlanes,k.numIntersection=I.numClipIntersection,k.vertexAlphas=I.vertexAlphas,k.vertexTangents=I.vertexTangents,k.toneMapping=I.toneMapping}function cu(y,I,k,F,z){I.isScene!==!0&&(I=qe),_t.resetTextureUnits();let ht=I.fog,xt=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?I.environment:null,lt=et===null?_.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Gt.workingColorSpace,gt=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,bt=T.get(F.envMap||xt,gt),Nt=F.vertexColors===!0&&!!k.attributes.color&&k.attributes.color.itemSize===4,kt=!!k.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),yt=!!k.morphAttributes.position,Vt=!!k.morphAttributes.normal,ce=!!k.morphAttributes.color,$t=vn;F.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&($t=_.toneMapping);let jt=k.morphAttributes.position||k.morphAttributes.normal||k.morphAttributes.color,Ee=jt!==void 0?jt.length:0,St=At.get(F),_e=E.state.lights;if(de===!0&&(Fe===!0||y!==Q)){let ae=y===Q&&F.id===X;Z.setState(F,y,ae)}let qt=!1,ni=!1;F.version===St.__version?St.needsLights&&St.lightsStateVersion!==_e.state.version||z.isBatchedMesh&&St.batching===!1||!z.isBatchedMesh&&St.batching===!0||z.isBatchedMesh&&St.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&St.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&St.instancing===!1||!z.isInstancedMesh&&St.instancing===!0||z.isSkinnedMesh&&St.skinning===!1||!z.isSkinnedMesh&&St.skinning===!0||z.isInstancedMesh&&St.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&St.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&St.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&St.instancingMorph===!1&&z.morphTexture!==null||St.envMap!==bt||F.fog===!0&&St.fog!==ht||St.numClippingPlanes!==void 0&&(St.numClippingPlanes!==Z.numPlanes||St.numIntersection!==Z.numIntersection)||St.vertexAlphas!==Nt||St.vertexTangents!==kt||St.morphTargets!==yt||St.morphNormals!==Vt||St.morphColors!==ce||St.morphTargetsCount!==Ee||St.numLightProbeGrids!==zl(E.state.lightProbeGridArray)?qt=!0:(St.outputColorSpace!==lt||St.toneMapping!==$t)&&(ni=!0):(qt=!0,St.__version=F.version);let Ae=St.currentProgram;(qt===!0||ni===!0)&&(Ae=ni===!0?lu(F,I,z,lt,$t):Zi(F,I,z),B&&F.isNodeMaterial&&B.onUpdateProgram(F,Ae,St));let Gs=!1,zn=!1,ii=!1,Xt=Ae.getUniforms(),we=St.uniforms;if(ut.useProgram(Ae.program)&&(Gs=!0,zn=!0,ii=!0),F.id!==X&&(X=F.id,zn=!0),Gs||Q!==y){ut.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),Xt.setValue(L,"projectionMatrix",y.projectionMatrix),Xt.setValue(L,"viewMatrix",y.matrixWorldInverse);let ye=Xt.map.cameraPosition;ye!==void 0&&ye.setValue(L,un.setFromMatrixPosition(y.matrixWorld)),ie.logarithmicDepthBuffer&&Xt.setValue(L,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&Xt.setValue(L,"isOrthographic",y.isOrthographicCamera===!0),Q!==y&&(Q=y,zn=!0,ii=!0)}if(St.needsLights&&(_e.state.sunShadowMap.length>0&&Xt.setValue(L,"sunShadowMap",_e.state.sunShadowMap,_t),_e.state.directionalShadowMap.length>0&&Xt.setValue(L,"directionalShadowMap",_e.state.directionalShadowMap,_t),_e.state.spotShadowMap.length>0&&Xt.setValue(L,"spotShadowMap",_e.state.spotShadowMap,_t),_e.state.pointShadowMap.length>0&&Xt.setValue(L,"pointShadowMap",_e.state.pointShadowMap,_t)),z.isSkinnedMesh){Xt.setOptional(L,z,"bindMatrix"),Xt.setOptional(L,z,"bindMatrixInverse");let ae=z.skeleton;ae&&(ae.boneTexture===null&&ae.computeBoneTexture(),Xt.setValue(L,"boneTexture",ae.boneTexture,_t))}z.isBatchedMesh&&(Xt.setOptional(L,z,"batchingTexture"),Xt.setValue(L,"batchingTexture",z._matricesTexture,_t),Xt.setOptional(L,z,"batchingIdTexture"),Xt.setValue(L,"batchingIdTexture",z._indirectTexture,_t),Xt.setOptional(L,z,"batchingColorTexture"),z._colorsTexture!==null&&Xt.setValue(L,"batchingColorTexture",z._colorsTexture,_t));let tn=k.morphAttributes;if((tn.position!==void 0||tn.normal!==void 0||tn.color!==void 0)&&K.update(z,k,Ae),(zn||St.receiveShadow!==z.receiveShadow)&&(St.receiveShadow=z.receiveShadow,Xt.setValue(L,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&I.environment!==null&&(we.envMapIntensity.value=I.environmentIntensity),we.dfgLUT!==void 0&&(we.dfgLUT.value=Zg()),zn){if(Xt.setValue(L,"toneMappingExposure",_.toneMappingExposure),St.needsLights&&hu(we,ii),ht&&F.fog===!0&&st.refreshFogUniforms(we,ht),st.refreshMaterialUniforms(we,F,mt,Et,E.state.transmissionRenderTarget[y.id]),St.needsLights&&St.numLightProbeGrids>0){let ae=w,ye=0;for(let Mn of E.state.lightProbeGridArray)Mn.texture!==null&&(ae.textures[ye]=Mn.texture,ae.min[ye]=Mn.boundingBox.min,ae.max[ye]=Mn.boundingBox.max,ae.resolution[ye]=Mn.resolution,ye++);for(let Mn in ae)ae[Mn].length=ye;we.probesSH.value=ae.textures,we.probesMin.value=ae.min,we.probesMax.value=ae.max,we.probesResolution.value=ae.resolution}Xi.upload(L,kl(St),we,_t)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(Xi.upload(L,kl(St),we,_t),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&Xt.setValue(L,"center",z.center),Xt.setValue(L,"modelViewMatrix",z.modelViewMatrix),Xt.setValue(L,"normalMatrix",z.normalMatrix),Xt.setValue(L,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let ae=F.uniformsGroups;for(let ye=0,Mn=ae.length;ye<Mn;ye++){let Hl=ae[ye];wt.update(Hl,Ae),wt.bind(Hl,Ae)}}return Ae}function hu(y,I){y.ambientLightColor.needsUpdate=I,y.lightProbe.needsUpdate=I,y.sunLights.needsUpdate=I,y.sunLightShadows.needsUpdate=I,y.directionalLights.needsUpdate=I,y.directionalLightShadows.needsUpdate=I,y.pointLights.needsUpdate=I,y.pointLightShadows.needsUpdate=I,y.spotLights.needsUpdate=I,y.spotLightShadows.needsUpdate=I,y.rectAreaLights.needsUpdate=I,y.hemisphereLights.needsUpdate=I}function uu(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(y,I,k){let F=At.get(y);F.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),At.get(y.texture).__webglTexture=I,At.get(y.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:k,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,I){let k=At.get(y);k.__webglFramebuffer=I,k.__useDefaultFramebuffer=I===void 0},this.setRenderTarget=function(y,I=0,k=0){et=y,q=I,V=k;let F=null,z=!1,ht=!1;if(y){let lt=At.get(y);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(L.FRAMEBUFFER,lt.__webglFramebuffer),$.copy(y.viewport),Mt.copy(y.scissor),Lt=y.scissorTest,ut.viewport($),ut.scissor(Mt),ut.setScissorTest(Lt),X=-1;return}else if(lt.__webglFramebuffer===void 0)_t.setupRenderTarget(y);else if(lt.__hasExternalTextures)_t.rebindTextures(y,At.get(y.texture).__webglTexture,At.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){let Nt=y.depthTexture;if(lt.__boundDepthTexture!==Nt){if(Nt!==null&&At.has(Nt)&&(y.width!==Nt.image.width||y.height!==Nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");_t.setupDepthRenderbuffer(y)}}let gt=y.texture;(gt.isData3DTexture||gt.isDataArrayTexture||gt.isCompressedArrayTexture)&&(ht=!0);let bt=At.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(bt[I])?F=bt[I][k]:F=bt[I],z=!0):y.samples>0&&_t.useMultisampledRTT(y)===!1?F=At.get(y).__webglMultisampledFramebuffer:Array.isArray(bt)?F=bt[k]:F=bt,$.copy(y.viewport),Mt.copy(y.scissor),Lt=y.scissorTest}else $.copy(Rt).multiplyScalar(mt).floor(),Mt.copy(Zt).multiplyScalar(mt).floor(),Lt=Kt;if(k!==0&&(F=H),ut.bindFramebuffer(L.FRAMEBUFFER,F)&&ut.drawBuffers(y,F),ut.viewport($),ut.scissor(Mt),ut.setScissorTest(Lt),z){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+I,lt.__webglTexture,k)}else if(ht){let lt=I;for(let gt=0;gt<y.textures.length;gt++){let bt=At.get(y.textures[gt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+gt,bt.__webglTexture,k,lt)}}else if(y!==null&&k!==0){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,lt.__webglTexture,k)}X=-1};function Gl(y){let I=At.get(y);return(I.__readFormat!==y.format||I.__readType!==y.type)&&(I.__readFormat=y.format,I.__readType=y.type,I.__formatReadable=ie.textureFormatReadable(y.format),I.__typeReadable=ie.textureTypeReadable(y.type)),I}this.readRenderTargetPixels=function(y,I,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget)){Pt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt){ut.bindFramebuffer(L.FRAMEBUFFER,gt);try{let bt=y.textures[lt],Nt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Gl(bt);if(yt.__formatReadable===!1){Pt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(yt.__typeReadable===!1){Pt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}I>=0&&I<=y.width-F&&k>=0&&k<=y.height-z&&L.readPixels(I,k,F,z,it.convert(Nt),it.convert(kt),ht)}finally{let bt=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,bt)}}},this.readRenderTargetPixelsAsync=async function(y,I,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt)if(I>=0&&I<=y.width-F&&k>=0&&k<=y.height-z){ut.bindFramebuffer(L.FRAMEBUFFER,gt);let bt=y.textures[lt],Nt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Gl(bt);if(yt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(yt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Vt=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,Vt),L.bufferData(L.PIXEL_PACK_BUFFER,ht.byteLength,L.STREAM_READ),L.readPixels(I,k,F,z,it.convert(Nt),it.convert(kt),0),L.bindBuffer(L.PIXEL_PACK_BUFFER,null);let ce=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,ce);let $t=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await ch(L,$t,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,Vt),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,ht),L.bindBuffer(L.PIXEL_PACK_BUFFER,null),L.deleteBuffer(Vt),L.deleteSync($t),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,I=null,k=0){let F=Math.pow(2,-k),z=Math.floor(y.image.width*F),ht=Math.floor(y.image.height*F),xt=I!==null?I.x:0,lt=I!==null?I.y:0;_t.setTexture2D(y,0),L.copyTexSubImage2D(L.TEXTURE_2D,k,0,0,xt,lt,z,ht),ut.unbindTexture()},this.copyTextureToTexture=function(y,I,k=null,F=null,z=0,ht=0){let xt,lt,gt,bt,Nt,kt,yt,Vt,ce,$t=y.isCompressedTexture?y.mipmaps[ht]:y.image;if(k!==null)xt=k.max.x-k.min.x,lt=k.max.y-k.min.y,gt=k.isBox3?k.max.z-k.min.z:1,bt=k.min.x,Nt=k.min.y,kt=k.isBox3?k.min.z:0;else{let Xt=Math.pow(2,-z);xt=Math.floor($t.width*Xt),lt=Math.floor($t.height*Xt),y.isDataArrayTexture?gt=$t.depth:y.isData3DTexture?gt=Math.floor($t.depth*Xt):gt=1,bt=0,Nt=0,kt=0}F!==null?(yt=F.x,Vt=F.y,ce=F.z):(yt=0,Vt=0,ce=0);let jt=it.convert(I.format),Ee=it.convert(I.type),St;I.isData3DTexture?(_t.setTexture3D(I,0),St=L.TEXTURE_3D):I.isDataArrayTexture||I.isCompressedArrayTexture?(_t.setTexture2DArray(I,0),St=L.TEXTURE_2D_ARRAY):(_t.setTexture2D(I,0),St=L.TEXTURE_2D),ut.activeTexture(L.TEXTURE0),ut.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,I.flipY),ut.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,I.premultiplyAlpha),ut.pixelStorei(L.UNPACK_ALIGNMENT,I.unpackAlignment);let _e=ut.getParameter(L.UNPACK_ROW_LENGTH),qt=ut.getParameter(L.UNPACK_IMAGE_HEIGHT),ni=ut.getParameter(L.UNPACK_SKIP_PIXELS),Ae=ut.getParameter(L.UNPACK_SKIP_ROWS),Gs=ut.getParameter(L.UNPACK_SKIP_IMAGES);ut.pixelStorei(L.UNPACK_ROW_LENGTH,$t.width),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,$t.height),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,bt),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Nt),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,kt);let zn=y.isDataArrayTexture||y.isData3DTexture,ii=I.isDataArrayTexture||I.isData3DTexture;if(y.isDepthTexture){let Xt=At.get(y),we=At.get(I),tn=At.get(Xt.__renderTarget),ae=At.get(we.__renderTarget);ut.bindFramebuffer(L.READ_FRAMEBUFFER,tn.__webglFramebuffer),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,ae.__webglFramebuffer);for(let ye=0;ye<gt;ye++)zn&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(y).__webglTexture,z,kt+ye),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(I).__webglTexture,ht,ce+ye)),L.blitFramebuffer(bt,Nt,bt+xt,Nt+lt,yt,Vt,yt+xt,Vt+lt,L.DEPTH_BUFFER_BIT,L.NEAREST);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(z!==0||y.isRenderTargetTexture||At.has(y)){let Xt=At.get(y),we=At.get(I);ut.bindFramebuffer(L.READ_FRAMEBUFFER,P),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,G);for(let tn=0;tn<gt;tn++)zn?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Xt.__webglTexture,z,kt+tn):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Xt.__webglTexture,z),ii?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,we.__webglTexture,ht,ce+tn):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,we.__webglTexture,ht),z!==0?L.blitFramebuffer(bt,Nt,bt+xt,Nt+lt,yt,Vt,yt+xt,Vt+lt,L.COLOR_BUFFER_BIT,L.NEAREST):ii?L.copyTexSubImage3D(St,ht,yt,Vt,ce+tn,bt,Nt,xt,lt):L.copyTexSubImage2D(St,ht,yt,Vt,bt,Nt,xt,lt);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else ii?y.isDataTexture||y.isData3DTexture?L.texSubImage3D(St,ht,yt,Vt,ce,xt,lt,gt,jt,Ee,$t.data):I.isCompressedArrayTexture?L.compressedTexSubImage3D(St,ht,yt,Vt,ce,xt,lt,gt,jt,$t.data):L.texSubImage3D(St,ht,yt,Vt,ce,xt,lt,gt,jt,Ee,$t):y.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,ht,yt,Vt,xt,lt,jt,Ee,$t.data):y.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,ht,yt,Vt,$t.width,$t.height,jt,$t.data):L.texSubImage2D(L.TEXTURE_2D,ht,yt,Vt,xt,lt,jt,Ee,$t);ut.pixelStorei(L.UNPACK_ROW_LENGTH,_e),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,qt),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,ni),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Ae),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,Gs),ht===0&&I.generateMipmaps===!0&&I.mipmapsAutoUpdate===!0&&L.generateMipmap(St),ut.unbindTexture()},this.initRenderTarget=function(y){At.get(y).__webglFramebuffer===void 0&&_t.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?_t.setTextureCube(y,0):y.isData3DTexture?_t.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?_t.setTexture2DArray(y,0):_t.setTexture2D(y,0),ut.unbindTexture()},this.resetState=function(){q=0,V=0,et=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return je}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Gt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Gt._getUnpackColorSpace()}};var Zh=.5,Jh=.012,Ya=new U(0,0,1),Kh=.15,Xa=Math.PI/180,Qh=60*Xa,Yi=i=>new vs({color:i}),Jg=Yi("#e8eaee"),jh=Yi("#9aa3b2"),Al=Yi("#5c6675"),Kg=Yi("#3d4653"),jg=Yi("#c9723c"),Qg=Yi("#8a6d3b"),$g=new $e({color:"#b3261e"}),t0=new $e({color:"#6a1b9a",wireframe:!0}),e0=new Zn({color:"#1f2937"}),n0=new Zn({color:"#5b4a2a"}),i0=new $e({color:"#1565c0",wireframe:!0,depthTest:!1});function On(i,t,e,n=20){let s=new Bi(i,i,t,n);return s.rotateX(Math.PI/2),new pe(s,e)}var ti=(i,t=0)=>new U(i[t],i[t+1],i[t+2]);function qa(i,t,e){let n=e.clone().sub(t);i.position.copy(t).addScaledVector(n,.5),i.scale.z=Math.max(n.length(),1e-6),i.quaternion.setFromUnitVectors(Ya,n.normalize())}var Za=class extends Ge{constructor(t){super(),this.shaft=On(.012,1,t,8),this.head=new pe(new ms(.032,.07,10).rotateX(Math.PI/2),t),this.add(this.shaft,this.head)}show(t,e){let n=Jh*e.length();if(this.visible=n>.012,!this.visible)return;let s=t.clone().addScaledVector(e,Jh);qa(this.shaft,t,s),this.head.position.copy(s),this.head.quaternion.copy(this.shaft.quaternion)}},Ja=class extends Ge{constructor(t,e){super(),this.believes=e,this.position.y=t,this.rotation.z=Qh;let n=On(.1,.06,jh);n.position.z=.03,this.add(n),this.limbs=Array.from({length:8},(a,o)=>On(o<5?.055:.045,1,Jg)),this.joints=Array.from({length:7},(a,o)=>On(o<5?.068:.055,o<5?.15:.12,jh)),this.flange=new Ge;let s=On(.05,.02,Al),r=new pe(new Nn(.05,.19,.05),Al);r.position.z=.035,this.flange.add(s,r);for(let a of[-1,1]){let o=new pe(new Nn(.02,.015,.05),Al);o.position.set(0,a*.055,.085),this.flange.add(o)}this.objects=new Ge,this.flange.add(this.objects),this.belief=new pe(new zi(1,12,8),i0),this.belief.matrixAutoUpdate=!1,this.flange.add(this.belief),this.bag=new pe(new zi(.06,14,10),Qg),this.string=new Fi(new Pe().setFromPoints([new U,Ya]),n0),this.target=new Ge,this.target.add(new pe(new xs(.085,.006,6,28),new $e({color:"#1f2937"}))),this.stream=On(.008,1,new $e({color:"#3b82c4"}),8),this.sag=On(.004,1,new $e({color:"#1f2937"}),6),this.push=new Za($g),this.felt=new Za(t0),this.add(...this.limbs,...this.joints,this.flange,this.bag,this.string,this.target,this.sag,this.stream,this.push,this.felt)}update(t,e,n,s){let r=t("links"),a=M=>[ti(r,7*M),new Qe(...r.slice(7*M+3,7*M+7))],o=new U;for(let M=0;M<8;++M){let[A,w]=a(M);this.limbs[M].visible=A.distanceTo(o)>.001,this.limbs[M].visible&&qa(this.limbs[M],o,A),M<7?(this.joints[M].position.copy(A),this.joints[M].quaternion.copy(w)):(this.flange.position.copy(A),this.flange.quaternion.copy(w),this.target.quaternion.copy(w),this.target.position.copy(A).sub(ti(t("error"))),this.sag.visible=ti(t("error")).length()>.004,this.sag.visible&&qa(this.sag,this.target.position,A)),o=A}let c=ti(t("hand")),l=c.clone().add(new U(.07,.03,.35));this.stream.visible=s,qa(this.stream,l,l.clone().setZ(c.z-.05)),this.bag.visible=this.string.visible=n,n&&(this.bag.position.copy(ti(t("bag"))),this.string.geometry.setFromPoints([c,this.bag.position])),this.push.show(c,e),this.felt.show(c,this.believes?ti(t("force")):new U);let h=t("mean"),f=t("com_covariance");this.belief.visible=this.believes&&t("held")[0]>.5&&Math.max(f[0],f[4],f[8])<Kh*Kh;let d=2*Math.sqrt(f[0]),m=2*f[1]/Math.sqrt(f[0]),g=2*f[2]/Math.sqrt(f[0]),S=Math.sqrt(Math.max(4*f[4]-m*m,1e-8)),p=(4*f[5]-m*g)/S,u=Math.sqrt(Math.max(4*f[8]-g*g-p*p,1e-8));this.belief.matrix.set(d,0,0,h[1],m,S,0,h[2],g,p,u,h[3],0,0,0,1),this.belief.matrixWorldNeedsUpdate=!0}hold(t){this.objects.clear();for(let{mass:e,com:n,kind:s}of t){let r=.05*Math.cbrt(Math.max(e,.05)),a=s==="cup"?On(.045,.03+.06*e,jg):On(r,1.6*r,Kg);a.position.copy(ti(n)),a.add(new Oi(new gs(a.geometry,30),e0)),this.objects.add(a)}}};function s0(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;return t!==void 0&&/swiftshader|llvmpipe|software/i.test(i.getParameter(t))}var Ka=class{constructor(t){this.canvas=t,this.renderer=new Ga({canvas:t,antialias:!s0()}),this.scene=new ls,this.scene.background=new Ut("#f4f6f8"),this.camera=new Le(32,1,.1,10),this.camera.up.copy(Ya),this.azimuth=0,this.elevation=12*Xa;let e=new Ts("#ffffff",2);e.position.set(2,-1,3);let n=new Es(3,15,"#b8c0cc","#dde2e8");n.rotation.x=Math.PI/2,this.arms={without:new Ja(-Zh,!1),with:new Ja(Zh,!0)},this.wall=new pe(new hi(1,1.1,5,5),new $e({color:"#37474f",wireframe:!0})),this.wall.rotation.x=Math.PI/2,this.scene.add(new Ms("#ffffff","#b0b6bf",2),e,n,...Object.values(this.arms)),this.walls=Object.values(this.arms).map(s=>{let r=this.wall.clone();return s.add(r),r}),this.ratio=Math.min(devicePixelRatio,2),this.interval=this.drawn=0,this.resize(),new ResizeObserver(()=>this.resize()).observe(t)}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.look())}look(){let t=Math.tan(this.camera.fov*Xa/2),e=Math.max(.58/t,.98/(t*this.camera.aspect))+.45,n=new U(.15,.18,.45),s=Math.cos(this.elevation);this.camera.position.set(s*Math.cos(this.azimuth),s*Math.sin(this.azimuth),Math.sin(this.elevation)).multiplyScalar(e).add(n),this.camera.lookAt(n),this.camera.updateMatrixWorld()}turn(t,e){this.azimuth=Math.min(Math.max(this.azimuth-.006*t,-1.2),1.2),this.elevation=Math.min(Math.max(this.elevation+.006*e,0),1.2),this.look()}handAt(t){let n=this.arms[t].flange.localToWorld(new U(0,0,.1)).project(this.camera);return{x:(n.x+1)/2*this.canvas.clientWidth,y:(1-n.y)/2*this.canvas.clientHeight}}inArms(t,e){let n=this.camera.position.distanceTo(this.arms.with.position),s=2*Math.tan(this.camera.fov*Xa/2)*n/this.canvas.clientHeight,r=new Qt().extractRotation(this.camera.matrixWorld);return new U(t*s,-e*s,0).applyMatrix4(r).applyAxisAngle(Ya,-Qh)}draw(t,e){let n=JSON.stringify(e);for(let[r,a]of Object.entries(this.arms))a.update(o=>t(`${r}.${o}`),ti(t("push")),t("hanging")[0]!==0,t("pour")[0]>0),n!==this.held&&a.hold(e);this.held=n;let s=t("wall_at");for(let r of this.walls)r.visible=t("constrained")[0]!==0,r.position.set(.4,s[0]+.1,.5);this.renderer.render(this.scene,this.camera),this.adapt()}adapt(){let t=performance.now(),e=t-this.drawn;this.drawn=t,e<1e3&&(this.interval+=(e-this.interval)/10),!(this.interval<45||this.ratio<.6)&&(this.interval=0,this.ratio*=.8,this.resize())}};var eu=["hand is empty","holds it steadily","is being filled","something pushes","payload is changing"],$h=["","attached","exchanged","removed","filled","only a push"],Cl=300,r0=100,Xe=i=>document.getElementById(i),zs=new Worker(URL.createObjectURL(new Blob([Wl],{type:"text/javascript"}))),Rl=new Hs,Il,_l,$a,hn=0,Ll=1,Qa=0,to=[],ks=[],eo=!0,tu=!1,Pl=0,ja=-1,ue=i=>{let[t,e]=Il[i];return _l.subarray(t,t+e)},nu=i=>zs.postMessage({command:i});function a0(i){eo=!1,nu(i)}zs.onmessage=({data:i})=>{if(i.fields&&(Il=i.fields,to=[],ks=[],Pl=0,Rl.clear()),i.frames){for(_l of i.frames)Rl.add(ue);hn=i.ticks,i.busy&&(Qa+=(i.busy-Qa)*.05),eo&&l0()}i.command&&(i.accepted?o0(i.command,i.at):gi("A Panda is rated for 3 kg: that would be too much.")),i.paused&&au()};function o0(i,t){to.push(`${t} ${i}`);let[e,...n]=i.split(" ");e==="attach"&&ks.push({kind:+n[0]===Ji?"cup":"weight",mass:+n[0],com:n.slice(1).map(Number)}),e==="drop"&&(ks=[])}function l0(){!tu&&hn>=Cl&&nu(ro(1.2,0)),tu=hn>=Cl,hn<Cl?gi("Both hands are empty."):hn<4e3?gi("Both hands were given 1.2 kg. Nobody told the arms."):gi("Your turn: drag a weight onto a hand, or pull at a hand.")}function gi(i){Xe("caption").textContent!==i&&(Xe("caption").textContent=i)}function Ue(i,t,e,n=""){let s=Xe(i);s.dataset.value=t;let r=t.toFixed(e)+n;s.textContent!==r&&(s.textContent=r)}function iu(){let i=ue("with.mean"),t=ue("with.deviation"),e=ue("with.payload"),n=g=>Math.hypot(...g);Ue("error-without",1e3*n(ue("without.error")),1),Ue("error-with",1e3*n(ue("with.error")),1),Ue("mass",i[0],3),Ue("mass-deviation",t[0],3),Ue("truth",e[0],3);for(let g=0;g<3;++g)Ue(`com-${g}`,1e3*i[g+1],1),Ue(`com-deviation-${g}`,1e3*t[g+1],1),Ue(`com-truth-${g}`,1e3*e[g+1],1);let s=ue("with.probability"),r=s.indexOf(Math.max(...s));eu.forEach((g,S)=>{let p=Xe("modes").children[S];p.classList.toggle("likeliest",S===r),p.querySelector("i").style.width=`${100*s[S]}%`,Ue(`mode-${S}`,100*s[S],1," %")}),[...ue("with.force"),...ue("with.moment")].forEach((g,S)=>{let p=Math.max(-1,Math.min(1,g/(S<3?40:4))),u=Xe("wrench").children[S].querySelector("i");u.style.left=`${50+50*Math.min(p,0)}%`,u.style.width=`${50*Math.abs(p)}%`,Ue(`wrench-${S}`,g,S<3?1:2,S<3?" N":" N m")});let o=ue("with.health")[0],[c,l]=ue("with.limit");Ue("health",o,1),Xe("health-word").textContent=o<3?"good":"not explained",Ue("confidence",100*ue("with.confidence")[0],0," %"),Ue("friction",100*ue("with.friction_shows")[0],0," %"),Ue("wall",1e3*ue("with.wall")[0],0," mm"),Xe("limit").textContent=`joint ${c}, ${(l*180/Math.PI).toFixed(0)}\xB0 away`,Qa>0&&Ue("speed",1/Qa,1);let[h,f,d,m]=ue("with.event");ue("with.changing")[0]?Xe("noticed").textContent="something is happening":h>0&&(Xe("noticed").textContent=`${$h[f]}: noticed ${Math.round(1e3*(m-d))} ms after it began`),h>Pl&&!eo&&gi(`rme: ${$h[f]}, ${i[0].toFixed(2)} kg.`),Pl=h}function su(){requestAnimationFrame(su),_l&&($a?.draw(ue,ks.map(i=>i.kind==="cup"?{...i,mass:ue("poured")[0]}:i)),!(ja>=0&&hn>=ja&&hn<ja+r0)&&(ja=hn,iu(),ql(Xe("history"),Rl)))}function ru(i,t,e){for(let[n,s]of t.entries())Xe(i).insertAdjacentHTML("beforeend",`<li><span>${s}</span><span class="bar"><i></i></span><output id="${e}-${n}"></output></li>`)}Xe("save").addEventListener("click",()=>{let i=document.createElement("a");i.href=URL.createObjectURL(new Blob([to.join(`
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
