(()=>{var Wl=`(()=>{var qe=(()=>{var c=typeof document<"u"&&document.currentScript?document.currentScript.src:void 0;return(function(n){n=n||{};var n=typeof n<"u"?n:{},Y,X;n.ready=new Promise(function(t,e){Y=t,X=e});var pt=Object.assign({},n),Tt=[],yt="./this.program",bt=(t,e)=>{throw e},Pt=!1,q=!0,R="";function Gt(t){return n.locateFile?n.locateFile(t,R):R+t}var Nt,Jt,rt,Kt;(Pt||q)&&(q?R=self.location.href:typeof document<"u"&&document.currentScript&&(R=document.currentScript.src),c&&(R=c),R.indexOf("blob:")!==0?R=R.substr(0,R.replace(/[?#].*/,"").lastIndexOf("/")+1):R="",Nt=(t=>{var e=new XMLHttpRequest;return e.open("GET",t,!1),e.send(null),e.responseText}),q&&(rt=(t=>{var e=new XMLHttpRequest;return e.open("GET",t,!1),e.responseType="arraybuffer",e.send(null),new Uint8Array(e.response)})),Jt=((t,e,r)=>{var a=new XMLHttpRequest;a.open("GET",t,!0),a.responseType="arraybuffer",a.onload=(()=>{if(a.status==200||a.status==0&&a.response){e(a.response);return}r()}),a.onerror=r,a.send(null)}),Kt=(t=>document.title=t));var Vt=n.print||console.log.bind(console),L=n.printErr||console.warn.bind(console);Object.assign(n,pt),pt=null,n.arguments&&(Tt=n.arguments),n.thisProgram&&(yt=n.thisProgram),n.quit&&(bt=n.quit);var _e=4;function C(t){C.shown||(C.shown={}),C.shown[t]||(C.shown[t]=1,L(t))}function $e(t,e){if(typeof WebAssembly.Function=="function"){for(var r={i:"i32",j:"i64",f:"f32",d:"f64"},a={parameters:[],results:e[0]=="v"?[]:[r[e[0]]]},u=1;u<e.length;++u)a.parameters.push(r[e[u]]);return new WebAssembly.Function(a,t)}var l=[1,0,1,96],f=e.slice(0,1),s=e.slice(1),d={i:127,j:126,f:125,d:124};l.push(s.length);for(var u=0;u<s.length;++u)l.push(d[s[u]]);f=="v"?l.push(0):l=l.concat([1,d[f]]),l[1]=l.length-2;var b=new Uint8Array([0,97,115,109,1,0,0,0].concat(l,[2,7,1,1,101,1,102,0,0,7,5,1,1,102,0,0])),P=new WebAssembly.Module(b),j=new WebAssembly.Instance(P,{e:{f:t}}),y=j.exports.f;return y}var gt=[],It;function tn(){if(gt.length)return gt.pop();try{Z.grow(1)}catch(t){throw t instanceof RangeError?"Unable to grow wasm table. Set ALLOW_TABLE_GROWTH.":t}return Z.length-1}function en(t,e){for(var r=t;r<t+e;r++){var a=ft(r);a&&It.set(a,r)}}var nn=0,S;n.wasmBinary&&(S=n.wasmBinary);var qt=n.noExitRuntime||!0;typeof WebAssembly!="object"&&U("no native wasm support detected");var Q,it=!1,Ht;function rn(t,e){t||U(e)}function Ct(t){var e=n["_"+t];return e}function Qt(t,e,r,a,u){var l={string:function(p){var x=0;if(p!=null&&p!==0){var J=(p.length<<2)+1;x=ct(J),At(p,x,J)}return x},array:function(p){var x=ct(p.length);return xt(p,x),x}};function f(p){return e==="string"?A(p):e==="boolean"?!!p:p}var s=Ct(t),d=[],b=0;if(a)for(var P=0;P<a.length;P++){var j=l[r[P]];j?(b===0&&(b=Et()),d[P]=j(a[P])):d[P]=a[P]}var y=s.apply(null,d);function w(p){return b!==0&&zt(b),f(p)}return y=w(y),y}var an=1,Rt=typeof TextDecoder<"u"?new TextDecoder("utf8"):void 0;function wt(t,e,r){for(var a=e+r,u=e;t[u]&&!(u>=a);)++u;if(u-e>16&&t.subarray&&Rt)return Rt.decode(t.subarray(e,u));for(var l="";e<u;){var f=t[e++];if(!(f&128)){l+=String.fromCharCode(f);continue}var s=t[e++]&63;if((f&224)==192){l+=String.fromCharCode((f&31)<<6|s);continue}var d=t[e++]&63;if((f&240)==224?f=(f&15)<<12|s<<6|d:f=(f&7)<<18|s<<12|d<<6|t[e++]&63,f<65536)l+=String.fromCharCode(f);else{var b=f-65536;l+=String.fromCharCode(55296|b>>10,56320|b&1023)}}return l}function A(t,e){return t?wt(k,t,e):""}function Wt(t,e,r,a){if(!(a>0))return 0;for(var u=r,l=r+a-1,f=0;f<t.length;++f){var s=t.charCodeAt(f);if(s>=55296&&s<=57343){var d=t.charCodeAt(++f);s=65536+((s&1023)<<10)|d&1023}if(s<=127){if(r>=l)break;e[r++]=s}else if(s<=2047){if(r+1>=l)break;e[r++]=192|s>>6,e[r++]=128|s&63}else if(s<=65535){if(r+2>=l)break;e[r++]=224|s>>12,e[r++]=128|s>>6&63,e[r++]=128|s&63}else{if(r+3>=l)break;e[r++]=240|s>>18,e[r++]=128|s>>12&63,e[r++]=128|s>>6&63,e[r++]=128|s&63}}return e[r]=0,r-u}function At(t,e,r){return Wt(t,k,e,r)}function _t(t){for(var e=0,r=0;r<t.length;++r){var a=t.charCodeAt(r);a>=55296&&a<=57343&&(a=65536+((a&1023)<<10)|t.charCodeAt(++r)&1023),a<=127?++e:a<=2047?e+=2:a<=65535?e+=3:e+=4}return e}var on=typeof TextDecoder<"u"?new TextDecoder("utf-16le"):void 0;function xt(t,e){O.set(t,e)}function $t(t,e,r){for(var a=0;a<t.length;++a)O[e++>>0]=t.charCodeAt(a);r||(O[e>>0]=0)}var Ot,O,k,te,ee,v,ne,re,ie;function ht(t){Ot=t,n.HEAP8=O=new Int8Array(t),n.HEAP16=te=new Int16Array(t),n.HEAP32=v=new Int32Array(t),n.HEAPU8=k=new Uint8Array(t),n.HEAPU16=ee=new Uint16Array(t),n.HEAPU32=ne=new Uint32Array(t),n.HEAPF32=re=new Float32Array(t),n.HEAPF64=ie=new Float64Array(t)}var fn=n.INITIAL_MEMORY||16777216,Z,Yt=[],Lt=[],Mt=[],ae=!1,oe=!1,fe=0;function se(){return qt||fe>0}function ue(){if(n.preRun)for(typeof n.preRun=="function"&&(n.preRun=[n.preRun]);n.preRun.length;)me(n.preRun.shift());ot(Yt)}function le(){ae=!0,ot(Lt)}function sn(){oe=!0}function ce(){if(n.postRun)for(typeof n.postRun=="function"&&(n.postRun=[n.postRun]);n.postRun.length;)de(n.postRun.shift());ot(Mt)}function me(t){Yt.unshift(t)}function ve(t){Lt.unshift(t)}function de(t){Mt.unshift(t)}var M=0,at=null,D=null;function pe(t){M++,n.monitorRunDependencies&&n.monitorRunDependencies(M)}function Te(t){if(M--,n.monitorRunDependencies&&n.monitorRunDependencies(M),M==0&&(at!==null&&(clearInterval(at),at=null),D)){var e=D;D=null,e()}}n.preloadedImages={},n.preloadedAudios={};function U(t){n.onAbort&&n.onAbort(t),t="Aborted("+t+")",L(t),it=!0,Ht=1,t+=". Build with -s ASSERTIONS=1 for more info.";var e=new WebAssembly.RuntimeError(t);throw X(e),e}var ye="data:application/octet-stream;base64,";function jt(t){return t.startsWith(ye)}var g;g="live.wasm",jt(g)||(g=Gt(g));function Ft(t){try{if(t==g&&S)return new Uint8Array(S);if(rt)return rt(t);throw"both async and sync fetching of the wasm failed"}catch(e){U(e)}}function be(){return!S&&(Pt||q)&&typeof fetch=="function"?fetch(g,{credentials:"same-origin"}).then(function(t){if(!t.ok)throw"failed to load wasm binary file at '"+g+"'";return t.arrayBuffer()}).catch(function(){return Ft(g)}):Promise.resolve().then(function(){return Ft(g)})}function Pe(){var t={env:Bt,wasi_snapshot_preview1:Bt};function e(f,s){var d=f.exports;n.asm=d,Q=n.asm.memory,ht(Q.buffer),Z=n.asm.__indirect_function_table,ve(n.asm.__wasm_call_ctors),Te("wasm-instantiate")}pe("wasm-instantiate");function r(f){e(f.instance)}function a(f){return be().then(function(s){return WebAssembly.instantiate(s,t)}).then(function(s){return s}).then(f,function(s){L("failed to asynchronously prepare wasm: "+s),U(s)})}function u(){return!S&&typeof WebAssembly.instantiateStreaming=="function"&&!jt(g)&&typeof fetch=="function"?fetch(g,{credentials:"same-origin"}).then(function(f){var s=WebAssembly.instantiateStreaming(f,t);return s.then(r,function(d){return L("wasm streaming compile failed: "+d),L("falling back to ArrayBuffer instantiation"),a(r)})}):a(r)}if(n.instantiateWasm)try{var l=n.instantiateWasm(t,e);return l}catch(f){return L("Module.instantiateWasm callback failed with error: "+f),!1}return u().catch(X),{}}var un,ln;function ot(t){for(;t.length>0;){var e=t.shift();if(typeof e=="function"){e(n);continue}var r=e.func;typeof r=="number"?e.arg===void 0?ft(r)():ft(r)(e.arg):r(e.arg===void 0?null:e.arg)}}function cn(t){return t}function mn(t){var e=/\\b_Z[\\w\\d_]+/g;return t.replace(e,function(r){var a=r;return r===a?r:a+" ["+r+"]"})}var G=[];function ft(t){var e=G[t];return e||(t>=G.length&&(G.length=t+1),G[t]=e=Z.get(t)),e}function vn(){var t=new Error;if(!t.stack){try{throw new Error}catch(e){t=e}if(!t.stack)return"(no stack trace available)"}return t.stack.toString()}function dn(t,e){Z.set(t,e),G[t]=e}function ge(t){return Xt(t+16)+16}function He(t){this.excPtr=t,this.ptr=t-16,this.set_type=function(e){v[this.ptr+4>>2]=e},this.get_type=function(){return v[this.ptr+4>>2]},this.set_destructor=function(e){v[this.ptr+8>>2]=e},this.get_destructor=function(){return v[this.ptr+8>>2]},this.set_refcount=function(e){v[this.ptr>>2]=e},this.set_caught=function(e){e=e?1:0,O[this.ptr+12>>0]=e},this.get_caught=function(){return O[this.ptr+12>>0]!=0},this.set_rethrown=function(e){e=e?1:0,O[this.ptr+13>>0]=e},this.get_rethrown=function(){return O[this.ptr+13>>0]!=0},this.init=function(e,r){this.set_type(e),this.set_destructor(r),this.set_refcount(0),this.set_caught(!1),this.set_rethrown(!1)},this.add_ref=function(){var e=v[this.ptr>>2];v[this.ptr>>2]=e+1},this.release_ref=function(){var e=v[this.ptr>>2];return v[this.ptr>>2]=e-1,e===1}}var Re=0,we=0;function We(t,e,r){var a=new He(t);throw a.init(e,r),Re=t,we++,t}function xe(){U("")}function Oe(t,e,r){k.copyWithin(t,e,e+r)}function he(){return 2147483648}function Ye(t){try{return Q.grow(t-Ot.byteLength+65535>>>16),ht(Q.buffer),1}catch{}}function Le(t){var e=k.length;t=t>>>0;var r=he();if(t>r)return!1;let a=(d,b)=>d+(b-d%b)%b;for(var u=1;u<=4;u*=2){var l=e*(1+.2/u);l=Math.min(l,t+100663296);var f=Math.min(r,a(Math.max(t,l),65536)),s=Ye(f);if(s)return!0}return!1}var st={};function Me(){return yt||"./this.program"}function N(){if(!N.strings){var t=(typeof navigator=="object"&&navigator.languages&&navigator.languages[0]||"C").replace("-","_")+".UTF-8",e={USER:"web_user",LOGNAME:"web_user",PATH:"/",PWD:"/",HOME:"/home/web_user",LANG:t,_:Me()};for(var r in st)st[r]===void 0?delete e[r]:e[r]=st[r];var a=[];for(var r in e)a.push(r+"="+e[r]);N.strings=a}return N.strings}var ut={buffers:[null,[],[]],printChar:function(t,e){var r=ut.buffers[t];e===0||e===10?((t===1?Vt:L)(wt(r,0)),r.length=0):r.push(e)},varargs:void 0,get:function(){ut.varargs+=4;var t=v[ut.varargs-4>>2];return t},getStr:function(t){var e=A(t);return e},get64:function(t,e){return t}};function je(t,e){var r=0;return N().forEach(function(a,u){var l=e+r;v[t+u*4>>2]=l,$t(a,l),r+=a.length+1}),0}function Fe(t,e){var r=N();v[t>>2]=r.length;var a=0;return r.forEach(function(u){a+=u.length+1}),v[e>>2]=a,0}function _(t){return t%4===0&&(t%100!==0||t%400===0)}function lt(t,e){for(var r=0,a=0;a<=e;r+=t[a++]);return r}var $=[31,29,31,30,31,30,31,31,30,31,30,31],tt=[31,28,31,30,31,30,31,31,30,31,30,31];function et(t,e){for(var r=new Date(t.getTime());e>0;){var a=_(r.getFullYear()),u=r.getMonth(),l=(a?$:tt)[u];if(e>l-r.getDate())e-=l-r.getDate()+1,r.setDate(1),u<11?r.setMonth(u+1):(r.setMonth(0),r.setFullYear(r.getFullYear()+1));else return r.setDate(r.getDate()+e),r}return r}function Be(t,e,r,a){var u=v[a+40>>2],l={tm_sec:v[a>>2],tm_min:v[a+4>>2],tm_hour:v[a+8>>2],tm_mday:v[a+12>>2],tm_mon:v[a+16>>2],tm_year:v[a+20>>2],tm_wday:v[a+24>>2],tm_yday:v[a+28>>2],tm_isdst:v[a+32>>2],tm_gmtoff:v[a+36>>2],tm_zone:u?A(u):""},f=A(r),s={"%c":"%a %b %d %H:%M:%S %Y","%D":"%m/%d/%y","%F":"%Y-%m-%d","%h":"%b","%r":"%I:%M:%S %p","%R":"%H:%M","%T":"%H:%M:%S","%x":"%m/%d/%y","%X":"%H:%M:%S","%Ec":"%c","%EC":"%C","%Ex":"%m/%d/%y","%EX":"%H:%M:%S","%Ey":"%y","%EY":"%Y","%Od":"%d","%Oe":"%e","%OH":"%H","%OI":"%I","%Om":"%m","%OM":"%M","%OS":"%S","%Ou":"%u","%OU":"%U","%OV":"%V","%Ow":"%w","%OW":"%W","%Oy":"%y"};for(var d in s)f=f.replace(new RegExp(d,"g"),s[d]);var b=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"],P=["January","February","March","April","May","June","July","August","September","October","November","December"];function j(i,o,T){for(var m=typeof i=="number"?i.toString():i||"";m.length<o;)m=T[0]+m;return m}function y(i,o){return j(i,o,"0")}function w(i,o){function T(W){return W<0?-1:W>0?1:0}var m;return(m=T(i.getFullYear()-o.getFullYear()))===0&&(m=T(i.getMonth()-o.getMonth()))===0&&(m=T(i.getDate()-o.getDate())),m}function p(i){switch(i.getDay()){case 0:return new Date(i.getFullYear()-1,11,29);case 1:return i;case 2:return new Date(i.getFullYear(),0,3);case 3:return new Date(i.getFullYear(),0,2);case 4:return new Date(i.getFullYear(),0,1);case 5:return new Date(i.getFullYear()-1,11,31);case 6:return new Date(i.getFullYear()-1,11,30)}}function x(i){var o=et(new Date(i.tm_year+1900,0,1),i.tm_yday),T=new Date(o.getFullYear(),0,4),m=new Date(o.getFullYear()+1,0,4),W=p(T),h=p(m);return w(W,o)<=0?w(h,o)<=0?o.getFullYear()+1:o.getFullYear():o.getFullYear()-1}var J={"%a":function(i){return b[i.tm_wday].substring(0,3)},"%A":function(i){return b[i.tm_wday]},"%b":function(i){return P[i.tm_mon].substring(0,3)},"%B":function(i){return P[i.tm_mon]},"%C":function(i){var o=i.tm_year+1900;return y(o/100|0,2)},"%d":function(i){return y(i.tm_mday,2)},"%e":function(i){return j(i.tm_mday,2," ")},"%g":function(i){return x(i).toString().substring(2)},"%G":function(i){return x(i)},"%H":function(i){return y(i.tm_hour,2)},"%I":function(i){var o=i.tm_hour;return o==0?o=12:o>12&&(o-=12),y(o,2)},"%j":function(i){return y(i.tm_mday+lt(_(i.tm_year+1900)?$:tt,i.tm_mon-1),3)},"%m":function(i){return y(i.tm_mon+1,2)},"%M":function(i){return y(i.tm_min,2)},"%n":function(){return\`
\`},"%p":function(i){return i.tm_hour>=0&&i.tm_hour<12?"AM":"PM"},"%S":function(i){return y(i.tm_sec,2)},"%t":function(){return"	"},"%u":function(i){return i.tm_wday||7},"%U":function(i){var o=new Date(i.tm_year+1900,0,1),T=o.getDay()===0?o:et(o,7-o.getDay()),m=new Date(i.tm_year+1900,i.tm_mon,i.tm_mday);if(w(T,m)<0){var W=lt(_(m.getFullYear())?$:tt,m.getMonth()-1)-31,h=31-T.getDate(),F=h+W+m.getDate();return y(Math.ceil(F/7),2)}return w(T,o)===0?"01":"00"},"%V":function(i){var o=new Date(i.tm_year+1900,0,4),T=new Date(i.tm_year+1901,0,4),m=p(o),W=p(T),h=et(new Date(i.tm_year+1900,0,1),i.tm_yday);if(w(h,m)<0)return"53";if(w(W,h)<=0)return"01";var F;return m.getFullYear()<i.tm_year+1900?F=i.tm_yday+32-m.getDate():F=i.tm_yday+1-m.getDate(),y(Math.ceil(F/7),2)},"%w":function(i){return i.tm_wday},"%W":function(i){var o=new Date(i.tm_year,0,1),T=o.getDay()===1?o:et(o,o.getDay()===0?1:7-o.getDay()+1),m=new Date(i.tm_year+1900,i.tm_mon,i.tm_mday);if(w(T,m)<0){var W=lt(_(m.getFullYear())?$:tt,m.getMonth()-1)-31,h=31-T.getDate(),F=h+W+m.getDate();return y(Math.ceil(F/7),2)}return w(T,o)===0?"01":"00"},"%y":function(i){return(i.tm_year+1900).toString().substring(2)},"%Y":function(i){return i.tm_year+1900},"%z":function(i){var o=i.tm_gmtoff,T=o>=0;return o=Math.abs(o)/60,o=o/60*100+o%60,(T?"+":"-")+("0000"+o).slice(-4)},"%Z":function(i){return i.tm_zone},"%%":function(){return"%"}};f=f.replace(/%%/g,"\\0\\0");for(var d in J)f.includes(d)&&(f=f.replace(new RegExp(d,"g"),J[d](l)));f=f.replace(/\\0\\0/g,"%");var vt=Ee(f,!1);return vt.length>e?0:(xt(vt,t),vt.length-1)}function Xe(t,e,r,a){return Be(t,e,r,a)}var pn=!1;function Ee(t,e,r){var a=r>0?r:_t(t)+1,u=new Array(a),l=Wt(t,u,0,u.length);return e&&(u.length=l),u}var Bt={__cxa_allocate_exception:ge,__cxa_throw:We,abort:xe,emscripten_memcpy_big:Oe,emscripten_resize_heap:Le,environ_get:je,environ_sizes_get:Fe,strftime_l:Xe},Tn=Pe(),ze=n.___wasm_call_ctors=function(){return(ze=n.___wasm_call_ctors=n.asm.__wasm_call_ctors).apply(null,arguments)},Se=n._live_start=function(){return(Se=n._live_start=n.asm.live_start).apply(null,arguments)},ke=n._live_command=function(){return(ke=n._live_command=n.asm.live_command).apply(null,arguments)},Ze=n._live_step=function(){return(Ze=n._live_step=n.asm.live_step).apply(null,arguments)},De=n._live_values=function(){return(De=n._live_values=n.asm.live_values).apply(null,arguments)},Ue=n._live_layout=function(){return(Ue=n._live_layout=n.asm.live_layout).apply(null,arguments)},Xt=n._malloc=function(){return(Xt=n._malloc=n.asm.malloc).apply(null,arguments)},Ge=n.___errno_location=function(){return(Ge=n.___errno_location=n.asm.__errno_location).apply(null,arguments)},Et=n.stackSave=function(){return(Et=n.stackSave=n.asm.stackSave).apply(null,arguments)},zt=n.stackRestore=function(){return(zt=n.stackRestore=n.asm.stackRestore).apply(null,arguments)},ct=n.stackAlloc=function(){return(ct=n.stackAlloc=n.asm.stackAlloc).apply(null,arguments)},Ne=n.dynCall_viijii=function(){return(Ne=n.dynCall_viijii=n.asm.dynCall_viijii).apply(null,arguments)},Je=n.dynCall_iiiiij=function(){return(Je=n.dynCall_iiiiij=n.asm.dynCall_iiiiij).apply(null,arguments)},Ke=n.dynCall_iiiiijj=function(){return(Ke=n.dynCall_iiiiijj=n.asm.dynCall_iiiiijj).apply(null,arguments)},Ve=n.dynCall_iiiiiijj=function(){return(Ve=n.dynCall_iiiiiijj=n.asm.dynCall_iiiiiijj).apply(null,arguments)};n.ccall=Qt;var nt;function Ie(t){this.name="ExitStatus",this.message="Program terminated with exit("+t+")",this.status=t}D=function t(){nt||mt(),nt||(D=t)};function mt(t){if(t=t||Tt,M>0||(ue(),M>0))return;function e(){nt||(nt=!0,n.calledRun=!0,!it&&(le(),Y(n),n.onRuntimeInitialized&&n.onRuntimeInitialized(),ce()))}n.setStatus?(n.setStatus("Running..."),setTimeout(function(){setTimeout(function(){n.setStatus("")},1),e()},1)):e()}n.run=mt;function yn(t){Ht=t,se()||(n.onExit&&n.onExit(t),it=!0),bt(t,new Ie(t))}if(n.preInit)for(typeof n.preInit=="function"&&(n.preInit=[n.preInit]);n.preInit.length>0;)n.preInit.pop()();return mt(),n.ready})})(),St=qe;var kt="H4sIAAAAAAACA+y9eZgcx3UnGEdmHZ3V3dlAA2igcUQmIaCAxtGgLDSagtgdEAnBs+sxdmY/L779Pi0AgaDBAg+QhGR4BoMuiqRclrhWeSxZJdoyCw16VDrMKUuyXaJks0haYlGmrdJdEkGwKGvI0kikyzYll44RF+9FZGZUdgPq2dXs/rNFovO9X9yRkfFeRLyIIEfvvo0SQmjNessROkfnjtA5coTNqT907gifAxr+0rkjiTn80bkj1hzidsArggQ+iPJA546k5ubCQPQsPXskGfEEA547d+4cOUJI6KKjPYeZoWeBOxdFee4InzurubPwOHdujhwZmJszEsJcnIMIVJxI2nNzZ8OynAU/Z5FnZyFb7CyAbO4clOGsjiczN9cXL+brLJ074vTjRurkyPBc/49EdUCO0LOQgXOYjbNndX3p4gCP+T17VhcbS2jPKScsMD2LPlX4OV1AVQ5LFS9tJMzQCz+rywahKVQFw5qDigdn9WBYt+zcOfof8O9ZqKhz5Ag7F7zvc1j3c3P0PxiJ0DnWoil+/PZ3jB0+fOzM0cNHb731jmNHTx8/fPzMseOnTt9yx+2EgLOjnE+fuOuO3yAWICuO33b3sbtuOXX6+O2Hbzt+27FTv3n4bbf8OrHBbaXhdtfxu2/5d8cPnzh+9JSKyj76tjvuOk1GVv7G0btvOXz37UdP3X3ijtOHT911/B23HP+NXSPHb3/HLXfdcfthCHb34V8/fprwK3h1Aq/oCeIeuPv0XTefvuW244dvJSn+pP24PUIppVvJCB0enlg1yuhYgrFtlKU55dyy6CpKtzOLUYtwajHK0mm2Y2dyPZ0ku8aS1yYsy7IYtyxrwLIopzRpWdYqa3TMGqEM/ktazLK4ZbHXWxZjzKa/xNgbNrCkRenuDcPUstLr0pQxRuhUMpkcSA6KPdODtmUPXjc6Ogg/8UZvkAwTyhkh+CUTyuwVftLmFiGEcBselDJCCSec2AQ8ckI41ywnhNmMEAJ5oYRZhADHCecr+AihSYiSM6aCMMaApoz4hKxmq11375uud5m72nXd5MysdPZx2+aEQ8ReyiLWm9PXMMfm3KHEITesXJmkqaRlw78EYWyIc5txTkmCWGucZGJlwkk4iZWJ9MYbE+sTyURy2LY5TZAhnuDWmgT80hsTiUTSJoSlCOGUp5Ipe1mC2XR5avnrbGcZGU+lCE0BBMiy8VSGk0QiMZAYSKRTmQyP6KEBxoewTJCVTfCehoCE0gM/BE/C15LNWWYn1m7OJuyBAUKhignjlELFUgbtw3Ych9vcduwUoZrIpFI0Y2dSKUJSJJNR/yi8JKZ/+LIQWuQ/SoYJJ5QxTuC94CsB/xx+W0jasiyb2VvSjCVt20omkzyZtNID6XR6ADJJCB2mZNnQ/jVWkp6in2GfYXaS0jzL51kiTeeobD78BHGS/5GNJG47ftsdd/0mIyOHD//G0btvO3zs6K23Hj52+o677iapgVtvecfxw3efPnrXaTKYQebYHbfddvT2m8hQWrsdP0VcB+l3HL317cfvJiOKu/Xob97x9tNk2erDh2+5/aZb7jp+7PThm99++zHoFQ6fPvq2W49TkrgNewzyJ9Q9fPj4XXfdfsdh7ECg4/g4Td99+uixk//26DuOkyfsDDL/5vjdp++46zh50h5AXmLwv7aHbvrN298MGX/HLbfkbrmFfC5CboFfjnzeHu5HcuQp2+2DAGvY6Z5FiaTOoyztZOr20/Q++jv0vbRAa/TT9FH6GfpZ+lf0E/QT9DH6JP1r+nn6FP08/QJ9hv4N/Vv6LvZb7F5WYD+jr9F72G+zd7P3sAfYH7IPsUfZ0+wL7Bn2CP0k/aj1ces71ovWd63vWS9b/2D9o/XP1g+sf7F+ZP3E+m/Wa9YF6z9ZH7Nq1qetR63PWJ+1/tJ6kf+V9ZhVt0rWX1ufs56ynra+YH2CPmP9rfU16+vWN61vWc9az1lt6xtWy/oH2qUXrUvWC9bTtMVa7E+sR6z/bFWtP7U+YX3S+pT1Iv8z68+tv7Ba7HHrcesJ61P0U/RJ61O0xf7O+qL1hAVla1pfslrsy9ZXNP9V60sY2zfZt9hFBtRz7BJrsxZ7gb3CXmU/ZD3WYz9mP2V5/k5+H2+x9/D38t/j7+Pv5+/nv88/wB/kf8D/kLfYPK/wP+Wf4J/kn+Kf5o/yFvsM/yv+JP9r/jn+ed7gT3OI/Rn+t/zv+Bf5l/hX+Nf531sd6/tWz/qp1bVetZT7N/m3+LP8Of48/zb/L9Z/tV6xfmz9zPon64fWPXbe/nsOf1/iLfZd/l3+X/G/7/FP0O/z718Be5m/rLFXrop1+Q95i+Wte60We7dVtFrsd633WS32fuv3rUcpPD9gPUqfpu+z78d6+iT9JP24/Vn70/Yjdot9xq7Z/9lusUftP7M/YbfYY3aL/aX9uF20H7cftweeenX14/ZjnLK5a4h0T/pkI2GzgshMThCZyrn2IJEPv48JkmUZyU5LK+f+CfXpbkYEvXGQAJ5CxJoFf1lGAq85SXYzEoDUTdw4SB1gEXcEkW5uI5H1V+l2QiS980ZrVtZepftqf/m+i3/07keef2xuihNZfZXuI0BULhN59espp3LgVH+VSnodIY5sIcSIbAZEIyDaAdF5lWIOriFyEssrCEQj1GNMkCAH35iZ4llB9v2kgsC3Zqa428+m+lkiu6/SG27G39dnBJFjOUHce6hs/UDntB0QnR/QfQ9+8sVnPvjJFy+qkIFLLyDyP4zqArwIIiehwgrvY7L0ewzqtv57TG6Fypwg8q9fpVlGPCSwfIJY8CJLr5CcOyAI/nuEOs4XKGVz8JIeeKtHBQG/D7xVUGtWYARM6ODMmhUMQgiKfy+/6UIYoqBDBC6lQ4FL6ZBywdiyzBqh+K6fvDa3jRBJDkCmsqx2rQopn/X68Kan8G3kn90Q7LgB6ISYKss5yubkV7HkPrFm4f0LVXZwhpcPLpgf+Yxi2H5rTlCbzwomR096RDCZPmlmgajEPCaIoG8ZJEE0jkcgDkHD+J3VRH7vVRoEhiYWZOwrA8yao+fYOUFuIPjrvvlYSBNy852Q2J9mqLOPOJ4tC89T9/22x64hsk5P+nQjEUzYkrjLJfW4YPgahS2pu1ww+amLNCfJGylknuxm1YtUMGg0NSBk/SLNYRMSTDYMumnQrYCWtR/B9wcfX+GH1L0X/pcdJ+feT8FJf1f5n2lPAhtnjapnVT8r+lnWz5J+Fqms/4gKKis0J6gs0pybE9T8vgrgU39C377cyvMG/4WZKX5GRXRKPU4Iug+/mWc++M8zU/yIbP4YYu8RiL1NVOzGZ3XIiBz6jIOR81eBP6CinTWiBXhPxH8P+EnZ/gmk08B0JlUy37/wwg++1P1xGzxkVTwiSu7LM9CVIOoasWGfob/v7k8hzrGcoG4OKhirWr8OjzuCyfZFmvMt2fwR3cIxIks2NJ0SFlQt0vA+e9AiWj+CPLp/QNfA236O5mT1x5GXBgAVA6gDUDaAFgA1A2gDUDeADgCNAGCzgkt65yC5ctPRLWeQ/P8N539sw4H2kr9Ec2FrwVaBr8sAgibTfQ46isKleKNpX4o1mtalWKNpXoo1ms6lWKPpXoo1mt4ls9Gonir/PJShTkGgaclFgRAMNQvssLXkovgPOtXvHWWvm0ueVYrKqigkE8T9GPW5PPXL1iybxWbp/KoFDzcnT93pJ6FvtcUqkZSgP5y5azdLiVXChrRWCb6bWRnqAHUdccQqzxYcdBVhCyI41IwjuLBzklxHiGAekcRLXkNkl5/0GXTU8qsfoLvZfQwq8AMoZPhu1qCCy8xJ0H2YbNBcTn4H3VC0Qq/9DBUsyxq0z5Pv+DY4jgobKpvmIKoxgVhG2PveWc7n22SKWQIyuZu5wpYiJ4nMuh+ia4Qt1+bcD1vCQVXp1BQ70Je7OlCYsfz7UIxx0Oc+bAkOqtGYerjqkRLcW6deVleLlx40mtRuloe4uhBDk2Jli5w/7A+IVb79FmtODLg/pSAqbP0cEHaWpaDKB4S9hYESluGOsN0fUo8K2/0R9VLqndqofKbkwK9gsJT7O0wMCCpS7uMU6uA6MixSYgAE4XDOfS+DtzYgByDESTGwnTi+I4lwREpQ90O2I2xUMTOsPzHHTMwRA+5/o37qlyFFaEyQS8ctMYhEOH0JO/0Ji5SkJyG1k5LmILDlpyQBf33JS2KLAQfaELzEbVBhWTbp2zJ1pzUnuBh2f0jFsPsjmtvNtkX8Dyn42+b+Ez4nbWE70r0TVG6Ovn0bPWGgYTHs/pi6P6F9wTFO95+p4NvJpOQQls9CaQ7gp/Haa6+9lnRfhfIhedKzM9RxhK3SsN1XqaNaaj1QL6jWNzRfAb5Gc0GNDmwkYkCmcqot+0Pu31F4Kyn4KIUTam9OlhH1LTkQG357DgD6QRwxJIbAE34ZOT+VZRnPwgbxIFOZFZawJPmfxz1bDMmxnDcoBuSnfp+5LzKPiwH3I5YkXorNcUh50IwMvk4ryzL+sLCyzH2LNSuGQeBiLizASJZtHCHEt+TcWwaJZBnmsFlhybHTcuzt/rAkB6B+sgxE8Gv0TklP57YTKgXUr8TG5ohh92EbmkfOS/2cDOy3ZsNksyOErFH5GJbwZjPQB6VQB6VeShLHs6Kq8QchOtUxDAlk/EF4ulg51l0iNX6X+wcMPhFoh+qdQX7w9cCnnHNfoD6HwgS5205caYNEJx5ns1z3piIJ9cQFm+CpaejCBZepyy3v4xRym4R+rEJ9+6TPJX+770ia81VPy351kIqk4JK93U+JpEj9T+P4/qAL6sF7/OVxP2XNiVTg2xIpyU+777dtSRw/KRzJT+d8J0w5ie45LyUcmcp5+FH9K2tWJKE/VF01EynVRIUDORRMJHezClXt2kbl/udXAIcyVamHZfs49Th8Gu5h4sgLK9wjIG0FA+VkNytTpGtA/6GiG0CXsLPM6RGYn3TXYyG8LJs1/1tEBkAWGH7pLMs+SwXbTp7EXKomKMmBcZl4CzhDqvJHy2XC/WNbef841S+Dn5QC/PAJTvzN4bjjphsHKYgvkRWbyxpNzR6/cdCCl4qV3GWKdKd5T5Nj0zzPBTM1pA4TzBz7tmN8CyqiwHNiM8gKBrXdYjn3nrBWmt8nOeXFPSeIfsHNWwWRLXTZwl016G0rj2M5P6k1CCI7ChM53w6xrsKyOT8VKjSqKiY48bL/o8qXvUL5Ot8C4R2WMPp4iOx+i5oF7AEblS3/LM2JqFgFYIMSZbjzf7vJWFGT+c6otBZtMu7VmgxUn4laizQiIosXaQ40fiv6RFLwfmUq5yexmyP4RjA6d63+PkTgRMCJoNMvqLAfHrpCYVPoBzvFy49gbgnGFlxnWL9irqokG4zkZ24aF9mwJo6NT3AyzZsX6S8ow68sv0KGx4K342Wx9rzNguAIH5uzv1W1Lhj+i81Ii+w0zgkQWQFQeyhHHmQJ6Kyii/AetJ8C0FEk+dt/QWV7cniRsoEzcdeJpLsOPv9wmgIn5H5x9froyqs1hL5XTMjNEG3AurPHMBX8st2j8AlfpLpT4lGnpDDX6KjgK09N8Ta+g55yh04r6KAIDtNhjARqThhTQ4FdkvOdEKw/p3qNEzo15adIc/5w6KetwALN+QMh2NIB81SNx1I5b5DNqeL3tWt5zGjWOEOV/ViGOqB3DP13zhPpeSxrIxGWVh0tPfC3tOpo6YG/pQf+ljHwt3Dgb+mBvxUb+Fuxgb/VP/C31MDfUgN/a+HA38KBv6UH/lb/wN+KDfyt2MDfUgN/KzbwtxYZ+Fs48LfUwN+KDfwtNfC3+gf+lhr4W/0Dfysa+Fsw8LcgPj16jiYABsWQLNJb/SGYA8jpKSMAGwGbQrYesEQMQmxDMAeQC5ok+Kj+WPs4hWwlYE8gWw7YI8jWAvaMij1g81QlHvAF+AZgikJEnwxMUIj41wKTEwQnJ4TxocDUhIg+EZiYENHHAdMS5sdxyWzyBOckRPRFwIyECL8amPTNPw9j5Od/YV34sqt1NaqzCb+0t/n8OvJnF0HIDl5DZNM+6ac3EpH01Yx7MpxxT4KiCwos6OSQl7Qss5zAAuOXKNIwfirDE/qOpBplIXhApLFb4CI9wSsMevY0dh4UgKoGyHWkREVaC8PmU3V8rYgfVI+sSEu6m21UnBDpoP0+iu03DW3RFel9P/3K5z/w3NOlCrbfNKRRvpxGHrKWZzmRljWW8xPuGpGGduxbIr2Fl9gU5qJGc34KgKIGqjCaBKCgACDzDHuRNCgLHWeaN5CWXSenxLFie5ptKTafUWxbsQXNdhRb1GxXsSXN9nQqxbdiATg4PUeUGxHQVssRq1+JrDxHcu4aYYmEbmZYoCrmH4tSiYpS1kWBuhMizc6K5HYCqzdpWPXCiA9BLWj6CCSi6YOwZDbBCYzD0rKJL738ajDVloQwuiNIQly6F8CUTumgzjQ/IZsd4r7f9rmXEGpyq61XIRKX200KZqEfhw/RT8BbPyESqklZ28kJa1YkoJ/zU8Lawg+oolpb+CFIFKmD2IVN8CPeJpGAlE+IhNg0zY84IgH4qWl+Cihsn6mgrwAgD+896EwSENcZaI/gVKKBbCxppyIF8aHoGkWRg3SVothBukKxppEuUxQ/SHcpznIh3aFT0CCQbtMpaCtIt+gUNCOkm3QKWhjSDToFjQ/pOp3idSqGlI6WgsdmKOIZKHogSL5/+UspMZEIVM6fzkzxIhMJ0LcK8ASFi6k66lHV0Xsw21CmOW+IzYpNYtN5f6vY+jZQUUQ2pDeLzUgf9QYdMSjPO/Kzg+B5HnzNg/N8ufyQOyap/LIr3zOke6DeDELPr5EvDN7w4Afh980Zd0xQUFUGlSpGYVw1rGlTVx6L2HxdT4kbznsExfKrL8Wa4Hk6DTPZQBboNMxxA1mkOuFPzwhnOyHj03xSJOBT8kdE0JqRcqFZjQgKjXKZbs4jkLlRlccVgWfI/EpVBseMYAzyDBHsCXSkPcphcopPihE5e1JQOXsyHFjSCT5p6IU3iewHA31p7tid8m8z8rFlIuuOCbtfgYx7/PiIfM8QeqQTfMzHN+JgEKBWBFS5/NBVInlgufzAeoxkAAMYjjI/Lu8dRrdl2Pwk8ZaxWYEq3lax9by/WWwOW4ymKYwbsNlsFpuPesscsUx+ewiazVaxVTcb9KOz5o6JkTD3K3XM82IUR4zYvPxNUeatWTEiNotND/mbLkzzrBgRWwVQQoyILFJjDq5k+I4YwjcDDc3N+QPAuopN5Xwb2BSyYih4LUEru6+OelRCdljOXx42luUQbUbFPhJibs5fppIYDbFUzl+h0lkZYFBmAfmEp7/FeB1b+l7HK/AViS3qnRJ/i9iiawWosqoWBEdCsPxQGF/3sfIHb/jpR/7xy7/ytoMzx+RjjrzgYmTLw3ArworFl6pqOwMUfNblstlUrFmxXGwS2Yf8LNSsWC62CqBcsVxsRiollostSBFHDAeC+wk0LhgM6vOBen/9Ij8WLVA9MaNWppRr+WN1opamtPcPq+AJWeRY/7pKM+rrVG8ii6wIPmAh9HtS72QMWTf4lF1kw7eTEhk5CQseDYIrHljxRpsTm/re0H2jsrxebHLH1Hu5sscXM4HHFVf3+O41gcfRpSa9bKlJjyw1aQqaMHZYw0Bl8Q0CJYBygMKvaQAo/JBsoPQ3lFr0GzJ67kIdu8WELFjwMQYvcSDsJpHKwptESsBLHAh714Gwox7QH7B+dQNB72pGuAeSgs7T2yqJZwddFgo53U2Z3Vdfl6WBsTgg4kA2Dkwa3R4u1fxLOpSW+JVhOkCVyyqJABUKVbEG4KT2il0kneB7/K3RSFps7XuN9wzK5rjYqjzOXsXjx0bl49pj8Gbm4c3UaQQU68GyugYergfr64EYfi1YYDeBUhwoxoFCHMjHAb3G3orjTRrLcMMAHq0H6/5mkFNKD3D9TSI5wcuZslIYNoHaimp4WakNAFQDwNVALQDGNFAPAKGBRgBkNdAMgElBIcVWRmw6Pw3qCjTRpGyjO2KQj6TsRMABBLoRcBCBXgQcQiA/GAJHEChEAKjQTQvVuu1kDO2lLD1QcVSOioPTWCtJWRpUg4szyJU1B28DakezBcVWNVtUbE2zJWDqyHiboqr/aLw1fSDWmrofi7Wm6tPB6wPttEzVwt/qjUSkfDvsKGy0dvDXIzuJbDbnb9Cdv606f6E7f1t1/p7u/G3V+fu687dVD3KN7kHsqMcINbWNRqowEHkd8geQhxHRIPIHkW+RYERxCPk2CabPjiDfITnf1XMdmNYpaJvgUqY5fwxdyhQBGIEsD0YgtrJS8TMIFBUA45mRYDwDAIxnlgXjGVsZoGipd0YlpwcoNg55VwBSxSkMGwfFoM/CczwoMY6dU8qSwl9r1kM4PGqolJrhlGBTAS2a89cgAN+v0jig4zomP+3KJ9OBVnPKVH/khwbkPUrhuUaF2DjBiRlCqTyLhvBViNfFQiy7cghPhRiMhRi5cgihQgzFQmSuHGKDCjEcC7H8yiHWqxBuLMTYlUM4MaeYFvnaykCLHIjH8cMBkPjgtKbf6Wb5R6vl51ct5gSK4BaxVg0oxrUCKbLHxv1N85GwmT0uL2yQZRXDavjE1oigAa0WQQNbIbaCxigwhpvGH5x3L1A/e15sEUFE7Zn5cFmkPO9vAeVS2KCHPjgvgKtQsVKsDidB1kSNdIK3qGp0DYoxP4gBGtQRq9WKdYKdxf7xRmtWJ7Jv1tP6Uf7mWVwqX6Ayafr62flIO549fqcuLmhP2dDTWB1LtPk8ZHjxEmUveJtEsBp2fX1eZC8407yaiMbvD6GIMwBUmesJNYKvJfoN0w72s2BJZsyV7VGdf34okDuFoZyfwj48hXxxKOcPIe8q4TCU8weRH1PiYSjnDyMvlHwYyvkO8lkQD0M5fyAQAsa096zqz2HM3UzkfDfsyV3Vk4/ontxVPfky3ZO7qicf1T25q3ryFbond1VPvlL35G6/LuiGPbkb9uTLjVShJx/TPbmre/KM7sldMab7cFdkdO/tQt8tiSwncFwwFlvEFJv7vrmfrYIPa3PQN1zZ4xOjgUd33zP/8tNPvvh7FVhIKCSxs/Q2C1cWPke0bZiLSxlJ9SzrZyUpXLSaSQo3bFjwRZUfujw6K4JrGWOQTzLMuiv//imSw0l9KNVT6HZfQrt1/xb5Co2GP0bu5WMD8pFlmF/7yk4rr+y04spOo1d2WnZlp5ErO6GefOWqbw0EVb/86u/oA8tgDib0uDWs5T8Oe4buDKb20AV/s9gkNt80jg1ERF4fnve3Yje39abxC2Fa1b3zeoR+ZOa4fHyD/KjKkNWvSDUfq+Pn0c9nY7yI8WMx3o3xqRgPo+rO10hObBLU3Xy5uwHF4pBIyHwraIA4L9v6NRh+t4heRU3IkkGXDbpi0FWDroV0WE5dPNJnskr6TFVJZKLa38XBQLIOilf/dIDRrWT6u5VMf7eS6e9WMv3dSqa/W8GvckJkoDubFRkxAUp9Rmx6EF0uuPMUFPgMdCeSyH9SkwgZ0JckTHoja466hSFb7pT3rJbnh9QIHNrulYfqT6cMj6aAujnyOCmP3ykfWSPfqcb09lI9rlyqxxVL9Ti6VI/LlupxZKkeM7qC0C4noyphAi1zMqqg29A2J6MKs2UajDMyKsPZaV4ERnU+07wEDCa8dRrsdzIwod6GZ3Ya7HUyYss0b8Jz2zRvMNU46ky1lRo8t07zMhcJ2X0u+hg6Bt2OaBz4vjXeEdQ/298RKD4b40WMH4vxboxPxXjISu853RGMgsxuk2h5MyEbwDohWwd2OGRrwA6GbBXYoZCtABtMECVgbTY/NMXLR0RCttqmJErI9ovIf4RqvtGJuqF6x+hODLpq0BWDLht0qdNXy8UTwpKzJ9WKWEK2vk5yXlJYUsDoObGd5A8hfjnh/CEneCFJkdILcki5oD4hNSY2zYPuhEwKtKakMqAu/Lxv/5Wx4JNOXX2a7pGUvLQu8Jjq/wow7PE75R8vl8XQz9jiXwpG9rVl8i9DjzA9ghGAjpgyM/fSCvlPa9EbrrBBTVDZBgMBEa4ig6E7rCLDyjEuI8OKoQ0G0rjbpERz3rCsbvIcZfgphsEeCy1KTeNItQoONrz+AFjd2+DPAmNUSwyCCXbfojgsdw+C3bdaDR/OspT2mmXkpEztHwR7WejAHdnahJaurU2e4wiwgwcATc8y3NEPQWT1Ii5j21lm5UIjlmgxHdofmO2vBLtTdyVYziadYAEezfoZVMTHqeDKFnQbeZIqw2SWZTWqDUQvXsWQv2MY8mszeIjmJ1E0XRXNOreG2yruYzn3L8AysMvhjSQ9LlaF5tCrgi1nq9Sghw877jBxUkT+0SiYmrY4s+foWbAC+FfWLJ8N90vAKi3TWxD0dgmfKzNTElrl3Rzs2WpexKJT96iggrnj0O82L1I/0TdwRIMikQiXJeZlfpMsbVJ2jT3cjKMNN8E05xxENcF7FC03aWi5mWdq7aat+YLmO5oval6bbJZYYH0ClvMe2Er+P8gfGl5aYQ6tIIeYoLa8DDLY03yQQbS9NDKIxpf9GeSupzY35p+naKSNW1l0bqN84fD2Ii1Pw1/YGMLg3dpgGm0LAg3dcb7G4M2eu4ZIoRbbQZPRr9c9HuxetMBCvG/3orXE3YvWIrsXrb7dkVCOFOwkxY2NW1hmCnbfwGgl0OiuuLsSg3rcAQ9Aj/roBGsAnq3iWIshbIwTtpSMCo5m5BTM37EkfIkl4VASTNHxYFzMwegdPOjseeAqBXZ3TiXJ0qpai1RvaF5kmyZKKvkdvVkWzNy+BzSAbU1Ab9Mj0RthmK8zPofHWd/eP6g25XoJ7C8Tetut0pI59HIcOkSwgw06RN8a9xk0AipP/araR0C8JBqCU7VnickR3LOUgj1LVBBtGw97liZhR+pulgVLqd1sG0x/EMGuI68XRGZzHhUM+ze0uBfW+OWvSH1Sgmm5DN6kgL0JuDeZZ1nG/Qgwsyd9hq5QsjG9c3k7ucanZs7BcS3MVI+7F2wf1W5Ld4Tw4hlRO+Bggw/szkBc7glShH6R7GYH1R4StLvCCYADqsb24H5zyJOr8gRTs5ApsKGDXebKnWwnyxfmKnP1XB1akCsYMQ2Y2TrVl61DfhpmgDFjh6A9iPSHwcoKsrKN3O0zSJpi0rcKBttABIXk16Bz2IRPBPuWj4XQoQBaHkKpAPq3IXQggN4cQnsC6JoQGgug14dQFiEuR1FEvmWQZpiD4gQc76M+fIBKEQjkH7ZotWMbW3VsfzTv/y558F1SwX2GXyVE4Hhctc2zKlb9vXlcf2zwEUN/jLvloDo5KAfOzx6kfGQucZbBx5q3cQcRm3Xvpb6F4vFfY26t0FDPUvvIVMOHlwx/LPe87XDwOCgb9Faf53xs/2iaiyuTSbA4xJVJpFxlDpXNCQ7fg7YwRPt2NEVCT2hohBTYEOapogsU5/KTKIU4/A3NJuGjHpRJVSWQ54IzxQvQhZQcsNYsObnQ/rCISNFAyoiUnVxk8FjKYLCMEQyRooEUECkYSB6RvIH0MOqekVgXkW6EoNmTM8U7OuvlzBQvZ8CKDWOrGLFVEakaSA2RmoHUEakbSAORhoE0EWmaZRnEsgwaZUEkbyA9DNUzQnUR6RpIB5GOgbQRaWf6ytvKTMGqH9LFwSleHIQ6xxRLRoplRMoGUkGkYiBVRKoGUkOkZiB1ROqDfXloDE7xBqTbRNem4b+FSMtA2oi0DaSDSMesH0R6BtJFpGvmdghzO2SUCJGKgZQRKRtICZGSgRQRKRpIAZHCUF8ZYfiYH1J0bWiK14agNtBn3QjbQKRhIE1EmgbSQqRlIG1E2gbSQaTTn4fu0BTvQro9dO0Z/vPD2MaGjVIgUjCQIiJFAykhUjKQMiLl4b50K8NTvDIMdY6uVcN/DZGagdQRqRtIA5GGgTQRaRpIC5FWf7rt4SnehnQ76Nox/HcR6RpID5GegeTRvDzvGnWCSMFAiogU3b50S+4UL7lQG+haNvxXEKkYSBWRqoHUEKkZSF0ZuhtIA5FGf7pNd4o3Id02urYN/y1EWgbScXOgcfVLmWQoZZKmlEn2Sxmw0I5JGlkYyZnSBoxu8yM5LXGA67k5LXWAK47ExI5sjeS06AH3tgp7RvnuKE6ZsSdlV7EFzfZGriqEZHc8FwgifK1r43KoNx6XQ4W1C+RQfl1cDvXWxuVQd21cDnXWxuVQe21cDrXWxuSQbK7NBbIIc7MuF4gjbHPr4tKotC4ujcrr4tKosi4ujarr4tKoti4ujbrr4tKosy4ujdrr4tKotS4ujZrr4tKosS4mjWRdFbOli9lTLAglfG3r4zKpsD4uk4rr4zKptD4uk8rr4zKpsj4mk2R1fS6QS1gt6+Niqb4+LpYa6+Niqbk+Lpba6+NiqbU+LpZKG+JiqbghLpYKG+JiKb8hLpZ66+Niqbs+JpZkRxUTRBPWzIZcIJ2wWjbEhVN1Q1w41TbEhVN9Q1w4NTbEhVNzQ0w4yZZKuquTbm+Iy6fOhrh86m6Iy6fehrh8you4fCqImHySRZELZBTWv4iLqLKIi6iKiIuoqoiLqJqIi6i6iIko2VBJt3XSTRGXUi0Rl1JtEZdSHRGXUl0Rl1I9EZNSMu/lAkmF1eLFBVXRiwuqkhcXVGUvLqgqXlxQVb2YoJI1lXRTJ93w4rKq7sVlVdP7hcqqrrdAVnU8U1a1PVNW9by4rKr7pqxq+Kasavp9sqrl98mqtn91WdXa1ierOtvisqq9LS6rutsWyKrO9risam+Py6rW9risam6Py6rG9risqm+Py6ra9j5Z1d3eJ6t62+OyKr8jLqsKO+KyqrgjLqtKO+KyqrwjLqtaO+KyqrkjLqsaO+Kyqr4jLqtqO+KyqrojLqsqO/pkVXtHn6zq7IjLqu6OuKzq7YjLqvzOuKwq7IzLquLOuKwq7eyTVeWdcVlV2RmXVdWdcVlV2xmXVY2dcVlV3xmXVfnJuKzq7YzLqu7OuKzq7IzLqvbOuKxq7YzLqubOPllVmOyTVcXJuKwqTcZlVXkyLqsqk3FZVZ2My6raZFxW1Sf7ZFVjMi6rmpNxWdWajMuq9mRcVnUm47KqOxmXVb3JPlmV3xWXVYVdcVlV3BWXVaVdcVlV3hWXVZVdcVlV3dUnq2q74rKqvisuqxq74rKquSsuq1q74rKqvSsuqzq7+mRVd1dcVvV2xWVV/tq4rCpcG5dVxWvjsqp0bVxWla/tk1XVa+OyqnJtXFbVrv2FyqrWtQtkVfNaU1Y1rjVlVfvauKyqvN6UVdXXm7Kq9vo+WVV/fZ+sarz+6rKq/qY+WdV8U1xWNd4Ul1WtNy2QVc3r47KqcX1cVtWvj8uq2vVxWVW9Pi6rKtfHZVX5+j5Z1bq+T1a1r4/Lqs71cVnVvT4uq3rXx2VVfiYuqwozcVlVn4nLqtpMXFZVZ+KyqjITl1XlmbisKs3EZVVxpk9WNWb6ZFVzJi6rWjNxWdWeicuqzkxcVnVn4rKqNxOXVfnZk6asKtRJXFgVFWRKq5KCTHFVVpApr6oKMgVWRUGmxOooyBRZbQWZMqulIFNoNRVkSq2GgkyxVVeQKbdqCEWCq6v5QHL1VBBTdOUfJ3HZVVCQKbyKCjKlV0lBpvgqK8iUX5XHSZ8AqyovpgSrKcgUYXUFmTKsoSBTiDUVZEqxloJMMdbWOQjkWEd5MQVZV0GmJOspyBRl+SdIXJYVFGQKs6KCTGlWeoL0ibOy8mLKs4qCTIFWVZAp0WoKMkVaXUGmTGsoyBRqTZ2DQKq1lBdTrLUVZMq1joJMwdZVkCnZegoyRVv+SRKXbYUnSZ9wKyovpiwrKcgUeGQ3K79ZEPnwk4GVExGwWQOwypMk51n7qLcGTgYRaz4MZ5QJuu/6gqD37/uTn33tO1+9/79VWuScWHPWRyFjiTX76Fl//Mo+xw2fbEk+1+zjZ/3xfTX2b3DZTIXAvP2cYNZZD46dQzEMdf11dawcNoZvoI3Xq8pOciAwQ3tYbRDs5ydjfDbGixg/FuPdGA8rvmCuGhpV4OGC7qh7L/U4/EniaVkkZ244VwdqRVihHjQXA8wHYMcAHwzANoCGTT62UsPjRwOPTQPU+15J35bKxv+uzkPkMNBWJ3QQWXpWGeuN6daHLFi0cuPML+UlpT9S5UUYykPxYmAjR2TBoPMG3Xs2orsG3THoxkU4e6tPC6kryFRDagoy9ZCqgkxFpKIgUxMpK8hURUoIRbqIOtqEyPxzUWV2gxd5cSHWXQTrXFzYCNqLYK1FsOYCjKvKGYCvvGepZ1k/21zz+tlilxut3ttKriN1SwzsU9sqnvnuzBSvWWGbxsxWdDQdHbyin22mnrPweCO98pel2lVWDKizQgb2PfTuR957/zde+t1ZtfGWXUeqliwMgPEIHOMxm/MzG4msfWU1HoF7DZFldtJPbSSSym878vxQ+HHhGRDfduTvmRA2X5/5CbB4HDVMeEUCTBtXmEa9ALn+yj5oVIzOixVixbxYKVbi5vdR02oxn5KtYTEKVovbyJiflnS/SMu5/XfhiaJtctLnG4lwbrTUIbPqPN8nR9xr5GeEu1FwOZlDB/ne9cjOnkRMfkq4G5VVlQPh4cQrBkeQyhU5H3iR8639eH4O+ddow7NdWcfQHBzuK9InvTTYykHnm3Y/aguOQcHoMeU+yzACMNQDI3Kdqvs6xbqbCJhftAluX4LNwkaBhaYLT8J+pOfG5XdHofBsTlLwmzX8Hh0kayQJApDuDJxHtibgc73Z4478wnL53UFVe9tJE47rT4BR+iIJKqPrz62EjRfoX86exDe6BK8T/MAS/R1cor9DS/R3ZIn+TizR36kr+ys6hr8zS/SXp0v0WFiqx+JSPZaW6rG8VI+Vq3j80TLYiKM9VpfqsbZUj/Wlemws1WNzqR5bS/XYvorH96416rGzVI/dpXrsLdVjni3RY2GpHotL9Vi6iseHM/KT42F7XKrHylI9VpfqsbZUj/WlemwsxaMDvXOJq965ZYa4WYyiiDh+p/zOiPzW2rCtxaLt2w9QGZO/tSJsbGyBUO6yhVK5x/rFsvzpiPzi2oXCWTcjfuVSPTYGO+2CZrRUj8WleISjrhPaOA+plNrvH5yfltjChUfhkfXWiMROOuk5wI154+qE9iZTzz3CFs4bKRw7sEYfN6COGRgHFSkQlTac/4QR7FFHpiTw8MBJRR2BgEgdgrBIHYTgSB2APDooRcNjCRLhgWJIl6g+FiARHkyGtDYgRFobFiJ9Rp0AkAgPHEiEB44hrQ8cQ1ofOIa0PnAMaX3oGdL60DOkgzMFMC8MzxpTeWFTcN6YygubgjPHkO5RPOofaX0wGtL6YDSk9cFoqqwMzzNTdcCmeFnTcMJdRdNw8F1V0zU2BdutVP7ZFGzBUuViU7AtywbVtgln9msFG58ljkbS+C3h5QKhlqr2bE1w4a0QKbUZMaVUcltWeM5zYMLZhtOZ1ftuMf3CwSZfD7rwDcoeCw6H6GGW4FxnfTpEVwFwxpQ6HqKjADjlSO1iLHIECjzYx1hQQJ4Hx0TkuSpbiatieOn/nlKINO67MUsQ5V3lugEpqvzWgVQ5rQGp8tgGUuWuBaTKV5NjDYkVN7wef1+ZmZ/mVY6I+lKbgFR4eIhQTZOuSig42bQ1o5Iwj2ttxfgm8MbO8wbcBCE7HOyVlQ4M8/Vcf/YpRaWgOrjuHsbAeBgOouQ31Nbf/73/pfbIDGx25+pYqALHmQocw9X55acxtKtxhTf0s6mf7Zi/lsY7+tnlKsleQj2btno29LNoK38Fzeft/vh6Op68pf3pZ1E/S/pZ1s+KflYtFV8Nnu21etqJy+JaPT+jYnV1aV3BYZ5LjV65LK0NyXJEVqJo8kmosItq3xuXzTSw9YCtDYVhqiGJuRvSuRsGX8Ohr7pBbg0T6W4J8gomSSEa5aKzNmduFtaJlNdDXteHMfa2hGR+a0gWonSaEdmbCEmym9W26ZcOTyOh+jYo2bbcvkdLT/zuK396af56XUELofJCqLQQKi6ECgsgk81DDhpb48WHhcCggK2IbEZkw/CwLSTbEdmJyG5E9iKysD0kixFZishyRFYishaR9YhsRGQzIlsRWdgRvbyI7EUeuhHZMVKL/FYjshKR5YgsRWQnItsR2YrIZkQ2jBh2RlUSkYWIzEdkz4ghQusRWYvIakRWjBgishuRnYhsR2TLiGEyKnxEliKyGJGFiGxFZDMiGxFZj8iaEUPUzvIR2Ys8dCOyY8QQ+a1GZCUiyxFZMjwM5by0GO3b7sej4xtGL0zzzlon7PzB4CP8+LdFZITmt0fkZEhWI7Qaoe0IbUdocUdE7grJeoTWI7Qbou4W1fMU18IEkyyxoIN18XwSW7OF1bnI1ZbNN0DxUQMYVYoO6qkprZjuUdQRUFFTWjHNKuogqKgprZiOARUopq6C94AgTWk184CiQPk8qEjQSQ8pElTVI4oEDfaEIkGxPaXIU3BWTCrQTitU0U2l+aYC7bSk6brSfFOBdlrQdFVpvqlAOz2jyI5SYFOB4lnXdE8pvKlAUW1qGhTYlqZBsW1ruq2U31SgkHaDpBgqtqlAIc0znTWlCKcCJbSk6bpSllOBktvB625SYRtNzV7wV4Qn5s77K8NDbOf9VdMqmlXTKopV0yqJFf1+8toNs7VqWmU1iOfpmXl/bFoVa2xaFXVsWhV/Rb+fhnar6ydW48pp9YZWTqu3s3JavZkV0+qtrJhWb2TFtHobK7UC+OTMvL96Gl/56mlsBKunsVms6PdwSLkcVI8DqgQdnYOqjvmMcp3F+JXC9kdQV9PYpFdOY3teOY2NeYXhYcU0tuoV09ikV0xjY76c4xS8ARj++fyN1BIpwd9Ioz3C3kqRDo8+QCqlDiB39NASKdwLhhTuD3O28D0ehcektwYeWW9cpMUo5DoNw8asSMNYclKkYSy5R6RhU6IksqWUpfQ+PIEobep8BxV6Qj3ytN/1lIILVD3LMeeixiv6WY+5VzXe0M92zL2p8U4M72o8z3T6DI4Yh1GQ6oT7M6E9leG2p3veeR/sExZpRZGPQcgqbIsWIgVrBFw4MJ3hboXDyV+yc7LqCxMrPuPkZGljH5b/0xGoxe5a90Nwex/Zzf7wqOAyuZt114KgASVRfvNNur+EJTg4JCmh+foLJOx86W5WPqrVU4ii+gKJxJHhr4G0ShHi+M4TNFRPaz8jOUgb+/Wfkb60y5+lfWkXnqSRAgtx6Nv0uk/QSE4adN7wX0Q6ysPHH2ZhHvJtGuah0KZ9eeh8iPXlofkwiyQZ0DoPtYdZJNcNumH4byEd5eHV+3mYh8bjLMxD83HWl4fqa/15KL2LR2o3xKHzkH8Xj7QIgy4a/stIR3n47EtRHooXeJiH0gXel4dem/flof1SFGf9pSgPjZeidJsG3TL8d17qz8N9T1thHlr3WWEe2kAbeag/YfXloYLhVJwFoHUeik9bkapj0GXDfxXpKA/PfNQO81B+McpD5cX+PBQetvvy0P2oHWlBQOs8tD5qR1qlQXcM/z2kozy874FEmIfOU3aYh+5Tdl8emvcn+vJQw3AqzhLQOg/lBxKRnmfQVcN/HekoDxdfjvJQ/UgizEPtI4m+PJRe6s9D/pUozvbLUR46L0fpdg2693Lkv/BKfx4e/mIyzEPv3ckwD/n3JPvy0G4kzTzg5MIX4d67BkagIq8ArTNT/WIy6qAMum747wJegDN+qX5jALwLlpKD1wnAfXBAWNC2AXhnPp+fVPxXwyTT8v+8ZzUkgxeCFBSN91Xk71ltCACY/MqvVkTpntXQmxt+KwZdNeiaQdcNumHQTaD7FtrTsnUPKsHFpJKjMv/bC/0Ufhv9fAlNUNhZkZJWzk9sJ7BnPa0Ef/2ueqgBgOZMfGccFAgoCQ9dQr/CkXT/OKggZFFHtn8c79MIz1iexUrRfkXdC+bFbqg73mi/1KxgnUH9CpzJWiFGxUqYZRcrj437q8SoWHXTuL/qvDtPvRVipVDUSpGWvQKEUYA/qoKF2SuXy/7oBXXBSBc8rhQB2wF2hWZtWXssqHJbfuqx1bo14QWy1cdWw5GxhoeGQTfBM1WeWxhQPkz14KT4eOSvYNB5gyZvpOXHIYHS48ZLhMuOwPXhxzHGB9Tox8Y7oT4Pvqufj79yW9Y/b2TRoJsG3TLotkF3DbqzSNw9wz3/lFEsgy4ZdPGphXGUDfeKQVcNurZIuJbh3jTohkHXDbq9SBydp9S4MalfTf6LRp383UL/BcO9ZNDFLy5SLsO9YtBVg64ZdN2gGwbd/GLU7loG3jbo//LFoDuyZRf9y04wFm5/OfTXNy/7ZWgwnS8bL9ug81+J6N6XF6kIw71o0OQ6Uv3KatUkK1/BBvyVhaGt3awMjm5WpOBeEjjGSV0gzWSZ5zxbJMHMhMPtUdtJC9b7MnCL4+QUnj9o43H5k4oS6pBDGwciQlGuOtrQ1pPdGX0DJFrLZ/qOgdwT4ydjfDbGixg/FuPdGJ9yBI9M7jJgcrcZ7niFExq5Pog8CUdZSyLfqTqIpL7NssQUmcLRA5JqlMHU4h0sWHhrBIPFuwSAsHiHt1S1LDDDh5GIajdJkXgjrUEca3DhKIm2lvAcxxEJ09MjHGLBFTyur/+aVBSu4CGFK3hI4QoeUgfUggKLVvAwszDRUeGKhvmPsqZBAJc0DbMlRU3DJEpB02dwgQfJU7iAhCTMkrQ1DLMkLU3DLElT0zBL0tA0zJLUNQ2zJDVNwyxJNcgNwyWDZHBwVVHTMDVS0DRMmeQ1DVMpPR0Wpli6moZpkk5QWobLD6oWGC5BqHQZLkOo/DA0aFP5hHU7TcM0SUPTMH3ShHdJ4Z066uWW4eNoW+HLZXpBHF+FWsxCss3CN9GD6Rlb5x+mbXT8HZjO0XSRT/GS9lPgU7yo6TzHpRjMQ9nWeWgDULHNPLRUHoKLfrj+XCcVlVUNyNZzBFx/rmOKclUDsvX8AqbVDtIqJ8De04Z7HsPywileNhaSq+OvoQCWOh0f8m+ppWrIvqWWq6EWuDoRHyqBq4VxqAMeJllOOPqdXQ5fwU+qYsFBUFt41fLWwH0aKks9yFI9YXxfa6bgaGr8rqoJyGLXCl5JzQpfSccKv6i2FX5SLSv8pppW+FE1LP1VbeF1K8xiD7JoLHPmk5BYxfK4ytlvJ+FonetIAZ81PBE5KUuoT3eVQGATvGxdxSbiWyvhZEYwNmATvHo1n38xpI1W+Gz4VmCBmZ/OTfB2n5mC/PZq7dcJayf0WjMTuVk+OCg/Fxgx4AlveqtQRs6ehCPJ4AbqB8DItXQpMr0tGnTBoPMG3XvOMOF9juR8W3Owy0ob0Zb/D7z/cIEdb+PSAjve+qUFdry1SwvseKuXFtjxVi4tsOPtvRzawYNu2cCbmy8R4xhddcezJPK7RPNww2xY5IjGKanbwVz4EsnBDXTKoJ7rLWFwA3hSdr+uSujiHRqWu2JebezqDuGtFqMCT2Xr/JrPMEAKu/c/pDlZY6cA2aKatFSI9gWHh/tr9tF79333k6W/+ej3/uCeP5s7d79Ys+9ncDn5vXgQKgrHM/fet48W7vfXqB1iYBYvRsWafesK+7720a999GvkXrHmfn/NvpF37cvnSy//7LWHvvePAfa6dyn5evEn/14juwtizT6ncP+j0UHzmirvnQ+PoS/rElaGdQkzSynTzylRZtES4YFynV+Dbvr/vZLFdtWVrw3bRs1bYKZd9yKb9YiErRwBXY3CV65dEL5o+ITdHXH3kjo9vmqpjQ541JxIKIt9OE/XTxo2+3Cirs8BUFtItK1+7Qi0+Xafsb4Hd2KXXkAMkmgybcEPd0Yat37DjZLRxahwBl3tyBQvvlVfJYl3yWJIWx0vaKtDuG11CLetLEZsbTFiGLBn4KGu4MbdEysFcVddxvJw8Kvz5xZNnoWNLOrW5555oC81T8Klptl2FwzHBVX9LfG50d1yQaPbE8BKcETWVguuvKaW7tVdutexpXsVS/eaXbrXySV6xUvuiaDzPofjiNWd98BasLiBrAusDUseyI4Bm4CFEGQFsElYKkE2C2wKFlCQnQQ2DcsqRPAH3f9EBb0wjV2oFXIHBBF2yB2EJh5yh0BOhdwROHky5E4IItIhd8p5kDN2js+pu3Pry32OvSmcpsjj/RNOz6v+SfmCDcE+XdBD0aCHsuM9lN4GtYS4IWa2IGYWxGzFY2bqY+O7WX25oGaXR+/3abzLQ6yvy0Nkd0HQK3Z57h+HX059/iHBzDTYLyiNG8a23/C//sRbPTvvPkjnnU++jg3PWWdhA8WI2kBBBM0SspuE+9cE3U6s64g+a5GFu7U5HIaZ2s3wlls1eDuTwfMk4cJshkcgRwcuJnCztqVc4e0z2K5taYXZhuoeU/qrFdh1wqGLlrFL2w7vf7XD212RCm0jrchmEg9dtMx92QmQIAktQTiej8iMjdgcz0dkxkZsLBXs285nYOYYXY1N2VwWBzGKjBEFIkUDySNSMJAeRpQ3kC4iPSMrHUS6/VkB/a0NWSljnBUjhgoiVQOpIlIzkBoidQOpI9IwkAYi0RZsTBd2fpcGoSxDWJZBoyzoP28gXUR6RpwdRLoG0kakYyAtRNr96cJW7CakW8R0S0YqJUTKBlJGpGIgFUSqBlJFpGYgNUSizdeYLuz5LgxBbaBr0/DfRKRlIC1E2gbSRqRj1gkiPQPpINLtTxc2fNch3cow5nzIKB0iFQMpIVI2kCIiJQMpIFI0kDwi0c5rTBc2XfeGlH0e1Ibhv45Iw0AaiDQNpIlIy0BaiLQNpI1Ipz9d2NyNdoFddO0Z/nuIRDurOR4zyIyN1RyPGWTGvmqOxwwyY1s1hwEA1NJwX7qwpbsD6VbQtWr4ryJSM5AaInUDqSPSMJAGIk0DaSLS6k8XNnKXwe6yja4dw38Hka6BdBHpGUgPkWgPNcejA5mxhZrj+YLM2EGtxuLDU7wF6ZbQtWz4LyNSMZAKIlUDqSJSM5AaInUDqSPS6E8XNm0XR6A9jGCHb+yQ5rI5os5db/WHgW3WjREQOWh3r27sWh5qTPP+qLr1Y+SGQ/8xO/7kD/5hZr4MB3c0RvxlN+y96bX5S7//kZl5vIjREsuicGK5GIm4clnZDS+LYhGjYiSKADw0Rhw4aFtdJQH3uLe+QXL6DmhgmwE7iWwjYLPI1gNWIFsL2DFkqwELUyBkC6/8b8p8mchO4HIA2W7AHkS2F7CHkIW7fPSNVsAWAvYEssWAPYVsOwg7q6R0CidNcLStWM+S5WVwsTuV1S14PDuAcMcqCm1D9Nta3uPUVHRQi71A6sPpxyD3E0riJ3J+Qs9ooxH/mJL9gam2DVs0E30SP4ES/0y47yFvbIcoGNskYMsEXEoBVvbUONeFwmyAEvkUT1JmwVEsFI9RNjUAiocvmxoAlRUnJvWpLGf6pT7VqkHRQJRyUTCQQkzqUzx82ZT6FA9fNqU+xcOXWbD9meIJyyw4ioXi8cqmHkDxeGVTD6B4vLKpB1A8XtnUAyger2zqAVS2Mv16ANW6TiT7qdZ18gaSj8l+qnWdroEoXadjIErXaRtIWxWzpYsJ5yyz4CgWqrWfkpGu0n7KBqK0n4qBKO2naiBK+6kZiNJ+6gbSVEk3dNJKTWkaHpQq0zIQpe60DUSpRB2zomIKAdWKVNfM8FC/EkC1+lIxEKXilA1EqUElA1GqUtFAlDpVMBA4i5kFp69QPHCZBYevUK0G1Q3/Sg1qGIhSg5oGotSgloEopadtIEox6hhITyXd1UnnY5oB1TpNpBlQrfcUDETpRkUDUfpTyUCUjlU2EDh2mQXHrVCtDFUND0oZqhmIUobqBqKUoYaBKGWoaSBKGWoZSEcl3dZJK32oY3hQ+lDXQPIx/YBqfSjSD6jWhwoGovShooHA4cssOGCFapWobHhQKlHFQJRKVDUQpRLVDESpRHUDUSpRw0BaKummTlppRS3Dg9KKIq2B6vPBunDFYw/Pak7l/FRUJyMAuTk/HVUKQmPBdbZYKwiJ4MpbrJYRNdLUd0ZivSA0GVwIjHUzgifB7NH1gh5mT/qJqGJG1NRbzmdR1SAG91Emo8pBLLpdGCsDsU54wzBWGWLt8JZhIimKY8u8w+imQYLXPPUB6TgwEAecOJCJA4NxwJrge/oBdTJA3NOBOHAwDhyKA0fiwIkIgBvX8XqZzoigwr6OtEfgGxnRM7QUTrYOyPyykCxEZDEiS8uMywr9EWNZ5vxa+efLxIi6r3FPn9OfZ+Bqde2UukKoRDzCvlDuFUKxq4Yau0Ko5FVDiSuEGrpqqOwVQrlXDTV5hVDDVw6Fs9xZVjrkwRSgtZuVDgkblUo7y0iWWSMUJmi2kXtpeI3IGX1TSXsEJqJfcJg9NwSTVk1b3YVEZPkbBBc+YEGo97yi4cifksbhfKCuxtOgHGt8AHRujcPCQkHjcKFFW+NwzlFe43AxQEvjcGh+7+uKhgPlmxofEWSCd3/NWwbPxmFvOVyXMqEO2YfFKp+5K2BEsgyGGSUbXKG3h/ledBkRLriUlUvXcBkWQ+BSUS49w2VQZMClqlzybuTiiAFwqSmXguGSFilwqSuXouGSFAkcAsEbUit16qL4w1Cjz8PFNrIdgFj7CuuYWEVhXROrKqxnYjWF5Z83sLrCCiZWfB6W+QSR55+Ey+UInlvF3BU3/PvRR97ywr87PTMPlVw8XFb5XOhUAqfSok5lcCov6lQBp8qiTlVwqi7qVAOn2qJOdXCqH3bUBfJYwbCU6bNo/QguxjoTrR7pq+XVFUVgthKtHeE18cY1MC8gBheU6rUjCqZSMMjzg+QYrDq4v4WN7u/ROyw1FTisP8HNO+WXVIplSy82ab6k+aLmi5ovaL6g+bzm85rvvaj4HtdL05rvar7yEoGpALjPXoeo6hiqmq9pvqb5uubrmm9ovqH5puabmm9pvqX5NqRoA9LWSEf76Gi+q/luUAbN94IydnQZbV0Hmi9ovqj5oubhZDKQPjYc78WEJWx39RpB1JJI41Y5cEruuTXnM1xZ9HEV8JuYRzUFv52QcW1OlYdXX4BXz/FKSkxNs65iS5od09+mZoX+LDWb1V+kZifVlImtPzeGl2xC6G+GnyDDSzghChOrKqxqYjWF1UysrrC6iTUU1ogwqi6ZdB5glM3pY50s6OBvxIvthFLwBA1OdQIVTeEMOTg60zjUycUr3QRxX6E+FdT9MXV/QhVuI/4j6jG8j41I4n6PeTClwLFm2BzchQYrRuUVwna/yHyqJj+oYL8yyARu72KSnpb0Lsdn7k8AgCuRIAlYgYLLxBiuRakZEkHcH8AsBd7bSNw/gvu/FIP6oc68+zrF4tlQljobyvnpMJs9i/UBl9TthwO5vLfAu5r0NqIU9l6H79DbBI8T3mZ4lKmXhWeLelvgWWTeVpwqY94EPPPc2wZxZL0hlP/eMDYLz4XHEW8dPErU2w7PJvV2wLPAvJ3wrDNvEp495u2COIQ3gpqHtwxbmrccHoe89Zgu9a7FdKn3ekyXeb8Ezxrz3gDPLvN2Qxxj3ijqPN4KbLzeSngc9DZgutSbwnSptwfTpd40PKvMuw6eHea9EeJwvVWobXlj+D14q+FxwBOYLvX2YrrUexOmS73r4Vlh3gw828ybhThS3hrU87xx/MS8tfCY9Tx4nPEkJku9fZgs9d6MVc28G7CqmXej2A+UWr71k/PA7FHr2SlkTqkV68R8GScuK1QtS6fRsU3VyvOAmtUsMbW67KBjk6kF5Mw8GHj7KIHoeXgQf/ACXo18HvVa/IrP+9eAU4eWQ0sKmBc9JPaLtSI5LzyRmhdSYD72ifS8eLOAVG8Qzry4Uag01qIoo+eFij7le+fFuFhz3l+DGk5f1P44rAPvF6shcgGR71WRvwkivx4jn4HIZ3Xkq1EYhpG7vjgvxsSq8/4qcOj1Rz4Gy8r7xUqIfANEPqUi3wORT2Pk10Hkb9SRr0TVK4x8zN9wHszez/uj4JBnfZGvgDXF/WI5RL4eIr9WRf56iPyXMPI3QOS7deTLIY5mGLnw158Xy8TIeR8Vv0J/5Mtg+nK/cCHydRD5dhX5Doh8J0Y+CZHv0pG7EEcrjDzrrzsPat95fwjVm/7Ih3Ez5n6xCWLfDLFnVexbIPatGPsExL5Nx55ERTSMfdJPnBevExvP+ynUkPpjT8OWTzYrfOM8IDhXZG2MXx3jV8b45THejfHJGH9NjF8T41fF+NEYPxLjh2J8KsbDlxODvBgvYvyGGL8+xq+L8YkYvx9OtkuIxHn487ZBIsbFeEiPibGQXiFWhPQysSykh8VwSKdFOqTJdlKGpZP9+sLMg4qahAWF/SBhCFqrEgULWMxAagzWMZByYXoeqRRMz+9Xpj5wubEr9ov9MG8BF6oCKXIg17jYD/Mw6spZNFqBO54tTaV87JiwByN63QVtWSw0aLncwyq3VHkal0DQsMVC65bLPbhyc8vTylgUrFwsNHW5LCGU21h5WtmUgsmLhXYvlyWQchPlaWV6CvYvFhrBXJZwyi1bnlYWqmAMY6FFzGUJqtwmL+v1kzAaBKtZONoxhRu0iRjCDdpEjOAGbQK7dvLwVJuyiViDm7KJuAa3NhORxA3ZRLi4IZuI5bghm8AW5gY8V+MmbCLW4iZsInzYCi2J9xZH7NdXYL7F+QPOrLP2HDZTn6keh8Nj1rfKZd/uOwSBCDsy+3jIZ9H3jIZCISvYBRUX1sme82hkh3dD66pwAUoFUErX+DR3h6FiGAwjjvkJYQkqEpJLIhLjOWXvSm4a9xPqAGKRkDZCSNKc5Kf8pIbO4+qQwlIBdsW84+BHJCW/1U+LVJCSoCIF0IBIBtD5/iKqYkPA0zkoCgxtIUTSiCIh0gFX1kmlDP+pPq8DfV6de1MscXZwTh0gmlL2M2qs/NbAUI+GinpZs1pRr2hWK+pVZGFmMh0NjhWWzfkD0eBYYZM53wmxhsL25PxMiDUVNnvSHwyxlsJgjnIoBNsKhEnK4RDsKBBmKd0Q7OocH5kOLY7V+NEfCf2ASTJM0JGcvywEC5dUwDPToTmzGrv6y0M/JQUWaM4fjQI+qwIGkwDP9lVo6dm+Ci0/21ehFWCjuqziychR1QIb1WAd2KjyGsBG9dYENqqxFrBRXbWBjWqp82xfLcFxyiKqHzhpWUQ1A4cwGzUD5zOLqE7g6GYR1kaWFd4Kl2uL1OXB5FjOBZv9NJbfU18pbinCfsIW9nnfEhbIBC54SDPBkD4Kp9am5XlHfnYQpt7mwdc8OKvD/SSVX3ble4b019RTR/4+v0a+MBgeYgFmisHxXN+fwR094ZHWP1WHAhDBdFfJdVdpq/MrYJ6MwyPlMXi4ng2PMc+SVL5ipJyadceMvKm8WsKaB23mofDG9+5j5Q+GGweOycccecEVCZgr7eseLZG44FmwbnzBg6N6Exfg0mJ4MEdlssNi53IX4LZiaxo27Kjc61J1mSNSeLiv02SMn6VzsvsDiuWSPUVYMv9DJGAgX38ZzOJ0TzbNa7dBO3pZDYDbOABWy/SKhjIS2QsYiKD4gmLK5bJgNzy+qvKjZd/4h8fmy7qFYvQ3bPub9/zNI7/zaZhqwrmjINqWGW3XjLYQRaujaqioIuMJGAUoE4OmGU3HjCa/IBow+t9O1JRs92XjSHGDbod0Akb4KHF7tznOZhLtCOgEOwJ0hOiPKH9fZozOUZwKpid9BjdCw4pA4BG5C+F8IcMpMKoi7r5K3XM4iIcvpnkrjDAYrEN9X9tJnEG2E7B5inzr+6FVBYO+Cro6iE7NwTkQV+02vAm79wOqbTwYtANt/sHU/AKDxqK3kzEwAIe7y1U5dTaZyp2Zf7Ig7yTIO7aqKHMpZMOiuMiGRYFL28WCnDPZBI3D+bpF02e1HPOVCc68n8IB7bwyyUnN+2lU4jTvzoN5BzzLZTVQxAuyU/NqYJdAXWxeDcQcHBHD15uBLzmt7tJ25wX6ysJ8NYy3wcPg/Hl/AJU+mN/GxHBorUbVY5dHOqisXR7flMt+Yv68n0QtEKJKz4uUyMyDWgzKH7TKB7VkR40PEmaQD4EZh+QEJnUAJr/ZBD8IsbDLWroOmgqCHtFBT+igp8KgZ3TQPNVhC1QHdoPARapDl6gOXqZh+ArVEVSDCGpBBGNBBPUggkYQQTOKoBVE0A4i6AQRiCCCbhBBL4ggz8IICkxHUGQ6ghLTEWSDCMpMR1BhOoJqFEEtiKAeRNAIIph03p2gzln4dOWXYKuWRwJZFXU1N8HYiAj2kK86yuhEL9Dlpjkq46iOstAwHpoYsNowHhoZsAlVa6AtA5tUdYAKL0NLeKX4omg5f6Us7FmYhYrOAsgSPn8eIrOV5Tyd4AegFSswrQzoL3+eB6GJK3BA2dHTCTwOSYMMZmUozAyBWDuPEu68uU1A5Yg/BCU+ZeaIXwCoqnN0RiQwfBrCCz7vOzD1gE54JT24DQRuGZw5QEc81gkcWeDI8awnirNTCZHAONPz54UjnPnzvhXPmfUQVH6FmlmzLkC11HTWqqh3Y/oQTwbiETa+s6rOhTrLC3MBXnjgJYFDI4pzY0mRxDgGMI7M/HlVY+YQSOXIfghSb/flyMYc1XWO8OSpJCY3gMlBbKr+VL46mCgey5VCbwy9cfSWCJOONxx1Hm3YgEAlMlvQNG+AouG86yMW33p2ei55Dm5ZyJz0924kYq+ej1fiJoF8JeB7NvLlgO8qvhTwHcUXA76t+ELAt5DfwvNHpnjTFntlIZHTK0bBWtFe2YKdTCjkgzWlvXDUp16R04YJe2UDoZoJ1RGqmlANoYoJVREqm1AFoVIEkS28eNi7SewFuzp1xsRe2RnQ+wf3ynJIipumeDkt9gLbHVDP6oDYi5vzNd8C9xLN+ZP7dIJFmvMnAgYGG7sDBoYjuwIG5jzeEDAwmNmmGXVS195wXW2vLNOcuio8WMo7ADkmObEXltn2yt5ADvJt5/xprcnvlXkHMNhjvD3ECohV7Zx/bYgVEavZOX8qxEqI1e2cvyPEyog17Jy/M8DE3glesqd5d0Dowuti6wLroupC/rziNb2ciJULjCN1GvhynZyIClhzciIqWt3JiahQDScnouI0nZyICtJyciIowi8g27VrF2S73Z/tTl+2u33Z7vVlGyw2o2yDRWeUbbD43BmN0x54q7cblmuSJ/1dG4nYBcW0c/4bcCbulNgl3oDTcCcUJcCCF6kxMO1FyoW5O6RSMHeHFBjvil24v+YNck/43e6SDQ5IgYef7Ru28Bb3boJnm3vH4dnh3s3w7HLv1+HZ494JeOYt7xZ4NrmXE7v0EcW7xC24Z3+XOIH7+HeJX8e9/bvEzbjff5c4jmcA7IJvsGSpcA3gc3jGwBu2kyZsgt4lG1bOn4D41fowkiXc/I1kETd/Y+lgubdrKRqWgjuahoXotqZhibdgKxqWf/OahqXhHmSDQvYd8YYJ3oK97Zivlq2eZfBM0eRiF3yO3gTks2T7k9asyk07yiMs3U4qElZ1s4qEBV+hyB5uZkeyG5Wno8qDRxrYjkq3kFTPtg3pNRJYL20bXlnZzskK1W+RgldHTN6I2dmNi/6TijqhcrAbz6oQijqk0t+NZ1W4ijoAqU+I3cFZFSTKyu4sI961kngTkng7YMSUPOlPwYgJ7pTxtkmordmT/uSC2fA1korJCZ5aFHUXRccWRcWiaHZRdDKG8lmxTUyKCTl5K/aje/ouLphWpmj92AQ/EAcOxoFDceCICXjbxATYkE8oG3JJvWk2K7aBpJ+EOw2MMfLl4pUNvgxAzQRC8m0qdDEWuhIPXb9a6FIsdDUeunG10E0eW4+YnOCtRbD2IlhnEay7CNZbBMtbcUz3E1Cb/W7YCIqLYKVFsPIiWGURrLoIVlsEqy+CNWKYA5kvgeXaJJ5XMtHf/sRE/xdzJwBuHBiLAyIOZOOA+WHcGeQDO5VJ1DH+P8kHAHviwGwcOBAHDsaBQ3HgSBw4EQdOxYEzcSBP40hhAVJcgJQWIGW6sOpBzhiDALh5K5w6U21cEm8bg5cDtz1MoFUAzGBMoEkAzGrA+/BhgFUuLzqZiUuk+JJ8CtMa8HZ8HIVP4Nbz+XLcNxVUTZfigOXnRTvpWzraPb6to51FA4UF0VrzOEiEidOFzjAgUtOzCXS+YqppsOOFKUQ2fx5S5hAwIShwSZiNxZme+fPz5ol2hkHwNkfCCtS2cW/aEdOOPz1IQEsrc4+pF+JRMSUmUdcqazKLB00jKXC7EJJjuIsISRdn+JBMwdwfUjjNNyUrNCcmYXHlukDlmpI9nlPvNFC5JrXKNalVrkmtck1qlWtSq1yTWuWa1CrXFN4FaIspULm6lpgClasDz19HvWcKVK4WPI/jcUlToHI1LBWuB3wOVbWgK52SPSvnT0P8SuVCUqlcSCqVC8sHKlfZVjSoXCVNg8pV1DSoXDVNg8pV1TSoXBVbTIF+UQcb7f+LvLePcSzL7sP43uNXFauq2V8zVVOzs/e9GUk1qiJZzequYlWpu/l6+qPmY3dbsi23LcvuVbeEBnti96w2QCdYeLi2k3AQJWBsGWC3nSzJtmwGkBEmcLBEYHspQ1HKdoJUYkeq2FZQMAyJgGGYTgSEARxv9vc75/E9ktXzsYn9T3owxXPOPe++++67795zzz0fkTe0Ja2rJeX3CJdYtCcN5swdysNsz0nYShG6pO0UugiK0EVQhC6Cw/CJROhiS2rJDCy0zNYqBoN/5FTcXWlELyW/9eR4wtzx68mKTJuBFMZKeqmM2YGo/8QUN2LL3/WsNjQvJD01QJ4KUrWIceDsUJMCtKZoXdC6og1BG4o2BW1apmhsjN/eb6zAaPQ3VuyPTdFv/toKp4t7bpYzpXuWM6h7zqyLrOOe5yfrXuA37F7kbOC+QtnJFcHKnafU5XKeWnYXKK+5i/iBJTNkOvcMhJ5N18HPmhvHj3ET+Fl2k/jJuin8pN00t0nunFnn5GVsntgvhWkIzZkQ/sgsRpGFKJKJIvNRxIogsPB65jkm/syLm8QzL2GSz7ykST3zUib9zEubuWfeXBjJMwQfruKI2Mw9XPUQICz9cNVLmaRJ4VgaJz8PV6HVNomHq4hHYOIPVz1Hz7T+8+sPKXvbOG9aV8ODjP2x2Y2X/ZhZz24uWq/BLXTJvPJ1c8ZcxHOaC3hAcx5PZs7hkcxZPIvJfv0j1JaLxRYt5MvdsgXDHLhu1mElUYJ0mdu242Mlkf97jsmZkv9/OO+tfveFG3fQni3f+aa3UfEK9AbZlcOzXQjEPOApwKrBY1yWApUdG2IKv2EsHP05UoCIeRsmvFPYd5Fu93ZXzQYV/60fzMJNubLr8ErjPJstG720ViwSY+yBVuvAwoKX7mKbU8CZgzQ3geZKnTXWaeHt86Ik6nqwir+Rtyy8yAZUOP2pTGLi/tiee1arbSzcP2O20Pdb6h3KDsfb8n/P2bbj/u85bi6jI92zZPWNj0fJr3iOcZom5/+T2IFXWIU5Brr64apnmfjNn17K/Vf/6T//59fbMGvG+IIqmqu8NaktXDeWrOZxNRH/M0HNn6dOk8HmZN9CPZtUPawJxDAvhLJQYWO+4ASw6yirgW6a0BoU0jpjrEtAoHW8hXuCZX1rwcZ4X8/KHpkfPjpjfDrb9qxxt5gQfLh688//5o8OMvmzf7P5cC9Ga1mMePQYnhx7hnEKqYfABxG8AsJomlCNTxFq04T6NKERJfjxd3EaHrbxlrQkffMv/zn7P4lSOOUafcYLfMbgBZkQfLgq/Fgy8Hi5mHUrwwS0Rb+2pVrKIpKkBCCWnzhIYekgLB2E1MalELw8Bg9D6mFIHYXUUUjtFEPwyhg8DqkDp5J9G9d8WaNWF+EoFWYZKfq9C5EcJEXJwzQuzeZRx2+sVPhVYf3qOh7P6YvYy6KJWijGB+2mF3+Aromow4M38b12tm1Boy5fJ2aywW+sZNCN/+NKxf5WZE6Z+IBei042OLfgxZMs8HZ4gaoQwzb0VkM6DitsSgg+XEVsZH/O3cWQLeLjKO06taMVVHG0AnGByy8+pqLfIGXdORC0qehdQTuK3hO0q+h9QXuKPhK0r+gTQQ8VfSrokaJVS/BjxWuKnyheV3ygeEPxoeJNxUeKdxSv/k+CdxWvKd5TvK54X/GG4oeKNxU/Uryj+LHiXcVPFO8pPlC8r/hQ8UPFR4ofKV619fkVryl+onhd8YHiDcWHijcVHyneUbz6P+vzK15TvKd4XfG+4g3FDxVvKn6keEfxY8W7ip8o3lN8oHhf8aHih4qPFD9SvMrFvCjqp11GOS4yBLLZZH7B3fHQHAix4VS8rTFxKMSmU/H8MXEkxI5T8W6MiYiQbDa59L8zJtaE2HMq3q0xsS7EvlPxbocfhhAPnYr3bkCkiOu+ig0x1I+xx17hrZgpmB2er+T8UsXkILFntyjRuHP4Me48fpbdDH6y7gJ+0u4il3N3yS7LVOat52JrVJxiMjtOy6y8Bn1hxeSyl826mdt1OimzbuZ3nSZ+M7tOA78LDCO6bhZ3nRp+lxh3dF2PAboKpnednoLZXaevILLpKGh2nSMF13adYwU3d52TlFnPvm3Ww1R86/DcD+fS9clsT+sT2Z4WrEw4Ta1PhdCLf2ta7sGp8Hi33T59inuw2jL2mOlF9q9YrdBoNHPzP/pn/3Xz//yN7rVfgaXU+pp9nPZKfuwDt0xRNA9RdB/yWc7sV7x9yJ8bUCJYLY8beUhX3RSihjzzrJsH/8Vff/6//9a/e+2hKBA2/Ga64l3lYzy4FZnOf+6jxZi5SgEwY/ahoUSt1XjLxUWDVMXdt8umjDe8ASdGb4OiobHAHGtx5dHKlssvKGDuiziZh5iXh5hni9T9q0u+Vdm2f3UJE/wME5x41k2JLBxGR9mKd9lcxs1+sNHqpkzELpWUJf6dhzEuoP5GuLIsl9uRF9B6qazkWTRoEFuudTjBB8/3gy1eD+YDWnLCEtwFRLJoyYAlDsoOUxMlw7DkaLJkFJYcT5ZUz45LTiZK4BqUoKbOTcq+NCX70vR4X3pG9qVZDn/3LD8I9xw/Efc8Pxr3Aj8j9yI/LPcVDHne0OJHxw1ta6I9dS1+xWQnCxpacNGcmSxoasEFk54s6GjBeZOaLOhqwTmTnCzoacFZk5goQGOPHKjZ0E0wYD9BLwzS/DqgUUdZ9E0EJSfTJaOgZDBdUp3TkuF0SS0oGU2X1IOSanyyRPYbA1E/NubgDzuHvpqTB4RUPjkOOmHJaLKkG5T41bRYAUZ7bFxYmy3sjwvrs4WH48LGTKG0o3em5VHLiK/gDHxpz8iepXfG5FS7tG4cdnOcXIfgOjyDb/mMDGt0dHzivsdhyXCy5CQsGU2WDMKSamLyRYcltcmSUVhSnyiRj60KjUM1m+G6hdMnaEkxoc4HHL15KInm2RuceaoYxvi28TqP8DqP5ype3lhmkXskFOcjj6OFC9wvTRUOtDDD8ZHy4pPFQy2epzY8RT1ApHikxdQgd1JecrK4MS8GC5gxYMXBtYPzRme+4pVhOhXOrB7t1Ky2KaOCYD7Ha0+beWNpCK+86KRTJjMm5VQNqkOgpkMAvXY4jyGAVugLiE+07zgsaUyWnIQlzcmSQVjSmSwZhiXdyZJRWNKbLKlmxiX9yZJaWHI4USKDoo/H689nzMYPJ+tANMGKs2bHuPCpiOJee9li12yKUqS/4Tm/cAvKMZfKJnNNqvhuO8wG/Qs4QFvPXqEKIHvFrMNdpp/Fx56tSKXyKBjE3Hn3ljyEjgXCtSnLSLLHip4IeqLoQNCBokNBh4qOBB0pWj1LtHpW0JqgNUXrgtYVbQjaULQpaFPRjqAdRbuCdhXtCdo7awqq1cLMh4Vk2z4wBbOxbd80BVPwNyvbdhnQtv0TJBzCv6pkAvnmhc6LZ0ORR0lHs6TjWdLJLGkwSxrOkkazpOq5GVJtllSfJTVmSc1ZUmeW1J0l9WZJ/VnS4SzpaJZ0PE0q4JQnzzgkMSlpWiZPTe26E3tBdT3JHcsopaOU7pjSVUpvTOkppT+m9JVyOKYcKuVoTDlSyvGYcqyUkzHlRCmDMWWglOGYMlTKaEwZKaVqB5SqLZTamFJTSn1MqSulMaY0lNIcU5pK6YwpHaV0x5SuUnpjSk8p/TGlr5TDMeVQKUdjypFSjseUY9tMvLwTW15eXjtLLxjYRikDpQzHlKFSRmPKSClVJ6BUHe2sMaWmlPqYUldKY0xpKKU5pjSV0hlTOkrpjildpfTGlJ5S+mNKXymHY8qhUo7GlCOlHI8px0o5GVNOlDIYUwZKGY4pQ6WMxpSRUqrxcf/EtX/GlJpS6mNKXSmNMaWhlOaY0lRKZ0zpxGV77F0314MdmSwWnHlWZmeeWVJzltSZJXVnSb0Z0prdWfLyvvNBXLbGCOKxAT5332ygChfb1c5Kxb2Kre9KxS2ZDbTJvWk20Fz3DrazKxX3PSdaQ3+lYt5TtcmGf7hSMXfGGBR3N8fY8UqFg1+wk5WKuTrGBisVik+CDVcq3CtHtrtxHH1QvY9dsbfhx/ggyHQP0QxSeEfABPptQyMsrSOjfSDI1Tc0ptI6MthLSCUstBtuhgt+RHmxZvc2PN669N0XIj9UN8bG27vl9s29X9r8x//xv3PrWvNm7p3X/+k/3n7tusn7sfe8PI7usF5nzcZ3PeeFHOg9WDVyEgVL9+qGtIC7Bzml+oyKWWcQ9mi2znkdU1+8ysbLqpzTMfnFq2y+rMqUjukvXmVnXGUcbnEPx1Um9Zv4YlXiw+yOq0ybuEmHrUzoB5StBCJ/d0OP/eLUtlzC/wer23Zvw2zQqTj+mXeEBT88ICB3Plg1P9ir8OQgljHr9rcov+mBRDCgKcEObCHKBrKnWJJYTTHZHx9bgs0R6yg2T+ypIJkJExX88yiP1x0eeWD/AoHVFkxu2VVMbllVTG55ZAkmt2wqJrd8Isgpt4yz7Y5YE8ktj22PRkByy45icsuRJZjc8lAxuWVDMbnlI0FOuaV12uEx9ViWiT+QX7wU3TJgf4FFOe9bmHtwsq1XrZXbbX2re9dfyOGn8ze8hzdM7a/430cqho+8vF+t9r+f+hpsQ//cv/i//75Ng6q8//3vX/9KvAzS37XdjfHu8e477ekKaKv1MHDrrFY//tPQY/5xs1H5qzfMv/9nviddG//BcGqz6Va7baybv/XP/snfj3X/1vX2zf/1J3/3b/7dm4PvNdsovPm3fvPd9+7/i//revumeWv4Z0/W/tX3mu2bf/Z3vn7md5x/db3ZNPH23+C90t/iz7f+9Pc87I1QL8crXN+tpnGaL6AudZ2McTKeHgXrcB6fOP5yeOL4y9dx7Nvf8GPuzTCJeRjl2j3/Zszvzz328m+J4vCMvD9RlOjGCuP2hRiNdM8g1o5rcem5Cb1uqeJdRaRXWeLceGTyNjdpebvvH+LLxcu8g5m87C+Ysr9wAFuFOcwVxoPO7apflU8OcbZgauFmaB/mpsxGLpaGFtfMmTguQCwc/C57UNSlGc5hY2wj4pXbnEwkUka4GW0DhW2HsVrj7gkODw02wvQH28ApQJo3S+Ema1RpxDnJrZk7/uYHbEp5246FVikucsYlEBMF4aDYfG9splI2cy9Cy7bvBHC2rw8x9+kfByZFODLp3cqXy+2Hq65lw1U1NTaGyZbbD0TVHdu24yav4SsjUTJxLm+4Y497ZT9uyn78YNUrc/ceh6bcj+OcfcrgYGNsJqMBITbgl9WK7PGT0jVYumfvys8oT7uERPMFvKRiwHVyizh/tXSG4QplkujM0EfLJKKdkjAJmOa0aUyUh1LTlCphVXlGiriKGMDBDN5bovC1j3BMPCt45C7g54m7iJ+65S7ht2q5Z/Bbs9wsqkm7mHu68YpbDqvf9xsFHc40xbnjL5g7OpznZTjHOZyb1EaitaFio90ODIncs+YqVdj7Yq6SbLvpcKDPm6QM9FQwRlptMycDPWzKne++GMeo98owiEzBozUVHfMpU/Lj78G+CQnw5h5y1cNwjuugT04M+nmTlkEPTVyyKemASsGgvzM56JPwAjRjy6iWNzdeg2NlM/+pg36++anvdw6SgEkHjyeD3iTkYRDS1kZIg/jpg7+suVdfMvhLfhz1HKx6pfHgL8ngT0wP/vnpwZ82qejgT0kXYfDP3pWDvywd1HxBKQk4XraJRwa/zFTQU8abNECLR10mTTzaOZC80sHg38co7cYppDMMyRJUvO22ycKWrI3on5Y5024jbmjTPQedp8m04RptmcV22yxAq9tum/MoPm9uYjzf9FO3KdI3X0feZ+cFP0zPMufaoSGESqWvI2DL+Sl6nj6B64zxsS/fZ3bL5PE9SA/loagPwG6aPlEnabm0J+hA0UNBR4oeCVqlVMzJpp42eZCO07tOR+Fhetfpp6U8Kz/pYGri5wy50qmAGecJ2Z82efQkSrJ/FCulrm6lD72rWL6ggytxy2Ty5qqcRTJfxD51bFp0FXGJhHo0Qc0q9XiCuqzUkwmqUepggrqmVKjc9vmyQd0kVd/ZPE3S8jgpeSuWkDnPZXxB7NVwSiDSQm8pHLw0XPQ7r0fmTks3WYdn2qru4ite18CxSjxS4jBKPFTiIErsK/EkSuwp8ThK7CrxKEo8eb1CU0g5mj95ndtDpYodFXykXgexn61Qxlv3G2+g2MtDr3+YxFjOU51MXTycG1/H87xOp72ObjOqXyLaVbQmaE/RuqB9RRuCHiraFPRI0Y6gx4p2BT0J9jOCDhTtCzpU9FDQkaJHglZ1e3UsaE3RE0Hrig4EbSg6FLSp6EjQjqLVN+R5Fa0J2lO0LmgfKJd1MZLYizXekDcwRO9FbaD5fhpvoOx4VSzvNrR3BG2mtdFAdduv7SalHqEMSWlEKCNSmhFK9fXKWNWgz0BKN0Lp8KpOOqR0SelGKD1SehFKn5R+hHJIymGEckTKUYQyvMguK2l7gYVGX+t+9RUWH2hTBburvS3YPR1cgt3X3hPskT6QYE/0YQR7qg8imBh7rft9QWuKHgpaV/RI0Iaix4I2FT0RtKPoQNCuokNBe4qOBO0rWn1Vvg1Fa4IeKVoX9FjRhqAnijYFHSjaEXSoaFfQkaI9QcW4a93vC1pT9FDQuqJHgjYUPRa0qeiJoB1FB4J2FR0K2lN0JGhf0eqyPK+iNUGPFK0LeqxoQ9ATRZuCDhTtCDpUtCvoSNGeoGLMte73Ba0peihoXdEjQRuKHgvaVPRE0I6iA0G7ig4F7Sk6ErSvaHVFnlfR5hsVs5HdVmul2LZdf91cC82ULocmStfHVHiOZmDGjUC1ZsNdN++KZrDon4j9p2uZd0QtWPSPleSYLQm4XvSPlBQ3vsRdvyUh13dFU3RDXBVui2FJUUKt0/jNPQs06ybNTsTYNAFiWsNv7MDcnyEk7podiFrwXFpqU4xqQjhLtrkLRXxVqDwsk2JYKQmUiquzGt1jB3sZyORxc7bNaBEUuqAJAfN9+LdAhZJAsAhEEtpBUtg9s+OXH2cLsO/7b1cq3qZ4WhThwe/R7SI+NsR68r0X2bblWvLgCXG5iDpgLIsDhnHnxFVj3myOVR60LoKduHGgBcvAAHyT9t3UJ8wLeR7iP8miZpgT8hxCo5C8THJayAsQkUnOkpwS8iJ2GCSnSU4KeQkSLMkxkhNCPkM3fvYGTRNlX7grFzuEsmId3OQzimUHHpNCNIlr4jCH/qKKi1FSb87/1osnV+e/e/1h/Ft4n7TTbfH9Bha62BkZOrsctFB/wtAB5m6LAYJol/sDOnbdNMqlKxo9ZR61GGMrS2G5+TIbupdt8yOmdHAaKtIe+u+tIO7aS67YRTmkHUhBxVys+/dWFmNmx+xt2/2U/C6YnTV7gb7ZHh372P8SEY1vaAwuh6AJwbUQ3AzBUgiWQ/AgBO+G4L0QvB+Cj0LwSQg+DcGqFcK1CFyPwI0I3IzAnQjcjcC9CNyPwIcR+CgCH0fgkwg8iMDDCDyKwFU70v4IXI/AjQjcjMCdCNyNwL0I3I/AhwpPbluLfs2DE5sMo4iTXQGhY6zH3vpbNBC+UvE2c7Ff/vYKPYGr/+XZipt3yvgm1+z6t1f84T9JfFjxu3bF5LOX3JyS3Q2TwwVQGtA4of7tlYzZ8J2vsZrYHmo0m9ki3Yx/+dsrODGCYW+s4ub9mJszu2v2UcZD+IANanbpspQ3OYT09Er+csXdMjmTr/gnVsXbR0C4q6HSwaLhyK7JMdvvHqzdOMSfmT1MkqG9frbcNvEX31HsXLntOeFhQAjClws7oa0Zu9jvRSLaQRe3O6HaarqWrGSO2YP1mjTiweepiUu6ZewmLVWtSlDL8P91LSXWA+OovaCmb33OmqQKVpgwYwviI4mkWgontI3vhkUtTOElg3s9M87DW96GuXrro71Y1uybDfiM5Oispg5TeUzIh2md0FV8DrDjEMPE7p9MlA4ipWYXVpGRwlH00uZ3cJdGxuwiwA22yruIOkOTMLOLiDNC6wnN7CLQjJAOla0ZGTbirRQYPpsQfLj6cC/2u5bZ5NK06zQw5vUBOd2OH1Cx4xCLPqCWDiKl4QNq4Sh6afM7u07z2ytmVw0lsfCrWSQWfzWChACgGkgIAboLElmhmnbnYOb/yQrD2AxSno2eUePJXVh0eg66KKSMUl4cXZXWgI1co/06arAZXA+CUnxsUbfJkFzGEZ/tJKm1T1bEQ+yJ/DyVn6p6kdX0t66/Df19JD/3zLop7MXuwgfNH9TELycwO3+wF7tvl/HACxr2cBeRoNTnEYF2RFzcRQSeoMuqC+MuG2XGXTbMBF227gwy1KBg6qoFEuemf/ztFa1j0z9SehIBHZSeAo/S02jstwOZdtM/UTq6f6j0ebPpjxTGvap/akXTCW36NYUX0dkKQ1hpKHyG3dH8U1E3peF1NEwqbHnOcwY0hu/eGQMIqq0lQiUY9RGC698CIbgDZgghYswcZVyJJrhOr3urLcEJ1yHEQfR9jskjTaNTvO3mc5kmd2ncZLXFSbhDkI7CdGEWWZXOzSKv0u1ZZFY6REv/01Was2zOYfJwzvo0d2DEw6brwNZVbKvaTQZptcUAq910E4gmSHMRYEmGCdhgPMWmm0JgQpqbAEvT/XuDYRgxmeqkNX9btEYavNm1F2KZGNe0409kxex8Iq8BbuPdT8JX2/skfLX9T8JXe/jJ+NWuO81PVtxFWmNu+kdS0KKrN/pyoUUn8HWTMJkW3cPR4/MtOo6vQ5Hfgkc5XordgswI295FbCMyZhPWg81PVswm4/gQwA0kiqi0AkddMW2dSQiMVpukwHgakxIYT2nSY0/QUXUFW51NygW7Jo/tZqyi8oO3kd3hmKzKABTO5u8moqwBTy3KU//vM9M8bD9lCe4sv72CDSfjjcKX0I8hlsOOf5SqMCJR2ewuzccs/Qfvym3EdCrRCWfbXAnUMf2UFBzQD4fgXfrhELxHPxyC9+mHQ/DRrjNQ8MmuM1Tw6a4zSpltWLMDFdXLNqZloDVF64LWFW0I2lC0KWhT0Y6gHUW7gnYV7QnaU7QvaF/RQ0EPFT0S9EjRY0GPFT0R9ETRgaADRYeCDhUdCTpStDonz2vr8wpaU7QuaF3RhqANRZuCNhXtCNpRtCtoV9GeoD1F+4L2FT0U9FDRI0GPFD0W9FjRE0FPFB0IOlB0KOhQ0ZGgonq5wrw3ltnGaPyE73u+Iga622YbBvH4W+XfTpIbwOdmOxerpVa/8EaQptaXkEMZUbcKfswtvxnzq9Zjb+OtmITjgthdisT+3URIMr9UcTclnJubJ4O7+2bM7yYee7m3YlFv2PWx2iP+Mr9Y7K09avKFszkVLPM17NVfZFwbqqTfWBkbewWaGlgKBSoamHvVDgMNzrpfP1wZ2/M0DlfGdmDNw2DGXPc7h8GMmTO4R1fqkjZVxSXXY4EwtttMb5fjLJ4B1gyweWCNAJsDVg+wNLBagDnAqsDW/a7cQ+QZhEI4iZPeUzqUJql2u4mlbyBF/UhRso3DuaEUHEYKEiwYxX3L3XfKZt9swpj7Q4nTOBE5aGc6ANPOdACmnekATDvTAZh2pgIwufumgIWtoNL4Pg5GpgI/5afvm5++b376vvnp++anAz/lpwM/5acDP+WnAj+55YxM6LNZVnZngspRITRLWp4lmVnS2ixpc5ZUmibNhI4DNWd2GRPogKp/IGmcOJLMFPCEDGRZQmsI4UhoGYEbCZUgHud4Aw0oTvLmjvMIkmgu+ukDrVoVLpnH8Mctr1JcKeFEU/xLID6pEwoFMPFUoQAm7iwUwMTrhQKYeCZBbvMtt8B07LbeZjxU1ygkQfDCmBvLXRiRY7Frh5G9VerCaKbQ5QgSo+Smg3H+TrxscgiHZgqhpAWXyhwm2U2Tg6yyZnIQUwxSIUEazUE4yZqcYURn+gEj0F/tSLoh56cr0KHySOa5uD/n1p0yo3ITPKAYS/Au5VuC9xj3muB9RrAm+Og524Ewq5hMMdE3IjkCGL1BNLNFiYRTlEg4RVHEFiUSTlHmuuK6WAtgksbymELL81hG7Ur2y2YD603MbG/EmrYEEYoJLc3QP2lBskSygiwTWRbEEDGCrBFZE2STyKbZ8NZ1uWAgMktXr+gy5C6M1yrXwXqIwLZRm05mRojESQ52xd8LjRqaEafjaAyGVbMw6UcMWzaGI0pIOCJa7RrxEYUCG7E1XPqHpcVOOObadhlhMWsWut6WTZoz+UKUeiUaQkXDXyMmf4tjWGVCxvRJ0BrUTVBmJCUplCQ7j5SUUFLsW1LSQkmz60mZE8oc3wwp80KZz5grSOaQNVf4MHhlhLJ4X4SW8bIIGbwpQmvcqMkpwBWGq5J2izR/hZLsOJrc8Pq4d+VwoEXNut2SxerAXGHKlnXxCrfYOCswgjVXmLpFC+f5LPMojEvhSVg4x0ef04MDFA7CwjR7Kq2afxQOw8IUOzal+n8UjsLCJN9DMjwFELGBQacSEokqKXGpUhKlKi0xq+YkHs28RPitWuaK/S14k9NoN4wux2DgDM7dZHRyhgWXo4FxKA8MHShdqFrSUwbEMDeLOLsxSzgLOsOzoKbJtiXqkxWqOUwGt1jkLZZwizN6CzTDc1rGebBohRZUHKJjiyEoLLOBoVSsH8pd/MQi0uPphlPe+iq2hxFZj8Ia546FZkaC31/Bh/OJ5cfujL+Yo+sPv7EX+4QBWTYxG9DadwP5Clo6p4lN9712Syc3we+2WzrLCX7Qbul0J3i53dJ5T/BSu6UToOD3260MzvhEisZZFMOob5oiDqDacvhUZPd6CZmYLT2cWyacYpD+LOE0I/SnCc+1xW5+OxdrJiMTlWshApiN+w0SovV1EKP/JVK6a2UQNoz8wyi/TXtG+yE5UsoxeilHUjmqyZdxJJSj9lKOeeWov5QjrhyNl3IUKdFKB8/r0lCEuWpbOjepC0nRpHR9KZpg2SnStZYGbBsQB7AdwXklNitZ7zWELa5jI24O3CuaJti9hJAdc4+9Tabb7mH+2Ibq5ommZpbQlnNt9Zlj3Kz5tjq0MfgV0nSo0xnDaS201S2Mds/4IMVji1Etl9rqTsUAlfKJxvzDfyDhz5D3EhaVDOnbomj53HPantVysxzsRhrSwNBTN7vg9iNYyamLmt702DZyv5qjswH1XLwHlVcHTItgt9yzHOpaez2ovR/WPgxqb45rPwpqr0Zqb0rtlEjLknSh5Z4TZzD3vDiguRfEA869KF537ivi6ee+Kt6F7opovdzXxK3MXRVXNndZfOnc18V/z/2S+Ay6b4ifovtl0Y+5RhzUXFec4lxPvPLcN8UT0H1LvA/dHxGtnPuj+H2K9LI4uHYTxqLAaSEan424fCnYN2PNiCAv5PjWNgFkBRCO2ieyMzEnw3faXvyFC7kzLjma4i/cOBRhWTktTj1HJtWkOQer47OYrbMyW4+TRBk5PPgODa6xe2i+4FYDK1VbDuxHOKw+KzllSBiCcC5QfLd2nUGah2LLlW371xM4DJDEh31oijt2hRG0sZfPvUXVG4L2Y0e/Y4prdtwtQtO4bUPiL27b3zQ5s7NtPxHsQ8EemZzJbdv35eeP4Ed8f+8RHAD8/QRPAN5FbJxYJftzdplBMjzGysARL2Rhz4EfyERn5iNB8dAXk7av+TBNHs0EEaSDArZkAsxLKI5NxumQTIBKSjOCBzMB0prMx6xkP/CK2G6YIlMBFqOpAItMpYciTQUIUNL+7YxTAeYQeJO0wmmpAK3JVIB58jsfevumME7Ol8OW40OvbHZOSQWIZ5TnxoVMTZij3YjzobcTqaJo9idTAeZlI0P+gplkLU+mApStFYcDtHccJtkHco5kePachtoDB73pthg22ObHMJf8KOaRH5E55C3MH29y7vAwb7jhnNGzWhiZ1TlohXnIncaAN6jiy6jiDaniS6jidVaxjCpWwyr6UkVtXMUxq3gNVaygilelildQxUVWcQFVnA+rOJQq6nPyZDVbLDP4pR1Z3PG0+HiwLsCi0MZgqaeFvW7LN3lMTnh8kClNpoYyNZTphEzZgClLpqYyNZVpQKblgGmZTB1l6ijTkEwmYDJk6ipTV5lGZFoLmNbI1FOmnjJVbW4hAqZNMvXTclbe09nBXMr+hxbnD6yTV7btNJJBJB97xfFswQP4NH3gGLaCQZS4/+USIxviDVE1LwsI3bAREMrcNQGhfd0UML1LxcQGFeVlgR5hp5CTxXCXmokNUSvfExB64PsCQnH7SMDsLlUXkPt2qbfYoLK8auk9LR5j5GR55+lGTpZ2HnrkZGGntzzhZbrJEzygfzzBp3SMl1tbdInPyYJDZ/icLEJ0g8/JwkQHeMKGnu8E79LlXW5v0dldbm/RzT0nSx8d3KU/JSGhdKhNp3bCa/RmJ3iPbuxyf4sO7HJ/i67rOVmE6bQu/WrTXV061qajetFPIV1u8cZ/UK1WT2iyXjRF/79xKv6Tj2BlESf+JtHdbTvmJ2XgeDuYWbJ/1jq9Cr1SrxDePwfeelImHsR43b3x5//qX/i1v/lrf7d2bYfHt1e27Y4NQxAMvG37V3HClRbzjX1IdXYQiK3gZ5nRV5pSxkK2Z8pY1rag4vSTH7o7Zs/s49jOhRta0UHoiqLOi2bLcLJnShtKN21ZRDaYCw56GI4tTDDUV3FotMXilG+13RQjUb6Qtph18sNoM6tgliuHV/STovQEsq9IAa7Oyx7fC4xKaISy4W9+6OUqfDCvaHKivR0vkxE7iNW2BpTJ+elveDuVyN4h3INt+Nbt1TafNwjAgguylZdfYJ92wfKnXOCcdoH5lAvip12wVsFjn35BAhfkTHF8gZj+BP3oH9kylmJ7sb+I+czethvhztRF7+JA410dJnmOpvFElteJKC1QFm8tr3PAskAG01heP7o1gTYxieV16ioJVN6Vl8hJ40Cgu5jD8vqV3hPoPmawvE52jwR6ggksr7PMU4EwPVQtgWsyg+WDKbauMCbJhsKY5ZoKY4LqKIyppaswJoWewn2ZxPLBDHuoMGbII4UxuR0rjGnpRGFMKAOFhzKN5YPpeaQwZteqre2XaSwfTGl1W/cIljjHNFGGZ7GdMr9KeO+YItS+ekRBQ1T7MaJSM4hiHL60CVN87OV85yO3DHsoBJ7+GlW63/rI3cMpFs/udzBO9Tt/xk82LT9Z+Vl+Bp3whh+HDVLBjyNC8x5jDdBirBwvR6thJeSnzZIc2Jsy+U3x1njLD3OxBQeWR/u8xsXEZ91etCmHjokwKrb0IQozD1EmJ59lhxrxPU4S0WfZlJ/7z3SWeiY2WXyYHTzMTtC4Ak4KWN8OHoz17Uh98lDW1EMV5DrbSKTaBxTTLS43FjLQTkxveXx5CEyCL/H38It9hw+/ILvivoPP0OT9oV3xbnLn4VvuVX4wRW+DM/RlvFnkq/ET73p3oEj1MSN9s4J1hOoqxe2PEd+w9MyzGOfwmWc/9K5zaoHLtW2ug/zkmagfzfVVz3qIqNfXOV2BxRGWjgW1BbgKUR6bPHHhOWFYb3uaxyJPQnga9jOt5eFqBsUVr4SgVNcXqWtPfuhuSccW8RAl3/kmo0NujF+HzP3ONysuXq/1kXsLYxfgHToW/smP3Bv6xvZ4FuJtVbxrYthzzWyZchgzdUtOh8FmfePzcBZ8u+IWTM638cZvyBu/habprQpiz+di7BVQQZA3rKDhL+UJ6ceYfOz/yfcW4S6WxkeUh/fmhxV5wC2uuQUM5oQp6Yi/7cfca3zYkm8/jgx8TNk39Hmdb3o5Db9mmX2TQyOCeK63guflQrgvBa5lbpl9sAURRPZDtuznY1v+xuxNc2PpV7sujq67gY/shilK192+tRibaPcNqeLGS6qwUMU1fEjXzG2p4rJccZn9B5OjyR6XBbDoFsx13z7g3fKmYLYo1HhluZg0P/mhKQl5T6vYC+/rFUzpgDfMqyB0S14SRqd8ifGZkcmR/Ni7tghT2AIcWy/LqRlcXDFQS2o8gMH6ju5G0ZQSJxkdVGM3u3c4Tr2yspVDtnKUbXKQlqSbtuKf4w4ZGojSpaMNv3V83+96txEDzpKO/8i9ASK+tGt4gC1YPuhcWxjPtcGdGFhL5L5N+EimeZij7SujfWWzpa9RorDeoMV/2KqgJtYDa9dWYAMbf18WB73QkoKMnzAbj93L2jpp8nV8NzzHv4ZhVqi4N0zB3JLmRZ72NhP6yLPKQ/LJSvpke9Eny8mT7ake5VOe7LpExy2d/kxY027QE8ZYdBPV0X1Zw/fY5agFsFeKYA+8rW94BTg/L8K71MYs6ksQ4rzk+8jLKSdMAVyGdEIueXWX932LDtXhfwjRG8nREc12JMnFnAksMYHFJzDYCUwTDqYJd6cJ98K7YzHw8UjphTEElqfT10SOUZRSs6arcbbthYUxRE/smat601fd+DPVavUotmNn/Zh7FV+s78exa8tTTYsOTGzbFyJd9nMMlQhWrNYLVkYX6Pj7XnmRs8gdzPbiFmy/0GEM20XS0qSlZd1VWpa0rKyzSlsmbVnWVaUZ0gwe8qq58xHEgaum/BFbwftF7Ji+7kbfMx5fhAG24TP4HOXLfgafrXzLn8FnKZ+JcmG/9+5HvvWL5ipkuoJv/aK7FxmmO0tOzLLjkDd3fMfNma1Fe8FBpwtaYgwBSqOlxZhvU3rKmS06+d+EQjZmcu4OHPyvmsKqe9XsmXe/4b5rKJzBoCGP41tIZeaqb310a9seyRa7nkYQgnC3HSPICLvbdmPuzZifDbbbuuOXXRQ4C2bzbTu2Y8exEn7DyyEsBS0NzordwTmxQjgvNgkXxELhIg/h3FfEbOFV/JTcFfyU3dfwc+Cu4ueuu4yfe+7r+Lnvfgk/j9w38PPE/TJ+nroGP1XLdfFbs1wPv3XLfRO/Dct9i4m2cCJQ1BOBIk8UfozR3S13Db99y30bv4eW++P4PcKnUORJgoPfE0tOIgeWnEAOLTl5HFly4li13SXe3xaXv7qNUx22wDY5BH2gAtxmqokmFeBpnAkUqe/LMZ0adAxFqvZyDFDB0p4tOvNMm4V9oms4iCoy0iDWIBxEQdewxjhUtrj0MaM8z5zn22YJKlJzBhrSrFFu2Gj8KLh/DNxrwv02uH+c3DwVcgJumHd8GdwG3K5we+B+k9zUAf9IwI1nXwH3a+BeFe5lcL9Obqp73wi4YVRyFtw8zDgv3BfAfZHc1Oy+KtyyTuY5zBgSZEPlliDnbdHYEuMFnV5U6Rkj0Z5hTkeZ015RBIANWU+mmbNR5gUcESjz8inMy1HmrFf048psTmE2UeYLXtFPKPPaKcxrY+YNOeqDcZMEPLPaLTlj35CDRkusoLBrxVl4syX55lm6LKXLWnqAMyRkCms3my2cdS8LmxE2o2x3203hqyJOFwBYwTdbOBE3csWaXLGmV9wLrqgFV/QQ1AvAgN4yLZhhrDHt0w7tM16Eep9UYOCWxaFMSkyRWG3JsyJ81gTfGekC3vXJp/BlpTPYqI71KYxx6Q42+uTTGB3phSVmTrM/hdGSR3akG4y+OMNWO9qt0iE/6C15b2hBNnhJwlQNmGpW8NrwQGf4usUkhK+2Gbw84b4XvLE0Qylx/CT15WSD1xUMDNMO3ifeFd7Azpr9120vp4MU0ZvHgqPo92VDuLNm98AWDnxrhttEuf8auMNvapZ7OcrdBXf4uc5yZ6Pcv2p7O5GZQLh5qKYpytOS7E8+wZi3I5yxUzhjY04oaN+KiQMxTl7X7MYcVYrBSSxcNPlppoPDWngvkJINznPhrskYZMvBKRmcNiUqWXDoBddNUtbkDGvXXIKhtazTV7btLlbxS8juuG0fRlb0nsADwH8NKtDcmzF/GHvsQY9vKtv2si7nu2t22t2BV+QCldBF6Uko67lDuBLqxq/obJNuixlgoBunGaCoxmkESM24mABu6Ojh+4664/2EmPbsYobcEF+4NXuZdyNo+Cqbkhi+qFWlea+0aPC4dvyE2A2hJSzLilqPqxDLSmyYtFF0fVzPfsIUxfyOjWWxYbFhU3npAVvPsjWWrXGZZdld6oBZtil7wSZ92OEI8FaQUX3T/hag2s96V+ixU35Mw/i6WqVsU1JJ47dvuXM09LHcefw2bTeD3yPbXaDxjuMu4veRu0QrG4QK26bAkhWbKfcsPQBs9xx+j233PC16HPcCfp+4F1mr5b7CWmGRsU25ZQW/Xdt9Db8ntrvKVjnuMn6fuq+zVsv9EmuFQcY2xZwv47dnu4bWTLbrslWO67FaiF/bFLPeYrUQv7YpFv0oH9Z2f4wPa7trbJbjvo3f++6Pwy9nrsKbWGom2Oat1EDHJjZQAx2kiuWN1UAnztJDNdBJtVk4UgOdBAs7aqCTlEGJYwM4lLwJg7u3IIX8CBPQmh+FscaPwebDrGE2fduEV5jXwf0lcL8h3F8GtyG3C24v4OZnfhHsr4D9VWFfAftrZF8F+3LAznliCexwlzNZYT8L9nNkPw/2CwE7J5ofN0yyy/y6ZJ9n1E2yL4B9MWA/SdvfYgJ5i6MRZ/7b+KLpAgNbTbq3iE1uTPxkkLniijiAt+mAh7KseMkgbBg9YPgevHgb0d9giw2Iho+0nkkyXa7EGGs2vTlxk2FgBC/d8hZhytl8Ie4xXuZ522NciwzM8ebaLbHT3DQJCIRwomhhicfxtfjXeAviApqQbLxJsDlkY9oJ8C2IJ2hSsvcuNfUcfYHmfIgSATIybnQQTiFNA0qTbtKXJvuXLUZlmGuHBh1N9cqMdF/Vbnm2+B151nMx3ww6cWRJsh+x9Am6r8YrbIneIS5KDCvxImpFknjhxdsS3naTvQhBgc+OToaFIh8wqU/k8BEsdkdYzYsMnT/hkDUvNeFEB+f7R+rZswELWltkTMmMxxAXTc9GAL+ixr5oetzzLHuJtoe5t0SxLdn25phi2YN7oKFcY7e9DONQWk1voe0lWjgWQ0TLed0cZJiMc5MSCJbHibCCyMLp0bWy7dlN+nhHSrEvQfIhFKxNFjigHWBDv20zNv02zi1z2zZD1+e2bQlq72NF/PUQ/OsCHsFmqRuBf1XgBmL0Sch8vwf4LwncBdxkgiirkv05MTRTr07XUXs1xgu9TwddGBrLYT3P/Vpc/sa2tCffg52XxDvMMXooot7FRUqyjUPUmvA9iIvthSW65MTYY5yHjjxRlKPCH8h77ag1Eow8jtTsZxSruDnfcvMwaWc6Nu4l4OTbSeuAiLfhOpwWEcjjog8fc0QCXDK2mDXK586wmhwuRDmONP7JCy+FB2y2KXF6Z/m9Esl652jmiS/h9Za3bJYZixOqlCWxlYODB6/mFpHXncWQg80crnql5Z035yNXpeWqdHBVcLdzsOkLrnq15V0wF/gRUm3DTbcJ9ukQgr2MxNPE+LbNvJlrSWzKMFl5TnKtWm3Zw4uJIEItMjUWazEe5hlHnnXNW+R8g/uvtLyL5iKnBtx/nnGLeczEqzELkdUsMP24I61+jRe0vDPmjFyVkqtStEzWmIpJXj1HIq86g9iYc5yCpYcgM8EAPUdLBW/1mRdEqh1+/NCE8INv3CI/urMoNkvozKJYJuFtFGl/1GyiNjREbO3YjJxw4TlyAVfTSzwbm/3hXvGpe70Ou/ZXELPoVXNO1soM1soFLImiA0h/eg0b8BZ+gr0dztY3zCoO2zfMskw4cziE38BUeddsmIsyYZQfmwuyvzy/6+D4Ig/D+Ly3sRc7fKSnIFf8+iBWcTfEaP6KP/hfYhWzm/WE6VSW5m/GAjOD2j2UHscq5orf+c1YELntit8QWjdKawqtF6V1hNaP0rpCO4zSekI7itKqxzENTHDFP/5NfPJcO392vEQ9bQFchpfFb8cqodQFp86BUmTtgg/HUClY9cPQL+1wMWS46G3uAWgTXsKSvE0FwvQFshYGF6zxApHL9Zp7vObL/94//cnef/ZmH0PIhQdj0S6bg1knuINZ/7yDWf+8g1n/vINZ/7yDWf+8g1n/vI3ZRmzMNmJjthEbs43YmG3ExmwjNmYbEZ/xBcxJXCVMS2KNU6QrrdOURaRoxDEHPiE2c263VLcm/qi0fDqg2ajYF8IPjb2LTaFExhLqE3YwfeC4QLTUVuope5m+iExmItxViz0thsM81GzJSVqNBWtiMswzV7mgTjrc3+AcVNYbNFt4Ejt4EnhU4UnoSYsnceRJDlQrscuWy+79gBY+OHU/0ATTBTZJzn4PaOETMxxcm1ILl7qXhMO1Wi3Efxc74+aLL+pwPXY6odmhGPLgceKtpq5EsIvOwTxG5IA49q70TZQduVhCWrInF1tIS3blYg6pBmtiEakWa2oUqSZrahZpidEazIpgpoH5q3jazGbLzNb7LZ1eMK9hWgrwuuCHAd4Q/CjAm4IfB3hH8JMA7wo+CPDePbnh6Lc5raEVSCdpLplLyN8qio/sirfLpu4uQqippZib1BIHdW4s0QGEHvHpCT7hoxN8SnOqTdm78i1syhaUb2ZTNuo0p9qU3TfNqTZlS01zqk3ZJ9OcalP2vjSn2pTNK82pNmWjT3OqTdm905xqU7bkNKfalH02zak2Ze9Mc6pN2fbSnGpTFAU0p1KPKZpTSfttmoVK+20a6kj7bdqFSvtt2oVK+23ahUr7xS5U2i92odJ+m6mLpP02kxZJ+21mKJL228xNJO23mZVI2m8zH5G032YmImm/zRxE0n6b2Yek/Q7zDkn7HWYckvY7zDUk7XeYZUja7zC/kLTfYWahTXOJY+dQwTRzCRHMMokQwWVmDyJomDaI4BrzBRHcZKIggiVmCCJYZmogggfMCUTwLpMBEbzHLEAE7zP9D8FHuwiUTfDJrtNT8Omu01cQ4+5QYYy7I4Ux7o4Vxrg7URjjbqAwxt1QYVoRK4xxV00IjHFXUxjjrq4wxl1DYYy7psIYdx2FMe66CmPc9RTGuOsrjHF3qDBtoBXGuDtWGOPuRGGMu4HCGHdDhTHuRgpj3FWT2n6MF4Ux7uoKY9w1FMa4ayqMcddRGOOuqzDGXU9hjLu+whh3hwpj3B0pjHF3rDDG3YnCGHcDhTHuhgojjulIYQQxrabMlTX7dd+6zaB1V/wavXKov/CH/xtghFo6SmJ3SDMTGqfCNYerLL1zZPVuyXqUUxcvyt5p2SDnZKWHuxG3XaBmVQygQxGl92ZLNpA5Kl7xB4J8syW7TDrUwMmDMr3sr3Ni5QJ/Ce4ZQN3MiO4FMVlrKYERkLWu8JHD1I2in3GYzpHwicMUj4QHDvNUQ2ESd6l3asTdOFVOcXFw7sTFGbobF5dsBO04EB92SIxxccZOuxmu7e6COGovcn13l8R7+wzXeDcrLt1nuc6758TP+zzXeveCPgs80aHninPhb1Ejcxj3Ao8JBuDZZPDQC3SkOA/aidAS5hxpZ0E7FlrKiBPIGdCOhBY3S6QtgnYoNMcskJYBrS807DTpfgZaL6Vjlb1Uu9dkACAZsuywOkgjhP1CIKBLzGGG/ryn2s2aUOvSuwG1LtQGqZ2A2hBqk9RuQG0KtUNqT6hX/D4Esl0vl4v9muXirCC2F/s1iBLrU1E91qejeqxPR/VYn47qsT4d1WN9OqrH+lRUD6+4F+tbkFriH8uoPRAfsUNRoxyKkMOQzW1EioV3BdQgHjx2i5L4hd+XfzxBTArxZIKYEuJggpgW4nCCOCfE0QRxUYg1O0pcEmJ9gnhGiI0JYlaIzQniWSF2JogiByNUVoRIhRHOuBhG250XuVxSW3ctxL2BJusVkb4lDfY991UJ3SHpsO+7KxLUQ9JiP3Jfk3AfLjcOT9xViRiwLF/a6/Khfkm+0Dfk0/yyfJNGxwsDYbTEMdB6IRsCaDqgul14uBq8MGPMastYLwyVp1ACnX24iken98uXzWssvADNTtZkzYUHPOell8wbZoWF56EsOmPOmPMPeFhMb5ovmVdZeK7lnYOTvTn3YBUvhG43znNqIx0Tl9NgDqXXzSu8ItPyMhK9G3oZk3nAc2A64Cybi2SZb4leqcucVmb+AU+A6Zcz/9ybN4tm3iw+XMWooPtP5rmXQYAAVjan/kH2c89m1Lj0w1WMNDoQXQARIU5SckBOB6PzIMIZNflwFaOXDkjnQIRqHplSEpBGM/KVIJQRNhV0DaI6K07dbF9xaPaSTYqCuqlMmlST4qCsI16KGZCOFV/z0kwUc6L4pjdnrCbFuBxC+DUp3eVMypxtUujLmaTBaV0NYIJq+KpDFSgU9SOb256FJgXKnJkzi03KmTJsxD1MwlncEygrWyIJZ/FIICObIQln8VSgTWwE/FjCtzLeJW4eLi3GcDjyiGcjJ2lxIO/GxWE2x22EZ2tDsZPAi64r8gQDo6FI3UIXNxVrWHgLHcWaFl5UV7G+hXfZU+zQwuvuK3ZkQb9/qNjQQqiLI8VGFr6IY8WqNsbOSXAHGyN3oFjHxiAfKta18T2MgjvY+HSqccGObe8cZduciO3eeYq3cgfHu0AJNydiuXeRQq48reO9QjkXIVEewUiPcUZOfgGKp0GsYl7RQBu/G6tA38aIHIAvaOgOwOc1xgfgcxoMBPBZgY8AZwU+BHxG1yDAGsijB1gjfnQBL6jiDLCGCWkCnlfFG+A5geuA0wLXAKdUcQY4qe3/nZjGKrziDwFrXJIBYEfcaQ3PgE5+oUWnUmb5PEEAyR082+/EJL4x7Ang2oU1BXkaak5FXJtghC3OxZKss0hB8HMw7vi0yrvIc3WJ0vLo/69vQfRTRXOJwbBi4lm2A1TDYV1iZCsjMqWcKrvirOs6sjbFZW2KBgTadFOSKsJNSxYId04SPMjy2bFl2ezjtJ4ZF9xFSabgLklOCfeMyB5uVjJBuGdlSZD19dCWhfXElhV1ZMtyPLRkHa7ZsgA3bVl5e7YsuUc4r2cOB3dZ0jPgwP5tJ+0+xE/M/Xl02T+MVYCxO674Q6APCZuf33EGP4Me/kexiskxOhg7H+gO+4nvBWhxjDbIjNEYpF+54h9BPWOZVyC2vgrN7QrUgHHzGg5mV9tNkzTLOGp9PThDv+IfyiVncAnN1M7KJedwyXlecgGXXAwv6eOSNHM/4vRlXo67cVLMg+4mT7rNkpzCqOgTR8BOCdi0rDuwzj+MVTQmGtBmgG4SbQToGtF6gBrZvQXoMtFqgGaJjv6BorK96wWlB0T7AXqX6GGA3iN6FKD3iR4H6COiJwH6hGg3QMtyFp2GxmuocdnkWG/HHLjb4jd7SR0g4T+7hXPf2GOv/FbMXPFy/vHvxCpiXp/zj09iFbdEc+RcLpamJtk/ilfodHsSozM4/AjsMk8OPHtK7bw9q/jenlV8b88qvrdnFd/bs4rv7VnFt1iIzBLTs6TsLGl5lmRmSWuzpOlmXOI56SwxPUvKzpKWZ0lmlrQ2SzqlGSUvMU08NVog1FezpLuzpHuzpPuzpEeTJD8Fd641u5r0rffEGL5rPXfnAHQsb/65m3E+ZtIzmNYVsGdYMAWYgafwg6hb+zRuSuP3iNbWJo9AI8UgJeroOr6jItaFA1M8xW047ydvrzLa0KmFCRSuvaQwjkLzkkIHhcsvKbRRmH1JoYXC9Lgw6s6dXxXr5TgPUZ1WW+JIJZmfdx5CPhMiIi9lqhme5jNmmWNSD729VUZbSj+H7UQaRhJpk2iN7/QrTQ/Ki5TZW5UEp5ry1pbdSJmBqySgXHhNy4vz6Bv5cSVoyirMPkqmCI+ARctPmi2zt+puBem5U7fjH5uthLnENzv2G0TG5IJGIS+YbQ1avYf3nUCsRbcAR9KTGCMpm4L/fesjb3spFbPxL2ZnzDbC0+RijzDaypHN/eBneEiEpB85LmyBB/89z8GuWylyInWfmjL4PuW4hpEXFzYDBNd0/lFsHGQ+q9zdKHcvyt2PcC8r92GU+yjKfRzhNsp9EuUeRLmHEe415R5Fuau/HeGu/XbIvanc9d+OcDei3M0Id8mUcQCOCzrRC7rRC3qRC2JafT/KfRjlPopwH/hJs21/LJoBSxeS7bdipkzxFrEI8jIgijDX0c8fJqriehk3RYhwexLntwjpbkvi/BZx5nhVkzfBeWQc5TLnd5MV77KE9L0sasJ1CX1Ot5RFEfuWROw7I2LfWE1Ise+ciH3nObeLKM7F5kL4ebQ5xYtd4sUpclYMFF+JkJtNTvZiqfjqFL8Rk8XlKD9nfbFdXJli3xQjxtcmqm+asHF/iYtB21yMUoKD9Vcm2Q7QtFcnaXfbZnmSAlv+lUnS/bZ5bZLyiIezsDk1V1Wm2jZbKk5tmz2VpLbNvgpR26ag8tO2yavoVFQBFgeiB2Z7PON/H/KO2RbhddtcgEHZc5i/LMI6hDHLJF6ZiUOiTECiRNgtSJHn0bB2y6RbHPF5nYxk4O3LmNO5aktG2lUdZBgoCLv9MZafbaMBwdQCKAjixVCN0WCPTagmSmY7+9gtIv43k40VvXU/eTuz6hbNOie4caz4HA4A3G0/RqVD/XygdNhhyD0c+5wTrJOEDmKkGILt7ToDxbpJaCGq5wVrJqGFGGpZLwktRO08bL3oLbxjLtG6e306+PO/DnWtmzeXsEJcEttvlSHz4oK7vmDBr+0SI7OgWSVp1pE9XefxDOVkhjKYoQxnKKMZStWZaG5hurnrEjlhB4k1p6QfuIWcQhucQhueQhudQqsmZ2m1adq01OtM4dP12p9hM3LKPfun0A5PoR2dQjs+hXZyCm1wCm14Cm10Cq2aOqWfTqHVT6E1TqE1T6F1pmk5v3GmgsQPdiX7+7z1XKzvYBzHOY6x6C5U6P2OjVbdeeztvRUze/4yNmgjSUu4hxFXcyR1yV4oIAZxxfBTd7zVtvclyCDTHFnhODBfEqDhtL03dp3lKbbldovJS/J09877pQ/NegXrzx4CZ+YDX+0Wk4xTenOoP9ozVIo0nbb36m7Eh5VfOUyoT6vVvLzWeLTWjtOGlnFtota1l9W69vJaE9Fauw6PdDYnat18Wa2bL681Ga215/DkqGT2YEJ4EInpEn0lfBOrwZvwzre913adu6f1O25o9iq6CAd3dREWw6p4W7493f3Lu849DKRo8rFTev6z6nWmX8CFXef+Z9a79pn1xqdfweKu8+gz6938zHoT0y8hBfX9HrSTES/4mbdQQyrwlvSdt9T2VtSWacu3X9pn8Kb7jBeBDrsIk6DpJ7Nf2mOn1+pMd9cZGBd9Zq2bn15rfLqz0jRT2oM+9vBTeusQidpb8oDeXBsq/CPpLedTnqtrfVZ34cFgZDPzYM6nPNip1TrTTzbPA649aItr9qeMAzqJSFu8DA9G6zafLP4pTRi8/MnWqZ9NmII0xEuaeDtMwwcB7Mg2BSifN01BnG+yEEhfgeS5ZF6NMMN62eELKoidtyUhYReg0Tw3wei9zsdlvcumYF7HlrEgBt9w4javQD26ZJZnq+9K9SnUvIiaL8zUPNCa75oC9vxtcQ6/iBavQIF73rwxWS8rfiIXZU1hbCKOGOAwXmh7CfE6Woheh4sa2jlrvFVKzLjNRbR+BUrh8+a1U271VC46MAWEvW+LiH8B7VtG+14zb8Cx/EtTV/LSklya5qUpCZ1uLuB+y7jfa1BKr5rV6Ut3KX/GRZm8AOP2c7BBfxU+Xm/A2+tLIvJPXdYUE9KEGOIvTjy9mN/x3d0zBZzH3EfXmVR0/Ig9HUsfsYvSEuLdXDQX0UUr6KLzU7elFSNGA10dzmA0XMRoWJkaDTaNE1l5TUZFGqPiDEbFxclRYfOkmax1i0+UxhOdmX6ijja2YfFZ0lPPcqLFTWnfPNpHi/5X2gxfP9E+mksWGG7dnAXbnHllplUjac08WpOdaE2cx+i83aG0Zn6qNQMUx2l9WaATiMmYs9N19Gy2wUIbzrYZmz/aBpoe8CbHchMrehOLJ9O8Sc1mcWKqDSOb9060Gck/UjNP2RnQqS5XJiOlPAaXR7PNHlxz3opByFQJc4sxlix3j4GmtiT2kZef3sz9G8mo4+5NpvbZu8WQQwUkuvofgtOFbX/w38Uq7j42UwgURuVw7APErgJqCv5J7MOKd2nNvufl/dgBo4ANrIo8r7mU/VAPziw9eHP0YCyhB2u2HszF9eAsqQdvqQWxdWA1+XE3QaqgEQW6CHvjoSJZDImRIsuerZYneXprqUlInnmq1Xgkz2DCmOgyVLq4adqJunPUrbjzsmt0M7JTdBdkd+guyo7QXZJdoHtGdn5uVnZ7OCDEkVzD3oGtI+G6vQMbSMI1ewe2kYSr9g5sJgmPrB3YUhIeWjuwsSQ8sHZge5mDHqOXpAVGSpQVQZ4JW2KHJNqq09CEpjSdzOG8tpOkBUYKDjlJTJFxOuSI5iUBzYtx8BFbPMprerT7SNLuA2AjiSBq/kmikn0MM4EgABlGwlcZ9iojr2r7bee+Nnz7beeetnuYQMKaQazi15zsX7DcS1CHwgXTHzpKew160AUedlZTctq7/bYzSu441QW5s3vd7HB3thcJD/pmzO+ffexd5uEW4sZumYLZo3bk38gH5W6ZPfTF3ljdkGdks8tGor4NlwSEaHdGwOyuc6Lg8q7TyApodp0jBdd2ndpZAWHHrDWUdp2uXlbedQYKHuw6Tb3s7q5zrOC9XaeuNdzfdarK+2jX6SmIVIQKPt11OnoZ7JhPFIYdc0PrgB1zTdlhx9xXGHbMI4Vhx9zVa2HHPFAYdsxNrQd2zHXlZ8hShWHHXFV+2DH3FIYd81Bh2DF3tB7YMTf0WtgxHykMO+Za0H7YBysMO+aRwrSf13pgx9wM2o81QmHYMdeD9mMWVxh2zFW9FnbMvbPmsj9cqrglc9nvL1Xcr2F0YlbHfPqhm+fcmPymxHCks2E0B7St39Gen0LUKcSh3QuCvIvXsRXEcPO2Qp6tU3mcz8ET/xw8ic/Bk/wsnoz5WhDJ/jue89w45lqYZTamkVlwXuRMZh+/Rj6IoxJ5LupYnHiGur8Dz+5rGh0w6EDfT93x7t7S9vgSMnHLWFQHjyMQzrZ5msf5HDzxz8GT+Bw8yc/iQZiS+PssJ/cNZDVHKMc7pCQq3jsB5V1S4ogAqZT3SHEq3s2A8j4pdsW7HVA+iPSW+xVTwA7L/hY7F7zjc8EPvavaOrQsKj6Zu0wT9BW54qrWxWMKBJw1t/mAr5kPAobbUww3leH9gOHmFMMtZXgvYLg1xfCOMrwbMLwzxXBDGe4EDDeiDHCv32KXGx1WLRlXfvBurkbG03PP4sO2eQV3D7dDvtvhO/xgkulmyHQzZHp/kulWyHQrZHpvkumdkOmdkOndSaYbIdONkOnOBBNCyiUkHOSeqM4k3jICU8pQOO0U3NsyhdurnLnypvDVRQaH/Ii5VDgRyuYbYyacFcxl/8SeVNllcNlthj4NLoxcg+PCkuzuL2N3b7dbON55Mq7IxpQZUQDuefkg1jECoHp54ayw8j4qB+sLMZ5GNEv3Ghr62M3rYVDTtc2WH3tPIpJTGhZt4vVwArK/E4kJFagwjj6WI/hm0lw319eddDSkwXW5KWNEvcSHsO2Jp8t1v+FAyXwkSubLfnepcoMmW5f9Tgg2Q7ARgvUxyGToSz/4jdhZ9Jb8BNck6ec9aEp1QTKX/dqSvpnpj5v6lNSHctYTWaSklkK4UGkle5GPitfaFa80eUlp6pLS9CXOF78k/sUvSXzxS5Jf8JLM6XPKuAvHHRZMKjO9GvmadbyfdulnXOf8kNfFf8jrEj/kdckf5jrGxHzs7pk8P1RYCtSW6JZGuL5EtzQJ8L1EtzTCzSW6pUkA8SW6pRHuLtEtjXBviRseeyLB0WV/kKFravCJ9jMVzjSjTEXNKy/7h5mKt2cu+9WFkHaUwbNcxuZmTDvOYPd0GdvaMe0kwyi7fmOh4pXG1Hqm4vmYECKcjQykgct+L0JrZireHbQqQutkKt67aNVCxbs6pnYzFe89tGuh4r0TUM3lt51hZsfpZQTuLOw4tQyeJFPx3kfrFyverXEdo/mK9wFKFyvezTF1OF/xvoLShYp3e0wdzFe8uyiNPut8xfsayqL9NF/xfhJPsFjxfirs0fmK9/vwrIsV7/ePqf35ivcH8CyLFe+nx9TefMX7g3juxYp3L3ze+Yr3h9BDi5Xo054s7DjH8wI3Fneczjx45iveH8YTLFa8nwn7e77i/RE8wWLF+9nwzcxXvD+KZ1iseH9sTK3NV7z7eMLFivf1MbU6X/F+Du99seI9iLbiaHHHGc1JyOg+hm/GlDg0aZ59lSHsCd7mQKYB9z2ARwQfcNjTxJtVHC7tOs0F8w7gAa+7yUFP5p8GeEzw6/xEwuuOlnad4wVzi7cmx+/nrQn+Md46ZD7Gp7Jofoo3IcfP8iYhxwkOMBbNz7C6kDzAt7eEbkhV3JvyRTFWPhIJXEUY+tvmlrkaxOkewiepxPBqDn7r0A+V4MGUwM+mm8RPzEu5lrnqlpyyuYkY9h8aEVc5JyOm9jvM8WK3EVe7j2AsAOrU3r+DUAkJ/m5Cm2KJ+XFTs5reNCWV6iRSTwkLYclPwh30KuCrkBPshLk1XgCYO5bRw6/T4MNi7B92G1xvjlPmsiFah+dNPR2gh0APx2gVfjjVuQDtAe2N0SHQ4ZwKROzPrMEmVM1w7prLaq5zz1xWE5772LaqUfJlc03tkS8bn1AN8epvEKwDvEOwAfBdgk2A7xHsWJMSRnkSfSoju5eB6TTBWoaZVS+br/H6PsC7BA8BfoXgEcAPCB4DfJ/gCcA/RHAE8A8SrNrmsvkD0nCAv08aDvAnpeH2ZJu6U00eWNKy4/kd6NhlypvfwTiZ4Guiyj8s7QP4R6TVAP+oPAvA+wR7AH+OYNeWKkdzO1C5T1R5bGOmSlTwnfvlx9k/6FuuT/EMEZzygVBXw+IdIFVsTANkZFe8QoAgH8e1AEEYsFJEFDyxI8Pwq5CMb8i9Nbr+ic2NDkNeY2QFpch5gHASAxtxzselsBmjwtyXqNtKrCPV3QjUeITaB7XqICZ5hDoEteZkxiO1NB6pm+ORujYeqWY8UpfNZVNSYzOZvu0dJ/1pkm36/wPBNv2F5dr0FxZr019Yqk1/YaE2/YVl2vQXFWnTP7REm/7hBNr0DyfPpn84cTb9w0mz6R9SmP2qHHXQ/JW+iQSzdEwkuEyvRIKGLokE1+iPSHCTzogES/RE9LHv9c1XMeS/GmxvMTcgE9B1PwvZtuZAtvWR7c2O5nRHHqbL5np4UNVw9LjwMhTiTYeWjIp1HCj3hop1HRy8jBTDCTynBWJ9Bwc5NcUOHdg/1B3kX1c16nWzJ3eEofEWQgVN9PQyiM4U0YAYnyKugZiYIsIYmSeCUWIJxNQUEWGQxHcpHxDHSn9uDbAM701IABOnahKU7LLfPwtL0jwN0ToJidJ7cq6SLehx2SWz4/eTFRyXyQEY/dPg0ttJCGlIUhekrpJGJPVA6impyvO0Pn2BlVQj6RCkQyXVSToC6UhJDZKOQTpOmB0mrippMsmrb6nbvB/z+xgo7jWzDZPvWsqzeSrRdh14H+GsBrNuJxlR7uLMCMZ8ruWUzTXIaXAeMbbZkyRDPK0R1aiRjCBtMQMgkm2L5QJThiy3xaqCiGmLbQWRtbaYKlgi+21Be5Rg1ESV3Pg2Fqh/qjr4HK4xu9UN4MhyBdyquLeBW9Crhm2+6pcwJw5w0Pmvr91bMu3KN9YWqxQLLEfAoMGltT+SisT1rsT6wA4CbATsboB10QX3Aowdcn+iQ/hs7mVNuFbwFz90r0fNf2JuybdMwcs/9m75zkfeJaahQX6j62PVv2RCboZmOHIDc0lzl/nzjz3JjDZxKeT8Zbm4hOPbAEqPoXHVzeZ4ccz7i1Lt1fCUwX5uMMkU/CHe0M2p4wZHlit78rjhprlJ5y/jYDmL6PpMXA8b5OmhEDXTT+3dCZSqMkmc8tRbvv3+zANjdAZXleCacMlYdFRQSnaGsjx11WQfFPzE+4uaimrP3GL+MVOQs1AxhVr80C1Fba7wNPggb3Ktj678k3LSHmatgr9wJ3gG2lWHL91cNpci106OCMl/FdW1j+WncdOt55HWhA3xoJe9yavC+Xa6LQEv+mrixvSxkIvGTS6FbwxtjvDemRBKxi3bkhVycho31+hYIFrk8mN4STQtSNukp/EBvgsijvrTAuKkX8uztM25DWrVgRxLcERegsOQd5n2Ku+Q6kD6JTjgZQRPHFxG8NgZX2Zos3SDDHGIzwSP46iB4FEcNRA8jKMGgv34uIY1kfrJm4AoTvAwgcoI9hOojGAvgcoIdhOojGAnMa5sE5IJZhfJFysxV5AhyYnEkcTkZU/i1Sm8b02VT+HlSTT88GUvH0at/Donzqm7H07drTaFH07drTaFH0yi6ZffndYD9anbH03drj6FH03drj6F351Es59x+8bU7Y+nbteYwo+nbteYwu9Nosufcfvm1O1Ppm7XnMJPpm7XnMLvT6LmM27fmbr9YOp2nSl8MHW7zhT+aBJd+4zbd6duP5y6XXcKH07drjuFP5lENz/j9r2p24+mbtebwkdTt+tN4U8n0dKn3F6cL7pWxWybHX+UrGT/LbqEuxI61mW4WIRt2JasPHA9d+N0SocxGF3Wn4srSUvCwCSfixdJS0Nixp+LB0lLg2Laz8V7pKX5whPPxXOkpTnDnefiNdIKAng+F4+RFk18t2W22rb/Ygo+985j7yZyPviNFKS/nAQQhzCXg78+sq4VzL63jmxsBRHuvUsIDndJfNUuSaCKSxKoAp6ELu3NjBuno6CboGOgmzQFP7Yf+9uwZi0gdtwlRJsrmEIudlj2Y3dA7Je9O7713kfe1l7ssBxYP1JIcoKgCpnTvNq+s+t0Ya+HWDlbeCGFNWQBw47pUvaPB3fcMpfM1ipvi3u5dzKG2qZ+WX5HkLmGVysIGYarv38Vp48xSFd3aBNoCn5npeJeFbcwmGiYS37P+tC7XlmzTxxYPXwQh53WuhiPWciuBiPIEyhKzPUK/DJLcndet1/xrmf/hCmY6+amX7cq2ScQDvoOtq/j2fDutTZFugIz81YTz8Jwrh8/DOO5apjpgnbkdR/vsY+0a0HlH0kuztHVCmKxxDLqTWbuSL5qtkof88SpUMwq6KXf8GPudTywviRk9zR3kG9zHclS90WQdi+ZO+NkqetIloquQt6fSz6DotoV3hNyitmSvqt4d/D1my1znSiQB0hlewdz2KnkZvxU8nFiiuxeN5eQCPWSWYdYuW6uiuCzL4lQo404pQm82sLVKvnuq9g05qqHWRl/YRE2uNezvyj9/+tl9v6vl4NefU8vld78ph9z75ibsED9JcvcxNir0mTK3PR/yar8oKRqVbL/No0RTcW97pT9hHtJK95/j+6Jd5DBuWBurrEKhjCWyv+E/LrXYD/oPPbeeStmf4xNjl4Ni5FrWG7wN0s7s+soXKA6sdUGefkHH2tV0tBsIVMQicYU/FqfHtSgZhlS+RocMQp+PaQvC/emKfiNkGoQUPnaOvd5zZCMGM7XNOFNwe+EBZsST9nN6GC8y8F4zbzDrnnifzyW+4cfc28uI3Pfj33g/eQirEnSFWE2+77zTVph7ku2pX0k6/4pP+Z+YPY5OPfNB/7Hv1jxbmCDkZdL172rOrphhAQ/DfOB+SlcfgPJTmEN9xVuQ6h6xiU4TKSxT8Gs+6PYhxV/YEC7wUd6N9AsmhtIBxxcUuLWx9ww709xbSG76Zb5CkT3r5ivydDLx/WOW3q5JjMN7oive2Ama8qYDzCKP8Dh01ehsPnYLZmfXKRv6xYnMT7vVrDbtSb3kQWzNR7tkpK6/WAyWemvGOuF65gtt5TRXVnwpbwDscCFJv6dXKzniFctb8d5YT/cuC38YKyWcb6MIfnMYwoJIsvPJIEYEfMMKrZlQdaeQcNmBNl8BgXbmiClZ4hXtglEY4zAR6eEXT7HyGU/9h63WvPmKgeHPDcSXsuEtIUppv2s6c4zxcEW4lECnYOiDGidaBrKNKA1oiko3IBWiSaZaWQLETKBJqC4AzokGsdgrHj7knrW7Jl58ejThuvD6APqQ2tHoHMkN6Cbn1RlRDo0nJncUFXlpkIwlOXduRCcp9lSnF2RlAOG0jNm20X78VkCS5ikYGvAEL2DmAGWgt8OpwFgaTMnWBbYHLyQOKEAmzcLgsWALWiHiNqRnpDBq3Hj1Dra3xEHGDhvNOkNYSSJR2gyrkKBWoh/J7Bk+on2z8t4X0cUk0g09I8fSLpg5+ejK+cNHQU4n0nvIGTdlh7VnBDkfneo4DLj1hE0DFpHcI0R6whuMlwdwRJj1REs78oqdo1mzh0F7zIaM8F7jMZM8D6jMRN8xGDMBJ8wFjPBpwzFTLAqoZgJ1yQUMxtfh/m9wg1rB6GYCWOTX00I3LF2EIqZcNfaQShmyjvmhs66kB+urdmxUIQI+iyQNSYXPx+pYU3Jj301XjbOc7EK1i6mnMEJ92ucXG/I3MzJ9X3NsH5X5x7vXWNNzlJtzG9dWO93LbJZ3/DeFd6vBLzvjnm/EvLqtHoD0+oN877MU1+LTnR+PYGimRveGJ9nFEwpXOe9rWClzxiexGeaZn3VxVS4f8D8tnj+jIsZu+9IJBkY0WOpT1ey3wiAb0J1W8jF/nYZhoi52N8pf+NWvIwlfO6xd+ktKsH2Yn+HHZj21ql0hkwbQCLtQtZds+PuOlq5TpJZX4Xwns6YS2Z9267a8vsvbXNpzf6XNhd9yRWzFWSNafKLDcHlEDQhuBaCmyFYCsFyCB6E4N0QvBeC90PwUQg+CcGnIVi1QrgWgesRuBGBmxG4E4G7EbgXgfsR+DACH0Xg4wh8EoEHEXgYgUcRuGpH2h+B6xG4EYGbEbgTgbsRuBeB+xH4MAIfReDjCHwSgQcReBiBRxG46kTaH4HrEbgRgZsRuBOBuxG4pzA2lGb9bae0g5M/gps7OA8kuLaDU0KC/w9p7wImR3Wdi3ZVTb+mNZrWaGY00gBatSXBwCAxikEzg7A0JYQ0vIR4CAQYLIHAoiVAYExIQkz7STu2447jR6PYpqZl4k5ix52X3Tl50I5j08ax6eQmN53kfMdt7C/pk9hJ35ucpL97z72++tfaVbV7ZrBzvqtP3/Taf629a9WuXfu5HjSLs0MmJ2ZxtMZkdhZnbkymZnEYNw1vgydoJ6bYDUd+m/q3pX/b+reDnCdmcaLH6TrS1ovRKgyaMzVd/OIs+n0mD8+i32fy6Cz6fSaPzaLfZ/LkLPp9Js/Mot9n8plZ9PvT3sIpQ8b2gJZN/zb1b2NAZOtqWatIWzxGiKy60Jo1C1f5TKMPL2m6Iv05077080yXpP9nuijjwk6vC0MAIAXeAj5fh3krELAa1wLq36b+bcRFwI4WqBLXAurrdX0T2IGVEkLDDqyoadiBFTTdttiGjOmWxTZkO2FnpeaANFmonV4njvnT+VfREABkXazJRNKElkT/+gktkU439W9D/9b1HWuwbEvqKoRlm6YrsGzTtA/LtgSkSuTUm7kibS1VAqqO07JTDqDN9g3TwX45Z4dhXEvftprUYupfX/+WklpcnW7o33oSgVaxQpEddtwjL8ludIcOBARnNwljimnRKmEBkxhPUbOBgEmsUlCxGmgloQGJio3Kq9uzcBe/06umtEb2TkRiC0g/IkshiZ9iSkud0k+TgrhpFrfmSI6eSF/VyW4KgzgqXAOdFDQqUesaQNC3w1zpGmiloF+JStdAM5VTt3GlO1GlO7PQQtvpVdPRI0SkH5GliCymzacppPVTpCG2nXOvQ7gXO+cewTE4/Bd5w6fdG/pn5Z7n0A41fQrHiwd43XEdTdMNqxwvTmOhNs3qDMqjA3rN5605pa4MjhejrMoLjxe98HjRC48XvRXHi7IH4g1LsUdEhSg8XrwOqkNP5dSh/9Tp4iE69J85XfRohztNyx9a3U4W3R6c+K360FcGp4vm85LFT8W5PJwuHiCLDkRIdgUysSxXfxXskNNFPt682rNoxylMR++gHe6VrHll5dSVeJ+eecCIB7pjYIGfH5VmGAYtO2Ccxh3WHgweA8UdiF47XUeeaTPU1yY45S0/YJzGpDWUng8YA2kiQdQ0WSxcmT3L6QPGZbIEvKiuvhuXufbEZicQ2Yte2nV0wOS9PeDtl+zK4IAxsLKS7cV9rLPJP4flZ5HP/OX7YmBOfmbkZwofKAoOP1E71CLcybEHrg4/UzunrgwSiF/gBYmGlVPXBQnEVTgQJBBP4YYggTgKh8ICrJy6PSzayqk7wptaOXUkLDqWU3eGRcdy6i6jq8gHkwhLp/UvtkJTOXU0yFezocL9Jq04vZNjIrwJzqA7A7p3tKC3PRcydGUvMkx3eBth56VOO65LtHLqXnpzVCKUefUClvs8CyPUvjDtWxigdl7qtBKh9DEJWyPb+01b9vfrMG7fiWNbTAbY+wi2kBFA9C10bSRgDCPO9ZGAMQw4N4bpdgzjzU1hGvE6bkK5zaQAczl1n9acRXKGN8DC5BQGg8NhkjAU3BomJzAQ3BYmsxgGdl7qNFL6mTq2HEu0bTmX6No4mIAHcDi5ODHLnjAc0V/ZKQM1vIuIJjGcf1wpWrrY7b06UC++Qmt8sn+K6UC9+Ar9VtnjxN2BejG7TmBPKDtlusJ+MK4LtIevoAOB9vAVWieZfUQcCrSHr9Cvnn2wSKtgpymiycueMiztm+LeQHf3Ct0a2CmFNAT2liFtgF2BHAl0i6+gOwKN4yu08jH7j0BlWLPiciKuPUSIyjD7g5DXzy4l5M2z8wl56ezsQt43e+EQRWd2LnJnoH/MN1hg/WPxWYFCxSChAVKaQx2kNIUaSGkGVZDSBCog5fX7IMVUouRI+TFeKFyh5/5XYF+tid8rOO58iq7IPo3xHIHSsRp/Exy+6r32gYwswL+hl907w2X33mDNvRNrbpwp7JzUhWWWb+ijV8TZERb431yANwovTlfocWPhzV4s+9PqTZPuTmxovN09mBEFHTXtFfawI20JHTcd7HTLLuY0TdOc7H3sxSmUKGUiC06ROnKWFO0HvqTssmww5/fmyMbVQrwcmQAEm7fTuM+E2ivziOkpe1TNyVYBPBXuVQjU6JzQ3npPTM7jFGEahwbqTWwuqGxRdhKr35XsGDVwmiDsWWHP/lj2Ysg+IewTP5a9FLKTsNOPZfdD9ilhn/qx7DirUNNgnxH2GaUjw6/Czhs77ptov9fEHhDt9BJ8FkkHJ91p2uUVX4mJul10ztyv2ZFa7cITy7Qill2ZeMMr9IZXpt7wysyqV/AZ7PJar8T0NHmX538NrlW8CtuSaTeaYMEDagXKK3T/vAO68Cmo1+zQziOyQk1gw3uHdh1BQk1hS3yHdhwxI9Qc+0yFvtIVstMvETTFd8SiUIehLrhDe444KtQxqAnu0H4jTgp1Bn6kdmivEc8Ihd3UvCU0dlMLmobTiKKmSxKYcUfgNMLXdEUCM+4InEZUNV2TwIw7AqcRdU03JDDjjsBpRFPTLQnMuCNwGtHWdEcCM+4InEZ0Nd2T7n9H4DQib2v5bXYSsyNwGlHUdEkCM+4InUZouiI+lXYETiOqmq5JYMYdgdOIuqYb4hJI5JfAjCK/OJIS+UWzWuQXN0givwRmFPnFNZHI77BGtcjv8Kgg8kuIG5Hf0VrkV0jwO1/TFUfrkV8hwe+qmq45WpP8CgkVV9c0QsU1NI1QcU1NI1RcS9MIFdfWNELFdTTddfhAQOR3+ERA5B/gIwGRf4DPBET+AT4UEPkH+FRA5B/gYwGRf4DPBUT+AT4YEPkHeNdH5B/gowGRf4DPBkT+AT4cEPkH+HRA5B/g0wGRf4BPB0T+AQ7UKPIPcKBGkT/OgRpF/jgHahT54xyoUeSPc6BGkT/OgRpF/jirdov8cdbpFvnjvCkk8sdZi1vkj7P6tsgfZ71tkT/OCtsif5wDNYr8cbaIFfnjbBEr8sfZIlbkT7BFrMifYItYkT/BFrEif4ItYrkv8hO8TcR0JcFbR7tET33eqRyiXV7124gxIg+Ezq6m0zWdrut0XacbOt3Q6aZON3W6pdMtSXPcooPzTvdm2uX1voX4KF7plTBi9i4v/23GfBMrCFYxsaJgVRMrCVYzMV+weoRt98R3EW4+67Xi0GZCsGTtqAqXs6dxh9ckNMsZ6fULOnlSknmdPCbJ3rcleVSSXZ08LMmOTi6K/+ztPBFsH2KntesxWk7TT+FMZVeGFrDOQoQQ2qVDoO/yrFNrB6xYzGJbhF00jzAkfxUTD9LcZc/rSFxFTWa5w57Xsbh8TRJ31/M6GldVkzPorO0Fmt8eq1tRZA8EdrbIekBH9VgOZJcDE8sBWg5MLQdmQuA4nnweT/wVSyLDYAm1a5d9gYRv+ctY7gs0g52+L+yj979Xgr7s2mVP0eUStPOqKZvES7yNoJ+jilXOEFkSZ0kc3PMq6H9cJbG4V05fLpenZN211FmJccAh1VOrsKeEPSvsWc3OAdWzq7BnhX1C2Cc0+wTYJ1ZhnxB2EnbS7AR2WoWdhH1K2Kc0+xTYp1ZhnxL2GWGf0ewcinNmFXaEHMUW4VaJfu4mOXa1m+Do1q5EvHZtjoLtOhwZ2x3gYNeYE12DgmemnTM4NL8GQs1MOydxnn4Nnn9m2jmKXZ9rUHcz085hePK4BvU+M+0s+q6DBMJg8sQHGgXXoB5mpp1jfsaNU4xi005+rUpR6qzCKfwApR+cVPhNQfbGWynmNb/Dk9gYfBPIht7AWZXi2B0phAyU6IJoAjGvBd5dFINTDu0R6WxfIA4blSO8bfDupBh8eeiNyLNcfRY5D/Y1rZjXAe9VFIMLEP1x9UUFlKggwtv9DsfZjsFziHhTip/lACKWhBWkOCUC3h545ykGhyPgTVDirIpTEj4xEZcQDi8175RdOurO0DU0H6y4r6HLg3X4NXRVsDq/Rq8iayB3yeIT5HSwur+GYpc6jbdi0W8vUMw799VYbnssNrBA12C/CTX+g1jO6/6blX0ntwG8pOZpnuFdgzr+gY6f1JZ0O0h3JN0J0l2LrsHWEOoEJTZi0HCSHjDmtdvcn6MVeD1Nr8Wb+67QwxBE42kUq+kMxby85hmEOBpfg9toegitRfOMea3/YbEaqNcWwvE6QgzQNdgZ5xdb/Ge0Bm3iCqAAYFqHVbgKdZZ/TG/QILbBVVC7gVtKp8x+a31fJaXjTZW5VT/GYV/WQCt0COqgiMWlsmUODXwVbOmgBeLA/d8AB15QVpndm3JE4asoC3t42Lxx3OGY1/th8JZiXuu/xXQrjHmV7+rYITGvrWEHLBHc0fAAHur1MKpLjCMoS6OLebXXQ/6ehpPIG/Cj0r8jeAqfzPdC9oKGbYp5je8FxfuU9rpcyypbpozXEzpdpkEv/+9MZ/DQ6wgPUftuGAAl5nWCBAQuRQJDzEYgJoTrhcJBpMr3wogqMa8VCaIGIWVVCsUri3ltnXCQKEop4scx5tV1MoFrXZ1IcgX4Uih8u8a8pk7YfI9RWgPvjUNQ+BkjfrKR8tKSO86P55uP1zQfL9//eFXz8dp9j1c0H69u1HMcN16LGw/LjdfDXS9uWzdv2zVv6/fftmneNv8987ZV87Zto1YRIWRpyd3AdyqZd2qYd+p9t+9OFfNOrb4HLJh3qhkPOIIPZRAOypfcjShfPnJa77tjeEqdHPHdLD682jFa57ujNHLW3UTrzrqTtP6siy+o+0PpECBHR9Ncz5qGEK0fRh1R84dRR9T4YdQRtbNMXgB2IS+EGJrjIu4ts+5mluVRN2Morhm6hBE55CzAzfSS6LcMU3ZJ/PitpTHEkOKexX7RjS/zhzNA8XMuIuvGodho4ccy7oWx6aIlFe/Lo1MLX1xAA0nRxiW8sSRtWMLLStA49Fl1jj0LZV/ZK11usUGynWHtOvusgnr7/rMv4N/v7y0vUeYcXeDv/5+/9n/8xc0PzOwt+yoRJWit766lJGQuU3JZrgv7ciWNXMO+O0wp2iw9Zqo/X1+ulJErHajyhb7C9paVrVX6HHy27hoaYnUo3x3CFD2ndmmX8DHsunYfpRiUGzv4Tc07bfzCTwt+h+edJn7T807jUbqKhjhoqYRapDUy65zncWNQ5pTzPKqMwBPzGpoo+zJ1RNd+Fa3HADHIoR55higDAHs2H6JNgk4hkFWGrsFJBc3o5zy8l67B0Qgt0syUHZuyU+sujBHPFRqnWeWrcZpi2Q3gWoNYjn/p2BPPWs95lrvJXiDphdFO59T6JbWG1nCDw9zewlQaoyhP3NQoX1jCVEZfzaq1yLioxhhdwsxFX5pQw7h0WI0zuqSSlNSXSPEnelRtYHQJEz99aUqtw6VjaoLRJZWmtL40o0Zw6aTayCjCV9u4lAY6c+4Fju4cm3amzr2gHJnhcWzn2LRDDCVATpx7QQ2SQ4M4MA654riUZa4BkKk+rjWAYqtlDI+T8V1tREzNc747QhOIM33Od9fRBsSdO4c+aRwRpc+hEY9hwngOH8EoGuY5NLz1tIapDJrdCHb6YogZe4xiCBd7VNraYWl6ixRDfNgFiuEwaM6LuZsytCnztOU8R1b2Nyxle2euH1jgIJS2l4GBgw3PAmeeUAPZj8ddh2I04METyjNPYvs/Rg7cS8fI3mVDfxXU1Wj/rkP2dbAMQc9i86wND66NTmLDmexwLHMVclqYW2d/w8qeiyvrUjs2y+VZWNHFpuwY7mLtE5R9WWfusKznJB8OJmyyt8cyyvImnvIm3uHFFpUziSvQQ3YmUagdFmqbhdp9hc5a1nNeKhtTVvYTcbK8H/yfFh7M8gZyFMv+u5X9JNBP/atG6/9qeQNZK5b5kW1Zz6JomRrwPBuJFCdSkshyIiuJCU5MSII4QZKY4sQUyBnUtJwVx8LD45icJsfkbDkmJ838c0x+8OYdLmQmClDUfe5B02PhE95fTXhLa8nKTnDTjK54vzTu/fUQP4lcS612LSXXsqtdy8q1idWuTcg1Wu0aybWp1a5NybWZ1a7NZCcyr260k89d/OyWmOdbp5S1lddE396IJUPpyxsDh2ExrytY0cQ6ghVMrC1Y3sRagvW+ZOZ9hbHKlzfmlK13lWJeV9DqlzfmQqwnWM3E8q9tzEX6JDHPl4tL+mqDc9TNHAXBGiZWFKxpYiXBWibmC9Y2sYpgHROrCtY1sVpjY87lediXN+bcuIN5QxLGGU4Ow3DAOEAOPq5EDmtTE8yuBk6sBlJuWZlJOHBJet+PyZDqFV/bmOOlSfOPzQd+Tar3j42X4wtWN7GKYA0TqwpWMsurCeabWF2wiok1BKuaWMXJqQFsiqT4M3LTNCAhDi0QhM/ewkwgi9DL6B4sib5teVNRCGH0bBj8sugYOOMUxjN2D8HJGZ08I8k5nSxhMZ7u12Bi+4HsCdH/524pfQ4hoFKSzCKp5eGuKX0ORiQs5VkkhrE0sHm8jQ7G1Ho/arsoABzHFOYkNgbZrQbrGl9tpkEuaxBzU5sVlYe40IplRFYsqzHM4m1WWN4kRdUstc1gGPXVxUZS+VJe11JrubyepSaN6xldXt5WF0h5BVtdYjCM+8o4CFRbdHl1W63j8hq2Mo4Q1YW6vKatXCmvZatLDYaLfHUZTDV4D9aiEX7qNGowRRvKvhHSsaw2+LTGVzybS2PylkLMbiOeY1lN+DTqq2kD2Qh7kLXgxUTvAuPKJp/GfXW5gUyCdx14qeyTa1y5wKeLfEUiaAGCZmm9TyLQGgg0RGM+ye3dvuqntdD7l5tt76tIWkcX+iRFXyRF51H0IJ5eSk/R1rKvOFzKIMeg4XukaFvZN+J3ltWQT4N4SrlTii4p+yqDImkQDyS3SdGlZV9daGRb6+M806IR3GCjT5dzFvP9rfMxN7JoDThGfURGKPt0UV+7xrQJFcKLcFzO9DdQ3OUoWbQZHBczxxafLutrdZhsWThLWAMml5nGfVrPc3sUPuSTLmqOi1JcSIZDx+IBNvo0eb5GOfAs+PFKOMuFKGv/un/c/q4XPvnEm1/iDX4UMFxGGVMicB/DGS4wXaZpvsjFmtcXuT5GtYDmFRh6sO7XADnRNCG1cE5loo8/Ik9Mqgw6o1hZ6R4NClIoxWFwUMBeHzguNYJpPWXKijeyMZF31/Gk3R3Bzxx2CGQV4a4HcNhdi5+j7hr8HHNT+DnpDpEF9ROj+AvknoU+cELAYh+4ESDiB7lDHETJXUMZWlt2z7d3Wl9213PcGpGqZLmbeHHjXojultfqjroobEfZhXJZjbG7pLQ7hinxmHQDF/Jy3lHDS7wgvZCbh7uGN17ctbQeP+tpAj8TvA3kDtE6/KzLENq/m6YMjZTdEcrQprI8dZZXYYMoueWozbTZFGKYhRh0hyHEMA2eU4O0Cax1R2WXypT13U00ToNld5yG8DOEkK64z0b8bKS1+FnLS053BEJsKLuDvD5zN9gLsmJqO4rCr4xvm+XbptwsbpulFMaHDWBtOOdXgfjy3A20EQ+0EYsdPO0F+LmAxvEzTmvws4ajK7mDMDcaku82LR/nGvkC1/JnhrB0sOUblG9pRD6hdfhyMNl0Xd5IfW2jqyIL8r3A/C9vVFuW1FZZwo5y5LYYbaVR2kKj5TJN+mV3dP/2ay/4p9d3bdrrTpIKw34/CG/pHnFIyWDA3kybOaTcGV6r8PCKuFWIXYdPjIg4MBu+1328P8w/E/uP/9SRmct+7U173WjgcqMx0Y1GDDfq7t1xY+tn1Q2htRG5ftXNo5GIXBeR0RDvRgORe6FhQolZWBvT2aw+LAG9Uegm6Ak9NwJ9gZ47gR7XcyvQw3qyCXpIz5tAp/VkFfQaPbcDvVZPdkGP6ckw6PV6sgx6UE+1v74xh0bAU3HQ6/RBDegNWmbQm7TMoC/UMoNO6cMa0C5Nnh+NaAh/RmmIRk9MKi1X4bWNOfvZaGsr1Tfr2mRcoNT5oYlH1n4WWktrzmUoc066I9/C5son01bqOXiriAUrmXbKnBdCSdSRtSBmjGogoCmnbE1zu+prZbz3O5hTcb2KZA/HCWNJmcchCFwkJ8mOptCDOWXTQDR9HszhyCxI83c1OO80sZ/ZSucoEU6C2+kcxcNUJ52jZLQ+SucoWi310jlKRZPswVwgYS0k2XZkkLcDvBjOf1ARMa8V8Tb7eBt4lvZgjiw2nmIJBnPGc3QHc9FTwA02OOcklc/keKgJLxcyfHkxfOST804RH0Epk0PyjG6yknpGN2ZJ5S3dziVZ0MmaJIs6WZdkSScbkvR1sinJik62JFnVybYkazrZkWRdJ7uSbOhkT5JNncyv4WRLJwuSbOtkUZIdnSxJsquTviR7OlmRJLSw+HklWdDJmiSLOlmXZEknG5L0dbIpyYpOtiRZ1cm2JGs62ZFkXSe7kmzoZE+STZ3MD8nz6mRBkm2dLEqyo5MlSXZ10pdkTycrkoTWFj+vJAs6WZNkUSfrkizpZEOSvk42JVnRyZYkq5KU+cK808Yuakcu1TVnV5INnexJsqmT+bXysDpZkGRbJ4uS7OhkSZJdnfQl2XOkY2JFlMz7rnQ2P2c/m3znlpiXb8VOqdTWGEGn3ME+7sV0cVkW9UMYTHWScmptkESgdixj9aWZnBo2OOdkB0Vz+u423v/rWNlfsXB+DfYtgeI20lM5tTXQ3kaaciodqHAjPZFTg4GXaaSzOZUJHFAjncqpNcHxcpISwckzk3OsKQ4u3Q1UbLmwyIrlTB5mdXMmj7IDaSaPsVo3kydZ2RuFwOrAEtkcBmBakQ0UygFgIrouUCsHgOnqSKBcDgCT2vWBijkATKJHA0VzvuEZVjRPsgPqMQAVNhZMIiiJGgdQ1YDv5NQGADUNYMtiAkBdA1UnpzYCaGig5uTUJgBNDdSdnJoE0GIgAaM/9zL8Fm13Gr95270cvz3L3Y7fruVegt+O5U7ht225l8KfAusNJr2Gk1MX0KVSetPJqQtpShItJ6cuokskAfdCm2m7JDpOThFdLomek1MuTUui6+SUoss4QdtYHTHpFQdyyGSxh5QkyTupwKmDvA0fpLyHEkh5A0WQUvcFkFLr+URY6704hExibPprCSuRxJgiQReTGGxMz+Es90oIw1USRxvbZNerNZgjTTYjshGR9YisRWQ1IBPTzhn3Yh6R3W2UDG73C3Wxu0zSNtpW5sCCSbpYHwTl95aVwJ0EjSLnxbRmtQIqUQG11QvoJmi9FJBZrYBqVEB99QJ6CRqRAgZXK6AWFdBYvYB8ktZJAenVCqhHBTRXL6CQpKwUsHW1AhpRAa3VCygmeWHhXkxbViugmaSkF9tt5TP4AjfoU5Gk1xoPmg7bYeJqMaOnN0mvPR6SnYjsjofZqxty+/7vSu2PPvZfP/Nq0LYmwqu18D5a9vbqspcgXAf5vJal23R+Y3S/iRUNuBBd9SOyuHEFYyW6Wo/I6krGRnS1HZHNlYyd6Gp+UyTjSsZCdLW4acVVP7paicjGpnCinPSqK3PVA9aE9653vzcl3/w3N+UkxZXe3IR6LIV9wwU5irMBP4spqZR0VXHp4y/Ao1yIXG2p/TF0Dim1jcYCA89x2kbjQWIDbaMNQWKCttFEkNhI22hjkNhE22hTkJikbTQZJC6gbXRBkLiQttGFQeIi2kYXBYnNtI02BwmibURBQtE2UkHCpW3kBgkE9oh5nYt4yp2SWbRMvtsXYRYjF7J6Ln5RjobCqXd+c47W6hRWJe4lNIyfKeSYci/FQeS842/G/GZzTgaPmFfcnJOhI+aVNudk4Ih5lc28iroALq9xfvCneUt/ZzGvdE1O2V5SEv41YPybN4MRWmX5/4utPL6a0MuODmfkE0yvAdqSfE2M0UPBiqSVt8LVSdvI0WVaywH9kA+9HsnR/rSVC8TofNoK5cBtG39n9YlRfT0qtPh6JEbpdSunhoNb+69HYlSMHLXXIzFQ2l9+1Q6lqPwokqL6o34pin9k90nR43xSZgu0lqL9VTu8b8eguwZ//k/tPhk+9ZITytBt26EMvbbdJ0PrM06fDPWXwiNlzwetZai85IT3rRp0zeBvMB3J8P33D4Qy1P7ECWWo/4nTJ4OfH+iTofD8QFhmB2VoGbrvHwjv2zPovMFfZDqS4fOdSIb8ZwdCGQqfHeiTofPdfhmanajMaieSodaJ7ls36IbB3+r0y/Bv34iHMjTeFw9laII2ZKh+Nd4nQ+nVeFhmD2VoGfKvxsP7Fgy6aPDHdtn+q/jiKgx6+aQutPLn8ZxKgC1FCdnUwE9sg6TmiK/NCLhXwGMCHhXwbQIWLEHzlsAfkV9otjJe0fiXdbqp09/RfC39m7flek9ff16nfVuuV+Q39kWNNzTe1Phfa7yr8Z7Gf6TxkiO4L7+xzzmC1zXe0PhrOt3V1zsa/w+NlwYELw4I/qL8wpCG8ZrGX9F4R+Ntjf+LxotxwQtxwT+p01VJw8iF8Zc13tLpf9DX2xrPJ3S9J/T7SOh61/iXNV7VeFPj39F4S+M9jT+f1O8jqes/qetd4xWNNzT+1xpvaryr8R9pvMers5RukQnvcynxiopFXCoc5usRw2sRQyNi6EQM/xExdCOGYjpkeDEdMoS+OBJeLWJ4JWKoRwztiOFfIoZOxFAYDBk+ORgyFAdDhmrE8HLEUIsYWhHDP0QM7YghnwkZPpIJGQqZkKESMXw5YqhGDM2I4TsRQyti6EUMz68JGfJrQgZ/TcjwxYihEjE0Ioa/jhiaEUM3YvhRxNCLGEpDUXsYitrDUNQeIobXIoZGxNCJGP4jYuhGDMW1UXtYG7WHtVF7iBheiRjqEUM7YviXiKETMRSGo/YwHLWH4ag9RAwvRwy1iKEVMfxDxNCOGPLZqD1ko/aQjdpDxPDliKEaMTQjhu9EDK2IoRcxPL8uag/rovawLmoPEUNlnbE9HPt/Xscg41wd+59MxHbZPRD7npt1ukygJ+RL7/teXJcR8z5s0B836E8b9EsG/fnv8Qga03vSve/pkmtMmFHNvsezzO8bA6RBFw26ZNC+QVcMumPQbdB9y5WY11oFa66CNVbB6qtgtVWw6nLMi7mZLTFv5pRaszVGqWCiodKYVnQvoDTWRIhctFvOOGBO6m6TU8aL5YxzgNJeI71saZtmF0z9ELvMfpEt3NJY4xJ2FMtAWnaARMq/Sl/FtksngetsspmWPSPWqc54tdRpzD86WxCLOMNOBwbZV52slbkJXpjDRkXRkf2bQWzLYvvFK23Fkco22hbpD+sshQtzdLGQja05iLmMZQ3sExOef2GO0tnL0Yy35fjQmwbRe0/LfXpx/RC0DZs1WV92VJNs4HYxbdv/Jv73Pb20V1wBJyZZESEDdeWM9lqzxpuBdZdDKa+CLTJeJTUpx+mc15jkbTObUlN29wLM6uKUutTpXaDb4DVgzF9o6FUxUjCQGiNFA6kzUjKQBiP+hTmvkeAbxrziV2PAOltyXsPSWO9PGWtuM5T7BGoYUEegugG1BaoZUEugqgHlv8ZQa5shRuObjPmXG2JUv8VYYYehYiZQ3oB8gXrbI6gkUNeAigJ1DKgmUHGHIUb+L0W0Kw0xOn8lz7nLeE6BagbUEqhqQE2BKgbUEMg3oK5AjV2GGLX/KqK92RDD/2/ynHuM5xSoa0BFgToGVBCobUB5gVoGVBEov9cQo/t9EQ2eGEI5Wn8vD/pKzHhSwSom1hDMN7G6YCUTqwlWNLG2YDAxjqSp/FAk/LYpTfFf5HlfM3IXBGubWF6wlon1/lmauYl1BWuYWEnydl8zpWn/DxHxf4+kGdr3C3/w2fwXPvFnr738HHKuJScLm0h7l+3/eZyG9/3qnzeb3/vCe96/oOXENsEAxtMUznz4fHqtFWfV6+DMlhVhRM3Z0p4tRIFfFJwt7dlC1PNZKYMVe6ClwRR7tmBqQZTSLe3TgqnDorZuaZ8WTB0TxXZL+7Rgin1aMMU+LZjSPi2Y1j4tmNY+LWKiysMaGUyLTwvIwJ6jHBqAjquN82Ck42QHWp6OqJH36686rCYPftvQiUW4wwHv9x1tEmJJ79mF3Q82Ai38zW7XAh+dd/JHUe+tGC7hJ1L0FaxoYiXBSibmC+abWEWwiolVBauaWE2wmonVBaubWEOwhok1BWuaWEuwlom1BWubWEewjol1BeuaWE+wnonl/4Yx/ESK0oIVTKwoWNHESoKVTMwXzDeximAVE6sKVjWxmmA1E6sLVjexhmANE2sK1jSxlmAtE2sL1jaxjmAdE+sK1jWxnmA9E8v/rdTf35r1J1jBxIqCFU2sJFjJxHzBfBOrCFYxsapgVROrCVYzsbpgdRNrCNYwMLK2x5r3XB1r3oN6k+stM09bsLaJdQTrmFhXsK6J9QTrmVj+76Te/s6sN8EKJlYUrGhiJcFKJuYL5ptYRbCKiVUFq5pYTbCaidUFq5tYQ7CGiTUFa5pYS7CWibUFa5tYR7COiXUF64aYF2OTgZjX+ztWJY2HvSoDTtStDqBbfRLdqmOaBdhedjVw4knpa50AjMPnZdz7y1jQ117qlI7POqXj2ooVtfFdtn/Wm+CC4SeatQpWNbGKYBUT8wXzQyzzbse2nht7VrTb3QH8lnCCYHPM8wTrnltukrXRLTEOeMZN4+eMO8hK826GlejdNaxt77J5CxRd7Wln0WW19AU3i585d50YCI2wdYy7ng1o3FHW33fHWKvfHWddf3eDWCFM8NDqiCNUcrwKnKixwdJEWYwCNog+e5bGy2IHMFYW66RRtp9l26T1DM3QiPDOkSjJL2gLgUU2QRfmwyQK+UdpSJiPwRIRj4m4RnhqBDcQ3megncz1AqtorigO4S51ByNqrkwYbnLtsjmr7/MaxsEaxvHi7Mrttwes1HP8pGms2tRAjs3nB3LK0W3EhhIKT1eY4ukKUzxdYQrTFS/mphzYvU3lVIJSaLEDufPVNoXV3EDQ4BI0gGlAHNOApAlmVwMnVgMph4IHIjAFg5eU99+lEbNA3QQfqDPdS/DZONP5JB9zM11I8ok108UkHz4zXUryYS7TfnIeZ/9MV5Lz2B5lupqcx4k807Uk+2Fmup6cxzk5043kPI68mW4m57GFynQrOe+0NN1OzjttTXdg86rpbnLe6Wq6l5zHNqvNjpwd/A1eDHt6dvA3RIqMFA2kxEjJQHxGfAOpMFIxkCoj1RBJo82kZd2beSVrp58bfBbmrv7/tpFdDWpNUDZ5gt0XG3tXX96Y46PM5t+vy7HJd/OqHFoJ3F9sj33/SxthYcNms+0vbfS634+fznn5uRwlszuxlmbYtclB+WRDBHsXsAzZnnP9EB+BXI1yKJX9KYplWX25oBSrdhcVAgRBG+zrG91hb8BzPJsSir9cfMYn0I9OS2PWXmvF0HRamvUyjExMxSc5rpC1PdawroPlJ74qOAy2tseInOsODsUM/v3f+jP8+8HeE9cN2WJ+FBMzhQH+tGaEyrI6NmwgBvjrioUGUNqEaUq0twd4MXBU2zGJfvdA4OPupMCLoaHTYbHwGOD1AJuXDPCCoKDJk9rwZoCXBCVNPsPOj5jMi7M6pgvirI7pojirY7rEzuoQ0cPCAVYDGtvBfhYWTh2twt22xIarhd8MHNll7AWKQ/edK9AKKvDAEFs4GIEIH2TDWFZaR2nscJMDt9jcPTsH4A1me+xVy4sdfPLq2KvsT8azDwD8pga/KdY1mSWU3baiSH3gvH5SZeBCT97rN9ijU3woRoMiyJLeA/ubvSdcO+NZlNnvjx/6ODbFTpA9Ce4B18bQfX6OgyMUy2aLYPs5z/Escq6Dia3Dz3cQqswOHloMYKHkN7j0Ag3u/7nR3zz43Z/92N6y4rsucssLg9WkFsoqA/lPTJ4YWPBsb0AknfRsecrJNTbqUyxpESdLISCONqY9PwqysbkerLR1yJLKnh+LfD/U2mezNx6asEj0VabfNo7HIV4GGuZsmRfPqXUyhmE96UPMTHlJDa3IW+LXWrdg+8RjHa86fah7ry0vRSUOvXhOjchIx+tMtqIqL4lq+ZJa318wbJzkUTNn2dTfp5GyPOvQWfxdy3DWN2Re/+I5yeP7+2+rXfS+f7r18oUTbjzjJSg+BMNrbkxDlheDxySLnKtjJAZ/+tu1w2/XNr9dO/x27fDbtcNv1w6/XTv8dm3z27XDb9cOv107+nbt6Nu1o2/Xjr5dO/p2bePbtY1v1za+XTv4dil+3ZC9hr8wPKkXd+MZ+VZh1xi/OjYgNkfQfc4KCa1o2GxYU3aMvR7E2Jie++B5p/71jaw/+23+6Xx7o292g8zWeWWj9NW1LWU3IxY51S1ld1jIyhaxaIHq7xYY2jBZ2gLzGunit5TdrJCFLWV3nWe5joNgO3rexubG0JEdZGQOEzivtkU8nLhs3oOxLgCGaQ0DlQCAowoAfgAMwboHg2oArIWhGcbdAMjSOgYKAbAumG8N6jk2FJAVZRBvEzXE+smKhhGPM0jXFK1BvM4gXVU0hHieQbqiaC3ifQZpX1EW8UCDdEnRuqV5p/e1jRk9cuuxepG998a8DlvhXupUX96oN/vELLdX3xhN9luC5b9imOq2BSuYWFebEr9smAj3tCmxieWbYkocYpm/cKzEs3pnjD8s5ZR5c4y/LTXACZ6/Z1Ucs1uLx2a4ukiUxQAO35hKcoJdAEwpRP3yZYHrcCcIHyvo/MoIujbtLIhPHPSucIeDHTN2+DTtHJWcqSDnMZ3zpM55Jsz5jM6Zt3TWgiV5s0HeoqUzlyyd27fC7BVL568G+Ws6/0SQvx7kbwT5m1H+VpC/HeTv6PwU5O8G+XtB/rwd5i/YOn/R1vlLtuSfCvL7ts5fsXX+apS/FuSvB/kbOv9M5v1YUNjPedKw7fDgCNHUNgnas6OhlK16WHtfzB8im7gTGTeOiSJHqjZLETOCviJE6V8sJowSXCsTSNJcVZKCs1KSuiOmFn2SJESS1kpJiislaThinWFKYoeStFeVpLSKJE1HzDr6JEmKJJ2VkvgrJWk5YgliSuJk0BkMuCkpqLuyoMrKgtqO2JCYBQ1kKOV9L3YDxZ8g6wlKPEH2E5R8gpwnaOCJzEf/3naueu5XrGctmD9kT6kLt/KeE6ss4dZT9g9ej6sNIDqvxxd5jr+Bh5EfvB7fEvO6yVNq/VZeHfivxtU4jXs/eC2Zm7Jj6gL4ujqdg+cazjR1OicqTxswEvE1aC8qKztN62jD9ljq6ljpuJAbr469oMlNV8fOHqf15sFrO9mfbi1LN5elG8vS9WXpGtKiV7NeB/BZrwP48G9R/xb0b17/dpaVU9V4L0HrXIc2IEymrasGzmwQWtqdhhHc38ZOqSxbwRUz7BhrXs6RJxjLjzI2iy56PZNwldIVcg9GBiEPoa8X8gCGAiEPYqQQ8np2X+TeiA4dpncU817bhLFjko9Zg7urm86Ws2XLvY1uouvp+jIdpINlOkAH0JccokNl2kN7yj7N0VyZZmmWQzOeLdON55DrEG9MDPP5cdrrxXNqTKRP4zhXuSK/Aw46BIEWKA3dYbZO3nM2W7bKNEezZYWSsx5zRkfTagSK7i1bz3wv2yt8rEXvS2Sbfncu7BqCz6ln9Tn1KKXZegR6vOEEuqz4aUYDx1R8Wq1GaNbg6LsR28T1OQzj43F5VCUPOREdbTvZy6GtnHUPiMnBQVZxdq9nBWK8EWyF3cQPO0C30Z7ABPflMlfITXQjXV9WqHe8jlk64LM4+DtnnH3jIdQczdLcg5N+1hM3RcNe/KmcGvF6E9opYgJn0TQCVXfUwcP8759fxhPyQ6hA/dqLuSPOAiVoRL/OusoR3mTjolyg+Jz2GhpsmmBTg60IHMEh0Yg3xnOqhFfYBo6E15VZl5rTCgNbc8TkqFRiwstrxs5W3UiE0d+WI022tgpHvZ+jFHEUuYy58C7V4C6ib8CvdpQ96uHZdY1+Vb90vG9dlTloym+Pxa4bitwJ4XPcHnttE/6+K/MkzOG93qR8qJmoWeyRZjH7/6NZzJ2l2XNmg8D7RoPYgwaBBP7OGg1iVn9JNHcCDSJDw5haDmtliAmtDLE9VjrOw6UFyrOxE5JAsAzPPoCgFm4acSvnTqkRDnfp4HSP3yPvyVnuLH7n8FnzLvAe/C64B3hnznIP4nfRvZ435yz3RvwexlPh4Q7h55h7G35Ounfi54x7F36ece/l7T/LfSuNeI1ZVqCfmeWGVJfUlKRqkiJJVSU1IanKbKR4P+L5s5F+PrTz3b+wwDOnlYlGvGpE1kKS/gIx7mZphEeDORqht0ahoeadEpB7TaQI5C4TKQC500TyQG4zkd4sjdAhE+kCOf+q/XmnA/J6OujPO22QB2iPP++0QJ7/3v15pzlLI15zkjcFrZwa1aos3L1WrNNqWC6jH52D6dwoDbMB3gT3/WNBtyZlTISqZgunNG/xJ/PCh4Ywl34yM+IrJZgZloPD4ke0nzlQutMbmdxxoDHyM42ddic0XzqIvDaHYcZNOAs8griznuUOOwtBad7YaTXqjbHdYBiYS5dAY1EULIESNLqCaTRimvV9d5aGESdrWHdpI/Jdj52mNPPRrDwKUJowoASeJ+GNIT6uvlkQGXmWIyObD0wjXmk2517kxdzE+UlZ8R9jp1Rmqy43ww7pszeqrRw5Bjd3L8YJkpRXsdTb3Nsp4SadBXob3V52b/cs9xJnQTeSNF2CSrkMlTJFyfB505SgqehZ05Sky/ouXmbEDPN993a6BBVxiZY44+XfBBvEsdO6oul20cNimC42sCSeNClV4bC3LRbbvZ3rIawoKZXNutCuJRDJJG9Kp7zx0zi4SOvK4IZwe/8EgLNS2vBDdvs5OYVYj/3fFKptilKIG7dFM6e8qnU65273YNk26SYoxe1O7iEvKMksuN3bzIlANC7czq5D0nwLN00XexbCq0T7l7qwZFTXcE4eKy+5t9MWuKC4+LqhmLNAt0e3HTutX5O6ZNoJH0wXoC7j3HQJqpAuO78c56LSeDdp0jHcJEtwT7qd3naOgyBfjKe/mJJuuq/aMzSJC5NcOyoVvov2UM4dpoxXSubcUcp4lUTOvRSvOJ5zL6cMzFndHZRB+DP3Csqgq3Fn4Ns4LnXcGc+52ynj+fEc3L14xfGcewllvOZAzt1JGa8+lnN/CvxOzr0M/KM4jcjAiNcdwH1Hc3Bd4zVtnFtkvPr6nDuF+9s5+LLxuiM5dyP4+akyXmkk56YgVyznbkJ9rsu5m/mFdrM53TQdRIzGVHMSg7O6MnsIBQznaJKnnmOBflEGUULpSsmbvZkyMP/sJvC3Mnx+QV4ZFqjHUBVQVUP5JP7WANU0VGCoDqiuoSJDDUANDZUYagJqashnqAWopaEKQ21AbQ1VGeoA6mioxlAXUFdDdYZ6gHoaajCUhzvWfFagJkMFQAUNtRgqAipqqM1QCVBJQx2GfEC+hroMVQBVNNRjqAqoqqF8igUGVNNQgaE6oLqGigw1ADU0VGKoCaipIZ+hFqCWhioMtQG1NVRlqAOok0XDS8Dn+SSmzGpC74tlOAjsLpqEmqdyQ7SVgP7UJNRBlQrRZiKnBmmSZ9bbApQmoRKlJsUpfYIydCXPBgdx9xSbA/NIGEc6y15GfAkpksF+2q7Ig25GR0uQND9DjKsj4c9LyRkojPONZjhV0qkpThV1ijhV0KkJTuV1iusGeunaxXuGMpc6XZ5UoRbXubdz1a1z38ava5370/yO1rnP0CbazBO1KaEIN2JqAjdhKosbMMWxo5jiWroYurczEJspLoUpLoUpLoUpLoUpLoWpmJawOeL+DL/8Efdn+Y2PuD/Hr3nEfZbW0kZdNlNcNlNcNlNcNlNcNlMyj6EpLSFTXApTXApTXApTXApTXApTgYS99e7Pc4Mfdd/JrXzUfY6b9qibt2iA1mhWpjg7U1wkU3wbpvjWTLE4l1HSpPgqU5yDKS6FKS6ZKb4bU/x4+H7G3F+w+H2Pub/IRHXMfYGJ2ph7FoG+f0rfiSm+E1N8J6b4TkzxnZiSOR5dou/EFJfCFJfCFJfCFJfCFJfCVFCRjXH3V1im5rj7KSZa4+4efunj7gHagnA0XDpTXDpTXDpTXDpTXDpTQemlDe5BrosN7vVcFRvcG7kmNrg3ca825h7i1znm3savc9y9k1/nuHsXSzfq3svCjbpvZdlG3QdZtlH3BJe73n2Cy13vPsnlrnffzhW83n0PP0xvnfteJvIj7iyXPOLOUYae4cYywi75MvTTNOfjFCtDb+PFAc5Xbqf3WuyIb0YcJ82IjeGMOE6a2af7pWfpPWDrWZShn6O3+xyILEM/S0/6fIiboZ+hJ3wOW3aFFHSFFHSFFHRFUFDeohM+h+/K0HP0oM9RvTL0Tnqrz8G+MvTzdK8vMcCkoB1S0A4paEdQ0FmL7vI5FlaGXrDoTp9jZGXoFy26zefYWRn6BYsO+RxT63Ip63Ip63Ip6/KgrAN0k8+hpTK0R9ZVID9l0fU+R6LK0K9YvMhqxelSKelSKelSKelSXRJPAWQudRGmE0jJbCF7C02geyxy9FMXZIFJBTLP5DaQPQ7POsldKZNX0mig1zxGw8Fs402YeL1Jr9h53q6ng4GxgsOW66Kbe5FW+2GK1X6YYrUfplhLmSnWUmaKtZSZYi1lplhLmSnWUmaKtZSZYi1lplhLmSnWUmaKtZSZYi1lprSWMtNaS5lpraXMtNZSZlq0lHl8+keOELUVE3nHWwetYiyK6nPG1kXGflZvWDgHWC0BatzY0Qj3NBi3tsdeOO45B6GUgM33ze68mEROyQ/Jz4Rpf+toa1zcHNq8Ad0y6KZBNwy6btA1g+4adM+god0b0AWDLhp0yaArBl016JpB1w26YdBN815/a8hg0D2Dp2vQHYNum/cy8tYMumrQFYP2Dbpk0Kz4Oh+6IQy2sUQRjjV0Nc2aw5pmjeb56LBDzdN8Wc3LRVa91nQ1oLGnl0ATeuE4zUuDyF4dtQxpRXy4JjzskCz7EkcSg9PP7G6UYG+PjQ8sYKuUhmjI+zd93jGmzzvYc5RWhAuU8hKhUl4iVMpLBEp5QvHXyRR/nUzx18kUf51M8dfJFH+dTPHXyRR/nUzx18kUf51M8deZkE02/joTsp/HX2dCNvP460zITh5/nQnZxtM2BAm9jzCitV1lX2E4UnZNiw3BaI6GadQEAxuC4QDU28PahmCIggq0Zb+RrQlstiZwtDWBbVgT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPYq1gT2KtYE9irWBPY3MEpW8bF8Pwv6Al1RziLIEPQIejvA2eDPhDb/tAYVWmvfVHOHcNxm7/ZvcOLucNezFU44Nx4SsW3QnW9tR5beEVxEhSP9uPuMDr7vbS3rJ46p/bOOx1EAdk771T1b290tUzo7DnT+yzOVR8V7oL+ba6HviKWr2QrONnLkrK3x5p2tBvX/ZHLnXnca63NuSnEWLBPqcGtMRpEUJBQZFZh923cJUaRm1nay9ov5SV29m6r+8vqGDr65RxZ4VigY0JU7bJ6aN4IMSFsE+Uld7dn8bbtbkp6M6e5Q52gwWCLFJuEu4PdU+kxB2k3e5K3y+qWeSMyhSjC7l29SHqDIgfMIut2Wb1l3ghoIWryb1Dk1BsUGTeLbNhldes8894/78xFe6a7zTrjqro/qCp1Q1k9Pu8srFYxuCHBWngmvKWbDA677OX1c3TeWUTzNG67WtX82EKd5TV0z7xz+CcWOvXjCx1YXkcehvJBumHeOGxeUUfP0A1SRzVbLZbV3fPOM/zx2T/mkY79pHrCIx3HrGD5M9k/5pmO/aSKwjMd4fnFIC1CzfGNn6pq0aI8Vt1W+8rqZmhC8nM5P0aCovWGD2ZD5crdL6ENGrY6TLdGkc99dR+vdFN0H5plig6Tt+xqD1eP0K1lOk5vKdPddEuZbqCHDC7EersWU64U7abDZbUbzDeDeZFu6eNTD/DEKkXXYhaYogcwBUTpHkq/B6UfRemPryz9JJfuoeB7UPDRFQWXdMELUvAipciDJPdAkqMQ+3F6qEz307H+0rn4GcmbQhVE72M/7YMi734Us4/eYuZDprq+I/GtPNzqHtzqKG71OG51/7JbYSqbov3g3Uf39JXncdz0FHmY0KboVtzzLRD9Foj+EEQ/RsfKhC6/v1DeAUXtHEHtHEft3N1fO3tZzRYVfQQVfRwVfTcq+ob+ojBH5qZwlFIYQp5hYY9A2ON9wu7lwO7MA7seOkxHzGazl+O18+WCxaLthmg3Q7TFvluyzi9ushs3uXn5TVr6JlW5yW7zJrs5EHyKdrN+MMrYjzL2mWXwhg1y7l+Ws2gzfLjcd6Sti+tYNOj5NlbacexBt9bib3P90jyTSLQZagFqa6jDUBtQhyEoIO2y60mmW2sRa82O6P85xnRtTW6X3RO6nsztsv9N6Iad22V3x6ToLhfdQdFdfbceQ11APQ3lh/kCIJBIFBjKj0IFV0NFhgqAihoqMVQEVNKQz1AJEEivO5bL3iE9iKs7Svct0vm6x2WgcvfJNMC9Vvc5N0h/5j6uzeIO46Sb3IfFoG2/WMDdI3Fg3EWxmbsfPBPufWLt9oCYxx3T9nU342LW9cQG7hYxmjsKcMo9KdZyj4h5HbsrT7m3ipncKZm+uEfEZepeqXbXpTSiLLAlRBKHzBM893EWaBBunihFSTGE47v72X1oFXGs3pLCkb1WIiWNQrdggga93tocuwrpJHiihDSNYmE4OO20GRvlsBnbDN6uxrGC3GrgPY23LTjjjXAYhgEv2Tm1xcALjPOtYCPWtIWGjVjBERo2YnVNw0asp2m2ERsQGjZiHU3DRsyPCw0bsZamYSNWTAgNG7GGpttis8Z0R2zNmNY2YsNsvTUodmJQ0GpLMp+S2oKf8VGudm/mNAawWjaYs8vFCagz1JeB2wA2loFbATaXgawN0VoGbgHYNkC4VR9luapx46w+qdUwbHuBbQeTUMSQN2wHihgPuXeTzBMeorvL7t1aEUO4hr0kFDGS8LIf6RzoEigVqRYIlDQUMQImQxHjbt937+5XxJBGm/SSmB3wKffd8kQMB6oYd4u6YPBUBzgAoMUuMg8OOTTI7yvDbxDxKTspgXoMVdLosNMC5dcwF6COhgoMVQbBNShQUbgAdTRUEi7Ew6lkBPKFC1Anoz8z+cRuV6PbY3VnyCLXw/IE65E1A5mglgINkruhOcGF4a16TUQkVMM4J4eyTfYAuSQp/ptdRAHFCe7hERlBOmUUj61l7gFra7gHhOClQYHqDPmAfA01GAqeOOzQdadfGow6faZ1p+/H/xOdfpOLrqLoqr5bi6EaoJqG2gzVAdU11GGoAaihoS5DTUBNDfUYagFqaSg/xCUCag/SXjqCBeYpupaupVvpFFY+ZXUrHcUgSx7dAoCO0q2APbofEwu6jx5g+Bhgup88XLyPHsdUhh6m/XzxHr6IqeYSPU73geVhugGzBDpJjzBLjlluZpZFsNAN9PB5xrISKRhm8i1clHAzcJxv/5bwPjmBHy8v0S2Eiw/wxf18ke/mHtYj3BFngZQ3c1ol5YVhl4CHcUrmFLwu7f/wD3/P/4+vV/ewZZqcPdvsvrf/ioR25SvZ/isS55WvTPRfkVivfIX6r0i8V74y1X+FY76SwgesPFZ1kRYl4r/xgl8G8rv1QP6QHsg/ZOmR/JOWHsp9S4/lS5YezMvaWMs9J1Zj7mfF/Mt9ydIj+a+KZZf7OQk551bEUsz9NW3a5f66mKG5X7ZkBK+J1Zn7+2I+5v4XMVhz/8DS4/YfWtygs+7V/Elm3Wu4mQ+7b+bPYdhdkFmae53MedzT3Nqz7rs4o591b+ePYNh9G38sw+5PyxzOfUZmRO7PcAFZ92f5a866P8dfyLD7LN942P15meC575Tpkvsc58/ikBrfaBZHxPiAsjgixr2HcUTMMzccEfOECge0KCWLA1rInXX3sLzQg8Xth92DMrNzr2cxht0buYisexOLnXUPsbhZ9za+/bB7p0z73LtYimH3Xr2Dk+R+rTsGDQzMVozeTQ1n7zLnaVVb5mk1W6Ziddu9WTePW3T1H+XXc9a9n1/LWZmcZc/K7GzirEzP6Kx7hl/fWZngLZx138Hv/axMzQ6flblZwTrrcoiYZ87KvCxvnXXfrdvOWfdRaWZn3cek4Z11329pe/1BSvG8wBZDfXyOdEsZk3ns6RGw91tYR7B7NLqZtxFwaQKXHsWVx7Dw4ss+3VNW++V6FtdzuP5uCwynsJAQLp9uKKtFYUuB7WGwPQKuk+B6By2GrD5dW1b7pEe4H2xnwHYMbA+A7T7ap3sNZj5aFl081i+TT3c4WHSwftigvELeTkzJK4RJeEm/sKJ+YQX9wvL6hfUseWFdS15Yx5IXlrfkhT0j7+uMvK6T8raOycs6qt+VvKpFeVEL8p7m9FuakXfUtuQVtSz3/Yw3LffDTDQs92luSZb7kaBPKAbdR0l6Fst93tLONArastP9gDb3dD8YdBQv6o7hl3RX81Hdo/yy7kA+pjuKj4utq/sJK2wmKpnjAM/D0m+r3fRLVln8rHt0suxzz6z204uW0BNqkYqaJrWP7hNySl1LN5S5k7VpN33UKpNHj5R92k8PlH1apBLy7KPHyj5de37xrzvq3fTLzJljzmPM+bxwvt9i1pvLurffTR9j1lPMeoZZC8L6YWG9payHjN30cWZ9t8W8DzPvB4T3aWY9Wtbjzm76BLM+ypzvYM4PCudHpNT7y/6K9mcsdv34isVuJb5isVuNR4tdntOYC9yCtWKxm4qmPTzV0dOegrVirVuLr1jr1uMr1rqN+Iq1bjO+Yq3biq9Y67bjK9a6nXj/Wrdv5Y950/r+lT/mTetXLO15ya+fnOn/hScPNhAw/Vrfv/DHvHh9/8IfCh3r+xf+UGBZ37/whxrjaP/C39dHBMbCH6opo/0Lf0x7R4NpkUgtj/STJhV/ZOlh5I8tPa68HEwr6sG04ivyzduylG9bsqVQsWQL4YyMTHPSz8Vkp6BjuX8SdCJfDeYgf6o7hq/pOcjXg/7mFT0Haege4xt6DvJq0LV8U3chf6bnIN/SXc239RzkNd21NIM5yJ9b/BajGGVcNZT2Cuvxt4NID14ql71Tv7gx3vqSKh3nHSqZ1I/z9pK8tg285SRvdYx3RpmujIuVO7ezcd6flXe6YR6xiyTvOG94Ml0d561DaZ3jvGMrL3zDPLyVS95x3gKUlc04795JmxvnrTppDRvmEQJJ8o7zzpwse8Z5I06ea5x33eS5NswjTpLkHedNOlkTjfO2mzzXOO+1yXNtmEcwpWtp//lRtZx9CSYuHu2j3ZJ4kN6HIzb3BD2FnyfEc6w0gDRCaYC8B+dsnQvcRdngwck84I9YsjV0RiycMSRxZNEPWzDFmMNIMoaGcj9+sK80hoGsyGjK9fCTdY+JGdK7LbGBdp+UYKRv11FB38P4IhTR2GranWUbbXce2abcd+jhekw+a95VsvSwneDGzjtVRdu9D78F230Kv3nbfRi/Pcs9id+u5T6C344lm1h5yz2F32fcRyXuz2P4Oem+j5/4mPs0fo5iOE1A2AL/LmIwTUC4D/LvHIbQBB75o/zbtjCGJnj0/hgTTQujaIJH708wUbfcTzNRs9zPMFG13N9gomK5n2fCt9wvMFGy3N9komi5X2SiYLlVS7bmfsuSjb/ftmRz73f0y/pdS17i7+mX+CUM32OIgnhapaFCYlM6p9IyfP+WVcarT6l9MpKmMX5fS1VNT6gb6DOaJnUzj7xpjN+3yKAIrZLd9NsWdogLMgJixL2BfgOJmzFe+3QLhn3RRdlNv8O8HxDeR5n388L7MeF9SoZw8P4u835QeB9j3i8I78eF92EZw8H7e8z7S8L7PouZf1OYPyHMJ2UUB/OXmPmjwvw0835ReD8tvI/IMG5hGLf0QRr6IW6GaI5ohmlpkopr+6hU9n361T6l3+zD+sWe1O/1Ef1ac/qtntIv9VHdKB+TRinN8Iw0w5O6GR7TzfCoboaHdTNc1M1wQTfDOd0KZ3QjnNJtkHQTnNAtMOt+RppGmm06LcLEj9K8Gkhw8yiTlJRS+8okhWfVtbDclTtOqBvKJEKQurlMIteUuiXwo2DRfZiyH8Uc/TMWcdZPW+fnfvQJC+cWH7folsBbg0UFXmc8b4H7aWF+HzM/Bt5HA1Y4HzkFzhwYHxHGk+B7GHxPBXwTgekTvz9jVMWpEnrOlMLsNQ6Jb6Zj5JXPP6aP9KK6hR5A+lpJn1TPW7zrcv55ffVomTdq4qiMj3JLiiO4/FHhPaxYIpBnVAHi++okNzTOMqF+We45pyA+8DjixJ+SLM+oD0iWp3COxDlIfUxyLKj7SAt4TD3MN7mBBy1LocGrx8qGdxtfPd1vtvRLlhFt+4MW3Uwfts6v7Hz1fovOYDX1ERyRUsnCfNvnEyU5eMMBkO+f89V+uoP20x0PToIyHBUxemJS3UF3lF9Ui/SOsroDX5Fxv9+wfHreFOAjhuulsjpDd9BHzcsftugooZBHDPDzlk8Fk+sdvuL+4JdN8OMW5TjrKQP8TcunD5hcn7B89UUTqKL5G+lPo+mimIcN8LcstEgD+Izlq982gd+xzHcQaZc8/aL6XeucKln0qMH9KN3Bq6anDOz3LHrMSD7t+2WF97CkvmT1v1G8xIjTx0u9hXi9pc6/MeqrYrzsoybzhy16BC+W3uGb8DtoPz7KnIkVLV67+4RKw1oJdWMyfMLCHmTZJ1THp43qMOsCLetROmnme5T2n+/uiR/xJJ00vT99yXpRfcY6d76d0Bn6glmkOkP70VsTqppOombK6il6qry0vMXzDX/PokUsR9UiRhC/rB47qx49T6L2pFWeb+jLKkoaWj/uU9EiaUbLMiyiL5OWgSt9D423QGcI2gcYJX2fHhOBH6PHzMd9+kX1onVOPY0awvbHx62+G3yanbvQY3hK/jg+bJWX1AeXtYcjoiXwED1Et9JnLdpNf2iV1ZnyEr1k0eP0BxaB9q2yekd5ic5ZdJy+LFjNIkCftMoKKg9UtuhDFr2FKnL51+Ty5yy0raWyOoI/u2nJwnk37aXfF7b/Imy/Lmz0qxYdKS+BazfvMOOvOkzXlFH2EdzjsHDxhSP05jIt0CeRGXc6IiIelgKZ5e4ynSbfondA3rtFriPydIfl9sz2UJmuoz9Etf+BRQ+Vl/CQ4K4I92eF+/c194cscb+5m64u+0vqk7yHeH4qQ4/TYbq9TEfobTjW/+ky/Qx0BZ6hKMO7LOR4nOf1FhQADtPPIcOzyPDzZXoOGd5pZPhZ8B/neT23hbfQEfpFC9wvWGXYCjxUhn2CZKDD9Avo3HZTnu/zFl4bWGW6lY7QAWQ6WKYbkeX6KMcezvApznArLw4sqDYcoduQ4c4y3YsMd0UZDnGGm8C/lxc9fEHdjT0/DI7zNOur3dhXofdaMOZQhzG80tvpSV8d4TmjeshXHwI3dlDoZuz2HSurYzyPerdFD5QV9nSex2W6v6zuL/vqeWtJ+Wa3uWSR1HyNaz4u7o+4qhq6quLsAIn4qVr8VHF2fwRxyxjJeBtpN+aldJg3k47wlFSds3z1WVxl+Y7yvtEjvM9UgEC+emRJ9fWjhUCYTiBMNxCmFwmTt7Uw8KXEwhTZBZJ6iYX5ZRYmx8KcYmEw51W/avnqc7jKwuRYmFMszAdEmNySMgfOU1qUkq1FgVsmFqVih6JUA1FqgSh1EeUDLMrHWJT7WJSHWRSeLlQsX/0aT/ogyn0sysMsyvtElPuW1FH0aL5ajHqqD1ovqofPqfdZ4PqwdVb9ukVPnVVP0T1n1T3koXthjRPZYqOjmMz46gbs6CmvjN7gZhmdzeFI3eH76mZ0lpiC0cmz6ig2eQsY0PaXCVf3+z49jQkZPXZW3YKJ3yI9ep7p/GOWMd+g/fQ0eoo7ynStLxO3m9H53gLkqfOTJdqH3n8fplU8MNwB4a7FHGdfmTwuJuy523vLqLiHUG/nLK64X7XwaVcsg+ll3tk+/wnQMW5vD5x/3XQ/Ktpk+ZDU72ctruDP4YNAx3U/f4D4zsroCneXfenH0A6OlH1/yffpdy0svjB6ZV+KvhafHs6+ZPlL9ER0F3UtHyeeMJAboIdEe+mPLPzfS9/mVv3nFipriV7DiNBEdS3RVyzunOmbGBH+TLBvcfdIdX4hS/SKRS9jQPiGXH1VrjYsUeRCf/onFv2xRbfS14Tj68Lxp8xBX+U+F9MSDAQeWusfW7Qfmfgkc28ZLflliw6Dda/c0JMTSZ+OU92ifbjbrVLkXhHWk3NKepy+gsHuWxYfQL4qbF8Xttc0G+qXH5/uwGNDtj8T/m8I/9eE/9vC398UDAcd9CDeDP4tubuxJmxuxNHCbrgpgWmBfxweaj91nCMbYBfSP842HzDm6Ioxh1gi0HT2Ghi5iHNtNjNCtLrj7LqQprNv3hT4RlG2F7vJ9AQwy7uCnvWEm7CfA3Gg76oXk+vvfMIdhWZF3yV2wRP4a7A960nxaj0MfZxh1sdhSxdojFun9T7BHJb84RXxVWF7NvxPjUBTYoRGRSXSGzudcW1KsHGV6G8o3oiUjcqwAHc2g9pCyU5QMquHqwPa28y/vlz2aXb/un/c/q4XPvnEm196cf+3dj/38Gf8f4f5zrnsZyzj7czTgf0/898v3pn6/LOcq//ykprd7//JP/2/Ny7+7jxF5InJ7EsWjICqx+HPhvb4PhvwsNnXANQ3YttjbWtgoc8MZ1RbkaRDM5x0aIaTDs1w0qEZTjo0w0mHZjjp0AwnHZrhpEMznHRohpMOzXDSoRlOOjTDSYdmOOnQDCcdmuGkDTOctGGGkzbMcNKGGU46MsPB1qvFivfeXM6dwG6b9vrCuv3Qy0oEljkjkXN5W+LDD8MyZ8QEsxzyIxGBFixzrMgyZzQybQotcxJ9ljkJePqFR3pKv8F3hCvT2Te7c/YCJfibcZZ9M/N4uw6+mWH7ORB938y8fDMOvpkRL+Y6xqVIRHb/kNA14uhvhxLcxgNtNvHr5bzhlXnfZ2MwO+c6ZOHrsWhEG2Pi63FoGF9PeE9xYwpX7G2L/Y7bYUHufIbmOGqx+MVRs/oj2mN+RPOrf0Tzyz6iWdpjfkTzyz+i+egjmu//iHz4fM6yEpAjUbA2URaeNqSRBHal2eD11jeDezN7Mg+DWGW9FiMFA2kzUjSQDiNR6Kss3C4hmlYDZXb5qhEGK+vVLgZkRMHKev4UoCgIVtYrMdIwkCIjdQMpMFIzkDwjVQOpMGLEv8p63R0s0uXG/Vsz/Jw7onxNRvIG0mAkin2V9eqMdA2kxkjHQNqMGIGvsuKvyox7lfWK8/xsu4xnY6RmIHlGqgbSm+PXaSBdRnwDKXEuI+JV1mvvZZHebNy/8ZUYP9we4+EE6hpQTaCOAVUFahtQRaCWATUFMgJeZb1SgzEz4FXWy7/KoBHwKuv1vsFYxcS6gvkm1hGsZGJtwYomVpB7mAGvsl6zKRJ+25Sm9hfyvK8ZuauCtU2sIljLxHzBmiZWEqxhYnXBzIBXWbHTc/oCXgUWq1mxZc6KLXNWbJmzYsucFVvmrMQSznoLp8TaloFF+TksP0fl55j8nJGfZ+Qnb8lvQf8W9W9J/+oCmzrZ0L91/VvTv1X9WwmKs3Xx+ren8a7+7ejfdlCe5qvp36r+rehfX/+WbMquakncwIVZPpLj35ZlMMKgLGD0LWE4KT8zBHfB3Hl6sXCDeoVF8BhbBBsTuTmYwU2eUumtMS/pjmgfesmD7LcrTY52schHDywfhngcR9kwYW7qVM+Bb8OWTvlxdYAPGDnVSKiDfKTKqW5SXc8HpmmJuYvDgRv5RBRAfVAcffKRJ4COeP48xGeaAIpDDNzGNZSW4KwA7uST2rTERAVwFx/FAiisY+BePmsFUOUZhHorH6YCEJek6kE+LQWQH2PgBB+HAqiMM/AEvyAAzQ0MPMl63AB67FdOvV1Hukx4PvsOVe+x5p22IA12vqjea807HVt8O2Ia67PfUnZkyi5NsZpj/6Y30o1ln26im8ri3vQ2uk32f+7E/stddFfZp3vp3jK9ld5apgfpQc56gk6U6Ql6okxP0pNY2L+d3l6m92DLpYydl/fKJpKvZvvchKbRirKUlo+T31VMzZ8Vpw1pHJzfQLNiZI6Z9zlzYTrnw6PkCI5IRrx1mIOwBvbYaXcsmL1z+5nHdN8dchawGSR+8KJFBLx5jp2GsjR8oQ6FutWJfr3qBA3B3aVxcXi59ztZSmila4hOQ3BQZhuu7gTV3vUYshdoCA8w5I0ZKtdjB4cc2HbJdACPg2HZnZDh0XVlmHKVDBTuNt1Hu1t19+hO8myQhkIPcuxJL+PgM4RDwGEvcaMauY4SXvJ6eGETydhbnzwXd14ZYpaEsERXSUJOVy3NEH8DhpaNBYkTOa0b9pK3sGu7YZmGSxc5pu3mRwJviDRmXGnaOTVkpHsOTOWjtB+HPb2kR0OPinZIDYXUSORvMaRGyQ1zuGEON8zhhjncMIcKc6gwhwpzqDCHCnNsC3NsC3NsC3NsC3NsC3NsDXNsDXNsDXNsDXNsDXNMhjkmwxyTYY7JMMdk8G61NaDRXvmLyN64iRyJ0Qu4OYntgTl3nh2oHxflhtpxmDlzGziOdT9vGMzT3BLNLvHqYJVdgflgXwDrVB1XZEHWq2udmG3ZmdXzWVP2p44PLMggo9jJwZxoc2gtayhbiOaFVnKzdOSPkqUV5Cwd1cO3tHIdPOWbBl4k2DETmxLspInNCHbGxOYEe8bEFrQzBssEF+UR+OR9iN3JDLF/Pfaml6CYfK2KPderWdi186AjFtAwuV8TJLNI1sNkCslCmIz12+69YBx0ztMszT84KQuw0L2o7oAkMhI52T0rXq1+c2ucTOQV9wD2SPBuTCeO7iHYS605peytMWlObppiyvK6F+XUEE7s76QhaBvchZ+Ye6+uC2jRkkVRsJXsPiRlEqArgl1WSyWwI2SpAHcPxto12s93UKeKHRmLD+GE19uqHX6zH2vxJcz+s0HeJI6wQd4GvwDxnIyjF+ayN8EnwEBOo/w3ezN8JVjo26d4zT+LQXHu/KBIezAmHug3UJ07SwdZ7S3ui1KsmoXf6lmceUCpVeAmwwcA38iKbwO+KMwCPgj4Nt6AErjO8PWAb2J9N4FrDN9Is8usQEWTzlc3nVOztKcsaiyzdKAsSiqzdLAsKiizdH1Z9EtQCBrGIXFqftM53z3U10rgtwHdchjUhw6F9gcvvYgbDQVurm3oLqsh6oMqKyCaFWW+Ms/ZdLKLZDdM9pDshcm8XeYJm04WkCyEySKSRRteIt7gZjVw1MBRXylhYyXUXAm13qDoNopuo+jOykzdlVBvJZR3Vi+64JTZcM9mr+3LMpVWQv5KqPIGRVdRdBVF11Zmqq+EGiuh5hsU3ULRLRTdXpmpsxLqroR6yyHHq2dyNGscwvx/3L0LjFxZeh52H/WururqdzebTZ5zydltLmd2W5JNdvWQ7L6j4ZCzs5qMV/AunXWyHJGJ6BoC5syuvNzd2WWtJCMlwVAqsADXjB97+7YMlJEgKcQJUA4cqBAERlmRo9rIQMqJg5R2ZLthO0A5MIxCYmsz3///995zm2zuyImDICTQ95zvnHvq3P+8//M/dhnul8Wauev3kmA3CQZJsJME2yhNfUnKblHsyxJrUuwrEpuVePMWcdJgbwSTTsUfbzVkfrB5fsCcfPWIZ9nmeVY/jYGuIqAWAyMWq1qPgZlHgBJAxLki42cLYgWoPQcnzacw48VqCVlt+vBt8pXqkpPUyLzUCpXikpPU2KSVEZ6aJrD+ZwuirkGWRF0jptkItlTgOX5yrqGu1vaRERCfC5t8Kqe1gvjqfMuQk1uGnNwyxFUVXRX7Ir63aUc/AMtHxk847CKs/mF8mk0mIwdOHGAZ3rtKMxqpcmCCyyXdaf0pRJ1AbN6z23SV0EB9O/DTlrvi/DqeNozrXnHaFL7i/DnGOsCSWaiLKQuKTn7PfqpH95+GBk9Dw6eh0dPQ+Glo8jR0/DQ0PQnZfgsGkrcdCxcGeVXcdjJeAf04Dz9D4OfnVRSHssodI343BG8/iT8IwSpI4o9C8PmT+OMQ3P4k3gS9mraBtIC0TKQNpG0iHSAdEwmABCYStUSC9ID0TKQPpG8iAyADExkCGZrICMjIRMZAxiYyATIxkWipS5BotUuQaMEz6CNrnkEfWfZOabBoGTSIBaRjIgGQwES6QLom0gPSM5Fo+TSIBWRgIkMgQxMZARmZyBjI2ESi1dMgFpBjE5kCmZrIDMjMRJpYdJquSSxZPI3OBKRtIh0gHRMJgAQm0gXSNZFo7TToA6RvIgMgAxMZAhm6JxuvGBELySO8ECHROpogEyATEzkGcmwiUyBTE5kBmZlIMwNiZQykBaRlIm0gbRPpAOmYSAAkMJEukK6J9ID0TKQPpG8iAyADExkCGZrICMjIRMZAxiYyATIxkWMgxyYyBTI1kRmQmYk0s6BP1qQPkJaJtIG0TaQDpJPFPsymA5Cl38U+zWb5dX0DqzdYH3x8cUgce57PLQ4WP2+ZTy6OP7PEd9AbmLWthrfOpxfHP7bEkdCbmPUt9uVDhxnYM3sBkS9h1bAa3kVEvoxVxWp4m3QCI9+N3gWEv/rxorTLinH63sdr1k6D5hF9XzmJ/Axzgg+9XT7heu+FvNRtszh9Qcnp3PsaEu6zHHqe0bbt3Qd6j9ELjHZs7x7QrzK6yWhge18NadNF6EVGu7b3lZA2ZoS+wGjP9r4c0uaNUI/Rvu19CegXGdWMDmzvi0DfZHSd0aHtvQn0C4yuMDqyvS8AfYPRZUbHtvdGSMelgE1r7LIjO+/1kI5T7LOD0WPbuxXScSvg2/Zddm3nvUZXloxWGJ3Z3g2g74rsvrqh6sbh/WrIrjT57PaIQrdCdrnJZ7e7FHojZO+c+Bj22ImPZS+eIAbYE7bsdHcphF3uDoWww92m0FfppGhTY7EDTTQmy65fVV8LWTj+qnovjLRg9SVyna3nxHRK0bf0DtgB/8J6x8uQ/RTyU/IicXYj5uw1vQdzK+6Buqb2Qr3n23ojZs5W1QaYs2fAnD2f2MJQVVVU5xP+a1UV1JlU4pkkcS8I9J7aAHN2Q5hdGbb+VzCck+yRg3nB1YsGGHt6IMZlIeao7j3lm8Q5iErIgC1be4Mc6vqdcwKoXO0O4lsNNRftijNw5qnPcDZ93rd01T1QVd/5ut5Q51WVpVsKpHqxh3WjY+treLZtfR3Plq0P8Gza+iaej/VDPB5Bx70A1YufxeOu/nk87uhv4PGWfozHbf1NPA70t/DY1d/GY0e/j8e2/g4eSn8Xj3X9BA/Say+AffOr9LT0r9nigeaMKqoNplqOXezw3EHioXiFZUFRiGoytK6e0FOp79INAn4VUqeohHqfM+9CIBV1VN+i5231Tb6LwFeox4TdUd/gzHch6YpvhtgraEACrpz5sXoYMpnUzZDppsiNJpESortEWwj3ErEhTBuZ0DKVMFQVkapE4EL6nL6GZ++ivk7upc/pAzy7F/VNcj19Tj/EM7iIFslcdmdb+mfJ3/RF/fN4Trf0N6igi/oxnsdb+ptU0EX9LTwnW/rbVNBF/T6e4y39HSrngv4unqMt/YTKuUCm8S+7wy00D0q6AKsDmcvuYAtWB1DWBVgdyFx2+1uwOoDSLsDqAOq/pW9QcRf0a1T/LX2LSrugX6f6b+k3qKwL+gsqw16fyaTwHn3MFpV64RBTFyJ8OttTb6gvEBYIVlN76pZ6nbCuYOtqDy67COsJptQe5In/kk1oX9BttQeb5x8yOhB0R+3B4vmvMToUdFftqSeqyeBIwAO1p76jvkvYWLDbak99W71P2ESwt9Se+qb6FmHHgt1Re+ob6jFhU8Huqj34jCFsJtgDtacequ/xDzfPMfhI7akDdZOwlmCP1Z66pq4T1j6nMv5sjTyhZXlmUHU1RzMYGn8DZW1EYIHAFsBWDNYIbANsx+A6gR2AnRhUBHbPoA3iH9omsAewF4M7BPYB9mNwl8ABwEEMHhA42gSxNyPwNoFjgOMYfIvACcBJDN4h8BjgcQzeJXB2FsQ9G4EPmCBbIMhWBD5iggBsxeBjJgjA9pZv0bqygYunqszTDe8Mrli9gqqrnKryelGI2OIyl2/IZEZbs6KqSztJ7mKU+wzuZik9R7N2wzt/IkeBdnpJCeefKmG2npQAbuPTJXR+TAnBmYZ3RkoAw0xqeSYpAfvQMye/Ik7fwOwWL5M8ytEEcHEwezcampgO4Aoh+Fo0qjBRfB2D7+vRuMCM9AsYKb8QTQZoNXhNaL4XDWZ0QpTT/Vo0EtGFUM7o69FYwq+jnNkvRBMIGhrltN6Lhj/6LcrpfS0aveh1KGf89Wj44df/DH79z0STDvoGymm/F00Y6Ooop/+1aMSjo6KcydejIYtfRzmtP5Ms9v0LvNijj6mMP14Ej6zJPLIMT4+kup/hqbfutlY4PN6qu71VDs+26u54jcPBFun1Z3jyrrttyT/Zqrt9yd88V3cnkr+7RUr/GZ7+625H8h9v1d2B5G+dq7vHkr+3RRYBMrx+1N1A8k+36u5Q8rfP1d3pGr6uIt/In0Z7mP5cg3cyyT5mWBYuYcYfJcFxEpwmwVkSbM7FwU4SDJJgNw6SpEv546fpnbbM+PEJfCJ4ey6Nt07Ee3PxyUbTSjad53X7eJ7X7XFV1u1RldftYZXX7UGV1+3RIq/bw0VetweLvG73F3nd7i7wuh0s8LrdWeB1u73A63azJuv2bF7/qm1OUf1yo6Hqqsqbw4Z3hvV69mikVsGvLEgumhPOsB5FPBtUca4rRjnOc46xG6rzyQyHdqwi8fxlboItmRO8PfWN8FCQAiHX1M/HCEvQXFc/Gx6qKp05q5xC+AE2XofJLxRQU9oN7qmH4aG6pm6Gh+o6toSH6gD7QSNz0cj8hDJ/lzJ/h/K+b2atGlm/TVm/RVm/SVkfx1nLlLXKFGhmQ1U9Md9lsLnnjBuR5Tje32f8fgmsZ0r0sPjRuuZdo1XHuxnSiubt0crkXQ8PCcA+BQuQd0DRO94evpjC2KxcD9U1dfAxEMgVNvJwCVRuTcp9xOUW4nJvc7nrUu5jo9y30uV+yFfhyMRFUME7UnCNC96OC37ABe9KwetGwY9OVrjG5a5zCdeYAFzuDpd7Oy63wOXekXJ3jXJrT1V4nQve5jeo4LtS8IEnBI0K3lVCci74tlGwOlnhAy73NpdA5VpS7l1PCBqVe0cJybncB0a5B09V+DYX/ICLoIKVFGx5QtCo4MdKSM4FF4yC756s8FtcboFLuMYE4HKVJwSNyl1XQnIud9so13qqwne4YMVtdo0JcjPuo9TlrhsdlSh0ELfATYP46YIVF3zARVxjgtyMOyl1uetGTyUKHcRNcNOgfooS21zuXS7hGhPkZtxHqctdNzoqUeggboGbBvHTFd7hgi0u4hpT4GbcSYk+142eShQ4iJvgpkH9VIV3udwdfuEa96GbcR+l771udFSi10E8i9w0JhCjXO/ah+DuOEw+HhfSi6SbXo9IGvXV60yyhzKRXFd78Rxy/eOTr7qJmZiq/IDLfSTjQnqR9NLrEUmjrnqdKfZQ5pGk3Afpcj/0boJJ5TABk56LuUEGAtPoYdxbD5gKHx/a+TcOVDKNHOD8vkfrCuixB1YYXQFiFbouByXKiR3qx78R8A870m7cJcPDwLt2xHMu7UkRKXCkRhFMbtcppBhep8g6R7Ypss2RHYqgIx1Q6IDhXYrscuQ2RW5z5C2KvMWROxS5w5G7FLnLhteuKwcHwyP+xJsUehRX64HK+O2ioaqAw86l6JwYmSUVkM+JkWFSAfmcGJkmFZDPiZFR0fqH+isUrwgroVsRVkJQEVZCpyKshHZFWAmtirASmhVmJczmmJUwnWNWwvEcsxImc8xKGM+BlQCDpvqrtIOa0/doBzWn79MOak6/S9frO3y9XiCvk8Q3f08VyK3keWZ7F8h75IvM9i6Qa0myELWHQ9cWrdsW2DTkLqxA7kwvkX/JDBm2+Rr9mq2/RJ9q6y/Tt9u6TrUBoy2jCn73XMP7LOkATfMEjM43vM8R0C4QMFMN748Q0GMg8BreTxEwYmB4oeH9US6Dgd65hneFgBkXOj7f8LIEdDhHUze8EgF9BroeXxHU3TEDowt8TVB3Zwz0z/FVQR0OQwFMzvN1QR1ePwG0NF8Z1N2B1MPja4O6O2FgfIGvDupus0jA4BxfH9ThchTA8Xm+0ajDbyiAtuY7hbo7lHp4DbpYIHPBVI8LfLtQd1tFsD4CGE/agyrQLzMTqizMszJvwoMyb8I7ZdmEt8u8CW+VeRPeLPMmfFbiTfi0xJvw45Iwz0q8CR+XeBM+KvEmfFjiTfigxJvwfkmTawc4CD/jZ7/ubXBnwa7xOzi75Btqo+Ft0LICTfoN2lOFgfpZBGse5KkPEMRWgqQMq+q7ai9U31LI9fMkcH1TXWd7P1X1BGnfprRvUNpDToM3zSa4j+p9SnxMid+zORVHfJzfxXsI14sq6gfROQxdPGI6T/ON2p9Ql9RXGK/92yqjjC5sdF6j2xod1uiqRic1uqfRMY0uaXRGoxsaHdDoekanM7qb0dGMLmZ0LqNbxR0q+nY+sMq3R8e734xJ8EX15UAfqDfVlwJ982SbF6jJv/p0k99Kmvwv2kmb/6p9otHvoe1ep7b7SzY13q/ZSbPfR+oblHqDEj+wk3Z/F4lfoMTXKPHD05odcpWfpdrqzwnTYZpveFW6HniI403bxoip0v3Az+LZtPXP4/lYfwOPR/oxHg/0N/G4q7+Fxx39bTzeghdYXA98B48D/V08dvUTPHZwWK3ifuBNPJT+Ih7r+kt41PSX8Sjoq3TC0rvugfqs2iBJqKr6efU5tUGGms6QkH+ofhbnMexhqIefoS0eTGScEYqSZG5VfQui/98ER149BoP+G4rTeIzVQ/UdSsOAUd+WNBD7i0h7k9KaxNl/Iokg9i7pE1Dil5H2JUmLz4RM6wJJ51Z5YUjOjQV/GsG9FDyL4H4Kbl4UeJCCWxE8TMHtCB6l4E4Ej1NwEMGTFNyN4OMU3IvgaQruR/AsBQ8iuOmY8DCCWyl4FMHtFDyO4E4KnkRwkIKPI7ibgqcR3EvBswjup+DmCxG9U3ArgocpuB3BoxTcieBxCg4ieJKCuxF8bMAvqgPebUL7xlLn1U085tQv2Xwb/B65lLVk6rrEe7vai+pF9aKwXrv2Ybxftbi/HXJR5wXoMzDHm2jqY4dcelGAIQM76Ng7KdepxNdLPKei6YrsOhXNVWQ1HDRRkZ2nokJF9p6KqhTZfSoqUWT/qfj5IjtQxQ8X2YMqSFtkF6ogZ5F9qIKERXaiCrIV2YsqumaR3aiiOxbZjyq6YIkdqaLbldiTKupbEk+qtPsVT6q06RVPqrTXFU+qtMUlwbAcM8DlsgVzavtfkGNVm20ti+LaEq5wnZesZSggkEaeKxp5olE3leexPCfyHOMpfMbj/avoWSz9j1txW7TfcnQpbkcaS3ZKY8nWzrM1luZZY2kZl+Lrol50meQQbHHmQKeBeVOBiRKXn6uxBPV30p5StqGxxKipsRTrKJELWRZIXblVcXDvS7pRkZV7ihfYnGBAcnWE1MiKpROQQBch62RSMBOQJBEhijT4srhQyDKyTfp+8OE+yzGyQ4YJ8VPdApQLcRENaYN/bLGnOqp5iVwD197IHESqYfMnVMN2lUPSB3W1G+pd39bLMaFttQxCrzChE+kDm7SLYlrCkdBKKnElSdwNAr2rlkHo5dgfR/OnRPhAdMN22R8HwaJ/xdhpsge7xJtMlMWo1P4aWaHdxLWDb+sLLvRriv7qQ/CTbSEF8Wd302a36FVlNxIZn90jvvdeeqNisdAGmyLUeclc9Hv2w4bWpKR2QTuqSJLQ/BvcKwqUhVZ6U+PP0AGFLokqvo6f0DbUkd41VUmiwgoJrWnfGB7qXZXXdpkMDbgHajf52ZWH0kx0Hoo+TAqgI1F4iN1plw28UlFiw8Bh7Rd+JfpN7BJAClaW0vOqoO0U2cvqAhIupORAVMmfVKCdV/I7+YZ+wbf0ChFnWmtIM7tqhc+0Nh1Gl2tvwkHJPHngvICCRJW5RI61l/nd2s+IG5Yc+UmZR9efFzcsBPUA9QRq5sltD6C+QC2CBoAGArUJGgIaCtQhaARoJFBA0BjQWKAuQRNAE4F6BB0DOhaoT9AU0FSgAUEzQDOBhgQ14QKjWWNoRFALUEugMUFtQG2BJgR1AHUEOiYoABQINCWoC6gr0IygHqCeQM0CVRhQX6AWQQNAA4HaBA0BDQXqEDQCNBIoIGgMaCxQl6AJoIlAPYKOAR3X4NYmh/sMm7gcF0TrveRPcmy3BHyMfIyOc5iTbGKC6Bgd5bA82MQAuRihUB072/A2KT7MqZJaJt4HuWAq0LlNJOFKmJ3XE/8lJczNsT8Tqq1K7sfpGywiB+ZlKpn6KSvnQ+krR65Y1xq0uMEpPETk2Sn8BWVHTuHzCLbEP7wdOYW/iGDkFN6OnMIvqxci3f+i8qJhsoLRt5La2dgnnMK7sVN4N3YK78ZO4d3YKbwbO4V3Y6fwbuwU3o2dwruxU3g3dgrvxk7h3dgpvBs7hXdjp/Bu7BTejZ3Cu4ZTeNdwCu8aTuFdwym8mziFL0VO4XOsrZk1lzjR/C0nOn2n6F+cbuWpbBqTEVXARMdMJ6tJZIBlnx3R+85rm/pGbAUq51tfqKCS9rsaGnb2a5knvpVVORitgTOLxDIN2+rJxdadFsFWXTSs0OTIPo1zqn2aHOzT5KK5fV42OLBPk1NFtu6UiywMTNiIddoujSvKrmkrT6+JgZpb/xoGal5TN9St8PAPY5kGtg56b2MRUlcPgzJMWpAqzEVL1fVV50AtEJkhi8bWnvBlV9WqOsuNd9ntvh14u6h05wdZWustbCw6P8iqJWyPrG0n+K2sh1H5z81Wr9WV5Xd/K9ugbP7IYrsa/oyhsdXwAxqEkHm8+kG8oZg+ua+S8L33WCYipxag1Wolmlpx6G3IvRaelfAuUmqnpqyfmqJOTdk+NWXn1JTdU1MOTk25fWrKW6em3Dk15e6pKQ9OTXl0asrjU1MMZeWTSa3Tk9qnJ3VOTwqenUQHCjDpDnSujGVsbEF/mNYvmhlo7sBOP+ccKAf9+ZR+9XOcVDg9qXZ60vrpSeq0JPgectMfpnd5wjaQOk/nBnKDpxYDeY2XAgO5RcuEAbxOK4gBvEGLiwF8gdYdA3iTliQD+CKtVgbwJVrIDODLtMYZwFdoLjSAr9LKaAD3aNE0gPu0nhrAu7TUGsB7tAobwNdogTaAXyK7YUYr61+2fTtWoacFwkmTnkyDsPsgA8TMzq6EDPBGACWMdBuo1wIoY6SbQd0KNOlyGy2hXg80KXIbjaHeCDRpcRvtob4QaNLVNppEvQmtaifVKuqLgSZVb6NhwKb+Et0lGtiXA03euozmUV8JoMyRaiH11QBKHalGUvcCKHek2kndD6DkkWoq9W4AXZVUa6n3Av0eXZYa2NcC/TW6TTWwX7LpasdJtZv6ZZsuekSTnBmsv2wbi8Ev2eZE8TUz8p4ZedeM3Dcj98zIV83IV8zIl83Il8zIF83Im2bkC2bkDTPyuhm5ZUZeMyM3zEjdjOwaEZrVsHV+qlOf6HsnusmJFk2THqLsBp1JMzWduXkificd3UlHC6cV/S674knnbp2I301Hd9PR2nPL7p8oq30i/iAdPUhH159b9uBEWZ0T8Ufp6O10VJ1aNq9m/QL2okXei6KV432aR55jujDkuQavjgE2ft23sRj+ngU7i5bzPvZqv/GDrAeLntiEfpTVu4qMQlqqXkdc1XnFscoeDIJeVbv3NznBwhvdj7Ie0Ktq957nbOJ5iGyHytmshXZi8h0mEevI7hw4T8hIi/WS9S9/mK06lu2WleW3Pso26If99kfZRpm4gmW14HdQWcc5UGvbjoX6Tn+IMa7WXrLWae/pP0m+GdrgpKiNU8IV55//ENVcYvfGM9TZb/4+NpuRY2PLb0m8JfG2xNsS70i8I/FA4oHEuxLvSrwn8Z7E+xLvS3wg8YHEhxIfSnwk8ZHExxIfS3wi8YnEjyV+nPeIj2rFtgvOHhzV3f5H2cQsju1bn88cqAX/w9+jLdCC/wECtYR+/l8CkJMtvF7zLb1A9PTO+s47WB3REGpNLfjO1xv+SAzAOtLjVnFyUGfRPKvUFLltx7pVsejXK1XHtvJltfqS9cHbqvaSZd2q2HM5Aj58WxVfsqzXKlk0ud3wFpR9G13a9nOfr1B3tOlE+Rs/yOIz3qy4Zh1tdBzbt9/xFnDsy6GMd3WFfCLJaWSNKqtXfVsv+JY+6x7wDzlqQdlqTa3yJ8WHFRo5gO2n4HubHr/hfPI3tI3yG3pBncXp8axiH3gV9GCuAFfQ+0PVA/xKtIZttobxHsbt/ZsVG7ZIEfauqjUVNRZNDp4Maa+OA+FhLYT2HT1pxOo6jWzeQv+e1cCkYFFpFFILqIFQeMGohofBqlepo/xTxBe2HeuKg29dxcPiawl/8FHUe81Oa5XVEq6e6cIk7r0yX7iW7dCEYe8hriy6KPlhVm3BrNAc1eYHWXAFXDn5Wy9Z/+qHWb2GpNkPs3pBbSmqzJba8uE/OUP1EWO25xsK1VxTW7Vd5Nh25ug6AmXbUjq65hxVwjlRCZoU25hpLrutj7L396w/eFbVnH+zVXPgO3yNafajH2YrVjTPL9CMyRP9VbUAa8Dvx0tKlofNqkND4zWyrriAkUWDyqG5wOZhpHj4vOedVQtqSdlKPaPbQplXKbX0VML9TY/fOfv0OzdOfUcv4TpFXaXOqW5IQNejgQXrwZ4bsdxXM+9L1bjK3h+yhqlfy6p6+dW/89v490/3Q7BMrMtukxZLi9yaodY2l5Mehp4swTSy6sQsYUtX2XfIpva/st8g/slSPBzA/Yz2dLP9eBP3qcH9zXt6DX3OlT6n1vbQe54zAiJbMn+o3kX1sm49q5Nxycr+fCbpumAE+pZWSDz+Yda3MF+jr/iWXjKMrF+w/In1jnf2IqwTWp7NHVLBxJ9NVkU/yqKvncU3KHWWTTeeZbuqZ9muqs0z/qpSvvUFz72J+zfp6Eu89Vl9VhugBfSuWtK411mlxQ5cKl4uuOU955QZdPceKmjpNUx68p7z9YZyaBbz7c9rRy1oSznU6SjDGmVYQoYlUG5JKZrrz247Bb1Qph7Zx7yHJSFqdY8YAf2Pssmt1qbiL1p4Rq9yqA+5t1h2qfdRljbfb8OeHugX/CALBilzFwa0D2x+lA2SK7qD5HBwcH9T7+KqE1P8+YZe8q2YUM/66VWiS3TQULgpW434stA4p26xeUh0W4oWG7Vau4zBSP3HWzXaBSNnlRZiqjbU12X9wW01dRKtykqB2A2P9i9JM2CRWYi7BV1fwqwnTunMFq7Lmd133+XNDD4Od23veDnf/bfINub775LNcXz7KvosfXv0tUop7geHtHdGgv3e6WnOc9LcU9IsP9PQ6CsZ9BWXp681ulu2o3r4I1htWFWrmB12D3nrZ+M12S2t8Wvy2eQFYQmGEFNm9NDMiRcE50SCb+lV8ze9BX/QtGH5ybd/JoN2XqBqXHYtap7dMuWNyfHjs1uYqC21iol6VSbqaOwmP2sl5WBu3MWmOF3Obszovs+8YAt94J//MOst+NZtOunOPso2qEsfl8TKH1ib6G2QS3uN2JkaNy0W7rExJWw3Gtz5jHvl96GMTFXDOB2RZd0PgqNkkJbB1UEPbnirfmuTb+dX/R79KFprlg09mLsLw6jNPEtulGw6K9B9QqsMutj+8XpDr1FddO2C5R80YMoY+0O/nWlgyjzO3aK9mHXF6eToaf1FHAPVwhXnOAdeekFsFlr+tCCmCi3/uCCmCi1/UhD7hJY/5uCbIDAHv5hc1rNdDRjnPfy+/gqWuYL+Kh5DmFlkv6f3eKpw+FBgkRTeAmTvYm79/tvUPhWDF/FzFVstmPIClClh8P/mz2H9sHUFa1PjJatDp1qHG4qsH2OWUwvocDBW55p8vNi53MGTg9/gA9ECmQrkXGgKyekdwGRiHVUZuodwwZHcnsCkZV3duL9JtkePcNmxAHkt3iTj/GuVpVd4C7TnQHWWWI7UpXqryp7VyamaWpDuR6ZQFxoxK2m6T5dtEFZhk871o0NDhMIg2P3NEFtkS9W/fxTnKCQzeOHg3maCDxJ8cH+T+l5M2QCWQFwYn/SoBe6rXRYEXVBfgqHlr0Txq6p+BDPOxHQ0Oy3WiQuWX3vHsyDVJHZWItJdJJPesFqSU18lm85k5pkMPgdi/BnGoAMyDU1GooMg+H746r/8a//sf/iZn7u7f2R0iqRH7N/b9G4EfFKBmdE6yq+rq0fxD0/3Vd3IzeMbTj7gfIM7G1qwgD+1IMBjHX8UBbfxZweujvQturdhs7TbPGk81q/TrEh3n36Qgz03MsD3mnoddixvBepGGNd7PWmXdbNd1pN2Wf+4XcJXP/yA/u2HtdAWG4PEcoGEEwZygcRE7m1y5ZnBsmkISsGquVqIbmQtEd6x/FojaphxLuYnrh8YwdNrdbJScbOqJEhvs/mYX0YbRUGMijGMdBy8w3Jutv8flxqYoDCxdSnoYBcEvc6Llm9jVd/i6qry/+Y7c0+q72Oqam3ge179Zw8+av2Xs9+/cT9DZz9/9LtZ2aglK1zeORA/P+iX8cKWRQxTe3LU9ae/yEvKH9jv+s5r5L/G9pu/lCwrlTLlj1ezT/aK+PvBxbCXU1lehPN8JRr9uJMu6Rb5MXFOllRJunLF7PiJ8VrDju39TV1FY09PIdagX46JZW4AKrGLpIR0RmqaiicSxMa3SdTJP8o9TaHpP8o9h6if5JVPRtRUSRFRT5R0KlFVVVVUVciIZfMpQr5PhOz95YX/Nwg5+u25p6ky+e255xDyk7zyyQiZKiki5ImSfiwhs6oan5B/MzTcm4LZ8L0NmVn+9v6Rd0pRoVfBluQfZHkPZV12Z82NwKvW8QTf9nsbYNYh0/C3ypyJhIi8eWHkIkOOMvT/swWxr08ZKix3NI8PQ1s3N8Abr6p5nl1rqqJq9ze92qE3zxUavDdQSfD+pvyEqqraoVdN8lTNPFJT1KB2GH0lclXMXBUuCab+uQpedpO/DvVSWdpCqsq9TWW/47u/4E9/P/uw4U+YLNgT+c1fIUKQkmI1oSWkMb638WEttA9juv6JAyN4b1NVySgMNmRZnMZX2aA2k5rIDxpSuUJwhEG2Cmjl4VnFE8czXQNBKTQPq6Or2AdVGaGc86pmmoz2Kqwh6fdWG14G74rGZI1CXXBTj6sNzxZ78/6k2vDyUQRu7ctRZFRteHMSIf8n1Y+fhvWFaRWG7aqQW23na3/ZBj+byMYkdPz2akNlRJDN8TurDThMEjP3lbobrEIw/pLbXb3qtlCvWQVljSwyveH44zxZq81JtJXHaXT8vY1YpIVq1czzc4a2ppeuOGcpOKs0rjik+4l3rzjLFGwiWOMMuQa4LQgOq40rToEtoZXggoumG5iXIU/1ldhANsvhxMtkhpdJC3aqSRIZ22lXDpPJ0hOaJWQOVElBgq1S+3fAzRn9blZnyD0Y2jbzZsUmWWxdmbPKZJcMkthPVyFafOIqBP8o29CQpnZP1COZrZ9bj0G//Ix6FFL1qD1dj2jujuvR/u3ys+uRTHbPrUfvLy88ox41qUekKgGT4jnp7WVVpuF8xNYK80mEdmhRxPGnK3Jdl0Czp6Hm6kmIDLpXKYZRQNbOVyh6vILOTHewea96qCpHp20l6hgw1ZT/FCpoVlHVozoeFG1WKdqUn2lxtCXRNkfbEu1wtCPRgKOBRLsc7Uq0x9GeRPsc7Ut0wNEBolXRq+bRNF5Nwn+Xw4PVxhVnxOFC44rz25IF8HCVCxznqcBxnqMTjk7yGG2Ym8RqKhG6pjIwnYqz4xFbKYQkj5L4OsdVFFcc347i2xzfieI7HN+N4rscP4jiBxy/HcVvc/ytKP4Wx+9E8TscvxvF73L8QRR/wPFHUfwRxx9H8cccb9oR0LQZacVIS5B2jLTt6NwXIR1BghgJBOnGSFeQXoz0BOnHSF+QQYwMBBnGyNBWqQYa2akWGskL4/iFsSCTGJkIchwjx4JMY2QqyCxGZoI0nZhYjhArRlqCtGOkLUgnRjqCBDESCNKNka4gvRjpCdKPkb4ggxgZCDKMkaEgoxgZCTKOkbEgkxiZCHIcI8eCTGNkKsgsRmaCNN2YPq7QJ0Zabrrx2m6q8dryQid+oSNIECOBIN0Y6QrSi5GeIP0Y6QsyiJGBIMMYGQoyipGRIOMYGQsyiZGJIMcxcizINEamgsxiZCZIMxMTKyPEipGWIO0YaQvSiZGOIEGMBIJ0Y6QrSC9GeoL0Y6QvyCBGBoIMY2SYOTHyMtx4GSGWvDAmM19ELEEmMTIR5DhGjgWZxshUkFmMzARpZiOkmRVixUhLkHaMtAXpxEhHkCBGAkG6MdIVpBcjPUH6MdIXZBAjA0GGMTIUZBQjI0HGMTIWZBIjE0GOY+RYkGmMTAWZxchMkGYupk9O6BMjLUHaMdIWpBMjnRwvt7rKqzD29VicdY3XbEiCYCnXi7zC6yVe+PUy7wf0Cm8T9CrvHrw1ccIzzjfgEToWSbLUmqqwGS2KF9QqxwtKFt0Vjsfr7TLH4/V2iePxervI8Xi9XeB4vN7WOB6vt/Mcj9fbKsdvqyz2dlm/dItuhmYVVFwYbBXWjqNvzau1INkZtfNqNUh2Rp28WgmSnVGQV8tBsjPq5tVSkOyMenm1GCQ7o35eLQTJzmiQV6RMJNFhXpHilURHeVUNaGeUk0NKdP7wh/MNOaiwRD398iqdHwe5Ru1Pchv3VvU8Nsr/JAuoBnviNdJauwx7gJYfjMqN2p+E0mctxNkv5QMIh8TLbutXNrz50FtQ86Gqvlr6H48eXS/9hf3QW6SGFktkUN/xbLWAPTgfwzw4m4pUfiy/YxzOZpQXmva10FsKVbqkLqUu4efi9x1/sMDlV1LocIHzptEelTBPbe5VU0mjBWYMVE7+alMSjFqDu9JabZDmXqGhCyDGga5esPxB/h3Phd6Mh07fAIfIOYB5i7eMHfhf/b4XHY9rg5CMX3jziXTfv48jTC3xlKnmA1X99wAWaCjV/qKNslVe2pfkZEC0+PQS3scF7Dx9aFXNg0GRbP+N3f6mt3boJfv/EW4/qkqO+nodXKz5D70lVTvyFmI9lBNKKFU1f4gMi6dkOPSWU6eqRbWYOFwEr1kvqcqrL/302X/ywytn9kNvRVXUAv6nc736x6783Z+62fp7+6G3GqolI7qgFqGCeWTwnVbVAhBvQS3A0f2iWlQr+CBcyYCcXo0IUzudMCTagK6mqocRO8iyrHteZtOrxY1DBKsRwWoo3yhLZTYhsOFSS2WjwenCWGrUcLpoHsVukkLuGjb6BX7t2U3NKlVH3garnmVxJKgceVXWP8viRFA58kQJLYsDQeXIW2BNtCzOA5Ujb5HV0bI4DlSOvGXWScvSaaBy5C2xZlqWzgKVI2+F9dOydBKoHHmrrKWWpXNA5cg7w7pqa2r+0JtXGyHpAQSstjavqhS/E7DyGk0n0CQIWIVtHi0CVYOAFdnm1SLFHwWszjavlin+OGCltnm1FLI6QyCqbfNqJRRtKlFwm1erIatFBKLmNq/OhKw6EdCRZV1VDsG/DDU4XLVQo9cvhBptuRjqBTgbD/WiqqilUC/Dv2aIbqpWQ43+eSbUq6qiNkK94Vs6Twpm3Ey00NHQ9zJqQ7kqL0uIVyFzWDzbZMmNAjHCUuiE0OoJ9JjQ2gl0SujCCXRG6OIJFPIDGVpITbRF6NIJtE3oygkUVoKztFTTdMUeGLBe5v0Sq0iqdTr6ndqFi5F+F5xK5Um3kGbPp9atSBPMy9JPJbOmeB+rRZdwJ1Nmp6Zgbn92SnfxtJTm0mkp41NTesunpbRWTkuZPDuF1g1spaqn6Ac5fpP8A5+a3Hp+cvv5yZ3nJwfPT+4+P7n3/OT+85MHz0vOpjWOKgBMjaMqAFPjaB6AqXFUA2BqHC0AMDWOFgGYGkdLAEyNo2UApsbRSrovhySLDFZklgYK+3Uzpf8rga6gV5jaBtVAV4GZ2g3zgZ4HZmpT1AJNJjFM5Y2FQC+Q3zcDWwz0IjmHM7ClQC+RBzkDWw70MhnhMLCVQK+ke22oVgO9KhxSmRVWDQ2RFVM1YtmMLJmRRTOyYEZqZmTejFTNSOWE5gu20vOauKH9edn7zvP5pjvP55tgns83nXk+37Tn+XzTmufzTXOezzezKgma4Sbpsjv+3gZWwlmVLpYmcmOyUneb84QcC7Jcd1uMTAVZqrttRmaCLNbdDiPNX2Rkoe4GjLQEqZFtBiBtQebJNAOQjiBVsswAJBCkQoYZoPzQ/cWNWMcW0e9tNHDRMaxeZd0DivvTakOuQyx/yNCxAQ0YmhhQn6GxAfUYGhkQ6qMqsuNHuCoqFwhHt3gI1zgMOqgFDoNKapHDoKFaEvUHhJdFNQLhFVGbQHhVVDRQTjY6CVn+sIWqgVMuKhcSn0bvSnwm8YnEm1IeRBRgO0A+ayrRAkdnEq1xFPdOiK7LrdYqnCr+rxn7M+8zF1CXmPOoy8z6hKMbMrRWYVG1Kp049DwLptSYUQihRzAn9SJzR/USc2T1Mou5rdCxWq/S6VevMS9RrzP/Um8w41SfYaat3mRpuLN09tZbdETW55jdqM8zi1MrZqtqzXxd7bFszAU6oOuLdI7WLzBHUn+KuaD608x51dvM+tWXmN2sP0PHeH2ZuNv6RcUehj2XTvOsCuZliNUdkqfZmpdltjRH170cc445qrw883M5ug1zF+SRjqI7XpG5ouxJiiwNhCqjXgwDlVWfCQOVU5fCQOXVNhy+qE+HgSqqT4VkJg65LyL3C5T7AuX2KLem3Ipyn2c7fci9hdznKPdZyr1Juc9Q7g3Kvc52+5B7FbnXKPcK5V6m3EuUe5FyL7AhP+SeR+4a5a5S7grlnqPcZcpdohve8n8yZztPFCsy842zLfYpWE2Zf98W+xSshMzfa4t9CgqRfQoKkX0Kyz94R9n+wTtmqWSlgkJkpYJCZKWCQmSlgkJkpYJCZKWCQmSlwuJOQVt5i5uZNvEWDwTavlvcv2njbnG3pa2mxb2R7hcs7mR0s8DS1DbdKYgQNN0mWDxe6B7B4mFAlwYW9266LrC409JFgcUdi64ILB6odDlg8fijawGuv0MXAlx/h64CuP4OXQJw/R1i/3P9HWL8c/0dYvlz/R1i9nP9HWLzc/0dYvBz/R1i7XP9HWLqc/0dYudz/R1i5HP9HWLhc/0dYt5z/R1i23P9XWLYc/1dYtVz/V3iy3P9XeLIc/1d4sVz/V3iwnP9XeK/c/1d4rxz/V3iuXP93UhMEtx24rNz/V3isHP9XeKtc/1d4qpz/V3ip3P9XeKkc/0z4KGzxssoA9M2eEIuxrlZifpVhrjq/F0Z4qfzd2WIk87flSEeOn9Xhrjn/F0Z4pvzd2WIY87flSFeOX9XBlxy2hxAZwC+ckcZVmlsZdjcDp6JrIFLq0SNQ4WrPDovub3MVfmtS243c1XqcMkNMlelbpfcYeYqOPIUHmSuSh0uuf3MVaobtKNGmbIQNgNuPBOnk2XidLJp4kwyxJ9ngmeIM88EzxBPngmeIW48EzxLfHgmbJY48EzYLHjvKSJ0skyEiRBhcpIIO1fJ4LV7yd2+Snaw3Uuuukq2sl1aOdefTSx8ZAf6jfiwYY4/bJhLf1iQJUY/t2iWWPzcolli7nOLZomtzy2aJYY+t2iWWPncU7PExGeCZol9z4TLEuOeCZcllj0TLkvMeiZcltj0TLgcMeiZcDlizTPhcsSU5x6ZI3Y81z9XdwMJd3N1tyvhXq7u9iTcz9XdvoQHubo7yM0b9B8iBvfKsF8UZBuRjW+i3zBXLv9XW87Sk9r7FyAzTk714HilEPtKGRQanhNFoG+cjSK9JFM3CQYF07dKp+CQbvGg5C3j2S95qwlr8D5VcsRC+uA5jzm4ojKJbNPyEb86LIViIXhZrYRivndZrYZkANjyJ0kxx1ExjlrGHo2iJIOflZet+N0e3m2W5QUL0vhcTIbenUXvDgv0gl6lEjTShsX4rQEHIQff5+A6tsEchARbl4Oge8DBTZLaKuqzPD46pbiwoCSFGVRYJSpAlJarI1+/For5Y/6sDj5mHFcLJjL1mlBhUjyFCmsRFab84hY+m4PnhArHxYQKFtfbO0uyY7iDmJHE2DzGd/R13mZi5MsCJ4LSmAjeGTOtLWlMK2/DTOtIGpPUWzfTAkljyntrZlpX0riBvBUjDco4iVW7ZXWOW3Qr1Muw2DkuyMEhA60IOVso+tSBXLdYEMvyHJX6whFBqQ8bE5T6nglBqc84JihV+ylBKykCktSfdRlGrU3aMSwaHinKScr0qZRAUmZPpXQlpVk8mdKTlNZTKX1JaZ9IwSIEtmX2itPPUKxdJi0vMq/tQOwtozLQR4HYG4L9DIm9IXhcILE34uWwSm0ZfFwaJWWwIS2wsbPGN5UbXh7oY5Kyir6nDMaaRUztnPExZZjEs4i3XTC+pAyXRxaxuIsJPCg3vBL1eJts0wk8LDc89i5vk5RX1A3g0IcsI9gkDxZ1hTIcolskAFMxukO5wfdopmFnyz8uw+KeRaIw80a3KDe8Gk2Etqol8KwMDTCLhGEWErg51/AWWT8VVs7ijjQHNTOLJGKWEp9NhYbnxtf77raDu36PmOy8PQ9EOoi47LxLD0Q8iNjsvFkPRD6I+Oy8Zw9EQIjsGPHWPRAJIZeoRDv4QESEXKIQbeQDkRFyiTp2YvCVoIGICgUiJeQSVWh3H9D2nqCRCAkFIhrkEjVorx+IbJBLlKAtfyDCQS4JB9HOPxDpIJekg+gAEIh4kEviQXQOCEQ+yCX5IDoOBCIg5JKAEJ0KApEQcklCiA4HgYgIuSQiRGeEQGSEWDuIjgqBCAm5JCREJ4ZApIRckhKig0MgYkIuiQnR+SEQOSGX5IToGBGIoJBLgkJ0mgjoOBE7MJvuY3NFQzQaqv9tJhmrAw4j+DczyWClDTEN1GRxpxGbYuETGIlCprEUA1ww9sOVxtgAdRpjo5FpjGUv0xiLaKaxCo3HNFalwZjG5mkkprEaDcM0tkBjMI0t0gBMY0s0+tIYzYEnxiFJR/EYDJMxKAflMBmCclwOkxEoh+YwGYBydA6T8ScH6DAZfnKMDpPRJ4fpMBl8cqQOk7EnB+swGXpyvA6TkSeH7DAZeHLUDpNxJwfuMBl2cuwOk1Enh+8wGXRyBA+TMScH8TAZcnIcD5MRJ4fyMBlwcjQPk/EmB/QwGW5yTA+T0SaH9TAZbHJkD5OxJgf3kE/uOBvT/vG4wn5ZNO1JBi5t/qYV8Za+RnO9SxvJWYXuB2griWMz7SObVfGlTjvJsavPYoKvijubLZrlXX0Oa2+V/b3o8wCPXejr+x1I1QPUAKeu9uiNir6AFbUqC9nM5YXs5PDylA5ODkOlzgcnh+s5tRWcHNZn1WZwcvifURvByWliXa2dwLJqRa2ewGDA9UIKm1R4LGGJrTRYnS7jdwqN2pf4DKKXaQ5TDuer/btyiYsrzd2HXhaKMQO6MpSMWW6oMNlHsIAJMmTJJ1IuLUgiCbVUwjhJWE8lTJIElUo4ThK2UwnTBey7KGEnTLZdqRtZsvvRrXpZf5dUfQYbDdlCYidS8pZFsHzI+HFBRciIkankFHTM6CyNThhtFlPoMaOtNDpltG2iFoldXXG6VV5CerTb6lVZ8sniBqO/VZZ+smrwaTAtgJX+4bKdfcK8D+bHCyv+/4OcTtI2b5LyAMzEeg7O4026VXcasSFhXIh7mQY84phg7Vng+rNA1UDJTgLm/GzDy/l/y5I+8f975ofUP0fmo7n+ubo7kvA4R5qqXP8cKRNz/XN191jC01wdBtG5/jlyD8D1z9eh2MP1z9chCcj1z9chBsj1z9chA8j1z9chAMj1z9ch/cf1z9ch+sf1z9ch98f1z9ch9Mf1z9ch8cf1z9ch7sf1z5PyAtc/T5oLXP98HXbKuf55csbE9c+ThyWuf4HcJll+q4DO1ypEfcTy24S0DaRDSMdAAkICA+kS0jWQHiE9A+kT0jeQASGDBKHvLTBzgY7dtpgkkNMTIWMDmRAyMZBjQo4NZErI1EBmhMzSv9ssknsoOtuCJkWDJoS0DaRDSMdAAkICA+kS0jWQHiE9A+kT0jeQASEDAxkSMjSQESEjAxkTMjaQCSETAzkm5NhApoRMDWRGyMxAmiWankoJ0iKkZSBtQtoG0iGkYyABIYGBdAnpGkiPkJ6B9AnpG8iAkIGBDAkZGsiIkJGBjAkZl1ItPinV3UmJuYSxiRChDCFTA5kRMjOQZpkoUzYoQ0jLQNqEtMup3+2U626nzNwK0MTI3yWkayA9QnoG0iekbyADQgYGMiRkaCATQibl5B5+TMg4QbBkjspX3RGx0uEmGxb/wKrnYJqhflyuwzE2sSNAK+O3ZoTMDKQ5R7SaM2hFSMtA2oS0DaRDSCdCUrcJwRxzS8EjIQMv5f8HbxOCOVkgu3N1tztH5BhXYnJwME2O3lzd7c2heajSfeMzBoQMDGRIyNBARoSMDGRMyNhAJoRMDOSYkGMDmRIyNZAZITMDaVaoMSpGYxDSMpA2IW0D6RDSMZCAkMBAuoR0DaRHSM9A+oT0DWRAyMBAhoQMDWREyChCzHuNcYXuNXr0nb259L3GuFIu/70zTvX94hM2WLICVWeVuQJbUYysX6SPOdeAHdSXrGbZWyNjXzxFQCLv1T9O//7BfmiIvnvFujslDvlWMnucmlsofy6ZVn5M1ta5ZL75MVnb55KJ6Mdk7ZxLZqjnZY0jNMheffsn//jOZ/7aT5M5oMIRS2HUmAn78bnxMERR4TPplSZTlvU4LJnz4hefTT2DaFlW+LBkakxenD7nxVb04jbPo6kXZ895sR29uMPTberFZ9LZIG+WdU0smY+TF1unvpiNzhg8c9NbZQi9hvHigdiJ1+iYCoOB3nLDo5s6GGWzNIRz4Y8L8jI5Zic1i+y0SOfVssqp7KGXFT5TlEBnS5WPE6ZIIF+bXh5vRGLuvxmGXhZXfjl+0csZhpQKKqsK9za9rMp9yJH7myp/KDnqB0cBF59TxcBQasjCsCh+PitM6CAPweNMwherH/yGmAOFIT02ehMZS5xu0QVVkfRykpFbq7sDmFQYbjbk2EfTCMeUTLEc25bplWM7MrVybFemVcTic2A5vo0Tuzf/BY+MOBYcedlDcjmSoVbKSCst+YNN2DzLkgW3UOXYcVqNaRkGHlnzXfJnmw2VI/PBue/HZpxCag6VP/wgCFX2yMsnOgb5lB43fg+i22JgDIfos8qFht76B0Fsh2SaqvNv/OYRLDbkDnVeZV6yat4SETKPPoij/iZ425tlslmRBdMLLKb+2YY4AVQoWNE7fvMsug69uRxryUTv9fHeIH5v23iv9bz3BnhvGL+3Y7zXft57Q7w3it/bNd7rPO+9Ed4by3vc8MarwfNeHePVSfyTt433umfRsem9zFPvTc7y8kNmjDLcOGIvhRpHGFNJXxqdQV+iHjQsRJPEB/LOX9sPjtSSGKs7mXD4AQ/EddNeRkEtwXadtwTJM3RHL6dW1TpxvQwLLVKcyt17qquJOd4myTCOo1GSOQj59q2V8bIhhjmtFEZyGAY6LzYXo2HdPdeg4bHk7zxsoO8Osjwjwh9kEuxx0NRII3ycZBklweHTuVWe5+B4amHzZkvoyFsw8DGFvQ8IT8q2jxpySs3L14THZ72sIfpcTCaHeHxmP8ACyO8UPiDVoVJ46OXizFZiuU5lNr1yqGIJ6yamhY9rCRdZoSqrbHjolRDEshIE3/dyR14ZZnNKKnfkzalCCDsP9MVFVcRrBcpWOvLmEc+qgsojax4KSyjPKx+q0pG3EB7qnMqqudCbU3lVDL1FwksoqqDmQ8wNCx+XRvKFh7qgFtXcoS6qsqod6hJZfdFl3oPpDRe2AOPVibq7WobPY7JdWQ6jlUZl1YZa9ncbyHeGfH6Zaauk3YJOp4qsK7qs1uICqayCmZ9KyJsIvZvjd81GLkcHttoVTPfrJN8sO0e4mKrtWd8rq3U2TUaItQcryuRBRMPc7j/+4Bf/zp//737n11+76nbIED5kociy/YGYyPWW2NT6EgyPLpN11SUfFn1ezxy8+o//XFD/Ezcu/S0yVObCsOwSjJCunkjAtHG+oW1ZTGzlxiZEyXZxjiDHhPIE2SZUICiJF2kcFmmxjhbtrMrLM3dvU0MdIQP/ABlYJM2oVRCNz1xPrsD6PsLLZJ80MaEiFjphZsooxkYxbLBOLRPt/SfaiQtiynU+4s9diuy04KszZGk+Kt+zG7FR0JThZMe33oRBTJVhc72ZyK4VGXG+yZbjXf4xVzux8ZalqCM8EScBsE4H2/Kpxu1+dLK1f5Dlo8cf/PBECpn8hrhT/+Q7LXI7YL1sn7QTTjaZqTpXEFIrZL0Z9lCZECtsq3lFrUS2msVGs+tbaqW2ixQxzuxCbsKVvvcm+a8U88x2ZPvZeUZ5cetxubiqek65t4lkKzQuyr+85GSe5CAytvOOl72Ilsj+aQ0bKqU/rXMiWF6MbLeL6OHbnlPNWpbtOpBM9Ae/Z6FFdV5Eyst8z8gS8D0bejqv2DjCZ5WzZ60bi5EqHsbmixPQ2VRFcaH2u/shJlpVMrZKm0nYgRErsTr51m8GUPCci886r/6prT/+M7VfOI8CQ2/uMHmtjBfLpHiexQd98PaedYmDH769Z32GDCSQVQQ8s/56o/YVVU5Z1sm+0mxm+JvKVI5Pn/aMF8sKBq4Vydohe5GzZ07JTiU3C+BpZFUJkt5ZLMnWibyUkUt85V/+7t/6C//L3+50969Sye5pJXNrFPELuVRd3FOrnjOrzp+YVXOJmVC8/6wXIwdcMF0df3mJf806/dcqbkqNtuIyNZpNxRWwuAKVH1sBGPXnzy1xq2on7oT+iU74av/cn/0nf6z/V/alIz3a5+6Bzpl0rRJ1F+ostMg66CdZlUPPeUYFaKy4bF79w7dpAovpIB3GPoUOmJbzBt04YzbugMunk125FecP09P+TXegOafsPPFPeFSDWa8zPk1o07OeTZPkGfiReJf2kC45OInW2NjkYjFxD/L+u7pwIiGyxSi+IW2ssF1xMEx7LWDOMzD7GVgKKMJbD7mZy8BIQA5raU4VxAajrJ7RO107eonesPGGrFSyZSnG6ub3ykaffOX/7Pb/61//+3/lf5cmyHCTf9K5KW5JKea/+XEtGU0y2yr7Kk6Py//p7+zHNVPO5vN7KLHuKPnF5Df/c/rNZ/bKLFv/z77y4V//h7/9wV//h3+fDis0nJ+e1+bs8skN+Gg/Nk8rgV/fZ9p4MAFP+wjndc/dhBnd17zcpjd3qIrR4N0/8orGimOchF79P77b+Jtf//MPkuKVuxl6xUNjW/8x4lWwO6apsBT/vrkIGUsLrXyS6ev7oUfWRV/bPNSl1PJDzk/L5WROcrnBSypalpxP0OwWfPNoNxnxc/yu61u3ftyg/3Gzg3NAk1Al7Qyc+k2r2Rykp6bKJ5iaeOpku4doJKwOaLmbxlQX9aXf+nH9VwrDOhMX5NuvVZ5ugOJTH+B8oqkr/gmqbvwbzif7jcwnXF+z/g52Yb+ScZz3c2Bwtyu8DWMRhlg+U4CDWDpTxCJux7KZIh3xViyZKUISd0y2sIhL3DUxEZx4YGIiQvHIxHZFAMLEDiKlLxO8Tc488qQQnfdLD1WOvaXn4YCdwsomhgBc6/ruz2TeJz6Ak1VO2RR9WRG/vDaEHkpyrIe1dhhjgSlM2y89xGrEPohI8RCuAuiU5Son1I5vG/VAKfDPkYkdxpMwQxTDwTojdeVEO4l9vDAEgXZUHiZ4o6oVVAafxyUohyWiMqpoxIW5QnaIssT5IV6nQ7xOm/yxiIhPFnc16AolJ/ukgA154HBXyMKyguW3HbJTmlVuIiDlgUEABn3H4d42sfnZtY2MtYMk4yNO3+WHpZx4QjvyHDHd8hljcrMxewnj6W/sK3uTSgp1kdq+4O889MDr9XewKqIt8izzZog4ZcAbQGI+LV4FrlyE11L40IpfWE8ljJIElUpgGxyUsG0YuyiAwgU/J34aYN2Zzkfuq+/9Bz9z/x86t/ZD5YbEIK0xiUg+qQC7vCFLzVleWRF3xo0XCbwDRwQw70vPOXmW7m2C21LGq2UqdYcHEyiQUWVVQrGmNQ7IJ0lKkawYGSlDK3rJgqqsG3rzqfSRma5CmGIyUsdm6jZOUWYqWyeZU04KZesklRPoVCyZpNGZWD1Jo2ydpHYCZeskpRMoWyeZA0vLQDs21yGNBjbXIY12ba5DGu1JHdJoX+qQRgdSBzdNealDGh1JHdLoWOqQRidShzR6LHVIo1OpA1rRS1dv9kxiNJ1nEaPlPIsYbedZxOg4zyJG4MQV2T5Rka7zrIr0nlmR/jMrMnhmRYZPVwRTYeBgKhx+2ik8KWMqnLz8jleAmRmxFp24daehyz6gyYwCjToWbziLEYHRjFtGTl6A+4oazBYtkPUoNR8GwVHgJRYoDGMU9zf1qir40+WGLqmCP1xq6Ioq+MFiQ1fdA1VgmSlVVKu1V1TBby1CWK/IeO2nVYFuoIp+x30IlZaC31lkQY2aykM0sKwKfnsxkt3Iq8Ilt7VIQX+9oarRJXgefZQcGXNUlUgKouVycP0q1H0pWLsKLWAKFq5COZiC4FMhWLjsdlZIB1jcXuTZKPh8SPL1R9QgRbB75/AJLzfElEMe9gDmP64GXaHoGoBdvYDHjl6kCVcv04Ssl2jCJv9MZSIQSFLmxVCV2RVznhQ35kNkHdloiTwpfCxQYGDDZFSeFEWWKdCzYSQqTwomaym+P/6RADPm+HK0JPvtn2yoOSL4Zbe1yNLHhctuexGLHgVHi6RuTOHhIqkzU3iwWGeyFi67/UVSx6Zwb5HWVwp3F2mNpXCwSOssk3YRSysFm0skrkjh2SKJQ1J4ukjilhQ+XiRdVgpPFklJl8LjRdJO5sovkYgi136JRAv5p5ZIJDBP3Q/VWOI904Sj3SVuSLvhFePLkJKDc2rJzz/Uc0KjUrRnqul5VaL1vKbmQz0veybOlffzD72yn6dlN94acVpOlZLtEUNFVT6RqZQgMHATUFcy91D+ZB2jJP9QSuNeJ7CaSzDYB5evwjJeQriEL3RZvWS2SdRch/LPOiC/fZ4rctkNNqB6s0Fo14vQCdAJo4MX4rxnkPcMoePtOC/QCaPTy3Fe3KoGm4S2PhfnBTrZBJ//VgWaDfw1NKpUtvaqXpnLRF21GG0J57ElJEfAtYaOroOnP9Lzieroj+4Ti/xEaSoT6HkU15xvcJrfcmmumJchmI8T8Qqm3Z1G7Sa0EEY5WHxUC/CakPqVmlpQNfJ1OM9P9iJaKwtXq6ZXwIspkDJy6kcLpCuc5Wdbni15NuU5y/BzmgGRHWN7W4gZcxOyB7gQejw+CorHBj1nrpER21vKuExjuQBVz5Y8R47M0/m4rqBBwZ9m8HfkgBCYinKvBj/6Dz/41cPNQQAjiaqmlu5teispoqyomlohoizxk4myAuOCQkw6/+VobmU5ibyY66AQCbFTiITYKURC7BQiIXYKkRA7hUiInUIHOG1RiMTXKUTi6xQi8XUKkfg6hUh8nUIkvk4hMtRBITHUQWEx1EFhMdRBYTHUQWEx1JHjuZhmvhxP0KRglONZm1SLcjyVk1JRjud3UifK8aRPikQUFkMdFBZDHRQWQx0UFkMdFBZDHVx/NtTB9WdDHVx/NtTB9WdDHVx/NtTB9WdDHVx/NtTB9WdDHVx/NtTB9WdDHTn0F68I04DwRCZtXKT7RLQxhaiNKURtTCFqYwpRG1OI2phC1MYUojamELUxhaiNKURtTCFqYwpRG1OI2phC1MZFNqxIbVxkZU9q4yJreVIbF1m9k9q4yHqd1MZFVuikNi6yJie1cZFVOKmNi6y7SW1cZKVNauMia2tSGxdZTZPauMj6mdTGRVbMpDYuskYmtXGRVTGpjbn+3MZcf25jrj+3Mdef25jrz23M9ec25vpzG3P9uY25/tzGXH9uY64/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxFq4/G2Ph+rMxliLuswfunjVwpa+ztgX3dda24L7O2hbc11nbgvs6a1twX2dtC+7rrG3BY5W1LXIw0gWtC+bS0UPxY50fNX4U+GHxg7VvDOA2P97ixx1+3OXHI3485gcsCNG6Ic+2PDvyHMlzKM+BPPvy7MmzG5XjSLnynAk+leexPCdReZKvL8+ePLvyDORJVoAWxYrPolgIWhTrQ8ti2WiZ1YiWMeCX4DgWCy5ZAKbl2R85sJBZomWKphhVqr0mHLQcGx2Fdl/H0fPYqk/gsqdMF60LeD7Si7SD18t47OolVaKTR55PHqRmSxb58ySIU/YnNTGzQIwBVfbHDKwyH0GV/VFNZI4sYsCU/SEDGTptARjUxIyDRTydMnYtbPMBx6+T+/RD6e7zai1UNRjLWoBIyqLKhGpJrYeQKzn5TmJBU0J/6iAkNy3E68R2vFi7FbEKWU6uxPOyIlJ6ZKA853dyDY+MkmVCtlFORsmyIUvAkk2yGk6FJNdKNskWQpZVJYtksOBFAqhkkIytVe+wObLFUE4griJhr92QBaMO8I3gzaJYMvD2Fj5TrKCRAbi7Ypj6ARdRiIp4JEU8liKadlxGy5ZC2nZUSseWYgKby6lF5XRtKahnS0n9pKRBVNIwLmkUlTSWktajkiZRScdRSdOkpFlUUtOJSmo5UlLb4ZJUVFLHkZICR0rqOnFJPUdK6sclDaKShlISGNUlcoJhJTZASuQDA71QmOIlcoFhRR2FgGMC1oUpXiIHGOjrwhEvkf8LjAb6lRKPQRqP9Ld2m5UXd/jnD2OWnngCojocxuy8BJ1EKFh5CXwcwaMUPI3gcQqeRfAkBTfdw4Rpl8CtCJ6m4HYEz1JwJ4LBt0vgIIJbKbgbwe0U3IvgTgruR3CQggcR3E3BwwjupeBRBPdT8DiCByl4EsHDFHwcwaMUPI3gcQqeRfAkBTczhwkTz6B3BE9TcDuCZym4E8Fg4Rn0juBWCu5GcDsF9yK4k4L7ERyk4EEEd1PwMIJ7KXgUwf0UPI7gQQqeRPAwBR8TTGf7lyF7t1L+gzknx5caMKpPhqloec3zsyfPrjwDeXbk2c4rWnom57w50uckLqU/PUdrTjkkvU7GZufEQjcxTxhrnmeDqiHrefrHlEeXICVv4ew5y9LZk9jlIXbZGciqvIUGOc+HcwXmJ9LuKrA259RcCGMVYfB9b45tLljCbtCwgVOlvA/o92tszYCr0uGqIHXMGG4XYLsC1vermA+JJUc8SvqBIAi9Eim0UqXa8oQbEzzhlAXPljzJZ07Gn+YafF1Se105sfVIJ7Ye6cQ61U6sU+3EOtVOrFPtxDrVTqxTTSE6qjixNrUTa1M7sTa1E2tTO7E2tRNrUzux3UjHsBvpGHYjHcNupGPYjXQSu5HkloQnEtLEJstoiBcSrek8XaB5xYYqqKIJ1hrIn1WFRL/axVXj3yDX7fgZCKhccaZnYZD8bIO5zLWXcKO/Z3Xe5puk2vUzJj+aL42C85ADUXP3N705Q2YgZPTepk6MIeu5JFjC5ThJxWRZdDALz6Su8wQB8o4LpksWzkgh9ZIVqZeIBNlImgW2JHaJh2gHdH2lssDlbm6Xj/ySUgoCXYJQVENnIw+jRbmRXHlYhvgn++0mByqwnYA7RrJTExWgS+V/7fFclvFMWg7TczRwZzEwO0ejlkYyAc3z3jwNY3z60+MXwtxU5ls0YMs0mCG4fl6GZVmGcI0vAEoQq5bxe9ltn9cLNLzLMnhLaiEavGw46jxNNmMG4kEr9wjGxQII839/5LoHuJDmfu3lJS3LEwgzRMmleg6dhJyBIoib5pz/Bz/60Y/y3EtwU55XJS5UZZML+cssXx1xZw+p0FRW+z3POZnfOZFfek4BPafAPaesLNTrk/9o2cib88cWi1+Vj/gX5mLpT/gogQg92G6Hei4lG6BsSL/034Yi4u9ZDZGZZPcE5b/6WefK+4skX1F4x7vBzlKD89rl6UazypfeYU+f8FWxo7LGEcTLwkfGvU39k9Bh/J+shn5N3fCHmYb+aXXDn+Qb+lV1ww/chr6lbvj9XEPfVjew9uvX1Q2/nW3ozyejfMc9wEs2WLGvqJ+svYKsGVwlvcJ47afVDRjpxJ1yqEUcXb3iZ6EstW4YzJ/u34Og9UvW75xhZ8Cv0Bi9hv0evk294vcLDxvey9CE4CWPf/hlP4DOY+1F0OGOuiYq2+oarDyEpK2A5ecGWc5ikbaX/c7FBrnhLSlXpHM/2qd7cL4ML92PTcFsHISem5aJcdUNv5mlulleKfDytb9q64J62e++0PBeTsSzSh+3LeSgjoLEZ4wH751ZlU9h+UOvAF8ysaeYI1yrvhydDG4YxMUXE3FBWHXjkju1iSV9DeFj+yplv3HJndjEmf68ej26bbutbkXBV9VPi/oxhUj9mEKkfkwhUj+mkCVlstnVVoH6dx4kUoUPPkxVm1jIJZVVRBn3SJNY/g0YZvVcJoZ75GWNT8d0S36jHpG+3SPuLDqrHGn/l5WLdfplRSoUsBH7NrmWRvd33/H2Llpqz586DX1Nvea9jMVD3/Qt7XM/9K7DHEmdBL+XVF3MkdfJlvkKni1br+LZhFJNHcbD1/F4pDfweKDP4HFXb+JxR5/F4y29hcdtfQ6PA30ej12t8NjRGo9t7eGh9AU8YIm8DivmL+BR0J/Cg1e7a8qnO6GbyufFrs76IZQR9r7pRfUCAeuw+o1iYfI7oKRt5RG0Q5a/UQ+lCDhQ5+l5G2a/JfNbsAOO7yAj4PgutUnAA3ihwVfDFjjnfQxOBtEFbA4ilFoNOa1tw7MNERMXm0RdWAePLjF9zGS+n6GZbA/nF72vrtPx5hpzXnhfQy/CSUWGC4P10gz/ABxTZPhnQ7J5SlUJYXuUahfqdQ49CvUGhx6E+gyH7oZ6k0N3Qn2WQ2+FeotDt0MyHwoahfo8h3ZDrTi0E2rNoe1QexxSob7AofVQX+RQLdQvcKgQ6k9xyAp1zre17x6opahl+XvrUfMeMH9DL8GCkzqgr4YTixWOgR2iV9Qqx2BZXq+qNY6BfaLX1DrHHoeBXlcbHHkUBnpDneHIgzDQZ9QmR+6Ggd5UZzlyJwz0WbXFkbfCQG+pcxy5HQb6nDrPkYMw0OeV4shuGGilNEd2wkBr5XFkOwy0py5wRIWBvqAucmQ9DPRF9QJHamGgX1Cf4kghDPSnVI4jVhjoXNRZ+AJ1H8zZwFb7YDB28FyhHfM+jJ+28FyjnfU+nPo8VvtqA1PGvjqDLc6+2sR+aF+dxUZpX21h57SvzmFLv6/OY4+/rxQmk32lcQrYVx6OBfvqAs4J++oiDg776gWcJPbVp3C02Feks7yXzOnXRed8DzyOECqyXVvtKQJabugV6BZBgKZLcmr9GJg5oefS/cPL2LJfUy4KtMDCuxbN9i9jyroO+bOQEgVUAAtpkJU3X44YRnv4iaH9IVUZ4RHCgo8RrnF4gvA6h48RVhyeIrzN4RnCOxxuOh+CbhRuIXzA4TbCtzncQfgtDgcI3+FwF+G7HO4h/IDDfYQfcXiA8GOpP8JNWz4AkZZExoi0JTJBpCORY0QCW+3R/H8N8797YEyq5mjM4QWLpi2mYl0RVOBJlwgpUI0g5r0JxLMic98E4gmX+W8CbRPEHDiBdnieJhE6gXYJ2iVxVIEOePImaVSBbvM8DlnUCHqLIPZkJtAdntnJmZlAdwlif2YCPeDpnlyaCfSIZ35aewV6TBA7NhPo48mHp2C2uCpoy5algY2uCtpmNLK7KmjHliWDTa8KGtiyfrD11fTKgRGmZWDpPI8n2mbtYChgFPCQ8orUz2zPZb3Kl8HOlAwFFYMH70RgPgYxdiDb7LKnzpeJiym5qNSeUeowScsmxY6tZ/3YJEGTXyP2ZlwCxoBR+tT85RidPbN0cDifLr1lp0sfGKW37WeV3rGfVTp4nEQZo/Q9v+3i8BGrzhE/wc+/Uy1bTvTPdiCfcz22DwVXK2KYi72tzHLsbWWUZW8rY5vdrTRd/SI7N9Avxfam4GVGDH3pz7L9M/05tgGnf0K8xfwUu4zQf4TdJOg/GtuvgnMaMRymr7AlNX2VrcnpXXFQk2HnE+KoJgNHNZFt9FpsiIz91kxy7Limn2XPNQObPdcci+eadgaeayJz6guwzFEQc+pk3Y0d2fSy7Mmmb7Mrm0nkyiYDVzaRBfZFNpDGXm1GOfZq082yW5uezX5txg47tmlm4NhGdrvX5NxTOPJcPKdwVhdZBqMl5thmvzTTPEUnNvulGeYoOrbZL03A69HI9srs04KiQ9ubY/ceFB3YXkXuZ06Ksnk5w4UpfO9lSRTu402qKmDHWvx4B6vKH+9v1Rz2thV18ekiFvmKK2APvCgCYnXYsRY+3r+qIjazZex257DVrahzTxfBl188f3MRENHD5rWAe7sitrZl7H3n4ByyotafLoKdq/J8z0VA3E9dQRFXUcQuilhGEUsoIvN0EXzPxusDF1FFEZ9FEZ9DET+BIv4oivgjKOKnni6CPcLyesJFfDok30CqoC6hiM+giJdQxIso4vLTRfAlIa0/yWYGXYV7Sk25R99PDnLhEd3Y2uo6r6C0sCaTwjV1nZfTgY3zci6aI3pJJhfeTxntm+hChA5MtBahQxOdj9CRiVYjFFcdtPyTv1FGr2MFuc53qFBil5FR+zwdRBHU131L7yUcjMRagk4Ml6R08pJg+ZmczkStSCcO33Qie6sTdUGTV5o4lNOfToKJbzx9KQl+JgleToIvJsGXkuBnk+Dn3AN1Xe1FbQVfVrRHAhuF7iLV5wL9OeWCtLii/GygP8uxvhOqlwL9Esdwo/lioF/kWNcJ1eVAX+YYbkA/E+jPcAwXo5cCfYljbSdU24He5hiuUz8d6E9zrOmIoz+K4faVXAFSbGqLs0CK4baW3AlSDJe45HCQYmNbXBJSDFe/c4Ge49jQ/nhUBLos32eLKiN/n/3x2Al0Qb7P/ng4BTov34drYphJ2UNn2pOzic3r5HWZXbMnZrj8iemqcGLuKZ6YSMonZoW5E0O8koxXivMUwJtFm91u2dFO0aYRRPcXtE20aZzRLQbtEW0ajXSXQRtExD9Ncd4dIr5Ncd4aIn6J4rwvRPwzFOdNoc3uytIm+DHzpC3wY0JKG+DHpJe2v48ZMDG/nz5meXQ4enpm+gkMYPrsqC/T7HSNjlDqJ8weH3rxzPAyzU6SCe0laN9ECxE6MNFivAM00XKEjkx0Lt4Xmmgl3heaaDXeF5rofLwjNNFavCM00YV4R+gY6GK8IzTRT8d7QRPdjveCJnop3gua6GcitGuil2P6muiLMX1N9KWYvib62Zi+jjHPfy6a55NBWFY7uKLZEfYyJvZb6hVkeEXEZm5gz3fRUjvl/2jJWX3i4Jq2ufWOl79osY42meuie6aVh3A9H90BdG1vHT5pSOFuXa2Fes236b6Bb/ddVfBXHnpZfwVe1xO1O0ypTiIV7pLh4yTRSWKhWgvAweHbBZlV8uh/KgNtQi4FHA4rglUlwZyDSAFvhWw9kgETlOLitoRMoUQ6eV2b3ISXy6S8SN5c/dwbXuGmcv386+9C95d/wMXvcgVJtK2sKE+O8ySpKk/pE0cyZE/J0MrAmIkLP6srcu0GS9Lxtx68oyyyhYlNhEW2MHc5pGAfk0LrEMujUA0MagoVwKCmkKicDK3YGBK0SmoNMm9GlICGzdR6x7MvRmS0/dF/bzVqb1C7o866SGZGzHZ30+1eMvTvS2j3Mtp9zmh3B2Pd0KjEpV4qsXyy3Uto91K0mvitn5J2d412FzhSu1wz1C5X2MzciSaO3NpGpQ7WQJjhJgjD/ddB668+JNveQgoWmUvfadCrymkkU/DaEV+JLb1Bl7crULdAe8IJKGXO+j37YUNXfUsXVQGq29ohTVb8BnfQDGUh6TrT4kiyQ1nDLbHKvo6f0A6UItCzTJVNKiyT0Jq8YISHek1VYDuneJMsy6wlP7vyUJqJfAtEHyYFkGsB2GAhJZwy2D4oykHbOMrlSYZfiX5Tran/i703AbIrS8sD7z13eVsuLzfpSanl3FuqqqxNldXdSFndTStvuapQewF5mQhNhD2jpuSe8lN5pqpobBnLKDF4IjEEk44Z7KwyuO57wibBhkkGGNIzYJIA3Dlj3J0GYpyGNk7AwSRtloTGdnqM6anv+/9z73kpVRfGbg/hIUOhd85/z76f//z/9/fu8WEPKhtZy8aZGWn2DlUzs+boaA+Lw18N+ryG7vxK0OeNsvzloM/L4dG/CPq45xW7nw76uH/C6ALvn2Wjn82p0lEI0+E6JqAbxPcvg+euvN39YlxWaZn84CHkuiNPO2FxlEJThXG7f8iKMRiC3zjrUmI8h9fALZC2lLRK0jZI20paI2kHpB0lrZO0C9KukkqS9kDaU9IGSfsg7StpUwyignSgpC25i4J0qKRtko5AOlLSDkkrOEutdIW0S9IqSKtK2iNpDaQ1Je2TtA7SupIOSCpBKpV0KFA/IG0o6YikTZA2lbTCe/IWSFtKWiVpG6RtJa3JbRqkHSWtk7QL0q6SSpL2QNpT0gZJ+yDtK2mTpAOQDpS0RdIhSIcYT4cpNA5NsX62nzf1pS4sDlJsV6ZYO9vPxyvqfooFzBSrZ/v5REXdSyFVa/Cmmp9wVBERyQ39uyk4CJ8OMKiC7pNWGAT92hgVeQIb/dqwFB+iN/u0MKJWt1D2fq0rKQ3TF/5G+ayXB4dtsZdwLM/Ua/x07Zyqnd3aOVk7w0Iw4j8d9Iud1JsVMq+R1y59Ago/2e9+iW0Cbnq9cZm2d8LHojU6J+BcpfMEnCsNAXQOH4uO0ss0LjLnskjsrJuDqsWngJfYRnR1wsIskG5pBcGdVjZw08oyRFpZhkgryxBpZRkirSxDpM4yBC2yC4RBWtmESCubEGllEyKtbEKklU2ItLIJkVbWb1PP+m3qWb9NPeu3qWf9NnVSTFj49g8DwtQVDQgcYeNfOQvm4XclYfuO6t//kxqqCK+6wXyWUqckd3fs5vIwa5g7I/JITRs//+d+8ZFnmn/nzpXhzTzkIQQvq60RiGCD90/Dm4dt3mOIvDWA+E9q42EWi25/hTDXeDOn5+Y8r4C0zuwVIjF3rMup50GfaE5XaaC9yqmXtwcdiPO8fcMAeimAEAV+7uY8gOjedJB25TAjet9S3vYyS73MrMdZ0Myu0Sp8lZnNxwedrKnQqB4a9JiMgHiUOiEjZEwGD0o4GgXDbEJG4JgMyXiEoSUDNrat5z/Kv1+4MhQwBnsMx1JGXWw7fkAKWDVGMlVB6IQCTtArSwHSmzeB2EsPmilP/WImMlIbdoTakJEcj1KbMtITGfoNmSlNmVixbfuFQ0WJYTlSuNudH20ac3fujpjUq3E1AYSIXvcosRjp8yiJWPPzKGr2z6OIeUCPQCs2r3oEonq+7BEovXXDI1CY7LpHoNjeNY9AI39XPQLN+y17BBr2W/IINOm36BFozG/BI9CMn/UINODX8wi0j9r1CLT92fQIVNMIPAIO34aj1MjdPhxteBuVIujktz20RmNhNXhEsnDC0R6waSlAgH4nCOtnBA5GmUMjsDEOCWukNygxOApDo0ynEbgaZUuFI90ijKtwpGeEtRWOdI4wv8KR/hH2WDjSRcJAC0d6SVhs4UhH2ZlSnjy8vrKzEEMYgTYb2rlSHj+8HrMnSnkI8TrNnix5hHYX0qBj68vFR+yJ2v2anfM9s75nxvdM+54p39P1PZO+Z8L3jPueMd/T8T1t39PyPU3f0/A9qe9JfE/seyLP07mXhIYGoeQMT+HbXHgPeQpbSzQpGqnhMB36QbFw/BOePo9Rlu6jLN86TsHL5THS7v2kvftJ+/eTDu4nHd5POrqfJEalRkir95PW7iet308q7ydt3E/avJ+0dT9p+34S+HyBgG8IKeQlCwfjhVeOfYIZt+Pxu/dRevdR7PEsbHpfygsQYE6Pd9sx0tH9pPK+8ltDhTkP2BmyjgPsek4BqfPtiUnuJnesBBdJ3VStKihqV7F5si+qaLsdNb1M8C4acG3AHl1MJGo5RECKe6mfN52UL/fdJ6JX3VkjJvulo7BdvIM0nKw7uEHyggomXUe28DE5WLR5ugE3qSXlGpetPRat3BvihDLty+KEDuyr4oTq6m1xbkc84MZ44HS5QHga2VDZsa2H25YeeMd5CEbD2RSQ4A4aCmqoivxfcpkH8OzHwP046IkkugCfZxFOd2iA9gO4IdInb9h2eS/vvDGgdDwiwf6zSMp2cBjwQdI3tXRUIfXoUCW10ZsURQps502KIPGmprYtuIvpm8SNUvsbBV6dl1rFToo2FilaVBr2MyLog5plb+GE9qdWWIvpIRR+ZDzwl1UAhx0PENYohj/4EcFGDh1Tdi3Ka4zJIcob0UJup/P3z5jTd6K7DKpskdWHxfQCjP9d0JFD5ojIEphi7YIKBphi64K+8pti7WGVJjbFwQV9vTfF4UP6FG9UVDibsabYFucsqBINiHqHF5xZ9+LoIbXSboryghpZN8XOBTWybopSouEifnRBzambYuWC2mY3xcYFFRswxa44z6AvKYmCq/7qBWU0U3okeXtebwqlFCX2PIVJRI+0gxd/U6w8XJN28epvIK0sdh7OUpsbZ+IejvLzw9KmlBFt2JPD0jbt2JD3gxUJdAKBTjHQaQaaY6DOsMRchvahjfHelEAo1KZ2loGmGKg9LLESHEqgiSEf1BGoy0DjDNQSQy3QdFTjyLFcMtoMymvEGN6+zw5L1RUNxJ5prKwLqxh4RoXFGY+8D35oCHdEwF6Ef8JAqt37uUVcvDdgybaJS0lP3DRyYsXdw7VkQdwWl5FFcS/krcqcI2+bbVnFeBnsyNqGdf68jXxjj4KkcF1c12SZEySFl8V1QxY5QVK4La5X9Q4vUAqr6lxxV3jFUlhX91qoK59iKWyouxTMhMBhKWyFRCU8J7MUI7NqlC8VLrW19pycYgzF4ZLSNVJMhWOcxF1TkbKEY7hrMHQja45zuGs5BruKU7i2n1Cu4QyOJlx2lOs4gbMhO/YcTqXnikSxg84xFMttQ6+EgBikvVKgf9CxFcIWQwnndojXXENop9aQpN2Q+Locm9SOyWMutrxG8qivGQsP6HzNnKIWpecViLKuKvwGot5OES5V8U5Vu7tRKXY3Vae75dS526rJ3dERHEx6g/TE522QuuGZ67aMAZqP10MU/AY3SPPJepjm3Xqg5lP1UAU4TjVY8xl/uAIOpx6w+ZwMWZ5zzruBG/znM24d5QYGk2teUl7GrdE1Mimv4s7ompqU27gxugYnZYXyFK7dY2Gn4b7omj8Wdhmui1UvxMLYwnWx6oxY+E+4LlZdQhpkJuZK6Zjf4awrq2lXTTqZf5x21awrq2kHx36IzUnCHYSQmjAQH4H2KVxHhGdDCxjb1eRWDYQjDO3dT0uwdQPpLUPj9rN0bBjsauWxmc3Lr1ZuSma2QIKcF/yQ84Ifct7DD9lXdI09/d3VX6JsnHjXuV+6ye+mviwCVs9uC2wQnfyCsivNQXxdkSG5ysYgnK4IjVy3DiTihoqJvMyGwMkU7QBOCJqBbBLXDO+0rNSLirekJN6SknpLSmN0SWl6S0prdElpe0tKx1tSxrwlZdxbUia8JWXSW1K6/pIyNbKkTI8sKTP+LpjP+vsgRnW9ouQn/TUl7/1OVhUPwMEtKx6Eg1tXZO05tq7I8uOvK7L8+OuKrD3+uiJrj7+uyNrjryuy9vjriqw9/roia8/IuiKLz8i6IqvPyLoiq8/ouiLLz+i6IuvP6Loi6896Rdus1p+yom1V689GRYPEF8yNhWXVZ7GsJ6RvhaX03uh6xZ4Qg/a97PTnXr1Ou9XrVLV6JW71St2RoeHWp113jtirzhH77hxx4Ba0Q13Q3PI17pYvXdFWja5oa1jRdPGaclmUWNJ0/ZIVbRMrmnzcwprG0hlIvqJ05u0T/+dc5ebUPPc7rVSndaU65VaqRFeqVA8pDbccLei5ZdGdW5b03LKsS9dVV3EuVeO6VOnadUPXrpdV0O1VrTPXqmm3Vs2oCJpUOXSqamQXo8pkJrsqE9fhN8eNuduAlNDamII5wExxjeEXj0BU44UA8++wg7eGZ6Mt/V3peAGB4SeapM9GO218eDZa09+9lo2L1agPVhS5RDHsJHevQWGYytL4lnT/MN5ML5nVMfQIvlwyK577f4roPur0L5k1ca/CfM7Xi3sF7lWFqhEGiL6yiiE3miQDZU8pXbJOQNlXSg+UA1AOlGJBOQTlUCkLZA6AcqSURVBWGqVqubOTwXMBZVUpy6CsgbKmlKvk1oCyrpRroJSglEq5TmYRKBtKuUGgdVA2lfIyrbGBsqWUV8nmAWVbKbdpeA2UHaUIB2gXpF0lrZK0B9KektZI2gdpX0nrJB2AdKCkkqRDkA4bDr2IrQTSkZI2SVqBrOhKU7q8+0dE4X/P1G+BHEOjnQeYgQeFqJsToAEPTKOqH6AJHpgGyrPWlBBHD0wDIXY1xEr0oDRaSKMlIVYfFGIXIXZbbigL0GYuEhZRngpWkqgorBhRRtiGHRJ2lOgqLItSQpDXbH2Pw39T0Ms7imLerNHM+dvS34b+pi85C0yHH6Qoe0k2ByV6SwLqUXi3JHICnO2SCyVFfGvZ104lhztWqhxXBJ30P5rHQLaL79QYqATtUlaktovROdkUlixWV7XTanRudt2XqxC253yJRLW9LDlXIsJ9wdlzQa+5oKvYgwb6UotpxMCcz9YFvu4CrzEwZwl2qQFhPobMZJPxOOsXXLwbVXmqeLuMx4wNzOfpyy/mJhPgIrHoEnjZJVBWCexVCawxARbGQN5W2qsGVIPufFrDmuYwh1j7bTBfae4fftZGRDtN5VdU1ZudKvh/uXzv+S/79g99zQfOLW7DxCHU3PEWHY2gpgKJVdJp+OlEVTqrP1yls8x03GBLR9JJMfQ0nbROJ+2IJcGYmoAxD1jAFoi4jsmyIbjz24YfGjZ9vhN9x1d8+n/8tR9kH61Qzb7hvT5hp6vsQ322g9dTmDW/ENio8+sdE99tYfc7TG/lqZjqsEn3mk2LJcichd0/jFfxYql/yRzgRd5cMvv6+6mUn3awIe2J+wDunxT3Pty7qTWUUuGgLwW3J1XxDBGWp59CFA4NL1U5Bzki03+dI7YUPB/IsHAkloLqA0kWDqxSsH0gz8IjdCkIP5BqoUxIKTg/lG3h4bkUuB8KuPDsXArqD6VceHQuBfyHoi48OZeCAUR5Fx6cS4ECSrnUGycyT8ImCSIzT8JWKKfmUvGBUvaqqaXmSdoJVXhF0YJSzilTy82TtBeqLAiPwSTth3JkLnkKJukglBNqKcC2WHO7f8SmxXYEyUGFOebr0Xaad9g0aT5Gf5KP05/kE/TH+ST9cd6lP8rrh1nvjfbmPIGBui/J76T+TujvuP6O6W9nZAFucyUlfGebS+mKOMdBTeicAFWclFSM6aRwoDinSkInB0S+Y027fzQzMqJDG3eftqkwizEuB4JsHPG2/US0PBB8Y9xnOS4HgnIc8Uj7RHRtIFjHuNlyXA4E8Ri3W47LgeAe43rLcTkQ9GO+zhlZ8tsCz9SEkF6k9CbXOSMrf0cCdCvDotwFNMBVrIMcDNEQtzOErB8XuQloyGsu5CquFHSV0RD3N8SxFcgZ9wKNc93FWavi7OAOQtdGNMRVD7EXgI/T1NgLLvaNqmxV7N0q9iquMHRtwvqHpLOomJ6BbAyazssunbJKZ69KZ61KZwdXIbq2qqfiFK+0IgoJPZoGXdCwadEFzYGELmjhxCpPHtqILmjupCoESSiatTSm6M9OKlI326kI22ylImOzmYpozUYqEjVlKoI062nWlW2eVyVeN3cjrtgUo1njAWlXHl/XEn6YFsglIqYpehpBmQDPVgqymmKo1ZsfU0mw4k97M/DYii+wt5AVxfreWYtMdDe9w5UwKZZeqYZhKMOTgAcRhqeOPuVEDXgMjoZiFTzyhicvEBrgKjfxUIZnU0L2/JA9F/KaC7mKazFdpcAlII7141gX57qLs1bFkVMKT9pubkUYnnXsBRf7RlW2KvZuFVvOKjyeuykYYXjWjbPo0nnZpVNW6exV6axV6ciRhaKvMjxVPDzVK7URsNzTnc+Mm/G7iZotHbtQn2YPf5BT/14+RRaBIXx8045Z+gE/MYPlSf3AlpjF8qR+gE+QKad+dO4Ud8ziwPSzCbELfHgmTwWfjdBbbfzcyicJvPWVr/F9s9eHmJrKrkD6nGoxTWpQ5DFmcGwbfCyeHtZiwbjZNF9/5+8RsLYiQm7lie2IIH2bWiXRx/KoypA54unTRn0Mn2nfuopf9HGzbCdfoL3yCI/nUn5a8T1Wh6ytUGLtqg5JsXPOL+mMV9Kk2D2HMjZYI/c5OVYRBQ3Tiow/qCLIoq7IzOepIofn/YrMjlTk6Pyxisz+jiqCLOqKzH6eKrKe+RXpjlSkzI5VpPs7qgiyqCvS/TxVZDv3KzI1UpGd/FhFpt61IoQgO14T5FHXZMqvSSV2FvFtXFfGaTlu5KosGFH8Rr/N2Iq6etYzmF5R12pqt6au19SpmiqSUxM0z2LHsLEQVttXn+0q9LanQdtVeG5PibarEN6eHm1XYb49VdoJvHV2bZWHU6n18nBatV4eTrHWy8Pp1np5OPXaCSJt13k4NVsvD6dp6+XhlG29PJy+rZeHU7mdwEOKl4dTvfXyqLVvvVxqBVwvn1oH18upVsOdwEONl5e7VYzk5u4VI7m5m8VIblsgbh3LbTsUzsmYWIn8psSYu8/ckY1SRGO3jYjDbhkRgd00Iva6YUTUtTQi3rpuMkXlFjHWVSOiqytGxFWPQhFRPQwFq+NAsTr2Q8Hq2AuB1UH8kHlFAjmjmB4j6ByboaBzbIRA5yCGXCbtJpAca6FAcqwqJMdKKJAct4HIAQy5R9nFAn1yQ5BPrgvwyTXBPbkqsCfLQD0BhhxhThYF5WQBaq54iiDWSQ9ojdB0IOJJUwBPguwL5JWHsn2RvQg1RB7pQgWVYrpNwHEwo25OhhHz7uXNoWVhYKittCzeAkzrsbyLeafGc/8CsPXfB4bUe4Xl9B4w858hJx+ndvu07dQA8o8i9CMI/bCEvoDQDzF0jtCZCw0Ff4vQ5xH6nIQ+i9BnGHoeoU+70MBxP4XQfF04KaFPIPQcQ88i9IwLDaz2aYSeQmiVn5hE6AmGBgQyIIsdHruqWfJ01vlkGEZ3bdD9EHVnZanF2hZyfQ2wVsTFUbvPBbeynhIX5VhfpXNo+nG876QQ4D2c6DsDIfCud/vObgfBPaf6zpwGvAfT9O6rd22W3s1YvFtz9K4k4t0/Qe9u4h0z26p9NEUdnH/XMDN3ortc0E5WeBB4gz4pD1pzgutA0XBj5wTXgcLj9AHXgeLl9AHXgQLo9AHXgSLq9IFBRSF2+o4cPgN9hw6fgb4Dh89AH3AdKExP355Da6Bv16E10Lfj0Browysfpfrp23LYDfThpZC6AfThLZHqAyfRQif1BT+QR5KQuA7GRkMfkd+ogKwD5DcYUB4ev8HY8l5zDV7qvadcg/FWgfHD3/JNaVpcFqh5oTZpjZraXFZ7tAZyboHbeOAfp/+aqtjgLkztj1Jebvk4GLitBn4xGyj7DPxT9MsmA/80/bK5wD8zFB0V7iy1ZGoohkTFzsQxPIbZIshOsrhuLFEY+4Q9IacGb8QN2cI8GMxRPFsDoZ2VuuVTE0fd9qmpo+741Iaj7vrUpqPu+dSWo+771LajHvjUjqMe+tQxRz3yqeOOCjyGijrhqKs+ddJR13xq11HXfeqUo5Y+ddpRgccwhyEuPUiqP8g73x+bCQFD2J1Xm8zd5XyMls+btcY49eM3w1dyQzo4wKafw14jD5y3un89zJpFaKNbPP02aD4NqtDZBJQeXwNGCxTFgWjdiiRx24L+fKxq7jDUFrwJZJfMWNwym5aMNkhMuWk3Ab3uqJgVoAamYWxDo9uuo8S1gn1an6ebqnmeuhhtFyP2LSC3K3Y0Nb+dIrcY5VM9cA/Ah4XLp+y4h1f8weGI7PbUW/eyLlolZt06RfRa3n6HGqQiOh+wqJnRvce2pRBRMX2rMH/gAXGB9R27uDGO0iOpxWDKHKP0jsUyRezVdxQ9QAaD6KgCu2F3Hiyjsc7fjEx8d86xjOZgfBql4dYmGpPrwD+m6EymBrqytojZAH4HR6IxyuMAqAdHoglK7WC44EjU5Z4J8B8ciaZpPSyboVxQNkteajZHFmt2QvQiT4ouZk+UP0+RfZudJqcmm0cXqPCLGusGFDkXJrJy5ofC7j0twtBdYH+Rv9sbCl/3JCULyNI9MRRW7pyEXcJdF6XDMonC2mkRWUD5sbRGKl3F6mEtRm2xRqPykG6WsLexrLN5sN6zvcjakyaknLtyqeT8IFIUZTkCB+Hha1BwpbNRdVNcJK9wR6zr/bu0pxL2VFL3VPKfT0/5neO6TXrqf07NE3eSu3qpOKWXitN6qZjXS8UZvVSclUvFOblUnJdLhZVLRSaXilwuFQ/JpeKCXCoelkvFI3KpeFQuFQtyqXhMLhWPy6XiCblUPCmXiqc40Rcx0Z/B2fc9Yo7enoKSa2RPU3HZzkOdNbJnhoTNOjsklta5IQG2zkNLNbJ2SPCtbEhErnxImK6HhsTuujAkoNfDQ6J8PTIk9NejQ+KBLUCXFCBEGFP2ceiNAmYIY8o+CRBoAAllvSIkwBlOd0/bZ9zaTpCzp2UUXVS45RiAnfaiwi0nfH69qHDLsGhLH+GW8fBLH+GWaQYRPsAtt8DTgQdwy23bEQ/gljswug0P4JbHYGsbHsAtj8PENjyAW56AZW14ALc8CYPa8ABuGRYc6AHc8pSdFg/glqftjHgWFDWaHqug0fT0FDOanq5CRtPTVMRoegIiRj+NYfh0Jdb1nn5+0ca861+EnvQ6flOyCi5CYXoVv00yGS5C0ei2vQitqFftRShLvWwvWgoIXrSUSL4I7fFr9iJM3F61F20Xh9iLdgpn24swJbdoLwLhecFeBMCztReB79yzFwHv3LUXgXfTtBcB7hzYRZR0USfML0M17YT/UI03KD7nfbHo0rXwhmMvO2W7Bry9y04brwlv97JT12vD25Rnnsg9+ODVAGMHKXf/INQaYaFCMB2ymGPGwMiA6NVhi+U5q82zBGEcBsL3bqq/OxAbFA319wZiYrOlfgs/jlEKNNXAqt2WmjX8hbujC/eYLtzjunBP6MI9KQt3VxbuKVm4p2XhnpGFe1YW7jlZuE/Iwn1SFu6eLNynZOE+LQv3vCzcZ2ThPisL9zlZuM8XQRZy5oVi6DiH0JoNi+QVOankLYW/ojJf6Vm8OK8dV6/yuPdHHKuWuXRx+Y/ISmIZLJdilmphaFnIxWFpWeglsAEiCkuwSldljWctr8ESXyR26tgItFMXUdSVTfQqE2ajQWJe2hLcgUjWArAIIpFeHZMOAMhm5CzUleUgt4Ju0upbK1I/IZ8fdXLRRiExWuQRqTbBIVahiRmkRv9kk9BXus5fT8ziHXNXmWMtZY61lTnWUebYmDLHxpU5NqHMsUlljnWVOTalzLFpZY7NKHNsVpljc8ocO6HMsZPKHOspc+yUMsdOK3NsXpljZ5Q5dlb3sXO6j53XfczqPpbpPpbLPvaQ7GMXZB97WPaxR2Qfe1T2sQXZxx6Tfexx2ceekH3sSdnHnpJ97KLsY0/LPrYo+9gzso+9h2eL9wlDzIIh8T4yyt7LXYJQq7jVQmMHrm6eoNM7cPfAMmvDZfMGAFbfC95YU3hFYB3PglEwA+4AeEy0/KdcJvKYlKcUYtxi0MZgWjHcSYQ7gXBzLhy41hDEAgA/ZkMiXLAUE6GBWdB0/K/QPoJwDyPcBQn3EMLlCJe5cOCVP4lwTyDc4xLuMYRbQLhHXTiw2d+DcM8g3KKEexrhLiLcUy4c2jDs5+9T3tj/h4NzUwfnhg7O/0SHp71QBuZuKCNzJ5ShuR3K2NwK/0MH5+jQBJSmDE379uqnY5Mi1jI07aPitHmDR1gZnOBqOrTQp4Y2pkmQhIfn1C6M6mA6lNGLCJcznGh9PsZw006h06GTPo1wDzHcGYZ7nOFmnHaoQzVdRLgLDHeW4Z5guFmGGx9WaKjPINzDDHeO4U56iqQTwwpF9T0I9wjDnWe4HsOdYLjJoT84qWnX+YtxGN7Fuzb+5SFcMVyU9x99mwgofOW9TJC0I5BjIO0oaVcgx0DaVdKeQI6F1EYW0r5AjoG0r6QDgRwD6UBJhwI5BtKhko4EcgykIyWtiBk548ROA8oncMKUtBwtJr7EqBxIa0paF9tyIK0rqRQTcyCVStowMjlLWpUmadPIvC1pXJqkLSNTuqSNaWkvI7PdScYGlHLgQlDScLC0lxGU8JKGp6W9jGCWlzQ4Ju1lBAG9pBlqaS8jkOoldX+lvYxgtJfUGZb2MgL6XlLXWNorEgFiCu92frEZjt+xQREUPxR1vznMAJ3JBxEzCnkYWPNWTu67B4tg7oFEdWixsDuEakTTqpiLGQrjVyzsDoXrKxZ2h8LyFQO7QwU1oIHdIaclRd/B53yncizfX441LcdVMp3Jic5jyDxRueCqfLwm8tY9oSfCGRaZeXl+Iz0VDrFIzou5ZNJbwikW+XnypoXe5sskb77IOzfWDAeCGvFOFUDQ4zVY1xqsMple3pTUIEFDIwrawNQCEsGehit06r53VCNIRHcarvAt931MtYNEJKfhKtF23408ZopSIUV2gFc10N6IjlcmeguNuz1SmeheLvbMAxU6CqguK3UaZ2GRYgcpWhGS2tEiQQSuLjJCjblQEwLdoBJE43XBEcq4UPGzut6sGC1+SlGkDuWLIAT+jpWAjfCRSiQ0xB6oxFMgGwfrMs7ipSwe0p2glFPCgYagKtzkFTJlITtsSA2bPKur0rYraouCUWOU45ug5J4MofR4gdO3MES3Rwqc3kNDbrpWZ4EX89S1ZptpkxdPMAE3pBqieiOLaKSt1RbpQo5idrwOggePaJjcgxCpG9nR6MiG2fqODTqH0eh2w9no7TmQF70mcIe03Qh50eviv8F3moGIBHD2BSIv+rL4X+U7zUCEAai5gneagQgBVPNyJRyoCEA1x1ZBWlXSmuwUIK0paV12CpDWlVTKTgFSqSSxIrkB0oaSNmWnAGlTSVuyU4C0paRt3VkHuqdW02UHpB0l7erOOtA9VWYAd9aB7qncTWVnHeieyt1UdtaB7qncTWVnHeieyt1UdtaB7qkyebizDnRPrWbAKkirSlozsrMOdE/lbio7K9rL3Nfjfmf7oiC0RejJgaCzfSEQdLYvAYLO9sU/0Nm+2Af7elTog309KvLBvh4V+GBfj4p7sK9H5TzY16NSHuzrURmP/z+eojqfGA+fviOckhmnnyxckgXhtVhFjRSeCR+AcNBPhHWSyum/Kaf/lpz+23JP6Mg9YUzuCeNy85iQm8ckZT/lHrQo4sRN4d/0gC8j6DTgdRVBsRkpmMS0PTHIT8jb9ZxtDKAQi7OLj+o2aWft1CCf5YI8NyzfVJ3ZcR+tzs5yg5HPeBlu+zh4/NrUrziFTPrIdDzuT9gTw8GbqnY75oPe8XNHP1MjuOXj6ellQT5fG8kZtm4FMcamlJDOa5y4YT6FdX0c38eGRIkpoX8zPcxPlR4mZIYSeLLSAIJEnBbi4MKbp4hzcuDFwQWp6+G+DSGx5/nigZ1CiHk07gxYSKeR0Jkyf4gttBONVmMaOZwd5Be4eefn/PLRHM4UdKOhp9AY5r2BPVPmj7AIJ238diXBmJpXizMdyep8mT/KrNaPZXUK4b3kFyT5uLTJwJ4v88eYbs/Gfn0fZ1KE32mjLAPbK1GIJxD5rNd2VIe1ftSzTC9Bvklp2yhnC+VsSjlnyvw0E9+SxGN7khU6X+bzSPwUlN4XUbaZMn+SaVl7zs/gHKOvSvQEZYtLBJ5C9JNe2RI/ltVi9XziU0wK2w5616ZvDvNn0CNvDvP3+G12cciSxsBxR0ljZFWNhhWq6tlTZWlnBnk6LMs39biKDBdZuAQp9GpUw5VhPm2ny9KeGcDO0bh9xl7wczwlqdxgIg0vVgOQTCjFAGyptn3PaLyTtGJkn2Zv9SQRiJm0YHlpjBf9SStjcjci/WHQHyFdBlAp9AXQHyNdRgMRm1ow+zHGq/2klY7cFvq82B4CXXpoTehToFvSpbmxpdtJMB5axMqx2mLrQk9AnxaLTKS/THJDrTWNWa0VkVxRqw5rNaG12otIf1isS4EutdoQ+gLoj5EutSJYVRO16rBWE1qrHaHPg/4k6VKrdaFPiekp0KVWOJV4AJRYB05gJZwbDkqHvjYhJp9ixNVKE7+gM7LunkAXarRViZYg2jSiaZtAcqc5sh6fwGDQWNcZqYFItG+lLQZ20+yzUbfzA8ZEdxP3mr84ogBSmndRANkw76IAsuyUIzbNuyiAVKoit50WxZZ5F/2PSmdkpdK82Kw0L7aNr/9R12nhPu2RWuNkq4p9ENZ6Gw/W1ihFW+OzsWncNXeEBJxy4tVCyCWL8ZjjIbdSmK2RRzYGmCctzgMAUGRsxCy4jwNojQ2ckYPOPVhGbqseStjPGgaSNrTFYChKzvT0MYoan3ivbVZWEtpO/Nog77kXxwPK7RTha5KRs5GgumkYaXXkhEYSJH7UzwLKpLxIQwteVNfE7xAVtaHhlOM5RQ8MHmhJRTClIY5ilsbgU8m4TqvBQ1TdJJQ6asKIvBiQsJGYRGmztQnw2fSsc3g2WoYDNHRahFK9NkUQCJ/pRwg8aaMBg5jPGQTqYsB/Lma1OlqSqt/v1Vu0NwbmRSsu7ONpvQhvZYGNxgMnliR2MTvfDeGB+Hez8MDThflY9gye5YEK+btWeGBRhQcWjwkPLP6e8MCDhQf0ST7WJdEJWfwuFSBQUQcRIPihKKT0cyACRtDLiShDmMsmM6ytVUQCxSCkpkrAE4NBSF0VXCfWgpB6Kp1ORAUhWRVBJ1iCkEQIOBL4AyGJHDBJS0oSUWCSlpUk0sCR4D8ISQSCI8F5EJJwHiJBcxCSMB8iAWoQkvAfIoFeEJKwIEh6VUnChSDptpKEEREJKoHSHC8iUpiJUEWkSgXKFTwJoTqORKRoEaGKTglTIlIIiFDlqIQvMSLetpKYVGRY7a08uhBY81QQQBTxRbimiujF17IESo2wuPOzwSv9Ynsl7CNMo4hu5c3is+FrhaGloRewGwKx/6ngt34uGQ8otQllyJ9LbPhF49xVt36+wvZevpnFleVbBQcNngp+8+eSiSgIDTiBVdwEhemOx2NJTX3Rxq+NR2OxRxmHVhcL9CXxsiuH6UhkMxY5F+TGvmw8hCnL5AWi4y6Yg59L8rhY4pbOGqdF/OI422OGdUlsOg7xA1bFPBXMvZChNE8Fn/25BGKBT0RNaBy3EPUFhkxusTD/LvwD40ElrZG1wa+usEv2r6jpjn9z5fl/+GP4+40ryOTFeWEoDe8ltt0hjkWrY1teP+yuhJQDIW/l5xPlGYFD8/NJWWMhe6jCyzfnBy+N04DaY8Hk5eAkXaZ52XTFFVw2tE9RhECm+LmEbmJzFxv/KOkDPAlHir8Dd/SYiS/T+z3qHRPv96t3Vrw/TO9CMH8pIAg4vC1q0OE8eiHofNqEjTujBhtuioL4unn+PI2ZPLR8L1e2kkdRPqNHiYRB5VEEdyf0KImwujxKKvwwj1KzITyOxM35vAHmgVgcoeURmNhIbs5DDtvGxMgxNro5D5F+a27O55x51GCvnAtwvTnMQ++GKcrufAuyYVmKDvyId2vUuz3q3Rn17tZeZ3jjzPK9xIadzr8+bZK7c5jt+w2FJgGbNSbiM4cVFCt1gjflUCiSVpHobiyYeJSCqifF5nkFuPYApoqNBiXGbFJs6edGZbuo2Kw+bt//cavRzyXhnTphfqTdtR9ZCfsLJsCJtIl9M4Stm/3QzeSmu+REEsNosMAFI9I6zSJt/J/J2xMpELwOAJ/CphFoJc0PiVYqg7r2KTbO97vPdlRwoQXI8lC2u6xjU+HPEtxHbk2wVNMZChwGM8jNJbPXIKQG0U6GXJIJ/fKTDQbabgDihe5L5seEtgfaTgPAMI1+nlR88gT9Ud0WhyIIUN0JhyJAUF34hiJ4UKnwD0VgwfkX5UW18i8NRXvT+ZeHorrp/FeHorfp/NeGwqR3/utDYdI7/42hMOmd/+WhMOmd/9WhMOmd//ZQmPTOv4LGIo/eUVZBWfUpa6Cs+ZR1UNZ9imv0mrIByoZP2QRl06dsgbLlU7ZB2fYpO6DssFse1EG7+LzrR9gDZc+n7IOy71MOQDnwKYegHPqUI1COfMoK7ttk0FeNBcqqT1kDZc2nrIOy7lNKUEqfsgHKhk/ZBGXTp2yBsuVTtkHZ9inkCOz4lF1Qdn3KHih7PmUflH2fcgDKgU85BOXQpxyBcuRTVoAeQUyyuIbpoIjCO3TeGj6v+RHWQVn3KSUopU/ZAGXDp2yCsulTCGSx5VO2Qdn2KTug7PiUXVB2fcoeKHs+ZR+UfZ9yAMqBTzkE5dCnHIFy5FNW4iGBgLzGAmXVp6yBsuZT1kFZ9yklKKVP2QBlw6dsgrLpU7ZA2fIp26Bs+5QdUHbi452XuMbC511EcJQ9UPZ8yj4o+z7lAJQDn3IIyqFPOQLlyKesJENiKdWUVVBWfcoaKGs+ZR2UdZ9SglL6lA1QNnzKJiibPmULlC2fsg3Ktk/ZAWXHp+yCsutT9kDZ8yn7oOz7lANQDnzKISiHPuUIlCOfspIOiUDltQ8oqz5lDZQ1n7IOynpKyYe8JdBh+dyQp2kCi+UnwNpoCexYfhIMjpaAkuU9sDnouZ2fAq+D7lfz02B40P1yPg+uB9038jNgfdB9PT8L/gfd1/LZYTbDi8As9fDkZJAUuzg2xTQuENoZxZB2R5k9UqePUfdJnTpGPSC1e4x6SOrkMepRIOK3o9QVikqPH6Oukjp2jLpGaucYdV105hTUMChHdJ/jutLC2claNJeb2lkcvMa4WA6E25zas7zyD3AQAvrXGV73B5A7wsPQPK/6A4gZAfvrNK/5AwBpAfrrFK/4A8jyAPmLGIyLAwBcAfjrJK/2AwDxLNnUnuC1fgAcHoAAzvFKPwCsz1UUq5vHlGqqKxRTiilvs4DkRcRgHgFTMXasiBgcpCGsEztOBMzpAeqLJSUjIgYvaZhPsLCi7w6G0jCfZHnJhoCeIDCDWGRyIWKwlob5FEtNJkQM/hJer+JKKXnBzFLhE6pcDRlkYK+EHnslGkH7UKRLH+1DIS59tA+FsvTRPhSw0kf7UCxKH+hD0SV9oA+yV6IRoA+yV6IRoA+yVyIP6GNEkz6l4Rob0c4d6hxqncNqYsmUGuk78dc9J/6638Rf95r46z4Tf91j4q/7S/x1b4m/7ivxj1bnxXEc472JEXSoe7Df+D3dg9/TPfhdqnsgutHNoNic6N4IOu8Lw7tFsxvkYfevQvPol36dHJ+wiPs26P41kH7yM0r6jc+ERdwNg853pSa5OwmewmZ4KzcXApj4+Zp/Bk5guGBW/lkI3IgiumSAGhoWR5/C89Ul8z76Vn8GWuWXDBBGo0vmSeAQXDLAHzWwr3fJEJhT3bN0boA51aVzoX/JjNG1DiKMDjX73S/lF4nUPU0aKd2XYKnrU6EatAqLo38a9iu5of1PhTIPD/9pSBtEYXEoYfNahgdGVW993/O/+W2/9uN/6EuvXRl6IOaNSpLxWzym0UvzlC5oDGmkVcm9ZRfx4nbFormwXA4BxVys/AxzteODfGqoiBgtKBjYFuQaFDOjAxUB2xnkMyKvT7EmBAPw5DBvdr8dKsjN7pshAT6wZuazRLLMafO2WQE9H16xzUE+Psy7w3xOUVXBtMhxTuq+vZcpfOuknRgITCuOWePDfAL73BhZHQOFXp2zswPBdhUcUUC2Nm3Hjr+d3tCBseIJh9oIL9MzBm0LQsa6QaKjQ8eDdv5i7VzgK2ivn4eXDCFZw0vmW2ScrGEclGE1Or4prMcMhhIGSvemrfl6h1dsY0ARECV8aHk40q12auiM404PRXICKhoiR9LQ5uZvcyhCXfR0hyqGRV9P+BQG6BwXgs5XRzRcqXcVI2y1UAUeOX9igg0JCorwciilK2yaUiF/A76ouHC2DrdUh2tKuG4dbqEOt1yH60o4kUuo87V1vkvDUqGDXb7NOl9b5yvhrJdvs87X1vlKuAUv326d70Kd7/KwVAhil2+3znehzlfCLXn5dut8F+p8Jdxy56fSqHEnuRt+pagxJM4+jGCEC64TFc/fquSYNz/4UoyHijtm2TbeyI1N38gjm7wBTVjBtXYM4AdYIgwCCO+P2H4eZs3nP8u/X72bOfsm8ai0f1SFuDluTltTe18Yr6FkgMaD5wxjzUe8HLOIjx5ZhG8RAgGqGijc8VCYxEnlSp2rLMssxltq/NYQoCFm1PAKrIfn0Q8891n3F3z1c1+lVhI/G/wxjq438ng0wEoV4LpIEti4BHc1/oF84jm7+q15q1hZ2f5sdMtOfGs+9jqDdP9qiCCt4tyfKcxr+biNXOB2cf7PvJ51YDGxQAaN1/K2nfhWRCO7t1OYWxMmCKPO872nnv9j/zZrLY/V7u0x49z/5oqN/pZtuURaduz1F8bD0waiJyhP48UYedAJPnOniD5W7D6O9blOUBJxoRhzxfZt+0tee2HcnDZ3AJJYj4G2fm59eBx4IJGN773R/athJ3MG8joTURyE6K83x+K6AjZ6vvHHZ9/7yN8afH85QK96/qpmJfqZhTx8XGxjdmzUwdguK6WawJo3rRm1VPzSfA7x+6DSz7nna+fcezbqTnbEwlJz1CZmINSerfVwIQ3177/ANesJ3/1cC1yznvDdz7XANesJ371vges9cIFbuG+B6z1wgVu4b4HrPXCBW7hvgVus8136XAvcYp3v0uda4BbrfJfuX+A+nYTRXXnYxakMHWX0pys/ODB1AVUT4ExnpH+NDeSoJae372OTAMLmH40Tl7MIux8Vwq/MAAPzU2G/+9/IgNr9VFiF/tYJLzTvId7HHzvtfawWsXqShE8F3/upcL4K/xPvFr5Y+xQfreoon5r1S7v1GxgexQZ/7lWBvnbsXcux6Zfjq7vvVo7vOl6OT554tyj/y/Eo6+13i/Ldx6PsTr9blO85HuV764KZZWueDGaK4CrE2IomT9V4SAOug4CzmqL5/mCGMSG5FhbrvxL08b7/3L/+8X/0w//qO775f7t4OYDIWPD+QGzNNvvdl83dkYQTl7CkmLgUO3lYbJx7KgjeH8Q2LL7l3EIQXGKpg/cHCQ11ITU/rQXT7H4nU+Ej8s+3wqaO9aa8ao5BcAgDu2ubunAtGAondLAJF72PFb0vL4KreYr327D7t8O8hYv8qx+OCeEsknBJ0f5DxNOKUdYmak8RuKTo9otXX8s73W9MsgRnXCzrK7dfZ342wWWkaeNLZqxjYwCC2Ta0seZtLDBQlJVjUyFNIKl37yWnlYm2YLpZYmPUIYbw0yXTQ5o2vlVEX37JzOL0wacJ/DRR3hjo7E1M79g2aSh7wQQoQyJTW1sAwfAuP0Zo3Nn+JROjMqxWrNsPUw7xE+TJrWL2T+cdIn8V//CN7/6F4MM0s4FsrXxsFeHH8jbeM//AfPFjCGJbxS/82Bvv/fC8i/Ml4IwUs6/kre43JjBGUMy+AsHFmAIH4BQSdKujRY5lnepIyRlsDEVu2XafD66z/YwChS+OGxsSlSotZm8hQfz8e6YaWwGJaNgWgjVs+5KJYT+Et1ybCFxaWMzewn22aN16MghkCEJBiUMwzkKXTMcmWTgWdbr/ddAp7s3hTv3AlDs2jJdtiOgd26xGddONao6DoBhDhcHBzFJMUcLFkQeYx7fyhkApN4roy/PEtjBdI/zEucE4+YM4C+E6jZDRl+Oc+sWYOFlgQ53SGfmGmmp0Kw+L4PdTjjWygGexIad6C/tBbJmdgYSacLnyRv8WESHx2NK4lTcEWi3kO77gdjT7WWgb6IWGhYgQoOBwV4ttEovQWPTlAMBDit1vCnkYupXjHd/S9FX3m3AAZC1aPDugXjCHHnKyGQxGCDkFt/KoMF8Og0YchjjNQS70CKe6D8/nIeQ6JcqXYMwU0ce635gkRYDDMDQZg1t5W8oCQLtGcfs1SCA3WE92e/SxLHn75MbmoS6Im8UNVBGILITDTHW0kK3ptUEqoHJG4fCwLjRdU7QwvwMLIzscTmNmZPQ0ub5NdrqTQedPh9Fds1wsdL8jzLGoxLoIRUV8C7IoSCcaDztF3A3yqPv3EhsVe78eFgnYNJZmggKRxTO0MdkUV1eVrzEQuh/lExoK8smnzcTd95Gv09ATxIL5+j+BlRGWno9gbq17DuBBaD5IjhU7UT8fE9ud/FmQHys/Pfnpyg8YGi7BPCp2/v4pwYDtEeR713ktvXvOu0DvvvMu2ramJbm2n3vrL3/n//CX/vH//VeWkVEb1knaRQ+G4dZ/NoB0YlDs7gd92+6eR/7Fyj4YCsizTXM8Zxg8i1HrRCRkIrJsiYyzbgTd5yAUXB+yTiOVDCYi0FnRYDsnGLSZmNE1mSXqLBintDme5Yox9LAACD0iCm+PMk2TLTBNkz0mdrqzx8UqZvaEIBI9KXBDT4nW2kUmZbKnxQZ5tiiiftkzglv0HgEleq+ozb2PKZnsC/B7FGaXxJZ5dlmxkJYE5ehZUcx7v6jcfYApmuyDgrObfaHYRM8+pMBJVwQTaVnU9QpR13uONTXZ7+PyDLtdHbJqW/YDsOwlcvtELx/a9+OVbxE6O8/CdQN8r9IuwQ2roUN7Gc5tvPeV9hLch3juA4AyCgYWmNwEWvY56LIV0OtYpi1DewWQdR8iBsYXQqHjg3bG8UBb9n0I/V6Efo+EfgahBe7uaYT+fS403gYvIvRTCP2khH4CoR9n6McQesGF7tmWfRShH0HohyV0jtAZQ1uEPu9CW9uy5xD6LEKfkdDzCH2KoU8idM+FXrDcjzuqQ0H5/9Xo+T8/+51f9LNf8TVXSsowiO2hEeq2Uo9GqEdK3Yx96mYs1IMR6oFSy8Snlol1WznhvLi9FnsGXZ1ybhOYq3qNTymghdccdD3RBRNnqY0KZ4QOTJyJthIsTwcMmDhrbGUuAITbpInRtTKfFeDBQxLFolr59piR4csxJs88b4+daggQClEKsqQIhrTbWyoEoeSzQ+OXMmmspLhh7Il63BFIsavgiFOKd+iSKV0yu1UyK0aT2ayS6UoyPU3mqiZzu0pmwyWzVyWz6pLZqpLpSTJWk3GwjCthlc6mS2e/SmfNpbNdpWMlnQVN57qms1qns+XSOajSWXfp7FTpLFCAbTUi/75yNmtnt3ZC1ScqwmwSMrQYMa1qxHTwsgxnNx9X4qw8N38pVUxaYrwhgXWUSHHSOn1Giuy4EuK+RAghgsub728vZO+3HdL+tkMu9PNElHVcyERDxgLwxpATRfLhbNJOYMpPFOmLjDxRpK/kUt3PncJHcN6AlY3i7pdBhWecCHl7Ju/a7gD/falQ9u+jHNxHObyPcnQfZSUapUi/dm2ePBXsGmQvC3ZX0HT3DN7FMfvzafxsmHwKz26EsZkGaPNQPiznU/jZNPmsnZXiWUbs5ieGAzGLMZQwt/NZ/GwZQDdLuSVoL58ZDiyTu5oD1WUW+M9DCb4Z5nPcY0x+Eg96xMNhNJufctGu5fPMLKFQyZnhAM8dSIJRD8L8JH53TH4Wb30EyWASC/k5l8T1/LxLYjXMLUuB0ob51HBgT0LZcIiHGFScAenEtzOoo7VCgKI4zJEM7DzJ54U8NxzYE9Qin+HHU/x4Tj6egBL7jJ1Bx8zZuco9a2crN7SSnXvaTldudqq6x6A4AnNIs2IlaU6MJ1E9fgy6JQt2DEol0McsNhNgHbchw3JBGUxbifxu6++e/u7r7yZ+PQ7jhtJ3j9F3jvkPkmi5+9WhbRY70J/B3pFxC+lls9wfsjmaW0uyeVprTrIzNIGWZGdpPi3JTtL8WZKdow3pJOvRCFqSnafJtSQ7RXtRSUbOn6V0dFH+TMAnwunum2E+UzPuZwY5LOZtAi54uvvt4YhO/QlPVf7tYVvm2bNRiZBTCjSwAc8JSkkZm1HuyYwYIxsy9aOEcaYHlJ4y6HUa9V6jh4JYfFM7jAlaDPtdl8wv0XPJ/PNYXsYSiPp77n1xb8HQ5Eajdn+LuNcgiVyKez/GC5u4N0Bfx8VgvYEXNmb89fLtEOmueml9jUdf8dLa8NwPyI9xH5QfWCbkNJNrojKb8YK5qliYIvVCprDIsdRM5kQFZ1w4W4dbqsM1JVy3DrdQh1uuw3UlXKBQmy5fW+frmMx1vr06X1vn65jMdb69Ol9b5+uYzHW+i3W+S3W+jslc57tY57tU5+uYzHW+i3W+S3W+ymSWUSN9VuyIID0f3JsU0ojtadu15wEaegryEYQdzU+LnM5DwF7Ap3P4RPvh+UMi0nPBzltCls7iVDzHTxcEaH0r7Uum3dNqpD4VMR9M6lQkfDCPUxHuwdRNUXEgg+ZNAbQTFvrWDQr04i15ez+QC+W6+HecHyaAmaXcGyFO4PKEwV+X6aa6keuWupHtdlQrNxW7ES/u2Abdzb2Jm3skN/cmPoTFPxi3IsdQbMOOaLHU/aiN5EpeFwzSUq7Q2SyDi6rL1g0tKbjde/8y1BtWUBwobV9oMFhRrPys0A6ENu1OxbGdhY2hYk/iANk1KA6dB/goqxLTnX8ho4UI+36EIz/Cmh+hCx6vjBO+HGi5n4jW/sSgetDZRk3W/ymjDarnmx1Qy4ras2HxqYk6JRjsiyQJ2OqLJR7M9MXysgPrXDEFdIrfmJd4fwp6Z8XRLwdgj6u++N4vB301aAnvrvN2ZXQ4r/CxhbdhhLchjyhgkH/DnCtXWHzDtG2QxdH9U1BeLw6EgfGWFLVRrH3c+bv0b1X+Hv37lR8lf6OrJS/2AgypJjhmTR1SsQypJoZUjA8xOHJrHz8lPdso1j+uzJMmvaXzdund/HjFh2HELUS0/LT98YoJA+/uxysmDLx7zrskEfcREZzTN3o2Llr1KC6WtMzmncpsJIW9T1Rl3v/ESJkPPjFS5sNP+GUujj5R8Y7CYgiLiYk3h9CcK5+skguLb5ORqA9VjWLV//iZk6Mf1/yPPzzjffTkSYp1CTWQYN849qBgnopZsfvJU/o2g/A/PTua576fZzlff2wUB588BU0oMh8bxS9JMlsyiuLvc6Pr8JNV+8B79Emvfb6urWPJhsUvnxQeHofsX8GHfXrIpsuaWN+/I8wbL4xHb7fESM81tOcivj8QzEm6rvlEdFV6rUkDTl1xXZe+aj4R3ZDR1XwielkGVvOJ6FVK5BVf37Vx0ai7rvvVYRbjP3TpxhjXvodsUGzIGQz2RIp9IV+gJtpYJkqU/1U2i2T3xrIz0DyTIGdtUGxqzDnbLA6EfBLqZ+I8Z4Ni62fcetssDoWM4bwtzvNYhTXEtG0WR0I+BStV4rRYLjTElG0WK7ygZSdsXOxKiAzri4Y4bZvFqoTIC6vTJB6dJo1qmgA8J7enB3luT9tskJ+2p21+cz4/bU/gHH/CTlk74I3qxM35fArXgUF+yk4D52baTttTN+fzaTCWBnnPzthzPOLb3s35fAZXkUF+0s7ZswNepE7enM/n7AXcAy7Yrn2Idzx74eZ83sUuPcgfsrN2fsD72UM353NsILMv5c15hpu7mUfimrmZJ+KavomXN7imbuYtcZ2+mbc5CeJKb7ESmVPHrHN0naNZCVd4dmOa8zaat8k8ntxa87Y9L9z4H2/buDCYOm41KEo+CcseNNQHYtl/hsVm5du5MSxLfUXWaf0r0/40DRbM6p/I4/gOxuYnAszK76tUnYOORPmqE14UqECCs09uvQG33tTc+s8H8c/K88Hi5+P5gK6eypjYqIi9h4Svi014t4OHhJVQdcxx3ACSpUgiUuDKeAJXFGRsvJEnELDCME9egrJt0/OIJBVejtTVcK6yzOMRAJgGDrNvDfPkHrEkkntZk/GyFJbcVv+Vs1Sm5smKtYqiBsqK9YriYApauNPFAOoarwddC5fAZJC3bBOKA41hPqFIBKkdo7oBaB0FP2jbzkAADhqECM3b1D9A3HggaAUTdnygsAg04Q6cg4TBGxSnXKY/FexpS48CRxNj5pK5baOi/FfhJfMx53gF0JyXzKvyA4ACJ0kJ/ILwkvnj+CJyltfpPIDzj9HJx5JreJ4JKEWJsw7glPC7or+35edV+XlZfm7AEipFH/9eZOI75m4R8kmT587YxgMInoG7oBbRjE/oHif0jhPsccLCccLiccLVUWhSCKnnlXnvuy8pbQlwPBpjWWMXKbT9K0vgH4FCfRXxI0QSij5KXpeXBd4Na+946AnVvYQp18hSLCErad4omi8SurVBLfyVlM79QJ7MRbMm1PknKIiiTxPq/KPLihYNWkI4sGgC0Z0Ji6V+HvL4umTTYvmWDdVqRwpX93J0VVy9y9E1uBaMvWSuAy+oY9POjyah2BfdVfWFdVVf2A9VfSEU9YVXRXshEOWFJdFd2FPdhVJ1Fw5Ud2FTdRdui+pCUzQXlkVxYd+I4sKGEcWFw2OKCyuquNAVvYWrorZwYERtYdOI2sKRqi1sq9rCqtoZ7YnewjXRWzg0oriwZURzYcWMgtOvKTi9FeWF66K8cGREe2HbiPrCqhH9BT7HiQrFM6Lk8B5Rjniv1UUwUjEuI8D01IouZS1MVFe5FKntVPWF6QVGvSjw0gu4YdGopXcxb6mKqxpEVMj39xLy/RlCvi8S8v1pokJeHJa2Bcw1gdcGsI+NidCWEJLeAdgvMPSjDP3IUI0xAjeogp1/iKFzhs4Y2jL0+aHKHwKWyMaEp3eg9/MMfZqhTzF0z4m9R3j5igljn/ApLOVDg4PIn2boKScSHwHCMiZ2fwIBc5sCHN82sCIK8D5kSLg6dl4PKmFIZ3LGiT6KyZla+lFMztTw5GJypkYoF5MzNUg59NZ8nHIorj0bLXZ22uHZO4Krns0JyHt2QvDfs5MCZZH1BOQiOyVAFtlpgX2Vc+wuJgsBXrMzgvaRzQpcLQ6zHJtTAkwLDFNV4CHCLYCzMDGIfXENMiUYumOEz80miJqbTVJ+MCMYRjMjMwH4qpBXzAQ8POtQ2jATsOpMLBtnEaS0wKv45lAwOoJKWJp2KVUiOlJQ+LBCTVX8b0KJO11s2HpUNXFD3IQVcTacpj1MTyoIAJC8RcUMBR/JNCUWtSBiQywDEtkEwr5qw1Eodey7qZ0UDFSEnxQlcEigTAjyKagTTlU9Bcw4jZYNB/mYU6iHWir2dlJbQ4XnBUpITBtmw0GeDGsw4coEKEoLfbamhiJ4NrC0sdSz2DGLDUCDutzxPTl5tO0529RyC34rYzo19badpnkI/Twhn6edij0wSJtaE0F3xecphwjQhsVgrZIAuRqtxW4FUOzVomlnqebC4C0NLtUBGjyq2L45nzffgjbo3kh1mvdyWM/IZ6Ec5arT0urgeKNJOGX7WTtjG65eLa2XTfB2jnAzDjFg1s7bhqtgSysIcFMJ1xjW1hxWjFeVFmwju3hjLt6UxpNaNtEWaJaX5vPWWwBoB0SCdxK8lwOUPp+1p2zH1WnM1WlK6wSZME3L4QbM2h7UZVyECRdh2kWYkQiNYW3gYdsvfceetOMugQmXwLRLYEYTkGq0MIhtx47dnM87b0EV92CkGp17eQcNcMKOu0pMuEpMu0rMaCVwzpYkGw7zgIudV7hxO2e7LqVJl1LqUmq7lBJNSUrZARI/3lFfmn8LrNbOVgLEoIivRZC+MnKgpmJaBCzIoglRt8h/Hrrqnb88A7xF81YezqsBCsBQP1B2Nn1RgngnvZHviX5feofvsX5ffIfvkX5feIfvRr/bd/ge6ndcJiCshoW4mC163inz5jyupIKqSOMH6yFh+iBpaEPBVxyjCB7kDW0oJ86wDo9biLPdkWhWYrsjT+XyodY7gGS6IF7Y7wBc6aJ4F9QyxhJb2pnxUHhRHsLeEvy1sFgqtoPR0mtJDEsODiFlJEXoP1GJ/9SJ+9uGiuU3RSYfO79oAbWdylM56ChUbNStkacy7FgRESSKxh+sULoOr/jNghdkY01Jy9bYdzXUtQ8N0aJPBf/H8vxI4RNrOgCY6Xw6NtHdEFfh5T5vwsGC2V6G7C2Bi3hNeI4n80iP9toyPR3iPNprVyxUvbBYdcCStr3jwS2CP3YKsEZQ24/UeIFYIoit6X4F+twPcjzAn+9o2cZ5VBKLNl25sgt2FHsglCNqKg9Eokxe+Vdo943XMkeCffFQzE5oGJxdeeOqggDCSupRh4rQc25F+dDwprMqsbMsOibJC5SGhvHC7n9LEkHabEKSTeYvmabDpdtepkAndYqJOhW+0ifH87YzHcxAVym0GRRBF/C0Yfe267T/yF32RLT8H6W/OLkuBJ3PpGHzLvVY8VC9+1DfO/mgI52+T5ESddY8Ed2uuDsrYcXeWQ0r/s5aKMU3OGNK+Q2OmVIBPK6HMteRfvhstIQbvkgph0X0WtYq5LgY3ioiAPSFxZ3XcDSFKi6RBRt96v4nIssTiz1q5TolkOd+PW+I4WaP2H0Qsff6sehREfeh+gZDzU1nE7olRlIk+3fKershWMERMWTz1LYkcvBUsHOBCMLmqeDvGoH8+2z4GiWYGoCYfUD1k3dogmJnrk+k45QQA5E0CLk4Hyuar9MQAcjh63nTfWvyW7/6Zu77VseL3iGeNkuKZkn9ZuGs0GLszNVFcdHYIIJ9UDUIJ+IFLBhsiBcIm8j7wdVxteMYsyHQHl9CDuToAEAjgGW5BazeIqD9zrpHYHn6vsGQPmgwpA8aDF70dxwMsjS4AZESTkQFrVA4YHv3wXioAKQjt1RIG3Q+1TATssCvhLfI4uJikTc5DgQQQ2H13JIDxCAgmWC46ONw+FrWLgIxYf5FbKffooIi7cMLIkjXCgrMK/3igIZajVgMVTBo2dCZLANDPK6SjDv2HcbaMyPoy4ntSGu0OZ5tV9I1VW7MThIxfQcz7Qwxq5FOqSxe3F+jkmazCG/lYy/EyxgOonDyla9xtIP7ePTBfoV0EkprU3hUZzQNuw6lpClV+fu2KzdJgyr9tsICsJvjlVUUxGfbif0MaZaoj9KoHMWDEkLRzRcTd9DcysYLYAc0qYIyZtvQQghfyyYkRpxPotrsbaKaQCd+HL0ZofYdQTXXbmMUFI0isiM9m1jtNA89HD2pUdTwrRqF9UJprzZQ5Ybr1Yl42XWoRFe0cZcjWsD1b925bYz0tp0soi9mKlX/6qImtRuTOd3EnMYOvB/1s0hrSSmK8JW+NqaCpDyrx3esaon3PTn+3bzL9+hzfDeY62iHGO0QH1vhHlysNSxCIaKp8Vmd3b9kwuSulS0D8RbMftQvjr5QVbkY2OiMj6HQI62QQONGl7ItWui1iTV5Kh6jppKBwApG7IOfVeiy1aa7UO25i9WWu1SdrE39BMsvV+VYbfgEe01c1wXE2PAJ9oa4XhbIYsMn2FetOxTcrg8FhCXWUwHBiM1j0Vp4WSCIzWPRenhZgIfNY1EZXsYBm+6N8DJOKHRvhry3pXkk7aV9woXv1iWzTbDh7p3OZ6bN5N2WHpahYCJ6faI2MPVsdHQFMizLt1SCVB5vVrcBT4Uj6oy+5iihl88KYV0JFmZ8QCiVsKA2fooNJSzmJxX0dHs5Nzws1heFWqAvm6mds7VzrnaeqJ0no2U7bUWTnJKDUwDz4BksKfZPiZAMMcanbFLsOQJwxkHYdQRgjYOw4wjAGwdh2xGAOQ7CliMAdxyETUfo2VMkbDjCKdUtEE0lcJAwpNqQJVyEDSHRv5kTrZwToqtzEuO0bXnabdtTcqhsd/8cQW2XhbNZLgunc31ZOJ9ry8q5XBaO5sqycCyPrmRTHbEFvrksLBdyLmao/ABRVUiKgRF8Apzhk+AMl+VbsJrFQ7zD7fhgEXb/bJ68P/gHyxY3grr5T0Gxx/AVUgCnoZW+vZwn7pyGvlcV9bGcvFu8VHCMKLd4YYA3Cw4jpdgBXi840pTSG+Ahg4NRKd0B3jQwXJXQHMjrxtEVYUFnPayTOPrYlCeEJq2myxKBM4Il7/kwQr0p5wS+DKWchrTOTSkniNNRxon2uQ1BGO00j+kxL70MljBMMiRkWuAAq2HlIRvjWp7KuSN15w4cjAB517RTLFW1OzVkO4ll02TpYz1bTInd9inqmjZff+cwulO1Cm7lgawGYygRYut25XKt9idJyD+D6PFc9Dm1QxPUSVCDw1v5hJxBYtHg/crXeMiEfh/OIE2tYywZYiHFga85khttZAyl3A2rxccp5J3Cmzq8kfAxqhu76qa6+MXHMg79w8g7JoZq8DyS4DwyaZMM29qEHcfBI3wtE56WDaDDe0uspbCesDg5KSfLr5Q+b7mzSCwFcCjP4CR5vS2d2KxOGdKzGkVtkcR6GGseP4tolcekyt36LCLRnWkazdE7izTrTh7HvjyO5VPOIlU/RzJKpXYTchZJcBYZA9cmkttVS4xTyKxquM1SrY00aqN8sRxKGhIwlYANFzAdDWh+uwGj305APa+0cF6p2ipQvVIpebGW9LXR69JXAHl6chF5VzedHIsCP4vysyA/Vn568tOVn6b8yH2ITRz+h+98tbPHTVCXgnojxN0IG6E5vhGa4xuhOb4RmuMboTm+EZrjG6E5vhEafyPUC40sJpFshJFshJFshJFshJFshJFshJFVtg82QvJTf2cN38HNpPvn1ETosmwUOXdEvOwuV85VcQp/ba2mryudj8g1ecMFd7tmVGwayGXYtnCNvjM2yd30juBmJpRISJVNRisQMc+7TwXBuNytySaGnlneGpWoiFRy6uiKmPyQfV5sfcjer2pk8uYpX6ycEkSZbEGODqokyOMEBcEpvb6cj+FZCULp+TgAzIC30H5pvjZ8IMVo29ZbFO5aBjzgmGfhCzJpbzhe4vIXDv8kQ7fxlgVESRELEamo+6Q2D3/QRvOyv7XuZR3LhoKAhA6bVJmGC6aHR1cH5hm7RqQ+uNeSgSz+uExc6Sskptzo8vaA6FJcUvMxYMBBOKqFx7TRmkILp+1ZfWT9pOrHaonnxrxlO1rF9HNXsZV1XL1Uet6zrdTZicLWXRXtSh1D2+er6mIbYQ0mBBA1BoEw8N9xqXIXJo/N6rgmsrTrTZLJ4Z7WfR1XzoqzEhfmqjBNbuXcBRrcBUJyT8wtbyNoKZPBFFGfWxLzBzhNdT8FN5t3ylBZM5vhSzDjEFPl7EHkMn4geS85Rs6qlT3Byl4xzRovqAGwuhAPKAJj+8t6w92ZXKi1Wtroo+O0ft39Mrkw/cgyBYl+pGrU369R2Zgfs6lKZn2bMfHdzh2YcKkaN3VdoMdiiA64szDZlnoKhmiAO/9CrsCdfCEroGdekTPYWhZBg6MrWVcNB8nwAJJ2Touvh5GqnB5FeL6E7ire4WWxWI3xHolHl5gCHdA5pa3RiF3RkjNuxDNuNNIqfxPHzTcg+leEL4p4YcOGwz/52nhI5doYz5GNEmY6eOyc/yjHDRmc6YvjBkDHmMIdG3f+yaRp3H32jhibMC+Qj9tjJQRY0qpFiPbbF4oF0XOHkFSx2M9TaSFKYTWkhfDIkTe1iYiXJdLMuNJnU7yNZ9PCXs94pt+H4Ieh6BWP/btGbNc2RYVtWTTabosi22YoCmwHgG81FL3KqPhmslxQI3mvuJo9JHf87AIVXIBNYChr9QizhjyUoSwWRVx6og13LXtMuAHZ41SFAUaBoazVk/LIkD3FvCEXhYtSdpqsh+xpeU7IKB6zA+koQ3mX9zBvk72XeZvsfbxwicbejewL5OUhu8RKA7XAUGpmiXmb7FnmbbL3izQYbf0uiprfy9kH5K0i+yArDxQDQ1GbD7EIJuM1bCXKlm2oYo2hPYMx8QFIM3wQgkOAEOgATQACRVfwyL5Mg7llfkZlUuYR4QsQ4ZJEuIwIS4zwLCK8XyPMi2mL0wj/NMIvSvhnEP49DP9ehH+fhj8tpjFOIfxjCP+4hH8C4Z9k+KcQ/qKGPyWmNXoI/xDCX5DwDyP8Iwz/KMIvaPiemOY4ifBnEf6chD+P8JbhM4TPNfxJMe3RRXjiI09L+BmEn2X4OYQ/oeFblcV2oivzcHBSUJ2p+SWMz1NDuUFAGIy3j/khz/6QFCtp6GoS/GQBkpNH/lBERrEupR/DlWElvqX3pLbk2RJsTjBzrztvl7eoG87bG4J99LLz2iGYR68678IQrKPbzrs4BOOI3U3/0hB8o1ViFcoQOqmj+azOqHNiWPq8DlMrkzTTGcNZuBrJhKcMmFHpRE7pCzo+H5ZZ+ojOGM7GtUjWhzWdlWuhTMuuTMtdI9PymszKXZ2V65EsJ+s6O9dDmZ09mZ17RqbndZmdezo7y0gWn1JnaRnKLLUySffNyCzd11m6EclStWFktm6EMlsXZLIeYLJyep7RNYrTdDOShW3TyHTd1Om6KLP1UGfrq9myrlEFxoG+FbNTthSqPG/LiqIv0h1Z2xTec0y6ryz15Xlc1g/BPc8nZCXTt20uJrdr6M4So/qEynS1gHrQth+EYdgvBPj0h5jouL0Cs9UFEKSXj0Wth9Asol5G1CVEfVajvh9RP4CoZ45FrQbjDI0VI+Z7EfN9GnMeMS8h5hcci1mN6mnEfAoxLyLmaY35NGI+g5iLx2JW02MKMRfEbK4YM2bMxxHzScR84ljMap51aa4ZMR9CzAsa8+Eh7QnbSfvIsZjVhD2JmGcR8xxinteYFjFzxMyOxcTM71CIrT2kwFFZMxO5SM0MyUwsyU0kM1HXl86vNoy5G+oRtJkbAlUFFZtOUSZNhYArwrqKNmsqtN5SxHQVEdJUKLQin1sL/VaIucjeMbTdq4xRQEfJ8KqX4bU6w+t+hjfqDF/2Mny1zvC2n6FjmHsZroR1jquhl6VIGUie66GfaRnWuW6EXrabYZ3vVng847XRjLe9jHf8jHe9jPdGMt73Mj7wMz70Mj66L+P1YzU2Xo2NX2Pj1diM1Nh4NTZ+jY1XY3M84/JYjb2Md/yMd72M90Yy3vcyPvAzPvQyPjqWMTclr46RX8fIq2M0UsfIq2Pk19GTWd+Kqqz45odrQh5mhlIqNqxYAP7gNpWcdeAPQVOJWwf+ADGV1HXgd5+phK8Dv3FNJYOtZjGKReCvacG4C8cdgSMNbExJ8F+JjbnbvCOyYwGWVqdfsRJWCharYaVhsRZWKhbrYaVjUYaVkoVMgSVAFRLmmKaxUtg8xKNXEXwg3DIEwEvcNTmlSAYEFwKYoN59qC9vsk1ywxpOSp0m8kRAXc5HIpxOssilU/LNCaWTLvLoElxk0UleqnY+SjXqpVIgDHF9djWgfYa2qC50RO9hTJQmxuWMPSHqGpOi6tGt69TSWqn9X68yS8OBGu5FmWjVuSOeheFADfeiEsOBGu5F9YYDNdyLag8HargX7TEcqOHehtiI7o7Wpm55WMjdwG9Hu2tMe3BcO3VC+3lSu74rg6GrjT/pWn5Cm328avMxbfCOa+22NnWrPmHIQOh0NsbMhLxqgmUydiEQ6UWOvKQeeUk98pJ65CX1yEvqkZfUIy9RibJNOCmhVARf5KsevZ6n7w/+rrEpmf8ENMQVHAI+YEFBuqdDxh6wEKO3YPKOTPb3Bxi1EObnbWfT1NIq2uMJ2dk5sBJs6o3iBjs+rTfP1Ns803rzTP3NM603z9TbPNN680z9zZOjGApT9RM/2ZM26f4FQQUSsHMi98gLokDw8B1RcObkNRGe9TDv4aQCsKIwP0WtFMAThVCxHSpe0DwUV8oSsN1oA/CgEicHRm4ZZb7a/Bp9mO9OvCJQ4guSI6E0vEoZUWy3UfRe54ThS2cKLetj/uaov/ZEJQtDWx1Z6ESbxmthHvZQKDNyK3SRRBgNMcQauhOGSmzEdQtsrDMV3NvwpTzkQKARzTGosuKtBoNGWoHMIsrFTRVhNqEiXG7yqzSxrP9zwpvuogO4xJ9UJrZF03MZPyVBFtHo6GnX4rJcTrIA/WzaLNsplGcCDd4tBLi3OdLoE2j0GRVVGdciOZEz8IE4ciEo1hFELfQMWKRqmtSmkCyTbyPU5n1U7RWsO0I41jPj6JlxO6OPYNIzkn9VKhZLkL3SvlxY/K6CPE7etl1JYtoGdrKab9Ewj0TubRKCK1Gt2KrLYvwiYcXCfjYhIzmbl8GdnZYBn52SOZD1ZGJkJ2WuZCdk/mSEu7qdGbFwJOPAn2oRLNDIVIPTTTVHXlOym2qOXnrBN2rypgv+blON77cPnm5tf7oVAR9Jj085tYFQTbnK3xz1155jHRugYwM3gZr3TzmNdN+Ua45MuY4dU4bstxsTiWnulUgN6yirnJJFG6f67kFB5ZCJPXJkCE8VVnzVw4gaVUZYqtRjMsJVpSaQEbYqlWZEnD2maokR3ipVQoywV2lUE++Om5CPLbZNn/zaWPmtoZNPjr38GfZ4qD/f8cqIb7o/vfrsME/kHO1sLHMVon3i7mtOGst7LzDFSoS2Wo9N+27rjsKrTipgalexUKcU3nRaEUtnFLR1VmFY5wRYFdr5uplN0gCZHl8myKfGChbL8QUHDhp9W+SBY0o8OL5M2Wnx4PiCx0t6cHzBwyU9OL7g0ZIeHF/wYEkPji8nHM9ZwYIjHEf4HtB9ViSopp4VqappNfE+owbgZ1Uia06ltE48G90Wk+o7FzBTDJdnyCZDgJSyHpSqoEwAZUBq4YgGxAKwSeHRvOMEU/KWPFMlWH3a7mGeLwnVWtqWZyt59wfOYfN1hFcxxaYsau2+J0BAaYgORAM6br8aEwshIlnCnFUyciQ/vEXKOqmyATgAZA0nByIN2Pm1ppm8O85ZJHI/NpB9a5/7ll5TxDZSkE+XIjc2M4IgAJQ80TCZdofAmXvg/gAcoIsHP8j/dIXTz0DwTPAt2c6IoD0eCCYZrtfPu1W4Xj+fGglXa5WKgi0eENJatVRvO4t90QCWM70Sl/qiByyneyUu34I2cKFyR/Krn3YC9BdUpslfUCrsWPKsf42cBqXCjiWP/tfJdFAq7FjyJnCD3AcBHnhOxRlRSTvJxh3k028+K9itwFJJBHTFPYNjKOONcw5QJNPPRmr0TQNgKCB2lyFOMMSC0iDvuM8XV0GwEvHYba4S0xUKwm9CyveQo4jwtIQ+OArld1d/d8Ia+GDDc3+LuJ1hKbg3Q7EsBbezLBXRstRdYRYRVE0sUFqrUjF4Ix+IyKEzoP5EdH0gIoZNGdmAvh2AF4+p01LKy4OcUnU65YAsO8B7AGyAdZRye5DPCwDjmFJWwgHO6QGUAZW0Gg7ysyM9hJEH8JZZds6EgN5UvTIrvXIOvULBB/KjZ+temdFemSW0pPTKzJuCAMXZNCNy2jN+T/wn6YNp6QBp/jlpe2n5k9Ls0ug9aXFp71PS2NLUp6WdpZXnpYmlgc9o60rbntWG5foTFSuUpVgVLa/77N8QcVYQL8IF06MtnCEBFlSPjVrXcvptqm9xOGoSR+MHDOHFsiOxloajBnLqWN2RWAsjsZaHo+Zy6liq4TVSQjtSwtp4zvES9kZKaEdKWJvSOV7C3kgJ7UgJa8M6x0u4OFLCpZES1mZ2jpdwcaSESyMlrI3uHC/h4kgJl0ZK6Ezw/JZ5gB0kWgMKgE75ezbePs823r4jDKM7gmIfCy59IkD4uGuFst+K/H1TXM3LRHowBELpCXjNgvwsys+S/FyVn2vyc50bbaU6vbB8DxbIoQGeUL05T4VFQZMiBCfI41JtCEI2kJ9t5x8b07pjvtKqwACk1rMmxduzMYqsZy0KqmdtirhDusKGqj4AFBfw4R4j7m2AywRS70qFJrWGQCiKPACGQZ4qMkfqgcum1gDfyHikhtpixhqaltDxvQq3AF9MOJiRkURK3ESvS1GWpIGMTeXkYFNrBnifDWzMtr4triaRg+AS8CAw57YhztIGJwqWMHkaDpSZF4CJRyXeJk/D/L6mfiATgdm3Ena+txcmd4vDbzBPBcEL8fJDQVF2b+XBhaBY/a1QJB3XfiukbZhiHY7iqN395jCLi82vNfJ942tH4IaDYst92XaOXefYOR52z33Zd469b1DHwfGw+9WXbzC+OQuWtfj+M8V0d5jIsFvX3zX8fvP3/JWf/sy//YlPX7kMTP7guZ/90W/89P73rP/kD969jHtX8NxXbX33r/3oX/rhzbdzWYF/79d3f/SXPvGr33flMgzYB8XKo2z1Q7iPHqH7AO5Dce/DfSDuPSr4iHsX7j1x7/ARIAFc6lrSrxXuvyL4ut/8f352hkCbsCVb7MT97l9UxKjtWH639HcTvz/yq1/73T/wXRv/KxCg4f+23Z/+a7+4/lOfQG1KEP7lX/6lv3/0z3/le0BYR7abUvw1FkHcq3CX4l6Be13cR9A7W9Pqwr0q7gO4D4n2uhn3nXm/H3z+f/+Jb370b3z3P8cLxjqLfxDVxd+PbPDcT/z1r/3qr/rb3/BplGYvkg+7+P36rX+z9ws7P7SHDzsg/OOf+hdf84tv/vc/fuUyTDIEz/3k3/jxH/rp7/26T1y5jNeUoNiXomzCvSfuDZotEXcJ94641+He1mrDvaXVprtJ0NqoqsaV5/+v/b/wX1z8yRZ6YQvWWwjO7qqxoqU+MjbQYffxn7pyGVf+4Llf+H95exf4uo7qbnRm9t7noX2OzpafR5Ifs7edRE7sRLz84AOsUW3HjglxaAiP2+/X0FCae07aWsak5laxFOIYkRAiQiiOS+HoGIihMTWUNirFWEmgmFdRUyjm0VaFFEzhKyrQryZAdP1fa/bjHMkptPe7yc86s2fPzJ7HmjVrrVmPj3zx0Pff9SZ08hyef/7TJ2Yf/faH/n7rJogKxOAHvn34I/cf++sv0/DhInW8j2ED6TFOn0F6lNNTSJ/n3k4iPWtHjfQ5O2oq34F+zqrMKH7ytefsVh8tYRRnFd4eV+koGujNUz//wLc+96/v/f7WTbi3S0eD3o0j4/wX3v+ev5z63t/Q1kDGiZ89MPqWLz6KRRnF86e+89W7xr727k+iwHmIdqa437NIT3L6HNInOT1Dd0ycPot0w44f6SN2/OS/16e9oTLA9e533n3vG/7oRwCu85L2hszsDfs7aX+B+wYffc8HH//5qW8+ht4BCQ6+764PfumpP/7YX9HmQMbck0c+ceSnH/nKVrLGEmaWuwDMaM5xGtjRzHAavtvMWU4fANRwci860xejYjNepo0hM2vxZ4//+tuf98GnaGNQ38+JtO83JWfj4Mfe/uHxk/888fWtfGK+9SdTZz710W9+ZSufo1/98789P/k3X5tE9wcy49tKp61prKMuwDT+CCf70BtOgkMeW2d99Qozus766RXmfF98sJuznTVmbNOePznxg9/5zTd/ZyuxzSQSCN4oSdBxRt4KHc6axWQytdCT5vjTUBilAwuPDftY4MeT9IiYetYTtjTnKYts7FBidI4r3MIVxuzjXn4ct48H+PEIPUIYGLdHBnMOa+GaI/FRMp6cP29Vg0f/9NuIwvYlOkrOtGdMtWdMphnfoIyT7RnH2zMa7RlH3qoGJ0898I133/2hL1LGeHvGWHvGaHs/zt/bljHbnnGuPWPmXjX4/WP/9O9/M/vUNB+y7RnT7Rln7m3r+lR7xmR7xsn2jOP3qkF+/vxXeT7aM460Z4ynbTzJ89GeMdqecf4tbRmzb4nJhOlPTzF5MC9nZl7O2Xk50/NyzszLmZqXM5nkjD7AOSfn5Ryfl9NIcmY/yDlH5uWMz8sZm5czmrZ8lHPO39OeM5vmvNPOT5IzZfszk5a5385PmnOfnZ957Zy5Rw0SDB2ffKOdn3k5k/NyTt6jBi0MjNr5mZfTmJdzZF7O+D1q8NSf/91Tf/Fnn7vTzs89avCur3z6se8du+NNdn7mlTl/txr87Jvu+ZejX/gPojyEmb27vcy5u9Xg4X87+6Fv3Hvv07yh5hU5m8khCnT67mRHneF2z7QXmbpbDb75fT89/Il/eu8hyphsL3Ey82Fu5Hh7kcbdavDI18abf3b6zI95T6UZP+M9dbdFemN3q8EnHv/8Tz79J39+B9Udjd+cf3PaiJ2EGFM23qwG6US656t/z1GMTSOorRVgEeDFQvggtv1uYd7+tIwjPiLLurT1/wlaIyVIlafzLFV2OI6nCg5LlnWdyZMSf8OnsBufzJOoaixXi9RGBZ8iMC35OH7VRjXJb6cR4OJkJv0wp4/kOTgG0pN5Do5BQjAbHMMxjTyHtXc47kCVk2dz1kfjFc5Mzjp3vMI5l7Ps2hXObC5hzXA7lGPeDAIuy+BBupVnPg1XJ/ktLP9FCEBcreRCMsaZzIVFe9XiU7lcWKIrmFxYpqhSubDTXsFUuCVWkhlDaGrkI+C6GacbVNjGXeGcpJwjnENmPmdyTasUCH7WZ5d18PCoO6yOsc9eGyvsiKwAl0Hk77HRgGczwfY3vE6uqbJ3qyDMs7CZhSys8nJchp71Spoj0xwErlPschS6hWNwQJWjaxalPShu4KLcJyukJrkIhJUOLiX2anh9KMJDVaDz8Iw2AUVK6APBi5zuwPNNrdY1jpmGY2j/3zzljKwkELNuk7P2YjqxLDMDdSvPje3IMuxkIbU8y+T2tflGS8PId6XJJWmySsaHXiayTgdH1vE5sk6Jbms4vswnpQVtls0WahvVVJqcjDcHZ01Dunsyk36Y00dkKgGelKkE+GQsATYNCYB3WBgbldk8j2SxkFMM8MO4jCrk+oA1jCnW4kqOi1jgeI2r+OavyCEMV2Mh41u/fPBBrL8Db8sQm+SxtKubE5FmI8C8psVe1ZxA/B7IvldgUVfqXHMiitg0MI/YJzmYpUADnn09r0JOodmAYzRIz1ei1ooL0NqAI7UC3TVWKXZKeQt7deqGJX6THQmW2HoPVwLwpd8De3y8WoJXi2NbATjc79VVqL8uh0b+Mmjks9kB7HMrJExxIbchYYpnzgj6Yic5v6Qvj+JXbwE/6CIGEV39RnQd7ELKMoPfAl0bu9gM04obHnd0JezSOgx0MVykO8PFOoT//XCpLofLdBQu1zmoFtAtZwrydOP90dUqGLkEID+zrB7l10Kn50gQo1WKJFm9NfI5l/T5AlZ4n4T2Qt7Mdta0X2MtbxH1sg5qtNJqpkar2M3u6ib5c/V1N9aiR/c2yd+rr1dD0WSl7uabSb5GtD3Mm75auIjCHpBaS2oCF65Mk6vS5OqMz4E02ZMme50B7WM4ucxwjkur+C7ZomcS2hc8rpzVX1zL1zCXwCl0nrLhqtNJHUpUrYFDXwO3PfDNsEpX9SXNaF0jWsVeGlbrql7bjNY3otWsOHUyxx/QUMOJ1upeAhXIi6t6WTO6RPdYsELG0mZ0me5u8K0UwvuGJR5CWMHKqXrksVYbYj1HirFG8QpnL26/zgKPnJO1aLEurnNG5SbStsHl3BJkjHEGkgeIrfaIKS7i7oe5oDCAxy2KfknXiS1GkGuEGZccAtyDjWWX5hiCdKlDR3GZLZ7KkKKuwM9AqPFTCC/Fjw4vx8/m8ArdxRdnRYDM0iYeqnhAyDk89OOhGpHWUocZ82tRB9+swnpsqb4Um+5ybL8rqAQ7kw/oXRXvVuCdtu8CEsIWgBnHJMw7YUJW3KgO4aG8UY1S5kY1zI8HcGEIJ+70cyt+cEELf+4FUiGqbVSvoeQskjchMAZ5bKcv3MCN7OGfndzIi2H1hq+WqTze0MdtE9SBAnegwH7gD/CXArzC8tCcz8JzijkrazT/wUFNF/fpys+QFoHHCw23VB4DQYGTxPlCizRZ7h4fipeEEDG/4aX0SOhKmWlFgCXYzOWcYjuXUSfcQBNuI7xZ47NZxQYtY074LJpzNsSZsVZm5xVbrow74Ua9mIN0LOGIIB7Zs1Q52B30narYKku11s/FWj6PfZFsJAyrm1wkwG3/Cn0lL3Y/CjyLTcX0Ui6iL9WX4+0VqL6BXZlEy+gt4rZT1HdPBwib6WHtA34q8RMiknm8NmdVmv4Sp6dUbaOa5jSO3c9z8iyyz+CMO6MADvSVT0puccr+Tsq0uY8jXbLAiIoosCRtK0iLlih5RtU47HyBAKMEosBeZZMmwFK9jLFrCSoM9g1h6+Xpm82YXrK2KGHzVfWK+M0ZkbxanuZOp7lVrePcs2nu0jR3JtuCbkbLJxjFLdNL9YpmVNXLYZzT4MKkrc7tTmibiT5pvYyfNUAad74IDVREjONzBJmkmcxX+0p3WjkUKYV4eCR5Eel+dOAx4Edd04uSGGqMihSjIrLh2sB2U1fGShwMza9g66x+BuKdDMM3hRtJWSCsItiRl5wSy62j+aU46EjNTyCAJmkK8EGxHJGGu5u6F6EoidTh82I5oLgXp2UV+Zcy6p927LGxFCfpaqyg7tbPRbHnoQ3eEpvik2Q1B3NDmStRph9leFds5sNlGcx8VuEb+nJ04wp0dAPrfUZb+KMNZT/aDQugS3UPRc68Sq+GKdFloMd0t14Hq8gLbxqN6Cr4DOqFidFaHO06bEQhRoOoOWsRnbm3OdGIoubEhL0i7QXyXkFll+tn65VcdTVF21wPk8luavfZmKoIjXfzl9GRNY1oDbeE4fQAy2t8QC/Xz9Gr+HsrmxO6BzZU6+jTjeg56M4aBIeucl0ME5jUDnMzAmP3UJxPGvEqCj36bISuxoxHmPEQM76GZ7yRDGQLYmdjICt5TKspcOhzYHO6lGpeiZr9qPmsuCZ3fBPMVnspfCiNYSXFFr0Kxqm8OhFWJ8TqrIlrijg0NdNM0swENgiSNGc5ScEVpoPwKlAMnRzpCJRMpw2clDdnONkHqoST6xBdjJPrEYaMk5dfoMmOc/IKgCInNyB4GievNLmw0+TDDnjEAaElmZIiXfQgCu2W7bRbFnthhd0fl8R0Zw1xhxEctglVm+PQF6fYDJc1JybCHtJkj9ZggiIgcZ8YxOX6ErztJbWfaC3eXob9s1QDxsKV+hKs9Vp9Gc3oOrzow/HQTTquq3QEKAnRiF6GSAxLmYxYT69X68sw6WvQFluYLYPR79LkBAmrutPkbyU3mjMCTg9xWkLFTsEWBipnZ0UtLBIWCRGZrK8GS2kgUZigms012HkaXQuX6EuOhn36sqPhOh0dDdfDsw47zdNejewDVtLJTAR5PLECezpH+gA0P+SNuWrn06cixyVwBbm8wWbPkYKz5WnYY0T+Vt3JX+iOPdpEijVrLQKQlhpeydTwKrZ6XW33Tfy2ym+fzW8RdKOTXGspveKoXgtoXoN9ERIdhk14GW+w9c0GpvwSvLwKNo60eiivEQSj2WhMUOh0pdcCYa0B9gvJLlEvw5FOm3M54m00OB67sjQ2d6wQdfMiEixhYzMtL2l6ClEfgwuB6boLGMIicYZGEfU3GXOFls1pTnD4+eUMcSFq+GjnWRxvXi/TfYS81lgUSK+DC1iw0dDd/C3uBPC5nbtoDb5CrfYyqBWiHj4X9DJCKdT5Xh7ilEOuJeMdBVdb8Um4IrXGUpqMmDmqEp2GOX0Zddo6LqoiJ+IcsNCosiR2ssYKJ6wOWbFOk0QjuoKrwrWCXpRmr+PszchenGZfucVqQUY5VpXj7Ms5G+RFjo3SOb+P86cpP0jzN3D+WcovpvnrOZ+JjNjOT1jI7oy5vVEP3J7uz87MszIzwyvLoaYyh+yabPmebPnebPnkfFyZLb8qW351tnxy0FSz5Z+dLf+ctHyHkfWwA84wALTLwLX/e6QWjxRIw7ZseT/TKNZIscXFCnRqJ3gzqP/RQk0765x+5vGcdU7fJud8npN6kzNrk9VNzjmbDDY5MzZZ2OSctUncrFKSbJ3GQG82uOk9zE8e4aed/DSOJzNQt9d4njlOGWdFcrHmmdEi1ThpGdLz3MBxmXQV3ixn8aUjXPKMLTnOj1P2cYwfJ+lRbhAzXaRuMu1YeQaCFQTQADWbaxsVIl7QZEUFkPt5wslrhJktsjedPHOrCKTONDjS5GEqD9dCjs6xglKxRYWEc/v5h4M8sYQwx5pLOdZcyvHtbI7jdOWyTdzEuXv55wD/wCjOusag33H7e8T+wrgu20jD5p+0v5P2d8r+nrG/0/b3rP0919bOjM2ftb/n7e+osv2xv+P294j9Pa7a+mPzT9rfSfs7ZX/P2N9p+3vW/p5ra2fG5s/a3/P2d9Qux5j9Hbe/R5y2fsB3b36jmkT+m3DPxfoeWOVv5igkX8dG9TBnfM6hDH+jOu6YPEkjc+a4UwvulxdrJa48v87bYf5UpOMZUEUgRL6Li1C176hBIdYq55NOLHzg+eZZcBRYIgFT5HMZPylT0h1sGrVAfnXfQm26tbBI+CNnZovEOulOUouFDjTiLzdj0RL7DSuQLbLiKE959h9WIJtkxXGi8uxFrECmyYojTeXZm1iBTJQVx6rKs1OxwhU4rhRHu8qzc7HCFVDOURwvS5oji2ykT2nGF9nInNKMcbIX9/iLbAxRac53UXKFlma2y8YNRfixrnA1HFyTs27yMV2o6W7a4bpQI3c/4IcKUGxcRb97ycsJDU2CqiiQgTuiYxXI/ryHsqYVR8puxC7IoQ+wAzYrGSlj+4fJuyFd8sCKBad7t5bUDXOui8m2aGVzIuo9qruPRdUHIfUhej1a8Rpy6Xy8i0WLR3Wv7gZF2/t+cFnVZnJH0DgG/qL3/RNh1dd5XUXg0O74o/lb2aNpbMTMh0xed2NEBbZrtstLWWzTbA8ozqqymbNdXMpiC2dt15ay+tjo2S4tZbHBc3+Do9+Rbn33g1G37tHduuc1vWGrVoXu2faXp77y1X8c/voLb4ZJFdxNRmXzpLi6zEfeNMyNPDu1zLQQMHu86OCpp/ONLXw+xSCB3LPIPcu555PcGeTOcC4DFXLPIfcc544lubPIneXc8ST3PHLPc+6RJHcU8zlaoNxzXVCVz5N8plGEqnx+jTBBPSrzUU0OwiHHBdqh0zNfiwoIK0yXHFBZLtDq0wqBbPNp3WIBcBWWIQUiZXlZC2SurEloHuVoqbgkiXwKZLYs6ASMKrREXI208cUx/g6k85SBaEfdrIdPGvoDx/ixBFkEYYMmv9jZbFjbiRK/GJXH2AN2R/AWCUtySKYqTDvitXOsxdSC6pxR8eesQcCUst+zZhyUOaaaXBwB+OxHc/ajHFejjFvGjuBe2HsGJBqlkLOM57wrnMkS3C+WIKor1SKL6ZKd4SF8cGRxXSZ3Os6tZnPPxrk6mzsT5/Zlc8/Fuf1JLsy7z+SxqJ0xaYZIHFEJz338PJnHUnUSlYbnk/laFOC5agmqPGTtsSjLw3V0tCiRdHlWBHYExM54nozE0JOEHhvLk8E++pzkjeZhWkSjS/LO58jBL+YhyZvNkUQZM5bkncthlDS3cR6ky5OlTc4MRWUjG6nYW/RWiP2wF3PA/8epADgEh6GC/ArAeJ9fgEfI85uifTPJb8AlWEjK2TdT/Ib4BH5Ttm/O5Kz7TLqSwJuCfTPNb84Je0pUSZSHN2dt35EH29k8Ms9JzoQ1yyJbcNbmBXB0avPO27yqrhIng7xRxXkajsJs3pjN69NV4pCQN27z+hGdzOYdUYw7tL3QARTk8Hc6X2Nqv5GzK+3VIj9ZmyM53P14ZsarRaUkdzyHCyDPnPVqUSWFi1wtWoomvVoUpJCRq0Uwkzzj1aKuFDa8WrQca+7VokUtq+5tcma9eNVp5ma9ZObsIi/Pzpxd3mXZmbMLuzQ7c3ZJl2Rnzi7m4uzMtS3jEdWyjMcJ7A6kq+iR+kPDuoGwywicQZljmXX0oFpBn5HpQnqsK2GdRNiVxLFEmQ2ZLiVOJYZ5mVnL83SFwyuarOUMWZynq3iWbvDS9ZumC7x05c5IrFy6ZjDJW6bT1YJN53I9b51OynidyPKbKbID8TItZ/8B8czQMi1L8saSZVqa5NG80DItSfJoWmiZFid5NCu0TB1J3nEZL5NH7oUsBWqXySMvQ5YCtavkkbchS4HaRfLIwZClQO0aeeRoyFKgdok88jdkKVC7Qh7RfZS3ObNAFOGCVyleH7sye3FbY/V1PbsaN+HaiFKvQPBDSu1BuERK7UznHo5AziMQSsyrsAYaX/VE+Xm54w4jXrptpN3qMHY+J23GOcUo/HjOZnxeMZ4nfSYsu0rCu9NZfJx2xkZ1vsS/fNM0W0pumhoquWk6X0pvmu6Wur3X7f1FTwfq+Cq6eJK7iM7NepSk48f2U8dd6bRd6fyluiKYEouVlplai/WWmaKLVZeZ6ou1l5kyjBWYmXpMjJPkOudcl0WAZYhd3ucrOXI5KUsUYrHLcRdxwQowf1Wkk7O5FrwJyt3i+QIWAlwkuCcL2ifzE+R+AVFvZ50MfE/iBWQlCE8Ai5/zTgbSp+jtSfu2uAUGFinMn6G3k/ZtbgtMMVLon6a3U/ZtxxYYbaT74Cy9PWPf+ltg3pHuiBl6O23fwvzHvm1IaNRM2T5OklLQWft0nLSCztinKVILmrFPJyWUyqbt0xkJj3XnHIoOkXpYRgzwzpanoOWp3PJUaXnqSp5eXSZnOlZR8C6+aKX46pMO39s6uHRFoKJJpxZxHEJyuViyAbDLNqR1pw1SXbFhpwOO/8zRtWclR9c+b6NrjyqOrj2mOLz2uOL42kcUh6CYkhxg+4zkANvTNsD2WRtge8YG2D4nOcL2uGQe94jkENsNySG2j9sQ2ydtiO1JG2L7Jg6xfQuH2N7Ll0AHbIBtyQG2x2yA7X6Or72Z42sPcHztnRxeew9H14b7WM/MOlYnTyBeo8uGtTnrXAbkNBS2yMEMqOioYL3LEJFejYpsVkpUc9Rh/c2AWI588taUkYReDkXCK6CktV5TKxug0HcldKuu0knpWFS6FqUvQelLufRlKN2H0uvS0oG9oVuF0qtRWnPpEKUjlF6Tlq5am8wqSnejdA+X7kXpFSi9Mi1tBeUcoHUxSi/h0ktRelmsE2ZL91n7zBJKl1G6k0tXUDpA6a60NLPRwBYuWyQecdlOcdxlm8QxN8zRmeeyqeJ5J8xTgVkHwaTNGQdqZiX2HjBFS+jzAwG87rDWgVvIAEqT13hxDAgExk6wPWSz3Qky9TwGrASLKHI3xpa5FKsavCBHWj5GoWjJbxz8j4MT9LQAurbhJgRzgjlebMWuewRzghxdl74itHXcl+dQ3U0uRQwghxA+xhwWNjf4Ps/MFICm3+XIfGoCLK1TPGsHXEBqPV24sP8GJ7ENdtkrBHte8Gz2LXzF1kB6L7EhjSY7umO4F5aNZC9x3GGXHVZ49pYCi8uUjHXHG9dhb3JJnSBTJ7B1Aq5TTeqw27mkTjVTp2rrVLmOTuqwc4ukjs7U0baO5jp9SR32fZHU6cvU6bN1+rhOf1KHXWMkdfozdfptnX6/UVblEYcCe15Njj6k1RYT1hVbHAc+jQCfxn5Po76n8d5ZtVraaFzChvW0Le9kpWpp43BR6hVsIyttHC5KURwuSlEcLkpRHC7BKJMIYMFo09q5Sg7POW7TiM95xKYRoLNh04jQedymEaLzpE0jpOGkTU9Ja3NLRwIFMxd8LFDwb8FHAyl0CT4etpABHB8RxFcJPoaInxJ8FBEfxf1XxD9x/xXxTdx/RfwS918Rn8T9VxRem/uviDTj/ityDsT9V1vIkJCPQ3J4xP1X5PCI+69IS5X7r0hzlfuvSJuV+69Iw5X7r0jrlfuvSBOW++9AO9Zn67YxJw6ck6Or68231ngXPwhFRVJV9K51B0xOqzpHv8wbSe78nXomCGbBxiYIbARndiD/YIN2L/8E/FN9sIHTnn1O2VgChdhxo6vz5L4oaYYaofLkccqGp7DRA1RLaKxKyaGoAFSHVAIku73PZMLhkrTj8Ow4VHYceSpMw3HIjVIBru5vzQ5nM//s5Z/j8sEGqBgeDwJzRk7cP4/Ds+Y4jqBL7TncHo+r0jYu6/KxC37JG1HlZtrRFbqBryCyGCsSWEkvhSsFUQwPDeQYzlWYOzcSuOPMUSAiOEfyKAX3Tx3s5BLBmkh3CiHMwwqcLGGuoDJMfsgQe0Ik85KLY0/kaQAeAwnTKxyihYKYoC1K7k2TxyWnaTWyYQyL8YI7saOxpOGkWV5CVGIBd+xnLNCViTDwMwTsb5YlDZHjs+4H0ybQVOibnBbQEunQwXs47lTOuNfSoA4ijiuFDOu0YWt9ciYVKcSKVLpsxWTkEslOktpVFkl0DmHU1dbXVp66bqOT2sAn8FmqHToTW7NpXIpjYRA/aSNpdAJakrYUB15LK/mxA51KRrvbxleiznm7yaeh5MVC/zy6+MJIY3j2eat7SXisrmMsmoafq8RLFWfaTiL0aDr5FHGYW0n0EKk4QqywXedISMA5crW/UT3g+CeUzA1nzt0quzpS5OxiD3u/9+iB3TUHEQxlJuB7oUpBRUDDyGPxM3uXst5OPPy+An41iZaR1AxMM6gFlw9i15I38TO7orKeT6iFm+IWjsBRIRLT0rpDuUAoISIHx4SXTDxZiio5sJX10UJt3WIJqwbFDKfGzsaNXSC2uIUztlVF13XcwKhzDAd663RRoIDYn7S2k8YOpfvsrLFL6f7/dNYCzhyTTf7ehdlqcJcx6rTPNG9BMm/yWPxMBJrL1Cm3tQcOlXkJ4onkhm5JJq0QTxrTupZoE5bIsfMS2PbYdXN2bftsg/3JfIl4vgRB3XKhxXqxmOzbyI8grNu08HsWzsffL5XUUjZ9C+pRD/ypwWoKSmPhEpiC6JwZ2dEbLkUcOJ2n9DLtmgNDsBYKIZZ3f9uo/XDIwv5noTQY9mI37w+hEOFTpLohhI7EblypfTPyOp2vhVVdRED3Cn4ExY+xHmwX67JeSneMoYL/T2dAL0GEylv1ClIjI3/DlVt1GU9hSVd0h3H2xc+d9KyS5y56lslzJt7ZGq1CsaCRh4aLyfRxbZq8JE1GafLSNHlZmuxLk+u0HzsjXEfLHa2CdHMziH9wsCGeDvBTX7QaT1CjI1c5kcbjedlshOt0n6aK/RTCA2YYTYT1KJL6XUNTyVmU7IPyLJ764pK3xCWPJyXPoeRl0EHFk45L3hSXbCQlZ1DyUh0RrHHfq9y9gPv+Cn7S3Pcjtu/93PezqB3pS/g7QfydPfF3xpPvTKPkJXotlyzEJXfGJceSkmdQci209ezNDZcciEuOJiWnUHIN2UWGUFkYVTWK60OCNR+eJ3WfvqQRan2pXoOSl+m10M1cp6NGGMGFdVALc7oTP9060F21EDTJInZWm9f+i8ugOlbihrkI16FhSftEabE1Dcw/Qtk+d2GkdTIfodarkyGHqzOjCtfoXj/s1FUmDCK6xYlWWdfKrFIfWudMtkkZTzG7irJty3g62eWW/YiMp448PeFrMHagkEYD9RCuZRU0viwJt4gVIhK/QKN6zUSq8bdIr0pfrGbN526u0ZW+0BN0icVvszUirtEBmqhDu+wR1NXezlaUkNNu2EkooRMooRCjhM4UJXS07t5VOheKdP+tYu9VFmgI9VpQIy9UFkCFNRCyUK7jDULuqey2EtZuqN9uVLujw1UprA3U20ANhEtQI6fGDDmGwCWUejlHhWQSuKWT4SpdBCgVGaKIrsGN7nJelapxdhFw/NIjo57qGvVU86Zw0VO73B3p4qya0B3xqsHdcNQZk+esU6Edfuqh+3H/C1IWRuITQTF1qYD+O+AgD1Il2F6DhiaeSvA8SHJWryharTNgw+jhKjsP16a3Wj1ly9L7JD6ShNkzL8ChKGYiyBVpK1XZsT0Jz1dbsFWwHggqYN228qj8z3SoPvbdq+sReu+uJTllATaP2jP5nb3RMmQEUfHWaLnBRYXaBbenIFmCME+8Y1AWejng09MoIkF5Ix7nKuiE1aN85K7FLAQczzaoBSdk5G0vS3qA2ljeuHXt4VIjj2yHzk0wdMVbo2rLR92oKyzRR7vKAgCCj1YX+GiJPtmV/aSLtl37yRI+SVETS/aTbtjlm9H74HvLyCF4mf3ZW5UZHdXwtvXjt8Lfwh3oirtJCZRjA3xcWrzYHTGuZ86/VfUpYWbk7xh1m1H7I8eAeHCv6fXDbioXrjH5cBHBRtHk9WIKoaKL1/SGBb2GsKxehH87e8O1lkAoMKh1QFk+1N1wKca1uq/pjXp0Ry28BOEidQcjkUivDZdY5+EFxNftNa7uNe7O3tDXZb24Fi7VvdzkEuPi387eaIWReoWR1/SGl+oViNB7mRGEinqywcRnt2qpO/XSWrTS5G+NHL0yhq9j4Qa9QneakddF4POxK/o4pPE67Wq/Blk5LIgBelcwWlulO8LVFFBwNRpzbWORozeQKKxJOspqQF/O3tphtWureno9a/mD264gKs/V1rG/w554I63Xa1evYr/mOtEqieM7X+Q9OKDQ0RXsq4ru4321bjsFEHU47GXk6vVwNco13UQzZTVGtlpfwnjQopFLbWAHaD+C3oT5UUhDANRF0HyEgFyXgwcQkc2vRxatJDWk9jHdrl5q8rcmNfNU0wneJrNtu5m2czqvI6g56h6Y++tyMC59rHUdFs7Wtfs1Fmd341AS3POiXlyLKib/krLQi9k8owKGEtqZ9cjVy7Srl+3sjdx5HXUstok7WNBuWwedbO9KMMoG92hGjKDeOXoZabcR1bJIF+vhIl2JFiNDEudbNXeMSmLMYVzeGzkUvdW4devrQg3o5WmRvA7mFyH15LWi4hs3EJETfAILe/aH0niBFP/dzO8UVTSihk0+zD8jOl3E6NS/NVrchk474RdeDehOmn3CbIsXwGxFi047L4pOiwk6LSbotBPo1L81WtKGTisWnVbKQi/hjy65KDqt/FLotPJ/Dp0uZXS6ilApDsy89gmLrgIWTTNWQ82vHmnCnq0YdWmKSpdeg1OuA9gzg0q74RQDyGmN1ox51urVFLgBiKeLw8zXo+XG1csJwVIQmFrYc+EQpC8ExsW/nb2RYyAzBIK9xApQl83DrD3aA7aW9WgFo9cVKXq9jHZYL/eiqjtIyAN91dBVwwk9SILIHl1liZJry0crgazSwGPRpUDNO2zJgl5Jqq2Xcr6K8wPkB8j3EctPu7Y7kasv4wupSyeaqW6vjnbaMOdEXVwyD/X1UKx3vSZBEt1wiqKX6YJejlcOkOB8/JfFakWq4QTvyKCVtYxQSAmSmivrgnYIoQRAd4EZ1l11iB91F7BeV4z1lqZYz7ACqV+P8nTWsEYyertIuziLF0J3sP3Kt3QNGO8dF8N4xQUwHjTeF9Ui5xo2FxPXWES3JIvoKgsiusVpkaLu/P8Z0b3DlZ0ggVk8UkbqJRSeR0Em4ZIws46HRUwS+0wSlyiYRRc833P4Aujza5/3WicU96Hev4+fK/ZZ2efAPkv7vNjuZcGx6SMwsR2JEjnruRb04phyxkPADwE9VPihSoLqMB+HKrHBDPJggXNxbPvyThvhoMw0P0K0QDI6FAbxaMFgYKglHmoXUf4h30IYtRskH8VICXNAV9C10CVd5qEgDjRFoCFqZpFlECjeQdQB9MXC6tg7BAmOOdYHGz3jOdgXD46fq/vi8SHADgUTdjGiCkZUaQvqYj9mPxV/CGFYOAoxiQiYpAmSWFXIbGGQ/Akl/QxnNDxE48dFQ8vcuBTjhOanzPPj7AKtqQZ0GVcTunRr6MH8A8JtrLLu3G7nhC+c8nbSM31FFq4V5L4suxTnqkxukOQ6mdxqfG1hr3csp+63hEix35//dXt7sWCwFCu+t1M05zjOsBqRB7U4FeUG9dhDZm5ubi4/dAHDjI5ONVzcw4jE+aMW79fi1OBc/J+4MzHPmRM39iLGrBrRrpmb+8HTDp3XONt/6OwqKzOCey8S1TwYCjVMpT43Z0vNzb2TkxdYxkYSR72hE5HhQONYKIwoOb6BjymxQBmYUlAQFTM3d+8oLluMyhQ9nyl6fmuztZJxQi8N3y6O+fiYj8h8WjQp/gwUEPj/bVfdWlu/7aPN081tR3/+Dy/d8A8nTjea23776P4/+eHJP0VyaNmap/9q6ONIfvJ7Rx588MHPnG40YU+s0za6vhZ96/knxrc2t32vfNva3b//ga2N5rbrXzjdeG35w0j+jn7xp76w/REk5+4U96/d9RiS5Zfhvy9vbTTBdfN04WKv0Zyo+OSAKXLN+OU2fhi90K45SRkTWkxMROKoJmu2X+2lyxL/fvj5Tg99Hm5Gv9uZiNz0tTuhnQkoe+D/beNLP9fdkE+9qLnt965/dNmtj96IEb+Yuvi+rQ1I+1WToxGh9Jc2j33iu08dP9Xc9skPf/TUu/81fFGjue3ES981et3B+z/RgKWw0BJW/f4TVWfJiDssD64Rpp+s/0AP4qrpVNQDGI2cGEo989SXTtFaa+RtHTI/fXztDiI8f/aRe/hFz6B4JcU7xuoPkOvYRiS2Pevm3+h59UenT1EwWooQpJdNpLlbHFy2OSXPz9bcmqn5wgVrvpBqjoROyfXnf7o4lTYws+CnZ/jTihvI1BzI1Fzw0zP86YOhg/toz/zlW/6NJ8AzH//pV+Lkzz7yuVF3R1m19q1/ZPiri6hvn33g7Q+9rfO7bX1LcvEFJzstVHMgU/OFC9bkvt3Oo/LMTx9/cpTiac2boe7MDM0uOEOz3Au3fYa6MzM0u+AMzXIvhuMZeurxJ9/s7i7TRb3YdueZz/x2/68/maCGzb8SY6LNjzeiZQnwNBtwuZKsdzOqTkTdFkV+9/TNoVIjetmD8R4yuEtf9kHgGODJAz4F41IEsBJ04LIUlUWZVkPoymQ/Gi4Hcks+tPU1TGHJWraNrf9ZGz7FKq9ORIKFGZ5ZchvCK5wafC5wf2WobroQJgylUPMmO0YBo7Rl216317ny7u5j/4PcLjBGsW3p1kaeDVFyN/cZ0deph1wVbaHxR3fpS47e+ftboJm3vKUt7qSY0FX4F2MOb3R0ai5/HYOKFvabUuNcBbmMQj3xwZRPjqWTj4pDp4HLQwdX5xS/KagxHQzthdZlEplleoThh6DHxtgyzRBRoBwWr7p01+0SqYxuaCCoVH2VTh90y35XRbTeKtOBrA+uVzOZZ6wvsJMumzFjecwfFMibDvReqr8N0p9u73qjLnPLrdAYeeAK8OpFZnw88Gt+zQiigEEWOdBDrBPp4pInOIQfY7GswjVlyq4RbbLfNK6o9SnxiJ8hJayaiJU8F0y1HpaISymC4EdvoMUIEiogwinI6seIEklT/BrPWeYF6TAoOxdxzzT0P/azQEs0wsSLRRKWlCZPC2uitsPqaWBdtkMN4CpdqIeLTT9+FumC6YaMqYhtR/R+Yn4oaAEdvk59ceQzUZczM06N5qGmRgAi8eq/qBktbwWX5S3gsjwu+Ci6HT0DaDED5lp9IB778sxAeZbxbV0KPiAjkXRiamvzXTapp5rP+BEKcVF+ZCK0h6ca0SUMc+l2Qj1qP0KNfoP0SBWHWFF60esjpRftr0ckNoEmSljWrl78eixgCUIUrtenvuGY5a/3o06wp9B0MlCsFgnd8NpyLA6yNHOg509v5DP1jQ0bdqgRFtuj+wV4yUQT+C54Yxf2B0b65GclO0cDemlZoAUnVEQiLOlUUigfWTJUfstIXe32YVxDG5XgyxSExjVgsTIU0EQoaDQB3V+kL7AUE0Q0pZuW476pAe1ESheZU49HKOsRDROfdPfBjYwuEmNNwV9LFN+TNlLBVgF+iBxbBZDMxC4jD5f3IZcsareeKQd7hRoxn7yDIPmMbBxaloV01TL7mj26ZrdhGnz4v70bSVjaQYiPlYOqulAnIE6w6GvdgWTEv+Qui9Qjv9QuY7xQkv4z4/pQYT38bK/gW1j46eoXLqw+thJwBc5Hh2RmOe1FisefhWzMctNiz3qGBdn7oiYmkB132mYUuVxVkVsPK5klYZdBijUkzeyUsKFRFWL3ta6HLr6EriMqu8h3EcGJV2Y/AQ1Z05V0gVw+gnB8YPWyIODwicHjwqi457aNGCoatv905oGV6CTHqDmKZU9bRxI6tuC0YHXtXJ3taFtj2A0nXRj+lk1+KOTo1KEAofirfPof5ZMfytpH6fTXTp0JAKlF+m6LU/DJchoCb/9BimdE7A3kq06zqZ1tw1/+4que/9V/fmFz2/fedcXd3/7nV13gQ/By2+1Pf/jl31r56Rc1t3351Y92N+Tl4Gzefz7o6uq6Y2ujgVhIWjSxp7eTUNrRXnPbLuJ8PnUanEyj4jMDlrJSuO1pTjS1nNBuXHZrszHhf1pKNcJKQXItOGNxKsuIqwsszXuJOU6hUZl3P3oUbDXCMCarGLyT+WtQTsoSTGXRY/E/yQuCI4j42ukIqRyfFaKgrICa2Wcjgwfl0ZJqLXKU5riljB8Kit8IZSb/Dlc6I/gySw3IVEf1aEFzgZss7sPrjAPhO2EHSmnBce9VJs0esxQcwYjnCxHLMqweqjMEkb7SuIwnPOOYYYgspsQuvpkzA7UIaoncRp8SfKBB7ANZKKUKsGWgVAn2aJQKYKRGqSWwXKNUFc5jKLUCfmcopTcqzam1G9VaTvVtVH2cWr9RredU/0bVz6nnblTP5dTmjWozp16wUb0g1v5Q7DPRu5YVjLV7XVm29N5KgiAXipR2MXKiq4y7KzNtJHON3N0Xn0lKyecLySn1fKE45TxfOO1fiXuDwMAXX4+YLhT+OYRt42XeUWbuC0qcdUO4cH/92gQw/lD2EFwQOOAM5VoYCwk2mEdLIcQBNLIuqdpexpab35V6orJrnCGeH4Q1Jj7JGeIRbC97WtjjGUej1KpmG7K1SEh4rZWwKUwnmY+qWgxGxtlttcDL1q0bt5ZtC0gSPU6actoXEhrbxEvgA5kmbeGkT0TZZsYYEf71f6gU5HaKhkRWFyjO021knR8VqavwS8U/5EbcvnaMSgrmk4IOwVCcX6R8I7SoG2coIi1zaebkkLnjjYcKt0aSY1IqkCTD9F5RbWS7XNvBU4F/4E2vYF8rU0oKdicFq/yzhH8C/oG7vSCptiRJVZPUirgp9H4IHnRoXjXalScGcbEXHCTEjdlnt+ybSEXV20Rapt4mUhL1OISM5unWaGP1bgvdDxUcN5GW5kkSlUslUTGHmqElj+mcWXWbUUOPNEg+Nzf3xyzmRPL0t1qRupigDSESUeO2h5eJRX/3L+c/0dz25C2vXfO25u/hGLqu+ytfv/7yP0Jy8V+s+L9v/8KXkLzl60ve+LHfmdrayMgY9aubg7/yrulPNLcFPSuiz/zPECLESv1vPxlN70fyY3+98WUvft9JJIvf+NoX3vB7X0UylYuSmcTc3Omnnd06PyheObS9pbsaWs+NiYqfnHE2L34+3WhM2GH/4A6In9QwPXwxOc1Gn/rS41tTygwiEKGT/7dtzf9Bx+bTrz7d3Pa9d7zzlRsvb6J/3+970QuP3EzS1Sf19aOf/fUvIfffHp/86cATX0HutX96/wlx79eQu/n1//GJyVfeDMlvptmVS5/38hvuGdva3Lbi76+vP/a/7kHR1c+7+Ts3XTqF5EPffc9Xf+3mjyD5nN/93v2z1/wTkmu+9a/V177oL1unaKIkM0SieBBL1zxG8m3PfP/P/5ClbqLl87/22NG/+kFjzVRz2w+fePLlv/nSG6YazW0f+ePPf+/XFv8Wkq+N+g59+MWvQfLeY597sqP/OiQv/c5J4666BMmbXvexJ5c999sY6/NeU75p0XMPnUZs9Nav/MbR/f/6wx986HRz29uv2fnWH1zdM9Boblv/oZ3/eqzv/0JyibP35eH0/4PkLX3fD7uvOITkUM/dXy6v+30kw+/UXlp63quRfNNte0/9xfufM9Cw5EW6QJu/8Ycv2Xxwqrnt/ldeWXu1O47u9f3w9YvHvn8nkkf+16d+5X8uoaG86sFff1nxsWch+Q93Pbb3Y2//Lvp/ze+e27JA/7f9xoahwW/u3TjV3Hbzd97znf3Hb0c3vv0//vGvu394DMna2rfc8sjccSSr1/9R9XvqCJId7+mNPvRr+5Ecv37lpffc+KKBhh/G8utvntbyFAmG9t55mmT6E0GTTsEJYG4i/YR2s8vbCJqyqeUxP0ovIkBdYTf0VlL6OX1Jb/xVUlqKTml5FMcgUbZkWiibfpAyliII3iNbMvYi426X7mXUQTXMcu9cLFqLXPOZfN1spYMy9PjC40yewCzteQW5by7sKqfUYepK7cD1oBtdM1fZMa9WjshsI4KGrPhGBBP4OfkoR15tmklKRbKBgU1E0px51IaQNVM2JRq0iQmLNRHYjPPNDP02mmQwc9ZmTseZ6lSUe8i4+80sDbHxGDM8Ao5ZcT4cf0zAol/nBjccHoYu/HZCJzymwp174EMzHt/Y1ttPI9j9hU/FElwx0ixJn5YEpl5xydmtw1wSw2lE6VTc7A5rNy5V2ORYo9fYrD2AS7bUxj07hxHf84iJ7MWUdiYajUYrlkulCL2eTljNQDT9iq/zyQB8/589xx2WdNbT/wlEZJgEzzw1fe8bme6+6P1c2bPLm3QEB862H2x56unBKw8PvAY0dYK8R5qEuh//xtmncX2nPfPhTz02BzIFjbzSHcA93LbbXvCG5/1gy7+8EFY/24SYeXrwym+fbpQUjHGSt6eyb7c2LDu+7ek3XvGbVy/9j0TejvPj/Y1ItvLpMsv+e49EMvlmMySSJvlss+HTyakmIjBAE0z+0rn8JFgl6LmwpD9zvZW519Ny24bHi7/zyM/v/kRz25aXfvvwZ784jTuqR77+wXd3//USoKu7XvZ0d0O+CmfAj8EMdk2czh4HyVVZgZjC5kTkTCR+OkCbNyeO4SLQ2x5f3YEdnLC8oppoajVxISOUlmGD7kqnI5RURClPpB1Pj9hKKpCaPn1zcpXC5RpxFTHVZGp7IsresG61ZEm+dmLwuYdPgx83WyzzNpEZV6bOzAgu6lSTnJLu6E1hupIehGYur706NRk5E9RYg8h+p5FpVXtm8bW9F9Aw30SWhBXs4/r1n1wnNyxHFFFahRiI/2Pr7Qzb73lMvgLu9VLnkNdnBM6ZKUkoCvvcMBcWvEGoS8umOfsEoTO3GXkNMkPl+08rI0CA9L9lpKZMw6aEOcIpM06/Dfg/VmYseT1qX59/IvN69on49bknLDpMXwuSCdBvg8yPdA7oooHrdF0Y7B97KMqb2TlZN+8ZPXgtjTuzw/eQm9SgHuWTMW+xtuzJjByr+JnJmhPXl+HSe3RUDW3X1PQQ/lzNrFbwXpmZwf5faZ6Kazac2yEmS1r60dbbo+Lgc9/00CMXKO2GHWJxcAPwkhgy7v4obyb/ljA58GLenOQHhORIDqM7bz+NN98SfEmdN5M22YxEI3LjRZF8cEzb6TvzhD04hJmyWZN2RnEYnXwiXrfj8cyD8qdpbTC8fcFpJ+ZDj7DrMO28nxz6lyzda2+gfj9D389loOzVZbeHwLdlyj0j9wN1fTa/qwzNxU/9/LNP//515dReAhwikdhz+d1lx285R6TtlfnmJy7Btc6S28xcHta1VOGoJSyz29RiQwv3E1xw1N3dq+UxyMLzBDaVO+nF1iHIkOac2olBffjQ6bReKHTuEZ9iXTPCbursDoImRiRb0WgzcoE+m1HKvWx7z18dmC4efXxrc9ufHHjryk8NfR5I033qnQ8++CDYDEIHKLftpS/6x0X/9tjW5rZ/cD73B6/Z8WmUe+XbowfW7noCybeTpOyftzbI0biTYn+tGg1aUZyXwj/f4RSHnYM5S3d1sdKAlqeiEkinaBERT4vNJwpwsT13cDeW3adXFTNXqZs37r1uCIL5QXk4Kg/K2+M99ruvynA9odJ+BumUlS7vwR/iL0FZ3qB9NJAU2vsK3lRaNkIFiUbyZhbbMJXC0wTq0uDWsT0tZW7Y0RsqwAnabesW7QzqEslG1VG4IwmOSyNRydelQfHKstJdGcHhMQqzAze2tlGqiUpREO9+7ihmZSis6MDIHWbRflzhZNFOSGrlcwevfcbZWWxOEWkqQQZn3t3Ym4Itf26RGQ12XRjkHXGRG64mOnSCu0MUKfe5krmXIey0ALkDTEWCwRJyBu48HUFDnTsw/cH3AXGVMhjIrldhOMMelBI85u2POs35HxFWilL+gI8WM/UjOkOcZuQ1o7wuMT4smJM/YsTTacZ+bFFgEfyF9k/jqI86GsBvCiguD/HJREN3aBYsR06jqQtmMmlh3LZA/loUYTFLP8AyF/I7YWa5tDn3owQzztissz+KMaMw0zbvTJzXwNmnTsXz5DSjeGPQjum07AbcOM3nM1ifKLAg2gmWI6zg6o9WyUJXkCxdwMtJovrcBMgfDzdMEzC+vUAiazJltOzGL8ps/Be5DT/hNirt3EYl4TZ8HZwYJo6jREp/jFs6SUrvZ1iP0n/KeqRFZrcORyXLdTjEdTzYwnZ0trAdnbqzne1ImxodHbnzdOYUykgiErxycy/DmBMzJQxrsHeeeGY2JMSKs2if16yUDA3IpYvfKf8lipiTEcgIE7CRZg4SxR4DNcQ/LexGUgwiqWX9xOFIDcrb9YX9Kl5KhQxJiu/c0+v7xyWu2aQZLbwkA2szI026apirgPGVdBRKEgm3Ffj5cvqzq9c8XUERwJq548A1GaRxk8NFJ/fuprY+k69xwfYCs7fQn9295v5KLSTZh0yI5ab/udaLm4GLXtzwbQzd12Qm3IjgQcnKESpVbxF0jUaS6//02oauYEJRarvKCUXLzQ1f5vCHWq5zQgo1Yy9vRnB3I8B6kNCdDSQ3CLG9zIqkkbTSceRHyl4TkGdeGJk7JA6uD5nRO9546MAQX0tDTIxDRWlRr6Ci2iCs/kwtootCEqxKLep+TphD9yn/+JXSt3Pqx3p/7f9rYX4MaxAzdh91IGcQtdyvmQND+N0F9XjntkjeFvFIoOP+OiOHNN8M7I+UmbyPxPmRJCNPwBtMYiCcPnmfqkVqB7cObx3a+T0oDJCgBbfCuClyN6qCT0r3MMIyzj4ItqWGnyy6YzISOaUSpDDj3MnCtVh81y7ofuyL/RHL1fcN2cQQxPs4U0q3mWAoErdF0ni3mcJQ5GixDx/AkNRtxh2K5D60g2cJAXPrs0ye548YAxUXG2iUs0MV8VAFD5WNYWFdEw+WLoiocU+7UFyQ9oVXg8NooQvkAN25LYJeKn0udM27aDZCqUagiay9/ZFHljjog6dz+0iET3Pdpwp+iONBcsw2ugWQmHr8eOgWWqOLekwyfbRU8s1beMLJ0IjUk/6PzCsUKibfxnOqsOQHhrRLF3m4o1IDbFMltrNV05JIbCc9w6QkXT1J7eyOnN6QsJ92eiHRYN0JbK0quYNRfaoUkUMVRUtnjtD4doHf8NiRJtaoRPdWS6zvQ/qu4h6UHQoZEzrYgQ4cDYGbiAvCmJDeao+KW9MPzGUHpDiuFub0yG66BPJrkYA7CjeeYyiiE+J3zagidL9as0IPED5MqG+jeR99emvNBDTjYj/2iBmdWU05mPH9YLfN6GiFctRQ5Ow3ldswzfu0sw8+LeR++OswS2tYgn1mRc2HkQLNt0UJ+ex6ONtJMUew/hGpyxm41Je31XXerN7Ru98qVzjpcuS0vI71OnQukmwjrR1GroKXMAdtF63MSnS7htlydvSCW+9ltZj9CUYT2tvHffCM0vlko2tMABbkYvvdsXCpAJeOVilcOoA7J4XLlmeZPGfhkvhcgJ0zkAW8nJa7oEoEURmDnoeEhzJB5Lgj2qH0Ep+gwXqTkhaRabeOefIAnuQZH+AJf0RItYFnBoWUiuB0W8DTS8DTy4BnTotItYAnA6+FZoBnjsGzkMGuAsdBglvInh0oKbjOHUhwA2ELxlusDRCjLKGlRVkJfgPkvOs+RR9CA4ZvbnE0JlUi9kbIjcQostSBXj3AvYJNI9J0O0o3paZxn8I/6jO64vD1qUy6EiNYETdnIfiqWlRQI2bmftR1B8w5SqCf379fDY7AZPHJ+9XgaCOxYJy5X2nflGAMac5+8Msf9F5Hdo7321F9Mk6Maj+igL1Cy3oEYTLu/Ytmir4QSXfATHKSFMuK2rm23KGlLu4qd/hoBvaU7lCZ7vDjwaHWmfsVqXhKdidEPr0cmrOalizvIJBhk7fgwyArRnaUPe2FOQyGJglbRGo1RNqsuK7WqsabpxbmcCTnroNc2zzNWMeLuy3SbktEaXK0vLYMEZ+zq5zzdQ6fEzCvkqU81NhUXeeHoqQdl0so6jr3eQcQaShYrW0E6g2u6a/p3LVlYVcjQqzXXL1GMwkamBuzuhh5X8vgw9KMXE0MMWyvbL4ROlcPPix7oNDOHrRGri57xPaGHhUIFVTuFfIVTTr+wRjV3UfajF7ccam94MMSSpf4we4ZgZ69sD9aXcs/wAOIPH5tWfqYKDtZmCqCio/zowAIf/x+2sTC0qQLrbGya8wOOr0aLAyS1cV9wBEL9IaUFK7tBXo8Yo9vgnHz+fuVBvmBNvlUP36fMiNIPHyfspCPpy9ZyHWIVN0fSSJuIPUDScMb2XwcWZQm92zCaPIR9gDROn04VA5AtTE/RKophZrJD/VGUMC0u5QAjbUbZAZTqJrp26hc8977lJmNe0R8yAZRMoUhUnohpQup1XWkUgEzO1ShRs0BLe1XZfxVwZ1G3yzm4LBiok5LgT2TEFcLf1/G86vV7uy8asU+AGmVsiS0Y3eiuNp6qYpEGexUMg4cG8+0gbGfki0cipLwhSUaSVjYB4PTGqt7zJ9nMpmzeM4xB7Rj3zvJ+xx8YNWgFAkyKQcqFdPntk2Tw8BKxAGT3A6OBz4IdvCRwJWAw8cvUglYt0YATtXJw6xxhoyk61EQPAXa83Nkgp7DbNFJkKFsd/SgmzgKhaWoLXNiDmqP+QdFjA5OREEkLYhcCiRVVFAkzSXnaM5S6JnDk/SYcjgV2RcueUwM0ifDHDo2BJwu8gGaFKUDVPABKsuELGg3k0+9+OMrIhmTDlSTxs7rqcoSBJ8l+sxBLZMRFU1glsCrWKBzO3prtjyRukpz1DU6tpkJhDoPtVmloRNRLPjFkvSFLgAzOvjBctCCmINDWCg32YlQ4+Ht7dh1cYjnS1gN0KWWP4Stu9wfyYTRkNohRoM5HWI0gBPB1cUchstLxdwHEPFq0pEFjuWP/YKUrSLePqFsVUrZqpiydVooWxBt9PEV2h0UmzBj8bqAsokpb5KYxMzTW4jE8PZZEoaBG6pUrCAI4lcQ8SuY+BVs+Mqa5dJShs4OoktX3kbnj6RS0E4bqlH0ZfooAU/2A+irnS/MHhD9M2NYrx7lYwwLq9XI48AB+WfGsISDL8sgisvqhCjMVURAkxhjV2/kmV404pnp+9U6RbPnAYtRuoBcG9Z7odMmPla0Z6q1kE+XfEKKYVLcGusv76IgvdrDjBEFHMMnXGTLepSzg/HoCzoXYw5AqLMQhGI1IUlIIFTNh1DH4o1YIc4iE0nRmUouQ6hkkMklgJpbGFCJ4UoB1bkooDoZQM3NA1TJgJpCqPMLQKij41PVQmhuIQh1UgiNubTcjrLbBqHOwhCa+QA6aefLbmVtRSBuIlAogEMEsnK5qGulHnmmwT2fPaYIfmvVGSVXoa/Y1Sj4MeUvSHWW9oL4L9P+jg+RmOlHXUFCPTC6jLM9YGynBWNrbz7O1gUr1ylYhJ0nhJ0HwvbmIew8BuRdBGF7F0HYJKytkFIjc1cpj+S18kikjpEM0sVrlYwepI1dN7td5H8boStG6OlJSlrefKDydkn2ifxF94lLNu3JPnHTfeLG+0TO2yeK94lqR+g2WAbvFDfZKa4u2J0Sc6p2p8iL7hSX/C/HO0US+Y2d4qY7xY13Sg5zSIaLuewH0E07VcrSJ06GFHF4OhWDvWKwj+WDHkMs0SkdDKFqAQhVDKGM8y2EFlMRq/IRE9Ms0R2ATwX45KIEnx7ic1atHIDAzcKnx51P4NOL4dNrhU/VDp9qPnyqBD6VtrrOMpHuMnw+k1wTQMpSTZ37z+SaguWaliR0+SeVazqxXFMyJU8z7Gs/Fth/viTzpGpP6t+GbEQFO1yJpDkwFIkaFBowAOJKEqMJ5t2g2GxFNcQQSjrb7Diu5jsW2oaKJeO0G/MZetdlyaScR+/meTEdP0anMqYNWKgJjyNWrOkkYk2LRp14e5Ll05IaqBOCVY56HT9Zi1+wJmEecN9S1AG9K1kA66byTF/ntpdl/PEVkZvAprT0rrQUZTu96yYjyhF45hLw5PLby7A0xGFvwVMSo0Tq6/EpROApyRMVq7en5x8ICLpeMbCjoDVnOkRLS1eoDKuimFWBR3ntWVEcqssh3nfSKKuw0kjYoEYsJ8/wTsKyQWnbyeqXnUTmlUjBSJ2llbFSbYzV/BazvZV0PWNvWyxseReFLe8ZYUu1wxbPIsOWlUk6iUxSpjLJBcDMa4Ed7/8bMBNxP/4LYKZawMzLgplMwMy7CJh5FsxEK5j5Cy1KZsFlAnUV/5nhzk8YYXHR89mdfz67v9T5XMHxLNPzMj6l6UKBmKz0lJb2TE5PafciFwroBV0oSJzSQImZU5pwv8QpnfDBbJWUUrSW7EgpWsdStG58jLp2Rws6pyWd05LPaUnGx+wmLXLtOS120O3qytvYxIdKkf1KStE6TNFmPrDAOe1mzmm37Zx2M+c0SdSOM7zRCTCiVS8W1W8U4CuJ5PIyOCFpvw5Aep5SoBVfjRgExOCbVombVnAlOHoIBxUgKlFE0DAngz2CeyHVQ9ZOWtGeJ1Nop25lpkbuvxYiTYJ7cITw4IoC19GJ7aCXAY4oD3TSkHb2GWUlAB7OZ2WP6zyIWjeRDqjgJF3p5zNY0CI+RReX15bVwk0W+KtW0EAkfCITLNjb0XwGE45nW91VVsp226Xbh4t1O+6pYirYGtyrhJVkWpmqqriq4qpOMk7DzqucNoLBjXuJRckZNVSGE7gDQ+hjUZMWQhE2syxU4s2cBwQpZlFLGUys8KYUufMwcSlBViqWAMTQmKerS/K6TJVzVycfSDExcd8lpkAtJs4DvaoYvVK8ZJVi4hxjYkR0w6iyRSELw41WgolLFhNbUpT6kcXEdu24E0LnLo6JM/RoHpiYyxMmzjE9Cl4qgj8XGkrAbVZpFpZEZJtHL5YkL/yYW6LVLcarC18dLaubAYF26PEt0FMdCzYx5PvBSVSEZ2XXj1xyr1WoYUOzi0zsywrJmMywOZCQjJ5xhnq1Zw4MwV0irqa93b2w0qTYBdr17ynJ3AgTih5rYQC8FFOXsUmuYFcSsmZv4RRYopSmVPHREWtbtJ37goSg2r26rC5GU4r4mBdc2kkk2C3A5aQsCwOXaIEY0QZcTgxcyTGvWo55tfAxr+J+LAxcz3jMuy3HvMge805yzIsYuJwYuPg0Fxa4FL9YEvOIylKTylKTMuEgyMUcn+oiYWpYUlJp12xh+QJaWZiUFG2kpLQXJWnD4pckJUUbKblAi7iktb1VdP4wjKlWUlJdhJRUz0hKZgb/zKTkM8MYkZKulUMxKRk/pTCGSB6KYSwpSjDmMoypX4SU/AVh7BcnJReAMS9BYC0w5i+0KJkFT0GOSMn5QJdU8ltFPSohJWUrKan2RyojGWVSkjX7iJRUVvoW05BWTsf0JZGSikKOgUxuFfiQ0DMlJdUvTEqqmJRULPBRWVJS2ZuwFexOKSUls4SkWpiQFAz1bovARxEhqazmykKEJAl8FBOSVhPlIoRk5gNkDMUzJWimmI6U8dUHzalgOjIRUIA89/2XYomO/FjypbcwTg3G34q5O0V3vPLaXiDarcIE++kKPCCoQy3uBCwLE+pyxHfhcdEREgnpD0vyf0QBHSXZs+/bqHYS3iN8S1jf0G1yn1rb5Yken7u6gqPLBXwUSeMOsfq90fvoO2xj3afW408/6YIUeLnAh/buN6tf779Syot8nDQGF2gR0OXahiPiIgSzX4IvT/sR/dgIvyC0CN6levylJGt8wO4dtxZ8wNUCflhFMGnPXDsZWvhFaNaOBKfYUFRLimuMUWZfTUnpWs1Jd61g3zHaezHhDz4p+TTJ7bIeN+fm8rzOOe3UOa6n0l6dZLOmVCOyAULDWjAlgylJN7FoiF2DO8Gj0p7BGrF3S9Y2mMJ19nUJ0gvdQfHRnOAxOBOA6zRSmiSuGZS+R5puLku0PL8vUadVa/mKiprbGbIC21r2J+H0+l2CHOgljiR8vwOzWN1vqq8H+Iz4V4mkL2u7BJQf3IF07UuQ01IQarFeiOBTktYF2qpc+yPpVHrJVLpw+g/qgydyRZSzhnLchP3ac7scq2rB4S2s54aS8iAGpImGxp4il1aIfF2qcfhrmmA0r2XLBHNmjf0iuNQizWBJ+ezemibG9TdiTkYwL+wZ1t6b2UurxK1H7D/CCGh79zB8lUiAWAsekVr4i+OpMyUQhrXgs5KmN/isBFDOe/156TcUz5fmlaOg2WTQkin2NQagTBY7zgIw9qmdbCOSvuxTO4NpOlTbsl0zqofoFsJUa23fOKooN/gbSQ6GqrSrADpaBk+w4nGhFvythLQc39Zu8CWSlXhmdEpoJ/iyDP6OhSfBV2QPQScKnaW8lm+ZXPBVVghvG+XzBasKG5cKKHJ77ecxgV+T/uOqBcZbZrJPVYlEpgA2gvGRYKce2fn+onQH2ivuXCAL0wfogw97RarXBXYU0vrJ4OvQSGp/YSR6r+LukEpEW0Waknkvgi/KhV/Qyk2JoYu9TTsy/y33xrdYwPcBYh/9AxV8W1G4tXYQqRLgczHeBGxcKoNvSCNfR0gUbsn/XlqUcRnwvYIDLIo3XCCicsjI/bWrpNByyIirPe34ftlW/AdgaEK91KZfsbMXaLkv+ENF2KRPBduTF9jCXULQl4NxpWUwrl6HrlxOJw3JOqnKjmQhGXGBbbMo6rnPULSPi7IvHBKL2kp56uMO/4W2cpU12lZwZdmKt9hPE7VADo9oE6OVj8qW/a34nKUNKIK/lpTaIOjOEJutFSBoUwY1c/4BLJjdhFpgQ7paYTeSUxa6wOxTbXAIxy41ixH71PqunOih1ui4bC3Yp1Zkdly8/g8zmNj1P0fr32GX8bsWm0mrvdanSl2eSFb5X7KrfI7P3uBtWLy38eJd9gssXp8S/rN+sZVzeeVQAy3zsS2YAsdXZ6QZCf5R8nUPsQft3e9H919uPTDFddUIXbtEpEG7Yoe9B1PJqvOtl0OfryaX8/68b/UmPi0kpjf4d5kaj+QFS3X5t+S/qhXLBT+TzKTDY6gIfi57tMNhERM/XEJLUtLARIjgrYAZ8XxRIdK6UgvuU/HmX052b8nFdEKSUr5qpbxA48ZbsKoJrv0NtBgU/8oqELI6Ji5laxZd4MjGvPj+opbek6Hp81LfHmuFnXrbj0RXRZlS6i2Kuv1AC0lBhMsD8Or4u9eSSYhrOtie18XYrT9bPL2DbGVywTu8yAn+ANoEueCdpFQQHFF0M6FJaczREpPU4i6Kzi+P5xFK1jyPTDFU/KAiiApNhudWSPuPV9p0QEKPdyO0YkbWPS19/0mMg05lEfxERlA3TGhO9KUeeUTrPyXDuAgoPYeUA1R9tyXbHC3rkHcG7/HoaiL43zKSoIRE0IABvBP8B2SkFgQc0KHU+5hajJ15YA0A7C0QpjL1YughIyr2Moe3ncyFKtOZvH2rSg8YYIgNwjf52/xOBm1r1OX/pgUmYKPd8T6ublTrSca0QfST7qQ9DVBoV1yowLQy8oIf8jUIPQXXcfESo+yKb0b8pozx9UU+FDd3Hd3sYqu2fgZMi/2SlsGo4qXtN8EQS/gfk3ExfBUbPabeF6r/GEUdRn8VnQnUx05W5RX09V7/biWLFsCdtUA6FlvxspSgiABNUS8Z1QoiyZNu4ZKAZXvE5MFMpU+tDwv8VKTgeRG0mt/rEeA8JYOf0h0SQKdDq+AnUnfUgh8hL6fz9eDHlj1BfKlivYaZs8R0TPtrB9S3MOtrwRtZz2x9vIQ8m0bX0DoJHbRXr2UWj2YlmGEpRDCq/JClOIQO17YReTK4V81jYt6plBxxDpKHQXIauDumgWmVB0dI69Q11aHIs66+d0A1bccQ00jraad55Kss+N+y/nCYs/rZ2ul0lJC4gOehwMUhYdr6w2GeFFHtN5dQBmTZYZ4UgIYjNSh+lQ6c3MtIw70wxA7L96ALti2673Zp1agrVRYnxf0v8B/1UI36SROG0vH7JeRLEUsltXoo+DE2JfxKCF0AI9s6e8AiC8yeJwJX+CuwSLMxF61rwbu9npiDZqblsMJBY6lEtY7dhRKm7lNB11LhP592mvnGO1mWEQsdLeF57p0pI1WoBYcBpOYFllOiD7xZLcgVvVnNz7tbxbQFdWCXpS2eL3xLn7DPP3+93fykYa8l6NTMVhLbK358KBs5r/B3n6lwl4gFEtiAXY5ozVnf5SQEz4PKJ1bOvw4ngI2pRWcjmyz5O3o90+Hb4mifZRPsqmcfjuT4lQu6gIw8eZhmRS047mLHMFLbruW+iG6xabvKIXcguAskx++SEMjMHuFl6VN97LmPrhaJ2K2T1jITtWtrVmKg2Vdjl0tnuBb43gcI/2hcZaCo/e23vy+gXxa/vEtZ8Qt3lpefBmf0Di1MsW68Xfv8q1lAJTc5ezMCJTdy6g9vcg4wssP1gNxDu8mpP6zly/la/qFURHiL/2alHPj5GtBinbM3cvdsh+RtHTfhMsW4PlL1h4cj7+VDiQ26XCvMCH1ABH8m2XWjqdQMldddnjCSeKkNooKPWUoNPA7f0qxnjO6SVfPgCI9CblS3sDmYlvWHhzc5B0hm4g3KYUbcbih5ZE7aX2AJ7d3OJub1h19JnLL7EClvE6XGTdIwnLhdHM4shQUdQGHWFAtx+uumY5e/R5JrS8dMCUYbjhmonTgcqkHBptoOU8XOicg9DH8AcAJ8YuwQyYLdw9ZWexM58FebnII/Qt4yk/NJC3VQY5MMWuf0IGZXvx5OPNXrInViUGj1W5EyfyNqwTGlnXVO7PRmStxl3j0KWubEYP/h4Rjgh8iNCmT46xzh84ddyOn4UGgfkOIBjYVy0BrX84DsQA5jxCcid+wQhDbaHWOAyQ7oMx3KG6lgRDOCaUrXOsLYeifiGGn3rqybAJiSJu+j0qAeQ6wo+BYyc3NyCLcdwPJJRgSKR9bNG0cPXkdqxPR0x+hBCpch9yStkduNxN/J1NycuEFnn67vJVNUm6MPhR04gJw9SXe5AdXSgJrXgJtpQDts+i9bPnTXoT08sfi1+TNzcyLsIJhxfN2RKX3IZpPilprXjNT+IQY2rdqbW6Ap2xv6sm017oh9jH2nbH0F3adNC3C1JfpX2hPle9+g8ya3/8QwXD1V6sExZQKdr8PCcp3zini9vHXOHlJUiRu7kWRXA3UKNYd/5T1RsfcNumjbKnJbOq+LdVwxUXM7wzJ+BrBBncEKO6t5eq5yJy5uB/VY5B6MurSPlK+l9RkUyYPDUWVQH44W4SA9OBx16kU3nIDDmbhE6WCE0PX+weFokS4PVg5rZ/BZY4eixXEBR6ORsq7orhuwXXRlUI8dGo66tNLB4OioeyiqHIyWaV+XDg5HgV48qMfYycYhdO3gcLQYkoKDw9GSQX14OFo+HEoyF0Hcu7k5Ubeqhe7BqKp9XTk4HLm6esMJctCNJn3t3nBiGK7SDw5rxPRcesMJXcY4hlHUx0tHVw6SDz9UUNrhnirqKSTk9GUVN7RYL7nxhA70shvwd/GNJ4aHUXwJD8zVCsVcXdZdN57QXXo5CtjakZtglDv3bKc9hsBmwAWdg1vHQke7gxJf3joGvKLwIOlB6c5BeTjsBNoalIcPhaRDPzcn4TBjISCXvjoILfsXw2ufztWjghmV11ngpEg4/TXdCQsmMyfAbR4Dm6hrRPfap4BLFIL3KZZf2+Q6px9/Nh8aFC89gZTGn+DQobATiT78qQKNeescmDZ66ziiS4qtdA6Y9JCvO7C3O/fAiOGVF/6k2ItRADCYHIYx6A0nhsMOmqiWYncdonlUfEKQ7fygvDOtkUGhHUDNnpkRFEG7qJyDxJ3PinpUyKBS9nTEuFHuiYptWM/LzPXtcXp0dOQG7e2hLjuD4qWJ300qFeUz5W7U2afre4Fai9prQYXeM+FSV0t2jO3safnMDS1P8zCoy/jKa0d7GTRHQiLnrvZz5K5DQDChO4hDvthrP97ytbsO7aFbH48QqaNzgIwyNXcnBUFz7+QO4NUe4iCQHbrJQaydG3BZQn+u7406ekldWumO3iiXnnHkNAl56aEVwn9pcoIVt5Oi9oyowb6I/uUXRI8mQHDfoi6sc24J8/i5KaT4Vo7ugIZbenCGLsUx0QVC4A4hFle7e6KO3jfoDttqR9JqRz300dwrEBwduBss2aADxPjCsUPxtLqHyCWpc1h7yKYTP3dXqNRB7Qw6hyMHQSnrUQeFUu0wc2I37Vx3kMC8wOjfNaNSdxCyL2A3o18d2KCFdc5m/nw//gzgz07arIdgUyQzvchrb9A5zFoVcbQF5/YIE+feTsty4vbItaeagy6Qkne8JZwby1IXgDY8imjYPjGmVI860MEiJoamu497ptmPrdTOMALBE8bOD6cYEl6WcNINyju1O7gVEyXHDh0KPYptGBaBKceg8JRrIXng/sNiRdmCFd1BlrAhmCMFPqcIkUXGKQWgOvS+CGRIE0pWK1IX63ZCBf4E+FPlmQw9PBRI52rwheifM3aInEh6D5k8hT/efWI48m48gfUfS1FfB6E+LQ8NWxf4ReOSsglLAF0acyS1N4zTE1iMtgl8m5CbCSdDaRbMLKGzp6RyDqpU2AhK91TkLEhujRYSh3I/mBOvIOzygsN03LhjyWS+YJgEZxkHkq8i5EYlnbQkzS4V3RNT1h5ASTsP/RYdJ3CP9Fu2oeCG3ihnnkUzTGeDS2dDhsx+y3nYxfPhQL5eXUv/XsCrmXU+xLicyOyvSwWvoUbS5aIA+pUXRdk3tiFXEOCo0TpVuZYaufYaQqtDQFSHsC9Isw6Ijj3kkvcUrW5A1q/iD1A8cu4i5ArYqfhxqRuR9zJbSrSWYmW+T9rBjTD7NX9wbktX3bauwgzzl5kL4uuyw1J2WCRKwXiUHY/Uyg7G9kqrl9nXIvOaCE7/eSLDyaQ7gXkRuCTNcCH7aPHB7ryGnIxlhGot/JuCi3+h5W9FMmbZ1HyWTTLLBoyeMmkOoMfKfbcnon3wUySxBiLNnn/BQxZayW/KOoectNnxWBj8pOJmpgVJxYnrGx0lNORiF5Bee9zm3JwI3q+0C1xIP5pCQ8zNUSQMh8laOmVdusdeoK5jfj5n/8Lr2RxFFXTXOVVuMLAMs7ljdOQaEukN1Fvb2WJ7sJMrDFAPfjx6cDf14N45UbPYCAfL/JqOOXfH7fx3d685+jTdQLg4dqi5/pAQmWREgAHVsAyoKfDezqC7zoFCi3ZxtK4V/uslPLOCmz+IVTg4rB3iTZhFUfSc8hUplxJ5g3qMa0SoMcxNxIVtJn/Tix2iOmDeoU4zWVHeSCfgbFrN46r9LCVQms9il5+RoS7+Ugx1Rws11/FMRGD5v8tQl1OGumMeJ7wAdwy2IcsRl0EGlFtO2PIzMNfxK6k72onOMrPNvWl9y0ZfrPmOVrZ6Sv0SbPUZqJJfYISn1AI89UmKo0ZhC7W/Jyr0vkEXbEuFhKku1OBPnhqbVKGP35MqJIaqoWqpdEIcioKUH473z8lvf/yN/y60uv0C3hbBn4DJGle1QUIrx9Xtg4A9mz+qasg9QkzgBfZqnLhC1MOu+n/ZexNoua7yTHTvfaaqOlW3ztUdrWuHfU7EenKwHKU7kY2BWPumdTV4THBoVtZbnfTw3mLVdRKuMG7Wiqx7CcYoCQHFdueZwUY4TmwnFlEnDO5uE8vGgDqYREkgqDtuEB6VMIkMIBPHenzfv8+pU3fSgE3oXpjFVdWpffb4773/8fulzHHdwwvy/h68L8+Par57Qvt3j+ul7x6uv3tMV+8elHePlO8eXubdA/V3D/XfZd4veXp/+f4Bvj+t60MG9tJ096b6cI+rWpX3UHTcpwvO720a8jMldTOtX7N/V9Xegu5Na1uft8Q2gcaTx2Y3Xn19MQxoXoqle3TR9X1aYJ92Fa3pZ76sbihGeLxUGJtYu4lK9IbigfqRNiXvYkyUJC1I/rZlh66hBPwmlB9GedudvnTPrl27MOJhlG1RcdK+Zr8dssOV4sSOlh+HoWVBPdAatHbjb3t3sca27HCpcoF+YUjUEV18uAnPu3hjyFaqlhE7jNcMtTFdamqQwH5s+nn5fc3uXcU436ra6yLT4+5iyLbsGmpODNtseXUMVFC2ZdtgYTnQ0La8uoOajq70eRxpJHdjiewINC5yGKev2S/lDDUlmF570y6K5TV1SHl49VVk9GK1GRZTT/8Il+u1N1ANVmgw3jfkLUI/qV4e4/6/QRD/j5J+LoXyRGPDUT4oalVtZFWvY1U/V6T9qk6yKqvzMTuRj04rm96Q5jXtynLHUKld2UHti77JptTStJaqOPI2UZwF8+Cd85f3z0Iq8ZhmFUhQ0Kvgrh2zozbGbqgUMoGlFnBzQS5kW9Em7Z8fXExdi6doW5BYObqNvDH1TYW+hkMMrb4Bec2p0AlsNh34/cMvkXxpe9VJoW2ItQ1eYwH4Fb5mP5QpGTjV7Cen9kMmwRIWZtExf40lL8+CUP8UZG7NT07N7fc6Nb5asfG1d5R/p1GE+BTKO6LBsZ0b805NidMRxv+wAb/wudiE8wFu7gUtYo+3hcpJkt3rfWFq93mTX6sLmosM0OkQAUEApYUA17zx6im5yJo3Xp2mUDsQkb9RewlYYAlD1D2PRq/B38GsYhqKUGaB+oLsgOjA8lLqEcnXLKaVosWuL+KP2WYiBZrZvYY6Pdyk6F92L7xitWhX5BQVbo1sIg4mafT10mgc7rY68tsFV3/J1h38bwfLN15XtNjuCUXk+fODnwPxJFuqHRrY5nLvvbZoVu8lorcOUtushtM/XfPaJV5/3IIVn1kkzW7bsukNmI7X7EfCAWYMb2IyvTpC9sbgWNfLWG0eAr+jia0RYldQNVh9S7lNNeTYGNZEtMn4CxrTF7cLlUgrb1ICL5sngrFs18EOXCwd2Ogl9hqjgiAQ0fCizTwuexCwmzcWzWoarvHpliEW5YlX4cphEdZm08buhOrZRMSl/np87FLfl23Sl82L+vIWzLG8JAamsG9gkht1nUr/9l8Gw/PJbr3rB2GcKzrrxMXfiPkuxHFpaIN1j71LE3YSSXoP+8/dAJmH6dLJVIav2yqRcvTBUPBKFVzi7P0mLUz2PjgnOw21DFt52SxAjxXc0RAz4TbMINH0qtV5fPHs/SY3qcc6i9y7Gr0LmM/O7pwJJbdKfFnpbHpaVTEbSxG5xlaPlBaJ61jkGnD3BgiAjVwouXLwKLUaTMe40CtxrGA9Z+BLIF7HyOJox6fVq8WuvWVJOWbzjnx2wL7H027b+oOfUGph/tYHiqDEm6YlMpzF129KiMv+6XNuKiWUg5dSiRPUnvESEwPmc8wUiiuUWsbl5WmVjy0Wq3/lpPJi9Y1pPm47dgwU1LHjlHkru2hfxrYdnH1j+Efl421TuqxEDJFi7ll3dLhaq60EbIicPru1Yl5Kj6Vto6FQaW28W/PGrbwOWGdUqzPydUZ1ynQ/O+eOMOCqQzMawlGRpT2Q5VhSjfbVhIPVMHByPhDy2yjEc+HWTlh/XUImBl4XyKJa/U7n7UWF8qhtInmOKYh8eIBv1umcVp6tzC45Oa1vyCdPu9dF5DbOyLZs9w2ul+bj2Focit3ptZcRToima20ndV+41Ybui2rWxVfNMf/JhXBJSDuG3RnLJ0Wp8Dk1C6uHe/mOKQKWjE0n/5qeTbELr/MWsbHpc6mcxDEbZXcZevnatdg7ZY/+iYcdHZANlN0GXJEBN7QW/6wvxvk7Pmf4M2kn7DlQ54Ck83OEwCfIQGJzNmiOxxVXb2XhpG8F7Nr5wdX489paRdvyc5zOG/i4OZ9Av/WufIwzt/psc/0G1s5dmEfgLNvMlQsD1PnB6+Us0b4unhIho/lYneHXlJDtOJ7wlbwLD6Nple2jjyPu+9ZHKhz6O7N72Pefyyfwz+tkvrkGY/k4s4qH1+WxHYf1bXy68VOSc9cv+M/OucMlqkX2h+bbx11fJfJTnUC8wqTnHSTymFb5hO/LNIJgp1U+7gu8ukOtgACoo+/8EUGQXPrjy3f79dLtN6Hbk3bMplPT5iY7vmva3lCMOWWz2f0/7XEMHvEeuRBNW0JFED8NxEv8vUdPz/u78UGvXDO4BfHbXpa4bZkSECGlD3uoacvc43r2Pjv2r6nmQVZtRBa7fUEPhNIn2JMPzoNq8KxPXL9rGLqyVwpbVrsPzrtqW6GnLMn0nsDqKbw6ho3MM/m2QCh4b5BPgKu4Dm9cuROgvldyuXbbMZvdd8O03VVM3l1ETnK+T9munbTd/a8GdN7XmQDcuIWgnJ3zgz1BPskRBvlar2p1R02vn+lrr7YR8rtzMcCKlxN73HDajrKaY/x72MhWPGKKyez3+OiEyafw73GD68NQgRNjAHNb/GQpcrlbccpsm5srol52H6qHfmatZd8OsqZDRpZrr7R7gA/vN3bccqoMNTJr7eS0shM2mppW9hwbTfkllnf28R2hqr38e5uRd48LDSzInEil+/nluC64Rid0UfZ2S53aOGFaFnPs7uwDfOmop5djoJcByjzcp8yD0uZh0t0R3acbT5cH5PeD/P3Qkt+hbJFW7tdpPmYTO4GrOcENjcv4QOBv40m5jbN8vB2n1U5UixiRDjLirrEI1mjlqQ3yNiKa/T249xOi6nbKdm3WK0Zm89HqpjNy0xm56SSuHP/wpov8HR4KJxik9QJy0wWLCiGTTCTPedmXgXC86XC1JP52Dzb7DWLmF9W6uFntXy9MddPReVZtMnvBZWyczRt2jdm9KA2FcRfOEGC14ZpXdBTDuz3gFgAvcGqN8/Cnz22wJdcI+scxmo/b2D3XBTM/ZMfvRhMzU/kQ8Mzjno0RilBo20Q8n4Q2ta7tuY2zkW2kCDnVmHnaPhnB3JwpzFTeFLDfWDbpRuJTI6xmYYZx1wsz7rF36nwoPaPZwMBrw2wx37ods+M2mcrHIF6L29rPzrmPq60+Vr2Ne2By4B5Qtr2lE02rfJICqFCYh86Uo564B3bMTu7Kx4i4uIXximob5eoV3tHwROYGOhdUyrskKu8WwcXZGxdMtxjadNHdEZIFpQlCwvfHp5vweR6z4+hw1/3A5Tgmbff6qRLrO8XWpBEnwjFEkwxMHDR30HpDS463p2RS+6RcCrt/fr8de/XATRTyKvaVgtUIzw9+Dn9et+SWodUmBMcRnh+8dunP4DfY2rb6FfTTi5rDbeebw7UW8loLea0NHh+h6GBxteHvniW/495le7x3mxDIXeNymrj6JExIPOHpW9d6a33RdE1w5Yg1FogDuj2lduxuIv8MueaVUKfYoW0EgRnewX+aM6z7YH8A1DtjfWUl9sl4DrK/h/j3AP/er32H92np8T1agDDL7pr+nJiBKo/7KeLbt/HvAv/uMTJHRzWg3pNZRPl7gdevpbx5nB04wb9H+feYhv4nxLEunTnCznRt4m64tuemEOJAsvOUa40nvqP9XuKS9eSH6zLkJRvykkXF/HvE9xDXJFNj7Kl3b5+8dpBFD/Gv9Op+U86V8XPlYaX9qhYMIObiwre8Q+T2JqF7mr/IfeZEI8rsGZFr0vXGqW1TeZuZ6lnAMKPrrV96DKdYuz57RfDz+bBTecPLgtJsRGKS+6iIbfALxZBt9AhpykgnJJyCa9oWYvLOFQ1ktUhccxYmmqk8scNM3DF07ey1ecOLhkD+V6llSKy0AiVGjwhPPA6ZMBG9a/bypD8FcDfv5UPUKiRuHTimxK3b2jF2COf0n/31s+FVHXLZJ7s9XpAN+Nzs968HTI4lAwp+zKjp827aVYxNvxmTcU04j6jsMTs2zclZAC+ND7vB5I3fnebA/h27mzl6mPSN0JJTHPWUnOKzqH/rFBO5agFPjzjQpjuPPjdbZOtpX5QQe9UEPN/lXLJ3kURjlj/54pFfeqJVRJwjTlB9dkqUrNQI4ysLBEXbQF2cyHaw2TUdVmvDjinYTIm1h2mLvHQJoADpqTUz1WJp34+CYs91bp+nn4Yg7zcuoxaGOoBwK31luEpqWuVjqBw3BbMW9KtnZKTvLJBvrrMh4wHfjiwTbiHuLWranxER1PSlgPjUuz/yjvIAPRrJGRDxDODfhZinRwymEhs2kk12NMrHar0FALg7HFX7/aA0wc3Nao5EfpceivJxjIibOconbdN9XQHBDB4MNRY/st1tRTJVaHdcXd5hJonYNuE4ZehtFpDpIa3Z+Pp8yM3b+Do3/wbuxQjW4Yr+AxJHwzY42za+vsLwru3ECDsxmJkrotpOjLATG3Z4zg7hLgjKqQ78VoxEim1trREkqImVtyRJZNu2yZPu9BTGDDBRTRz5Irw8vDgSugOyBHs5a7dFdtKOQ+7AQRfla3nsRfk5WN16HV9X9Tr2RT28x+VjPXui7D9z5cPqh31RwTW4JyomIBeE7mjYs+dYNnE8JAGE5aKHftHDnNi0CLzlPMSkbzNwg0p2s5P//UNfFQDxLTZwQq/WzMwRZOJ40OtzNocvFc7GHQ1AMxNsn84YJ4KyfUiIaD/Ix8QQtfDHH/qqllk/HNYqO1ZWdjCsKjvMwRwpB3MolMoOhlJZ+pH8XMY2SCf92RL27Ln9ZLFS50K/zr2s87ayzj2+zgVfZ+gO1CqoOrWvX8EBVnB/WcE9voJ9YT6GyJevKXF7OSxzUhPAL+VKnh8c5hQdCbwAx9IHlyntB+1n8GCA+kNIUiSEMTvBEpT00S3Wen8AQiBVQHKXxd8X5JNms9ttR2ZtGVp6pRxuAXj68borB+U1OynOMQvS2GKFFKYxKM7hRAbF2vLH+w8qaBSMkOkehsZuw/04bic5xwEuyEk7irSiTl0J7uyrqsdbzSa8PObQ/cH6cJ8jvEj7CRLjWl2SxbRAAYBpaULoBR16luKESTGiNXZcRrT3E8pLoutFErX5OOSkvrprQBKtuH1R656ubcGtn5GU9W2d1n1XxiqJNxhop410VGdguXAPqdnKasEYpo6yLbd2O8WjL+LHb4tJX1Az8vgqsRZqj4Ez2CPjzicuKKwHk8tMgYdNiTqQJ+vzQU5bz+aRXe416NhTOt6IJhA3B4w+42L0oV6g4zbC5vMboQmR07Mv7c57uD/8w5lQS4RGxZkI+jYbG7gNM3l0+u8ad8ksfNq38GR7I5IZqVIzaEuk7kqpKYWDnL5x18tEbwTuZms72cxALnjIzjlAvDYC1PPRd/3h02rbmXSJVTavmGNGSwmyRbj+VVQwmP02nm7t3jW98YY8PvNaMcJ4+gPvfOvnPvnwl35Lv5rStQwgOP05L+kNHsHVpqlPVzqtbHwDjBtT1A/URHOEW1fCdf2dWpluauP0w4HRuwOPAiJujXp5h7ODl97Q9wZ48KC64Ro6YJ+DBOtWXS2vdf0LDe+b1hCvtMgh/3PYE5fHiDYkfKOvKIrRkZQg2pHTc94xUV1tT+XuxvZx0uo5VPp8slM8wGn7qvn4P/jgQfUagevzhv7I/cbzajsPZ2Kb6GWs1VCmuDc/r+gXRm9e9+aTCprR3+bZ1ygMx88bgb6OGTUD4j1eKO/9t8KkCKiDz8pZmwXGhM8BDYraKsKeBPSPvNsb33b+Ufo/AmPEG/xU67bwytq6nfxYuW7hTVZNv5JhR6p6sfuWQpWpuhcaP0OHxPLrQbVLlq9yGF/YfAOWsPraeGu5iAzQOYNFLDtTxRxUGb+fg0NOUCPuEydVfV1PfgzrOj2wrt88vXX95sC6nqivKzqEJS0MpyhYtLQ1p87uW+D5NzBlATSBwYBrvZ8ahd/eYoNdi1a27vX+YPqU0WW6+wQF3L5bkUSUcH+SWsJ4o3LQQZyX2w3H/i08SxNCH1Dk4mVifH7gDQRuIywScrVdyUvEp1FTW/OQN/MFCvna9twqIDJKzNbKnXwwmBP1JIsRUM09jJxq7l/gpGMyiIX3imNAIGBkVX7hvGydqRWaLpu1gVv7Rtvs7XTIJkqsFj2bQw25oPFjfN3OIpAuSkKrsqfInOa70M9eLFUfxPaHv05aZsHi/XkOgfxyD7kb8LZMSmS1n1A+y0Kl+NXO9IZipY0Jg5C78pUexce8SvsPP278B7gVp/cT0ENjCk2VxDgQ/IQtMrh+rmUEtaNgmblOoHU1O01Gy5TFCRu0Xd6XnDvzbwCN1lMxM/lfCQKHqsWZYKBd3BcECtBSDl0QlLj0rS8x2XwEv6q9WkKnkVBqr85u10D422QuB6oGoDMCd/4mY+XbNZboTswFb2ApR77BdcxVcvnamgodaMeEW/sQMIH4hTw/VktDIUxo5zVl0jo/+yf1XPY+Qbpj5gOi4m1QWtxHEHWX7TO8QFFlQWDV1wlKTugv0NBfoAEu0PI9BLgzgtvfoSw+W4TUNbOWC2bvw+9vsmO7dlE8AdYSGALkwHwp5Z0NShfa/RDt+O6lW5kagh2qF+t3Ttc6p33ndL1zRTksART0aVlWftG7+8M24mfSUrqrDyuo69BhIuxgnezQlk6r3ZH6l47WhowWhUrLhs70RGmuszuJUBVuUIYqFs4ALAfKIxXYriRq6Erim3DWEUbisinQNlCnGgLcg1oD1Gq78rULsu1y3CkBm2BzkkFmd5oqQzkYJppHPBUIBfeIP3SnEVoHPSXuK2prOG91BKXlt48RtRXuEngDDh0tvpUSGjLXDomA2+VmrZIM40R7SM0OXRKmYRqGYZqmaZDyv9D/Cf23EP+pMEq1FAwNf2SORUc/dYWJOqZmCjWVa7cbYDhTeSRHZ7/Al8sCQI1lgSClIGNSZyg+UEmjcp065h/DWJX74TkXzBTJVN7hWWORHjiZKlL3V0rUDKn7KjG5U/cEUHvpexo6vWNK/AcbcObJPmLaZumGUjXSU5701EobSg1QnuCHkPDUUhIj3OJ9xYjslpXaKpuBcQiGo+UJ22X5svnjbeqOqNmhPG42TRP/6aYJtdbNiN8CPg+bzZjJdh6CZROuYkjSFF7nvg4EwwbUJg04P3acyv6A+BBvmlb1fXPDT3Widhc1fE3PuSfoIRE723Pz7s0mu12vhWvAJcra1P2d2tqJ5auTfy5kimP9QzDIxnRtxKESuc+DFBa9r0kqTvM2T/xxpB2zr031eI66DZLP538pmlzd59XWPLIJ89nI1yK6RF1JbVD/+25cgdx5YtUUsmJVakunY5X7X6CbdiN1G3IlXRSsOjbkN6Ekc8CNwq5cUbEawWZ/MXOEPRsJZGjCZkSYSQTGI+aPeQlqhkyjrsF0aK5V5fiGNDuCQ2xa5aNOcUdHcgBlAhHm9Far3Lor5kr7fCU0n/Y9UYRC2HLkDzgn4hSCc2K0elV5Rbx5mNZoUrlfnBMjo7ilnW5/Ksc0UvsZvPf1d2kQB1JrBCteDbLvQYWqo/2cW+VaVk0hg11ZCXzzVq+iP9883FpbZayAz25eIbnaJYcwTvJCuXf94dOP6u1nMh5fF6V0tT8fESe/Jro2Mt3aDeeS/flosNmO2vFd+ciZVw0GdmT63X/4NDQIj57zM/zaAlyF2V+MTs+/9bXQobcqukTrV9BT1Apq0hyVoX7KioSZlWFEAo94Lex+n3zi6xdvP4s1ZF0cuMHAcc4zx/N+mjhG7PjuYtQm+6dP6rcUE9Pzb31Nx9hRO7ErH7HqrJpD6pQMOkg7IvEC2flB42rxtLTKTVyLJPbJnPv6ezQcOfPh2rhNf9zD11mzs0gcRa2zGrgpB574gZsrOmp63g7vL0b3FBN25BqvpMHYgdVx041nO2imzR6xE68VNUt/RFcIF33addY2TU1hSpvUPAaxwkYym+3INBwpUjtio/uK0bfa0RvyUZj6KaaM5iPL3UI/2WnxxjsO5wyxdjbsyI9LKg1c8SP+im9AxFgDj4gRG8MhctSfTB2ccdjJDTtqR7IPmovLl/H1Q+blgRJ2YRRqxIYducjje8C+8xJyF2RD4NnZcXpr0SGAQq5sm4KbuQ5pSZRcqsA0v8eQy2vDrsyExq0zYDwKXBcbVA5JKrbqEjVlYyDIxm4K2Fixu8f0sg+bQrndM8Q2nZ/pJLZFdJGQ5iakQhZnCXDb4ugfzczRbtqC0uk6p3fSDpr9vmZ2c8ds63mz3UylgUIJjrCKnEo7IX/TKcbLkUV+wAlH1zyb0bGmVptSSbNniRKNDiPSZGu/Sy361foel93FhY1uNOpSyGk3TU+aRq1J3GgR22rkzXaQ4no+gytVavWOBKgGfTsV50iGsWQfdxWjV3caQmjY4z811wFwYhu0LrSGPD1ssYGU1DguoITvr3mVDZvT2hTghWaP4NsrCkNDFCB6+VBqaxJoockRcTQp5AewJ54+MLrUDsFjaT4fIkVAd02eqQkAuhYxcWM4baxTdoiIknu1QEq+GnBzBF+7hrgSdFosdHa/wRwjoDucgokcQSjbpwojmXuIgQpovWvK5MFETxAVcnoF66RLndcoFCWsmrjPUTYyFEMKcTL2cpXoCbzhmEG+s+m7At2cF+hhJjOs5DPJU2Pcq2YqZYwL5sSJmN5ty6steHK7j37r7/86eMNKig1YZwD5VqLb83eLwmUh7FvymoXh+LyRnyHurxLPAAkcSC1g1Hx2JKb1iXBMd5S761bJREIplz4H1JyIUQStix8k7O0FsvOuFbT1fjkbUPm0hY5MepaF4KSwVTS4UG8bzLT2jidW+wgTnVMAOAkl7walZok9I0jZotHCnIqbG5D5kKsBdFi+TWyU1DbT40YH856H7yj3ufOyB4zAReIBL+32te7gHbq36Af35OKi7lvn5Tr1vhnI2YuhydS4H57pKDcBvQ89E91EGSkDZhcvBjWOVyjDXTgjeIEy1wIF5D4GwSLFmAWYNnDfOi/7b5KKxn0EH9lpLNaTt4NCURJVIY9cl85H7j5ZNVETeOT//yaUuN5YnwRhHY5iQ5p48vYSgNoj8COED5tI0w/kEgakSKWbjMUnn5OPiku8zrTuU9zS6Zu19qKYcaHPE7ETVK+9qo6Ev7VT0W6ZXBwqOlOq6KjsC8qtKVMWzghsYn0fSlYHmevAhrOYgvT/EpWtVW7PHXrrnFVun//3wK2G/x7Cv+nNhuIRFCPupLoCATeDql3tFubn3MKDSBBfaUslOc3J7hU+F8ql0KvuvERxFlx8vTuIb8oZZhJc2DznFg4GW/HxQHAVQYjrbxnBXL3eHeVbZR1VpS6QaiS86dLFjTI1ultzvTu+7OtV7f36Qp975hyalOcjp1NBYWeeEsJ+l4nSAIZ60KTzBCCxCkg6PwpTEr2ETna3hrvo14bDufIv/bfiylU+OP4TdwIv2OSy7G5zL6VGXVBV3PPJLJMylbaCty3MV2aN45fe+CAydaS/OmKGBQHlsKrwSaB9jdxFPfoPXdzL14D0yy1GCZu+BTad3UHnmrSX08P68qJZlrNNUFUrLLWrLRw3RYsjEkCkFrSYGt/8lSDfI6oe4Ix2uW2BEFv4ERnUYjr9vFTuhpZtQulc9qNo7egkVnEBm1Znj8Ae3YndfJ45jRDT9ebyCxSUiogbXW8uJxyVnJiVhlFfIBpGvDLiApySAGuJedVdDkUhDpgLlCq6sHol7iXEVhbfaJ3HcDi7rkjcr/xZOCda8EguJg4mse2dOVMo6PJ9exUMtbmuv+gvsK77IezIiDdfLF3fIll5Ly/iqsv4xfuUHdSzrkVzBZ4F19mg5xYCQATnHQwISRipBh3pxE60Gh0rCdmNz2lEDwTNN2Q9qbkkOXQI8eqU7czmHdtGzo2deVvi4h9VvezjpuhAcdbws5vy7gLYNJQYvFQQprVWVro2Nn2BMvWxJRtUIGNLLlBm8dj4bGBsDZu4sBwXz5tlxgOOOZeuOVMOqeHm3+Becr0YZ0TVfXk1mrwciNMpBfw4T9y5+RDX3/2jmnUz2zvNcoG7eJX2q9h2iR6ZuEuu7bk/vUPEPATkOjgRio4ndlP0+tjSgaBFU1NoM5ETJKdeYDMXXNcjeM1mCvtbMLXw1o6tyT5hpHdd/IQaOi3xjQX/jzyVJ0/+0lwxDMc2ZkeZAh+Rt92nmnlm18DPVLwv+n4Yi5SZXYFwL7T72TmC2Hah94VPKP39qOkMR/1/Q6PdeGhoaDTGFxMFo6PNUT06GipJkg7FdjI0mo4ODQ0xOdtfqJlOsz2SSuzwuPtUsx2l9SOmrhcfaihtgnBtFK8lTW62OOTa59S/TJZf7rsoUO2J8tsrtGqPl1+QQGes/tLowEsjiIcG2Fnjsqm8AT3szhzhz7iG1+TDgEOfk5DzzcU48CCDzXYYF+SwHb8bs3P0Ti61TXhVjE93X5M37fh0uCcft00eWcN5k+9fTfsT8PxhYQmvd59q9vLMmbwNAXiNYFr2WxGzGVpJ5txGX3vymnzYjk8HqH1YbBF509cKZLk1cjwiI55tbJvKmSZdqpV482ha2fEbivGLAoZ9Yg3Eaw946nzyKJ64Tzfdp5qMnCraU2me2XG7JvukAQM46mA0VdumOkNEsvilORvbUbH9lk39lA95XFM08yGYeNptyEvjV7OH4IfK/qWyHIV2732J1VNFszrdG9JKEUMqSZDhISYVwtWU4hL2zzDhNViN/2iHwPt12q0UMikrhw6Nu8RZHGg2zg4ZcQhRkj8L3f5x5M9i8qxNBlhrDX5OKUJqXn8tHC/JFh9DHPZskj1kCvijF03GGDSsnr2MHlkh7i8ko056hb7M81LNTid1r8JZghMzle7goskOGRrW+97uvKw284pkq0DokzabaLOJehOr6dJUPn/ElA1rmwjHV7WA0+ANaKZDRMzOtqkcgmVtLRvsmbLRy4LNtmMbNrba/dDwD+IsUFd2EqgjZKJeqS5iUOpY3sScQ21Qv+8o5bVwvVG3blUnsSNbGKVLv9++s3XLGxuD63qAV80+IZG8XqZrgd1vpql/1rqKGo7+615+lJIqbScpzmn0ZgiboAv6sd1tU4X3iLTt2R0dw1E2bBvT17GJ7ewARbV2dAJOlraJLIeymW1jSpXbKE/BLnIK8QTWRCXlmrYr5WxZTqYajnhO5Snsa6/Kh8gg2iFhEHP6CxCZzKbpf9E6YOYK5ewcw3Ohuy4kRWw4b8PIBtmHdUeSw1OFMFpETH4SCDyIz1koJtRgvbkaBAZhgspECFRYdVqfFfX0nDK+HZZv23C7lOoJSPisZKkdBXZpVKbGEy3iqDW9TWY0TdOfZ8/XGya+u9N4Jjcoc6e4eUqh9JK7gvk5AlyjG3GwGde6tqCxSZbHzO6YEgtN4H0iKYoJC4Te6vTD4bImuGWMcto1Z4fWKG2iIIyTRrOVtjtD3Wx4TbqYTagw+bvL/fSjBihyy/70Yyv/dPpvuQTJz5EFsiwguHXLvvsv9Io//cuVf9qoVvzpR9TZd+ZMB3JGlX8nE/iyQL28Sj72smEkfniLNgH9T73TWAZXNEVjd/+iRebL1kIRTbd233C3v3DFQ+19+jWIgIFoLJ4+d3s9gH8T2qjWLxRwDZ31L8LCI96kNpRrOt0pMI4LxsMJYd9eTkXHwkGw/zxEoZvxWeoXJJR4exFM0UAbbPG5GIHfhhPHsC7klvOHPWJ2KAER4W2dSv/7ZLBmXu8yEPMOhLNFax3uJnjXYIt8FCHGr+atP+w+28xHrH53oT+anyP69pIjGHZHmvkIrqW/arq/bOIUmSuGp/IRO7wln8CBc07NR+4ttc8/yaSqFshfLkDEVUhuQY7NETssx+bRYffp8xCPPVckU+7mMffX59kEHKf+d1MuKI9W6N/D6hbDN2PjHVOiXm2VXj2SSqqFFDwPGzAZ+wpdSdH/jiraFhJHxDSDXECsiWLMfZGWZwLt+e/QLaJkPuoQ6xXgihQU8NidN1uM4uWy5gPuzlz3i6V527YQ3dliaN0oeZhujssrgYK0FOLdv7f9vv2/TEvxe7z8U4nIgniTw2k+vv/9LPf/fPrT7s76eChWoAFEHo7mAWCGbDenvaSbN/AIyip3Hv6/fYowrwk0QrFlYFOwH1H4+TmQcuw5JXhl/GNG2bU37SrOwcJK5Ng5ZeTYj0PO9FVchUP5nLuLmGYgPGxQjMGeathEMsOycMLoPk3xHbMKAg8whXGeYNJ2iNrXKSSebLtzeq75C1ABZHbMPa1mYHhEnh2Izk3E/2yfyjHy2DagukHsENMO+ZCj9Pq84+ZtypCjIbreNmT6bUJeyqbXU2mNu3toznauxdS5ECxBvJ1hfKxRgpG9E2BMaKJqAGlPBgAuI9nig5jGp4qkFOeYNMqZN9oMgWgcm3jAcRXQc8QE2wbKuOa1eeBaiGdi/+h9HZSOuhZDbl1bAFInhYwH303Oy9SsHXPPqBk82zo3i+7brq/QNWe3AXvM3WWEBG0LoZsLhxRDZn++6NBUcfgls3nKppu245rXAm4luVwsqgiyTcogW2iXqaBIZQqbNvmFIrPJtbNFZ4tNMXtDNkYyKbPZZgBcCDd7St38E1TgcHGg6WnYFPqP1IVw4kDRjk7/la7KplVwTxVE5T+cuNTGdmhmqv+1AxX49cXQzJTt2KHtU4iDsROw0qPqDVAnTL47n7T63WAtYH7rzBZNyao3uc/qfwsEGSA79opENh27eRVnIBU30Aa7WqSXEakdZO4tPCknA/Pj3z15y5ce87rWs1na1NMgaOeyqTzGRoqLxDauEPB52bvlXgK0jXtGSaRVYy5PBZZ3/g1u3radtu0pBLfusIH7pR1zRTqFaP62m3e7bTrFbMl8rUg7yv1Hym6UYVwI7UqRbuko16KRKbapa72evY6LDqOrMZHod/P1tGN2sNFiTGNJfZB44UvyCfqSqByhdggRdE2E+yrCG6J7sW3vmKI6yRcKYH+MVyoHzrlp2+6fwDC650UHaNs7i84UFJJtCHdbe+jikAeTKcalD9bDWtmhWbD6iBTGuSPxC3YNz+6XvLFAoNwb9lPSLeJZp2UnCJSb24iLfY2NZ53hXkZM3WyRiasRNT0b3MvkDpCS2Szx/MpmYZ20Q7gHh+XpG3Z0dHW5DWMDhYvuxo3WWMA4eNHDM7flmHDtQV8hF6Br7swD68Wey6aKpoQK4zQPILljiRu2KWFHeOEKWg/qg5Pnl3nXi8DGWynMbrxETdoUK8zjEJCSjyAvQIhDr3sFSYBX/T0/4EQFC5rFgjh1ORupelH4JpbMa79paaXtsNDNbVNoqu2awLXzLSZXdQI82gHNR96mloXIX2hvmwjilM4tdDqdapq6tWmSCyGwSb9jMqMca1fCchLbOP3ZIgmgs3G5Rdo7Jd9pNSvl7BVN27ZN2/aDQ7aIdnkBda6SebvSy+8bbdut6bk1pbSZka6yR6i/aHNN3EYbO+wtlkk9RQ0NsEtD+H/JLo3YyK1FZnrXnJOtErj0so5ybRvM5rE/XTduzieB7lV9vTOf9OPHig/xgMWk4XS1k+/f925xFebBOvl+KtA8t2XjJZurmm2sSpdX67AzO4krZufyhnBfieyxDrONDmyzpNxmPPuawgLyki8QOKXfVV4i7t+Ds/pdH5yz8Ka0SCqdXWOn9xL8yPtro9RGkucUCWudZeozfz4Ks1Jj3P5th+qzC2Gqip1BcL8dZNFwZsmJxRxBndki6xXxrA22kTqsNWRbyWz4FouGM7M2uJIN0jO6/0uKG4LMtBDEkE37Z0XcPyuQlQaRKI3y1wQ3kirpqGOzU7LWOFcOhNBRNNPzq7TYpcCV1eQ4/GmI9076dKAZ17VPC4gPYsJCQQhQVk9tMrdqxr6E7g6oKafghAHYkCoMIJQwgNBdsMmss/x2NbBn3PugFriAH/fi4zUU9ME00vj2Km9HlHzx0KXBuqVL61awyTyqBUjaKbeeMhVRCR7Vm8whmCnhghC5Q0wcC/gUls0+ZqSJeYEEDGFLUFfmYrzH2NabbcKCA/TzZ+cYUund+NebjVskElptMhsFAuhcIMhehLAeUDjmItpkLvBVZ7CJz9uQ6p61KfPULNellGifdg7WfTagBOSDaiBpZyNmnfPlW4UuJy4bDxCUP8V4IPFCiK3ZybAVKzUD9IGQHILnjWx/OaEL9vFLnP6e1uKXdE0RCBQd0y0iE2QRzxYhBnbZVBGG1Ejh7Av7GiRlRaAXpzQbziLoXxx16NMkaBSXTTEpKdD+o/q7UQ9BFNXbkfiGhrX09heAPT9XEgaOWsN0ztmdRgzYdqfACG7fmZ6/KPuyZiZX994xq7P/QjQDnyaUqdX7qYlDVNz22bKD7FPIKCqphG3AHNHZg4aJiz+g0/QHmdtRMDkL451LoMEkdoYCz5T+UUNH82KDCxfZZeb74S10WeBq8WqR9FQBJNdAeFXDALDFJncwjLD+t7GGUKJe4H1XmEFBwqxKlwFxwioPet0eSsuMn9hrEg8Vz0L/ghi8LZ0A8A9h9nvI4qslmoBO1DoVqJ4toY9TCa4vIoRhxQjDiiQMKwBksgCoQL+6wBSwa4lg6GOrhL3VCMBKUsaJ+LL2lEWDHsCFAwKX+FDtQPpC+Z8uhCFdh2zknqfbsewE7/cT76z7DgUuZCIM+MbE9I0pIsyT9cV31jyEbMTsQTR9I4LaPQ/tp+9KP/AGW+thArL+i8s65XMBICnD2mC+i9riBCdzGdDTzxMEB0NQ1wQjYKafWNQ3cA4BcsL2jhgvVhga8xujo3KYI9iGznoMwBEPr3CDEmLHFatKtyDMRxG48DLGEsHrK64PGfcg+ySZoKOlFIbZKALR8Z/ORMgKypCTipoi0pNQk/ah5aQo2IcR2BczsC8iR7XWNkAuC5yvSy9jlIphUeD3rlLM/06ZScjKD8kvqYysRN87xzt8zhIsulpB/who4IMThq1M/rm2y5iqYrbmVoJwni28E7QN+T3tlp+tSX8ESdZl08PQFfIEcLfdYiSn9syUGB5o073tFjMzld4RmmQ+9DlwGhXAuXHrcJfRRygCeTB+p/K4Z6orMJk4pggQwODO7H1miwxLc5JgDMISgjhiEnufWgfjHCLGOSSlgyx5IePDF7AKiGBwMHIyDuwLukTOxcrlocsklw0JxriGNVMCWNeyZiotWvflmH/EGm12V8uOv4D7f+Msg68gjrt753OQEe4EPAPIgtvORw/5R+eQjCNhvFpX0u0ZUfBtOqyDNA0zoTXE8okUB0XHxvcVQ3SQB7s1tCtvcxwGBpWSxMlTpLzDhStqTgkkA2ZhAG0tcRLFW6RXY7oCccIIbBtp0vBDLuoZ6UHSUbV3A+AW+tx67Z+p/0S3UZvcV6RvtekNYAca5S1W5lqans8+Y9Lx8ls/ZhiPFySHVJ/dE6bjlfLPqHBvk7waGblB5g2pApxGoBNinvNIoPNiS885zAP4iHC92SOQbK9EtnXFU0Ty7MSC9EFGBLmgecv+G1iiaM6a7QnaE3zXtpJxY8/pLsrFpxGqSLbRqRug8E53o1Il48OCBAXS2GhrjqbT1GcKy/7KpOdVrECwzk9LdkKXqXk3YyciAmWerYJHitgwTonrEI7C2ZtDXPT1Nthp1RuqEEOCEF1DX7/l+49DPPIsAPof2bjf/1D6H/b7r63x/Z9SVaJnP5AvGJ/GOX0POLl+oioM561hEbqvISL+ilCik7R4yYXZO4xVJXwAvv8Goabi7OaoCLLfxHkTZ/8fkzFltxnaV6zxYaXZHWZRN3VaWeEBwdDuoYgkvuqmzNq9/HSuN6eazrL69JtalstKyHAMwpz04YCip/z2KTwv8d6qzLaAzz6pe8w07pP+eIT6bcgoLd4Dl3iQUQdHP/Eo0CKUhn5zxTbI3m1snP0ZHHJjJA6vHj0OFqp69ARUB+2dNsie5Lq6yR6FMXwoAjHfZk8ZG89QEF5vJslRBq49m90RFaKtSSXCjxwrSNY99psme9qUedklUf0kjGIDT87Fk4+HOp33CS+QtbSBmXoTaeUZwwjXDUiq3nCNHr0Gsl52zOQZP/nEh08pOKc24Qbbwn2Q2Vb218irBBRVYYBtIPHKIKYG8gxkn4F7WXNKnDjl0RFNHFEgDziKJaJiyT6r8yHBbw7tUPY3Bu7ybewcBBx3lzRjO3nbduFvo7LP6bXl70iA2XNmeyeoSrYjnOCIFnSGLoHZs9p2mIhDpIoUd3cqMYywyri20JdKVfWmpEi37exLhnFKhJ+ERS8O5+0wckAOZ39jUjwS9KCubweOu4kzvp2eqHITHzDQRMvNZVtOy4QEdJ3XtiX9p2qFHpQGheWKEcmgnNSQk2qz7MuGAAg88rsRA7C/YkTZTJpmR2o9W7U73LDbAU1A+AB6s2d3hBSjGj1EEYRWXyYwtNk+cKRObYWP3pZwM9+1CnGw/jckcNcQj9o/T/amf+QGXk4D8fPEAP9ljRwvmUQ4rCu7wVSPmlwS7xeV3Y/zc1irtNwEstXbwwHbVNk3tNW9tEmPZ9BvAw+f1VvS3wmkH3vNbKHkJN1kFnwDe7BTvmboZwTEzoCQFb3sOPp3UPeyr2rEWmTf0tk/anZeZV8yMPY9QOszNSptYQMbskPcHtOzsBljl1DkW4/CAagm7lGvnT1LNwl+cPo6VF1vxFTN9NBOKnVmn4WnB0A2HkCkLyZdXaBOlj1XhDBx7Z7b95DOvm6oqMJrn9NrBYlRCmJOpFNtBM9RWfY+vUPSTdJkj9Q/ar1pCGCUnKoP4JbW2d8akQn6Da43bRtmf2cGxs2jQHQU/ihAwT0GRrXsjmit74l82mtEN3EhfdBxwP+xmiuEuT5IW0SDuBRIuuGyrrj3t9JLB6lLaPDdhpPX6GWPm0Jn+wLvCp69P5DH94bllf93RlRemTexI5yp24ekUIQkdC/LPYhJ0YaX9CTu9g3YURvUObYtIQp9PDDxXCTfHJfzzGgsXIbemgQTI+bbiC4KR3bTe0o0rWfvyD40bdOt7VHTmu0J4B7VdBM7OrrylmmAJzeK6tvmDjGGa5fhQGu68W2V2kHYkNiaWWfQbiyR2ODSDTsWihDDXDQ9uVSboCLoW/0dKUqcQvkCaqBAudT8DTX6gGxfsZg6uMH/TBtT5fAEEtF8GfxMgArwuMQLJrOrvHgLmJoguynI/pIGEV+IFBKC/AhDp9wjaqYTeTQ0EfTk15lOAOGivNzlExQepkwW/CZindOWngD9Ob67X9DbguJp9dMdtdaro3NVKo5Uep+mpghbOpRA91kXYfJDCfEx2UMBYzoggGbf0Nh02bO6V6Gb8t5hAMxVHYlSV5dz856EXCtsE8ps7XB9vatXhOXUO8qbgi9p/5Jmeb8ms5dJ+AxH/f3D8AU8DP/BEDXvRTkMP6aNHkjgvNw2ievbJKpvk3Bwm0SLtglVHNgm4sHut0m4zDaZ9nAF8hWK6J8ON9eww/hrHUsuTL0oYMPvE9sLSGzfNK/QLxaxfUVc7ZacyhXBlaGhkXhnCCaVJevsKUa0TUuIsn92f9YAB+S0zu74NM7uILXJ9MmTwWs79ZNaErrb5O5CzVqvpqof1igy932yfAHJ8tkXkSE89r8tWZ482a0T5vwpyPL7FPkCUuQ/voi38ucWU+Tu7z49Dt7d4ap3NxE4+WUaNDitbHID7SIkwKQkwCT9k0CtQn59ujvKSf0C/35e97J/Wp0G9bI0iIm5RCVWuY+rS1R8apLUZ0aSejFJwv/BKhcTT01I8wL1BY2/n19Cm55sMdTs+VOS6AaVnBmp6pJUs5OAUfkOCFWvSKhQrOuacjiqhGN8yv5MY/+5gw9RaRxQiSsSs8neF4g8ZyrZ2UB2jrzsLKxdejyo6m+vU7Zdyc443WY8UsAWhKBSrVuTEYvUS5Ap3G+UTTiRxjb5G7xdRDZuUQyE0s/LxilFOnEZU+LklvhFqDe2bD1qoB6PteO96rknIW7DldP2bNuL2+lskbqX7KDPq5d0mbqxxI/bPefGZ4cCbRSlYxmbYOmJdP0FNUcICHdSzW3twHxkq7HT/ZCCMvftYeW1dhDbCqzXF/AOUUwlWr0cZDWb5dg5XlWOV8l4oSxV/egLAWOXLvYF+LILNnVjGCadpP3PXgUBPa2/oT6ijbkhOIU8klRnWnZTsFbKivpexBOnss8ZQAsp4gtlH6QunU1UJx5j5vyRZ2wAodk9Atm3f5b5U9QmdeGlJqPkQSWDBN8/2f4ZTrY3By8PXqyTDYS46zsmRD1IiB/6LhDiU4Em57CvTop7PSneZjwJghSPc9q+xr9fLUnx8Gqk+KiQou3RfwoDnxRSnPCkOO5J8TZO/t46KT569qT4KEnxtpIUJ1D3uJDio0KKXyMpflVXG8ziz7n4M9mToZakeNsiUjxaJ8UJ39lzSYp2CSmeK6Q46W3O2g8szN4SANsehuoIHxrMai3G6HqX1sPXTuizP0XL0+dtdfo8WtHnvpI+jQl3R9522ffQEHtqSZ/tij6FNpvraoTaWuefpgg0Rcy1O7fnDCg2ZbZ4pCT3Q2lJuu5UiKwlPzfxgT835Wevfm3Kzw3Btmn6MlrKNKVMAynrQrpFiBbWgx1paK/PhU4cQXWxDWlGqvZDMLAf2ozAYPmZvvLRxkAczUPvFKAk1zgCxmH7TG8+hQxUboFcDiOxx+JTyc/814c8mYGn4Q/3hmdxhp/RoR2vvFPilQ5tl/UPazHLmoEzGiNYKhvhZGAX9Cxbyr6hc53dFORx6dZEwSt7W+C8U10oFHsmB65ZdNiWDiTSuFpv7HCq1qafNzqcd2//TbA3cFr6TVBJNxWaN0LzRO7idYPQKuW+cp77hAUg7XU+181U9lFTBOKPNU9EWUE6j2c6VGlTZs4eZHjynju0t0fio5vM/gieSwAzKh/vqz0GMP3RW42AmhMz3lwHwCN04xM2+6hXWUhrhMo7equh5RRwSCgpwcUpPpYNHLjVVA0c6j8+VHs8CRO6oFUxIWvjIq4K8kxfZDL5lF1kGikzV2OCc4VZlKb3wA2DPUv/1XKG08DStS8Q++mvBNQHfLYLu0wDbq+wcv1q0Lel/kiZEz2o7keJV8cm1nTISCu8d/q6DZeB1dlfyBQRA6mUQ/F07feMZ8bjSz0z3h6csWfGrwdn6JnxpHhmfPSfyeviiaVeF8+s4HXx5IDXxc1n4nXx9HfR6+IddB6H10XN3+Jmk9qh/4O9LTqlvwLOxvQ/B5qGnqP1i++wv/iOVMo/L6Rke4O8Lrc8anrZbwRnrwk8wmPxsAFxrawJTFa+55KlmsAjppc9uVQTuN48apbIJCa7OeBdh5ee/m65KvRH/cyyd+KR5fWAR70e8FWDEQgcHX0PqEfpsyM6u93DDt4b9qMSTuG58PaAngteeF/Gc+GbRptBz4VNpr285wL0Az9X+SysN//BqhfdZ+GYgtMCfHy808JjCvqFpjNvhPl+GeeFeLHzwhFVeS80xXuhWXkvNFf0Xmj6IQEC6RTeC/FZeS98f6e+KDt1VTv6d7hTv79kL8qSrWqN/v6SfS8u2bMv4n34/SV7UZbsH1/Eg1H04sfrC3bUL9gxVH9oQC/+GP8e0b3sNjy8fzWdygdPVy9+jCM4Wl+3D569MvKDXLdjsm6DevEPak7dY1QLHtF+dMvqxd8lK3ls0Uoe+k714h+sW/wOLbee/dlYfj2P1fWOh6r1PH46Fr/H6xa/2yuL39sDWvyoq6bFT5ij5Sx+zy2x+Hme84W1+OkBS51+8S1+CxomP2FWafJ7TonNz7xx0OxnU/dLc4VyR5Toqo4yYVbN8CdV/u9n/PuMOrX17/uHxXf/sCiNaC/GYVHaohaC2ooe9yt6wsjq1WxRX+bfY+WKHlptRR85XVvUCY7heH1FHzn7FX2EK3qiXNG6LeoRWdEvc26PaT+6ZW1RfkVPLFrRI9+pLeqRU9qijixni+pP0fLLfKK+zEeqZV4IZJlLk8pKbNnKJpXHF5tUbn8BTCqr8GlnbVIRPu10TCpLebSzN6mcBu+12KRydCWTykaaVKCtZ9zTgLbeK3Pq2vqw1NZ3PWoGg6DUwPcM3wdiBUcRK/g/vep+Yy13AEC1TV9139fYKx912FACoRJRgS4cxSSchXL/6V5EPYTM48QST9SLP2moT0W53wo2mYww+/x6V4CjHtyFsBq/zXT2bn2Pzzw47Zc0v2W/E7Q11bLry1bviNamDEPdSJSTdH3FniBYVotG7hs6uzsQdkCXV9mFyxeUmIylxYVMfaqO/hzLRSkBxlpsJZ/ws4vUDNxs7uMP6R9W6hX6cqvcQw/p9UptMttwfKqe0zvdR0ccIUXC7F64/iF/pwADKPeKHv+4Dk4KlLcq+92Az5DfyWS/x+KYPCN79hU9C935kkMt62X39beurh0xWF1aLPZ7aUzJTN6HcRBeSpA9bMB4rNA1Zgh8epCJHY3AZL2MPmI0IcHMuxDOkTn6wdrjMgNQKKHI/V9q4dPInea+VjalpY217ohyJ/BwYUHPTWGt+PRJ5f5BASkAuv8tg2wvDjhgg4ebPDC4mMqMpEECBTWA+wIe91eD0jdDpf9BySY4oJHQw5Kf7Ur6wGyrJH0Wz07TB0LgKIjmoARczhriHkjGVrvTnVDiBGp6Es39PwLdqKltGV1McFJ43sXZ+4Ex2cq+goDH1Id7vzVgegHgzRCoW/WTU0ufiqYga/R7BbODoDvczPQZNGYUDc/5NWxSLUCTA7RN3/tmCdyAT7UBpG7jalWltgm051VKNDEDyEFkTfaBgDjpcbYvYCbfhm3mcYDY0viKEChGTQyV1WQf4HrRZtSyjexLxjPBif/KkChVNpr4RhPbRqMA1GvxFpnd3ssbaBVzE+NUudnknfK1If/akO14qDLgwInlBpRJ+CRCwGn2DOHsQHuwLZ7rohpO7+4H4zfWlanC6ZsLM5rV0IKrHf58bWZf1rZJNTx0EoDsAcpWbJNtU0yzRHuijbLfD4qYZqLsy5qTdke0ltiO2ialFp95wncQrzEm0aAw3YUB8HMgsEQs8fgQcXqBkttlRjIWejDkq4goo7Ongro5OP31AYiBymJB9f0vCsSAdi2fiEcgBkKBGNDZfzICMPCfoiIcABjQABggOpTJ9gEAAa6jRDC3AVwv31mGA7d1mnVV2t+kXeGj1wpT0QYCO5VOx8sDd/qlFwWvA58q5+vxNcucr16honry103yhD3WP2EPqx7QinjExgNHLF4i63b2Z+xxf8aezV2hvgfvitNYAvU9ugR/G+h43mPNVV0/5MU99P0TVnr+oSBPyNHuw0nxXjKIkZm3SUjOqcF9F748WA8a32SslHQ/IMvhufrsdz34RvjyYOMyJTaiRMp12gDkPMDq9ZyfJ/gONOSloikZO9wPXBluXqknDekJ3n4vQOjKVrIP9zuRLf4RU/fhIC0ipMME3u+3Z++9OvtrIx+IeyRgOomsTKvfVxBpra+xxHG/V0ufZ8gSHFY9wYJCMkp4PUTweoht1G+iiTv1Yr/YTdtCpAKdLtG9zbP8MftIIP9ymQlf96/wZ3N/jWNa7PFHlSB4HpbkMEN1jaCkL+ZejFtoLOVevi3T3WiAU3KjEb3PBz6jXqH617ohc5KHVZ5DnoZmRS5HGCvBVnEhIto/odzTyoZT0Ep9XLmn+Fkj67j7Ij5btE3G55PKPYMnYHz4dGt6u66C2Cscn7YA3TUI21O6CoWgj6DOKQXCKaEk4B4BpeiUB8YrBPrap3UoFNZLXLXIEPKigb8reKm4OqLj0gepimv6QKRbK7I8HaoZ68xMQ2De6sxM3Gdm4qVXfVzNc8PDL9mGYAAD7aliaBrLMTQrVZfahmdoVirRIP4YQfnAtyCiHmzFTUH2aSYXFCaiBIBjEc0ieQIvT5swhZaul6uzfsjiQgaI3F8kMIyN2V6VwDQGa9QBCzXkMXFjmxCrDtu2zz4J5+SRTSSovNl/UOOd+obzIYyvbds13qkteUxTpPMi79QtX8v8a5ntUisp7i5N8pZE8ZHwdhsD4y4WRvVCSLOd7H1Bn13st570WTCuvVBZfSIAYyic8Km5su5KzPCyDXIZEsG7S28L5XJYMLXL4QTOsxNyOTx2XnU5NKw30cAfmtoDM88kRjySEzm6+v6uF8PeBKBPvuN+gAamE/1LwJ/QFwVXi5vsa5cpiHMW10UsR/CCFp0Mz+AFzTO4Ka8VLYST2bi6LxZ3Dk1kpSeuEk928d6umutfGxcFVt5Yv7gMrjjcHrHcHk3xv/ZH+6OawIKgUuD28fZIa10/oQa6nsj18aiPX5DrY4FrRNheuT7iLR3J+1O10Uo9G8H7o+V3knJ/z/vjOP8eU/4GwQdeIbS3XYc/r+9fIQluj6ZcIczKUV0hB/2Be7Ti3D7lObf/2yr3Sc+5vXYRj8bLa/OsG+WFdsSzOkXMpytwaXRsJv0IU+MpKZQHbyXpo7hwSMC4iyzCS3tu4yzzVU9xA1WMz1HP+LyQWqC3B9+hFuiBU2mBsP2/4rVAHz2lFuhHVlHuwNduqX6nr9GhxSR91M/OPr2YMyc7U7Lmt+HLbfpUepxf4974NV1y57fpisn9Nb0Se/5remX+/MFTMLkHZa0F7tekjy9WOTxe3r9vD1ZQOdzeVzkwQ8aZah1uGVAEhKUioHS5PhOtwypVea3DKiXOWOtAP3VeNw+doeIhLBUP0vzKiodbBhQPYal4kFQlqyoe2LnldQ8f7EvpzeV1D42+7qHhzBuLBlQEjZoCAg+X6CCa1EE8fFY6CFS4rCKiubIiIqwpIr6p65ru9I+0jvwQk1IREXlFRA3vUJd4h14ZEZd4h9rjHQbAO4xFHRHU1RGAPdVFAFpgxEAoeZ0r1FyC3jITTGTDdG2JfhiLB+8iDEQoLoiLlpSHzH/1YvKK7MQqqgoxqR7VpZx8on+EHNUryclH9cpy8mkeIf7aO8sDUX2PHoinsxLqe3QlSo1FZbRl372ZcFmNxWFk/HvUnIbG4rAp9RFiclyqsVhcYqnG4qBZorE4bM5YY/Go6fVbWayxGPhxOY3Fo6bkB81ZaCzEt8ss1VgEy2ksHjWnp7H45Goai4OLNRZiuy3ZzY8tFqDrF/gZCdC3DMiz5ZUVV/fyGQrQq1TnBehVSny3BOjbBwRoHNWnK0PXmYEzEKNLl3hkDF1VjL5lQIwOSzFaMKMXi9FVBIvMQylIc6zLsV39fiR91oIKKArezbJcm9lrpKvNgZL83TMuFuLQ7QMSeMUYnh6HUkrTB+oH1z3YFfcEy0vTC8j09pw5I2l6ISiF5HuCVaXpxQWXk6aPmyXS9EJwttL0c6bXb24FaXqgzHLS9HPlyfacORtp+jl/tiyRpoPlpOnnzGlL059cVZo+uFiaPjBwvH3aS9OVEr6Spin9l+L0Ib2IjTjAq/iA7nmJ+pCuSdQHVmQk6NiySKRGVV6mvr2SqUWwFjKnWI3U9t+WrA9Eg6L1wcqRmTf0Yz6Lji2jAg2jABkiyWBA8bBpCAhLruXTvaGPNAHoPXd6bBOsu2HS6gb4BYYQHtHEh5SjMPtU4F46E/qsRwZvIBym5dNpGilSNN3Haa9vEhJ/Iz7GubE+gbjB+JKZTmCbzEDtK8ZeAP02wIk01puMugD4Jre8RmDdcJuOXQZSFilJIxmRVPCX2octJtI55o1KlimGjHhBfYSfoWeolMHT7LM6+0s+4zeEQjMpg65+/RtTdvtvTDkbzDo2WUZOV247DF2SSL/yUX1ul/jxYPSsyorIMkJRwqlqCiKVhsqZ1FVaB0bETv/23r++98//+5/c/BdKjoFSmYIo1EaPOBPZHwe58ogTEqtbL1b6mjfguAOnUNFhVF4qfxyklw+2CRJrDOCW+1BYJToYNgwg/yA7HCDatVFvfrMSf6R+s4rN4jwS3tspoJhD5+XuRoI9bpT2z7vkF+kGcya9yQZ68+en05uw7M0+s7g37zO13rSlNztOszeRGx3oy2eW9mW6WhYXZp+FISUAUxSWajJ3uItk2F8e6jFJx5PI2andx9W2KffloVn25uN9E02lb4NaQLtYwuGsuGtze7uQeUcXMuKmFwmpHxaXJPtUgHBdFCcsunYbZ3NdvisYBaHoVPrvx3w/KJOYYNyfAox/61pvknJGnN2kfYauS4pmG8smiMqgxfd0qrjvBJBhcqj52LukOtsSf7Y15NO94UBWpNP+n6TxGHq50hPhRDQRJxMTE62JiYmJoW42MTExMjYh/yltgmBiQk80Jiaa6UR7ojORTkwMrxkdT0vSTyTyO7SN7HDQnkxLIqw9//OgPYErdYU9CPc60YL4P7IHN5nJ9nhK4Z+5UsvqnAGl+FRjRlYY+YR+4DLBgZtj6HOZyANxoRJq3B4DeOBv/8+P3vvwlz9187M8PAb7xGlO5PhA66N84Q8+dO+f7//UzU+exgsjKZf61N2d2HGKvq453Zr0LNMUrlrZMCo7d1FlwTKVfcWcql+ZkOyp+9UerIm5pRdX1kVl4WlU9opTdWuInHovryX00MRzKN09+5u4wdtPlVefkv0u9mMpt8xdJfrsdmdgVZi1uEbHDblLnuUdBpXVs3p2pl8Vuyr5aSQBEe5Gf9gi+YdPc4ajebZQPG7aWztl7iOJIFbyKHQpMy7SAM1TsN3GDHxGGDrVtYn79EP6fLUyzY6UNEskgcce0gzWRcrNI54rXOHFTvliKz3Vsr2ytmzRcsvW5AYbuM5X32ANsXkMUoxepun4VBSTpIPHkXfjjVU7WeWomlz5qIpSufBq595ngnYoTwc7HPoO96867BB/oSFQO3YvJbDPIsoR4q48zRsu9uNF3YVmR8trzoAvBpGDj0W0uWHiic9Vpbb0G7ClZ7XIk8gIPol8XomwZuEZMd6Pnznj/UzFeEMjcKRivMPlGG8pcgrGu7GY8Za3zoTxbgwy3qjgqTrjHS7LeEuxJYz3E4sZ7yd19lSf8X56EeP9JPwjym7fbMrZKBnvp8+A8X7mjBnvHwXj/W8GUWjcno8hpelFAbLdLvjPmY3diYflc8PG7rj/PMhsx4R4yT4nDLkVvu9Hz4Qhp2Xxc6fiyR9fhSd/7Cx58l8PzpYnf3wVnvzzZ8mTl705c5788RV58qOn4Mm/+OLy5M8s4smfBE/+VMWTH+nz5E8v4cmfWIYnfxI8+VOLefIjK/Lkz6zKkx/zPPnmXp8nv7jiyT1Djslt2OR7gxW/uLx6Hhtkxavnnz9jVtzvvk3m4gFu/OL+xf/Fs+bG3YmHymMlcccfKo+VxB17qDxWEnf0ofJYWcQb8H7yXQOr7m57uF/b3of7te15uF/bwsOnUVudj191oGfEx59qys6Ij7+4z8d/8Tvk41ft15ny8atWdnp8/MWn4OOfGODj/U2q5Iyo8/HPnBYff/ELx8f/evAC8fH7Htbuguw9uoiXXKUXlDRKvv3ow5pYeqDyIzUqP7wKlY+WNbTSU63XaTHwNd4gqfEGSY03SGq8wSrbrs7dX9zn7r/4z8jd106/PoNfnaZHBxn8i/sM/hdfaAb/4orBf6bO4D+pyS/3Gfynq1KrM/gXC4O/eZYM/k1aebg9SfltYIeQAFOwCtTxI9STVJg9GfBRHuDabOdhvduam9Wn6ZTXAx9qKMlEZYfSXdr3B07eAv+W/odBNkaCV2KE0w8hV/olqoOpg5wakSfugJkZ6mVPIV8E2BGRD95FcMKejwHNEuvTbsnwf2xRfnNF0bdrBQeAeADWuG4JXyW4YmkIjuAPPDTYvqA/U/tgTGsDWVWXgJKBu1H7+OwGUhQEcD4I4J1QTWDgU87zN4apu6xXMI02p7qgdfQYLXY0FtYnOamWRnkP9ITBu22cRAjvyf4cTE4CZ3E/x3GBjMdlSkFx9xCD7bdf2CsGljNZU+84KJlLl13TfYGsaZmx0LwxjQDYIJkDv6rXpm3axt2G7PcD/+WXb1qwmxSKCIppv8jDwdpaMKIR76TsOe2ZUkb40xhwvlEXyXngc3tpmD7fH6XlQj7po7ZXBoq+EAeqd56Ba4uYr45JipC9MGiJvWuvrnxIv01A79QVBLTw8nslVa8cMu/UPTCQVrlbWeGNppd9PZAoz2+cR63N2/Dr186j1mZB03q2wLK/yr/fUB55d4N0ryF2SOmZGN1wWmAdbpW45Fn3hLoSIurAM9PL9tN1OFlviMKd8GhNsQ/eiSvTuA1C97qHx3KhBWXFoTiDGYHKqPxKYNXL/sQI8iQsku0wjRgm/g3aMhc4bXsC8aHdoFr9JmrJ30mdZdbLRUjRAyCcHik69KsA46gYQAUnOkzvGRbPjgNhCfTc2mTuCgX15B7AhVy4ybyOGCVIqZxytVJaWo+ZoktY5k3mRo0X3F5s8QXtf/+qzodtCjdjfByyKdxd8LFtUziifFXnHZu69fyU2RQm47xlU/dN1cvX2BQzko/0OZwUQTO8I4LsBCBjng1si9O+Sc6i7FuB7VidfR1+gjD8azr92nb92RpbZpcYqbJLaMGaGV787hPGDtWfmewfaTVHD577Z+tBusmsKz2Hm0RGFCfBhXCuWOOa1+cjFCEZxG8NcF4rtMNwhtE0qbsn9HpeRyasJmZxGazuXaDUUKRVGERNLG0w0wEPUtMJM8cEfMiyvw1sZtML1GR2V9Q2g8ilBJiJfQ1xSifLfvPxYJV4sFyd1Pm0hdPskM3sgHPEE0DGZs9Ck8SvTG74WSBJwAm8TZgGYg37xLneatWm4wx8Yi6byg0YqlhAVOPUdgZf2tqJ/EtSxHZsi036d2PJLcxcvVV7K7ZUL91ZWnrFJpZMaUBXI7LLZjuX0dgRfJmx6Qb1S05tndu5BYg/qR0Sb3eZWUC0Z38XkPMWDCOb9jao/+j0ZXCBBQHYIaIiZAQLyuAMT69jLlToERHEJBASESGtN0I2Kl1vEAlms+xZusICvvYu34cMx3E4m/0TUhngcT7KlxkVZkt2YRSFDfws6INYSjaGymHpVMFumfVmkmu13sBPTHIcTQKqQQBPfQc90nXg9Bs6ut/fBjv07bOtgUlZi2Nuvck2mclUPk4ySqA2KfUXZF4GdlN/cVGP748sbVoCSKSpXQPFy0pVBksX26Rerqs1BffFysBqZD8SiClA23eFIKoG4afuCnvZ3wf8EZkgmmQwBarUCKy17uFUGya2jEbCUA0iur7cABo13oiMoel6s6BRc9em4N0EuSr7h0BK4BpMPfzMjVrWTzmVclf2kyqUteH2mCkzlLJqa86wcl/dOvrD1aboiDA81WpsUP+RgsQy+ygoN19Zj15STzXR4iyytJaQqLZq+Zn3yceREIEL1Ie8DSXQjw1DYbBOTroWhBZUh+JblyMICsctHN+aLAf8+2x4xTJdr6agZUN/2qwwD34WPJOBjjidKy6SLMBMp8Tqoup/uPYTzxZgBWHP9HmQUl5DRTgDcIN1+LfNv0P8O8y/XfAlqTsQUrva5SykZdQqevNSJOUmLPzntXgbCp4G77/QR7umQ6p6BiXtI1p8/nxgqs/fTedfqjIhM8wWgXDR2xkNq68j8FhaBE7bYKpUVcRevrCRu3AmnIcLPh6kNsh+XxcNxgvRGVJlzwdrYWLYIN0KIQc06MQPlinKTgY2wmAldziMPbOeHkQO68l1LrGDZPI++R2NIvwuj4LfA7drbulA/iIUhXflxU+ZQnuZQotMMVr6ptNVfbTy4s4qgSLzfmtKBF8RQUSYyGqyBPTvsGNBG6FwomRfD8LNdckozp7DuRnzaBRevUtQakGAiJ3KbjOSyk6JbG0gRvuf3mFKYQkyQRcVWchgN5vsrgi0ywBfpixBwhOoVkBUs1BAYE96pb3BzhUtiCTp6/P5VbAJlSx00f6WzrHLYZS41RRNHJ3UwoQIIQpr9tYrIqdSHAGIoDGzl0n3EPPUs3oWInn2viiVF0xPsg6I5AqQsHeW4kY9cDwpUTKScoJYXfbNoFLKaBoA0LsTumRSY5sUIfuYPauz34rW2pAhcz4yJa1kSIgoK8gw5Oy8v6R3UZdgijA9BzviOe1Dbm4z3dTH3kiuhIP/ibkSBnCoLgAO1cATiyc17Kp1wK7i+/fL+y9frA3hGdMgl1GU6EyyAyDg6z7O+igOLiWYiEqMIlVA0PMBJEztN7Tm1hawxL/14vfxsI52GHq0w7AvfgtswuFF4vfBvvgNmLTHK/H7QRG/j4XljjlYF78frMTvRyTMJOxlbw4HxO+P1MTvA7pyXlXuv2ovwApK26nF70dKUftXgkr8rp6ZN64qgT94Cgn8kbOQwA+UA/DGzRBonHyA7vT1XF4YD5cTxjGvMm3PLEvIx8K8hK7rC+PHQ6HkZ7PTEMZ/bokwfvQUwvjRvjB+uC+Mb54tZfGNlSxul8jif+9l8eMry+I3hatIwm8Ll0rC1TORhLEsIxXu6ykk4erduiy+55+tBym0ly+ALP7EWcvitOtQFidh/3IIuXm9ybJ7zkAWf2JAFvemonjZOs9QFn+yksWzb1DNaETaffoUUrixHXlB5O+nV5e/n9Rl/SvWXpbrLC73Isrcg+LlKWTuBzxYSk227Mvc4i8jMvdHB2XuRiVzNxhBOyh2P+C70fBi96+EFLsfeAHE7vX+ruMiebH7o17s/uiqYrdih2zal7kbm0yWVuJ3Y2BSqtKDArcH78Sapv1eyJqmtT5UwvaSuk4taT8xKGk/CUn7qdUl7X8YlLTDUtKWc2EZSZtC0+tfKCn76RdRyj53sZT9jBcxZQmuW1XCflok7HMXS9jP1CVsnjxnKmH/Q+ATTdUk7LCUsCUSkA1Dwj73hZSwa8OHdM0cUqtI10+fvnSdLZaus1K6zl4k6follXT9N3qxXA0K+FQk4f0H61DNCKcHa3J/sLLk1lwsuT0+ILndH6wouTVLye1AACb0FJKbz03nQ+AHJDfx8eK5dMfqktstJrvHS263MO3YgOQWznpc3FJiI88vEls4ILE16hLbjWElsb01LJIVJTbYGSuhLVkktCWV0HZ3JbThhcVy2x0lZwoOo5TbGl7qsA1OAKtbLLQ12MEvmJKbaVBky1sU2nJdSaLigJrdGCI3XfasLsws7hqeZ+hWEUjHwIxlh7R0v1fo7JsB5EdZJsErSGSxfEI9lrMBB+nQ2Vb2O1GFXuAlxkYlMd4flKSxPKN9f1CTGH3U38FA+OwprecdyRBUNG9V9k8IjwW4cdoUwexYINLfYZH+fqZKdWXW9cVNIT68vdYG2QdKW+qgiRUOLQCC8DSqKxr1dlY2c0iaeeXpCJmlPXqxnPk3Phvg4WqL+jDQGD4nSsCfN5nHjHwCgO1vjskU/amIZhs2meNaENYptB2X2M1O7aejgz+15GPepPPFk0gmiBjJpJ9bNWbwmXvMYL3RXvbhoEgkorRDhHtGlLZs4oW9VvZrITIBYHIZ2E4MeDk+jtCSXAzLewXc4Bs924S9N/HoIvgB/iQbZpBqECx7CWouIvKf8u+f8K8HEO+K7IePHt8QH1OBJszeHsrwEdy7Xga/kWNvm3lBDIT39TbwW7gjEmQI09f1bANKGCnQ8/c+Cww8N700z1hjbmzmszG2bebnos3bzPteKrfOn61IcomwaqhyhjnCw5Ln+E+Z5/hPtO3ahk09duKvE+UUX9bhj8VxATSmxLZ5K/CCaPhroo/hfm9oW/i94yEMuXcSr8hrCDFuSf/KVCQLZIAm5gSSeXYiyHlWIMUh3JOR7aPlpTM8+FZAhJqvawnSxvTg8TvCReWeNAPl4KqjvPkUgoGYT1Hw/QH806uCfPaEAVpO/5nyQqPJnvte7V7KuHU5Go71YRfG5DwQP5SFcC6fCDbbcUdWyIst4WY7ZjteJjB2DDy/zv4J+AJ3BeLw805xew+IMN11mdwaXUBNiyo5siplkTGvth2QRxt2XGRRpQMTRqn3IwIbEta+wH9dEPrEYXgRQh+4oU72FdMxfRPoimUNZMmvoK4J3DBdMszt7LcC2x4cFZcVZ8akDRGSHuZd3tWR7eKujsFgdvumyy5Yny5vx6Ei49nB4qHtXtVRNvNlZosuejdc9m6N790aO4yFzaDNzVhLFs7bmBpfXOH5GiIl8J3hckRyQg3bNYteHbZNmC6kdQli2Lja/PEk+YoJ5918BH5RECBS6hoyp/LRQGois5rZEaxylq9pVx7cVZeGbUsysKyRs2kUcdKjV7D8CNuxo7JA7iREZjdffwwkjJG0Nk3Z0vozjBWzlmfCek/Kmn0gSO04Ho/Xcv56Xex66GIvpNY0uyWC6QL/KCaCVRa3m2ierMreK3duL70z0An50yqE//7+tXG/OCC1bCRaiqgy8beorqdzAHLFGpv6N0tt4O/z7wdKFydcDG2vqf4q/U4pPX1VF7g/n1P962KJ7hNHI9rHwbkLhBAJg4iv9Ix/FqTdkMsjLi+JXeXdwd/rj3F1NPr61IZ7Sm0nJkjDXx4iCnWUqCYNoayskssjAgPp/6DKFgd+QG6R3+ct8gFtAS1Freyu2iUSegOPXCKR8FYJz6+4Jn3IrJd5OhDdkP6dZ1AONFZiUA4myKiRyKflGZR9qPG2UGZ2X1hnUPjT3sGfWvLx1AzKA8lKDMoDiWdQnLluJR5lT1gR254QMo7wKA8kfR7l9jqP8kCymEfZQ8XxAv8+R972BP8eCyoe5UhQ8SiHgopHeSToZTefgkd5JDgFj/JIsDyPgucr8Sj96VidTWly5kpOhSNcb56jrfNE0OdUHgmyW5bjVA6uyqlgthdxKgcadU5lRQblpvC0OIC3hafHAZTlSg4Ax59wALzQV+cAypdrDMqe79Xu1RmUd8YVgzK6mEEZ57KTTxlbzKeM1viUUeFTfiW0neyB5fiUpORTkmX4lFF2JFrEpoydNptCwCJ/a3W92qhLxJxFbIpkCF+pbMmmJHachqo6m/LAimzKBNiUxLMpScWmJH1tLxCrBIjRDsnhwZe7dijPPL+SVPxKAvBC2sjWWGPRw2JY+rhG+A9wHHZY2B6wBlsIljgssaBUeQz7+qGzQwX5mpJt6drhWiVrPO9kpOougZuEg0lKDuaWAQ6mxHgSeKkVeZhhpIV3Kh8hD5NspQmva4dBAd0BHqaPV9USNZvnYUbAw4xcwfLDwqyMLOJhao/BwwyntanrLq2feFhr+gyj8ahUkzbJHgrAK+tePkaMrHs9G3K8lMFxfpc3A47yxxexISQrsiG3mBoLcoxn/1H+fYx/j/CvP/fbogApWZB7gooFuat2G6zKgtwVDPIgdwUrMyF3BctzIXcFq7Eh/fvh9DkRrzlKy8GvN4/xojgS9JmRu+oXRY0bObgqN4LJJzdyPBBuJFRuXrQ9Ufa1IP0trWoeNtTYRd5vXjNhD04rbaO+33xUhdqg7HoTFiXyJzGi4IEgEc/EBr2MmKKLQECjZUBAIyKX6l52SJcQnqn3oklzanE+JqmekETopmCrMBSN7DAM4+mUEh8DcklfkYLuyCfoUvBLVbSppIs/eietEsY9eafxtuOQ4SE+5KFhTYGogFy0WnlAi2HAtERlxABfkTMY9WVvwaXyNiYQxJZHT7gxMtVfLcY4tEtfi+ztUXqBfFwri6myX43Qg7WDD98T8mG63yPN2hJeWfRq7odlhTRT2gm2cmG8Fi4s7yZTZh+gHg8qw/mt9CRoAKwryO4O1kK9i3/FkUA5qOZTUXcwrEPLpG0cZurpecajVdpkP10+gNvp2fSL/TuySd3h+8O+W0/CBKa2Kfo9rxCtEFvzhHP6ntBq+jL4b4UQSKG2UyduydnQLmFmCy5r9lZqQ2VdMd1XkOV5N9bCLxPTkDZ6eWjmy0ZML4+q9DpIU8XUDNkvR0V8RSiN/2pUAD5KX08vMybRwKwHjHVB73+Zh2Oc+uw5Ni5pOI98M3nsVLkIREmQ9UNoH/KnopI9kWRLDRm+FGbviGyU3RjBpsacEgD8C0pgNLGaxigdZu+M2CuvIfX5hsJc1XNTMNgo8DyAONL1U1VEor1mbQXHAqoHLKCVrYbO8Dp/W+RvCtB5IHca74ZGxWDIruW4fzv0877Win3Kq3P9GuFHbMFotghnJcdFKPcubFNh9h69lgtnVfZNjXfEnPFN7VfbmuydEfCK2SUaBGW2s5vY3TAXfGN0j/SevQMeDPzuwtlNplHdbP5X8SxEtd7OSzrKfi1KU9sieUvskNkupME9SotE2XRufI/fzqVHyt8wTWUYOtsXsq36t+zOEDfM84FUwceyaxOBS0/EjqG4DigsOM797HhoPx1V/uypp8g7Tx5md4UM76r8vBrDWv3/tL0HVFPL9ji8z0lCC0hEvXY9xN6xK0aGY0GxYcNy1YsRItIChIBdomLBiopKFexdsbdosHfF3pVrRcUEFeyaz5k5CeAt773ft/6spZk5e+qePXvaLlJpNHbIAnySwFmJzit2pUJmRU+yBLCWFheHSROoOBDV7MJibFRcRLZWTHgkTi5LwxIj0yUC05TNkWAsckANStA2hsgFgdXW/8IJi3ngL1CCANlqMd6gb2OkhxyAeLJbswzvesSefOYyPDx47qctY9lYPskCSLQCbq9iZcli/CNgwarYhoeiEzVXQWYqn4cHlU5TPm+1RbyKjIRsmoSv4S1oz+GMAtHzNWRxEtJFQrtgoc8ZEmopkmzgZDNxuhQxX7Ca5d9Ul9WqYiEkmjhNLNBTupjPzCTNzcxk+RMXcXNJMC+Rla0QyzLE/AYK35DJ8k8pHAcLrPAsCtdn0ubz+zNZaoIlK5PltxAEkG8FqwRZYgLYvcySP5vmz85k+YTTJDUObrHCz1D4mUyWX3OGwHFQb4XnUHhOJiss5/ztTGxnFIfwxxPWlLk0ZW4my+8/S1Li4AUrPI/C83D15wgcB69b4QUU/imT5bfdhg4M4C98wgmS9FsmizUMyaf71iyzV5IsCSvZTtt0Ol22pC0L+CO/n+ZKWklz4U9Prbk20FwbVrJ83CWK8pUs/6kY5RSehT9eJnAc1C21wPdT+P6VLH/hCh2AlSw/2wrPpvDslSy/+xpF+UqWT7DCz1D4mZUsP+8eRTlushWeQ+E5K1k+8z6B42C2FX6bwm+vZPnEB3RIVrLkYU4YCArPxY16SAdiJUveB4WBoPC8lSz/jcJx8LYVXkDhBbj+XALHwVwr/BOFf1rJ8if+JHAczLPCdXSG6laxfN5jAsfBAit8NoUnrGL5nHwCn72K5b9dJ0H8dcsN69cka64kmitzFcsX0lxJq1g+7hadU6tYfvct69dMa64NNFfWKlY2X4JjfMFtOuSrWH5D8ZDSZNk02f5VLD/vLh3ZVSyfVTxyNNkZDH9KR24Vy38qHjkKz8ENe0ZHbhXL66yUl7CMxYyLNHMZS8S5MGfD30nfl7FS2QYxZocUlrmMxYwQw9KWsVLikpxwX9lKsWDlR9gOY3a9UoxVc0Hg9zUpa92wjMX/6Ppi4d1tWHFJEWIxXlo8GXoDB6QWQVjfDuuARGNleMt+ES8jkWIqgcFBsHDDgQsgO3Uz9BbHCswIJ9UGN2OAYyJ56IZfG6ReeHVnOOrPixRSOgv5QnPh9B0YfEnDYi3mElICrLQLCOINom7CPQtvhp5OjLXm4mI4JpIIL0k4EXYIjHc0riy5yu8KgploEX2AsBYD/1QMWLKTVuBdnkhaA6/mtA+6jYx1cSeIwcZpSnSYPhvI4ZfkRBxAG1x8WVS6ryUqSNjzP1VgSf4fKmgolODVlQ5KYxAux8QU70xx0nLU0ALD6xjvqlS3Rdq6ZHax0AKOyiN7V7XobZWW82ClDciribCCUSlrO7nFY7gjkT2kcgp0y7DfsmWoR85RfUpiG9sLK0aI0CrP0mhpjC2AlM6HjZMXY4XotpbsanFFVqz/jxVZ8v2Hin5FvyC9TY0rlE7qCNQoAg/dq0pblca7SKgbb366l0Z7iRJcwOKrw5Z47OaJ9Aj9xIukbaGkmQAxsUpAPJYQQRHqG9wuWBbHCgIl9NgiomOUZBmjwxLGUThIlsFcwZWKSYo4O+K03NWOmJQnovL46CMOdqWbetokoTUiyyUpmZ/4DtgG/5Sh52SRHY9FwomJgrK0KufaQO/+HDlnfMpzFiwplMXm7fCRwNUFW56Q24e4OuD3R5qrHDmQ4k2yXIqb44L/c+CBs6/q6iTy5MrhTttzTrzYuyoWawNZNit3IFtzPtZVhu9T7cWxnBOPfapgydye2EYdzeZATkNYYDfE1QnbwA8mL672pBx6pSnFBThwsmAiyy4OdpXi+7sQuQv2nsLZk5Gl98flKK5lrvZcWWwGwpnES1wmYwP4ZViwYSyItEiACWKVEqsKlp3slFhuhx+OMBngIwtnFyyX0NsCK3+jw0Du0mgaeyENGQnWMpzUjgsZVVt890tftYorwQ5teNbVEd9SlyGl4+sxfErj7LydsLQ5MQiPX2UlQk1yR+FV1hEbCsEkwoS42pU8wFjMrATL6cWQKzVnYaUviYW+xBb6Ik+6YkEtA68bro64PQSn2N4RObhRoXF36zsMvV0gLrKLLw4s7rFl2Va/2CKLqbVLNlbKL/vPlC+4R7IjbiT+gfJj/0L5ZS2UT6nehVYjwzSB77bxO5ddMCcTmuhCqN7VCXtRwKZM7OirkgMl9TLUG4+EaK/oWE5S1RXf5zkQv2JVXZ0FkipDJHG7EpdDTjwbI3fkpN4/aX060zvSieWcOQdM5lLOEf/rXZVjZFdZuaNlcthj+sZPPI6uZTCZS3k8os6kFq+q8nIhrlLOmStHjuLOnBNXJpgklpfBnpXKVCVTxjHY1R43g+GkZEaUIW93ZKY64f/sXR0po+CcsWcojpHtZeXYlRXPkoso67ywwd49HMi50JEIlFqMDDmQSjFxE6Rg0iO6JkyIXEoUBFztcQbyxoBbaY/nsqOrPedEGkTufUgRZJY68AnkUc8Fk4Ws1BTl7AliBHuTEkHsl05OnqFm9Mj7CkuGjitrsWMkOyOWS3g2uIzIDljGOjGx+SJXooBggyeVLZ0QxANLyTSWyUvuoIrnr8g6cYtp047c6fIMVZXE9XYlkxc/RtlaKqB0KhY2lH8//WwsRC6xEDmdfnSZYTA+S05FfC9fVhDmLD0VPX7xVk9WJGzpy+qpXmyx/STbi6ejuJSb+sVMqfy0fjaWZ0n2EnwKr5FEVaIK7j3x8c1RDIX0dIIq1EoeK4rlsBAm4VUWJMiLddRBWNpDiKwj5VVk0yt1tbi64ljpGEYUS2cw+4tNNEfqgI+xMJkSPIhezxEBYtxBQfJVRB+lyNaJrCcM1iiUnRfzjJdU2skqCUprgL/UALyYZ/jZiSzd9VfFfK1E8ax0CVbnFV7v7PCrH+VImFppF2xLDo7tXwbHljrIxdTM8E8TWY6piofJnhoyklinB3E+V0bEsgxIsas5qUA2+J0Xa3dREieE7SCtAH/TY2mcjfXNwCr1jTcvkjasHbkycwyW29OdD7lWtaMzkMhNM4LDGIYT+ZBVmXUUSan5rWYMyCW82XwcejpRy10Ssrn25InINFll5EwI1hWQYPtdAjEwZOGivpDMzr2JcLQlKdsdr0olk/I2MXw2oyFLnZCsBBBF8joCFIrbLipdnuiv5TnG8Ln/WJ5NTHGR/019+0SW7hLXd+LuThKMF7wL0n0SRfK6/aJuThZcCHAH3mwbyUl4By1Jw0n4bNtIOcs7aDUaXqcTB1tQinV+eVbwQ/hLU1jcVMxjeDaGL/iH9rK8WMu74RrYGN45UvOPHXPApTnjhCTDrwklQkLc9l8woMsWeTuJS2Nc9P8E41JBLwT7GWGEi3qexY6uGfKeLCUPAEAXG/rGaGfRFSVPhQ8lVv37f5wFjiVmgQOZBXTlIfOcCMhIOBF+qncgj6GcjQ+xRSflJNiREiOMnJjDEjuCfQOeWKViOQaf1yXCCyzDH2O8Ma3wjxjqKEpCiF+CC2Lkdnw2g/vdjezRUCTH8DZaPts5UlOiDmuRrFCkqbgokVAU5ie4RFc7QV/xDUPOYnwudqbI2fG5TCSfyXg5sXiDSqM6xsuJIcuUtRUSfElf3CR73CTcLt5GixmmVkPbJYr8a+NEQuMKmZ5OEh47HCMNFGMykTQBEW0gtg1A2ikpoVtZwISUkQDLsgx+UMXKq9T8tY+TnSP9IrTIltKipYGlm16i5dioJEvrJoOG+yHHb9w2WrkTn10TTwBHLa/LdcYYt42UM7yLVqPRCL3CJjDteHEML8JgOy15opIzuHgNx/CKSI2GzzZDMK/LEmlw7x2ISxu6mXHCs5yz12CWoOnAUHEr7B6aSu44UMq2PECJOElPLEcgtdA3/5/pWydmxMQlPMfKgZAAWPTgCMmKqXAKlKRUIITPBJcgVrykU/JkSpAnEPIk5gMZeTGqWTJDi8nTyrqAUqUwkqbiUghHBjziElIY9v7Jv8EkR6iSip1YqFKEN2k2xZRHd6eYlES0NEJGYs42BG9QRLhAYkMQF29Di/9vCMrbiaqKCgSFyV9SkqDEJRshKkFcIjo7bUj3a2I8uGh5na4AIinncixFPYIzNjzquCM2wmzr5sSWrIyxoJRQogiXTiaatSD8KC8KlrpCCQev5NUYC0OIpali697mf17sJWSpF3GS3mSpx5tRHsvrSugqYKlfwusiIjGVk7vBUus+Y1kKWLLu48W32FLOv6777P953bcWQ7aS1IMrx2JKY/+frf0sJj3ml+Jd/nkpJnX/a/H/+0IopmcWshCSNZD5jzzipZhKNv0bcUj/dg2kyrykUSVWwDJkBaS3a0QAG5MQVpLqQySjMMEIGyRCSo425LqDY/lOeLqyvB/lC4yw+DG/LH5kn0mmmMS6AAqlOjGO5N023FqCSCgBr3lM8ZonEdY8yf+vNY/HFxv2tCWWiWlnmZi/tklL+RPdEIpxY0SuTn9tmtC8UlzJ7i9cya40V7IryZXsS3Aip+IwMZjrhBtrb+FMkmLOZGflTNYpja+fKBsgkpXBJdYksXVNYjiRN74YciTaqv+R1ApEjOTflyNyasKG6OTUkI4NYdKYdCgjsSKVcP1OdEHy+/f1iLKrYqZsWZNoMcI6EP43q5GtsFxwNsJqZCOsRpLSq5Hk19VIW3oxArqnKbnC2Zawfl9qsG3/Mti2pQfbtuRgS0oMtn2pwWYslCkMtk3xYNv+ZRmiW6cSS09xJQwvIqadCfYsVC75dfmxHkCxyoYrFC8/v+HRp2/SVLSAyOzR++8blvtvkmi/JZGsVKJblkS2hC7shF97KmZGTuYmkSUiIxH8qMfP/k1WqwpVwbx9gpE9EkvTip184/M3I7vClrgzICyqhK9v1uLrm6W+vsUWX9+sIOZng8X8xFTMz4aK+bFEzI9IMGIFWZEg/ySozYoEGTBRaSfe9FRPG20obnQ+bXQZQX1GtpmRrZJIn+NXfouMRz55pnSW8meSiQd5LA+SxFJ5IJkRo0YOGNbNCUga8kYqxWn4lfayx2J+SxLLbyCh/UksP5OETiSx/AISykli+e92OHQ/ieW3k295SSyfREKFSSyf74xDumSW3yPDoXnJLD//NxxKSmb57VVxaE0yy+eTHFnJLG8oh0P6ZJZf5IhDBZaX2/xlLG4YeZtOYqXVSMNpV3jHENkKiZwAcFekhQzwnyxIKLQg4VOKBQk5yb8i4VMKRcKnFAsScpJZ/vozRvZCzN9PZvkCGsxLZvl5z0mwMJnlt9CgLoXlr9PgvBSW/0SDSSksn/iCBNeksPx+GsxKYfkzNKhPYfnbNHgmheXzaPA6LoEGc1NYfnYeCeansHwSDX6yoKRwGYubSV7FkwlKPqX8ipIcOrrS15i2KUmLrObDqQl+uQSrdOMllwjjugInkrPkUMDIxRxQWzXiEEKkWP+DOD4GKiVFbuyK3z8tCugsvvBjnUBKdj30uhuEr+T4g5X8xcFCXtbi2B6k2CYLCI9kZE7YWBzbcyKqto5VFwjnJELD+GWQxBmiMS6YLz+HJSSWC+P/zTL+memW8del/jr+mel0/DPTLeOvS2X5AkLc81JZ/gUJJaWy/HtCoGtwyIUQbSrL7yXkq09l+RuEuM+ksvwnkuM6LoVAc1NZPo1Mh/xUlv9aBoc+pbL8EvItLo3l15FQQhrLLyElp6Wx/P5qOLQhjeUNBLo7jeW3kLzZaZZ6L6SxfAGB3k5j+Qsk79M0lteVJxMojeXPEOi3NJafQSbV7HSWzyN5E9NZfi6pQ7dcoKpvy1jceSJlkkqoKjP9V6rSpVKqeoyFSiyIjlsuIDonw4LorPRfEZ2TQRGdk2FBdFY6y2+glK1PZ/kzNHgmneXzafB6OsvHvaQTIp3l02gwP53lt9Dgp3SWz6bBuBUsf50GE1awfAENpq1g+aRXJLhhBcvvp8HdK1j+Pg1mr2B53WsSvLCC5RNo8PYKls+kwacrWD6LBgtWWNvwbQXLZ9OvszNYPocGEzNYPpcGMzNYvoAGt2SwvC6fBPdnsHwCDZ7IYPlMGpxtGYC45SxGChGTSicDkJPx6wBkUXqVqoFPsOB/ngX/n6z4z834C6MT8P/Jiv/cDJa/Xp0QZgbLXyGhBEtb5i1ncQIi8pRBWcxf2pJLi5RGAJ9kaUuipS1JmdZJl/lrW5IyaVuSMq2TLpPlsyg65mGhORpMsrQmcTmLkxDSzCStScr8C2nSQqW1gd+w3FJ32nKWP2iPxQo3LLfUlbaclToA/iHKUXWA329Nv2U5y8edxOsr/ihk2EIzbBEy1Ab+jDWDfjnLnyByi2es6fU0vb64gtvW9BeWs/wGWsFta4YLNMOF4gryrBnuL2f5VaSCPGv6+zT9/eIKPlnT5y9n+Qu0gk/WDPk0Q35xBbOTLBm+4QzOuILZSZb032j6b8UVJFnTz0ti+cxTpIIka4Z5SSTDvCSaAW9ZZFMleHNWk0qn2AXLiaUZqrxAglR5wavk/UOxvDSxayqivhyIidO/E5tgLOcHugfkZcFSVNoPAtnAE39L0ATGEZOGjDuMo2dy/H4ji5dgSzoWUX5ajl2wtJ1FPLuK8CuIwhPZ23/+VAVrl9AXUaJnQkPViMgL0QgRe/KrK8hGEn87rFa2VEKEz6jsfrGiRCMoafcGOIb6Tgeh6VSeR7Al0lgwNSkm9uYE8RkgWGSJ+RqL3x8sqkYGhoic0m2lY7AsQUI77RhMP5HVWUo0GVgfbCgFyyFMipRT1Qbyw3pVlfDFdlPiJdJ6VrRbX8jsyAsZFeJmLOgVAUhbUYpgOKiK34uIzPVWRg5ODH9mDZGIJ8LeZcuSw4JMjBUx6M53zTui0+KO5evwvlfOYpebSyVyETX4QwQMxBbLW0C9ftAXRFkqyVoZt8W+t2A3NFUi2A1NkxAlGuKyTS0HWRpVZnkKoSEY1hFDnoAlWxLOxvAvbIUPQqbUUpmEkpMlgp477xZMZaaZYGK9FF8FafmcNwwWietAIGyw9KOg5yLoSbB8uBw/68RGBZO6iHUe3Hn8FB/Dy0K8iVUsRlDJsBOO445EpYJ6miTKGbKlRC3JHuum4BOKVLZUItjoY4kdq6P4YozExNgYqA35QJwABYfI7S0AG+ykxSGYk2Dd5qPkot4BU5uDYAeHpWceKT3ziHF6+2C5WJaEr2XAHWxpMXa8LbEka2cxE+yMpwNR/S+2scMINnYssmv7SvvNw5ix4ZgQK1psCVpsitEisaJFYkULfk2l3u1KosXGghabkmixFdAi4rB2hgUF2M4EJyrZedvSnScHPkmJnpUHjhGOiyfxcS2dqSKVDmGoRzyO5R2o+phIOFBS1hROVcdY2VJMvHIxIXJagbjkiVJkIe+jDK0t0spOxfTkitWGGbnIiicRseFJ8hFLCmJqlYvlRMGcWDDxi0une24itIMNNGGfX3iakTgjS5dY9dNiS45LcY1iIQsZIXpywJaixLgeXPdR0j9OFCzHdWG9SNoMMR4g0gxav1hoWgjxBwTW2q2SCYeLCYMKGTHu4Gy9Q7GQlOw7I4jeysVULIHFtyYiKe/gKuaxbThoAlI5HlMnOpw8I9hL5sSC1SgCoBJLGOV0rIDKflAZQUzpYleGXosR50YUoSJqSpq8nYgEa9L0sC9dx1hHzCojhZWrYtuwjqT9nxm5mCf6lSyVMxNRC3ciyt5EdC1sw2IzorF0jPHZCMucElErCseq+ljDhOD+CCuVY09ZsdiBJUYJ0Ymyk2OxDdz1nrgLgiQWI+jUL2R/4UzkRuSv3AmLSv/v/GmR5Bf+tLg0fzoj8CesCoNNhmEWdeYXFoVh2BJZMNUSwzrxwVQvjLMniRme+e+5FdWLJKo3RPANn0XtSto1P/4rQ6IIKc2UBGz8j2yJYqMEW1pcmi2dKcmWSLexIp+FN5Xo6r/yJtyJ7L9MHkJ2//XkYVzFRJ5BmDzML5Nn/f9p8rBULFsOJS7GgO7/LDRtvSyTtrV646UKrsQnW4VgYoaUY2SbJKQ5+AMWULrHCvZJpRcZIqUvSAcyIXIxb9+LoJPDAsOawBD+in0o7xgjlxAi4jNNTDBRO+4ZwjPB3Ul/2NifM9V89FYzfDOIwwsvkV0CNlCcIhFMFfMJl0AtZ2QpEmIFL+ES3iAkS6QWsO7YrWYYnkThOBqKLfsL2ZJ/yUb0pgQ9PBzuSHQQmgDHdqVrJxEcF3vRDYiXRbLH8l12iO0qPSSiF56ewWSZiOUZ6uZYtlmCBbeAmKytQhNguiCS6FhfnmpO2vJ2IdQyAhmY8pyIzzcxbYjPaIaKeKYVMJSPVQrmga+HVz1szSGYKlljMKmN+i3ArmMlVC6UyIzxQN4QsVtCB+p+WVSf5XjGqyp1KG1JWyJlpbL2dLsvqs82LsMCvjAXEdOj+Kc+zkuDtYuDbsUl0vKJKkV91s2JEVJ2o6H6AmGLiHdozBqxb0Aee44jiCKeEnixhge+FempmBfc4cZi7BCFRuxah6HaysSvAlWIEKwfVStrS0xLcnKseiwWZI0rCY4JGS/8fCumDglBOkLY8MvkIqtycm1KDZXoPl+GbXhh2vKiFFGJZ7vR/UQbtpKzlB6C2uAdJ80CpLPBbdjaUmkVQRfGzjI+VCRwq0QqbflPIEpfdnKL70iwdkrqK+jCiInSMXCsBV/Rcuy5maiCVKHi1BLZDgl+J6JqM6QoCZ7uhAtHVi1ZqgNpCTmoRJAK/qVZjoJNSLlEAGThR0fBNzJug0gbTJJUChYUZi3J8ONbGyfG4qlQ7I2vF6QpjHCKbM0K043tZjlYtqKfZHK21MiIikcGkzsWhABKfsJzlWAhuz5bCV+TUl1VkklETN+TtDgXa81SatCEAcXHPEubiIlSICZw6T0u24atJsXP/SILujhxSXTtlhCiERwDUhBljfVZmXBmL4+7SrYGpDUM7h/nTLhYG5bDKRrzgh9Egm+MfYJeEUf2u4IEt6Q3dfnagWlFF0GyXohlewWMExs4TaA1UV1pAq3IC58NLr4S7g1eccj7mx3PRpJH1OIPmJ5EggdbIr7Liznbrk5YkxobsWmMF9VIJ4pyPDXJBKxP0FgfB4U5z1jnDEMwa6EkCe2ZjcVHqmwfWRwwJdlg6SUt9kNPKEliUcQBnqVeTi2FYzMrpJus0HlrOVhzgLPxFm7PAXdG7Fmcmpbg9S/5HFkpWItnLBlo5QR1xNTEP9Qplfa0zFW5LW8XjZ1kYgU1whLx3mEHkZEuMTtF5EDIY9sFeH4W+5J1AKm3tSwbXBYxIBApmLIhM91VIv2bmW5DShILJWGmLi1i4P8RwbKeAsl6FdNjCT5GiLJEnwhNEnE4EaYkTJldyS4Iv4G0YRv/34iqmGuW6rU08b/udlcn+Nd+MyX7LTSQztcS7WSLKRSsLQWhpdYeSpezjI2Vf0hKtIsTy3aRa5Em0NrVls4WLKsF7tCaoMrVjsZa0SlkX+xmGM97W5JR7qBxtcWnhCbQSi7VYLkHTBHdiW0ZGzK97On0srFSOZYzKUHhohKMQSQl1ryLOQPVVsDDbFO6elo5Z4urp5VzdhosNI3nhw1nT+YHsUZlJgqYpFOcnTXWStoe/g0rv4xzqZlS7Z9zSrFX2EJnYkhFtgwznwR6AyYB/ltVaUt6kZb/TngeF9PdFVFSdAyRE0ffa8RESK+0CmC2RHg5F0MtkNoAB7VBKoNagOUSIiKpsA+5K8NN2cqJt3biZsYRL9tQtkIxBHdlK2dDoVC2HEhr/R3EditnZ0lTFaR1Svnt3srZUpjdVs7ekqoaSKUZV5mdDPA6O+nsyl2jtEFhSm24pnO4enRQoLt7oEYZE6QdD0Hq0UFqHIjQhI9SjgoKxeGuapUmcPxApTrEktxfGaH0x6C+GlVAkL82KFzdVaMpLi5MFRauGQ9eqlGaaKVmPPRQqulvdOh4GDgmWhMVoBwPA6NV5HewKkBNQwOU2mgNCUSr8U/vcPLjpQkiMeV4qBPWrE5AszrjQcFF+oUpx0GTRhzHuQ1xGwdN3IY0chvCuQ1p4jaukds4zm0c9AmPwdUBHx0YHaWFvuFR2miNytJKjSpKC6oYlVoLYeFh+EcbFKqFHuFBam2voLAgbZQlZYwqNBz31y8Uf4bOEUH+FpA2XBMZrfobgDo6NNQvKkLpr/IbqwoKHPO3BQsQXhPWVxMUrnF3Dx89OkqlhV5BapVSw2u1GqV/iWHSKjWBKi34aIJUaq0So/2fklhH2N09QAu9Sfeiw3xGRak0MSr60cdfC2OVoaF+Si1GPIzW0JH0ixoTPjaqRJtigqL8w6OjaPu9hFTFn0mPOo/3Dy1GrDIgKDoKugRpVCStMrSLMiwiSB3o7q7014RHRf06ElHaoNGj1SoMUI4PDVcGdA4Pi1Cpo0gXLYlCVTEqTRQQAlVx6uiwUTgaGqQOiQJtkH9IFHhwblwfLqwZDeFfNy5cwzXntOFccze3xm5ubpxGGSDAi0PNm0WBUsuFhUdpObemzTn6NQoiwqM1wEdoIEaFUfxvjRujVAf4hceoNH4qPBH+Bin+KrVWpcFYDx+l0oCSK9URTKoqEhigitDSUBeVPw0EhUf5jVJGqdzd/UNVSg30VmogQBMegdNCHW/3Or3d6wzg6kRYcKNUB3DqcC03QaUJx1MJekSrIUob4O6uGuevisDtto42+JfoDQSoYoJoSMlFq4O0XGS0UqvSqPGX3uHqvyPhSL+wIPU/EWygMkj9r+RKEvxKnqWAf8Uk+fwXFiZMxKigQDWolWrLYAk0HKaMivILU/3lu394GP3cQ6kuNX0pR/BTasIsZAUeHS0BTF00GoZ5GmjDw0P/hk1qVKODQkPJJMNkFBRaYlJpVFFBAdHK0L/pnzpcE6b8u/Lw6AYpQzE/hDEqZah2zF/REC7g0G+UUh0wNihAOwYioqPGYJrxHwNKrVbpPwbzw7+fnaHh6kAYpYwK8veL0mqC1IG/ztQAmhT6RIeGDsDM7VeA/xilOhAH8C8oR4XHqDg3QpGWGdacTsSQQILHEFxfIF54oE5Tt16joQ7+NxqUoaHh/rhjioEeuGEkpqofFTRB5afl1A24eup6HCZnVUAUF6YcFxQWHcZFRUdEhGu0qgAOp/vbESHYAaW/NihGBVpNtAovQ1BySvdXhkX8QlQapVYFofi/iPAoFYxWhkapSoylOjwoSoUnmerfWMRoZYDKTxsUpvrXFSYiPFRF2U9jK8ZacJizcNoxKm60Mkqr0nA0Vcf/KtnocI2/CvxxRQEqtb/qr2NHuIpSTVKF+fmHxyg1QST6N3MoShvwN1MIf/0Vh+7uESpNUHhAiWGwfvpl3zBYqfUfYwX+DXoEiJVtlyKocLWquOeWCv55HIQxHRUerQ7421kwKlSlDsD0GwBjVKEB/7TJidIqtaoAskioAjB+o7QaZZBaFfBPzDBMOc4vKkJFEvw655XqwOhQpUaAk0mk8lOHa4P8VQF4g2RhQlxUM40ywMqKfomSyF9YAqbeAL8IihG6DoxSBviROYUXmRKU7B8eHRoeNurXpd7y2Us1Crw0SnWIkusaFhSi5Poq1QFKy7IzLGwEuOG1tlSF3LCQwBEWRlBMrJYtJDesh5Cr1Jc6Sq7OKK5OAFenu2V5Gwp9fQZ4D6GdHQwWAPTh+0Df3sD3hl6d/fhevQiqekAvvk838O7jBZ3BrXmLlq1at2nbrj10buo70KtJO1oIIaU/WkBzvEto0hyUXKhKHagdw3lwbjA2SDumKYQpx9Vv3pgLbcypIqL+aNK8WYsGXDMuLEhd3xJvzEUFBYYp/dzIV5y2QQNO0ZFroWrSEidV+o8JUqtw9qDQcDVXv72qeQsuSM0FhEePClU15po3batqhT+MDg1XahtAfbxxbACdlBpNkErTNzxUFeXuHqUMiwhVBdSn1N3g3zeajbnixYvuBawpmlqnOoc7QDomNL8B9I3WqLiYII02WhnKjY5Wk8Hn/JWhoaoAV2jMBYZrOXDnVOMiVP6Yx4Lwx2VbQinJ+G8j+jIlWK9dMgbtrzHjdb/9C9DE8tu6/TlBiyj8ABpN/p4j4E+5SlmZJ/C3XaWeNLUR0bKGen7b+PZq71F9kaX00vEC4beVpzXOr5NLRZ8QA/wRubRTAfqfm/NLN4DfVos2L7vWPzevSedqrx+3aYj+c/MW1Baat6K2VNMlu3RCAEszW5K/a9bmUajMk35//0sFub/8ugkVVvK0NMBSLvAr6kj7F+e7eAH/5ZO46uJFnnbklQf9/eJB0RSHLL80X3uh3E/C90QEfEJdaa6Y4ueI8Hn3X35FdjSjjxSAwQ2UALAA0NceQAQAraUAYgA4kex3kZn2HCXe4ZbMS3uOxozbZWPaPA19XDgjT9ZOboCz2rxC/UTU6Xf/HPuVS9C7K4/nKfvoUAP58YYPz6QhUd2I1+oVKaiFr1vDjeUiDLP3t1/qCDPQqrpfJiWW7YZ0XcrVH1V2NYqf2Hhy3rRVSDF95g/7pjORMeZwq666KMNvFSLdzw6aZUjBzWg/xzB8sSim9fgU9K2K97QISSJaY372+25IR/5dVuXsNMYiZp1jtZyrvgb35wp/v51TUbsVl3UTWq5Cum4DN6ibrkCrlj0fZLd5KtpWRrd/82ClYUefpabK8REG84QZko+ipshn7Ipxl34biWr77/kceyMS5flUvfHSMwYtvb3n8IPF1VAtfUc75nN/Q5ivyx3boW1QQmFQhe8r49HXren17ePjUMH9ifuf7o9C9RtkwTpHhUE7aXc7/6QBht69Ko4q6tbdgHEurgBgCwB4COwBoE9LTZiqnWocYStRzd36R6sDVT2jtVqld6+gtl27dv0lRdu+Y8ZHBflHWaBu4wAelgcYMg5AXx7gW3kAn0NKSeCWB6hSky4Dv7q+RKkfpl6VRpmE+Gf0WNVMHttogsJ2ePmWdddNVRw+XzBhtm2EEF+ksOQTfg1XXVvGTrrDegq/2cCbG0rzKugo3N5T+M3GtCMW/tkAwPTPq6BLHzV8a1ABrgyuBw9aFcGoe9mgSF4KfEJn8O/3Aw493Az7lCfBXV0brvbuBN42uWD/qilUW3wFXlf/AQ12VIM8j/VQ1HoadDnUFNJexsHuuhHAT/GDm4vaw4Dp7SGtsD3M9YuD+p8Pw6eaHeCheTk4J0mgbDMTOPw+F8JqhsHlKW3A/nw98PLZBytGI2jyyg8O1ouGZ69PQ8eJb+Fje1tY3H8OfA15BTV3+IHdiPngJhoEE795QcHmEOD0l6FNYQo82Vgd/lAuAruqz2FGsgoyy/vBfM8xoLtthnpRvcHGpjmcG1QBzm6IgomPR0LIvGyofKIbXAw8DvZ592Ho9IYwN+YErKu2DLpsfwCVB1+BtR4SkNiaoeUUBMda5EGSz0M4NLkF1O14HGqEmCDj0x/QuqY7xL47B29nVYdJCa4QXHsS3FB/AbcmY6FCh86wp/wpOF45HbaeOAaNe/PgCCNg5mQveBLZBFJPpUDLUQC7r06C3euXQ1vfG3DL4wOsllWC3jHfICC9IUTc2gz+kz7BhKzBULHCC8j2HgQdbt6B9XHtoHat83Bzzlj4fWAtgJoH4K1DVah86RFkNDfD6BrBkDxYCVu+doMpsbdBrtoHLfLi4blhJJhOXITQNvYwAl2H3x7egiEdHsLD1MVwVV4f6s/Mg8dDesOpcy3A7slvkDv5PFTM7gvvq6+HSrnDoGm5VjDdZRRM785A0YJhsDUrFmq8fAfde3QGWeA12PTgNmzz6wTBykvgUH8NXEveDTbr3sHwsbGw+th0UCpmw5yocbB93u8QfuswNFnnD4WG8zB/qgnqHg0E33Nd4dydNlB/w1U4ppwPLmfHgrhueXDxSoUTQ0/AmZNdoPfORQAV38P1zluhgfcz+H5DBnDkG9RIvAARl4xQzqMI8t/qYNeL43D6U31YIkmEo5Ee0NR+F0i7vofZLmmwmZsITfdkQLfFx2Bii2bg6BsGmvUJEPKiJjQ/vwzG/9YD+PGPofBRPOQlLofHz+MguflymP0mBPz82sCh72Wge8puCFwTCpGaTjB/RAvIqLAf9M/sYX7zOvBR2x7cJNXAyZGBnnZjoLFxCHTblADaFywcvlkbPk5eB+ruGsj4zQQLEtfB7kUf4MqAfnDZ4R1wSS2hqOcU2Ok/Bh54+IHnCBHMiI8F3/4NoG1ANoTdlkGL7i1gWK9o6BN5HboOVIPU/ig0LAqC8qNvQD3bdBgh7gu7O9yDVzEnYdbniuAdMhmq1zsIy4IawKkLW2Br+YGQ8DgYZt+Jh8aaviBecwTG2ibCe7cIgG/14FXkBhh9zBsCcjvC8gfTYTVaDp0Tv4PTzHnQnH8Ii9unw4OIeVBx3wuwe9QBKrRtBMN1mfC7bgnIyi4G57zbEKrbDvfMPaFdgjMMrRQDo9ZWAOX5Q3A6/gDIPA/D1Xdi8I6uB6/3foB78kPgUH4TxNdtBgHTY8C+Q0sok1gF+rlvguqrj8H2N9tgeF0XCDvWG5pMSIPsQctBhKaDfcEHaOQ5D8KaJ0P73bbgyFWA28eHQdHiE3Bqa0/oc24trG97EZ5vbAObFyfCg05joLL/Q4iZZ4Ixc/vDt3ttYdvKzfCoQnOAbSvB8etdCOg9Gt5I9kEDlRsMHmSAbmZ3CP58AKKPvIf6Sx7BZp0bjJ73AcTnK8AXuQ3ceVodOu5aA4OrLoQ2F+2hT6eXUO7IGmhZaw8UbKoCPqoNcPXoWpAiZxg27iLU+hwDE+eKIb6iBk6tGwDh6sdgeg2Q2mMInLi7DzaNPggxly/DFbY67HjbBOYlH4XjW8fCzO534eOITDilK4QtBc3gQX4KoOF6yHkYBgmna0LDe3thdR13gO0psHXAEtg7WAwNmuyGnropcNd2PcRsKgMTh66E31wawv19TeDLs+8Qf+8HxB/5Dk9jQsFm4zfw0EXADHUF+D7LDPU9bEEZ2BIaVpoJvQ+/gl0vtsPCMDUsDWwPzQ3DIO5Wd3B79BucbtIZ6ihbw9mIS+B2fj8YQr/DGlgFktCn8PuDTHAN7wajXK7CgeFxEKH0hpBBuZDcn4G+vm2hxo190PLtCSin9oMRbk9hRtONUH3ncVjZog3Y7VsDr3Zch98+usLCoKdQzzwWHEU6mO/ZBHwuZgK3Nhl2rboGzUY4wO7PnaDs3fMw+UgOpN47CpsrHoZzq6aCXfBwaOpbEeqBL8SWL4A/bWdCeWkALOPnw6wjD+Hu94YQUmcvTIxvBZL3P+CAYQWMCfaBHg03gM+J36HJJz3c+j0JCk8vBafe84FzXwdrBvtBebQDdO2WwgWOgcgHM+Hsw71gGFkEvVVlgbENgXlZW2Bndg708+0ONb6WgaWa47DapgNke7YGm/sTIbfrBejT4AvcPHcG8t7zMCngIaQG3IY7R5rDmuXHYeyQ6xD05CQU3C0HB90V4FXJC3yj/eDq4SJQLz4FW5qOgDJd3kA1j06gPDELGnx/CS9uvgf5pHMQvqg12OWeBPOt+aAOfgxZ30/BErujMGmEFkK27oSL6nTw0EyEU2WD4ePljdAg6hHsOXsQ9kE/eLzTCbQHa8OzySNBe3sOOFVoDFMrOcKU0YnANPgNMibEwPfvR2BQVxPcmdIG8u+Ug7kHD8CJ5d+g+YZ68FZ9HBJPtoHbGwbB7g174PKFMuAS3wTCB7eCxoPiIfnSE7jJHYCQPzaBR8M0KOt3Ab5Le8CfhV9hQYcweDyzMby8Hgffdm8Ek/EKNG19Fpq1V0I71y5Q9c4ZmPrNAb72CIZm1W7DgN1x0Cd5HgyUX4CGvvch+9RNkFZeBlUi9kPQ0gCo+/tIQP2NEFvWGQr3lIVv54uglb4JtNIbIW/EBXjwx0gIXJAKi1ua4GzF/aAckgp/DtZDv+mn4LaHDB5Edocm1R7A9korwbWxFwx9fwvuTEiCFQOzwWfmFxhk8w2ejd8G8fI20G6rHAKX3AffvE0wrW47OPciFfo5rYHkljtg460yECTpDqqdBRA7ez3M7rUcPl9pA66Ld8HEaT0g6bIreGbch/vdfOFPrTsEvu4EP9IfwR/X/WBi4Bo4uGUC+H5YBY1m1wL+oC8MVduBa8OZ0L7bdIh/8hyerbgO3l89wTzoJVRzPgcnh86BxC+N4NrRk+B88jLc+30bdDs5E2Z0HgWuMztA4/GJIFPOgoa9JoKucRXobHCB2XUTYJwiHjaceArP7k2EE+7HoG7hK/gYOAecFhtAtboRdFyyAw5PksKafveh3gN/CPrzAaQkVoYNDZbCmEv1wf7NbuiSwUGfpHMQMc0fpkyqBc4HWsD6ogVQftALcH1rB3vSG0L4lN6wtnI/2PN5M0x7dBOWPVDCb21YOOGeAdNXrQTNmzBoP38CTNu/EUJaDAevesMAWr2BqzAWvhX6AjO0N+RG6oB/nw3SrYwn3jvjPXyTLlqPn7+6JK9Pip/nt5H9LozrgOPTqxa0BwBPrs6Edjgun/akDU5f/X1Q6x/TGqm6VQgUjmztOv88ZP7o1DTG4N5hhT7lo+Phw9+xGsUjpBjo6+vrexItalTxsq/vWlQxZ01g2bJThSPfmU6m9jjfc1T7xDTzYcMltKfQ8ZZdyBZ0oa/X1c07p6M49z6pubd88Yn5GEivNi9AasPsKj4dUhWtW37d2PGDCY24fzut3MhIvVI31iMl34SujJ4lm/BHgn5GrDqvwhMTKvchsHX/q/MU2hkVrmXdMaEvCz7X0l2aq3/44UGDkBwTUp55ruzzcaTiTGp0pa6nTSj5WsthT1cnKKa/P3XO44gJhU2cPmJdynKFc/zn0CF7TOib6fviKnsWKD520zRavMWErqQ1i+h4xEOx6sq1FvmrTUiqTohvJQrWV732Y/voVBMqc7hZw/6Dlur7DXPJYZaYkO+rPvNMur76C81Dsw/PMaHfCm8cqHV2kT63ycZtKdNMaLvv8JdPrukU/RasPZM0wYS6L1n7qkJVnX5iv8mK/RoT6tjioW9BzYX6V/PntfscbEKGAeXQvPi5iujz4a+H+ZtQ3ddlY9LuLNNfHy6Oyx1mQiObuXt8zE9RbDowpvmsgSaU3m7m+WkvFuqr3/km79vbhOYfX9eFD5+juDlv1OwOXiY0Wfw0SzJBp1h2f/Iib2RCiRs2PPm+YJmi3aho9YR2JjS5u/ZdpT9mKdC6nT6XmpvQuxc1kxp10ykeTHqs6trIhP6wi0QT9y/TT/Uv+vNRbRNqvtk+7M+P0xR/PqxZlF7DhL4YwqukunbUJ9y5mxNbyYR2OzhqprWdq5CKnq6b4WJCC89fil9cXq0Y1Mxj43ZHE9q7Oat3dO/pigr7mjv8sDGhXtotj5lOMxXNb/f6FsGYUI9P10a0f7BQYf4tYKfdNyMSD1vQQbd6pv5txmK/kx+MaEzfnhfe9FisP7/Rve36t0a0oEm/qp9sk/Wjb0vCtuUb0dU2iR55VyL1HzOetbr3wogqVL20q3LlZP2zDeWON3liRGG9Gq7vnjFDIW/l0mvdQyOaE1R/wkiXJfpqui3irneNaFh8xe4L1w/RN2z60dXhphFVTfEOTG08Sb98Q987RVeMqOyWYyPf+HdWNIlXjrS7ZESmAJsO9qOXKQZD9Tf8OSMaL1p5988LakWO4uieVaeMyM3FGS0wL1E8vHaroOFxI8raPuHQpYQYRb2GbW7cNRjR2NyBrw9XX6JwevA9eafeiBasjoRWiQv16xunx+w8YETeq5fcv/Bwlr7T6Mur7u41Ir92zodPPRynn+aTPqjRbiP6MHxivpfLTL3z4hHn1uwwogW3vleStF6iuFtvT5tu241Ikjqn2b6kiYrvp5dfd9lqRPYDqz3+0z9B0WBg9we2m43o1anKfWecbqXY5zV0Tt2NRtQ6O6DR8xaJiu6uWyuErzeijJhkZY+n8/T292MO/LnWiDb0NnU42XKefoave9aUNUa07WWj+HED4vTc8QutvFYb0ZAhg8Y9uLREX0fuO63dKiMKqDxFt0k2WBG1sdd135VGVF/+h8G0a4n+YofY0SsyjWjagVaztroE6w13pdEumUZk3Bi23xTor29WRaXYmWFE/WbnDux4X6ePS+z3eXKGEV32+H1KQM1xeq1ffl50hhFlTZ6b3cM4U6+durZ7SoYRzXnuW6NF5Zn6s4GdBr3OMKJr1+3/OJ+WoEAjHvoEZRpR9bW9D9xvMVE/i3kdVX6lEYVkBw78np+oaHHUjXmz0oh8Q29u/vO1SjGqz+U271cZUafLu5qdXDlb71LFY2C9NUbUqm2Ht3uDlujLXeqVHL/WiGqYK7vH/aHTbz1dy6vKeiNSD9bc7ns9Uf9mcZfUOxuMCOaUGRa4NUGRPHrOndObjGj3q4KjzfbNV9zLbNjp2RYjMr84mTZyr0o/r8ue31psN6Iufu+HTv8wUdFmbIXkbTuMaHrHGutr2i/RnzIvkg7bbUQNaoTO3b9xhP7ZyYtZbfcZ0dADCZM+1wrVO/c/c77LQSPa9LlQ3rnzYn3fPg8zph02op4LRt8KPTdDf9D2XMTbbCOqd2lRo2/bIxUJBaunLTphRIeiHP5sfTVMUavWk8r+Z4zIXz5KLj45S696NmLi6AtGdKP54yczq81VtGzSIz81x4gqHNJfu3JokX5EHY+dohtGdLW5Ma35hQTFkF1u5VbcMaJdv0ep44LiFIbv431DHhrR7vQFyy8+mqaf8P6aIeSJEc1qeX7x2CrzFFuv/Z6ckWdEX+5c6bFwYoJ+9N75DWyNRnRw2/1Bd4776r9W8Nm/6r0ReX5Y17HMmgS9+9Bn8zWfjajVkq3tCm+O0Xf74+u7GLMRtZ4zJOSxcZG+h81KtyyJCV184Odwy6xVXD3aM6GGowltSVr85evhRXr7GreGHXMxoV2O2922qaMUaf1nPEitbEKJ3zOGt3iyQDEhx+y3mTOhLUPtryzMjVP0vDK46dt6JhRYpU+77Rf9FXte2CSGNTOhMZUXhzYOCVQEJZjuc21N6OqeC9MrzdHpvxwf4StFJhT+xYxGbF2onxRv26NJNxPy3hjdbptTgv5dvJPdLB8TWm/bcd2M1VrFrDVf71caYkLOck9uxaJp+qTpZ397MtKEtiw+eqPv7wsUM1rcEz0PMqGeIcyWoe5xipG7mfeuUSZU02O3reuNaXq/1Iktl08yobNO3TocaBivb7CyqLzXTBO6Ntt9pHivVvEBzX3RNMGEIjXp/fJPTldM73X6a78UEypYdG2hy8eF+rsJa1ZtX2NCk7W1Hidtm69/G7igSfftJmTHbeL1xxco6v2uNFY9aEItXm88ntgoTrH8YEjbRidNyDjjSvONAXMUnl3Vw2JyTOjNkw5PD7ZdoC9/JG3r93smlH5xUe8O8WMVtxNWTD36woTiL4zkj0oGKN5GLmx07L0JQTu6Q3ALPL1k8PumHRl6yWwY5tbv59biBkro+tpsNl82lGXe1t6VfBZlnLF5Fu170iBcRhvG4g2I7w10nuxILhscHyxNTk4+i9Z3DcQ7E4Pbwy6ra3sfQ6qOndaYzQbDuZsN68dF6pF5TFbn18kHDDNytn+cNnUfutj1SnS5/nsMGQ9zjxe0+ogg4fn42Au3DDVfNg4eV+4jAnA6Zgy/Zcjc88Vu5LsPCHL7lXtS7pZh8rxyNddd+YBgXP12w/bfNFzZfVLqvQPHdQm+I24aDjo2a9lt0QcEUCkmh71pqNVJXikj8gOChISZ5zbcMNypsTbZp/8HBH1Fgzr73DCcqL1w06CWHxB4hhxv++G6ofz99JBd5TF8w/f16dcNvYaf6h/woQjBhvj2i7teN/g0XrQn8HYRgv1Z7QvfXDM8TBh2Xn+wCEHEwi6Xll0zjKty550yvQhB5uGKNTyvGWYN8nIZpCtCoPMyPX551XAt5MWl5f5FCHLd2lVNvGpYErv+cZ1uRQhm35130uOqYXpXm07mhkUIEuo1+PPlFcOjwzvvyZ2LEHzq3ihs6RXDrYetui18X4jg04GUQP6KwbP+w8udbxciSDIl5rzJMZxZPS7b43AhAtm9SmtTcgxz6uQej11ViGC/f//n3XIMreKu15bMLkRQMLOr/PVlg7RJ5aqXwgoRZFWM7tHtsmFgpfbX7gz4GXeTdeyy5pLh97jdXeq5Y/jLLk7sJcPXTxX4PRzOP7bBqpEXDTsKPe5Os/1ZX8JSMZN9wbDwx+ARC43vEcjiBzXgLhhe9pJm3rmB41PnV5x63tDoqCx75OH3CHKuXTj7+Jxh/93oRrXX/oQnuDT17HrOwOZkXJTPf4+goPqYsRvOGqpNiDs5LPo9ArfuQWGOZw2P22z1vjTiPYLsruu4yDMGz+u9k8Z7YXj53QtvnjbUPm++NLzZz/wRoxT7FacN3k4ro8dWeo9gZNvUlNWnDAntPdqeYd4jyNw3sLn0lIH/tPRQn9fvELjVjpkcddJwZWNl1uEGjh9bOPH+CUPD7/s2fD7yDgFc7dfY64Rhc1XHCdU24vh0/Zys4wa3PeVHapbguHdIctXjhqKVgwd/mfwOgeeahIGzjhkMHaqn7hrzDkHm+E8H3h81HC5aOD19AI43rnNm5FFDB7uzm/Z5/IxzHwfHXso27PXc2IhpiOE/vO8rsg0t+AvLxlf4Wb6up/7wYIMh9dvV6hyDy/dcZtf2iEHavbd3Yf5bBJ6fPZIqHjYEqRb2L7r9FkHm7T6Bnw8ZJk0ZXLbWybcIRjbjxt8/aHhZ97x20o63CHT1XxzPPmDYW6WxI7PiZ/5szS6vdfsNhyP2Tsya8xMOW3Yx8/cZ9upNdeaMxfF2Xd9q9xruNu/Ven4Azj8rrMwfewwP/OolHOj3s/zclQ+Hd99t6HW1xZoyCNcf3PtOy12Gu59lmrmNcf0nP43ndhqa78mv71blJ5wbleRVZodhe6u4u19tcflXg0O/bDfsCunjbCwqQOA5tsf8u1sNlzIajrB5ih/DZjzN1282uK5t7N/l6k94totn/MqNhipJjyetz8ZxtuWQ2esNV9qcmt5s+8/0upuBf0SuNbQvl5l0Lx3HVd5zhq82PHrRf/vmebj8CgFPvFcavtbv0yxjIoa/npatWWGovLD1vD3BON6//1vfFEPjz/lrjUNxfOrlUR2XGRIaX7no7Y3bs2ne1/qLDRu3Fpw61Q7HP3MTm88zbGwxvpyqPoGPaF05ztA96lW92pVwPP+YyGWcYemO8jZiOxyvPd5ePNJQ5UvdjzVzTQggIe69KRxpXymPVVuJ4x1b8/dnoabJU7Nk/j/jumMnVl9agi5uNSo+1MHw+PJHM1LRi3KLRGde4tfOspduZ61Em3ecH6fbZkSQzeQMm7MWpTqmr6qi/QnX3facPnwj2pPsMH2RO44PNgXX24oGpYy0z2Vw+qRnSdFZKOnQ2GfMuTcIOKcnRQN2ItGiSdJ3i9/g8Z/7oOludGn419Fbhr9BkD141lCbvSj94R+bGtfD8ODWMXf3oYuNQzzU7/IRjKzWp/PmA4gdv35V2BEcdzp0etwhFGbXNqzu3HwE3IsW5TofRuIhIw4nDsHwh5HNHQxoXsahlnvq5iPwXNSoQmA2Qi/yjdOLXiPIWjxtRrej6Oiye9HfT/yMu527qK57DNXvMdOxxtLXCPqeXHdLdBw19jCdfKx6jUDWUnH80XE0d/bZwO5tXyPQTQhpc/AE6uFW3bWn/WsEBVfqt19yEk0xvZuRd+8VgoJKtS8Gn0KrOo5sXn37q5/r0ej8T56n0foh19DzaRhepSi7whk0N8re5Dn4FQLdh4ENXp5B9XpuTmjY+BUCz09sm0Nn0ZV3S8plMj/h0Ljam7nnUFXFvdoZt14iyGGG9xt2HiXsOC2ps+0lgmz9hcAGF1CzS8vfNZ3xEsHI7jdaf7iAonuuMR4cjuFerQ4fvYjadX+RfqrVT3ju5f3MvEvoef/AZj5OLxEkVMy2972M0m+ZF/R/nodgf02X0DI5aBJcyLhkyEOQs6TM/sgcVOb4kbvZyXkIImauCLmeg75WrLWpnhbDe7ac1eYKskvZtQV88hB0rxXolHQF+Xqo8rwb5iHQXcg1f7qCRrKFSxmbPARj/G/5Db2KGqzO9a/z+AWCDeXt3Q5cRVv33B+768gLBCM7yzSVrqFjdZYHbkp9gaBSfljdsdfQYJuK72zHv0Dgtv2rz41ryLHczXvnBv1Mn9vsibHFdRSy14cB2XOkGNZpUSg7RbF0d28RuD1H/Ajo/sowXzHueqIT9H2O9q29OXN97ALF1vA+thDxHPWqMzDk1TelYpvzox/mhc/R9zJDe9WbMkmvP+lvC1nPEXP3fvcxR+foPxwdXgNynqOyS7zTq6HpCo8Pktdm03M0oMnjKmLdFL1u+cwyIHuB+o+3jxxtnqhweRn4zdzsBao963DdxzBPEVx26iOzzwt0lXmrXsSq9Qlpgc4Q8QJp0wZejPwWqG99ZsoX88IXaLq4aMXRI1MVz49xP8zbXyBVwIUGFadE6OEsemO+/AJVmzvRTqPT6WOq1H1pNr1A2z6nh9XPnq/IW50mBlkeatnrWb+rsfGKhY2XVAS3PDT1vdvelz/m6NOiWtpA3zykb60KMRjiFafiO3EQkYeiJ5Z9rzLM1YvHF702L8xDg893XKWGeP0jsV4OWXnIoWduu0cwWT+nquMz8+U8JMkwe0XCbH3nBYu+mU15qF3EhJyJU6crTvt9qQGyl0i0+1HMIo94xYGJXuXA7SWKYZN69tHFKsJtjc/NPi9R01HmOwVTFuqvuCgemsNfooPt6i7bNC1C7zSna6F54Utk2hCwqKpult6jadID8/aXqO2S3+fkes7Sj/7q/cZ8GdNv6lG7S0jRL+0tBwUvkcOw2fU2oTl6m6yuZUH2Cg26OyS5u1mr+PLhkC24vUKVwhrN2XxknmJ89eUy6PsKuY0f9+Dcj9mK7k2LqkPEK3Rv8+2OMfxCff+WQ6tBwivkEnMsjjUs0Pf08GkIWa+QHzIrxN+D9FdqbLtlvvwK7Y5IcHnhMU0/TtzPaDa9Qqsflsn1sAlWDHNS3TM7v0YHHGq2O2Pzu2LwuU0/zM1eo+qKWtoazHj9/YNL75h9XqOMhjPHyMzj9WmqFbUh4jXy8JmZ09U8R+H526zP5oWv0efjx5aN/TFJ4XNefNW8/TU60eidsZ7ZX991OH/VfPk1cn3VwbjPHKp/ZO//yWx6jYZLmy4X8VP1A2L2/Gl2zkeVg/clBhydq3gy+Mtbc7N89OaU23zTjwB97aeG+2affBTdLV8/BsXpPx4Y+MYcno/ycwcUrJ4Sp7ixMPm1eWE+erv483yb6VGKFNc6rpCVj8RlKgUs+D5Gn+aV+MB8OR9pXp2udmTKAkXMie+vzKZ89GN2xtb2RxYoGn1K+Q1kb1Dk7wc2LJocraj+0dkJ3N6gu6cjghKOxitOOI9/ZfZ5gxx/DDnZtswQ/bNZ95tCxBvUxflo75u6WP2mafddIeENGj78e+LCSVr9dDbktnn7GzRF6Xqyeuw8RftuoQ0g5w0asMO8cwUzW1GU0OWZ2fQGxV/of+oqqBWJHzZfNDsb0dWgJpzn9Fj9gzP975mbGVGAXdVzR2GiwvRbp3dmHyPqtzkxa4NZoyj7x5w8c7gRDT1i2hH1YbDeybyiLCQYEXNG+sd8XZy+S8W1j8zbjWgP1/mGDYxTrIx1qQI5RrR4+KCRn9i++hP6g7ZQYERln7ce0cVzhp6dP6HI7GxCkkWm9s2/+uhPz3lWA9xMyLds1LstU+coEltNKzL7mFDn07eu82iOIqTXxm/mcBOKHpdUrZAdpedPfP7TvNCEer4YW3hl8ljFlCe5V83bTaj56kkplZlw/YqnY6tBjgnt2HKpp3FqpKL58dyPZpMJ/T4rgmkrUevVI1WFZucCdNehmvfWKXP0QybMfG9uVoByd347HhS7XF/R6dt3s08BGpZ4vtUPw3LFtN4XRRBRgM4Pepo9HaYp8s6/+2xeWICqRLc98sgcplfddWQgqwC9rvt8WyxapG93bQ0DOQXoY0b38V8m6xTfv9/9YjYVoOyQmxES8Vj9su8HpSB7i0ZJw+Ku6xYoRhQ++2Ju9haZ2nwP+GJIV9xJueEEfd+ibX1dIsZCiiLF19UZIt4i48Mnjz9/n6+oO7DeN/PCtyhK0+G+GyxSDFV0dIGst2g2I9KNj01W7FvR4JP58lsUOC9jc4vPKj1cn1NoNr1Fr4etTzfELlGsmTnXEWTvkHzY90UhugyFqPMMEbi9Qy0NGa+PmZco4j7ozWafd0jTtOmUF0yM4o5rgyJz+DukdIyNOfQtVqFwX1IeEt6hRjyrOMdq9OX8fctD1jvE1nzXcppusb5D/x+vzZffoXf3fdpNMc/WL9u6XwoF79BJ3q1vP/MM/fbHE76and+j9Pp/zI6EqfpYvy0/zM3eowr79qER5kX6QYHrHKHve3R42lz5tNilCtePX8tCxHt04YbTiYOgUxxoNvSzeeF71G/9zibpKFHf6eoDMWS9R3+2i4kIiZ2hGHx2Z5H58nvU3MUgc2cnKCrtznplNr1HWf13jA6LTVIUbm9RAWSFqPaMyn5tPwUqGsztVhHcClHnfvc1z5npCv/dS1+YfQrR7/E79weZ4xW50eI8c3ghGvjuWOqO7KX6F0fDTeaFhUjT0P2dvWeqQrz+yDPz9kLUdbKTYZ85Uf+wnqwi5BSijsH3IwOyk/WPPQqcoaAQVRswQxofu1xxped9F5AVoTZrRkeqxCMVE+pJfgO3ImTfotalS4Zl+l4R9/LNPkXo1kqJRMPG6zcO9DOZw4uQS8DZMs8NqQoX2fOKkFCEEkzbp56cMlux2OOsCLKKULajwcGOz9DrK3tXh5wi1KBbna8Npybp4yfsf2E2FSFx0BvdvimJ+l/vIyz3DCPJPcMzg40gBNfHd2hycvJLNGFNA/L9ZdfuqcO83xmOo7pzG1mE7DI/IODjC0Fa8cyBd9Ma3zToBrWtX3v3FwWB6jB0I4baDTEcvnLDwH3MvW23ttphAh2JoWcxdEjXimNjbhjC+u69sWZULQr1xNCXGPqpyaytVW4YbgRmrXga91xPJStJvUU/oePGLvU7ct2Q69FgSVBVMc0LpF4MHVnt2FzldcOFuF7dm90uR/uaW4TrxdANM2e6ia8b3KXT3rzvdJ+2ORtDX2Jo9yDfXuuuGUYm9pt5agdH82ZiaPwHkFbUJaU86HbNsFh38nrvoXUoFN868BsxlPvz4OO8q4bbjfYl15hYl0JHknoxdPbD/6+9q4+Lqkr/3wsIwkUERRA1xXxNM+edmbK9TKalArrC5msOOAww8Sovgq5blKWSmlitaZliWom90fZimjij+AKYCr7lphW6uolrRa6t9mLsfe49wwzDjLrr57O/f353Rudyv+ec7/Oc55znPOfcOXe6Ty87YhOqDn8cXt/DBW32hsZKvFdJ38O/GO86Ypv7ReLQgdMjZH2jJV5CV1t3ra5ttPklfZOx471+rDYkXkI3v/XWzPRGW8vmp9T7+vVjtXGFeAl9+N2flnZqtKVN73R9z+bBcl47oWXXwEeWF5wduLHBFuJ75fHvMoNltILQSkIbPnxxUGyD7YkRV9Z9omvZ4UTrvKGlEi+hsbOye247bFs8as1bw6Z0YbUh8f5EFjx94J2WQ7aB7y1au3XwcFYbEi+hLcNyAoYcsoW2CkkTR0ay2pB4CbVPzOw/86Ctd0b9pyu392ctXeIltOLl/VdXfGbTPL0+Y+K8IS5o2c9e0KZ/Ei+h5SMKF+0+YFuxdamyKiFKRu2E1hFqL02o+2e9La38oGBO2C63qwpCmwmtOttvx4B628VdY0+nLhtU7UTLfvGClkq8hE66snb65Drb347t8vtr4zDWjyReQhuiLRVP1NoCfz71hK3aUVcSL6FNoT5lb+23TR2fmF9+yhUt+9ULGi3xEtoQ9U3XE/tsaWf/svGxc6GsXUm8hJa/mado3WszTApdP3pdXxe02RvadJl4r5O+G/52fvBe24oZAeVLv4pmrY7QSkJLD2QNj99jG1WiTdkVHHm/E63zhlYQ2kxoed/oX+fU2O5NGhK/qOQH5pEk3t+o5fS7NvnPu22d98yJVCwfyGpS4iU0eeTxYVt32VZtDOu5qfQeF7TOGxor8RJa3rDg8c/ttiszLixZZQ2634mWtXpBoyVeQptOKVdestkuqzfOTCpi1geh9a3gI4bnBAzZaRuFlmF3a4bd7wQvegGbfiDWUo6PtM9YkTRrh81/p2nqlOA7WC0TWklo0/h7s5/fbqvdMuOC1sB8mYTWeUMrCG0mtEJ5YkzNJ7aMR0bG37Wguwta9qQXtFTiJTT5/LNHWj62fVGgrot5iXmcZImX0Gh/IaD3R7Yps/alzPBh3kpCm72hsRLvUyRz71WfGz+wfd39p8++mHW3C1rpDY2WeAkt3fidzvK+LXDjirmzFoSzapZ4JTTMrgh6z7byOd3CddNGuKBlC72gTfQN90oJjZrz5QNv2eLyTpyf/1QfF7TOG0rrbMZmQu2qf00tfNP23YbLmrG/3l3tRMue9oJWSLwS+tu2xes22rb8NvjHrT4/jnKidd7QUkIvPs3xESUhrzy13nYu8PEFg0vvqnaCzz7jGUyWWJ8hfY4H9N72ks3wxs8vJC0fynoJofWU9deqzfYVtrVvHP3Xgr5f73CCF72A0RLpIo6PCM0c1vSE7VzsF12Es1HVTnCLF1DaYfDVIo73oZPrizje1/49FbaY4yPKinqElgoXhr+6JnM/82ulBFYuJg1emPpIdLlw5OpZ/xmnHXEJofWUtW7ooHGrBU3wdNX2CuaKQWAzZY39puxRY4WQ+PkPM+1hHDPmd8S6hOMj7jn2btomYej16qKCCGatUgIrl5A91odveXGz8KfB0xv+PI/pEEtonYR+ebDgwNtCwNCTD13O6MXUJ7RZQv3tyovvCn+8r27i78JCmK/9llpJGfW3sY33vfS+8Mq6Lo88qnKMPIRWEtrU+OaP1R8Inyecen1WLesVyYTWEVrxUvz05o+Evnc8OsrfymSOJbSZUPvFoKPYKqi+fbVyed9LchuCxPssVca0R2eptwlfPFR978ywAawyLhEvocnvLK997FPhfMbV4aXl3ZlUhNZJeXdwU5fsEI6+PX1f41hHJEVoM6HRQQsN+3cKTWP+/l6GfQSTitCypaTRKcPKCzbhetCGiSc0Dm8q8UrokKeei9wlXA4YcajkexYdNP2DeAltGfD48C27BM0a/YPPvclqo4LQZkJLFwWnNO4WNnz45IGsV32ZXyO0bBnHR5b3qPrVUiOU5U8YsHnkPrk2YgmtJLRKvfD+lXuEko+vJ81byPxptMQroRvOnR+yV9j/J+v5C2qmb9NF4iU0dNnOhCn7hJJ7Rt299LAj7iC0bLkoc17R0m4t+4Qz/deeXx7msC+hlYROevCZ5WX7hU6jV+aFpjlicELrl3N8hOEf7+2sFRrvbt6SdH8Aq0gCLxJ49fT06XVCbmvF1KGXA5jPk1ifo3p8dtS3L9QL1v6PTBqdz/p5UzOxEtowY8pJ5QFhy5m3E5ZrWdxoJ7ROynuffnHDAeHjbknT9kxg9qsgtJnQ0JZ9v+R+JhwZvmpv/qUfZD+QTGjZCqrlY1X3v39Q0Fb1uDqslXXAWImX0NBvWkMSDwmKK8bkId12yzaIJrR+BcdHfHnunR8PCWHPfWrp0b9eLhgSLWWt+iCrz5rDguLr4PpLB3qzSr5AtOUcHzk1Plk/p0FYmfBtxKm115gzJbSS0OSU9BF7GoTmi6MilvZkYWMpoXWEXqAm1yj0aXndHNKfdaJkQpsJvfb2gZmZjcKTEa9fPfiyI0CTeFeKeTOmm9fYGoWt1Q/9/ts3HIOWxEvoJyHZY8KPCBe3j93+1WIWVjR9Q7yElp9e0LLziHDFb9L4n9ey4MBOaDOhyUfP/BB+VPhkVP+j888yA1YQWvY8VeTOuemZR4Xa4h+qDuaEMY0IrSRUoS6evPuoMLPa/+Ok+3qy7inxEnrh+IAPo44JrzaVX9Kd68w0kngJrZ2ze/mcY0LRifTAQ0NGMlcm8b5AJUeua6o7Jmw6GdS7LJoFWZB4Ca3QB7x753Fh2v7UJ/N2sklsE+2bqyO0oTbx6h+PC9/HPvrdt++w4MBOaPMLHF/ZKXna19XHjwunLZs6D+ODpKLDJwBBAHgAwQC6AAgB0JU2mAEIA9ANQHdKC6AHgAgAkWzvEB1xE4CeAKJoE1hrayv9o2u9APQG8OB4YOp4Oe3mCUAf+i6iC19fAP3c+KIZX3/GdyftUUosVJtMKoO8Hd2aWzDOnJBoUirNGSn5JtpqW1gwzjyGdiPJ+5A2jweWxbXlU2rb9rFbUrJnF6XdILu0n6lpvDOvmpHKmb3n/LAE6DNB1pW+8XBsPOB7pbW1owzWnHSvMiQkmgxt+93b6ZQ6QbYZG2owMw4YAGAg7ZNrbW2lf3RtEIDBZP0JwLUJQHAccMwln6vNHPlcbeaQ1+DU25qTfiPtvcscHifz0UH2GCK2g6FODr3jaRZjWL2XxMFYsYbjj/o1Fq7DlFerh5XmTe7a2vq7IdRSUwFc8AVChwAVizjEPtAVpatWA2d+7EQaacW4dA6AzNbW1kO/tLY+b2ttdWyobP1PD3A+vn6d/AM6B7ILQXxwl5CuoWHduof3iIjsGdWrd587+vaL7n/ngFvD/48PcD5+Ab7+nVh9+AC0W87uB9g7AXZ/wB4A2DsD9kDAHgTYecAeDNi7APYQwN4VsIcC9jDA3g2wdwfs4YC9B2CPAOyRgL0nYI8C7L0Ae2/A3gew3wHY+wL2fgBtdP2AA2p8gBpfoMYPqOkE1PgDNQFATWegJhCoCQJqeKAmGKjpAhwNAWq6AjVA8Kccgmt8EFzji+AaPwSfIn2+6ub3Z3c7NyTInsSx0dtYsY7jfc4lwGhfx/EPxY02jU6aNknq9HGjTQl/iB8zedxo6TxpXPwYsOujJ8bFGZPGSOfxExPGJBknT5POxyQmGh8akwhj+XqON0YhCFFR1KnA6pg2V0reVTqiEBYUFRXlGxQADoF8TyDQnyfcn/JQTuOZ9RzfP8SZIagLXe5CxgoMkQoMIRdtfKWC47lgGN+s4Pge5J4lH43AYClfML2NxylNKIxnKA25dL+uUppQeQMxvY0rNnA81w3GVzZwfF9yv5IPRmA3KU036U1eoVevXjAe2cDxIY6/mH7Gha9xPBcO44rXOL4HDQzS6IDAcClBOL2N1ZQmAsa61zj+LhpEpJEEgRFSmgjp7dyVb3xg9INjxpZOhrH0dY5v5Xzg/qKnZLMXbv7ikv3sN3p1Ptnx5ZbiuMtr76292uU/4fLad2svR176UY5KjvcpfwTGF9/h+J98ObnvwrHTtRPb6eq6o/e/HdUdo4JjJHCM1o5ROpqNyjQiO0Yex2jj8Ox3ARgGYDhAPyhHv3GKewCMJA8PQAlAJToBNW1HZz6btijE0J4E2lIO0C+U02P7pRGLIhna6kCL77R1wQjgAerTFF0AoG46FsBDAB4GMA4ABRw06MQBiKfRhnaa0+5yAL8HMBlAojhCJwH4A4BHAEyhEYv28gOYDmAGjbAAHhV9yywAJory/of8fwSwAMCfADwu+rUnYCz/iON9KmbCuGnb/7cEIAXAbABmFhlYAKSJAXO6GCVkiJMbqzhje4yiAXEGnCXOzbMB5ADIBZDHIoV8AAUACgEUAZgLoFiMZUsAzAMw/wYt4X/F76ElVOzi+F2c02mmzDanWtJk11kydfiIvEnWcTkJkkWAQXnS/85Hg0lPS2EGy2YGGcSUcJzPY5/TmOEcaUe4pB3Emvu97Dze5TyRNZJBTFmw84fbpTe27Ob4v/p2BNoXJN2lsLT3AXQkpTn7ovEW+iMdOyzOfmm8Sd+UotY0Zx81evETdFSlOVuJ0UtLKWQWL2KtBazFpLAWUuBy/WbG8VyhHettECvfYYzZLuepLucP34Ihp7mUeWuGNx7bx/GrAheYnd3E6Az/dTRlyLJo01LMlsK2aY4ZsM9lT3lh+Sws33/avRiP1lw4L88yrpgeZcEmNwrpkmPuIT3CwixP4T4ztwXIILnp8wr7pKM8VZYpn8l0o+7L2GLMuakW89zCcWazUmkyZc+WHhdlKnSRR8WStM2GJJlyUmWZ4lI7yrQk1SmTn0WWaT6TqaPLAErFaemTHmR6sKCDUBJn0004SxjnU4xzoSjH0+Iw9Iw4DC0Sh6HFlF4chso8cVo9cyZZvHO6l1HcsQipjNU3L8PR7kwma3aeo92dtsjpnTxZ9JQ3ms5KODU+T3gxw6Pb46zNmdvkik3z3q4c0+Gcouw8etYSyyaVW9i+XGeaYmea1SyNFHSnAc+Kw/5SZpdl4tC/XBz6n2N206QBK6gdM3ylGAY8L4YBLzC8IV2264sMp1nVKjEseEkMC1aLYcEaeiiSGBa8IoYFa8Ww4FUxLFgnhgXrXWyUU5RtSrcUyqsFBmvbsovJWmjJlxcJPK+iOHuEwWRqK8Wln2jaLrv23VXpch2XpjuXX6rYOV0fld6x7j9Jh/HKYY6v5zZlyBpXMI03iIHNa2Jgs1EMbDaJrux1MbB5Qwxs3qRFLDGwqRQDmy1iYPOWB42LvWpc3EHjYq8aF7e1msIMzxopMjpqtCwDxtpGjv+KW2aVNXqbafSOGHq9Kw4g71EpYuj1vhh6/YVm4lSamxZ5RQ675d6G3aRSOtotr6id3SZbmX2sTi2zrE4tr3nQstAKY9VRjt/JJT0ma/kR0/JjMXjcSpYVg8dt4pC0XQweP6UhXwweqz1oWexVy1u1lVRKm60GPuZZiyZrRy1GPQbjtWMc/zKflAnsFMNaG9OCVkh2iZOM3ZBWO7BHDGr2ikHNPrbESun300ZscRCuE4ObejG4OSBONj4TB+KDLr6Eni55251QKkQ2GNmrS2Zb+SqFyeSgMNGqZm5+SrrD31HaoZmy9rWsVnxdtI/OlD/jMp1rybFZwCExGDvM6qFBDMgaxYDsiBhUHKXlVHGydFwMxE6weqD0n4v+76QYmPxVDMa+EIMxWgk6LQZhX3qqh9voml6UlUxPuvbIknVtyPSuqz7Lqeu5LOArMUD8muna5C7vbXZCpUPevKJChz32MhlLszq2xtMusqVmA2fEQPEsk+1vnmT7b7oO6w19sm/Mfy1b7tXnGP95cej9O90HocVfumdFN+LEuO8fdGOTbrm6LFkrsnNzLPPYEBo3W9GuSiSsfXx1MluWaYcHmVqynbFOVo4s03dMpu8Jpy9B0LdR6Is/NJbT187oi3hiDHjVu0xKkok4J+XcmLOJcV5jnD/RUwHF2O4XiovF2O66GNv9RguezOVwnGfOYlYPxLnnJpxJuTKnDydz0hqDHwd04gB/DgjggM4cEMgBQRzAe+ds01Ofe2POa4wzmHF24YAQZ7kG2Wy36cikUNFZkKPfnsiV7V/uScZcGNc2cfzL3No8WcKuTMJQDgjzKOFtuJj2ErZ5lvl5soSavI4SvpgHo/0MSRg7R5awG5OwOweEd5Dwdp1Km4SOwV2SsO8cWcKTHiTUz4Hx3FmS8ByTsAeTMIIDIj1KeBujcnsJ2+pwN5NwwRwPnmcOjEvOcfy2zjPzZQl7MgmjOKAXB/R2SqnPthQUpKRbCtqFNmrH1fa+xZDPooL8jqxJ+c72/yHj7cN47+CAvhzQzxNvsdOPrr1BuYlsPprD5twpLosG8WyO7AlLclmcKPCAT2FYKsvvLV0Sm6MXuSxxuacZyzCrByyR/V3oUoanNA4d3fVy18VddncZ3eVxlwFsESmFlV/EzvPd9LGwBZZ8L2niXa6ZGT+Yf89z4c9ySz/PRYYil7p3vZblks7IrqWzzwIXPRJZ3jx2zcLWTmazc9aspEUxM0uT6wFPYNfn3qCMB9nf5hukca1X93p0rzP3unKvE/f6cK8Ld/3d9XTXy10HR3nx7HySvIr52SWOnx93k7gcLAa8UcwqfWljLhDNAf054E6X8VVjMhVkpORbUk3m3KKcwjY/s2ku6KeO+VpOoVAoFSqFWqFRaBU6RYxCrzAoFUqlUqVUKzVKrVKnjFHqlQaVQqVUqVRqlUalVelUMSq9yqBWqJVqlVqt1qi1ap06Rq1XGzQKjVKj0qg1Go1Wo9PEaPQag1ahVWpVWrVWo9VqddoYrV5r0Cl0Sp1Kp9ZpdFqdThej0+sMMYoYZYwqRh2jidHG6GJiYvQxBr1Cr9Sr9Gq9Rq/V6/Qxer3eYFAYlAaVQW3QGLQGnSHGoDcYYNz0Pcdf9rvZLX/Uv3xfAoW65pKSlNnWuUqljurImm2S1vasOWm5bSsktcVA6HygffoYk8mcRU+yb5eB0l8rBi4VyxbpUwIM4ICBHDCIAwZzwBAOGMoBd3HAMPn5Fqhg6Ya7pbubA0ZwwD2cGz9NKwqsnkSQZCgpkbmllVBW9ki3shUcoOQAVYeylSbT3GyrN/2OuZQ9dZ5880jNARqmSyy7puUAHQckFhqcvxfCWp5innTd+fx4VvbD8+T8dCyZJ9+ciuEAvVSOUpmVm241s99GkfR0SW9n6Q3O9DprztyULGuqKSU/vUj6aR7Hl3zmyeVLtwdYvnud+VTyA9wZEcvTxPIkFhra6sShD+bDuPoKx/tOej703/C18tn/7AYA";async function Zt(c){let H=Uint8Array.from(atob(c),Y=>Y.charCodeAt(0)),n=new Blob([H]).stream().pipeThrough(new DecompressionStream("gzip"));return new Uint8Array(await new Response(n).arrayBuffer())}var E=20,Qe=200,B,K,I,V,z,dt;function Dt(){let c=B._live_values()/8;return B.HEAPF64.slice(c,c+K.length)}function Ut(c){B._live_start(c);let H=B.ccall("live_layout","string").trim().split(\`
\`).map(n=>n.split(" "));K={names:{},length:0};for(let[n,Y,X]of H)K.names[n]=[+Y,+X],K.length=+Y+ +X;I=z=0,dt=performance.now(),V=!1,postMessage({fields:K.names,seed:c}),postMessage({frames:[Dt()],ticks:I})}function Ae(){let c=performance.now();if(z=Math.min(z+c-dt,Qe),dt=c,V)return;let H=[];for(;z>=E;z-=E)B._live_step(E),I+=E,H.push(Dt());H.length>0&&postMessage({frames:H,ticks:I,busy:(performance.now()-c)/(H.length*E)})}onmessage=({data:c})=>{if(c.start!==void 0&&Ut(c.start),c.paused!==void 0&&(V=c.paused,z=0,V&&postMessage({paused:V})),c.command){let H=B.ccall("live_command","number",["string"],[c.command])!==0;postMessage({command:c.command,accepted:H,at:I})}};Zt(kt).then(c=>St({wasmBinary:c})).then(c=>{B=c,Ut(1),setInterval(Ae,E/2)});})();
`;var so={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},Ji=.2;function ro(i,t){let e=i===Ji?0:.02;return`attach ${i} ${e} ${e/2} ${(.1+.07*t).toFixed(2)}`}function Xl(i){let{act:t,view:e}=i,n=[...document.querySelectorAll("#controls button")],s=l=>t(ro(l,i.held().length)),r=0,a={attach:l=>s(+l.dataset.attach),cup:()=>s(Ji),hang:()=>t(`hang 1 ${.25}`),command:l=>t(l.dataset.command),pose:()=>t(`pose ${r=(r+1)%4}`),restart:()=>{r=0;for(let l of n)l.dataset.toggle&&l.setAttribute("aria-pressed",!1);i.restart()},toggle:l=>{let h=l.getAttribute("aria-pressed")!=="true";l.setAttribute("aria-pressed",h),t(`${l.dataset.toggle} ${h?1:0}`)}},o={pour:l=>{l&&!i.held().some(({kind:h})=>h==="cup")&&s(Ji),t(`pour ${l?.3:0}`)},push:l=>t(`push 0 ${l?15:0} 0`)};for(let l of n){if(fu(l),l.dataset.hold){pu(l,o[l.dataset.hold]);continue}let h=Object.keys(a).find(f=>f in l.dataset);l.addEventListener("click",()=>{a[h](l),l.dataset.say&&l.getAttribute("aria-pressed")!=="false"&&i.say(l.dataset.say)}),l.closest(".weights")&&mu(l,i.say)}if(gu(n),!e)return;let c=l=>t(`push ${l.toArray().map(h=>h.toFixed(3)).join(" ")}`);xu((l,h)=>c(e.inArms(l,h).setLength(l||h?15:0))),vu(e,(l,h)=>{c(e.inArms(l,h).multiplyScalar(100).clampLength(0,i.get("constrained")[0]?15:40))})}function fu(i){let t=i.dataset.key,e=i.lastChild,n=e.data.toLowerCase().indexOf(t),s=document.createElement("u"),r=document.createElement("span");i.setAttribute("aria-keyshortcuts",t),s.textContent=n<0?t.toUpperCase():e.data[n],r.append(...n<0?[e.data," ",s]:[e.data.slice(0,n),s,e.data.slice(n+1)]),e.replaceWith(r)}function pu(i,t){let e=n=>{i.classList.contains("held")!==n&&(i.classList.toggle("held",n),t(n))};for(let n of["pointerdown","hold"])i.addEventListener(n,()=>e(!0));for(let n of["pointerup","pointerleave","pointercancel","blur","keyup","release"])i.addEventListener(n,()=>e(!1));i.addEventListener("keydown",({key:n})=>{(n===" "||n==="Enter")&&e(!0)})}function mu(i,t){i.addEventListener("pointerdown",e=>{let n=document.createElement("div");n.className="dragged",n.append(i.querySelector("i").cloneNode());let s=({clientX:o,clientY:c})=>{!n.isConnected&&Math.hypot(o-e.clientX,c-e.clientY)<6||(document.body.append(n),n.style.left=`${o}px`,n.style.top=`${c}px`)},r=({type:o,clientX:c,clientY:l})=>{for(let[h,f]of a)removeEventListener(h,f);n.isConnected&&(n.remove(),o!=="pointercancel"&&(document.elementFromPoint(c,l)?.closest("#stage")?i.click():t("Let it go over one of the hands.")))},a=[["pointermove",s],["pointerup",r],["pointercancel",r]];for(let[o,c]of a)addEventListener(o,c)})}function gu(i){let t=new Map(i.map(e=>[e.dataset.key,e]));addEventListener("keydown",({altKey:e,ctrlKey:n,key:s,metaKey:r,repeat:a,target:o})=>{if(a||e||n||r||o.closest("input, select, pre"))return;let c=t.get(s.toLowerCase());c?.dataset.hold?c.dispatchEvent(new Event("hold")):c?.click()}),addEventListener("keyup",({key:e})=>t.get(e.toLowerCase())?.dispatchEvent(new Event("release")))}function xu(i){let t=document.getElementById("scene"),e=new Set,n=()=>i(...[...e].reduce(([s,r],a)=>[s+so[a][0],r+so[a][1]],[0,0]));t.addEventListener("keydown",s=>{s.key in so&&(s.preventDefault(),!s.repeat&&(e.add(s.key),n()))}),t.addEventListener("keyup",({key:s})=>e.delete(s)&&n()),t.addEventListener("blur",()=>{e.size!==0&&(e.clear(),n())})}function vu(i,t){let e=document.getElementById("scene");e.addEventListener("pointerdown",n=>{let{left:s,top:r}=e.getBoundingClientRect(),a=["without","with"].some(l=>{let{x:h,y:f}=i.handAt(l);return Math.hypot(n.clientX-s-h,n.clientY-r-f)<90}),o=n,c=l=>{a?t(l.clientX-n.clientX,l.clientY-n.clientY):i.turn(l.clientX-o.clientX,l.clientY-o.clientY),o=l};e.setPointerCapture(n.pointerId),e.addEventListener("pointermove",c),e.addEventListener("lostpointercapture",()=>{e.removeEventListener("pointermove",c),a&&t(0,0)},{once:!0})})}var Vs=class{constructor(){this.clear()}clear(){this.rows=[]}add(t){this.rows.push({t:t("ticks")[0]/1e3,mean:t("with.mean")[0],deviation:t("with.deviation")[0],truth:t("with.payload")[0]}),this.rows.length>12/.02&&this.rows.shift()}},yu=(()=>{let i=document.createElement("canvas");i.width=i.height=6;let t=i.getContext("2d");t.strokeStyle="#1565c0";for(let e of[-6,0,6])t.moveTo(e,6),t.lineTo(e+6,0);return t.stroke(),t.createPattern(i,"repeat")})();function ao(i,t,e,n){let s=devicePixelRatio,r=i.clientWidth,a=i.clientHeight;i.width!==Math.round(r*s)&&(i.width=Math.round(r*s),i.height=Math.round(a*s));let o=i.getContext("2d");o.setTransform(s,0,0,s,0,0),o.clearRect(0,0,r,a);let c=t.reduce((u,S)=>Math.max(u,S.mean+S.deviation,S.truth??0),.5),l=c>10?5:c>4?2:c>2?1:.5,h=l*Math.ceil(1.05*c/l),f=u=>30+(r-34)*(u-e)/(n-e),d=u=>a-16-(a-22)*Math.max(u,0)/h;o.font="11px system-ui, sans-serif",o.fillStyle="#5b6472",o.strokeStyle="#dde2e8";for(let u=0;u<=h+1e-9;u+=l)o.strokeRect(30,d(u),r-34,0),o.fillText(u.toFixed(l<1?1:0),4,d(u)+4);let m=Math.max(1,Math.round((n-e)/6));for(let u=m*Math.ceil(e/m);u<=n;u+=m)o.fillText(`${u} s`,Math.min(f(u)-8,r-26),a-3);let g=(u,S)=>{o.setLineDash(S),o.beginPath();for(let[A,T]of u)o.lineTo(f(A),d(T))},M=t.map(u=>[u.t,u.mean+2*u.deviation]),p=t.map(u=>[u.t,u.mean-2*u.deviation]);o.save(),o.beginPath(),o.rect(30,0,r-34,a-16),o.clip(),g([...M,...p.reverse()],[]),o.fillStyle=yu,o.fill(),o.strokeStyle="#1f2937",g(t.filter(u=>u.truth!==void 0).map(u=>[u.t,u.truth]),[5,4]),o.stroke(),o.lineWidth=2,o.strokeStyle="#1565c0",g(t.map(u=>[u.t,u.mean]),[]),o.stroke(),o.restore(),o.setLineDash([])}function Yl(i,{rows:t}){let e=Math.max(12,t[t.length-1].t);ao(i,t,e-12,e)}var oe=i=>document.getElementById(i),kn=[],ql,Mu=0;function Su(){return ql??=new Promise((i,t)=>{let e=document.createElement("script");e.src="logs.js",e.onload=()=>i(new Worker(URL.createObjectURL(new Blob([globalThis.rmeLogWorker],{type:"text/javascript"})))),e.onerror=()=>t(new Error("logs.js is missing beside the page")),document.head.append(e)}),ql}async function Jl(i,t){let e=await Su(),n=++Mu;return new Promise(s=>{let r=({data:a})=>{a.id===n&&(e.removeEventListener("message",r),s(a))};e.addEventListener("message",r),e.postMessage({id:n,files:kn,program:i,options:t})})}async function bu(i){let t=i.name.endsWith(".gz"),e=t?i.stream().pipeThrough(new DecompressionStream("gzip")):i.stream();return{name:t?i.name.slice(0,-3):i.name,bytes:new Uint8Array(await new Response(e).arrayBuffer())}}var si=({name:i})=>/\.(urdf|xml)$/i.test(i),Ws=()=>kn.filter(i=>!si(i)).map(({name:i})=>i);function Tu(i){let t=new DOMParser().parseFromString(new TextDecoder().decode(i.bytes),"text/xml"),e=[...t.querySelectorAll("robot > link")].map(h=>h.getAttribute("name")),n=h=>new Set([...t.querySelectorAll(`robot > joint > ${h}`)].map(f=>f.getAttribute("link"))),s=n("parent"),r=n("child"),a=[...t.querySelectorAll("robot > joint")].find(h=>/revolute|continuous/.test(h.getAttribute("type"))),o=e.filter(h=>!s.has(h)),c=a?.querySelector("parent")?.getAttribute("link")??e.find(h=>!r.has(h)),l=o.find(h=>/^(tool0|.*flange|.*link8|.*ee|.*tip)$/i.test(h))??o.at(-1);for(let[h,f]of[["base",c],["tip",l]])oe(h).replaceChildren(...e.map(d=>new Option(d,d,!1,d===f)))}async function Zl(i){for(let e of i){let n=await bu(e);kn=kn.filter(s=>s.name!==n.name&&!(si(s)&&si(n))),kn.push(n)}let t=kn.find(si);oe("chosen").textContent=kn.map(({name:e})=>e).join(", "),oe("arm").hidden=!t,t&&[...i].some(si)&&Tu(t),oe("replay").disabled=oe("check").disabled=Ws().length===0,Ws().length>0&&[...i].some(e=>!si(e))&&await Ql()}function Kl(){let i=kn.find(si),t=oe("options").value.trim();return[...i?["--urdf",i.name,"--base",oe("base").value,"--tip",oe("tip").value]:[],...t?t.split(/\s+/):[]]}function oo(i,t){oe("verdict").textContent=i,oe("output").hidden=!1,oe("output").textContent=t.join(`
`)}async function jl(i,t){oe("verdict").textContent=i;for(let e of["replay","check"])oe(e).disabled=!0;await t();for(let e of["replay","check"])oe(e).disabled=!1}var Ql=()=>jl("replaying ...",async()=>{let i=Ws().at(-1),{code:t,output:e}=await Jl("replay_log",[i,"--json",...Kl()]);if(t!==0){oe("replayed").hidden=!0,oo(`${i} could not be replayed`,e);return}let n=e.filter(o=>o.startsWith("{")).map(o=>JSON.parse(o)),s=n.filter(({type:o})=>o==="estimate"),r=n.filter(({type:o,final:c})=>c||o==="rejected"),a=n.find(({type:o})=>o==="summary");oe("replayed").hidden=!1,oe("replayed").rows=s.map(({t:o,mass:c,std:l,truth:h})=>({t:o,mean:c,deviation:l[0],truth:h?.[0]})),$l(),oo(`${i}: ${a.samples} samples, ${a.estimates} changes of the payload, ${a.rejected} pushes`,[...n.filter(({type:o})=>o==="note").map(({text:o})=>o),...r.map(({t:o,kind:c,mass:l,std:h})=>`${o.toFixed(3)} s  ${c}`+(l===void 0?"":`  ${l.toFixed(3)} +- ${h[0].toFixed(3)} kg`))])});function $l(){let{rows:i}=oe("replayed");i?.length>1&&ao(oe("replayed"),i,i[0].t,i.at(-1).t)}var wu=()=>jl("checking ...",async()=>{let{code:i,output:t}=await Jl("check_arm",[...Ws(),...Kl()]);oo(["The arm fits: sign, units and frames of its torque can be right.","Sign, units or frames of the torque do not fit the arm.","check_arm does not take these options.","check_arm cannot use these files."][i],t)});function tc(){oe("files").addEventListener("change",({target:t})=>Zl(t.files)),oe("replay").addEventListener("click",Ql),oe("check").addEventListener("click",wu),addEventListener("resize",$l);let i=t=>e=>{e.dataTransfer?.types.includes("Files")&&(e.preventDefault(),oe("own").classList.toggle("over",t),e.type==="drop"&&Zl(e.dataTransfer.files))};for(let[t,e]of[["dragover",!0],["dragleave",!1],["drop",!1]])addEventListener(t,i(e))}var Cc=0,zo=1,Pc=2;var As=1,_c=2,Hi=3,Qn=0,Ne=1,xn=2,ui=0,Gi=1,ko=2,Ho=3,Go=4,Ic=5;var di=100,Lc=101,Dc=102,Nc=103,Uc=104,Fc=200,Oc=201,Bc=202,zc=203,Vo=204,Wo=205,kc=206,Hc=207,Gc=208,Vc=209,Wc=210,Xc=211,Yc=212,qc=213,Zc=214,yr=0,Mr=1,Sr=2,Ii=3,br=4,Tr=5,wr=6,Er=7,Qr=0,Jc=1,Kc=2,vn=0,Xo=1,Yo=2,qo=3,Zo=4,Jo=5,Ko=6,jo=7;var Qo=300,fi=301,Vi=302,$r=303,ta=304,Ar=1e3,fn=1001,Rr=1002,Se=1003,jc=1004;var Rs=1005;var De=1006,ea=1007;var Nn=1008;var Be=1009,$o=1010,tl=1011,Wi=1012,na=1013,an=1014,on=1015,ln=1016,ia=1017,sa=1018,pi=1020,el=35902,nl=35899,il=1021,sl=1022,cn=1023,Pn=1026,Un=1027,rl=1028,ra=1029,$n=1030,aa=1031;var oa=1033,Cs=33776,Ps=33777,_s=33778,Is=33779,la=35840,ca=35841,ha=35842,ua=35843,da=36196,fa=37492,pa=37496,ma=37488,ga=37489,Ls=37490,xa=37491,va=37808,ya=37809,Ma=37810,Sa=37811,ba=37812,Ta=37813,wa=37814,Ea=37815,Aa=37816,Ra=37817,Ca=37818,Pa=37819,_a=37820,Ia=37821,La=36492,Da=36494,Na=36495,Ua=36283,Fa=36284,Ds=36285,Oa=36286;var ns=2300,Cr=2301,gr=2302,Lo=2303,Do=2400,No=2401,Uo=2402;var Qc=3200;var Ba=0,$c=1,Fn="",He="srgb",is="srgb-linear",ss="linear",qt="srgb";var xr=7680;var th=519,eh=512,nh=513,ih=514,al=515,sh=516,rh=517,ol=518,ll=519,ah=35044;var cl="300 es",je=2e3,Li=2001;function Eu(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Au(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function rs(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function oh(){let i=rs("canvas");return i.style.display="block",i}var ec={},Di=null;function hl(...i){let t="THREE."+i.shift();Di?Di("log",t,...i):console.log(t,...i)}function lh(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Rt(...i){i=lh(i);let t="THREE."+i.shift();if(Di)Di("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Pt(...i){i=lh(i);let t="THREE."+i.shift();if(Di)Di("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function es(...i){let t=i.join(" ");t in ec||(ec[t]=!0,Rt(...i))}function ch(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var hh={[yr]:yr,[Sr]:wr,[br]:br,[Ii]:Tr,[Mr]:Mr,[wr]:Sr,[Er]:Er,[Tr]:Ii},mn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},Re=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var vr=Math.PI/180,Pr=180/Math.PI;function Ns(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Re[i&255]+Re[i>>8&255]+Re[i>>16&255]+Re[i>>24&255]+"-"+Re[t&255]+Re[t>>8&255]+"-"+Re[t>>16&15|64]+Re[t>>24&255]+"-"+Re[e&63|128]+Re[e>>8&255]+"-"+Re[e>>16&255]+Re[e>>24&255]+Re[n&255]+Re[n>>8&255]+Re[n>>16&255]+Re[n>>24&255]).toLowerCase()}function Wt(i,t,e){return Math.max(t,Math.min(e,i))}function Ru(i,t){return(i%t+t)%t}function lo(i,t,e){return(1-e)*i+e*t}function uh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ul(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Cu(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Pu(i,t){if(t.constructor===Float32Array)return i;let e=ul(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Vt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qe=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let c=n[s+0],l=n[s+1],h=n[s+2],f=n[s+3],d=r[a+0],m=r[a+1],g=r[a+2],M=r[a+3];if(f!==M||c!==d||l!==m||h!==g){let p=c*d+l*m+h*g+f*M;p<0&&(d=-d,m=-m,g=-g,M=-M,p=-p);let u=1-o;if(p<.9995){let S=Math.acos(p),A=Math.sin(S);u=Math.sin(u*S)/A,o=Math.sin(o*S)/A,c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+M*o}else{c=c*u+d*o,l=l*u+m*o,h=h*u+g*o,f=f*u+M*o;let S=1/Math.sqrt(c*c+l*l+h*h+f*f);c*=S,l*=S,h*=S,f*=S}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,s,r,a){let o=n[s],c=n[s+1],l=n[s+2],h=n[s+3],f=r[a],d=r[a+1],m=r[a+2],g=r[a+3];return t[e]=o*g+h*f+c*m-l*d,t[e+1]=c*g+h*d+l*f-o*m,t[e+2]=l*g+h*m+o*d-c*f,t[e+3]=h*g-o*f-c*d-l*m,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,c=Math.sin,l=o(n/2),h=o(s/2),f=o(r/2),d=c(n/2),m=c(s/2),g=c(r/2);switch(a){case"XYZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"YXZ":this._x=d*h*f+l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"ZXY":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f-d*m*g;break;case"ZYX":this._x=d*h*f-l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f+d*m*g;break;case"YZX":this._x=d*h*f+l*m*g,this._y=l*m*f+d*h*g,this._z=l*h*g-d*m*f,this._w=l*h*f-d*m*g;break;case"XZY":this._x=d*h*f-l*m*g,this._y=l*m*f-d*h*g,this._z=l*h*g+d*m*f,this._w=l*h*f+d*m*g;break;default:Rt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],c=e[9],l=e[2],h=e[6],f=e[10],d=n+o+f;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-c)*m,this._y=(r-l)*m,this._z=(a-s)*m}else if(n>o&&n>f){let m=2*Math.sqrt(1+n-o-f);this._w=(h-c)/m,this._x=.25*m,this._y=(s+a)/m,this._z=(r+l)/m}else if(o>f){let m=2*Math.sqrt(1+o-n-f);this._w=(r-l)/m,this._x=(s+a)/m,this._y=.25*m,this._z=(c+h)/m}else{let m=2*Math.sqrt(1+f-n-o);this._w=(a-s)/m,this._x=(r+l)/m,this._y=(c+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+a*o+s*l-r*c,this._y=s*h+a*c+r*o-n*l,this._z=r*h+a*l+n*c-s*o,this._w=a*h-n*o-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let c=1-e;if(o<.9995){let l=Math.acos(o),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(nc.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(nc.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,c=t.w,l=2*(a*s-o*n),h=2*(o*e-r*s),f=2*(r*n-a*e);return this.x=e+c*l+a*f-o*h,this.y=n+c*h+o*l-r*f,this.z=s+c*f+r*h-a*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,c=e.z;return this.x=s*c-r*o,this.y=r*a-n*c,this.z=n*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return co.copy(this).projectOnVector(t),this.sub(co)}reflect(t){return this.sub(co.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},co=new U,nc=new Qe,_t=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l)}set(t,e,n,s,r,a,o,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=a,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],c=n[6],l=n[1],h=n[4],f=n[7],d=n[2],m=n[5],g=n[8],M=s[0],p=s[3],u=s[6],S=s[1],A=s[4],T=s[7],R=s[2],E=s[5],x=s[8];return r[0]=a*M+o*S+c*R,r[3]=a*p+o*A+c*E,r[6]=a*u+o*T+c*x,r[1]=l*M+h*S+f*R,r[4]=l*p+h*A+f*E,r[7]=l*u+h*T+f*x,r[2]=d*M+m*S+g*R,r[5]=d*p+m*A+g*E,r[8]=d*u+m*T+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8];return e*a*h-e*o*l-n*r*h+n*o*c+s*r*l-s*a*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=h*a-o*l,d=o*c-h*r,m=l*r-a*c,g=e*f+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return t[0]=f*M,t[1]=(s*l-h*n)*M,t[2]=(o*n-s*a)*M,t[3]=d*M,t[4]=(h*e-s*c)*M,t[5]=(s*r-o*e)*M,t[6]=m*M,t[7]=(n*c-l*e)*M,t[8]=(a*e-n*r)*M,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*a+l*o)+a+t,-s*l,s*c,-s*(-l*a+c*o)+o+e,0,0,1),this}scale(t,e){return es("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ho.makeScale(t,e)),this}rotate(t){return es("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ho.makeRotation(-t)),this}translate(t,e){return es("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ho.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ho=new _t,ic=new _t().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sc=new _t().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _u(){let i={enabled:!0,workingColorSpace:is,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===qt&&(s.r=Cn(s.r),s.g=Cn(s.g),s.b=Cn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===qt&&(s.r=_i(s.r),s.g=_i(s.g),s.b=_i(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fn?ss:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[is]:{primaries:t,whitePoint:n,transfer:ss,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:He},outputColorSpaceConfig:{drawingBufferColorSpace:He}},[He]:{primaries:t,whitePoint:n,transfer:qt,toXYZ:ic,fromXYZ:sc,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:He}}}),i}var Gt=_u();function Cn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function _i(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var xi,_r=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{xi===void 0&&(xi=rs("canvas")),xi.width=t.width,xi.height=t.height;let s=xi.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=xi}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=rs("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Cn(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Cn(e[n]/255)*255):e[n]=Cn(e[n]);return{data:e,width:t.width,height:t.height}}else return Rt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Iu=0,Ni=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Iu++}),this.uuid=Ns(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(uo(s[a].image)):r.push(uo(s[a]))}else r=uo(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function uo(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?_r.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Rt("Texture: Unable to serialize Texture."),{})}var Lu=0,fo=new U,Oe=class i extends mn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=fn,s=fn,r=De,a=Nn,o=cn,c=Be,l=i.DEFAULT_ANISOTROPY,h=Fn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Lu++}),this.uuid=Ns(),this.name="",this.source=new Ni(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new Vt(0,0),this.repeat=new Vt(1,1),this.center=new Vt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new _t,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fo).x}get height(){return this.source.getSize(fo).y}get depth(){return this.source.getSize(fo).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Rt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Rt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Qo)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ar:t.x=t.x-Math.floor(t.x);break;case fn:t.x=t.x<0?0:1;break;case Rr:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ar:t.y=t.y-Math.floor(t.y);break;case fn:t.y=t.y<0?0:1;break;case Rr:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Oe.DEFAULT_IMAGE=null;Oe.DEFAULT_MAPPING=Qo;Oe.DEFAULT_ANISOTROPY=1;var se=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],f=c[8],d=c[1],m=c[5],g=c[9],M=c[2],p=c[6],u=c[10];if(Math.abs(h-d)<.01&&Math.abs(f-M)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(f+M)<.1&&Math.abs(g+p)<.1&&Math.abs(l+m+u-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(l+1)/2,T=(m+1)/2,R=(u+1)/2,E=(h+d)/4,x=(f+M)/4,b=(g+p)/4;return A>T&&A>R?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):T>R?T<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(T),n=E/s,r=b/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=x/r,s=b/r),this.set(n,s,r,e),this}let S=Math.sqrt((p-g)*(p-g)+(f-M)*(f-M)+(d-h)*(d-h));return Math.abs(S)<.001&&(S=1),this.x=(p-g)/S,this.y=(f-M)/S,this.z=(d-h)/S,this.w=Math.acos((l+m+u-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ir=class extends mn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:De,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new se(0,0,t,e),this.scissorTest=!1,this.viewport=new se(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Oe({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:De,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ni(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ve=class extends Ir{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},as=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Se,this.minFilter=Se,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Lr=class extends Oe{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Se,this.minFilter=Se,this.wrapR=fn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,c,l,h,f,d,m,g,M,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,M,p)}set(t,e,n,s,r,a,o,c,l,h,f,d,m,g,M,p){let u=this.elements;return u[0]=t,u[4]=e,u[8]=n,u[12]=s,u[1]=r,u[5]=a,u[9]=o,u[13]=c,u[2]=l,u[6]=h,u[10]=f,u[14]=d,u[3]=m,u[7]=g,u[11]=M,u[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/vi.setFromMatrixColumn(t,0).length(),r=1/vi.setFromMatrixColumn(t,1).length(),a=1/vi.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let d=a*h,m=a*f,g=o*h,M=o*f;e[0]=c*h,e[4]=-c*f,e[8]=l,e[1]=m+g*l,e[5]=d-M*l,e[9]=-o*c,e[2]=M-d*l,e[6]=g+m*l,e[10]=a*c}else if(t.order==="YXZ"){let d=c*h,m=c*f,g=l*h,M=l*f;e[0]=d+M*o,e[4]=g*o-m,e[8]=a*l,e[1]=a*f,e[5]=a*h,e[9]=-o,e[2]=m*o-g,e[6]=M+d*o,e[10]=a*c}else if(t.order==="ZXY"){let d=c*h,m=c*f,g=l*h,M=l*f;e[0]=d-M*o,e[4]=-a*f,e[8]=g+m*o,e[1]=m+g*o,e[5]=a*h,e[9]=M-d*o,e[2]=-a*l,e[6]=o,e[10]=a*c}else if(t.order==="ZYX"){let d=a*h,m=a*f,g=o*h,M=o*f;e[0]=c*h,e[4]=g*l-m,e[8]=d*l+M,e[1]=c*f,e[5]=M*l+d,e[9]=m*l-g,e[2]=-l,e[6]=o*c,e[10]=a*c}else if(t.order==="YZX"){let d=a*c,m=a*l,g=o*c,M=o*l;e[0]=c*h,e[4]=M-d*f,e[8]=g*f+m,e[1]=f,e[5]=a*h,e[9]=-o*h,e[2]=-l*h,e[6]=m*f+g,e[10]=d-M*f}else if(t.order==="XZY"){let d=a*c,m=a*l,g=o*c,M=o*l;e[0]=c*h,e[4]=-f,e[8]=l*h,e[1]=d*f+M,e[5]=a*h,e[9]=m*f-g,e[2]=g*f-m,e[6]=o*h,e[10]=M*f+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Du,t,Nu)}lookAt(t,e,n){let s=this.elements;return ze.subVectors(t,e),ze.lengthSq()===0&&(ze.z=1),ze.normalize(),Hn.crossVectors(n,ze),Hn.lengthSq()===0&&(Math.abs(n.z)===1?ze.x+=1e-4:ze.z+=1e-4,ze.normalize(),Hn.crossVectors(n,ze)),Hn.normalize(),Xs.crossVectors(ze,Hn),s[0]=Hn.x,s[4]=Xs.x,s[8]=ze.x,s[1]=Hn.y,s[5]=Xs.y,s[9]=ze.y,s[2]=Hn.z,s[6]=Xs.z,s[10]=ze.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],c=n[8],l=n[12],h=n[1],f=n[5],d=n[9],m=n[13],g=n[2],M=n[6],p=n[10],u=n[14],S=n[3],A=n[7],T=n[11],R=n[15],E=s[0],x=s[4],b=s[8],N=s[12],I=s[1],D=s[5],B=s[9],V=s[13],P=s[2],G=s[6],Y=s[10],H=s[14],et=s[3],X=s[7],Q=s[11],$=s[15];return r[0]=a*E+o*I+c*P+l*et,r[4]=a*x+o*D+c*G+l*X,r[8]=a*b+o*B+c*Y+l*Q,r[12]=a*N+o*V+c*H+l*$,r[1]=h*E+f*I+d*P+m*et,r[5]=h*x+f*D+d*G+m*X,r[9]=h*b+f*B+d*Y+m*Q,r[13]=h*N+f*V+d*H+m*$,r[2]=g*E+M*I+p*P+u*et,r[6]=g*x+M*D+p*G+u*X,r[10]=g*b+M*B+p*Y+u*Q,r[14]=g*N+M*V+p*H+u*$,r[3]=S*E+A*I+T*P+R*et,r[7]=S*x+A*D+T*G+R*X,r[11]=S*b+A*B+T*Y+R*Q,r[15]=S*N+A*V+T*H+R*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],c=t[9],l=t[13],h=t[2],f=t[6],d=t[10],m=t[14],g=t[3],M=t[7],p=t[11],u=t[15],S=c*m-l*d,A=o*m-l*f,T=o*d-c*f,R=a*m-l*h,E=a*d-c*h,x=a*f-o*h;return e*(M*S-p*A+u*T)-n*(g*S-p*R+u*E)+s*(g*A-M*R+u*x)-r*(g*T-M*E+p*x)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],c=t[2],l=t[6],h=t[10];return e*(a*h-o*l)-n*(r*h-o*c)+s*(r*l-a*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],c=t[6],l=t[7],h=t[8],f=t[9],d=t[10],m=t[11],g=t[12],M=t[13],p=t[14],u=t[15],S=e*o-n*a,A=e*c-s*a,T=e*l-r*a,R=n*c-s*o,E=n*l-r*o,x=s*l-r*c,b=h*M-f*g,N=h*p-d*g,I=h*u-m*g,D=f*p-d*M,B=f*u-m*M,V=d*u-m*p,P=S*V-A*B+T*D+R*I-E*N+x*b;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/P;return t[0]=(o*V-c*B+l*D)*G,t[1]=(s*B-n*V-r*D)*G,t[2]=(M*x-p*E+u*R)*G,t[3]=(d*E-f*x-m*R)*G,t[4]=(c*I-a*V-l*N)*G,t[5]=(e*V-s*I+r*N)*G,t[6]=(p*T-g*x-u*A)*G,t[7]=(h*x-d*T+m*A)*G,t[8]=(a*B-o*I+l*b)*G,t[9]=(n*I-e*B-r*b)*G,t[10]=(g*E-M*T+u*S)*G,t[11]=(f*T-h*E-m*S)*G,t[12]=(o*N-a*D-c*b)*G,t[13]=(e*D-n*N+s*b)*G,t[14]=(M*A-g*R-p*S)*G,t[15]=(h*R-f*A+d*S)*G,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,c=t.z,l=r*a,h=r*o;return this.set(l*a+n,l*o-s*c,l*c+s*o,0,l*o+s*c,h*o+n,h*c-s*a,0,l*c-s*o,h*c+s*a,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,a=e._y,o=e._z,c=e._w,l=r+r,h=a+a,f=o+o,d=r*l,m=r*h,g=r*f,M=a*h,p=a*f,u=o*f,S=c*l,A=c*h,T=c*f,R=n.x,E=n.y,x=n.z;return s[0]=(1-(M+u))*R,s[1]=(m+T)*R,s[2]=(g-A)*R,s[3]=0,s[4]=(m-T)*E,s[5]=(1-(d+u))*E,s[6]=(p+S)*E,s[7]=0,s[8]=(g+A)*x,s[9]=(p-S)*x,s[10]=(1-(d+M))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=vi.set(s[0],s[1],s[2]).length(),o=vi.set(s[4],s[5],s[6]).length(),c=vi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),en.copy(this);let l=1/a,h=1/o,f=1/c;return en.elements[0]*=l,en.elements[1]*=l,en.elements[2]*=l,en.elements[4]*=h,en.elements[5]*=h,en.elements[6]*=h,en.elements[8]*=f,en.elements[9]*=f,en.elements[10]*=f,e.setFromRotationMatrix(en),n.x=a,n.y=o,n.z=c,this}makePerspective(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2*r/(e-t),f=2*r/(n-s),d=(e+t)/(e-t),m=(n+s)/(n-s),g,M;if(c)g=r/(a-r),M=a*r/(a-r);else if(o===je)g=-(a+r)/(a-r),M=-2*a*r/(a-r);else if(o===Li)g=-a/(a-r),M=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=f,l[9]=m,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=je,c=!1){let l=this.elements,h=2/(e-t),f=2/(n-s),d=-(e+t)/(e-t),m=-(n+s)/(n-s),g,M;if(c)g=1/(a-r),M=a/(a-r);else if(o===je)g=-2/(a-r),M=-(a+r)/(a-r);else if(o===Li)g=-1/(a-r),M=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=f,l[9]=0,l[13]=m,l[2]=0,l[6]=0,l[10]=g,l[14]=M,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},vi=new U,en=new Qt,Du=new U(0,0,0),Nu=new U(1,1,1),Hn=new U,Xs=new U,ze=new U,rc=new Qt,ac=new Qe,_n=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],c=s[1],l=s[5],h=s[9],f=s[2],d=s[6],m=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,m),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,m),this._z=Math.atan2(-a,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Wt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-a,l));break;case"YZX":this._z=Math.asin(Wt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,m));break;case"XZY":this._z=Math.asin(-Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Rt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return rc.makeRotationFromQuaternion(t),this.setFromRotationMatrix(rc,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ac.setFromEuler(this),this.setFromQuaternion(ac,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};_n.DEFAULT_ORDER="XYZ";var os=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Uu=0,oc=new U,yi=new Qe,bn=new Qt,Ys=new U,Ki=new U,Fu=new U,Ou=new Qe,lc=new U(1,0,0),cc=new U(0,1,0),hc=new U(0,0,1),uc={type:"added"},Bu={type:"removed"},Mi={type:"childadded",child:null},po={type:"childremoved",child:null},we=class i extends mn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Uu++}),this.uuid=Ns(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new U,e=new _n,n=new Qe,s=new U(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new _t}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new os,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.multiply(yi),this}rotateOnWorldAxis(t,e){return yi.setFromAxisAngle(t,e),this.quaternion.premultiply(yi),this}rotateX(t){return this.rotateOnAxis(lc,t)}rotateY(t){return this.rotateOnAxis(cc,t)}rotateZ(t){return this.rotateOnAxis(hc,t)}translateOnAxis(t,e){return oc.copy(t).applyQuaternion(this.quaternion),this.position.add(oc.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(lc,t)}translateY(t){return this.translateOnAxis(cc,t)}translateZ(t){return this.translateOnAxis(hc,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(bn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Ys.copy(t):Ys.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ki.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bn.lookAt(Ki,Ys,this.up):bn.lookAt(Ys,Ki,this.up),this.quaternion.setFromRotationMatrix(bn),s&&(bn.extractRotation(s.matrixWorld),yi.setFromRotationMatrix(bn),this.quaternion.premultiply(yi.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Pt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(uc),Mi.child=t,this.dispatchEvent(Mi),Mi.child=null):Pt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Bu),po.child=t,this.dispatchEvent(po),po.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),bn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),bn.multiply(t.parent.matrixWorld)),t.applyMatrix4(bn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(uc),Mi.child=t,this.dispatchEvent(Mi),Mi.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,t,Fu),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,Ou,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let c=o.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let f=c[l];r(t.shapes,f)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(r(t.materials,this.material[c]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let c=this.animations[o];s.animations.push(r(t.animations,c))}}if(e){let o=a(t.geometries),c=a(t.materials),l=a(t.textures),h=a(t.images),f=a(t.shapes),d=a(t.skeletons),m=a(t.animations),g=a(t.nodes);o.length>0&&(n.geometries=o),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let c=[];for(let l in o){let h=o[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};we.DEFAULT_UP=new U(0,1,0);we.DEFAULT_MATRIX_AUTO_UPDATE=!0;we.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ge=class extends we{constructor(){super(),this.isGroup=!0,this.type="Group"}},zu={type:"move"},Ui=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ge,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ge,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ge,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null,o=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){a=!0;for(let M of t.hand.values()){let p=e.getJointPose(M,n),u=this._getHandJoint(l,M);p!==null&&(u.matrix.fromArray(p.transform.matrix),u.matrix.decompose(u.position,u.quaternion,u.scale),u.matrixWorldNeedsUpdate=!0,u.jointRadius=p.radius),u.visible=p!==null}let h=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],d=h.position.distanceTo(f.position),m=.02,g=.005;l.inputState.pinching&&d>m+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=m-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(zu)))}return o!==null&&(o.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ge;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},dh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Gn={h:0,s:0,l:0},qs={h:0,s:0,l:0};function mo(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Ut=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=He){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Gt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Gt.workingColorSpace){return this.r=t,this.g=e,this.b=n,Gt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Gt.workingColorSpace){if(t=Ru(t,1),e=Wt(e,0,1),n=Wt(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=mo(a,r,t+1/3),this.g=mo(a,r,t),this.b=mo(a,r,t-1/3)}return Gt.colorSpaceToWorking(this,s),this}setStyle(t,e=He){function n(r){r!==void 0&&parseFloat(r)<1&&Rt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Rt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Rt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=He){let n=dh[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Rt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Cn(t.r),this.g=Cn(t.g),this.b=Cn(t.b),this}copyLinearToSRGB(t){return this.r=_i(t.r),this.g=_i(t.g),this.b=_i(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=He){return Gt.workingToColorSpace(Ce.copy(this),t),Math.round(Wt(Ce.r*255,0,255))*65536+Math.round(Wt(Ce.g*255,0,255))*256+Math.round(Wt(Ce.b*255,0,255))}getHexString(t=He){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Gt.workingColorSpace){Gt.workingToColorSpace(Ce.copy(this),e);let n=Ce.r,s=Ce.g,r=Ce.b,a=Math.max(n,s,r),o=Math.min(n,s,r),c,l,h=(o+a)/2;if(o===a)c=0,l=0;else{let f=a-o;switch(l=h<=.5?f/(a+o):f/(2-a-o),a){case n:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-n)/f+2;break;case r:c=(n-s)/f+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=Gt.workingColorSpace){return Gt.workingToColorSpace(Ce.copy(this),e),t.r=Ce.r,t.g=Ce.g,t.b=Ce.b,t}getStyle(t=He){Gt.workingToColorSpace(Ce.copy(this),t);let e=Ce.r,n=Ce.g,s=Ce.b;return t!==He?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Gn),this.setHSL(Gn.h+t,Gn.s+e,Gn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Gn),t.getHSL(qs);let n=lo(Gn.h,qs.h,e),s=lo(Gn.s,qs.s,e),r=lo(Gn.l,qs.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ce=new Ut;Ut.NAMES=dh;var ls=class extends we{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new _n,this.environmentIntensity=1,this.environmentRotation=new _n,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},nn=new U,Tn=new U,go=new U,wn=new U,Si=new U,bi=new U,dc=new U,xo=new U,vo=new U,yo=new U,Mo=new se,So=new se,bo=new se,Rn=class i{constructor(t=new U,e=new U,n=new U){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),nn.subVectors(t,e),s.cross(nn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){nn.subVectors(s,e),Tn.subVectors(n,e),go.subVectors(t,e);let a=nn.dot(nn),o=nn.dot(Tn),c=nn.dot(go),l=Tn.dot(Tn),h=Tn.dot(go),f=a*l-o*o;if(f===0)return r.set(0,0,0),null;let d=1/f,m=(l*c-o*h)*d,g=(a*h-o*c)*d;return r.set(1-m-g,g,m)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,wn)===null?!1:wn.x>=0&&wn.y>=0&&wn.x+wn.y<=1}static getInterpolation(t,e,n,s,r,a,o,c){return this.getBarycoord(t,e,n,s,wn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,wn.x),c.addScaledVector(a,wn.y),c.addScaledVector(o,wn.z),c)}static getInterpolatedAttribute(t,e,n,s,r,a){return Mo.setScalar(0),So.setScalar(0),bo.setScalar(0),Mo.fromBufferAttribute(t,e),So.fromBufferAttribute(t,n),bo.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(Mo,r.x),a.addScaledVector(So,r.y),a.addScaledVector(bo,r.z),a}static isFrontFacing(t,e,n,s){return nn.subVectors(n,e),Tn.subVectors(t,e),nn.cross(Tn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return nn.subVectors(this.c,this.b),Tn.subVectors(this.a,this.b),nn.cross(Tn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,a,o;Si.subVectors(s,n),bi.subVectors(r,n),xo.subVectors(t,n);let c=Si.dot(xo),l=bi.dot(xo);if(c<=0&&l<=0)return e.copy(n);vo.subVectors(t,s);let h=Si.dot(vo),f=bi.dot(vo);if(h>=0&&f<=h)return e.copy(s);let d=c*f-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return a=c/(c-h),e.copy(n).addScaledVector(Si,a);yo.subVectors(t,r);let m=Si.dot(yo),g=bi.dot(yo);if(g>=0&&m<=g)return e.copy(r);let M=m*l-c*g;if(M<=0&&l>=0&&g<=0)return o=l/(l-g),e.copy(n).addScaledVector(bi,o);let p=h*g-m*f;if(p<=0&&f-h>=0&&m-g>=0)return dc.subVectors(r,s),o=(f-h)/(f-h+(m-g)),e.copy(s).addScaledVector(dc,o);let u=1/(p+M+d);return a=M*u,o=d*u,e.copy(n).addScaledVector(Si,a).addScaledVector(bi,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Yn=class{constructor(t=new U(1/0,1/0,1/0),e=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(sn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(sn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=sn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,sn):sn.fromBufferAttribute(r,a),sn.applyMatrix4(t.matrixWorld),this.expandByPoint(sn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Zs.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Zs.copy(n.boundingBox)),Zs.applyMatrix4(t.matrixWorld),this.union(Zs)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,sn),sn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ji),Js.subVectors(this.max,ji),Ti.subVectors(t.a,ji),wi.subVectors(t.b,ji),Ei.subVectors(t.c,ji),Vn.subVectors(wi,Ti),Wn.subVectors(Ei,wi),ri.subVectors(Ti,Ei);let e=[0,-Vn.z,Vn.y,0,-Wn.z,Wn.y,0,-ri.z,ri.y,Vn.z,0,-Vn.x,Wn.z,0,-Wn.x,ri.z,0,-ri.x,-Vn.y,Vn.x,0,-Wn.y,Wn.x,0,-ri.y,ri.x,0];return!To(e,Ti,wi,Ei,Js)||(e=[1,0,0,0,1,0,0,0,1],!To(e,Ti,wi,Ei,Js))?!1:(Ks.crossVectors(Vn,Wn),e=[Ks.x,Ks.y,Ks.z],To(e,Ti,wi,Ei,Js))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,sn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(sn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(En[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),En[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),En[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),En[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),En[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),En[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),En[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),En[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(En),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},En=[new U,new U,new U,new U,new U,new U,new U,new U],sn=new U,Zs=new Yn,Ti=new U,wi=new U,Ei=new U,Vn=new U,Wn=new U,ri=new U,ji=new U,Js=new U,Ks=new U,ai=new U;function To(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){ai.fromArray(i,r);let o=s.x*Math.abs(ai.x)+s.y*Math.abs(ai.y)+s.z*Math.abs(ai.z),c=t.dot(ai),l=e.dot(ai),h=n.dot(ai);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>o)return!1}return!0}var he=new U,js=new Vt,ku=0,pn=class extends mn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ku++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=ah,this.updateRanges=[],this.gpuType=on,this.version=0,this._normalizationScale=t!==void 0?ul(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)js.fromBufferAttribute(this,e),js.applyMatrix3(t),this.setXY(e,js.x,js.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix3(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyMatrix4(t),this.setXYZ(e,he.x,he.y,he.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.applyNormalMatrix(t),this.setXYZ(e,he.x,he.y,he.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)he.fromBufferAttribute(this,e),he.transformDirection(t),this.setXYZ(e,he.x,he.y,he.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Cu(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Pu(t,this.array)}};var cs=class extends pn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var hs=class extends pn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var te=class extends pn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Hu=new Yn,Qi=new U,wo=new U,ci=class{constructor(t=new U,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Hu.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Qi.subVectors(t,this.center);let e=Qi.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Qi,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(wo.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Qi.copy(t.center).add(wo)),this.expandByPoint(Qi.copy(t.center).sub(wo))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Gu=0,Ke=new Qt,Eo=new we,Ai=new U,ke=new Yn,$i=new Yn,Me=new U,Pe=class i extends mn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Gu++}),this.uuid=Ns(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Eu(t)?hs:cs)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new _t().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ke.makeRotationFromQuaternion(t),this.applyMatrix4(Ke),this}rotateX(t){return Ke.makeRotationX(t),this.applyMatrix4(Ke),this}rotateY(t){return Ke.makeRotationY(t),this.applyMatrix4(Ke),this}rotateZ(t){return Ke.makeRotationZ(t),this.applyMatrix4(Ke),this}translate(t,e,n){return Ke.makeTranslation(t,e,n),this.applyMatrix4(Ke),this}scale(t,e,n){return Ke.makeScale(t,e,n),this.applyMatrix4(Ke),this}lookAt(t){return Eo.lookAt(t),Eo.updateMatrix(),this.applyMatrix4(Eo.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ai).negate(),this.translate(Ai.x,Ai.y,Ai.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new te(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Rt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Yn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Pt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ke.setFromBufferAttribute(r),this.morphTargetsRelative?(Me.addVectors(this.boundingBox.min,ke.min),this.boundingBox.expandByPoint(Me),Me.addVectors(this.boundingBox.max,ke.max),this.boundingBox.expandByPoint(Me)):(this.boundingBox.expandByPoint(ke.min),this.boundingBox.expandByPoint(ke.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Pt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ci);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Pt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(t){let n=this.boundingSphere.center;if(ke.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];$i.setFromBufferAttribute(o),this.morphTargetsRelative?(Me.addVectors(ke.min,$i.min),ke.expandByPoint(Me),Me.addVectors(ke.max,$i.max),ke.expandByPoint(Me)):(ke.expandByPoint($i.min),ke.expandByPoint($i.max))}ke.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Me.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Me));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],c=this.morphTargetsRelative;for(let l=0,h=o.count;l<h;l++)Me.fromBufferAttribute(o,l),c&&(Ai.fromBufferAttribute(t,l),Me.add(Ai)),s=Math.max(s,n.distanceToSquared(Me))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Pt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Pt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],c=[],l=new Uint8Array(n.count);for(let N=0;N<n.count;N++)o[N]=new U,c[N]=new U;let h=new U,f=new U,d=new U,m=new Vt,g=new Vt,M=new Vt,p=new U,u=new U;function S(N,I,D){l[N]=l[I]=l[D]=1,h.fromBufferAttribute(n,N),f.fromBufferAttribute(n,I),d.fromBufferAttribute(n,D),m.fromBufferAttribute(r,N),g.fromBufferAttribute(r,I),M.fromBufferAttribute(r,D),f.sub(h),d.sub(h),g.sub(m),M.sub(m);let B=1/(g.x*M.y-M.x*g.y);isFinite(B)&&(p.copy(f).multiplyScalar(M.y).addScaledVector(d,-g.y).multiplyScalar(B),u.copy(d).multiplyScalar(g.x).addScaledVector(f,-M.x).multiplyScalar(B),o[N].add(p),o[I].add(p),o[D].add(p),c[N].add(u),c[I].add(u),c[D].add(u))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let N=0,I=A.length;N<I;++N){let D=A[N],B=D.start,V=D.count;for(let P=B,G=B+V;P<G;P+=3)S(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let T=new U,R=new U,E=new U,x=new U;function b(N){E.fromBufferAttribute(s,N),x.copy(E);let I=o[N];T.copy(I),T.sub(E.multiplyScalar(E.dot(I))).normalize(),R.crossVectors(x,I);let B=R.dot(c[N])<0?-1:1;a.setXYZW(N,T.x,T.y,T.z,B)}for(let N=0,I=n.count;N<I;++N)l[N]&&b(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new pn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new U,r=new U,a=new U,o=new U,c=new U,l=new U,h=new U,f=new U;if(t)for(let d=0,m=t.count;d<m;d+=3){let g=t.getX(d+0),M=t.getX(d+1),p=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,M),a.fromBufferAttribute(e,p),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),o.fromBufferAttribute(n,g),c.fromBufferAttribute(n,M),l.fromBufferAttribute(n,p),o.add(h),c.add(h),l.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(M,c.x,c.y,c.z),n.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,m=e.count;d<m;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Me.fromBufferAttribute(t,e),Me.normalize(),t.setXYZ(e,Me.x,Me.y,Me.z)}toNonIndexed(){function t(o,c){let l=o.array,h=o.itemSize,f=o.normalized,d=new l.constructor(c.length*h),m=0,g=0;for(let M=0,p=c.length;M<p;M++){o.isInterleavedBufferAttribute?m=c[M]*o.data.stride+o.offset:m=c[M]*h;for(let u=0;u<h;u++)d[g++]=l[m++]}return new pn(d,h,f)}if(this.index===null)return Rt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let o in s){let c=s[o],l=t(c,n);e.setAttribute(o,l)}let r=this.morphAttributes;for(let o in r){let c=[],l=r[o];for(let h=0,f=l.length;h<f;h++){let d=l[h],m=t(d,n);c.push(m)}e.morphAttributes[o]=c}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,c=a.length;o<c;o++){let l=a[o];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let f=0,d=l.length;f<d;f++){let m=l[f];h.push(m.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],f=r[l];for(let d=0,m=f.length;d<m;d++)h.push(f[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let l=0,h=a.length;l<h;l++){let f=a[l];this.addGroup(f.start,f.count,f.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ao=new U,Vu=new U,Wu=new _t,rn=class{constructor(t=new U(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Ao.subVectors(n,e).cross(Vu.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Ao),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Wu.getNormalMatrix(t),s=this.coplanarPoint(Ao).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Xu=0,In=class extends mn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Xu++}),this.uuid=Ns(),this.name="",this.type="Material",this.blending=Gi,this.side=Qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Vo,this.blendDst=Wo,this.blendEquation=di,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ut(0,0,0),this.blendAlpha=0,this.depthFunc=Ii,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=th,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xr,this.stencilZFail=xr,this.stencilZPass=xr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Rt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Rt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let c=r[o];delete c.metadata,a.push(c)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ut().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new rn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Vt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Vt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var An=new U,Ro=new U,Qs=new U,$s=new U,us=class{constructor(t=new U,e=new U(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,An)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=An.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(An.copy(this.origin).addScaledVector(this.direction,e),An.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ro.copy(t).add(e).multiplyScalar(.5),Qs.copy(e).sub(t).normalize(),$s.copy(this.origin).sub(Ro);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Qs),o=$s.dot(this.direction),c=-$s.dot(Qs),l=$s.lengthSq(),h=Math.abs(1-a*a),f,d,m,g;if(h>0)if(f=a*c-o,d=a*o-c,g=r*h,f>=0)if(d>=-g)if(d<=g){let M=1/h;f*=M,d*=M,m=f*(f+a*d+2*o)+d*(a*f+d+2*c)+l}else d=r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d=-r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;else d<=-g?(f=Math.max(0,-(-a*r+o)),d=f>0?-r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l):d<=g?(f=0,d=Math.min(Math.max(-r,-c),r),m=d*(d+2*c)+l):(f=Math.max(0,-(a*r+o)),d=f>0?r:Math.min(Math.max(-r,-c),r),m=-f*f+d*(d+2*c)+l);else d=a>0?-r:r,f=Math.max(0,-(a*d+o)),m=-f*f+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Ro).addScaledVector(Qs,d),m}intersectSphere(t,e){if(t.radius<0)return null;An.subVectors(t.center,this.origin);let n=An.dot(this.direction),s=An.dot(An)-n*n,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,c=n+a;return c<0?null:o<0?this.at(c,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,c,l=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(t.min.z-d.z)*f,c=(t.max.z-d.z)*f):(o=(t.max.z-d.z)*f,c=(t.min.z-d.z)*f),n>c||o>s)||((o>n||n!==n)&&(n=o),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,An)!==null}intersectTriangle(t,e,n,s,r){let a=this.origin,o=this.direction,c=o.x,l=o.y,h=o.z,f=t.x-a.x,d=t.y-a.y,m=t.z-a.z,g=e.x-a.x,M=e.y-a.y,p=e.z-a.z,u=n.x-a.x,S=n.y-a.y,A=n.z-a.z,T=Math.abs(c),R=Math.abs(l),E=Math.abs(h),x,b,N,I,D,B,V,P,G,Y,H,et;if(T>=R&&T>=E?(N=c,B=f,G=g,et=u,c>=0?(x=l,b=h,I=d,D=m,V=M,P=p,Y=S,H=A):(x=h,b=l,I=m,D=d,V=p,P=M,Y=A,H=S)):R>=E?(N=l,B=d,G=M,et=S,l>=0?(x=h,b=c,I=m,D=f,V=p,P=g,Y=A,H=u):(x=c,b=h,I=f,D=m,V=g,P=p,Y=u,H=A)):(N=h,B=m,G=p,et=A,h>=0?(x=c,b=l,I=f,D=d,V=g,P=M,Y=u,H=S):(x=l,b=c,I=d,D=f,V=M,P=g,Y=S,H=u)),N===0)return null;let X=x/N,Q=b/N,$=1/N,St=I-X*B,Lt=D-Q*B,J=V-X*G,pt=P-Q*G,vt=Y-X*et,Et=H-Q*et,mt=vt*pt-Et*J,Nt=St*Et-Lt*vt,le=J*Lt-pt*St;if(s){if(mt<0||Nt<0||le<0)return null}else if((mt<0||Nt<0||le<0)&&(mt>0||Nt>0||le>0))return null;let Ct=mt+Nt+le;if(Ct===0)return null;let Zt=$*(mt*B+Nt*G+le*et);return(Ct>0?Zt<0:Zt>0)?null:this.at(Zt/Ct,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},$e=class extends In{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _n,this.combine=Qr,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fc=new Qt,oi=new us,tr=new ci,pc=new U,er=new U,nr=new U,ir=new U,Co=new U,sr=new U,mc=new U,rr=new U,pe=class extends we{constructor(t=new Pe,e=new $e){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){sr.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=o[c],f=r[c];h!==0&&(Co.fromBufferAttribute(f,t),a?sr.addScaledVector(Co,h):sr.addScaledVector(Co.sub(e),h))}e.add(sr)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),tr.copy(n.boundingSphere),tr.applyMatrix4(r),oi.copy(t.ray).recast(t.near),!(tr.containsPoint(oi.origin)===!1&&(oi.intersectSphere(tr,pc)===null||oi.origin.distanceToSquared(pc)>(t.far-t.near)**2))&&(fc.copy(r).invert(),oi.copy(t.ray).applyMatrix4(fc),!(n.boundingBox!==null&&oi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,oi)))}_computeIntersections(t,e,n){let s,r=this.geometry,a=this.material,o=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,d=r.groups,m=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,M=d.length;g<M;g++){let p=d[g],u=a[p.materialIndex],S=Math.max(p.start,m.start),A=Math.min(o.count,Math.min(p.start+p.count,m.start+m.count));for(let T=S,R=A;T<R;T+=3){let E=o.getX(T),x=o.getX(T+1),b=o.getX(T+2);s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),M=Math.min(o.count,m.start+m.count);for(let p=g,u=M;p<u;p+=3){let S=o.getX(p),A=o.getX(p+1),T=o.getX(p+2);s=ar(this,a,t,n,l,h,f,S,A,T),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(a))for(let g=0,M=d.length;g<M;g++){let p=d[g],u=a[p.materialIndex],S=Math.max(p.start,m.start),A=Math.min(c.count,Math.min(p.start+p.count,m.start+m.count));for(let T=S,R=A;T<R;T+=3){let E=T,x=T+1,b=T+2;s=ar(this,u,t,n,l,h,f,E,x,b),s&&(s.faceIndex=Math.floor(T/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,m.start),M=Math.min(c.count,m.start+m.count);for(let p=g,u=M;p<u;p+=3){let S=p,A=p+1,T=p+2;s=ar(this,a,t,n,l,h,f,S,A,T),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function Yu(i,t,e,n,s,r,a,o){let c;if(t.side===Ne?c=n.intersectTriangle(a,r,s,!0,o):c=n.intersectTriangle(s,r,a,t.side===Qn,o),c===null)return null;rr.copy(o),rr.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(rr);return l<e.near||l>e.far?null:{distance:l,point:rr.clone(),object:i}}function ar(i,t,e,n,s,r,a,o,c,l){i.getVertexPosition(o,er),i.getVertexPosition(c,nr),i.getVertexPosition(l,ir);let h=Yu(i,t,e,n,er,nr,ir,mc);if(h){let f=new U;Rn.getBarycoord(mc,er,nr,ir,f),s&&(h.uv=Rn.getInterpolatedAttribute(s,o,c,l,f,new Vt)),r&&(h.uv1=Rn.getInterpolatedAttribute(r,o,c,l,f,new Vt)),a&&(h.normal=Rn.getInterpolatedAttribute(a,o,c,l,f,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:c,c:l,normal:new U,materialIndex:0};Rn.getNormal(er,nr,ir,d.normal),h.face=d,h.barycoord=f}return h}var Dr=class extends Oe{constructor(t=null,e=1,n=1,s,r,a,o,c,l=Se,h=Se,f,d){super(null,a,o,c,l,h,s,r,f,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var li=new ci,qu=new Vt(.5,.5),or=new U,qn=class{constructor(t=new rn,e=new rn,n=new rn,s=new rn,r=new rn,a=new rn){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=je,n=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],c=r[2],l=r[3],h=r[4],f=r[5],d=r[6],m=r[7],g=r[8],M=r[9],p=r[10],u=r[11],S=r[12],A=r[13],T=r[14],R=r[15];if(s[0].setComponents(l-a,m-h,u-g,R-S).normalize(),s[1].setComponents(l+a,m+h,u+g,R+S).normalize(),s[2].setComponents(l+o,m+f,u+M,R+A).normalize(),s[3].setComponents(l-o,m-f,u-M,R-A).normalize(),n)s[4].setComponents(c,d,p,T).normalize(),s[5].setComponents(l-c,m-d,u-p,R-T).normalize();else if(s[4].setComponents(l-c,m-d,u-p,R-T).normalize(),e===je)s[5].setComponents(l+c,m+d,u+p,R+T).normalize();else if(e===Li)s[5].setComponents(c,d,p,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),li.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),li.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(li)}intersectsSprite(t){li.center.set(0,0,0);let e=qu.distanceTo(t.center);return li.radius=.7071067811865476+e,li.applyMatrix4(t.matrixWorld),this.intersectsSphere(li)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(or.x=s.normal.x>0?t.max.x:t.min.x,or.y=s.normal.y>0?t.max.y:t.min.y,or.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(or)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},gc=new Qt,Nr=class i{constructor(){this.coordinateSystem=je,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];gc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new qn),n[s].setFromProjectionMatrix(gc,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new qn),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Zn=class extends In{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ur=new U,Fr=new U,xc=new Qt,ts=new us,lr=new ci,Po=new U,vc=new U,Fi=class extends we{constructor(t=new Pe,e=new Zn){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ur.fromBufferAttribute(e,s-1),Fr.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ur.distanceTo(Fr);t.setAttribute("lineDistance",new te(n,1))}else Rt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),lr.copy(n.boundingSphere),lr.applyMatrix4(s),lr.radius+=r,t.ray.intersectsSphere(lr)===!1)return;xc.copy(s).invert(),ts.copy(t.ray).applyMatrix4(xc);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let M=m,p=g-1;M<p;M+=l){let u=h.getX(M),S=h.getX(M+1),A=cr(this,t,ts,c,u,S,M);A&&e.push(A)}if(this.isLineLoop){let M=h.getX(g-1),p=h.getX(m),u=cr(this,t,ts,c,M,p,g-1);u&&e.push(u)}}else{let m=Math.max(0,a.start),g=Math.min(d.count,a.start+a.count);for(let M=m,p=g-1;M<p;M+=l){let u=cr(this,t,ts,c,M,M+1,M);u&&e.push(u)}if(this.isLineLoop){let M=cr(this,t,ts,c,g-1,m,g-1);M&&e.push(M)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function cr(i,t,e,n,s,r,a){let o=i.geometry.attributes.position;if(Ur.fromBufferAttribute(o,s),Fr.fromBufferAttribute(o,r),e.distanceSqToSegment(Ur,Fr,Po,vc)>n)return;Po.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Po);if(!(l<t.near||l>t.far))return{distance:l,point:vc.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var yc=new U,Mc=new U,Oi=class extends Fi{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)yc.fromBufferAttribute(e,s),Mc.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+yc.distanceTo(Mc);t.setAttribute("lineDistance",new te(n,1))}else Rt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ds=class extends Oe{constructor(t=[],e=fi,n,s,r,a,o,c,l,h){super(t,e,n,s,r,a,o,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ln=class extends Oe{constructor(t,e,n=an,s,r,a,o=Se,c=Se,l,h=Pn,f=1){if(h!==Pn&&h!==Un)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:f};super(d,s,r,a,o,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ni(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},fs=class extends Ln{constructor(t,e=an,n=fi,s,r,a=Se,o=Se,c,l=Pn){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ps=class extends Oe{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Dn=class i extends Pe{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let c=[],l=[],h=[],f=[],d=0,m=0;g("z","y","x",-1,-1,n,e,t,a,r,0),g("z","y","x",1,-1,n,e,-t,a,r,1),g("x","z","y",1,1,t,n,e,s,a,2),g("x","z","y",1,-1,t,n,-e,s,a,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2));function g(M,p,u,S,A,T,R,E,x,b,N){let I=T/x,D=R/b,B=T/2,V=R/2,P=E/2,G=x+1,Y=b+1,H=0,et=0,X=new U;for(let Q=0;Q<Y;Q++){let $=Q*D-V;for(let St=0;St<G;St++){let Lt=St*I-B;X[M]=Lt*S,X[p]=$*A,X[u]=P,l.push(X.x,X.y,X.z),X[M]=0,X[p]=0,X[u]=E>0?1:-1,h.push(X.x,X.y,X.z),f.push(St/x),f.push(1-Q/b),H+=1}}for(let Q=0;Q<b;Q++)for(let $=0;$<x;$++){let St=d+$+G*Q,Lt=d+$+G*(Q+1),J=d+($+1)+G*(Q+1),pt=d+($+1)+G*Q;c.push(St,Lt,pt),c.push(Lt,J,pt),et+=6}o.addGroup(m,et,N),m+=et,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Bi=class i extends Pe{constructor(t=1,e=1,n=1,s=32,r=1,a=!1,o=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],f=[],d=[],m=[],g=0,M=[],p=n/2,u=0;S(),a===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new te(f,3)),this.setAttribute("normal",new te(d,3)),this.setAttribute("uv",new te(m,2));function S(){let T=new U,R=new U,E=0,x=(e-t)/n;for(let b=0;b<=r;b++){let N=[],I=b/r,D=I*(e-t)+t;for(let B=0;B<=s;B++){let V=B/s,P=V*c+o,G=Math.sin(P),Y=Math.cos(P);R.x=D*G,R.y=-I*n+p,R.z=D*Y,f.push(R.x,R.y,R.z),T.set(G,x,Y).normalize(),d.push(T.x,T.y,T.z),m.push(V,1-I),N.push(g++)}M.push(N)}for(let b=0;b<s;b++)for(let N=0;N<r;N++){let I=M[N][b],D=M[N+1][b],B=M[N+1][b+1],V=M[N][b+1];(t>0||N!==0)&&(h.push(I,D,V),E+=3),(e>0||N!==r-1)&&(h.push(D,B,V),E+=3)}l.addGroup(u,E,0),u+=E}function A(T){let R=g,E=new Vt,x=new U,b=0,N=T===!0?t:e,I=T===!0?1:-1;for(let B=1;B<=s;B++)f.push(0,p*I,0),d.push(0,I,0),m.push(.5,.5),g++;let D=g;for(let B=0;B<=s;B++){let P=B/s*c+o,G=Math.cos(P),Y=Math.sin(P);x.x=N*Y,x.y=p*I,x.z=N*G,f.push(x.x,x.y,x.z),d.push(0,I,0),E.x=G*.5+.5,E.y=Y*.5*I+.5,m.push(E.x,E.y),g++}for(let B=0;B<s;B++){let V=R+B,P=D+B;T===!0?h.push(P,P+1,V):h.push(P+1,P,V),b+=3}l.addGroup(u,b,T===!0?1:2),u+=b}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ms=class i extends Bi{constructor(t=1,e=1,n=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,n,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var hr=new U,ur=new U,_o=new U,dr=new Rn,gs=class extends Pe{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(vr*e),a=t.getIndex(),o=t.getAttribute("position"),c=a?a.count:o.count,l=[0,0,0],h=["a","b","c"],f=new Array(3),d=new Map,m=[];for(let g=0;g<c;g+=3){a?(l[0]=a.getX(g),l[1]=a.getX(g+1),l[2]=a.getX(g+2)):(l[0]=g,l[1]=g+1,l[2]=g+2);let{a:M,b:p,c:u}=dr;if(M.fromBufferAttribute(o,l[0]),p.fromBufferAttribute(o,l[1]),u.fromBufferAttribute(o,l[2]),dr.getNormal(_o),f[0]=`${Math.round(M.x*s)},${Math.round(M.y*s)},${Math.round(M.z*s)}`,f[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,f[2]=`${Math.round(u.x*s)},${Math.round(u.y*s)},${Math.round(u.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let S=0;S<3;S++){let A=(S+1)%3,T=f[S],R=f[A],E=dr[h[S]],x=dr[h[A]],b=`${T}_${R}`,N=`${R}_${T}`,I=d.get(N);I?(_o.dot(I.normal)<=r&&(m.push(E.x,E.y,E.z),m.push(x.x,x.y,x.z)),d.set(N,null)):d.has(b)||d.set(b,{index0:l[S],index1:l[A],normal:_o.clone()})}}for(let g of d.values())if(g){let{index0:M,index1:p}=g;hr.fromBufferAttribute(o,M),ur.fromBufferAttribute(o,p),m.push(hr.x,hr.y,hr.z),m.push(ur.x,ur.y,ur.z)}this.setAttribute("position",new te(m,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var hi=class i extends Pe{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(n),c=Math.floor(s),l=o+1,h=c+1,f=t/o,d=e/c,m=[],g=[],M=[],p=[];for(let u=0;u<h;u++){let S=u*d-a;for(let A=0;A<l;A++){let T=A*f-r;g.push(T,-S,0),M.push(0,0,1),p.push(A/o),p.push(1-u/c)}}for(let u=0;u<c;u++)for(let S=0;S<o;S++){let A=S+l*u,T=S+l*(u+1),R=S+1+l*(u+1),E=S+1+l*u;m.push(A,T,E),m.push(T,R,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(M,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var zi=class i extends Pe{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(a+o,Math.PI),l=0,h=[],f=new U,d=new U,m=[],g=[],M=[],p=[];for(let u=0;u<=n;u++){let S=[],A=u/n,T=a+A*o,R=t*Math.cos(T),E=Math.sqrt(t*t-R*R),x=0;u===0&&a===0?x=.5/e:u===n&&c===Math.PI&&(x=-.5/e);for(let b=0;b<=e;b++){let N=b/e,I=s+N*r;f.x=-E*Math.cos(I),f.y=R,f.z=E*Math.sin(I),g.push(f.x,f.y,f.z),d.copy(f).normalize(),M.push(d.x,d.y,d.z),p.push(N+x,1-A),S.push(l++)}h.push(S)}for(let u=0;u<n;u++)for(let S=0;S<e;S++){let A=h[u][S+1],T=h[u][S],R=h[u+1][S],E=h[u+1][S+1];(u!==0||a>0)&&m.push(A,T,E),(u!==n-1||c<Math.PI)&&m.push(T,R,E)}this.setIndex(m),this.setAttribute("position",new te(g,3)),this.setAttribute("normal",new te(M,3)),this.setAttribute("uv",new te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var xs=class i extends Pe{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],h=[],f=[],d=new U,m=new U,g=new U;for(let M=0;M<=n;M++){let p=a+M/n*o;for(let u=0;u<=s;u++){let S=u/s*r;m.x=(t+e*Math.cos(p))*Math.cos(S),m.y=(t+e*Math.cos(p))*Math.sin(S),m.z=e*Math.sin(p),l.push(m.x,m.y,m.z),d.x=t*Math.cos(S),d.y=t*Math.sin(S),g.subVectors(m,d).normalize(),h.push(g.x,g.y,g.z),f.push(u/s),f.push(M/n)}}for(let M=1;M<=n;M++)for(let p=1;p<=s;p++){let u=(s+1)*M+p-1,S=(s+1)*(M-1)+p-1,A=(s+1)*(M-1)+p,T=(s+1)*M+p;c.push(u,S,T),c.push(S,A,T)}this.setIndex(c),this.setAttribute("position",new te(l,3)),this.setAttribute("normal",new te(h,3)),this.setAttribute("uv",new te(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function mi(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Sc(s))s.isRenderTargetTexture?(Rt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Sc(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function _e(i){let t={};for(let e=0;e<i.length;e++){let n=mi(i[e]);for(let s in n)t[s]=n[s]}return t}function Sc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Zu(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function dl(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Gt.workingColorSpace}var fh={clone:mi,merge:_e},Ju=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ku=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,gn=class extends In{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ju,this.fragmentShader=Ku,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=mi(t.uniforms),this.uniformsGroups=Zu(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Ut().setHex(s.value);break;case"v2":this.uniforms[n].value=new Vt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new U().fromArray(s.value);break;case"v4":this.uniforms[n].value=new se().fromArray(s.value);break;case"m3":this.uniforms[n].value=new _t().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Or=class extends gn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vs=class extends In{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ba,this.normalScale=new Vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new _n,this.combine=Qr,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Br=class extends In{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qc,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},zr=class extends In{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ri(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function fr(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Jn=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let a;e:{i:if(!(t<s)){for(let o=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=e[++n],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(n=2,r=o);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}a=n,n=0;break e}break n}for(;n<a;){let o=n+a>>>1;t<e[o]?a=o:n=o+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=n[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},kr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Do,endingEnd:Do}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],c=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case No:r=t,o=2*e-n;break;case Uo:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=n}if(c===void 0)switch(this.getSettings_().endingEnd){case No:a=t,c=2*n-e;break;case Uo:a=1,c=n+s[1]-s[0];break;default:a=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-o),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-e)/(s-e),M=g*g,p=M*g,u=-d*p+2*d*M-d*g,S=(1+d)*p+(-1.5-2*d)*M+(-.5+d)*g+1,A=(-1-m)*p+(1.5+m)*M+.5*g,T=m*p-m*M;for(let R=0;R!==o;++R)r[R]=u*a[h+R]+S*a[l+R]+A*a[c+R]+T*a[f+R];return r}},Hr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=(n-e)/(s-e),f=1-h;for(let d=0;d!==o;++d)r[d]=a[l+d]*f+a[c+d]*h;return r}},Gr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Vr=class extends Jn{interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=t*o,l=c-o,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-e)/(s-e),M=1-g;for(let p=0;p!==o;++p)r[p]=a[l+p]*M+a[c+p]*g;return r}let d=o*2,m=t-1;for(let g=0;g!==o;++g){let M=a[l+g],p=a[c+g],u=m*d+g*2,S=f[u],A=f[u+1],T=t*d+g*2,R=h[T],E=h[T+1],x=Qu(n,e,S,R,s);r[g]=ph(x,M,A,E,p)}return r}};function ph(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function ju(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function Qu(i,t,e,n,s){let r=(i-t)/(s-t);for(let a=0;a<8;a++){let o=ph(r,t,e,n,s)-i;if(Math.abs(o)<1e-10)break;let c=ju(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-o/c))}return r}var We=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ri(e,this.TimeBufferType),this.values=Ri(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Ri(t.times,Array),values:Ri(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),fr(t.settings)&&(n.settings={inTangents:Ri(t.settings.inTangents,Array),outTangents:Ri(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Gr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Hr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new kr(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Vr(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ns:e=this.InterpolantFactoryMethodDiscrete;break;case Cr:e=this.InterpolantFactoryMethodLinear;break;case gr:e=this.InterpolantFactoryMethodSmooth;break;case Lo:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Rt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ns;case this.InterpolantFactoryMethodLinear:return Cr;case this.InterpolantFactoryMethodSmooth:return gr;case this.InterpolantFactoryMethodBezier:return Lo}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;fr(this.settings)&&(bc(this.settings.inTangents,t),bc(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;fr(this.settings)&&(Tc(this.settings.inTangents,t),Tc(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<t;)++r;for(;a!==-1&&n[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Pt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Pt("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let c=n[o];if(typeof c=="number"&&isNaN(c)){Pt("KeyframeTrack: Time is not a valid number.",this,o,c),t=!1;break}if(a!==null&&a>c){Pt("KeyframeTrack: Out of order keys.",this,o,c,a),t=!1;break}a=c}if(s!==void 0&&Au(s))for(let o=0,c=s.length;o!==c;++o){let l=s[o];if(isNaN(l)){Pt("KeyframeTrack: Value is not a valid number.",this,o,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===gr,r=t.length-1,a=1;for(let o=1;o<r;++o){let c=!1,l=t[o],h=t[o+1];if(l!==h&&(o!==1||l!==t[0]))if(s)c=!0;else{let f=o*n,d=f-n,m=f+n;for(let g=0;g!==n;++g){let M=e[f+g];if(M!==e[d+g]||M!==e[m+g]){c=!0;break}}}if(c){if(o!==a){t[a]=t[o];let f=o*n,d=a*n;for(let m=0;m!==n;++m)e[d+m]=e[f+m]}++a}}if(r>0){t[a]=t[r];for(let o=r*n,c=a*n,l=0;l!==n;++l)e[c+l]=e[o+l];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,fr(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Tc(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}We.prototype.ValueTypeName="";We.prototype.TimeBufferType=Float32Array;We.prototype.ValueBufferType=Float32Array;We.prototype.DefaultInterpolation=Cr;var Kn=class extends We{constructor(t,e,n){super(t,e,n)}};Kn.prototype.ValueTypeName="bool";Kn.prototype.ValueBufferType=Array;Kn.prototype.DefaultInterpolation=ns;Kn.prototype.InterpolantFactoryMethodLinear=void 0;Kn.prototype.InterpolantFactoryMethodSmooth=void 0;var Wr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Wr.prototype.ValueTypeName="color";var Xr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};Xr.prototype.ValueTypeName="number";var Yr=class extends Jn{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,c=(n-e)/(s-e),l=t*o;for(let h=l+o;l!==h;l+=4)Qe.slerpFlat(r,0,a,l-o,a,l,c);return r}},ys=class extends We{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Yr(this.times,this.values,this.getValueSize(),t)}};ys.prototype.ValueTypeName="quaternion";ys.prototype.InterpolantFactoryMethodSmooth=void 0;var jn=class extends We{constructor(t,e,n){super(t,e,n)}};jn.prototype.ValueTypeName="string";jn.prototype.ValueBufferType=Array;jn.prototype.DefaultInterpolation=ns;jn.prototype.InterpolantFactoryMethodLinear=void 0;jn.prototype.InterpolantFactoryMethodSmooth=void 0;var qr=class extends We{constructor(t,e,n,s){super(t,e,n,s)}};qr.prototype.ValueTypeName="vector";var Zr=class{constructor(t,e,n){let s=this,r=!1,a=0,o=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,f){return l.push(h,f),this},this.removeHandler=function(h){let f=l.indexOf(h);return f!==-1&&l.splice(f,2),this},this.getHandler=function(h){for(let f=0,d=l.length;f<d;f+=2){let m=l[f],g=l[f+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mh=new Zr,Jr=class{constructor(t){this.manager=t!==void 0?t:mh,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jr.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ms=class extends we{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ut(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ss=class extends Ms{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(we.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ut(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Io=new Qt,wc=new U,Ec=new U,Kr=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Vt(512,512),this.mapType=Be,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new qn,this._frameExtents=new Vt(1,1),this._viewportCount=1,this._viewports=[new se(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;wc.setFromMatrixPosition(t.matrixWorld),e.position.copy(wc),Ec.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Ec),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Io.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Io,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Li||t.reversedDepth?e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+c,0,.5*o,0,.5*o+l,0,0,.5,.5,0,0,0,1),e.multiply(Io)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},pr=new U,mr=new Qe,dn=new U,bs=class extends we{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=je,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(pr,mr,dn),dn.x===1&&dn.y===1&&dn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(pr,mr,dn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Xn=new U,Ac=new Vt,Rc=new Vt,Le=class extends bs{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Pr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(vr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Pr*2*Math.atan(Math.tan(vr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Xn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z),Xn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Xn.x,Xn.y).multiplyScalar(-t/Xn.z)}getViewSize(t,e){return this.getViewBounds(t,Ac,Rc),e.subVectors(Rc,Ac)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(vr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let c=a.fullWidth,l=a.fullHeight;r+=a.offsetX*s/c,e-=a.offsetY*n/l,s*=a.width/c,n*=a.height/l}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ts=class extends bs{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,a=n+t,o=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,a=r+l*this.view.width,o-=h*this.view.offsetY,c=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Fo=class extends Kr{constructor(){super(new Ts(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ws=class extends Ms{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(we.DEFAULT_UP),this.updateMatrix(),this.target=new we,this.shadow=new Fo}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Ci=-90,Pi=1,ki=class extends we{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Le(Ci,Pi,t,e);s.layers=this.layers,this.add(s);let r=new Le(Ci,Pi,t,e);r.layers=this.layers,this.add(r);let a=new Le(Ci,Pi,t,e);a.layers=this.layers,this.add(a);let o=new Le(Ci,Pi,t,e);o.layers=this.layers,this.add(o);let c=new Le(Ci,Pi,t,e);c.layers=this.layers,this.add(c);let l=new Le(Ci,Pi,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,c]=e;for(let l of e)this.remove(l);if(t===je)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Li)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,c,l,h]=this.children,f=t.getRenderTarget(),d=t.getActiveCubeFace(),m=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let M=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=M,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,d,m),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},jr=class extends Le{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var fl="\\[\\]\\.:\\/",$u=new RegExp("["+fl+"]","g"),pl="[^"+fl+"]",td="[^"+fl.replace("\\.","")+"]",ed=/((?:WC+[\/:])*)/.source.replace("WC",pl),nd=/(WCOD+)?/.source.replace("WCOD",td),id=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",pl),sd=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",pl),rd=new RegExp("^"+ed+nd+id+sd+"$"),ad=["material","materials","bones","map"],Oo=class{constructor(t,e,n){let s=n||ee.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},ee=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace($u,"")}static parseTrackName(t){let e=rd.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ad.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let c=n(o.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Rt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){Pt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Pt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Pt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Pt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Pt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Pt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){Pt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let a=t[s];if(a===void 0){let l=e.nodeName;Pt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Pt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Pt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(c=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ee.Composite=Oo;ee.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ee.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ee.prototype.GetterByBindingType=[ee.prototype._getValue_direct,ee.prototype._getValue_array,ee.prototype._getValue_arrayElement,ee.prototype._getValue_toArray];ee.prototype.SetterByBindingTypeAndVersioning=[[ee.prototype._setValue_direct,ee.prototype._setValue_direct_setNeedsUpdate,ee.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_array,ee.prototype._setValue_array_setNeedsUpdate,ee.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_arrayElement,ee.prototype._setValue_arrayElement_setNeedsUpdate,ee.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ee.prototype._setValue_fromArray,ee.prototype._setValue_fromArray_setNeedsUpdate,ee.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var p0=new Float32Array(1);var Bo=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Es=class extends Oi{constructor(t=10,e=10,n=4473924,s=8947848){n=new Ut(n),s=new Ut(s);let r=e/2,a=t/e,o=t/2,c=[],l=[];for(let d=0,m=0,g=-o;d<=e;d++,g+=a){c.push(-o,0,g,o,0,g),c.push(g,0,-o,g,0,o);let M=d===r?n:s;M.toArray(l,m),m+=3,M.toArray(l,m),m+=3,M.toArray(l,m),m+=3,M.toArray(l,m),m+=3}let h=new Pe;h.setAttribute("position",new te(c,3)),h.setAttribute("color",new te(l,3));let f=new Zn({vertexColors:!0,toneMapped:!1});super(h,f),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};function ml(i,t,e,n){let s=od(n);switch(e){case il:return i*t;case rl:return i*t/s.components*s.byteLength;case ra:return i*t/s.components*s.byteLength;case $n:return i*t*2/s.components*s.byteLength;case aa:return i*t*2/s.components*s.byteLength;case sl:return i*t*3/s.components*s.byteLength;case cn:return i*t*4/s.components*s.byteLength;case oa:return i*t*4/s.components*s.byteLength;case Cs:case Ps:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case _s:case Is:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ca:case ua:return Math.max(i,16)*Math.max(t,8)/4;case la:case ha:return Math.max(i,8)*Math.max(t,8)/2;case da:case fa:case ma:case ga:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case pa:case Ls:case xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case va:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ya:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Ma:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Sa:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ba:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Ta:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case wa:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ea:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Aa:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Ra:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ca:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Pa:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case _a:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Ia:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case La:case Da:case Na:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ua:case Fa:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ds:case Oa:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function od(i){switch(i){case Be:case $o:return{byteLength:1,components:1};case Wi:case tl:case ln:return{byteLength:2,components:1};case ia:case sa:return{byteLength:2,components:4};case an:case na:case on:return{byteLength:4,components:1};case el:case nl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Rt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Oh(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function cd(i){let t=new WeakMap;function e(o,c){let l=o.array,h=o.usage,f=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),o.onUploadCallback();let m;if(l instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)m=i.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)m=i.SHORT;else if(l instanceof Uint32Array)m=i.UNSIGNED_INT;else if(l instanceof Int32Array)m=i.INT;else if(l instanceof Int8Array)m=i.BYTE;else if(l instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:m,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,c,l){let h=c.array,f=c.updateRanges;if(i.bindBuffer(l,o),f.length===0)i.bufferSubData(l,0,h);else{f.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<f.length;m++){let g=f[d],M=f[m];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++d,f[d]=M)}f.length=d+1;for(let m=0,g=f.length;m<g;m++){let M=f[m];i.bufferSubData(l,M.start*h.BYTES_PER_ELEMENT,h,M.start,M.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let c=t.get(o);c&&(i.deleteBuffer(c.buffer),t.delete(o))}function a(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let l=t.get(o);if(l===void 0)t.set(o,e(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,o,c),l.version=o.version}}return{get:s,remove:r,update:a}}var hd=`#ifdef USE_ALPHAHASH
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
#endif`,Rd=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Cd=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Pd=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,_d=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
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
}`,Hd=`#ifdef USE_ENVMAP
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
#endif`,Yd=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,qd=`#ifdef USE_FOG
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
#endif`,_f=`#ifndef FLAT_SHADED
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
#endif`,Hf=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Gf=`#ifdef DITHERING
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
#endif`,qf=`#if NUM_SPOT_LIGHT_COORDS > 0
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
}`,_p=`#define NORMAL
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
}`,Hp=`uniform vec3 color;
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
}`,Bt={alphahash_fragment:hd,alphahash_pars_fragment:ud,alphamap_fragment:dd,alphamap_pars_fragment:fd,alphatest_fragment:pd,alphatest_pars_fragment:md,aomap_fragment:gd,aomap_pars_fragment:xd,batching_pars_vertex:vd,batching_vertex:yd,begin_vertex:Md,beginnormal_vertex:Sd,bsdfs:bd,iridescence_fragment:Td,bumpmap_pars_fragment:wd,clipping_planes_fragment:Ed,clipping_planes_pars_fragment:Ad,clipping_planes_pars_vertex:Rd,clipping_planes_vertex:Cd,color_fragment:Pd,color_pars_fragment:_d,color_pars_vertex:Id,color_vertex:Ld,common:Dd,defaultnormal_vertex:Nd,displacementmap_pars_vertex:Ud,displacementmap_vertex:Fd,emissivemap_fragment:Od,emissivemap_pars_fragment:Bd,colorspace_fragment:zd,colorspace_pars_fragment:kd,envmap_fragment:Hd,envmap_common_pars_fragment:Gd,envmap_pars_fragment:Vd,envmap_pars_vertex:Wd,envmap_physical_pars_fragment:ef,envmap_vertex:Xd,fog_vertex:Yd,fog_pars_vertex:qd,fog_fragment:Zd,fog_pars_fragment:Jd,gradientmap_pars_fragment:Kd,lightmap_pars_fragment:jd,lights_lambert_fragment:Qd,lights_lambert_pars_fragment:$d,lights_pars_begin:tf,lights_toon_fragment:nf,lights_toon_pars_fragment:sf,lights_phong_fragment:rf,lights_phong_pars_fragment:af,lights_physical_fragment:of,lights_physical_pars_fragment:lf,lights_fragment_begin:cf,lights_fragment_maps:hf,lights_fragment_end:uf,lightprobes_pars_fragment:df,logdepthbuf_fragment:ff,logdepthbuf_pars_fragment:pf,logdepthbuf_pars_vertex:mf,logdepthbuf_vertex:gf,map_fragment:xf,map_pars_fragment:vf,map_particle_fragment:yf,map_particle_pars_fragment:Mf,metalnessmap_fragment:Sf,metalnessmap_pars_fragment:bf,morphinstance_vertex:Tf,morphcolor_vertex:wf,morphnormal_vertex:Ef,morphtarget_pars_vertex:Af,morphtarget_vertex:Rf,normal_fragment_begin:Cf,normal_fragment_maps:Pf,normal_pars_fragment:_f,normal_pars_vertex:If,normal_vertex:Lf,normalmap_pars_fragment:Df,clearcoat_normal_fragment_begin:Nf,clearcoat_normal_fragment_maps:Uf,clearcoat_pars_fragment:Ff,iridescence_pars_fragment:Of,opaque_fragment:Bf,packing:zf,premultiplied_alpha_fragment:kf,project_vertex:Hf,dithering_fragment:Gf,dithering_pars_fragment:Vf,roughnessmap_fragment:Wf,roughnessmap_pars_fragment:Xf,shadowmap_pars_fragment:Yf,shadowmap_pars_vertex:qf,shadowmap_vertex:Zf,shadowmask_pars_fragment:Jf,skinbase_vertex:Kf,skinning_pars_vertex:jf,skinning_vertex:Qf,skinnormal_vertex:$f,specularmap_fragment:tp,specularmap_pars_fragment:ep,tonemapping_fragment:np,tonemapping_pars_fragment:ip,transmission_fragment:sp,transmission_pars_fragment:rp,uv_pars_fragment:ap,uv_pars_vertex:op,uv_vertex:lp,worldpos_vertex:cp,background_vert:hp,background_frag:up,backgroundCube_vert:dp,backgroundCube_frag:fp,cube_vert:pp,cube_frag:mp,depth_vert:gp,depth_frag:xp,distance_vert:vp,distance_frag:yp,equirect_vert:Mp,equirect_frag:Sp,linedashed_vert:bp,linedashed_frag:Tp,meshbasic_vert:wp,meshbasic_frag:Ep,meshlambert_vert:Ap,meshlambert_frag:Rp,meshmatcap_vert:Cp,meshmatcap_frag:Pp,meshnormal_vert:_p,meshnormal_frag:Ip,meshphong_vert:Lp,meshphong_frag:Dp,meshphysical_vert:Np,meshphysical_frag:Up,meshtoon_vert:Fp,meshtoon_frag:Op,points_vert:Bp,points_frag:zp,shadow_vert:kp,shadow_frag:Hp,sprite_vert:Gp,sprite_frag:Vp},ft={common:{diffuse:{value:new Ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new _t},alphaMap:{value:null},alphaMapTransform:{value:new _t},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new _t}},envmap:{envMap:{value:null},envMapRotation:{value:new _t},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new _t}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new _t}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new _t},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new _t},normalScale:{value:new Vt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new _t},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new _t}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new _t}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new _t}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new _t},alphaTest:{value:0},uvTransform:{value:new _t}},sprite:{diffuse:{value:new Ut(16777215)},opacity:{value:1},center:{value:new Vt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new _t},alphaMap:{value:null},alphaMapTransform:{value:new _t},alphaTest:{value:0}}},Mn={basic:{uniforms:_e([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Bt.meshbasic_vert,fragmentShader:Bt.meshbasic_frag},lambert:{uniforms:_e([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},envMapIntensity:{value:1}}]),vertexShader:Bt.meshlambert_vert,fragmentShader:Bt.meshlambert_frag},phong:{uniforms:_e([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},specular:{value:new Ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphong_vert,fragmentShader:Bt.meshphong_frag},standard:{uniforms:_e([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag},toon:{uniforms:_e([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new Ut(0)}}]),vertexShader:Bt.meshtoon_vert,fragmentShader:Bt.meshtoon_frag},matcap:{uniforms:_e([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Bt.meshmatcap_vert,fragmentShader:Bt.meshmatcap_frag},points:{uniforms:_e([ft.points,ft.fog]),vertexShader:Bt.points_vert,fragmentShader:Bt.points_frag},dashed:{uniforms:_e([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Bt.linedashed_vert,fragmentShader:Bt.linedashed_frag},depth:{uniforms:_e([ft.common,ft.displacementmap]),vertexShader:Bt.depth_vert,fragmentShader:Bt.depth_frag},normal:{uniforms:_e([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Bt.meshnormal_vert,fragmentShader:Bt.meshnormal_frag},sprite:{uniforms:_e([ft.sprite,ft.fog]),vertexShader:Bt.sprite_vert,fragmentShader:Bt.sprite_frag},background:{uniforms:{uvTransform:{value:new _t},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Bt.background_vert,fragmentShader:Bt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new _t}},vertexShader:Bt.backgroundCube_vert,fragmentShader:Bt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Bt.cube_vert,fragmentShader:Bt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Bt.equirect_vert,fragmentShader:Bt.equirect_frag},distance:{uniforms:_e([ft.common,ft.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Bt.distance_vert,fragmentShader:Bt.distance_frag},shadow:{uniforms:_e([ft.lights,ft.fog,{color:{value:new Ut(0)},opacity:{value:1}}]),vertexShader:Bt.shadow_vert,fragmentShader:Bt.shadow_frag}};Mn.physical={uniforms:_e([Mn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new _t},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new _t},clearcoatNormalScale:{value:new Vt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new _t},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new _t},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new _t},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new _t},sheen:{value:0},sheenColor:{value:new Ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new _t},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new _t},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new _t},transmissionSamplerSize:{value:new Vt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new _t},attenuationDistance:{value:0},attenuationColor:{value:new Ut(0)},specularColor:{value:new Ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new _t},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new _t},anisotropyVector:{value:new Vt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new _t}}]),vertexShader:Bt.meshphysical_vert,fragmentShader:Bt.meshphysical_frag};var za={r:0,b:0,g:0},Wp=new Qt,Bh=new _t;Bh.set(-1,0,0,0,1,0,0,0,1);function Xp(i,t,e,n,s,r){let a=new Ut(0),o=s===!0?0:1,c,l,h=null,f=0,d=null;function m(S){let A=S.isScene===!0?S.background:null;if(A&&A.isTexture){let T=S.backgroundBlurriness>0;A=t.get(A,T)}return A}function g(S){let A=!1,T=m(S);T===null?p(a,o):T&&T.isColor&&(p(T,1),A=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function M(S,A){let T=m(A);T&&T.isCubeTexture?(l===void 0&&(l=new pe(new Dn(1,1,1),new gn({name:"BackgroundCubeMaterial",uniforms:mi(Mn.backgroundCube.uniforms),vertexShader:Mn.backgroundCube.vertexShader,fragmentShader:Mn.backgroundCube.fragmentShader,side:Ne,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(R,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=T,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Wp.makeRotationFromEuler(A.backgroundRotation)).transpose(),T.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Bh),l.material.toneMapped=Gt.getTransfer(T.colorSpace)!==qt,(h!==T||f!==T.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=T,f=T.version,d=i.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null)):T&&T.isTexture&&(c===void 0&&(c=new pe(new hi(2,2),new gn({name:"BackgroundMaterial",uniforms:mi(Mn.background.uniforms),vertexShader:Mn.background.vertexShader,fragmentShader:Mn.background.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=T,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Gt.getTransfer(T.colorSpace)!==qt,T.matrixAutoUpdate===!0&&T.updateMatrix(),c.material.uniforms.uvTransform.value.copy(T.matrix),(h!==T||f!==T.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=T,f=T.version,d=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function p(S,A){S.getRGB(za,dl(i)),e.buffers.color.setClear(za.r,za.g,za.b,A,r)}function u(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,A=1){a.set(S),o=A,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(S){o=S,p(a,o)},render:g,addToRenderList:M,dispose:u}}function Yp(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,a=!1;function o(D,B,V,P,G){let Y=!1,H=f(D,P,V,B);r!==H&&(r=H,l(r.object)),Y=m(D,P,V,G),Y&&g(D,P,V,G),G!==null&&t.update(G,i.ELEMENT_ARRAY_BUFFER),(Y||a)&&(a=!1,T(D,B,V,P),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function c(){return i.createVertexArray()}function l(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function f(D,B,V,P){let G=P.wireframe===!0,Y=n[B.id];Y===void 0&&(Y={},n[B.id]=Y);let H=D.isInstancedMesh===!0?D.id:0,et=Y[H];et===void 0&&(et={},Y[H]=et);let X=et[V.id];X===void 0&&(X={},et[V.id]=X);let Q=X[G];return Q===void 0&&(Q=d(c()),X[G]=Q),Q}function d(D){let B=[],V=[],P=[];for(let G=0;G<e;G++)B[G]=0,V[G]=0,P[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:V,attributeDivisors:P,object:D,attributes:{},index:null}}function m(D,B,V,P){let G=r.attributes,Y=B.attributes,H=0,et=V.getAttributes();for(let X in et)if(et[X].location>=0){let $=G[X],St=Y[X];if(St===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(St=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(St=D.instanceColor)),$===void 0||$.attribute!==St||St&&$.data!==St.data)return!0;H++}return r.attributesNum!==H||r.index!==P}function g(D,B,V,P){let G={},Y=B.attributes,H=0,et=V.getAttributes();for(let X in et)if(et[X].location>=0){let $=Y[X];$===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&($=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&($=D.instanceColor));let St={};St.attribute=$,$&&$.data&&(St.data=$.data),G[X]=St,H++}r.attributes=G,r.attributesNum=H,r.index=P}function M(){let D=r.newAttributes;for(let B=0,V=D.length;B<V;B++)D[B]=0}function p(D){u(D,0)}function u(D,B){let V=r.newAttributes,P=r.enabledAttributes,G=r.attributeDivisors;V[D]=1,P[D]===0&&(i.enableVertexAttribArray(D),P[D]=1),G[D]!==B&&(i.vertexAttribDivisor(D,B),G[D]=B)}function S(){let D=r.newAttributes,B=r.enabledAttributes;for(let V=0,P=B.length;V<P;V++)B[V]!==D[V]&&(i.disableVertexAttribArray(V),B[V]=0)}function A(D,B,V,P,G,Y,H){H===!0?i.vertexAttribIPointer(D,B,V,G,Y):i.vertexAttribPointer(D,B,V,P,G,Y)}function T(D,B,V,P){M();let G=P.attributes,Y=V.getAttributes(),H=B.defaultAttributeValues;for(let et in Y){let X=Y[et];if(X.location>=0){let Q=G[et];if(Q===void 0&&(et==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),et==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let $=Q.normalized,St=Q.itemSize,Lt=t.get(Q);if(Lt===void 0)continue;let J=Lt.buffer,pt=Lt.type,vt=Lt.bytesPerElement,Et=pt===i.INT||pt===i.UNSIGNED_INT||Q.gpuType===na;if(Q.isInterleavedBufferAttribute){let mt=Q.data,Nt=mt.isInterleavedBuffer===!0?mt.stride:mt.itemSize,le=Q.offset;if(mt.isInstancedInterleavedBuffer||mt.isInstancedBufferAttribute){for(let Ct=0;Ct<X.locationSize;Ct++)u(X.location+Ct,mt.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=mt.meshPerAttribute*mt.count)}else for(let Ct=0;Ct<X.locationSize;Ct++)p(X.location+Ct);i.bindBuffer(i.ARRAY_BUFFER,J);for(let Ct=0;Ct<X.locationSize;Ct++)A(X.location+Ct,St/X.locationSize,pt,$,Nt*vt,(le+St/X.locationSize*Ct)*vt,Et)}else{if(Q.isInstancedBufferAttribute){for(let mt=0;mt<X.locationSize;mt++)u(X.location+mt,Q.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let mt=0;mt<X.locationSize;mt++)p(X.location+mt);i.bindBuffer(i.ARRAY_BUFFER,J);for(let mt=0;mt<X.locationSize;mt++)A(X.location+mt,St/X.locationSize,pt,$,St*vt,St/X.locationSize*mt*vt,Et)}}else if(H!==void 0){let $=H[et];if($!==void 0)switch($.length){case 2:i.vertexAttrib2fv(X.location,$);break;case 3:i.vertexAttrib3fv(X.location,$);break;case 4:i.vertexAttrib4fv(X.location,$);break;default:i.vertexAttrib1fv(X.location,$)}}}}S()}function R(){N();for(let D in n){let B=n[D];for(let V in B){let P=B[V];for(let G in P){let Y=P[G];for(let H in Y)h(Y[H].object),delete Y[H];delete P[G]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let B=n[D.id];for(let V in B){let P=B[V];for(let G in P){let Y=P[G];for(let H in Y)h(Y[H].object),delete Y[H];delete P[G]}}delete n[D.id]}function x(D){for(let B in n){let V=n[B];for(let P in V){let G=V[P];if(G[D.id]===void 0)continue;let Y=G[D.id];for(let H in Y)h(Y[H].object),delete Y[H];delete G[D.id]}}}function b(D){for(let B in n){let V=n[B],P=D.isInstancedMesh===!0?D.id:0,G=V[P];if(G!==void 0){for(let Y in G){let H=G[Y];for(let et in H)h(H[et].object),delete H[et];delete G[Y]}delete V[P],Object.keys(V).length===0&&delete n[B]}}}function N(){I(),a=!0,r!==s&&(r=s,l(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:N,resetDefaultState:I,dispose:R,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:M,enableAttribute:p,disableUnusedAttributes:S}}function qp(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function a(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function o(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let m=0;m<h;m++)d+=l[m];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Zp(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==cn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let b=x===ln&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==Be&&x!==on&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Rt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Rt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Rt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),u=i.getParameter(i.MAX_VERTEX_ATTRIBS),S=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),T=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:a,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:p,maxAttributes:u,maxVertexUniforms:S,maxVaryings:A,maxFragmentUniforms:T,maxSamples:R,samples:E}}function Jp(i){let t=this,e=null,n=0,s=!1,r=!1,a=new rn,o=new _t,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,d){let m=f.length!==0||d||n!==0||s;return s=d,n=f.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,d){e=h(f,d,0)},this.setState=function(f,d,m){let g=f.clippingPlanes,M=f.clipIntersection,p=f.clipShadows,u=i.get(f);if(!s||g===null||g.length===0||r&&!p)r?h(null):l();else{let S=r?0:n,A=S*4,T=u.clippingState||null;c.value=T,T=h(g,d,A,m);for(let R=0;R!==A;++R)T[R]=e[R];u.clippingState=T,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=S}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(f,d,m,g){let M=f!==null?f.length:0,p=null;if(M!==0){if(p=c.value,g!==!0||p===null){let u=m+M*4,S=d.matrixWorldInverse;o.getNormalMatrix(S),(p===null||p.length<u)&&(p=new Float32Array(u));for(let A=0,T=m;A!==M;++A,T+=4)a.copy(f[A]).applyMatrix4(S,o),a.normal.toArray(p,T),p[T+3]=a.constant}c.value=p,c.needsUpdate=!0}return t.numPlanes=M,t.numIntersection=0,p}}var Os=class extends Ve{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ds(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Dn(5,5,5),r=new gn({name:"CubemapFromEquirect",uniforms:mi(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ne,blending:ui});r.uniforms.tEquirect.value=e;let a=new pe(s,r),o=e.minFilter;return e.minFilter===Nn&&(e.minFilter=De),new ki(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(r)}},gh=256,Kp=3,jp=20,zh=256,kh=16,Qp=3,$p=new U,tm=new Ut,Ha=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ki(1,10,null),this._boxMesh=new pe(new Dn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:a=256,position:o=$p}=r,c=this._renderer;this._setSize(a);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let f=c.autoClear,d=c.autoClearColor,m=c.autoClearDepth,g=c.autoClearStencil,M=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,M===null&&(t.background=c.getClearColor(tm));let p=new ki(n,s,h);return p.position.copy(o),p.update(c,t),c.autoClear=f,c.autoClearColor=d,c.autoClearDepth=m,c.autoClearStencil=g,t.background=M,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(gh,uh(t))}_fromTexture(t,e){t.mapping===fi||t.mapping===Vi?this._setSize(t.image.length===0?gh:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=xh(t,!1,!1),n=Math.log2(t)-Kp;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=xh(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===fi||t.mapping===Vi?(this._cubemapMaterial===null&&(this._cubemapMaterial=yh()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vh()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=em(),this._integrationMaterial=nm());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/kh);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-Qp)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let c=o>0?Math.log2(e)+.5*Math.log2(6/(zh*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=c,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=im());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function xh(i,t,e){return new Os(i,{minFilter:Nn,generateMipmaps:t,type:ln,colorSpace:is,depthBuffer:e})}function Bs(i,t,e){return new gn({name:i,uniforms:t,vertexShader:Bt.cube_vert,fragmentShader:e,side:Ne,blending:ui,depthTest:!1,depthWrite:!1})}function em(){return Bs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

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
	`)}function sm(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?a(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===$r||m===ta)if(t.has(d)){let g=t.get(d).texture;return o(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let M=new Os(g.height);return M.fromEquirectangularTexture(i,d),t.set(d,M),d.addEventListener("dispose",l),o(M.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===$r||m===ta,M=m===fi||m===Vi;if(g||M){let p=e.get(d),u=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==u)return n===null&&(n=new Ha(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),p.texture;if(p!==void 0)return p.texture;{let S=d.image;return g&&S&&S.height>0||M&&S&&c(S)?(n===null&&(n=new Ha(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,e.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function o(d,m){return m===$r?d.mapping=fi:m===ta&&(d.mapping=Vi),d}function c(d){let m=0,g=6;for(let M=0;M<g;M++)d[M]!==void 0&&m++;return m===g}function l(d){let m=d.target;m.removeEventListener("dispose",l);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function rm(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&es("WebGLRenderer: "+n+" extension not supported."),s}}}function am(i,t,e,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let M=r.get(g);M&&(t.remove(M),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,M){return s[M.id]!==void 0||(M.addEventListener("dispose",o),s[M.id]=new WeakRef(M),a.register(M,M.id,M),e.memory.geometries++),M}function h(g){let M=g.attributes;for(let p in M)t.update(M[p],i.ARRAY_BUFFER)}function f(g){let M=g.index,p=g.attributes.position,u=0;if(p===void 0)return;let S=M!==null?M.array.length:p.array.length/3-1,A=p.count>=65535?hs:cs,T=new A(Math.ceil(S/3)*6,1),R=T.array;if(M!==null){let x=M.array;u=M.version;for(let b=0,N=0;b<S;b+=3){let I=x[b+0],D=x[b+1],B=x[b+2];R[N++]=I,R[N++]=D,R[N++]=D,R[N++]=B,R[N++]=B,R[N++]=I}}else{u=p.version;for(let x=0,b=0;x<S;x+=3){let N=x+0,I=x+1,D=x+2;R[b++]=N,R[b++]=I,R[b++]=I,R[b++]=D,R[b++]=D,R[b++]=N}}T.version=u;let E=r.get(g);E&&t.remove(E),r.set(g,T)}function d(g){let M=r.get(g);if(M){let p=g.index;p!==null&&M.version<p.version&&f(g)}else f(g);return r.get(g)}function m(){for(let g in s){let M=s[g].deref();M!==void 0&&c(M)}}return{get:l,update:h,getWireframeAttribute:d,dispose:m}}function om(i,t,e){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function c(f,d){i.drawElements(n,d,r,f*a),e.update(d,n,1)}function l(f,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,f*a,m),e.update(d,n,m))}function h(f,d,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,m);let M=0;for(let p=0;p<m;p++)M+=d[p];e.update(M,n,1)}this.setMode=s,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function lm(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:Pt("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function cm(i,t,e){let n=new WeakMap,s=new se;function r(a,o,c){let l=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=h!==void 0?h.length:0,d=n.get(o);if(d===void 0||d.count!==f){let N=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",N)};d!==void 0&&d.texture.dispose();let m=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,M=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],u=o.morphAttributes.normal||[],S=o.morphAttributes.color||[],A=0;m===!0&&(A=1),g===!0&&(A=2),M===!0&&(A=3);let T=o.attributes.position.count*A,R=1;T>t.maxTextureSize&&(R=Math.ceil(T/t.maxTextureSize),T=t.maxTextureSize);let E=new Float32Array(T*R*4*f),x=new as(E,T,R,f);x.type=on,x.needsUpdate=!0;let b=A*4;for(let I=0;I<f;I++){let D=p[I],B=u[I],V=S[I],P=T*R*4*I;for(let G=0;G<D.count;G++){let Y=G*b;m===!0&&(s.fromBufferAttribute(D,G),E[P+Y+0]=s.x,E[P+Y+1]=s.y,E[P+Y+2]=s.z,E[P+Y+3]=0),g===!0&&(s.fromBufferAttribute(B,G),E[P+Y+4]=s.x,E[P+Y+5]=s.y,E[P+Y+6]=s.z,E[P+Y+7]=0),M===!0&&(s.fromBufferAttribute(V,G),E[P+Y+8]=s.x,E[P+Y+9]=s.y,E[P+Y+10]=s.z,E[P+Y+11]=V.itemSize===4?s.w:1)}}d={count:f,texture:x,size:new Vt(T,R)},n.set(o,d),o.addEventListener("dispose",N)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let m=0;for(let M=0;M<l.length;M++)m+=l[M];let g=o.morphTargetsRelative?1:1-m;c.getUniforms().setValue(i,"morphTargetBaseInfluence",g),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function hm(i,t,e,n,s){let r=new WeakMap;function a(l){let h=s.render.frame,f=l.geometry,d=t.get(l,f);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let m=l.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function o(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var um={[Xo]:"LINEAR_TONE_MAPPING",[Yo]:"REINHARD_TONE_MAPPING",[qo]:"CINEON_TONE_MAPPING",[Zo]:"ACES_FILMIC_TONE_MAPPING",[Ko]:"AGX_TONE_MAPPING",[jo]:"NEUTRAL_TONE_MAPPING",[Jo]:"CUSTOM_TONE_MAPPING"};function dm(i,t,e,n,s,r){let a=new Ve(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,c=null,l=null,h=new Pe;h.setAttribute("position",new te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new te([0,2,0,0,2,0],2));let f=new Or({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new pe(h,f),m=new Ts(-1,1,1,-1,0,1),g=null,M=null,p=!1,u,S=null,A=[],T=!1;this.setSize=function(R,E){a.setSize(R,E),o!==null&&o.setSize(R,E),c!==null&&c.setSize(R,E);for(let x=0;x<A.length;x++){let b=A[x];b.setSize&&b.setSize(R,E)}},this.setEffects=function(R){A=R,T=A.length>0&&A[0].isRenderPass===!0;let E=a.width,x=a.height;A.length>0&&o===null&&(o=new Ve(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}),c=new Ve(E,x,{type:ln,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(N=>N.needsDepthTexture===!0);b!==(a.depthTexture!==null)&&(b===!0&&l===null&&(l=new Ln(E,x),r===!0&&(l.format=Un,l.type=pi)),a.dispose(),a.depthTexture=b?l:null,a.resolveDepthBuffer=b,a.storeMultisampledDepthBuffer=b);for(let N=0;N<A.length;N++){let I=A[N];I.setSize&&I.setSize(E,x),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(l)}},this.begin=function(R,E){if(p||R.toneMapping===vn&&A.length===0)return!1;if(S=E,E!==null){let x=E.width,b=E.height;(a.width!==x||a.height!==b)&&this.setSize(x,b)}return T===!1&&R.setRenderTarget(a),u=R.toneMapping,R.toneMapping=vn,!0},this.hasRenderPass=function(){return T},this.end=function(R,E){R.toneMapping=u,p=!0;let x=a,b=o;for(let N=0;N<A.length;N++){let I=A[N];I.enabled!==!1&&(I.render(R,b,x,E),I.needsSwap!==!1&&(x=b,b=b===o?c:o))}if(g!==R.outputColorSpace||M!==R.toneMapping){g=R.outputColorSpace,M=R.toneMapping,f.defines={},Gt.getTransfer(g)===qt&&(f.defines.SRGB_TRANSFER="");let N=um[M];N&&(f.defines[N]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(S),R.render(d,m),S=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),c!==null&&c.dispose(),h.dispose(),f.dispose()}}var Hh=new Oe,Gh=new Ln(1,1),Vh=new fs(1),Wh=new as,Xh=new Lr,Yh=new ds,Mh=[],Sh=[],bh=new Float32Array(16),Th=new Float32Array(9),wh=new Float32Array(4);function Yi(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Mh[s];if(r===void 0&&(r=new Float32Array(s),Mh[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function me(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function ge(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Va(i,t){let e=Sh[t];e===void 0&&(e=new Int32Array(t),Sh[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function fm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function pm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2fv(this.addr,t),ge(e,t)}}function mm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(me(e,t))return;i.uniform3fv(this.addr,t),ge(e,t)}}function gm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4fv(this.addr,t),ge(e,t)}}function xm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;wh.set(n),i.uniformMatrix2fv(this.addr,!1,wh),ge(e,n)}}function vm(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;Th.set(n),i.uniformMatrix3fv(this.addr,!1,Th),ge(e,n)}}function ym(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(me(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),ge(e,t)}else{if(me(e,n))return;bh.set(n),i.uniformMatrix4fv(this.addr,!1,bh),ge(e,n)}}function Mm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Sm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2iv(this.addr,t),ge(e,t)}}function bm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3iv(this.addr,t),ge(e,t)}}function Tm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4iv(this.addr,t),ge(e,t)}}function wm(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Em(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(me(e,t))return;i.uniform2uiv(this.addr,t),ge(e,t)}}function Am(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(me(e,t))return;i.uniform3uiv(this.addr,t),ge(e,t)}}function Rm(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(me(e,t))return;i.uniform4uiv(this.addr,t),ge(e,t)}}function Wa(i){return i.version===0&&(i.compareFunction=ll,i.needsUpdate=!0),i}function Cm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Wa(Gh):r=Hh,e.setTexture2D(t||r,s)}function Pm(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Xh,s)}function _m(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Wa(Vh):r=Yh,e.setTextureCube(t||r,s)}function Im(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Wh,s)}function Lm(i){switch(i){case 5126:return fm;case 35664:return pm;case 35665:return mm;case 35666:return gm;case 35674:return xm;case 35675:return vm;case 35676:return ym;case 5124:case 35670:return Mm;case 35667:case 35671:return Sm;case 35668:case 35672:return bm;case 35669:case 35673:return Tm;case 5125:return wm;case 36294:return Em;case 36295:return Am;case 36296:return Rm;case 35678:case 36198:case 36298:case 36306:case 35682:return Cm;case 35679:case 36299:case 36307:return Pm;case 35680:case 36300:case 36308:case 36293:return _m;case 36289:case 36303:case 36311:case 36292:return Im}}function Dm(i,t){i.uniform1fv(this.addr,t)}function Nm(i,t){let e=Yi(t,this.size,2);i.uniform2fv(this.addr,e)}function Um(i,t){let e=Yi(t,this.size,3);i.uniform3fv(this.addr,e)}function Fm(i,t){let e=Yi(t,this.size,4);i.uniform4fv(this.addr,e)}function Om(i,t){let e=Yi(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Bm(i,t){let e=Yi(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function zm(i,t){let e=Yi(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function km(i,t){i.uniform1iv(this.addr,t)}function Hm(i,t){i.uniform2iv(this.addr,t)}function Gm(i,t){i.uniform3iv(this.addr,t)}function Vm(i,t){i.uniform4iv(this.addr,t)}function Wm(i,t){i.uniform1uiv(this.addr,t)}function Xm(i,t){i.uniform2uiv(this.addr,t)}function Ym(i,t){i.uniform3uiv(this.addr,t)}function qm(i,t){i.uniform4uiv(this.addr,t)}function Zm(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Wa(Gh):a=Hh;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function Jm(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||Xh,r[a])}function Km(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Wa(Vh):a=Yh;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function jm(i,t,e){let n=this.cache,s=t.length,r=Va(e,s);me(n,r)||(i.uniform1iv(this.addr,r),ge(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||Wh,r[a])}function Qm(i){switch(i){case 5126:return Dm;case 35664:return Nm;case 35665:return Um;case 35666:return Fm;case 35674:return Om;case 35675:return Bm;case 35676:return zm;case 5124:case 35670:return km;case 35667:case 35671:return Hm;case 35668:case 35672:return Gm;case 35669:case 35673:return Vm;case 5125:return Wm;case 36294:return Xm;case 36295:return Ym;case 36296:return qm;case 35678:case 36198:case 36298:case 36306:case 35682:return Zm;case 35679:case 36299:case 36307:return Jm;case 35680:case 36300:case 36308:case 36293:return Km;case 36289:case 36303:case 36311:case 36292:return jm}}var vl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Lm(e.type)}},yl=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Qm(e.type)}},Ml=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],n)}}},gl=/(\w+)(\])?(\[|\.)?/g;function Eh(i,t){i.seq.push(t),i.map[t.id]=t}function $m(i,t,e){let n=i.name,s=n.length;for(gl.lastIndex=0;;){let r=gl.exec(n),a=gl.lastIndex,o=r[1],c=r[2]==="]",l=r[3];if(c&&(o=o|0),l===void 0||l==="["&&a+2===s){Eh(e,l===void 0?new vl(o,i,t):new yl(o,i,t));break}else{let f=e.map[o];f===void 0&&(f=new Ml(o),Eh(e,f)),e=f}}}var Xi=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=t.getActiveUniform(e,a),c=t.getUniformLocation(e,o.name);$m(o,c,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],c=n[o.id];c.needsUpdate!==!1&&o.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&n.push(a)}return n}};function Ah(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var tg=37297,eg=0;function ng(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}var Rh=new _t;function ig(i){Gt._getMatrix(Rh,Gt.workingColorSpace,i);let t=`mat3( ${Rh.elements.map(e=>e.toFixed(4))} )`;switch(Gt.getTransfer(i)){case ss:return[t,"LinearTransferOETF"];case qt:return[t,"sRGBTransferOETF"];default:return Rt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Ch(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+ng(i.getShaderSource(t),o)}else return r}function sg(i,t){let e=ig(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rg={[Xo]:"Linear",[Yo]:"Reinhard",[qo]:"Cineon",[Zo]:"ACESFilmic",[Ko]:"AgX",[jo]:"Neutral",[Jo]:"Custom"};function ag(i,t){let e=rg[t];return e===void 0?(Rt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ka=new U;function og(){Gt.getLuminanceCoefficients(ka);let i=ka.x.toFixed(4),t=ka.y.toFixed(4),e=ka.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lg(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fs).join(`
`)}function cg(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function hg(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function Fs(i){return i!==""}function Ph(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function _h(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var ug=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sl(i){return i.replace(ug,dg)}function dg(i,t){let e=Bt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Sl(e)}var fg=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ih(i){return i.replace(fg,pg)}function pg(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Lh(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}var mg={[As]:"SHADOWMAP_TYPE_PCF",[Hi]:"SHADOWMAP_TYPE_VSM"};function gg(i){return mg[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var xg={[Vi]:"ENVMAP_MODE_REFRACTION"};function vg(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":xg[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yg={[Qr]:"ENVMAP_BLENDING_MULTIPLY",[Jc]:"ENVMAP_BLENDING_MIX",[Kc]:"ENVMAP_BLENDING_ADD"};function Mg(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":yg[i.combine]||"ENVMAP_BLENDING_NONE"}function Sg(i,t,e,n){let s=i.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,c=gg(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=vg(e),f=Mg(e),d=lg(e),m=cg(r),g=s.createProgram(),M,p,u=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(M=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Fs).join(`
`),M.length>0&&(M+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Fs).join(`
`),p.length>0&&(p+=`
`)):(M=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fs).join(`
`),p=[Lh(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==vn?"#define TONE_MAPPING":"",e.toneMapping!==vn?Bt.tonemapping_pars_fragment:"",e.toneMapping!==vn?ag("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Bt.colorspace_pars_fragment,sg("linearToOutputTexel",e.outputColorSpace),og(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fs).join(`
`)),a=Sl(a),a=Ph(a,e),a=_h(a,e),o=Sl(o),o=Ph(o,e),o=_h(o,e),a=Ih(a),o=Ih(o),e.isRawShaderMaterial!==!0&&(u=`#version 300 es
`,M=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,p=["#define varying in",e.glslVersion===cl?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===cl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=u+M+a,A=u+p+o,T=Ah(s,s.VERTEX_SHADER,S),R=Ah(s,s.FRAGMENT_SHADER,A);s.attachShader(g,T),s.attachShader(g,R),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(I){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",B=s.getShaderInfoLog(T)||"",V=s.getShaderInfoLog(R)||"",P=D.trim(),G=B.trim(),Y=V.trim(),H=!0,et=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,T,R);else{let X=Ch(s,T,"vertex"),Q=Ch(s,R,"fragment");Pt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+P+`
`+X+`
`+Q)}else P!==""?Rt("WebGLProgram: Program Info Log:",P):(G===""||Y==="")&&(et=!1);et&&(I.diagnostics={runnable:H,programLog:P,vertexShader:{log:G,prefix:M},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(T),s.deleteShader(R),x=new Xi(s,g),b=hg(s,g)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(g,tg)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=eg++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=T,this.fragmentShader=R,this}var bg=0,bl=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Tl(t),e.set(t,n)),n}},Tl=class{constructor(t){this.id=bg++,this.code=t,this.usedTimes=0}};function Tg(i){return i===$n||i===Ls||i===Ds}function wg(i,t,e,n,s,r){let a=new os,o=new bl,c=new Set,l=[],h=new Map,f=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,b,N,I,D,B){let V=I.fog,P=D.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,H=t.get(x.envMap||G,Y),et=d[x.type],X=n.precision;x.precision!==null&&(X=n.getMaxPrecision(x.precision),X!==x.precision&&Rt("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let Q=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,$=Q!==void 0?Q.length:0,St=0;P.morphAttributes.position!==void 0&&(St=1),P.morphAttributes.normal!==void 0&&(St=2),P.morphAttributes.color!==void 0&&(St=3);let Lt,J,pt,vt;if(et){let dt=Mn[et];Lt=dt.vertexShader,J=dt.fragmentShader}else{Lt=x.vertexShader,J=x.fragmentShader;let dt=o.getVertexShaderStage(x),Jt=o.getFragmentShaderStage(x);o.update(x,dt,Jt),pt=dt.id,vt=Jt.id}let Et=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),Nt=D.isInstancedMesh===!0,le=D.isBatchedMesh===!0,Ct=!!x.map,Zt=!!x.matcap,Kt=!!H,zt=Kt&&H.isPMREMTexture===!0,be=!!x.aoMap,de=!!x.lightMap,Fe=!!x.bumpMap&&x.wireframe===!1,re=!!x.normalMap,un=!!x.displacementMap,xe=!!x.emissiveMap,Ye=!!x.metalnessMap,qe=!!x.roughnessMap,Ze=x.anisotropy>0,L=x.clearcoat>0,Je=x.diffuseRoughness>0,ne=x.dispersion>0,ie=x.retroreflectivity>0,ut=x.iridescence>0,fe=x.sheen>0,At=x.transmission>0,It=Ze&&!!x.anisotropyMap,w=L&&!!x.clearcoatMap,v=L&&!!x.clearcoatNormalMap,O=L&&!!x.clearcoatRoughnessMap,tt=Je&&!!x.diffuseRoughnessMap,j=ut&&!!x.iridescenceMap,st=ut&&!!x.iridescenceThicknessMap,ct=fe&&!!x.sheenColorMap,q=fe&&!!x.sheenRoughnessMap,Z=!!x.specularMap,at=!!x.specularColorMap,C=!!x.specularIntensityMap,K=At&&!!x.transmissionMap,W=At&&!!x.thicknessMap,ot=!!x.gradientMap,it=!!x.alphaMap,rt=x.alphaTest>0,Tt=!!x.alphaHash,Ot=!!x.extensions,nt=vn;x.toneMapped&&(Et===null||Et.isXRRenderTarget===!0)&&(nt=i.toneMapping);let wt=zt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Ft={shaderID:et,shaderType:x.type,shaderName:x.name,vertexShader:Lt,fragmentShader:J,defines:x.defines,customVertexShaderID:pt,customFragmentShaderID:vt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:le,batchingColor:le&&D._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&D.instanceColor!==null,instancingMorph:Nt&&D.morphTexture!==null,outputColorSpace:Et===null?i.outputColorSpace:Et.isXRRenderTarget===!0?Et.texture.colorSpace:Gt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ct,matcap:Zt,envMap:Kt,envMapMode:Kt&&H.mapping,envMapPMREM:zt,envMapMaxLod:zt?wt.length-1:null,envMapSize:zt?wt[0].width:null,aoMap:be,lightMap:de,bumpMap:Fe,normalMap:re,displacementMap:un,emissiveMap:xe,normalMapObjectSpace:re&&x.normalMapType===$c,normalMapTangentSpace:re&&x.normalMapType===Ba,packedNormalMap:re&&x.normalMapType===Ba&&Tg(x.normalMap.format),metalnessMap:Ye,roughnessMap:qe,anisotropy:Ze,anisotropyMap:It,clearcoat:L,clearcoatMap:w,clearcoatNormalMap:v,clearcoatRoughnessMap:O,diffuseRoughness:Je,diffuseRoughnessMap:tt,dispersion:ne,retroreflection:ie,iridescence:ut,iridescenceMap:j,iridescenceThicknessMap:st,sheen:fe,sheenColorMap:ct,sheenRoughnessMap:q,specularMap:Z,specularColorMap:at,specularIntensityMap:C,transmission:At,transmissionMap:K,thicknessMap:W,gradientMap:ot,opaque:x.transparent===!1&&x.blending===Gi&&x.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:Tt,combine:x.combine,mapUv:Ct&&m(x.map.channel),aoMapUv:be&&m(x.aoMap.channel),lightMapUv:de&&m(x.lightMap.channel),bumpMapUv:Fe&&m(x.bumpMap.channel),normalMapUv:re&&m(x.normalMap.channel),displacementMapUv:un&&m(x.displacementMap.channel),emissiveMapUv:xe&&m(x.emissiveMap.channel),metalnessMapUv:Ye&&m(x.metalnessMap.channel),roughnessMapUv:qe&&m(x.roughnessMap.channel),anisotropyMapUv:It&&m(x.anisotropyMap.channel),clearcoatMapUv:w&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:j&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:st&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:q&&m(x.sheenRoughnessMap.channel),specularMapUv:Z&&m(x.specularMap.channel),specularColorMapUv:at&&m(x.specularColorMap.channel),specularIntensityMapUv:C&&m(x.specularIntensityMap.channel),transmissionMapUv:K&&m(x.transmissionMap.channel),thicknessMapUv:W&&m(x.thicknessMap.channel),alphaMapUv:it&&m(x.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(re||Ze),vertexNormals:!!P.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!P.attributes.uv&&(Ct||it),fog:!!V,useFog:x.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||P.attributes.normal===void 0&&re===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:mt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:St,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:B.filter(dt=>dt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Ct&&x.map.isVideoTexture===!0&&Gt.getTransfer(x.map.colorSpace)===qt,decodeVideoTextureEmissive:xe&&x.emissiveMap.isVideoTexture===!0&&Gt.getTransfer(x.emissiveMap.colorSpace)===qt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===xn,flipSided:x.side===Ne,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ot&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ot&&x.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Ft.vertexUv1s=c.has(1),Ft.vertexUv2s=c.has(2),Ft.vertexUv3s=c.has(3),c.clear(),Ft}function M(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let N in x.defines)b.push(N),b.push(x.defines[N]);return x.isRawShaderMaterial===!1&&(p(b,x),u(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function p(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function u(x,b){a.disableAll(),b.instancing&&a.enable(0),b.instancingColor&&a.enable(1),b.instancingMorph&&a.enable(2),b.matcap&&a.enable(3),b.envMap&&a.enable(4),b.normalMapObjectSpace&&a.enable(5),b.normalMapTangentSpace&&a.enable(6),b.clearcoat&&a.enable(7),b.iridescence&&a.enable(8),b.alphaTest&&a.enable(9),b.vertexColors&&a.enable(10),b.vertexAlphas&&a.enable(11),b.vertexUv1s&&a.enable(12),b.vertexUv2s&&a.enable(13),b.vertexUv3s&&a.enable(14),b.vertexTangents&&a.enable(15),b.anisotropy&&a.enable(16),b.alphaHash&&a.enable(17),b.batching&&a.enable(18),b.dispersion&&a.enable(19),b.retroreflection&&a.enable(24),b.diffuseRoughness&&a.enable(25),b.batchingColor&&a.enable(20),b.gradientMap&&a.enable(21),b.packedNormalMap&&a.enable(22),b.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),b.numLightProbeGrids>0&&a.enable(22),b.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function S(x){let b=d[x.type],N;if(b){let I=Mn[b];N=fh.clone(I.uniforms)}else N=x.uniforms;return N}function A(x,b){let N=h.get(b);return N!==void 0?++N.usedTimes:(N=new Sg(i,b,x,s),l.push(N),h.set(b,N)),N}function T(x){if(--x.usedTimes===0){let b=l.indexOf(x);l[b]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function R(x){o.remove(x)}function E(){o.dispose()}return{getParameters:g,getProgramCacheKey:M,getUniforms:S,acquireProgram:A,releaseProgram:T,releaseShaderCache:R,programs:l,dispose:E}}function Eg(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,c){i.get(a)[o]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Ag(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Dh(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Nh(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function o(d,m,g,M,p,u){let S=i[t];return S===void 0?(S={id:d.id,object:d,geometry:m,material:g,materialVariant:a(d),groupOrder:M,renderOrder:d.renderOrder,z:p,group:u},i[t]=S):(S.id=d.id,S.object=d,S.geometry=m,S.material=g,S.materialVariant=a(d),S.groupOrder=M,S.renderOrder=d.renderOrder,S.z=p,S.group=u),t++,S}function c(d,m,g,M,p,u,S){S.reversedDepth===!0&&(p=-p);let A=o(d,m,g,M,p,u);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):e.push(A)}function l(d,m,g,M,p,u){let S=o(d,m,g,M,p,u);g.transmission>0?n.unshift(S):g.transparent===!0?s.unshift(S):e.unshift(S)}function h(d,m){e.length>1&&e.sort(d||Ag),n.length>1&&n.sort(m||Dh),s.length>1&&s.sort(m||Dh)}function f(){for(let d=t,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:f,sort:h}}function Rg(){let i=new WeakMap;function t(n,s){let r=i.get(n),a;return r===void 0?(a=new Nh,i.set(n,[a])):s>=r.length?(a=new Nh,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function Cg(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new U,color:new Ut};break;case"SpotLight":e={position:new U,direction:new U,color:new Ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new U,color:new Ut,distance:0,decay:0};break;case"HemisphereLight":e={direction:new U,skyColor:new Ut,groundColor:new Ut};break;case"RectAreaLight":e={color:new Ut,position:new U,halfWidth:new U,halfHeight:new U};break}return i[t.id]=e,e}}}function Pg(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var _g=0;function Ig(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Lg(i){let t=new Cg,e=Pg(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new U);let s=new U,r=new Qt,a=new Qt;function o(l){let h=0,f=0,d=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let m=0,g=0,M=0,p=0,u=0,S=0,A=0,T=0,R=0,E=0,x=0,b=0,N=0,I=0;l.sort(Ig);for(let B=0,V=l.length;B<V;B++){let P=l[B],G=P.color,Y=P.intensity,H=P.distance,et=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===$n?et=P.shadow.map.texture:et=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=G.r*Y,f+=G.g*Y,d+=G.b*Y;else if(P.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(P.sh.coefficients[X],Y);I++}else if(P.isSunLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,$=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=$,n.sunShadowMap[g]=et;let St=Q.getViewportCount();for(let Lt=0;Lt<St;Lt++)n.sunShadowMatrix[M+Lt]=Q.getMatrix(Lt),n.sunShadowCascade[M+Lt]=Q._cascadeData[Lt];M+=St,g++}n.sun[m]=X,m++}else if(P.isDirectionalLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,$=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.directionalShadow[p]=$,n.directionalShadowMap[p]=et,n.directionalShadowMatrix[p]=P.shadow.matrix,R++}n.directional[p]=X,p++}else if(P.isSpotLight){let X=t.get(P);X.position.setFromMatrixPosition(P.matrixWorld),X.color.copy(G).multiplyScalar(Y),X.distance=H,X.coneCos=Math.cos(P.angle),X.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),X.decay=P.decay,n.spot[S]=X;let Q=P.shadow;if(P.map&&(n.spotLightMap[b]=P.map,b++,Q.updateMatrices(P),P.castShadow&&N++),n.spotLightMatrix[S]=Q.matrix,P.castShadow){let $=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,n.spotShadow[S]=$,n.spotShadowMap[S]=et,x++}S++}else if(P.isRectAreaLight){let X=t.get(P);X.color.copy(G).multiplyScalar(Y),X.halfWidth.set(P.width*.5,0,0),X.halfHeight.set(0,P.height*.5,0),n.rectArea[A]=X,A++}else if(P.isPointLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),X.distance=P.distance,X.decay=P.decay,P.castShadow){let Q=P.shadow,$=e.get(P);$.shadowIntensity=Q.intensity,$.shadowBias=Q.bias,$.shadowNormalBias=Q.normalBias,$.shadowRadius=Q.radius,$.shadowMapSize=Q.mapSize,$.shadowCameraNear=Q.camera.near,$.shadowCameraFar=Q.camera.far,n.pointShadow[u]=$,n.pointShadowMap[u]=et,n.pointShadowMatrix[u]=P.shadow.matrix,E++}n.point[u]=X,u++}else if(P.isHemisphereLight){let X=t.get(P);X.skyColor.copy(P.color).multiplyScalar(Y),X.groundColor.copy(P.groundColor).multiplyScalar(Y),n.hemi[T]=X,T++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=d;let D=n.hash;(D.sunLength!==m||D.directionalLength!==p||D.pointLength!==u||D.spotLength!==S||D.rectAreaLength!==A||D.hemiLength!==T||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==E||D.numSpotShadows!==x||D.numSpotMaps!==b||D.numLightProbes!==I)&&(n.sun.length=m,n.directional.length=p,n.spot.length=S,n.rectArea.length=A,n.point.length=u,n.hemi.length=T,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=M,n.sunShadowCascade.length=M,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-N,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=I,D.sunLength=m,D.directionalLength=p,D.pointLength=u,D.spotLength=S,D.rectAreaLength=A,D.hemiLength=T,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=E,D.numSpotShadows=x,D.numSpotMaps=b,D.numLightProbes=I,n.version=_g++)}function c(l,h){let f=0,d=0,m=0,g=0,M=0,p=0,u=h.matrixWorldInverse;for(let S=0,A=l.length;S<A;S++){let T=l[S];if(T.isSunLight){let R=n.sun[f];R.direction.setFromMatrixPosition(T.matrixWorld),R.direction.transformDirection(u),f++}else if(T.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(u),d++}else if(T.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(u),R.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(u),g++}else if(T.isRectAreaLight){let R=n.rectArea[M];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(u),a.identity(),r.copy(T.matrixWorld),r.premultiply(u),a.extractRotation(r),R.halfWidth.set(T.width*.5,0,0),R.halfHeight.set(0,T.height*.5,0),R.halfWidth.applyMatrix4(a),R.halfHeight.applyMatrix4(a),M++}else if(T.isPointLight){let R=n.point[m];R.position.setFromMatrixPosition(T.matrixWorld),R.position.applyMatrix4(u),m++}else if(T.isHemisphereLight){let R=n.hemi[p];R.direction.setFromMatrixPosition(T.matrixWorld),R.direction.transformDirection(u),p++}}}return{setup:o,setupView:c,state:n}}function Uh(i){let t=new Lg(i),e=[],n=[],s=[];function r(f){h.camera=f,e.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):e.push(f)}function o(f){n.push(f)}function c(){t.setup(e),s.sort((f,d)=>f.priority-d.priority||f.id-d.id)}function l(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:a,pushShadow:o}}function Dg(i){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new Uh(i),t.set(s,[o])):r>=a.length?(o=new Uh(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}var Ng=`void main() {
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
}`,Fg=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],Og=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],Fh=new Qt,Us=new U,xl=new U;function Bg(i,t,e){let n=new qn,s=new Vt,r=new Vt,a=new se,o=new Br,c=new zr,l={},h=e.maxTextureSize,f={[Qn]:Ne,[Ne]:Qn,[xn]:xn},d=new gn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Vt},radius:{value:4}},vertexShader:Ng,fragmentShader:Ug}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new Pe;g.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new pe(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=As;let u=this.type;this.render=function(E,x,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;this.type===_c&&(Rt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=As);let N=i.getRenderTarget(),I=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ui),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=u!==this.type;V&&x.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(G=>G.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,G=E.length;P<G;P++){let Y=E[P],H=Y.shadow;if(H===void 0){Rt("WebGLShadowMap:",Y,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let et=H.getFrameExtents();s.multiply(et),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,H.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=X,H.map===null||V===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Hi){if(Y.isPointLight){Rt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Ve(s.x,s.y,{format:$n,type:ln,minFilter:De,magFilter:De,generateMipmaps:!1}),H.map.texture.name=Y.name+".shadowMap",H.map.depthTexture=new Ln(s.x,s.y,on),H.map.depthTexture.name=Y.name+".shadowMapDepth",H.map.depthTexture.format=Pn,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Se,H.map.depthTexture.magFilter=Se}else Y.isPointLight?(H.map=new Os(s.x),H.map.depthTexture=new fs(s.x,an)):(H.map=new Ve(s.x,s.y),H.map.depthTexture=new Ln(s.x,s.y,an)),H.map.depthTexture.name=Y.name+".shadowMap",H.map.depthTexture.format=Pn,this.type===As?(H.map.depthTexture.compareFunction=X?ol:al,H.map.depthTexture.minFilter=De,H.map.depthTexture.magFilter=De):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Se,H.map.depthTexture.magFilter=Se);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Y.isPointLight!==!0&&H.updateMatrices(Y,b);let $=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:b.layers;for(let St=0;St<Q;St++){let Lt=H.getCamera(St);if(Y.isPointLight){let J=H.camera,pt=H.matrix,vt=Y.distance||J.far;vt!==J.far&&(J.far=vt,J.updateProjectionMatrix()),Us.setFromMatrixPosition(Y.matrixWorld),J.position.copy(Us),xl.copy(J.position),xl.add(Fg[St]),J.up.copy(Og[St]),J.lookAt(xl),J.updateMatrixWorld(),pt.makeTranslation(-Us.x,-Us.y,-Us.z),Fh.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Fh,J.coordinateSystem,J.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,St),i.clear();else{St===0&&(i.setRenderTarget(H.map),i.clear());let J=H.getViewport(St);a.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),B.viewport(a)}n=H.getFrustum(St),T(x,b,Lt,Y,$,this.type)}H.isPointLightShadow!==!0&&this.type===Hi&&S(H,b),H.needsUpdate=!1}u=this.type,p.needsUpdate=!1,i.setRenderTarget(N,I,D)};function S(E,x){let b=t.update(M);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null?E.mapPass=new Ve(s.x,s.y,{format:$n,type:ln}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,d,M,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value.set(E.map.width,E.map.height),m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,m,M,null)}function A(E,x,b,N){let I=null,D=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)I=D;else if(I=b.isPointLight===!0?c:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=I.uuid,V=x.uuid,P=l[B];P===void 0&&(P={},l[B]=P);let G=P[V];G===void 0&&(G=I.clone(),P[V]=G,x.addEventListener("dispose",R)),I=G}if(I.visible=x.visible,I.wireframe=x.wireframe,N===Hi?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:f[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let B=i.properties.get(I);B.light=b}return I}function T(E,x,b,N,I,D){if(E.visible===!1)return;if(E.layers.test(I)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Hi)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let P=t.update(E),G=E.material;if(Array.isArray(G)){let Y=P.groups;for(let H=0,et=Y.length;H<et;H++){let X=Y[H],Q=G[X.materialIndex];if(Q&&Q.visible){let $=A(E,Q,N,D);E.onBeforeShadow(i,E,x,b,P,$,X),i.renderBufferDirect(b,null,P,$,E,X),E.onAfterShadow(i,E,x,b,P,$,X)}}}else if(G.visible){let Y=A(E,G,N,D);E.onBeforeShadow(i,E,x,b,P,Y,null),i.renderBufferDirect(b,null,P,Y,E,null),E.onAfterShadow(i,E,x,b,P,Y,null)}}let V=E.children;for(let P=0,G=V.length;P<G;P++)T(V[P],x,b,N,I,D)}function R(E){E.target.removeEventListener("dispose",R);for(let b in l){let N=l[b],I=E.target.uuid;I in N&&(N[I].dispose(),delete N[I])}}}function zg(i,t){function e(){let C=!1,K=new se,W=null,ot=new se(0,0,0,0);return{setMask:function(it){W!==it&&!C&&(i.colorMask(it,it,it,it),W=it)},setLocked:function(it){C=it},setClear:function(it,rt,Tt,Ot,nt){nt===!0&&(it*=Ot,rt*=Ot,Tt*=Ot),K.set(it,rt,Tt,Ot),ot.equals(K)===!1&&(i.clearColor(it,rt,Tt,Ot),ot.copy(K))},reset:function(){C=!1,W=null,ot.set(-1,0,0,0)}}}function n(){let C=!1,K=!1,W=null,ot=null,it=null;return{setReversed:function(rt){if(K!==rt){let Tt=t.get("EXT_clip_control");rt?Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.ZERO_TO_ONE_EXT):Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.NEGATIVE_ONE_TO_ONE_EXT),K=rt;let Ot=it;it=null,this.setClear(Ot)}},getReversed:function(){return K},setTest:function(rt){rt?mt(i.DEPTH_TEST):Nt(i.DEPTH_TEST)},setMask:function(rt){W!==rt&&!C&&(i.depthMask(rt),W=rt)},setFunc:function(rt){if(K&&(rt=hh[rt]),ot!==rt){switch(rt){case yr:i.depthFunc(i.NEVER);break;case Mr:i.depthFunc(i.ALWAYS);break;case Sr:i.depthFunc(i.LESS);break;case Ii:i.depthFunc(i.LEQUAL);break;case br:i.depthFunc(i.EQUAL);break;case Tr:i.depthFunc(i.GEQUAL);break;case wr:i.depthFunc(i.GREATER);break;case Er:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ot=rt}},setLocked:function(rt){C=rt},setClear:function(rt){it!==rt&&(it=rt,K&&(rt=1-rt),i.clearDepth(rt))},reset:function(){C=!1,W=null,ot=null,it=null,K=!1}}}function s(){let C=!1,K=null,W=null,ot=null,it=null,rt=null,Tt=null,Ot=null,nt=null;return{setTest:function(wt){C||(wt?mt(i.STENCIL_TEST):Nt(i.STENCIL_TEST))},setMask:function(wt){K!==wt&&!C&&(i.stencilMask(wt),K=wt)},setFunc:function(wt,Ft,dt){(W!==wt||ot!==Ft||it!==dt)&&(i.stencilFunc(wt,Ft,dt),W=wt,ot=Ft,it=dt)},setOp:function(wt,Ft,dt){(rt!==wt||Tt!==Ft||Ot!==dt)&&(i.stencilOp(wt,Ft,dt),rt=wt,Tt=Ft,Ot=dt)},setLocked:function(wt){C=wt},setClear:function(wt){nt!==wt&&(i.clearStencil(wt),nt=wt)},reset:function(){C=!1,K=null,W=null,ot=null,it=null,rt=null,Tt=null,Ot=null,nt=null}}}let r=new e,a=new n,o=new s,c={},l=new WeakMap,h={},f={},d={},m=new WeakMap,g=[],M=null,p=!1,u=null,S=null,A=null,T=null,R=null,E=null,x=null,b=new Ut(0,0,0),N=0,I=!1,D=null,B=null,V=null,P=null,G=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,et=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(X)[1]),H=et>=1):X.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),H=et>=2);let Q=null,$={},St=i.getParameter(i.SCISSOR_BOX),Lt=i.getParameter(i.VIEWPORT),J=new se().fromArray(St),pt=new se().fromArray(Lt);function vt(C,K,W,ot){let it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(C,rt),i.texParameteri(C,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(C,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Tt=0;Tt<W;Tt++)C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,ot,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+Tt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}let Et={};Et[i.TEXTURE_2D]=vt(i.TEXTURE_2D,i.TEXTURE_2D,1),Et[i.TEXTURE_CUBE_MAP]=vt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Et[i.TEXTURE_2D_ARRAY]=vt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Et[i.TEXTURE_3D]=vt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),mt(i.DEPTH_TEST),a.setFunc(Ii),Fe(!1),re(zo),mt(i.CULL_FACE),be(ui);function mt(C){h[C]!==!0&&(i.enable(C),h[C]=!0)}function Nt(C){h[C]!==!1&&(i.disable(C),h[C]=!1)}function le(C,K){return d[C]!==K?(i.bindFramebuffer(C,K),d[C]=K,C===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),C===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Ct(C,K){let W=g,ot=!1;if(C){W=m.get(K),W===void 0&&(W=[],m.set(K,W));let it=C.textures;if(W.length!==it.length||W[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,Tt=it.length;rt<Tt;rt++)W[rt]=i.COLOR_ATTACHMENT0+rt;W.length=it.length,ot=!0}}else W[0]!==i.BACK&&(W[0]=i.BACK,ot=!0);ot&&i.drawBuffers(W)}function Zt(C){return M!==C?(i.useProgram(C),M=C,!0):!1}let Kt={[di]:i.FUNC_ADD,[Lc]:i.FUNC_SUBTRACT,[Dc]:i.FUNC_REVERSE_SUBTRACT};Kt[Nc]=i.MIN,Kt[Uc]=i.MAX;let zt={[Fc]:i.ZERO,[Oc]:i.ONE,[Bc]:i.SRC_COLOR,[Vo]:i.SRC_ALPHA,[Wc]:i.SRC_ALPHA_SATURATE,[Gc]:i.DST_COLOR,[kc]:i.DST_ALPHA,[zc]:i.ONE_MINUS_SRC_COLOR,[Wo]:i.ONE_MINUS_SRC_ALPHA,[Vc]:i.ONE_MINUS_DST_COLOR,[Hc]:i.ONE_MINUS_DST_ALPHA,[Xc]:i.CONSTANT_COLOR,[Yc]:i.ONE_MINUS_CONSTANT_COLOR,[qc]:i.CONSTANT_ALPHA,[Zc]:i.ONE_MINUS_CONSTANT_ALPHA};function be(C,K,W,ot,it,rt,Tt,Ot,nt,wt){if(C===ui){p===!0&&(Nt(i.BLEND),p=!1);return}if(p===!1&&(mt(i.BLEND),p=!0),C!==Ic){if(C!==u||wt!==I){if((S!==di||R!==di)&&(i.blendEquation(i.FUNC_ADD),S=di,R=di),wt)switch(C){case Gi:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFunc(i.ONE,i.ONE);break;case Ho:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Go:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Pt("WebGLState: Invalid blending: ",C);break}else switch(C){case Gi:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Ho:Pt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Go:Pt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Pt("WebGLState: Invalid blending: ",C);break}A=null,T=null,E=null,x=null,b.set(0,0,0),N=0,u=C,I=wt}return}it=it||K,rt=rt||W,Tt=Tt||ot,(K!==S||it!==R)&&(i.blendEquationSeparate(Kt[K],Kt[it]),S=K,R=it),(W!==A||ot!==T||rt!==E||Tt!==x)&&(i.blendFuncSeparate(zt[W],zt[ot],zt[rt],zt[Tt]),A=W,T=ot,E=rt,x=Tt),(Ot.equals(b)===!1||nt!==N)&&(i.blendColor(Ot.r,Ot.g,Ot.b,nt),b.copy(Ot),N=nt),u=C,I=!1}function de(C,K){C.side===xn?Nt(i.CULL_FACE):mt(i.CULL_FACE);let W=C.side===Ne;K&&(W=!W),Fe(W),C.blending===Gi&&C.transparent===!1?be(ui):be(C.blending,C.blendEquation,C.blendSrc,C.blendDst,C.blendEquationAlpha,C.blendSrcAlpha,C.blendDstAlpha,C.blendColor,C.blendAlpha,C.premultipliedAlpha),a.setFunc(C.depthFunc),a.setTest(C.depthTest),a.setMask(C.depthWrite),r.setMask(C.colorWrite);let ot=C.stencilWrite;o.setTest(ot),ot&&(o.setMask(C.stencilWriteMask),o.setFunc(C.stencilFunc,C.stencilRef,C.stencilFuncMask),o.setOp(C.stencilFail,C.stencilZFail,C.stencilZPass)),xe(C.polygonOffset,C.polygonOffsetFactor,C.polygonOffsetUnits),C.alphaToCoverage===!0?mt(i.SAMPLE_ALPHA_TO_COVERAGE):Nt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Fe(C){D!==C&&(C?i.frontFace(i.CW):i.frontFace(i.CCW),D=C)}function re(C){C!==Cc?(mt(i.CULL_FACE),C!==B&&(C===zo?i.cullFace(i.BACK):C===Pc?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Nt(i.CULL_FACE),B=C}function un(C){C!==V&&(H&&i.lineWidth(C),V=C)}function xe(C,K,W){C?(mt(i.POLYGON_OFFSET_FILL),(P!==K||G!==W)&&(P=K,G=W,a.getReversed()&&(K=-K,W=-W),i.polygonOffset(K,W))):Nt(i.POLYGON_OFFSET_FILL)}function Ye(C){C?mt(i.SCISSOR_TEST):Nt(i.SCISSOR_TEST)}function qe(C){C===void 0&&(C=i.TEXTURE0+Y-1),Q!==C&&(i.activeTexture(C),Q=C)}function Ze(C,K,W){W===void 0&&(Q===null?W=i.TEXTURE0+Y-1:W=Q);let ot=$[W];ot===void 0&&(ot={type:void 0,texture:void 0},$[W]=ot),(ot.type!==C||ot.texture!==K)&&(Q!==W&&(i.activeTexture(W),Q=W),i.bindTexture(C,K||Et[C]),ot.type=C,ot.texture=K)}function L(){let C=$[Q];C!==void 0&&C.type!==void 0&&(i.bindTexture(C.type,null),C.type=void 0,C.texture=void 0)}function Je(){try{i.compressedTexImage2D(...arguments)}catch(C){Pt("WebGLState:",C)}}function ne(){try{i.compressedTexImage3D(...arguments)}catch(C){Pt("WebGLState:",C)}}function ie(){try{i.texSubImage2D(...arguments)}catch(C){Pt("WebGLState:",C)}}function ut(){try{i.texSubImage3D(...arguments)}catch(C){Pt("WebGLState:",C)}}function fe(){try{i.compressedTexSubImage2D(...arguments)}catch(C){Pt("WebGLState:",C)}}function At(){try{i.compressedTexSubImage3D(...arguments)}catch(C){Pt("WebGLState:",C)}}function It(){try{i.texStorage2D(...arguments)}catch(C){Pt("WebGLState:",C)}}function w(){try{i.texStorage3D(...arguments)}catch(C){Pt("WebGLState:",C)}}function v(){try{i.texImage2D(...arguments)}catch(C){Pt("WebGLState:",C)}}function O(){try{i.texImage3D(...arguments)}catch(C){Pt("WebGLState:",C)}}function tt(C){return f[C]!==void 0?f[C]:i.getParameter(C)}function j(C,K){f[C]!==K&&(i.pixelStorei(C,K),f[C]=K)}function st(C){J.equals(C)===!1&&(i.scissor(C.x,C.y,C.z,C.w),J.copy(C))}function ct(C){pt.equals(C)===!1&&(i.viewport(C.x,C.y,C.z,C.w),pt.copy(C))}function q(C,K){let W=l.get(K);W===void 0&&(W=new WeakMap,l.set(K,W));let ot=W.get(C);ot===void 0&&(ot=i.getUniformBlockIndex(K,C.name),i.uniformBlockBinding(K,ot,ot),W.set(C,ot))}function Z(C,K,W){let it=l.get(K).get(C);c[it]!==W&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,W),c[it]=W)}function at(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,$={},d={},c={},m=new WeakMap,g=[],M=null,p=!1,u=null,S=null,A=null,T=null,R=null,E=null,x=null,b=new Ut(0,0,0),N=0,I=!1,D=null,B=null,V=null,P=null,G=null,J.set(0,0,i.canvas.width,i.canvas.height),pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:mt,disable:Nt,bindFramebuffer:le,drawBuffers:Ct,useProgram:Zt,setBlending:be,setMaterial:de,setFlipSided:Fe,setCullFace:re,setLineWidth:un,setPolygonOffset:xe,setScissorTest:Ye,activeTexture:qe,bindTexture:Ze,unbindTexture:L,compressedTexImage2D:Je,compressedTexImage3D:ne,texImage2D:v,texImage3D:O,pixelStorei:j,getParameter:tt,updateUBOMapping:q,uniformBlockBinding:Z,texStorage2D:It,texStorage3D:w,texSubImage2D:ie,texSubImage3D:ut,compressedTexSubImage2D:fe,compressedTexSubImage3D:At,scissor:st,viewport:ct,reset:at}}function kg(i,t,e,n,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Vt,h=new WeakMap,f=new Set,d,m=new WeakMap,g=new Set,M=new FinalizationRegistry(w=>g.delete(w)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function u(w,v){return p?new OffscreenCanvas(w,v):rs("canvas")}function S(w,v,O){let tt=1,j=It(w);if((j.width>O||j.height>O)&&(tt=O/Math.max(j.width,j.height)),tt<1)if(typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&w instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&w instanceof ImageBitmap||typeof VideoFrame<"u"&&w instanceof VideoFrame){let st=Math.floor(tt*j.width),ct=Math.floor(tt*j.height);d===void 0&&(d=u(st,ct));let q=v?u(st,ct):d;return q.width=st,q.height=ct,q.getContext("2d").drawImage(w,0,0,st,ct),Rt("WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+st+"x"+ct+")."),q}else return"data"in w&&Rt("WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),w;return w}function A(w){return w.generateMipmaps}function T(w){i.generateMipmap(w)}function R(w){return w.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:w.isWebGL3DRenderTarget?i.TEXTURE_3D:w.isWebGLArrayRenderTarget||w.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(w,v,O,tt,j,st=!1){if(w!==null){if(i[w]!==void 0)return i[w];Rt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+w+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||Rt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let q=v;if(v===i.RED&&(O===i.FLOAT&&(q=i.R32F),O===i.HALF_FLOAT&&(q=i.R16F),O===i.UNSIGNED_BYTE&&(q=i.R8),O===i.UNSIGNED_SHORT&&ct&&(q=ct.R16_EXT),O===i.SHORT&&ct&&(q=ct.R16_SNORM_EXT)),v===i.RED_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.R8UI),O===i.UNSIGNED_SHORT&&(q=i.R16UI),O===i.UNSIGNED_INT&&(q=i.R32UI),O===i.BYTE&&(q=i.R8I),O===i.SHORT&&(q=i.R16I),O===i.INT&&(q=i.R32I)),v===i.RG&&(O===i.FLOAT&&(q=i.RG32F),O===i.HALF_FLOAT&&(q=i.RG16F),O===i.UNSIGNED_BYTE&&(q=i.RG8),O===i.UNSIGNED_SHORT&&ct&&(q=ct.RG16_EXT),O===i.SHORT&&ct&&(q=ct.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.RG8UI),O===i.UNSIGNED_SHORT&&(q=i.RG16UI),O===i.UNSIGNED_INT&&(q=i.RG32UI),O===i.BYTE&&(q=i.RG8I),O===i.SHORT&&(q=i.RG16I),O===i.INT&&(q=i.RG32I)),v===i.RGB_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.RGB8UI),O===i.UNSIGNED_SHORT&&(q=i.RGB16UI),O===i.UNSIGNED_INT&&(q=i.RGB32UI),O===i.BYTE&&(q=i.RGB8I),O===i.SHORT&&(q=i.RGB16I),O===i.INT&&(q=i.RGB32I)),v===i.RGBA_INTEGER&&(O===i.UNSIGNED_BYTE&&(q=i.RGBA8UI),O===i.UNSIGNED_SHORT&&(q=i.RGBA16UI),O===i.UNSIGNED_INT&&(q=i.RGBA32UI),O===i.BYTE&&(q=i.RGBA8I),O===i.SHORT&&(q=i.RGBA16I),O===i.INT&&(q=i.RGBA32I)),v===i.RGB&&(O===i.UNSIGNED_SHORT&&ct&&(q=ct.RGB16_EXT),O===i.SHORT&&ct&&(q=ct.RGB16_SNORM_EXT),O===i.UNSIGNED_INT_5_9_9_9_REV&&(q=i.RGB9_E5),O===i.UNSIGNED_INT_10F_11F_11F_REV&&(q=i.R11F_G11F_B10F)),v===i.RGBA){let Z=st?ss:Gt.getTransfer(j);O===i.FLOAT&&(q=i.RGBA32F),O===i.HALF_FLOAT&&(q=i.RGBA16F),O===i.UNSIGNED_BYTE&&(q=Z===qt?i.SRGB8_ALPHA8:i.RGBA8),O===i.UNSIGNED_SHORT&&ct&&(q=ct.RGBA16_EXT),O===i.SHORT&&ct&&(q=ct.RGBA16_SNORM_EXT),O===i.UNSIGNED_SHORT_4_4_4_4&&(q=i.RGBA4),O===i.UNSIGNED_SHORT_5_5_5_1&&(q=i.RGB5_A1)}return(q===i.R16F||q===i.R32F||q===i.RG16F||q===i.RG32F||q===i.RGBA16F||q===i.RGBA32F)&&t.get("EXT_color_buffer_float"),q}function x(w,v){let O;return w?v===null||v===an||v===pi?O=i.DEPTH24_STENCIL8:v===on?O=i.DEPTH32F_STENCIL8:v===Wi&&(O=i.DEPTH24_STENCIL8,Rt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===an||v===pi?O=i.DEPTH_COMPONENT24:v===on?O=i.DEPTH_COMPONENT32F:v===Wi&&(O=i.DEPTH_COMPONENT16),O}function b(w,v){return A(w)===!0||w.isFramebufferTexture&&w.minFilter!==Se&&w.minFilter!==De?Math.log2(Math.max(v.width,v.height))+1:w.mipmaps.length>0?w.mipmaps.length:w.isCompressedTexture&&Array.isArray(w.image)?v.mipmaps.length:1}function N(w){let v=new WeakRef(w);n.get(w).__ref=v,g.add(v),M.register(w,v,v)}function I(w){let v=n.get(w).__ref;v!==void 0&&(g.delete(v),M.unregister(v))}function D(w){V(w.target)}function B(w){P(w.target)}function V(w){w.removeEventListener("dispose",D),I(w),Y(w),w.isVideoTexture&&h.delete(w),w.isHTMLTexture&&f.delete(w)}function P(w){w.removeEventListener("dispose",B),I(w),et(w)}function G(){for(let w of g){let v=w.deref();v!==void 0&&(v.isRenderTarget===!0?P(v):V(v))}g.clear(),f.clear()}function Y(w){let v=n.get(w);if(v.__webglInit===void 0)return;let O=w.source,tt=m.get(O);if(tt){let j=tt[v.__cacheKey];j.usedTimes--,j.usedTimes===0&&H(w),Object.keys(tt).length===0&&m.delete(O)}n.remove(w)}function H(w){let v=n.get(w);i.deleteTexture(v.__webglTexture);let O=w.source,tt=m.get(O);delete tt[v.__cacheKey],a.memory.textures--}function et(w){let v=n.get(w);v.__depthDisposeCallback&&v.__depthDisposeCallback();let O=w.depthTexture;if(O&&O.renderTarget===w&&V(O),w.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(v.__webglFramebuffer[j]))for(let st=0;st<v.__webglFramebuffer[j].length;st++)i.deleteFramebuffer(v.__webglFramebuffer[j][st]);else i.deleteFramebuffer(v.__webglFramebuffer[j]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[j])}else{if(Array.isArray(v.__webglFramebuffer))for(let j=0;j<v.__webglFramebuffer.length;j++)i.deleteFramebuffer(v.__webglFramebuffer[j]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let j=0;j<v.__webglColorRenderbuffer.length;j++)v.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[j]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let tt=w.textures;for(let j=0,st=tt.length;j<st;j++){let ct=n.get(tt[j]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),a.memory.textures--),n.remove(tt[j])}n.remove(w)}let X=0;function Q(){X=0}function $(){return X}function St(w){X=w}function Lt(){let w=X;return w>=s.maxTextures&&Rt("WebGLTextures: Trying to use "+(w+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,w}function J(w){let v=[];return v.push(w.wrapS),v.push(w.wrapT),v.push(w.wrapR||0),v.push(w.magFilter),v.push(w.minFilter),v.push(w.anisotropy),v.push(w.internalFormat),v.push(w.format),v.push(w.type),v.push(w.generateMipmaps),v.push(w.mipmapsAutoUpdate),v.push(w.premultiplyAlpha),v.push(w.flipY),v.push(w.unpackAlignment),v.push(w.colorSpace),v.join()}function pt(w,v){let O=n.get(w);if(w.isVideoTexture&&fe(w),w.isRenderTargetTexture===!1&&w.isExternalTexture!==!0&&w.version>0&&O.__version!==w.version){let tt=w.image;if(tt===null)Rt("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)Rt("WebGLRenderer: Texture marked for update but image is incomplete");else{de(O,w,v);return}}else w.isExternalTexture&&(O.__webglTexture=w.sourceTexture?w.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,O.__webglTexture,i.TEXTURE0+v)}function vt(w,v){let O=n.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&O.__version!==w.version){de(O,w,v);return}else w.isExternalTexture&&(O.__webglTexture=w.sourceTexture?w.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,O.__webglTexture,i.TEXTURE0+v)}function Et(w,v){let O=n.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&O.__version!==w.version){de(O,w,v);return}e.bindTexture(i.TEXTURE_3D,O.__webglTexture,i.TEXTURE0+v)}function mt(w,v){let O=n.get(w);if(w.version>0&&O.__version!==w.version){Fe(O,w,v);return}e.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+v)}let Nt={[Ar]:i.REPEAT,[fn]:i.CLAMP_TO_EDGE,[Rr]:i.MIRRORED_REPEAT},le={[Se]:i.NEAREST,[jc]:i.NEAREST_MIPMAP_NEAREST,[Rs]:i.NEAREST_MIPMAP_LINEAR,[De]:i.LINEAR,[ea]:i.LINEAR_MIPMAP_NEAREST,[Nn]:i.LINEAR_MIPMAP_LINEAR},Ct={[eh]:i.NEVER,[ll]:i.ALWAYS,[nh]:i.LESS,[al]:i.LEQUAL,[ih]:i.EQUAL,[ol]:i.GEQUAL,[sh]:i.GREATER,[rh]:i.NOTEQUAL};function Zt(w,v){if(v.type===on&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===De||v.magFilter===ea||v.magFilter===Rs||v.magFilter===Nn||v.minFilter===De||v.minFilter===ea||v.minFilter===Rs||v.minFilter===Nn)&&Rt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(w,i.TEXTURE_WRAP_S,Nt[v.wrapS]),i.texParameteri(w,i.TEXTURE_WRAP_T,Nt[v.wrapT]),(w===i.TEXTURE_3D||w===i.TEXTURE_2D_ARRAY)&&i.texParameteri(w,i.TEXTURE_WRAP_R,Nt[v.wrapR]),i.texParameteri(w,i.TEXTURE_MAG_FILTER,le[v.magFilter]),i.texParameteri(w,i.TEXTURE_MIN_FILTER,le[v.minFilter]),v.compareFunction&&(i.texParameteri(w,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(w,i.TEXTURE_COMPARE_FUNC,Ct[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===Se||v.minFilter!==Rs&&v.minFilter!==Nn||v.type===on&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let O=t.get("EXT_texture_filter_anisotropic");i.texParameterf(w,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function Kt(w,v){let O=!1;w.__webglInit===void 0&&(w.__webglInit=!0,v.addEventListener("dispose",D),N(v));let tt=v.source,j=m.get(tt);j===void 0&&(j={},m.set(tt,j));let st=J(v);if(st!==w.__cacheKey){j[st]===void 0&&(j[st]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,O=!0),j[st].usedTimes++;let ct=j[w.__cacheKey];ct!==void 0&&(j[w.__cacheKey].usedTimes--,ct.usedTimes===0&&H(v)),w.__cacheKey=st,w.__webglTexture=j[st].texture}return O}function zt(w,v,O){return Math.floor(Math.floor(w/O)/v)}function be(w,v,O,tt){let st=w.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,O,tt,v.data);else{st.sort((C,K)=>C.start-K.start);let ct=0;for(let C=1;C<st.length;C++){let K=st[ct],W=st[C],ot=K.start+K.count,it=zt(W.start,v.width,4),rt=zt(K.start,v.width,4);W.start<=ot+1&&it===rt&&zt(W.start+W.count-1,v.width,4)===it?K.count=Math.max(K.count,W.start+W.count-K.start):(++ct,st[ct]=W)}st.length=ct+1;let q=e.getParameter(i.UNPACK_ROW_LENGTH),Z=e.getParameter(i.UNPACK_SKIP_PIXELS),at=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let C=0,K=st.length;C<K;C++){let W=st[C],ot=Math.floor(W.start/4),it=Math.ceil(W.count/4),rt=ot%v.width,Tt=Math.floor(ot/v.width),Ot=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Tt),e.texSubImage2D(i.TEXTURE_2D,0,rt,Tt,Ot,nt,O,tt,v.data)}w.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,q),e.pixelStorei(i.UNPACK_SKIP_PIXELS,Z),e.pixelStorei(i.UNPACK_SKIP_ROWS,at)}}function de(w,v,O){let tt=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(tt=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(tt=i.TEXTURE_3D);let j=Kt(w,v),st=v.source;e.bindTexture(tt,w.__webglTexture,i.TEXTURE0+O);let ct=n.get(st);if(st.version!==ct.__version||j===!0){if(e.activeTexture(i.TEXTURE0+O),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let nt=Gt.getPrimaries(Gt.workingColorSpace),wt=v.colorSpace===Fn?null:Gt.getPrimaries(v.colorSpace),Ft=v.colorSpace===Fn||nt===wt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ft)}e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let Z=S(v.image,!1,s.maxTextureSize);Z=At(v,Z);let at=r.convert(v.format,v.colorSpace),C=r.convert(v.type),K=E(v.internalFormat,at,C,v.normalized,v.colorSpace,v.isVideoTexture);Zt(tt,v);let W,ot=v.mipmaps,it=v.isVideoTexture!==!0,rt=ct.__version===void 0||j===!0,Tt=st.dataReady,Ot=b(v,Z);if(v.isDepthTexture)K=x(v.format===Un,v.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,Z.width,Z.height):e.texImage2D(i.TEXTURE_2D,0,K,Z.width,Z.height,0,at,C,null));else if(v.isDataTexture)if(ot.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,wt=ot.length;nt<wt;nt++)W=ot[nt],it?Tt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,C,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,C,W.data);v.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,Z.width,Z.height),Tt&&be(v,Z,at,C)):e.texImage2D(i.TEXTURE_2D,0,K,Z.width,Z.height,0,at,C,Z.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,ot[0].width,ot[0].height,Z.depth);for(let nt=0,wt=ot.length;nt<wt;nt++)if(W=ot[nt],v.format!==cn)if(at!==null)if(it){if(Tt)if(v.layerUpdates.size>0){let Ft=ml(W.width,W.height,v.format,v.type);for(let dt of v.layerUpdates){let Jt=W.data.subarray(dt*Ft/W.data.BYTES_PER_ELEMENT,(dt+1)*Ft/W.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,dt,W.width,W.height,1,at,Jt)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Z.depth,at,W.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Z.depth,0,W.data,0,0);else Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?Tt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,W.width,W.height,Z.depth,at,C,W.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,W.width,W.height,Z.depth,0,at,C,W.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,ot[0].width,ot[0].height);for(let nt=0,wt=ot.length;nt<wt;nt++)W=ot[nt],v.format!==cn?at!==null?it?Tt&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,W.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,W.data):Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?Tt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,W.width,W.height,at,C,W.data):e.texImage2D(i.TEXTURE_2D,nt,K,W.width,W.height,0,at,C,W.data)}else if(v.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,Z.width,Z.height,Z.depth),Tt)if(v.layerUpdates.size>0){let nt=ml(Z.width,Z.height,v.format,v.type);for(let wt of v.layerUpdates){let Ft=Z.data.subarray(wt*nt/Z.data.BYTES_PER_ELEMENT,(wt+1)*nt/Z.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,wt,Z.width,Z.height,1,at,C,Ft)}v.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,at,C,Z.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,Z.width,Z.height,Z.depth,0,at,C,Z.data);else if(v.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Ot,K,Z.width,Z.height,Z.depth),Tt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,at,C,Z.data)):e.texImage3D(i.TEXTURE_3D,0,K,Z.width,Z.height,Z.depth,0,at,C,Z.data);else if(v.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Ot,K,Z.width,Z.height);else{let nt=Z.width,wt=Z.height;for(let Ft=0;Ft<Ot;Ft++)e.texImage2D(i.TEXTURE_2D,Ft,K,nt,wt,0,at,C,null),nt>>=1,wt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){let nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),Z.parentNode!==nt){nt.appendChild(Z),f.add(v),nt.onpaint=wt=>{let Ft=wt.changedElements;for(let dt of f)Ft.includes(dt.image)&&(dt.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Z);else{let Ft=i.RGBA,dt=i.RGBA,Jt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ft,dt,Jt,Z)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ot.length>0){if(it&&rt){let nt=It(ot[0]);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}for(let nt=0,wt=ot.length;nt<wt;nt++)W=ot[nt],it?Tt&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,at,C,W):e.texImage2D(i.TEXTURE_2D,nt,K,at,C,W);v.generateMipmaps=!1}else if(it){if(rt){let nt=It(Z);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}Tt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,at,C,Z)}else e.texImage2D(i.TEXTURE_2D,0,K,at,C,Z);A(v)&&v.mipmapsAutoUpdate===!0&&T(tt),ct.__version=st.version,v.onUpdate&&v.onUpdate(v)}w.__version=v.version}function Fe(w,v,O){if(v.image.length!==6)return;let tt=Kt(w,v),j=v.source;e.bindTexture(i.TEXTURE_CUBE_MAP,w.__webglTexture,i.TEXTURE0+O);let st=n.get(j);if(j.version!==st.__version||tt===!0){e.activeTexture(i.TEXTURE0+O);let ct=Gt.getPrimaries(Gt.workingColorSpace),q=v.colorSpace===Fn?null:Gt.getPrimaries(v.colorSpace),Z=v.colorSpace===Fn||ct===q?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let at=v.isCompressedTexture||v.image[0].isCompressedTexture,C=v.image[0]&&v.image[0].isDataTexture,K=[];for(let dt=0;dt<6;dt++)!at&&!C?K[dt]=S(v.image[dt],!0,s.maxCubemapSize):K[dt]=C?v.image[dt].image:v.image[dt],K[dt]=At(v,K[dt]);let W=K[0],ot=r.convert(v.format,v.colorSpace),it=r.convert(v.type),rt=E(v.internalFormat,ot,it,v.normalized,v.colorSpace),Tt=v.isVideoTexture!==!0,Ot=st.__version===void 0||tt===!0,nt=j.dataReady,wt=b(v,W);Zt(i.TEXTURE_CUBE_MAP,v);let Ft;if(v.isDepthTexture){if(rt=x(v.format===Un,v.type),Ot)if(Tt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,W.width,W.height);else for(let dt=0;dt<6;dt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,W.width,W.height,0,ot,it,null)}else if(at){Tt&&Ot&&e.texStorage2D(i.TEXTURE_CUBE_MAP,wt,rt,W.width,W.height);for(let dt=0;dt<6;dt++){Ft=K[dt].mipmaps;for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];v.format!==cn?ot!==null?Tt?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,ve.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ve.data):Rt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,0,0,ve.width,ve.height,ot,it,ve.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt,rt,ve.width,ve.height,0,ot,it,ve.data)}}}else{if(Ft=v.mipmaps,Tt&&Ot){Ft.length>0&&wt++;let dt=It(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,wt,rt,dt.width,dt.height)}for(let dt=0;dt<6;dt++)if(C){Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,K[dt].width,K[dt].height,ot,it,K[dt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,K[dt].width,K[dt].height,0,ot,it,K[dt].data);for(let Jt=0;Jt<Ft.length;Jt++){let Bn=Ft[Jt].image[dt].image;Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,Bn.width,Bn.height,ot,it,Bn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,Bn.width,Bn.height,0,ot,it,Bn.data)}}else{Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,0,0,ot,it,K[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,0,rt,ot,it,K[dt]);for(let Jt=0;Jt<Ft.length;Jt++){let ve=Ft[Jt];Tt?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,0,0,ot,it,ve.image[dt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+dt,Jt+1,rt,ot,it,ve.image[dt])}}}A(v)&&v.mipmapsAutoUpdate===!0&&T(i.TEXTURE_CUBE_MAP),st.__version=j.version,v.onUpdate&&v.onUpdate(v)}w.__version=v.version}function re(w,v,O,tt,j,st){let ct=r.convert(O.format,O.colorSpace),q=r.convert(O.type),Z=E(O.internalFormat,ct,q,O.normalized,O.colorSpace),at=n.get(v),C=n.get(O);if(C.__renderTarget=v,!at.__hasExternalTextures){let K=Math.max(1,v.width>>st),W=Math.max(1,v.height>>st);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?e.texImage3D(j,st,Z,K,W,v.depth,0,ct,q,null):e.texImage2D(j,st,Z,K,W,0,ct,q,null)}e.bindFramebuffer(i.FRAMEBUFFER,w),ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,tt,j,C.__webglTexture,0,ie(v)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,tt,j,C.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function un(w,v,O){if(i.bindRenderbuffer(i.RENDERBUFFER,w),v.depthBuffer){let tt=v.depthTexture,j=tt&&tt.isDepthTexture?tt.type:null,st=x(v.stencilBuffer,j),ct=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),st,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),st,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,st,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,w)}else{let tt=v.textures;for(let j=0;j<tt.length;j++){let st=tt[j],ct=r.convert(st.format,st.colorSpace),q=r.convert(st.type),Z=E(st.internalFormat,ct,q,st.normalized,st.colorSpace);ut(v)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ie(v),Z,v.width,v.height):O?i.renderbufferStorageMultisample(i.RENDERBUFFER,ie(v),Z,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Z,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(w,v,O){let tt=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,w),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let j=n.get(v.depthTexture);j.__renderTarget=v;let st=tt?v.depthTexture.image[0]:v.depthTexture.image;(!j.__webglTexture||st.width!==v.width||st.height!==v.height)&&(st.width=v.width,st.height=v.height,v.depthTexture.needsUpdate=!0),tt?mt(v.depthTexture,0):pt(v.depthTexture,0);let ct=j.__webglTexture,q=ie(v),Z=tt?i.TEXTURE_CUBE_MAP_POSITIVE_X+O:i.TEXTURE_2D,at=v.depthTexture.format===Un?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===Pn)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Z,ct,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,at,Z,ct,0);else if(v.depthTexture.format===Un)ut(v)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,at,Z,ct,0,q):i.framebufferTexture2D(i.FRAMEBUFFER,at,Z,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ye(w){let v=n.get(w),O=w.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==w.depthTexture){let tt=w.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),tt){let j=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,tt.removeEventListener("dispose",j)};tt.addEventListener("dispose",j),v.__depthDisposeCallback=j}v.__boundDepthTexture=tt}if(w.depthTexture&&!v.__autoAllocateDepthBuffer)if(O)for(let tt=0;tt<6;tt++)xe(v.__webglFramebuffer[tt],w,tt);else w.texture.mipmaps.length>0?xe(v.__webglFramebuffer[0],w,0):xe(v.__webglFramebuffer,w,0);else if(O){v.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[tt]),v.__webglDepthbuffer[tt]===void 0)v.__webglDepthbuffer[tt]=i.createRenderbuffer(),un(v.__webglDepthbuffer[tt],w,!1);else{let j=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer[tt];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}}else if(w.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),un(v.__webglDepthbuffer,w,!1);else{let j=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function qe(w,v,O){let tt=n.get(w);v!==void 0&&re(tt.__webglFramebuffer,w,w.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),O!==void 0&&Ye(w)}function Ze(w){let v=w.texture,O=n.get(w),tt=n.get(v);w.addEventListener("dispose",B),N(w);let j=w.textures,st=w.isWebGLCubeRenderTarget===!0,ct=j.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=i.createTexture()),tt.__version=v.version,a.memory.textures++),st){O.__webglFramebuffer=[];for(let q=0;q<6;q++)if(v.mipmaps.length>0){O.__webglFramebuffer[q]=[];for(let Z=0;Z<v.mipmaps.length;Z++)O.__webglFramebuffer[q][Z]=i.createFramebuffer()}else O.__webglFramebuffer[q]=i.createFramebuffer()}else{if(v.mipmaps.length>0){O.__webglFramebuffer=[];for(let q=0;q<v.mipmaps.length;q++)O.__webglFramebuffer[q]=i.createFramebuffer()}else O.__webglFramebuffer=i.createFramebuffer();if(ct)for(let q=0,Z=j.length;q<Z;q++){let at=n.get(j[q]);at.__webglTexture===void 0&&(at.__webglTexture=i.createTexture(),a.memory.textures++)}if(w.samples>0&&ut(w)===!1){O.__webglMultisampledFramebuffer=i.createFramebuffer(),O.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let q=0;q<j.length;q++){let Z=j[q];O.__webglColorRenderbuffer[q]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,O.__webglColorRenderbuffer[q]);let at=r.convert(Z.format,Z.colorSpace),C=r.convert(Z.type),K=E(Z.internalFormat,at,C,Z.normalized,Z.colorSpace,w.isXRRenderTarget===!0),W=ie(w);i.renderbufferStorageMultisample(i.RENDERBUFFER,W,K,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+q,i.RENDERBUFFER,O.__webglColorRenderbuffer[q])}i.bindRenderbuffer(i.RENDERBUFFER,null),w.depthBuffer&&(O.__webglDepthRenderbuffer=i.createRenderbuffer(),un(O.__webglDepthRenderbuffer,w,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture),Zt(i.TEXTURE_CUBE_MAP,v);for(let q=0;q<6;q++)if(v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)re(O.__webglFramebuffer[q][Z],w,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,Z);else re(O.__webglFramebuffer[q],w,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+q,0);A(v)?T(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let q=0,Z=j.length;q<Z;q++){let at=j[q],C=n.get(at),K=i.TEXTURE_2D;(w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&(K=w.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,C.__webglTexture),Zt(K,at),re(O.__webglFramebuffer,w,at,i.COLOR_ATTACHMENT0+q,K,0),A(at)&&T(K)}e.unbindTexture()}else{let q=i.TEXTURE_2D;if((w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&(q=w.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(q,tt.__webglTexture),Zt(q,v),v.mipmaps.length>0)for(let Z=0;Z<v.mipmaps.length;Z++)re(O.__webglFramebuffer[Z],w,v,i.COLOR_ATTACHMENT0,q,Z);else re(O.__webglFramebuffer,w,v,i.COLOR_ATTACHMENT0,q,0);A(v)?T(q):v.mipmaps.length>0&&i.texParameteri(q,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}w.depthBuffer&&Ye(w)}function L(w){let v=w.textures;for(let O=0,tt=v.length;O<tt;O++){let j=v[O];if(A(j)&&j.mipmapsAutoUpdate===!0){let st=R(w),ct=n.get(j).__webglTexture;e.bindTexture(st,ct),T(st),e.unbindTexture()}}}let Je=[];function ne(w){if(w.samples>0){if(ut(w)===!1){let v=w.textures,O=w.width,tt=w.height,j=i.COLOR_BUFFER_BIT,st=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(w),q=v.length>1;if(q)for(let at=0;at<v.length;at++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),w.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let at=0;at<v.length;at++){if(w.resolveDepthBuffer&&(w.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),w.stencilBuffer&&w.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),q){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let C=n.get(v[at]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,C,0)}i.blitFramebuffer(0,0,O,tt,0,0,O,tt,j,i.NEAREST),c===!0&&(Je.length=0,Je.push(i.COLOR_ATTACHMENT0+at),w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&Je.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Je))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),q)for(let at=0;at<v.length;at++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.RENDERBUFFER,ct.__webglColorRenderbuffer[at]);let C=n.get(v[at]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+at,i.TEXTURE_2D,C,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&c){let v=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function ie(w){return Math.min(s.maxSamples,w.samples)}function ut(w){let v=n.get(w);return w.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function fe(w){let v=a.render.frame;h.get(w)!==v&&(h.set(w,v),w.update())}function At(w,v){let O=w.colorSpace,tt=w.format,j=w.type;return w.isCompressedTexture===!0||w.isVideoTexture===!0||O!==is&&O!==Fn&&(Gt.getTransfer(O)===qt?(tt!==cn||j!==Be)&&Rt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Pt("WebGLTextures: Unsupported texture color space:",O)),v}function It(w){return typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement?(l.width=w.naturalWidth||w.width,l.height=w.naturalHeight||w.height):typeof VideoFrame<"u"&&w instanceof VideoFrame?(l.width=w.displayWidth,l.height=w.displayHeight):(l.width=w.width,l.height=w.height),l}this.allocateTextureUnit=Lt,this.resetTextureUnits=Q,this.getTextureUnits=$,this.setTextureUnits=St,this.setTexture2D=pt,this.setTexture2DArray=vt,this.setTexture3D=Et,this.setTextureCube=mt,this.rebindTextures=qe,this.setupRenderTarget=Ze,this.updateRenderTargetMipmap=L,this.updateMultisampleRenderTarget=ne,this.setupDepthRenderbuffer=Ye,this.setupFrameBufferTexture=re,this.useMultisampledRTT=ut,this.dispose=G}function Hg(i,t){function e(n,s=Fn){let r,a=Gt.getTransfer(s);if(n===Be)return i.UNSIGNED_BYTE;if(n===ia)return i.UNSIGNED_SHORT_4_4_4_4;if(n===sa)return i.UNSIGNED_SHORT_5_5_5_1;if(n===el)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nl)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$o)return i.BYTE;if(n===tl)return i.SHORT;if(n===Wi)return i.UNSIGNED_SHORT;if(n===na)return i.INT;if(n===an)return i.UNSIGNED_INT;if(n===on)return i.FLOAT;if(n===ln)return i.HALF_FLOAT;if(n===il)return i.ALPHA;if(n===sl)return i.RGB;if(n===cn)return i.RGBA;if(n===Pn)return i.DEPTH_COMPONENT;if(n===Un)return i.DEPTH_STENCIL;if(n===rl)return i.RED;if(n===ra)return i.RED_INTEGER;if(n===$n)return i.RG;if(n===aa)return i.RG_INTEGER;if(n===oa)return i.RGBA_INTEGER;if(n===Cs||n===Ps||n===_s||n===Is)if(a===qt)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Cs)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Cs)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ps)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===_s)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Is)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===la||n===ca||n===ha||n===ua)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===la)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ca)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ha)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ua)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===da||n===fa||n===pa||n===ma||n===ga||n===Ls||n===xa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===da||n===fa)return a===qt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===pa)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ma)return r.COMPRESSED_R11_EAC;if(n===ga)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ls)return r.COMPRESSED_RG11_EAC;if(n===xa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===va||n===ya||n===Ma||n===Sa||n===ba||n===Ta||n===wa||n===Ea||n===Aa||n===Ra||n===Ca||n===Pa||n===_a||n===Ia)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===va)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ya)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ma)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Sa)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ba)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ta)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===wa)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ea)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Aa)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ra)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ca)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Pa)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===_a)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ia)return a===qt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===La||n===Da||n===Na)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===La)return a===qt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Da)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Na)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ua||n===Fa||n===Ds||n===Oa)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ua)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Fa)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ds)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Oa)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===pi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Gg=`
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

}`,wl=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new ps(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new gn({vertexShader:Gg,fragmentShader:Vg,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new pe(new hi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},El=class extends mn{constructor(t,e){super();let n=this,s=null,r=1,a=null,o="local-floor",c=1,l=null,h=null,f=null,d=null,m=null,g=null,M=typeof XRWebGLBinding<"u",p=new wl,u={},S=e.getContextAttributes(),A=null,T=null,R=[],E=[],x=new Vt,b=null,N=null,I=new Le;I.viewport=new se;let D=new Le;D.viewport=new se;let B=[I,D],V=new jr,P=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let pt=R[J];return pt===void 0&&(pt=new Ui,R[J]=pt),pt.getTargetRaySpace()},this.getControllerGrip=function(J){let pt=R[J];return pt===void 0&&(pt=new Ui,R[J]=pt),pt.getGripSpace()},this.getHand=function(J){let pt=R[J];return pt===void 0&&(pt=new Ui,R[J]=pt),pt.getHandSpace()};function Y(J){let pt=E.indexOf(J.inputSource);if(pt===-1)return;let vt=R[pt];vt!==void 0&&(vt.update(J.inputSource,J.frame,l||a),vt.dispatchEvent({type:J.type,data:J.inputSource}))}function H(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",et);for(let J=0;J<R.length;J++){let pt=E[J];pt!==null&&(E[J]=null,R[J].disconnect(pt))}P=null,G=null,p.reset();for(let J in u)delete u[J];if(t.setRenderTarget(A),m=null,d=null,f=null,s=null,T=null,Lt.stop(),n.isPresenting=!1,t.setPixelRatio(b),t.setSize(x.width,x.height,!1),N!==null){let J=N.camera;J.fov=N.fov,J.zoom=N.zoom,J.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Rt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,n.isPresenting===!0&&Rt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||a},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",H),s.addEventListener("inputsourceschange",et),S.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(x),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let vt=null,Et=null,mt=null;S.depth&&(mt=S.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,vt=S.stencil?Un:Pn,Et=S.stencil?pi:an);let Nt={colorFormat:e.RGBA8,depthFormat:mt,scaleFactor:r};f=this.getBinding(),d=f.createProjectionLayer(Nt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),T=new Ve(d.textureWidth,d.textureHeight,{format:cn,type:Be,depthTexture:new Ln(d.textureWidth,d.textureHeight,Et,void 0,void 0,void 0,void 0,void 0,void 0,vt),stencilBuffer:S.stencil,colorSpace:t.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let vt={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,e,vt),s.updateRenderState({baseLayer:m}),t.setPixelRatio(1),t.setSize(m.framebufferWidth,m.framebufferHeight,!1),T=new Ve(m.framebufferWidth,m.framebufferHeight,{format:cn,type:Be,colorSpace:t.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}T.isXRRenderTarget=!0,this.setFoveation(c),l=null,a=await s.requestReferenceSpace(o),Lt.setContext(s),Lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function et(J){for(let pt=0;pt<J.removed.length;pt++){let vt=J.removed[pt],Et=E.indexOf(vt);Et>=0&&(E[Et]=null,R[Et].disconnect(vt))}for(let pt=0;pt<J.added.length;pt++){let vt=J.added[pt],Et=E.indexOf(vt);if(Et===-1){for(let Nt=0;Nt<R.length;Nt++)if(Nt>=E.length){E.push(vt),Et=Nt;break}else if(E[Nt]===null){E[Nt]=vt,Et=Nt;break}if(Et===-1)break}let mt=R[Et];mt&&mt.connect(vt)}}function X(J,pt){pt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(pt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let pt=J.near,vt=J.far;p.texture!==null&&(p.depthNear>0&&(pt=p.depthNear),p.depthFar>0&&(vt=p.depthFar)),V.near=D.near=I.near=pt,V.far=D.far=I.far=vt,(P!==V.near||G!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),P=V.near,G=V.far),V.layers.mask=J.layers.mask|6,I.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;let Et=J.parent,mt=V.cameras;X(V,Et);for(let Nt=0;Nt<mt.length;Nt++)X(mt[Nt],Et);V.projectionMatrix.copy(I.projectionMatrix),V.projectionMatrixInverse.copy(I.projectionMatrixInverse),N===null&&J.isPerspectiveCamera&&(N={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,V,Et)};function Q(J,pt,vt){vt===null?J.matrix.copy(pt.matrixWorld):(J.matrix.copy(vt.matrixWorld),J.matrix.invert(),J.matrix.multiply(pt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(pt.projectionMatrix),J.projectionMatrixInverse.copy(pt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Pr*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&m===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(V)},this.getCameraTexture=function(J){return u[J]};let $=null;function St(J,pt){if(h=pt.getViewerPose(l||a),g=pt,h!==null){let vt=h.views;m!==null&&(t.setRenderTargetFramebuffer(T,m.framebuffer),t.setRenderTarget(T));let Et=!1;vt.length!==V.cameras.length&&(V.cameras.length=0,Et=!0);for(let Ct=0;Ct<vt.length;Ct++){let Zt=vt[Ct],Kt=null;if(m!==null)Kt=m.getViewport(Zt);else{let be=f.getViewSubImage(d,Zt);Kt=be.viewport,Ct===0&&(t.setRenderTargetTextures(T,be.colorTexture,be.depthStencilTexture),t.setRenderTarget(T))}let zt=B[Ct];zt===void 0&&(zt=new Le,zt.layers.enable(Ct),zt.viewport=new se,B[Ct]=zt),zt.matrix.fromArray(Zt.transform.matrix),zt.matrix.decompose(zt.position,zt.quaternion,zt.scale),zt.projectionMatrix.fromArray(Zt.projectionMatrix),zt.projectionMatrixInverse.copy(zt.projectionMatrix).invert(),zt.viewport.set(Kt.x,Kt.y,Kt.width,Kt.height),Ct===0&&(V.matrix.copy(zt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Et===!0&&V.cameras.push(zt)}let mt=s.enabledFeatures;if(mt&&mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){f=n.getBinding();let Ct=f.getDepthInformation(vt[0]);Ct&&Ct.isValid&&Ct.texture&&p.init(Ct,s.renderState)}if(mt&&mt.includes("camera-access")&&M){t.state.unbindTexture(),f=n.getBinding();for(let Ct=0;Ct<vt.length;Ct++){let Zt=vt[Ct].camera;if(Zt){let Kt=u[Zt];Kt||(Kt=new ps,u[Zt]=Kt);let zt=f.getCameraImage(Zt);Kt.sourceTexture=zt}}}}for(let vt=0;vt<R.length;vt++){let Et=E[vt],mt=R[vt];Et!==null&&mt!==void 0&&mt.update(Et,pt,l||a)}$&&$(J,pt),pt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:pt}),g=null}let Lt=new Oh;Lt.setAnimationLoop(St),this.setAnimationLoop=function(J){$=J},this.dispose=function(){}}},Wg=new Qt,qh=new _t;qh.set(-1,0,0,0,1,0,0,0,1);function Xg(i,t){function e(p,u){p.matrixAutoUpdate===!0&&p.updateMatrix(),u.value.copy(p.matrix)}function n(p,u){u.color.getRGB(p.fogColor.value,dl(i)),u.isFog?(p.fogNear.value=u.near,p.fogFar.value=u.far):u.isFogExp2&&(p.fogDensity.value=u.density)}function s(p,u,S,A,T){u.isNodeMaterial?u.uniformsNeedUpdate=!1:u.isMeshBasicMaterial?r(p,u):u.isMeshLambertMaterial?(r(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshToonMaterial?(r(p,u),f(p,u)):u.isMeshPhongMaterial?(r(p,u),h(p,u),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)):u.isMeshStandardMaterial?(r(p,u),d(p,u),u.isMeshPhysicalMaterial&&m(p,u,T)):u.isMeshMatcapMaterial?(r(p,u),g(p,u)):u.isMeshDepthMaterial?r(p,u):u.isMeshDistanceMaterial?(r(p,u),M(p,u)):u.isMeshNormalMaterial?r(p,u):u.isLineBasicMaterial?(a(p,u),u.isLineDashedMaterial&&o(p,u)):u.isPointsMaterial?c(p,u,S,A):u.isSpriteMaterial?l(p,u):u.isShadowMaterial?(p.color.value.copy(u.color),p.opacity.value=u.opacity):u.isShaderMaterial&&(u.uniformsNeedUpdate=!1)}function r(p,u){p.opacity.value=u.opacity,u.color&&p.diffuse.value.copy(u.color),u.emissive&&p.emissive.value.copy(u.emissive).multiplyScalar(u.emissiveIntensity),u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.bumpMap&&(p.bumpMap.value=u.bumpMap,e(u.bumpMap,p.bumpMapTransform),p.bumpScale.value=u.bumpScale,u.side===Ne&&(p.bumpScale.value*=-1)),u.normalMap&&(p.normalMap.value=u.normalMap,e(u.normalMap,p.normalMapTransform),p.normalScale.value.copy(u.normalScale),u.side===Ne&&p.normalScale.value.negate()),u.displacementMap&&(p.displacementMap.value=u.displacementMap,e(u.displacementMap,p.displacementMapTransform),p.displacementScale.value=u.displacementScale,p.displacementBias.value=u.displacementBias),u.emissiveMap&&(p.emissiveMap.value=u.emissiveMap,e(u.emissiveMap,p.emissiveMapTransform)),u.specularMap&&(p.specularMap.value=u.specularMap,e(u.specularMap,p.specularMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest);let S=t.get(u),A=S.envMap,T=S.envMapRotation;A&&(p.envMap.value=A,p.envMapRotation.value.setFromMatrix4(Wg.makeRotationFromEuler(T)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(qh),p.reflectivity.value=u.reflectivity,p.ior.value=u.ior,p.refractionRatio.value=u.refractionRatio),u.lightMap&&(p.lightMap.value=u.lightMap,p.lightMapIntensity.value=u.lightMapIntensity,e(u.lightMap,p.lightMapTransform)),u.aoMap&&(p.aoMap.value=u.aoMap,p.aoMapIntensity.value=u.aoMapIntensity,e(u.aoMap,p.aoMapTransform))}function a(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform))}function o(p,u){p.dashSize.value=u.dashSize,p.totalSize.value=u.dashSize+u.gapSize,p.scale.value=u.scale}function c(p,u,S,A){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.size.value=u.size*S,p.scale.value=A*.5,u.map&&(p.map.value=u.map,e(u.map,p.uvTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function l(p,u){p.diffuse.value.copy(u.color),p.opacity.value=u.opacity,p.rotation.value=u.rotation,u.map&&(p.map.value=u.map,e(u.map,p.mapTransform)),u.alphaMap&&(p.alphaMap.value=u.alphaMap,e(u.alphaMap,p.alphaMapTransform)),u.alphaTest>0&&(p.alphaTest.value=u.alphaTest)}function h(p,u){p.specular.value.copy(u.specular),p.shininess.value=Math.max(u.shininess,1e-4)}function f(p,u){u.gradientMap&&(p.gradientMap.value=u.gradientMap)}function d(p,u){p.metalness.value=u.metalness,u.metalnessMap&&(p.metalnessMap.value=u.metalnessMap,e(u.metalnessMap,p.metalnessMapTransform)),p.roughness.value=u.roughness,u.roughnessMap&&(p.roughnessMap.value=u.roughnessMap,e(u.roughnessMap,p.roughnessMapTransform)),u.envMap&&(p.envMapIntensity.value=u.envMapIntensity)}function m(p,u,S){p.ior.value=u.ior,u.diffuseRoughness>0&&(p.diffuseRoughness.value=u.diffuseRoughness,u.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=u.diffuseRoughnessMap,e(u.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),u.sheen>0&&(p.sheenColor.value.copy(u.sheenColor).multiplyScalar(u.sheen),p.sheenRoughness.value=u.sheenRoughness,u.sheenColorMap&&(p.sheenColorMap.value=u.sheenColorMap,e(u.sheenColorMap,p.sheenColorMapTransform)),u.sheenRoughnessMap&&(p.sheenRoughnessMap.value=u.sheenRoughnessMap,e(u.sheenRoughnessMap,p.sheenRoughnessMapTransform))),u.clearcoat>0&&(p.clearcoat.value=u.clearcoat,p.clearcoatRoughness.value=u.clearcoatRoughness,u.clearcoatMap&&(p.clearcoatMap.value=u.clearcoatMap,e(u.clearcoatMap,p.clearcoatMapTransform)),u.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=u.clearcoatRoughnessMap,e(u.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),u.clearcoatNormalMap&&(p.clearcoatNormalMap.value=u.clearcoatNormalMap,e(u.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(u.clearcoatNormalScale),u.side===Ne&&p.clearcoatNormalScale.value.negate())),u.dispersion>0&&(p.dispersion.value=u.dispersion),u.retroreflectivity>0&&(p.retroreflectivity.value=u.retroreflectivity),u.iridescence>0&&(p.iridescence.value=u.iridescence,p.iridescenceIOR.value=u.iridescenceIOR,p.iridescenceThicknessMinimum.value=u.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=u.iridescenceThicknessMaximum,u.iridescenceMap&&(p.iridescenceMap.value=u.iridescenceMap,e(u.iridescenceMap,p.iridescenceMapTransform)),u.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=u.iridescenceThicknessMap,e(u.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),u.transmission>0&&(p.transmission.value=u.transmission,p.transmissionSamplerMap.value=S.texture,p.transmissionSamplerSize.value.set(S.width,S.height),u.transmissionMap&&(p.transmissionMap.value=u.transmissionMap,e(u.transmissionMap,p.transmissionMapTransform)),p.thickness.value=u.thickness,u.thicknessMap&&(p.thicknessMap.value=u.thicknessMap,e(u.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=u.attenuationDistance,p.attenuationColor.value.copy(u.attenuationColor)),u.anisotropy>0&&(p.anisotropyVector.value.set(u.anisotropy*Math.cos(u.anisotropyRotation),u.anisotropy*Math.sin(u.anisotropyRotation)),u.anisotropyMap&&(p.anisotropyMap.value=u.anisotropyMap,e(u.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=u.specularIntensity,p.specularColor.value.copy(u.specularColor),u.specularColorMap&&(p.specularColorMap.value=u.specularColorMap,e(u.specularColorMap,p.specularColorMapTransform)),u.specularIntensityMap&&(p.specularIntensityMap.value=u.specularIntensityMap,e(u.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,u){u.matcap&&(p.matcap.value=u.matcap)}function M(p,u){let S=t.get(u).light;p.referencePosition.value.setFromMatrixPosition(S.matrixWorld),p.nearDistance.value=S.shadow.camera.near,p.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Yg(i,t,e,n){let s={},r={};function a(S,A){let T=A.program;n.uniformBlockBinding(S,T,s[S.id])}function o(S,A){let T=s[S.id];T===void 0&&(g(S),T=c(S),s[S.id]=T,S.addEventListener("dispose",p));let R=A.program;n.updateUBOMapping(S,R);let E=t.render.frame;r[S.id]!==E&&(l(S),r[S.id]=E)}function c(S){let A=i.createBuffer(),T=S.__size,R=S.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,T,R),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(S){let A=s[S.id],T=S.uniforms,R=S.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=T.length;E<x;E++){let b=T[E];if(Array.isArray(b))for(let N=0,I=b.length;N<I;N++)h(b[N],E,N,R);else h(b,E,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(S,A,T,R){if(d(S,A,T,R)===!0){let E=S.__offset,x=S.value;if(Array.isArray(x)){let b=0;for(let N=0;N<x.length;N++){let I=x[N],D=M(I,!0);f(I,S.__data,b),b+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,S.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,S.__data)}}function f(S,A,T){typeof S=="number"||typeof S=="boolean"?A[T]=S:S.isMatrix3?(A[T]=S.elements[0],A[T+1]=S.elements[1],A[T+2]=S.elements[2],A[T+3]=0,A[T+4]=S.elements[3],A[T+5]=S.elements[4],A[T+6]=S.elements[5],A[T+7]=0,A[T+8]=S.elements[6],A[T+9]=S.elements[7],A[T+10]=S.elements[8],A[T+11]=0):ArrayBuffer.isView(S)?A.set(S.subarray(0,A.length-T),T):S.toArray(A,T)}function d(S,A,T,R){let E=S.value,x=A+"_"+T;if(Array.isArray(E)){R[x]===void 0&&(R[x]=[]);let b=R[x],N=!1;for(let I=0;I<E.length;I++)m(E[I],b,I)===!0&&(N=!0);return N}return m(E,R,x)}function m(S,A,T){if(A[T]===void 0)return typeof S=="number"||typeof S=="boolean"?A[T]=S:ArrayBuffer.isView(S)?A[T]=S.slice():A[T]=S.clone(),!0;{let R=A[T];if(typeof S=="number"||typeof S=="boolean"){if(R!==S)return A[T]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(R.equals(S)===!1)return R.copy(S),!0}}return!1}function g(S){let A=S.uniforms,T=0,R=16;for(let x=0,b=A.length;x<b;x++){let N=Array.isArray(A[x])?A[x]:[A[x]];for(let I=0,D=N.length;I<D;I++){let B=N[I],V=Array.isArray(B.value)?B.value:[B.value],P=Array.isArray(A[x])||Array.isArray(B.value),G=T;for(let H=0,et=V.length;H<et;H++){let X=V[H],Q=M(X,P),$=T%R,St=$%Q.boundary,Lt=$+St;T+=St,Lt!==0&&R-Lt<Q.storage&&(T+=R-Lt),H===0&&(G=T),T+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((T-G)/Float32Array.BYTES_PER_ELEMENT),B.__offset=G}}let E=T%R;return E>0&&(T+=R-E),S.__size=T,S.__cache={},this}function M(S,A){let T={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(T.boundary=4,T.storage=4):S.isVector2?(T.boundary=8,T.storage=8):S.isVector3||S.isColor?(T.boundary=16,T.storage=12):S.isVector4?(T.boundary=16,T.storage=16):S.isMatrix3?(T.boundary=16,T.storage=48):S.isMatrix4?(T.boundary=16,T.storage=64):S.isTexture?Rt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(T.boundary=16,T.storage=S.byteLength):Rt("WebGLRenderer: Unsupported uniform value type.",S),A===!0&&(T.boundary=16,T.storage=Math.ceil(T.storage/16)*16),T}function p(S){let A=S.target;A.removeEventListener("dispose",p),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function u(){for(let S in s)i.deleteBuffer(s[S]);s={},r={}}return{bind:a,update:o,dispose:u}}var qg=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),yn=null;function Zg(){return yn===null&&(yn=new Dr(qg,16,16,$n,ln),yn.name="DFG_LUT",yn.minFilter=De,yn.magFilter=De,yn.wrapS=fn,yn.wrapT=fn,yn.generateMipmaps=!1,yn.needsUpdate=!0),yn}var Ga=class{constructor(t={}){let{canvas:e=oh(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:d=!1,outputBufferType:m=Be}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let M=m,p=new Set([oa,aa,ra]),u=new Set([Be,an,Wi,pi,ia,sa]),S=new Uint32Array(4),A=new Int32Array(4),T={textures:[],min:[],max:[],resolution:[]},R=null,E=null,x=[],b=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=vn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,B=null,V=null,P=null,G=null;this._outputColorSpace=He;let Y=0,H=0,et=null,X=-1,Q=null,$=new se,St=new se,Lt=null,J=new Ut(0),pt=0,vt=e.width,Et=e.height,mt=1,Nt=null,le=null,Ct=new se(0,0,vt,Et),Zt=new se(0,0,vt,Et),Kt=!1,zt=new qn,be=new Nr,de=!1,Fe=!1,re=new Qt,un=new U,xe=new se,Ye={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},qe=!1;function Ze(){return et===null?mt:1}let L=n;function Je(y,_){return e.getContext(y,_)}let ne,ie,ut,fe,At,It,w,v,O,tt,j,st,ct,q,Z,at,C,K,W,ot,it,rt,Tt;try{let y={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",wt,!1),e.addEventListener("webglcontextrestored",Ft,!1),e.addEventListener("webglcontextcreationerror",dt,!1),L===null){let _="webgl2";if(L=Je(_,y),L===null)throw Je(_)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ot()}catch(y){throw e.removeEventListener("webglcontextlost",wt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),Pt("WebGLRenderer: "+y.message),y}function Ot(){ne=new rm(L),ne.init(),it=new Hg(L,ne),ie=new Zp(L,ne,t,it),ut=new zg(L,ne),ie.reversedDepthBuffer&&d&&ut.buffers.depth.setReversed(!0),V=L.createFramebuffer(),P=L.createFramebuffer(),G=L.createFramebuffer(),fe=new lm(L),At=new Eg,It=new kg(L,ne,ut,At,ie,it,fe),w=new sm(I),v=new cd(L),rt=new Yp(L,v),O=new am(L,v,fe,rt),tt=new hm(L,O,v,rt,fe),K=new cm(L,ie,It),Z=new Jp(At),j=new wg(I,w,ne,ie,rt,Z),st=new Xg(I,At),ct=new Rg,q=new Dg(ne),C=new Xp(I,w,ut,tt,g,c),at=new Bg(I,tt,ie),Tt=new Yg(L,fe,ie,ut),W=new qp(L,ne,fe),ot=new om(L,ne,fe),fe.programs=j.programs,I.capabilities=ie,I.extensions=ne,I.properties=At,I.renderLists=ct,I.shadowMap=at,I.state=ut,I.info=fe}M!==Be&&(N=new dm(M,e.width,e.height,o,s,r));let nt=new El(I,L);this.xr=nt,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let y=ne.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){let y=ne.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return mt},this.setPixelRatio=function(y){y!==void 0&&(mt=y,this.setSize(vt,Et,!1))},this.getSize=function(y){return y.set(vt,Et)},this.setSize=function(y,_,k=!0){if(nt.isPresenting){Rt("WebGLRenderer: Can't change size while VR device is presenting.");return}vt=y,Et=_,e.width=Math.floor(y*mt),e.height=Math.floor(_*mt),k===!0&&(e.style.width=y+"px",e.style.height=_+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,y,_)},this.getDrawingBufferSize=function(y){return y.set(vt*mt,Et*mt).floor()},this.setDrawingBufferSize=function(y,_,k){vt=y,Et=_,mt=k,e.width=Math.floor(y*k),e.height=Math.floor(_*k),this.setViewport(0,0,y,_)},this.setEffects=function(y){if(M===Be){Pt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let _=0;_<y.length;_++)if(y[_].isOutputPass===!0){Rt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy($)},this.getViewport=function(y){return y.copy(Ct)},this.setViewport=function(y,_,k,F){y.isVector4?Ct.set(y.x,y.y,y.z,y.w):Ct.set(y,_,k,F),ut.viewport($.copy(Ct).multiplyScalar(Ze()).round())},this.getScissor=function(y){return y.copy(Zt)},this.setScissor=function(y,_,k,F){y.isVector4?Zt.set(y.x,y.y,y.z,y.w):Zt.set(y,_,k,F),ut.scissor(St.copy(Zt).multiplyScalar(Ze()).round())},this.getScissorTest=function(){return Kt},this.setScissorTest=function(y){ut.setScissorTest(Kt=y)},this.setOpaqueSort=function(y){Nt=y},this.setTransparentSort=function(y){le=y},this.getClearColor=function(y){return y.copy(C.getClearColor())},this.setClearColor=function(){C.setClearColor(...arguments)},this.getClearAlpha=function(){return C.getClearAlpha()},this.setClearAlpha=function(){C.setClearAlpha(...arguments)},this.clear=function(y=!0,_=!0,k=!0){let F=0;if(y){let z=!1;if(et!==null){let ht=et.texture.format;z=p.has(ht)}if(z){let ht=et.texture.type,xt=u.has(ht),lt=C.getClearColor(),gt=C.getClearAlpha(),bt=lt.r,Dt=lt.g,kt=lt.b;xt?(S[0]=bt,S[1]=Dt,S[2]=kt,S[3]=gt,L.clearBufferuiv(L.COLOR,0,S)):(A[0]=bt,A[1]=Dt,A[2]=kt,A[3]=gt,L.clearBufferiv(L.COLOR,0,A))}else F|=L.COLOR_BUFFER_BIT}_&&(F|=L.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),k&&(F|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&L.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),B=y},this.dispose=function(){e.removeEventListener("webglcontextlost",wt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",dt,!1),C.dispose(),ct.dispose(),q.dispose(),It.dispose(),At.dispose(),w.dispose(),tt.dispose(),O.dispose(),rt.dispose(),Tt.dispose(),j.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Nl),nt.removeEventListener("sessionend",Ul),ei.stop()};function wt(y){y.preventDefault(),hl("WebGLRenderer: Context Lost."),D=!0}function Ft(){hl("WebGLRenderer: Context Restored."),D=!1;let y=fe.autoReset,_=at.enabled,k=at.autoUpdate,F=at.needsUpdate,z=at.type;Ot(),fe.autoReset=y,at.enabled=_,at.autoUpdate=k,at.needsUpdate=F,at.type=z}function dt(y){Pt("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Jt(y){let _=y.target;_.removeEventListener("dispose",Jt),ve(_)}function ve(y){Bn(y),At.remove(y)}function Bn(y){let _=At.get(y).programs;_!==void 0&&(_.forEach(function(k){j.releaseProgram(k)}),y.isShaderMaterial&&j.releaseShaderCache(y))}this.renderBufferDirect=function(y,_,k,F,z,ht){_===null&&(_=Ye);let xt=z.isMesh&&z.matrixWorld.determinantAffine()<0,lt=cu(y,_,k,F,z);ut.setMaterial(F,xt);let gt=k.index,bt=1;if(F.wireframe===!0){if(gt=O.getWireframeAttribute(k),gt===void 0)return;bt=2}let Dt=k.drawRange,kt=k.attributes.position,yt=Dt.start*bt,Ht=(Dt.start+Dt.count)*bt;ht!==null&&(yt=Math.max(yt,ht.start*bt),Ht=Math.min(Ht,(ht.start+ht.count)*bt)),gt!==null?(yt=Math.max(yt,0),Ht=Math.min(Ht,gt.count)):kt!=null&&(yt=Math.max(yt,0),Ht=Math.min(Ht,kt.count));let ce=Ht-yt;if(ce<0||ce===1/0)return;rt.setup(z,F,lt,k,gt);let $t,jt=W;if(gt!==null&&($t=v.get(gt),jt=ot,jt.setIndex($t)),z.isMesh)F.wireframe===!0?(ut.setLineWidth(F.wireframeLinewidth*Ze()),jt.setMode(L.LINES)):jt.setMode(L.TRIANGLES);else if(z.isLine){let Ee=F.linewidth;Ee===void 0&&(Ee=1),ut.setLineWidth(Ee*Ze()),z.isLineSegments?jt.setMode(L.LINES):z.isLineLoop?jt.setMode(L.LINE_LOOP):jt.setMode(L.LINE_STRIP)}else z.isPoints?jt.setMode(L.POINTS):z.isSprite&&jt.setMode(L.TRIANGLES);if(z.isBatchedMesh)if(ne.get("WEBGL_multi_draw"))jt.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Ee=z._multiDrawStarts,Mt=z._multiDrawCounts,Ie=z._multiDrawCount,Yt=gt?v.get(gt).bytesPerElement:1,ni=At.get(F).currentProgram.getUniforms();for(let Ae=0;Ae<Ie;Ae++)ni.setValue(L,"_gl_DrawID",Ae),jt.render(Ee[Ae]/Yt,Mt[Ae])}else if(z.isInstancedMesh)jt.renderInstances(yt,ce,z.count);else if(k.isInstancedBufferGeometry){let Ee=k._maxInstanceCount!==void 0?k._maxInstanceCount:1/0,Mt=Math.min(k.instanceCount,Ee);jt.renderInstances(yt,ce,Mt)}else jt.render(yt,ce)};function Dl(y,_,k,F){B!==null&&y.isNodeMaterial&&B.setObject(F,y),de===!0&&Z.setState(y,k,!1),y.transparent===!0&&y.side===xn&&y.forceSinglePass===!1?(y.side=Ne,y.needsUpdate=!0,Zi(y,_,F),y.side=Qn,y.needsUpdate=!0,Zi(y,_,F),y.side=xn):Zi(y,_,F)}this.compile=function(y,_,k=null){k===null&&(k=y),B!==null&&B.renderStart(y,_,k),E=q.get(k),E.init(_),b.push(E),k.traverseVisible(function(z){z.isLight&&z.layers.test(_.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),y!==k&&y.traverseVisible(function(z){z.isLight&&z.layers.test(_.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),Fe=this.localClippingEnabled,de=Z.init(this.clippingPlanes,Fe),de===!0&&Z.setGlobalState(this.clippingPlanes,_),B!==null&&at.render(E.state.shadowsArray,k,_);let F=new Set;return y.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let ht=z.material;if(ht)if(Array.isArray(ht))for(let xt=0;xt<ht.length;xt++){let lt=ht[xt];Dl(lt,k,_,z),F.add(lt)}else Dl(ht,k,_,z),F.add(ht)}),E=b.pop(),B!==null&&B.renderEnd(),F},this.compileAsync=function(y,_,k=null){let F=this.compile(y,_,k);return new Promise(z=>{function ht(){if(F.forEach(function(xt){let gt=At.get(xt).currentProgram;(gt===void 0||gt.isReady())&&F.delete(xt)}),F.size===0){z(y);return}setTimeout(ht,10)}ne.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let no=null;function ou(y){no&&no(y)}function Nl(){ei.stop()}function Ul(){ei.start()}let ei=new Oh;ei.setAnimationLoop(ou),typeof self<"u"&&ei.setContext(self),this.setAnimationLoop=function(y){no=y,nt.setAnimationLoop(y),y===null?ei.stop():ei.start()},nt.addEventListener("sessionstart",Nl),nt.addEventListener("sessionend",Ul),this.render=function(y,_){if(_!==void 0&&_.isCamera!==!0){Pt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(y,_);let k=nt.enabled===!0&&nt.isPresenting===!0,F=N!==null&&(et===null||k)&&N.begin(I,et);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),_.parent===null&&_.matrixWorldAutoUpdate===!0&&_.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(_),_=nt.getCamera()),y.isScene===!0&&y.onBeforeRender(I,y,_,et),E=q.get(y,b.length),E.init(_),E.state.textureUnits=It.getTextureUnits(),b.push(E),re.multiplyMatrices(_.projectionMatrix,_.matrixWorldInverse),_.isArrayCamera?be.setFromArrayCamera(_):zt.setFromProjectionMatrix(re,je,_.reversedDepth),Fe=this.localClippingEnabled,de=Z.init(this.clippingPlanes,Fe),R=ct.get(y,x.length),R.init(),x.push(R),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let xt=I.xr.getDepthSensingMesh();xt!==null&&io(xt,_,-1/0,I.sortObjects)}io(y,_,0,I.sortObjects),R.finish(),B!==null&&B.updateLights(E.state.lightsArray),I.sortObjects===!0&&R.sort(Nt,le),qe=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,qe&&C.addToRenderList(R,y),this.info.autoReset===!0&&this.info.reset(),de===!0&&Z.beginShadows();let z=E.state.shadowsArray;if(at.render(z,y,_),de===!0&&Z.endShadows(),(F&&N.hasRenderPass())===!1){let xt=R.opaque,lt=R.transmissive;if(E.setupLights(),_.isArrayCamera){let gt=_.cameras;if(lt.length>0)for(let bt=0,Dt=gt.length;bt<Dt;bt++){let kt=gt[bt];Ol(xt,lt,y,kt)}qe&&C.render(y);for(let bt=0,Dt=gt.length;bt<Dt;bt++){let kt=gt[bt];Fl(R,y,kt,kt.viewport)}}else lt.length>0&&Ol(xt,lt,y,_),qe&&C.render(y),Fl(R,y,_)}et!==null&&H===0&&(It.updateMultisampleRenderTarget(et),It.updateRenderTargetMipmap(et)),F&&N.end(I),y.isScene===!0&&y.onAfterRender(I,y,_),rt.resetDefaultState(),X=-1,Q=null,b.pop(),b.length>0?(E=b[b.length-1],It.setTextureUnits(E.state.textureUnits),de===!0&&Z.setGlobalState(I.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,B!==null&&B.renderEnd()};function io(y,_,k,F){if(y.visible===!1)return;if(y.layers.test(_.layers)){if(y.isGroup)k=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(_);else if(y.isLight)E.pushLight(y),y.castShadow&&E.pushShadow(y);else if(y.isSprite){let xt=_.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){F&&xe.setFromMatrixPosition(y.matrixWorld).applyMatrix4(re);let lt=tt.update(y),gt=y.material;gt.visible&&R.push(y,lt,gt,k,xe.z,null,_)}}else if(y.isMesh||y.isLine||y.isPoints){let xt=_.isArrayCamera?be:zt;if(!y.frustumCulled||y.intersectsFrustum(xt)){let lt=tt.update(y),gt=y.material;if(F&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),xe.copy(y.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),xe.copy(lt.boundingSphere.center)),xe.applyMatrix4(y.matrixWorld).applyMatrix4(re)),Array.isArray(gt)){let bt=lt.groups;for(let Dt=0,kt=bt.length;Dt<kt;Dt++){let yt=bt[Dt],Ht=gt[yt.materialIndex];Ht&&Ht.visible&&R.push(y,lt,Ht,k,xe.z,yt,_)}}else gt.visible&&R.push(y,lt,gt,k,xe.z,null,_)}}}let ht=y.children;for(let xt=0,lt=ht.length;xt<lt;xt++)io(ht[xt],_,k,F)}function Fl(y,_,k,F){let{opaque:z,transmissive:ht,transparent:xt}=y;E.setupLightsView(k),de===!0&&Z.setGlobalState(I.clippingPlanes,k),F&&ut.viewport($.copy(F)),z.length>0&&Hs(z,_,k),ht.length>0&&Hs(ht,_,k),xt.length>0&&Hs(xt,_,k),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function Ol(y,_,k,F){if((k.isScene===!0?k.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[F.id]===void 0){let yt=ne.has("EXT_color_buffer_half_float")||ne.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[F.id]=new Ve(1,1,{generateMipmaps:!0,type:yt?ln:Be,minFilter:Nn,samples:Math.max(4,ie.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Gt.workingColorSpace})}let ht=E.state.transmissionRenderTarget[F.id],xt=F.viewport||$;ht.setSize(xt.z*I.transmissionResolutionScale,xt.w*I.transmissionResolutionScale);let lt=I.getRenderTarget(),gt=I.getActiveCubeFace(),bt=I.getActiveMipmapLevel();I.setRenderTarget(ht),I.getClearColor(J),pt=I.getClearAlpha(),pt<1&&I.setClearColor(16777215,.5),I.clear(),qe&&C.render(k);let Dt=I.toneMapping;I.toneMapping=vn;let kt=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),E.setupLightsView(F),de===!0&&Z.setGlobalState(I.clippingPlanes,F),Hs(y,k,F),It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht),ne.has("WEBGL_multisampled_render_to_texture")===!1){let yt=!1;for(let Ht=0,ce=_.length;Ht<ce;Ht++){let $t=_[Ht],{object:jt,geometry:Ee,material:Mt,group:Ie}=$t;if(Mt.side===xn&&jt.layers.test(F.layers)){let Yt=Mt.side;Mt.side=Ne,Mt.needsUpdate=!0,Bl(jt,k,F,Ee,Mt,Ie),Mt.side=Yt,Mt.needsUpdate=!0,yt=!0}}yt===!0&&(It.updateMultisampleRenderTarget(ht),It.updateRenderTargetMipmap(ht))}I.setRenderTarget(lt,gt,bt),I.setClearColor(J,pt),kt!==void 0&&(F.viewport=kt),I.toneMapping=Dt}function Hs(y,_,k){let F=_.isScene===!0?_.overrideMaterial:null;for(let z=0,ht=y.length;z<ht;z++){let xt=y[z],{object:lt,geometry:gt,group:bt}=xt,Dt=xt.material;Dt.allowOverride===!0&&F!==null&&(Dt=F),lt.layers.test(k.layers)&&Bl(lt,_,k,gt,Dt,bt)}}function Bl(y,_,k,F,z,ht){B!==null&&z.isNodeMaterial&&B.setObject(y,z),y.onBeforeRender(I,_,k,F,z,ht),y.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),z.onBeforeRender(I,_,k,F,y,ht),z.transparent===!0&&z.side===xn&&z.forceSinglePass===!1?(z.side=Ne,z.needsUpdate=!0,I.renderBufferDirect(k,_,F,z,y,ht),z.side=Qn,z.needsUpdate=!0,I.renderBufferDirect(k,_,F,z,y,ht),z.side=xn):I.renderBufferDirect(k,_,F,z,y,ht),y.onAfterRender(I,_,k,F,z,ht)}function zl(y){let _=0;for(let k of y)k.texture!==null&&_++;return _}function Zi(y,_,k){_.isScene!==!0&&(_=Ye);let F=At.get(y),z=E.state.lights,ht=E.state.shadowsArray,xt=z.state.version,lt=j.getParameters(y,z.state,ht,_,k,E.state.lightProbeGridArray),gt=j.getProgramCacheKey(lt),bt=F.programs;F.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?_.environment:null,F.fog=_.fog;let Dt=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;F.envMap=w.get(y.envMap||F.environment,Dt),F.envMapRotation=F.environment!==null&&y.envMap===null?_.environmentRotation:y.envMapRotation,bt===void 0&&(y.addEventListener("dispose",Jt),bt=new Map,F.programs=bt,F.programVariants=new Map);let kt=bt.get(gt);if(kt!==void 0){if(F.currentProgram===kt&&F.lightsStateVersion===xt)return Hl(y,lt),kt}else lt.uniforms=j.getUniforms(y),B!==null&&y.isNodeMaterial&&B.build(y,k,lt),y.onBeforeCompile(lt,I),kt=j.acquireProgram(lt,gt),bt.set(gt,kt),F.uniforms=lt.uniforms;let yt=F.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(yt.clippingPlanes=Z.uniform),Hl(y,lt),F.needsLights=uu(y),F.lightsStateVersion=xt,F.needsLights&&(yt.ambientLightColor.value=z.state.ambient,yt.lightProbe.value=z.state.probe,yt.sunLights.value=z.state.sun,yt.sunLightShadows.value=z.state.sunShadow,yt.directionalLights.value=z.state.directional,yt.directionalLightShadows.value=z.state.directionalShadow,yt.spotLights.value=z.state.spot,yt.spotLightShadows.value=z.state.spotShadow,yt.rectAreaLights.value=z.state.rectArea,yt.ltc_1.value=z.state.rectAreaLTC1,yt.ltc_2.value=z.state.rectAreaLTC2,yt.pointLights.value=z.state.point,yt.pointLightShadows.value=z.state.pointShadow,yt.hemisphereLights.value=z.state.hemi,yt.sunShadowMatrix.value=z.state.sunShadowMatrix,yt.sunShadowCascade.value=z.state.sunShadowCascade,yt.directionalShadowMatrix.value=z.state.directionalShadowMatrix,yt.spotLightMatrix.value=z.state.spotLightMatrix,yt.spotLightMap.value=z.state.spotLightMap,yt.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=zl(E.state.lightProbeGridArray),F.currentProgram=kt,F.uniformsList=null,kt}function lu(y,_,k,F,z){let ht=At.get(y),xt=ht.currentProgram.id+","+F+","+z,lt=ht.programVariants.get(xt);return lt===void 0?(lt=Zi(y,_,k),ht.programVariants.set(xt,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=F,ht.toneMapping=z),lt}function kl(y){if(y.uniformsList===null){let _=y.currentProgram.getUniforms();y.uniformsList=Xi.seqWithValue(_.seq,y.uniforms)}return y.uniformsList}function Hl(y,_){let k=At.get(y);k.outputColorSpace=_.outputColorSpace,k.batching=_.batching,k.batchingColor=_.batchingColor,k.instancing=_.instancing,k.instancingColor=_.instancingColor,k.instancingMorph=_.instancingMorph,k.skinning=_.skinning,k.morphTargets=_.morphTargets,k.morphNormals=_.morphNormals,k.morphColors=_.morphColors,k.morphTargetsCount=_.morphTargetsCount,k.numClippingPlanes=_.numClippingPlanes,k.numIntersection=_.numClipIntersection,k.vertexAlphas=_.vertexAlphas,k.vertexTangents=_.vertexTangents,k.toneMapping=_.toneMapping}function cu(y,_,k,F,z){_.isScene!==!0&&(_=Ye),It.resetTextureUnits();let ht=_.fog,xt=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?_.environment:null,lt=et===null?I.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Gt.workingColorSpace,gt=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,bt=w.get(F.envMap||xt,gt),Dt=F.vertexColors===!0&&!!k.attributes.color&&k.attributes.color.itemSize===4,kt=!!k.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),yt=!!k.morphAttributes.position,Ht=!!k.morphAttributes.normal,ce=!!k.morphAttributes.color,$t=vn;F.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&($t=I.toneMapping);let jt=k.morphAttributes.position||k.morphAttributes.normal||k.morphAttributes.color,Ee=jt!==void 0?jt.length:0,Mt=At.get(F),Ie=E.state.lights;if(de===!0&&(Fe===!0||y!==Q)){let ae=y===Q&&F.id===X;Z.setState(F,y,ae)}let Yt=!1,ni=!1;F.version===Mt.__version?Mt.needsLights&&Mt.lightsStateVersion!==Ie.state.version||z.isBatchedMesh&&Mt.batching===!1||!z.isBatchedMesh&&Mt.batching===!0||z.isBatchedMesh&&Mt.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Mt.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Mt.instancing===!1||!z.isInstancedMesh&&Mt.instancing===!0||z.isSkinnedMesh&&Mt.skinning===!1||!z.isSkinnedMesh&&Mt.skinning===!0||z.isInstancedMesh&&Mt.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Mt.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Mt.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Mt.instancingMorph===!1&&z.morphTexture!==null||Mt.envMap!==bt||F.fog===!0&&Mt.fog!==ht||Mt.numClippingPlanes!==void 0&&(Mt.numClippingPlanes!==Z.numPlanes||Mt.numIntersection!==Z.numIntersection)||Mt.vertexAlphas!==Dt||Mt.vertexTangents!==kt||Mt.morphTargets!==yt||Mt.morphNormals!==Ht||Mt.morphColors!==ce||Mt.morphTargetsCount!==Ee||Mt.numLightProbeGrids!==zl(E.state.lightProbeGridArray)?Yt=!0:(Mt.outputColorSpace!==lt||Mt.toneMapping!==$t)&&(ni=!0):(Yt=!0,Mt.__version=F.version);let Ae=Mt.currentProgram;(Yt===!0||ni===!0)&&(Ae=ni===!0?lu(F,_,z,lt,$t):Zi(F,_,z),B&&F.isNodeMaterial&&B.onUpdateProgram(F,Ae,Mt));let Gs=!1,zn=!1,ii=!1,Xt=Ae.getUniforms(),Te=Mt.uniforms;if(ut.useProgram(Ae.program)&&(Gs=!0,zn=!0,ii=!0),F.id!==X&&(X=F.id,zn=!0),Gs||Q!==y){ut.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),Xt.setValue(L,"projectionMatrix",y.projectionMatrix),Xt.setValue(L,"viewMatrix",y.matrixWorldInverse);let ye=Xt.map.cameraPosition;ye!==void 0&&ye.setValue(L,un.setFromMatrixPosition(y.matrixWorld)),ie.logarithmicDepthBuffer&&Xt.setValue(L,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&Xt.setValue(L,"isOrthographic",y.isOrthographicCamera===!0),Q!==y&&(Q=y,zn=!0,ii=!0)}if(Mt.needsLights&&(Ie.state.sunShadowMap.length>0&&Xt.setValue(L,"sunShadowMap",Ie.state.sunShadowMap,It),Ie.state.directionalShadowMap.length>0&&Xt.setValue(L,"directionalShadowMap",Ie.state.directionalShadowMap,It),Ie.state.spotShadowMap.length>0&&Xt.setValue(L,"spotShadowMap",Ie.state.spotShadowMap,It),Ie.state.pointShadowMap.length>0&&Xt.setValue(L,"pointShadowMap",Ie.state.pointShadowMap,It)),z.isSkinnedMesh){Xt.setOptional(L,z,"bindMatrix"),Xt.setOptional(L,z,"bindMatrixInverse");let ae=z.skeleton;ae&&(ae.boneTexture===null&&ae.computeBoneTexture(),Xt.setValue(L,"boneTexture",ae.boneTexture,It))}z.isBatchedMesh&&(Xt.setOptional(L,z,"batchingTexture"),Xt.setValue(L,"batchingTexture",z._matricesTexture,It),Xt.setOptional(L,z,"batchingIdTexture"),Xt.setValue(L,"batchingIdTexture",z._indirectTexture,It),Xt.setOptional(L,z,"batchingColorTexture"),z._colorsTexture!==null&&Xt.setValue(L,"batchingColorTexture",z._colorsTexture,It));let tn=k.morphAttributes;if((tn.position!==void 0||tn.normal!==void 0||tn.color!==void 0)&&K.update(z,k,Ae),(zn||Mt.receiveShadow!==z.receiveShadow)&&(Mt.receiveShadow=z.receiveShadow,Xt.setValue(L,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&_.environment!==null&&(Te.envMapIntensity.value=_.environmentIntensity),Te.dfgLUT!==void 0&&(Te.dfgLUT.value=Zg()),zn){if(Xt.setValue(L,"toneMappingExposure",I.toneMappingExposure),Mt.needsLights&&hu(Te,ii),ht&&F.fog===!0&&st.refreshFogUniforms(Te,ht),st.refreshMaterialUniforms(Te,F,mt,Et,E.state.transmissionRenderTarget[y.id]),Mt.needsLights&&Mt.numLightProbeGrids>0){let ae=T,ye=0;for(let Sn of E.state.lightProbeGridArray)Sn.texture!==null&&(ae.textures[ye]=Sn.texture,ae.min[ye]=Sn.boundingBox.min,ae.max[ye]=Sn.boundingBox.max,ae.resolution[ye]=Sn.resolution,ye++);for(let Sn in ae)ae[Sn].length=ye;Te.probesSH.value=ae.textures,Te.probesMin.value=ae.min,Te.probesMax.value=ae.max,Te.probesResolution.value=ae.resolution}Xi.upload(L,kl(Mt),Te,It)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(Xi.upload(L,kl(Mt),Te,It),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&Xt.setValue(L,"center",z.center),Xt.setValue(L,"modelViewMatrix",z.modelViewMatrix),Xt.setValue(L,"normalMatrix",z.normalMatrix),Xt.setValue(L,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let ae=F.uniformsGroups;for(let ye=0,Sn=ae.length;ye<Sn;ye++){let Vl=ae[ye];Tt.update(Vl,Ae),Tt.bind(Vl,Ae)}}return Ae}function hu(y,_){y.ambientLightColor.needsUpdate=_,y.lightProbe.needsUpdate=_,y.sunLights.needsUpdate=_,y.sunLightShadows.needsUpdate=_,y.directionalLights.needsUpdate=_,y.directionalLightShadows.needsUpdate=_,y.pointLights.needsUpdate=_,y.pointLightShadows.needsUpdate=_,y.spotLights.needsUpdate=_,y.spotLightShadows.needsUpdate=_,y.rectAreaLights.needsUpdate=_,y.hemisphereLights.needsUpdate=_}function uu(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(y,_,k){let F=At.get(y);F.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),At.get(y.texture).__webglTexture=_,At.get(y.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:k,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,_){let k=At.get(y);k.__webglFramebuffer=_,k.__useDefaultFramebuffer=_===void 0},this.setRenderTarget=function(y,_=0,k=0){et=y,Y=_,H=k;let F=null,z=!1,ht=!1;if(y){let lt=At.get(y);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(L.FRAMEBUFFER,lt.__webglFramebuffer),$.copy(y.viewport),St.copy(y.scissor),Lt=y.scissorTest,ut.viewport($),ut.scissor(St),ut.setScissorTest(Lt),X=-1;return}else if(lt.__webglFramebuffer===void 0)It.setupRenderTarget(y);else if(lt.__hasExternalTextures)It.rebindTextures(y,At.get(y.texture).__webglTexture,At.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){let Dt=y.depthTexture;if(lt.__boundDepthTexture!==Dt){if(Dt!==null&&At.has(Dt)&&(y.width!==Dt.image.width||y.height!==Dt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");It.setupDepthRenderbuffer(y)}}let gt=y.texture;(gt.isData3DTexture||gt.isDataArrayTexture||gt.isCompressedArrayTexture)&&(ht=!0);let bt=At.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(bt[_])?F=bt[_][k]:F=bt[_],z=!0):y.samples>0&&It.useMultisampledRTT(y)===!1?F=At.get(y).__webglMultisampledFramebuffer:Array.isArray(bt)?F=bt[k]:F=bt,$.copy(y.viewport),St.copy(y.scissor),Lt=y.scissorTest}else $.copy(Ct).multiplyScalar(mt).floor(),St.copy(Zt).multiplyScalar(mt).floor(),Lt=Kt;if(k!==0&&(F=V),ut.bindFramebuffer(L.FRAMEBUFFER,F)&&ut.drawBuffers(y,F),ut.viewport($),ut.scissor(St),ut.setScissorTest(Lt),z){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+_,lt.__webglTexture,k)}else if(ht){let lt=_;for(let gt=0;gt<y.textures.length;gt++){let bt=At.get(y.textures[gt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+gt,bt.__webglTexture,k,lt)}}else if(y!==null&&k!==0){let lt=At.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,lt.__webglTexture,k)}X=-1};function Gl(y){let _=At.get(y);return(_.__readFormat!==y.format||_.__readType!==y.type)&&(_.__readFormat=y.format,_.__readType=y.type,_.__formatReadable=ie.textureFormatReadable(y.format),_.__typeReadable=ie.textureTypeReadable(y.type)),_}this.readRenderTargetPixels=function(y,_,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget)){Pt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt){ut.bindFramebuffer(L.FRAMEBUFFER,gt);try{let bt=y.textures[lt],Dt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Gl(bt);if(yt.__formatReadable===!1){Pt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(yt.__typeReadable===!1){Pt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}_>=0&&_<=y.width-F&&k>=0&&k<=y.height-z&&L.readPixels(_,k,F,z,it.convert(Dt),it.convert(kt),ht)}finally{let bt=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,bt)}}},this.readRenderTargetPixelsAsync=async function(y,_,k,F,z,ht,xt,lt=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let gt=At.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&xt!==void 0&&(gt=gt[xt],Array.isArray(gt)&&(gt=gt[0])),gt)if(_>=0&&_<=y.width-F&&k>=0&&k<=y.height-z){ut.bindFramebuffer(L.FRAMEBUFFER,gt);let bt=y.textures[lt],Dt=bt.format,kt=bt.type;y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+lt);let yt=Gl(bt);if(yt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(yt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ht=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,Ht),L.bufferData(L.PIXEL_PACK_BUFFER,ht.byteLength,L.STREAM_READ),L.readPixels(_,k,F,z,it.convert(Dt),it.convert(kt),0),L.bindBuffer(L.PIXEL_PACK_BUFFER,null);let ce=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(L.FRAMEBUFFER,ce);let $t=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await ch(L,$t,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,Ht),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,ht),L.bindBuffer(L.PIXEL_PACK_BUFFER,null),L.deleteBuffer(Ht),L.deleteSync($t),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,_=null,k=0){let F=Math.pow(2,-k),z=Math.floor(y.image.width*F),ht=Math.floor(y.image.height*F),xt=_!==null?_.x:0,lt=_!==null?_.y:0;It.setTexture2D(y,0),L.copyTexSubImage2D(L.TEXTURE_2D,k,0,0,xt,lt,z,ht),ut.unbindTexture()},this.copyTextureToTexture=function(y,_,k=null,F=null,z=0,ht=0){let xt,lt,gt,bt,Dt,kt,yt,Ht,ce,$t=y.isCompressedTexture?y.mipmaps[ht]:y.image;if(k!==null)xt=k.max.x-k.min.x,lt=k.max.y-k.min.y,gt=k.isBox3?k.max.z-k.min.z:1,bt=k.min.x,Dt=k.min.y,kt=k.isBox3?k.min.z:0;else{let Xt=Math.pow(2,-z);xt=Math.floor($t.width*Xt),lt=Math.floor($t.height*Xt),y.isDataArrayTexture?gt=$t.depth:y.isData3DTexture?gt=Math.floor($t.depth*Xt):gt=1,bt=0,Dt=0,kt=0}F!==null?(yt=F.x,Ht=F.y,ce=F.z):(yt=0,Ht=0,ce=0);let jt=it.convert(_.format),Ee=it.convert(_.type),Mt;_.isData3DTexture?(It.setTexture3D(_,0),Mt=L.TEXTURE_3D):_.isDataArrayTexture||_.isCompressedArrayTexture?(It.setTexture2DArray(_,0),Mt=L.TEXTURE_2D_ARRAY):(It.setTexture2D(_,0),Mt=L.TEXTURE_2D),ut.activeTexture(L.TEXTURE0),ut.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,_.flipY),ut.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),ut.pixelStorei(L.UNPACK_ALIGNMENT,_.unpackAlignment);let Ie=ut.getParameter(L.UNPACK_ROW_LENGTH),Yt=ut.getParameter(L.UNPACK_IMAGE_HEIGHT),ni=ut.getParameter(L.UNPACK_SKIP_PIXELS),Ae=ut.getParameter(L.UNPACK_SKIP_ROWS),Gs=ut.getParameter(L.UNPACK_SKIP_IMAGES);ut.pixelStorei(L.UNPACK_ROW_LENGTH,$t.width),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,$t.height),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,bt),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Dt),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,kt);let zn=y.isDataArrayTexture||y.isData3DTexture,ii=_.isDataArrayTexture||_.isData3DTexture;if(y.isDepthTexture){let Xt=At.get(y),Te=At.get(_),tn=At.get(Xt.__renderTarget),ae=At.get(Te.__renderTarget);ut.bindFramebuffer(L.READ_FRAMEBUFFER,tn.__webglFramebuffer),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,ae.__webglFramebuffer);for(let ye=0;ye<gt;ye++)zn&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(y).__webglTexture,z,kt+ye),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,At.get(_).__webglTexture,ht,ce+ye)),L.blitFramebuffer(bt,Dt,bt+xt,Dt+lt,yt,Ht,yt+xt,Ht+lt,L.DEPTH_BUFFER_BIT,L.NEAREST);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(z!==0||y.isRenderTargetTexture||At.has(y)){let Xt=At.get(y),Te=At.get(_);ut.bindFramebuffer(L.READ_FRAMEBUFFER,P),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,G);for(let tn=0;tn<gt;tn++)zn?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Xt.__webglTexture,z,kt+tn):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Xt.__webglTexture,z),ii?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Te.__webglTexture,ht,ce+tn):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Te.__webglTexture,ht),z!==0?L.blitFramebuffer(bt,Dt,bt+xt,Dt+lt,yt,Ht,yt+xt,Ht+lt,L.COLOR_BUFFER_BIT,L.NEAREST):ii?L.copyTexSubImage3D(Mt,ht,yt,Ht,ce+tn,bt,Dt,xt,lt):L.copyTexSubImage2D(Mt,ht,yt,Ht,bt,Dt,xt,lt);ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else ii?y.isDataTexture||y.isData3DTexture?L.texSubImage3D(Mt,ht,yt,Ht,ce,xt,lt,gt,jt,Ee,$t.data):_.isCompressedArrayTexture?L.compressedTexSubImage3D(Mt,ht,yt,Ht,ce,xt,lt,gt,jt,$t.data):L.texSubImage3D(Mt,ht,yt,Ht,ce,xt,lt,gt,jt,Ee,$t):y.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,ht,yt,Ht,xt,lt,jt,Ee,$t.data):y.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,ht,yt,Ht,$t.width,$t.height,jt,$t.data):L.texSubImage2D(L.TEXTURE_2D,ht,yt,Ht,xt,lt,jt,Ee,$t);ut.pixelStorei(L.UNPACK_ROW_LENGTH,Ie),ut.pixelStorei(L.UNPACK_IMAGE_HEIGHT,Yt),ut.pixelStorei(L.UNPACK_SKIP_PIXELS,ni),ut.pixelStorei(L.UNPACK_SKIP_ROWS,Ae),ut.pixelStorei(L.UNPACK_SKIP_IMAGES,Gs),ht===0&&_.generateMipmaps===!0&&_.mipmapsAutoUpdate===!0&&L.generateMipmap(Mt),ut.unbindTexture()},this.initRenderTarget=function(y){At.get(y).__webglFramebuffer===void 0&&It.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?It.setTextureCube(y,0):y.isData3DTexture?It.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?It.setTexture2DArray(y,0):It.setTexture2D(y,0),ut.unbindTexture()},this.resetState=function(){Y=0,H=0,et=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return je}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Gt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Gt._getUnpackColorSpace()}};var Zh=.5,Jh=.012,qa=new U(0,0,1),Kh=.15,Xa=Math.PI/180,Qh=60*Xa,qi=i=>new vs({color:i}),Jg=qi("#e8eaee"),jh=qi("#9aa3b2"),Al=qi("#5c6675"),Kg=qi("#3d4653"),jg=qi("#c9723c"),Qg=qi("#8a6d3b"),$g=new $e({color:"#b3261e"}),t0=new $e({color:"#6a1b9a",wireframe:!0}),e0=new Zn({color:"#1f2937"}),n0=new Zn({color:"#5b4a2a"}),i0=new $e({color:"#1565c0",wireframe:!0,depthTest:!1});function On(i,t,e,n=20){let s=new Bi(i,i,t,n);return s.rotateX(Math.PI/2),new pe(s,e)}var ti=(i,t=0)=>new U(i[t],i[t+1],i[t+2]);function Ya(i,t,e){let n=e.clone().sub(t);i.position.copy(t).addScaledVector(n,.5),i.scale.z=Math.max(n.length(),1e-6),i.quaternion.setFromUnitVectors(qa,n.normalize())}var Za=class extends Ge{constructor(t){super(),this.shaft=On(.012,1,t,8),this.head=new pe(new ms(.032,.07,10).rotateX(Math.PI/2),t),this.add(this.shaft,this.head)}show(t,e){let n=Jh*e.length();if(this.visible=n>.012,!this.visible)return;let s=t.clone().addScaledVector(e,Jh);Ya(this.shaft,t,s),this.head.position.copy(s),this.head.quaternion.copy(this.shaft.quaternion)}},Ja=class extends Ge{constructor(t,e){super(),this.believes=e,this.position.y=t,this.rotation.z=Qh;let n=On(.1,.06,jh);n.position.z=.03,this.add(n),this.limbs=Array.from({length:8},(a,o)=>On(o<5?.055:.045,1,Jg)),this.joints=Array.from({length:7},(a,o)=>On(o<5?.068:.055,o<5?.15:.12,jh)),this.flange=new Ge;let s=On(.05,.02,Al),r=new pe(new Dn(.05,.19,.05),Al);r.position.z=.035,this.flange.add(s,r);for(let a of[-1,1]){let o=new pe(new Dn(.02,.015,.05),Al);o.position.set(0,a*.055,.085),this.flange.add(o)}this.objects=new Ge,this.flange.add(this.objects),this.belief=new pe(new zi(1,12,8),i0),this.belief.matrixAutoUpdate=!1,this.flange.add(this.belief),this.bag=new pe(new zi(.06,14,10),Qg),this.string=new Fi(new Pe().setFromPoints([new U,qa]),n0),this.target=new Ge,this.target.add(new pe(new xs(.085,.006,6,28),new $e({color:"#1f2937"}))),this.stream=On(.008,1,new $e({color:"#3b82c4"}),8),this.sag=On(.004,1,new $e({color:"#1f2937"}),6),this.push=new Za($g),this.felt=new Za(t0),this.add(...this.limbs,...this.joints,this.flange,this.bag,this.string,this.target,this.sag,this.stream,this.push,this.felt)}update(t,e,n,s){let r=t("links"),a=S=>[ti(r,7*S),new Qe(...r.slice(7*S+3,7*S+7))],o=new U;for(let S=0;S<8;++S){let[A,T]=a(S);this.limbs[S].visible=A.distanceTo(o)>.001,this.limbs[S].visible&&Ya(this.limbs[S],o,A),S<7?(this.joints[S].position.copy(A),this.joints[S].quaternion.copy(T)):(this.flange.position.copy(A),this.flange.quaternion.copy(T),this.target.quaternion.copy(T),this.target.position.copy(A).sub(ti(t("error"))),this.sag.visible=ti(t("error")).length()>.004,this.sag.visible&&Ya(this.sag,this.target.position,A)),o=A}let c=ti(t("hand")),l=c.clone().add(new U(.07,.03,.35));this.stream.visible=s,Ya(this.stream,l,l.clone().setZ(c.z-.05)),this.bag.visible=this.string.visible=n,n&&(this.bag.position.copy(ti(t("bag"))),this.string.geometry.setFromPoints([c,this.bag.position])),this.push.show(c,e),this.felt.show(c,this.believes?ti(t("force")):new U);let h=t("mean"),f=t("com_covariance");this.belief.visible=this.believes&&t("held")[0]>.5&&Math.max(f[0],f[4],f[8])<Kh*Kh;let d=2*Math.sqrt(f[0]),m=2*f[1]/Math.sqrt(f[0]),g=2*f[2]/Math.sqrt(f[0]),M=Math.sqrt(Math.max(4*f[4]-m*m,1e-8)),p=(4*f[5]-m*g)/M,u=Math.sqrt(Math.max(4*f[8]-g*g-p*p,1e-8));this.belief.matrix.set(d,0,0,h[1],m,M,0,h[2],g,p,u,h[3],0,0,0,1),this.belief.matrixWorldNeedsUpdate=!0}hold(t){this.objects.clear();for(let{mass:e,com:n,kind:s}of t){let r=.05*Math.cbrt(Math.max(e,.05)),a=s==="cup"?On(.045,.03+.06*e,jg):On(r,1.6*r,Kg);a.position.copy(ti(n)),a.add(new Oi(new gs(a.geometry,30),e0)),this.objects.add(a)}}};function s0(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;return t!==void 0&&/swiftshader|llvmpipe|software/i.test(i.getParameter(t))}var Ka=class{constructor(t){this.canvas=t,this.renderer=new Ga({canvas:t,antialias:!s0()}),this.scene=new ls,this.scene.background=new Ut("#f4f6f8"),this.camera=new Le(32,1,.1,10),this.camera.up.copy(qa),this.azimuth=0,this.elevation=12*Xa;let e=new ws("#ffffff",2);e.position.set(2,-1,3);let n=new Es(3,15,"#b8c0cc","#dde2e8");n.rotation.x=Math.PI/2,this.arms={without:new Ja(-Zh,!1),with:new Ja(Zh,!0)},this.wall=new pe(new hi(1,1.1,5,5),new $e({color:"#37474f",wireframe:!0})),this.wall.rotation.x=Math.PI/2,this.scene.add(new Ss("#ffffff","#b0b6bf",2),e,n,...Object.values(this.arms)),this.walls=Object.values(this.arms).map(s=>{let r=this.wall.clone();return s.add(r),r}),this.ratio=Math.min(devicePixelRatio,2),this.interval=this.drawn=0,this.resize(),new ResizeObserver(()=>this.resize()).observe(t)}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(this.ratio),this.renderer.setSize(t,e,!1),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.look())}look(){let t=Math.tan(this.camera.fov*Xa/2),e=Math.max(.58/t,.98/(t*this.camera.aspect))+.45,n=new U(.15,.18,.45),s=Math.cos(this.elevation);this.camera.position.set(s*Math.cos(this.azimuth),s*Math.sin(this.azimuth),Math.sin(this.elevation)).multiplyScalar(e).add(n),this.camera.lookAt(n),this.camera.updateMatrixWorld()}turn(t,e){this.azimuth=Math.min(Math.max(this.azimuth-.006*t,-1.2),1.2),this.elevation=Math.min(Math.max(this.elevation+.006*e,0),1.2),this.look()}handAt(t){let n=this.arms[t].flange.localToWorld(new U(0,0,.1)).project(this.camera);return{x:(n.x+1)/2*this.canvas.clientWidth,y:(1-n.y)/2*this.canvas.clientHeight}}inArms(t,e){let n=this.camera.position.distanceTo(this.arms.with.position),s=2*Math.tan(this.camera.fov*Xa/2)*n/this.canvas.clientHeight,r=new Qt().extractRotation(this.camera.matrixWorld);return new U(t*s,-e*s,0).applyMatrix4(r).applyAxisAngle(qa,-Qh)}draw(t,e){let n=JSON.stringify(e);for(let[r,a]of Object.entries(this.arms))a.update(o=>t(`${r}.${o}`),ti(t("push")),t("hanging")[0]!==0,t("pour")[0]>0),n!==this.held&&a.hold(e);this.held=n;let s=t("wall_at");for(let r of this.walls)r.visible=t("constrained")[0]!==0,r.position.set(.4,s[0]+.1,.5);this.renderer.render(this.scene,this.camera),this.adapt()}adapt(){let t=performance.now(),e=t-this.drawn;this.drawn=t,e<1e3&&(this.interval+=(e-this.interval)/10),!(this.interval<45||this.ratio<.6)&&(this.interval=0,this.ratio*=.8,this.resize())}};var eu=["hand is empty","holds it steadily","is being filled","something pushes","payload is changing"],$h=["","attached","exchanged","removed","filled","only a push"],Rl=300,r0=100,Xe=i=>document.getElementById(i),zs=new Worker(URL.createObjectURL(new Blob([Wl],{type:"text/javascript"}))),Cl=new Vs,_l,Il,$a,hn=0,Ll=1,Qa=0,to=[],ks=[],eo=!0,tu=!1,Pl=0,ja=-1,ue=i=>{let[t,e]=_l[i];return Il.subarray(t,t+e)},nu=i=>zs.postMessage({command:i});function a0(i){eo=!1,nu(i)}zs.onmessage=({data:i})=>{if(i.fields&&(_l=i.fields,to=[],ks=[],Pl=0,Cl.clear()),i.frames){for(Il of i.frames)Cl.add(ue);hn=i.ticks,i.busy&&(Qa+=(i.busy-Qa)*.05),eo&&l0()}i.command&&(i.accepted?o0(i.command,i.at):gi("A Panda is rated for 3 kg: that would be too much.")),i.paused&&au()};function o0(i,t){to.push(`${t} ${i}`);let[e,...n]=i.split(" ");e==="attach"&&ks.push({kind:+n[0]===Ji?"cup":"weight",mass:+n[0],com:n.slice(1).map(Number)}),e==="drop"&&(ks=[])}function l0(){!tu&&hn>=Rl&&nu(ro(1.2,0)),tu=hn>=Rl,hn<Rl?gi("Both hands are empty."):hn<4e3?gi("Both hands were given 1.2 kg. Nobody told the arms."):gi("Your turn: drag a weight onto a hand, or pull at a hand.")}function gi(i){Xe("caption").textContent!==i&&(Xe("caption").textContent=i)}function Ue(i,t,e,n=""){let s=Xe(i);s.dataset.value=t;let r=t.toFixed(e)+n;s.textContent!==r&&(s.textContent=r)}function iu(){let i=ue("with.mean"),t=ue("with.deviation"),e=ue("with.payload"),n=g=>Math.hypot(...g);Ue("error-without",1e3*n(ue("without.error")),1),Ue("error-with",1e3*n(ue("with.error")),1),Ue("mass",i[0],3),Ue("mass-deviation",t[0],3),Ue("truth",e[0],3);for(let g=0;g<3;++g)Ue(`com-${g}`,1e3*i[g+1],1),Ue(`com-deviation-${g}`,1e3*t[g+1],1),Ue(`com-truth-${g}`,1e3*e[g+1],1);let s=ue("with.probability"),r=s.indexOf(Math.max(...s));eu.forEach((g,M)=>{let p=Xe("modes").children[M];p.classList.toggle("likeliest",M===r),p.querySelector("i").style.width=`${100*s[M]}%`,Ue(`mode-${M}`,100*s[M],1," %")}),[...ue("with.force"),...ue("with.moment")].forEach((g,M)=>{let p=Math.max(-1,Math.min(1,g/(M<3?40:4))),u=Xe("wrench").children[M].querySelector("i");u.style.left=`${50+50*Math.min(p,0)}%`,u.style.width=`${50*Math.abs(p)}%`,Ue(`wrench-${M}`,g,M<3?1:2,M<3?" N":" N m")});let o=ue("with.health")[0],[c,l]=ue("with.limit");Ue("health",o,1),Xe("health-word").textContent=o<3?"good":"not explained",Ue("confidence",100*ue("with.confidence")[0],0," %"),Ue("friction",100*ue("with.friction_shows")[0],0," %"),Ue("wall",1e3*ue("with.wall")[0],0," mm"),Xe("limit").textContent=`joint ${c}, ${(l*180/Math.PI).toFixed(0)}\xB0 away`,Qa>0&&Ue("speed",1/Qa,1);let[h,f,d,m]=ue("with.event");ue("with.changing")[0]?Xe("noticed").textContent="something is happening":h>0&&(Xe("noticed").textContent=`${$h[f]}: noticed ${Math.round(1e3*(m-d))} ms after it began`),h>Pl&&!eo&&gi(`rme: ${$h[f]}, ${i[0].toFixed(2)} kg.`),Pl=h}function su(){requestAnimationFrame(su),Il&&($a?.draw(ue,ks.map(i=>i.kind==="cup"?{...i,mass:ue("poured")[0]}:i)),!(ja>=0&&hn>=ja&&hn<ja+r0)&&(ja=hn,iu(),Yl(Xe("history"),Cl)))}function ru(i,t,e){for(let[n,s]of t.entries())Xe(i).insertAdjacentHTML("beforeend",`<li><span>${s}</span><span class="bar"><i></i></span><output id="${e}-${n}"></output></li>`)}Xe("save").addEventListener("click",()=>{let i=document.createElement("a");i.href=URL.createObjectURL(new Blob([to.join(`
`)+`
`])),i.download=`session-seed-${Ll}-until-${hn}.txt`,i.click()});ru("modes",eu,"mode");ru("wrench",["force x","force y","force z","moment x","moment y","moment z"],"wrench");tc();try{$a=new Ka(Xe("scene"))}catch{gi("This browser draws no three dimensions (WebGL). The numbers are those of the arms all the same.")}Xl({act:a0,get:ue,say:gi,view:$a,held:()=>ks,restart:()=>{eo=!1,zs.postMessage({start:++Ll})}});requestAnimationFrame(su);var au;globalThis.rme={pause:()=>new Promise(i=>{au=()=>{iu();let t=Object.fromEntries(Object.keys(_l).map(e=>[e,[...ue(e)]]));i({ticks:hn,seed:Ll,session:to.join(`
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
