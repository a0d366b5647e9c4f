(()=>{var lo={N:[[1e9,"nN"],[1e6,"µN"],[1e3,"mN"],[1,"N"],[.001,"kN"],[1e-6,"MN"],[1e-9,"GN"]],"N m":[[1e9,"nN m"],[1e6,"µN m"],[1e3,"mN m"],[1,"N m"],[.001,"kN m"],[1e-6,"MN m"],[1e-9,"GN m"]],V:[[1e9,"nV"],[1e6,"µV"],[1e3,"mV"],[1,"V"],[.001,"kV"],[1e-6,"MV"],[1e-9,"GV"]],A:[[1e9,"nA"],[1e6,"µA"],[1e3,"mA"],[1,"A"],[.001,"kA"],[1e-6,"MA"],[1e-9,"GA"]],W:[[1e9,"nW"],[1e6,"µW"],[1e3,"mW"],[1,"W"],[.001,"kW"],[1e-6,"MW"],[1e-9,"GW"]],J:[[1e9,"nJ"],[1e6,"µJ"],[1e3,"mJ"],[1,"J"],[.001,"kJ"],[1e-6,"MJ"],[1e-9,"GJ"]],Pa:[[1,"Pa"],[.001,"kPa"],[1e-6,"MPa"],[1e-9,"GPa"]],"N/m":[[1,"N/m"],[.001,"kN/m"],[1e-6,"MN/m"],[1e-9,"GN/m"]],"N m/rad":[[1,"N m/rad"],[.001,"kN m/rad"],[1e-6,"MN m/rad"],[1e-9,"GN m/rad"]],"N s/m":[[1,"N s/m"],[.001,"kN s/m"],[1e-6,"MN s/m"],[1e-9,"GN s/m"]],Hz:[[1,"Hz"],[.001,"kHz"],[1e-6,"MHz"],[1e-9,"GHz"]],m:[[1e9,"nm"],[1e6,"µm"],[1e3,"mm"],[1,"m"]],s:[[1e9,"ns"],[1e6,"µs"],[1e3,"ms"],[1,"s"]],"m/s":[[1e9,"nm/s"],[1e6,"µm/s"],[1e3,"mm/s"],[1,"m/s"]],"m/s²":[[1e9,"nm/s²"],[1e6,"µm/s²"],[1e3,"mm/s²"],[1,"m/s²"]],kg:[[1e3,"g"],[1,"kg"],[.001,"t"]],rad:[[57.29577951308232,"deg"]],"%":[[100,"%"]]},Zn={Pa:1e-6,"N/m":1e-6,"":1e-12},bs={"%":3,"":4},hd=1e6,co=-4,sp=1e-12,rp=" ",ap=" ",op=[1,1.2,1.6,2,2.4,3.2,4,4.8,6,8,10],dd=100;var ud=["#053a7a","#2b7bba","#8fc1e3","#d4d4d4","#f2b279","#d9662b","#8c2d04"],fd=["#482878","#3e4a89","#31688e","#26828e","#1f9e89","#35b779","#6ece58","#b5de2b","#fde725"],ws="#8a8a8a",Tn="#e3003a",Cr="#9429ff",lp="#c66b9d",Ke={rigid:"#7a8ea3",driven:"#009e73",active:"#009e73",elastic:"#c66b9d",beam:"#c66b9d",cable:"#d99a00",free:"#8d98a4",frame:"#8d98a4"},ho={membrane:"#9fb6cc",solid:"#c2b59b"},qe={light:{back:"#f7f8fa",card:"#ffffff",ink:"#1d242b",faint:"#5d6873",line:"#d5dbe1",accent:"#0b62a8",pressed:"#dcebf7",halo:"#a86400",alarm:"#c40032",outline:"#3a444e",node:"#5b6672",support:"#56606b",grid:"#8a949e",body:"#a9b6c3",edge:"#2b333b","pen-1":"#0072b2","pen-2":"#c24e00","pen-3":"#00795a"},dark:{back:"#14181d",card:"#1d232a",ink:"#e3e8ee",faint:"#9aa6b2",line:"#38424d",accent:"#6db5f0",pressed:"#24405a",halo:"#ffb000",alarm:"#ff8095",outline:"#7d8894",node:"#aab4bf",support:"#97a3af",grid:"#8a949e",body:"#5d6a77",edge:"#0b0e11","pen-1":"#56b4e9","pen-2":"#f08b47","pen-3":"#2fc796"}},cp={clamp:[[[-.8,0],[.8,0]],[[-.48,0],[-.8,-.22]],[[-.16,0],[-.48,-.22]],[[.16,0],[-.16,-.22]],[[.48,0],[.16,-.22]],[[.8,0],[.48,-.22]]],pin:[[[0,0],[-.5,-.75],[.5,-.75],[0,0]],[[-.7,-.75],[.7,-.75]],[[-.42,-.75],[-.7,-.97]],[[-.14,-.75],[-.42,-.97]],[[.14,-.75],[-.14,-.97]],[[.42,-.75],[.14,-.97]],[[.7,-.75],[.42,-.97]]],roller:[[[0,0],[-.42,-.6],[.42,-.6],[0,0]],[[-.12,-.73],[-.158,-.638],[-.25,-.6],[-.342,-.638],[-.38,-.73],[-.342,-.822],[-.25,-.86],[-.158,-.822],[-.12,-.73]],[[.38,-.73],[.342,-.638],[.25,-.6],[.158,-.638],[.12,-.73],[.158,-.822],[.25,-.86],[.342,-.822],[.38,-.73]],[[-.7,-.86],[.7,-.86]],[[-.42,-.86],[-.7,-1.08]],[[-.14,-.86],[-.42,-1.08]],[[.14,-.86],[-.14,-1.08]],[[.42,-.86],[.14,-1.08]],[[.7,-.86],[.42,-1.08]]],spring:[[[0,0],[0,-.15],[.25,-.24],[-.25,-.42],[.25,-.6],[-.25,-.78],[0,-.87],[0,-1]],[[-.5,-1],[.5,-1]],[[-.3,-1],[-.5,-1.22]],[[-.1,-1],[-.3,-1.22]],[[.1,-1],[-.1,-1.22]],[[.3,-1],[.1,-1.22]],[[.5,-1],[.3,-1.22]]],gap:[[[0,0],[0,-.3]],[[-.35,-.3],[.35,-.3]],[[-.5,-.55],[.5,-.55]],[[-.3,-.55],[-.5,-.77]],[[-.1,-.55],[-.3,-.77]],[[.1,-.55],[-.1,-.77]],[[.3,-.55],[.1,-.77]],[[.5,-.55],[.3,-.77]]],turn:[[[-.35,-.35],[.35,-.35],[.35,.35],[-.35,.35],[-.35,-.35]]],"turning spring":[[[0,.15],[-.062,.149],[-.123,.123],[-.171,.071],[-.197,0],[-.193,-.08],[-.156,-.156],[-.089,-.215],[-0,-.244],[.098,-.237],[.189,-.189],[.258,-.107],[.291,-0],[.28,.116],[.223,.223],[.125,.302],[0,.339],[-.134,.324],[-.256,.256],[-.345,.143],[-.386,0],[-.367,-.152],[-.289,-.289],[-.161,-.389],[-0,-.433],[.17,-.411],[.323,-.323],[.433,-.179],[.48,-0]],[[.48,-.25],[.48,.25]]],"turning gap":[[[.485,.353],[.411,.437],[.321,.507],[.221,.558],[.112,.589],[0,.6],[-.112,.589],[-.221,.558],[-.321,.507],[-.411,.437],[-.485,.353]],[[.36,.26],[.61,.44]],[[-.36,.26],[-.61,.44]]]};function Cn(n,t){let e=lo[t],i=Math.abs(n);return e?!Number.isFinite(i)||i<(Zn[t]||Zn[""])?e.find(s=>s[0]===1)||e[0]:e.findLast(s=>i*s[0]*(1+1e-9)>=1)||e[0]:[1,t]}function Kt(n,t=4){if(Number.isNaN(n))return"-";let e=n<0?"-":"";if(!Number.isFinite(n))return`${e}∞`;if(n===0)return"0";let i=Math.abs(n),[s,r]=i.toExponential(t-1).split("e"),a=Number(r);return a<co||a>=Math.log10(hd)?`${e}${hp(s)}e${a}`:e+hp(i.toFixed(Math.max(0,t-1-a)))}function hp(n){return n.includes(".")?n.replace(/\.?0+$/,""):n}function St(n,t,e=0){if(!Number.isFinite(n))return Kt(n);let[i,s]=Cn(n,t),r=lo[t]&&Math.abs(n)<(Zn[t]||Zn[""])?0:n;return`${Kt(r*i,e||bs[t]||bs[""])} ${s}`.trimEnd()}function md(n){return Number.isFinite(n)?`${Kt(n)} s`:"-"}function an(n,t,e=0){let s=n.filter(Number.isFinite).map(Math.abs).reduce((r,a)=>Math.max(r,a),0);return uo(s,n,t,e)}function uo(n,t,e,i=0,s=!1){let[r,a]=Cn(n,e),o=Math.max(lo[e]?Zn[e]||Zn[""]:0,sp*n),l=n*r,c=l>0?Math.floor(Math.log10(l)+1e-9):0,h=i||bs[e]||bs[""],d=t.reduce((m,x)=>Number.isFinite(x)&&Math.abs(x)>o?Math.min(m,Math.abs(x)):m,1);if(c<co||c>=Math.log10(hd)||a===""&&d<10**co)return[t.map(m=>Kt(Math.abs(m)<o?0:m*r,i||bs[""])),a];let u=e==="%"&&!i,f=u?1:Math.max(0,h-1-c),p=t.filter(m=>Number.isFinite(m)&&Math.abs(m)>=o);for(;f&&!u&&!s&&p.every(m=>pd(m*r,f).endsWith("0"));)f--;let y=`0${f?ap+rp.repeat(f):""}`;return[t.map(m=>Number.isFinite(m)?Math.abs(m)<o||!m?y:pd(m*r,f):Kt(m)),a]}function pd(n,t){let e=Math.abs(n).toFixed(t);return n<0&&/[1-9]/.test(e)?`-${e}`:e}function Fx(n){return Number.isFinite(n)?n>dd?`> ${dd}`:pd(n,2):Kt(n)}function dp(n){if(!(Number.isFinite(n)&&n>0))return 1;let t=Math.floor(Math.log10(n));return[...op,12].map(e=>+`${e}e${t}`).find(e=>e>=n*(1-1e-9))}function gd(n,t,e=5){if(!(Number.isFinite(n)&&Number.isFinite(t)&&t>n))return[n];let i=Math.floor(Math.log10((t-n)/e));for(let s=0;s<9;s++){let r=[1,2,5][s%3],a=i+Math.floor(s/3),o=+`${r}e${a}`,l=Math.ceil(n/o-1e-9),c=Math.floor(t/o+1e-9);if(c-l<e)return Array.from({length:c-l+1},(h,d)=>+`${(l+d)*r}e${a}`)}return[n]}function Kn(n){let t=10**Math.floor(Math.log10(n));return([5,2,1].find(i=>i*t<=n*(1+1e-9))||1)*t}function fo(n,t,e=!1){return Number.isNaN(t)?e?"-":Hi(n)?"not checked":"not known":n.scale==="margin"?t<=0?e?"∞":"∞ (no compression)":Fx(1/t-1):St(t,n.unit)}function Hi(n){return n.scale==="capacity"||n.scale==="margin"}function Ms(n){let t=parseInt(n.slice(1),16);return[t>>16&255,t>>8&255,t&255]}var xd={diverging:ud.map(Ms),sequential:fd.map(Ms)};function up(n,t){let e=Math.min(Math.max(t,0),1)*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,a)=>r+s*(n[i+1][a]-r))}function Rn(n,t,e){if(Number.isNaN(t))return Ms(ws);if(n==="capacity"||n==="margin")return t>1?Ms(Tn):up(xd.sequential,t/e[1]);let i=e[1]-e[0]||1;return up(n==="diverging"?xd.diverging:xd.sequential,(t-e[0])/i)}function Rr(n,t){if(n==="capacity"||n==="margin")return[0,1];let e=dp(Math.max(...t.flat().map(Math.abs)));return n==="diverging"?[-e,e]:[0,e]}function Pr(n){return`linear-gradient(to right, ${(n==="diverging"?ud:fd).join(", ")})`}function g(n,t={},...e){let i=document.createElement(n);return fp(i,t),i.append(...e.flat(2).filter(s=>s!=null)),i}function ht(n,t={},...e){let i=document.createElementNS("http://www.w3.org/2000/svg",n);return fp(i,t),i.append(...e.flat()),i}function fp(n,t){for(let[e,i]of Object.entries(t))e.startsWith("on")?n.addEventListener(e.slice(2),i):i===!0?n.setAttribute(e,""):i!==!1&&i!==void 0&&n.setAttribute(e,i)}function he(n,...t){return n.replaceChildren(...t.flat().filter(Boolean)),n}function po(n,t,e,i){let s=g("button",{title:t,type:"button","aria-pressed":String(e)},n);return s.addEventListener("click",()=>i()),s}function xi(n,t){n.setAttribute("aria-pressed",String(!!t))}function de(n,...t){return g("details",{open:!0},g("summary",{},n),...t)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Ji={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Qi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Qp=0,eu=1,tm=2;var Ea=1,em=2,sr=3,zn=0,Be=1,ri=2,hs=0,rr=1,iu=2,nu=3,su=4,im=5;var ds=100,nm=101,sm=102,rm=103,am=104,om=200,lm=201,cm=202,hm=203,ru=204,au=205,dm=206,um=207,fm=208,pm=209,mm=210,gm=211,xm=212,ym=213,vm=214,jo=0,Yo=1,Zo=2,Ws=3,Ko=4,Jo=5,Qo=6,tl=7,Ll=0,_m=1,bm=2,tn=0,ou=1,lu=2,cu=3,hu=4,du=5,uu=6,fu=7;var pu=300,us=301,ar=302,Dl=303,kl=304,el=1e3,Xi=1001,il=1002,Ye=1003,wm=1004;var Ta=1005;var hi=1006,Ol=1007;var yn=1008;var pi=1009,mu=1010,gu=1011,or=1012,Ul=1013,zi=1014,Ii=1015,Gi=1016,Fl=1017,Bl=1018,fs=1020,xu=35902,yu=35899,vu=1021,_u=1022,Vi=1023,fn=1026,vn=1027,zl=1028,Gl=1029,Gn=1030,Vl=1031;var Hl=1033,Ca=33776,Ra=33777,Pa=33778,Ia=33779,Wl=35840,$l=35841,Xl=35842,ql=35843,jl=36196,Yl=37492,Zl=37496,Kl=37488,Jl=37489,Na=37490,Ql=37491,tc=37808,ec=37809,ic=37810,nc=37811,sc=37812,rc=37813,ac=37814,oc=37815,lc=37816,cc=37817,hc=37818,dc=37819,uc=37820,fc=37821,pc=36492,mc=36494,gc=36495,xc=36283,yc=36284,La=36285,vc=36286;var Xr=2300,nl=2301,Xo=2302,Wd=2303,$d=2400,Xd=2401,qd=2402;var Mm=3200;var _c=0,Sm=1,_n="",_i="srgb",qr="srgb-linear",jr="linear",me="srgb";var qo=7680;var Am=519,Em=512,Tm=513,Cm=514,bu=515,Rm=516,Pm=517,wu=518,Mu=519,Su=35044,Au=35048;var Eu="300 es",Ri=2e3,$s=2001;function Bx(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function zx(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Yr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Im(){let n=Yr("canvas");return n.style.display="block",n}var pp={},Xs=null;function Zr(...n){let t="THREE."+n.shift();Xs?Xs("log",t,...n):console.log(t,...n)}function Nm(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function zt(...n){n=Nm(n);let t="THREE."+n.shift();if(Xs)Xs("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Ht(...n){n=Nm(n);let t="THREE."+n.shift();if(Xs)Xs("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Vr(...n){let t=n.join(" ");t in pp||(pp[t]=!0,zt(...n))}function Lm(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Dm={[jo]:jo,[Zo]:Qo,[Ko]:Ko,[Ws]:Jo,[Yo]:Yo,[Qo]:Zo,[tl]:tl,[Jo]:Ws},Bi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},ni=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],mp=1234567,Vs=Math.PI/180,qs=180/Math.PI;function bn(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ni[n&255]+ni[n>>8&255]+ni[n>>16&255]+ni[n>>24&255]+"-"+ni[t&255]+ni[t>>8&255]+"-"+ni[t>>16&15|64]+ni[t>>24&255]+"-"+ni[e&63|128]+ni[e>>8&255]+"-"+ni[e>>16&255]+ni[e>>24&255]+ni[i&255]+ni[i>>8&255]+ni[i>>16&255]+ni[i>>24&255]).toLowerCase()}function Jt(n,t,e){return Math.max(t,Math.min(e,n))}function Tu(n,t){return(n%t+t)%t}function Gx(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Vx(n,t,e){return n!==t?(e-n)/(t-n):0}function Hr(n,t,e){return(1-e)*n+e*t}function Hx(n,t,e,i){return Hr(n,t,1-Math.exp(-e*i))}function Wx(n,t=1){return t-Math.abs(Tu(n,t*2)-t)}function $x(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Xx(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function qx(n,t){return n+Math.floor(Math.random()*(t-n+1))}function jx(n,t){return n+Math.random()*(t-n)}function Yx(n){return n*(.5-Math.random())}function Zx(n){n!==void 0&&(mp=n);let t=mp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Kx(n){return n*Vs}function Jx(n){return n*qs}function Qx(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function ty(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Cu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ey(n,t,e,i,s){let r=Math.cos,a=Math.sin,o=r(e/2),l=a(e/2),c=r((t+i)/2),h=a((t+i)/2),d=r((t-i)/2),u=a((t-i)/2),f=r((i-t)/2),p=a((i-t)/2);switch(s){case"XYX":n.set(o*h,l*d,l*u,o*c);break;case"YZY":n.set(l*u,o*h,l*d,o*c);break;case"ZXZ":n.set(l*d,l*u,o*h,o*c);break;case"XZX":n.set(o*h,l*p,l*f,o*c);break;case"YXY":n.set(l*f,o*h,l*p,o*c);break;case"ZYZ":n.set(l*p,l*f,o*h,o*c);break;default:zt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function bc(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Ru(n,t){if(t.constructor===Float32Array)return n;let e=bc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Pu(n,t){if(t.constructor===Float32Array)return n;let e=bc(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Iu={DEG2RAD:Vs,RAD2DEG:qs,generateUUID:bn,clamp:Jt,euclideanModulo:Tu,mapLinear:Gx,inverseLerp:Vx,lerp:Hr,damp:Hx,pingpong:Wx,smoothstep:$x,smootherstep:Xx,randInt:qx,randFloat:jx,randFloatSpread:Yx,seededRandom:Zx,degToRad:Kx,radToDeg:Jx,isPowerOfTwo:Qx,ceilPowerOfTwo:ty,floorPowerOfTwo:Cu,setQuaternionFromProperEuler:ey,normalize:Pu,denormalize:Ru},it=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Jt(this.x,t.x,e.x),this.y=Jt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Jt(this.x,t,e),this.y=Jt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Jt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*i-a*s+t.x,this.y=r*s+a*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Qe=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,a,o){let l=i[s+0],c=i[s+1],h=i[s+2],d=i[s+3],u=r[a+0],f=r[a+1],p=r[a+2],y=r[a+3];if(d!==y||l!==u||c!==f||h!==p){let m=l*u+c*f+h*p+d*y;m<0&&(u=-u,f=-f,p=-p,y=-y,m=-m);let x=1-o;if(m<.9995){let _=Math.acos(m),w=Math.sin(_);x=Math.sin(x*_)/w,o=Math.sin(o*_)/w,l=l*x+u*o,c=c*x+f*o,h=h*x+p*o,d=d*x+y*o}else{l=l*x+u*o,c=c*x+f*o,h=h*x+p*o,d=d*x+y*o;let _=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=_,c*=_,h*=_,d*=_}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,a){let o=i[s],l=i[s+1],c=i[s+2],h=i[s+3],d=r[a],u=r[a+1],f=r[a+2],p=r[a+3];return t[e]=o*p+h*d+l*f-c*u,t[e+1]=l*p+h*u+c*d-o*f,t[e+2]=c*p+h*f+o*u-l*d,t[e+3]=h*p-o*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,l=Math.sin,c=o(i/2),h=o(s/2),d=o(r/2),u=l(i/2),f=l(s/2),p=l(r/2);switch(a){case"XYZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"YXZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"ZXY":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"ZYX":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"YZX":this._x=u*h*d+c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d-u*f*p;break;case"XZY":this._x=u*h*d-c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d+u*f*p;break;default:zt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],a=e[1],o=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=i+o+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-s)*f}else if(i>o&&i>d){let f=2*Math.sqrt(1+i-o-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+a)/f,this._z=(r+c)/f}else if(o>d){let f=2*Math.sqrt(1+o-i-d);this._w=(r-c)/f,this._x=(s+a)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-i-o);this._w=(a-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Jt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,a=t._w,o=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-i*c,this._z=r*h+a*c+i*l-s*o,this._w=a*h-i*o-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(i=-i,s=-s,r=-r,a=-a,o=-o);let l=1-e;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(gp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(gp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,a=t.y,o=t.z,l=t.w,c=2*(a*s-o*i),h=2*(o*e-r*s),d=2*(r*i-a*e);return this.x=e+l*c+a*d-o*h,this.y=i+l*h+o*c-r*d,this.z=s+l*d+r*h-a*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Jt(this.x,t.x,e.x),this.y=Jt(this.y,t.y,e.y),this.z=Jt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Jt(this.x,t,e),this.y=Jt(this.y,t,e),this.z=Jt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,a=e.x,o=e.y,l=e.z;return this.x=s*l-r*o,this.y=r*a-i*l,this.z=i*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return yd.copy(this).projectOnVector(t),this.sub(yd)}reflect(t){return this.sub(yd.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Jt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},yd=new I,gp=new Qe,Xt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,a,o,l,c)}set(t,e,i,s,r,a,o,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],h=i[4],d=i[7],u=i[2],f=i[5],p=i[8],y=s[0],m=s[3],x=s[6],_=s[1],w=s[4],b=s[7],T=s[2],A=s[5],v=s[8];return r[0]=a*y+o*_+l*T,r[3]=a*m+o*w+l*A,r[6]=a*x+o*b+l*v,r[1]=c*y+h*_+d*T,r[4]=c*m+h*w+d*A,r[7]=c*x+h*b+d*v,r[2]=u*y+f*_+p*T,r[5]=u*m+f*w+p*A,r[8]=u*x+f*b+p*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8];return e*a*h-e*o*c-i*r*h+i*o*l+s*r*c-s*a*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],d=h*a-o*c,u=o*l-h*r,f=c*r-a*l,p=e*d+i*u+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return t[0]=d*y,t[1]=(s*c-h*i)*y,t[2]=(o*i-s*a)*y,t[3]=u*y,t[4]=(h*e-s*l)*y,t[5]=(s*r-o*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(a*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+t,-s*c,s*l,-s*(-c*a+l*o)+o+e,0,0,1),this}scale(t,e){return Vr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vd.makeScale(t,e)),this}rotate(t){return Vr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vd.makeRotation(-t)),this}translate(t,e){return Vr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},vd=new Xt,xp=new Xt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),yp=new Xt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function iy(){let n={enabled:!0,workingColorSpace:qr,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===me&&(s.r=un(s.r),s.g=un(s.g),s.b=un(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===me&&(s.r=Hs(s.r),s.g=Hs(s.g),s.b=Hs(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===_n?jr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[qr]:{primaries:t,whitePoint:i,transfer:jr,toXYZ:xp,fromXYZ:yp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:_i},outputColorSpaceConfig:{drawingBufferColorSpace:_i}},[_i]:{primaries:t,whitePoint:i,transfer:me,toXYZ:xp,fromXYZ:yp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:_i}}}),n}var oe=iy();function un(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Hs(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ss,sl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Ss===void 0&&(Ss=Yr("canvas")),Ss.width=t.width,Ss.height=t.height;let s=Ss.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Ss}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Yr("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=un(r[a]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(un(e[i]/255)*255):e[i]=un(e[i]);return{data:e,width:t.width,height:t.height}}else return zt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},ny=0,js=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ny++}),this.uuid=bn(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(_d(s[a].image)):r.push(_d(s[a]))}else r=_d(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function _d(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?sl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(zt("Texture: Unable to serialize Texture."),{})}var sy=0,bd=new I,di=class n extends Bi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Xi,s=Xi,r=hi,a=yn,o=Vi,l=pi,c=n.DEFAULT_ANISOTROPY,h=_n){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:sy++}),this.uuid=bn(),this.name="",this.source=new js(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Xt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(bd).x}get height(){return this.source.getSize(bd).y}get depth(){return this.source.getSize(bd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){zt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){zt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==pu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case el:t.x=t.x-Math.floor(t.x);break;case Xi:t.x=t.x<0?0:1;break;case il:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case el:t.y=t.y-Math.floor(t.y);break;case Xi:t.y=t.y<0?0:1;break;case il:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};di.DEFAULT_IMAGE=null;di.DEFAULT_MAPPING=pu;di.DEFAULT_ANISOTROPY=1;var Re=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*i+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],p=l[9],y=l[2],m=l[6],x=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-y)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+y)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+x-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,b=(f+1)/2,T=(x+1)/2,A=(h+u)/4,v=(d+y)/4,E=(p+m)/4;return w>b&&w>T?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=A/i,r=v/i):b>T?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=A/s,r=E/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=v/r,s=E/r),this.set(i,s,r,e),this}let _=Math.sqrt((m-p)*(m-p)+(d-y)*(d-y)+(u-h)*(u-h));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(d-y)/_,this.z=(u-h)/_,this.w=Math.acos((c+f+x-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Jt(this.x,t.x,e.x),this.y=Jt(this.y,t.y,e.y),this.z=Jt(this.z,t.z,e.z),this.w=Jt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Jt(this.x,t,e),this.y=Jt(this.y,t,e),this.z=Jt(this.z,t,e),this.w=Jt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Jt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},rl=class extends Bi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:hi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Re(0,0,t,e),this.scissorTest=!1,this.viewport=new Re(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new di({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:hi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new js(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wi=class extends rl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Kr=class extends di{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Ye,this.minFilter=Ye,this.wrapR=Xi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var al=class extends di{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Ye,this.minFilter=Ye,this.wrapR=Xi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ge=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,a,o,l,c,h,d,u,f,p,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,a,o,l,c,h,d,u,f,p,y,m)}set(t,e,i,s,r,a,o,l,c,h,d,u,f,p,y,m){let x=this.elements;return x[0]=t,x[4]=e,x[8]=i,x[12]=s,x[1]=r,x[5]=a,x[9]=o,x[13]=l,x[2]=c,x[6]=h,x[10]=d,x[14]=u,x[3]=f,x[7]=p,x[11]=y,x[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/As.setFromMatrixColumn(t,0).length(),r=1/As.setFromMatrixColumn(t,1).length(),a=1/As.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*a,e[9]=i[9]*a,e[10]=i[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=a*h,f=a*d,p=o*h,y=o*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+p*c,e[5]=u-y*c,e[9]=-o*l,e[2]=y-u*c,e[6]=p+f*c,e[10]=a*l}else if(t.order==="YXZ"){let u=l*h,f=l*d,p=c*h,y=c*d;e[0]=u+y*o,e[4]=p*o-f,e[8]=a*c,e[1]=a*d,e[5]=a*h,e[9]=-o,e[2]=f*o-p,e[6]=y+u*o,e[10]=a*l}else if(t.order==="ZXY"){let u=l*h,f=l*d,p=c*h,y=c*d;e[0]=u-y*o,e[4]=-a*d,e[8]=p+f*o,e[1]=f+p*o,e[5]=a*h,e[9]=y-u*o,e[2]=-a*c,e[6]=o,e[10]=a*l}else if(t.order==="ZYX"){let u=a*h,f=a*d,p=o*h,y=o*d;e[0]=l*h,e[4]=p*c-f,e[8]=u*c+y,e[1]=l*d,e[5]=y*c+u,e[9]=f*c-p,e[2]=-c,e[6]=o*l,e[10]=a*l}else if(t.order==="YZX"){let u=a*l,f=a*c,p=o*l,y=o*c;e[0]=l*h,e[4]=y-u*d,e[8]=p*d+f,e[1]=d,e[5]=a*h,e[9]=-o*h,e[2]=-c*h,e[6]=f*d+p,e[10]=u-y*d}else if(t.order==="XZY"){let u=a*l,f=a*c,p=o*l,y=o*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+y,e[5]=a*h,e[9]=f*d-p,e[2]=p*d-f,e[6]=o*h,e[10]=y*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(ry,t,ay)}lookAt(t,e,i){let s=this.elements;return yi.subVectors(t,e),yi.lengthSq()===0&&(yi.z=1),yi.normalize(),Pn.crossVectors(i,yi),Pn.lengthSq()===0&&(Math.abs(i.z)===1?yi.x+=1e-4:yi.z+=1e-4,yi.normalize(),Pn.crossVectors(i,yi)),Pn.normalize(),mo.crossVectors(yi,Pn),s[0]=Pn.x,s[4]=mo.x,s[8]=yi.x,s[1]=Pn.y,s[5]=mo.y,s[9]=yi.y,s[2]=Pn.z,s[6]=mo.z,s[10]=yi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],h=i[1],d=i[5],u=i[9],f=i[13],p=i[2],y=i[6],m=i[10],x=i[14],_=i[3],w=i[7],b=i[11],T=i[15],A=s[0],v=s[4],E=s[8],D=s[12],P=s[1],k=s[5],U=s[9],$=s[13],R=s[2],F=s[6],W=s[10],V=s[14],nt=s[3],X=s[7],Q=s[11],et=s[15];return r[0]=a*A+o*P+l*R+c*nt,r[4]=a*v+o*k+l*F+c*X,r[8]=a*E+o*U+l*W+c*Q,r[12]=a*D+o*$+l*V+c*et,r[1]=h*A+d*P+u*R+f*nt,r[5]=h*v+d*k+u*F+f*X,r[9]=h*E+d*U+u*W+f*Q,r[13]=h*D+d*$+u*V+f*et,r[2]=p*A+y*P+m*R+x*nt,r[6]=p*v+y*k+m*F+x*X,r[10]=p*E+y*U+m*W+x*Q,r[14]=p*D+y*$+m*V+x*et,r[3]=_*A+w*P+b*R+T*nt,r[7]=_*v+w*k+b*F+T*X,r[11]=_*E+w*U+b*W+T*Q,r[15]=_*D+w*$+b*V+T*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],a=t[1],o=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],p=t[3],y=t[7],m=t[11],x=t[15],_=l*f-c*u,w=o*f-c*d,b=o*u-l*d,T=a*f-c*h,A=a*u-l*h,v=a*d-o*h;return e*(y*_-m*w+x*b)-i*(p*_-m*T+x*A)+s*(p*w-y*T+x*v)-r*(p*b-y*A+m*v)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],a=t[5],o=t[9],l=t[2],c=t[6],h=t[10];return e*(a*h-o*c)-i*(r*h-o*l)+s*(r*c-a*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],p=t[12],y=t[13],m=t[14],x=t[15],_=e*o-i*a,w=e*l-s*a,b=e*c-r*a,T=i*l-s*o,A=i*c-r*o,v=s*c-r*l,E=h*y-d*p,D=h*m-u*p,P=h*x-f*p,k=d*m-u*y,U=d*x-f*y,$=u*x-f*m,R=_*$-w*U+b*k+T*P-A*D+v*E;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let F=1/R;return t[0]=(o*$-l*U+c*k)*F,t[1]=(s*U-i*$-r*k)*F,t[2]=(y*v-m*A+x*T)*F,t[3]=(u*A-d*v-f*T)*F,t[4]=(l*P-a*$-c*D)*F,t[5]=(e*$-s*P+r*D)*F,t[6]=(m*b-p*v-x*w)*F,t[7]=(h*v-u*b+f*w)*F,t[8]=(a*U-o*P+c*E)*F,t[9]=(i*P-e*U-r*E)*F,t[10]=(p*A-y*b+x*_)*F,t[11]=(d*b-h*A-f*_)*F,t[12]=(o*D-a*k-l*E)*F,t[13]=(e*k-i*D+s*E)*F,t[14]=(y*w-p*T-m*_)*F,t[15]=(h*T-d*w+u*_)*F,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,a=t.x,o=t.y,l=t.z,c=r*a,h=r*o;return this.set(c*a+i,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+i,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,a){return this.set(1,i,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,a=e._y,o=e._z,l=e._w,c=r+r,h=a+a,d=o+o,u=r*c,f=r*h,p=r*d,y=a*h,m=a*d,x=o*d,_=l*c,w=l*h,b=l*d,T=i.x,A=i.y,v=i.z;return s[0]=(1-(y+x))*T,s[1]=(f+b)*T,s[2]=(p-w)*T,s[3]=0,s[4]=(f-b)*A,s[5]=(1-(u+x))*A,s[6]=(m+_)*A,s[7]=0,s[8]=(p+w)*v,s[9]=(m-_)*v,s[10]=(1-(u+y))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let a=As.set(s[0],s[1],s[2]).length(),o=As.set(s[4],s[5],s[6]).length(),l=As.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Oi.copy(this);let c=1/a,h=1/o,d=1/l;return Oi.elements[0]*=c,Oi.elements[1]*=c,Oi.elements[2]*=c,Oi.elements[4]*=h,Oi.elements[5]*=h,Oi.elements[6]*=h,Oi.elements[8]*=d,Oi.elements[9]*=d,Oi.elements[10]*=d,e.setFromRotationMatrix(Oi),i.x=a,i.y=o,i.z=l,this}makePerspective(t,e,i,s,r,a,o=Ri,l=!1){let c=this.elements,h=2*r/(e-t),d=2*r/(i-s),u=(e+t)/(e-t),f=(i+s)/(i-s),p,y;if(l)p=r/(a-r),y=a*r/(a-r);else if(o===Ri)p=-(a+r)/(a-r),y=-2*a*r/(a-r);else if(o===$s)p=-a/(a-r),y=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,a,o=Ri,l=!1){let c=this.elements,h=2/(e-t),d=2/(i-s),u=-(e+t)/(e-t),f=-(i+s)/(i-s),p,y;if(l)p=1/(a-r),y=a/(a-r);else if(o===Ri)p=-2/(a-r),y=-(a+r)/(a-r);else if(o===$s)p=-1/(a-r),y=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},As=new I,Oi=new ge,ry=new I(0,0,0),ay=new I(1,1,1),Pn=new I,mo=new I,yi=new I,vp=new ge,_p=new Qe,pn=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Jt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Jt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(Jt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Jt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(Jt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-Jt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:zt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return vp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(vp,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return _p.setFromEuler(this),this.setFromQuaternion(_p,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};pn.DEFAULT_ORDER="XYZ";var Jr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},oy=0,bp=new I,Es=new Qe,on=new ge,go=new I,Ir=new I,ly=new I,cy=new Qe,wp=new I(1,0,0),Mp=new I(0,1,0),Sp=new I(0,0,1),Ap={type:"added"},hy={type:"removed"},Ts={type:"childadded",child:null},wd={type:"childremoved",child:null},ti=class n extends Bi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:oy++}),this.uuid=bn(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new I,e=new pn,i=new Qe,s=new I(1,1,1);function r(){i.setFromEuler(e,!1)}function a(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ge},normalMatrix:{value:new Xt}}),this.matrix=new ge,this.matrixWorld=new ge,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Jr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Es.setFromAxisAngle(t,e),this.quaternion.multiply(Es),this}rotateOnWorldAxis(t,e){return Es.setFromAxisAngle(t,e),this.quaternion.premultiply(Es),this}rotateX(t){return this.rotateOnAxis(wp,t)}rotateY(t){return this.rotateOnAxis(Mp,t)}rotateZ(t){return this.rotateOnAxis(Sp,t)}translateOnAxis(t,e){return bp.copy(t).applyQuaternion(this.quaternion),this.position.add(bp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(wp,t)}translateY(t){return this.translateOnAxis(Mp,t)}translateZ(t){return this.translateOnAxis(Sp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(on.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?go.copy(t):go.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ir.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?on.lookAt(Ir,go,this.up):on.lookAt(go,Ir,this.up),this.quaternion.setFromRotationMatrix(on),s&&(on.extractRotation(s.matrixWorld),Es.setFromRotationMatrix(on),this.quaternion.premultiply(Es.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Ht("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Ap),Ts.child=t,this.dispatchEvent(Ts),Ts.child=null):Ht("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(hy),wd.child=t,this.dispatchEvent(wd),wd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),on.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),on.multiply(t.parent.matrixWorld)),t.applyMatrix4(on),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Ap),Ts.child=t,this.dispatchEvent(Ts),Ts.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let a=this.children[i].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ir,t,ly),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ir,cy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(t.materials,this.material[l]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(t.animations,l))}}if(e){let o=a(t.geometries),l=a(t.materials),c=a(t.textures),h=a(t.images),d=a(t.shapes),u=a(t.skeletons),f=a(t.animations),p=a(t.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ti.DEFAULT_UP=new I(0,1,0);ti.DEFAULT_MATRIX_AUTO_UPDATE=!0;ti.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fe=class extends ti{constructor(){super(),this.isGroup=!0,this.type="Group"}},dy={type:"move"},Ys=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fe,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fe,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fe,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){a=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,i),x=this._getHandJoint(c,y);m!==null&&(x.matrix.fromArray(m.transform.matrix),x.matrix.decompose(x.position,x.quaternion,x.scale),x.matrixWorldNeedsUpdate=!0,x.jointRadius=m.radius),x.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&u>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(dy)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Fe;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},km={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},In={h:0,s:0,l:0},xo={h:0,s:0,l:0};function Md(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var kt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=_i){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,oe.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=oe.workingColorSpace){return this.r=t,this.g=e,this.b=i,oe.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=oe.workingColorSpace){if(t=Tu(t,1),e=Jt(e,0,1),i=Jt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,a=2*i-r;this.r=Md(a,r,t+1/3),this.g=Md(a,r,t),this.b=Md(a,r,t-1/3)}return oe.colorSpaceToWorking(this,s),this}setStyle(t,e=_i){function i(r){r!==void 0&&parseFloat(r)<1&&zt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:zt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);zt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=_i){let i=km[t.toLowerCase()];return i!==void 0?this.setHex(i,e):zt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=un(t.r),this.g=un(t.g),this.b=un(t.b),this}copyLinearToSRGB(t){return this.r=Hs(t.r),this.g=Hs(t.g),this.b=Hs(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=_i){return oe.workingToColorSpace(si.copy(this),t),Math.round(Jt(si.r*255,0,255))*65536+Math.round(Jt(si.g*255,0,255))*256+Math.round(Jt(si.b*255,0,255))}getHexString(t=_i){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=oe.workingColorSpace){oe.workingToColorSpace(si.copy(this),e);let i=si.r,s=si.g,r=si.b,a=Math.max(i,s,r),o=Math.min(i,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let d=a-o;switch(c=h<=.5?d/(a+o):d/(2-a-o),a){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=oe.workingColorSpace){return oe.workingToColorSpace(si.copy(this),e),t.r=si.r,t.g=si.g,t.b=si.b,t}getStyle(t=_i){oe.workingToColorSpace(si.copy(this),t);let e=si.r,i=si.g,s=si.b;return t!==_i?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(In),this.setHSL(In.h+t,In.s+e,In.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(In),t.getHSL(xo);let i=Hr(In.h,xo.h,e),s=Hr(In.s,xo.s,e),r=Hr(In.l,xo.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},si=new kt;kt.NAMES=km;var ns=class extends ti{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new pn,this.environmentIntensity=1,this.environmentRotation=new pn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ui=new I,ln=new I,Sd=new I,cn=new I,Cs=new I,Rs=new I,Ep=new I,Ad=new I,Ed=new I,Td=new I,Cd=new Re,Rd=new Re,Pd=new Re,$i=class n{constructor(t=new I,e=new I,i=new I){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ui.subVectors(t,e),s.cross(Ui);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ui.subVectors(s,e),ln.subVectors(i,e),Sd.subVectors(t,e);let a=Ui.dot(Ui),o=Ui.dot(ln),l=Ui.dot(Sd),c=ln.dot(ln),h=ln.dot(Sd),d=a*c-o*o;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-o*h)*u,p=(a*h-o*l)*u;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,cn)===null?!1:cn.x>=0&&cn.y>=0&&cn.x+cn.y<=1}static getInterpolation(t,e,i,s,r,a,o,l){return this.getBarycoord(t,e,i,s,cn)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,cn.x),l.addScaledVector(a,cn.y),l.addScaledVector(o,cn.z),l)}static getInterpolatedAttribute(t,e,i,s,r,a){return Cd.setScalar(0),Rd.setScalar(0),Pd.setScalar(0),Cd.fromBufferAttribute(t,e),Rd.fromBufferAttribute(t,i),Pd.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(Cd,r.x),a.addScaledVector(Rd,r.y),a.addScaledVector(Pd,r.z),a}static isFrontFacing(t,e,i,s){return Ui.subVectors(i,e),ln.subVectors(t,e),Ui.cross(ln).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ui.subVectors(this.c,this.b),ln.subVectors(this.a,this.b),Ui.cross(ln).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,a,o;Cs.subVectors(s,i),Rs.subVectors(r,i),Ad.subVectors(t,i);let l=Cs.dot(Ad),c=Rs.dot(Ad);if(l<=0&&c<=0)return e.copy(i);Ed.subVectors(t,s);let h=Cs.dot(Ed),d=Rs.dot(Ed);if(h>=0&&d<=h)return e.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),e.copy(i).addScaledVector(Cs,a);Td.subVectors(t,r);let f=Cs.dot(Td),p=Rs.dot(Td);if(p>=0&&f<=p)return e.copy(r);let y=f*c-l*p;if(y<=0&&c>=0&&p<=0)return o=c/(c-p),e.copy(i).addScaledVector(Rs,o);let m=h*p-f*d;if(m<=0&&d-h>=0&&f-p>=0)return Ep.subVectors(r,s),o=(d-h)/(d-h+(f-p)),e.copy(s).addScaledVector(Ep,o);let x=1/(m+y+u);return a=y*x,o=u*x,e.copy(i).addScaledVector(Cs,a).addScaledVector(Rs,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qi=class{constructor(t=new I(1/0,1/0,1/0),e=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Fi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Fi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Fi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,Fi):Fi.fromBufferAttribute(r,a),Fi.applyMatrix4(t.matrixWorld),this.expandByPoint(Fi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),yo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),yo.copy(i.boundingBox)),yo.applyMatrix4(t.matrixWorld),this.union(yo)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Fi),Fi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Nr),vo.subVectors(this.max,Nr),Ps.subVectors(t.a,Nr),Is.subVectors(t.b,Nr),Ns.subVectors(t.c,Nr),Nn.subVectors(Is,Ps),Ln.subVectors(Ns,Is),Jn.subVectors(Ps,Ns);let e=[0,-Nn.z,Nn.y,0,-Ln.z,Ln.y,0,-Jn.z,Jn.y,Nn.z,0,-Nn.x,Ln.z,0,-Ln.x,Jn.z,0,-Jn.x,-Nn.y,Nn.x,0,-Ln.y,Ln.x,0,-Jn.y,Jn.x,0];return!Id(e,Ps,Is,Ns,vo)||(e=[1,0,0,0,1,0,0,0,1],!Id(e,Ps,Is,Ns,vo))?!1:(_o.crossVectors(Nn,Ln),e=[_o.x,_o.y,_o.z],Id(e,Ps,Is,Ns,vo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Fi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Fi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(hn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),hn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),hn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),hn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),hn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),hn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),hn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),hn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(hn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},hn=[new I,new I,new I,new I,new I,new I,new I,new I],Fi=new I,yo=new qi,Ps=new I,Is=new I,Ns=new I,Nn=new I,Ln=new I,Jn=new I,Nr=new I,vo=new I,_o=new I,Qn=new I;function Id(n,t,e,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){Qn.fromArray(n,r);let o=s.x*Math.abs(Qn.x)+s.y*Math.abs(Qn.y)+s.z*Math.abs(Qn.z),l=t.dot(Qn),c=e.dot(Qn),h=i.dot(Qn);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var Ue=new I,bo=new it,uy=0,De=class extends Bi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:uy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Su,this.updateRanges=[],this.gpuType=Ii,this.version=0,this._normalizationScale=t!==void 0?bc(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)bo.fromBufferAttribute(this,e),bo.applyMatrix3(t),this.setXY(e,bo.x,bo.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.applyMatrix3(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.applyMatrix4(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.applyNormalMatrix(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Ue.fromBufferAttribute(this,e),Ue.transformDirection(t),this.setXYZ(e,Ue.x,Ue.y,Ue.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ru(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Pu(t,this.array)}};var Qr=class extends De{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ta=class extends De{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var _e=class extends De{constructor(t,e,i){super(new Float32Array(t),e,i)}},fy=new qi,Lr=new I,Nd=new I,mn=class{constructor(t=new I,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):fy.setFromPoints(t).getCenter(i);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Lr.subVectors(t,this.center);let e=Lr.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Lr,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Nd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Lr.copy(t.center).add(Nd)),this.expandByPoint(Lr.copy(t.center).sub(Nd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},py=0,Ci=new ge,Ld=new ti,Ls=new I,vi=new qi,Dr=new qi,je=new I,Se=class n extends Bi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:py++}),this.uuid=bn(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Bx(t)?ta:Qr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Xt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ci.makeRotationFromQuaternion(t),this.applyMatrix4(Ci),this}rotateX(t){return Ci.makeRotationX(t),this.applyMatrix4(Ci),this}rotateY(t){return Ci.makeRotationY(t),this.applyMatrix4(Ci),this}rotateZ(t){return Ci.makeRotationZ(t),this.applyMatrix4(Ci),this}translate(t,e,i){return Ci.makeTranslation(t,e,i),this.applyMatrix4(Ci),this}scale(t,e,i){return Ci.makeScale(t,e,i),this.applyMatrix4(Ci),this}lookAt(t){return Ld.lookAt(t),Ld.updateMatrix(),this.applyMatrix4(Ld.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ls).negate(),this.translate(Ls.x,Ls.y,Ls.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new _e(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&zt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new qi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ht("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];vi.setFromBufferAttribute(r),this.morphTargetsRelative?(je.addVectors(this.boundingBox.min,vi.min),this.boundingBox.expandByPoint(je),je.addVectors(this.boundingBox.max,vi.max),this.boundingBox.expandByPoint(je)):(this.boundingBox.expandByPoint(vi.min),this.boundingBox.expandByPoint(vi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ht('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new mn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ht("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(t){let i=this.boundingSphere.center;if(vi.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];Dr.setFromBufferAttribute(o),this.morphTargetsRelative?(je.addVectors(vi.min,Dr.min),vi.expandByPoint(je),je.addVectors(vi.max,Dr.max),vi.expandByPoint(je)):(vi.expandByPoint(Dr.min),vi.expandByPoint(Dr.max))}vi.getCenter(i);let s=0;for(let r=0,a=t.count;r<a;r++)je.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(je));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)je.fromBufferAttribute(o,c),l&&(Ls.fromBufferAttribute(t,c),je.add(Ls)),s=Math.max(s,i.distanceToSquared(je))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ht('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Ht("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new De(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(i.count);for(let D=0;D<i.count;D++)o[D]=new I,l[D]=new I;let h=new I,d=new I,u=new I,f=new it,p=new it,y=new it,m=new I,x=new I;function _(D,P,k){c[D]=c[P]=c[k]=1,h.fromBufferAttribute(i,D),d.fromBufferAttribute(i,P),u.fromBufferAttribute(i,k),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,P),y.fromBufferAttribute(r,k),d.sub(h),u.sub(h),p.sub(f),y.sub(f);let U=1/(p.x*y.y-y.x*p.y);isFinite(U)&&(m.copy(d).multiplyScalar(y.y).addScaledVector(u,-p.y).multiplyScalar(U),x.copy(u).multiplyScalar(p.x).addScaledVector(d,-y.x).multiplyScalar(U),o[D].add(m),o[P].add(m),o[k].add(m),l[D].add(x),l[P].add(x),l[k].add(x))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let D=0,P=w.length;D<P;++D){let k=w[D],U=k.start,$=k.count;for(let R=U,F=U+$;R<F;R+=3)_(t.getX(R+0),t.getX(R+1),t.getX(R+2))}let b=new I,T=new I,A=new I,v=new I;function E(D){A.fromBufferAttribute(s,D),v.copy(A);let P=o[D];b.copy(P),b.sub(A.multiplyScalar(A.dot(P))).normalize(),T.crossVectors(v,P);let U=T.dot(l[D])<0?-1:1;a.setXYZW(D,b.x,b.y,b.z,U)}for(let D=0,P=i.count;D<P;++D)c[D]&&E(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new De(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,f=i.count;u<f;u++)i.setXYZ(u,0,0,0);let s=new I,r=new I,a=new I,o=new I,l=new I,c=new I,h=new I,d=new I;if(t)for(let u=0,f=t.count;u<f;u+=3){let p=t.getX(u+0),y=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,y),a.fromBufferAttribute(e,m),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),o.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,m),o.add(h),l.add(h),c.add(h),i.setXYZ(p,o.x,o.y,o.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),a.fromBufferAttribute(e,u+2),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)je.fromBufferAttribute(t,e),je.normalize(),t.setXYZ(e,je.x,je.y,je.z)}toNonIndexed(){function t(o,l){let c=o.array,h=o.itemSize,d=o.normalized,u=new c.constructor(l.length*h),f=0,p=0;for(let y=0,m=l.length;y<m;y++){o.isInterleavedBufferAttribute?f=l[y]*o.data.stride+o.offset:f=l[y]*h;for(let x=0;x<h;x++)u[p++]=c[f++]}return new De(u,h,d)}if(this.index===null)return zt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=t(l,i);e.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=t(u,i);l.push(f)}e.morphAttributes[o]=l}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let c=0,h=a.length;c<h;c++){let d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},ol=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Su,this.updateRanges=[],this.version=0,this.uuid=bn()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Tp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Tp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Tp(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=bn()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ci=new I,ea=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?bc(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ci.fromBufferAttribute(this,e),ci.applyMatrix4(t),this.setXYZ(e,ci.x,ci.y,ci.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ci.fromBufferAttribute(this,e),ci.applyNormalMatrix(t),this.setXYZ(e,ci.x,ci.y,ci.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ci.fromBufferAttribute(this,e),ci.transformDirection(t),this.setXYZ(e,ci.x,ci.y,ci.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Zr("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new De(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Zr("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Ru(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Pu(t,this.data.array)}},Dd=new I,my=new I,gy=new Xt,bi=class{constructor(t=new I(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Dd.subVectors(i,e).cross(my.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Dd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||gy.getNormalMatrix(t),s=this.coplanarPoint(Dd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},xy=0,ji=class extends Bi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:xy++}),this.uuid=bn(),this.name="",this.type="Material",this.blending=rr,this.side=zn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ru,this.blendDst=au,this.blendEquation=ds,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new kt(0,0,0),this.blendAlpha=0,this.depthFunc=Ws,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Am,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=qo,this.stencilZFail=qo,this.stencilZPass=qo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){zt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){zt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new kt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new bi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new it().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Zs=class extends ji{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new kt(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Ds,kr=new I,ks=new I,Os=new I,Us=new it,Or=new it,Om=new ge,wo=new I,Ur=new I,Mo=new I,Cp=new it,kd=new it,Rp=new it,ia=class extends ti{constructor(t=new Zs){if(super(),this.isSprite=!0,this.type="Sprite",Ds===void 0){Ds=new Se;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new ol(e,5);Ds.setIndex([0,1,2,0,2,3]),Ds.setAttribute("position",new ea(i,3,0,!1)),Ds.setAttribute("uv",new ea(i,2,3,!1))}this.geometry=Ds,this.material=t,this.center=new it(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&Ht('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),ks.setFromMatrixScale(this.matrixWorld),Om.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Os.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&ks.multiplyScalar(-Os.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let a=this.center;So(wo.set(-.5,-.5,0),Os,a,ks,s,r),So(Ur.set(.5,-.5,0),Os,a,ks,s,r),So(Mo.set(.5,.5,0),Os,a,ks,s,r),Cp.set(0,0),kd.set(1,0),Rp.set(1,1);let o=t.ray.intersectTriangle(wo,Ur,Mo,!1,kr);if(o===null&&(So(Ur.set(-.5,.5,0),Os,a,ks,s,r),kd.set(0,1),o=t.ray.intersectTriangle(wo,Mo,Ur,!1,kr),o===null))return;let l=t.ray.origin.distanceTo(kr);l<t.near||l>t.far||e.push({distance:l,point:kr.clone(),uv:$i.getInterpolation(kr,wo,Ur,Mo,Cp,kd,Rp,new it),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function So(n,t,e,i,s,r){Us.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Or.x=r*Us.x-s*Us.y,Or.y=s*Us.x+r*Us.y):Or.copy(Us),n.copy(t),n.x+=Or.x,n.y+=Or.y,n.applyMatrix4(Om)}var dn=new I,Od=new I,Ao=new I,Eo=new I,ss=class{constructor(t=new I,e=new I(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,dn)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=dn.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(dn.copy(this.origin).addScaledVector(this.direction,e),dn.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Od.copy(t).add(e).multiplyScalar(.5),Ao.copy(e).sub(t).normalize(),Eo.copy(this.origin).sub(Od);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Ao),o=Eo.dot(this.direction),l=-Eo.dot(Ao),c=Eo.lengthSq(),h=Math.abs(1-a*a),d,u,f,p;if(h>0)if(d=a*l-o,u=a*o-l,p=r*h,d>=0)if(u>=-p)if(u<=p){let y=1/h;d*=y,u*=y,f=d*(d+a*u+2*o)+u*(a*d+u+2*l)+c}else u=r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;else u<=-p?(d=Math.max(0,-(-a*r+o)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=p?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(a*r+o)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=a>0?-r:r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Od).addScaledVector(Ao,u),f}intersectSphere(t,e){if(t.radius<0)return null;dn.subVectors(t.center,this.origin);let i=dn.dot(this.direction),s=dn.dot(dn)-i*i,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(i=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(i=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,a=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,a=(t.min.y-u.y)*h),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),d>=0?(o=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(o=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),i>l||o>s)||((o>i||i!==i)&&(i=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,dn)!==null}intersectTriangle(t,e,i,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,d=t.x-a.x,u=t.y-a.y,f=t.z-a.z,p=e.x-a.x,y=e.y-a.y,m=e.z-a.z,x=i.x-a.x,_=i.y-a.y,w=i.z-a.z,b=Math.abs(l),T=Math.abs(c),A=Math.abs(h),v,E,D,P,k,U,$,R,F,W,V,nt;if(b>=T&&b>=A?(D=l,U=d,F=p,nt=x,l>=0?(v=c,E=h,P=u,k=f,$=y,R=m,W=_,V=w):(v=h,E=c,P=f,k=u,$=m,R=y,W=w,V=_)):T>=A?(D=c,U=u,F=y,nt=_,c>=0?(v=h,E=l,P=f,k=d,$=m,R=p,W=w,V=x):(v=l,E=h,P=d,k=f,$=p,R=m,W=x,V=w)):(D=h,U=f,F=m,nt=w,h>=0?(v=l,E=c,P=d,k=u,$=p,R=y,W=x,V=_):(v=c,E=l,P=u,k=d,$=y,R=p,W=_,V=x)),D===0)return null;let X=v/D,Q=E/D,et=1/D,Et=P-X*U,Gt=k-Q*U,j=$-X*F,vt=R-Q*F,Tt=W-X*nt,Ut=V-Q*nt,_t=Tt*vt-Ut*j,Ft=Et*Ut-Gt*Tt,Ae=j*Gt-vt*Et;if(s){if(_t<0||Ft<0||Ae<0)return null}else if((_t<0||Ft<0||Ae<0)&&(_t>0||Ft>0||Ae>0))return null;let Vt=_t+Ft+Ae;if(Vt===0)return null;let te=et*(_t*U+Ft*F+Ae*nt);return(Vt>0?te<0:te>0)?null:this.at(te/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Yi=class extends ji{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new pn,this.combine=Ll,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Pp=new ge,ts=new ss,To=new mn,Ip=new I,Co=new I,Ro=new I,Po=new I,Ud=new I,Io=new I,Np=new I,No=new I,Ne=class extends ti{constructor(t=new Se,e=new Yi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){Io.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],d=r[l];h!==0&&(Ud.fromBufferAttribute(d,t),a?Io.addScaledVector(Ud,h):Io.addScaledVector(Ud.sub(e),h))}e.add(Io)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),To.copy(i.boundingSphere),To.applyMatrix4(r),ts.copy(t.ray).recast(t.near),!(To.containsPoint(ts.origin)===!1&&(ts.intersectSphere(To,Ip)===null||ts.origin.distanceToSquared(Ip)>(t.far-t.near)**2))&&(Pp.copy(r).invert(),ts.copy(t.ray).applyMatrix4(Pp),!(i.boundingBox!==null&&ts.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,ts)))}_computeIntersections(t,e,i){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let p=0,y=u.length;p<y;p++){let m=u[p],x=a[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(o.count,Math.min(m.start+m.count,f.start+f.count));for(let b=_,T=w;b<T;b+=3){let A=o.getX(b),v=o.getX(b+1),E=o.getX(b+2);s=Lo(this,x,t,i,c,h,d,A,v,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(o.count,f.start+f.count);for(let m=p,x=y;m<x;m+=3){let _=o.getX(m),w=o.getX(m+1),b=o.getX(m+2);s=Lo(this,a,t,i,c,h,d,_,w,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let p=0,y=u.length;p<y;p++){let m=u[p],x=a[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=_,T=w;b<T;b+=3){let A=b,v=b+1,E=b+2;s=Lo(this,x,t,i,c,h,d,A,v,E),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=p,x=y;m<x;m+=3){let _=m,w=m+1,b=m+2;s=Lo(this,a,t,i,c,h,d,_,w,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function yy(n,t,e,i,s,r,a,o){let l;if(t.side===Be?l=i.intersectTriangle(a,r,s,!0,o):l=i.intersectTriangle(s,r,a,t.side===zn,o),l===null)return null;No.copy(o),No.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(No);return c<e.near||c>e.far?null:{distance:c,point:No.clone(),object:n}}function Lo(n,t,e,i,s,r,a,o,l,c){n.getVertexPosition(o,Co),n.getVertexPosition(l,Ro),n.getVertexPosition(c,Po);let h=yy(n,t,e,i,Co,Ro,Po,Np);if(h){let d=new I;$i.getBarycoord(Np,Co,Ro,Po,d),s&&(h.uv=$i.getInterpolatedAttribute(s,o,l,c,d,new it)),r&&(h.uv1=$i.getInterpolatedAttribute(r,o,l,c,d,new it)),a&&(h.normal=$i.getInterpolatedAttribute(a,o,l,c,d,new I),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a:o,b:l,c,normal:new I,materialIndex:0};$i.getNormal(Co,Ro,Po,u.normal),h.face=u,h.barycoord=d}return h}var na=class extends di{constructor(t=null,e=1,i=1,s,r,a,o,l,c=Ye,h=Ye,d,u){super(null,a,o,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var rs=class extends De{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Fs=new ge,Lp=new ge,Do=[],Dp=new qi,vy=new ge,Fr=new Ne,Br=new mn,Zi=class extends Ne{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new rs(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,vy)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new qi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Fs),Dp.copy(t.boundingBox).applyMatrix4(Fs),this.boundingBox.union(Dp)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new mn),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Fs),Br.copy(t.boundingSphere).applyMatrix4(Fs),this.boundingSphere.union(Br)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,a=t*r+1;for(let o=0;o<i.length;o++)i[o]=s[a+o]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Fr.geometry=this.geometry,Fr.material=this.material,Fr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Br.copy(this.boundingSphere),Br.applyMatrix4(i),t.ray.intersectsSphere(Br)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Fs),Lp.multiplyMatrices(i,Fs),Fr.matrixWorld=Lp,Fr.raycast(t,Do);for(let a=0,o=Do.length;a<o;a++){let l=Do[a];l.instanceId=r,l.object=this,e.push(l)}Do.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new rs(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new na(new Float32Array(s*this.count),s,this.count,zl,Ii));let r=this.morphTexture.source.data.data,a=0;for(let c=0;c<i.length;c++)a+=i[c];let o=this.geometry.morphTargetsRelative?1:1-a,l=s*t;return r[l]=o,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},es=new mn,_y=new it(.5,.5),ko=new I,kn=class{constructor(t=new bi,e=new bi,i=new bi,s=new bi,r=new bi,a=new bi){this.planes=[t,e,i,s,r,a]}set(t,e,i,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ri,i=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],p=r[8],y=r[9],m=r[10],x=r[11],_=r[12],w=r[13],b=r[14],T=r[15];if(s[0].setComponents(c-a,f-h,x-p,T-_).normalize(),s[1].setComponents(c+a,f+h,x+p,T+_).normalize(),s[2].setComponents(c+o,f+d,x+y,T+w).normalize(),s[3].setComponents(c-o,f-d,x-y,T-w).normalize(),i)s[4].setComponents(l,u,m,b).normalize(),s[5].setComponents(c-l,f-u,x-m,T-b).normalize();else if(s[4].setComponents(c-l,f-u,x-m,T-b).normalize(),e===Ri)s[5].setComponents(c+l,f+u,x+m,T+b).normalize();else if(e===$s)s[5].setComponents(l,u,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),es.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),es.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(es)}intersectsSprite(t){es.center.set(0,0,0);let e=_y.distanceTo(t.center);return es.radius=.7071067811865476+e,es.applyMatrix4(t.matrixWorld),this.intersectsSphere(es)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(ko.x=s.normal.x>0?t.max.x:t.min.x,ko.y=s.normal.y>0?t.max.y:t.min.y,ko.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ko)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},kp=new ge,ll=class n{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];kp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new kn),i[s].setFromProjectionMatrix(kp,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new kn),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var ui=class extends ji{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new kt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},cl=new I,hl=new I,Op=new ge,zr=new ss,Oo=new mn,Fd=new I,Up=new I,Ks=class extends ti{constructor(t=new Se,e=new ui){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)cl.fromBufferAttribute(e,s-1),hl.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=cl.distanceTo(hl);t.setAttribute("lineDistance",new _e(i,1))}else zt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Oo.copy(i.boundingSphere),Oo.applyMatrix4(s),Oo.radius+=r,t.ray.intersectsSphere(Oo)===!1)return;Op.copy(s).invert(),zr.copy(t.ray).applyMatrix4(Op);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let f=Math.max(0,a.start),p=Math.min(h.count,a.start+a.count);for(let y=f,m=p-1;y<m;y+=c){let x=h.getX(y),_=h.getX(y+1),w=Uo(this,t,zr,l,x,_,y);w&&e.push(w)}if(this.isLineLoop){let y=h.getX(p-1),m=h.getX(f),x=Uo(this,t,zr,l,y,m,p-1);x&&e.push(x)}}else{let f=Math.max(0,a.start),p=Math.min(u.count,a.start+a.count);for(let y=f,m=p-1;y<m;y+=c){let x=Uo(this,t,zr,l,y,y+1,y);x&&e.push(x)}if(this.isLineLoop){let y=Uo(this,t,zr,l,p-1,f,p-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function Uo(n,t,e,i,s,r,a){let o=n.geometry.attributes.position;if(cl.fromBufferAttribute(o,s),hl.fromBufferAttribute(o,r),e.distanceSqToSegment(cl,hl,Fd,Up)>i)return;Fd.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Fd);if(!(c<t.near||c>t.far))return{distance:c,point:Up.clone().applyMatrix4(n.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:n}}var Fp=new I,Bp=new I,Pi=class extends Ks{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Fp.fromBufferAttribute(e,s),Bp.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Fp.distanceTo(Bp);t.setAttribute("lineDistance",new _e(i,1))}else zt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var sa=class extends di{constructor(t=[],e=us,i,s,r,a,o,l,c,h){super(t,e,i,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ra=class extends di{constructor(t,e,i,s,r,a,o,l,c){super(t,e,i,s,r,a,o,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var gn=class extends di{constructor(t,e,i=zi,s,r,a,o=Ye,l=Ye,c,h=fn,d=1){if(h!==fn&&h!==vn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,a,o,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new js(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},aa=class extends gn{constructor(t,e=zi,i=us,s,r,a=Ye,o=Ye,l,c=fn){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,i,s,r,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},oa=class extends di{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},On=class n extends Se{constructor(t=1,e=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],d=[],u=0,f=0;p("z","y","x",-1,-1,i,e,t,a,r,0),p("z","y","x",1,-1,i,e,-t,a,r,1),p("x","z","y",1,1,t,i,e,s,a,2),p("x","z","y",1,-1,t,i,-e,s,a,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new _e(c,3)),this.setAttribute("normal",new _e(h,3)),this.setAttribute("uv",new _e(d,2));function p(y,m,x,_,w,b,T,A,v,E,D){let P=b/v,k=T/E,U=b/2,$=T/2,R=A/2,F=v+1,W=E+1,V=0,nt=0,X=new I;for(let Q=0;Q<W;Q++){let et=Q*k-$;for(let Et=0;Et<F;Et++){let Gt=Et*P-U;X[y]=Gt*_,X[m]=et*w,X[x]=R,c.push(X.x,X.y,X.z),X[y]=0,X[m]=0,X[x]=A>0?1:-1,h.push(X.x,X.y,X.z),d.push(Et/v),d.push(1-Q/E),V+=1}}for(let Q=0;Q<E;Q++)for(let et=0;et<v;et++){let Et=u+et+F*Q,Gt=u+et+F*(Q+1),j=u+(et+1)+F*(Q+1),vt=u+(et+1)+F*Q;l.push(Et,Gt,vt),l.push(Gt,j,vt),nt+=6}o.addGroup(f,nt,D),f+=nt,u+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var xn=class n extends Se{constructor(t=1,e=1,i=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],p=0,y=[],m=i/2,x=0;_(),a===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new _e(d,3)),this.setAttribute("normal",new _e(u,3)),this.setAttribute("uv",new _e(f,2));function _(){let b=new I,T=new I,A=0,v=(e-t)/i;for(let E=0;E<=r;E++){let D=[],P=E/r,k=P*(e-t)+t;for(let U=0;U<=s;U++){let $=U/s,R=$*l+o,F=Math.sin(R),W=Math.cos(R);T.x=k*F,T.y=-P*i+m,T.z=k*W,d.push(T.x,T.y,T.z),b.set(F,v,W).normalize(),u.push(b.x,b.y,b.z),f.push($,1-P),D.push(p++)}y.push(D)}for(let E=0;E<s;E++)for(let D=0;D<r;D++){let P=y[D][E],k=y[D+1][E],U=y[D+1][E+1],$=y[D][E+1];(t>0||D!==0)&&(h.push(P,k,$),A+=3),(e>0||D!==r-1)&&(h.push(k,U,$),A+=3)}c.addGroup(x,A,0),x+=A}function w(b){let T=p,A=new it,v=new I,E=0,D=b===!0?t:e,P=b===!0?1:-1;for(let U=1;U<=s;U++)d.push(0,m*P,0),u.push(0,P,0),f.push(.5,.5),p++;let k=p;for(let U=0;U<=s;U++){let R=U/s*l+o,F=Math.cos(R),W=Math.sin(R);v.x=D*W,v.y=m*P,v.z=D*F,d.push(v.x,v.y,v.z),u.push(0,P,0),A.x=F*.5+.5,A.y=W*.5*P+.5,f.push(A.x,A.y),p++}for(let U=0;U<s;U++){let $=T+U,R=k+U;b===!0?h.push(R,R+1,$):h.push(R+1,R,$),E+=3}c.addGroup(x,E,b===!0?1:2),x+=E}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Js=class n extends xn{constructor(t=1,e=1,i=32,s=1,r=!1,a=0,o=Math.PI*2){super(0,t,e,i,s,r,a,o),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:a,thetaLength:o}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},dl=class n extends Se{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],a=[];o(s),c(i),h(),this.setAttribute("position",new _e(r,3)),this.setAttribute("normal",new _e(r.slice(),3)),this.setAttribute("uv",new _e(a,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function o(_){let w=new I,b=new I,T=new I;for(let A=0;A<e.length;A+=3)f(e[A+0],w),f(e[A+1],b),f(e[A+2],T),l(w,b,T,_)}function l(_,w,b,T){let A=T+1,v=[];for(let E=0;E<=A;E++){v[E]=[];let D=_.clone().lerp(b,E/A),P=w.clone().lerp(b,E/A),k=A-E;for(let U=0;U<=k;U++)U===0&&E===A?v[E][U]=D:v[E][U]=D.clone().lerp(P,U/k)}for(let E=0;E<A;E++)for(let D=0;D<2*(A-E)-1;D++){let P=Math.floor(D/2);D%2===0?(u(v[E][P+1]),u(v[E+1][P]),u(v[E][P])):(u(v[E][P+1]),u(v[E+1][P+1]),u(v[E+1][P]))}}function c(_){let w=new I;for(let b=0;b<r.length;b+=3)w.x=r[b+0],w.y=r[b+1],w.z=r[b+2],w.normalize().multiplyScalar(_),r[b+0]=w.x,r[b+1]=w.y,r[b+2]=w.z}function h(){let _=new I;for(let w=0;w<r.length;w+=3){_.x=r[w+0],_.y=r[w+1],_.z=r[w+2];let b=m(_)/2/Math.PI+.5,T=x(_)/Math.PI+.5;a.push(b,1-T)}p(),d()}function d(){for(let _=0;_<a.length;_+=6){let w=a[_+0],b=a[_+2],T=a[_+4],A=Math.max(w,b,T),v=Math.min(w,b,T);A>.9&&v<.1&&(w<.2&&(a[_+0]+=1),b<.2&&(a[_+2]+=1),T<.2&&(a[_+4]+=1))}}function u(_){r.push(_.x,_.y,_.z)}function f(_,w){let b=_*3;w.x=t[b+0],w.y=t[b+1],w.z=t[b+2]}function p(){let _=new I,w=new I,b=new I,T=new I,A=new it,v=new it,E=new it;for(let D=0,P=0;D<r.length;D+=9,P+=6){_.set(r[D+0],r[D+1],r[D+2]),w.set(r[D+3],r[D+4],r[D+5]),b.set(r[D+6],r[D+7],r[D+8]),A.set(a[P+0],a[P+1]),v.set(a[P+2],a[P+3]),E.set(a[P+4],a[P+5]),T.copy(_).add(w).add(b).divideScalar(3);let k=m(T);y(A,P+0,_,k),y(v,P+2,w,k),y(E,P+4,b,k)}}function y(_,w,b,T){T<0&&_.x===1&&(a[w]=_.x-1),b.x===0&&b.z===0&&(a[w]=T/2/Math.PI+.5)}function m(_){return Math.atan2(_.z,-_.x)}function x(_){return Math.atan2(-_.y,Math.sqrt(_.x*_.x+_.z*_.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var Fo=new I,Bo=new I,Bd=new I,zo=new $i,la=class extends Se{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Vs*e),a=t.getIndex(),o=t.getAttribute("position"),l=a?a.count:o.count,c=[0,0,0],h=["a","b","c"],d=new Array(3),u=new Map,f=[];for(let p=0;p<l;p+=3){a?(c[0]=a.getX(p),c[1]=a.getX(p+1),c[2]=a.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:y,b:m,c:x}=zo;if(y.fromBufferAttribute(o,c[0]),m.fromBufferAttribute(o,c[1]),x.fromBufferAttribute(o,c[2]),zo.getNormal(Bd),d[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,d[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,d[2]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let _=0;_<3;_++){let w=(_+1)%3,b=d[_],T=d[w],A=zo[h[_]],v=zo[h[w]],E=`${b}_${T}`,D=`${T}_${b}`,P=u.get(D);P?(Bd.dot(P.normal)<=r&&(f.push(A.x,A.y,A.z),f.push(v.x,v.y,v.z)),u.set(D,null)):u.has(E)||u.set(E,{index0:c[_],index1:c[w],normal:Bd.clone()})}}for(let p of u.values())if(p){let{index0:y,index1:m}=p;Fo.fromBufferAttribute(o,y),Bo.fromBufferAttribute(o,m),f.push(Fo.x,Fo.y,Fo.z),f.push(Bo.x,Bo.y,Bo.z)}this.setAttribute("position",new _e(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},Mi=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){zt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,s=this.getPoint(0),r=0;e.push(0);for(let a=1;a<=t;a++)i=this.getPoint(a/t),r+=i.distanceTo(s),e.push(r),s=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),s=0,r=i.length,a;e?a=e:a=t*i[r-1];let o=0,l=r-1,c;for(;o<=l;)if(s=Math.floor(o+(l-o)/2),c=i[s]-a,c<0)o=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,i[s]===a)return s/(r-1);let h=i[s],u=i[s+1]-h,f=(a-h)/u;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let a=this.getPoint(s),o=this.getPoint(r),l=e||(a.isVector2?new it:new I);return l.copy(o).sub(a).normalize(),l}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new I,s=[],r=[],a=[],o=new I,l=new ge;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new I)}r[0]=new I,a[0]=new I;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),d=Math.abs(s[0].y),u=Math.abs(s[0].z);h<=c&&(c=h,i.set(1,0,0)),d<=c&&(c=d,i.set(0,1,0)),u<=c&&i.set(0,0,1),o.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],o),a[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),a[f]=a[f-1].clone(),o.crossVectors(s[f-1],s[f]),o.length()>Number.EPSILON){o.normalize();let p=Math.acos(Jt(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(o,p))}a[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(Jt(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(o.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),a[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Qs=class extends Mi{constructor(t=0,e=0,i=1,s=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(t,e=new it){let i=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(a?r=0:r=s),this.aClockwise===!0&&!a&&(r===s?r=-s:r=r-s);let o=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let h=Math.cos(this.aRotation),d=Math.sin(this.aRotation),u=l-this.aX,f=c-this.aY;l=u*h-f*d+this.aX,c=u*d+f*h+this.aY}return i.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},ul=class extends Qs{constructor(t,e,i,s,r,a){super(t,e,i,i,s,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function Nu(){let n=0,t=0,e=0,i=0;function s(r,a,o,l){n=r,t=o,e=-3*r+3*a-2*o-l,i=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){s(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,h,d){let u=(a-r)/c-(o-r)/(c+h)+(o-a)/h,f=(o-a)/h-(l-a)/(h+d)+(l-o)/d;u*=h,f*=h,s(a,o,u,f)},calc:function(r){let a=r*r,o=a*r;return n+t*r+e*a+i*o}}}var zp=new I,Gp=new I,zd=new Nu,Gd=new Nu,Vd=new Nu,fl=class extends Mi{constructor(t=[],e=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=s}getPoint(t,e=new I){let i=e,s=this.points,r=s.length,a=(r-(this.closed?0:1))*t,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,h;this.closed||o>0?c=s[(o-1)%r]:(Gp.subVectors(s[0],s[1]).add(s[0]),c=Gp);let d=s[o%r],u=s[(o+1)%r];if(this.closed||o+2<r?h=s[(o+2)%r]:(zp.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=zp),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(d),f),y=Math.pow(d.distanceToSquared(u),f),m=Math.pow(u.distanceToSquared(h),f);y<1e-4&&(y=1),p<1e-4&&(p=y),m<1e-4&&(m=y),zd.initNonuniformCatmullRom(c.x,d.x,u.x,h.x,p,y,m),Gd.initNonuniformCatmullRom(c.y,d.y,u.y,h.y,p,y,m),Vd.initNonuniformCatmullRom(c.z,d.z,u.z,h.z,p,y,m)}else this.curveType==="catmullrom"&&(zd.initCatmullRom(c.x,d.x,u.x,h.x,this.tension),Gd.initCatmullRom(c.y,d.y,u.y,h.y,this.tension),Vd.initCatmullRom(c.z,d.z,u.z,h.z,this.tension));return i.set(zd.calc(l),Gd.calc(l),Vd.calc(l)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new I().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Vp(n,t,e,i,s){let r=(i-t)*.5,a=(s-e)*.5,o=n*n,l=n*o;return(2*e-2*i+r+a)*l+(-3*e+3*i-2*r-a)*o+r*n+e}function by(n,t){let e=1-n;return e*e*t}function wy(n,t){return 2*(1-n)*n*t}function My(n,t){return n*n*t}function Wr(n,t,e,i){return by(n,t)+wy(n,e)+My(n,i)}function Sy(n,t){let e=1-n;return e*e*e*t}function Ay(n,t){let e=1-n;return 3*e*e*n*t}function Ey(n,t){return 3*(1-n)*n*n*t}function Ty(n,t){return n*n*n*t}function $r(n,t,e,i,s){return Sy(n,t)+Ay(n,e)+Ey(n,i)+Ty(n,s)}var ca=class extends Mi{constructor(t=new it,e=new it,i=new it,s=new it){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new it){let i=e,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set($r(t,s.x,r.x,a.x,o.x),$r(t,s.y,r.y,a.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},pl=class extends Mi{constructor(t=new I,e=new I,i=new I,s=new I){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new I){let i=e,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return i.set($r(t,s.x,r.x,a.x,o.x),$r(t,s.y,r.y,a.y,o.y),$r(t,s.z,r.z,a.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},ha=class extends Mi{constructor(t=new it,e=new it){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new it){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new it){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ml=class extends Mi{constructor(t=new I,e=new I){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new I){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new I){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},da=class extends Mi{constructor(t=new it,e=new it,i=new it){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new it){let i=e,s=this.v0,r=this.v1,a=this.v2;return i.set(Wr(t,s.x,r.x,a.x),Wr(t,s.y,r.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},gl=class extends Mi{constructor(t=new I,e=new I,i=new I){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new I){let i=e,s=this.v0,r=this.v1,a=this.v2;return i.set(Wr(t,s.x,r.x,a.x),Wr(t,s.y,r.y,a.y),Wr(t,s.z,r.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ua=class extends Mi{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new it){let i=e,s=this.points,r=(s.length-1)*t,a=Math.floor(r),o=r-a,l=s[a===0?a:a-1],c=s[a],h=s[a>s.length-2?s.length-1:a+1],d=s[a>s.length-3?s.length-1:a+2];return i.set(Vp(o,l.x,c.x,h.x,d.x),Vp(o,l.y,c.y,h.y,d.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new it().fromArray(s))}return this}},jd=Object.freeze({__proto__:null,ArcCurve:ul,CatmullRomCurve3:fl,CubicBezierCurve:ca,CubicBezierCurve3:pl,EllipseCurve:Qs,LineCurve:ha,LineCurve3:ml,QuadraticBezierCurve:da,QuadraticBezierCurve3:gl,SplineCurve:ua}),xl=class extends Mi{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let i=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new jd[i](e,t))}return this}getPoint(t,e){let i=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=i){let a=s[r]-i,o=this.curves[r],l=o.getLength(),c=l===0?0:1-a/l;return o.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let i=0,s=this.curves.length;i<s;i++)e+=this.curves[i].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],i;for(let s=0,r=this.curves;s<r.length;s++){let a=r[s],o=a.isEllipseCurve?t*2:a.isLineCurve||a.isLineCurve3?1:a.isSplineCurve?t*a.points.length:t,l=a.getPoints(o);for(let c=0;c<l.length;c++){let h=l[c];i&&i.equals(h)||(e.push(h),i=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,i=this.curves.length;e<i;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,i=t.curves.length;e<i;e++){let s=t.curves[e];this.curves.push(new jd[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},fa=class extends xl{constructor(t){super(),this.type="Path",this.currentPoint=new it,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,i=t.length;e<i;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let i=new ha(this.currentPoint.clone(),new it(t,e));return this.curves.push(i),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,i,s){let r=new da(this.currentPoint.clone(),new it(t,e),new it(i,s));return this.curves.push(r),this.currentPoint.set(i,s),this}bezierCurveTo(t,e,i,s,r,a){let o=new ca(this.currentPoint.clone(),new it(t,e),new it(i,s),new it(r,a));return this.curves.push(o),this.currentPoint.set(r,a),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),i=new ua(e);return this.curves.push(i),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,i,s,r,a){let o=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+o,e+l,i,s,r,a),this}absarc(t,e,i,s,r,a){return this.absellipse(t,e,i,i,s,r,a),this}ellipse(t,e,i,s,r,a,o,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,i,s,r,a,o,l),this}absellipse(t,e,i,s,r,a,o,l){let c=new Qs(t,e,i,s,r,a,o,l);if(this.curves.length>0){let d=c.getPoint(0);d.equals(this.currentPoint)||this.lineTo(d.x,d.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},tr=class extends fa{constructor(t){super(t),this.uuid=bn(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let i=0,s=this.holes.length;i<s;i++)e[i]=this.holes[i].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,i=this.holes.length;e<i;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,i=t.holes.length;e<i;e++){let s=t.holes[e];this.holes.push(new fa().fromJSON(s))}return this}};function Cy(n,t,e=2){let i=t&&t.length,s=i?t[0]*e:n.length,r=Um(n,0,s,e,!0),a=[];if(!r||r.next===r.prev)return a;let o,l,c;if(i&&(r=Ly(n,t,r,e)),n.length>80*e){o=n[0],l=n[1];let h=o,d=l;for(let u=e;u<s;u+=e){let f=n[u],p=n[u+1];f<o&&(o=f),p<l&&(l=p),f>h&&(h=f),p>d&&(d=p)}c=Math.max(h-o,d-l),c=c!==0?32767/c:0}return pa(r,a,e,o,l,c,0),a}function Um(n,t,e,i,s){let r;if(s===Wy(n,t,e,i)>0)for(let a=t;a<e;a+=i)r=Hp(a/i|0,n[a],n[a+1],r);else for(let a=e-i;a>=t;a-=i)r=Hp(a/i|0,n[a],n[a+1],r);return r&&er(r,r.next)&&(ga(r),r=r.next),r}function as(n,t){if(!n)return n;t||(t=n);let e=n,i;do if(i=!1,!e.steiner&&(er(e,e.next)||Ie(e.prev,e,e.next)===0)){if(ga(e),e=t=e.prev,e===e.next)break;i=!0}else e=e.next;while(i||e!==t);return t}function pa(n,t,e,i,s,r,a){if(!n)return;!a&&r&&Fy(n,i,s,r);let o=n;for(;n.prev!==n.next;){let l=n.prev,c=n.next;if(r?Py(n,i,s,r):Ry(n)){t.push(l.i,n.i,c.i),ga(n),n=c.next,o=c.next;continue}if(n=c,n===o){a?a===1?(n=Iy(as(n),t),pa(n,t,e,i,s,r,2)):a===2&&Ny(n,t,e,i,s,r):pa(as(n),t,e,i,s,r,1);break}}}function Ry(n){let t=n.prev,e=n,i=n.next;if(Ie(t,e,i)>=0)return!1;let s=t.x,r=e.x,a=i.x,o=t.y,l=e.y,c=i.y,h=Math.min(s,r,a),d=Math.min(o,l,c),u=Math.max(s,r,a),f=Math.max(o,l,c),p=i.next;for(;p!==t;){if(p.x>=h&&p.x<=u&&p.y>=d&&p.y<=f&&Gr(s,o,r,l,a,c,p.x,p.y)&&Ie(p.prev,p,p.next)>=0)return!1;p=p.next}return!0}function Py(n,t,e,i){let s=n.prev,r=n,a=n.next;if(Ie(s,r,a)>=0)return!1;let o=s.x,l=r.x,c=a.x,h=s.y,d=r.y,u=a.y,f=Math.min(o,l,c),p=Math.min(h,d,u),y=Math.max(o,l,c),m=Math.max(h,d,u),x=Yd(f,p,t,e,i),_=Yd(y,m,t,e,i),w=n.prevZ,b=n.nextZ;for(;w&&w.z>=x&&b&&b.z<=_;){if(w.x>=f&&w.x<=y&&w.y>=p&&w.y<=m&&w!==s&&w!==a&&Gr(o,h,l,d,c,u,w.x,w.y)&&Ie(w.prev,w,w.next)>=0||(w=w.prevZ,b.x>=f&&b.x<=y&&b.y>=p&&b.y<=m&&b!==s&&b!==a&&Gr(o,h,l,d,c,u,b.x,b.y)&&Ie(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;w&&w.z>=x;){if(w.x>=f&&w.x<=y&&w.y>=p&&w.y<=m&&w!==s&&w!==a&&Gr(o,h,l,d,c,u,w.x,w.y)&&Ie(w.prev,w,w.next)>=0)return!1;w=w.prevZ}for(;b&&b.z<=_;){if(b.x>=f&&b.x<=y&&b.y>=p&&b.y<=m&&b!==s&&b!==a&&Gr(o,h,l,d,c,u,b.x,b.y)&&Ie(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function Iy(n,t){let e=n;do{let i=e.prev,s=e.next.next;!er(i,s)&&Bm(i,e,e.next,s)&&ma(i,s)&&ma(s,i)&&(t.push(i.i,e.i,s.i),ga(e),ga(e.next),e=n=s),e=e.next}while(e!==n);return as(e)}function Ny(n,t,e,i,s,r){let a=n;do{let o=a.next.next;for(;o!==a.prev;){if(a.i!==o.i&&Gy(a,o)){let l=zm(a,o);a=as(a,a.next),l=as(l,l.next),pa(a,t,e,i,s,r,0),pa(l,t,e,i,s,r,0);return}o=o.next}a=a.next}while(a!==n)}function Ly(n,t,e,i){let s=[];for(let r=0,a=t.length;r<a;r++){let o=t[r]*i,l=r<a-1?t[r+1]*i:n.length,c=Um(n,o,l,i,!1);c===c.next&&(c.steiner=!0),s.push(zy(c))}s.sort(Dy);for(let r=0;r<s.length;r++)e=ky(s[r],e);return e}function Dy(n,t){let e=n.x-t.x;if(e===0&&(e=n.y-t.y,e===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=i-s}return e}function ky(n,t){let e=Oy(n,t);if(!e)return t;let i=zm(e,n);return as(i,i.next),as(e,e.next)}function Oy(n,t){let e=t,i=n.x,s=n.y,r=-1/0,a;if(er(n,e))return e;do{if(er(n,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let d=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(d<=i&&d>r&&(r=d,a=e.x<e.next.x?e:e.next,d===i))return a}e=e.next}while(e!==t);if(!a)return null;let o=a,l=a.x,c=a.y,h=1/0;e=a;do{if(i>=e.x&&e.x>=l&&i!==e.x&&Fm(s<c?i:r,s,l,c,s<c?r:i,s,e.x,e.y)){let d=Math.abs(s-e.y)/(i-e.x);ma(e,n)&&(d<h||d===h&&(e.x>a.x||e.x===a.x&&Uy(a,e)))&&(a=e,h=d)}e=e.next}while(e!==o);return a}function Uy(n,t){return Ie(n.prev,n,t.prev)<0&&Ie(t.next,n,n.next)<0}function Fy(n,t,e,i){let s=n;do s.z===0&&(s.z=Yd(s.x,s.y,t,e,i)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==n);s.prevZ.nextZ=null,s.prevZ=null,By(s)}function By(n){let t,e=1;do{let i=n,s;n=null;let r=null;for(t=0;i;){t++;let a=i,o=0;for(let c=0;c<e&&(o++,a=a.nextZ,!!a);c++);let l=e;for(;o>0||l>0&&a;)o!==0&&(l===0||!a||i.z<=a.z)?(s=i,i=i.nextZ,o--):(s=a,a=a.nextZ,l--),r?r.nextZ=s:n=s,s.prevZ=r,r=s;i=a}r.nextZ=null,e*=2}while(t>1);return n}function Yd(n,t,e,i,s){return n=(n-e)*s|0,t=(t-i)*s|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,n|t<<1}function zy(n){let t=n,e=n;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==n);return e}function Fm(n,t,e,i,s,r,a,o){return(s-a)*(t-o)>=(n-a)*(r-o)&&(n-a)*(i-o)>=(e-a)*(t-o)&&(e-a)*(r-o)>=(s-a)*(i-o)}function Gr(n,t,e,i,s,r,a,o){return!(n===a&&t===o)&&Fm(n,t,e,i,s,r,a,o)}function Gy(n,t){return n.next.i!==t.i&&n.prev.i!==t.i&&!Vy(n,t)&&(ma(n,t)&&ma(t,n)&&Hy(n,t)&&(Ie(n.prev,n,t.prev)||Ie(n,t.prev,t))||er(n,t)&&Ie(n.prev,n,n.next)>0&&Ie(t.prev,t,t.next)>0)}function Ie(n,t,e){return(t.y-n.y)*(e.x-t.x)-(t.x-n.x)*(e.y-t.y)}function er(n,t){return n.x===t.x&&n.y===t.y}function Bm(n,t,e,i){let s=Vo(Ie(n,t,e)),r=Vo(Ie(n,t,i)),a=Vo(Ie(e,i,n)),o=Vo(Ie(e,i,t));return!!(s!==r&&a!==o||s===0&&Go(n,e,t)||r===0&&Go(n,i,t)||a===0&&Go(e,n,i)||o===0&&Go(e,t,i))}function Go(n,t,e){return t.x<=Math.max(n.x,e.x)&&t.x>=Math.min(n.x,e.x)&&t.y<=Math.max(n.y,e.y)&&t.y>=Math.min(n.y,e.y)}function Vo(n){return n>0?1:n<0?-1:0}function Vy(n,t){let e=n;do{if(e.i!==n.i&&e.next.i!==n.i&&e.i!==t.i&&e.next.i!==t.i&&Bm(e,e.next,n,t))return!0;e=e.next}while(e!==n);return!1}function ma(n,t){return Ie(n.prev,n,n.next)<0?Ie(n,t,n.next)>=0&&Ie(n,n.prev,t)>=0:Ie(n,t,n.prev)<0||Ie(n,n.next,t)<0}function Hy(n,t){let e=n,i=!1,s=(n.x+t.x)/2,r=(n.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(i=!i),e=e.next;while(e!==n);return i}function zm(n,t){let e=Zd(n.i,n.x,n.y),i=Zd(t.i,t.x,t.y),s=n.next,r=t.prev;return n.next=t,t.prev=n,e.next=s,s.prev=e,i.next=e,e.prev=i,r.next=i,i.prev=r,i}function Hp(n,t,e,i){let s=Zd(n,t,e);return i?(s.next=i.next,s.prev=i,i.next.prev=s,i.next=s):(s.prev=s,s.next=s),s}function ga(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function Zd(n,t,e){return{i:n,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Wy(n,t,e,i){let s=0;for(let r=t,a=e-i;r<e;r+=i)s+=(n[a]-n[r])*(n[r+1]+n[a+1]),a=r;return s}var Kd=class{static triangulate(t,e,i=2){return Cy(t,e,i)}},is=class n{static area(t){let e=t.length,i=0;for(let s=e-1,r=0;r<e;s=r++)i+=t[s].x*t[r].y-t[r].x*t[s].y;return i*.5}static isClockWise(t){return n.area(t)<0}static triangulateShape(t,e){let i=[],s=[],r=[];Wp(t),$p(i,t);let a=t.length;e.forEach(Wp);for(let l=0;l<e.length;l++)s.push(a),a+=e[l].length,$p(i,e[l]);let o=Kd.triangulate(i,s);for(let l=0;l<o.length;l+=3)r.push(o.slice(l,l+3));return r}};function Wp(n){let t=n.length;t>2&&n[t-1].equals(n[0])&&n.pop()}function $p(n,t){for(let e=0;e<t.length;e++)n.push(t[e].x),n.push(t[e].y)}var xa=class n extends Se{constructor(t=new tr([new it(.5,.5),new it(-.5,.5),new it(-.5,-.5),new it(.5,-.5)]),e={}){super(),this.type="ExtrudeGeometry",this.parameters={shapes:t,options:e},t=Array.isArray(t)?t:[t];let i=this,s=[],r=[];for(let o=0,l=t.length;o<l;o++){let c=t[o];a(c)}this.setAttribute("position",new _e(s,3)),this.setAttribute("uv",new _e(r,2)),this.computeVertexNormals();function a(o){let l=[],c=e.curveSegments!==void 0?e.curveSegments:12,h=e.steps!==void 0?e.steps:1,d=e.depth!==void 0?e.depth:1,u=e.bevelEnabled!==void 0?e.bevelEnabled:!0,f=e.bevelThickness!==void 0?e.bevelThickness:.2,p=e.bevelSize!==void 0?e.bevelSize:f-.1,y=e.bevelOffset!==void 0?e.bevelOffset:0,m=e.bevelSegments!==void 0?e.bevelSegments:3,x=e.extrudePath,_=e.UVGenerator!==void 0?e.UVGenerator:$y,w,b=!1,T,A,v,E;if(x){w=x.getSpacedPoints(h),b=!0,u=!1;let tt=x.isCatmullRomCurve3?x.closed:!1;T=x.computeFrenetFrames(h,tt),A=new I,v=new I,E=new I}u||(m=0,f=0,p=0,y=0);let D=o.extractPoints(c),P=D.shape,k=D.holes;if(!is.isClockWise(P)){P=P.reverse();for(let tt=0,dt=k.length;tt<dt;tt++){let ot=k[tt];is.isClockWise(ot)&&(k[tt]=ot.reverse())}}function $(tt){let ot=10000000000000001e-36,At=tt[0];for(let yt=1;yt<=tt.length;yt++){let jt=yt%tt.length,Lt=tt[jt],ne=Lt.x-At.x,se=Lt.y-At.y,ue=ne*ne+se*se,O=Math.max(Math.abs(Lt.x),Math.abs(Lt.y),Math.abs(At.x),Math.abs(At.y)),ke=ot*O*O;if(ue<=ke){tt.splice(jt,1),yt--;continue}At=Lt}}$(P),k.forEach($);let R=k.length,F=P;for(let tt=0;tt<R;tt++){let dt=k[tt];P=P.concat(dt)}function W(tt,dt,ot){return dt||Ht("ExtrudeGeometry: vec does not exist"),tt.clone().addScaledVector(dt,ot)}let V=P.length;function nt(tt,dt,ot){let At,yt,jt,Lt=tt.x-dt.x,ne=tt.y-dt.y,se=ot.x-tt.x,ue=ot.y-tt.y,O=Lt*Lt+ne*ne,ke=Lt*ue-ne*se;if(Math.abs(ke)>Number.EPSILON){let ee=Math.sqrt(O),be=Math.sqrt(se*se+ue*ue),mt=dt.x-ne/ee,Le=dt.y+Lt/ee,Bt=ot.x-ue/be,$t=ot.y+se/be,C=((Bt-mt)*ue-($t-Le)*se)/(Lt*ue-ne*se);At=mt+Lt*C-tt.x,yt=Le+ne*C-tt.y;let M=At*At+yt*yt;if(M<=2)return new it(At,yt);jt=Math.sqrt(M/2)}else{let ee=!1;Lt>Number.EPSILON?se>Number.EPSILON&&(ee=!0):Lt<-Number.EPSILON?se<-Number.EPSILON&&(ee=!0):Math.sign(ne)===Math.sign(ue)&&(ee=!0),ee?(At=-ne,yt=Lt,jt=Math.sqrt(O)):(At=Lt,yt=ne,jt=Math.sqrt(O/2))}return new it(At/jt,yt/jt)}let X=[];for(let tt=0,dt=F.length,ot=dt-1,At=tt+1;tt<dt;tt++,ot++,At++)ot===dt&&(ot=0),At===dt&&(At=0),X[tt]=nt(F[tt],F[ot],F[At]);let Q=[],et,Et=X.concat();for(let tt=0,dt=R;tt<dt;tt++){let ot=k[tt];et=[];for(let At=0,yt=ot.length,jt=yt-1,Lt=At+1;At<yt;At++,jt++,Lt++)jt===yt&&(jt=0),Lt===yt&&(Lt=0),et[At]=nt(ot[At],ot[jt],ot[Lt]);Q.push(et),Et=Et.concat(et)}let Gt;if(m===0)Gt=is.triangulateShape(F,k);else{let tt=[],dt=[];for(let ot=0;ot<m;ot++){let At=ot/m,yt=f*Math.cos(At*Math.PI/2),jt=p*Math.sin(At*Math.PI/2)+y;for(let Lt=0,ne=F.length;Lt<ne;Lt++){let se=W(F[Lt],X[Lt],jt);Ft(se.x,se.y,-yt),At===0&&tt.push(se)}for(let Lt=0,ne=R;Lt<ne;Lt++){let se=k[Lt];et=Q[Lt];let ue=[];for(let O=0,ke=se.length;O<ke;O++){let ee=W(se[O],et[O],jt);Ft(ee.x,ee.y,-yt),At===0&&ue.push(ee)}At===0&&dt.push(ue)}}Gt=is.triangulateShape(tt,dt)}let j=Gt.length,vt=p+y;for(let tt=0;tt<V;tt++){let dt=u?W(P[tt],Et[tt],vt):P[tt];b?(v.copy(T.normals[0]).multiplyScalar(dt.x),A.copy(T.binormals[0]).multiplyScalar(dt.y),E.copy(w[0]).add(v).add(A),Ft(E.x,E.y,E.z)):Ft(dt.x,dt.y,0)}for(let tt=1;tt<=h;tt++)for(let dt=0;dt<V;dt++){let ot=u?W(P[dt],Et[dt],vt):P[dt];b?(v.copy(T.normals[tt]).multiplyScalar(ot.x),A.copy(T.binormals[tt]).multiplyScalar(ot.y),E.copy(w[tt]).add(v).add(A),Ft(E.x,E.y,E.z)):Ft(ot.x,ot.y,d/h*tt)}for(let tt=m-1;tt>=0;tt--){let dt=tt/m,ot=f*Math.cos(dt*Math.PI/2),At=p*Math.sin(dt*Math.PI/2)+y;for(let yt=0,jt=F.length;yt<jt;yt++){let Lt=W(F[yt],X[yt],At);Ft(Lt.x,Lt.y,d+ot)}for(let yt=0,jt=k.length;yt<jt;yt++){let Lt=k[yt];et=Q[yt];for(let ne=0,se=Lt.length;ne<se;ne++){let ue=W(Lt[ne],et[ne],At);b?Ft(ue.x,ue.y+w[h-1].y,w[h-1].x+ot):Ft(ue.x,ue.y,d+ot)}}}Tt(),Ut();function Tt(){let tt=s.length/3;if(u){let dt=0,ot=V*dt;for(let At=0;At<j;At++){let yt=Gt[At];Ae(yt[2]+ot,yt[1]+ot,yt[0]+ot)}dt=h+m*2,ot=V*dt;for(let At=0;At<j;At++){let yt=Gt[At];Ae(yt[0]+ot,yt[1]+ot,yt[2]+ot)}}else{for(let dt=0;dt<j;dt++){let ot=Gt[dt];Ae(ot[2],ot[1],ot[0])}for(let dt=0;dt<j;dt++){let ot=Gt[dt];Ae(ot[0]+V*h,ot[1]+V*h,ot[2]+V*h)}}i.addGroup(tt,s.length/3-tt,0)}function Ut(){let tt=s.length/3,dt=0;_t(F,dt),dt+=F.length;for(let ot=0,At=k.length;ot<At;ot++){let yt=k[ot];_t(yt,dt),dt+=yt.length}i.addGroup(tt,s.length/3-tt,1)}function _t(tt,dt){let ot=tt.length;for(;--ot>=0;){let At=ot,yt=ot-1;yt<0&&(yt=tt.length-1);for(let jt=0,Lt=h+m*2;jt<Lt;jt++){let ne=V*jt,se=V*(jt+1),ue=dt+At+ne,O=dt+yt+ne,ke=dt+yt+se,ee=dt+At+se;Vt(ue,O,ke,ee)}}}function Ft(tt,dt,ot){l.push(tt),l.push(dt),l.push(ot)}function Ae(tt,dt,ot){te(tt),te(dt),te(ot);let At=s.length/3,yt=_.generateTopUV(i,s,At-3,At-2,At-1);ie(yt[0]),ie(yt[1]),ie(yt[2])}function Vt(tt,dt,ot,At){te(tt),te(dt),te(At),te(dt),te(ot),te(At);let yt=s.length/3,jt=_.generateSideWallUV(i,s,yt-6,yt-3,yt-2,yt-1);ie(jt[0]),ie(jt[1]),ie(jt[3]),ie(jt[1]),ie(jt[2]),ie(jt[3])}function te(tt){s.push(l[tt*3+0]),s.push(l[tt*3+1]),s.push(l[tt*3+2])}function ie(tt){r.push(tt.x),r.push(tt.y)}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes,i=this.parameters.options;return Xy(e,i,t)}static fromJSON(t,e){let i=[];for(let r=0,a=t.shapes.length;r<a;r++){let o=e[t.shapes[r]];i.push(o)}let s=t.options.extrudePath;return s!==void 0&&(t.options.extrudePath=new jd[s.type]().fromJSON(s)),new n(i,t.options)}},$y={generateTopUV:function(n,t,e,i,s){let r=t[e*3],a=t[e*3+1],o=t[i*3],l=t[i*3+1],c=t[s*3],h=t[s*3+1];return[new it(r,a),new it(o,l),new it(c,h)]},generateSideWallUV:function(n,t,e,i,s,r){let a=t[e*3],o=t[e*3+1],l=t[e*3+2],c=t[i*3],h=t[i*3+1],d=t[i*3+2],u=t[s*3],f=t[s*3+1],p=t[s*3+2],y=t[r*3],m=t[r*3+1],x=t[r*3+2];return Math.abs(o-h)<Math.abs(a-c)?[new it(a,1-l),new it(c,1-d),new it(u,1-p),new it(y,1-x)]:[new it(o,1-l),new it(h,1-d),new it(f,1-p),new it(m,1-x)]}};function Xy(n,t,e){if(e.shapes=[],Array.isArray(n))for(let i=0,s=n.length;i<s;i++){let r=n[i];e.shapes.push(r.uuid)}else e.shapes.push(n.uuid);return e.options=Object.assign({},t),t.extrudePath!==void 0&&(e.options.extrudePath=t.extrudePath.toJSON()),e}var os=class n extends dl{constructor(t=1,e=0){let i=(1+Math.sqrt(5))/2,s=[-1,i,0,1,i,0,-1,-i,0,1,-i,0,0,-1,i,0,1,i,0,-1,-i,0,1,-i,i,0,-1,i,0,1,-i,0,-1,-i,0,1],r=[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1];super(s,r,t,e),this.type="IcosahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}};var ya=class n extends Se{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(i),l=Math.floor(s),c=o+1,h=l+1,d=t/o,u=e/l,f=[],p=[],y=[],m=[];for(let x=0;x<h;x++){let _=x*u-a;for(let w=0;w<c;w++){let b=w*d-r;p.push(b,-_,0),y.push(0,0,1),m.push(w/o),m.push(1-x/l)}}for(let x=0;x<l;x++)for(let _=0;_<o;_++){let w=_+c*x,b=_+c*(x+1),T=_+1+c*(x+1),A=_+1+c*x;f.push(w,b,A),f.push(b,T,A)}this.setIndex(f),this.setAttribute("position",new _e(p,3)),this.setAttribute("normal",new _e(y,3)),this.setAttribute("uv",new _e(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var va=class n extends Se{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],h=[],d=[],u=new I,f=new I,p=new I;for(let y=0;y<=i;y++){let m=a+y/i*o;for(let x=0;x<=s;x++){let _=x/s*r;f.x=(t+e*Math.cos(m))*Math.cos(_),f.y=(t+e*Math.cos(m))*Math.sin(_),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),u.x=t*Math.cos(_),u.y=t*Math.sin(_),p.subVectors(f,u).normalize(),h.push(p.x,p.y,p.z),d.push(x/s),d.push(y/i)}}for(let y=1;y<=i;y++)for(let m=1;m<=s;m++){let x=(s+1)*y+m-1,_=(s+1)*(y-1)+m-1,w=(s+1)*(y-1)+m,b=(s+1)*y+m;l.push(x,_,b),l.push(_,w,b)}this.setIndex(l),this.setAttribute("position",new _e(c,3)),this.setAttribute("normal",new _e(h,3)),this.setAttribute("uv",new _e(d,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function ps(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Xp(s))s.isRenderTargetTexture?(zt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Xp(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function ai(n){let t={};for(let e=0;e<n.length;e++){let i=ps(n[e]);for(let s in i)t[s]=i[s]}return t}function Xp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function qy(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Lu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:oe.workingColorSpace}var Gm={clone:ps,merge:ai},jy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Yy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ki=class extends ji{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=jy,this.fragmentShader=Yy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ps(t.uniforms),this.uniformsGroups=qy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new kt().setHex(s.value);break;case"v2":this.uniforms[i].value=new it().fromArray(s.value);break;case"v3":this.uniforms[i].value=new I().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Re().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Xt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ge().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},yl=class extends Ki{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var fi=class extends ji{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new kt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=_c,this.normalScale=new it(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new pn,this.combine=Ll,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},vl=class extends ji{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Mm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},_l=class extends ji{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Bs(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Ho(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Un=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let a;e:{n:if(!(t<s)){for(let o=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===o)break;if(r=s,s=e[++i],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(i=2,r=o);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}a=i,i=0;break e}break i}for(;i<a;){let o=i+a>>>1;t<e[o]?a=o:i=o+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=i[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},bl=class extends Un{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:$d,endingEnd:$d}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Xd:r=t,o=2*e-i;break;case qd:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Xd:a=t,l=2*i-e;break;case qd:a=1,l=i+s[1]-s[0];break;default:a=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-o),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),y=p*p,m=y*p,x=-u*m+2*u*y-u*p,_=(1+u)*m+(-1.5-2*u)*y+(-.5+u)*p+1,w=(-1-f)*m+(1.5+f)*y+.5*p,b=f*m-f*y;for(let T=0;T!==o;++T)r[T]=x*a[h+T]+_*a[c+T]+w*a[l+T]+b*a[d+T];return r}},wl=class extends Un{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=(i-e)/(s-e),d=1-h;for(let u=0;u!==o;++u)r[u]=a[c+u]*d+a[l+u]*h;return r}},Ml=class extends Un{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Sl=class extends Un{interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this.inTangents,d=this.outTangents;if(!h||!d){let p=(i-e)/(s-e),y=1-p;for(let m=0;m!==o;++m)r[m]=a[c+m]*y+a[l+m]*p;return r}let u=o*2,f=t-1;for(let p=0;p!==o;++p){let y=a[c+p],m=a[l+p],x=f*u+p*2,_=d[x],w=d[x+1],b=t*u+p*2,T=h[b],A=h[b+1],v=Ky(i,e,_,T,s);r[p]=Vm(v,y,w,A,m)}return r}};function Vm(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Zy(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Ky(n,t,e,i,s){let r=(n-t)/(s-t);for(let a=0;a<8;a++){let o=Vm(r,t,e,i,s)-n;if(Math.abs(o)<1e-10)break;let l=Zy(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var Si=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Bs(e,this.TimeBufferType),this.values=Bs(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Bs(t.times,Array),values:Bs(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Ho(t.settings)&&(i.settings={inTangents:Bs(t.settings.inTangents,Array),outTangents:Bs(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Ml(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new wl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new bl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Sl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Xr:e=this.InterpolantFactoryMethodDiscrete;break;case nl:e=this.InterpolantFactoryMethodLinear;break;case Xo:e=this.InterpolantFactoryMethodSmooth;break;case Wd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return zt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Xr;case this.InterpolantFactoryMethodLinear:return nl;case this.InterpolantFactoryMethodSmooth:return Xo;case this.InterpolantFactoryMethodBezier:return Wd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Ho(this.settings)&&(qp(this.settings.inTangents,t),qp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Ho(this.settings)&&(jp(this.settings.inTangents,t),jp(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,a=s-1;for(;r!==s&&i[r]<t;)++r;for(;a!==-1&&i[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=i.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Ht("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Ht("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let l=i[o];if(typeof l=="number"&&isNaN(l)){Ht("KeyframeTrack: Time is not a valid number.",this,o,l),t=!1;break}if(a!==null&&a>l){Ht("KeyframeTrack: Out of order keys.",this,o,l,a),t=!1;break}a=l}if(s!==void 0&&zx(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){Ht("KeyframeTrack: Value is not a valid number.",this,o,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Xo,r=t.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=t[o],h=t[o+1];if(c!==h&&(o!==1||c!==t[0]))if(s)l=!0;else{let d=o*i,u=d-i,f=d+i;for(let p=0;p!==i;++p){let y=e[d+p];if(y!==e[u+p]||y!==e[f+p]){l=!0;break}}}if(l){if(o!==a){t[a]=t[o];let d=o*i,u=a*i;for(let f=0;f!==i;++f)e[u+f]=e[d+f]}++a}}if(r>0){t[a]=t[r];for(let o=r*i,l=a*i,c=0;c!==i;++c)e[l+c]=e[o+c];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Ho(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function qp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function jp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Si.prototype.ValueTypeName="";Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=nl;var Fn=class extends Si{constructor(t,e,i){super(t,e,i)}};Fn.prototype.ValueTypeName="bool";Fn.prototype.ValueBufferType=Array;Fn.prototype.DefaultInterpolation=Xr;Fn.prototype.InterpolantFactoryMethodLinear=void 0;Fn.prototype.InterpolantFactoryMethodSmooth=void 0;var Al=class extends Si{constructor(t,e,i,s){super(t,e,i,s)}};Al.prototype.ValueTypeName="color";var El=class extends Si{constructor(t,e,i,s){super(t,e,i,s)}};El.prototype.ValueTypeName="number";var Tl=class extends Un{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(i-e)/(s-e),c=t*o;for(let h=c+o;c!==h;c+=4)Qe.slerpFlat(r,0,a,c-o,a,c,l);return r}},_a=class extends Si{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Tl(this.times,this.values,this.getValueSize(),t)}};_a.prototype.ValueTypeName="quaternion";_a.prototype.InterpolantFactoryMethodSmooth=void 0;var Bn=class extends Si{constructor(t,e,i){super(t,e,i)}};Bn.prototype.ValueTypeName="string";Bn.prototype.ValueBufferType=Array;Bn.prototype.DefaultInterpolation=Xr;Bn.prototype.InterpolantFactoryMethodLinear=void 0;Bn.prototype.InterpolantFactoryMethodSmooth=void 0;var Cl=class extends Si{constructor(t,e,i,s){super(t,e,i,s)}};Cl.prototype.ValueTypeName="vector";var Rl=class{constructor(t,e,i){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Hm=new Rl,Pl=class{constructor(t){this.manager=t!==void 0?t:Hm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Pl.DEFAULT_MATERIAL_NAME="__DEFAULT";var ba=class extends ti{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new kt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Hd=new ge,Yp=new I,Zp=new I,Il=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new it(512,512),this.mapType=pi,this.map=null,this.mapPass=null,this.matrix=new ge,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new kn,this._frameExtents=new it(1,1),this._viewportCount=1,this._viewports=[new Re(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Yp.setFromMatrixPosition(t.matrixWorld),e.position.copy(Yp),Zp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Zp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Hd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Hd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===$s||t.reversedDepth?e.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):e.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),e.multiply(Hd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Wo=new I,$o=new Qe,Wi=new I,wa=class extends ti{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ge,this.projectionMatrix=new ge,this.projectionMatrixInverse=new ge,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Wo,$o,Wi),Wi.x===1&&Wi.y===1&&Wi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Wo,$o,Wi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Wo,$o,Wi),Wi.x===1&&Wi.y===1&&Wi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Wo,$o,Wi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Dn=new I,Kp=new it,Jp=new it,Je=class extends wa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=qs*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Vs*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return qs*2*Math.atan(Math.tan(Vs*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Dn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Dn.x,Dn.y).multiplyScalar(-t/Dn.z),Dn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Dn.x,Dn.y).multiplyScalar(-t/Dn.z)}getViewSize(t,e){return this.getViewBounds(t,Kp,Jp),e.subVectors(Jp,Kp)}setViewOffset(t,e,i,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Vs*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,e-=a.offsetY*i/c,s*=a.width/l,i*=a.height/c}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ma=class extends wa{constructor(t=-1,e=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,a=i+t,o=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Jd=class extends Il{constructor(){super(new Ma(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ls=class extends ba{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(ti.DEFAULT_UP),this.updateMatrix(),this.target=new ti,this.shadow=new Jd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},cs=class extends ba{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var zs=-90,Gs=1,ir=class extends ti{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Je(zs,Gs,t,e);s.layers=this.layers,this.add(s);let r=new Je(zs,Gs,t,e);r.layers=this.layers,this.add(r);let a=new Je(zs,Gs,t,e);a.layers=this.layers,this.add(a);let o=new Je(zs,Gs,t,e);o.layers=this.layers,this.add(o);let l=new Je(zs,Gs,t,e);l.layers=this.layers,this.add(l);let c=new Je(zs,Gs,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,a,o,l]=e;for(let c of e)this.remove(c);if(t===Ri)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===$s)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Nl=class extends Je{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Du="\\[\\]\\.:\\/",Jy=new RegExp("["+Du+"]","g"),ku="[^"+Du+"]",Qy="[^"+Du.replace("\\.","")+"]",tv=/((?:WC+[\/:])*)/.source.replace("WC",ku),ev=/(WCOD+)?/.source.replace("WCOD",Qy),iv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ku),nv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ku),sv=new RegExp("^"+tv+ev+iv+nv+"$"),rv=["material","materials","bones","map"],Qd=class{constructor(t,e,i){let s=i||Ee.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ee=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Jy,"")}static parseTrackName(t){let e=sv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);rv.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let l=i(o.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){zt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ht("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ht("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ht("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Ht("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Ht("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let a=t[s];if(a===void 0){let c=e.nodeName;Ht("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ee.Composite=Qd;Ee.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ee.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ee.prototype.GetterByBindingType=[Ee.prototype._getValue_direct,Ee.prototype._getValue_array,Ee.prototype._getValue_arrayElement,Ee.prototype._getValue_toArray];Ee.prototype.SetterByBindingTypeAndVersioning=[[Ee.prototype._setValue_direct,Ee.prototype._setValue_direct_setNeedsUpdate,Ee.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ee.prototype._setValue_array,Ee.prototype._setValue_array_setNeedsUpdate,Ee.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ee.prototype._setValue_arrayElement,Ee.prototype._setValue_arrayElement_setNeedsUpdate,Ee.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ee.prototype._setValue_fromArray,Ee.prototype._setValue_fromArray_setNeedsUpdate,Ee.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nT=new Float32Array(1);var nr=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Jt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Jt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var tu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Sa=class extends Pi{constructor(t=10,e=10,i=4473924,s=8947848){i=new kt(i),s=new kt(s);let r=e/2,a=t/e,o=t/2,l=[],c=[];for(let u=0,f=0,p=-o;u<=e;u++,p+=a){l.push(-o,0,p,o,0,p),l.push(p,0,-o,p,0,o);let y=u===r?i:s;y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3}let h=new Se;h.setAttribute("position",new _e(l,3)),h.setAttribute("color",new _e(c,3));let d=new ui({vertexColors:!0,toneMapped:!1});super(h,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Aa=class extends Bi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Ou(n,t,e,i){let s=av(i);switch(e){case vu:return n*t;case zl:return n*t/s.components*s.byteLength;case Gl:return n*t/s.components*s.byteLength;case Gn:return n*t*2/s.components*s.byteLength;case Vl:return n*t*2/s.components*s.byteLength;case _u:return n*t*3/s.components*s.byteLength;case Vi:return n*t*4/s.components*s.byteLength;case Hl:return n*t*4/s.components*s.byteLength;case Ca:case Ra:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Pa:case Ia:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case $l:case ql:return Math.max(n,16)*Math.max(t,8)/4;case Wl:case Xl:return Math.max(n,8)*Math.max(t,8)/2;case jl:case Yl:case Kl:case Jl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Zl:case Na:case Ql:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case tc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ec:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case ic:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case nc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case sc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case rc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case ac:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case oc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case lc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case cc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case hc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case dc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case uc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case fc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case pc:case mc:case gc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case xc:case yc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case La:case vc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function av(n){switch(n){case pi:case mu:return{byteLength:1,components:1};case or:case gu:case Gi:return{byteLength:2,components:1};case Fl:case Bl:return{byteLength:2,components:4};case zi:case Ul:case Ii:return{byteLength:4,components:1};case xu:case yu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?zt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function dg(){let n=null,t=!1,e=null,i=null;function s(r,a){i=n.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function lv(n){let t=new WeakMap;function e(o,l){let c=o.array,h=o.usage,d=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function i(o,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,o),d.length===0)n.bufferSubData(c,0,h);else{d.sort((f,p)=>f.start-p.start);let u=0;for(let f=1;f<d.length;f++){let p=d[u],y=d[f];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++u,d[u]=y)}d.length=u+1;for(let f=0,p=d.length;f<p;f++){let y=d[f];n.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=t.get(o);l&&(n.deleteBuffer(l.buffer),t.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=t.get(o);if(c===void 0)t.set(o,e(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var cv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,hv=`#ifdef USE_ALPHAHASH
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
#endif`,dv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,uv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,fv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,pv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,mv=`#ifdef USE_AOMAP
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
#endif`,gv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,xv=`#ifdef USE_BATCHING
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
#endif`,yv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,vv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,_v=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,bv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,wv=`#ifdef USE_IRIDESCENCE
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
#endif`,Mv=`#ifdef USE_BUMPMAP
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
#endif`,Sv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Av=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ev=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Tv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Cv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Rv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Pv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Iv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Nv=`#define PI 3.141592653589793
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
} // validated`,Lv=`vec3 transformedNormal = objectNormal;
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
#endif`,Dv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,kv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Ov=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Uv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Fv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Bv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,zv=`#ifdef USE_ENVMAP
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
#endif`,Gv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Vv=`#ifdef USE_ENVMAP
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
#endif`,Hv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Wv=`#ifdef USE_ENVMAP
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
#endif`,$v=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Xv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,qv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,jv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Yv=`#ifdef USE_GRADIENTMAP
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
}`,Zv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Kv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Jv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Qv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,t_=`#ifdef USE_ENVMAP
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
#endif`,e_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,i_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,n_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,s_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,r_=`PhysicalMaterial material;
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
#endif`,a_=`uniform sampler2D dfgLUT;
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
}`,o_=`
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
#endif`,l_=`#if defined( RE_IndirectDiffuse )
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
#endif`,c_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,h_=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,d_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,u_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,f_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,p_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,m_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,g_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,x_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,y_=`#if defined( USE_POINTS_UV )
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
#endif`,v_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,__=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,b_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,w_=`#if defined( USE_MORPHCOLORS )
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
#endif`,M_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,S_=`#ifdef USE_MORPHTARGETS
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
#endif`,A_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,E_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
#endif`,C_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,R_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,P_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,I_=`#ifdef USE_NORMALMAP
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
#endif`,N_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,L_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,D_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,k_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,O_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,U_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,F_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,B_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,z_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,G_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,V_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,H_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,W_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,$_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,X_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,q_=`float getShadowMask() {
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
}`,j_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Y_=`#ifdef USE_SKINNING
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
#endif`,Z_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,K_=`#ifdef USE_SKINNING
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
#endif`,J_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Q_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,tb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,eb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ib=`#ifdef USE_TRANSMISSION
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
#endif`,nb=`#ifdef USE_TRANSMISSION
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
#endif`,sb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ab=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ob=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,lb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,cb=`uniform sampler2D t2D;
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
}`,hb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,db=`uniform float backgroundBlurriness;
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
}`,ub=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pb=`#include <common>
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
}`,mb=`#if DEPTH_PACKING == 3200
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
}`,gb=`#define DISTANCE
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
}`,xb=`#define DISTANCE
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
}`,yb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,vb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_b=`uniform float scale;
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
}`,bb=`uniform vec3 diffuse;
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
}`,wb=`#include <common>
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
}`,Mb=`uniform vec3 diffuse;
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
}`,Sb=`#define LAMBERT
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
}`,Ab=`#define LAMBERT
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
}`,Eb=`#define MATCAP
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
}`,Tb=`#define MATCAP
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
}`,Cb=`#define NORMAL
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
}`,Rb=`#define NORMAL
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
}`,Pb=`#define PHONG
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
}`,Ib=`#define PHONG
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
}`,Nb=`#define STANDARD
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
}`,Lb=`#define STANDARD
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
}`,Db=`#define TOON
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
}`,kb=`#define TOON
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
}`,Ob=`uniform float size;
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
}`,Ub=`uniform vec3 diffuse;
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
}`,Fb=`#include <common>
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
}`,Bb=`uniform vec3 color;
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
}`,zb=`uniform float rotation;
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
}`,Gb=`uniform vec3 diffuse;
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
}`,Qt={alphahash_fragment:cv,alphahash_pars_fragment:hv,alphamap_fragment:dv,alphamap_pars_fragment:uv,alphatest_fragment:fv,alphatest_pars_fragment:pv,aomap_fragment:mv,aomap_pars_fragment:gv,batching_pars_vertex:xv,batching_vertex:yv,begin_vertex:vv,beginnormal_vertex:_v,bsdfs:bv,iridescence_fragment:wv,bumpmap_pars_fragment:Mv,clipping_planes_fragment:Sv,clipping_planes_pars_fragment:Av,clipping_planes_pars_vertex:Ev,clipping_planes_vertex:Tv,color_fragment:Cv,color_pars_fragment:Rv,color_pars_vertex:Pv,color_vertex:Iv,common:Nv,defaultnormal_vertex:Lv,displacementmap_pars_vertex:Dv,displacementmap_vertex:kv,emissivemap_fragment:Ov,emissivemap_pars_fragment:Uv,colorspace_fragment:Fv,colorspace_pars_fragment:Bv,envmap_fragment:zv,envmap_common_pars_fragment:Gv,envmap_pars_fragment:Vv,envmap_pars_vertex:Hv,envmap_physical_pars_fragment:t_,envmap_vertex:Wv,fog_vertex:$v,fog_pars_vertex:Xv,fog_fragment:qv,fog_pars_fragment:jv,gradientmap_pars_fragment:Yv,lightmap_pars_fragment:Zv,lights_lambert_fragment:Kv,lights_lambert_pars_fragment:Jv,lights_pars_begin:Qv,lights_toon_fragment:e_,lights_toon_pars_fragment:i_,lights_phong_fragment:n_,lights_phong_pars_fragment:s_,lights_physical_fragment:r_,lights_physical_pars_fragment:a_,lights_fragment_begin:o_,lights_fragment_maps:l_,lights_fragment_end:c_,lightprobes_pars_fragment:h_,logdepthbuf_fragment:d_,logdepthbuf_pars_fragment:u_,logdepthbuf_pars_vertex:f_,logdepthbuf_vertex:p_,map_fragment:m_,map_pars_fragment:g_,map_particle_fragment:x_,map_particle_pars_fragment:y_,metalnessmap_fragment:v_,metalnessmap_pars_fragment:__,morphinstance_vertex:b_,morphcolor_vertex:w_,morphnormal_vertex:M_,morphtarget_pars_vertex:S_,morphtarget_vertex:A_,normal_fragment_begin:E_,normal_fragment_maps:T_,normal_pars_fragment:C_,normal_pars_vertex:R_,normal_vertex:P_,normalmap_pars_fragment:I_,clearcoat_normal_fragment_begin:N_,clearcoat_normal_fragment_maps:L_,clearcoat_pars_fragment:D_,iridescence_pars_fragment:k_,opaque_fragment:O_,packing:U_,premultiplied_alpha_fragment:F_,project_vertex:B_,dithering_fragment:z_,dithering_pars_fragment:G_,roughnessmap_fragment:V_,roughnessmap_pars_fragment:H_,shadowmap_pars_fragment:W_,shadowmap_pars_vertex:$_,shadowmap_vertex:X_,shadowmask_pars_fragment:q_,skinbase_vertex:j_,skinning_pars_vertex:Y_,skinning_vertex:Z_,skinnormal_vertex:K_,specularmap_fragment:J_,specularmap_pars_fragment:Q_,tonemapping_fragment:tb,tonemapping_pars_fragment:eb,transmission_fragment:ib,transmission_pars_fragment:nb,uv_pars_fragment:sb,uv_pars_vertex:rb,uv_vertex:ab,worldpos_vertex:ob,background_vert:lb,background_frag:cb,backgroundCube_vert:hb,backgroundCube_frag:db,cube_vert:ub,cube_frag:fb,depth_vert:pb,depth_frag:mb,distance_vert:gb,distance_frag:xb,equirect_vert:yb,equirect_frag:vb,linedashed_vert:_b,linedashed_frag:bb,meshbasic_vert:wb,meshbasic_frag:Mb,meshlambert_vert:Sb,meshlambert_frag:Ab,meshmatcap_vert:Eb,meshmatcap_frag:Tb,meshnormal_vert:Cb,meshnormal_frag:Rb,meshphong_vert:Pb,meshphong_frag:Ib,meshphysical_vert:Nb,meshphysical_frag:Lb,meshtoon_vert:Db,meshtoon_frag:kb,points_vert:Ob,points_frag:Ub,shadow_vert:Fb,shadow_frag:Bb,sprite_vert:zb,sprite_frag:Gb},wt={common:{diffuse:{value:new kt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Xt},alphaMap:{value:null},alphaMapTransform:{value:new Xt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Xt}},envmap:{envMap:{value:null},envMapRotation:{value:new Xt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Xt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Xt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Xt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Xt},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Xt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Xt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Xt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Xt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new kt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new kt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Xt},alphaTest:{value:0},uvTransform:{value:new Xt}},sprite:{diffuse:{value:new kt(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Xt},alphaMap:{value:null},alphaMapTransform:{value:new Xt},alphaTest:{value:0}}},nn={basic:{uniforms:ai([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.fog]),vertexShader:Qt.meshbasic_vert,fragmentShader:Qt.meshbasic_frag},lambert:{uniforms:ai([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,wt.lights,{emissive:{value:new kt(0)},envMapIntensity:{value:1}}]),vertexShader:Qt.meshlambert_vert,fragmentShader:Qt.meshlambert_frag},phong:{uniforms:ai([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,wt.lights,{emissive:{value:new kt(0)},specular:{value:new kt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Qt.meshphong_vert,fragmentShader:Qt.meshphong_frag},standard:{uniforms:ai([wt.common,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.roughnessmap,wt.metalnessmap,wt.fog,wt.lights,{emissive:{value:new kt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Qt.meshphysical_vert,fragmentShader:Qt.meshphysical_frag},toon:{uniforms:ai([wt.common,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.gradientmap,wt.fog,wt.lights,{emissive:{value:new kt(0)}}]),vertexShader:Qt.meshtoon_vert,fragmentShader:Qt.meshtoon_frag},matcap:{uniforms:ai([wt.common,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,{matcap:{value:null}}]),vertexShader:Qt.meshmatcap_vert,fragmentShader:Qt.meshmatcap_frag},points:{uniforms:ai([wt.points,wt.fog]),vertexShader:Qt.points_vert,fragmentShader:Qt.points_frag},dashed:{uniforms:ai([wt.common,wt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Qt.linedashed_vert,fragmentShader:Qt.linedashed_frag},depth:{uniforms:ai([wt.common,wt.displacementmap]),vertexShader:Qt.depth_vert,fragmentShader:Qt.depth_frag},normal:{uniforms:ai([wt.common,wt.bumpmap,wt.normalmap,wt.displacementmap,{opacity:{value:1}}]),vertexShader:Qt.meshnormal_vert,fragmentShader:Qt.meshnormal_frag},sprite:{uniforms:ai([wt.sprite,wt.fog]),vertexShader:Qt.sprite_vert,fragmentShader:Qt.sprite_frag},background:{uniforms:{uvTransform:{value:new Xt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Qt.background_vert,fragmentShader:Qt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Xt}},vertexShader:Qt.backgroundCube_vert,fragmentShader:Qt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Qt.cube_vert,fragmentShader:Qt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Qt.equirect_vert,fragmentShader:Qt.equirect_frag},distance:{uniforms:ai([wt.common,wt.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Qt.distance_vert,fragmentShader:Qt.distance_frag},shadow:{uniforms:ai([wt.lights,wt.fog,{color:{value:new kt(0)},opacity:{value:1}}]),vertexShader:Qt.shadow_vert,fragmentShader:Qt.shadow_frag}};nn.physical={uniforms:ai([nn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Xt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Xt},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Xt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Xt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Xt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Xt},sheen:{value:0},sheenColor:{value:new kt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Xt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Xt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Xt},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Xt},attenuationDistance:{value:0},attenuationColor:{value:new kt(0)},specularColor:{value:new kt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Xt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Xt},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Xt}}]),vertexShader:Qt.meshphysical_vert,fragmentShader:Qt.meshphysical_frag};var wc={r:0,b:0,g:0},Vb=new ge,ug=new Xt;ug.set(-1,0,0,0,1,0,0,0,1);function Hb(n,t,e,i,s,r){let a=new kt(0),o=s===!0?0:1,l,c,h=null,d=0,u=null;function f(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let b=_.backgroundBlurriness>0;w=t.get(w,b)}return w}function p(_){let w=!1,b=f(_);b===null?m(a,o):b&&b.isColor&&(m(b,1),w=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?e.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(_,w){let b=f(w);b&&b.isCubeTexture?(c===void 0&&(c=new Ne(new On(1,1,1),new Ki({name:"BackgroundCubeMaterial",uniforms:ps(nn.backgroundCube.uniforms),vertexShader:nn.backgroundCube.vertexShader,fragmentShader:nn.backgroundCube.fragmentShader,side:Be,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,A,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Vb.makeRotationFromEuler(w.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ug),c.material.toneMapped=oe.getTransfer(b.colorSpace)!==me,(h!==b||d!==b.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=b,d=b.version,u=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ne(new ya(2,2),new Ki({name:"BackgroundMaterial",uniforms:ps(nn.background.uniforms),vertexShader:nn.background.vertexShader,fragmentShader:nn.background.fragmentShader,side:zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=oe.getTransfer(b.colorSpace)!==me,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||d!==b.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=b,d=b.version,u=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,w){_.getRGB(wc,Lu(n)),e.buffers.color.setClear(wc.r,wc.g,wc.b,w,r)}function x(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(_,w=1){a.set(_),o=w,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(_){o=_,m(a,o)},render:p,addToRenderList:y,dispose:x}}function Wb(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,a=!1;function o(k,U,$,R,F){let W=!1,V=d(k,R,$,U);r!==V&&(r=V,c(r.object)),W=f(k,R,$,F),W&&p(k,R,$,F),F!==null&&t.update(F,n.ELEMENT_ARRAY_BUFFER),(W||a)&&(a=!1,b(k,U,$,R),F!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(F).buffer))}function l(){return n.createVertexArray()}function c(k){return n.bindVertexArray(k)}function h(k){return n.deleteVertexArray(k)}function d(k,U,$,R){let F=R.wireframe===!0,W=i[U.id];W===void 0&&(W={},i[U.id]=W);let V=k.isInstancedMesh===!0?k.id:0,nt=W[V];nt===void 0&&(nt={},W[V]=nt);let X=nt[$.id];X===void 0&&(X={},nt[$.id]=X);let Q=X[F];return Q===void 0&&(Q=u(l()),X[F]=Q),Q}function u(k){let U=[],$=[],R=[];for(let F=0;F<e;F++)U[F]=0,$[F]=0,R[F]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:$,attributeDivisors:R,object:k,attributes:{},index:null}}function f(k,U,$,R){let F=r.attributes,W=U.attributes,V=0,nt=$.getAttributes();for(let X in nt)if(nt[X].location>=0){let et=F[X],Et=W[X];if(Et===void 0&&(X==="instanceMatrix"&&k.instanceMatrix&&(Et=k.instanceMatrix),X==="instanceColor"&&k.instanceColor&&(Et=k.instanceColor)),et===void 0||et.attribute!==Et||Et&&et.data!==Et.data)return!0;V++}return r.attributesNum!==V||r.index!==R}function p(k,U,$,R){let F={},W=U.attributes,V=0,nt=$.getAttributes();for(let X in nt)if(nt[X].location>=0){let et=W[X];et===void 0&&(X==="instanceMatrix"&&k.instanceMatrix&&(et=k.instanceMatrix),X==="instanceColor"&&k.instanceColor&&(et=k.instanceColor));let Et={};Et.attribute=et,et&&et.data&&(Et.data=et.data),F[X]=Et,V++}r.attributes=F,r.attributesNum=V,r.index=R}function y(){let k=r.newAttributes;for(let U=0,$=k.length;U<$;U++)k[U]=0}function m(k){x(k,0)}function x(k,U){let $=r.newAttributes,R=r.enabledAttributes,F=r.attributeDivisors;$[k]=1,R[k]===0&&(n.enableVertexAttribArray(k),R[k]=1),F[k]!==U&&(n.vertexAttribDivisor(k,U),F[k]=U)}function _(){let k=r.newAttributes,U=r.enabledAttributes;for(let $=0,R=U.length;$<R;$++)U[$]!==k[$]&&(n.disableVertexAttribArray($),U[$]=0)}function w(k,U,$,R,F,W,V){V===!0?n.vertexAttribIPointer(k,U,$,F,W):n.vertexAttribPointer(k,U,$,R,F,W)}function b(k,U,$,R){y();let F=R.attributes,W=$.getAttributes(),V=U.defaultAttributeValues;for(let nt in W){let X=W[nt];if(X.location>=0){let Q=F[nt];if(Q===void 0&&(nt==="instanceMatrix"&&k.instanceMatrix&&(Q=k.instanceMatrix),nt==="instanceColor"&&k.instanceColor&&(Q=k.instanceColor)),Q!==void 0){let et=Q.normalized,Et=Q.itemSize,Gt=t.get(Q);if(Gt===void 0)continue;let j=Gt.buffer,vt=Gt.type,Tt=Gt.bytesPerElement,Ut=vt===n.INT||vt===n.UNSIGNED_INT||Q.gpuType===Ul;if(Q.isInterleavedBufferAttribute){let _t=Q.data,Ft=_t.isInterleavedBuffer===!0?_t.stride:_t.itemSize,Ae=Q.offset;if(_t.isInstancedInterleavedBuffer||_t.isInstancedBufferAttribute){for(let Vt=0;Vt<X.locationSize;Vt++)x(X.location+Vt,_t.meshPerAttribute);k.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=_t.meshPerAttribute*_t.count)}else for(let Vt=0;Vt<X.locationSize;Vt++)m(X.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,j);for(let Vt=0;Vt<X.locationSize;Vt++)w(X.location+Vt,Et/X.locationSize,vt,et,Ft*Tt,(Ae+Et/X.locationSize*Vt)*Tt,Ut)}else{if(Q.isInstancedBufferAttribute){for(let _t=0;_t<X.locationSize;_t++)x(X.location+_t,Q.meshPerAttribute);k.isInstancedMesh!==!0&&R._maxInstanceCount===void 0&&(R._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let _t=0;_t<X.locationSize;_t++)m(X.location+_t);n.bindBuffer(n.ARRAY_BUFFER,j);for(let _t=0;_t<X.locationSize;_t++)w(X.location+_t,Et/X.locationSize,vt,et,Et*Tt,Et/X.locationSize*_t*Tt,Ut)}}else if(V!==void 0){let et=V[nt];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(X.location,et);break;case 3:n.vertexAttrib3fv(X.location,et);break;case 4:n.vertexAttrib4fv(X.location,et);break;default:n.vertexAttrib1fv(X.location,et)}}}}_()}function T(){D();for(let k in i){let U=i[k];for(let $ in U){let R=U[$];for(let F in R){let W=R[F];for(let V in W)h(W[V].object),delete W[V];delete R[F]}}delete i[k]}}function A(k){if(i[k.id]===void 0)return;let U=i[k.id];for(let $ in U){let R=U[$];for(let F in R){let W=R[F];for(let V in W)h(W[V].object),delete W[V];delete R[F]}}delete i[k.id]}function v(k){for(let U in i){let $=i[U];for(let R in $){let F=$[R];if(F[k.id]===void 0)continue;let W=F[k.id];for(let V in W)h(W[V].object),delete W[V];delete F[k.id]}}}function E(k){for(let U in i){let $=i[U],R=k.isInstancedMesh===!0?k.id:0,F=$[R];if(F!==void 0){for(let W in F){let V=F[W];for(let nt in V)h(V[nt].object),delete V[nt];delete F[W]}delete $[R],Object.keys($).length===0&&delete i[U]}}}function D(){P(),a=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:D,resetDefaultState:P,dispose:T,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:m,disableUnusedAttributes:_}}function $b(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function a(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function o(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function Xb(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(v){return!(v!==Vi&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(v){let E=v===Gi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==pi&&v!==Ii&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(zt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&zt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&zt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),x=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:m,maxAttributes:x,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:b,maxSamples:T,samples:A}}function qb(n){let t=this,e=null,i=0,s=!1,r=!1,a=new bi,o=new Xt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||i!==0||s;return s=u,i=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let p=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,x=n.get(d);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let _=r?0:i,w=_*4,b=x.clippingState||null;l.value=b,b=h(p,u,w,f);for(let T=0;T!==w;++T)b[T]=e[T];x.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(d,u,f,p){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=l.value,p!==!0||m===null){let x=f+y*4,_=u.matrixWorldInverse;o.getNormalMatrix(_),(m===null||m.length<x)&&(m=new Float32Array(x));for(let w=0,b=f;w!==y;++w,b+=4)a.copy(d[w]).applyMatrix4(_,o),a.normal.toArray(m,b),m[b+3]=a.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var Oa=class extends wi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new sa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new On(5,5,5),r=new Ki({name:"CubemapFromEquirect",uniforms:ps(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Be,blending:hs});r.uniforms.tEquirect.value=e;let a=new Ne(s,r),o=e.minFilter;return e.minFilter===yn&&(e.minFilter=hi),new ir(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,i,s);t.setRenderTarget(r)}},Wm=256,jb=3,Yb=20,fg=256,pg=16,Zb=3,Kb=new I,Jb=new kt,Sc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ir(1,10,null),this._boxMesh=new Ne(new On(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:a=256,position:o=Kb}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(Jb));let m=new ir(i,s,h);return m.position.copy(o),m.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=p,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=qm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Xm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Wm,Cu(t))}_fromTexture(t,e){t.mapping===us||t.mapping===ar?this._setSize(t.image.length===0?Wm:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=$m(t,!1,!1),i=Math.log2(t)-jb;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=$m(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===us||t.mapping===ar?(this._cubemapMaterial===null&&(this._cubemapMaterial=qm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Xm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Qb(),this._integrationMaterial=tw());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/pg);for(let a=0;a<=i;a++){let o=n.lodToRoughness(a,i);if(a>i-Zb)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let l=o>0?Math.log2(e)+.5*Math.log2(6/(fg*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=ew());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function $m(n,t,e){return new Oa(n,{minFilter:yn,generateMipmaps:t,type:Gi,colorSpace:qr,depthBuffer:e})}function Ua(n,t,e){return new Ki({name:n,uniforms:t,vertexShader:Qt.cube_vert,fragmentShader:e,side:Be,blending:hs,depthTest:!1,depthWrite:!1})}function Qb(){return Ua("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${fg}u

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
	`)}function tw(){return Ua("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:pg}},`

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
	`)}function ew(){return Ua("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Yb}
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
	`)}function Xm(){return Ua("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function qm(){return Ua("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function iw(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,f=!1){return u==null?null:f?a(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===Dl||f===kl)if(t.has(u)){let p=t.get(u).texture;return o(p,u.mapping)}else{let p=u.image;if(p&&p.height>0){let y=new Oa(p.height);return y.fromEquirectangularTexture(n,u),t.set(u,y),u.addEventListener("dispose",c),o(y.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,p=f===Dl||f===kl,y=f===us||f===ar;if(p||y){let m=e.get(u),x=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==x)return i===null&&(i=new Sc(n)),m=p?i.fromEquirectangular(u,m):i.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let _=u.image;return p&&_&&_.height>0||y&&_&&l(_)?(i===null&&(i=new Sc(n)),m=p?i.fromEquirectangular(u):i.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function o(u,f){return f===Dl?u.mapping=us:f===kl&&(u.mapping=ar),u}function l(u){let f=0,p=6;for(let y=0;y<p;y++)u[y]!==void 0&&f++;return f===p}function c(u){let f=u.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function nw(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Vr("WebGLRenderer: "+i+" extension not supported."),s}}}function sw(n,t,e,i){let s={},r=new WeakMap,a=new FinalizationRegistry(p=>delete s[p]);function o(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",o),delete s[p.id],a.unregister(p);let y=r.get(p);y&&(t.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",o),s[y.id]=new WeakRef(y),a.register(y,y.id,y),e.memory.geometries++),y}function h(p){let y=p.attributes;for(let m in y)t.update(y[m],n.ARRAY_BUFFER)}function d(p){let y=p.index,m=p.attributes.position,x=0;if(m===void 0)return;let _=y!==null?y.array.length:m.array.length/3-1,w=m.count>=65535?ta:Qr,b=new w(Math.ceil(_/3)*6,1),T=b.array;if(y!==null){let v=y.array;x=y.version;for(let E=0,D=0;E<_;E+=3){let P=v[E+0],k=v[E+1],U=v[E+2];T[D++]=P,T[D++]=k,T[D++]=k,T[D++]=U,T[D++]=U,T[D++]=P}}else{x=m.version;for(let v=0,E=0;v<_;v+=3){let D=v+0,P=v+1,k=v+2;T[E++]=D,T[E++]=P,T[E++]=P,T[E++]=k,T[E++]=k,T[E++]=D}}b.version=x;let A=r.get(p);A&&t.remove(A),r.set(p,b)}function u(p){let y=r.get(p);if(y){let m=p.index;m!==null&&y.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function rw(n,t,e){let i;function s(d){i=d}let r,a;function o(d){r=d.type,a=d.bytesPerElement}function l(d,u){n.drawElements(i,u,r,d*a),e.update(u,i,1)}function c(d,u,f){f!==0&&(n.drawElementsInstanced(i,u,r,d*a,f),e.update(u,i,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,f);let y=0;for(let m=0;m<f;m++)y+=u[m];e.update(y,i,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function aw(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(e.calls++,a){case n.TRIANGLES:e.triangles+=o*(r/3);break;case n.LINES:e.lines+=o*(r/2);break;case n.LINE_STRIP:e.lines+=o*(r-1);break;case n.LINE_LOOP:e.lines+=o*r;break;case n.POINTS:e.points+=o*r;break;default:Ht("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function ow(n,t,e){let i=new WeakMap,s=new Re;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(o);if(u===void 0||u.count!==d){let D=function(){v.dispose(),i.delete(o),o.removeEventListener("dispose",D)};u!==void 0&&u.texture.dispose();let f=o.morphAttributes.position!==void 0,p=o.morphAttributes.normal!==void 0,y=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],x=o.morphAttributes.normal||[],_=o.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),y===!0&&(w=3);let b=o.attributes.position.count*w,T=1;b>t.maxTextureSize&&(T=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let A=new Float32Array(b*T*4*d),v=new Kr(A,b,T,d);v.type=Ii,v.needsUpdate=!0;let E=w*4;for(let P=0;P<d;P++){let k=m[P],U=x[P],$=_[P],R=b*T*4*P;for(let F=0;F<k.count;F++){let W=F*E;f===!0&&(s.fromBufferAttribute(k,F),A[R+W+0]=s.x,A[R+W+1]=s.y,A[R+W+2]=s.z,A[R+W+3]=0),p===!0&&(s.fromBufferAttribute(U,F),A[R+W+4]=s.x,A[R+W+5]=s.y,A[R+W+6]=s.z,A[R+W+7]=0),y===!0&&(s.fromBufferAttribute($,F),A[R+W+8]=s.x,A[R+W+9]=s.y,A[R+W+10]=s.z,A[R+W+11]=$.itemSize===4?s.w:1)}}u={count:d,texture:v,size:new it(b,T)},i.set(o,u),o.addEventListener("dispose",D)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let p=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function lw(n,t,e,i,s){let r=new WeakMap;function a(c){let h=s.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var cw={[ou]:"LINEAR_TONE_MAPPING",[lu]:"REINHARD_TONE_MAPPING",[cu]:"CINEON_TONE_MAPPING",[hu]:"ACES_FILMIC_TONE_MAPPING",[uu]:"AGX_TONE_MAPPING",[fu]:"NEUTRAL_TONE_MAPPING",[du]:"CUSTOM_TONE_MAPPING"};function hw(n,t,e,i,s,r){let a=new wi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new Se;h.setAttribute("position",new _e([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new _e([0,2,0,0,2,0],2));let d=new yl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Ne(h,d),f=new Ma(-1,1,1,-1,0,1),p=null,y=null,m=!1,x,_=null,w=[],b=!1;this.setSize=function(T,A){a.setSize(T,A),o!==null&&o.setSize(T,A),l!==null&&l.setSize(T,A);for(let v=0;v<w.length;v++){let E=w[v];E.setSize&&E.setSize(T,A)}},this.setEffects=function(T){w=T,b=w.length>0&&w[0].isRenderPass===!0;let A=a.width,v=a.height;w.length>0&&o===null&&(o=new wi(A,v,{type:Gi,depthBuffer:!1,stencilBuffer:!1}),l=new wi(A,v,{type:Gi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&w.some(D=>D.needsDepthTexture===!0);E!==(a.depthTexture!==null)&&(E===!0&&c===null&&(c=new gn(A,v),r===!0&&(c.format=vn,c.type=fs)),a.dispose(),a.depthTexture=E?c:null,a.resolveDepthBuffer=E,a.storeMultisampledDepthBuffer=E);for(let D=0;D<w.length;D++){let P=w[D];P.setSize&&P.setSize(A,v),E&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(T,A){if(m||T.toneMapping===tn&&w.length===0)return!1;if(_=A,A!==null){let v=A.width,E=A.height;(a.width!==v||a.height!==E)&&this.setSize(v,E)}return b===!1&&T.setRenderTarget(a),x=T.toneMapping,T.toneMapping=tn,!0},this.hasRenderPass=function(){return b},this.end=function(T,A){T.toneMapping=x,m=!0;let v=a,E=o;for(let D=0;D<w.length;D++){let P=w[D];P.enabled!==!1&&(P.render(T,E,v,A),P.needsSwap!==!1&&(v=E,E=E===o?l:o))}if(p!==T.outputColorSpace||y!==T.toneMapping){p=T.outputColorSpace,y=T.toneMapping,d.defines={},oe.getTransfer(p)===me&&(d.defines.SRGB_TRANSFER="");let D=cw[y];D&&(d.defines[D]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=v.texture,T.setRenderTarget(_),T.render(u,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var mg=new di,gg=new gn(1,1),xg=new aa(1),yg=new Kr,vg=new al,_g=new sa,jm=[],Ym=[],Zm=new Float32Array(16),Km=new Float32Array(9),Jm=new Float32Array(4);function cr(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=jm[s];if(r===void 0&&(r=new Float32Array(s),jm[s]=r),t!==0){i.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,n[a].toArray(r,o)}return r}function ze(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Ge(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Ec(n,t){let e=Ym[t];e===void 0&&(e=new Int32Array(t),Ym[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function dw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function uw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ze(e,t))return;n.uniform2fv(this.addr,t),Ge(e,t)}}function fw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(ze(e,t))return;n.uniform3fv(this.addr,t),Ge(e,t)}}function pw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ze(e,t))return;n.uniform4fv(this.addr,t),Ge(e,t)}}function mw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(ze(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Ge(e,t)}else{if(ze(e,i))return;Jm.set(i),n.uniformMatrix2fv(this.addr,!1,Jm),Ge(e,i)}}function gw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(ze(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Ge(e,t)}else{if(ze(e,i))return;Km.set(i),n.uniformMatrix3fv(this.addr,!1,Km),Ge(e,i)}}function xw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(ze(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Ge(e,t)}else{if(ze(e,i))return;Zm.set(i),n.uniformMatrix4fv(this.addr,!1,Zm),Ge(e,i)}}function yw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function vw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ze(e,t))return;n.uniform2iv(this.addr,t),Ge(e,t)}}function _w(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ze(e,t))return;n.uniform3iv(this.addr,t),Ge(e,t)}}function bw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ze(e,t))return;n.uniform4iv(this.addr,t),Ge(e,t)}}function ww(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Mw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ze(e,t))return;n.uniform2uiv(this.addr,t),Ge(e,t)}}function Sw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ze(e,t))return;n.uniform3uiv(this.addr,t),Ge(e,t)}}function Aw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ze(e,t))return;n.uniform4uiv(this.addr,t),Ge(e,t)}}function Tc(n){return n.version===0&&(n.compareFunction=Mu,n.needsUpdate=!0),n}function Ew(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Tc(gg):r=mg,e.setTexture2D(t||r,s)}function Tw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||vg,s)}function Cw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Tc(xg):r=_g,e.setTextureCube(t||r,s)}function Rw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||yg,s)}function Pw(n){switch(n){case 5126:return dw;case 35664:return uw;case 35665:return fw;case 35666:return pw;case 35674:return mw;case 35675:return gw;case 35676:return xw;case 5124:case 35670:return yw;case 35667:case 35671:return vw;case 35668:case 35672:return _w;case 35669:case 35673:return bw;case 5125:return ww;case 36294:return Mw;case 36295:return Sw;case 36296:return Aw;case 35678:case 36198:case 36298:case 36306:case 35682:return Ew;case 35679:case 36299:case 36307:return Tw;case 35680:case 36300:case 36308:case 36293:return Cw;case 36289:case 36303:case 36311:case 36292:return Rw}}function Iw(n,t){n.uniform1fv(this.addr,t)}function Nw(n,t){let e=cr(t,this.size,2);n.uniform2fv(this.addr,e)}function Lw(n,t){let e=cr(t,this.size,3);n.uniform3fv(this.addr,e)}function Dw(n,t){let e=cr(t,this.size,4);n.uniform4fv(this.addr,e)}function kw(n,t){let e=cr(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Ow(n,t){let e=cr(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Uw(n,t){let e=cr(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Fw(n,t){n.uniform1iv(this.addr,t)}function Bw(n,t){n.uniform2iv(this.addr,t)}function zw(n,t){n.uniform3iv(this.addr,t)}function Gw(n,t){n.uniform4iv(this.addr,t)}function Vw(n,t){n.uniform1uiv(this.addr,t)}function Hw(n,t){n.uniform2uiv(this.addr,t)}function Ww(n,t){n.uniform3uiv(this.addr,t)}function $w(n,t){n.uniform4uiv(this.addr,t)}function Xw(n,t,e){let i=this.cache,s=t.length,r=Ec(e,s);ze(i,r)||(n.uniform1iv(this.addr,r),Ge(i,r));let a;this.type===n.SAMPLER_2D_SHADOW?a=Tc(gg):a=mg;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function qw(n,t,e){let i=this.cache,s=t.length,r=Ec(e,s);ze(i,r)||(n.uniform1iv(this.addr,r),Ge(i,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||vg,r[a])}function jw(n,t,e){let i=this.cache,s=t.length,r=Ec(e,s);ze(i,r)||(n.uniform1iv(this.addr,r),Ge(i,r));let a;this.type===n.SAMPLER_CUBE_SHADOW?a=Tc(xg):a=_g;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function Yw(n,t,e){let i=this.cache,s=t.length,r=Ec(e,s);ze(i,r)||(n.uniform1iv(this.addr,r),Ge(i,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||yg,r[a])}function Zw(n){switch(n){case 5126:return Iw;case 35664:return Nw;case 35665:return Lw;case 35666:return Dw;case 35674:return kw;case 35675:return Ow;case 35676:return Uw;case 5124:case 35670:return Fw;case 35667:case 35671:return Bw;case 35668:case 35672:return zw;case 35669:case 35673:return Gw;case 5125:return Vw;case 36294:return Hw;case 36295:return Ww;case 36296:return $w;case 35678:case 36198:case 36298:case 36306:case 35682:return Xw;case 35679:case 36299:case 36307:return qw;case 35680:case 36300:case 36308:case 36293:return jw;case 36289:case 36303:case 36311:case 36292:return Yw}}var Bu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Pw(e.type)}},zu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Zw(e.type)}},Gu=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],i)}}},Uu=/(\w+)(\])?(\[|\.)?/g;function Qm(n,t){n.seq.push(t),n.map[t.id]=t}function Kw(n,t,e){let i=n.name,s=i.length;for(Uu.lastIndex=0;;){let r=Uu.exec(i),a=Uu.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Qm(e,c===void 0?new Bu(o,n,t):new zu(o,n,t));break}else{let d=e.map[o];d===void 0&&(d=new Gu(o),Qm(e,d)),e=d}}}var lr=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){let o=t.getActiveUniform(e,a),l=t.getUniformLocation(e,o.name);Kw(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&i.push(a)}return i}};function tg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var Jw=37297,Qw=0;function tM(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;i.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return i.join(`
`)}var eg=new Xt;function eM(n){oe._getMatrix(eg,oe.workingColorSpace,n);let t=`mat3( ${eg.elements.map(e=>e.toFixed(4))} )`;switch(oe.getTransfer(n)){case jr:return[t,"LinearTransferOETF"];case me:return[t,"sRGBTransferOETF"];default:return zt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function ig(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+tM(n.getShaderSource(t),o)}else return r}function iM(n,t){let e=eM(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var nM={[ou]:"Linear",[lu]:"Reinhard",[cu]:"Cineon",[hu]:"ACESFilmic",[uu]:"AgX",[fu]:"Neutral",[du]:"Custom"};function sM(n,t){let e=nM[t];return e===void 0?(zt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Mc=new I;function rM(){oe.getLuminanceCoefficients(Mc);let n=Mc.x.toFixed(4),t=Mc.y.toFixed(4),e=Mc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function aM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ka).join(`
`)}function oM(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function lM(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),a=r.name,o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:n.getAttribLocation(t,a),locationSize:o}}return e}function ka(n){return n!==""}function ng(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function sg(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var cM=/^[ \t]*#include +<([\w\d./]+)>/gm;function Vu(n){return n.replace(cM,hM)}function hM(n,t){let e=Qt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Vu(e)}var dM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function rg(n){return n.replace(dM,uM)}function uM(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function ag(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var fM={[Ea]:"SHADOWMAP_TYPE_PCF",[sr]:"SHADOWMAP_TYPE_VSM"};function pM(n){return fM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var mM={[ar]:"ENVMAP_MODE_REFRACTION"};function gM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":mM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var xM={[Ll]:"ENVMAP_BLENDING_MULTIPLY",[_m]:"ENVMAP_BLENDING_MIX",[bm]:"ENVMAP_BLENDING_ADD"};function yM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":xM[n.combine]||"ENVMAP_BLENDING_NONE"}function vM(n,t,e,i){let s=n.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,l=pM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=gM(e),d=yM(e),u=aM(e),f=oM(r),p=s.createProgram(),y,m,x=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ka).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ka).join(`
`),m.length>0&&(m+=`
`)):(y=[ag(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ka).join(`
`),m=[ag(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==tn?"#define TONE_MAPPING":"",e.toneMapping!==tn?Qt.tonemapping_pars_fragment:"",e.toneMapping!==tn?sM("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Qt.colorspace_pars_fragment,iM("linearToOutputTexel",e.outputColorSpace),rM(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ka).join(`
`)),a=Vu(a),a=ng(a,e),a=sg(a,e),o=Vu(o),o=ng(o,e),o=sg(o,e),a=rg(a),o=rg(o),e.isRawShaderMaterial!==!0&&(x=`#version 300 es
`,y=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===Eu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Eu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=x+y+a,w=x+m+o,b=tg(s,s.VERTEX_SHADER,_),T=tg(s,s.FRAGMENT_SHADER,w);s.attachShader(p,b),s.attachShader(p,T),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(P){if(n.debug.checkShaderErrors){let k=s.getProgramInfoLog(p)||"",U=s.getShaderInfoLog(b)||"",$=s.getShaderInfoLog(T)||"",R=k.trim(),F=U.trim(),W=$.trim(),V=!0,nt=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,T);else{let X=ig(s,b,"vertex"),Q=ig(s,T,"fragment");Ht("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+R+`
`+X+`
`+Q)}else R!==""?zt("WebGLProgram: Program Info Log:",R):(F===""||W==="")&&(nt=!1);nt&&(P.diagnostics={runnable:V,programLog:R,vertexShader:{log:F,prefix:y},fragmentShader:{log:W,prefix:m}})}s.deleteShader(b),s.deleteShader(T),v=new lr(s,p),E=lM(s,p)}let v;this.getUniforms=function(){return v===void 0&&A(this),v};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(p,Jw)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Qw++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=T,this}var _M=0,Hu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Wu(t),e.set(t,i)),i}},Wu=class{constructor(t){this.id=_M++,this.code=t,this.usedTimes=0}};function bM(n){return n===Gn||n===Na||n===La}function wM(n,t,e,i,s,r){let a=new Jr,o=new Hu,l=new Set,c=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,E,D,P,k,U){let $=P.fog,R=k.geometry,F=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,W=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,V=t.get(v.envMap||F,W),nt=u[v.type],X=i.precision;v.precision!==null&&(X=i.getMaxPrecision(v.precision),X!==v.precision&&zt("WebGLProgram.getParameters:",v.precision,"not supported, using",X,"instead."));let Q=R.morphAttributes.position||R.morphAttributes.normal||R.morphAttributes.color,et=Q!==void 0?Q.length:0,Et=0;R.morphAttributes.position!==void 0&&(Et=1),R.morphAttributes.normal!==void 0&&(Et=2),R.morphAttributes.color!==void 0&&(Et=3);let Gt,j,vt,Tt;if(nt){let bt=nn[nt];Gt=bt.vertexShader,j=bt.fragmentShader}else{Gt=v.vertexShader,j=v.fragmentShader;let bt=o.getVertexShaderStage(v),xe=o.getFragmentShaderStage(v);o.update(v,bt,xe),vt=bt.id,Tt=xe.id}let Ut=n.getRenderTarget(),_t=n.state.buffers.depth.getReversed(),Ft=k.isInstancedMesh===!0,Ae=k.isBatchedMesh===!0,Vt=!!v.map,te=!!v.matcap,ie=!!V,tt=ie&&V.isPMREMTexture===!0,dt=!!v.aoMap,ot=!!v.lightMap,At=!!v.bumpMap&&v.wireframe===!1,yt=!!v.normalMap,jt=!!v.displacementMap,Lt=!!v.emissiveMap,ne=!!v.metalnessMap,se=!!v.roughnessMap,ue=v.anisotropy>0,O=v.clearcoat>0,ke=v.diffuseRoughness>0,ee=v.dispersion>0,be=v.retroreflectivity>0,mt=v.iridescence>0,Le=v.sheen>0,Bt=v.transmission>0,$t=ue&&!!v.anisotropyMap,C=O&&!!v.clearcoatMap,M=O&&!!v.clearcoatNormalMap,z=O&&!!v.clearcoatRoughnessMap,st=ke&&!!v.diffuseRoughnessMap,J=mt&&!!v.iridescenceMap,lt=mt&&!!v.iridescenceThicknessMap,gt=Le&&!!v.sheenColorMap,Y=Le&&!!v.sheenRoughnessMap,Z=!!v.specularMap,ut=!!v.specularColorMap,N=!!v.specularIntensityMap,K=Bt&&!!v.transmissionMap,q=Bt&&!!v.thicknessMap,ft=!!v.gradientMap,at=!!v.alphaMap,ct=v.alphaTest>0,Dt=!!v.alphaHash,Zt=!!v.extensions,rt=tn;v.toneMapped&&(Ut===null||Ut.isXRRenderTarget===!0)&&(rt=n.toneMapping);let Ot=tt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Yt={shaderID:nt,shaderType:v.type,shaderName:v.name,vertexShader:Gt,fragmentShader:j,defines:v.defines,customVertexShaderID:vt,customFragmentShaderID:Tt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:X,batching:Ae,batchingColor:Ae&&k._colorsTexture!==null,instancing:Ft,instancingColor:Ft&&k.instanceColor!==null,instancingMorph:Ft&&k.morphTexture!==null,outputColorSpace:Ut===null?n.outputColorSpace:Ut.isXRRenderTarget===!0?Ut.texture.colorSpace:oe.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Vt,matcap:te,envMap:ie,envMapMode:ie&&V.mapping,envMapPMREM:tt,envMapMaxLod:tt?Ot.length-1:null,envMapSize:tt?Ot[0].width:null,aoMap:dt,lightMap:ot,bumpMap:At,normalMap:yt,displacementMap:jt,emissiveMap:Lt,normalMapObjectSpace:yt&&v.normalMapType===Sm,normalMapTangentSpace:yt&&v.normalMapType===_c,packedNormalMap:yt&&v.normalMapType===_c&&bM(v.normalMap.format),metalnessMap:ne,roughnessMap:se,anisotropy:ue,anisotropyMap:$t,clearcoat:O,clearcoatMap:C,clearcoatNormalMap:M,clearcoatRoughnessMap:z,diffuseRoughness:ke,diffuseRoughnessMap:st,dispersion:ee,retroreflection:be,iridescence:mt,iridescenceMap:J,iridescenceThicknessMap:lt,sheen:Le,sheenColorMap:gt,sheenRoughnessMap:Y,specularMap:Z,specularColorMap:ut,specularIntensityMap:N,transmission:Bt,transmissionMap:K,thicknessMap:q,gradientMap:ft,opaque:v.transparent===!1&&v.blending===rr&&v.alphaToCoverage===!1,alphaMap:at,alphaTest:ct,alphaHash:Dt,combine:v.combine,mapUv:Vt&&f(v.map.channel),aoMapUv:dt&&f(v.aoMap.channel),lightMapUv:ot&&f(v.lightMap.channel),bumpMapUv:At&&f(v.bumpMap.channel),normalMapUv:yt&&f(v.normalMap.channel),displacementMapUv:jt&&f(v.displacementMap.channel),emissiveMapUv:Lt&&f(v.emissiveMap.channel),metalnessMapUv:ne&&f(v.metalnessMap.channel),roughnessMapUv:se&&f(v.roughnessMap.channel),anisotropyMapUv:$t&&f(v.anisotropyMap.channel),clearcoatMapUv:C&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:st&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:J&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:lt&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:gt&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:Y&&f(v.sheenRoughnessMap.channel),specularMapUv:Z&&f(v.specularMap.channel),specularColorMapUv:ut&&f(v.specularColorMap.channel),specularIntensityMapUv:N&&f(v.specularIntensityMap.channel),transmissionMapUv:K&&f(v.transmissionMap.channel),thicknessMapUv:q&&f(v.thicknessMap.channel),alphaMapUv:at&&f(v.alphaMap.channel),vertexTangents:!!R.attributes.tangent&&(yt||ue),vertexNormals:!!R.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!R.attributes.color&&R.attributes.color.itemSize===4,pointsUvs:k.isPoints===!0&&!!R.attributes.uv&&(Vt||at),fog:!!$,useFog:v.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||R.attributes.normal===void 0&&yt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:_t,skinning:k.isSkinnedMesh===!0,hasPositionAttribute:R.attributes.position!==void 0,morphTargets:R.morphAttributes.position!==void 0,morphNormals:R.morphAttributes.normal!==void 0,morphColors:R.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:Et,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:U.filter(bt=>bt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:rt,decodeVideoTexture:Vt&&v.map.isVideoTexture===!0&&oe.getTransfer(v.map.colorSpace)===me,decodeVideoTextureEmissive:Lt&&v.emissiveMap.isVideoTexture===!0&&oe.getTransfer(v.emissiveMap.colorSpace)===me,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===ri,flipSided:v.side===Be,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Zt&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&v.extensions.multiDraw===!0||Ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Yt.vertexUv1s=l.has(1),Yt.vertexUv2s=l.has(2),Yt.vertexUv3s=l.has(3),l.clear(),Yt}function y(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let D in v.defines)E.push(D),E.push(v.defines[D]);return v.isRawShaderMaterial===!1&&(m(E,v),x(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function m(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function x(v,E){a.disableAll(),E.instancing&&a.enable(0),E.instancingColor&&a.enable(1),E.instancingMorph&&a.enable(2),E.matcap&&a.enable(3),E.envMap&&a.enable(4),E.normalMapObjectSpace&&a.enable(5),E.normalMapTangentSpace&&a.enable(6),E.clearcoat&&a.enable(7),E.iridescence&&a.enable(8),E.alphaTest&&a.enable(9),E.vertexColors&&a.enable(10),E.vertexAlphas&&a.enable(11),E.vertexUv1s&&a.enable(12),E.vertexUv2s&&a.enable(13),E.vertexUv3s&&a.enable(14),E.vertexTangents&&a.enable(15),E.anisotropy&&a.enable(16),E.alphaHash&&a.enable(17),E.batching&&a.enable(18),E.dispersion&&a.enable(19),E.retroreflection&&a.enable(24),E.diffuseRoughness&&a.enable(25),E.batchingColor&&a.enable(20),E.gradientMap&&a.enable(21),E.packedNormalMap&&a.enable(22),E.vertexNormals&&a.enable(23),v.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),E.numLightProbeGrids>0&&a.enable(22),E.hasPositionAttribute&&a.enable(23),v.push(a.mask)}function _(v){let E=u[v.type],D;if(E){let P=nn[E];D=Gm.clone(P.uniforms)}else D=v.uniforms;return D}function w(v,E){let D=h.get(E);return D!==void 0?++D.usedTimes:(D=new vM(n,E,v,s),c.push(D),h.set(E,D)),D}function b(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function T(v){o.remove(v)}function A(){o.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:_,acquireProgram:w,releaseProgram:b,releaseShaderCache:T,programs:c,dispose:A}}function MM(){let n=new WeakMap;function t(a){return n.has(a)}function e(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,l){n.get(a)[o]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function SM(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function og(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function lg(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function a(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function o(u,f,p,y,m,x){let _=n[t];return _===void 0?(_={id:u.id,object:u,geometry:f,material:p,materialVariant:a(u),groupOrder:y,renderOrder:u.renderOrder,z:m,group:x},n[t]=_):(_.id=u.id,_.object=u,_.geometry=f,_.material=p,_.materialVariant=a(u),_.groupOrder=y,_.renderOrder=u.renderOrder,_.z=m,_.group=x),t++,_}function l(u,f,p,y,m,x,_){_.reversedDepth===!0&&(m=-m);let w=o(u,f,p,y,m,x);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(u,f,p,y,m,x){let _=o(u,f,p,y,m,x);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function h(u,f){e.length>1&&e.sort(u||SM),i.length>1&&i.sort(f||og),s.length>1&&s.sort(f||og)}function d(){for(let u=t,f=n.length;u<f;u++){let p=n[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function AM(){let n=new WeakMap;function t(i,s){let r=n.get(i),a;return r===void 0?(a=new lg,n.set(i,[a])):s>=r.length?(a=new lg,r.push(a)):a=r[s],a}function e(){n=new WeakMap}return{get:t,dispose:e}}function EM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new I,color:new kt};break;case"SpotLight":e={position:new I,direction:new I,color:new kt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new I,color:new kt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new I,skyColor:new kt,groundColor:new kt};break;case"RectAreaLight":e={color:new kt,position:new I,halfWidth:new I,halfHeight:new I};break}return n[t.id]=e,e}}}function TM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var CM=0;function RM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function PM(n){let t=new EM,e=TM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new I);let s=new I,r=new ge,a=new ge;function o(c){let h=0,d=0,u=0;for(let U=0;U<9;U++)i.probe[U].set(0,0,0);let f=0,p=0,y=0,m=0,x=0,_=0,w=0,b=0,T=0,A=0,v=0,E=0,D=0,P=0;c.sort(RM);for(let U=0,$=c.length;U<$;U++){let R=c[U],F=R.color,W=R.intensity,V=R.distance,nt=null;if(R.shadow&&R.shadow.map&&(R.shadow.map.texture.format===Gn?nt=R.shadow.map.texture:nt=R.shadow.map.depthTexture||R.shadow.map.texture),R.isAmbientLight)h+=F.r*W,d+=F.g*W,u+=F.b*W;else if(R.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(R.sh.coefficients[X],W);P++}else if(R.isSunLight){let X=t.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=nt;let Et=Q.getViewportCount();for(let Gt=0;Gt<Et;Gt++)i.sunShadowMatrix[y+Gt]=Q.getMatrix(Gt),i.sunShadowCascade[y+Gt]=Q._cascadeData[Gt];y+=Et,p++}i.sun[f]=X,f++}else if(R.isDirectionalLight){let X=t.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=nt,i.directionalShadowMatrix[m]=R.shadow.matrix,T++}i.directional[m]=X,m++}else if(R.isSpotLight){let X=t.get(R);X.position.setFromMatrixPosition(R.matrixWorld),X.color.copy(F).multiplyScalar(W),X.distance=V,X.coneCos=Math.cos(R.angle),X.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),X.decay=R.decay,i.spot[_]=X;let Q=R.shadow;if(R.map&&(i.spotLightMap[E]=R.map,E++,Q.updateMatrices(R),R.castShadow&&D++),i.spotLightMatrix[_]=Q.matrix,R.castShadow){let et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.spotShadow[_]=et,i.spotShadowMap[_]=nt,v++}_++}else if(R.isRectAreaLight){let X=t.get(R);X.color.copy(F).multiplyScalar(W),X.halfWidth.set(R.width*.5,0,0),X.halfHeight.set(0,R.height*.5,0),i.rectArea[w]=X,w++}else if(R.isPointLight){let X=t.get(R);if(X.color.copy(R.color).multiplyScalar(R.intensity),X.distance=R.distance,X.decay=R.decay,R.castShadow){let Q=R.shadow,et=e.get(R);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,et.shadowCameraNear=Q.camera.near,et.shadowCameraFar=Q.camera.far,i.pointShadow[x]=et,i.pointShadowMap[x]=nt,i.pointShadowMatrix[x]=R.shadow.matrix,A++}i.point[x]=X,x++}else if(R.isHemisphereLight){let X=t.get(R);X.skyColor.copy(R.color).multiplyScalar(W),X.groundColor.copy(R.groundColor).multiplyScalar(W),i.hemi[b]=X,b++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=wt.LTC_FLOAT_1,i.rectAreaLTC2=wt.LTC_FLOAT_2):(i.rectAreaLTC1=wt.LTC_HALF_1,i.rectAreaLTC2=wt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let k=i.hash;(k.sunLength!==f||k.directionalLength!==m||k.pointLength!==x||k.spotLength!==_||k.rectAreaLength!==w||k.hemiLength!==b||k.numSunShadows!==p||k.numDirectionalShadows!==T||k.numPointShadows!==A||k.numSpotShadows!==v||k.numSpotMaps!==E||k.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=m,i.spot.length=_,i.rectArea.length=w,i.point.length=x,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-D,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=P,k.sunLength=f,k.directionalLength=m,k.pointLength=x,k.spotLength=_,k.rectAreaLength=w,k.hemiLength=b,k.numSunShadows=p,k.numDirectionalShadows=T,k.numPointShadows=A,k.numSpotShadows=v,k.numSpotMaps=E,k.numLightProbes=P,i.version=CM++)}function l(c,h){let d=0,u=0,f=0,p=0,y=0,m=0,x=h.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let b=c[_];if(b.isSunLight){let T=i.sun[d];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(x),d++}else if(b.isDirectionalLight){let T=i.directional[u];T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(x),u++}else if(b.isSpotLight){let T=i.spot[p];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(x),T.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(x),p++}else if(b.isRectAreaLight){let T=i.rectArea[y];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(x),a.identity(),r.copy(b.matrixWorld),r.premultiply(x),a.extractRotation(r),T.halfWidth.set(b.width*.5,0,0),T.halfHeight.set(0,b.height*.5,0),T.halfWidth.applyMatrix4(a),T.halfHeight.applyMatrix4(a),y++}else if(b.isPointLight){let T=i.point[f];T.position.setFromMatrixPosition(b.matrixWorld),T.position.applyMatrix4(x),f++}else if(b.isHemisphereLight){let T=i.hemi[m];T.direction.setFromMatrixPosition(b.matrixWorld),T.direction.transformDirection(x),m++}}}return{setup:o,setupView:l,state:i}}function cg(n){let t=new PM(n),e=[],i=[],s=[];function r(d){h.camera=d,e.length=0,i.length=0,s.length=0}function a(d){d.isLightProbeGrid?s.push(d):e.push(d)}function o(d){i.push(d)}function l(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function IM(n){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new cg(n),t.set(s,[o])):r>=a.length?(o=new cg(n),a.push(o)):o=a[r],o}function i(){t=new WeakMap}return{get:e,dispose:i}}var NM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,LM=`uniform sampler2D shadow_pass;
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
}`,DM=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],kM=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],hg=new ge,Da=new I,Fu=new I;function OM(n,t,e){let i=new kn,s=new it,r=new it,a=new Re,o=new vl,l=new _l,c={},h=e.maxTextureSize,d={[zn]:Be,[Be]:zn,[ri]:ri},u=new Ki({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:NM,fragmentShader:LM}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let p=new Se;p.setAttribute("position",new De(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Ne(p,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ea;let x=this.type;this.render=function(A,v,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===em&&(zt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ea);let D=n.getRenderTarget(),P=n.getActiveCubeFace(),k=n.getActiveMipmapLevel(),U=n.state;U.setBlending(hs),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let $=x!==this.type;$&&v.traverse(function(R){R.material&&(Array.isArray(R.material)?R.material.forEach(F=>F.needsUpdate=!0):R.material.needsUpdate=!0)});for(let R=0,F=A.length;R<F;R++){let W=A[R],V=W.shadow;if(V===void 0){zt("WebGLShadowMap:",W,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let nt=V.getFrameExtents();s.multiply(nt),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/nt.x),s.x=r.x*nt.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/nt.y),s.y=r.y*nt.y,V.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||$===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===sr){if(W.isPointLight){zt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new wi(s.x,s.y,{format:Gn,type:Gi,minFilter:hi,magFilter:hi,generateMipmaps:!1}),V.map.texture.name=W.name+".shadowMap",V.map.depthTexture=new gn(s.x,s.y,Ii),V.map.depthTexture.name=W.name+".shadowMapDepth",V.map.depthTexture.format=fn,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Ye,V.map.depthTexture.magFilter=Ye}else W.isPointLight?(V.map=new Oa(s.x),V.map.depthTexture=new aa(s.x,zi)):(V.map=new wi(s.x,s.y),V.map.depthTexture=new gn(s.x,s.y,zi)),V.map.depthTexture.name=W.name+".shadowMap",V.map.depthTexture.format=fn,this.type===Ea?(V.map.depthTexture.compareFunction=X?wu:bu,V.map.depthTexture.minFilter=hi,V.map.depthTexture.magFilter=hi):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Ye,V.map.depthTexture.magFilter=Ye);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();W.isPointLight!==!0&&V.updateMatrices(W,E);let et=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:E.layers;for(let Et=0;Et<Q;Et++){let Gt=V.getCamera(Et);if(W.isPointLight){let j=V.camera,vt=V.matrix,Tt=W.distance||j.far;Tt!==j.far&&(j.far=Tt,j.updateProjectionMatrix()),Da.setFromMatrixPosition(W.matrixWorld),j.position.copy(Da),Fu.copy(j.position),Fu.add(DM[Et]),j.up.copy(kM[Et]),j.lookAt(Fu),j.updateMatrixWorld(),vt.makeTranslation(-Da.x,-Da.y,-Da.z),hg.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),V._frustum.setFromProjectionMatrix(hg,j.coordinateSystem,j.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,Et),n.clear();else{Et===0&&(n.setRenderTarget(V.map),n.clear());let j=V.getViewport(Et);a.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),U.viewport(a)}i=V.getFrustum(Et),b(v,E,Gt,W,et,this.type)}V.isPointLightShadow!==!0&&this.type===sr&&_(V,E),V.needsUpdate=!1}x=this.type,m.needsUpdate=!1,n.setRenderTarget(D,P,k)};function _(A,v){let E=t.update(y);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new wi(s.x,s.y,{format:Gn,type:Gi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(v,null,E,u,y,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(v,null,E,f,y,null)}function w(A,v,E,D){let P=null,k=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(k!==void 0)P=k;else if(P=E.isPointLight===!0?l:o,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let U=P.uuid,$=v.uuid,R=c[U];R===void 0&&(R={},c[U]=R);let F=R[$];F===void 0&&(F=P.clone(),R[$]=F,v.addEventListener("dispose",T)),P=F}if(P.visible=v.visible,P.wireframe=v.wireframe,D===sr?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:d[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,E.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let U=n.properties.get(P);U.light=E}return P}function b(A,v,E,D,P,k){if(A.visible===!1)return;if(A.layers.test(P)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&k===sr)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let R=t.update(A),F=A.material;if(Array.isArray(F)){let W=R.groups;for(let V=0,nt=W.length;V<nt;V++){let X=W[V],Q=F[X.materialIndex];if(Q&&Q.visible){let et=w(A,Q,D,k);A.onBeforeShadow(n,A,v,E,R,et,X),n.renderBufferDirect(E,null,R,et,A,X),A.onAfterShadow(n,A,v,E,R,et,X)}}}else if(F.visible){let W=w(A,F,D,k);A.onBeforeShadow(n,A,v,E,R,W,null),n.renderBufferDirect(E,null,R,W,A,null),A.onAfterShadow(n,A,v,E,R,W,null)}}let $=A.children;for(let R=0,F=$.length;R<F;R++)b($[R],v,E,D,P,k)}function T(A){A.target.removeEventListener("dispose",T);for(let E in c){let D=c[E],P=A.target.uuid;P in D&&(D[P].dispose(),delete D[P])}}}function UM(n,t){function e(){let N=!1,K=new Re,q=null,ft=new Re(0,0,0,0);return{setMask:function(at){q!==at&&!N&&(n.colorMask(at,at,at,at),q=at)},setLocked:function(at){N=at},setClear:function(at,ct,Dt,Zt,rt){rt===!0&&(at*=Zt,ct*=Zt,Dt*=Zt),K.set(at,ct,Dt,Zt),ft.equals(K)===!1&&(n.clearColor(at,ct,Dt,Zt),ft.copy(K))},reset:function(){N=!1,q=null,ft.set(-1,0,0,0)}}}function i(){let N=!1,K=!1,q=null,ft=null,at=null;return{setReversed:function(ct){if(K!==ct){let Dt=t.get("EXT_clip_control");ct?Dt.clipControlEXT(Dt.LOWER_LEFT_EXT,Dt.ZERO_TO_ONE_EXT):Dt.clipControlEXT(Dt.LOWER_LEFT_EXT,Dt.NEGATIVE_ONE_TO_ONE_EXT),K=ct;let Zt=at;at=null,this.setClear(Zt)}},getReversed:function(){return K},setTest:function(ct){ct?_t(n.DEPTH_TEST):Ft(n.DEPTH_TEST)},setMask:function(ct){q!==ct&&!N&&(n.depthMask(ct),q=ct)},setFunc:function(ct){if(K&&(ct=Dm[ct]),ft!==ct){switch(ct){case jo:n.depthFunc(n.NEVER);break;case Yo:n.depthFunc(n.ALWAYS);break;case Zo:n.depthFunc(n.LESS);break;case Ws:n.depthFunc(n.LEQUAL);break;case Ko:n.depthFunc(n.EQUAL);break;case Jo:n.depthFunc(n.GEQUAL);break;case Qo:n.depthFunc(n.GREATER);break;case tl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}ft=ct}},setLocked:function(ct){N=ct},setClear:function(ct){at!==ct&&(at=ct,K&&(ct=1-ct),n.clearDepth(ct))},reset:function(){N=!1,q=null,ft=null,at=null,K=!1}}}function s(){let N=!1,K=null,q=null,ft=null,at=null,ct=null,Dt=null,Zt=null,rt=null;return{setTest:function(Ot){N||(Ot?_t(n.STENCIL_TEST):Ft(n.STENCIL_TEST))},setMask:function(Ot){K!==Ot&&!N&&(n.stencilMask(Ot),K=Ot)},setFunc:function(Ot,Yt,bt){(q!==Ot||ft!==Yt||at!==bt)&&(n.stencilFunc(Ot,Yt,bt),q=Ot,ft=Yt,at=bt)},setOp:function(Ot,Yt,bt){(ct!==Ot||Dt!==Yt||Zt!==bt)&&(n.stencilOp(Ot,Yt,bt),ct=Ot,Dt=Yt,Zt=bt)},setLocked:function(Ot){N=Ot},setClear:function(Ot){rt!==Ot&&(n.clearStencil(Ot),rt=Ot)},reset:function(){N=!1,K=null,q=null,ft=null,at=null,ct=null,Dt=null,Zt=null,rt=null}}}let r=new e,a=new i,o=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,p=[],y=null,m=!1,x=null,_=null,w=null,b=null,T=null,A=null,v=null,E=new kt(0,0,0),D=0,P=!1,k=null,U=null,$=null,R=null,F=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,nt=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=nt>=1):X.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=nt>=2);let Q=null,et={},Et=n.getParameter(n.SCISSOR_BOX),Gt=n.getParameter(n.VIEWPORT),j=new Re().fromArray(Et),vt=new Re().fromArray(Gt);function Tt(N,K,q,ft){let at=new Uint8Array(4),ct=n.createTexture();n.bindTexture(N,ct),n.texParameteri(N,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(N,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Dt=0;Dt<q;Dt++)N===n.TEXTURE_3D||N===n.TEXTURE_2D_ARRAY?n.texImage3D(K,0,n.RGBA,1,1,ft,0,n.RGBA,n.UNSIGNED_BYTE,at):n.texImage2D(K+Dt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,at);return ct}let Ut={};Ut[n.TEXTURE_2D]=Tt(n.TEXTURE_2D,n.TEXTURE_2D,1),Ut[n.TEXTURE_CUBE_MAP]=Tt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ut[n.TEXTURE_2D_ARRAY]=Tt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ut[n.TEXTURE_3D]=Tt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),_t(n.DEPTH_TEST),a.setFunc(Ws),At(!1),yt(eu),_t(n.CULL_FACE),dt(hs);function _t(N){h[N]!==!0&&(n.enable(N),h[N]=!0)}function Ft(N){h[N]!==!1&&(n.disable(N),h[N]=!1)}function Ae(N,K){return u[N]!==K?(n.bindFramebuffer(N,K),u[N]=K,N===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=K),N===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=K),!0):!1}function Vt(N,K){let q=p,ft=!1;if(N){q=f.get(K),q===void 0&&(q=[],f.set(K,q));let at=N.textures;if(q.length!==at.length||q[0]!==n.COLOR_ATTACHMENT0){for(let ct=0,Dt=at.length;ct<Dt;ct++)q[ct]=n.COLOR_ATTACHMENT0+ct;q.length=at.length,ft=!0}}else q[0]!==n.BACK&&(q[0]=n.BACK,ft=!0);ft&&n.drawBuffers(q)}function te(N){return y!==N?(n.useProgram(N),y=N,!0):!1}let ie={[ds]:n.FUNC_ADD,[nm]:n.FUNC_SUBTRACT,[sm]:n.FUNC_REVERSE_SUBTRACT};ie[rm]=n.MIN,ie[am]=n.MAX;let tt={[om]:n.ZERO,[lm]:n.ONE,[cm]:n.SRC_COLOR,[ru]:n.SRC_ALPHA,[mm]:n.SRC_ALPHA_SATURATE,[fm]:n.DST_COLOR,[dm]:n.DST_ALPHA,[hm]:n.ONE_MINUS_SRC_COLOR,[au]:n.ONE_MINUS_SRC_ALPHA,[pm]:n.ONE_MINUS_DST_COLOR,[um]:n.ONE_MINUS_DST_ALPHA,[gm]:n.CONSTANT_COLOR,[xm]:n.ONE_MINUS_CONSTANT_COLOR,[ym]:n.CONSTANT_ALPHA,[vm]:n.ONE_MINUS_CONSTANT_ALPHA};function dt(N,K,q,ft,at,ct,Dt,Zt,rt,Ot){if(N===hs){m===!0&&(Ft(n.BLEND),m=!1);return}if(m===!1&&(_t(n.BLEND),m=!0),N!==im){if(N!==x||Ot!==P){if((_!==ds||T!==ds)&&(n.blendEquation(n.FUNC_ADD),_=ds,T=ds),Ot)switch(N){case rr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case iu:n.blendFunc(n.ONE,n.ONE);break;case nu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case su:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Ht("WebGLState: Invalid blending: ",N);break}else switch(N){case rr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case iu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case nu:Ht("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case su:Ht("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ht("WebGLState: Invalid blending: ",N);break}w=null,b=null,A=null,v=null,E.set(0,0,0),D=0,x=N,P=Ot}return}at=at||K,ct=ct||q,Dt=Dt||ft,(K!==_||at!==T)&&(n.blendEquationSeparate(ie[K],ie[at]),_=K,T=at),(q!==w||ft!==b||ct!==A||Dt!==v)&&(n.blendFuncSeparate(tt[q],tt[ft],tt[ct],tt[Dt]),w=q,b=ft,A=ct,v=Dt),(Zt.equals(E)===!1||rt!==D)&&(n.blendColor(Zt.r,Zt.g,Zt.b,rt),E.copy(Zt),D=rt),x=N,P=!1}function ot(N,K){N.side===ri?Ft(n.CULL_FACE):_t(n.CULL_FACE);let q=N.side===Be;K&&(q=!q),At(q),N.blending===rr&&N.transparent===!1?dt(hs):dt(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),a.setFunc(N.depthFunc),a.setTest(N.depthTest),a.setMask(N.depthWrite),r.setMask(N.colorWrite);let ft=N.stencilWrite;o.setTest(ft),ft&&(o.setMask(N.stencilWriteMask),o.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),o.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),Lt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?_t(n.SAMPLE_ALPHA_TO_COVERAGE):Ft(n.SAMPLE_ALPHA_TO_COVERAGE)}function At(N){k!==N&&(N?n.frontFace(n.CW):n.frontFace(n.CCW),k=N)}function yt(N){N!==Qp?(_t(n.CULL_FACE),N!==U&&(N===eu?n.cullFace(n.BACK):N===tm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ft(n.CULL_FACE),U=N}function jt(N){N!==$&&(V&&n.lineWidth(N),$=N)}function Lt(N,K,q){N?(_t(n.POLYGON_OFFSET_FILL),(R!==K||F!==q)&&(R=K,F=q,a.getReversed()&&(K=-K,q=-q),n.polygonOffset(K,q))):Ft(n.POLYGON_OFFSET_FILL)}function ne(N){N?_t(n.SCISSOR_TEST):Ft(n.SCISSOR_TEST)}function se(N){N===void 0&&(N=n.TEXTURE0+W-1),Q!==N&&(n.activeTexture(N),Q=N)}function ue(N,K,q){q===void 0&&(Q===null?q=n.TEXTURE0+W-1:q=Q);let ft=et[q];ft===void 0&&(ft={type:void 0,texture:void 0},et[q]=ft),(ft.type!==N||ft.texture!==K)&&(Q!==q&&(n.activeTexture(q),Q=q),n.bindTexture(N,K||Ut[N]),ft.type=N,ft.texture=K)}function O(){let N=et[Q];N!==void 0&&N.type!==void 0&&(n.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function ke(){try{n.compressedTexImage2D(...arguments)}catch(N){Ht("WebGLState:",N)}}function ee(){try{n.compressedTexImage3D(...arguments)}catch(N){Ht("WebGLState:",N)}}function be(){try{n.texSubImage2D(...arguments)}catch(N){Ht("WebGLState:",N)}}function mt(){try{n.texSubImage3D(...arguments)}catch(N){Ht("WebGLState:",N)}}function Le(){try{n.compressedTexSubImage2D(...arguments)}catch(N){Ht("WebGLState:",N)}}function Bt(){try{n.compressedTexSubImage3D(...arguments)}catch(N){Ht("WebGLState:",N)}}function $t(){try{n.texStorage2D(...arguments)}catch(N){Ht("WebGLState:",N)}}function C(){try{n.texStorage3D(...arguments)}catch(N){Ht("WebGLState:",N)}}function M(){try{n.texImage2D(...arguments)}catch(N){Ht("WebGLState:",N)}}function z(){try{n.texImage3D(...arguments)}catch(N){Ht("WebGLState:",N)}}function st(N){return d[N]!==void 0?d[N]:n.getParameter(N)}function J(N,K){d[N]!==K&&(n.pixelStorei(N,K),d[N]=K)}function lt(N){j.equals(N)===!1&&(n.scissor(N.x,N.y,N.z,N.w),j.copy(N))}function gt(N){vt.equals(N)===!1&&(n.viewport(N.x,N.y,N.z,N.w),vt.copy(N))}function Y(N,K){let q=c.get(K);q===void 0&&(q=new WeakMap,c.set(K,q));let ft=q.get(N);ft===void 0&&(ft=n.getUniformBlockIndex(K,N.name),n.uniformBlockBinding(K,ft,ft),q.set(N,ft))}function Z(N,K,q){let at=c.get(K).get(N);l[at]!==q&&(n.bindBufferBase(n.UNIFORM_BUFFER,at,q),l[at]=q)}function ut(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,et={},u={},l={},f=new WeakMap,p=[],y=null,m=!1,x=null,_=null,w=null,b=null,T=null,A=null,v=null,E=new kt(0,0,0),D=0,P=!1,k=null,U=null,$=null,R=null,F=null,j.set(0,0,n.canvas.width,n.canvas.height),vt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:_t,disable:Ft,bindFramebuffer:Ae,drawBuffers:Vt,useProgram:te,setBlending:dt,setMaterial:ot,setFlipSided:At,setCullFace:yt,setLineWidth:jt,setPolygonOffset:Lt,setScissorTest:ne,activeTexture:se,bindTexture:ue,unbindTexture:O,compressedTexImage2D:ke,compressedTexImage3D:ee,texImage2D:M,texImage3D:z,pixelStorei:J,getParameter:st,updateUBOMapping:Y,uniformBlockBinding:Z,texStorage2D:$t,texStorage3D:C,texSubImage2D:be,texSubImage3D:mt,compressedTexSubImage2D:Le,compressedTexSubImage3D:Bt,scissor:lt,viewport:gt,reset:ut}}function FM(n,t,e,i,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,h=new WeakMap,d=new Set,u,f=new WeakMap,p=new Set,y=new FinalizationRegistry(C=>p.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function x(C,M){return m?new OffscreenCanvas(C,M):Yr("canvas")}function _(C,M,z){let st=1,J=$t(C);if((J.width>z||J.height>z)&&(st=z/Math.max(J.width,J.height)),st<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let lt=Math.floor(st*J.width),gt=Math.floor(st*J.height);u===void 0&&(u=x(lt,gt));let Y=M?x(lt,gt):u;return Y.width=lt,Y.height=gt,Y.getContext("2d").drawImage(C,0,0,lt,gt),zt("WebGLRenderer: Texture has been resized from ("+J.width+"x"+J.height+") to ("+lt+"x"+gt+")."),Y}else return"data"in C&&zt("WebGLRenderer: Image in DataTexture is too big ("+J.width+"x"+J.height+")."),C;return C}function w(C){return C.generateMipmaps}function b(C){n.generateMipmap(C)}function T(C){return C.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?n.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(C,M,z,st,J,lt=!1){if(C!==null){if(n[C]!==void 0)return n[C];zt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let gt;st&&(gt=t.get("EXT_texture_norm16"),gt||zt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=M;if(M===n.RED&&(z===n.FLOAT&&(Y=n.R32F),z===n.HALF_FLOAT&&(Y=n.R16F),z===n.UNSIGNED_BYTE&&(Y=n.R8),z===n.UNSIGNED_SHORT&&gt&&(Y=gt.R16_EXT),z===n.SHORT&&gt&&(Y=gt.R16_SNORM_EXT)),M===n.RED_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.R8UI),z===n.UNSIGNED_SHORT&&(Y=n.R16UI),z===n.UNSIGNED_INT&&(Y=n.R32UI),z===n.BYTE&&(Y=n.R8I),z===n.SHORT&&(Y=n.R16I),z===n.INT&&(Y=n.R32I)),M===n.RG&&(z===n.FLOAT&&(Y=n.RG32F),z===n.HALF_FLOAT&&(Y=n.RG16F),z===n.UNSIGNED_BYTE&&(Y=n.RG8),z===n.UNSIGNED_SHORT&&gt&&(Y=gt.RG16_EXT),z===n.SHORT&&gt&&(Y=gt.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.RG8UI),z===n.UNSIGNED_SHORT&&(Y=n.RG16UI),z===n.UNSIGNED_INT&&(Y=n.RG32UI),z===n.BYTE&&(Y=n.RG8I),z===n.SHORT&&(Y=n.RG16I),z===n.INT&&(Y=n.RG32I)),M===n.RGB_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.RGB8UI),z===n.UNSIGNED_SHORT&&(Y=n.RGB16UI),z===n.UNSIGNED_INT&&(Y=n.RGB32UI),z===n.BYTE&&(Y=n.RGB8I),z===n.SHORT&&(Y=n.RGB16I),z===n.INT&&(Y=n.RGB32I)),M===n.RGBA_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.RGBA8UI),z===n.UNSIGNED_SHORT&&(Y=n.RGBA16UI),z===n.UNSIGNED_INT&&(Y=n.RGBA32UI),z===n.BYTE&&(Y=n.RGBA8I),z===n.SHORT&&(Y=n.RGBA16I),z===n.INT&&(Y=n.RGBA32I)),M===n.RGB&&(z===n.UNSIGNED_SHORT&&gt&&(Y=gt.RGB16_EXT),z===n.SHORT&&gt&&(Y=gt.RGB16_SNORM_EXT),z===n.UNSIGNED_INT_5_9_9_9_REV&&(Y=n.RGB9_E5),z===n.UNSIGNED_INT_10F_11F_11F_REV&&(Y=n.R11F_G11F_B10F)),M===n.RGBA){let Z=lt?jr:oe.getTransfer(J);z===n.FLOAT&&(Y=n.RGBA32F),z===n.HALF_FLOAT&&(Y=n.RGBA16F),z===n.UNSIGNED_BYTE&&(Y=Z===me?n.SRGB8_ALPHA8:n.RGBA8),z===n.UNSIGNED_SHORT&&gt&&(Y=gt.RGBA16_EXT),z===n.SHORT&&gt&&(Y=gt.RGBA16_SNORM_EXT),z===n.UNSIGNED_SHORT_4_4_4_4&&(Y=n.RGBA4),z===n.UNSIGNED_SHORT_5_5_5_1&&(Y=n.RGB5_A1)}return(Y===n.R16F||Y===n.R32F||Y===n.RG16F||Y===n.RG32F||Y===n.RGBA16F||Y===n.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function v(C,M){let z;return C?M===null||M===zi||M===fs?z=n.DEPTH24_STENCIL8:M===Ii?z=n.DEPTH32F_STENCIL8:M===or&&(z=n.DEPTH24_STENCIL8,zt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===zi||M===fs?z=n.DEPTH_COMPONENT24:M===Ii?z=n.DEPTH_COMPONENT32F:M===or&&(z=n.DEPTH_COMPONENT16),z}function E(C,M){return w(C)===!0||C.isFramebufferTexture&&C.minFilter!==Ye&&C.minFilter!==hi?Math.log2(Math.max(M.width,M.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?M.mipmaps.length:1}function D(C){let M=new WeakRef(C);i.get(C).__ref=M,p.add(M),y.register(C,M,M)}function P(C){let M=i.get(C).__ref;M!==void 0&&(p.delete(M),y.unregister(M))}function k(C){$(C.target)}function U(C){R(C.target)}function $(C){C.removeEventListener("dispose",k),P(C),W(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&d.delete(C)}function R(C){C.removeEventListener("dispose",U),P(C),nt(C)}function F(){for(let C of p){let M=C.deref();M!==void 0&&(M.isRenderTarget===!0?R(M):$(M))}p.clear(),d.clear()}function W(C){let M=i.get(C);if(M.__webglInit===void 0)return;let z=C.source,st=f.get(z);if(st){let J=st[M.__cacheKey];J.usedTimes--,J.usedTimes===0&&V(C),Object.keys(st).length===0&&f.delete(z)}i.remove(C)}function V(C){let M=i.get(C);n.deleteTexture(M.__webglTexture);let z=C.source,st=f.get(z);delete st[M.__cacheKey],a.memory.textures--}function nt(C){let M=i.get(C);M.__depthDisposeCallback&&M.__depthDisposeCallback();let z=C.depthTexture;if(z&&z.renderTarget===C&&$(z),C.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(M.__webglFramebuffer[J]))for(let lt=0;lt<M.__webglFramebuffer[J].length;lt++)n.deleteFramebuffer(M.__webglFramebuffer[J][lt]);else n.deleteFramebuffer(M.__webglFramebuffer[J]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[J])}else{if(Array.isArray(M.__webglFramebuffer))for(let J=0;J<M.__webglFramebuffer.length;J++)n.deleteFramebuffer(M.__webglFramebuffer[J]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let J=0;J<M.__webglColorRenderbuffer.length;J++)M.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[J]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let st=C.textures;for(let J=0,lt=st.length;J<lt;J++){let gt=i.get(st[J]);gt.__webglTexture&&(n.deleteTexture(gt.__webglTexture),a.memory.textures--),i.remove(st[J])}i.remove(C)}let X=0;function Q(){X=0}function et(){return X}function Et(C){X=C}function Gt(){let C=X;return C>=s.maxTextures&&zt("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,C}function j(C){let M=[];return M.push(C.wrapS),M.push(C.wrapT),M.push(C.wrapR||0),M.push(C.magFilter),M.push(C.minFilter),M.push(C.anisotropy),M.push(C.internalFormat),M.push(C.format),M.push(C.type),M.push(C.generateMipmaps),M.push(C.mipmapsAutoUpdate),M.push(C.premultiplyAlpha),M.push(C.flipY),M.push(C.unpackAlignment),M.push(C.colorSpace),M.join()}function vt(C,M){let z=i.get(C);if(C.isVideoTexture&&Le(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&z.__version!==C.version){let st=C.image;if(st===null)zt("WebGLRenderer: Texture marked for update but no image data found.");else if(st.complete===!1)zt("WebGLRenderer: Texture marked for update but image is incomplete");else{ot(z,C,M);return}}else C.isExternalTexture&&(z.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,z.__webglTexture,n.TEXTURE0+M)}function Tt(C,M){let z=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&z.__version!==C.version){ot(z,C,M);return}else C.isExternalTexture&&(z.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,z.__webglTexture,n.TEXTURE0+M)}function Ut(C,M){let z=i.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&z.__version!==C.version){ot(z,C,M);return}e.bindTexture(n.TEXTURE_3D,z.__webglTexture,n.TEXTURE0+M)}function _t(C,M){let z=i.get(C);if(C.version>0&&z.__version!==C.version){At(z,C,M);return}e.bindTexture(n.TEXTURE_CUBE_MAP,z.__webglTexture,n.TEXTURE0+M)}let Ft={[el]:n.REPEAT,[Xi]:n.CLAMP_TO_EDGE,[il]:n.MIRRORED_REPEAT},Ae={[Ye]:n.NEAREST,[wm]:n.NEAREST_MIPMAP_NEAREST,[Ta]:n.NEAREST_MIPMAP_LINEAR,[hi]:n.LINEAR,[Ol]:n.LINEAR_MIPMAP_NEAREST,[yn]:n.LINEAR_MIPMAP_LINEAR},Vt={[Em]:n.NEVER,[Mu]:n.ALWAYS,[Tm]:n.LESS,[bu]:n.LEQUAL,[Cm]:n.EQUAL,[wu]:n.GEQUAL,[Rm]:n.GREATER,[Pm]:n.NOTEQUAL};function te(C,M){if(M.type===Ii&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===hi||M.magFilter===Ol||M.magFilter===Ta||M.magFilter===yn||M.minFilter===hi||M.minFilter===Ol||M.minFilter===Ta||M.minFilter===yn)&&zt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(C,n.TEXTURE_WRAP_S,Ft[M.wrapS]),n.texParameteri(C,n.TEXTURE_WRAP_T,Ft[M.wrapT]),(C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY)&&n.texParameteri(C,n.TEXTURE_WRAP_R,Ft[M.wrapR]),n.texParameteri(C,n.TEXTURE_MAG_FILTER,Ae[M.magFilter]),n.texParameteri(C,n.TEXTURE_MIN_FILTER,Ae[M.minFilter]),M.compareFunction&&(n.texParameteri(C,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(C,n.TEXTURE_COMPARE_FUNC,Vt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Ye||M.minFilter!==Ta&&M.minFilter!==yn||M.type===Ii&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(C,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ie(C,M){let z=!1;C.__webglInit===void 0&&(C.__webglInit=!0,M.addEventListener("dispose",k),D(M));let st=M.source,J=f.get(st);J===void 0&&(J={},f.set(st,J));let lt=j(M);if(lt!==C.__cacheKey){J[lt]===void 0&&(J[lt]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,z=!0),J[lt].usedTimes++;let gt=J[C.__cacheKey];gt!==void 0&&(J[C.__cacheKey].usedTimes--,gt.usedTimes===0&&V(M)),C.__cacheKey=lt,C.__webglTexture=J[lt].texture}return z}function tt(C,M,z){return Math.floor(Math.floor(C/z)/M)}function dt(C,M,z,st){let lt=C.updateRanges;if(lt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,z,st,M.data);else{lt.sort((N,K)=>N.start-K.start);let gt=0;for(let N=1;N<lt.length;N++){let K=lt[gt],q=lt[N],ft=K.start+K.count,at=tt(q.start,M.width,4),ct=tt(K.start,M.width,4);q.start<=ft+1&&at===ct&&tt(q.start+q.count-1,M.width,4)===at?K.count=Math.max(K.count,q.start+q.count-K.start):(++gt,lt[gt]=q)}lt.length=gt+1;let Y=e.getParameter(n.UNPACK_ROW_LENGTH),Z=e.getParameter(n.UNPACK_SKIP_PIXELS),ut=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let N=0,K=lt.length;N<K;N++){let q=lt[N],ft=Math.floor(q.start/4),at=Math.ceil(q.count/4),ct=ft%M.width,Dt=Math.floor(ft/M.width),Zt=at,rt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,ct),e.pixelStorei(n.UNPACK_SKIP_ROWS,Dt),e.texSubImage2D(n.TEXTURE_2D,0,ct,Dt,Zt,rt,z,st,M.data)}C.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,Y),e.pixelStorei(n.UNPACK_SKIP_PIXELS,Z),e.pixelStorei(n.UNPACK_SKIP_ROWS,ut)}}function ot(C,M,z){let st=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(st=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(st=n.TEXTURE_3D);let J=ie(C,M),lt=M.source;e.bindTexture(st,C.__webglTexture,n.TEXTURE0+z);let gt=i.get(lt);if(lt.version!==gt.__version||J===!0){if(e.activeTexture(n.TEXTURE0+z),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let rt=oe.getPrimaries(oe.workingColorSpace),Ot=M.colorSpace===_n?null:oe.getPrimaries(M.colorSpace),Yt=M.colorSpace===_n||rt===Ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Yt)}e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let Z=_(M.image,!1,s.maxTextureSize);Z=Bt(M,Z);let ut=r.convert(M.format,M.colorSpace),N=r.convert(M.type),K=A(M.internalFormat,ut,N,M.normalized,M.colorSpace,M.isVideoTexture);te(st,M);let q,ft=M.mipmaps,at=M.isVideoTexture!==!0,ct=gt.__version===void 0||J===!0,Dt=lt.dataReady,Zt=E(M,Z);if(M.isDepthTexture)K=v(M.format===vn,M.type),ct&&(at?e.texStorage2D(n.TEXTURE_2D,1,K,Z.width,Z.height):e.texImage2D(n.TEXTURE_2D,0,K,Z.width,Z.height,0,ut,N,null));else if(M.isDataTexture)if(ft.length>0){at&&ct&&e.texStorage2D(n.TEXTURE_2D,Zt,K,ft[0].width,ft[0].height);for(let rt=0,Ot=ft.length;rt<Ot;rt++)q=ft[rt],at?Dt&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,q.width,q.height,ut,N,q.data):e.texImage2D(n.TEXTURE_2D,rt,K,q.width,q.height,0,ut,N,q.data);M.generateMipmaps=!1}else at?(ct&&e.texStorage2D(n.TEXTURE_2D,Zt,K,Z.width,Z.height),Dt&&dt(M,Z,ut,N)):e.texImage2D(n.TEXTURE_2D,0,K,Z.width,Z.height,0,ut,N,Z.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){at&&ct&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,K,ft[0].width,ft[0].height,Z.depth);for(let rt=0,Ot=ft.length;rt<Ot;rt++)if(q=ft[rt],M.format!==Vi)if(ut!==null)if(at){if(Dt)if(M.layerUpdates.size>0){let Yt=Ou(q.width,q.height,M.format,M.type);for(let bt of M.layerUpdates){let xe=q.data.subarray(bt*Yt/q.data.BYTES_PER_ELEMENT,(bt+1)*Yt/q.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,bt,q.width,q.height,1,ut,xe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,0,q.width,q.height,Z.depth,ut,q.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,rt,K,q.width,q.height,Z.depth,0,q.data,0,0);else zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else at?Dt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,0,q.width,q.height,Z.depth,ut,N,q.data):e.texImage3D(n.TEXTURE_2D_ARRAY,rt,K,q.width,q.height,Z.depth,0,ut,N,q.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{at&&ct&&e.texStorage2D(n.TEXTURE_2D,Zt,K,ft[0].width,ft[0].height);for(let rt=0,Ot=ft.length;rt<Ot;rt++)q=ft[rt],M.format!==Vi?ut!==null?at?Dt&&e.compressedTexSubImage2D(n.TEXTURE_2D,rt,0,0,q.width,q.height,ut,q.data):e.compressedTexImage2D(n.TEXTURE_2D,rt,K,q.width,q.height,0,q.data):zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):at?Dt&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,q.width,q.height,ut,N,q.data):e.texImage2D(n.TEXTURE_2D,rt,K,q.width,q.height,0,ut,N,q.data)}else if(M.isDataArrayTexture)if(at){if(ct&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,K,Z.width,Z.height,Z.depth),Dt)if(M.layerUpdates.size>0){let rt=Ou(Z.width,Z.height,M.format,M.type);for(let Ot of M.layerUpdates){let Yt=Z.data.subarray(Ot*rt/Z.data.BYTES_PER_ELEMENT,(Ot+1)*rt/Z.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ot,Z.width,Z.height,1,ut,N,Yt)}M.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,ut,N,Z.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,K,Z.width,Z.height,Z.depth,0,ut,N,Z.data);else if(M.isData3DTexture)at?(ct&&e.texStorage3D(n.TEXTURE_3D,Zt,K,Z.width,Z.height,Z.depth),Dt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,ut,N,Z.data)):e.texImage3D(n.TEXTURE_3D,0,K,Z.width,Z.height,Z.depth,0,ut,N,Z.data);else if(M.isFramebufferTexture){if(ct)if(at)e.texStorage2D(n.TEXTURE_2D,Zt,K,Z.width,Z.height);else{let rt=Z.width,Ot=Z.height;for(let Yt=0;Yt<Zt;Yt++)e.texImage2D(n.TEXTURE_2D,Yt,K,rt,Ot,0,ut,N,null),rt>>=1,Ot>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let rt=n.canvas;if(rt.hasAttribute("layoutsubtree")||rt.setAttribute("layoutsubtree","true"),Z.parentNode!==rt){rt.appendChild(Z),d.add(M),rt.onpaint=Ot=>{let Yt=Ot.changedElements;for(let bt of d)Yt.includes(bt.image)&&(bt.needsUpdate=!0)},rt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Z);else{let Yt=n.RGBA,bt=n.RGBA,xe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Yt,bt,xe,Z)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(ft.length>0){if(at&&ct){let rt=$t(ft[0]);e.texStorage2D(n.TEXTURE_2D,Zt,K,rt.width,rt.height)}for(let rt=0,Ot=ft.length;rt<Ot;rt++)q=ft[rt],at?Dt&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,ut,N,q):e.texImage2D(n.TEXTURE_2D,rt,K,ut,N,q);M.generateMipmaps=!1}else if(at){if(ct){let rt=$t(Z);e.texStorage2D(n.TEXTURE_2D,Zt,K,rt.width,rt.height)}Dt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ut,N,Z)}else e.texImage2D(n.TEXTURE_2D,0,K,ut,N,Z);w(M)&&M.mipmapsAutoUpdate===!0&&b(st),gt.__version=lt.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function At(C,M,z){if(M.image.length!==6)return;let st=ie(C,M),J=M.source;e.bindTexture(n.TEXTURE_CUBE_MAP,C.__webglTexture,n.TEXTURE0+z);let lt=i.get(J);if(J.version!==lt.__version||st===!0){e.activeTexture(n.TEXTURE0+z);let gt=oe.getPrimaries(oe.workingColorSpace),Y=M.colorSpace===_n?null:oe.getPrimaries(M.colorSpace),Z=M.colorSpace===_n||gt===Y?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let ut=M.isCompressedTexture||M.image[0].isCompressedTexture,N=M.image[0]&&M.image[0].isDataTexture,K=[];for(let bt=0;bt<6;bt++)!ut&&!N?K[bt]=_(M.image[bt],!0,s.maxCubemapSize):K[bt]=N?M.image[bt].image:M.image[bt],K[bt]=Bt(M,K[bt]);let q=K[0],ft=r.convert(M.format,M.colorSpace),at=r.convert(M.type),ct=A(M.internalFormat,ft,at,M.normalized,M.colorSpace),Dt=M.isVideoTexture!==!0,Zt=lt.__version===void 0||st===!0,rt=J.dataReady,Ot=E(M,q);te(n.TEXTURE_CUBE_MAP,M);let Yt;if(M.isDepthTexture){if(ct=v(M.format===vn,M.type),Zt)if(Dt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,ct,q.width,q.height);else for(let bt=0;bt<6;bt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,ct,q.width,q.height,0,ft,at,null)}else if(ut){Dt&&Zt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,ct,q.width,q.height);for(let bt=0;bt<6;bt++){Yt=K[bt].mipmaps;for(let xe=0;xe<Yt.length;xe++){let $e=Yt[xe];M.format!==Vi?ft!==null?Dt?rt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe,0,0,$e.width,$e.height,ft,$e.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe,ct,$e.width,$e.height,0,$e.data):zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Dt?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe,0,0,$e.width,$e.height,ft,at,$e.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe,ct,$e.width,$e.height,0,ft,at,$e.data)}}}else{if(Yt=M.mipmaps,Dt&&Zt){Yt.length>0&&Ot++;let bt=$t(K[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,ct,bt.width,bt.height)}for(let bt=0;bt<6;bt++)if(N){Dt?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,0,0,K[bt].width,K[bt].height,ft,at,K[bt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,ct,K[bt].width,K[bt].height,0,ft,at,K[bt].data);for(let xe=0;xe<Yt.length;xe++){let An=Yt[xe].image[bt].image;Dt?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe+1,0,0,An.width,An.height,ft,at,An.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe+1,ct,An.width,An.height,0,ft,at,An.data)}}else{Dt?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,0,0,ft,at,K[bt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,0,ct,ft,at,K[bt]);for(let xe=0;xe<Yt.length;xe++){let $e=Yt[xe];Dt?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe+1,0,0,ft,at,$e.image[bt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+bt,xe+1,ct,ft,at,$e.image[bt])}}}w(M)&&M.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),lt.__version=J.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function yt(C,M,z,st,J,lt){let gt=r.convert(z.format,z.colorSpace),Y=r.convert(z.type),Z=A(z.internalFormat,gt,Y,z.normalized,z.colorSpace),ut=i.get(M),N=i.get(z);if(N.__renderTarget=M,!ut.__hasExternalTextures){let K=Math.max(1,M.width>>lt),q=Math.max(1,M.height>>lt);J===n.TEXTURE_3D||J===n.TEXTURE_2D_ARRAY?e.texImage3D(J,lt,Z,K,q,M.depth,0,gt,Y,null):e.texImage2D(J,lt,Z,K,q,0,gt,Y,null)}e.bindFramebuffer(n.FRAMEBUFFER,C),mt(M)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,st,J,N.__webglTexture,0,be(M)):(J===n.TEXTURE_2D||J>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&J<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,st,J,N.__webglTexture,lt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function jt(C,M,z){if(n.bindRenderbuffer(n.RENDERBUFFER,C),M.depthBuffer){let st=M.depthTexture,J=st&&st.isDepthTexture?st.type:null,lt=v(M.stencilBuffer,J),gt=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;mt(M)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,be(M),lt,M.width,M.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,be(M),lt,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,lt,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,gt,n.RENDERBUFFER,C)}else{let st=M.textures;for(let J=0;J<st.length;J++){let lt=st[J],gt=r.convert(lt.format,lt.colorSpace),Y=r.convert(lt.type),Z=A(lt.internalFormat,gt,Y,lt.normalized,lt.colorSpace);mt(M)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,be(M),Z,M.width,M.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,be(M),Z,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,Z,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Lt(C,M,z){let st=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,C),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let J=i.get(M.depthTexture);J.__renderTarget=M;let lt=st?M.depthTexture.image[0]:M.depthTexture.image;(!J.__webglTexture||lt.width!==M.width||lt.height!==M.height)&&(lt.width=M.width,lt.height=M.height,M.depthTexture.needsUpdate=!0),st?_t(M.depthTexture,0):vt(M.depthTexture,0);let gt=J.__webglTexture,Y=be(M),Z=st?n.TEXTURE_CUBE_MAP_POSITIVE_X+z:n.TEXTURE_2D,ut=M.depthTexture.format===vn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===fn)mt(M)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,Z,gt,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,ut,Z,gt,0);else if(M.depthTexture.format===vn)mt(M)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,Z,gt,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,ut,Z,gt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function ne(C){let M=i.get(C),z=C.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==C.depthTexture){let st=C.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),st){let J=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,st.removeEventListener("dispose",J)};st.addEventListener("dispose",J),M.__depthDisposeCallback=J}M.__boundDepthTexture=st}if(C.depthTexture&&!M.__autoAllocateDepthBuffer)if(z)for(let st=0;st<6;st++)Lt(M.__webglFramebuffer[st],C,st);else C.texture.mipmaps.length>0?Lt(M.__webglFramebuffer[0],C,0):Lt(M.__webglFramebuffer,C,0);else if(z){M.__webglDepthbuffer=[];for(let st=0;st<6;st++)if(e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[st]),M.__webglDepthbuffer[st]===void 0)M.__webglDepthbuffer[st]=n.createRenderbuffer(),jt(M.__webglDepthbuffer[st],C,!1);else{let J=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,lt=M.__webglDepthbuffer[st];n.bindRenderbuffer(n.RENDERBUFFER,lt),n.framebufferRenderbuffer(n.FRAMEBUFFER,J,n.RENDERBUFFER,lt)}}else if(C.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),jt(M.__webglDepthbuffer,C,!1);else{let J=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,lt=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,lt),n.framebufferRenderbuffer(n.FRAMEBUFFER,J,n.RENDERBUFFER,lt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function se(C,M,z){let st=i.get(C);M!==void 0&&yt(st.__webglFramebuffer,C,C.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),z!==void 0&&ne(C)}function ue(C){let M=C.texture,z=i.get(C),st=i.get(M);C.addEventListener("dispose",U),D(C);let J=C.textures,lt=C.isWebGLCubeRenderTarget===!0,gt=J.length>1;if(gt||(st.__webglTexture===void 0&&(st.__webglTexture=n.createTexture()),st.__version=M.version,a.memory.textures++),lt){z.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(M.mipmaps.length>0){z.__webglFramebuffer[Y]=[];for(let Z=0;Z<M.mipmaps.length;Z++)z.__webglFramebuffer[Y][Z]=n.createFramebuffer()}else z.__webglFramebuffer[Y]=n.createFramebuffer()}else{if(M.mipmaps.length>0){z.__webglFramebuffer=[];for(let Y=0;Y<M.mipmaps.length;Y++)z.__webglFramebuffer[Y]=n.createFramebuffer()}else z.__webglFramebuffer=n.createFramebuffer();if(gt)for(let Y=0,Z=J.length;Y<Z;Y++){let ut=i.get(J[Y]);ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture(),a.memory.textures++)}if(C.samples>0&&mt(C)===!1){z.__webglMultisampledFramebuffer=n.createFramebuffer(),z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Y=0;Y<J.length;Y++){let Z=J[Y];z.__webglColorRenderbuffer[Y]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,z.__webglColorRenderbuffer[Y]);let ut=r.convert(Z.format,Z.colorSpace),N=r.convert(Z.type),K=A(Z.internalFormat,ut,N,Z.normalized,Z.colorSpace,C.isXRRenderTarget===!0),q=be(C);n.renderbufferStorageMultisample(n.RENDERBUFFER,q,K,C.width,C.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Y,n.RENDERBUFFER,z.__webglColorRenderbuffer[Y])}n.bindRenderbuffer(n.RENDERBUFFER,null),C.depthBuffer&&(z.__webglDepthRenderbuffer=n.createRenderbuffer(),jt(z.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(lt){e.bindTexture(n.TEXTURE_CUBE_MAP,st.__webglTexture),te(n.TEXTURE_CUBE_MAP,M);for(let Y=0;Y<6;Y++)if(M.mipmaps.length>0)for(let Z=0;Z<M.mipmaps.length;Z++)yt(z.__webglFramebuffer[Y][Z],C,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,Z);else yt(z.__webglFramebuffer[Y],C,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);w(M)?b(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(gt){for(let Y=0,Z=J.length;Y<Z;Y++){let ut=J[Y],N=i.get(ut),K=n.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(K=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(K,N.__webglTexture),te(K,ut),yt(z.__webglFramebuffer,C,ut,n.COLOR_ATTACHMENT0+Y,K,0),w(ut)&&b(K)}e.unbindTexture()}else{let Y=n.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Y=C.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(Y,st.__webglTexture),te(Y,M),M.mipmaps.length>0)for(let Z=0;Z<M.mipmaps.length;Z++)yt(z.__webglFramebuffer[Z],C,M,n.COLOR_ATTACHMENT0,Y,Z);else yt(z.__webglFramebuffer,C,M,n.COLOR_ATTACHMENT0,Y,0);w(M)?b(Y):M.mipmaps.length>0&&n.texParameteri(Y,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}C.depthBuffer&&ne(C)}function O(C){let M=C.textures;for(let z=0,st=M.length;z<st;z++){let J=M[z];if(w(J)&&J.mipmapsAutoUpdate===!0){let lt=T(C),gt=i.get(J).__webglTexture;e.bindTexture(lt,gt),b(lt),e.unbindTexture()}}}let ke=[];function ee(C){if(C.samples>0){if(mt(C)===!1){let M=C.textures,z=C.width,st=C.height,J=n.COLOR_BUFFER_BIT,lt=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,gt=i.get(C),Y=M.length>1;if(Y)for(let ut=0;ut<M.length;ut++)e.bindFramebuffer(n.FRAMEBUFFER,gt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,gt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,gt.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,gt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,gt.__webglFramebuffer);for(let ut=0;ut<M.length;ut++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(J|=n.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(J|=n.STENCIL_BUFFER_BIT)),Y){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,gt.__webglColorRenderbuffer[ut]);let N=i.get(M[ut]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,N,0)}n.blitFramebuffer(0,0,z,st,0,0,z,st,J,n.NEAREST),l===!0&&(ke.length=0,ke.push(n.COLOR_ATTACHMENT0+ut),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&ke.push(lt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,ke))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Y)for(let ut=0;ut<M.length;ut++){e.bindFramebuffer(n.FRAMEBUFFER,gt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.RENDERBUFFER,gt.__webglColorRenderbuffer[ut]);let N=i.get(M[ut]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,gt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.TEXTURE_2D,N,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,gt.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let M=C.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function be(C){return Math.min(s.maxSamples,C.samples)}function mt(C){let M=i.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Le(C){let M=a.render.frame;h.get(C)!==M&&(h.set(C,M),C.update())}function Bt(C,M){let z=C.colorSpace,st=C.format,J=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||z!==qr&&z!==_n&&(oe.getTransfer(z)===me?(st!==Vi||J!==pi)&&zt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ht("WebGLTextures: Unsupported texture color space:",z)),M}function $t(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=Gt,this.resetTextureUnits=Q,this.getTextureUnits=et,this.setTextureUnits=Et,this.setTexture2D=vt,this.setTexture2DArray=Tt,this.setTexture3D=Ut,this.setTextureCube=_t,this.rebindTextures=se,this.setupRenderTarget=ue,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=ee,this.setupDepthRenderbuffer=ne,this.setupFrameBufferTexture=yt,this.useMultisampledRTT=mt,this.dispose=F}function BM(n,t){function e(i,s=_n){let r,a=oe.getTransfer(s);if(i===pi)return n.UNSIGNED_BYTE;if(i===Fl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Bl)return n.UNSIGNED_SHORT_5_5_5_1;if(i===xu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===yu)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===mu)return n.BYTE;if(i===gu)return n.SHORT;if(i===or)return n.UNSIGNED_SHORT;if(i===Ul)return n.INT;if(i===zi)return n.UNSIGNED_INT;if(i===Ii)return n.FLOAT;if(i===Gi)return n.HALF_FLOAT;if(i===vu)return n.ALPHA;if(i===_u)return n.RGB;if(i===Vi)return n.RGBA;if(i===fn)return n.DEPTH_COMPONENT;if(i===vn)return n.DEPTH_STENCIL;if(i===zl)return n.RED;if(i===Gl)return n.RED_INTEGER;if(i===Gn)return n.RG;if(i===Vl)return n.RG_INTEGER;if(i===Hl)return n.RGBA_INTEGER;if(i===Ca||i===Ra||i===Pa||i===Ia)if(a===me)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ca)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ca)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ra)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Wl||i===$l||i===Xl||i===ql)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Wl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===$l)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Xl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ql)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===jl||i===Yl||i===Zl||i===Kl||i===Jl||i===Na||i===Ql)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===jl||i===Yl)return a===me?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Zl)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Kl)return r.COMPRESSED_R11_EAC;if(i===Jl)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Na)return r.COMPRESSED_RG11_EAC;if(i===Ql)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===tc||i===ec||i===ic||i===nc||i===sc||i===rc||i===ac||i===oc||i===lc||i===cc||i===hc||i===dc||i===uc||i===fc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===tc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ec)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ic)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===nc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===sc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===rc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ac)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===oc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===lc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===cc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===hc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===dc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===uc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===fc)return a===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===pc||i===mc||i===gc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===pc)return a===me?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===mc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===gc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===xc||i===yc||i===La||i===vc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===xc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===yc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===La)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===vc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===fs?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var zM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,GM=`
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

}`,$u=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new oa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ki({vertexShader:zM,fragmentShader:GM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ne(new ya(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Xu=class extends Bi{constructor(t,e){super();let i=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,p=null,y=typeof XRWebGLBinding<"u",m=new $u,x={},_=e.getContextAttributes(),w=null,b=null,T=[],A=[],v=new it,E=null,D=null,P=new Je;P.viewport=new Re;let k=new Je;k.viewport=new Re;let U=[P,k],$=new Nl,R=null,F=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let vt=T[j];return vt===void 0&&(vt=new Ys,T[j]=vt),vt.getTargetRaySpace()},this.getControllerGrip=function(j){let vt=T[j];return vt===void 0&&(vt=new Ys,T[j]=vt),vt.getGripSpace()},this.getHand=function(j){let vt=T[j];return vt===void 0&&(vt=new Ys,T[j]=vt),vt.getHandSpace()};function W(j){let vt=A.indexOf(j.inputSource);if(vt===-1)return;let Tt=T[vt];Tt!==void 0&&(Tt.update(j.inputSource,j.frame,c||a),Tt.dispatchEvent({type:j.type,data:j.inputSource}))}function V(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",nt);for(let j=0;j<T.length;j++){let vt=A[j];vt!==null&&(A[j]=null,T[j].disconnect(vt))}R=null,F=null,m.reset();for(let j in x)delete x[j];if(t.setRenderTarget(w),f=null,u=null,d=null,s=null,b=null,Gt.stop(),i.isPresenting=!1,t.setPixelRatio(E),t.setSize(v.width,v.height,!1),D!==null){let j=D.camera;j.fov=D.fov,j.zoom=D.zoom,j.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,i.isPresenting===!0&&zt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){o=j,i.isPresenting===!0&&zt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",V),s.addEventListener("inputsourceschange",nt),_.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Tt=null,Ut=null,_t=null;_.depth&&(_t=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Tt=_.stencil?vn:fn,Ut=_.stencil?fs:zi);let Ft={colorFormat:e.RGBA8,depthFormat:_t,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Ft),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),b=new wi(u.textureWidth,u.textureHeight,{format:Vi,type:pi,depthTexture:new gn(u.textureWidth,u.textureHeight,Ut,void 0,void 0,void 0,void 0,void 0,void 0,Tt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let Tt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,Tt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new wi(f.framebufferWidth,f.framebufferHeight,{format:Vi,type:pi,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),Gt.setContext(s),Gt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function nt(j){for(let vt=0;vt<j.removed.length;vt++){let Tt=j.removed[vt],Ut=A.indexOf(Tt);Ut>=0&&(A[Ut]=null,T[Ut].disconnect(Tt))}for(let vt=0;vt<j.added.length;vt++){let Tt=j.added[vt],Ut=A.indexOf(Tt);if(Ut===-1){for(let Ft=0;Ft<T.length;Ft++)if(Ft>=A.length){A.push(Tt),Ut=Ft;break}else if(A[Ft]===null){A[Ft]=Tt,Ut=Ft;break}if(Ut===-1)break}let _t=T[Ut];_t&&_t.connect(Tt)}}function X(j,vt){vt===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(vt.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let vt=j.near,Tt=j.far;m.texture!==null&&(m.depthNear>0&&(vt=m.depthNear),m.depthFar>0&&(Tt=m.depthFar)),$.near=k.near=P.near=vt,$.far=k.far=P.far=Tt,(R!==$.near||F!==$.far)&&(s.updateRenderState({depthNear:$.near,depthFar:$.far}),R=$.near,F=$.far),$.layers.mask=j.layers.mask|6,P.layers.mask=$.layers.mask&-5,k.layers.mask=$.layers.mask&-3;let Ut=j.parent,_t=$.cameras;X($,Ut);for(let Ft=0;Ft<_t.length;Ft++)X(_t[Ft],Ut);$.projectionMatrix.copy(P.projectionMatrix),$.projectionMatrixInverse.copy(P.projectionMatrixInverse),D===null&&j.isPerspectiveCamera&&(D={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,$,Ut)};function Q(j,vt,Tt){Tt===null?j.matrix.copy(vt.matrixWorld):(j.matrix.copy(Tt.matrixWorld),j.matrix.invert(),j.matrix.multiply(vt.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(vt.projectionMatrix),j.projectionMatrixInverse.copy(vt.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=qs*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return $},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(j){l=j,u!==null&&(u.fixedFoveation=j),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=j)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh($)},this.getCameraTexture=function(j){return x[j]};let et=null;function Et(j,vt){if(h=vt.getViewerPose(c||a),p=vt,h!==null){let Tt=h.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Ut=!1;Tt.length!==$.cameras.length&&($.cameras.length=0,Ut=!0);for(let Vt=0;Vt<Tt.length;Vt++){let te=Tt[Vt],ie=null;if(f!==null)ie=f.getViewport(te);else{let dt=d.getViewSubImage(u,te);ie=dt.viewport,Vt===0&&(t.setRenderTargetTextures(b,dt.colorTexture,dt.depthStencilTexture),t.setRenderTarget(b))}let tt=U[Vt];tt===void 0&&(tt=new Je,tt.layers.enable(Vt),tt.viewport=new Re,U[Vt]=tt),tt.matrix.fromArray(te.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(te.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ie.x,ie.y,ie.width,ie.height),Vt===0&&($.matrix.copy(tt.matrix),$.matrix.decompose($.position,$.quaternion,$.scale)),Ut===!0&&$.cameras.push(tt)}let _t=s.enabledFeatures;if(_t&&_t.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=i.getBinding();let Vt=d.getDepthInformation(Tt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(_t&&_t.includes("camera-access")&&y){t.state.unbindTexture(),d=i.getBinding();for(let Vt=0;Vt<Tt.length;Vt++){let te=Tt[Vt].camera;if(te){let ie=x[te];ie||(ie=new oa,x[te]=ie);let tt=d.getCameraImage(te);ie.sourceTexture=tt}}}}for(let Tt=0;Tt<T.length;Tt++){let Ut=A[Tt],_t=T[Tt];Ut!==null&&_t!==void 0&&_t.update(Ut,vt,c||a)}et&&et(j,vt),vt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:vt}),p=null}let Gt=new dg;Gt.setAnimationLoop(Et),this.setAnimationLoop=function(j){et=j},this.dispose=function(){}}},VM=new ge,bg=new Xt;bg.set(-1,0,0,0,1,0,0,0,1);function HM(n,t){function e(m,x){m.matrixAutoUpdate===!0&&m.updateMatrix(),x.value.copy(m.matrix)}function i(m,x){x.color.getRGB(m.fogColor.value,Lu(n)),x.isFog?(m.fogNear.value=x.near,m.fogFar.value=x.far):x.isFogExp2&&(m.fogDensity.value=x.density)}function s(m,x,_,w,b){x.isNodeMaterial?x.uniformsNeedUpdate=!1:x.isMeshBasicMaterial?r(m,x):x.isMeshLambertMaterial?(r(m,x),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)):x.isMeshToonMaterial?(r(m,x),d(m,x)):x.isMeshPhongMaterial?(r(m,x),h(m,x),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)):x.isMeshStandardMaterial?(r(m,x),u(m,x),x.isMeshPhysicalMaterial&&f(m,x,b)):x.isMeshMatcapMaterial?(r(m,x),p(m,x)):x.isMeshDepthMaterial?r(m,x):x.isMeshDistanceMaterial?(r(m,x),y(m,x)):x.isMeshNormalMaterial?r(m,x):x.isLineBasicMaterial?(a(m,x),x.isLineDashedMaterial&&o(m,x)):x.isPointsMaterial?l(m,x,_,w):x.isSpriteMaterial?c(m,x):x.isShadowMaterial?(m.color.value.copy(x.color),m.opacity.value=x.opacity):x.isShaderMaterial&&(x.uniformsNeedUpdate=!1)}function r(m,x){m.opacity.value=x.opacity,x.color&&m.diffuse.value.copy(x.color),x.emissive&&m.emissive.value.copy(x.emissive).multiplyScalar(x.emissiveIntensity),x.map&&(m.map.value=x.map,e(x.map,m.mapTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,e(x.alphaMap,m.alphaMapTransform)),x.bumpMap&&(m.bumpMap.value=x.bumpMap,e(x.bumpMap,m.bumpMapTransform),m.bumpScale.value=x.bumpScale,x.side===Be&&(m.bumpScale.value*=-1)),x.normalMap&&(m.normalMap.value=x.normalMap,e(x.normalMap,m.normalMapTransform),m.normalScale.value.copy(x.normalScale),x.side===Be&&m.normalScale.value.negate()),x.displacementMap&&(m.displacementMap.value=x.displacementMap,e(x.displacementMap,m.displacementMapTransform),m.displacementScale.value=x.displacementScale,m.displacementBias.value=x.displacementBias),x.emissiveMap&&(m.emissiveMap.value=x.emissiveMap,e(x.emissiveMap,m.emissiveMapTransform)),x.specularMap&&(m.specularMap.value=x.specularMap,e(x.specularMap,m.specularMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest);let _=t.get(x),w=_.envMap,b=_.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(VM.makeRotationFromEuler(b)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(bg),m.reflectivity.value=x.reflectivity,m.ior.value=x.ior,m.refractionRatio.value=x.refractionRatio),x.lightMap&&(m.lightMap.value=x.lightMap,m.lightMapIntensity.value=x.lightMapIntensity,e(x.lightMap,m.lightMapTransform)),x.aoMap&&(m.aoMap.value=x.aoMap,m.aoMapIntensity.value=x.aoMapIntensity,e(x.aoMap,m.aoMapTransform))}function a(m,x){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,x.map&&(m.map.value=x.map,e(x.map,m.mapTransform))}function o(m,x){m.dashSize.value=x.dashSize,m.totalSize.value=x.dashSize+x.gapSize,m.scale.value=x.scale}function l(m,x,_,w){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,m.size.value=x.size*_,m.scale.value=w*.5,x.map&&(m.map.value=x.map,e(x.map,m.uvTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,e(x.alphaMap,m.alphaMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest)}function c(m,x){m.diffuse.value.copy(x.color),m.opacity.value=x.opacity,m.rotation.value=x.rotation,x.map&&(m.map.value=x.map,e(x.map,m.mapTransform)),x.alphaMap&&(m.alphaMap.value=x.alphaMap,e(x.alphaMap,m.alphaMapTransform)),x.alphaTest>0&&(m.alphaTest.value=x.alphaTest)}function h(m,x){m.specular.value.copy(x.specular),m.shininess.value=Math.max(x.shininess,1e-4)}function d(m,x){x.gradientMap&&(m.gradientMap.value=x.gradientMap)}function u(m,x){m.metalness.value=x.metalness,x.metalnessMap&&(m.metalnessMap.value=x.metalnessMap,e(x.metalnessMap,m.metalnessMapTransform)),m.roughness.value=x.roughness,x.roughnessMap&&(m.roughnessMap.value=x.roughnessMap,e(x.roughnessMap,m.roughnessMapTransform)),x.envMap&&(m.envMapIntensity.value=x.envMapIntensity)}function f(m,x,_){m.ior.value=x.ior,x.diffuseRoughness>0&&(m.diffuseRoughness.value=x.diffuseRoughness,x.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=x.diffuseRoughnessMap,e(x.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),x.sheen>0&&(m.sheenColor.value.copy(x.sheenColor).multiplyScalar(x.sheen),m.sheenRoughness.value=x.sheenRoughness,x.sheenColorMap&&(m.sheenColorMap.value=x.sheenColorMap,e(x.sheenColorMap,m.sheenColorMapTransform)),x.sheenRoughnessMap&&(m.sheenRoughnessMap.value=x.sheenRoughnessMap,e(x.sheenRoughnessMap,m.sheenRoughnessMapTransform))),x.clearcoat>0&&(m.clearcoat.value=x.clearcoat,m.clearcoatRoughness.value=x.clearcoatRoughness,x.clearcoatMap&&(m.clearcoatMap.value=x.clearcoatMap,e(x.clearcoatMap,m.clearcoatMapTransform)),x.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=x.clearcoatRoughnessMap,e(x.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),x.clearcoatNormalMap&&(m.clearcoatNormalMap.value=x.clearcoatNormalMap,e(x.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(x.clearcoatNormalScale),x.side===Be&&m.clearcoatNormalScale.value.negate())),x.dispersion>0&&(m.dispersion.value=x.dispersion),x.retroreflectivity>0&&(m.retroreflectivity.value=x.retroreflectivity),x.iridescence>0&&(m.iridescence.value=x.iridescence,m.iridescenceIOR.value=x.iridescenceIOR,m.iridescenceThicknessMinimum.value=x.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=x.iridescenceThicknessMaximum,x.iridescenceMap&&(m.iridescenceMap.value=x.iridescenceMap,e(x.iridescenceMap,m.iridescenceMapTransform)),x.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=x.iridescenceThicknessMap,e(x.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),x.transmission>0&&(m.transmission.value=x.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),x.transmissionMap&&(m.transmissionMap.value=x.transmissionMap,e(x.transmissionMap,m.transmissionMapTransform)),m.thickness.value=x.thickness,x.thicknessMap&&(m.thicknessMap.value=x.thicknessMap,e(x.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=x.attenuationDistance,m.attenuationColor.value.copy(x.attenuationColor)),x.anisotropy>0&&(m.anisotropyVector.value.set(x.anisotropy*Math.cos(x.anisotropyRotation),x.anisotropy*Math.sin(x.anisotropyRotation)),x.anisotropyMap&&(m.anisotropyMap.value=x.anisotropyMap,e(x.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=x.specularIntensity,m.specularColor.value.copy(x.specularColor),x.specularColorMap&&(m.specularColorMap.value=x.specularColorMap,e(x.specularColorMap,m.specularColorMapTransform)),x.specularIntensityMap&&(m.specularIntensityMap.value=x.specularIntensityMap,e(x.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,x){x.matcap&&(m.matcap.value=x.matcap)}function y(m,x){let _=t.get(x).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function WM(n,t,e,i){let s={},r={};function a(_,w){let b=w.program;i.uniformBlockBinding(_,b,s[_.id])}function o(_,w){let b=s[_.id];b===void 0&&(p(_),b=l(_),s[_.id]=b,_.addEventListener("dispose",m));let T=w.program;i.updateUBOMapping(_,T);let A=t.render.frame;r[_.id]!==A&&(c(_),r[_.id]=A)}function l(_){let w=n.createBuffer(),b=_.__size,T=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,b,T),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=s[_.id],b=_.uniforms,T=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let A=0,v=b.length;A<v;A++){let E=b[A];if(Array.isArray(E))for(let D=0,P=E.length;D<P;D++)h(E[D],A,D,T);else h(E,A,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,w,b,T){if(u(_,w,b,T)===!0){let A=_.__offset,v=_.value;if(Array.isArray(v)){let E=0;for(let D=0;D<v.length;D++){let P=v[D],k=y(P,!0);d(P,_.__data,E),E+=k.storage/Float32Array.BYTES_PER_ELEMENT}}else d(v,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,_.__data)}}function d(_,w,b){typeof _=="number"||typeof _=="boolean"?w[b]=_:_.isMatrix3?(w[b]=_.elements[0],w[b+1]=_.elements[1],w[b+2]=_.elements[2],w[b+3]=0,w[b+4]=_.elements[3],w[b+5]=_.elements[4],w[b+6]=_.elements[5],w[b+7]=0,w[b+8]=_.elements[6],w[b+9]=_.elements[7],w[b+10]=_.elements[8],w[b+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-b),b):_.toArray(w,b)}function u(_,w,b,T){let A=_.value,v=w+"_"+b;if(Array.isArray(A)){T[v]===void 0&&(T[v]=[]);let E=T[v],D=!1;for(let P=0;P<A.length;P++)f(A[P],E,P)===!0&&(D=!0);return D}return f(A,T,v)}function f(_,w,b){if(w[b]===void 0)return typeof _=="number"||typeof _=="boolean"?w[b]=_:ArrayBuffer.isView(_)?w[b]=_.slice():w[b]=_.clone(),!0;{let T=w[b];if(typeof _=="number"||typeof _=="boolean"){if(T!==_)return w[b]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(T.equals(_)===!1)return T.copy(_),!0}}return!1}function p(_){let w=_.uniforms,b=0,T=16;for(let v=0,E=w.length;v<E;v++){let D=Array.isArray(w[v])?w[v]:[w[v]];for(let P=0,k=D.length;P<k;P++){let U=D[P],$=Array.isArray(U.value)?U.value:[U.value],R=Array.isArray(w[v])||Array.isArray(U.value),F=b;for(let V=0,nt=$.length;V<nt;V++){let X=$[V],Q=y(X,R),et=b%T,Et=et%Q.boundary,Gt=et+Et;b+=Et,Gt!==0&&T-Gt<Q.storage&&(b+=T-Gt),V===0&&(F=b),b+=Q.storage}let W=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new W((b-F)/Float32Array.BYTES_PER_ELEMENT),U.__offset=F}}let A=b%T;return A>0&&(b+=T-A),_.__size=b,_.__cache={},this}function y(_,w){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=16,b.storage=48):_.isMatrix4?(b.boundary=16,b.storage=64):_.isTexture?zt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(b.boundary=16,b.storage=_.byteLength):zt("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(_){let w=_.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function x(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:a,update:o,dispose:x}}var $M=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),en=null;function XM(){return en===null&&(en=new na($M,16,16,Gn,Gi),en.name="DFG_LUT",en.minFilter=hi,en.magFilter=hi,en.wrapS=Xi,en.wrapT=Xi,en.generateMipmaps=!1,en.needsUpdate=!0),en}var Ac=class{constructor(t={}){let{canvas:e=Im(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=pi}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=a;let y=f,m=new Set([Hl,Vl,Gl]),x=new Set([pi,zi,or,fs,Fl,Bl]),_=new Uint32Array(4),w=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},T=null,A=null,v=[],E=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=tn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,k=!1,U=null,$=null,R=null,F=null;this._outputColorSpace=_i;let W=0,V=0,nt=null,X=-1,Q=null,et=new Re,Et=new Re,Gt=null,j=new kt(0),vt=0,Tt=e.width,Ut=e.height,_t=1,Ft=null,Ae=null,Vt=new Re(0,0,Tt,Ut),te=new Re(0,0,Tt,Ut),ie=!1,tt=new kn,dt=new ll,ot=!1,At=!1,yt=new ge,jt=new I,Lt=new Re,ne={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},se=!1;function ue(){return nt===null?_t:1}let O=i;function ke(S,L){return e.getContext(S,L)}let ee,be,mt,Le,Bt,$t,C,M,z,st,J,lt,gt,Y,Z,ut,N,K,q,ft,at,ct,Dt;try{let S={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Yt,!1),e.addEventListener("webglcontextcreationerror",bt,!1),O===null){let L="webgl2";if(O=ke(L,S),O===null)throw ke(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Zt()}catch(S){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Yt,!1),e.removeEventListener("webglcontextcreationerror",bt,!1),Ht("WebGLRenderer: "+S.message),S}function Zt(){ee=new nw(O),ee.init(),at=new BM(O,ee),be=new Xb(O,ee,t,at),mt=new UM(O,ee),be.reversedDepthBuffer&&u&&mt.buffers.depth.setReversed(!0),$=O.createFramebuffer(),R=O.createFramebuffer(),F=O.createFramebuffer(),Le=new aw(O),Bt=new MM,$t=new FM(O,ee,mt,Bt,be,at,Le),C=new iw(P),M=new lv(O),ct=new Wb(O,M),z=new sw(O,M,Le,ct),st=new lw(O,z,M,ct,Le),K=new ow(O,be,$t),Z=new qb(Bt),J=new wM(P,C,ee,be,ct,Z),lt=new HM(P,Bt),gt=new AM,Y=new IM(ee),N=new Hb(P,C,mt,st,p,l),ut=new OM(P,st,be),Dt=new WM(O,Le,be,mt),q=new $b(O,ee,Le),ft=new rw(O,ee,Le),Le.programs=J.programs,P.capabilities=be,P.extensions=ee,P.properties=Bt,P.renderLists=gt,P.shadowMap=ut,P.state=mt,P.info=Le}y!==pi&&(D=new hw(y,e.width,e.height,o,s,r));let rt=new Xu(P,O);this.xr=rt,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let S=ee.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=ee.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return _t},this.setPixelRatio=function(S){S!==void 0&&(_t=S,this.setSize(Tt,Ut,!1))},this.getSize=function(S){return S.set(Tt,Ut)},this.setSize=function(S,L,H=!0){if(rt.isPresenting){zt("WebGLRenderer: Can't change size while VR device is presenting.");return}Tt=S,Ut=L,e.width=Math.floor(S*_t),e.height=Math.floor(L*_t),H===!0&&(e.style.width=S+"px",e.style.height=L+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,S,L)},this.getDrawingBufferSize=function(S){return S.set(Tt*_t,Ut*_t).floor()},this.setDrawingBufferSize=function(S,L,H){Tt=S,Ut=L,_t=H,e.width=Math.floor(S*H),e.height=Math.floor(L*H),this.setViewport(0,0,S,L)},this.setEffects=function(S){if(y===pi){Ht("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let L=0;L<S.length;L++)if(S[L].isOutputPass===!0){zt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(et)},this.getViewport=function(S){return S.copy(Vt)},this.setViewport=function(S,L,H,B){S.isVector4?Vt.set(S.x,S.y,S.z,S.w):Vt.set(S,L,H,B),mt.viewport(et.copy(Vt).multiplyScalar(ue()).round())},this.getScissor=function(S){return S.copy(te)},this.setScissor=function(S,L,H,B){S.isVector4?te.set(S.x,S.y,S.z,S.w):te.set(S,L,H,B),mt.scissor(Et.copy(te).multiplyScalar(ue()).round())},this.getScissorTest=function(){return ie},this.setScissorTest=function(S){mt.setScissorTest(ie=S)},this.setOpaqueSort=function(S){Ft=S},this.setTransparentSort=function(S){Ae=S},this.getClearColor=function(S){return S.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(S=!0,L=!0,H=!0){let B=0;if(S){let G=!1;if(nt!==null){let xt=nt.texture.format;G=m.has(xt)}if(G){let xt=nt.texture.type,Ct=x.has(xt),pt=N.getClearColor(),Mt=N.getClearAlpha(),Nt=pt.r,qt=pt.g,re=pt.b;Ct?(_[0]=Nt,_[1]=qt,_[2]=re,_[3]=Mt,O.clearBufferuiv(O.COLOR,0,_)):(w[0]=Nt,w[1]=qt,w[2]=re,w[3]=Mt,O.clearBufferiv(O.COLOR,0,w))}else B|=O.COLOR_BUFFER_BIT}L&&(B|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(B|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),B!==0&&O.clear(B)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),U=S},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Yt,!1),e.removeEventListener("webglcontextcreationerror",bt,!1),N.dispose(),gt.dispose(),Y.dispose(),$t.dispose(),Bt.dispose(),C.dispose(),st.dispose(),z.dispose(),ct.dispose(),Dt.dispose(),J.dispose(),rt.dispose(),rt.removeEventListener("sessionstart",jf),rt.removeEventListener("sessionend",Yf),qn.stop()};function Ot(S){S.preventDefault(),Zr("WebGLRenderer: Context Lost."),k=!0}function Yt(){Zr("WebGLRenderer: Context Restored."),k=!1;let S=Le.autoReset,L=ut.enabled,H=ut.autoUpdate,B=ut.needsUpdate,G=ut.type;Zt(),Le.autoReset=S,ut.enabled=L,ut.autoUpdate=H,ut.needsUpdate=B,ut.type=G}function bt(S){Ht("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function xe(S){let L=S.target;L.removeEventListener("dispose",xe),$e(L)}function $e(S){An(S),Bt.remove(S)}function An(S){let L=Bt.get(S).programs;L!==void 0&&(L.forEach(function(H){J.releaseProgram(H)}),S.isShaderMaterial&&J.releaseShaderCache(S))}this.renderBufferDirect=function(S,L,H,B,G,xt){L===null&&(L=ne);let Ct=G.isMesh&&G.matrixWorld.determinantAffine()<0,pt=kx(S,L,H,B,G);mt.setMaterial(B,Ct);let Mt=H.index,Nt=1;if(B.wireframe===!0){if(Mt=z.getWireframeAttribute(H),Mt===void 0)return;Nt=2}let qt=H.drawRange,re=H.attributes.position,Rt=qt.start*Nt,ae=(qt.start+qt.count)*Nt;xt!==null&&(Rt=Math.max(Rt,xt.start*Nt),ae=Math.min(ae,(xt.start+xt.count)*Nt)),Mt!==null?(Rt=Math.max(Rt,0),ae=Math.min(ae,Mt.count)):re!=null&&(Rt=Math.max(Rt,0),ae=Math.min(ae,re.count));let Oe=ae-Rt;if(Oe<0||Oe===1/0)return;ct.setup(G,B,pt,H,Mt);let Me,we=q;if(Mt!==null&&(Me=M.get(Mt),we=ft,we.setIndex(Me)),G.isMesh)B.wireframe===!0?(mt.setLineWidth(B.wireframeLinewidth*ue()),we.setMode(O.LINES)):we.setMode(O.TRIANGLES);else if(G.isLine){let ei=B.linewidth;ei===void 0&&(ei=1),mt.setLineWidth(ei*ue()),G.isLineSegments?we.setMode(O.LINES):G.isLineLoop?we.setMode(O.LINE_LOOP):we.setMode(O.LINE_STRIP)}else G.isPoints?we.setMode(O.POINTS):G.isSprite&&we.setMode(O.TRIANGLES);if(G.isBatchedMesh)if(ee.get("WEBGL_multi_draw"))we.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let ei=G._multiDrawStarts,Pt=G._multiDrawCounts,li=G._multiDrawCount,fe=Mt?M.get(Mt).bytesPerElement:1,jn=Bt.get(B).currentProgram.getUniforms();for(let ii=0;ii<li;ii++)jn.setValue(O,"_gl_DrawID",ii),we.render(ei[ii]/fe,Pt[ii])}else if(G.isInstancedMesh)we.renderInstances(Rt,Oe,G.count);else if(H.isInstancedBufferGeometry){let ei=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,Pt=Math.min(H.instanceCount,ei);we.renderInstances(Rt,Oe,Pt)}else we.render(Rt,Oe)};function qf(S,L,H,B){U!==null&&S.isNodeMaterial&&U.setObject(B,S),ot===!0&&Z.setState(S,H,!1),S.transparent===!0&&S.side===ri&&S.forceSinglePass===!1?(S.side=Be,S.needsUpdate=!0,Tr(S,L,B),S.side=zn,S.needsUpdate=!0,Tr(S,L,B),S.side=ri):Tr(S,L,B)}this.compile=function(S,L,H=null){H===null&&(H=S),U!==null&&U.renderStart(S,L,H),A=Y.get(H),A.init(L),E.push(A),H.traverseVisible(function(G){G.isLight&&G.layers.test(L.layers)&&(A.pushLight(G),G.castShadow&&A.pushShadow(G))}),S!==H&&S.traverseVisible(function(G){G.isLight&&G.layers.test(L.layers)&&(A.pushLight(G),G.castShadow&&A.pushShadow(G))}),A.setupLights(),U!==null&&U.updateLights(A.state.lightsArray),At=this.localClippingEnabled,ot=Z.init(this.clippingPlanes,At),ot===!0&&Z.setGlobalState(this.clippingPlanes,L),U!==null&&ut.render(A.state.shadowsArray,H,L);let B=new Set;return S.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let xt=G.material;if(xt)if(Array.isArray(xt))for(let Ct=0;Ct<xt.length;Ct++){let pt=xt[Ct];qf(pt,H,L,G),B.add(pt)}else qf(xt,H,L,G),B.add(xt)}),A=E.pop(),U!==null&&U.renderEnd(),B},this.compileAsync=function(S,L,H=null){let B=this.compile(S,L,H);return new Promise(G=>{function xt(){if(B.forEach(function(Ct){let Mt=Bt.get(Ct).currentProgram;(Mt===void 0||Mt.isReady())&&B.delete(Ct)}),B.size===0){G(S);return}setTimeout(xt,10)}ee.get("KHR_parallel_shader_compile")!==null?xt():setTimeout(xt,10)})};let ld=null;function Lx(S){ld&&ld(S)}function jf(){qn.stop()}function Yf(){qn.start()}let qn=new dg;qn.setAnimationLoop(Lx),typeof self<"u"&&qn.setContext(self),this.setAnimationLoop=function(S){ld=S,rt.setAnimationLoop(S),S===null?qn.stop():qn.start()},rt.addEventListener("sessionstart",jf),rt.addEventListener("sessionend",Yf),this.render=function(S,L){if(L!==void 0&&L.isCamera!==!0){Ht("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(k===!0)return;U!==null&&U.renderStart(S,L);let H=rt.enabled===!0&&rt.isPresenting===!0,B=D!==null&&(nt===null||H)&&D.begin(P,nt);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),rt.enabled===!0&&rt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(rt.cameraAutoUpdate===!0&&rt.updateCamera(L),L=rt.getCamera()),S.isScene===!0&&S.onBeforeRender(P,S,L,nt),A=Y.get(S,E.length),A.init(L),A.state.textureUnits=$t.getTextureUnits(),E.push(A),yt.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?dt.setFromArrayCamera(L):tt.setFromProjectionMatrix(yt,Ri,L.reversedDepth),At=this.localClippingEnabled,ot=Z.init(this.clippingPlanes,At),T=gt.get(S,v.length),T.init(),v.push(T),this.info.render.frame++,rt.enabled===!0&&rt.isPresenting===!0){let Ct=P.xr.getDepthSensingMesh();Ct!==null&&cd(Ct,L,-1/0,P.sortObjects)}cd(S,L,0,P.sortObjects),T.finish(),U!==null&&U.updateLights(A.state.lightsArray),P.sortObjects===!0&&T.sort(Ft,Ae),se=rt.enabled===!1||rt.isPresenting===!1||rt.hasDepthSensing()===!1,se&&N.addToRenderList(T,S),this.info.autoReset===!0&&this.info.reset(),ot===!0&&Z.beginShadows();let G=A.state.shadowsArray;if(ut.render(G,S,L),ot===!0&&Z.endShadows(),(B&&D.hasRenderPass())===!1){let Ct=T.opaque,pt=T.transmissive;if(A.setupLights(),L.isArrayCamera){let Mt=L.cameras;if(pt.length>0)for(let Nt=0,qt=Mt.length;Nt<qt;Nt++){let re=Mt[Nt];Kf(Ct,pt,S,re)}se&&N.render(S);for(let Nt=0,qt=Mt.length;Nt<qt;Nt++){let re=Mt[Nt];Zf(T,S,re,re.viewport)}}else pt.length>0&&Kf(Ct,pt,S,L),se&&N.render(S),Zf(T,S,L)}nt!==null&&V===0&&($t.updateMultisampleRenderTarget(nt),$t.updateRenderTargetMipmap(nt)),B&&D.end(P),S.isScene===!0&&S.onAfterRender(P,S,L),ct.resetDefaultState(),X=-1,Q=null,E.pop(),E.length>0?(A=E[E.length-1],$t.setTextureUnits(A.state.textureUnits),ot===!0&&Z.setGlobalState(P.clippingPlanes,A.state.camera)):A=null,v.pop(),v.length>0?T=v[v.length-1]:T=null,U!==null&&U.renderEnd()};function cd(S,L,H,B){if(S.visible===!1)return;if(S.layers.test(L.layers)){if(S.isGroup)H=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(L);else if(S.isLight)A.pushLight(S),S.castShadow&&A.pushShadow(S);else if(S.isSprite){let Ct=L.isArrayCamera?dt:tt;if(!S.frustumCulled||S.intersectsFrustum(Ct)){B&&Lt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(yt);let pt=st.update(S),Mt=S.material;Mt.visible&&T.push(S,pt,Mt,H,Lt.z,null,L)}}else if(S.isMesh||S.isLine||S.isPoints){let Ct=L.isArrayCamera?dt:tt;if(!S.frustumCulled||S.intersectsFrustum(Ct)){let pt=st.update(S),Mt=S.material;if(B&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Lt.copy(S.boundingSphere.center)):(pt.boundingSphere===null&&pt.computeBoundingSphere(),Lt.copy(pt.boundingSphere.center)),Lt.applyMatrix4(S.matrixWorld).applyMatrix4(yt)),Array.isArray(Mt)){let Nt=pt.groups;for(let qt=0,re=Nt.length;qt<re;qt++){let Rt=Nt[qt],ae=Mt[Rt.materialIndex];ae&&ae.visible&&T.push(S,pt,ae,H,Lt.z,Rt,L)}}else Mt.visible&&T.push(S,pt,Mt,H,Lt.z,null,L)}}}let xt=S.children;for(let Ct=0,pt=xt.length;Ct<pt;Ct++)cd(xt[Ct],L,H,B)}function Zf(S,L,H,B){let{opaque:G,transmissive:xt,transparent:Ct}=S;A.setupLightsView(H),ot===!0&&Z.setGlobalState(P.clippingPlanes,H),B&&mt.viewport(et.copy(B)),G.length>0&&ao(G,L,H),xt.length>0&&ao(xt,L,H),Ct.length>0&&ao(Ct,L,H),mt.buffers.depth.setTest(!0),mt.buffers.depth.setMask(!0),mt.buffers.color.setMask(!0),mt.setPolygonOffset(!1)}function Kf(S,L,H,B){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[B.id]===void 0){let Rt=ee.has("EXT_color_buffer_half_float")||ee.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[B.id]=new wi(1,1,{generateMipmaps:!0,type:Rt?Gi:pi,minFilter:yn,samples:Math.max(4,be.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:oe.workingColorSpace})}let xt=A.state.transmissionRenderTarget[B.id],Ct=B.viewport||et;xt.setSize(Ct.z*P.transmissionResolutionScale,Ct.w*P.transmissionResolutionScale);let pt=P.getRenderTarget(),Mt=P.getActiveCubeFace(),Nt=P.getActiveMipmapLevel();P.setRenderTarget(xt),P.getClearColor(j),vt=P.getClearAlpha(),vt<1&&P.setClearColor(16777215,.5),P.clear(),se&&N.render(H);let qt=P.toneMapping;P.toneMapping=tn;let re=B.viewport;if(B.viewport!==void 0&&(B.viewport=void 0),A.setupLightsView(B),ot===!0&&Z.setGlobalState(P.clippingPlanes,B),ao(S,H,B),$t.updateMultisampleRenderTarget(xt),$t.updateRenderTargetMipmap(xt),ee.has("WEBGL_multisampled_render_to_texture")===!1){let Rt=!1;for(let ae=0,Oe=L.length;ae<Oe;ae++){let Me=L[ae],{object:we,geometry:ei,material:Pt,group:li}=Me;if(Pt.side===ri&&we.layers.test(B.layers)){let fe=Pt.side;Pt.side=Be,Pt.needsUpdate=!0,Jf(we,H,B,ei,Pt,li),Pt.side=fe,Pt.needsUpdate=!0,Rt=!0}}Rt===!0&&($t.updateMultisampleRenderTarget(xt),$t.updateRenderTargetMipmap(xt))}P.setRenderTarget(pt,Mt,Nt),P.setClearColor(j,vt),re!==void 0&&(B.viewport=re),P.toneMapping=qt}function ao(S,L,H){let B=L.isScene===!0?L.overrideMaterial:null;for(let G=0,xt=S.length;G<xt;G++){let Ct=S[G],{object:pt,geometry:Mt,group:Nt}=Ct,qt=Ct.material;qt.allowOverride===!0&&B!==null&&(qt=B),pt.layers.test(H.layers)&&Jf(pt,L,H,Mt,qt,Nt)}}function Jf(S,L,H,B,G,xt){U!==null&&G.isNodeMaterial&&U.setObject(S,G),S.onBeforeRender(P,L,H,B,G,xt),S.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),G.onBeforeRender(P,L,H,B,S,xt),G.transparent===!0&&G.side===ri&&G.forceSinglePass===!1?(G.side=Be,G.needsUpdate=!0,P.renderBufferDirect(H,L,B,G,S,xt),G.side=zn,G.needsUpdate=!0,P.renderBufferDirect(H,L,B,G,S,xt),G.side=ri):P.renderBufferDirect(H,L,B,G,S,xt),S.onAfterRender(P,L,H,B,G,xt)}function Qf(S){let L=0;for(let H of S)H.texture!==null&&L++;return L}function Tr(S,L,H){L.isScene!==!0&&(L=ne);let B=Bt.get(S),G=A.state.lights,xt=A.state.shadowsArray,Ct=G.state.version,pt=J.getParameters(S,G.state,xt,L,H,A.state.lightProbeGridArray),Mt=J.getProgramCacheKey(pt),Nt=B.programs;B.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?L.environment:null,B.fog=L.fog;let qt=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;B.envMap=C.get(S.envMap||B.environment,qt),B.envMapRotation=B.environment!==null&&S.envMap===null?L.environmentRotation:S.envMapRotation,Nt===void 0&&(S.addEventListener("dispose",xe),Nt=new Map,B.programs=Nt,B.programVariants=new Map);let re=Nt.get(Mt);if(re!==void 0){if(B.currentProgram===re&&B.lightsStateVersion===Ct)return ep(S,pt),re}else pt.uniforms=J.getUniforms(S),U!==null&&S.isNodeMaterial&&U.build(S,H,pt),S.onBeforeCompile(pt,P),re=J.acquireProgram(pt,Mt),Nt.set(Mt,re),B.uniforms=pt.uniforms;let Rt=B.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(Rt.clippingPlanes=Z.uniform),ep(S,pt),B.needsLights=Ux(S),B.lightsStateVersion=Ct,B.needsLights&&(Rt.ambientLightColor.value=G.state.ambient,Rt.lightProbe.value=G.state.probe,Rt.sunLights.value=G.state.sun,Rt.sunLightShadows.value=G.state.sunShadow,Rt.directionalLights.value=G.state.directional,Rt.directionalLightShadows.value=G.state.directionalShadow,Rt.spotLights.value=G.state.spot,Rt.spotLightShadows.value=G.state.spotShadow,Rt.rectAreaLights.value=G.state.rectArea,Rt.ltc_1.value=G.state.rectAreaLTC1,Rt.ltc_2.value=G.state.rectAreaLTC2,Rt.pointLights.value=G.state.point,Rt.pointLightShadows.value=G.state.pointShadow,Rt.hemisphereLights.value=G.state.hemi,Rt.sunShadowMatrix.value=G.state.sunShadowMatrix,Rt.sunShadowCascade.value=G.state.sunShadowCascade,Rt.directionalShadowMatrix.value=G.state.directionalShadowMatrix,Rt.spotLightMatrix.value=G.state.spotLightMatrix,Rt.spotLightMap.value=G.state.spotLightMap,Rt.pointShadowMatrix.value=G.state.pointShadowMatrix),B.numLightProbeGrids=Qf(A.state.lightProbeGridArray),B.currentProgram=re,B.uniformsList=null,re}function Dx(S,L,H,B,G){let xt=Bt.get(S),Ct=xt.currentProgram.id+","+B+","+G,pt=xt.programVariants.get(Ct);return pt===void 0?(pt=Tr(S,L,H),xt.programVariants.set(Ct,pt)):(xt.currentProgram=pt,xt.uniformsList=null,xt.outputColorSpace=B,xt.toneMapping=G),pt}function tp(S){if(S.uniformsList===null){let L=S.currentProgram.getUniforms();S.uniformsList=lr.seqWithValue(L.seq,S.uniforms)}return S.uniformsList}function ep(S,L){let H=Bt.get(S);H.outputColorSpace=L.outputColorSpace,H.batching=L.batching,H.batchingColor=L.batchingColor,H.instancing=L.instancing,H.instancingColor=L.instancingColor,H.instancingMorph=L.instancingMorph,H.skinning=L.skinning,H.morphTargets=L.morphTargets,H.morphNormals=L.morphNormals,H.morphColors=L.morphColors,H.morphTargetsCount=L.morphTargetsCount,H.numClippingPlanes=L.numClippingPlanes,H.numIntersection=L.numClipIntersection,H.vertexAlphas=L.vertexAlphas,H.vertexTangents=L.vertexTangents,H.toneMapping=L.toneMapping}function kx(S,L,H,B,G){L.isScene!==!0&&(L=ne),$t.resetTextureUnits();let xt=L.fog,Ct=B.isMeshStandardMaterial||B.isMeshLambertMaterial||B.isMeshPhongMaterial?L.environment:null,pt=nt===null?P.outputColorSpace:nt.isXRRenderTarget===!0?nt.texture.colorSpace:oe.workingColorSpace,Mt=B.isMeshStandardMaterial||B.isMeshLambertMaterial&&!B.envMap||B.isMeshPhongMaterial&&!B.envMap,Nt=C.get(B.envMap||Ct,Mt),qt=B.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,re=!!H.attributes.tangent&&(!!B.normalMap||B.anisotropy>0),Rt=!!H.morphAttributes.position,ae=!!H.morphAttributes.normal,Oe=!!H.morphAttributes.color,Me=tn;B.toneMapped&&(nt===null||nt.isXRRenderTarget===!0)&&(Me=P.toneMapping);let we=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,ei=we!==void 0?we.length:0,Pt=Bt.get(B),li=A.state.lights;if(ot===!0&&(At===!0||S!==Q)){let Pe=S===Q&&B.id===X;Z.setState(B,S,Pe)}let fe=!1,jn=!1;B.version===Pt.__version?Pt.needsLights&&Pt.lightsStateVersion!==li.state.version||G.isBatchedMesh&&Pt.batching===!1||!G.isBatchedMesh&&Pt.batching===!0||G.isBatchedMesh&&Pt.batchingColor===!0&&G._colorsTexture===null||G.isBatchedMesh&&Pt.batchingColor===!1&&G._colorsTexture!==null||G.isInstancedMesh&&Pt.instancing===!1||!G.isInstancedMesh&&Pt.instancing===!0||G.isSkinnedMesh&&Pt.skinning===!1||!G.isSkinnedMesh&&Pt.skinning===!0||G.isInstancedMesh&&Pt.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&Pt.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&Pt.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&Pt.instancingMorph===!1&&G.morphTexture!==null||Pt.envMap!==Nt||B.fog===!0&&Pt.fog!==xt||Pt.numClippingPlanes!==void 0&&(Pt.numClippingPlanes!==Z.numPlanes||Pt.numIntersection!==Z.numIntersection)||Pt.vertexAlphas!==qt||Pt.vertexTangents!==re||Pt.morphTargets!==Rt||Pt.morphNormals!==ae||Pt.morphColors!==Oe||Pt.morphTargetsCount!==ei||Pt.numLightProbeGrids!==Qf(A.state.lightProbeGridArray)?fe=!0:(Pt.outputColorSpace!==pt||Pt.toneMapping!==Me)&&(jn=!0):(fe=!0,Pt.__version=B.version);let ii=Pt.currentProgram;(fe===!0||jn===!0)&&(ii=jn===!0?Dx(B,L,G,pt,Me):Tr(B,L,G),U&&B.isNodeMaterial&&U.onUpdateProgram(B,ii,Pt));let oo=!1,En=!1,Yn=!1,ce=ii.getUniforms(),Ze=Pt.uniforms;if(mt.useProgram(ii.program)&&(oo=!0,En=!0,Yn=!0),B.id!==X&&(X=B.id,En=!0),oo||Q!==S){mt.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),ce.setValue(O,"projectionMatrix",S.projectionMatrix),ce.setValue(O,"viewMatrix",S.matrixWorldInverse);let Xe=ce.map.cameraPosition;Xe!==void 0&&Xe.setValue(O,jt.setFromMatrixPosition(S.matrixWorld)),be.logarithmicDepthBuffer&&ce.setValue(O,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(B.isMeshPhongMaterial||B.isMeshToonMaterial||B.isMeshLambertMaterial||B.isMeshBasicMaterial||B.isMeshStandardMaterial||B.isShaderMaterial)&&ce.setValue(O,"isOrthographic",S.isOrthographicCamera===!0),Q!==S&&(Q=S,En=!0,Yn=!0)}if(Pt.needsLights&&(li.state.sunShadowMap.length>0&&ce.setValue(O,"sunShadowMap",li.state.sunShadowMap,$t),li.state.directionalShadowMap.length>0&&ce.setValue(O,"directionalShadowMap",li.state.directionalShadowMap,$t),li.state.spotShadowMap.length>0&&ce.setValue(O,"spotShadowMap",li.state.spotShadowMap,$t),li.state.pointShadowMap.length>0&&ce.setValue(O,"pointShadowMap",li.state.pointShadowMap,$t)),G.isSkinnedMesh){ce.setOptional(O,G,"bindMatrix"),ce.setOptional(O,G,"bindMatrixInverse");let Pe=G.skeleton;Pe&&(Pe.boneTexture===null&&Pe.computeBoneTexture(),ce.setValue(O,"boneTexture",Pe.boneTexture,$t))}G.isBatchedMesh&&(ce.setOptional(O,G,"batchingTexture"),ce.setValue(O,"batchingTexture",G._matricesTexture,$t),ce.setOptional(O,G,"batchingIdTexture"),ce.setValue(O,"batchingIdTexture",G._indirectTexture,$t),ce.setOptional(O,G,"batchingColorTexture"),G._colorsTexture!==null&&ce.setValue(O,"batchingColorTexture",G._colorsTexture,$t));let ki=H.morphAttributes;if((ki.position!==void 0||ki.normal!==void 0||ki.color!==void 0)&&K.update(G,H,ii),(En||Pt.receiveShadow!==G.receiveShadow)&&(Pt.receiveShadow=G.receiveShadow,ce.setValue(O,"receiveShadow",G.receiveShadow)),(B.isMeshStandardMaterial||B.isMeshLambertMaterial||B.isMeshPhongMaterial)&&B.envMap===null&&L.environment!==null&&(Ze.envMapIntensity.value=L.environmentIntensity),Ze.dfgLUT!==void 0&&(Ze.dfgLUT.value=XM()),En){if(ce.setValue(O,"toneMappingExposure",P.toneMappingExposure),Pt.needsLights&&Ox(Ze,Yn),xt&&B.fog===!0&&lt.refreshFogUniforms(Ze,xt),lt.refreshMaterialUniforms(Ze,B,_t,Ut,A.state.transmissionRenderTarget[S.id]),Pt.needsLights&&Pt.numLightProbeGrids>0){let Pe=b,Xe=0;for(let rn of A.state.lightProbeGridArray)rn.texture!==null&&(Pe.textures[Xe]=rn.texture,Pe.min[Xe]=rn.boundingBox.min,Pe.max[Xe]=rn.boundingBox.max,Pe.resolution[Xe]=rn.resolution,Xe++);for(let rn in Pe)Pe[rn].length=Xe;Ze.probesSH.value=Pe.textures,Ze.probesMin.value=Pe.min,Ze.probesMax.value=Pe.max,Ze.probesResolution.value=Pe.resolution}lr.upload(O,tp(Pt),Ze,$t)}if(B.isShaderMaterial&&B.uniformsNeedUpdate===!0&&(lr.upload(O,tp(Pt),Ze,$t),B.uniformsNeedUpdate=!1),B.isSpriteMaterial&&ce.setValue(O,"center",G.center),ce.setValue(O,"modelViewMatrix",G.modelViewMatrix),ce.setValue(O,"normalMatrix",G.normalMatrix),ce.setValue(O,"modelMatrix",G.matrixWorld),B.uniformsGroups!==void 0){let Pe=B.uniformsGroups;for(let Xe=0,rn=Pe.length;Xe<rn;Xe++){let np=Pe[Xe];Dt.update(np,ii),Dt.bind(np,ii)}}return ii}function Ox(S,L){S.ambientLightColor.needsUpdate=L,S.lightProbe.needsUpdate=L,S.sunLights.needsUpdate=L,S.sunLightShadows.needsUpdate=L,S.directionalLights.needsUpdate=L,S.directionalLightShadows.needsUpdate=L,S.pointLights.needsUpdate=L,S.pointLightShadows.needsUpdate=L,S.spotLights.needsUpdate=L,S.spotLightShadows.needsUpdate=L,S.rectAreaLights.needsUpdate=L,S.hemisphereLights.needsUpdate=L}function Ux(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return nt},this.setRenderTargetTextures=function(S,L,H){let B=Bt.get(S);B.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,B.__autoAllocateDepthBuffer===!1&&(B.__useRenderToTexture=!1),Bt.get(S.texture).__webglTexture=L,Bt.get(S.depthTexture).__webglTexture=B.__autoAllocateDepthBuffer?void 0:H,B.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,L){let H=Bt.get(S);H.__webglFramebuffer=L,H.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(S,L=0,H=0){nt=S,W=L,V=H;let B=null,G=!1,xt=!1;if(S){let pt=Bt.get(S);if(pt.__useDefaultFramebuffer!==void 0){mt.bindFramebuffer(O.FRAMEBUFFER,pt.__webglFramebuffer),et.copy(S.viewport),Et.copy(S.scissor),Gt=S.scissorTest,mt.viewport(et),mt.scissor(Et),mt.setScissorTest(Gt),X=-1;return}else if(pt.__webglFramebuffer===void 0)$t.setupRenderTarget(S);else if(pt.__hasExternalTextures)$t.rebindTextures(S,Bt.get(S.texture).__webglTexture,Bt.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let qt=S.depthTexture;if(pt.__boundDepthTexture!==qt){if(qt!==null&&Bt.has(qt)&&(S.width!==qt.image.width||S.height!==qt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(S)}}let Mt=S.texture;(Mt.isData3DTexture||Mt.isDataArrayTexture||Mt.isCompressedArrayTexture)&&(xt=!0);let Nt=Bt.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Nt[L])?B=Nt[L][H]:B=Nt[L],G=!0):S.samples>0&&$t.useMultisampledRTT(S)===!1?B=Bt.get(S).__webglMultisampledFramebuffer:Array.isArray(Nt)?B=Nt[H]:B=Nt,et.copy(S.viewport),Et.copy(S.scissor),Gt=S.scissorTest}else et.copy(Vt).multiplyScalar(_t).floor(),Et.copy(te).multiplyScalar(_t).floor(),Gt=ie;if(H!==0&&(B=$),mt.bindFramebuffer(O.FRAMEBUFFER,B)&&mt.drawBuffers(S,B),mt.viewport(et),mt.scissor(Et),mt.setScissorTest(Gt),G){let pt=Bt.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+L,pt.__webglTexture,H)}else if(xt){let pt=L;for(let Mt=0;Mt<S.textures.length;Mt++){let Nt=Bt.get(S.textures[Mt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Mt,Nt.__webglTexture,H,pt)}}else if(S!==null&&H!==0){let pt=Bt.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,pt.__webglTexture,H)}X=-1};function ip(S){let L=Bt.get(S);return(L.__readFormat!==S.format||L.__readType!==S.type)&&(L.__readFormat=S.format,L.__readType=S.type,L.__formatReadable=be.textureFormatReadable(S.format),L.__typeReadable=be.textureTypeReadable(S.type)),L}this.readRenderTargetPixels=function(S,L,H,B,G,xt,Ct,pt=0){if(!(S&&S.isWebGLRenderTarget)){Ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Mt=Bt.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Ct!==void 0&&(Mt=Mt[Ct],Array.isArray(Mt)&&(Mt=Mt[0])),Mt){mt.bindFramebuffer(O.FRAMEBUFFER,Mt);try{let Nt=S.textures[pt],qt=Nt.format,re=Nt.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+pt);let Rt=ip(Nt);if(Rt.__formatReadable===!1){Ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Rt.__typeReadable===!1){Ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=S.width-B&&H>=0&&H<=S.height-G&&O.readPixels(L,H,B,G,at.convert(qt),at.convert(re),xt)}finally{let Nt=nt!==null?Bt.get(nt).__webglFramebuffer:null;mt.bindFramebuffer(O.FRAMEBUFFER,Nt)}}},this.readRenderTargetPixelsAsync=async function(S,L,H,B,G,xt,Ct,pt=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Mt=Bt.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Ct!==void 0&&(Mt=Mt[Ct],Array.isArray(Mt)&&(Mt=Mt[0])),Mt)if(L>=0&&L<=S.width-B&&H>=0&&H<=S.height-G){mt.bindFramebuffer(O.FRAMEBUFFER,Mt);let Nt=S.textures[pt],qt=Nt.format,re=Nt.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+pt);let Rt=ip(Nt);if(Rt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Rt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ae=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,ae),O.bufferData(O.PIXEL_PACK_BUFFER,xt.byteLength,O.STREAM_READ),O.readPixels(L,H,B,G,at.convert(qt),at.convert(re),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Oe=nt!==null?Bt.get(nt).__webglFramebuffer:null;mt.bindFramebuffer(O.FRAMEBUFFER,Oe);let Me=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await Lm(O,Me,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,ae),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,xt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(ae),O.deleteSync(Me),xt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,L=null,H=0){let B=Math.pow(2,-H),G=Math.floor(S.image.width*B),xt=Math.floor(S.image.height*B),Ct=L!==null?L.x:0,pt=L!==null?L.y:0;$t.setTexture2D(S,0),O.copyTexSubImage2D(O.TEXTURE_2D,H,0,0,Ct,pt,G,xt),mt.unbindTexture()},this.copyTextureToTexture=function(S,L,H=null,B=null,G=0,xt=0){let Ct,pt,Mt,Nt,qt,re,Rt,ae,Oe,Me=S.isCompressedTexture?S.mipmaps[xt]:S.image;if(H!==null)Ct=H.max.x-H.min.x,pt=H.max.y-H.min.y,Mt=H.isBox3?H.max.z-H.min.z:1,Nt=H.min.x,qt=H.min.y,re=H.isBox3?H.min.z:0;else{let ce=Math.pow(2,-G);Ct=Math.floor(Me.width*ce),pt=Math.floor(Me.height*ce),S.isDataArrayTexture?Mt=Me.depth:S.isData3DTexture?Mt=Math.floor(Me.depth*ce):Mt=1,Nt=0,qt=0,re=0}B!==null?(Rt=B.x,ae=B.y,Oe=B.z):(Rt=0,ae=0,Oe=0);let we=at.convert(L.format),ei=at.convert(L.type),Pt;L.isData3DTexture?($t.setTexture3D(L,0),Pt=O.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?($t.setTexture2DArray(L,0),Pt=O.TEXTURE_2D_ARRAY):($t.setTexture2D(L,0),Pt=O.TEXTURE_2D),mt.activeTexture(O.TEXTURE0),mt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,L.flipY),mt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),mt.pixelStorei(O.UNPACK_ALIGNMENT,L.unpackAlignment);let li=mt.getParameter(O.UNPACK_ROW_LENGTH),fe=mt.getParameter(O.UNPACK_IMAGE_HEIGHT),jn=mt.getParameter(O.UNPACK_SKIP_PIXELS),ii=mt.getParameter(O.UNPACK_SKIP_ROWS),oo=mt.getParameter(O.UNPACK_SKIP_IMAGES);mt.pixelStorei(O.UNPACK_ROW_LENGTH,Me.width),mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Me.height),mt.pixelStorei(O.UNPACK_SKIP_PIXELS,Nt),mt.pixelStorei(O.UNPACK_SKIP_ROWS,qt),mt.pixelStorei(O.UNPACK_SKIP_IMAGES,re);let En=S.isDataArrayTexture||S.isData3DTexture,Yn=L.isDataArrayTexture||L.isData3DTexture;if(S.isDepthTexture){let ce=Bt.get(S),Ze=Bt.get(L),ki=Bt.get(ce.__renderTarget),Pe=Bt.get(Ze.__renderTarget);mt.bindFramebuffer(O.READ_FRAMEBUFFER,ki.__webglFramebuffer),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Pe.__webglFramebuffer);for(let Xe=0;Xe<Mt;Xe++)En&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Bt.get(S).__webglTexture,G,re+Xe),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Bt.get(L).__webglTexture,xt,Oe+Xe)),O.blitFramebuffer(Nt,qt,Nt+Ct,qt+pt,Rt,ae,Rt+Ct,ae+pt,O.DEPTH_BUFFER_BIT,O.NEAREST);mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(G!==0||S.isRenderTargetTexture||Bt.has(S)){let ce=Bt.get(S),Ze=Bt.get(L);mt.bindFramebuffer(O.READ_FRAMEBUFFER,R),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,F);for(let ki=0;ki<Mt;ki++)En?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ce.__webglTexture,G,re+ki):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ce.__webglTexture,G),Yn?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ze.__webglTexture,xt,Oe+ki):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ze.__webglTexture,xt),G!==0?O.blitFramebuffer(Nt,qt,Nt+Ct,qt+pt,Rt,ae,Rt+Ct,ae+pt,O.COLOR_BUFFER_BIT,O.NEAREST):Yn?O.copyTexSubImage3D(Pt,xt,Rt,ae,Oe+ki,Nt,qt,Ct,pt):O.copyTexSubImage2D(Pt,xt,Rt,ae,Nt,qt,Ct,pt);mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Yn?S.isDataTexture||S.isData3DTexture?O.texSubImage3D(Pt,xt,Rt,ae,Oe,Ct,pt,Mt,we,ei,Me.data):L.isCompressedArrayTexture?O.compressedTexSubImage3D(Pt,xt,Rt,ae,Oe,Ct,pt,Mt,we,Me.data):O.texSubImage3D(Pt,xt,Rt,ae,Oe,Ct,pt,Mt,we,ei,Me):S.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,xt,Rt,ae,Ct,pt,we,ei,Me.data):S.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,xt,Rt,ae,Me.width,Me.height,we,Me.data):O.texSubImage2D(O.TEXTURE_2D,xt,Rt,ae,Ct,pt,we,ei,Me);mt.pixelStorei(O.UNPACK_ROW_LENGTH,li),mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,fe),mt.pixelStorei(O.UNPACK_SKIP_PIXELS,jn),mt.pixelStorei(O.UNPACK_SKIP_ROWS,ii),mt.pixelStorei(O.UNPACK_SKIP_IMAGES,oo),xt===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&O.generateMipmap(Pt),mt.unbindTexture()},this.initRenderTarget=function(S){Bt.get(S).__webglFramebuffer===void 0&&$t.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?$t.setTextureCube(S,0):S.isData3DTexture?$t.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?$t.setTexture2DArray(S,0):$t.setTexture2D(S,0),mt.unbindTexture()},this.resetState=function(){W=0,V=0,nt=null,mt.reset(),ct.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=oe._getDrawingBufferColorSpace(t),e.unpackColorSpace=oe._getUnpackColorSpace()}};var Cc=class{constructor(t){this.scene=t;let{beam_member:e,beam_along:i}=t.arrays;this.row=new Map(e?[...e.data].map((s,r)=>[s,r]):[]),this.places=i?i.shape[1]:0,this.several=i?i.shape[2]:0}points(t,e){let{ends:i}=this.scene;return this.row.has(e)?this.combined("beam_along",t,this.row.get(e)):[t[i[2*e]],t[i[2*e+1]]]}across(t,e){return this.combined("beam_across",t,this.row.get(e))}combined(t,e,i){let{scene:{arrays:s},places:r,several:a}=this,{data:o}=s[t];return Array.from({length:r},(l,c)=>{let h=[0,0,0];for(let d=0;d<a;d++){let u=o[(i*r+c)*a+d],f=e[s.beam_nodes.data[i*a+d]];for(let p=0;p<3;p++)h[p]+=u*f[p]}return h})}};function Ni(n){return n.slice(1).map((t,e)=>[n[e],t])}var qM=3e4,jM=n=>[1,3,5].map(t=>parseInt(n.slice(t,t+2),16)),Rc=class{constructor(t){this.scene=t,this.corners=t.skin;let e=t.faces,i=new Se;for(let a of["position","color"])i.setAttribute(a,new De(new Float32Array(9*e),3));let s=new fi({vertexColors:!0,side:ri,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});this.mesh=new Ne(i,s),this.mesh.visible=e>0,this.edges=Fa(this.corners);let r=new Se;r.setAttribute("position",new De(new Float32Array(3*this.edges.length),3)),this.lines=new Pi(r,new ui({transparent:!0,opacity:.35}));for(let a of this.objects())a.frustumCulled=!1}objects(){return[this.mesh,this.lines]}setTheme(t){this.lines.material.color.set(qe[t].edge)}place(t){let{mesh:e,lines:i}=this;if(!e.visible)return;let s=e.geometry.attributes.position,r=i.geometry.attributes.position;this.corners.forEach((a,o)=>s.array.set(t[a],3*o)),this.edges.forEach((a,o)=>r.array.set(t[a],3*o)),s.needsUpdate=r.needsUpdate=!0,e.geometry.computeVertexNormals()}paint(t,e,i){let{scene:s,mesh:r}=this;if(!r.visible)return;let a=t&&s.coloursFaces(t.id),o=new kt,{array:l}=r.geometry.attributes.color;for(let c=0;c<s.faces;c++){let h=s.header.skins[s.arrays.skin_part.data[c]].kind,[d,u,f]=a?Rn(t.scale,s.faceValue(t.id,e,c),i):jM(ho[h]||ws);o.setRGB(d/255,u/255,f/255,"srgb");for(let p=0;p<3;p++)o.toArray(l,9*c+3*p)}r.geometry.attributes.color.needsUpdate=!0}colourOf(t){let{r:e,g:i,b:s}=new kt().fromArray(this.mesh.geometry.attributes.color.array,9*t).getRGB({r:0,g:0,b:0},"srgb");return[e,i,s].map(r=>Math.round(255*r))}};function Fa(n){let t=new Map;for(let e=0;e<n.length;e+=3)for(let i=0;i<3;i++){let s=n[e+i],r=n[e+(i+1)%3];t.set(s<r?`${s} ${r}`:`${r} ${s}`,[s,r])}return t.size>qM?[]:[...t.values()].flat()}var YM=new I(0,1,0);function Pc(n,t,e="#ffffff"){let i=new Zi(n,new fi({color:e}),Math.max(t,1));return i.count=t,i.instanceMatrix.setUsage(Au),i.frustumCulled=!1,i}function ms(n,t){return Pc(new xn(1,1,1,t,1,!1),n)}function wg(n){return Pc(new On(2,1,2),n)}function Ic(n,t,e){return Pc(new os(1,t),n,e)}function Mg(n,t,e){return Pc(new Js(1,1,t),n,e)}function Li(n,t,e,i,s){let r=n.instanceMatrix.array,a=16*t,o=i[0]-e[0],l=i[1]-e[1],c=i[2]-e[2],h=Math.hypot(o,l,c)||1e-12,d=o/h,u=l/h,f=c/h,p=0,y=-f,m=u;Math.abs(d)>.7&&([p,y,m]=[f,0,-d]);let x=s/(Math.hypot(p,y,m)||1);p*=x,y*=x,m*=x,r[a]=p,r[a+1]=y,r[a+2]=m,r[a+3]=0,r[a+4]=o,r[a+5]=l,r[a+6]=c,r[a+7]=0,r[a+8]=y*f-m*u,r[a+9]=m*d-p*f,r[a+10]=p*u-y*d,r[a+11]=0,r[a+12]=(e[0]+i[0])/2,r[a+13]=(e[1]+i[1])/2,r[a+14]=(e[2]+i[2])/2,r[a+15]=1}function Sg(n,t,e,i,s,[r,a]){let o=n.instanceMatrix.array,l=16*t,c=[i[0]-e[0],i[1]-e[1],i[2]-e[2]],h=Math.hypot(...c)||1e-12,d=c.map(m=>m/h),u=d[0]*s[0]+d[1]*s[1]+d[2]*s[2],f=s.map((m,x)=>m-u*d[x]),p=Math.hypot(...f)||1;f=f.map(m=>m/p);let y=[f[1]*d[2]-f[2]*d[1],f[2]*d[0]-f[0]*d[2],f[0]*d[1]-f[1]*d[0]];for(let m=0;m<3;m++)o[l+m]=r*f[m],o[l+4+m]=c[m],o[l+8+m]=a*y[m],o[l+12+m]=(e[m]+i[m])/2;o[l+3]=o[l+7]=o[l+11]=0,o[l+15]=1}function hr(n,t,e,i){let s=n.instanceMatrix.array,r=16*t;s.fill(0,r,r+16),s[r]=s[r+5]=s[r+10]=i,s[r+12]=e[0],s[r+13]=e[1],s[r+14]=e[2],s[r+15]=1}function Vn(n){n.instanceMatrix.needsUpdate=!0}function Ba(n){let t=new Fe,e=new fi({color:n}),i=new Ne(new xn(1,1,1,12),e),s=new Ne(new Js(1,1,16),e);return t.add(i,s),t}function dr(n,t,e,i){let s=Math.hypot(...e);if(n.visible=s>2*i,!n.visible)return;let[r,a]=n.children,o=Math.min(5*i,s/2);r.scale.set(i,s-o,i),r.position.y=(s-o)/2,a.scale.set(2.4*i,o,2.4*i),a.position.y=s-o/2,n.position.set(...t),n.quaternion.copy(new Qe().setFromUnitVectors(YM,new I(...e).normalize()))}function Ag(n,t){return new Ne(new va(n,n/5,10,32),new fi({color:t}))}function Nc({length0:n,extent:t}){return Math.max(.1*n,.04*t.size)}function wn({kind:n,along:t},e,i){let[s,r]=ZM(n,t);return cp[n].map(a=>a.map(([o,l])=>e.map((c,h)=>c+i*(o*s[h]+l*r[h]))))}function ZM(n,t){if(!t.some(Boolean))return[[1,0,0],[0,0,1]];let e=Math.hypot(t[0],t[1]),i=e>1e-9?[t[1]/e,-t[0]/e,0]:[1,0,0];return[i,n.startsWith("turn")?KM(t,i):t]}function KM(n,t){return[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]]}var Eg=Ke.driven,JM="#3f4a55",Lc=.3,QM={x:[1,0,0],y:[0,1,0],z:[0,0,1]},Dc=class{constructor(t){Object.assign(this,{scene:t,size:Nc(t)}),this.marks=t.header.support_marks,this.pointed=this.marks.filter(({kind:i})=>Tg(i));let e=this.marks.reduce((i,s)=>i+this.rodsOf(s,[0,0,0]).length,0);this.cones=Mg(this.pointed.length,4,"#ffffff"),this.rods=ms(e,6),this.mesh=new Fe,this.mesh.add(this.cones,this.rods)}rodsOf(t,e){return wn(t,e,this.size).filter((i,s)=>s>0||!Tg(t.kind)).flatMap(Ni)}feet(t){return this.marks.map(({node:e,along:i})=>this.scene.position(t,e).map((s,r)=>s-this.size*i[r]))}setTheme({support:t}){for(let e of this.mesh.children)e.material.color.set(t)}place(t){this.pointed.forEach((e,i)=>{let[[s,r,a]]=wn(e,t[e.node],this.size);Li(this.cones,i,r.map((o,l)=>(o+a[l])/2),s,.5*this.size)}),this.marks.flatMap(e=>this.rodsOf(e,t[e.node])).forEach(([e,i],s)=>Li(this.rods,s,e,i,.045*this.size)),Vn(this.cones),Vn(this.rods)}},Tg=n=>n==="pin"||n==="roller",za=class{constructor(t,e){this.scene=t,this.radius=.1*e,this.group=new Fe,this.shown=t.header.loads.map((s,r)=>({...s,k:r})).filter(s=>s.drawn!==!1),this.arrows=this.shown.map(()=>Ba(Cr));for(let s of this.arrows)this.group.add(s);let i=0;if(t.has("load_force")){let{data:s}=t.arrays.load_force;for(let r=0;r<s.length;r+=t.dim)i=Math.max(i,Math.hypot(...s.slice(r,r+t.dim)))}this.factor=i?.16*t.extent.size/i:0}tips(t){return this.shown.map(e=>{let i=this.scene.vector("load_force",t,e.k),s=(e.pressure?Lc:1)*this.factor;return this.scene.placeOfLoad(e,r=>this.scene.position(t,r)).map((r,a)=>e.at?r-s*i[a]:r+s*i[a])})}place(t,e){this.shown.forEach((i,s)=>{let r=i.pressure?Lc:1,a=this.scene.vector("load_force",e,i.k).map(l=>r*l*this.factor),o=this.scene.placeOfLoad(i,l=>t[l]);dr(this.arrows[s],i.at?o.map((l,c)=>l-a[c]):o,a,r*this.radius)})}},kc=class{constructor(t,e){this.scene=t,this.size=e,this.group=new Fe,this.shown=t.header.drives.filter(i=>i.kind!=="length").map(i=>{let s=i.kind==="coordinate"?Ba(Eg):Ag(.75*e,Eg);return this.group.add(s),{drive:i,mark:s}})}place(t){for(let{drive:e,mark:i}of this.shown)e.kind==="angle"?Cg(i,t[this.scene.ends[2*e.member]],e.about):e.kind==="hinge"?Cg(i,...tS(e.axis.map(s=>t[s]))):dr(i,t[e.node],QM[e.axis].map(s=>2.5*this.size*s),.15*this.size)}};function tS([n,t]){return t?[n.map((e,i)=>(e+t[i])/2),t.map((e,i)=>e-n[i])]:[n,[0,0,1]]}function Cg(n,t,e=[0,0,1]){n.position.set(...t),n.quaternion.setFromUnitVectors(new I(0,0,1),new I(...e).normalize())}var Oc=class{constructor(t,e,i){this.scene=t,this.triangles=e;let s=new Se;s.setAttribute("position",new De(new Float32Array(9*e.length),3));let r=new fi({color:"#7f93a8",side:ri,transparent:!0,opacity:i,depthWrite:!1});this.mesh=new Ne(s,r),this.mesh.frustumCulled=!1}place(t){let{array:e}=this.mesh.geometry.attributes.position;this.triangles.forEach((i,s)=>{i.forEach((r,a)=>e.set(t[r],9*s+3*a))}),this.mesh.geometry.attributes.position.needsUpdate=!0,this.mesh.geometry.computeVertexNormals()}};function qu(n,{member:t,center:e},i){let s=i[n.ends[2*t]],r=i[n.ends[2*t+1]],a=Math.hypot(r[0]-s[0],r[1]-s[1])||1,o=[(r[0]-s[0])/a,(r[1]-s[1])/a];return[s,r,[s[0]+e[0]*o[0]-e[1]*o[1],s[1]+e[0]*o[1]+e[1]*o[0],0]]}var Uc=class{constructor(t,e){this.scene=t,this.size=e,this.mesh=Ic(t.header.bodies.length,2,JM)}place(t){this.scene.header.bodies.forEach((e,i)=>hr(this.mesh,i,qu(this.scene,e,t)[2],this.size)),Vn(this.mesh)}};function Rg(n){let{low:t,high:e,centre:i,size:s}=n.extent,r=Kn(s/8),a=Math.max(4,Math.ceil(.75*s/r)),o=new Sa(2*a*r,2*a,"#8a949e","#8a949e");o.material.transparent=!0,o.material.opacity=.35;let l=c=>Math.round(c/r)*r;return n.dim===2?(o.rotation.x=Math.PI/2,o.position.set(l(i[0]),l(i[1]),-.08*n.length0)):(o.quaternion.copy(new Qe().setFromUnitVectors(new I(0,1,0),new I(0,0,1))),o.position.set(l(i[0]),l(i[1]),t[2]-.03*(e[2]-t[2]||s))),{grid:o,step:r}}function Pg(n){let t=n.nodes.map((r,a)=>n.position(0,a)),i=[...n.members.flatMap((r,a)=>n.shows(a)?Ni(n.curves.points(t,a)).flat():[]),...Fa(n.skin).map(r=>t[r])].flat(),s=new Pi(ju(i),new ui({color:"#8a949e",transparent:!0,opacity:.8}));return s.frustumCulled=!1,s}function ju(n){let t=new Se;return t.setAttribute("position",new De(new Float32Array(n),3)),t}var eS=9,iS=22,Fc={corner:[.72,-1,.42],front:[0,-1,0],side:[1,0,0],top:[0,-1e-4,1],plane:[0,0,1]},ur=class{constructor(t,e){Object.assign(this,{canvas:t,scene:e,frame:0,channel:null,limits:[0,1],picked:null})}points(){let{scene:t,frame:e,mode:i}=this;return t.nodes.map((s,r)=>{let a=t.position(e,r);if(!i)return a;let o=t.arrays[i.array].data,l=r*t.dim;for(let c=0;c<t.dim;c++)a[c]+=i.size*o[l+c];return a})}setFrame(t){this.frame=t,this.move(),this.paint()}setColours(t,e){Object.assign(this,{channel:t,limits:e}),this.paint()}get plain(){return!this.channel||!this.scene.channel(this.channel.id)}shade(t){let{scene:e,channel:i,frame:s,limits:r}=this;return this.plain?Ms(Ke[e.header.kinds[t]]):Rn(i.scale,e.value(i.id,s,t),r)}hatched(t){let{scene:e,channel:i,frame:s}=this;return!this.plain&&i.id!=="speed"&&(e.unsure.has(t)||Number.isNaN(e.value(i.id,s,t)))}request(){this.waiting||=requestAnimationFrame(()=>this.render())}along(t,e){let{curves:i,ends:s}=this.scene;return i.row.has(t)?i.points(this.now,t).map(r=>this.project(r)):[e[s[2*t]],e[s[2*t+1]]]}pickAt(t,e,i=!1){let s=this.now.map(l=>this.project(l)),r=i?iS:eS,a=null,o=(l,c,h,d,u)=>{let f=d+1e-4*h-u;h<=r&&d<1&&(!a||f<a.far)&&(a={type:l,index:c,far:f})};return this.scene.members.forEach((l,c)=>{if(this.scene.shows(c))for(let[h,d]of Ni(this.along(c,s))){let[u,f]=[d[0]-h[0],d[1]-h[1]],p=Math.min(1,Math.max(0,((t-h[0])*u+(e-h[1])*f)/(u*u+f*f||1)));o("member",c,Math.hypot(h[0]+p*u-t,h[1]+p*f-e),h[2]+p*(d[2]-h[2]),0)}}),s.forEach((l,c)=>this.scene.directors.has(c)||o("node",c,Math.hypot(l[0]-t,l[1]-e),l[2],.002)),a&&{type:a.type,index:a.index}}};var fr=class{constructor(t){this.scene=t,this.group=new Fe,this.lines=new Map,this.material=new ui({})}setTheme({ink:t}){this.material.color.set(t)}show(t){for(let[e,i]of this.lines)i.visible=t.has(e);for(let e of t)this.lines.has(e)||this.add(e)}add(t){let{scene:e}=this,i=new Ks(ju(Array.from({length:e.frames},(s,r)=>e.position(r,t)).flat()),this.material);i.frustumCulled=!1,this.lines.set(t,i),this.group.add(i)}get shown(){return[...this.lines].filter(([,t])=>t.visible).map(([t])=>t)}};function Bc(n){let t=new Set([...n.header.supports.map(i=>i.node),...n.skin,...n.directors]),e=[];for(let i=0;i<n.nodes.length;i++){if(t.has(i))continue;let s=n.position(0,i);for(let r=1;r<n.frames;r++)if(Math.hypot(...n.position(r,i).map((o,l)=>o-s[l]))>1e-4*n.extent.size){e.push(i);break}}return e}var zc=()=>({visible:!0}),Vc=class extends ur{constructor(t,e,i){super(t,e),this.step=Kn(e.extent.size/8),this.traces=new fr(e),Object.assign(this,{ghost:{visible:!1},grid:zc(),loads:{group:zc()},supports:{mesh:zc()},faces:{mesh:zc()}}),this.controls={update(){}},this.setTheme(i),this.aim(e.dim===2?"plane":"corner"),this.setFrame(0)}setTheme(t){this.colours=qe[t],this.request()}move(){this.now=this.points(),this.request()}paint(){this.request()}pick(t){this.picked=t,this.request()}showTraces(t){this.paths=t,this.request()}rebuildLoads(){this.request()}aim(t){this.preset=t;let e=Fc[t],i=Math.hypot(...e),s=e.map(a=>a/i),r=Math.abs(s[2])>.99?[0,1,0]:[0,0,1];this.turn(s,r),this.zoom=1}turn(t,e){let i=[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],s=Math.hypot(...i)||1,r=i.map(a=>a/s);this.axes=[r,[t[1]*r[2]-t[2]*r[1],t[2]*r[0]-t[0]*r[2],t[0]*r[1]-t[1]*r[0]],t],this.request()}orbit(t,e,i){let[,,s]=this.axes,r=Math.hypot(s[0],s[1])||1e-6,a=Math.atan2(s[1],s[0])+t,o=Math.min(Math.max(Math.atan2(s[2],r)+e,-1.5),1.5);(t||e)&&this.turn([Math.cos(a)*Math.cos(o),Math.sin(a)*Math.cos(o),Math.sin(o)],[0,0,1]),this.zoom/=i,this.request(),this.onCamera?.(this)}copyCamera(t){t.axes&&Object.assign(this,{axes:t.axes,zoom:t.zoom}),this.request()}resize(){this.request()}end(){this.ended=!0}project(t){let{clientWidth:e,clientHeight:i}=this.canvas,{centre:s,size:r}=this.scene.extent,[a,o,l]=this.axes.map(h=>h.reduce((d,u,f)=>d+u*(t[f]-s[f]),0)),c=.86*this.zoom*Math.min(e,i)/r;return[e/2+c*a,i/2-c*o,.5-l/(4*r)]}render(){cancelAnimationFrame(this.waiting),this.waiting=0;let{clientWidth:t,clientHeight:e}=this.canvas,i=window.devicePixelRatio||1;if(this.ended||!t||!e)return;this.canvas.width=Math.round(t*i),this.canvas.height=Math.round(e*i);let s=this.canvas.getContext("2d"),{scene:r,colours:a}=this;s.scale(i,i),s.fillStyle=a.back,s.fillRect(0,0,t,e),s.lineCap="round";let o=this.now.map(l=>this.project(l));this.ghost.visible&&this.bars(s,r.nodes.map((l,c)=>r.position(0,c)),()=>a.grid,1);for(let l of this.paths||[])Gc(s,Array.from({length:r.frames},(c,h)=>this.project(r.position(h,l))),a.ink,1);this.skins(s,o),this.bars(s,this.now,()=>a.outline,6),this.bars(s,this.now,l=>`rgb(${this.shade(l).join(" ")})`,4),this.bars(s,this.now,l=>this.hatched(l)?a.back:null,4,[3,6]),this.bars(s,this.now,l=>this.picked?.type==="member"&&this.picked.index===l?"#ffb000":null,3),this.marks(s,o),this.drawn=(this.drawn||0)+1,this.onDrawn?.(this)}skins(t,e){let{scene:i,channel:s,frame:r,limits:a,colours:o}=this,l=s&&i.coloursFaces(s.id),c=u=>l?`rgb(${Rn(s.scale,i.faceValue(s.id,r,u),a).join(" ")})`:o.body,h=Array.from({length:i.faces},(u,f)=>({corners:[...i.skin.slice(3*f,3*f+3)].map(p=>e[p]),fill:c(f)}));h.push(...(i.header.solids||[]).map(u=>({corners:u.map(f=>e[f]),fill:o.body})));for(let u of i.header.bodies)h.push({corners:qu(i,u,this.now).map(f=>this.project(f)),fill:o.body});let d=({corners:u})=>u.reduce((f,p)=>f+p[2],0)/u.length;t.strokeStyle=o.edge,t.lineWidth=.3,t.lineJoin="round";for(let{corners:u,fill:f}of h.sort((p,y)=>d(y)-d(p))){t.beginPath();for(let[p,y]of u)t.lineTo(p,y);t.closePath(),t.fillStyle=f,t.fill(),t.stroke()}}bars(t,e,i,s,r=[]){let{scene:a}=this;a.members.forEach((o,l)=>{let c=a.shows(l)&&i(l);c&&Gc(t,a.curves.points(e,l).map(h=>this.project(h)),c,s,r)})}marks(t,e){let{scene:i,colours:s}=this,r=([a,o],l,c)=>{t.beginPath(),t.arc(a,o,l,0,7),t.fillStyle=c,t.fill()};if(this.supports.mesh.visible)for(let a of i.header.support_marks)for(let o of wn(a,this.now[a.node],Nc(i)))Gc(t,o.map(l=>this.project(l)),s.support,1.5);i.members.length<800&&e.forEach((a,o)=>!i.directors.has(o)&&r(a,this.picked?.type==="node"&&this.picked.index===o?6:3,s.node));for(let a of i.header.drives){let o=a.kind==="coordinate"?a.node:a.kind==="hinge"?a.axis[0]:i.ends[2*a.member];r(a.kind==="length"?nS(e,i,a.member):e[o],5,Ke.driven)}this.loads.group.visible&&i.has("load_force")&&this.arrows(t)}arrows(t){let{scene:e,frame:i}=this,s=e.header.loads.map((a,o)=>Math.hypot(...e.vector("load_force",i,o))),r=Math.max(...s,1e-30);e.header.loads.forEach((a,o)=>{if(a.drawn===!1||s[o]<.001*r)return;let l=e.vector("load_force",i,o),c=e.placeOfLoad(a,p=>this.now[p]),h=(a.pressure?Lc:1)*.16*e.extent.size,d=a.at?c.map((p,y)=>p-h*l[y]/r):c,[u,f]=[d,d.map((p,y)=>p+h*l[y]/r)].map(p=>this.project(p));Gc(t,[u,f],Cr,2),t.fillStyle=Cr,t.fillRect(f[0]-3,f[1]-3,6,6)})}};function nS(n,t,e){let[i,s]=[n[t.ends[2*e]],n[t.ends[2*e+1]]];return[(i[0]+s[0])/2,(i[1]+s[1])/2]}function Gc(n,t,e,i,s=[]){n.strokeStyle=e,n.lineWidth=i,n.setLineDash(s),n.beginPath();for(let[r,a]of t)n.lineTo(r,a);n.stroke(),n.setLineDash([])}var Wc=320,Va=160,Ga=66,Hc=254,pr=62,sS={F_A:"var(--pen-1)",F_B:"var(--pen-1)","m g":"var(--pen-3)","m a":"var(--pen-2)",T:"var(--pen-3)",Q:"var(--pen-3)",P:"var(--pen-3)",B:"var(--pen-3)"};function Ig(n,t){let e=Math.max(...t.terms.map(h=>Math.hypot(...h.force)))||1,i=h=>Math.max(...t.terms.map(d=>Math.abs(d.force[h]))),s=i(2)>i(1)?2:1,r=i(s),a=38/e,o=r>.02*e?a:Math.min(a*20,r?26/r:a),l=h=>Ga+h/t.state.L*(Hc-Ga),c=ht("svg",{viewBox:`0 0 ${Wc} ${Va}`,role:"img","aria-label":"free body of the member"});c.append(ht("line",{x1:Ga,y1:pr,x2:Hc,y2:pr,class:"rod"}),...[Ga,Hc].map(h=>ht("circle",{cx:h,cy:pr,r:4,class:"joint"})),Yu(Ga,Va-24,`end A: ${n.nodes[t.state.A]}`),Yu(Hc,Va-24,`end B: ${n.nodes[t.state.B]}`),Yu(Wc/2,Va-7,`plane 1–${s+1}${r>1e-6*e&&o>1.01*a?`, across × ${Kt(o/a,2)}`:""}`,"faint"));for(let h of t.drives)c.append(...rS(h,t,l));t.couples.forEach((h,d)=>c.append(...aS(h,d,l)));for(let h of t.terms)oS(c,l(h.at),h,[h.force[0]*a,-h.force[s]*o]);return c}function rS(n,t,e){let i=t.state.rods[1],s=e(i?i.start:t.state.L/2);return[ht("rect",{x:s-4,y:pr-7,width:8,height:14,rx:2,fill:"var(--pen-3)"}),...Ng(`thrust of ${n.name}: ${St(n.force,"N")}`,0)]}function aS(n,t,e){return[ht("circle",{cx:e(n.at),cy:pr,r:10+3*t,fill:"none",stroke:"var(--pen-3)","stroke-width":3}),...Ng(`couple of ${n.words}: ${St(n.size,"N m")}`,t)]}function Ng(n,t){return[ht("text",{x:Wc/2,y:12+12*t,"text-anchor":"middle",fill:"var(--pen-3)"},n)]}function Yu(n,t,e,i=""){return ht("text",{x:n,y:t,"text-anchor":"middle",class:i},e)}function oS(n,t,e,[i,s]){let r=Math.hypot(i,s);if(r<3)return;let a=e.symbol==="F_A"&&i>0||e.symbol==="F_B"&&i<0,o=pr+(e.inertia?10:0),[l,c]=a?[t-i,o-s]:[t,o],[h,d]=[l+i,c+s],u=i/r,f=s/r,p=Math.min(9,r),y=[[h,d],[h-p*u-.4*p*f,d-p*f+.4*p*u],[h-p*u+.4*p*f,d-p*f-.4*p*u]],m=sS[e.symbol],[x,_]=a?[l-14*u,c-12*f]:[h+14*u,d+12*f];n.append(ht("line",{x1:l,y1:c,x2:h-.7*p*u,y2:d-.7*p*f,stroke:m,"stroke-width":2.4,"stroke-dasharray":e.inertia?"4 3":"none"}),ht("polygon",{points:y.map(w=>w.join(",")).join(" "),fill:m}),ht("text",{x:Math.min(Wc-14,Math.max(14,x)),y:Math.min(Va-36,Math.max(11,_+4.5)),"text-anchor":"middle",fill:m},e.symbol))}function Lg(n,t){let e=Math.max(...t.terms.map(a=>Math.hypot(...a.force))),i=n.dim===3?[0,1,2]:[0,1],[s,r]=an(t.terms.flatMap(a=>i.map(o=>Math.abs(a.force[o])<1e-6*e?0:a.force[o])),"N");return g("table",{class:"numbers"},g("thead",{},g("tr",{},g("th",{},`force (${r})`),i.map(a=>g("th",{},`along ${a+1}`)))),g("tbody",{},t.terms.map((a,o)=>g("tr",{title:a.words},g("th",{},a.symbol,g("small",{},` ${a.words}`)),i.map(l=>g("td",{},s[o*i.length+l])))),t.couples.map(a=>g("tr",{},g("th",{},"couple ",g("small",{},a.words)),g("td",{colspan:i.length},St(a.size,"N m")))),t.drives.map(a=>g("tr",{},g("th",{},"drive ",g("small",{},a.name)),g("td",{colspan:i.length},St(a.force,"N"))))))}function kg(n,t,e,i,s,r){if(n===0)return Math.sqrt(lS(Math.abs(t),e,i,s,r));if(n===1)return Math.sqrt(hS(Math.abs(t),Math.abs(e),Math.abs(i),s,r));if(n===2){let a=Math.abs(t)+Math.abs(e)+Math.abs(i);return Math.sqrt(a*a+3*(s*s+r*r))}return NaN}function lS(n,t,e,i,s){let r=Math.hypot(t,e),a=3*(i*i+s*s);if(r===0||a===0)return(n+r)**2+a;let o=(s*t-i*e)/r,l=(i*t+s*e)/r,c=f=>(n+r*Math.cos(f))**2+3*(o*Math.sin(f)+l*Math.cos(f))**2,h=2*Math.PI/48,d=0,u=0;for(let f=0;f<48;f++)c(f*h)>d&&([d,u]=[c(f*h),f*h]);return Math.max(d,c(cS(c,u,h)))}function cS(n,t,e){let i=(Math.sqrt(5)-1)/2,s=t-e,r=t+e;for(let a=0;a<40;a++){let o=r-i*(r-s),l=s+i*(r-s);n(o)>n(l)?r=l:s=o}return(s+r)/2}function hS(n,t,e,i,s){let r=0;for(let a=0;a<4;a++){let o=a&1,l=a>>1;for(let h=0;h<20;h++)o=Dg(n+t*l,e,i),l=Dg(n+e*o,t,s);let c=(i*(1-o*o))**2+(s*(1-l*l))**2;r=Math.max(r,(n+e*o+t*l)**2+3*c)}return r}function Dg(n,t,e){let i=12*e*e;if(2*t*t>=i)return 1;let s=0;for(let r=0;r<60;r++){let a=i*s**3+(2*t*t-i)*s+2*n*t,o=3*i*s*s+2*t*t-i;if(a<=0)break;if(o>=0||s>=1)return 1;let l=-a/o;if(s+=l,l<1e-12)break}return s>=1?1:(n+t*s)**2+i/4*(1-s*s)**2>(n+t)**2?s:1}var Te=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],Ce=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],Wt=(n,t)=>[n*t[0],n*t[1],n*t[2]],Ku=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Zu=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],dS=n=>Wt(1/(Math.hypot(...n)||1),n);function Xa(n,t,e){let i=n.ends[2*e],s=n.ends[2*e+1],r=n.position(t,i),a=Ce(n.position(t,s),r),o=Math.hypot(...a),l=Wt(1/o,a);if(n.dim===2)return{A:i,B:s,L:o,xA:r,axes:[l,[-l[1],l[0],0],[0,0,1]]};let c=n.arrays.orient.data[e],h=c>=0?Ce(n.position(t,c),r):[...n.arrays.reference.data.slice(3*e,3*e+3)],d=Zu(l,h);if(Ku(d,d)<=1e-18*Ku(h,h)){let u=[0,1,2].reduce((f,p)=>Math.abs(l[p])<Math.abs(l[f])?p:f,0);d=Zu(l,[0,1,2].map(f=>f===u?1:0))}return d=dS(d),{A:i,B:s,L:o,xA:r,axes:[l,Zu(d,l),d]}}function Ug(n,t,e){let i=Xa(n,t,e),s=x=>i.axes.map(_=>Ku(_,x)),r=[0,1,2].map(x=>n.header.gravity[x]||0),a=n.vector("acceleration",t,i.A),o=n.vector("acceleration",t,i.B),l=s(Ce(n.vector("velocity",t,i.B),n.vector("velocity",t,i.A))),c=s(Ce(a,r)),h=s(Ce(o,a)),d=i.L,u=[l[1]/d,l[2]/d],f=[-(u[0]**2+u[1]**2),(h[1]-2*l[0]*u[0])/d,(h[2]-2*l[0]*u[1])/d],p=fS(n,e,d),y=uS(n,t,e,d,s),m=pS(n,t,e,{...i,local:s,b:c,e:h,bend:f,rods:p,actions:y});return{...i,member:e,frame:t,gravity:r,local:s,b:c,e:h,bend:f,rods:p,actions:y,FA:m[0],FB:m[1],derived:m[2]}}function uS(n,t,e,i,s){return(n.header.actions||[]).flatMap((r,a)=>{if(r.member!==e)return[];let[o,l]=[0,1].map(u=>s(n.actionForce(t,a,u))),c=Te(o,l),h=r.spread?.5:n.number("action_place",t,a),d=Ce(l,Wt(h,c));return[{...r,fA:o,fB:l,force:c,place:h,couple:[0,-i*d[2],i*d[1]],whole:[0,-i*l[2],i*l[1]]}]})}function fS(n,t,e){let i=n.arrays.rods.data,s=6*t,r={mass:i[s],rotary:i[s+2],start:0,length:e,role:"bar",masses:[]};if(!n.active.has(t))return[r];let a=o=>(n.header.clamped||[]).filter(l=>l.rod===o);return[{...r,length:i[s+1],role:"base",masses:a(2*t)},{mass:i[s+3],rotary:i[s+5],start:e-i[s+4],length:i[s+4],role:"tube",masses:a(2*t+1)}]}function Wa({first:n,change:t},e){return Wt(e.mass,Te(n,Wt(e.place,t)))}function Xc(n,t){let{b:e,e:i,bend:s}=n;return t.role==="bar"?{first:e,change:i}:t.role==="base"?{first:e,change:Wt(t.length,s)}:{first:Ce(Te(e,i),Wt(t.length,s)),change:Wt(t.length,s)}}function pS(n,t,e,i){if(n.has("joint_force"))return[0,1].map(h=>i.local(n.jointForce(t,e,h))).concat(!1);let s=i.actions.filter(h=>h.mean).reduce((h,d)=>h-d.fA[0]+(1-d.place)*d.force[0],n.number("member_force",t,e)),r=[0,0,0],a=[0,0,0],o=i.rods.map(h=>{let d=Xc(i,h),{first:u,change:f}=d,p=h.masses.reduce((x,_)=>Te(x,Wa(d,_)),Wt(h.mass,Te(u,Wt(.5,f))));r=Te(r,p);let y=i.L-h.start,m=Te(Wt(y-h.length/2,u),Wt(y/2-h.length/3,f));a=Te(a,Ce(Wt(h.mass,m),Wt(h.rotary,i.bend)));for(let x of h.masses)a=Te(a,Wt(y-x.place*h.length,Wa(d,x)));return{push:p,change:f,mass:h.mass}}),l=Wt(1/i.L,a);l[0]=i.rods.length===2?o[0].push[0]-s:o[0].mass*(i.b[0]/2+i.e[0]/6)-s;let c=h=>i.actions.reduce((d,u)=>Te(d,u[h]),[0,0,0]);return[Ce(l,c("fA")),Ce(Ce(r,l),c("fB")),!0]}function qc(n,t,e){let i=Ug(n,t,e),s=i.rods.map((r,a)=>{let{first:o,change:l}=Xc(i,r),c=Wt(r.mass,o),h=Wt(r.mass/2,l),d=Wt(-1,i.FA),u=p=>i.actions.filter(y=>y.place===p).reduce((y,m)=>Te(y,m.couple),[0,0,0]),f;if(r.role==="bar")f=mS(i,r,c,h,d);else if(r.role==="tube")f=Og(i,r,r.masses,Ce(Ce(i.FB,c),h),c,h,u(1),0);else{let p=(i.L-i.rods[1].length)/r.length,y=d,m=Wt(-1,u(0));f=[];for(let _ of r.masses.filter(w=>w.place<p)){let w=_.place,b=Wa({first:o,change:l},_);w>0&&f.push($a(y,c,h,r,i.bend,m,!1,w)),y=Te(y,b),m=Te(m,[0,-r.length*b[2]*w,r.length*b[1]*w])}f.push({...$a(y,c,h,r,i.bend,m,!1,p),nut:!0});let x=r.masses.filter(_=>_.place>=p);f.push(...Og(i,r,x,Ce(Wt(-1,c),h),c,h,[0,0,0],p))}return{part:n.partsOf[e][a],...r,pieces:f}});return s.length===2&&vS(i,s),{state:i,parts:s}}function Og(n,t,e,i,s,r,a,o){let l=Xc(n,t),c=[],h=(d,u)=>[0,t.length*d[2]*(1-u),-t.length*d[1]*(1-u)];for(let d of e){let u=Wa(l,d);i=Ce(i,u),a=Ce(a,h(u,d.place))}for(let d of e){let u=d.place,f=Wa(l,d);u>o&&c.push($a(i,s,r,t,n.bend,a,!0,u)),i=Te(i,f),a=Te(a,h(f,u))}return c.push($a(i,s,r,t,n.bend,a,!0,2)),c}function mS(n,t,e,i,s){let r=n.actions.flatMap(({spread:o,place:l})=>o?[o.begin,o.end]:[l]),a=[...new Set(r.filter(o=>o>0&&o<1))].sort((o,l)=>o-l);return[...a,2].map((o,l)=>{let c=l?a[l-1]:0,h=$a(s,e,i,t,n.bend,[0,0,0],!1,o);for(let d of n.actions)d.spread?d.spread.end<=c?Ha(h,t,yS(d)):d.spread.begin<=c&&Ha(h,t,$c(d,0,1)):d.place<=c&&d.place<1&&Ha(h,t,gS(d));return h})}var gS=({force:n,place:t,couple:e})=>({D:[n],P:[Wt(-t,n),n],C:[e]});function xS({spread:{begin:n,end:t,ratio:e},fA:i,fB:s,force:r}){let a=t-n;if(e)return[Wt((e[0]-(e[1]-e[0])*n/a)/a,r),Wt((e[1]-e[0])/(a*a),r)];let o=Wt(1/a,Ce(s,Wt(n,r))),l=Ce(Wt(4,r),Wt(6,o)),c=Ce(Wt(12,o),Wt(6,r));return[Wt(1/a,Ce(l,Wt(n/a,c))),Wt(1/(a*a),c)]}function $c(n,t,e){let{begin:i,couple:s}=n.spread,r=Math.max(i,t),a=(r-t)/e,[o,l]=xS(s?{...n,force:n.whole}:n),c=u=>Te(Wt(u,o),Wt(u*u/2,l)),h=[Ce(c(t),c(r)),Te(Wt(e,o),Wt(e*t,l)),Wt(e*e/2,l)];if(s)return{D:[],P:[],C:h};let d=[[0,0,0],h[0],Wt(1/2,h[1]),Wt(1/3,h[2])];return d[0]=Wt(-1,d.reduce((u,f,p)=>Te(u,Wt(a**p,f)),[0,0,0])),{D:h,P:d,C:[]}}function yS(n){if(n.spread.couple)return{D:[],P:[],C:[n.whole]};let{P:t}=$c(n,0,1),e=n.spread.end,i=t.reduce((s,r,a)=>Te(s,Wt(e**a,r)),[0,0,0]);return{D:[n.force],P:[Ce(i,Wt(e,n.force)),n.force],C:[]}}function Ha(n,t,{D:e,P:i,C:s}){e.forEach((r,a)=>n.S[a]=Ce(n.S[a],r)),i.forEach((r,a)=>{n.M[0][a]-=t.length*r[2],n.M[1][a]+=t.length*r[1]}),s.forEach((r,a)=>[1,2].forEach(o=>n.M[o-1][a]-=r[o]))}function vS(n,t){for(let e of n.actions.filter(({spread:i})=>i)){let[i,s]=t,r=Math.max(0,s.start/n.L);for(let d of i.pieces)if(Ha(d,i,$c(e,0,i.length/n.L)),d.nut)break;let{D:a,P:o}=$c(e,r,s.length/n.L),[l,c]=[a,o].map(d=>d.reduce((u,f)=>Te(u,f),[0,0,0])),h={D:[Ce(a[0],l),...a.slice(1)],P:o.map((d,u)=>Te(d,u===0?Ce(l,c):u===1?Wt(-1,l):[0,0,0])),C:[]};for(let d of s.pieces)Ha(d,s,h)}}function $a(n,t,e,i,s,r,a,o){let l=i.length,c=[r[1],l*n[2]-i.rotary*s[2],l*t[2]/2,l*e[2]/3],h=[r[2],i.rotary*s[1]-l*n[1],-l*t[1]/2,-l*e[1]/3];return a&&(c[0]-=c[1]+c[2]+c[3],h[0]-=h[1]+h[2]+h[3]),{S:[n,t,e],M:[c,h],end:o}}function jc(n,t,e){let{S:i,M:s}=t.pieces.find(u=>e<=u.end),[r,a,o]=[0,1,2].map(u=>i[0][u]+e*(i[1][u]+e*i[2][u])),[l,c]=s.map(u=>u[0]+e*(u[1]+e*(u[2]+e*u[3]))),h=n.arrays.part_scale.data.slice(4*t.part,4*t.part+4),d=n.arrays.part_shape.data[t.part];return{T:r,V2:a,V3:o,M2:l,M3:c,stress:kg(d,r*h[0],l*h[1],c*h[2],a*h[3],o*h[3])}}function Yc(n,t,e){let i=Ug(n,t,e),s=i.local(i.gravity),r=[0,0,0],a=[0,0,0],o=0,l=0;for(let p of i.rods){let y=Xc(i,p);for(let{mass:m,place:x}of[{mass:p.mass,place:.5},...p.masses])r=Te(r,Wt(m,s)),a=Te(a,Wt(m,Te(Te(y.first,Wt(x,y.change)),s))),o+=m*(p.start+x*p.length),l+=m}let c=l>0?o/l:i.L/2,h=[{symbol:"F_A",words:`joint ${n.nodes[i.A]} on it`,force:i.FA,at:0},{symbol:"F_B",words:`joint ${n.nodes[i.B]} on it`,force:i.FB,at:i.L},{symbol:"m g",words:"weight",force:r,at:c},{symbol:"m a",words:"inertia: what they sum to",force:a,at:c,inertia:!0}],d=Math.max(...i.FA.map(Math.abs),...i.FB.map(Math.abs),1e-30),u=i.actions.filter(p=>Math.max(...p.force.map(Math.abs))>1e-6*d);h.splice(2,0,...u.map(p=>({symbol:_S[p.kind],words:`${p.kind} ${p.source}`,force:p.force,at:p.place*i.L})));let f=i.actions.filter(p=>Math.hypot(...p.couple)>1e-6*d*i.L).map(p=>({words:`${p.kind} ${p.source}`,at:p.place*i.L,couple:p.couple,size:n.dim===2?p.couple[2]:Math.hypot(...p.couple)}));return{state:i,mass:l,centre:c,terms:h,couples:f,drives:Ju(n,t,e).filter(p=>p.unit==="m")}}var _S={drive:"T",coupling:"Q",load:"P",body:"B",friction:"C",spring:"K",bearing:"C",hub:"H",couple:"C",hinge:"C"};function Ju(n,t,e){return Bg(n,t,i=>i.member===e)}function Fg(n,t,e){return Bg(n,t,i=>i.node===e||i.axis?.includes?.(e)===!0)}function Bg(n,t,e){return n.header.drives.flatMap((i,s)=>{if(!e(i))return[];let r=a=>n.has(a)?n.number(a,t,s):NaN;return[{...i,position:r("drive_position"),force:r("drive_force")}]})}var Ai={left:52,right:10,top:18,bottom:18},zg=Object.fromEntries(Object.entries(qe).map(([n,t])=>[n,[1,2,3].map(e=>t[`pen-${e}`])]));function Di(n,t,e={}){let i=window.devicePixelRatio||1,s=n.clientWidth||300,r=n.clientHeight||110;n.width=Math.round(s*i),n.height=Math.round(r*i);let a=n.getContext("2d");a.scale(i,i);let o=getComputedStyle(n),l=o.color,c=o.getPropertyValue("--line").trim()||"#ccc",h=o.getPropertyValue("--dark").trim()==="1"?"dark":"light",d=bS(t,e,s,r);return a.font="11px system-ui, sans-serif",wS(a,d,e,l,c),t.forEach((u,f)=>MS(a,d,u,zg[h][f%3],e.fill)),Number.isFinite(e.limit)&&AS(a,d,e.limit,h==="dark"?qe.dark.alarm:Tn),e.cursor!==void 0&&ES(a,d,e.cursor,l),TS(a,d,t,zg[h],l),d}function bS(n,t,e,i){let[s,r,a,o]=[1/0,-1/0,0,0];for(let{x:p,y}of n)for(let m=0;m<p.length;m++)p[m]<s&&(s=p[m]),p[m]>r&&(r=p[m]),y[m]<a&&Number.isFinite(y[m])&&(a=y[m]),y[m]>o&&Number.isFinite(y[m])&&(o=y[m]);let l=Math.max(Math.abs(a),Math.abs(o));Number.isFinite(t.limit)&&t.limit<2.5*l&&(o=Math.max(o,t.limit)),(o-a<1e-12*(l||1)||a===o)&&([a,o]=[Math.min(a,-1e-9),Math.max(o,1e-9)]);let c=.06*(o-a);a<0&&(a-=c),o>0&&(o+=c);let[h,d]=Cn(l,t.unit||""),u=e-Ai.left-Ai.right,f=i-Ai.top-Ai.bottom;return{x0:s,x1:r,y0:a,y1:o,largest:l,factor:h,unit:d,width:e,height:i,x:p=>Ai.left+(p-s)/(r-s||1)*u,y:p=>Ai.top+(1-(p-a)/(o-a))*f}}function wS(n,t,e,i,s){n.strokeStyle=s,n.fillStyle=i,n.lineWidth=1;let[r,a]=[Ai.left,t.width-Ai.right];n.textAlign="right",n.textBaseline="middle";let{factor:o}=t;for(let h of t.largest?gd(t.y0*o,t.y1*o,4):[0]){let d=Math.round(t.y(h/o))+.5;n.beginPath(),n.moveTo(r,d),n.lineTo(a,d),n.stroke(),n.fillText(Kt(h),r-5,d)}n.textBaseline="alphabetic",n.textAlign="center";let l=` ${e.xUnit||"s"}`,c=n.measureText(l).width;for(let h of gd(t.x0,t.x1,5)){let d=Kt(h),u=n.measureText(d).width/2,f=Math.min(Math.max(t.x(h),r+u),a-u);(f+u<a-c||h===0)&&n.fillText(d,f,t.height-4)}n.textAlign="right",n.fillText(l,a,t.height-4),n.textAlign="left",n.fillText(`${e.title||""}${t.unit?` (${t.unit})`:""}`,r,11)}function MS(n,t,e,i,s){let{x:r,y:a}=e;n.strokeStyle=n.fillStyle=i,n.lineWidth=1.6,n.setLineDash(e.dashed?[5,3]:[]);for(let[o,l]of SS(a)){n.beginPath();for(let c=o;c<=l;c++)n[c>o?"lineTo":"moveTo"](t.x(r[c]),t.y(a[c]));n.stroke(),s&&(n.lineTo(t.x(r[l]),t.y(0)),n.lineTo(t.x(r[o]),t.y(0)),n.globalAlpha=.12,n.fill(),n.globalAlpha=1)}n.setLineDash([])}function SS(n){let t=[];for(let e=0;e<n.length;e++){if(!Number.isFinite(n[e]))continue;t.length&&t[t.length-1][1]===e-1?t[t.length-1][1]=e:t.push([e,e])}return t}function AS(n,t,e,i){e>t.y1||(n.strokeStyle=i,n.setLineDash([4,3]),n.beginPath(),n.moveTo(Ai.left,t.y(e)),n.lineTo(t.width-Ai.right,t.y(e)),n.stroke(),n.setLineDash([]))}function ES(n,t,e,i){n.strokeStyle=i,n.globalAlpha=.6,n.beginPath(),n.moveTo(t.x(e),Ai.top),n.lineTo(t.x(e),t.height-Ai.bottom),n.stroke(),n.globalAlpha=1}function TS(n,t,e,i,s){let r=t.width-Ai.right;n.textAlign="right";for(let a=e.length-1;a>=0;a--){let{label:o}=e[a];o&&(n.fillStyle=s,n.fillText(o,r,11),r-=n.measureText(o).width+4,n.fillStyle=i[a%i.length],n.fillRect(r-12,6,12,3),r-=20)}}var Gg=41,CS=12,RS=new Set(["stress"]),PS=[["Axial force T","N",[[0,""]]],["Shear V","N",[[1,""]]],["Bending moment M","N m",[[2,""]]],["von Mises stress","Pa",[[3,""]]]],IS=[["Axial force T","N",[[0,""]]],["Shear V","N",[[1,"V2"],[2,"V3"]]],["Bending moment M","N m",[[3,"M2"],[4,"M3"]]],["Torsion","N m",[[5,""]]],["von Mises stress","Pa",[[6,""]]]],Zc=class{constructor(t){this.app=t,this.node=g("section",{class:"inspector","aria-label":"what is picked"})}show(){let{picked:t}=this.app;if(this.updates=[],!t){let e=this.app.views.some(({scene:r})=>r.members.length),i=(e?["N","P"]:["Shift N","Shift P"]).map(r=>g("kbd",{},r)),s=`${this.app.touch?"Tap":"Pick"} ${e?"a member or node in the picture or the table":"a node in the picture"}`;he(this.node,g("p",{class:"faint"},s,this.app.touch?".":["; or step through them with ",i[0]," and ",i[1],"."]),e?null:this.overview(),this.app.views.map((r,a)=>this.measured(r,a))),this.update();return}he(this.node,g("div",{class:"views"},this.app.views.map((e,i)=>this.column(e,i,t)))),this.update()}overview(){let t=this.app.views.flatMap(({scene:e})=>{let{skins:i=[],pressures:s,loads:r}=e.header,a=i.map(l=>[`${l.kind[0].toUpperCase()}${l.kind.slice(1)}`,l.name]);a.push(["Nodes",e.nodes.length],["Faces",e.faces]),s&&a.push(["Pressure",`${s.least===s.largest?"":`${St(s.least,"Pa")} to `}${St(s.largest,"Pa")} on ${s.count} ${s.count===1?"face":"faces"}`]);let o=r.filter(l=>!l.pressure&&!l.at).length;return o&&a.push(["Nodal loads",o]),a});return g("table",{class:"values"},t.map(([e,i])=>g("tr",{},g("th",{},e),g("td",{},i))))}measured(t,e){let{scene:i}=t,s=i.header.quantities||[];if(!s.length)return null;let r=({limits:c},h)=>c&&(c[0]!==null&&h<c[0]||c[1]!==null&&h>c[1]),a=this.values(()=>s.map((c,h)=>{let d=i.number("quantity",t.frame,h);return[c.name,St(d,c.unit),r(c,d)?"beyond its limit":c.words]})),o=i.frames<2?[]:s.slice(0,CS).map((c,h)=>{let d=g("canvas",{class:"plot",role:"img","aria-label":`${c.name} over time`}),u=Array.from(i.time,(f,p)=>i.number("quantity",p,h));return this.updates.push(()=>Di(d,[{x:i.time,y:u,label:""}],{title:c.name,unit:c.unit,cursor:i.time[t.frame]})),d}),l=this.app.views.length>1;return g("div",{class:"subject"},g("h2",{},"Quantities",l?g("small",{},` ${this.app.labels[e]}`):null),a,...o)}update(){for(let t of this.updates||[])t()}column(t,e,i){let{scene:s}=t,r=this.app.indexIn(t,i),o=this.app.views.length>1?g("h3",{},this.app.labels[e]):null;if(r<0)return g("div",{},o,g("p",{class:"faint"},`no ${i.type} called ${i.name} here`));let l=i.type==="member"?this.member(t,r):this.atNode(t,r);return g("div",{class:"subject"},o,...l)}member(t,e){let{scene:i}=t,[s,r]=[i.ends[2*e],i.ends[2*e+1]],a=i.header.kinds[e],l=[g("h2",{},i.members[e],g("small",{},` ${a}${a==="cable"?"":" member"}, `,this.link(t,s)," → ",this.link(t,r))),this.values(()=>this.memberValues(t,e)),this.history(t,e),...this.driveHistories(t,e)];return i.has("member_force")&&((i.header.beams||[]).includes(e)?l.push(...this.beam(t,e)):i.header.bodies.some(c=>c.member===e)||l.push(...this.mechanics(t,e))),l}link(t,e){let i=t.scene.nodes[e];return g("button",{class:"link",type:"button",onclick:()=>this.app.pick({type:"node",name:i})},i)}values(t){let e=g("table",{class:"values"});return this.updates.push(()=>he(e,t().map(([i,s,r])=>g("tr",{},g("th",{},i),g("td",{},s,r?g("small",{},` ${r}`):null))))),e}memberValues(t,e){let{scene:i,frame:s}=t,r=i.header.channels.map(l=>{let c=i.plainValue(l.id,s,e),h=l.id==="force"&&c?c>0?"tension":"compression":"";return[l.label,fo(l,c),l.over_run?"worst of the run":h]}),a=i.header.bodies.find(l=>l.member===e);a&&r.push(["Body",St(a.mass,"kg")]),r.push(["Length",St(i.length(s,e),"m",6)]),r.push(...DS(i,s,e)),r.push(...Wg(Ju(i,s,e)));let o=i.header.not_checked?.[i.members[e]];return o&&r.push(["Not checked",o]),i.unsure.has(e)&&r.push(["Note","this force is not unique: a share by stiffness or convention"]),r}history(t,e){let{scene:i}=t;if(i.frames<2)return null;let s=g("canvas",{class:"plot",role:"img","aria-label":"history"});return this.updates.push(()=>{let r=i.channel(this.app.channel?.id)||i.header.channels[0],a=Array.from(i.time,(h,d)=>i.value(r.id,d,e)),o=RS.has(r.id)?Vg(i,e):["capacity","margin"].includes(r.scale)?1:void 0,l=r.scale==="margin"?"Buckling: compression over allowed":r.label,c=[{x:i.time,y:a,label:""}];if(r.id==="force"&&i.has("rest_force")){let h=Array.from(i.time,(d,u)=>i.number("rest_force",u,e));c.push({x:i.time,y:h,label:"at rest",dashed:!0})}Di(s,c,{title:l,unit:r.unit,cursor:i.time[t.frame],limit:o})}),s}driveHistories(t,e){let{scene:i}=t;return i.frames<2||!i.has("drive_force")?[]:i.header.drives.flatMap((s,r)=>{let a=Array.from(i.time,(c,h)=>i.number("drive_force",h,r));if(s.member!==e||!a.some(Number.isFinite))return[];let o=s.unit==="rad",l=g("canvas",{class:"plot",role:"img","aria-label":`drive ${s.name} over time`});return this.updates.push(()=>Di(l,[{x:i.time,y:a,label:""}],{title:`${o?"Torque":"Force"} of drive ${s.name}`,unit:o?"N m":"N",cursor:i.time[t.frame]})),[l]})}beam(t,e){let{scene:i}=t,s=i.arrays.beam_section,r=i.curves.row.get(e);if(!s||r===void 0)return[g("p",{class:"faint"},r===void 0?"Section forces of rigid beams are not computed.":"Section forces of beams: kt.strength.beams.")];let[,a,o,l]=s.shape,c=i.length(0,e),h=Array.from({length:o},(p,y)=>y*c/(o-1)),d=p=>h.map((y,m)=>s.data[((t.frame*a+r)*o+m)*l+p]),f=(i.dim===2?PS:IS).map(p=>[g("canvas",{class:"plot small",role:"img","aria-label":p[0]}),...p]);return this.updates.push(()=>{for(let[p,y,m,x]of f){let _=x.map(([w,b])=>({x:h,y:d(w),label:b}));Di(p,_,{title:y,unit:m,xUnit:"m from A",fill:!0})}}),[g("h4",{},"Along it, now"),...f.map(([p])=>p)]}mechanics(t,e){let{scene:i}=t,s=g("div",{class:"freebody"}),r=g("div");this.updates.push(()=>{let l=Yc(i,t.frame,e);he(s,Ig(i,l)),he(r,Lg(i,l))});let a=i.dim===3,o=[["Axial force T","N",[["T",""]]],["Shear V","N",a?[["V2","V2"],["V3","V3"]]:[["V2",""]]],["Bending moment M","N m",a?[["M2","M2"],["M3","M3"]]:[["M3",""]]],["von Mises stress","Pa",[["stress",""]]]].map(l=>[g("canvas",{class:"plot small",role:"img","aria-label":l[0]}),...l]);return this.updates.push(()=>{let l=Qu(i,t.frame,e);for(let[c,h,d,u]of o){let f=u.map(([y,m])=>({x:l.s,y:l[y],label:m})),p=NS(u)==="stress"?Vg(i,e):void 0;Di(c,f,{title:h,unit:d,xUnit:"m from A",fill:!0,limit:p})}}),[g("h4",{},"Cut free, now"),s,r,g("h4",{},"Along it, now"),...o.map(([l])=>l)]}atNode(t,e){let{scene:i}=t,s=g("h2",{},i.nodes[e],g("small",{}," node")),r=i.members.flatMap((c,h)=>i.ends[2*h]===e||i.ends[2*h+1]===e?[h]:[]),a=g("p",{},"joins ",r.slice(0,24).flatMap(c=>[g("button",{class:"link",type:"button",onclick:()=>this.app.pick({type:"member",name:i.members[c]})},i.members[c])," "])),o=po(this.app.hint("Path","T"),"Path of this node along the run",!1,()=>this.app.toggleTrace());o.classList.add("trace"),this.updates.push(()=>xi(o,this.app.paths.has(i.nodes[e])));let l=[s,a,this.values(()=>LS(i,t.frame,e))];return i.frames>1&&l.push(o,this.nodeHistory(t,e)),l}nodeHistory(t,e){let{scene:i}=t,s=g("canvas",{class:"plot",role:"img","aria-label":"history"}),r=i.position(0,e),a="xyz".slice(0,i.dim).split("").map((o,l)=>({x:i.time,label:o,y:Array.from(i.time,(c,h)=>i.position(h,e)[l]-r[l])}));return this.updates.push(()=>Di(s,a,{title:"Moved from the start",unit:"m",cursor:i.time[t.frame]})),s}},NS=n=>n[0][0];function Vg(n,t){return Math.min(...n.partsOf[t].map(e=>n.arrays.part_allowed.data[e]))}function LS(n,t,e){let i="xyz".slice(0,n.dim).split(""),s=(c,h)=>{let d=Math.max(...c.map(Math.abs)),[u,f]=an(i.map((p,y)=>Math.abs(c[y])>1e-9*d?c[y]:0),h);return`${u.map(p=>p.trim()).join(", ")} ${f}`},r=[["Position",s(n.position(t,e),"m")]];if(n.has("velocity")){let c=n.vector("velocity",t,e),h=n.vector("acceleration",t,e);r.push(["Speed",St(Math.hypot(...c),"m/s")],["Velocity",s(c,"m/s")],["Acceleration",s(h,"m/s²")])}let a=n.arrays.lump.data[e];a&&r.push(["Lumped mass",St(a,"kg")]);let o=n.header.supports.find(c=>c.node===e);o&&r.push(o.words?["Support",o.words]:["Held in",[...o.axes].join(", ")]);let l=n.header.supported?.indexOf(n.nodes[e])??-1;return l>=0&&r.push(["Reaction",s(n.vector("reaction",t,l),"N")]),n.header.loads.forEach((c,h)=>{c.node===e&&r.push([`Load ${c.name}`,s(n.vector("load_force",t,h),"N")])}),r.push(...Wg(Fg(n,t,e))),r}function DS(n,t,e){return n.header.loads.flatMap((i,s)=>{if(i.member!==e||i.words===!1)return[];let r=Math.hypot(...n.vector("load_force",t,s));return[[`Load ${i.name}`,i.span?St(r/i.span,"N/m"):St(r,"N")]]})}function Wg(n){return n.filter(t=>!Number.isNaN(t.position)).map(t=>{let e=t.unit==="rad";return[`Drive ${t.name}`,St(t.position,t.unit,6),Number.isNaN(t.force)?"":`drive ${e?"torque":"force"} ${St(t.force,e?"N m":"N")}`]})}function Qu(n,t,e){let i={s:[],T:[],V2:[],V3:[],M2:[],M3:[],stress:[],parts:[]};for(let s of qc(n,t,e).parts){i.s.length&&Hg(i,s.start,{T:NaN,V2:NaN,V3:NaN,M2:NaN,M3:NaN,stress:NaN},"");for(let r=0;r<Gg;r++){let a=r/(Gg-1);Hg(i,s.start+a*s.length,jc(n,s,a),n.header.parts[s.part])}}return i}function Hg(n,t,e,i){n.s.push(t),n.parts.push(i);for(let[s,r]of Object.entries(e))n[s].push(r)}var $g=[["Time",[[" ","play or pause",n=>n.togglePlay(),"space"],["ArrowRight","one sample on (Shift: ten)",(n,t)=>n.step(t.shiftKey?10:1),"→"],["ArrowLeft","one sample back (Shift: ten)",(n,t)=>n.step(t.shiftKey?-10:-1),"←"],["Home","to the start",n=>n.goTo(0)],["End","to the end",n=>n.goTo(n.lead.frames-1)],["+","faster",n=>n.faster(1)],["-","slower",n=>n.faster(-1)],["x","to the worst sample of what colours",n=>n.toWorst()]]],["What is shown",[["c","next colour (Shift: previous)",(n,t)=>n.nextChannel(t.shiftKey?-1:1)],["s","next diagram over the structure (Shift: previous)",(n,t)=>n.nextDiagram(t.shiftKey?-1:1)],["e","next load case",n=>n.nextCase()],["m","next mode or mechanism",n=>n.nextMode()],["g","start pose as a ghost",n=>n.toggle("ghost")],["y","paths of all nodes that move",n=>n.toggle("paths")],["l","loads",n=>n.toggle("loads")],["b","supports",n=>n.toggle("supports")],["r","faces of rigid bars",n=>n.toggle("faces")],["h","ground grid",n=>n.toggle("grid")],["a","names",n=>n.toggle("names")],["v","panel beside the picture",n=>n.togglePanel()],["d","dark or light",n=>n.toggleTheme()]]],["Picking",[["n","next member (Shift: next node)",(n,t)=>n.pickNext(t.shiftKey?"node":"member",1)],["p","previous member (Shift: node)",(n,t)=>n.pickNext(t.shiftKey?"node":"member",-1)],["w","the worst member now",n=>n.pickWorst()],["t","path of the picked node",n=>n.toggleTrace()],["/","find by name",n=>n.find()],["Escape","nothing picked",n=>n.escape(),"Esc"]]],["Camera",[["1","from a corner",n=>n.aim("corner")],["2","from the front (along y)",n=>n.aim("front")],["3","from the side (along x)",n=>n.aim("side")],["4","from above (the x-y plane)",n=>n.aim("plane")],["f","fit",n=>n.aim(n.views[0].preset)],["i","turn up",n=>n.orbit(0,.12,1)],["k","turn down",n=>n.orbit(0,-.12,1)],["j","turn left",n=>n.orbit(-.12,0,1)],["o","turn right",n=>n.orbit(.12,0,1)],[",","nearer",n=>n.orbit(0,0,.9)],[".","farther",n=>n.orbit(0,0,1.1)],["?","this page",n=>n.toggleHelp()]]]],kS=new Set([..."1234ikjo"]),OS=new Set(["text","search","number"]);function Xg(n,t,e){let i=new Map($g.flatMap(([,r])=>r.map(([a,,o])=>[a,o])));t.addEventListener("keydown",r=>{if(r.ctrlKey||r.metaKey||r.altKey||r.defaultPrevented)return;let a=r.target;if(r.key!=="Escape"&&a.closest?.(".controls"))return;if(a.tagName==="INPUT"&&OS.has(a.type)){r.key==="Enter"&&n.table.pickFirst(),(r.key==="Escape"||r.key==="Enter")&&a.blur();return}if(a.tagName==="BUTTON"&&(r.key===" "||r.key==="Enter")||a.tagName==="SELECT")return;let l=r.key.length===1?r.key.toLowerCase():r.key,c=i.get(l);c&&(r.preventDefault(),c(n,r))},{signal:e});let s=!1;t.addEventListener("pointerdown",()=>s=!0,{signal:e}),t.addEventListener("keydown",()=>s=!1,{capture:!0,signal:e}),t.addEventListener("change",r=>{s&&r.target.tagName==="SELECT"&&r.target.blur()},{signal:e})}function qg(n){let t=n.views[0].scene.dim===2,i=$g.map(([l,c])=>[l,c.filter(([h])=>!t||!kS.has(h))]).map(([l,c])=>g("div",{},g("h3",{},l),g("dl",{},c.map(([h,d,,u])=>[g("dt",{},g("kbd",{},u||h.toUpperCase())),g("dd",{},d)]).flat()))),s=g("button",{type:"button",onclick:()=>n.toggleHelp()},n.hint("Close","Esc")),a=`Bars thinner than a hundredth of the usual length are drawn thicker, to be seen. Green: what moves by itself (collars at the screw, rings at motors). Hatched: supports. Violet arrows: loads. Striped: not checked, or a force that is not unique. ${n.touch?`${t?"Drag to shift, two fingers to approach":"Drag to turn, two fingers to shift and approach"}, tap to pick.`:`${t?"Drag to shift":"Drag to turn, right-drag to shift"}, wheel to approach, click to pick.`}`,o=l=>{l.key==="Tab"&&(l.preventDefault(),s.focus())};return g("div",{class:"help",role:"dialog","aria-modal":"true","aria-label":n.touch?"help":"keys",hidden:!0,onkeydown:o},g("div",{class:"sheet"},n.touch?g("h2",{},"Help"):[g("h2",{},"Keys"),g("div",{class:"columns"},i)],g("p",{},a),s))}var US={rigid:"rigid bar",driven:"driven bar",active:"active member: base and tube",elastic:"elastic bar",beam:"elastic beam",cable:"cable: tension only",free:"free sensor"},FS={membrane:"membrane",solid:"surface of a solid"},Jc=class{constructor(t){this.app=t,this.node=g("div",{class:"legend",role:"note","aria-live":"polite"})}show(){let{channel:t,limits:e}=this.app;if(!t){let l=[...this.kinds().map(([c,h])=>Kc(Ke[c],h)),...this.skins(),...this.motors()];this.node.hidden=!l.length,he(this.node,g("b",{},"Kinds of members"),l);return}this.node.hidden=!1;let[i,s]=Cn(e[1],t.unit),r=`${t.label}${s?` (${s})`:""}`,a=BS(t,e).map(l=>g("span",{},zS(t,l,i))),o=[g("b",{},r),g("div",{class:"bar",style:`background:${Pr(t.scale)}`}),g("div",{class:"ticks"},a),g("div",{class:"words"},g("span",{},t.low),g("span",{},this.high(t)))];t.over_run&&o.push(g("small",{},"worst of the whole run")),this.over(t)&&o.push(Kc(Tn,t.scale==="margin"?"buckles (margin below 0)":"over capacity (above 100 %)")),this.missing(t)&&o.push(jg("var(--missing)",Hi(t)?"not checked":"not known")),t.id!=="speed"&&this.app.views.some(({scene:l})=>l.unsure.size)&&o.push(jg("var(--faint)","the force is not unique")),this.app.views.some(({scene:l})=>l.coloursFaces(t.id))||o.push(...this.skins()),he(this.node,o)}high(t){if(t.high!=="largest of the run")return t.high;let e=this.app.views.map(({scene:i})=>i).filter(i=>i.channel(t.id));return`largest ${this.app.lead.frames>1?"of the run ":""}${St(Math.max(...e.map(i=>i.range(t.id)[1])),t.unit)}`}kinds(){let t=new Set(this.app.views.flatMap(e=>e.scene.header.kinds));return Object.entries(US).filter(([e])=>t.has(e))}motors(){return this.app.views.some(({scene:e})=>e.header.drives.some(i=>i.kind==="angle"||i.kind==="hinge"))?[Kc(Ke.driven,"ring: motor about its axis")]:[]}skins(){let t=new Set(this.app.views.flatMap(e=>e.scene.header.skins?.map(i=>i.kind)||[]));return Object.entries(FS).filter(([e])=>t.has(e)).map(([e,i])=>Kc(ho[e],i))}over(t){return Hi(t)&&this.app.views.some(({scene:e})=>e.channel(t.id)&&e.range(t.id)[1]>1)}missing(t){return this.app.views.some(({scene:e,frame:i})=>e.members.some((s,r)=>Number.isNaN(e.value(t.id,i,r))))}};function Kc(n,t){return g("div",{class:"swatch"},g("i",{style:`background:${n}`}),t)}function jg(n,t){return g("div",{class:"swatch"},g("i",{style:`background:repeating-linear-gradient(135deg, ${n} 0 4px, var(--card) 4px 7px)`}),t)}function BS(n,[t,e]){return n.scale==="diverging"?[t,t/2,0,e/2,e]:[0,.25,.5,.75,1].map(i=>t+i*(e-t))}function zS(n,t,e){return n.scale==="margin"?t<=0?"∞":Kt(1/t-1,2):Kt(t*e,3)}var GS=400,Qc=48,tf=5,ef=2,VS=[[1,-1],[1,1],[-1,-1],[-1,1],[0,-1],[0,1],[1,0],[-1,0]],HS=[.5,.4,.6,.3,.7,.2,.8],th=class{constructor(t){this.view=t,this.node=g("div",{class:"names","aria-hidden":!0})}place(t,e=[]){if(this.node.hidden=!t||this.view.scene.members.length>GS,this.node.hidden)return;let{scene:i,now:s}=this.view;this.tags??=this.made();let r=s.map(l=>this.view.project(l)),a=this.node.getBoundingClientRect(),o=new nf(a.width,a.height);for(let l of this.node.closest(".stage")?.querySelectorAll(".legend")||[])o.add(XS(l,a));for(let l of e)o.add(l);for(let{tag:l,type:c,index:h}of this.order()){let d=c==="node"?WS(r[h],l):$S(this.view.along(h,r),l),u=[l.place??0,...d.keys()].find(f=>f<d.length&&o.free(d[f]));l.node.style.visibility=u===void 0?"hidden":"visible",u!==void 0&&(l.place=u,o.add(d[u]),l.node.style.transform=`translate(${(d[u][0]+ef).toFixed(1)}px, ${d[u][1].toFixed(1)}px)`)}}made(){let{scene:t}=this.view,e=[...t.nodes.map((i,s)=>g("span",{class:"of-node",hidden:t.directors.has(s)},i)),...t.members.map((i,s)=>g("span",{hidden:!t.shows(s)},i))];return he(this.node,e),e.map(i=>({node:i,width:i.offsetWidth,height:i.offsetHeight}))}order(){let{scene:t,picked:e}=this.view,i=t.nodes.length,s=this.tags.map((a,o)=>o<i?{tag:a,type:"node",index:o}:{tag:a,type:"member",index:o-i});return[...e?s.splice((e.type==="node"?0:i)+e.index,1):[],...s].filter(({tag:a})=>!a.node.hidden)}};function WS([n,t],{width:e,height:i}){return VS.map(([s,r])=>Yg(n+s*(e/2+tf),t+r*(i/2+tf-1),e,i))}function $S(n,{width:t,height:e}){let i=Math.floor(n.length/3),s=n[i],r=n[n.length-1-i],[a,o]=[r[0]-s[0],r[1]-s[1]],l=Math.hypot(a,o)||1,c=[o/l,-a/l],h=(Math.abs(c[0])*t+Math.abs(c[1])*e)/2+tf-1;return HS.flatMap(d=>[1,-1].map(u=>Yg(s[0]+d*a+u*h*c[0],s[1]+d*o+u*h*c[1],t,e)))}function Yg(n,t,e,i){return[n-e/2-ef,t-i/2,n+e/2+ef,t+i/2]}function XS(n,t){let e=n.getBoundingClientRect();return[e.left-t.left,e.top-t.top,e.right-t.left,e.bottom-t.top]}var nf=class{constructor(t,e){Object.assign(this,{width:t,height:e,cells:new Map})}squares([t,e,i,s]){let r=[];for(let a=Math.floor(t/Qc);a<=Math.floor(i/Qc);a++)for(let o=Math.floor(e/Qc);o<=Math.floor(s/Qc);o++)r.push(1e5*a+o);return r}free(t){return t[0]<0||t[1]<0||t[2]>this.width||t[3]>this.height?!1:this.squares(t).every(e=>(this.cells.get(e)||[]).every(i=>i[2]<=t[0]||i[0]>=t[2]||i[3]<=t[1]||i[1]>=t[3]))}add(t){for(let e of this.squares(t))this.cells.has(e)?this.cells.get(e).push(t):this.cells.set(e,[t])}};var qS=.13,gs=13,jS=40,YS=.02,ZS=1e-7,KS=4e3,JS={N:"T",V:"V2",M:"M3"},QS=[[0,1],[0,-1],[1,0],[-1,0],[1,1],[-1,1],[1,-1],[-1,-1]],t1=[1,2],e1=[1,2,4,8,16,24],ih=class{constructor(t){this.view=t,this.node=ht("svg",{class:"diagram","aria-hidden":!0}),this.labels=[],this.boxes=[],this.factors=new Map}place(t){let{scene:e,frame:i}=this.view;if(this.labels=[],this.boxes=[],!t||!Zg(e,t)){this.node.replaceChildren();return}let s=this.factor(t),r=rf(e,i,t,this.view.now),a=r.map(l=>this.drawn(l,t,s)),o=this.view.canvas.getBoundingClientRect();this.node.setAttribute("viewBox",`0 0 ${o.width} ${o.height}`),this.node.replaceChildren(...a.flatMap(({shown:l})=>l),...this.written(r,a,t,o))}reach(t){let{scene:e}=this.view;if(!t||!Zg(e,t))return[];let i=this.factor(t),s=Kg(e),r=[];for(let a=0;a<e.frames;a+=s)for(let{base:o,values:l,ways:c,extremes:h}of rf(e,a,t))r.push(...h.map(d=>o[d].map((u,f)=>u+i*l[d]*c[d][f])));return r}factor(t){let{scene:e}=this.view,i=`${t.id} ${e.header.load_case}`;if(!this.factors.has(i)){let s=Kg(e),r=0;for(let l=0;l<e.frames;l+=s)for(let{values:c}of rf(e,l,t))for(let h of c)r=Math.max(r,Math.abs(h));let a=r?qS*e.extent.size/r:0,o=10**Math.floor(Math.log10(a||1));this.factors.set(i,t.id==="deflection"&&a?o*Math.max(...[1,2,5].filter(l=>l*o<=a*(1+1e-9))):a)}return this.factors.get(i)}drawn({base:t,values:e,ways:i},s,r){let a=c=>c.map(h=>this.view.project(h)),o=a(t),l=a(t.map((c,h)=>c.map((d,u)=>d+r*e[h]*i[h][u])));return{tips:l,foot:o,shown:lf(o,l,e,s.id)}}written(t,e,i,s){let r=t.flatMap(({extremes:o,values:l,member:c},h)=>o.map(d=>({member:this.view.scene.members[c],value:l[d],tip:e[h].tips[d],foot:e[h].foot[d]}))),a=af(r,i.unit,s,cf(this.node));return this.labels=a.map(({member:o,value:l,words:c})=>({member:o,value:l,words:c})),this.boxes=a.map(({box:o})=>o),a.map(of)}};function af(n,t,{width:e,height:i},s){let r=Math.max(0,...n.map(({value:l})=>Math.abs(l))),a=[],o=n.filter(({value:l})=>Math.abs(l)>YS*r).sort((l,c)=>Math.abs(c.value)-Math.abs(l.value)).slice(0,jS);for(let l of o){let c=St(l.value,t),h=6.4*c.length+6,d=15,u=([y,m])=>[y-h/2,m-d/2,y+h/2,m+d/2],f=n1(l,h,d,a.length?t1:e1).filter(([y,m])=>y>h/2&&m>d/2&&y<e-h/2&&m<i-d/2),p=f.find(y=>[...s,...a.map(m=>m.box)].every(m=>i1(u(y),m)))||(a.length?null:f[0]);p&&a.push({...l,words:c,at:p,box:u(p),chief:!a.length})}return a}function of({words:n,at:[t,e],chief:i}){return ht("text",{class:i?"chief":"",x:t.toFixed(1),y:e.toFixed(1)},n)}function lf(n,t,e,i){if(i==="deflection")return[ht("path",{class:"shape",d:sf(t)})];let s=(a,o)=>ht("path",{class:`area ${a}`,d:`${sf([...n,...t.map((l,c)=>o(e[c])?l:n[c]).reverse()])}Z`});return[...i==="N"?[s("tension",a=>a>0),s("compression",a=>a<0)]:[s("plain",()=>!0)],ht("path",{class:"rim",d:sf([n[0],...t,n.at(-1)])})]}var Zg=(n,t)=>n.header.shows?.some(({id:e})=>e===t.id),Kg=n=>Math.max(1,Math.ceil(n.frames*n.members.length/KS)),sf=n=>`M${n.map(([t,e])=>`${t.toFixed(1)} ${e.toFixed(1)}`).join("L")}`,i1=(n,t)=>n[2]<=t[0]||t[2]<=n[0]||n[3]<=t[1]||t[3]<=n[1];function n1({tip:n,foot:t},e,i,s){let r=[n[0]-t[0],n[1]-t[1]],a=([o,l])=>o*r[0]+l*r[1];return s.flatMap(o=>QS.toSorted((l,c)=>a(c)-a(l)).map(([l,c])=>[n[0]+l*(e/2+3*o),n[1]+c*(i/2+4*o)]))}function cf(n){let t=n.getBoundingClientRect();return[...n.closest(".stage")?.querySelectorAll(".legend, .told")||[]].filter(e=>!e.hidden).map(e=>{let i=e.getBoundingClientRect();return[i.left-t.left,i.top-t.top,i.right-t.left,i.bottom-t.top]})}function rf(n,t,e,i){return Qg(n,t,e,i).filter(({values:s})=>s.some(Boolean)&&!s.some(Number.isNaN)).map(s=>({...s,extremes:s1(s)}))}function Jg(n,t,e){let i=new Map;for(let{member:s,values:r}of Qg(n,t,e))i.set(s,!r.some(Number.isNaN));return n.members.filter((s,r)=>n.shows(r)&&!i.get(r)&&!(e.id==="torque"&&!n.curves.row.has(r)))}function Qg(n,t,e,i=n.nodes.map((s,r)=>n.position(t,r))){let s=e.unit==="m"?0:ZS*r1(n)*(e.unit==="N m"?n.extent.size:1),r=new Set(n.header.bodies.map(({member:o})=>o)),a=new Set(n.header.beams);return n.members.flatMap((o,l)=>{if(!n.shows(l))return[];let c=n.curves.row.get(l);return c!==void 0?n.has("beam_section")?[a1(n,t,e,i,l,c)]:[]:a.has(l)||r.has(l)?[]:e.id==="deflection"?[l1(n,t,l)]:c1(n,t,e,l)}).map(o=>({...o,values:o.values.map(l=>Math.abs(l)<=s?0:l)}))}function s1({values:n,extremes:t}){let e=[...new Set(t)].filter(r=>n[r]);if(e.length<2||n[e[0]]*n[e[1]]<0)return e;let i=e.reduce((r,a)=>Math.abs(n[a])>Math.abs(n[r])?a:r);return[Math.max(...n)-Math.min(...n)<=1e-6*Math.abs(n[i])?n.length>>1:i]}function r1(n){let t=(r,a)=>r.reduce((o,l,c)=>a(c)&&Math.abs(l)>o?Math.abs(l):o,0);n.forces??=new Map;let e=n.header.load_case,{joint_force:i,beam_section:s}=n.arrays;if(!n.forces.has(e)){let r=s?.shape[3];n.forces.set(e,Math.max(i?t(i.data,()=>!0):0,s?t(s.data,a=>a%r<n.dim):0))}return n.forces.get(e)}function a1(n,t,e,i,s,r){let{arrays:a,dim:o,header:l}=n,c=l.shows.findIndex(({id:R})=>R===e.id),[,h,d,u]=a.beam_extreme.shape,f=((t*h+r)*d+c)*u,[p,y,m,x]=a.beam_extreme.data.slice(f,f+4),_=R=>a.beam_section.data[((t*h+r)*gs+R)*a.beam_section.shape[3]+c],w=R=>[0,1,2].map(F=>F<o?a.beam_moved.data[((t*h+r)*gs+R)*o+F]:0),b=Array.from({length:gs},(R,F)=>e.id==="deflection"?w(F):null),A=[...Array.from({length:gs},(R,F)=>[F/(gs-1),b[F]?Math.hypot(...b[F]):_(F)]),...e.id==="deflection"?[[x,m]]:[[y,p],[x,m]]].sort((R,F)=>R[0]-F[0]),v=A.map(([,R])=>R),E=[p,m].map(R=>v.indexOf(R)).filter(R=>R>=0);if(e.id==="deflection"){let R=t0(n,t,s),F=A.map(([W])=>eh(b,W)).map(W=>W.map(V=>V/(Math.hypot(...W)||1)));return{member:s,base:A.map(([W])=>eh(R,W)),values:v,ways:F,extremes:E}}let D=n.curves.points(i,s),P=n.curves.across(i,s),k=D.at(-1).map((R,F)=>R-D[0][F]),U=k.map(R=>R/(Math.hypot(...k)||1)),$=A.map(([R])=>eh(P,R)).map(R=>(e.axis===2?R:o1(U,R)).map(F=>e.side*F));return{member:s,base:A.map(([R])=>eh(D,R)),values:v,ways:$,extremes:E}}function eh(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,a)=>(1-s)*r+s*n[i+1][a])}var o1=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]];function t0(n,t,e){return[0,1].map(i=>n.vector("unmoved",0,n.ends[2*e+i]))}function l1(n,t,e){let i=[0,1].map(r=>n.vector("moved",t,n.ends[2*e+r])),s=i.map(r=>Math.hypot(...r));return{member:e,base:t0(n,t,e),values:s,ways:i.map((r,a)=>r.map(o=>o/(s[a]||1))),extremes:[s[0]>s[1]?0:1]}}function c1(n,t,e,i){let s=JS[e.id]||e.id;if(s==="torque")return[];let r=Xa(n,t,i),[a,o,l]=r.axes,c=(e.axis===2?o:l).map(h=>e.side*h);return qc(n,t,i).parts.map(h=>{let d=new Set(Array.from({length:gs},(m,x)=>x/(gs-1))),u=0;for(let m of h.pieces){let x=Math.min(m.end,1);for(let _ of[u,Math.min(1,u+1e-9),x,...h1(m,s)])_>=u&&_<=x&&d.add(_);u=x}let f=[...d].sort((m,x)=>m-x),p=f.map(m=>jc(n,h,m)[s]),y=f.map(m=>r.xA.map((x,_)=>x+(h.start+m*h.length)*a[_]));return{member:i,base:y,values:p,ways:f.map(()=>c),extremes:[Math.min(...p),Math.max(...p)].map(m=>p.indexOf(m))}})}function h1({S:n,M:t},e){let i=e[0]==="M"?t[e==="M2"?0:1]:n.map(l=>l[["T","V2","V3"].indexOf(e)]),[s,r,a]=[3*(i[3]||0),2*i[2],i[1]];if(Math.abs(s)<1e-300)return r?[-a/r]:[];let o=Math.sqrt(r*r-4*s*a);return Number.isNaN(o)?[]:[(-r+o)/(2*s),(-r-o)/(2*s)]}var d1=[.001,.002,.005,.01,.02,.05,.1,.2,.5,1,2,5,10],e0=[1,1.5,2,3,4,6,8],u1=5,i0=8;function gr(n){if(!(n>0)||!Number.isFinite(n))return 1;let t=Math.floor(Math.log10(n/i0));return[...e0,...e0.map(i=>10*i)].map(i=>+`${i}e${t}`).find(i=>n/i<=i0&&n/i>=u1)||1}function n0(n){return[...new Set([...d1,gr(n)])].sort((t,e)=>t-e)}var mr=class{constructor(t){this.app=t;let e=t.lead.time,i=e[t.lead.frames-1]-e[0],s=gr(i),r=a=>`${Kt(a)}×${a===s&&i>0?` (${Kt(i/a,2)} s)`:""}`;this.button=g("button",{type:"button",class:"play",title:t.hint("Play or pause","space"),onclick:()=>t.togglePlay()},"▶"),this.slider=g("input",{type:"range",min:0,max:Math.max(t.lead.frames-1,0),step:1,value:0,"aria-label":"time",oninput:()=>t.seek(Number(this.slider.value))}),this.readout=g("output",{class:"time"}),this.speed=g("select",{"aria-label":"speed",title:t.hint("Speed","+ and -"),onchange:()=>t.setSpeed(Number(this.speed.value))},t.speeds.map(a=>g("option",{value:a,selected:a===t.speed},r(a)))),this.node=g("footer",{class:"timebar"},this.button,this.slider,this.readout,this.speed),this.node.hidden=t.lead.frames<2}update(){let{app:t}=this,e=t.lead.time[t.index],i=t.lead.time[t.lead.frames-1],s=Math.max(4,Math.ceil(Math.log10(t.lead.frames))+1);this.slider.value=t.index,this.slider.setAttribute("aria-valuetext",t.said?.()??`${Kt(e,s)} s of ${Kt(i,s)} s`),this.readout.textContent=t.said?.()??`${Kt(e,s)} s`,this.button.textContent=t.playing?"❚❚":"▶",this.button.setAttribute("aria-label",t.playing?"pause":"play"),this.speed.value=String(t.speed)}};function hf(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return Math.abs(n[i]-t)<Math.abs(t-n[e])?i:e}var xr=class{constructor(){Object.assign(this,{index:0,playing:!1,speed:1,way:"once",back:!1})}setLead(t){this.lead=t,Object.assign(this,{speeds:n0(this.duration),speed:gr(this.duration)})}get duration(){return this.lead.time[this.lead.frames-1]-this.lead.time[0]}step(t){this.pause(),this.goTo(this.index+t)}togglePlay(){this.lead.frames<2||(this.playing=!this.playing,this.playing&&this.way!=="back"&&this.index===this.lead.frames-1&&this.goTo(0),this.start(),this.time.update(),this.playing&&requestAnimationFrame(t=>this.tick(t)))}pause(){this.playing=!1,this.time.update()}start(){let t=this.lead.time[this.index]-this.lead.time[0];this.clock={at:performance.now(),from:this.back&&this.way==="back"?2*this.duration-t:t}}seek(t){this.goTo(t),this.start()}setWay(t){Object.assign(this,{way:t,back:!1}),this.start()}tick(t){if(!this.playing)return;let{duration:e,way:i}=this,s=i==="back"?2*e:e,r=this.clock.from+this.speed*(t-this.clock.at)/1e3,a=i==="once"&&r>=e;i!=="once"&&(r%=s),this.back=i==="back"&&r>e;let o=hf(this.lead.time,this.lead.time[0]+(this.back?s-r:r));o!==this.index&&this.goTo(o),a?this.pause():requestAnimationFrame(l=>this.tick(l))}setSpeed(t){this.speed=t,this.start(),this.time.update()}faster(t){let e=this.speeds.indexOf(this.speed)+t;this.setSpeed(this.speeds[Math.min(Math.max(e,0),this.speeds.length-1)])}};var df=150,nh=class{constructor(t){this.app=t,this.order={id:"name",down:!0},this.filter=g("input",{type:"search",placeholder:"find by name","aria-label":"find members by name",oninput:()=>this.show()}),this.head=g("thead"),this.body=g("tbody"),this.note=g("p",{class:"faint"}),this.node=g("section",{class:"table","aria-label":"values of all members now"},this.filter,g("div",{class:"scroll"},g("table",{class:"numbers"},this.head,this.body)),this.note)}columns(){let{scene:t}=this.app.views[0],e=t.header.channels.filter(a=>a.id!=="speed"||t.header.channels.length===1),i=this.app.views;e.length||e.push({id:"length",label:"Length",unit:"m"});let s=i.length>1?e.filter(a=>a.id===this.app.channel?.id).concat(e).slice(0,1):e,r=i.some(a=>a.scene.header.channels.some(o=>o.over_run));return s.flatMap(a=>i.flatMap((o,l)=>{let c=o.scene.channel(a.id);if(a.id!=="length"&&!c)return[];let h=uo(this.largest(a),[],a.unit)[1],d=i.length>1?`${a.label}, ${this.app.labels[l]}`:a.label;return[{id:`${a.id}:${l}`,label:d,unit:h,when:r?c?.over_run?"worst of run":"now":"",channel:a,view:o}]}))}largest(t){if(t.id==="length")return this.app.views.reduce((i,{scene:s})=>s.members.reduce((r,a,o)=>Math.max(r,s.length(0,o)),i),0);let e=this.app.views.filter(({scene:i})=>i.channel(t.id)).flatMap(({scene:i})=>i.range(t.id));return Math.max(...e.map(Math.abs))}show(){let t=this.columns(),e=(c,h)=>g("th",{scope:"col","aria-sort":this.order.id===c?this.order.down?"descending":"ascending":"none"},g("button",{type:"button",class:"link",onclick:()=>this.sort(c)},h)),i=({label:c,unit:h,when:d})=>[c,d?g("small",{},d):null,h?g("small",{class:"unit"},` (${h})`):null];he(this.head,g("tr",{},e("name","member"),t.map(c=>e(c.id,i(c)))));let s=[...new Set(this.app.views.flatMap(({scene:c})=>c.members.filter((h,d)=>c.shows(d))))],r=this.filter.value.trim().toLowerCase(),a=s.map(c=>({name:c})).filter(({name:c})=>c.toLowerCase().includes(r)),o=t.find(c=>c.id===this.order.id);o?a.sort((c,h)=>(this.order.down?1:-1)*(s0(o,h.name)-s0(o,c.name))):this.order.down||a.reverse(),this.rows=a.slice(0,df),this.cells=[],he(this.body,this.rows.map(({name:c})=>this.row(c,t)));let l=this.app.views.map(({scene:c})=>c);he(this.note,a.length>df?g("span",{},`${df} of ${a.length} members; sort or search to see others. `):null,t.some(c=>c.channel.id==="force")&&l.some(c=>c.unsure.size)?g("span",{},"† not unique: a share by stiffness or convention. "):null,t.some(c=>Hi(c.channel))&&l.some(({unchecked:c})=>c)?g("span",{},"- striped: not checked. "):null,t.some(c=>c.channel.id==="utilisation")&&l.some(c=>Object.keys(c.header.not_checked||{}).length)?g("span",{},"* not every rule was checked: pick the member. "):null),this.node.hidden=!s.length,this.update(),this.mark()}row(t,e){let i=e.map(r=>{let a=g("td");return this.cells.push({cell:a,column:r,index:r.view.scene.members.indexOf(t)}),a}),s=g("button",{type:"button",class:"link",onclick:()=>this.app.pick({type:"member",name:t})},t);return g("tr",{"data-name":t},g("th",{scope:"row"},s),i)}pickFirst(){this.rows.length&&this.app.pick({type:"member",name:this.rows[0].name})}sort(t){this.order={id:t,down:this.order.id===t?!this.order.down:!0},this.show()}update(){let t=new Map;for(let e of this.cells){let{scene:i,frame:s}=e.column.view,{channel:r}=e.column;e.value=e.index<0?NaN:i.plainValue(r.id,s,e.index),t.set(e.column,[...t.get(e.column)||[],e])}for(let[e,i]of t){let{channel:s,view:{scene:r}}=e,a=i.map(l=>l.value),o=s.scale==="margin"?a.map(l=>fo(s,l,!0)):uo(this.largest(s),a,s.unit,0,!0)[0];i.forEach(({cell:l,value:c,index:h},d)=>{let u=h<0?"":this.sign(s,r,h,c);l.textContent=u+o[d],l.classList.toggle("over",Hi(s)&&c>1),l.classList.toggle("hatched",u.startsWith("†")||h>=0&&Hi(s)&&Number.isNaN(c))})}}sign(t,e,i,s){let r=e.members[i];return t.id==="force"&&e.unsure.has(i)?"† ":t.id==="utilisation"&&!Number.isNaN(s)&&e.header.not_checked?.[r]?"* ":""}reveal(t){let e=this.body.closest(".scroll"),i=this.head.offsetHeight;t.offsetTop-i<e.scrollTop?e.scrollTop=t.offsetTop-i:t.offsetTop+t.offsetHeight>e.scrollTop+e.clientHeight&&(e.scrollTop=t.offsetTop+t.offsetHeight-e.clientHeight)}mark(){let{picked:t}=this.app;for(let e of this.body.children){let i=t?.type==="member"&&e.dataset.name===t.name;e.toggleAttribute("aria-current",i),i&&this.reveal(e)}}};function s0(n,t){let{scene:e,frame:i}=n.view,s=e.members.indexOf(t),r=s<0?NaN:Math.abs(e.value(n.channel.id,i,s));return Number.isNaN(r)?-1:r}var f1=[["ghost","Ghost","Start pose","G"],["paths","Paths","Paths of all nodes that move","Y"],["names","Names","Names of members and nodes","A"],["loads","Loads","Loads","L"],["grid","Grid","Ground grid","H"]],p1=[["corner","Corner","1"],["front","Front","2"],["side","Side","3"],["plane","Top","4"]],sh=class{constructor(t){this.app=t;let{header:e}=t.views[0].scene,i=[...new Set(t.views.map(({scene:h})=>h.header.title||h.header.name||"Model"))],s=[...new Map(t.views.flatMap(h=>h.scene.header.channels).map(h=>[h.id,h])).values()],r=g("option",{value:""},"Kind of member");this.colour=g("select",{"aria-label":"colour by",title:t.hint("Colour by","C"),onchange:()=>t.setChannel(this.colour.value)},r,s.map(h=>g("option",{value:h.id},h.label)));let a=f1.filter(([h])=>h!=="paths"||t.lead.frames>1);this.switches=new Map(a.map(([h,d,u,f])=>[h,po(d,t.hint(u,f),t.shown[h],()=>t.toggle(h))]));let o=t.views[0].scene.dim===3?p1:[],l=e.modes.length?g("select",{"aria-label":"mode",title:t.hint("Mode or mechanism","M"),onchange:()=>t.setMode(Number(this.modes.value))},g("option",{value:-1},"No mode"),e.modes.map((h,d)=>g("option",{value:d},m1(h)))):null;this.modes=l;let{cases:c}=t.views[0].scene;this.cases=c.length>1?g("select",{"aria-label":"load case",title:t.hint("Load case","E"),onchange:()=>t.setCase(this.cases.value)},c.map(h=>g("option",{value:h},h))):null,this.diagram=t.offered.length?g("select",{"aria-label":"diagram",title:t.hint("Diagram over the structure","S"),onchange:()=>t.setDiagram(this.diagram.value)},g("option",{value:""},"Off"),t.offered.map(({id:h,label:d})=>g("option",{value:h},d))):null,this.node=g("header",{class:t.views.length>1?"toolbar two":"toolbar"},g("div",{class:"title"},g("h1",{},i.join(" | ")),t.views.map(({scene:h},d)=>g("p",{},t.views.length>1?`${t.labels[d]}: `:"",g1(h)))),g("div",{class:"tools"},this.cases&&g("label",{},g("span",{},"Load case"),this.cases),g("label",{},g("span",{},"Colour"),this.colour),this.diagram&&g("label",{},g("span",{},"Diagram"),this.diagram),l,g("span",{class:"group",role:"group","aria-label":"camera"},o.map(([h,d,u])=>g("button",{type:"button",title:t.hint(`Camera: ${d}`,u),onclick:()=>t.aim(h)},d))),g("span",{class:"group",role:"group","aria-label":"show"},[...this.switches.values()]),g("span",{class:"group"},g("button",{type:"button",title:t.hint("Panel","V"),onclick:()=>t.togglePanel()},"Panel"),g("button",{type:"button",title:t.hint("Dark or light","D"),"aria-label":"dark or light",onclick:()=>t.toggleTheme()},"◐"),g("button",{type:"button",title:t.hint("Help","?"),"aria-label":"help",onclick:()=>t.toggleHelp()},"?"))))}update(){this.colour.value=this.app.channel?.id||"",this.cases&&(this.cases.value=this.app.views[0].scene.header.load_case),this.diagram&&(this.diagram.value=this.app.diagram?.id||""),this.modes&&(this.modes.value=String(this.app.mode));for(let[t,e]of this.switches)xi(e,this.app.shown[t])}};function m1(n){return n.frequency===null?n.name:`${n.name}: ${St(Number(n.frequency),"Hz")}`}function r0(n,t){return`${n} ${t}${n===1?"":"s"}`}function g1(n){let{header:t}=n,e=n.members.filter((l,c)=>n.shows(c)),i=n.nodes.filter((l,c)=>!n.directors.has(c)),s=[t.kind==="run"?`run ${t.name}`:t.kind];t.cases.length===1&&t.load_case!=="all"&&s.push(`load case ${t.load_case}`);let r=(t.skins||[]).map(l=>`${l.kind} ${l.name}`);s.push([e.length||!r.length?r0(e.length,"member"):"",r.length>3?`${r.length} meshes`:r.join(", "),r0(i.length,"node")].filter(Boolean).join(", "));let{all:a,shown:o}=t.samples;return a>1&&s.push(o<a?`${o} of ${a} samples`:`${a} samples`),t.rounded&&s.push("curves rounded"),t.status!=="Completed."?s.push(`${t.status} ${t.message}`):t.message&&!t.verdict?.more.some(l=>t.message.includes(l))&&s.push(t.message),s.join(" · ")}var x1={ok:"✓",over:"✕",open:"-",none:"-"},rh=class{constructor(t){this.app=t,this.node=g("div",{class:"verdicts",role:"status","aria-label":"verdict"}),this.update()}update(){let t=JSON.stringify(this.app.views.map(({scene:e})=>e.header.verdict||null));t!==this.told&&(this.told=t,he(this.node,this.app.views.map((e,i)=>this.strip(e,i))),this.node.hidden=!this.node.childElementCount)}strip({scene:t},e){let{verdict:i}=t.header;if(!i)return null;let{state:s,text:r,governing:a,more:o}=i;return g("div",{class:`verdict ${s}`},g("span",{class:"headline"},g("b",{class:"sign","aria-hidden":!0},x1[s]),g("b",{},this.app.views.length>1?`${this.app.labels[e]}: ${r}`:r)),a?g("button",{type:"button",class:"governing",title:"Show this member and instant",onclick:()=>this.go(t,a)},s==="open"?`highest of what was checked: ${a.text}`:a.text):null,o.length?g("span",{},o.join("; ")):null)}go(t,e){let{app:i}=this;if(i.pause(),t.cases.includes(e.load_case)&&i.setCase(e.load_case),e.kind==="member"&&t.channel("utilisation")&&i.setChannel("utilisation"),e.time!==null&&i.goTo(i.lead.frameAt(e.time)),e.kind==="quantity")return i.pick(null);let s=t.header.drives.find(r=>r.name===e.name);t.members.includes(e.member)?i.pick({type:"member",name:e.member}):s?.member!==void 0?i.pick({type:"member",name:t.members[s.member]}):s&&i.pick({type:"node",name:t.nodes[s.node??s.start]})}};var a0={type:"change"},ff={type:"start"},l0={type:"end"},ah=new ss,o0=new bi,y1=Math.cos(70*Iu.DEG2RAD),Ve=new I,mi=2*Math.PI,pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},uf=1e-6,oh=class extends Aa{constructor(t,e=null){super(t,e),this.state=pe.NONE,this.target=new I,this.cursor=new I,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ji.ROTATE,MIDDLE:Ji.DOLLY,RIGHT:Ji.PAN},this.touches={ONE:Qi.ROTATE,TWO:Qi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new I,this._lastQuaternion=new Qe,this._lastTargetPosition=new I,this._quat=new Qe().setFromUnitVectors(t.up,new I(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new nr,this._sphericalDelta=new nr,this._scale=1,this._panOffset=new I,this._rotateStart=new it,this._rotateEnd=new it,this._rotateDelta=new it,this._panStart=new it,this._panEnd=new it,this._panDelta=new it,this._dollyStart=new it,this._dollyEnd=new it,this._dollyDelta=new it,this._dollyDirection=new I,this._mouse=new it,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=_1.bind(this),this._onPointerDown=v1.bind(this),this._onPointerUp=b1.bind(this),this._onContextMenu=C1.bind(this),this._onMouseWheel=S1.bind(this),this._onKeyDown=A1.bind(this),this._onTouchStart=E1.bind(this),this._onTouchMove=T1.bind(this),this._onMouseDown=w1.bind(this),this._onMouseMove=M1.bind(this),this._interceptControlDown=R1.bind(this),this._interceptControlUp=P1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(a0),this.update(),this.state=pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Ve.copy(e).sub(this.target),Ve.applyQuaternion(this._quat),this._spherical.setFromVector3(Ve),this.autoRotate&&this.state===pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=mi:i>Math.PI&&(i-=mi),s<-Math.PI?s+=mi:s>Math.PI&&(s-=mi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Ve.setFromSpherical(this._spherical),Ve.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ve),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=Ve.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new I(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new I(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Ve.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(ah.origin.copy(this.object.position),ah.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ah.direction))<y1?this.object.lookAt(this.target):(o0.setFromNormalAndCoplanarPoint(this.object.up,this.target),ah.intersectPlane(o0,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>uf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>uf||this._lastTargetPosition.distanceToSquared(this.target)>uf?(this.dispatchEvent(a0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?mi/60*this.autoRotateSpeed*t:mi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ve.setFromMatrixColumn(e,0),Ve.multiplyScalar(-t),this._panOffset.add(Ve)}_panUp(t,e){this.screenSpacePanning===!0?Ve.setFromMatrixColumn(e,1):(Ve.setFromMatrixColumn(e,0),Ve.crossVectors(this.object.up,Ve)),Ve.multiplyScalar(t),this._panOffset.add(Ve)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ve.copy(s).sub(this.target);let r=Ve.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,a=i.width,o=i.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(mi*this._rotateDelta.x/e.clientHeight),this._rotateUp(mi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-mi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(mi*this._rotateDelta.x/e.clientHeight),this._rotateUp(mi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(t.pageX+e.x)*.5,o=(t.pageY+e.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new it,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function v1(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function _1(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function b1(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(l0),this.state=pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function w1(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ji.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=pe.DOLLY;break;case Ji.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=pe.ROTATE}break;case Ji.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=pe.PAN}break;default:this.state=pe.NONE}this.state!==pe.NONE&&this.dispatchEvent(ff)}function M1(n){switch(this.state){case pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function S1(n){this.enabled===!1||this.enableZoom===!1||this.state!==pe.NONE||(n.preventDefault(),this.dispatchEvent(ff),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(l0))}function A1(n){this.enabled!==!1&&this._handleKeyDown(n)}function E1(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Qi.ROTATE:if(this.enableRotate===!1){this.state=pe.NONE;break}this._handleTouchStartRotate(n),this.state=pe.TOUCH_ROTATE;break;case Qi.PAN:if(this.enablePan===!1){this.state=pe.NONE;break}this._handleTouchStartPan(n),this.state=pe.TOUCH_PAN;break;default:this.state=pe.NONE}break;case 2:switch(this.touches.TWO){case Qi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=pe.TOUCH_DOLLY_PAN;break;case Qi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=pe.TOUCH_DOLLY_ROTATE;break;default:this.state=pe.NONE}break;default:this.state=pe.NONE}this.state!==pe.NONE&&this.dispatchEvent(ff)}function T1(n){switch(this._trackPointer(n),this.state){case pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=pe.NONE}}function C1(n){this.enabled!==!1&&n.preventDefault()}function R1(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function P1(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var pf=[.35,1.2],I1="5.0",N1=.6;function L1(){let n=new fi({color:"#ffffff"});return n.userData={stripe:{value:new kt}},n.onBeforeCompile=t=>{Object.assign(t.uniforms,n.userData),t.vertexShader=`attribute float hatch;
varying float vHatch;
varying float vAlong;
${t.vertexShader}`.replace("#include <begin_vertex>",`#include <begin_vertex>
      vHatch = hatch;
      vAlong = position.y * length(instanceMatrix[1].xyz) / (${I1} * max(length(instanceMatrix[0].xyz), length(instanceMatrix[2].xyz)));`),t.fragmentShader=`varying float vHatch;
varying float vAlong;
uniform vec3 stripe;
${t.fragmentShader}`.replace("#include <color_fragment>",`#include <color_fragment>
if (vHatch > 0.5 && fract(vAlong) < 0.4) diffuseColor.rgb = stripe;`)},n}function mf(n){return n.material=L1(),n.geometry.setAttribute("hatch",new rs(new Float32Array(n.instanceMatrix.count),1)),n}var lh=class{constructor(t,e=[]){this.size={value:new it(1,1)},this.width={value:pf[1]},[this.material,this.sides]=["","if (abs(normal.y) > 0.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);"].map(i=>this.outline(i)),this.meshes=t.filter(i=>i.count).map(i=>{let s=new Zi(i.geometry,e.includes(i)?this.sides:this.material,i.count);return s.instanceMatrix=i.instanceMatrix,s.frustumCulled=!1,s})}outline(t){let e=new Yi({side:Be});return e.customProgramCacheKey=()=>`rim ${t}`,e.onBeforeCompile=i=>{Object.assign(i.uniforms,{rimSize:this.size,rimWidth:this.width}),i.vertexShader=`uniform vec2 rimSize;
uniform float rimWidth;
${i.vertexShader}`.replace("#include <project_vertex>",`#include <project_vertex>
        vec3 rimNormal = mat3(modelViewMatrix) * mat3(instanceMatrix) * normal;
        vec2 rimAway = (projectionMatrix * vec4(rimNormal, 0.0)).xy * rimSize;
        gl_Position.xy += rimAway / max(length(rimAway), 1e-20) * 2.0 * rimWidth / rimSize * gl_Position.w;
        ${t}`)},e}setColour(t){for(let e of[this.material,this.sides])e.color.set(t)}setScale(t){this.width.value=Math.min(Math.max(N1*t,pf[0]),pf[1])}resize(t,e){this.size.value.set(t,e)}};var c0=new kt(Ke.driven),D1=.3,k1=new kt(lp);function O1(n){let t=.011*n.length0,e=.05*n.length0;return Float32Array.from(n.arrays.radius.data,i=>Math.min(e,Math.max(t,i||0)))}function U1(n,t){let e=n.arrays.box?.data;return n.members.map((i,s)=>{let r=e?[e[2*s],e[2*s+1]]:[NaN];if(!r.every(o=>o>0)||n.active.has(s))return null;let a=t[s]/Math.max(...r);return r.map(o=>Math.max(a*o,.2*t[s]))})}var hh=class{constructor(t){this.scene=t,this.radius=O1(t);let e=t.members.length>800;this.pieces=t.members.flatMap((a,o)=>t.active.has(o)?[[o,"base"],[o,"tube"],[o,"screw"]]:t.curves.row.has(o)?Array.from({length:t.curves.places-1},(l,c)=>[o,"beam",c]):[[o,t.header.kinds[o]]]),this.box=U1(t,this.radius);let i=this.pieces.filter(([a])=>this.box[a]),s=this.pieces.filter(([a])=>!this.box[a]);this.pieces=[...s,...i],this.round=s.length,this.firstPiece=[],this.pieces.forEach(([a],o)=>this.firstPiece[a]??=o),this.marks=t.members.flatMap((a,o)=>G1(t,o)),this.rods=mf(ms(s.length,e?6:14)),this.boxes=mf(wg(i.length)),this.collars=ms(this.marks.length,e?6:18),this.balls=Ic(t.nodes.length,e?1:3,"#ffffff"),this.small=B1(t),this.lines=z1(this.pieces.length),this.ball=1.55*this.radius.reduce((a,o)=>Math.min(a,o),.02*t.length0);let r=new kt("#ffffff");this.pieces.forEach((a,o)=>this.at(o).mesh.setColorAt(this.at(o).index,r)),this.marks.forEach((a,o)=>this.collars.setColorAt(o,a.colour)),this.paintNodes("#5b6672"),this.rims=new lh([this.rods,this.boxes,this.collars,this.balls],[this.rods,this.boxes])}objects(){return[this.rods,this.boxes,this.collars,this.balls,this.lines,...this.rims.meshes]}at(t){return t<this.round?{mesh:this.rods,index:t}:{mesh:this.boxes,index:t-this.round}}setTheme({node:t,outline:e,back:i}){this.paintNodes(t),this.rims.setColour(e);for(let{material:s}of[this.rods,this.boxes])s.userData.stripe.value.set(i)}setScale(t){this.rims.setScale(t);let e=t>D1;for(let i of[this.rods,this.boxes,this.collars,this.balls,...this.rims.meshes])i.visible=e}resize(t,e){this.rims.resize(t,e)}place(t,e){let{scene:i,radius:s}=this,r=i.arrays.rods.data,a=this.lines.geometry.attributes.position,o=new Map;for(let l of i.curves.row.keys())o.set(l,{pieces:F1(Ni(i.curves.points(t,l)),.3*s[l]),across:i.curves.across(t,l)});this.pieces.forEach(([l,c,h],d)=>{let[u,f]=o.get(l)?.pieces[h]||[t[i.ends[2*l]],t[i.ends[2*l+1]]],p=i.shows(l)?s[l]:0;a.array.set(u,6*d),a.array.set(p?f:u,6*d+3),d>=this.round&&p?Sg(this.boxes,d-this.round,u,f,o.get(l)?.across[h]||Xa(i,e,l).axes[1],this.box[l]):c==="base"?Li(this.rods,d,u,yr(u,f,Math.min(r[6*l+1],ch(u,f))),.75*p):c==="tube"?Li(this.rods,d,yr(f,u,Math.min(r[6*l+4],ch(u,f))),f,1.5*p):Li(this.rods,d,u,f,c==="free"||c==="screw"||c==="cable"?.35*p:c==="elastic"?.7*p:p)}),this.marks.forEach((l,c)=>{let h=t[i.ends[2*l.member]],d=t[i.ends[2*l.member+1]],u=ch(h,d),f=s[l.member],p=l.nut?Math.max(0,u-r[6*l.member+4]):l.place*u,y=l.half*f;Li(this.collars,c,yr(h,d,p-y),yr(h,d,p+y),l.width*f)}),t.forEach((l,c)=>hr(this.balls,c,l,this.ball*this.small[c])),a.needsUpdate=!0,[this.rods,this.boxes,this.collars,this.balls].forEach(Vn)}paint(t,e){let i=new kt,s=this.lines.geometry.attributes.color;this.pieces.forEach(([r],a)=>{let[o,l,c]=t(r),{mesh:h,index:d}=this.at(a);h.setColorAt(d,i.setRGB(o/255,l/255,c/255,"srgb")),h.geometry.attributes.hatch.array[d]=e(r)?1:0;for(let u of[0,1])i.toArray(s.array,6*a+3*u)}),s.needsUpdate=!0;for(let r of[this.rods,this.boxes])r.geometry.attributes.hatch.needsUpdate=!0,r.instanceColor&&(r.instanceColor.needsUpdate=!0)}hatchOf(t){let{mesh:e,index:i}=this.at(this.firstPiece[t]);return e.geometry.attributes.hatch.array[i]===1}paintNodes(t){let e=new kt(t);for(let i=0;i<this.scene.nodes.length;i++)this.balls.setColorAt(i,e);this.balls.instanceColor&&(this.balls.instanceColor.needsUpdate=!0)}colourOf(t){let e=new kt,{mesh:i,index:s}=this.at(this.firstPiece[t]);i.getColorAt(s,e);let{r,g:a,b:o}=e.getRGB({r:0,g:0,b:0},"srgb");return[r,a,o].map(l=>Math.round(255*l))}};function F1(n,t){return n.map(([e,i],s)=>[s?yr(e,i,-t):e,s<n.length-1?yr(i,e,-t):i])}function B1(n){let t=new Float32Array(n.nodes.length).fill(1),e=new Set(n.ends),i=new Set(n.skin);for(let s of i)e.has(s)||(t[s]=i.size>300?0:.6);for(let s of n.directors)t[s]=0;return t}function z1(n){let t=new Se;for(let i of["position","color"])t.setAttribute(i,new De(new Float32Array(6*n),3));let e=new Pi(t,new ui({vertexColors:!0}));return e.frustumCulled=!1,e}function G1(n,t){if(n.active.has(t))return[{member:t,nut:!0,half:1.6,width:2.2,colour:c0}];let e=n.header.kinds[t];return e==="driven"?[{member:t,place:.5,half:2.2,width:1.8,colour:c0}]:e!=="elastic"?[]:[.3,.4,.5,.6,.7].map(i=>({member:t,place:i,half:.3,width:1.7,colour:k1}))}function ch(n,t){return Math.hypot(t[0]-n[0],t[1]-n[1],t[2]-n[2])}function yr(n,t,e){let i=e/(ch(n,t)||1);return[n[0]+i*(t[0]-n[0]),n[1]+i*(t[1]-n[1]),n[2]+i*(t[2]-n[2])]}var V1="#ffb000",dh=class{constructor(t){this.bars=t,this.group=new Fe;let e=new Yi({color:V1,side:Be});this.bar=new Zi(new xn(1,1,1,18,1,!0),e,Math.max(1,t.scene.curves.places-1)),this.ball=new Zi(new os(1,3),e,1);for(let i of[this.bar,this.ball])i.frustumCulled=i.visible=!1,this.group.add(i)}place(t,e){let{bars:i}=this;if(this.bar.visible=e?.type==="member",this.ball.visible=e?.type==="node",this.bar.visible){let{active:s,curves:r}=i.scene,a=e.index,o=Ni(r.points(t,a)),l=i.radius[a]*(s.has(a)?2.9:1.9);o.forEach(([c,h],d)=>Li(this.bar,d,c,h,l)),this.bar.count=o.length}this.ball.visible&&hr(this.ball,0,t[e.index],1.7*i.ball),[this.bar,this.ball].forEach(Vn)}};var h0=24,uh=class{constructor(t,e){this.scene=t,this.group=new Fe,this.material=new fi({side:ri,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),this.ink=new ui({}),this.plates=t.header.bodies.map((s,r)=>this.plate(s,e,r)),this.hulls=t.header.solids||[];let i=new Se;i.setAttribute("position",new De(new Float32Array(9*this.hulls.length),3)),this.hull=new Ne(i,this.material),this.hull.frustumCulled=!1,this.group.add(this.hull)}setTheme({body:t,outline:e}){this.material.color.set(t),this.ink.color.set(e)}plate(t,e,i){let s=this.scene.length(0,t.member),r=1.9*e,a=.5*e,o=H1([[0,0],[s,0],t.center],r),l=new xa(new tr(o.map(([h,d])=>new it(h,d))),{depth:a,bevelEnabled:!1,steps:1});l.translate(0,0,-a*(.5+.02*i));let c=new Fe;return c.add(new Ne(l,this.material),new Pi(new la(l,50),this.ink)),this.group.add(c),{body:t,plate:c}}place(t){let{scene:e}=this;for(let{body:s,plate:r}of this.plates){let a=t[e.ends[2*s.member]],o=t[e.ends[2*s.member+1]];r.position.set(...a),r.rotation.z=Math.atan2(o[1]-a[1],o[0]-a[0])}if(!this.hulls.length)return;let{position:i}=this.hull.geometry.attributes;this.hulls.forEach((s,r)=>s.forEach((a,o)=>i.array.set(t[a],9*r+3*o))),i.needsUpdate=!0,this.hull.geometry.computeVertexNormals()}};function H1(n,t){let e=n.flatMap(([s,r])=>Array.from({length:h0},(a,o)=>{let l=2*Math.PI*o/h0;return[s+t*Math.cos(l),r+t*Math.sin(l)]}));e.sort((s,r)=>s[0]-r[0]||s[1]-r[1]);let i=s=>{let r=[];for(let a of s){for(;r.length>1&&W1(r[r.length-2],r[r.length-1],a)<=0;)r.pop();r.push(a)}return r.slice(0,-1)};return[...i(e),...i(e.reverse())]}function W1(n,t,e){return(t[0]-n[0])*(e[1]-n[1])-(t[1]-n[1])*(e[0]-n[0])}var gf=104,$1=[["x",[1,0,0],"#c0392b"],["y",[0,1,0],"#2e8b57"],["z",[0,0,1],"#2f6fc1"]],fh=class{constructor(t){this.world=new ns,this.camera=new Je(30,1,.1,20);let e=new ls("#ffffff",1.5);e.position.set(1,-2,3),this.world.add(new cs("#ffffff",1.8),e),this.letters=$1.slice(0,t.dim).map(([i,s,r])=>this.add(i,s,r,.05)),this.gravity=this.add("g",[0,0,1],"#8a949e",.07),this.letters.push(this.gravity),this.setGravity(t.header.gravity)}add(t,e,i,s){let r=Ba(i),a=new ia(new Zs({depthTest:!1}));return dr(r,[0,0,0],e,s),a.position.set(...e.map(o=>1.27*o)),a.scale.setScalar(.44),this.world.add(r,a),{name:t,letter:a,one:r}}setGravity(t){let e=[0,1,2].map(a=>t[a]||0),i=Math.hypot(...e),{one:s,letter:r}=this.gravity;r.visible=i>0,this.pull=new I(...e).multiplyScalar(1.08/(i||1)),dr(s,[0,0,0],e.map(a=>.85*a/(i||1)),.07)}setTheme(t){for(let{name:e,letter:i}of this.letters)i.material.map?.dispose(),i.material.map=X1(e,qe[t].ink),i.material.needsUpdate=!0}render(t,e){let i=t.getPixelRatio(),s=t.domElement,r=s.width/i;this.camera.position.set(0,0,5.6).applyQuaternion(e.quaternion),this.camera.quaternion.copy(e.quaternion);let a=new I(-.95,0,0).applyQuaternion(e.quaternion);this.gravity.one.position.copy(a),this.gravity.letter.position.copy(this.pull).add(a),t.setViewport(r-gf-4,4,gf,gf),t.clearDepth(),t.render(this.world,this.camera),t.setViewport(0,0,r,s.height/i)}};function X1(n,t){let e=document.createElement("canvas");e.width=e.height=64;let i=e.getContext("2d");return i.font="600 46px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle",i.fillStyle=t,i.fillText(n,32,34),new ra(e)}var q1=.8,j1=2e4,Y1=104;function xf({scene:n,loads:t,supports:e,beside:i=[]}){let s=[...i],r=Math.max(1,Math.ceil(n.frames*n.nodes.length/j1)),a=n.frames-1;for(let o=0;o<=a;o=o<a?Math.min(o+r,a):o+1){for(let l=0;l<n.nodes.length;l++)n.directors.has(l)||s.push(n.position(o,l));s.push(...t.tips(o),...e.feet(o))}return s}function yf({scene:n,camera:t,canvas:e},i,s,r=q1,a=Y1){let o=new I().crossVectors(t.up,i);o.length()<.001&&o.set(1,0,0),o.normalize();let l=new I().crossVectors(i,o),c=Math.tan(t.fov*Math.PI/360),h=t.aspect,d=Math.min(a/(e.clientHeight||1e3),.25),u=c*h*r,f=c*(r-d),p=s.map(w=>{let b=new I(...w);return[b.dot(o),b.dot(l),b.dot(i)]}),y=[0,1,2].map(w=>(p.reduce((b,T)=>Math.min(b,T[w]),1/0)+p.reduce((b,T)=>Math.max(b,T[w]),-1/0))/2),m=n.extent.size;for(let w=0;w<4;w++){m=p.reduce((b,[T,A,v])=>Math.max(b,Math.abs(T-y[0])/u+v-y[2],Math.abs(A-y[1])/f+v-y[2]),.05*n.extent.size);for(let b of[0,1]){let T=p.map(A=>(A[b]-y[b])/(m-A[2]+y[2]));w<3&&(y[b]+=m*(T.reduce((A,v)=>Math.min(A,v),1/0)+T.reduce((A,v)=>Math.max(A,v),-1/0))/2)}}let x=p.reduce((w,b)=>Math.max(w,(b[1]-y[1])/(m-b[2]+y[2])/c),0);return y[1]+=Math.max(0,x-r+2*d)*c*m,{centre:new I().addScaledVector(o,y[0]).addScaledVector(l,y[1]).addScaledVector(i,y[2]),far:m}}function d0(){return!!document.createElement("canvas").getContext("webgl2")}var vr=class extends ur{constructor(t,e,i,s=e.members.length<2e3){super(t,e),this.renderer=new Ac({canvas:t,antialias:s,preserveDrawingBuffer:!0}),this.renderer.autoClear=!1,this.world=new ns,this.camera=new Je(32,1,e.extent.size/500,e.extent.size*60),this.camera.up.set(0,e.dim===2?1:0,e.dim===2?0:1),this.lamp=new ls("#ffffff",2.1),this.lampPlace=[-.35,.6,1],this.ambient=new cs("#ffffff",1.45),this.world.add(this.ambient,this.lamp),this.controls=new oh(this.camera,t),e.dim===2&&(this.controls.enableRotate=!1,this.controls.mouseButtons.LEFT=Ji.PAN,this.controls.touches.ONE=Qi.PAN),this.controls.addEventListener("change",()=>this.onCamera?.(this)),this.triad=new fh(e),this.build(),this.setTheme(i),this.aim(e.dim===2?"plane":"corner"),this.setFrame(0)}build(){let{scene:t,world:e}=this,i=.1*t.length0;this.bars=new hh(t),this.supports=new Dc(t),this.loads=new za(t,.9*i),this.drives=new kc(t,i),this.bodies=new uh(t,this.bars.ball),this.traces=new fr(t),this.centres=new Uc(t,.25*i),this.faces=new Oc(t,t.header.triangles,.35),this.faces.mesh.visible=!1,this.skins=new Rc(t),this.halo=new dh(this.bars),Object.assign(this,Rg(t)),this.ghost=Pg(t),this.ghost.visible=!1,e.add(...this.bars.objects(),this.supports.mesh,this.loads.group,this.drives.group,this.bodies.group,this.centres.mesh,this.faces.mesh,this.traces.group,...this.skins.objects(),this.halo.group,this.grid,this.ghost)}rebuildLoads(){this.world.remove(this.loads.group),this.loads=new za(this.scene,.09*this.scene.length0),this.world.add(this.loads.group),this.triad.setGravity(this.scene.header.gravity)}setTheme(t){this.renderer.setClearColor(new kt(qe[t].back));for(let e of[this.bars,this.supports,this.bodies,this.traces])e.setTheme(qe[t]);this.skins.setTheme(t),this.triad.setTheme(t),this.paint()}move(){this.now=this.points(),[this.bars,this.supports,this.drives,this.bodies,this.centres,this.faces,this.skins].forEach(t=>t.place(this.now,this.frame)),this.loads.place(this.now,this.frame),this.halo.place(this.now,this.picked),this.request()}pick(t){this.picked=t,this.halo.place(this.now,t),this.request()}paint(){this.bars.paint(t=>this.shade(t),t=>this.hatched(t)),this.skins.paint(this.channel,this.frame,this.limits),this.request()}showTraces(t){this.traces.show(t),this.request()}aim(t){let{scene:e,camera:i,controls:s}=this,r=new I(...Fc[t]).normalize(),{centre:a,far:o}=yf(this,r,xf(this));i.position.copy(a).addScaledVector(r,o),s.target.copy(a),s.update(),this.preset=t,this.request()}orbit(t,e,i){let{camera:s,controls:r}=this,a=s.position.clone().sub(r.target);a.applyAxisAngle(s.up,t);let o=new I().crossVectors(s.up,a).normalize(),l=a.clone().applyAxisAngle(o,-e);Math.abs(l.clone().normalize().dot(s.up))<.995&&a.copy(l),s.position.copy(r.target).addScaledVector(a,i),r.update(),this.request()}copyCamera(t){this.camera.position.copy(t.camera.position),this.controls.target.copy(t.controls.target),this.camera.lookAt(this.controls.target),this.request()}resize(){let{clientWidth:t,clientHeight:e}=this.canvas;!t||!e||(this.renderer.setPixelRatio(Math.min(window.devicePixelRatio,2)),this.renderer.setSize(t,e,!1),this.bars.resize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),!this.sized&&this.preset&&this.aim(this.preset),this.sized=!0,this.request())}end(){this.ended=!0,this.controls.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss()}render(){if(cancelAnimationFrame(this.waiting),this.waiting=0,this.ended)return;let{renderer:t,camera:e}=this;this.lamp.position.set(...this.lampPlace).applyQuaternion(e.quaternion);let i=e.position.distanceTo(this.controls.target),s=2*i*Math.tan(e.fov*Math.PI/360)/this.canvas.clientHeight;this.bars.setScale(this.bars.ball/1.55/s),t.clear(),t.render(this.world,e),this.triad.render(t,e),this.drawn=(this.drawn||0)+1,this.onDrawn?.(this)}project(t){let{clientWidth:e,clientHeight:i}=this.canvas,s=new I(...t).project(this.camera);return[(s.x+1)/2*e,(1-s.y)/2*i,s.z]}};var ph=24,Z1=.08;function K1(n){return n.header.triangles.length>0&&n.arrays.radius.data.every(Number.isNaN)}var Hn=class extends xr{constructor(t,e,i=[],s=null){super(),Object.assign(this,{root:t,side:s,ended:new AbortController}),Object.assign(this,{channel:null,limits:[0,1],picked:null,mode:-1,labels:i}),this.shown={ghost:!1,names:e[0].nodes.length<=12,loads:!0,supports:!0,grid:!0,faces:e.every(K1),paths:!1},this.paths=new Set,this.touch=matchMedia("(hover: none)").matches,this.theme=t.dataset.theme||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"),t.dataset.theme=this.theme,this.setLead(e.reduce((o,l)=>l.time[l.frames-1]>o.time[o.frames-1]?l:o));let r=e.map((o,l)=>g("canvas",{tabindex:0,role:"img","aria-label":`picture of ${i[l]||o.header.title||"the model"}`}));this.diagram=null,this.offered=[...new Map(e.flatMap(o=>o.header.shows||[]).map(o=>[o.id,o])).values()],this.flat=!d0();let a=this.flat?Vc:vr;this.views=e.map((o,l)=>new a(r[l],o,this.theme)),this.layout(r),this.wire(),Xg(this,t.ownerDocument,this.ended.signal),this.setChannel(e[0].header.channels[0]?.id||""),this.table.show(),this.pick(null),this.apply(),this.goTo(0)}hint(t,e){return this.touch?t:`${t} (${e})`}layout(t){let{views:e}=this;this.bar=new sh(this),this.verdict=new rh(this),this.time=new mr(this),this.legend=new Jc(this),this.inspector=new Zc(this),this.table=new nh(this),this.names=e.map(s=>new th(s)),this.over=e.map(s=>new ih(s));let i=t.map((s,r)=>g("div",{class:"pane"},s,this.over[r].node,this.names[r].node,e.length>1?g("div",{class:"label"},this.labels[r]):null,g("div",{class:"scale"},`grid ${St(e[r].step,"m")}`)));this.told=g("p",{class:"told",role:"note","aria-live":"polite"}),this.panel=g("aside",{class:"panel"},this.inspector.node,this.table.node),this.stage=g("div",{class:"stage"},g("div",{class:"panes"},i),this.legend.node,g("div",{class:"said"},this.flat?g("p",{class:"note"},"This browser has no WebGL: a plain picture, turned by the buttons."):null,this.told)),this.help=qg(this),this.root.replaceChildren(this.bar.node,this.verdict.node,g("main",{},this.side,this.stage,this.panel),this.time.node,this.help)}wire(){let t=new ResizeObserver(()=>this.resize());this.ended.signal.addEventListener("abort",()=>t.disconnect()),this.views.forEach((e,i)=>{t.observe(e.canvas.parentElement),e.onCamera=()=>this.follow(e),e.onDrawn=()=>{this.over[i].place(this.diagram),this.names[i].place(this.shown.names,this.over[i].boxes)};let s=null;e.canvas.addEventListener("pointerdown",r=>s=[r.clientX,r.clientY]),e.canvas.addEventListener("pointerup",r=>{s&&Math.hypot(r.clientX-s[0],r.clientY-s[1])<5&&this.click(e,r),s=null})}),this.resize()}refresh(){for(let e of this.views)e.scene.renew();this.verdict.update();let{channel:t}=this;t&&Rr(t.scale,this.views.map(i=>i.scene.range(t.id))).some((i,s)=>i!==this.limits[s])&&this.setChannel(t.id),this.goTo(this.index)}end(){this.playing=!1,this.mode=-1,this.ended.abort();for(let t of this.views)t.end()}resize(){this.views.forEach(t=>t.resize()),this.inspector.update()}goTo(t){this.index=Math.min(Math.max(Math.round(t),0),this.lead.frames-1);let e=this.lead.time[this.index];for(let i of this.views)i.setFrame(i.scene===this.lead?this.index:i.scene.frameAt(e));this.time.update(),this.inspector.update(),this.table.update()}toWorst(){let{lead:t,channel:e}=this;if(!e||!t.channel(e.id))return;let i=[-1,0];for(let s=0;s<t.frames;s++){for(let r=0;r<t.members.length;r++){let a=Math.abs(t.value(e.id,s,r));a>i[0]&&(i=[a,s])}for(let r=0;t.coloursFaces(e.id)&&r<t.faces;r++){let a=t.faceValue(e.id,s,r);a>i[0]&&(i=[a,s])}}this.pause(),this.goTo(i[1])}setChannel(t){let e=this.views.map(i=>i.scene).filter(i=>i.channel(t));this.channel=e.length?e[0].channel(t):null,this.channel&&(this.limits=Rr(this.channel.scale,e.map(i=>i.range(t))));for(let i of this.views)i.setColours(this.channel,this.limits);this.legend.show(),this.bar.update(),this.views.length>1&&this.table.show(),this.inspector.update()}setDiagram(t){let e=this.offered.find(a=>a.id===t)||null;this.diagram=e,this.views.forEach((a,o)=>{a.beside=this.over[o].reach(e);let{clientWidth:l,clientHeight:c}=a.canvas,[h]=cf(this.over[o].node),d=([u,f])=>h&&u<h[2]&&f<h[3]||u<ph||f<ph||u>l-ph||f>c-ph;a.beside.some(u=>d(a.project(u)))&&a.aim(a.preset),a.request()});let i=e?.id==="deflection"?`, drawn ${this.over.map(a=>Kt(a.factor(e))).join(" and ")} times as large`:"",s=e?[...new Set(this.views.flatMap(({scene:a,frame:o})=>Jg(a,o,e)))]:[],r=s.length?`; not known of ${s.slice(0,4).join(", ")}${s.length>4?` and ${s.length-4} more`:""}`:"";this.told.textContent=e?`${e.label}: ${e.sign}${i}${r}.`:"",this.bar.update()}nextDiagram(t){let e=["",...this.offered.map(i=>i.id)];this.setDiagram(e[(e.indexOf(this.diagram?.id||"")+t+e.length)%e.length])}setCase(t){for(let e of this.views)e.scene.choose(t)&&e.rebuildLoads();this.setChannel(this.channel?.id||""),this.apply(),this.inspector.show(),this.goTo(this.index),this.diagram&&this.setDiagram(this.diagram.id)}nextCase(){let{cases:t,header:e}=this.views[0].scene;t.length>1&&this.setCase(t[(t.indexOf(e.load_case)+1)%t.length])}nextChannel(t){let e=["",...this.views[0].scene.header.channels.map(s=>s.id)],i=e.indexOf(this.channel?.id||"");this.setChannel(e[(i+t+e.length)%e.length])}setMode(t){let{modes:e}=this.views[0].scene.header;this.mode=t<e.length?t:-1;let i=this.views[0],s=this.mode>=0;if(i.mode=s?{array:e[this.mode].array,size:0}:null,this.bar.update(),i.move(),!s)return;let a=i.scene.arrays[i.mode.array].data.reduce((h,d)=>Math.max(h,Math.abs(d)),0)||1,o=performance.now(),l=this.mode,c=h=>{this.mode===l&&(i.mode.size=Z1*i.scene.extent.size/a*Math.sin((h-o)/1e3*2.5),i.move(),i.render(),requestAnimationFrame(c))};requestAnimationFrame(c)}nextMode(){let t=this.views[0].scene.header.modes.length;t&&this.setMode(this.mode+1<t?this.mode+1:-1)}toggle(t){this.shown[t]=!this.shown[t],this.apply()}apply(){for(let t of this.views)t.ghost.visible=this.shown.ghost,t.loads.group.visible=this.shown.loads,t.supports.mesh.visible=this.shown.supports,t.grid.visible=this.shown.grid,t.faces.mesh.visible=this.shown.faces,t.showTraces(this.tracedIn(t)),t.canvas.parentElement.classList.toggle("gridless",!this.shown.grid),t.request();this.bar.update()}togglePanel(){this.root.classList.toggle("wide"),this.resize()}toggleTheme(){this.theme=this.theme==="dark"?"light":"dark",this.root.dataset.theme=this.theme;for(let t of this.views)t.setTheme(this.theme);this.inspector.update()}toggleHelp(){this.help.hidden=!this.help.hidden,this.help.hidden?this.before?.focus?.():(this.before=this.root.ownerDocument.activeElement,this.help.querySelector("button").focus())}pick(t){this.picked=t;for(let e of this.views){let i=t?this.indexIn(e,t):-1;e.pick(i<0?null:{type:t.type,index:i})}this.panel.classList.toggle("picked",!!t),this.inspector.show(),this.table.mark(),this.onPick?.(t)}indexIn(t,e){return t.scene[e.type==="member"?"members":"nodes"].indexOf(e.name)}click(t,e){let i=t.canvas.getBoundingClientRect(),s=t.pickAt(e.clientX-i.left,e.clientY-i.top,e.pointerType==="touch");this.pick(s&&{type:s.type,name:t.scene[`${s.type}s`][s.index]})}pickNext(t,e){let i=this.views[0].scene[`${t}s`];if(!i.length)return;let s=this.picked?.type===t?i.indexOf(this.picked.name):e>0?-1:0;this.pick({type:t,name:i[(s+e+i.length)%i.length]})}pickWorst(){let{scene:t,frame:e}=this.views[0];if(!this.channel)return;let i=[-1,0];t.members.forEach((s,r)=>{let a=Math.abs(t.value(this.channel.id,e,r));a>i[0]&&(i=[a,r])}),t.members.length&&this.pick({type:"member",name:t.members[i[1]]})}toggleTrace(){if(this.picked?.type!=="node"||this.lead.frames<2)return;let{name:t}=this.picked;this.paths.delete(t)||this.paths.add(t),this.apply(),this.inspector.update()}tracedIn(t){return this.shown.paths&&(t.moving??=Bc(t.scene)),new Set([...this.shown.paths?t.moving:[],...[...this.paths].map(e=>t.scene.nodes.indexOf(e)).filter(e=>e>=0)])}find(){this.root.classList.remove("wide"),this.table.filter.focus()}escape(){this.help.hidden?this.pick(null):this.toggleHelp()}aim(t){for(let e of this.views)e.aim(e.scene.dim===2?"plane":t)}orbit(t,e,i){let s=this.views[0].scene.dim===3;this.views[0].orbit(s?t:0,s?e:0,i)}follow(t){t.request();for(let e of this.views)e!==t&&e.copyCamera(t)}diagrams(t,e=0){let{scene:i,frame:s}=this.views[e];return Qu(i,s,i.members.indexOf(t))}freeBody(t,e=0){let{scene:i,frame:s}=this.views[e];return Yc(i,s,i.members.indexOf(t))}};var mh=class{constructor(t){Object.assign(this,{show:t,words:"",timer:0})}wait(t,e){let i=performance.now()-e;e===this.since||this.words&&i>=200||(this.end(),this.since=e,this.timer=setTimeout(()=>this.say(t),Math.max(40,200-i)))}say(t){clearTimeout(this.timer),this.words=t,this.show(t)}end(){clearTimeout(this.timer),this.since=null,this.words&&this.say("")}};var J1=2e3,Q1="The studio does not answer. Start it again, and open the address that it prints.";function gh(n){let t=new DataView(n).getUint32(0,!0);return[JSON.parse(new TextDecoder().decode(new Uint8Array(n,4,t))),new Uint8Array(n,4+t)]}var _r=class{constructor(t){Object.assign(this,{root:t,waiting:null,queue:[],wanted:null,closed:!1}),this.doing=g("p",{class:"busy",hidden:!0}),this.busy=new mh(e=>this.showBusy(e))}ask(t,e=performance.now()){return new Promise(i=>{this.queue.push({command:t,resolve:i,since:e}),this.pump()})}pump(){if(!this.waiting&&!this.closed){let t=this.hurried()||this.queue.shift()||this.leisurely();t&&(this.waiting={resolve:()=>{},since:performance.now(),...t},this.post(JSON.stringify(t.sent||t.command)))}this.watch()}hurried(){}leisurely(){}watch(){let t=this.waiting||this.queue[0];t?this.busy.wait("Computing ...",t.since):this.busy.end()}showBusy(t){this.doing.hidden=!t,this.doing.textContent=t,this.root.classList.toggle("awaiting",!!t)}async hear(t){let e=typeof t=="string"?JSON.parse(t):await this.unpacked(t);if(e.kind==="failed")return this.fail(e.message);if(e.kind==="busy"){(this.busy.words||!this.there)&&this.busy.say(e.text);return}if(this.heard(e))return this.pump();let{waiting:i}=this;if(this.waiting=null,e.kind==="computing")return this.busy.words&&this.busy.say(e.text),this.queue.push({...i,sent:{do:"motion",number:e.number}}),this.pump();i?.resolve(e),this.pump()}connect(){let t=this.page?`&page=${this.page}`:"",e=new WebSocket(`${location.origin.replace(/^http/,"ws")}${location.pathname}live?busy=1${t}`);e.binaryType="arraybuffer",e.addEventListener("open",()=>this.open(i=>e.send(i))),e.addEventListener("message",({data:i})=>this.hear(i)),e.addEventListener("close",()=>this.close())}fail(t,...e){window.kinetruss.failed=t,this.closed=!0,this.root.replaceChildren(g("div",{class:"failure"},g("p",{},t),...e)),this.root.dataset.state="failed"}close(){if(this.root.dataset.state!=="failed"){this.closed=!0;for(let{resolve:t}of[this.waiting,...this.queue].filter(Boolean))t({kind:"lost"});if(Object.assign(this,{waiting:null,queue:[],wanted:null}),this.busy.end(),!this.there)return this.fail(Q1);this.setEnded(!0),setTimeout(()=>this.connect(),J1)}}setEnded(t,e=this.root){e.classList.toggle("ended",t);for(let i of e.querySelectorAll("input, select, button, textarea"))i.disabled=t}};var tA="xyz",xh={azimuth:-Math.PI/2,elevation:Math.PI/2},u0={corner:[-.95,.5],top:[-Math.PI/2,Math.PI/2],front:[-Math.PI/2,0],side:[0,0]},eA=8,f0=44,vf=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],gi=n=>Number(n.toPrecision(12))||0,br=class{constructor(){Object.assign(this,{dim:2,centre:[0,0,0],scale:200,width:600,height:400,plane:{axis:2,at:0},step:null}),this.turnTo(xh.azimuth,xh.elevation)}setDim(t){if(t===this.dim)return;this.dim=t,this.plane={axis:2,at:0};let[e,i]=t===3?u0.corner:[xh.azimuth,xh.elevation];this.turnTo(e,i)}turnTo(t,e){this.azimuth=t,this.elevation=Math.min(Math.max(e,-Math.PI/2),Math.PI/2);let[i,s,r,a]=[Math.cos(t),Math.sin(t),Math.cos(this.elevation),Math.sin(this.elevation)].map(o=>Math.abs(o)<1e-15?0:o);this.right=[-s,i,0],this.up=[-a*i,-a*s,r],this.toward=[r*i,r*s,a]}turn(t,e){this.dim===3&&this.turnTo(this.azimuth+t,this.elevation+e)}look(t){this.turnTo(...u0[t])}face(){this.look({x:"side",y:"front",z:"top"}[tA[this.plane.axis]])}pan(t,e){this.centre=this.centre.map((i,s)=>i-(t*this.right[s]-e*this.up[s])/this.scale)}zoom(t,[e,i]=[this.width/2,this.height/2]){let[s,r]=[e-this.width/2,i-this.height/2];this.pan(-s,-r),this.scale=Math.min(Math.max(this.scale*t,.001),1e7),this.pan(s,r)}fit(t){if(!t.length){Object.assign(this,{centre:[0,0,0],scale:Math.min(this.width,this.height)/1.2});return}this.centre=[0,1,2].map(s=>(Math.min(...t.map(r=>r[s]||0))+Math.max(...t.map(r=>r[s]||0)))/2),this.scale=1;let e=t.map(s=>this.project(s)),i=[0,1].map(s=>Math.max(...e.map(r=>r[s]))-Math.min(...e.map(r=>r[s])));this.scale=Math.min(.62*this.width/(i[0]||1e-9),.62*this.height/(i[1]||1e-9),1e5),t.length===1&&(this.scale=Math.min(this.width,this.height)/1.2)}project(t){let e=[0,1,2].map(i=>(t[i]||0)-this.centre[i]);return[this.width/2+this.scale*vf(e,this.right),this.height/2-this.scale*vf(e,this.up),vf(e,this.toward)]}unproject([t,e],i=this.plane.at){let[s,r]=[(t-this.width/2)/this.scale,(this.height/2-e)/this.scale],a=this.centre.map((c,h)=>c+s*this.right[h]+r*this.up[h]),{axis:o}=this.plane;if(Math.abs(this.toward[o])<.08)return null;let l=(i-a[o])/this.toward[o];return a.map((c,h)=>h===o?i:c+l*this.toward[h])}get key(){return[this.scale,...this.centre,this.azimuth,this.elevation,this.width,this.height,this.plane.axis,this.plane.at].join()}get grid(){let t=Kn(f0/this.scale);return this.step||(t*this.scale<.6*f0?Kn(2.5*t):t)}snapped(t,e=[]){return t.map((i,s)=>{if(s===this.plane.axis)return i;let r=gi(Math.round(i/this.grid)*this.grid),a=e.reduce((o,l)=>Math.abs((l[s]||0)-i)<Math.abs(o-i)?l[s]||0:o,1/0);return Math.abs(a-i)*this.scale<eA&&Math.abs(a-i)<Math.abs(r-i)?a:r})}get across(){return[0,1,2].filter(t=>t!==this.plane.axis)}};var iA=34,nA=/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;function sA(n){let t=n.trim();return t?nA.test(t)?Number(t):t:null}function le(n,t,e,{hint:i="",size:s=9,name:r=n}={}){let a=g("input",{type:"text",size:s,"aria-label":r,placeholder:i,inputmode:"text",autocomplete:"off",spellcheck:"false"});a.dataset.size=s,qa(a,t??"");let o=()=>{delete a.dataset.dirty,e(sA(a.value),a.value.trim())};return a.addEventListener("input",()=>{a.dataset.dirty="yes",p0(a)}),a.addEventListener("change",o),a.addEventListener("blur",()=>a.isConnected&&a.dataset.dirty&&o()),a.addEventListener("keydown",l=>{l.key==="Enter"&&a.blur(),l.key==="Escape"&&(qa(a,t??""),delete a.dataset.dirty,a.blur())}),g("label",{class:"entry"},g("span",{},n),a)}function qa(n,t){n.value=t,p0(n)}function p0(n){n.size=Math.min(Math.max(Number(n.dataset.size)||1,n.value.length),iA)}function ye(n,t,e,i,s=n){let r=g("select",{"aria-label":s},t.map(a=>Array.isArray(a)?g("option",{value:a[0]},a[1]):g("option",{value:a},a)));return r.value=e??"",r.addEventListener("change",()=>i(r.value)),g("label",{class:"entry"},g("span",{},n),r)}function Wn(n,t,e,i=n){let s=g("input",{type:"checkbox","aria-label":i});return s.checked=t,s.addEventListener("change",()=>e(s.checked)),g("label",{class:"tick"},s,n)}function It(n,t,e={}){return g("button",{type:"button",onclick:t,...e},n)}function ve(n,...t){let{activeElement:e}=n.ownerDocument,i=n.contains(e)?e.getAttribute("aria-label")||e.textContent:null,s=i&&e.tagName==="INPUT"&&e.type==="text"&&e.dataset.dirty?e.value:null,r=s===null?null:e.selectionStart;if(n.replaceChildren(...t.flat(4).filter(Boolean)),!i)return;let a=[...n.querySelectorAll("input, select, button, textarea")].find(o=>(o.getAttribute("aria-label")||o.textContent)===i);a&&(a.focus({preventScroll:!0}),s!==null&&(qa(a,s),a.dataset.dirty="yes",a.setSelectionRange(r,r)))}var yh=class{constructor(t){this.draw=t,this.place=g("span",{}),this.grid=g("span",{}),this.outside=g("button",{type:"button",hidden:!0,onclick:()=>t.fit()}),this.node=g("div",{class:"readout"},this.place,this.grid,this.outside)}update(){let{draw:t}=this,{state:e,camera:i,rubber:s,cursor:r,pointed:a}=t,o=s?.to||r||a?.at,l=o&&`${a?.name&&!s?`${a.name}: `:""}${t.cut(o).map(d=>gi(d)).map(d=>Number(d.toPrecision(6))).join(", ")} m`,c=s?.from&&s.to&&Math.hypot(...s.to.map((d,u)=>d-s.from[u]));this.place.textContent=[l,c?`length ${St(c,"m")}`:""].filter(Boolean).join("; "),this.grid.textContent=`grid ${St(i.grid,"m")}`;let h=(t.canvas.seen||[]).filter(([d,u])=>d<0||u<0||d>i.width||u>i.height).length;this.outside.hidden=!h||!e?.nodes.length,this.outside.textContent=`${h} node${h===1?" is":"s are"} out of sight. Show all`}};function xs(n){let[,t,e="m"]=/^\s*([+-]?[\d.]+(?:e[+-]?\d+)?)\s*([a-z]+)?\s*$/i.exec(String(n??""))||[];return Number(t??NaN)*({m:1,cm:.01,mm:.001,in:.0254,ft:.3048}[e]??NaN)}var m0=14,rA=10;function vh({dim:n,places:t,lines:e,bodies:i=[],supports:s=[],turning:r=[],path:a=[]},o=148,l=104){let c=new br;Object.assign(c,{width:o,height:l}),c.setDim(n),c.fit([...t,...a]);let h=[...t,...a].map(x=>c.project(x)),d=x=>Math.max(...h.map(_=>_[x]))-Math.min(...h.map(_=>_[x]));c.scale*=Math.min((o-2*m0)/(d(0)||1e-9),(l-2*m0)/(d(1)||1e-9),1.6);let u=x=>c.project(x),f=t.map(u),p=(x,_)=>`M${x.map(([w,b])=>`${w.toFixed(1)} ${b.toFixed(1)}`).join("L")}${_?"Z":""}`,y=s.flatMap(({node:x,kind:_,along:w})=>wn({kind:_,along:w},[...t[x],0].slice(0,3),rA/c.scale).map((b,T)=>ht("path",{class:(_==="pin"||_==="roller")&&T===0?"hold":"hold line",d:p(b.map(u))}))),m=r.map(([x,_])=>{let[w,b]=[f[x],f[_]],T=Math.atan2(b[1]-w[1],b[0]-w[0]),A=v=>`${(w[0]+9*Math.cos(T+v)).toFixed(1)} ${(w[1]+9*Math.sin(T+v)).toFixed(1)}`;return ht("path",{class:"turn",d:`M${A(.5)}A9 9 0 1 1 ${A(-.5)}`})});return ht("svg",{class:"thumb",viewBox:`0 0 ${o} ${l}`,width:o,height:l,"aria-hidden":"true"},...y,...i.map(x=>ht("path",{class:"plate",d:p(x.map(_=>f[_]),!0)})),a.length?[ht("path",{class:"way",d:p(a.map(u))})]:[],...e.map(([x,_,w])=>ht("path",{class:w==="elastic"?"piece soft":"piece",style:`stroke: ${Ke[w]||Ke.rigid}`,d:p([f[x],f[_]])})),...m,...t.length>40?[]:f.map(([x,_])=>ht("circle",{class:"joint",cx:x.toFixed(1),cy:_.toFixed(1),r:2})))}var _f=5,g0=24,aA=18,oA=1e-9,_h=Math.PI/180,lA=["positions","path"],bh=(n,t)=>Math.hypot(n[0]-t[0],n[1]-t[1]);function cA(n,t){let e=n.reduce((i,s,r)=>[...i,r?i.at(-1)+bh(s,n[r-1]):0],[]);return Array.from({length:t},(i,s)=>{let r=e.at(-1)*s/(t-1),a=Math.max(1,e.findIndex(l=>l>=r-1e-12)),o=(r-e[a-1])/(e[a]-e[a-1]||1);return[0,1].map(l=>Number((n[a-1][l]+o*(n[a][l]-n[a-1][l])).toPrecision(6)))})}var wh=class{constructor(t){Object.assign(this,{draw:t,positions:[],path:[],closed:!1,length:0,fourBars:!0,sliders:!0,rows:[],told:"",begun:null}),this.body=g("div",{}),this.node=de("Ask for a linkage",this.body),this.node.open=!1}takes(t){return lA.includes(t)}begin(t,e,i){return this.node.open=!0,t==="path"?{kind:"ask",line:[this.draw.camera.unproject(e)],places:[e]}:i&&{kind:"ask",from:i.point}}move(t,e,i){t.line?(t.line.push(this.draw.camera.unproject(e)),t.places.push(e)):i&&(t.to=i.point),this.act=t,this.draw.canvas.update()}end(t){this.act=null,t.line&&t.line.length>3?(this.closed=bh(t.places[0],t.places.at(-1))<aA,this.path=cA(this.closed?[...t.line.slice(0,-1),t.line[0]]:t.line,g0+this.closed).slice(0,g0),this.positions=[]):t.to&&this.add(t.from,t.to),this.changed()}enter(t,e){this.node.open=!0,t==="path"?(this.path.push(e.slice(0,2)),this.positions=[]):this.begun?(this.add(this.begun,e),this.begun=null):this.begun=e,this.changed()}add(t,e){if(bh(t,e)){if(this.positions.length===_f)return this.draw.tell(`At most ${_f} positions: no four-bar takes more. Remove one first.`,!0);this.positions.length||(this.length=bh(t,e)),this.positions.push([t[0],t[1],gi(Math.atan2(e[1]-t[1],e[0]-t[0]))]),this.path=[]}}clear(){Object.assign(this,{positions:[],path:[],rows:[],told:"",begun:null,length:0}),this.changed()}changed(){this.draw.canvas.update(),this.rebuild()}place(t){let{camera:e}=this.draw,i=c=>e.project(c),s=(c,h)=>`M${c.map(([d,u])=>`${d.toFixed(1)} ${u.toFixed(1)}`).join("L")}${h?"Z":""}`,r=[],a=this.act?.line||this.path;if(a.length>1&&r.push(ht("path",{class:"way",d:s(a.map(i),this.closed&&!this.act)})),!this.act?.line)for(let c of this.path){let[h,d]=i(c);r.push(ht("circle",{class:"at",cx:h,cy:d,r:2.5}))}let o=this.length||60/e.scale,l=[...this.positions];if(this.act?.to&&l.push([...this.act.from.slice(0,2),Math.atan2(this.act.to[1]-this.act.from[1],this.act.to[0]-this.act.from[0])]),l.forEach(([c,h,d],u)=>{let f=i([c,h]),p=i([c+o*Math.cos(d),h+o*Math.sin(d)]),y=Math.atan2(p[1]-f[1],p[0]-f[0]),m=x=>[p[0]-10*Math.cos(y+x),p[1]-10*Math.sin(y+x)];r.push(ht("path",{class:"position",d:s([f,p])+s([m(.45),p,m(-.45)])}),ht("circle",{class:"at",cx:f[0],cy:f[1],r:4}),ht("text",{x:f[0]-14,y:f[1]+5},u+1))}),this.begun){let[c,h]=i(this.begun);r.push(ht("circle",{class:"at",cx:c,cy:h,r:4}))}t.replaceChildren(...r)}rebuild(){let{draw:t}=this,{state:e}=t;if(!e)return;if(e.dim!==2)return ve(this.body,g("p",{class:"faint"},"Linkages lie in the plane; this drawing is in space."));let i=this.positions.length?this.positions.length<3:this.path.length<4,s=(r,a)=>It(a,()=>t.setTool(r),{"aria-pressed":String(t.tool===r),"aria-label":`draw ${r}`});ve(this.body,g("p",{class:"faint"},"Draw three to five positions of a body, each from a point along its direction, or draw a path. Four-bars and slider-cranks that pass there are found."),g("div",{class:"row"},s("positions","Draw positions"),s("path","Draw a path"),It("Type a position",()=>this.type(),{disabled:this.positions.length===_f}),It("Clear",()=>this.clear(),{"aria-label":"clear the task"})),this.positions.map((r,a)=>this.position(r,a)),this.path.length||!this.positions.length?this.points():null,g("div",{class:"row"},Wn("four-bars",this.fourBars,r=>this.fourBars=r),Wn("slider-cranks",this.sliders,r=>this.sliders=r),It("Find linkages",()=>this.find(),{disabled:i||!!this.asking})),g("div",{class:"cards"},this.rows.map((r,a)=>this.card(r,a))),this.told?g("p",{role:"status",class:this.rows.length?"faint":"banner warning"},this.told):null)}position(t,e){let i=(s,r,a)=>{let o=r===null?NaN:a(r);Number.isFinite(o)?t[s]=o:this.draw.tell(`${s===2?"An angle is a number of degrees":"A place is a length: 0.1, 50 mm"}. Got ${r??"nothing"}.`,!0),this.changed()};return g("div",{class:"row"},g("b",{},e+1),["x","y"].map((s,r)=>le(s,Number(t[r].toPrecision(5)),a=>i(r,a,xs),{size:5,name:`${s} of position ${e+1}`})),le("deg",Number((t[2]/_h).toPrecision(4)),s=>i(2,s,r=>Number(r)*_h),{size:4,name:`angle of position ${e+1}`}),It("×",()=>{this.positions.splice(e,1),this.changed()},{"aria-label":`remove position ${e+1}`}))}type(){let t=this.positions.at(-1)||[0,0,0];this.positions.push(this.positions.length?[gi(t[0]+this.draw.camera.grid),t[1],gi(t[2]+15*_h)]:[...t]),this.length||=2*this.draw.camera.grid,this.path=[],this.changed()}points(){let t=g("textarea",{rows:3,"aria-label":"points of the path",placeholder:"x, y of each point, one a line",spellcheck:"false"});return t.value=this.path.map(e=>e.join(", ")).join(`
`),t.addEventListener("change",()=>{let e=t.value.split(`
`).map(r=>r.trim()).filter(Boolean),i=e.map(r=>r.split(/[,;\s]+/).map(Number)),s=i.findIndex(r=>r.length!==2||r.some(a=>!Number.isFinite(a)));if(s>=0)return this.draw.tell(`Line ${s+1} of the path: ${e[s]}. Write two numbers, in m, e.g. 0.1, 0.25.`,!0);Object.assign(this,{path:i,positions:i.length?[]:this.positions}),this.changed()}),g("div",{class:"points"},t,Wn("closed",this.closed,e=>{this.closed=e,this.changed()},"closed path"))}card({type:t,error:e,transmission:i,size:s,picture:r},a){let o=[e>oA*s?`off by ${St(e,"m")}`:"exact",`transmission ${Math.round(i/_h)}°`];return g("button",{type:"button",class:"card",title:"Put it into the drawing","aria-label":`put linkage ${a+1}: ${t}, ${o.join(", ")}`,onclick:()=>this.put(a)},vh(r),g("b",{},t),o.map(l=>g("span",{},l)))}async find(){this.asking=!0,Object.assign(this,{rows:[],told:""}),this.rebuild();let t=[this.fourBars&&"four-bar",this.sliders&&"slider-crank"].filter(Boolean),e=this.positions.length?{positions:this.positions,point:this.length}:{path:this.path,closed:this.closed},i=t.length?await this.draw.ask({do:"ask",kinds:t,...e}):{message:"Choose four-bars, slider-cranks or both."};Object.assign(this,{asking:!1,rows:i.rows||[],told:i.message||""}),this.rebuild()}async put(t){(await this.draw.edit({do:"choose",number:t})).kind==="drawing"&&this.draw.reveal()}};var hA=[9,15,21],dA=13,uA=[[1,0],[-1,0],[0,1],[0,-1],[.7,.7],[-.7,.7],[.7,-.7],[-.7,-.7]],fA=[18,36,54,72,90,120,160],pA=[.5,.38,.62,.26,.74],mA=(n,t)=>n[0]<t[2]&&t[0]<n[2]&&n[1]<t[3]&&t[1]<n[3],bf=(n,t,e)=>[n-1,t-dA+3,n+e+1,t+3];function gA([n,t],[e,i,s,r]){let[a,o]=[0,1];for(let[l,c,h,d]of[[n[0],t[0]-n[0],e,s],[n[1],t[1]-n[1],i,r]]){if(Math.abs(c)<1e-9){if(l<h||l>d)return!1;continue}let[u,f]=[(h-l)/c,(d-l)/c];[a,o]=[Math.max(a,Math.min(u,f)),Math.min(o,Math.max(u,f))]}return a<o}var x0=document.createElement("canvas").getContext("2d"),wf=new Map;function ja(n,t,e=400){return[...n].reduce((i,s)=>{let r=`${e} ${t} ${s}`;return wf.has(r)||(x0.font=`${e} ${t}px ${getComputedStyle(document.getElementById("kinetruss")).fontFamily}`,wf.set(r,x0.measureText(s).width)),i+wf.get(r)},0)}var Mh=class{constructor(){Object.assign(this,{taken:[],lines:[]})}begin(t,e,i){this.taken=[...t.map(([s,r])=>[s-6,r-6,s+6,r+6]),...i],this.lines=e}put(t,e,i,s){let[[[r,a]]]=e,o=s?fA.map(d=>uA.map(([u,f])=>[r+d*u,a+d*f])):[],l=d=>d.filter(([u,f])=>!this.taken.some(p=>mA(p,bf(u,f,i)))),c=d=>d.find(([u,f])=>!this.lines.some(p=>gA(p,bf(u,f,i))))||d[0],h=[...e,...o].reduce((d,u)=>d||c(l(u)),null)||(s?[r,a]:null);t.setAttribute("display",h?"inline":"none"),h&&(this.taken.push(bf(...h,i)),t.setAttribute("x",h[0].toFixed(1)),t.setAttribute("y",h[1].toFixed(1)))}node(t,[e,i],s){let r=ja(t.textContent,12,600);this.put(t,hA.map(a=>[[e+a,i-a],[e-a-r,i-a],[e+a,i+8+a],[e-a-r,i+8+a],[e-r/2,i-3-a],[e-r/2,i+13+a],[e+2+a,i+4],[e-2-a-r,i+4]]),r,s)}member(t,e,i,s){let r=ja(t.textContent,11),a=pA.flatMap(o=>{let[l,c]=[e[0]+o*(i[0]-e[0]),e[1]+o*(i[1]-e[1])];return[[l+6,c-6],[l-6-r,c-6],[l+6,c+16],[l-6-r,c+16],[l-r/2,c-8],[l-r/2,c+18]]});this.put(t,[a],r,s)}};var xA=26;function v0(n,t){return Object.values(n.bodies||{}).map(({nodes:e})=>{let i=(e||[]).map(t).filter(Boolean),s=[0,1].map(o=>i.reduce((l,c)=>l+c[o]/i.length,0)),r=([o,l])=>Math.atan2(l-s[1],o-s[0]),a=i.toSorted((o,l)=>r(o)-r(l));return ht("path",{class:"body",d:a.length>1?`M${a.map(([o,l])=>`${o.toFixed(1)} ${l.toFixed(1)}`).join("L")}Z`:""})})}function _0(n,t,e){return Object.values(n.springs||{}).map(({coordinate:s})=>{if(s?.kind==="hinge")return y0(t(s.axis?.[0]),t(s.start),t(s.end));let r=s?.kind==="angle"?e(s.bar)?.map(t):null;return r&&r[0]?y0(r[0],[r[0][0]+1,r[0][1]],r[1]):null}).filter(Boolean)}function y0(n,t,e){if(!n||!t||!e)return null;let[i,s]=[t,e].map(([o,l])=>Math.atan2(l-n[1],o-n[0])),r=(s-i+3*Math.PI)%(2*Math.PI)-Math.PI,a=Array.from({length:13},(o,l)=>{let c=xA+(l%2&&l>1&&l<11?5:0)-(l%2===0&&l>1&&l<11?5:0),h=i+r*l/12;return`${(n[0]+c*Math.cos(h)).toFixed(1)} ${(n[1]+c*Math.sin(h)).toFixed(1)}`});return ht("path",{class:"spring",d:`M${a.join("L")}`})}var Ei={pick:"changes lengths",move:"lengths are kept"};function b0(n,t,e){let i=Math.hypot(...t.map((r,a)=>r-n[a])),s=Math.atan2(t[1]-n[1],t[0]-n[0])*180/Math.PI;return`${St(i,"m")}${e===2&&i>0?`, ${Kt(s,4)} deg`:""}`}var M0=["bars","active","beams","links"],w0=[...M0,"cylinders","drives","couplings","springs","stops"];function He(n,t,e,i=!0){let s=new Set((w0.includes(t)?w0:[t]).flatMap(a=>Object.keys(n[a]||{})));if(i&&!s.has(e))return e;let r=i?2:1;for(;s.has(`${e}${r}`);)r++;return`${e}${r}`}function Ya(n,t){let e=[],i=new Set(n.state.nodes),s=[...Array(26).keys()].map(a=>String.fromCharCode(65+a));return[t.map(({node:a,point:o})=>{if(a)return a;let l=1;for(;i.has(`N${l}`);)l++;let c=s.find(h=>!i.has(h))||`N${l}`;return i.add(c),e.push([["nodes",c],n.cut(o)]),c}),e]}function We(n,t){let{data:e}=n.state,i=M0.find(o=>t in(e[o]||{})),s=e[i][t],r=i==="links"?"nodes":"ends",a=Array.isArray(s)?{[r]:s}:s;return{table:i,record:a,nodes:a[r]}}function Za(n,t){return[...new Set(n.state.members.filter(({ends:e})=>e.includes(t)).map(({name:e})=>e))]}function wr(n,t){let{data:e,dim:i}=n.state;if(!["bars","links","active"].some(h=>t in(e[h]||{})))return n.tell(`${t} is a beam, which has no angle of its own: take a bar or a link (Kind, in the panel).`,!0);if(i===2)return{kind:"angle",bar:t};let r=Object.values(e.drives||{}).find(h=>h.kind==="angle"&&h.bar===t)?.axis||"xyz"[n.camera.plane.axis],{nodes:a}=We(n,t),o=S0(r),l=n.at(a[0]).map((h,d)=>n.at(a.at(-1))[d]-h),c=Math.hypot(...l);return Math.abs(l.reduce((h,d,u)=>h+d*o[u],0))<.999999*c?{kind:"angle",bar:t,axis:r}:n.tell(`${t} points along ${r}, so it has no angle about it. In space the axis is the normal of the work plane: choose another Plane, above the drawing.`,!0)}var S0=n=>Array.isArray(n)?n.map(Number):[0,1,2].map(t=>+("xyz"[t]===(n??"z")));function Ti(n,t){let[,e,i]=/^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([^\d\s].*)?$/i.exec(String(n))||[];return e===void 0?null:[Number(e),(i||t).trim()]}function Mf(n,t){let[e,i]=Cn(n,t);return`${Number((n*e).toPrecision(7))} ${i}`}function A0([n,t],e){return e.map(i=>`${Number((n*i).toPrecision(7))||0} ${t}`)}var E0=n=>Number(n.toPrecision(2)),oi=n=>n.length?`M${n.map(([t,e])=>`${t.toFixed(1)} ${e.toFixed(1)}`).join("L")}`:"";function sn(n,t,e){return t&&e?[ht("path",{class:"rubber",d:oi([t,e].map(i=>n.camera.project(i)))})]:[]}function Ka(n,t,e="load"){let i=Math.atan2(n[1]-t[1],n[0]-t[0]),s=r=>[n[0]-9*Math.cos(i+r),n[1]-9*Math.sin(i+r)];return ht("path",{class:e,d:oi([t,n])+oi([s(.42),n,s(-.42)])})}function ys({camera:n},t,e,i,s=null,[r,a]=[0,1]){let o=S0(i),l=(p,y)=>[p[1]*y[2]-p[2]*y[1],p[2]*y[0]-p[0]*y[2],p[0]*y[1]-p[1]*y[0]],c=p=>Math.hypot(...p),h=s&&c(l(o,s))>1e-9?s:Math.abs(o[0])<.9*c(o)?[1,0,0]:[0,1,0],d=l(o,h),u=d.map(p=>p/c(d)),f=l(u,o).map(p=>p/c(o));return Array.from({length:49},(p,y)=>{let m=2*Math.PI*(r+(a-r)*y/48);return n.project(t.map((x,_)=>x+e*(Math.cos(m)*f[_]+Math.sin(m)*u[_])))})}function T0(n,[t,e]){return ht("text",{class:"hand",x:t+10,y:e-8},n)}function Mr(n,t,e){let{camera:i}=n,[s,r]=i.across,a=[e[s]-t[s],e[r]-t[r]],o=Math.hypot(...a),l=Math.PI/12,c=Math.atan2(a[1],a[0]),h=n.snap?Math.round(c/l)*l:c,d=[0,0,0];return[d[s],d[r]]=[Math.cos(h),Math.sin(h)].map(u=>Math.abs(u)<1e-9?0:u),{direction:n.cut(d),angle:h,pixels:o*i.scale,length:o}}var Ja=(n,t)=>n.node?n.node===t.node:!t.node&&n.point.every((e,i)=>Math.abs(e-t.point[i])<1e-12),yA={name:"link",words:"Link",key:"1",about:"One stiff member through two pins or more: click them in their order; the last one again ends it, the first one again closes it",icon:"M4 19L11 10L20 5M4 17a2 2 0 1 0 .1 0M11 8a2 2 0 1 0 .1 0M20 3a2 2 0 1 0 .1 0",takes:n=>{let t=n.at(-1),e=n.slice(0,-1);return n.length>2&&(Ja(t,e.at(-1))||n.length>3&&Ja(t,e[0]))?null:"place"},shows:(n,t,e)=>[ht("path",{class:"rubber",d:oi([...t,...e?[e]:[]].map(({point:i})=>n.camera.project(i)))})],async act(n,t){let e=t.at(-1),i=Ja(e,t[0]),s=i?t.slice(0,-1):t.filter((l,c)=>!c||!Ja(l,t[c-1]));if(s.every(l=>Ja(l,s[0])))return n.tell("A link needs two different places.",!0);let[r,a]=Ya(n,s),o=He(n.state.data,"links","link",!1);await n.change(`adding ${o}`,[...a,[["links",o],i?[...r,r[0]]:r]],{type:"member",name:o})}};function Qa(n,t,e){return{...n,takes:i=>i.length<2?"place":null,shows:(i,[s],r)=>sn(i,s?.point,r?.point),async act(i,s){let[r,a]=Ya(i,s);if(r[0]===r[1])return i.tell("It needs two different places.",!0);let{data:o,members:l}=i.state,c=l.find(m=>!m.goes_on&&r.every(x=>m.ends.includes(x))&&m.name in(o.bars||{})),{table:h,stem:d,entry:u}=t(i,r,s),f=c?.name||He(o,h,d,!1),p=[...a,...c?[[["bars",f],null]]:[],[[h,f],u]];if(!await i.change(`adding ${f}`,p,{type:"member",name:f}))return;let y=[0,1,2].map(m=>(i.at(r[0])[m]+i.at(r[1])[m])/2);return e&&{at:y,...e(i,f)}}}}var C0=[yA];var vA=26,R0=-1;function N0(n,t,e){let{nodes:i}=We(n,t),[s,r]=[n.at(i[0]),n.at(i[1])],a=r.map((c,h)=>c-s[h]),o=a.reduce((c,h)=>c+h*h,0)||1,l=e.reduce((c,h,d)=>c+(h-s[d])*a[d],0)/o;return s.map((c,h)=>c+l*a[h])}var to=(n,t)=>Math.hypot(...n.map((e,i)=>e-t[i]));function P0(n,t){let e=Za(n,t),i=n.at(t);return n.state.members.filter(({name:s,goes_on:r,ends:a})=>!r&&!e.includes(s)&&to(N0(n,s,i),i)*n.camera.scale<1&&to(i,n.at(a[0]))<to(...a.map(o=>n.at(o)))).map(({name:s})=>s)}var _A={name:"slider",words:"Slider",key:"x",about:"A block that slides on a bar: click the node that lies on it, or pull from the node to the bar; the same again removes it. For a slide on the ground take Roller",icon:"M3 19L21 7M7 10l4 6l6 -4l-4 -6z",takes:(n,t)=>n.length?n.length>1||P0(t,n[0].node).length===1?null:"member":"node",shows:(n,[t],e)=>sn(n,t?.point,e?.point),async act(n,[{node:t,point:e},i]){let{data:s}=n.state,r=i?.member||P0(n,t)[0];if(Za(n,t).includes(r))return n.tell(`${t} is an end of ${r}. A block slides on another bar than its own.`,!0);let a=We(n,r).nodes.slice(0,2),o=N0(n,r,e),l=bA(s,t,a);if(l.length)return n.change(`${t} leaves ${r}`,l.map(d=>[["couplings",d],null]),{type:"node",name:t}).then(()=>null);let c=to(o,e)*n.camera.scale<1e-6?[]:[[["nodes",t,"at"],n.cut(o).map(d=>Number(d.toPrecision(12)))]],h=wA(n,a,t).map(([d,u])=>[["couplings",d],{terms:[[u,1]],value:0}]);await n.change(`${t} slides on ${r}`,[...c,...h],{type:"node",name:t})}},bA=(n,t,e)=>Object.entries(n.couplings||{}).filter(([,{terms:i=[]}])=>i.length===1&&i[0][0].kind==="offset"&&i[0][0].point===t&&String(i[0][0].line)===String(e)).map(([i])=>i);function wA(n,t,e){let i=He(n.state.data,"couplings","block"),s={kind:"offset",line:t,point:e};if(n.state.dim===2)return[[i,s]];let[r,a]=t.map(d=>n.at(d)),o=[0,1,2].map(d=>Math.abs(a[d]-r[d])),l=n.camera.plane.axis,c=Math.min(...o),h="xyz"[o[l]<=c+1e-9?l:o.indexOf(c)];return[[i,{...s,axis:h}],[`${i}.along`,{...s,along:h}]]}var MA={name:"gear",words:"Gear",key:"5",about:"Gear wheels or a belt between two bars that turn, in space each about the axis of its drive or the normal of the work plane: click one, then the other, and type how often the second turns for one turn of the first (negative: the other way round)",icon:"M8 8a4 4 0 1 0 .1 0M8 4v4M8 16v4M2 12h2M12 12h2M17 4a3 3 0 1 0 .1 0M17 2v2M17 10v2",takes:n=>n.length<2?"member":null,shows:(n,[t],e)=>sn(n,t?.point,e?.point),async act(n,[{member:t},{member:e,point:i}]){if(t===e)return n.tell("Gear wheels need two bars. Click one, then the other.",!0);let s=He(n.state.data,"couplings","gear"),r=wr(n,t),a=r&&wr(n,e);if(!a)return null;let o=h=>({terms:[[r,h],[a,-1]]}),l=h=>n.change(`${s} of ${t} and ${e}`,[[["couplings",s],o(h)]],{type:"member",name:e});if(!await l(R0))return null;let c=h=>{let d=SA(h);return d?l(d):n.tell(`A ratio is a number or two: -0.5, -20/40. Got ${h}.`,!0)};return{at:i,label:`Turns of ${e} a turn of ${t}`,value:String(R0),set:c}}};function SA(n){let[t,e=1]=n.split(/[/:]/).map(Number);return Number.isFinite(t/e)?t/e:0}var I0=(n,t)=>(e,i)=>({label:"Stiffness",value:t,set:s=>{let r=Ti(s,"N/m");return r?e.change(`stiffness of ${i}`,[[["bars",i,"stiffness"],r.join(" ")]]):e.tell(`A stiffness is a number with a unit: 1 kN/m. Got ${s}.`,!0)}}),L0=[_A,MA,Qa({name:"spring",words:"Spring",key:"z",about:"A coil spring from pin to pin; then type its stiffness",icon:"M3 20l3 -3l-1 -5l6 3l-1 -5l6 3l-1 -5l3 -1l3 -3"},(n,t)=>({table:"bars",stem:"spring",entry:{ends:t,kind:"elastic",stiffness:"1 kN/m"}}),I0("elastic","1 kN/m")),Qa({name:"rope",words:"Rope",key:"6",about:"A rope from pin to pin, which only pulls; then type its stiffness",icon:"M3 19c4 -6 6 3 9 -4s5 2 9 -10"},(n,t)=>({table:"bars",stem:"rope",entry:{ends:t,kind:"cable",stiffness:"100 kN/m"}}),I0("cable","100 kN/m")),{name:"hinge",words:"Hinge spring",key:"7",about:"A spring of the angle between two bars that meet: pull from one to the other, and in space click a node on the axis of their hinge; a click is for the angle to the ground, in space about the normal of the work plane",icon:"M4 20L20 20M4 20L15 5M14 20a10 10 0 0 0 -4 -8M9 15l2 -1M11 18l2 -1",takes:(n,t)=>n.length<2?"member":n.length<3&&t.state.dim===3&&n[0].member!==n[1].member?"node":null,more:()=>!0,next:([n,t])=>t&&`Hinge spring: now click a node on the axis of the hinge of ${n.member} and ${t.member}, which goes from where they meet to it.`,shows:(n,[t],e)=>sn(n,t?.point,e?.point),async act(n,[t,e,i]){let s=[t.member,...e&&e.member!==t.member?[e.member]:[]];if(s.length===1&&!wr(n,t.member))return null;let a=(await n.edit({do:"make",what:"angle_spring",members:s,nodes:i?[i.node]:[],axis:"xyz"[n.camera.plane.axis]})).made?.entry?.[1];return a&&{at:t.point,label:"Stiffness",value:"10 N m/rad",set:o=>{let l=Ti(o,"N m/rad");return l?n.change(`stiffness of ${a}`,[[["springs",a,"stiffness"],l.join(" ")]]):n.tell(`A stiffness is a number with a unit: 10 N m/rad. Got ${o}.`,!0)}}}}];function D0(n,t){let{data:e,members:i,fixed:s}=n.state,r=a=>i.find(o=>o.name===a)?.ends;return Object.values(e.couplings||{}).flatMap(({terms:a=[]})=>{let[[o,l]=[],[c,h]=[]]=a;if(a.length===1&&o.kind==="offset")return o.along?[]:AA(t(o.point),o.line.map(t));let d=a.length===2&&[o,c].every(A=>A.kind==="angle")&&[o,c].map(A=>r(A.bar));if(!d||!d.every(Boolean)||!Number(l)||!Number(h))return[];let[u,f]=d.map(A=>n.at(A.find(v=>s[v])||A[0])),p=to(u,f),[y,m]=[Math.abs(l),Math.abs(h)].map(A=>p*A/(Math.abs(l)+Math.abs(h))),x=A=>ht("path",{class:"wheel",d:A}),_=A=>[x(`${oi(ys(n,u,y*A,o.axis))}Z`),x(`${oi(ys(n,f,m*A,c.axis))}Z`)];if(l*h>0)return _(1);let w=Math.min(1,vA/n.camera.scale/Math.max(y,m)),b=f.map((A,v)=>A-u[v]),T=A=>oi([ys(n,u,y*w,o.axis,b,[A,A])[0],ys(n,f,m*w,c.axis,b,[A,A])[0]]);return[..._(w),x(T(.25)+T(-.25))]})}function AA(n,[t,e]){return!n||!t||!e?[]:[ht("rect",{class:"block",x:-13,y:-8,width:26,height:16,rx:2,transform:`translate(${n[0].toFixed(1)} ${n[1].toFixed(1)}) rotate(${(Math.atan2(e[1]-t[1],e[0]-t[0])*180/Math.PI).toFixed(2)})`})]}var Sf=46,EA={N:100,"N/m":100},TA=4,k0=7;function Af(n,t){let e=n.filter(({span:i})=>!!i==(t==="N/m"));return Math.max(0,...e.map(({force:i,shape:s=[1,1]})=>Math.hypot(...i)*Math.max(...s.map(Math.abs))))||EA[t]}var O0=(n,t,e)=>E0(e/Sf*Af(n.state.loads,t));function U0(n,t,e,i,s){return{...n,takes:r=>[t,"tip"][r.length]||null,shows(r,[a],o){if(!a||!o)return[];let{direction:l,pixels:c,length:h}=Mr(r,a.point,o.point),{camera:d}=r,u=f=>d.project(f.map((p,y)=>p+h*(l[y]||0)));return[...s(r,a).map(f=>Ka(u(f),d.project(f))),T0(St(O0(r,e,c),e),u(a.point))]},async act(r,[a,o]){let{direction:l,pixels:c,length:h}=Mr(r,a.point,o.point),d=O0(r,e,c);if(c<TA)return r.tell("Pull the arrow away from where it begins.",!0);let{data:u}=r.state,{stem:f,entry:p}=i(a),y=He(u,"loads",f),m=w=>[["loads",y],{...p,force:A0(w,l)}],x=a.node?{type:"node",name:a.node}:{type:"member",name:a.member};if(!await r.change(`${y}`,[m(Ti(Mf(d,e),e))],x))return null;let _=w=>{let b=Ti(w,e);return b?r.change(`${y}`,[m(b)]):r.tell(`A ${e==="N"?"force is a number with a unit: 2 kN":"force along a member is a number with a unit: 2 kN/m"}. Got ${w}.`,!0)};return{at:a.point.map((w,b)=>w+h*(l[b]||0)),label:y,value:Mf(d,e),set:_}}}}var F0=[U0({name:"force",words:"Force",key:"p",about:"A force: pull its arrow from a node or from a place of a bar, and type its value",icon:"M12 3v16M7 14l5 5l5 -5M8 3h8"},"thing","N",({node:n,member:t,share:e})=>n?{stem:`F_${n}`,entry:{node:n}}:{stem:`F_${t}`,entry:{member:t,at:`${Number((100*e).toPrecision(3))} %`}},(n,{point:t})=>[t]),U0({name:"load",words:"Line load",key:"u",about:"A force along a bar, beam or link, per length: pull its arrow from the member, and type its value",icon:"M3 4h18M4 4v12M12 4v12M20 4v12M2 13l2 3l2 -3M10 13l2 3l2 -3M18 13l2 3l2 -3M3 20h18"},"member","N/m",({member:n})=>({stem:`q_${n}`,entry:{member:n}}),(n,{member:t,point:e,share:i})=>{let s=n.state.members.filter(({name:o})=>o===t),[r,a]=[s[0].ends[0],s.at(-1).ends[1]].map(o=>n.at(o));return i===void 0?[e]:Array.from({length:k0},(o,l)=>r.map((c,h)=>c+l/(k0-1)*(a[h]-c)))}),{name:"mass",words:"Mass",key:"4",about:"A mass at a node, on which gravity acts: click the node and type it",icon:"M7 9h10l4 12h-18zM12 9a3 3 0 1 0 -.1 0",takes:n=>n.length?null:"node",async act(n,[{node:t,point:e}]){let i=n.state.data.nodes[t],s=Array.isArray(i)?void 0:i.mass,r=a=>{let o=Ti(a,"kg");return o?n.change(`mass of ${t}`,[[["nodes",t,"mass"],o[0]?o.join(" "):null]]):n.tell(`A mass is a number with a unit: 5 kg. Got ${a}.`,!0)};return n.pick({type:"node",name:t}),s===void 0&&await r("1 kg"),{at:e,label:`Mass of ${t}`,value:typeof s=="number"?`${s} kg`:s??"1 kg",set:r}}}];var B0=24,z0=30,G0=[{name:"dimension",words:"Dimension",key:"0",about:"A dimension that stays in the picture: click a bar, and type the length if it is to be kept; pull from node to node for a distance, from bar to bar for an angle; the same again removes it",icon:"M3 7v10M21 7v10M3 12h18M7 9l-4 3l4 3M17 9l4 3l-4 3",measures:!0,takes:([n,t])=>n?t?null:n.node?"node":"member":"thing",more:({member:n})=>!!n,shows:(n,[t],e)=>sn(n,t?.point,e?.point),async act(n,[t,e]){if(t.node&&(!e||e.node===t.node))return n.tell("Pull from one node to another.",!0);let i=t.member,s=e?.member!==i&&e?.member,r=n.state.dimensions.length;if(s&&!V0(n,[i,s]))return n.tell(`${i} and ${s} do not meet at a node: there is no angle between them to measure. A click on one of them measures its length.`,!0);let a=await n.ask({do:"dimension",...i?{members:s?[i,s]:[i]}:{nodes:[t.node,e.node]}});if(!i||s||a.kind!=="drawing"||a.dimensions.length<r||n.play.away||We(n,i).table!=="bars")return null;n.pick({type:"member",name:i});let{record:o,nodes:l}=We(n,i),[c,h]=l.map(f=>n.at(f)),d=["elastic","cable"].includes(o.kind)?"natural_length":"length",u=f=>{let p=Ti(f,"m");return p?n.change(`length of ${i}`,[[["bars",i,d],p.join(" ")]]):n.tell(`A length is a number with a unit: 200 mm. Got ${f}.`,!0)};return{at:c.map((f,p)=>(f+h[p])/2),label:`Length of ${i}`,value:o[d]??St(Math.hypot(...c.map((f,p)=>h[p]-f)),"m",6),set:u}}}];function V0(n,t){let[e,i]=t.map(s=>We(n,s).nodes);return e.find(s=>i.includes(s))}function H0(n,t){let{state:e}=n,i=[],s=[],r={nodes:new Set(e.nodes),members:new Set(e.members.map(({name:a})=>a))};for(let{nodes:a,members:o}of e.dimensions){if(!(a||o).every(h=>r[a?"nodes":"members"].has(h)))continue;let{line:l,text:c}=o?.length===2?CA(n,t,o):RA(n,t,a||We(n,o[0]).nodes,o?.[0]);i.push(ht("path",{class:"dimension",d:l})),s.push(c)}return{lines:i,texts:s}}function CA(n,t,e){let i=V0(n,e);if(!i)return{line:"",text:{words:"",at:[0,0],way:[0,0]}};let s=e.map(p=>We(n,p).nodes).map(p=>p[0]===i?p.at(-1):p[0]),r=t(i),[a,o]=s.map(p=>n.at(p).map((y,m)=>y-n.at(i)[m])),l=[0,1,2].map(p=>a[(p+1)%3]*o[(p+2)%3]-a[(p+2)%3]*o[(p+1)%3]),c=Math.atan2(Math.hypot(...l),a.reduce((p,y,m)=>p+y*o[m],0)),[h,d]=s.map(p=>Math.atan2(t(p)[1]-r[1],t(p)[0]-r[0])),u=(d-h+3*Math.PI)%(2*Math.PI)-Math.PI,f=(p,y)=>[r[0]+p*Math.cos(y),r[1]+p*Math.sin(y)];return{line:oi(Array.from({length:17},(p,y)=>f(z0,h+u*y/16))),text:{words:`${Kt(c*180/Math.PI,4)} deg`,at:f(z0+18,h+u/2),way:[0,60]}}}function RA(n,t,e,i){let[s,r]=[e[0],e.at(-1)],[a,o]=[t(s),t(r)],l=Math.hypot(o[0]-a[0],o[1]-a[1])||1,[c,h]=[(o[1]-a[1])/l*B0,-(o[0]-a[0])/l*B0],[d,u]=[[a[0]+c,a[1]+h],[o[0]+c,o[1]+h]],f=Math.atan2(o[1]-a[1],o[0]-a[0]),p=([w,b],T,A)=>[w+T*8*Math.cos(f+A),b+T*8*Math.sin(f+A)],y=oi([a,[a[0]+1.15*c,a[1]+1.15*h]])+oi([o,[o[0]+1.15*c,o[1]+1.15*h]])+oi([p(d,1,.35),d,u,p(u,-1,.35)])+oi([p(d,1,-.35),d])+oi([u,p(u,-1,-.35)]),{length:m,kind:x="rigid"}=n.state.data.bars?.[i]||{},_=Math.hypot(...n.at(s).map((w,b)=>w-n.at(r)[b]));return{line:y,text:{words:typeof m=="string"&&x==="rigid"?m:St(_,"m"),at:[(d[0]+u[0])/2+.4*c,(d[1]+u[1])/2+.4*h],way:[u[0]-d[0],u[1]-d[1]]}}}var PA=60,IA=24,W0=80,$0=24,Ef=60,Tf=12,NA=22,Cf=7,LA=15,Sh=5,Ah=(n,t,e)=>`rgb(${Rn(n,t,e).map(Math.round).join(" ")})`,Mn=(n,t=!1)=>n.length?`M${n.map(([e,i])=>`${e.toFixed(2)} ${i.toFixed(2)}`).join("L")}${t?"Z":""}`:"",Eh=class{constructor(t){this.draw=t;let e=i=>ht("g",{class:i});this.layers=Object.fromEntries(["picture","grid","bodies","curve","paths","apart","task","bars","marks","diagram","nodes","names","values","rubber"].map(i=>[i,e(i)])),this.node=ht("svg",{class:"drawing",tabindex:0,role:"application","aria-label":"drawing; arrow keys move the cursor, Enter draws there, Tab leaves"},...Object.values(this.layers)),this.names=new Mh,this.legend=g("div",{class:"legend",hidden:!0}),new ResizeObserver(()=>this.resize()).observe(this.node)}resize(){let{width:t,height:e}=this.node.getBoundingClientRect();!t||!e||(Object.assign(this.draw.camera,{width:t,height:e}),this.node.setAttribute("viewBox",`0 0 ${t} ${e}`),!this.sized&&this.draw.state&&this.draw.fit(),this.sized=!0,this.update())}rebuild(){let{state:t}=this.draw;this.places=new Map,this.bars=t.members.map(({name:e})=>ht("path",{class:"bar","data-member":e})),this.circles=t.nodes.map(e=>ht("circle",{class:"node","data-node":e,r:6})),this.labels=t.nodes.map(e=>ht("text",{class:"name"},e)),this.tags=t.members.map(({name:e})=>ht("text",{class:"tag"},e)),this.layers.bars.replaceChildren(...this.bars),this.layers.nodes.replaceChildren(...this.circles),this.layers.names.replaceChildren(...this.tags,...this.labels),this.index=new Map(t.nodes.map((e,i)=>[e,i])),this.coils=new Set(Object.entries(t.data.bars||{}).filter(([,e])=>e?.kind==="elastic"&&e.stiffness!==void 0).map(([e])=>e)),this.update()}at(t){return this.seen[this.index.get(t)]}update(t=!1){let{state:e,camera:i,picked:s,shown:r}=this.draw;if(!e||!this.bars)return;this.seen=e.places.map(o=>i.project(o)),this.grid(),this.paint(e,s,r,t);let a=e.nodes.length<=W0;this.layers.names.setAttribute("display",r.names&&a||this.draw.gripped.size?"inline":"none"),this.circles.forEach((o,l)=>{let[c,h]=this.seen[l];o.setAttribute("cx",c.toFixed(2)),o.setAttribute("cy",h.toFixed(2)),t||o.classList.toggle("picked",s.nodes.has(e.nodes[l]))}),this.marks(e),this.place(e,s,r.names&&a),this.draw.picture.place(this.layers.picture),this.draw.curves.place(this.layers.curve),this.draw.task.place(this.layers.task),this.draw.play.paths(this.layers.paths),this.rubber(),this.draw.value.place()}near(t){let e=t?`${t.type} ${t.name}`:"";if(e===this.nearKey)return;this.nearKey=e;let{state:i,picked:s,shown:r}=this.draw;this.place(i,s,r.names&&i.nodes.length<=W0)}isNear(t,e){return this.nearKey===`${t} ${e}`}paint(t,e,i,s){let r=this.draw.stale?null:t.force,a=(r||[]).filter(u=>u!==null).map(Math.abs),{play:o}=this.draw,l=o.away&&o.film.largest||Math.max(...a,0)||1,c=this.draw.stale?{}:t.used||{};i.strength?this.strengthLegend(c,t.used?"not checked: it needs forces, sections and materials":"it is computed"):this.legend.hidden=!i.force||!a.some(u=>u>0),!i.strength&&this.legend.dataset.of!==(this.legend.dataset.of=`${l};${t.unsure.length}`)&&he(this.legend,g("b",{},"Force"),g("div",{class:"bar",style:`background: ${Pr("diverging")}`}),g("div",{class:"ticks"},g("span",{},St(-l,"N")),g("span",{},"0"),g("span",{},St(l,"N"))),g("div",{class:"words"},g("span",{},"compression"),g("span",{},"tension")),t.unsure.length?g("div",{},"?: not unique, in the colour of its kind"):null);let h=new Set(t.unsure),d=!s||t.members.length<=$0;this.bars.forEach((u,f)=>{let{name:p,ends:y,kind:m}=t.members[f],[x,_]=y.map(T=>this.at(T));u.setAttribute("d",Mn(m==="elastic"&&this.coils.has(p)?DA(x,_):[x,_]));let w=r?.[f]??null,b=w!==null&&!h.has(p);i.strength?u.style.stroke=Ah("capacity",p in c?c[p]:NaN,[0,1]):u.style.stroke=i.force&&b?Ah("diverging",w,[-l,l]):Ke[m]||Ke.rigid,s||(u.classList.toggle("picked",e.members.has(p)),u.classList.toggle("apart",p in t.apart),u.classList.toggle("coil",m==="elastic"&&this.coils.has(p)),u.classList.toggle("soft",m==="elastic"&&!this.coils.has(p)||m==="cable"||m==="free")),!(!d&&!e.members.has(p))&&(this.tags[f].textContent=i.strength&&p in c&&!i.lengths?`${p} ${St(c[p],"%")}${h.has(p)?" ?":""}`:i.lengths||this.touches(y)?`${p} ${b0(...y.map(T=>this.draw.at(T)),t.dim)}`:i.force&&w!==null?`${p} ${St(Math.abs(w)<1e-12*l?0:w,"N")}${b?"":" ?"}`:p)})}strengthLegend(t,e){let i=Object.entries(t).reduce((r,a)=>a[1]>r[1]?a:r,["",-1]),s=`strength;${i};${e}`;this.legend.hidden=!1,this.legend.dataset.of!==(this.legend.dataset.of=s)&&he(this.legend,g("b",{},"Strength: share of what is allowed"),g("div",{class:"bar",style:`background: ${Pr("sequential")}`}),g("div",{class:"ticks"},g("span",{},"0"),g("span",{},"50 %"),g("span",{},"100 %")),g("div",{class:"swatch"},g("i",{style:`background: ${Ah("capacity",2,[0,1])}`}),"beyond a limit"),g("div",{class:"swatch"},g("i",{style:`background: ${Ah("capacity",NaN,[0,1])}`}),i[0]?"not checked":e),i[0]?g("div",{class:"words"},`most: ${i[0]}, ${St(i[1],"%")}`):null)}touches(t){return t.some(e=>this.draw.gripped.has(e))}place(t,e,i){let{gripped:s,play:r,diagram:a}=this.draw,o=t.members.map(({ends:d})=>d.map(u=>this.at(u)));if(this.names.begin(this.seen,t.members.length<=Ef?o:[],this.taken),(i||s.size)&&this.labels.forEach((d,u)=>i?this.names.node(d,this.seen[u],e.nodes.has(t.nodes[u])||this.isNear("node",t.nodes[u])):d.setAttribute("display","none")),a.place(this.layers.diagram,this.names.taken),this.values(i),!i&&!s.size)return;let l=({name:d})=>(this.isNear("member",d)?2:0)+(e.members.has(d)?1:0),c=t.members.map((d,u)=>u).sort((d,u)=>l(t.members[u])-l(t.members[d])),h=r.playing?$0:Ef;for(let d of c){let{name:u,ends:f,goes_on:p}=t.members[d],y=!p&&(l(t.members[d])>0||this.touches(f));i&&!a.found&&t.members.length<=h&&!p||y?this.names.member(this.tags[d],...o[d],y):this.tags[d].setAttribute("display","none")}}values(t){let e=(r,a)=>ht("text",{class:a},r),i=[],s=(r,a,o,l)=>{this.names.put(r,[a],o,l),i.push(r)};for(let{words:r,at:[a,o],way:[l,c]}of this.measured){let h=ja(r,12);s(e(r,"measure"),[0,.18,-.18,.32,-.32].map(d=>[a+d*l-h/2,o+d*c+4]),h,!0)}if(t)for(let{words:r,tip:a,foot:o}of this.arrows.slice(0,Ef)){let l=ja(r,12,600),c=a[1]>o[1]?15:-6,[h,d]=a;s(e(r,"amount"),[[h-l/2,d+c],[h+7,d+4],[h-l-7,d+4],[h+7,(d+o[1])/2+4],[h-l-7,(d+o[1])/2+4],[h-l/2,d+2*c]],l,!1)}this.layers.values.replaceChildren(...i)}grid(){let{camera:t}=this.draw,[e,i]=t.across,{grid:s}=t,r=`${t.key},${s},${t.dim}`;if(r===this.gridded)return;this.gridded=r;let a=t.unproject([t.width/2,t.height/2]);if(!a){this.layers.grid.replaceChildren();return}let o=Math.min(PA,Math.ceil(.75*Math.hypot(t.width,t.height)/t.scale/s)),l=_=>Math.round(a[_]/s)-o,c=(_,w)=>{let b=[0,0,0];return[b[e],b[i],b[t.plane.axis]]=[_*s,w*s,t.plane.at],t.project(b)},[h,d]=[l(e),l(i)],[u,f]=[h+2*o,d+2*o],p={thin:"",axis:""};for(let _=h;_<=u;_++)p[_===0?"axis":"thin"]+=Mn([c(_,d),c(_,f)]);for(let _=d;_<=f;_++)p[_===0?"axis":"thin"]+=Mn([c(h,_),c(u,_)]);let y=t.project([0,0,0]),m=[..."xyz"].slice(0,t.dim).map((_,w)=>{let b=t.project([0,1,2].map(T=>T===w?34/t.scale:0));return ht("text",{class:"axis-name",x:b[0],y:b[1]},_)}),x=[0,1,2].slice(0,t.dim).map(_=>Mn([y,t.project([0,1,2].map(w=>w===_?28/t.scale:0))])).join("");this.layers.grid.replaceChildren(ht("path",{class:"thin",d:p.thin}),ht("path",{class:"zero",d:p.axis}),ht("path",{class:"cross",d:x}),...m)}marks(t){let e=[],i=a=>this.at(a),s=a=>t.members.find(o=>o.name===a)?.ends;this.taken=[];for(let a of t.supports)e.push(...this.support(a));for(let a of t.drives)e.push(...this.drive(a,s));this.arrows=[];for(let a of t.loads)e.push(...this.load(a));this.layers.bodies.replaceChildren(...v0(t.data,i),...D0(this.draw,i));let r=H0(this.draw,i);this.measured=r.texts,this.layers.marks.replaceChildren(...e,..._0(t.data,i,s),...r.lines)}drive({unit:t,bar:e,node:i,axis:s},r){let{camera:a}=this.draw,o=p=>p.forEach(([y,m])=>this.taken.push([y-Sh,m-Sh,y+Sh,m+Sh]));if(i&&s){if(!this.at(i))return[];let y=this.draw.at(i),m=x=>a.project(y.map((_,w)=>_+("xyz"[w]===s?x/a.scale:0)));return[1,-1].map(x=>(o([34,28,23,17,12].map(_=>m(x*_))),Ka(m(x*34),m(x*12),"drive")))}let l=r(e);if(!l)return[];let[c,h]=l.map(p=>this.at(p)),[d,u]=[(c[0]+h[0])/2,(c[1]+h[1])/2],f=Math.atan2(h[1]-c[1],h[0]-c[0]);if(t==="rad"){let[p,y]=l.map(x=>this.draw.at(x)),m=ys(this.draw,p,LA/a.scale,s,y.map((x,_)=>x-p[_]),[0,.8]);return o(m.filter((x,_)=>_%4===0)),[ht("path",{class:"drive",d:Mn(m)})]}return o([-8,0,8].map(p=>[d+p*Math.cos(f),u+p*Math.sin(f)])),[ht("rect",{class:"drive",x:-11,y:-5,width:22,height:10,rx:3,transform:`translate(${d} ${u}) rotate(${f*180/Math.PI})`})]}load({name:t,node:e,member:i,force:s,at:r,span:a,shape:o,turns:l}){let{state:c,camera:h}=this.draw,d=a?"N/m":"N",u=Af(c.loads,d),f=e?[]:c.members.filter(A=>A.name===i);if(e?!this.index.has(e):!f.length)return[];let p=e?[]:[...f.map(({ends:A})=>A[0]),f.at(-1).ends[1]].map(A=>this.draw.at(A)),y=A=>q0(p,A),m=[0,1,2].map(A=>s[A]||0);if(l&&c.dim===2){let[A,v]=[p[0],p.at(-1)],E=Math.hypot(v[0]-A[0],v[1]-A[1])||1,[D,P]=[(v[0]-A[0])/E,(v[1]-A[1])/E];m=[D*m[0]-P*m[1],P*m[0]+D*m[1],0]}let _=(e?[[this.draw.at(e),1]]:a?Array.from({length:Cf},(A,v)=>[y(a[0]+(a[1]-a[0])*v/(Cf-1)),o[0]+(o[1]-o[0])*v/(Cf-1)]):[[y(r),1]]).map(([A,v])=>[h.project(A),h.project(A.map((E,D)=>E+v*m[D]/u*(Sf/h.scale)))]),[w,b]=_[Math.floor(_.length/2)];this.arrows.push({name:t,words:St(Math.hypot(...s)*(a?Math.max(...o.map(Math.abs)):1),d),foot:w,tip:b});let T=a?[ht("path",{class:"load thin",d:Mn(_.map(([,A])=>A))})]:[];return[..._.filter(([A,v])=>Math.hypot(A[0]-v[0],A[1]-v[1])>1).map(([A,v])=>Ka(v,A)),...T]}support({node:t,kind:e,along:i}){let s=this.draw.state.places[this.index.get(t)],{camera:r}=this.draw;if(!s)return[];let a=[s[0],s[1],s[2]||0],o=e==="pin"||e==="roller",l=wn({kind:e,along:i},a,IA/r.scale).map(h=>h.map(d=>r.project(d))),c=h=>l.flat().map(d=>d[h]);return this.taken.push([Math.min(...c(0)),Math.min(...c(1)),Math.max(...c(0)),Math.max(...c(1))]),l.map((h,d)=>ht("path",{class:o&&d===0?"support":"support line","data-support":t,"data-kind":e,d:Mn(h)}))}rubber(){let{camera:t,rubber:e,cursor:i}=this.draw,s=[];if(e?.parts&&s.push(...e.parts),e?.from&&e.to&&s.push(ht("path",{class:"rubber",d:Mn([t.project(e.from),t.project(e.to)])})),e?.box&&s.push(ht("path",{class:"box",d:Mn([[e.box[0],e.box[1]],[e.box[2],e.box[1]],[e.box[2],e.box[3]],[e.box[0],e.box[3]]],!0)})),e?.to){let[o,l]=t.project(e.to);s.push(ht("circle",{class:"hint",cx:o,cy:l,r:9}))}let{pointed:r,tool:a}=this.draw;if(r?.name&&Ei[a]){let[o,l]=t.project(r.at);s.push(ht("text",{class:"hand",x:o+12,y:l+24},Ei[a]))}if(i){let[o,l]=t.project(i);s.push(ht("path",{class:"cursor",d:`M${o-12} ${l}H${o+12}M${o} ${l-12}V${l+12}`}))}this.layers.rubber.replaceChildren(...s),this.draw.readout.update()}linesOf(t){return this.draw.state.members.filter(e=>e.name===t).map(({ends:e})=>e.map(i=>this.at(i)))}shareOf(t,[e,i]){let s=this.linesOf(t),r=s.map(([c,h])=>Math.hypot(h[0]-c[0],h[1]-c[1])),a=r.reduce((c,h)=>c+h,0)||1,o={apart:1/0,share:.5},l=0;return s.forEach(([c,h],d)=>{let u=X0(c,h,[e,i]),f=Math.hypot(c[0]+u*(h[0]-c[0])-e,c[1]+u*(h[1]-c[1])-i);f<o.apart&&(o={apart:f,share:(l+u*r[d])/a}),l+=r[d]}),o.share}pointOf(t,e){let i=this.draw.state.members.filter(s=>s.name===t);return q0([...i.map(({ends:s})=>s[0]),i.at(-1).ends[1]].map(s=>this.draw.at(s)),this.shareOf(t,e))}hit([t,e],i=!1,s=()=>!0){let{state:r}=this.draw,a=i?NA:Tf,o=null;if(this.seen.forEach((c,h)=>{let d=Math.hypot(c[0]-t,c[1]-e);d<=a&&s(r.nodes[h])&&(!o||d<o.apart-1e-6||d<o.apart+1e-6&&c[2]>o.depth)&&(o={type:"node",name:r.nodes[h],apart:d,depth:c[2]})}),o?.apart<=Tf)return o;let l=o?o.apart-Tf+4:1/0;return r.members.forEach(({name:c,ends:h})=>{let[d,u]=h.map(y=>this.at(y)),f=X0(d,u,[t,e]),p=Math.hypot(d[0]+f*(u[0]-d[0])-t,d[1]+f*(u[1]-d[1])-e);p<=(i?16:8)&&p<l&&(!o||p<o.apart)&&(o={type:"member",name:c,apart:p})}),o}};function X0(n,t,[e,i]){let[s,r]=[t[0]-n[0],t[1]-n[1]];return Math.min(1,Math.max(0,((e-n[0])*s+(i-n[1])*r)/(s*s+r*r||1)))}function q0(n,t){let e=n.slice(1).map((r,a)=>Math.hypot(...r.map((o,l)=>o-n[a][l]))),i=t*e.reduce((r,a)=>r+a,0),s=e.findIndex((r,a)=>i<=r+1e-12||a===e.length-1?!0:(i-=r,!1));return n[s].map((r,a)=>r+i/(e[s]||1)*(n[s+1][a]-r))}function DA(n,t){let[e,i]=[t[0]-n[0],t[1]-n[1]],s=Math.hypot(e,i)||1,r=Math.max(4,Math.min(12,Math.round(s/14))),a=(o,l)=>[n[0]+o*e-l*i*8/s,n[1]+o*i+l*e*8/s];return[n,a(.12,0),...Array.from({length:2*r},(o,l)=>a(.12+.76*(l+.5)/(2*r),l%2?-1:1)),a(.88,0),t]}var kA={mechanism:"moves",redundant:"redundant",drive:"drive",open:"does not close"},Th=class{constructor(t){this.draw=t,this.doing=g("p",{class:"busy",hidden:!0}),this.words=g("div",{class:"words",role:"status","aria-live":"polite"}),this.tables=g("div",{}),this.mobility=g("pre",{}),this.node=g("section",{class:"verdicts","aria-label":"state of the drawing"},this.doing,this.words),this.details=g("div",{class:"state"},this.tables,g("details",{},g("summary",{},"Mobility"),this.mobility))}wait(t){this.doing.hidden=!t,this.doing.textContent=t}rebuild(){let{state:t}=this.draw,e=[];for(let a of t.missing)e.push(["",a,"missing"]);for(let{kind:a,text:o}of t.warnings)e.push([kA[a]||a,o]);for(let a of t.alarms)e.push(["limit",a]);for(let{text:a,line:o}of t.faults||[])e.push(["fault",o?`Line ${o}: ${a}`:a]);let i=t.hints||[],s=t.pins||[],r=JSON.stringify([e,i,s,t.why]);if(r!==this.last){this.last=r;let a=!e.length&&t.force;this.words.replaceChildren(g("p",{},a?g("b",{class:"good"},`Stable, ${OA(t.drives.length)}. `):null,t.why),g("ul",{},e.slice(0,14).map(([o,l,c=o.split(" ")[0]])=>g("li",{class:`of-${c}`},o?g("b",{},o):null,o?" ":null,l)),i.map(o=>g("li",{},g("b",{},"note")," ",o)),s.map(({node:o,member:l})=>g("li",{},g("button",{type:"button",class:"pin",title:`${l} becomes a link through ${o}: stiff there, and pinned to what else is at ${o}`,onclick:()=>this.draw.edit({do:"pin",member:l,node:o})},`Pin ${o} to ${l}`)))))}this.mobility.textContent=t.mobility?t.mobility.text||"It follows when the pointer rests.":"",this.numbers(t)}numbers(t){let e=[];t.drives.length&&e.push(g("table",{class:"numbers"},g("tr",{},g("th",{},"drive"),g("th",{},"at"),g("th",{},Rf(t.drives))),t.drives.slice(0,40).map(({name:r,unit:a,value:o,force:l})=>g("tr",{},g("th",{},r),g("td",{},St(o,a)),g("td",{},l===null?"-":St(l,a==="rad"?"N m":"N"))))));let i=[..."xyz"].slice(0,t.dim),s=Object.entries(t.reaction).slice(0,60);if(s.length){let r=t.reaction_moment,a=Object.keys(r).length?t.dim===3?i:["z"]:[],[o,l]=j0(s.map(([,u])=>u),"N"),[c,h]=j0(s.map(([u])=>r[u]||[]),"N m"),d=u=>u.map(f=>g("td",{},f));e.push(g("table",{class:"numbers"},g("tr",{},g("th",{},"reaction"),i.map(u=>g("th",{},`${u} (${l})`)),a.map(u=>g("th",{},`M${u} (${h})`))),s.map(([u],f)=>g("tr",{},g("th",{},u),d(o[f]),c[f].length?d(c[f]):a.map(()=>g("td",{}))))))}ve(this.tables,...e)}};function j0(n,t){let[e,i]=an(n.flat().map(s=>s??NaN),t);return[n.map(s=>e.splice(0,s.length)),i]}function OA(n){return n?`with ${n===1?"one drive":`${n} drives`}`:"without a drive"}function Rf(n){let t=n.filter(({unit:e})=>e==="rad").length;return t===n.length?"holding torque":t?"holding force or torque":"holding force"}var Ch=class{constructor(t){Object.assign(this,{draw:t,on:null,found:null,stale:!1}),this.body=g("div",{}),this.plot=g("canvas",{class:"plot",role:"img","aria-label":"force of the drive along its range"}),this.note=g("p",{class:"faint",role:"status"}),this.node=de("Path of a node",this.body,this.note,this.plot),this.plot.hidden=!0}rebuild(){let{draw:t}=this,{state:e,picked:i}=t;if(!e)return;let s=e.drives.map(({name:a})=>a);this.on&&(!e.nodes.includes(this.on.node)||!s.includes(this.on.drive))&&this.stop();let r=[...i.nodes][0]||this.on?.node||e.nodes.at(-1)||"";this.wish={node:r,drive:this.on?.drive||s[0]||""},s.length?ve(this.body,g("div",{class:"row"},ye("of node",e.nodes,r,a=>this.wish.node=a,"node of the path"),ye("by drive",s,this.wish.drive,a=>this.wish.drive=a,"drive of the path"),It("Show path",()=>this.start()),this.on?It("Hide",()=>{this.stop(),this.rebuild()}):null)):ve(this.body,g("p",{class:"faint"},"A path needs a drive: pick a bar and choose its driven length or angle."))}start(){this.on={...this.wish},this.stale=!0,this.rebuild(),this.draw.pump()}stop(){Object.assign(this,{on:null,found:null,stale:!1}),this.note.textContent="",this.plot.hidden=!0,this.draw.canvas.update()}spoil(){this.on&&(this.stale=!0)}command(){return this.stale=!1,{do:"curve",...this.on}}take(t){if(!this.on)return;this.found=t,this.note.textContent=t.stopped,this.draw.canvas.update(),this.plot.hidden=!1;let e=t.unit==="rad"?"N m":"N",i=t.unit==="rad"?180/Math.PI:1,s=t.values.map(a=>a*i),r=t.force.map(a=>a??NaN);Di(this.plot,[{x:s,y:r,label:t.drive}],{unit:e,xUnit:t.unit==="rad"?"deg":"m",title:Rf([t])})}failed(t,e){!this.on||e?.command||!t.startsWith("No")||(this.found=null,this.note.textContent=t,this.plot.hidden=!0,this.draw.canvas.update())}place(t){if(!this.found)return t.replaceChildren();let{camera:e}=this.draw,i=this.found.path.map(s=>e.project(s));t.replaceChildren(ht("path",{class:"curve",d:`M${i.map(([s,r])=>`${s.toFixed(2)} ${r.toFixed(2)}`).join("L")}`}))}};var Rh=class{constructor(t){Object.assign(this,{draw:t,on:"",found:null,stale:!1}),this.select=g("select",{"aria-label":"diagram",title:"Diagram over the structure, of all loads",onchange:()=>this.choose(this.select.value)}),this.node=g("label",{class:"entry"},g("span",{},"Diagram"),this.select),this.told=g("p",{class:"told",role:"status"})}rebuild(){let{shows:t}=this.draw.state;t.some(({id:e})=>e===this.on)||(this.on=""),this.select.replaceChildren(g("option",{value:""},"Off"),...t.map(({id:e,label:i})=>g("option",{value:e},i))),this.select.value=this.on}choose(t){Object.assign(this,{on:t,found:null,stale:!!t}),this.select.value=t,this.tell(),this.draw.canvas.update(),this.draw.pump()}spoil(){this.on&&(this.stale=!0,this.found=null,this.tell())}follow(){this.spoil(),this.draw.pump()}command(){let{play:t}=this.draw;return this.stale=!1,{do:"over",show:this.on,...t.away?{sample:t.index}:{}}}take(t){t.show!==this.on||this.stale||(this.found=t,this.tell(),this.draw.canvas.update())}tell(){let{found:t}=this,e=t?.show==="deflection"&&t.curves.length?`, drawn ${Kt(t.factor)} times as large`:"";this.told.textContent=this.on&&this.draw.play.playing?"The diagram is shown where the motion stops.":t?t.why||`${t.sentence}${e}.`:""}place(t,e){let{found:i,draw:s}=this,{camera:r}=s;if(!i||s.stale||s.play.playing)return t.replaceChildren();let a=h=>h.map(d=>r.project(d)),o=[],l=i.curves.flatMap(h=>{let d=a(h.base),u=a(h.base.map((f,p)=>f.map((y,m)=>y+i.factor*h.shift[p][m])));for(let f of h.extremes)o.push({value:h.values[f],tip:u[f],foot:d[f]});return lf(d,u,h.values,i.show)}),c=af(o,i.unit,r,e);e.push(...c.map(({box:h})=>h)),t.replaceChildren(...l,...c.map(of))}};var Y0=`.sheet { flex: 1; min-width: 0; display: flex; flex-direction: column; }
.sheetpane { flex: 1; min-width: 0; min-height: 0; position: relative; display: flex; }
.motion { flex: none; padding: 4px 10px; border-top: 1px solid var(--line); background: var(--card); font-size: 13px; }
.motion .row { display: flex; flex-wrap: wrap; align-items: center; gap: 4px 10px; }
.motion .row[hidden] { display: none; }
.motion .next button { margin: 2px 4px 2px 0; }
#kinetruss .motion .row > * { min-height: 44px; }
#kinetruss .motion button, #kinetruss .motion select, #kinetruss .motion input[type="text"] { min-height: 44px; min-width: 44px; font: inherit; }
#kinetruss .motion input[type="text"] { color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 5px; padding: 2px 6px; }
.motion .timebar { flex: 1 1 320px; min-width: min(100%, 320px); padding: 0; border: 0; }
.motion .timebar .time { min-width: 112px; }
.motion .timebar input { min-width: 120px; }
.motion .row .words { flex: 1 1 240px; }
.motion .words:empty { display: none; }
.motion .words { margin: 2px 0; font-variant-numeric: tabular-nums; }
.motion .words b { font-weight: 600; }
.motion .wrong { color: var(--alarm); }
.motion .words .here { color: var(--alarm); }
.motion .graph { position: relative; height: 104px; touch-action: none; cursor: ew-resize; }
.motion .graph .plot { width: 100%; height: 100%; display: block; pointer-events: none; }
.motion .now { position: absolute; top: 16px; bottom: 16px; width: 0; border-left: 2px solid var(--accent); pointer-events: none; }
.drawing .path { fill: none; stroke: var(--pen-1); stroke-width: 1.5; opacity: 0.8; }
.away .sketch .words .of-limit { opacity: 0.35; }
.drawing { flex: 1; width: 100%; height: 100%; min-height: 260px; touch-action: none; cursor: crosshair; user-select: none; }
.drawing:focus-visible { outline-offset: -2px !important; }
.drawing .thin { stroke: var(--line); stroke-width: 0.6; fill: none; }
.drawing .zero { stroke: var(--faint); stroke-width: 1; fill: none; opacity: 0.55; }
.drawing .cross { stroke: var(--faint); stroke-width: 2; fill: none; }
.drawing text { fill: var(--ink); font-size: 12px; paint-order: stroke; stroke: var(--back); stroke-width: 3px; pointer-events: none; }
.drawing .axis-name, .drawing .tag { fill: var(--faint); font-size: 11px; }
.drawing[data-tool="pick"] { cursor: default; }
.drawing[data-tool="move"] { cursor: grab; }
.drawing[data-tool="move"]:active { cursor: grabbing; }
.drawing .hand { fill: var(--accent); font-size: 11px; }
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
.drawing { --load: #8a4fbf; }
[data-theme="dark"] .drawing { --load: #c39af0; }
.drawing .load { fill: none; stroke: var(--load); stroke-width: 2.5; }
.drawing .load.thin { stroke-width: 1.2; }
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
#kinetruss .rail { gap: 4px 20px; padding: 6px 14px; }
#kinetruss .rail .title { flex: 0 1 auto; }
#kinetruss .rail .tools { flex: 1 1 auto; justify-content: flex-end; gap: 4px 10px; }
#kinetruss .rail .tools button { padding: 3px 7px; font-size: 13px; }
#kinetruss .rail .tools input { width: 64px; }
.starters:not(.all) .card span { display: none; } /* low, so that one can draw above it; a tip has the words */
.palette { flex: 1 1 100%; display: flex; flex-wrap: wrap; gap: 4px 9px; }
.palette .group { display: inline-flex; flex-wrap: wrap; gap: 2px; }
.palette .group + .group { border-left: 1px solid var(--line); padding-left: 9px; }
#kinetruss .palette button { display: inline-flex; flex-direction: column; align-items: center; justify-content: center; gap: 0; padding: 2px 3px; min-width: 46px; min-height: 46px; border-color: transparent; background: none; }
#kinetruss .palette button:hover { border-color: var(--line); }
#kinetruss .palette button[aria-pressed="true"] { background: var(--pressed); border-color: var(--accent); }
#kinetruss .palette .head { display: none; }
.palette button span { font-size: 10.5px; line-height: 1.15; color: var(--faint); white-space: nowrap; }
.icon { fill: none; stroke: currentColor; stroke-width: 1.7; stroke-linecap: round; stroke-linejoin: round; flex: none; }
.menu { position: absolute; z-index: 3; width: 264px; max-height: calc(100% - 8px); overflow: auto; padding: 6px; border: 1px solid var(--line); border-radius: 8px; background: var(--card); box-shadow: 0 6px 22px rgb(0 0 0 / 0.22); }
.menu b { display: block; padding: 2px 6px 4px; }
.menu .items { display: grid; grid-template-columns: 1fr 1fr; gap: 2px; }
#kinetruss .menu button { display: flex; gap: 7px; align-items: center; min-height: 44px; padding: 2px 6px; border-color: transparent; background: none; text-align: left; }
#kinetruss .menu button:hover, #kinetruss .menu button:focus { background: var(--pressed); }
.value { position: absolute; z-index: 2; display: flex; gap: 6px; align-items: center; padding: 2px 6px; border: 1px solid var(--accent); border-radius: 6px; background: var(--card); box-shadow: 0 3px 12px rgb(0 0 0 / 0.18); font-size: 12px; }
.value.corner { right: 10px; bottom: 8px; left: auto !important; top: auto !important; }
#kinetruss .value input { font: inherit; font-size: 14px; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 5px; padding: 2px 6px; min-height: 44px; }
.drawing .wheel { fill: none; stroke: var(--pen-3); stroke-width: 1.5; stroke-dasharray: 5 3; }
.drawing .block { fill: var(--card); stroke: var(--ink); stroke-width: 1.8; }
.drawing .dimension { fill: none; stroke: var(--pen-1); stroke-width: 1.2; }
.drawing .values .measure { fill: var(--pen-1); }
.drawing .values .amount { fill: var(--load); font-weight: 600; }
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
  .motion .timebar { position: static; }
  .motion .graph { height: 88px; }
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
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(112px, 1fr)); gap: 8px; margin: 6px 0; }
#kinetruss .card { display: flex; flex-direction: column; align-items: flex-start; gap: 1px; padding: 4px 6px 6px; min-height: 44px; text-align: left; border: 1px solid var(--line); border-radius: 6px; background: var(--card); color: inherit; overflow: hidden; }
#kinetruss .card:hover, #kinetruss .card:focus-visible { border-color: var(--accent); }
.card b { font-size: 12.5px; }
.card span { font-size: 11.5px; color: var(--faint); line-height: 1.25; }
.thumb { width: 100%; height: auto; display: block; align-self: center; }
.thumb .piece { stroke-width: 2.6; stroke-linecap: round; fill: none; }
.thumb .piece.soft { stroke-dasharray: 4 3; }
.thumb .plate { fill: var(--faint); fill-opacity: 0.2; }
.thumb .joint { fill: var(--card); stroke: var(--ink); stroke-width: 1.1; }
.thumb .hold { fill: var(--faint); opacity: 0.7; }
.thumb .hold.line { fill: none; stroke: var(--faint); stroke-width: 1; }
.thumb .turn { fill: none; stroke: var(--pen-3); stroke-width: 1.6; }
.thumb .way, .drawing .task .way { fill: none; stroke: var(--pen-1); stroke-width: 1.6; }
.drawing .task .way { stroke-dasharray: 7 4; stroke-width: 2; }
.drawing .task .at { fill: var(--card); stroke: var(--pen-1); stroke-width: 1.6; }
.drawing .task .position { fill: none; stroke: var(--pen-1); stroke-width: 4; stroke-linecap: round; }
.starters { position: absolute; left: 10px; right: 10px; bottom: 40px; border: 1px solid var(--line); border-radius: 8px; background: color-mix(in srgb, var(--card) 94%, transparent); padding: 4px 8px 6px; z-index: 1; }
.starters[hidden] { display: none; }
@media (max-height: 700px) {
  .starters:not(.all) { display: none; } /* it would lie over where one draws; they stand in the panel too */
}
.starters header { display: flex; gap: 8px; align-items: center; }
.starters header b { flex: 1; }
#kinetruss .starters header button { min-width: 44px; min-height: 44px; }
.starters.all { top: 10px; display: flex; flex-direction: column; }
.starters.all .cards { flex-wrap: wrap; overflow: auto; align-content: flex-start; }
.starters .cards { display: flex; overflow-x: auto; margin: 0; padding-bottom: 4px; }
#kinetruss .starters .card { flex: 0 0 136px; }
.sketch .points textarea { height: 84px; width: 100%; border: 1px solid var(--line); border-radius: 5px; }
.row.take > span { min-width: 56px; }
@media (max-width: 820px) {
  #kinetruss .starters .card { flex-basis: 112px; }
  .starters .card span { display: none; }
}

#kinetruss .rail .group select { max-width: 190px; }
#kinetruss .sketch select { max-width: 172px; }
#kinetruss .sketch select[aria-label^="section of"] { max-width: 230px; }
.welcome { position: absolute; inset: 0; display: grid; place-items: center; pointer-events: none; }
.welcome[hidden] { display: none; }
.welcome ol { display: grid; grid-template-columns: repeat(4, minmax(0, 150px)); gap: 18px; list-style: none; counter-reset: step; margin: 0; padding: 14px; }
.welcome li { counter-increment: step; text-align: center; color: var(--faint); font-size: 13px; }
.welcome li span::before { content: counter(step) " "; font-weight: 700; color: var(--accent); }
.welcome svg { width: 100%; fill: none; stroke-linecap: round; stroke-linejoin: round; }
.welcome .line { stroke: var(--ink); stroke-width: 4; opacity: 0.75; }
.welcome .begun { stroke: var(--accent); stroke-dasharray: 6 6; }
.welcome .tension { stroke: #d9772b; opacity: 1; }
.welcome .compression { stroke: #2e78b5; opacity: 1; }
.welcome .node { fill: var(--card); stroke: var(--ink); stroke-width: 2; }
.welcome .foot { fill: var(--faint); stroke: var(--faint); stroke-width: 1.5; }
.welcome .tip { fill: var(--accent); }
.welcome .turn { stroke: var(--pen-3); stroke-width: 2.5; }
.welcome .pull { stroke: #8a4fbf; stroke-width: 2.5; }
.welcome .way { stroke: var(--pen-1); stroke-width: 1.5; }
.rail .fold { display: none; }
@media (max-width: 620px) {
  #kinetruss .rail .fold { display: inline-block; }
  #kinetruss .rail:not(.open) .tools .view { display: none; }
  #kinetruss .palette { gap: 2px; justify-content: center; }
  #kinetruss .palette::after { content: ""; flex: 1 0 100%; order: 1; border-top: 1px solid var(--line); }
  #kinetruss .palette .group { display: contents; }
  #kinetruss .palette button { order: 2; flex: 0 1 72px; padding: 1px 0; }
  #kinetruss .palette .group:not(.open) button:not(.head) { display: none; }
  #kinetruss .palette .head { display: inline-flex; order: 0; flex: 1 1 0; min-width: 34px; }
  #kinetruss .palette .head[aria-current="true"] { background: var(--pressed); border-color: var(--accent); }
  #kinetruss .palette .head[aria-expanded="true"] { border-bottom: 3px solid var(--accent); }
  .palette .head span { font-size: 9px; line-height: 1; white-space: normal; text-align: center; text-transform: capitalize; }
  .palette .head .icon { width: 20px; height: 20px; }
  #kinetruss .rail { padding: 6px 8px; }
  #kinetruss .rail .title { display: flex; gap: 4px 12px; align-items: baseline; flex-wrap: wrap; }
  #kinetruss .rail .tools { justify-content: flex-start; gap: 3px 6px; }
  #kinetruss .rail .tools .group { display: contents; }
  #kinetruss .rail .tools button { padding: 2px 4px; font-size: 12px; }
  .welcome ol { grid-template-columns: repeat(2, minmax(0, 120px)); gap: 8px; padding: 6px; }
}
.drawing .bar.coil { stroke-width: 2.5; stroke-linejoin: round; }
.drawing .bar.coil.picked { stroke-width: 4; }
.sketch .finder { flex: 1 1 100%; }
.sketch .finder .rows { max-height: 260px; overflow: auto; }
#kinetruss .sketch .finder input { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 5px; padding: 2px 6px; min-height: 44px; }
#kinetruss .sketch .catalogue button.link { min-height: 28px; }
.sketch fieldset { margin: 2px 0; padding: 0 10px 2px; }
.sketch .weight { margin-left: 14px; }
`;var J0=/[:#{}[\],&*!|>'"%@`]|^[-?]/;function Ph(n){return n==null?"":Array.isArray(n)?`[${n.map(Ph).join(", ")}]`:typeof n=="object"?`{${Object.entries(n).map(([t,e])=>`${t}: ${Ph(e)}`).join(", ")}}`:typeof n=="string"&&J0.test(n)?JSON.stringify(n):String(n)}var FA=({type:n,of:t})=>n==="value"||n==="choice"||n==="text"||n==="flag"||n==="any"||n==="list"&&t.type!=="record",Q0=Math.PI/180,BA=/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;function tx(n,t){return Array.isArray(n)?n.map(e=>tx(e,t)):typeof n=="number"?`${Number((n/Q0).toPrecision(10))} ${t}`:n}function Z0(n,t){return n.split(",").map(e=>BA.test(e.trim())?`${e.trim()} ${t}`:e.trim()).join(", ")}var Sr=class{constructor(t,e){Object.assign(this,{draw:t,again:e,drafts:new Map,open:new Set})}get forms(){return this.draw.choices.forms}entry(t,e){let i=[t,e],s=this.forms.tables[t],r=this.draw.state.data[t]?.[e],a={nodes:"at",bars:"ends",beams:"ends",links:"nodes"}[t],o=Array.isArray(r)&&a?{[a]:r}:r;return s.type!=="record"||o!==void 0&&typeof o!="object"?this.field(this.live(),s,e,o,i):this.record(this.live(),s,t,o,i,!0)}live(){return{set:(t,e)=>this.draw.edit({do:"set",path:t,value:e,typed:!0}),draft:!1}}begin(t,e={}){this.drafts.set(t.join("."),e),this.again()}drafting(t){let e=t.join("."),i=this.drafts.get(e),s=(o,l)=>{let c=o.slice(t.length),h=c.pop(),d=i;for(let u of c)d=d[u]??={};l===null?delete d[h]:d[h]=l,this.again()},r=async()=>{(await this.live().set(t,i)).kind==="drawing"&&(this.drafts.delete(e),this.again())},a=()=>{this.drafts.delete(e),this.again()};return{context:{set:s,draft:!0},root:i,actions:g("div",{class:"row"},It("Apply",r,{"aria-label":`apply ${e}`}),It("Cancel",a,{"aria-label":`cancel ${e}`}))}}degrees(t,e){let i=(t.type==="list"?t.of:t).unit||"",s=this.draw.state.drives.find(a=>a.name===e),r=i.startsWith("rad")?i:s?.unit==="rad"&&i.includes("or rad")?i.split("or ")[1]:"";return{rad:"deg","rad/s":"deg/s"}[r]||""}field(t,e,i,s,r){if(e.type==="record")return this.record(t,e,i,s,r);if(e.type==="table"&&FA(e.of))return this.table(t,e,i,s,r);let a=r.join(".");if(e.type==="flag"||e.type==="choice"&&!e.free){let y=(e.type==="flag"?[!0,!1]:e.of).map(String);return ye($n(i),[["",e.default===void 0?"-":`${e.default} (default)`],...y],s==null?"":String(s),m=>t.set(r,m||null),a)}let o=e.type==="list"&&e.of.type!=="record",l=this.degrees(e,i),c=l?tx(s,l):s,h=o&&Array.isArray(c)?Ph(c).slice(1,-1):typeof c=="string"?c:Ph(c),d=l||(e.unit??(o?e.of.unit:"")),u=y=>{if(y===null)return t.set(r,null);let m=l&&!String(y).startsWith("[")?Z0(String(y),l):String(y);return o&&!m.startsWith("[")?t.set(r,e.of.type==="list"?`[[${m}]]`:`[${m}]`):t.set(r,e.type==="text"&&J0.test(m)?JSON.stringify(m):m)},f=e.default!==void 0&&typeof e.default!="object"?`${l?e.default/Q0:e.default}${d?` ${d}`:""}`:d||(o?"a, b":""),p=le($n(i),h,u,{hint:f,size:o||e.type==="any"?16:9,name:a});return K0(p,a,e.type==="choice"?e.of.map(String):this.names(e)),d&&h!==""&&(p.title=d),p}table(t,e,i,s,r){let a=Object.entries(s||{}).map(([f,p])=>g("div",{class:"row"},this.field(t,e.of,f,p,[...r,f]))),o=r.join("."),l=this.names(e.keys),c=(e.keys.names||[]).includes("drives")&&l.find(f=>!(f in(s||{})))||"",h=this.degrees(e.of,c)||(e.of.type==="list"?e.of.of.unit:e.of.unit)||"",d=[["name",c,""],["value","",h]].map(([f,p,y])=>le(f,p,()=>{},{hint:y,size:8,name:`new ${f} in ${o}`}));K0(d[0],`keys ${o}`,l);let u=()=>{let[f,p]=d.map(x=>x.querySelector("input").value.trim()),y=this.degrees(e.of,f),m=y&&!p.startsWith("[")?Z0(p,y):p;f&&m&&t.set([...r,f],e.of.type==="list"&&!m.startsWith("[")?`[${m}]`:m)};return g("fieldset",{},g("legend",{},$n(i)),a,g("div",{class:"row"},d,It("Add",u,{"aria-label":`add to ${o}`})))}record(t,e,i,s,r,a=!1){let o=r.join("."),{records:l}=this.forms,c=!t.draft&&this.drafts.has(o)?this.drafting(r):null,h=c?c.root:s,d=c?c.context:t,u=h!==null&&typeof h=="object",f=u?e.of.find(v=>l[v].kind===h.kind)||e.of[0]:null,p=v=>{let E=l[v].kind?{kind:l[v].kind}:{};d.draft?d.set(r,E):this.begin(r,E)},y=this.names(e),m=[...a?[]:[["","-"]],...y,...e.of.map(v=>[`: ${v}`,e.of.length>1?$n(l[v].kind||v):y.length?"own values ...":"given"])],x=v=>{v.startsWith(": ")?p(v.slice(2)):(c&&this.drafts.delete(o),t.set(r,v||null))},_=u?`: ${f}`:s??"";typeof _=="string"&&_&&!m.some(v=>(Array.isArray(v)?v[0]:v)===_)&&m.push(_);let w=u&&e.of.length<2&&!y.length,b=w?null:ye(u?"kind":$n(i),m,_,x,o),T=w&&!a&&!e.needed&&!c?It("Remove",()=>t.set(r,null),{"aria-label":`remove ${o}`}):null;if(!u)return b;let A=[b,T,this.fields(d,f,h,r),c?.actions];return a?g("div",{class:"form"},A):g("fieldset",{class:"form"},g("legend",{},$n(i)),A)}fields(t,e,i,s){let{fields:r,about:a}=this.forms.records[e],o=s.join("."),[l,c]=[[],[]];for(let[d,u]of Object.entries(r))(d in i||u.needed?l:c).push(this.field(t,u,d,i[d],[...s,d]));let h=(d,u)=>{let f=`${d} ${o}`,p=g("details",{open:this.open.has(f)},g("summary",{"aria-label":`${d} of ${o}`},d),u);return p.addEventListener("toggle",()=>p.open?this.open.add(f):this.open.delete(f)),p};return[g("div",{class:"row"},l),c.length?h("More fields",g("div",{class:"row"},c)):null,a&&s.length===2?h("What they mean",g("pre",{class:"about"},a)):null]}names({names:t=[],also:e=[]}){let{data:i}=this.draw.state,s=(a,o)=>a!=="poses"&&(a!=="bars"||!t.includes("drives")||o.kind==="driven"),r=a=>Object.entries(i[a]||{}).filter(([,o])=>s(a,o)).map(([o])=>o);return[...new Set([...t.flatMap(a=>[...r(a),...this.draw.choices[a]||[]]),...e])]}};function K0(n,t,e){if(!e.length)return;let i=`names-${t.replace(/[^\w-]/g,"_")}`;n.querySelector("input").setAttribute("list",i),n.append(g("datalist",{id:i},e.map(s=>g("option",{value:s}))))}function $n(n){return n.replaceAll("_"," ")}var ex=["active","beams","links","bodies","springs","drives","loads","load_cases","trajectories"],zA=300,GA={bodies:"body",trajectories:"trajectory",load_cases:"case",poses:"pose"},Ih=class{constructor(t){Object.assign(this,{draw:t,table:"springs",name:"",ran:{}}),this.forms=new Sr(t,()=>this.rebuild()),this.body=g("div",{}),this.runs=g("div",{}),this.node=de("Entries of the model",this.body),this.runsNode=de("Runs",this.runs),this.node.open=!1}show([t,e]){let i=t==="runs";Object.assign(this,i?{run:e}:{table:t,name:e}),(i?this.runsNode:this.node).open=!0,this.rebuild()}rebuild(){let{draw:t}=this,{state:e}=t;e&&(this.entries(e.data),this.listRuns(e.data.runs||{}))}entries(t){let{tables:e}=this.draw.choices.forms,i=l=>Object.keys(t[l]||{}).length,s=Object.keys(e).filter(l=>l!=="runs"&&(!(l in t)||!Array.isArray(t[l]))),r=[...ex,...s.filter(l=>!ex.includes(l))],a=Object.keys(t[this.table]||{}),o=[...this.forms.drafts.keys()].filter(l=>l.startsWith(`${this.table}.`)&&!a.includes(l.slice(this.table.length+1))&&l.split(".").length===2).map(l=>l.slice(this.table.length+1));[...a,...o].includes(this.name)||(this.name=a[0]||o[0]||""),ve(this.body,g("div",{class:"row"},ye("Table",r.map(l=>[l,`${$n(l)} (${i(l)})`]),this.table,l=>{Object.assign(this,{table:l,name:""}),this.rebuild()},"table of entries"),ye("Entry",[...a,...o.map(l=>[l,`${l} (new)`])],this.name,l=>{this.name=l,this.rebuild()},"entry"),It("New",()=>this.fresh(),{"aria-label":"new entry"})),g("p",{class:"faint"},e[this.table].about),this.name?this.form(this.table,this.name):null)}form(t,e){let i=e in(this.draw.state.data[t]||{});return g("div",{},i?g("div",{class:"row"},this.naming(t,e),It("Delete",()=>this.draw.edit({do:"set",path:[t,e],value:null}),{"aria-label":`delete ${t} ${e}`})):null,this.forms.entry(t,e))}naming(t,e){return le("Name",e,async s=>{if(s===null)return this.rebuild();(await this.draw.edit({do:"rename",table:t,old:e,new:String(s)})).kind==="drawing"&&this.show([t,String(s)])},{name:`name of ${t} ${e}`})}fresh(){let{table:t}=this,e=this.draw.choices.forms.tables[t],i=GA[t]||t.replace(/s$/,""),s=this.draw.state.data[t]||{},r=1;for(;`${i}${r}`in s||this.forms.drafts.has(`${t}.${i}${r}`);)r++;this.name=`${i}${r}`;let{kind:a}=e.type==="record"?this.draw.choices.forms.records[e.of[0]]:{};this.forms.begin([t,this.name],a?{kind:a}:{})}listRuns(t){let e=Object.keys(t),{doing:i}=this;e.includes(this.run)||(this.run=e[0]||"");let s=()=>this.draw.make("run");ve(this.runs,g("div",{class:"row"},e.length?ye("Run",e,this.run,r=>{this.run=r,this.rebuild()},"run"):g("span",{class:"faint"},"No run yet: a run moves the drives, or computes the equilibrium."),It("New run",s),this.run&&!i?It("Do it",()=>this.start(this.run),{"aria-label":`do run ${this.run}`}):null),i?this.progress(i):null,i?.name===this.run?null:this.result(this.ran[this.run]),this.run?this.form("runs",this.run):null)}progress({name:t,done:e,total:i}){return this.bar=g("progress",{max:i||1,value:e||void 0,"aria-label":`progress of ${t}`}),this.share=g("span",{role:"status","aria-live":"off"},ix(this.doing)),g("div",{class:"row doing"},this.share,this.bar,It("Stop",()=>this.stop(),{"aria-label":`stop run ${t}`}))}result(t){if(!t)return null;let e=t.revision!==this.draw.state.revision;return g("div",{role:"status"},g("pre",{class:"about"},t.words),e?g("p",{class:"faint"},"The drawing has changed since."):null,t.number?g("a",{href:`result/${t.number}`,target:"_blank",rel:"noopener"},"Show the result"):null)}async start(t){this.doing={name:t},this.rebuild(),this.hear(await this.draw.ask({do:"run",name:t}))}async stop(){let{name:t}=this.doing||{},e=await this.draw.ask({do:"stop"});this.hear(e),e.kind==="stopped"&&this.draw.tell(`The run ${t} was stopped.`)}hear(t){clearTimeout(this.timer);let e=this.doing;if(this.doing=t.kind==="running"?t:null,this.doing?this.timer=setTimeout(()=>this.follow(),zA):t.kind==="ran"&&(this.ran[t.name]=t,this.draw.tell(`The run ${t.name} is done.`)),!this.doing||!e)return this.rebuild();this.bar.max=t.total||1,t.done&&(this.bar.value=t.done),this.share.textContent=ix(t)}async follow(){this.doing&&this.hear(await this.draw.ask({do:"running"}))}take(t){t?.form||(t?.kind==="running"?this.hear(t):t?.kind==="ran"&&(this.ran[t.name]=t))}};function ix({name:n,done:t,total:e,what:i="samples",note:s=""}){return`Computing ${n}${e?`: ${t} of ${e} ${i}`:" ..."}${s?`. ${s}`:""}`}var Nh=class{constructor(t){this.draw=t,this.name=g("input",{type:"text","aria-label":"file name",size:18}),this.rows=g("ul",{class:"versions"}),this.offer=g("p",{class:"banner",hidden:!0}),this.ask=g("p",{class:"banner warning",hidden:!0}),this.body=g("div",{},this.ask,g("div",{class:"row"},this.name,It("Save",()=>this.save(),{title:"Save (Ctrl+S)"})),g("div",{class:"row"},It("Keep this state",()=>this.list({do:"keep"})),It("Show versions",()=>this.list({do:"versions"}))),this.rows),this.node=de("Save and versions",this.body,g("p",{class:"faint"},"Every edit is kept beside the file, in the folder .kinetruss, until it is saved."))}rebuild(){let{state:t}=this.draw;this.body.hidden=!t.writable,t.offered||(this.offer.hidden=!0),this.name.value||(this.name.value=t.file||"model.yaml"),t.saved&&this.list({do:"versions"})}async save(t=!1){this.ask.hidden=!0;let e=this.name.value.trim();e&&!/[./\\]/.test(e)&&(this.name.value=`${e}.yaml`);let i=await this.draw.ask({do:"save",name:this.name.value.trim(),replace:t});i.kind==="exists"&&(this.ask.hidden=!1,this.ask.replaceChildren(`${i.message} `,It("Overwrite",()=>this.save(!0))),this.draw.tell(i.message,!0),this.node.open=!0,this.ask.scrollIntoView({block:"nearest"}))}async list(t){let{rows:e}=await this.draw.ask(t);if(!e)return;let i=s=>new Date(1e3*s).toLocaleString();this.rows.replaceChildren(...e.length?e.toReversed().map(({number:s,when:r,words:a})=>g("li",{},It(`Back to ${s}`,()=>this.draw.ask({do:"restore",number:s})),` ${a}, ${i(r)}`)):[g("li",{},"No version yet.")])}setOffer(t){if(this.offer.hidden=!t,!t)return;let e=async i=>{this.offer.hidden=!0,await this.draw.ask({do:"draft",keep:i}),this.draw.fit()};this.offer.replaceChildren(`A drawing of ${t.lines} lines was not saved when its studio ended, ${new Date(1e3*t.when).toLocaleString()}. `,It("Go on with it",()=>e(!0))," ",It("Remove it",()=>e(!1)))}};var Lh=class{constructor(t){Object.assign(this,{draw:t,values:{}}),this.body=g("div",{}),this.node=de("Copy, mirror, stack",this.body),this.node.open=!1}field(t,e,i,s){return le(t,this.values[e]??i,r=>this.values[e]=r,{size:6,name:s})}value(t,e){return this.values[t]??e}nodes(){let{picked:t,state:e}=this.draw,i=e.members.filter(({name:s})=>t.members.has(s)).flatMap(({ends:s})=>s);return[...new Set([...t.nodes,...i])]}rebuild(){let{draw:t}=this,{state:e}=t;if(!e)return;let i=[..."xyz"].slice(0,e.dim),s=this.nodes().length,r=()=>t.edit({do:"copy",nodes:this.nodes(),by:i.map(h=>this.value(`d${h}`,0)),count:this.value("count",1)}).then(()=>t.reveal()),a=()=>t.edit({do:"mirror",nodes:this.nodes(),axis:this.value("axis","x"),at:this.value("at",0)}).then(()=>t.reveal()),o=()=>t.edit({do:"stack",cell:this.value("cell",c[0]),count:this.value("cells",1)}).then(h=>h.kind==="drawing"&&t.fit()),l=["triangle","panel"],c=t.choices.cells.filter(h=>l.includes(h)===(e.dim===2));ve(this.body,g("p",{class:"faint"},s?`${s} node${s===1?" is":"s are"} picked.`:"No node is picked: Shift-click, Shift-drag a box, or Ctrl+A."),g("fieldset",{},g("legend",{},"Copy, shifted by"),g("div",{class:"row"},i.map(h=>this.field(h,`d${h}`,0,`shift of copies along ${h}`)),this.field("times","count",1,"number of copies"),It("Copy",r))),g("fieldset",{},g("legend",{},"Mirror in the plane"),g("div",{class:"row"},ye("",i,this.value("axis","x"),h=>this.values.axis=h,"mirror axis"),this.field("=","at",0,"place of the mirror"),It("Mirror",a))),g("fieldset",{},g("legend",{},"Cells of the library"),g("div",{class:"row"},ye("",c,this.value("cell",c[0]),h=>this.values.cell=h,"cell"),this.field("times","cells",1,"number of cells"),It("Stack",o))))}};function VA(n,t,e){let{nodes:i}=We(n,t),[s,r]=i.map(c=>n.at(c)),a=s.map((c,h)=>r[h]-c),o=Math.hypot(...a),l=c=>{let h=Ti(c,"m"),d=xs(h?.join(" "))/o;if(!h)return n.tell(`A length is a number with a unit: 200 mm. Got ${c}.`,!0);let u=e&&d>0?[[["nodes",i[1]],n.cut(s.map((f,p)=>gi(f+d*a[p])))]]:[];return n.change(`length of ${t}`,[...u,[["bars",t,"length"],h.join(" ")]])};return{label:`Length of ${t}`,value:St(o,"m",6),set:l}}var nx=[{name:"node",words:"Node",key:"n",about:"A node where you click",icon:"M12 7a5 5 0 1 0 .1 0",takes:n=>n.length?null:"spot",act:async(n,[{node:t,point:e}])=>t?n.pick({type:"node",name:t}):void await n.edit({do:"add",at:n.cut(e)})},{name:"bar",words:"Bar",key:"b",about:"A bar from press to release, or from click to click and on to the next; the last one again ends it. It makes the nodes it needs; its length can be typed at once",icon:"M6 18L18 6M5 17a2 2 0 1 0 .1 0M19 3a2 2 0 1 0 .1 0",chain:!0,takes:n=>n.length<2?"place":null,async act(n,t){let[e,i]=Ya(n,t),s=n.state.members.find(a=>e.every(o=>a.ends.includes(o)));if(s)return n.pick({type:"member",name:s.name}),n.tell(`${s.name} joins ${e[0]} and ${e[1]} already. It is picked now.`,!0);let r=He(n.state.data,"bars","b",!1);return await n.change(`adding ${r}`,[...i,[["bars",r],e]],{type:"member",name:r})&&VA(n,r,i.some(([[,a]])=>a===e[1]))}}];var HA={rod:.75,shortest:.8,longest:1.4,barrel:[.06,.05],piston:[.03,0]},sx=(n,t,e,i)=>Object.entries(n.state.data.drives||{}).find(([,s])=>(s.kind||"angle")===t&&s[e]===i)?.[0];function WA({turned:n,along:t}={}){let e=Number.parseFloat(n)*Math.PI/180,s=(Array.isArray(t)?t.map(Number):n===void 0?[]:[Math.cos(e),Math.sin(e)]).map(Math.abs);return"xyz"[s.indexOf(Math.max(...s))]}var $A=(n,[t,e])=>({kind:e?"tube":"rod",...e?{outer:Pf(n*t),inner:Pf(n*e)}:{diameter:Pf(n*t)}}),Pf=n=>`${Number((1e3*n).toPrecision(2))} mm`,rx=[{name:"turn",words:"Turn",key:"t",about:"Drive the angle of a bar or link, in space about the normal of the work plane: click it; again stops it",icon:"M5 19L18 12M5 17a2 2 0 1 0 .1 0M9 6a9 9 0 0 1 10 12M21 14l-2 4l-4 -2",takes:n=>n.length?null:"member",async act(n,[{member:t}]){let e=sx(n,"angle","bar",t),i=e||He(n.state.data,"drives","motor"),s=e?null:wr(n,t);!e&&!s||await n.change(e?`${i} removed`:`${i} turns ${t}${s.axis?` about ${s.axis}`:""}`,[[["drives",i],s]],{type:"member",name:t})}},{name:"stroke",words:"Stroke",key:"s",about:"Drive the length of a bar: click it; again stops it",icon:"M3 17L21 7M8 8l-5 9l10 1M14 5l7 2l-4 6",takes:n=>n.length?null:"member",async act(n,[{member:t}]){let{table:e,record:i}=We(n,t),{kind:s,stiffness:r,natural_length:a,pretension:o,strain:l,...c}=i;if(e!=="bars")return n.tell(`${t} is no bar; the length of a bar is driven.`,!0);let h=s==="driven",d=h?c:{...c,kind:"driven"};await n.change(h?`${t} keeps its length`:`driving the length of ${t}`,[[["bars",t],Object.keys(d).length===1?d.ends:d]],{type:"member",name:t})}},Qa({name:"cylinder",words:"Cylinder",key:"y",about:"A hydraulic cylinder from pin to pin, with the limits of its stroke: press and release, or click and click. Drawn over a bar, it replaces it",icon:"M3 20l9 -9M8 18l-3 -3l7 -7l4 4l-7 7zM14 10l6 -6M20 2a2 2 0 1 0 .1 0"},(n,t,e)=>{let[i,s]=e.map(({point:p})=>p),r=Math.hypot(...i.map((p,y)=>s[y]-p)),a=p=>Number(p.toPrecision(3)),{rod:o,shortest:l,longest:c,barrel:h,piston:d}=HA,u=n.state.data.material||"steel_s355",f=p=>({length:a(o*r),section:$A(r,p),material:u});return{table:"active",stem:"cylinder",entry:{ends:t,base:f(h),tube:f(d),limits:[a(l*r),a(c*r)]}}}),{name:"push",words:"Push",key:"3",about:"Drive a node along the direction that is free to it, as the block of a slide: click it; again stops it",icon:"M3 16h10v-8h-10zM13 12h8M17 8l4 4l-4 4M2 20h20",takes:n=>n.length?null:"node",async act(n,[{node:t}]){let{data:e,dim:i,fixed:s}=n.state,r=sx(n,"coordinate","node",t),a=WA(e.supports?.[t])||[..."xyz"].slice(0,i).find(l=>!(s[t]||"").includes(l)),o=r||He(e,"drives","slide");if(!a)return n.tell(`${t} is held in all directions. Make it a roller first.`,!0);await n.change(r?`${o} removed`:`${o} pushes ${t} along ${a}`,[[["drives",o],r?null:{kind:"coordinate",node:t,axis:a}]],{type:"node",name:t})}}];var XA=Math.PI/180;function If(n,t,{fixed:e=null,support:i=null,clamped:s=!1}){let{data:r,fixed:a}=n.state,o=r.clamped||[],l=[];if(e!==(a[t]||null)&&l.push([["fixed",t],e]),JSON.stringify(i)!==JSON.stringify(r.supports?.[t]||null)&&l.push([["supports",t],i]),(Array.isArray(o)?o.includes(t):t in o)!==s)if(!Array.isArray(o))l.push([["clamped",t],s?"ground":null]);else{let h=o.filter(d=>d!==t);l.push([["clamped"],s?[...o,t]:h.length?h:null])}return l}function Dh(n,t,e,i,s=[]){let r=[...s,...If(n,t,i)];return r.length?n.change(`${e} at ${t}`,r,{type:"node",name:t}):n.change(`freeing ${t}`,If(n,t,{}),{type:"node",name:t})}var ax=n=>"xyz".slice(0,n.state.dim);function qA(n){let t=Number((n/XA).toFixed(4)),e=(t%180+180)%180;return e===0?{fixed:"y"}:e===90?{fixed:"x"}:{support:{y:"held",turned:`${e} deg`}}}function jA(n){let t=[..."xyz"].filter((e,i)=>Math.abs(n[i])<1e-9).join("");return t.length===2?{fixed:t}:{support:{along:n.map(e=>Number(e.toPrecision(12))),y:"held",z:"held"}}}function YA(n,t){let e=Za(n,t).map(c=>({name:c,...We(n,c)})),i=e.filter(({table:c})=>c==="beams"||c==="links");if(i.some(({table:c,record:h})=>c==="beams"||(h.weld||[]).includes(t)))return[];let[s]=i.length?i:e.length===1?e:[];if(!s)return null;let{kind:r,ends:a,...o}=s.record;if(s.table==="bars"&&(r&&r!=="rigid"||Object.keys(o).some(c=>!["section","material","mass"].includes(c))))return null;let l={nodes:s.nodes,...s.table==="links"?s.record:o,weld:[...s.record.weld||[],t]};return[...s.table==="bars"?[[["bars",s.name],null]]:[],[["links",s.name],l]]}var ox=[{name:"pin",words:"Pin",key:"h",about:"Hold a node in all directions: click it; again frees it",icon:"M12 5l-6 11h12zM3 19h18M5 22l2 -3M10 22l2 -3M15 22l2 -3",takes:n=>n.length?null:"node",act:(n,[{node:t}])=>Dh(n,t,"pin",{fixed:ax(n)}).then(()=>null)},{name:"roller",words:"Roller",key:"r",about:"Let a node slide along a line: click it for a level line (in space a level plane), or pull from it along the line, in space in the work plane; again frees it",icon:"M12 4l-6 10h12zM8 16a2 2 0 1 0 .1 0M16 16a2 2 0 1 0 .1 0M3 22h18",takes:n=>["node","tip"][n.length]||null,more:()=>!0,shows:(n,[t],e)=>{if(!t||!e)return[];let{direction:i,length:s}=Mr(n,t.point,e.point),r=a=>t.point.map((o,l)=>o+a*s*(i[l]||0));return sn(n,r(-1),r(1))},act:(n,[{node:t,point:e},i])=>{let s=i&&Mr(n,e,i.point);return Dh(n,t,"roller",n.state.dim===2?qA(s?s.angle:0):s?jA(s.direction):{fixed:"z"}).then(()=>null)}},{name:"clamp",words:"Clamp",key:"e",about:"Hold the place and the rotation of a beam or link at its node: click the node; again frees it. A single bar there becomes a link",icon:"M6 4v16M6 12h15M2 7l4 -3M2 12l4 -3M2 17l4 -3M2 22l4 -3",takes:n=>n.length?null:"node",async act(n,[{node:t}]){let e=YA(n,t);if(!e)return n.tell(`Nothing at ${t} has a rotation to hold: bars are pinned. Make one of them a beam or a link first (Kind, in the panel).`,!0);await Dh(n,t,"clamp",{clamped:!0},e)}},{name:"foot",words:"Spring foot",key:"2",about:"Hold a node by a spring, upright; the other directions stay held. Click the node and type the stiffness; again frees it",icon:"M12 3v3l-4 2l8 3l-8 3l8 3l-4 2v2M4 21h16",takes:n=>n.length?null:"node",async act(n,[{node:t,point:e}]){let i=ax(n),s=i.at(-1),r=n.state.data.supports?.[t];if(r&&r[s]!==void 0&&r[s]!=="held")return Dh(n,t,"spring foot",{}).then(()=>null);let a=Object.fromEntries([...i].map(l=>[l,l===s?"10 kN/m":"held"]));return await n.change(`spring foot at ${t}`,If(n,t,{support:a}),{type:"node",name:t})?{at:e,label:"Stiffness",value:"10 kN/m",set:l=>{let c=Ti(l,"N/m");return c?n.change(`spring foot at ${t}`,[[["supports",t,s],c.join(" ")]]):n.tell(`A stiffness is a number with a unit: 10 kN/m. Got ${l}.`,!0)}}:null}}];var ZA=[{name:"pick",words:"Pick",key:"v",about:"Pick and change: drag nodes, lengths follow; Shift adds to what is picked, Shift-drag draws a box",icon:"M6 3l12 10h-6l3 7l-3 1l-3 -7l-3 4z"},{name:"move",words:"Move",key:"m",about:"Move what is drawn: drag a node, all lengths are kept and drives follow",icon:"M12 3v18M3 12h18M9 6l3 -3l3 3M9 18l3 3l3 -3M6 9l-3 3l3 3M18 9l3 3l-3 3"}],KA=[{name:"positions",words:"Positions",key:"q",about:"Positions that a linkage shall take: press at a point of the body, release along its direction",icon:"M4 18l7 -3M8 11l7 -1M13 5l7 2M9 13l2 2l-3 1M13 8l2 2l-3 1M18 4l2 3l-3 1"},{name:"path",words:"Path",key:"w",about:"A path that a linkage shall draw: press, draw, release",icon:"M3 15c3 -14 15 -12 18 -3c-2 9 -14 9 -18 3z"}],eo=[["pick",ZA],["draw",[...nx,...C0]],["hold",ox],["drive",rx],["load",F0],["join",L0],["measure",G0],["ask for a linkage",KA]],Ar=new Map(eo.flatMap(([,n])=>n).map(n=>[n.name,n]));var kh="The work plane is seen edge-on. Turn the view, or choose another plane.",Nf=4,JA=550,Lf=()=>Math.floor(Math.random()*2**50),Oh=class{constructor(t){Object.assign(this,{draw:t,given:[],before:null,doing:Promise.resolve()}),this.pointers=new Map;let{node:e}=t.canvas;e.addEventListener("pointerdown",i=>this.down(i)),e.addEventListener("pointermove",i=>this.move(i)),e.addEventListener("pointerup",i=>this.up(i)),e.addEventListener("pointercancel",i=>this.cancel(i)),e.addEventListener("wheel",i=>{i.preventDefault(),t.camera.zoom(Math.exp(-i.deltaY/500),this.place(i)),t.canvas.update()},{passive:!1}),e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("blur",({relatedTarget:i})=>!t.value.node.contains(i)&&this.leave()),e.addEventListener("touchend",i=>this.rested&&i.preventDefault()),e.addEventListener("pointerleave",()=>this.point(null))}place(t){let e=this.draw.canvas.node.getBoundingClientRect();return[t.clientX-e.left,t.clientY-e.top]}target(t,e,i){let{draw:s}=this,r=s.canvas.hit(t,e,i);if(r?.type==="node")return{node:r.name,point:s.at(r.name)};let a=s.camera.unproject(t);if(!a)return s.tell(kh,!0),null;let o=s.snapped(a),l=s.nodeAt(o);return l===void 0?{point:o}:{node:l,point:s.at(l)}}down(t){let{draw:e}=this,i=this.place(t),s=this.touch=t.pointerType==="touch";if(e.canvas.node.setPointerCapture(t.pointerId),this.pointers.set(t.pointerId,i),e.canvas.node.focus({preventScroll:!0}),e.keyboard.setCursor(null),e.menu.close(),e.value.close(!0),clearTimeout(this.long),this.pointers.size===2)return this.pinch();if(this.rested=!1,s&&(this.long=setTimeout(()=>this.pressed(i),JA)),t.button===1||t.button===2||t.altKey){this.act={kind:e.camera.dim===3&&!t.shiftKey?"turn":"pan",last:i,start:i,asks:t.button===2};return}if(e.picture.placing)return e.picture.click(i);let r=e.canvas.hit(i,s);if(this.draws&&e.play.away)return this.back();Ei[e.tool]?this.begin(r,i,t):e.task.takes(e.tool)?this.act=e.task.begin(e.tool,i,this.target(i,s)):this.act=this.give(this.wanted(i,s))?{kind:"give",start:i,touch:s}:null}begin(t,e,i){let{draw:s}=this,r=i.shiftKey||s.several;if(!t){this.act=r?{kind:"box",start:e}:{kind:"pan",last:e,start:e,clear:!0};return}r?s.toggle(t):s.isPicked(t)||s.pick(t),t.type==="node"?this.act={kind:"drag",start:e,node:t.name,from:Object.fromEntries([...s.picked.nodes].map(a=>[a,s.at(a)])),number:Lf()}:this.act={kind:"none"}}move(t){let{draw:e}=this,{act:i}=this,s=this.place(t);if(this.pointers.has(t.pointerId)&&this.pointers.set(t.pointerId,s),i?.kind==="pinch")return this.pinched();let r=i?.start&&Math.hypot(s[0]-i.start[0],s[1]-i.start[1])>Nf;if(r&&clearTimeout(this.long),!i)return this.hover(s);if(i.kind==="give")return r&&this.using.chain&&(this.given=this.given.slice(-1)),this.show(s,i.touch);if(i.kind==="pan"||i.kind==="turn"){let[a,o]=[s[0]-i.last[0],s[1]-i.last[1]];r&&(i.clear=i.asks=!1),i.kind==="pan"?e.camera.pan(a,o):e.camera.turn(-a/150,o/150),i.last=s,e.canvas.update()}else i.kind==="box"?(e.rubber={box:[...i.start,...s]},e.canvas.rubber()):i.kind==="drag"?this.drag(s):i.kind==="ask"&&e.task.move(i,s,this.target(s,t.pointerType==="touch"))}hover(t){let{draw:e}=this;if(e.closed)return;let i=e.canvas.hit(t);if(e.canvas.near(i),this.using)return this.show(t);if(Ei[e.tool])return this.point(i?.type==="node"?{name:i.name,at:e.at(i.name)}:null);e.rubber={to:this.target(t)?.point},e.canvas.rubber()}back(){this.act=null,this.draw.play.home(),this.draw.tell("This is the pose that is drawn: draw here. Or stop the motion where you want, and choose Keep this pose.")}point(t){this.draw.pointed=t,!t&&!this.act&&(this.draw.rubber=null),this.draw.canvas.rubber()}drag(t){let{draw:e,act:i}=this,s=i.from[i.node];if(!i.moved&&Math.hypot(t[0]-i.start[0],t[1]-i.start[1])<=Nf)return;if(e.play.away)return this.back();let r=e.camera.unproject(t,s[e.camera.plane.axis]||0);if(!r)return e.tell(kh,!0);i.moved=!0;let a=e.tool==="move",o=a?r:e.snapped(r,new Set(Object.keys(i.from))),l={};for(let[c,h]of Object.entries(i.from))l[c]=h.map((d,u)=>u===e.camera.plane.axis||o[u]===s[u]?d:gi(d+o[u]-s[u])).slice(0,e.camera.dim);e.pointed={name:i.node,at:l[i.node]},e.drag(l,i.number,a)}up(t){let{draw:e,act:i}=this,s=this.place(t);if(this.pointers.delete(t.pointerId),clearTimeout(this.long),this.act=null,e.rubber=null,i?.asks)return e.menu.open(s,this.there(s));if(i?.kind==="give")return this.released(i,s);i?.kind==="drag"&&(e.pointed=null),i?.kind==="pan"&&i.clear?e.pick(null):i?.kind==="drag"&&i.moved?this.release(i):i?.kind==="box"?e.pickBox(i.start,s):i?.kind==="ask"&&e.task.end(i),e.canvas.rubber()}release({node:t,from:e}){let{draw:i}=this;i.tool==="move"?i.dragged().then(()=>{i.at(t).every((s,r)=>s===e[t][r])&&i.tell(i.held(t),!0)}):i.dragged()}cancel(t){clearTimeout(this.long),this.pointers.delete(t.pointerId),this.act=null,this.draw.rubber=null,this.draw.canvas.rubber()}get using(){let t=Ar.get(this.draw.tool);return t?.takes?t:null}get draws(){return!Ei[this.draw.tool]&&!this.using?.measures}get enough(){return this.given.length===1&&!!this.using.more?.(this.given[0])}there(t,e){let{draw:i}=this,s=i.canvas.hit(t,e);return s?.type==="node"?{node:s.name,point:i.at(s.name)}:{...s?{member:s.name,share:i.canvas.shareOf(s.name,t)}:{},point:s?i.canvas.pointOf(s.name,t):i.camera.unproject(t)}}wanted(t,e,i=!1){let{draw:s,using:r}=this,a=r.takes(this.given,s);if(a==="place")return this.target(t,e);if(a==="spot")return this.target(t,e,l=>s.inPlane(l));if(a==="tip"){let l=s.camera.unproject(t,this.given[0].point[s.camera.plane.axis]||0);return!l&&!i&&s.tell(kh,!0),l&&{point:l}}let o=a==="member"?this.memberAt(t,e):this.there(t,e);return o&&(a==="thing"?o.node||o.member:o[a])?o:(i||s.tell(`${r.words}: ${{node:"a node",member:"a bar, beam or link",thing:"a node or a bar"}[a]} is wanted here. ${r.about}.`,!0),null)}memberAt(t,e){let i=this.draw.canvas.hit(t,e,()=>!1);return i&&{member:i.name,share:this.draw.canvas.shareOf(i.name,t),point:this.draw.canvas.pointOf(i.name,t)}}give(t){return t?(this.given=[...this.given,t],!0):!1}now(t){let{draw:e}=this,i=t.member?void 0:e.state.nodes.includes(t.node)?t.node:e.nodeAt(t.point);return i===void 0?{...t,node:i}:{...t,node:i,point:e.at(i)}}show(t,e){let{draw:i,using:s}=this,r=this.given.map(o=>this.now(o)),a=s.takes(r,i)?this.wanted(t,e,!0):null;i.rubber={parts:s.shows?.(i,r,a)||[],from:s.shows?null:r.at(-1)?.point,to:a?.point||null},i.canvas.rubber()}released({start:t,touch:e},i){let{draw:s,using:r}=this,a=Math.hypot(i[0]-t[0],i[1]-t[1])>Nf;a&&r.takes(this.given,s)&&this.give(this.wanted(i,e,this.enough)),this.finish({pulled:a}),s.canvas.rubber()}finish({pulled:t=!1,more:e=!1}={}){let{draw:i,using:s,given:r,before:a}=this;if(!s||!r.length)return;if(s.takes(r,i)&&(e||!this.enough)){let h=s.next?.(r);r.at(-1).node&&i.pick({type:"node",name:r.at(-1).node}),h&&i.tell(h);return}let[o,l]=r.map(h=>this.now(h).point),c=s.chain&&l.every((h,d)=>h===o[d]);this.given=s.chain&&!t&&!a&&!c?r.slice(-1):[],i.rubber=null,i.tell(c?`${s.words}: ended. Another one needs two different places.`:""),c||(this.doing=this.doing.catch(()=>{}).then(()=>this.do(s,r))),a&&i.setTool(a)}async do(t,e){let{draw:i}=this,s=await t.act(i,e.map(r=>this.now(r)));this.given=this.given.map(r=>this.now(r)),s&&!this.act&&i.value.ask(s)}once(t,e){let{draw:i}=this,s=i.tool;if(!e.point)return i.tell(kh,!0);i.setTool(t.name),this.before=s;let r=["place","spot"].includes(t.takes([],i))&&!e.node?{point:i.snapped(e.point)}:e;this.given=[r],t.takes(this.given,i)&&!this.enough&&i.tell(`${t.about}.`),this.finish()}pressed(t){let{draw:e}=this;this.cancelAct(),this.act=null,this.rested=!0,this.pointers.clear(),e.menu.open(t,this.there(t,!0))}pinch(){this.cancelAct(),this.act={kind:"pinch",last:[...this.pointers.values()]}}cancelAct(){this.draw.rubber=null,this.given=[],this.before=null}leave(){this.cancelAct(),this.draw.keyboard.setCursor(null)}pinched(){let{draw:t,act:e}=this,i=[...this.pointers.values()];if(i.length<2)return;let s=l=>[(l[0][0]+l[1][0])/2,(l[0][1]+l[1][1])/2],r=l=>Math.hypot(l[0][0]-l[1][0],l[0][1]-l[1][1]),[a,o]=[s(e.last),s(i)];t.camera.pan(o[0]-a[0],o[1]-a[1]),t.camera.zoom(r(i)/(r(e.last)||1),o),e.last=i.map(l=>[...l]),t.canvas.update()}};var QA={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},Uh=class{constructor(t){Object.assign(this,{draw:t,grabbed:null}),t.canvas.node.addEventListener("keydown",e=>this.key(e))}setCursor(t){this.draw.cursor=t,this.draw.canvas.rubber()}key(t){let{draw:e}=this,{camera:i}=e;if(t.ctrlKey||t.metaKey||t.altKey)return;if(t.key==="ContextMenu"||t.key==="F10"&&t.shiftKey)return t.preventDefault(),this.ask();let s=QA[t.key];if(s&&this.grabbed)t.preventDefault(),this.nudge(s,t.shiftKey);else if(s){t.preventDefault();let[r,a]=i.across,o=i.grid*(t.shiftKey?10:1),l=e.cursor||i.snapped(i.unproject([i.width/2,i.height/2])||[0,0,0]),c=[...l];e.cursor&&(c[r]=l[r]+s[0]*o,c[a]=l[a]+s[1]*o),this.goTo(i.snapped(c))}else if(t.key==="PageDown"||t.key==="PageUp"){t.preventDefault();let r=t.key==="PageDown"?1:-1;t.shiftKey&&i.dim===3?this.lift(-r):this.hop(r)}else t.key==="Enter"&&e.cursor?(t.preventDefault(),this.enter(t)):t.key==="Escape"&&(t.preventDefault(),this.escape())}goTo(t){let{draw:e}=this,{tools:i}=e,s=e.camera.project(t),r=e.canvas.hit(s);this.setCursor(t),i.using&&i.given.length&&i.show(s),e.say(`${r?`${r.type} ${r.name}, `:""}${e.cut(t).map(a=>Number(a.toPrecision(6))).join(", ")} m`)}hop(t){let{draw:e}=this,{nodes:i,members:s}=e.state,{cursor:r}=e,a=[...i.map(l=>e.at(l)),...s.map(({ends:[l,c]})=>e.at(l).map((h,d)=>(h+e.at(c)[d])/2))],o=a.findIndex(l=>r&&l.every((c,h)=>Math.abs(c-r[h])*e.camera.scale<.5));a.length&&this.goTo(a[o<0?t>0?0:a.length-1:(o+t+a.length)%a.length])}lift(t){let{draw:e}=this,{axis:i,at:s}=e.camera.plane,r=gi(s+t*e.camera.grid);e.rail.setPlane({at:r}),e.cursor&&this.setCursor(e.cursor.map((a,o)=>o===i?r:a)),e.say(`work plane at ${"xyz"[i]} = ${r} m`)}nudge(t,e){let{draw:i}=this,{camera:s}=i,{node:r,number:a}=this.grabbed;if(i.play.away)return i.tools.back();let o=[...i.waiting&&this.grabbed.to||i.at(r)];s.across.forEach((l,c)=>o[l]=gi(o[l]+t[c]*s.grid/(e?1:4))),i.drag({[r]:i.cut(o)},a,i.tool==="move"),Object.assign(this.grabbed,{to:o,moved:!0})}grab(t){let{draw:e}=this,i=this.grabbed;this.grabbed=t?{node:t,number:Lf()}:null,i?.moved&&e.dragged(),t&&e.say(`${t} is in your hand: arrows move it, ${Ei[e.tool]}; Enter lets it go`),e.tools.point(t?{name:t,at:e.at(t)}:null)}escape(){if(this.grabbed)return this.grab(null);let{draw:t}=this,{tools:e}=t;if(t.play.away)return t.play.home();e.before&&t.setTool(e.before),e.leave(),t.pick(null)}ask(){let{draw:t}=this,{camera:e,picked:i}=t,[s]=i.nodes,[r]=i.members,a=r&&t.state.members.find(({name:h})=>h===r).ends.map(h=>t.at(h)),o=t.cursor||(s?t.at(s):a?a[0].map((h,d)=>(h+a[1][d])/2):e.unproject([e.width/2,e.height/2])||e.centre),l=e.project(o),c=!t.cursor&&(s||r);t.menu.open(l,c?s?{node:s,point:o}:{member:r,share:.5,point:o}:t.tools.there(l))}enter(t){let{draw:e}=this,{tools:i}=e,s=e.camera.project(e.cursor),r=e.canvas.hit(s),a=r?.type==="node"&&r.name;if(i.draws&&e.play.away)return i.back();i.using?i.give(i.wanted(s))&&i.finish({more:t.shiftKey}):e.task.takes(e.tool)?e.task.enter(e.tool,a?e.at(a):e.cursor):this.grabbed?this.grab(null):t.shiftKey&&r?e.toggle(r):a&&(e.tool==="move"||e.isPicked(r))?(e.pick(r),this.grab(a)):e.pick(r)}};function Fh(n){return ht("svg",{class:"icon",viewBox:"0 0 24 24",width:24,height:24,"aria-hidden":"true"},ht("path",{d:n}))}var Bh=class{constructor(t){this.tools=new Map([...Ar.values()].map(({name:e,words:i,key:s,about:r,icon:a})=>[e,g("button",{type:"button","aria-label":i,title:`${r} (${s.toUpperCase()})`,onclick:()=>t.setTool(e)},Fh(a),g("span",{},i))])),this.groups=eo.map(([e,i])=>{let s=g("button",{type:"button",class:"head","aria-label":`${e}: ${i.map(({words:a})=>a).join(", ")}`,onclick:()=>this.open(r)}),r={name:e,tools:i,head:s,buttons:i.map(a=>this.tools.get(a.name))};return r.node=g("span",{class:"group",role:"group","aria-label":e},s,r.buttons),r}),this.node=g("div",{class:"palette",role:"toolbar","aria-label":"tools"},this.groups.map(({node:e})=>e))}open(t){for(let e of this.groups)e.node.classList.toggle("open",e===t),e.head.setAttribute("aria-expanded",String(e===t))}rebuild(t,e){for(let[i,s]of this.tools)xi(s,t===i);for(let i of["positions","path"])this.tools.get(i).hidden=e===3;for(let{name:i,tools:s,head:r,buttons:a}of this.groups){let o=s.find(l=>l.name===t);r.hidden=a.every(({hidden:l})=>l),r.setAttribute("aria-current",String(!!o)),r.replaceChildren(Fh((o||s[0]).icon),g("span",{},o?o.words:i.split(" ")[0]))}t!==this.chosen&&this.open(this.groups.find(({tools:i})=>i.some(s=>s.name===t))),this.chosen=t}};var zh=class{constructor(t){this.draw=t,this.node=g("div",{class:"menu",role:"menu",tabindex:-1,hidden:!0,onkeydown:e=>this.key(e),onfocusout:e=>!this.node.contains(e.relatedTarget)&&this.close()})}open(t,e){let{draw:i}=this,s=e.node?{type:"node",name:e.node}:e.member?{type:"member",name:e.member}:null,r=e.node?["node","thing","place"]:e.member?["member","thing","place"]:["place","spot"];s&&!i.isPicked(s)&&i.pick(s);let a=eo.map(([u,f])=>[u,f.filter(p=>r.includes(p.takes?.([],i)))]),o=(u,f,p)=>g("button",{type:"button",role:"menuitem",tabindex:-1,onclick:()=>{this.close(),i.canvas.node.focus({preventScroll:!0}),f()}},p||null,u),l=[...a.flatMap(([,u])=>u.map(f=>o(f.words,()=>i.tools.once(f,e),Fh(f.icon))))];s?l.push(o("Fields",()=>i.properties.focus()),o("Delete",()=>i.remove())):l.push(o("Show all",()=>i.fit()),o("Undo",()=>i.ask({do:"undo"}))),this.node.setAttribute("aria-label",s?`what to do at ${s.name}`:"what to do here"),this.node.replaceChildren(g("b",{},s?s.name:"Here"),g("div",{class:"items"},l)),this.node.hidden=!1;let{camera:c}=i,{offsetWidth:h,offsetHeight:d}=this.node;Object.assign(this.node.style,{left:`${Math.max(4,Math.min(t[0],c.width-h-4))}px`,top:`${Math.max(4,Math.min(t[1],c.height-d-4))}px`}),this.node.querySelector("button").focus({preventScroll:!0})}close(){this.node.hidden=!0}key(t){let e=[...this.node.querySelectorAll("button")],i=e.indexOf(document.activeElement),{key:s}=t;if(t.stopPropagation(),s==="Escape"||s==="Tab"){t.preventDefault(),this.close(),this.draw.canvas.node.focus({preventScroll:!0});return}let r={ArrowDown:1,ArrowRight:1,ArrowUp:-1,ArrowLeft:-1}[s],a=e.findIndex((l,c)=>c>i&&l.textContent.trim().toLowerCase().startsWith(s.toLowerCase())),o=r?(i+r+e.length)%e.length:{Home:0,End:e.length-1}[s]??(s.length===1&&s!==" "?a:-1);o>=0&&e[o].focus(),(o>=0||s.length===1&&s!==" ")&&t.preventDefault()}};var tE=3e6,eE=1600;function iE(n){return new Promise(t=>{let e=new FileReader;e.addEventListener("load",()=>t(e.result)),e.addEventListener("error",()=>t("")),e.readAsDataURL(n)})}function nE(n,{width:t,height:e}){let i=Math.min(1,eE/Math.max(t,e)),s=g("canvas",{width:Math.round(i*t),height:Math.round(i*e)});return s.getContext("2d").drawImage(n,0,0,s.width,s.height),s.toDataURL("image/jpeg",.85)}var Gh=class{constructor(t){Object.assign(this,{draw:t,image:null,placing:null,points:[],opacity:.5,shown:!0}),this.file=g("input",{type:"file",accept:"image/*","aria-label":"picture to trace",onchange:()=>this.load()}),this.body=g("div",{}),this.node=de("Picture to trace",this.file,this.body),this.node.open=!1,this.image=null}async load(){let[t]=this.file.files;if(!t)return;let e=await iE(t),i=new Image;i.addEventListener("load",()=>{let{camera:s}=this.draw,{axis:r,at:a}=s.plane,[o,l]=s.across,c=.6*Math.min(s.width,s.height)/s.scale/Math.max(i.naturalWidth,i.naturalHeight),h=s.unproject([s.width/2,s.height/2])||[0,0,0];h[o]-=c*i.naturalWidth/2,h[l]+=c*i.naturalHeight/2,this.loaded=i,this.image={source:i.src,width:i.naturalWidth,height:i.naturalHeight,axes:[o,l],axis:r,at:a,turn:[c,0],origin:[h[o],h[l]]},this.points=[],this.rebuild(),this.draw.canvas.update(),this.keep(!0)}),i.addEventListener("error",()=>this.draw.tell("This file is no picture that the browser can show.",!0)),i.src=e}async keep(t=!1){if(!this.image||this.draw.closed)return;let{source:e,...i}=this.image,s={do:"picture",place:{...i,opacity:this.opacity,shown:this.shown}};t&&(s.source=e.length<tE?e:nE(this.loaded,i)),await this.draw.ask(s)}take(t){if(!t||this.image)return;let{opacity:e,shown:i,...s}=t.place;Object.assign(this,{image:{...s,source:t.source},opacity:e,shown:i}),this.rebuild()}remove(){this.image=null,this.file.value="",ve(this.body),this.draw.canvas.update(),this.draw.ask({do:"picture",place:null})}rebuild(){if(!this.image)return;let t=g("input",{type:"range",min:0,max:1,step:.05,value:this.opacity,"aria-label":"opacity of the picture"});t.addEventListener("input",()=>{this.opacity=Number(t.value),this.draw.canvas.update()}),t.addEventListener("change",()=>this.keep());let e=["Click the first point in the picture.","Click the second point in the picture."];ve(this.body,g("div",{class:"row"},Wn("shown",this.shown,i=>{this.shown=i,this.draw.canvas.update(),this.keep()}),t,It("Remove",()=>this.remove(),{"aria-label":"remove the picture"})),It("Place by two points",()=>this.begin()),this.placing?g("p",{role:"status"},e[this.points.length]||""):null,this.points.length===2&&!this.placing?this.entries():null)}begin(){Object.assign(this,{placing:!0,points:[]}),this.rebuild(),this.draw.tell("Click the first point in the picture.")}click(t){let{origin:e,turn:i,axes:s,at:r}=this.image,a=this.draw.camera.unproject(t,r);if(!a)return;let[o,l]=[a[s[0]]-e[0],a[s[1]]-e[1]],[c,h]=i,d=c*c+h*h;this.points.push([(c*o+h*l)/d,(h*o-c*l)/d]),this.points.length===2&&(this.placing=null),this.draw.tell(this.points.length===2?"Now write where the two points are.":"Click the second point in the picture."),this.rebuild()}entries(){let t=this.image.axes.map(s=>"xyz"[s]),e=["first","second"].map((s,r)=>t.map((a,o)=>le(a,r&&!o?1:0,()=>{},{size:5,name:`${a} of the ${s} point in m`}))),i=()=>{let s=e.map(r=>r.map(a=>Number(a.querySelector("input").value)));if(s.flat().some(r=>!Number.isFinite(r)))return this.draw.tell("Write the places as numbers, in m.",!0);this.fit(s)};return g("fieldset",{},g("legend",{},"Their places (m)"),e.map(s=>g("div",{class:"row"},s)),It("Place",i))}fit([t,e]){let[i,s]=this.points.map(([u,f])=>[u,-f]),[r,a]=[s[0]-i[0],s[1]-i[1]],[o,l]=[e[0]-t[0],e[1]-t[1]],c=r*r+a*a;if(!c||!(o||l))return this.draw.tell("The two points coincide. Choose two that are far apart.",!0);let[h,d]=[(r*o+a*l)/c,(r*l-a*o)/c];this.image.turn=[h,d],this.image.origin=[t[0]-h*i[0]+d*i[1],t[1]-d*i[0]-h*i[1]],this.points=[],this.rebuild(),this.draw.tell(""),this.draw.canvas.update(),this.keep()}place(t){let{image:e,draw:i}=this;if(!e||!this.shown)return t.replaceChildren();let[s,r]=e.axes,[a,o]=e.turn,l=(f,p)=>{let y=[0,0,0];return[y[s],y[r],y[e.axis]]=[e.origin[0]+a*f+o*p,e.origin[1]+o*f-a*p,e.at],i.camera.project(y)},[c,h,d]=[l(0,0),l(1,0),l(0,1)],u=[h[0]-c[0],h[1]-c[1],d[0]-c[0],d[1]-c[1],c[0],c[1]];this.element||=ht("image",{});for(let[f,p]of Object.entries({href:e.source,width:e.width,height:e.height,opacity:this.opacity,preserveAspectRatio:"none",transform:`matrix(${u.join(" ")})`}))this.element.setAttribute(f,p);t.replaceChildren(this.element)}};var lx=4,cx=-100,Vh={2:"xy",3:"xyz"},sE="What still moves is told in the panel. No single click stops it: clamp a node that turns, join beams stiffly, or add a bar or a support to each part that moves.",hx=(n,t,e)=>[`Hold ${n}${t===e?"":` along ${[...t].join(" and ")}`}`,`support at ${n}`,["fixed",n],t,!1],Df=(n,t,e,i,s,r)=>[n,t,["drives",He(i,"drives",e)],s,r];function rE(n){let{dim:t,nodes:e,members:i,fixed:s,drives:r,mobility:a,missing:o,data:l,force:c}=n;if(!i.length||!a)return[];let h=new Map(e.map(m=>[m,i.filter(({ends:x})=>x.includes(m)).length])),d=m=>(s[m]||"").length===t;if(a.undriven>0){if(t===3)return c?[]:aE(n);let m=a.undriven>1?e.filter(w=>h.get(w)===1&&!d(w)):[];if(m.length)return m.slice(0,lx).map(w=>hx(w,Vh[2],Vh[2]));if(c)return[];let x=new Set(r.map(({bar:w})=>w));return i.filter(({name:w,ends:b})=>d(b[0])!==d(b[1])&&!x.has(w)&&w in(l.bars||{})).slice(0,lx).map(({name:w,ends:b})=>Df(`Turn ${w} about ${b.find(d)}`,`drive ${w} about ${b.find(d)}`,"motor",l,{kind:"angle",bar:w},!0))}if(!o.some(m=>m.startsWith("No load")))return[];let u=m=>(s[m]?0:i.length)+h.get(m),f=e.filter(m=>!d(m)),p=Math.max(...f.map(u)),y=f.filter(m=>u(m)===p).at(-1);return y?[[`${-cx} N down at ${y}`,`load on ${y}`,["loads",He(l,"loads",`F_${y}`)],{node:y,force:[...Vh[t]].map((m,x)=>`${x===t-1?cx:0} N`)},r.length>0]]:[]}function aE({clicks:n,data:t,mobility:e}){let i=e.undriven===1,s={hold:({node:r,axes:a})=>hx(r,a,Vh[3]),turn:({bar:r,node:a,axis:o})=>Df(`Turn ${r} about ${a}, axis ${o}`,`drive ${r} about ${a}`,"motor",t,{kind:"angle",bar:r,axis:o},i),push:({node:r,axis:a})=>Df(`Push ${r} along ${a}`,`drive ${r} along ${a}`,"slide",t,{kind:"coordinate",node:r,axis:a},i),join:({ends:r})=>[`Bar ${r.join(" to ")}`,`bar from ${r.join(" to ")}`,["bars",He(t,"bars","b",!1)],r,!1]};return n.length?n.map(r=>s[r.do](r)):sE}function kf(n,t){let e=rE(n.state);if(!e.length)return null;let i=async(s,r,a)=>{(await n.edit({do:"set",path:s,value:r})).kind==="drawing"&&a&&!t.playing&&t.toggle()};return g("span",{class:"next"},"Next: ",typeof e=="string"?e:e.map(([s,r,a,o,l])=>It(s,()=>i(a,o,l),{"aria-label":r})))}var oE=/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;function Hh(n,t){return t==="rad"?`${Kt(n*180/Math.PI)} deg/s`:St(n,"m/s")}var Wh=class{constructor(t){Object.assign(this,{play:t,trying:null}),this.of={rad:{text:"",good:"",error:""},m:{text:"",good:"",error:""}}}asked(t,e){return oE.test(t)?`${t} ${e==="rad"?"deg/s":"m/s"}`:t||null}good(t){return this.asked(this.of[t].good,t)}node(t){let{unit:e}=t.drives[t.lead],i=this.of[e],s=le("Rate",i.text,(a,o)=>this.take(o,e),{hint:Hh(t.rate,e),size:10,name:"rate of the drive"});if(!i.error)return s;let r=s.querySelector("input");return r.setAttribute("aria-invalid","true"),r.setAttribute("aria-describedby","rate-error"),[s,g("span",{id:"rate-error",class:"wrong",role:"alert"},`${i.error} Shown at ${Hh(t.rate,e)}.`)]}async take(t,e){let{play:i}=this,{revision:s}=i.draw.state,r=this.of[e],a=i.command(this.asked(t,e));Object.assign(r,{text:t,error:""}),this.trying=a;let o=await i.ask(a);if(i.draw.state.revision!==s)return this.take(t,e);o.kind==="error"?(r.error=o.message,i.rebuild()):i.isFilm(o)&&(r.good=t,i.show(o))}};var lE=8,vs=2*Math.PI;function Uf(n){let t=n.filter(e=>Number.isFinite(e)&&e>0).sort((e,i)=>e-i);return t.length?Math.min(t.at(-1),lE*t[t.length>>1]):0}var Of=n=>Number.isFinite(n)?n:null,$h=class{constructor(t){let[e,i]=gh(t);Object.assign(this,e,{header:{supports:[]},skin:[],directors:[],arrays:{}});let s=i.byteOffset;for(let[l,c]of Object.entries(e.arrays)){let h=new Float32Array(t,s,c.reduce((d,u)=>d*u,1));this.arrays[l]={data:h,shape:c},s+=h.byteLength}this.time=this.arrays.time.data,this.frames=this.time.length,[,,this.dim]=this.arrays.position.shape,this.columns=new Map(this.members.map((l,c)=>[l,c]));let{data:r}=this.arrays.position,[a,o]=[Math.min,Math.max].map(l=>Array.from({length:this.dim},(c,h)=>r.reduce((d,u,f)=>f%this.dim===h?l(d,u):d,r[h])));this.extent={size:Math.hypot(...o.map((l,c)=>l-a[c]))},this.moving=Bc(this),this.largest=Uf(Array.from({length:this.frames},(l,c)=>Math.max(0,...this.row("member_force",c).map(Math.abs).filter(Number.isFinite)))),this.judge(),this.lead=this.drives.findIndex(({name:l})=>l===this.swept[0])}judge(){let{data:t}=this.arrays.used||{data:[]},e=this.judged?.length;this.most=t.reduce((i,s,r)=>s>(i?.value??-1)?{value:s,member:this.judged[r%e],sample:Math.floor(r/e)}:i,null),this.never=(this.judged||[]).filter((i,s)=>Array.from({length:this.frames},(r,a)=>t[a*e+s]).every(Number.isNaN))}used(t){if(!this.judged)return null;let e=this.judged.length?this.row("used",t):[];return Object.fromEntries(this.judged.map((i,s)=>[i,e[s]]).filter(([,i])=>Number.isFinite(i)))}row(t,e){let{data:i}=this.arrays[t],s=i.length/this.frames;return Array.from(i.subarray(e*s,(e+1)*s))}above(t){let{data:e}=this.arrays[t],i=e.reduce((s,r)=>Math.min(s,r));return Array.from(e,s=>s-i)}position(t,e){let{data:i}=this.arrays.position,s=(t*this.nodes.length+e)*this.dim;return[i[s],i[s+1],this.dim===3?i[s+2]:0]}get falls(){return!this.swept.length}get unit(){return this.falls?"s":this.drives[this.lead].unit}value(t,e=this.lead){if(e<0)return this.time[t];let i=this.arrays.drive_position.data[t*this.drives.length+e];return this.whole&&this.drives[e].unit==="rad"?(i%vs+vs)%vs:i}held(t,e=this.lead){return e<0?NaN:this.arrays.drive_force.data[t*this.drives.length+e]}shown(t,e){let i=this.row("member_force",t),s=r=>{if(!this.arrays[r])return{};let a=this.row(r,t).map(Of),o=a.length/this.supports.length,l=this.supports.map((c,h)=>[c,a.slice(h*o,(h+1)*o)]);return Object.fromEntries(r==="reaction"?l:l.filter(([c])=>this.moments.includes(c)))};return{places:this.nodes.map((r,a)=>this.position(t,a).slice(0,this.dim)),force:e.members.map(({name:r})=>Of(i[this.columns.get(r)])),reaction:s("reaction"),reaction_moment:s("reaction_moment"),drives:e.drives.map(r=>{let a=this.drives.findIndex(({name:o})=>o===r.name);return{...r,value:this.value(t,a),force:Of(this.held(t,a))}}),unsure:this.unsure,used:this.used(t)}}swing(t,e){let[i,s,r]=[1/0,-1/0,null];for(let o=0;o<this.frames;o++){let[l,c]=[this.position(o,t),this.position(o,e)],h=Math.atan2(c[1]-l[1],c[0]-l[0]);r!==null&&(h+=vs*Math.round((r-h)/vs)),r=h,i=Math.min(i,h),s=Math.max(s,h)}let a=vs*Math.floor((i+Math.PI)/vs);return[i-a,s-a]}};var dx="all drives",Ff="let go",cE=6,hE=2,Bf=4,dE=100,uE=.01,fE={round:"Full turn",back:"There and back",once:"Once"},Xh=class extends xr{constructor(t){super(),Object.assign(this,{draw:t,film:null,drawn:null,way:"round",chosen:"",atSpeed:!1,rate:new Wh(this),pace:null,told:0,awaited:0,turn:0,touch:matchMedia("(hover: none)").matches}),this.controls=g("div",{class:"row"}),this.aside=g("span",{class:"row",hidden:!0},It("Keep this pose",()=>this.keep(),{title:"Draw the mechanism in the pose shown"}),It("Back",()=>this.home(),{title:this.hint("Back to the pose that is drawn","Escape"),"aria-label":"back to the drawn pose"})),this.words=g("p",{class:"words",role:"status"}),this.canvas=g("canvas",{class:"plot",role:"img","aria-label":"force or torque of the drive along its range"}),this.cursor=g("i",{class:"now"}),this.graph=g("div",{class:"graph",hidden:!0},this.canvas,this.cursor);for(let e of["pointerdown","pointermove"])this.graph.addEventListener(e,i=>i.buttons&&this.point(i));this.node=g("section",{class:"motion","aria-label":"motion"},this.controls,this.words,this.graph),this.node.addEventListener("keydown",e=>{e.key!==" "||e.target.type!=="range"||(e.preventDefault(),this.togglePlay())}),new ResizeObserver(()=>this.curve()).observe(this.graph)}hint(t,e){return this.touch?t:`${t} (${e})`}get away(){return this.drawn!==null}get falls(){let{drives:t,mobility:e}=this.draw.state;return this.chosen===Ff||!t.length||e?.undriven>0}get movable(){let{drives:t,mobility:e}=this.draw.state;return!!(t.length||e?.freedoms)}get drives(){let t=this.falls?[]:this.draw.state.drives.map(({name:e})=>e);return this.chosen===dx?t:[t.includes(this.chosen)?this.chosen:t[0]].filter(Boolean)}async toggle(){if(!this.draw.closed){if(this.film)return this.togglePlay();this.going=!0,await this.load()}}async load(){if(!this.movable)return this.refuse("Nothing is driven yet.");let{revision:t}=this.draw.state,e=++this.turn,i=await this.ask(this.command(this.falls?null:this.rate.good(this.unit)));if(!(e!==this.turn||t!==this.draw.state.revision)){if(!this.isFilm(i))return this.refuse(i.message||"");this.show(i),this.going&&!this.playing&&this.togglePlay(),this.going=!1}}get unit(){return this.draw.state.drives.find(({name:t})=>t===this.drives[0]).unit}command(t){return this.falls?{do:"let_go",held:this.chosen!==Ff,strength:this.draw.shown.strength}:{do:"sweep",drives:this.drives,rate:this.atSpeed?t:null,at_speed:this.atSpeed,strength:this.draw.shown.strength}}async ask(t){this.awaited++;let e=await this.draw.ask(t);return this.awaited--,e}isFilm(t){return t.kind==="sweep"&&t.revision===this.draw.state.revision}show(t){let{value:e}=this,i=this.node.contains(document.activeElement),s=this.film,r=s&&!this.away;Object.assign(this,{film:t,key:"",failed:"",index:t.here}),t.number=this.loads=(this.loads||0)+1,this.setLead(t),this.pace&&Object.assign(this,{speed:this.pace,speeds:[...new Set([...this.speeds,this.pace])].sort((a,o)=>a-o)}),this.way=t.falls?"once":!t.whole&&this.way==="round"?"back":t.whole&&!this.asked?"round":this.way,this.time=new mr(this),this.rebuild(),r?this.time.update():this.goTo(e===void 0?t.here:this.nearest(e)),this.playing&&this.start(),this.judge(),!s&&(this.reveal(),i&&this.time.button.focus())}judge(){let{film:t}=this;t&&!t.judged&&this.draw.shown.strength&&!this.awaited&&this.load(),this.say()}setSpeed(t){this.pace=t===gr(this.duration)?null:t,super.setSpeed(t)}reveal(){let{draw:t,film:e}=this,{camera:i}=t;t.canvas.resize();let s=Array.from({length:e.frames},(a,o)=>e.nodes.map((l,c)=>e.position(o,c))).flat(),r=([a,o])=>a<0||o<0||a>i.width||o>i.height;s.some(a=>r(i.project(a)))&&(i.fit(s),t.canvas.update())}refuse(t){Object.assign(this,{failed:t,going:!1}),this.rebuild()}nearest(t){let{film:e}=this,i=e.here;for(let s=0;s<e.frames;s++)Math.abs(e.value(s)-t)<Math.abs(e.value(i)-t)&&(i=s);return i}togglePlay(){super.togglePlay(),this.playing?this.draw.diagram.spoil():this.tell()}goTo(t){let{draw:e,film:i}=this,{state:s}=e;this.index=Math.min(Math.max(Math.round(t),0),i.frames-1);let r=i.shown(this.index,s);this.drawn||=Object.fromEntries(Object.keys(r).map(a=>[a,s[a]])),this.value=i.value(this.index),Object.assign(s,r),e.root.classList.add("away"),this.aside.hidden=!1,e.canvas.update(this.playing),this.time.update(),this.mark(),(!this.playing||performance.now()-this.told>dE)&&this.tell()}tell(){let{draw:t}=this;this.told=performance.now(),t.status.numbers(t.state),t.properties.follow(),this.playing||t.diagram.follow(),this.say()}pause(){super.pause(),this.tell()}home(){this.away&&(this.playing=!1,Object.assign(this.draw.state,this.drawn),this.drawn=null,this.draw.root.classList.remove("away"),this.draw.canvas.update(),this.index=this.film.here,this.time.update(),this.aside.hidden=!0,this.tell(),this.mark())}spoil(){let{state:t}=this.draw;if(this.film?.revision===t.revision){this.away&&(this.drawn=null,this.goTo(this.index)),this.going&&this.toggle(),this.going=!1;return}let e=this.going||this.playing;Object.assign(this,{film:null,drawn:null,playing:!1,failed:"",going:!1}),this.draw.root.classList.remove("away"),this.rebuild(),e&&this.toggle()}async keep(){let{film:t,index:e,draw:i}=this,s=Object.fromEntries(t.drives.map(({name:r},a)=>[r,t.arrays.drive_position.data[e*t.drives.length+a]]));this.value=void 0,await i.edit({do:"put",...t.falls?{sample:e}:{values:s}})}point(t){if(!this.frame)return;let e=t.clientX-this.canvas.getBoundingClientRect().left,{xs:i}=this,s=0;for(let r=0;r<i.length;r++)Math.abs(this.frame.x(i[r])-e)<Math.abs(this.frame.x(i[s])-e)&&(s=r);this.seek(this.order[s])}rebuild(){let{draw:t,film:e}=this,{state:i}=t;if(!i)return;let s=i.drives.map(({name:f})=>f),r=f=>{Object.assign(this,f);let p=this.playing||!e;return this.home(),this.film=null,p&&e?this.toggle():e?this.load():this.rebuild()},a=e?this.time.node:It("▶ Play",()=>this.toggle(),{class:"play",title:this.hint("Play: the drives go through their range","space"),disabled:!this.movable}),o=i.mobility?.undriven?[["","hold still"]]:[...s,...s.length>1?[dx]:[]],l=s.length?ye("Drive",[...o,Ff],this.chosen||o[0],f=>r({chosen:f,value:void 0}),"drive that moves"):null,c=Object.entries(fE).filter(([f])=>e?.whole||f!=="round"),h=e&&!e.falls?ye("Way",c,this.way,f=>{this.asked=!0,this.setWay(f)},"way through the range"):null,d=e?g("label",{class:"entry"},g("span",{},"Speed"),this.time.speed):null,u=(e?!e.bent&&!e.falls:this.atSpeed)?ye("Forces",[["","at rest"],["on","at speed"]],this.atSpeed?"on":"",f=>r({atSpeed:!!f}),"forces while it moves"):null;ve(this.controls,a,d,l,h,u,e&&this.atSpeed?this.rate.node(e):null,this.aside),this.aside.hidden=!this.away,e?this.graph.before(this.words):this.controls.append(this.words),this.graph.hidden=!e,this.say(),this.curve()}say(){let{film:t,draw:e}=this,{state:i}=e,s=[i.revision,t?.number,t&&this.ended(),this.limit,this.failed,t&&this.unjudged(),e.shown.strength].join();if(s===this.saidOf)return;if(this.saidOf=s,t)return ve(this.words,...this.found());let r=this.failed||(i.drives.length||!i.members.length?"":this.movable&&i.weights?.all>0?"Nothing is driven yet: Play lets it go.":"Nothing is driven yet.");ve(this.words,r?g("span",{},`${r} `):null,kf(e,this))}ended(){let t=this.film.frames-1,e=Math.max(1,uE*t);return[this.index<=e,this.index>=t-e]}found(){let{film:t}=this,e=t.frames-1,i=this.ended(),s=t.ends.map((u,f)=>u&&g("b",{class:i[f]?"here":""},`${u} `)),r=t.swept.map(u=>{let f=t.drives.findIndex(y=>y.name===u),{unit:p}=t.drives[f];return t.whole?`${u}: full turn`:`${u}: ${St(t.value(0,f),p)} to ${St(t.value(e,f),p)}`}),a=Array.from({length:t.frames},(u,f)=>Math.abs(t.held(f))),o=a.reduce((u,f,p)=>f<=this.limit*(1+1e-6)&&f>(a[u]??0)?p:u,-1),{unit:l}=t,c=a[o]>0?` Largest ${l==="rad"?"torque":"force"}${this.cut?" away from the dead point":""} ${St(a[o],l==="rad"?"N m":"N")} at ${St(t.value(o),l)}.`:"",h=t.at_speed?`${t.swept[0]} at ${Hh(t.rate,l)}. `:"";t.falls&&r.push(`Let go${t.arrays.kinetic_energy.data[0]>0?" with the velocities of the model":", from rest"}${t.drives_hold&&t.drives.length?", while the drives hold still":""}`);let d=t.bent?"Parts that bend or stretch are in equilibrium, at rest. ":"";return[...s,g("span",{},`${d}${h}${r.slice(0,3).join("; ")}.${c} ${this.swings().join(" ")} `),this.strength(),kf(this.draw,this)]}unjudged(){let{film:t,draw:e,index:i}=this;if(!e.shown.strength||!t.judged)return[];let s=t.used(i);return t.judged.filter(r=>!(r in s)&&!t.never.includes(r))}strength(){let{film:t,draw:e}=this,{most:i,never:s}=t;if(!e.shown.strength||!t.judged)return null;if(!i)return g("span",{},"Strength is not checked: it needs sections and materials. ");let r=l=>`${l.slice(0,Bf).join(", ")}${l.length>Bf?` and ${l.length-Bf} more`:""}`,a=this.unjudged(),o=t.unsure.length?`Not unique: the forces of ${r(t.unsure)}, and so their strength. `:"";return g("span",{class:i.value>1?"here":""},`Strength: at most ${St(i.value,"%")} of what is allowed, of ${i.member} at ${this.placeOf(i.sample)}. `,s.length?`Not checked: ${r(s)}. `:"",a.length?`Not checked in this pose: ${r(a)}. `:"",o)}swings(){let{film:t,draw:e}=this,{state:i}=e;if(i.dim!==2)return[];let s=o=>(i.fixed[o]||"").length===2,r=new Set(i.drives.map(({bar:o})=>o));return i.members.filter(({name:o,ends:l,goes_on:c})=>!c&&s(l[0])!==s(l[1])&&!r.has(o)).slice(0,hE).map(({name:o,ends:l})=>{let[c,h]=(s(l[0])?l:[...l].reverse()).map(p=>t.nodes.indexOf(p)),[d,u]=t.swing(c,h),f=p=>Kt(p*180/Math.PI,4);return u-d>2*Math.PI-.1?`${o} turns all round.`:u-d>1e-6?`${o} swings ${f(u-d)} deg (${f(d)} to ${f(u)} deg).`:""})}placeOf(t){let{film:e}=this;return`${e.falls?"":`${e.swept[0]} `}${St(e.value(t),e.unit)}`}said(){let{film:t}=this;return t.swept.length<2?this.placeOf(this.index):`${Kt(100*this.index/(t.frames-1),3)} %`}curve(){let{film:t}=this;if(!t||this.graph.hidden||!this.graph.clientWidth)return;let{unit:e}=t,i=e==="rad",s=t.swept.length===1,r=d=>s?t.value(d)*(i?180/Math.PI:1):t.time[d]-t.time[0];this.order=Array.from({length:t.frames},(d,u)=>u).sort((d,u)=>r(d)-r(u)),this.xs=this.order.map(r);let a=t.drives.map((d,u)=>({...d,d:u})).filter(d=>t.swept.includes(d.name)&&d.unit===e).slice(0,3),o=a.map(({d})=>Uf(Array.from({length:t.frames},(u,f)=>Math.abs(t.held(f,d)))));this.limit=Math.max(...o),this.cut=a.some(({d},u)=>Array.from({length:t.frames},(f,p)=>Math.abs(t.held(p,d))).some(f=>f>o[u]*(1+1e-6)));let l=a.map(({name:d,d:u},f)=>({x:this.xs,y:this.order.map(p=>Math.abs(t.held(p,u))>o[f]*(1+1e-6)?NaN:t.held(p,u)),label:d})),c=i?"torque":"force",h=()=>["kinetic","potential"].map(d=>({x:this.xs,y:t.above(`${d}_energy`),label:d}));t.falls?this.frame=Di(this.canvas,h(),{unit:"J",xUnit:"s",title:"energy"}):this.frame=Di(this.canvas,l,{unit:i?"N m":"N",xUnit:s?i?"deg":"m":"s",title:this.atSpeed?`driving ${c}`:`holding ${c}`}),this.place=r,this.mark(),this.say()}mark(){this.frame&&this.film&&(this.cursor.style.left=`${this.frame.x(this.place(this.index)).toFixed(1)}px`)}paths(t){let{film:e,draw:i}=this,{camera:s,picked:r}=i,a=e?e.moving.filter(l=>e.moving.length<=cE||r.nodes.has(e.nodes[l])):[],o=`${s.key};${a}`;o===this.key&&t.childElementCount===a.length||(this.key=o,t.replaceChildren(...a.map(l=>ht("path",{class:"path",d:`M${Array.from({length:e.frames},(c,h)=>s.project(e.position(h,l)).slice(0,2).map(d=>d.toFixed(1)).join(" ")).join("L")}`}))))}};var pE=60;function mE(n,t){let e=t.toLowerCase().split(/\s+/).filter(Boolean);return n.filter(({name:i,of:s})=>e.every(r=>`${i} ${s}`.toLowerCase().includes(r)))}var gE=n=>String(n).replace(/ mm$/,"");function xE({kind:n,outer:t,inner:e,diameter:i,width:s,height:r}){let a={tube:[t,e],rod:[i],rectangle:[s,r]}[n];return a?`${n} ${a.map(gE).join(" x ")}${String(a[0]).endsWith("mm")?" mm":""}`:`${n} of its own`}function yE(n,t,e,i){let s=g("input",{type:"search","aria-label":`find ${e}`,placeholder:"steel 60.3, inch 0.75 ...",size:20}),r=g("tbody",{}),a=g("p",{class:"faint",role:"status"}),o=g("table",{class:"numbers catalogue"},g("thead",{},g("tr",{},["section","A (cm²)","I (cm⁴)","kg/m"].map(d=>g("th",{},d)))),r),l=g("div",{class:"finder",hidden:!0},g("label",{class:"entry"},g("span",{},"Find"),s),g("div",{class:"rows"},o),a),c=async()=>{n.catalogue||=await n.ask({do:"sections"});let d=mE(n.catalogue.rows,s.value),u=d.slice(0,pE),f=n.catalogue.densities[i];r.replaceChildren(...u.map(({name:p,of:y,section:m,area:x,inertia:_})=>g("tr",{},g("th",{},It(p,()=>t(m),{"aria-label":`${p}, ${y}`,title:y,class:"link"}),g("small",{},` ${y}`)),[1e4*x,1e8*_,f*x].map(w=>g("td",{title:f?"":"choose a material first"},Kt(w,4)))))),a.textContent=d.length>u.length?`${d.length-u.length} more: type a part of the name.`:d.length?"":"Nothing is called so."};s.addEventListener("input",c);let h=It("Find ...",()=>{l.hidden=!l.hidden,h.setAttribute("aria-expanded",String(!l.hidden)),!l.hidden&&(c(),s.focus())},{"aria-label":`catalogue, ${e}`,"aria-expanded":"false"});return[h,l]}function io(n,t,e,i,s){let r=[...Object.keys(n.state.data.sections||{}),...n.choices.sections],a=t&&typeof t=="object"?"own":t||"",o=le("Outer",a==="own"?t.outer??t.diameter:"",()=>{},{hint:"20 mm",size:6,name:`outer diameter, ${i}`}),l=le("Inner",a==="own"?t.inner:"",()=>{},{hint:"0",size:6,name:`inner diameter, ${i}`}),h=g("span",{class:"row",hidden:a!=="own"},o,l,It("Set",()=>{let[p,y]=[o,l].map(x=>x.querySelector("input").value.trim()),m=[p,y].find(x=>Number(x)!==0&&Number.isFinite(Number(x)));if(m!==void 0)return n.tell(`A diameter needs its unit, or it would be metres: ${m} mm.`,!0);p&&e(!y||Number(y)===0?{kind:"rod",diameter:p}:{kind:"tube",outer:p,inner:y})},{"aria-label":`set ${i}`})),[d,u]=yE(n,e,i,s),f=ye("Section",[["",i.endsWith("of the model")?"none":"of the model"],...new Set(r),["own",a==="own"?xE(t):"tube or rod ..."]],a,p=>{h.hidden=p!=="own",p!=="own"&&e(p||null)},i);return g("span",{class:"row"},f,d,h,u)}function no(n,t,e,i){let s=[...Object.keys(n.state.data.materials||{}),...n.choices.materials],r=t&&typeof t=="object"?[["own","of its own"]]:[];return ye("Material",[["",i.endsWith("of the model")?"none":"of the model"],...new Set(s),...r],r.length?"own":t||"",a=>a!=="own"&&e(a||null),i)}function so(n,t){let{weights:e}=n.state,i=e?.members[t];if(!e)return"";let s=`all: ${St(e.all,"kg")}`;return t===void 0?s:i?`weighs ${St(i,"kg")}, ${s}`:"weighs nothing: no section and material, no mass"}var vE=[["rigid","rigid"],["driven","driven length"],["elastic","elastic (spring)"],["cable","cable"],["free","free (measures only)"]],zf=[["active","active member (rods, screw, motor)"],["beam","beam (bends)"],["link","link (more pins)"]],ux={angle_spring:"Angle spring",body:"Body"},fx=12,Sn=[..."xyz"],qh=class{constructor(t){this.draw=t,this.body=g("div",{}),this.forms=new Sr(t,()=>this.rebuild()),this.node=de("Picked",this.body),this.fresh=g("div",{}),this.freshNode=de("Node by its place",this.fresh)}focus(){this.node.open=!0,(this.body.querySelector("input[type=text]")||this.body.querySelector("select")).focus()}set(t,e){return this.draw.edit({do:"set",path:t,value:e})}entry(t,e){let i=this.draw.state.data[t]?.[e];return Array.isArray(i)?{[{nodes:"at",links:"nodes"}[t]||"ends"]:i}:i||{}}rebuild(){let{draw:t}=this,{picked:e,state:i}=t;if(!i)return;let s=[...e.nodes],r=[...e.members],a=this.lists(i,s,r);ve(this.fresh,this.newNode()),s.length===1&&!r.length?ve(this.body,a,this.ofNode(s[0])):r.length===1&&!s.length?ve(this.body,a,this.ofMember(r[0])):ve(this.body,a,g("p",{class:"faint"},s.length+r.length?[mx(s,"node"),mx(r,"member")].filter(Boolean).join("; "):"Nothing is picked."),r.length>1?this.ofMany(r):null,this.making([...r.length===2?["angle_spring"]:[],...s.length+r.length>1?["body"]:[]]),i.nodes.length?null:this.other(i.dim))}lists(t,e,i){let s=(r,a,o)=>ye("",[["",`${r} ...`],...a],o.length===1?o[0]:"",l=>this.draw.pick(l?{type:r,name:l}:null),`pick a ${r}`);return g("div",{class:"row"},s("node",t.nodes,e),s("member",[...new Set(t.members.map(({name:r})=>r))],i),e.length+i.length===1?this.naming(e.length?"nodes":We(this.draw,i[0]).table,[...e,...i][0]):null)}other(t){let e=t===2?"Draw in space":"Draw in the plane";return g("div",{class:"row"},g("span",{class:"faint"},`This drawing is ${t===2?"planar":"in space"}.`),It(e,()=>this.draw.edit({do:"fresh",dim:5-t})))}newNode(){let{dim:t}=this.draw.state,e=Sn.slice(0,t).map(s=>le(s,"",()=>{},{hint:"0",size:6,name:`${s} of the new node`})),i=async()=>{let s=e.map(a=>a.querySelector("input").value.trim()||"0");(await this.draw.edit({do:"add",at:s.map(a=>Number.isFinite(Number(a))?Number(a):a)})).kind==="drawing"&&(this.draw.reveal(),this.fresh.querySelector('[aria-label="x of the new node"]').focus())};for(let s of e)s.addEventListener("keydown",r=>r.key==="Enter"&&i());return g("div",{class:"row"},e,It("Add node",i),g("small",{},"m, or with a unit"))}ofNode(t){let{draw:e}=this,{state:i}=e,s=this.entry("nodes",t),r=Sn.slice(0,i.dim).map((l,c)=>le(l,px(s.at?.[c]),h=>{if(h===null)return this.rebuild();let d=[...s.at];d[c]=h,e.edit({do:"move",places:{[t]:d}}).then(()=>e.reveal())},{size:8,name:`${l} of ${t}`})),a=i.fixed[t]||"",o=Sn.slice(0,i.dim).map((l,c)=>Wn(l,a.includes(l),h=>this.set(["fixed",t],Sn.slice(0,i.dim).filter(d=>d===l?h:a.includes(d)).join("")||null),`hold ${t} along ${l}`));return[g("fieldset",{},g("legend",{},"Place (m, or with a unit: 50 mm, 2 in)"),g("div",{class:"row"},r)),g("fieldset",{},g("legend",{},"Support: held along"),g("div",{class:"row"},o,It("All",()=>this.set(["fixed",t],Sn.slice(0,i.dim).join("")),{"aria-label":`hold ${t}`}),It("Free",()=>this.set(["fixed",t],null),{"aria-label":`free ${t}`}))),this.load(t),g("div",{class:"row"},le("Mass",s.mass,l=>this.set(["nodes",t,"mass"],l),{hint:"0 kg",name:`mass of ${t}`}),this.slide(t))]}slide(t){let{state:e}=this.draw,i=Object.entries(e.data.drives||{}).find(([,s])=>s.kind==="coordinate"&&s.node===t);return ye("Driven along",[["","-"],...Sn.slice(0,e.dim)],i?.[1].axis||"",s=>this.set(["drives",i?.[0]||this.free("drives","slide")],s?{kind:"coordinate",node:t,axis:s}:null),`drive ${t} along`)}load(t){let{state:e}=this.draw,i=Object.entries(e.data.loads||{}).find(([,a])=>a.node===t&&a.force),s=i?i[1].force:Array(e.dim).fill(0),r=Sn.slice(0,e.dim).map((a,o)=>le(`F${a}`,i?s[o]:"",l=>{let c=s.map((d,u)=>u===o?l??0:d),h=c.every(d=>Number(d)===0);this.set(["loads",i?.[0]||this.free("loads",`F_${t}`)],h?null:{...i?.[1]||{},node:t,force:c})},{hint:"0 N",size:6,name:`force on ${t} along ${a}`}));return g("fieldset",{},g("legend",{},"Load (N, or with a unit: 2 kN)"),g("div",{class:"row"},r))}ofMember(t){let{draw:e}=this,{state:i}=e,{table:s}=We(e,t);if(s!=="bars")return this.ofOther(s,t);let r=this.entry("bars",t),a=r.kind||"rigid";this.span=g("small",{class:"span"},this.spanText(t));let o=g("small",{class:"weight"},so(e,t)),l=a==="elastic"||a==="cable",c=l?le("Natural length",r.natural_length,h=>this.set(["bars",t,"natural_length"],h),{hint:"as drawn",name:`natural length of ${t}`}):le("Length",r.length,h=>this.set(["bars",t,"length"],h),{hint:"as drawn",name:`length of ${t}`});return[this.span,o,g("div",{class:"row"},ye("Kind",[...vE,...zf],a,h=>this.setKind(t,h),`kind of ${t}`),c),l?g("div",{class:"row"},le("Stiffness",r.stiffness,h=>this.set(["bars",t,"stiffness"],h),{hint:"E A/l",name:`stiffness of ${t}`}),le("Pretension",r.pretension,h=>this.set(["bars",t,"pretension"],h),{hint:"0 N",name:`pretension of ${t}`})):null,this.made("bars",t,r),g("div",{class:"row"},this.angle(t),It(ux.angle_spring,()=>this.draw.make("angle_spring")))]}made(t,e,i){let{draw:s}=this,r=a=>o=>this.set([t,e,a],o);return[g("div",{class:"row"},io(s,i.section,r("section"),`section of ${e}`,i.material||s.state.data.material)),g("div",{class:"row"},no(s,i.material,r("material"),`material of ${e}`),le("Mass",i.mass,r("mass"),{hint:"of its section",size:10,name:`mass of ${e}`}))]}ofOther(t,e){this.span=g("small",{class:"span"},this.spanText(e));let i={beams:"beam",links:"link"}[t]||"active";return[this.span,g("small",{class:"weight"},so(this.draw,e)),g("div",{class:"row"},ye("Kind",[["bar","bar"],...zf],i,s=>this.draw.make(s),`kind of ${e}`)),t==="beams"?this.beamEnds(e):this.making(["angle_spring"]),t==="active"?null:this.made(t,e,this.entry(t,e)),this.forms.entry(t,e)]}beamEnds(t){let{data:e}=this.draw.state,i=this.entry("beams",t),s=i.release||[],r=e.clamped||[],a=c=>Array.isArray(r)?r.includes(c):c in r,o=(c,h)=>c.filter(d=>d!==h).length?c.filter(d=>d!==h):null,l=async(c,h)=>{s.includes(c)!==(h==="hinge")&&await this.set(["beams",t,"release"],h==="hinge"?[...s,c]:o(s,c)),a(c)!==(h==="clamped")&&(Array.isArray(r)?await this.set(["clamped"],h==="clamped"?[...r,c]:o(r,c)):await this.set(["clamped",c],null))};return g("div",{class:"row"},i.ends.map(c=>ye(`At ${c}`,[["joined","joined stiffly"],["hinge","hinge"],["clamped","clamped to the ground"]],s.includes(c)?"hinge":a(c)?"clamped":"joined",h=>l(c,h),`end of ${t} at ${c}`)))}making(t){return g("div",{class:"row"},t.map(e=>It(ux[e],()=>this.draw.make(e))))}setKind(t,e){if(zf.some(([r])=>r===e))return this.draw.make(e);let i={...this.entry("bars",t)},{state:s}=this.draw;if(delete i.kind,e==="elastic"||e==="cable")delete i.length,!((i.section||s.data.section)&&(i.material||s.data.material))&&i.stiffness===void 0&&(i.stiffness="1 kN/m");else for(let r of["stiffness","natural_length","pretension","strain"])delete i[r];this.set(["bars",t],e==="rigid"?Object.keys(i).length===1?i.ends:i:{...i,kind:e})}ofMany(t){let e=async(i,s)=>{for(let r of t)r in(this.draw.state.data.bars||{})&&await this.set(["bars",r,i],s)};return g("div",{class:"row"},io(this.draw,null,i=>e("section",i),"section of all picked"),no(this.draw,null,i=>e("material",i),"material of all picked"))}angle(t){let{state:e}=this.draw,i=Object.entries(e.data.drives||{}).find(([,r])=>(r.kind||"angle")==="angle"&&r.bar===t),s=e.dim===2?[["","-"],["on","yes"]]:[["","-"],...Sn.map(r=>[r,`about ${r}`])];return ye("Driven angle",s,i?i[1].axis||"on":"",r=>this.set(["drives",i?.[0]||this.free("drives","motor")],r?{kind:"angle",bar:t,...e.dim===3?{axis:r}:{}}:null),`driven angle of ${t}`)}free(t,e){return He(this.draw.state.data,t,e)}naming(t,e){return le("Name",e,i=>i===null?this.rebuild():this.draw.edit({do:"rename",table:t,old:e,new:String(i)}),{size:5,name:`name of ${e}`})}spanText(t){let{state:e}=this.draw,i=e.members.findIndex(o=>o.name===t);if(i<0)return"";let s=e.members.filter(o=>o.name===t).map(({ends:o})=>o),r=o=>((l,c)=>Math.hypot(...l.map((h,d)=>h-c[d])))(...o.map(l=>this.draw.at(l))),a=e.force?.[i]??null;return`${[s[0][0],...s.map(o=>o[1])].join(" to ")}, ${St(s.map(r).reduce((o,l)=>o+l),"m")}${a===null?"":`, ${St(a,"N")}${e.unsure.includes(t)?" (not unique)":""}`}`}follow(){let{picked:t,state:e}=this.draw;if(t.members.size===1&&this.span&&(this.span.textContent=this.spanText([...t.members][0])),t.nodes.size!==1)return;let[i]=t.nodes;e.places[e.nodes.indexOf(i)].forEach((s,r)=>{let a=this.body.querySelector(`[aria-label="${Sn[r]} of ${CSS.escape(i)}"]`);a&&qa(a,px(s))})}};function px(n){return typeof n=="number"?Number(n.toPrecision(7)):n}function mx(n,t){return n.length?`${n.length} ${t}${n.length===1?"":"s"}: ${n.slice(0,fx).join(", ")}${n.length>fx?" ...":""}`:""}var jh=class{constructor(t){Object.assign(this,{draw:t,rows:null,away:!1}),this.strip=g("section",{class:"starters","aria-label":"drawings to begin with",hidden:!0}),this.all=It("All of them",()=>this.all.setAttribute("aria-pressed",String(this.strip.classList.toggle("all"))),{"aria-pressed":"false"}),this.cards=g("div",{class:"cards"}),this.node=de("Begin from",g("p",{class:"faint"},"A copy in place of this drawing; it can be undone."),this.cards),this.node.open=!1,this.node.addEventListener("toggle",()=>this.node.open&&this.fetch())}get empty(){return!!this.draw.state&&!this.draw.state.nodes.length}rebuild(){this.strip.hidden=!this.empty||this.away||!this.rows||this.draw.task.takes(this.draw.tool),this.empty&&!this.away&&this.fetch()}async fetch(){if(this.rows||this.asked)return;this.asked=!0;let{rows:t}=await this.draw.ask({do:"starters"});this.asked=!1,t&&(this.rows=t,this.cards.replaceChildren(...t.map(e=>this.card(e))),this.strip.replaceChildren(g("header",{},g("b",{},"Begin from one of these, or draw"),this.all,It("×",()=>this.hide(),{"aria-label":"hide the drawings to begin with",title:"Hide (they stay in the panel)"})),g("div",{class:"cards"},t.map(e=>this.card(e)))),this.rebuild())}card({name:t,words:e,picture:i}){return g("button",{type:"button",class:"card",title:e,onclick:()=>this.begin(t)},vh(i),g("b",{},t),g("span",{},e))}hide(){this.away=!0,this.rebuild(),this.draw.canvas.node.focus({preventScroll:!0})}async begin(t){(await this.draw.ask({do:"begin",name:t})).kind==="drawing"&&(this.node.open=!1,this.draw.fit(),this.draw.canvas.node.focus({preventScroll:!0}),this.draw.say(`${t}: a copy to change`))}};var _E=300,gx=[["Picture",[["png","PNG","A picture of the drawing, 300 dots per inch"],["svg","SVG","A picture of the drawing as lines and text, for print"],["pdf","PDF","The same picture on a sheet of its size"]]],["Motion",[["gif","GIF","A film that plays everywhere (needs Chromium)"],["mp4","MP4","A film (needs Chromium and ffmpeg)"],["page","Page","One file that plays in any browser, without a network"]]],["Model",[["yaml","YAML","The model file"],["python","Python","The model as Python code"]]],["Result",[["report","Report","A report for a reviewer, one file"],["paper","Report as PDF","The report printed (needs Chromium)"]]]],Yh=class{constructor(t){Object.assign(this,{draw:t,run:"",doing:null}),this.body=g("div",{}),this.note=g("div",{role:"status"}),this.node=de("Take it with you",this.body,this.note)}rebuild(){let{state:t}=this.draw;if(!t)return;let e=Object.keys(t.data.runs||{});e.includes(this.run)||(this.run="");let i=gx.map(([s,r])=>g("div",{class:"row take"},g("span",{class:"faint"},s),r.map(([a,o,l])=>It(o,()=>this.take(a),{title:l,"aria-label":`take ${o}`,disabled:!!this.doing||!t.nodes.length}))));ve(this.body,e.length>1?g("div",{class:"row"},ye("of run",[["","the first that moves"],...e],this.run,s=>this.run=s,"run to take")):null,i)}async take(t){this.doing=t,this.rebuild();let{play:e}=this.draw,i=e.away?e.index:null,s=await this.draw.ask({do:"take",form:t,run:this.run,sample:i});for(;s.kind==="running"&&s.form;)this.progress(s),await new Promise(r=>setTimeout(r,_E)),s=await this.draw.ask({do:"running"});this.doing=null,this.rebuild(),s.kind==="taken"?this.fetch(s):this.note.replaceChildren(s.kind==="error"?g("p",{class:"banner warning"},s.message):"")}progress({done:t,total:e,note:i}){let s=gx.flatMap(([,a])=>a).find(([a])=>a===this.doing)[1],r=`Making the ${s}${e?`: ${t} of ${e} pictures`:" ..."}${i?`. ${i}`:""}`;this.note.replaceChildren(g("div",{class:"row doing"},g("span",{"aria-live":"off"},r),g("progress",{max:e||1,...t?{value:t}:{}}),It("Stop",()=>this.draw.ask({do:"stop"}),{"aria-label":"stop making the file"})))}fetch({number:t,file:e,bytes:i}){let s=g("a",{href:`result/${t}`,download:e},e);this.note.replaceChildren(g("p",{},s,` (${i<1e6?`${Math.ceil(i/1e3)} kB`:`${(i/1e6).toFixed(1)} MB`})`)),s.click()}};var bE=240,Zh=class{constructor(t){Object.assign(this,{draw:t,typing:-1}),this.area=g("textarea",{"aria-label":"model as text",spellcheck:"false",rows:18,wrap:"off",oninput:()=>this.typed(),onblur:()=>this.typing--}),this.lines=g("pre",{class:"lines","aria-hidden":"true"}),this.faults=g("ul",{class:"faults",role:"status"}),this.back=g("button",{type:"button",hidden:!0,onclick:()=>this.reset()},"Back to the drawing's text"),this.node=de("The file",g("p",{class:"faint"},"The same model as text. An edit of the drawing changes only its own lines; comments stay."),g("div",{class:"text"},this.lines,this.area),this.faults,this.back),this.area.addEventListener("scroll",()=>this.lines.scrollTop=this.area.scrollTop)}typed(){this.dirty=!0,this.since=performance.now(),this.number([]),clearTimeout(this.timer);let{typing:t}=this;this.timer=setTimeout(()=>this.send(t),bE)}async send(t){let e=this.area.value,i=await this.draw.ask({do:"text",text:e,drag:t},this.since);this.area.value!==e||i.kind==="lost"||(i.kind==="faults"?this.show(i.faults,!0):i.kind==="drawing"&&(this.dirty=!1,this.show(i.faults,!1)))}reset(){this.dirty=!1,this.rebuild()}rebuild(){let{state:t}=this.draw;this.dirty&&this.area.ownerDocument.activeElement===this.area||(this.dirty=!1,this.area.value!==t.text&&(this.area.value=t.text),this.show(t.faults,!1))}show(t,e){this.back.hidden=!e,this.number(t.map(({line:i})=>i)),this.faults.replaceChildren(...t.slice(0,20).map(({text:i,line:s})=>g("li",{},g("button",{type:"button",class:"link",onclick:()=>this.goTo(s)},s?`Line ${s}`:"Model"),` ${i}`)),...e?[g("li",{},"The drawing is that of the last text without such faults.")]:[])}number(t){let e=this.area.value.split(`
`).length;this.lines.replaceChildren(...Array.from({length:e},(i,s)=>g("span",{class:t.includes(s+1)?"faulty":""},`${s+1}
`))),this.lines.scrollTop=this.area.scrollTop}goTo(t){if(!t)return;let e=this.area.value.split(`
`),i=e.slice(0,t-1).reduce((s,r)=>s+r.length+1,0);this.area.focus(),this.area.setSelectionRange(i,i+e[t-1].length),this.area.scrollTop=(t-4)*(this.area.scrollHeight/e.length)}};var Kh=class{constructor(t){this.draw=t,this.palette=new Bh(t),this.tools=this.palette.tools;let e=(i,s,r)=>g("button",{type:"button",title:s,"aria-label":s.replace(/ \(.*/,""),onclick:r},i);this.several=e("Several","Pick several: as with Shift held",()=>this.toggleSeveral()),this.several.className="several",this.undo=e("Undo","Undo (Ctrl+Z)",()=>t.ask({do:"undo"})),this.redo=e("Redo","Redo (Ctrl+Y)",()=>t.ask({do:"redo"})),this.delete=e("Delete","Delete what is picked (Delete)",()=>t.remove()),this.fit=e("Fit","Show all (F)",()=>t.fit()),this.names=e("Names","Names and forces (A)",()=>this.toggle("names")),this.force=e("Forces","Colour by force (C)",()=>this.toggle("force")),this.strength=e("Strength","Colour by strength: how much of what is allowed is used (8)",()=>this.toggle("strength")),this.lengths=e("Lengths","Lengths and angles (L)",()=>this.toggle("lengths")),this.snap=e("Snap","Snap to the grid (G)",()=>this.toggleSnap()),this.theme=e("◐","Dark or light (D)",()=>t.toggleTheme()),this.fold=g("button",{type:"button",class:"fold","aria-expanded":"false",title:"What is shown: names, colours, diagram, grid",onclick:()=>this.fold.setAttribute("aria-expanded",String(this.node.classList.toggle("open")))},"View ▾"),this.looks=g("span",{class:"group view",role:"group","aria-label":"view"},["corner","top","front","side"].map(i=>g("button",{type:"button",title:`View: ${i}`,onclick:()=>this.look(i)},i[0].toUpperCase()+i.slice(1)))),this.plane=g("span",{class:"group view plane"}),this.grid=g("span",{class:"group view"}),this.title=g("h1",{}),this.node=g("header",{class:"toolbar rail"},g("div",{class:"title"},this.title,g("a",{href:"../",class:"operate"},"Operate: sliders and forces")),g("div",{class:"tools"},g("span",{class:"group"},this.several,this.undo,this.redo,this.delete,this.fit,this.fold),g("span",{class:"group view"},this.names,this.force,this.strength,this.lengths,this.snap,this.theme,t.diagram.node),this.grid,this.looks,this.plane),this.palette.node)}toggle(t){let{shown:e}=this.draw,i={force:"strength",strength:"force"}[t];e[t]=!e[t],i&&e[t]&&(e[i]=!1),this.draw.canvas.update(),this.rebuild(),this.draw.play.judge()}toggleSnap(){this.draw.snap=!this.draw.snap,this.rebuild()}toggleSeveral(){this.draw.several=!this.draw.several,this.draw.several&&!Ei[this.draw.tool]&&this.draw.setTool("pick"),this.rebuild()}look(t){this.draw.camera.look(t),this.draw.fit()}setPlane(t){Object.assign(this.draw.camera.plane,t),this.draw.canvas.update(),this.rebuild()}rebuild(){let{draw:t}=this,{state:e,camera:i}=t;if(this.palette.rebuild(t.tool,e?.dim),xi(this.several,t.several),xi(this.names,t.shown.names),xi(this.force,t.shown.force),xi(this.strength,t.shown.strength),xi(this.lengths,t.shown.lengths),xi(this.snap,t.snap),!e)return;this.title.textContent=`${e.file||"Untitled drawing"}${e.dirty?" (not saved)":""}`,this.undo.disabled=!e.undo,this.redo.disabled=!e.redo,this.undo.title=e.undo?`Undo ${e.undo} (Ctrl+Z)`:"Nothing to undo",this.redo.title=e.redo?`Redo ${e.redo} (Ctrl+Y)`:"Nothing to redo",this.delete.disabled=!t.picked.nodes.size&&!t.picked.members.size,this.looks.hidden=this.plane.hidden=e.dim!==3,this.grid.replaceChildren(le("Grid",i.step??"",r=>this.setStep(r),{hint:"auto",size:4,name:"grid step in m"}));let s=g("select",{"aria-label":"work plane",onchange:()=>this.setPlane({axis:Number(s.value),at:0})},["y-z","x-z","x-y"].map((r,a)=>g("option",{value:a},r)));s.value=i.plane.axis,this.plane.replaceChildren(g("label",{class:"entry"},g("span",{},"Plane"),s),le(`at ${"xyz"[i.plane.axis]} =`,i.plane.at,r=>this.setHeight(r),{size:4,name:"height of the work plane in m"}),g("button",{type:"button",title:"Look straight at the work plane",onclick:()=>{i.face(),t.fit()}},"Face it"))}setHeight(t){let e=xs(t);Number.isFinite(e)?this.setPlane({at:e}):(this.draw.tell(`The height of the work plane is a length: 0.5, 500 mm. Got ${t??"nothing"}.`,!0),this.rebuild())}setStep(t){let{draw:e}=this,{camera:i}=e,s=t===null?null:xs(t);s===null||s>0?i.step=s:e.tell(`The step of the grid is a length: 0.05, 50 mm, 2 in. Got ${t}.`,!0),s>0&&!e.state.nodes.length&&(s*i.scale<8||s*i.scale>150)&&i.zoom(44/s/i.scale),e.canvas.update(),this.rebuild()}key(t){let{draw:e}=this,{target:i}=t,s=i.tagName==="TEXTAREA"||i.tagName==="SELECT"||i.tagName==="INPUT"&&i.type!=="checkbox";e.closed||t.defaultPrevented||s||this.press(t)}press(t){let{draw:e}=this,{target:i}=t,s=t.key.length===1?t.key.toLowerCase():t.key;if(t.ctrlKey||t.metaKey){let o={z:t.shiftKey?"redo":"undo",y:"redo"}[s];if(o)e.ask({do:o});else if(s==="a")e.pickAll();else if(s==="s")e.files.save();else return;t.preventDefault();return}if(t.altKey)return;let r=[...Ar.values()].find(o=>o.key===s),a={i:[0,.12],k:[0,-.12],j:[-.12,0],o:[.12,0]}[s];if(r)e.setTool(r.name);else if(a)e.camera.turn(...a),e.canvas.update();else if(s==="Delete"||s==="Backspace")e.remove();else if(s==="Escape")e.keyboard.escape();else if(s===" "&&!i.closest("button, a, summary"))e.play.toggle();else if((s==="+"||s==="-")&&e.play.film)e.play.faster(s==="+"?1:-1);else if(s==="f")e.fit();else if(s==="a")this.toggle("names");else if(s==="c")this.toggle("force");else if(s==="8")this.toggle("strength");else if(s==="l")this.toggle("lengths");else if(s==="g")this.toggleSnap();else if(s==="d")e.toggleTheme();else return;t.preventDefault()}};var Jh=class{constructor(t){this.draw=t,this.input=g("input",{type:"text",autocomplete:"off",spellcheck:"false",size:9,onkeydown:e=>this.key(e),onblur:e=>this.left(e),oninput:()=>this.typed=!0}),this.label=g("span",{}),this.node=g("label",{class:"value",hidden:!0},this.label,this.input)}ask({at:t,label:e,value:i,set:s}){Object.assign(this,{at:t,set:s,typed:!1}),this.node.classList.toggle("corner",!t),this.label.textContent=e,this.input.setAttribute("aria-label",e),this.input.value=i,this.input.size=Math.max(9,String(i).length),this.node.hidden=!1,this.place(),!(!t&&this.draw.tools.touch)&&(this.input.focus({preventScroll:!0}),this.input.select())}place(){if(this.node.hidden||!this.at)return;let{camera:t}=this.draw,[e,i]=t.project(this.at),{offsetWidth:s,offsetHeight:r}=this.node,a=(o,l,c)=>Math.max(4,Math.min(o,c-l-4));Object.assign(this.node.style,{left:`${a(e+14,s,t.width)}px`,top:`${a(i+10,r,t.height)}px`})}key(t){let{draw:e}=this,{key:i}=t,s=!this.typed&&(t.ctrlKey||t.metaKey?/^[yzs]$/i:/^([a-z ]|Arrow.*|Page.*|Delete|Escape|ContextMenu|F10)$/i).test(i);i!=="Enter"&&i!=="Escape"&&!s||(t.stopPropagation(),this.close(i==="Enter"),e.canvas.node.focus({preventScroll:!0}),s&&e.keyboard.key(t),s&&!t.defaultPrevented&&e.rail.press(t),t.preventDefault())}left({relatedTarget:t}){this.close(!0),t!==this.draw.canvas.node&&this.draw.tools.leave()}close(t){this.node.hidden||(this.node.hidden=!0,t&&this.typed&&this.input.value.trim()&&this.set(this.input.value.trim()))}};var Er=(n,t)=>ht("path",{class:t,d:n}),wE=(n,t)=>ht("circle",{class:"node",cx:n,cy:t,r:5}),xx=(n,t)=>Er(`M${n} ${t}l-9 15h18zM${n-13} ${t+16}h26`,"foot"),ro=[[28,84],[40,52],[104,28],[124,84]],Qh=(n=[])=>[0,1,2].map(t=>Er(`M${ro[t]}L${ro[t+1]}`,`line ${n[t]||""}`)),td=()=>ro.map(([n,t])=>wE(n,t)),Gf=()=>[xx(...ro[0]),xx(...ro[3])],yx=()=>Er("M10 76a20 20 0 0 1 30 -10m-9 -5l10 5l-6 9","turn"),ME=()=>Er("M104 34v30m-6 -9l6 9l6 -9","pull"),SE=[["Drag from point to point: bars",()=>[...Qh(["","","begun"]),...td(),Er("M124 84l4 16l4 -6l7 -1z","tip")]],["Hold what stands",()=>[...Qh(),...Gf(),...td()]],["Turn a bar",()=>[...Qh(),...Gf(),...td(),yx()]],["Play: motion, forces, reactions",()=>[...Qh(["tension","compression","compression"]),...Gf(),Er("M66 36C84 16 118 18 130 34","way"),...td(),yx(),ME()]]],ed=class{constructor(t){this.draw=t,this.node=g("div",{class:"welcome",hidden:!0,"aria-label":"what one can do here"},g("ol",{},SE.map(([e,i])=>g("li",{},ht("svg",{viewBox:"0 0 150 108","aria-hidden":"true"},...i()),g("span",{},e)))))}rebuild(){let{nodes:t,faults:e}=this.draw.state;this.node.hidden=t.length>0||!!e?.length}};var id=class{constructor(t){this.draw=t,this.body=g("div",{}),this.node=de("Model",this.body)}rebuild(){let{draw:t}=this,{state:e}=t;if(!e)return;let{data:i,dim:s}=e,r=(c,h)=>t.edit({do:"set",path:c,value:h}),a=i.gravity||Array(s).fill(0),o=[..."xyz"].slice(0,s).map((c,h)=>le(`g${c}`,a[h],d=>r(["gravity"],a.map((u,f)=>f===h?d??0:u)),{size:6,name:`gravity along ${c}`})),l=(c,h)=>It(h,()=>t.edit({do:"fresh",dim:c}),{title:"It can be undone."});ve(this.body,g("div",{class:"row"},io(t,i.section,c=>r(["section"],c),"section of the model",i.material)),g("div",{class:"row"},no(t,i.material,c=>r(["material"],c),"material of the model"),g("small",{},so(t))),g("div",{class:"row"},o,g("small",{},"m/s²")),g("div",{class:"row"},le("Title",i.title,c=>r(["title"],c===null?null:String(c)),{size:20,name:"title"})),g("div",{class:"row"},l(2,"New, in the plane"),l(3,"New, in space")))}};var AE=6,vx=new Set(["running"]),EE={picture:Gh,curves:Ch,diagram:Rh,readout:yh,play:Xh,welcome:ed,canvas:Eh,status:Th,properties:qh,whole:id,groups:Lh,text:Zh,entries:Ih,files:Nh,task:wh,starters:jh,takeAway:Yh,menu:zh,value:Jh,rail:Kh,tools:Oh,keyboard:Uh},Vf={curve:"Computing the path ...",over:"Computing the diagram ...",sweep:"Computing the motion ...",let_go:"Computing the motion ...",run:"Starting the run ...",stop:"Stopping the run ...",ask:"Looking for linkages ...",starters:"Drawing the pictures ...",take:"Making the file ...",save:"Saving ...",keep:"Saving ...",versions:"Reading the versions ...",picture:"Saving the picture ...",dimension:"Saving the dimension ..."};function _x(n){let t=document.createElement("style");t.textContent=Y0,document.head.append(t);let e=new Hf(n);window.kinetruss.draw=e,e.connect()}var Hf=class extends _r{constructor(t){super(t),Object.assign(this,{state:null,tool:"bar",snap:!0,closed:!0,cursor:null,rubber:null,pointed:null,gripped:new Set,several:!1,moves:0,stale:!1}),this.picked={nodes:new Set,members:new Set},this.shown={names:!0,force:!0,strength:!1,lengths:!1},this.theme=t.dataset.theme||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"),t.dataset.theme=this.theme,this.camera=new br,this.banner=g("p",{class:"banner",role:"status",hidden:!0}),this.spoken=g("p",{class:"spoken",role:"status","aria-live":"polite"});for(let[i,s]of Object.entries(EE))this[i]=new s(this);let e=g("aside",{class:"controls sketch","aria-label":"drawing"},g("div",{class:"head"},this.banner,this.files.offer,this.status.node),g("div",{class:"parts"},this.status.details,this.properties.node,this.whole.node,this.properties.freshNode,this.entries.runsNode,this.starters.node,this.task.node,this.entries.node,this.groups.node,this.curves.node,this.picture.node,this.text.node,this.takeAway.node,this.files.node));t.replaceChildren(this.rail.node,g("main",{},g("div",{class:"sheet"},g("div",{class:"sheetpane"},this.canvas.node,this.welcome.node,this.starters.strip,this.canvas.legend,this.diagram.told,this.doing,this.readout.node,this.spoken,this.value.node,this.menu.node),this.play.node),e)),t.ownerDocument.addEventListener("keydown",i=>this.rail.key(i))}get there(){return this.state}ask(t,e){return!(t.do in Vf)&&!vx.has(t.do)&&(this.play.going||=this.play.playing&&t.do!=="put",this.play.home()),super.ask(t,e)}async edit(t){let e=await this.ask(t),{made:i}=e;return i?.member?this.pick({type:"member",name:i.member}):i?.node&&this.pick({type:"node",name:i.node}),i?.entry&&!i.member&&this.entries.show(i.entry),i?.lost?.length&&this.tell(`Removed with it: ${i.lost.join(", ")}.`),e}async change(t,e,i){return(await this.edit({do:"change",changes:e,words:t})).kind!=="drawing"?!1:(i&&this.pick(i),!0)}make(t){return this.edit({do:"make",what:t,axis:"xyz"[this.camera.plane.axis],nodes:[...this.picked.nodes],members:[...this.picked.members]})}drag(t,e,i=!1){this.wanted={do:"move",places:t,drag:e,keep:i},this.gripped=new Set(Object.keys(t)),this.pump()}dragged(){return this.gripped=new Set,this.ask({do:"show"})}held(t){let{fixed:e,mobility:i}=this.state;return e[t]?`${t} is held. Free it in the panel, or drag another node.`:`${i&&!i.freedoms?"All lengths are kept, and nothing can move. ":"Nothing moves that way with all lengths kept. "}Pick (V) drags a node and changes the lengths.`}hurried(){let t=this.wanted;return!t||this.curves.stale&&this.moves>=AE?null:(this.moves++,this.wanted=null,{command:t})}leisurely(){return this.diagram.stale&&!this.play.playing?{command:this.diagram.command()}:this.curves.stale?(this.moves=0,{command:this.curves.command()}):null}watch(){if(!this.state)return;let t=[this.waiting,...this.queue].filter(s=>s&&!vx.has(s.command.do)),e=t.find(({command:s})=>!(s.do in Vf)),[i]=e?[e]:t;this.changing=!!e,i?this.busy.wait(Vf[i.command.do]||"Computing ...",i.since):this.busy.end()}showBusy(t){let e=!!(t&&this.changing&&this.state);t&&this.doing.hidden&&this.say(t),super.showBusy(t),this.status.wait(e?t:""),e!==this.stale&&(this.stale=e,this.root.classList.toggle("stale",e),this.canvas.update())}unpacked(t){return new $h(t)}heard(t){return t.kind==="drawing"?this.take(t):t.kind==="moved"?this.place(t):t.kind==="over"?this.diagram.take(t):t.kind==="curve"?this.curves.take(t):t.kind==="error"&&this.waiting?.command!==this.play.rate.trying&&this.refuse(t.message),t.other||t.choices}refuse(t){this.play.going=!1,this.curves.failed(t,this.waiting),this.tell(t,!0);for(let e of[this.properties,this.whole,this.entries])e.rebuild()}take(t){let e=!this.state,i=this.state?.dim,s=!!this.state?.nodes.length&&!t.nodes.length,r=null;t.choices&&(this.choices=t.choices,this.files.setOffer(t.offer),this.picture.take(t.picture),r=t.running),this.state=t,this.camera.setDim(t.dim),this.keepPicked(t.made?.renamed),!t.other&&!e&&this.tell(t.saved||""),this.diagram.spoil(),this.canvas.rebuild(),(e||s||t.dim!==i)&&this.fit(),this.curves.spoil();for(let a of[this.rail,this.welcome,this.status,this.properties,this.whole,this.groups,this.entries,this.curves,this.diagram,this.text,this.files,this.starters,this.task,this.takeAway])a.rebuild();this.play.spoil(),r&&this.entries.take(r),window.kinetruss.ready=!0,this.root.dataset.state="ready"}place(t){Object.assign(this.state,t,{kind:"drawing"}),this.diagram.spoil(),this.play.spoil(),this.canvas.update(),this.curves.spoil(),this.status.rebuild(),this.properties.follow()}keepPicked(t){if(t)for(let i of Object.values(this.picked))i.delete(t[0])&&i.add(t[1]);let e={nodes:new Set(this.state.nodes),members:new Set(this.state.members.map(({name:i})=>i))};for(let[i,s]of Object.entries(this.picked))for(let r of s)e[i].has(r)||s.delete(r)}at(t){let e=this.state.places[this.state.nodes.indexOf(t)];return[e[0],e[1],e[2]||0]}snapped(t,e=new Set){return this.snap?this.camera.snapped(t,this.state.places.filter((i,s)=>!e.has(this.state.nodes[s]))):t}nodeAt(t){let{places:e,nodes:i}=this.state;return i[e.findIndex(s=>t.every((r,a)=>Math.abs(r-(s[a]||0))*this.camera.scale<.5))]}inPlane(t){let{axis:e,at:i}=this.camera.plane;return Math.abs(this.at(t)[e]-i)*this.camera.scale<1}cut(t){return t.slice(0,this.camera.dim)}isPicked({type:t,name:e}){return this.picked[`${t}s`].has(e)}pick(t){this.picked.nodes.clear(),this.picked.members.clear(),t&&this.picked[`${t.type}s`].add(t.name),this.repick()}toggle({type:t,name:e}){let i=this.picked[`${t}s`];i.delete(e)||i.add(e),this.repick()}pickAll(){this.state.nodes.forEach(t=>this.picked.nodes.add(t)),this.state.members.forEach(({name:t})=>this.picked.members.add(t)),this.repick()}pickBox(t,e){let i=([s,r])=>(s-t[0])*(s-e[0])<=0&&(r-t[1])*(r-e[1])<=0;this.state.nodes.forEach((s,r)=>i(this.canvas.seen[r])&&this.picked.nodes.add(s)),this.state.members.forEach(({name:s,ends:r})=>r.every(a=>this.picked.nodes.has(a))&&this.picked.members.add(s)),this.repick()}repick(){this.canvas.update();for(let t of[this.rail,this.properties,this.groups,this.curves])t.rebuild();this.say([...this.picked.nodes,...this.picked.members].join(", ")||"nothing picked")}remove(){let t=[...this.picked.nodes],e=[...this.picked.members];(t.length||e.length)&&this.edit({do:"delete",nodes:t,members:e})}reveal(){let{width:t,height:e}=this.camera;this.canvas.seen.some(([i,s])=>i<0||s<0||i>t||s>e)&&this.fit()}fit(){this.camera.fit(this.state.places),this.canvas.update()}setTool(t){if(this.task.takes(t)&&this.state?.dim===3)return this.tell("Linkages are asked for in the plane. Begin a planar drawing: Draw in the plane, in the panel of an empty drawing.",!0);this.tool=t,Ei[t]||(this.several=!1),this.keyboard.grabbed=null,this.canvas.node.dataset.tool=t,this.tools.cancelAct(),this.canvas.rubber(),this.rail.rebuild(),this.task.rebuild(),this.starters.rebuild()}toggleTheme(){this.theme=this.theme==="dark"?"light":"dark",this.root.dataset.theme=this.theme,this.play.curve()}tell(t,e=!1){this.banner.hidden=!t,this.banner.textContent=t,this.banner.classList.toggle("warning",e)}say(t){this.spoken.textContent=t}open(t){this.post=t,this.closed=!1,this.setEnded(!1),this.state?this.tell("The studio answers again."):this.busy.wait("Opening ...",performance.now())}close(){super.close(),this.state&&this.tell("The studio has ended. The drawing stays as it was last confirmed and cannot be changed. It is kept beside its file: start the studio again in the same folder, and this page goes on with it.",!0)}};var nd="KTSCENE1",TE="kinetruss.scene",bx=1;function _s(n){let t=atob(n.trim()),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e}async function wx(n){let{readable:t,writable:e}=new DecompressionStream("deflate"),i=e.getWriter(),s=i.write(n).then(()=>i.close()),[r]=await Promise.all([new Response(t).arrayBuffer(),s]);return new Uint8Array(r)}async function Xn(n){if(String.fromCharCode(...n.subarray(0,nd.length))!==nd)throw new Error("These bytes are no kinetruss scene.");let e=nd.length+4,i=e+new DataView(n.buffer,n.byteOffset).getUint32(nd.length,!0),[s,r]=await Promise.all([wx(n.subarray(e,i)),wx(n.subarray(i))]),a=4+new DataView(s.buffer).getUint32(0,!0),o=JSON.parse(new TextDecoder().decode(s.subarray(4,a)));if(o.format!==TE||o.version!==bx)throw new Error(`Scene version ${o.version} is not known to this viewer, which reads ${bx}.`);let l={};for(let[c,h]of Object.entries(o.arrays)){let d=h.form==="plain"?CE(s,a,h):RE(r,h);l[c]={shape:h.shape,data:d}}return new Wf(o,l)}var Mx=n=>n.shape.reduce((t,e)=>t*e,1);function CE(n,t,e){let i=t+e.at,{buffer:s}=n.slice(i,i+4*Mx(e));return e.type==="int32"?new Int32Array(s):new Float32Array(s)}function RE(n,t){let e=Mx(t),i=e/t.shape[0];return t.form==="float32"?PE(n,t.at,e,i):IE(n,t,e,i)}function PE(n,t,e,i){let s=new Uint32Array(e),r=t+e,a=r+e,o=a+e;for(let l=0;l<e;l++)s[l]=n[t+l]|n[r+l]<<8|n[a+l]<<16|n[o+l]<<24,l>=i&&(s[l]+=s[l-i]);return new Float32Array(s.buffer)}function IE(n,{at:t,order:e},i,s){let r=Float64Array.from(new Int8Array(n.slice(t,t+s).buffer),d=>2**d),a=new Int32Array(n.slice(t+s,t+5*s).buffer),o=t+5*s,l=o+i,c=new Float32Array(i),h=Array.from({length:e},()=>new Uint16Array(s));for(let d=0,u=0,f=0;d<i;d++){let p=n[o+d]|n[l+d]<<8,y=p>>>1^-(p&1);for(let m=Math.min(e-1,f);m>=0;m--)y=h[m][u]+=y;c[d]=(h[0][u]+a[u])*r[u],++u===s&&(u=0,f++)}return c}var Wf=class{constructor(t,e){Object.assign(this,{header:t,arrays:e,stored:{...e},cases:t.cases.map(i=>i.load_case)}),this.time=e.time.data,this.frames=this.time.length,this.dim=t.dim,this.nodes=t.nodes,this.members=t.members,this.ends=e.ends.data,this.active=new Set(t.two_rods),this.directors=new Set(t.directors||[]),this.partsOf=this.members.map(()=>[]),e.part_member.data.forEach((i,s)=>this.partsOf[i].push(s)),this.curves=new Cc(this),this.skin=e.skin?e.skin.data:new Int32Array(0),this.faces=this.skin.length/3,this.extent=NE(e.position.data,this.dim),this.length0=LE(this),this.ranges={},this.kept={},this.sure()}shows(t){return this.header.kinds[t]!=="frame"}sure(){this.unsure=new Set((this.header.not_unique||[]).map(t=>this.members.indexOf(t)).filter(t=>t>=0))}renew(){Object.assign(this.kept,this.ranges),this.ranges={}}choose(t){let e=this.cases.indexOf(t);if(e<0)return!1;Object.assign(this.header,this.header.cases[e]);for(let i of Object.keys(this.stored)){let s=this.stored[`${e}:${i}`];this.arrays[i]=s||this.stored[i]}return this.ranges={},this.kept={},this.sure(),!0}get unchecked(){return["utilisation","buckling"].some(t=>this.has(t)&&this.arrays[t].data.some((e,i)=>Number.isNaN(e)&&this.shows(i%this.members.length)))}has(t){return t in this.arrays}vector(t,e,i){let{data:s,shape:r}=this.arrays[t],a=this.dim,o=(e*r[1]+i)*a;return[s[o],s[o+1],a===3?s[o+2]:0]}position(t,e){return this.vector("position",t,e)}placeOfLoad(t,e){return t.at?[0,1,2].map(i=>t.at.reduce((s,[r,a])=>s+a*e(r)[i],0)):e(t.node)}jointForce(t,e,i){let{data:s}=this.arrays.joint_force,r=this.dim,a=((t*this.members.length+e)*2+i)*r;return[s[a],s[a+1],r===3?s[a+2]:0]}actionForce(t,e,i){let{data:s,shape:r}=this.arrays.action_force,a=this.dim,o=((t*r[1]+e)*2+i)*a;return[s[o],s[o+1],a===3?s[o+2]:0]}number(t,e,i){let{data:s,shape:r}=this.arrays[t];return r.length===1?s[i]:s[e*r[1]+i]}channel(t){return this.header.channels.find(e=>e.id===t)}value(t,e,i){if(t==="length")return this.length(e,i);let s=this.channel(t);return s?s.array?this.has(s.array)?this.number(s.array,e,i):NaN:this.memberSpeed(e,i):NaN}plainValue(t,e,i){let s=this.value(t,e,i);if(!this.channel(t))return s;let[r,a]=this.range(t);return Math.abs(s)<1e-12*Math.max(Math.abs(r),Math.abs(a))?0:s}coloursFaces(t){return this.has(this.channel(t)?.faces)}faceValue(t,e,i){return this.number(this.channel(t).faces,e,i)}memberSpeed(t,e){let i=this.vector("velocity",t,this.ends[2*e]),s=this.vector("velocity",t,this.ends[2*e+1]);return Math.hypot(i[0]+s[0],i[1]+s[1],i[2]+s[2])/2}length(t,e){let i=this.position(t,this.ends[2*e]),s=this.position(t,this.ends[2*e+1]);return Math.hypot(s[0]-i[0],s[1]-i[1],s[2]-i[2])}range(t){if(!(t in this.ranges)){let[e,i]=this.kept[t]||[1/0,-1/0],s=this.channel(t),r=s&&s.array&&this.arrays[s.array]?.shape.length===1?1:this.frames,a=o=>{o<e&&(e=o),o>i&&Number.isFinite(o)&&(i=o)};for(let o=0;o<r;o++)for(let l=0;l<this.members.length;l++)this.shows(l)&&a(this.value(t,o,l));this.coloursFaces(t)&&this.arrays[s.faces].data.forEach(a),this.ranges[t]=e<=i?[e,i]:[0,0]}return this.ranges[t]}frameAt(t){return hf(this.time,t)}};function NE(n,t){let e=[1/0,1/0,t===3?1/0:0],i=[-1/0,-1/0,t===3?-1/0:0];for(let a=0;a<n.length;a++){let o=a%t;n[a]<e[o]&&(e[o]=n[a]),n[a]>i[o]&&(i[o]=n[a])}let s=e.map((a,o)=>(a+i[o])/2),r=Math.hypot(...i.map((a,o)=>a-e[o]))||1;return{low:e,high:i,centre:s,size:r}}function LE(n){let e=n.members.map((i,s)=>s).filter(i=>n.shows(i)).map(i=>n.length(0,i)).sort((i,s)=>i-s);return e[e.length>>1]||n.extent.size/4}var DE=24,kE=.94,OE=.08,Sx=2,UE=8192,FE=.001,Ax=.7;function Tx(n){window.kinetruss.film=async t=>{let e=await Xn(_s(document.querySelector("script.kinetruss-scene").textContent));return window.kinetruss.shown=new $f(n,e,t),window.kinetruss.shown.said}}var $f=class{constructor(t,e,i){let[s,r]=[0,1].map(()=>document.createElement("canvas")),{width:a,height:o}=i;s.style.cssText=`display: block; width: ${a}px; height: ${o}px;`,t.replaceChildren(s);let l=Sx*Math.max(a,o)>UE?1:Sx;Object.assign(this,{scene:e,look:i,fine:l,view:new vr(s,e,"light",l===1)}),Object.assign(r,{width:a,height:o}),this.pen=r.getContext("2d",{willReadFrequently:!0}),this.dress(),this.aim(),this.said=this.colour()}dress(){let{view:t,scene:e,look:i}=this;t.renderer.setClearColor(new kt("#ffffff")),t.triad.render=()=>{},t.lamp.intensity=Math.PI*Ax,t.lampPlace=[0,0,1],t.ambient.intensity=Math.PI*(1-Ax),t.loads.group.visible=i.loads,t.faces.mesh.visible=i.faces,t.grid.visible=!1;let s=FE*e.extent.size;i.grid&&this.lines(Ex(t),s,qe.light.line),i.ghost&&this.lines(BE(e),s,"#a8b0b9");for(let a of i.paths)this.lines(Ni(Array.from({length:e.frames},(o,l)=>e.position(l,a))),2*s,qe.light.ink);if(i.mode===null)return;let{array:r}=e.header.modes[i.mode];this.reach=OE*e.extent.size/(e.arrays[r].data.reduce((a,o)=>Math.max(a,Math.abs(o)),0)||1),t.mode={array:r,size:0}}lines(t,e,i){let s=ms(t.length,6);s.material=new Yi({color:i}),t.forEach(([r,a],o)=>Li(s,o,r,a,e)),this.view.world.add(s)}aim(){let{view:t,look:e}=this,{camera:i,controls:s}=t;i.fov=DE,t.resize(),t.renderer.setPixelRatio(this.fine);let r=xf(t),a=2*t.bars.ball;if(t.mode)for(let h of[-this.reach,this.reach])r.push(...this.swung(h));e.grid&&r.push(...Ex(t).flat()),this.places=[-a,a].flatMap(h=>r.map(d=>d.map(u=>u+h)));let o=new I(...e.direction).normalize();i.up.set(0,...Math.abs(o.z)>.999?[1,0]:[0,1]);let{centre:l,far:c}=yf(t,o,this.places,kE,0);i.position.copy(l).addScaledVector(o,c),i.lookAt(l),s.target.copy(l)}swung(t){return this.view.mode.size=t,this.view.points()}colour(){let{view:t,scene:e,look:i}=this,s=i.colour&&e.channel(i.colour);if(!s)return{step:t.step,unsure:!1,limits:[0,1],largest:0,over:!1,missing:!1};let r=e.range(s.id),a=Rr(s.scale,[r]);return t.setColours(s,a),{step:t.step,unsure:e.unsure.size>0,limits:a,largest:Math.max(...r.map(Math.abs)),over:Hi(s)&&r[1]>1,missing:this.missing(s)}}missing(t){let{scene:e}=this,i=e.members.map((s,r)=>r).filter(s=>e.shows(s));for(let s=0;s<e.frames;s++)if(i.some(r=>Number.isNaN(e.value(t.id,s,r))))return!0;return!1}shoot(t,e){let{view:i}=this;return i.mode&&(i.mode.size=e*this.reach),i.setFrame(t),i.render(),this.pen.drawImage(i.canvas,0,0,this.look.width,this.look.height),this.pen.canvas.toDataURL("image/png")}};function BE(n){let t=n.nodes.map((s,r)=>n.position(0,r)),e=Fa(n.skin);return[...n.members.flatMap((s,r)=>n.shows(r)?Ni(n.curves.points(t,r)):[]),...Array.from({length:e.length/2},(s,r)=>[t[e[2*r]],t[e[2*r+1]]])]}function Ex({scene:n,step:t,grid:e,supports:i}){let{low:s,high:r}=n.extent,a=[0,1].map(c=>Math.floor(s[c]/t-.2)),o=[0,1].map(c=>Math.ceil(r[c]/t+.2)),l=n.dim===2?e.position.z:Math.min(e.position.z,...i.feet(0).map(c=>c[2]));return[0,1].flatMap(c=>Array.from({length:o[c]-a[c]+1},(h,d)=>[a,o].map(u=>{let f=[u[0]*t,u[1]*t,l];return f[c]=(a[c]+d)*t,f})))}var zE=["rigid","driven","elastic","cut"],sd=class{constructor(t){this.live=t,this.acting=g("div",{}),this.kind=g("div",{}),this.node=g("div",{},g("details",{open:!0},g("summary",{},"Member"),this.kind),g("details",{},g("summary",{},"Gravity, payload, loads"),this.acting))}rebuild(t){this.setup=t,he(this.acting,this.cases(t),this.gravity(t),this.masses(t),t.loads.map(e=>this.load(e,t)),this.load({name:this.free(t),node:this.chosen||t.nodes[t.nodes.length-1],force:Array(t.dim).fill(0)},t,"Add")),this.members(t)}async sent(t,e){if(t.every(i=>Number.isFinite(i.valueAsNumber))){(await e())?.kind==="error"&&this.rebuild(this.setup);return}this.live.controls.tell("A field is empty or holds no number. It was set back.",!0),this.rebuild(this.setup)}free(t){let e=1;for(;t.loads.some(i=>i.name===`load_${e}`);)e++;return`load_${e}`}cases(t){if(!t.cases.length)return null;let e=g("select",{"aria-label":"load case",onchange:()=>this.live.ask({do:"case",name:e.value||null})},g("option",{value:""},"all loads"),t.cases.map(i=>g("option",{value:i,selected:i===t.case},i)));return g("label",{class:"row"},"Load case",e)}vector(t,e){return t.map((i,s)=>g("input",{type:"number",step:"any",value:i,"aria-label":`${e} ${"xyz"[s]}`,class:"component"}))}gravity(t){let e=this.vector(t.gravity,"gravity"),i=()=>this.sent(e,()=>this.live.ask({do:"gravity",value:e.map(o=>o.valueAsNumber)})),s=Math.hypot(...t.gravity)||9.80665,r=(o,l)=>{e.forEach((c,h)=>c.value=h===o?l*s:0),i()},a=e.flatMap((o,l)=>[1,-1].map(c=>g("button",{type:"button",title:`gravity along ${c<0?"-":"+"}${"xyz"[l]}`,onclick:()=>r(l,c)},`${c<0?"-":"+"}${"xyz"[l]}`)));return e.forEach(o=>o.addEventListener("change",i)),g("fieldset",{},g("legend",{},"Gravity (m/s²)"),g("div",{class:"row"},e),g("div",{class:"row"},a))}masses(t){let e=Object.keys(t.masses).reduce((a,o)=>t.masses[o]>t.masses[a]?o:a),i=t.masses[e]?e:t.nodes[t.nodes.length-1];this.chosen=this.chosen&&this.chosen in t.masses?this.chosen:i;let s=g("input",{type:"number",min:0,step:"any",value:t.masses[this.chosen],"aria-label":"payload in kg",class:"component",onchange:()=>this.sent([s],()=>this.live.ask({do:"mass",node:r.value,mass:s.valueAsNumber}))}),r=Cx(t,this.chosen,"node of the payload",a=>{this.chosen=a,s.value=t.masses[a]});return g("fieldset",{},g("legend",{},"Payload (kg)"),g("div",{class:"row"},r,s))}load(t,e,i="Set"){if(!t.force)return g("p",{class:"faint"},`Load ${t.name} changes in time; at its start here.`);let s=this.vector(t.force,`load ${t.name}`),r=Cx(e,t.node,`node of load ${t.name}`),a=c=>this.live.ask({do:"load",name:t.name,node:r.value,force:c}),o=g("button",{type:"button",onclick:()=>this.sent(s,()=>a(s.map(c=>c.valueAsNumber)))},i),l=i==="Set"?g("button",{type:"button",title:"Take this load away",onclick:()=>a(s.map(()=>0))},"×"):null;return g("fieldset",{},g("legend",{},i==="Set"?`Load ${t.name} (N)`:"Another load (N)"),g("div",{class:"row"},r,...s,o,l))}members(t){this.member=g("select",{"aria-label":"member",onchange:()=>this.mark()},t.members.map(({name:i,role:s,own:r})=>g("option",{value:i},s===r?i:`${i} (${s})`))),this.shown&&t.members.some(i=>i.name===this.shown)&&(this.member.value=this.shown),this.buttons=new Map([...zE,"own"].map(i=>[i,g("button",{type:"button",onclick:()=>this.live.ask({do:"switch",member:this.member.value,to:i})},i==="own"?"as in the file":i)]));let e=t.lost.length?g("p",{class:"faint"},`Rests on changed members, not in the model now: ${t.lost.join(", ")}.`):null;he(this.kind,t.members.length?[g("div",{class:"row"},this.member,g("span",{class:"group"},[...this.buttons.values()])),e]:[]),t.members.length&&this.mark()}mark(){this.shown=this.member.value;let{role:t}=this.setup.members.find(e=>e.name===this.shown);for(let[e,i]of this.buttons)i.setAttribute("aria-pressed",String(e===t))}picked(t){t?.type==="member"&&(this.member.value=t.name,this.mark())}};function Cx(n,t,e,i=()=>{}){let s=g("select",{"aria-label":e,onchange:()=>i(s.value)},n.nodes.map(r=>g("option",{value:r,selected:r===t},r)));return s}var GE=2e3,VE=Math.PI/180,rd=class{constructor(t){this.live=t,this.list=g("div",{class:"drives"}),this.node=de("Drives",this.list)}rebuild(t){this.rows=new Map(t.drives.map(e=>[e.name,this.row(e)])),he(this.list,t.drives.length?[...this.rows.values()].map(e=>e.node):g("p",{class:"faint"},"This model has no drive."))}row(t){let e=t.unit==="rad"?1/VE:1e3,i=t.unit==="rad"?"deg":"mm",{low:s,high:r,name:a}=t,o=g("input",{type:"range",min:s,max:r,step:(r-s)/GE,"aria-label":`drive ${a}`,oninput:()=>this.live.move({[a]:Number(o.value)})}),l=g("input",{type:"number",step:"any","aria-label":`value of ${a} in ${i}`,oninput:()=>d.typing=!0,onchange:()=>{d.typing=!1,Number.isFinite(l.valueAsNumber)?this.live.move({[a]:l.valueAsNumber/e}):this.update(this.live.controls.last)}}),c=g("small",{},`${Kt(s*e,4)} to ${Kt(r*e,4)} ${i}${t.limited?"":", no limits in the model"}`),d={node:g("div",{class:"drive","data-drive":a},g("b",{},a),g("span",{class:"value"},l,` ${i}`),o,c),slider:o,field:l,factor:e,typing:!1};return d}update({values:t,stopped:e}){for(let[i,{node:s,slider:r,field:a,factor:o,typing:l}]of this.rows){let c=t[i];if(c===void 0)continue;(!(this.live.wanted&&i in this.live.wanted)||e)&&(r.value=c),l||(a.value=Number((c*o).toFixed(4))),s.classList.toggle("stopped",!!e&&i in(this.live.sent||{}))}}};var ad=class{constructor(t){Object.assign(this,{live:t,frames:[]}),this.at=g("input",{type:"number",min:0,step:"any",value:0,"aria-label":"time of the key frame in s",class:"component"}),this.samples=g("input",{type:"number",min:2,max:2001,step:1,value:201,"aria-label":"samples",class:"component"}),this.line=g("div",{class:"timeline"}),this.list=g("div",{}),this.worst=g("table",{class:"numbers"}),this.play=g("button",{type:"button",onclick:()=>this.run()},"Run"),this.back=g("button",{type:"button",hidden:!0,onclick:()=>this.live.ask({do:"show"})},"Back to the sliders"),this.setter=g("div",{class:"row"},"at",this.at,"s",g("button",{type:"button",onclick:()=>this.set()},"Set key frame here")),this.node=de("Motion through key frames",this.setter,this.line,this.list,g("div",{class:"row"},this.play,this.samples,"samples",this.back),this.worst),this.show()}set(){let t=Math.max(0,this.at.valueAsNumber||0);this.frames=this.frames.filter(e=>Math.abs(e.time-t)>1e-6),this.frames.push({time:t,values:{...this.live.controls.last.values}}),this.frames.sort((e,i)=>e.time-i.time),this.next(),this.keep()}remove(t){this.frames=this.frames.filter(e=>e!==t),this.keep()}next(){this.at.value=this.frames.length?Number((this.frames[this.frames.length-1].time+1).toFixed(6)):0}take(t){this.frames=t,this.next(),this.show()}keep(){this.show(),this.live.page&&this.live.ask({do:"frames",frames:this.frames})}told(){let t=new Set((this.live.setup?.drives||[]).map(e=>e.name));return this.frames.map(({time:e,values:i})=>({time:e,values:Object.fromEntries(Object.entries(i).filter(([s])=>t.has(s)))}))}show(){let t=this.frames.length?this.frames[this.frames.length-1].time:0;this.play.disabled=this.frames.length<2;let e=this.frames.map(({time:i})=>ht("circle",{cx:8+284*i/(t||1),cy:12,r:6}));he(this.line,this.frames.length?ht("svg",{viewBox:"0 0 300 24",role:"img","aria-label":`${this.frames.length} key frames over ${t} s`},ht("line",{x1:8,y1:12,x2:292,y2:12}),e):null),he(this.list,this.frames.map(i=>g("div",{class:"row"},g("button",{type:"button",title:"Go there",onclick:()=>this.live.move(i.values)},md(i.time)),g("button",{type:"button",title:"Remove this key frame","aria-label":`remove the key frame at ${i.time} s`,onclick:()=>this.remove(i)},"×"))))}async run(){this.play.disabled=!0,this.live.controls.tell("Running ..."),await this.live.ask({do:"run",frames:this.told(),samples:Math.round(this.samples.valueAsNumber||201)}),this.play.disabled=this.frames.length<2}running(t){for(let e of[this.setter,this.line,this.list])e.hidden=!!t;this.back.hidden=!t,t&&this.live.controls.tell(""),he(this.worst,t?[g("tr",{},["worst","member","value","of limit","at"].map(e=>g("th",{},e))),...t.worst.map(e=>this.row(e))]:[])}row(t){let e=()=>{let{app:s}=this.live;s.pause(),s.views[0].scene.cases.includes(t.case)&&s.setCase(t.case),t.time!==null&&s.goTo(s.lead.frameAt(t.time)),t.member&&s.pick({type:"member",name:t.member})},i=t.value===null?"-":St(t.value,t.unit);return g("tr",{},g("th",{},g("button",{type:"button",class:"link",onclick:e},t.what)),g("td",{},t.member),g("td",{},i),g("td",{},HE(t.used)),g("td",{},t.time===null?"":md(t.time)))}};function HE(n){return n===null?"":St(n==="Infinity"?1/0:n,"%")}var Rx=.05,od=class{constructor(t){this.live=t,this.banner=g("p",{class:"banner",role:"status",hidden:!0}),this.offer=g("div",{}),this.alarm=g("p",{class:"alarm",role:"alert",hidden:!0}),this.drives=new rd(t),this.changes=new sd(t),this.frames=new ad(t),this.gauge=g("meter",{min:0,max:1,low:Rx,optimum:1,value:0,"aria-label":"distance from a singular pose"}),this.gaugeText=g("output",{}),this.mobility=g("pre",{}),this.note=g("p",{class:"faint"}),this.motors=g("table",{class:"numbers"}),this.reactions=g("table",{class:"numbers"}),this.file=g("input",{type:"text","aria-label":"file name",size:18}),this.pose=g("input",{type:"checkbox"}),this.live_=g("div",{},this.drives.node,this.state(),this.changes.node),this.node=g("aside",{class:"controls","aria-label":"controls"},this.banner,this.offer,this.alarm,this.live_,this.frames.node,this.saving())}state(){return this.motorSection=de("Motors, holding still",this.motors),this.reactionSection=de("Reactions",this.reactions),this.mobilitySection=de("Mobility",this.mobility),g("div",{},g("div",{class:"gauge"},g("span",{},"Singularity gauge"),this.gauge,this.gaugeText),this.note,this.reactionSection,this.motorSection,this.mobilitySection)}saving(){let t=()=>this.save({do:"save",name:this.file.value.trim(),pose:this.pose.checked,frames:this.frames.told()});return this.saveSection=de("Save",g("div",{class:"row"},this.file,g("button",{type:"button",onclick:t},"Save")),g("label",{},this.pose," in this pose"),g("div",{class:"row"},this.undo=this.button("Undo","undo"),this.redo=this.button("Redo","redo"),this.button("Back to the file's model","reset"),this.live.root.dataset.live==="socket"?g("a",{href:"draw/"},"Draw: change the structure"):null)),this.saveSection}button(t,e){return g("button",{type:"button",onclick:()=>this.live.ask({do:e})},t)}async save(t){let e=await this.live.ask(t);e.kind==="exists"&&(this.tell(e.message,!0),this.banner.append(" ",g("button",{type:"button",onclick:()=>this.save({...t,replace:!0})},"Overwrite")))}rebuild(t){this.setup=t,this.drives.rebuild(t),this.changes.rebuild(t),this.file.value||(this.file.value=t.file||"model.yaml"),this.saveSection.hidden=!t.writable,this.history(t),this.setOffer(t.offer),this.tell("")}history({undo:t,redo:e}){for(let[i,s]of[[this.undo,t],[this.redo,e]])i.disabled=!s,i.title=s&&`${i.textContent} ${s}`}setOffer(t){let e=(i,s)=>g("button",{type:"button",onclick:()=>this.live.draft(s)},i);he(this.offer,t?g("p",{class:"banner"},`Changes of ${new Date(1e3*t).toLocaleString()} were not saved when their studio ended. They would take the place of what this page shows. `,e("Go on with them",!0)," ",e("Remove them",!1)):null)}update(t){this.last=t,this.drives.update(t);let e=t.gauge!==null;this.gauge.value=e?t.gauge:0,this.gaugeText.textContent=e?`${Kt(t.gauge,3)}${t.gauge<Rx?": near a singular pose":""}`:"not known",t.mobility&&(this.mobility.textContent=t.mobility),this.mobilitySection.hidden=!this.mobility.textContent,this.note.textContent=t.note,this.tell(t.stopped,!0),this.alarm.hidden=!t.alarms?.length,this.alarm.textContent!==(t.alarms||[]).join(" ")&&(this.alarm.textContent=(t.alarms||[]).join(" ")),this.showMotors(t.demand),this.showReactions()}showMotors(t){if(this.motorSection.hidden=!t?.length,!t?.length||!this.motorSection.open)return;let e=[["thrust","N"],["holding_torque","N m"],["breakaway_torque","N m"],["current","A"]].filter(([a])=>a in t[0]),i={thrust:"thrust",holding_torque:"hold",breakaway_torque:"start",current:"current"},s=a=>a.max_current&&a.current!==null?g("small",{class:"unit"},St(Math.abs(a.current)/a.max_current,"%")):null,r=e.map(([a,o])=>an(t.map(l=>l[a]??NaN),o));he(this.motors,g("tr",{},g("th",{},"drive"),e.map(([a],o)=>g("th",{},i[a],g("small",{class:"unit"},` (${r[o][1]})`)))),t.map((a,o)=>g("tr",{},g("th",{},a.name),e.map(([l],c)=>g("td",{},r[c][0][o],l==="current"?s(a):null)))))}showReactions(){let{scene:t,running:e}=this.live;if(e||!t.has("reaction")||!this.reactionSection.open)return;let i=[..."xyz"].slice(0,t.dim),s=t.header.supported.slice(0,200),r=s.flatMap((l,c)=>t.vector("reaction",0,c).slice(0,t.dim)),[a,o]=an(r,"N");he(this.reactions,g("tr",{},g("th",{},"node"),i.map(l=>g("th",{},`${l} (${o})`))),s.map((l,c)=>g("tr",{},g("th",{},l),i.map((h,d)=>g("td",{},a[c*i.length+d])))))}picked(){this.changes.picked(this.live.app.picked)}running(t){this.live_.hidden=!!t,t&&(this.alarm.hidden=!0),this.frames.running(t),t?.note&&this.tell(t.note,!0)}tell(t,e=!1){this.banner.hidden=!t,this.banner.textContent=t,this.banner.classList.toggle("warning",e)}};var WE=150,$E=2500,XE=40;function Px(n){let t=new Xf(n);if(window.kinetruss.live=t,n.dataset.live==="frame")qE(t);else{t.store=`kinetruss ${location.pathname}`;let[e]=performance.getEntriesByType("navigation");e?.type==="reload"&&(t.page=sessionStorage.getItem(t.store)||""),t.connect()}}function qE(n){window.addEventListener("message",({source:t,data:e})=>{t===window.parent&&t!==window&&e?.kinetruss&&n.hear(e.kinetruss)}),window.parent.postMessage({kinetruss:'{"do":"show"}'},"*"),setTimeout(()=>n.still(),window.parent===window?0:$E),n.open(t=>window.parent.postMessage({kinetruss:t},"*"))}var Xf=class extends _r{constructor(t){super(t),Object.assign(this,{app:null,running:!1,answers:0,adopt:!0,page:""}),this.controls=new od(this),t.ownerDocument.addEventListener("keydown",e=>this.key(e))}get there(){return this.app}move(t){this.wanted={...this.wanted,...t},this.pump()}hurried(){return this.wanted?(this.sent=this.wanted,this.wanted=null,{command:{do:"move",values:this.sent}}):null}key(t){let e={z:t.shiftKey?"redo":"undo",y:"redo"}[t.key.toLowerCase()];!e||!(t.ctrlKey||t.metaKey)||this.closed||!this.setup?.[e]||t.target.matches("input:not([type=range], [type=checkbox]), textarea")||(t.preventDefault(),this.ask({do:e}))}showBusy(t){super.showBusy(t),!this.app&&this.root.dataset.state!=="failed"&&this.root.replaceChildren(t?g("p",{class:"failure busy"},t):"")}heard({kind:t,message:e}){(t==="error"||t==="saved")&&this.controls.tell(e,t==="error"),this.answers++,t==="state"&&!this.wanted&&!this.queue.length&&this.rest()}async unpacked(t){let[e,i]=gh(t);return e.kind==="state"?this.place(e,i):await this.stage(e,i),e}async still(){let[t]=document.querySelectorAll("script.kinetruss-scene");this.app||this.answers||!t||(this.busy.end(),this.app=new Hn(this.root,[await Xn(_s(t.textContent))]),window.kinetruss.app=this.app,window.kinetruss.ready=!0,this.root.dataset.state="ready",this.app.stage.append(g("p",{class:"note"},"A still: run the notebook to move it.")))}rest(){if(clearTimeout(this.timer),this.setup.members.length<=XE||this.fine){this.fine=!1;return}this.timer=setTimeout(()=>{this.fine=!0,this.ask({do:"move",values:{},fine:!0})},WE)}async stage(t,e){let i=await Xn(e),s=t.kind==="run";s||Object.assign(i.header,{kind:"live",verdict:t.state.verdict});let r=this.app;r?.end();let a=new Hn(this.root,[i],[],this.controls.node);a.stage.append(this.doing),r&&(a.shown=r.shown,a.apply(),a.views[0].sized=!0,a.views[0].copyCamera(r.views[0]),a.views[0].controls.update(),i.channel(r.channel?.id)&&a.setChannel(r.channel.id),r.picked&&i[`${r.picked.type}s`].includes(r.picked.name)&&a.pick(r.picked)),Object.assign(this,{app:a,scene:i,running:s}),window.kinetruss.app=a,a.onPick=()=>this.controls.picked(),s||(this.setup=t.setup,this.controls.rebuild(t.setup),this.controls.update(t.state),this.adopt&&this.begin(t.setup)),this.controls.running(s?t:null),window.kinetruss.ready=!0,this.root.dataset.state="ready"}place(t,e){let i=e.byteOffset;for(let[s,r]of t.arrays){let a=this.scene.arrays[s];a&&a.data.length===r&&a.data.set(new Float32Array(e.buffer,i,r)),i+=4*r}this.running||(this.scene.header.verdict=t.state.verdict,this.app.refresh()),this.controls.update(t.state)}open(t){this.post=t,this.adopt=!0,this.app||this.busy.wait("Computing ...",performance.now())}draft(t){return this.adopt=t,this.ask({do:"draft",keep:t})}begin({page:t,frames:e}){let i=this.closed,s=t===this.page&&t!=="";if(Object.assign(this,{adopt:!1,closed:!1,page:t}),this.store&&sessionStorage.setItem(this.store,t),(e.length||i&&s)&&this.controls.frames.take(e),!i){s&&this.controls.tell("The page was loaded again and goes on with its changes.");return}this.setEnded(!1),this.controls.history(this.setup),this.controls.frames.show(),s||this.controls.frames.keep(),this.controls.tell(s?"The studio answers again.":"The studio answers again, but it has kept no changes of this page: the model is that of the file.",!s)}fail(t){super.fail(t,this.store?g("p",{},g("a",{href:"draw/"},"Go to the drawing")):"")}close(){clearTimeout(this.timer),super.close(),this.app&&this.controls.tell("The studio has ended. The picture stays and cannot be changed. The changes are kept beside the file: start the studio of the same file again, and this page goes on with them.",!0)}setEnded(t){super.setEnded(t,this.controls.node)}};var Ix=`/* The colours --back, --ink and so on are those of src/kinetruss/display/palettes.py; theme.js writes them. */
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
`;function Nx(){let n=(t,e,i)=>`${t} { ${[...Object.entries(e),...i].map(([s,r])=>`--${s}: ${r};`).join(" ")} }`;return[n("#kinetruss",qe.light,[["over",Tn],["missing",ws],["dark",0]]),n('#kinetruss[data-theme="dark"]',qe.dark,[["dark",1]]),'#kinetruss { color-scheme: light; } #kinetruss[data-theme="dark"] { color-scheme: dark; }'].join(`
`)}async function YE(){let n=document.getElementById("kinetruss");if(!n)return;let t=document.createElement("style");if(t.textContent=`${Nx()}
${Ix}`,document.head.append(t),n.dataset.live==="draw")return _x(n);if(n.dataset.live==="film")return Tx(n);if(n.dataset.live)return Px(n);let e=[...document.querySelectorAll("script.kinetruss-scene")];try{let i=[];for(let r of e)i.push(await Xn(_s(r.textContent)));let s=new Hn(n,i,e.map(r=>r.dataset.label||""));window.kinetruss.app=s,requestAnimationFrame(()=>requestAnimationFrame(()=>{window.kinetruss.ready=!0,n.dataset.state="ready"}))}catch(i){window.kinetruss.failed=String(i?.message||i),n.dataset.state="failed",n.textContent=`This page cannot be shown: ${window.kinetruss.failed} A browser of 2023 or newer with WebGL is needed.`}}window.kinetruss={...window.kinetruss,ready:!1,App:Hn,fromBase64:_s,readScene:Xn};YE();})();
