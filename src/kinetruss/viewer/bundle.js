(()=>{var Ia={N:[[1e9,"nN"],[1e6,"µN"],[1e3,"mN"],[1,"N"],[.001,"kN"],[1e-6,"MN"],[1e-9,"GN"]],"N m":[[1e9,"nN m"],[1e6,"µN m"],[1e3,"mN m"],[1,"N m"],[.001,"kN m"],[1e-6,"MN m"],[1e-9,"GN m"]],V:[[1e9,"nV"],[1e6,"µV"],[1e3,"mV"],[1,"V"],[.001,"kV"],[1e-6,"MV"],[1e-9,"GV"]],A:[[1e9,"nA"],[1e6,"µA"],[1e3,"mA"],[1,"A"],[.001,"kA"],[1e-6,"MA"],[1e-9,"GA"]],W:[[1e9,"nW"],[1e6,"µW"],[1e3,"mW"],[1,"W"],[.001,"kW"],[1e-6,"MW"],[1e-9,"GW"]],J:[[1e9,"nJ"],[1e6,"µJ"],[1e3,"mJ"],[1,"J"],[.001,"kJ"],[1e-6,"MJ"],[1e-9,"GJ"]],Pa:[[1,"Pa"],[.001,"kPa"],[1e-6,"MPa"],[1e-9,"GPa"]],"N/m":[[1,"N/m"],[.001,"kN/m"],[1e-6,"MN/m"],[1e-9,"GN/m"]],"N m/rad":[[1,"N m/rad"],[.001,"kN m/rad"],[1e-6,"MN m/rad"],[1e-9,"GN m/rad"]],"N s/m":[[1,"N s/m"],[.001,"kN s/m"],[1e-6,"MN s/m"],[1e-9,"GN s/m"]],Hz:[[1,"Hz"],[.001,"kHz"],[1e-6,"MHz"],[1e-9,"GHz"]],m:[[1e9,"nm"],[1e6,"µm"],[1e3,"mm"],[1,"m"]],s:[[1e9,"ns"],[1e6,"µs"],[1e3,"ms"],[1,"s"]],"m/s":[[1e9,"nm/s"],[1e6,"µm/s"],[1e3,"mm/s"],[1,"m/s"]],"m/s²":[[1e9,"nm/s²"],[1e6,"µm/s²"],[1e3,"mm/s²"],[1,"m/s²"]],kg:[[1e3,"g"],[1,"kg"],[.001,"t"]],rad:[[57.29577951308232,"deg"]],"%":[[100,"%"]]},Bn={Pa:1e-6,"N/m":1e-6,"":1e-12},cs={"%":3,"":4},gh=1e6,Na=-4,Wd=1e-12,Xd=" ",$d=" ",qd=[1,1.2,1.6,2,2.4,3.2,4,4.8,6,8,10],xh=100;var _h=["#053a7a","#2b7bba","#8fc1e3","#d4d4d4","#f2b279","#d9662b","#8c2d04"],vh=["#482878","#3e4a89","#31688e","#26828e","#1f9e89","#35b779","#6ece58","#b5de2b","#fde725"],hs="#8a8a8a",_n="#e3003a",cr="#9429ff",Yd="#c66b9d",hi={rigid:"#7a8ea3",driven:"#009e73",active:"#009e73",elastic:"#c66b9d",beam:"#c66b9d",cable:"#d99a00",free:"#8d98a4",frame:"#8d98a4"},La={membrane:"#9fb6cc",solid:"#c2b59b"},Xe={light:{back:"#f7f8fa",card:"#ffffff",ink:"#1d242b",faint:"#5d6873",line:"#d5dbe1",accent:"#0b62a8",pressed:"#dcebf7",halo:"#a86400",alarm:"#c40032",outline:"#3a444e",node:"#5b6672",support:"#56606b",grid:"#8a949e",body:"#a9b6c3",edge:"#2b333b","pen-1":"#0072b2","pen-2":"#c24e00","pen-3":"#00795a"},dark:{back:"#14181d",card:"#1d232a",ink:"#e3e8ee",faint:"#9aa6b2",line:"#38424d",accent:"#6db5f0",pressed:"#24405a",halo:"#ffb000",alarm:"#ff8095",outline:"#7d8894",node:"#aab4bf",support:"#97a3af",grid:"#8a949e",body:"#5d6a77",edge:"#0b0e11","pen-1":"#56b4e9","pen-2":"#f08b47","pen-3":"#2fc796"}},Zd={clamp:[[[-.8,0],[.8,0]],[[-.48,0],[-.8,-.22]],[[-.16,0],[-.48,-.22]],[[.16,0],[-.16,-.22]],[[.48,0],[.16,-.22]],[[.8,0],[.48,-.22]]],pin:[[[0,0],[-.5,-.75],[.5,-.75],[0,0]],[[-.7,-.75],[.7,-.75]],[[-.42,-.75],[-.7,-.97]],[[-.14,-.75],[-.42,-.97]],[[.14,-.75],[-.14,-.97]],[[.42,-.75],[.14,-.97]],[[.7,-.75],[.42,-.97]]],roller:[[[0,0],[-.42,-.6],[.42,-.6],[0,0]],[[-.12,-.73],[-.158,-.638],[-.25,-.6],[-.342,-.638],[-.38,-.73],[-.342,-.822],[-.25,-.86],[-.158,-.822],[-.12,-.73]],[[.38,-.73],[.342,-.638],[.25,-.6],[.158,-.638],[.12,-.73],[.158,-.822],[.25,-.86],[.342,-.822],[.38,-.73]],[[-.7,-.86],[.7,-.86]],[[-.42,-.86],[-.7,-1.08]],[[-.14,-.86],[-.42,-1.08]],[[.14,-.86],[-.14,-1.08]],[[.42,-.86],[.14,-1.08]],[[.7,-.86],[.42,-1.08]]],spring:[[[0,0],[0,-.15],[.25,-.24],[-.25,-.42],[.25,-.6],[-.25,-.78],[0,-.87],[0,-1]],[[-.5,-1],[.5,-1]],[[-.3,-1],[-.5,-1.22]],[[-.1,-1],[-.3,-1.22]],[[.1,-1],[-.1,-1.22]],[[.3,-1],[.1,-1.22]],[[.5,-1],[.3,-1.22]]],gap:[[[0,0],[0,-.3]],[[-.35,-.3],[.35,-.3]],[[-.5,-.55],[.5,-.55]],[[-.3,-.55],[-.5,-.77]],[[-.1,-.55],[-.3,-.77]],[[.1,-.55],[-.1,-.77]],[[.3,-.55],[.1,-.77]],[[.5,-.55],[.3,-.77]]],turn:[[[-.35,-.35],[.35,-.35],[.35,.35],[-.35,.35],[-.35,-.35]]],"turning spring":[[[0,.15],[-.062,.149],[-.123,.123],[-.171,.071],[-.197,0],[-.193,-.08],[-.156,-.156],[-.089,-.215],[-0,-.244],[.098,-.237],[.189,-.189],[.258,-.107],[.291,-0],[.28,.116],[.223,.223],[.125,.302],[0,.339],[-.134,.324],[-.256,.256],[-.345,.143],[-.386,0],[-.367,-.152],[-.289,-.289],[-.161,-.389],[-0,-.433],[.17,-.411],[.323,-.323],[.433,-.179],[.48,-0]],[[.48,-.25],[.48,.25]]],"turning gap":[[[.485,.353],[.411,.437],[.321,.507],[.221,.558],[.112,.589],[0,.6],[-.112,.589],[-.221,.558],[-.321,.507],[-.411,.437],[-.485,.353]],[[.36,.26],[.61,.44]],[[-.36,.26],[-.61,.44]]]};function us(n,t){let e=Ia[t],i=Math.abs(n);return e?!Number.isFinite(i)||i<(Bn[t]||Bn[""])?e.find(s=>s[0]===1)||e[0]:e.findLast(s=>i*s[0]*(1+1e-9)>=1)||e[0]:[1,t]}function ue(n,t=4){if(Number.isNaN(n))return"-";let e=n<0?"-":"";if(!Number.isFinite(n))return`${e}∞`;if(n===0)return"0";let i=Math.abs(n),[s,r]=i.toExponential(t-1).split("e"),a=Number(r);return a<Na||a>=Math.log10(gh)?`${e}${jd(s)}e${a}`:e+jd(i.toFixed(Math.max(0,t-1-a)))}function jd(n){return n.includes(".")?n.replace(/\.?0+$/,""):n}function $t(n,t,e=0){if(!Number.isFinite(n))return ue(n);let[i,s]=us(n,t),r=Ia[t]&&Math.abs(n)<(Bn[t]||Bn[""])?0:n;return`${ue(r*i,e||cs[t]||cs[""])} ${s}`.trimEnd()}function bh(n){return Number.isFinite(n)?`${ue(n)} s`:"-"}function zn(n,t,e=0){let s=n.filter(Number.isFinite).map(Math.abs).reduce((r,a)=>Math.max(r,a),0);return Da(s,n,t,e)}function Da(n,t,e,i=0,s=!1){let[r,a]=us(n,e),o=Math.max(Ia[e]?Bn[e]||Bn[""]:0,Wd*n),l=n*r,c=l>0?Math.floor(Math.log10(l)+1e-9):0,h=i||cs[e]||cs[""],u=t.reduce((m,g)=>Number.isFinite(g)&&Math.abs(g)>o?Math.min(m,Math.abs(g)):m,1);if(c<Na||c>=Math.log10(gh)||a===""&&u<10**Na)return[t.map(m=>ue(Math.abs(m)<o?0:m*r,i||cs[""])),a];let d=e==="%"&&!i,f=d?1:Math.max(0,h-1-c),p=t.filter(m=>Number.isFinite(m)&&Math.abs(m)>=o);for(;f&&!d&&!s&&p.every(m=>yh(m*r,f).endsWith("0"));)f--;let v=`0${f?$d+Xd.repeat(f):""}`;return[t.map(m=>Number.isFinite(m)?Math.abs(m)<o||!m?v:yh(m*r,f):ue(m)),a]}function yh(n,t){let e=Math.abs(n).toFixed(t);return n<0&&/[1-9]/.test(e)?`-${e}`:e}function Ug(n){return Number.isFinite(n)?n>xh?`> ${xh}`:yh(n,2):ue(n)}function Kd(n){if(!(Number.isFinite(n)&&n>0))return 1;let t=Math.floor(Math.log10(n));return[...qd,12].map(e=>+`${e}e${t}`).find(e=>e>=n*(1-1e-9))}function Mh(n,t,e=5){if(!(Number.isFinite(n)&&Number.isFinite(t)&&t>n))return[n];let i=Math.floor(Math.log10((t-n)/e));for(let s=0;s<9;s++){let r=[1,2,5][s%3],a=i+Math.floor(s/3),o=+`${r}e${a}`,l=Math.ceil(n/o-1e-9),c=Math.floor(t/o+1e-9);if(c-l<e)return Array.from({length:c-l+1},(h,u)=>+`${(l+u)*r}e${a}`)}return[n]}function Gn(n){let t=10**Math.floor(Math.log10(n));return([5,2,1].find(i=>i*t<=n*(1+1e-9))||1)*t}function Oa(n,t,e=!1){return Number.isNaN(t)?e?"-":Oi(n)?"not checked":"not known":n.scale==="margin"?t<=0?e?"∞":"∞ (no compression)":Ug(1/t-1):$t(t,n.unit)}function Oi(n){return n.scale==="capacity"||n.scale==="margin"}function ds(n){let t=parseInt(n.slice(1),16);return[t>>16&255,t>>8&255,t&255]}var Sh={diverging:_h.map(ds),sequential:vh.map(ds)};function Jd(n,t){let e=Math.min(Math.max(t,0),1)*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,a)=>r+s*(n[i+1][a]-r))}function vn(n,t,e){if(Number.isNaN(t))return ds(hs);if(n==="capacity"||n==="margin")return t>1?ds(_n):Jd(Sh.sequential,t/e[1]);let i=e[1]-e[0]||1;return Jd(n==="diverging"?Sh.diverging:Sh.sequential,(t-e[0])/i)}function hr(n,t){if(n==="capacity"||n==="margin")return[0,1];let e=Kd(Math.max(...t.flat().map(Math.abs)));return n==="diverging"?[-e,e]:[0,e]}function Ua(n){return`linear-gradient(to right, ${(n==="diverging"?_h:vh).join(", ")})`}function x(n,t={},...e){let i=document.createElement(n);return Qd(i,t),i.append(...e.flat(2).filter(s=>s!=null)),i}function Ht(n,t={},...e){let i=document.createElementNS("http://www.w3.org/2000/svg",n);return Qd(i,t),i.append(...e.flat()),i}function Qd(n,t){for(let[e,i]of Object.entries(t))e.startsWith("on")?n.addEventListener(e.slice(2),i):i===!0?n.setAttribute(e,""):i!==!1&&i!==void 0&&n.setAttribute(e,i)}function ce(n,...t){return n.replaceChildren(...t.flat().filter(Boolean)),n}function Fa(n,t,e,i){let s=x("button",{title:t,type:"button","aria-pressed":String(e)},n);return s.addEventListener("click",()=>i()),s}function Ui(n,t){n.setAttribute("aria-pressed",String(!!t))}function be(n,...t){return x("details",{open:!0},x("summary",{},n),...t)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Xi={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},$i={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},zf=0,ou=1,Gf=2;var aa=1,Vf=2,qs=3,Pn=0,ke=1,ii=2,ts=0,Ys=1,lu=2,cu=3,hu=4,Hf=5;var es=100,Wf=101,Xf=102,$f=103,qf=104,Yf=200,Zf=201,jf=202,Kf=203,uu=204,du=205,Jf=206,Qf=207,tp=208,ep=209,ip=210,np=211,sp=212,rp=213,ap=214,_o=0,vo=1,yo=2,Ls=3,bo=4,Mo=5,So=6,wo=7,nl=0,op=1,lp=2,qi=0,fu=1,pu=2,mu=3,gu=4,xu=5,_u=6,vu=7;var yu=300,is=301,Zs=302,sl=303,rl=304,To=1e3,Bi=1001,Eo=1002,qe=1003,cp=1004;var oa=1005;var ai=1006,al=1007;var cn=1008;var ui=1009,bu=1010,Mu=1011,js=1012,ol=1013,Ni=1014,wi=1015,Li=1016,ll=1017,cl=1018,ns=1020,Su=35902,wu=35899,Tu=1021,Eu=1022,Di=1023,sn=1026,hn=1027,hl=1028,ul=1029,In=1030,dl=1031;var fl=1033,la=33776,ca=33777,ha=33778,ua=33779,pl=35840,ml=35841,gl=35842,xl=35843,_l=36196,vl=37492,yl=37496,bl=37488,Ml=37489,da=37490,Sl=37491,wl=37808,Tl=37809,El=37810,Al=37811,Cl=37812,Rl=37813,Pl=37814,Il=37815,Nl=37816,Ll=37817,Dl=37818,Ol=37819,Ul=37820,Fl=37821,kl=36492,Bl=36494,zl=36495,Gl=36283,Vl=36284,fa=36285,Hl=36286;var Er=2300,Ao=2301,go=2302,jh=2303,Kh=2400,Jh=2401,Qh=2402;var hp=3200;var Wl=0,up=1,un="",mi="srgb",Ar="srgb-linear",Cr="linear",fe="srgb";var xo=7680;var dp=519,fp=512,pp=513,mp=514,Au=515,gp=516,xp=517,Cu=518,Ru=519,Pu=35044,Iu=35048;var Nu="300 es",Mi=2e3,Ds=2001;function Fg(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function kg(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Rr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function _p(){let n=Rr("canvas");return n.style.display="block",n}var tf={},Os=null;function Pr(...n){let t="THREE."+n.shift();Os?Os("log",t,...n):console.log(t,...n)}function vp(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ft(...n){n=vp(n);let t="THREE."+n.shift();if(Os)Os("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function zt(...n){n=vp(n);let t="THREE."+n.shift();if(Os)Os("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Mr(...n){let t=n.join(" ");t in tf||(tf[t]=!0,Ft(...n))}function yp(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var bp={[_o]:_o,[yo]:So,[bo]:bo,[Ls]:Mo,[vo]:vo,[So]:yo,[wo]:wo,[Mo]:Ls},Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},ti=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ef=1234567,Is=Math.PI/180,Us=180/Math.PI;function dn(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ti[n&255]+ti[n>>8&255]+ti[n>>16&255]+ti[n>>24&255]+"-"+ti[t&255]+ti[t>>8&255]+"-"+ti[t>>16&15|64]+ti[t>>24&255]+"-"+ti[e&63|128]+ti[e>>8&255]+"-"+ti[e>>16&255]+ti[e>>24&255]+ti[i&255]+ti[i>>8&255]+ti[i>>16&255]+ti[i>>24&255]).toLowerCase()}function jt(n,t,e){return Math.max(t,Math.min(e,n))}function Lu(n,t){return(n%t+t)%t}function Bg(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function zg(n,t,e){return n!==t?(e-n)/(t-n):0}function Sr(n,t,e){return(1-e)*n+e*t}function Gg(n,t,e,i){return Sr(n,t,1-Math.exp(-e*i))}function Vg(n,t=1){return t-Math.abs(Lu(n,t*2)-t)}function Hg(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Wg(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Xg(n,t){return n+Math.floor(Math.random()*(t-n+1))}function $g(n,t){return n+Math.random()*(t-n)}function qg(n){return n*(.5-Math.random())}function Yg(n){n!==void 0&&(ef=n);let t=ef+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Zg(n){return n*Is}function jg(n){return n*Us}function Kg(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Jg(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Du(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Qg(n,t,e,i,s){let r=Math.cos,a=Math.sin,o=r(e/2),l=a(e/2),c=r((t+i)/2),h=a((t+i)/2),u=r((t-i)/2),d=a((t-i)/2),f=r((i-t)/2),p=a((i-t)/2);switch(s){case"XYX":n.set(o*h,l*u,l*d,o*c);break;case"YZY":n.set(l*d,o*h,l*u,o*c);break;case"ZXZ":n.set(l*u,l*d,o*h,o*c);break;case"XZX":n.set(o*h,l*p,l*f,o*c);break;case"YXY":n.set(l*f,o*h,l*p,o*c);break;case"ZYZ":n.set(l*p,l*f,o*h,o*c);break;default:Ft("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Xl(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ou(n,t){if(t.constructor===Float32Array)return n;let e=Xl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Uu(n,t){if(t.constructor===Float32Array)return n;let e=Xl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Fu={DEG2RAD:Is,RAD2DEG:Us,generateUUID:dn,clamp:jt,euclideanModulo:Lu,mapLinear:Bg,inverseLerp:zg,lerp:Sr,damp:Gg,pingpong:Vg,smoothstep:Hg,smootherstep:Wg,randInt:Xg,randFloat:$g,randFloatSpread:qg,seededRandom:Yg,degToRad:Zg,radToDeg:jg,isPowerOfTwo:Kg,ceilPowerOfTwo:Jg,floorPowerOfTwo:Du,setQuaternionFromProperEuler:Qg,normalize:Uu,denormalize:Ou},it=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=jt(this.x,t.x,e.x),this.y=jt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=jt(this.x,t,e),this.y=jt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(jt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*i-a*s+t.x,this.y=r*s+a*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},je=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,a,o){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[a+0],f=r[a+1],p=r[a+2],v=r[a+3];if(u!==v||l!==d||c!==f||h!==p){let m=l*d+c*f+h*p+u*v;m<0&&(d=-d,f=-f,p=-p,v=-v,m=-m);let g=1-o;if(m<.9995){let M=Math.acos(m),w=Math.sin(M);g=Math.sin(g*M)/w,o=Math.sin(o*M)/w,l=l*g+d*o,c=c*g+f*o,h=h*g+p*o,u=u*g+v*o}else{l=l*g+d*o,c=c*g+f*o,h=h*g+p*o,u=u*g+v*o;let M=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=M,c*=M,h*=M,u*=M}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,a){let o=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[a],d=r[a+1],f=r[a+2],p=r[a+3];return t[e]=o*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-o*f,t[e+2]=c*p+h*f+o*d-l*u,t[e+3]=h*p-o*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,l=Math.sin,c=o(i/2),h=o(s/2),u=o(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(a){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:Ft("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],a=e[1],o=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=i+o+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-s)*f}else if(i>o&&i>u){let f=2*Math.sqrt(1+i-o-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+a)/f,this._z=(r+c)/f}else if(o>u){let f=2*Math.sqrt(1+o-i-u);this._w=(r-c)/f,this._x=(s+a)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-o);this._w=(a-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(jt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,a=t._w,o=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-i*c,this._z=r*h+a*c+i*l-s*o,this._w=a*h-i*o-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(i=-i,s=-s,r=-r,a=-a,o=-o);let l=1-e;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(nf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(nf.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,a=t.y,o=t.z,l=t.w,c=2*(a*s-o*i),h=2*(o*e-r*s),u=2*(r*i-a*e);return this.x=e+l*c+a*u-o*h,this.y=i+l*h+o*c-r*u,this.z=s+l*u+r*h-a*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=jt(this.x,t.x,e.x),this.y=jt(this.y,t.y,e.y),this.z=jt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=jt(this.x,t,e),this.y=jt(this.y,t,e),this.z=jt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,a=e.x,o=e.y,l=e.z;return this.x=s*l-r*o,this.y=r*a-i*l,this.z=i*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return wh.copy(this).projectOnVector(t),this.sub(wh)}reflect(t){return this.sub(wh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(jt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},wh=new I,nf=new je,Wt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,a,o,l,c)}set(t,e,i,s,r,a,o,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],p=i[8],v=s[0],m=s[3],g=s[6],M=s[1],w=s[4],b=s[7],C=s[2],E=s[5],_=s[8];return r[0]=a*v+o*M+l*C,r[3]=a*m+o*w+l*E,r[6]=a*g+o*b+l*_,r[1]=c*v+h*M+u*C,r[4]=c*m+h*w+u*E,r[7]=c*g+h*b+u*_,r[2]=d*v+f*M+p*C,r[5]=d*m+f*w+p*E,r[8]=d*g+f*b+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8];return e*a*h-e*o*c-i*r*h+i*o*l+s*r*c-s*a*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=h*a-o*c,d=o*l-h*r,f=c*r-a*l,p=e*u+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return t[0]=u*v,t[1]=(s*c-h*i)*v,t[2]=(o*i-s*a)*v,t[3]=d*v,t[4]=(h*e-s*l)*v,t[5]=(s*r-o*e)*v,t[6]=f*v,t[7]=(i*l-c*e)*v,t[8]=(a*e-i*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+t,-s*c,s*l,-s*(-c*a+l*o)+o+e,0,0,1),this}scale(t,e){return Mr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Th.makeScale(t,e)),this}rotate(t){return Mr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Th.makeRotation(-t)),this}translate(t,e){return Mr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Th.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Th=new Wt,sf=new Wt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),rf=new Wt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function t0(){let n={enabled:!0,workingColorSpace:Ar,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===fe&&(s.r=nn(s.r),s.g=nn(s.g),s.b=nn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===fe&&(s.r=Ns(s.r),s.g=Ns(s.g),s.b=Ns(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===un?Cr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ar]:{primaries:t,whitePoint:i,transfer:Cr,toXYZ:sf,fromXYZ:rf,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:mi},outputColorSpaceConfig:{drawingBufferColorSpace:mi}},[mi]:{primaries:t,whitePoint:i,transfer:fe,toXYZ:sf,fromXYZ:rf,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:mi}}}),n}var ae=t0();function nn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ns(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var fs,Co=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{fs===void 0&&(fs=Rr("canvas")),fs.width=t.width,fs.height=t.height;let s=fs.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=fs}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Rr("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=nn(r[a]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(nn(e[i]/255)*255):e[i]=nn(e[i]);return{data:e,width:t.width,height:t.height}}else return Ft("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},e0=0,Fs=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:e0++}),this.uuid=dn(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Eh(s[a].image)):r.push(Eh(s[a]))}else r=Eh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Eh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Co.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ft("Texture: Unable to serialize Texture."),{})}var i0=0,Ah=new I,oi=class n extends Ii{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Bi,s=Bi,r=ai,a=cn,o=Di,l=ui,c=n.DEFAULT_ANISOTROPY,h=un){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:i0++}),this.uuid=dn(),this.name="",this.source=new Fs(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Wt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ah).x}get height(){return this.source.getSize(Ah).y}get depth(){return this.source.getSize(Ah).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Ft(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ft(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==yu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case To:t.x=t.x-Math.floor(t.x);break;case Bi:t.x=t.x<0?0:1;break;case Eo:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case To:t.y=t.y-Math.floor(t.y);break;case Bi:t.y=t.y<0?0:1;break;case Eo:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=yu;oi.DEFAULT_ANISOTROPY=1;var Ae=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*i+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],v=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,b=(f+1)/2,C=(g+1)/2,E=(h+d)/4,_=(u+v)/4,T=(p+m)/4;return w>b&&w>C?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=E/i,r=_/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=E/s,r=T/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=_/r,s=T/r),this.set(i,s,r,e),this}let M=Math.sqrt((m-p)*(m-p)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(m-p)/M,this.y=(u-v)/M,this.z=(d-h)/M,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=jt(this.x,t.x,e.x),this.y=jt(this.y,t.y,e.y),this.z=jt(this.z,t.z,e.z),this.w=jt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=jt(this.x,t,e),this.y=jt(this.y,t,e),this.z=jt(this.z,t,e),this.w=jt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ro=class extends Ii{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ai,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Ae(0,0,t,e),this.scissorTest=!1,this.viewport=new Ae(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new oi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ai,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Fs(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},xi=class extends Ro{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Ir=class extends oi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=qe,this.minFilter=qe,this.wrapR=Bi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Po=class extends oi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=qe,this.minFilter=qe,this.wrapR=Bi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var pe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,a,o,l,c,h,u,d,f,p,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,a,o,l,c,h,u,d,f,p,v,m)}set(t,e,i,s,r,a,o,l,c,h,u,d,f,p,v,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=a,g[9]=o,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=v,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/ps.setFromMatrixColumn(t,0).length(),r=1/ps.setFromMatrixColumn(t,1).length(),a=1/ps.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*a,e[9]=i[9]*a,e[10]=i[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=a*h,f=a*u,p=o*h,v=o*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-v*c,e[9]=-o*l,e[2]=v-d*c,e[6]=p+f*c,e[10]=a*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,v=c*u;e[0]=d+v*o,e[4]=p*o-f,e[8]=a*c,e[1]=a*u,e[5]=a*h,e[9]=-o,e[2]=f*o-p,e[6]=v+d*o,e[10]=a*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,v=c*u;e[0]=d-v*o,e[4]=-a*u,e[8]=p+f*o,e[1]=f+p*o,e[5]=a*h,e[9]=v-d*o,e[2]=-a*c,e[6]=o,e[10]=a*l}else if(t.order==="ZYX"){let d=a*h,f=a*u,p=o*h,v=o*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+v,e[1]=l*u,e[5]=v*c+d,e[9]=f*c-p,e[2]=-c,e[6]=o*l,e[10]=a*l}else if(t.order==="YZX"){let d=a*l,f=a*c,p=o*l,v=o*c;e[0]=l*h,e[4]=v-d*u,e[8]=p*u+f,e[1]=u,e[5]=a*h,e[9]=-o*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-v*u}else if(t.order==="XZY"){let d=a*l,f=a*c,p=o*l,v=o*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+v,e[5]=a*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=o*h,e[10]=v*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(n0,t,s0)}lookAt(t,e,i){let s=this.elements;return fi.subVectors(t,e),fi.lengthSq()===0&&(fi.z=1),fi.normalize(),yn.crossVectors(i,fi),yn.lengthSq()===0&&(Math.abs(i.z)===1?fi.x+=1e-4:fi.z+=1e-4,fi.normalize(),yn.crossVectors(i,fi)),yn.normalize(),ka.crossVectors(fi,yn),s[0]=yn.x,s[4]=ka.x,s[8]=fi.x,s[1]=yn.y,s[5]=ka.y,s[9]=fi.y,s[2]=yn.z,s[6]=ka.z,s[10]=fi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],p=i[2],v=i[6],m=i[10],g=i[14],M=i[3],w=i[7],b=i[11],C=i[15],E=s[0],_=s[4],T=s[8],U=s[12],P=s[1],D=s[5],F=s[9],X=s[13],R=s[2],k=s[6],W=s[10],V=s[14],nt=s[3],$=s[7],Q=s[11],et=s[15];return r[0]=a*E+o*P+l*R+c*nt,r[4]=a*_+o*D+l*k+c*$,r[8]=a*T+o*F+l*W+c*Q,r[12]=a*U+o*X+l*V+c*et,r[1]=h*E+u*P+d*R+f*nt,r[5]=h*_+u*D+d*k+f*$,r[9]=h*T+u*F+d*W+f*Q,r[13]=h*U+u*X+d*V+f*et,r[2]=p*E+v*P+m*R+g*nt,r[6]=p*_+v*D+m*k+g*$,r[10]=p*T+v*F+m*W+g*Q,r[14]=p*U+v*X+m*V+g*et,r[3]=M*E+w*P+b*R+C*nt,r[7]=M*_+w*D+b*k+C*$,r[11]=M*T+w*F+b*W+C*Q,r[15]=M*U+w*X+b*V+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],a=t[1],o=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],v=t[7],m=t[11],g=t[15],M=l*f-c*d,w=o*f-c*u,b=o*d-l*u,C=a*f-c*h,E=a*d-l*h,_=a*u-o*h;return e*(v*M-m*w+g*b)-i*(p*M-m*C+g*E)+s*(p*w-v*C+g*_)-r*(p*b-v*E+m*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],a=t[5],o=t[9],l=t[2],c=t[6],h=t[10];return e*(a*h-o*c)-i*(r*h-o*l)+s*(r*c-a*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],v=t[13],m=t[14],g=t[15],M=e*o-i*a,w=e*l-s*a,b=e*c-r*a,C=i*l-s*o,E=i*c-r*o,_=s*c-r*l,T=h*v-u*p,U=h*m-d*p,P=h*g-f*p,D=u*m-d*v,F=u*g-f*v,X=d*g-f*m,R=M*X-w*F+b*D+C*P-E*U+_*T;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let k=1/R;return t[0]=(o*X-l*F+c*D)*k,t[1]=(s*F-i*X-r*D)*k,t[2]=(v*_-m*E+g*C)*k,t[3]=(d*E-u*_-f*C)*k,t[4]=(l*P-a*X-c*U)*k,t[5]=(e*X-s*P+r*U)*k,t[6]=(m*b-p*_-g*w)*k,t[7]=(h*_-d*b+f*w)*k,t[8]=(a*F-o*P+c*T)*k,t[9]=(i*P-e*F-r*T)*k,t[10]=(p*E-v*b+g*M)*k,t[11]=(u*b-h*E-f*M)*k,t[12]=(o*U-a*D-l*T)*k,t[13]=(e*D-i*U+s*T)*k,t[14]=(v*w-p*C-m*M)*k,t[15]=(h*C-u*w+d*M)*k,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,a=t.x,o=t.y,l=t.z,c=r*a,h=r*o;return this.set(c*a+i,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+i,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,a){return this.set(1,i,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,a=e._y,o=e._z,l=e._w,c=r+r,h=a+a,u=o+o,d=r*c,f=r*h,p=r*u,v=a*h,m=a*u,g=o*u,M=l*c,w=l*h,b=l*u,C=i.x,E=i.y,_=i.z;return s[0]=(1-(v+g))*C,s[1]=(f+b)*C,s[2]=(p-w)*C,s[3]=0,s[4]=(f-b)*E,s[5]=(1-(d+g))*E,s[6]=(m+M)*E,s[7]=0,s[8]=(p+w)*_,s[9]=(m-M)*_,s[10]=(1-(d+v))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let a=ps.set(s[0],s[1],s[2]).length(),o=ps.set(s[4],s[5],s[6]).length(),l=ps.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Ci.copy(this);let c=1/a,h=1/o,u=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=h,Ci.elements[5]*=h,Ci.elements[6]*=h,Ci.elements[8]*=u,Ci.elements[9]*=u,Ci.elements[10]*=u,e.setFromRotationMatrix(Ci),i.x=a,i.y=o,i.z=l,this}makePerspective(t,e,i,s,r,a,o=Mi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,v;if(l)p=r/(a-r),v=a*r/(a-r);else if(o===Mi)p=-(a+r)/(a-r),v=-2*a*r/(a-r);else if(o===Ds)p=-a/(a-r),v=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,a,o=Mi,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,v;if(l)p=1/(a-r),v=a/(a-r);else if(o===Mi)p=-2/(a-r),v=-(a+r)/(a-r);else if(o===Ds)p=-1/(a-r),v=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},ps=new I,Ci=new pe,n0=new I(0,0,0),s0=new I(1,1,1),yn=new I,ka=new I,fi=new I,af=new pe,of=new je,rn=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(jt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-jt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(jt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-jt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(jt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-jt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ft("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return af.makeRotationFromQuaternion(t),this.setFromRotationMatrix(af,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return of.setFromEuler(this),this.setFromQuaternion(of,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};rn.DEFAULT_ORDER="XYZ";var Nr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},r0=0,lf=new I,ms=new je,Ki=new pe,Ba=new I,ur=new I,a0=new I,o0=new je,cf=new I(1,0,0),hf=new I(0,1,0),uf=new I(0,0,1),df={type:"added"},l0={type:"removed"},gs={type:"childadded",child:null},Ch={type:"childremoved",child:null},Ke=class n extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:r0++}),this.uuid=dn(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new I,e=new rn,i=new je,s=new I(1,1,1);function r(){i.setFromEuler(e,!1)}function a(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new pe},normalMatrix:{value:new Wt}}),this.matrix=new pe,this.matrixWorld=new pe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Nr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ms.setFromAxisAngle(t,e),this.quaternion.multiply(ms),this}rotateOnWorldAxis(t,e){return ms.setFromAxisAngle(t,e),this.quaternion.premultiply(ms),this}rotateX(t){return this.rotateOnAxis(cf,t)}rotateY(t){return this.rotateOnAxis(hf,t)}rotateZ(t){return this.rotateOnAxis(uf,t)}translateOnAxis(t,e){return lf.copy(t).applyQuaternion(this.quaternion),this.position.add(lf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(cf,t)}translateY(t){return this.translateOnAxis(hf,t)}translateZ(t){return this.translateOnAxis(uf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ki.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ba.copy(t):Ba.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ur.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ki.lookAt(ur,Ba,this.up):Ki.lookAt(Ba,ur,this.up),this.quaternion.setFromRotationMatrix(Ki),s&&(Ki.extractRotation(s.matrixWorld),ms.setFromRotationMatrix(Ki),this.quaternion.premultiply(ms.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(zt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(df),gs.child=t,this.dispatchEvent(gs),gs.child=null):zt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(l0),Ch.child=t,this.dispatchEvent(Ch),Ch.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ki.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ki.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ki),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(df),gs.child=t,this.dispatchEvent(gs),gs.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let a=this.children[i].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ur,t,a0),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ur,o0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(t.materials,this.material[l]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(t.animations,l))}}if(e){let o=a(t.geometries),l=a(t.materials),c=a(t.textures),h=a(t.images),u=a(t.shapes),d=a(t.skeletons),f=a(t.animations),p=a(t.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ke.DEFAULT_UP=new I(0,1,0);Ke.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ke.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fe=class extends Ke{constructor(){super(),this.isGroup=!0,this.type="Group"}},c0={type:"move"},ks=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fe,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fe,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fe,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){a=!0;for(let v of t.hand.values()){let m=e.getJointPose(v,i),g=this._getHandJoint(c,v);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(c0)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Fe;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Mp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},bn={h:0,s:0,l:0},za={h:0,s:0,l:0};function Rh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Nt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=mi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ae.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ae.workingColorSpace){return this.r=t,this.g=e,this.b=i,ae.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ae.workingColorSpace){if(t=Lu(t,1),e=jt(e,0,1),i=jt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,a=2*i-r;this.r=Rh(a,r,t+1/3),this.g=Rh(a,r,t),this.b=Rh(a,r,t-1/3)}return ae.colorSpaceToWorking(this,s),this}setStyle(t,e=mi){function i(r){r!==void 0&&parseFloat(r)<1&&Ft("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Ft("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Ft("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=mi){let i=Mp[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Ft("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=nn(t.r),this.g=nn(t.g),this.b=nn(t.b),this}copyLinearToSRGB(t){return this.r=Ns(t.r),this.g=Ns(t.g),this.b=Ns(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=mi){return ae.workingToColorSpace(ei.copy(this),t),Math.round(jt(ei.r*255,0,255))*65536+Math.round(jt(ei.g*255,0,255))*256+Math.round(jt(ei.b*255,0,255))}getHexString(t=mi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ae.workingColorSpace){ae.workingToColorSpace(ei.copy(this),e);let i=ei.r,s=ei.g,r=ei.b,a=Math.max(i,s,r),o=Math.min(i,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ae.workingColorSpace){return ae.workingToColorSpace(ei.copy(this),e),t.r=ei.r,t.g=ei.g,t.b=ei.b,t}getStyle(t=mi){ae.workingToColorSpace(ei.copy(this),t);let e=ei.r,i=ei.g,s=ei.b;return t!==mi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(bn),this.setHSL(bn.h+t,bn.s+e,bn.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(bn),t.getHSL(za);let i=Sr(bn.h,za.h,e),s=Sr(bn.s,za.s,e),r=Sr(bn.l,za.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ei=new Nt;Nt.NAMES=Mp;var qn=class extends Ke{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new rn,this.environmentIntensity=1,this.environmentRotation=new rn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ri=new I,Ji=new I,Ph=new I,Qi=new I,xs=new I,_s=new I,ff=new I,Ih=new I,Nh=new I,Lh=new I,Dh=new Ae,Oh=new Ae,Uh=new Ae,ki=class n{constructor(t=new I,e=new I,i=new I){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ri.subVectors(t,e),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ri.subVectors(s,e),Ji.subVectors(i,e),Ph.subVectors(t,e);let a=Ri.dot(Ri),o=Ri.dot(Ji),l=Ri.dot(Ph),c=Ji.dot(Ji),h=Ji.dot(Ph),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-o*h)*d,p=(a*h-o*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Qi)===null?!1:Qi.x>=0&&Qi.y>=0&&Qi.x+Qi.y<=1}static getInterpolation(t,e,i,s,r,a,o,l){return this.getBarycoord(t,e,i,s,Qi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Qi.x),l.addScaledVector(a,Qi.y),l.addScaledVector(o,Qi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,a){return Dh.setScalar(0),Oh.setScalar(0),Uh.setScalar(0),Dh.fromBufferAttribute(t,e),Oh.fromBufferAttribute(t,i),Uh.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(Dh,r.x),a.addScaledVector(Oh,r.y),a.addScaledVector(Uh,r.z),a}static isFrontFacing(t,e,i,s){return Ri.subVectors(i,e),Ji.subVectors(t,e),Ri.cross(Ji).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),Ji.subVectors(this.a,this.b),Ri.cross(Ji).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,a,o;xs.subVectors(s,i),_s.subVectors(r,i),Ih.subVectors(t,i);let l=xs.dot(Ih),c=_s.dot(Ih);if(l<=0&&c<=0)return e.copy(i);Nh.subVectors(t,s);let h=xs.dot(Nh),u=_s.dot(Nh);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),e.copy(i).addScaledVector(xs,a);Lh.subVectors(t,r);let f=xs.dot(Lh),p=_s.dot(Lh);if(p>=0&&f<=p)return e.copy(r);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return o=c/(c-p),e.copy(i).addScaledVector(_s,o);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return ff.subVectors(r,s),o=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(ff,o);let g=1/(m+v+d);return a=v*g,o=d*g,e.copy(i).addScaledVector(xs,a).addScaledVector(_s,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},zi=class{constructor(t=new I(1/0,1/0,1/0),e=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,Pi):Pi.fromBufferAttribute(r,a),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ga.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ga.copy(i.boundingBox)),Ga.applyMatrix4(t.matrixWorld),this.union(Ga)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(dr),Va.subVectors(this.max,dr),vs.subVectors(t.a,dr),ys.subVectors(t.b,dr),bs.subVectors(t.c,dr),Mn.subVectors(ys,vs),Sn.subVectors(bs,ys),Vn.subVectors(vs,bs);let e=[0,-Mn.z,Mn.y,0,-Sn.z,Sn.y,0,-Vn.z,Vn.y,Mn.z,0,-Mn.x,Sn.z,0,-Sn.x,Vn.z,0,-Vn.x,-Mn.y,Mn.x,0,-Sn.y,Sn.x,0,-Vn.y,Vn.x,0];return!Fh(e,vs,ys,bs,Va)||(e=[1,0,0,0,1,0,0,0,1],!Fh(e,vs,ys,bs,Va))?!1:(Ha.crossVectors(Mn,Sn),e=[Ha.x,Ha.y,Ha.z],Fh(e,vs,ys,bs,Va))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(tn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),tn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),tn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),tn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),tn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),tn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),tn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),tn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(tn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},tn=[new I,new I,new I,new I,new I,new I,new I,new I],Pi=new I,Ga=new zi,vs=new I,ys=new I,bs=new I,Mn=new I,Sn=new I,Vn=new I,dr=new I,Va=new I,Ha=new I,Hn=new I;function Fh(n,t,e,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){Hn.fromArray(n,r);let o=s.x*Math.abs(Hn.x)+s.y*Math.abs(Hn.y)+s.z*Math.abs(Hn.z),l=t.dot(Hn),c=e.dot(Hn),h=i.dot(Hn);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var Ue=new I,Wa=new it,h0=0,Ne=class extends Ii{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:h0++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Pu,this.updateRanges=[],this.gpuType=wi,this.version=0,this._normalizationScale=t!==void 0?Xl(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Wa.fromBufferAttribute(this,e),Wa.applyMatrix3(t),this.setXY(e,Wa.x,Wa.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.applyMatrix3(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.applyMatrix4(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.applyNormalMatrix(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.transformDirection(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ou(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Uu(t,this.array)}};var Lr=class extends Ne{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Dr=class extends Ne{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ge=class extends Ne{constructor(t,e,i){super(new Float32Array(t),e,i)}},u0=new zi,fr=new I,kh=new I,an=class{constructor(t=new I,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):u0.setFromPoints(t).getCenter(i);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;fr.subVectors(t,this.center);let e=fr.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(fr,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(kh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(fr.copy(t.center).add(kh)),this.expandByPoint(fr.copy(t.center).sub(kh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},d0=0,bi=new pe,Bh=new Ke,Ms=new I,pi=new zi,pr=new zi,$e=new I,Me=class n extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:d0++}),this.uuid=dn(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Fg(t)?Dr:Lr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Wt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return bi.makeRotationFromQuaternion(t),this.applyMatrix4(bi),this}rotateX(t){return bi.makeRotationX(t),this.applyMatrix4(bi),this}rotateY(t){return bi.makeRotationY(t),this.applyMatrix4(bi),this}rotateZ(t){return bi.makeRotationZ(t),this.applyMatrix4(bi),this}translate(t,e,i){return bi.makeTranslation(t,e,i),this.applyMatrix4(bi),this}scale(t,e,i){return bi.makeScale(t,e,i),this.applyMatrix4(bi),this}lookAt(t){return Bh.lookAt(t),Bh.updateMatrix(),this.applyMatrix4(Bh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ms).negate(),this.translate(Ms.x,Ms.y,Ms.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new ge(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Ft("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){zt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];pi.setFromBufferAttribute(r),this.morphTargetsRelative?($e.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint($e),$e.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint($e)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&zt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new an);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){zt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(t){let i=this.boundingSphere.center;if(pi.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];pr.setFromBufferAttribute(o),this.morphTargetsRelative?($e.addVectors(pi.min,pr.min),pi.expandByPoint($e),$e.addVectors(pi.max,pr.max),pi.expandByPoint($e)):(pi.expandByPoint(pr.min),pi.expandByPoint(pr.max))}pi.getCenter(i);let s=0;for(let r=0,a=t.count;r<a;r++)$e.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared($e));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)$e.fromBufferAttribute(o,c),l&&(Ms.fromBufferAttribute(t,c),$e.add(Ms)),s=Math.max(s,i.distanceToSquared($e))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&zt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){zt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new Ne(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)o[U]=new I,l[U]=new I;let h=new I,u=new I,d=new I,f=new it,p=new it,v=new it,m=new I,g=new I;function M(U,P,D){c[U]=c[P]=c[D]=1,h.fromBufferAttribute(i,U),u.fromBufferAttribute(i,P),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,P),v.fromBufferAttribute(r,D),u.sub(h),d.sub(h),p.sub(f),v.sub(f);let F=1/(p.x*v.y-v.x*p.y);isFinite(F)&&(m.copy(u).multiplyScalar(v.y).addScaledVector(d,-p.y).multiplyScalar(F),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-v.x).multiplyScalar(F),o[U].add(m),o[P].add(m),o[D].add(m),l[U].add(g),l[P].add(g),l[D].add(g))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let U=0,P=w.length;U<P;++U){let D=w[U],F=D.start,X=D.count;for(let R=F,k=F+X;R<k;R+=3)M(t.getX(R+0),t.getX(R+1),t.getX(R+2))}let b=new I,C=new I,E=new I,_=new I;function T(U){E.fromBufferAttribute(s,U),_.copy(E);let P=o[U];b.copy(P),b.sub(E.multiplyScalar(E.dot(P))).normalize(),C.crossVectors(_,P);let F=C.dot(l[U])<0?-1:1;a.setXYZW(U,b.x,b.y,b.z,F)}for(let U=0,P=i.count;U<P;++U)c[U]&&T(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Ne(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new I,r=new I,a=new I,o=new I,l=new I,c=new I,h=new I,u=new I;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),v=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,v),a.fromBufferAttribute(e,m),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),o.fromBufferAttribute(i,p),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),o.add(h),l.add(h),c.add(h),i.setXYZ(p,o.x,o.y,o.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),a.fromBufferAttribute(e,d+2),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)$e.fromBufferAttribute(t,e),$e.normalize(),t.setXYZ(e,$e.x,$e.y,$e.z)}toNonIndexed(){function t(o,l){let c=o.array,h=o.itemSize,u=o.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let v=0,m=l.length;v<m;v++){o.isInterleavedBufferAttribute?f=l[v]*o.data.stride+o.offset:f=l[v]*h;for(let g=0;g<h;g++)d[p++]=c[f++]}return new Ne(d,h,u)}if(this.index===null)return Ft("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=t(l,i);e.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,i);l.push(f)}e.morphAttributes[o]=l}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let c=0,h=a.length;c<h;c++){let u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Io=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Pu,this.updateRanges=[],this.version=0,this.uuid=dn()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=pf(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=pf(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function pf(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=dn()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ri=new I,Or=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Xl(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ri.fromBufferAttribute(this,e),ri.applyMatrix4(t),this.setXYZ(e,ri.x,ri.y,ri.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ri.fromBufferAttribute(this,e),ri.applyNormalMatrix(t),this.setXYZ(e,ri.x,ri.y,ri.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ri.fromBufferAttribute(this,e),ri.transformDirection(t),this.setXYZ(e,ri.x,ri.y,ri.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Pr("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ne(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Pr("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ou(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Uu(t,this.data.array)}},zh=new I,f0=new I,p0=new Wt,gi=class{constructor(t=new I(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=zh.subVectors(i,e).cross(f0.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(zh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||p0.getNormalMatrix(t),s=this.coplanarPoint(zh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},m0=0,Gi=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:m0++}),this.uuid=dn(),this.name="",this.type="Material",this.blending=Ys,this.side=Pn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=uu,this.blendDst=du,this.blendEquation=es,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Nt(0,0,0),this.blendAlpha=0,this.depthFunc=Ls,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=dp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=xo,this.stencilZFail=xo,this.stencilZPass=xo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Ft(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Ft(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Nt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new gi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new it().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Bs=class extends Gi{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new Nt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Ss,mr=new I,ws=new I,Ts=new I,Es=new it,gr=new it,Sp=new pe,Xa=new I,xr=new I,$a=new I,mf=new it,Gh=new it,gf=new it,Ur=class extends Ke{constructor(t=new Bs){if(super(),this.isSprite=!0,this.type="Sprite",Ss===void 0){Ss=new Me;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Io(e,5);Ss.setIndex([0,1,2,0,2,3]),Ss.setAttribute("position",new Or(i,3,0,!1)),Ss.setAttribute("uv",new Or(i,2,3,!1))}this.geometry=Ss,this.material=t,this.center=new it(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&zt('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),ws.setFromMatrixScale(this.matrixWorld),Sp.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Ts.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&ws.multiplyScalar(-Ts.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let a=this.center;qa(Xa.set(-.5,-.5,0),Ts,a,ws,s,r),qa(xr.set(.5,-.5,0),Ts,a,ws,s,r),qa($a.set(.5,.5,0),Ts,a,ws,s,r),mf.set(0,0),Gh.set(1,0),gf.set(1,1);let o=t.ray.intersectTriangle(Xa,xr,$a,!1,mr);if(o===null&&(qa(xr.set(-.5,.5,0),Ts,a,ws,s,r),Gh.set(0,1),o=t.ray.intersectTriangle(Xa,$a,xr,!1,mr),o===null))return;let l=t.ray.origin.distanceTo(mr);l<t.near||l>t.far||e.push({distance:l,point:mr.clone(),uv:ki.getInterpolation(mr,Xa,xr,$a,mf,Gh,gf,new it),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function qa(n,t,e,i,s,r){Es.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(gr.x=r*Es.x-s*Es.y,gr.y=s*Es.x+r*Es.y):gr.copy(Es),n.copy(t),n.x+=gr.x,n.y+=gr.y,n.applyMatrix4(Sp)}var en=new I,Vh=new I,Ya=new I,Za=new I,Yn=class{constructor(t=new I,e=new I(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,en)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=en.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(en.copy(this.origin).addScaledVector(this.direction,e),en.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Vh.copy(t).add(e).multiplyScalar(.5),Ya.copy(e).sub(t).normalize(),Za.copy(this.origin).sub(Vh);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Ya),o=Za.dot(this.direction),l=-Za.dot(Ya),c=Za.lengthSq(),h=Math.abs(1-a*a),u,d,f,p;if(h>0)if(u=a*l-o,d=a*o-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let v=1/h;u*=v,d*=v,f=u*(u+a*d+2*o)+d*(a*u+d+2*l)+c}else d=r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-a*r+o)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(a*r+o)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=a>0?-r:r,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Vh).addScaledVector(Ya,d),f}intersectSphere(t,e){if(t.radius<0)return null;en.subVectors(t.center,this.origin);let i=en.dot(this.direction),s=en.dot(en)-i*i,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,a=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,a=(t.min.y-d.y)*h),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),u>=0?(o=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(o=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||o>s)||((o>i||i!==i)&&(i=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,en)!==null}intersectTriangle(t,e,i,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,u=t.x-a.x,d=t.y-a.y,f=t.z-a.z,p=e.x-a.x,v=e.y-a.y,m=e.z-a.z,g=i.x-a.x,M=i.y-a.y,w=i.z-a.z,b=Math.abs(l),C=Math.abs(c),E=Math.abs(h),_,T,U,P,D,F,X,R,k,W,V,nt;if(b>=C&&b>=E?(U=l,F=u,k=p,nt=g,l>=0?(_=c,T=h,P=d,D=f,X=v,R=m,W=M,V=w):(_=h,T=c,P=f,D=d,X=m,R=v,W=w,V=M)):C>=E?(U=c,F=d,k=v,nt=M,c>=0?(_=h,T=l,P=f,D=u,X=m,R=p,W=w,V=g):(_=l,T=h,P=u,D=f,X=p,R=m,W=g,V=w)):(U=h,F=f,k=m,nt=w,h>=0?(_=l,T=c,P=u,D=d,X=p,R=v,W=g,V=M):(_=c,T=l,P=d,D=u,X=v,R=p,W=M,V=g)),U===0)return null;let $=_/U,Q=T/U,et=1/U,wt=P-$*F,kt=D-Q*F,Y=X-$*k,_t=R-Q*k,Tt=W-$*nt,Dt=V-Q*nt,vt=Tt*_t-Dt*Y,Ot=wt*Dt-kt*Tt,Se=Y*kt-_t*wt;if(s){if(vt<0||Ot<0||Se<0)return null}else if((vt<0||Ot<0||Se<0)&&(vt>0||Ot>0||Se>0))return null;let Bt=vt+Ot+Se;if(Bt===0)return null;let Jt=et*(vt*F+Ot*k+Se*nt);return(Bt>0?Jt<0:Jt>0)?null:this.at(Jt/Bt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Vi=class extends Gi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rn,this.combine=nl,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},xf=new pe,Wn=new Yn,ja=new an,_f=new I,Ka=new I,Ja=new I,Qa=new I,Hh=new I,to=new I,vf=new I,eo=new I,Pe=class extends Ke{constructor(t=new Me,e=new Vi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){to.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],u=r[l];h!==0&&(Hh.fromBufferAttribute(u,t),a?to.addScaledVector(Hh,h):to.addScaledVector(Hh.sub(e),h))}e.add(to)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ja.copy(i.boundingSphere),ja.applyMatrix4(r),Wn.copy(t.ray).recast(t.near),!(ja.containsPoint(Wn.origin)===!1&&(Wn.intersectSphere(ja,_f)===null||Wn.origin.distanceToSquared(_f)>(t.far-t.near)**2))&&(xf.copy(r).invert(),Wn.copy(t.ray).applyMatrix4(xf),!(i.boundingBox!==null&&Wn.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Wn)))}_computeIntersections(t,e,i){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let p=0,v=d.length;p<v;p++){let m=d[p],g=a[m.materialIndex],M=Math.max(m.start,f.start),w=Math.min(o.count,Math.min(m.start+m.count,f.start+f.count));for(let b=M,C=w;b<C;b+=3){let E=o.getX(b),_=o.getX(b+1),T=o.getX(b+2);s=io(this,g,t,i,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(o.count,f.start+f.count);for(let m=p,g=v;m<g;m+=3){let M=o.getX(m),w=o.getX(m+1),b=o.getX(m+2);s=io(this,a,t,i,c,h,u,M,w,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let p=0,v=d.length;p<v;p++){let m=d[p],g=a[m.materialIndex],M=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=M,C=w;b<C;b+=3){let E=b,_=b+1,T=b+2;s=io(this,g,t,i,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let m=p,g=v;m<g;m+=3){let M=m,w=m+1,b=m+2;s=io(this,a,t,i,c,h,u,M,w,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function g0(n,t,e,i,s,r,a,o){let l;if(t.side===ke?l=i.intersectTriangle(a,r,s,!0,o):l=i.intersectTriangle(s,r,a,t.side===Pn,o),l===null)return null;eo.copy(o),eo.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(eo);return c<e.near||c>e.far?null:{distance:c,point:eo.clone(),object:n}}function io(n,t,e,i,s,r,a,o,l,c){n.getVertexPosition(o,Ka),n.getVertexPosition(l,Ja),n.getVertexPosition(c,Qa);let h=g0(n,t,e,i,Ka,Ja,Qa,vf);if(h){let u=new I;ki.getBarycoord(vf,Ka,Ja,Qa,u),s&&(h.uv=ki.getInterpolatedAttribute(s,o,l,c,u,new it)),r&&(h.uv1=ki.getInterpolatedAttribute(r,o,l,c,u,new it)),a&&(h.normal=ki.getInterpolatedAttribute(a,o,l,c,u,new I),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a:o,b:l,c,normal:new I,materialIndex:0};ki.getNormal(Ka,Ja,Qa,d.normal),h.face=d,h.barycoord=u}return h}var Fr=class extends oi{constructor(t=null,e=1,i=1,s,r,a,o,l,c=qe,h=qe,u,d){super(null,a,o,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zn=class extends Ne{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},As=new pe,yf=new pe,no=[],bf=new zi,x0=new pe,_r=new Pe,vr=new an,Hi=class extends Pe{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Zn(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,x0)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new zi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,As),bf.copy(t.boundingBox).applyMatrix4(As),this.boundingBox.union(bf)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new an),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,As),vr.copy(t.boundingSphere).applyMatrix4(As),this.boundingSphere.union(vr)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,a=t*r+1;for(let o=0;o<i.length;o++)i[o]=s[a+o]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(_r.geometry=this.geometry,_r.material=this.material,_r.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),vr.copy(this.boundingSphere),vr.applyMatrix4(i),t.ray.intersectsSphere(vr)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,As),yf.multiplyMatrices(i,As),_r.matrixWorld=yf,_r.raycast(t,no);for(let a=0,o=no.length;a<o;a++){let l=no[a];l.instanceId=r,l.object=this,e.push(l)}no.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Zn(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Fr(new Float32Array(s*this.count),s,this.count,hl,wi));let r=this.morphTexture.source.data.data,a=0;for(let c=0;c<i.length;c++)a+=i[c];let o=this.geometry.morphTargetsRelative?1:1-a,l=s*t;return r[l]=o,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Xn=new an,_0=new it(.5,.5),so=new I,Tn=class{constructor(t=new gi,e=new gi,i=new gi,s=new gi,r=new gi,a=new gi){this.planes=[t,e,i,s,r,a]}set(t,e,i,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Mi,i=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],v=r[9],m=r[10],g=r[11],M=r[12],w=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-a,f-h,g-p,C-M).normalize(),s[1].setComponents(c+a,f+h,g+p,C+M).normalize(),s[2].setComponents(c+o,f+u,g+v,C+w).normalize(),s[3].setComponents(c-o,f-u,g-v,C-w).normalize(),i)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,g-m,C-b).normalize();else if(s[4].setComponents(c-l,f-d,g-m,C-b).normalize(),e===Mi)s[5].setComponents(c+l,f+d,g+m,C+b).normalize();else if(e===Ds)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Xn.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Xn.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Xn)}intersectsSprite(t){Xn.center.set(0,0,0);let e=_0.distanceTo(t.center);return Xn.radius=.7071067811865476+e,Xn.applyMatrix4(t.matrixWorld),this.intersectsSphere(Xn)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(so.x=s.normal.x>0?t.max.x:t.min.x,so.y=s.normal.y>0?t.max.y:t.min.y,so.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(so)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Mf=new pe,No=class n{constructor(){this.coordinateSystem=Mi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Mf.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Tn),i[s].setFromProjectionMatrix(Mf,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Tn),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var li=class extends Gi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Nt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Lo=new I,Do=new I,Sf=new pe,yr=new Yn,ro=new an,Wh=new I,wf=new I,zs=class extends Ke{constructor(t=new Me,e=new li){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Lo.fromBufferAttribute(e,s-1),Do.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Lo.distanceTo(Do);t.setAttribute("lineDistance",new ge(i,1))}else Ft("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ro.copy(i.boundingSphere),ro.applyMatrix4(s),ro.radius+=r,t.ray.intersectsSphere(ro)===!1)return;Sf.copy(s).invert(),yr.copy(t.ray).applyMatrix4(Sf);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,a.start),p=Math.min(h.count,a.start+a.count);for(let v=f,m=p-1;v<m;v+=c){let g=h.getX(v),M=h.getX(v+1),w=ao(this,t,yr,l,g,M,v);w&&e.push(w)}if(this.isLineLoop){let v=h.getX(p-1),m=h.getX(f),g=ao(this,t,yr,l,v,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,a.start),p=Math.min(d.count,a.start+a.count);for(let v=f,m=p-1;v<m;v+=c){let g=ao(this,t,yr,l,v,v+1,v);g&&e.push(g)}if(this.isLineLoop){let v=ao(this,t,yr,l,p-1,f,p-1);v&&e.push(v)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function ao(n,t,e,i,s,r,a){let o=n.geometry.attributes.position;if(Lo.fromBufferAttribute(o,s),Do.fromBufferAttribute(o,r),e.distanceSqToSegment(Lo,Do,Wh,wf)>i)return;Wh.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Wh);if(!(c<t.near||c>t.far))return{distance:c,point:wf.clone().applyMatrix4(n.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:n}}var Tf=new I,Ef=new I,Si=class extends zs{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Tf.fromBufferAttribute(e,s),Ef.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Tf.distanceTo(Ef);t.setAttribute("lineDistance",new ge(i,1))}else Ft("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var kr=class extends oi{constructor(t=[],e=is,i,s,r,a,o,l,c,h){super(t,e,i,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Br=class extends oi{constructor(t,e,i,s,r,a,o,l,c){super(t,e,i,s,r,a,o,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var on=class extends oi{constructor(t,e,i=Ni,s,r,a,o=qe,l=qe,c,h=sn,u=1){if(h!==sn&&h!==hn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,a,o,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Fs(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},zr=class extends on{constructor(t,e=Ni,i=is,s,r,a=qe,o=qe,l,c=sn){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,a,o,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Gr=class extends oi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},En=class n extends Me{constructor(t=1,e=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,a,r,0),p("z","y","x",1,-1,i,e,-t,a,r,1),p("x","z","y",1,1,t,i,e,s,a,2),p("x","z","y",1,-1,t,i,-e,s,a,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ge(c,3)),this.setAttribute("normal",new ge(h,3)),this.setAttribute("uv",new ge(u,2));function p(v,m,g,M,w,b,C,E,_,T,U){let P=b/_,D=C/T,F=b/2,X=C/2,R=E/2,k=_+1,W=T+1,V=0,nt=0,$=new I;for(let Q=0;Q<W;Q++){let et=Q*D-X;for(let wt=0;wt<k;wt++){let kt=wt*P-F;$[v]=kt*M,$[m]=et*w,$[g]=R,c.push($.x,$.y,$.z),$[v]=0,$[m]=0,$[g]=E>0?1:-1,h.push($.x,$.y,$.z),u.push(wt/_),u.push(1-Q/T),V+=1}}for(let Q=0;Q<T;Q++)for(let et=0;et<_;et++){let wt=d+et+k*Q,kt=d+et+k*(Q+1),Y=d+(et+1)+k*(Q+1),_t=d+(et+1)+k*Q;l.push(wt,kt,_t),l.push(kt,Y,_t),nt+=6}o.addGroup(f,nt,U),f+=nt,d+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ln=class n extends Me{constructor(t=1,e=1,i=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,v=[],m=i/2,g=0;M(),a===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new ge(u,3)),this.setAttribute("normal",new ge(d,3)),this.setAttribute("uv",new ge(f,2));function M(){let b=new I,C=new I,E=0,_=(e-t)/i;for(let T=0;T<=r;T++){let U=[],P=T/r,D=P*(e-t)+t;for(let F=0;F<=s;F++){let X=F/s,R=X*l+o,k=Math.sin(R),W=Math.cos(R);C.x=D*k,C.y=-P*i+m,C.z=D*W,u.push(C.x,C.y,C.z),b.set(k,_,W).normalize(),d.push(b.x,b.y,b.z),f.push(X,1-P),U.push(p++)}v.push(U)}for(let T=0;T<s;T++)for(let U=0;U<r;U++){let P=v[U][T],D=v[U+1][T],F=v[U+1][T+1],X=v[U][T+1];(t>0||U!==0)&&(h.push(P,D,X),E+=3),(e>0||U!==r-1)&&(h.push(D,F,X),E+=3)}c.addGroup(g,E,0),g+=E}function w(b){let C=p,E=new it,_=new I,T=0,U=b===!0?t:e,P=b===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,m*P,0),d.push(0,P,0),f.push(.5,.5),p++;let D=p;for(let F=0;F<=s;F++){let R=F/s*l+o,k=Math.cos(R),W=Math.sin(R);_.x=U*W,_.y=m*P,_.z=U*k,u.push(_.x,_.y,_.z),d.push(0,P,0),E.x=k*.5+.5,E.y=W*.5*P+.5,f.push(E.x,E.y),p++}for(let F=0;F<s;F++){let X=C+F,R=D+F;b===!0?h.push(R,R+1,X):h.push(R+1,R,X),T+=3}c.addGroup(g,T,b===!0?1:2),g+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Gs=class n extends ln{constructor(t=1,e=1,i=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,i,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Oo=class n extends Me{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],a=[];o(s),c(i),h(),this.setAttribute("position",new ge(r,3)),this.setAttribute("normal",new ge(r.slice(),3)),this.setAttribute("uv",new ge(a,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function o(M){let w=new I,b=new I,C=new I;for(let E=0;E<e.length;E+=3)f(e[E+0],w),f(e[E+1],b),f(e[E+2],C),l(w,b,C,M)}function l(M,w,b,C){let E=C+1,_=[];for(let T=0;T<=E;T++){_[T]=[];let U=M.clone().lerp(b,T/E),P=w.clone().lerp(b,T/E),D=E-T;for(let F=0;F<=D;F++)F===0&&T===E?_[T][F]=U:_[T][F]=U.clone().lerp(P,F/D)}for(let T=0;T<E;T++)for(let U=0;U<2*(E-T)-1;U++){let P=Math.floor(U/2);U%2===0?(d(_[T][P+1]),d(_[T+1][P]),d(_[T][P])):(d(_[T][P+1]),d(_[T+1][P+1]),d(_[T+1][P]))}}function c(M){let w=new I;for(let b=0;b<r.length;b+=3)w.x=r[b+0],w.y=r[b+1],w.z=r[b+2],w.normalize().multiplyScalar(M),r[b+0]=w.x,r[b+1]=w.y,r[b+2]=w.z}function h(){let M=new I;for(let w=0;w<r.length;w+=3){M.x=r[w+0],M.y=r[w+1],M.z=r[w+2];let b=m(M)/2/Math.PI+.5,C=g(M)/Math.PI+.5;a.push(b,1-C)}p(),u()}function u(){for(let M=0;M<a.length;M+=6){let w=a[M+0],b=a[M+2],C=a[M+4],E=Math.max(w,b,C),_=Math.min(w,b,C);E>.9&&_<.1&&(w<.2&&(a[M+0]+=1),b<.2&&(a[M+2]+=1),C<.2&&(a[M+4]+=1))}}function d(M){r.push(M.x,M.y,M.z)}function f(M,w){let b=M*3;w.x=t[b+0],w.y=t[b+1],w.z=t[b+2]}function p(){let M=new I,w=new I,b=new I,C=new I,E=new it,_=new it,T=new it;for(let U=0,P=0;U<r.length;U+=9,P+=6){M.set(r[U+0],r[U+1],r[U+2]),w.set(r[U+3],r[U+4],r[U+5]),b.set(r[U+6],r[U+7],r[U+8]),E.set(a[P+0],a[P+1]),_.set(a[P+2],a[P+3]),T.set(a[P+4],a[P+5]),C.copy(M).add(w).add(b).divideScalar(3);let D=m(C);v(E,P+0,M,D),v(_,P+2,w,D),v(T,P+4,b,D)}}function v(M,w,b,C){C<0&&M.x===1&&(a[w]=M.x-1),b.x===0&&b.z===0&&(a[w]=C/2/Math.PI+.5)}function m(M){return Math.atan2(M.z,-M.x)}function g(M){return Math.atan2(-M.y,Math.sqrt(M.x*M.x+M.z*M.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var oo=new I,lo=new I,Xh=new I,co=new ki,Vr=class extends Me{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Is*e),a=t.getIndex(),o=t.getAttribute("position"),l=a?a.count:o.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){a?(c[0]=a.getX(p),c[1]=a.getX(p+1),c[2]=a.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:v,b:m,c:g}=co;if(v.fromBufferAttribute(o,c[0]),m.fromBufferAttribute(o,c[1]),g.fromBufferAttribute(o,c[2]),co.getNormal(Xh),u[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let M=0;M<3;M++){let w=(M+1)%3,b=u[M],C=u[w],E=co[h[M]],_=co[h[w]],T=`${b}_${C}`,U=`${C}_${b}`,P=d.get(U);P?(Xh.dot(P.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(_.x,_.y,_.z)),d.set(U,null)):d.has(T)||d.set(T,{index0:c[M],index1:c[w],normal:Xh.clone()})}}for(let p of d.values())if(p){let{index0:v,index1:m}=p;oo.fromBufferAttribute(o,v),lo.fromBufferAttribute(o,m),f.push(oo.x,oo.y,oo.z),f.push(lo.x,lo.y,lo.z)}this.setAttribute("position",new ge(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},_i=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ft("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,s=this.getPoint(0),r=0;e.push(0);for(let a=1;a<=t;a++)i=this.getPoint(a/t),r+=i.distanceTo(s),e.push(r),s=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),s=0,r=i.length,a;e?a=e:a=t*i[r-1];let o=0,l=r-1,c;for(;o<=l;)if(s=Math.floor(o+(l-o)/2),c=i[s]-a,c<0)o=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,i[s]===a)return s/(r-1);let h=i[s],d=i[s+1]-h,f=(a-h)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let a=this.getPoint(s),o=this.getPoint(r),l=e||(a.isVector2?new it:new I);return l.copy(o).sub(a).normalize(),l}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new I,s=[],r=[],a=[],o=new I,l=new pe;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new I)}r[0]=new I,a[0]=new I;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,i.set(1,0,0)),u<=c&&(c=u,i.set(0,1,0)),d<=c&&i.set(0,0,1),o.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],o),a[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),a[f]=a[f-1].clone(),o.crossVectors(s[f-1],s[f]),o.length()>Number.EPSILON){o.normalize();let p=Math.acos(jt(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(o,p))}a[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(jt(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(o.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),a[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Vs=class extends _i{constructor(t=0,e=0,i=1,s=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(t,e=new it){let i=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(a?r=0:r=s),this.aClockwise===!0&&!a&&(r===s?r=-s:r=r-s);let o=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return i.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Uo=class extends Vs{constructor(t,e,i,s,r,a){super(t,e,i,i,s,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function ku(){let n=0,t=0,e=0,i=0;function s(r,a,o,l){n=r,t=o,e=-3*r+3*a-2*o-l,i=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){s(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,h,u){let d=(a-r)/c-(o-r)/(c+h)+(o-a)/h,f=(o-a)/h-(l-a)/(h+u)+(l-o)/u;d*=h,f*=h,s(a,o,d,f)},calc:function(r){let a=r*r,o=a*r;return n+t*r+e*a+i*o}}}var Af=new I,Cf=new I,$h=new ku,qh=new ku,Yh=new ku,Fo=class extends _i{constructor(t=[],e=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=s}getPoint(t,e=new I){let i=e,s=this.points,r=s.length,a=(r-(this.closed?0:1))*t,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,h;this.closed||o>0?c=s[(o-1)%r]:(Cf.subVectors(s[0],s[1]).add(s[0]),c=Cf);let u=s[o%r],d=s[(o+1)%r];if(this.closed||o+2<r?h=s[(o+2)%r]:(Af.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Af),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),v=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);v<1e-4&&(v=1),p<1e-4&&(p=v),m<1e-4&&(m=v),$h.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,v,m),qh.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,v,m),Yh.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,v,m)}else this.curveType==="catmullrom"&&($h.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),qh.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Yh.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return i.set($h.calc(l),qh.calc(l),Yh.calc(l)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new I().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Rf(n,t,e,i,s){let r=(i-t)*.5,a=(s-e)*.5,o=n*n,l=n*o;return(2*e-2*i+r+a)*l+(-3*e+3*i-2*r-a)*o+r*n+e}function v0(n,t){let e=1-n;return e*e*t}function y0(n,t){return 2*(1-n)*n*t}function b0(n,t){return n*n*t}function wr(n,t,e,i){return v0(n,t)+y0(n,e)+b0(n,i)}function M0(n,t){let e=1-n;return e*e*e*t}function S0(n,t){let e=1-n;return 3*e*e*n*t}function w0(n,t){return 3*(1-n)*n*n*t}function T0(n,t){return n*n*n*t}function Tr(n,t,e,i,s){return M0(n,t)+S0(n,e)+w0(n,i)+T0(n,s)}var Hr=class extends _i{constructor(t=new it,e=new it,i=new it,s=new it){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new it){let i=e,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set(Tr(t,s.x,r.x,a.x,o.x),Tr(t,s.y,r.y,a.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},ko=class extends _i{constructor(t=new I,e=new I,i=new I,s=new I){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new I){let i=e,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set(Tr(t,s.x,r.x,a.x,o.x),Tr(t,s.y,r.y,a.y,o.y),Tr(t,s.z,r.z,a.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Wr=class extends _i{constructor(t=new it,e=new it){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new it){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new it){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Bo=class extends _i{constructor(t=new I,e=new I){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new I){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new I){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Xr=class extends _i{constructor(t=new it,e=new it,i=new it){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new it){let i=e,s=this.v0,r=this.v1,a=this.v2;return i.set(wr(t,s.x,r.x,a.x),wr(t,s.y,r.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},zo=class extends _i{constructor(t=new I,e=new I,i=new I){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new I){let i=e,s=this.v0,r=this.v1,a=this.v2;return i.set(wr(t,s.x,r.x,a.x),wr(t,s.y,r.y,a.y),wr(t,s.z,r.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},$r=class extends _i{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new it){let i=e,s=this.points,r=(s.length-1)*t,a=Math.floor(r),o=r-a,l=s[a===0?a:a-1],c=s[a],h=s[a>s.length-2?s.length-1:a+1],u=s[a>s.length-3?s.length-1:a+2];return i.set(Rf(o,l.x,c.x,h.x,u.x),Rf(o,l.y,c.y,h.y,u.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new it().fromArray(s))}return this}},tu=Object.freeze({__proto__:null,ArcCurve:Uo,CatmullRomCurve3:Fo,CubicBezierCurve:Hr,CubicBezierCurve3:ko,EllipseCurve:Vs,LineCurve:Wr,LineCurve3:Bo,QuadraticBezierCurve:Xr,QuadraticBezierCurve3:zo,SplineCurve:$r}),Go=class extends _i{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let i=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new tu[i](e,t))}return this}getPoint(t,e){let i=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=i){let a=s[r]-i,o=this.curves[r],l=o.getLength(),c=l===0?0:1-a/l;return o.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let i=0,s=this.curves.length;i<s;i++)e+=this.curves[i].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],i;for(let s=0,r=this.curves;s<r.length;s++){let a=r[s],o=a.isEllipseCurve?t*2:a.isLineCurve||a.isLineCurve3?1:a.isSplineCurve?t*a.points.length:t,l=a.getPoints(o);for(let c=0;c<l.length;c++){let h=l[c];i&&i.equals(h)||(e.push(h),i=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,i=this.curves.length;e<i;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(new tu[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},qr=class extends Go{constructor(t){super(),this.type="Path",this.currentPoint=new it,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,i=t.length;e<i;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let i=new Wr(this.currentPoint.clone(),new it(t,e));return this.curves.push(i),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,i,s){let r=new Xr(this.currentPoint.clone(),new it(t,e),new it(i,s));return this.curves.push(r),this.currentPoint.set(i,s),this}bezierCurveTo(t,e,i,s,r,a){let o=new Hr(this.currentPoint.clone(),new it(t,e),new it(i,s),new it(r,a));return this.curves.push(o),this.currentPoint.set(r,a),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),i=new $r(e);return this.curves.push(i),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,i,s,r,a){let o=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+o,e+l,i,s,r,a),this}absarc(t,e,i,s,r,a){return this.absellipse(t,e,i,i,s,r,a),this}ellipse(t,e,i,s,r,a,o,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,i,s,r,a,o,l),this}absellipse(t,e,i,s,r,a,o,l){let c=new Vs(t,e,i,s,r,a,o,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},Hs=class extends qr{constructor(t){super(t),this.uuid=dn(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let i=0,s=this.holes.length;i<s;i++)e[i]=this.holes[i].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,i=this.holes.length;e<i;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(new qr().fromJSON(s))}return this}};function E0(n,t,e=2){let i=t&&t.length,s=i?t[0]*e:n.length,r=wp(n,0,s,e,!0),a=[];if(!r||r.next===r.prev)return a;let o,l,c;if(i&&(r=I0(n,t,r,e)),n.length>80*e){o=n[0],l=n[1];let h=o,u=l;for(let d=e;d<s;d+=e){let f=n[d],p=n[d+1];f<o&&(o=f),p<l&&(l=p),f>h&&(h=f),p>u&&(u=p)}c=Math.max(h-o,u-l),c=c!==0?32767/c:0}return Yr(r,a,e,o,l,c,0),a}function wp(n,t,e,i,s){let r;if(s===V0(n,t,e,i)>0)for(let a=t;a<e;a+=i)r=Pf(a/i|0,n[a],n[a+1],r);else for(let a=e-i;a>=t;a-=i)r=Pf(a/i|0,n[a],n[a+1],r);return r&&Ws(r,r.next)&&(jr(r),r=r.next),r}function jn(n,t){if(!n)return n;t||(t=n);let e=n,i;do if(i=!1,!e.steiner&&(Ws(e,e.next)||Re(e.prev,e,e.next)===0)){if(jr(e),e=t=e.prev,e===e.next)break;i=!0}else e=e.next;while(i||e!==t);return t}function Yr(n,t,e,i,s,r,a){if(!n)return;!a&&r&&U0(n,i,s,r);let o=n;for(;n.prev!==n.next;){let l=n.prev,c=n.next;if(r?C0(n,i,s,r):A0(n)){t.push(l.i,n.i,c.i),jr(n),n=c.next,o=c.next;continue}if(n=c,n===o){a?a===1?(n=R0(jn(n),t),Yr(n,t,e,i,s,r,2)):a===2&&P0(n,t,e,i,s,r):Yr(jn(n),t,e,i,s,r,1);break}}}function A0(n){let t=n.prev,e=n,i=n.next;if(Re(t,e,i)>=0)return!1;let s=t.x,r=e.x,a=i.x,o=t.y,l=e.y,c=i.y,h=Math.min(s,r,a),u=Math.min(o,l,c),d=Math.max(s,r,a),f=Math.max(o,l,c),p=i.next;for(;p!==t;){if(p.x>=h&&p.x<=d&&p.y>=u&&p.y<=f&&br(s,o,r,l,a,c,p.x,p.y)&&Re(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function C0(n,t,e,i){let s=n.prev,r=n,a=n.next;if(Re(s,r,a)>=0)return!1;let o=s.x,l=r.x,c=a.x,h=s.y,u=r.y,d=a.y,f=Math.min(o,l,c),p=Math.min(h,u,d),v=Math.max(o,l,c),m=Math.max(h,u,d),g=eu(f,p,t,e,i),M=eu(v,m,t,e,i),w=n.prevZ,b=n.nextZ;for(;w&&w.z>=g&&b&&b.z<=M;){if(w.x>=f&&w.x<=v&&w.y>=p&&w.y<=m&&w!==s&&w!==a&&br(o,h,l,u,c,d,w.x,w.y)&&Re(w.prev,w,w.next)>=0||(w=w.prevZ,b.x>=f&&b.x<=v&&b.y>=p&&b.y<=m&&b!==s&&b!==a&&br(o,h,l,u,c,d,b.x,b.y)&&Re(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;w&&w.z>=g;){if(w.x>=f&&w.x<=v&&w.y>=p&&w.y<=m&&w!==s&&w!==a&&br(o,h,l,u,c,d,w.x,w.y)&&Re(w.prev,w,w.next)>=0)return!1;w=w.prevZ}for(;b&&b.z<=M;){if(b.x>=f&&b.x<=v&&b.y>=p&&b.y<=m&&b!==s&&b!==a&&br(o,h,l,u,c,d,b.x,b.y)&&Re(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function R0(n,t){let e=n;do{let i=e.prev,s=e.next.next;!Ws(i,s)&&Ep(i,e,e.next,s)&&Zr(i,s)&&Zr(s,i)&&(t.push(i.i,e.i,s.i),jr(e),jr(e.next),e=n=s),e=e.next}while(e!==n);return jn(e)}function P0(n,t,e,i,s,r){let a=n;do{let o=a.next.next;for(;o!==a.prev;){if(a.i!==o.i&&B0(a,o)){let l=Ap(a,o);a=jn(a,a.next),l=jn(l,l.next),Yr(a,t,e,i,s,r,0),Yr(l,t,e,i,s,r,0);return}o=o.next}a=a.next}while(a!==n)}function I0(n,t,e,i){let s=[];for(let r=0,a=t.length;r<a;r++){let o=t[r]*i,l=r<a-1?t[r+1]*i:n.length,c=wp(n,o,l,i,!1);c===c.next&&(c.steiner=!0),s.push(k0(c))}s.sort(N0);for(let r=0;r<s.length;r++)e=L0(s[r],e);return e}function N0(n,t){let e=n.x-t.x;if(e===0&&(e=n.y-t.y,e===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=i-s}return e}function L0(n,t){let e=D0(n,t);if(!e)return t;let i=Ap(e,n);return jn(i,i.next),jn(e,e.next)}function D0(n,t){let e=t,i=n.x,s=n.y,r=-1/0,a;if(Ws(n,e))return e;do{if(Ws(n,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let u=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(u<=i&&u>r&&(r=u,a=e.x<e.next.x?e:e.next,u===i))return a}e=e.next}while(e!==t);if(!a)return null;let o=a,l=a.x,c=a.y,h=1/0;e=a;do{if(i>=e.x&&e.x>=l&&i!==e.x&&Tp(s<c?i:r,s,l,c,s<c?r:i,s,e.x,e.y)){let u=Math.abs(s-e.y)/(i-e.x);Zr(e,n)&&(u<h||u===h&&(e.x>a.x||e.x===a.x&&O0(a,e)))&&(a=e,h=u)}e=e.next}while(e!==o);return a}function O0(n,t){return Re(n.prev,n,t.prev)<0&&Re(t.next,n,n.next)<0}function U0(n,t,e,i){let s=n;do s.z===0&&(s.z=eu(s.x,s.y,t,e,i)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==n);s.prevZ.nextZ=null,s.prevZ=null,F0(s)}function F0(n){let t,e=1;do{let i=n,s;n=null;let r=null;for(t=0;i;){t++;let a=i,o=0;for(let c=0;c<e&&(o++,a=a.nextZ,!!a);c++);let l=e;for(;o>0||l>0&&a;)o!==0&&(l===0||!a||i.z<=a.z)?(s=i,i=i.nextZ,o--):(s=a,a=a.nextZ,l--),r?r.nextZ=s:n=s,s.prevZ=r,r=s;i=a}r.nextZ=null,e*=2}while(t>1);return n}function eu(n,t,e,i,s){return n=(n-e)*s|0,t=(t-i)*s|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,n|t<<1}function k0(n){let t=n,e=n;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==n);return e}function Tp(n,t,e,i,s,r,a,o){return(s-a)*(t-o)>=(n-a)*(r-o)&&(n-a)*(i-o)>=(e-a)*(t-o)&&(e-a)*(r-o)>=(s-a)*(i-o)}function br(n,t,e,i,s,r,a,o){return!(n===a&&t===o)&&Tp(n,t,e,i,s,r,a,o)}function B0(n,t){return n.next.i!==t.i&&n.prev.i!==t.i&&!z0(n,t)&&(Zr(n,t)&&Zr(t,n)&&G0(n,t)&&(Re(n.prev,n,t.prev)||Re(n,t.prev,t))||Ws(n,t)&&Re(n.prev,n,n.next)>0&&Re(t.prev,t,t.next)>0)}function Re(n,t,e){return(t.y-n.y)*(e.x-t.x)-(t.x-n.x)*(e.y-t.y)}function Ws(n,t){return n.x===t.x&&n.y===t.y}function Ep(n,t,e,i){let s=uo(Re(n,t,e)),r=uo(Re(n,t,i)),a=uo(Re(e,i,n)),o=uo(Re(e,i,t));return!!(s!==r&&a!==o||s===0&&ho(n,e,t)||r===0&&ho(n,i,t)||a===0&&ho(e,n,i)||o===0&&ho(e,t,i))}function ho(n,t,e){return t.x<=Math.max(n.x,e.x)&&t.x>=Math.min(n.x,e.x)&&t.y<=Math.max(n.y,e.y)&&t.y>=Math.min(n.y,e.y)}function uo(n){return n>0?1:n<0?-1:0}function z0(n,t){let e=n;do{if(e.i!==n.i&&e.next.i!==n.i&&e.i!==t.i&&e.next.i!==t.i&&Ep(e,e.next,n,t))return!0;e=e.next}while(e!==n);return!1}function Zr(n,t){return Re(n.prev,n,n.next)<0?Re(n,t,n.next)>=0&&Re(n,n.prev,t)>=0:Re(n,t,n.prev)<0||Re(n,n.next,t)<0}function G0(n,t){let e=n,i=!1,s=(n.x+t.x)/2,r=(n.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(i=!i),e=e.next;while(e!==n);return i}function Ap(n,t){let e=iu(n.i,n.x,n.y),i=iu(t.i,t.x,t.y),s=n.next,r=t.prev;return n.next=t,t.prev=n,e.next=s,s.prev=e,i.next=e,e.prev=i,r.next=i,i.prev=r,i}function Pf(n,t,e,i){let s=iu(n,t,e);return i?(s.next=i.next,s.prev=i,i.next.prev=s,i.next=s):(s.prev=s,s.next=s),s}function jr(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function iu(n,t,e){return{i:n,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function V0(n,t,e,i){let s=0;for(let r=t,a=e-i;r<e;r+=i)s+=(n[a]-n[r])*(n[r+1]+n[a+1]),a=r;return s}var nu=class{static triangulate(t,e,i=2){return E0(t,e,i)}},$n=class n{static area(t){let e=t.length,i=0;for(let s=e-1,r=0;r<e;s=r++)i+=t[s].x*t[r].y-t[r].x*t[s].y;return i*.5}static isClockWise(t){return n.area(t)<0}static triangulateShape(t,e){let i=[],s=[],r=[];If(t),Nf(i,t);let a=t.length;e.forEach(If);for(let l=0;l<e.length;l++)s.push(a),a+=e[l].length,Nf(i,e[l]);let o=nu.triangulate(i,s);for(let l=0;l<o.length;l+=3)r.push(o.slice(l,l+3));return r}};function If(n){let t=n.length;t>2&&n[t-1].equals(n[0])&&n.pop()}function Nf(n,t){for(let e=0;e<t.length;e++)n.push(t[e].x),n.push(t[e].y)}var Kr=class n extends Me{constructor(t=new Hs([new it(.5,.5),new it(-.5,.5),new it(-.5,-.5),new it(.5,-.5)]),e={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:t,options:e},t=Array.isArray(t)?t:[t];let i=this,s=[],r=[];for(let o=0,l=t.length;o<l;o++){let c=t[o];a(c)}this.setAttribute("position",new ge(s,3)),this.setAttribute("uv",new ge(r,2)),this.computeVertexNormals();function a(o){let l=[],c=e.curveSegments!==void 0?e.curveSegments:12,h=e.steps!==void 0?e.steps:1,u=e.depth!==void 0?e.depth:1,d=e.bevelEnabled!==void 0?e.bevelEnabled:!0,f=e.bevelThickness!==void 0?e.bevelThickness:.2,p=e.bevelSize!==void 0?e.bevelSize:f-.1,v=e.bevelOffset!==void 0?e.bevelOffset:0,m=e.bevelSegments!==void 0?e.bevelSegments:3,g=e.extrudePath,M=e.UVGenerator!==void 0?e.UVGenerator:H0,w,b=!1,C,E,_,T;if(g){w=g.getSpacedPoints(h),b=!0,d=!1;let tt=g.isCatmullRomCurve3?g.closed:!1;C=g.computeFrenetFrames(h,tt),E=new I,_=new I,T=new I}d||(m=0,f=0,p=0,v=0);let U=o.extractPoints(c),P=U.shape,D=U.holes;if(!$n.isClockWise(P)){P=P.reverse();for(let tt=0,ht=D.length;tt<ht;tt++){let ot=D[tt];$n.isClockWise(ot)&&(D[tt]=ot.reverse())}}function X(tt){let ot=10000000000000001e-36,St=tt[0];for(let xt=1;xt<=tt.length;xt++){let qt=xt%tt.length,Pt=tt[qt],ie=Pt.x-St.x,ne=Pt.y-St.y,le=ie*ie+ne*ne,O=Math.max(Math.abs(Pt.x),Math.abs(Pt.y),Math.abs(St.x),Math.abs(St.y)),De=ot*O*O;if(le<=De){tt.splice(qt,1),xt--;continue}St=Pt}}X(P),D.forEach(X);let R=D.length,k=P;for(let tt=0;tt<R;tt++){let ht=D[tt];P=P.concat(ht)}function W(tt,ht,ot){return ht||zt("ExtrudeGeometry: vec does not exist"),tt.clone().addScaledVector(ht,ot)}let V=P.length;function nt(tt,ht,ot){let St,xt,qt,Pt=tt.x-ht.x,ie=tt.y-ht.y,ne=ot.x-tt.x,le=ot.y-tt.y,O=Pt*Pt+ie*ie,De=Pt*le-ie*ne;if(Math.abs(De)>Number.EPSILON){let te=Math.sqrt(O),_e=Math.sqrt(ne*ne+le*le),pt=ht.x-ie/te,Ie=ht.y+Pt/te,Ut=ot.x-le/_e,Vt=ot.y+ne/_e,A=((Ut-pt)*le-(Vt-Ie)*ne)/(Pt*le-ie*ne);St=pt+Pt*A-tt.x,xt=Ie+ie*A-tt.y;let y=St*St+xt*xt;if(y<=2)return new it(St,xt);qt=Math.sqrt(y/2)}else{let te=!1;Pt>Number.EPSILON?ne>Number.EPSILON&&(te=!0):Pt<-Number.EPSILON?ne<-Number.EPSILON&&(te=!0):Math.sign(ie)===Math.sign(le)&&(te=!0),te?(St=-ie,xt=Pt,qt=Math.sqrt(O)):(St=Pt,xt=ie,qt=Math.sqrt(O/2))}return new it(St/qt,xt/qt)}let $=[];for(let tt=0,ht=k.length,ot=ht-1,St=tt+1;tt<ht;tt++,ot++,St++)ot===ht&&(ot=0),St===ht&&(St=0),$[tt]=nt(k[tt],k[ot],k[St]);let Q=[],et,wt=$.concat();for(let tt=0,ht=R;tt<ht;tt++){let ot=D[tt];et=[];for(let St=0,xt=ot.length,qt=xt-1,Pt=St+1;St<xt;St++,qt++,Pt++)qt===xt&&(qt=0),Pt===xt&&(Pt=0),et[St]=nt(ot[St],ot[qt],ot[Pt]);Q.push(et),wt=wt.concat(et)}let kt;if(m===0)kt=$n.triangulateShape(k,D);else{let tt=[],ht=[];for(let ot=0;ot<m;ot++){let St=ot/m,xt=f*Math.cos(St*Math.PI/2),qt=p*Math.sin(St*Math.PI/2)+v;for(let Pt=0,ie=k.length;Pt<ie;Pt++){let ne=W(k[Pt],$[Pt],qt);Ot(ne.x,ne.y,-xt),St===0&&tt.push(ne)}for(let Pt=0,ie=R;Pt<ie;Pt++){let ne=D[Pt];et=Q[Pt];let le=[];for(let O=0,De=ne.length;O<De;O++){let te=W(ne[O],et[O],qt);Ot(te.x,te.y,-xt),St===0&&le.push(te)}St===0&&ht.push(le)}}kt=$n.triangulateShape(tt,ht)}let Y=kt.length,_t=p+v;for(let tt=0;tt<V;tt++){let ht=d?W(P[tt],wt[tt],_t):P[tt];b?(_.copy(C.normals[0]).multiplyScalar(ht.x),E.copy(C.binormals[0]).multiplyScalar(ht.y),T.copy(w[0]).add(_).add(E),Ot(T.x,T.y,T.z)):Ot(ht.x,ht.y,0)}for(let tt=1;tt<=h;tt++)for(let ht=0;ht<V;ht++){let ot=d?W(P[ht],wt[ht],_t):P[ht];b?(_.copy(C.normals[tt]).multiplyScalar(ot.x),E.copy(C.binormals[tt]).multiplyScalar(ot.y),T.copy(w[tt]).add(_).add(E),Ot(T.x,T.y,T.z)):Ot(ot.x,ot.y,u/h*tt)}for(let tt=m-1;tt>=0;tt--){let ht=tt/m,ot=f*Math.cos(ht*Math.PI/2),St=p*Math.sin(ht*Math.PI/2)+v;for(let xt=0,qt=k.length;xt<qt;xt++){let Pt=W(k[xt],$[xt],St);Ot(Pt.x,Pt.y,u+ot)}for(let xt=0,qt=D.length;xt<qt;xt++){let Pt=D[xt];et=Q[xt];for(let ie=0,ne=Pt.length;ie<ne;ie++){let le=W(Pt[ie],et[ie],St);b?Ot(le.x,le.y+w[h-1].y,w[h-1].x+ot):Ot(le.x,le.y,u+ot)}}}Tt(),Dt();function Tt(){let tt=s.length/3;if(d){let ht=0,ot=V*ht;for(let St=0;St<Y;St++){let xt=kt[St];Se(xt[2]+ot,xt[1]+ot,xt[0]+ot)}ht=h+m*2,ot=V*ht;for(let St=0;St<Y;St++){let xt=kt[St];Se(xt[0]+ot,xt[1]+ot,xt[2]+ot)}}else{for(let ht=0;ht<Y;ht++){let ot=kt[ht];Se(ot[2],ot[1],ot[0])}for(let ht=0;ht<Y;ht++){let ot=kt[ht];Se(ot[0]+V*h,ot[1]+V*h,ot[2]+V*h)}}i.addGroup(tt,s.length/3-tt,0)}function Dt(){let tt=s.length/3,ht=0;vt(k,ht),ht+=k.length;for(let ot=0,St=D.length;ot<St;ot++){let xt=D[ot];vt(xt,ht),ht+=xt.length}i.addGroup(tt,s.length/3-tt,1)}function vt(tt,ht){let ot=tt.length;for(;--ot>=0;){let St=ot,xt=ot-1;xt<0&&(xt=tt.length-1);for(let qt=0,Pt=h+m*2;qt<Pt;qt++){let ie=V*qt,ne=V*(qt+1),le=ht+St+ie,O=ht+xt+ie,De=ht+xt+ne,te=ht+St+ne;Bt(le,O,De,te)}}}function Ot(tt,ht,ot){l.push(tt),l.push(ht),l.push(ot)}function Se(tt,ht,ot){Jt(tt),Jt(ht),Jt(ot);let St=s.length/3,xt=M.generateTopUV(i,s,St-3,St-2,St-1);ee(xt[0]),ee(xt[1]),ee(xt[2])}function Bt(tt,ht,ot,St){Jt(tt),Jt(ht),Jt(St),Jt(ht),Jt(ot),Jt(St);let xt=s.length/3,qt=M.generateSideWallUV(i,s,xt-6,xt-3,xt-2,xt-1);ee(qt[0]),ee(qt[1]),ee(qt[3]),ee(qt[1]),ee(qt[2]),ee(qt[3])}function Jt(tt){s.push(l[tt*3+0]),s.push(l[tt*3+1]),s.push(l[tt*3+2])}function ee(tt){r.push(tt.x),r.push(tt.y)}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes,i=this.parameters.options;return W0(e,i,t)}static fromJSON(t,e){let i=[];for(let r=0,a=t.shapes.length;r<a;r++){let o=e[t.shapes[r]];i.push(o)}let s=t.options.extrudePath;return s!==void 0&&(t.options.extrudePath=new tu[s.type]().fromJSON(s)),new n(i,t.options)}},H0={generateTopUV:function(n,t,e,i,s){let r=t[e*3],a=t[e*3+1],o=t[i*3],l=t[i*3+1],c=t[s*3],h=t[s*3+1];return[new it(r,a),new it(o,l),new it(c,h)]},generateSideWallUV:function(n,t,e,i,s,r){let a=t[e*3],o=t[e*3+1],l=t[e*3+2],c=t[i*3],h=t[i*3+1],u=t[i*3+2],d=t[s*3],f=t[s*3+1],p=t[s*3+2],v=t[r*3],m=t[r*3+1],g=t[r*3+2];return Math.abs(o-h)<Math.abs(a-c)?[new it(a,1-l),new it(c,1-u),new it(d,1-p),new it(v,1-g)]:[new it(o,1-l),new it(h,1-u),new it(f,1-p),new it(m,1-g)]}};function W0(n,t,e){if(e.shapes=[],Array.isArray(n))for(let i=0,s=n.length;i<s;i++){let r=n[i];e.shapes.push(r.uuid)}else e.shapes.push(n.uuid);return e.options=Object.assign({},t),t.extrudePath!==void 0&&(e.options.extrudePath=t.extrudePath.toJSON()),e}var Kn=class n extends Oo{constructor(t=1,e=0){let i=(1+Math.sqrt(5))/2,s=[-1,i,0,1,i,0,-1,-i,0,1,-i,0,0,-1,i,0,1,i,0,-1,-i,0,1,-i,i,0,-1,i,0,1,-i,0,-1,-i,0,1],r=[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1];super(s,r,t,e),this.type="IcosahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}};var Jr=class n extends Me{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(i),l=Math.floor(s),c=o+1,h=l+1,u=t/o,d=e/l,f=[],p=[],v=[],m=[];for(let g=0;g<h;g++){let M=g*d-a;for(let w=0;w<c;w++){let b=w*u-r;p.push(b,-M,0),v.push(0,0,1),m.push(w/o),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let M=0;M<o;M++){let w=M+c*g,b=M+c*(g+1),C=M+1+c*(g+1),E=M+1+c*g;f.push(w,b,E),f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new ge(p,3)),this.setAttribute("normal",new ge(v,3)),this.setAttribute("uv",new ge(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Qr=class n extends Me{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new I,f=new I,p=new I;for(let v=0;v<=i;v++){let m=a+v/i*o;for(let g=0;g<=s;g++){let M=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(M),f.y=(t+e*Math.cos(m))*Math.sin(M),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),d.x=t*Math.cos(M),d.y=t*Math.sin(M),p.subVectors(f,d).normalize(),h.push(p.x,p.y,p.z),u.push(g/s),u.push(v/i)}}for(let v=1;v<=i;v++)for(let m=1;m<=s;m++){let g=(s+1)*v+m-1,M=(s+1)*(v-1)+m-1,w=(s+1)*(v-1)+m,b=(s+1)*v+m;l.push(g,M,b),l.push(M,w,b)}this.setIndex(l),this.setAttribute("position",new ge(c,3)),this.setAttribute("normal",new ge(h,3)),this.setAttribute("uv",new ge(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function ss(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Lf(s))s.isRenderTargetTexture?(Ft("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Lf(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function ni(n){let t={};for(let e=0;e<n.length;e++){let i=ss(n[e]);for(let s in i)t[s]=i[s]}return t}function Lf(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function X0(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Bu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ae.workingColorSpace}var Cp={clone:ss,merge:ni},$0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,q0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Wi=class extends Gi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=$0,this.fragmentShader=q0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ss(t.uniforms),this.uniformsGroups=X0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Nt().setHex(s.value);break;case"v2":this.uniforms[i].value=new it().fromArray(s.value);break;case"v3":this.uniforms[i].value=new I().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ae().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Wt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new pe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Vo=class extends Wi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ci=class extends Gi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Nt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Nt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Wl,this.normalScale=new it(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rn,this.combine=nl,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Ho=class extends Gi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=hp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Wo=class extends Gi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Cs(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function fo(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var An=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let a;e:{n:if(!(t<s)){for(let o=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===o)break;if(r=s,s=e[++i],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(i=2,r=o);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}a=i,i=0;break e}break i}for(;i<a;){let o=i+a>>>1;t<e[o]?a=o:i=o+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=i[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Xo=class extends An{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Kh,endingEnd:Kh}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Jh:r=t,o=2*e-i;break;case Qh:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Jh:a=t,l=2*i-e;break;case Qh:a=1,l=i+s[1]-s[0];break;default:a=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-o),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),v=p*p,m=v*p,g=-d*m+2*d*v-d*p,M=(1+d)*m+(-1.5-2*d)*v+(-.5+d)*p+1,w=(-1-f)*m+(1.5+f)*v+.5*p,b=f*m-f*v;for(let C=0;C!==o;++C)r[C]=g*a[h+C]+M*a[c+C]+w*a[l+C]+b*a[u+C];return r}},$o=class extends An{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==o;++d)r[d]=a[c+d]*u+a[l+d]*h;return r}},qo=class extends An{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Yo=class extends An{interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(i-e)/(s-e),v=1-p;for(let m=0;m!==o;++m)r[m]=a[c+m]*v+a[l+m]*p;return r}let d=o*2,f=t-1;for(let p=0;p!==o;++p){let v=a[c+p],m=a[l+p],g=f*d+p*2,M=u[g],w=u[g+1],b=t*d+p*2,C=h[b],E=h[b+1],_=Z0(i,e,M,C,s);r[p]=Rp(_,v,w,E,m)}return r}};function Rp(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Y0(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Z0(n,t,e,i,s){let r=(n-t)/(s-t);for(let a=0;a<8;a++){let o=Rp(r,t,e,i,s)-n;if(Math.abs(o)<1e-10)break;let l=Y0(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var vi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Cs(e,this.TimeBufferType),this.values=Cs(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Cs(t.times,Array),values:Cs(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),fo(t.settings)&&(i.settings={inTangents:Cs(t.settings.inTangents,Array),outTangents:Cs(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new qo(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new $o(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Xo(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Yo(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Er:e=this.InterpolantFactoryMethodDiscrete;break;case Ao:e=this.InterpolantFactoryMethodLinear;break;case go:e=this.InterpolantFactoryMethodSmooth;break;case jh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ft("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Er;case this.InterpolantFactoryMethodLinear:return Ao;case this.InterpolantFactoryMethodSmooth:return go;case this.InterpolantFactoryMethodBezier:return jh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;fo(this.settings)&&(Df(this.settings.inTangents,t),Df(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;fo(this.settings)&&(Of(this.settings.inTangents,t),Of(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,a=s-1;for(;r!==s&&i[r]<t;)++r;for(;a!==-1&&i[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=i.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(zt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(zt("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let l=i[o];if(typeof l=="number"&&isNaN(l)){zt("KeyframeTrack: Time is not a valid number.",this,o,l),t=!1;break}if(a!==null&&a>l){zt("KeyframeTrack: Out of order keys.",this,o,l,a),t=!1;break}a=l}if(s!==void 0&&kg(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){zt("KeyframeTrack: Value is not a valid number.",this,o,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===go,r=t.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=t[o],h=t[o+1];if(c!==h&&(o!==1||c!==t[0]))if(s)l=!0;else{let u=o*i,d=u-i,f=u+i;for(let p=0;p!==i;++p){let v=e[u+p];if(v!==e[d+p]||v!==e[f+p]){l=!0;break}}}if(l){if(o!==a){t[a]=t[o];let u=o*i,d=a*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++a}}if(r>0){t[a]=t[r];for(let o=r*i,l=a*i,c=0;c!==i;++c)e[l+c]=e[o+c];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,fo(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Df(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Of(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}vi.prototype.ValueTypeName="";vi.prototype.TimeBufferType=Float32Array;vi.prototype.ValueBufferType=Float32Array;vi.prototype.DefaultInterpolation=Ao;var Cn=class extends vi{constructor(t,e,i){super(t,e,i)}};Cn.prototype.ValueTypeName="bool";Cn.prototype.ValueBufferType=Array;Cn.prototype.DefaultInterpolation=Er;Cn.prototype.InterpolantFactoryMethodLinear=void 0;Cn.prototype.InterpolantFactoryMethodSmooth=void 0;var Zo=class extends vi{constructor(t,e,i,s){super(t,e,i,s)}};Zo.prototype.ValueTypeName="color";var jo=class extends vi{constructor(t,e,i,s){super(t,e,i,s)}};jo.prototype.ValueTypeName="number";var Ko=class extends An{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(i-e)/(s-e),c=t*o;for(let h=c+o;c!==h;c+=4)je.slerpFlat(r,0,a,c-o,a,c,l);return r}},ta=class extends vi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Ko(this.times,this.values,this.getValueSize(),t)}};ta.prototype.ValueTypeName="quaternion";ta.prototype.InterpolantFactoryMethodSmooth=void 0;var Rn=class extends vi{constructor(t,e,i){super(t,e,i)}};Rn.prototype.ValueTypeName="string";Rn.prototype.ValueBufferType=Array;Rn.prototype.DefaultInterpolation=Er;Rn.prototype.InterpolantFactoryMethodLinear=void 0;Rn.prototype.InterpolantFactoryMethodSmooth=void 0;var Jo=class extends vi{constructor(t,e,i,s){super(t,e,i,s)}};Jo.prototype.ValueTypeName="vector";var Qo=class{constructor(t,e,i){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Pp=new Qo,tl=class{constructor(t){this.manager=t!==void 0?t:Pp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};tl.DEFAULT_MATERIAL_NAME="__DEFAULT";var ea=class extends Ke{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Nt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Zh=new pe,Uf=new I,Ff=new I,el=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new it(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new pe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Tn,this._frameExtents=new it(1,1),this._viewportCount=1,this._viewports=[new Ae(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Uf.setFromMatrixPosition(t.matrixWorld),e.position.copy(Uf),Ff.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Ff),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Zh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Zh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Ds||t.reversedDepth?e.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),e.multiply(Zh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},po=new I,mo=new je,Fi=new I,ia=class extends Ke{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pe,this.projectionMatrix=new pe,this.projectionMatrixInverse=new pe,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(po,mo,Fi),Fi.x===1&&Fi.y===1&&Fi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(po,mo,Fi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(po,mo,Fi),Fi.x===1&&Fi.y===1&&Fi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(po,mo,Fi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},wn=new I,kf=new it,Bf=new it,Ze=class extends ia{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Us*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Is*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Us*2*Math.atan(Math.tan(Is*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){wn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(wn.x,wn.y).multiplyScalar(-t/wn.z),wn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(wn.x,wn.y).multiplyScalar(-t/wn.z)}getViewSize(t,e){return this.getViewBounds(t,kf,Bf),e.subVectors(Bf,kf)}setViewOffset(t,e,i,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Is*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,e-=a.offsetY*i/c,s*=a.width/l,i*=a.height/c}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var na=class extends ia{constructor(t=-1,e=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,a=i+t,o=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},su=class extends el{constructor(){super(new na(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Jn=class extends ea{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ke.DEFAULT_UP),this.updateMatrix(),this.target=new Ke,this.shadow=new su}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Qn=class extends ea{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Rs=-90,Ps=1,Xs=class extends Ke{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Ze(Rs,Ps,t,e);s.layers=this.layers,this.add(s);let r=new Ze(Rs,Ps,t,e);r.layers=this.layers,this.add(r);let a=new Ze(Rs,Ps,t,e);a.layers=this.layers,this.add(a);let o=new Ze(Rs,Ps,t,e);o.layers=this.layers,this.add(o);let l=new Ze(Rs,Ps,t,e);l.layers=this.layers,this.add(l);let c=new Ze(Rs,Ps,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,a,o,l]=e;for(let c of e)this.remove(c);if(t===Mi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ds)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=v,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},il=class extends Ze{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var zu="\\[\\]\\.:\\/",j0=new RegExp("["+zu+"]","g"),Gu="[^"+zu+"]",K0="[^"+zu.replace("\\.","")+"]",J0=/((?:WC+[\/:])*)/.source.replace("WC",Gu),Q0=/(WCOD+)?/.source.replace("WCOD",K0),tx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Gu),ex=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Gu),ix=new RegExp("^"+J0+Q0+tx+ex+"$"),nx=["material","materials","bones","map"],ru=class{constructor(t,e,i){let s=i||we.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},we=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(j0,"")}static parseTrackName(t){let e=ix.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);nx.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let l=i(o.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Ft("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){zt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){zt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){zt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){zt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){zt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){zt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){zt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let a=t[s];if(a===void 0){let c=e.nodeName;zt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){zt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){zt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};we.Composite=ru;we.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};we.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};we.prototype.GetterByBindingType=[we.prototype._getValue_direct,we.prototype._getValue_array,we.prototype._getValue_arrayElement,we.prototype._getValue_toArray];we.prototype.SetterByBindingTypeAndVersioning=[[we.prototype._setValue_direct,we.prototype._setValue_direct_setNeedsUpdate,we.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[we.prototype._setValue_array,we.prototype._setValue_array_setNeedsUpdate,we.prototype._setValue_array_setMatrixWorldNeedsUpdate],[we.prototype._setValue_arrayElement,we.prototype._setValue_arrayElement_setNeedsUpdate,we.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[we.prototype._setValue_fromArray,we.prototype._setValue_fromArray_setNeedsUpdate,we.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var i1=new Float32Array(1);var $s=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=jt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(jt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var au=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var sa=class extends Si{constructor(t=10,e=10,i=4473924,s=8947848){i=new Nt(i),s=new Nt(s);let r=e/2,a=t/e,o=t/2,l=[],c=[];for(let d=0,f=0,p=-o;d<=e;d++,p+=a){l.push(-o,0,p,o,0,p),l.push(p,0,-o,p,0,o);let v=d===r?i:s;v.toArray(c,f),f+=3,v.toArray(c,f),f+=3,v.toArray(c,f),f+=3,v.toArray(c,f),f+=3}let h=new Me;h.setAttribute("position",new ge(l,3)),h.setAttribute("color",new ge(c,3));let u=new li({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var ra=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Vu(n,t,e,i){let s=sx(i);switch(e){case Tu:return n*t;case hl:return n*t/s.components*s.byteLength;case ul:return n*t/s.components*s.byteLength;case In:return n*t*2/s.components*s.byteLength;case dl:return n*t*2/s.components*s.byteLength;case Eu:return n*t*3/s.components*s.byteLength;case Di:return n*t*4/s.components*s.byteLength;case fl:return n*t*4/s.components*s.byteLength;case la:case ca:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ha:case ua:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ml:case xl:return Math.max(n,16)*Math.max(t,8)/4;case pl:case gl:return Math.max(n,8)*Math.max(t,8)/2;case _l:case vl:case bl:case Ml:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case yl:case da:case Sl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case wl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Tl:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case El:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Al:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Cl:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Rl:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Pl:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Il:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Nl:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Ll:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Dl:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Ol:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Ul:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Fl:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case kl:case Bl:case zl:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Gl:case Vl:return Math.ceil(n/4)*Math.ceil(t/4)*8;case fa:case Hl:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function sx(n){switch(n){case ui:case bu:return{byteLength:1,components:1};case js:case Mu:case Li:return{byteLength:2,components:1};case ll:case cl:return{byteLength:2,components:4};case Ni:case ol:case wi:return{byteLength:4,components:1};case Su:case wu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ft("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Jp(){let n=null,t=!1,e=null,i=null;function s(r,a){i=n.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function ax(n){let t=new WeakMap;function e(o,l){let c=o.array,h=o.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function i(o,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,o),u.length===0)n.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],v=u[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let v=u[f];n.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=t.get(o);l&&(n.deleteBuffer(l.buffer),t.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=t.get(o);if(c===void 0)t.set(o,e(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var ox=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,lx=`#ifdef USE_ALPHAHASH
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
#endif`,cx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,hx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ux=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,dx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,fx=`#ifdef USE_AOMAP
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
#endif`,px=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,mx=`#ifdef USE_BATCHING
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
#endif`,gx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,xx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,_x=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,vx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,yx=`#ifdef USE_IRIDESCENCE
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
#endif`,bx=`#ifdef USE_BUMPMAP
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
#endif`,Mx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Sx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,wx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Tx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ex=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ax=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Cx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Rx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Px=`#define PI 3.141592653589793
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
} // validated`,Ix=`vec3 transformedNormal = objectNormal;
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
#endif`,Nx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Lx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Dx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ox=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ux="gl_FragColor = linearToOutputTexel( gl_FragColor );",Fx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,kx=`#ifdef USE_ENVMAP
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
#endif`,Bx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,zx=`#ifdef USE_ENVMAP
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
#endif`,Gx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Vx=`#ifdef USE_ENVMAP
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
#endif`,Hx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Wx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Xx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,$x=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,qx=`#ifdef USE_GRADIENTMAP
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
}`,Yx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Zx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,jx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Kx=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Jx=`#ifdef USE_ENVMAP
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
#endif`,Qx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,t_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,e_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,i_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,n_=`PhysicalMaterial material;
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
#endif`,s_=`uniform sampler2D dfgLUT;
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
}`,r_=`
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
#endif`,a_=`#if defined( RE_IndirectDiffuse )
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
#endif`,o_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,l_=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,c_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,h_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,u_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,d_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,f_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,p_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,m_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,g_=`#if defined( USE_POINTS_UV )
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
#endif`,x_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,__=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,v_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,y_=`#if defined( USE_MORPHCOLORS )
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
#endif`,b_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,M_=`#ifdef USE_MORPHTARGETS
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
#endif`,S_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,w_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,T_=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,E_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,A_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,C_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,R_=`#ifdef USE_NORMALMAP
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
#endif`,P_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,I_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,N_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,L_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,D_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,O_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,U_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,F_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,k_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,B_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,z_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,G_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,V_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,H_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,W_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,X_=`float getShadowMask() {
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
}`,$_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,q_=`#ifdef USE_SKINNING
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
#endif`,Y_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Z_=`#ifdef USE_SKINNING
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
#endif`,j_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,K_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,J_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Q_=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,tv=`#ifdef USE_TRANSMISSION
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
#endif`,ev=`#ifdef USE_TRANSMISSION
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
#endif`,iv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,nv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,av=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,ov=`uniform sampler2D t2D;
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
}`,lv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cv=`uniform float backgroundBlurriness;
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
}`,hv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,uv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dv=`#include <common>
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
}`,fv=`#if DEPTH_PACKING == 3200
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
}`,pv=`#define DISTANCE
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
}`,mv=`#define DISTANCE
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
}`,gv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,xv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_v=`uniform float scale;
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
}`,vv=`uniform vec3 diffuse;
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
}`,yv=`#include <common>
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
}`,bv=`uniform vec3 diffuse;
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
}`,Mv=`#define LAMBERT
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
}`,Sv=`#define LAMBERT
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
}`,wv=`#define MATCAP
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
}`,Tv=`#define MATCAP
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
}`,Ev=`#define NORMAL
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
}`,Av=`#define NORMAL
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
}`,Cv=`#define PHONG
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
}`,Rv=`#define PHONG
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
}`,Pv=`#define STANDARD
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
}`,Iv=`#define STANDARD
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
}`,Nv=`#define TOON
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
}`,Lv=`#define TOON
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
}`,Dv=`uniform float size;
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
}`,Ov=`uniform vec3 diffuse;
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
}`,Uv=`#include <common>
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
}`,Fv=`uniform vec3 color;
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
}`,kv=`uniform float rotation;
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
}`,Bv=`uniform vec3 diffuse;
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
}`,Kt={alphahash_fragment:ox,alphahash_pars_fragment:lx,alphamap_fragment:cx,alphamap_pars_fragment:hx,alphatest_fragment:ux,alphatest_pars_fragment:dx,aomap_fragment:fx,aomap_pars_fragment:px,batching_pars_vertex:mx,batching_vertex:gx,begin_vertex:xx,beginnormal_vertex:_x,bsdfs:vx,iridescence_fragment:yx,bumpmap_pars_fragment:bx,clipping_planes_fragment:Mx,clipping_planes_pars_fragment:Sx,clipping_planes_pars_vertex:wx,clipping_planes_vertex:Tx,color_fragment:Ex,color_pars_fragment:Ax,color_pars_vertex:Cx,color_vertex:Rx,common:Px,defaultnormal_vertex:Ix,displacementmap_pars_vertex:Nx,displacementmap_vertex:Lx,emissivemap_fragment:Dx,emissivemap_pars_fragment:Ox,colorspace_fragment:Ux,colorspace_pars_fragment:Fx,envmap_fragment:kx,envmap_common_pars_fragment:Bx,envmap_pars_fragment:zx,envmap_pars_vertex:Gx,envmap_physical_pars_fragment:Jx,envmap_vertex:Vx,fog_vertex:Hx,fog_pars_vertex:Wx,fog_fragment:Xx,fog_pars_fragment:$x,gradientmap_pars_fragment:qx,lightmap_pars_fragment:Yx,lights_lambert_fragment:Zx,lights_lambert_pars_fragment:jx,lights_pars_begin:Kx,lights_toon_fragment:Qx,lights_toon_pars_fragment:t_,lights_phong_fragment:e_,lights_phong_pars_fragment:i_,lights_physical_fragment:n_,lights_physical_pars_fragment:s_,lights_fragment_begin:r_,lights_fragment_maps:a_,lights_fragment_end:o_,lightprobes_pars_fragment:l_,logdepthbuf_fragment:c_,logdepthbuf_pars_fragment:h_,logdepthbuf_pars_vertex:u_,logdepthbuf_vertex:d_,map_fragment:f_,map_pars_fragment:p_,map_particle_fragment:m_,map_particle_pars_fragment:g_,metalnessmap_fragment:x_,metalnessmap_pars_fragment:__,morphinstance_vertex:v_,morphcolor_vertex:y_,morphnormal_vertex:b_,morphtarget_pars_vertex:M_,morphtarget_vertex:S_,normal_fragment_begin:w_,normal_fragment_maps:T_,normal_pars_fragment:E_,normal_pars_vertex:A_,normal_vertex:C_,normalmap_pars_fragment:R_,clearcoat_normal_fragment_begin:P_,clearcoat_normal_fragment_maps:I_,clearcoat_pars_fragment:N_,iridescence_pars_fragment:L_,opaque_fragment:D_,packing:O_,premultiplied_alpha_fragment:U_,project_vertex:F_,dithering_fragment:k_,dithering_pars_fragment:B_,roughnessmap_fragment:z_,roughnessmap_pars_fragment:G_,shadowmap_pars_fragment:V_,shadowmap_pars_vertex:H_,shadowmap_vertex:W_,shadowmask_pars_fragment:X_,skinbase_vertex:$_,skinning_pars_vertex:q_,skinning_vertex:Y_,skinnormal_vertex:Z_,specularmap_fragment:j_,specularmap_pars_fragment:K_,tonemapping_fragment:J_,tonemapping_pars_fragment:Q_,transmission_fragment:tv,transmission_pars_fragment:ev,uv_pars_fragment:iv,uv_pars_vertex:nv,uv_vertex:sv,worldpos_vertex:rv,background_vert:av,background_frag:ov,backgroundCube_vert:lv,backgroundCube_frag:cv,cube_vert:hv,cube_frag:uv,depth_vert:dv,depth_frag:fv,distance_vert:pv,distance_frag:mv,equirect_vert:gv,equirect_frag:xv,linedashed_vert:_v,linedashed_frag:vv,meshbasic_vert:yv,meshbasic_frag:bv,meshlambert_vert:Mv,meshlambert_frag:Sv,meshmatcap_vert:wv,meshmatcap_frag:Tv,meshnormal_vert:Ev,meshnormal_frag:Av,meshphong_vert:Cv,meshphong_frag:Rv,meshphysical_vert:Pv,meshphysical_frag:Iv,meshtoon_vert:Nv,meshtoon_frag:Lv,points_vert:Dv,points_frag:Ov,shadow_vert:Uv,shadow_frag:Fv,sprite_vert:kv,sprite_frag:Bv},bt={common:{diffuse:{value:new Nt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Wt},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Wt}},envmap:{envMap:{value:null},envMapRotation:{value:new Wt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Wt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Wt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Wt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Wt},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Wt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Wt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Wt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Wt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Nt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Nt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0},uvTransform:{value:new Wt}},sprite:{diffuse:{value:new Nt(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Wt},alphaMap:{value:null},alphaMapTransform:{value:new Wt},alphaTest:{value:0}}},Zi={basic:{uniforms:ni([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:Kt.meshbasic_vert,fragmentShader:Kt.meshbasic_frag},lambert:{uniforms:ni([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)},envMapIntensity:{value:1}}]),vertexShader:Kt.meshlambert_vert,fragmentShader:Kt.meshlambert_frag},phong:{uniforms:ni([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)},specular:{value:new Nt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Kt.meshphong_vert,fragmentShader:Kt.meshphong_frag},standard:{uniforms:ni([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Kt.meshphysical_vert,fragmentShader:Kt.meshphysical_frag},toon:{uniforms:ni([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new Nt(0)}}]),vertexShader:Kt.meshtoon_vert,fragmentShader:Kt.meshtoon_frag},matcap:{uniforms:ni([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:Kt.meshmatcap_vert,fragmentShader:Kt.meshmatcap_frag},points:{uniforms:ni([bt.points,bt.fog]),vertexShader:Kt.points_vert,fragmentShader:Kt.points_frag},dashed:{uniforms:ni([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Kt.linedashed_vert,fragmentShader:Kt.linedashed_frag},depth:{uniforms:ni([bt.common,bt.displacementmap]),vertexShader:Kt.depth_vert,fragmentShader:Kt.depth_frag},normal:{uniforms:ni([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:Kt.meshnormal_vert,fragmentShader:Kt.meshnormal_frag},sprite:{uniforms:ni([bt.sprite,bt.fog]),vertexShader:Kt.sprite_vert,fragmentShader:Kt.sprite_frag},background:{uniforms:{uvTransform:{value:new Wt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Kt.background_vert,fragmentShader:Kt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Wt}},vertexShader:Kt.backgroundCube_vert,fragmentShader:Kt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Kt.cube_vert,fragmentShader:Kt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Kt.equirect_vert,fragmentShader:Kt.equirect_frag},distance:{uniforms:ni([bt.common,bt.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Kt.distance_vert,fragmentShader:Kt.distance_frag},shadow:{uniforms:ni([bt.lights,bt.fog,{color:{value:new Nt(0)},opacity:{value:1}}]),vertexShader:Kt.shadow_vert,fragmentShader:Kt.shadow_frag}};Zi.physical={uniforms:ni([Zi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Wt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Wt},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Wt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Wt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Wt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Wt},sheen:{value:0},sheenColor:{value:new Nt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Wt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Wt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Wt},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Wt},attenuationDistance:{value:0},attenuationColor:{value:new Nt(0)},specularColor:{value:new Nt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Wt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Wt},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Wt}}]),vertexShader:Kt.meshphysical_vert,fragmentShader:Kt.meshphysical_frag};var $l={r:0,b:0,g:0},zv=new pe,Qp=new Wt;Qp.set(-1,0,0,0,1,0,0,0,1);function Gv(n,t,e,i,s,r){let a=new Nt(0),o=s===!0?0:1,l,c,h=null,u=0,d=null;function f(M){let w=M.isScene===!0?M.background:null;if(w&&w.isTexture){let b=M.backgroundBlurriness>0;w=t.get(w,b)}return w}function p(M){let w=!1,b=f(M);b===null?m(a,o):b&&b.isColor&&(m(b,1),w=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(M,w){let b=f(w);b&&b.isCubeTexture?(c===void 0&&(c=new Pe(new En(1,1,1),new Wi({name:"BackgroundCubeMaterial",uniforms:ss(Zi.backgroundCube.uniforms),vertexShader:Zi.backgroundCube.vertexShader,fragmentShader:Zi.backgroundCube.fragmentShader,side:ke,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(zv.makeRotationFromEuler(w.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Qp),c.material.toneMapped=ae.getTransfer(b.colorSpace)!==fe,(h!==b||u!==b.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=n.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Pe(new Jr(2,2),new Wi({name:"BackgroundMaterial",uniforms:ss(Zi.background.uniforms),vertexShader:Zi.background.vertexShader,fragmentShader:Zi.background.fragmentShader,side:Pn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=ae.getTransfer(b.colorSpace)!==fe,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=n.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function m(M,w){M.getRGB($l,Bu(n)),e.buffers.color.setClear($l.r,$l.g,$l.b,w,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,w=1){a.set(M),o=w,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(M){o=M,m(a,o)},render:p,addToRenderList:v,dispose:g}}function Vv(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,a=!1;function o(D,F,X,R,k){let W=!1,V=u(D,R,X,F);r!==V&&(r=V,c(r.object)),W=f(D,R,X,k),W&&p(D,R,X,k),k!==null&&t.update(k,n.ELEMENT_ARRAY_BUFFER),(W||a)&&(a=!1,b(D,F,X,R),k!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(k).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function u(D,F,X,R){let k=R.wireframe===!0,W=i[F.id];W===void 0&&(W={},i[F.id]=W);let V=D.isInstancedMesh===!0?D.id:0,nt=W[V];nt===void 0&&(nt={},W[V]=nt);let $=nt[X.id];$===void 0&&($={},nt[X.id]=$);let Q=$[k];return Q===void 0&&(Q=d(l()),$[k]=Q),Q}function d(D){let F=[],X=[],R=[];for(let k=0;k<e;k++)F[k]=0,X[k]=0,R[k]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:X,attributeDivisors:R,object:D,attributes:{},index:null}}function f(D,F,X,R){let k=r.attributes,W=F.attributes,V=0,nt=X.getAttributes();for(let $ in nt)if(nt[$].location>=0){let et=k[$],wt=W[$];if(wt===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(wt=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(wt=D.instanceColor)),et===void 0||et.attribute!==wt||wt&&et.data!==wt.data)return!0;V++}return r.attributesNum!==V||r.index!==R}function p(D,F,X,R){let k={},W=F.attributes,V=0,nt=X.getAttributes();for(let $ in nt)if(nt[$].location>=0){let et=W[$];et===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(et=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(et=D.instanceColor));let wt={};wt.attribute=et,et&&et.data&&(wt.data=et.data),k[$]=wt,V++}r.attributes=k,r.attributesNum=V,r.index=R}function v(){let D=r.newAttributes;for(let F=0,X=D.length;F<X;F++)D[F]=0}function m(D){g(D,0)}function g(D,F){let X=r.newAttributes,R=r.enabledAttributes,k=r.attributeDivisors;X[D]=1,R[D]===0&&(n.enableVertexAttribArray(D),R[D]=1),k[D]!==F&&(n.vertexAttribDivisor(D,F),k[D]=F)}function M(){let D=r.newAttributes,F=r.enabledAttributes;for(let X=0,R=F.length;X<R;X++)F[X]!==D[X]&&(n.disableVertexAttribArray(X),F[X]=0)}function w(D,F,X,R,k,W,V){V===!0?n.vertexAttribIPointer(D,F,X,k,W):n.vertexAttribPointer(D,F,X,R,k,W)}function b(D,F,X,R){v();let k=R.attributes,W=X.getAttributes(),V=F.defaultAttributeValues;for(let nt in W){let $=W[nt];if($.location>=0){let Q=k[nt];if(Q===void 0&&(nt==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),nt==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let et=Q.normalized,wt=Q.itemSize,kt=t.get(Q);if(kt===void 0)continue;let Y=kt.buffer,_t=kt.type,Tt=kt.bytesPerElement,Dt=_t===n.INT||_t===n.UNSIGNED_INT||Q.gpuType===ol;if(Q.isInterleavedBufferAttribute){let vt=Q.data,Ot=vt.isInterleavedBuffer===!0?vt.stride:vt.itemSize,Se=Q.offset;if(vt.isInstancedInterleavedBuffer||vt.isInstancedBufferAttribute){for(let Bt=0;Bt<$.locationSize;Bt++)g($.location+Bt,vt.meshPerAttribute);D.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=vt.meshPerAttribute*vt.count)}else for(let Bt=0;Bt<$.locationSize;Bt++)m($.location+Bt);n.bindBuffer(n.ARRAY_BUFFER,Y);for(let Bt=0;Bt<$.locationSize;Bt++)w($.location+Bt,wt/$.locationSize,_t,et,Ot*Tt,(Se+wt/$.locationSize*Bt)*Tt,Dt)}else{if(Q.isInstancedBufferAttribute){for(let vt=0;vt<$.locationSize;vt++)g($.location+vt,Q.meshPerAttribute);D.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let vt=0;vt<$.locationSize;vt++)m($.location+vt);n.bindBuffer(n.ARRAY_BUFFER,Y);for(let vt=0;vt<$.locationSize;vt++)w($.location+vt,wt/$.locationSize,_t,et,wt*Tt,wt/$.locationSize*vt*Tt,Dt)}}else if(V!==void 0){let et=V[nt];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv($.location,et);break;case 3:n.vertexAttrib3fv($.location,et);break;case 4:n.vertexAttrib4fv($.location,et);break;default:n.vertexAttrib1fv($.location,et)}}}}M()}function C(){U();for(let D in i){let F=i[D];for(let X in F){let R=F[X];for(let k in R){let W=R[k];for(let V in W)h(W[V].object),delete W[V];delete R[k]}}delete i[D]}}function E(D){if(i[D.id]===void 0)return;let F=i[D.id];for(let X in F){let R=F[X];for(let k in R){let W=R[k];for(let V in W)h(W[V].object),delete W[V];delete R[k]}}delete i[D.id]}function _(D){for(let F in i){let X=i[F];for(let R in X){let k=X[R];if(k[D.id]===void 0)continue;let W=k[D.id];for(let V in W)h(W[V].object),delete W[V];delete k[D.id]}}}function T(D){for(let F in i){let X=i[F],R=D.isInstancedMesh===!0?D.id:0,k=X[R];if(k!==void 0){for(let W in k){let V=k[W];for(let nt in V)h(V[nt].object),delete V[nt];delete k[W]}delete X[R],Object.keys(X).length===0&&delete i[F]}}}function U(){P(),a=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:U,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:v,enableAttribute:m,disableUnusedAttributes:M}}function Hv(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function a(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function o(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Wv(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(_){return!(_!==Di&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(_){let T=_===Li&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ui&&_!==wi&&!T&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Ft("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Ft("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Ft("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),M=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:M,maxVaryings:w,maxFragmentUniforms:b,maxSamples:C,samples:E}}function Xv(n){let t=this,e=null,i=0,s=!1,r=!1,a=new gi,o=new Wt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,v=u.clipIntersection,m=u.clipShadows,g=n.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let M=r?0:i,w=M*4,b=g.clippingState||null;l.value=b,b=h(p,d,w,f);for(let C=0;C!==w;++C)b[C]=e[C];g.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,p){let v=u!==null?u.length:0,m=null;if(v!==0){if(m=l.value,p!==!0||m===null){let g=f+v*4,M=d.matrixWorldInverse;o.getNormalMatrix(M),(m===null||m.length<g)&&(m=new Float32Array(g));for(let w=0,b=f;w!==v;++w,b+=4)a.copy(u[w]).applyMatrix4(M,o),a.normal.toArray(m,b),m[b+3]=a.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}var ga=class extends xi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new kr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new En(5,5,5),r=new Wi({name:"CubemapFromEquirect",uniforms:ss(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ke,blending:ts});r.uniforms.tEquirect.value=e;let a=new Pe(s,r),o=e.minFilter;return e.minFilter===cn&&(e.minFilter=ai),new Xs(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,i,s);t.setRenderTarget(r)}},Ip=256,$v=3,qv=20,tm=256,em=16,Yv=3,Zv=new I,jv=new Nt,Yl=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Xs(1,10,null),this._boxMesh=new Pe(new En(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:a=256,position:o=Zv}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,v=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(t.background=l.getClearColor(jv));let m=new Xs(i,s,h);return m.position.copy(o),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=v,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Dp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Lp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Ip,Du(t))}_fromTexture(t,e){t.mapping===is||t.mapping===Zs?this._setSize(t.image.length===0?Ip:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Np(t,!1,!1),i=Math.log2(t)-$v;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Np(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===is||t.mapping===Zs?(this._cubemapMaterial===null&&(this._cubemapMaterial=Dp()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Lp()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Kv(),this._integrationMaterial=Jv());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/em);for(let a=0;a<=i;a++){let o=n.lodToRoughness(a,i);if(a>i-Yv)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let l=o>0?Math.log2(e)+.5*Math.log2(6/(tm*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Qv());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Np(n,t,e){return new ga(n,{minFilter:cn,generateMipmaps:t,type:Li,colorSpace:Ar,depthBuffer:e})}function xa(n,t,e){return new Wi({name:n,uniforms:t,vertexShader:Kt.cube_vert,fragmentShader:e,side:ke,blending:ts,depthTest:!1,depthWrite:!1})}function Kv(){return xa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${tm}u

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
	`)}function Jv(){return xa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:em}},`

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
	`)}function Qv(){return xa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${qv}
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
	`)}function Lp(){return xa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Dp(){return xa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function ty(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?a(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===sl||f===rl)if(t.has(d)){let p=t.get(d).texture;return o(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let v=new ga(p.height);return v.fromEquirectangularTexture(n,d),t.set(d,v),d.addEventListener("dispose",c),o(v.texture,d.mapping)}else return null}}return d}function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===sl||f===rl,v=f===is||f===Zs;if(p||v){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Yl(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let M=d.image;return p&&M&&M.height>0||v&&M&&l(M)?(i===null&&(i=new Yl(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function o(d,f){return f===sl?d.mapping=is:f===rl&&(d.mapping=Zs),d}function l(d){let f=0,p=6;for(let v=0;v<p;v++)d[v]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function ey(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Mr("WebGLRenderer: "+i+" extension not supported."),s}}}function iy(n,t,e,i){let s={},r=new WeakMap,a=new FinalizationRegistry(p=>delete s[p]);function o(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",o),delete s[p.id],a.unregister(p);let v=r.get(p);v&&(t.remove(v),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",o),s[v.id]=new WeakRef(v),a.register(v,v.id,v),e.memory.geometries++),v}function h(p){let v=p.attributes;for(let m in v)t.update(v[m],n.ARRAY_BUFFER)}function u(p){let v=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let M=v!==null?v.array.length:m.array.length/3-1,w=m.count>=65535?Dr:Lr,b=new w(Math.ceil(M/3)*6,1),C=b.array;if(v!==null){let _=v.array;g=v.version;for(let T=0,U=0;T<M;T+=3){let P=_[T+0],D=_[T+1],F=_[T+2];C[U++]=P,C[U++]=D,C[U++]=D,C[U++]=F,C[U++]=F,C[U++]=P}}else{g=m.version;for(let _=0,T=0;_<M;_+=3){let U=_+0,P=_+1,D=_+2;C[T++]=U,C[T++]=P,C[T++]=P,C[T++]=D,C[T++]=D,C[T++]=U}}b.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,b)}function d(p){let v=r.get(p);if(v){let m=p.index;m!==null&&v.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function ny(n,t,e){let i;function s(u){i=u}let r,a;function o(u){r=u.type,a=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*a),e.update(d,i,1)}function c(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*a,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let v=0;for(let m=0;m<f;m++)v+=d[m];e.update(v,i,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function sy(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(e.calls++,a){case n.TRIANGLES:e.triangles+=o*(r/3);break;case n.LINES:e.lines+=o*(r/2);break;case n.LINE_STRIP:e.lines+=o*(r-1);break;case n.LINE_LOOP:e.lines+=o*r;break;case n.POINTS:e.points+=o*r;break;default:zt("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function ry(n,t,e){let i=new WeakMap,s=new Ae;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(o);if(d===void 0||d.count!==u){let U=function(){_.dispose(),i.delete(o),o.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=o.morphAttributes.position!==void 0,p=o.morphAttributes.normal!==void 0,v=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],g=o.morphAttributes.normal||[],M=o.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),v===!0&&(w=3);let b=o.attributes.position.count*w,C=1;b>t.maxTextureSize&&(C=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let E=new Float32Array(b*C*4*u),_=new Ir(E,b,C,u);_.type=wi,_.needsUpdate=!0;let T=w*4;for(let P=0;P<u;P++){let D=m[P],F=g[P],X=M[P],R=b*C*4*P;for(let k=0;k<D.count;k++){let W=k*T;f===!0&&(s.fromBufferAttribute(D,k),E[R+W+0]=s.x,E[R+W+1]=s.y,E[R+W+2]=s.z,E[R+W+3]=0),p===!0&&(s.fromBufferAttribute(F,k),E[R+W+4]=s.x,E[R+W+5]=s.y,E[R+W+6]=s.z,E[R+W+7]=0),v===!0&&(s.fromBufferAttribute(X,k),E[R+W+8]=s.x,E[R+W+9]=s.y,E[R+W+10]=s.z,E[R+W+11]=X.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new it(b,C)},i.set(o,d),o.addEventListener("dispose",U)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,e);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function ay(n,t,e,i,s){let r=new WeakMap;function a(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var oy={[fu]:"LINEAR_TONE_MAPPING",[pu]:"REINHARD_TONE_MAPPING",[mu]:"CINEON_TONE_MAPPING",[gu]:"ACES_FILMIC_TONE_MAPPING",[_u]:"AGX_TONE_MAPPING",[vu]:"NEUTRAL_TONE_MAPPING",[xu]:"CUSTOM_TONE_MAPPING"};function ly(n,t,e,i,s,r){let a=new xi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new Me;h.setAttribute("position",new ge([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ge([0,2,0,0,2,0],2));let u=new Vo({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Pe(h,u),f=new na(-1,1,1,-1,0,1),p=null,v=null,m=!1,g,M=null,w=[],b=!1;this.setSize=function(C,E){a.setSize(C,E),o!==null&&o.setSize(C,E),l!==null&&l.setSize(C,E);for(let _=0;_<w.length;_++){let T=w[_];T.setSize&&T.setSize(C,E)}},this.setEffects=function(C){w=C,b=w.length>0&&w[0].isRenderPass===!0;let E=a.width,_=a.height;w.length>0&&o===null&&(o=new xi(E,_,{type:Li,depthBuffer:!1,stencilBuffer:!1}),l=new xi(E,_,{type:Li,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&w.some(U=>U.needsDepthTexture===!0);T!==(a.depthTexture!==null)&&(T===!0&&c===null&&(c=new on(E,_),r===!0&&(c.format=hn,c.type=ns)),a.dispose(),a.depthTexture=T?c:null,a.resolveDepthBuffer=T,a.storeMultisampledDepthBuffer=T);for(let U=0;U<w.length;U++){let P=w[U];P.setSize&&P.setSize(E,_),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,E){if(m||C.toneMapping===qi&&w.length===0)return!1;if(M=E,E!==null){let _=E.width,T=E.height;(a.width!==_||a.height!==T)&&this.setSize(_,T)}return b===!1&&C.setRenderTarget(a),g=C.toneMapping,C.toneMapping=qi,!0},this.hasRenderPass=function(){return b},this.end=function(C,E){C.toneMapping=g,m=!0;let _=a,T=o;for(let U=0;U<w.length;U++){let P=w[U];P.enabled!==!1&&(P.render(C,T,_,E),P.needsSwap!==!1&&(_=T,T=T===o?l:o))}if(p!==C.outputColorSpace||v!==C.toneMapping){p=C.outputColorSpace,v=C.toneMapping,u.defines={},ae.getTransfer(p)===fe&&(u.defines.SRGB_TRANSFER="");let U=oy[v];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(M),C.render(d,f),M=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var im=new oi,nm=new on(1,1),sm=new zr(1),rm=new Ir,am=new Po,om=new kr,Op=[],Up=[],Fp=new Float32Array(16),kp=new Float32Array(9),Bp=new Float32Array(4);function Js(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Op[s];if(r===void 0&&(r=new Float32Array(s),Op[s]=r),t!==0){i.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,n[a].toArray(r,o)}return r}function Be(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function ze(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function jl(n,t){let e=Up[t];e===void 0&&(e=new Int32Array(t),Up[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function cy(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function hy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;n.uniform2fv(this.addr,t),ze(e,t)}}function uy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Be(e,t))return;n.uniform3fv(this.addr,t),ze(e,t)}}function dy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;n.uniform4fv(this.addr,t),ze(e,t)}}function fy(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;Bp.set(i),n.uniformMatrix2fv(this.addr,!1,Bp),ze(e,i)}}function py(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;kp.set(i),n.uniformMatrix3fv(this.addr,!1,kp),ze(e,i)}}function my(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;Fp.set(i),n.uniformMatrix4fv(this.addr,!1,Fp),ze(e,i)}}function gy(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function xy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;n.uniform2iv(this.addr,t),ze(e,t)}}function _y(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Be(e,t))return;n.uniform3iv(this.addr,t),ze(e,t)}}function vy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;n.uniform4iv(this.addr,t),ze(e,t)}}function yy(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function by(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;n.uniform2uiv(this.addr,t),ze(e,t)}}function My(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Be(e,t))return;n.uniform3uiv(this.addr,t),ze(e,t)}}function Sy(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;n.uniform4uiv(this.addr,t),ze(e,t)}}function Kl(n){return n.version===0&&(n.compareFunction=Ru,n.needsUpdate=!0),n}function wy(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Kl(nm):r=im,e.setTexture2D(t||r,s)}function Ty(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||am,s)}function Ey(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Kl(sm):r=om,e.setTextureCube(t||r,s)}function Ay(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||rm,s)}function Cy(n){switch(n){case 5126:return cy;case 35664:return hy;case 35665:return uy;case 35666:return dy;case 35674:return fy;case 35675:return py;case 35676:return my;case 5124:case 35670:return gy;case 35667:case 35671:return xy;case 35668:case 35672:return _y;case 35669:case 35673:return vy;case 5125:return yy;case 36294:return by;case 36295:return My;case 36296:return Sy;case 35678:case 36198:case 36298:case 36306:case 35682:return wy;case 35679:case 36299:case 36307:return Ty;case 35680:case 36300:case 36308:case 36293:return Ey;case 36289:case 36303:case 36311:case 36292:return Ay}}function Ry(n,t){n.uniform1fv(this.addr,t)}function Py(n,t){let e=Js(t,this.size,2);n.uniform2fv(this.addr,e)}function Iy(n,t){let e=Js(t,this.size,3);n.uniform3fv(this.addr,e)}function Ny(n,t){let e=Js(t,this.size,4);n.uniform4fv(this.addr,e)}function Ly(n,t){let e=Js(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Dy(n,t){let e=Js(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Oy(n,t){let e=Js(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Uy(n,t){n.uniform1iv(this.addr,t)}function Fy(n,t){n.uniform2iv(this.addr,t)}function ky(n,t){n.uniform3iv(this.addr,t)}function By(n,t){n.uniform4iv(this.addr,t)}function zy(n,t){n.uniform1uiv(this.addr,t)}function Gy(n,t){n.uniform2uiv(this.addr,t)}function Vy(n,t){n.uniform3uiv(this.addr,t)}function Hy(n,t){n.uniform4uiv(this.addr,t)}function Wy(n,t,e){let i=this.cache,s=t.length,r=jl(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));let a;this.type===n.SAMPLER_2D_SHADOW?a=Kl(nm):a=im;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function Xy(n,t,e){let i=this.cache,s=t.length,r=jl(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||am,r[a])}function $y(n,t,e){let i=this.cache,s=t.length,r=jl(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));let a;this.type===n.SAMPLER_CUBE_SHADOW?a=Kl(sm):a=om;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function qy(n,t,e){let i=this.cache,s=t.length,r=jl(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||rm,r[a])}function Yy(n){switch(n){case 5126:return Ry;case 35664:return Py;case 35665:return Iy;case 35666:return Ny;case 35674:return Ly;case 35675:return Dy;case 35676:return Oy;case 5124:case 35670:return Uy;case 35667:case 35671:return Fy;case 35668:case 35672:return ky;case 35669:case 35673:return By;case 5125:return zy;case 36294:return Gy;case 36295:return Vy;case 36296:return Hy;case 35678:case 36198:case 36298:case 36306:case 35682:return Wy;case 35679:case 36299:case 36307:return Xy;case 35680:case 36300:case 36308:case 36293:return $y;case 36289:case 36303:case 36311:case 36292:return qy}}var Xu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Cy(e.type)}},$u=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Yy(e.type)}},qu=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],i)}}},Hu=/(\w+)(\])?(\[|\.)?/g;function zp(n,t){n.seq.push(t),n.map[t.id]=t}function Zy(n,t,e){let i=n.name,s=i.length;for(Hu.lastIndex=0;;){let r=Hu.exec(i),a=Hu.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){zp(e,c===void 0?new Xu(o,n,t):new $u(o,n,t));break}else{let u=e.map[o];u===void 0&&(u=new qu(o),zp(e,u)),e=u}}}var Ks=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){let o=t.getActiveUniform(e,a),l=t.getUniformLocation(e,o.name);Zy(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&i.push(a)}return i}};function Gp(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var jy=37297,Ky=0;function Jy(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;i.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return i.join(`
`)}var Vp=new Wt;function Qy(n){ae._getMatrix(Vp,ae.workingColorSpace,n);let t=`mat3( ${Vp.elements.map(e=>e.toFixed(4))} )`;switch(ae.getTransfer(n)){case Cr:return[t,"LinearTransferOETF"];case fe:return[t,"sRGBTransferOETF"];default:return Ft("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Hp(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+Jy(n.getShaderSource(t),o)}else return r}function tb(n,t){let e=Qy(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var eb={[fu]:"Linear",[pu]:"Reinhard",[mu]:"Cineon",[gu]:"ACESFilmic",[_u]:"AgX",[vu]:"Neutral",[xu]:"Custom"};function ib(n,t){let e=eb[t];return e===void 0?(Ft("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ql=new I;function nb(){ae.getLuminanceCoefficients(ql);let n=ql.x.toFixed(4),t=ql.y.toFixed(4),e=ql.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ma).join(`
`)}function rb(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function ab(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),a=r.name,o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:n.getAttribLocation(t,a),locationSize:o}}return e}function ma(n){return n!==""}function Wp(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Xp(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var ob=/^[ \t]*#include +<([\w\d./]+)>/gm;function Yu(n){return n.replace(ob,lb)}function lb(n,t){let e=Kt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Yu(e)}var cb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function $p(n){return n.replace(cb,hb)}function hb(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function qp(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var ub={[aa]:"SHADOWMAP_TYPE_PCF",[qs]:"SHADOWMAP_TYPE_VSM"};function db(n){return ub[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var fb={[Zs]:"ENVMAP_MODE_REFRACTION"};function pb(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":fb[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var mb={[nl]:"ENVMAP_BLENDING_MULTIPLY",[op]:"ENVMAP_BLENDING_MIX",[lp]:"ENVMAP_BLENDING_ADD"};function gb(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":mb[n.combine]||"ENVMAP_BLENDING_NONE"}function xb(n,t,e,i){let s=n.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,l=db(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=pb(e),u=gb(e),d=sb(e),f=rb(r),p=s.createProgram(),v,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(v=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ma).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ma).join(`
`),m.length>0&&(m+=`
`)):(v=[qp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ma).join(`
`),m=[qp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==qi?"#define TONE_MAPPING":"",e.toneMapping!==qi?Kt.tonemapping_pars_fragment:"",e.toneMapping!==qi?ib("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Kt.colorspace_pars_fragment,tb("linearToOutputTexel",e.outputColorSpace),nb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ma).join(`
`)),a=Yu(a),a=Wp(a,e),a=Xp(a,e),o=Yu(o),o=Wp(o,e),o=Xp(o,e),a=$p(a),o=$p(o),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",e.glslVersion===Nu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Nu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let M=g+v+a,w=g+m+o,b=Gp(s,s.VERTEX_SHADER,M),C=Gp(s,s.FRAGMENT_SHADER,w);s.attachShader(p,b),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(P){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(b)||"",X=s.getShaderInfoLog(C)||"",R=D.trim(),k=F.trim(),W=X.trim(),V=!0,nt=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,C);else{let $=Hp(s,b,"vertex"),Q=Hp(s,C,"fragment");zt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+R+`
`+$+`
`+Q)}else R!==""?Ft("WebGLProgram: Program Info Log:",R):(k===""||W==="")&&(nt=!1);nt&&(P.diagnostics={runnable:V,programLog:R,vertexShader:{log:k,prefix:v},fragmentShader:{log:W,prefix:m}})}s.deleteShader(b),s.deleteShader(C),_=new Ks(s,p),T=ab(s,p)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,jy)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Ky++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var _b=0,Zu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new ju(t),e.set(t,i)),i}},ju=class{constructor(t){this.id=_b++,this.code=t,this.usedTimes=0}};function vb(n){return n===In||n===da||n===fa}function yb(n,t,e,i,s,r){let a=new Nr,o=new Zu,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,T,U,P,D,F){let X=P.fog,R=D.geometry,k=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=t.get(_.envMap||k,W),nt=d[_.type],$=i.precision;_.precision!==null&&($=i.getMaxPrecision(_.precision),$!==_.precision&&Ft("WebGLProgram.getParameters:",_.precision,"not supported, using",$,"instead."));let Q=R.morphAttributes.position||R.morphAttributes.normal||R.morphAttributes.color,et=Q!==void 0?Q.length:0,wt=0;R.morphAttributes.position!==void 0&&(wt=1),R.morphAttributes.normal!==void 0&&(wt=2),R.morphAttributes.color!==void 0&&(wt=3);let kt,Y,_t,Tt;if(nt){let yt=Zi[nt];kt=yt.vertexShader,Y=yt.fragmentShader}else{kt=_.vertexShader,Y=_.fragmentShader;let yt=o.getVertexShaderStage(_),me=o.getFragmentShaderStage(_);o.update(_,yt,me),_t=yt.id,Tt=me.id}let Dt=n.getRenderTarget(),vt=n.state.buffers.depth.getReversed(),Ot=D.isInstancedMesh===!0,Se=D.isBatchedMesh===!0,Bt=!!_.map,Jt=!!_.matcap,ee=!!V,tt=ee&&V.isPMREMTexture===!0,ht=!!_.aoMap,ot=!!_.lightMap,St=!!_.bumpMap&&_.wireframe===!1,xt=!!_.normalMap,qt=!!_.displacementMap,Pt=!!_.emissiveMap,ie=!!_.metalnessMap,ne=!!_.roughnessMap,le=_.anisotropy>0,O=_.clearcoat>0,De=_.diffuseRoughness>0,te=_.dispersion>0,_e=_.retroreflectivity>0,pt=_.iridescence>0,Ie=_.sheen>0,Ut=_.transmission>0,Vt=le&&!!_.anisotropyMap,A=O&&!!_.clearcoatMap,y=O&&!!_.clearcoatNormalMap,z=O&&!!_.clearcoatRoughnessMap,st=De&&!!_.diffuseRoughnessMap,J=pt&&!!_.iridescenceMap,lt=pt&&!!_.iridescenceThicknessMap,mt=Ie&&!!_.sheenColorMap,Z=Ie&&!!_.sheenRoughnessMap,j=!!_.specularMap,ut=!!_.specularColorMap,N=!!_.specularIntensityMap,K=Ut&&!!_.transmissionMap,q=Ut&&!!_.thicknessMap,dt=!!_.gradientMap,at=!!_.alphaMap,ct=_.alphaTest>0,It=!!_.alphaHash,Zt=!!_.extensions,rt=qi;_.toneMapped&&(Dt===null||Dt.isXRRenderTarget===!0)&&(rt=n.toneMapping);let Lt=tt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Yt={shaderID:nt,shaderType:_.type,shaderName:_.name,vertexShader:kt,fragmentShader:Y,defines:_.defines,customVertexShaderID:_t,customFragmentShaderID:Tt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:$,batching:Se,batchingColor:Se&&D._colorsTexture!==null,instancing:Ot,instancingColor:Ot&&D.instanceColor!==null,instancingMorph:Ot&&D.morphTexture!==null,outputColorSpace:Dt===null?n.outputColorSpace:Dt.isXRRenderTarget===!0?Dt.texture.colorSpace:ae.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Bt,matcap:Jt,envMap:ee,envMapMode:ee&&V.mapping,envMapPMREM:tt,envMapMaxLod:tt?Lt.length-1:null,envMapSize:tt?Lt[0].width:null,aoMap:ht,lightMap:ot,bumpMap:St,normalMap:xt,displacementMap:qt,emissiveMap:Pt,normalMapObjectSpace:xt&&_.normalMapType===up,normalMapTangentSpace:xt&&_.normalMapType===Wl,packedNormalMap:xt&&_.normalMapType===Wl&&vb(_.normalMap.format),metalnessMap:ie,roughnessMap:ne,anisotropy:le,anisotropyMap:Vt,clearcoat:O,clearcoatMap:A,clearcoatNormalMap:y,clearcoatRoughnessMap:z,diffuseRoughness:De,diffuseRoughnessMap:st,dispersion:te,retroreflection:_e,iridescence:pt,iridescenceMap:J,iridescenceThicknessMap:lt,sheen:Ie,sheenColorMap:mt,sheenRoughnessMap:Z,specularMap:j,specularColorMap:ut,specularIntensityMap:N,transmission:Ut,transmissionMap:K,thicknessMap:q,gradientMap:dt,opaque:_.transparent===!1&&_.blending===Ys&&_.alphaToCoverage===!1,alphaMap:at,alphaTest:ct,alphaHash:It,combine:_.combine,mapUv:Bt&&f(_.map.channel),aoMapUv:ht&&f(_.aoMap.channel),lightMapUv:ot&&f(_.lightMap.channel),bumpMapUv:St&&f(_.bumpMap.channel),normalMapUv:xt&&f(_.normalMap.channel),displacementMapUv:qt&&f(_.displacementMap.channel),emissiveMapUv:Pt&&f(_.emissiveMap.channel),metalnessMapUv:ie&&f(_.metalnessMap.channel),roughnessMapUv:ne&&f(_.roughnessMap.channel),anisotropyMapUv:Vt&&f(_.anisotropyMap.channel),clearcoatMapUv:A&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:y&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:st&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:J&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:lt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:mt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(_.sheenRoughnessMap.channel),specularMapUv:j&&f(_.specularMap.channel),specularColorMapUv:ut&&f(_.specularColorMap.channel),specularIntensityMapUv:N&&f(_.specularIntensityMap.channel),transmissionMapUv:K&&f(_.transmissionMap.channel),thicknessMapUv:q&&f(_.thicknessMap.channel),alphaMapUv:at&&f(_.alphaMap.channel),vertexTangents:!!R.attributes.tangent&&(xt||le),vertexNormals:!!R.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!R.attributes.color&&R.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!R.attributes.uv&&(Bt||at),fog:!!X,useFog:_.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||R.attributes.normal===void 0&&xt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:vt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:R.attributes.position!==void 0,morphTargets:R.morphAttributes.position!==void 0,morphNormals:R.morphAttributes.normal!==void 0,morphColors:R.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:wt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:F.filter(yt=>yt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:rt,decodeVideoTexture:Bt&&_.map.isVideoTexture===!0&&ae.getTransfer(_.map.colorSpace)===fe,decodeVideoTextureEmissive:Pt&&_.emissiveMap.isVideoTexture===!0&&ae.getTransfer(_.emissiveMap.colorSpace)===fe,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===ii,flipSided:_.side===ke,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Zt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&_.extensions.multiDraw===!0||Se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Yt.vertexUv1s=l.has(1),Yt.vertexUv2s=l.has(2),Yt.vertexUv3s=l.has(3),l.clear(),Yt}function v(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)T.push(U),T.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(m(T,_),g(T,_),T.push(n.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function m(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function g(_,T){a.disableAll(),T.instancing&&a.enable(0),T.instancingColor&&a.enable(1),T.instancingMorph&&a.enable(2),T.matcap&&a.enable(3),T.envMap&&a.enable(4),T.normalMapObjectSpace&&a.enable(5),T.normalMapTangentSpace&&a.enable(6),T.clearcoat&&a.enable(7),T.iridescence&&a.enable(8),T.alphaTest&&a.enable(9),T.vertexColors&&a.enable(10),T.vertexAlphas&&a.enable(11),T.vertexUv1s&&a.enable(12),T.vertexUv2s&&a.enable(13),T.vertexUv3s&&a.enable(14),T.vertexTangents&&a.enable(15),T.anisotropy&&a.enable(16),T.alphaHash&&a.enable(17),T.batching&&a.enable(18),T.dispersion&&a.enable(19),T.retroreflection&&a.enable(24),T.diffuseRoughness&&a.enable(25),T.batchingColor&&a.enable(20),T.gradientMap&&a.enable(21),T.packedNormalMap&&a.enable(22),T.vertexNormals&&a.enable(23),_.push(a.mask),a.disableAll(),T.fog&&a.enable(0),T.useFog&&a.enable(1),T.flatShading&&a.enable(2),T.logarithmicDepthBuffer&&a.enable(3),T.reversedDepthBuffer&&a.enable(4),T.skinning&&a.enable(5),T.morphTargets&&a.enable(6),T.morphNormals&&a.enable(7),T.morphColors&&a.enable(8),T.premultipliedAlpha&&a.enable(9),T.shadowMapEnabled&&a.enable(10),T.doubleSided&&a.enable(11),T.flipSided&&a.enable(12),T.useDepthPacking&&a.enable(13),T.dithering&&a.enable(14),T.transmission&&a.enable(15),T.sheen&&a.enable(16),T.opaque&&a.enable(17),T.pointsUvs&&a.enable(18),T.decodeVideoTexture&&a.enable(19),T.decodeVideoTextureEmissive&&a.enable(20),T.alphaToCoverage&&a.enable(21),T.numLightProbeGrids>0&&a.enable(22),T.hasPositionAttribute&&a.enable(23),_.push(a.mask)}function M(_){let T=d[_.type],U;if(T){let P=Zi[T];U=Cp.clone(P.uniforms)}else U=_.uniforms;return U}function w(_,T){let U=h.get(T);return U!==void 0?++U.usedTimes:(U=new xb(n,T,_,s),c.push(U),h.set(T,U)),U}function b(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){o.remove(_)}function E(){o.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:M,acquireProgram:w,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:E}}function bb(){let n=new WeakMap;function t(a){return n.has(a)}function e(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,l){n.get(a)[o]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Mb(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Yp(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Zp(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function a(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function o(d,f,p,v,m,g){let M=n[t];return M===void 0?(M={id:d.id,object:d,geometry:f,material:p,materialVariant:a(d),groupOrder:v,renderOrder:d.renderOrder,z:m,group:g},n[t]=M):(M.id=d.id,M.object=d,M.geometry=f,M.material=p,M.materialVariant=a(d),M.groupOrder=v,M.renderOrder=d.renderOrder,M.z=m,M.group=g),t++,M}function l(d,f,p,v,m,g,M){M.reversedDepth===!0&&(m=-m);let w=o(d,f,p,v,m,g);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(d,f,p,v,m,g){let M=o(d,f,p,v,m,g);p.transmission>0?i.unshift(M):p.transparent===!0?s.unshift(M):e.unshift(M)}function h(d,f){e.length>1&&e.sort(d||Mb),i.length>1&&i.sort(f||Yp),s.length>1&&s.sort(f||Yp)}function u(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Sb(){let n=new WeakMap;function t(i,s){let r=n.get(i),a;return r===void 0?(a=new Zp,n.set(i,[a])):s>=r.length?(a=new Zp,r.push(a)):a=r[s],a}function e(){n=new WeakMap}return{get:t,dispose:e}}function wb(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new I,color:new Nt};break;case"SpotLight":e={position:new I,direction:new I,color:new Nt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new I,color:new Nt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new I,skyColor:new Nt,groundColor:new Nt};break;case"RectAreaLight":e={color:new Nt,position:new I,halfWidth:new I,halfHeight:new I};break}return n[t.id]=e,e}}}function Tb(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var Eb=0;function Ab(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function Cb(n){let t=new wb,e=Tb(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new I);let s=new I,r=new pe,a=new pe;function o(c){let h=0,u=0,d=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let f=0,p=0,v=0,m=0,g=0,M=0,w=0,b=0,C=0,E=0,_=0,T=0,U=0,P=0;c.sort(Ab);for(let F=0,X=c.length;F<X;F++){let R=c[F],k=R.color,W=R.intensity,V=R.distance,nt=null;if(R.shadow&&R.shadow.map&&(R.shadow.map.texture.format===In?nt=R.shadow.map.texture:nt=R.shadow.map.depthTexture||R.shadow.map.texture),R.isAmbientLight)h+=k.r*W,u+=k.g*W,d+=k.b*W;else if(R.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(R.sh.coefficients[$],W);P++}else if(R.isSunLight){let $=t.get(R);if($.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=nt;let wt=Q.getViewportCount();for(let kt=0;kt<wt;kt++)i.sunShadowMatrix[v+kt]=Q.getMatrix(kt),i.sunShadowCascade[v+kt]=Q._cascadeData[kt];v+=wt,p++}i.sun[f]=$,f++}else if(R.isDirectionalLight){let $=t.get(R);if($.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=nt,i.directionalShadowMatrix[m]=R.shadow.matrix,C++}i.directional[m]=$,m++}else if(R.isSpotLight){let $=t.get(R);$.position.setFromMatrixPosition(R.matrixWorld),$.color.copy(k).multiplyScalar(W),$.distance=V,$.coneCos=Math.cos(R.angle),$.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),$.decay=R.decay,i.spot[M]=$;let Q=R.shadow;if(R.map&&(i.spotLightMap[T]=R.map,T++,Q.updateMatrices(R),R.castShadow&&U++),i.spotLightMatrix[M]=Q.matrix,R.castShadow){let et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.spotShadow[M]=et,i.spotShadowMap[M]=nt,_++}M++}else if(R.isRectAreaLight){let $=t.get(R);$.color.copy(k).multiplyScalar(W),$.halfWidth.set(R.width*.5,0,0),$.halfHeight.set(0,R.height*.5,0),i.rectArea[w]=$,w++}else if(R.isPointLight){let $=t.get(R);if($.color.copy(R.color).multiplyScalar(R.intensity),$.distance=R.distance,$.decay=R.decay,R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,et.shadowCameraNear=Q.camera.near,et.shadowCameraFar=Q.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=nt,i.pointShadowMatrix[g]=R.shadow.matrix,E++}i.point[g]=$,g++}else if(R.isHemisphereLight){let $=t.get(R);$.skyColor.copy(R.color).multiplyScalar(W),$.groundColor.copy(R.groundColor).multiplyScalar(W),i.hemi[b]=$,b++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=bt.LTC_FLOAT_1,i.rectAreaLTC2=bt.LTC_FLOAT_2):(i.rectAreaLTC1=bt.LTC_HALF_1,i.rectAreaLTC2=bt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==g||D.spotLength!==M||D.rectAreaLength!==w||D.hemiLength!==b||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==_||D.numSpotMaps!==T||D.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=m,i.spot.length=M,i.rectArea.length=w,i.point.length=g,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+T-U,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=P,D.sunLength=f,D.directionalLength=m,D.pointLength=g,D.spotLength=M,D.rectAreaLength=w,D.hemiLength=b,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=_,D.numSpotMaps=T,D.numLightProbes=P,i.version=Eb++)}function l(c,h){let u=0,d=0,f=0,p=0,v=0,m=0,g=h.matrixWorldInverse;for(let M=0,w=c.length;M<w;M++){let b=c[M];if(b.isSunLight){let C=i.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),u++}else if(b.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),d++}else if(b.isSpotLight){let C=i.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(b.isRectAreaLight){let C=i.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),a.identity(),r.copy(b.matrixWorld),r.premultiply(g),a.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(a),C.halfHeight.applyMatrix4(a),v++}else if(b.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(g),f++}else if(b.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:o,setupView:l,state:i}}function jp(n){let t=new Cb(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function a(u){u.isLightProbeGrid?s.push(u):e.push(u)}function o(u){i.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function Rb(n){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new jp(n),t.set(s,[o])):r>=a.length?(o=new jp(n),a.push(o)):o=a[r],o}function i(){t=new WeakMap}return{get:e,dispose:i}}var Pb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Ib=`uniform sampler2D shadow_pass;
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
}`,Nb=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],Lb=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],Kp=new pe,pa=new I,Wu=new I;function Db(n,t,e){let i=new Tn,s=new it,r=new it,a=new Ae,o=new Ho,l=new Wo,c={},h=e.maxTextureSize,u={[Pn]:ke,[ke]:Pn,[ii]:ii},d=new Wi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:Pb,fragmentShader:Ib}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Me;p.setAttribute("position",new Ne(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Pe(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=aa;let g=this.type;this.render=function(E,_,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Vf&&(Ft("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=aa);let U=n.getRenderTarget(),P=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),F=n.state;F.setBlending(ts),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let X=g!==this.type;X&&_.traverse(function(R){R.material&&(Array.isArray(R.material)?R.material.forEach(k=>k.needsUpdate=!0):R.material.needsUpdate=!0)});for(let R=0,k=E.length;R<k;R++){let W=E[R],V=W.shadow;if(V===void 0){Ft("WebGLShadowMap:",W,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let nt=V.getFrameExtents();s.multiply(nt),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/nt.x),s.x=r.x*nt.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/nt.y),s.y=r.y*nt.y,V.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=$,V.map===null||X===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===qs){if(W.isPointLight){Ft("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new xi(s.x,s.y,{format:In,type:Li,minFilter:ai,magFilter:ai,generateMipmaps:!1}),V.map.texture.name=W.name+".shadowMap",V.map.depthTexture=new on(s.x,s.y,wi),V.map.depthTexture.name=W.name+".shadowMapDepth",V.map.depthTexture.format=sn,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qe,V.map.depthTexture.magFilter=qe}else W.isPointLight?(V.map=new ga(s.x),V.map.depthTexture=new zr(s.x,Ni)):(V.map=new xi(s.x,s.y),V.map.depthTexture=new on(s.x,s.y,Ni)),V.map.depthTexture.name=W.name+".shadowMap",V.map.depthTexture.format=sn,this.type===aa?(V.map.depthTexture.compareFunction=$?Cu:Au,V.map.depthTexture.minFilter=ai,V.map.depthTexture.magFilter=ai):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qe,V.map.depthTexture.magFilter=qe);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();W.isPointLight!==!0&&V.updateMatrices(W,T);let et=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:T.layers;for(let wt=0;wt<Q;wt++){let kt=V.getCamera(wt);if(W.isPointLight){let Y=V.camera,_t=V.matrix,Tt=W.distance||Y.far;Tt!==Y.far&&(Y.far=Tt,Y.updateProjectionMatrix()),pa.setFromMatrixPosition(W.matrixWorld),Y.position.copy(pa),Wu.copy(Y.position),Wu.add(Nb[wt]),Y.up.copy(Lb[wt]),Y.lookAt(Wu),Y.updateMatrixWorld(),_t.makeTranslation(-pa.x,-pa.y,-pa.z),Kp.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Kp,Y.coordinateSystem,Y.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,wt),n.clear();else{wt===0&&(n.setRenderTarget(V.map),n.clear());let Y=V.getViewport(wt);a.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),F.viewport(a)}i=V.getFrustum(wt),b(_,T,kt,W,et,this.type)}V.isPointLightShadow!==!0&&this.type===qs&&M(V,T),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(U,P,D)};function M(E,_){let T=t.update(v);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new xi(s.x,s.y,{format:In,type:Li}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(_,null,T,d,v,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(_,null,T,f,v,null)}function w(E,_,T,U){let P=null,D=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)P=D;else if(P=T.isPointLight===!0?l:o,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let F=P.uuid,X=_.uuid,R=c[F];R===void 0&&(R={},c[F]=R);let k=R[X];k===void 0&&(k=P.clone(),R[X]=k,_.addEventListener("dispose",C)),P=k}if(P.visible=_.visible,P.wireframe=_.wireframe,U===qs?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?_.shadowSide:u[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=_.wireframeLinewidth,P.linewidth=_.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let F=n.properties.get(P);F.light=T}return P}function b(E,_,T,U,P,D){if(E.visible===!1)return;if(E.layers.test(P)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===qs)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let R=t.update(E),k=E.material;if(Array.isArray(k)){let W=R.groups;for(let V=0,nt=W.length;V<nt;V++){let $=W[V],Q=k[$.materialIndex];if(Q&&Q.visible){let et=w(E,Q,U,D);E.onBeforeShadow(n,E,_,T,R,et,$),n.renderBufferDirect(T,null,R,et,E,$),E.onAfterShadow(n,E,_,T,R,et,$)}}}else if(k.visible){let W=w(E,k,U,D);E.onBeforeShadow(n,E,_,T,R,W,null),n.renderBufferDirect(T,null,R,W,E,null),E.onAfterShadow(n,E,_,T,R,W,null)}}let X=E.children;for(let R=0,k=X.length;R<k;R++)b(X[R],_,T,U,P,D)}function C(E){E.target.removeEventListener("dispose",C);for(let T in c){let U=c[T],P=E.target.uuid;P in U&&(U[P].dispose(),delete U[P])}}}function Ob(n,t){function e(){let N=!1,K=new Ae,q=null,dt=new Ae(0,0,0,0);return{setMask:function(at){q!==at&&!N&&(n.colorMask(at,at,at,at),q=at)},setLocked:function(at){N=at},setClear:function(at,ct,It,Zt,rt){rt===!0&&(at*=Zt,ct*=Zt,It*=Zt),K.set(at,ct,It,Zt),dt.equals(K)===!1&&(n.clearColor(at,ct,It,Zt),dt.copy(K))},reset:function(){N=!1,q=null,dt.set(-1,0,0,0)}}}function i(){let N=!1,K=!1,q=null,dt=null,at=null;return{setReversed:function(ct){if(K!==ct){let It=t.get("EXT_clip_control");ct?It.clipControlEXT(It.LOWER_LEFT_EXT,It.ZERO_TO_ONE_EXT):It.clipControlEXT(It.LOWER_LEFT_EXT,It.NEGATIVE_ONE_TO_ONE_EXT),K=ct;let Zt=at;at=null,this.setClear(Zt)}},getReversed:function(){return K},setTest:function(ct){ct?vt(n.DEPTH_TEST):Ot(n.DEPTH_TEST)},setMask:function(ct){q!==ct&&!N&&(n.depthMask(ct),q=ct)},setFunc:function(ct){if(K&&(ct=bp[ct]),dt!==ct){switch(ct){case _o:n.depthFunc(n.NEVER);break;case vo:n.depthFunc(n.ALWAYS);break;case yo:n.depthFunc(n.LESS);break;case Ls:n.depthFunc(n.LEQUAL);break;case bo:n.depthFunc(n.EQUAL);break;case Mo:n.depthFunc(n.GEQUAL);break;case So:n.depthFunc(n.GREATER);break;case wo:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}dt=ct}},setLocked:function(ct){N=ct},setClear:function(ct){at!==ct&&(at=ct,K&&(ct=1-ct),n.clearDepth(ct))},reset:function(){N=!1,q=null,dt=null,at=null,K=!1}}}function s(){let N=!1,K=null,q=null,dt=null,at=null,ct=null,It=null,Zt=null,rt=null;return{setTest:function(Lt){N||(Lt?vt(n.STENCIL_TEST):Ot(n.STENCIL_TEST))},setMask:function(Lt){K!==Lt&&!N&&(n.stencilMask(Lt),K=Lt)},setFunc:function(Lt,Yt,yt){(q!==Lt||dt!==Yt||at!==yt)&&(n.stencilFunc(Lt,Yt,yt),q=Lt,dt=Yt,at=yt)},setOp:function(Lt,Yt,yt){(ct!==Lt||It!==Yt||Zt!==yt)&&(n.stencilOp(Lt,Yt,yt),ct=Lt,It=Yt,Zt=yt)},setLocked:function(Lt){N=Lt},setClear:function(Lt){rt!==Lt&&(n.clearStencil(Lt),rt=Lt)},reset:function(){N=!1,K=null,q=null,dt=null,at=null,ct=null,It=null,Zt=null,rt=null}}}let r=new e,a=new i,o=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],v=null,m=!1,g=null,M=null,w=null,b=null,C=null,E=null,_=null,T=new Nt(0,0,0),U=0,P=!1,D=null,F=null,X=null,R=null,k=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,nt=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec($)[1]),V=nt>=1):$.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),V=nt>=2);let Q=null,et={},wt=n.getParameter(n.SCISSOR_BOX),kt=n.getParameter(n.VIEWPORT),Y=new Ae().fromArray(wt),_t=new Ae().fromArray(kt);function Tt(N,K,q,dt){let at=new Uint8Array(4),ct=n.createTexture();n.bindTexture(N,ct),n.texParameteri(N,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(N,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let It=0;It<q;It++)N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY?n.texImage3D(K,0,n.RGBA,1,1,dt,0,n.RGBA,n.UNSIGNED_BYTE,at):n.texImage2D(K+It,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,at);return ct}let Dt={};Dt[n.TEXTURE_2D]=Tt(n.TEXTURE_2D,n.TEXTURE_2D,1),Dt[n.TEXTURE_CUBE_MAP]=Tt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Dt[n.TEXTURE_2D_ARRAY]=Tt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Dt[n.TEXTURE_3D]=Tt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),vt(n.DEPTH_TEST),a.setFunc(Ls),St(!1),xt(ou),vt(n.CULL_FACE),ht(ts);function vt(N){h[N]!==!0&&(n.enable(N),h[N]=!0)}function Ot(N){h[N]!==!1&&(n.disable(N),h[N]=!1)}function Se(N,K){return d[N]!==K?(n.bindFramebuffer(N,K),d[N]=K,N===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=K),N===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=K),!0):!1}function Bt(N,K){let q=p,dt=!1;if(N){q=f.get(K),q===void 0&&(q=[],f.set(K,q));let at=N.textures;if(q.length!==at.length||q[0]!==n.COLOR_ATTACHMENT0){for(let ct=0,It=at.length;ct<It;ct++)q[ct]=n.COLOR_ATTACHMENT0+ct;q.length=at.length,dt=!0}}else q[0]!==n.BACK&&(q[0]=n.BACK,dt=!0);dt&&n.drawBuffers(q)}function Jt(N){return v!==N?(n.useProgram(N),v=N,!0):!1}let ee={[es]:n.FUNC_ADD,[Wf]:n.FUNC_SUBTRACT,[Xf]:n.FUNC_REVERSE_SUBTRACT};ee[$f]=n.MIN,ee[qf]=n.MAX;let tt={[Yf]:n.ZERO,[Zf]:n.ONE,[jf]:n.SRC_COLOR,[uu]:n.SRC_ALPHA,[ip]:n.SRC_ALPHA_SATURATE,[tp]:n.DST_COLOR,[Jf]:n.DST_ALPHA,[Kf]:n.ONE_MINUS_SRC_COLOR,[du]:n.ONE_MINUS_SRC_ALPHA,[ep]:n.ONE_MINUS_DST_COLOR,[Qf]:n.ONE_MINUS_DST_ALPHA,[np]:n.CONSTANT_COLOR,[sp]:n.ONE_MINUS_CONSTANT_COLOR,[rp]:n.CONSTANT_ALPHA,[ap]:n.ONE_MINUS_CONSTANT_ALPHA};function ht(N,K,q,dt,at,ct,It,Zt,rt,Lt){if(N===ts){m===!0&&(Ot(n.BLEND),m=!1);return}if(m===!1&&(vt(n.BLEND),m=!0),N!==Hf){if(N!==g||Lt!==P){if((M!==es||C!==es)&&(n.blendEquation(n.FUNC_ADD),M=es,C=es),Lt)switch(N){case Ys:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lu:n.blendFunc(n.ONE,n.ONE);break;case cu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case hu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:zt("WebGLState: Invalid blending: ",N);break}else switch(N){case Ys:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case cu:zt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hu:zt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:zt("WebGLState: Invalid blending: ",N);break}w=null,b=null,E=null,_=null,T.set(0,0,0),U=0,g=N,P=Lt}return}at=at||K,ct=ct||q,It=It||dt,(K!==M||at!==C)&&(n.blendEquationSeparate(ee[K],ee[at]),M=K,C=at),(q!==w||dt!==b||ct!==E||It!==_)&&(n.blendFuncSeparate(tt[q],tt[dt],tt[ct],tt[It]),w=q,b=dt,E=ct,_=It),(Zt.equals(T)===!1||rt!==U)&&(n.blendColor(Zt.r,Zt.g,Zt.b,rt),T.copy(Zt),U=rt),g=N,P=!1}function ot(N,K){N.side===ii?Ot(n.CULL_FACE):vt(n.CULL_FACE);let q=N.side===ke;K&&(q=!q),St(q),N.blending===Ys&&N.transparent===!1?ht(ts):ht(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),a.setFunc(N.depthFunc),a.setTest(N.depthTest),a.setMask(N.depthWrite),r.setMask(N.colorWrite);let dt=N.stencilWrite;o.setTest(dt),dt&&(o.setMask(N.stencilWriteMask),o.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),o.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),Pt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?vt(n.SAMPLE_ALPHA_TO_COVERAGE):Ot(n.SAMPLE_ALPHA_TO_COVERAGE)}function St(N){D!==N&&(N?n.frontFace(n.CW):n.frontFace(n.CCW),D=N)}function xt(N){N!==zf?(vt(n.CULL_FACE),N!==F&&(N===ou?n.cullFace(n.BACK):N===Gf?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ot(n.CULL_FACE),F=N}function qt(N){N!==X&&(V&&n.lineWidth(N),X=N)}function Pt(N,K,q){N?(vt(n.POLYGON_OFFSET_FILL),(R!==K||k!==q)&&(R=K,k=q,a.getReversed()&&(K=-K,q=-q),n.polygonOffset(K,q))):Ot(n.POLYGON_OFFSET_FILL)}function ie(N){N?vt(n.SCISSOR_TEST):Ot(n.SCISSOR_TEST)}function ne(N){N===void 0&&(N=n.TEXTURE0+W-1),Q!==N&&(n.activeTexture(N),Q=N)}function le(N,K,q){q===void 0&&(Q===null?q=n.TEXTURE0+W-1:q=Q);let dt=et[q];dt===void 0&&(dt={type:void 0,texture:void 0},et[q]=dt),(dt.type!==N||dt.texture!==K)&&(Q!==q&&(n.activeTexture(q),Q=q),n.bindTexture(N,K||Dt[N]),dt.type=N,dt.texture=K)}function O(){let N=et[Q];N!==void 0&&N.type!==void 0&&(n.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function De(){try{n.compressedTexImage2D(...arguments)}catch(N){zt("WebGLState:",N)}}function te(){try{n.compressedTexImage3D(...arguments)}catch(N){zt("WebGLState:",N)}}function _e(){try{n.texSubImage2D(...arguments)}catch(N){zt("WebGLState:",N)}}function pt(){try{n.texSubImage3D(...arguments)}catch(N){zt("WebGLState:",N)}}function Ie(){try{n.compressedTexSubImage2D(...arguments)}catch(N){zt("WebGLState:",N)}}function Ut(){try{n.compressedTexSubImage3D(...arguments)}catch(N){zt("WebGLState:",N)}}function Vt(){try{n.texStorage2D(...arguments)}catch(N){zt("WebGLState:",N)}}function A(){try{n.texStorage3D(...arguments)}catch(N){zt("WebGLState:",N)}}function y(){try{n.texImage2D(...arguments)}catch(N){zt("WebGLState:",N)}}function z(){try{n.texImage3D(...arguments)}catch(N){zt("WebGLState:",N)}}function st(N){return u[N]!==void 0?u[N]:n.getParameter(N)}function J(N,K){u[N]!==K&&(n.pixelStorei(N,K),u[N]=K)}function lt(N){Y.equals(N)===!1&&(n.scissor(N.x,N.y,N.z,N.w),Y.copy(N))}function mt(N){_t.equals(N)===!1&&(n.viewport(N.x,N.y,N.z,N.w),_t.copy(N))}function Z(N,K){let q=c.get(K);q===void 0&&(q=new WeakMap,c.set(K,q));let dt=q.get(N);dt===void 0&&(dt=n.getUniformBlockIndex(K,N.name),n.uniformBlockBinding(K,dt,dt),q.set(N,dt))}function j(N,K,q){let at=c.get(K).get(N);l[at]!==q&&(n.bindBufferBase(n.UNIFORM_BUFFER,at,q),l[at]=q)}function ut(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,et={},d={},l={},f=new WeakMap,p=[],v=null,m=!1,g=null,M=null,w=null,b=null,C=null,E=null,_=null,T=new Nt(0,0,0),U=0,P=!1,D=null,F=null,X=null,R=null,k=null,Y.set(0,0,n.canvas.width,n.canvas.height),_t.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:vt,disable:Ot,bindFramebuffer:Se,drawBuffers:Bt,useProgram:Jt,setBlending:ht,setMaterial:ot,setFlipSided:St,setCullFace:xt,setLineWidth:qt,setPolygonOffset:Pt,setScissorTest:ie,activeTexture:ne,bindTexture:le,unbindTexture:O,compressedTexImage2D:De,compressedTexImage3D:te,texImage2D:y,texImage3D:z,pixelStorei:J,getParameter:st,updateUBOMapping:Z,uniformBlockBinding:j,texStorage2D:Vt,texStorage3D:A,texSubImage2D:_e,texSubImage3D:pt,compressedTexSubImage2D:Ie,compressedTexSubImage3D:Ut,scissor:lt,viewport:mt,reset:ut}}function Ub(n,t,e,i,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,v=new FinalizationRegistry(A=>p.delete(A)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(A,y){return m?new OffscreenCanvas(A,y):Rr("canvas")}function M(A,y,z){let st=1,J=Vt(A);if((J.width>z||J.height>z)&&(st=z/Math.max(J.width,J.height)),st<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let lt=Math.floor(st*J.width),mt=Math.floor(st*J.height);d===void 0&&(d=g(lt,mt));let Z=y?g(lt,mt):d;return Z.width=lt,Z.height=mt,Z.getContext("2d").drawImage(A,0,0,lt,mt),Ft("WebGLRenderer: Texture has been resized from ("+J.width+"x"+J.height+") to ("+lt+"x"+mt+")."),Z}else return"data"in A&&Ft("WebGLRenderer: Image in DataTexture is too big ("+J.width+"x"+J.height+")."),A;return A}function w(A){return A.generateMipmaps}function b(A){n.generateMipmap(A)}function C(A){return A.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?n.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(A,y,z,st,J,lt=!1){if(A!==null){if(n[A]!==void 0)return n[A];Ft("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let mt;st&&(mt=t.get("EXT_texture_norm16"),mt||Ft("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=y;if(y===n.RED&&(z===n.FLOAT&&(Z=n.R32F),z===n.HALF_FLOAT&&(Z=n.R16F),z===n.UNSIGNED_BYTE&&(Z=n.R8),z===n.UNSIGNED_SHORT&&mt&&(Z=mt.R16_EXT),z===n.SHORT&&mt&&(Z=mt.R16_SNORM_EXT)),y===n.RED_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.R8UI),z===n.UNSIGNED_SHORT&&(Z=n.R16UI),z===n.UNSIGNED_INT&&(Z=n.R32UI),z===n.BYTE&&(Z=n.R8I),z===n.SHORT&&(Z=n.R16I),z===n.INT&&(Z=n.R32I)),y===n.RG&&(z===n.FLOAT&&(Z=n.RG32F),z===n.HALF_FLOAT&&(Z=n.RG16F),z===n.UNSIGNED_BYTE&&(Z=n.RG8),z===n.UNSIGNED_SHORT&&mt&&(Z=mt.RG16_EXT),z===n.SHORT&&mt&&(Z=mt.RG16_SNORM_EXT)),y===n.RG_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RG8UI),z===n.UNSIGNED_SHORT&&(Z=n.RG16UI),z===n.UNSIGNED_INT&&(Z=n.RG32UI),z===n.BYTE&&(Z=n.RG8I),z===n.SHORT&&(Z=n.RG16I),z===n.INT&&(Z=n.RG32I)),y===n.RGB_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RGB8UI),z===n.UNSIGNED_SHORT&&(Z=n.RGB16UI),z===n.UNSIGNED_INT&&(Z=n.RGB32UI),z===n.BYTE&&(Z=n.RGB8I),z===n.SHORT&&(Z=n.RGB16I),z===n.INT&&(Z=n.RGB32I)),y===n.RGBA_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RGBA8UI),z===n.UNSIGNED_SHORT&&(Z=n.RGBA16UI),z===n.UNSIGNED_INT&&(Z=n.RGBA32UI),z===n.BYTE&&(Z=n.RGBA8I),z===n.SHORT&&(Z=n.RGBA16I),z===n.INT&&(Z=n.RGBA32I)),y===n.RGB&&(z===n.UNSIGNED_SHORT&&mt&&(Z=mt.RGB16_EXT),z===n.SHORT&&mt&&(Z=mt.RGB16_SNORM_EXT),z===n.UNSIGNED_INT_5_9_9_9_REV&&(Z=n.RGB9_E5),z===n.UNSIGNED_INT_10F_11F_11F_REV&&(Z=n.R11F_G11F_B10F)),y===n.RGBA){let j=lt?Cr:ae.getTransfer(J);z===n.FLOAT&&(Z=n.RGBA32F),z===n.HALF_FLOAT&&(Z=n.RGBA16F),z===n.UNSIGNED_BYTE&&(Z=j===fe?n.SRGB8_ALPHA8:n.RGBA8),z===n.UNSIGNED_SHORT&&mt&&(Z=mt.RGBA16_EXT),z===n.SHORT&&mt&&(Z=mt.RGBA16_SNORM_EXT),z===n.UNSIGNED_SHORT_4_4_4_4&&(Z=n.RGBA4),z===n.UNSIGNED_SHORT_5_5_5_1&&(Z=n.RGB5_A1)}return(Z===n.R16F||Z===n.R32F||Z===n.RG16F||Z===n.RG32F||Z===n.RGBA16F||Z===n.RGBA32F)&&t.get("EXT_color_buffer_float"),Z}function _(A,y){let z;return A?y===null||y===Ni||y===ns?z=n.DEPTH24_STENCIL8:y===wi?z=n.DEPTH32F_STENCIL8:y===js&&(z=n.DEPTH24_STENCIL8,Ft("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ni||y===ns?z=n.DEPTH_COMPONENT24:y===wi?z=n.DEPTH_COMPONENT32F:y===js&&(z=n.DEPTH_COMPONENT16),z}function T(A,y){return w(A)===!0||A.isFramebufferTexture&&A.minFilter!==qe&&A.minFilter!==ai?Math.log2(Math.max(y.width,y.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?y.mipmaps.length:1}function U(A){let y=new WeakRef(A);i.get(A).__ref=y,p.add(y),v.register(A,y,y)}function P(A){let y=i.get(A).__ref;y!==void 0&&(p.delete(y),v.unregister(y))}function D(A){X(A.target)}function F(A){R(A.target)}function X(A){A.removeEventListener("dispose",D),P(A),W(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&u.delete(A)}function R(A){A.removeEventListener("dispose",F),P(A),nt(A)}function k(){for(let A of p){let y=A.deref();y!==void 0&&(y.isRenderTarget===!0?R(y):X(y))}p.clear(),u.clear()}function W(A){let y=i.get(A);if(y.__webglInit===void 0)return;let z=A.source,st=f.get(z);if(st){let J=st[y.__cacheKey];J.usedTimes--,J.usedTimes===0&&V(A),Object.keys(st).length===0&&f.delete(z)}i.remove(A)}function V(A){let y=i.get(A);n.deleteTexture(y.__webglTexture);let z=A.source,st=f.get(z);delete st[y.__cacheKey],a.memory.textures--}function nt(A){let y=i.get(A);y.__depthDisposeCallback&&y.__depthDisposeCallback();let z=A.depthTexture;if(z&&z.renderTarget===A&&X(z),A.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(y.__webglFramebuffer[J]))for(let lt=0;lt<y.__webglFramebuffer[J].length;lt++)n.deleteFramebuffer(y.__webglFramebuffer[J][lt]);else n.deleteFramebuffer(y.__webglFramebuffer[J]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[J])}else{if(Array.isArray(y.__webglFramebuffer))for(let J=0;J<y.__webglFramebuffer.length;J++)n.deleteFramebuffer(y.__webglFramebuffer[J]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let J=0;J<y.__webglColorRenderbuffer.length;J++)y.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[J]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let st=A.textures;for(let J=0,lt=st.length;J<lt;J++){let mt=i.get(st[J]);mt.__webglTexture&&(n.deleteTexture(mt.__webglTexture),a.memory.textures--),i.remove(st[J])}i.remove(A)}let $=0;function Q(){$=0}function et(){return $}function wt(A){$=A}function kt(){let A=$;return A>=s.maxTextures&&Ft("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,A}function Y(A){let y=[];return y.push(A.wrapS),y.push(A.wrapT),y.push(A.wrapR||0),y.push(A.magFilter),y.push(A.minFilter),y.push(A.anisotropy),y.push(A.internalFormat),y.push(A.format),y.push(A.type),y.push(A.generateMipmaps),y.push(A.mipmapsAutoUpdate),y.push(A.premultiplyAlpha),y.push(A.flipY),y.push(A.unpackAlignment),y.push(A.colorSpace),y.join()}function _t(A,y){let z=i.get(A);if(A.isVideoTexture&&Ie(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&z.__version!==A.version){let st=A.image;if(st===null)Ft("WebGLRenderer: Texture marked for update but no image data found.");else if(st.complete===!1)Ft("WebGLRenderer: Texture marked for update but image is incomplete");else{ot(z,A,y);return}}else A.isExternalTexture&&(z.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,z.__webglTexture,n.TEXTURE0+y)}function Tt(A,y){let z=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&z.__version!==A.version){ot(z,A,y);return}else A.isExternalTexture&&(z.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,z.__webglTexture,n.TEXTURE0+y)}function Dt(A,y){let z=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&z.__version!==A.version){ot(z,A,y);return}e.bindTexture(n.TEXTURE_3D,z.__webglTexture,n.TEXTURE0+y)}function vt(A,y){let z=i.get(A);if(A.version>0&&z.__version!==A.version){St(z,A,y);return}e.bindTexture(n.TEXTURE_CUBE_MAP,z.__webglTexture,n.TEXTURE0+y)}let Ot={[To]:n.REPEAT,[Bi]:n.CLAMP_TO_EDGE,[Eo]:n.MIRRORED_REPEAT},Se={[qe]:n.NEAREST,[cp]:n.NEAREST_MIPMAP_NEAREST,[oa]:n.NEAREST_MIPMAP_LINEAR,[ai]:n.LINEAR,[al]:n.LINEAR_MIPMAP_NEAREST,[cn]:n.LINEAR_MIPMAP_LINEAR},Bt={[fp]:n.NEVER,[Ru]:n.ALWAYS,[pp]:n.LESS,[Au]:n.LEQUAL,[mp]:n.EQUAL,[Cu]:n.GEQUAL,[gp]:n.GREATER,[xp]:n.NOTEQUAL};function Jt(A,y){if(y.type===wi&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===ai||y.magFilter===al||y.magFilter===oa||y.magFilter===cn||y.minFilter===ai||y.minFilter===al||y.minFilter===oa||y.minFilter===cn)&&Ft("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(A,n.TEXTURE_WRAP_S,Ot[y.wrapS]),n.texParameteri(A,n.TEXTURE_WRAP_T,Ot[y.wrapT]),(A===n.TEXTURE_3D||A===n.TEXTURE_2D_ARRAY)&&n.texParameteri(A,n.TEXTURE_WRAP_R,Ot[y.wrapR]),n.texParameteri(A,n.TEXTURE_MAG_FILTER,Se[y.magFilter]),n.texParameteri(A,n.TEXTURE_MIN_FILTER,Se[y.minFilter]),y.compareFunction&&(n.texParameteri(A,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(A,n.TEXTURE_COMPARE_FUNC,Bt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===qe||y.minFilter!==oa&&y.minFilter!==cn||y.type===wi&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){let z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(A,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function ee(A,y){let z=!1;A.__webglInit===void 0&&(A.__webglInit=!0,y.addEventListener("dispose",D),U(y));let st=y.source,J=f.get(st);J===void 0&&(J={},f.set(st,J));let lt=Y(y);if(lt!==A.__cacheKey){J[lt]===void 0&&(J[lt]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,z=!0),J[lt].usedTimes++;let mt=J[A.__cacheKey];mt!==void 0&&(J[A.__cacheKey].usedTimes--,mt.usedTimes===0&&V(y)),A.__cacheKey=lt,A.__webglTexture=J[lt].texture}return z}function tt(A,y,z){return Math.floor(Math.floor(A/z)/y)}function ht(A,y,z,st){let lt=A.updateRanges;if(lt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,y.width,y.height,z,st,y.data);else{lt.sort((N,K)=>N.start-K.start);let mt=0;for(let N=1;N<lt.length;N++){let K=lt[mt],q=lt[N],dt=K.start+K.count,at=tt(q.start,y.width,4),ct=tt(K.start,y.width,4);q.start<=dt+1&&at===ct&&tt(q.start+q.count-1,y.width,4)===at?K.count=Math.max(K.count,q.start+q.count-K.start):(++mt,lt[mt]=q)}lt.length=mt+1;let Z=e.getParameter(n.UNPACK_ROW_LENGTH),j=e.getParameter(n.UNPACK_SKIP_PIXELS),ut=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,y.width);for(let N=0,K=lt.length;N<K;N++){let q=lt[N],dt=Math.floor(q.start/4),at=Math.ceil(q.count/4),ct=dt%y.width,It=Math.floor(dt/y.width),Zt=at,rt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,ct),e.pixelStorei(n.UNPACK_SKIP_ROWS,It),e.texSubImage2D(n.TEXTURE_2D,0,ct,It,Zt,rt,z,st,y.data)}A.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,Z),e.pixelStorei(n.UNPACK_SKIP_PIXELS,j),e.pixelStorei(n.UNPACK_SKIP_ROWS,ut)}}function ot(A,y,z){let st=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(st=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(st=n.TEXTURE_3D);let J=ee(A,y),lt=y.source;e.bindTexture(st,A.__webglTexture,n.TEXTURE0+z);let mt=i.get(lt);if(lt.version!==mt.__version||J===!0){if(e.activeTexture(n.TEXTURE0+z),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let rt=ae.getPrimaries(ae.workingColorSpace),Lt=y.colorSpace===un?null:ae.getPrimaries(y.colorSpace),Yt=y.colorSpace===un||rt===Lt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Yt)}e.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment);let j=M(y.image,!1,s.maxTextureSize);j=Ut(y,j);let ut=r.convert(y.format,y.colorSpace),N=r.convert(y.type),K=E(y.internalFormat,ut,N,y.normalized,y.colorSpace,y.isVideoTexture);Jt(st,y);let q,dt=y.mipmaps,at=y.isVideoTexture!==!0,ct=mt.__version===void 0||J===!0,It=lt.dataReady,Zt=T(y,j);if(y.isDepthTexture)K=_(y.format===hn,y.type),ct&&(at?e.texStorage2D(n.TEXTURE_2D,1,K,j.width,j.height):e.texImage2D(n.TEXTURE_2D,0,K,j.width,j.height,0,ut,N,null));else if(y.isDataTexture)if(dt.length>0){at&&ct&&e.texStorage2D(n.TEXTURE_2D,Zt,K,dt[0].width,dt[0].height);for(let rt=0,Lt=dt.length;rt<Lt;rt++)q=dt[rt],at?It&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,q.width,q.height,ut,N,q.data):e.texImage2D(n.TEXTURE_2D,rt,K,q.width,q.height,0,ut,N,q.data);y.generateMipmaps=!1}else at?(ct&&e.texStorage2D(n.TEXTURE_2D,Zt,K,j.width,j.height),It&&ht(y,j,ut,N)):e.texImage2D(n.TEXTURE_2D,0,K,j.width,j.height,0,ut,N,j.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){at&&ct&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,K,dt[0].width,dt[0].height,j.depth);for(let rt=0,Lt=dt.length;rt<Lt;rt++)if(q=dt[rt],y.format!==Di)if(ut!==null)if(at){if(It)if(y.layerUpdates.size>0){let Yt=Vu(q.width,q.height,y.format,y.type);for(let yt of y.layerUpdates){let me=q.data.subarray(yt*Yt/q.data.BYTES_PER_ELEMENT,(yt+1)*Yt/q.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,yt,q.width,q.height,1,ut,me)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,0,q.width,q.height,j.depth,ut,q.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,rt,K,q.width,q.height,j.depth,0,q.data,0,0);else Ft("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else at?It&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,0,q.width,q.height,j.depth,ut,N,q.data):e.texImage3D(n.TEXTURE_2D_ARRAY,rt,K,q.width,q.height,j.depth,0,ut,N,q.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{at&&ct&&e.texStorage2D(n.TEXTURE_2D,Zt,K,dt[0].width,dt[0].height);for(let rt=0,Lt=dt.length;rt<Lt;rt++)q=dt[rt],y.format!==Di?ut!==null?at?It&&e.compressedTexSubImage2D(n.TEXTURE_2D,rt,0,0,q.width,q.height,ut,q.data):e.compressedTexImage2D(n.TEXTURE_2D,rt,K,q.width,q.height,0,q.data):Ft("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):at?It&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,q.width,q.height,ut,N,q.data):e.texImage2D(n.TEXTURE_2D,rt,K,q.width,q.height,0,ut,N,q.data)}else if(y.isDataArrayTexture)if(at){if(ct&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,K,j.width,j.height,j.depth),It)if(y.layerUpdates.size>0){let rt=Vu(j.width,j.height,y.format,y.type);for(let Lt of y.layerUpdates){let Yt=j.data.subarray(Lt*rt/j.data.BYTES_PER_ELEMENT,(Lt+1)*rt/j.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Lt,j.width,j.height,1,ut,N,Yt)}y.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,j.width,j.height,j.depth,ut,N,j.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,K,j.width,j.height,j.depth,0,ut,N,j.data);else if(y.isData3DTexture)at?(ct&&e.texStorage3D(n.TEXTURE_3D,Zt,K,j.width,j.height,j.depth),It&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,j.width,j.height,j.depth,ut,N,j.data)):e.texImage3D(n.TEXTURE_3D,0,K,j.width,j.height,j.depth,0,ut,N,j.data);else if(y.isFramebufferTexture){if(ct)if(at)e.texStorage2D(n.TEXTURE_2D,Zt,K,j.width,j.height);else{let rt=j.width,Lt=j.height;for(let Yt=0;Yt<Zt;Yt++)e.texImage2D(n.TEXTURE_2D,Yt,K,rt,Lt,0,ut,N,null),rt>>=1,Lt>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in n){let rt=n.canvas;if(rt.hasAttribute("layoutsubtree")||rt.setAttribute("layoutsubtree","true"),j.parentNode!==rt){rt.appendChild(j),u.add(y),rt.onpaint=Lt=>{let Yt=Lt.changedElements;for(let yt of u)Yt.includes(yt.image)&&(yt.needsUpdate=!0)},rt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,j);else{let Yt=n.RGBA,yt=n.RGBA,me=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Yt,yt,me,j)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(dt.length>0){if(at&&ct){let rt=Vt(dt[0]);e.texStorage2D(n.TEXTURE_2D,Zt,K,rt.width,rt.height)}for(let rt=0,Lt=dt.length;rt<Lt;rt++)q=dt[rt],at?It&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,ut,N,q):e.texImage2D(n.TEXTURE_2D,rt,K,ut,N,q);y.generateMipmaps=!1}else if(at){if(ct){let rt=Vt(j);e.texStorage2D(n.TEXTURE_2D,Zt,K,rt.width,rt.height)}It&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ut,N,j)}else e.texImage2D(n.TEXTURE_2D,0,K,ut,N,j);w(y)&&y.mipmapsAutoUpdate===!0&&b(st),mt.__version=lt.version,y.onUpdate&&y.onUpdate(y)}A.__version=y.version}function St(A,y,z){if(y.image.length!==6)return;let st=ee(A,y),J=y.source;e.bindTexture(n.TEXTURE_CUBE_MAP,A.__webglTexture,n.TEXTURE0+z);let lt=i.get(J);if(J.version!==lt.__version||st===!0){e.activeTexture(n.TEXTURE0+z);let mt=ae.getPrimaries(ae.workingColorSpace),Z=y.colorSpace===un?null:ae.getPrimaries(y.colorSpace),j=y.colorSpace===un||mt===Z?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,j);let ut=y.isCompressedTexture||y.image[0].isCompressedTexture,N=y.image[0]&&y.image[0].isDataTexture,K=[];for(let yt=0;yt<6;yt++)!ut&&!N?K[yt]=M(y.image[yt],!0,s.maxCubemapSize):K[yt]=N?y.image[yt].image:y.image[yt],K[yt]=Ut(y,K[yt]);let q=K[0],dt=r.convert(y.format,y.colorSpace),at=r.convert(y.type),ct=E(y.internalFormat,dt,at,y.normalized,y.colorSpace),It=y.isVideoTexture!==!0,Zt=lt.__version===void 0||st===!0,rt=J.dataReady,Lt=T(y,q);Jt(n.TEXTURE_CUBE_MAP,y);let Yt;if(y.isDepthTexture){if(ct=_(y.format===hn,y.type),Zt)if(It)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,ct,q.width,q.height);else for(let yt=0;yt<6;yt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,ct,q.width,q.height,0,dt,at,null)}else if(ut){It&&Zt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Lt,ct,q.width,q.height);for(let yt=0;yt<6;yt++){Yt=K[yt].mipmaps;for(let me=0;me<Yt.length;me++){let He=Yt[me];y.format!==Di?dt!==null?It?rt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me,0,0,He.width,He.height,dt,He.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me,ct,He.width,He.height,0,He.data):Ft("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):It?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me,0,0,He.width,He.height,dt,at,He.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me,ct,He.width,He.height,0,dt,at,He.data)}}}else{if(Yt=y.mipmaps,It&&Zt){Yt.length>0&&Lt++;let yt=Vt(K[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Lt,ct,yt.width,yt.height)}for(let yt=0;yt<6;yt++)if(N){It?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,0,0,K[yt].width,K[yt].height,dt,at,K[yt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,ct,K[yt].width,K[yt].height,0,dt,at,K[yt].data);for(let me=0;me<Yt.length;me++){let gn=Yt[me].image[yt].image;It?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me+1,0,0,gn.width,gn.height,dt,at,gn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me+1,ct,gn.width,gn.height,0,dt,at,gn.data)}}else{It?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,0,0,dt,at,K[yt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,0,ct,dt,at,K[yt]);for(let me=0;me<Yt.length;me++){let He=Yt[me];It?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me+1,0,0,dt,at,He.image[yt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+yt,me+1,ct,dt,at,He.image[yt])}}}w(y)&&y.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),lt.__version=J.version,y.onUpdate&&y.onUpdate(y)}A.__version=y.version}function xt(A,y,z,st,J,lt){let mt=r.convert(z.format,z.colorSpace),Z=r.convert(z.type),j=E(z.internalFormat,mt,Z,z.normalized,z.colorSpace),ut=i.get(y),N=i.get(z);if(N.__renderTarget=y,!ut.__hasExternalTextures){let K=Math.max(1,y.width>>lt),q=Math.max(1,y.height>>lt);J===n.TEXTURE_3D||J===n.TEXTURE_2D_ARRAY?e.texImage3D(J,lt,j,K,q,y.depth,0,mt,Z,null):e.texImage2D(J,lt,j,K,q,0,mt,Z,null)}e.bindFramebuffer(n.FRAMEBUFFER,A),pt(y)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,st,J,N.__webglTexture,0,_e(y)):(J===n.TEXTURE_2D||J>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&J<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,st,J,N.__webglTexture,lt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function qt(A,y,z){if(n.bindRenderbuffer(n.RENDERBUFFER,A),y.depthBuffer){let st=y.depthTexture,J=st&&st.isDepthTexture?st.type:null,lt=_(y.stencilBuffer,J),mt=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;pt(y)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_e(y),lt,y.width,y.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,_e(y),lt,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,lt,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,mt,n.RENDERBUFFER,A)}else{let st=y.textures;for(let J=0;J<st.length;J++){let lt=st[J],mt=r.convert(lt.format,lt.colorSpace),Z=r.convert(lt.type),j=E(lt.internalFormat,mt,Z,lt.normalized,lt.colorSpace);pt(y)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_e(y),j,y.width,y.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,_e(y),j,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,j,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Pt(A,y,z){let st=y.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,A),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let J=i.get(y.depthTexture);J.__renderTarget=y;let lt=st?y.depthTexture.image[0]:y.depthTexture.image;(!J.__webglTexture||lt.width!==y.width||lt.height!==y.height)&&(lt.width=y.width,lt.height=y.height,y.depthTexture.needsUpdate=!0),st?vt(y.depthTexture,0):_t(y.depthTexture,0);let mt=J.__webglTexture,Z=_e(y),j=st?n.TEXTURE_CUBE_MAP_POSITIVE_X+z:n.TEXTURE_2D,ut=y.depthTexture.format===hn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(y.depthTexture.format===sn)pt(y)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,j,mt,0,Z):n.framebufferTexture2D(n.FRAMEBUFFER,ut,j,mt,0);else if(y.depthTexture.format===hn)pt(y)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,j,mt,0,Z):n.framebufferTexture2D(n.FRAMEBUFFER,ut,j,mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function ie(A){let y=i.get(A),z=A.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==A.depthTexture){let st=A.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),st){let J=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,st.removeEventListener("dispose",J)};st.addEventListener("dispose",J),y.__depthDisposeCallback=J}y.__boundDepthTexture=st}if(A.depthTexture&&!y.__autoAllocateDepthBuffer)if(z)for(let st=0;st<6;st++)Pt(y.__webglFramebuffer[st],A,st);else A.texture.mipmaps.length>0?Pt(y.__webglFramebuffer[0],A,0):Pt(y.__webglFramebuffer,A,0);else if(z){y.__webglDepthbuffer=[];for(let st=0;st<6;st++)if(e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[st]),y.__webglDepthbuffer[st]===void 0)y.__webglDepthbuffer[st]=n.createRenderbuffer(),qt(y.__webglDepthbuffer[st],A,!1);else{let J=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,lt=y.__webglDepthbuffer[st];n.bindRenderbuffer(n.RENDERBUFFER,lt),n.framebufferRenderbuffer(n.FRAMEBUFFER,J,n.RENDERBUFFER,lt)}}else if(A.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),qt(y.__webglDepthbuffer,A,!1);else{let J=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,lt=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,lt),n.framebufferRenderbuffer(n.FRAMEBUFFER,J,n.RENDERBUFFER,lt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function ne(A,y,z){let st=i.get(A);y!==void 0&&xt(st.__webglFramebuffer,A,A.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),z!==void 0&&ie(A)}function le(A){let y=A.texture,z=i.get(A),st=i.get(y);A.addEventListener("dispose",F),U(A);let J=A.textures,lt=A.isWebGLCubeRenderTarget===!0,mt=J.length>1;if(mt||(st.__webglTexture===void 0&&(st.__webglTexture=n.createTexture()),st.__version=y.version,a.memory.textures++),lt){z.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(y.mipmaps.length>0){z.__webglFramebuffer[Z]=[];for(let j=0;j<y.mipmaps.length;j++)z.__webglFramebuffer[Z][j]=n.createFramebuffer()}else z.__webglFramebuffer[Z]=n.createFramebuffer()}else{if(y.mipmaps.length>0){z.__webglFramebuffer=[];for(let Z=0;Z<y.mipmaps.length;Z++)z.__webglFramebuffer[Z]=n.createFramebuffer()}else z.__webglFramebuffer=n.createFramebuffer();if(mt)for(let Z=0,j=J.length;Z<j;Z++){let ut=i.get(J[Z]);ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture(),a.memory.textures++)}if(A.samples>0&&pt(A)===!1){z.__webglMultisampledFramebuffer=n.createFramebuffer(),z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Z=0;Z<J.length;Z++){let j=J[Z];z.__webglColorRenderbuffer[Z]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,z.__webglColorRenderbuffer[Z]);let ut=r.convert(j.format,j.colorSpace),N=r.convert(j.type),K=E(j.internalFormat,ut,N,j.normalized,j.colorSpace,A.isXRRenderTarget===!0),q=_e(A);n.renderbufferStorageMultisample(n.RENDERBUFFER,q,K,A.width,A.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Z,n.RENDERBUFFER,z.__webglColorRenderbuffer[Z])}n.bindRenderbuffer(n.RENDERBUFFER,null),A.depthBuffer&&(z.__webglDepthRenderbuffer=n.createRenderbuffer(),qt(z.__webglDepthRenderbuffer,A,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(lt){e.bindTexture(n.TEXTURE_CUBE_MAP,st.__webglTexture),Jt(n.TEXTURE_CUBE_MAP,y);for(let Z=0;Z<6;Z++)if(y.mipmaps.length>0)for(let j=0;j<y.mipmaps.length;j++)xt(z.__webglFramebuffer[Z][j],A,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,j);else xt(z.__webglFramebuffer[Z],A,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);w(y)?b(n.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),e.unbindTexture()}else if(mt){for(let Z=0,j=J.length;Z<j;Z++){let ut=J[Z],N=i.get(ut),K=n.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(K=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(K,N.__webglTexture),Jt(K,ut),xt(z.__webglFramebuffer,A,ut,n.COLOR_ATTACHMENT0+Z,K,0),w(ut)&&b(K)}e.unbindTexture()}else{let Z=n.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(Z=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(Z,st.__webglTexture),Jt(Z,y),y.mipmaps.length>0)for(let j=0;j<y.mipmaps.length;j++)xt(z.__webglFramebuffer[j],A,y,n.COLOR_ATTACHMENT0,Z,j);else xt(z.__webglFramebuffer,A,y,n.COLOR_ATTACHMENT0,Z,0);w(y)?b(Z):y.mipmaps.length>0&&n.texParameteri(Z,n.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),e.unbindTexture()}A.depthBuffer&&ie(A)}function O(A){let y=A.textures;for(let z=0,st=y.length;z<st;z++){let J=y[z];if(w(J)&&J.mipmapsAutoUpdate===!0){let lt=C(A),mt=i.get(J).__webglTexture;e.bindTexture(lt,mt),b(lt),e.unbindTexture()}}}let De=[];function te(A){if(A.samples>0){if(pt(A)===!1){let y=A.textures,z=A.width,st=A.height,J=n.COLOR_BUFFER_BIT,lt=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,mt=i.get(A),Z=y.length>1;if(Z)for(let ut=0;ut<y.length;ut++)e.bindFramebuffer(n.FRAMEBUFFER,mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,mt.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,mt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,mt.__webglFramebuffer);for(let ut=0;ut<y.length;ut++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(J|=n.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(J|=n.STENCIL_BUFFER_BIT)),Z){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,mt.__webglColorRenderbuffer[ut]);let N=i.get(y[ut]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,N,0)}n.blitFramebuffer(0,0,z,st,0,0,z,st,J,n.NEAREST),l===!0&&(De.length=0,De.push(n.COLOR_ATTACHMENT0+ut),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&De.push(lt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,De))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Z)for(let ut=0;ut<y.length;ut++){e.bindFramebuffer(n.FRAMEBUFFER,mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.RENDERBUFFER,mt.__webglColorRenderbuffer[ut]);let N=i.get(y[ut]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.TEXTURE_2D,N,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,mt.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let y=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function _e(A){return Math.min(s.maxSamples,A.samples)}function pt(A){let y=i.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Ie(A){let y=a.render.frame;h.get(A)!==y&&(h.set(A,y),A.update())}function Ut(A,y){let z=A.colorSpace,st=A.format,J=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||z!==Ar&&z!==un&&(ae.getTransfer(z)===fe?(st!==Di||J!==ui)&&Ft("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):zt("WebGLTextures: Unsupported texture color space:",z)),y}function Vt(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=kt,this.resetTextureUnits=Q,this.getTextureUnits=et,this.setTextureUnits=wt,this.setTexture2D=_t,this.setTexture2DArray=Tt,this.setTexture3D=Dt,this.setTextureCube=vt,this.rebindTextures=ne,this.setupRenderTarget=le,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=te,this.setupDepthRenderbuffer=ie,this.setupFrameBufferTexture=xt,this.useMultisampledRTT=pt,this.dispose=k}function Fb(n,t){function e(i,s=un){let r,a=ae.getTransfer(s);if(i===ui)return n.UNSIGNED_BYTE;if(i===ll)return n.UNSIGNED_SHORT_4_4_4_4;if(i===cl)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Su)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===wu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===bu)return n.BYTE;if(i===Mu)return n.SHORT;if(i===js)return n.UNSIGNED_SHORT;if(i===ol)return n.INT;if(i===Ni)return n.UNSIGNED_INT;if(i===wi)return n.FLOAT;if(i===Li)return n.HALF_FLOAT;if(i===Tu)return n.ALPHA;if(i===Eu)return n.RGB;if(i===Di)return n.RGBA;if(i===sn)return n.DEPTH_COMPONENT;if(i===hn)return n.DEPTH_STENCIL;if(i===hl)return n.RED;if(i===ul)return n.RED_INTEGER;if(i===In)return n.RG;if(i===dl)return n.RG_INTEGER;if(i===fl)return n.RGBA_INTEGER;if(i===la||i===ca||i===ha||i===ua)if(a===fe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===la)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===la)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ca)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ha)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ua)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===pl||i===ml||i===gl||i===xl)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===pl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ml)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===gl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===xl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===_l||i===vl||i===yl||i===bl||i===Ml||i===da||i===Sl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===_l||i===vl)return a===fe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===yl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===bl)return r.COMPRESSED_R11_EAC;if(i===Ml)return r.COMPRESSED_SIGNED_R11_EAC;if(i===da)return r.COMPRESSED_RG11_EAC;if(i===Sl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===wl||i===Tl||i===El||i===Al||i===Cl||i===Rl||i===Pl||i===Il||i===Nl||i===Ll||i===Dl||i===Ol||i===Ul||i===Fl)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===wl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Tl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===El)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Al)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Cl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Rl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Pl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Il)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Nl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ll)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Dl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ol)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ul)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Fl)return a===fe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===kl||i===Bl||i===zl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===kl)return a===fe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Bl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===zl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Gl||i===Vl||i===fa||i===Hl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Gl)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Vl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===fa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Hl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ns?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var kb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Bb=`
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

}`,Ku=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Gr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Wi({vertexShader:kb,fragmentShader:Bb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Pe(new Jr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ju=class extends Ii{constructor(t,e){super();let i=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,v=typeof XRWebGLBinding<"u",m=new Ku,g={},M=e.getContextAttributes(),w=null,b=null,C=[],E=[],_=new it,T=null,U=null,P=new Ze;P.viewport=new Ae;let D=new Ze;D.viewport=new Ae;let F=[P,D],X=new il,R=null,k=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let _t=C[Y];return _t===void 0&&(_t=new ks,C[Y]=_t),_t.getTargetRaySpace()},this.getControllerGrip=function(Y){let _t=C[Y];return _t===void 0&&(_t=new ks,C[Y]=_t),_t.getGripSpace()},this.getHand=function(Y){let _t=C[Y];return _t===void 0&&(_t=new ks,C[Y]=_t),_t.getHandSpace()};function W(Y){let _t=E.indexOf(Y.inputSource);if(_t===-1)return;let Tt=C[_t];Tt!==void 0&&(Tt.update(Y.inputSource,Y.frame,c||a),Tt.dispatchEvent({type:Y.type,data:Y.inputSource}))}function V(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",nt);for(let Y=0;Y<C.length;Y++){let _t=E[Y];_t!==null&&(E[Y]=null,C[Y].disconnect(_t))}R=null,k=null,m.reset();for(let Y in g)delete g[Y];if(t.setRenderTarget(w),f=null,d=null,u=null,s=null,b=null,kt.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),U!==null){let Y=U.camera;Y.fov=U.fov,Y.zoom=U.zoom,Y.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,i.isPresenting===!0&&Ft("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){o=Y,i.isPresenting===!0&&Ft("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Y){c=Y},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Y){if(s=Y,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",V),s.addEventListener("inputsourceschange",nt),M.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let Tt=null,Dt=null,vt=null;M.depth&&(vt=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Tt=M.stencil?hn:sn,Dt=M.stencil?ns:Ni);let Ot={colorFormat:e.RGBA8,depthFormat:vt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ot),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new xi(d.textureWidth,d.textureHeight,{format:Di,type:ui,depthTexture:new on(d.textureWidth,d.textureHeight,Dt,void 0,void 0,void 0,void 0,void 0,void 0,Tt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Tt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,Tt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new xi(f.framebufferWidth,f.framebufferHeight,{format:Di,type:ui,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),kt.setContext(s),kt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function nt(Y){for(let _t=0;_t<Y.removed.length;_t++){let Tt=Y.removed[_t],Dt=E.indexOf(Tt);Dt>=0&&(E[Dt]=null,C[Dt].disconnect(Tt))}for(let _t=0;_t<Y.added.length;_t++){let Tt=Y.added[_t],Dt=E.indexOf(Tt);if(Dt===-1){for(let Ot=0;Ot<C.length;Ot++)if(Ot>=E.length){E.push(Tt),Dt=Ot;break}else if(E[Ot]===null){E[Ot]=Tt,Dt=Ot;break}if(Dt===-1)break}let vt=C[Dt];vt&&vt.connect(Tt)}}function $(Y,_t){_t===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(_t.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(s===null)return;let _t=Y.near,Tt=Y.far;m.texture!==null&&(m.depthNear>0&&(_t=m.depthNear),m.depthFar>0&&(Tt=m.depthFar)),X.near=D.near=P.near=_t,X.far=D.far=P.far=Tt,(R!==X.near||k!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),R=X.near,k=X.far),X.layers.mask=Y.layers.mask|6,P.layers.mask=X.layers.mask&-5,D.layers.mask=X.layers.mask&-3;let Dt=Y.parent,vt=X.cameras;$(X,Dt);for(let Ot=0;Ot<vt.length;Ot++)$(vt[Ot],Dt);X.projectionMatrix.copy(P.projectionMatrix),X.projectionMatrixInverse.copy(P.projectionMatrixInverse),U===null&&Y.isPerspectiveCamera&&(U={camera:Y,fov:Y.fov,zoom:Y.zoom}),Q(Y,X,Dt)};function Q(Y,_t,Tt){Tt===null?Y.matrix.copy(_t.matrixWorld):(Y.matrix.copy(Tt.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(_t.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(_t.projectionMatrix),Y.projectionMatrixInverse.copy(_t.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=Us*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Y){l=Y,d!==null&&(d.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(X)},this.getCameraTexture=function(Y){return g[Y]};let et=null;function wt(Y,_t){if(h=_t.getViewerPose(c||a),p=_t,h!==null){let Tt=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Dt=!1;Tt.length!==X.cameras.length&&(X.cameras.length=0,Dt=!0);for(let Bt=0;Bt<Tt.length;Bt++){let Jt=Tt[Bt],ee=null;if(f!==null)ee=f.getViewport(Jt);else{let ht=u.getViewSubImage(d,Jt);ee=ht.viewport,Bt===0&&(t.setRenderTargetTextures(b,ht.colorTexture,ht.depthStencilTexture),t.setRenderTarget(b))}let tt=F[Bt];tt===void 0&&(tt=new Ze,tt.layers.enable(Bt),tt.viewport=new Ae,F[Bt]=tt),tt.matrix.fromArray(Jt.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(Jt.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ee.x,ee.y,ee.width,ee.height),Bt===0&&(X.matrix.copy(tt.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Dt===!0&&X.cameras.push(tt)}let vt=s.enabledFeatures;if(vt&&vt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=i.getBinding();let Bt=u.getDepthInformation(Tt[0]);Bt&&Bt.isValid&&Bt.texture&&m.init(Bt,s.renderState)}if(vt&&vt.includes("camera-access")&&v){t.state.unbindTexture(),u=i.getBinding();for(let Bt=0;Bt<Tt.length;Bt++){let Jt=Tt[Bt].camera;if(Jt){let ee=g[Jt];ee||(ee=new Gr,g[Jt]=ee);let tt=u.getCameraImage(Jt);ee.sourceTexture=tt}}}}for(let Tt=0;Tt<C.length;Tt++){let Dt=E[Tt],vt=C[Tt];Dt!==null&&vt!==void 0&&vt.update(Dt,_t,c||a)}et&&et(Y,_t),_t.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_t}),p=null}let kt=new Jp;kt.setAnimationLoop(wt),this.setAnimationLoop=function(Y){et=Y},this.dispose=function(){}}},zb=new pe,lm=new Wt;lm.set(-1,0,0,0,1,0,0,0,1);function Gb(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Bu(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,M,w,b){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,b)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),v(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(a(m,g),g.isLineDashedMaterial&&o(m,g)):g.isPointsMaterial?l(m,g,M,w):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===ke&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===ke&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let M=t.get(g),w=M.envMap,b=M.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(zb.makeRotationFromEuler(b)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(lm),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function a(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function o(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,M,w){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*M,m.scale.value=w*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,M){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ke&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function v(m,g){let M=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Vb(n,t,e,i){let s={},r={};function a(M,w){let b=w.program;i.uniformBlockBinding(M,b,s[M.id])}function o(M,w){let b=s[M.id];b===void 0&&(p(M),b=l(M),s[M.id]=b,M.addEventListener("dispose",m));let C=w.program;i.updateUBOMapping(M,C);let E=t.render.frame;r[M.id]!==E&&(c(M),r[M.id]=E)}function l(M){let w=n.createBuffer(),b=M.__size,C=M.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(M){let w=s[M.id],b=M.uniforms,C=M.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let E=0,_=b.length;E<_;E++){let T=b[E];if(Array.isArray(T))for(let U=0,P=T.length;U<P;U++)h(T[U],E,U,C);else h(T,E,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(M,w,b,C){if(d(M,w,b,C)===!0){let E=M.__offset,_=M.value;if(Array.isArray(_)){let T=0;for(let U=0;U<_.length;U++){let P=_[U],D=v(P,!0);u(P,M.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,M.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,M.__data)}}function u(M,w,b){typeof M=="number"||typeof M=="boolean"?w[b]=M:M.isMatrix3?(w[b]=M.elements[0],w[b+1]=M.elements[1],w[b+2]=M.elements[2],w[b+3]=0,w[b+4]=M.elements[3],w[b+5]=M.elements[4],w[b+6]=M.elements[5],w[b+7]=0,w[b+8]=M.elements[6],w[b+9]=M.elements[7],w[b+10]=M.elements[8],w[b+11]=0):ArrayBuffer.isView(M)?w.set(M.subarray(0,w.length-b),b):M.toArray(w,b)}function d(M,w,b,C){let E=M.value,_=w+"_"+b;if(Array.isArray(E)){C[_]===void 0&&(C[_]=[]);let T=C[_],U=!1;for(let P=0;P<E.length;P++)f(E[P],T,P)===!0&&(U=!0);return U}return f(E,C,_)}function f(M,w,b){if(w[b]===void 0)return typeof M=="number"||typeof M=="boolean"?w[b]=M:ArrayBuffer.isView(M)?w[b]=M.slice():w[b]=M.clone(),!0;{let C=w[b];if(typeof M=="number"||typeof M=="boolean"){if(C!==M)return w[b]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(C.equals(M)===!1)return C.copy(M),!0}}return!1}function p(M){let w=M.uniforms,b=0,C=16;for(let _=0,T=w.length;_<T;_++){let U=Array.isArray(w[_])?w[_]:[w[_]];for(let P=0,D=U.length;P<D;P++){let F=U[P],X=Array.isArray(F.value)?F.value:[F.value],R=Array.isArray(w[_])||Array.isArray(F.value),k=b;for(let V=0,nt=X.length;V<nt;V++){let $=X[V],Q=v($,R),et=b%C,wt=et%Q.boundary,kt=et+wt;b+=wt,kt!==0&&C-kt<Q.storage&&(b+=C-kt),V===0&&(k=b),b+=Q.storage}let W=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new W((b-k)/Float32Array.BYTES_PER_ELEMENT),F.__offset=k}}let E=b%C;return E>0&&(b+=C-E),M.__size=b,M.__cache={},this}function v(M,w){let b={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(b.boundary=4,b.storage=4):M.isVector2?(b.boundary=8,b.storage=8):M.isVector3||M.isColor?(b.boundary=16,b.storage=12):M.isVector4?(b.boundary=16,b.storage=16):M.isMatrix3?(b.boundary=16,b.storage=48):M.isMatrix4?(b.boundary=16,b.storage=64):M.isTexture?Ft("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(b.boundary=16,b.storage=M.byteLength):Ft("WebGLRenderer: Unsupported uniform value type.",M),w===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(M){let w=M.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function g(){for(let M in s)n.deleteBuffer(s[M]);s={},r={}}return{bind:a,update:o,dispose:g}}var Hb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Yi=null;function Wb(){return Yi===null&&(Yi=new Fr(Hb,16,16,In,Li),Yi.name="DFG_LUT",Yi.minFilter=ai,Yi.magFilter=ai,Yi.wrapS=Bi,Yi.wrapT=Bi,Yi.generateMipmaps=!1,Yi.needsUpdate=!0),Yi}var Zl=class{constructor(t={}){let{canvas:e=_p(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ui}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=a;let v=f,m=new Set([fl,dl,ul]),g=new Set([ui,Ni,js,ns,ll,cl]),M=new Uint32Array(4),w=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,E=null,_=[],T=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,D=!1,F=null,X=null,R=null,k=null;this._outputColorSpace=mi;let W=0,V=0,nt=null,$=-1,Q=null,et=new Ae,wt=new Ae,kt=null,Y=new Nt(0),_t=0,Tt=e.width,Dt=e.height,vt=1,Ot=null,Se=null,Bt=new Ae(0,0,Tt,Dt),Jt=new Ae(0,0,Tt,Dt),ee=!1,tt=new Tn,ht=new No,ot=!1,St=!1,xt=new pe,qt=new I,Pt=new Ae,ie={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ne=!1;function le(){return nt===null?vt:1}let O=i;function De(S,L){return e.getContext(S,L)}let te,_e,pt,Ie,Ut,Vt,A,y,z,st,J,lt,mt,Z,j,ut,N,K,q,dt,at,ct,It;try{let S={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Lt,!1),e.addEventListener("webglcontextrestored",Yt,!1),e.addEventListener("webglcontextcreationerror",yt,!1),O===null){let L="webgl2";if(O=De(L,S),O===null)throw De(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Zt()}catch(S){throw e.removeEventListener("webglcontextlost",Lt,!1),e.removeEventListener("webglcontextrestored",Yt,!1),e.removeEventListener("webglcontextcreationerror",yt,!1),zt("WebGLRenderer: "+S.message),S}function Zt(){te=new ey(O),te.init(),at=new Fb(O,te),_e=new Wv(O,te,t,at),pt=new Ob(O,te),_e.reversedDepthBuffer&&d&&pt.buffers.depth.setReversed(!0),X=O.createFramebuffer(),R=O.createFramebuffer(),k=O.createFramebuffer(),Ie=new sy(O),Ut=new bb,Vt=new Ub(O,te,pt,Ut,_e,at,Ie),A=new ty(P),y=new ax(O),ct=new Vv(O,y),z=new iy(O,y,Ie,ct),st=new ay(O,z,y,ct,Ie),K=new ry(O,_e,Vt),j=new Xv(Ut),J=new yb(P,A,te,_e,ct,j),lt=new Gb(P,Ut),mt=new Sb,Z=new Rb(te),N=new Gv(P,A,pt,st,p,l),ut=new Db(P,st,_e),It=new Vb(O,Ie,_e,pt),q=new Hv(O,te,Ie),dt=new ny(O,te,Ie),Ie.programs=J.programs,P.capabilities=_e,P.extensions=te,P.properties=Ut,P.renderLists=mt,P.shadowMap=ut,P.state=pt,P.info=Ie}v!==ui&&(U=new ly(v,e.width,e.height,o,s,r));let rt=new Ju(P,O);this.xr=rt,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let S=te.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=te.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return vt},this.setPixelRatio=function(S){S!==void 0&&(vt=S,this.setSize(Tt,Dt,!1))},this.getSize=function(S){return S.set(Tt,Dt)},this.setSize=function(S,L,H=!0){if(rt.isPresenting){Ft("WebGLRenderer: Can't change size while VR device is presenting.");return}Tt=S,Dt=L,e.width=Math.floor(S*vt),e.height=Math.floor(L*vt),H===!0&&(e.style.width=S+"px",e.style.height=L+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,S,L)},this.getDrawingBufferSize=function(S){return S.set(Tt*vt,Dt*vt).floor()},this.setDrawingBufferSize=function(S,L,H){Tt=S,Dt=L,vt=H,e.width=Math.floor(S*H),e.height=Math.floor(L*H),this.setViewport(0,0,S,L)},this.setEffects=function(S){if(v===ui){zt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let L=0;L<S.length;L++)if(S[L].isOutputPass===!0){Ft("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(et)},this.getViewport=function(S){return S.copy(Bt)},this.setViewport=function(S,L,H,B){S.isVector4?Bt.set(S.x,S.y,S.z,S.w):Bt.set(S,L,H,B),pt.viewport(et.copy(Bt).multiplyScalar(le()).round())},this.getScissor=function(S){return S.copy(Jt)},this.setScissor=function(S,L,H,B){S.isVector4?Jt.set(S.x,S.y,S.z,S.w):Jt.set(S,L,H,B),pt.scissor(wt.copy(Jt).multiplyScalar(le()).round())},this.getScissorTest=function(){return ee},this.setScissorTest=function(S){pt.setScissorTest(ee=S)},this.setOpaqueSort=function(S){Ot=S},this.setTransparentSort=function(S){Se=S},this.getClearColor=function(S){return S.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(S=!0,L=!0,H=!0){let B=0;if(S){let G=!1;if(nt!==null){let gt=nt.texture.format;G=m.has(gt)}if(G){let gt=nt.texture.type,Et=g.has(gt),ft=N.getClearColor(),Mt=N.getClearAlpha(),Rt=ft.r,Xt=ft.g,se=ft.b;Et?(M[0]=Rt,M[1]=Xt,M[2]=se,M[3]=Mt,O.clearBufferuiv(O.COLOR,0,M)):(w[0]=Rt,w[1]=Xt,w[2]=se,w[3]=Mt,O.clearBufferiv(O.COLOR,0,w))}else B|=O.COLOR_BUFFER_BIT}L&&(B|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(B|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),B!==0&&O.clear(B)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),F=S},this.dispose=function(){e.removeEventListener("webglcontextlost",Lt,!1),e.removeEventListener("webglcontextrestored",Yt,!1),e.removeEventListener("webglcontextcreationerror",yt,!1),N.dispose(),mt.dispose(),Z.dispose(),Vt.dispose(),Ut.dispose(),A.dispose(),st.dispose(),z.dispose(),ct.dispose(),It.dispose(),J.dispose(),rt.dispose(),rt.removeEventListener("sessionstart",Dd),rt.removeEventListener("sessionend",Od),Un.stop()};function Lt(S){S.preventDefault(),Pr("WebGLRenderer: Context Lost."),D=!0}function Yt(){Pr("WebGLRenderer: Context Restored."),D=!1;let S=Ie.autoReset,L=ut.enabled,H=ut.autoUpdate,B=ut.needsUpdate,G=ut.type;Zt(),Ie.autoReset=S,ut.enabled=L,ut.autoUpdate=H,ut.needsUpdate=B,ut.type=G}function yt(S){zt("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function me(S){let L=S.target;L.removeEventListener("dispose",me),He(L)}function He(S){gn(S),Ut.remove(S)}function gn(S){let L=Ut.get(S).programs;L!==void 0&&(L.forEach(function(H){J.releaseProgram(H)}),S.isShaderMaterial&&J.releaseShaderCache(S))}this.renderBufferDirect=function(S,L,H,B,G,gt){L===null&&(L=ie);let Et=G.isMesh&&G.matrixWorld.determinantAffine()<0,ft=Lg(S,L,H,B,G);pt.setMaterial(B,Et);let Mt=H.index,Rt=1;if(B.wireframe===!0){if(Mt=z.getWireframeAttribute(H),Mt===void 0)return;Rt=2}let Xt=H.drawRange,se=H.attributes.position,At=Xt.start*Rt,re=(Xt.start+Xt.count)*Rt;gt!==null&&(At=Math.max(At,gt.start*Rt),re=Math.min(re,(gt.start+gt.count)*Rt)),Mt!==null?(At=Math.max(At,0),re=Math.min(re,Mt.count)):se!=null&&(At=Math.max(At,0),re=Math.min(re,se.count));let Oe=re-At;if(Oe<0||Oe===1/0)return;ct.setup(G,B,ft,H,Mt);let ye,ve=q;if(Mt!==null&&(ye=y.get(Mt),ve=dt,ve.setIndex(ye)),G.isMesh)B.wireframe===!0?(pt.setLineWidth(B.wireframeLinewidth*le()),ve.setMode(O.LINES)):ve.setMode(O.TRIANGLES);else if(G.isLine){let Je=B.linewidth;Je===void 0&&(Je=1),pt.setLineWidth(Je*le()),G.isLineSegments?ve.setMode(O.LINES):G.isLineLoop?ve.setMode(O.LINE_LOOP):ve.setMode(O.LINE_STRIP)}else G.isPoints?ve.setMode(O.POINTS):G.isSprite&&ve.setMode(O.TRIANGLES);if(G.isBatchedMesh)if(te.get("WEBGL_multi_draw"))ve.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let Je=G._multiDrawStarts,Ct=G._multiDrawCounts,si=G._multiDrawCount,he=Mt?y.get(Mt).bytesPerElement:1,Fn=Ut.get(B).currentProgram.getUniforms();for(let Qe=0;Qe<si;Qe++)Fn.setValue(O,"_gl_DrawID",Qe),ve.render(Je[Qe]/he,Ct[Qe])}else if(G.isInstancedMesh)ve.renderInstances(At,Oe,G.count);else if(H.isInstancedBufferGeometry){let Je=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,Ct=Math.min(H.instanceCount,Je);ve.renderInstances(At,Oe,Ct)}else ve.render(At,Oe)};function Ld(S,L,H,B){F!==null&&S.isNodeMaterial&&F.setObject(B,S),ot===!0&&j.setState(S,H,!1),S.transparent===!0&&S.side===ii&&S.forceSinglePass===!1?(S.side=ke,S.needsUpdate=!0,lr(S,L,B),S.side=Pn,S.needsUpdate=!0,lr(S,L,B),S.side=ii):lr(S,L,B)}this.compile=function(S,L,H=null){H===null&&(H=S),F!==null&&F.renderStart(S,L,H),E=Z.get(H),E.init(L),T.push(E),H.traverseVisible(function(G){G.isLight&&G.layers.test(L.layers)&&(E.pushLight(G),G.castShadow&&E.pushShadow(G))}),S!==H&&S.traverseVisible(function(G){G.isLight&&G.layers.test(L.layers)&&(E.pushLight(G),G.castShadow&&E.pushShadow(G))}),E.setupLights(),F!==null&&F.updateLights(E.state.lightsArray),St=this.localClippingEnabled,ot=j.init(this.clippingPlanes,St),ot===!0&&j.setGlobalState(this.clippingPlanes,L),F!==null&&ut.render(E.state.shadowsArray,H,L);let B=new Set;return S.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let gt=G.material;if(gt)if(Array.isArray(gt))for(let Et=0;Et<gt.length;Et++){let ft=gt[Et];Ld(ft,H,L,G),B.add(ft)}else Ld(gt,H,L,G),B.add(gt)}),E=T.pop(),F!==null&&F.renderEnd(),B},this.compileAsync=function(S,L,H=null){let B=this.compile(S,L,H);return new Promise(G=>{function gt(){if(B.forEach(function(Et){let Mt=Ut.get(Et).currentProgram;(Mt===void 0||Mt.isReady())&&B.delete(Et)}),B.size===0){G(S);return}setTimeout(gt,10)}te.get("KHR_parallel_shader_compile")!==null?gt():setTimeout(gt,10)})};let ph=null;function Ig(S){ph&&ph(S)}function Dd(){Un.stop()}function Od(){Un.start()}let Un=new Jp;Un.setAnimationLoop(Ig),typeof self<"u"&&Un.setContext(self),this.setAnimationLoop=function(S){ph=S,rt.setAnimationLoop(S),S===null?Un.stop():Un.start()},rt.addEventListener("sessionstart",Dd),rt.addEventListener("sessionend",Od),this.render=function(S,L){if(L!==void 0&&L.isCamera!==!0){zt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;F!==null&&F.renderStart(S,L);let H=rt.enabled===!0&&rt.isPresenting===!0,B=U!==null&&(nt===null||H)&&U.begin(P,nt);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),rt.enabled===!0&&rt.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(rt.cameraAutoUpdate===!0&&rt.updateCamera(L),L=rt.getCamera()),S.isScene===!0&&S.onBeforeRender(P,S,L,nt),E=Z.get(S,T.length),E.init(L),E.state.textureUnits=Vt.getTextureUnits(),T.push(E),xt.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?ht.setFromArrayCamera(L):tt.setFromProjectionMatrix(xt,Mi,L.reversedDepth),St=this.localClippingEnabled,ot=j.init(this.clippingPlanes,St),C=mt.get(S,_.length),C.init(),_.push(C),this.info.render.frame++,rt.enabled===!0&&rt.isPresenting===!0){let Et=P.xr.getDepthSensingMesh();Et!==null&&mh(Et,L,-1/0,P.sortObjects)}mh(S,L,0,P.sortObjects),C.finish(),F!==null&&F.updateLights(E.state.lightsArray),P.sortObjects===!0&&C.sort(Ot,Se),ne=rt.enabled===!1||rt.isPresenting===!1||rt.hasDepthSensing()===!1,ne&&N.addToRenderList(C,S),this.info.autoReset===!0&&this.info.reset(),ot===!0&&j.beginShadows();let G=E.state.shadowsArray;if(ut.render(G,S,L),ot===!0&&j.endShadows(),(B&&U.hasRenderPass())===!1){let Et=C.opaque,ft=C.transmissive;if(E.setupLights(),L.isArrayCamera){let Mt=L.cameras;if(ft.length>0)for(let Rt=0,Xt=Mt.length;Rt<Xt;Rt++){let se=Mt[Rt];Fd(Et,ft,S,se)}ne&&N.render(S);for(let Rt=0,Xt=Mt.length;Rt<Xt;Rt++){let se=Mt[Rt];Ud(C,S,se,se.viewport)}}else ft.length>0&&Fd(Et,ft,S,L),ne&&N.render(S),Ud(C,S,L)}nt!==null&&V===0&&(Vt.updateMultisampleRenderTarget(nt),Vt.updateRenderTargetMipmap(nt)),B&&U.end(P),S.isScene===!0&&S.onAfterRender(P,S,L),ct.resetDefaultState(),$=-1,Q=null,T.pop(),T.length>0?(E=T[T.length-1],Vt.setTextureUnits(E.state.textureUnits),ot===!0&&j.setGlobalState(P.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,F!==null&&F.renderEnd()};function mh(S,L,H,B){if(S.visible===!1)return;if(S.layers.test(L.layers)){if(S.isGroup)H=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(L);else if(S.isLight)E.pushLight(S),S.castShadow&&E.pushShadow(S);else if(S.isSprite){let Et=L.isArrayCamera?ht:tt;if(!S.frustumCulled||S.intersectsFrustum(Et)){B&&Pt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(xt);let ft=st.update(S),Mt=S.material;Mt.visible&&C.push(S,ft,Mt,H,Pt.z,null,L)}}else if(S.isMesh||S.isLine||S.isPoints){let Et=L.isArrayCamera?ht:tt;if(!S.frustumCulled||S.intersectsFrustum(Et)){let ft=st.update(S),Mt=S.material;if(B&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Pt.copy(S.boundingSphere.center)):(ft.boundingSphere===null&&ft.computeBoundingSphere(),Pt.copy(ft.boundingSphere.center)),Pt.applyMatrix4(S.matrixWorld).applyMatrix4(xt)),Array.isArray(Mt)){let Rt=ft.groups;for(let Xt=0,se=Rt.length;Xt<se;Xt++){let At=Rt[Xt],re=Mt[At.materialIndex];re&&re.visible&&C.push(S,ft,re,H,Pt.z,At,L)}}else Mt.visible&&C.push(S,ft,Mt,H,Pt.z,null,L)}}}let gt=S.children;for(let Et=0,ft=gt.length;Et<ft;Et++)mh(gt[Et],L,H,B)}function Ud(S,L,H,B){let{opaque:G,transmissive:gt,transparent:Et}=S;E.setupLightsView(H),ot===!0&&j.setGlobalState(P.clippingPlanes,H),B&&pt.viewport(et.copy(B)),G.length>0&&Ra(G,L,H),gt.length>0&&Ra(gt,L,H),Et.length>0&&Ra(Et,L,H),pt.buffers.depth.setTest(!0),pt.buffers.depth.setMask(!0),pt.buffers.color.setMask(!0),pt.setPolygonOffset(!1)}function Fd(S,L,H,B){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[B.id]===void 0){let At=te.has("EXT_color_buffer_half_float")||te.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[B.id]=new xi(1,1,{generateMipmaps:!0,type:At?Li:ui,minFilter:cn,samples:Math.max(4,_e.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ae.workingColorSpace})}let gt=E.state.transmissionRenderTarget[B.id],Et=B.viewport||et;gt.setSize(Et.z*P.transmissionResolutionScale,Et.w*P.transmissionResolutionScale);let ft=P.getRenderTarget(),Mt=P.getActiveCubeFace(),Rt=P.getActiveMipmapLevel();P.setRenderTarget(gt),P.getClearColor(Y),_t=P.getClearAlpha(),_t<1&&P.setClearColor(16777215,.5),P.clear(),ne&&N.render(H);let Xt=P.toneMapping;P.toneMapping=qi;let se=B.viewport;if(B.viewport!==void 0&&(B.viewport=void 0),E.setupLightsView(B),ot===!0&&j.setGlobalState(P.clippingPlanes,B),Ra(S,H,B),Vt.updateMultisampleRenderTarget(gt),Vt.updateRenderTargetMipmap(gt),te.has("WEBGL_multisampled_render_to_texture")===!1){let At=!1;for(let re=0,Oe=L.length;re<Oe;re++){let ye=L[re],{object:ve,geometry:Je,material:Ct,group:si}=ye;if(Ct.side===ii&&ve.layers.test(B.layers)){let he=Ct.side;Ct.side=ke,Ct.needsUpdate=!0,kd(ve,H,B,Je,Ct,si),Ct.side=he,Ct.needsUpdate=!0,At=!0}}At===!0&&(Vt.updateMultisampleRenderTarget(gt),Vt.updateRenderTargetMipmap(gt))}P.setRenderTarget(ft,Mt,Rt),P.setClearColor(Y,_t),se!==void 0&&(B.viewport=se),P.toneMapping=Xt}function Ra(S,L,H){let B=L.isScene===!0?L.overrideMaterial:null;for(let G=0,gt=S.length;G<gt;G++){let Et=S[G],{object:ft,geometry:Mt,group:Rt}=Et,Xt=Et.material;Xt.allowOverride===!0&&B!==null&&(Xt=B),ft.layers.test(H.layers)&&kd(ft,L,H,Mt,Xt,Rt)}}function kd(S,L,H,B,G,gt){F!==null&&G.isNodeMaterial&&F.setObject(S,G),S.onBeforeRender(P,L,H,B,G,gt),S.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),G.onBeforeRender(P,L,H,B,S,gt),G.transparent===!0&&G.side===ii&&G.forceSinglePass===!1?(G.side=ke,G.needsUpdate=!0,P.renderBufferDirect(H,L,B,G,S,gt),G.side=Pn,G.needsUpdate=!0,P.renderBufferDirect(H,L,B,G,S,gt),G.side=ii):P.renderBufferDirect(H,L,B,G,S,gt),S.onAfterRender(P,L,H,B,G,gt)}function Bd(S){let L=0;for(let H of S)H.texture!==null&&L++;return L}function lr(S,L,H){L.isScene!==!0&&(L=ie);let B=Ut.get(S),G=E.state.lights,gt=E.state.shadowsArray,Et=G.state.version,ft=J.getParameters(S,G.state,gt,L,H,E.state.lightProbeGridArray),Mt=J.getProgramCacheKey(ft),Rt=B.programs;B.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?L.environment:null,B.fog=L.fog;let Xt=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;B.envMap=A.get(S.envMap||B.environment,Xt),B.envMapRotation=B.environment!==null&&S.envMap===null?L.environmentRotation:S.envMapRotation,Rt===void 0&&(S.addEventListener("dispose",me),Rt=new Map,B.programs=Rt,B.programVariants=new Map);let se=Rt.get(Mt);if(se!==void 0){if(B.currentProgram===se&&B.lightsStateVersion===Et)return Gd(S,ft),se}else ft.uniforms=J.getUniforms(S),F!==null&&S.isNodeMaterial&&F.build(S,H,ft),S.onBeforeCompile(ft,P),se=J.acquireProgram(ft,Mt),Rt.set(Mt,se),B.uniforms=ft.uniforms;let At=B.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(At.clippingPlanes=j.uniform),Gd(S,ft),B.needsLights=Og(S),B.lightsStateVersion=Et,B.needsLights&&(At.ambientLightColor.value=G.state.ambient,At.lightProbe.value=G.state.probe,At.sunLights.value=G.state.sun,At.sunLightShadows.value=G.state.sunShadow,At.directionalLights.value=G.state.directional,At.directionalLightShadows.value=G.state.directionalShadow,At.spotLights.value=G.state.spot,At.spotLightShadows.value=G.state.spotShadow,At.rectAreaLights.value=G.state.rectArea,At.ltc_1.value=G.state.rectAreaLTC1,At.ltc_2.value=G.state.rectAreaLTC2,At.pointLights.value=G.state.point,At.pointLightShadows.value=G.state.pointShadow,At.hemisphereLights.value=G.state.hemi,At.sunShadowMatrix.value=G.state.sunShadowMatrix,At.sunShadowCascade.value=G.state.sunShadowCascade,At.directionalShadowMatrix.value=G.state.directionalShadowMatrix,At.spotLightMatrix.value=G.state.spotLightMatrix,At.spotLightMap.value=G.state.spotLightMap,At.pointShadowMatrix.value=G.state.pointShadowMatrix),B.numLightProbeGrids=Bd(E.state.lightProbeGridArray),B.currentProgram=se,B.uniformsList=null,se}function Ng(S,L,H,B,G){let gt=Ut.get(S),Et=gt.currentProgram.id+","+B+","+G,ft=gt.programVariants.get(Et);return ft===void 0?(ft=lr(S,L,H),gt.programVariants.set(Et,ft)):(gt.currentProgram=ft,gt.uniformsList=null,gt.outputColorSpace=B,gt.toneMapping=G),ft}function zd(S){if(S.uniformsList===null){let L=S.currentProgram.getUniforms();S.uniformsList=Ks.seqWithValue(L.seq,S.uniforms)}return S.uniformsList}function Gd(S,L){let H=Ut.get(S);H.outputColorSpace=L.outputColorSpace,H.batching=L.batching,H.batchingColor=L.batchingColor,H.instancing=L.instancing,H.instancingColor=L.instancingColor,H.instancingMorph=L.instancingMorph,H.skinning=L.skinning,H.morphTargets=L.morphTargets,H.morphNormals=L.morphNormals,H.morphColors=L.morphColors,H.morphTargetsCount=L.morphTargetsCount,H.numClippingPlanes=L.numClippingPlanes,H.numIntersection=L.numClipIntersection,H.vertexAlphas=L.vertexAlphas,H.vertexTangents=L.vertexTangents,H.toneMapping=L.toneMapping}function Lg(S,L,H,B,G){L.isScene!==!0&&(L=ie),Vt.resetTextureUnits();let gt=L.fog,Et=B.isMeshStandardMaterial||B.isMeshLambertMaterial||B.isMeshPhongMaterial?L.environment:null,ft=nt===null?P.outputColorSpace:nt.isXRRenderTarget===!0?nt.texture.colorSpace:ae.workingColorSpace,Mt=B.isMeshStandardMaterial||B.isMeshLambertMaterial&&!B.envMap||B.isMeshPhongMaterial&&!B.envMap,Rt=A.get(B.envMap||Et,Mt),Xt=B.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,se=!!H.attributes.tangent&&(!!B.normalMap||B.anisotropy>0),At=!!H.morphAttributes.position,re=!!H.morphAttributes.normal,Oe=!!H.morphAttributes.color,ye=qi;B.toneMapped&&(nt===null||nt.isXRRenderTarget===!0)&&(ye=P.toneMapping);let ve=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,Je=ve!==void 0?ve.length:0,Ct=Ut.get(B),si=E.state.lights;if(ot===!0&&(St===!0||S!==Q)){let Ce=S===Q&&B.id===$;j.setState(B,S,Ce)}let he=!1,Fn=!1;B.version===Ct.__version?Ct.needsLights&&Ct.lightsStateVersion!==si.state.version||G.isBatchedMesh&&Ct.batching===!1||!G.isBatchedMesh&&Ct.batching===!0||G.isBatchedMesh&&Ct.batchingColor===!0&&G._colorsTexture===null||G.isBatchedMesh&&Ct.batchingColor===!1&&G._colorsTexture!==null||G.isInstancedMesh&&Ct.instancing===!1||!G.isInstancedMesh&&Ct.instancing===!0||G.isSkinnedMesh&&Ct.skinning===!1||!G.isSkinnedMesh&&Ct.skinning===!0||G.isInstancedMesh&&Ct.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&Ct.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&Ct.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&Ct.instancingMorph===!1&&G.morphTexture!==null||Ct.envMap!==Rt||B.fog===!0&&Ct.fog!==gt||Ct.numClippingPlanes!==void 0&&(Ct.numClippingPlanes!==j.numPlanes||Ct.numIntersection!==j.numIntersection)||Ct.vertexAlphas!==Xt||Ct.vertexTangents!==se||Ct.morphTargets!==At||Ct.morphNormals!==re||Ct.morphColors!==Oe||Ct.morphTargetsCount!==Je||Ct.numLightProbeGrids!==Bd(E.state.lightProbeGridArray)?he=!0:(Ct.outputColorSpace!==ft||Ct.toneMapping!==ye)&&(Fn=!0):(he=!0,Ct.__version=B.version);let Qe=Ct.currentProgram;(he===!0||Fn===!0)&&(Qe=Fn===!0?Ng(B,L,G,ft,ye):lr(B,L,G),F&&B.isNodeMaterial&&F.onUpdateProgram(B,Qe,Ct));let Pa=!1,xn=!1,kn=!1,oe=Qe.getUniforms(),Ye=Ct.uniforms;if(pt.useProgram(Qe.program)&&(Pa=!0,xn=!0,kn=!0),B.id!==$&&($=B.id,xn=!0),Pa||Q!==S){pt.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),oe.setValue(O,"projectionMatrix",S.projectionMatrix),oe.setValue(O,"viewMatrix",S.matrixWorldInverse);let We=oe.map.cameraPosition;We!==void 0&&We.setValue(O,qt.setFromMatrixPosition(S.matrixWorld)),_e.logarithmicDepthBuffer&&oe.setValue(O,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(B.isMeshPhongMaterial||B.isMeshToonMaterial||B.isMeshLambertMaterial||B.isMeshBasicMaterial||B.isMeshStandardMaterial||B.isShaderMaterial)&&oe.setValue(O,"isOrthographic",S.isOrthographicCamera===!0),Q!==S&&(Q=S,xn=!0,kn=!0)}if(Ct.needsLights&&(si.state.sunShadowMap.length>0&&oe.setValue(O,"sunShadowMap",si.state.sunShadowMap,Vt),si.state.directionalShadowMap.length>0&&oe.setValue(O,"directionalShadowMap",si.state.directionalShadowMap,Vt),si.state.spotShadowMap.length>0&&oe.setValue(O,"spotShadowMap",si.state.spotShadowMap,Vt),si.state.pointShadowMap.length>0&&oe.setValue(O,"pointShadowMap",si.state.pointShadowMap,Vt)),G.isSkinnedMesh){oe.setOptional(O,G,"bindMatrix"),oe.setOptional(O,G,"bindMatrixInverse");let Ce=G.skeleton;Ce&&(Ce.boneTexture===null&&Ce.computeBoneTexture(),oe.setValue(O,"boneTexture",Ce.boneTexture,Vt))}G.isBatchedMesh&&(oe.setOptional(O,G,"batchingTexture"),oe.setValue(O,"batchingTexture",G._matricesTexture,Vt),oe.setOptional(O,G,"batchingIdTexture"),oe.setValue(O,"batchingIdTexture",G._indirectTexture,Vt),oe.setOptional(O,G,"batchingColorTexture"),G._colorsTexture!==null&&oe.setValue(O,"batchingColorTexture",G._colorsTexture,Vt));let Ai=H.morphAttributes;if((Ai.position!==void 0||Ai.normal!==void 0||Ai.color!==void 0)&&K.update(G,H,Qe),(xn||Ct.receiveShadow!==G.receiveShadow)&&(Ct.receiveShadow=G.receiveShadow,oe.setValue(O,"receiveShadow",G.receiveShadow)),(B.isMeshStandardMaterial||B.isMeshLambertMaterial||B.isMeshPhongMaterial)&&B.envMap===null&&L.environment!==null&&(Ye.envMapIntensity.value=L.environmentIntensity),Ye.dfgLUT!==void 0&&(Ye.dfgLUT.value=Wb()),xn){if(oe.setValue(O,"toneMappingExposure",P.toneMappingExposure),Ct.needsLights&&Dg(Ye,kn),gt&&B.fog===!0&&lt.refreshFogUniforms(Ye,gt),lt.refreshMaterialUniforms(Ye,B,vt,Dt,E.state.transmissionRenderTarget[S.id]),Ct.needsLights&&Ct.numLightProbeGrids>0){let Ce=b,We=0;for(let ji of E.state.lightProbeGridArray)ji.texture!==null&&(Ce.textures[We]=ji.texture,Ce.min[We]=ji.boundingBox.min,Ce.max[We]=ji.boundingBox.max,Ce.resolution[We]=ji.resolution,We++);for(let ji in Ce)Ce[ji].length=We;Ye.probesSH.value=Ce.textures,Ye.probesMin.value=Ce.min,Ye.probesMax.value=Ce.max,Ye.probesResolution.value=Ce.resolution}Ks.upload(O,zd(Ct),Ye,Vt)}if(B.isShaderMaterial&&B.uniformsNeedUpdate===!0&&(Ks.upload(O,zd(Ct),Ye,Vt),B.uniformsNeedUpdate=!1),B.isSpriteMaterial&&oe.setValue(O,"center",G.center),oe.setValue(O,"modelViewMatrix",G.modelViewMatrix),oe.setValue(O,"normalMatrix",G.normalMatrix),oe.setValue(O,"modelMatrix",G.matrixWorld),B.uniformsGroups!==void 0){let Ce=B.uniformsGroups;for(let We=0,ji=Ce.length;We<ji;We++){let Hd=Ce[We];It.update(Hd,Qe),It.bind(Hd,Qe)}}return Qe}function Dg(S,L){S.ambientLightColor.needsUpdate=L,S.lightProbe.needsUpdate=L,S.sunLights.needsUpdate=L,S.sunLightShadows.needsUpdate=L,S.directionalLights.needsUpdate=L,S.directionalLightShadows.needsUpdate=L,S.pointLights.needsUpdate=L,S.pointLightShadows.needsUpdate=L,S.spotLights.needsUpdate=L,S.spotLightShadows.needsUpdate=L,S.rectAreaLights.needsUpdate=L,S.hemisphereLights.needsUpdate=L}function Og(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return nt},this.setRenderTargetTextures=function(S,L,H){let B=Ut.get(S);B.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,B.__autoAllocateDepthBuffer===!1&&(B.__useRenderToTexture=!1),Ut.get(S.texture).__webglTexture=L,Ut.get(S.depthTexture).__webglTexture=B.__autoAllocateDepthBuffer?void 0:H,B.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,L){let H=Ut.get(S);H.__webglFramebuffer=L,H.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(S,L=0,H=0){nt=S,W=L,V=H;let B=null,G=!1,gt=!1;if(S){let ft=Ut.get(S);if(ft.__useDefaultFramebuffer!==void 0){pt.bindFramebuffer(O.FRAMEBUFFER,ft.__webglFramebuffer),et.copy(S.viewport),wt.copy(S.scissor),kt=S.scissorTest,pt.viewport(et),pt.scissor(wt),pt.setScissorTest(kt),$=-1;return}else if(ft.__webglFramebuffer===void 0)Vt.setupRenderTarget(S);else if(ft.__hasExternalTextures)Vt.rebindTextures(S,Ut.get(S.texture).__webglTexture,Ut.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let Xt=S.depthTexture;if(ft.__boundDepthTexture!==Xt){if(Xt!==null&&Ut.has(Xt)&&(S.width!==Xt.image.width||S.height!==Xt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Vt.setupDepthRenderbuffer(S)}}let Mt=S.texture;(Mt.isData3DTexture||Mt.isDataArrayTexture||Mt.isCompressedArrayTexture)&&(gt=!0);let Rt=Ut.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Rt[L])?B=Rt[L][H]:B=Rt[L],G=!0):S.samples>0&&Vt.useMultisampledRTT(S)===!1?B=Ut.get(S).__webglMultisampledFramebuffer:Array.isArray(Rt)?B=Rt[H]:B=Rt,et.copy(S.viewport),wt.copy(S.scissor),kt=S.scissorTest}else et.copy(Bt).multiplyScalar(vt).floor(),wt.copy(Jt).multiplyScalar(vt).floor(),kt=ee;if(H!==0&&(B=X),pt.bindFramebuffer(O.FRAMEBUFFER,B)&&pt.drawBuffers(S,B),pt.viewport(et),pt.scissor(wt),pt.setScissorTest(kt),G){let ft=Ut.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+L,ft.__webglTexture,H)}else if(gt){let ft=L;for(let Mt=0;Mt<S.textures.length;Mt++){let Rt=Ut.get(S.textures[Mt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Mt,Rt.__webglTexture,H,ft)}}else if(S!==null&&H!==0){let ft=Ut.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ft.__webglTexture,H)}$=-1};function Vd(S){let L=Ut.get(S);return(L.__readFormat!==S.format||L.__readType!==S.type)&&(L.__readFormat=S.format,L.__readType=S.type,L.__formatReadable=_e.textureFormatReadable(S.format),L.__typeReadable=_e.textureTypeReadable(S.type)),L}this.readRenderTargetPixels=function(S,L,H,B,G,gt,Et,ft=0){if(!(S&&S.isWebGLRenderTarget)){zt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Mt=Ut.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Et!==void 0&&(Mt=Mt[Et],Array.isArray(Mt)&&(Mt=Mt[0])),Mt){pt.bindFramebuffer(O.FRAMEBUFFER,Mt);try{let Rt=S.textures[ft],Xt=Rt.format,se=Rt.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ft);let At=Vd(Rt);if(At.__formatReadable===!1){zt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(At.__typeReadable===!1){zt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=S.width-B&&H>=0&&H<=S.height-G&&O.readPixels(L,H,B,G,at.convert(Xt),at.convert(se),gt)}finally{let Rt=nt!==null?Ut.get(nt).__webglFramebuffer:null;pt.bindFramebuffer(O.FRAMEBUFFER,Rt)}}},this.readRenderTargetPixelsAsync=async function(S,L,H,B,G,gt,Et,ft=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Mt=Ut.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Et!==void 0&&(Mt=Mt[Et],Array.isArray(Mt)&&(Mt=Mt[0])),Mt)if(L>=0&&L<=S.width-B&&H>=0&&H<=S.height-G){pt.bindFramebuffer(O.FRAMEBUFFER,Mt);let Rt=S.textures[ft],Xt=Rt.format,se=Rt.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ft);let At=Vd(Rt);if(At.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(At.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let re=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,re),O.bufferData(O.PIXEL_PACK_BUFFER,gt.byteLength,O.STREAM_READ),O.readPixels(L,H,B,G,at.convert(Xt),at.convert(se),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Oe=nt!==null?Ut.get(nt).__webglFramebuffer:null;pt.bindFramebuffer(O.FRAMEBUFFER,Oe);let ye=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await yp(O,ye,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,re),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,gt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(re),O.deleteSync(ye),gt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,L=null,H=0){let B=Math.pow(2,-H),G=Math.floor(S.image.width*B),gt=Math.floor(S.image.height*B),Et=L!==null?L.x:0,ft=L!==null?L.y:0;Vt.setTexture2D(S,0),O.copyTexSubImage2D(O.TEXTURE_2D,H,0,0,Et,ft,G,gt),pt.unbindTexture()},this.copyTextureToTexture=function(S,L,H=null,B=null,G=0,gt=0){let Et,ft,Mt,Rt,Xt,se,At,re,Oe,ye=S.isCompressedTexture?S.mipmaps[gt]:S.image;if(H!==null)Et=H.max.x-H.min.x,ft=H.max.y-H.min.y,Mt=H.isBox3?H.max.z-H.min.z:1,Rt=H.min.x,Xt=H.min.y,se=H.isBox3?H.min.z:0;else{let oe=Math.pow(2,-G);Et=Math.floor(ye.width*oe),ft=Math.floor(ye.height*oe),S.isDataArrayTexture?Mt=ye.depth:S.isData3DTexture?Mt=Math.floor(ye.depth*oe):Mt=1,Rt=0,Xt=0,se=0}B!==null?(At=B.x,re=B.y,Oe=B.z):(At=0,re=0,Oe=0);let ve=at.convert(L.format),Je=at.convert(L.type),Ct;L.isData3DTexture?(Vt.setTexture3D(L,0),Ct=O.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(Vt.setTexture2DArray(L,0),Ct=O.TEXTURE_2D_ARRAY):(Vt.setTexture2D(L,0),Ct=O.TEXTURE_2D),pt.activeTexture(O.TEXTURE0),pt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,L.flipY),pt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),pt.pixelStorei(O.UNPACK_ALIGNMENT,L.unpackAlignment);let si=pt.getParameter(O.UNPACK_ROW_LENGTH),he=pt.getParameter(O.UNPACK_IMAGE_HEIGHT),Fn=pt.getParameter(O.UNPACK_SKIP_PIXELS),Qe=pt.getParameter(O.UNPACK_SKIP_ROWS),Pa=pt.getParameter(O.UNPACK_SKIP_IMAGES);pt.pixelStorei(O.UNPACK_ROW_LENGTH,ye.width),pt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,ye.height),pt.pixelStorei(O.UNPACK_SKIP_PIXELS,Rt),pt.pixelStorei(O.UNPACK_SKIP_ROWS,Xt),pt.pixelStorei(O.UNPACK_SKIP_IMAGES,se);let xn=S.isDataArrayTexture||S.isData3DTexture,kn=L.isDataArrayTexture||L.isData3DTexture;if(S.isDepthTexture){let oe=Ut.get(S),Ye=Ut.get(L),Ai=Ut.get(oe.__renderTarget),Ce=Ut.get(Ye.__renderTarget);pt.bindFramebuffer(O.READ_FRAMEBUFFER,Ai.__webglFramebuffer),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ce.__webglFramebuffer);for(let We=0;We<Mt;We++)xn&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ut.get(S).__webglTexture,G,se+We),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ut.get(L).__webglTexture,gt,Oe+We)),O.blitFramebuffer(Rt,Xt,Rt+Et,Xt+ft,At,re,At+Et,re+ft,O.DEPTH_BUFFER_BIT,O.NEAREST);pt.bindFramebuffer(O.READ_FRAMEBUFFER,null),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(G!==0||S.isRenderTargetTexture||Ut.has(S)){let oe=Ut.get(S),Ye=Ut.get(L);pt.bindFramebuffer(O.READ_FRAMEBUFFER,R),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,k);for(let Ai=0;Ai<Mt;Ai++)xn?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,oe.__webglTexture,G,se+Ai):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,oe.__webglTexture,G),kn?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ye.__webglTexture,gt,Oe+Ai):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ye.__webglTexture,gt),G!==0?O.blitFramebuffer(Rt,Xt,Rt+Et,Xt+ft,At,re,At+Et,re+ft,O.COLOR_BUFFER_BIT,O.NEAREST):kn?O.copyTexSubImage3D(Ct,gt,At,re,Oe+Ai,Rt,Xt,Et,ft):O.copyTexSubImage2D(Ct,gt,At,re,Rt,Xt,Et,ft);pt.bindFramebuffer(O.READ_FRAMEBUFFER,null),pt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else kn?S.isDataTexture||S.isData3DTexture?O.texSubImage3D(Ct,gt,At,re,Oe,Et,ft,Mt,ve,Je,ye.data):L.isCompressedArrayTexture?O.compressedTexSubImage3D(Ct,gt,At,re,Oe,Et,ft,Mt,ve,ye.data):O.texSubImage3D(Ct,gt,At,re,Oe,Et,ft,Mt,ve,Je,ye):S.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,gt,At,re,Et,ft,ve,Je,ye.data):S.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,gt,At,re,ye.width,ye.height,ve,ye.data):O.texSubImage2D(O.TEXTURE_2D,gt,At,re,Et,ft,ve,Je,ye);pt.pixelStorei(O.UNPACK_ROW_LENGTH,si),pt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,he),pt.pixelStorei(O.UNPACK_SKIP_PIXELS,Fn),pt.pixelStorei(O.UNPACK_SKIP_ROWS,Qe),pt.pixelStorei(O.UNPACK_SKIP_IMAGES,Pa),gt===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&O.generateMipmap(Ct),pt.unbindTexture()},this.initRenderTarget=function(S){Ut.get(S).__webglFramebuffer===void 0&&Vt.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Vt.setTextureCube(S,0):S.isData3DTexture?Vt.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Vt.setTexture2DArray(S,0):Vt.setTexture2D(S,0),pt.unbindTexture()},this.resetState=function(){W=0,V=0,nt=null,pt.reset(),ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ae._getDrawingBufferColorSpace(t),e.unpackColorSpace=ae._getUnpackColorSpace()}};var Jl=class{constructor(t){this.scene=t;let{beam_member:e,beam_along:i}=t.arrays;this.row=new Map(e?[...e.data].map((s,r)=>[s,r]):[]),this.places=i?i.shape[1]:0,this.several=i?i.shape[2]:0}points(t,e){let{ends:i}=this.scene;return this.row.has(e)?this.combined("beam_along",t,this.row.get(e)):[t[i[2*e]],t[i[2*e+1]]]}across(t,e){return this.combined("beam_across",t,this.row.get(e))}combined(t,e,i){let{scene:{arrays:s},places:r,several:a}=this,{data:o}=s[t];return Array.from({length:r},(l,c)=>{let h=[0,0,0];for(let u=0;u<a;u++){let d=o[(i*r+c)*a+u],f=e[s.beam_nodes.data[i*a+u]];for(let p=0;p<3;p++)h[p]+=d*f[p]}return h})}};function Ti(n){return n.slice(1).map((t,e)=>[n[e],t])}var Xb=3e4,$b=n=>[1,3,5].map(t=>parseInt(n.slice(t,t+2),16)),Ql=class{constructor(t){this.scene=t,this.corners=t.skin;let e=t.faces,i=new Me;for(let a of["position","color"])i.setAttribute(a,new Ne(new Float32Array(9*e),3));let s=new ci({vertexColors:!0,side:ii,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});this.mesh=new Pe(i,s),this.mesh.visible=e>0,this.edges=_a(this.corners);let r=new Me;r.setAttribute("position",new Ne(new Float32Array(3*this.edges.length),3)),this.lines=new Si(r,new li({transparent:!0,opacity:.35}));for(let a of this.objects())a.frustumCulled=!1}objects(){return[this.mesh,this.lines]}setTheme(t){this.lines.material.color.set(Xe[t].edge)}place(t){let{mesh:e,lines:i}=this;if(!e.visible)return;let s=e.geometry.attributes.position,r=i.geometry.attributes.position;this.corners.forEach((a,o)=>s.array.set(t[a],3*o)),this.edges.forEach((a,o)=>r.array.set(t[a],3*o)),s.needsUpdate=r.needsUpdate=!0,e.geometry.computeVertexNormals()}paint(t,e,i){let{scene:s,mesh:r}=this;if(!r.visible)return;let a=t&&s.coloursFaces(t.id),o=new Nt,{array:l}=r.geometry.attributes.color;for(let c=0;c<s.faces;c++){let h=s.header.skins[s.arrays.skin_part.data[c]].kind,[u,d,f]=a?vn(t.scale,s.faceValue(t.id,e,c),i):$b(La[h]||hs);o.setRGB(u/255,d/255,f/255,"srgb");for(let p=0;p<3;p++)o.toArray(l,9*c+3*p)}r.geometry.attributes.color.needsUpdate=!0}colourOf(t){let{r:e,g:i,b:s}=new Nt().fromArray(this.mesh.geometry.attributes.color.array,9*t).getRGB({r:0,g:0,b:0},"srgb");return[e,i,s].map(r=>Math.round(255*r))}};function _a(n){let t=new Map;for(let e=0;e<n.length;e+=3)for(let i=0;i<3;i++){let s=n[e+i],r=n[e+(i+1)%3];t.set(s<r?`${s} ${r}`:`${r} ${s}`,[s,r])}return t.size>Xb?[]:[...t.values()].flat()}var qb=new I(0,1,0);function tc(n,t,e="#ffffff"){let i=new Hi(n,new ci({color:e}),Math.max(t,1));return i.count=t,i.instanceMatrix.setUsage(Iu),i.frustumCulled=!1,i}function rs(n,t){return tc(new ln(1,1,1,t,1,!1),n)}function cm(n){return tc(new En(2,1,2),n)}function ec(n,t,e){return tc(new Kn(1,t),n,e)}function hm(n,t,e){return tc(new Gs(1,1,t),n,e)}function Ei(n,t,e,i,s){let r=n.instanceMatrix.array,a=16*t,o=i[0]-e[0],l=i[1]-e[1],c=i[2]-e[2],h=Math.hypot(o,l,c)||1e-12,u=o/h,d=l/h,f=c/h,p=0,v=-f,m=d;Math.abs(u)>.7&&([p,v,m]=[f,0,-u]);let g=s/(Math.hypot(p,v,m)||1);p*=g,v*=g,m*=g,r[a]=p,r[a+1]=v,r[a+2]=m,r[a+3]=0,r[a+4]=o,r[a+5]=l,r[a+6]=c,r[a+7]=0,r[a+8]=v*f-m*d,r[a+9]=m*u-p*f,r[a+10]=p*d-v*u,r[a+11]=0,r[a+12]=(e[0]+i[0])/2,r[a+13]=(e[1]+i[1])/2,r[a+14]=(e[2]+i[2])/2,r[a+15]=1}function um(n,t,e,i,s,[r,a]){let o=n.instanceMatrix.array,l=16*t,c=[i[0]-e[0],i[1]-e[1],i[2]-e[2]],h=Math.hypot(...c)||1e-12,u=c.map(m=>m/h),d=u[0]*s[0]+u[1]*s[1]+u[2]*s[2],f=s.map((m,g)=>m-d*u[g]),p=Math.hypot(...f)||1;f=f.map(m=>m/p);let v=[f[1]*u[2]-f[2]*u[1],f[2]*u[0]-f[0]*u[2],f[0]*u[1]-f[1]*u[0]];for(let m=0;m<3;m++)o[l+m]=r*f[m],o[l+4+m]=c[m],o[l+8+m]=a*v[m],o[l+12+m]=(e[m]+i[m])/2;o[l+3]=o[l+7]=o[l+11]=0,o[l+15]=1}function Qs(n,t,e,i){let s=n.instanceMatrix.array,r=16*t;s.fill(0,r,r+16),s[r]=s[r+5]=s[r+10]=i,s[r+12]=e[0],s[r+13]=e[1],s[r+14]=e[2],s[r+15]=1}function Nn(n){n.instanceMatrix.needsUpdate=!0}function va(n){let t=new Fe,e=new ci({color:n}),i=new Pe(new ln(1,1,1,12),e),s=new Pe(new Gs(1,1,16),e);return t.add(i,s),t}function tr(n,t,e,i){let s=Math.hypot(...e);if(n.visible=s>2*i,!n.visible)return;let[r,a]=n.children,o=Math.min(5*i,s/2);r.scale.set(i,s-o,i),r.position.y=(s-o)/2,a.scale.set(2.4*i,o,2.4*i),a.position.y=s-o/2,n.position.set(...t),n.quaternion.copy(new je().setFromUnitVectors(qb,new I(...e).normalize()))}function dm(n,t){return new Pe(new Qr(n,n/5,10,32),new ci({color:t}))}function ic({length0:n,extent:t}){return Math.max(.1*n,.04*t.size)}function as({kind:n,along:t},e,i){let[s,r]=Yb(n,t);return Zd[n].map(a=>a.map(([o,l])=>e.map((c,h)=>c+i*(o*s[h]+l*r[h]))))}function Yb(n,t){if(!t.some(Boolean))return[[1,0,0],[0,0,1]];let e=Math.hypot(t[0],t[1]),i=e>1e-9?[t[1]/e,-t[0]/e,0]:[1,0,0];return[i,n.startsWith("turn")?Zb(t,i):t]}function Zb(n,t){return[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]]}var fm=hi.driven,jb="#3f4a55",nc=.3,Kb={x:[1,0,0],y:[0,1,0],z:[0,0,1]},sc=class{constructor(t){Object.assign(this,{scene:t,size:ic(t)}),this.marks=t.header.support_marks,this.pointed=this.marks.filter(({kind:i})=>pm(i));let e=this.marks.reduce((i,s)=>i+this.rodsOf(s,[0,0,0]).length,0);this.cones=hm(this.pointed.length,4,"#ffffff"),this.rods=rs(e,6),this.mesh=new Fe,this.mesh.add(this.cones,this.rods)}rodsOf(t,e){return as(t,e,this.size).filter((i,s)=>s>0||!pm(t.kind)).flatMap(Ti)}feet(t){return this.marks.map(({node:e,along:i})=>this.scene.position(t,e).map((s,r)=>s-this.size*i[r]))}setTheme({support:t}){for(let e of this.mesh.children)e.material.color.set(t)}place(t){this.pointed.forEach((e,i)=>{let[[s,r,a]]=as(e,t[e.node],this.size);Ei(this.cones,i,r.map((o,l)=>(o+a[l])/2),s,.5*this.size)}),this.marks.flatMap(e=>this.rodsOf(e,t[e.node])).forEach(([e,i],s)=>Ei(this.rods,s,e,i,.045*this.size)),Nn(this.cones),Nn(this.rods)}},pm=n=>n==="pin"||n==="roller",ya=class{constructor(t,e){this.scene=t,this.radius=.1*e,this.group=new Fe,this.shown=t.header.loads.map((s,r)=>({...s,k:r})).filter(s=>s.drawn!==!1),this.arrows=this.shown.map(()=>va(cr));for(let s of this.arrows)this.group.add(s);let i=0;if(t.has("load_force")){let{data:s}=t.arrays.load_force;for(let r=0;r<s.length;r+=t.dim)i=Math.max(i,Math.hypot(...s.slice(r,r+t.dim)))}this.factor=i?.16*t.extent.size/i:0}tips(t){return this.shown.map(e=>{let i=this.scene.vector("load_force",t,e.k),s=(e.pressure?nc:1)*this.factor;return this.scene.placeOfLoad(e,r=>this.scene.position(t,r)).map((r,a)=>e.at?r-s*i[a]:r+s*i[a])})}place(t,e){this.shown.forEach((i,s)=>{let r=i.pressure?nc:1,a=this.scene.vector("load_force",e,i.k).map(l=>r*l*this.factor),o=this.scene.placeOfLoad(i,l=>t[l]);tr(this.arrows[s],i.at?o.map((l,c)=>l-a[c]):o,a,r*this.radius)})}},rc=class{constructor(t,e){this.scene=t,this.size=e,this.group=new Fe,this.shown=t.header.drives.filter(i=>i.kind!=="length").map(i=>{let s=i.kind==="coordinate"?va(fm):dm(.75*e,fm);return this.group.add(s),{drive:i,mark:s}})}place(t){for(let{drive:e,mark:i}of this.shown)e.kind==="angle"?mm(i,t[this.scene.ends[2*e.member]],e.about):e.kind==="hinge"?mm(i,...Jb(e.axis.map(s=>t[s]))):tr(i,t[e.node],Kb[e.axis].map(s=>2.5*this.size*s),.15*this.size)}};function Jb([n,t]){return t?[n.map((e,i)=>(e+t[i])/2),t.map((e,i)=>e-n[i])]:[n,[0,0,1]]}function mm(n,t,e=[0,0,1]){n.position.set(...t),n.quaternion.setFromUnitVectors(new I(0,0,1),new I(...e).normalize())}var ac=class{constructor(t,e,i){this.scene=t,this.triangles=e;let s=new Me;s.setAttribute("position",new Ne(new Float32Array(9*e.length),3));let r=new ci({color:"#7f93a8",side:ii,transparent:!0,opacity:i,depthWrite:!1});this.mesh=new Pe(s,r),this.mesh.frustumCulled=!1}place(t){let{array:e}=this.mesh.geometry.attributes.position;this.triangles.forEach((i,s)=>{i.forEach((r,a)=>e.set(t[r],9*s+3*a))}),this.mesh.geometry.attributes.position.needsUpdate=!0,this.mesh.geometry.computeVertexNormals()}};function Qu(n,{member:t,center:e},i){let s=i[n.ends[2*t]],r=i[n.ends[2*t+1]],a=Math.hypot(r[0]-s[0],r[1]-s[1])||1,o=[(r[0]-s[0])/a,(r[1]-s[1])/a];return[s,r,[s[0]+e[0]*o[0]-e[1]*o[1],s[1]+e[0]*o[1]+e[1]*o[0],0]]}var oc=class{constructor(t,e){this.scene=t,this.size=e,this.mesh=ec(t.header.bodies.length,2,jb)}place(t){this.scene.header.bodies.forEach((e,i)=>Qs(this.mesh,i,Qu(this.scene,e,t)[2],this.size)),Nn(this.mesh)}};function gm(n){let{low:t,high:e,centre:i,size:s}=n.extent,r=Gn(s/8),a=Math.max(4,Math.ceil(.75*s/r)),o=new sa(2*a*r,2*a,"#8a949e","#8a949e");o.material.transparent=!0,o.material.opacity=.35;let l=c=>Math.round(c/r)*r;return n.dim===2?(o.rotation.x=Math.PI/2,o.position.set(l(i[0]),l(i[1]),-.08*n.length0)):(o.quaternion.copy(new je().setFromUnitVectors(new I(0,1,0),new I(0,0,1))),o.position.set(l(i[0]),l(i[1]),t[2]-.03*(e[2]-t[2]||s))),{grid:o,step:r}}function xm(n){let t=n.nodes.map((r,a)=>n.position(0,a)),i=[...n.members.flatMap((r,a)=>n.shows(a)?Ti(n.curves.points(t,a)).flat():[]),..._a(n.skin).map(r=>t[r])].flat(),s=new Si(td(i),new li({color:"#8a949e",transparent:!0,opacity:.8}));return s.frustumCulled=!1,s}function td(n){let t=new Me;return t.setAttribute("position",new Ne(new Float32Array(n),3)),t}var Qb=9,tM=22,lc={corner:[.72,-1,.42],front:[0,-1,0],side:[1,0,0],top:[0,-1e-4,1],plane:[0,0,1]},er=class{constructor(t,e){Object.assign(this,{canvas:t,scene:e,frame:0,channel:null,limits:[0,1],picked:null})}points(){let{scene:t,frame:e,mode:i}=this;return t.nodes.map((s,r)=>{let a=t.position(e,r);if(!i)return a;let o=t.arrays[i.array].data,l=r*t.dim;for(let c=0;c<t.dim;c++)a[c]+=i.size*o[l+c];return a})}setFrame(t){this.frame=t,this.move(),this.paint()}setColours(t,e){Object.assign(this,{channel:t,limits:e}),this.paint()}get plain(){return!this.channel||!this.scene.channel(this.channel.id)}shade(t){let{scene:e,channel:i,frame:s,limits:r}=this;return this.plain?ds(hi[e.header.kinds[t]]):vn(i.scale,e.value(i.id,s,t),r)}hatched(t){let{scene:e,channel:i,frame:s}=this;return!this.plain&&i.id!=="speed"&&(e.unsure.has(t)||Number.isNaN(e.value(i.id,s,t)))}request(){this.waiting||=requestAnimationFrame(()=>this.render())}along(t,e){let{curves:i,ends:s}=this.scene;return i.row.has(t)?i.points(this.now,t).map(r=>this.project(r)):[e[s[2*t]],e[s[2*t+1]]]}pickAt(t,e,i=!1){let s=this.now.map(l=>this.project(l)),r=i?tM:Qb,a=null,o=(l,c,h,u,d)=>{let f=u+1e-4*h-d;h<=r&&u<1&&(!a||f<a.far)&&(a={type:l,index:c,far:f})};return this.scene.members.forEach((l,c)=>{if(this.scene.shows(c))for(let[h,u]of Ti(this.along(c,s))){let[d,f]=[u[0]-h[0],u[1]-h[1]],p=Math.min(1,Math.max(0,((t-h[0])*d+(e-h[1])*f)/(d*d+f*f||1)));o("member",c,Math.hypot(h[0]+p*d-t,h[1]+p*f-e),h[2]+p*(u[2]-h[2]),0)}}),s.forEach((l,c)=>this.scene.directors.has(c)||o("node",c,Math.hypot(l[0]-t,l[1]-e),l[2],.002)),a&&{type:a.type,index:a.index}}};var ir=class{constructor(t){this.scene=t,this.group=new Fe,this.lines=new Map,this.material=new li({})}setTheme({ink:t}){this.material.color.set(t)}show(t){for(let[e,i]of this.lines)i.visible=t.has(e);for(let e of t)this.lines.has(e)||this.add(e)}add(t){let{scene:e}=this,i=new zs(td(Array.from({length:e.frames},(s,r)=>e.position(r,t)).flat()),this.material);i.frustumCulled=!1,this.lines.set(t,i),this.group.add(i)}get shown(){return[...this.lines].filter(([,t])=>t.visible).map(([t])=>t)}};function _m(n){let t=new Set([...n.header.supports.map(i=>i.node),...n.skin,...n.directors]),e=[];for(let i=0;i<n.nodes.length;i++){if(t.has(i))continue;let s=n.position(0,i);for(let r=1;r<n.frames;r++)if(Math.hypot(...n.position(r,i).map((o,l)=>o-s[l]))>1e-4*n.extent.size){e.push(i);break}}return e}var cc=()=>({visible:!0}),uc=class extends er{constructor(t,e,i){super(t,e),this.step=Gn(e.extent.size/8),this.traces=new ir(e),Object.assign(this,{ghost:{visible:!1},grid:cc(),loads:{group:cc()},supports:{mesh:cc()},faces:{mesh:cc()}}),this.controls={update(){}},this.setTheme(i),this.aim(e.dim===2?"plane":"corner"),this.setFrame(0)}setTheme(t){this.colours=Xe[t],this.request()}move(){this.now=this.points(),this.request()}paint(){this.request()}pick(t){this.picked=t,this.request()}showTraces(t){this.paths=t,this.request()}rebuildLoads(){this.request()}aim(t){this.preset=t;let e=lc[t],i=Math.hypot(...e),s=e.map(a=>a/i),r=Math.abs(s[2])>.99?[0,1,0]:[0,0,1];this.turn(s,r),this.zoom=1}turn(t,e){let i=[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],s=Math.hypot(...i)||1,r=i.map(a=>a/s);this.axes=[r,[t[1]*r[2]-t[2]*r[1],t[2]*r[0]-t[0]*r[2],t[0]*r[1]-t[1]*r[0]],t],this.request()}orbit(t,e,i){let[,,s]=this.axes,r=Math.hypot(s[0],s[1])||1e-6,a=Math.atan2(s[1],s[0])+t,o=Math.min(Math.max(Math.atan2(s[2],r)+e,-1.5),1.5);(t||e)&&this.turn([Math.cos(a)*Math.cos(o),Math.sin(a)*Math.cos(o),Math.sin(o)],[0,0,1]),this.zoom/=i,this.request(),this.onCamera?.(this)}copyCamera(t){t.axes&&Object.assign(this,{axes:t.axes,zoom:t.zoom}),this.request()}resize(){this.request()}end(){this.ended=!0}project(t){let{clientWidth:e,clientHeight:i}=this.canvas,{centre:s,size:r}=this.scene.extent,[a,o,l]=this.axes.map(h=>h.reduce((u,d,f)=>u+d*(t[f]-s[f]),0)),c=.86*this.zoom*Math.min(e,i)/r;return[e/2+c*a,i/2-c*o,.5-l/(4*r)]}render(){cancelAnimationFrame(this.waiting),this.waiting=0;let{clientWidth:t,clientHeight:e}=this.canvas,i=window.devicePixelRatio||1;if(this.ended||!t||!e)return;this.canvas.width=Math.round(t*i),this.canvas.height=Math.round(e*i);let s=this.canvas.getContext("2d"),{scene:r,colours:a}=this;s.scale(i,i),s.fillStyle=a.back,s.fillRect(0,0,t,e),s.lineCap="round";let o=this.now.map(l=>this.project(l));this.ghost.visible&&this.bars(s,r.nodes.map((l,c)=>r.position(0,c)),()=>a.grid,1);for(let l of this.paths||[])hc(s,Array.from({length:r.frames},(c,h)=>this.project(r.position(h,l))),a.ink,1);this.skins(s,o),this.bars(s,this.now,()=>a.outline,6),this.bars(s,this.now,l=>`rgb(${this.shade(l).join(" ")})`,4),this.bars(s,this.now,l=>this.hatched(l)?a.back:null,4,[3,6]),this.bars(s,this.now,l=>this.picked?.type==="member"&&this.picked.index===l?"#ffb000":null,3),this.marks(s,o),this.drawn=(this.drawn||0)+1,this.onDrawn?.(this)}skins(t,e){let{scene:i,channel:s,frame:r,limits:a,colours:o}=this,l=s&&i.coloursFaces(s.id),c=d=>l?`rgb(${vn(s.scale,i.faceValue(s.id,r,d),a).join(" ")})`:o.body,h=Array.from({length:i.faces},(d,f)=>({corners:[...i.skin.slice(3*f,3*f+3)].map(p=>e[p]),fill:c(f)}));h.push(...(i.header.solids||[]).map(d=>({corners:d.map(f=>e[f]),fill:o.body})));for(let d of i.header.bodies)h.push({corners:Qu(i,d,this.now).map(f=>this.project(f)),fill:o.body});let u=({corners:d})=>d.reduce((f,p)=>f+p[2],0)/d.length;t.strokeStyle=o.edge,t.lineWidth=.3,t.lineJoin="round";for(let{corners:d,fill:f}of h.sort((p,v)=>u(v)-u(p))){t.beginPath();for(let[p,v]of d)t.lineTo(p,v);t.closePath(),t.fillStyle=f,t.fill(),t.stroke()}}bars(t,e,i,s,r=[]){let{scene:a}=this;a.members.forEach((o,l)=>{let c=a.shows(l)&&i(l);c&&hc(t,a.curves.points(e,l).map(h=>this.project(h)),c,s,r)})}marks(t,e){let{scene:i,colours:s}=this,r=([a,o],l,c)=>{t.beginPath(),t.arc(a,o,l,0,7),t.fillStyle=c,t.fill()};if(this.supports.mesh.visible)for(let a of i.header.support_marks)for(let o of as(a,this.now[a.node],ic(i)))hc(t,o.map(l=>this.project(l)),s.support,1.5);i.members.length<800&&e.forEach((a,o)=>!i.directors.has(o)&&r(a,this.picked?.type==="node"&&this.picked.index===o?6:3,s.node));for(let a of i.header.drives){let o=a.kind==="coordinate"?a.node:a.kind==="hinge"?a.axis[0]:i.ends[2*a.member];r(a.kind==="length"?eM(e,i,a.member):e[o],5,hi.driven)}this.loads.group.visible&&i.has("load_force")&&this.arrows(t)}arrows(t){let{scene:e,frame:i}=this,s=e.header.loads.map((a,o)=>Math.hypot(...e.vector("load_force",i,o))),r=Math.max(...s,1e-30);e.header.loads.forEach((a,o)=>{if(a.drawn===!1||s[o]<.001*r)return;let l=e.vector("load_force",i,o),c=e.placeOfLoad(a,p=>this.now[p]),h=(a.pressure?nc:1)*.16*e.extent.size,u=a.at?c.map((p,v)=>p-h*l[v]/r):c,[d,f]=[u,u.map((p,v)=>p+h*l[v]/r)].map(p=>this.project(p));hc(t,[d,f],cr,2),t.fillStyle=cr,t.fillRect(f[0]-3,f[1]-3,6,6)})}};function eM(n,t,e){let[i,s]=[n[t.ends[2*e]],n[t.ends[2*e+1]]];return[(i[0]+s[0])/2,(i[1]+s[1])/2]}function hc(n,t,e,i,s=[]){n.strokeStyle=e,n.lineWidth=i,n.setLineDash(s),n.beginPath();for(let[r,a]of t)n.lineTo(r,a);n.stroke(),n.setLineDash([])}var fc=320,Ma=160,ba=66,dc=254,nr=62,iM={F_A:"var(--pen-1)",F_B:"var(--pen-1)","m g":"var(--pen-3)","m a":"var(--pen-2)",T:"var(--pen-3)",Q:"var(--pen-3)",P:"var(--pen-3)",B:"var(--pen-3)"};function vm(n,t){let e=Math.max(...t.terms.map(h=>Math.hypot(...h.force)))||1,i=h=>Math.max(...t.terms.map(u=>Math.abs(u.force[h]))),s=i(2)>i(1)?2:1,r=i(s),a=38/e,o=r>.02*e?a:Math.min(a*20,r?26/r:a),l=h=>ba+h/t.state.L*(dc-ba),c=Ht("svg",{viewBox:`0 0 ${fc} ${Ma}`,role:"img","aria-label":"free body of the member"});c.append(Ht("line",{x1:ba,y1:nr,x2:dc,y2:nr,class:"rod"}),...[ba,dc].map(h=>Ht("circle",{cx:h,cy:nr,r:4,class:"joint"})),ed(ba,Ma-24,`end A: ${n.nodes[t.state.A]}`),ed(dc,Ma-24,`end B: ${n.nodes[t.state.B]}`),ed(fc/2,Ma-7,`plane 1–${s+1}${r>1e-6*e&&o>1.01*a?`, across × ${ue(o/a,2)}`:""}`,"faint"));for(let h of t.drives)c.append(...nM(h,t,l));t.couples.forEach((h,u)=>c.append(...sM(h,u,l)));for(let h of t.terms)rM(c,l(h.at),h,[h.force[0]*a,-h.force[s]*o]);return c}function nM(n,t,e){let i=t.state.rods[1],s=e(i?i.start:t.state.L/2);return[Ht("rect",{x:s-4,y:nr-7,width:8,height:14,rx:2,fill:"var(--pen-3)"}),...ym(`thrust of ${n.name}: ${$t(n.force,"N")}`,0)]}function sM(n,t,e){return[Ht("circle",{cx:e(n.at),cy:nr,r:10+3*t,fill:"none",stroke:"var(--pen-3)","stroke-width":3}),...ym(`couple of ${n.words}: ${$t(n.size,"N m")}`,t)]}function ym(n,t){return[Ht("text",{x:fc/2,y:12+12*t,"text-anchor":"middle",fill:"var(--pen-3)"},n)]}function ed(n,t,e,i=""){return Ht("text",{x:n,y:t,"text-anchor":"middle",class:i},e)}function rM(n,t,e,[i,s]){let r=Math.hypot(i,s);if(r<3)return;let a=e.symbol==="F_A"&&i>0||e.symbol==="F_B"&&i<0,o=nr+(e.inertia?10:0),[l,c]=a?[t-i,o-s]:[t,o],[h,u]=[l+i,c+s],d=i/r,f=s/r,p=Math.min(9,r),v=[[h,u],[h-p*d-.4*p*f,u-p*f+.4*p*d],[h-p*d+.4*p*f,u-p*f-.4*p*d]],m=iM[e.symbol],[g,M]=a?[l-14*d,c-12*f]:[h+14*d,u+12*f];n.append(Ht("line",{x1:l,y1:c,x2:h-.7*p*d,y2:u-.7*p*f,stroke:m,"stroke-width":2.4,"stroke-dasharray":e.inertia?"4 3":"none"}),Ht("polygon",{points:v.map(w=>w.join(",")).join(" "),fill:m}),Ht("text",{x:Math.min(fc-14,Math.max(14,g)),y:Math.min(Ma-36,Math.max(11,M+4.5)),"text-anchor":"middle",fill:m},e.symbol))}function bm(n,t){let e=Math.max(...t.terms.map(a=>Math.hypot(...a.force))),i=n.dim===3?[0,1,2]:[0,1],[s,r]=zn(t.terms.flatMap(a=>i.map(o=>Math.abs(a.force[o])<1e-6*e?0:a.force[o])),"N");return x("table",{class:"numbers"},x("thead",{},x("tr",{},x("th",{},`force (${r})`),i.map(a=>x("th",{},`along ${a+1}`)))),x("tbody",{},t.terms.map((a,o)=>x("tr",{title:a.words},x("th",{},a.symbol,x("small",{},` ${a.words}`)),i.map(l=>x("td",{},s[o*i.length+l])))),t.couples.map(a=>x("tr",{},x("th",{},"couple ",x("small",{},a.words)),x("td",{colspan:i.length},$t(a.size,"N m")))),t.drives.map(a=>x("tr",{},x("th",{},"drive ",x("small",{},a.name)),x("td",{colspan:i.length},$t(a.force,"N"))))))}function Sm(n,t,e,i,s,r){if(n===0)return Math.sqrt(aM(Math.abs(t),e,i,s,r));if(n===1)return Math.sqrt(lM(Math.abs(t),Math.abs(e),Math.abs(i),s,r));if(n===2){let a=Math.abs(t)+Math.abs(e)+Math.abs(i);return Math.sqrt(a*a+3*(s*s+r*r))}return NaN}function aM(n,t,e,i,s){let r=Math.hypot(t,e),a=3*(i*i+s*s);if(r===0||a===0)return(n+r)**2+a;let o=(s*t-i*e)/r,l=(i*t+s*e)/r,c=f=>(n+r*Math.cos(f))**2+3*(o*Math.sin(f)+l*Math.cos(f))**2,h=2*Math.PI/48,u=0,d=0;for(let f=0;f<48;f++)c(f*h)>u&&([u,d]=[c(f*h),f*h]);return Math.max(u,c(oM(c,d,h)))}function oM(n,t,e){let i=(Math.sqrt(5)-1)/2,s=t-e,r=t+e;for(let a=0;a<40;a++){let o=r-i*(r-s),l=s+i*(r-s);n(o)>n(l)?r=l:s=o}return(s+r)/2}function lM(n,t,e,i,s){let r=0;for(let a=0;a<4;a++){let o=a&1,l=a>>1;for(let h=0;h<20;h++)o=Mm(n+t*l,e,i),l=Mm(n+e*o,t,s);let c=(i*(1-o*o))**2+(s*(1-l*l))**2;r=Math.max(r,(n+e*o+t*l)**2+3*c)}return r}function Mm(n,t,e){let i=12*e*e;if(2*t*t>=i)return 1;let s=0;for(let r=0;r<60;r++){let a=i*s**3+(2*t*t-i)*s+2*n*t,o=3*i*s*s+2*t*t-i;if(a<=0)break;if(o>=0||s>=1)return 1;let l=-a/o;if(s+=l,l<1e-12)break}return s>=1?1:(n+t*s)**2+i/4*(1-s*s)**2>(n+t)**2?s:1}var Te=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],Ee=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],Gt=(n,t)=>[n*t[0],n*t[1],n*t[2]],nd=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],id=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],cM=n=>Gt(1/(Math.hypot(...n)||1),n);function Ea(n,t,e){let i=n.ends[2*e],s=n.ends[2*e+1],r=n.position(t,i),a=Ee(n.position(t,s),r),o=Math.hypot(...a),l=Gt(1/o,a);if(n.dim===2)return{A:i,B:s,L:o,xA:r,axes:[l,[-l[1],l[0],0],[0,0,1]]};let c=n.arrays.orient.data[e],h=c>=0?Ee(n.position(t,c),r):[...n.arrays.reference.data.slice(3*e,3*e+3)],u=id(l,h);if(nd(u,u)<=1e-18*nd(h,h)){let d=[0,1,2].reduce((f,p)=>Math.abs(l[p])<Math.abs(l[f])?p:f,0);u=id(l,[0,1,2].map(f=>f===d?1:0))}return u=cM(u),{A:i,B:s,L:o,xA:r,axes:[l,id(u,l),u]}}function Tm(n,t,e){let i=Ea(n,t,e),s=g=>i.axes.map(M=>nd(M,g)),r=[0,1,2].map(g=>n.header.gravity[g]||0),a=n.vector("acceleration",t,i.A),o=n.vector("acceleration",t,i.B),l=s(Ee(n.vector("velocity",t,i.B),n.vector("velocity",t,i.A))),c=s(Ee(a,r)),h=s(Ee(o,a)),u=i.L,d=[l[1]/u,l[2]/u],f=[-(d[0]**2+d[1]**2),(h[1]-2*l[0]*d[0])/u,(h[2]-2*l[0]*d[1])/u],p=uM(n,e,u),v=hM(n,t,e,u,s),m=dM(n,t,e,{...i,local:s,b:c,e:h,bend:f,rods:p,actions:v});return{...i,member:e,frame:t,gravity:r,local:s,b:c,e:h,bend:f,rods:p,actions:v,FA:m[0],FB:m[1],derived:m[2]}}function hM(n,t,e,i,s){return(n.header.actions||[]).flatMap((r,a)=>{if(r.member!==e)return[];let[o,l]=[0,1].map(d=>s(n.actionForce(t,a,d))),c=Te(o,l),h=r.spread?.5:n.number("action_place",t,a),u=Ee(l,Gt(h,c));return[{...r,fA:o,fB:l,force:c,place:h,couple:[0,-i*u[2],i*u[1]],whole:[0,-i*l[2],i*l[1]]}]})}function uM(n,t,e){let i=n.arrays.rods.data,s=6*t,r={mass:i[s],rotary:i[s+2],start:0,length:e,role:"bar",masses:[]};if(!n.active.has(t))return[r];let a=o=>(n.header.clamped||[]).filter(l=>l.rod===o);return[{...r,length:i[s+1],role:"base",masses:a(2*t)},{mass:i[s+3],rotary:i[s+5],start:e-i[s+4],length:i[s+4],role:"tube",masses:a(2*t+1)}]}function wa({first:n,change:t},e){return Gt(e.mass,Te(n,Gt(e.place,t)))}function mc(n,t){let{b:e,e:i,bend:s}=n;return t.role==="bar"?{first:e,change:i}:t.role==="base"?{first:e,change:Gt(t.length,s)}:{first:Ee(Te(e,i),Gt(t.length,s)),change:Gt(t.length,s)}}function dM(n,t,e,i){if(n.has("joint_force"))return[0,1].map(h=>i.local(n.jointForce(t,e,h))).concat(!1);let s=i.actions.filter(h=>h.mean).reduce((h,u)=>h-u.fA[0]+(1-u.place)*u.force[0],n.number("member_force",t,e)),r=[0,0,0],a=[0,0,0],o=i.rods.map(h=>{let u=mc(i,h),{first:d,change:f}=u,p=h.masses.reduce((g,M)=>Te(g,wa(u,M)),Gt(h.mass,Te(d,Gt(.5,f))));r=Te(r,p);let v=i.L-h.start,m=Te(Gt(v-h.length/2,d),Gt(v/2-h.length/3,f));a=Te(a,Ee(Gt(h.mass,m),Gt(h.rotary,i.bend)));for(let g of h.masses)a=Te(a,Gt(v-g.place*h.length,wa(u,g)));return{push:p,change:f,mass:h.mass}}),l=Gt(1/i.L,a);l[0]=i.rods.length===2?o[0].push[0]-s:o[0].mass*(i.b[0]/2+i.e[0]/6)-s;let c=h=>i.actions.reduce((u,d)=>Te(u,d[h]),[0,0,0]);return[Ee(l,c("fA")),Ee(Ee(r,l),c("fB")),!0]}function gc(n,t,e){let i=Tm(n,t,e),s=i.rods.map((r,a)=>{let{first:o,change:l}=mc(i,r),c=Gt(r.mass,o),h=Gt(r.mass/2,l),u=Gt(-1,i.FA),d=p=>i.actions.filter(v=>v.place===p).reduce((v,m)=>Te(v,m.couple),[0,0,0]),f;if(r.role==="bar")f=fM(i,r,c,h,u);else if(r.role==="tube")f=wm(i,r,r.masses,Ee(Ee(i.FB,c),h),c,h,d(1),0);else{let p=(i.L-i.rods[1].length)/r.length,v=u,m=Gt(-1,d(0));f=[];for(let M of r.masses.filter(w=>w.place<p)){let w=M.place,b=wa({first:o,change:l},M);w>0&&f.push(Ta(v,c,h,r,i.bend,m,!1,w)),v=Te(v,b),m=Te(m,[0,-r.length*b[2]*w,r.length*b[1]*w])}f.push({...Ta(v,c,h,r,i.bend,m,!1,p),nut:!0});let g=r.masses.filter(M=>M.place>=p);f.push(...wm(i,r,g,Ee(Gt(-1,c),h),c,h,[0,0,0],p))}return{part:n.partsOf[e][a],...r,pieces:f}});return s.length===2&&xM(i,s),{state:i,parts:s}}function wm(n,t,e,i,s,r,a,o){let l=mc(n,t),c=[],h=(u,d)=>[0,t.length*u[2]*(1-d),-t.length*u[1]*(1-d)];for(let u of e){let d=wa(l,u);i=Ee(i,d),a=Ee(a,h(d,u.place))}for(let u of e){let d=u.place,f=wa(l,u);d>o&&c.push(Ta(i,s,r,t,n.bend,a,!0,d)),i=Te(i,f),a=Te(a,h(f,d))}return c.push(Ta(i,s,r,t,n.bend,a,!0,2)),c}function fM(n,t,e,i,s){let r=n.actions.flatMap(({spread:o,place:l})=>o?[o.begin,o.end]:[l]),a=[...new Set(r.filter(o=>o>0&&o<1))].sort((o,l)=>o-l);return[...a,2].map((o,l)=>{let c=l?a[l-1]:0,h=Ta(s,e,i,t,n.bend,[0,0,0],!1,o);for(let u of n.actions)u.spread?u.spread.end<=c?Sa(h,t,gM(u)):u.spread.begin<=c&&Sa(h,t,pc(u,0,1)):u.place<=c&&u.place<1&&Sa(h,t,pM(u));return h})}var pM=({force:n,place:t,couple:e})=>({D:[n],P:[Gt(-t,n),n],C:[e]});function mM({spread:{begin:n,end:t,ratio:e},fA:i,fB:s,force:r}){let a=t-n;if(e)return[Gt((e[0]-(e[1]-e[0])*n/a)/a,r),Gt((e[1]-e[0])/(a*a),r)];let o=Gt(1/a,Ee(s,Gt(n,r))),l=Ee(Gt(4,r),Gt(6,o)),c=Ee(Gt(12,o),Gt(6,r));return[Gt(1/a,Ee(l,Gt(n/a,c))),Gt(1/(a*a),c)]}function pc(n,t,e){let{begin:i,couple:s}=n.spread,r=Math.max(i,t),a=(r-t)/e,[o,l]=mM(s?{...n,force:n.whole}:n),c=d=>Te(Gt(d,o),Gt(d*d/2,l)),h=[Ee(c(t),c(r)),Te(Gt(e,o),Gt(e*t,l)),Gt(e*e/2,l)];if(s)return{D:[],P:[],C:h};let u=[[0,0,0],h[0],Gt(1/2,h[1]),Gt(1/3,h[2])];return u[0]=Gt(-1,u.reduce((d,f,p)=>Te(d,Gt(a**p,f)),[0,0,0])),{D:h,P:u,C:[]}}function gM(n){if(n.spread.couple)return{D:[],P:[],C:[n.whole]};let{P:t}=pc(n,0,1),e=n.spread.end,i=t.reduce((s,r,a)=>Te(s,Gt(e**a,r)),[0,0,0]);return{D:[n.force],P:[Ee(i,Gt(e,n.force)),n.force],C:[]}}function Sa(n,t,{D:e,P:i,C:s}){e.forEach((r,a)=>n.S[a]=Ee(n.S[a],r)),i.forEach((r,a)=>{n.M[0][a]-=t.length*r[2],n.M[1][a]+=t.length*r[1]}),s.forEach((r,a)=>[1,2].forEach(o=>n.M[o-1][a]-=r[o]))}function xM(n,t){for(let e of n.actions.filter(({spread:i})=>i)){let[i,s]=t,r=Math.max(0,s.start/n.L);for(let u of i.pieces)if(Sa(u,i,pc(e,0,i.length/n.L)),u.nut)break;let{D:a,P:o}=pc(e,r,s.length/n.L),[l,c]=[a,o].map(u=>u.reduce((d,f)=>Te(d,f),[0,0,0])),h={D:[Ee(a[0],l),...a.slice(1)],P:o.map((u,d)=>Te(u,d===0?Ee(l,c):d===1?Gt(-1,l):[0,0,0])),C:[]};for(let u of s.pieces)Sa(u,s,h)}}function Ta(n,t,e,i,s,r,a,o){let l=i.length,c=[r[1],l*n[2]-i.rotary*s[2],l*t[2]/2,l*e[2]/3],h=[r[2],i.rotary*s[1]-l*n[1],-l*t[1]/2,-l*e[1]/3];return a&&(c[0]-=c[1]+c[2]+c[3],h[0]-=h[1]+h[2]+h[3]),{S:[n,t,e],M:[c,h],end:o}}function xc(n,t,e){let{S:i,M:s}=t.pieces.find(d=>e<=d.end),[r,a,o]=[0,1,2].map(d=>i[0][d]+e*(i[1][d]+e*i[2][d])),[l,c]=s.map(d=>d[0]+e*(d[1]+e*(d[2]+e*d[3]))),h=n.arrays.part_scale.data.slice(4*t.part,4*t.part+4),u=n.arrays.part_shape.data[t.part];return{T:r,V2:a,V3:o,M2:l,M3:c,stress:Sm(u,r*h[0],l*h[1],c*h[2],a*h[3],o*h[3])}}function _c(n,t,e){let i=Tm(n,t,e),s=i.local(i.gravity),r=[0,0,0],a=[0,0,0],o=0,l=0;for(let p of i.rods){let v=mc(i,p);for(let{mass:m,place:g}of[{mass:p.mass,place:.5},...p.masses])r=Te(r,Gt(m,s)),a=Te(a,Gt(m,Te(Te(v.first,Gt(g,v.change)),s))),o+=m*(p.start+g*p.length),l+=m}let c=l>0?o/l:i.L/2,h=[{symbol:"F_A",words:`joint ${n.nodes[i.A]} on it`,force:i.FA,at:0},{symbol:"F_B",words:`joint ${n.nodes[i.B]} on it`,force:i.FB,at:i.L},{symbol:"m g",words:"weight",force:r,at:c},{symbol:"m a",words:"inertia: what they sum to",force:a,at:c,inertia:!0}],u=Math.max(...i.FA.map(Math.abs),...i.FB.map(Math.abs),1e-30),d=i.actions.filter(p=>Math.max(...p.force.map(Math.abs))>1e-6*u);h.splice(2,0,...d.map(p=>({symbol:_M[p.kind],words:`${p.kind} ${p.source}`,force:p.force,at:p.place*i.L})));let f=i.actions.filter(p=>Math.hypot(...p.couple)>1e-6*u*i.L).map(p=>({words:`${p.kind} ${p.source}`,at:p.place*i.L,couple:p.couple,size:n.dim===2?p.couple[2]:Math.hypot(...p.couple)}));return{state:i,mass:l,centre:c,terms:h,couples:f,drives:sd(n,t,e).filter(p=>p.unit==="m")}}var _M={drive:"T",coupling:"Q",load:"P",body:"B",friction:"C",spring:"K",bearing:"C",hub:"H",couple:"C",hinge:"C"};function sd(n,t,e){return Am(n,t,i=>i.member===e)}function Em(n,t,e){return Am(n,t,i=>i.node===e||i.axis?.includes?.(e)===!0)}function Am(n,t,e){return n.header.drives.flatMap((i,s)=>{if(!e(i))return[];let r=a=>n.has(a)?n.number(a,t,s):NaN;return[{...i,position:r("drive_position"),force:r("drive_force")}]})}var yi={left:52,right:10,top:18,bottom:18},Cm=Object.fromEntries(Object.entries(Xe).map(([n,t])=>[n,[1,2,3].map(e=>t[`pen-${e}`])]));function fn(n,t,e={}){let i=window.devicePixelRatio||1,s=n.clientWidth||300,r=n.clientHeight||110;n.width=Math.round(s*i),n.height=Math.round(r*i);let a=n.getContext("2d");a.scale(i,i);let o=getComputedStyle(n),l=o.color,c=o.getPropertyValue("--line").trim()||"#ccc",h=o.getPropertyValue("--dark").trim()==="1"?"dark":"light",u=vM(t,e,s,r);return a.font="11px system-ui, sans-serif",yM(a,u,e,l,c),t.forEach((d,f)=>bM(a,u,d,Cm[h][f%3],e.fill)),Number.isFinite(e.limit)&&SM(a,u,e.limit,h==="dark"?Xe.dark.alarm:_n),e.cursor!==void 0&&wM(a,u,e.cursor,l),TM(a,u,t,Cm[h],l),u}function vM(n,t,e,i){let[s,r,a,o]=[1/0,-1/0,0,0];for(let{x:p,y:v}of n)for(let m=0;m<p.length;m++)p[m]<s&&(s=p[m]),p[m]>r&&(r=p[m]),v[m]<a&&Number.isFinite(v[m])&&(a=v[m]),v[m]>o&&Number.isFinite(v[m])&&(o=v[m]);let l=Math.max(Math.abs(a),Math.abs(o));Number.isFinite(t.limit)&&t.limit<2.5*l&&(o=Math.max(o,t.limit)),(o-a<1e-12*(l||1)||a===o)&&([a,o]=[Math.min(a,-1e-9),Math.max(o,1e-9)]);let c=.06*(o-a);a<0&&(a-=c),o>0&&(o+=c);let[h,u]=us(l,t.unit||""),d=e-yi.left-yi.right,f=i-yi.top-yi.bottom;return{x0:s,x1:r,y0:a,y1:o,largest:l,factor:h,unit:u,width:e,height:i,x:p=>yi.left+(p-s)/(r-s||1)*d,y:p=>yi.top+(1-(p-a)/(o-a))*f}}function yM(n,t,e,i,s){n.strokeStyle=s,n.fillStyle=i,n.lineWidth=1;let[r,a]=[yi.left,t.width-yi.right];n.textAlign="right",n.textBaseline="middle";let{factor:o}=t;for(let h of t.largest?Mh(t.y0*o,t.y1*o,4):[0]){let u=Math.round(t.y(h/o))+.5;n.beginPath(),n.moveTo(r,u),n.lineTo(a,u),n.stroke(),n.fillText(ue(h),r-5,u)}n.textBaseline="alphabetic",n.textAlign="center";let l=` ${e.xUnit||"s"}`,c=n.measureText(l).width;for(let h of Mh(t.x0,t.x1,5)){let u=ue(h),d=n.measureText(u).width/2,f=Math.min(Math.max(t.x(h),r+d),a-d);(f+d<a-c||h===0)&&n.fillText(u,f,t.height-4)}n.textAlign="right",n.fillText(l,a,t.height-4),n.textAlign="left",n.fillText(`${e.title||""}${t.unit?` (${t.unit})`:""}`,r,11)}function bM(n,t,e,i,s){let{x:r,y:a}=e;n.strokeStyle=n.fillStyle=i,n.lineWidth=1.6,n.setLineDash(e.dashed?[5,3]:[]);for(let[o,l]of MM(a)){n.beginPath();for(let c=o;c<=l;c++)n[c>o?"lineTo":"moveTo"](t.x(r[c]),t.y(a[c]));n.stroke(),s&&(n.lineTo(t.x(r[l]),t.y(0)),n.lineTo(t.x(r[o]),t.y(0)),n.globalAlpha=.12,n.fill(),n.globalAlpha=1)}n.setLineDash([])}function MM(n){let t=[];for(let e=0;e<n.length;e++){if(!Number.isFinite(n[e]))continue;t.length&&t[t.length-1][1]===e-1?t[t.length-1][1]=e:t.push([e,e])}return t}function SM(n,t,e,i){e>t.y1||(n.strokeStyle=i,n.setLineDash([4,3]),n.beginPath(),n.moveTo(yi.left,t.y(e)),n.lineTo(t.width-yi.right,t.y(e)),n.stroke(),n.setLineDash([]))}function wM(n,t,e,i){n.strokeStyle=i,n.globalAlpha=.6,n.beginPath(),n.moveTo(t.x(e),yi.top),n.lineTo(t.x(e),t.height-yi.bottom),n.stroke(),n.globalAlpha=1}function TM(n,t,e,i,s){let r=t.width-yi.right;n.textAlign="right";for(let a=e.length-1;a>=0;a--){let{label:o}=e[a];o&&(n.fillStyle=s,n.fillText(o,r,11),r-=n.measureText(o).width+4,n.fillStyle=i[a%i.length],n.fillRect(r-12,6,12,3),r-=20)}}var Rm=41,EM=12,AM=new Set(["stress"]),CM=[["Axial force T","N",[[0,""]]],["Shear V","N",[[1,""]]],["Bending moment M","N m",[[2,""]]],["von Mises stress","Pa",[[3,""]]]],RM=[["Axial force T","N",[[0,""]]],["Shear V","N",[[1,"V2"],[2,"V3"]]],["Bending moment M","N m",[[3,"M2"],[4,"M3"]]],["Torsion","N m",[[5,""]]],["von Mises stress","Pa",[[6,""]]]],vc=class{constructor(t){this.app=t,this.node=x("section",{class:"inspector","aria-label":"what is picked"})}show(){let{picked:t}=this.app;if(this.updates=[],!t){let e=this.app.views.some(({scene:r})=>r.members.length),i=(e?["N","P"]:["Shift N","Shift P"]).map(r=>x("kbd",{},r)),s=`${this.app.touch?"Tap":"Pick"} ${e?"a member or node in the picture or the table":"a node in the picture"}`;ce(this.node,x("p",{class:"faint"},s,this.app.touch?".":["; or step through them with ",i[0]," and ",i[1],"."]),e?null:this.overview(),this.app.views.map((r,a)=>this.measured(r,a))),this.update();return}ce(this.node,x("div",{class:"views"},this.app.views.map((e,i)=>this.column(e,i,t)))),this.update()}overview(){let t=this.app.views.flatMap(({scene:e})=>{let{skins:i=[],pressures:s,loads:r}=e.header,a=i.map(l=>[`${l.kind[0].toUpperCase()}${l.kind.slice(1)}`,l.name]);a.push(["Nodes",e.nodes.length],["Faces",e.faces]),s&&a.push(["Pressure",`${s.least===s.largest?"":`${$t(s.least,"Pa")} to `}${$t(s.largest,"Pa")} on ${s.count} ${s.count===1?"face":"faces"}`]);let o=r.filter(l=>!l.pressure&&!l.at).length;return o&&a.push(["Nodal loads",o]),a});return x("table",{class:"values"},t.map(([e,i])=>x("tr",{},x("th",{},e),x("td",{},i))))}measured(t,e){let{scene:i}=t,s=i.header.quantities||[];if(!s.length)return null;let r=({limits:c},h)=>c&&(c[0]!==null&&h<c[0]||c[1]!==null&&h>c[1]),a=this.values(()=>s.map((c,h)=>{let u=i.number("quantity",t.frame,h);return[c.name,$t(u,c.unit),r(c,u)?"beyond its limit":c.words]})),o=i.frames<2?[]:s.slice(0,EM).map((c,h)=>{let u=x("canvas",{class:"plot",role:"img","aria-label":`${c.name} over time`}),d=Array.from(i.time,(f,p)=>i.number("quantity",p,h));return this.updates.push(()=>fn(u,[{x:i.time,y:d,label:""}],{title:c.name,unit:c.unit,cursor:i.time[t.frame]})),u}),l=this.app.views.length>1;return x("div",{class:"subject"},x("h2",{},"Quantities",l?x("small",{},` ${this.app.labels[e]}`):null),a,...o)}update(){for(let t of this.updates||[])t()}column(t,e,i){let{scene:s}=t,r=this.app.indexIn(t,i),o=this.app.views.length>1?x("h3",{},this.app.labels[e]):null;if(r<0)return x("div",{},o,x("p",{class:"faint"},`no ${i.type} called ${i.name} here`));let l=i.type==="member"?this.member(t,r):this.atNode(t,r);return x("div",{class:"subject"},o,...l)}member(t,e){let{scene:i}=t,[s,r]=[i.ends[2*e],i.ends[2*e+1]],a=i.header.kinds[e],l=[x("h2",{},i.members[e],x("small",{},` ${a}${a==="cable"?"":" member"}, `,this.link(t,s)," → ",this.link(t,r))),this.values(()=>this.memberValues(t,e)),this.history(t,e),...this.driveHistories(t,e)];return i.has("member_force")&&((i.header.beams||[]).includes(e)?l.push(...this.beam(t,e)):i.header.bodies.some(c=>c.member===e)||l.push(...this.mechanics(t,e))),l}link(t,e){let i=t.scene.nodes[e];return x("button",{class:"link",type:"button",onclick:()=>this.app.pick({type:"node",name:i})},i)}values(t){let e=x("table",{class:"values"});return this.updates.push(()=>ce(e,t().map(([i,s,r])=>x("tr",{},x("th",{},i),x("td",{},s,r?x("small",{},` ${r}`):null))))),e}memberValues(t,e){let{scene:i,frame:s}=t,r=i.header.channels.map(l=>{let c=i.plainValue(l.id,s,e),h=l.id==="force"&&c?c>0?"tension":"compression":"";return[l.label,Oa(l,c),l.over_run?"worst of the run":h]}),a=i.header.bodies.find(l=>l.member===e);a&&r.push(["Body",$t(a.mass,"kg")]),r.push(["Length",$t(i.length(s,e),"m",6)]),r.push(...NM(i,s,e)),r.push(...Nm(sd(i,s,e)));let o=i.header.not_checked?.[i.members[e]];return o&&r.push(["Not checked",o]),i.unsure.has(e)&&r.push(["Note","this force is not unique: a share by stiffness or convention"]),r}history(t,e){let{scene:i}=t;if(i.frames<2)return null;let s=x("canvas",{class:"plot",role:"img","aria-label":"history"});return this.updates.push(()=>{let r=i.channel(this.app.channel?.id)||i.header.channels[0],a=Array.from(i.time,(h,u)=>i.value(r.id,u,e)),o=AM.has(r.id)?Pm(i,e):["capacity","margin"].includes(r.scale)?1:void 0,l=r.scale==="margin"?"Buckling: compression over allowed":r.label,c=[{x:i.time,y:a,label:""}];if(r.id==="force"&&i.has("rest_force")){let h=Array.from(i.time,(u,d)=>i.number("rest_force",d,e));c.push({x:i.time,y:h,label:"at rest",dashed:!0})}fn(s,c,{title:l,unit:r.unit,cursor:i.time[t.frame],limit:o})}),s}driveHistories(t,e){let{scene:i}=t;return i.frames<2||!i.has("drive_force")?[]:i.header.drives.flatMap((s,r)=>{let a=Array.from(i.time,(c,h)=>i.number("drive_force",h,r));if(s.member!==e||!a.some(Number.isFinite))return[];let o=s.unit==="rad",l=x("canvas",{class:"plot",role:"img","aria-label":`drive ${s.name} over time`});return this.updates.push(()=>fn(l,[{x:i.time,y:a,label:""}],{title:`${o?"Torque":"Force"} of drive ${s.name}`,unit:o?"N m":"N",cursor:i.time[t.frame]})),[l]})}beam(t,e){let{scene:i}=t,s=i.arrays.beam_section,r=i.curves.row.get(e);if(!s||r===void 0)return[x("p",{class:"faint"},r===void 0?"Section forces of rigid beams are not computed.":"Section forces of beams: kt.strength.beams.")];let[,a,o,l]=s.shape,c=i.length(0,e),h=Array.from({length:o},(p,v)=>v*c/(o-1)),u=p=>h.map((v,m)=>s.data[((t.frame*a+r)*o+m)*l+p]),f=(i.dim===2?CM:RM).map(p=>[x("canvas",{class:"plot small",role:"img","aria-label":p[0]}),...p]);return this.updates.push(()=>{for(let[p,v,m,g]of f){let M=g.map(([w,b])=>({x:h,y:u(w),label:b}));fn(p,M,{title:v,unit:m,xUnit:"m from A",fill:!0})}}),[x("h4",{},"Along it, now"),...f.map(([p])=>p)]}mechanics(t,e){let{scene:i}=t,s=x("div",{class:"freebody"}),r=x("div");this.updates.push(()=>{let l=_c(i,t.frame,e);ce(s,vm(i,l)),ce(r,bm(i,l))});let a=i.dim===3,o=[["Axial force T","N",[["T",""]]],["Shear V","N",a?[["V2","V2"],["V3","V3"]]:[["V2",""]]],["Bending moment M","N m",a?[["M2","M2"],["M3","M3"]]:[["M3",""]]],["von Mises stress","Pa",[["stress",""]]]].map(l=>[x("canvas",{class:"plot small",role:"img","aria-label":l[0]}),...l]);return this.updates.push(()=>{let l=rd(i,t.frame,e);for(let[c,h,u,d]of o){let f=d.map(([v,m])=>({x:l.s,y:l[v],label:m})),p=PM(d)==="stress"?Pm(i,e):void 0;fn(c,f,{title:h,unit:u,xUnit:"m from A",fill:!0,limit:p})}}),[x("h4",{},"Cut free, now"),s,r,x("h4",{},"Along it, now"),...o.map(([l])=>l)]}atNode(t,e){let{scene:i}=t,s=x("h2",{},i.nodes[e],x("small",{}," node")),r=i.members.flatMap((c,h)=>i.ends[2*h]===e||i.ends[2*h+1]===e?[h]:[]),a=x("p",{},"joins ",r.slice(0,24).flatMap(c=>[x("button",{class:"link",type:"button",onclick:()=>this.app.pick({type:"member",name:i.members[c]})},i.members[c])," "])),o=Fa(this.app.hint("Path","T"),"Path of this node along the run",!1,()=>this.app.toggleTrace());o.classList.add("trace"),this.updates.push(()=>Ui(o,this.app.paths.has(i.nodes[e])));let l=[s,a,this.values(()=>IM(i,t.frame,e))];return i.frames>1&&l.push(o,this.nodeHistory(t,e)),l}nodeHistory(t,e){let{scene:i}=t,s=x("canvas",{class:"plot",role:"img","aria-label":"history"}),r=i.position(0,e),a="xyz".slice(0,i.dim).split("").map((o,l)=>({x:i.time,label:o,y:Array.from(i.time,(c,h)=>i.position(h,e)[l]-r[l])}));return this.updates.push(()=>fn(s,a,{title:"Moved from the start",unit:"m",cursor:i.time[t.frame]})),s}},PM=n=>n[0][0];function Pm(n,t){return Math.min(...n.partsOf[t].map(e=>n.arrays.part_allowed.data[e]))}function IM(n,t,e){let i="xyz".slice(0,n.dim).split(""),s=(c,h)=>{let u=Math.max(...c.map(Math.abs)),[d,f]=zn(i.map((p,v)=>Math.abs(c[v])>1e-9*u?c[v]:0),h);return`${d.map(p=>p.trim()).join(", ")} ${f}`},r=[["Position",s(n.position(t,e),"m")]];if(n.has("velocity")){let c=n.vector("velocity",t,e),h=n.vector("acceleration",t,e);r.push(["Speed",$t(Math.hypot(...c),"m/s")],["Velocity",s(c,"m/s")],["Acceleration",s(h,"m/s²")])}let a=n.arrays.lump.data[e];a&&r.push(["Lumped mass",$t(a,"kg")]);let o=n.header.supports.find(c=>c.node===e);o&&r.push(o.words?["Support",o.words]:["Held in",[...o.axes].join(", ")]);let l=n.header.supported?.indexOf(n.nodes[e])??-1;return l>=0&&r.push(["Reaction",s(n.vector("reaction",t,l),"N")]),n.header.loads.forEach((c,h)=>{c.node===e&&r.push([`Load ${c.name}`,s(n.vector("load_force",t,h),"N")])}),r.push(...Nm(Em(n,t,e))),r}function NM(n,t,e){return n.header.loads.flatMap((i,s)=>{if(i.member!==e||i.words===!1)return[];let r=Math.hypot(...n.vector("load_force",t,s));return[[`Load ${i.name}`,i.span?$t(r/i.span,"N/m"):$t(r,"N")]]})}function Nm(n){return n.filter(t=>!Number.isNaN(t.position)).map(t=>{let e=t.unit==="rad";return[`Drive ${t.name}`,$t(t.position,t.unit,6),Number.isNaN(t.force)?"":`drive ${e?"torque":"force"} ${$t(t.force,e?"N m":"N")}`]})}function rd(n,t,e){let i={s:[],T:[],V2:[],V3:[],M2:[],M3:[],stress:[],parts:[]};for(let s of gc(n,t,e).parts){i.s.length&&Im(i,s.start,{T:NaN,V2:NaN,V3:NaN,M2:NaN,M3:NaN,stress:NaN},"");for(let r=0;r<Rm;r++){let a=r/(Rm-1);Im(i,s.start+a*s.length,xc(n,s,a),n.header.parts[s.part])}}return i}function Im(n,t,e,i){n.s.push(t),n.parts.push(i);for(let[s,r]of Object.entries(e))n[s].push(r)}var Lm=[["Time",[[" ","play or pause",n=>n.togglePlay(),"space"],["ArrowRight","one sample on (Shift: ten)",(n,t)=>n.step(t.shiftKey?10:1),"→"],["ArrowLeft","one sample back (Shift: ten)",(n,t)=>n.step(t.shiftKey?-10:-1),"←"],["Home","to the start",n=>n.goTo(0)],["End","to the end",n=>n.goTo(n.lead.frames-1)],["+","faster",n=>n.faster(1)],["-","slower",n=>n.faster(-1)],["x","to the worst sample of what colours",n=>n.toWorst()]]],["What is shown",[["c","next colour (Shift: previous)",(n,t)=>n.nextChannel(t.shiftKey?-1:1)],["s","next diagram over the structure (Shift: previous)",(n,t)=>n.nextDiagram(t.shiftKey?-1:1)],["e","next load case",n=>n.nextCase()],["m","next mode or mechanism",n=>n.nextMode()],["g","start pose as a ghost",n=>n.toggle("ghost")],["y","paths of all nodes that move",n=>n.toggle("paths")],["l","loads",n=>n.toggle("loads")],["b","supports",n=>n.toggle("supports")],["r","faces of rigid bars",n=>n.toggle("faces")],["h","ground grid",n=>n.toggle("grid")],["a","names",n=>n.toggle("names")],["v","panel beside the picture",n=>n.togglePanel()],["d","dark or light",n=>n.toggleTheme()]]],["Picking",[["n","next member (Shift: next node)",(n,t)=>n.pickNext(t.shiftKey?"node":"member",1)],["p","previous member (Shift: node)",(n,t)=>n.pickNext(t.shiftKey?"node":"member",-1)],["w","the worst member now",n=>n.pickWorst()],["t","path of the picked node",n=>n.toggleTrace()],["/","find by name",n=>n.find()],["Escape","nothing picked",n=>n.escape(),"Esc"]]],["Camera",[["1","from a corner",n=>n.aim("corner")],["2","from the front (along y)",n=>n.aim("front")],["3","from the side (along x)",n=>n.aim("side")],["4","from above (the x-y plane)",n=>n.aim("plane")],["f","fit",n=>n.aim(n.views[0].preset)],["i","turn up",n=>n.orbit(0,.12,1)],["k","turn down",n=>n.orbit(0,-.12,1)],["j","turn left",n=>n.orbit(-.12,0,1)],["o","turn right",n=>n.orbit(.12,0,1)],[",","nearer",n=>n.orbit(0,0,.9)],[".","farther",n=>n.orbit(0,0,1.1)],["?","this page",n=>n.toggleHelp()]]]],LM=new Set([..."1234ikjo"]),DM=new Set(["text","search","number"]);function Dm(n,t,e){let i=new Map(Lm.flatMap(([,r])=>r.map(([a,,o])=>[a,o])));t.addEventListener("keydown",r=>{if(r.ctrlKey||r.metaKey||r.altKey||r.defaultPrevented)return;let a=r.target;if(r.key!=="Escape"&&a.closest?.(".controls"))return;if(a.tagName==="INPUT"&&DM.has(a.type)){r.key==="Enter"&&n.table.pickFirst(),(r.key==="Escape"||r.key==="Enter")&&a.blur();return}if(a.tagName==="BUTTON"&&(r.key===" "||r.key==="Enter")||a.tagName==="SELECT")return;let l=r.key.length===1?r.key.toLowerCase():r.key,c=i.get(l);c&&(r.preventDefault(),c(n,r))},{signal:e});let s=!1;t.addEventListener("pointerdown",()=>s=!0,{signal:e}),t.addEventListener("keydown",()=>s=!1,{capture:!0,signal:e}),t.addEventListener("change",r=>{s&&r.target.tagName==="SELECT"&&r.target.blur()},{signal:e})}function Om(n){let t=n.views[0].scene.dim===2,i=Lm.map(([l,c])=>[l,c.filter(([h])=>!t||!LM.has(h))]).map(([l,c])=>x("div",{},x("h3",{},l),x("dl",{},c.map(([h,u,,d])=>[x("dt",{},x("kbd",{},d||h.toUpperCase())),x("dd",{},u)]).flat()))),s=x("button",{type:"button",onclick:()=>n.toggleHelp()},n.hint("Close","Esc")),a=`Bars thinner than a hundredth of the usual length are drawn thicker, to be seen. Green: what moves by itself (collars at the screw, rings at motors). Hatched: supports. Violet arrows: loads. Striped: not checked, or a force that is not unique. ${n.touch?`${t?"Drag to shift, two fingers to approach":"Drag to turn, two fingers to shift and approach"}, tap to pick.`:`${t?"Drag to shift":"Drag to turn, right-drag to shift"}, wheel to approach, click to pick.`}`,o=l=>{l.key==="Tab"&&(l.preventDefault(),s.focus())};return x("div",{class:"help",role:"dialog","aria-modal":"true","aria-label":n.touch?"help":"keys",hidden:!0,onkeydown:o},x("div",{class:"sheet"},n.touch?x("h2",{},"Help"):[x("h2",{},"Keys"),x("div",{class:"columns"},i)],x("p",{},a),s))}var OM={rigid:"rigid bar",driven:"driven bar",active:"active member: base and tube",elastic:"elastic bar",beam:"elastic beam",cable:"cable: tension only",free:"free sensor"},UM={membrane:"membrane",solid:"surface of a solid"},bc=class{constructor(t){this.app=t,this.node=x("div",{class:"legend",role:"note","aria-live":"polite"})}show(){let{channel:t,limits:e}=this.app;if(!t){let l=[...this.kinds().map(([c,h])=>yc(hi[c],h)),...this.skins(),...this.motors()];this.node.hidden=!l.length,ce(this.node,x("b",{},"Kinds of members"),l);return}this.node.hidden=!1;let[i,s]=us(e[1],t.unit),r=`${t.label}${s?` (${s})`:""}`,a=FM(t,e).map(l=>x("span",{},kM(t,l,i))),o=[x("b",{},r),x("div",{class:"bar",style:`background:${Ua(t.scale)}`}),x("div",{class:"ticks"},a),x("div",{class:"words"},x("span",{},t.low),x("span",{},this.high(t)))];t.over_run&&o.push(x("small",{},"worst of the whole run")),this.over(t)&&o.push(yc(_n,t.scale==="margin"?"buckles (margin below 0)":"over capacity (above 100 %)")),this.missing(t)&&o.push(Um("var(--missing)",Oi(t)?"not checked":"not known")),t.id!=="speed"&&this.app.views.some(({scene:l})=>l.unsure.size)&&o.push(Um("var(--faint)","the force is not unique")),this.app.views.some(({scene:l})=>l.coloursFaces(t.id))||o.push(...this.skins()),ce(this.node,o)}high(t){if(t.high!=="largest of the run")return t.high;let e=this.app.views.map(({scene:i})=>i).filter(i=>i.channel(t.id));return`largest ${this.app.lead.frames>1?"of the run ":""}${$t(Math.max(...e.map(i=>i.range(t.id)[1])),t.unit)}`}kinds(){let t=new Set(this.app.views.flatMap(e=>e.scene.header.kinds));return Object.entries(OM).filter(([e])=>t.has(e))}motors(){return this.app.views.some(({scene:e})=>e.header.drives.some(i=>i.kind==="angle"||i.kind==="hinge"))?[yc(hi.driven,"ring: motor about its axis")]:[]}skins(){let t=new Set(this.app.views.flatMap(e=>e.scene.header.skins?.map(i=>i.kind)||[]));return Object.entries(UM).filter(([e])=>t.has(e)).map(([e,i])=>yc(La[e],i))}over(t){return Oi(t)&&this.app.views.some(({scene:e})=>e.channel(t.id)&&e.range(t.id)[1]>1)}missing(t){return this.app.views.some(({scene:e,frame:i})=>e.members.some((s,r)=>Number.isNaN(e.value(t.id,i,r))))}};function yc(n,t){return x("div",{class:"swatch"},x("i",{style:`background:${n}`}),t)}function Um(n,t){return x("div",{class:"swatch"},x("i",{style:`background:repeating-linear-gradient(135deg, ${n} 0 4px, var(--card) 4px 7px)`}),t)}function FM(n,[t,e]){return n.scale==="diverging"?[t,t/2,0,e/2,e]:[0,.25,.5,.75,1].map(i=>t+i*(e-t))}function kM(n,t,e){return n.scale==="margin"?t<=0?"∞":ue(1/t-1,2):ue(t*e,3)}var BM=400,Mc=48,ad=5,od=2,zM=[[1,-1],[1,1],[-1,-1],[-1,1],[0,-1],[0,1],[1,0],[-1,0]],GM=[.5,.4,.6,.3,.7,.2,.8],Sc=class{constructor(t){this.view=t,this.node=x("div",{class:"names","aria-hidden":!0})}place(t,e=[]){if(this.node.hidden=!t||this.view.scene.members.length>BM,this.node.hidden)return;let{scene:i,now:s}=this.view;this.tags??=this.made();let r=s.map(l=>this.view.project(l)),a=this.node.getBoundingClientRect(),o=new ld(a.width,a.height);for(let l of this.node.closest(".stage")?.querySelectorAll(".legend")||[])o.add(WM(l,a));for(let l of e)o.add(l);for(let{tag:l,type:c,index:h}of this.order()){let u=c==="node"?VM(r[h],l):HM(this.view.along(h,r),l),d=[l.place??0,...u.keys()].find(f=>f<u.length&&o.free(u[f]));l.node.style.visibility=d===void 0?"hidden":"visible",d!==void 0&&(l.place=d,o.add(u[d]),l.node.style.transform=`translate(${(u[d][0]+od).toFixed(1)}px, ${u[d][1].toFixed(1)}px)`)}}made(){let{scene:t}=this.view,e=[...t.nodes.map((i,s)=>x("span",{class:"of-node",hidden:t.directors.has(s)},i)),...t.members.map((i,s)=>x("span",{hidden:!t.shows(s)},i))];return ce(this.node,e),e.map(i=>({node:i,width:i.offsetWidth,height:i.offsetHeight}))}order(){let{scene:t,picked:e}=this.view,i=t.nodes.length,s=this.tags.map((a,o)=>o<i?{tag:a,type:"node",index:o}:{tag:a,type:"member",index:o-i});return[...e?s.splice((e.type==="node"?0:i)+e.index,1):[],...s].filter(({tag:a})=>!a.node.hidden)}};function VM([n,t],{width:e,height:i}){return zM.map(([s,r])=>Fm(n+s*(e/2+ad),t+r*(i/2+ad-1),e,i))}function HM(n,{width:t,height:e}){let i=Math.floor(n.length/3),s=n[i],r=n[n.length-1-i],[a,o]=[r[0]-s[0],r[1]-s[1]],l=Math.hypot(a,o)||1,c=[o/l,-a/l],h=(Math.abs(c[0])*t+Math.abs(c[1])*e)/2+ad-1;return GM.flatMap(u=>[1,-1].map(d=>Fm(s[0]+u*a+d*h*c[0],s[1]+u*o+d*h*c[1],t,e)))}function Fm(n,t,e,i){return[n-e/2-od,t-i/2,n+e/2+od,t+i/2]}function WM(n,t){let e=n.getBoundingClientRect();return[e.left-t.left,e.top-t.top,e.right-t.left,e.bottom-t.top]}var ld=class{constructor(t,e){Object.assign(this,{width:t,height:e,cells:new Map})}squares([t,e,i,s]){let r=[];for(let a=Math.floor(t/Mc);a<=Math.floor(i/Mc);a++)for(let o=Math.floor(e/Mc);o<=Math.floor(s/Mc);o++)r.push(1e5*a+o);return r}free(t){return t[0]<0||t[1]<0||t[2]>this.width||t[3]>this.height?!1:this.squares(t).every(e=>(this.cells.get(e)||[]).every(i=>i[2]<=t[0]||i[0]>=t[2]||i[3]<=t[1]||i[1]>=t[3]))}add(t){for(let e of this.squares(t))this.cells.has(e)?this.cells.get(e).push(t):this.cells.set(e,[t])}};var XM=.13,os=13,$M=40,qM=.02,YM=1e-7,ZM=4e3,jM={N:"T",V:"V2",M:"M3"},KM=[[0,1],[0,-1],[1,0],[-1,0],[1,1],[-1,1],[1,-1],[-1,-1]],Tc=class{constructor(t){this.view=t,this.node=Ht("svg",{class:"diagram","aria-hidden":!0}),this.labels=[],this.boxes=[],this.factors=new Map}place(t){let{scene:e,frame:i}=this.view;if(this.labels=[],this.boxes=[],!t||!km(e,t)){this.node.replaceChildren();return}let s=this.factor(t),r=hd(e,i,t,this.view.now),a=r.map(l=>this.drawn(l,t,s)),o=this.view.canvas.getBoundingClientRect();this.node.setAttribute("viewBox",`0 0 ${o.width} ${o.height}`),this.node.replaceChildren(...a.flatMap(({shown:l})=>l),...this.written(r,a,t,o))}reach(t){let{scene:e}=this.view;if(!t||!km(e,t))return[];let i=this.factor(t),s=Bm(e),r=[];for(let a=0;a<e.frames;a+=s)for(let{base:o,values:l,ways:c,extremes:h}of hd(e,a,t))r.push(...h.map(u=>o[u].map((d,f)=>d+i*l[u]*c[u][f])));return r}factor(t){let{scene:e}=this.view,i=`${t.id} ${e.header.load_case}`;if(!this.factors.has(i)){let s=Bm(e),r=0;for(let l=0;l<e.frames;l+=s)for(let{values:c}of hd(e,l,t))for(let h of c)r=Math.max(r,Math.abs(h));let a=r?XM*e.extent.size/r:0,o=10**Math.floor(Math.log10(a||1));this.factors.set(i,t.id==="deflection"&&a?o*Math.max(...[1,2,5].filter(l=>l*o<=a*(1+1e-9))):a)}return this.factors.get(i)}drawn({base:t,values:e,ways:i},s,r){let a=c=>c.map(h=>this.view.project(h)),o=a(t),l=a(t.map((c,h)=>c.map((u,d)=>u+r*e[h]*i[h][d])));return{tips:l,foot:o,shown:fd(o,l,e,s.id)}}written(t,e,i,s){let r=t.flatMap(({extremes:o,values:l,member:c},h)=>o.map(u=>({member:this.view.scene.members[c],value:l[u],tip:e[h].tips[u],foot:e[h].foot[u]}))),a=ud(r,i.unit,s,pd(this.node));return this.labels=a.map(({member:o,value:l,words:c})=>({member:o,value:l,words:c})),this.boxes=a.map(({box:o})=>o),a.map(dd)}};function ud(n,t,{width:e,height:i},s){let r=Math.max(0,...n.map(({value:l})=>Math.abs(l))),a=[],o=n.filter(({value:l})=>Math.abs(l)>qM*r).sort((l,c)=>Math.abs(c.value)-Math.abs(l.value)).slice(0,$M);for(let l of o){let c=$t(l.value,t),h=6.4*c.length+6,u=15,d=([v,m])=>[v-h/2,m-u/2,v+h/2,m+u/2],f=QM(l,h,u).filter(([v,m])=>v>h/2&&m>u/2&&v<e-h/2&&m<i-u/2),p=f.find(v=>[...s,...a.map(m=>m.box)].every(m=>JM(d(v),m)))||(a.length?null:f[0]);p&&a.push({...l,words:c,at:p,box:d(p),chief:!a.length})}return a}function dd({words:n,at:[t,e],chief:i}){return Ht("text",{class:i?"chief":"",x:t.toFixed(1),y:e.toFixed(1)},n)}function fd(n,t,e,i){if(i==="deflection")return[Ht("path",{class:"shape",d:cd(t)})];let s=(a,o)=>Ht("path",{class:`area ${a}`,d:`${cd([...n,...t.map((l,c)=>o(e[c])?l:n[c]).reverse()])}Z`});return[...i==="N"?[s("tension",a=>a>0),s("compression",a=>a<0)]:[s("plain",()=>!0)],Ht("path",{class:"rim",d:cd([n[0],...t,n.at(-1)])})]}var km=(n,t)=>n.header.shows?.some(({id:e})=>e===t.id),Bm=n=>Math.max(1,Math.ceil(n.frames*n.members.length/ZM)),cd=n=>`M${n.map(([t,e])=>`${t.toFixed(1)} ${e.toFixed(1)}`).join("L")}`,JM=(n,t)=>n[2]<=t[0]||t[2]<=n[0]||n[3]<=t[1]||t[3]<=n[1];function QM({tip:n,foot:t},e,i){let s=[n[0]-t[0],n[1]-t[1]],r=([a,o])=>a*s[0]+o*s[1];return[1,2].flatMap(a=>KM.toSorted((o,l)=>r(l)-r(o)).map(([o,l])=>[n[0]+o*(e/2+3*a),n[1]+l*(i/2+4*a)]))}function pd(n){let t=n.getBoundingClientRect();return[...n.closest(".stage")?.querySelectorAll(".legend, .told")||[]].filter(e=>!e.hidden).map(e=>{let i=e.getBoundingClientRect();return[i.left-t.left,i.top-t.top,i.right-t.left,i.bottom-t.top]})}function hd(n,t,e,i){return Gm(n,t,e,i).filter(({values:s})=>s.some(Boolean)&&!s.some(Number.isNaN)).map(s=>({...s,extremes:tS(s)}))}function zm(n,t,e){let i=new Map;for(let{member:s,values:r}of Gm(n,t,e))i.set(s,!r.some(Number.isNaN));return n.members.filter((s,r)=>n.shows(r)&&!i.get(r)&&!(e.id==="torque"&&!n.curves.row.has(r)))}function Gm(n,t,e,i=n.nodes.map((s,r)=>n.position(t,r))){let s=e.unit==="m"?0:YM*eS(n)*(e.unit==="N m"?n.extent.size:1),r=new Set(n.header.bodies.map(({member:o})=>o)),a=new Set(n.header.beams);return n.members.flatMap((o,l)=>{if(!n.shows(l))return[];let c=n.curves.row.get(l);return c!==void 0?n.has("beam_section")?[iS(n,t,e,i,l,c)]:[]:a.has(l)||r.has(l)?[]:e.id==="deflection"?[sS(n,t,l)]:rS(n,t,e,l)}).map(o=>({...o,values:o.values.map(l=>Math.abs(l)<=s?0:l)}))}function tS({values:n,extremes:t}){let e=[...new Set(t)].filter(r=>n[r]);if(e.length<2||n[e[0]]*n[e[1]]<0)return e;let i=e.reduce((r,a)=>Math.abs(n[a])>Math.abs(n[r])?a:r);return[Math.max(...n)-Math.min(...n)<=1e-6*Math.abs(n[i])?n.length>>1:i]}function eS(n){let t=(r,a)=>r.reduce((o,l,c)=>a(c)&&Math.abs(l)>o?Math.abs(l):o,0);n.forces??=new Map;let e=n.header.load_case,{joint_force:i,beam_section:s}=n.arrays;if(!n.forces.has(e)){let r=s?.shape[3];n.forces.set(e,Math.max(i?t(i.data,()=>!0):0,s?t(s.data,a=>a%r<n.dim):0))}return n.forces.get(e)}function iS(n,t,e,i,s,r){let{arrays:a,dim:o,header:l}=n,c=l.shows.findIndex(({id:R})=>R===e.id),[,h,u,d]=a.beam_extreme.shape,f=((t*h+r)*u+c)*d,[p,v,m,g]=a.beam_extreme.data.slice(f,f+4),M=R=>a.beam_section.data[((t*h+r)*os+R)*a.beam_section.shape[3]+c],w=R=>[0,1,2].map(k=>k<o?a.beam_moved.data[((t*h+r)*os+R)*o+k]:0),b=Array.from({length:os},(R,k)=>e.id==="deflection"?w(k):null),E=[...Array.from({length:os},(R,k)=>[k/(os-1),b[k]?Math.hypot(...b[k]):M(k)]),...e.id==="deflection"?[[g,m]]:[[v,p],[g,m]]].sort((R,k)=>R[0]-k[0]),_=E.map(([,R])=>R),T=[p,m].map(R=>_.indexOf(R)).filter(R=>R>=0);if(e.id==="deflection"){let R=Vm(n,t,s),k=E.map(([W])=>wc(b,W)).map(W=>W.map(V=>V/(Math.hypot(...W)||1)));return{member:s,base:E.map(([W])=>wc(R,W)),values:_,ways:k,extremes:T}}let U=n.curves.points(i,s),P=n.curves.across(i,s),D=U.at(-1).map((R,k)=>R-U[0][k]),F=D.map(R=>R/(Math.hypot(...D)||1)),X=E.map(([R])=>wc(P,R)).map(R=>(e.axis===2?R:nS(F,R)).map(k=>e.side*k));return{member:s,base:E.map(([R])=>wc(U,R)),values:_,ways:X,extremes:T}}function wc(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,a)=>(1-s)*r+s*n[i+1][a])}var nS=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]];function Vm(n,t,e){return[0,1].map(i=>n.vector("unmoved",0,n.ends[2*e+i]))}function sS(n,t,e){let i=[0,1].map(r=>n.vector("moved",t,n.ends[2*e+r])),s=i.map(r=>Math.hypot(...r));return{member:e,base:Vm(n,t,e),values:s,ways:i.map((r,a)=>r.map(o=>o/(s[a]||1))),extremes:[s[0]>s[1]?0:1]}}function rS(n,t,e,i){let s=jM[e.id]||e.id;if(s==="torque")return[];let r=Ea(n,t,i),[a,o,l]=r.axes,c=(e.axis===2?o:l).map(h=>e.side*h);return gc(n,t,i).parts.map(h=>{let u=new Set(Array.from({length:os},(m,g)=>g/(os-1))),d=0;for(let m of h.pieces){let g=Math.min(m.end,1);for(let M of[d,Math.min(1,d+1e-9),g,...aS(m,s)])M>=d&&M<=g&&u.add(M);d=g}let f=[...u].sort((m,g)=>m-g),p=f.map(m=>xc(n,h,m)[s]),v=f.map(m=>r.xA.map((g,M)=>g+(h.start+m*h.length)*a[M]));return{member:i,base:v,values:p,ways:f.map(()=>c),extremes:[Math.min(...p),Math.max(...p)].map(m=>p.indexOf(m))}})}function aS({S:n,M:t},e){let i=e[0]==="M"?t[e==="M2"?0:1]:n.map(l=>l[["T","V2","V3"].indexOf(e)]),[s,r,a]=[3*(i[3]||0),2*i[2],i[1]];if(Math.abs(s)<1e-300)return r?[-a/r]:[];let o=Math.sqrt(r*r-4*s*a);return Number.isNaN(o)?[]:[(-r+o)/(2*s),(-r-o)/(2*s)]}var oS=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10],Hm=[1,1.5,2,3,4,6,8],lS=5,Wm=8;function Ac(n){if(!(n>0)||!Number.isFinite(n))return 1;let t=Math.floor(Math.log10(n/Wm));return[...Hm,...Hm.map(i=>10*i)].map(i=>+`${i}e${t}`).find(i=>n/i<=Wm&&n/i>=lS)||1}function Xm(n){return[...new Set([...oS,Ac(n)])].sort((t,e)=>t-e)}var Ec=class{constructor(t){this.app=t;let e=t.lead.time,i=e[t.lead.frames-1]-e[0],s=Ac(i),r=a=>`${ue(a)}×${a===s&&i>0?` (${ue(i/a,2)} s)`:""}`;this.button=x("button",{type:"button",class:"play",title:t.hint("Play or pause","space"),onclick:()=>t.togglePlay()},"▶"),this.slider=x("input",{type:"range",min:0,max:Math.max(t.lead.frames-1,0),step:1,value:0,"aria-label":"time",oninput:()=>t.seek(Number(this.slider.value))}),this.readout=x("output",{class:"time"}),this.speed=x("select",{"aria-label":"speed",title:t.hint("Speed","+ and -"),onchange:()=>t.setSpeed(Number(this.speed.value))},t.speeds.map(a=>x("option",{value:a,selected:a===t.speed},r(a)))),this.node=x("footer",{class:"timebar"},this.button,this.slider,this.readout,this.speed),this.node.hidden=t.lead.frames<2}update(){let{app:t}=this,e=t.lead.time[t.index],i=t.lead.time[t.lead.frames-1],s=Math.max(4,Math.ceil(Math.log10(t.lead.frames))+1);this.slider.value=t.index,this.slider.setAttribute("aria-valuetext",t.said?.()??`${ue(e,s)} s of ${ue(i,s)} s`),this.readout.textContent=t.said?.()??`${ue(e,s)} s`,this.button.textContent=t.playing?"❚❚":"▶",this.button.setAttribute("aria-label",t.playing?"pause":"play"),this.speed.value=String(t.speed)}};function md(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return Math.abs(n[i]-t)<Math.abs(t-n[e])?i:e}var Cc=class{constructor(){Object.assign(this,{index:0,playing:!1,speed:1,way:"once",back:!1})}setLead(t){this.lead=t,Object.assign(this,{speeds:Xm(this.duration),speed:Ac(this.duration)})}get duration(){return this.lead.time[this.lead.frames-1]-this.lead.time[0]}step(t){this.pause(),this.goTo(this.index+t)}togglePlay(){this.lead.frames<2||(this.playing=!this.playing,this.playing&&this.way!=="back"&&this.index===this.lead.frames-1&&this.goTo(0),this.start(),this.time.update(),this.playing&&requestAnimationFrame(t=>this.tick(t)))}pause(){this.playing=!1,this.time.update()}start(){let t=this.lead.time[this.index]-this.lead.time[0];this.clock={at:performance.now(),from:this.back&&this.way==="back"?2*this.duration-t:t}}seek(t){this.goTo(t),this.start()}setWay(t){Object.assign(this,{way:t,back:!1}),this.start()}tick(t){if(!this.playing)return;let{duration:e,way:i}=this,s=i==="back"?2*e:e,r=this.clock.from+this.speed*(t-this.clock.at)/1e3,a=i==="once"&&r>=e;i!=="once"&&(r%=s),this.back=i==="back"&&r>e;let o=md(this.lead.time,this.lead.time[0]+(this.back?s-r:r));o!==this.index&&this.goTo(o),a?this.pause():requestAnimationFrame(l=>this.tick(l))}setSpeed(t){this.speed=t,this.start(),this.time.update()}faster(t){let e=this.speeds.indexOf(this.speed)+t;this.setSpeed(this.speeds[Math.min(Math.max(e,0),this.speeds.length-1)])}};var gd=150,Rc=class{constructor(t){this.app=t,this.order={id:"name",down:!0},this.filter=x("input",{type:"search",placeholder:"find by name","aria-label":"find members by name",oninput:()=>this.show()}),this.head=x("thead"),this.body=x("tbody"),this.note=x("p",{class:"faint"}),this.node=x("section",{class:"table","aria-label":"values of all members now"},this.filter,x("div",{class:"scroll"},x("table",{class:"numbers"},this.head,this.body)),this.note)}columns(){let{scene:t}=this.app.views[0],e=t.header.channels.filter(a=>a.id!=="speed"||t.header.channels.length===1),i=this.app.views;e.length||e.push({id:"length",label:"Length",unit:"m"});let s=i.length>1?e.filter(a=>a.id===this.app.channel?.id).concat(e).slice(0,1):e,r=i.some(a=>a.scene.header.channels.some(o=>o.over_run));return s.flatMap(a=>i.flatMap((o,l)=>{let c=o.scene.channel(a.id);if(a.id!=="length"&&!c)return[];let h=Da(this.largest(a),[],a.unit)[1],u=i.length>1?`${a.label}, ${this.app.labels[l]}`:a.label;return[{id:`${a.id}:${l}`,label:u,unit:h,when:r?c?.over_run?"worst of run":"now":"",channel:a,view:o}]}))}largest(t){if(t.id==="length")return this.app.views.reduce((i,{scene:s})=>s.members.reduce((r,a,o)=>Math.max(r,s.length(0,o)),i),0);let e=this.app.views.filter(({scene:i})=>i.channel(t.id)).flatMap(({scene:i})=>i.range(t.id));return Math.max(...e.map(Math.abs))}show(){let t=this.columns(),e=(c,h)=>x("th",{scope:"col","aria-sort":this.order.id===c?this.order.down?"descending":"ascending":"none"},x("button",{type:"button",class:"link",onclick:()=>this.sort(c)},h)),i=({label:c,unit:h,when:u})=>[c,u?x("small",{},u):null,h?x("small",{class:"unit"},` (${h})`):null];ce(this.head,x("tr",{},e("name","member"),t.map(c=>e(c.id,i(c)))));let s=[...new Set(this.app.views.flatMap(({scene:c})=>c.members.filter((h,u)=>c.shows(u))))],r=this.filter.value.trim().toLowerCase(),a=s.map(c=>({name:c})).filter(({name:c})=>c.toLowerCase().includes(r)),o=t.find(c=>c.id===this.order.id);o?a.sort((c,h)=>(this.order.down?1:-1)*($m(o,h.name)-$m(o,c.name))):this.order.down||a.reverse(),this.rows=a.slice(0,gd),this.cells=[],ce(this.body,this.rows.map(({name:c})=>this.row(c,t)));let l=this.app.views.map(({scene:c})=>c);ce(this.note,a.length>gd?x("span",{},`${gd} of ${a.length} members; sort or search to see others. `):null,t.some(c=>c.channel.id==="force")&&l.some(c=>c.unsure.size)?x("span",{},"† not unique: a share by stiffness or convention. "):null,t.some(c=>Oi(c.channel))&&l.some(({unchecked:c})=>c)?x("span",{},"- striped: not checked. "):null,t.some(c=>c.channel.id==="utilisation")&&l.some(c=>Object.keys(c.header.not_checked||{}).length)?x("span",{},"* not every rule was checked: pick the member. "):null),this.node.hidden=!s.length,this.update(),this.mark()}row(t,e){let i=e.map(r=>{let a=x("td");return this.cells.push({cell:a,column:r,index:r.view.scene.members.indexOf(t)}),a}),s=x("button",{type:"button",class:"link",onclick:()=>this.app.pick({type:"member",name:t})},t);return x("tr",{"data-name":t},x("th",{scope:"row"},s),i)}pickFirst(){this.rows.length&&this.app.pick({type:"member",name:this.rows[0].name})}sort(t){this.order={id:t,down:this.order.id===t?!this.order.down:!0},this.show()}update(){let t=new Map;for(let e of this.cells){let{scene:i,frame:s}=e.column.view,{channel:r}=e.column;e.value=e.index<0?NaN:i.plainValue(r.id,s,e.index),t.set(e.column,[...t.get(e.column)||[],e])}for(let[e,i]of t){let{channel:s,view:{scene:r}}=e,a=i.map(l=>l.value),o=s.scale==="margin"?a.map(l=>Oa(s,l,!0)):Da(this.largest(s),a,s.unit,0,!0)[0];i.forEach(({cell:l,value:c,index:h},u)=>{let d=h<0?"":this.sign(s,r,h,c);l.textContent=d+o[u],l.classList.toggle("over",Oi(s)&&c>1),l.classList.toggle("hatched",d.startsWith("†")||h>=0&&Oi(s)&&Number.isNaN(c))})}}sign(t,e,i,s){let r=e.members[i];return t.id==="force"&&e.unsure.has(i)?"† ":t.id==="utilisation"&&!Number.isNaN(s)&&e.header.not_checked?.[r]?"* ":""}reveal(t){let e=this.body.closest(".scroll"),i=this.head.offsetHeight;t.offsetTop-i<e.scrollTop?e.scrollTop=t.offsetTop-i:t.offsetTop+t.offsetHeight>e.scrollTop+e.clientHeight&&(e.scrollTop=t.offsetTop+t.offsetHeight-e.clientHeight)}mark(){let{picked:t}=this.app;for(let e of this.body.children){let i=t?.type==="member"&&e.dataset.name===t.name;e.toggleAttribute("aria-current",i),i&&this.reveal(e)}}};function $m(n,t){let{scene:e,frame:i}=n.view,s=e.members.indexOf(t),r=s<0?NaN:Math.abs(e.value(n.channel.id,i,s));return Number.isNaN(r)?-1:r}var cS=[["ghost","Ghost","Start pose","G"],["paths","Paths","Paths of all nodes that move","Y"],["names","Names","Names of members and nodes","A"],["loads","Loads","Loads","L"],["grid","Grid","Ground grid","H"]],hS=[["corner","Corner","1"],["front","Front","2"],["side","Side","3"],["plane","Top","4"]],Pc=class{constructor(t){this.app=t;let{header:e}=t.views[0].scene,i=[...new Set(t.views.map(({scene:h})=>h.header.title||h.header.name||"Model"))],s=[...new Map(t.views.flatMap(h=>h.scene.header.channels).map(h=>[h.id,h])).values()],r=x("option",{value:""},"Kind of member");this.colour=x("select",{"aria-label":"colour by",title:t.hint("Colour by","C"),onchange:()=>t.setChannel(this.colour.value)},r,s.map(h=>x("option",{value:h.id},h.label)));let a=cS.filter(([h])=>h!=="paths"||t.lead.frames>1);this.switches=new Map(a.map(([h,u,d,f])=>[h,Fa(u,t.hint(d,f),t.shown[h],()=>t.toggle(h))]));let o=t.views[0].scene.dim===3?hS:[],l=e.modes.length?x("select",{"aria-label":"mode",title:t.hint("Mode or mechanism","M"),onchange:()=>t.setMode(Number(this.modes.value))},x("option",{value:-1},"No mode"),e.modes.map((h,u)=>x("option",{value:u},uS(h)))):null;this.modes=l;let{cases:c}=t.views[0].scene;this.cases=c.length>1?x("select",{"aria-label":"load case",title:t.hint("Load case","E"),onchange:()=>t.setCase(this.cases.value)},c.map(h=>x("option",{value:h},h))):null,this.diagram=t.offered.length?x("select",{"aria-label":"diagram",title:t.hint("Diagram over the structure","S"),onchange:()=>t.setDiagram(this.diagram.value)},x("option",{value:""},"Off"),t.offered.map(({id:h,label:u})=>x("option",{value:h},u))):null,this.node=x("header",{class:t.views.length>1?"toolbar two":"toolbar"},x("div",{class:"title"},x("h1",{},i.join(" | ")),t.views.map(({scene:h},u)=>x("p",{},t.views.length>1?`${t.labels[u]}: `:"",dS(h)))),x("div",{class:"tools"},this.cases&&x("label",{},x("span",{},"Load case"),this.cases),x("label",{},x("span",{},"Colour"),this.colour),this.diagram&&x("label",{},x("span",{},"Diagram"),this.diagram),l,x("span",{class:"group",role:"group","aria-label":"camera"},o.map(([h,u,d])=>x("button",{type:"button",title:t.hint(`Camera: ${u}`,d),onclick:()=>t.aim(h)},u))),x("span",{class:"group",role:"group","aria-label":"show"},[...this.switches.values()]),x("span",{class:"group"},x("button",{type:"button",title:t.hint("Panel","V"),onclick:()=>t.togglePanel()},"Panel"),x("button",{type:"button",title:t.hint("Dark or light","D"),"aria-label":"dark or light",onclick:()=>t.toggleTheme()},"◐"),x("button",{type:"button",title:t.hint("Help","?"),"aria-label":"help",onclick:()=>t.toggleHelp()},"?"))))}update(){this.colour.value=this.app.channel?.id||"",this.cases&&(this.cases.value=this.app.views[0].scene.header.load_case),this.diagram&&(this.diagram.value=this.app.diagram?.id||""),this.modes&&(this.modes.value=String(this.app.mode));for(let[t,e]of this.switches)Ui(e,this.app.shown[t])}};function uS(n){return n.frequency===null?n.name:`${n.name}: ${$t(Number(n.frequency),"Hz")}`}function qm(n,t){return`${n} ${t}${n===1?"":"s"}`}function dS(n){let{header:t}=n,e=n.members.filter((l,c)=>n.shows(c)),i=n.nodes.filter((l,c)=>!n.directors.has(c)),s=[t.kind==="run"?`run ${t.name}`:t.kind];t.cases.length===1&&t.load_case!=="all"&&s.push(`load case ${t.load_case}`);let r=(t.skins||[]).map(l=>`${l.kind} ${l.name}`);s.push([e.length||!r.length?qm(e.length,"member"):"",r.length>3?`${r.length} meshes`:r.join(", "),qm(i.length,"node")].filter(Boolean).join(", "));let{all:a,shown:o}=t.samples;return a>1&&s.push(o<a?`${o} of ${a} samples`:`${a} samples`),t.rounded&&s.push("curves rounded"),t.status!=="Completed."?s.push(`${t.status} ${t.message}`):t.message&&!t.verdict?.more.some(l=>t.message.includes(l))&&s.push(t.message),s.join(" · ")}var fS={ok:"✓",over:"✕",open:"-",none:"-"},Ic=class{constructor(t){this.app=t,this.node=x("div",{class:"verdicts",role:"status","aria-label":"verdict"}),this.update()}update(){let t=JSON.stringify(this.app.views.map(({scene:e})=>e.header.verdict||null));t!==this.told&&(this.told=t,ce(this.node,this.app.views.map((e,i)=>this.strip(e,i))),this.node.hidden=!this.node.childElementCount)}strip({scene:t},e){let{verdict:i}=t.header;if(!i)return null;let{state:s,text:r,governing:a,more:o}=i;return x("div",{class:`verdict ${s}`},x("span",{class:"headline"},x("b",{class:"sign","aria-hidden":!0},fS[s]),x("b",{},this.app.views.length>1?`${this.app.labels[e]}: ${r}`:r)),a?x("button",{type:"button",class:"governing",title:"Show this member and instant",onclick:()=>this.go(t,a)},s==="open"?`highest of what was checked: ${a.text}`:a.text):null,o.length?x("span",{},o.join("; ")):null)}go(t,e){let{app:i}=this;if(i.pause(),t.cases.includes(e.load_case)&&i.setCase(e.load_case),e.kind==="member"&&t.channel("utilisation")&&i.setChannel("utilisation"),e.time!==null&&i.goTo(i.lead.frameAt(e.time)),e.kind==="quantity")return i.pick(null);let s=t.header.drives.find(r=>r.name===e.name);t.members.includes(e.member)?i.pick({type:"member",name:e.member}):s?.member!==void 0?i.pick({type:"member",name:t.members[s.member]}):s&&i.pick({type:"node",name:t.nodes[s.node??s.start]})}};var Ym={type:"change"},_d={type:"start"},jm={type:"end"},Nc=new Yn,Zm=new gi,pS=Math.cos(70*Fu.DEG2RAD),Ge=new I,di=2*Math.PI,de={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},xd=1e-6,Lc=class extends ra{constructor(t,e=null){super(t,e),this.state=de.NONE,this.target=new I,this.cursor=new I,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Xi.ROTATE,MIDDLE:Xi.DOLLY,RIGHT:Xi.PAN},this.touches={ONE:$i.ROTATE,TWO:$i.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new I,this._lastQuaternion=new je,this._lastTargetPosition=new I,this._quat=new je().setFromUnitVectors(t.up,new I(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new $s,this._sphericalDelta=new $s,this._scale=1,this._panOffset=new I,this._rotateStart=new it,this._rotateEnd=new it,this._rotateDelta=new it,this._panStart=new it,this._panEnd=new it,this._panDelta=new it,this._dollyStart=new it,this._dollyEnd=new it,this._dollyDelta=new it,this._dollyDirection=new I,this._mouse=new it,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=gS.bind(this),this._onPointerDown=mS.bind(this),this._onPointerUp=xS.bind(this),this._onContextMenu=wS.bind(this),this._onMouseWheel=yS.bind(this),this._onKeyDown=bS.bind(this),this._onTouchStart=MS.bind(this),this._onTouchMove=SS.bind(this),this._onMouseDown=_S.bind(this),this._onMouseMove=vS.bind(this),this._interceptControlDown=TS.bind(this),this._interceptControlUp=ES.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=de.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Ym),this.update(),this.state=de.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Ge.copy(e).sub(this.target),Ge.applyQuaternion(this._quat),this._spherical.setFromVector3(Ge),this.autoRotate&&this.state===de.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=di:i>Math.PI&&(i-=di),s<-Math.PI?s+=di:s>Math.PI&&(s-=di),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Ge.setFromSpherical(this._spherical),Ge.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ge),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=Ge.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new I(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new I(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Ge.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Nc.origin.copy(this.object.position),Nc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Nc.direction))<pS?this.object.lookAt(this.target):(Zm.setFromNormalAndCoplanarPoint(this.object.up,this.target),Nc.intersectPlane(Zm,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>xd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>xd||this._lastTargetPosition.distanceToSquared(this.target)>xd?(this.dispatchEvent(Ym),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?di/60*this.autoRotateSpeed*t:di/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ge.setFromMatrixColumn(e,0),Ge.multiplyScalar(-t),this._panOffset.add(Ge)}_panUp(t,e){this.screenSpacePanning===!0?Ge.setFromMatrixColumn(e,1):(Ge.setFromMatrixColumn(e,0),Ge.crossVectors(this.object.up,Ge)),Ge.multiplyScalar(t),this._panOffset.add(Ge)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ge.copy(s).sub(this.target);let r=Ge.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,a=i.width,o=i.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(di*this._rotateDelta.x/e.clientHeight),this._rotateUp(di*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(di*this._rotateDelta.x/e.clientHeight),this._rotateUp(di*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(t.pageX+e.x)*.5,o=(t.pageY+e.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new it,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function mS(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function gS(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function xS(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(jm),this.state=de.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function _S(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Xi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=de.DOLLY;break;case Xi.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=de.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=de.ROTATE}break;case Xi.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=de.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=de.PAN}break;default:this.state=de.NONE}this.state!==de.NONE&&this.dispatchEvent(_d)}function vS(n){switch(this.state){case de.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case de.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case de.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function yS(n){this.enabled===!1||this.enableZoom===!1||this.state!==de.NONE||(n.preventDefault(),this.dispatchEvent(_d),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(jm))}function bS(n){this.enabled!==!1&&this._handleKeyDown(n)}function MS(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case $i.ROTATE:if(this.enableRotate===!1){this.state=de.NONE;break}this._handleTouchStartRotate(n),this.state=de.TOUCH_ROTATE;break;case $i.PAN:if(this.enablePan===!1){this.state=de.NONE;break}this._handleTouchStartPan(n),this.state=de.TOUCH_PAN;break;default:this.state=de.NONE}break;case 2:switch(this.touches.TWO){case $i.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=de.TOUCH_DOLLY_PAN;break;case $i.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=de.TOUCH_DOLLY_ROTATE;break;default:this.state=de.NONE}break;default:this.state=de.NONE}this.state!==de.NONE&&this.dispatchEvent(_d)}function SS(n){switch(this._trackPointer(n),this.state){case de.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case de.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case de.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case de.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=de.NONE}}function wS(n){this.enabled!==!1&&n.preventDefault()}function TS(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function ES(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var vd=[.35,1.2],AS="5.0",CS=.6;function RS(){let n=new ci({color:"#ffffff"});return n.userData={stripe:{value:new Nt}},n.onBeforeCompile=t=>{Object.assign(t.uniforms,n.userData),t.vertexShader=`attribute float hatch;
varying float vHatch;
varying float vAlong;
${t.vertexShader}`.replace("#include <begin_vertex>",`#include <begin_vertex>
      vHatch = hatch;
      vAlong = position.y * length(instanceMatrix[1].xyz) / (${AS} * max(length(instanceMatrix[0].xyz), length(instanceMatrix[2].xyz)));`),t.fragmentShader=`varying float vHatch;
varying float vAlong;
uniform vec3 stripe;
${t.fragmentShader}`.replace("#include <color_fragment>",`#include <color_fragment>
if (vHatch > 0.5 && fract(vAlong) < 0.4) diffuseColor.rgb = stripe;`)},n}function yd(n){return n.material=RS(),n.geometry.setAttribute("hatch",new Zn(new Float32Array(n.instanceMatrix.count),1)),n}var Dc=class{constructor(t,e=[]){this.size={value:new it(1,1)},this.width={value:vd[1]},[this.material,this.sides]=["","if (abs(normal.y) > 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);"].map(i=>this.outline(i)),this.meshes=t.filter(i=>i.count).map(i=>{let s=new Hi(i.geometry,e.includes(i)?this.sides:this.material,i.count);return s.instanceMatrix=i.instanceMatrix,s.frustumCulled=!1,s})}outline(t){let e=new Vi({side:ke});return e.customProgramCacheKey=()=>`rim ${t}`,e.onBeforeCompile=i=>{Object.assign(i.uniforms,{rimSize:this.size,rimWidth:this.width}),i.vertexShader=`uniform vec2 rimSize;
uniform float rimWidth;
${i.vertexShader}`.replace("#include <project_vertex>",`#include <project_vertex>
        vec3 rimNormal = mat3(modelViewMatrix) * mat3(instanceMatrix) * normal;
        vec2 rimAway = (projectionMatrix * vec4(rimNormal, 0.0)).xy * rimSize;
        gl_Position.xy += rimAway / max(length(rimAway), 1e-20) * 2.0 * rimWidth / rimSize * gl_Position.w;
        ${t}`)},e}setColour(t){for(let e of[this.material,this.sides])e.color.set(t)}setScale(t){this.width.value=Math.min(Math.max(CS*t,vd[0]),vd[1])}resize(t,e){this.size.value.set(t,e)}};var Km=new Nt(hi.driven),PS=.3,IS=new Nt(Yd);function NS(n){let t=.011*n.length0,e=.05*n.length0;return Float32Array.from(n.arrays.radius.data,i=>Math.min(e,Math.max(t,i||0)))}function LS(n,t){let e=n.arrays.box?.data;return n.members.map((i,s)=>{let r=e?[e[2*s],e[2*s+1]]:[NaN];if(!r.every(o=>o>0)||n.active.has(s))return null;let a=t[s]/Math.max(...r);return r.map(o=>Math.max(a*o,.2*t[s]))})}var Uc=class{constructor(t){this.scene=t,this.radius=NS(t);let e=t.members.length>800;this.pieces=t.members.flatMap((a,o)=>t.active.has(o)?[[o,"base"],[o,"tube"],[o,"screw"]]:t.curves.row.has(o)?Array.from({length:t.curves.places-1},(l,c)=>[o,"beam",c]):[[o,t.header.kinds[o]]]),this.box=LS(t,this.radius);let i=this.pieces.filter(([a])=>this.box[a]),s=this.pieces.filter(([a])=>!this.box[a]);this.pieces=[...s,...i],this.round=s.length,this.firstPiece=[],this.pieces.forEach(([a],o)=>this.firstPiece[a]??=o),this.marks=t.members.flatMap((a,o)=>FS(t,o)),this.rods=yd(rs(s.length,e?6:14)),this.boxes=yd(cm(i.length)),this.collars=rs(this.marks.length,e?6:18),this.balls=ec(t.nodes.length,e?1:3,"#ffffff"),this.small=OS(t),this.lines=US(this.pieces.length),this.ball=1.55*this.radius.reduce((a,o)=>Math.min(a,o),.02*t.length0);let r=new Nt("#ffffff");this.pieces.forEach((a,o)=>this.at(o).mesh.setColorAt(this.at(o).index,r)),this.marks.forEach((a,o)=>this.collars.setColorAt(o,a.colour)),this.paintNodes("#5b6672"),this.rims=new Dc([this.rods,this.boxes,this.collars,this.balls],[this.rods,this.boxes])}objects(){return[this.rods,this.boxes,this.collars,this.balls,this.lines,...this.rims.meshes]}at(t){return t<this.round?{mesh:this.rods,index:t}:{mesh:this.boxes,index:t-this.round}}setTheme({node:t,outline:e,back:i}){this.paintNodes(t),this.rims.setColour(e);for(let{material:s}of[this.rods,this.boxes])s.userData.stripe.value.set(i)}setScale(t){this.rims.setScale(t);let e=t>PS;for(let i of[this.rods,this.boxes,this.collars,this.balls,...this.rims.meshes])i.visible=e}resize(t,e){this.rims.resize(t,e)}place(t,e){let{scene:i,radius:s}=this,r=i.arrays.rods.data,a=this.lines.geometry.attributes.position,o=new Map;for(let l of i.curves.row.keys())o.set(l,{pieces:DS(Ti(i.curves.points(t,l)),.3*s[l]),across:i.curves.across(t,l)});this.pieces.forEach(([l,c,h],u)=>{let[d,f]=o.get(l)?.pieces[h]||[t[i.ends[2*l]],t[i.ends[2*l+1]]],p=i.shows(l)?s[l]:0;a.array.set(d,6*u),a.array.set(p?f:d,6*u+3),u>=this.round&&p?um(this.boxes,u-this.round,d,f,o.get(l)?.across[h]||Ea(i,e,l).axes[1],this.box[l]):c==="base"?Ei(this.rods,u,d,sr(d,f,Math.min(r[6*l+1],Oc(d,f))),.75*p):c==="tube"?Ei(this.rods,u,sr(f,d,Math.min(r[6*l+4],Oc(d,f))),f,1.5*p):Ei(this.rods,u,d,f,c==="free"||c==="screw"||c==="cable"?.35*p:c==="elastic"?.7*p:p)}),this.marks.forEach((l,c)=>{let h=t[i.ends[2*l.member]],u=t[i.ends[2*l.member+1]],d=Oc(h,u),f=s[l.member],p=l.nut?Math.max(0,d-r[6*l.member+4]):l.place*d,v=l.half*f;Ei(this.collars,c,sr(h,u,p-v),sr(h,u,p+v),l.width*f)}),t.forEach((l,c)=>Qs(this.balls,c,l,this.ball*this.small[c])),a.needsUpdate=!0,[this.rods,this.boxes,this.collars,this.balls].forEach(Nn)}paint(t,e){let i=new Nt,s=this.lines.geometry.attributes.color;this.pieces.forEach(([r],a)=>{let[o,l,c]=t(r),{mesh:h,index:u}=this.at(a);h.setColorAt(u,i.setRGB(o/255,l/255,c/255,"srgb")),h.geometry.attributes.hatch.array[u]=e(r)?1:0;for(let d of[0,1])i.toArray(s.array,6*a+3*d)}),s.needsUpdate=!0;for(let r of[this.rods,this.boxes])r.geometry.attributes.hatch.needsUpdate=!0,r.instanceColor&&(r.instanceColor.needsUpdate=!0)}hatchOf(t){let{mesh:e,index:i}=this.at(this.firstPiece[t]);return e.geometry.attributes.hatch.array[i]===1}paintNodes(t){let e=new Nt(t);for(let i=0;i<this.scene.nodes.length;i++)this.balls.setColorAt(i,e);this.balls.instanceColor&&(this.balls.instanceColor.needsUpdate=!0)}colourOf(t){let e=new Nt,{mesh:i,index:s}=this.at(this.firstPiece[t]);i.getColorAt(s,e);let{r,g:a,b:o}=e.getRGB({r:0,g:0,b:0},"srgb");return[r,a,o].map(l=>Math.round(255*l))}};function DS(n,t){return n.map(([e,i],s)=>[s?sr(e,i,-t):e,s<n.length-1?sr(i,e,-t):i])}function OS(n){let t=new Float32Array(n.nodes.length).fill(1),e=new Set(n.ends),i=new Set(n.skin);for(let s of i)e.has(s)||(t[s]=i.size>300?0:.6);for(let s of n.directors)t[s]=0;return t}function US(n){let t=new Me;for(let i of["position","color"])t.setAttribute(i,new Ne(new Float32Array(6*n),3));let e=new Si(t,new li({vertexColors:!0}));return e.frustumCulled=!1,e}function FS(n,t){if(n.active.has(t))return[{member:t,nut:!0,half:1.6,width:2.2,colour:Km}];let e=n.header.kinds[t];return e==="driven"?[{member:t,place:.5,half:2.2,width:1.8,colour:Km}]:e!=="elastic"?[]:[.3,.4,.5,.6,.7].map(i=>({member:t,place:i,half:.3,width:1.7,colour:IS}))}function Oc(n,t){return Math.hypot(t[0]-n[0],t[1]-n[1],t[2]-n[2])}function sr(n,t,e){let i=e/(Oc(n,t)||1);return[n[0]+i*(t[0]-n[0]),n[1]+i*(t[1]-n[1]),n[2]+i*(t[2]-n[2])]}var kS="#ffb000",Fc=class{constructor(t){this.bars=t,this.group=new Fe;let e=new Vi({color:kS,side:ke});this.bar=new Hi(new ln(1,1,1,18,1,!0),e,Math.max(1,t.scene.curves.places-1)),this.ball=new Hi(new Kn(1,3),e,1);for(let i of[this.bar,this.ball])i.frustumCulled=i.visible=!1,this.group.add(i)}place(t,e){let{bars:i}=this;if(this.bar.visible=e?.type==="member",this.ball.visible=e?.type==="node",this.bar.visible){let{active:s,curves:r}=i.scene,a=e.index,o=Ti(r.points(t,a)),l=i.radius[a]*(s.has(a)?2.9:1.9);o.forEach(([c,h],u)=>Ei(this.bar,u,c,h,l)),this.bar.count=o.length}this.ball.visible&&Qs(this.ball,0,t[e.index],1.7*i.ball),[this.bar,this.ball].forEach(Nn)}};var Jm=24,kc=class{constructor(t,e){this.scene=t,this.group=new Fe,this.material=new ci({side:ii,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),this.ink=new li({}),this.plates=t.header.bodies.map((s,r)=>this.plate(s,e,r)),this.hulls=t.header.solids||[];let i=new Me;i.setAttribute("position",new Ne(new Float32Array(9*this.hulls.length),3)),this.hull=new Pe(i,this.material),this.hull.frustumCulled=!1,this.group.add(this.hull)}setTheme({body:t,outline:e}){this.material.color.set(t),this.ink.color.set(e)}plate(t,e,i){let s=this.scene.length(0,t.member),r=1.9*e,a=.5*e,o=BS([[0,0],[s,0],t.center],r),l=new Kr(new Hs(o.map(([h,u])=>new it(h,u))),{depth:a,bevelEnabled:!1,steps:1});l.translate(0,0,-a*(.5+.02*i));let c=new Fe;return c.add(new Pe(l,this.material),new Si(new Vr(l,50),this.ink)),this.group.add(c),{body:t,plate:c}}place(t){let{scene:e}=this;for(let{body:s,plate:r}of this.plates){let a=t[e.ends[2*s.member]],o=t[e.ends[2*s.member+1]];r.position.set(...a),r.rotation.z=Math.atan2(o[1]-a[1],o[0]-a[0])}if(!this.hulls.length)return;let{position:i}=this.hull.geometry.attributes;this.hulls.forEach((s,r)=>s.forEach((a,o)=>i.array.set(t[a],9*r+3*o))),i.needsUpdate=!0,this.hull.geometry.computeVertexNormals()}};function BS(n,t){let e=n.flatMap(([s,r])=>Array.from({length:Jm},(a,o)=>{let l=2*Math.PI*o/Jm;return[s+t*Math.cos(l),r+t*Math.sin(l)]}));e.sort((s,r)=>s[0]-r[0]||s[1]-r[1]);let i=s=>{let r=[];for(let a of s){for(;r.length>1&&zS(r[r.length-2],r[r.length-1],a)<=0;)r.pop();r.push(a)}return r.slice(0,-1)};return[...i(e),...i(e.reverse())]}function zS(n,t,e){return(t[0]-n[0])*(e[1]-n[1])-(t[1]-n[1])*(e[0]-n[0])}var bd=104,GS=[["x",[1,0,0],"#c0392b"],["y",[0,1,0],"#2e8b57"],["z",[0,0,1],"#2f6fc1"]],Bc=class{constructor(t){this.world=new qn,this.camera=new Ze(30,1,.1,20);let e=new Jn("#ffffff",1.5);e.position.set(1,-2,3),this.world.add(new Qn("#ffffff",1.8),e),this.letters=GS.slice(0,t.dim).map(([i,s,r])=>this.add(i,s,r,.05)),this.gravity=this.add("g",[0,0,1],"#8a949e",.07),this.letters.push(this.gravity),this.setGravity(t.header.gravity)}add(t,e,i,s){let r=va(i),a=new Ur(new Bs({depthTest:!1}));return tr(r,[0,0,0],e,s),a.position.set(...e.map(o=>1.27*o)),a.scale.setScalar(.44),this.world.add(r,a),{name:t,letter:a,one:r}}setGravity(t){let e=[0,1,2].map(a=>t[a]||0),i=Math.hypot(...e),{one:s,letter:r}=this.gravity;r.visible=i>0,this.pull=new I(...e).multiplyScalar(1.08/(i||1)),tr(s,[0,0,0],e.map(a=>.85*a/(i||1)),.07)}setTheme(t){for(let{name:e,letter:i}of this.letters)i.material.map?.dispose(),i.material.map=VS(e,Xe[t].ink),i.material.needsUpdate=!0}render(t,e){let i=t.getPixelRatio(),s=t.domElement,r=s.width/i;this.camera.position.set(0,0,5.6).applyQuaternion(e.quaternion),this.camera.quaternion.copy(e.quaternion);let a=new I(-.95,0,0).applyQuaternion(e.quaternion);this.gravity.one.position.copy(a),this.gravity.letter.position.copy(this.pull).add(a),t.setViewport(r-bd-4,4,bd,bd),t.clearDepth(),t.render(this.world,this.camera),t.setViewport(0,0,r,s.height/i)}};function VS(n,t){let e=document.createElement("canvas");e.width=e.height=64;let i=e.getContext("2d");return i.font="600 46px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle",i.fillStyle=t,i.fillText(n,32,34),new Br(e)}var HS=.8,WS=2e4,XS=104;function Md({scene:n,loads:t,supports:e,beside:i=[]}){let s=[...i],r=Math.max(1,Math.ceil(n.frames*n.nodes.length/WS)),a=n.frames-1;for(let o=0;o<=a;o=o<a?Math.min(o+r,a):o+1){for(let l=0;l<n.nodes.length;l++)n.directors.has(l)||s.push(n.position(o,l));s.push(...t.tips(o),...e.feet(o))}return s}function Sd({scene:n,camera:t,canvas:e},i,s,r=HS,a=XS){let o=new I().crossVectors(t.up,i);o.length()<.001&&o.set(1,0,0),o.normalize();let l=new I().crossVectors(i,o),c=Math.tan(t.fov*Math.PI/360),h=t.aspect,u=Math.min(a/(e.clientHeight||1e3),.25),d=c*h*r,f=c*(r-u),p=s.map(w=>{let b=new I(...w);return[b.dot(o),b.dot(l),b.dot(i)]}),v=[0,1,2].map(w=>(p.reduce((b,C)=>Math.min(b,C[w]),1/0)+p.reduce((b,C)=>Math.max(b,C[w]),-1/0))/2),m=n.extent.size;for(let w=0;w<4;w++){m=p.reduce((b,[C,E,_])=>Math.max(b,Math.abs(C-v[0])/d+_-v[2],Math.abs(E-v[1])/f+_-v[2]),.05*n.extent.size);for(let b of[0,1]){let C=p.map(E=>(E[b]-v[b])/(m-E[2]+v[2]));w<3&&(v[b]+=m*(C.reduce((E,_)=>Math.min(E,_),1/0)+C.reduce((E,_)=>Math.max(E,_),-1/0))/2)}}let g=p.reduce((w,b)=>Math.max(w,(b[1]-v[1])/(m-b[2]+v[2])/c),0);return v[1]+=Math.max(0,g-r+2*u)*c*m,{centre:new I().addScaledVector(o,v[0]).addScaledVector(l,v[1]).addScaledVector(i,v[2]),far:m}}function Qm(){return!!document.createElement("canvas").getContext("webgl2")}var rr=class extends er{constructor(t,e,i,s=e.members.length<2e3){super(t,e),this.renderer=new Zl({canvas:t,antialias:s,preserveDrawingBuffer:!0}),this.renderer.autoClear=!1,this.world=new qn,this.camera=new Ze(32,1,e.extent.size/500,e.extent.size*60),this.camera.up.set(0,e.dim===2?1:0,e.dim===2?0:1),this.lamp=new Jn("#ffffff",2.1),this.lampPlace=[-.35,.6,1],this.ambient=new Qn("#ffffff",1.45),this.world.add(this.ambient,this.lamp),this.controls=new Lc(this.camera,t),e.dim===2&&(this.controls.enableRotate=!1,this.controls.mouseButtons.LEFT=Xi.PAN,this.controls.touches.ONE=$i.PAN),this.controls.addEventListener("change",()=>this.onCamera?.(this)),this.triad=new Bc(e),this.build(),this.setTheme(i),this.aim(e.dim===2?"plane":"corner"),this.setFrame(0)}build(){let{scene:t,world:e}=this,i=.1*t.length0;this.bars=new Uc(t),this.supports=new sc(t),this.loads=new ya(t,.9*i),this.drives=new rc(t,i),this.bodies=new kc(t,this.bars.ball),this.traces=new ir(t),this.centres=new oc(t,.25*i),this.faces=new ac(t,t.header.triangles,.35),this.faces.mesh.visible=!1,this.skins=new Ql(t),this.halo=new Fc(this.bars),Object.assign(this,gm(t)),this.ghost=xm(t),this.ghost.visible=!1,e.add(...this.bars.objects(),this.supports.mesh,this.loads.group,this.drives.group,this.bodies.group,this.centres.mesh,this.faces.mesh,this.traces.group,...this.skins.objects(),this.halo.group,this.grid,this.ghost)}rebuildLoads(){this.world.remove(this.loads.group),this.loads=new ya(this.scene,.09*this.scene.length0),this.world.add(this.loads.group),this.triad.setGravity(this.scene.header.gravity)}setTheme(t){this.renderer.setClearColor(new Nt(Xe[t].back));for(let e of[this.bars,this.supports,this.bodies,this.traces])e.setTheme(Xe[t]);this.skins.setTheme(t),this.triad.setTheme(t),this.paint()}move(){this.now=this.points(),[this.bars,this.supports,this.drives,this.bodies,this.centres,this.faces,this.skins].forEach(t=>t.place(this.now,this.frame)),this.loads.place(this.now,this.frame),this.halo.place(this.now,this.picked),this.request()}pick(t){this.picked=t,this.halo.place(this.now,t),this.request()}paint(){this.bars.paint(t=>this.shade(t),t=>this.hatched(t)),this.skins.paint(this.channel,this.frame,this.limits),this.request()}showTraces(t){this.traces.show(t),this.request()}aim(t){let{scene:e,camera:i,controls:s}=this,r=new I(...lc[t]).normalize(),{centre:a,far:o}=Sd(this,r,Md(this));i.position.copy(a).addScaledVector(r,o),s.target.copy(a),s.update(),this.preset=t,this.request()}orbit(t,e,i){let{camera:s,controls:r}=this,a=s.position.clone().sub(r.target);a.applyAxisAngle(s.up,t);let o=new I().crossVectors(s.up,a).normalize(),l=a.clone().applyAxisAngle(o,-e);Math.abs(l.clone().normalize().dot(s.up))<.995&&a.copy(l),s.position.copy(r.target).addScaledVector(a,i),r.update(),this.request()}copyCamera(t){this.camera.position.copy(t.camera.position),this.controls.target.copy(t.controls.target),this.camera.lookAt(this.controls.target),this.request()}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(Math.min(window.devicePixelRatio,2)),this.renderer.setSize(t,e,!1),this.bars.resize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),!this.sized&&this.preset&&this.aim(this.preset),this.sized=!0,this.request())}end(){this.ended=!0,this.controls.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss()}render(){if(cancelAnimationFrame(this.waiting),this.waiting=0,this.ended)return;let{renderer:t,camera:e}=this;this.lamp.position.set(...this.lampPlace).applyQuaternion(e.quaternion);let i=e.position.distanceTo(this.controls.target),s=2*i*Math.tan(e.fov*Math.PI/360)/this.canvas.clientHeight;this.bars.setScale(this.bars.ball/1.55/s),t.clear(),t.render(this.world,e),this.triad.render(t,e),this.drawn=(this.drawn||0)+1,this.onDrawn?.(this)}project(t){let{clientWidth:e,clientHeight:i}=this.canvas,s=new I(...t).project(this.camera);return[(s.x+1)/2*e,(1-s.y)/2*i,s.z]}};var zc=24,$S=.08;function qS(n){return n.header.triangles.length>0&&n.arrays.radius.data.every(Number.isNaN)}var Ln=class extends Cc{constructor(t,e,i=[],s=null){super(),Object.assign(this,{root:t,side:s,ended:new AbortController}),Object.assign(this,{channel:null,limits:[0,1],picked:null,mode:-1,labels:i}),this.shown={ghost:!1,names:e[0].nodes.length<=12,loads:!0,supports:!0,grid:!0,faces:e.every(qS),paths:!1},this.paths=new Set,this.touch=matchMedia("(hover: none)").matches,this.theme=t.dataset.theme||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"),t.dataset.theme=this.theme,this.setLead(e.reduce((o,l)=>l.time[l.frames-1]>o.time[o.frames-1]?l:o));let r=e.map((o,l)=>x("canvas",{tabindex:0,role:"img","aria-label":`picture of ${i[l]||o.header.title||"the model"}`}));this.diagram=null,this.offered=[...new Map(e.flatMap(o=>o.header.shows||[]).map(o=>[o.id,o])).values()],this.flat=!Qm();let a=this.flat?uc:rr;this.views=e.map((o,l)=>new a(r[l],o,this.theme)),this.layout(r),this.wire(),Dm(this,t.ownerDocument,this.ended.signal),this.setChannel(e[0].header.channels[0]?.id||""),this.table.show(),this.pick(null),this.apply(),this.goTo(0)}hint(t,e){return this.touch?t:`${t} (${e})`}layout(t){let{views:e}=this;this.bar=new Pc(this),this.verdict=new Ic(this),this.time=new Ec(this),this.legend=new bc(this),this.inspector=new vc(this),this.table=new Rc(this),this.names=e.map(s=>new Sc(s)),this.over=e.map(s=>new Tc(s));let i=t.map((s,r)=>x("div",{class:"pane"},s,this.over[r].node,this.names[r].node,e.length>1?x("div",{class:"label"},this.labels[r]):null,x("div",{class:"scale"},`grid ${$t(e[r].step,"m")}`)));this.told=x("p",{class:"told",role:"note","aria-live":"polite"}),this.panel=x("aside",{class:"panel"},this.inspector.node,this.table.node),this.stage=x("div",{class:"stage"},x("div",{class:"panes"},i),this.legend.node,x("div",{class:"said"},this.flat?x("p",{class:"note"},"This browser has no WebGL: a plain picture, turned by the buttons."):null,this.told)),this.help=Om(this),this.root.replaceChildren(this.bar.node,this.verdict.node,x("main",{},this.side,this.stage,this.panel),this.time.node,this.help)}wire(){let t=new ResizeObserver(()=>this.resize());this.ended.signal.addEventListener("abort",()=>t.disconnect()),this.views.forEach((e,i)=>{t.observe(e.canvas.parentElement),e.onCamera=()=>this.follow(e),e.onDrawn=()=>{this.over[i].place(this.diagram),this.names[i].place(this.shown.names,this.over[i].boxes)};let s=null;e.canvas.addEventListener("pointerdown",r=>s=[r.clientX,r.clientY]),e.canvas.addEventListener("pointerup",r=>{s&&Math.hypot(r.clientX-s[0],r.clientY-s[1])<5&&this.click(e,r),s=null})}),this.resize()}refresh(){for(let e of this.views)e.scene.renew();this.verdict.update();let{channel:t}=this;t&&hr(t.scale,this.views.map(i=>i.scene.range(t.id))).some((i,s)=>i!==this.limits[s])&&this.setChannel(t.id),this.goTo(this.index)}end(){this.playing=!1,this.mode=-1,this.ended.abort();for(let t of this.views)t.end()}resize(){this.views.forEach(t=>t.resize()),this.inspector.update()}goTo(t){this.index=Math.min(Math.max(Math.round(t),0),this.lead.frames-1);let e=this.lead.time[this.index];for(let i of this.views)i.setFrame(i.scene===this.lead?this.index:i.scene.frameAt(e));this.time.update(),this.inspector.update(),this.table.update()}toWorst(){let{lead:t,channel:e}=this;if(!e||!t.channel(e.id))return;let i=[-1,0];for(let s=0;s<t.frames;s++){for(let r=0;r<t.members.length;r++){let a=Math.abs(t.value(e.id,s,r));a>i[0]&&(i=[a,s])}for(let r=0;t.coloursFaces(e.id)&&r<t.faces;r++){let a=t.faceValue(e.id,s,r);a>i[0]&&(i=[a,s])}}this.pause(),this.goTo(i[1])}setChannel(t){let e=this.views.map(i=>i.scene).filter(i=>i.channel(t));this.channel=e.length?e[0].channel(t):null,this.channel&&(this.limits=hr(this.channel.scale,e.map(i=>i.range(t))));for(let i of this.views)i.setColours(this.channel,this.limits);this.legend.show(),this.bar.update(),this.views.length>1&&this.table.show(),this.inspector.update()}setDiagram(t){let e=this.offered.find(a=>a.id===t)||null;this.diagram=e,this.views.forEach((a,o)=>{a.beside=this.over[o].reach(e);let{clientWidth:l,clientHeight:c}=a.canvas,[h]=pd(this.over[o].node),u=([d,f])=>h&&d<h[2]&&f<h[3]||d<zc||f<zc||d>l-zc||f>c-zc;a.beside.some(d=>u(a.project(d)))&&a.aim(a.preset),a.request()});let i=e?.id==="deflection"?`, drawn ${this.over.map(a=>ue(a.factor(e))).join(" and ")} times as large`:"",s=e?[...new Set(this.views.flatMap(({scene:a,frame:o})=>zm(a,o,e)))]:[],r=s.length?`; not known of ${s.slice(0,4).join(", ")}${s.length>4?` and ${s.length-4} more`:""}`:"";this.told.textContent=e?`${e.label}: ${e.sign}${i}${r}.`:"",this.bar.update()}nextDiagram(t){let e=["",...this.offered.map(i=>i.id)];this.setDiagram(e[(e.indexOf(this.diagram?.id||"")+t+e.length)%e.length])}setCase(t){for(let e of this.views)e.scene.choose(t)&&e.rebuildLoads();this.setChannel(this.channel?.id||""),this.apply(),this.inspector.show(),this.goTo(this.index),this.diagram&&this.setDiagram(this.diagram.id)}nextCase(){let{cases:t,header:e}=this.views[0].scene;t.length>1&&this.setCase(t[(t.indexOf(e.load_case)+1)%t.length])}nextChannel(t){let e=["",...this.views[0].scene.header.channels.map(s=>s.id)],i=e.indexOf(this.channel?.id||"");this.setChannel(e[(i+t+e.length)%e.length])}setMode(t){let{modes:e}=this.views[0].scene.header;this.mode=t<e.length?t:-1;let i=this.views[0],s=this.mode>=0;if(i.mode=s?{array:e[this.mode].array,size:0}:null,this.bar.update(),i.move(),!s)return;let a=i.scene.arrays[i.mode.array].data.reduce((h,u)=>Math.max(h,Math.abs(u)),0)||1,o=performance.now(),l=this.mode,c=h=>{this.mode===l&&(i.mode.size=$S*i.scene.extent.size/a*Math.sin((h-o)/1e3*2.5),i.move(),i.render(),requestAnimationFrame(c))};requestAnimationFrame(c)}nextMode(){let t=this.views[0].scene.header.modes.length;t&&this.setMode(this.mode+1<t?this.mode+1:-1)}toggle(t){this.shown[t]=!this.shown[t],this.apply()}apply(){for(let t of this.views)t.ghost.visible=this.shown.ghost,t.loads.group.visible=this.shown.loads,t.supports.mesh.visible=this.shown.supports,t.grid.visible=this.shown.grid,t.faces.mesh.visible=this.shown.faces,t.showTraces(this.tracedIn(t)),t.canvas.parentElement.classList.toggle("gridless",!this.shown.grid),t.request();this.bar.update()}togglePanel(){this.root.classList.toggle("wide"),this.resize()}toggleTheme(){this.theme=this.theme==="dark"?"light":"dark",this.root.dataset.theme=this.theme;for(let t of this.views)t.setTheme(this.theme);this.inspector.update()}toggleHelp(){this.help.hidden=!this.help.hidden,this.help.hidden?this.before?.focus?.():(this.before=this.root.ownerDocument.activeElement,this.help.querySelector("button").focus())}pick(t){this.picked=t;for(let e of this.views){let i=t?this.indexIn(e,t):-1;e.pick(i<0?null:{type:t.type,index:i})}this.panel.classList.toggle("picked",!!t),this.inspector.show(),this.table.mark(),this.onPick?.(t)}indexIn(t,e){return t.scene[e.type==="member"?"members":"nodes"].indexOf(e.name)}click(t,e){let i=t.canvas.getBoundingClientRect(),s=t.pickAt(e.clientX-i.left,e.clientY-i.top,e.pointerType==="touch");this.pick(s&&{type:s.type,name:t.scene[`${s.type}s`][s.index]})}pickNext(t,e){let i=this.views[0].scene[`${t}s`];if(!i.length)return;let s=this.picked?.type===t?i.indexOf(this.picked.name):e>0?-1:0;this.pick({type:t,name:i[(s+e+i.length)%i.length]})}pickWorst(){let{scene:t,frame:e}=this.views[0];if(!this.channel)return;let i=[-1,0];t.members.forEach((s,r)=>{let a=Math.abs(t.value(this.channel.id,e,r));a>i[0]&&(i=[a,r])}),t.members.length&&this.pick({type:"member",name:t.members[i[1]]})}toggleTrace(){if(this.picked?.type!=="node"||this.lead.frames<2)return;let{name:t}=this.picked;this.paths.delete(t)||this.paths.add(t),this.apply(),this.inspector.update()}tracedIn(t){return this.shown.paths&&(t.moving??=_m(t.scene)),new Set([...this.shown.paths?t.moving:[],...[...this.paths].map(e=>t.scene.nodes.indexOf(e)).filter(e=>e>=0)])}find(){this.root.classList.remove("wide"),this.table.filter.focus()}escape(){this.help.hidden?this.pick(null):this.toggleHelp()}aim(t){for(let e of this.views)e.aim(e.scene.dim===2?"plane":t)}orbit(t,e,i){let s=this.views[0].scene.dim===3;this.views[0].orbit(s?t:0,s?e:0,i)}follow(t){t.request();for(let e of this.views)e!==t&&e.copyCamera(t)}diagrams(t,e=0){let{scene:i,frame:s}=this.views[e];return rd(i,s,i.members.indexOf(t))}freeBody(t,e=0){let{scene:i,frame:s}=this.views[e];return _c(i,s,i.members.indexOf(t))}};var Gc=class{constructor(t){Object.assign(this,{show:t,words:"",timer:0})}wait(t,e){let i=performance.now()-e;this.words&&i>=200||(this.end(),this.timer=setTimeout(()=>this.say(t),Math.max(40,200-i)))}say(t){clearTimeout(this.timer),this.words=t,this.show(t)}end(){clearTimeout(this.timer),this.words&&this.say("")}};var YS=2e3,ZS="The studio does not answer. Start it again, and open the address that it prints.";function tg(n){let t=new DataView(n).getUint32(0,!0);return[JSON.parse(new TextDecoder().decode(new Uint8Array(n,4,t))),new Uint8Array(n,4+t)]}var ar=class{constructor(t){Object.assign(this,{root:t,waiting:null,queue:[],wanted:null,closed:!1}),this.doing=x("p",{class:"busy",hidden:!0}),this.busy=new Gc(e=>this.showBusy(e))}ask(t,e=performance.now()){return new Promise(i=>{this.queue.push({command:t,resolve:i,since:e}),this.pump()})}pump(){if(!this.waiting&&!this.closed){let t=this.hurried()||this.queue.shift()||this.leisurely();t&&(this.waiting={resolve:()=>{},since:performance.now(),...t},this.post(JSON.stringify(t.command)))}this.watch()}hurried(){}leisurely(){}watch(){let t=this.waiting||this.queue[0];t?this.busy.wait("Computing ...",t.since):this.busy.end()}showBusy(t){this.doing.hidden=!t,this.doing.textContent=t,this.root.classList.toggle("awaiting",!!t)}async hear(t){let e=typeof t=="string"?JSON.parse(t):await this.unpacked(t);if(e.kind==="failed")return this.fail(e.message);if(e.kind==="busy"){(this.busy.words||!this.there)&&this.busy.say(e.text);return}if(this.heard(e))return this.pump();let{waiting:i}=this;this.waiting=null,i?.resolve(e),this.pump()}connect(){let t=this.page?`&page=${this.page}`:"",e=new WebSocket(`${location.origin.replace(/^http/,"ws")}${location.pathname}live?busy=1${t}`);e.binaryType="arraybuffer",e.addEventListener("open",()=>this.open(i=>e.send(i))),e.addEventListener("message",({data:i})=>this.hear(i)),e.addEventListener("close",()=>this.close())}fail(t,...e){window.kinetruss.failed=t,this.closed=!0,this.root.replaceChildren(x("div",{class:"failure"},x("p",{},t),...e)),this.root.dataset.state="failed"}close(){if(this.root.dataset.state!=="failed"){this.closed=!0;for(let{resolve:t}of[this.waiting,...this.queue].filter(Boolean))t({kind:"lost"});if(Object.assign(this,{waiting:null,queue:[],wanted:null}),this.busy.end(),!this.there)return this.fail(ZS);this.setEnded(!0),setTimeout(()=>this.connect(),YS)}}setEnded(t,e=this.root){e.classList.toggle("ended",t);for(let i of e.querySelectorAll("input, select, button, textarea"))i.disabled=t}};var jS="xyz",Vc={azimuth:-Math.PI/2,elevation:Math.PI/2},eg={corner:[-.95,.5],top:[-Math.PI/2,Math.PI/2],front:[-Math.PI/2,0],side:[0,0]},KS=8,ig=44,wd=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Aa=n=>Number(n.toPrecision(12))||0,Hc=class{constructor(){Object.assign(this,{dim:2,centre:[0,0,0],scale:200,width:600,height:400,plane:{axis:2,at:0},step:null}),this.turnTo(Vc.azimuth,Vc.elevation)}setDim(t){if(t===this.dim)return;this.dim=t,this.plane={axis:2,at:0};let[e,i]=t===3?eg.corner:[Vc.azimuth,Vc.elevation];this.turnTo(e,i)}turnTo(t,e){this.azimuth=t,this.elevation=Math.min(Math.max(e,-Math.PI/2),Math.PI/2);let[i,s,r,a]=[Math.cos(t),Math.sin(t),Math.cos(this.elevation),Math.sin(this.elevation)].map(o=>Math.abs(o)<1e-15?0:o);this.right=[-s,i,0],this.up=[-a*i,-a*s,r],this.toward=[r*i,r*s,a]}turn(t,e){this.dim===3&&this.turnTo(this.azimuth+t,this.elevation+e)}look(t){this.turnTo(...eg[t])}face(){this.look({x:"side",y:"front",z:"top"}[jS[this.plane.axis]])}pan(t,e){this.centre=this.centre.map((i,s)=>i-(t*this.right[s]-e*this.up[s])/this.scale)}zoom(t,[e,i]=[this.width/2,this.height/2]){let[s,r]=[e-this.width/2,i-this.height/2];this.pan(-s,-r),this.scale=Math.min(Math.max(this.scale*t,.001),1e7),this.pan(s,r)}fit(t){if(!t.length){Object.assign(this,{centre:[0,0,0],scale:Math.min(this.width,this.height)/1.2});return}this.centre=[0,1,2].map(s=>(Math.min(...t.map(r=>r[s]||0))+Math.max(...t.map(r=>r[s]||0)))/2),this.scale=1;let e=t.map(s=>this.project(s)),i=[0,1].map(s=>Math.max(...e.map(r=>r[s]))-Math.min(...e.map(r=>r[s])));this.scale=Math.min(.62*this.width/(i[0]||1e-9),.62*this.height/(i[1]||1e-9),1e5),t.length===1&&(this.scale=Math.min(this.width,this.height)/1.2)}project(t){let e=[0,1,2].map(i=>(t[i]||0)-this.centre[i]);return[this.width/2+this.scale*wd(e,this.right),this.height/2-this.scale*wd(e,this.up),wd(e,this.toward)]}unproject([t,e],i=this.plane.at){let[s,r]=[(t-this.width/2)/this.scale,(this.height/2-e)/this.scale],a=this.centre.map((c,h)=>c+s*this.right[h]+r*this.up[h]),{axis:o}=this.plane;if(Math.abs(this.toward[o])<.08)return null;let l=(i-a[o])/this.toward[o];return a.map((c,h)=>h===o?i:c+l*this.toward[h])}get grid(){let t=Gn(ig/this.scale);return this.step||(t*this.scale<.6*ig?Gn(2.5*t):t)}snapped(t,e=[]){return t.map((i,s)=>{if(s===this.plane.axis)return i;let r=Aa(Math.round(i/this.grid)*this.grid),a=e.reduce((o,l)=>Math.abs((l[s]||0)-i)<Math.abs(o-i)?l[s]||0:o,1/0);return Math.abs(a-i)*this.scale<KS&&Math.abs(a-i)<Math.abs(r-i)?a:r})}get across(){return[0,1,2].filter(t=>t!==this.plane.axis)}};var JS=[.5,.38,.62,.26,.74],QS=(n,t)=>n[0]<t[2]&&t[0]<n[2]&&n[1]<t[3]&&t[1]<n[3],ng=(n,t,e)=>[n-1,t-13+3,n+e+1,t+3],Wc=class{constructor(){this.taken=[]}begin(t){this.taken=t.map(([e,i])=>[e-6,i-6,e+6,i+6])}put(t,e,i,s){let r=e.find(([a,o])=>!this.taken.some(l=>QS(l,ng(a,o,i))))||(s?e[0]:null);t.setAttribute("display",r?"inline":"none"),r&&(this.taken.push(ng(...r,i)),t.setAttribute("x",r[0].toFixed(1)),t.setAttribute("y",r[1].toFixed(1)))}node(t,[e,i]){let s=7.4*t.textContent.length;this.put(t,[[e+9,i-9],[e-9-s,i-9],[e+9,i+17],[e-9-s,i+17]],s,!0)}member(t,e,i,s){let r=6.1*t.textContent.length,a=JS.flatMap(o=>{let[l,c]=[e[0]+o*(i[0]-e[0]),e[1]+o*(i[1]-e[1])];return[[l+5,c-5],[l-5-r,c-5],[l+5,c+15],[l-5-r,c+15]]});this.put(t,a,r,s)}};var tw=26;function rg(n,t){return Object.values(n.bodies||{}).map(({nodes:e})=>{let i=(e||[]).map(t).filter(Boolean),s=[0,1].map(o=>i.reduce((l,c)=>l+c[o]/i.length,0)),r=([o,l])=>Math.atan2(l-s[1],o-s[0]),a=i.toSorted((o,l)=>r(o)-r(l));return Ht("path",{class:"body",d:a.length>1?`M${a.map(([o,l])=>`${o.toFixed(1)} ${l.toFixed(1)}`).join("L")}Z`:""})})}function ag(n,t,e){return Object.values(n.springs||{}).map(({coordinate:s})=>{if(s?.kind==="hinge")return sg(t(s.axis?.[0]),t(s.start),t(s.end));let r=s?.kind==="angle"?e(s.bar)?.map(t):null;return r&&r[0]?sg(r[0],[r[0][0]+1,r[0][1]],r[1]):null}).filter(Boolean)}function sg(n,t,e){if(!n||!t||!e)return null;let[i,s]=[t,e].map(([o,l])=>Math.atan2(l-n[1],o-n[0])),r=(s-i+3*Math.PI)%(2*Math.PI)-Math.PI,a=Array.from({length:13},(o,l)=>{let c=tw+(l%2&&l>1&&l<11?5:0)-(l%2===0&&l>1&&l<11?5:0),h=i+r*l/12;return`${(n[0]+c*Math.cos(h)).toFixed(1)} ${(n[1]+c*Math.sin(h)).toFixed(1)}`});return Ht("path",{class:"spring",d:`M${a.join("L")}`})}var ew=60,iw=24,nw=46,sw=80,rw=24,pn=(n,t=!1)=>n.length?`M${n.map(([e,i])=>`${e.toFixed(2)} ${i.toFixed(2)}`).join("L")}${t?"Z":""}`:"",Xc=class{constructor(t){this.draw=t;let e=i=>Ht("g",{class:i});this.layers=Object.fromEntries(["picture","grid","bodies","curve","apart","bars","marks","diagram","nodes","names","rubber"].map(i=>[i,e(i)])),this.node=Ht("svg",{class:"drawing",tabindex:0,role:"application","aria-label":"drawing; arrow keys move the cursor, Enter draws there, Tab leaves"},...Object.values(this.layers)),this.names=new Wc,this.legend=x("div",{class:"legend",hidden:!0}),new ResizeObserver(()=>this.resize()).observe(this.node)}resize(){let{width:t,height:e}=this.node.getBoundingClientRect();!t||!e||(Object.assign(this.draw.camera,{width:t,height:e}),this.node.setAttribute("viewBox",`0 0 ${t} ${e}`),!this.sized&&this.draw.state&&this.draw.fit(),this.sized=!0,this.update())}rebuild(){let{state:t}=this.draw;this.places=new Map,this.bars=t.members.map(({name:e})=>Ht("path",{class:"bar","data-member":e})),this.circles=t.nodes.map(e=>Ht("circle",{class:"node","data-node":e,r:6})),this.labels=t.nodes.map(e=>Ht("text",{class:"name"},e)),this.tags=t.members.map(({name:e})=>Ht("text",{class:"tag"},e)),this.layers.bars.replaceChildren(...this.bars),this.layers.nodes.replaceChildren(...this.circles),this.layers.names.replaceChildren(...this.tags,...this.labels),this.index=new Map(t.nodes.map((e,i)=>[e,i])),this.update()}at(t){return this.seen[this.index.get(t)]}update(){let{state:t,camera:e,picked:i,shown:s}=this.draw;if(!t||!this.bars)return;this.seen=t.places.map(a=>e.project(a)),this.grid(),this.paint(t,i,s);let r=t.nodes.length<=sw;this.layers.names.setAttribute("display",s.names&&r?"inline":"none"),this.circles.forEach((a,o)=>{let[l,c]=this.seen[o];a.setAttribute("cx",l.toFixed(2)),a.setAttribute("cy",c.toFixed(2)),a.classList.toggle("picked",i.nodes.has(t.nodes[o]))}),this.place(t,i,s.names&&r),this.marks(t),this.draw.picture.place(this.layers.picture),this.draw.curves.place(this.layers.curve),this.rubber()}paint(t,e,i){let s=this.draw.stale?null:t.force,r=(s||[]).filter(o=>o!==null).map(Math.abs),a=Math.max(...r,0)||1;this.legend.hidden=!i.force||!r.some(o=>o>0),ce(this.legend,x("b",{},"Force"),x("div",{class:"bar",style:`background: ${Ua("diverging")}`}),x("div",{class:"ticks"},x("span",{},$t(-a,"N")),x("span",{},"0"),x("span",{},$t(a,"N"))),x("div",{class:"words"},x("span",{},"compression"),x("span",{},"tension")),t.unsure.length?x("div",{},"?: not unique, in the colour of its kind"):null),this.bars.forEach((o,l)=>{let{name:c,ends:h,kind:u}=t.members[l],[d,f]=h.map(m=>this.at(m));o.setAttribute("d",pn([d,f]));let p=s?.[l]??null,v=p!==null&&!t.unsure.includes(c);o.style.stroke=i.force&&v?`rgb(${vn("diverging",p,[-a,a]).map(Math.round).join(" ")})`:hi[u]||hi.rigid,o.classList.toggle("picked",e.members.has(c)),o.classList.toggle("apart",c in t.apart),o.classList.toggle("soft",u==="elastic"||u==="cable"||u==="free"),this.tags[l].textContent=i.force&&p!==null?`${c} ${$t(Math.abs(p)<1e-12*a?0:p,"N")}${v?"":" ?"}`:c})}place(t,e,i){if(this.names.begin(this.seen),i&&this.labels.forEach((r,a)=>this.names.node(r,this.seen[a])),this.draw.diagram.place(this.layers.diagram,this.names.taken),!i)return;let s=t.members.map((r,a)=>a).sort((r,a)=>e.members.has(t.members[a].name)-e.members.has(t.members[r].name));for(let r of s){let{name:a,ends:o,goes_on:l}=t.members[r],c=e.members.has(a)&&!l;t.members.length<=rw&&!l||c?this.names.member(this.tags[r],this.at(o[0]),this.at(o[1]),c):this.tags[r].setAttribute("display","none")}}grid(){let{camera:t}=this.draw,[e,i]=t.across,{grid:s}=t,r=t.unproject([t.width/2,t.height/2]);if(!r){this.layers.grid.replaceChildren();return}let a=Math.min(ew,Math.ceil(.75*Math.hypot(t.width,t.height)/t.scale/s)),o=g=>Math.round(r[g]/s)-a,l=(g,M)=>{let w=[0,0,0];return[w[e],w[i],w[t.plane.axis]]=[g*s,M*s,t.plane.at],t.project(w)},[c,h]=[o(e),o(i)],[u,d]=[c+2*a,h+2*a],f={thin:"",axis:""};for(let g=c;g<=u;g++)f[g===0?"axis":"thin"]+=pn([l(g,h),l(g,d)]);for(let g=h;g<=d;g++)f[g===0?"axis":"thin"]+=pn([l(c,g),l(u,g)]);let p=t.project([0,0,0]),v=[..."xyz"].slice(0,t.dim).map((g,M)=>{let w=t.project([0,1,2].map(b=>b===M?34/t.scale:0));return Ht("text",{class:"axis-name",x:w[0],y:w[1]},g)}),m=[0,1,2].slice(0,t.dim).map(g=>pn([p,t.project([0,1,2].map(M=>M===g?28/t.scale:0))])).join("");this.layers.grid.replaceChildren(Ht("path",{class:"thin",d:f.thin}),Ht("path",{class:"zero",d:f.axis}),Ht("path",{class:"cross",d:m}),...v)}marks(t){let e=[];for(let a of t.supports)e.push(...this.support(a));for(let{unit:a,bar:o}of t.drives){let l=t.members.find(d=>d.name===o);if(!l)continue;let[c,h]=l.ends.map(d=>this.at(d)),u=Math.atan2(h[1]-c[1],h[0]-c[0]);a==="rad"?e.push(Ht("path",{class:"drive",d:`M${c[0]+15*Math.cos(u)} ${c[1]+15*Math.sin(u)}A15 15 0 1 1 ${c[0]+15*Math.cos(u+1.2)} ${c[1]+15*Math.sin(u+1.2)}`})):e.push(Ht("rect",{class:"drive",x:-11,y:-5,width:22,height:10,rx:3,transform:`translate(${(c[0]+h[0])/2} ${(c[1]+h[1])/2}) rotate(${u*180/Math.PI})`}))}let i=Math.max(...t.loads.map(({force:a})=>Math.hypot(...a)),0)||1;for(let{node:a,force:o}of t.loads){let l=t.places[this.index.get(a)];if(!l)continue;let c=this.at(a),{camera:h}=this.draw,u=h.project(l.map((d,f)=>d+(o[f]||0)/i*(nw/h.scale)));e.push(aw(u,c))}let s=a=>this.at(a),r=a=>t.members.find(o=>o.name===a)?.ends;this.layers.bodies.replaceChildren(...rg(t.data,s)),this.layers.marks.replaceChildren(...e,...ag(t.data,s,r))}support({node:t,kind:e,along:i}){let s=this.draw.state.places[this.index.get(t)],{camera:r}=this.draw;if(!s)return[];let a=[s[0],s[1],s[2]||0],o=e==="pin"||e==="roller";return as({kind:e,along:i},a,iw/r.scale).map((l,c)=>Ht("path",{class:o&&c===0?"support":"support line","data-support":t,"data-kind":e,d:pn(l.map(h=>r.project(h)))}))}rubber(){let{camera:t,rubber:e,cursor:i}=this.draw,s=[];if(e?.from&&e.to&&s.push(Ht("path",{class:"rubber",d:pn([t.project(e.from),t.project(e.to)])})),e?.box&&s.push(Ht("path",{class:"box",d:pn([[e.box[0],e.box[1]],[e.box[2],e.box[1]],[e.box[2],e.box[3]],[e.box[0],e.box[3]]],!0)})),e?.to){let[r,a]=t.project(e.to);s.push(Ht("circle",{class:"hint",cx:r,cy:a,r:9}))}if(i){let[r,a]=t.project(i);s.push(Ht("path",{class:"cursor",d:`M${r-12} ${a}H${r+12}M${r} ${a-12}V${a+12}`}))}this.layers.rubber.replaceChildren(...s),this.draw.readout.update()}hit([t,e],i=!1,s=()=>!0){let{state:r}=this.draw,a=i?22:12,o=null;return this.seen.forEach((l,c)=>{let h=Math.hypot(l[0]-t,l[1]-e);h<=a&&s(r.nodes[c])&&(!o||h<o.apart-1e-6||h<o.apart+1e-6&&l[2]>o.depth)&&(o={type:"node",name:r.nodes[c],apart:h,depth:l[2]})}),o||(r.members.forEach(({name:l,ends:c})=>{let[h,u]=c.map(m=>this.at(m)),[d,f]=[u[0]-h[0],u[1]-h[1]],p=Math.min(1,Math.max(0,((t-h[0])*d+(e-h[1])*f)/(d*d+f*f||1))),v=Math.hypot(h[0]+p*d-t,h[1]+p*f-e);v<=(i?16:8)&&(!o||v<o.apart)&&(o={type:"member",name:l,apart:v})}),o)}};function aw(n,t){let e=Math.atan2(n[1]-t[1],n[0]-t[0]),i=s=>[n[0]-9*Math.cos(e+s),n[1]-9*Math.sin(e+s)];return Ht("path",{class:"load",d:pn([t,n])+pn([i(.42),n,i(-.42)])})}var ow=34,lw=/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;function cw(n){let t=n.trim();return t?lw.test(t)?Number(t):t:null}function xe(n,t,e,{hint:i="",size:s=9,name:r=n}={}){let a=x("input",{type:"text",size:s,"aria-label":r,placeholder:i,inputmode:"text",autocomplete:"off",spellcheck:"false"});a.dataset.size=s,Ca(a,t??"");let o=()=>{delete a.dataset.dirty,e(cw(a.value))};return a.addEventListener("input",()=>{a.dataset.dirty="yes",og(a)}),a.addEventListener("change",o),a.addEventListener("blur",()=>a.isConnected&&a.dataset.dirty&&o()),a.addEventListener("keydown",l=>{l.key==="Enter"&&a.blur(),l.key==="Escape"&&(Ca(a,t??""),delete a.dataset.dirty,a.blur())}),x("label",{class:"entry"},x("span",{},n),a)}function Ca(n,t){n.value=t,og(n)}function og(n){n.size=Math.min(Math.max(Number(n.dataset.size)||1,n.value.length),ow)}function Le(n,t,e,i,s=n){let r=x("select",{"aria-label":s},t.map(a=>Array.isArray(a)?x("option",{value:a[0]},a[1]):x("option",{value:a},a)));return r.value=e??"",r.addEventListener("change",()=>i(r.value)),x("label",{class:"entry"},x("span",{},n),r)}function $c(n,t,e,i=n){let s=x("input",{type:"checkbox","aria-label":i});return s.checked=t,s.addEventListener("change",()=>e(s.checked)),x("label",{class:"tick"},s,n)}function Qt(n,t,e={}){return x("button",{type:"button",onclick:t,...e},n)}function Ve(n,...t){let{activeElement:e}=n.ownerDocument,i=n.contains(e)?e.getAttribute("aria-label")||e.textContent:null,s=i&&e.tagName==="INPUT"&&e.type==="text"&&e.dataset.dirty?e.value:null,r=s===null?null:e.selectionStart;if(n.replaceChildren(...t.flat(4).filter(Boolean)),!i)return;let a=[...n.querySelectorAll("input, select, button, textarea")].find(o=>(o.getAttribute("aria-label")||o.textContent)===i);a&&(a.focus({preventScroll:!0}),s!==null&&(Ca(a,s),a.dataset.dirty="yes",a.setSelectionRange(r,r)))}var hw={mechanism:"moves",redundant:"redundant",drive:"drive",open:"does not close"},qc=class{constructor(t){this.draw=t,this.doing=x("p",{class:"busy",hidden:!0}),this.words=x("div",{class:"words",role:"status","aria-live":"polite"}),this.tables=x("div",{}),this.mobility=x("pre",{}),this.node=x("section",{class:"verdicts","aria-label":"state of the drawing"},this.doing,this.words),this.details=x("div",{class:"state"},this.tables,x("details",{},x("summary",{},"Mobility"),this.mobility))}wait(t){this.doing.hidden=!t,this.doing.textContent=t}rebuild(){let{state:t}=this.draw,e=[];for(let a of t.missing)e.push(["",a,"missing"]);for(let{kind:a,text:o}of t.warnings)e.push([hw[a]||a,o]);for(let a of t.alarms)e.push(["limit",a]);for(let{text:a,line:o}of t.faults||[])e.push(["fault",o?`Line ${o}: ${a}`:a]);let i=t.hints||[],s=t.pins||[],r=JSON.stringify([e,i,s,t.why]);if(r!==this.last){this.last=r;let a=!e.length&&t.force;this.words.replaceChildren(x("p",{class:a?"good":""},a?`Stable, ${uw(t.drives.length)}. ${t.why}`:t.why),x("ul",{},e.slice(0,14).map(([o,l,c=o.split(" ")[0]])=>x("li",{class:`of-${c}`},o?x("b",{},o):null,o?" ":null,l)),i.map(o=>x("li",{},x("b",{},"note")," ",o)),s.map(({node:o,member:l})=>x("li",{},x("button",{type:"button",class:"pin",title:`${l} becomes a link through ${o}: stiff there, and pinned to what else is at ${o}`,onclick:()=>this.draw.edit({do:"pin",member:l,node:o})},`Pin ${o} to ${l}`)))))}this.mobility.textContent=t.mobility?t.mobility.text||"It follows when the pointer rests.":"",this.numbers(t)}numbers(t){let e=[];t.drives.length&&e.push(x("table",{class:"numbers"},x("tr",{},x("th",{},"drive"),x("th",{},"at"),x("th",{},Td(t.drives))),t.drives.slice(0,40).map(({name:r,unit:a,value:o,force:l})=>x("tr",{},x("th",{},r),x("td",{},$t(o,a)),x("td",{},l===null?"-":$t(l,a==="rad"?"N m":"N"))))));let i=[..."xyz"].slice(0,t.dim),s=Object.entries(t.reaction).slice(0,60);if(s.length){let r=t.reaction_moment,a=Object.keys(r).length?t.dim===3?i:["z"]:[],o=l=>l.map(c=>x("td",{},c===null?"-":ue(Math.abs(c)<1e-12*Math.max(...l.map(Math.abs))?0:c,4)));e.push(x("table",{class:"numbers"},x("tr",{},x("th",{},"reaction"),i.map(l=>x("th",{},`${l} (N)`)),a.map(l=>x("th",{},`M${l} (N m)`))),s.map(([l,c])=>x("tr",{},x("th",{},l),o(c),r[l]?o(r[l]):a.map(()=>x("td",{}))))))}Ve(this.tables,...e)}};function uw(n){return n?`with ${n===1?"one drive":`${n} drives`}`:"without a drive"}function Td(n){let t=n.filter(({unit:e})=>e==="rad").length;return t===n.length?"holding torque":t?"holding force or torque":"holding force"}var Yc=class{constructor(t){Object.assign(this,{draw:t,on:null,found:null,stale:!1}),this.body=x("div",{}),this.plot=x("canvas",{class:"plot",role:"img","aria-label":"force of the drive along its range"}),this.note=x("p",{class:"faint",role:"status"}),this.node=be("Path of a node",this.body,this.note,this.plot),this.plot.hidden=!0}rebuild(){let{draw:t}=this,{state:e,picked:i}=t;if(!e)return;let s=e.drives.map(({name:a})=>a);this.on&&(!e.nodes.includes(this.on.node)||!s.includes(this.on.drive))&&this.stop();let r=[...i.nodes][0]||this.on?.node||e.nodes.at(-1)||"";this.wish={node:r,drive:this.on?.drive||s[0]||""},s.length?Ve(this.body,x("div",{class:"row"},Le("of node",e.nodes,r,a=>this.wish.node=a,"node of the path"),Le("by drive",s,this.wish.drive,a=>this.wish.drive=a,"drive of the path"),Qt("Show path",()=>this.start()),this.on?Qt("Hide",()=>{this.stop(),this.rebuild()}):null)):Ve(this.body,x("p",{class:"faint"},"A path needs a drive: pick a bar and choose its driven length or angle."))}start(){this.on={...this.wish},this.stale=!0,this.rebuild(),this.draw.pump()}stop(){Object.assign(this,{on:null,found:null,stale:!1}),this.note.textContent="",this.plot.hidden=!0,this.draw.canvas.update()}spoil(){this.on&&(this.stale=!0)}command(){return this.stale=!1,{do:"curve",...this.on}}take(t){if(!this.on)return;this.found=t,this.note.textContent=t.stopped,this.draw.canvas.update(),this.plot.hidden=!1;let e=t.unit==="rad"?"N m":"N",i=t.unit==="rad"?180/Math.PI:1,s=t.values.map(a=>a*i),r=t.force.map(a=>a??NaN);fn(this.plot,[{x:s,y:r,label:t.drive}],{unit:e,xUnit:t.unit==="rad"?"deg":"m",title:Td([t])})}failed(t,e){!this.on||e?.command||!t.startsWith("No")||(this.found=null,this.note.textContent=t,this.plot.hidden=!0,this.draw.canvas.update())}place(t){if(!this.found)return t.replaceChildren();let{camera:e}=this.draw,i=this.found.path.map(s=>e.project(s));t.replaceChildren(Ht("path",{class:"curve",d:`M${i.map(([s,r])=>`${s.toFixed(2)} ${r.toFixed(2)}`).join("L")}`}))}};var Zc=class{constructor(t){Object.assign(this,{draw:t,on:"",found:null,stale:!1}),this.select=x("select",{"aria-label":"diagram",title:"Diagram over the structure, of all loads",onchange:()=>this.choose(this.select.value)}),this.node=x("label",{class:"entry"},x("span",{},"Diagram"),this.select),this.told=x("p",{class:"told",role:"status"})}rebuild(){let{shows:t}=this.draw.state;t.some(({id:e})=>e===this.on)||(this.on=""),this.select.replaceChildren(x("option",{value:""},"Off"),...t.map(({id:e,label:i})=>x("option",{value:e},i))),this.select.value=this.on}choose(t){Object.assign(this,{on:t,found:null,stale:!!t}),this.select.value=t,this.tell(),this.draw.canvas.update(),this.draw.pump()}spoil(){this.on&&(this.stale=!0,this.found=null,this.tell())}command(){return this.stale=!1,{do:"over",show:this.on}}take(t){t.show!==this.on||this.stale||(this.found=t,this.tell(),this.draw.canvas.update())}tell(){let{found:t}=this,e=t?.show==="deflection"&&t.curves.length?`, drawn ${ue(t.factor)} times as large`:"";this.told.textContent=t?t.why||`${t.sentence}${e}.`:""}place(t,e){let{found:i,draw:s}=this,{camera:r}=s;if(!i||s.stale)return t.replaceChildren();let a=h=>h.map(u=>r.project(u)),o=[],l=i.curves.flatMap(h=>{let u=a(h.base),d=a(h.base.map((f,p)=>f.map((v,m)=>v+i.factor*h.shift[p][m])));for(let f of h.extremes)o.push({value:h.values[f],tip:d[f],foot:u[f]});return fd(u,d,h.values,i.show)}),c=ud(o,i.unit,r,e);e.push(...c.map(({box:h})=>h)),t.replaceChildren(...l,...c.map(dd))}};var lg=`.sheetpane { flex: 1; min-width: 0; position: relative; display: flex; }
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
.drawing .diagram text { text-anchor: middle; dominant-baseline: central; font-size: 11.5px; }
.sheetpane .told { position: absolute; left: 10px; bottom: 34px; max-width: calc(100% - 20px); pointer-events: none; }
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
`;var hg=/[:#{}[\],&*!|>'"%@`]|^[-?]/;function jc(n){return n==null?"":Array.isArray(n)?`[${n.map(jc).join(", ")}]`:typeof n=="object"?`{${Object.entries(n).map(([t,e])=>`${t}: ${jc(e)}`).join(", ")}}`:typeof n=="string"&&hg.test(n)?JSON.stringify(n):String(n)}var fw=({type:n,of:t})=>n==="value"||n==="choice"||n==="text"||n==="flag"||n==="any"||n==="list"&&t.type!=="record",or=class{constructor(t,e){Object.assign(this,{draw:t,again:e,drafts:new Map,open:new Set})}get forms(){return this.draw.choices.forms}entry(t,e){let i=[t,e],s=this.forms.tables[t],r=this.draw.state.data[t]?.[e],a={nodes:"at",bars:"ends",beams:"ends",links:"nodes"}[t],o=Array.isArray(r)&&a?{[a]:r}:r;return s.type!=="record"||o!==void 0&&typeof o!="object"?this.field(this.live(),s,e,o,i):this.record(this.live(),s,t,o,i,!0)}live(){return{set:(t,e)=>this.draw.edit({do:"set",path:t,value:e,typed:!0}),draft:!1}}begin(t,e={}){this.drafts.set(t.join("."),e),this.again()}drafting(t){let e=t.join("."),i=this.drafts.get(e),s=(o,l)=>{let c=o.slice(t.length),h=c.pop(),u=i;for(let d of c)u=u[d]??={};l===null?delete u[h]:u[h]=l,this.again()},r=async()=>{(await this.live().set(t,i)).kind==="drawing"&&(this.drafts.delete(e),this.again())},a=()=>{this.drafts.delete(e),this.again()};return{context:{set:s,draft:!0},root:i,actions:x("div",{class:"row"},Qt("Apply",r,{"aria-label":`apply ${e}`}),Qt("Cancel",a,{"aria-label":`cancel ${e}`}))}}field(t,e,i,s,r){if(e.type==="record")return this.record(t,e,i,s,r);if(e.type==="table"&&fw(e.of))return this.table(t,e,i,s,r);let a=r.join(".");if(e.type==="flag"||e.type==="choice"&&!e.free){let f=(e.type==="flag"?[!0,!1]:e.of).map(String);return Le(Dn(i),[["",e.default===void 0?"-":`${e.default} (default)`],...f],s==null?"":String(s),p=>t.set(r,p||null),a)}let o=e.type==="list"&&e.of.type!=="record",l=o&&Array.isArray(s)?jc(s).slice(1,-1):typeof s=="string"?s:jc(s),c=e.unit??(o?e.of.unit:""),h=f=>{if(f===null)return t.set(r,null);let p=String(f);return o&&!p.startsWith("[")?t.set(r,e.of.type==="list"?`[[${p}]]`:`[${p}]`):t.set(r,e.type==="text"&&hg.test(p)?JSON.stringify(p):p)},u=e.default!==void 0&&typeof e.default!="object"?`${e.default}${c?` ${c}`:""}`:c||(o?"a, b":""),d=xe(Dn(i),l,h,{hint:u,size:o||e.type==="any"?16:9,name:a});return cg(d,a,e.type==="choice"?e.of.map(String):this.names(e)),c&&l!==""&&(d.title=c),d}table(t,e,i,s,r){let a=Object.entries(s||{}).map(([h,u])=>x("div",{class:"row"},this.field(t,e.of,h,u,[...r,h]))),o=r.join("."),l=[["name","",""],["value",e.of.unit||"",e.of.type]].map(([h,u])=>xe(h,"",()=>{},{hint:u,size:8,name:`new ${h} in ${o}`}));cg(l[0],`keys ${o}`,this.names(e.keys));let c=()=>{let[h,u]=l.map(d=>d.querySelector("input").value.trim());h&&u&&t.set([...r,h],e.of.type==="list"&&!u.startsWith("[")?`[${u}]`:u)};return x("fieldset",{},x("legend",{},Dn(i)),a,x("div",{class:"row"},l,Qt("Add",c,{"aria-label":`add to ${o}`})))}record(t,e,i,s,r,a=!1){let o=r.join("."),{records:l}=this.forms,c=!t.draft&&this.drafts.has(o)?this.drafting(r):null,h=c?c.root:s,u=c?c.context:t,d=h!==null&&typeof h=="object",f=d?e.of.find(_=>l[_].kind===h.kind)||e.of[0]:null,p=_=>{let T=l[_].kind?{kind:l[_].kind}:{};u.draft?u.set(r,T):this.begin(r,T)},v=this.names(e),m=[...a?[]:[["","-"]],...v,...e.of.map(_=>[`: ${_}`,e.of.length>1?Dn(l[_].kind||_):v.length?"own values ...":"given"])],g=_=>{_.startsWith(": ")?p(_.slice(2)):(c&&this.drafts.delete(o),t.set(r,_||null))},M=d?`: ${f}`:s??"";typeof M=="string"&&M&&!m.some(_=>(Array.isArray(_)?_[0]:_)===M)&&m.push(M);let w=d&&e.of.length<2&&!v.length,b=w?null:Le(d?"kind":Dn(i),m,M,g,o),C=w&&!a&&!e.needed&&!c?Qt("Remove",()=>t.set(r,null),{"aria-label":`remove ${o}`}):null;if(!d)return b;let E=[b,C,this.fields(u,f,h,r),c?.actions];return a?x("div",{class:"form"},E):x("fieldset",{class:"form"},x("legend",{},Dn(i)),E)}fields(t,e,i,s){let{fields:r,about:a}=this.forms.records[e],o=s.join("."),[l,c]=[[],[]];for(let[u,d]of Object.entries(r))(u in i||d.needed?l:c).push(this.field(t,d,u,i[u],[...s,u]));let h=(u,d)=>{let f=`${u} ${o}`,p=x("details",{open:this.open.has(f)},x("summary",{"aria-label":`${u} of ${o}`},u),d);return p.addEventListener("toggle",()=>p.open?this.open.add(f):this.open.delete(f)),p};return[x("div",{class:"row"},l),c.length?h("More fields",x("div",{class:"row"},c)):null,a&&s.length===2?h("What they mean",x("pre",{class:"about"},a)):null]}names({names:t=[],also:e=[]}){let{data:i}=this.draw.state,s=(a,o)=>a!=="poses"&&(a!=="bars"||!t.includes("drives")||o.kind==="driven"),r=a=>Object.entries(i[a]||{}).filter(([,o])=>s(a,o)).map(([o])=>o);return[...new Set([...t.flatMap(a=>[...r(a),...this.draw.choices[a]||[]]),...e])]}};function cg(n,t,e){if(!e.length)return;let i=`names-${t.replace(/[^\w-]/g,"_")}`;n.querySelector("input").setAttribute("list",i),n.append(x("datalist",{id:i},e.map(s=>x("option",{value:s}))))}function Dn(n){return n.replaceAll("_"," ")}var ug=["active","beams","links","bodies","springs","drives","loads","load_cases","trajectories"],pw=300,mw={bodies:"body",trajectories:"trajectory",load_cases:"case",poses:"pose"},Kc=class{constructor(t){Object.assign(this,{draw:t,table:"springs",name:"",ran:{}}),this.forms=new or(t,()=>this.rebuild()),this.body=x("div",{}),this.runs=x("div",{}),this.node=be("Entries of the model",this.body),this.runsNode=be("Runs",this.runs),this.node.open=!1}show([t,e]){let i=t==="runs";Object.assign(this,i?{run:e}:{table:t,name:e}),(i?this.runsNode:this.node).open=!0,this.rebuild()}rebuild(){let{draw:t}=this,{state:e}=t;e&&(this.entries(e.data),this.listRuns(e.data.runs||{}))}entries(t){let{tables:e}=this.draw.choices.forms,i=l=>Object.keys(t[l]||{}).length,s=Object.keys(e).filter(l=>l!=="runs"&&(!(l in t)||!Array.isArray(t[l]))),r=[...ug,...s.filter(l=>!ug.includes(l))],a=Object.keys(t[this.table]||{}),o=[...this.forms.drafts.keys()].filter(l=>l.startsWith(`${this.table}.`)&&!a.includes(l.slice(this.table.length+1))&&l.split(".").length===2).map(l=>l.slice(this.table.length+1));[...a,...o].includes(this.name)||(this.name=a[0]||o[0]||""),Ve(this.body,x("div",{class:"row"},Le("Table",r.map(l=>[l,`${Dn(l)} (${i(l)})`]),this.table,l=>{Object.assign(this,{table:l,name:""}),this.rebuild()},"table of entries"),Le("Entry",[...a,...o.map(l=>[l,`${l} (new)`])],this.name,l=>{this.name=l,this.rebuild()},"entry"),Qt("New",()=>this.fresh(),{"aria-label":"new entry"})),x("p",{class:"faint"},e[this.table].about),this.name?this.form(this.table,this.name):null)}form(t,e){let i=e in(this.draw.state.data[t]||{});return x("div",{},i?x("div",{class:"row"},this.naming(t,e),Qt("Delete",()=>this.draw.edit({do:"set",path:[t,e],value:null}),{"aria-label":`delete ${t} ${e}`})):null,this.forms.entry(t,e))}naming(t,e){return xe("Name",e,async s=>{if(s===null)return this.rebuild();(await this.draw.edit({do:"rename",table:t,old:e,new:String(s)})).kind==="drawing"&&this.show([t,String(s)])},{name:`name of ${t} ${e}`})}fresh(){let{table:t}=this,e=this.draw.choices.forms.tables[t],i=mw[t]||t.replace(/s$/,""),s=this.draw.state.data[t]||{},r=1;for(;`${i}${r}`in s||this.forms.drafts.has(`${t}.${i}${r}`);)r++;this.name=`${i}${r}`;let{kind:a}=e.type==="record"?this.draw.choices.forms.records[e.of[0]]:{};this.forms.begin([t,this.name],a?{kind:a}:{})}listRuns(t){let e=Object.keys(t),{doing:i}=this;e.includes(this.run)||(this.run=e[0]||"");let s=()=>this.draw.make("run");Ve(this.runs,x("div",{class:"row"},e.length?Le("Run",e,this.run,r=>{this.run=r,this.rebuild()},"run"):x("span",{class:"faint"},"No run yet: a run moves the drives, or computes the equilibrium."),Qt("New run",s),this.run&&!i?Qt("Do it",()=>this.start(this.run),{"aria-label":`do run ${this.run}`}):null),i?this.progress(i):null,i?.name===this.run?null:this.result(this.ran[this.run]),this.run?this.form("runs",this.run):null)}progress({name:t,done:e,total:i}){return this.bar=x("progress",{max:i||1,value:e||void 0,"aria-label":`progress of ${t}`}),this.share=x("span",{role:"status","aria-live":"off"},dg(this.doing)),x("div",{class:"row doing"},this.share,this.bar,Qt("Stop",()=>this.stop(),{"aria-label":`stop run ${t}`}))}result(t){if(!t)return null;let e=t.revision!==this.draw.state.revision;return x("div",{role:"status"},x("pre",{class:"about"},t.words),e?x("p",{class:"faint"},"The drawing has changed since."):null,t.number?x("a",{href:`result/${t.number}`,target:"_blank",rel:"noopener"},"Show the result"):null)}async start(t){this.doing={name:t},this.rebuild(),this.hear(await this.draw.ask({do:"run",name:t}))}async stop(){let{name:t}=this.doing||{},e=await this.draw.ask({do:"stop"});this.hear(e),e.kind==="stopped"&&this.draw.tell(`The run ${t} was stopped.`)}hear(t){clearTimeout(this.timer);let e=this.doing;if(this.doing=t.kind==="running"?t:null,this.doing?this.timer=setTimeout(()=>this.follow(),pw):t.kind==="ran"&&(this.ran[t.name]=t,this.draw.tell(`The run ${t.name} is done.`)),!this.doing||!e)return this.rebuild();this.bar.max=t.total||1,t.done&&(this.bar.value=t.done),this.share.textContent=dg(t)}async follow(){this.doing&&this.hear(await this.draw.ask({do:"running"}))}take(t){t?.kind==="running"?this.hear(t):t?.kind==="ran"&&(this.ran[t.name]=t)}};function dg({name:n,done:t,total:e,what:i="samples",note:s=""}){return`Computing ${n}${e?`: ${t} of ${e} ${i}`:" ..."}${s?`. ${s}`:""}`}var Jc=class{constructor(t){this.draw=t,this.name=x("input",{type:"text","aria-label":"file name",size:18}),this.rows=x("ul",{class:"versions"}),this.offer=x("p",{class:"banner",hidden:!0}),this.ask=x("p",{class:"banner warning",hidden:!0}),this.body=x("div",{},this.ask,x("div",{class:"row"},this.name,Qt("Save",()=>this.save(),{title:"Save (Ctrl+S)"})),x("div",{class:"row"},Qt("Keep this state",()=>this.list({do:"keep"})),Qt("Show versions",()=>this.list({do:"versions"}))),this.rows),this.node=be("Save and versions",this.body,x("p",{class:"faint"},"Every edit is kept beside the file, in the folder .kinetruss, until it is saved."))}rebuild(){let{state:t}=this.draw;this.body.hidden=!t.writable,t.offered||(this.offer.hidden=!0),this.name.value||(this.name.value=t.file||"model.yaml"),t.saved&&this.list({do:"versions"})}async save(t=!1){this.ask.hidden=!0;let e=this.name.value.trim();e&&!/[./\\]/.test(e)&&(this.name.value=`${e}.yaml`);let i=await this.draw.ask({do:"save",name:this.name.value.trim(),replace:t});i.kind==="exists"&&(this.ask.hidden=!1,this.ask.replaceChildren(`${i.message} `,Qt("Overwrite",()=>this.save(!0))),this.draw.tell(i.message,!0),this.node.open=!0,this.ask.scrollIntoView({block:"nearest"}))}async list(t){let{rows:e}=await this.draw.ask(t);if(!e)return;let i=s=>new Date(1e3*s).toLocaleString();this.rows.replaceChildren(...e.length?e.toReversed().map(({number:s,when:r,words:a})=>x("li",{},Qt(`Back to ${s}`,()=>this.draw.ask({do:"restore",number:s})),` ${a}, ${i(r)}`)):[x("li",{},"No version yet.")])}setOffer(t){if(this.offer.hidden=!t,!t)return;let e=async i=>{this.offer.hidden=!0,await this.draw.ask({do:"draft",keep:i}),this.draw.fit()};this.offer.replaceChildren(`A drawing of ${t.lines} lines was not saved when its studio ended, ${new Date(1e3*t.when).toLocaleString()}. `,Qt("Go on with it",()=>e(!0))," ",Qt("Remove it",()=>e(!1)))}};var Qc=class{constructor(t){Object.assign(this,{draw:t,values:{}}),this.body=x("div",{}),this.node=be("Copy, mirror, stack",this.body),this.node.open=!1}field(t,e,i,s){return xe(t,this.values[e]??i,r=>this.values[e]=r,{size:6,name:s})}value(t,e){return this.values[t]??e}nodes(){let{picked:t,state:e}=this.draw,i=e.members.filter(({name:s})=>t.members.has(s)).flatMap(({ends:s})=>s);return[...new Set([...t.nodes,...i])]}rebuild(){let{draw:t}=this,{state:e}=t;if(!e)return;let i=[..."xyz"].slice(0,e.dim),s=this.nodes().length,r=()=>t.edit({do:"copy",nodes:this.nodes(),by:i.map(h=>this.value(`d${h}`,0)),count:this.value("count",1)}).then(()=>t.reveal()),a=()=>t.edit({do:"mirror",nodes:this.nodes(),axis:this.value("axis","x"),at:this.value("at",0)}).then(()=>t.reveal()),o=()=>t.edit({do:"stack",cell:this.value("cell",c[0]),count:this.value("cells",1)}).then(h=>h.kind==="drawing"&&t.fit()),l=["triangle","panel"],c=t.choices.cells.filter(h=>l.includes(h)===(e.dim===2));Ve(this.body,x("p",{class:"faint"},s?`${s} node${s===1?" is":"s are"} picked.`:"No node is picked: Shift-click, Shift-drag a box, or Ctrl+A."),x("fieldset",{},x("legend",{},"Copy, shifted by"),x("div",{class:"row"},i.map(h=>this.field(h,`d${h}`,0,`shift of copies along ${h}`)),this.field("times","count",1,"number of copies"),Qt("Copy",r))),x("fieldset",{},x("legend",{},"Mirror in the plane"),x("div",{class:"row"},Le("",i,this.value("axis","x"),h=>this.values.axis=h,"mirror axis"),this.field("=","at",0,"place of the mirror"),Qt("Mirror",a))),x("fieldset",{},x("legend",{},"Cells of the library"),x("div",{class:"row"},Le("",c,this.value("cell",c[0]),h=>this.values.cell=h,"cell"),this.field("times","cells",1,"number of cells"),Qt("Stack",o))))}};var gw=3e6,xw=1600;function _w(n){return new Promise(t=>{let e=new FileReader;e.addEventListener("load",()=>t(e.result)),e.addEventListener("error",()=>t("")),e.readAsDataURL(n)})}function vw(n,{width:t,height:e}){let i=Math.min(1,xw/Math.max(t,e)),s=x("canvas",{width:Math.round(i*t),height:Math.round(i*e)});return s.getContext("2d").drawImage(n,0,0,s.width,s.height),s.toDataURL("image/jpeg",.85)}var th=class{constructor(t){Object.assign(this,{draw:t,image:null,placing:null,points:[],opacity:.5,shown:!0}),this.file=x("input",{type:"file",accept:"image/*","aria-label":"picture to trace",onchange:()=>this.load()}),this.body=x("div",{}),this.node=be("Picture to trace",this.file,this.body),this.node.open=!1,this.image=null}async load(){let[t]=this.file.files;if(!t)return;let e=await _w(t),i=new Image;i.addEventListener("load",()=>{let{camera:s}=this.draw,{axis:r,at:a}=s.plane,[o,l]=s.across,c=.6*Math.min(s.width,s.height)/s.scale/Math.max(i.naturalWidth,i.naturalHeight),h=s.unproject([s.width/2,s.height/2])||[0,0,0];h[o]-=c*i.naturalWidth/2,h[l]+=c*i.naturalHeight/2,this.loaded=i,this.image={source:i.src,width:i.naturalWidth,height:i.naturalHeight,axes:[o,l],axis:r,at:a,turn:[c,0],origin:[h[o],h[l]]},this.points=[],this.rebuild(),this.draw.canvas.update(),this.keep(!0)}),i.addEventListener("error",()=>this.draw.tell("This file is no picture that the browser can show.",!0)),i.src=e}async keep(t=!1){if(!this.image||this.draw.closed)return;let{source:e,...i}=this.image,s={do:"picture",place:{...i,opacity:this.opacity,shown:this.shown}};t&&(s.source=e.length<gw?e:vw(this.loaded,i)),await this.draw.ask(s)}take(t){if(!t||this.image)return;let{opacity:e,shown:i,...s}=t.place;Object.assign(this,{image:{...s,source:t.source},opacity:e,shown:i}),this.rebuild()}remove(){this.image=null,this.file.value="",Ve(this.body),this.draw.canvas.update(),this.draw.ask({do:"picture",place:null})}rebuild(){if(!this.image)return;let t=x("input",{type:"range",min:0,max:1,step:.05,value:this.opacity,"aria-label":"opacity of the picture"});t.addEventListener("input",()=>{this.opacity=Number(t.value),this.draw.canvas.update()}),t.addEventListener("change",()=>this.keep());let e=["Click the first point in the picture.","Click the second point in the picture."];Ve(this.body,x("div",{class:"row"},$c("shown",this.shown,i=>{this.shown=i,this.draw.canvas.update(),this.keep()}),t,Qt("Remove",()=>this.remove(),{"aria-label":"remove the picture"})),Qt("Place by two points",()=>this.begin()),this.placing?x("p",{role:"status"},e[this.points.length]||""):null,this.points.length===2&&!this.placing?this.entries():null)}begin(){Object.assign(this,{placing:!0,points:[]}),this.rebuild(),this.draw.tell("Click the first point in the picture.")}click(t){let{origin:e,turn:i,axes:s,at:r}=this.image,a=this.draw.camera.unproject(t,r);if(!a)return;let[o,l]=[a[s[0]]-e[0],a[s[1]]-e[1]],[c,h]=i,u=c*c+h*h;this.points.push([(c*o+h*l)/u,(h*o-c*l)/u]),this.points.length===2&&(this.placing=null),this.draw.tell(this.points.length===2?"Now write where the two points are.":"Click the second point in the picture."),this.rebuild()}entries(){let t=this.image.axes.map(s=>"xyz"[s]),e=["first","second"].map((s,r)=>t.map((a,o)=>xe(a,r&&!o?1:0,()=>{},{size:5,name:`${a} of the ${s} point in m`}))),i=()=>{let s=e.map(r=>r.map(a=>Number(a.querySelector("input").value)));if(s.flat().some(r=>!Number.isFinite(r)))return this.draw.tell("Write the places as numbers, in m.",!0);this.fit(s)};return x("fieldset",{},x("legend",{},"Their places (m)"),e.map(s=>x("div",{class:"row"},s)),Qt("Place",i))}fit([t,e]){let[i,s]=this.points.map(([d,f])=>[d,-f]),[r,a]=[s[0]-i[0],s[1]-i[1]],[o,l]=[e[0]-t[0],e[1]-t[1]],c=r*r+a*a;if(!c||!(o||l))return this.draw.tell("The two points coincide. Choose two that are far apart.",!0);let[h,u]=[(r*o+a*l)/c,(r*l-a*o)/c];this.image.turn=[h,u],this.image.origin=[t[0]-h*i[0]+u*i[1],t[1]-u*i[0]-h*i[1]],this.points=[],this.rebuild(),this.draw.tell(""),this.draw.canvas.update(),this.keep()}place(t){let{image:e,draw:i}=this;if(!e||!this.shown)return t.replaceChildren();let[s,r]=e.axes,[a,o]=e.turn,l=(f,p)=>{let v=[0,0,0];return[v[s],v[r],v[e.axis]]=[e.origin[0]+a*f+o*p,e.origin[1]+o*f-a*p,e.at],i.camera.project(v)},[c,h,u]=[l(0,0),l(1,0),l(0,1)],d=[h[0]-c[0],h[1]-c[1],u[0]-c[0],u[1]-c[1],c[0],c[1]];this.element||=Ht("image",{});for(let[f,p]of Object.entries({href:e.source,width:e.width,height:e.height,opacity:this.opacity,preserveAspectRatio:"none",transform:`matrix(${d.join(" ")})`}))this.element.setAttribute(f,p);t.replaceChildren(this.element)}};var yw=[["rigid","rigid"],["driven","driven length"],["elastic","elastic (spring)"],["cable","cable"],["free","free (measures only)"]],Ed=[["active","active member (rods, screw, motor)"],["beam","beam (bends)"],["link","link (more pins)"]],bw={angle_spring:"Angle spring",body:"Body"},fg=12,mn=[..."xyz"],eh=class{constructor(t){this.draw=t,this.body=x("div",{}),this.forms=new or(t,()=>this.rebuild()),this.node=be("Picked",this.body)}set(t,e){return this.draw.edit({do:"set",path:t,value:e})}entry(t,e){let i=this.draw.state.data[t]?.[e];return Array.isArray(i)?{[{nodes:"at",links:"nodes"}[t]||"ends"]:i}:i||{}}rebuild(){let{draw:t}=this,{picked:e,state:i}=t;if(!i)return;let s=[...e.nodes],r=[...e.members],a=this.lists(i,s,r);s.length===1&&!r.length?Ve(this.body,a,this.ofNode(s[0]),this.newNode()):r.length===1&&!s.length?Ve(this.body,a,this.ofMember(r[0])):Ve(this.body,a,x("p",{class:"faint"},s.length+r.length?[mg(s,"node"),mg(r,"member")].filter(Boolean).join("; "):"Nothing is picked."),r.length>1?this.ofMany(r):null,this.making([...r.length===2?["angle_spring"]:[],...s.length+r.length>1?["body"]:[]]),s.length?null:this.newNode(),i.nodes.length?null:this.other(i.dim))}lists(t,e,i){let s=(r,a,o,l)=>Le(a,[["","-"],...o],l.length===1?l[0]:"",c=>this.draw.pick(c?{type:r,name:c}:null),`pick a ${r}`);return x("div",{class:"row"},s("node","Node",t.nodes,e),s("member","Member",[...new Set(t.members.map(({name:r})=>r))],i))}other(t){let e=t===2?"Draw in space":"Draw in the plane";return x("div",{class:"row"},x("span",{class:"faint"},`This drawing is ${t===2?"planar":"in space"}.`),Qt(e,()=>this.draw.edit({do:"fresh",dim:5-t})))}newNode(){let{dim:t}=this.draw.state,e=mn.slice(0,t).map(s=>xe(s,"",()=>{},{hint:"0",size:6,name:`${s} of the new node`})),i=async()=>{let s=e.map(a=>a.querySelector("input").value.trim()||"0");(await this.draw.edit({do:"add",at:s.map(a=>Number.isFinite(Number(a))?Number(a):a)})).kind==="drawing"&&(this.draw.reveal(),this.body.querySelector('[aria-label="x of the new node"]').focus())};for(let s of e)s.addEventListener("keydown",r=>r.key==="Enter"&&i());return x("fieldset",{},x("legend",{},"New node at (m, or with a unit)"),x("div",{class:"row"},e,Qt("Add node",i)))}ofNode(t){let{draw:e}=this,{state:i}=e,s=this.entry("nodes",t),r=mn.slice(0,i.dim).map((l,c)=>xe(l,pg(s.at?.[c]),h=>{if(h===null)return this.rebuild();let u=[...s.at];u[c]=h,e.edit({do:"move",places:{[t]:u}}).then(()=>e.reveal())},{size:8,name:`${l} of ${t}`})),a=i.fixed[t]||"",o=mn.slice(0,i.dim).map((l,c)=>$c(l,a.includes(l),h=>this.set(["fixed",t],mn.slice(0,i.dim).filter(u=>u===l?h:a.includes(u)).join("")||null),`hold ${t} along ${l}`));return[this.naming("nodes",t),x("fieldset",{},x("legend",{},"Place (m, or with a unit: 50 mm, 2 in)"),x("div",{class:"row"},r)),x("fieldset",{},x("legend",{},"Support: held along"),x("div",{class:"row"},o,Qt("All",()=>this.set(["fixed",t],mn.slice(0,i.dim).join("")),{"aria-label":`hold ${t}`}),Qt("Free",()=>this.set(["fixed",t],null),{"aria-label":`free ${t}`}))),this.load(t),x("div",{class:"row"},xe("Mass",s.mass,l=>this.set(["nodes",t,"mass"],l),{hint:"0 kg",name:`mass of ${t}`}),this.slide(t))]}slide(t){let{state:e}=this.draw,i=Object.entries(e.data.drives||{}).find(([,s])=>s.kind==="coordinate"&&s.node===t);return Le("Driven along",[["","-"],...mn.slice(0,e.dim)],i?.[1].axis||"",s=>this.set(["drives",i?.[0]||this.free("drives","slide")],s?{kind:"coordinate",node:t,axis:s}:null),`drive ${t} along`)}load(t){let{state:e}=this.draw,i=Object.entries(e.data.loads||{}).find(([,a])=>a.node===t&&a.force),s=i?i[1].force:Array(e.dim).fill(0),r=mn.slice(0,e.dim).map((a,o)=>xe(`F${a}`,i?s[o]:"",l=>{let c=s.map((u,d)=>d===o?l??0:u),h=c.every(u=>Number(u)===0);this.set(["loads",i?.[0]||this.free("loads",`F_${t}`)],h?null:{...i?.[1]||{},node:t,force:c})},{hint:"0 N",size:6,name:`force on ${t} along ${a}`}));return x("fieldset",{},x("legend",{},"Load (N, or with a unit: 2 kN)"),x("div",{class:"row"},r))}ofMember(t){let{draw:e}=this,{state:i}=e;if(!(t in(i.data.bars||{})))return this.ofOther(["beams","links"].find(l=>t in(i.data[l]||{}))||"active",t);let s=this.entry("bars",t),r=s.kind||"rigid";this.span=x("small",{class:"span"},this.spanText(t));let a=r==="elastic"||r==="cable",o=a?xe("Natural length",s.natural_length,l=>this.set(["bars",t,"natural_length"],l),{hint:"as drawn",name:`natural length of ${t}`}):xe("Length",s.length,l=>this.set(["bars",t,"length"],l),{hint:"as drawn",name:`length of ${t}`});return[this.naming("bars",t),this.span,x("div",{class:"row"},Le("Kind",[...yw,...Ed],r,l=>this.setKind(t,l),`kind of ${t}`),o),a?x("div",{class:"row"},xe("Stiffness",s.stiffness,l=>this.set(["bars",t,"stiffness"],l),{hint:"E A/l",name:`stiffness of ${t}`}),xe("Pretension",s.pretension,l=>this.set(["bars",t,"pretension"],l),{hint:"0 N",name:`pretension of ${t}`})):null,this.angle(t),x("div",{class:"row"},ih(e,s.section,l=>this.set(["bars",t,"section"],l),`section of ${t}`),nh(e,s.material,l=>this.set(["bars",t,"material"],l),`material of ${t}`)),x("div",{class:"row"},xe("Mass",s.mass,l=>this.set(["bars",t,"mass"],l),{hint:"of its section",name:`mass of ${t}`})),this.making(["angle_spring"])]}ofOther(t,e){this.span=x("small",{class:"span"},this.spanText(e));let i={beams:"beam",links:"link"}[t]||"active";return[this.naming(t,e),this.span,x("div",{class:"row"},Le("Kind",[["bar","bar"],...Ed],i,s=>this.draw.make(s),`kind of ${e}`)),t==="beams"?this.beamEnds(e):this.making(["angle_spring"]),this.forms.entry(t,e)]}beamEnds(t){let{data:e}=this.draw.state,i=this.entry("beams",t),s=i.release||[],r=e.clamped||[],a=c=>Array.isArray(r)?r.includes(c):c in r,o=(c,h)=>c.filter(u=>u!==h).length?c.filter(u=>u!==h):null,l=async(c,h)=>{s.includes(c)!==(h==="hinge")&&await this.set(["beams",t,"release"],h==="hinge"?[...s,c]:o(s,c)),a(c)!==(h==="clamped")&&(Array.isArray(r)?await this.set(["clamped"],h==="clamped"?[...r,c]:o(r,c)):await this.set(["clamped",c],null))};return x("div",{class:"row"},i.ends.map(c=>Le(`At ${c}`,[["joined","joined stiffly"],["hinge","hinge"],["clamped","clamped to the ground"]],s.includes(c)?"hinge":a(c)?"clamped":"joined",h=>l(c,h),`end of ${t} at ${c}`)))}making(t){return x("div",{class:"row"},t.map(e=>Qt(bw[e],()=>this.draw.make(e))))}setKind(t,e){if(Ed.some(([r])=>r===e))return this.draw.make(e);let i={...this.entry("bars",t)},{state:s}=this.draw;if(delete i.kind,e==="elastic"||e==="cable")delete i.length,!((i.section||s.data.section)&&(i.material||s.data.material))&&i.stiffness===void 0&&(i.stiffness="1 kN/m");else for(let r of["stiffness","natural_length","pretension","strain"])delete i[r];this.set(["bars",t],e==="rigid"?Object.keys(i).length===1?i.ends:i:{...i,kind:e})}ofMany(t){let e=async(i,s)=>{for(let r of t)r in(this.draw.state.data.bars||{})&&await this.set(["bars",r,i],s)};return x("div",{class:"row"},ih(this.draw,null,i=>e("section",i),"section of all picked"),nh(this.draw,null,i=>e("material",i),"material of all picked"))}angle(t){let{state:e}=this.draw,i=Object.entries(e.data.drives||{}).find(([,r])=>(r.kind||"angle")==="angle"&&r.bar===t),s=e.dim===2?[["","-"],["on","yes"]]:[["","-"],...mn.map(r=>[r,`about ${r}`])];return x("div",{class:"row"},Le("Driven angle",s,i?i[1].axis||"on":"",r=>this.set(["drives",i?.[0]||this.free("drives","motor")],r?{kind:"angle",bar:t,...e.dim===3?{axis:r}:{}}:null),`driven angle of ${t}`))}free(t,e){let i=this.draw.state.data[t]||{},s=e;for(let r=2;s in i;r++)s=`${e}${r}`;return s}naming(t,e){return x("div",{class:"row"},xe("Name",e,i=>i===null?this.rebuild():this.draw.edit({do:"rename",table:t,old:e,new:String(i)}),{name:`name of ${e}`}))}spanText(t){let{state:e}=this.draw,i=e.members.findIndex(o=>o.name===t);if(i<0)return"";let s=e.members.filter(o=>o.name===t).map(({ends:o})=>o),r=o=>((l,c)=>Math.hypot(...l.map((h,u)=>h-c[u])))(...o.map(l=>this.draw.at(l))),a=e.force?.[i]??null;return`${[s[0][0],...s.map(o=>o[1])].join(" to ")}, ${$t(s.map(r).reduce((o,l)=>o+l),"m")}${a===null?"":`, ${$t(a,"N")}${e.unsure.includes(t)?" (not unique)":""}`}`}follow(){let{picked:t,state:e}=this.draw;if(t.members.size===1&&this.span&&(this.span.textContent=this.spanText([...t.members][0])),t.nodes.size!==1)return;let[i]=t.nodes;e.places[e.nodes.indexOf(i)].forEach((s,r)=>{let a=this.body.querySelector(`[aria-label="${mn[r]} of ${CSS.escape(i)}"]`);a&&Ca(a,pg(s))})}};function pg(n){return typeof n=="number"?Number(n.toPrecision(7)):n}function mg(n,t){return n.length?`${n.length} ${t}${n.length===1?"":"s"}: ${n.slice(0,fg).join(", ")}${n.length>fg?" ...":""}`:""}function ih(n,t,e,i){let s=[...Object.keys(n.state.data.sections||{}),...n.choices.sections],r=t&&typeof t=="object"?"own":t||"",a=xe("Outer",r==="own"?t.outer??t.diameter:"",()=>{},{hint:"20 mm",size:6,name:`outer diameter, ${i}`}),o=xe("Inner",r==="own"?t.inner:"",()=>{},{hint:"0",size:6,name:`inner diameter, ${i}`}),c=x("span",{class:"row",hidden:r!=="own"},a,o,Qt("Set",()=>{let[u,d]=[a,o].map(p=>p.querySelector("input").value.trim()),f=[u,d].find(p=>Number(p)!==0&&Number.isFinite(Number(p)));if(f!==void 0)return n.tell(`A diameter needs its unit, or it would be metres: ${f} mm.`,!0);u&&e(!d||Number(d)===0?{kind:"rod",diameter:u}:{kind:"tube",outer:u,inner:d})},{"aria-label":`set ${i}`})),h=Le("Section",[["",i.endsWith("of the model")?"none":"of the model"],...new Set(s),["own","tube or rod ..."]],r,u=>{c.hidden=u!=="own",u!=="own"&&e(u||null)},i);return x("span",{class:"row"},h,c)}function nh(n,t,e,i){let s=[...Object.keys(n.state.data.materials||{}),...n.choices.materials],r=t&&typeof t=="object"?[["own","of its own"]]:[];return Le("Material",[["",i.endsWith("of the model")?"none":"of the model"],...new Set(s),...r],r.length?"own":t||"",a=>a!=="own"&&e(a||null),i)}var sh=class{constructor(t){this.draw=t,this.place=x("span",{}),this.grid=x("span",{}),this.outside=x("button",{type:"button",hidden:!0,onclick:()=>t.fit()}),this.node=x("div",{class:"readout"},this.place,this.grid,this.outside)}update(){let{draw:t}=this,{state:e,camera:i,rubber:s,cursor:r,pointed:a}=t,o=s?.to||r||a?.at,l=o&&`${a?.name&&!s?`${a.name}: `:""}${t.cut(o).map(u=>Aa(u)).map(u=>Number(u.toPrecision(6))).join(", ")} m`,c=s?.from&&s.to&&Math.hypot(...s.to.map((u,d)=>u-s.from[d]));this.place.textContent=[l,c?`length ${$t(c,"m")}`:""].filter(Boolean).join("; "),this.grid.textContent=`grid ${$t(i.grid,"m")}`;let h=(t.canvas.seen||[]).filter(([u,d])=>u<0||d<0||u>i.width||d>i.height).length;this.outside.hidden=!h||!e?.nodes.length,this.outside.textContent=`${h} node${h===1?" is":"s are"} out of sight. Show all`}};function Ad(n){let[,t,e="m"]=/^\s*([+-]?[\d.]+(?:e[+-]?\d+)?)\s*([a-z]+)?\s*$/i.exec(String(n??""))||[];return Number(t??NaN)*({m:1,cm:.01,mm:.001,in:.0254,ft:.3048}[e]??NaN)}var Mw=240,rh=class{constructor(t){Object.assign(this,{draw:t,typing:-1}),this.area=x("textarea",{"aria-label":"model as text",spellcheck:"false",rows:18,wrap:"off",oninput:()=>this.typed(),onblur:()=>this.typing--}),this.lines=x("pre",{class:"lines","aria-hidden":"true"}),this.faults=x("ul",{class:"faults",role:"status"}),this.back=x("button",{type:"button",hidden:!0,onclick:()=>this.reset()},"Back to the drawing's text"),this.node=be("The file",x("p",{class:"faint"},"The same model as text. An edit of the drawing changes only its own lines; comments stay."),x("div",{class:"text"},this.lines,this.area),this.faults,this.back),this.area.addEventListener("scroll",()=>this.lines.scrollTop=this.area.scrollTop)}typed(){this.dirty=!0,this.since=performance.now(),this.number([]),clearTimeout(this.timer);let{typing:t}=this;this.timer=setTimeout(()=>this.send(t),Mw)}async send(t){let e=this.area.value,i=await this.draw.ask({do:"text",text:e,drag:t},this.since);this.area.value!==e||i.kind==="lost"||(i.kind==="faults"?this.show(i.faults,!0):i.kind==="drawing"&&(this.dirty=!1,this.show(i.faults,!1)))}reset(){this.dirty=!1,this.rebuild()}rebuild(){let{state:t}=this.draw;this.dirty&&this.area.ownerDocument.activeElement===this.area||(this.dirty=!1,this.area.value!==t.text&&(this.area.value=t.text),this.show(t.faults,!1))}show(t,e){this.back.hidden=!e,this.number(t.map(({line:i})=>i)),this.faults.replaceChildren(...t.slice(0,20).map(({text:i,line:s})=>x("li",{},x("button",{type:"button",class:"link",onclick:()=>this.goTo(s)},s?`Line ${s}`:"Model"),` ${i}`)),...e?[x("li",{},"The drawing is that of the last text without such faults.")]:[])}number(t){let e=this.area.value.split(`
`).length;this.lines.replaceChildren(...Array.from({length:e},(i,s)=>x("span",{class:t.includes(s+1)?"faulty":""},`${s+1}
`))),this.lines.scrollTop=this.area.scrollTop}goTo(t){if(!t)return;let e=this.area.value.split(`
`),i=e.slice(0,t-1).reduce((s,r)=>s+r.length+1,0);this.area.focus(),this.area.setSelectionRange(i,i+e[t-1].length),this.area.scrollTop=(t-4)*(this.area.scrollHeight/e.length)}};var Cd=4,Sw={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},ah=class{constructor(t){this.draw=t,this.pointers=new Map;let{node:e}=t.canvas;e.addEventListener("pointerdown",i=>this.down(i)),e.addEventListener("pointermove",i=>this.move(i)),e.addEventListener("pointerup",i=>this.up(i)),e.addEventListener("pointercancel",i=>this.cancel(i)),e.addEventListener("wheel",i=>{i.preventDefault(),t.camera.zoom(Math.exp(-i.deltaY/500),this.place(i)),t.canvas.update()},{passive:!1}),e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("keydown",i=>this.key(i)),e.addEventListener("blur",()=>{this.cancelAct(),this.setCursor(null)}),e.addEventListener("pointerleave",()=>this.point(null))}place(t){let e=this.draw.canvas.node.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}target(t,e){let{draw:i}=this,s=i.canvas.hit(t,e,l=>i.tool!=="node"||i.inPlane(l));if(s?.type==="node")return{node:s.name,point:i.at(s.name)};let r=i.camera.unproject(t);if(!r)return i.tell("The work plane is seen edge-on. Turn the view, or choose another plane.",!0),null;let a=i.snapped(r),o=i.nodeAt(a);return o===void 0?{point:a}:{node:o,point:i.at(o)}}down(t){let{draw:e}=this,i=this.place(t),s=t.pointerType==="touch";if(e.canvas.node.setPointerCapture(t.pointerId),this.pointers.set(t.pointerId,i),e.canvas.node.focus({preventScroll:!0}),this.setCursor(null),this.pointers.size===2)return this.pinch();if(t.button===1||t.button===2||t.altKey){this.act={kind:e.camera.dim===3&&!t.shiftKey?"turn":"pan",last:i};return}if(e.picture.placing)return e.picture.click(i);let r=e.canvas.hit(i,s);e.tool==="pick"?this.begin(r,i,t):this.act={kind:e.tool,start:i,from:this.target(i,s)}}begin(t,e,i){let{draw:s}=this,r=i.shiftKey||s.several;if(!t){this.act=r?{kind:"box",start:e}:{kind:"pan",last:e,start:e,clear:!0};return}r?s.toggle(t):s.isPicked(t)||s.pick(t),t.type==="node"?this.act={kind:"drag",start:e,node:t.name,from:Object.fromEntries([...s.picked.nodes].map(a=>[a,s.at(a)])),number:Math.floor(Math.random()*2**50)}:this.act={kind:"none"}}move(t){let{draw:e}=this,{act:i}=this,s=this.place(t);if(this.pointers.has(t.pointerId)&&this.pointers.set(t.pointerId,s),i?.kind==="pinch")return this.pinched();if(!i)return this.hover(s);if(i.kind==="pan"||i.kind==="turn"){let[r,a]=[s[0]-i.last[0],s[1]-i.last[1]];i.clear&&Math.hypot(s[0]-i.start[0],s[1]-i.start[1])>Cd&&(i.clear=!1),i.kind==="pan"?e.camera.pan(r,a):e.camera.turn(-r/150,a/150),i.last=s,e.canvas.update()}else if(i.kind==="box")e.rubber={box:[...i.start,...s]},e.canvas.rubber();else if(i.kind==="drag")this.drag(s);else if(i.kind==="bar"&&i.from){let r=this.target(s,t.pointerType==="touch");e.rubber=r&&{from:i.from.point,to:r.point},e.canvas.rubber()}}hover(t){let{draw:e}=this;if(e.closed)return;let i=e.canvas.hit(t);if(e.tool==="pick")return this.point(i?.type==="node"?{name:i.name,at:e.at(i.name)}:null);let s=i?.type==="node"?e.at(i.name):e.camera.unproject(t),r=s&&(i?.type==="node"?s:e.snapped(s));e.rubber=r?{from:this.pending?.point,to:r}:null,e.canvas.rubber()}point(t){this.draw.pointed=t,!t&&!this.act&&(this.draw.rubber=null),this.draw.canvas.rubber()}drag(t){let{draw:e,act:i}=this,s=i.from[i.node];if(!i.moved&&Math.hypot(t[0]-i.start[0],t[1]-i.start[1])<=Cd)return;let r=e.camera.unproject(t,s[e.camera.plane.axis]||0);if(!r)return e.tell("The work plane is seen edge-on. Turn the view, or choose another plane.",!0);i.moved=!0;let a=e.snapped(r,new Set(Object.keys(i.from))),o={};for(let[l,c]of Object.entries(i.from))o[l]=c.map((h,u)=>u===e.camera.plane.axis||a[u]===s[u]?h:Aa(h+a[u]-s[u])).slice(0,e.camera.dim);e.pointed={name:i.node,at:o[i.node]},e.drag(o,i.number)}up(t){let{draw:e,act:i}=this,s=this.place(t);this.pointers.delete(t.pointerId),this.act=null,e.rubber=null,i?.kind==="pan"&&i.clear?e.pick(null):i?.kind==="drag"&&i.moved?e.dragged():i?.kind==="box"?e.pickBox(i.start,s):i?.kind==="node"&&i.from?this.drawNode(i.from):i?.kind==="bar"&&i.from&&this.drawBar(i,s,t.pointerType==="touch"),e.canvas.rubber()}cancel(t){this.pointers.delete(t.pointerId),this.act=null,this.draw.rubber=null,this.draw.canvas.rubber()}drawNode(t){let{draw:e}=this;t.node?e.pick({type:"node",name:t.node}):e.edit({do:"add",at:e.cut(t.point)})}drawBar(t,e,i){if(Math.hypot(e[0]-t.start[0],e[1]-t.start[1])>Cd){this.pending=null;let r=this.target(e,i);r&&this.join(t.from,r)}else this.clickBar(t.from)}async clickBar(t){let{draw:e}=this;if(!this.pending){let{node:s}=t;s?e.pick({type:"node",name:s}):s=(await e.edit({do:"add",at:e.cut(t.point)})).made?.node,this.pending=s?{node:s,point:e.at(s)}:null;return}let i=this.pending;this.pending=null,i.node!==t.node&&await this.join(i,t)}async join(t,e){let{draw:i}=this,s=t.node||(await i.edit({do:"add",at:i.cut(t.point)})).made?.node;if(!s||s===e.node)return;let r=i.state.members.find(({ends:a})=>a.includes(s)&&a.includes(e.node));if(r){i.pick({type:"member",name:r.name}),i.tell(`${r.name} joins ${s} and ${e.node} already. It is picked now.`,!0);return}e.node?await i.edit({do:"bar",ends:[s,e.node]}):await i.edit({do:"add",at:i.cut(e.point),bar_from:s})}pinch(){this.cancelAct(),this.act={kind:"pinch",last:[...this.pointers.values()]}}cancelAct(){this.draw.rubber=null,this.pending=null}pinched(){let{draw:t,act:e}=this,i=[...this.pointers.values()];if(i.length<2)return;let s=l=>[(l[0][0]+l[1][0])/2,(l[0][1]+l[1][1])/2],r=l=>Math.hypot(l[0][0]-l[1][0],l[0][1]-l[1][1]),[a,o]=[s(e.last),s(i)];t.camera.pan(o[0]-a[0],o[1]-a[1]),t.camera.zoom(r(i)/(r(e.last)||1),o),e.last=i.map(l=>[...l]),t.canvas.update()}setCursor(t){this.draw.cursor=t,this.draw.canvas.rubber()}key(t){let{draw:e}=this,{camera:i}=e;if(t.ctrlKey||t.metaKey||t.altKey)return;let s=Sw[t.key];if(s){t.preventDefault();let[r,a]=i.across,o=i.grid*(t.shiftKey?10:1),l=e.cursor||i.snapped(i.unproject([i.width/2,i.height/2])||[0,0,0]),c=[...l];e.cursor&&(c[r]=l[r]+s[0]*o,c[a]=l[a]+s[1]*o),this.setCursor(i.snapped(c));let h=e.canvas.hit(i.project(e.cursor));e.say(`${h?`${h.type} ${h.name}, `:""}${e.cut(e.cursor).join(", ")} m`)}else t.key==="Enter"&&e.cursor?(t.preventDefault(),this.enter(t)):t.key==="Escape"&&(t.preventDefault(),this.escape())}escape(){this.cancelAct(),this.setCursor(null),this.draw.pick(null)}enter(t){let{draw:e}=this,i=e.camera.project(e.cursor),s=e.canvas.hit(i),r=s?.type==="node"?{node:s.name,point:e.at(s.name)}:{point:e.cursor};e.tool==="node"?this.drawNode(r):e.tool==="bar"?this.clickBar(r):t.shiftKey&&s?e.toggle(s):e.pick(s)}};var gg=[["pick","Pick","v","Pick and move: drag nodes, Shift adds to what is picked, Shift-drag draws a box (V)"],["node","Node","n","A node where you click (N)"],["bar","Bar","b","A bar from press to release, or from click to click; it makes the nodes it needs (B)"]],oh=class{constructor(t){this.draw=t,this.tools=new Map(gg.map(([i,s,,r])=>[i,x("button",{type:"button",title:r,onclick:()=>t.setTool(i)},s)]));let e=(i,s,r)=>x("button",{type:"button",title:s,"aria-label":s.replace(/ \(.*/,""),onclick:r},i);this.several=e("Several","Pick several: as with Shift held",()=>this.toggleSeveral()),this.several.className="several",this.undo=e("Undo","Undo (Ctrl+Z)",()=>t.ask({do:"undo"})),this.redo=e("Redo","Redo (Ctrl+Y)",()=>t.ask({do:"redo"})),this.delete=e("Delete","Delete what is picked (Delete)",()=>t.remove()),this.fit=e("Fit","Show all (F)",()=>t.fit()),this.names=e("Names","Names and forces (A)",()=>this.toggle("names")),this.force=e("Forces","Colour by force (C)",()=>this.toggle("force")),this.snap=e("Snap","Snap to the grid (G)",()=>this.toggleSnap()),this.theme=e("◐","Dark or light (D)",()=>t.toggleTheme()),this.looks=x("span",{class:"group",role:"group","aria-label":"view"},["corner","top","front","side"].map(i=>x("button",{type:"button",title:`View: ${i}`,onclick:()=>this.look(i)},i[0].toUpperCase()+i.slice(1)))),this.plane=x("span",{class:"group plane"}),this.grid=x("span",{class:"group"}),this.title=x("h1",{}),this.node=x("header",{class:"toolbar rail"},x("div",{class:"title"},this.title,x("a",{href:"../",class:"operate"},"Operate: sliders and forces")),x("div",{class:"tools"},x("span",{class:"group",role:"group","aria-label":"tools"},[...this.tools.values()],this.several),x("span",{class:"group"},this.undo,this.redo,this.delete),x("span",{class:"group"},this.fit,this.names,this.force,this.snap,this.theme,t.diagram.node),this.grid,this.looks,this.plane))}toggle(t){this.draw.shown[t]=!this.draw.shown[t],this.draw.canvas.update(),this.rebuild()}toggleSnap(){this.draw.snap=!this.draw.snap,this.rebuild()}toggleSeveral(){this.draw.several=!this.draw.several,this.draw.several&&this.draw.setTool("pick"),this.rebuild()}look(t){this.draw.camera.look(t),this.draw.fit()}setPlane(t){Object.assign(this.draw.camera.plane,t),this.draw.canvas.update(),this.rebuild()}rebuild(){let{draw:t}=this,{state:e,camera:i}=t;for(let[r,a]of this.tools)Ui(a,t.tool===r);if(Ui(this.several,t.several),Ui(this.names,t.shown.names),Ui(this.force,t.shown.force),Ui(this.snap,t.snap),!e)return;this.title.textContent=`${e.file||"Untitled drawing"}${e.dirty?" (not saved)":""}`,this.undo.disabled=!e.undo,this.redo.disabled=!e.redo,this.undo.title=e.undo?`Undo ${e.undo} (Ctrl+Z)`:"Nothing to undo",this.redo.title=e.redo?`Redo ${e.redo} (Ctrl+Y)`:"Nothing to redo",this.delete.disabled=!t.picked.nodes.size&&!t.picked.members.size,this.looks.hidden=this.plane.hidden=e.dim!==3,this.grid.replaceChildren(xe("Grid",i.step??"",r=>this.setStep(r),{hint:"auto",size:4,name:"grid step in m"}));let s=x("select",{"aria-label":"work plane",onchange:()=>this.setPlane({axis:Number(s.value),at:0})},["y-z","x-z","x-y"].map((r,a)=>x("option",{value:a},r)));s.value=i.plane.axis,this.plane.replaceChildren(x("label",{class:"entry"},x("span",{},"Plane"),s),xe(`at ${"xyz"[i.plane.axis]} =`,i.plane.at,r=>this.setHeight(r),{size:4,name:"height of the work plane in m"}),x("button",{type:"button",title:"Look straight at the work plane",onclick:()=>{i.face(),t.fit()}},"Face it"))}setHeight(t){let e=Ad(t);Number.isFinite(e)?this.setPlane({at:e}):(this.draw.tell(`The height of the work plane is a length: 0.5, 500 mm. Got ${t??"nothing"}.`,!0),this.rebuild())}setStep(t){let{draw:e}=this,{camera:i}=e,s=t===null?null:Ad(t);s===null||s>0?i.step=s:e.tell(`The step of the grid is a length: 0.05, 50 mm, 2 in. Got ${t}.`,!0),s>0&&!e.state.nodes.length&&(s*i.scale<8||s*i.scale>150)&&i.zoom(44/s/i.scale),e.canvas.update(),this.rebuild()}key(t){let{draw:e}=this,{target:i}=t,s=i.tagName==="TEXTAREA"||i.tagName==="SELECT"||i.tagName==="INPUT"&&i.type!=="checkbox";if(e.closed||t.defaultPrevented||s)return;let r=t.key.length===1?t.key.toLowerCase():t.key;if(t.ctrlKey||t.metaKey){let l={z:t.shiftKey?"redo":"undo",y:"redo"}[r];if(l)e.ask({do:l});else if(r==="a")e.pickAll();else if(r==="s")e.files.save();else return;t.preventDefault();return}if(t.altKey)return;let a=gg.find(l=>l[2]===r),o={i:[0,.12],k:[0,-.12],j:[-.12,0],o:[.12,0]}[r];if(a)e.setTool(a[0]);else if(o)e.camera.turn(...o),e.canvas.update();else if(r==="Delete"||r==="Backspace")e.remove();else if(r==="Escape")e.tools.escape();else if(r==="f")e.fit();else if(r==="a")this.toggle("names");else if(r==="c")this.toggle("force");else if(r==="g")this.toggleSnap();else if(r==="d")e.toggleTheme();else return;t.preventDefault()}};var lh=class{constructor(t){this.draw=t,this.body=x("div",{}),this.node=be("Model",this.body)}rebuild(){let{draw:t}=this,{state:e}=t;if(!e)return;let{data:i,dim:s}=e,r=(c,h)=>t.edit({do:"set",path:c,value:h}),a=i.gravity||Array(s).fill(0),o=[..."xyz"].slice(0,s).map((c,h)=>xe(`g${c}`,a[h],u=>r(["gravity"],a.map((d,f)=>f===h?u??0:d)),{size:6,name:`gravity along ${c}`})),l=(c,h)=>Qt(h,()=>t.edit({do:"fresh",dim:c}),{title:"It can be undone."});Ve(this.body,x("div",{class:"row"},xe("Title",i.title,c=>r(["title"],c===null?null:String(c)),{size:20,name:"title"})),x("div",{class:"row"},o,x("small",{},"m/s²")),x("div",{class:"row"},ih(t,i.section,c=>r(["section"],c),"section of the model"),nh(t,i.material,c=>r(["material"],c),"material of the model")),x("div",{class:"row"},l(2,"New, in the plane"),l(3,"New, in space")))}};var ww=6,Tw=new Set(["running"]),xg={curve:"Computing the path ...",over:"Computing the diagram ...",run:"Starting the run ...",stop:"Stopping the run ...",save:"Saving ...",keep:"Saving ...",versions:"Reading the versions ...",picture:"Saving the picture ..."};function _g(n){let t=document.createElement("style");t.textContent=lg,document.head.append(t);let e=new Rd(n);window.kinetruss.draw=e,e.connect()}var Rd=class extends ar{constructor(t){super(t),Object.assign(this,{state:null,tool:"bar",snap:!0,closed:!0,cursor:null,rubber:null,pointed:null,several:!1,moves:0,stale:!1}),this.picked={nodes:new Set,members:new Set},this.shown={names:!0,force:!0},this.theme=t.dataset.theme||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"),t.dataset.theme=this.theme,this.camera=new Hc,this.banner=x("p",{class:"banner",role:"status",hidden:!0}),this.spoken=x("p",{class:"spoken",role:"status","aria-live":"polite"}),this.picture=new th(this),this.curves=new Yc(this),this.diagram=new Zc(this),this.readout=new sh(this),this.canvas=new Xc(this),this.status=new qc(this),this.properties=new eh(this),this.whole=new lh(this),this.groups=new Qc(this),this.text=new rh(this),this.entries=new Kc(this),this.files=new Jc(this),this.rail=new oh(this),this.tools=new ah(this);let e=x("aside",{class:"controls sketch","aria-label":"drawing"},x("div",{class:"head"},this.banner,this.files.offer,this.status.node),x("div",{class:"parts"},this.status.details,this.properties.node,this.entries.runsNode,this.entries.node,this.groups.node,this.whole.node,this.curves.node,this.picture.node,this.text.node,this.files.node));t.replaceChildren(this.rail.node,x("main",{},x("div",{class:"sheetpane"},this.canvas.node,this.canvas.legend,this.diagram.told,this.doing,this.readout.node,this.spoken),e)),t.ownerDocument.addEventListener("keydown",i=>this.rail.key(i))}get there(){return this.state}async edit(t){let e=await this.ask(t),{made:i}=e;return i?.member?this.pick({type:"member",name:i.member}):i?.node&&this.pick({type:"node",name:i.node}),i?.entry&&!i.member&&this.entries.show(i.entry),i?.lost?.length&&this.tell(`Removed with it: ${i.lost.join(", ")}.`),e}make(t){return this.edit({do:"make",what:t,nodes:[...this.picked.nodes],members:[...this.picked.members]})}drag(t,e){this.wanted={do:"move",places:t,drag:e},this.pump()}dragged(){this.ask({do:"show"})}hurried(){let t=this.wanted;return!t||this.curves.stale&&this.moves>=ww?null:(this.moves++,this.wanted=null,{command:t})}leisurely(){return this.diagram.stale?{command:this.diagram.command()}:this.curves.stale?(this.moves=0,{command:this.curves.command()}):null}watch(){if(!this.state)return;let t=[this.waiting,...this.queue].filter(s=>s&&!Tw.has(s.command.do)),e=t.find(({command:s})=>!(s.do in xg)),[i]=e?[e]:t;this.changing=!!e,i?this.busy.wait(xg[i.command.do]||"Computing ...",i.since):this.busy.end()}showBusy(t){let e=!!(t&&this.changing&&this.state);t&&this.doing.hidden&&this.say(t),super.showBusy(t),this.status.wait(e?t:""),e!==this.stale&&(this.stale=e,this.root.classList.toggle("stale",e),this.canvas.update())}heard(t){return t.kind==="drawing"?this.take(t):t.kind==="moved"?this.place(t):t.kind==="over"?this.diagram.take(t):t.kind==="curve"?this.curves.take(t):t.kind==="error"&&this.refuse(t.message),t.other||t.choices}refuse(t){this.curves.failed(t,this.waiting),this.tell(t,!0);for(let e of[this.properties,this.whole,this.entries])e.rebuild()}take(t){let e=!this.state,i=this.state?.dim,s=null;t.choices&&(this.choices=t.choices,this.files.setOffer(t.offer),this.picture.take(t.picture),s=t.running),this.state=t,this.camera.setDim(t.dim),this.keepPicked(t.made?.renamed),!t.other&&!e&&this.tell(t.saved||""),this.diagram.spoil(),this.canvas.rebuild(),(e||t.dim!==i)&&this.fit(),this.curves.spoil();for(let r of[this.rail,this.status,this.properties,this.whole,this.groups,this.entries,this.curves,this.diagram,this.text,this.files])r.rebuild();s&&this.entries.take(s),window.kinetruss.ready=!0,this.root.dataset.state="ready"}place(t){Object.assign(this.state,t,{kind:"drawing"}),this.diagram.spoil(),this.canvas.update(),this.curves.spoil(),this.status.rebuild(),this.properties.follow()}keepPicked(t){if(t)for(let i of Object.values(this.picked))i.delete(t[0])&&i.add(t[1]);let e={nodes:new Set(this.state.nodes),members:new Set(this.state.members.map(({name:i})=>i))};for(let[i,s]of Object.entries(this.picked))for(let r of s)e[i].has(r)||s.delete(r)}at(t){let e=this.state.places[this.state.nodes.indexOf(t)];return[e[0],e[1],e[2]||0]}snapped(t,e=new Set){return this.snap?this.camera.snapped(t,this.state.places.filter((i,s)=>!e.has(this.state.nodes[s]))):t}nodeAt(t){let{places:e,nodes:i}=this.state;return i[e.findIndex(s=>t.every((r,a)=>Math.abs(r-(s[a]||0))*this.camera.scale<.5))]}inPlane(t){let{axis:e,at:i}=this.camera.plane;return Math.abs(this.at(t)[e]-i)*this.camera.scale<1}cut(t){return t.slice(0,this.camera.dim)}isPicked({type:t,name:e}){return this.picked[`${t}s`].has(e)}pick(t){this.picked.nodes.clear(),this.picked.members.clear(),t&&this.picked[`${t.type}s`].add(t.name),this.repick()}toggle({type:t,name:e}){let i=this.picked[`${t}s`];i.delete(e)||i.add(e),this.repick()}pickAll(){this.state.nodes.forEach(t=>this.picked.nodes.add(t)),this.state.members.forEach(({name:t})=>this.picked.members.add(t)),this.repick()}pickBox(t,e){let i=([s,r])=>(s-t[0])*(s-e[0])<=0&&(r-t[1])*(r-e[1])<=0;this.state.nodes.forEach((s,r)=>i(this.canvas.seen[r])&&this.picked.nodes.add(s)),this.state.members.forEach(({name:s,ends:r})=>r.every(a=>this.picked.nodes.has(a))&&this.picked.members.add(s)),this.repick()}repick(){this.canvas.update();for(let t of[this.rail,this.properties,this.groups,this.curves])t.rebuild();this.say([...this.picked.nodes,...this.picked.members].join(", ")||"nothing picked")}remove(){let t=[...this.picked.nodes],e=[...this.picked.members];(t.length||e.length)&&this.edit({do:"delete",nodes:t,members:e})}reveal(){let{width:t,height:e}=this.camera;this.canvas.seen.some(([i,s])=>i<0||s<0||i>t||s>e)&&this.fit()}fit(){this.camera.fit(this.state.places),this.canvas.update()}setTool(t){this.tool=t,t!=="pick"&&(this.several=!1),this.tools.cancelAct(),this.canvas.rubber(),this.rail.rebuild()}toggleTheme(){this.theme=this.theme==="dark"?"light":"dark",this.root.dataset.theme=this.theme}tell(t,e=!1){this.banner.hidden=!t,this.banner.textContent=t,this.banner.classList.toggle("warning",e)}say(t){this.spoken.textContent=t}open(t){this.post=t,this.closed=!1,this.setEnded(!1),this.state?this.tell("The studio answers again."):this.busy.wait("Opening ...",performance.now())}close(){super.close(),this.state&&this.tell("The studio has ended. The drawing stays as it was last confirmed and cannot be changed. It is kept beside its file: start the studio again in the same folder, and this page goes on with it.",!0)}};var ch="KTSCENE1",Ew="kinetruss.scene",vg=1;function ls(n){let t=atob(n.trim()),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e}async function yg(n){let{readable:t,writable:e}=new DecompressionStream("deflate"),i=e.getWriter(),s=i.write(n).then(()=>i.close()),[r]=await Promise.all([new Response(t).arrayBuffer(),s]);return new Uint8Array(r)}async function On(n){if(String.fromCharCode(...n.subarray(0,ch.length))!==ch)throw new Error("These bytes are no kinetruss scene.");let e=ch.length+4,i=e+new DataView(n.buffer,n.byteOffset).getUint32(ch.length,!0),[s,r]=await Promise.all([yg(n.subarray(e,i)),yg(n.subarray(i))]),a=4+new DataView(s.buffer).getUint32(0,!0),o=JSON.parse(new TextDecoder().decode(s.subarray(4,a)));if(o.format!==Ew||o.version!==vg)throw new Error(`Scene version ${o.version} is not known to this viewer, which reads ${vg}.`);let l={};for(let[c,h]of Object.entries(o.arrays)){let u=h.form==="plain"?Aw(s,a,h):Cw(r,h);l[c]={shape:h.shape,data:u}}return new Pd(o,l)}var bg=n=>n.shape.reduce((t,e)=>t*e,1);function Aw(n,t,e){let i=t+e.at,{buffer:s}=n.slice(i,i+4*bg(e));return e.type==="int32"?new Int32Array(s):new Float32Array(s)}function Cw(n,t){let e=bg(t),i=e/t.shape[0];return t.form==="float32"?Rw(n,t.at,e,i):Pw(n,t,e,i)}function Rw(n,t,e,i){let s=new Uint32Array(e),r=t+e,a=r+e,o=a+e;for(let l=0;l<e;l++)s[l]=n[t+l]|n[r+l]<<8|n[a+l]<<16|n[o+l]<<24,l>=i&&(s[l]+=s[l-i]);return new Float32Array(s.buffer)}function Pw(n,{at:t,order:e},i,s){let r=Float64Array.from(new Int8Array(n.slice(t,t+s).buffer),u=>2**u),a=new Int32Array(n.slice(t+s,t+5*s).buffer),o=t+5*s,l=o+i,c=new Float32Array(i),h=Array.from({length:e},()=>new Uint16Array(s));for(let u=0,d=0,f=0;u<i;u++){let p=n[o+u]|n[l+u]<<8,v=p>>>1^-(p&1);for(let m=Math.min(e-1,f);m>=0;m--)v=h[m][d]+=v;c[u]=(h[0][d]+a[d])*r[d],++d===s&&(d=0,f++)}return c}var Pd=class{constructor(t,e){Object.assign(this,{header:t,arrays:e,stored:{...e},cases:t.cases.map(i=>i.load_case)}),this.time=e.time.data,this.frames=this.time.length,this.dim=t.dim,this.nodes=t.nodes,this.members=t.members,this.ends=e.ends.data,this.active=new Set(t.two_rods),this.directors=new Set(t.directors||[]),this.partsOf=this.members.map(()=>[]),e.part_member.data.forEach((i,s)=>this.partsOf[i].push(s)),this.curves=new Jl(this),this.skin=e.skin?e.skin.data:new Int32Array(0),this.faces=this.skin.length/3,this.extent=Iw(e.position.data,this.dim),this.length0=Nw(this),this.ranges={},this.kept={},this.sure()}shows(t){return this.header.kinds[t]!=="frame"}sure(){this.unsure=new Set((this.header.not_unique||[]).map(t=>this.members.indexOf(t)).filter(t=>t>=0))}renew(){Object.assign(this.kept,this.ranges),this.ranges={}}choose(t){let e=this.cases.indexOf(t);if(e<0)return!1;Object.assign(this.header,this.header.cases[e]);for(let i of Object.keys(this.stored)){let s=this.stored[`${e}:${i}`];this.arrays[i]=s||this.stored[i]}return this.ranges={},this.kept={},this.sure(),!0}get unchecked(){return["utilisation","buckling"].some(t=>this.has(t)&&this.arrays[t].data.some((e,i)=>Number.isNaN(e)&&this.shows(i%this.members.length)))}has(t){return t in this.arrays}vector(t,e,i){let{data:s,shape:r}=this.arrays[t],a=this.dim,o=(e*r[1]+i)*a;return[s[o],s[o+1],a===3?s[o+2]:0]}position(t,e){return this.vector("position",t,e)}placeOfLoad(t,e){return t.at?[0,1,2].map(i=>t.at.reduce((s,[r,a])=>s+a*e(r)[i],0)):e(t.node)}jointForce(t,e,i){let{data:s}=this.arrays.joint_force,r=this.dim,a=((t*this.members.length+e)*2+i)*r;return[s[a],s[a+1],r===3?s[a+2]:0]}actionForce(t,e,i){let{data:s,shape:r}=this.arrays.action_force,a=this.dim,o=((t*r[1]+e)*2+i)*a;return[s[o],s[o+1],a===3?s[o+2]:0]}number(t,e,i){let{data:s,shape:r}=this.arrays[t];return r.length===1?s[i]:s[e*r[1]+i]}channel(t){return this.header.channels.find(e=>e.id===t)}value(t,e,i){if(t==="length")return this.length(e,i);let s=this.channel(t);return s?s.array?this.has(s.array)?this.number(s.array,e,i):NaN:this.memberSpeed(e,i):NaN}plainValue(t,e,i){let s=this.value(t,e,i);if(!this.channel(t))return s;let[r,a]=this.range(t);return Math.abs(s)<1e-12*Math.max(Math.abs(r),Math.abs(a))?0:s}coloursFaces(t){return this.has(this.channel(t)?.faces)}faceValue(t,e,i){return this.number(this.channel(t).faces,e,i)}memberSpeed(t,e){let i=this.vector("velocity",t,this.ends[2*e]),s=this.vector("velocity",t,this.ends[2*e+1]);return Math.hypot(i[0]+s[0],i[1]+s[1],i[2]+s[2])/2}length(t,e){let i=this.position(t,this.ends[2*e]),s=this.position(t,this.ends[2*e+1]);return Math.hypot(s[0]-i[0],s[1]-i[1],s[2]-i[2])}range(t){if(!(t in this.ranges)){let[e,i]=this.kept[t]||[1/0,-1/0],s=this.channel(t),r=s&&s.array&&this.arrays[s.array]?.shape.length===1?1:this.frames,a=o=>{o<e&&(e=o),o>i&&Number.isFinite(o)&&(i=o)};for(let o=0;o<r;o++)for(let l=0;l<this.members.length;l++)this.shows(l)&&a(this.value(t,o,l));this.coloursFaces(t)&&this.arrays[s.faces].data.forEach(a),this.ranges[t]=e<=i?[e,i]:[0,0]}return this.ranges[t]}frameAt(t){return md(this.time,t)}};function Iw(n,t){let e=[1/0,1/0,t===3?1/0:0],i=[-1/0,-1/0,t===3?-1/0:0];for(let a=0;a<n.length;a++){let o=a%t;n[a]<e[o]&&(e[o]=n[a]),n[a]>i[o]&&(i[o]=n[a])}let s=e.map((a,o)=>(a+i[o])/2),r=Math.hypot(...i.map((a,o)=>a-e[o]))||1;return{low:e,high:i,centre:s,size:r}}function Nw(n){let e=n.members.map((i,s)=>s).filter(i=>n.shows(i)).map(i=>n.length(0,i)).sort((i,s)=>i-s);return e[e.length>>1]||n.extent.size/4}var Lw=24,Dw=.94,Ow=.08,Mg=2,Uw=8192,Fw=.001,Sg=.7;function Tg(n){window.kinetruss.film=async t=>{let e=await On(ls(document.querySelector("script.kinetruss-scene").textContent));return window.kinetruss.shown=new Id(n,e,t),window.kinetruss.shown.said}}var Id=class{constructor(t,e,i){let[s,r]=[0,1].map(()=>document.createElement("canvas")),{width:a,height:o}=i;s.style.cssText=`display: block; width: ${a}px; height: ${o}px;`,t.replaceChildren(s);let l=Mg*Math.max(a,o)>Uw?1:Mg;Object.assign(this,{scene:e,look:i,fine:l,view:new rr(s,e,"light",l===1)}),Object.assign(r,{width:a,height:o}),this.pen=r.getContext("2d",{willReadFrequently:!0}),this.dress(),this.aim(),this.said=this.colour()}dress(){let{view:t,scene:e,look:i}=this;t.renderer.setClearColor(new Nt("#ffffff")),t.triad.render=()=>{},t.lamp.intensity=Math.PI*Sg,t.lampPlace=[0,0,1],t.ambient.intensity=Math.PI*(1-Sg),t.loads.group.visible=i.loads,t.faces.mesh.visible=i.faces,t.grid.visible=!1;let s=Fw*e.extent.size;i.grid&&this.lines(wg(t),s,Xe.light.line),i.ghost&&this.lines(kw(e),s,"#a8b0b9");for(let a of i.paths)this.lines(Ti(Array.from({length:e.frames},(o,l)=>e.position(l,a))),2*s,Xe.light.ink);if(i.mode===null)return;let{array:r}=e.header.modes[i.mode];this.reach=Ow*e.extent.size/(e.arrays[r].data.reduce((a,o)=>Math.max(a,Math.abs(o)),0)||1),t.mode={array:r,size:0}}lines(t,e,i){let s=rs(t.length,6);s.material=new Vi({color:i}),t.forEach(([r,a],o)=>Ei(s,o,r,a,e)),this.view.world.add(s)}aim(){let{view:t,look:e}=this,{camera:i,controls:s}=t;i.fov=Lw,t.resize(),t.renderer.setPixelRatio(this.fine);let r=Md(t),a=2*t.bars.ball;if(t.mode)for(let h of[-this.reach,this.reach])r.push(...this.swung(h));e.grid&&r.push(...wg(t).flat()),this.places=[-a,a].flatMap(h=>r.map(u=>u.map(d=>d+h)));let o=new I(...e.direction).normalize();i.up.set(0,...Math.abs(o.z)>.999?[1,0]:[0,1]);let{centre:l,far:c}=Sd(t,o,this.places,Dw,0);i.position.copy(l).addScaledVector(o,c),i.lookAt(l),s.target.copy(l)}swung(t){return this.view.mode.size=t,this.view.points()}colour(){let{view:t,scene:e,look:i}=this,s=i.colour&&e.channel(i.colour);if(!s)return{step:t.step,unsure:!1,limits:[0,1],largest:0,over:!1,missing:!1};let r=e.range(s.id),a=hr(s.scale,[r]);return t.setColours(s,a),{step:t.step,unsure:e.unsure.size>0,limits:a,largest:Math.max(...r.map(Math.abs)),over:Oi(s)&&r[1]>1,missing:this.missing(s)}}missing(t){let{scene:e}=this,i=e.members.map((s,r)=>r).filter(s=>e.shows(s));for(let s=0;s<e.frames;s++)if(i.some(r=>Number.isNaN(e.value(t.id,s,r))))return!0;return!1}shoot(t,e){let{view:i}=this;return i.mode&&(i.mode.size=e*this.reach),i.setFrame(t),i.render(),this.pen.drawImage(i.canvas,0,0,this.look.width,this.look.height),this.pen.canvas.toDataURL("image/png")}};function kw(n){let t=n.nodes.map((s,r)=>n.position(0,r)),e=_a(n.skin);return[...n.members.flatMap((s,r)=>n.shows(r)?Ti(n.curves.points(t,r)):[]),...Array.from({length:e.length/2},(s,r)=>[t[e[2*r]],t[e[2*r+1]]])]}function wg({scene:n,step:t,grid:e,supports:i}){let{low:s,high:r}=n.extent,a=[0,1].map(c=>Math.floor(s[c]/t-.2)),o=[0,1].map(c=>Math.ceil(r[c]/t+.2)),l=n.dim===2?e.position.z:Math.min(e.position.z,...i.feet(0).map(c=>c[2]));return[0,1].flatMap(c=>Array.from({length:o[c]-a[c]+1},(h,u)=>[a,o].map(d=>{let f=[d[0]*t,d[1]*t,l];return f[c]=(a[c]+u)*t,f})))}var Bw=["rigid","driven","elastic","cut"],hh=class{constructor(t){this.live=t,this.acting=x("div",{}),this.kind=x("div",{}),this.node=x("div",{},x("details",{open:!0},x("summary",{},"Member"),this.kind),x("details",{},x("summary",{},"Gravity, payload, loads"),this.acting))}rebuild(t){this.setup=t,ce(this.acting,this.cases(t),this.gravity(t),this.masses(t),t.loads.map(e=>this.load(e,t)),this.load({name:this.free(t),node:this.chosen||t.nodes[t.nodes.length-1],force:Array(t.dim).fill(0)},t,"Add")),this.members(t)}async sent(t,e){if(t.every(i=>Number.isFinite(i.valueAsNumber))){(await e())?.kind==="error"&&this.rebuild(this.setup);return}this.live.controls.tell("A field is empty or holds no number. It was set back.",!0),this.rebuild(this.setup)}free(t){let e=1;for(;t.loads.some(i=>i.name===`load_${e}`);)e++;return`load_${e}`}cases(t){if(!t.cases.length)return null;let e=x("select",{"aria-label":"load case",onchange:()=>this.live.ask({do:"case",name:e.value||null})},x("option",{value:""},"all loads"),t.cases.map(i=>x("option",{value:i,selected:i===t.case},i)));return x("label",{class:"row"},"Load case",e)}vector(t,e){return t.map((i,s)=>x("input",{type:"number",step:"any",value:i,"aria-label":`${e} ${"xyz"[s]}`,class:"component"}))}gravity(t){let e=this.vector(t.gravity,"gravity"),i=()=>this.sent(e,()=>this.live.ask({do:"gravity",value:e.map(o=>o.valueAsNumber)})),s=Math.hypot(...t.gravity)||9.80665,r=(o,l)=>{e.forEach((c,h)=>c.value=h===o?l*s:0),i()},a=e.flatMap((o,l)=>[1,-1].map(c=>x("button",{type:"button",title:`gravity along ${c<0?"-":"+"}${"xyz"[l]}`,onclick:()=>r(l,c)},`${c<0?"-":"+"}${"xyz"[l]}`)));return e.forEach(o=>o.addEventListener("change",i)),x("fieldset",{},x("legend",{},"Gravity (m/s²)"),x("div",{class:"row"},e),x("div",{class:"row"},a))}masses(t){let e=Object.keys(t.masses).reduce((a,o)=>t.masses[o]>t.masses[a]?o:a),i=t.masses[e]?e:t.nodes[t.nodes.length-1];this.chosen=this.chosen&&this.chosen in t.masses?this.chosen:i;let s=x("input",{type:"number",min:0,step:"any",value:t.masses[this.chosen],"aria-label":"payload in kg",class:"component",onchange:()=>this.sent([s],()=>this.live.ask({do:"mass",node:r.value,mass:s.valueAsNumber}))}),r=Eg(t,this.chosen,"node of the payload",a=>{this.chosen=a,s.value=t.masses[a]});return x("fieldset",{},x("legend",{},"Payload (kg)"),x("div",{class:"row"},r,s))}load(t,e,i="Set"){if(!t.force)return x("p",{class:"faint"},`Load ${t.name} changes in time; at its start here.`);let s=this.vector(t.force,`load ${t.name}`),r=Eg(e,t.node,`node of load ${t.name}`),a=c=>this.live.ask({do:"load",name:t.name,node:r.value,force:c}),o=x("button",{type:"button",onclick:()=>this.sent(s,()=>a(s.map(c=>c.valueAsNumber)))},i),l=i==="Set"?x("button",{type:"button",title:"Take this load away",onclick:()=>a(s.map(()=>0))},"×"):null;return x("fieldset",{},x("legend",{},i==="Set"?`Load ${t.name} (N)`:"Another load (N)"),x("div",{class:"row"},r,...s,o,l))}members(t){this.member=x("select",{"aria-label":"member",onchange:()=>this.mark()},t.members.map(({name:i,role:s,own:r})=>x("option",{value:i},s===r?i:`${i} (${s})`))),this.shown&&t.members.some(i=>i.name===this.shown)&&(this.member.value=this.shown),this.buttons=new Map([...Bw,"own"].map(i=>[i,x("button",{type:"button",onclick:()=>this.live.ask({do:"switch",member:this.member.value,to:i})},i==="own"?"as in the file":i)]));let e=t.lost.length?x("p",{class:"faint"},`Rests on changed members, not in the model now: ${t.lost.join(", ")}.`):null;ce(this.kind,t.members.length?[x("div",{class:"row"},this.member,x("span",{class:"group"},[...this.buttons.values()])),e]:[]),t.members.length&&this.mark()}mark(){this.shown=this.member.value;let{role:t}=this.setup.members.find(e=>e.name===this.shown);for(let[e,i]of this.buttons)i.setAttribute("aria-pressed",String(e===t))}picked(t){t?.type==="member"&&(this.member.value=t.name,this.mark())}};function Eg(n,t,e,i=()=>{}){let s=x("select",{"aria-label":e,onchange:()=>i(s.value)},n.nodes.map(r=>x("option",{value:r,selected:r===t},r)));return s}var zw=2e3,Gw=Math.PI/180,uh=class{constructor(t){this.live=t,this.list=x("div",{class:"drives"}),this.node=be("Drives",this.list)}rebuild(t){this.rows=new Map(t.drives.map(e=>[e.name,this.row(e)])),ce(this.list,t.drives.length?[...this.rows.values()].map(e=>e.node):x("p",{class:"faint"},"This model has no drive."))}row(t){let e=t.unit==="rad"?1/Gw:1e3,i=t.unit==="rad"?"deg":"mm",{low:s,high:r,name:a}=t,o=x("input",{type:"range",min:s,max:r,step:(r-s)/zw,"aria-label":`drive ${a}`,oninput:()=>this.live.move({[a]:Number(o.value)})}),l=x("input",{type:"number",step:"any","aria-label":`value of ${a} in ${i}`,oninput:()=>u.typing=!0,onchange:()=>{u.typing=!1,Number.isFinite(l.valueAsNumber)?this.live.move({[a]:l.valueAsNumber/e}):this.update(this.live.controls.last)}}),c=x("small",{},`${ue(s*e,4)} to ${ue(r*e,4)} ${i}${t.limited?"":", no limits in the model"}`),u={node:x("div",{class:"drive","data-drive":a},x("b",{},a),x("span",{class:"value"},l,` ${i}`),o,c),slider:o,field:l,factor:e,typing:!1};return u}update({values:t,stopped:e}){for(let[i,{node:s,slider:r,field:a,factor:o,typing:l}]of this.rows){let c=t[i];if(c===void 0)continue;(!(this.live.wanted&&i in this.live.wanted)||e)&&(r.value=c),l||(a.value=Number((c*o).toFixed(4))),s.classList.toggle("stopped",!!e&&i in(this.live.sent||{}))}}};var dh=class{constructor(t){Object.assign(this,{live:t,frames:[]}),this.at=x("input",{type:"number",min:0,step:"any",value:0,"aria-label":"time of the key frame in s",class:"component"}),this.samples=x("input",{type:"number",min:2,max:2001,step:1,value:201,"aria-label":"samples",class:"component"}),this.line=x("div",{class:"timeline"}),this.list=x("div",{}),this.worst=x("table",{class:"numbers"}),this.play=x("button",{type:"button",onclick:()=>this.run()},"Run"),this.back=x("button",{type:"button",hidden:!0,onclick:()=>this.live.ask({do:"show"})},"Back to the sliders"),this.setter=x("div",{class:"row"},"at",this.at,"s",x("button",{type:"button",onclick:()=>this.set()},"Set key frame here")),this.node=be("Motion through key frames",this.setter,this.line,this.list,x("div",{class:"row"},this.play,this.samples,"samples",this.back),this.worst),this.show()}set(){let t=Math.max(0,this.at.valueAsNumber||0);this.frames=this.frames.filter(e=>Math.abs(e.time-t)>1e-6),this.frames.push({time:t,values:{...this.live.controls.last.values}}),this.frames.sort((e,i)=>e.time-i.time),this.next(),this.keep()}remove(t){this.frames=this.frames.filter(e=>e!==t),this.keep()}next(){this.at.value=this.frames.length?Number((this.frames[this.frames.length-1].time+1).toFixed(6)):0}take(t){this.frames=t,this.next(),this.show()}keep(){this.show(),this.live.page&&this.live.ask({do:"frames",frames:this.frames})}told(){let t=new Set((this.live.setup?.drives||[]).map(e=>e.name));return this.frames.map(({time:e,values:i})=>({time:e,values:Object.fromEntries(Object.entries(i).filter(([s])=>t.has(s)))}))}show(){let t=this.frames.length?this.frames[this.frames.length-1].time:0;this.play.disabled=this.frames.length<2;let e=this.frames.map(({time:i})=>Ht("circle",{cx:8+284*i/(t||1),cy:12,r:6}));ce(this.line,this.frames.length?Ht("svg",{viewBox:"0 0 300 24",role:"img","aria-label":`${this.frames.length} key frames over ${t} s`},Ht("line",{x1:8,y1:12,x2:292,y2:12}),e):null),ce(this.list,this.frames.map(i=>x("div",{class:"row"},x("button",{type:"button",title:"Go there",onclick:()=>this.live.move(i.values)},bh(i.time)),x("button",{type:"button",title:"Remove this key frame","aria-label":`remove the key frame at ${i.time} s`,onclick:()=>this.remove(i)},"×"))))}async run(){this.play.disabled=!0,this.live.controls.tell("Running ..."),await this.live.ask({do:"run",frames:this.told(),samples:Math.round(this.samples.valueAsNumber||201)}),this.play.disabled=this.frames.length<2}running(t){for(let e of[this.setter,this.line,this.list])e.hidden=!!t;this.back.hidden=!t,t&&this.live.controls.tell(""),ce(this.worst,t?[x("tr",{},["worst","member","value","of limit","at"].map(e=>x("th",{},e))),...t.worst.map(e=>this.row(e))]:[])}row(t){let e=()=>{let{app:s}=this.live;s.pause(),s.views[0].scene.cases.includes(t.case)&&s.setCase(t.case),t.time!==null&&s.goTo(s.lead.frameAt(t.time)),t.member&&s.pick({type:"member",name:t.member})},i=t.value===null?"-":$t(t.value,t.unit);return x("tr",{},x("th",{},x("button",{type:"button",class:"link",onclick:e},t.what)),x("td",{},t.member),x("td",{},i),x("td",{},Vw(t.used)),x("td",{},t.time===null?"":bh(t.time)))}};function Vw(n){return n===null?"":$t(n==="Infinity"?1/0:n,"%")}var Ag=.05,fh=class{constructor(t){this.live=t,this.banner=x("p",{class:"banner",role:"status",hidden:!0}),this.offer=x("div",{}),this.alarm=x("p",{class:"alarm",role:"alert",hidden:!0}),this.drives=new uh(t),this.changes=new hh(t),this.frames=new dh(t),this.gauge=x("meter",{min:0,max:1,low:Ag,optimum:1,value:0,"aria-label":"distance from a singular pose"}),this.gaugeText=x("output",{}),this.mobility=x("pre",{}),this.note=x("p",{class:"faint"}),this.motors=x("table",{class:"numbers"}),this.reactions=x("table",{class:"numbers"}),this.file=x("input",{type:"text","aria-label":"file name",size:18}),this.pose=x("input",{type:"checkbox"}),this.live_=x("div",{},this.drives.node,this.state(),this.changes.node),this.node=x("aside",{class:"controls","aria-label":"controls"},this.banner,this.offer,this.alarm,this.live_,this.frames.node,this.saving())}state(){return this.motorSection=be("Motors, holding still",this.motors),this.reactionSection=be("Reactions",this.reactions),this.mobilitySection=be("Mobility",this.mobility),x("div",{},x("div",{class:"gauge"},x("span",{},"Singularity gauge"),this.gauge,this.gaugeText),this.note,this.reactionSection,this.motorSection,this.mobilitySection)}saving(){let t=()=>this.save({do:"save",name:this.file.value.trim(),pose:this.pose.checked,frames:this.frames.told()});return this.saveSection=be("Save",x("div",{class:"row"},this.file,x("button",{type:"button",onclick:t},"Save")),x("label",{},this.pose," in this pose"),x("div",{class:"row"},this.undo=this.button("Undo","undo"),this.redo=this.button("Redo","redo"),this.button("Back to the file's model","reset"),this.live.root.dataset.live==="socket"?x("a",{href:"draw/"},"Draw: change the structure"):null)),this.saveSection}button(t,e){return x("button",{type:"button",onclick:()=>this.live.ask({do:e})},t)}async save(t){let e=await this.live.ask(t);e.kind==="exists"&&(this.tell(e.message,!0),this.banner.append(" ",x("button",{type:"button",onclick:()=>this.save({...t,replace:!0})},"Overwrite")))}rebuild(t){this.setup=t,this.drives.rebuild(t),this.changes.rebuild(t),this.file.value||(this.file.value=t.file||"model.yaml"),this.saveSection.hidden=!t.writable,this.history(t),this.setOffer(t.offer),this.tell("")}history({undo:t,redo:e}){for(let[i,s]of[[this.undo,t],[this.redo,e]])i.disabled=!s,i.title=s&&`${i.textContent} ${s}`}setOffer(t){let e=(i,s)=>x("button",{type:"button",onclick:()=>this.live.draft(s)},i);ce(this.offer,t?x("p",{class:"banner"},`Changes of ${new Date(1e3*t).toLocaleString()} were not saved when their studio ended. They would take the place of what this page shows. `,e("Go on with them",!0)," ",e("Remove them",!1)):null)}update(t){this.last=t,this.drives.update(t);let e=t.gauge!==null;this.gauge.value=e?t.gauge:0,this.gaugeText.textContent=e?`${ue(t.gauge,3)}${t.gauge<Ag?": near a singular pose":""}`:"not known",t.mobility&&(this.mobility.textContent=t.mobility),this.mobilitySection.hidden=!this.mobility.textContent,this.note.textContent=t.note,this.tell(t.stopped,!0),this.alarm.hidden=!t.alarms?.length,this.alarm.textContent!==(t.alarms||[]).join(" ")&&(this.alarm.textContent=(t.alarms||[]).join(" ")),this.showMotors(t.demand),this.showReactions()}showMotors(t){if(this.motorSection.hidden=!t?.length,!t?.length||!this.motorSection.open)return;let e=[["thrust","N"],["holding_torque","N m"],["breakaway_torque","N m"],["current","A"]].filter(([a])=>a in t[0]),i={thrust:"thrust",holding_torque:"hold",breakaway_torque:"start",current:"current"},s=a=>a.max_current&&a.current!==null?x("small",{class:"unit"},$t(Math.abs(a.current)/a.max_current,"%")):null,r=e.map(([a,o])=>zn(t.map(l=>l[a]??NaN),o));ce(this.motors,x("tr",{},x("th",{},"drive"),e.map(([a],o)=>x("th",{},i[a],x("small",{class:"unit"},` (${r[o][1]})`)))),t.map((a,o)=>x("tr",{},x("th",{},a.name),e.map(([l],c)=>x("td",{},r[c][0][o],l==="current"?s(a):null)))))}showReactions(){let{scene:t,running:e}=this.live;if(e||!t.has("reaction")||!this.reactionSection.open)return;let i=[..."xyz"].slice(0,t.dim),s=t.header.supported.slice(0,200),r=s.flatMap((l,c)=>t.vector("reaction",0,c).slice(0,t.dim)),[a,o]=zn(r,"N");ce(this.reactions,x("tr",{},x("th",{},"node"),i.map(l=>x("th",{},`${l} (${o})`))),s.map((l,c)=>x("tr",{},x("th",{},l),i.map((h,u)=>x("td",{},a[c*i.length+u])))))}picked(){this.changes.picked(this.live.app.picked)}running(t){this.live_.hidden=!!t,t&&(this.alarm.hidden=!0),this.frames.running(t),t?.note&&this.tell(t.note,!0)}tell(t,e=!1){this.banner.hidden=!t,this.banner.textContent=t,this.banner.classList.toggle("warning",e)}};var Hw=150,Ww=2500,Xw=40;function Cg(n){let t=new Nd(n);if(window.kinetruss.live=t,n.dataset.live==="frame")$w(t);else{t.store=`kinetruss ${location.pathname}`;let[e]=performance.getEntriesByType("navigation");e?.type==="reload"&&(t.page=sessionStorage.getItem(t.store)||""),t.connect()}}function $w(n){window.addEventListener("message",({source:t,data:e})=>{t===window.parent&&t!==window&&e?.kinetruss&&n.hear(e.kinetruss)}),window.parent.postMessage({kinetruss:'{"do":"show"}'},"*"),setTimeout(()=>n.still(),window.parent===window?0:Ww),n.open(t=>window.parent.postMessage({kinetruss:t},"*"))}var Nd=class extends ar{constructor(t){super(t),Object.assign(this,{app:null,running:!1,answers:0,adopt:!0,page:""}),this.controls=new fh(this),t.ownerDocument.addEventListener("keydown",e=>this.key(e))}get there(){return this.app}move(t){this.wanted={...this.wanted,...t},this.pump()}hurried(){return this.wanted?(this.sent=this.wanted,this.wanted=null,{command:{do:"move",values:this.sent}}):null}key(t){let e={z:t.shiftKey?"redo":"undo",y:"redo"}[t.key.toLowerCase()];!e||!(t.ctrlKey||t.metaKey)||this.closed||!this.setup?.[e]||t.target.matches("input:not([type=range], [type=checkbox]), textarea")||(t.preventDefault(),this.ask({do:e}))}showBusy(t){super.showBusy(t),!this.app&&this.root.dataset.state!=="failed"&&this.root.replaceChildren(t?x("p",{class:"failure busy"},t):"")}heard({kind:t,message:e}){(t==="error"||t==="saved")&&this.controls.tell(e,t==="error"),this.answers++,t==="state"&&!this.wanted&&!this.queue.length&&this.rest()}async unpacked(t){let[e,i]=tg(t);return e.kind==="state"?this.place(e,i):await this.stage(e,i),e}async still(){let[t]=document.querySelectorAll("script.kinetruss-scene");this.app||this.answers||!t||(this.busy.end(),this.app=new Ln(this.root,[await On(ls(t.textContent))]),window.kinetruss.app=this.app,window.kinetruss.ready=!0,this.root.dataset.state="ready",this.app.stage.append(x("p",{class:"note"},"A still: run the notebook to move it.")))}rest(){if(clearTimeout(this.timer),this.setup.members.length<=Xw||this.fine){this.fine=!1;return}this.timer=setTimeout(()=>{this.fine=!0,this.ask({do:"move",values:{},fine:!0})},Hw)}async stage(t,e){let i=await On(e),s=t.kind==="run";s||Object.assign(i.header,{kind:"live",verdict:t.state.verdict});let r=this.app;r?.end();let a=new Ln(this.root,[i],[],this.controls.node);a.stage.append(this.doing),r&&(a.shown=r.shown,a.apply(),a.views[0].sized=!0,a.views[0].copyCamera(r.views[0]),a.views[0].controls.update(),i.channel(r.channel?.id)&&a.setChannel(r.channel.id),r.picked&&i[`${r.picked.type}s`].includes(r.picked.name)&&a.pick(r.picked)),Object.assign(this,{app:a,scene:i,running:s}),window.kinetruss.app=a,a.onPick=()=>this.controls.picked(),s||(this.setup=t.setup,this.controls.rebuild(t.setup),this.controls.update(t.state),this.adopt&&this.begin(t.setup)),this.controls.running(s?t:null),window.kinetruss.ready=!0,this.root.dataset.state="ready"}place(t,e){let i=e.byteOffset;for(let[s,r]of t.arrays){let a=this.scene.arrays[s];a&&a.data.length===r&&a.data.set(new Float32Array(e.buffer,i,r)),i+=4*r}this.running||(this.scene.header.verdict=t.state.verdict,this.app.refresh()),this.controls.update(t.state)}open(t){this.post=t,this.adopt=!0,this.app||this.busy.wait("Computing ...",performance.now())}draft(t){return this.adopt=t,this.ask({do:"draft",keep:t})}begin({page:t,frames:e}){let i=this.closed,s=t===this.page&&t!=="";if(Object.assign(this,{adopt:!1,closed:!1,page:t}),this.store&&sessionStorage.setItem(this.store,t),(e.length||i&&s)&&this.controls.frames.take(e),!i){s&&this.controls.tell("The page was loaded again and goes on with its changes.");return}this.setEnded(!1),this.controls.history(this.setup),this.controls.frames.show(),s||this.controls.frames.keep(),this.controls.tell(s?"The studio answers again.":"The studio answers again, but it has kept no changes of this page: the model is that of the file.",!s)}fail(t){super.fail(t,this.store?x("p",{},x("a",{href:"draw/"},"Go to the drawing")):"")}close(){clearTimeout(this.timer),super.close(),this.app&&this.controls.tell("The studio has ended. The picture stays and cannot be changed. The changes are kept beside the file: start the studio of the same file again, and this page goes on with them.",!0)}setEnded(t){super.setEnded(t,this.controls.node)}};var Rg=`/* The colours --back, --ink and so on are those of src/kinetruss/display/palettes.py; theme.js writes them. */
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
.said { position: absolute; left: 10px; bottom: 8px; max-width: min(420px, calc(100% - 230px)); pointer-events: none; }
.said .note { margin: 0 0 4px; padding: 0 6px; font-size: 12px; color: var(--faint); }
.pane.gridless .scale { display: none; }
.names { position: absolute; inset: 0; overflow: hidden; pointer-events: none; font-size: 11px; }
.names span { position: absolute; left: 0; top: 0; color: var(--ink); white-space: nowrap; line-height: 13px; padding: 0 1px;
  text-shadow: 1px 0 1px var(--back), -1px 0 1px var(--back), 0 1px 1px var(--back), 0 -1px 1px var(--back), 0 0 4px var(--back), 0 0 4px var(--back); }
.names .of-node { font-weight: 700; }
.failure { padding: 16px; max-width: 46em; }
.diagram { pointer-events: none; }
svg.diagram { position: absolute; inset: 0; width: 100%; height: 100%; }
.diagram .area { fill: color-mix(in srgb, var(--accent) 22%, transparent); stroke: none; }
.diagram .tension { fill: color-mix(in srgb, #f2b279 55%, transparent); }
.diagram .compression { fill: color-mix(in srgb, #8fc1e3 55%, transparent); }
.diagram .rim, .diagram .shape { fill: none; stroke: var(--ink); stroke-width: 1.2; }
.diagram .shape { stroke-width: 2; }
.diagram text { fill: var(--ink); font-size: 11.5px; text-anchor: middle; dominant-baseline: central; paint-order: stroke; stroke: var(--back); stroke-width: 3px; font-variant-numeric: tabular-nums; }
.diagram .chief { font-weight: 700; }
.told { margin: 0; padding: 2px 6px; border-radius: 4px; background: color-mix(in srgb, var(--card) 85%, transparent); color: var(--faint); font-size: 12px; pointer-events: none; }
.told:empty { display: none; }
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
  .said { position: static; flex: none; max-width: none; }
  .stage { flex-direction: column; }
  .toolbar { padding: 8px 10px; }
  .toolbar .title { flex-basis: 100%; }
  .tools { gap: 6px; }
}
@media (max-width: 820px) and (orientation: portrait) {
  .panes { flex-direction: column; }
  .pane + .pane { border-left: 0; border-top: 1px solid var(--line); }
}
`;function Pg(){let n=(t,e,i)=>`${t} { ${[...Object.entries(e),...i].map(([s,r])=>`--${s}: ${r};`).join(" ")} }`;return[n("#kinetruss",Xe.light,[["over",_n],["missing",hs],["dark",0]]),n('#kinetruss[data-theme="dark"]',Xe.dark,[["dark",1]]),'#kinetruss { color-scheme: light; } #kinetruss[data-theme="dark"] { color-scheme: dark; }'].join(`
`)}async function Yw(){let n=document.getElementById("kinetruss");if(!n)return;let t=document.createElement("style");if(t.textContent=`${Pg()}
${Rg}`,document.head.append(t),n.dataset.live==="draw")return _g(n);if(n.dataset.live==="film")return Tg(n);if(n.dataset.live)return Cg(n);let e=[...document.querySelectorAll("script.kinetruss-scene")];try{let i=[];for(let r of e)i.push(await On(ls(r.textContent)));let s=new Ln(n,i,e.map(r=>r.dataset.label||""));window.kinetruss.app=s,requestAnimationFrame(()=>requestAnimationFrame(()=>{window.kinetruss.ready=!0,n.dataset.state="ready"}))}catch(i){window.kinetruss.failed=String(i?.message||i),n.dataset.state="failed",n.textContent=`This page cannot be shown: ${window.kinetruss.failed} A browser of 2023 or newer with WebGL is needed.`}}window.kinetruss={...window.kinetruss,ready:!1,App:Ln,fromBase64:ls,readScene:On};Yw();})();
