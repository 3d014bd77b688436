#pragma once
/// Style and script of report pages.
#include <string_view>

namespace analysis {

inline constexpr std::string_view page_style = R"css(
:root{color-scheme:light;--ink:#1c2330;--soft:#5b6472;--line:#d9dee6;--paper:#fff;--tint:#f5f7fa;--link:#1d5fa8}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,"DejaVu Sans",sans-serif}
header,main,footer{max-width:1120px;margin:0 auto;padding:0 20px}
header{padding-top:28px}h1{font-size:1.7rem;line-height:1.2;margin:0 0 6px}header p{color:var(--soft);margin:0 0 12px}
nav{display:flex;flex-wrap:wrap;gap:4px 14px;font-size:.9rem;padding:10px 0;border-block:1px solid var(--line)}
a{color:var(--link);text-decoration:none}a:hover{text-decoration:underline}
h2{font-size:1.25rem;margin:36px 0 8px}section{scroll-margin-top:12px}p{max-width:76ch}
figure{margin:18px 0}img{max-width:100%;height:auto;display:block}figcaption{color:var(--soft);font-size:.9rem;margin-top:4px}
.table{overflow-x:auto;margin:16px 0;border:1px solid var(--line);border-radius:6px}
table{border-collapse:collapse;width:100%;font-size:.86rem;font-variant-numeric:tabular-nums}
caption{text-align:left;padding:8px 10px;color:var(--soft)}
th,td{text-align:left;vertical-align:top;padding:6px 10px;border-top:1px solid var(--line)}
th{background:var(--tint);font-weight:600;white-space:nowrap}
.animation canvas{width:min(100%,380px);height:auto;image-rendering:pixelated;border:1px solid var(--line);background:#fff;display:block}
.controls{display:flex;align-items:center;gap:10px;max-width:380px;margin-top:6px}
.controls input{flex:1;min-width:60px}.controls output{font-variant-numeric:tabular-nums;min-width:6.5em}
button{font:inherit;font-size:.9rem;padding:3px 12px;border:1px solid var(--line);border-radius:5px;background:var(--tint);cursor:pointer}
.scale{display:flex;align-items:center;gap:8px;max-width:380px;font-size:.82rem;color:var(--soft)}
.scale i{flex:1;height:10px;background:linear-gradient(90deg,#440154,#472d7b,#3b528b,#2c728e,#21918c,#28ae80,#5ec962,#addc30,#fde725)}
footer{color:var(--soft);font-size:.82rem;padding-block:24px}
@media(max-width:600px){header,main,footer{padding-inline:14px}h1{font-size:1.35rem}th,td{padding:5px 7px}
#claims table,#claims tbody,#claims tr,#claims td{display:block}#claims thead{display:none}
#claims tr{border-top:1px solid var(--line);padding:6px 0}#claims td{border:0;padding:2px 10px}
figure:not(.animation){overflow-x:auto}figure:not(.animation) img{max-width:none;min-width:640px}
#claims td:nth-child(2){font-weight:600}#claims td:nth-child(n+4){color:var(--soft)}}
)css";

inline constexpr std::string_view page_script = R"js(
'use strict';
const stops=[[68,1,84],[71,45,123],[59,82,139],[44,114,142],[33,145,140],[40,174,128],[94,201,98],[173,220,48],[253,231,37]];
const palette=Array.from({length:256},(_,v)=>{const t=(v-1)/254*8,k=Math.max(0,Math.min(7,Math.floor(t))),f=t-k;
  return stops[k].map((c,i)=>Math.round(c+(stops[k+1][i]-c)*f));});
for(const figure of document.querySelectorAll('.animation')){
  const canvas=figure.querySelector('canvas'),context=canvas.getContext('2d');
  const button=figure.querySelector('button'),slider=figure.querySelector('input'),output=figure.querySelector('output');
  const captions=canvas.dataset.captions.split('|');
  const frames=canvas.dataset.frames.split(' ').map(text=>Uint8Array.from(atob(text),c=>c.charCodeAt(0)));
  canvas.removeAttribute('data-frames');
  let timer=0;
  const show=index=>{
    const pixels=context.createImageData(canvas.width,canvas.height);
    frames[index].forEach((v,i)=>{const c=v?palette[v]:[255,255,255];pixels.data.set([c[0],c[1],c[2],255],4*i);});
    context.putImageData(pixels,0,0);
    canvas.dataset.frame=index;slider.value=index;output.textContent=captions[index];
  };
  const next=()=>show((Number(canvas.dataset.frame)+1)%frames.length);
  const play=()=>{timer=setInterval(next,700);button.textContent='Pause';};
  const stop=()=>{clearInterval(timer);timer=0;button.textContent='Play';};
  button.addEventListener('click',()=>timer?stop():play());
  slider.addEventListener('input',()=>{stop();show(Number(slider.value));});
  show(0);play();
}
)js";

}  // namespace analysis
