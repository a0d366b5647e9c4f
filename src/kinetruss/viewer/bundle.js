(()=>{var Ra={N:[[1e9,"nN"],[1e6,"µN"],[1e3,"mN"],[1,"N"],[.001,"kN"],[1e-6,"MN"],[1e-9,"GN"]],"N m":[[1e9,"nN m"],[1e6,"µN m"],[1e3,"mN m"],[1,"N m"],[.001,"kN m"],[1e-6,"MN m"],[1e-9,"GN m"]],V:[[1e9,"nV"],[1e6,"µV"],[1e3,"mV"],[1,"V"],[.001,"kV"],[1e-6,"MV"],[1e-9,"GV"]],A:[[1e9,"nA"],[1e6,"µA"],[1e3,"mA"],[1,"A"],[.001,"kA"],[1e-6,"MA"],[1e-9,"GA"]],W:[[1e9,"nW"],[1e6,"µW"],[1e3,"mW"],[1,"W"],[.001,"kW"],[1e-6,"MW"],[1e-9,"GW"]],J:[[1e9,"nJ"],[1e6,"µJ"],[1e3,"mJ"],[1,"J"],[.001,"kJ"],[1e-6,"MJ"],[1e-9,"GJ"]],Pa:[[1,"Pa"],[.001,"kPa"],[1e-6,"MPa"],[1e-9,"GPa"]],"N/m":[[1,"N/m"],[.001,"kN/m"],[1e-6,"MN/m"],[1e-9,"GN/m"]],"N m/rad":[[1,"N m/rad"],[.001,"kN m/rad"],[1e-6,"MN m/rad"],[1e-9,"GN m/rad"]],"N s/m":[[1,"N s/m"],[.001,"kN s/m"],[1e-6,"MN s/m"],[1e-9,"GN s/m"]],Hz:[[1,"Hz"],[.001,"kHz"],[1e-6,"MHz"],[1e-9,"GHz"]],m:[[1e9,"nm"],[1e6,"µm"],[1e3,"mm"],[1,"m"]],s:[[1e9,"ns"],[1e6,"µs"],[1e3,"ms"],[1,"s"]],"m/s":[[1e9,"nm/s"],[1e6,"µm/s"],[1e3,"mm/s"],[1,"m/s"]],"m/s²":[[1e9,"nm/s²"],[1e6,"µm/s²"],[1e3,"mm/s²"],[1,"m/s²"]],kg:[[1e3,"g"],[1,"kg"],[.001,"t"]],rad:[[57.29577951308232,"deg"]],"%":[[100,"%"]]},Bn={Pa:1e-6,"N/m":1e-6,"":1e-12},ls={"%":3,"":4},oh=1e6,Pa=-4,Rd=1e-12,Pd=" ",Id=" ",Nd=[1,1.2,1.6,2,2.4,3.2,4,4.8,6,8,10],lh=100;var ch=["#053a7a","#2b7bba","#8fc1e3","#d4d4d4","#f2b279","#d9662b","#8c2d04"],hh=["#482878","#3e4a89","#31688e","#26828e","#1f9e89","#35b779","#6ece58","#b5de2b","#fde725"],cs="#8a8a8a",_n="#e3003a",lr="#9429ff",Ld="#c66b9d",hi={rigid:"#7a8ea3",driven:"#009e73",active:"#009e73",elastic:"#c66b9d",beam:"#c66b9d",cable:"#d99a00",free:"#8d98a4",frame:"#8d98a4"},Ia={membrane:"#9fb6cc",solid:"#c2b59b"},Xe={light:{back:"#f7f8fa",card:"#ffffff",ink:"#1d242b",faint:"#5d6873",line:"#d5dbe1",accent:"#0b62a8",pressed:"#dcebf7",halo:"#a86400",alarm:"#c40032",outline:"#3a444e",node:"#5b6672",support:"#56606b",grid:"#8a949e",body:"#a9b6c3",edge:"#2b333b","pen-1":"#0072b2","pen-2":"#c24e00","pen-3":"#00795a"},dark:{back:"#14181d",card:"#1d232a",ink:"#e3e8ee",faint:"#9aa6b2",line:"#38424d",accent:"#6db5f0",pressed:"#24405a",halo:"#ffb000",alarm:"#ff8095",outline:"#7d8894",node:"#aab4bf",support:"#97a3af",grid:"#8a949e",body:"#5d6a77",edge:"#0b0e11","pen-1":"#56b4e9","pen-2":"#f08b47","pen-3":"#2fc796"}},Dd={clamp:[[[-.8,0],[.8,0]],[[-.48,0],[-.8,-.22]],[[-.16,0],[-.48,-.22]],[[.16,0],[-.16,-.22]],[[.48,0],[.16,-.22]],[[.8,0],[.48,-.22]]],pin:[[[0,0],[-.5,-.75],[.5,-.75],[0,0]],[[-.7,-.75],[.7,-.75]],[[-.42,-.75],[-.7,-.97]],[[-.14,-.75],[-.42,-.97]],[[.14,-.75],[-.14,-.97]],[[.42,-.75],[.14,-.97]],[[.7,-.75],[.42,-.97]]],roller:[[[0,0],[-.42,-.6],[.42,-.6],[0,0]],[[-.12,-.73],[-.158,-.638],[-.25,-.6],[-.342,-.638],[-.38,-.73],[-.342,-.822],[-.25,-.86],[-.158,-.822],[-.12,-.73]],[[.38,-.73],[.342,-.638],[.25,-.6],[.158,-.638],[.12,-.73],[.158,-.822],[.25,-.86],[.342,-.822],[.38,-.73]],[[-.7,-.86],[.7,-.86]],[[-.42,-.86],[-.7,-1.08]],[[-.14,-.86],[-.42,-1.08]],[[.14,-.86],[-.14,-1.08]],[[.42,-.86],[.14,-1.08]],[[.7,-.86],[.42,-1.08]]],spring:[[[0,0],[0,-.15],[.25,-.24],[-.25,-.42],[.25,-.6],[-.25,-.78],[0,-.87],[0,-1]],[[-.5,-1],[.5,-1]],[[-.3,-1],[-.5,-1.22]],[[-.1,-1],[-.3,-1.22]],[[.1,-1],[-.1,-1.22]],[[.3,-1],[.1,-1.22]],[[.5,-1],[.3,-1.22]]],gap:[[[0,0],[0,-.3]],[[-.35,-.3],[.35,-.3]],[[-.5,-.55],[.5,-.55]],[[-.3,-.55],[-.5,-.77]],[[-.1,-.55],[-.3,-.77]],[[.1,-.55],[-.1,-.77]],[[.3,-.55],[.1,-.77]],[[.5,-.55],[.3,-.77]]],turn:[[[-.35,-.35],[.35,-.35],[.35,.35],[-.35,.35],[-.35,-.35]]],"turning spring":[[[0,.15],[-.062,.149],[-.123,.123],[-.171,.071],[-.197,0],[-.193,-.08],[-.156,-.156],[-.089,-.215],[-0,-.244],[.098,-.237],[.189,-.189],[.258,-.107],[.291,-0],[.28,.116],[.223,.223],[.125,.302],[0,.339],[-.134,.324],[-.256,.256],[-.345,.143],[-.386,0],[-.367,-.152],[-.289,-.289],[-.161,-.389],[-0,-.433],[.17,-.411],[.323,-.323],[.433,-.179],[.48,-0]],[[.48,-.25],[.48,.25]]],"turning gap":[[[.485,.353],[.411,.437],[.321,.507],[.221,.558],[.112,.589],[0,.6],[-.112,.589],[-.221,.558],[-.321,.507],[-.411,.437],[-.485,.353]],[[.36,.26],[.61,.44]],[[-.36,.26],[-.61,.44]]]};function hs(s,t){let e=Ra[t],i=Math.abs(s);return e?!Number.isFinite(i)||i<(Bn[t]||Bn[""])?e.find(n=>n[0]===1)||e[0]:e.findLast(n=>i*n[0]*(1+1e-9)>=1)||e[0]:[1,t]}function ye(s,t=4){if(Number.isNaN(s))return"-";let e=s<0?"-":"";if(!Number.isFinite(s))return`${e}∞`;if(s===0)return"0";let i=Math.abs(s),[n,r]=i.toExponential(t-1).split("e"),a=Number(r);return a<Pa||a>=Math.log10(oh)?`${e}${Ud(n)}e${a}`:e+Ud(i.toFixed(Math.max(0,t-1-a)))}function Ud(s){return s.includes(".")?s.replace(/\.?0+$/,""):s}function $t(s,t,e=0){if(!Number.isFinite(s))return ye(s);let[i,n]=hs(s,t),r=Ra[t]&&Math.abs(s)<(Bn[t]||Bn[""])?0:s;return`${ye(r*i,e||ls[t]||ls[""])} ${n}`.trimEnd()}function dh(s){return Number.isFinite(s)?`${ye(s)} s`:"-"}function zn(s,t,e=0){let n=s.filter(Number.isFinite).map(Math.abs).reduce((r,a)=>Math.max(r,a),0);return Na(n,s,t,e)}function Na(s,t,e,i=0,n=!1){let[r,a]=hs(s,e),o=Math.max(Ra[e]?Bn[e]||Bn[""]:0,Rd*s),l=s*r,c=l>0?Math.floor(Math.log10(l)+1e-9):0,h=i||ls[e]||ls[""],u=t.reduce((m,g)=>Number.isFinite(g)&&Math.abs(g)>o?Math.min(m,Math.abs(g)):m,1);if(c<Pa||c>=Math.log10(oh)||a===""&&u<10**Pa)return[t.map(m=>ye(Math.abs(m)<o?0:m*r,i||ls[""])),a];let d=e==="%"&&!i,f=d?1:Math.max(0,h-1-c),p=t.filter(m=>Number.isFinite(m)&&Math.abs(m)>=o);for(;f&&!d&&!n&&p.every(m=>uh(m*r,f).endsWith("0"));)f--;let y=`0${f?Id+Pd.repeat(f):""}`;return[t.map(m=>Number.isFinite(m)?Math.abs(m)<o||!m?y:uh(m*r,f):ye(m)),a]}function uh(s,t){let e=Math.abs(s).toFixed(t);return s<0&&/[1-9]/.test(e)?`-${e}`:e}function xg(s){return Number.isFinite(s)?s>lh?`> ${lh}`:uh(s,2):ye(s)}function Od(s){if(!(Number.isFinite(s)&&s>0))return 1;let t=Math.floor(Math.log10(s));return[...Nd,12].map(e=>+`${e}e${t}`).find(e=>e>=s*(1-1e-9))}function fh(s,t,e=5){if(!(Number.isFinite(s)&&Number.isFinite(t)&&t>s))return[s];let i=Math.floor(Math.log10((t-s)/e));for(let n=0;n<9;n++){let r=[1,2,5][n%3],a=i+Math.floor(n/3),o=+`${r}e${a}`,l=Math.ceil(s/o-1e-9),c=Math.floor(t/o+1e-9);if(c-l<e)return Array.from({length:c-l+1},(h,u)=>+`${(l+u)*r}e${a}`)}return[s]}function Gn(s){let t=10**Math.floor(Math.log10(s));return([5,2,1].find(i=>i*t<=s*(1+1e-9))||1)*t}function La(s,t,e=!1){return Number.isNaN(t)?e?"-":Ui(s)?"not checked":"not known":s.scale==="margin"?t<=0?e?"∞":"∞ (no compression)":xg(1/t-1):$t(t,s.unit)}function Ui(s){return s.scale==="capacity"||s.scale==="margin"}function us(s){let t=parseInt(s.slice(1),16);return[t>>16&255,t>>8&255,t&255]}var ph={diverging:ch.map(us),sequential:hh.map(us)};function Fd(s,t){let e=Math.min(Math.max(t,0),1)*(s.length-1),i=Math.min(Math.floor(e),s.length-2),n=e-i;return s[i].map((r,a)=>r+n*(s[i+1][a]-r))}function yn(s,t,e){if(Number.isNaN(t))return us(cs);if(s==="capacity"||s==="margin")return t>1?us(_n):Fd(ph.sequential,t/e[1]);let i=e[1]-e[0]||1;return Fd(s==="diverging"?ph.diverging:ph.sequential,(t-e[0])/i)}function cr(s,t){if(s==="capacity"||s==="margin")return[0,1];let e=Od(Math.max(...t.flat().map(Math.abs)));return s==="diverging"?[-e,e]:[0,e]}function Da(s){return`linear-gradient(to right, ${(s==="diverging"?ch:hh).join(", ")})`}function x(s,t={},...e){let i=document.createElement(s);return kd(i,t),i.append(...e.flat(2).filter(n=>n!=null)),i}function Yt(s,t={},...e){let i=document.createElementNS("http://www.w3.org/2000/svg",s);return kd(i,t),i.append(...e.flat()),i}function kd(s,t){for(let[e,i]of Object.entries(t))e.startsWith("on")?s.addEventListener(e.slice(2),i):i===!0?s.setAttribute(e,""):i!==!1&&i!==void 0&&s.setAttribute(e,i)}function ce(s,...t){return s.replaceChildren(...t.flat().filter(Boolean)),s}function Ua(s,t,e,i){let n=x("button",{title:t,type:"button","aria-pressed":String(e)},s);return n.addEventListener("click",()=>i()),n}function Oi(s,t){s.setAttribute("aria-pressed",String(!!t))}function be(s,...t){return x("details",{open:!0},x("summary",{},s),...t)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Xi={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},$i={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Tf=0,Jh=1,Ef=2;var ra=1,Af=2,$s=3,Pn=0,ke=1,ii=2,ts=0,qs=1,Qh=2,tu=3,eu=4,Cf=5;var es=100,Rf=101,Pf=102,If=103,Nf=104,Lf=200,Df=201,Uf=202,Of=203,iu=204,nu=205,Ff=206,kf=207,Bf=208,zf=209,Gf=210,Vf=211,Hf=212,Wf=213,Xf=214,go=0,xo=1,_o=2,Ns=3,yo=4,vo=5,bo=6,Mo=7,el=0,$f=1,qf=2,qi=0,su=1,ru=2,au=3,ou=4,lu=5,cu=6,hu=7;var uu=300,is=301,Ys=302,il=303,nl=304,So=1e3,Bi=1001,wo=1002,qe=1003,Yf=1004;var aa=1005;var ai=1006,sl=1007;var cn=1008;var ui=1009,du=1010,fu=1011,Zs=1012,rl=1013,Ni=1014,wi=1015,Li=1016,al=1017,ol=1018,ns=1020,pu=35902,mu=35899,gu=1021,xu=1022,Di=1023,sn=1026,hn=1027,ll=1028,cl=1029,In=1030,hl=1031;var ul=1033,oa=33776,la=33777,ca=33778,ha=33779,dl=35840,fl=35841,pl=35842,ml=35843,gl=36196,xl=37492,_l=37496,yl=37488,vl=37489,ua=37490,bl=37491,Ml=37808,Sl=37809,wl=37810,Tl=37811,El=37812,Al=37813,Cl=37814,Rl=37815,Pl=37816,Il=37817,Nl=37818,Ll=37819,Dl=37820,Ul=37821,Ol=36492,Fl=36494,kl=36495,Bl=36283,zl=36284,da=36285,Gl=36286;var Tr=2300,To=2301,po=2302,Gh=2303,Vh=2400,Hh=2401,Wh=2402;var Zf=3200;var Vl=0,jf=1,un="",mi="srgb",Er="srgb-linear",Ar="linear",de="srgb";var mo=7680;var Kf=519,Jf=512,Qf=513,tp=514,_u=515,ep=516,ip=517,yu=518,vu=519,bu=35044,Mu=35048;var Su="300 es",Mi=2e3,Ls=2001;function _g(s){for(let t=s.length-1;t>=0;--t)if(s[t]>=65535)return!0;return!1}function yg(s){return ArrayBuffer.isView(s)&&!(s instanceof DataView)}function Cr(s){return document.createElementNS("http://www.w3.org/1999/xhtml",s)}function np(){let s=Cr("canvas");return s.style.display="block",s}var Bd={},Ds=null;function Rr(...s){let t="THREE."+s.shift();Ds?Ds("log",t,...s):console.log(t,...s)}function sp(s){let t=s[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=s[1];e&&e.isStackTrace?s[0]+=" "+e.getLocation():s[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return s}function Ft(...s){s=sp(s);let t="THREE."+s.shift();if(Ds)Ds("warn",t,...s);else{let e=s[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...s)}}function zt(...s){s=sp(s);let t="THREE."+s.shift();if(Ds)Ds("error",t,...s);else{let e=s[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...s)}}function br(...s){let t=s.join(" ");t in Bd||(Bd[t]=!0,Ft(...s))}function rp(s,t,e){return new Promise(function(i,n){function r(){switch(s.clientWaitSync(t,s.SYNC_FLUSH_COMMANDS_BIT,0)){case s.WAIT_FAILED:n();break;case s.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var ap={[go]:go,[_o]:bo,[yo]:yo,[Ns]:vo,[xo]:xo,[bo]:_o,[Mo]:Mo,[vo]:Ns},Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let n=i[t];if(n!==void 0){let r=n.indexOf(e);r!==-1&&n.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let n=i.slice(0);for(let r=0,a=n.length;r<a;r++)n[r].call(this,t);t.target=null}}},ti=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],zd=1234567,Ps=Math.PI/180,Us=180/Math.PI;function dn(){let s=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ti[s&255]+ti[s>>8&255]+ti[s>>16&255]+ti[s>>24&255]+"-"+ti[t&255]+ti[t>>8&255]+"-"+ti[t>>16&15|64]+ti[t>>24&255]+"-"+ti[e&63|128]+ti[e>>8&255]+"-"+ti[e>>16&255]+ti[e>>24&255]+ti[i&255]+ti[i>>8&255]+ti[i>>16&255]+ti[i>>24&255]).toLowerCase()}function jt(s,t,e){return Math.max(t,Math.min(e,s))}function wu(s,t){return(s%t+t)%t}function vg(s,t,e,i,n){return i+(s-t)*(n-i)/(e-t)}function bg(s,t,e){return s!==t?(e-s)/(t-s):0}function Mr(s,t,e){return(1-e)*s+e*t}function Mg(s,t,e,i){return Mr(s,t,1-Math.exp(-e*i))}function Sg(s,t=1){return t-Math.abs(wu(s,t*2)-t)}function wg(s,t,e){return s<=t?0:s>=e?1:(s=(s-t)/(e-t),s*s*(3-2*s))}function Tg(s,t,e){return s<=t?0:s>=e?1:(s=(s-t)/(e-t),s*s*s*(s*(s*6-15)+10))}function Eg(s,t){return s+Math.floor(Math.random()*(t-s+1))}function Ag(s,t){return s+Math.random()*(t-s)}function Cg(s){return s*(.5-Math.random())}function Rg(s){s!==void 0&&(zd=s);let t=zd+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Pg(s){return s*Ps}function Ig(s){return s*Us}function Ng(s){return s>0&&Number.isInteger(s)&&2**Math.round(Math.log2(s))===s}function Lg(s){return Math.pow(2,Math.ceil(Math.log(s)/Math.LN2))}function Tu(s){return Math.pow(2,Math.floor(Math.log(s)/Math.LN2))}function Dg(s,t,e,i,n){let r=Math.cos,a=Math.sin,o=r(e/2),l=a(e/2),c=r((t+i)/2),h=a((t+i)/2),u=r((t-i)/2),d=a((t-i)/2),f=r((i-t)/2),p=a((i-t)/2);switch(n){case"XYX":s.set(o*h,l*u,l*d,o*c);break;case"YZY":s.set(l*d,o*h,l*u,o*c);break;case"ZXZ":s.set(l*u,l*d,o*h,o*c);break;case"XZX":s.set(o*h,l*p,l*f,o*c);break;case"YXY":s.set(l*f,o*h,l*p,o*c);break;case"ZYZ":s.set(l*p,l*f,o*h,o*c);break;default:Ft("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+n)}}function Hl(s){switch(s.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Eu(s,t){if(t.constructor===Float32Array)return s;let e=Hl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(s/e,-1)}function Au(s,t){if(t.constructor===Float32Array)return s;let e=Hl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(s*e)}var Cu={DEG2RAD:Ps,RAD2DEG:Us,generateUUID:dn,clamp:jt,euclideanModulo:wu,mapLinear:vg,inverseLerp:bg,lerp:Mr,damp:Mg,pingpong:Sg,smoothstep:wg,smootherstep:Tg,randInt:Eg,randFloat:Ag,randFloatSpread:Cg,seededRandom:Rg,degToRad:Pg,radToDeg:Ig,isPowerOfTwo:Ng,ceilPowerOfTwo:Lg,floorPowerOfTwo:Tu,setQuaternionFromProperEuler:Dg,normalize:Au,denormalize:Eu},it=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,n=t.elements;return this.x=n[0]*e+n[3]*i+n[6],this.y=n[1]*e+n[4]*i+n[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=jt(this.x,t.x,e.x),this.y=jt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=jt(this.x,t,e),this.y=jt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(jt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),n=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*i-a*n+t.x,this.y=r*n+a*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},je=class{constructor(t=0,e=0,i=0,n=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=n}static slerpFlat(t,e,i,n,r,a,o){let l=i[n+0],c=i[n+1],h=i[n+2],u=i[n+3],d=r[a+0],f=r[a+1],p=r[a+2],y=r[a+3];if(u!==y||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*y;m<0&&(d=-d,f=-f,p=-p,y=-y,m=-m);let g=1-o;if(m<.9995){let M=Math.acos(m),w=Math.sin(M);g=Math.sin(g*M)/w,o=Math.sin(o*M)/w,l=l*g+d*o,c=c*g+f*o,h=h*g+p*o,u=u*g+y*o}else{l=l*g+d*o,c=c*g+f*o,h=h*g+p*o,u=u*g+y*o;let M=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=M,c*=M,h*=M,u*=M}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,n,r,a){let o=i[n],l=i[n+1],c=i[n+2],h=i[n+3],u=r[a],d=r[a+1],f=r[a+2],p=r[a+3];return t[e]=o*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-o*f,t[e+2]=c*p+h*f+o*d-l*u,t[e+3]=h*p-o*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,n){return this._x=t,this._y=e,this._z=i,this._w=n,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,n=t._y,r=t._z,a=t._order,o=Math.cos,l=Math.sin,c=o(i/2),h=o(n/2),u=o(r/2),d=l(i/2),f=l(n/2),p=l(r/2);switch(a){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Ft("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,n=Math.sin(i);return this._x=t.x*n,this._y=t.y*n,this._z=t.z*n,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],n=e[4],r=e[8],a=e[1],o=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=i+o+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-n)*f}else if(i>o&&i>u){let f=2*Math.sqrt(1+i-o-u);this._w=(h-l)/f,this._x=.25*f,this._y=(n+a)/f,this._z=(r+c)/f}else if(o>u){let f=2*Math.sqrt(1+o-i-u);this._w=(r-c)/f,this._x=(n+a)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-o);this._w=(a-n)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(jt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let n=Math.min(1,e/i);return this.slerp(t,n),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,n=t._y,r=t._z,a=t._w,o=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+a*o+n*c-r*l,this._y=n*h+a*l+r*o-i*c,this._z=r*h+a*c+i*l-n*o,this._w=a*h-i*o-n*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,n=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(i=-i,n=-n,r=-r,a=-a,o=-o);let l=1-e;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+n*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+n*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),n=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(n*Math.sin(t),n*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},P=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Gd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Gd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,n=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*n,this.y=r[1]*e+r[4]*i+r[7]*n,this.z=r[2]*e+r[5]*i+r[8]*n,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,n=this.z,r=t.elements,a=1/(r[3]*e+r[7]*i+r[11]*n+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*n+r[12])*a,this.y=(r[1]*e+r[5]*i+r[9]*n+r[13])*a,this.z=(r[2]*e+r[6]*i+r[10]*n+r[14])*a,this}applyQuaternion(t){let e=this.x,i=this.y,n=this.z,r=t.x,a=t.y,o=t.z,l=t.w,c=2*(a*n-o*i),h=2*(o*e-r*n),u=2*(r*i-a*e);return this.x=e+l*c+a*u-o*h,this.y=i+l*h+o*c-r*u,this.z=n+l*u+r*h-a*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,n=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*n,this.y=r[1]*e+r[5]*i+r[9]*n,this.z=r[2]*e+r[6]*i+r[10]*n,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=jt(this.x,t.x,e.x),this.y=jt(this.y,t.y,e.y),this.z=jt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=jt(this.x,t,e),this.y=jt(this.y,t,e),this.z=jt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,n=t.y,r=t.z,a=e.x,o=e.y,l=e.z;return this.x=n*l-r*o,this.y=r*a-i*l,this.z=i*o-n*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return mh.copy(this).projectOnVector(t),this.sub(mh)}reflect(t){return this.sub(mh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(jt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,n=this.z-t.z;return e*e+i*i+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let n=Math.sin(e)*t;return this.x=n*Math.sin(i),this.y=Math.cos(e)*t,this.z=n*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),n=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=n,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},mh=new P,Gd=new je,Ht=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,n,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,n,r,a,o,l,c)}set(t,e,i,n,r,a,o,l,c){let h=this.elements;return h[0]=t,h[1]=n,h[2]=o,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,n=e.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],p=i[8],y=n[0],m=n[3],g=n[6],M=n[1],w=n[4],b=n[7],C=n[2],E=n[5],_=n[8];return r[0]=a*y+o*M+l*C,r[3]=a*m+o*w+l*E,r[6]=a*g+o*b+l*_,r[1]=c*y+h*M+u*C,r[4]=c*m+h*w+u*E,r[7]=c*g+h*b+u*_,r[2]=d*y+f*M+p*C,r[5]=d*m+f*w+p*E,r[8]=d*g+f*b+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],n=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8];return e*a*h-e*o*c-i*r*h+i*o*l+n*r*c-n*a*l}invert(){let t=this.elements,e=t[0],i=t[1],n=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=h*a-o*c,d=o*l-h*r,f=c*r-a*l,p=e*u+i*d+n*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=u*y,t[1]=(n*c-h*i)*y,t[2]=(o*i-n*a)*y,t[3]=d*y,t[4]=(h*e-n*l)*y,t[5]=(n*r-o*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(a*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,n,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+t,-n*c,n*l,-n*(-c*a+l*o)+o+e,0,0,1),this}scale(t,e){return br("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(gh.makeScale(t,e)),this}rotate(t){return br("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(gh.makeRotation(-t)),this}translate(t,e){return br("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(gh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let n=0;n<9;n++)if(e[n]!==i[n])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},gh=new Ht,Vd=new Ht().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Hd=new Ht().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ug(){let s={enabled:!0,workingColorSpace:Er,spaces:{},convert:function(n,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===de&&(n.r=nn(n.r),n.g=nn(n.g),n.b=nn(n.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(n.applyMatrix3(this.spaces[r].toXYZ),n.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===de&&(n.r=Is(n.r),n.g=Is(n.g),n.b=Is(n.b))),n},workingToColorSpace:function(n,r){return this.convert(n,this.workingColorSpace,r)},colorSpaceToWorking:function(n,r){return this.convert(n,r,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===un?Ar:this.spaces[n].transfer},getToneMappingMode:function(n){return this.spaces[n].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(n,r=this.workingColorSpace){return n.fromArray(this.spaces[r].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,r,a){return n.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return s.define({[Er]:{primaries:t,whitePoint:i,transfer:Ar,toXYZ:Vd,fromXYZ:Hd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:mi},outputColorSpaceConfig:{drawingBufferColorSpace:mi}},[mi]:{primaries:t,whitePoint:i,transfer:de,toXYZ:Vd,fromXYZ:Hd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:mi}}}),s}var ae=Ug();function nn(s){return s<.04045?s*.0773993808:Math.pow(s*.9478672986+.0521327014,2.4)}function Is(s){return s<.0031308?s*12.92:1.055*Math.pow(s,.41666)-.055}var ds,Eo=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{ds===void 0&&(ds=Cr("canvas")),ds.width=t.width,ds.height=t.height;let n=ds.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),i=ds}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Cr("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let n=i.getImageData(0,0,t.width,t.height),r=n.data;for(let a=0;a<r.length;a++)r[a]=nn(r[a]/255)*255;return i.putImageData(n,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(nn(e[i]/255)*255):e[i]=nn(e[i]);return{data:e,width:t.width,height:t.height}}else return Ft("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Og=0,Os=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Og++}),this.uuid=dn(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},n=this.data;if(n!==null){let r;if(Array.isArray(n)){r=[];for(let a=0,o=n.length;a<o;a++)n[a].isDataTexture?r.push(xh(n[a].image)):r.push(xh(n[a]))}else r=xh(n);i.url=r}return e||(t.images[this.uuid]=i),i}};function xh(s){return typeof HTMLImageElement<"u"&&s instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&s instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&s instanceof ImageBitmap?Eo.getDataURL(s):s.data?{data:Array.from(s.data),width:s.width,height:s.height,type:s.data.constructor.name}:(Ft("Texture: Unable to serialize Texture."),{})}var Fg=0,_h=new P,oi=class s extends Ii{constructor(t=s.DEFAULT_IMAGE,e=s.DEFAULT_MAPPING,i=Bi,n=Bi,r=ai,a=cn,o=Di,l=ui,c=s.DEFAULT_ANISOTROPY,h=un){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Fg++}),this.uuid=dn(),this.name="",this.source=new Os(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=n,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ht,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(_h).x}get height(){return this.source.getSize(_h).y}get depth(){return this.source.getSize(_h).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Ft(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let n=this[e];if(n===void 0){Ft(`Texture.setValues(): property '${e}' does not exist.`);continue}n&&i&&n.isVector2&&i.isVector2||n&&i&&n.isVector3&&i.isVector3||n&&i&&n.isMatrix3&&i.isMatrix3?n.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==uu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case So:t.x=t.x-Math.floor(t.x);break;case Bi:t.x=t.x<0?0:1;break;case wo:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case So:t.y=t.y-Math.floor(t.y);break;case Bi:t.y=t.y<0?0:1;break;case wo:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=uu;oi.DEFAULT_ANISOTROPY=1;var Ae=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,n=1){this.x=t,this.y=e,this.z=i,this.w=n}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,n){return this.x=t,this.y=e,this.z=i,this.w=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,n=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*i+a[8]*n+a[12]*r,this.y=a[1]*e+a[5]*i+a[9]*n+a[13]*r,this.z=a[2]*e+a[6]*i+a[10]*n+a[14]*r,this.w=a[3]*e+a[7]*i+a[11]*n+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,n,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],y=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,b=(f+1)/2,C=(g+1)/2,E=(h+d)/4,_=(u+y)/4,T=(p+m)/4;return w>b&&w>C?w<.01?(i=0,n=.707106781,r=.707106781):(i=Math.sqrt(w),n=E/i,r=_/i):b>C?b<.01?(i=.707106781,n=0,r=.707106781):(n=Math.sqrt(b),i=E/n,r=T/n):C<.01?(i=.707106781,n=.707106781,r=0):(r=Math.sqrt(C),i=_/r,n=T/r),this.set(i,n,r,e),this}let M=Math.sqrt((m-p)*(m-p)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(m-p)/M,this.y=(u-y)/M,this.z=(d-h)/M,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=jt(this.x,t.x,e.x),this.y=jt(this.y,t.y,e.y),this.z=jt(this.z,t.z,e.z),this.w=jt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=jt(this.x,t,e),this.y=jt(this.y,t,e),this.z=jt(this.z,t,e),this.w=jt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ao=class extends Ii{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ai,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Ae(0,0,t,e),this.scissorTest=!1,this.viewport=new Ae(0,0,t,e),this.textures=[];let n=i.count;for(let r=0;r<n;r++)this.textures[r]=new oi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ai,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let n=0,r=this.textures.length;n<r;n++)this.textures[n].image.width=t,this.textures[n].image.height=e,this.textures[n].image.depth=i,this.textures[n].isData3DTexture!==!0&&(this.textures[n].isArrayTexture=this.textures[n].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let n=Object.assign({},t.textures[e].image);this.textures[e].source=new Os(n)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},xi=class extends Ao{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Pr=class extends oi{constructor(t=null,e=1,i=1,n=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:n},this.magFilter=qe,this.minFilter=qe,this.wrapR=Bi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Co=class extends oi{constructor(t=null,e=1,i=1,n=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:n},this.magFilter=qe,this.minFilter=qe,this.wrapR=Bi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var fe=class s{static{this.prototype.isMatrix4=!0}constructor(t,e,i,n,r,a,o,l,c,h,u,d,f,p,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,n,r,a,o,l,c,h,u,d,f,p,y,m)}set(t,e,i,n,r,a,o,l,c,h,u,d,f,p,y,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=n,g[1]=r,g[5]=a,g[9]=o,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=y,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new s().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,n=1/fs.setFromMatrixColumn(t,0).length(),r=1/fs.setFromMatrixColumn(t,1).length(),a=1/fs.setFromMatrixColumn(t,2).length();return e[0]=i[0]*n,e[1]=i[1]*n,e[2]=i[2]*n,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*a,e[9]=i[9]*a,e[10]=i[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,n=t.y,r=t.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(n),c=Math.sin(n),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=a*h,f=a*u,p=o*h,y=o*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-y*c,e[9]=-o*l,e[2]=y-d*c,e[6]=p+f*c,e[10]=a*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,y=c*u;e[0]=d+y*o,e[4]=p*o-f,e[8]=a*c,e[1]=a*u,e[5]=a*h,e[9]=-o,e[2]=f*o-p,e[6]=y+d*o,e[10]=a*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,y=c*u;e[0]=d-y*o,e[4]=-a*u,e[8]=p+f*o,e[1]=f+p*o,e[5]=a*h,e[9]=y-d*o,e[2]=-a*c,e[6]=o,e[10]=a*l}else if(t.order==="ZYX"){let d=a*h,f=a*u,p=o*h,y=o*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+y,e[1]=l*u,e[5]=y*c+d,e[9]=f*c-p,e[2]=-c,e[6]=o*l,e[10]=a*l}else if(t.order==="YZX"){let d=a*l,f=a*c,p=o*l,y=o*c;e[0]=l*h,e[4]=y-d*u,e[8]=p*u+f,e[1]=u,e[5]=a*h,e[9]=-o*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-y*u}else if(t.order==="XZY"){let d=a*l,f=a*c,p=o*l,y=o*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+y,e[5]=a*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=o*h,e[10]=y*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(kg,t,Bg)}lookAt(t,e,i){let n=this.elements;return fi.subVectors(t,e),fi.lengthSq()===0&&(fi.z=1),fi.normalize(),vn.crossVectors(i,fi),vn.lengthSq()===0&&(Math.abs(i.z)===1?fi.x+=1e-4:fi.z+=1e-4,fi.normalize(),vn.crossVectors(i,fi)),vn.normalize(),Oa.crossVectors(fi,vn),n[0]=vn.x,n[4]=Oa.x,n[8]=fi.x,n[1]=vn.y,n[5]=Oa.y,n[9]=fi.y,n[2]=vn.z,n[6]=Oa.z,n[10]=fi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,n=e.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],p=i[2],y=i[6],m=i[10],g=i[14],M=i[3],w=i[7],b=i[11],C=i[15],E=n[0],_=n[4],T=n[8],O=n[12],R=n[1],U=n[5],F=n[9],W=n[13],N=n[2],G=n[6],$=n[10],V=n[14],nt=n[3],X=n[7],Q=n[11],et=n[15];return r[0]=a*E+o*R+l*N+c*nt,r[4]=a*_+o*U+l*G+c*X,r[8]=a*T+o*F+l*$+c*Q,r[12]=a*O+o*W+l*V+c*et,r[1]=h*E+u*R+d*N+f*nt,r[5]=h*_+u*U+d*G+f*X,r[9]=h*T+u*F+d*$+f*Q,r[13]=h*O+u*W+d*V+f*et,r[2]=p*E+y*R+m*N+g*nt,r[6]=p*_+y*U+m*G+g*X,r[10]=p*T+y*F+m*$+g*Q,r[14]=p*O+y*W+m*V+g*et,r[3]=M*E+w*R+b*N+C*nt,r[7]=M*_+w*U+b*G+C*X,r[11]=M*T+w*F+b*$+C*Q,r[15]=M*O+w*W+b*V+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],n=t[8],r=t[12],a=t[1],o=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],y=t[7],m=t[11],g=t[15],M=l*f-c*d,w=o*f-c*u,b=o*d-l*u,C=a*f-c*h,E=a*d-l*h,_=a*u-o*h;return e*(y*M-m*w+g*b)-i*(p*M-m*C+g*E)+n*(p*w-y*C+g*_)-r*(p*b-y*E+m*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],n=t[8],r=t[1],a=t[5],o=t[9],l=t[2],c=t[6],h=t[10];return e*(a*h-o*c)-i*(r*h-o*l)+n*(r*c-a*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let n=this.elements;return t.isVector3?(n[12]=t.x,n[13]=t.y,n[14]=t.z):(n[12]=t,n[13]=e,n[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],n=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],y=t[13],m=t[14],g=t[15],M=e*o-i*a,w=e*l-n*a,b=e*c-r*a,C=i*l-n*o,E=i*c-r*o,_=n*c-r*l,T=h*y-u*p,O=h*m-d*p,R=h*g-f*p,U=u*m-d*y,F=u*g-f*y,W=d*g-f*m,N=M*W-w*F+b*U+C*R-E*O+_*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/N;return t[0]=(o*W-l*F+c*U)*G,t[1]=(n*F-i*W-r*U)*G,t[2]=(y*_-m*E+g*C)*G,t[3]=(d*E-u*_-f*C)*G,t[4]=(l*R-a*W-c*O)*G,t[5]=(e*W-n*R+r*O)*G,t[6]=(m*b-p*_-g*w)*G,t[7]=(h*_-d*b+f*w)*G,t[8]=(a*F-o*R+c*T)*G,t[9]=(i*R-e*F-r*T)*G,t[10]=(p*E-y*b+g*M)*G,t[11]=(u*b-h*E-f*M)*G,t[12]=(o*O-a*U-l*T)*G,t[13]=(e*U-i*O+n*T)*G,t[14]=(y*w-p*C-m*M)*G,t[15]=(h*C-u*w+d*M)*G,this}scale(t){let e=this.elements,i=t.x,n=t.y,r=t.z;return e[0]*=i,e[4]*=n,e[8]*=r,e[1]*=i,e[5]*=n,e[9]*=r,e[2]*=i,e[6]*=n,e[10]*=r,e[3]*=i,e[7]*=n,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],n=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,n))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),n=Math.sin(e),r=1-i,a=t.x,o=t.y,l=t.z,c=r*a,h=r*o;return this.set(c*a+i,c*o-n*l,c*l+n*o,0,c*o+n*l,h*o+i,h*l-n*a,0,c*l-n*o,h*l+n*a,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,n,r,a){return this.set(1,i,r,0,t,1,a,0,e,n,1,0,0,0,0,1),this}compose(t,e,i){let n=this.elements,r=e._x,a=e._y,o=e._z,l=e._w,c=r+r,h=a+a,u=o+o,d=r*c,f=r*h,p=r*u,y=a*h,m=a*u,g=o*u,M=l*c,w=l*h,b=l*u,C=i.x,E=i.y,_=i.z;return n[0]=(1-(y+g))*C,n[1]=(f+b)*C,n[2]=(p-w)*C,n[3]=0,n[4]=(f-b)*E,n[5]=(1-(d+g))*E,n[6]=(m+M)*E,n[7]=0,n[8]=(p+w)*_,n[9]=(m-M)*_,n[10]=(1-(d+y))*_,n[11]=0,n[12]=t.x,n[13]=t.y,n[14]=t.z,n[15]=1,this}decompose(t,e,i){let n=this.elements;t.x=n[12],t.y=n[13],t.z=n[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let a=fs.set(n[0],n[1],n[2]).length(),o=fs.set(n[4],n[5],n[6]).length(),l=fs.set(n[8],n[9],n[10]).length();r<0&&(a=-a),Ci.copy(this);let c=1/a,h=1/o,u=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=h,Ci.elements[5]*=h,Ci.elements[6]*=h,Ci.elements[8]*=u,Ci.elements[9]*=u,Ci.elements[10]*=u,e.setFromRotationMatrix(Ci),i.x=a,i.y=o,i.z=l,this}makePerspective(t,e,i,n,r,a,o=Mi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-n),d=(e+t)/(e-t),f=(i+n)/(i-n),p,y;if(l)p=r/(a-r),y=a*r/(a-r);else if(o===Mi)p=-(a+r)/(a-r),y=-2*a*r/(a-r);else if(o===Ls)p=-a/(a-r),y=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,n,r,a,o=Mi,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-n),d=-(e+t)/(e-t),f=-(i+n)/(i-n),p,y;if(l)p=1/(a-r),y=a/(a-r);else if(o===Mi)p=-2/(a-r),y=-(a+r)/(a-r);else if(o===Ls)p=-1/(a-r),y=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let n=0;n<16;n++)if(e[n]!==i[n])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},fs=new P,Ci=new fe,kg=new P(0,0,0),Bg=new P(1,1,1),vn=new P,Oa=new P,fi=new P,Wd=new fe,Xd=new je,rn=class s{constructor(t=0,e=0,i=0,n=s.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=n}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,n=this._order){return this._x=t,this._y=e,this._z=i,this._order=n,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let n=t.elements,r=n[0],a=n[4],o=n[8],l=n[1],c=n[5],h=n[9],u=n[2],d=n[6],f=n[10];switch(e){case"XYZ":this._y=Math.asin(jt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-jt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(jt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-jt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(jt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-jt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ft("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Wd.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Wd,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Xd.setFromEuler(this),this.setFromQuaternion(Xd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};rn.DEFAULT_ORDER="XYZ";var Ir=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},zg=0,$d=new P,ps=new je,Ki=new fe,Fa=new P,hr=new P,Gg=new P,Vg=new je,qd=new P(1,0,0),Yd=new P(0,1,0),Zd=new P(0,0,1),jd={type:"added"},Hg={type:"removed"},ms={type:"childadded",child:null},yh={type:"childremoved",child:null},Ke=class s extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:zg++}),this.uuid=dn(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=s.DEFAULT_UP.clone();let t=new P,e=new rn,i=new je,n=new P(1,1,1);function r(){i.setFromEuler(e,!1)}function a(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:n},modelViewMatrix:{value:new fe},normalMatrix:{value:new Ht}}),this.matrix=new fe,this.matrixWorld=new fe,this.matrixAutoUpdate=s.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=s.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ir,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ps.setFromAxisAngle(t,e),this.quaternion.multiply(ps),this}rotateOnWorldAxis(t,e){return ps.setFromAxisAngle(t,e),this.quaternion.premultiply(ps),this}rotateX(t){return this.rotateOnAxis(qd,t)}rotateY(t){return this.rotateOnAxis(Yd,t)}rotateZ(t){return this.rotateOnAxis(Zd,t)}translateOnAxis(t,e){return $d.copy(t).applyQuaternion(this.quaternion),this.position.add($d.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(qd,t)}translateY(t){return this.translateOnAxis(Yd,t)}translateZ(t){return this.translateOnAxis(Zd,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ki.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Fa.copy(t):Fa.set(t,e,i);let n=this.parent;this.updateWorldMatrix(!0,!1),hr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ki.lookAt(hr,Fa,this.up):Ki.lookAt(Fa,hr,this.up),this.quaternion.setFromRotationMatrix(Ki),n&&(Ki.extractRotation(n.matrixWorld),ps.setFromRotationMatrix(Ki),this.quaternion.premultiply(ps.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(zt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(jd),ms.child=t,this.dispatchEvent(ms),ms.child=null):zt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Hg),yh.child=t,this.dispatchEvent(yh),yh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ki.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ki.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ki),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(jd),ms.child=t,this.dispatchEvent(ms),ms.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,n=this.children.length;i<n;i++){let a=this.children[i].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let n=this.children;for(let r=0,a=n.length;r<a;r++)n[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(hr,t,Gg),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(hr,Vg,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,n=e.length;i<n;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,n=e.length;i<n;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,n=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*n,r[13]+=i-r[1]*e-r[5]*i-r[9]*n,r[14]+=n-r[2]*e-r[6]*i-r[10]*n}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,n=e.length;i<n;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let n={};n.uuid=this.uuid,n.type=this.type,n.name=this.name,n.castShadow=this.castShadow,n.receiveShadow=this.receiveShadow,n.visible=this.visible,n.frustumCulled=this.frustumCulled,n.renderOrder=this.renderOrder,n.static=this.static,n.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(n.userData=this.userData),n.layers=this.layers.mask,n.matrix=this.matrix.toArray(),n.up=this.up.toArray(),this.pivot!==null&&(n.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(n.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(n.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(n.type="InstancedMesh",n.count=this.count,n.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(n.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(n.type="BatchedMesh",n.perObjectFrustumCulled=this.perObjectFrustumCulled,n.sortObjects=this.sortObjects,n.drawRanges=this._drawRanges,n.reservedRanges=this._reservedRanges,n.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),n.instanceInfo=this._instanceInfo.map(o=>({...o})),n.availableInstanceIds=this._availableInstanceIds.slice(),n.availableGeometryIds=this._availableGeometryIds.slice(),n.nextIndexStart=this._nextIndexStart,n.nextVertexStart=this._nextVertexStart,n.geometryCount=this._geometryCount,n.maxInstanceCount=this._maxInstanceCount,n.maxVertexCount=this._maxVertexCount,n.maxIndexCount=this._maxIndexCount,n.geometryInitialized=this._geometryInitialized,n.matricesTexture=this._matricesTexture.toJSON(t),n.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(n.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(n.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(n.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?n.background=this.background.toJSON():this.background.isTexture&&(n.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(n.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){n.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(n.bindMode=this.bindMode,n.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),n.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(t.materials,this.material[l]));n.material=o}else n.material=r(t.materials,this.material);if(this.children.length>0){n.children=[];for(let o=0;o<this.children.length;o++)n.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){n.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];n.animations.push(r(t.animations,l))}}if(e){let o=a(t.geometries),l=a(t.materials),c=a(t.textures),h=a(t.images),u=a(t.shapes),d=a(t.skeletons),f=a(t.animations),p=a(t.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=n,i;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let n=t.children[i];this.add(n.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ke.DEFAULT_UP=new P(0,1,0);Ke.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ke.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fe=class extends Ke{constructor(){super(),this.isGroup=!0,this.type="Group"}},Wg={type:"move"},Fs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fe,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fe,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fe,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let n=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){a=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,i),g=this._getHandJoint(c,y);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(n=e.getPose(t.targetRaySpace,i),n===null&&r!==null&&(n=r),n!==null&&(o.matrix.fromArray(n.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,n.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(n.linearVelocity)):o.hasLinearVelocity=!1,n.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(n.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Wg)))}return o!==null&&(o.visible=n!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Fe;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},op={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},bn={h:0,s:0,l:0},ka={h:0,s:0,l:0};function vh(s,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?s+(t-s)*6*e:e<1/2?t:e<2/3?s+(t-s)*6*(2/3-e):s}var Nt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let n=t;n&&n.isColor?this.copy(n):typeof n=="number"?this.setHex(n):typeof n=="string"&&this.setStyle(n)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=mi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ae.colorSpaceToWorking(this,e),this}setRGB(t,e,i,n=ae.workingColorSpace){return this.r=t,this.g=e,this.b=i,ae.colorSpaceToWorking(this,n),this}setHSL(t,e,i,n=ae.workingColorSpace){if(t=wu(t,1),e=jt(e,0,1),i=jt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,a=2*i-r;this.r=vh(a,r,t+1/3),this.g=vh(a,r,t),this.b=vh(a,r,t-1/3)}return ae.colorSpaceToWorking(this,n),this}setStyle(t,e=mi){function i(r){r!==void 0&&parseFloat(r)<1&&Ft("Color: Alpha component of "+t+" will be ignored.")}let n;if(n=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=n[1],o=n[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Ft("Color: Unknown color model "+t)}}else if(n=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=n[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Ft("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=mi){let i=op[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Ft("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=nn(t.r),this.g=nn(t.g),this.b=nn(t.b),this}copyLinearToSRGB(t){return this.r=Is(t.r),this.g=Is(t.g),this.b=Is(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=mi){return ae.workingToColorSpace(ei.copy(this),t),Math.round(jt(ei.r*255,0,255))*65536+Math.round(jt(ei.g*255,0,255))*256+Math.round(jt(ei.b*255,0,255))}getHexString(t=mi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ae.workingColorSpace){ae.workingToColorSpace(ei.copy(this),e);let i=ei.r,n=ei.g,r=ei.b,a=Math.max(i,n,r),o=Math.min(i,n,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case i:l=(n-r)/u+(n<r?6:0);break;case n:l=(r-i)/u+2;break;case r:l=(i-n)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ae.workingColorSpace){return ae.workingToColorSpace(ei.copy(this),e),t.r=ei.r,t.g=ei.g,t.b=ei.b,t}getStyle(t=mi){ae.workingToColorSpace(ei.copy(this),t);let e=ei.r,i=ei.g,n=ei.b;return t!==mi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${n.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(n*255)})`}offsetHSL(t,e,i){return this.getHSL(bn),this.setHSL(bn.h+t,bn.s+e,bn.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(bn),t.getHSL(ka);let i=Mr(bn.h,ka.h,e),n=Mr(bn.s,ka.s,e),r=Mr(bn.l,ka.l,e);return this.setHSL(i,n,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,n=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*n,this.g=r[1]*e+r[4]*i+r[7]*n,this.b=r[2]*e+r[5]*i+r[8]*n,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ei=new Nt;Nt.NAMES=op;var qn=class extends Ke{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new rn,this.environmentIntensity=1,this.environmentRotation=new rn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ri=new P,Ji=new P,bh=new P,Qi=new P,gs=new P,xs=new P,Kd=new P,Mh=new P,Sh=new P,wh=new P,Th=new Ae,Eh=new Ae,Ah=new Ae,ki=class s{constructor(t=new P,e=new P,i=new P){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,n){n.subVectors(i,e),Ri.subVectors(t,e),n.cross(Ri);let r=n.lengthSq();return r>0?n.multiplyScalar(1/Math.sqrt(r)):n.set(0,0,0)}static getBarycoord(t,e,i,n,r){Ri.subVectors(n,e),Ji.subVectors(i,e),bh.subVectors(t,e);let a=Ri.dot(Ri),o=Ri.dot(Ji),l=Ri.dot(bh),c=Ji.dot(Ji),h=Ji.dot(bh),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-o*h)*d,p=(a*h-o*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,n){return this.getBarycoord(t,e,i,n,Qi)===null?!1:Qi.x>=0&&Qi.y>=0&&Qi.x+Qi.y<=1}static getInterpolation(t,e,i,n,r,a,o,l){return this.getBarycoord(t,e,i,n,Qi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Qi.x),l.addScaledVector(a,Qi.y),l.addScaledVector(o,Qi.z),l)}static getInterpolatedAttribute(t,e,i,n,r,a){return Th.setScalar(0),Eh.setScalar(0),Ah.setScalar(0),Th.fromBufferAttribute(t,e),Eh.fromBufferAttribute(t,i),Ah.fromBufferAttribute(t,n),a.setScalar(0),a.addScaledVector(Th,r.x),a.addScaledVector(Eh,r.y),a.addScaledVector(Ah,r.z),a}static isFrontFacing(t,e,i,n){return Ri.subVectors(i,e),Ji.subVectors(t,e),Ri.cross(Ji).dot(n)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,n){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[n]),this}setFromAttributeAndIndices(t,e,i,n){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,n),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),Ji.subVectors(this.a,this.b),Ri.cross(Ji).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return s.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return s.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,n,r){return s.getInterpolation(t,this.a,this.b,this.c,e,i,n,r)}containsPoint(t){return s.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return s.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,n=this.b,r=this.c,a,o;gs.subVectors(n,i),xs.subVectors(r,i),Mh.subVectors(t,i);let l=gs.dot(Mh),c=xs.dot(Mh);if(l<=0&&c<=0)return e.copy(i);Sh.subVectors(t,n);let h=gs.dot(Sh),u=xs.dot(Sh);if(h>=0&&u<=h)return e.copy(n);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),e.copy(i).addScaledVector(gs,a);wh.subVectors(t,r);let f=gs.dot(wh),p=xs.dot(wh);if(p>=0&&f<=p)return e.copy(r);let y=f*c-l*p;if(y<=0&&c>=0&&p<=0)return o=c/(c-p),e.copy(i).addScaledVector(xs,o);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Kd.subVectors(r,n),o=(u-h)/(u-h+(f-p)),e.copy(n).addScaledVector(Kd,o);let g=1/(m+y+d);return a=y*g,o=d*g,e.copy(i).addScaledVector(gs,a).addScaledVector(xs,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zi=class{constructor(t=new P(1/0,1/0,1/0),e=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,Pi):Pi.fromBufferAttribute(r,a),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ba.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ba.copy(i.boundingBox)),Ba.applyMatrix4(t.matrixWorld),this.union(Ba)}let n=t.children;for(let r=0,a=n.length;r<a;r++)this.expandByObject(n[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ur),za.subVectors(this.max,ur),_s.subVectors(t.a,ur),ys.subVectors(t.b,ur),vs.subVectors(t.c,ur),Mn.subVectors(ys,_s),Sn.subVectors(vs,ys),Vn.subVectors(_s,vs);let e=[0,-Mn.z,Mn.y,0,-Sn.z,Sn.y,0,-Vn.z,Vn.y,Mn.z,0,-Mn.x,Sn.z,0,-Sn.x,Vn.z,0,-Vn.x,-Mn.y,Mn.x,0,-Sn.y,Sn.x,0,-Vn.y,Vn.x,0];return!Ch(e,_s,ys,vs,za)||(e=[1,0,0,0,1,0,0,0,1],!Ch(e,_s,ys,vs,za))?!1:(Ga.crossVectors(Mn,Sn),e=[Ga.x,Ga.y,Ga.z],Ch(e,_s,ys,vs,za))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(tn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),tn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),tn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),tn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),tn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),tn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),tn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),tn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(tn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},tn=[new P,new P,new P,new P,new P,new P,new P,new P],Pi=new P,Ba=new zi,_s=new P,ys=new P,vs=new P,Mn=new P,Sn=new P,Vn=new P,ur=new P,za=new P,Ga=new P,Hn=new P;function Ch(s,t,e,i,n){for(let r=0,a=s.length-3;r<=a;r+=3){Hn.fromArray(s,r);let o=n.x*Math.abs(Hn.x)+n.y*Math.abs(Hn.y)+n.z*Math.abs(Hn.z),l=t.dot(Hn),c=e.dot(Hn),h=i.dot(Hn);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var Oe=new P,Va=new it,Xg=0,Ne=class extends Ii{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Xg++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=bu,this.updateRanges=[],this.gpuType=wi,this.version=0,this._normalizationScale=t!==void 0?Hl(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let n=0,r=this.itemSize;n<r;n++)this.array[t+n]=e.array[i+n];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Va.fromBufferAttribute(this,e),Va.applyMatrix3(t),this.setXY(e,Va.x,Va.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.applyMatrix3(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.applyMatrix4(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.applyNormalMatrix(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.transformDirection(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=n,this}setXYZW(t,e,i,n,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),n=this._normalize(n),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=n,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Eu(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Au(t,this.array)}};var Nr=class extends Ne{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Lr=class extends Ne{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var me=class extends Ne{constructor(t,e,i){super(new Float32Array(t),e,i)}},$g=new zi,dr=new P,Rh=new P,an=class{constructor(t=new P,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):$g.setFromPoints(t).getCenter(i);let n=0;for(let r=0,a=t.length;r<a;r++)n=Math.max(n,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(n),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;dr.subVectors(t,this.center);let e=dr.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),n=(i-this.radius)*.5;this.center.addScaledVector(dr,n/i),this.radius+=n}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Rh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(dr.copy(t.center).add(Rh)),this.expandByPoint(dr.copy(t.center).sub(Rh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},qg=0,bi=new fe,Ph=new Ke,bs=new P,pi=new zi,fr=new zi,$e=new P,Me=class s extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:qg++}),this.uuid=dn(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(_g(t)?Lr:Nr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ht().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let n=this.attributes.tangent;return n!==void 0&&(n.transformDirection(t),n.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return bi.makeRotationFromQuaternion(t),this.applyMatrix4(bi),this}rotateX(t){return bi.makeRotationX(t),this.applyMatrix4(bi),this}rotateY(t){return bi.makeRotationY(t),this.applyMatrix4(bi),this}rotateZ(t){return bi.makeRotationZ(t),this.applyMatrix4(bi),this}translate(t,e,i){return bi.makeTranslation(t,e,i),this.applyMatrix4(bi),this}scale(t,e,i){return bi.makeScale(t,e,i),this.applyMatrix4(bi),this}lookAt(t){return Ph.lookAt(t),Ph.updateMatrix(),this.applyMatrix4(Ph.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(bs).negate(),this.translate(bs.x,bs.y,bs.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let n=0,r=t.length;n<r;n++){let a=t[n];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new me(i,3))}else{let i=Math.min(t.length,e.count);for(let n=0;n<i;n++){let r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&Ft("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){zt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,n=e.length;i<n;i++){let r=e[i];pi.setFromBufferAttribute(r),this.morphTargetsRelative?($e.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint($e),$e.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint($e)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&zt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new an);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){zt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(t){let i=this.boundingSphere.center;if(pi.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];fr.setFromBufferAttribute(o),this.morphTargetsRelative?($e.addVectors(pi.min,fr.min),pi.expandByPoint($e),$e.addVectors(pi.max,fr.max),pi.expandByPoint($e)):(pi.expandByPoint(fr.min),pi.expandByPoint(fr.max))}pi.getCenter(i);let n=0;for(let r=0,a=t.count;r<a;r++)$e.fromBufferAttribute(t,r),n=Math.max(n,i.distanceToSquared($e));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)$e.fromBufferAttribute(o,c),l&&(bs.fromBufferAttribute(t,c),$e.add(bs)),n=Math.max(n,i.distanceToSquared($e))}this.boundingSphere.radius=Math.sqrt(n),isNaN(this.boundingSphere.radius)&&zt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){zt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,n=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new Ne(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(i.count);for(let O=0;O<i.count;O++)o[O]=new P,l[O]=new P;let h=new P,u=new P,d=new P,f=new it,p=new it,y=new it,m=new P,g=new P;function M(O,R,U){c[O]=c[R]=c[U]=1,h.fromBufferAttribute(i,O),u.fromBufferAttribute(i,R),d.fromBufferAttribute(i,U),f.fromBufferAttribute(r,O),p.fromBufferAttribute(r,R),y.fromBufferAttribute(r,U),u.sub(h),d.sub(h),p.sub(f),y.sub(f);let F=1/(p.x*y.y-y.x*p.y);isFinite(F)&&(m.copy(u).multiplyScalar(y.y).addScaledVector(d,-p.y).multiplyScalar(F),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-y.x).multiplyScalar(F),o[O].add(m),o[R].add(m),o[U].add(m),l[O].add(g),l[R].add(g),l[U].add(g))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let O=0,R=w.length;O<R;++O){let U=w[O],F=U.start,W=U.count;for(let N=F,G=F+W;N<G;N+=3)M(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let b=new P,C=new P,E=new P,_=new P;function T(O){E.fromBufferAttribute(n,O),_.copy(E);let R=o[O];b.copy(R),b.sub(E.multiplyScalar(E.dot(R))).normalize(),C.crossVectors(_,R);let F=C.dot(l[O])<0?-1:1;a.setXYZW(O,b.x,b.y,b.z,F)}for(let O=0,R=i.count;O<R;++O)c[O]&&T(O);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Ne(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let n=new P,r=new P,a=new P,o=new P,l=new P,c=new P,h=new P,u=new P;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),y=t.getX(d+1),m=t.getX(d+2);n.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),a.fromBufferAttribute(e,m),h.subVectors(a,r),u.subVectors(n,r),h.cross(u),o.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,m),o.add(h),l.add(h),c.add(h),i.setXYZ(p,o.x,o.y,o.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)n.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),u.subVectors(n,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)$e.fromBufferAttribute(t,e),$e.normalize(),t.setXYZ(e,$e.x,$e.y,$e.z)}toNonIndexed(){function t(o,l){let c=o.array,h=o.itemSize,u=o.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let y=0,m=l.length;y<m;y++){o.isInterleavedBufferAttribute?f=l[y]*o.data.stride+o.offset:f=l[y]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new Ne(d,h,u)}if(this.index===null)return Ft("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new s,i=this.index.array,n=this.attributes;for(let o in n){let l=n[o],c=t(l,i);e.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,i);l.push(f)}e.morphAttributes[o]=l}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let n={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(n[l]=h,r=!0)}r&&(t.data.morphAttributes=n,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let n=t.attributes;for(let c in n){let h=n[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let c=0,h=a.length;c<h;c++){let u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ro=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=bu,this.updateRanges=[],this.version=0,this.uuid=dn()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let n=0,r=this.stride;n<r;n++)this.array[t+n]=e.array[i+n];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Jd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),n=new this.constructor(i,this.stride);return n.setUsage(this.usage),n}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Jd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Jd(s){return s.buffer._uuid===void 0&&(s.buffer._uuid=dn()),s.byteOffset===0&&s.byteLength===s.buffer.byteLength?s.buffer._uuid:s.buffer._uuid+":"+s.byteOffset+":"+s.byteLength}var ri=new P,Dr=class s{constructor(t,e,i,n=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=n,this._normalizationScale=t!==void 0?Hl(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ri.fromBufferAttribute(this,e),ri.applyMatrix4(t),this.setXYZ(e,ri.x,ri.y,ri.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ri.fromBufferAttribute(this,e),ri.applyNormalMatrix(t),this.setXYZ(e,ri.x,ri.y,ri.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ri.fromBufferAttribute(this,e),ri.transformDirection(t),this.setXYZ(e,ri.x,ri.y,ri.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=n,this}setXYZW(t,e,i,n,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),n=this._normalize(n),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=n,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Rr("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let n=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[n+r])}return new Ne(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new s(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Rr("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let n=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[n+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Eu(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Au(t,this.data.array)}},Ih=new P,Yg=new P,Zg=new Ht,gi=class{constructor(t=new P(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,n){return this.normal.set(t,e,i),this.constant=n,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let n=Ih.subVectors(i,e).cross(Yg.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(n,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let n=t.delta(Ih),r=this.normal.dot(n);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(n,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Zg.getNormalMatrix(t),n=this.coplanarPoint(Ih).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-n.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},jg=0,Gi=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:jg++}),this.uuid=dn(),this.name="",this.type="Material",this.blending=qs,this.side=Pn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=iu,this.blendDst=nu,this.blendEquation=es,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Nt(0,0,0),this.blendAlpha=0,this.depthFunc=Ns,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Kf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=mo,this.stencilZFail=mo,this.stencilZPass=mo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Ft(`Material: parameter '${e}' has value of undefined.`);continue}let n=this[e];if(n===void 0){Ft(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}n&&n.isColor?n.set(i):n&&n.isVector2&&i&&i.isVector2||n&&n.isEuler&&i&&i.isEuler||n&&n.isVector3&&i&&i.isVector3?n.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function n(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(e){let r=n(t.textures),a=n(t.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Nt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new gi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new it().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let n=e.length;i=new Array(n);for(let r=0;r!==n;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},ks=class extends Gi{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Nt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Ms,pr=new P,Ss=new P,ws=new P,Ts=new it,mr=new it,lp=new fe,Ha=new P,gr=new P,Wa=new P,Qd=new it,Nh=new it,tf=new it,Ur=class extends Ke{constructor(t=new ks){if(super(),this.isSprite=!0,this.type="Sprite",Ms===void 0){Ms=new Me;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Ro(e,5);Ms.setIndex([0,1,2,0,2,3]),Ms.setAttribute("position",new Dr(i,3,0,!1)),Ms.setAttribute("uv",new Dr(i,2,3,!1))}this.geometry=Ms,this.material=t,this.center=new it(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&zt('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Ss.setFromMatrixScale(this.matrixWorld),lp.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),ws.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Ss.multiplyScalar(-ws.z);let i=this.material.rotation,n,r;i!==0&&(r=Math.cos(i),n=Math.sin(i));let a=this.center;Xa(Ha.set(-.5,-.5,0),ws,a,Ss,n,r),Xa(gr.set(.5,-.5,0),ws,a,Ss,n,r),Xa(Wa.set(.5,.5,0),ws,a,Ss,n,r),Qd.set(0,0),Nh.set(1,0),tf.set(1,1);let o=t.ray.intersectTriangle(Ha,gr,Wa,!1,pr);if(o===null&&(Xa(gr.set(-.5,.5,0),ws,a,Ss,n,r),Nh.set(0,1),o=t.ray.intersectTriangle(Ha,Wa,gr,!1,pr),o===null))return;let l=t.ray.origin.distanceTo(pr);l<t.near||l>t.far||e.push({distance:l,point:pr.clone(),uv:ki.getInterpolation(pr,Ha,gr,Wa,Qd,Nh,tf,new it),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Xa(s,t,e,i,n,r){Ts.subVectors(s,e).addScalar(.5).multiply(i),n!==void 0?(mr.x=r*Ts.x-n*Ts.y,mr.y=n*Ts.x+r*Ts.y):mr.copy(Ts),s.copy(t),s.x+=mr.x,s.y+=mr.y,s.applyMatrix4(lp)}var en=new P,Lh=new P,$a=new P,qa=new P,Yn=class{constructor(t=new P,e=new P(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,en)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=en.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(en.copy(this.origin).addScaledVector(this.direction,e),en.distanceToSquared(t))}distanceSqToSegment(t,e,i,n){Lh.copy(t).add(e).multiplyScalar(.5),$a.copy(e).sub(t).normalize(),qa.copy(this.origin).sub(Lh);let r=t.distanceTo(e)*.5,a=-this.direction.dot($a),o=qa.dot(this.direction),l=-qa.dot($a),c=qa.lengthSq(),h=Math.abs(1-a*a),u,d,f,p;if(h>0)if(u=a*l-o,d=a*o-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let y=1/h;u*=y,d*=y,f=u*(u+a*d+2*o)+d*(a*u+d+2*l)+c}else d=r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-a*r+o)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(a*r+o)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=a>0?-r:r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),n&&n.copy(Lh).addScaledVector($a,d),f}intersectSphere(t,e){if(t.radius<0)return null;en.subVectors(t.center,this.origin);let i=en.dot(this.direction),n=en.dot(en)-i*i,r=t.radius*t.radius;if(n>r)return null;let a=Math.sqrt(r-n),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,n,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,n=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,n=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),i>a||r>n||((r>i||isNaN(i))&&(i=r),(a<n||isNaN(n))&&(n=a),u>=0?(o=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(o=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||o>n)||((o>i||i!==i)&&(i=o),(l<n||n!==n)&&(n=l),n<0)?null:this.at(i>=0?i:n,e)}intersectsBox(t){return this.intersectBox(t,en)!==null}intersectTriangle(t,e,i,n,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,u=t.x-a.x,d=t.y-a.y,f=t.z-a.z,p=e.x-a.x,y=e.y-a.y,m=e.z-a.z,g=i.x-a.x,M=i.y-a.y,w=i.z-a.z,b=Math.abs(l),C=Math.abs(c),E=Math.abs(h),_,T,O,R,U,F,W,N,G,$,V,nt;if(b>=C&&b>=E?(O=l,F=u,G=p,nt=g,l>=0?(_=c,T=h,R=d,U=f,W=y,N=m,$=M,V=w):(_=h,T=c,R=f,U=d,W=m,N=y,$=w,V=M)):C>=E?(O=c,F=d,G=y,nt=M,c>=0?(_=h,T=l,R=f,U=u,W=m,N=p,$=w,V=g):(_=l,T=h,R=u,U=f,W=p,N=m,$=g,V=w)):(O=h,F=f,G=m,nt=w,h>=0?(_=l,T=c,R=u,U=d,W=p,N=y,$=g,V=M):(_=c,T=l,R=d,U=u,W=y,N=p,$=M,V=g)),O===0)return null;let X=_/O,Q=T/O,et=1/O,wt=R-X*F,kt=U-Q*F,Y=W-X*G,_t=N-Q*G,Tt=$-X*nt,Dt=V-Q*nt,yt=Tt*_t-Dt*Y,Ut=wt*Dt-kt*Tt,Se=Y*kt-_t*wt;if(n){if(yt<0||Ut<0||Se<0)return null}else if((yt<0||Ut<0||Se<0)&&(yt>0||Ut>0||Se>0))return null;let Bt=yt+Ut+Se;if(Bt===0)return null;let Jt=et*(yt*F+Ut*G+Se*nt);return(Bt>0?Jt<0:Jt>0)?null:this.at(Jt/Bt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Vi=class extends Gi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rn,this.combine=el,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},ef=new fe,Wn=new Yn,Ya=new an,nf=new P,Za=new P,ja=new P,Ka=new P,Dh=new P,Ja=new P,sf=new P,Qa=new P,Pe=class extends Ke{constructor(t=new Me,e=new Vi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let n=e[i[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=n.length;r<a;r++){let o=n[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let i=this.geometry,n=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;e.fromBufferAttribute(n,t);let o=this.morphTargetInfluences;if(r&&o){Ja.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],u=r[l];h!==0&&(Dh.fromBufferAttribute(u,t),a?Ja.addScaledVector(Dh,h):Ja.addScaledVector(Dh.sub(e),h))}e.add(Ja)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,n=this.material,r=this.matrixWorld;n!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ya.copy(i.boundingSphere),Ya.applyMatrix4(r),Wn.copy(t.ray).recast(t.near),!(Ya.containsPoint(Wn.origin)===!1&&(Wn.intersectSphere(Ya,nf)===null||Wn.origin.distanceToSquared(nf)>(t.far-t.near)**2))&&(ef.copy(r).invert(),Wn.copy(t.ray).applyMatrix4(ef),!(i.boundingBox!==null&&Wn.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Wn)))}_computeIntersections(t,e,i){let n,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let p=0,y=d.length;p<y;p++){let m=d[p],g=a[m.materialIndex],M=Math.max(m.start,f.start),w=Math.min(o.count,Math.min(m.start+m.count,f.start+f.count));for(let b=M,C=w;b<C;b+=3){let E=o.getX(b),_=o.getX(b+1),T=o.getX(b+2);n=to(this,g,t,i,c,h,u,E,_,T),n&&(n.faceIndex=Math.floor(b/3),n.face.materialIndex=m.materialIndex,e.push(n))}}else{let p=Math.max(0,f.start),y=Math.min(o.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let M=o.getX(m),w=o.getX(m+1),b=o.getX(m+2);n=to(this,a,t,i,c,h,u,M,w,b),n&&(n.faceIndex=Math.floor(m/3),e.push(n))}}else if(l!==void 0)if(Array.isArray(a))for(let p=0,y=d.length;p<y;p++){let m=d[p],g=a[m.materialIndex],M=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=M,C=w;b<C;b+=3){let E=b,_=b+1,T=b+2;n=to(this,g,t,i,c,h,u,E,_,T),n&&(n.faceIndex=Math.floor(b/3),n.face.materialIndex=m.materialIndex,e.push(n))}}else{let p=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=p,g=y;m<g;m+=3){let M=m,w=m+1,b=m+2;n=to(this,a,t,i,c,h,u,M,w,b),n&&(n.faceIndex=Math.floor(m/3),e.push(n))}}}};function Kg(s,t,e,i,n,r,a,o){let l;if(t.side===ke?l=i.intersectTriangle(a,r,n,!0,o):l=i.intersectTriangle(n,r,a,t.side===Pn,o),l===null)return null;Qa.copy(o),Qa.applyMatrix4(s.matrixWorld);let c=e.ray.origin.distanceTo(Qa);return c<e.near||c>e.far?null:{distance:c,point:Qa.clone(),object:s}}function to(s,t,e,i,n,r,a,o,l,c){s.getVertexPosition(o,Za),s.getVertexPosition(l,ja),s.getVertexPosition(c,Ka);let h=Kg(s,t,e,i,Za,ja,Ka,sf);if(h){let u=new P;ki.getBarycoord(sf,Za,ja,Ka,u),n&&(h.uv=ki.getInterpolatedAttribute(n,o,l,c,u,new it)),r&&(h.uv1=ki.getInterpolatedAttribute(r,o,l,c,u,new it)),a&&(h.normal=ki.getInterpolatedAttribute(a,o,l,c,u,new P),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:l,c,normal:new P,materialIndex:0};ki.getNormal(Za,ja,Ka,d.normal),h.face=d,h.barycoord=u}return h}var Or=class extends oi{constructor(t=null,e=1,i=1,n,r,a,o,l,c=qe,h=qe,u,d){super(null,a,o,l,c,h,n,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zn=class extends Ne{constructor(t,e,i,n=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Es=new fe,rf=new fe,eo=[],af=new zi,Jg=new fe,xr=new Pe,_r=new an,Hi=class extends Pe{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Zn(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let n=0;n<i;n++)this.setMatrixAt(n,Jg)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new zi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Es),af.copy(t.boundingBox).applyMatrix4(Es),this.boundingBox.union(af)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new an),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Es),_r.copy(t.boundingSphere).applyMatrix4(Es),this.boundingSphere.union(_r)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,n=this.morphTexture.source.data.data,r=i.length+1,a=t*r+1;for(let o=0;o<i.length;o++)i[o]=n[a+o]}raycast(t,e){let i=this.matrixWorld,n=this.count;if(xr.geometry=this.geometry,xr.material=this.material,xr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),_r.copy(this.boundingSphere),_r.applyMatrix4(i),t.ray.intersectsSphere(_r)!==!1))for(let r=0;r<n;r++){this.getMatrixAt(r,Es),rf.multiplyMatrices(i,Es),xr.matrixWorld=rf,xr.raycast(t,eo);for(let a=0,o=eo.length;a<o;a++){let l=eo[a];l.instanceId=r,l.object=this,e.push(l)}eo.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Zn(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,n=i.length+1;this.morphTexture===null&&(this.morphTexture=new Or(new Float32Array(n*this.count),n,this.count,ll,wi));let r=this.morphTexture.source.data.data,a=0;for(let c=0;c<i.length;c++)a+=i[c];let o=this.geometry.morphTargetsRelative?1:1-a,l=n*t;return r[l]=o,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Xn=new an,Qg=new it(.5,.5),io=new P,Tn=class{constructor(t=new gi,e=new gi,i=new gi,n=new gi,r=new gi,a=new gi){this.planes=[t,e,i,n,r,a]}set(t,e,i,n,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(i),o[3].copy(n),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Mi,i=!1){let n=this.planes,r=t.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],y=r[9],m=r[10],g=r[11],M=r[12],w=r[13],b=r[14],C=r[15];if(n[0].setComponents(c-a,f-h,g-p,C-M).normalize(),n[1].setComponents(c+a,f+h,g+p,C+M).normalize(),n[2].setComponents(c+o,f+u,g+y,C+w).normalize(),n[3].setComponents(c-o,f-u,g-y,C-w).normalize(),i)n[4].setComponents(l,d,m,b).normalize(),n[5].setComponents(c-l,f-d,g-m,C-b).normalize();else if(n[4].setComponents(c-l,f-d,g-m,C-b).normalize(),e===Mi)n[5].setComponents(c+l,f+d,g+m,C+b).normalize();else if(e===Ls)n[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Xn.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Xn.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Xn)}intersectsSprite(t){Xn.center.set(0,0,0);let e=Qg.distanceTo(t.center);return Xn.radius=.7071067811865476+e,Xn.applyMatrix4(t.matrixWorld),this.intersectsSphere(Xn)}intersectsSphere(t){let e=this.planes,i=t.center,n=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<n)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let n=e[i];if(io.x=n.normal.x>0?t.max.x:t.min.x,io.y=n.normal.y>0?t.max.y:t.min.y,io.z=n.normal.z>0?t.max.z:t.min.z,n.distanceToPoint(io)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},of=new fe,Po=class s{constructor(){this.coordinateSystem=Mi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let n=0;n<e.length;n++){let r=e[n];of.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[n]===void 0&&(i[n]=new Tn),i[n].setFromProjectionMatrix(of,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let n=0;n<t._count;n++)e[n]===void 0&&(e[n]=new Tn),e[n].copy(i[n]);return this._count=t._count,this}clone(){return new s().copy(this)}};var li=class extends Gi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Nt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Io=new P,No=new P,lf=new fe,yr=new Yn,no=new an,Uh=new P,cf=new P,Bs=class extends Ke{constructor(t=new Me,e=new li){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let n=1,r=e.count;n<r;n++)Io.fromBufferAttribute(e,n-1),No.fromBufferAttribute(e,n),i[n]=i[n-1],i[n]+=Io.distanceTo(No);t.setAttribute("lineDistance",new me(i,1))}else Ft("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,n=this.matrixWorld,r=t.params.Line.threshold,a=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),no.copy(i.boundingSphere),no.applyMatrix4(n),no.radius+=r,t.ray.intersectsSphere(no)===!1)return;lf.copy(n).invert(),yr.copy(t.ray).applyMatrix4(lf);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,a.start),p=Math.min(h.count,a.start+a.count);for(let y=f,m=p-1;y<m;y+=c){let g=h.getX(y),M=h.getX(y+1),w=so(this,t,yr,l,g,M,y);w&&e.push(w)}if(this.isLineLoop){let y=h.getX(p-1),m=h.getX(f),g=so(this,t,yr,l,y,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,a.start),p=Math.min(d.count,a.start+a.count);for(let y=f,m=p-1;y<m;y+=c){let g=so(this,t,yr,l,y,y+1,y);g&&e.push(g)}if(this.isLineLoop){let y=so(this,t,yr,l,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let n=e[i[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=n.length;r<a;r++){let o=n[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function so(s,t,e,i,n,r,a){let o=s.geometry.attributes.position;if(Io.fromBufferAttribute(o,n),No.fromBufferAttribute(o,r),e.distanceSqToSegment(Io,No,Uh,cf)>i)return;Uh.applyMatrix4(s.matrixWorld);let c=t.ray.origin.distanceTo(Uh);if(!(c<t.near||c>t.far))return{distance:c,point:cf.clone().applyMatrix4(s.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:s}}var hf=new P,uf=new P,Si=class extends Bs{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let n=0,r=e.count;n<r;n+=2)hf.fromBufferAttribute(e,n),uf.fromBufferAttribute(e,n+1),i[n]=n===0?0:i[n-1],i[n+1]=i[n]+hf.distanceTo(uf);t.setAttribute("lineDistance",new me(i,1))}else Ft("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Fr=class extends oi{constructor(t=[],e=is,i,n,r,a,o,l,c,h){super(t,e,i,n,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},kr=class extends oi{constructor(t,e,i,n,r,a,o,l,c){super(t,e,i,n,r,a,o,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var on=class extends oi{constructor(t,e,i=Ni,n,r,a,o=qe,l=qe,c,h=sn,u=1){if(h!==sn&&h!==hn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,n,r,a,o,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Os(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Br=class extends on{constructor(t,e=Ni,i=is,n,r,a=qe,o=qe,l,c=sn){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,n,r,a,o,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},zr=class extends oi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},En=class s extends Me{constructor(t=1,e=1,i=1,n=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:n,heightSegments:r,depthSegments:a};let o=this;n=Math.floor(n),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,a,r,0),p("z","y","x",1,-1,i,e,-t,a,r,1),p("x","z","y",1,1,t,i,e,n,a,2),p("x","z","y",1,-1,t,i,-e,n,a,3),p("x","y","z",1,-1,t,e,i,n,r,4),p("x","y","z",-1,-1,t,e,-i,n,r,5),this.setIndex(l),this.setAttribute("position",new me(c,3)),this.setAttribute("normal",new me(h,3)),this.setAttribute("uv",new me(u,2));function p(y,m,g,M,w,b,C,E,_,T,O){let R=b/_,U=C/T,F=b/2,W=C/2,N=E/2,G=_+1,$=T+1,V=0,nt=0,X=new P;for(let Q=0;Q<$;Q++){let et=Q*U-W;for(let wt=0;wt<G;wt++){let kt=wt*R-F;X[y]=kt*M,X[m]=et*w,X[g]=N,c.push(X.x,X.y,X.z),X[y]=0,X[m]=0,X[g]=E>0?1:-1,h.push(X.x,X.y,X.z),u.push(wt/_),u.push(1-Q/T),V+=1}}for(let Q=0;Q<T;Q++)for(let et=0;et<_;et++){let wt=d+et+G*Q,kt=d+et+G*(Q+1),Y=d+(et+1)+G*(Q+1),_t=d+(et+1)+G*Q;l.push(wt,kt,_t),l.push(kt,Y,_t),nt+=6}o.addGroup(f,nt,O),f+=nt,d+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ln=class s extends Me{constructor(t=1,e=1,i=1,n=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:n,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;n=Math.floor(n),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,y=[],m=i/2,g=0;M(),a===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new me(u,3)),this.setAttribute("normal",new me(d,3)),this.setAttribute("uv",new me(f,2));function M(){let b=new P,C=new P,E=0,_=(e-t)/i;for(let T=0;T<=r;T++){let O=[],R=T/r,U=R*(e-t)+t;for(let F=0;F<=n;F++){let W=F/n,N=W*l+o,G=Math.sin(N),$=Math.cos(N);C.x=U*G,C.y=-R*i+m,C.z=U*$,u.push(C.x,C.y,C.z),b.set(G,_,$).normalize(),d.push(b.x,b.y,b.z),f.push(W,1-R),O.push(p++)}y.push(O)}for(let T=0;T<n;T++)for(let O=0;O<r;O++){let R=y[O][T],U=y[O+1][T],F=y[O+1][T+1],W=y[O][T+1];(t>0||O!==0)&&(h.push(R,U,W),E+=3),(e>0||O!==r-1)&&(h.push(U,F,W),E+=3)}c.addGroup(g,E,0),g+=E}function w(b){let C=p,E=new it,_=new P,T=0,O=b===!0?t:e,R=b===!0?1:-1;for(let F=1;F<=n;F++)u.push(0,m*R,0),d.push(0,R,0),f.push(.5,.5),p++;let U=p;for(let F=0;F<=n;F++){let N=F/n*l+o,G=Math.cos(N),$=Math.sin(N);_.x=O*$,_.y=m*R,_.z=O*G,u.push(_.x,_.y,_.z),d.push(0,R,0),E.x=G*.5+.5,E.y=$*.5*R+.5,f.push(E.x,E.y),p++}for(let F=0;F<n;F++){let W=C+F,N=U+F;b===!0?h.push(N,N+1,W):h.push(N+1,N,W),T+=3}c.addGroup(g,T,b===!0?1:2),g+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},zs=class s extends ln{constructor(t=1,e=1,i=32,n=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,i,n,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:n,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new s(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Lo=class s extends Me{constructor(t=[],e=[],i=1,n=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:n};let r=[],a=[];o(n),c(i),h(),this.setAttribute("position",new me(r,3)),this.setAttribute("normal",new me(r.slice(),3)),this.setAttribute("uv",new me(a,2)),n===0?this.computeVertexNormals():this.normalizeNormals();function o(M){let w=new P,b=new P,C=new P;for(let E=0;E<e.length;E+=3)f(e[E+0],w),f(e[E+1],b),f(e[E+2],C),l(w,b,C,M)}function l(M,w,b,C){let E=C+1,_=[];for(let T=0;T<=E;T++){_[T]=[];let O=M.clone().lerp(b,T/E),R=w.clone().lerp(b,T/E),U=E-T;for(let F=0;F<=U;F++)F===0&&T===E?_[T][F]=O:_[T][F]=O.clone().lerp(R,F/U)}for(let T=0;T<E;T++)for(let O=0;O<2*(E-T)-1;O++){let R=Math.floor(O/2);O%2===0?(d(_[T][R+1]),d(_[T+1][R]),d(_[T][R])):(d(_[T][R+1]),d(_[T+1][R+1]),d(_[T+1][R]))}}function c(M){let w=new P;for(let b=0;b<r.length;b+=3)w.x=r[b+0],w.y=r[b+1],w.z=r[b+2],w.normalize().multiplyScalar(M),r[b+0]=w.x,r[b+1]=w.y,r[b+2]=w.z}function h(){let M=new P;for(let w=0;w<r.length;w+=3){M.x=r[w+0],M.y=r[w+1],M.z=r[w+2];let b=m(M)/2/Math.PI+.5,C=g(M)/Math.PI+.5;a.push(b,1-C)}p(),u()}function u(){for(let M=0;M<a.length;M+=6){let w=a[M+0],b=a[M+2],C=a[M+4],E=Math.max(w,b,C),_=Math.min(w,b,C);E>.9&&_<.1&&(w<.2&&(a[M+0]+=1),b<.2&&(a[M+2]+=1),C<.2&&(a[M+4]+=1))}}function d(M){r.push(M.x,M.y,M.z)}function f(M,w){let b=M*3;w.x=t[b+0],w.y=t[b+1],w.z=t[b+2]}function p(){let M=new P,w=new P,b=new P,C=new P,E=new it,_=new it,T=new it;for(let O=0,R=0;O<r.length;O+=9,R+=6){M.set(r[O+0],r[O+1],r[O+2]),w.set(r[O+3],r[O+4],r[O+5]),b.set(r[O+6],r[O+7],r[O+8]),E.set(a[R+0],a[R+1]),_.set(a[R+2],a[R+3]),T.set(a[R+4],a[R+5]),C.copy(M).add(w).add(b).divideScalar(3);let U=m(C);y(E,R+0,M,U),y(_,R+2,w,U),y(T,R+4,b,U)}}function y(M,w,b,C){C<0&&M.x===1&&(a[w]=M.x-1),b.x===0&&b.z===0&&(a[w]=C/2/Math.PI+.5)}function m(M){return Math.atan2(M.z,-M.x)}function g(M){return Math.atan2(-M.y,Math.sqrt(M.x*M.x+M.z*M.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.vertices,t.indices,t.radius,t.detail)}};var ro=new P,ao=new P,Oh=new P,oo=new ki,Gr=class extends Me{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let n=Math.pow(10,4),r=Math.cos(Ps*e),a=t.getIndex(),o=t.getAttribute("position"),l=a?a.count:o.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){a?(c[0]=a.getX(p),c[1]=a.getX(p+1),c[2]=a.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:y,b:m,c:g}=oo;if(y.fromBufferAttribute(o,c[0]),m.fromBufferAttribute(o,c[1]),g.fromBufferAttribute(o,c[2]),oo.getNormal(Oh),u[0]=`${Math.round(y.x*n)},${Math.round(y.y*n)},${Math.round(y.z*n)}`,u[1]=`${Math.round(m.x*n)},${Math.round(m.y*n)},${Math.round(m.z*n)}`,u[2]=`${Math.round(g.x*n)},${Math.round(g.y*n)},${Math.round(g.z*n)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let M=0;M<3;M++){let w=(M+1)%3,b=u[M],C=u[w],E=oo[h[M]],_=oo[h[w]],T=`${b}_${C}`,O=`${C}_${b}`,R=d.get(O);R?(Oh.dot(R.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(_.x,_.y,_.z)),d.set(O,null)):d.has(T)||d.set(T,{index0:c[M],index1:c[w],normal:Oh.clone()})}}for(let p of d.values())if(p){let{index0:y,index1:m}=p;ro.fromBufferAttribute(o,y),ao.fromBufferAttribute(o,m),f.push(ro.x,ro.y,ro.z),f.push(ao.x,ao.y,ao.z)}this.setAttribute("position",new me(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},_i=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ft("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,n=this.getPoint(0),r=0;e.push(0);for(let a=1;a<=t;a++)i=this.getPoint(a/t),r+=i.distanceTo(n),e.push(r),n=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),n=0,r=i.length,a;e?a=e:a=t*i[r-1];let o=0,l=r-1,c;for(;o<=l;)if(n=Math.floor(o+(l-o)/2),c=i[n]-a,c<0)o=n+1;else if(c>0)l=n-1;else{l=n;break}if(n=l,i[n]===a)return n/(r-1);let h=i[n],d=i[n+1]-h,f=(a-h)/d;return(n+f)/(r-1)}getTangent(t,e){let n=t-1e-4,r=t+1e-4;n<0&&(n=0),r>1&&(r=1);let a=this.getPoint(n),o=this.getPoint(r),l=e||(a.isVector2?new it:new P);return l.copy(o).sub(a).normalize(),l}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new P,n=[],r=[],a=[],o=new P,l=new fe;for(let f=0;f<=t;f++){let p=f/t;n[f]=this.getTangentAt(p,new P)}r[0]=new P,a[0]=new P;let c=Number.MAX_VALUE,h=Math.abs(n[0].x),u=Math.abs(n[0].y),d=Math.abs(n[0].z);h<=c&&(c=h,i.set(1,0,0)),u<=c&&(c=u,i.set(0,1,0)),d<=c&&i.set(0,0,1),o.crossVectors(n[0],i).normalize(),r[0].crossVectors(n[0],o),a[0].crossVectors(n[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),a[f]=a[f-1].clone(),o.crossVectors(n[f-1],n[f]),o.length()>Number.EPSILON){o.normalize();let p=Math.acos(jt(n[f-1].dot(n[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(o,p))}a[f].crossVectors(n[f],r[f])}if(e===!0){let f=Math.acos(jt(r[0].dot(r[t]),-1,1));f/=t,n[0].dot(o.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(n[p],f*p)),a[p].crossVectors(n[p],r[p])}return{tangents:n,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Gs=class extends _i{constructor(t=0,e=0,i=1,n=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=n,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(t,e=new it){let i=e,n=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=n;for(;r>n;)r-=n;r<Number.EPSILON&&(a?r=0:r=n),this.aClockwise===!0&&!a&&(r===n?r=-n:r=r-n);let o=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return i.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Do=class extends Gs{constructor(t,e,i,n,r,a){super(t,e,i,i,n,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function Ru(){let s=0,t=0,e=0,i=0;function n(r,a,o,l){s=r,t=o,e=-3*r+3*a-2*o-l,i=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){n(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,h,u){let d=(a-r)/c-(o-r)/(c+h)+(o-a)/h,f=(o-a)/h-(l-a)/(h+u)+(l-o)/u;d*=h,f*=h,n(a,o,d,f)},calc:function(r){let a=r*r,o=a*r;return s+t*r+e*a+i*o}}}var df=new P,ff=new P,Fh=new Ru,kh=new Ru,Bh=new Ru,Uo=class extends _i{constructor(t=[],e=!1,i="centripetal",n=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=n}getPoint(t,e=new P){let i=e,n=this.points,r=n.length,a=(r-(this.closed?0:1))*t,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,h;this.closed||o>0?c=n[(o-1)%r]:(ff.subVectors(n[0],n[1]).add(n[0]),c=ff);let u=n[o%r],d=n[(o+1)%r];if(this.closed||o+2<r?h=n[(o+2)%r]:(df.subVectors(n[r-1],n[r-2]).add(n[r-1]),h=df),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),y=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);y<1e-4&&(y=1),p<1e-4&&(p=y),m<1e-4&&(m=y),Fh.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,y,m),kh.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,y,m),Bh.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,y,m)}else this.curveType==="catmullrom"&&(Fh.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),kh.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Bh.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return i.set(Fh.calc(l),kh.calc(l),Bh.calc(l)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let n=t.points[e];this.points.push(n.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let n=this.points[e];t.points.push(n.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let n=t.points[e];this.points.push(new P().fromArray(n))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function pf(s,t,e,i,n){let r=(i-t)*.5,a=(n-e)*.5,o=s*s,l=s*o;return(2*e-2*i+r+a)*l+(-3*e+3*i-2*r-a)*o+r*s+e}function t0(s,t){let e=1-s;return e*e*t}function e0(s,t){return 2*(1-s)*s*t}function i0(s,t){return s*s*t}function Sr(s,t,e,i){return t0(s,t)+e0(s,e)+i0(s,i)}function n0(s,t){let e=1-s;return e*e*e*t}function s0(s,t){let e=1-s;return 3*e*e*s*t}function r0(s,t){return 3*(1-s)*s*s*t}function a0(s,t){return s*s*s*t}function wr(s,t,e,i,n){return n0(s,t)+s0(s,e)+r0(s,i)+a0(s,n)}var Vr=class extends _i{constructor(t=new it,e=new it,i=new it,n=new it){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=n}getPoint(t,e=new it){let i=e,n=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set(wr(t,n.x,r.x,a.x,o.x),wr(t,n.y,r.y,a.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Oo=class extends _i{constructor(t=new P,e=new P,i=new P,n=new P){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=n}getPoint(t,e=new P){let i=e,n=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set(wr(t,n.x,r.x,a.x,o.x),wr(t,n.y,r.y,a.y,o.y),wr(t,n.z,r.z,a.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Hr=class extends _i{constructor(t=new it,e=new it){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new it){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new it){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Fo=class extends _i{constructor(t=new P,e=new P){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new P){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new P){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Wr=class extends _i{constructor(t=new it,e=new it,i=new it){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new it){let i=e,n=this.v0,r=this.v1,a=this.v2;return i.set(Sr(t,n.x,r.x,a.x),Sr(t,n.y,r.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ko=class extends _i{constructor(t=new P,e=new P,i=new P){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new P){let i=e,n=this.v0,r=this.v1,a=this.v2;return i.set(Sr(t,n.x,r.x,a.x),Sr(t,n.y,r.y,a.y),Sr(t,n.z,r.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Xr=class extends _i{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new it){let i=e,n=this.points,r=(n.length-1)*t,a=Math.floor(r),o=r-a,l=n[a===0?a:a-1],c=n[a],h=n[a>n.length-2?n.length-1:a+1],u=n[a>n.length-3?n.length-1:a+2];return i.set(pf(o,l.x,c.x,h.x,u.x),pf(o,l.y,c.y,h.y,u.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let n=t.points[e];this.points.push(n.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let n=this.points[e];t.points.push(n.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let n=t.points[e];this.points.push(new it().fromArray(n))}return this}},Xh=Object.freeze({__proto__:null,ArcCurve:Do,CatmullRomCurve3:Uo,CubicBezierCurve:Vr,CubicBezierCurve3:Oo,EllipseCurve:Gs,LineCurve:Hr,LineCurve3:Fo,QuadraticBezierCurve:Wr,QuadraticBezierCurve3:ko,SplineCurve:Xr}),Bo=class extends _i{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let i=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Xh[i](e,t))}return this}getPoint(t,e){let i=t*this.getLength(),n=this.getCurveLengths(),r=0;for(;r<n.length;){if(n[r]>=i){let a=n[r]-i,o=this.curves[r],l=o.getLength(),c=l===0?0:1-a/l;return o.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let i=0,n=this.curves.length;i<n;i++)e+=this.curves[i].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],i;for(let n=0,r=this.curves;n<r.length;n++){let a=r[n],o=a.isEllipseCurve?t*2:a.isLineCurve||a.isLineCurve3?1:a.isSplineCurve?t*a.points.length:t,l=a.getPoints(o);for(let c=0;c<l.length;c++){let h=l[c];i&&i.equals(h)||(e.push(h),i=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let n=t.curves[e];this.curves.push(n.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,i=this.curves.length;e<i;e++){let n=this.curves[e];t.curves.push(n.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let n=t.curves[e];this.curves.push(new Xh[n.type]().fromJSON(n))}return this.cacheLengths=null,this}},$r=class extends Bo{constructor(t){super(),this.type="Path",this.currentPoint=new it,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,i=t.length;e<i;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let i=new Hr(this.currentPoint.clone(),new it(t,e));return this.curves.push(i),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,i,n){let r=new Wr(this.currentPoint.clone(),new it(t,e),new it(i,n));return this.curves.push(r),this.currentPoint.set(i,n),this}bezierCurveTo(t,e,i,n,r,a){let o=new Vr(this.currentPoint.clone(),new it(t,e),new it(i,n),new it(r,a));return this.curves.push(o),this.currentPoint.set(r,a),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),i=new Xr(e);return this.curves.push(i),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,i,n,r,a){let o=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+o,e+l,i,n,r,a),this}absarc(t,e,i,n,r,a){return this.absellipse(t,e,i,i,n,r,a),this}ellipse(t,e,i,n,r,a,o,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,i,n,r,a,o,l),this}absellipse(t,e,i,n,r,a,o,l){let c=new Gs(t,e,i,n,r,a,o,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},Vs=class extends $r{constructor(t){super(t),this.uuid=dn(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let i=0,n=this.holes.length;i<n;i++)e[i]=this.holes[i].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let n=t.holes[e];this.holes.push(n.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,i=this.holes.length;e<i;e++){let n=this.holes[e];t.holes.push(n.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let n=t.holes[e];this.holes.push(new $r().fromJSON(n))}return this}};function o0(s,t,e=2){let i=t&&t.length,n=i?t[0]*e:s.length,r=cp(s,0,n,e,!0),a=[];if(!r||r.next===r.prev)return a;let o,l,c;if(i&&(r=d0(s,t,r,e)),s.length>80*e){o=s[0],l=s[1];let h=o,u=l;for(let d=e;d<n;d+=e){let f=s[d],p=s[d+1];f<o&&(o=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-o,u-l),c=c!==0?32767/c:0}return qr(r,a,e,o,l,c,0),a}function cp(s,t,e,i,n){let r;if(n===S0(s,t,e,i)>0)for(let a=t;a<e;a+=i)r=mf(a/i|0,s[a],s[a+1],r);else for(let a=e-i;a>=t;a-=i)r=mf(a/i|0,s[a],s[a+1],r);return r&&Hs(r,r.next)&&(Zr(r),r=r.next),r}function jn(s,t){if(!s)return s;t||(t=s);let e=s,i;do if(i=!1,!e.steiner&&(Hs(e,e.next)||Re(e.prev,e,e.next)===0)){if(Zr(e),e=t=e.prev,e===e.next)break;i=!0}else e=e.next;while(i||e!==t);return t}function qr(s,t,e,i,n,r,a){if(!s)return;!a&&r&&x0(s,i,n,r);let o=s;for(;s.prev!==s.next;){let l=s.prev,c=s.next;if(r?c0(s,i,n,r):l0(s)){t.push(l.i,s.i,c.i),Zr(s),s=c.next,o=c.next;continue}if(s=c,s===o){a?a===1?(s=h0(jn(s),t),qr(s,t,e,i,n,r,2)):a===2&&u0(s,t,e,i,n,r):qr(jn(s),t,e,i,n,r,1);break}}}function l0(s){let t=s.prev,e=s,i=s.next;if(Re(t,e,i)>=0)return!1;let n=t.x,r=e.x,a=i.x,o=t.y,l=e.y,c=i.y,h=Math.min(n,r,a),u=Math.min(o,l,c),d=Math.max(n,r,a),f=Math.max(o,l,c),p=i.next;for(;p!==t;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&vr(n,o,r,l,a,c,p.x,p.y)&&Re(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function c0(s,t,e,i){let n=s.prev,r=s,a=s.next;if(Re(n,r,a)>=0)return!1;let o=n.x,l=r.x,c=a.x,h=n.y,u=r.y,d=a.y,f=Math.min(o,l,c),p=Math.min(h,u,d),y=Math.max(o,l,c),m=Math.max(h,u,d),g=$h(f,p,t,e,i),M=$h(y,m,t,e,i),w=s.prevZ,b=s.nextZ;for(;w&&w.z>=g&&b&&b.z<=M;){if(w.x>=f&&w.x<=y&&w.y>=p&&w.y<=m&&w!==n&&w!==a&&vr(o,h,l,u,c,d,w.x,w.y)&&Re(w.prev,w,w.next)>=0||(w=w.prevZ,b.x>=f&&b.x<=y&&b.y>=p&&b.y<=m&&b!==n&&b!==a&&vr(o,h,l,u,c,d,b.x,b.y)&&Re(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;w&&w.z>=g;){if(w.x>=f&&w.x<=y&&w.y>=p&&w.y<=m&&w!==n&&w!==a&&vr(o,h,l,u,c,d,w.x,w.y)&&Re(w.prev,w,w.next)>=0)return!1;w=w.prevZ}for(;b&&b.z<=M;){if(b.x>=f&&b.x<=y&&b.y>=p&&b.y<=m&&b!==n&&b!==a&&vr(o,h,l,u,c,d,b.x,b.y)&&Re(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function h0(s,t){let e=s;do{let i=e.prev,n=e.next.next;!Hs(i,n)&&up(i,e,e.next,n)&&Yr(i,n)&&Yr(n,i)&&(t.push(i.i,e.i,n.i),Zr(e),Zr(e.next),e=s=n),e=e.next}while(e!==s);return jn(e)}function u0(s,t,e,i,n,r){let a=s;do{let o=a.next.next;for(;o!==a.prev;){if(a.i!==o.i&&v0(a,o)){let l=dp(a,o);a=jn(a,a.next),l=jn(l,l.next),qr(a,t,e,i,n,r,0),qr(l,t,e,i,n,r,0);return}o=o.next}a=a.next}while(a!==s)}function d0(s,t,e,i){let n=[];for(let r=0,a=t.length;r<a;r++){let o=t[r]*i,l=r<a-1?t[r+1]*i:s.length,c=cp(s,o,l,i,!1);c===c.next&&(c.steiner=!0),n.push(y0(c))}n.sort(f0);for(let r=0;r<n.length;r++)e=p0(n[r],e);return e}function f0(s,t){let e=s.x-t.x;if(e===0&&(e=s.y-t.y,e===0)){let i=(s.next.y-s.y)/(s.next.x-s.x),n=(t.next.y-t.y)/(t.next.x-t.x);e=i-n}return e}function p0(s,t){let e=m0(s,t);if(!e)return t;let i=dp(e,s);return jn(i,i.next),jn(e,e.next)}function m0(s,t){let e=t,i=s.x,n=s.y,r=-1/0,a;if(Hs(s,e))return e;do{if(Hs(s,e.next))return e.next;if(n<=e.y&&n>=e.next.y&&e.next.y!==e.y){let u=e.x+(n-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=i&&u>r&&(r=u,a=e.x<e.next.x?e:e.next,u===i))return a}e=e.next}while(e!==t);if(!a)return null;let o=a,l=a.x,c=a.y,h=1/0;e=a;do{if(i>=e.x&&e.x>=l&&i!==e.x&&hp(n<c?i:r,n,l,c,n<c?r:i,n,e.x,e.y)){let u=Math.abs(n-e.y)/(i-e.x);Yr(e,s)&&(u<h||u===h&&(e.x>a.x||e.x===a.x&&g0(a,e)))&&(a=e,h=u)}e=e.next}while(e!==o);return a}function g0(s,t){return Re(s.prev,s,t.prev)<0&&Re(t.next,s,s.next)<0}function x0(s,t,e,i){let n=s;do n.z===0&&(n.z=$h(n.x,n.y,t,e,i)),n.prevZ=n.prev,n.nextZ=n.next,n=n.next;while(n!==s);n.prevZ.nextZ=null,n.prevZ=null,_0(n)}function _0(s){let t,e=1;do{let i=s,n;s=null;let r=null;for(t=0;i;){t++;let a=i,o=0;for(let c=0;c<e&&(o++,a=a.nextZ,!!a);c++);let l=e;for(;o>0||l>0&&a;)o!==0&&(l===0||!a||i.z<=a.z)?(n=i,i=i.nextZ,o--):(n=a,a=a.nextZ,l--),r?r.nextZ=n:s=n,n.prevZ=r,r=n;i=a}r.nextZ=null,e*=2}while(t>1);return s}function $h(s,t,e,i,n){return s=(s-e)*n|0,t=(t-i)*n|0,s=(s|s<<8)&16711935,s=(s|s<<4)&252645135,s=(s|s<<2)&858993459,s=(s|s<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,s|t<<1}function y0(s){let t=s,e=s;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==s);return e}function hp(s,t,e,i,n,r,a,o){return(n-a)*(t-o)>=(s-a)*(r-o)&&(s-a)*(i-o)>=(e-a)*(t-o)&&(e-a)*(r-o)>=(n-a)*(i-o)}function vr(s,t,e,i,n,r,a,o){return!(s===a&&t===o)&&hp(s,t,e,i,n,r,a,o)}function v0(s,t){return s.next.i!==t.i&&s.prev.i!==t.i&&!b0(s,t)&&(Yr(s,t)&&Yr(t,s)&&M0(s,t)&&(Re(s.prev,s,t.prev)||Re(s,t.prev,t))||Hs(s,t)&&Re(s.prev,s,s.next)>0&&Re(t.prev,t,t.next)>0)}function Re(s,t,e){return(t.y-s.y)*(e.x-t.x)-(t.x-s.x)*(e.y-t.y)}function Hs(s,t){return s.x===t.x&&s.y===t.y}function up(s,t,e,i){let n=co(Re(s,t,e)),r=co(Re(s,t,i)),a=co(Re(e,i,s)),o=co(Re(e,i,t));return!!(n!==r&&a!==o||n===0&&lo(s,e,t)||r===0&&lo(s,i,t)||a===0&&lo(e,s,i)||o===0&&lo(e,t,i))}function lo(s,t,e){return t.x<=Math.max(s.x,e.x)&&t.x>=Math.min(s.x,e.x)&&t.y<=Math.max(s.y,e.y)&&t.y>=Math.min(s.y,e.y)}function co(s){return s>0?1:s<0?-1:0}function b0(s,t){let e=s;do{if(e.i!==s.i&&e.next.i!==s.i&&e.i!==t.i&&e.next.i!==t.i&&up(e,e.next,s,t))return!0;e=e.next}while(e!==s);return!1}function Yr(s,t){return Re(s.prev,s,s.next)<0?Re(s,t,s.next)>=0&&Re(s,s.prev,t)>=0:Re(s,t,s.prev)<0||Re(s,s.next,t)<0}function M0(s,t){let e=s,i=!1,n=(s.x+t.x)/2,r=(s.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&n<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(i=!i),e=e.next;while(e!==s);return i}function dp(s,t){let e=qh(s.i,s.x,s.y),i=qh(t.i,t.x,t.y),n=s.next,r=t.prev;return s.next=t,t.prev=s,e.next=n,n.prev=e,i.next=e,e.prev=i,r.next=i,i.prev=r,i}function mf(s,t,e,i){let n=qh(s,t,e);return i?(n.next=i.next,n.prev=i,i.next.prev=n,i.next=n):(n.prev=n,n.next=n),n}function Zr(s){s.next.prev=s.prev,s.prev.next=s.next,s.prevZ&&(s.prevZ.nextZ=s.nextZ),s.nextZ&&(s.nextZ.prevZ=s.prevZ)}function qh(s,t,e){return{i:s,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function S0(s,t,e,i){let n=0;for(let r=t,a=e-i;r<e;r+=i)n+=(s[a]-s[r])*(s[r+1]+s[a+1]),a=r;return n}var Yh=class{static triangulate(t,e,i=2){return o0(t,e,i)}},$n=class s{static area(t){let e=t.length,i=0;for(let n=e-1,r=0;r<e;n=r++)i+=t[n].x*t[r].y-t[r].x*t[n].y;return i*.5}static isClockWise(t){return s.area(t)<0}static triangulateShape(t,e){let i=[],n=[],r=[];gf(t),xf(i,t);let a=t.length;e.forEach(gf);for(let l=0;l<e.length;l++)n.push(a),a+=e[l].length,xf(i,e[l]);let o=Yh.triangulate(i,n);for(let l=0;l<o.length;l+=3)r.push(o.slice(l,l+3));return r}};function gf(s){let t=s.length;t>2&&s[t-1].equals(s[0])&&s.pop()}function xf(s,t){for(let e=0;e<t.length;e++)s.push(t[e].x),s.push(t[e].y)}var jr=class s extends Me{constructor(t=new Vs([new it(.5,.5),new it(-.5,.5),new it(-.5,-.5),new it(.5,-.5)]),e={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:t,options:e},t=Array.isArray(t)?t:[t];let i=this,n=[],r=[];for(let o=0,l=t.length;o<l;o++){let c=t[o];a(c)}this.setAttribute("position",new me(n,3)),this.setAttribute("uv",new me(r,2)),this.computeVertexNormals();function a(o){let l=[],c=e.curveSegments!==void 0?e.curveSegments:12,h=e.steps!==void 0?e.steps:1,u=e.depth!==void 0?e.depth:1,d=e.bevelEnabled!==void 0?e.bevelEnabled:!0,f=e.bevelThickness!==void 0?e.bevelThickness:.2,p=e.bevelSize!==void 0?e.bevelSize:f-.1,y=e.bevelOffset!==void 0?e.bevelOffset:0,m=e.bevelSegments!==void 0?e.bevelSegments:3,g=e.extrudePath,M=e.UVGenerator!==void 0?e.UVGenerator:w0,w,b=!1,C,E,_,T;if(g){w=g.getSpacedPoints(h),b=!0,d=!1;let tt=g.isCatmullRomCurve3?g.closed:!1;C=g.computeFrenetFrames(h,tt),E=new P,_=new P,T=new P}d||(m=0,f=0,p=0,y=0);let O=o.extractPoints(c),R=O.shape,U=O.holes;if(!$n.isClockWise(R)){R=R.reverse();for(let tt=0,ht=U.length;tt<ht;tt++){let ot=U[tt];$n.isClockWise(ot)&&(U[tt]=ot.reverse())}}function W(tt){let ot=10000000000000001e-36,St=tt[0];for(let xt=1;xt<=tt.length;xt++){let Xt=xt%tt.length,Pt=tt[Xt],ie=Pt.x-St.x,ne=Pt.y-St.y,le=ie*ie+ne*ne,D=Math.max(Math.abs(Pt.x),Math.abs(Pt.y),Math.abs(St.x),Math.abs(St.y)),De=ot*D*D;if(le<=De){tt.splice(Xt,1),xt--;continue}St=Pt}}W(R),U.forEach(W);let N=U.length,G=R;for(let tt=0;tt<N;tt++){let ht=U[tt];R=R.concat(ht)}function $(tt,ht,ot){return ht||zt("ExtrudeGeometry: vec does not exist"),tt.clone().addScaledVector(ht,ot)}let V=R.length;function nt(tt,ht,ot){let St,xt,Xt,Pt=tt.x-ht.x,ie=tt.y-ht.y,ne=ot.x-tt.x,le=ot.y-tt.y,D=Pt*Pt+ie*ie,De=Pt*le-ie*ne;if(Math.abs(De)>Number.EPSILON){let te=Math.sqrt(D),xe=Math.sqrt(ne*ne+le*le),pt=ht.x-ie/te,Ie=ht.y+Pt/te,Ot=ot.x-le/xe,Vt=ot.y+ne/xe,A=((Ot-pt)*le-(Vt-Ie)*ne)/(Pt*le-ie*ne);St=pt+Pt*A-tt.x,xt=Ie+ie*A-tt.y;let v=St*St+xt*xt;if(v<=2)return new it(St,xt);Xt=Math.sqrt(v/2)}else{let te=!1;Pt>Number.EPSILON?ne>Number.EPSILON&&(te=!0):Pt<-Number.EPSILON?ne<-Number.EPSILON&&(te=!0):Math.sign(ie)===Math.sign(le)&&(te=!0),te?(St=-ie,xt=Pt,Xt=Math.sqrt(D)):(St=Pt,xt=ie,Xt=Math.sqrt(D/2))}return new it(St/Xt,xt/Xt)}let X=[];for(let tt=0,ht=G.length,ot=ht-1,St=tt+1;tt<ht;tt++,ot++,St++)ot===ht&&(ot=0),St===ht&&(St=0),X[tt]=nt(G[tt],G[ot],G[St]);let Q=[],et,wt=X.concat();for(let tt=0,ht=N;tt<ht;tt++){let ot=U[tt];et=[];for(let St=0,xt=ot.length,Xt=xt-1,Pt=St+1;St<xt;St++,Xt++,Pt++)Xt===xt&&(Xt=0),Pt===xt&&(Pt=0),et[St]=nt(ot[St],ot[Xt],ot[Pt]);Q.push(et),wt=wt.concat(et)}let kt;if(m===0)kt=$n.triangulateShape(G,U);else{let tt=[],ht=[];for(let ot=0;ot<m;ot++){let St=ot/m,xt=f*Math.cos(St*Math.PI/2),Xt=p*Math.sin(St*Math.PI/2)+y;for(let Pt=0,ie=G.length;Pt<ie;Pt++){let ne=$(G[Pt],X[Pt],Xt);Ut(ne.x,ne.y,-xt),St===0&&tt.push(ne)}for(let Pt=0,ie=N;Pt<ie;Pt++){let ne=U[Pt];et=Q[Pt];let le=[];for(let D=0,De=ne.length;D<De;D++){let te=$(ne[D],et[D],Xt);Ut(te.x,te.y,-xt),St===0&&le.push(te)}St===0&&ht.push(le)}}kt=$n.triangulateShape(tt,ht)}let Y=kt.length,_t=p+y;for(let tt=0;tt<V;tt++){let ht=d?$(R[tt],wt[tt],_t):R[tt];b?(_.copy(C.normals[0]).multiplyScalar(ht.x),E.copy(C.binormals[0]).multiplyScalar(ht.y),T.copy(w[0]).add(_).add(E),Ut(T.x,T.y,T.z)):Ut(ht.x,ht.y,0)}for(let tt=1;tt<=h;tt++)for(let ht=0;ht<V;ht++){let ot=d?$(R[ht],wt[ht],_t):R[ht];b?(_.copy(C.normals[tt]).multiplyScalar(ot.x),E.copy(C.binormals[tt]).multiplyScalar(ot.y),T.copy(w[tt]).add(_).add(E),Ut(T.x,T.y,T.z)):Ut(ot.x,ot.y,u/h*tt)}for(let tt=m-1;tt>=0;tt--){let ht=tt/m,ot=f*Math.cos(ht*Math.PI/2),St=p*Math.sin(ht*Math.PI/2)+y;for(let xt=0,Xt=G.length;xt<Xt;xt++){let Pt=$(G[xt],X[xt],St);Ut(Pt.x,Pt.y,u+ot)}for(let xt=0,Xt=U.length;xt<Xt;xt++){let Pt=U[xt];et=Q[xt];for(let ie=0,ne=Pt.length;ie<ne;ie++){let le=$(Pt[ie],et[ie],St);b?Ut(le.x,le.y+w[h-1].y,w[h-1].x+ot):Ut(le.x,le.y,u+ot)}}}Tt(),Dt();function Tt(){let tt=n.length/3;if(d){let ht=0,ot=V*ht;for(let St=0;St<Y;St++){let xt=kt[St];Se(xt[2]+ot,xt[1]+ot,xt[0]+ot)}ht=h+m*2,ot=V*ht;for(let St=0;St<Y;St++){let xt=kt[St];Se(xt[0]+ot,xt[1]+ot,xt[2]+ot)}}else{for(let ht=0;ht<Y;ht++){let ot=kt[ht];Se(ot[2],ot[1],ot[0])}for(let ht=0;ht<Y;ht++){let ot=kt[ht];Se(ot[0]+V*h,ot[1]+V*h,ot[2]+V*h)}}i.addGroup(tt,n.length/3-tt,0)}function Dt(){let tt=n.length/3,ht=0;yt(G,ht),ht+=G.length;for(let ot=0,St=U.length;ot<St;ot++){let xt=U[ot];yt(xt,ht),ht+=xt.length}i.addGroup(tt,n.length/3-tt,1)}function yt(tt,ht){let ot=tt.length;for(;--ot>=0;){let St=ot,xt=ot-1;xt<0&&(xt=tt.length-1);for(let Xt=0,Pt=h+m*2;Xt<Pt;Xt++){let ie=V*Xt,ne=V*(Xt+1),le=ht+St+ie,D=ht+xt+ie,De=ht+xt+ne,te=ht+St+ne;Bt(le,D,De,te)}}}function Ut(tt,ht,ot){l.push(tt),l.push(ht),l.push(ot)}function Se(tt,ht,ot){Jt(tt),Jt(ht),Jt(ot);let St=n.length/3,xt=M.generateTopUV(i,n,St-3,St-2,St-1);ee(xt[0]),ee(xt[1]),ee(xt[2])}function Bt(tt,ht,ot,St){Jt(tt),Jt(ht),Jt(St),Jt(ht),Jt(ot),Jt(St);let xt=n.length/3,Xt=M.generateSideWallUV(i,n,xt-6,xt-3,xt-2,xt-1);ee(Xt[0]),ee(Xt[1]),ee(Xt[3]),ee(Xt[1]),ee(Xt[2]),ee(Xt[3])}function Jt(tt){n.push(l[tt*3+0]),n.push(l[tt*3+1]),n.push(l[tt*3+2])}function ee(tt){r.push(tt.x),r.push(tt.y)}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes,i=this.parameters.options;return T0(e,i,t)}static fromJSON(t,e){let i=[];for(let r=0,a=t.shapes.length;r<a;r++){let o=e[t.shapes[r]];i.push(o)}let n=t.options.extrudePath;return n!==void 0&&(t.options.extrudePath=new Xh[n.type]().fromJSON(n)),new s(i,t.options)}},w0={generateTopUV:function(s,t,e,i,n){let r=t[e*3],a=t[e*3+1],o=t[i*3],l=t[i*3+1],c=t[n*3],h=t[n*3+1];return[new it(r,a),new it(o,l),new it(c,h)]},generateSideWallUV:function(s,t,e,i,n,r){let a=t[e*3],o=t[e*3+1],l=t[e*3+2],c=t[i*3],h=t[i*3+1],u=t[i*3+2],d=t[n*3],f=t[n*3+1],p=t[n*3+2],y=t[r*3],m=t[r*3+1],g=t[r*3+2];return Math.abs(o-h)<Math.abs(a-c)?[new it(a,1-l),new it(c,1-u),new it(d,1-p),new it(y,1-g)]:[new it(o,1-l),new it(h,1-u),new it(f,1-p),new it(m,1-g)]}};function T0(s,t,e){if(e.shapes=[],Array.isArray(s))for(let i=0,n=s.length;i<n;i++){let r=s[i];e.shapes.push(r.uuid)}else e.shapes.push(s.uuid);return e.options=Object.assign({},t),t.extrudePath!==void 0&&(e.options.extrudePath=t.extrudePath.toJSON()),e}var Kn=class s extends Lo{constructor(t=1,e=0){let i=(1+Math.sqrt(5))/2,n=[-1,i,0,1,i,0,-1,-i,0,1,-i,0,0,-1,i,0,1,i,0,-1,-i,0,1,-i,i,0,-1,i,0,1,-i,0,-1,-i,0,1],r=[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1];super(n,r,t,e),this.type="IcosahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new s(t.radius,t.detail)}};var Kr=class s extends Me{constructor(t=1,e=1,i=1,n=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:n};let r=t/2,a=e/2,o=Math.floor(i),l=Math.floor(n),c=o+1,h=l+1,u=t/o,d=e/l,f=[],p=[],y=[],m=[];for(let g=0;g<h;g++){let M=g*d-a;for(let w=0;w<c;w++){let b=w*u-r;p.push(b,-M,0),y.push(0,0,1),m.push(w/o),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let M=0;M<o;M++){let w=M+c*g,b=M+c*(g+1),C=M+1+c*(g+1),E=M+1+c*g;f.push(w,b,E),f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new me(p,3)),this.setAttribute("normal",new me(y,3)),this.setAttribute("uv",new me(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.width,t.height,t.widthSegments,t.heightSegments)}};var Jr=class s extends Me{constructor(t=1,e=.4,i=12,n=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:n,arc:r,thetaStart:a,thetaLength:o},i=Math.floor(i),n=Math.floor(n);let l=[],c=[],h=[],u=[],d=new P,f=new P,p=new P;for(let y=0;y<=i;y++){let m=a+y/i*o;for(let g=0;g<=n;g++){let M=g/n*r;f.x=(t+e*Math.cos(m))*Math.cos(M),f.y=(t+e*Math.cos(m))*Math.sin(M),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),d.x=t*Math.cos(M),d.y=t*Math.sin(M),p.subVectors(f,d).normalize(),h.push(p.x,p.y,p.z),u.push(g/n),u.push(y/i)}}for(let y=1;y<=i;y++)for(let m=1;m<=n;m++){let g=(n+1)*y+m-1,M=(n+1)*(y-1)+m-1,w=(n+1)*(y-1)+m,b=(n+1)*y+m;l.push(g,M,b),l.push(M,w,b)}this.setIndex(l),this.setAttribute("position",new me(c,3)),this.setAttribute("normal",new me(h,3)),this.setAttribute("uv",new me(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new s(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function ss(s){let t={};for(let e in s){t[e]={};for(let i in s[e]){let n=s[e][i];if(_f(n))n.isRenderTargetTexture?(Ft("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=n.clone();else if(Array.isArray(n))if(_f(n[0])){let r=[];for(let a=0,o=n.length;a<o;a++)r[a]=n[a].clone();t[e][i]=r}else t[e][i]=n.slice();else t[e][i]=n}}return t}function ni(s){let t={};for(let e=0;e<s.length;e++){let i=ss(s[e]);for(let n in i)t[n]=i[n]}return t}function _f(s){return s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)}function E0(s){let t=[];for(let e=0;e<s.length;e++)t.push(s[e].clone());return t}function Pu(s){let t=s.getRenderTarget();return t===null?s.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ae.workingColorSpace}var fp={clone:ss,merge:ni},A0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,C0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Wi=class extends Gi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=A0,this.fragmentShader=C0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ss(t.uniforms),this.uniformsGroups=E0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let n in this.uniforms){let a=this.uniforms[n].value;a&&a.isTexture?e.uniforms[n]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[n]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[n]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[n]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[n]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[n]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[n]={type:"m4",value:a.toArray()}:e.uniforms[n]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let n in this.extensions)this.extensions[n]===!0&&(i[n]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let n=t.uniforms[i];switch(this.uniforms[i]={},n.type){case"t":this.uniforms[i].value=e[n.value]||null;break;case"c":this.uniforms[i].value=new Nt().setHex(n.value);break;case"v2":this.uniforms[i].value=new it().fromArray(n.value);break;case"v3":this.uniforms[i].value=new P().fromArray(n.value);break;case"v4":this.uniforms[i].value=new Ae().fromArray(n.value);break;case"m3":this.uniforms[i].value=new Ht().fromArray(n.value);break;case"m4":this.uniforms[i].value=new fe().fromArray(n.value);break;default:this.uniforms[i].value=n.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},zo=class extends Wi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ci=class extends Gi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Nt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Vl,this.normalScale=new it(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rn,this.combine=el,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Go=class extends Gi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Zf,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Vo=class extends Gi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function As(s,t){return!s||s.constructor===t?s:typeof t.BYTES_PER_ELEMENT=="number"?new t(s):Array.prototype.slice.call(s)}function ho(s){return s!==void 0&&s.inTangents!==void 0&&s.outTangents!==void 0}var An=class{constructor(t,e,i,n){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=n!==void 0?n:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,n=e[i],r=e[i-1];i:{t:{let a;e:{n:if(!(t<n)){for(let o=i+2;;){if(n===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===o)break;if(r=n,n=e[++i],t<n)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(i=2,r=o);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(n=r,r=e[--i-1],t>=r)break t}a=i,i=0;break e}break i}for(;i<a;){let o=i+a>>>1;t<e[o]?a=o:i=o+1}if(n=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,n)}return this.interpolate_(i,r,t,n)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,n=this.valueSize,r=t*n;for(let a=0;a!==n;++a)e[a]=i[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ho=class extends An{constructor(t,e,i,n){super(t,e,i,n),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Vh,endingEnd:Vh}}intervalChanged_(t,e,i){let n=this.parameterPositions,r=t-2,a=t+1,o=n[r],l=n[a];if(o===void 0)switch(this.getSettings_().endingStart){case Hh:r=t,o=2*e-i;break;case Wh:r=n.length-2,o=e+n[r]-n[r+1];break;default:r=t,o=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Hh:a=t,l=2*i-e;break;case Wh:a=1,l=i+n[1]-n[0];break;default:a=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-o),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,i,n){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(n-e),y=p*p,m=y*p,g=-d*m+2*d*y-d*p,M=(1+d)*m+(-1.5-2*d)*y+(-.5+d)*p+1,w=(-1-f)*m+(1.5+f)*y+.5*p,b=f*m-f*y;for(let C=0;C!==o;++C)r[C]=g*a[h+C]+M*a[c+C]+w*a[l+C]+b*a[u+C];return r}},Wo=class extends An{constructor(t,e,i,n){super(t,e,i,n)}interpolate_(t,e,i,n){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=(i-e)/(n-e),u=1-h;for(let d=0;d!==o;++d)r[d]=a[c+d]*u+a[l+d]*h;return r}},Xo=class extends An{constructor(t,e,i,n){super(t,e,i,n)}interpolate_(t){return this.copySampleValue_(t-1)}},$o=class extends An{interpolate_(t,e,i,n){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(i-e)/(n-e),y=1-p;for(let m=0;m!==o;++m)r[m]=a[c+m]*y+a[l+m]*p;return r}let d=o*2,f=t-1;for(let p=0;p!==o;++p){let y=a[c+p],m=a[l+p],g=f*d+p*2,M=u[g],w=u[g+1],b=t*d+p*2,C=h[b],E=h[b+1],_=P0(i,e,M,C,n);r[p]=pp(_,y,w,E,m)}return r}};function pp(s,t,e,i,n){let r=1-s;return r*r*r*t+3*r*r*s*e+3*r*s*s*i+s*s*s*n}function R0(s,t,e,i,n){let r=1-s;return 3*r*r*(e-t)+6*r*s*(i-e)+3*s*s*(n-i)}function P0(s,t,e,i,n){let r=(s-t)/(n-t);for(let a=0;a<8;a++){let o=pp(r,t,e,i,n)-s;if(Math.abs(o)<1e-10)break;let l=R0(r,t,e,i,n);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var yi=class{constructor(t,e,i,n){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=As(e,this.TimeBufferType),this.values=As(i,this.ValueBufferType),this.setInterpolation(n||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:As(t.times,Array),values:As(t.values,Array)};let n=t.getInterpolation();n!==t.DefaultInterpolation&&(i.interpolation=n),ho(t.settings)&&(i.settings={inTangents:As(t.settings.inTangents,Array),outTangents:As(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Xo(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Wo(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ho(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new $o(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Tr:e=this.InterpolantFactoryMethodDiscrete;break;case To:e=this.InterpolantFactoryMethodLinear;break;case po:e=this.InterpolantFactoryMethodSmooth;break;case Gh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ft("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Tr;case this.InterpolantFactoryMethodLinear:return To;case this.InterpolantFactoryMethodSmooth:return po;case this.InterpolantFactoryMethodBezier:return Gh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,n=e.length;i!==n;++i)e[i]+=t;ho(this.settings)&&(yf(this.settings.inTangents,t),yf(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,n=e.length;i!==n;++i)e[i]*=t;ho(this.settings)&&(vf(this.settings.inTangents,t),vf(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,n=i.length,r=0,a=n-1;for(;r!==n&&i[r]<t;)++r;for(;a!==-1&&i[a]>e;)--a;if(++a,r!==0||a!==n){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=i.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(zt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,n=this.values,r=i.length;r===0&&(zt("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let l=i[o];if(typeof l=="number"&&isNaN(l)){zt("KeyframeTrack: Time is not a valid number.",this,o,l),t=!1;break}if(a!==null&&a>l){zt("KeyframeTrack: Out of order keys.",this,o,l,a),t=!1;break}a=l}if(n!==void 0&&yg(n))for(let o=0,l=n.length;o!==l;++o){let c=n[o];if(isNaN(c)){zt("KeyframeTrack: Value is not a valid number.",this,o,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),n=this.getInterpolation()===po,r=t.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=t[o],h=t[o+1];if(c!==h&&(o!==1||c!==t[0]))if(n)l=!0;else{let u=o*i,d=u-i,f=u+i;for(let p=0;p!==i;++p){let y=e[u+p];if(y!==e[d+p]||y!==e[f+p]){l=!0;break}}}if(l){if(o!==a){t[a]=t[o];let u=o*i,d=a*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++a}}if(r>0){t[a]=t[r];for(let o=r*i,l=a*i,c=0;c!==i;++c)e[l+c]=e[o+c];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,n=new i(this.name,t,e);return n.createInterpolant=this.createInterpolant,ho(this.settings)&&(n.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),n}};function yf(s,t){for(let e=0,i=s.length;e!==i;e+=2)s[e]+=t}function vf(s,t){for(let e=0,i=s.length;e!==i;e+=2)s[e]*=t}yi.prototype.ValueTypeName="";yi.prototype.TimeBufferType=Float32Array;yi.prototype.ValueBufferType=Float32Array;yi.prototype.DefaultInterpolation=To;var Cn=class extends yi{constructor(t,e,i){super(t,e,i)}};Cn.prototype.ValueTypeName="bool";Cn.prototype.ValueBufferType=Array;Cn.prototype.DefaultInterpolation=Tr;Cn.prototype.InterpolantFactoryMethodLinear=void 0;Cn.prototype.InterpolantFactoryMethodSmooth=void 0;var qo=class extends yi{constructor(t,e,i,n){super(t,e,i,n)}};qo.prototype.ValueTypeName="color";var Yo=class extends yi{constructor(t,e,i,n){super(t,e,i,n)}};Yo.prototype.ValueTypeName="number";var Zo=class extends An{constructor(t,e,i,n){super(t,e,i,n)}interpolate_(t,e,i,n){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(i-e)/(n-e),c=t*o;for(let h=c+o;c!==h;c+=4)je.slerpFlat(r,0,a,c-o,a,c,l);return r}},Qr=class extends yi{constructor(t,e,i,n){super(t,e,i,n)}InterpolantFactoryMethodLinear(t){return new Zo(this.times,this.values,this.getValueSize(),t)}};Qr.prototype.ValueTypeName="quaternion";Qr.prototype.InterpolantFactoryMethodSmooth=void 0;var Rn=class extends yi{constructor(t,e,i){super(t,e,i)}};Rn.prototype.ValueTypeName="string";Rn.prototype.ValueBufferType=Array;Rn.prototype.DefaultInterpolation=Tr;Rn.prototype.InterpolantFactoryMethodLinear=void 0;Rn.prototype.InterpolantFactoryMethodSmooth=void 0;var jo=class extends yi{constructor(t,e,i,n){super(t,e,i,n)}};jo.prototype.ValueTypeName="vector";var Ko=class{constructor(t,e,i){let n=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){o++,r===!1&&n.onStart!==void 0&&n.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,n.onProgress!==void 0&&n.onProgress(h,a,o),a===o&&(r=!1,n.onLoad!==void 0&&n.onLoad())},this.itemError=function(h){n.onError!==void 0&&n.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},mp=new Ko,Jo=class{constructor(t){this.manager=t!==void 0?t:mp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(n,r){i.load(t,n,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jo.DEFAULT_MATERIAL_NAME="__DEFAULT";var ta=class extends Ke{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Nt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var zh=new fe,bf=new P,Mf=new P,Qo=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new it(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new fe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Tn,this._frameExtents=new it(1,1),this._viewportCount=1,this._viewports=[new Ae(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;bf.setFromMatrixPosition(t.matrixWorld),e.position.copy(bf),Mf.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Mf),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,n){zh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(zh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=n?n.z/r.x:1,o=n?n.w/r.y:1,l=n?n.x/r.x:0,c=n?n.y/r.y:0;t.coordinateSystem===Ls||t.reversedDepth?e.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),e.multiply(zh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},uo=new P,fo=new je,Fi=new P,ea=class extends Ke{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new fe,this.projectionMatrix=new fe,this.projectionMatrixInverse=new fe,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(uo,fo,Fi),Fi.x===1&&Fi.y===1&&Fi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(uo,fo,Fi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(uo,fo,Fi),Fi.x===1&&Fi.y===1&&Fi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(uo,fo,Fi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},wn=new P,Sf=new it,wf=new it,Ze=class extends ea{constructor(t=50,e=1,i=.1,n=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=n,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Us*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Ps*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Us*2*Math.atan(Math.tan(Ps*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){wn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(wn.x,wn.y).multiplyScalar(-t/wn.z),wn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(wn.x,wn.y).multiplyScalar(-t/wn.z)}getViewSize(t,e){return this.getViewBounds(t,Sf,wf),e.subVectors(wf,Sf)}setViewOffset(t,e,i,n,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=n,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Ps*.5*this.fov)/this.zoom,i=2*e,n=this.aspect*i,r=-.5*n,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*n/l,e-=a.offsetY*i/c,n*=a.width/l,i*=a.height/c}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+n,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ia=class extends ea{constructor(t=-1,e=1,i=1,n=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=n,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,n,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=n,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,n=(this.top+this.bottom)/2,r=i-t,a=i+t,o=n+e,l=n-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Zh=class extends Qo{constructor(){super(new ia(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Jn=class extends ta{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ke.DEFAULT_UP),this.updateMatrix(),this.target=new Ke,this.shadow=new Zh}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Qn=class extends ta{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Cs=-90,Rs=1,Ws=class extends Ke{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let n=new Ze(Cs,Rs,t,e);n.layers=this.layers,this.add(n);let r=new Ze(Cs,Rs,t,e);r.layers=this.layers,this.add(r);let a=new Ze(Cs,Rs,t,e);a.layers=this.layers,this.add(a);let o=new Ze(Cs,Rs,t,e);o.layers=this.layers,this.add(o);let l=new Ze(Cs,Rs,t,e);l.layers=this.layers,this.add(l);let c=new Ze(Cs,Rs,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,n,r,a,o,l]=e;for(let c of e)this.remove(c);if(t===Mi)i.up.set(0,1,0),i.lookAt(1,0,0),n.up.set(0,1,0),n.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ls)i.up.set(0,-1,0),i.lookAt(-1,0,0),n.up.set(0,-1,0),n.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:n}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,n),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,n),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,2,n),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,3,n),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,n),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,n),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},tl=class extends Ze{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Iu="\\[\\]\\.:\\/",I0=new RegExp("["+Iu+"]","g"),Nu="[^"+Iu+"]",N0="[^"+Iu.replace("\\.","")+"]",L0=/((?:WC+[\/:])*)/.source.replace("WC",Nu),D0=/(WCOD+)?/.source.replace("WCOD",N0),U0=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Nu),O0=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Nu),F0=new RegExp("^"+L0+D0+U0+O0+"$"),k0=["material","materials","bones","map"],jh=class{constructor(t,e,i){let n=i||we.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,n)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,n=this._bindings[i];n!==void 0&&n.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let n=this._targetGroup.nCachedObjects_,r=i.length;n!==r;++n)i[n].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},we=class s{constructor(t,e,i){this.path=e,this.parsedPath=i||s.parseTrackName(e),this.node=s.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new s.Composite(t,e,i):new s(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(I0,"")}static parseTrackName(t){let e=F0.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},n=i.nodeName&&i.nodeName.lastIndexOf(".");if(n!==void 0&&n!==-1){let r=i.nodeName.substring(n+1);k0.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,n),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let l=i(o.children);if(l)return l}return null},n=i(t.children);if(n)return n}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)t[e++]=i[n]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)i[n]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)i[n]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let n=0,r=i.length;n!==r;++n)i[n]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,n=e.propertyName,r=e.propertyIndex;if(t||(t=s.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Ft("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){zt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){zt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){zt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){zt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){zt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){zt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){zt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let a=t[n];if(a===void 0){let c=e.nodeName;zt("PropertyBinding: Trying to update property for track: "+c+"."+n+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(n==="morphTargetInfluences"){if(!t.geometry){zt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){zt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=n;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};we.Composite=jh;we.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};we.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};we.prototype.GetterByBindingType=[we.prototype._getValue_direct,we.prototype._getValue_array,we.prototype._getValue_arrayElement,we.prototype._getValue_toArray];we.prototype.SetterByBindingTypeAndVersioning=[[we.prototype._setValue_direct,we.prototype._setValue_direct_setNeedsUpdate,we.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[we.prototype._setValue_array,we.prototype._setValue_array_setNeedsUpdate,we.prototype._setValue_array_setMatrixWorldNeedsUpdate],[we.prototype._setValue_arrayElement,we.prototype._setValue_arrayElement_setNeedsUpdate,we.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[we.prototype._setValue_fromArray,we.prototype._setValue_fromArray_setNeedsUpdate,we.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Mw=new Float32Array(1);var Xs=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=jt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(jt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Kh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,n){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,n)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,n){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=n,this}};var na=class extends Si{constructor(t=10,e=10,i=4473924,n=8947848){i=new Nt(i),n=new Nt(n);let r=e/2,a=t/e,o=t/2,l=[],c=[];for(let d=0,f=0,p=-o;d<=e;d++,p+=a){l.push(-o,0,p,o,0,p),l.push(p,0,-o,p,0,o);let y=d===r?i:n;y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3}let h=new Me;h.setAttribute("position",new me(l,3)),h.setAttribute("color",new me(c,3));let u=new li({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var sa=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Lu(s,t,e,i){let n=B0(i);switch(e){case gu:return s*t;case ll:return s*t/n.components*n.byteLength;case cl:return s*t/n.components*n.byteLength;case In:return s*t*2/n.components*n.byteLength;case hl:return s*t*2/n.components*n.byteLength;case xu:return s*t*3/n.components*n.byteLength;case Di:return s*t*4/n.components*n.byteLength;case ul:return s*t*4/n.components*n.byteLength;case oa:case la:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case ca:case ha:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case fl:case ml:return Math.max(s,16)*Math.max(t,8)/4;case dl:case pl:return Math.max(s,8)*Math.max(t,8)/2;case gl:case xl:case yl:case vl:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*8;case _l:case ua:case bl:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case Ml:return Math.floor((s+3)/4)*Math.floor((t+3)/4)*16;case Sl:return Math.floor((s+4)/5)*Math.floor((t+3)/4)*16;case wl:return Math.floor((s+4)/5)*Math.floor((t+4)/5)*16;case Tl:return Math.floor((s+5)/6)*Math.floor((t+4)/5)*16;case El:return Math.floor((s+5)/6)*Math.floor((t+5)/6)*16;case Al:return Math.floor((s+7)/8)*Math.floor((t+4)/5)*16;case Cl:return Math.floor((s+7)/8)*Math.floor((t+5)/6)*16;case Rl:return Math.floor((s+7)/8)*Math.floor((t+7)/8)*16;case Pl:return Math.floor((s+9)/10)*Math.floor((t+4)/5)*16;case Il:return Math.floor((s+9)/10)*Math.floor((t+5)/6)*16;case Nl:return Math.floor((s+9)/10)*Math.floor((t+7)/8)*16;case Ll:return Math.floor((s+9)/10)*Math.floor((t+9)/10)*16;case Dl:return Math.floor((s+11)/12)*Math.floor((t+9)/10)*16;case Ul:return Math.floor((s+11)/12)*Math.floor((t+11)/12)*16;case Ol:case Fl:case kl:return Math.ceil(s/4)*Math.ceil(t/4)*16;case Bl:case zl:return Math.ceil(s/4)*Math.ceil(t/4)*8;case da:case Gl:return Math.ceil(s/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function B0(s){switch(s){case ui:case du:return{byteLength:1,components:1};case Zs:case fu:case Li:return{byteLength:2,components:1};case al:case ol:return{byteLength:2,components:4};case Ni:case rl:case wi:return{byteLength:4,components:1};case pu:case mu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${s}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ft("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Fp(){let s=null,t=!1,e=null,i=null;function n(r,a){i=s.requestAnimationFrame(n),e(r,a)}return{start:function(){t!==!0&&e!==null&&s!==null&&(i=s.requestAnimationFrame(n),t=!0)},stop:function(){s!==null&&s.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){s=r}}}function G0(s){let t=new WeakMap;function e(o,l){let c=o.array,h=o.usage,u=c.byteLength,d=s.createBuffer();s.bindBuffer(l,d),s.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=s.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=s.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=s.HALF_FLOAT:f=s.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=s.SHORT;else if(c instanceof Uint32Array)f=s.UNSIGNED_INT;else if(c instanceof Int32Array)f=s.INT;else if(c instanceof Int8Array)f=s.BYTE;else if(c instanceof Uint8Array)f=s.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=s.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function i(o,l,c){let h=l.array,u=l.updateRanges;if(s.bindBuffer(c,o),u.length===0)s.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],y=u[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let y=u[f];s.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function n(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=t.get(o);l&&(s.deleteBuffer(l.buffer),t.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=t.get(o);if(c===void 0)t.set(o,e(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:n,remove:r,update:a}}var V0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,H0=`#ifdef USE_ALPHAHASH
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
#endif`,W0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,X0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,$0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,q0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Y0=`#ifdef USE_AOMAP
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
#endif`,Z0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,j0=`#ifdef USE_BATCHING
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
#endif`,K0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,J0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Q0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,tx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ex=`#ifdef USE_IRIDESCENCE
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
#endif`,ix=`#ifdef USE_BUMPMAP
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
#endif`,nx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,sx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,rx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ax=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,ox=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,lx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,cx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,hx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,ux=`#define PI 3.141592653589793
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
} // validated`,dx=`vec3 transformedNormal = objectNormal;
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
#endif`,fx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,px=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,mx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,gx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,xx="gl_FragColor = linearToOutputTexel( gl_FragColor );",_x=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,yx=`#ifdef USE_ENVMAP
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
#endif`,vx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,bx=`#ifdef USE_ENVMAP
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
#endif`,Mx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Sx=`#ifdef USE_ENVMAP
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
#endif`,wx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Tx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ex=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Ax=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Cx=`#ifdef USE_GRADIENTMAP
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
}`,Rx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Px=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ix=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Nx=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Lx=`#ifdef USE_ENVMAP
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
#endif`,Dx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ux=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ox=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Fx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,kx=`PhysicalMaterial material;
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
#endif`,Bx=`uniform sampler2D dfgLUT;
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
}`,zx=`
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
#endif`,Gx=`#if defined( RE_IndirectDiffuse )
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
#endif`,Vx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Hx=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Wx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Xx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$x=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Yx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Zx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,jx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Kx=`#if defined( USE_POINTS_UV )
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
#endif`,Jx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Qx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,t_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,e_=`#if defined( USE_MORPHCOLORS )
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
#endif`,i_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,n_=`#ifdef USE_MORPHTARGETS
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
#endif`,s_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,r_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,a_=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,o_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,l_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,c_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,h_=`#ifdef USE_NORMALMAP
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
#endif`,u_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,d_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,f_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,p_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,m_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,g_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,x_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,__=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,y_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,v_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,b_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,M_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,S_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,w_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,T_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,E_=`float getShadowMask() {
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
}`,A_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,C_=`#ifdef USE_SKINNING
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
#endif`,R_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,P_=`#ifdef USE_SKINNING
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
#endif`,I_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,N_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,L_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,D_=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,U_=`#ifdef USE_TRANSMISSION
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
#endif`,O_=`#ifdef USE_TRANSMISSION
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
#endif`,F_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,k_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,B_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,z_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,G_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,V_=`uniform sampler2D t2D;
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
}`,H_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,W_=`uniform float backgroundBlurriness;
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
}`,X_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,q_=`#include <common>
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
}`,Y_=`#if DEPTH_PACKING == 3200
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
}`,Z_=`#define DISTANCE
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
}`,j_=`#define DISTANCE
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
}`,K_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,J_=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Q_=`uniform float scale;
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
}`,ty=`uniform vec3 diffuse;
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
}`,ey=`#include <common>
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
}`,iy=`uniform vec3 diffuse;
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
}`,ny=`#define LAMBERT
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
}`,sy=`#define LAMBERT
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
}`,ry=`#define MATCAP
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
}`,ay=`#define MATCAP
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
}`,oy=`#define NORMAL
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
}`,ly=`#define NORMAL
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
}`,cy=`#define PHONG
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
}`,hy=`#define PHONG
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
}`,uy=`#define STANDARD
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
}`,dy=`#define STANDARD
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
}`,fy=`#define TOON
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
}`,py=`#define TOON
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
}`,my=`uniform float size;
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
}`,gy=`uniform vec3 diffuse;
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
}`,xy=`#include <common>
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
}`,_y=`uniform vec3 color;
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
}`,yy=`uniform float rotation;
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
}`,vy=`uniform vec3 diffuse;
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
}`,Kt={alphahash_fragment:V0,alphahash_pars_fragment:H0,alphamap_fragment:W0,alphamap_pars_fragment:X0,alphatest_fragment:$0,alphatest_pars_fragment:q0,aomap_fragment:Y0,aomap_pars_fragment:Z0,batching_pars_vertex:j0,batching_vertex:K0,begin_vertex:J0,beginnormal_vertex:Q0,bsdfs:tx,iridescence_fragment:ex,bumpmap_pars_fragment:ix,clipping_planes_fragment:nx,clipping_planes_pars_fragment:sx,clipping_planes_pars_vertex:rx,clipping_planes_vertex:ax,color_fragment:ox,color_pars_fragment:lx,color_pars_vertex:cx,color_vertex:hx,common:ux,defaultnormal_vertex:dx,displacementmap_pars_vertex:fx,displacementmap_vertex:px,emissivemap_fragment:mx,emissivemap_pars_fragment:gx,colorspace_fragment:xx,colorspace_pars_fragment:_x,envmap_fragment:yx,envmap_common_pars_fragment:vx,envmap_pars_fragment:bx,envmap_pars_vertex:Mx,envmap_physical_pars_fragment:Lx,envmap_vertex:Sx,fog_vertex:wx,fog_pars_vertex:Tx,fog_fragment:Ex,fog_pars_fragment:Ax,gradientmap_pars_fragment:Cx,lightmap_pars_fragment:Rx,lights_lambert_fragment:Px,lights_lambert_pars_fragment:Ix,lights_pars_begin:Nx,lights_toon_fragment:Dx,lights_toon_pars_fragment:Ux,lights_phong_fragment:Ox,lights_phong_pars_fragment:Fx,lights_physical_fragment:kx,lights_physical_pars_fragment:Bx,lights_fragment_begin:zx,lights_fragment_maps:Gx,lights_fragment_end:Vx,lightprobes_pars_fragment:Hx,logdepthbuf_fragment:Wx,logdepthbuf_pars_fragment:Xx,logdepthbuf_pars_vertex:$x,logdepthbuf_vertex:qx,map_fragment:Yx,map_pars_fragment:Zx,map_particle_fragment:jx,map_particle_pars_fragment:Kx,metalnessmap_fragment:Jx,metalnessmap_pars_fragment:Qx,morphinstance_vertex:t_,morphcolor_vertex:e_,morphnormal_vertex:i_,morphtarget_pars_vertex:n_,morphtarget_vertex:s_,normal_fragment_begin:r_,normal_fragment_maps:a_,normal_pars_fragment:o_,normal_pars_vertex:l_,normal_vertex:c_,normalmap_pars_fragment:h_,clearcoat_normal_fragment_begin:u_,clearcoat_normal_fragment_maps:d_,clearcoat_pars_fragment:f_,iridescence_pars_fragment:p_,opaque_fragment:m_,packing:g_,premultiplied_alpha_fragment:x_,project_vertex:__,dithering_fragment:y_,dithering_pars_fragment:v_,roughnessmap_fragment:b_,roughnessmap_pars_fragment:M_,shadowmap_pars_fragment:S_,shadowmap_pars_vertex:w_,shadowmap_vertex:T_,shadowmask_pars_fragment:E_,skinbase_vertex:A_,skinning_pars_vertex:C_,skinning_vertex:R_,skinnormal_vertex:P_,specularmap_fragment:I_,specularmap_pars_fragment:N_,tonemapping_fragment:L_,tonemapping_pars_fragment:D_,transmission_fragment:U_,transmission_pars_fragment:O_,uv_pars_fragment:F_,uv_pars_vertex:k_,uv_vertex:B_,worldpos_vertex:z_,background_vert:G_,background_frag:V_,backgroundCube_vert:H_,backgroundCube_frag:W_,cube_vert:X_,cube_frag:$_,depth_vert:q_,depth_frag:Y_,distance_vert:Z_,distance_frag:j_,equirect_vert:K_,equirect_frag:J_,linedashed_vert:Q_,linedashed_frag:ty,meshbasic_vert:ey,meshbasic_frag:iy,meshlambert_vert:ny,meshlambert_frag:sy,meshmatcap_vert:ry,meshmatcap_frag:ay,meshnormal_vert:oy,meshnormal_frag:ly,meshphong_vert:cy,meshphong_frag:hy,meshphysical_vert:uy,meshphysical_frag:dy,meshtoon_vert:fy,meshtoon_frag:py,points_vert:my,points_frag:gy,shadow_vert:xy,shadow_frag:_y,sprite_vert:yy,sprite_frag:vy},bt={common:{diffuse:{value:new Nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ht}},envmap:{envMap:{value:null},envMapRotation:{value:new Ht},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ht}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ht}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ht},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ht},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ht},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ht}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ht}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ht}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0},uvTransform:{value:new Ht}},sprite:{diffuse:{value:new Nt(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ht},alphaMap:{value:null},alphaMapTransform:{value:new Ht},alphaTest:{value:0}}},Zi={basic:{uniforms:ni([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:Kt.meshbasic_vert,fragmentShader:Kt.meshbasic_frag},lambert:{uniforms:ni([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)},envMapIntensity:{value:1}}]),vertexShader:Kt.meshlambert_vert,fragmentShader:Kt.meshlambert_frag},phong:{uniforms:ni([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)},specular:{value:new Nt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Kt.meshphong_vert,fragmentShader:Kt.meshphong_frag},standard:{uniforms:ni([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Kt.meshphysical_vert,fragmentShader:Kt.meshphysical_frag},toon:{uniforms:ni([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)}}]),vertexShader:Kt.meshtoon_vert,fragmentShader:Kt.meshtoon_frag},matcap:{uniforms:ni([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:Kt.meshmatcap_vert,fragmentShader:Kt.meshmatcap_frag},points:{uniforms:ni([bt.points,bt.fog]),vertexShader:Kt.points_vert,fragmentShader:Kt.points_frag},dashed:{uniforms:ni([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Kt.linedashed_vert,fragmentShader:Kt.linedashed_frag},depth:{uniforms:ni([bt.common,bt.displacementmap]),vertexShader:Kt.depth_vert,fragmentShader:Kt.depth_frag},normal:{uniforms:ni([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:Kt.meshnormal_vert,fragmentShader:Kt.meshnormal_frag},sprite:{uniforms:ni([bt.sprite,bt.fog]),vertexShader:Kt.sprite_vert,fragmentShader:Kt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ht},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Kt.background_vert,fragmentShader:Kt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ht}},vertexShader:Kt.backgroundCube_vert,fragmentShader:Kt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Kt.cube_vert,fragmentShader:Kt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Kt.equirect_vert,fragmentShader:Kt.equirect_frag},distance:{uniforms:ni([bt.common,bt.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Kt.distance_vert,fragmentShader:Kt.distance_frag},shadow:{uniforms:ni([bt.lights,bt.fog,{color:{value:new Nt(0)},opacity:{value:1}}]),vertexShader:Kt.shadow_vert,fragmentShader:Kt.shadow_frag}};Zi.physical={uniforms:ni([Zi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ht},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ht},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ht},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ht},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ht},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ht},sheen:{value:0},sheenColor:{value:new Nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ht},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ht},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ht},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ht},attenuationDistance:{value:0},attenuationColor:{value:new Nt(0)},specularColor:{value:new Nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ht},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ht},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ht}}]),vertexShader:Kt.meshphysical_vert,fragmentShader:Kt.meshphysical_frag};var Wl={r:0,b:0,g:0},by=new fe,kp=new Ht;kp.set(-1,0,0,0,1,0,0,0,1);function My(s,t,e,i,n,r){let a=new Nt(0),o=n===!0?0:1,l,c,h=null,u=0,d=null;function f(M){let w=M.isScene===!0?M.background:null;if(w&&w.isTexture){let b=M.backgroundBlurriness>0;w=t.get(w,b)}return w}function p(M){let w=!1,b=f(M);b===null?m(a,o):b&&b.isColor&&(m(b,1),w=!0);let C=s.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(s.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),s.clear(s.autoClearColor,s.autoClearDepth,s.autoClearStencil))}function y(M,w){let b=f(w);b&&b.isCubeTexture?(c===void 0&&(c=new Pe(new En(1,1,1),new Wi({name:"BackgroundCubeMaterial",uniforms:ss(Zi.backgroundCube.uniforms),vertexShader:Zi.backgroundCube.vertexShader,fragmentShader:Zi.backgroundCube.fragmentShader,side:ke,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(by.makeRotationFromEuler(w.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(kp),c.material.toneMapped=ae.getTransfer(b.colorSpace)!==de,(h!==b||u!==b.version||d!==s.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=s.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Pe(new Kr(2,2),new Wi({name:"BackgroundMaterial",uniforms:ss(Zi.background.uniforms),vertexShader:Zi.background.vertexShader,fragmentShader:Zi.background.fragmentShader,side:Pn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=ae.getTransfer(b.colorSpace)!==de,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==s.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=s.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function m(M,w){M.getRGB(Wl,Pu(s)),e.buffers.color.setClear(Wl.r,Wl.g,Wl.b,w,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,w=1){a.set(M),o=w,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(M){o=M,m(a,o)},render:p,addToRenderList:y,dispose:g}}function Sy(s,t){let e=s.getParameter(s.MAX_VERTEX_ATTRIBS),i={},n=d(null),r=n,a=!1;function o(U,F,W,N,G){let $=!1,V=u(U,N,W,F);r!==V&&(r=V,c(r.object)),$=f(U,N,W,G),$&&p(U,N,W,G),G!==null&&t.update(G,s.ELEMENT_ARRAY_BUFFER),($||a)&&(a=!1,b(U,F,W,N),G!==null&&s.bindBuffer(s.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return s.createVertexArray()}function c(U){return s.bindVertexArray(U)}function h(U){return s.deleteVertexArray(U)}function u(U,F,W,N){let G=N.wireframe===!0,$=i[F.id];$===void 0&&($={},i[F.id]=$);let V=U.isInstancedMesh===!0?U.id:0,nt=$[V];nt===void 0&&(nt={},$[V]=nt);let X=nt[W.id];X===void 0&&(X={},nt[W.id]=X);let Q=X[G];return Q===void 0&&(Q=d(l()),X[G]=Q),Q}function d(U){let F=[],W=[],N=[];for(let G=0;G<e;G++)F[G]=0,W[G]=0,N[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:W,attributeDivisors:N,object:U,attributes:{},index:null}}function f(U,F,W,N){let G=r.attributes,$=F.attributes,V=0,nt=W.getAttributes();for(let X in nt)if(nt[X].location>=0){let et=G[X],wt=$[X];if(wt===void 0&&(X==="instanceMatrix"&&U.instanceMatrix&&(wt=U.instanceMatrix),X==="instanceColor"&&U.instanceColor&&(wt=U.instanceColor)),et===void 0||et.attribute!==wt||wt&&et.data!==wt.data)return!0;V++}return r.attributesNum!==V||r.index!==N}function p(U,F,W,N){let G={},$=F.attributes,V=0,nt=W.getAttributes();for(let X in nt)if(nt[X].location>=0){let et=$[X];et===void 0&&(X==="instanceMatrix"&&U.instanceMatrix&&(et=U.instanceMatrix),X==="instanceColor"&&U.instanceColor&&(et=U.instanceColor));let wt={};wt.attribute=et,et&&et.data&&(wt.data=et.data),G[X]=wt,V++}r.attributes=G,r.attributesNum=V,r.index=N}function y(){let U=r.newAttributes;for(let F=0,W=U.length;F<W;F++)U[F]=0}function m(U){g(U,0)}function g(U,F){let W=r.newAttributes,N=r.enabledAttributes,G=r.attributeDivisors;W[U]=1,N[U]===0&&(s.enableVertexAttribArray(U),N[U]=1),G[U]!==F&&(s.vertexAttribDivisor(U,F),G[U]=F)}function M(){let U=r.newAttributes,F=r.enabledAttributes;for(let W=0,N=F.length;W<N;W++)F[W]!==U[W]&&(s.disableVertexAttribArray(W),F[W]=0)}function w(U,F,W,N,G,$,V){V===!0?s.vertexAttribIPointer(U,F,W,G,$):s.vertexAttribPointer(U,F,W,N,G,$)}function b(U,F,W,N){y();let G=N.attributes,$=W.getAttributes(),V=F.defaultAttributeValues;for(let nt in $){let X=$[nt];if(X.location>=0){let Q=G[nt];if(Q===void 0&&(nt==="instanceMatrix"&&U.instanceMatrix&&(Q=U.instanceMatrix),nt==="instanceColor"&&U.instanceColor&&(Q=U.instanceColor)),Q!==void 0){let et=Q.normalized,wt=Q.itemSize,kt=t.get(Q);if(kt===void 0)continue;let Y=kt.buffer,_t=kt.type,Tt=kt.bytesPerElement,Dt=_t===s.INT||_t===s.UNSIGNED_INT||Q.gpuType===rl;if(Q.isInterleavedBufferAttribute){let yt=Q.data,Ut=yt.isInterleavedBuffer===!0?yt.stride:yt.itemSize,Se=Q.offset;if(yt.isInstancedInterleavedBuffer||yt.isInstancedBufferAttribute){for(let Bt=0;Bt<X.locationSize;Bt++)g(X.location+Bt,yt.meshPerAttribute);U.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=yt.meshPerAttribute*yt.count)}else for(let Bt=0;Bt<X.locationSize;Bt++)m(X.location+Bt);s.bindBuffer(s.ARRAY_BUFFER,Y);for(let Bt=0;Bt<X.locationSize;Bt++)w(X.location+Bt,wt/X.locationSize,_t,et,Ut*Tt,(Se+wt/X.locationSize*Bt)*Tt,Dt)}else{if(Q.isInstancedBufferAttribute){for(let yt=0;yt<X.locationSize;yt++)g(X.location+yt,Q.meshPerAttribute);U.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let yt=0;yt<X.locationSize;yt++)m(X.location+yt);s.bindBuffer(s.ARRAY_BUFFER,Y);for(let yt=0;yt<X.locationSize;yt++)w(X.location+yt,wt/X.locationSize,_t,et,wt*Tt,wt/X.locationSize*yt*Tt,Dt)}}else if(V!==void 0){let et=V[nt];if(et!==void 0)switch(et.length){case 2:s.vertexAttrib2fv(X.location,et);break;case 3:s.vertexAttrib3fv(X.location,et);break;case 4:s.vertexAttrib4fv(X.location,et);break;default:s.vertexAttrib1fv(X.location,et)}}}}M()}function C(){O();for(let U in i){let F=i[U];for(let W in F){let N=F[W];for(let G in N){let $=N[G];for(let V in $)h($[V].object),delete $[V];delete N[G]}}delete i[U]}}function E(U){if(i[U.id]===void 0)return;let F=i[U.id];for(let W in F){let N=F[W];for(let G in N){let $=N[G];for(let V in $)h($[V].object),delete $[V];delete N[G]}}delete i[U.id]}function _(U){for(let F in i){let W=i[F];for(let N in W){let G=W[N];if(G[U.id]===void 0)continue;let $=G[U.id];for(let V in $)h($[V].object),delete $[V];delete G[U.id]}}}function T(U){for(let F in i){let W=i[F],N=U.isInstancedMesh===!0?U.id:0,G=W[N];if(G!==void 0){for(let $ in G){let V=G[$];for(let nt in V)h(V[nt].object),delete V[nt];delete G[$]}delete W[N],Object.keys(W).length===0&&delete i[F]}}}function O(){R(),a=!0,r!==n&&(r=n,c(r.object))}function R(){n.geometry=null,n.program=null,n.wireframe=!1}return{setup:o,reset:O,resetDefaultState:R,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:m,disableUnusedAttributes:M}}function wy(s,t,e){let i;function n(l){i=l}function r(l,c){s.drawArrays(i,l,c),e.update(c,i,1)}function a(l,c,h){h!==0&&(s.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function o(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,i,1)}this.setMode=n,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Ty(s,t,e,i){let n;function r(){if(n!==void 0)return n;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");n=s.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else n=0;return n}function a(_){return!(_!==Di&&i.convert(_)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(_){let T=_===Li&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ui&&_!==wi&&!T&&i.convert(_)!==s.getParameter(s.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.HIGH_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&s.getShaderPrecisionFormat(s.VERTEX_SHADER,s.MEDIUM_FLOAT).precision>0&&s.getShaderPrecisionFormat(s.FRAGMENT_SHADER,s.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Ft("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Ft("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Ft("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=s.getParameter(s.MAX_TEXTURE_IMAGE_UNITS),p=s.getParameter(s.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=s.getParameter(s.MAX_TEXTURE_SIZE),m=s.getParameter(s.MAX_CUBE_MAP_TEXTURE_SIZE),g=s.getParameter(s.MAX_VERTEX_ATTRIBS),M=s.getParameter(s.MAX_VERTEX_UNIFORM_VECTORS),w=s.getParameter(s.MAX_VARYING_VECTORS),b=s.getParameter(s.MAX_FRAGMENT_UNIFORM_VECTORS),C=s.getParameter(s.MAX_SAMPLES),E=s.getParameter(s.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:M,maxVaryings:w,maxFragmentUniforms:b,maxSamples:C,samples:E}}function Ey(s){let t=this,e=null,i=0,n=!1,r=!1,a=new gi,o=new Ht,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||n;return n=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,y=u.clipIntersection,m=u.clipShadows,g=s.get(u);if(!n||p===null||p.length===0||r&&!m)r?h(null):c();else{let M=r?0:i,w=M*4,b=g.clippingState||null;l.value=b,b=h(p,d,w,f);for(let C=0;C!==w;++C)b[C]=e[C];g.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,p){let y=u!==null?u.length:0,m=null;if(y!==0){if(m=l.value,p!==!0||m===null){let g=f+y*4,M=d.matrixWorldInverse;o.getNormalMatrix(M),(m===null||m.length<g)&&(m=new Float32Array(g));for(let w=0,b=f;w!==y;++w,b+=4)a.copy(u[w]).applyMatrix4(M,o),a.normal.toArray(m,b),m[b+3]=a.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var ma=class extends xi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},n=[i,i,i,i,i,i];this.texture=new Fr(n),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},n=new En(5,5,5),r=new Wi({name:"CubemapFromEquirect",uniforms:ss(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ke,blending:ts});r.uniforms.tEquirect.value=e;let a=new Pe(n,r),o=e.minFilter;return e.minFilter===cn&&(e.minFilter=ai),new Ws(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,i=!0,n=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,i,n);t.setRenderTarget(r)}},gp=256,Ay=3,Cy=20,Bp=256,zp=16,Ry=3,Py=new P,Iy=new Nt,$l=class s{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ws(1,10,null),this._boxMesh=new Pe(new En(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,n=100,r={}){let{size:a=256,position:o=Py}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(Iy));let m=new Ws(i,n,h);return m.position.copy(o),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=_p(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(gp,Tu(t))}_fromTexture(t,e){t.mapping===is||t.mapping===Ys?this._setSize(t.image.length===0?gp:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=xp(t,!1,!1),i=Math.log2(t)-Ay;for(let n=0;n<=i;n++)e.texture.mipmaps.push({width:t>>n,height:t>>n});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=xp(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let n=this._boxMesh,r=this._cubeCamera;n.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,n),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===is||t.mapping===Ys?(this._cubemapMaterial===null&&(this._cubemapMaterial=yp()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=_p()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Ny(),this._integrationMaterial=Ly());let e=this._cubeSize,i=t.texture.mipmaps.length-1,n=this._ggxMaterial.uniforms;n.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/zp);for(let a=0;a<=i;a++){let o=s.lodToRoughness(a,i);if(a>i-Ry)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let l=o>0?Math.log2(e)+.5*Math.log2(6/(Bp*Math.pow(o,4)))+.5:0;n.roughness.value=o,n.lodBias.value=l,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Dy());let i=this._blurMaterial,n=i.uniforms,r=this._sourceTarget;n.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,n.envMap.value=r.texture,this._renderCube(t,0,i),n.envMap.value=t.texture,this._renderCube(r,0,i)}};function xp(s,t,e){return new ma(s,{minFilter:cn,generateMipmaps:t,type:Li,colorSpace:Er,depthBuffer:e})}function ga(s,t,e){return new Wi({name:s,uniforms:t,vertexShader:Kt.cube_vert,fragmentShader:e,side:ke,blending:ts,depthTest:!1,depthWrite:!1})}function Ny(){return ga("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Bp}u

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
	`)}function Ly(){return ga("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:zp}},`

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
	`)}function Dy(){return ga("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Cy}
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
	`)}function _p(){return ga("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function yp(){return ga("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Uy(s){let t=new WeakMap,e=new WeakMap,i=null;function n(d,f=!1){return d==null?null:f?a(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===il||f===nl)if(t.has(d)){let p=t.get(d).texture;return o(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let y=new ma(p.height);return y.fromEquirectangularTexture(s,d),t.set(d,y),d.addEventListener("dispose",c),o(y.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===il||f===nl,y=f===is||f===Ys;if(p||y){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new $l(s)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let M=d.image;return p&&M&&M.height>0||y&&M&&l(M)?(i===null&&(i=new $l(s)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function o(d,f){return f===il?d.mapping=is:f===nl&&(d.mapping=Ys),d}function l(d){let f=0,p=6;for(let y=0;y<p;y++)d[y]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:n,dispose:u}}function Oy(s){let t={};function e(i){if(t[i]!==void 0)return t[i];let n=s.getExtension(i);return t[i]=n,n}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let n=e(i);return n===null&&br("WebGLRenderer: "+i+" extension not supported."),n}}}function Fy(s,t,e,i){let n={},r=new WeakMap,a=new FinalizationRegistry(p=>delete n[p]);function o(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",o),delete n[p.id],a.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,y){return n[y.id]!==void 0||(y.addEventListener("dispose",o),n[y.id]=new WeakRef(y),a.register(y,y.id,y),e.memory.geometries++),y}function h(p){let y=p.attributes;for(let m in y)t.update(y[m],s.ARRAY_BUFFER)}function u(p){let y=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let M=y!==null?y.array.length:m.array.length/3-1,w=m.count>=65535?Lr:Nr,b=new w(Math.ceil(M/3)*6,1),C=b.array;if(y!==null){let _=y.array;g=y.version;for(let T=0,O=0;T<M;T+=3){let R=_[T+0],U=_[T+1],F=_[T+2];C[O++]=R,C[O++]=U,C[O++]=U,C[O++]=F,C[O++]=F,C[O++]=R}}else{g=m.version;for(let _=0,T=0;_<M;_+=3){let O=_+0,R=_+1,U=_+2;C[T++]=O,C[T++]=R,C[T++]=R,C[T++]=U,C[T++]=U,C[T++]=O}}b.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,b)}function d(p){let y=r.get(p);if(y){let m=p.index;m!==null&&y.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in n){let y=n[p].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function ky(s,t,e){let i;function n(u){i=u}let r,a;function o(u){r=u.type,a=u.bytesPerElement}function l(u,d){s.drawElements(i,d,r,u*a),e.update(d,i,1)}function c(u,d,f){f!==0&&(s.drawElementsInstanced(i,d,r,u*a,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let y=0;for(let m=0;m<f;m++)y+=d[m];e.update(y,i,1)}this.setMode=n,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function By(s){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(e.calls++,a){case s.TRIANGLES:e.triangles+=o*(r/3);break;case s.LINES:e.lines+=o*(r/2);break;case s.LINE_STRIP:e.lines+=o*(r-1);break;case s.LINE_LOOP:e.lines+=o*r;break;case s.POINTS:e.points+=o*r;break;default:zt("WebGLInfo: Unknown draw mode:",a);break}}function n(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:n,update:i}}function zy(s,t,e){let i=new WeakMap,n=new Ae;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(o);if(d===void 0||d.count!==u){let O=function(){_.dispose(),i.delete(o),o.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=o.morphAttributes.position!==void 0,p=o.morphAttributes.normal!==void 0,y=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],g=o.morphAttributes.normal||[],M=o.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),y===!0&&(w=3);let b=o.attributes.position.count*w,C=1;b>t.maxTextureSize&&(C=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let E=new Float32Array(b*C*4*u),_=new Pr(E,b,C,u);_.type=wi,_.needsUpdate=!0;let T=w*4;for(let R=0;R<u;R++){let U=m[R],F=g[R],W=M[R],N=b*C*4*R;for(let G=0;G<U.count;G++){let $=G*T;f===!0&&(n.fromBufferAttribute(U,G),E[N+$+0]=n.x,E[N+$+1]=n.y,E[N+$+2]=n.z,E[N+$+3]=0),p===!0&&(n.fromBufferAttribute(F,G),E[N+$+4]=n.x,E[N+$+5]=n.y,E[N+$+6]=n.z,E[N+$+7]=0),y===!0&&(n.fromBufferAttribute(W,G),E[N+$+8]=n.x,E[N+$+9]=n.y,E[N+$+10]=n.z,E[N+$+11]=W.itemSize===4?n.w:1)}}d={count:u,texture:_,size:new it(b,C)},i.set(o,d),o.addEventListener("dispose",O)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(s,"morphTexture",a.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let p=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(s,"morphTargetBaseInfluence",p),l.getUniforms().setValue(s,"morphTargetInfluences",c)}l.getUniforms().setValue(s,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(s,"morphTargetsTextureSize",d.size)}return{update:r}}function Gy(s,t,e,i,n){let r=new WeakMap;function a(c){let h=n.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,s.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,s.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var Vy={[su]:"LINEAR_TONE_MAPPING",[ru]:"REINHARD_TONE_MAPPING",[au]:"CINEON_TONE_MAPPING",[ou]:"ACES_FILMIC_TONE_MAPPING",[cu]:"AGX_TONE_MAPPING",[hu]:"NEUTRAL_TONE_MAPPING",[lu]:"CUSTOM_TONE_MAPPING"};function Hy(s,t,e,i,n,r){let a=new xi(t,e,{type:s,depthBuffer:n,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new Me;h.setAttribute("position",new me([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new me([0,2,0,0,2,0],2));let u=new zo({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Pe(h,u),f=new ia(-1,1,1,-1,0,1),p=null,y=null,m=!1,g,M=null,w=[],b=!1;this.setSize=function(C,E){a.setSize(C,E),o!==null&&o.setSize(C,E),l!==null&&l.setSize(C,E);for(let _=0;_<w.length;_++){let T=w[_];T.setSize&&T.setSize(C,E)}},this.setEffects=function(C){w=C,b=w.length>0&&w[0].isRenderPass===!0;let E=a.width,_=a.height;w.length>0&&o===null&&(o=new xi(E,_,{type:Li,depthBuffer:!1,stencilBuffer:!1}),l=new xi(E,_,{type:Li,depthBuffer:!1,stencilBuffer:!1}));let T=n===!0&&w.some(O=>O.needsDepthTexture===!0);T!==(a.depthTexture!==null)&&(T===!0&&c===null&&(c=new on(E,_),r===!0&&(c.format=hn,c.type=ns)),a.dispose(),a.depthTexture=T?c:null,a.resolveDepthBuffer=T,a.storeMultisampledDepthBuffer=T);for(let O=0;O<w.length;O++){let R=w[O];R.setSize&&R.setSize(E,_),T&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(C,E){if(m||C.toneMapping===qi&&w.length===0)return!1;if(M=E,E!==null){let _=E.width,T=E.height;(a.width!==_||a.height!==T)&&this.setSize(_,T)}return b===!1&&C.setRenderTarget(a),g=C.toneMapping,C.toneMapping=qi,!0},this.hasRenderPass=function(){return b},this.end=function(C,E){C.toneMapping=g,m=!0;let _=a,T=o;for(let O=0;O<w.length;O++){let R=w[O];R.enabled!==!1&&(R.render(C,T,_,E),R.needsSwap!==!1&&(_=T,T=T===o?l:o))}if(p!==C.outputColorSpace||y!==C.toneMapping){p=C.outputColorSpace,y=C.toneMapping,u.defines={},ae.getTransfer(p)===de&&(u.defines.SRGB_TRANSFER="");let O=Vy[y];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(M),C.render(d,f),M=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Gp=new oi,Vp=new on(1,1),Hp=new Br(1),Wp=new Pr,Xp=new Co,$p=new Fr,vp=[],bp=[],Mp=new Float32Array(16),Sp=new Float32Array(9),wp=new Float32Array(4);function Ks(s,t,e){let i=s[0];if(i<=0||i>0)return s;let n=t*e,r=vp[n];if(r===void 0&&(r=new Float32Array(n),vp[n]=r),t!==0){i.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,s[a].toArray(r,o)}return r}function Be(s,t){if(s.length!==t.length)return!1;for(let e=0,i=s.length;e<i;e++)if(s[e]!==t[e])return!1;return!0}function ze(s,t){for(let e=0,i=t.length;e<i;e++)s[e]=t[e]}function Yl(s,t){let e=bp[t];e===void 0&&(e=new Int32Array(t),bp[t]=e);for(let i=0;i!==t;++i)e[i]=s.allocateTextureUnit();return e}function Wy(s,t){let e=this.cache;e[0]!==t&&(s.uniform1f(this.addr,t),e[0]=t)}function Xy(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;s.uniform2fv(this.addr,t),ze(e,t)}}function $y(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(s.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Be(e,t))return;s.uniform3fv(this.addr,t),ze(e,t)}}function qy(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;s.uniform4fv(this.addr,t),ze(e,t)}}function Yy(s,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;s.uniformMatrix2fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;wp.set(i),s.uniformMatrix2fv(this.addr,!1,wp),ze(e,i)}}function Zy(s,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;s.uniformMatrix3fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;Sp.set(i),s.uniformMatrix3fv(this.addr,!1,Sp),ze(e,i)}}function jy(s,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;s.uniformMatrix4fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;Mp.set(i),s.uniformMatrix4fv(this.addr,!1,Mp),ze(e,i)}}function Ky(s,t){let e=this.cache;e[0]!==t&&(s.uniform1i(this.addr,t),e[0]=t)}function Jy(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;s.uniform2iv(this.addr,t),ze(e,t)}}function Qy(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Be(e,t))return;s.uniform3iv(this.addr,t),ze(e,t)}}function tv(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;s.uniform4iv(this.addr,t),ze(e,t)}}function ev(s,t){let e=this.cache;e[0]!==t&&(s.uniform1ui(this.addr,t),e[0]=t)}function iv(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(s.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;s.uniform2uiv(this.addr,t),ze(e,t)}}function nv(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(s.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Be(e,t))return;s.uniform3uiv(this.addr,t),ze(e,t)}}function sv(s,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(s.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;s.uniform4uiv(this.addr,t),ze(e,t)}}function Zl(s){return s.version===0&&(s.compareFunction=vu,s.needsUpdate=!0),s}function rv(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n);let r;this.type===s.SAMPLER_2D_SHADOW?r=Zl(Vp):r=Gp,e.setTexture2D(t||r,n)}function av(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n),e.setTexture3D(t||Xp,n)}function ov(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n);let r;this.type===s.SAMPLER_CUBE_SHADOW?r=Zl(Hp):r=$p,e.setTextureCube(t||r,n)}function lv(s,t,e){let i=this.cache,n=e.allocateTextureUnit();i[0]!==n&&(s.uniform1i(this.addr,n),i[0]=n),e.setTexture2DArray(t||Wp,n)}function cv(s){switch(s){case 5126:return Wy;case 35664:return Xy;case 35665:return $y;case 35666:return qy;case 35674:return Yy;case 35675:return Zy;case 35676:return jy;case 5124:case 35670:return Ky;case 35667:case 35671:return Jy;case 35668:case 35672:return Qy;case 35669:case 35673:return tv;case 5125:return ev;case 36294:return iv;case 36295:return nv;case 36296:return sv;case 35678:case 36198:case 36298:case 36306:case 35682:return rv;case 35679:case 36299:case 36307:return av;case 35680:case 36300:case 36308:case 36293:return ov;case 36289:case 36303:case 36311:case 36292:return lv}}function hv(s,t){s.uniform1fv(this.addr,t)}function uv(s,t){let e=Ks(t,this.size,2);s.uniform2fv(this.addr,e)}function dv(s,t){let e=Ks(t,this.size,3);s.uniform3fv(this.addr,e)}function fv(s,t){let e=Ks(t,this.size,4);s.uniform4fv(this.addr,e)}function pv(s,t){let e=Ks(t,this.size,4);s.uniformMatrix2fv(this.addr,!1,e)}function mv(s,t){let e=Ks(t,this.size,9);s.uniformMatrix3fv(this.addr,!1,e)}function gv(s,t){let e=Ks(t,this.size,16);s.uniformMatrix4fv(this.addr,!1,e)}function xv(s,t){s.uniform1iv(this.addr,t)}function _v(s,t){s.uniform2iv(this.addr,t)}function yv(s,t){s.uniform3iv(this.addr,t)}function vv(s,t){s.uniform4iv(this.addr,t)}function bv(s,t){s.uniform1uiv(this.addr,t)}function Mv(s,t){s.uniform2uiv(this.addr,t)}function Sv(s,t){s.uniform3uiv(this.addr,t)}function wv(s,t){s.uniform4uiv(this.addr,t)}function Tv(s,t,e){let i=this.cache,n=t.length,r=Yl(e,n);Be(i,r)||(s.uniform1iv(this.addr,r),ze(i,r));let a;this.type===s.SAMPLER_2D_SHADOW?a=Zl(Vp):a=Gp;for(let o=0;o!==n;++o)e.setTexture2D(t[o]||a,r[o])}function Ev(s,t,e){let i=this.cache,n=t.length,r=Yl(e,n);Be(i,r)||(s.uniform1iv(this.addr,r),ze(i,r));for(let a=0;a!==n;++a)e.setTexture3D(t[a]||Xp,r[a])}function Av(s,t,e){let i=this.cache,n=t.length,r=Yl(e,n);Be(i,r)||(s.uniform1iv(this.addr,r),ze(i,r));let a;this.type===s.SAMPLER_CUBE_SHADOW?a=Zl(Hp):a=$p;for(let o=0;o!==n;++o)e.setTextureCube(t[o]||a,r[o])}function Cv(s,t,e){let i=this.cache,n=t.length,r=Yl(e,n);Be(i,r)||(s.uniform1iv(this.addr,r),ze(i,r));for(let a=0;a!==n;++a)e.setTexture2DArray(t[a]||Wp,r[a])}function Rv(s){switch(s){case 5126:return hv;case 35664:return uv;case 35665:return dv;case 35666:return fv;case 35674:return pv;case 35675:return mv;case 35676:return gv;case 5124:case 35670:return xv;case 35667:case 35671:return _v;case 35668:case 35672:return yv;case 35669:case 35673:return vv;case 5125:return bv;case 36294:return Mv;case 36295:return Sv;case 36296:return wv;case 35678:case 36198:case 36298:case 36306:case 35682:return Tv;case 35679:case 36299:case 36307:return Ev;case 35680:case 36300:case 36308:case 36293:return Av;case 36289:case 36303:case 36311:case 36292:return Cv}}var Ou=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=cv(e.type)}},Fu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Rv(e.type)}},ku=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let n=this.seq;for(let r=0,a=n.length;r!==a;++r){let o=n[r];o.setValue(t,e[o.id],i)}}},Du=/(\w+)(\])?(\[|\.)?/g;function Tp(s,t){s.seq.push(t),s.map[t.id]=t}function Pv(s,t,e){let i=s.name,n=i.length;for(Du.lastIndex=0;;){let r=Du.exec(i),a=Du.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===n){Tp(e,c===void 0?new Ou(o,s,t):new Fu(o,s,t));break}else{let u=e.map[o];u===void 0&&(u=new ku(o),Tp(e,u)),e=u}}}var js=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){let o=t.getActiveUniform(e,a),l=t.getUniformLocation(e,o.name);Pv(o,l,this)}let n=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?n.push(a):r.push(a);n.length>0&&(this.seq=n.concat(r))}setValue(t,e,i,n){let r=this.map[e];r!==void 0&&r.setValue(t,i,n)}setOptional(t,e,i){let n=e[i];n!==void 0&&this.setValue(t,i,n)}static upload(t,e,i,n){for(let r=0,a=e.length;r!==a;++r){let o=e[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(t,l.value,n)}}static seqWithValue(t,e){let i=[];for(let n=0,r=t.length;n!==r;++n){let a=t[n];a.id in e&&i.push(a)}return i}};function Ep(s,t,e){let i=s.createShader(t);return s.shaderSource(i,e),s.compileShader(i),i}var Iv=37297,Nv=0;function Lv(s,t){let e=s.split(`
`),i=[],n=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=n;a<r;a++){let o=a+1;i.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return i.join(`
`)}var Ap=new Ht;function Dv(s){ae._getMatrix(Ap,ae.workingColorSpace,s);let t=`mat3( ${Ap.elements.map(e=>e.toFixed(4))} )`;switch(ae.getTransfer(s)){case Ar:return[t,"LinearTransferOETF"];case de:return[t,"sRGBTransferOETF"];default:return Ft("WebGLProgram: Unsupported color space: ",s),[t,"LinearTransferOETF"]}}function Cp(s,t,e){let i=s.getShaderParameter(t,s.COMPILE_STATUS),r=(s.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+Lv(s.getShaderSource(t),o)}else return r}function Uv(s,t){let e=Dv(t);return[`vec4 ${s}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Ov={[su]:"Linear",[ru]:"Reinhard",[au]:"Cineon",[ou]:"ACESFilmic",[cu]:"AgX",[hu]:"Neutral",[lu]:"Custom"};function Fv(s,t){let e=Ov[t];return e===void 0?(Ft("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+s+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+s+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Xl=new P;function kv(){ae.getLuminanceCoefficients(Xl);let s=Xl.x.toFixed(4),t=Xl.y.toFixed(4),e=Xl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${s}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Bv(s){return[s.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",s.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(pa).join(`
`)}function zv(s){let t=[];for(let e in s){let i=s[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Gv(s,t){let e={},i=s.getProgramParameter(t,s.ACTIVE_ATTRIBUTES);for(let n=0;n<i;n++){let r=s.getActiveAttrib(t,n),a=r.name,o=1;r.type===s.FLOAT_MAT2&&(o=2),r.type===s.FLOAT_MAT3&&(o=3),r.type===s.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:s.getAttribLocation(t,a),locationSize:o}}return e}function pa(s){return s!==""}function Rp(s,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return s.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Pp(s,t){return s.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Vv=/^[ \t]*#include +<([\w\d./]+)>/gm;function Bu(s){return s.replace(Vv,Hv)}function Hv(s,t){let e=Kt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Bu(e)}var Wv=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ip(s){return s.replace(Wv,Xv)}function Xv(s,t,e,i){let n="";for(let r=parseInt(t);r<parseInt(e);r++)n+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return n}function Np(s){let t=`precision ${s.precision} float;
	precision ${s.precision} int;
	precision ${s.precision} sampler2D;
	precision ${s.precision} samplerCube;
	precision ${s.precision} sampler3D;
	precision ${s.precision} sampler2DArray;
	precision ${s.precision} sampler2DShadow;
	precision ${s.precision} samplerCubeShadow;
	precision ${s.precision} sampler2DArrayShadow;
	precision ${s.precision} isampler2D;
	precision ${s.precision} isampler3D;
	precision ${s.precision} isamplerCube;
	precision ${s.precision} isampler2DArray;
	precision ${s.precision} usampler2D;
	precision ${s.precision} usampler3D;
	precision ${s.precision} usamplerCube;
	precision ${s.precision} usampler2DArray;
	`;return s.precision==="highp"?t+=`
#define HIGH_PRECISION`:s.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:s.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var $v={[ra]:"SHADOWMAP_TYPE_PCF",[$s]:"SHADOWMAP_TYPE_VSM"};function qv(s){return $v[s.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Yv={[Ys]:"ENVMAP_MODE_REFRACTION"};function Zv(s){return s.envMap===!1?"ENVMAP_MODE_REFLECTION":Yv[s.envMapMode]||"ENVMAP_MODE_REFLECTION"}var jv={[el]:"ENVMAP_BLENDING_MULTIPLY",[$f]:"ENVMAP_BLENDING_MIX",[qf]:"ENVMAP_BLENDING_ADD"};function Kv(s){return s.envMap===!1?"ENVMAP_BLENDING_NONE":jv[s.combine]||"ENVMAP_BLENDING_NONE"}function Jv(s,t,e,i){let n=s.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,l=qv(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Zv(e),u=Kv(e),d=Bv(e),f=zv(r),p=n.createProgram(),y,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(pa).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(pa).join(`
`),m.length>0&&(m+=`
`)):(y=[Np(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(pa).join(`
`),m=[Np(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==qi?"#define TONE_MAPPING":"",e.toneMapping!==qi?Kt.tonemapping_pars_fragment:"",e.toneMapping!==qi?Fv("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Kt.colorspace_pars_fragment,Uv("linearToOutputTexel",e.outputColorSpace),kv(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(pa).join(`
`)),a=Bu(a),a=Rp(a,e),a=Pp(a,e),o=Bu(o),o=Rp(o,e),o=Pp(o,e),a=Ip(a),o=Ip(o),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===Su?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Su?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let M=g+y+a,w=g+m+o,b=Ep(n,n.VERTEX_SHADER,M),C=Ep(n,n.FRAGMENT_SHADER,w);n.attachShader(p,b),n.attachShader(p,C),e.index0AttributeName!==void 0?n.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&n.bindAttribLocation(p,0,"position"),n.linkProgram(p);function E(R){if(s.debug.checkShaderErrors){let U=n.getProgramInfoLog(p)||"",F=n.getShaderInfoLog(b)||"",W=n.getShaderInfoLog(C)||"",N=U.trim(),G=F.trim(),$=W.trim(),V=!0,nt=!0;if(n.getProgramParameter(p,n.LINK_STATUS)===!1)if(V=!1,typeof s.debug.onShaderError=="function")s.debug.onShaderError(n,p,b,C);else{let X=Cp(n,b,"vertex"),Q=Cp(n,C,"fragment");zt("WebGLProgram: Shader Error "+n.getError()+" - VALIDATE_STATUS "+n.getProgramParameter(p,n.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+N+`
`+X+`
`+Q)}else N!==""?Ft("WebGLProgram: Program Info Log:",N):(G===""||$==="")&&(nt=!1);nt&&(R.diagnostics={runnable:V,programLog:N,vertexShader:{log:G,prefix:y},fragmentShader:{log:$,prefix:m}})}n.deleteShader(b),n.deleteShader(C),_=new js(n,p),T=Gv(n,p)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let O=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=n.getProgramParameter(p,Iv)),O},this.destroy=function(){i.releaseStatesOfProgram(this),n.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Nv++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var Qv=0,zu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let n=this._getShaderCacheForMaterial(t);return n.has(e)===!1&&(n.add(e),e.usedTimes++),n.has(i)===!1&&(n.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Gu(t),e.set(t,i)),i}},Gu=class{constructor(t){this.id=Qv++,this.code=t,this.usedTimes=0}};function tb(s){return s===In||s===ua||s===da}function eb(s,t,e,i,n,r){let a=new Ir,o=new zu,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,T,O,R,U,F){let W=R.fog,N=U.geometry,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?R.environment:null,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=t.get(_.envMap||G,$),nt=d[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&Ft("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,et=Q!==void 0?Q.length:0,wt=0;N.morphAttributes.position!==void 0&&(wt=1),N.morphAttributes.normal!==void 0&&(wt=2),N.morphAttributes.color!==void 0&&(wt=3);let kt,Y,_t,Tt;if(nt){let vt=Zi[nt];kt=vt.vertexShader,Y=vt.fragmentShader}else{kt=_.vertexShader,Y=_.fragmentShader;let vt=o.getVertexShaderStage(_),pe=o.getFragmentShaderStage(_);o.update(_,vt,pe),_t=vt.id,Tt=pe.id}let Dt=s.getRenderTarget(),yt=s.state.buffers.depth.getReversed(),Ut=U.isInstancedMesh===!0,Se=U.isBatchedMesh===!0,Bt=!!_.map,Jt=!!_.matcap,ee=!!V,tt=ee&&V.isPMREMTexture===!0,ht=!!_.aoMap,ot=!!_.lightMap,St=!!_.bumpMap&&_.wireframe===!1,xt=!!_.normalMap,Xt=!!_.displacementMap,Pt=!!_.emissiveMap,ie=!!_.metalnessMap,ne=!!_.roughnessMap,le=_.anisotropy>0,D=_.clearcoat>0,De=_.diffuseRoughness>0,te=_.dispersion>0,xe=_.retroreflectivity>0,pt=_.iridescence>0,Ie=_.sheen>0,Ot=_.transmission>0,Vt=le&&!!_.anisotropyMap,A=D&&!!_.clearcoatMap,v=D&&!!_.clearcoatNormalMap,B=D&&!!_.clearcoatRoughnessMap,st=De&&!!_.diffuseRoughnessMap,J=pt&&!!_.iridescenceMap,lt=pt&&!!_.iridescenceThicknessMap,mt=Ie&&!!_.sheenColorMap,Z=Ie&&!!_.sheenRoughnessMap,j=!!_.specularMap,ut=!!_.specularColorMap,I=!!_.specularIntensityMap,K=Ot&&!!_.transmissionMap,q=Ot&&!!_.thicknessMap,dt=!!_.gradientMap,at=!!_.alphaMap,ct=_.alphaTest>0,It=!!_.alphaHash,Zt=!!_.extensions,rt=qi;_.toneMapped&&(Dt===null||Dt.isXRRenderTarget===!0)&&(rt=s.toneMapping);let Lt=tt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,qt={shaderID:nt,shaderType:_.type,shaderName:_.name,vertexShader:kt,fragmentShader:Y,defines:_.defines,customVertexShaderID:_t,customFragmentShaderID:Tt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:Se,batchingColor:Se&&U._colorsTexture!==null,instancing:Ut,instancingColor:Ut&&U.instanceColor!==null,instancingMorph:Ut&&U.morphTexture!==null,outputColorSpace:Dt===null?s.outputColorSpace:Dt.isXRRenderTarget===!0?Dt.texture.colorSpace:ae.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Bt,matcap:Jt,envMap:ee,envMapMode:ee&&V.mapping,envMapPMREM:tt,envMapMaxLod:tt?Lt.length-1:null,envMapSize:tt?Lt[0].width:null,aoMap:ht,lightMap:ot,bumpMap:St,normalMap:xt,displacementMap:Xt,emissiveMap:Pt,normalMapObjectSpace:xt&&_.normalMapType===jf,normalMapTangentSpace:xt&&_.normalMapType===Vl,packedNormalMap:xt&&_.normalMapType===Vl&&tb(_.normalMap.format),metalnessMap:ie,roughnessMap:ne,anisotropy:le,anisotropyMap:Vt,clearcoat:D,clearcoatMap:A,clearcoatNormalMap:v,clearcoatRoughnessMap:B,diffuseRoughness:De,diffuseRoughnessMap:st,dispersion:te,retroreflection:xe,iridescence:pt,iridescenceMap:J,iridescenceThicknessMap:lt,sheen:Ie,sheenColorMap:mt,sheenRoughnessMap:Z,specularMap:j,specularColorMap:ut,specularIntensityMap:I,transmission:Ot,transmissionMap:K,thicknessMap:q,gradientMap:dt,opaque:_.transparent===!1&&_.blending===qs&&_.alphaToCoverage===!1,alphaMap:at,alphaTest:ct,alphaHash:It,combine:_.combine,mapUv:Bt&&f(_.map.channel),aoMapUv:ht&&f(_.aoMap.channel),lightMapUv:ot&&f(_.lightMap.channel),bumpMapUv:St&&f(_.bumpMap.channel),normalMapUv:xt&&f(_.normalMap.channel),displacementMapUv:Xt&&f(_.displacementMap.channel),emissiveMapUv:Pt&&f(_.emissiveMap.channel),metalnessMapUv:ie&&f(_.metalnessMap.channel),roughnessMapUv:ne&&f(_.roughnessMap.channel),anisotropyMapUv:Vt&&f(_.anisotropyMap.channel),clearcoatMapUv:A&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:v&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:st&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:J&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:lt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:mt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(_.sheenRoughnessMap.channel),specularMapUv:j&&f(_.specularMap.channel),specularColorMapUv:ut&&f(_.specularColorMap.channel),specularIntensityMapUv:I&&f(_.specularIntensityMap.channel),transmissionMapUv:K&&f(_.transmissionMap.channel),thicknessMapUv:q&&f(_.thicknessMap.channel),alphaMapUv:at&&f(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(xt||le),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!N.attributes.uv&&(Bt||at),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&xt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:yt,skinning:U.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:wt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:F.filter(vt=>vt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:s.shadowMap.enabled&&O.length>0,shadowMapType:s.shadowMap.type,toneMapping:rt,decodeVideoTexture:Bt&&_.map.isVideoTexture===!0&&ae.getTransfer(_.map.colorSpace)===de,decodeVideoTextureEmissive:Pt&&_.emissiveMap.isVideoTexture===!0&&ae.getTransfer(_.emissiveMap.colorSpace)===de,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ii,flipSided:_.side===ke,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Zt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&_.extensions.multiDraw===!0||Se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return qt.vertexUv1s=l.has(1),qt.vertexUv2s=l.has(2),qt.vertexUv3s=l.has(3),l.clear(),qt}function y(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let O in _.defines)T.push(O),T.push(_.defines[O]);return _.isRawShaderMaterial===!1&&(m(T,_),g(T,_),T.push(s.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function m(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function g(_,T){a.disableAll(),T.instancing&&a.enable(0),T.instancingColor&&a.enable(1),T.instancingMorph&&a.enable(2),T.matcap&&a.enable(3),T.envMap&&a.enable(4),T.normalMapObjectSpace&&a.enable(5),T.normalMapTangentSpace&&a.enable(6),T.clearcoat&&a.enable(7),T.iridescence&&a.enable(8),T.alphaTest&&a.enable(9),T.vertexColors&&a.enable(10),T.vertexAlphas&&a.enable(11),T.vertexUv1s&&a.enable(12),T.vertexUv2s&&a.enable(13),T.vertexUv3s&&a.enable(14),T.vertexTangents&&a.enable(15),T.anisotropy&&a.enable(16),T.alphaHash&&a.enable(17),T.batching&&a.enable(18),T.dispersion&&a.enable(19),T.retroreflection&&a.enable(24),T.diffuseRoughness&&a.enable(25),T.batchingColor&&a.enable(20),T.gradientMap&&a.enable(21),T.packedNormalMap&&a.enable(22),T.vertexNormals&&a.enable(23),_.push(a.mask),a.disableAll(),T.fog&&a.enable(0),T.useFog&&a.enable(1),T.flatShading&&a.enable(2),T.logarithmicDepthBuffer&&a.enable(3),T.reversedDepthBuffer&&a.enable(4),T.skinning&&a.enable(5),T.morphTargets&&a.enable(6),T.morphNormals&&a.enable(7),T.morphColors&&a.enable(8),T.premultipliedAlpha&&a.enable(9),T.shadowMapEnabled&&a.enable(10),T.doubleSided&&a.enable(11),T.flipSided&&a.enable(12),T.useDepthPacking&&a.enable(13),T.dithering&&a.enable(14),T.transmission&&a.enable(15),T.sheen&&a.enable(16),T.opaque&&a.enable(17),T.pointsUvs&&a.enable(18),T.decodeVideoTexture&&a.enable(19),T.decodeVideoTextureEmissive&&a.enable(20),T.alphaToCoverage&&a.enable(21),T.numLightProbeGrids>0&&a.enable(22),T.hasPositionAttribute&&a.enable(23),_.push(a.mask)}function M(_){let T=d[_.type],O;if(T){let R=Zi[T];O=fp.clone(R.uniforms)}else O=_.uniforms;return O}function w(_,T){let O=h.get(T);return O!==void 0?++O.usedTimes:(O=new Jv(s,T,_,n),c.push(O),h.set(T,O)),O}function b(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){o.remove(_)}function E(){o.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:M,acquireProgram:w,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:E}}function ib(){let s=new WeakMap;function t(a){return s.has(a)}function e(a){let o=s.get(a);return o===void 0&&(o={},s.set(a,o)),o}function i(a){s.delete(a)}function n(a,o,l){s.get(a)[o]=l}function r(){s=new WeakMap}return{has:t,get:e,remove:i,update:n,dispose:r}}function nb(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.material.id!==t.material.id?s.material.id-t.material.id:s.materialVariant!==t.materialVariant?s.materialVariant-t.materialVariant:s.z!==t.z?s.z-t.z:s.id-t.id}function Lp(s,t){return s.groupOrder!==t.groupOrder?s.groupOrder-t.groupOrder:s.renderOrder!==t.renderOrder?s.renderOrder-t.renderOrder:s.z!==t.z?t.z-s.z:s.id-t.id}function Dp(){let s=[],t=0,e=[],i=[],n=[];function r(){t=0,e.length=0,i.length=0,n.length=0}function a(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function o(d,f,p,y,m,g){let M=s[t];return M===void 0?(M={id:d.id,object:d,geometry:f,material:p,materialVariant:a(d),groupOrder:y,renderOrder:d.renderOrder,z:m,group:g},s[t]=M):(M.id=d.id,M.object=d,M.geometry=f,M.material=p,M.materialVariant=a(d),M.groupOrder=y,M.renderOrder=d.renderOrder,M.z=m,M.group=g),t++,M}function l(d,f,p,y,m,g,M){M.reversedDepth===!0&&(m=-m);let w=o(d,f,p,y,m,g);p.transmission>0?i.push(w):p.transparent===!0?n.push(w):e.push(w)}function c(d,f,p,y,m,g){let M=o(d,f,p,y,m,g);p.transmission>0?i.unshift(M):p.transparent===!0?n.unshift(M):e.unshift(M)}function h(d,f){e.length>1&&e.sort(d||nb),i.length>1&&i.sort(f||Lp),n.length>1&&n.sort(f||Lp)}function u(){for(let d=t,f=s.length;d<f;d++){let p=s[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:n,init:r,push:l,unshift:c,finish:u,sort:h}}function sb(){let s=new WeakMap;function t(i,n){let r=s.get(i),a;return r===void 0?(a=new Dp,s.set(i,[a])):n>=r.length?(a=new Dp,r.push(a)):a=r[n],a}function e(){s=new WeakMap}return{get:t,dispose:e}}function rb(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new P,color:new Nt};break;case"SpotLight":e={position:new P,direction:new P,color:new Nt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new P,color:new Nt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new P,skyColor:new Nt,groundColor:new Nt};break;case"RectAreaLight":e={color:new Nt,position:new P,halfWidth:new P,halfHeight:new P};break}return s[t.id]=e,e}}}function ab(){let s={};return{get:function(t){if(s[t.id]!==void 0)return s[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return s[t.id]=e,e}}}var ob=0;function lb(s,t){return(t.castShadow?2:0)-(s.castShadow?2:0)+(t.map?1:0)-(s.map?1:0)}function cb(s){let t=new rb,e=ab(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new P);let n=new P,r=new fe,a=new fe;function o(c){let h=0,u=0,d=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let f=0,p=0,y=0,m=0,g=0,M=0,w=0,b=0,C=0,E=0,_=0,T=0,O=0,R=0;c.sort(lb);for(let F=0,W=c.length;F<W;F++){let N=c[F],G=N.color,$=N.intensity,V=N.distance,nt=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===In?nt=N.shadow.map.texture:nt=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=G.r*$,u+=G.g*$,d+=G.b*$;else if(N.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(N.sh.coefficients[X],$);R++}else if(N.isSunLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=nt;let wt=Q.getViewportCount();for(let kt=0;kt<wt;kt++)i.sunShadowMatrix[y+kt]=Q.getMatrix(kt),i.sunShadowCascade[y+kt]=Q._cascadeData[kt];y+=wt,p++}i.sun[f]=X,f++}else if(N.isDirectionalLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=nt,i.directionalShadowMatrix[m]=N.shadow.matrix,C++}i.directional[m]=X,m++}else if(N.isSpotLight){let X=t.get(N);X.position.setFromMatrixPosition(N.matrixWorld),X.color.copy(G).multiplyScalar($),X.distance=V,X.coneCos=Math.cos(N.angle),X.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),X.decay=N.decay,i.spot[M]=X;let Q=N.shadow;if(N.map&&(i.spotLightMap[T]=N.map,T++,Q.updateMatrices(N),N.castShadow&&O++),i.spotLightMatrix[M]=Q.matrix,N.castShadow){let et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.spotShadow[M]=et,i.spotShadowMap[M]=nt,_++}M++}else if(N.isRectAreaLight){let X=t.get(N);X.color.copy(G).multiplyScalar($),X.halfWidth.set(N.width*.5,0,0),X.halfHeight.set(0,N.height*.5,0),i.rectArea[w]=X,w++}else if(N.isPointLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),X.distance=N.distance,X.decay=N.decay,N.castShadow){let Q=N.shadow,et=e.get(N);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,et.shadowCameraNear=Q.camera.near,et.shadowCameraFar=Q.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=nt,i.pointShadowMatrix[g]=N.shadow.matrix,E++}i.point[g]=X,g++}else if(N.isHemisphereLight){let X=t.get(N);X.skyColor.copy(N.color).multiplyScalar($),X.groundColor.copy(N.groundColor).multiplyScalar($),i.hemi[b]=X,b++}}w>0&&(s.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=bt.LTC_FLOAT_1,i.rectAreaLTC2=bt.LTC_FLOAT_2):(i.rectAreaLTC1=bt.LTC_HALF_1,i.rectAreaLTC2=bt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let U=i.hash;(U.sunLength!==f||U.directionalLength!==m||U.pointLength!==g||U.spotLength!==M||U.rectAreaLength!==w||U.hemiLength!==b||U.numSunShadows!==p||U.numDirectionalShadows!==C||U.numPointShadows!==E||U.numSpotShadows!==_||U.numSpotMaps!==T||U.numLightProbes!==R)&&(i.sun.length=f,i.directional.length=m,i.spot.length=M,i.rectArea.length=w,i.point.length=g,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+T-O,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=O,i.numLightProbes=R,U.sunLength=f,U.directionalLength=m,U.pointLength=g,U.spotLength=M,U.rectAreaLength=w,U.hemiLength=b,U.numSunShadows=p,U.numDirectionalShadows=C,U.numPointShadows=E,U.numSpotShadows=_,U.numSpotMaps=T,U.numLightProbes=R,i.version=ob++)}function l(c,h){let u=0,d=0,f=0,p=0,y=0,m=0,g=h.matrixWorldInverse;for(let M=0,w=c.length;M<w;M++){let b=c[M];if(b.isSunLight){let C=i.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),n.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(n),C.direction.transformDirection(g),d++}else if(b.isSpotLight){let C=i.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(b.matrixWorld),n.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(n),C.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let C=i.rectArea[y];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),a.identity(),r.copy(b.matrixWorld),r.premultiply(g),a.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),y++}else if(b.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:o,setupView:l,state:i}}function Up(s){let t=new cb(s),e=[],i=[],n=[];function r(u){h.camera=u,e.length=0,i.length=0,n.length=0}function a(u){u.isLightProbeGrid?n.push(u):e.push(u)}function o(u){i.push(u)}function l(){t.setup(e),n.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:n,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function hb(s){let t=new WeakMap;function e(n,r=0){let a=t.get(n),o;return a===void 0?(o=new Up(s),t.set(n,[o])):r>=a.length?(o=new Up(s),a.push(o)):o=a[r],o}function i(){t=new WeakMap}return{get:e,dispose:i}}var ub=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,db=`uniform sampler2D shadow_pass;
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
}`,fb=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],pb=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],Op=new fe,fa=new P,Uu=new P;function mb(s,t,e){let i=new Tn,n=new it,r=new it,a=new Ae,o=new Go,l=new Vo,c={},h=e.maxTextureSize,u={[Pn]:ke,[ke]:Pn,[ii]:ii},d=new Wi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:ub,fragmentShader:db}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Me;p.setAttribute("position",new Ne(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Pe(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ra;let g=this.type;this.render=function(E,_,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Af&&(Ft("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ra);let O=s.getRenderTarget(),R=s.getActiveCubeFace(),U=s.getActiveMipmapLevel(),F=s.state;F.setBlending(ts),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let W=g!==this.type;W&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(G=>G.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,G=E.length;N<G;N++){let $=E[N],V=$.shadow;if(V===void 0){Ft("WebGLShadowMap:",$,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;n.copy(V.mapSize);let nt=V.getFrameExtents();n.multiply(nt),r.copy(V.mapSize),(n.x>h||n.y>h)&&(n.x>h&&(r.x=Math.floor(h/nt.x),n.x=r.x*nt.x,V.mapSize.x=r.x),n.y>h&&(r.y=Math.floor(h/nt.y),n.y=r.y*nt.y,V.mapSize.y=r.y));let X=s.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||W===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===$s){if($.isPointLight){Ft("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new xi(n.x,n.y,{format:In,type:Li,minFilter:ai,magFilter:ai,generateMipmaps:!1}),V.map.texture.name=$.name+".shadowMap",V.map.depthTexture=new on(n.x,n.y,wi),V.map.depthTexture.name=$.name+".shadowMapDepth",V.map.depthTexture.format=sn,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qe,V.map.depthTexture.magFilter=qe}else $.isPointLight?(V.map=new ma(n.x),V.map.depthTexture=new Br(n.x,Ni)):(V.map=new xi(n.x,n.y),V.map.depthTexture=new on(n.x,n.y,Ni)),V.map.depthTexture.name=$.name+".shadowMap",V.map.depthTexture.format=sn,this.type===ra?(V.map.depthTexture.compareFunction=X?yu:_u,V.map.depthTexture.minFilter=ai,V.map.depthTexture.magFilter=ai):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qe,V.map.depthTexture.magFilter=qe);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==n.x||V.map.height!==n.y)&&V.map.setSize(n.x,n.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();$.isPointLight!==!0&&V.updateMatrices($,T);let et=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:T.layers;for(let wt=0;wt<Q;wt++){let kt=V.getCamera(wt);if($.isPointLight){let Y=V.camera,_t=V.matrix,Tt=$.distance||Y.far;Tt!==Y.far&&(Y.far=Tt,Y.updateProjectionMatrix()),fa.setFromMatrixPosition($.matrixWorld),Y.position.copy(fa),Uu.copy(Y.position),Uu.add(fb[wt]),Y.up.copy(pb[wt]),Y.lookAt(Uu),Y.updateMatrixWorld(),_t.makeTranslation(-fa.x,-fa.y,-fa.z),Op.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Op,Y.coordinateSystem,Y.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)s.setRenderTarget(V.map,wt),s.clear();else{wt===0&&(s.setRenderTarget(V.map),s.clear());let Y=V.getViewport(wt);a.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),F.viewport(a)}i=V.getFrustum(wt),b(_,T,kt,$,et,this.type)}V.isPointLightShadow!==!0&&this.type===$s&&M(V,T),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,s.setRenderTarget(O,R,U)};function M(E,_){let T=t.update(y);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new xi(n.x,n.y,{format:In,type:Li}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,s.setRenderTarget(E.mapPass),s.clear(),s.renderBufferDirect(_,null,T,d,y,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,s.setRenderTarget(E.map),s.clear(),s.renderBufferDirect(_,null,T,f,y,null)}function w(E,_,T,O){let R=null,U=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(U!==void 0)R=U;else if(R=T.isPointLight===!0?l:o,s.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let F=R.uuid,W=_.uuid,N=c[F];N===void 0&&(N={},c[F]=N);let G=N[W];G===void 0&&(G=R.clone(),N[W]=G,_.addEventListener("dispose",C)),R=G}if(R.visible=_.visible,R.wireframe=_.wireframe,O===$s?R.side=_.shadowSide!==null?_.shadowSide:_.side:R.side=_.shadowSide!==null?_.shadowSide:u[_.side],R.alphaMap=_.alphaMap,R.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,R.map=_.map,R.clipShadows=_.clipShadows,R.clippingPlanes=_.clippingPlanes,R.clipIntersection=_.clipIntersection,R.displacementMap=_.displacementMap,R.displacementScale=_.displacementScale,R.displacementBias=_.displacementBias,R.wireframeLinewidth=_.wireframeLinewidth,R.linewidth=_.linewidth,T.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let F=s.properties.get(R);F.light=T}return R}function b(E,_,T,O,R,U){if(E.visible===!1)return;if(E.layers.test(R)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&U===$s)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let N=t.update(E),G=E.material;if(Array.isArray(G)){let $=N.groups;for(let V=0,nt=$.length;V<nt;V++){let X=$[V],Q=G[X.materialIndex];if(Q&&Q.visible){let et=w(E,Q,O,U);E.onBeforeShadow(s,E,_,T,N,et,X),s.renderBufferDirect(T,null,N,et,E,X),E.onAfterShadow(s,E,_,T,N,et,X)}}}else if(G.visible){let $=w(E,G,O,U);E.onBeforeShadow(s,E,_,T,N,$,null),s.renderBufferDirect(T,null,N,$,E,null),E.onAfterShadow(s,E,_,T,N,$,null)}}let W=E.children;for(let N=0,G=W.length;N<G;N++)b(W[N],_,T,O,R,U)}function C(E){E.target.removeEventListener("dispose",C);for(let T in c){let O=c[T],R=E.target.uuid;R in O&&(O[R].dispose(),delete O[R])}}}function gb(s,t){function e(){let I=!1,K=new Ae,q=null,dt=new Ae(0,0,0,0);return{setMask:function(at){q!==at&&!I&&(s.colorMask(at,at,at,at),q=at)},setLocked:function(at){I=at},setClear:function(at,ct,It,Zt,rt){rt===!0&&(at*=Zt,ct*=Zt,It*=Zt),K.set(at,ct,It,Zt),dt.equals(K)===!1&&(s.clearColor(at,ct,It,Zt),dt.copy(K))},reset:function(){I=!1,q=null,dt.set(-1,0,0,0)}}}function i(){let I=!1,K=!1,q=null,dt=null,at=null;return{setReversed:function(ct){if(K!==ct){let It=t.get("EXT_clip_control");ct?It.clipControlEXT(It.LOWER_LEFT_EXT,It.ZERO_TO_ONE_EXT):It.clipControlEXT(It.LOWER_LEFT_EXT,It.NEGATIVE_ONE_TO_ONE_EXT),K=ct;let Zt=at;at=null,this.setClear(Zt)}},getReversed:function(){return K},setTest:function(ct){ct?yt(s.DEPTH_TEST):Ut(s.DEPTH_TEST)},setMask:function(ct){q!==ct&&!I&&(s.depthMask(ct),q=ct)},setFunc:function(ct){if(K&&(ct=ap[ct]),dt!==ct){switch(ct){case go:s.depthFunc(s.NEVER);break;case xo:s.depthFunc(s.ALWAYS);break;case _o:s.depthFunc(s.LESS);break;case Ns:s.depthFunc(s.LEQUAL);break;case yo:s.depthFunc(s.EQUAL);break;case vo:s.depthFunc(s.GEQUAL);break;case bo:s.depthFunc(s.GREATER);break;case Mo:s.depthFunc(s.NOTEQUAL);break;default:s.depthFunc(s.LEQUAL)}dt=ct}},setLocked:function(ct){I=ct},setClear:function(ct){at!==ct&&(at=ct,K&&(ct=1-ct),s.clearDepth(ct))},reset:function(){I=!1,q=null,dt=null,at=null,K=!1}}}function n(){let I=!1,K=null,q=null,dt=null,at=null,ct=null,It=null,Zt=null,rt=null;return{setTest:function(Lt){I||(Lt?yt(s.STENCIL_TEST):Ut(s.STENCIL_TEST))},setMask:function(Lt){K!==Lt&&!I&&(s.stencilMask(Lt),K=Lt)},setFunc:function(Lt,qt,vt){(q!==Lt||dt!==qt||at!==vt)&&(s.stencilFunc(Lt,qt,vt),q=Lt,dt=qt,at=vt)},setOp:function(Lt,qt,vt){(ct!==Lt||It!==qt||Zt!==vt)&&(s.stencilOp(Lt,qt,vt),ct=Lt,It=qt,Zt=vt)},setLocked:function(Lt){I=Lt},setClear:function(Lt){rt!==Lt&&(s.clearStencil(Lt),rt=Lt)},reset:function(){I=!1,K=null,q=null,dt=null,at=null,ct=null,It=null,Zt=null,rt=null}}}let r=new e,a=new i,o=new n,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],y=null,m=!1,g=null,M=null,w=null,b=null,C=null,E=null,_=null,T=new Nt(0,0,0),O=0,R=!1,U=null,F=null,W=null,N=null,G=null,$=s.getParameter(s.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,nt=0,X=s.getParameter(s.VERSION);X.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=nt>=1):X.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=nt>=2);let Q=null,et={},wt=s.getParameter(s.SCISSOR_BOX),kt=s.getParameter(s.VIEWPORT),Y=new Ae().fromArray(wt),_t=new Ae().fromArray(kt);function Tt(I,K,q,dt){let at=new Uint8Array(4),ct=s.createTexture();s.bindTexture(I,ct),s.texParameteri(I,s.TEXTURE_MIN_FILTER,s.NEAREST),s.texParameteri(I,s.TEXTURE_MAG_FILTER,s.NEAREST);for(let It=0;It<q;It++)I===s.TEXTURE_3D||I===s.TEXTURE_2D_ARRAY?s.texImage3D(K,0,s.RGBA,1,1,dt,0,s.RGBA,s.UNSIGNED_BYTE,at):s.texImage2D(K+It,0,s.RGBA,1,1,0,s.RGBA,s.UNSIGNED_BYTE,at);return ct}let Dt={};Dt[s.TEXTURE_2D]=Tt(s.TEXTURE_2D,s.TEXTURE_2D,1),Dt[s.TEXTURE_CUBE_MAP]=Tt(s.TEXTURE_CUBE_MAP,s.TEXTURE_CUBE_MAP_POSITIVE_X,6),Dt[s.TEXTURE_2D_ARRAY]=Tt(s.TEXTURE_2D_ARRAY,s.TEXTURE_2D_ARRAY,1,1),Dt[s.TEXTURE_3D]=Tt(s.TEXTURE_3D,s.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),yt(s.DEPTH_TEST),a.setFunc(Ns),St(!1),xt(Jh),yt(s.CULL_FACE),ht(ts);function yt(I){h[I]!==!0&&(s.enable(I),h[I]=!0)}function Ut(I){h[I]!==!1&&(s.disable(I),h[I]=!1)}function Se(I,K){return d[I]!==K?(s.bindFramebuffer(I,K),d[I]=K,I===s.DRAW_FRAMEBUFFER&&(d[s.FRAMEBUFFER]=K),I===s.FRAMEBUFFER&&(d[s.DRAW_FRAMEBUFFER]=K),!0):!1}function Bt(I,K){let q=p,dt=!1;if(I){q=f.get(K),q===void 0&&(q=[],f.set(K,q));let at=I.textures;if(q.length!==at.length||q[0]!==s.COLOR_ATTACHMENT0){for(let ct=0,It=at.length;ct<It;ct++)q[ct]=s.COLOR_ATTACHMENT0+ct;q.length=at.length,dt=!0}}else q[0]!==s.BACK&&(q[0]=s.BACK,dt=!0);dt&&s.drawBuffers(q)}function Jt(I){return y!==I?(s.useProgram(I),y=I,!0):!1}let ee={[es]:s.FUNC_ADD,[Rf]:s.FUNC_SUBTRACT,[Pf]:s.FUNC_REVERSE_SUBTRACT};ee[If]=s.MIN,ee[Nf]=s.MAX;let tt={[Lf]:s.ZERO,[Df]:s.ONE,[Uf]:s.SRC_COLOR,[iu]:s.SRC_ALPHA,[Gf]:s.SRC_ALPHA_SATURATE,[Bf]:s.DST_COLOR,[Ff]:s.DST_ALPHA,[Of]:s.ONE_MINUS_SRC_COLOR,[nu]:s.ONE_MINUS_SRC_ALPHA,[zf]:s.ONE_MINUS_DST_COLOR,[kf]:s.ONE_MINUS_DST_ALPHA,[Vf]:s.CONSTANT_COLOR,[Hf]:s.ONE_MINUS_CONSTANT_COLOR,[Wf]:s.CONSTANT_ALPHA,[Xf]:s.ONE_MINUS_CONSTANT_ALPHA};function ht(I,K,q,dt,at,ct,It,Zt,rt,Lt){if(I===ts){m===!0&&(Ut(s.BLEND),m=!1);return}if(m===!1&&(yt(s.BLEND),m=!0),I!==Cf){if(I!==g||Lt!==R){if((M!==es||C!==es)&&(s.blendEquation(s.FUNC_ADD),M=es,C=es),Lt)switch(I){case qs:s.blendFuncSeparate(s.ONE,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case Qh:s.blendFunc(s.ONE,s.ONE);break;case tu:s.blendFuncSeparate(s.ZERO,s.ONE_MINUS_SRC_COLOR,s.ZERO,s.ONE);break;case eu:s.blendFuncSeparate(s.DST_COLOR,s.ONE_MINUS_SRC_ALPHA,s.ZERO,s.ONE);break;default:zt("WebGLState: Invalid blending: ",I);break}else switch(I){case qs:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE_MINUS_SRC_ALPHA,s.ONE,s.ONE_MINUS_SRC_ALPHA);break;case Qh:s.blendFuncSeparate(s.SRC_ALPHA,s.ONE,s.ONE,s.ONE);break;case tu:zt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case eu:zt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:zt("WebGLState: Invalid blending: ",I);break}w=null,b=null,E=null,_=null,T.set(0,0,0),O=0,g=I,R=Lt}return}at=at||K,ct=ct||q,It=It||dt,(K!==M||at!==C)&&(s.blendEquationSeparate(ee[K],ee[at]),M=K,C=at),(q!==w||dt!==b||ct!==E||It!==_)&&(s.blendFuncSeparate(tt[q],tt[dt],tt[ct],tt[It]),w=q,b=dt,E=ct,_=It),(Zt.equals(T)===!1||rt!==O)&&(s.blendColor(Zt.r,Zt.g,Zt.b,rt),T.copy(Zt),O=rt),g=I,R=!1}function ot(I,K){I.side===ii?Ut(s.CULL_FACE):yt(s.CULL_FACE);let q=I.side===ke;K&&(q=!q),St(q),I.blending===qs&&I.transparent===!1?ht(ts):ht(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),a.setFunc(I.depthFunc),a.setTest(I.depthTest),a.setMask(I.depthWrite),r.setMask(I.colorWrite);let dt=I.stencilWrite;o.setTest(dt),dt&&(o.setMask(I.stencilWriteMask),o.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),o.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),Pt(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?yt(s.SAMPLE_ALPHA_TO_COVERAGE):Ut(s.SAMPLE_ALPHA_TO_COVERAGE)}function St(I){U!==I&&(I?s.frontFace(s.CW):s.frontFace(s.CCW),U=I)}function xt(I){I!==Tf?(yt(s.CULL_FACE),I!==F&&(I===Jh?s.cullFace(s.BACK):I===Ef?s.cullFace(s.FRONT):s.cullFace(s.FRONT_AND_BACK))):Ut(s.CULL_FACE),F=I}function Xt(I){I!==W&&(V&&s.lineWidth(I),W=I)}function Pt(I,K,q){I?(yt(s.POLYGON_OFFSET_FILL),(N!==K||G!==q)&&(N=K,G=q,a.getReversed()&&(K=-K,q=-q),s.polygonOffset(K,q))):Ut(s.POLYGON_OFFSET_FILL)}function ie(I){I?yt(s.SCISSOR_TEST):Ut(s.SCISSOR_TEST)}function ne(I){I===void 0&&(I=s.TEXTURE0+$-1),Q!==I&&(s.activeTexture(I),Q=I)}function le(I,K,q){q===void 0&&(Q===null?q=s.TEXTURE0+$-1:q=Q);let dt=et[q];dt===void 0&&(dt={type:void 0,texture:void 0},et[q]=dt),(dt.type!==I||dt.texture!==K)&&(Q!==q&&(s.activeTexture(q),Q=q),s.bindTexture(I,K||Dt[I]),dt.type=I,dt.texture=K)}function D(){let I=et[Q];I!==void 0&&I.type!==void 0&&(s.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}function De(){try{s.compressedTexImage2D(...arguments)}catch(I){zt("WebGLState:",I)}}function te(){try{s.compressedTexImage3D(...arguments)}catch(I){zt("WebGLState:",I)}}function xe(){try{s.texSubImage2D(...arguments)}catch(I){zt("WebGLState:",I)}}function pt(){try{s.texSubImage3D(...arguments)}catch(I){zt("WebGLState:",I)}}function Ie(){try{s.compressedTexSubImage2D(...arguments)}catch(I){zt("WebGLState:",I)}}function Ot(){try{s.compressedTexSubImage3D(...arguments)}catch(I){zt("WebGLState:",I)}}function Vt(){try{s.texStorage2D(...arguments)}catch(I){zt("WebGLState:",I)}}function A(){try{s.texStorage3D(...arguments)}catch(I){zt("WebGLState:",I)}}function v(){try{s.texImage2D(...arguments)}catch(I){zt("WebGLState:",I)}}function B(){try{s.texImage3D(...arguments)}catch(I){zt("WebGLState:",I)}}function st(I){return u[I]!==void 0?u[I]:s.getParameter(I)}function J(I,K){u[I]!==K&&(s.pixelStorei(I,K),u[I]=K)}function lt(I){Y.equals(I)===!1&&(s.scissor(I.x,I.y,I.z,I.w),Y.copy(I))}function mt(I){_t.equals(I)===!1&&(s.viewport(I.x,I.y,I.z,I.w),_t.copy(I))}function Z(I,K){let q=c.get(K);q===void 0&&(q=new WeakMap,c.set(K,q));let dt=q.get(I);dt===void 0&&(dt=s.getUniformBlockIndex(K,I.name),s.uniformBlockBinding(K,dt,dt),q.set(I,dt))}function j(I,K,q){let at=c.get(K).get(I);l[at]!==q&&(s.bindBufferBase(s.UNIFORM_BUFFER,at,q),l[at]=q)}function ut(){s.disable(s.BLEND),s.disable(s.CULL_FACE),s.disable(s.DEPTH_TEST),s.disable(s.POLYGON_OFFSET_FILL),s.disable(s.SCISSOR_TEST),s.disable(s.STENCIL_TEST),s.disable(s.SAMPLE_ALPHA_TO_COVERAGE),s.blendEquation(s.FUNC_ADD),s.blendFunc(s.ONE,s.ZERO),s.blendFuncSeparate(s.ONE,s.ZERO,s.ONE,s.ZERO),s.blendColor(0,0,0,0),s.colorMask(!0,!0,!0,!0),s.clearColor(0,0,0,0),s.depthMask(!0),s.depthFunc(s.LESS),a.setReversed(!1),s.clearDepth(1),s.stencilMask(4294967295),s.stencilFunc(s.ALWAYS,0,4294967295),s.stencilOp(s.KEEP,s.KEEP,s.KEEP),s.clearStencil(0),s.cullFace(s.BACK),s.frontFace(s.CCW),s.polygonOffset(0,0),s.activeTexture(s.TEXTURE0),s.bindFramebuffer(s.FRAMEBUFFER,null),s.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),s.bindFramebuffer(s.READ_FRAMEBUFFER,null),s.useProgram(null),s.lineWidth(1),s.scissor(0,0,s.canvas.width,s.canvas.height),s.viewport(0,0,s.canvas.width,s.canvas.height),s.pixelStorei(s.PACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_ALIGNMENT,4),s.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,!1),s.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),s.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,s.BROWSER_DEFAULT_WEBGL),s.pixelStorei(s.PACK_ROW_LENGTH,0),s.pixelStorei(s.PACK_SKIP_PIXELS,0),s.pixelStorei(s.PACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_ROW_LENGTH,0),s.pixelStorei(s.UNPACK_IMAGE_HEIGHT,0),s.pixelStorei(s.UNPACK_SKIP_PIXELS,0),s.pixelStorei(s.UNPACK_SKIP_ROWS,0),s.pixelStorei(s.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,et={},d={},l={},f=new WeakMap,p=[],y=null,m=!1,g=null,M=null,w=null,b=null,C=null,E=null,_=null,T=new Nt(0,0,0),O=0,R=!1,U=null,F=null,W=null,N=null,G=null,Y.set(0,0,s.canvas.width,s.canvas.height),_t.set(0,0,s.canvas.width,s.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:yt,disable:Ut,bindFramebuffer:Se,drawBuffers:Bt,useProgram:Jt,setBlending:ht,setMaterial:ot,setFlipSided:St,setCullFace:xt,setLineWidth:Xt,setPolygonOffset:Pt,setScissorTest:ie,activeTexture:ne,bindTexture:le,unbindTexture:D,compressedTexImage2D:De,compressedTexImage3D:te,texImage2D:v,texImage3D:B,pixelStorei:J,getParameter:st,updateUBOMapping:Z,uniformBlockBinding:j,texStorage2D:Vt,texStorage3D:A,texSubImage2D:xe,texSubImage3D:pt,compressedTexSubImage2D:Ie,compressedTexSubImage3D:Ot,scissor:lt,viewport:mt,reset:ut}}function xb(s,t,e,i,n,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,y=new FinalizationRegistry(A=>p.delete(A)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(A,v){return m?new OffscreenCanvas(A,v):Cr("canvas")}function M(A,v,B){let st=1,J=Vt(A);if((J.width>B||J.height>B)&&(st=B/Math.max(J.width,J.height)),st<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let lt=Math.floor(st*J.width),mt=Math.floor(st*J.height);d===void 0&&(d=g(lt,mt));let Z=v?g(lt,mt):d;return Z.width=lt,Z.height=mt,Z.getContext("2d").drawImage(A,0,0,lt,mt),Ft("WebGLRenderer: Texture has been resized from ("+J.width+"x"+J.height+") to ("+lt+"x"+mt+")."),Z}else return"data"in A&&Ft("WebGLRenderer: Image in DataTexture is too big ("+J.width+"x"+J.height+")."),A;return A}function w(A){return A.generateMipmaps}function b(A){s.generateMipmap(A)}function C(A){return A.isWebGLCubeRenderTarget?s.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?s.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?s.TEXTURE_2D_ARRAY:s.TEXTURE_2D}function E(A,v,B,st,J,lt=!1){if(A!==null){if(s[A]!==void 0)return s[A];Ft("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let mt;st&&(mt=t.get("EXT_texture_norm16"),mt||Ft("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=v;if(v===s.RED&&(B===s.FLOAT&&(Z=s.R32F),B===s.HALF_FLOAT&&(Z=s.R16F),B===s.UNSIGNED_BYTE&&(Z=s.R8),B===s.UNSIGNED_SHORT&&mt&&(Z=mt.R16_EXT),B===s.SHORT&&mt&&(Z=mt.R16_SNORM_EXT)),v===s.RED_INTEGER&&(B===s.UNSIGNED_BYTE&&(Z=s.R8UI),B===s.UNSIGNED_SHORT&&(Z=s.R16UI),B===s.UNSIGNED_INT&&(Z=s.R32UI),B===s.BYTE&&(Z=s.R8I),B===s.SHORT&&(Z=s.R16I),B===s.INT&&(Z=s.R32I)),v===s.RG&&(B===s.FLOAT&&(Z=s.RG32F),B===s.HALF_FLOAT&&(Z=s.RG16F),B===s.UNSIGNED_BYTE&&(Z=s.RG8),B===s.UNSIGNED_SHORT&&mt&&(Z=mt.RG16_EXT),B===s.SHORT&&mt&&(Z=mt.RG16_SNORM_EXT)),v===s.RG_INTEGER&&(B===s.UNSIGNED_BYTE&&(Z=s.RG8UI),B===s.UNSIGNED_SHORT&&(Z=s.RG16UI),B===s.UNSIGNED_INT&&(Z=s.RG32UI),B===s.BYTE&&(Z=s.RG8I),B===s.SHORT&&(Z=s.RG16I),B===s.INT&&(Z=s.RG32I)),v===s.RGB_INTEGER&&(B===s.UNSIGNED_BYTE&&(Z=s.RGB8UI),B===s.UNSIGNED_SHORT&&(Z=s.RGB16UI),B===s.UNSIGNED_INT&&(Z=s.RGB32UI),B===s.BYTE&&(Z=s.RGB8I),B===s.SHORT&&(Z=s.RGB16I),B===s.INT&&(Z=s.RGB32I)),v===s.RGBA_INTEGER&&(B===s.UNSIGNED_BYTE&&(Z=s.RGBA8UI),B===s.UNSIGNED_SHORT&&(Z=s.RGBA16UI),B===s.UNSIGNED_INT&&(Z=s.RGBA32UI),B===s.BYTE&&(Z=s.RGBA8I),B===s.SHORT&&(Z=s.RGBA16I),B===s.INT&&(Z=s.RGBA32I)),v===s.RGB&&(B===s.UNSIGNED_SHORT&&mt&&(Z=mt.RGB16_EXT),B===s.SHORT&&mt&&(Z=mt.RGB16_SNORM_EXT),B===s.UNSIGNED_INT_5_9_9_9_REV&&(Z=s.RGB9_E5),B===s.UNSIGNED_INT_10F_11F_11F_REV&&(Z=s.R11F_G11F_B10F)),v===s.RGBA){let j=lt?Ar:ae.getTransfer(J);B===s.FLOAT&&(Z=s.RGBA32F),B===s.HALF_FLOAT&&(Z=s.RGBA16F),B===s.UNSIGNED_BYTE&&(Z=j===de?s.SRGB8_ALPHA8:s.RGBA8),B===s.UNSIGNED_SHORT&&mt&&(Z=mt.RGBA16_EXT),B===s.SHORT&&mt&&(Z=mt.RGBA16_SNORM_EXT),B===s.UNSIGNED_SHORT_4_4_4_4&&(Z=s.RGBA4),B===s.UNSIGNED_SHORT_5_5_5_1&&(Z=s.RGB5_A1)}return(Z===s.R16F||Z===s.R32F||Z===s.RG16F||Z===s.RG32F||Z===s.RGBA16F||Z===s.RGBA32F)&&t.get("EXT_color_buffer_float"),Z}function _(A,v){let B;return A?v===null||v===Ni||v===ns?B=s.DEPTH24_STENCIL8:v===wi?B=s.DEPTH32F_STENCIL8:v===Zs&&(B=s.DEPTH24_STENCIL8,Ft("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===Ni||v===ns?B=s.DEPTH_COMPONENT24:v===wi?B=s.DEPTH_COMPONENT32F:v===Zs&&(B=s.DEPTH_COMPONENT16),B}function T(A,v){return w(A)===!0||A.isFramebufferTexture&&A.minFilter!==qe&&A.minFilter!==ai?Math.log2(Math.max(v.width,v.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?v.mipmaps.length:1}function O(A){let v=new WeakRef(A);i.get(A).__ref=v,p.add(v),y.register(A,v,v)}function R(A){let v=i.get(A).__ref;v!==void 0&&(p.delete(v),y.unregister(v))}function U(A){W(A.target)}function F(A){N(A.target)}function W(A){A.removeEventListener("dispose",U),R(A),$(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&u.delete(A)}function N(A){A.removeEventListener("dispose",F),R(A),nt(A)}function G(){for(let A of p){let v=A.deref();v!==void 0&&(v.isRenderTarget===!0?N(v):W(v))}p.clear(),u.clear()}function $(A){let v=i.get(A);if(v.__webglInit===void 0)return;let B=A.source,st=f.get(B);if(st){let J=st[v.__cacheKey];J.usedTimes--,J.usedTimes===0&&V(A),Object.keys(st).length===0&&f.delete(B)}i.remove(A)}function V(A){let v=i.get(A);s.deleteTexture(v.__webglTexture);let B=A.source,st=f.get(B);delete st[v.__cacheKey],a.memory.textures--}function nt(A){let v=i.get(A);v.__depthDisposeCallback&&v.__depthDisposeCallback();let B=A.depthTexture;if(B&&B.renderTarget===A&&W(B),A.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(v.__webglFramebuffer[J]))for(let lt=0;lt<v.__webglFramebuffer[J].length;lt++)s.deleteFramebuffer(v.__webglFramebuffer[J][lt]);else s.deleteFramebuffer(v.__webglFramebuffer[J]);v.__webglDepthbuffer&&s.deleteRenderbuffer(v.__webglDepthbuffer[J])}else{if(Array.isArray(v.__webglFramebuffer))for(let J=0;J<v.__webglFramebuffer.length;J++)s.deleteFramebuffer(v.__webglFramebuffer[J]);else s.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&s.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&s.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let J=0;J<v.__webglColorRenderbuffer.length;J++)v.__webglColorRenderbuffer[J]&&s.deleteRenderbuffer(v.__webglColorRenderbuffer[J]);v.__webglDepthRenderbuffer&&s.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let st=A.textures;for(let J=0,lt=st.length;J<lt;J++){let mt=i.get(st[J]);mt.__webglTexture&&(s.deleteTexture(mt.__webglTexture),a.memory.textures--),i.remove(st[J])}i.remove(A)}let X=0;function Q(){X=0}function et(){return X}function wt(A){X=A}function kt(){let A=X;return A>=n.maxTextures&&Ft("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+n.maxTextures),X+=1,A}function Y(A){let v=[];return v.push(A.wrapS),v.push(A.wrapT),v.push(A.wrapR||0),v.push(A.magFilter),v.push(A.minFilter),v.push(A.anisotropy),v.push(A.internalFormat),v.push(A.format),v.push(A.type),v.push(A.generateMipmaps),v.push(A.mipmapsAutoUpdate),v.push(A.premultiplyAlpha),v.push(A.flipY),v.push(A.unpackAlignment),v.push(A.colorSpace),v.join()}function _t(A,v){let B=i.get(A);if(A.isVideoTexture&&Ie(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&B.__version!==A.version){let st=A.image;if(st===null)Ft("WebGLRenderer: Texture marked for update but no image data found.");else if(st.complete===!1)Ft("WebGLRenderer: Texture marked for update but image is incomplete");else{ot(B,A,v);return}}else A.isExternalTexture&&(B.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(s.TEXTURE_2D,B.__webglTexture,s.TEXTURE0+v)}function Tt(A,v){let B=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&B.__version!==A.version){ot(B,A,v);return}else A.isExternalTexture&&(B.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(s.TEXTURE_2D_ARRAY,B.__webglTexture,s.TEXTURE0+v)}function Dt(A,v){let B=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&B.__version!==A.version){ot(B,A,v);return}e.bindTexture(s.TEXTURE_3D,B.__webglTexture,s.TEXTURE0+v)}function yt(A,v){let B=i.get(A);if(A.version>0&&B.__version!==A.version){St(B,A,v);return}e.bindTexture(s.TEXTURE_CUBE_MAP,B.__webglTexture,s.TEXTURE0+v)}let Ut={[So]:s.REPEAT,[Bi]:s.CLAMP_TO_EDGE,[wo]:s.MIRRORED_REPEAT},Se={[qe]:s.NEAREST,[Yf]:s.NEAREST_MIPMAP_NEAREST,[aa]:s.NEAREST_MIPMAP_LINEAR,[ai]:s.LINEAR,[sl]:s.LINEAR_MIPMAP_NEAREST,[cn]:s.LINEAR_MIPMAP_LINEAR},Bt={[Jf]:s.NEVER,[vu]:s.ALWAYS,[Qf]:s.LESS,[_u]:s.LEQUAL,[tp]:s.EQUAL,[yu]:s.GEQUAL,[ep]:s.GREATER,[ip]:s.NOTEQUAL};function Jt(A,v){if(v.type===wi&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===ai||v.magFilter===sl||v.magFilter===aa||v.magFilter===cn||v.minFilter===ai||v.minFilter===sl||v.minFilter===aa||v.minFilter===cn)&&Ft("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),s.texParameteri(A,s.TEXTURE_WRAP_S,Ut[v.wrapS]),s.texParameteri(A,s.TEXTURE_WRAP_T,Ut[v.wrapT]),(A===s.TEXTURE_3D||A===s.TEXTURE_2D_ARRAY)&&s.texParameteri(A,s.TEXTURE_WRAP_R,Ut[v.wrapR]),s.texParameteri(A,s.TEXTURE_MAG_FILTER,Se[v.magFilter]),s.texParameteri(A,s.TEXTURE_MIN_FILTER,Se[v.minFilter]),v.compareFunction&&(s.texParameteri(A,s.TEXTURE_COMPARE_MODE,s.COMPARE_REF_TO_TEXTURE),s.texParameteri(A,s.TEXTURE_COMPARE_FUNC,Bt[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===qe||v.minFilter!==aa&&v.minFilter!==cn||v.type===wi&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||i.get(v).__currentAnisotropy){let B=t.get("EXT_texture_filter_anisotropic");s.texParameterf(A,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,n.getMaxAnisotropy())),i.get(v).__currentAnisotropy=v.anisotropy}}}function ee(A,v){let B=!1;A.__webglInit===void 0&&(A.__webglInit=!0,v.addEventListener("dispose",U),O(v));let st=v.source,J=f.get(st);J===void 0&&(J={},f.set(st,J));let lt=Y(v);if(lt!==A.__cacheKey){J[lt]===void 0&&(J[lt]={texture:s.createTexture(),usedTimes:0},a.memory.textures++,B=!0),J[lt].usedTimes++;let mt=J[A.__cacheKey];mt!==void 0&&(J[A.__cacheKey].usedTimes--,mt.usedTimes===0&&V(v)),A.__cacheKey=lt,A.__webglTexture=J[lt].texture}return B}function tt(A,v,B){return Math.floor(Math.floor(A/B)/v)}function ht(A,v,B,st){let lt=A.updateRanges;if(lt.length===0)e.texSubImage2D(s.TEXTURE_2D,0,0,0,v.width,v.height,B,st,v.data);else{lt.sort((I,K)=>I.start-K.start);let mt=0;for(let I=1;I<lt.length;I++){let K=lt[mt],q=lt[I],dt=K.start+K.count,at=tt(q.start,v.width,4),ct=tt(K.start,v.width,4);q.start<=dt+1&&at===ct&&tt(q.start+q.count-1,v.width,4)===at?K.count=Math.max(K.count,q.start+q.count-K.start):(++mt,lt[mt]=q)}lt.length=mt+1;let Z=e.getParameter(s.UNPACK_ROW_LENGTH),j=e.getParameter(s.UNPACK_SKIP_PIXELS),ut=e.getParameter(s.UNPACK_SKIP_ROWS);e.pixelStorei(s.UNPACK_ROW_LENGTH,v.width);for(let I=0,K=lt.length;I<K;I++){let q=lt[I],dt=Math.floor(q.start/4),at=Math.ceil(q.count/4),ct=dt%v.width,It=Math.floor(dt/v.width),Zt=at,rt=1;e.pixelStorei(s.UNPACK_SKIP_PIXELS,ct),e.pixelStorei(s.UNPACK_SKIP_ROWS,It),e.texSubImage2D(s.TEXTURE_2D,0,ct,It,Zt,rt,B,st,v.data)}A.clearUpdateRanges(),e.pixelStorei(s.UNPACK_ROW_LENGTH,Z),e.pixelStorei(s.UNPACK_SKIP_PIXELS,j),e.pixelStorei(s.UNPACK_SKIP_ROWS,ut)}}function ot(A,v,B){let st=s.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(st=s.TEXTURE_2D_ARRAY),v.isData3DTexture&&(st=s.TEXTURE_3D);let J=ee(A,v),lt=v.source;e.bindTexture(st,A.__webglTexture,s.TEXTURE0+B);let mt=i.get(lt);if(lt.version!==mt.__version||J===!0){if(e.activeTexture(s.TEXTURE0+B),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let rt=ae.getPrimaries(ae.workingColorSpace),Lt=v.colorSpace===un?null:ae.getPrimaries(v.colorSpace),qt=v.colorSpace===un||rt===Lt?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,qt)}e.pixelStorei(s.UNPACK_ALIGNMENT,v.unpackAlignment);let j=M(v.image,!1,n.maxTextureSize);j=Ot(v,j);let ut=r.convert(v.format,v.colorSpace),I=r.convert(v.type),K=E(v.internalFormat,ut,I,v.normalized,v.colorSpace,v.isVideoTexture);Jt(st,v);let q,dt=v.mipmaps,at=v.isVideoTexture!==!0,ct=mt.__version===void 0||J===!0,It=lt.dataReady,Zt=T(v,j);if(v.isDepthTexture)K=_(v.format===hn,v.type),ct&&(at?e.texStorage2D(s.TEXTURE_2D,1,K,j.width,j.height):e.texImage2D(s.TEXTURE_2D,0,K,j.width,j.height,0,ut,I,null));else if(v.isDataTexture)if(dt.length>0){at&&ct&&e.texStorage2D(s.TEXTURE_2D,Zt,K,dt[0].width,dt[0].height);for(let rt=0,Lt=dt.length;rt<Lt;rt++)q=dt[rt],at?It&&e.texSubImage2D(s.TEXTURE_2D,rt,0,0,q.width,q.height,ut,I,q.data):e.texImage2D(s.TEXTURE_2D,rt,K,q.width,q.height,0,ut,I,q.data);v.generateMipmaps=!1}else at?(ct&&e.texStorage2D(s.TEXTURE_2D,Zt,K,j.width,j.height),It&&ht(v,j,ut,I)):e.texImage2D(s.TEXTURE_2D,0,K,j.width,j.height,0,ut,I,j.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){at&&ct&&e.texStorage3D(s.TEXTURE_2D_ARRAY,Zt,K,dt[0].width,dt[0].height,j.depth);for(let rt=0,Lt=dt.length;rt<Lt;rt++)if(q=dt[rt],v.format!==Di)if(ut!==null)if(at){if(It)if(v.layerUpdates.size>0){let qt=Lu(q.width,q.height,v.format,v.type);for(let vt of v.layerUpdates){let pe=q.data.subarray(vt*qt/q.data.BYTES_PER_ELEMENT,(vt+1)*qt/q.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,rt,0,0,vt,q.width,q.height,1,ut,pe)}}else e.compressedTexSubImage3D(s.TEXTURE_2D_ARRAY,rt,0,0,0,q.width,q.height,j.depth,ut,q.data)}else e.compressedTexImage3D(s.TEXTURE_2D_ARRAY,rt,K,q.width,q.height,j.depth,0,q.data,0,0);else Ft("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else at?It&&e.texSubImage3D(s.TEXTURE_2D_ARRAY,rt,0,0,0,q.width,q.height,j.depth,ut,I,q.data):e.texImage3D(s.TEXTURE_2D_ARRAY,rt,K,q.width,q.height,j.depth,0,ut,I,q.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{at&&ct&&e.texStorage2D(s.TEXTURE_2D,Zt,K,dt[0].width,dt[0].height);for(let rt=0,Lt=dt.length;rt<Lt;rt++)q=dt[rt],v.format!==Di?ut!==null?at?It&&e.compressedTexSubImage2D(s.TEXTURE_2D,rt,0,0,q.width,q.height,ut,q.data):e.compressedTexImage2D(s.TEXTURE_2D,rt,K,q.width,q.height,0,q.data):Ft("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):at?It&&e.texSubImage2D(s.TEXTURE_2D,rt,0,0,q.width,q.height,ut,I,q.data):e.texImage2D(s.TEXTURE_2D,rt,K,q.width,q.height,0,ut,I,q.data)}else if(v.isDataArrayTexture)if(at){if(ct&&e.texStorage3D(s.TEXTURE_2D_ARRAY,Zt,K,j.width,j.height,j.depth),It)if(v.layerUpdates.size>0){let rt=Lu(j.width,j.height,v.format,v.type);for(let Lt of v.layerUpdates){let qt=j.data.subarray(Lt*rt/j.data.BYTES_PER_ELEMENT,(Lt+1)*rt/j.data.BYTES_PER_ELEMENT);e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,Lt,j.width,j.height,1,ut,I,qt)}v.clearLayerUpdates()}else e.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,0,j.width,j.height,j.depth,ut,I,j.data)}else e.texImage3D(s.TEXTURE_2D_ARRAY,0,K,j.width,j.height,j.depth,0,ut,I,j.data);else if(v.isData3DTexture)at?(ct&&e.texStorage3D(s.TEXTURE_3D,Zt,K,j.width,j.height,j.depth),It&&e.texSubImage3D(s.TEXTURE_3D,0,0,0,0,j.width,j.height,j.depth,ut,I,j.data)):e.texImage3D(s.TEXTURE_3D,0,K,j.width,j.height,j.depth,0,ut,I,j.data);else if(v.isFramebufferTexture){if(ct)if(at)e.texStorage2D(s.TEXTURE_2D,Zt,K,j.width,j.height);else{let rt=j.width,Lt=j.height;for(let qt=0;qt<Zt;qt++)e.texImage2D(s.TEXTURE_2D,qt,K,rt,Lt,0,ut,I,null),rt>>=1,Lt>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in s){let rt=s.canvas;if(rt.hasAttribute("layoutsubtree")||rt.setAttribute("layoutsubtree","true"),j.parentNode!==rt){rt.appendChild(j),u.add(v),rt.onpaint=Lt=>{let qt=Lt.changedElements;for(let vt of u)qt.includes(vt.image)&&(vt.needsUpdate=!0)},rt.requestPaint();return}if(s.texElementImage2D.length===3)s.texElementImage2D(s.TEXTURE_2D,s.RGBA8,j);else{let qt=s.RGBA,vt=s.RGBA,pe=s.UNSIGNED_BYTE;s.texElementImage2D(s.TEXTURE_2D,0,qt,vt,pe,j)}s.texParameteri(s.TEXTURE_2D,s.TEXTURE_MIN_FILTER,s.LINEAR),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_S,s.CLAMP_TO_EDGE),s.texParameteri(s.TEXTURE_2D,s.TEXTURE_WRAP_T,s.CLAMP_TO_EDGE)}}else if(dt.length>0){if(at&&ct){let rt=Vt(dt[0]);e.texStorage2D(s.TEXTURE_2D,Zt,K,rt.width,rt.height)}for(let rt=0,Lt=dt.length;rt<Lt;rt++)q=dt[rt],at?It&&e.texSubImage2D(s.TEXTURE_2D,rt,0,0,ut,I,q):e.texImage2D(s.TEXTURE_2D,rt,K,ut,I,q);v.generateMipmaps=!1}else if(at){if(ct){let rt=Vt(j);e.texStorage2D(s.TEXTURE_2D,Zt,K,rt.width,rt.height)}It&&e.texSubImage2D(s.TEXTURE_2D,0,0,0,ut,I,j)}else e.texImage2D(s.TEXTURE_2D,0,K,ut,I,j);w(v)&&v.mipmapsAutoUpdate===!0&&b(st),mt.__version=lt.version,v.onUpdate&&v.onUpdate(v)}A.__version=v.version}function St(A,v,B){if(v.image.length!==6)return;let st=ee(A,v),J=v.source;e.bindTexture(s.TEXTURE_CUBE_MAP,A.__webglTexture,s.TEXTURE0+B);let lt=i.get(J);if(J.version!==lt.__version||st===!0){e.activeTexture(s.TEXTURE0+B);let mt=ae.getPrimaries(ae.workingColorSpace),Z=v.colorSpace===un?null:ae.getPrimaries(v.colorSpace),j=v.colorSpace===un||mt===Z?s.NONE:s.BROWSER_DEFAULT_WEBGL;e.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(s.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(s.UNPACK_COLORSPACE_CONVERSION_WEBGL,j);let ut=v.isCompressedTexture||v.image[0].isCompressedTexture,I=v.image[0]&&v.image[0].isDataTexture,K=[];for(let vt=0;vt<6;vt++)!ut&&!I?K[vt]=M(v.image[vt],!0,n.maxCubemapSize):K[vt]=I?v.image[vt].image:v.image[vt],K[vt]=Ot(v,K[vt]);let q=K[0],dt=r.convert(v.format,v.colorSpace),at=r.convert(v.type),ct=E(v.internalFormat,dt,at,v.normalized,v.colorSpace),It=v.isVideoTexture!==!0,Zt=lt.__version===void 0||st===!0,rt=J.dataReady,Lt=T(v,q);Jt(s.TEXTURE_CUBE_MAP,v);let qt;if(v.isDepthTexture){if(ct=_(v.format===hn,v.type),Zt)if(It)e.texStorage2D(s.TEXTURE_CUBE_MAP,1,ct,q.width,q.height);else for(let vt=0;vt<6;vt++)e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,0,ct,q.width,q.height,0,dt,at,null)}else if(ut){It&&Zt&&e.texStorage2D(s.TEXTURE_CUBE_MAP,Lt,ct,q.width,q.height);for(let vt=0;vt<6;vt++){qt=K[vt].mipmaps;for(let pe=0;pe<qt.length;pe++){let He=qt[pe];v.format!==Di?dt!==null?It?rt&&e.compressedTexSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe,0,0,He.width,He.height,dt,He.data):e.compressedTexImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe,ct,He.width,He.height,0,He.data):Ft("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):It?rt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe,0,0,He.width,He.height,dt,at,He.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe,ct,He.width,He.height,0,dt,at,He.data)}}}else{if(qt=v.mipmaps,It&&Zt){qt.length>0&&Lt++;let vt=Vt(K[0]);e.texStorage2D(s.TEXTURE_CUBE_MAP,Lt,ct,vt.width,vt.height)}for(let vt=0;vt<6;vt++)if(I){It?rt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,0,0,0,K[vt].width,K[vt].height,dt,at,K[vt].data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,0,ct,K[vt].width,K[vt].height,0,dt,at,K[vt].data);for(let pe=0;pe<qt.length;pe++){let gn=qt[pe].image[vt].image;It?rt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe+1,0,0,gn.width,gn.height,dt,at,gn.data):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe+1,ct,gn.width,gn.height,0,dt,at,gn.data)}}else{It?rt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,0,0,0,dt,at,K[vt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,0,ct,dt,at,K[vt]);for(let pe=0;pe<qt.length;pe++){let He=qt[pe];It?rt&&e.texSubImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe+1,0,0,dt,at,He.image[vt]):e.texImage2D(s.TEXTURE_CUBE_MAP_POSITIVE_X+vt,pe+1,ct,dt,at,He.image[vt])}}}w(v)&&v.mipmapsAutoUpdate===!0&&b(s.TEXTURE_CUBE_MAP),lt.__version=J.version,v.onUpdate&&v.onUpdate(v)}A.__version=v.version}function xt(A,v,B,st,J,lt){let mt=r.convert(B.format,B.colorSpace),Z=r.convert(B.type),j=E(B.internalFormat,mt,Z,B.normalized,B.colorSpace),ut=i.get(v),I=i.get(B);if(I.__renderTarget=v,!ut.__hasExternalTextures){let K=Math.max(1,v.width>>lt),q=Math.max(1,v.height>>lt);J===s.TEXTURE_3D||J===s.TEXTURE_2D_ARRAY?e.texImage3D(J,lt,j,K,q,v.depth,0,mt,Z,null):e.texImage2D(J,lt,j,K,q,0,mt,Z,null)}e.bindFramebuffer(s.FRAMEBUFFER,A),pt(v)?o.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,st,J,I.__webglTexture,0,xe(v)):(J===s.TEXTURE_2D||J>=s.TEXTURE_CUBE_MAP_POSITIVE_X&&J<=s.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&s.framebufferTexture2D(s.FRAMEBUFFER,st,J,I.__webglTexture,lt),e.bindFramebuffer(s.FRAMEBUFFER,null)}function Xt(A,v,B){if(s.bindRenderbuffer(s.RENDERBUFFER,A),v.depthBuffer){let st=v.depthTexture,J=st&&st.isDepthTexture?st.type:null,lt=_(v.stencilBuffer,J),mt=v.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;pt(v)?o.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,xe(v),lt,v.width,v.height):B?s.renderbufferStorageMultisample(s.RENDERBUFFER,xe(v),lt,v.width,v.height):s.renderbufferStorage(s.RENDERBUFFER,lt,v.width,v.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,mt,s.RENDERBUFFER,A)}else{let st=v.textures;for(let J=0;J<st.length;J++){let lt=st[J],mt=r.convert(lt.format,lt.colorSpace),Z=r.convert(lt.type),j=E(lt.internalFormat,mt,Z,lt.normalized,lt.colorSpace);pt(v)?o.renderbufferStorageMultisampleEXT(s.RENDERBUFFER,xe(v),j,v.width,v.height):B?s.renderbufferStorageMultisample(s.RENDERBUFFER,xe(v),j,v.width,v.height):s.renderbufferStorage(s.RENDERBUFFER,j,v.width,v.height)}}s.bindRenderbuffer(s.RENDERBUFFER,null)}function Pt(A,v,B){let st=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(s.FRAMEBUFFER,A),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let J=i.get(v.depthTexture);J.__renderTarget=v;let lt=st?v.depthTexture.image[0]:v.depthTexture.image;(!J.__webglTexture||lt.width!==v.width||lt.height!==v.height)&&(lt.width=v.width,lt.height=v.height,v.depthTexture.needsUpdate=!0),st?yt(v.depthTexture,0):_t(v.depthTexture,0);let mt=J.__webglTexture,Z=xe(v),j=st?s.TEXTURE_CUBE_MAP_POSITIVE_X+B:s.TEXTURE_2D,ut=v.depthTexture.format===hn?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;if(v.depthTexture.format===sn)pt(v)?o.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,ut,j,mt,0,Z):s.framebufferTexture2D(s.FRAMEBUFFER,ut,j,mt,0);else if(v.depthTexture.format===hn)pt(v)?o.framebufferTexture2DMultisampleEXT(s.FRAMEBUFFER,ut,j,mt,0,Z):s.framebufferTexture2D(s.FRAMEBUFFER,ut,j,mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function ie(A){let v=i.get(A),B=A.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==A.depthTexture){let st=A.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),st){let J=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,st.removeEventListener("dispose",J)};st.addEventListener("dispose",J),v.__depthDisposeCallback=J}v.__boundDepthTexture=st}if(A.depthTexture&&!v.__autoAllocateDepthBuffer)if(B)for(let st=0;st<6;st++)Pt(v.__webglFramebuffer[st],A,st);else A.texture.mipmaps.length>0?Pt(v.__webglFramebuffer[0],A,0):Pt(v.__webglFramebuffer,A,0);else if(B){v.__webglDepthbuffer=[];for(let st=0;st<6;st++)if(e.bindFramebuffer(s.FRAMEBUFFER,v.__webglFramebuffer[st]),v.__webglDepthbuffer[st]===void 0)v.__webglDepthbuffer[st]=s.createRenderbuffer(),Xt(v.__webglDepthbuffer[st],A,!1);else{let J=A.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,lt=v.__webglDepthbuffer[st];s.bindRenderbuffer(s.RENDERBUFFER,lt),s.framebufferRenderbuffer(s.FRAMEBUFFER,J,s.RENDERBUFFER,lt)}}else if(A.texture.mipmaps.length>0?e.bindFramebuffer(s.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(s.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=s.createRenderbuffer(),Xt(v.__webglDepthbuffer,A,!1);else{let J=A.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,lt=v.__webglDepthbuffer;s.bindRenderbuffer(s.RENDERBUFFER,lt),s.framebufferRenderbuffer(s.FRAMEBUFFER,J,s.RENDERBUFFER,lt)}e.bindFramebuffer(s.FRAMEBUFFER,null)}function ne(A,v,B){let st=i.get(A);v!==void 0&&xt(st.__webglFramebuffer,A,A.texture,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,0),B!==void 0&&ie(A)}function le(A){let v=A.texture,B=i.get(A),st=i.get(v);A.addEventListener("dispose",F),O(A);let J=A.textures,lt=A.isWebGLCubeRenderTarget===!0,mt=J.length>1;if(mt||(st.__webglTexture===void 0&&(st.__webglTexture=s.createTexture()),st.__version=v.version,a.memory.textures++),lt){B.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0){B.__webglFramebuffer[Z]=[];for(let j=0;j<v.mipmaps.length;j++)B.__webglFramebuffer[Z][j]=s.createFramebuffer()}else B.__webglFramebuffer[Z]=s.createFramebuffer()}else{if(v.mipmaps.length>0){B.__webglFramebuffer=[];for(let Z=0;Z<v.mipmaps.length;Z++)B.__webglFramebuffer[Z]=s.createFramebuffer()}else B.__webglFramebuffer=s.createFramebuffer();if(mt)for(let Z=0,j=J.length;Z<j;Z++){let ut=i.get(J[Z]);ut.__webglTexture===void 0&&(ut.__webglTexture=s.createTexture(),a.memory.textures++)}if(A.samples>0&&pt(A)===!1){B.__webglMultisampledFramebuffer=s.createFramebuffer(),B.__webglColorRenderbuffer=[],e.bindFramebuffer(s.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let Z=0;Z<J.length;Z++){let j=J[Z];B.__webglColorRenderbuffer[Z]=s.createRenderbuffer(),s.bindRenderbuffer(s.RENDERBUFFER,B.__webglColorRenderbuffer[Z]);let ut=r.convert(j.format,j.colorSpace),I=r.convert(j.type),K=E(j.internalFormat,ut,I,j.normalized,j.colorSpace,A.isXRRenderTarget===!0),q=xe(A);s.renderbufferStorageMultisample(s.RENDERBUFFER,q,K,A.width,A.height),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+Z,s.RENDERBUFFER,B.__webglColorRenderbuffer[Z])}s.bindRenderbuffer(s.RENDERBUFFER,null),A.depthBuffer&&(B.__webglDepthRenderbuffer=s.createRenderbuffer(),Xt(B.__webglDepthRenderbuffer,A,!0)),e.bindFramebuffer(s.FRAMEBUFFER,null)}}if(lt){e.bindTexture(s.TEXTURE_CUBE_MAP,st.__webglTexture),Jt(s.TEXTURE_CUBE_MAP,v);for(let Z=0;Z<6;Z++)if(v.mipmaps.length>0)for(let j=0;j<v.mipmaps.length;j++)xt(B.__webglFramebuffer[Z][j],A,v,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+Z,j);else xt(B.__webglFramebuffer[Z],A,v,s.COLOR_ATTACHMENT0,s.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);w(v)?b(s.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&s.texParameteri(s.TEXTURE_CUBE_MAP,s.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(mt){for(let Z=0,j=J.length;Z<j;Z++){let ut=J[Z],I=i.get(ut),K=s.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(K=A.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture(K,I.__webglTexture),Jt(K,ut),xt(B.__webglFramebuffer,A,ut,s.COLOR_ATTACHMENT0+Z,K,0),w(ut)&&b(K)}e.unbindTexture()}else{let Z=s.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(Z=A.isWebGL3DRenderTarget?s.TEXTURE_3D:s.TEXTURE_2D_ARRAY),e.bindTexture(Z,st.__webglTexture),Jt(Z,v),v.mipmaps.length>0)for(let j=0;j<v.mipmaps.length;j++)xt(B.__webglFramebuffer[j],A,v,s.COLOR_ATTACHMENT0,Z,j);else xt(B.__webglFramebuffer,A,v,s.COLOR_ATTACHMENT0,Z,0);w(v)?b(Z):v.mipmaps.length>0&&s.texParameteri(Z,s.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}A.depthBuffer&&ie(A)}function D(A){let v=A.textures;for(let B=0,st=v.length;B<st;B++){let J=v[B];if(w(J)&&J.mipmapsAutoUpdate===!0){let lt=C(A),mt=i.get(J).__webglTexture;e.bindTexture(lt,mt),b(lt),e.unbindTexture()}}}let De=[];function te(A){if(A.samples>0){if(pt(A)===!1){let v=A.textures,B=A.width,st=A.height,J=s.COLOR_BUFFER_BIT,lt=A.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT,mt=i.get(A),Z=v.length>1;if(Z)for(let ut=0;ut<v.length;ut++)e.bindFramebuffer(s.FRAMEBUFFER,mt.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+ut,s.RENDERBUFFER,null),e.bindFramebuffer(s.FRAMEBUFFER,mt.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+ut,s.TEXTURE_2D,null,0);e.bindFramebuffer(s.READ_FRAMEBUFFER,mt.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?e.bindFramebuffer(s.DRAW_FRAMEBUFFER,mt.__webglFramebuffer[0]):e.bindFramebuffer(s.DRAW_FRAMEBUFFER,mt.__webglFramebuffer);for(let ut=0;ut<v.length;ut++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(J|=s.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(J|=s.STENCIL_BUFFER_BIT)),Z){s.framebufferRenderbuffer(s.READ_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.RENDERBUFFER,mt.__webglColorRenderbuffer[ut]);let I=i.get(v[ut]).__webglTexture;s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0,s.TEXTURE_2D,I,0)}s.blitFramebuffer(0,0,B,st,0,0,B,st,J,s.NEAREST),l===!0&&(De.length=0,De.push(s.COLOR_ATTACHMENT0+ut),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&De.push(lt),s.invalidateFramebuffer(s.READ_FRAMEBUFFER,De))}if(e.bindFramebuffer(s.READ_FRAMEBUFFER,null),e.bindFramebuffer(s.DRAW_FRAMEBUFFER,null),Z)for(let ut=0;ut<v.length;ut++){e.bindFramebuffer(s.FRAMEBUFFER,mt.__webglMultisampledFramebuffer),s.framebufferRenderbuffer(s.FRAMEBUFFER,s.COLOR_ATTACHMENT0+ut,s.RENDERBUFFER,mt.__webglColorRenderbuffer[ut]);let I=i.get(v[ut]).__webglTexture;e.bindFramebuffer(s.FRAMEBUFFER,mt.__webglFramebuffer),s.framebufferTexture2D(s.DRAW_FRAMEBUFFER,s.COLOR_ATTACHMENT0+ut,s.TEXTURE_2D,I,0)}e.bindFramebuffer(s.DRAW_FRAMEBUFFER,mt.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let v=A.stencilBuffer?s.DEPTH_STENCIL_ATTACHMENT:s.DEPTH_ATTACHMENT;s.invalidateFramebuffer(s.DRAW_FRAMEBUFFER,[v])}}}function xe(A){return Math.min(n.maxSamples,A.samples)}function pt(A){let v=i.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function Ie(A){let v=a.render.frame;h.get(A)!==v&&(h.set(A,v),A.update())}function Ot(A,v){let B=A.colorSpace,st=A.format,J=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||B!==Er&&B!==un&&(ae.getTransfer(B)===de?(st!==Di||J!==ui)&&Ft("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):zt("WebGLTextures: Unsupported texture color space:",B)),v}function Vt(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=kt,this.resetTextureUnits=Q,this.getTextureUnits=et,this.setTextureUnits=wt,this.setTexture2D=_t,this.setTexture2DArray=Tt,this.setTexture3D=Dt,this.setTextureCube=yt,this.rebindTextures=ne,this.setupRenderTarget=le,this.updateRenderTargetMipmap=D,this.updateMultisampleRenderTarget=te,this.setupDepthRenderbuffer=ie,this.setupFrameBufferTexture=xt,this.useMultisampledRTT=pt,this.dispose=G}function _b(s,t){function e(i,n=un){let r,a=ae.getTransfer(n);if(i===ui)return s.UNSIGNED_BYTE;if(i===al)return s.UNSIGNED_SHORT_4_4_4_4;if(i===ol)return s.UNSIGNED_SHORT_5_5_5_1;if(i===pu)return s.UNSIGNED_INT_5_9_9_9_REV;if(i===mu)return s.UNSIGNED_INT_10F_11F_11F_REV;if(i===du)return s.BYTE;if(i===fu)return s.SHORT;if(i===Zs)return s.UNSIGNED_SHORT;if(i===rl)return s.INT;if(i===Ni)return s.UNSIGNED_INT;if(i===wi)return s.FLOAT;if(i===Li)return s.HALF_FLOAT;if(i===gu)return s.ALPHA;if(i===xu)return s.RGB;if(i===Di)return s.RGBA;if(i===sn)return s.DEPTH_COMPONENT;if(i===hn)return s.DEPTH_STENCIL;if(i===ll)return s.RED;if(i===cl)return s.RED_INTEGER;if(i===In)return s.RG;if(i===hl)return s.RG_INTEGER;if(i===ul)return s.RGBA_INTEGER;if(i===oa||i===la||i===ca||i===ha)if(a===de)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===oa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===la)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===oa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===la)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ca)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ha)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===dl||i===fl||i===pl||i===ml)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===dl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===fl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===pl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ml)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===gl||i===xl||i===_l||i===yl||i===vl||i===ua||i===bl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===gl||i===xl)return a===de?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===_l)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===yl)return r.COMPRESSED_R11_EAC;if(i===vl)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ua)return r.COMPRESSED_RG11_EAC;if(i===bl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ml||i===Sl||i===wl||i===Tl||i===El||i===Al||i===Cl||i===Rl||i===Pl||i===Il||i===Nl||i===Ll||i===Dl||i===Ul)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ml)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Sl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===wl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Tl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===El)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Al)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Cl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Rl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Pl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Il)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Nl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ll)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Dl)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ul)return a===de?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ol||i===Fl||i===kl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Ol)return a===de?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Fl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===kl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Bl||i===zl||i===da||i===Gl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Bl)return r.COMPRESSED_RED_RGTC1_EXT;if(i===zl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===da)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Gl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ns?s.UNSIGNED_INT_24_8:s[i]!==void 0?s[i]:null}return{convert:e}}var yb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,vb=`
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

}`,Vu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new zr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Wi({vertexShader:yb,fragmentShader:vb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Pe(new Kr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Hu=class extends Ii{constructor(t,e){super();let i=this,n=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,y=typeof XRWebGLBinding<"u",m=new Vu,g={},M=e.getContextAttributes(),w=null,b=null,C=[],E=[],_=new it,T=null,O=null,R=new Ze;R.viewport=new Ae;let U=new Ze;U.viewport=new Ae;let F=[R,U],W=new tl,N=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let _t=C[Y];return _t===void 0&&(_t=new Fs,C[Y]=_t),_t.getTargetRaySpace()},this.getControllerGrip=function(Y){let _t=C[Y];return _t===void 0&&(_t=new Fs,C[Y]=_t),_t.getGripSpace()},this.getHand=function(Y){let _t=C[Y];return _t===void 0&&(_t=new Fs,C[Y]=_t),_t.getHandSpace()};function $(Y){let _t=E.indexOf(Y.inputSource);if(_t===-1)return;let Tt=C[_t];Tt!==void 0&&(Tt.update(Y.inputSource,Y.frame,c||a),Tt.dispatchEvent({type:Y.type,data:Y.inputSource}))}function V(){n.removeEventListener("select",$),n.removeEventListener("selectstart",$),n.removeEventListener("selectend",$),n.removeEventListener("squeeze",$),n.removeEventListener("squeezestart",$),n.removeEventListener("squeezeend",$),n.removeEventListener("end",V),n.removeEventListener("inputsourceschange",nt);for(let Y=0;Y<C.length;Y++){let _t=E[Y];_t!==null&&(E[Y]=null,C[Y].disconnect(_t))}N=null,G=null,m.reset();for(let Y in g)delete g[Y];if(t.setRenderTarget(w),f=null,d=null,u=null,n=null,b=null,kt.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),O!==null){let Y=O.camera;Y.fov=O.fov,Y.zoom=O.zoom,Y.updateProjectionMatrix(),O=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,i.isPresenting===!0&&Ft("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){o=Y,i.isPresenting===!0&&Ft("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Y){c=Y},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(n,e)),u},this.getFrame=function(){return p},this.getSession=function(){return n},this.setSession=async function(Y){if(n=Y,n!==null){if(w=t.getRenderTarget(),n.addEventListener("select",$),n.addEventListener("selectstart",$),n.addEventListener("selectend",$),n.addEventListener("squeeze",$),n.addEventListener("squeezestart",$),n.addEventListener("squeezeend",$),n.addEventListener("end",V),n.addEventListener("inputsourceschange",nt),M.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Tt=null,Dt=null,yt=null;M.depth&&(yt=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Tt=M.stencil?hn:sn,Dt=M.stencil?ns:Ni);let Ut={colorFormat:e.RGBA8,depthFormat:yt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ut),n.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new xi(d.textureWidth,d.textureHeight,{format:Di,type:ui,depthTexture:new on(d.textureWidth,d.textureHeight,Dt,void 0,void 0,void 0,void 0,void 0,void 0,Tt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Tt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(n,e,Tt),n.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new xi(f.framebufferWidth,f.framebufferHeight,{format:Di,type:ui,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await n.requestReferenceSpace(o),kt.setContext(n),kt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(n!==null)return n.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function nt(Y){for(let _t=0;_t<Y.removed.length;_t++){let Tt=Y.removed[_t],Dt=E.indexOf(Tt);Dt>=0&&(E[Dt]=null,C[Dt].disconnect(Tt))}for(let _t=0;_t<Y.added.length;_t++){let Tt=Y.added[_t],Dt=E.indexOf(Tt);if(Dt===-1){for(let Ut=0;Ut<C.length;Ut++)if(Ut>=E.length){E.push(Tt),Dt=Ut;break}else if(E[Ut]===null){E[Ut]=Tt,Dt=Ut;break}if(Dt===-1)break}let yt=C[Dt];yt&&yt.connect(Tt)}}function X(Y,_t){_t===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(_t.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(n===null)return;let _t=Y.near,Tt=Y.far;m.texture!==null&&(m.depthNear>0&&(_t=m.depthNear),m.depthFar>0&&(Tt=m.depthFar)),W.near=U.near=R.near=_t,W.far=U.far=R.far=Tt,(N!==W.near||G!==W.far)&&(n.updateRenderState({depthNear:W.near,depthFar:W.far}),N=W.near,G=W.far),W.layers.mask=Y.layers.mask|6,R.layers.mask=W.layers.mask&-5,U.layers.mask=W.layers.mask&-3;let Dt=Y.parent,yt=W.cameras;X(W,Dt);for(let Ut=0;Ut<yt.length;Ut++)X(yt[Ut],Dt);W.projectionMatrix.copy(R.projectionMatrix),W.projectionMatrixInverse.copy(R.projectionMatrixInverse),O===null&&Y.isPerspectiveCamera&&(O={camera:Y,fov:Y.fov,zoom:Y.zoom}),Q(Y,W,Dt)};function Q(Y,_t,Tt){Tt===null?Y.matrix.copy(_t.matrixWorld):(Y.matrix.copy(Tt.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(_t.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(_t.projectionMatrix),Y.projectionMatrixInverse.copy(_t.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=Us*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Y){l=Y,d!==null&&(d.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(Y){return g[Y]};let et=null;function wt(Y,_t){if(h=_t.getViewerPose(c||a),p=_t,h!==null){let Tt=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Dt=!1;Tt.length!==W.cameras.length&&(W.cameras.length=0,Dt=!0);for(let Bt=0;Bt<Tt.length;Bt++){let Jt=Tt[Bt],ee=null;if(f!==null)ee=f.getViewport(Jt);else{let ht=u.getViewSubImage(d,Jt);ee=ht.viewport,Bt===0&&(t.setRenderTargetTextures(b,ht.colorTexture,ht.depthStencilTexture),t.setRenderTarget(b))}let tt=F[Bt];tt===void 0&&(tt=new Ze,tt.layers.enable(Bt),tt.viewport=new Ae,F[Bt]=tt),tt.matrix.fromArray(Jt.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(Jt.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ee.x,ee.y,ee.width,ee.height),Bt===0&&(W.matrix.copy(tt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Dt===!0&&W.cameras.push(tt)}let yt=n.enabledFeatures;if(yt&&yt.includes("depth-sensing")&&n.depthUsage=="gpu-optimized"&&y){u=i.getBinding();let Bt=u.getDepthInformation(Tt[0]);Bt&&Bt.isValid&&Bt.texture&&m.init(Bt,n.renderState)}if(yt&&yt.includes("camera-access")&&y){t.state.unbindTexture(),u=i.getBinding();for(let Bt=0;Bt<Tt.length;Bt++){let Jt=Tt[Bt].camera;if(Jt){let ee=g[Jt];ee||(ee=new zr,g[Jt]=ee);let tt=u.getCameraImage(Jt);ee.sourceTexture=tt}}}}for(let Tt=0;Tt<C.length;Tt++){let Dt=E[Tt],yt=C[Tt];Dt!==null&&yt!==void 0&&yt.update(Dt,_t,c||a)}et&&et(Y,_t),_t.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_t}),p=null}let kt=new Fp;kt.setAnimationLoop(wt),this.setAnimationLoop=function(Y){et=Y},this.dispose=function(){}}},bb=new fe,qp=new Ht;qp.set(-1,0,0,0,1,0,0,0,1);function Mb(s,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Pu(s)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function n(m,g,M,w,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),y(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(a(m,g),g.isLineDashedMaterial&&o(m,g)):g.isPointsMaterial?l(m,g,M,w):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===ke&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===ke&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let M=t.get(g),w=M.envMap,b=M.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(bb.makeRotationFromEuler(b)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(qp),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function a(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function o(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,M,w){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*M,m.scale.value=w*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,M){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ke&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function y(m,g){let M=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:n}}function Sb(s,t,e,i){let n={},r={};function a(M,w){let b=w.program;i.uniformBlockBinding(M,b,n[M.id])}function o(M,w){let b=n[M.id];b===void 0&&(p(M),b=l(M),n[M.id]=b,M.addEventListener("dispose",m));let C=w.program;i.updateUBOMapping(M,C);let E=t.render.frame;r[M.id]!==E&&(c(M),r[M.id]=E)}function l(M){let w=s.createBuffer(),b=M.__size,C=M.usage;return s.bindBuffer(s.UNIFORM_BUFFER,w),s.bufferData(s.UNIFORM_BUFFER,b,C),s.bindBuffer(s.UNIFORM_BUFFER,null),w}function c(M){let w=n[M.id],b=M.uniforms,C=M.__cache;s.bindBuffer(s.UNIFORM_BUFFER,w);for(let E=0,_=b.length;E<_;E++){let T=b[E];if(Array.isArray(T))for(let O=0,R=T.length;O<R;O++)h(T[O],E,O,C);else h(T,E,0,C)}s.bindBuffer(s.UNIFORM_BUFFER,null)}function h(M,w,b,C){if(d(M,w,b,C)===!0){let E=M.__offset,_=M.value;if(Array.isArray(_)){let T=0;for(let O=0;O<_.length;O++){let R=_[O],U=y(R,!0);u(R,M.__data,T),T+=U.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,M.__data,0);s.bufferSubData(s.UNIFORM_BUFFER,E,M.__data)}}function u(M,w,b){typeof M=="number"||typeof M=="boolean"?w[b]=M:M.isMatrix3?(w[b]=M.elements[0],w[b+1]=M.elements[1],w[b+2]=M.elements[2],w[b+3]=0,w[b+4]=M.elements[3],w[b+5]=M.elements[4],w[b+6]=M.elements[5],w[b+7]=0,w[b+8]=M.elements[6],w[b+9]=M.elements[7],w[b+10]=M.elements[8],w[b+11]=0):ArrayBuffer.isView(M)?w.set(M.subarray(0,w.length-b),b):M.toArray(w,b)}function d(M,w,b,C){let E=M.value,_=w+"_"+b;if(Array.isArray(E)){C[_]===void 0&&(C[_]=[]);let T=C[_],O=!1;for(let R=0;R<E.length;R++)f(E[R],T,R)===!0&&(O=!0);return O}return f(E,C,_)}function f(M,w,b){if(w[b]===void 0)return typeof M=="number"||typeof M=="boolean"?w[b]=M:ArrayBuffer.isView(M)?w[b]=M.slice():w[b]=M.clone(),!0;{let C=w[b];if(typeof M=="number"||typeof M=="boolean"){if(C!==M)return w[b]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(C.equals(M)===!1)return C.copy(M),!0}}return!1}function p(M){let w=M.uniforms,b=0,C=16;for(let _=0,T=w.length;_<T;_++){let O=Array.isArray(w[_])?w[_]:[w[_]];for(let R=0,U=O.length;R<U;R++){let F=O[R],W=Array.isArray(F.value)?F.value:[F.value],N=Array.isArray(w[_])||Array.isArray(F.value),G=b;for(let V=0,nt=W.length;V<nt;V++){let X=W[V],Q=y(X,N),et=b%C,wt=et%Q.boundary,kt=et+wt;b+=wt,kt!==0&&C-kt<Q.storage&&(b+=C-kt),V===0&&(G=b),b+=Q.storage}let $=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new $((b-G)/Float32Array.BYTES_PER_ELEMENT),F.__offset=G}}let E=b%C;return E>0&&(b+=C-E),M.__size=b,M.__cache={},this}function y(M,w){let b={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(b.boundary=4,b.storage=4):M.isVector2?(b.boundary=8,b.storage=8):M.isVector3||M.isColor?(b.boundary=16,b.storage=12):M.isVector4?(b.boundary=16,b.storage=16):M.isMatrix3?(b.boundary=16,b.storage=48):M.isMatrix4?(b.boundary=16,b.storage=64):M.isTexture?Ft("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(b.boundary=16,b.storage=M.byteLength):Ft("WebGLRenderer: Unsupported uniform value type.",M),w===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(M){let w=M.target;w.removeEventListener("dispose",m),s.deleteBuffer(n[w.id]),delete n[w.id],delete r[w.id]}function g(){for(let M in n)s.deleteBuffer(n[M]);n={},r={}}return{bind:a,update:o,dispose:g}}var wb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Yi=null;function Tb(){return Yi===null&&(Yi=new Or(wb,16,16,In,Li),Yi.name="DFG_LUT",Yi.minFilter=ai,Yi.magFilter=ai,Yi.wrapS=Bi,Yi.wrapT=Bi,Yi.generateMipmaps=!1,Yi.needsUpdate=!0),Yi}var ql=class{constructor(t={}){let{canvas:e=np(),context:i=null,depth:n=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ui}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=a;let y=f,m=new Set([ul,hl,cl]),g=new Set([ui,Ni,Zs,ns,al,ol]),M=new Uint32Array(4),w=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,E=null,_=[],T=[],O=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,U=!1,F=null,W=null,N=null,G=null;this._outputColorSpace=mi;let $=0,V=0,nt=null,X=-1,Q=null,et=new Ae,wt=new Ae,kt=null,Y=new Nt(0),_t=0,Tt=e.width,Dt=e.height,yt=1,Ut=null,Se=null,Bt=new Ae(0,0,Tt,Dt),Jt=new Ae(0,0,Tt,Dt),ee=!1,tt=new Tn,ht=new Po,ot=!1,St=!1,xt=new fe,Xt=new P,Pt=new Ae,ie={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ne=!1;function le(){return nt===null?yt:1}let D=i;function De(S,L){return e.getContext(S,L)}let te,xe,pt,Ie,Ot,Vt,A,v,B,st,J,lt,mt,Z,j,ut,I,K,q,dt,at,ct,It;try{let S={alpha:!0,depth:n,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Lt,!1),e.addEventListener("webglcontextrestored",qt,!1),e.addEventListener("webglcontextcreationerror",vt,!1),D===null){let L="webgl2";if(D=De(L,S),D===null)throw De(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Zt()}catch(S){throw e.removeEventListener("webglcontextlost",Lt,!1),e.removeEventListener("webglcontextrestored",qt,!1),e.removeEventListener("webglcontextcreationerror",vt,!1),zt("WebGLRenderer: "+S.message),S}function Zt(){te=new Oy(D),te.init(),at=new _b(D,te),xe=new Ty(D,te,t,at),pt=new gb(D,te),xe.reversedDepthBuffer&&d&&pt.buffers.depth.setReversed(!0),W=D.createFramebuffer(),N=D.createFramebuffer(),G=D.createFramebuffer(),Ie=new By(D),Ot=new ib,Vt=new xb(D,te,pt,Ot,xe,at,Ie),A=new Uy(R),v=new G0(D),ct=new Sy(D,v),B=new Fy(D,v,Ie,ct),st=new Gy(D,B,v,ct,Ie),K=new zy(D,xe,Vt),j=new Ey(Ot),J=new eb(R,A,te,xe,ct,j),lt=new Mb(R,Ot),mt=new sb,Z=new hb(te),I=new My(R,A,pt,st,p,l),ut=new mb(R,st,xe),It=new Sb(D,Ie,xe,pt),q=new wy(D,te,Ie),dt=new ky(D,te,Ie),Ie.programs=J.programs,R.capabilities=xe,R.extensions=te,R.properties=Ot,R.renderLists=mt,R.shadowMap=ut,R.state=pt,R.info=Ie}y!==ui&&(O=new Hy(y,e.width,e.height,o,n,r));let rt=new Hu(R,D);this.xr=rt,this.getContext=function(){return D},this.getContextAttributes=function(){return D.getContextAttributes()},this.forceContextLoss=function(){let S=te.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=te.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return yt},this.setPixelRatio=function(S){S!==void 0&&(yt=S,this.setSize(Tt,Dt,!1))},this.getSize=function(S){return S.set(Tt,Dt)},this.setSize=function(S,L,H=!0){if(rt.isPresenting){Ft("WebGLRenderer: Can't change size while VR device is presenting.");return}Tt=S,Dt=L,e.width=Math.floor(S*yt),e.height=Math.floor(L*yt),H===!0&&(e.style.width=S+"px",e.style.height=L+"px"),O!==null&&O.setSize(e.width,e.height),this.setViewport(0,0,S,L)},this.getDrawingBufferSize=function(S){return S.set(Tt*yt,Dt*yt).floor()},this.setDrawingBufferSize=function(S,L,H){Tt=S,Dt=L,yt=H,e.width=Math.floor(S*H),e.height=Math.floor(L*H),this.setViewport(0,0,S,L)},this.setEffects=function(S){if(y===ui){zt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let L=0;L<S.length;L++)if(S[L].isOutputPass===!0){Ft("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(et)},this.getViewport=function(S){return S.copy(Bt)},this.setViewport=function(S,L,H,k){S.isVector4?Bt.set(S.x,S.y,S.z,S.w):Bt.set(S,L,H,k),pt.viewport(et.copy(Bt).multiplyScalar(le()).round())},this.getScissor=function(S){return S.copy(Jt)},this.setScissor=function(S,L,H,k){S.isVector4?Jt.set(S.x,S.y,S.z,S.w):Jt.set(S,L,H,k),pt.scissor(wt.copy(Jt).multiplyScalar(le()).round())},this.getScissorTest=function(){return ee},this.setScissorTest=function(S){pt.setScissorTest(ee=S)},this.setOpaqueSort=function(S){Ut=S},this.setTransparentSort=function(S){Se=S},this.getClearColor=function(S){return S.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(S=!0,L=!0,H=!0){let k=0;if(S){let z=!1;if(nt!==null){let gt=nt.texture.format;z=m.has(gt)}if(z){let gt=nt.texture.type,Et=g.has(gt),ft=I.getClearColor(),Mt=I.getClearAlpha(),Rt=ft.r,Wt=ft.g,se=ft.b;Et?(M[0]=Rt,M[1]=Wt,M[2]=se,M[3]=Mt,D.clearBufferuiv(D.COLOR,0,M)):(w[0]=Rt,w[1]=Wt,w[2]=se,w[3]=Mt,D.clearBufferiv(D.COLOR,0,w))}else k|=D.COLOR_BUFFER_BIT}L&&(k|=D.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(k|=D.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&D.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),F=S},this.dispose=function(){e.removeEventListener("webglcontextlost",Lt,!1),e.removeEventListener("webglcontextrestored",qt,!1),e.removeEventListener("webglcontextcreationerror",vt,!1),I.dispose(),mt.dispose(),Z.dispose(),Vt.dispose(),Ot.dispose(),A.dispose(),st.dispose(),B.dispose(),ct.dispose(),It.dispose(),J.dispose(),rt.dispose(),rt.removeEventListener("sessionstart",yd),rt.removeEventListener("sessionend",vd),On.stop()};function Lt(S){S.preventDefault(),Rr("WebGLRenderer: Context Lost."),U=!0}function qt(){Rr("WebGLRenderer: Context Restored."),U=!1;let S=Ie.autoReset,L=ut.enabled,H=ut.autoUpdate,k=ut.needsUpdate,z=ut.type;Zt(),Ie.autoReset=S,ut.enabled=L,ut.autoUpdate=H,ut.needsUpdate=k,ut.type=z}function vt(S){zt("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function pe(S){let L=S.target;L.removeEventListener("dispose",pe),He(L)}function He(S){gn(S),Ot.remove(S)}function gn(S){let L=Ot.get(S).programs;L!==void 0&&(L.forEach(function(H){J.releaseProgram(H)}),S.isShaderMaterial&&J.releaseShaderCache(S))}this.renderBufferDirect=function(S,L,H,k,z,gt){L===null&&(L=ie);let Et=z.isMesh&&z.matrixWorld.determinantAffine()<0,ft=pg(S,L,H,k,z);pt.setMaterial(k,Et);let Mt=H.index,Rt=1;if(k.wireframe===!0){if(Mt=B.getWireframeAttribute(H),Mt===void 0)return;Rt=2}let Wt=H.drawRange,se=H.attributes.position,At=Wt.start*Rt,re=(Wt.start+Wt.count)*Rt;gt!==null&&(At=Math.max(At,gt.start*Rt),re=Math.min(re,(gt.start+gt.count)*Rt)),Mt!==null?(At=Math.max(At,0),re=Math.min(re,Mt.count)):se!=null&&(At=Math.max(At,0),re=Math.min(re,se.count));let Ue=re-At;if(Ue<0||Ue===1/0)return;ct.setup(z,k,ft,H,Mt);let ve,_e=q;if(Mt!==null&&(ve=v.get(Mt),_e=dt,_e.setIndex(ve)),z.isMesh)k.wireframe===!0?(pt.setLineWidth(k.wireframeLinewidth*le()),_e.setMode(D.LINES)):_e.setMode(D.TRIANGLES);else if(z.isLine){let Je=k.linewidth;Je===void 0&&(Je=1),pt.setLineWidth(Je*le()),z.isLineSegments?_e.setMode(D.LINES):z.isLineLoop?_e.setMode(D.LINE_LOOP):_e.setMode(D.LINE_STRIP)}else z.isPoints?_e.setMode(D.POINTS):z.isSprite&&_e.setMode(D.TRIANGLES);if(z.isBatchedMesh)if(te.get("WEBGL_multi_draw"))_e.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Je=z._multiDrawStarts,Ct=z._multiDrawCounts,si=z._multiDrawCount,he=Mt?v.get(Mt).bytesPerElement:1,Fn=Ot.get(k).currentProgram.getUniforms();for(let Qe=0;Qe<si;Qe++)Fn.setValue(D,"_gl_DrawID",Qe),_e.render(Je[Qe]/he,Ct[Qe])}else if(z.isInstancedMesh)_e.renderInstances(At,Ue,z.count);else if(H.isInstancedBufferGeometry){let Je=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,Ct=Math.min(H.instanceCount,Je);_e.renderInstances(At,Ue,Ct)}else _e.render(At,Ue)};function _d(S,L,H,k){F!==null&&S.isNodeMaterial&&F.setObject(k,S),ot===!0&&j.setState(S,H,!1),S.transparent===!0&&S.side===ii&&S.forceSinglePass===!1?(S.side=ke,S.needsUpdate=!0,or(S,L,k),S.side=Pn,S.needsUpdate=!0,or(S,L,k),S.side=ii):or(S,L,k)}this.compile=function(S,L,H=null){H===null&&(H=S),F!==null&&F.renderStart(S,L,H),E=Z.get(H),E.init(L),T.push(E),H.traverseVisible(function(z){z.isLight&&z.layers.test(L.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),S!==H&&S.traverseVisible(function(z){z.isLight&&z.layers.test(L.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),F!==null&&F.updateLights(E.state.lightsArray),St=this.localClippingEnabled,ot=j.init(this.clippingPlanes,St),ot===!0&&j.setGlobalState(this.clippingPlanes,L),F!==null&&ut.render(E.state.shadowsArray,H,L);let k=new Set;return S.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let gt=z.material;if(gt)if(Array.isArray(gt))for(let Et=0;Et<gt.length;Et++){let ft=gt[Et];_d(ft,H,L,z),k.add(ft)}else _d(gt,H,L,z),k.add(gt)}),E=T.pop(),F!==null&&F.renderEnd(),k},this.compileAsync=function(S,L,H=null){let k=this.compile(S,L,H);return new Promise(z=>{function gt(){if(k.forEach(function(Et){let Mt=Ot.get(Et).currentProgram;(Mt===void 0||Mt.isReady())&&k.delete(Et)}),k.size===0){z(S);return}setTimeout(gt,10)}te.get("KHR_parallel_shader_compile")!==null?gt():setTimeout(gt,10)})};let rh=null;function dg(S){rh&&rh(S)}function yd(){On.stop()}function vd(){On.start()}let On=new Fp;On.setAnimationLoop(dg),typeof self<"u"&&On.setContext(self),this.setAnimationLoop=function(S){rh=S,rt.setAnimationLoop(S),S===null?On.stop():On.start()},rt.addEventListener("sessionstart",yd),rt.addEventListener("sessionend",vd),this.render=function(S,L){if(L!==void 0&&L.isCamera!==!0){zt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;F!==null&&F.renderStart(S,L);let H=rt.enabled===!0&&rt.isPresenting===!0,k=O!==null&&(nt===null||H)&&O.begin(R,nt);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),rt.enabled===!0&&rt.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(rt.cameraAutoUpdate===!0&&rt.updateCamera(L),L=rt.getCamera()),S.isScene===!0&&S.onBeforeRender(R,S,L,nt),E=Z.get(S,T.length),E.init(L),E.state.textureUnits=Vt.getTextureUnits(),T.push(E),xt.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?ht.setFromArrayCamera(L):tt.setFromProjectionMatrix(xt,Mi,L.reversedDepth),St=this.localClippingEnabled,ot=j.init(this.clippingPlanes,St),C=mt.get(S,_.length),C.init(),_.push(C),this.info.render.frame++,rt.enabled===!0&&rt.isPresenting===!0){let Et=R.xr.getDepthSensingMesh();Et!==null&&ah(Et,L,-1/0,R.sortObjects)}ah(S,L,0,R.sortObjects),C.finish(),F!==null&&F.updateLights(E.state.lightsArray),R.sortObjects===!0&&C.sort(Ut,Se),ne=rt.enabled===!1||rt.isPresenting===!1||rt.hasDepthSensing()===!1,ne&&I.addToRenderList(C,S),this.info.autoReset===!0&&this.info.reset(),ot===!0&&j.beginShadows();let z=E.state.shadowsArray;if(ut.render(z,S,L),ot===!0&&j.endShadows(),(k&&O.hasRenderPass())===!1){let Et=C.opaque,ft=C.transmissive;if(E.setupLights(),L.isArrayCamera){let Mt=L.cameras;if(ft.length>0)for(let Rt=0,Wt=Mt.length;Rt<Wt;Rt++){let se=Mt[Rt];Md(Et,ft,S,se)}ne&&I.render(S);for(let Rt=0,Wt=Mt.length;Rt<Wt;Rt++){let se=Mt[Rt];bd(C,S,se,se.viewport)}}else ft.length>0&&Md(Et,ft,S,L),ne&&I.render(S),bd(C,S,L)}nt!==null&&V===0&&(Vt.updateMultisampleRenderTarget(nt),Vt.updateRenderTargetMipmap(nt)),k&&O.end(R),S.isScene===!0&&S.onAfterRender(R,S,L),ct.resetDefaultState(),X=-1,Q=null,T.pop(),T.length>0?(E=T[T.length-1],Vt.setTextureUnits(E.state.textureUnits),ot===!0&&j.setGlobalState(R.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,F!==null&&F.renderEnd()};function ah(S,L,H,k){if(S.visible===!1)return;if(S.layers.test(L.layers)){if(S.isGroup)H=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(L);else if(S.isLight)E.pushLight(S),S.castShadow&&E.pushShadow(S);else if(S.isSprite){let Et=L.isArrayCamera?ht:tt;if(!S.frustumCulled||S.intersectsFrustum(Et)){k&&Pt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(xt);let ft=st.update(S),Mt=S.material;Mt.visible&&C.push(S,ft,Mt,H,Pt.z,null,L)}}else if(S.isMesh||S.isLine||S.isPoints){let Et=L.isArrayCamera?ht:tt;if(!S.frustumCulled||S.intersectsFrustum(Et)){let ft=st.update(S),Mt=S.material;if(k&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Pt.copy(S.boundingSphere.center)):(ft.boundingSphere===null&&ft.computeBoundingSphere(),Pt.copy(ft.boundingSphere.center)),Pt.applyMatrix4(S.matrixWorld).applyMatrix4(xt)),Array.isArray(Mt)){let Rt=ft.groups;for(let Wt=0,se=Rt.length;Wt<se;Wt++){let At=Rt[Wt],re=Mt[At.materialIndex];re&&re.visible&&C.push(S,ft,re,H,Pt.z,At,L)}}else Mt.visible&&C.push(S,ft,Mt,H,Pt.z,null,L)}}}let gt=S.children;for(let Et=0,ft=gt.length;Et<ft;Et++)ah(gt[Et],L,H,k)}function bd(S,L,H,k){let{opaque:z,transmissive:gt,transparent:Et}=S;E.setupLightsView(H),ot===!0&&j.setGlobalState(R.clippingPlanes,H),k&&pt.viewport(et.copy(k)),z.length>0&&Aa(z,L,H),gt.length>0&&Aa(gt,L,H),Et.length>0&&Aa(Et,L,H),pt.buffers.depth.setTest(!0),pt.buffers.depth.setMask(!0),pt.buffers.color.setMask(!0),pt.setPolygonOffset(!1)}function Md(S,L,H,k){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[k.id]===void 0){let At=te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[k.id]=new xi(1,1,{generateMipmaps:!0,type:At?Li:ui,minFilter:cn,samples:Math.max(4,xe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ae.workingColorSpace})}let gt=E.state.transmissionRenderTarget[k.id],Et=k.viewport||et;gt.setSize(Et.z*R.transmissionResolutionScale,Et.w*R.transmissionResolutionScale);let ft=R.getRenderTarget(),Mt=R.getActiveCubeFace(),Rt=R.getActiveMipmapLevel();R.setRenderTarget(gt),R.getClearColor(Y),_t=R.getClearAlpha(),_t<1&&R.setClearColor(16777215,.5),R.clear(),ne&&I.render(H);let Wt=R.toneMapping;R.toneMapping=qi;let se=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),E.setupLightsView(k),ot===!0&&j.setGlobalState(R.clippingPlanes,k),Aa(S,H,k),Vt.updateMultisampleRenderTarget(gt),Vt.updateRenderTargetMipmap(gt),te.has("WEBGL_multisampled_render_to_texture")===!1){let At=!1;for(let re=0,Ue=L.length;re<Ue;re++){let ve=L[re],{object:_e,geometry:Je,material:Ct,group:si}=ve;if(Ct.side===ii&&_e.layers.test(k.layers)){let he=Ct.side;Ct.side=ke,Ct.needsUpdate=!0,Sd(_e,H,k,Je,Ct,si),Ct.side=he,Ct.needsUpdate=!0,At=!0}}At===!0&&(Vt.updateMultisampleRenderTarget(gt),Vt.updateRenderTargetMipmap(gt))}R.setRenderTarget(ft,Mt,Rt),R.setClearColor(Y,_t),se!==void 0&&(k.viewport=se),R.toneMapping=Wt}function Aa(S,L,H){let k=L.isScene===!0?L.overrideMaterial:null;for(let z=0,gt=S.length;z<gt;z++){let Et=S[z],{object:ft,geometry:Mt,group:Rt}=Et,Wt=Et.material;Wt.allowOverride===!0&&k!==null&&(Wt=k),ft.layers.test(H.layers)&&Sd(ft,L,H,Mt,Wt,Rt)}}function Sd(S,L,H,k,z,gt){F!==null&&z.isNodeMaterial&&F.setObject(S,z),S.onBeforeRender(R,L,H,k,z,gt),S.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),z.onBeforeRender(R,L,H,k,S,gt),z.transparent===!0&&z.side===ii&&z.forceSinglePass===!1?(z.side=ke,z.needsUpdate=!0,R.renderBufferDirect(H,L,k,z,S,gt),z.side=Pn,z.needsUpdate=!0,R.renderBufferDirect(H,L,k,z,S,gt),z.side=ii):R.renderBufferDirect(H,L,k,z,S,gt),S.onAfterRender(R,L,H,k,z,gt)}function wd(S){let L=0;for(let H of S)H.texture!==null&&L++;return L}function or(S,L,H){L.isScene!==!0&&(L=ie);let k=Ot.get(S),z=E.state.lights,gt=E.state.shadowsArray,Et=z.state.version,ft=J.getParameters(S,z.state,gt,L,H,E.state.lightProbeGridArray),Mt=J.getProgramCacheKey(ft),Rt=k.programs;k.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?L.environment:null,k.fog=L.fog;let Wt=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;k.envMap=A.get(S.envMap||k.environment,Wt),k.envMapRotation=k.environment!==null&&S.envMap===null?L.environmentRotation:S.envMapRotation,Rt===void 0&&(S.addEventListener("dispose",pe),Rt=new Map,k.programs=Rt,k.programVariants=new Map);let se=Rt.get(Mt);if(se!==void 0){if(k.currentProgram===se&&k.lightsStateVersion===Et)return Ed(S,ft),se}else ft.uniforms=J.getUniforms(S),F!==null&&S.isNodeMaterial&&F.build(S,H,ft),S.onBeforeCompile(ft,R),se=J.acquireProgram(ft,Mt),Rt.set(Mt,se),k.uniforms=ft.uniforms;let At=k.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(At.clippingPlanes=j.uniform),Ed(S,ft),k.needsLights=gg(S),k.lightsStateVersion=Et,k.needsLights&&(At.ambientLightColor.value=z.state.ambient,At.lightProbe.value=z.state.probe,At.sunLights.value=z.state.sun,At.sunLightShadows.value=z.state.sunShadow,At.directionalLights.value=z.state.directional,At.directionalLightShadows.value=z.state.directionalShadow,At.spotLights.value=z.state.spot,At.spotLightShadows.value=z.state.spotShadow,At.rectAreaLights.value=z.state.rectArea,At.ltc_1.value=z.state.rectAreaLTC1,At.ltc_2.value=z.state.rectAreaLTC2,At.pointLights.value=z.state.point,At.pointLightShadows.value=z.state.pointShadow,At.hemisphereLights.value=z.state.hemi,At.sunShadowMatrix.value=z.state.sunShadowMatrix,At.sunShadowCascade.value=z.state.sunShadowCascade,At.directionalShadowMatrix.value=z.state.directionalShadowMatrix,At.spotLightMatrix.value=z.state.spotLightMatrix,At.spotLightMap.value=z.state.spotLightMap,At.pointShadowMatrix.value=z.state.pointShadowMatrix),k.numLightProbeGrids=wd(E.state.lightProbeGridArray),k.currentProgram=se,k.uniformsList=null,se}function fg(S,L,H,k,z){let gt=Ot.get(S),Et=gt.currentProgram.id+","+k+","+z,ft=gt.programVariants.get(Et);return ft===void 0?(ft=or(S,L,H),gt.programVariants.set(Et,ft)):(gt.currentProgram=ft,gt.uniformsList=null,gt.outputColorSpace=k,gt.toneMapping=z),ft}function Td(S){if(S.uniformsList===null){let L=S.currentProgram.getUniforms();S.uniformsList=js.seqWithValue(L.seq,S.uniforms)}return S.uniformsList}function Ed(S,L){let H=Ot.get(S);H.outputColorSpace=L.outputColorSpace,H.batching=L.batching,H.batchingColor=L.batchingColor,H.instancing=L.instancing,H.instancingColor=L.instancingColor,H.instancingMorph=L.instancingMorph,H.skinning=L.skinning,H.morphTargets=L.morphTargets,H.morphNormals=L.morphNormals,H.morphColors=L.morphColors,H.morphTargetsCount=L.morphTargetsCount,H.numClippingPlanes=L.numClippingPlanes,H.numIntersection=L.numClipIntersection,H.vertexAlphas=L.vertexAlphas,H.vertexTangents=L.vertexTangents,H.toneMapping=L.toneMapping}function pg(S,L,H,k,z){L.isScene!==!0&&(L=ie),Vt.resetTextureUnits();let gt=L.fog,Et=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?L.environment:null,ft=nt===null?R.outputColorSpace:nt.isXRRenderTarget===!0?nt.texture.colorSpace:ae.workingColorSpace,Mt=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Rt=A.get(k.envMap||Et,Mt),Wt=k.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,se=!!H.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),At=!!H.morphAttributes.position,re=!!H.morphAttributes.normal,Ue=!!H.morphAttributes.color,ve=qi;k.toneMapped&&(nt===null||nt.isXRRenderTarget===!0)&&(ve=R.toneMapping);let _e=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,Je=_e!==void 0?_e.length:0,Ct=Ot.get(k),si=E.state.lights;if(ot===!0&&(St===!0||S!==Q)){let Ce=S===Q&&k.id===X;j.setState(k,S,Ce)}let he=!1,Fn=!1;k.version===Ct.__version?Ct.needsLights&&Ct.lightsStateVersion!==si.state.version||z.isBatchedMesh&&Ct.batching===!1||!z.isBatchedMesh&&Ct.batching===!0||z.isBatchedMesh&&Ct.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Ct.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Ct.instancing===!1||!z.isInstancedMesh&&Ct.instancing===!0||z.isSkinnedMesh&&Ct.skinning===!1||!z.isSkinnedMesh&&Ct.skinning===!0||z.isInstancedMesh&&Ct.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Ct.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Ct.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Ct.instancingMorph===!1&&z.morphTexture!==null||Ct.envMap!==Rt||k.fog===!0&&Ct.fog!==gt||Ct.numClippingPlanes!==void 0&&(Ct.numClippingPlanes!==j.numPlanes||Ct.numIntersection!==j.numIntersection)||Ct.vertexAlphas!==Wt||Ct.vertexTangents!==se||Ct.morphTargets!==At||Ct.morphNormals!==re||Ct.morphColors!==Ue||Ct.morphTargetsCount!==Je||Ct.numLightProbeGrids!==wd(E.state.lightProbeGridArray)?he=!0:(Ct.outputColorSpace!==ft||Ct.toneMapping!==ve)&&(Fn=!0):(he=!0,Ct.__version=k.version);let Qe=Ct.currentProgram;(he===!0||Fn===!0)&&(Qe=Fn===!0?fg(k,L,z,ft,ve):or(k,L,z),F&&k.isNodeMaterial&&F.onUpdateProgram(k,Qe,Ct));let Ca=!1,xn=!1,kn=!1,oe=Qe.getUniforms(),Ye=Ct.uniforms;if(pt.useProgram(Qe.program)&&(Ca=!0,xn=!0,kn=!0),k.id!==X&&(X=k.id,xn=!0),Ca||Q!==S){pt.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),oe.setValue(D,"projectionMatrix",S.projectionMatrix),oe.setValue(D,"viewMatrix",S.matrixWorldInverse);let We=oe.map.cameraPosition;We!==void 0&&We.setValue(D,Xt.setFromMatrixPosition(S.matrixWorld)),xe.logarithmicDepthBuffer&&oe.setValue(D,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&oe.setValue(D,"isOrthographic",S.isOrthographicCamera===!0),Q!==S&&(Q=S,xn=!0,kn=!0)}if(Ct.needsLights&&(si.state.sunShadowMap.length>0&&oe.setValue(D,"sunShadowMap",si.state.sunShadowMap,Vt),si.state.directionalShadowMap.length>0&&oe.setValue(D,"directionalShadowMap",si.state.directionalShadowMap,Vt),si.state.spotShadowMap.length>0&&oe.setValue(D,"spotShadowMap",si.state.spotShadowMap,Vt),si.state.pointShadowMap.length>0&&oe.setValue(D,"pointShadowMap",si.state.pointShadowMap,Vt)),z.isSkinnedMesh){oe.setOptional(D,z,"bindMatrix"),oe.setOptional(D,z,"bindMatrixInverse");let Ce=z.skeleton;Ce&&(Ce.boneTexture===null&&Ce.computeBoneTexture(),oe.setValue(D,"boneTexture",Ce.boneTexture,Vt))}z.isBatchedMesh&&(oe.setOptional(D,z,"batchingTexture"),oe.setValue(D,"batchingTexture",z._matricesTexture,Vt),oe.setOptional(D,z,"batchingIdTexture"),oe.setValue(D,"batchingIdTexture",z._indirectTexture,Vt),oe.setOptional(D,z,"batchingColorTexture"),z._colorsTexture!==null&&oe.setValue(D,"batchingColorTexture",z._colorsTexture,Vt));let Ai=H.morphAttributes;if((Ai.position!==void 0||Ai.normal!==void 0||Ai.color!==void 0)&&K.update(z,H,Qe),(xn||Ct.receiveShadow!==z.receiveShadow)&&(Ct.receiveShadow=z.receiveShadow,oe.setValue(D,"receiveShadow",z.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&L.environment!==null&&(Ye.envMapIntensity.value=L.environmentIntensity),Ye.dfgLUT!==void 0&&(Ye.dfgLUT.value=Tb()),xn){if(oe.setValue(D,"toneMappingExposure",R.toneMappingExposure),Ct.needsLights&&mg(Ye,kn),gt&&k.fog===!0&&lt.refreshFogUniforms(Ye,gt),lt.refreshMaterialUniforms(Ye,k,yt,Dt,E.state.transmissionRenderTarget[S.id]),Ct.needsLights&&Ct.numLightProbeGrids>0){let Ce=b,We=0;for(let ji of E.state.lightProbeGridArray)ji.texture!==null&&(Ce.textures[We]=ji.texture,Ce.min[We]=ji.boundingBox.min,Ce.max[We]=ji.boundingBox.max,Ce.resolution[We]=ji.resolution,We++);for(let ji in Ce)Ce[ji].length=We;Ye.probesSH.value=Ce.textures,Ye.probesMin.value=Ce.min,Ye.probesMax.value=Ce.max,Ye.probesResolution.value=Ce.resolution}js.upload(D,Td(Ct),Ye,Vt)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(js.upload(D,Td(Ct),Ye,Vt),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&oe.setValue(D,"center",z.center),oe.setValue(D,"modelViewMatrix",z.modelViewMatrix),oe.setValue(D,"normalMatrix",z.normalMatrix),oe.setValue(D,"modelMatrix",z.matrixWorld),k.uniformsGroups!==void 0){let Ce=k.uniformsGroups;for(let We=0,ji=Ce.length;We<ji;We++){let Cd=Ce[We];It.update(Cd,Qe),It.bind(Cd,Qe)}}return Qe}function mg(S,L){S.ambientLightColor.needsUpdate=L,S.lightProbe.needsUpdate=L,S.sunLights.needsUpdate=L,S.sunLightShadows.needsUpdate=L,S.directionalLights.needsUpdate=L,S.directionalLightShadows.needsUpdate=L,S.pointLights.needsUpdate=L,S.pointLightShadows.needsUpdate=L,S.spotLights.needsUpdate=L,S.spotLightShadows.needsUpdate=L,S.rectAreaLights.needsUpdate=L,S.hemisphereLights.needsUpdate=L}function gg(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return nt},this.setRenderTargetTextures=function(S,L,H){let k=Ot.get(S);k.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Ot.get(S.texture).__webglTexture=L,Ot.get(S.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:H,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,L){let H=Ot.get(S);H.__webglFramebuffer=L,H.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(S,L=0,H=0){nt=S,$=L,V=H;let k=null,z=!1,gt=!1;if(S){let ft=Ot.get(S);if(ft.__useDefaultFramebuffer!==void 0){pt.bindFramebuffer(D.FRAMEBUFFER,ft.__webglFramebuffer),et.copy(S.viewport),wt.copy(S.scissor),kt=S.scissorTest,pt.viewport(et),pt.scissor(wt),pt.setScissorTest(kt),X=-1;return}else if(ft.__webglFramebuffer===void 0)Vt.setupRenderTarget(S);else if(ft.__hasExternalTextures)Vt.rebindTextures(S,Ot.get(S.texture).__webglTexture,Ot.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let Wt=S.depthTexture;if(ft.__boundDepthTexture!==Wt){if(Wt!==null&&Ot.has(Wt)&&(S.width!==Wt.image.width||S.height!==Wt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Vt.setupDepthRenderbuffer(S)}}let Mt=S.texture;(Mt.isData3DTexture||Mt.isDataArrayTexture||Mt.isCompressedArrayTexture)&&(gt=!0);let Rt=Ot.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Rt[L])?k=Rt[L][H]:k=Rt[L],z=!0):S.samples>0&&Vt.useMultisampledRTT(S)===!1?k=Ot.get(S).__webglMultisampledFramebuffer:Array.isArray(Rt)?k=Rt[H]:k=Rt,et.copy(S.viewport),wt.copy(S.scissor),kt=S.scissorTest}else et.copy(Bt).multiplyScalar(yt).floor(),wt.copy(Jt).multiplyScalar(yt).floor(),kt=ee;if(H!==0&&(k=W),pt.bindFramebuffer(D.FRAMEBUFFER,k)&&pt.drawBuffers(S,k),pt.viewport(et),pt.scissor(wt),pt.setScissorTest(kt),z){let ft=Ot.get(S.texture);D.framebufferTexture2D(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_CUBE_MAP_POSITIVE_X+L,ft.__webglTexture,H)}else if(gt){let ft=L;for(let Mt=0;Mt<S.textures.length;Mt++){let Rt=Ot.get(S.textures[Mt]);D.framebufferTextureLayer(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0+Mt,Rt.__webglTexture,H,ft)}}else if(S!==null&&H!==0){let ft=Ot.get(S.texture);D.framebufferTexture2D(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,ft.__webglTexture,H)}X=-1};function Ad(S){let L=Ot.get(S);return(L.__readFormat!==S.format||L.__readType!==S.type)&&(L.__readFormat=S.format,L.__readType=S.type,L.__formatReadable=xe.textureFormatReadable(S.format),L.__typeReadable=xe.textureTypeReadable(S.type)),L}this.readRenderTargetPixels=function(S,L,H,k,z,gt,Et,ft=0){if(!(S&&S.isWebGLRenderTarget)){zt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Mt=Ot.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Et!==void 0&&(Mt=Mt[Et],Array.isArray(Mt)&&(Mt=Mt[0])),Mt){pt.bindFramebuffer(D.FRAMEBUFFER,Mt);try{let Rt=S.textures[ft],Wt=Rt.format,se=Rt.type;S.textures.length>1&&D.readBuffer(D.COLOR_ATTACHMENT0+ft);let At=Ad(Rt);if(At.__formatReadable===!1){zt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(At.__typeReadable===!1){zt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=S.width-k&&H>=0&&H<=S.height-z&&D.readPixels(L,H,k,z,at.convert(Wt),at.convert(se),gt)}finally{let Rt=nt!==null?Ot.get(nt).__webglFramebuffer:null;pt.bindFramebuffer(D.FRAMEBUFFER,Rt)}}},this.readRenderTargetPixelsAsync=async function(S,L,H,k,z,gt,Et,ft=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Mt=Ot.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Et!==void 0&&(Mt=Mt[Et],Array.isArray(Mt)&&(Mt=Mt[0])),Mt)if(L>=0&&L<=S.width-k&&H>=0&&H<=S.height-z){pt.bindFramebuffer(D.FRAMEBUFFER,Mt);let Rt=S.textures[ft],Wt=Rt.format,se=Rt.type;S.textures.length>1&&D.readBuffer(D.COLOR_ATTACHMENT0+ft);let At=Ad(Rt);if(At.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(At.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let re=D.createBuffer();D.bindBuffer(D.PIXEL_PACK_BUFFER,re),D.bufferData(D.PIXEL_PACK_BUFFER,gt.byteLength,D.STREAM_READ),D.readPixels(L,H,k,z,at.convert(Wt),at.convert(se),0),D.bindBuffer(D.PIXEL_PACK_BUFFER,null);let Ue=nt!==null?Ot.get(nt).__webglFramebuffer:null;pt.bindFramebuffer(D.FRAMEBUFFER,Ue);let ve=D.fenceSync(D.SYNC_GPU_COMMANDS_COMPLETE,0);return D.flush(),await rp(D,ve,4),D.bindBuffer(D.PIXEL_PACK_BUFFER,re),D.getBufferSubData(D.PIXEL_PACK_BUFFER,0,gt),D.bindBuffer(D.PIXEL_PACK_BUFFER,null),D.deleteBuffer(re),D.deleteSync(ve),gt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,L=null,H=0){let k=Math.pow(2,-H),z=Math.floor(S.image.width*k),gt=Math.floor(S.image.height*k),Et=L!==null?L.x:0,ft=L!==null?L.y:0;Vt.setTexture2D(S,0),D.copyTexSubImage2D(D.TEXTURE_2D,H,0,0,Et,ft,z,gt),pt.unbindTexture()},this.copyTextureToTexture=function(S,L,H=null,k=null,z=0,gt=0){let Et,ft,Mt,Rt,Wt,se,At,re,Ue,ve=S.isCompressedTexture?S.mipmaps[gt]:S.image;if(H!==null)Et=H.max.x-H.min.x,ft=H.max.y-H.min.y,Mt=H.isBox3?H.max.z-H.min.z:1,Rt=H.min.x,Wt=H.min.y,se=H.isBox3?H.min.z:0;else{let oe=Math.pow(2,-z);Et=Math.floor(ve.width*oe),ft=Math.floor(ve.height*oe),S.isDataArrayTexture?Mt=ve.depth:S.isData3DTexture?Mt=Math.floor(ve.depth*oe):Mt=1,Rt=0,Wt=0,se=0}k!==null?(At=k.x,re=k.y,Ue=k.z):(At=0,re=0,Ue=0);let _e=at.convert(L.format),Je=at.convert(L.type),Ct;L.isData3DTexture?(Vt.setTexture3D(L,0),Ct=D.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(Vt.setTexture2DArray(L,0),Ct=D.TEXTURE_2D_ARRAY):(Vt.setTexture2D(L,0),Ct=D.TEXTURE_2D),pt.activeTexture(D.TEXTURE0),pt.pixelStorei(D.UNPACK_FLIP_Y_WEBGL,L.flipY),pt.pixelStorei(D.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),pt.pixelStorei(D.UNPACK_ALIGNMENT,L.unpackAlignment);let si=pt.getParameter(D.UNPACK_ROW_LENGTH),he=pt.getParameter(D.UNPACK_IMAGE_HEIGHT),Fn=pt.getParameter(D.UNPACK_SKIP_PIXELS),Qe=pt.getParameter(D.UNPACK_SKIP_ROWS),Ca=pt.getParameter(D.UNPACK_SKIP_IMAGES);pt.pixelStorei(D.UNPACK_ROW_LENGTH,ve.width),pt.pixelStorei(D.UNPACK_IMAGE_HEIGHT,ve.height),pt.pixelStorei(D.UNPACK_SKIP_PIXELS,Rt),pt.pixelStorei(D.UNPACK_SKIP_ROWS,Wt),pt.pixelStorei(D.UNPACK_SKIP_IMAGES,se);let xn=S.isDataArrayTexture||S.isData3DTexture,kn=L.isDataArrayTexture||L.isData3DTexture;if(S.isDepthTexture){let oe=Ot.get(S),Ye=Ot.get(L),Ai=Ot.get(oe.__renderTarget),Ce=Ot.get(Ye.__renderTarget);pt.bindFramebuffer(D.READ_FRAMEBUFFER,Ai.__webglFramebuffer),pt.bindFramebuffer(D.DRAW_FRAMEBUFFER,Ce.__webglFramebuffer);for(let We=0;We<Mt;We++)xn&&(D.framebufferTextureLayer(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,Ot.get(S).__webglTexture,z,se+We),D.framebufferTextureLayer(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,Ot.get(L).__webglTexture,gt,Ue+We)),D.blitFramebuffer(Rt,Wt,Rt+Et,Wt+ft,At,re,At+Et,re+ft,D.DEPTH_BUFFER_BIT,D.NEAREST);pt.bindFramebuffer(D.READ_FRAMEBUFFER,null),pt.bindFramebuffer(D.DRAW_FRAMEBUFFER,null)}else if(z!==0||S.isRenderTargetTexture||Ot.has(S)){let oe=Ot.get(S),Ye=Ot.get(L);pt.bindFramebuffer(D.READ_FRAMEBUFFER,N),pt.bindFramebuffer(D.DRAW_FRAMEBUFFER,G);for(let Ai=0;Ai<Mt;Ai++)xn?D.framebufferTextureLayer(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,oe.__webglTexture,z,se+Ai):D.framebufferTexture2D(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,oe.__webglTexture,z),kn?D.framebufferTextureLayer(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,Ye.__webglTexture,gt,Ue+Ai):D.framebufferTexture2D(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,Ye.__webglTexture,gt),z!==0?D.blitFramebuffer(Rt,Wt,Rt+Et,Wt+ft,At,re,At+Et,re+ft,D.COLOR_BUFFER_BIT,D.NEAREST):kn?D.copyTexSubImage3D(Ct,gt,At,re,Ue+Ai,Rt,Wt,Et,ft):D.copyTexSubImage2D(Ct,gt,At,re,Rt,Wt,Et,ft);pt.bindFramebuffer(D.READ_FRAMEBUFFER,null),pt.bindFramebuffer(D.DRAW_FRAMEBUFFER,null)}else kn?S.isDataTexture||S.isData3DTexture?D.texSubImage3D(Ct,gt,At,re,Ue,Et,ft,Mt,_e,Je,ve.data):L.isCompressedArrayTexture?D.compressedTexSubImage3D(Ct,gt,At,re,Ue,Et,ft,Mt,_e,ve.data):D.texSubImage3D(Ct,gt,At,re,Ue,Et,ft,Mt,_e,Je,ve):S.isDataTexture?D.texSubImage2D(D.TEXTURE_2D,gt,At,re,Et,ft,_e,Je,ve.data):S.isCompressedTexture?D.compressedTexSubImage2D(D.TEXTURE_2D,gt,At,re,ve.width,ve.height,_e,ve.data):D.texSubImage2D(D.TEXTURE_2D,gt,At,re,Et,ft,_e,Je,ve);pt.pixelStorei(D.UNPACK_ROW_LENGTH,si),pt.pixelStorei(D.UNPACK_IMAGE_HEIGHT,he),pt.pixelStorei(D.UNPACK_SKIP_PIXELS,Fn),pt.pixelStorei(D.UNPACK_SKIP_ROWS,Qe),pt.pixelStorei(D.UNPACK_SKIP_IMAGES,Ca),gt===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&D.generateMipmap(Ct),pt.unbindTexture()},this.initRenderTarget=function(S){Ot.get(S).__webglFramebuffer===void 0&&Vt.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Vt.setTextureCube(S,0):S.isData3DTexture?Vt.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Vt.setTexture2DArray(S,0):Vt.setTexture2D(S,0),pt.unbindTexture()},this.resetState=function(){$=0,V=0,nt=null,pt.reset(),ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ae._getDrawingBufferColorSpace(t),e.unpackColorSpace=ae._getUnpackColorSpace()}};var jl=class{constructor(t){this.scene=t;let{beam_member:e,beam_along:i}=t.arrays;this.row=new Map(e?[...e.data].map((n,r)=>[n,r]):[]),this.places=i?i.shape[1]:0,this.several=i?i.shape[2]:0}points(t,e){let{ends:i}=this.scene;return this.row.has(e)?this.combined("beam_along",t,this.row.get(e)):[t[i[2*e]],t[i[2*e+1]]]}across(t,e){return this.combined("beam_across",t,this.row.get(e))}combined(t,e,i){let{scene:{arrays:n},places:r,several:a}=this,{data:o}=n[t];return Array.from({length:r},(l,c)=>{let h=[0,0,0];for(let u=0;u<a;u++){let d=o[(i*r+c)*a+u],f=e[n.beam_nodes.data[i*a+u]];for(let p=0;p<3;p++)h[p]+=d*f[p]}return h})}};function Ti(s){return s.slice(1).map((t,e)=>[s[e],t])}var Eb=3e4,Ab=s=>[1,3,5].map(t=>parseInt(s.slice(t,t+2),16)),Kl=class{constructor(t){this.scene=t,this.corners=t.skin;let e=t.faces,i=new Me;for(let a of["position","color"])i.setAttribute(a,new Ne(new Float32Array(9*e),3));let n=new ci({vertexColors:!0,side:ii,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});this.mesh=new Pe(i,n),this.mesh.visible=e>0,this.edges=xa(this.corners);let r=new Me;r.setAttribute("position",new Ne(new Float32Array(3*this.edges.length),3)),this.lines=new Si(r,new li({transparent:!0,opacity:.35}));for(let a of this.objects())a.frustumCulled=!1}objects(){return[this.mesh,this.lines]}setTheme(t){this.lines.material.color.set(Xe[t].edge)}place(t){let{mesh:e,lines:i}=this;if(!e.visible)return;let n=e.geometry.attributes.position,r=i.geometry.attributes.position;this.corners.forEach((a,o)=>n.array.set(t[a],3*o)),this.edges.forEach((a,o)=>r.array.set(t[a],3*o)),n.needsUpdate=r.needsUpdate=!0,e.geometry.computeVertexNormals()}paint(t,e,i){let{scene:n,mesh:r}=this;if(!r.visible)return;let a=t&&n.coloursFaces(t.id),o=new Nt,{array:l}=r.geometry.attributes.color;for(let c=0;c<n.faces;c++){let h=n.header.skins[n.arrays.skin_part.data[c]].kind,[u,d,f]=a?yn(t.scale,n.faceValue(t.id,e,c),i):Ab(Ia[h]||cs);o.setRGB(u/255,d/255,f/255,"srgb");for(let p=0;p<3;p++)o.toArray(l,9*c+3*p)}r.geometry.attributes.color.needsUpdate=!0}colourOf(t){let{r:e,g:i,b:n}=new Nt().fromArray(this.mesh.geometry.attributes.color.array,9*t).getRGB({r:0,g:0,b:0},"srgb");return[e,i,n].map(r=>Math.round(255*r))}};function xa(s){let t=new Map;for(let e=0;e<s.length;e+=3)for(let i=0;i<3;i++){let n=s[e+i],r=s[e+(i+1)%3];t.set(n<r?`${n} ${r}`:`${r} ${n}`,[n,r])}return t.size>Eb?[]:[...t.values()].flat()}var Cb=new P(0,1,0);function Jl(s,t,e="#ffffff"){let i=new Hi(s,new ci({color:e}),Math.max(t,1));return i.count=t,i.instanceMatrix.setUsage(Mu),i.frustumCulled=!1,i}function rs(s,t){return Jl(new ln(1,1,1,t,1,!1),s)}function Yp(s){return Jl(new En(2,1,2),s)}function Ql(s,t,e){return Jl(new Kn(1,t),s,e)}function Zp(s,t,e){return Jl(new zs(1,1,t),s,e)}function Ei(s,t,e,i,n){let r=s.instanceMatrix.array,a=16*t,o=i[0]-e[0],l=i[1]-e[1],c=i[2]-e[2],h=Math.hypot(o,l,c)||1e-12,u=o/h,d=l/h,f=c/h,p=0,y=-f,m=d;Math.abs(u)>.7&&([p,y,m]=[f,0,-u]);let g=n/(Math.hypot(p,y,m)||1);p*=g,y*=g,m*=g,r[a]=p,r[a+1]=y,r[a+2]=m,r[a+3]=0,r[a+4]=o,r[a+5]=l,r[a+6]=c,r[a+7]=0,r[a+8]=y*f-m*d,r[a+9]=m*u-p*f,r[a+10]=p*d-y*u,r[a+11]=0,r[a+12]=(e[0]+i[0])/2,r[a+13]=(e[1]+i[1])/2,r[a+14]=(e[2]+i[2])/2,r[a+15]=1}function jp(s,t,e,i,n,[r,a]){let o=s.instanceMatrix.array,l=16*t,c=[i[0]-e[0],i[1]-e[1],i[2]-e[2]],h=Math.hypot(...c)||1e-12,u=c.map(m=>m/h),d=u[0]*n[0]+u[1]*n[1]+u[2]*n[2],f=n.map((m,g)=>m-d*u[g]),p=Math.hypot(...f)||1;f=f.map(m=>m/p);let y=[f[1]*u[2]-f[2]*u[1],f[2]*u[0]-f[0]*u[2],f[0]*u[1]-f[1]*u[0]];for(let m=0;m<3;m++)o[l+m]=r*f[m],o[l+4+m]=c[m],o[l+8+m]=a*y[m],o[l+12+m]=(e[m]+i[m])/2;o[l+3]=o[l+7]=o[l+11]=0,o[l+15]=1}function Js(s,t,e,i){let n=s.instanceMatrix.array,r=16*t;n.fill(0,r,r+16),n[r]=n[r+5]=n[r+10]=i,n[r+12]=e[0],n[r+13]=e[1],n[r+14]=e[2],n[r+15]=1}function Nn(s){s.instanceMatrix.needsUpdate=!0}function _a(s){let t=new Fe,e=new ci({color:s}),i=new Pe(new ln(1,1,1,12),e),n=new Pe(new zs(1,1,16),e);return t.add(i,n),t}function Qs(s,t,e,i){let n=Math.hypot(...e);if(s.visible=n>2*i,!s.visible)return;let[r,a]=s.children,o=Math.min(5*i,n/2);r.scale.set(i,n-o,i),r.position.y=(n-o)/2,a.scale.set(2.4*i,o,2.4*i),a.position.y=n-o/2,s.position.set(...t),s.quaternion.copy(new je().setFromUnitVectors(Cb,new P(...e).normalize()))}function Kp(s,t){return new Pe(new Jr(s,s/5,10,32),new ci({color:t}))}function tc({length0:s,extent:t}){return Math.max(.1*s,.04*t.size)}function as({kind:s,along:t},e,i){let[n,r]=Rb(s,t);return Dd[s].map(a=>a.map(([o,l])=>e.map((c,h)=>c+i*(o*n[h]+l*r[h]))))}function Rb(s,t){if(!t.some(Boolean))return[[1,0,0],[0,0,1]];let e=Math.hypot(t[0],t[1]),i=e>1e-9?[t[1]/e,-t[0]/e,0]:[1,0,0];return[i,s.startsWith("turn")?Pb(t,i):t]}function Pb(s,t){return[s[1]*t[2]-s[2]*t[1],s[2]*t[0]-s[0]*t[2],s[0]*t[1]-s[1]*t[0]]}var Jp=hi.driven,Ib="#3f4a55",ec=.3,Nb={x:[1,0,0],y:[0,1,0],z:[0,0,1]},ic=class{constructor(t){Object.assign(this,{scene:t,size:tc(t)}),this.marks=t.header.support_marks,this.pointed=this.marks.filter(({kind:i})=>Qp(i));let e=this.marks.reduce((i,n)=>i+this.rodsOf(n,[0,0,0]).length,0);this.cones=Zp(this.pointed.length,4,"#ffffff"),this.rods=rs(e,6),this.mesh=new Fe,this.mesh.add(this.cones,this.rods)}rodsOf(t,e){return as(t,e,this.size).filter((i,n)=>n>0||!Qp(t.kind)).flatMap(Ti)}feet(t){return this.marks.map(({node:e,along:i})=>this.scene.position(t,e).map((n,r)=>n-this.size*i[r]))}setTheme({support:t}){for(let e of this.mesh.children)e.material.color.set(t)}place(t){this.pointed.forEach((e,i)=>{let[[n,r,a]]=as(e,t[e.node],this.size);Ei(this.cones,i,r.map((o,l)=>(o+a[l])/2),n,.5*this.size)}),this.marks.flatMap(e=>this.rodsOf(e,t[e.node])).forEach(([e,i],n)=>Ei(this.rods,n,e,i,.045*this.size)),Nn(this.cones),Nn(this.rods)}},Qp=s=>s==="pin"||s==="roller",ya=class{constructor(t,e){this.scene=t,this.radius=.1*e,this.group=new Fe,this.shown=t.header.loads.map((n,r)=>({...n,k:r})).filter(n=>n.drawn!==!1),this.arrows=this.shown.map(()=>_a(lr));for(let n of this.arrows)this.group.add(n);let i=0;if(t.has("load_force")){let{data:n}=t.arrays.load_force;for(let r=0;r<n.length;r+=t.dim)i=Math.max(i,Math.hypot(...n.slice(r,r+t.dim)))}this.factor=i?.16*t.extent.size/i:0}tips(t){return this.shown.map(e=>{let i=this.scene.vector("load_force",t,e.k),n=(e.pressure?ec:1)*this.factor;return this.scene.placeOfLoad(e,r=>this.scene.position(t,r)).map((r,a)=>e.at?r-n*i[a]:r+n*i[a])})}place(t,e){this.shown.forEach((i,n)=>{let r=i.pressure?ec:1,a=this.scene.vector("load_force",e,i.k).map(l=>r*l*this.factor),o=this.scene.placeOfLoad(i,l=>t[l]);Qs(this.arrows[n],i.at?o.map((l,c)=>l-a[c]):o,a,r*this.radius)})}},nc=class{constructor(t,e){this.scene=t,this.size=e,this.group=new Fe,this.shown=t.header.drives.filter(i=>i.kind!=="length").map(i=>{let n=i.kind==="coordinate"?_a(Jp):Kp(.75*e,Jp);return this.group.add(n),{drive:i,mark:n}})}place(t){for(let{drive:e,mark:i}of this.shown)e.kind==="angle"?tm(i,t[this.scene.ends[2*e.member]],e.about):e.kind==="hinge"?tm(i,...Lb(e.axis.map(n=>t[n]))):Qs(i,t[e.node],Nb[e.axis].map(n=>2.5*this.size*n),.15*this.size)}};function Lb([s,t]){return t?[s.map((e,i)=>(e+t[i])/2),t.map((e,i)=>e-s[i])]:[s,[0,0,1]]}function tm(s,t,e=[0,0,1]){s.position.set(...t),s.quaternion.setFromUnitVectors(new P(0,0,1),new P(...e).normalize())}var sc=class{constructor(t,e,i){this.scene=t,this.triangles=e;let n=new Me;n.setAttribute("position",new Ne(new Float32Array(9*e.length),3));let r=new ci({color:"#7f93a8",side:ii,transparent:!0,opacity:i,depthWrite:!1});this.mesh=new Pe(n,r),this.mesh.frustumCulled=!1}place(t){let{array:e}=this.mesh.geometry.attributes.position;this.triangles.forEach((i,n)=>{i.forEach((r,a)=>e.set(t[r],9*n+3*a))}),this.mesh.geometry.attributes.position.needsUpdate=!0,this.mesh.geometry.computeVertexNormals()}};function Wu(s,{member:t,center:e},i){let n=i[s.ends[2*t]],r=i[s.ends[2*t+1]],a=Math.hypot(r[0]-n[0],r[1]-n[1])||1,o=[(r[0]-n[0])/a,(r[1]-n[1])/a];return[n,r,[n[0]+e[0]*o[0]-e[1]*o[1],n[1]+e[0]*o[1]+e[1]*o[0],0]]}var rc=class{constructor(t,e){this.scene=t,this.size=e,this.mesh=Ql(t.header.bodies.length,2,Ib)}place(t){this.scene.header.bodies.forEach((e,i)=>Js(this.mesh,i,Wu(this.scene,e,t)[2],this.size)),Nn(this.mesh)}};function em(s){let{low:t,high:e,centre:i,size:n}=s.extent,r=Gn(n/8),a=Math.max(4,Math.ceil(.75*n/r)),o=new na(2*a*r,2*a,"#8a949e","#8a949e");o.material.transparent=!0,o.material.opacity=.35;let l=c=>Math.round(c/r)*r;return s.dim===2?(o.rotation.x=Math.PI/2,o.position.set(l(i[0]),l(i[1]),-.08*s.length0)):(o.quaternion.copy(new je().setFromUnitVectors(new P(0,1,0),new P(0,0,1))),o.position.set(l(i[0]),l(i[1]),t[2]-.03*(e[2]-t[2]||n))),{grid:o,step:r}}function im(s){let t=s.nodes.map((r,a)=>s.position(0,a)),i=[...s.members.flatMap((r,a)=>s.shows(a)?Ti(s.curves.points(t,a)).flat():[]),...xa(s.skin).map(r=>t[r])].flat(),n=new Si(Xu(i),new li({color:"#8a949e",transparent:!0,opacity:.8}));return n.frustumCulled=!1,n}function Xu(s){let t=new Me;return t.setAttribute("position",new Ne(new Float32Array(s),3)),t}var Db=9,Ub=22,ac={corner:[.72,-1,.42],front:[0,-1,0],side:[1,0,0],top:[0,-1e-4,1],plane:[0,0,1]},tr=class{constructor(t,e){Object.assign(this,{canvas:t,scene:e,frame:0,channel:null,limits:[0,1],picked:null})}points(){let{scene:t,frame:e,mode:i}=this;return t.nodes.map((n,r)=>{let a=t.position(e,r);if(!i)return a;let o=t.arrays[i.array].data,l=r*t.dim;for(let c=0;c<t.dim;c++)a[c]+=i.size*o[l+c];return a})}setFrame(t){this.frame=t,this.move(),this.paint()}setColours(t,e){Object.assign(this,{channel:t,limits:e}),this.paint()}get plain(){return!this.channel||!this.scene.channel(this.channel.id)}shade(t){let{scene:e,channel:i,frame:n,limits:r}=this;return this.plain?us(hi[e.header.kinds[t]]):yn(i.scale,e.value(i.id,n,t),r)}hatched(t){let{scene:e,channel:i,frame:n}=this;return!this.plain&&i.id!=="speed"&&(e.unsure.has(t)||Number.isNaN(e.value(i.id,n,t)))}request(){this.waiting||=requestAnimationFrame(()=>this.render())}along(t,e){let{curves:i,ends:n}=this.scene;return i.row.has(t)?i.points(this.now,t).map(r=>this.project(r)):[e[n[2*t]],e[n[2*t+1]]]}pickAt(t,e,i=!1){let n=this.now.map(l=>this.project(l)),r=i?Ub:Db,a=null,o=(l,c,h,u,d)=>{let f=u+1e-4*h-d;h<=r&&u<1&&(!a||f<a.far)&&(a={type:l,index:c,far:f})};return this.scene.members.forEach((l,c)=>{if(this.scene.shows(c))for(let[h,u]of Ti(this.along(c,n))){let[d,f]=[u[0]-h[0],u[1]-h[1]],p=Math.min(1,Math.max(0,((t-h[0])*d+(e-h[1])*f)/(d*d+f*f||1)));o("member",c,Math.hypot(h[0]+p*d-t,h[1]+p*f-e),h[2]+p*(u[2]-h[2]),0)}}),n.forEach((l,c)=>this.scene.directors.has(c)||o("node",c,Math.hypot(l[0]-t,l[1]-e),l[2],.002)),a&&{type:a.type,index:a.index}}};var er=class{constructor(t){this.scene=t,this.group=new Fe,this.lines=new Map,this.material=new li({})}setTheme({ink:t}){this.material.color.set(t)}show(t){for(let[e,i]of this.lines)i.visible=t.has(e);for(let e of t)this.lines.has(e)||this.add(e)}add(t){let{scene:e}=this,i=new Bs(Xu(Array.from({length:e.frames},(n,r)=>e.position(r,t)).flat()),this.material);i.frustumCulled=!1,this.lines.set(t,i),this.group.add(i)}get shown(){return[...this.lines].filter(([,t])=>t.visible).map(([t])=>t)}};function nm(s){let t=new Set([...s.header.supports.map(i=>i.node),...s.skin,...s.directors]),e=[];for(let i=0;i<s.nodes.length;i++){if(t.has(i))continue;let n=s.position(0,i);for(let r=1;r<s.frames;r++)if(Math.hypot(...s.position(r,i).map((o,l)=>o-n[l]))>1e-4*s.extent.size){e.push(i);break}}return e}var oc=()=>({visible:!0}),cc=class extends tr{constructor(t,e,i){super(t,e),this.step=Gn(e.extent.size/8),this.traces=new er(e),Object.assign(this,{ghost:{visible:!1},grid:oc(),loads:{group:oc()},supports:{mesh:oc()},faces:{mesh:oc()}}),this.controls={update(){}},this.setTheme(i),this.aim(e.dim===2?"plane":"corner"),this.setFrame(0)}setTheme(t){this.colours=Xe[t],this.request()}move(){this.now=this.points(),this.request()}paint(){this.request()}pick(t){this.picked=t,this.request()}showTraces(t){this.paths=t,this.request()}rebuildLoads(){this.request()}aim(t){this.preset=t;let e=ac[t],i=Math.hypot(...e),n=e.map(a=>a/i),r=Math.abs(n[2])>.99?[0,1,0]:[0,0,1];this.turn(n,r),this.zoom=1}turn(t,e){let i=[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],n=Math.hypot(...i)||1,r=i.map(a=>a/n);this.axes=[r,[t[1]*r[2]-t[2]*r[1],t[2]*r[0]-t[0]*r[2],t[0]*r[1]-t[1]*r[0]],t],this.request()}orbit(t,e,i){let[,,n]=this.axes,r=Math.hypot(n[0],n[1])||1e-6,a=Math.atan2(n[1],n[0])+t,o=Math.min(Math.max(Math.atan2(n[2],r)+e,-1.5),1.5);(t||e)&&this.turn([Math.cos(a)*Math.cos(o),Math.sin(a)*Math.cos(o),Math.sin(o)],[0,0,1]),this.zoom/=i,this.request(),this.onCamera?.(this)}copyCamera(t){t.axes&&Object.assign(this,{axes:t.axes,zoom:t.zoom}),this.request()}resize(){this.request()}end(){this.ended=!0}project(t){let{clientWidth:e,clientHeight:i}=this.canvas,{centre:n,size:r}=this.scene.extent,[a,o,l]=this.axes.map(h=>h.reduce((u,d,f)=>u+d*(t[f]-n[f]),0)),c=.86*this.zoom*Math.min(e,i)/r;return[e/2+c*a,i/2-c*o,.5-l/(4*r)]}render(){cancelAnimationFrame(this.waiting),this.waiting=0;let{clientWidth:t,clientHeight:e}=this.canvas,i=window.devicePixelRatio||1;if(this.ended||!t||!e)return;this.canvas.width=Math.round(t*i),this.canvas.height=Math.round(e*i);let n=this.canvas.getContext("2d"),{scene:r,colours:a}=this;n.scale(i,i),n.fillStyle=a.back,n.fillRect(0,0,t,e),n.lineCap="round";let o=this.now.map(l=>this.project(l));this.ghost.visible&&this.bars(n,r.nodes.map((l,c)=>r.position(0,c)),()=>a.grid,1);for(let l of this.paths||[])lc(n,Array.from({length:r.frames},(c,h)=>this.project(r.position(h,l))),a.ink,1);this.skins(n,o),this.bars(n,this.now,()=>a.outline,6),this.bars(n,this.now,l=>`rgb(${this.shade(l).join(" ")})`,4),this.bars(n,this.now,l=>this.hatched(l)?a.back:null,4,[3,6]),this.bars(n,this.now,l=>this.picked?.type==="member"&&this.picked.index===l?"#ffb000":null,3),this.marks(n,o),this.drawn=(this.drawn||0)+1,this.onDrawn?.(this)}skins(t,e){let{scene:i,channel:n,frame:r,limits:a,colours:o}=this,l=n&&i.coloursFaces(n.id),c=d=>l?`rgb(${yn(n.scale,i.faceValue(n.id,r,d),a).join(" ")})`:o.body,h=Array.from({length:i.faces},(d,f)=>({corners:[...i.skin.slice(3*f,3*f+3)].map(p=>e[p]),fill:c(f)}));h.push(...(i.header.solids||[]).map(d=>({corners:d.map(f=>e[f]),fill:o.body})));for(let d of i.header.bodies)h.push({corners:Wu(i,d,this.now).map(f=>this.project(f)),fill:o.body});let u=({corners:d})=>d.reduce((f,p)=>f+p[2],0)/d.length;t.strokeStyle=o.edge,t.lineWidth=.3,t.lineJoin="round";for(let{corners:d,fill:f}of h.sort((p,y)=>u(y)-u(p))){t.beginPath();for(let[p,y]of d)t.lineTo(p,y);t.closePath(),t.fillStyle=f,t.fill(),t.stroke()}}bars(t,e,i,n,r=[]){let{scene:a}=this;a.members.forEach((o,l)=>{let c=a.shows(l)&&i(l);c&&lc(t,a.curves.points(e,l).map(h=>this.project(h)),c,n,r)})}marks(t,e){let{scene:i,colours:n}=this,r=([a,o],l,c)=>{t.beginPath(),t.arc(a,o,l,0,7),t.fillStyle=c,t.fill()};if(this.supports.mesh.visible)for(let a of i.header.support_marks)for(let o of as(a,this.now[a.node],tc(i)))lc(t,o.map(l=>this.project(l)),n.support,1.5);i.members.length<800&&e.forEach((a,o)=>!i.directors.has(o)&&r(a,this.picked?.type==="node"&&this.picked.index===o?6:3,n.node));for(let a of i.header.drives){let o=a.kind==="coordinate"?a.node:a.kind==="hinge"?a.axis[0]:i.ends[2*a.member];r(a.kind==="length"?Ob(e,i,a.member):e[o],5,hi.driven)}this.loads.group.visible&&i.has("load_force")&&this.arrows(t)}arrows(t){let{scene:e,frame:i}=this,n=e.header.loads.map((a,o)=>Math.hypot(...e.vector("load_force",i,o))),r=Math.max(...n,1e-30);e.header.loads.forEach((a,o)=>{if(a.drawn===!1||n[o]<.001*r)return;let l=e.vector("load_force",i,o),c=e.placeOfLoad(a,p=>this.now[p]),h=(a.pressure?ec:1)*.16*e.extent.size,u=a.at?c.map((p,y)=>p-h*l[y]/r):c,[d,f]=[u,u.map((p,y)=>p+h*l[y]/r)].map(p=>this.project(p));lc(t,[d,f],lr,2),t.fillStyle=lr,t.fillRect(f[0]-3,f[1]-3,6,6)})}};function Ob(s,t,e){let[i,n]=[s[t.ends[2*e]],s[t.ends[2*e+1]]];return[(i[0]+n[0])/2,(i[1]+n[1])/2]}function lc(s,t,e,i,n=[]){s.strokeStyle=e,s.lineWidth=i,s.setLineDash(n),s.beginPath();for(let[r,a]of t)s.lineTo(r,a);s.stroke(),s.setLineDash([])}var uc=320,ba=160,va=66,hc=254,ir=62,Fb={F_A:"var(--pen-1)",F_B:"var(--pen-1)","m g":"var(--pen-3)","m a":"var(--pen-2)",T:"var(--pen-3)",Q:"var(--pen-3)",P:"var(--pen-3)",B:"var(--pen-3)"};function sm(s,t){let e=Math.max(...t.terms.map(h=>Math.hypot(...h.force)))||1,i=h=>Math.max(...t.terms.map(u=>Math.abs(u.force[h]))),n=i(2)>i(1)?2:1,r=i(n),a=38/e,o=r>.02*e?a:Math.min(a*20,r?26/r:a),l=h=>va+h/t.state.L*(hc-va),c=Yt("svg",{viewBox:`0 0 ${uc} ${ba}`,role:"img","aria-label":"free body of the member"});c.append(Yt("line",{x1:va,y1:ir,x2:hc,y2:ir,class:"rod"}),...[va,hc].map(h=>Yt("circle",{cx:h,cy:ir,r:4,class:"joint"})),$u(va,ba-24,`end A: ${s.nodes[t.state.A]}`),$u(hc,ba-24,`end B: ${s.nodes[t.state.B]}`),$u(uc/2,ba-7,`plane 1–${n+1}${r>1e-6*e&&o>1.01*a?`, across × ${ye(o/a,2)}`:""}`,"faint"));for(let h of t.drives)c.append(...kb(h,t,l));t.couples.forEach((h,u)=>c.append(...Bb(h,u,l)));for(let h of t.terms)zb(c,l(h.at),h,[h.force[0]*a,-h.force[n]*o]);return c}function kb(s,t,e){let i=t.state.rods[1],n=e(i?i.start:t.state.L/2);return[Yt("rect",{x:n-4,y:ir-7,width:8,height:14,rx:2,fill:"var(--pen-3)"}),...rm(`thrust of ${s.name}: ${$t(s.force,"N")}`,0)]}function Bb(s,t,e){return[Yt("circle",{cx:e(s.at),cy:ir,r:10+3*t,fill:"none",stroke:"var(--pen-3)","stroke-width":3}),...rm(`couple of ${s.words}: ${$t(s.size,"N m")}`,t)]}function rm(s,t){return[Yt("text",{x:uc/2,y:12+12*t,"text-anchor":"middle",fill:"var(--pen-3)"},s)]}function $u(s,t,e,i=""){return Yt("text",{x:s,y:t,"text-anchor":"middle",class:i},e)}function zb(s,t,e,[i,n]){let r=Math.hypot(i,n);if(r<3)return;let a=e.symbol==="F_A"&&i>0||e.symbol==="F_B"&&i<0,o=ir+(e.inertia?10:0),[l,c]=a?[t-i,o-n]:[t,o],[h,u]=[l+i,c+n],d=i/r,f=n/r,p=Math.min(9,r),y=[[h,u],[h-p*d-.4*p*f,u-p*f+.4*p*d],[h-p*d+.4*p*f,u-p*f-.4*p*d]],m=Fb[e.symbol],[g,M]=a?[l-14*d,c-12*f]:[h+14*d,u+12*f];s.append(Yt("line",{x1:l,y1:c,x2:h-.7*p*d,y2:u-.7*p*f,stroke:m,"stroke-width":2.4,"stroke-dasharray":e.inertia?"4 3":"none"}),Yt("polygon",{points:y.map(w=>w.join(",")).join(" "),fill:m}),Yt("text",{x:Math.min(uc-14,Math.max(14,g)),y:Math.min(ba-36,Math.max(11,M+4.5)),"text-anchor":"middle",fill:m},e.symbol))}function am(s,t){let e=Math.max(...t.terms.map(a=>Math.hypot(...a.force))),i=s.dim===3?[0,1,2]:[0,1],[n,r]=zn(t.terms.flatMap(a=>i.map(o=>Math.abs(a.force[o])<1e-6*e?0:a.force[o])),"N");return x("table",{class:"numbers"},x("thead",{},x("tr",{},x("th",{},`force (${r})`),i.map(a=>x("th",{},`along ${a+1}`)))),x("tbody",{},t.terms.map((a,o)=>x("tr",{title:a.words},x("th",{},a.symbol,x("small",{},` ${a.words}`)),i.map(l=>x("td",{},n[o*i.length+l])))),t.couples.map(a=>x("tr",{},x("th",{},"couple ",x("small",{},a.words)),x("td",{colspan:i.length},$t(a.size,"N m")))),t.drives.map(a=>x("tr",{},x("th",{},"drive ",x("small",{},a.name)),x("td",{colspan:i.length},$t(a.force,"N"))))))}function lm(s,t,e,i,n,r){if(s===0)return Math.sqrt(Gb(Math.abs(t),e,i,n,r));if(s===1)return Math.sqrt(Hb(Math.abs(t),Math.abs(e),Math.abs(i),n,r));if(s===2){let a=Math.abs(t)+Math.abs(e)+Math.abs(i);return Math.sqrt(a*a+3*(n*n+r*r))}return NaN}function Gb(s,t,e,i,n){let r=Math.hypot(t,e),a=3*(i*i+n*n);if(r===0||a===0)return(s+r)**2+a;let o=(n*t-i*e)/r,l=(i*t+n*e)/r,c=f=>(s+r*Math.cos(f))**2+3*(o*Math.sin(f)+l*Math.cos(f))**2,h=2*Math.PI/48,u=0,d=0;for(let f=0;f<48;f++)c(f*h)>u&&([u,d]=[c(f*h),f*h]);return Math.max(u,c(Vb(c,d,h)))}function Vb(s,t,e){let i=(Math.sqrt(5)-1)/2,n=t-e,r=t+e;for(let a=0;a<40;a++){let o=r-i*(r-n),l=n+i*(r-n);s(o)>s(l)?r=l:n=o}return(n+r)/2}function Hb(s,t,e,i,n){let r=0;for(let a=0;a<4;a++){let o=a&1,l=a>>1;for(let h=0;h<20;h++)o=om(s+t*l,e,i),l=om(s+e*o,t,n);let c=(i*(1-o*o))**2+(n*(1-l*l))**2;r=Math.max(r,(s+e*o+t*l)**2+3*c)}return r}function om(s,t,e){let i=12*e*e;if(2*t*t>=i)return 1;let n=0;for(let r=0;r<60;r++){let a=i*n**3+(2*t*t-i)*n+2*s*t,o=3*i*n*n+2*t*t-i;if(a<=0)break;if(o>=0||n>=1)return 1;let l=-a/o;if(n+=l,l<1e-12)break}return n>=1?1:(s+t*n)**2+i/4*(1-n*n)**2>(s+t)**2?n:1}var Te=(s,t)=>[s[0]+t[0],s[1]+t[1],s[2]+t[2]],Ee=(s,t)=>[s[0]-t[0],s[1]-t[1],s[2]-t[2]],Gt=(s,t)=>[s*t[0],s*t[1],s*t[2]],Yu=(s,t)=>s[0]*t[0]+s[1]*t[1]+s[2]*t[2],qu=(s,t)=>[s[1]*t[2]-s[2]*t[1],s[2]*t[0]-s[0]*t[2],s[0]*t[1]-s[1]*t[0]],Wb=s=>Gt(1/(Math.hypot(...s)||1),s);function Zu(s,t,e){let i=s.ends[2*e],n=s.ends[2*e+1],r=s.position(t,i),a=Ee(s.position(t,n),r),o=Math.hypot(...a),l=Gt(1/o,a);if(s.dim===2)return{A:i,B:n,L:o,xA:r,axes:[l,[-l[1],l[0],0],[0,0,1]]};let c=s.arrays.orient.data[e],h=c>=0?Ee(s.position(t,c),r):[...s.arrays.reference.data.slice(3*e,3*e+3)],u=qu(l,h);if(Yu(u,u)<=1e-18*Yu(h,h)){let d=[0,1,2].reduce((f,p)=>Math.abs(l[p])<Math.abs(l[f])?p:f,0);u=qu(l,[0,1,2].map(f=>f===d?1:0))}return u=Wb(u),{A:i,B:n,L:o,xA:r,axes:[l,qu(u,l),u]}}function hm(s,t,e){let i=Zu(s,t,e),n=g=>i.axes.map(M=>Yu(M,g)),r=[0,1,2].map(g=>s.header.gravity[g]||0),a=s.vector("acceleration",t,i.A),o=s.vector("acceleration",t,i.B),l=n(Ee(s.vector("velocity",t,i.B),s.vector("velocity",t,i.A))),c=n(Ee(a,r)),h=n(Ee(o,a)),u=i.L,d=[l[1]/u,l[2]/u],f=[-(d[0]**2+d[1]**2),(h[1]-2*l[0]*d[0])/u,(h[2]-2*l[0]*d[1])/u],p=$b(s,e,u),y=Xb(s,t,e,u,n),m=qb(s,t,e,{...i,local:n,b:c,e:h,bend:f,rods:p,actions:y});return{...i,member:e,frame:t,gravity:r,local:n,b:c,e:h,bend:f,rods:p,actions:y,FA:m[0],FB:m[1],derived:m[2]}}function Xb(s,t,e,i,n){return(s.header.actions||[]).flatMap((r,a)=>{if(r.member!==e)return[];let[o,l]=[0,1].map(d=>n(s.actionForce(t,a,d))),c=Te(o,l),h=r.spread?.5:s.number("action_place",t,a),u=Ee(l,Gt(h,c));return[{...r,fA:o,fB:l,force:c,place:h,couple:[0,-i*u[2],i*u[1]],whole:[0,-i*l[2],i*l[1]]}]})}function $b(s,t,e){let i=s.arrays.rods.data,n=6*t,r={mass:i[n],rotary:i[n+2],start:0,length:e,role:"bar",masses:[]};if(!s.active.has(t))return[r];let a=o=>(s.header.clamped||[]).filter(l=>l.rod===o);return[{...r,length:i[n+1],role:"base",masses:a(2*t)},{mass:i[n+3],rotary:i[n+5],start:e-i[n+4],length:i[n+4],role:"tube",masses:a(2*t+1)}]}function Sa({first:s,change:t},e){return Gt(e.mass,Te(s,Gt(e.place,t)))}function fc(s,t){let{b:e,e:i,bend:n}=s;return t.role==="bar"?{first:e,change:i}:t.role==="base"?{first:e,change:Gt(t.length,n)}:{first:Ee(Te(e,i),Gt(t.length,n)),change:Gt(t.length,n)}}function qb(s,t,e,i){if(s.has("joint_force"))return[0,1].map(h=>i.local(s.jointForce(t,e,h))).concat(!1);let n=i.actions.filter(h=>h.mean).reduce((h,u)=>h-u.fA[0]+(1-u.place)*u.force[0],s.number("member_force",t,e)),r=[0,0,0],a=[0,0,0],o=i.rods.map(h=>{let u=fc(i,h),{first:d,change:f}=u,p=h.masses.reduce((g,M)=>Te(g,Sa(u,M)),Gt(h.mass,Te(d,Gt(.5,f))));r=Te(r,p);let y=i.L-h.start,m=Te(Gt(y-h.length/2,d),Gt(y/2-h.length/3,f));a=Te(a,Ee(Gt(h.mass,m),Gt(h.rotary,i.bend)));for(let g of h.masses)a=Te(a,Gt(y-g.place*h.length,Sa(u,g)));return{push:p,change:f,mass:h.mass}}),l=Gt(1/i.L,a);l[0]=i.rods.length===2?o[0].push[0]-n:o[0].mass*(i.b[0]/2+i.e[0]/6)-n;let c=h=>i.actions.reduce((u,d)=>Te(u,d[h]),[0,0,0]);return[Ee(l,c("fA")),Ee(Ee(r,l),c("fB")),!0]}function um(s,t,e){let i=hm(s,t,e),n=i.rods.map((r,a)=>{let{first:o,change:l}=fc(i,r),c=Gt(r.mass,o),h=Gt(r.mass/2,l),u=Gt(-1,i.FA),d=p=>i.actions.filter(y=>y.place===p).reduce((y,m)=>Te(y,m.couple),[0,0,0]),f;if(r.role==="bar")f=Yb(i,r,c,h,u);else if(r.role==="tube")f=cm(i,r,r.masses,Ee(Ee(i.FB,c),h),c,h,d(1),0);else{let p=(i.L-i.rods[1].length)/r.length,y=u,m=Gt(-1,d(0));f=[];for(let M of r.masses.filter(w=>w.place<p)){let w=M.place,b=Sa({first:o,change:l},M);w>0&&f.push(wa(y,c,h,r,i.bend,m,!1,w)),y=Te(y,b),m=Te(m,[0,-r.length*b[2]*w,r.length*b[1]*w])}f.push({...wa(y,c,h,r,i.bend,m,!1,p),nut:!0});let g=r.masses.filter(M=>M.place>=p);f.push(...cm(i,r,g,Ee(Gt(-1,c),h),c,h,[0,0,0],p))}return{part:s.partsOf[e][a],...r,pieces:f}});return n.length===2&&Jb(i,n),{state:i,parts:n}}function cm(s,t,e,i,n,r,a,o){let l=fc(s,t),c=[],h=(u,d)=>[0,t.length*u[2]*(1-d),-t.length*u[1]*(1-d)];for(let u of e){let d=Sa(l,u);i=Ee(i,d),a=Ee(a,h(d,u.place))}for(let u of e){let d=u.place,f=Sa(l,u);d>o&&c.push(wa(i,n,r,t,s.bend,a,!0,d)),i=Te(i,f),a=Te(a,h(f,d))}return c.push(wa(i,n,r,t,s.bend,a,!0,2)),c}function Yb(s,t,e,i,n){let r=s.actions.flatMap(({spread:o,place:l})=>o?[o.begin,o.end]:[l]),a=[...new Set(r.filter(o=>o>0&&o<1))].sort((o,l)=>o-l);return[...a,2].map((o,l)=>{let c=l?a[l-1]:0,h=wa(n,e,i,t,s.bend,[0,0,0],!1,o);for(let u of s.actions)u.spread?u.spread.end<=c?Ma(h,t,Kb(u)):u.spread.begin<=c&&Ma(h,t,dc(u,0,1)):u.place<=c&&u.place<1&&Ma(h,t,Zb(u));return h})}var Zb=({force:s,place:t,couple:e})=>({D:[s],P:[Gt(-t,s),s],C:[e]});function jb({spread:{begin:s,end:t,ratio:e},fA:i,fB:n,force:r}){let a=t-s;if(e)return[Gt((e[0]-(e[1]-e[0])*s/a)/a,r),Gt((e[1]-e[0])/(a*a),r)];let o=Gt(1/a,Ee(n,Gt(s,r))),l=Ee(Gt(4,r),Gt(6,o)),c=Ee(Gt(12,o),Gt(6,r));return[Gt(1/a,Ee(l,Gt(s/a,c))),Gt(1/(a*a),c)]}function dc(s,t,e){let{begin:i,couple:n}=s.spread,r=Math.max(i,t),a=(r-t)/e,[o,l]=jb(n?{...s,force:s.whole}:s),c=d=>Te(Gt(d,o),Gt(d*d/2,l)),h=[Ee(c(t),c(r)),Te(Gt(e,o),Gt(e*t,l)),Gt(e*e/2,l)];if(n)return{D:[],P:[],C:h};let u=[[0,0,0],h[0],Gt(1/2,h[1]),Gt(1/3,h[2])];return u[0]=Gt(-1,u.reduce((d,f,p)=>Te(d,Gt(a**p,f)),[0,0,0])),{D:h,P:u,C:[]}}function Kb(s){if(s.spread.couple)return{D:[],P:[],C:[s.whole]};let{P:t}=dc(s,0,1),e=s.spread.end,i=t.reduce((n,r,a)=>Te(n,Gt(e**a,r)),[0,0,0]);return{D:[s.force],P:[Ee(i,Gt(e,s.force)),s.force],C:[]}}function Ma(s,t,{D:e,P:i,C:n}){e.forEach((r,a)=>s.S[a]=Ee(s.S[a],r)),i.forEach((r,a)=>{s.M[0][a]-=t.length*r[2],s.M[1][a]+=t.length*r[1]}),n.forEach((r,a)=>[1,2].forEach(o=>s.M[o-1][a]-=r[o]))}function Jb(s,t){for(let e of s.actions.filter(({spread:i})=>i)){let[i,n]=t,r=Math.max(0,n.start/s.L);for(let u of i.pieces)if(Ma(u,i,dc(e,0,i.length/s.L)),u.nut)break;let{D:a,P:o}=dc(e,r,n.length/s.L),[l,c]=[a,o].map(u=>u.reduce((d,f)=>Te(d,f),[0,0,0])),h={D:[Ee(a[0],l),...a.slice(1)],P:o.map((u,d)=>Te(u,d===0?Ee(l,c):d===1?Gt(-1,l):[0,0,0])),C:[]};for(let u of n.pieces)Ma(u,n,h)}}function wa(s,t,e,i,n,r,a,o){let l=i.length,c=[r[1],l*s[2]-i.rotary*n[2],l*t[2]/2,l*e[2]/3],h=[r[2],i.rotary*n[1]-l*s[1],-l*t[1]/2,-l*e[1]/3];return a&&(c[0]-=c[1]+c[2]+c[3],h[0]-=h[1]+h[2]+h[3]),{S:[s,t,e],M:[c,h],end:o}}function dm(s,t,e){let{S:i,M:n}=t.pieces.find(d=>e<=d.end),[r,a,o]=[0,1,2].map(d=>i[0][d]+e*(i[1][d]+e*i[2][d])),[l,c]=n.map(d=>d[0]+e*(d[1]+e*(d[2]+e*d[3]))),h=s.arrays.part_scale.data.slice(4*t.part,4*t.part+4),u=s.arrays.part_shape.data[t.part];return{T:r,V2:a,V3:o,M2:l,M3:c,stress:lm(u,r*h[0],l*h[1],c*h[2],a*h[3],o*h[3])}}function pc(s,t,e){let i=hm(s,t,e),n=i.local(i.gravity),r=[0,0,0],a=[0,0,0],o=0,l=0;for(let p of i.rods){let y=fc(i,p);for(let{mass:m,place:g}of[{mass:p.mass,place:.5},...p.masses])r=Te(r,Gt(m,n)),a=Te(a,Gt(m,Te(Te(y.first,Gt(g,y.change)),n))),o+=m*(p.start+g*p.length),l+=m}let c=l>0?o/l:i.L/2,h=[{symbol:"F_A",words:`joint ${s.nodes[i.A]} on it`,force:i.FA,at:0},{symbol:"F_B",words:`joint ${s.nodes[i.B]} on it`,force:i.FB,at:i.L},{symbol:"m g",words:"weight",force:r,at:c},{symbol:"m a",words:"inertia: what they sum to",force:a,at:c,inertia:!0}],u=Math.max(...i.FA.map(Math.abs),...i.FB.map(Math.abs),1e-30),d=i.actions.filter(p=>Math.max(...p.force.map(Math.abs))>1e-6*u);h.splice(2,0,...d.map(p=>({symbol:Qb[p.kind],words:`${p.kind} ${p.source}`,force:p.force,at:p.place*i.L})));let f=i.actions.filter(p=>Math.hypot(...p.couple)>1e-6*u*i.L).map(p=>({words:`${p.kind} ${p.source}`,at:p.place*i.L,couple:p.couple,size:s.dim===2?p.couple[2]:Math.hypot(...p.couple)}));return{state:i,mass:l,centre:c,terms:h,couples:f,drives:ju(s,t,e).filter(p=>p.unit==="m")}}var Qb={drive:"T",coupling:"Q",load:"P",body:"B",friction:"C",spring:"K",bearing:"C",hub:"H",couple:"C",hinge:"C"};function ju(s,t,e){return pm(s,t,i=>i.member===e)}function fm(s,t,e){return pm(s,t,i=>i.node===e||i.axis?.includes?.(e)===!0)}function pm(s,t,e){return s.header.drives.flatMap((i,n)=>{if(!e(i))return[];let r=a=>s.has(a)?s.number(a,t,n):NaN;return[{...i,position:r("drive_position"),force:r("drive_force")}]})}var vi={left:52,right:10,top:18,bottom:18},mm=Object.fromEntries(Object.entries(Xe).map(([s,t])=>[s,[1,2,3].map(e=>t[`pen-${e}`])]));function fn(s,t,e={}){let i=window.devicePixelRatio||1,n=s.clientWidth||300,r=s.clientHeight||110;s.width=Math.round(n*i),s.height=Math.round(r*i);let a=s.getContext("2d");a.scale(i,i);let o=getComputedStyle(s),l=o.color,c=o.getPropertyValue("--line").trim()||"#ccc",h=o.getPropertyValue("--dark").trim()==="1"?"dark":"light",u=tM(t,e,n,r);a.font="11px system-ui, sans-serif",eM(a,u,e,l,c),t.forEach((d,f)=>iM(a,u,d,mm[h][f%3],e.fill)),Number.isFinite(e.limit)&&sM(a,u,e.limit,h==="dark"?Xe.dark.alarm:_n),e.cursor!==void 0&&rM(a,u,e.cursor,l),aM(a,u,t,mm[h],l)}function tM(s,t,e,i){let[n,r,a,o]=[1/0,-1/0,0,0];for(let{x:p,y}of s)for(let m=0;m<p.length;m++)p[m]<n&&(n=p[m]),p[m]>r&&(r=p[m]),y[m]<a&&Number.isFinite(y[m])&&(a=y[m]),y[m]>o&&Number.isFinite(y[m])&&(o=y[m]);let l=Math.max(Math.abs(a),Math.abs(o));Number.isFinite(t.limit)&&t.limit<2.5*l&&(o=Math.max(o,t.limit)),(o-a<1e-12*(l||1)||a===o)&&([a,o]=[Math.min(a,-1e-9),Math.max(o,1e-9)]);let c=.06*(o-a);a<0&&(a-=c),o>0&&(o+=c);let[h,u]=hs(l,t.unit||""),d=e-vi.left-vi.right,f=i-vi.top-vi.bottom;return{x0:n,x1:r,y0:a,y1:o,largest:l,factor:h,unit:u,width:e,height:i,x:p=>vi.left+(p-n)/(r-n||1)*d,y:p=>vi.top+(1-(p-a)/(o-a))*f}}function eM(s,t,e,i,n){s.strokeStyle=n,s.fillStyle=i,s.lineWidth=1;let[r,a]=[vi.left,t.width-vi.right];s.textAlign="right",s.textBaseline="middle";let{factor:o}=t;for(let h of t.largest?fh(t.y0*o,t.y1*o,4):[0]){let u=Math.round(t.y(h/o))+.5;s.beginPath(),s.moveTo(r,u),s.lineTo(a,u),s.stroke(),s.fillText(ye(h),r-5,u)}s.textBaseline="alphabetic",s.textAlign="center";let l=` ${e.xUnit||"s"}`,c=s.measureText(l).width;for(let h of fh(t.x0,t.x1,5)){let u=ye(h),d=s.measureText(u).width/2,f=Math.min(Math.max(t.x(h),r+d),a-d);(f+d<a-c||h===0)&&s.fillText(u,f,t.height-4)}s.textAlign="right",s.fillText(l,a,t.height-4),s.textAlign="left",s.fillText(`${e.title||""}${t.unit?` (${t.unit})`:""}`,r,11)}function iM(s,t,e,i,n){let{x:r,y:a}=e;s.strokeStyle=s.fillStyle=i,s.lineWidth=1.6,s.setLineDash(e.dashed?[5,3]:[]);for(let[o,l]of nM(a)){s.beginPath();for(let c=o;c<=l;c++)s[c>o?"lineTo":"moveTo"](t.x(r[c]),t.y(a[c]));s.stroke(),n&&(s.lineTo(t.x(r[l]),t.y(0)),s.lineTo(t.x(r[o]),t.y(0)),s.globalAlpha=.12,s.fill(),s.globalAlpha=1)}s.setLineDash([])}function nM(s){let t=[];for(let e=0;e<s.length;e++){if(!Number.isFinite(s[e]))continue;t.length&&t[t.length-1][1]===e-1?t[t.length-1][1]=e:t.push([e,e])}return t}function sM(s,t,e,i){e>t.y1||(s.strokeStyle=i,s.setLineDash([4,3]),s.beginPath(),s.moveTo(vi.left,t.y(e)),s.lineTo(t.width-vi.right,t.y(e)),s.stroke(),s.setLineDash([]))}function rM(s,t,e,i){s.strokeStyle=i,s.globalAlpha=.6,s.beginPath(),s.moveTo(t.x(e),vi.top),s.lineTo(t.x(e),t.height-vi.bottom),s.stroke(),s.globalAlpha=1}function aM(s,t,e,i,n){let r=t.width-vi.right;s.textAlign="right";for(let a=e.length-1;a>=0;a--){let{label:o}=e[a];o&&(s.fillStyle=n,s.fillText(o,r,11),r-=s.measureText(o).width+4,s.fillStyle=i[a%i.length],s.fillRect(r-12,6,12,3),r-=20)}}var gm=41,oM=12,lM=new Set(["stress"]),cM=[["Axial force T","N",[[0,""]]],["Shear V","N",[[1,""]]],["Bending moment M","N m",[[2,""]]],["von Mises stress","Pa",[[3,""]]]],hM=[["Axial force T","N",[[0,""]]],["Shear V","N",[[1,"V2"],[2,"V3"]]],["Bending moment M","N m",[[3,"M2"],[4,"M3"]]],["Torsion","N m",[[5,""]]],["von Mises stress","Pa",[[6,""]]]],mc=class{constructor(t){this.app=t,this.node=x("section",{class:"inspector","aria-label":"what is picked"})}show(){let{picked:t}=this.app;if(this.updates=[],!t){let e=this.app.views.some(({scene:r})=>r.members.length),i=(e?["N","P"]:["Shift N","Shift P"]).map(r=>x("kbd",{},r)),n=`${this.app.touch?"Tap":"Pick"} ${e?"a member or node in the picture or the table":"a node in the picture"}`;ce(this.node,x("p",{class:"faint"},n,this.app.touch?".":["; or step through them with ",i[0]," and ",i[1],"."]),e?null:this.overview(),this.app.views.map((r,a)=>this.measured(r,a))),this.update();return}ce(this.node,x("div",{class:"views"},this.app.views.map((e,i)=>this.column(e,i,t)))),this.update()}overview(){let t=this.app.views.flatMap(({scene:e})=>{let{skins:i=[],pressures:n,loads:r}=e.header,a=i.map(l=>[`${l.kind[0].toUpperCase()}${l.kind.slice(1)}`,l.name]);a.push(["Nodes",e.nodes.length],["Faces",e.faces]),n&&a.push(["Pressure",`${n.least===n.largest?"":`${$t(n.least,"Pa")} to `}${$t(n.largest,"Pa")} on ${n.count} ${n.count===1?"face":"faces"}`]);let o=r.filter(l=>!l.pressure&&!l.at).length;return o&&a.push(["Nodal loads",o]),a});return x("table",{class:"values"},t.map(([e,i])=>x("tr",{},x("th",{},e),x("td",{},i))))}measured(t,e){let{scene:i}=t,n=i.header.quantities||[];if(!n.length)return null;let r=({limits:c},h)=>c&&(c[0]!==null&&h<c[0]||c[1]!==null&&h>c[1]),a=this.values(()=>n.map((c,h)=>{let u=i.number("quantity",t.frame,h);return[c.name,$t(u,c.unit),r(c,u)?"beyond its limit":c.words]})),o=i.frames<2?[]:n.slice(0,oM).map((c,h)=>{let u=x("canvas",{class:"plot",role:"img","aria-label":`${c.name} over time`}),d=Array.from(i.time,(f,p)=>i.number("quantity",p,h));return this.updates.push(()=>fn(u,[{x:i.time,y:d,label:""}],{title:c.name,unit:c.unit,cursor:i.time[t.frame]})),u}),l=this.app.views.length>1;return x("div",{class:"subject"},x("h2",{},"Quantities",l?x("small",{},` ${this.app.labels[e]}`):null),a,...o)}update(){for(let t of this.updates||[])t()}column(t,e,i){let{scene:n}=t,r=this.app.indexIn(t,i),o=this.app.views.length>1?x("h3",{},this.app.labels[e]):null;if(r<0)return x("div",{},o,x("p",{class:"faint"},`no ${i.type} called ${i.name} here`));let l=i.type==="member"?this.member(t,r):this.atNode(t,r);return x("div",{class:"subject"},o,...l)}member(t,e){let{scene:i}=t,[n,r]=[i.ends[2*e],i.ends[2*e+1]],a=i.header.kinds[e],l=[x("h2",{},i.members[e],x("small",{},` ${a}${a==="cable"?"":" member"}, `,this.link(t,n)," → ",this.link(t,r))),this.values(()=>this.memberValues(t,e)),this.history(t,e),...this.driveHistories(t,e)];return i.has("member_force")&&((i.header.beams||[]).includes(e)?l.push(...this.beam(t,e)):i.header.bodies.some(c=>c.member===e)||l.push(...this.mechanics(t,e))),l}link(t,e){let i=t.scene.nodes[e];return x("button",{class:"link",type:"button",onclick:()=>this.app.pick({type:"node",name:i})},i)}values(t){let e=x("table",{class:"values"});return this.updates.push(()=>ce(e,t().map(([i,n,r])=>x("tr",{},x("th",{},i),x("td",{},n,r?x("small",{},` ${r}`):null))))),e}memberValues(t,e){let{scene:i,frame:n}=t,r=i.header.channels.map(l=>{let c=i.plainValue(l.id,n,e),h=l.id==="force"&&c?c>0?"tension":"compression":"";return[l.label,La(l,c),l.over_run?"worst of the run":h]}),a=i.header.bodies.find(l=>l.member===e);a&&r.push(["Body",$t(a.mass,"kg")]),r.push(["Length",$t(i.length(n,e),"m",6)]),r.push(...fM(i,n,e)),r.push(...ym(ju(i,n,e)));let o=i.header.not_checked?.[i.members[e]];return o&&r.push(["Not checked",o]),i.unsure.has(e)&&r.push(["Note","this force is not unique: a share by stiffness or convention"]),r}history(t,e){let{scene:i}=t;if(i.frames<2)return null;let n=x("canvas",{class:"plot",role:"img","aria-label":"history"});return this.updates.push(()=>{let r=i.channel(this.app.channel?.id)||i.header.channels[0],a=Array.from(i.time,(h,u)=>i.value(r.id,u,e)),o=lM.has(r.id)?xm(i,e):["capacity","margin"].includes(r.scale)?1:void 0,l=r.scale==="margin"?"Buckling: compression over allowed":r.label,c=[{x:i.time,y:a,label:""}];if(r.id==="force"&&i.has("rest_force")){let h=Array.from(i.time,(u,d)=>i.number("rest_force",d,e));c.push({x:i.time,y:h,label:"at rest",dashed:!0})}fn(n,c,{title:l,unit:r.unit,cursor:i.time[t.frame],limit:o})}),n}driveHistories(t,e){let{scene:i}=t;return i.frames<2||!i.has("drive_force")?[]:i.header.drives.flatMap((n,r)=>{let a=Array.from(i.time,(c,h)=>i.number("drive_force",h,r));if(n.member!==e||!a.some(Number.isFinite))return[];let o=n.unit==="rad",l=x("canvas",{class:"plot",role:"img","aria-label":`drive ${n.name} over time`});return this.updates.push(()=>fn(l,[{x:i.time,y:a,label:""}],{title:`${o?"Torque":"Force"} of drive ${n.name}`,unit:o?"N m":"N",cursor:i.time[t.frame]})),[l]})}beam(t,e){let{scene:i}=t,n=i.arrays.beam_section,r=i.curves.row.get(e);if(!n||r===void 0)return[x("p",{class:"faint"},r===void 0?"Section forces of rigid beams are not computed.":"Section forces of beams: kt.strength.beams.")];let[,a,o,l]=n.shape,c=i.length(0,e),h=Array.from({length:o},(p,y)=>y*c/(o-1)),u=p=>h.map((y,m)=>n.data[((t.frame*a+r)*o+m)*l+p]),f=(i.dim===2?cM:hM).map(p=>[x("canvas",{class:"plot small",role:"img","aria-label":p[0]}),...p]);return this.updates.push(()=>{for(let[p,y,m,g]of f){let M=g.map(([w,b])=>({x:h,y:u(w),label:b}));fn(p,M,{title:y,unit:m,xUnit:"m from A",fill:!0})}}),[x("h4",{},"Along it, now"),...f.map(([p])=>p)]}mechanics(t,e){let{scene:i}=t,n=x("div",{class:"freebody"}),r=x("div");this.updates.push(()=>{let l=pc(i,t.frame,e);ce(n,sm(i,l)),ce(r,am(i,l))});let a=i.dim===3,o=[["Axial force T","N",[["T",""]]],["Shear V","N",a?[["V2","V2"],["V3","V3"]]:[["V2",""]]],["Bending moment M","N m",a?[["M2","M2"],["M3","M3"]]:[["M3",""]]],["von Mises stress","Pa",[["stress",""]]]].map(l=>[x("canvas",{class:"plot small",role:"img","aria-label":l[0]}),...l]);return this.updates.push(()=>{let l=Ku(i,t.frame,e);for(let[c,h,u,d]of o){let f=d.map(([y,m])=>({x:l.s,y:l[y],label:m})),p=uM(d)==="stress"?xm(i,e):void 0;fn(c,f,{title:h,unit:u,xUnit:"m from A",fill:!0,limit:p})}}),[x("h4",{},"Cut free, now"),n,r,x("h4",{},"Along it, now"),...o.map(([l])=>l)]}atNode(t,e){let{scene:i}=t,n=x("h2",{},i.nodes[e],x("small",{}," node")),r=i.members.flatMap((c,h)=>i.ends[2*h]===e||i.ends[2*h+1]===e?[h]:[]),a=x("p",{},"joins ",r.slice(0,24).flatMap(c=>[x("button",{class:"link",type:"button",onclick:()=>this.app.pick({type:"member",name:i.members[c]})},i.members[c])," "])),o=Ua(this.app.hint("Path","T"),"Path of this node along the run",!1,()=>this.app.toggleTrace());o.classList.add("trace"),this.updates.push(()=>Oi(o,this.app.paths.has(i.nodes[e])));let l=[n,a,this.values(()=>dM(i,t.frame,e))];return i.frames>1&&l.push(o,this.nodeHistory(t,e)),l}nodeHistory(t,e){let{scene:i}=t,n=x("canvas",{class:"plot",role:"img","aria-label":"history"}),r=i.position(0,e),a="xyz".slice(0,i.dim).split("").map((o,l)=>({x:i.time,label:o,y:Array.from(i.time,(c,h)=>i.position(h,e)[l]-r[l])}));return this.updates.push(()=>fn(n,a,{title:"Moved from the start",unit:"m",cursor:i.time[t.frame]})),n}},uM=s=>s[0][0];function xm(s,t){return Math.min(...s.partsOf[t].map(e=>s.arrays.part_allowed.data[e]))}function dM(s,t,e){let i="xyz".slice(0,s.dim).split(""),n=(c,h)=>{let u=Math.max(...c.map(Math.abs)),[d,f]=zn(i.map((p,y)=>Math.abs(c[y])>1e-9*u?c[y]:0),h);return`${d.map(p=>p.trim()).join(", ")} ${f}`},r=[["Position",n(s.position(t,e),"m")]];if(s.has("velocity")){let c=s.vector("velocity",t,e),h=s.vector("acceleration",t,e);r.push(["Speed",$t(Math.hypot(...c),"m/s")],["Velocity",n(c,"m/s")],["Acceleration",n(h,"m/s²")])}let a=s.arrays.lump.data[e];a&&r.push(["Lumped mass",$t(a,"kg")]);let o=s.header.supports.find(c=>c.node===e);o&&r.push(o.words?["Support",o.words]:["Held in",[...o.axes].join(", ")]);let l=s.header.supported?.indexOf(s.nodes[e])??-1;return l>=0&&r.push(["Reaction",n(s.vector("reaction",t,l),"N")]),s.header.loads.forEach((c,h)=>{c.node===e&&r.push([`Load ${c.name}`,n(s.vector("load_force",t,h),"N")])}),r.push(...ym(fm(s,t,e))),r}function fM(s,t,e){return s.header.loads.flatMap((i,n)=>{if(i.member!==e||i.words===!1)return[];let r=Math.hypot(...s.vector("load_force",t,n));return[[`Load ${i.name}`,i.span?$t(r/i.span,"N/m"):$t(r,"N")]]})}function ym(s){return s.filter(t=>!Number.isNaN(t.position)).map(t=>{let e=t.unit==="rad";return[`Drive ${t.name}`,$t(t.position,t.unit,6),Number.isNaN(t.force)?"":`drive ${e?"torque":"force"} ${$t(t.force,e?"N m":"N")}`]})}function Ku(s,t,e){let i={s:[],T:[],V2:[],V3:[],M2:[],M3:[],stress:[],parts:[]};for(let n of um(s,t,e).parts){i.s.length&&_m(i,n.start,{T:NaN,V2:NaN,V3:NaN,M2:NaN,M3:NaN,stress:NaN},"");for(let r=0;r<gm;r++){let a=r/(gm-1);_m(i,n.start+a*n.length,dm(s,n,a),s.header.parts[n.part])}}return i}function _m(s,t,e,i){s.s.push(t),s.parts.push(i);for(let[n,r]of Object.entries(e))s[n].push(r)}var vm=[["Time",[[" ","play or pause",s=>s.togglePlay(),"space"],["ArrowRight","one sample on (Shift: ten)",(s,t)=>s.step(t.shiftKey?10:1),"→"],["ArrowLeft","one sample back (Shift: ten)",(s,t)=>s.step(t.shiftKey?-10:-1),"←"],["Home","to the start",s=>s.goTo(0)],["End","to the end",s=>s.goTo(s.lead.frames-1)],["+","faster",s=>s.faster(1)],["-","slower",s=>s.faster(-1)],["x","to the worst sample of what colours",s=>s.toWorst()]]],["What is shown",[["c","next colour (Shift: previous)",(s,t)=>s.nextChannel(t.shiftKey?-1:1)],["e","next load case",s=>s.nextCase()],["m","next mode or mechanism",s=>s.nextMode()],["g","start pose as a ghost",s=>s.toggle("ghost")],["y","paths of all nodes that move",s=>s.toggle("paths")],["l","loads",s=>s.toggle("loads")],["b","supports",s=>s.toggle("supports")],["r","faces of rigid bars",s=>s.toggle("faces")],["h","ground grid",s=>s.toggle("grid")],["a","names",s=>s.toggle("names")],["v","panel beside the picture",s=>s.togglePanel()],["d","dark or light",s=>s.toggleTheme()]]],["Picking",[["n","next member (Shift: next node)",(s,t)=>s.pickNext(t.shiftKey?"node":"member",1)],["p","previous member (Shift: node)",(s,t)=>s.pickNext(t.shiftKey?"node":"member",-1)],["w","the worst member now",s=>s.pickWorst()],["t","path of the picked node",s=>s.toggleTrace()],["/","find by name",s=>s.find()],["Escape","nothing picked",s=>s.escape(),"Esc"]]],["Camera",[["1","from a corner",s=>s.aim("corner")],["2","from the front (along y)",s=>s.aim("front")],["3","from the side (along x)",s=>s.aim("side")],["4","from above (the x-y plane)",s=>s.aim("plane")],["f","fit",s=>s.aim(s.views[0].preset)],["i","turn up",s=>s.orbit(0,.12,1)],["k","turn down",s=>s.orbit(0,-.12,1)],["j","turn left",s=>s.orbit(-.12,0,1)],["o","turn right",s=>s.orbit(.12,0,1)],[",","nearer",s=>s.orbit(0,0,.9)],[".","farther",s=>s.orbit(0,0,1.1)],["?","this page",s=>s.toggleHelp()]]]],pM=new Set([..."1234ikjo"]),mM=new Set(["text","search","number"]);function bm(s,t,e){let i=new Map(vm.flatMap(([,r])=>r.map(([a,,o])=>[a,o])));t.addEventListener("keydown",r=>{if(r.ctrlKey||r.metaKey||r.altKey||r.defaultPrevented)return;let a=r.target;if(r.key!=="Escape"&&a.closest?.(".controls"))return;if(a.tagName==="INPUT"&&mM.has(a.type)){r.key==="Enter"&&s.table.pickFirst(),(r.key==="Escape"||r.key==="Enter")&&a.blur();return}if(a.tagName==="BUTTON"&&(r.key===" "||r.key==="Enter")||a.tagName==="SELECT")return;let l=r.key.length===1?r.key.toLowerCase():r.key,c=i.get(l);c&&(r.preventDefault(),c(s,r))},{signal:e});let n=!1;t.addEventListener("pointerdown",()=>n=!0,{signal:e}),t.addEventListener("keydown",()=>n=!1,{capture:!0,signal:e}),t.addEventListener("change",r=>{n&&r.target.tagName==="SELECT"&&r.target.blur()},{signal:e})}function Mm(s){let t=s.views[0].scene.dim===2,i=vm.map(([l,c])=>[l,c.filter(([h])=>!t||!pM.has(h))]).map(([l,c])=>x("div",{},x("h3",{},l),x("dl",{},c.map(([h,u,,d])=>[x("dt",{},x("kbd",{},d||h.toUpperCase())),x("dd",{},u)]).flat()))),n=x("button",{type:"button",onclick:()=>s.toggleHelp()},s.hint("Close","Esc")),a=`Bars thinner than a hundredth of the usual length are drawn thicker, to be seen. Green: what moves by itself (collars at the screw, rings at motors). Cones: supports. Violet arrows: loads. Striped: not checked, or a force that is not unique. ${s.touch?`${t?"Drag to shift, two fingers to approach":"Drag to turn, two fingers to shift and approach"}, tap to pick.`:`${t?"Drag to shift":"Drag to turn, right-drag to shift"}, wheel to approach, click to pick.`}`,o=l=>{l.key==="Tab"&&(l.preventDefault(),n.focus())};return x("div",{class:"help",role:"dialog","aria-modal":"true","aria-label":s.touch?"help":"keys",hidden:!0,onkeydown:o},x("div",{class:"sheet"},s.touch?x("h2",{},"Help"):[x("h2",{},"Keys"),x("div",{class:"columns"},i)],x("p",{},a),n))}var gM={rigid:"rigid bar",driven:"driven bar",active:"active member: base and tube",elastic:"elastic bar",beam:"elastic beam",cable:"cable: tension only",free:"free sensor"},xM={membrane:"membrane",solid:"surface of a solid"},xc=class{constructor(t){this.app=t,this.node=x("div",{class:"legend",role:"note","aria-live":"polite"})}show(){let{channel:t,limits:e}=this.app;if(!t){let l=[...this.kinds().map(([c,h])=>gc(hi[c],h)),...this.skins(),...this.motors()];this.node.hidden=!l.length,ce(this.node,x("b",{},"Kinds of members"),l);return}this.node.hidden=!1;let[i,n]=hs(e[1],t.unit),r=`${t.label}${n?` (${n})`:""}`,a=_M(t,e).map(l=>x("span",{},yM(t,l,i))),o=[x("b",{},r),x("div",{class:"bar",style:`background:${Da(t.scale)}`}),x("div",{class:"ticks"},a),x("div",{class:"words"},x("span",{},t.low),x("span",{},this.high(t)))];t.over_run&&o.push(x("small",{},"worst of the whole run")),this.over(t)&&o.push(gc(_n,t.scale==="margin"?"buckles (margin below 0)":"over capacity (above 100 %)")),this.missing(t)&&o.push(Sm("var(--missing)",Ui(t)?"not checked":"not known")),t.id!=="speed"&&this.app.views.some(({scene:l})=>l.unsure.size)&&o.push(Sm("var(--faint)","the force is not unique")),this.app.views.some(({scene:l})=>l.coloursFaces(t.id))||o.push(...this.skins()),ce(this.node,o)}high(t){if(t.high!=="largest of the run")return t.high;let e=this.app.views.map(({scene:i})=>i).filter(i=>i.channel(t.id));return`largest ${this.app.lead.frames>1?"of the run ":""}${$t(Math.max(...e.map(i=>i.range(t.id)[1])),t.unit)}`}kinds(){let t=new Set(this.app.views.flatMap(e=>e.scene.header.kinds));return Object.entries(gM).filter(([e])=>t.has(e))}motors(){return this.app.views.some(({scene:e})=>e.header.drives.some(i=>i.kind==="angle"||i.kind==="hinge"))?[gc(hi.driven,"ring: motor about its axis")]:[]}skins(){let t=new Set(this.app.views.flatMap(e=>e.scene.header.skins?.map(i=>i.kind)||[]));return Object.entries(xM).filter(([e])=>t.has(e)).map(([e,i])=>gc(Ia[e],i))}over(t){return Ui(t)&&this.app.views.some(({scene:e})=>e.channel(t.id)&&e.range(t.id)[1]>1)}missing(t){return this.app.views.some(({scene:e,frame:i})=>e.members.some((n,r)=>Number.isNaN(e.value(t.id,i,r))))}};function gc(s,t){return x("div",{class:"swatch"},x("i",{style:`background:${s}`}),t)}function Sm(s,t){return x("div",{class:"swatch"},x("i",{style:`background:repeating-linear-gradient(135deg, ${s} 0 4px, var(--card) 4px 7px)`}),t)}function _M(s,[t,e]){return s.scale==="diverging"?[t,t/2,0,e/2,e]:[0,.25,.5,.75,1].map(i=>t+i*(e-t))}function yM(s,t,e){return s.scale==="margin"?t<=0?"∞":ye(1/t-1,2):ye(t*e,3)}var vM=400,_c=48,Ju=5,Qu=2,bM=[[1,-1],[1,1],[-1,-1],[-1,1],[0,-1],[0,1],[1,0],[-1,0]],MM=[.5,.4,.6,.3,.7,.2,.8],yc=class{constructor(t){this.view=t,this.node=x("div",{class:"names","aria-hidden":!0})}place(t){if(this.node.hidden=!t||this.view.scene.members.length>vM,this.node.hidden)return;let{scene:e,now:i}=this.view;this.tags??=this.made();let n=i.map(o=>this.view.project(o)),r=this.node.getBoundingClientRect(),a=new td(r.width,r.height);for(let o of this.node.closest(".stage")?.querySelectorAll(".legend")||[])a.add(TM(o,r));for(let{tag:o,type:l,index:c}of this.order()){let h=l==="node"?SM(n[c],o):wM(this.view.along(c,n),o),u=[o.place??0,...h.keys()].find(d=>d<h.length&&a.free(h[d]));o.node.style.visibility=u===void 0?"hidden":"visible",u!==void 0&&(o.place=u,a.add(h[u]),o.node.style.transform=`translate(${(h[u][0]+Qu).toFixed(1)}px, ${h[u][1].toFixed(1)}px)`)}}made(){let{scene:t}=this.view,e=[...t.nodes.map((i,n)=>x("span",{class:"of-node",hidden:t.directors.has(n)},i)),...t.members.map((i,n)=>x("span",{hidden:!t.shows(n)},i))];return ce(this.node,e),e.map(i=>({node:i,width:i.offsetWidth,height:i.offsetHeight}))}order(){let{scene:t,picked:e}=this.view,i=t.nodes.length,n=this.tags.map((a,o)=>o<i?{tag:a,type:"node",index:o}:{tag:a,type:"member",index:o-i});return[...e?n.splice((e.type==="node"?0:i)+e.index,1):[],...n].filter(({tag:a})=>!a.node.hidden)}};function SM([s,t],{width:e,height:i}){return bM.map(([n,r])=>wm(s+n*(e/2+Ju),t+r*(i/2+Ju-1),e,i))}function wM(s,{width:t,height:e}){let i=Math.floor(s.length/3),n=s[i],r=s[s.length-1-i],[a,o]=[r[0]-n[0],r[1]-n[1]],l=Math.hypot(a,o)||1,c=[o/l,-a/l],h=(Math.abs(c[0])*t+Math.abs(c[1])*e)/2+Ju-1;return MM.flatMap(u=>[1,-1].map(d=>wm(n[0]+u*a+d*h*c[0],n[1]+u*o+d*h*c[1],t,e)))}function wm(s,t,e,i){return[s-e/2-Qu,t-i/2,s+e/2+Qu,t+i/2]}function TM(s,t){let e=s.getBoundingClientRect();return[e.left-t.left,e.top-t.top,e.right-t.left,e.bottom-t.top]}var td=class{constructor(t,e){Object.assign(this,{width:t,height:e,cells:new Map})}squares([t,e,i,n]){let r=[];for(let a=Math.floor(t/_c);a<=Math.floor(i/_c);a++)for(let o=Math.floor(e/_c);o<=Math.floor(n/_c);o++)r.push(1e5*a+o);return r}free(t){return t[0]<0||t[1]<0||t[2]>this.width||t[3]>this.height?!1:this.squares(t).every(e=>(this.cells.get(e)||[]).every(i=>i[2]<=t[0]||i[0]>=t[2]||i[3]<=t[1]||i[1]>=t[3]))}add(t){for(let e of this.squares(t))this.cells.has(e)?this.cells.get(e).push(t):this.cells.set(e,[t])}};var ed=150,vc=class{constructor(t){this.app=t,this.order={id:"name",down:!0},this.filter=x("input",{type:"search",placeholder:"find by name","aria-label":"find members by name",oninput:()=>this.show()}),this.head=x("thead"),this.body=x("tbody"),this.note=x("p",{class:"faint"}),this.node=x("section",{class:"table","aria-label":"values of all members now"},this.filter,x("div",{class:"scroll"},x("table",{class:"numbers"},this.head,this.body)),this.note)}columns(){let{scene:t}=this.app.views[0],e=t.header.channels.filter(a=>a.id!=="speed"||t.header.channels.length===1),i=this.app.views;e.length||e.push({id:"length",label:"Length",unit:"m"});let n=i.length>1?e.filter(a=>a.id===this.app.channel?.id).concat(e).slice(0,1):e,r=i.some(a=>a.scene.header.channels.some(o=>o.over_run));return n.flatMap(a=>i.flatMap((o,l)=>{let c=o.scene.channel(a.id);if(a.id!=="length"&&!c)return[];let h=Na(this.largest(a),[],a.unit)[1],u=i.length>1?`${a.label}, ${this.app.labels[l]}`:a.label;return[{id:`${a.id}:${l}`,label:u,unit:h,when:r?c?.over_run?"worst of run":"now":"",channel:a,view:o}]}))}largest(t){if(t.id==="length")return this.app.views.reduce((i,{scene:n})=>n.members.reduce((r,a,o)=>Math.max(r,n.length(0,o)),i),0);let e=this.app.views.filter(({scene:i})=>i.channel(t.id)).flatMap(({scene:i})=>i.range(t.id));return Math.max(...e.map(Math.abs))}show(){let t=this.columns(),e=(c,h)=>x("th",{scope:"col","aria-sort":this.order.id===c?this.order.down?"descending":"ascending":"none"},x("button",{type:"button",class:"link",onclick:()=>this.sort(c)},h)),i=({label:c,unit:h,when:u})=>[c,u?x("small",{},u):null,h?x("small",{class:"unit"},` (${h})`):null];ce(this.head,x("tr",{},e("name","member"),t.map(c=>e(c.id,i(c)))));let n=[...new Set(this.app.views.flatMap(({scene:c})=>c.members.filter((h,u)=>c.shows(u))))],r=this.filter.value.trim().toLowerCase(),a=n.map(c=>({name:c})).filter(({name:c})=>c.toLowerCase().includes(r)),o=t.find(c=>c.id===this.order.id);o?a.sort((c,h)=>(this.order.down?1:-1)*(Tm(o,h.name)-Tm(o,c.name))):this.order.down||a.reverse(),this.rows=a.slice(0,ed),this.cells=[],ce(this.body,this.rows.map(({name:c})=>this.row(c,t)));let l=this.app.views.map(({scene:c})=>c);ce(this.note,a.length>ed?x("span",{},`${ed} of ${a.length} members; sort or search to see others. `):null,t.some(c=>c.channel.id==="force")&&l.some(c=>c.unsure.size)?x("span",{},"† not unique: a share by stiffness or convention. "):null,t.some(c=>Ui(c.channel))&&l.some(({unchecked:c})=>c)?x("span",{},"- striped: not checked. "):null,t.some(c=>c.channel.id==="utilisation")&&l.some(c=>Object.keys(c.header.not_checked||{}).length)?x("span",{},"* not every rule was checked: pick the member. "):null),this.node.hidden=!n.length,this.update(),this.mark()}row(t,e){let i=e.map(r=>{let a=x("td");return this.cells.push({cell:a,column:r,index:r.view.scene.members.indexOf(t)}),a}),n=x("button",{type:"button",class:"link",onclick:()=>this.app.pick({type:"member",name:t})},t);return x("tr",{"data-name":t},x("th",{scope:"row"},n),i)}pickFirst(){this.rows.length&&this.app.pick({type:"member",name:this.rows[0].name})}sort(t){this.order={id:t,down:this.order.id===t?!this.order.down:!0},this.show()}update(){let t=new Map;for(let e of this.cells){let{scene:i,frame:n}=e.column.view,{channel:r}=e.column;e.value=e.index<0?NaN:i.plainValue(r.id,n,e.index),t.set(e.column,[...t.get(e.column)||[],e])}for(let[e,i]of t){let{channel:n,view:{scene:r}}=e,a=i.map(l=>l.value),o=n.scale==="margin"?a.map(l=>La(n,l,!0)):Na(this.largest(n),a,n.unit,0,!0)[0];i.forEach(({cell:l,value:c,index:h},u)=>{let d=h<0?"":this.sign(n,r,h,c);l.textContent=d+o[u],l.classList.toggle("over",Ui(n)&&c>1),l.classList.toggle("hatched",d.startsWith("†")||h>=0&&Ui(n)&&Number.isNaN(c))})}}sign(t,e,i,n){let r=e.members[i];return t.id==="force"&&e.unsure.has(i)?"† ":t.id==="utilisation"&&!Number.isNaN(n)&&e.header.not_checked?.[r]?"* ":""}reveal(t){let e=this.body.closest(".scroll"),i=this.head.offsetHeight;t.offsetTop-i<e.scrollTop?e.scrollTop=t.offsetTop-i:t.offsetTop+t.offsetHeight>e.scrollTop+e.clientHeight&&(e.scrollTop=t.offsetTop+t.offsetHeight-e.clientHeight)}mark(){let{picked:t}=this.app;for(let e of this.body.children){let i=t?.type==="member"&&e.dataset.name===t.name;e.toggleAttribute("aria-current",i),i&&this.reveal(e)}}};function Tm(s,t){let{scene:e,frame:i}=s.view,n=e.members.indexOf(t),r=n<0?NaN:Math.abs(e.value(s.channel.id,i,n));return Number.isNaN(r)?-1:r}var EM=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10],Em=[1,1.5,2,3,4,6,8],AM=5,Am=8;function Mc(s){if(!(s>0)||!Number.isFinite(s))return 1;let t=Math.floor(Math.log10(s/Am));return[...Em,...Em.map(i=>10*i)].map(i=>+`${i}e${t}`).find(i=>s/i<=Am&&s/i>=AM)||1}function Cm(s){return[...new Set([...EM,Mc(s)])].sort((t,e)=>t-e)}var bc=class{constructor(t){this.app=t;let e=t.lead.time,i=e[t.lead.frames-1]-e[0],n=Mc(i),r=a=>`${ye(a)}×${a===n&&i>0?` (${ye(i/a,2)} s)`:""}`;this.button=x("button",{type:"button",class:"play",title:t.hint("Play or pause","space"),onclick:()=>t.togglePlay()},"▶"),this.slider=x("input",{type:"range",min:0,max:Math.max(t.lead.frames-1,0),step:1,value:0,"aria-label":"time",oninput:()=>t.goTo(Number(this.slider.value))}),this.readout=x("output",{class:"time"}),this.speed=x("select",{"aria-label":"speed",title:t.hint("Speed","+ and -"),onchange:()=>t.setSpeed(Number(this.speed.value))},t.speeds.map(a=>x("option",{value:a,selected:a===t.speed},r(a)))),this.node=x("footer",{class:"timebar"},this.button,this.slider,this.readout,this.speed),this.node.hidden=t.lead.frames<2}update(){let{app:t}=this,e=t.lead.time[t.index],i=t.lead.time[t.lead.frames-1],n=Math.max(4,Math.ceil(Math.log10(t.lead.frames))+1);this.slider.value=t.index,this.slider.setAttribute("aria-valuetext",`${ye(e,n)} s of ${ye(i,n)} s`),this.readout.textContent=`${ye(e,n)} s`,this.button.textContent=t.playing?"❚❚":"▶",this.button.setAttribute("aria-label",t.playing?"pause":"play"),this.speed.value=String(t.speed)}};var CM=[["ghost","Ghost","Start pose","G"],["paths","Paths","Paths of all nodes that move","Y"],["names","Names","Names of members and nodes","A"],["loads","Loads","Loads","L"],["grid","Grid","Ground grid","H"]],RM=[["corner","Corner","1"],["front","Front","2"],["side","Side","3"],["plane","Top","4"]],Sc=class{constructor(t){this.app=t;let{header:e}=t.views[0].scene,i=[...new Set(t.views.map(({scene:h})=>h.header.title||h.header.name||"Model"))],n=[...new Map(t.views.flatMap(h=>h.scene.header.channels).map(h=>[h.id,h])).values()],r=x("option",{value:""},"Kind of member");this.colour=x("select",{"aria-label":"colour by",title:t.hint("Colour by","C"),onchange:()=>t.setChannel(this.colour.value)},r,n.map(h=>x("option",{value:h.id},h.label)));let a=CM.filter(([h])=>h!=="paths"||t.lead.frames>1);this.switches=new Map(a.map(([h,u,d,f])=>[h,Ua(u,t.hint(d,f),t.shown[h],()=>t.toggle(h))]));let o=t.views[0].scene.dim===3?RM:[],l=e.modes.length?x("select",{"aria-label":"mode",title:t.hint("Mode or mechanism","M"),onchange:()=>t.setMode(Number(this.modes.value))},x("option",{value:-1},"No mode"),e.modes.map((h,u)=>x("option",{value:u},PM(h)))):null;this.modes=l;let{cases:c}=t.views[0].scene;this.cases=c.length>1?x("select",{"aria-label":"load case",title:t.hint("Load case","E"),onchange:()=>t.setCase(this.cases.value)},c.map(h=>x("option",{value:h},h))):null,this.node=x("header",{class:t.views.length>1?"toolbar two":"toolbar"},x("div",{class:"title"},x("h1",{},i.join(" | ")),t.views.map(({scene:h},u)=>x("p",{},t.views.length>1?`${t.labels[u]}: `:"",IM(h)))),x("div",{class:"tools"},this.cases&&x("label",{},x("span",{},"Load case"),this.cases),x("label",{},x("span",{},"Colour"),this.colour),l,x("span",{class:"group",role:"group","aria-label":"camera"},o.map(([h,u,d])=>x("button",{type:"button",title:t.hint(`Camera: ${u}`,d),onclick:()=>t.aim(h)},u))),x("span",{class:"group",role:"group","aria-label":"show"},[...this.switches.values()]),x("span",{class:"group"},x("button",{type:"button",title:t.hint("Panel","V"),onclick:()=>t.togglePanel()},"Panel"),x("button",{type:"button",title:t.hint("Dark or light","D"),"aria-label":"dark or light",onclick:()=>t.toggleTheme()},"◐"),x("button",{type:"button",title:t.hint("Help","?"),"aria-label":"help",onclick:()=>t.toggleHelp()},"?"))))}update(){this.colour.value=this.app.channel?.id||"",this.cases&&(this.cases.value=this.app.views[0].scene.header.load_case),this.modes&&(this.modes.value=String(this.app.mode));for(let[t,e]of this.switches)Oi(e,this.app.shown[t])}};function PM(s){return s.frequency===null?s.name:`${s.name}: ${$t(Number(s.frequency),"Hz")}`}function Rm(s,t){return`${s} ${t}${s===1?"":"s"}`}function IM(s){let{header:t}=s,e=s.members.filter((l,c)=>s.shows(c)),i=s.nodes.filter((l,c)=>!s.directors.has(c)),n=[t.kind==="run"?`run ${t.name}`:t.kind];t.cases.length===1&&t.load_case!=="all"&&n.push(`load case ${t.load_case}`);let r=(t.skins||[]).map(l=>`${l.kind} ${l.name}`);n.push([e.length||!r.length?Rm(e.length,"member"):"",r.length>3?`${r.length} meshes`:r.join(", "),Rm(i.length,"node")].filter(Boolean).join(", "));let{all:a,shown:o}=t.samples;return a>1&&n.push(o<a?`${o} of ${a} samples`:`${a} samples`),t.rounded&&n.push("curves rounded"),t.status!=="Completed."?n.push(`${t.status} ${t.message}`):t.message&&!t.verdict?.more.some(l=>t.message.includes(l))&&n.push(t.message),n.join(" · ")}var NM={ok:"✓",over:"✕",open:"-",none:"-"},wc=class{constructor(t){this.app=t,this.node=x("div",{class:"verdicts",role:"status","aria-label":"verdict"}),this.update()}update(){let t=JSON.stringify(this.app.views.map(({scene:e})=>e.header.verdict||null));t!==this.told&&(this.told=t,ce(this.node,this.app.views.map((e,i)=>this.strip(e,i))),this.node.hidden=!this.node.childElementCount)}strip({scene:t},e){let{verdict:i}=t.header;if(!i)return null;let{state:n,text:r,governing:a,more:o}=i;return x("div",{class:`verdict ${n}`},x("span",{class:"headline"},x("b",{class:"sign","aria-hidden":!0},NM[n]),x("b",{},this.app.views.length>1?`${this.app.labels[e]}: ${r}`:r)),a?x("button",{type:"button",class:"governing",title:"Show this member and instant",onclick:()=>this.go(t,a)},n==="open"?`highest of what was checked: ${a.text}`:a.text):null,o.length?x("span",{},o.join("; ")):null)}go(t,e){let{app:i}=this;if(i.pause(),t.cases.includes(e.load_case)&&i.setCase(e.load_case),e.kind==="member"&&t.channel("utilisation")&&i.setChannel("utilisation"),e.time!==null&&i.goTo(i.lead.frameAt(e.time)),e.kind==="quantity")return i.pick(null);let n=t.header.drives.find(r=>r.name===e.name);t.members.includes(e.member)?i.pick({type:"member",name:e.member}):n?.member!==void 0?i.pick({type:"member",name:t.members[n.member]}):n&&i.pick({type:"node",name:t.nodes[n.node??n.start]})}};var Pm={type:"change"},nd={type:"start"},Nm={type:"end"},Tc=new Yn,Im=new gi,LM=Math.cos(70*Cu.DEG2RAD),Ge=new P,di=2*Math.PI,ue={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},id=1e-6,Ec=class extends sa{constructor(t,e=null){super(t,e),this.state=ue.NONE,this.target=new P,this.cursor=new P,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Xi.ROTATE,MIDDLE:Xi.DOLLY,RIGHT:Xi.PAN},this.touches={ONE:$i.ROTATE,TWO:$i.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new P,this._lastQuaternion=new je,this._lastTargetPosition=new P,this._quat=new je().setFromUnitVectors(t.up,new P(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Xs,this._sphericalDelta=new Xs,this._scale=1,this._panOffset=new P,this._rotateStart=new it,this._rotateEnd=new it,this._rotateDelta=new it,this._panStart=new it,this._panEnd=new it,this._panDelta=new it,this._dollyStart=new it,this._dollyEnd=new it,this._dollyDelta=new it,this._dollyDirection=new P,this._mouse=new it,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=UM.bind(this),this._onPointerDown=DM.bind(this),this._onPointerUp=OM.bind(this),this._onContextMenu=HM.bind(this),this._onMouseWheel=BM.bind(this),this._onKeyDown=zM.bind(this),this._onTouchStart=GM.bind(this),this._onTouchMove=VM.bind(this),this._onMouseDown=FM.bind(this),this._onMouseMove=kM.bind(this),this._interceptControlDown=WM.bind(this),this._interceptControlUp=XM.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ue.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Pm),this.update(),this.state=ue.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Ge.copy(e).sub(this.target),Ge.applyQuaternion(this._quat),this._spherical.setFromVector3(Ge),this.autoRotate&&this.state===ue.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,n=this.maxAzimuthAngle;isFinite(i)&&isFinite(n)&&(i<-Math.PI?i+=di:i>Math.PI&&(i-=di),n<-Math.PI?n+=di:n>Math.PI&&(n-=di),i<=n?this._spherical.theta=Math.max(i,Math.min(n,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+n)/2?Math.max(i,this._spherical.theta):Math.min(n,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Ge.setFromSpherical(this._spherical),Ge.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ge),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=Ge.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new P(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new P(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Ge.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Tc.origin.copy(this.object.position),Tc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Tc.direction))<LM?this.object.lookAt(this.target):(Im.setFromNormalAndCoplanarPoint(this.object.up,this.target),Tc.intersectPlane(Im,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>id||8*(1-this._lastQuaternion.dot(this.object.quaternion))>id||this._lastTargetPosition.distanceToSquared(this.target)>id?(this.dispatchEvent(Pm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?di/60*this.autoRotateSpeed*t:di/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ge.setFromMatrixColumn(e,0),Ge.multiplyScalar(-t),this._panOffset.add(Ge)}_panUp(t,e){this.screenSpacePanning===!0?Ge.setFromMatrixColumn(e,1):(Ge.setFromMatrixColumn(e,0),Ge.crossVectors(this.object.up,Ge)),Ge.multiplyScalar(t),this._panOffset.add(Ge)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let n=this.object.position;Ge.copy(n).sub(this.target);let r=Ge.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),n=t-i.left,r=e-i.top,a=i.width,o=i.height;this._mouse.x=n/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(di*this._rotateDelta.x/e.clientHeight),this._rotateUp(di*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),n=.5*(t.pageY+e.y);this._rotateStart.set(i,n)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),n=.5*(t.pageY+e.y);this._panStart.set(i,n)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,n=t.pageY-e.y,r=Math.sqrt(i*i+n*n);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),n=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(n,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(di*this._rotateDelta.x/e.clientHeight),this._rotateUp(di*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),n=.5*(t.pageY+e.y);this._panEnd.set(i,n)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,n=t.pageY-e.y,r=Math.sqrt(i*i+n*n);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(t.pageX+e.x)*.5,o=(t.pageY+e.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new it,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function DM(s){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(s.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(s)&&(this._addPointer(s),s.pointerType==="touch"?this._onTouchStart(s):this._onMouseDown(s),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function UM(s){this.enabled!==!1&&(s.pointerType==="touch"?this._onTouchMove(s):this._onMouseMove(s))}function OM(s){switch(this._removePointer(s),this._pointers.length){case 0:this.domElement.releasePointerCapture(s.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Nm),this.state=ue.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function FM(s){let t;switch(s.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Xi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(s),this.state=ue.DOLLY;break;case Xi.ROTATE:if(s.ctrlKey||s.metaKey||s.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(s),this.state=ue.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(s),this.state=ue.ROTATE}break;case Xi.PAN:if(s.ctrlKey||s.metaKey||s.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(s),this.state=ue.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(s),this.state=ue.PAN}break;default:this.state=ue.NONE}this.state!==ue.NONE&&this.dispatchEvent(nd)}function kM(s){switch(this.state){case ue.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(s);break;case ue.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(s);break;case ue.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(s);break}}function BM(s){this.enabled===!1||this.enableZoom===!1||this.state!==ue.NONE||(s.preventDefault(),this.dispatchEvent(nd),this._handleMouseWheel(this._customWheelEvent(s)),this.dispatchEvent(Nm))}function zM(s){this.enabled!==!1&&this._handleKeyDown(s)}function GM(s){switch(this._trackPointer(s),this._pointers.length){case 1:switch(this.touches.ONE){case $i.ROTATE:if(this.enableRotate===!1){this.state=ue.NONE;break}this._handleTouchStartRotate(s),this.state=ue.TOUCH_ROTATE;break;case $i.PAN:if(this.enablePan===!1){this.state=ue.NONE;break}this._handleTouchStartPan(s),this.state=ue.TOUCH_PAN;break;default:this.state=ue.NONE}break;case 2:switch(this.touches.TWO){case $i.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(s),this.state=ue.TOUCH_DOLLY_PAN;break;case $i.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(s),this.state=ue.TOUCH_DOLLY_ROTATE;break;default:this.state=ue.NONE}break;default:this.state=ue.NONE}this.state!==ue.NONE&&this.dispatchEvent(nd)}function VM(s){switch(this._trackPointer(s),this.state){case ue.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(s),this.update();break;case ue.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(s),this.update();break;case ue.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(s),this.update();break;case ue.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(s),this.update();break;default:this.state=ue.NONE}}function HM(s){this.enabled!==!1&&s.preventDefault()}function WM(s){s.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function XM(s){s.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var sd=[.35,1.2],$M="5.0",qM=.6;function YM(){let s=new ci({color:"#ffffff"});return s.userData={stripe:{value:new Nt}},s.onBeforeCompile=t=>{Object.assign(t.uniforms,s.userData),t.vertexShader=`attribute float hatch;
varying float vHatch;
varying float vAlong;
${t.vertexShader}`.replace("#include <begin_vertex>",`#include <begin_vertex>
      vHatch = hatch;
      vAlong = position.y * length(instanceMatrix[1].xyz) / (${$M} * max(length(instanceMatrix[0].xyz), length(instanceMatrix[2].xyz)));`),t.fragmentShader=`varying float vHatch;
varying float vAlong;
uniform vec3 stripe;
${t.fragmentShader}`.replace("#include <color_fragment>",`#include <color_fragment>
if (vHatch > 0.5 && fract(vAlong) < 0.4) diffuseColor.rgb = stripe;`)},s}function rd(s){return s.material=YM(),s.geometry.setAttribute("hatch",new Zn(new Float32Array(s.instanceMatrix.count),1)),s}var Ac=class{constructor(t,e=[]){this.size={value:new it(1,1)},this.width={value:sd[1]},[this.material,this.sides]=["","if (abs(normal.y) > 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);"].map(i=>this.outline(i)),this.meshes=t.filter(i=>i.count).map(i=>{let n=new Hi(i.geometry,e.includes(i)?this.sides:this.material,i.count);return n.instanceMatrix=i.instanceMatrix,n.frustumCulled=!1,n})}outline(t){let e=new Vi({side:ke});return e.customProgramCacheKey=()=>`rim ${t}`,e.onBeforeCompile=i=>{Object.assign(i.uniforms,{rimSize:this.size,rimWidth:this.width}),i.vertexShader=`uniform vec2 rimSize;
uniform float rimWidth;
${i.vertexShader}`.replace("#include <project_vertex>",`#include <project_vertex>
        vec3 rimNormal = mat3(modelViewMatrix) * mat3(instanceMatrix) * normal;
        vec2 rimAway = (projectionMatrix * vec4(rimNormal, 0.0)).xy * rimSize;
        gl_Position.xy += rimAway / max(length(rimAway), 1e-20) * 2.0 * rimWidth / rimSize * gl_Position.w;
        ${t}`)},e}setColour(t){for(let e of[this.material,this.sides])e.color.set(t)}setScale(t){this.width.value=Math.min(Math.max(qM*t,sd[0]),sd[1])}resize(t,e){this.size.value.set(t,e)}};var Lm=new Nt(hi.driven),ZM=.3,jM=new Nt(Ld);function KM(s){let t=.011*s.length0,e=.05*s.length0;return Float32Array.from(s.arrays.radius.data,i=>Math.min(e,Math.max(t,i||0)))}function JM(s,t){let e=s.arrays.box?.data;return s.members.map((i,n)=>{let r=e?[e[2*n],e[2*n+1]]:[NaN];if(!r.every(o=>o>0)||s.active.has(n))return null;let a=t[n]/Math.max(...r);return r.map(o=>Math.max(a*o,.2*t[n]))})}var Rc=class{constructor(t){this.scene=t,this.radius=KM(t);let e=t.members.length>800;this.pieces=t.members.flatMap((a,o)=>t.active.has(o)?[[o,"base"],[o,"tube"],[o,"screw"]]:t.curves.row.has(o)?Array.from({length:t.curves.places-1},(l,c)=>[o,"beam",c]):[[o,t.header.kinds[o]]]),this.box=JM(t,this.radius);let i=this.pieces.filter(([a])=>this.box[a]),n=this.pieces.filter(([a])=>!this.box[a]);this.pieces=[...n,...i],this.round=n.length,this.firstPiece=[],this.pieces.forEach(([a],o)=>this.firstPiece[a]??=o),this.marks=t.members.flatMap((a,o)=>iS(t,o)),this.rods=rd(rs(n.length,e?6:14)),this.boxes=rd(Yp(i.length)),this.collars=rs(this.marks.length,e?6:18),this.balls=Ql(t.nodes.length,e?1:3,"#ffffff"),this.small=tS(t),this.lines=eS(this.pieces.length),this.ball=1.55*this.radius.reduce((a,o)=>Math.min(a,o),.02*t.length0);let r=new Nt("#ffffff");this.pieces.forEach((a,o)=>this.at(o).mesh.setColorAt(this.at(o).index,r)),this.marks.forEach((a,o)=>this.collars.setColorAt(o,a.colour)),this.paintNodes("#5b6672"),this.rims=new Ac([this.rods,this.boxes,this.collars,this.balls],[this.rods,this.boxes])}objects(){return[this.rods,this.boxes,this.collars,this.balls,this.lines,...this.rims.meshes]}at(t){return t<this.round?{mesh:this.rods,index:t}:{mesh:this.boxes,index:t-this.round}}setTheme({node:t,outline:e,back:i}){this.paintNodes(t),this.rims.setColour(e);for(let{material:n}of[this.rods,this.boxes])n.userData.stripe.value.set(i)}setScale(t){this.rims.setScale(t);let e=t>ZM;for(let i of[this.rods,this.boxes,this.collars,this.balls,...this.rims.meshes])i.visible=e}resize(t,e){this.rims.resize(t,e)}place(t,e){let{scene:i,radius:n}=this,r=i.arrays.rods.data,a=this.lines.geometry.attributes.position,o=new Map;for(let l of i.curves.row.keys())o.set(l,{pieces:QM(Ti(i.curves.points(t,l)),.3*n[l]),across:i.curves.across(t,l)});this.pieces.forEach(([l,c,h],u)=>{let[d,f]=o.get(l)?.pieces[h]||[t[i.ends[2*l]],t[i.ends[2*l+1]]],p=i.shows(l)?n[l]:0;a.array.set(d,6*u),a.array.set(p?f:d,6*u+3),u>=this.round&&p?jp(this.boxes,u-this.round,d,f,o.get(l)?.across[h]||Zu(i,e,l).axes[1],this.box[l]):c==="base"?Ei(this.rods,u,d,nr(d,f,Math.min(r[6*l+1],Cc(d,f))),.75*p):c==="tube"?Ei(this.rods,u,nr(f,d,Math.min(r[6*l+4],Cc(d,f))),f,1.5*p):Ei(this.rods,u,d,f,c==="free"||c==="screw"||c==="cable"?.35*p:c==="elastic"?.7*p:p)}),this.marks.forEach((l,c)=>{let h=t[i.ends[2*l.member]],u=t[i.ends[2*l.member+1]],d=Cc(h,u),f=n[l.member],p=l.nut?Math.max(0,d-r[6*l.member+4]):l.place*d,y=l.half*f;Ei(this.collars,c,nr(h,u,p-y),nr(h,u,p+y),l.width*f)}),t.forEach((l,c)=>Js(this.balls,c,l,this.ball*this.small[c])),a.needsUpdate=!0,[this.rods,this.boxes,this.collars,this.balls].forEach(Nn)}paint(t,e){let i=new Nt,n=this.lines.geometry.attributes.color;this.pieces.forEach(([r],a)=>{let[o,l,c]=t(r),{mesh:h,index:u}=this.at(a);h.setColorAt(u,i.setRGB(o/255,l/255,c/255,"srgb")),h.geometry.attributes.hatch.array[u]=e(r)?1:0;for(let d of[0,1])i.toArray(n.array,6*a+3*d)}),n.needsUpdate=!0;for(let r of[this.rods,this.boxes])r.geometry.attributes.hatch.needsUpdate=!0,r.instanceColor&&(r.instanceColor.needsUpdate=!0)}hatchOf(t){let{mesh:e,index:i}=this.at(this.firstPiece[t]);return e.geometry.attributes.hatch.array[i]===1}paintNodes(t){let e=new Nt(t);for(let i=0;i<this.scene.nodes.length;i++)this.balls.setColorAt(i,e);this.balls.instanceColor&&(this.balls.instanceColor.needsUpdate=!0)}colourOf(t){let e=new Nt,{mesh:i,index:n}=this.at(this.firstPiece[t]);i.getColorAt(n,e);let{r,g:a,b:o}=e.getRGB({r:0,g:0,b:0},"srgb");return[r,a,o].map(l=>Math.round(255*l))}};function QM(s,t){return s.map(([e,i],n)=>[n?nr(e,i,-t):e,n<s.length-1?nr(i,e,-t):i])}function tS(s){let t=new Float32Array(s.nodes.length).fill(1),e=new Set(s.ends),i=new Set(s.skin);for(let n of i)e.has(n)||(t[n]=i.size>300?0:.6);for(let n of s.directors)t[n]=0;return t}function eS(s){let t=new Me;for(let i of["position","color"])t.setAttribute(i,new Ne(new Float32Array(6*s),3));let e=new Si(t,new li({vertexColors:!0}));return e.frustumCulled=!1,e}function iS(s,t){if(s.active.has(t))return[{member:t,nut:!0,half:1.6,width:2.2,colour:Lm}];let e=s.header.kinds[t];return e==="driven"?[{member:t,place:.5,half:2.2,width:1.8,colour:Lm}]:e!=="elastic"?[]:[.3,.4,.5,.6,.7].map(i=>({member:t,place:i,half:.3,width:1.7,colour:jM}))}function Cc(s,t){return Math.hypot(t[0]-s[0],t[1]-s[1],t[2]-s[2])}function nr(s,t,e){let i=e/(Cc(s,t)||1);return[s[0]+i*(t[0]-s[0]),s[1]+i*(t[1]-s[1]),s[2]+i*(t[2]-s[2])]}var nS="#ffb000",Pc=class{constructor(t){this.bars=t,this.group=new Fe;let e=new Vi({color:nS,side:ke});this.bar=new Hi(new ln(1,1,1,18,1,!0),e,Math.max(1,t.scene.curves.places-1)),this.ball=new Hi(new Kn(1,3),e,1);for(let i of[this.bar,this.ball])i.frustumCulled=i.visible=!1,this.group.add(i)}place(t,e){let{bars:i}=this;if(this.bar.visible=e?.type==="member",this.ball.visible=e?.type==="node",this.bar.visible){let{active:n,curves:r}=i.scene,a=e.index,o=Ti(r.points(t,a)),l=i.radius[a]*(n.has(a)?2.9:1.9);o.forEach(([c,h],u)=>Ei(this.bar,u,c,h,l)),this.bar.count=o.length}this.ball.visible&&Js(this.ball,0,t[e.index],1.7*i.ball),[this.bar,this.ball].forEach(Nn)}};var Dm=24,Ic=class{constructor(t,e){this.scene=t,this.group=new Fe,this.material=new ci({side:ii,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),this.ink=new li({}),this.plates=t.header.bodies.map((n,r)=>this.plate(n,e,r)),this.hulls=t.header.solids||[];let i=new Me;i.setAttribute("position",new Ne(new Float32Array(9*this.hulls.length),3)),this.hull=new Pe(i,this.material),this.hull.frustumCulled=!1,this.group.add(this.hull)}setTheme({body:t,outline:e}){this.material.color.set(t),this.ink.color.set(e)}plate(t,e,i){let n=this.scene.length(0,t.member),r=1.9*e,a=.5*e,o=sS([[0,0],[n,0],t.center],r),l=new jr(new Vs(o.map(([h,u])=>new it(h,u))),{depth:a,bevelEnabled:!1,steps:1});l.translate(0,0,-a*(.5+.02*i));let c=new Fe;return c.add(new Pe(l,this.material),new Si(new Gr(l,50),this.ink)),this.group.add(c),{body:t,plate:c}}place(t){let{scene:e}=this;for(let{body:n,plate:r}of this.plates){let a=t[e.ends[2*n.member]],o=t[e.ends[2*n.member+1]];r.position.set(...a),r.rotation.z=Math.atan2(o[1]-a[1],o[0]-a[0])}if(!this.hulls.length)return;let{position:i}=this.hull.geometry.attributes;this.hulls.forEach((n,r)=>n.forEach((a,o)=>i.array.set(t[a],9*r+3*o))),i.needsUpdate=!0,this.hull.geometry.computeVertexNormals()}};function sS(s,t){let e=s.flatMap(([n,r])=>Array.from({length:Dm},(a,o)=>{let l=2*Math.PI*o/Dm;return[n+t*Math.cos(l),r+t*Math.sin(l)]}));e.sort((n,r)=>n[0]-r[0]||n[1]-r[1]);let i=n=>{let r=[];for(let a of n){for(;r.length>1&&rS(r[r.length-2],r[r.length-1],a)<=0;)r.pop();r.push(a)}return r.slice(0,-1)};return[...i(e),...i(e.reverse())]}function rS(s,t,e){return(t[0]-s[0])*(e[1]-s[1])-(t[1]-s[1])*(e[0]-s[0])}var ad=104,aS=[["x",[1,0,0],"#c0392b"],["y",[0,1,0],"#2e8b57"],["z",[0,0,1],"#2f6fc1"]],Nc=class{constructor(t){this.world=new qn,this.camera=new Ze(30,1,.1,20);let e=new Jn("#ffffff",1.5);e.position.set(1,-2,3),this.world.add(new Qn("#ffffff",1.8),e),this.letters=aS.slice(0,t.dim).map(([i,n,r])=>this.add(i,n,r,.05)),this.gravity=this.add("g",[0,0,1],"#8a949e",.07),this.letters.push(this.gravity),this.setGravity(t.header.gravity)}add(t,e,i,n){let r=_a(i),a=new Ur(new ks({depthTest:!1}));return Qs(r,[0,0,0],e,n),a.position.set(...e.map(o=>1.27*o)),a.scale.setScalar(.44),this.world.add(r,a),{name:t,letter:a,one:r}}setGravity(t){let e=[0,1,2].map(a=>t[a]||0),i=Math.hypot(...e),{one:n,letter:r}=this.gravity;r.visible=i>0,this.pull=new P(...e).multiplyScalar(1.08/(i||1)),Qs(n,[0,0,0],e.map(a=>.85*a/(i||1)),.07)}setTheme(t){for(let{name:e,letter:i}of this.letters)i.material.map?.dispose(),i.material.map=oS(e,Xe[t].ink),i.material.needsUpdate=!0}render(t,e){let i=t.getPixelRatio(),n=t.domElement,r=n.width/i;this.camera.position.set(0,0,5.6).applyQuaternion(e.quaternion),this.camera.quaternion.copy(e.quaternion);let a=new P(-.95,0,0).applyQuaternion(e.quaternion);this.gravity.one.position.copy(a),this.gravity.letter.position.copy(this.pull).add(a),t.setViewport(r-ad-4,4,ad,ad),t.clearDepth(),t.render(this.world,this.camera),t.setViewport(0,0,r,n.height/i)}};function oS(s,t){let e=document.createElement("canvas");e.width=e.height=64;let i=e.getContext("2d");return i.font="600 46px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle",i.fillStyle=t,i.fillText(s,32,34),new kr(e)}var lS=.8,cS=2e4,hS=104;function od({scene:s,loads:t,supports:e}){let i=[],n=Math.max(1,Math.ceil(s.frames*s.nodes.length/cS)),r=s.frames-1;for(let a=0;a<=r;a=a<r?Math.min(a+n,r):a+1){for(let o=0;o<s.nodes.length;o++)s.directors.has(o)||i.push(s.position(a,o));i.push(...t.tips(a),...e.feet(a))}return i}function ld({scene:s,camera:t,canvas:e},i,n,r=lS,a=hS){let o=new P().crossVectors(t.up,i);o.length()<.001&&o.set(1,0,0),o.normalize();let l=new P().crossVectors(i,o),c=Math.tan(t.fov*Math.PI/360),h=t.aspect,u=Math.min(a/(e.clientHeight||1e3),.25),d=c*h*r,f=c*(r-u),p=n.map(w=>{let b=new P(...w);return[b.dot(o),b.dot(l),b.dot(i)]}),y=[0,1,2].map(w=>(p.reduce((b,C)=>Math.min(b,C[w]),1/0)+p.reduce((b,C)=>Math.max(b,C[w]),-1/0))/2),m=s.extent.size;for(let w=0;w<4;w++){m=p.reduce((b,[C,E,_])=>Math.max(b,Math.abs(C-y[0])/d+_-y[2],Math.abs(E-y[1])/f+_-y[2]),.05*s.extent.size);for(let b of[0,1]){let C=p.map(E=>(E[b]-y[b])/(m-E[2]+y[2]));w<3&&(y[b]+=m*(C.reduce((E,_)=>Math.min(E,_),1/0)+C.reduce((E,_)=>Math.max(E,_),-1/0))/2)}}let g=p.reduce((w,b)=>Math.max(w,(b[1]-y[1])/(m-b[2]+y[2])/c),0);return y[1]+=Math.max(0,g-r+2*u)*c*m,{centre:new P().addScaledVector(o,y[0]).addScaledVector(l,y[1]).addScaledVector(i,y[2]),far:m}}function Um(){return!!document.createElement("canvas").getContext("webgl2")}var sr=class extends tr{constructor(t,e,i,n=e.members.length<2e3){super(t,e),this.renderer=new ql({canvas:t,antialias:n,preserveDrawingBuffer:!0}),this.renderer.autoClear=!1,this.world=new qn,this.camera=new Ze(32,1,e.extent.size/500,e.extent.size*60),this.camera.up.set(0,e.dim===2?1:0,e.dim===2?0:1),this.lamp=new Jn("#ffffff",2.1),this.lampPlace=[-.35,.6,1],this.ambient=new Qn("#ffffff",1.45),this.world.add(this.ambient,this.lamp),this.controls=new Ec(this.camera,t),e.dim===2&&(this.controls.enableRotate=!1,this.controls.mouseButtons.LEFT=Xi.PAN,this.controls.touches.ONE=$i.PAN),this.controls.addEventListener("change",()=>this.onCamera?.(this)),this.triad=new Nc(e),this.build(),this.setTheme(i),this.aim(e.dim===2?"plane":"corner"),this.setFrame(0)}build(){let{scene:t,world:e}=this,i=.1*t.length0;this.bars=new Rc(t),this.supports=new ic(t),this.loads=new ya(t,.9*i),this.drives=new nc(t,i),this.bodies=new Ic(t,this.bars.ball),this.traces=new er(t),this.centres=new rc(t,.25*i),this.faces=new sc(t,t.header.triangles,.35),this.faces.mesh.visible=!1,this.skins=new Kl(t),this.halo=new Pc(this.bars),Object.assign(this,em(t)),this.ghost=im(t),this.ghost.visible=!1,e.add(...this.bars.objects(),this.supports.mesh,this.loads.group,this.drives.group,this.bodies.group,this.centres.mesh,this.faces.mesh,this.traces.group,...this.skins.objects(),this.halo.group,this.grid,this.ghost)}rebuildLoads(){this.world.remove(this.loads.group),this.loads=new ya(this.scene,.09*this.scene.length0),this.world.add(this.loads.group),this.triad.setGravity(this.scene.header.gravity)}setTheme(t){this.renderer.setClearColor(new Nt(Xe[t].back));for(let e of[this.bars,this.supports,this.bodies,this.traces])e.setTheme(Xe[t]);this.skins.setTheme(t),this.triad.setTheme(t),this.paint()}move(){this.now=this.points(),[this.bars,this.supports,this.drives,this.bodies,this.centres,this.faces,this.skins].forEach(t=>t.place(this.now,this.frame)),this.loads.place(this.now,this.frame),this.halo.place(this.now,this.picked),this.request()}pick(t){this.picked=t,this.halo.place(this.now,t),this.request()}paint(){this.bars.paint(t=>this.shade(t),t=>this.hatched(t)),this.skins.paint(this.channel,this.frame,this.limits),this.request()}showTraces(t){this.traces.show(t),this.request()}aim(t){let{scene:e,camera:i,controls:n}=this,r=new P(...ac[t]).normalize(),{centre:a,far:o}=ld(this,r,od(this));i.position.copy(a).addScaledVector(r,o),n.target.copy(a),n.update(),this.preset=t,this.request()}orbit(t,e,i){let{camera:n,controls:r}=this,a=n.position.clone().sub(r.target);a.applyAxisAngle(n.up,t);let o=new P().crossVectors(n.up,a).normalize(),l=a.clone().applyAxisAngle(o,-e);Math.abs(l.clone().normalize().dot(n.up))<.995&&a.copy(l),n.position.copy(r.target).addScaledVector(a,i),r.update(),this.request()}copyCamera(t){this.camera.position.copy(t.camera.position),this.controls.target.copy(t.controls.target),this.camera.lookAt(this.controls.target),this.request()}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(Math.min(window.devicePixelRatio,2)),this.renderer.setSize(t,e,!1),this.bars.resize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),!this.sized&&this.preset&&this.aim(this.preset),this.sized=!0,this.request())}end(){this.ended=!0,this.controls.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss()}render(){if(cancelAnimationFrame(this.waiting),this.waiting=0,this.ended)return;let{renderer:t,camera:e}=this;this.lamp.position.set(...this.lampPlace).applyQuaternion(e.quaternion);let i=e.position.distanceTo(this.controls.target),n=2*i*Math.tan(e.fov*Math.PI/360)/this.canvas.clientHeight;this.bars.setScale(this.bars.ball/1.55/n),t.clear(),t.render(this.world,e),this.triad.render(t,e),this.drawn=(this.drawn||0)+1,this.onDrawn?.(this)}project(t){let{clientWidth:e,clientHeight:i}=this.canvas,n=new P(...t).project(this.camera);return[(n.x+1)/2*e,(1-n.y)/2*i,n.z]}};var uS=.08;function dS(s){return s.header.triangles.length>0&&s.arrays.radius.data.every(Number.isNaN)}var Ln=class{constructor(t,e,i=[],n=null){Object.assign(this,{root:t,side:n,ended:new AbortController}),Object.assign(this,{index:0,playing:!1,speed:1,channel:null,limits:[0,1],picked:null,mode:-1,labels:i}),this.shown={ghost:!1,names:e[0].nodes.length<=12,loads:!0,supports:!0,grid:!0,faces:e.every(dS),paths:!1},this.paths=new Set,this.touch=matchMedia("(hover: none)").matches,this.theme=t.dataset.theme||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"),t.dataset.theme=this.theme,this.lead=e.reduce((l,c)=>c.time[c.frames-1]>l.time[l.frames-1]?c:l);let r=this.lead.time[this.lead.frames-1]-this.lead.time[0];Object.assign(this,{speeds:Cm(r),speed:Mc(r)});let a=e.map((l,c)=>x("canvas",{tabindex:0,role:"img","aria-label":`picture of ${i[c]||l.header.title||"the model"}`}));this.flat=!Um();let o=this.flat?cc:sr;this.views=e.map((l,c)=>new o(a[c],l,this.theme)),this.layout(a),this.wire(),bm(this,t.ownerDocument,this.ended.signal),this.setChannel(e[0].header.channels[0]?.id||""),this.table.show(),this.pick(null),this.apply(),this.goTo(0)}hint(t,e){return this.touch?t:`${t} (${e})`}layout(t){let{views:e}=this;this.bar=new Sc(this),this.verdict=new wc(this),this.time=new bc(this),this.legend=new xc(this),this.inspector=new mc(this),this.table=new vc(this),this.names=e.map(n=>new yc(n));let i=t.map((n,r)=>x("div",{class:"pane"},n,this.names[r].node,e.length>1?x("div",{class:"label"},this.labels[r]):null,x("div",{class:"scale"},`grid ${$t(e[r].step,"m")}`)));this.panel=x("aside",{class:"panel"},this.inspector.node,this.table.node),this.stage=x("div",{class:"stage"},x("div",{class:"panes"},i),this.legend.node),this.flat&&this.stage.append(x("p",{class:"note"},"This browser has no WebGL: a plain picture, turned by the buttons.")),this.help=Mm(this),this.root.replaceChildren(this.bar.node,this.verdict.node,x("main",{},this.side,this.stage,this.panel),this.time.node,this.help)}wire(){let t=new ResizeObserver(()=>this.resize());this.ended.signal.addEventListener("abort",()=>t.disconnect()),this.views.forEach((e,i)=>{t.observe(e.canvas.parentElement),e.onCamera=()=>this.follow(e),e.onDrawn=()=>this.names[i].place(this.shown.names);let n=null;e.canvas.addEventListener("pointerdown",r=>n=[r.clientX,r.clientY]),e.canvas.addEventListener("pointerup",r=>{n&&Math.hypot(r.clientX-n[0],r.clientY-n[1])<5&&this.click(e,r),n=null})}),this.resize()}refresh(){for(let e of this.views)e.scene.renew();this.verdict.update();let{channel:t}=this;t&&cr(t.scale,this.views.map(i=>i.scene.range(t.id))).some((i,n)=>i!==this.limits[n])&&this.setChannel(t.id),this.goTo(this.index)}end(){this.playing=!1,this.mode=-1,this.ended.abort();for(let t of this.views)t.end()}resize(){this.views.forEach(t=>t.resize()),this.inspector.update()}goTo(t){this.index=Math.min(Math.max(Math.round(t),0),this.lead.frames-1);let e=this.lead.time[this.index];for(let i of this.views)i.setFrame(i.scene===this.lead?this.index:i.scene.frameAt(e));this.time.update(),this.inspector.update(),this.table.update()}step(t){this.pause(),this.goTo(this.index+t)}togglePlay(){this.lead.frames<2||(this.playing=!this.playing,this.playing&&this.index===this.lead.frames-1&&this.goTo(0),this.clock={at:performance.now(),from:this.lead.time[this.index]},this.time.update(),this.playing&&requestAnimationFrame(t=>this.tick(t)))}pause(){this.playing=!1,this.time.update()}tick(t){if(!this.playing)return;let e=this.clock.from+this.speed*(t-this.clock.at)/1e3,i=this.lead.frameAt(e);i!==this.index&&this.goTo(i),e>=this.lead.time[this.lead.frames-1]?this.pause():requestAnimationFrame(n=>this.tick(n))}setSpeed(t){this.speed=t,this.clock={at:performance.now(),from:this.lead.time[this.index]},this.time.update()}faster(t){let e=this.speeds.indexOf(this.speed)+t;this.setSpeed(this.speeds[Math.min(Math.max(e,0),this.speeds.length-1)])}toWorst(){let{lead:t,channel:e}=this;if(!e||!t.channel(e.id))return;let i=[-1,0];for(let n=0;n<t.frames;n++){for(let r=0;r<t.members.length;r++){let a=Math.abs(t.value(e.id,n,r));a>i[0]&&(i=[a,n])}for(let r=0;t.coloursFaces(e.id)&&r<t.faces;r++){let a=t.faceValue(e.id,n,r);a>i[0]&&(i=[a,n])}}this.pause(),this.goTo(i[1])}setChannel(t){let e=this.views.map(i=>i.scene).filter(i=>i.channel(t));this.channel=e.length?e[0].channel(t):null,this.channel&&(this.limits=cr(this.channel.scale,e.map(i=>i.range(t))));for(let i of this.views)i.setColours(this.channel,this.limits);this.legend.show(),this.bar.update(),this.views.length>1&&this.table.show(),this.inspector.update()}setCase(t){for(let e of this.views)e.scene.choose(t)&&e.rebuildLoads();this.setChannel(this.channel?.id||""),this.apply(),this.inspector.show(),this.goTo(this.index)}nextCase(){let{cases:t,header:e}=this.views[0].scene;t.length>1&&this.setCase(t[(t.indexOf(e.load_case)+1)%t.length])}nextChannel(t){let e=["",...this.views[0].scene.header.channels.map(n=>n.id)],i=e.indexOf(this.channel?.id||"");this.setChannel(e[(i+t+e.length)%e.length])}setMode(t){let{modes:e}=this.views[0].scene.header;this.mode=t<e.length?t:-1;let i=this.views[0],n=this.mode>=0;if(i.mode=n?{array:e[this.mode].array,size:0}:null,this.bar.update(),i.move(),!n)return;let a=i.scene.arrays[i.mode.array].data.reduce((h,u)=>Math.max(h,Math.abs(u)),0)||1,o=performance.now(),l=this.mode,c=h=>{this.mode===l&&(i.mode.size=uS*i.scene.extent.size/a*Math.sin((h-o)/1e3*2.5),i.move(),i.render(),requestAnimationFrame(c))};requestAnimationFrame(c)}nextMode(){let t=this.views[0].scene.header.modes.length;t&&this.setMode(this.mode+1<t?this.mode+1:-1)}toggle(t){this.shown[t]=!this.shown[t],this.apply()}apply(){for(let t of this.views)t.ghost.visible=this.shown.ghost,t.loads.group.visible=this.shown.loads,t.supports.mesh.visible=this.shown.supports,t.grid.visible=this.shown.grid,t.faces.mesh.visible=this.shown.faces,t.showTraces(this.tracedIn(t)),t.canvas.parentElement.classList.toggle("gridless",!this.shown.grid),t.request();this.bar.update()}togglePanel(){this.root.classList.toggle("wide"),this.resize()}toggleTheme(){this.theme=this.theme==="dark"?"light":"dark",this.root.dataset.theme=this.theme;for(let t of this.views)t.setTheme(this.theme);this.inspector.update()}toggleHelp(){this.help.hidden=!this.help.hidden,this.help.hidden?this.before?.focus?.():(this.before=this.root.ownerDocument.activeElement,this.help.querySelector("button").focus())}pick(t){this.picked=t;for(let e of this.views){let i=t?this.indexIn(e,t):-1;e.pick(i<0?null:{type:t.type,index:i})}this.panel.classList.toggle("picked",!!t),this.inspector.show(),this.table.mark(),this.onPick?.(t)}indexIn(t,e){return t.scene[e.type==="member"?"members":"nodes"].indexOf(e.name)}click(t,e){let i=t.canvas.getBoundingClientRect(),n=t.pickAt(e.clientX-i.left,e.clientY-i.top,e.pointerType==="touch");this.pick(n&&{type:n.type,name:t.scene[`${n.type}s`][n.index]})}pickNext(t,e){let i=this.views[0].scene[`${t}s`];if(!i.length)return;let n=this.picked?.type===t?i.indexOf(this.picked.name):e>0?-1:0;this.pick({type:t,name:i[(n+e+i.length)%i.length]})}pickWorst(){let{scene:t,frame:e}=this.views[0];if(!this.channel)return;let i=[-1,0];t.members.forEach((n,r)=>{let a=Math.abs(t.value(this.channel.id,e,r));a>i[0]&&(i=[a,r])}),t.members.length&&this.pick({type:"member",name:t.members[i[1]]})}toggleTrace(){if(this.picked?.type!=="node"||this.lead.frames<2)return;let{name:t}=this.picked;this.paths.delete(t)||this.paths.add(t),this.apply(),this.inspector.update()}tracedIn(t){return this.shown.paths&&(t.moving??=nm(t.scene)),new Set([...this.shown.paths?t.moving:[],...[...this.paths].map(e=>t.scene.nodes.indexOf(e)).filter(e=>e>=0)])}find(){this.root.classList.remove("wide"),this.table.filter.focus()}escape(){this.help.hidden?this.pick(null):this.toggleHelp()}aim(t){for(let e of this.views)e.aim(e.scene.dim===2?"plane":t)}orbit(t,e,i){let n=this.views[0].scene.dim===3;this.views[0].orbit(n?t:0,n?e:0,i)}follow(t){t.request();for(let e of this.views)e!==t&&e.copyCamera(t)}diagrams(t,e=0){let{scene:i,frame:n}=this.views[e];return Ku(i,n,i.members.indexOf(t))}freeBody(t,e=0){let{scene:i,frame:n}=this.views[e];return pc(i,n,i.members.indexOf(t))}};var Lc=class{constructor(t){Object.assign(this,{show:t,words:"",timer:0})}wait(t,e){let i=performance.now()-e;this.words&&i>=200||(this.end(),this.timer=setTimeout(()=>this.say(t),Math.max(40,200-i)))}say(t){clearTimeout(this.timer),this.words=t,this.show(t)}end(){clearTimeout(this.timer),this.words&&this.say("")}};var fS=2e3,pS="The studio does not answer. Start it again, and open the address that it prints.",rr=class{constructor(t){Object.assign(this,{root:t,waiting:null,queue:[],wanted:null,closed:!1}),this.doing=x("p",{class:"busy",hidden:!0}),this.busy=new Lc(e=>this.showBusy(e))}ask(t,e=performance.now()){return new Promise(i=>{this.queue.push({command:t,resolve:i,since:e}),this.pump()})}pump(){if(!this.waiting&&!this.closed){let t=this.hurried()||this.queue.shift()||this.leisurely();t&&(this.waiting={resolve:()=>{},since:performance.now(),...t},this.post(JSON.stringify(t.command)))}this.watch()}hurried(){}leisurely(){}watch(){let t=this.waiting||this.queue[0];t?this.busy.wait("Computing ...",t.since):this.busy.end()}showBusy(t){this.doing.hidden=!t,this.doing.textContent=t,this.root.classList.toggle("awaiting",!!t)}async hear(t){let e=typeof t=="string"?JSON.parse(t):await this.unpacked(t);if(e.kind==="failed")return this.fail(e.message);if(e.kind==="busy"){(this.busy.words||!this.there)&&this.busy.say(e.text);return}if(this.heard(e))return this.pump();let{waiting:i}=this;this.waiting=null,i?.resolve(e),this.pump()}connect(){let t=this.page?`&page=${this.page}`:"",e=new WebSocket(`${location.origin.replace(/^http/,"ws")}${location.pathname}live?busy=1${t}`);e.binaryType="arraybuffer",e.addEventListener("open",()=>this.open(i=>e.send(i))),e.addEventListener("message",({data:i})=>this.hear(i)),e.addEventListener("close",()=>this.close())}fail(t,...e){window.kinetruss.failed=t,this.closed=!0,this.root.replaceChildren(x("div",{class:"failure"},x("p",{},t),...e)),this.root.dataset.state="failed"}close(){if(this.root.dataset.state!=="failed"){this.closed=!0;for(let{resolve:t}of[this.waiting,...this.queue].filter(Boolean))t({kind:"lost"});if(Object.assign(this,{waiting:null,queue:[],wanted:null}),this.busy.end(),!this.there)return this.fail(pS);this.setEnded(!0),setTimeout(()=>this.connect(),fS)}}setEnded(t,e=this.root){e.classList.toggle("ended",t);for(let i of e.querySelectorAll("input, select, button, textarea"))i.disabled=t}};var mS="xyz",Dc={azimuth:-Math.PI/2,elevation:Math.PI/2},Om={corner:[-.95,.5],top:[-Math.PI/2,Math.PI/2],front:[-Math.PI/2,0],side:[0,0]},gS=8,Fm=44,cd=(s,t)=>s[0]*t[0]+s[1]*t[1]+s[2]*t[2],Ta=s=>Number(s.toPrecision(12))||0,Uc=class{constructor(){Object.assign(this,{dim:2,centre:[0,0,0],scale:200,width:600,height:400,plane:{axis:2,at:0},step:null}),this.turnTo(Dc.azimuth,Dc.elevation)}setDim(t){if(t===this.dim)return;this.dim=t,this.plane={axis:2,at:0};let[e,i]=t===3?Om.corner:[Dc.azimuth,Dc.elevation];this.turnTo(e,i)}turnTo(t,e){this.azimuth=t,this.elevation=Math.min(Math.max(e,-Math.PI/2),Math.PI/2);let[i,n,r,a]=[Math.cos(t),Math.sin(t),Math.cos(this.elevation),Math.sin(this.elevation)].map(o=>Math.abs(o)<1e-15?0:o);this.right=[-n,i,0],this.up=[-a*i,-a*n,r],this.toward=[r*i,r*n,a]}turn(t,e){this.dim===3&&this.turnTo(this.azimuth+t,this.elevation+e)}look(t){this.turnTo(...Om[t])}face(){this.look({x:"side",y:"front",z:"top"}[mS[this.plane.axis]])}pan(t,e){this.centre=this.centre.map((i,n)=>i-(t*this.right[n]-e*this.up[n])/this.scale)}zoom(t,[e,i]=[this.width/2,this.height/2]){let[n,r]=[e-this.width/2,i-this.height/2];this.pan(-n,-r),this.scale=Math.min(Math.max(this.scale*t,.001),1e7),this.pan(n,r)}fit(t){if(!t.length){Object.assign(this,{centre:[0,0,0],scale:Math.min(this.width,this.height)/1.2});return}this.centre=[0,1,2].map(n=>(Math.min(...t.map(r=>r[n]||0))+Math.max(...t.map(r=>r[n]||0)))/2),this.scale=1;let e=t.map(n=>this.project(n)),i=[0,1].map(n=>Math.max(...e.map(r=>r[n]))-Math.min(...e.map(r=>r[n])));this.scale=Math.min(.62*this.width/(i[0]||1e-9),.62*this.height/(i[1]||1e-9),1e5),t.length===1&&(this.scale=Math.min(this.width,this.height)/1.2)}project(t){let e=[0,1,2].map(i=>(t[i]||0)-this.centre[i]);return[this.width/2+this.scale*cd(e,this.right),this.height/2-this.scale*cd(e,this.up),cd(e,this.toward)]}unproject([t,e],i=this.plane.at){let[n,r]=[(t-this.width/2)/this.scale,(this.height/2-e)/this.scale],a=this.centre.map((c,h)=>c+n*this.right[h]+r*this.up[h]),{axis:o}=this.plane;if(Math.abs(this.toward[o])<.08)return null;let l=(i-a[o])/this.toward[o];return a.map((c,h)=>h===o?i:c+l*this.toward[h])}get grid(){let t=Gn(Fm/this.scale);return this.step||(t*this.scale<.6*Fm?Gn(2.5*t):t)}snapped(t,e=[]){return t.map((i,n)=>{if(n===this.plane.axis)return i;let r=Ta(Math.round(i/this.grid)*this.grid),a=e.reduce((o,l)=>Math.abs((l[n]||0)-i)<Math.abs(o-i)?l[n]||0:o,1/0);return Math.abs(a-i)*this.scale<gS&&Math.abs(a-i)<Math.abs(r-i)?a:r})}get across(){return[0,1,2].filter(t=>t!==this.plane.axis)}};var xS=[.5,.38,.62,.26,.74],_S=(s,t)=>s[0]<t[2]&&t[0]<s[2]&&s[1]<t[3]&&t[1]<s[3],km=(s,t,e)=>[s-1,t-13+3,s+e+1,t+3],Oc=class{constructor(){this.taken=[]}begin(t){this.taken=t.map(([e,i])=>[e-6,i-6,e+6,i+6])}put(t,e,i,n){let r=e.find(([a,o])=>!this.taken.some(l=>_S(l,km(a,o,i))))||(n?e[0]:null);t.setAttribute("display",r?"inline":"none"),r&&(this.taken.push(km(...r,i)),t.setAttribute("x",r[0].toFixed(1)),t.setAttribute("y",r[1].toFixed(1)))}node(t,[e,i]){let n=7.4*t.textContent.length;this.put(t,[[e+9,i-9],[e-9-n,i-9],[e+9,i+17],[e-9-n,i+17]],n,!0)}member(t,e,i,n){let r=6.1*t.textContent.length,a=xS.flatMap(o=>{let[l,c]=[e[0]+o*(i[0]-e[0]),e[1]+o*(i[1]-e[1])];return[[l+5,c-5],[l-5-r,c-5],[l+5,c+15],[l-5-r,c+15]]});this.put(t,a,r,n)}};var yS=26;function zm(s,t){return Object.values(s.bodies||{}).map(({nodes:e})=>{let i=(e||[]).map(t).filter(Boolean),n=[0,1].map(o=>i.reduce((l,c)=>l+c[o]/i.length,0)),r=([o,l])=>Math.atan2(l-n[1],o-n[0]),a=i.toSorted((o,l)=>r(o)-r(l));return Yt("path",{class:"body",d:a.length>1?`M${a.map(([o,l])=>`${o.toFixed(1)} ${l.toFixed(1)}`).join("L")}Z`:""})})}function Gm(s,t,e){return Object.values(s.springs||{}).map(({coordinate:n})=>{if(n?.kind==="hinge")return Bm(t(n.axis?.[0]),t(n.start),t(n.end));let r=n?.kind==="angle"?e(n.bar)?.map(t):null;return r&&r[0]?Bm(r[0],[r[0][0]+1,r[0][1]],r[1]):null}).filter(Boolean)}function Bm(s,t,e){if(!s||!t||!e)return null;let[i,n]=[t,e].map(([o,l])=>Math.atan2(l-s[1],o-s[0])),r=(n-i+3*Math.PI)%(2*Math.PI)-Math.PI,a=Array.from({length:13},(o,l)=>{let c=yS+(l%2&&l>1&&l<11?5:0)-(l%2===0&&l>1&&l<11?5:0),h=i+r*l/12;return`${(s[0]+c*Math.cos(h)).toFixed(1)} ${(s[1]+c*Math.sin(h)).toFixed(1)}`});return Yt("path",{class:"spring",d:`M${a.join("L")}`})}var vS=60,bS=24,MS=46,SS=80,wS=24,pn=(s,t=!1)=>s.length?`M${s.map(([e,i])=>`${e.toFixed(2)} ${i.toFixed(2)}`).join("L")}${t?"Z":""}`:"",Fc=class{constructor(t){this.draw=t;let e=i=>Yt("g",{class:i});this.layers=Object.fromEntries(["picture","grid","bodies","curve","apart","bars","marks","nodes","names","rubber"].map(i=>[i,e(i)])),this.node=Yt("svg",{class:"drawing",tabindex:0,role:"application","aria-label":"drawing; arrow keys move the cursor, Enter draws there, Tab leaves"},...Object.values(this.layers)),this.names=new Oc,this.legend=x("div",{class:"legend",hidden:!0}),new ResizeObserver(()=>this.resize()).observe(this.node)}resize(){let{width:t,height:e}=this.node.getBoundingClientRect();!t||!e||(Object.assign(this.draw.camera,{width:t,height:e}),this.node.setAttribute("viewBox",`0 0 ${t} ${e}`),!this.sized&&this.draw.state&&this.draw.fit(),this.sized=!0,this.update())}rebuild(){let{state:t}=this.draw;this.places=new Map,this.bars=t.members.map(({name:e})=>Yt("path",{class:"bar","data-member":e})),this.circles=t.nodes.map(e=>Yt("circle",{class:"node","data-node":e,r:6})),this.labels=t.nodes.map(e=>Yt("text",{class:"name"},e)),this.tags=t.members.map(({name:e})=>Yt("text",{class:"tag"},e)),this.layers.bars.replaceChildren(...this.bars),this.layers.nodes.replaceChildren(...this.circles),this.layers.names.replaceChildren(...this.tags,...this.labels),this.index=new Map(t.nodes.map((e,i)=>[e,i])),this.update()}at(t){return this.seen[this.index.get(t)]}update(){let{state:t,camera:e,picked:i,shown:n}=this.draw;if(!t||!this.bars)return;this.seen=t.places.map(a=>e.project(a)),this.grid(),this.paint(t,i,n);let r=t.nodes.length<=SS;this.layers.names.setAttribute("display",n.names&&r?"inline":"none"),this.circles.forEach((a,o)=>{let[l,c]=this.seen[o];a.setAttribute("cx",l.toFixed(2)),a.setAttribute("cy",c.toFixed(2)),a.classList.toggle("picked",i.nodes.has(t.nodes[o]))}),n.names&&r&&this.place(t,i),this.marks(t),this.draw.picture.place(this.layers.picture),this.draw.curves.place(this.layers.curve),this.rubber()}paint(t,e,i){let n=this.draw.stale?null:t.force,r=(n||[]).filter(o=>o!==null).map(Math.abs),a=Math.max(...r,0)||1;this.legend.hidden=!i.force||!r.some(o=>o>0),ce(this.legend,x("b",{},"Force"),x("div",{class:"bar",style:`background: ${Da("diverging")}`}),x("div",{class:"ticks"},x("span",{},$t(-a,"N")),x("span",{},"0"),x("span",{},$t(a,"N"))),x("div",{class:"words"},x("span",{},"compression"),x("span",{},"tension")),t.unsure.length?x("div",{},"?: not unique, in the colour of its kind"):null),this.bars.forEach((o,l)=>{let{name:c,ends:h,kind:u}=t.members[l],[d,f]=h.map(m=>this.at(m));o.setAttribute("d",pn([d,f]));let p=n?.[l]??null,y=p!==null&&!t.unsure.includes(c);o.style.stroke=i.force&&y?`rgb(${yn("diverging",p,[-a,a]).map(Math.round).join(" ")})`:hi[u]||hi.rigid,o.classList.toggle("picked",e.members.has(c)),o.classList.toggle("apart",c in t.apart),o.classList.toggle("soft",u==="elastic"||u==="cable"||u==="free"),this.tags[l].textContent=i.force&&p!==null?`${c} ${$t(Math.abs(p)<1e-12*a?0:p,"N")}${y?"":" ?"}`:c})}place(t,e){this.names.begin(this.seen),this.labels.forEach((n,r)=>this.names.node(n,this.seen[r]));let i=t.members.map((n,r)=>r).sort((n,r)=>e.members.has(t.members[r].name)-e.members.has(t.members[n].name));for(let n of i){let{name:r,ends:a,goes_on:o}=t.members[n],l=e.members.has(r)&&!o;t.members.length<=wS&&!o||l?this.names.member(this.tags[n],this.at(a[0]),this.at(a[1]),l):this.tags[n].setAttribute("display","none")}}grid(){let{camera:t}=this.draw,[e,i]=t.across,{grid:n}=t,r=t.unproject([t.width/2,t.height/2]);if(!r){this.layers.grid.replaceChildren();return}let a=Math.min(vS,Math.ceil(.75*Math.hypot(t.width,t.height)/t.scale/n)),o=g=>Math.round(r[g]/n)-a,l=(g,M)=>{let w=[0,0,0];return[w[e],w[i],w[t.plane.axis]]=[g*n,M*n,t.plane.at],t.project(w)},[c,h]=[o(e),o(i)],[u,d]=[c+2*a,h+2*a],f={thin:"",axis:""};for(let g=c;g<=u;g++)f[g===0?"axis":"thin"]+=pn([l(g,h),l(g,d)]);for(let g=h;g<=d;g++)f[g===0?"axis":"thin"]+=pn([l(c,g),l(u,g)]);let p=t.project([0,0,0]),y=[..."xyz"].slice(0,t.dim).map((g,M)=>{let w=t.project([0,1,2].map(b=>b===M?34/t.scale:0));return Yt("text",{class:"axis-name",x:w[0],y:w[1]},g)}),m=[0,1,2].slice(0,t.dim).map(g=>pn([p,t.project([0,1,2].map(M=>M===g?28/t.scale:0))])).join("");this.layers.grid.replaceChildren(Yt("path",{class:"thin",d:f.thin}),Yt("path",{class:"zero",d:f.axis}),Yt("path",{class:"cross",d:m}),...y)}marks(t){let e=[];for(let a of t.supports)e.push(...this.support(a));for(let{unit:a,bar:o}of t.drives){let l=t.members.find(d=>d.name===o);if(!l)continue;let[c,h]=l.ends.map(d=>this.at(d)),u=Math.atan2(h[1]-c[1],h[0]-c[0]);a==="rad"?e.push(Yt("path",{class:"drive",d:`M${c[0]+15*Math.cos(u)} ${c[1]+15*Math.sin(u)}A15 15 0 1 1 ${c[0]+15*Math.cos(u+1.2)} ${c[1]+15*Math.sin(u+1.2)}`})):e.push(Yt("rect",{class:"drive",x:-11,y:-5,width:22,height:10,rx:3,transform:`translate(${(c[0]+h[0])/2} ${(c[1]+h[1])/2}) rotate(${u*180/Math.PI})`}))}let i=Math.max(...t.loads.map(({force:a})=>Math.hypot(...a)),0)||1;for(let{node:a,force:o}of t.loads){let l=t.places[this.index.get(a)];if(!l)continue;let c=this.at(a),{camera:h}=this.draw,u=h.project(l.map((d,f)=>d+(o[f]||0)/i*(MS/h.scale)));e.push(TS(u,c))}let n=a=>this.at(a),r=a=>t.members.find(o=>o.name===a)?.ends;this.layers.bodies.replaceChildren(...zm(t.data,n)),this.layers.marks.replaceChildren(...e,...Gm(t.data,n,r))}support({node:t,kind:e,along:i}){let n=this.draw.state.places[this.index.get(t)],{camera:r}=this.draw;if(!n)return[];let a=[n[0],n[1],n[2]||0],o=e==="pin"||e==="roller";return as({kind:e,along:i},a,bS/r.scale).map((l,c)=>Yt("path",{class:o&&c===0?"support":"support line","data-support":t,"data-kind":e,d:pn(l.map(h=>r.project(h)))}))}rubber(){let{camera:t,rubber:e,cursor:i}=this.draw,n=[];if(e?.from&&e.to&&n.push(Yt("path",{class:"rubber",d:pn([t.project(e.from),t.project(e.to)])})),e?.box&&n.push(Yt("path",{class:"box",d:pn([[e.box[0],e.box[1]],[e.box[2],e.box[1]],[e.box[2],e.box[3]],[e.box[0],e.box[3]]],!0)})),e?.to){let[r,a]=t.project(e.to);n.push(Yt("circle",{class:"hint",cx:r,cy:a,r:9}))}if(i){let[r,a]=t.project(i);n.push(Yt("path",{class:"cursor",d:`M${r-12} ${a}H${r+12}M${r} ${a-12}V${a+12}`}))}this.layers.rubber.replaceChildren(...n),this.draw.readout.update()}hit([t,e],i=!1,n=()=>!0){let{state:r}=this.draw,a=i?22:12,o=null;return this.seen.forEach((l,c)=>{let h=Math.hypot(l[0]-t,l[1]-e);h<=a&&n(r.nodes[c])&&(!o||h<o.apart-1e-6||h<o.apart+1e-6&&l[2]>o.depth)&&(o={type:"node",name:r.nodes[c],apart:h,depth:l[2]})}),o||(r.members.forEach(({name:l,ends:c})=>{let[h,u]=c.map(m=>this.at(m)),[d,f]=[u[0]-h[0],u[1]-h[1]],p=Math.min(1,Math.max(0,((t-h[0])*d+(e-h[1])*f)/(d*d+f*f||1))),y=Math.hypot(h[0]+p*d-t,h[1]+p*f-e);y<=(i?16:8)&&(!o||y<o.apart)&&(o={type:"member",name:l,apart:y})}),o)}};function TS(s,t){let e=Math.atan2(s[1]-t[1],s[0]-t[0]),i=n=>[s[0]-9*Math.cos(e+n),s[1]-9*Math.sin(e+n)];return Yt("path",{class:"load",d:pn([t,s])+pn([i(.42),s,i(-.42)])})}var ES=34,AS=/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;function CS(s){let t=s.trim();return t?AS.test(t)?Number(t):t:null}function ge(s,t,e,{hint:i="",size:n=9,name:r=s}={}){let a=x("input",{type:"text",size:n,"aria-label":r,placeholder:i,inputmode:"text",autocomplete:"off",spellcheck:"false"});a.dataset.size=n,Ea(a,t??"");let o=()=>{delete a.dataset.dirty,e(CS(a.value))};return a.addEventListener("input",()=>{a.dataset.dirty="yes",Vm(a)}),a.addEventListener("change",o),a.addEventListener("blur",()=>a.isConnected&&a.dataset.dirty&&o()),a.addEventListener("keydown",l=>{l.key==="Enter"&&a.blur(),l.key==="Escape"&&(Ea(a,t??""),delete a.dataset.dirty,a.blur())}),x("label",{class:"entry"},x("span",{},s),a)}function Ea(s,t){s.value=t,Vm(s)}function Vm(s){s.size=Math.min(Math.max(Number(s.dataset.size)||1,s.value.length),ES)}function Le(s,t,e,i,n=s){let r=x("select",{"aria-label":n},t.map(a=>Array.isArray(a)?x("option",{value:a[0]},a[1]):x("option",{value:a},a)));return r.value=e??"",r.addEventListener("change",()=>i(r.value)),x("label",{class:"entry"},x("span",{},s),r)}function kc(s,t,e,i=s){let n=x("input",{type:"checkbox","aria-label":i});return n.checked=t,n.addEventListener("change",()=>e(n.checked)),x("label",{class:"tick"},n,s)}function Qt(s,t,e={}){return x("button",{type:"button",onclick:t,...e},s)}function Ve(s,...t){let{activeElement:e}=s.ownerDocument,i=s.contains(e)?e.getAttribute("aria-label")||e.textContent:null,n=i&&e.tagName==="INPUT"&&e.type==="text"&&e.dataset.dirty?e.value:null,r=n===null?null:e.selectionStart;if(s.replaceChildren(...t.flat(4).filter(Boolean)),!i)return;let a=[...s.querySelectorAll("input, select, button, textarea")].find(o=>(o.getAttribute("aria-label")||o.textContent)===i);a&&(a.focus({preventScroll:!0}),n!==null&&(Ea(a,n),a.dataset.dirty="yes",a.setSelectionRange(r,r)))}var RS={mechanism:"moves",redundant:"redundant",drive:"drive",open:"does not close"},Bc=class{constructor(t){this.draw=t,this.doing=x("p",{class:"busy",hidden:!0}),this.words=x("div",{class:"words",role:"status","aria-live":"polite"}),this.tables=x("div",{}),this.mobility=x("pre",{}),this.node=x("section",{class:"verdicts","aria-label":"state of the drawing"},this.doing,this.words),this.details=x("div",{class:"state"},this.tables,x("details",{},x("summary",{},"Mobility"),this.mobility))}wait(t){this.doing.hidden=!t,this.doing.textContent=t}rebuild(){let{state:t}=this.draw,e=[];for(let a of t.missing)e.push(["",a,"missing"]);for(let{kind:a,text:o}of t.warnings)e.push([RS[a]||a,o]);for(let a of t.alarms)e.push(["limit",a]);for(let{text:a,line:o}of t.faults||[])e.push(["fault",o?`Line ${o}: ${a}`:a]);let i=t.hints||[],n=t.pins||[],r=JSON.stringify([e,i,n,t.why]);if(r!==this.last){this.last=r;let a=!e.length&&t.force;this.words.replaceChildren(x("p",{class:a?"good":""},a?`Stable, ${PS(t.drives.length)}. ${t.why}`:t.why),x("ul",{},e.slice(0,14).map(([o,l,c=o.split(" ")[0]])=>x("li",{class:`of-${c}`},o?x("b",{},o):null,o?" ":null,l)),i.map(o=>x("li",{},x("b",{},"note")," ",o)),n.map(({node:o,member:l})=>x("li",{},x("button",{type:"button",class:"pin",title:`${l} becomes a link through ${o}: stiff there, and pinned to what else is at ${o}`,onclick:()=>this.draw.edit({do:"pin",member:l,node:o})},`Pin ${o} to ${l}`)))))}this.mobility.textContent=t.mobility?t.mobility.text||"It follows when the pointer rests.":"",this.numbers(t)}numbers(t){let e=[];t.drives.length&&e.push(x("table",{class:"numbers"},x("tr",{},x("th",{},"drive"),x("th",{},"at"),x("th",{},hd(t.drives))),t.drives.slice(0,40).map(({name:r,unit:a,value:o,force:l})=>x("tr",{},x("th",{},r),x("td",{},$t(o,a)),x("td",{},l===null?"-":$t(l,a==="rad"?"N m":"N"))))));let i=[..."xyz"].slice(0,t.dim),n=Object.entries(t.reaction).slice(0,60);if(n.length){let r=t.reaction_moment,a=Object.keys(r).length?t.dim===3?i:["z"]:[],o=l=>l.map(c=>x("td",{},c===null?"-":ye(Math.abs(c)<1e-12*Math.max(...l.map(Math.abs))?0:c,4)));e.push(x("table",{class:"numbers"},x("tr",{},x("th",{},"reaction"),i.map(l=>x("th",{},`${l} (N)`)),a.map(l=>x("th",{},`M${l} (N m)`))),n.map(([l,c])=>x("tr",{},x("th",{},l),o(c),r[l]?o(r[l]):a.map(()=>x("td",{}))))))}Ve(this.tables,...e)}};function PS(s){return s?`with ${s===1?"one drive":`${s} drives`}`:"without a drive"}function hd(s){let t=s.filter(({unit:e})=>e==="rad").length;return t===s.length?"holding torque":t?"holding force or torque":"holding force"}var zc=class{constructor(t){Object.assign(this,{draw:t,on:null,found:null,stale:!1}),this.body=x("div",{}),this.plot=x("canvas",{class:"plot",role:"img","aria-label":"force of the drive along its range"}),this.note=x("p",{class:"faint",role:"status"}),this.node=be("Path of a node",this.body,this.note,this.plot),this.plot.hidden=!0}rebuild(){let{draw:t}=this,{state:e,picked:i}=t;if(!e)return;let n=e.drives.map(({name:a})=>a);this.on&&(!e.nodes.includes(this.on.node)||!n.includes(this.on.drive))&&this.stop();let r=[...i.nodes][0]||this.on?.node||e.nodes.at(-1)||"";this.wish={node:r,drive:this.on?.drive||n[0]||""},n.length?Ve(this.body,x("div",{class:"row"},Le("of node",e.nodes,r,a=>this.wish.node=a,"node of the path"),Le("by drive",n,this.wish.drive,a=>this.wish.drive=a,"drive of the path"),Qt("Show path",()=>this.start()),this.on?Qt("Hide",()=>{this.stop(),this.rebuild()}):null)):Ve(this.body,x("p",{class:"faint"},"A path needs a drive: pick a bar and choose its driven length or angle."))}start(){this.on={...this.wish},this.stale=!0,this.rebuild(),this.draw.pump()}stop(){Object.assign(this,{on:null,found:null,stale:!1}),this.note.textContent="",this.plot.hidden=!0,this.draw.canvas.update()}spoil(){this.on&&(this.stale=!0)}command(){return this.stale=!1,{do:"curve",...this.on}}take(t){if(!this.on)return;this.found=t,this.note.textContent=t.stopped,this.draw.canvas.update(),this.plot.hidden=!1;let e=t.unit==="rad"?"N m":"N",i=t.unit==="rad"?180/Math.PI:1,n=t.values.map(a=>a*i),r=t.force.map(a=>a??NaN);fn(this.plot,[{x:n,y:r,label:t.drive}],{unit:e,xUnit:t.unit==="rad"?"deg":"m",title:hd([t])})}failed(t,e){!this.on||e?.command||!t.startsWith("No")||(this.found=null,this.note.textContent=t,this.plot.hidden=!0,this.draw.canvas.update())}place(t){if(!this.found)return t.replaceChildren();let{camera:e}=this.draw,i=this.found.path.map(n=>e.project(n));t.replaceChildren(Yt("path",{class:"curve",d:`M${i.map(([n,r])=>`${n.toFixed(2)} ${r.toFixed(2)}`).join("L")}`}))}};var Hm=`.sheetpane { flex: 1; min-width: 0; position: relative; display: flex; }
.drawing { flex: 1; width: 100%; height: 100%; min-height: 260px; touch-action: none; cursor: crosshair; user-select: none; }
.drawing:focus-visible { outline-offset: -2px !important; }
.drawing .thin { stroke: var(--line); stroke-width: 0.6; fill: none; }
.drawing .zero { stroke: var(--faint); stroke-width: 1; fill: none; opacity: 0.55; }
.drawing .cross { stroke: var(--faint); stroke-width: 2; fill: none; }
.drawing text { fill: var(--ink); font-size: 12px; paint-order: stroke; stroke: var(--back); stroke-width: 3px; pointer-events: none; }
.drawing .axis-name, .drawing .tag { fill: var(--faint); font-size: 11px; }
.drawing .name { font-weight: 600; }
.drawing .bar { stroke-width: 5; stroke-linecap: round; fill: none; }
.drawing .bar.soft { stroke-dasharray: 9 5; }
.drawing .bar.apart { stroke: var(--alarm) !important; stroke-dasharray: 3 6; }
.drawing .bar.picked { stroke-width: 8; filter: drop-shadow(0 0 2px var(--halo)) drop-shadow(0 0 2px var(--halo)); }
.drawing .node { fill: var(--card); stroke: var(--ink); stroke-width: 2; }
.drawing .node.picked { fill: var(--halo); stroke: var(--halo); }
.drawing .support { fill: var(--faint); stroke: none; opacity: 0.85; }
.drawing .support.line { fill: none; stroke: var(--faint); stroke-width: 1.6; opacity: 1; }
.drawing .drive { fill: none; stroke: var(--pen-3); stroke-width: 2.5; }
.drawing .body { fill: var(--faint); fill-opacity: 0.22; stroke: var(--faint); stroke-width: 2; stroke-linejoin: round; }
.drawing .spring { fill: none; stroke: #c66b9d; stroke-width: 2; }
.drawing .load { fill: none; stroke: #8a4fbf; stroke-width: 2.5; }
.drawing .curve { fill: none; stroke: var(--pen-1); stroke-width: 2; }
.drawing .rubber { stroke: var(--accent); stroke-width: 3; stroke-dasharray: 6 5; fill: none; }
.drawing .hint { fill: none; stroke: var(--accent); stroke-width: 1.5; }
.drawing .box { fill: color-mix(in srgb, var(--accent) 14%, transparent); stroke: var(--accent); }
.drawing .cursor { stroke: var(--halo); stroke-width: 2; }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); margin: 0; }
.rail .operate { color: var(--accent); font-size: 13px; }
#kinetruss .rail button, #kinetruss .rail select, #kinetruss .rail input { min-height: 44px; min-width: 44px; }
#kinetruss .rail input { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 5px; padding: 2px 6px; }
#kinetruss .rail button:disabled { opacity: 0.45; cursor: default; }
.rail .group { align-items: center; }
#kinetruss .sketch { width: 400px; border-right: 0; border-left: 1px solid var(--line); }
#kinetruss .sketch button, #kinetruss .sketch select, #kinetruss .sketch input[type="text"] { min-height: 44px; }
#kinetruss .sketch button.link { min-height: 24px; }
#kinetruss .sketch input[type="checkbox"] { width: 20px; height: 20px; }
#kinetruss .sketch input[type="file"] { max-width: 100%; font: inherit; min-height: 44px; }
.entry { display: inline-flex; gap: 5px; align-items: center; }
.entry span { color: var(--faint); }
.tick { display: inline-flex; gap: 5px; align-items: center; min-height: 44px; min-width: 44px; }
#kinetruss .sketch { display: flex; flex-direction: column; padding: 0; overflow: hidden; }
.sketch .head { flex: none; padding: 8px 14px 4px; border-bottom: 1px solid var(--line); }
.sketch .parts { flex: 1; min-height: 0; overflow-y: auto; padding: 0 14px 8px; }
.sketch .state { padding-top: 6px; }
.sketch .head .banner { position: static; }
.sketch .verdicts { position: relative; min-height: 26px; }
.sketch .verdicts .busy { position: absolute; inset: 0 0 auto; margin: 0; }
.sketch .state .numbers tr:first-child > * { position: sticky; top: 0; z-index: 1; background: var(--card); }
.sheetpane .busy { position: absolute; bottom: 44px; left: 50%; translate: -50% 0; margin: 0; max-width: calc(100% - 20px); padding: 4px 12px; border: 1px solid var(--line); border-left: 4px solid var(--accent); border-radius: 5px; background: var(--card); pointer-events: none; z-index: 1; }
.stale .sketch .words, .stale .sketch .state, .stale .sketch .span { visibility: hidden; }
.awaiting .sketch .plot, .awaiting .drawing .curve { opacity: 0.35; }
.readout { position: absolute; left: 10px; bottom: 8px; display: flex; flex-wrap: wrap; gap: 2px 14px; align-items: center; max-width: calc(100% - 20px); padding: 2px 6px; border-radius: 4px; background: color-mix(in srgb, var(--card) 85%, transparent); color: var(--faint); font-size: 12px; font-variant-numeric: tabular-nums; pointer-events: none; }
.readout button { pointer-events: auto; font-size: 12px; }
.rail { user-select: none; }
.sketch .words { max-height: 210px; overflow: auto; }
.sketch .words p { margin: 4px 0; }
.sketch .state { border-bottom: 1px solid var(--line); padding-bottom: 6px; }
.sketch .words .good { color: var(--pen-3); font-weight: 600; }
.sketch .words ul, .sketch .faults, .sketch .versions { list-style: none; margin: 4px 0; padding: 0; }
.sketch .words li { border-left: 4px solid var(--line); padding: 2px 8px; margin: 3px 0; overflow-wrap: anywhere; }
.sketch .words .of-moves, .sketch .words .of-drive { border-color: var(--pen-2); }
.sketch .words .of-limit, .sketch .words .of-fault, .sketch .words .of-does { border-color: var(--alarm); }
.sketch .words .of-redundant { border-color: var(--pen-1); }
.sketch .text { display: flex; border: 1px solid var(--line); border-radius: 5px; overflow: hidden; }
.sketch .lines { margin: 0 !important; padding: 6px 4px; color: var(--faint); text-align: right; overflow: hidden; min-width: 34px; height: 340px; background: var(--back); font: 12px/1.45 ui-monospace, monospace !important; }
.sketch .lines .faulty { color: #fff; background: var(--alarm); display: inline-block; width: 100%; }
.sketch textarea { flex: 1; min-width: 0; height: 340px; border: 0; padding: 6px; font: 12px/1.45 ui-monospace, monospace; color: inherit; background: var(--card); resize: none; white-space: pre; overflow: auto; }
.sketch .about { white-space: pre-wrap; max-height: 200px; overflow: auto; }
.sketch .form fieldset { margin: 6px 0; min-width: 0; }
#kinetruss .sketch .form select { max-width: 190px; }
.sketch .plot { height: 130px; }
.ended .drawing { opacity: 0.6; pointer-events: none; }
@media (max-width: 820px) {
  #kinetruss .sketch { display: block; width: auto; max-height: none; overflow: visible; border-left: 0; border-top: 1px solid var(--line); }
  .sketch .parts { overflow: visible; }
  .sheetpane { height: 56vh; flex: none; }
  #kinetruss[data-live="draw"] main { display: flex; }
}
@media (min-width: 821px) and (max-width: 1180px) {
  #kinetruss[data-live="draw"] main { display: flex; }
  #kinetruss .sketch { width: 350px; }
}
@media not all and (any-pointer: coarse) {
  .rail .several { display: none; }
}
.readout span:empty { display: none; }
`;var Xm=/[:#{}[\],&*!|>'"%@`]|^[-?]/;function Gc(s){return s==null?"":Array.isArray(s)?`[${s.map(Gc).join(", ")}]`:typeof s=="object"?`{${Object.entries(s).map(([t,e])=>`${t}: ${Gc(e)}`).join(", ")}}`:typeof s=="string"&&Xm.test(s)?JSON.stringify(s):String(s)}var NS=({type:s,of:t})=>s==="value"||s==="choice"||s==="text"||s==="flag"||s==="any"||s==="list"&&t.type!=="record",ar=class{constructor(t,e){Object.assign(this,{draw:t,again:e,drafts:new Map,open:new Set})}get forms(){return this.draw.choices.forms}entry(t,e){let i=[t,e],n=this.forms.tables[t],r=this.draw.state.data[t]?.[e],a={nodes:"at",bars:"ends",beams:"ends",links:"nodes"}[t],o=Array.isArray(r)&&a?{[a]:r}:r;return n.type!=="record"||o!==void 0&&typeof o!="object"?this.field(this.live(),n,e,o,i):this.record(this.live(),n,t,o,i,!0)}live(){return{set:(t,e)=>this.draw.edit({do:"set",path:t,value:e,typed:!0}),draft:!1}}begin(t,e={}){this.drafts.set(t.join("."),e),this.again()}drafting(t){let e=t.join("."),i=this.drafts.get(e),n=(o,l)=>{let c=o.slice(t.length),h=c.pop(),u=i;for(let d of c)u=u[d]??={};l===null?delete u[h]:u[h]=l,this.again()},r=async()=>{(await this.live().set(t,i)).kind==="drawing"&&(this.drafts.delete(e),this.again())},a=()=>{this.drafts.delete(e),this.again()};return{context:{set:n,draft:!0},root:i,actions:x("div",{class:"row"},Qt("Apply",r,{"aria-label":`apply ${e}`}),Qt("Cancel",a,{"aria-label":`cancel ${e}`}))}}field(t,e,i,n,r){if(e.type==="record")return this.record(t,e,i,n,r);if(e.type==="table"&&NS(e.of))return this.table(t,e,i,n,r);let a=r.join(".");if(e.type==="flag"||e.type==="choice"&&!e.free){let f=(e.type==="flag"?[!0,!1]:e.of).map(String);return Le(Dn(i),[["",e.default===void 0?"-":`${e.default} (default)`],...f],n==null?"":String(n),p=>t.set(r,p||null),a)}let o=e.type==="list"&&e.of.type!=="record",l=o&&Array.isArray(n)?Gc(n).slice(1,-1):typeof n=="string"?n:Gc(n),c=e.unit??(o?e.of.unit:""),h=f=>{if(f===null)return t.set(r,null);let p=String(f);return o&&!p.startsWith("[")?t.set(r,e.of.type==="list"?`[[${p}]]`:`[${p}]`):t.set(r,e.type==="text"&&Xm.test(p)?JSON.stringify(p):p)},u=e.default!==void 0&&typeof e.default!="object"?`${e.default}${c?` ${c}`:""}`:c||(o?"a, b":""),d=ge(Dn(i),l,h,{hint:u,size:o||e.type==="any"?16:9,name:a});return Wm(d,a,e.type==="choice"?e.of.map(String):this.names(e)),c&&l!==""&&(d.title=c),d}table(t,e,i,n,r){let a=Object.entries(n||{}).map(([h,u])=>x("div",{class:"row"},this.field(t,e.of,h,u,[...r,h]))),o=r.join("."),l=[["name","",""],["value",e.of.unit||"",e.of.type]].map(([h,u])=>ge(h,"",()=>{},{hint:u,size:8,name:`new ${h} in ${o}`}));Wm(l[0],`keys ${o}`,this.names(e.keys));let c=()=>{let[h,u]=l.map(d=>d.querySelector("input").value.trim());h&&u&&t.set([...r,h],e.of.type==="list"&&!u.startsWith("[")?`[${u}]`:u)};return x("fieldset",{},x("legend",{},Dn(i)),a,x("div",{class:"row"},l,Qt("Add",c,{"aria-label":`add to ${o}`})))}record(t,e,i,n,r,a=!1){let o=r.join("."),{records:l}=this.forms,c=!t.draft&&this.drafts.has(o)?this.drafting(r):null,h=c?c.root:n,u=c?c.context:t,d=h!==null&&typeof h=="object",f=d?e.of.find(_=>l[_].kind===h.kind)||e.of[0]:null,p=_=>{let T=l[_].kind?{kind:l[_].kind}:{};u.draft?u.set(r,T):this.begin(r,T)},y=this.names(e),m=[...a?[]:[["","-"]],...y,...e.of.map(_=>[`: ${_}`,e.of.length>1?Dn(l[_].kind||_):y.length?"own values ...":"given"])],g=_=>{_.startsWith(": ")?p(_.slice(2)):(c&&this.drafts.delete(o),t.set(r,_||null))},M=d?`: ${f}`:n??"";typeof M=="string"&&M&&!m.some(_=>(Array.isArray(_)?_[0]:_)===M)&&m.push(M);let w=d&&e.of.length<2&&!y.length,b=w?null:Le(d?"kind":Dn(i),m,M,g,o),C=w&&!a&&!e.needed&&!c?Qt("Remove",()=>t.set(r,null),{"aria-label":`remove ${o}`}):null;if(!d)return b;let E=[b,C,this.fields(u,f,h,r),c?.actions];return a?x("div",{class:"form"},E):x("fieldset",{class:"form"},x("legend",{},Dn(i)),E)}fields(t,e,i,n){let{fields:r,about:a}=this.forms.records[e],o=n.join("."),[l,c]=[[],[]];for(let[u,d]of Object.entries(r))(u in i||d.needed?l:c).push(this.field(t,d,u,i[u],[...n,u]));let h=(u,d)=>{let f=`${u} ${o}`,p=x("details",{open:this.open.has(f)},x("summary",{"aria-label":`${u} of ${o}`},u),d);return p.addEventListener("toggle",()=>p.open?this.open.add(f):this.open.delete(f)),p};return[x("div",{class:"row"},l),c.length?h("More fields",x("div",{class:"row"},c)):null,a&&n.length===2?h("What they mean",x("pre",{class:"about"},a)):null]}names({names:t=[],also:e=[]}){let{data:i}=this.draw.state,n=(a,o)=>a!=="poses"&&(a!=="bars"||!t.includes("drives")||o.kind==="driven"),r=a=>Object.entries(i[a]||{}).filter(([,o])=>n(a,o)).map(([o])=>o);return[...new Set([...t.flatMap(a=>[...r(a),...this.draw.choices[a]||[]]),...e])]}};function Wm(s,t,e){if(!e.length)return;let i=`names-${t.replace(/[^\w-]/g,"_")}`;s.querySelector("input").setAttribute("list",i),s.append(x("datalist",{id:i},e.map(n=>x("option",{value:n}))))}function Dn(s){return s.replaceAll("_"," ")}var $m=["active","beams","links","bodies","springs","drives","loads","load_cases","trajectories"],LS=300,DS={bodies:"body",trajectories:"trajectory",load_cases:"case",poses:"pose"},Vc=class{constructor(t){Object.assign(this,{draw:t,table:"springs",name:"",ran:{}}),this.forms=new ar(t,()=>this.rebuild()),this.body=x("div",{}),this.runs=x("div",{}),this.node=be("Entries of the model",this.body),this.runsNode=be("Runs",this.runs),this.node.open=!1}show([t,e]){let i=t==="runs";Object.assign(this,i?{run:e}:{table:t,name:e}),(i?this.runsNode:this.node).open=!0,this.rebuild()}rebuild(){let{draw:t}=this,{state:e}=t;e&&(this.entries(e.data),this.listRuns(e.data.runs||{}))}entries(t){let{tables:e}=this.draw.choices.forms,i=l=>Object.keys(t[l]||{}).length,n=Object.keys(e).filter(l=>l!=="runs"&&(!(l in t)||!Array.isArray(t[l]))),r=[...$m,...n.filter(l=>!$m.includes(l))],a=Object.keys(t[this.table]||{}),o=[...this.forms.drafts.keys()].filter(l=>l.startsWith(`${this.table}.`)&&!a.includes(l.slice(this.table.length+1))&&l.split(".").length===2).map(l=>l.slice(this.table.length+1));[...a,...o].includes(this.name)||(this.name=a[0]||o[0]||""),Ve(this.body,x("div",{class:"row"},Le("Table",r.map(l=>[l,`${Dn(l)} (${i(l)})`]),this.table,l=>{Object.assign(this,{table:l,name:""}),this.rebuild()},"table of entries"),Le("Entry",[...a,...o.map(l=>[l,`${l} (new)`])],this.name,l=>{this.name=l,this.rebuild()},"entry"),Qt("New",()=>this.fresh(),{"aria-label":"new entry"})),x("p",{class:"faint"},e[this.table].about),this.name?this.form(this.table,this.name):null)}form(t,e){let i=e in(this.draw.state.data[t]||{});return x("div",{},i?x("div",{class:"row"},this.naming(t,e),Qt("Delete",()=>this.draw.edit({do:"set",path:[t,e],value:null}),{"aria-label":`delete ${t} ${e}`})):null,this.forms.entry(t,e))}naming(t,e){return ge("Name",e,async n=>{if(n===null)return this.rebuild();(await this.draw.edit({do:"rename",table:t,old:e,new:String(n)})).kind==="drawing"&&this.show([t,String(n)])},{name:`name of ${t} ${e}`})}fresh(){let{table:t}=this,e=this.draw.choices.forms.tables[t],i=DS[t]||t.replace(/s$/,""),n=this.draw.state.data[t]||{},r=1;for(;`${i}${r}`in n||this.forms.drafts.has(`${t}.${i}${r}`);)r++;this.name=`${i}${r}`;let{kind:a}=e.type==="record"?this.draw.choices.forms.records[e.of[0]]:{};this.forms.begin([t,this.name],a?{kind:a}:{})}listRuns(t){let e=Object.keys(t),{doing:i}=this;e.includes(this.run)||(this.run=e[0]||"");let n=()=>this.draw.make("run");Ve(this.runs,x("div",{class:"row"},e.length?Le("Run",e,this.run,r=>{this.run=r,this.rebuild()},"run"):x("span",{class:"faint"},"No run yet: a run moves the drives, or computes the equilibrium."),Qt("New run",n),this.run&&!i?Qt("Do it",()=>this.start(this.run),{"aria-label":`do run ${this.run}`}):null),i?this.progress(i):null,i?.name===this.run?null:this.result(this.ran[this.run]),this.run?this.form("runs",this.run):null)}progress({name:t,done:e,total:i}){return this.bar=x("progress",{max:i||1,value:e||void 0,"aria-label":`progress of ${t}`}),this.share=x("span",{role:"status","aria-live":"off"},qm(this.doing)),x("div",{class:"row doing"},this.share,this.bar,Qt("Stop",()=>this.stop(),{"aria-label":`stop run ${t}`}))}result(t){if(!t)return null;let e=t.revision!==this.draw.state.revision;return x("div",{role:"status"},x("pre",{class:"about"},t.words),e?x("p",{class:"faint"},"The drawing has changed since."):null,t.number?x("a",{href:`result/${t.number}`,target:"_blank",rel:"noopener"},"Show the result"):null)}async start(t){this.doing={name:t},this.rebuild(),this.hear(await this.draw.ask({do:"run",name:t}))}async stop(){let{name:t}=this.doing||{},e=await this.draw.ask({do:"stop"});this.hear(e),e.kind==="stopped"&&this.draw.tell(`The run ${t} was stopped.`)}hear(t){clearTimeout(this.timer);let e=this.doing;if(this.doing=t.kind==="running"?t:null,this.doing?this.timer=setTimeout(()=>this.follow(),LS):t.kind==="ran"&&(this.ran[t.name]=t,this.draw.tell(`The run ${t.name} is done.`)),!this.doing||!e)return this.rebuild();this.bar.max=t.total||1,t.done&&(this.bar.value=t.done),this.share.textContent=qm(t)}async follow(){this.doing&&this.hear(await this.draw.ask({do:"running"}))}take(t){t?.kind==="running"?this.hear(t):t?.kind==="ran"&&(this.ran[t.name]=t)}};function qm({name:s,done:t,total:e,what:i="samples",note:n=""}){return`Computing ${s}${e?`: ${t} of ${e} ${i}`:" ..."}${n?`. ${n}`:""}`}var Hc=class{constructor(t){this.draw=t,this.name=x("input",{type:"text","aria-label":"file name",size:18}),this.rows=x("ul",{class:"versions"}),this.offer=x("p",{class:"banner",hidden:!0}),this.ask=x("p",{class:"banner warning",hidden:!0}),this.body=x("div",{},this.ask,x("div",{class:"row"},this.name,Qt("Save",()=>this.save(),{title:"Save (Ctrl+S)"})),x("div",{class:"row"},Qt("Keep this state",()=>this.list({do:"keep"})),Qt("Show versions",()=>this.list({do:"versions"}))),this.rows),this.node=be("Save and versions",this.body,x("p",{class:"faint"},"Every edit is kept beside the file, in the folder .kinetruss, until it is saved."))}rebuild(){let{state:t}=this.draw;this.body.hidden=!t.writable,t.offered||(this.offer.hidden=!0),this.name.value||(this.name.value=t.file||"model.yaml"),t.saved&&this.list({do:"versions"})}async save(t=!1){this.ask.hidden=!0;let e=this.name.value.trim();e&&!/[./\\]/.test(e)&&(this.name.value=`${e}.yaml`);let i=await this.draw.ask({do:"save",name:this.name.value.trim(),replace:t});i.kind==="exists"&&(this.ask.hidden=!1,this.ask.replaceChildren(`${i.message} `,Qt("Overwrite",()=>this.save(!0))),this.draw.tell(i.message,!0),this.node.open=!0,this.ask.scrollIntoView({block:"nearest"}))}async list(t){let{rows:e}=await this.draw.ask(t);if(!e)return;let i=n=>new Date(1e3*n).toLocaleString();this.rows.replaceChildren(...e.length?e.toReversed().map(({number:n,when:r,words:a})=>x("li",{},Qt(`Back to ${n}`,()=>this.draw.ask({do:"restore",number:n})),` ${a}, ${i(r)}`)):[x("li",{},"No version yet.")])}setOffer(t){if(this.offer.hidden=!t,!t)return;let e=async i=>{this.offer.hidden=!0,await this.draw.ask({do:"draft",keep:i}),this.draw.fit()};this.offer.replaceChildren(`A drawing of ${t.lines} lines was not saved when its studio ended, ${new Date(1e3*t.when).toLocaleString()}. `,Qt("Go on with it",()=>e(!0))," ",Qt("Remove it",()=>e(!1)))}};var Wc=class{constructor(t){Object.assign(this,{draw:t,values:{}}),this.body=x("div",{}),this.node=be("Copy, mirror, stack",this.body),this.node.open=!1}field(t,e,i,n){return ge(t,this.values[e]??i,r=>this.values[e]=r,{size:6,name:n})}value(t,e){return this.values[t]??e}nodes(){let{picked:t,state:e}=this.draw,i=e.members.filter(({name:n})=>t.members.has(n)).flatMap(({ends:n})=>n);return[...new Set([...t.nodes,...i])]}rebuild(){let{draw:t}=this,{state:e}=t;if(!e)return;let i=[..."xyz"].slice(0,e.dim),n=this.nodes().length,r=()=>t.edit({do:"copy",nodes:this.nodes(),by:i.map(h=>this.value(`d${h}`,0)),count:this.value("count",1)}).then(()=>t.reveal()),a=()=>t.edit({do:"mirror",nodes:this.nodes(),axis:this.value("axis","x"),at:this.value("at",0)}).then(()=>t.reveal()),o=()=>t.edit({do:"stack",cell:this.value("cell",c[0]),count:this.value("cells",1)}).then(h=>h.kind==="drawing"&&t.fit()),l=["triangle","panel"],c=t.choices.cells.filter(h=>l.includes(h)===(e.dim===2));Ve(this.body,x("p",{class:"faint"},n?`${n} node${n===1?" is":"s are"} picked.`:"No node is picked: Shift-click, Shift-drag a box, or Ctrl+A."),x("fieldset",{},x("legend",{},"Copy, shifted by"),x("div",{class:"row"},i.map(h=>this.field(h,`d${h}`,0,`shift of copies along ${h}`)),this.field("times","count",1,"number of copies"),Qt("Copy",r))),x("fieldset",{},x("legend",{},"Mirror in the plane"),x("div",{class:"row"},Le("",i,this.value("axis","x"),h=>this.values.axis=h,"mirror axis"),this.field("=","at",0,"place of the mirror"),Qt("Mirror",a))),x("fieldset",{},x("legend",{},"Cells of the library"),x("div",{class:"row"},Le("",c,this.value("cell",c[0]),h=>this.values.cell=h,"cell"),this.field("times","cells",1,"number of cells"),Qt("Stack",o))))}};var US=3e6,OS=1600;function FS(s){return new Promise(t=>{let e=new FileReader;e.addEventListener("load",()=>t(e.result)),e.addEventListener("error",()=>t("")),e.readAsDataURL(s)})}function kS(s,{width:t,height:e}){let i=Math.min(1,OS/Math.max(t,e)),n=x("canvas",{width:Math.round(i*t),height:Math.round(i*e)});return n.getContext("2d").drawImage(s,0,0,n.width,n.height),n.toDataURL("image/jpeg",.85)}var Xc=class{constructor(t){Object.assign(this,{draw:t,image:null,placing:null,points:[],opacity:.5,shown:!0}),this.file=x("input",{type:"file",accept:"image/*","aria-label":"picture to trace",onchange:()=>this.load()}),this.body=x("div",{}),this.node=be("Picture to trace",this.file,this.body),this.node.open=!1,this.image=null}async load(){let[t]=this.file.files;if(!t)return;let e=await FS(t),i=new Image;i.addEventListener("load",()=>{let{camera:n}=this.draw,{axis:r,at:a}=n.plane,[o,l]=n.across,c=.6*Math.min(n.width,n.height)/n.scale/Math.max(i.naturalWidth,i.naturalHeight),h=n.unproject([n.width/2,n.height/2])||[0,0,0];h[o]-=c*i.naturalWidth/2,h[l]+=c*i.naturalHeight/2,this.loaded=i,this.image={source:i.src,width:i.naturalWidth,height:i.naturalHeight,axes:[o,l],axis:r,at:a,turn:[c,0],origin:[h[o],h[l]]},this.points=[],this.rebuild(),this.draw.canvas.update(),this.keep(!0)}),i.addEventListener("error",()=>this.draw.tell("This file is no picture that the browser can show.",!0)),i.src=e}async keep(t=!1){if(!this.image||this.draw.closed)return;let{source:e,...i}=this.image,n={do:"picture",place:{...i,opacity:this.opacity,shown:this.shown}};t&&(n.source=e.length<US?e:kS(this.loaded,i)),await this.draw.ask(n)}take(t){if(!t||this.image)return;let{opacity:e,shown:i,...n}=t.place;Object.assign(this,{image:{...n,source:t.source},opacity:e,shown:i}),this.rebuild()}remove(){this.image=null,this.file.value="",Ve(this.body),this.draw.canvas.update(),this.draw.ask({do:"picture",place:null})}rebuild(){if(!this.image)return;let t=x("input",{type:"range",min:0,max:1,step:.05,value:this.opacity,"aria-label":"opacity of the picture"});t.addEventListener("input",()=>{this.opacity=Number(t.value),this.draw.canvas.update()}),t.addEventListener("change",()=>this.keep());let e=["Click the first point in the picture.","Click the second point in the picture."];Ve(this.body,x("div",{class:"row"},kc("shown",this.shown,i=>{this.shown=i,this.draw.canvas.update(),this.keep()}),t,Qt("Remove",()=>this.remove(),{"aria-label":"remove the picture"})),Qt("Place by two points",()=>this.begin()),this.placing?x("p",{role:"status"},e[this.points.length]||""):null,this.points.length===2&&!this.placing?this.entries():null)}begin(){Object.assign(this,{placing:!0,points:[]}),this.rebuild(),this.draw.tell("Click the first point in the picture.")}click(t){let{origin:e,turn:i,axes:n,at:r}=this.image,a=this.draw.camera.unproject(t,r);if(!a)return;let[o,l]=[a[n[0]]-e[0],a[n[1]]-e[1]],[c,h]=i,u=c*c+h*h;this.points.push([(c*o+h*l)/u,(h*o-c*l)/u]),this.points.length===2&&(this.placing=null),this.draw.tell(this.points.length===2?"Now write where the two points are.":"Click the second point in the picture."),this.rebuild()}entries(){let t=this.image.axes.map(n=>"xyz"[n]),e=["first","second"].map((n,r)=>t.map((a,o)=>ge(a,r&&!o?1:0,()=>{},{size:5,name:`${a} of the ${n} point in m`}))),i=()=>{let n=e.map(r=>r.map(a=>Number(a.querySelector("input").value)));if(n.flat().some(r=>!Number.isFinite(r)))return this.draw.tell("Write the places as numbers, in m.",!0);this.fit(n)};return x("fieldset",{},x("legend",{},"Their places (m)"),e.map(n=>x("div",{class:"row"},n)),Qt("Place",i))}fit([t,e]){let[i,n]=this.points.map(([d,f])=>[d,-f]),[r,a]=[n[0]-i[0],n[1]-i[1]],[o,l]=[e[0]-t[0],e[1]-t[1]],c=r*r+a*a;if(!c||!(o||l))return this.draw.tell("The two points coincide. Choose two that are far apart.",!0);let[h,u]=[(r*o+a*l)/c,(r*l-a*o)/c];this.image.turn=[h,u],this.image.origin=[t[0]-h*i[0]+u*i[1],t[1]-u*i[0]-h*i[1]],this.points=[],this.rebuild(),this.draw.tell(""),this.draw.canvas.update(),this.keep()}place(t){let{image:e,draw:i}=this;if(!e||!this.shown)return t.replaceChildren();let[n,r]=e.axes,[a,o]=e.turn,l=(f,p)=>{let y=[0,0,0];return[y[n],y[r],y[e.axis]]=[e.origin[0]+a*f+o*p,e.origin[1]+o*f-a*p,e.at],i.camera.project(y)},[c,h,u]=[l(0,0),l(1,0),l(0,1)],d=[h[0]-c[0],h[1]-c[1],u[0]-c[0],u[1]-c[1],c[0],c[1]];this.element||=Yt("image",{});for(let[f,p]of Object.entries({href:e.source,width:e.width,height:e.height,opacity:this.opacity,preserveAspectRatio:"none",transform:`matrix(${d.join(" ")})`}))this.element.setAttribute(f,p);t.replaceChildren(this.element)}};var BS=[["rigid","rigid"],["driven","driven length"],["elastic","elastic (spring)"],["cable","cable"],["free","free (measures only)"]],ud=[["active","active member (rods, screw, motor)"],["beam","beam (bends)"],["link","link (more pins)"]],zS={angle_spring:"Angle spring",body:"Body"},Ym=12,mn=[..."xyz"],$c=class{constructor(t){this.draw=t,this.body=x("div",{}),this.forms=new ar(t,()=>this.rebuild()),this.node=be("Picked",this.body)}set(t,e){return this.draw.edit({do:"set",path:t,value:e})}entry(t,e){let i=this.draw.state.data[t]?.[e];return Array.isArray(i)?{[{nodes:"at",links:"nodes"}[t]||"ends"]:i}:i||{}}rebuild(){let{draw:t}=this,{picked:e,state:i}=t;if(!i)return;let n=[...e.nodes],r=[...e.members],a=this.lists(i,n,r);n.length===1&&!r.length?Ve(this.body,a,this.ofNode(n[0]),this.newNode()):r.length===1&&!n.length?Ve(this.body,a,this.ofMember(r[0])):Ve(this.body,a,x("p",{class:"faint"},n.length+r.length?[jm(n,"node"),jm(r,"member")].filter(Boolean).join("; "):"Nothing is picked."),r.length>1?this.ofMany(r):null,this.making([...r.length===2?["angle_spring"]:[],...n.length+r.length>1?["body"]:[]]),n.length?null:this.newNode(),i.nodes.length?null:this.other(i.dim))}lists(t,e,i){let n=(r,a,o,l)=>Le(a,[["","-"],...o],l.length===1?l[0]:"",c=>this.draw.pick(c?{type:r,name:c}:null),`pick a ${r}`);return x("div",{class:"row"},n("node","Node",t.nodes,e),n("member","Member",[...new Set(t.members.map(({name:r})=>r))],i))}other(t){let e=t===2?"Draw in space":"Draw in the plane";return x("div",{class:"row"},x("span",{class:"faint"},`This drawing is ${t===2?"planar":"in space"}.`),Qt(e,()=>this.draw.edit({do:"fresh",dim:5-t})))}newNode(){let{dim:t}=this.draw.state,e=mn.slice(0,t).map(n=>ge(n,"",()=>{},{hint:"0",size:6,name:`${n} of the new node`})),i=async()=>{let n=e.map(a=>a.querySelector("input").value.trim()||"0");(await this.draw.edit({do:"add",at:n.map(a=>Number.isFinite(Number(a))?Number(a):a)})).kind==="drawing"&&(this.draw.reveal(),this.body.querySelector('[aria-label="x of the new node"]').focus())};for(let n of e)n.addEventListener("keydown",r=>r.key==="Enter"&&i());return x("fieldset",{},x("legend",{},"New node at (m, or with a unit)"),x("div",{class:"row"},e,Qt("Add node",i)))}ofNode(t){let{draw:e}=this,{state:i}=e,n=this.entry("nodes",t),r=mn.slice(0,i.dim).map((l,c)=>ge(l,Zm(n.at?.[c]),h=>{if(h===null)return this.rebuild();let u=[...n.at];u[c]=h,e.edit({do:"move",places:{[t]:u}}).then(()=>e.reveal())},{size:8,name:`${l} of ${t}`})),a=i.fixed[t]||"",o=mn.slice(0,i.dim).map((l,c)=>kc(l,a.includes(l),h=>this.set(["fixed",t],mn.slice(0,i.dim).filter(u=>u===l?h:a.includes(u)).join("")||null),`hold ${t} along ${l}`));return[this.naming("nodes",t),x("fieldset",{},x("legend",{},"Place (m, or with a unit: 50 mm, 2 in)"),x("div",{class:"row"},r)),x("fieldset",{},x("legend",{},"Support: held along"),x("div",{class:"row"},o,Qt("All",()=>this.set(["fixed",t],mn.slice(0,i.dim).join("")),{"aria-label":`hold ${t}`}),Qt("Free",()=>this.set(["fixed",t],null),{"aria-label":`free ${t}`}))),this.load(t),x("div",{class:"row"},ge("Mass",n.mass,l=>this.set(["nodes",t,"mass"],l),{hint:"0 kg",name:`mass of ${t}`}),this.slide(t))]}slide(t){let{state:e}=this.draw,i=Object.entries(e.data.drives||{}).find(([,n])=>n.kind==="coordinate"&&n.node===t);return Le("Driven along",[["","-"],...mn.slice(0,e.dim)],i?.[1].axis||"",n=>this.set(["drives",i?.[0]||this.free("drives","slide")],n?{kind:"coordinate",node:t,axis:n}:null),`drive ${t} along`)}load(t){let{state:e}=this.draw,i=Object.entries(e.data.loads||{}).find(([,a])=>a.node===t&&a.force),n=i?i[1].force:Array(e.dim).fill(0),r=mn.slice(0,e.dim).map((a,o)=>ge(`F${a}`,i?n[o]:"",l=>{let c=n.map((u,d)=>d===o?l??0:u),h=c.every(u=>Number(u)===0);this.set(["loads",i?.[0]||this.free("loads",`F_${t}`)],h?null:{...i?.[1]||{},node:t,force:c})},{hint:"0 N",size:6,name:`force on ${t} along ${a}`}));return x("fieldset",{},x("legend",{},"Load (N, or with a unit: 2 kN)"),x("div",{class:"row"},r))}ofMember(t){let{draw:e}=this,{state:i}=e;if(!(t in(i.data.bars||{})))return this.ofOther(["beams","links"].find(l=>t in(i.data[l]||{}))||"active",t);let n=this.entry("bars",t),r=n.kind||"rigid";this.span=x("small",{class:"span"},this.spanText(t));let a=r==="elastic"||r==="cable",o=a?ge("Natural length",n.natural_length,l=>this.set(["bars",t,"natural_length"],l),{hint:"as drawn",name:`natural length of ${t}`}):ge("Length",n.length,l=>this.set(["bars",t,"length"],l),{hint:"as drawn",name:`length of ${t}`});return[this.naming("bars",t),this.span,x("div",{class:"row"},Le("Kind",[...BS,...ud],r,l=>this.setKind(t,l),`kind of ${t}`),o),a?x("div",{class:"row"},ge("Stiffness",n.stiffness,l=>this.set(["bars",t,"stiffness"],l),{hint:"E A/l",name:`stiffness of ${t}`}),ge("Pretension",n.pretension,l=>this.set(["bars",t,"pretension"],l),{hint:"0 N",name:`pretension of ${t}`})):null,this.angle(t),x("div",{class:"row"},qc(e,n.section,l=>this.set(["bars",t,"section"],l),`section of ${t}`),Yc(e,n.material,l=>this.set(["bars",t,"material"],l),`material of ${t}`)),x("div",{class:"row"},ge("Mass",n.mass,l=>this.set(["bars",t,"mass"],l),{hint:"of its section",name:`mass of ${t}`})),this.making(["angle_spring"])]}ofOther(t,e){this.span=x("small",{class:"span"},this.spanText(e));let i={beams:"beam",links:"link"}[t]||"active";return[this.naming(t,e),this.span,x("div",{class:"row"},Le("Kind",[["bar","bar"],...ud],i,n=>this.draw.make(n),`kind of ${e}`)),t==="beams"?this.beamEnds(e):this.making(["angle_spring"]),this.forms.entry(t,e)]}beamEnds(t){let{data:e}=this.draw.state,i=this.entry("beams",t),n=i.release||[],r=e.clamped||[],a=c=>Array.isArray(r)?r.includes(c):c in r,o=(c,h)=>c.filter(u=>u!==h).length?c.filter(u=>u!==h):null,l=async(c,h)=>{n.includes(c)!==(h==="hinge")&&await this.set(["beams",t,"release"],h==="hinge"?[...n,c]:o(n,c)),a(c)!==(h==="clamped")&&(Array.isArray(r)?await this.set(["clamped"],h==="clamped"?[...r,c]:o(r,c)):await this.set(["clamped",c],null))};return x("div",{class:"row"},i.ends.map(c=>Le(`At ${c}`,[["joined","joined stiffly"],["hinge","hinge"],["clamped","clamped to the ground"]],n.includes(c)?"hinge":a(c)?"clamped":"joined",h=>l(c,h),`end of ${t} at ${c}`)))}making(t){return x("div",{class:"row"},t.map(e=>Qt(zS[e],()=>this.draw.make(e))))}setKind(t,e){if(ud.some(([r])=>r===e))return this.draw.make(e);let i={...this.entry("bars",t)},{state:n}=this.draw;if(delete i.kind,e==="elastic"||e==="cable")delete i.length,!((i.section||n.data.section)&&(i.material||n.data.material))&&i.stiffness===void 0&&(i.stiffness="1 kN/m");else for(let r of["stiffness","natural_length","pretension","strain"])delete i[r];this.set(["bars",t],e==="rigid"?Object.keys(i).length===1?i.ends:i:{...i,kind:e})}ofMany(t){let e=async(i,n)=>{for(let r of t)r in(this.draw.state.data.bars||{})&&await this.set(["bars",r,i],n)};return x("div",{class:"row"},qc(this.draw,null,i=>e("section",i),"section of all picked"),Yc(this.draw,null,i=>e("material",i),"material of all picked"))}angle(t){let{state:e}=this.draw,i=Object.entries(e.data.drives||{}).find(([,r])=>(r.kind||"angle")==="angle"&&r.bar===t),n=e.dim===2?[["","-"],["on","yes"]]:[["","-"],...mn.map(r=>[r,`about ${r}`])];return x("div",{class:"row"},Le("Driven angle",n,i?i[1].axis||"on":"",r=>this.set(["drives",i?.[0]||this.free("drives","motor")],r?{kind:"angle",bar:t,...e.dim===3?{axis:r}:{}}:null),`driven angle of ${t}`))}free(t,e){let i=this.draw.state.data[t]||{},n=e;for(let r=2;n in i;r++)n=`${e}${r}`;return n}naming(t,e){return x("div",{class:"row"},ge("Name",e,i=>i===null?this.rebuild():this.draw.edit({do:"rename",table:t,old:e,new:String(i)}),{name:`name of ${e}`}))}spanText(t){let{state:e}=this.draw,i=e.members.findIndex(o=>o.name===t);if(i<0)return"";let n=e.members.filter(o=>o.name===t).map(({ends:o})=>o),r=o=>((l,c)=>Math.hypot(...l.map((h,u)=>h-c[u])))(...o.map(l=>this.draw.at(l))),a=e.force?.[i]??null;return`${[n[0][0],...n.map(o=>o[1])].join(" to ")}, ${$t(n.map(r).reduce((o,l)=>o+l),"m")}${a===null?"":`, ${$t(a,"N")}${e.unsure.includes(t)?" (not unique)":""}`}`}follow(){let{picked:t,state:e}=this.draw;if(t.members.size===1&&this.span&&(this.span.textContent=this.spanText([...t.members][0])),t.nodes.size!==1)return;let[i]=t.nodes;e.places[e.nodes.indexOf(i)].forEach((n,r)=>{let a=this.body.querySelector(`[aria-label="${mn[r]} of ${CSS.escape(i)}"]`);a&&Ea(a,Zm(n))})}};function Zm(s){return typeof s=="number"?Number(s.toPrecision(7)):s}function jm(s,t){return s.length?`${s.length} ${t}${s.length===1?"":"s"}: ${s.slice(0,Ym).join(", ")}${s.length>Ym?" ...":""}`:""}function qc(s,t,e,i){let n=[...Object.keys(s.state.data.sections||{}),...s.choices.sections],r=t&&typeof t=="object"?"own":t||"",a=ge("Outer",r==="own"?t.outer??t.diameter:"",()=>{},{hint:"20 mm",size:6,name:`outer diameter, ${i}`}),o=ge("Inner",r==="own"?t.inner:"",()=>{},{hint:"0",size:6,name:`inner diameter, ${i}`}),c=x("span",{class:"row",hidden:r!=="own"},a,o,Qt("Set",()=>{let[u,d]=[a,o].map(p=>p.querySelector("input").value.trim()),f=[u,d].find(p=>Number(p)!==0&&Number.isFinite(Number(p)));if(f!==void 0)return s.tell(`A diameter needs its unit, or it would be metres: ${f} mm.`,!0);u&&e(!d||Number(d)===0?{kind:"rod",diameter:u}:{kind:"tube",outer:u,inner:d})},{"aria-label":`set ${i}`})),h=Le("Section",[["",i.endsWith("of the model")?"none":"of the model"],...new Set(n),["own","tube or rod ..."]],r,u=>{c.hidden=u!=="own",u!=="own"&&e(u||null)},i);return x("span",{class:"row"},h,c)}function Yc(s,t,e,i){let n=[...Object.keys(s.state.data.materials||{}),...s.choices.materials],r=t&&typeof t=="object"?[["own","of its own"]]:[];return Le("Material",[["",i.endsWith("of the model")?"none":"of the model"],...new Set(n),...r],r.length?"own":t||"",a=>a!=="own"&&e(a||null),i)}var Zc=class{constructor(t){this.draw=t,this.place=x("span",{}),this.grid=x("span",{}),this.outside=x("button",{type:"button",hidden:!0,onclick:()=>t.fit()}),this.node=x("div",{class:"readout"},this.place,this.grid,this.outside)}update(){let{draw:t}=this,{state:e,camera:i,rubber:n,cursor:r,pointed:a}=t,o=n?.to||r||a?.at,l=o&&`${a?.name&&!n?`${a.name}: `:""}${t.cut(o).map(u=>Ta(u)).map(u=>Number(u.toPrecision(6))).join(", ")} m`,c=n?.from&&n.to&&Math.hypot(...n.to.map((u,d)=>u-n.from[d]));this.place.textContent=[l,c?`length ${$t(c,"m")}`:""].filter(Boolean).join("; "),this.grid.textContent=`grid ${$t(i.grid,"m")}`;let h=(t.canvas.seen||[]).filter(([u,d])=>u<0||d<0||u>i.width||d>i.height).length;this.outside.hidden=!h||!e?.nodes.length,this.outside.textContent=`${h} node${h===1?" is":"s are"} out of sight. Show all`}};function dd(s){let[,t,e="m"]=/^\s*([+-]?[\d.]+(?:e[+-]?\d+)?)\s*([a-z]+)?\s*$/i.exec(String(s??""))||[];return Number(t??NaN)*({m:1,cm:.01,mm:.001,in:.0254,ft:.3048}[e]??NaN)}var GS=240,jc=class{constructor(t){Object.assign(this,{draw:t,typing:-1}),this.area=x("textarea",{"aria-label":"model as text",spellcheck:"false",rows:18,wrap:"off",oninput:()=>this.typed(),onblur:()=>this.typing--}),this.lines=x("pre",{class:"lines","aria-hidden":"true"}),this.faults=x("ul",{class:"faults",role:"status"}),this.back=x("button",{type:"button",hidden:!0,onclick:()=>this.reset()},"Back to the drawing's text"),this.node=be("The file",x("p",{class:"faint"},"The same model as text. An edit of the drawing changes only its own lines; comments stay."),x("div",{class:"text"},this.lines,this.area),this.faults,this.back),this.area.addEventListener("scroll",()=>this.lines.scrollTop=this.area.scrollTop)}typed(){this.dirty=!0,this.since=performance.now(),this.number([]),clearTimeout(this.timer);let{typing:t}=this;this.timer=setTimeout(()=>this.send(t),GS)}async send(t){let e=this.area.value,i=await this.draw.ask({do:"text",text:e,drag:t},this.since);this.area.value!==e||i.kind==="lost"||(i.kind==="faults"?this.show(i.faults,!0):i.kind==="drawing"&&(this.dirty=!1,this.show(i.faults,!1)))}reset(){this.dirty=!1,this.rebuild()}rebuild(){let{state:t}=this.draw;this.dirty&&this.area.ownerDocument.activeElement===this.area||(this.dirty=!1,this.area.value!==t.text&&(this.area.value=t.text),this.show(t.faults,!1))}show(t,e){this.back.hidden=!e,this.number(t.map(({line:i})=>i)),this.faults.replaceChildren(...t.slice(0,20).map(({text:i,line:n})=>x("li",{},x("button",{type:"button",class:"link",onclick:()=>this.goTo(n)},n?`Line ${n}`:"Model"),` ${i}`)),...e?[x("li",{},"The drawing is that of the last text without such faults.")]:[])}number(t){let e=this.area.value.split(`
`).length;this.lines.replaceChildren(...Array.from({length:e},(i,n)=>x("span",{class:t.includes(n+1)?"faulty":""},`${n+1}
`))),this.lines.scrollTop=this.area.scrollTop}goTo(t){if(!t)return;let e=this.area.value.split(`
`),i=e.slice(0,t-1).reduce((n,r)=>n+r.length+1,0);this.area.focus(),this.area.setSelectionRange(i,i+e[t-1].length),this.area.scrollTop=(t-4)*(this.area.scrollHeight/e.length)}};var fd=4,VS={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},Kc=class{constructor(t){this.draw=t,this.pointers=new Map;let{node:e}=t.canvas;e.addEventListener("pointerdown",i=>this.down(i)),e.addEventListener("pointermove",i=>this.move(i)),e.addEventListener("pointerup",i=>this.up(i)),e.addEventListener("pointercancel",i=>this.cancel(i)),e.addEventListener("wheel",i=>{i.preventDefault(),t.camera.zoom(Math.exp(-i.deltaY/500),this.place(i)),t.canvas.update()},{passive:!1}),e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("keydown",i=>this.key(i)),e.addEventListener("blur",()=>{this.cancelAct(),this.setCursor(null)}),e.addEventListener("pointerleave",()=>this.point(null))}place(t){let e=this.draw.canvas.node.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}target(t,e){let{draw:i}=this,n=i.canvas.hit(t,e,l=>i.tool!=="node"||i.inPlane(l));if(n?.type==="node")return{node:n.name,point:i.at(n.name)};let r=i.camera.unproject(t);if(!r)return i.tell("The work plane is seen edge-on. Turn the view, or choose another plane.",!0),null;let a=i.snapped(r),o=i.nodeAt(a);return o===void 0?{point:a}:{node:o,point:i.at(o)}}down(t){let{draw:e}=this,i=this.place(t),n=t.pointerType==="touch";if(e.canvas.node.setPointerCapture(t.pointerId),this.pointers.set(t.pointerId,i),e.canvas.node.focus({preventScroll:!0}),this.setCursor(null),this.pointers.size===2)return this.pinch();if(t.button===1||t.button===2||t.altKey){this.act={kind:e.camera.dim===3&&!t.shiftKey?"turn":"pan",last:i};return}if(e.picture.placing)return e.picture.click(i);let r=e.canvas.hit(i,n);e.tool==="pick"?this.begin(r,i,t):this.act={kind:e.tool,start:i,from:this.target(i,n)}}begin(t,e,i){let{draw:n}=this,r=i.shiftKey||n.several;if(!t){this.act=r?{kind:"box",start:e}:{kind:"pan",last:e,start:e,clear:!0};return}r?n.toggle(t):n.isPicked(t)||n.pick(t),t.type==="node"?this.act={kind:"drag",start:e,node:t.name,from:Object.fromEntries([...n.picked.nodes].map(a=>[a,n.at(a)])),number:Math.floor(Math.random()*2**50)}:this.act={kind:"none"}}move(t){let{draw:e}=this,{act:i}=this,n=this.place(t);if(this.pointers.has(t.pointerId)&&this.pointers.set(t.pointerId,n),i?.kind==="pinch")return this.pinched();if(!i)return this.hover(n);if(i.kind==="pan"||i.kind==="turn"){let[r,a]=[n[0]-i.last[0],n[1]-i.last[1]];i.clear&&Math.hypot(n[0]-i.start[0],n[1]-i.start[1])>fd&&(i.clear=!1),i.kind==="pan"?e.camera.pan(r,a):e.camera.turn(-r/150,a/150),i.last=n,e.canvas.update()}else if(i.kind==="box")e.rubber={box:[...i.start,...n]},e.canvas.rubber();else if(i.kind==="drag")this.drag(n);else if(i.kind==="bar"&&i.from){let r=this.target(n,t.pointerType==="touch");e.rubber=r&&{from:i.from.point,to:r.point},e.canvas.rubber()}}hover(t){let{draw:e}=this;if(e.closed)return;let i=e.canvas.hit(t);if(e.tool==="pick")return this.point(i?.type==="node"?{name:i.name,at:e.at(i.name)}:null);let n=i?.type==="node"?e.at(i.name):e.camera.unproject(t),r=n&&(i?.type==="node"?n:e.snapped(n));e.rubber=r?{from:this.pending?.point,to:r}:null,e.canvas.rubber()}point(t){this.draw.pointed=t,!t&&!this.act&&(this.draw.rubber=null),this.draw.canvas.rubber()}drag(t){let{draw:e,act:i}=this,n=i.from[i.node];if(!i.moved&&Math.hypot(t[0]-i.start[0],t[1]-i.start[1])<=fd)return;let r=e.camera.unproject(t,n[e.camera.plane.axis]||0);if(!r)return e.tell("The work plane is seen edge-on. Turn the view, or choose another plane.",!0);i.moved=!0;let a=e.snapped(r,new Set(Object.keys(i.from))),o={};for(let[l,c]of Object.entries(i.from))o[l]=c.map((h,u)=>u===e.camera.plane.axis||a[u]===n[u]?h:Ta(h+a[u]-n[u])).slice(0,e.camera.dim);e.pointed={name:i.node,at:o[i.node]},e.drag(o,i.number)}up(t){let{draw:e,act:i}=this,n=this.place(t);this.pointers.delete(t.pointerId),this.act=null,e.rubber=null,i?.kind==="pan"&&i.clear?e.pick(null):i?.kind==="drag"&&i.moved?e.dragged():i?.kind==="box"?e.pickBox(i.start,n):i?.kind==="node"&&i.from?this.drawNode(i.from):i?.kind==="bar"&&i.from&&this.drawBar(i,n,t.pointerType==="touch"),e.canvas.rubber()}cancel(t){this.pointers.delete(t.pointerId),this.act=null,this.draw.rubber=null,this.draw.canvas.rubber()}drawNode(t){let{draw:e}=this;t.node?e.pick({type:"node",name:t.node}):e.edit({do:"add",at:e.cut(t.point)})}drawBar(t,e,i){if(Math.hypot(e[0]-t.start[0],e[1]-t.start[1])>fd){this.pending=null;let r=this.target(e,i);r&&this.join(t.from,r)}else this.clickBar(t.from)}async clickBar(t){let{draw:e}=this;if(!this.pending){let{node:n}=t;n?e.pick({type:"node",name:n}):n=(await e.edit({do:"add",at:e.cut(t.point)})).made?.node,this.pending=n?{node:n,point:e.at(n)}:null;return}let i=this.pending;this.pending=null,i.node!==t.node&&await this.join(i,t)}async join(t,e){let{draw:i}=this,n=t.node||(await i.edit({do:"add",at:i.cut(t.point)})).made?.node;if(!n||n===e.node)return;let r=i.state.members.find(({ends:a})=>a.includes(n)&&a.includes(e.node));if(r){i.pick({type:"member",name:r.name}),i.tell(`${r.name} joins ${n} and ${e.node} already. It is picked now.`,!0);return}e.node?await i.edit({do:"bar",ends:[n,e.node]}):await i.edit({do:"add",at:i.cut(e.point),bar_from:n})}pinch(){this.cancelAct(),this.act={kind:"pinch",last:[...this.pointers.values()]}}cancelAct(){this.draw.rubber=null,this.pending=null}pinched(){let{draw:t,act:e}=this,i=[...this.pointers.values()];if(i.length<2)return;let n=l=>[(l[0][0]+l[1][0])/2,(l[0][1]+l[1][1])/2],r=l=>Math.hypot(l[0][0]-l[1][0],l[0][1]-l[1][1]),[a,o]=[n(e.last),n(i)];t.camera.pan(o[0]-a[0],o[1]-a[1]),t.camera.zoom(r(i)/(r(e.last)||1),o),e.last=i.map(l=>[...l]),t.canvas.update()}setCursor(t){this.draw.cursor=t,this.draw.canvas.rubber()}key(t){let{draw:e}=this,{camera:i}=e;if(t.ctrlKey||t.metaKey||t.altKey)return;let n=VS[t.key];if(n){t.preventDefault();let[r,a]=i.across,o=i.grid*(t.shiftKey?10:1),l=e.cursor||i.snapped(i.unproject([i.width/2,i.height/2])||[0,0,0]),c=[...l];e.cursor&&(c[r]=l[r]+n[0]*o,c[a]=l[a]+n[1]*o),this.setCursor(i.snapped(c));let h=e.canvas.hit(i.project(e.cursor));e.say(`${h?`${h.type} ${h.name}, `:""}${e.cut(e.cursor).join(", ")} m`)}else t.key==="Enter"&&e.cursor?(t.preventDefault(),this.enter(t)):t.key==="Escape"&&(t.preventDefault(),this.escape())}escape(){this.cancelAct(),this.setCursor(null),this.draw.pick(null)}enter(t){let{draw:e}=this,i=e.camera.project(e.cursor),n=e.canvas.hit(i),r=n?.type==="node"?{node:n.name,point:e.at(n.name)}:{point:e.cursor};e.tool==="node"?this.drawNode(r):e.tool==="bar"?this.clickBar(r):t.shiftKey&&n?e.toggle(n):e.pick(n)}};var Km=[["pick","Pick","v","Pick and move: drag nodes, Shift adds to what is picked, Shift-drag draws a box (V)"],["node","Node","n","A node where you click (N)"],["bar","Bar","b","A bar from press to release, or from click to click; it makes the nodes it needs (B)"]],Jc=class{constructor(t){this.draw=t,this.tools=new Map(Km.map(([i,n,,r])=>[i,x("button",{type:"button",title:r,onclick:()=>t.setTool(i)},n)]));let e=(i,n,r)=>x("button",{type:"button",title:n,"aria-label":n.replace(/ \(.*/,""),onclick:r},i);this.several=e("Several","Pick several: as with Shift held",()=>this.toggleSeveral()),this.several.className="several",this.undo=e("Undo","Undo (Ctrl+Z)",()=>t.ask({do:"undo"})),this.redo=e("Redo","Redo (Ctrl+Y)",()=>t.ask({do:"redo"})),this.delete=e("Delete","Delete what is picked (Delete)",()=>t.remove()),this.fit=e("Fit","Show all (F)",()=>t.fit()),this.names=e("Names","Names and forces (A)",()=>this.toggle("names")),this.force=e("Forces","Colour by force (C)",()=>this.toggle("force")),this.snap=e("Snap","Snap to the grid (G)",()=>this.toggleSnap()),this.theme=e("◐","Dark or light (D)",()=>t.toggleTheme()),this.looks=x("span",{class:"group",role:"group","aria-label":"view"},["corner","top","front","side"].map(i=>x("button",{type:"button",title:`View: ${i}`,onclick:()=>this.look(i)},i[0].toUpperCase()+i.slice(1)))),this.plane=x("span",{class:"group plane"}),this.grid=x("span",{class:"group"}),this.title=x("h1",{}),this.node=x("header",{class:"toolbar rail"},x("div",{class:"title"},this.title,x("a",{href:"../",class:"operate"},"Operate: sliders and forces")),x("div",{class:"tools"},x("span",{class:"group",role:"group","aria-label":"tools"},[...this.tools.values()],this.several),x("span",{class:"group"},this.undo,this.redo,this.delete),x("span",{class:"group"},this.fit,this.names,this.force,this.snap,this.theme),this.grid,this.looks,this.plane))}toggle(t){this.draw.shown[t]=!this.draw.shown[t],this.draw.canvas.update(),this.rebuild()}toggleSnap(){this.draw.snap=!this.draw.snap,this.rebuild()}toggleSeveral(){this.draw.several=!this.draw.several,this.draw.several&&this.draw.setTool("pick"),this.rebuild()}look(t){this.draw.camera.look(t),this.draw.fit()}setPlane(t){Object.assign(this.draw.camera.plane,t),this.draw.canvas.update(),this.rebuild()}rebuild(){let{draw:t}=this,{state:e,camera:i}=t;for(let[r,a]of this.tools)Oi(a,t.tool===r);if(Oi(this.several,t.several),Oi(this.names,t.shown.names),Oi(this.force,t.shown.force),Oi(this.snap,t.snap),!e)return;this.title.textContent=`${e.file||"Untitled drawing"}${e.dirty?" (not saved)":""}`,this.undo.disabled=!e.undo,this.redo.disabled=!e.redo,this.undo.title=e.undo?`Undo ${e.undo} (Ctrl+Z)`:"Nothing to undo",this.redo.title=e.redo?`Redo ${e.redo} (Ctrl+Y)`:"Nothing to redo",this.delete.disabled=!t.picked.nodes.size&&!t.picked.members.size,this.looks.hidden=this.plane.hidden=e.dim!==3,this.grid.replaceChildren(ge("Grid",i.step??"",r=>this.setStep(r),{hint:"auto",size:4,name:"grid step in m"}));let n=x("select",{"aria-label":"work plane",onchange:()=>this.setPlane({axis:Number(n.value),at:0})},["y-z","x-z","x-y"].map((r,a)=>x("option",{value:a},r)));n.value=i.plane.axis,this.plane.replaceChildren(x("label",{class:"entry"},x("span",{},"Plane"),n),ge(`at ${"xyz"[i.plane.axis]} =`,i.plane.at,r=>this.setHeight(r),{size:4,name:"height of the work plane in m"}),x("button",{type:"button",title:"Look straight at the work plane",onclick:()=>{i.face(),t.fit()}},"Face it"))}setHeight(t){let e=dd(t);Number.isFinite(e)?this.setPlane({at:e}):(this.draw.tell(`The height of the work plane is a length: 0.5, 500 mm. Got ${t??"nothing"}.`,!0),this.rebuild())}setStep(t){let{draw:e}=this,{camera:i}=e,n=t===null?null:dd(t);n===null||n>0?i.step=n:e.tell(`The step of the grid is a length: 0.05, 50 mm, 2 in. Got ${t}.`,!0),n>0&&!e.state.nodes.length&&(n*i.scale<8||n*i.scale>150)&&i.zoom(44/n/i.scale),e.canvas.update(),this.rebuild()}key(t){let{draw:e}=this,{target:i}=t,n=i.tagName==="TEXTAREA"||i.tagName==="SELECT"||i.tagName==="INPUT"&&i.type!=="checkbox";if(e.closed||t.defaultPrevented||n)return;let r=t.key.length===1?t.key.toLowerCase():t.key;if(t.ctrlKey||t.metaKey){let l={z:t.shiftKey?"redo":"undo",y:"redo"}[r];if(l)e.ask({do:l});else if(r==="a")e.pickAll();else if(r==="s")e.files.save();else return;t.preventDefault();return}if(t.altKey)return;let a=Km.find(l=>l[2]===r),o={i:[0,.12],k:[0,-.12],j:[-.12,0],o:[.12,0]}[r];if(a)e.setTool(a[0]);else if(o)e.camera.turn(...o),e.canvas.update();else if(r==="Delete"||r==="Backspace")e.remove();else if(r==="Escape")e.tools.escape();else if(r==="f")e.fit();else if(r==="a")this.toggle("names");else if(r==="c")this.toggle("force");else if(r==="g")this.toggleSnap();else if(r==="d")e.toggleTheme();else return;t.preventDefault()}};var Qc=class{constructor(t){this.draw=t,this.body=x("div",{}),this.node=be("Model",this.body)}rebuild(){let{draw:t}=this,{state:e}=t;if(!e)return;let{data:i,dim:n}=e,r=(c,h)=>t.edit({do:"set",path:c,value:h}),a=i.gravity||Array(n).fill(0),o=[..."xyz"].slice(0,n).map((c,h)=>ge(`g${c}`,a[h],u=>r(["gravity"],a.map((d,f)=>f===h?u??0:d)),{size:6,name:`gravity along ${c}`})),l=(c,h)=>Qt(h,()=>t.edit({do:"fresh",dim:c}),{title:"It can be undone."});Ve(this.body,x("div",{class:"row"},ge("Title",i.title,c=>r(["title"],c===null?null:String(c)),{size:20,name:"title"})),x("div",{class:"row"},o,x("small",{},"m/s²")),x("div",{class:"row"},qc(t,i.section,c=>r(["section"],c),"section of the model"),Yc(t,i.material,c=>r(["material"],c),"material of the model")),x("div",{class:"row"},l(2,"New, in the plane"),l(3,"New, in space")))}};var HS=6,WS=new Set(["running"]),Jm={curve:"Computing the path ...",run:"Starting the run ...",stop:"Stopping the run ...",save:"Saving ...",keep:"Saving ...",versions:"Reading the versions ...",picture:"Saving the picture ..."};function Qm(s){let t=document.createElement("style");t.textContent=Hm,document.head.append(t);let e=new pd(s);window.kinetruss.draw=e,e.connect()}var pd=class extends rr{constructor(t){super(t),Object.assign(this,{state:null,tool:"bar",snap:!0,closed:!0,cursor:null,rubber:null,pointed:null,several:!1,moves:0,stale:!1}),this.picked={nodes:new Set,members:new Set},this.shown={names:!0,force:!0},this.theme=t.dataset.theme||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"),t.dataset.theme=this.theme,this.camera=new Uc,this.banner=x("p",{class:"banner",role:"status",hidden:!0}),this.spoken=x("p",{class:"spoken",role:"status","aria-live":"polite"}),this.picture=new Xc(this),this.curves=new zc(this),this.readout=new Zc(this),this.canvas=new Fc(this),this.status=new Bc(this),this.properties=new $c(this),this.whole=new Qc(this),this.groups=new Wc(this),this.text=new jc(this),this.entries=new Vc(this),this.files=new Hc(this),this.rail=new Jc(this),this.tools=new Kc(this);let e=x("aside",{class:"controls sketch","aria-label":"drawing"},x("div",{class:"head"},this.banner,this.files.offer,this.status.node),x("div",{class:"parts"},this.status.details,this.properties.node,this.entries.runsNode,this.entries.node,this.groups.node,this.whole.node,this.curves.node,this.picture.node,this.text.node,this.files.node));t.replaceChildren(this.rail.node,x("main",{},x("div",{class:"sheetpane"},this.canvas.node,this.canvas.legend,this.doing,this.readout.node,this.spoken),e)),t.ownerDocument.addEventListener("keydown",i=>this.rail.key(i))}get there(){return this.state}async edit(t){let e=await this.ask(t),{made:i}=e;return i?.member?this.pick({type:"member",name:i.member}):i?.node&&this.pick({type:"node",name:i.node}),i?.entry&&!i.member&&this.entries.show(i.entry),i?.lost?.length&&this.tell(`Removed with it: ${i.lost.join(", ")}.`),e}make(t){return this.edit({do:"make",what:t,nodes:[...this.picked.nodes],members:[...this.picked.members]})}drag(t,e){this.wanted={do:"move",places:t,drag:e},this.pump()}dragged(){this.ask({do:"show"})}hurried(){let t=this.wanted;return!t||this.curves.stale&&this.moves>=HS?null:(this.moves++,this.wanted=null,{command:t})}leisurely(){return this.curves.stale?(this.moves=0,{command:this.curves.command()}):null}watch(){if(!this.state)return;let t=[this.waiting,...this.queue].filter(n=>n&&!WS.has(n.command.do)),e=t.find(({command:n})=>!(n.do in Jm)),[i]=e?[e]:t;this.changing=!!e,i?this.busy.wait(Jm[i.command.do]||"Computing ...",i.since):this.busy.end()}showBusy(t){let e=!!(t&&this.changing&&this.state);t&&this.doing.hidden&&this.say(t),super.showBusy(t),this.status.wait(e?t:""),e!==this.stale&&(this.stale=e,this.root.classList.toggle("stale",e),this.canvas.update())}heard(t){return t.kind==="drawing"?this.take(t):t.kind==="moved"?this.place(t):t.kind==="curve"?this.curves.take(t):t.kind==="error"&&this.refuse(t.message),t.other||t.choices}refuse(t){this.curves.failed(t,this.waiting),this.tell(t,!0);for(let e of[this.properties,this.whole,this.entries])e.rebuild()}take(t){let e=!this.state,i=this.state?.dim,n=null;t.choices&&(this.choices=t.choices,this.files.setOffer(t.offer),this.picture.take(t.picture),n=t.running),this.state=t,this.camera.setDim(t.dim),this.keepPicked(t.made?.renamed),!t.other&&!e&&this.tell(t.saved||""),this.canvas.rebuild(),(e||t.dim!==i)&&this.fit(),this.curves.spoil();for(let r of[this.rail,this.status,this.properties,this.whole,this.groups,this.entries,this.curves,this.text,this.files])r.rebuild();n&&this.entries.take(n),window.kinetruss.ready=!0,this.root.dataset.state="ready"}place(t){Object.assign(this.state,t,{kind:"drawing"}),this.canvas.update(),this.curves.spoil(),this.status.rebuild(),this.properties.follow()}keepPicked(t){if(t)for(let i of Object.values(this.picked))i.delete(t[0])&&i.add(t[1]);let e={nodes:new Set(this.state.nodes),members:new Set(this.state.members.map(({name:i})=>i))};for(let[i,n]of Object.entries(this.picked))for(let r of n)e[i].has(r)||n.delete(r)}at(t){let e=this.state.places[this.state.nodes.indexOf(t)];return[e[0],e[1],e[2]||0]}snapped(t,e=new Set){return this.snap?this.camera.snapped(t,this.state.places.filter((i,n)=>!e.has(this.state.nodes[n]))):t}nodeAt(t){let{places:e,nodes:i}=this.state;return i[e.findIndex(n=>t.every((r,a)=>Math.abs(r-(n[a]||0))*this.camera.scale<.5))]}inPlane(t){let{axis:e,at:i}=this.camera.plane;return Math.abs(this.at(t)[e]-i)*this.camera.scale<1}cut(t){return t.slice(0,this.camera.dim)}isPicked({type:t,name:e}){return this.picked[`${t}s`].has(e)}pick(t){this.picked.nodes.clear(),this.picked.members.clear(),t&&this.picked[`${t.type}s`].add(t.name),this.repick()}toggle({type:t,name:e}){let i=this.picked[`${t}s`];i.delete(e)||i.add(e),this.repick()}pickAll(){this.state.nodes.forEach(t=>this.picked.nodes.add(t)),this.state.members.forEach(({name:t})=>this.picked.members.add(t)),this.repick()}pickBox(t,e){let i=([n,r])=>(n-t[0])*(n-e[0])<=0&&(r-t[1])*(r-e[1])<=0;this.state.nodes.forEach((n,r)=>i(this.canvas.seen[r])&&this.picked.nodes.add(n)),this.state.members.forEach(({name:n,ends:r})=>r.every(a=>this.picked.nodes.has(a))&&this.picked.members.add(n)),this.repick()}repick(){this.canvas.update();for(let t of[this.rail,this.properties,this.groups,this.curves])t.rebuild();this.say([...this.picked.nodes,...this.picked.members].join(", ")||"nothing picked")}remove(){let t=[...this.picked.nodes],e=[...this.picked.members];(t.length||e.length)&&this.edit({do:"delete",nodes:t,members:e})}reveal(){let{width:t,height:e}=this.camera;this.canvas.seen.some(([i,n])=>i<0||n<0||i>t||n>e)&&this.fit()}fit(){this.camera.fit(this.state.places),this.canvas.update()}setTool(t){this.tool=t,t!=="pick"&&(this.several=!1),this.tools.cancelAct(),this.canvas.rubber(),this.rail.rebuild()}toggleTheme(){this.theme=this.theme==="dark"?"light":"dark",this.root.dataset.theme=this.theme}tell(t,e=!1){this.banner.hidden=!t,this.banner.textContent=t,this.banner.classList.toggle("warning",e)}say(t){this.spoken.textContent=t}open(t){this.post=t,this.closed=!1,this.setEnded(!1),this.state?this.tell("The studio answers again."):this.busy.wait("Opening ...",performance.now())}close(){super.close(),this.state&&this.tell("The studio has ended. The drawing stays as it was last confirmed and cannot be changed. It is kept beside its file: start the studio again in the same folder, and this page goes on with it.",!0)}};var th="KTSCENE1",XS="kinetruss.scene",tg=1;function os(s){let t=atob(s.trim()),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e}async function eg(s){let{readable:t,writable:e}=new DecompressionStream("deflate"),i=e.getWriter(),n=i.write(s).then(()=>i.close()),[r]=await Promise.all([new Response(t).arrayBuffer(),n]);return new Uint8Array(r)}async function Un(s){if(String.fromCharCode(...s.subarray(0,th.length))!==th)throw new Error("These bytes are no kinetruss scene.");let e=th.length+4,i=e+new DataView(s.buffer,s.byteOffset).getUint32(th.length,!0),[n,r]=await Promise.all([eg(s.subarray(e,i)),eg(s.subarray(i))]),a=4+new DataView(n.buffer).getUint32(0,!0),o=JSON.parse(new TextDecoder().decode(n.subarray(4,a)));if(o.format!==XS||o.version!==tg)throw new Error(`Scene version ${o.version} is not known to this viewer, which reads ${tg}.`);let l={};for(let[c,h]of Object.entries(o.arrays)){let u=h.form==="plain"?$S(n,a,h):qS(r,h);l[c]={shape:h.shape,data:u}}return new md(o,l)}var ig=s=>s.shape.reduce((t,e)=>t*e,1);function $S(s,t,e){let i=t+e.at,{buffer:n}=s.slice(i,i+4*ig(e));return e.type==="int32"?new Int32Array(n):new Float32Array(n)}function qS(s,t){let e=ig(t),i=e/t.shape[0];return t.form==="float32"?YS(s,t.at,e,i):ZS(s,t,e,i)}function YS(s,t,e,i){let n=new Uint32Array(e),r=t+e,a=r+e,o=a+e;for(let l=0;l<e;l++)n[l]=s[t+l]|s[r+l]<<8|s[a+l]<<16|s[o+l]<<24,l>=i&&(n[l]+=n[l-i]);return new Float32Array(n.buffer)}function ZS(s,{at:t,order:e},i,n){let r=Float64Array.from(new Int8Array(s.slice(t,t+n).buffer),u=>2**u),a=new Int32Array(s.slice(t+n,t+5*n).buffer),o=t+5*n,l=o+i,c=new Float32Array(i),h=Array.from({length:e},()=>new Uint16Array(n));for(let u=0,d=0,f=0;u<i;u++){let p=s[o+u]|s[l+u]<<8,y=p>>>1^-(p&1);for(let m=Math.min(e-1,f);m>=0;m--)y=h[m][d]+=y;c[u]=(h[0][d]+a[d])*r[d],++d===n&&(d=0,f++)}return c}var md=class{constructor(t,e){Object.assign(this,{header:t,arrays:e,stored:{...e},cases:t.cases.map(i=>i.load_case)}),this.time=e.time.data,this.frames=this.time.length,this.dim=t.dim,this.nodes=t.nodes,this.members=t.members,this.ends=e.ends.data,this.active=new Set(t.two_rods),this.directors=new Set(t.directors||[]),this.partsOf=this.members.map(()=>[]),e.part_member.data.forEach((i,n)=>this.partsOf[i].push(n)),this.curves=new jl(this),this.skin=e.skin?e.skin.data:new Int32Array(0),this.faces=this.skin.length/3,this.extent=jS(e.position.data,this.dim),this.length0=KS(this),this.ranges={},this.kept={},this.sure()}shows(t){return this.header.kinds[t]!=="frame"}sure(){this.unsure=new Set((this.header.not_unique||[]).map(t=>this.members.indexOf(t)).filter(t=>t>=0))}renew(){Object.assign(this.kept,this.ranges),this.ranges={}}choose(t){let e=this.cases.indexOf(t);if(e<0)return!1;Object.assign(this.header,this.header.cases[e]);for(let i of Object.keys(this.stored)){let n=this.stored[`${e}:${i}`];this.arrays[i]=n||this.stored[i]}return this.ranges={},this.kept={},this.sure(),!0}get unchecked(){return["utilisation","buckling"].some(t=>this.has(t)&&this.arrays[t].data.some((e,i)=>Number.isNaN(e)&&this.shows(i%this.members.length)))}has(t){return t in this.arrays}vector(t,e,i){let{data:n,shape:r}=this.arrays[t],a=this.dim,o=(e*r[1]+i)*a;return[n[o],n[o+1],a===3?n[o+2]:0]}position(t,e){return this.vector("position",t,e)}placeOfLoad(t,e){return t.at?[0,1,2].map(i=>t.at.reduce((n,[r,a])=>n+a*e(r)[i],0)):e(t.node)}jointForce(t,e,i){let{data:n}=this.arrays.joint_force,r=this.dim,a=((t*this.members.length+e)*2+i)*r;return[n[a],n[a+1],r===3?n[a+2]:0]}actionForce(t,e,i){let{data:n,shape:r}=this.arrays.action_force,a=this.dim,o=((t*r[1]+e)*2+i)*a;return[n[o],n[o+1],a===3?n[o+2]:0]}number(t,e,i){let{data:n,shape:r}=this.arrays[t];return r.length===1?n[i]:n[e*r[1]+i]}channel(t){return this.header.channels.find(e=>e.id===t)}value(t,e,i){if(t==="length")return this.length(e,i);let n=this.channel(t);return n?n.array?this.has(n.array)?this.number(n.array,e,i):NaN:this.memberSpeed(e,i):NaN}plainValue(t,e,i){let n=this.value(t,e,i);if(!this.channel(t))return n;let[r,a]=this.range(t);return Math.abs(n)<1e-12*Math.max(Math.abs(r),Math.abs(a))?0:n}coloursFaces(t){return this.has(this.channel(t)?.faces)}faceValue(t,e,i){return this.number(this.channel(t).faces,e,i)}memberSpeed(t,e){let i=this.vector("velocity",t,this.ends[2*e]),n=this.vector("velocity",t,this.ends[2*e+1]);return Math.hypot(i[0]+n[0],i[1]+n[1],i[2]+n[2])/2}length(t,e){let i=this.position(t,this.ends[2*e]),n=this.position(t,this.ends[2*e+1]);return Math.hypot(n[0]-i[0],n[1]-i[1],n[2]-i[2])}range(t){if(!(t in this.ranges)){let[e,i]=this.kept[t]||[1/0,-1/0],n=this.channel(t),r=n&&n.array&&this.arrays[n.array]?.shape.length===1?1:this.frames,a=o=>{o<e&&(e=o),o>i&&Number.isFinite(o)&&(i=o)};for(let o=0;o<r;o++)for(let l=0;l<this.members.length;l++)this.shows(l)&&a(this.value(t,o,l));this.coloursFaces(t)&&this.arrays[n.faces].data.forEach(a),this.ranges[t]=e<=i?[e,i]:[0,0]}return this.ranges[t]}frameAt(t){let e=0,i=this.frames-1;for(;i-e>1;){let n=e+i>>1;this.time[n]<=t?e=n:i=n}return Math.abs(this.time[i]-t)<Math.abs(t-this.time[e])?i:e}};function jS(s,t){let e=[1/0,1/0,t===3?1/0:0],i=[-1/0,-1/0,t===3?-1/0:0];for(let a=0;a<s.length;a++){let o=a%t;s[a]<e[o]&&(e[o]=s[a]),s[a]>i[o]&&(i[o]=s[a])}let n=e.map((a,o)=>(a+i[o])/2),r=Math.hypot(...i.map((a,o)=>a-e[o]))||1;return{low:e,high:i,centre:n,size:r}}function KS(s){let e=s.members.map((i,n)=>n).filter(i=>s.shows(i)).map(i=>s.length(0,i)).sort((i,n)=>i-n);return e[e.length>>1]||s.extent.size/4}var JS=24,QS=.94,tw=.08,ng=2,ew=8192,iw=.001,sg=.7;function ag(s){window.kinetruss.film=async t=>{let e=await Un(os(document.querySelector("script.kinetruss-scene").textContent));return window.kinetruss.shown=new gd(s,e,t),window.kinetruss.shown.said}}var gd=class{constructor(t,e,i){let[n,r]=[0,1].map(()=>document.createElement("canvas")),{width:a,height:o}=i;n.style.cssText=`display: block; width: ${a}px; height: ${o}px;`,t.replaceChildren(n);let l=ng*Math.max(a,o)>ew?1:ng;Object.assign(this,{scene:e,look:i,fine:l,view:new sr(n,e,"light",l===1)}),Object.assign(r,{width:a,height:o}),this.pen=r.getContext("2d",{willReadFrequently:!0}),this.dress(),this.aim(),this.said=this.colour()}dress(){let{view:t,scene:e,look:i}=this;t.renderer.setClearColor(new Nt("#ffffff")),t.triad.render=()=>{},t.lamp.intensity=Math.PI*sg,t.lampPlace=[0,0,1],t.ambient.intensity=Math.PI*(1-sg),t.loads.group.visible=i.loads,t.faces.mesh.visible=i.faces,t.grid.visible=!1;let n=iw*e.extent.size;i.grid&&this.lines(rg(t),n,Xe.light.line),i.ghost&&this.lines(nw(e),n,"#a8b0b9");for(let a of i.paths)this.lines(Ti(Array.from({length:e.frames},(o,l)=>e.position(l,a))),2*n,Xe.light.ink);if(i.mode===null)return;let{array:r}=e.header.modes[i.mode];this.reach=tw*e.extent.size/(e.arrays[r].data.reduce((a,o)=>Math.max(a,Math.abs(o)),0)||1),t.mode={array:r,size:0}}lines(t,e,i){let n=rs(t.length,6);n.material=new Vi({color:i}),t.forEach(([r,a],o)=>Ei(n,o,r,a,e)),this.view.world.add(n)}aim(){let{view:t,look:e}=this,{camera:i,controls:n}=t;i.fov=JS,t.resize(),t.renderer.setPixelRatio(this.fine);let r=od(t),a=2*t.bars.ball;if(t.mode)for(let h of[-this.reach,this.reach])r.push(...this.swung(h));e.grid&&r.push(...rg(t).flat()),this.places=[-a,a].flatMap(h=>r.map(u=>u.map(d=>d+h)));let o=new P(...e.direction).normalize();i.up.set(0,...Math.abs(o.z)>.999?[1,0]:[0,1]);let{centre:l,far:c}=ld(t,o,this.places,QS,0);i.position.copy(l).addScaledVector(o,c),i.lookAt(l),n.target.copy(l)}swung(t){return this.view.mode.size=t,this.view.points()}colour(){let{view:t,scene:e,look:i}=this,n=i.colour&&e.channel(i.colour);if(!n)return{step:t.step,unsure:!1,limits:[0,1],largest:0,over:!1,missing:!1};let r=e.range(n.id),a=cr(n.scale,[r]);return t.setColours(n,a),{step:t.step,unsure:e.unsure.size>0,limits:a,largest:Math.max(...r.map(Math.abs)),over:Ui(n)&&r[1]>1,missing:this.missing(n)}}missing(t){let{scene:e}=this,i=e.members.map((n,r)=>r).filter(n=>e.shows(n));for(let n=0;n<e.frames;n++)if(i.some(r=>Number.isNaN(e.value(t.id,n,r))))return!0;return!1}shoot(t,e){let{view:i}=this;return i.mode&&(i.mode.size=e*this.reach),i.setFrame(t),i.render(),this.pen.drawImage(i.canvas,0,0,this.look.width,this.look.height),this.pen.canvas.toDataURL("image/png")}};function nw(s){let t=s.nodes.map((n,r)=>s.position(0,r)),e=xa(s.skin);return[...s.members.flatMap((n,r)=>s.shows(r)?Ti(s.curves.points(t,r)):[]),...Array.from({length:e.length/2},(n,r)=>[t[e[2*r]],t[e[2*r+1]]])]}function rg({scene:s,step:t,grid:e,supports:i}){let{low:n,high:r}=s.extent,a=[0,1].map(c=>Math.floor(n[c]/t-.2)),o=[0,1].map(c=>Math.ceil(r[c]/t+.2)),l=s.dim===2?e.position.z:Math.min(e.position.z,...i.feet(0).map(c=>c[2]));return[0,1].flatMap(c=>Array.from({length:o[c]-a[c]+1},(h,u)=>[a,o].map(d=>{let f=[d[0]*t,d[1]*t,l];return f[c]=(a[c]+u)*t,f})))}var sw=["rigid","driven","elastic","cut"],eh=class{constructor(t){this.live=t,this.acting=x("div",{}),this.kind=x("div",{}),this.node=x("div",{},x("details",{open:!0},x("summary",{},"Member"),this.kind),x("details",{},x("summary",{},"Gravity, payload, loads"),this.acting))}rebuild(t){this.setup=t,ce(this.acting,this.cases(t),this.gravity(t),this.masses(t),t.loads.map(e=>this.load(e,t)),this.load({name:this.free(t),node:this.chosen||t.nodes[t.nodes.length-1],force:Array(t.dim).fill(0)},t,"Add")),this.members(t)}async sent(t,e){if(t.every(i=>Number.isFinite(i.valueAsNumber))){(await e())?.kind==="error"&&this.rebuild(this.setup);return}this.live.controls.tell("A field is empty or holds no number. It was set back.",!0),this.rebuild(this.setup)}free(t){let e=1;for(;t.loads.some(i=>i.name===`load_${e}`);)e++;return`load_${e}`}cases(t){if(!t.cases.length)return null;let e=x("select",{"aria-label":"load case",onchange:()=>this.live.ask({do:"case",name:e.value||null})},x("option",{value:""},"all loads"),t.cases.map(i=>x("option",{value:i,selected:i===t.case},i)));return x("label",{class:"row"},"Load case",e)}vector(t,e){return t.map((i,n)=>x("input",{type:"number",step:"any",value:i,"aria-label":`${e} ${"xyz"[n]}`,class:"component"}))}gravity(t){let e=this.vector(t.gravity,"gravity"),i=()=>this.sent(e,()=>this.live.ask({do:"gravity",value:e.map(o=>o.valueAsNumber)})),n=Math.hypot(...t.gravity)||9.80665,r=(o,l)=>{e.forEach((c,h)=>c.value=h===o?l*n:0),i()},a=e.flatMap((o,l)=>[1,-1].map(c=>x("button",{type:"button",title:`gravity along ${c<0?"-":"+"}${"xyz"[l]}`,onclick:()=>r(l,c)},`${c<0?"-":"+"}${"xyz"[l]}`)));return e.forEach(o=>o.addEventListener("change",i)),x("fieldset",{},x("legend",{},"Gravity (m/s²)"),x("div",{class:"row"},e),x("div",{class:"row"},a))}masses(t){let e=Object.keys(t.masses).reduce((a,o)=>t.masses[o]>t.masses[a]?o:a),i=t.masses[e]?e:t.nodes[t.nodes.length-1];this.chosen=this.chosen&&this.chosen in t.masses?this.chosen:i;let n=x("input",{type:"number",min:0,step:"any",value:t.masses[this.chosen],"aria-label":"payload in kg",class:"component",onchange:()=>this.sent([n],()=>this.live.ask({do:"mass",node:r.value,mass:n.valueAsNumber}))}),r=og(t,this.chosen,"node of the payload",a=>{this.chosen=a,n.value=t.masses[a]});return x("fieldset",{},x("legend",{},"Payload (kg)"),x("div",{class:"row"},r,n))}load(t,e,i="Set"){if(!t.force)return x("p",{class:"faint"},`Load ${t.name} changes in time; at its start here.`);let n=this.vector(t.force,`load ${t.name}`),r=og(e,t.node,`node of load ${t.name}`),a=c=>this.live.ask({do:"load",name:t.name,node:r.value,force:c}),o=x("button",{type:"button",onclick:()=>this.sent(n,()=>a(n.map(c=>c.valueAsNumber)))},i),l=i==="Set"?x("button",{type:"button",title:"Take this load away",onclick:()=>a(n.map(()=>0))},"×"):null;return x("fieldset",{},x("legend",{},i==="Set"?`Load ${t.name} (N)`:"Another load (N)"),x("div",{class:"row"},r,...n,o,l))}members(t){this.member=x("select",{"aria-label":"member",onchange:()=>this.mark()},t.members.map(({name:i,role:n,own:r})=>x("option",{value:i},n===r?i:`${i} (${n})`))),this.shown&&t.members.some(i=>i.name===this.shown)&&(this.member.value=this.shown),this.buttons=new Map([...sw,"own"].map(i=>[i,x("button",{type:"button",onclick:()=>this.live.ask({do:"switch",member:this.member.value,to:i})},i==="own"?"as in the file":i)]));let e=t.lost.length?x("p",{class:"faint"},`Rests on changed members, not in the model now: ${t.lost.join(", ")}.`):null;ce(this.kind,t.members.length?[x("div",{class:"row"},this.member,x("span",{class:"group"},[...this.buttons.values()])),e]:[]),t.members.length&&this.mark()}mark(){this.shown=this.member.value;let{role:t}=this.setup.members.find(e=>e.name===this.shown);for(let[e,i]of this.buttons)i.setAttribute("aria-pressed",String(e===t))}picked(t){t?.type==="member"&&(this.member.value=t.name,this.mark())}};function og(s,t,e,i=()=>{}){let n=x("select",{"aria-label":e,onchange:()=>i(n.value)},s.nodes.map(r=>x("option",{value:r,selected:r===t},r)));return n}var rw=2e3,aw=Math.PI/180,ih=class{constructor(t){this.live=t,this.list=x("div",{class:"drives"}),this.node=be("Drives",this.list)}rebuild(t){this.rows=new Map(t.drives.map(e=>[e.name,this.row(e)])),ce(this.list,t.drives.length?[...this.rows.values()].map(e=>e.node):x("p",{class:"faint"},"This model has no drive."))}row(t){let e=t.unit==="rad"?1/aw:1e3,i=t.unit==="rad"?"deg":"mm",{low:n,high:r,name:a}=t,o=x("input",{type:"range",min:n,max:r,step:(r-n)/rw,"aria-label":`drive ${a}`,oninput:()=>this.live.move({[a]:Number(o.value)})}),l=x("input",{type:"number",step:"any","aria-label":`value of ${a} in ${i}`,oninput:()=>u.typing=!0,onchange:()=>{u.typing=!1,Number.isFinite(l.valueAsNumber)?this.live.move({[a]:l.valueAsNumber/e}):this.update(this.live.controls.last)}}),c=x("small",{},`${ye(n*e,4)} to ${ye(r*e,4)} ${i}${t.limited?"":", no limits in the model"}`),u={node:x("div",{class:"drive","data-drive":a},x("b",{},a),x("span",{class:"value"},l,` ${i}`),o,c),slider:o,field:l,factor:e,typing:!1};return u}update({values:t,stopped:e}){for(let[i,{node:n,slider:r,field:a,factor:o,typing:l}]of this.rows){let c=t[i];if(c===void 0)continue;(!(this.live.wanted&&i in this.live.wanted)||e)&&(r.value=c),l||(a.value=Number((c*o).toFixed(4))),n.classList.toggle("stopped",!!e&&i in(this.live.sent||{}))}}};var nh=class{constructor(t){Object.assign(this,{live:t,frames:[]}),this.at=x("input",{type:"number",min:0,step:"any",value:0,"aria-label":"time of the key frame in s",class:"component"}),this.samples=x("input",{type:"number",min:2,max:2001,step:1,value:201,"aria-label":"samples",class:"component"}),this.line=x("div",{class:"timeline"}),this.list=x("div",{}),this.worst=x("table",{class:"numbers"}),this.play=x("button",{type:"button",onclick:()=>this.run()},"Run"),this.back=x("button",{type:"button",hidden:!0,onclick:()=>this.live.ask({do:"show"})},"Back to the sliders"),this.setter=x("div",{class:"row"},"at",this.at,"s",x("button",{type:"button",onclick:()=>this.set()},"Set key frame here")),this.node=be("Motion through key frames",this.setter,this.line,this.list,x("div",{class:"row"},this.play,this.samples,"samples",this.back),this.worst),this.show()}set(){let t=Math.max(0,this.at.valueAsNumber||0);this.frames=this.frames.filter(e=>Math.abs(e.time-t)>1e-6),this.frames.push({time:t,values:{...this.live.controls.last.values}}),this.frames.sort((e,i)=>e.time-i.time),this.next(),this.keep()}remove(t){this.frames=this.frames.filter(e=>e!==t),this.keep()}next(){this.at.value=this.frames.length?Number((this.frames[this.frames.length-1].time+1).toFixed(6)):0}take(t){this.frames=t,this.next(),this.show()}keep(){this.show(),this.live.page&&this.live.ask({do:"frames",frames:this.frames})}told(){let t=new Set((this.live.setup?.drives||[]).map(e=>e.name));return this.frames.map(({time:e,values:i})=>({time:e,values:Object.fromEntries(Object.entries(i).filter(([n])=>t.has(n)))}))}show(){let t=this.frames.length?this.frames[this.frames.length-1].time:0;this.play.disabled=this.frames.length<2;let e=this.frames.map(({time:i})=>Yt("circle",{cx:8+284*i/(t||1),cy:12,r:6}));ce(this.line,this.frames.length?Yt("svg",{viewBox:"0 0 300 24",role:"img","aria-label":`${this.frames.length} key frames over ${t} s`},Yt("line",{x1:8,y1:12,x2:292,y2:12}),e):null),ce(this.list,this.frames.map(i=>x("div",{class:"row"},x("button",{type:"button",title:"Go there",onclick:()=>this.live.move(i.values)},dh(i.time)),x("button",{type:"button",title:"Remove this key frame","aria-label":`remove the key frame at ${i.time} s`,onclick:()=>this.remove(i)},"×"))))}async run(){this.play.disabled=!0,this.live.controls.tell("Running ..."),await this.live.ask({do:"run",frames:this.told(),samples:Math.round(this.samples.valueAsNumber||201)}),this.play.disabled=this.frames.length<2}running(t){for(let e of[this.setter,this.line,this.list])e.hidden=!!t;this.back.hidden=!t,t&&this.live.controls.tell(""),ce(this.worst,t?[x("tr",{},["worst","member","value","of limit","at"].map(e=>x("th",{},e))),...t.worst.map(e=>this.row(e))]:[])}row(t){let e=()=>{let{app:n}=this.live;n.pause(),n.views[0].scene.cases.includes(t.case)&&n.setCase(t.case),t.time!==null&&n.goTo(n.lead.frameAt(t.time)),t.member&&n.pick({type:"member",name:t.member})},i=t.value===null?"-":$t(t.value,t.unit);return x("tr",{},x("th",{},x("button",{type:"button",class:"link",onclick:e},t.what)),x("td",{},t.member),x("td",{},i),x("td",{},ow(t.used)),x("td",{},t.time===null?"":dh(t.time)))}};function ow(s){return s===null?"":$t(s==="Infinity"?1/0:s,"%")}var lg=.05,sh=class{constructor(t){this.live=t,this.banner=x("p",{class:"banner",role:"status",hidden:!0}),this.offer=x("div",{}),this.alarm=x("p",{class:"alarm",role:"alert",hidden:!0}),this.drives=new ih(t),this.changes=new eh(t),this.frames=new nh(t),this.gauge=x("meter",{min:0,max:1,low:lg,optimum:1,value:0,"aria-label":"distance from a singular pose"}),this.gaugeText=x("output",{}),this.mobility=x("pre",{}),this.note=x("p",{class:"faint"}),this.motors=x("table",{class:"numbers"}),this.reactions=x("table",{class:"numbers"}),this.file=x("input",{type:"text","aria-label":"file name",size:18}),this.pose=x("input",{type:"checkbox"}),this.live_=x("div",{},this.drives.node,this.state(),this.changes.node),this.node=x("aside",{class:"controls","aria-label":"controls"},this.banner,this.offer,this.alarm,this.live_,this.frames.node,this.saving())}state(){return this.motorSection=be("Motors, holding still",this.motors),this.reactionSection=be("Reactions",this.reactions),this.mobilitySection=be("Mobility",this.mobility),x("div",{},x("div",{class:"gauge"},x("span",{},"Singularity gauge"),this.gauge,this.gaugeText),this.note,this.reactionSection,this.motorSection,this.mobilitySection)}saving(){let t=()=>this.save({do:"save",name:this.file.value.trim(),pose:this.pose.checked,frames:this.frames.told()});return this.saveSection=be("Save",x("div",{class:"row"},this.file,x("button",{type:"button",onclick:t},"Save")),x("label",{},this.pose," in this pose"),x("div",{class:"row"},this.undo=this.button("Undo","undo"),this.redo=this.button("Redo","redo"),this.button("Back to the file's model","reset"),this.live.root.dataset.live==="socket"?x("a",{href:"draw/"},"Draw: change the structure"):null)),this.saveSection}button(t,e){return x("button",{type:"button",onclick:()=>this.live.ask({do:e})},t)}async save(t){let e=await this.live.ask(t);e.kind==="exists"&&(this.tell(e.message,!0),this.banner.append(" ",x("button",{type:"button",onclick:()=>this.save({...t,replace:!0})},"Overwrite")))}rebuild(t){this.setup=t,this.drives.rebuild(t),this.changes.rebuild(t),this.file.value||(this.file.value=t.file||"model.yaml"),this.saveSection.hidden=!t.writable,this.history(t),this.setOffer(t.offer),this.tell("")}history({undo:t,redo:e}){for(let[i,n]of[[this.undo,t],[this.redo,e]])i.disabled=!n,i.title=n&&`${i.textContent} ${n}`}setOffer(t){let e=(i,n)=>x("button",{type:"button",onclick:()=>this.live.draft(n)},i);ce(this.offer,t?x("p",{class:"banner"},`Changes of ${new Date(1e3*t).toLocaleString()} were not saved when their studio ended. They would take the place of what this page shows. `,e("Go on with them",!0)," ",e("Remove them",!1)):null)}update(t){this.last=t,this.drives.update(t);let e=t.gauge!==null;this.gauge.value=e?t.gauge:0,this.gaugeText.textContent=e?`${ye(t.gauge,3)}${t.gauge<lg?": near a singular pose":""}`:"not known",t.mobility&&(this.mobility.textContent=t.mobility),this.mobilitySection.hidden=!this.mobility.textContent,this.note.textContent=t.note,this.tell(t.stopped,!0),this.alarm.hidden=!t.alarms?.length,this.alarm.textContent!==(t.alarms||[]).join(" ")&&(this.alarm.textContent=(t.alarms||[]).join(" ")),this.showMotors(t.demand),this.showReactions()}showMotors(t){if(this.motorSection.hidden=!t?.length,!t?.length||!this.motorSection.open)return;let e=[["thrust","N"],["holding_torque","N m"],["breakaway_torque","N m"],["current","A"]].filter(([a])=>a in t[0]),i={thrust:"thrust",holding_torque:"hold",breakaway_torque:"start",current:"current"},n=a=>a.max_current&&a.current!==null?x("small",{class:"unit"},$t(Math.abs(a.current)/a.max_current,"%")):null,r=e.map(([a,o])=>zn(t.map(l=>l[a]??NaN),o));ce(this.motors,x("tr",{},x("th",{},"drive"),e.map(([a],o)=>x("th",{},i[a],x("small",{class:"unit"},` (${r[o][1]})`)))),t.map((a,o)=>x("tr",{},x("th",{},a.name),e.map(([l],c)=>x("td",{},r[c][0][o],l==="current"?n(a):null)))))}showReactions(){let{scene:t,running:e}=this.live;if(e||!t.has("reaction")||!this.reactionSection.open)return;let i=[..."xyz"].slice(0,t.dim),n=t.header.supported.slice(0,200),r=n.flatMap((l,c)=>t.vector("reaction",0,c).slice(0,t.dim)),[a,o]=zn(r,"N");ce(this.reactions,x("tr",{},x("th",{},"node"),i.map(l=>x("th",{},`${l} (${o})`))),n.map((l,c)=>x("tr",{},x("th",{},l),i.map((h,u)=>x("td",{},a[c*i.length+u])))))}picked(){this.changes.picked(this.live.app.picked)}running(t){this.live_.hidden=!!t,t&&(this.alarm.hidden=!0),this.frames.running(t),t?.note&&this.tell(t.note,!0)}tell(t,e=!1){this.banner.hidden=!t,this.banner.textContent=t,this.banner.classList.toggle("warning",e)}};var lw=150,cw=2500,hw=40;function cg(s){let t=new xd(s);if(window.kinetruss.live=t,s.dataset.live==="frame")uw(t);else{t.store=`kinetruss ${location.pathname}`;let[e]=performance.getEntriesByType("navigation");e?.type==="reload"&&(t.page=sessionStorage.getItem(t.store)||""),t.connect()}}function uw(s){window.addEventListener("message",({source:t,data:e})=>{t===window.parent&&t!==window&&e?.kinetruss&&s.hear(e.kinetruss)}),window.parent.postMessage({kinetruss:'{"do":"show"}'},"*"),setTimeout(()=>s.still(),window.parent===window?0:cw),s.open(t=>window.parent.postMessage({kinetruss:t},"*"))}function dw(s){let t=new DataView(s).getUint32(0,!0);return[JSON.parse(new TextDecoder().decode(new Uint8Array(s,4,t))),new Uint8Array(s,4+t)]}var xd=class extends rr{constructor(t){super(t),Object.assign(this,{app:null,running:!1,answers:0,adopt:!0,page:""}),this.controls=new sh(this),t.ownerDocument.addEventListener("keydown",e=>this.key(e))}get there(){return this.app}move(t){this.wanted={...this.wanted,...t},this.pump()}hurried(){return this.wanted?(this.sent=this.wanted,this.wanted=null,{command:{do:"move",values:this.sent}}):null}key(t){let e={z:t.shiftKey?"redo":"undo",y:"redo"}[t.key.toLowerCase()];!e||!(t.ctrlKey||t.metaKey)||this.closed||!this.setup?.[e]||t.target.matches("input:not([type=range], [type=checkbox]), textarea")||(t.preventDefault(),this.ask({do:e}))}showBusy(t){super.showBusy(t),!this.app&&this.root.dataset.state!=="failed"&&this.root.replaceChildren(t?x("p",{class:"failure busy"},t):"")}heard({kind:t,message:e}){(t==="error"||t==="saved")&&this.controls.tell(e,t==="error"),this.answers++,t==="state"&&!this.wanted&&!this.queue.length&&this.rest()}async unpacked(t){let[e,i]=dw(t);return e.kind==="state"?this.place(e,i):await this.stage(e,i),e}async still(){let[t]=document.querySelectorAll("script.kinetruss-scene");this.app||this.answers||!t||(this.busy.end(),this.app=new Ln(this.root,[await Un(os(t.textContent))]),window.kinetruss.app=this.app,window.kinetruss.ready=!0,this.root.dataset.state="ready",this.app.stage.append(x("p",{class:"note"},"A still: run the notebook to move it.")))}rest(){if(clearTimeout(this.timer),this.setup.members.length<=hw||this.fine){this.fine=!1;return}this.timer=setTimeout(()=>{this.fine=!0,this.ask({do:"move",values:{},fine:!0})},lw)}async stage(t,e){let i=await Un(e),n=t.kind==="run";n||Object.assign(i.header,{kind:"live",verdict:t.state.verdict});let r=this.app;r?.end();let a=new Ln(this.root,[i],[],this.controls.node);a.stage.append(this.doing),r&&(a.shown=r.shown,a.apply(),a.views[0].sized=!0,a.views[0].copyCamera(r.views[0]),a.views[0].controls.update(),i.channel(r.channel?.id)&&a.setChannel(r.channel.id),r.picked&&i[`${r.picked.type}s`].includes(r.picked.name)&&a.pick(r.picked)),Object.assign(this,{app:a,scene:i,running:n}),window.kinetruss.app=a,a.onPick=()=>this.controls.picked(),n||(this.setup=t.setup,this.controls.rebuild(t.setup),this.controls.update(t.state),this.adopt&&this.begin(t.setup)),this.controls.running(n?t:null),window.kinetruss.ready=!0,this.root.dataset.state="ready"}place(t,e){let i=e.byteOffset;for(let[n,r]of t.arrays){let a=this.scene.arrays[n];a&&a.data.length===r&&a.data.set(new Float32Array(e.buffer,i,r)),i+=4*r}this.running||(this.scene.header.verdict=t.state.verdict,this.app.refresh()),this.controls.update(t.state)}open(t){this.post=t,this.adopt=!0,this.app||this.busy.wait("Computing ...",performance.now())}draft(t){return this.adopt=t,this.ask({do:"draft",keep:t})}begin({page:t,frames:e}){let i=this.closed,n=t===this.page&&t!=="";if(Object.assign(this,{adopt:!1,closed:!1,page:t}),this.store&&sessionStorage.setItem(this.store,t),(e.length||i&&n)&&this.controls.frames.take(e),!i){n&&this.controls.tell("The page was loaded again and goes on with its changes.");return}this.setEnded(!1),this.controls.history(this.setup),this.controls.frames.show(),n||this.controls.frames.keep(),this.controls.tell(n?"The studio answers again.":"The studio answers again, but it has kept no changes of this page: the model is that of the file.",!n)}fail(t){super.fail(t,this.store?x("p",{},x("a",{href:"draw/"},"Go to the drawing")):"")}close(){clearTimeout(this.timer),super.close(),this.app&&this.controls.tell("The studio has ended. The picture stays and cannot be changed. The changes are kept beside the file: start the studio of the same file again, and this page goes on with them.",!0)}setEnded(t){super.setEnded(t,this.controls.node)}};var hg=`/* The colours --back, --ink and so on are those of src/kinetruss/display/palettes.py; theme.js writes them. */
html, body { margin: 0; height: 100%; }
#kinetruss { box-sizing: border-box; display: flex; flex-direction: column; height: 100%; min-height: 0; background: var(--back); color: var(--ink); font: 14px/1.4 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
#kinetruss *, #kinetruss *::before { box-sizing: border-box; }
#kinetruss [hidden] { display: none !important; }
#kinetruss button, #kinetruss select, #kinetruss input[type="search"] { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 5px; padding: 3px 9px; min-height: 28px; }
#kinetruss button { cursor: pointer; }
#kinetruss button[aria-pressed="true"] { background: var(--pressed); border-color: var(--accent); }
#kinetruss :focus-visible { outline: 2px solid var(--accent); outline-offset: 1px; }
#kinetruss button.link { background: none; border: 0; padding: 0; min-height: 0; color: var(--accent); text-align: inherit; }
#kinetruss .faint, #kinetruss small { color: var(--faint); }
#kinetruss small { font-size: 12px; font-weight: 400; }
#kinetruss kbd { font: 12px ui-monospace, monospace; border: 1px solid var(--line); border-radius: 4px; padding: 0 5px; background: var(--card); }

.toolbar { display: flex; flex-wrap: wrap; gap: 6px 20px; align-items: center; justify-content: space-between; padding: 8px 14px; border-bottom: 1px solid var(--line); background: var(--card); }
.toolbar .title { min-width: 0; flex: 1 1 260px; }
.toolbar.two .title { flex-basis: 560px; }
.toolbar h1 { font-size: 16px; margin: 0; overflow-wrap: anywhere; }
.toolbar p { margin: 0; color: var(--faint); font-size: 12px; overflow-wrap: anywhere; }
.tools { display: flex; flex-wrap: wrap; gap: 6px 12px; align-items: center; }
.tools label { display: inline-flex; gap: 6px; align-items: center; }
.tools .group { display: inline-flex; flex-wrap: wrap; gap: 4px; }
.tools .group:empty { display: none; }

.verdict { display: flex; flex-wrap: wrap; gap: 2px 12px; align-items: center; padding: 4px 14px; min-height: 34px; border-bottom: 1px solid var(--line); background: var(--card); }
.verdict .headline { display: inline-flex; gap: 10px; align-items: center; }
.verdict .sign { flex: none; display: inline-grid; place-items: center; width: 22px; height: 22px; border-radius: 11px; background: var(--pressed); }
.verdict.open .sign, .verdict.none .sign, .hatched { background: repeating-linear-gradient(135deg, var(--card) 0 4px, var(--missing) 4px 6px); }
.verdict.open .sign, .verdict.none .sign { border: 1px solid var(--faint); text-shadow: 0 0 3px var(--card), 0 0 3px var(--card), 0 0 3px var(--card); }
.verdict.over { background: var(--over); color: #fff; }
.verdict.over .sign { background: #fff; color: var(--over); }
#kinetruss .verdict .governing { min-height: 26px; padding: 1px 9px; }
#kinetruss .verdict.over .governing { background: #fff; color: #1d242b; border-color: #fff; }
#kinetruss main { flex: 1; min-height: 0; display: flex; }
.stage { flex: 1; min-width: 0; position: relative; display: flex; }
.panes { flex: 1; min-width: 0; display: flex; }
.pane { position: relative; flex: 1; min-width: 0; overflow: hidden; }
.pane + .pane { border-left: 1px solid var(--line); }
.pane canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; touch-action: none; }
.pane canvas:focus-visible { outline-offset: -2px; }
.pane .label { position: absolute; bottom: 8px; left: 10px; background: var(--card); border: 1px solid var(--line); border-radius: 5px; padding: 2px 10px; font-weight: 600; max-width: calc(100% - 20px); overflow-wrap: anywhere; }
.pane .scale { position: absolute; right: 112px; bottom: 8px; font-size: 12px; color: var(--faint); pointer-events: none; }
.busy { font-variant-numeric: tabular-nums; }
.busy::before { content: ""; display: inline-block; width: 12px; height: 12px; margin-right: 8px; vertical-align: -1px; border: 2px solid var(--line); border-top-color: var(--accent); border-radius: 50%; animation: turning 0.9s linear infinite; }
@keyframes turning { to { rotate: 1turn; } }
@media (prefers-reduced-motion: reduce) { .busy::before { animation-duration: 6s; } }
.stage .busy { position: absolute; bottom: 44px; left: 50%; translate: -50% 0; margin: 0; max-width: calc(100% - 20px); padding: 4px 12px; border: 1px solid var(--line); border-left: 4px solid var(--accent); border-radius: 5px; background: var(--card); pointer-events: none; z-index: 1; }
.awaiting .verdict, .awaiting .panel, .awaiting .timebar, .awaiting .controls .gauge, .awaiting .controls .numbers { opacity: 0.4; }
.stage .note { position: absolute; left: 12px; bottom: 42px; margin: 0; font-size: 12px; color: var(--faint); max-width: 60%; }
.pane.gridless .scale { display: none; }
.names { position: absolute; inset: 0; overflow: hidden; pointer-events: none; font-size: 11px; }
.names span { position: absolute; left: 0; top: 0; color: var(--ink); white-space: nowrap; line-height: 13px; padding: 0 1px;
  text-shadow: 1px 0 1px var(--back), -1px 0 1px var(--back), 0 1px 1px var(--back), 0 -1px 1px var(--back), 0 0 4px var(--back), 0 0 4px var(--back); }
.names .of-node { font-weight: 700; }
.failure { padding: 16px; max-width: 46em; }
.legend { position: absolute; left: 10px; top: 10px; width: 250px; max-width: calc(100% - 20px); padding: 8px 12px; background: color-mix(in srgb, var(--card) 90%, transparent); border: 1px solid var(--line); border-radius: 6px; font-size: 12px; pointer-events: none; }
.legend b { display: block; margin-bottom: 4px; font-size: 13px; }
.legend .bar { height: 12px; border-radius: 3px; }
.legend .ticks, .legend .words { display: flex; justify-content: space-between; gap: 6px; }
.legend .ticks { font-variant-numeric: tabular-nums; margin-top: 2px; }
.legend .words { color: var(--faint); }
.legend .swatch { display: flex; gap: 7px; align-items: center; margin-top: 3px; }
.legend .swatch i { width: 18px; height: 10px; border-radius: 3px; flex: none; }

.panel { width: 390px; flex: none; display: flex; flex-direction: column; border-left: 1px solid var(--line); background: var(--card); min-height: 0; }
.wide .panel { display: none; }
.inspector { flex: 0 0 auto; overflow-y: auto; padding: 10px 14px; min-height: 0; }
.inspector h2 { font-size: 17px; margin: 0 0 6px; }
.inspector h3 { font-size: 14px; margin: 0 0 2px; color: var(--halo); }
.inspector h4 { font-size: 13px; margin: 12px 0 4px; }
.inspector p { margin: 4px 0; }
.views { display: flex; flex-direction: column; gap: 18px; }
.values { border-collapse: collapse; width: 100%; margin-bottom: 6px; }
.values th { text-align: left; font-weight: 400; color: var(--faint); padding: 1px 10px 1px 0; white-space: nowrap; vertical-align: top; }
.values td { font-variant-numeric: tabular-nums; width: 100%; }
.plot { display: block; width: 100%; height: 120px; color: var(--faint); }
.plot.small { height: 96px; }
.freebody svg { width: 100%; max-width: 380px; display: block; font-size: 12px; fill: var(--ink); }
.freebody .rod { stroke: var(--faint); stroke-width: 5; stroke-linecap: round; }
.freebody .joint { fill: var(--card); stroke: var(--ink); stroke-width: 1.6; }
.freebody .faint { fill: var(--faint); }
.numbers { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: 13px; }
.numbers th, .numbers td { padding: 2px 8px 2px 0; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
.numbers th:first-child { text-align: left; font-weight: 500; white-space: normal; }
.numbers thead th { vertical-align: bottom; font-weight: 500; white-space: normal; }
.numbers thead button { display: inline-flex; flex-wrap: wrap; justify-content: flex-end; gap: 0 4px; }
.numbers .unit { white-space: nowrap; }
.numbers td.hatched { background: repeating-linear-gradient(135deg, transparent 0 5px, var(--line) 5px 7px); }
.numbers tr[aria-current] { background: var(--pressed); }
.picked .inspector { flex: 1 1 68%; }
.table { flex: 1 1 32%; min-height: 150px; display: flex; flex-direction: column; gap: 6px; padding: 10px 14px; border-top: 1px solid var(--line); }
.table .scroll { position: relative; overflow: auto; min-height: 0; flex: 1; }
.table thead { position: sticky; top: 0; background: var(--card); }
.table p { margin: 0; font-size: 12px; }
.table p:empty { display: none; }

.timebar { display: flex; gap: 10px; align-items: center; padding: 8px 14px; border-top: 1px solid var(--line); background: var(--card); }
.timebar input { flex: 1; min-width: 0; accent-color: var(--accent); }
.timebar .play { width: 42px; }
.timebar .time { min-width: 76px; text-align: right; font-variant-numeric: tabular-nums; }

.controls { width: 340px; flex: none; overflow-y: auto; padding: 8px 14px; border-right: 1px solid var(--line); background: var(--card); font-size: 13px; }
.controls.ended { opacity: 0.75; }
.controls .banner, .controls .alarm { position: sticky; top: 0; z-index: 2; margin: 0 0 6px; padding: 6px 10px; border: 1px solid var(--line); border-left: 4px solid var(--accent); border-radius: 5px; background: var(--back); }
.controls .banner.warning { border-left-color: var(--pen-2); }
.controls .alarm { border-color: var(--alarm); border-left-width: 4px; font-weight: 600; }
.numbers td.over { color: var(--alarm); font-weight: 700; }
.controls details { border-bottom: 1px solid var(--line); padding: 6px 0 8px; }
.controls summary { font-weight: 600; cursor: pointer; padding: 2px 0; }
.controls .drive { display: grid; grid-template-columns: 1fr auto; gap: 0 8px; align-items: center; padding: 4px 0; }
.controls .drive input[type="range"], .controls .drive small { grid-column: 1 / -1; }
.controls .drive input[type="range"] { width: 100%; margin: 2px 0; accent-color: var(--accent); }
.controls .drive.stopped input[type="range"] { accent-color: var(--pen-2); }
.controls .drive .value input { width: 108px; text-align: right; }
#kinetruss .controls input[type="number"], #kinetruss .controls input[type="text"] { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 5px; padding: 2px 6px; min-height: 26px; min-width: 0; }
#kinetruss .controls select { max-width: 120px; padding: 2px 4px; min-height: 26px; }
#kinetruss .controls button { padding: 1px 7px; min-height: 26px; }
#kinetruss .controls button.link { padding: 0; min-height: 0; }
#kinetruss .controls button:disabled { opacity: 0.5; cursor: default; }
.controls .component { width: 66px; }
.controls .row { display: flex; flex-wrap: wrap; gap: 5px; align-items: center; margin: 4px 0; }
.controls .row .group { display: inline-flex; flex-wrap: wrap; gap: 4px; }
.controls fieldset { border: 1px solid var(--line); border-radius: 5px; margin: 6px 0; padding: 2px 8px 4px; min-width: 0; }
.controls legend { color: var(--faint); font-size: 12px; padding: 0 4px; }
.controls .gauge { display: grid; grid-template-columns: auto 1fr; gap: 2px 8px; align-items: center; padding: 8px 0 2px; }
.controls .gauge meter { width: 100%; }
.controls .gauge output { grid-column: 1 / -1; font-variant-numeric: tabular-nums; }
.controls pre { white-space: pre-wrap; overflow-wrap: anywhere; font: 12px ui-monospace, monospace; margin: 4px 0; }
.controls .numbers { font-size: 12px; }
.controls .numbers th { white-space: normal; }
.controls .numbers th, .controls .numbers td { padding-right: 6px; }
.controls .numbers .unit { display: block; }
.controls p { margin: 4px 0; }
.timeline svg { display: block; width: 100%; height: 24px; }
.timeline line { stroke: var(--line); stroke-width: 3; }
.timeline circle { fill: var(--accent); }

.help { position: fixed; inset: 0; display: grid; place-items: center; padding: 16px; background: rgb(0 0 0 / 45%); z-index: 5; overflow: auto; }
.help .sheet { background: var(--card); border-radius: 8px; padding: 16px 22px; max-width: 880px; max-height: 100%; overflow: auto; }
.help h2 { margin: 0 0 6px; font-size: 18px; }
.help h3 { margin: 8px 0 4px; font-size: 14px; }
.help .columns { columns: 2 320px; column-gap: 32px; }
.help .columns > div { break-inside: avoid; }
.help dl { display: grid; grid-template-columns: 58px 1fr; gap: 3px 8px; margin: 0; }
.help dd { margin: 0; }

@media (min-width: 821px) and (max-width: 1180px) {
  #kinetruss[data-live] main { display: grid; grid-template: minmax(0, 3fr) minmax(0, 2fr) / 310px minmax(0, 1fr); }
  #kinetruss[data-live].wide main { grid-template-rows: minmax(0, 1fr); }
  [data-live] .controls { grid-row: 1 / -1; width: auto; }
  [data-live] .panel { width: auto; border-left: 0; border-top: 1px solid var(--line); overflow-y: auto; }
  [data-live] .picked .inspector { flex: none; overflow: visible; }
}
@media (pointer: coarse) {
  #kinetruss button, #kinetruss select, #kinetruss input[type="search"], #kinetruss .verdict .governing { min-height: 44px; min-width: 44px; }
  #kinetruss button.link { min-width: 0; padding: 0 4px; }
  #kinetruss .controls button, #kinetruss .controls select, #kinetruss .controls input[type="number"], #kinetruss .controls input[type="text"] { min-height: 44px; }
  #kinetruss .controls summary, #kinetruss .controls label { padding: 11px 0; }
  .timebar input, .controls .drive input[type="range"] { height: 44px; }
}
@media (max-width: 820px) {
  #kinetruss { height: auto; min-height: 100%; }
  #kinetruss main { flex-direction: column; }
  .stage { height: 62vh; flex: none; }
  .controls { width: auto; max-height: 36vh; border-right: 0; border-bottom: 1px solid var(--line); }
  .panel { width: auto; border-left: 0; border-top: 1px solid var(--line); }
  .inspector { flex: none; overflow: visible; }
  .table .scroll { max-height: 60vh; }
  .timebar { position: sticky; bottom: 0; }
  .legend { width: 200px; }
  .toolbar { padding: 8px 10px; }
  .toolbar .title { flex-basis: 100%; }
  .tools { gap: 6px; }
}
@media (max-width: 820px) and (orientation: portrait) {
  .panes { flex-direction: column; }
  .pane + .pane { border-left: 0; border-top: 1px solid var(--line); }
}
`;function ug(){let s=(t,e,i)=>`${t} { ${[...Object.entries(e),...i].map(([n,r])=>`--${n}: ${r};`).join(" ")} }`;return[s("#kinetruss",Xe.light,[["over",_n],["missing",cs],["dark",0]]),s('#kinetruss[data-theme="dark"]',Xe.dark,[["dark",1]]),'#kinetruss { color-scheme: light; } #kinetruss[data-theme="dark"] { color-scheme: dark; }'].join(`
`)}async function pw(){let s=document.getElementById("kinetruss");if(!s)return;let t=document.createElement("style");if(t.textContent=`${ug()}
${hg}`,document.head.append(t),s.dataset.live==="draw")return Qm(s);if(s.dataset.live==="film")return ag(s);if(s.dataset.live)return cg(s);let e=[...document.querySelectorAll("script.kinetruss-scene")];try{let i=[];for(let r of e)i.push(await Un(os(r.textContent)));let n=new Ln(s,i,e.map(r=>r.dataset.label||""));window.kinetruss.app=n,requestAnimationFrame(()=>requestAnimationFrame(()=>{window.kinetruss.ready=!0,s.dataset.state="ready"}))}catch(i){window.kinetruss.failed=String(i?.message||i),s.dataset.state="failed",s.textContent=`This page cannot be shown: ${window.kinetruss.failed} A browser of 2023 or newer with WebGL is needed.`}}window.kinetruss={...window.kinetruss,ready:!1,App:Ln,fromBase64:os,readScene:Un};pw();})();
