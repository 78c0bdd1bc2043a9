/*
Made from web/studio by its build.mjs, with:

preact 10.29.8

The MIT License (MIT)

Copyright (c) 2015-present Jason Miller

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.

three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var Wr,nt,Qu,qn,$l,ju,eh,ca,ir,rs,th,Jo,Ka,Za,nh,xr={},Sr=[],Xd=/acit|ex(?:s|g|n|p|$)|rph|grid|ows|mnc|ntw|ine[ch]|zoo|^ord|itera/i,Xr=Array.isArray;function In(n,e){for(var t in e)n[t]=e[t];return n}function Qo(n){n&&n.parentNode&&n.parentNode.removeChild(n)}function ih(n,e,t){var i,s,r,a={};for(r in e)r=="key"?i=e[r]:r=="ref"?s=e[r]:a[r]=e[r];if(arguments.length>2&&(a.children=arguments.length>3?Wr.call(arguments,2):t),typeof n=="function"&&n.defaultProps!=null)for(r in n.defaultProps)a[r]===void 0&&(a[r]=n.defaultProps[r]);return sr(n,a,i,s,null)}function sr(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:void 0,__v:s??++Qu,__i:-1,__u:0};return s==null&&nt.vnode!=null&&nt.vnode(r),r}function Bt(n){return n.children}function as(n,e){this.props=n,this.context=e}function mi(n,e){if(e==null)return n.__?mi(n.__,n.__i+1):null;for(var t;e<n.__k.length;e++)if((t=n.__k[e])!=null&&t.__e!=null)return t.__e;return typeof n.type=="function"?mi(n):null}function $d(n){if(n.__P&&n.__d){var e=n.__v,t=e.__e,i=[],s=[],r=In({},e);r.__v=e.__v+1,nt.vnode&&nt.vnode(r),jo(n.__P,r,e,n.__n,n.__P.namespaceURI,32&e.__u?[t]:null,i,t??mi(e),!!(32&e.__u),s),r.__v=e.__v,r.__.__k[r.__i]=r,lh(i,r,s),e.__e=e.__=null,r.__e!=t&&sh(r)}}function sh(n){if((n=n.__)!=null&&n.__c!=null)return n.__e=n.__c.base=null,n.__k.some(function(e){if(e!=null&&e.__e!=null)return n.__e=n.__c.base=e.__e}),sh(n)}function Ja(n){(!n.__d&&(n.__d=!0)&&qn.push(n)&&!Mr.__r++||$l!=nt.debounceRendering)&&(($l=nt.debounceRendering)||ju)(Mr)}function Mr(){try{for(var n,e=1;qn.length;)qn.length>e&&qn.sort(eh),n=qn.shift(),e=qn.length,$d(n)}finally{qn.length=Mr.__r=0}}function rh(n,e,t,i,s,r,a,o,l,c,u){var f,h,g,_,y,d,m=i&&i.__k||Sr,x=e.length;for(l=qd(t,e,m,l,x),f=0;f<x;f++)(g=t.__k[f])!=null&&(h=g.__i!=-1&&m[g.__i]||xr,g.__i=f,d=jo(n,g,h,s,r,a,o,l,c,u),_=g.__e,g.ref&&h.ref!=g.ref&&(h.ref&&el(h.ref,null,g),u.push(g.ref,g.__c||_,g)),y==null&&_!=null&&(y=_),4&g.__u?(l=ah(g,l,n),h.__e&&(h.__e=null)):typeof g.type=="function"&&d!==void 0?l=d:_&&(l=_.nextSibling),g.__u&=-7);return t.__e=y,l}function qd(n,e,t,i,s){var r,a,o,l,c,u=t.length,f=u,h=0;for(n.__k=new Array(s),r=0;r<s;r++)(a=e[r])!=null&&typeof a!="boolean"&&typeof a!="function"?(typeof a=="string"||typeof a=="number"||typeof a=="bigint"||a.constructor==String?a=n.__k[r]=sr(null,a,null,null,null):Xr(a)?a=n.__k[r]=sr(Bt,{children:a},null,null,null):a.constructor===void 0&&a.__b>0?a=n.__k[r]=sr(a.type,a.props,a.key,a.ref?a.ref:null,a.__v):n.__k[r]=a,l=r+h,a.__=n,a.__b=n.__b+1,o=null,(c=a.__i=Yd(a,t,l,f))!=-1&&(f--,(o=t[c])&&(o.__u|=2)),o==null||o.__v==null?(c==-1&&(s>u?h--:s<u&&h++),typeof a.type!="function"&&(a.__u|=4)):c!=l&&(c==l-1?h--:c==l+1?h++:(c>l?h--:h++,a.__u|=4))):n.__k[r]=null;if(f)for(r=0;r<u;r++)(o=t[r])!=null&&(2&o.__u)==0&&(o.__e==i&&(i=mi(o)),uh(o,o));return i}function ah(n,e,t){var i,s;if(typeof n.type=="function"){for(i=n.__k,s=0;i&&s<i.length;s++)i[s]&&(i[s].__=n,e=ah(i[s],e,t));return e}n.__e!=e&&(e&&n.type&&!e.parentNode&&(e=mi(n)),e=t.insertBefore(n.__e,e||null));do e=e&&e.nextSibling;while(e!=null&&e.nodeType==8);return e}function Yd(n,e,t,i){var s,r,a,o=n.key,l=n.type,c=e[t],u=c!=null&&(2&c.__u)==0;if(c===null&&o==null||u&&o==c.key&&l==c.type)return t;if(i>(u?1:0)){for(s=t-1,r=t+1;s>=0||r<e.length;)if((c=e[a=s>=0?s--:r++])!=null&&(2&c.__u)==0&&o==c.key&&l==c.type)return a}return-1}function ql(n,e,t){e[0]=="-"?n.setProperty(e,t??""):n[e]=t==null?"":typeof t!="number"||Xd.test(e)?t:t+"px"}function Rs(n,e,t,i,s){var r,a;e:if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||ql(n.style,e,"");if(t)for(e in t)i&&t[e]==i[e]||ql(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")r=e!=(e=e.replace(th,"$1")),a=e.toLowerCase(),e=a in n||e=="onFocusOut"||e=="onFocusIn"?a.slice(2):e.slice(2),n.l||(n.l={}),n.l[e+r]=t,t?i?t[rs]=i[rs]:(t[rs]=Jo,n.addEventListener(e,r?Za:Ka,r)):n.removeEventListener(e,r?Za:Ka,r);else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{n[e]=t??"";break e}catch{}typeof t=="function"||(t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t))}}function Yl(n){return function(e){if(this.l){var t=this.l[e.type+n];if(e[ir]==null)e[ir]=Jo++;else if(e[ir]<t[rs])return;return t(nt.event?nt.event(e):e)}}}function jo(n,e,t,i,s,r,a,o,l,c){var u,f,h,g,_,y,d,m,x,T,S,E,A,p,w,N,C=e.type;if(e.constructor!==void 0)return null;128&t.__u&&(l=!!(32&t.__u),r=[o=e.__e=t.__e]),(u=nt.__b)&&u(e);e:if(typeof C=="function"){f=a.length;try{if(x=e.props,T=C.prototype&&C.prototype.render,S=(u=C.contextType)&&i[u.__c],E=u?S?S.props.value:u.__:i,t.__c?m=(h=e.__c=t.__c).__=h.__E:(T?e.__c=h=new C(x,E):(e.__c=h=new as(x,E),h.constructor=C,h.render=Zd),S&&S.sub(h),h.state||(h.state={}),h.__n=i,g=h.__d=!0,h.__h=[],h._sb=[]),T&&h.__s==null&&(h.__s=h.state),T&&C.getDerivedStateFromProps!=null&&(h.__s==h.state&&(h.__s=In({},h.__s)),In(h.__s,C.getDerivedStateFromProps(x,h.__s))),_=h.props,y=h.state,h.__v=e,g)T&&C.getDerivedStateFromProps==null&&h.componentWillMount!=null&&h.componentWillMount(),T&&h.componentDidMount!=null&&h.__h.push(h.componentDidMount);else{if(T&&C.getDerivedStateFromProps==null&&x!==_&&h.componentWillReceiveProps!=null&&h.componentWillReceiveProps(x,E),e.__v==t.__v||!h.__e&&h.shouldComponentUpdate!=null&&h.shouldComponentUpdate(x,h.__s,E)===!1){e.__v!=t.__v&&(h.props=x,h.state=h.__s,h.__d=!1),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(L){L&&(L.__=e)}),Sr.push.apply(h.__h,h._sb),h._sb=[],h.__h.length&&a.push(h),o=mi(t);break e}h.componentWillUpdate!=null&&h.componentWillUpdate(x,h.__s,E),T&&h.componentDidUpdate!=null&&h.__h.push(function(){h.componentDidUpdate(_,y,d)})}if(h.context=E,h.props=x,h.__P=n,h.__e=!1,A=nt.__r,p=0,T)h.state=h.__s,h.__d=!1,A&&A(e),u=h.render(h.props,h.state,h.context),Sr.push.apply(h.__h,h._sb),h._sb=[];else do h.__d=!1,A&&A(e),u=h.render(h.props,h.state,h.context),h.state=h.__s;while(h.__d&&++p<25);h.state=h.__s,h.getChildContext!=null&&(i=In(In({},i),h.getChildContext())),T&&!g&&h.getSnapshotBeforeUpdate!=null&&(d=h.getSnapshotBeforeUpdate(_,y)),w=u!=null&&u.type===Bt&&u.key==null?ch(u.props.children):u,o=rh(n,Xr(w)?w:[w],e,t,i,s,r,a,o,l,c),h.base=e.__e,e.__u&=-161,h.__h.length&&a.push(h),m&&(h.__E=h.__=null)}catch(L){if(a.length=f,e.__v=null,l||r!=null){if(L.then){for(e.__u|=l?160:128;o&&o.nodeType==8&&o.nextSibling;)o=o.nextSibling;r!=null&&(r[r.indexOf(o)]=null),e.__e=o}else if(r!=null)for(N=r.length;N--;)Qo(r[N])}else e.__e=t.__e;e.__k==null&&(e.__k=t.__k||[]),L.then||oh(e),nt.__e(L,e,t)}}else r==null&&e.__v==t.__v?(e.__k=t.__k,e.__e=t.__e):o=e.__e=Kd(t.__e,e,t,i,s,r,a,l,c);return(u=nt.diffed)&&u(e),128&e.__u?void 0:o}function oh(n){n&&(n.__c&&(n.__c.__e=!0),n.__k&&n.__k.some(oh))}function lh(n,e,t){for(var i=0;i<t.length;i++)el(t[i],t[++i],t[++i]);nt.__c&&nt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){nt.__e(r,s.__v)}})}function ch(n){return typeof n!="object"||n==null||n.__b>0?n:Xr(n)?n.map(ch):n.constructor!==void 0?null:In({},n)}function Kd(n,e,t,i,s,r,a,o,l){var c,u,f,h,g,_,y,d=t.props||xr,m=e.props,x=e.type;if(x=="svg"?s="http://www.w3.org/2000/svg":x=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r!=null){for(c=0;c<r.length;c++)if((g=r[c])&&"setAttribute"in g==!!x&&(x?g.localName==x:g.nodeType==3)){n=g,r[c]=null;break}}if(n==null){if(x==null)return document.createTextNode(m);n=document.createElementNS(s,x,m.is&&m),o&&(nt.__m&&nt.__m(e,r),o=!1),r=null}if(x==null)d===m||o&&n.data==m||(n.data=m);else{if(r=x=="textarea"&&m.defaultValue!=null?null:r&&Wr.call(n.childNodes),!o&&r!=null)for(d={},c=0;c<n.attributes.length;c++)d[(g=n.attributes[c]).name]=g.value;for(c in d)g=d[c],c=="dangerouslySetInnerHTML"?f=g:c=="children"||c in m||c=="value"&&"defaultValue"in m||c=="checked"&&"defaultChecked"in m||Rs(n,c,null,g,s);for(c in m)g=m[c],c=="children"?h=g:c=="dangerouslySetInnerHTML"?u=g:c=="value"?_=g:c=="checked"?y=g:o&&typeof g!="function"||d[c]===g||Rs(n,c,g,d[c],s);if(u)o||f&&(u.__html==f.__html||u.__html==n.innerHTML)||(n.innerHTML=u.__html),e.__k=[];else if(f&&(n.innerHTML=""),rh(e.type=="template"?n.content:n,Xr(h)?h:[h],e,t,i,x=="foreignObject"?"http://www.w3.org/1999/xhtml":s,r,a,r?r[0]:t.__k&&mi(t,0),o,l),r!=null)for(c=r.length;c--;)Qo(r[c]);o&&x!="textarea"||(c="value",x=="progress"&&_==null?n.removeAttribute("value"):_!=null&&(_!==n[c]||x=="progress"&&!_||x=="option"&&_!=d[c])&&Rs(n,c,_,d[c],s),c="checked",y!=null&&y!=n[c]&&Rs(n,c,y,d[c],s))}return n}function el(n,e,t){try{if(typeof n=="function"){var i=typeof n.__u=="function";i&&n.__u(),i&&e==null||(n.__u=n(e))}else n.current=e}catch(s){nt.__e(s,t)}}function uh(n,e,t){var i,s;if(nt.unmount&&nt.unmount(n),(i=n.ref)&&(i.current&&i.current!=n.__e||el(i,null,e)),(i=n.__c)!=null){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(r){nt.__e(r,e)}i.base=i.__P=i.__n=null}if(i=n.__k)for(s=0;s<i.length;s++)i[s]&&uh(i[s],e,t||typeof n.type!="function");t||Qo(n.__e),n.__c=n.__=n.__e=void 0}function Zd(n,e,t){return this.constructor(n,t)}function Jd(n,e,t){var i,s,r,a;e==document&&(e=document.documentElement),nt.__&&nt.__(n,e),s=(i=!1)?null:e.__k,r=[],a=[],jo(e,n=e.__k=ih(Bt,null,[n]),s||xr,xr,e.namespaceURI,s?null:e.firstChild?Wr.call(e.childNodes):null,r,s?s.__e:e.firstChild,i,a),lh(r,n,a),n.props.children=null}function Qd(n){function e(t){var i,s;return this.getChildContext||(i=new Set,(s={})[e.__c]=this,this.getChildContext=function(){return s},this.componentWillUnmount=function(){i=null},this.shouldComponentUpdate=function(r){this.props.value!=r.value&&i.forEach(function(a){a.__e=!0,Ja(a)})},this.sub=function(r){i.add(r);var a=r.componentWillUnmount;r.componentWillUnmount=function(){i&&i.delete(r),a&&a.call(r)}}),t.children}return e.__c="__cC"+nh++,e.__=n,e.Provider=e.__l=(e.Consumer=function(t,i){return t.children(i)}).contextType=e,e}Wr=Sr.slice,nt={__e:function(n,e,t,i){for(var s,r,a;e=e.__;)if((s=e.__c)&&!s.__)try{if((r=s.constructor)&&r.getDerivedStateFromError!=null&&(s.setState(r.getDerivedStateFromError(n)),a=s.__d),s.componentDidCatch!=null&&(s.componentDidCatch(n,i||{}),a=s.__d),a)return s.__E=s}catch(o){n=o}throw n}},Qu=0,as.prototype.setState=function(n,e){var t;t=this.__s!=null&&this.__s!=this.state?this.__s:this.__s=In({},this.state),typeof n=="function"&&(n=n(In({},t),this.props)),n&&In(t,n),n!=null&&this.__v&&(e&&this._sb.push(e),Ja(this))},as.prototype.forceUpdate=function(n){this.__v&&(this.__e=!0,n&&this.__h.push(n),Ja(this))},as.prototype.render=Bt,qn=[],ju=typeof Promise=="function"?Promise.prototype.then.bind(Promise.resolve()):setTimeout,eh=function(n,e){return n.__v.__b-e.__v.__b},Mr.__r=0,ca=Math.random().toString(8),ir="__d"+ca,rs="__a"+ca,th=/(PointerCapture)$|Capture$/i,Jo=0,Ka=Yl(!1),Za=Yl(!0),nh=0;var jd=0;function b(n,e,t,i,s,r){e||(e={});var a,o,l=e;if("ref"in l)for(o in l={},e)o=="ref"?a=e[o]:l[o]=e[o];var c={type:n,props:l,key:t,ref:a,__k:null,__:null,__b:0,__e:null,__c:null,constructor:void 0,__v:--jd,__i:-1,__u:0,__source:s,__self:r};if(typeof n=="function"&&(a=n.defaultProps))for(o in a)l[o]===void 0&&(l[o]=a[o]);return nt.vnode&&nt.vnode(c),c}var jn,st,ua,Kl,yr=0,hh=[],dt=nt,Zl=dt.__b,Jl=dt.__r,Ql=dt.diffed,jl=dt.__c,ec=dt.unmount,tc=dt.__;function Wi(n,e){dt.__h&&dt.__h(st,n,yr||e),yr=0;var t=st.__H||(st.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Un(n){return yr=1,dh(fh,n)}function dh(n,e,t){var i=Wi(jn++,2);if(i.t=n,!i.__c&&(i.__=[fh(void 0,e),function(o){var l=i.__N?i.__N[0]:i.__[0],c=i.t(l,o);l!==c&&(i.__N=[c,i.__[1]],i.__c.setState({}))}],i.__c=st,!st.__f)){var s=function(o,l,c){if(!i.__c.__H)return!0;var u=!1,f=i.__c.props!==o;if(i.__c.__H.__.some(function(g){if(g.__N){u=!0;var _=g.__[0];g.__=g.__N,g.__N=void 0,_!==g.__[0]&&(f=!0)}}),r){var h=r.call(this,o,l,c);return u?h||f:h}return!u||f};st.__f=!0;var r=st.shouldComponentUpdate,a=st.componentWillUpdate;st.componentWillUpdate=function(o,l,c){if(this.__e){var u=r;r=void 0,s(o,l,c),r=u}a&&a.call(this,o,l,c)},st.shouldComponentUpdate=s}return i.__N||i.__}function ei(n,e){var t=Wi(jn++,3);!dt.__s&&nl(t.__H,e)&&(t.__=n,t.u=e,st.__H.__h.push(t))}function Er(n,e){var t=Wi(jn++,4);!dt.__s&&nl(t.__H,e)&&(t.__=n,t.u=e,st.__h.push(t))}function _t(n){return yr=5,ti(function(){return{current:n}},[])}function ti(n,e){var t=Wi(jn++,7);return nl(t.__H,e)&&(t.__=n(),t.__H=e,t.__h=n),t.__}function ef(n){var e=st.context[n.__c],t=Wi(jn++,9);return t.c=n,e?(t.__==null&&(t.__=!0,e.sub(st)),e.props.value):n.__}function tl(){var n=Wi(jn++,11);if(!n.__){for(var e=st.__v;e!==null&&!e.__m&&e.__!==null;)e=e.__;var t=e.__m||(e.__m=[0,0]);n.__="P"+t[0]+"-"+t[1]++}return n.__}function tf(){for(var n;n=hh.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(rr),e.__h.some(Qa),e.__h=[]}catch(t){e.__h=[],dt.__e(t,n.__v)}}}dt.__b=function(n){st=null,Zl&&Zl(n)},dt.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),tc&&tc(n,e)},dt.__r=function(n){Jl&&Jl(n),jn=0;var e=(st=n.__c).__H;e&&(ua===st?(e.__h=[],st.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})):(e.__h.some(rr),e.__h.some(Qa),e.__h=[],jn=0)),ua=st},dt.diffed=function(n){Ql&&Ql(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&(hh.push(e)!==1&&Kl===dt.requestAnimationFrame||((Kl=dt.requestAnimationFrame)||nf)(tf)),e.__H.__.some(function(t){t.u&&(t.__H=t.u,t.u=void 0)})),ua=st=null},dt.__c=function(n,e){e.some(function(t){try{t.__h.some(rr),t.__h=t.__h.filter(function(i){return!i.__||Qa(i)})}catch(i){e.some(function(s){s.__h&&(s.__h=[])}),e=[],dt.__e(i,t.__v)}}),jl&&jl(n,e)},dt.unmount=function(n){ec&&ec(n);var e,t=n.__c;t&&t.__H&&(t.__H.__.some(function(i){try{rr(i)}catch(s){e=s}}),t.__H=void 0,e&&dt.__e(e,t.__v))};var nc=typeof requestAnimationFrame=="function";function nf(n){var e,t=function(){clearTimeout(i),nc&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);nc&&(e=requestAnimationFrame(t))}function rr(n){var e=st,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),st=e}function Qa(n){var e=st;n.__c=n.__(),st=e}function nl(n,e){return!n||n.length!==e.length||e.some(function(t,i){return t!==n[i]})}function fh(n,e){return typeof e=="function"?e(n):e}function ph(n,e,t){for(const[i,s]of Object.entries(e))s==null||s===!1||(i==="style"?n.style.cssText=String(s):n.setAttribute(i,s===!0?"":String(s)));for(const i of t)i!=null&&n.append(i)}function sf(n,e={},...t){const i=document.createElement(n);return ph(i,e,t),i}function Ht(n,e={},...t){const i=document.createElementNS("http://www.w3.org/2000/svg",n);return ph(i,e,t),i}function tt(n,e){if(n==null||Number.isNaN(n))return"–";const t=n.toFixed(e);return(Number(t)===0?t.replace("-",""):t).replace("-","−")}function vs(n){return n.replace(/-/g,"−")}function rt(n){return typeof n=="object"&&n!==null&&!Array.isArray(n)}function rn(n){return Array.isArray(n)}const rf=32;function mh(n,e=rf){return typeof n!="object"?n!==void 0:n===null||e===0?!1:Object.values(n).every(t=>mh(t,e-1))}function Qe(n){let e="";for(const t of n)typeof t=="number"?e+=`[${String(t)}]`:e+=e===""?t:`.${t}`;return e}function $r(n){const e=[];for(const t of n.matchAll(/\[(\d+)\]|[^.[\]]+/g))e.push(t[1]===void 0?t[0]:Number(t[1]));return e}function af(n){return Qe(n).replace(/\[\d+\]/g,"[]")}function pn(n,e){let t=n;for(const i of e)typeof i=="number"?t=rn(t)?t[i]:void 0:t=rt(t)?t[i]:void 0;return t}function qr(n,e,t){return ja(n,e,t)}function ja(n,e,t){const[i,...s]=e;if(i===void 0)return t;if(typeof i=="number"){const o=rn(n)?[...n]:[],l=ja(o[i],s,t);return l===void 0?o.splice(i,1):o[i]=l,o}const r=rt(n)?{...n}:{},a=ja(r[i],s,t);return a===void 0?Reflect.deleteProperty(r,i):r[i]=a,r}const of=["fit","uncertainty"];function en(n,e,t){const i=qr(n.recipe,e,t);return t===void 0?_h({...n,recipe:i},s=>gh(s,e)?null:s):{...n,recipe:i}}function lf(n,e,t){const i=new Set(n.locks);return t?i.add(Qe(e)):i.delete(Qe(e)),{...n,locks:i}}const cf="correlation";function gh(n,e){return e.every((t,i)=>n[i]===t)}function _h(n,e){const t=r=>{const a=e($r(r));return a===null?null:Qe(a)},i=new Set;for(const r of n.locks){const a=t(r);a!==null&&i.add(a)}let s=n.recipe;for(const r of of){const a=s[r];if(!rt(a))continue;const o=Object.entries(a).flatMap(([c,u])=>{if(c===cf){const h=rn(u)?uf(u,t):u;return rn(h)&&h.length===0?[]:[[c,h]]}const f=t(c);return f===null?[]:[[f,u]]}),l=o.length>0?Object.fromEntries(o):void 0;s=qr(s,[r],l)}return{...n,recipe:s,locks:i}}function uf(n,e){return n.flatMap(t=>{const i=rt(t)?t.of:void 0;if(!rt(t)||!rn(i))return[t];const s=i.flatMap(r=>{const a=typeof r=="string"?e(r):r;return a===null?[]:[a]});return s.length<2?[]:[{...t,of:s}]})}function il(n,e,t){return _h(n,i=>{const s=i[e.length];if(!gh(i,e)||typeof s!="number")return i;const r=t(s);return r===null?null:[...e,r,...i.slice(e.length+1)]})}function sl(n,e){const t=pn(n.recipe,e);return rn(t)?t:[]}function rl(n,e,t){return{...n,recipe:qr(n.recipe,e,t.length>0?t:void 0)}}function vh(n,e,t,i){const s=[...sl(n,e)];s.splice(t,0,rt(i)?{...i}:i);const r=il(n,e,a=>a>=t?a+1:a);return rl(r,e,s)}function hf(n,e,t){const i=sl(n,e).filter((r,a)=>a!==t),s=il(n,e,r=>r===t?null:r>t?r-1:r);return rl(s,e,i)}function df(n,e,t,i){const s=[...sl(n,e)],[r,a]=[s[t],s[t+i]];if(r===void 0||a===void 0)return n;s[t]=a,s[t+i]=r;const o=il(n,e,l=>l===t?t+i:l===t+i?t:l);return rl(o,e,s)}class al{constructor(e){this.value=e,this.listeners=new Set}get(){return this.value}set(e){this.value={...this.value,...e};for(const t of[...this.listeners])t()}subscribe(e){return this.listeners.add(e),()=>{this.listeners.delete(e)}}}function ol(n,e){const[,t]=dh(r=>r+1,0),i=e(n.get()),s=_t(e);return s.current=e,ei(()=>{let r=i;const a=()=>{const o=s.current(n.get());Object.is(o,r)||(r=o,t(void 0))};return a(),n.subscribe(a)},[n,i]),i}const xh=Qd(null),ff=xh.Provider;function lt(){const n=ef(xh);if(n===null)throw new Error("drawn outside of the studio");return n}function ve(n){return ol(lt().store,n)}function Yr(n){return ve(({document:e})=>pn(e.recipe,n))}function Ct(n){return ol(lt().viewer.store,n)}function ar(n){return ol(lt().atlas.store,n)}function Sh(n,e){return n.reading_models.find(t=>t.name===e)?.title??e}function dn(n,e){const t=af(e);return n.recipe.tables.find(i=>i.path===t)}const pf=[["_g_per_cm3","g/cm³"],["_per_mm","mm⁻¹"],["_per_um","µm⁻¹"],["_um","µm"],["_nm","nm"],["_mm","mm"],["_deg","°"]],mf={ior:"Binder",alpha:"Tilt, alpha",alpha_bottom:"Tilt at bottom",diameter_spread_um:"± diameter",spread_nm:"± thickness",wa:"Waves a",wb:"Waves b",wc:"Waves c",wd:"Waves d",we:"Waves e"};function Gt(n){const e=pf.find(([s])=>n.endsWith(s)),t=e===void 0?n:n.slice(0,-e[0].length),i=mf[n]??t.replace(/_/g," ");return{label:i.charAt(0).toUpperCase()+i.slice(1),unit:e?.[1]??""}}function Si(n,e){const t=e.each.findIndex(({mark:i})=>i!==""&&i in n);return Math.max(t,0)}function eo(n){return n.each.flatMap(({keys:e})=>e)}function xs(n,e){const t=e.alternatives??[];return t.filter(i=>t.every(s=>{if(s===i)return!0;const r=s.each[Si(n,s)]?.keys??[],a=eo(s).filter(o=>!r.includes(o));return!eo(i).every(o=>a.includes(o))}))}function Mh(n,e,t){for(const i of xs(n,e)){const s=Si(n,i);if(i.each[s]?.keys.includes(t.key)===!0)continue;const r=i.each.findIndex(({mark:a,keys:o})=>a===t.key||t.required&&o.includes(t.key));if(r>=0)return{group:i,to:r}}}function ic(n,e,t){return xs(n,e).find(i=>!i.required&&i.each[0]?.mark===""&&i.each[Si(n,i)]?.mark===t)}function Kr(n,e){const t=new Set,i=new Set;for(const s of xs(n,e)){const r=Si(n,s);s.each.forEach(({keys:a},o)=>{for(const l of a)(o===r?i:t).add(l)})}for(const s of i)t.delete(s);return t}function gf(n,e,t){return Mh(n,e,t)!==void 0?!1:xs(n,e).some(i=>!(i.each[Si(n,i)]?.keys??[]).includes(t.key)&&eo(i).includes(t.key))}function _f(n,e){return[e,n.doc,vf(n)].filter(t=>t!=="").join("; ")}function vf(n){const{min:e,max:t}=n;if(e===void 0&&t===void 0)return"";const i=n.min_excluded===!0||e===null?"(":"[",s=n.max_excluded===!0||t===null?")":"]",r=e==null?"−∞":sn(e),a=t==null?"∞":sn(t),o=Gt(n.key).unit;return`${n.zero===void 0?"":"0 or "}${i}${r}, ${a}${s}${o===""?"":` ${o}`}`}function sn(n){return String(Number(n.toPrecision(6))).replace("-","−")}function xf(n,e){if(!Number.isFinite(e))return!1;if(n.zero!==void 0&&e===0)return!0;const{min:t,max:i}=n;return t!=null&&(n.min_excluded?e<=t:e<t)?!1:!(i!=null&&(n.max_excluded?e>=i:e>i))}function yh(n,e){const t=[],i=s=>{const r=pn(e,s),a=dn(n,s);if(!(!rt(r)||a===void 0))for(const o of a.keys){const l=r[o.key],c=[...s,o.key];typeof l=="number"&&(o.kind==="number"||o.kind==="spectrum")?t.push({path:c,info:o,value:l}):o.kind==="table"?i(c):o.kind==="list"&&rn(l)&&l.forEach((u,f)=>{i([...c,f])})}};return i([]),t}function Mi(n,e){const t=[];e.slice(0,-1).forEach((s,r)=>{if(typeof s=="number"){const a=pn(n,e.slice(0,r+1)),o=rt(a)?a.name??a.from??a.material:void 0,c=`${ll(String(e[r-1]))} ${String(s+1)}`;t.push(typeof o=="string"&&o!==""?o:c)}else typeof e[r+1]!="number"&&t.push(s.replace(/_/g," "))});const i=t.join(", ");return i.charAt(0).toUpperCase()+i.slice(1)}function ll(n){return n==="flakes"?n:n.replace(/s$/,"")}const sc={lean:{tilt_deg:5,azimuth_deg:0},"layer[].flakes[]":{name:"TiO2 on mica",volume_fraction:.03,diameter_um:18,orientation:{distribution:"beckmann",alpha:.1},core:{material:"mica",thickness_nm:500,spread_nm:60},coats:[{material:"TiO2_anatase",thickness_nm:110,spread_nm:5}]},"layer[].flakes[].coats[]":{material:"SiO2",thickness_nm:100,spread_nm:5},"layer[].flakes[].core":{material:"mica",thickness_nm:500,spread_nm:60},"layer[].flakes[].orientation.tilts":[{tilt_deg:0,density:1},{tilt_deg:15,density:0}],"clearcoat.orange_peel":{wc:.005,wd:.005}};function Sf(n,e,t,i){const s=Ss(n,e,t),r=t.spread_of===void 0?void 0:i[t.spread_of];return typeof s!="number"||typeof r!="number"?s:Math.min(s,Number((r/4).toPrecision(2)))}function Ss(n,e,t){const i=[...e,t.key].map(a=>typeof a=="number"?"[]":`.${a}`).join("").slice(1),s=sc[i];if(s!==void 0)return s;const r=t.kind==="list"?sc[`${i}[]`]:void 0;if(r!==void 0)return[r];if(i==="layer[].pigment")return[yf(n)];switch(t.kind){case"number":case"spectrum":return t.typical??t.default??t.min??0;case"material":return n.materials[0]?.name??1.5;case"text":return t.choices==="pigments"?n.pigments[0]?.name??"":"";case"choice":return(Array.isArray(t.choices)?t.choices[0]:"")??"";case"flag":return!0;case"list":return[rc(n,[...e,t.key,0])];case"table":return rc(n,[...e,t.key])}}function Mf(n,e,t){if(e.at(-1)===us&&rt(t)&&typeof t.tilt_deg=="number")return{tilt_deg:Math.min(t.tilt_deg+5,90),density:0};const i=dn(n,e.slice(0,-1))?.keys.find(r=>r.key===e.at(-1));if(i===void 0)return{};const s=Ss(n,e.slice(0,-1),i);return(Array.isArray(s)?s[0]:s)??{}}function yf(n){const e=n.pigments[0];return e===void 0?{scattering_per_mm:10,absorption_per_mm:10}:{from:e.name,volume_fraction:.05}}function rc(n,e){const t=dn(n,e);if(t===void 0)return{};const i=new Set((t.alternatives??[]).flatMap(({each:r})=>r.flatMap(a=>a.keys))),s={};for(const r of t.keys)r.required&&!i.has(r.key)&&(s[r.key]=Ss(n,e,r));for(const r of t.alternatives??[])xs(s,t).includes(r)&&cl(n,e,t,r.each[0],s);return s}const us="tilts",br="tabulated";function Ef(n){if(!("distribution"in n))return n;const e=n.distribution===br;return us in n===e?n:{...n,distribution:e?"beckmann":br}}function bf(n,e,t,i,s){const r=dn(n,e)?.alternatives?.find(({each:o})=>o.some(({mark:l})=>l===us));if(r===void 0||i!=="distribution")return{...t,[i]:s};const a=r.each.findIndex(({mark:o})=>o===us==(s===br));return{...or(n,e,t,r,a),[i]:s}}function cl(n,e,t,i,s){const r=(t.alternatives??[]).filter(({required:o,each:l})=>o&&l.every(({mark:c,keys:u})=>c!==i?.mark&&wf(u,i?.keys??[]))),a=new Set(r.flatMap(({each:o})=>o.flatMap(({keys:l})=>l)));for(const o of t.keys){const l=o.required?!a.has(o.key):o.required_with!==void 0&&o.required_with in s;(o.key===i?.mark||l&&i?.keys.includes(o.key)===!0)&&s[o.key]===void 0&&(s[o.key]=Ss(n,e,o))}for(const{each:o}of r)o.some(({mark:l})=>l in s)||cl(n,e,t,o[0],s)}function wf(n,e){return n.every(t=>e.includes(t))}function or(n,e,t,i,s){const r=dn(n,e),a=i.each[s];if(r===void 0||a===void 0||Si(t,i)===s)return t;const o=new Set(i.each.flatMap(({keys:f})=>f));for(const f of a.keys)o.delete(f);const l=Object.entries(t).filter(([f])=>!o.has(f)),c=Object.fromEntries(l);cl(n,e,r,a,c);const u=Kr(c,r);for(const f of r.keys)!(f.required_with!==void 0&&f.required_with in c)||f.key in c||u.has(f.key)||(c[f.key]=Ss(n,e,f));return Ef(c)}class Tf{constructor(){this.known=new WeakMap,this.before=[],this.next=0}of(e){const t=this.before.length===e.length,i=new Set(e),s=e.map((r,a)=>{if(typeof r!="object")return a;const o=this.before[a],l=t&&typeof o=="object"&&!i.has(o),c=this.known.get(r)??(l?this.known.get(o):void 0)??this.next++;return this.known.set(r,c),c});return this.before=e,s}}function Af(n){const e=_t(null);return e.current??=new Tf,e.current.of(n)}function hs(...n){setTimeout(()=>{for(const e of n){const t=document.querySelector(e);if(!(t===null||t.matches(":disabled"))){t.focus();return}}})}const Rf={up:"M8 13V3M3.5 7.5 8 3l4.5 4.5",down:"M8 3v10M3.5 8.5 8 13l4.5-4.5",remove:"m4 4 8 8m0-8-8 8",copy:"M5.5 5.5v-3h8v8h-3m-8-5h8v8h-8z",lock:"M3.5 7.5h9v6h-9zM5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5",unlock:"M3.5 7.5h9v6h-9zM5.5 7.5V5a2.5 2.5 0 0 1 4.6-1.4",open:"m5 6 3 3.5L11 6",closed:"m6 5 3.5 3L6 11",undo:"M6 3 2.5 6.5 6 10M2.5 6.5H9a4 4 0 0 1 0 8H6",redo:"m10 3 3.5 3.5L10 10m3.5-3.5H7a4 4 0 0 0 0 8h3",add:"M8 3v10M3 8h10"};function Eh({name:n}){return b("svg",{class:"icon",viewBox:"0 0 16 16",width:"16",height:"16","aria-hidden":"true",children:b("path",{d:Rf[n]})})}function di(n){return b("button",{type:"button",class:"icon-button","data-icon":n.icon,"aria-label":n.label,title:n.label,disabled:n.disabled??!1,"aria-pressed":n.pressed,onClick:n.onClick,children:b(Eh,{name:n.icon})})}function bh(n){const e=t=>String(Math.round(255*Math.min(Math.max(t,0),1)));return`rgb(${n.map(e).join(", ")})`}function ac({rgb:n}){return n===void 0?null:n===null?b("i",{class:"swatch none"}):b("i",{class:"swatch",style:{background:bh(n)}})}const Cs=2,Ps=8,oc=380;function lc(n,e){const{top:t,bottom:i,left:s,width:r}=e.getBoundingClientRect(),a=innerHeight-i-Cs-Ps,o=t-Cs-Ps,l=Math.min(oc,n.scrollHeight),c=a<l&&o>a,{style:u}=n;u.minWidth=`${String(r)}px`,u.maxHeight=`${String(Math.min(oc,c?o:a))}px`,u.left=`${String(Math.max(Ps,Math.min(s,innerWidth-n.offsetWidth-Ps)))}px`,u.top=c?"auto":`${String(i+Cs)}px`,u.bottom=c?`${String(innerHeight-t+Cs)}px`:"auto"}const Cf=800;function Zr(n){const{choices:e,chosen:t,onChoose:i}=n,[s,r]=Un(!1),[a,o]=Un(0),l=tl(),c=_t(null),u=_t(null),f=_t(null),h=_t({text:"",at:0}),g=e.find(({name:T})=>T===t);Er(()=>{if(!s||f.current===null||u.current===null)return;const[T,S]=[f.current,u.current];lc(T,S),T.focus({preventScroll:!0});const E=w=>{c.current?.contains(w.target)!==!0&&r(!1)},A=w=>{w.target!==T&&lc(T,S)},p=new IntersectionObserver(([w])=>{w?.isIntersecting===!1&&r(!1)});return p.observe(S),document.addEventListener("pointerdown",E),document.addEventListener("scroll",A,!0),addEventListener("resize",A),()=>{p.disconnect(),document.removeEventListener("pointerdown",E),document.removeEventListener("scroll",A,!0),removeEventListener("resize",A)}},[s]),ei(()=>{s&&f.current?.children[a]?.scrollIntoView({block:"nearest"})},[s,a]);const _=()=>{o(Math.max(0,e.findIndex(({name:T})=>T===t))),r(!0)},y=()=>{r(!1),u.current?.focus()},d=T=>{const S=e[T];y(),S!==void 0&&i(S.name)},m=T=>{const S=Date.now(),E=S-h.current.at>Cf;h.current={text:(E?"":h.current.text)+T.toLowerCase(),at:S};const A=E?a+1:a,w=[...e.keys()].map(N=>(N+A)%e.length).find(N=>{const{title:C,name:L}=e[N];return(C??L).toLowerCase().startsWith(h.current.text)});w!==void 0&&o(w)},x=T=>{const S=e.length-1;if(T.key==="ArrowDown")o(Math.min(a+1,S));else if(T.key==="ArrowUp")o(Math.max(a-1,0));else if(T.key==="Home")o(0);else if(T.key==="End")o(S);else if(T.key==="Enter"||T.key===" ")d(a);else if(T.key==="Escape")y();else if(T.key==="Tab")r(!1);else if(T.key.length===1&&!T.ctrlKey&&!T.metaKey)m(T.key);else return;T.key!=="Tab"&&T.preventDefault(),T.stopPropagation()};return b("div",{class:`picker ${n.class??""}`,ref:c,children:[b("button",{type:"button",ref:u,class:"picked","aria-label":g===void 0?n.label:`${n.label}: ${g.name}`,"aria-haspopup":"listbox","aria-expanded":s,disabled:n.disabled??!1,onClick:()=>{s?r(!1):_()},onKeyDown:T=>{(T.key==="ArrowDown"||T.key==="ArrowUp")&&(T.preventDefault(),_())},children:[n.text===void 0&&b(ac,{rgb:g?.rgb}),b("span",{children:n.text??g?.title??g?.name??t??""})]}),s&&b("ul",{ref:f,class:"choices",role:"listbox",tabIndex:-1,"aria-label":n.label,"aria-activedescendant":`${l}-${String(a)}`,onKeyDown:x,children:e.map((T,S)=>b("li",{id:`${l}-${String(S)}`,role:"option","aria-selected":T.name===t,class:S===a?"active":"",onPointerMove:()=>{o(S)},onClick:()=>{d(S)},children:[b(ac,{rgb:T.rgb}),b("span",{children:[T.title??T.name,T.summary!==void 0&&b("small",{children:T.summary})]})]},T.name))})]})}function Xi(n){return class extends as{shouldComponentUpdate(t){return!Pf(this.props,t)}render(){return ih(n,this.props)}}}function Pf(n,e){const[t,i]=[Object.entries(n),new Map(Object.entries(e))];return t.length===i.size&&t.every(([s,r])=>i.has(s)&&Lf(s,r,i.get(s)))}function Lf(n,e,t){return n==="path"?Qe(e)===Qe(t):e===t}function wh(n){const e=Qe(n);return ve(({fault:t})=>t?.key===e?to(t.message,e):null)}function Df(n){const e=Qe(n);return ve(({fault:t,document:i})=>{if(t?.key===void 0)return null;if(t.key===e)return to(t.message,e);const s=$r(t.key);return s.length===n.length+1&&n.every((a,o)=>s[o]===a)&&pn(i.recipe,s)===void 0?to(t.message,e):null})}function to(n,e){const t=n.indexOf(e),i=t<0?n:n.slice(t+e.length).replace(/^[ .:]+/,""),s=i.startsWith("= ")?i.indexOf(": "):-1;return s<0?i:i.slice(s+2)}function ul({id:n,text:e}){return e===null?null:b("p",{class:"fault",id:n,role:"alert",children:e})}function Ui(n){return String(Number(n.toPrecision(6))).replace("e+","e")}const cc=7;function uc(n){const e=Ui(n);if(e.length<=cc)return e;const t=i=>n.toExponential(i).replace(/\.?0*e\+?/,"e");return[4,3,2,1].map(t).find(({length:i})=>i<=cc)??t(0)}const Nf={nm:100,um:50,"1/mm":100,"1/um":1,deg:45,"g/cm^3":5};function Oi(n){const e=10**Math.floor(Math.log10(n)),t=[1,2,5,10].find(i=>i*e>=n*(1-1e-9))??10;return Number((t*e).toPrecision(12))}function Th(n,e,t){const i=n.min??-1/0,s=n.max??1/0;let r,a;if(t!==void 0)[r,a]=t;else if(s-i<=1.0000001&&e>s/4)[r,a]=[i,s];else if(i<0)[r,a]=[i,s];else{const l=e>0?Oi(2*e):Nf[n.unit]??1;[r,a]=[0,Math.min(l,s)]}Number.isFinite(r)||(r=-Oi(2*Math.abs(e)||1)),Number.isFinite(a)||(a=Oi(2*Math.abs(e)||1)),r<i&&n.zero===void 0&&(r=i);const o=Oi((a-r)/500);return{low:r,high:a,step:o}}function ha(n,e,t){const i=Number((Math.round(t/e.step)*e.step).toPrecision(12));let s=Math.min(Math.max(i,e.low),e.high);const{min:r,max:a}=n;return n.zero!==void 0&&r!==null&&r!==void 0&&s<r?s<r/2?0:r:(r!=null&&(s=Math.max(s,n.min_excluded?r+e.step:r)),a!=null&&(s=Math.min(s,n.max_excluded?a-e.step:a)),Number(s.toPrecision(12)))}function If(n){if(!Array.isArray(n)||n.length!==2)return;const[e,t]=n;return typeof e=="number"&&typeof t=="number"?[e,t]:void 0}function Ah(n){const{path:e,info:t,value:i}=n,s=lt(),r=Qe(e),a=ve(q=>q.document.locks.has(r)),o=ve(q=>Mi(q.document.recipe,e)),l=If(Yr(["fit",r])),c=wh(e),u=tl(),[f,h]=Un(null),[g,_]=Un(!1),[y,d]=Un(null),m=ve(({document:q})=>y?.of===q);ei(()=>{m||d(null)},[m]);const x=_t(null),T=_t(!1),S=x.current,E=S===null||i>S.high||i<S.low,A=S!==null&&i>0&&i<S.high/40;(E||A&&!T.current)&&(x.current=Th(t,i,l));const{low:p,high:w,step:N}=x.current,{unit:C}=Gt(t.key),L=n.label??Gt(t.key).label,k=o===""?L:`${L}, ${o}`,X=(q,G)=>{s.edit(j=>en(j,e,q),G)},I=()=>{if(f===null)return;const q=Number(f.trim().replace("−","-").replace(",","."));if(h(null),f.trim()===""||!Number.isFinite(q)){const G=s.store.get().document;d({text:`“${f}” is not a number`,of:G});return}d(null),q!==i&&X(q,null)},V=(q,G)=>{G.preventDefault(),h(null);const j=G.shiftKey?10*N:N;X(ha(t,{low:p,high:1/0,step:N},i+q*j),`type ${r}`)},Q=uc(i)===Ui(i)?"":Ui(i),z=m&&y!==null?y.text:c;return b("div",{class:z===null?"row number":"row number wrong","data-key":r,children:[b("label",{for:u,title:t.doc,children:L}),b("input",{type:"range",min:p,max:w,step:"any",value:i,disabled:a,"aria-label":`${k}, slider`,"aria-valuetext":`${Ui(i)} ${C}`,onInput:q=>{T.current=!0,d(null);const G=Number(q.currentTarget.value);X(ha(t,{low:p,high:w,step:N},G),`slide ${r}`)},onChange:()=>{T.current=!1,s.endGesture()},onKeyDown:q=>{const j={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:20,PageDown:-20}[q.key];if(j===void 0)return;q.preventDefault();const te=q.shiftKey?10*N:N,Ee=ha(t,{low:p,high:w,step:N},i+j*te);X(Ee,`slide ${r}`)},onBlur:()=>{s.endGesture()}}),b("input",{id:u,type:"text",inputMode:"decimal",autocomplete:"off",value:f??(g?Ui(i):uc(i)),readOnly:a,title:_f(t,Q),"aria-label":k,"aria-invalid":z!==null,"data-draft":f!==null,"aria-describedby":z===null?void 0:`${u}-fault`,onInput:q=>{h(q.currentTarget.value)},onFocus:q=>{_(!0),q.currentTarget.value=Ui(i),q.currentTarget.select()},onBlur:()=>{_(!1),I(),s.endGesture()},onKeyDown:q=>{if(q.key==="Enter")I();else if(q.key==="Escape")h(null),d(null);else{if(a)return;q.key==="ArrowUp"?V(1,q):q.key==="ArrowDown"&&V(-1,q)}}}),b("span",{class:"unit",children:C}),b(di,{icon:a?"lock":"unlock",label:a?`Unlock ${k}`:`Lock ${k}`,pressed:a,onClick:()=>{s.edit(q=>lf(q,e,!a))}}),b(ul,{id:`${u}-fault`,text:z})]})}const Uf=Xi(({path:n,info:e,value:t})=>{if(typeof t=="number"&&e.kind!=="material")return b(Ah,{path:n,info:e,value:t});switch(e.kind){case"material":return b(Ff,{path:n,info:e,value:t});case"choice":return b(kf,{path:n,info:e,value:t});case"text":return e.choices==="pigments"?b(Of,{path:n,info:e,value:t}):b(Bf,{path:n,info:e,value:t});case"spectrum":return zf(t)?b(Vf,{path:n,info:e,value:t}):b(hc,{path:n,info:e,value:t});default:return b(hc,{path:n,info:e,value:t})}});function $i({path:n,info:e}){const t=lt(),i=ve(o=>Mi(o.document.recipe,n)),s=wh(n),r=tl(),{label:a}=Gt(e.key);return{id:r,label:a,full:i===""?a:`${a}, ${i}`,fault:s,faultText:b(ul,{id:`${r}-fault`,text:s}),describedBy:s===null?void 0:`${r}-fault`,class:s===null?"row":"row wrong",set:o=>{t.edit(l=>en(l,n,o))}}}function ds(n){return typeof n=="string"||typeof n=="number"?String(n):""}const da="a number: its index";function Ff(n){const e=$i(n),{value:t}=n,i=ve(u=>u.schema?.materials)??[],{info:s,path:r}=n,a=rt(t)?"own samples":typeof t=="string"?t:null,o=i.some(({name:u})=>u===t),l=[...a!==null&&!o?[{name:a,rgb:null}]:[],...i,{name:da,summary:"the same at all wavelengths",rgb:null}],c=b(Zr,{label:e.full,choices:l,chosen:typeof t=="number"?da:a,onChoose:u=>{u===da?e.set(typeof t=="number"?t:1.5):u!==a&&e.set(u)}});return typeof t=="number"?b(Bt,{children:[b("div",{class:e.class,children:[b("span",{class:"label",title:s.doc,children:e.label}),c]}),b(Ah,{path:r,info:{...s,kind:"number"},value:t,label:"Index"})]}):b("div",{class:e.class,"data-key":r.join("."),children:[b("span",{class:"label",title:s.doc,children:e.label}),c,e.faultText]})}function Of(n){const e=$i(n),t=ve(i=>i.schema?.pigments)??[];return b("div",{class:e.class,children:[b("span",{class:"label",children:"Pigment"}),b(Zr,{label:e.full,choices:t,chosen:ds(n.value),onChoose:e.set}),e.faultText]})}function kf(n){const e=$i(n),{info:t,value:i}=n,r=(Array.isArray(t.choices)?t.choices:[]).filter(l=>l!==br||l===i),a=lt(),o=l=>{const{schema:c}=a.store.get(),u=n.path.slice(0,-1);a.edit(f=>{const h=pn(f.recipe,u);return c===null||!rt(h)?f:en(f,u,bf(c,u,h,t.key,l))})};return b("div",{class:e.class,children:[b("label",{for:e.id,title:t.doc,children:e.label}),b("select",{id:e.id,"aria-label":e.full,"aria-describedby":e.describedBy,value:ds(i),onChange:l=>{o(l.currentTarget.value)},children:r.map(l=>b("option",{value:l,children:l},l))}),e.faultText]})}function Bf(n){const e=$i(n);return b("div",{class:e.class,children:[b("label",{for:e.id,title:n.info.doc,children:e.label}),b("input",{id:e.id,type:"text","aria-label":e.full,"aria-describedby":e.describedBy,value:ds(n.value),onChange:t=>{e.set(t.currentTarget.value)}}),e.faultText]})}function zf(n){return rn(n)&&n.length===3&&n.every(e=>typeof e=="number")}const Hf=n=>n<=.0031308?12.92*n:1.055*n**(1/2.4)-.055,Gf=n=>n<=.04045?n/12.92:((n+.055)/1.055)**2.4;function Vf(n){const e=$i(n),t=n.value,i=t.map(s=>Math.round(255*Hf(Math.min(Math.max(s,0),1)))).map(s=>s.toString(16).padStart(2,"0")).join("");return b("div",{class:e.class,children:[b("label",{for:e.id,title:n.info.doc,children:e.label}),b("span",{class:"colour",children:[b("input",{id:e.id,type:"color","aria-label":e.full,"aria-describedby":e.describedBy,value:`#${i}`,onChange:s=>{const r=s.currentTarget.value.slice(1).match(/../g)??[],a=o=>Number(Gf(parseInt(o,16)/255).toFixed(4));e.set(r.map(a))}}),b("span",{children:t.map(s=>s.toFixed(3)).join(" ")})]}),e.faultText]})}function hc(n){const e=$i(n),{value:t,info:i}=n,s=rt(t)?pn(t,["wavelengths_nm"]):void 0,r=rn(s)?`${String(s.length)} samples, ${ds(s[0])} to ${ds(s.at(-1))} nm`:typeof t=="string"?t:"as in the recipe";return b("div",{class:e.class,children:[b("span",{class:"label",title:i.doc,children:e.label}),b("span",{class:"plain",children:r}),i.kind==="spectrum"&&b("button",{type:"button",class:"small","aria-label":`One number in place of samples: ${e.full}`,onClick:()=>{e.set(Wf(t)),hs(`[data-key='${Qe(n.path)}'] input[type=text]`)},children:"One number"}),e.faultText]})}function Wf(n){const e=rt(n)?n.values:void 0,t=rn(e)?e.filter(s=>typeof s=="number"):[];if(t.length===0)return .5;const i=t.reduce((s,r)=>s+r,0)/t.length;return Number(i.toPrecision(4))}const Xf=new Set(["name","volume_fraction","mass_fraction","density_g_per_cm3","binder_density_g_per_cm3"]),lr=new Set(["coats"]),$f="core",fs="name";function qf(n,e){const t=Kr(n,e),i=e.keys.some(s=>s.choices==="pigments"&&s.key in n);return e.keys.filter(s=>!(s.key in n)&&!t.has(s.key)&&!gf(n,e,s)&&s.key!==fs&&s.choices!=="pigments"&&(!i||Xf.has(s.key)))}const hl=Xi(({path:n})=>{const e=ve(l=>l.schema),t=Yr(n),i=e===null?void 0:dn(e,n),s=Df(n);if(e===null||i===void 0||!rt(t))return null;const r=[],a=[],o=({key:l})=>l===$f;for(const l of[...i.keys.filter(c=>!o(c)),...i.keys.filter(o)]){const c=t[l.key],u=[...n,l.key];if(l.kind==="list")(rn(c)||n.length===0||Rh(n,l.key))&&dn(e,[...u,0])!==void 0&&(Kr(t,i).has(l.key)||a.push(b(Qf,{path:u},l.key)));else{if(c===void 0||l.key===fs)continue;l.kind==="table"?rt(c)&&dn(e,u)!==void 0&&a.push(b(Jf,{path:u,info:l},l.key)):r.push(b(Uf,{path:u,info:l,value:c},l.key))}}return b(Bt,{children:[b(ul,{id:`fault-${Qe(n)}`,text:s}),r,a]})});function Rh(n,e){return n.length===2&&n[0]==="layer"||e==="coats"}const Ch=Xi(({path:n})=>{const e=ve(r=>r.schema),t=lt();ve(({document:r})=>Yf(pn(r.recipe,n)));const i=pn(t.store.get().document.recipe,n),s=e===null?void 0:dn(e,n);return e===null||s===void 0||!rt(i)?null:b(Kf,{path:n,table:i,info:s,schema:e})});function Yf(n){return rt(n)?Object.keys(n).join(" "):""}function Kf(n){const{path:e,table:t,info:i,schema:s}=n,r=lt(),a=ve(({document:d})=>Mi(d.recipe,[...e,""])),o=d=>d.kind!=="table"||dn(s,[...e,d.key])!==void 0,l=d=>d.kind==="list"&&(e.length===0||Rh(e,d.key)),c=qf(t,i).filter(d=>o(d)&&!l(d)),u=new Set((i.alternatives??[]).filter(d=>d.required).flatMap(d=>d.each.map(m=>m.mark))),f=i.keys.filter(d=>d.key in t&&(!d.required||ic(t,i,d.key)!==void 0)&&!u.has(d.key)&&!(d.required_with!==void 0&&d.required_with in t)&&d.key!==fs&&d.kind!=="list"&&d.kind!=="table"&&d.choices!=="pigments"),h=Kr(t,i),_=i.keys.some(d=>d.choices==="pigments"&&d.key in t)?[]:(i.alternatives??[]).flatMap((d,m)=>d.each.flatMap(({mark:x},T)=>{const S=Si(t,d),E=d.each[S]?.mark??"";return T===S||x===""||E===""||h.has(E)?[]:x===us?[]:[{g:m,i:T,text:`${Gt(x).label} in place of ${Zf(E)}`}]}));if(c.length+f.length+_.length===0)return null;const y=d=>{const[m,x,T]=d.split(":");r.edit(S=>{const E=pn(S.recipe,e);if(m==="add"){const w=i.keys.find(L=>L.key===x);if(w===void 0)return S;const N=rt(E)?Mh(E,i,w):void 0;if(N===void 0||!rt(E)){const L=rt(E)?E:{},k=Sf(s,e,w,L);return en(S,[...e,w.key],k)}const C=or(s,e,E,N.group,N.to);return en(S,e,C)}if(m==="remove"){const w=rt(E)?ic(E,i,x??""):void 0;return w===void 0||!rt(E)?en(S,[...e,x??""],void 0):en(S,e,or(s,e,E,w,0))}const A=i.alternatives?.[Number(x)];if(A===void 0||!rt(E))return S;const p=or(s,e,E,A,Number(T));return en(S,e,p)})};return b("select",{class:"more","aria-label":`More of ${a===""?"the paint":a}`,"data-at":Qe(e),value:"",onChange:d=>{y(d.currentTarget.value),d.currentTarget.value=""},children:[b("option",{value:"",children:"More"}),c.length>0&&b("optgroup",{label:"Add",children:c.map(({key:d})=>b("option",{value:`add:${d}`,children:Gt(d).label},d))}),_.length>0&&b("optgroup",{label:"Say otherwise",children:_.map(({g:d,i:m,text:x})=>b("option",{value:`instead:${String(d)}:${String(m)}`,children:x},x))}),f.length>0&&b("optgroup",{label:"Leave out",children:f.map(({key:d})=>b("option",{value:`remove:${d}`,children:Gt(d).label},d))})]})}function Zf(n){return Gt(n).label.toLowerCase()}function Ph(n){const[e,t]=Un(!0);return b("section",{class:`part ${n.kind}`,"aria-label":n.label,"data-part":Qe(n.path),children:[b("header",{children:[b("button",{type:"button",class:"fold","aria-expanded":e,"aria-label":`${e?"Fold":"Unfold"} ${n.label}`,onClick:()=>{t(!e)},children:b(Eh,{name:e?"open":"closed"})}),b("h3",{children:n.title}),b("span",{class:"tools",children:[b(Ch,{path:n.path}),n.tools]})]}),e&&n.children]})}function Jf({path:n,info:e}){const t=lt(),{label:i}=Gt(e.key);return b(Ph,{path:n,kind:e.key,title:i,label:i,tools:!e.required&&b(di,{icon:"remove",label:`Remove ${i}`,onClick:()=>{t.edit(s=>en(s,n,void 0)),hs(`select.more[data-at='${Qe(n.slice(0,-1))}']`,".paint-name .name")}}),children:b(hl,{path:n})})}const Qf=Xi(({path:n})=>{const e=Yr(n),t=rn(e)?e:[],i=String(n.at(-1)),s=Af(t),r=[...t.keys()];lr.has(i)&&r.reverse();const a=b(ep,{path:n,at:t.length});return b("div",{class:`list ${i}`,"data-list":Qe(n),children:[lr.has(i)&&a,r.map(o=>b(tp,{path:n,i:o,count:t.length},s[o])),!lr.has(i)&&a]})});function Ls(n,e,t){return`[data-part='${Qe([...n,e])}'] > header .icon-button[data-icon='${t}']`}const dc="own coefficients",jf="New flakes",ep=Xi(({path:n,at:e})=>{const t=lt(),i=ve(l=>l.schema);if(i===null)return null;const s=String(n.at(-1)),r=ll(s),a=l=>{t.edit(c=>{const u=pn(c.recipe,[...n,e-1]),f=l??Mf(i,n,u);return vh(c,n,e,f)})},o=(l,c)=>b(Zr,{class:"add",label:s==="pigment"?"Add a pigment":"Add flakes",text:s==="pigment"?"+ Pigment":"+ Flakes",chosen:null,choices:l,onChoose:u=>{a(c(u))}});if(s==="pigment"){const l={name:dc,summary:"scattering and absorption",rgb:null};return o([...i.pigments,l],c=>c===dc?{scattering_per_mm:10,absorption_per_mm:10}:{from:c,volume_fraction:.05})}return s==="flakes"?o([{name:jf,summary:"TiO2 on mica, to begin with"},...i.flakes],c=>i.flakes.find(u=>u.name===c)?.value):b("button",{type:"button",class:"add",onClick:()=>{a()},children:["+ ",r.charAt(0).toUpperCase()+r.slice(1)]})}),tp=Xi(({path:n,i:e,count:t})=>{const i=lt(),s=ve(m=>m.schema),r=[...n,e],a=Yr(r),o=String(n.at(-1)),l=ll(o),c=o==="layer"&&t===1?"":` ${String(e+1)}`,u=`${l.charAt(0).toUpperCase()}${l.slice(1)}${c}`;if(!rt(a)||s===null)return null;const f=dn(s,r)?.keys.some(({key:m})=>m===fs)===!0,h=typeof a.name=="string"?a.name:"",g=h===""?u:`${u}, ${h}`,_=f?b("input",{type:"text",class:"name",value:h,placeholder:typeof a.from=="string"?a.from:u,"aria-label":`Name of ${u.toLowerCase()}`,onChange:m=>{const x=m.currentTarget.value;i.edit(T=>en(T,[...r,fs],x===""?void 0:x))}}):u,y=lr.has(o)?1:-1,d=(m,x)=>b(di,{icon:x,label:`Move ${g} ${x}`,disabled:e+m<0||e+m>=t,onClick:()=>{i.edit(S=>df(S,n,e,m));const T=x==="up"?"down":"up";hs(Ls(n,e+m,x),Ls(n,e+m,T))}});return b(Ph,{path:r,kind:o,title:_,label:g,tools:b(Bt,{children:[t>1&&d(y,"up"),t>1&&d(y===1?-1:1,"down"),b(di,{icon:"copy",label:`Duplicate ${g}`,onClick:()=>{i.edit(m=>vh(m,n,e+1,a))}}),b(di,{icon:"remove",label:`Remove ${g}`,onClick:()=>{i.edit(m=>hf(m,n,e)),hs(Ls(n,e,"remove"),Ls(n,e-1,"remove"),`[data-list='${Qe(n)}'] > .add`,`[data-list='${Qe(n)}'] > .add button`)}})]}),children:b(hl,{path:r})})});function np(){const n=lt(),e=ve(o=>o.document.recipe.name),t=ve(o=>o.fault),i=ve(o=>o.notOpened),s=ve(o=>o.paint?.warnings),r=i===null?t?.message:`Not opened: ${i}`;return b("section",{class:"composition","aria-label":"Composition",children:[b("div",{class:"paint-name",children:[b("input",{type:"text",class:"name","aria-label":"Name of the paint",placeholder:"Without a name",value:typeof e=="string"?e:"",onChange:o=>{const l=o.currentTarget.value;n.edit(c=>en(c,["name"],l===""?void 0:l))}}),b(Ch,{path:[]})]}),b("div",{class:"form",children:b(hl,{path:[]})}),b("div",{class:"said-place",children:b("div",{class:r===void 0?"said":"said wrong",role:"status","aria-label":"What the server says of the recipe",children:(r===void 0?s??[]:[r]).map(o=>b("p",{children:o},o))})})]})}const Lh=[{of:({out_of_gamut:n})=>n,mark:"!",name:"outside sRGB",means:"outside sRGB, clipped"},{of:({too_bright:n})=>n,mark:"↑",name:"too bright",means:"too bright: brighter than white, dimmed"}];function ip(n,e){return Lh.filter(({of:t})=>t(n)[e]===!0)}function sp(n){return Lh.map(({of:e,name:t})=>({count:e(n).filter(Boolean).length,name:t})).filter(({count:e})=>e>0).map(({count:e,name:t})=>`${String(e)} ${t}`).join(", ")}const os=180/Math.PI,rp=1.05,ap=1.02;function Dh(n){const{position_mm:e,target_mm:t,fov_deg:i,aspect:s}=n.camera,[r,a,o]=[0,1,2].map(u=>e[u]-t[u]),l=Math.hypot(r,a,o),c=Math.atan(s/rp*Math.tan(i/2/os));return{azimuth_deg:Math.atan2(a,r)*os,elevation_deg:Math.asin(o/l)*os,distance_mm:l,fov_deg:i,aspect:s,nearest_mm:ap*l*Math.sin(c)}}function Nh(n,e,t){const{azimuth_deg:i,elevation_deg:s,distance_mm:r,fov_deg:a,aspect:o}=n,l=Math.max(1,o*t/e),c=Math.tan(a/2/os),u=2*os*Math.atan(c*l);return{azimuth_deg:i,elevation_deg:s,distance_mm:r,fov_deg:u}}const fc=(n,e,t)=>Math.min(Math.max(n,e),t);function op(n,e,t=1){return{...n,elevation_deg:fc(n.elevation_deg+e,-85,85),distance_mm:fc(n.distance_mm/t,n.nearest_mm,1e5)}}function pc(n){const e=(n%360+360)%360;return e>180?e-360:e}function Jr(n){return n instanceof Error?n.message:String(n)}function wr(n,e,t){const i=URL.createObjectURL(new Blob([e],{type:t})),s=document.createElement("a");s.href=i,s.download=n,s.click(),setTimeout(()=>{URL.revokeObjectURL(i)},1e4)}const Ih=80,mc=6e6,gc=8e6;function Tr(n,e,t){if(e<=mc)return null;const[i,s]=[e,mc].map(r=>(r/1e6).toFixed(1));return`${n} has ${i??""} MB; at most ${s??""} MB can be ${t}.`}function _c(n,e){const t=new Blob([e]).size,i=Tr(n,t,"read");if(i!==null)return i;const s=new Blob([JSON.stringify(e)]).size;return s<=gc?null:`${n} has ${(s/1e6).toFixed(1)} MB as JSON; at most ${(gc/1e6).toFixed(1)} MB can be read.`}function Ar(n,e){const i=(typeof n=="string"?n.toLowerCase().replace(/[^\p{L}\p{N}]+/gu,"-"):"").replace(/^-+|-+$/g,"").slice(0,80);return`${i===""?"paint":i}.${e}`}function lp(n){return new Promise((e,t)=>{const i=new FileReader;i.onload=()=>{const s=i.result;e(s.slice(s.indexOf(",")+1))},i.onerror=()=>{t(new Error("the browser could not read it"))},i.readAsDataURL(n)})}function cp(n){document.querySelector("iframe.print")?.remove();const e=document.createElement("iframe");e.className="print",e.title="Report",e.addEventListener("load",()=>{e.contentWindow?.focus(),e.contentWindow?.print()}),e.srcdoc=n,document.body.append(e)}function up(n){return new Promise((e,t)=>{n.toBlob(i=>{i===null?t(new Error("the browser could not write a PNG")):e(i)},"image/png")})}function hp({uniforms:n}){return Object.fromEntries(n.map(({name:e,components:t,array:i,values:s})=>[e,t===1&&!i?s[0]:Float32Array.from(s)]))}function dp(n,e,t){const i=String(n.program);typeof n.glsl=="string"&&t.set(i,n.glsl);const s=t.get(i);if(s===void 0)throw new Error(`shader ${i}: its text did not come`);return{program:i,glsl:s,smoothCoat:n.smooth_coat===!0,flakes:s.includes("#define NACRE_FLAKES "),films:!1,...Uh(n,e)}}function fp(n,e){return n.type!=="films"?{uniforms:[],textures:[]}:Uh(n,e)}function pp(n,e){const t=new Set([...e.uniforms,...e.textures].map(({name:s})=>s)),i=s=>s.filter(({name:r})=>!t.has(r));return{...n,films:!0,uniforms:[...i(n.uniforms),...e.uniforms],textures:[...i(n.textures),...e.textures]}}function Uh(n,e){return{uniforms:n.uniforms,textures:e.map(({name:t,shape:i,data:s})=>({name:t,size:i.slice(0,-1).reverse(),data:new Uint16Array(s.buffer,s.byteOffset,s.byteLength/2)}))}}function Fh(n){const[e,t]=new Uint32Array(n,0,2),i=8;return{positions:new Float32Array(n,i,3*e),normals:new Float32Array(n,i+12*e,3*e),indices:new Uint32Array(n,i+32*e,3*t)}}function Oh(n){const[e]=new Uint32Array(n,0,1),t=new TextDecoder().decode(new Uint8Array(n,4,e)),i=JSON.parse(t),[s,r]=new Uint32Array(n,4+e,2),a=new Float32Array(n,12+e,3*s*r);return{...i,width:s,height:r,rgb:a}}const dl=".obj,.ply,.stl,.glb,.gltf",fl=".hdr,.exr",vc=n=>new RegExp(`(${n.replace(/\./g,"\\.").replace(/,/g,"|")})$`,"i"),[mp,gp]=[vc(dl),vc(fl)];function _p(n){return mp.test(n)?"shape":gp.test(n)?"light":null}class vp{constructor(e,t,i){this.store=e,this.viewer=t,this.connection=i}bringAgain(){const{ownShape:e,ownLight:t}=this.store.get();e!==null&&this.bring("shape",e.file,e.yUp),t!==null&&this.bring("light",t.file)}abandon(){for(const e of["shape","light"])this.viewer.hold(e,!1)}async bring(e,t,i=!1){const{ownShape:s,ownLight:r}=this.store.get(),a=e==="shape"?s:r,o=Tr(t.name,t.size,"shown");if(o!==null){this.say(o);return}this.say(`Reading ${t.name} …`),this.viewer.hold(e,!0);try{const l=await lp(t),c={file:t.name.slice(-Ih),base64:l};if(this.connection.ask(e,e==="shape"?{...c,y_up:i}:c,(f,h)=>{this.viewer.hold(e,!1),f.type==="error"?this.say(String(f.message)):this.brought({file:t,yUp:i,name:""},a,f,h)},void 0,()=>{this.say(`${t.name}: the server went away before it was read.`)}))return;this.say(`${t.name}: there is no server to read it.`)}catch(l){this.say(`${t.name}: ${Jr(l)}`)}this.viewer.hold(e,!1)}brought(e,t,i,s){const{schema:r}=this.store.get(),a=s[0]?.data;if(r===null||a===void 0)return;this.store.set({notOpened:null});const o=a.buffer,l=this.viewer.store.get().view,c=t?.file===e.file;if(i.type==="shape"){const u=i.shape,f=[...r.shapes.filter(({name:d})=>d!==t?.name),u],h={...r,shapes:f};this.store.set({schema:h,ownShape:{...e,name:u.name}}),this.viewer.add(h,{mesh:Fh(o)},u.name),(!c||l?.shape===t.name)&&this.viewer.setShape(h,u.name,!1);const[g,_]=[i.extent_mm,i.shown_mm].map(d=>Number(Number(d).toPrecision(3))),y=`${String(g)} mm${g===_?"":`, shown as ${String(_)} mm`}`;this.say(`${e.file.name}: ${String(i.triangles)} triangles, ${y}.`)}else{const u=i.light,f=[...r.lights.filter(({name:_})=>_!==t?.name),u],h={...r,lights:f};this.store.set({schema:h,ownLight:{...e,name:u.name}}),this.viewer.add(h,{light:Oh(o)},u.name),(!c||l?.light===t.name)&&this.viewer.setView({light:u.name});const g=`${String(i.width)} x ${String(i.height)} pixels`;this.say(`${e.file.name}: ${g}, a white panel that lies flat is white. ${String(i.note)}`)}}say(e){this.store.set({notice:e})}}function kh({readingsOf:n,document:e,readingsBy:t,settings:i}){return n===e&&t===i}function Ms({fault:n,readingsOf:e,document:t}){return n!==null&&e!==t}const xc={said:new Map,starts:4},Sc={key:null,ends:new Map},ls={running:!1,fraction:0,matches:null,colours:[],fault:null,skipped:[],began:null,model:""};const pl="187",xp=0,Mc=1,Sp=2,cr=1,Mp=2,ns=3,gi=0,Vt=1,Sn=2,fi=0,cs=1,yc=2,Ec=3,bc=4,Bh=5,Fi=100,yp=101,Ep=102,bp=103,wp=104,Tp=200,no=201,Ap=202,Rp=203,zh=204,Hh=205,Cp=206,Pp=207,Lp=208,Dp=209,Np=210,Ip=211,Up=212,Fp=213,Op=214,io=0,so=1,Rr=2,ps=3,ro=4,ao=5,oo=6,lo=7,Gh=0,kp=1,Bp=2,Fn=0,Vh=1,Wh=2,Xh=3,$h=4,qh=5,Yh=6,Kh=7,Zh=300,zi=301,ms=302,fa=303,pa=304,Cr=1e3,Mn=1001,co=1002,vt=1003,zp=1004,Ds=1005,Pt=1006,ma=1007,Jn=1008,tn=1009,Jh=1010,Qh=1011,gs=1012,ml=1013,bn=1014,Ot=1015,Wt=1016,gl=1017,_l=1018,Hi=1020,jh=35902,ed=35899,td=1021,nd=1022,nn=1023,ni=1026,Qn=1027,Qr=1028,vl=1029,_i=1030,xl=1031,Sl=1033,ur=33776,hr=33777,dr=33778,fr=33779,uo=35840,ho=35841,fo=35842,po=35843,mo=36196,go=37492,_o=37496,vo=37488,xo=37489,Pr=37490,So=37491,Mo=37808,yo=37809,Eo=37810,bo=37811,wo=37812,To=37813,Ao=37814,Ro=37815,Co=37816,Po=37817,Lo=37818,Do=37819,No=37820,Io=37821,Uo=36492,Fo=36494,Oo=36495,ko=36283,Bo=36284,Lr=36285,zo=36286,Hp=3200,wc=0,Gp=1,Zn="",jt="srgb",_s="srgb-linear",Dr="linear",Je="srgb",ga=7680,Vp=519,Wp=512,Xp=513,$p=514,id=515,qp=516,Yp=517,sd=518,rd=519,Kp=35044,Ho="300 es",hn=2e3,Nr=2001;function Zp(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Ir(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Jp(){const n=Ir("canvas");return n.style.display="block",n}const Tc={};function Ac(...n){const e="THREE."+n.shift();console.log(e,...n)}function ad(n){const e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){const t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Pe(...n){n=ad(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function qe(...n){n=ad(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function pr(...n){const e=n.join(" ");e in Tc||(Tc[e]=!0,Pe(...n))}function Qp(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}const jp={[io]:io,[Rr]:oo,[ro]:ro,[ps]:ao,[so]:so,[oo]:Rr,[lo]:lo,[ao]:ps};class yi{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){const i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){const i=this._listeners;if(i===void 0)return;const s=i[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const i=t[e.type];if(i!==void 0){e.target=this;const s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}}const Nt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],_a=Math.PI/180,Go=180/Math.PI;function ys(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Nt[n&255]+Nt[n>>8&255]+Nt[n>>16&255]+Nt[n>>24&255]+"-"+Nt[e&255]+Nt[e>>8&255]+"-"+Nt[e>>16&15|64]+Nt[e>>24&255]+"-"+Nt[t&63|128]+Nt[t>>8&255]+"-"+Nt[t>>16&255]+Nt[t>>24&255]+Nt[i&255]+Nt[i>>8&255]+Nt[i>>16&255]+Nt[i>>24&255]).toLowerCase()}function Ge(n,e,t){return Math.max(e,Math.min(t,n))}function em(n,e){return(n%e+e)%e}function va(n,e,t){return(1-t)*n+t*e}function tm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ml(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function nm(n,e){if(e.constructor===Float32Array)return n;const t=Ml(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function im(n,e){if(e.constructor===Float32Array)return n;const t=Ml(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}const Ll=class Ll{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Ge(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Ge(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*i-a*s+e.x,this.y=r*s+a*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};Ll.prototype.isVector2=!0;let Xe=Ll;class qi{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,a,o){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[a+0],g=r[a+1],_=r[a+2],y=r[a+3];if(f!==y||l!==h||c!==g||u!==_){let d=l*h+c*g+u*_+f*y;d<0&&(h=-h,g=-g,_=-_,y=-y,d=-d);let m=1-o;if(d<.9995){const x=Math.acos(d),T=Math.sin(x);m=Math.sin(m*x)/T,o=Math.sin(o*x)/T,l=l*m+h*o,c=c*m+g*o,u=u*m+_*o,f=f*m+y*o}else{l=l*m+h*o,c=c*m+g*o,u=u*m+_*o,f=f*m+y*o;const x=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=x,c*=x,u*=x,f*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,a){const o=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[a],h=r[a+1],g=r[a+2],_=r[a+3];return e[t]=o*_+u*f+l*g-c*h,e[t+1]=l*_+u*h+c*f-o*g,e[t+2]=c*_+u*g+o*h-l*f,e[t+3]=u*_-o*f-l*h-c*g,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(i/2),u=o(s/2),f=o(r/2),h=l(i/2),g=l(s/2),_=l(r/2);switch(a){case"XYZ":this._x=h*u*f+c*g*_,this._y=c*g*f-h*u*_,this._z=c*u*_+h*g*f,this._w=c*u*f-h*g*_;break;case"YXZ":this._x=h*u*f+c*g*_,this._y=c*g*f-h*u*_,this._z=c*u*_-h*g*f,this._w=c*u*f+h*g*_;break;case"ZXY":this._x=h*u*f-c*g*_,this._y=c*g*f+h*u*_,this._z=c*u*_+h*g*f,this._w=c*u*f-h*g*_;break;case"ZYX":this._x=h*u*f-c*g*_,this._y=c*g*f+h*u*_,this._z=c*u*_-h*g*f,this._w=c*u*f+h*g*_;break;case"YZX":this._x=h*u*f+c*g*_,this._y=c*g*f+h*u*_,this._z=c*u*_-h*g*f,this._w=c*u*f-h*g*_;break;case"XZY":this._x=h*u*f-c*g*_,this._y=c*g*f-h*u*_,this._z=c*u*_+h*g*f,this._w=c*u*f+h*g*_;break;default:Pe("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+o+f;if(h>0){const g=.5/Math.sqrt(h+1);this._w=.25/g,this._x=(u-l)*g,this._y=(r-c)*g,this._z=(a-s)*g}else if(i>o&&i>f){const g=2*Math.sqrt(1+i-o-f);this._w=(u-l)/g,this._x=.25*g,this._y=(s+a)/g,this._z=(r+c)/g}else if(o>f){const g=2*Math.sqrt(1+o-i-f);this._w=(r-c)/g,this._x=(s+a)/g,this._y=.25*g,this._z=(l+u)/g}else{const g=2*Math.sqrt(1+f-i-o);this._w=(a-s)/g,this._x=(r+c)/g,this._y=(l+u)/g,this._z=.25*g}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ge(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+a*o+s*c-r*l,this._y=s*u+a*l+r*o-i*c,this._z=r*u+a*c+i*l-s*o,this._w=a*u-i*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(i=-i,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){const c=Math.acos(o),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}const Dl=class Dl{constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Rc.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Rc.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(e){const t=this.x,i=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*i),u=2*(o*t-r*s),f=2*(r*i-a*t);return this.x=t+l*c+a*f-o*u,this.y=i+l*u+o*c-r*f,this.z=s+l*f+r*u-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Ge(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-i*l,this.z=i*o-s*a,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return xa.copy(this).projectOnVector(e),this.sub(xa)}reflect(e){return this.sub(xa.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Ge(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};Dl.prototype.isVector3=!0;let W=Dl;const xa=new W,Rc=new qi,Nl=class Nl{constructor(e,t,i,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c)}set(e,t,i,s,r,a,o,l,c){const u=this.elements;return u[0]=e,u[1]=s,u[2]=o,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=a,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],g=i[5],_=i[8],y=s[0],d=s[3],m=s[6],x=s[1],T=s[4],S=s[7],E=s[2],A=s[5],p=s[8];return r[0]=a*y+o*x+l*E,r[3]=a*d+o*T+l*A,r[6]=a*m+o*S+l*p,r[1]=c*y+u*x+f*E,r[4]=c*d+u*T+f*A,r[7]=c*m+u*S+f*p,r[2]=h*y+g*x+_*E,r[5]=h*d+g*T+_*A,r[8]=h*m+g*S+_*p,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8];return t*a*u-t*o*c-i*r*u+i*o*l+s*r*c-s*a*l}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],f=u*a-o*c,h=o*l-u*r,g=c*r-a*l,_=t*f+i*h+s*g;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const y=1/_;return e[0]=f*y,e[1]=(s*c-u*i)*y,e[2]=(o*i-s*a)*y,e[3]=h*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-o*t)*y,e[6]=g*y,e[7]=(i*l-c*t)*y,e[8]=(a*t-i*r)*y,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,a,o){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return pr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Sa.makeScale(e,t)),this}rotate(e){return pr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Sa.makeRotation(-e)),this}translate(e,t){return pr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Sa.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}};Nl.prototype.isMatrix3=!0;let De=Nl;const Sa=new De,Cc=new De().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Pc=new De().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function sm(){const n={enabled:!0,workingColorSpace:_s,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Je&&(s.r=On(s.r),s.g=On(s.g),s.b=On(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Je&&(s.r=ki(s.r),s.g=ki(s.g),s.b=ki(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Zn?Dr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[_s]:{primaries:e,whitePoint:i,transfer:Dr,toXYZ:Cc,fromXYZ:Pc,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:jt},outputColorSpaceConfig:{drawingBufferColorSpace:jt}},[jt]:{primaries:e,whitePoint:i,transfer:Je,toXYZ:Cc,fromXYZ:Pc,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:jt}}}),n}const Ve=sm();function On(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ki(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}let Ei;class rm{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Ei===void 0&&(Ei=Ir("canvas")),Ei.width=e.width,Ei.height=e.height;const s=Ei.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Ei}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=Ir("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=On(r[a]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(On(t[i]/255)*255):t[i]=On(t[i]);return{data:t,width:e.width,height:e.height}}else return Pe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let am=0;class yl{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:am++}),this.uuid=ys(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Ma(s[a].image)):r.push(Ma(s[a]))}else r=Ma(s);i.url=r}return t||(e.images[this.uuid]=i),i}}function Ma(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?rm.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Pe("Texture: Unable to serialize Texture."),{})}let om=0;const ya=new W;class kt extends yi{constructor(e=kt.DEFAULT_IMAGE,t=kt.DEFAULT_MAPPING,i=Mn,s=Mn,r=Pt,a=Jn,o=nn,l=tn,c=kt.DEFAULT_ANISOTROPY,u=Zn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:om++}),this.uuid=ys(),this.name="",this.source=new yl(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Xe(0,0),this.repeat=new Xe(1,1),this.center=new Xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new De,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ya).x}get height(){return this.source.getSize(ya).y}get depth(){return this.source.getSize(ya).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const i=e[t];if(i===void 0){Pe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){Pe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Zh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Cr:e.x=e.x-Math.floor(e.x);break;case Mn:e.x=e.x<0?0:1;break;case co:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Cr:e.y=e.y-Math.floor(e.y);break;case Mn:e.y=e.y<0?0:1;break;case co:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}kt.DEFAULT_IMAGE=null;kt.DEFAULT_MAPPING=Zh;kt.DEFAULT_ANISOTROPY=1;const Il=class Il{constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*i+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r;const l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],g=l[5],_=l[9],y=l[2],d=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-y)<.01&&Math.abs(_-d)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+y)<.1&&Math.abs(_+d)<.1&&Math.abs(c+g+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const T=(c+1)/2,S=(g+1)/2,E=(m+1)/2,A=(u+h)/4,p=(f+y)/4,w=(_+d)/4;return T>S&&T>E?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=p/i):S>E?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=w/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=p/r,s=w/r),this.set(i,s,r,t),this}let x=Math.sqrt((d-_)*(d-_)+(f-y)*(f-y)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(d-_)/x,this.y=(f-y)/x,this.z=(h-u)/x,this.w=Math.acos((c+g+m-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this.w=Ge(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this.w=Ge(this.w,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Ge(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};Il.prototype.isVector4=!0;let ht=Il;class lm extends yi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Pt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new ht(0,0,e,t),this.scissorTest=!1,this.viewport=new ht(0,0,e,t),this.textures=[];const s=i.count;for(let r=0;r<s;r++)this.textures[r]=new kt({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){const t={minFilter:Pt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const s=Object.assign({},e.textures[t].image);this.textures[t].source=new yl(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){const t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}}class fn extends lm{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class od extends kt{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=vt,this.minFilter=vt,this.wrapR=Mn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class Vo extends kt{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=vt,this.minFilter=vt,this.wrapR=Mn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}}const Vr=class Vr{constructor(e,t,i,s,r,a,o,l,c,u,f,h,g,_,y,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c,u,f,h,g,_,y,d)}set(e,t,i,s,r,a,o,l,c,u,f,h,g,_,y,d){const m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=a,m[9]=o,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=g,m[7]=_,m[11]=y,m[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Vr().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();const t=this.elements,i=e.elements,s=1/bi.setFromMatrixColumn(e,0).length(),r=1/bi.setFromMatrixColumn(e,1).length(),a=1/bi.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*a,t[9]=i[9]*a,t[10]=i[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,s=e.y,r=e.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){const h=a*u,g=a*f,_=o*u,y=o*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=g+_*c,t[5]=h-y*c,t[9]=-o*l,t[2]=y-h*c,t[6]=_+g*c,t[10]=a*l}else if(e.order==="YXZ"){const h=l*u,g=l*f,_=c*u,y=c*f;t[0]=h+y*o,t[4]=_*o-g,t[8]=a*c,t[1]=a*f,t[5]=a*u,t[9]=-o,t[2]=g*o-_,t[6]=y+h*o,t[10]=a*l}else if(e.order==="ZXY"){const h=l*u,g=l*f,_=c*u,y=c*f;t[0]=h-y*o,t[4]=-a*f,t[8]=_+g*o,t[1]=g+_*o,t[5]=a*u,t[9]=y-h*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){const h=a*u,g=a*f,_=o*u,y=o*f;t[0]=l*u,t[4]=_*c-g,t[8]=h*c+y,t[1]=l*f,t[5]=y*c+h,t[9]=g*c-_,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){const h=a*l,g=a*c,_=o*l,y=o*c;t[0]=l*u,t[4]=y-h*f,t[8]=_*f+g,t[1]=f,t[5]=a*u,t[9]=-o*u,t[2]=-c*u,t[6]=g*f+_,t[10]=h-y*f}else if(e.order==="XZY"){const h=a*l,g=a*c,_=o*l,y=o*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+y,t[5]=a*u,t[9]=g*f-_,t[2]=_*f-g,t[6]=o*u,t[10]=y*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(cm,e,um)}lookAt(e,t,i){const s=this.elements;return Xt.subVectors(e,t),Xt.lengthSq()===0&&(Xt.z=1),Xt.normalize(),Gn.crossVectors(i,Xt),Gn.lengthSq()===0&&(Math.abs(i.z)===1?Xt.x+=1e-4:Xt.z+=1e-4,Xt.normalize(),Gn.crossVectors(i,Xt)),Gn.normalize(),Ns.crossVectors(Xt,Gn),s[0]=Gn.x,s[4]=Ns.x,s[8]=Xt.x,s[1]=Gn.y,s[5]=Ns.y,s[9]=Xt.y,s[2]=Gn.z,s[6]=Ns.z,s[10]=Xt.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],g=i[13],_=i[2],y=i[6],d=i[10],m=i[14],x=i[3],T=i[7],S=i[11],E=i[15],A=s[0],p=s[4],w=s[8],N=s[12],C=s[1],L=s[5],k=s[9],X=s[13],I=s[2],V=s[6],Q=s[10],z=s[14],q=s[3],G=s[7],j=s[11],te=s[15];return r[0]=a*A+o*C+l*I+c*q,r[4]=a*p+o*L+l*V+c*G,r[8]=a*w+o*k+l*Q+c*j,r[12]=a*N+o*X+l*z+c*te,r[1]=u*A+f*C+h*I+g*q,r[5]=u*p+f*L+h*V+g*G,r[9]=u*w+f*k+h*Q+g*j,r[13]=u*N+f*X+h*z+g*te,r[2]=_*A+y*C+d*I+m*q,r[6]=_*p+y*L+d*V+m*G,r[10]=_*w+y*k+d*Q+m*j,r[14]=_*N+y*X+d*z+m*te,r[3]=x*A+T*C+S*I+E*q,r[7]=x*p+T*L+S*V+E*G,r[11]=x*w+T*k+S*Q+E*j,r[15]=x*N+T*X+S*z+E*te,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],g=e[14],_=e[3],y=e[7],d=e[11],m=e[15],x=l*g-c*h,T=o*g-c*f,S=o*h-l*f,E=a*g-c*u,A=a*h-l*u,p=a*f-o*u;return t*(y*x-d*T+m*S)-i*(_*x-d*E+m*A)+s*(_*T-y*E+m*p)-r*(_*S-y*A+d*p)}determinantAffine(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],u=e[10];return t*(a*u-o*c)-i*(r*u-o*l)+s*(r*c-a*l)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],g=e[11],_=e[12],y=e[13],d=e[14],m=e[15],x=t*o-i*a,T=t*l-s*a,S=t*c-r*a,E=i*l-s*o,A=i*c-r*o,p=s*c-r*l,w=u*y-f*_,N=u*d-h*_,C=u*m-g*_,L=f*d-h*y,k=f*m-g*y,X=h*m-g*d,I=x*X-T*k+S*L+E*C-A*N+p*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const V=1/I;return e[0]=(o*X-l*k+c*L)*V,e[1]=(s*k-i*X-r*L)*V,e[2]=(y*p-d*A+m*E)*V,e[3]=(h*A-f*p-g*E)*V,e[4]=(l*C-a*X-c*N)*V,e[5]=(t*X-s*C+r*N)*V,e[6]=(d*S-_*p-m*T)*V,e[7]=(u*p-h*S+g*T)*V,e[8]=(a*k-o*C+c*w)*V,e[9]=(i*C-t*k-r*w)*V,e[10]=(_*A-y*S+m*x)*V,e[11]=(f*S-u*A-g*x)*V,e[12]=(o*N-a*L-l*w)*V,e[13]=(t*L-i*N+s*w)*V,e[14]=(y*T-_*E-d*x)*V,e[15]=(u*E-f*T+h*x)*V,this}scale(e){const t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),s=Math.sin(t),r=1-i,a=e.x,o=e.y,l=e.z,c=r*a,u=r*o;return this.set(c*a+i,c*o-s*l,c*l+s*o,0,c*o+s*l,u*o+i,u*l-s*a,0,c*l-s*o,u*l+s*a,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,a){return this.set(1,i,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){const s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,u=a+a,f=o+o,h=r*c,g=r*u,_=r*f,y=a*u,d=a*f,m=o*f,x=l*c,T=l*u,S=l*f,E=i.x,A=i.y,p=i.z;return s[0]=(1-(y+m))*E,s[1]=(g+S)*E,s[2]=(_-T)*E,s[3]=0,s[4]=(g-S)*A,s[5]=(1-(h+m))*A,s[6]=(d+x)*A,s[7]=0,s[8]=(_+T)*p,s[9]=(d-x)*p,s[10]=(1-(h+y))*p,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){const s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];const r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let a=bi.set(s[0],s[1],s[2]).length();const o=bi.set(s[4],s[5],s[6]).length(),l=bi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),on.copy(this);const c=1/a,u=1/o,f=1/l;return on.elements[0]*=c,on.elements[1]*=c,on.elements[2]*=c,on.elements[4]*=u,on.elements[5]*=u,on.elements[6]*=u,on.elements[8]*=f,on.elements[9]*=f,on.elements[10]*=f,t.setFromRotationMatrix(on),i.x=a,i.y=o,i.z=l,this}makePerspective(e,t,i,s,r,a,o=hn,l=!1){const c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),g=(i+s)/(i-s);let _,y;if(l)_=r/(a-r),y=a*r/(a-r);else if(o===hn)_=-(a+r)/(a-r),y=-2*a*r/(a-r);else if(o===Nr)_=-a/(a-r),y=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=g,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,a,o=hn,l=!1){const c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),g=-(i+s)/(i-s);let _,y;if(l)_=1/(a-r),y=a/(a-r);else if(o===hn)_=-2/(a-r),y=-(a+r)/(a-r);else if(o===Nr)_=-1/(a-r),y=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=g,c[2]=0,c[6]=0,c[10]=_,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}};Vr.prototype.isMatrix4=!0;let ft=Vr;const bi=new W,on=new ft,cm=new W(0,0,0),um=new W(1,1,1),Gn=new W,Ns=new W,Xt=new W,Lc=new ft,Dc=new qi;class vi{constructor(e=0,t=0,i=0,s=vi.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],g=s[10];switch(t){case"XYZ":this._y=Math.asin(Ge(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-u,g),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ge(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(o,g),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ge(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,g),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ge(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,g),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(Ge(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,g));break;case"XZY":this._z=Math.asin(-Ge(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-u,g),this._y=0);break;default:Pe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Lc.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Lc,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Dc.setFromEuler(this),this.setFromQuaternion(Dc,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}vi.DEFAULT_ORDER="XYZ";class ld{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let hm=0;const Nc=new W,wi=new qi,Tn=new ft,Is=new W,Ji=new W,dm=new W,fm=new qi,Ic=new W(1,0,0),Uc=new W(0,1,0),Fc=new W(0,0,1),Oc={type:"added"},pm={type:"removed"},Ti={type:"childadded",child:null},Ea={type:"childremoved",child:null};class qt extends yi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:hm++}),this.uuid=ys(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=qt.DEFAULT_UP.clone();const e=new W,t=new vi,i=new qi,s=new W(1,1,1);function r(){i.setFromEuler(t,!1)}function a(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ft},normalMatrix:{value:new De}}),this.matrix=new ft,this.matrixWorld=new ft,this.matrixAutoUpdate=qt.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ld,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return wi.setFromAxisAngle(e,t),this.quaternion.multiply(wi),this}rotateOnWorldAxis(e,t){return wi.setFromAxisAngle(e,t),this.quaternion.premultiply(wi),this}rotateX(e){return this.rotateOnAxis(Ic,e)}rotateY(e){return this.rotateOnAxis(Uc,e)}rotateZ(e){return this.rotateOnAxis(Fc,e)}translateOnAxis(e,t){return Nc.copy(e).applyQuaternion(this.quaternion),this.position.add(Nc.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Ic,e)}translateY(e){return this.translateOnAxis(Uc,e)}translateZ(e){return this.translateOnAxis(Fc,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Tn.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Is.copy(e):Is.set(e,t,i);const s=this.parent;this.updateWorldMatrix(!0,!1),Ji.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Tn.lookAt(Ji,Is,this.up):Tn.lookAt(Is,Ji,this.up),this.quaternion.setFromRotationMatrix(Tn),s&&(Tn.extractRotation(s.matrixWorld),wi.setFromRotationMatrix(Tn),this.quaternion.premultiply(wi.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Oc),Ti.child=e,this.dispatchEvent(Ti),Ti.child=null):qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(pm),Ea.child=e,this.dispatchEvent(Ea),Ea.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Tn.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Tn.multiply(e.parent.matrixWorld)),e.applyMatrix4(Tn),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Oc),Ti.child=e,this.dispatchEvent(Ti),Ti.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){const a=this.children[i].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ji,e,dm),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ji,fm,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const e=this.pivot;if(e!==null){const t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){const s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){const r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,i)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const l=o.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){const l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){const o=a(e.geometries),l=a(e.materials),c=a(e.textures),u=a(e.images),f=a(e.shapes),h=a(e.skeletons),g=a(e.animations),_=a(e.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),g.length>0&&(i.animations=g),_.length>0&&(i.nodes=_)}return i.object=s,i;function a(o){const l=[];for(const c in o){const u=o[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}}qt.DEFAULT_UP=new W(0,1,0);qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class Us extends qt{constructor(){super(),this.isGroup=!0,this.type="Group"}}const mm={type:"move"};class ba{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Us,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Us,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Us,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,a=null;const o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(const y of e.hand.values()){const d=t.getJointPose(y,i),m=this._getHandJoint(c,y);d!==null&&(m.matrix.fromArray(d.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=d.radius),m.visible=d!==null}const u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),g=.02,_=.005;c.inputState.pinching&&h>g+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=g-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(mm)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new Us;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}const cd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vn={h:0,s:0,l:0},Fs={h:0,s:0,l:0};function wa(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Ye{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=jt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ve.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Ve.workingColorSpace){return this.r=e,this.g=t,this.b=i,Ve.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Ve.workingColorSpace){if(e=em(e,1),t=Ge(t,0,1),i=Ge(i,0,1),t===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+t):i+t-i*t,a=2*i-r;this.r=wa(a,r,e+1/3),this.g=wa(a,r,e),this.b=wa(a,r,e-1/3)}return Ve.colorSpaceToWorking(this,s),this}setStyle(e,t=jt){function i(r){r!==void 0&&parseFloat(r)<1&&Pe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Pe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Pe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=jt){const i=cd[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Pe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=On(e.r),this.g=On(e.g),this.b=On(e.b),this}copyLinearToSRGB(e){return this.r=ki(e.r),this.g=ki(e.g),this.b=ki(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=jt){return Ve.workingToColorSpace(It.copy(this),e),Math.round(Ge(It.r*255,0,255))*65536+Math.round(Ge(It.g*255,0,255))*256+Math.round(Ge(It.b*255,0,255))}getHexString(e=jt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ve.workingColorSpace){Ve.workingToColorSpace(It.copy(this),t);const i=It.r,s=It.g,r=It.b,a=Math.max(i,s,r),o=Math.min(i,s,r);let l,c;const u=(o+a)/2;if(o===a)l=0,c=0;else{const f=a-o;switch(c=u<=.5?f/(a+o):f/(2-a-o),a){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Ve.workingColorSpace){return Ve.workingToColorSpace(It.copy(this),t),e.r=It.r,e.g=It.g,e.b=It.b,e}getStyle(e=jt){Ve.workingToColorSpace(It.copy(this),e);const t=It.r,i=It.g,s=It.b;return e!==jt?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Vn),this.setHSL(Vn.h+e,Vn.s+t,Vn.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Vn),e.getHSL(Fs);const i=va(Vn.h,Fs.h,t),s=va(Vn.s,Fs.s,t),r=va(Vn.l,Fs.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const It=new Ye;Ye.NAMES=cd;class gm extends qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new vi,this.environmentIntensity=1,this.environmentRotation=new vi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}}const ln=new W,An=new W,Ta=new W,Rn=new W,Ai=new W,Ri=new W,kc=new W,Aa=new W,Ra=new W,Ca=new W,Pa=new ht,La=new ht,Da=new ht;class un{constructor(e=new W,t=new W,i=new W){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),ln.subVectors(e,t),s.cross(ln);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){ln.subVectors(s,t),An.subVectors(i,t),Ta.subVectors(e,t);const a=ln.dot(ln),o=ln.dot(An),l=ln.dot(Ta),c=An.dot(An),u=An.dot(Ta),f=a*c-o*o;if(f===0)return r.set(0,0,0),null;const h=1/f,g=(c*l-o*u)*h,_=(a*u-o*l)*h;return r.set(1-g-_,_,g)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Rn)===null?!1:Rn.x>=0&&Rn.y>=0&&Rn.x+Rn.y<=1}static getInterpolation(e,t,i,s,r,a,o,l){return this.getBarycoord(e,t,i,s,Rn)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Rn.x),l.addScaledVector(a,Rn.y),l.addScaledVector(o,Rn.z),l)}static getInterpolatedAttribute(e,t,i,s,r,a){return Pa.setScalar(0),La.setScalar(0),Da.setScalar(0),Pa.fromBufferAttribute(e,t),La.fromBufferAttribute(e,i),Da.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Pa,r.x),a.addScaledVector(La,r.y),a.addScaledVector(Da,r.z),a}static isFrontFacing(e,t,i,s){return ln.subVectors(i,t),An.subVectors(e,t),ln.cross(An).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ln.subVectors(this.c,this.b),An.subVectors(this.a,this.b),ln.cross(An).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return un.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return un.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return un.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return un.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return un.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,s=this.b,r=this.c;let a,o;Ai.subVectors(s,i),Ri.subVectors(r,i),Aa.subVectors(e,i);const l=Ai.dot(Aa),c=Ri.dot(Aa);if(l<=0&&c<=0)return t.copy(i);Ra.subVectors(e,s);const u=Ai.dot(Ra),f=Ri.dot(Ra);if(u>=0&&f<=u)return t.copy(s);const h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return a=l/(l-u),t.copy(i).addScaledVector(Ai,a);Ca.subVectors(e,r);const g=Ai.dot(Ca),_=Ri.dot(Ca);if(_>=0&&g<=_)return t.copy(r);const y=g*c-l*_;if(y<=0&&c>=0&&_<=0)return o=c/(c-_),t.copy(i).addScaledVector(Ri,o);const d=u*_-g*f;if(d<=0&&f-u>=0&&g-_>=0)return kc.subVectors(r,s),o=(f-u)/(f-u+(g-_)),t.copy(s).addScaledVector(kc,o);const m=1/(d+y+h);return a=y*m,o=h*m,t.copy(i).addScaledVector(Ai,a).addScaledVector(Ri,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}class Es{constructor(e=new W(1/0,1/0,1/0),t=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(cn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(cn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=cn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,cn):cn.fromBufferAttribute(r,a),cn.applyMatrix4(e.matrixWorld),this.expandByPoint(cn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Os.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Os.copy(i.boundingBox)),Os.applyMatrix4(e.matrixWorld),this.union(Os)}const s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,cn),cn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Qi),ks.subVectors(this.max,Qi),Ci.subVectors(e.a,Qi),Pi.subVectors(e.b,Qi),Li.subVectors(e.c,Qi),Wn.subVectors(Pi,Ci),Xn.subVectors(Li,Pi),li.subVectors(Ci,Li);let t=[0,-Wn.z,Wn.y,0,-Xn.z,Xn.y,0,-li.z,li.y,Wn.z,0,-Wn.x,Xn.z,0,-Xn.x,li.z,0,-li.x,-Wn.y,Wn.x,0,-Xn.y,Xn.x,0,-li.y,li.x,0];return!Na(t,Ci,Pi,Li,ks)||(t=[1,0,0,0,1,0,0,0,1],!Na(t,Ci,Pi,Li,ks))?!1:(Bs.crossVectors(Wn,Xn),t=[Bs.x,Bs.y,Bs.z],Na(t,Ci,Pi,Li,ks))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,cn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(cn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Cn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Cn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Cn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Cn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Cn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Cn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Cn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Cn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Cn),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const Cn=[new W,new W,new W,new W,new W,new W,new W,new W],cn=new W,Os=new Es,Ci=new W,Pi=new W,Li=new W,Wn=new W,Xn=new W,li=new W,Qi=new W,ks=new W,Bs=new W,ci=new W;function Na(n,e,t,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){ci.fromArray(n,r);const o=s.x*Math.abs(ci.x)+s.y*Math.abs(ci.y)+s.z*Math.abs(ci.z),l=e.dot(ci),c=t.dot(ci),u=i.dot(ci);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>o)return!1}return!0}const Nn=_m();function _m(){const n=new ArrayBuffer(4),e=new Float32Array(n),t=new Uint32Array(n),i=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){const c=l-127;c<-27?(i[l]=0,i[l|256]=32768,s[l]=24,s[l|256]=24):c<-14?(i[l]=1024>>-c-14,i[l|256]=1024>>-c-14|32768,s[l]=-c-1,s[l|256]=-c-1):c<=15?(i[l]=c+15<<10,i[l|256]=c+15<<10|32768,s[l]=13,s[l|256]=13):c<128?(i[l]=31744,i[l|256]=64512,s[l]=24,s[l|256]=24):(i[l]=31744,i[l|256]=64512,s[l]=13,s[l|256]=13)}const r=new Uint32Array(2048),a=new Uint32Array(64),o=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,u=0;for(;(c&8388608)===0;)c<<=1,u-=8388608;c&=-8388609,u+=947912704,r[l]=c|u}for(let l=1024;l<2048;++l)r[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)a[l]=l<<23;a[31]=1199570944,a[32]=2147483648;for(let l=33;l<63;++l)a[l]=2147483648+(l-32<<23);a[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(o[l]=1024);return{floatView:e,uint32View:t,baseTable:i,shiftTable:s,mantissaTable:r,exponentTable:a,offsetTable:o}}function vm(n){Math.abs(n)>65504&&Pe("DataUtils.toHalfFloat(): Value out of range."),n=Ge(n,-65504,65504),Nn.floatView[0]=n;const e=Nn.uint32View[0],t=e>>23&511;return Nn.baseTable[t]+((e&8388607)>>Nn.shiftTable[t])}function xm(n){const e=n>>10;return Nn.uint32View[0]=Nn.mantissaTable[Nn.offsetTable[e]+(n&1023)]+Nn.exponentTable[e],Nn.floatView[0]}class Sm{static toHalfFloat(e){return vm(e)}static fromHalfFloat(e){return xm(e)}}const gt=new W,zs=new Xe;let Mm=0;class En extends yi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Mm++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Kp,this.updateRanges=[],this.gpuType=Ot,this.version=0,this._normalizationScale=e!==void 0?Ml(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)zs.fromBufferAttribute(this,t),zs.applyMatrix3(e),this.setXY(t,zs.x,zs.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.applyMatrix3(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.applyMatrix4(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.applyNormalMatrix(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.transformDirection(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){const t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):nm(e,this.array)}_normalize(e){const t=this._normalizationScale;return t!==void 0?Math.round(e*t):im(e,this.array)}}class ud extends En{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class hd extends En{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class kn extends En{constructor(e,t,i){super(new Float32Array(e),t,i)}}const ym=new Es,ji=new W,Ia=new W;class El{constructor(e=new W,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):ym.setFromPoints(e).getCenter(i);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ji.subVectors(e,this.center);const t=ji.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ji,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ia.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ji.copy(e.center).add(Ia)),this.expandByPoint(ji.copy(e.center).sub(Ia))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}let Em=0;const Qt=new ft,Ua=new qt,Di=new W,$t=new Es,es=new Es,Tt=new W;class Bn extends yi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Em++}),this.uuid=ys(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Zp(e)?hd:ud)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new De().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Qt.makeRotationFromQuaternion(e),this.applyMatrix4(Qt),this}rotateX(e){return Qt.makeRotationX(e),this.applyMatrix4(Qt),this}rotateY(e){return Qt.makeRotationY(e),this.applyMatrix4(Qt),this}rotateZ(e){return Qt.makeRotationZ(e),this.applyMatrix4(Qt),this}translate(e,t,i){return Qt.makeTranslation(e,t,i),this.applyMatrix4(Qt),this}scale(e,t,i){return Qt.makeScale(e,t,i),this.applyMatrix4(Qt),this}lookAt(e){return Ua.lookAt(e),Ua.updateMatrix(),this.applyMatrix4(Ua.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Di).negate(),this.translate(Di.x,Di.y,Di.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let s=0,r=e.length;s<r;s++){const a=e[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new kn(i,3))}else{const i=Math.min(e.length,t.count);for(let s=0;s<i;s++){const r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Pe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Es);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){const r=t[i];$t.setFromBufferAttribute(r),this.morphTargetsRelative?(Tt.addVectors(this.boundingBox.min,$t.min),this.boundingBox.expandByPoint(Tt),Tt.addVectors(this.boundingBox.max,$t.max),this.boundingBox.expandByPoint(Tt)):(this.boundingBox.expandByPoint($t.min),this.boundingBox.expandByPoint($t.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new El);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(e){const i=this.boundingSphere.center;if($t.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){const o=t[r];es.setFromBufferAttribute(o),this.morphTargetsRelative?(Tt.addVectors($t.min,es.min),$t.expandByPoint(Tt),Tt.addVectors($t.max,es.max),$t.expandByPoint(Tt)):($t.expandByPoint(es.min),$t.expandByPoint(es.max))}$t.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)Tt.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Tt));if(t)for(let r=0,a=t.length;r<a;r++){const o=t[r],l=this.morphTargetsRelative;for(let c=0,u=o.count;c<u;c++)Tt.fromBufferAttribute(o,c),l&&(Di.fromBufferAttribute(e,c),Tt.add(Di)),s=Math.max(s,i.distanceToSquared(Tt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,s=t.normal,r=t.uv;let a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new En(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));const o=[],l=[],c=new Uint8Array(i.count);for(let N=0;N<i.count;N++)o[N]=new W,l[N]=new W;const u=new W,f=new W,h=new W,g=new Xe,_=new Xe,y=new Xe,d=new W,m=new W;function x(N,C,L){c[N]=c[C]=c[L]=1,u.fromBufferAttribute(i,N),f.fromBufferAttribute(i,C),h.fromBufferAttribute(i,L),g.fromBufferAttribute(r,N),_.fromBufferAttribute(r,C),y.fromBufferAttribute(r,L),f.sub(u),h.sub(u),_.sub(g),y.sub(g);const k=1/(_.x*y.y-y.x*_.y);isFinite(k)&&(d.copy(f).multiplyScalar(y.y).addScaledVector(h,-_.y).multiplyScalar(k),m.copy(h).multiplyScalar(_.x).addScaledVector(f,-y.x).multiplyScalar(k),o[N].add(d),o[C].add(d),o[L].add(d),l[N].add(m),l[C].add(m),l[L].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let N=0,C=T.length;N<C;++N){const L=T[N],k=L.start,X=L.count;for(let I=k,V=k+X;I<V;I+=3)x(e.getX(I+0),e.getX(I+1),e.getX(I+2))}const S=new W,E=new W,A=new W,p=new W;function w(N){A.fromBufferAttribute(s,N),p.copy(A);const C=o[N];S.copy(C),S.sub(A.multiplyScalar(A.dot(C))).normalize(),E.crossVectors(p,C);const k=E.dot(l[N])<0?-1:1;a.setXYZW(N,S.x,S.y,S.z,k)}for(let N=0,C=i.count;N<C;++N)c[N]&&w(N);this._transformed=!0}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new En(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,g=i.count;h<g;h++)i.setXYZ(h,0,0,0);const s=new W,r=new W,a=new W,o=new W,l=new W,c=new W,u=new W,f=new W;if(e)for(let h=0,g=e.count;h<g;h+=3){const _=e.getX(h+0),y=e.getX(h+1),d=e.getX(h+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,y),a.fromBufferAttribute(t,d),u.subVectors(a,r),f.subVectors(s,r),u.cross(f),o.fromBufferAttribute(i,_),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,d),o.add(u),l.add(u),c.add(u),i.setXYZ(_,o.x,o.y,o.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let h=0,g=t.count;h<g;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),a.fromBufferAttribute(t,h+2),u.subVectors(a,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Tt.fromBufferAttribute(e,t),Tt.normalize(),e.setXYZ(t,Tt.x,Tt.y,Tt.z)}toNonIndexed(){function e(o,l){const c=o.array,u=o.itemSize,f=o.normalized,h=new c.constructor(l.length*u);let g=0,_=0;for(let y=0,d=l.length;y<d;y++){o.isInterleavedBufferAttribute?g=l[y]*o.data.stride+o.offset:g=l[y]*u;for(let m=0;m<u;m++)h[_++]=c[g++]}return new En(h,u,f)}if(this.index===null)return Pe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new Bn,i=this.index.array,s=this.attributes;for(const o in s){const l=s[o],c=e(l,i);t.setAttribute(o,c)}const r=this.morphAttributes;for(const o in r){const l=[],c=r[o];for(let u=0,f=c.length;u<f;u++){const h=c[u],g=e(h,i);l.push(g)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let o=0,l=a.length;o<l;o++){const c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const l in i){const c=i[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){const g=c[f];u.push(g.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));const o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone());const s=e.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(t))}const r=e.morphAttributes;for(const c in r){const u=[],f=r[c];for(let h=0,g=f.length;h<g;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;const a=e.groups;for(let c=0,u=a.length;c<u;c++){const f=a[c];this.addGroup(f.start,f.count,f.materialIndex)}const o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Fa=new W,bm=new W,wm=new De;class Yn{constructor(e=new W(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const s=Fa.subVectors(i,t).cross(bm.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){const s=e.delta(Fa),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const a=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||wm.getNormalMatrix(e),s=this.coplanarPoint(Fa).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}}let Tm=0;class jr extends yi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Tm++}),this.uuid=ys(),this.name="",this.type="Material",this.blending=cs,this.side=gi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=zh,this.blendDst=Hh,this.blendEquation=Fi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ye(0,0,0),this.blendAlpha=0,this.depthFunc=ps,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Vp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ga,this.stencilZFail=ga,this.stencilZPass=ga,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){Pe(`Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){Pe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const a=[];for(const o in r){const l=r[o];delete l.metadata,a.push(l)}return a}if(t){const r=s(e.textures),a=s(e.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ye().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Yn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Xe().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}const Pn=new W,Oa=new W,Hs=new W,Gs=new W;class Am{constructor(e=new W,t=new W(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Pn)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Pn.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Pn.copy(this.origin).addScaledVector(this.direction,t),Pn.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Oa.copy(e).add(t).multiplyScalar(.5),Hs.copy(t).sub(e).normalize(),Gs.copy(this.origin).sub(Oa);const r=e.distanceTo(t)*.5,a=-this.direction.dot(Hs),o=Gs.dot(this.direction),l=-Gs.dot(Hs),c=Gs.lengthSq(),u=Math.abs(1-a*a);let f,h,g,_;if(u>0)if(f=a*l-o,h=a*o-l,_=r*u,f>=0)if(h>=-_)if(h<=_){const y=1/u;f*=y,h*=y,g=f*(f+a*h+2*o)+h*(a*f+h+2*l)+c}else h=r,f=Math.max(0,-(a*h+o)),g=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(a*h+o)),g=-f*f+h*(h+2*l)+c;else h<=-_?(f=Math.max(0,-(-a*r+o)),h=f>0?-r:Math.min(Math.max(-r,-l),r),g=-f*f+h*(h+2*l)+c):h<=_?(f=0,h=Math.min(Math.max(-r,-l),r),g=h*(h+2*l)+c):(f=Math.max(0,-(a*r+o)),h=f>0?r:Math.min(Math.max(-r,-l),r),g=-f*f+h*(h+2*l)+c);else h=a>0?-r:r,f=Math.max(0,-(a*h+o)),g=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Oa).addScaledVector(Hs,h),g}intersectSphere(e,t){if(e.radius<0)return null;Pn.subVectors(e.center,this.origin);const i=Pn.dot(this.direction),s=Pn.dot(Pn)-i*i,r=e.radius*e.radius;if(s>r)return null;const a=Math.sqrt(r-s),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,a,o,l;const c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,a=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,a=(e.min.y-h.y)*u),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(o=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||o>s)||((o>i||i!==i)&&(i=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Pn)!==null}intersectTriangle(e,t,i,s,r){const a=this.origin,o=this.direction,l=o.x,c=o.y,u=o.z,f=e.x-a.x,h=e.y-a.y,g=e.z-a.z,_=t.x-a.x,y=t.y-a.y,d=t.z-a.z,m=i.x-a.x,x=i.y-a.y,T=i.z-a.z,S=Math.abs(l),E=Math.abs(c),A=Math.abs(u);let p,w,N,C,L,k,X,I,V,Q,z,q;if(S>=E&&S>=A?(N=l,k=f,V=_,q=m,l>=0?(p=c,w=u,C=h,L=g,X=y,I=d,Q=x,z=T):(p=u,w=c,C=g,L=h,X=d,I=y,Q=T,z=x)):E>=A?(N=c,k=h,V=y,q=x,c>=0?(p=u,w=l,C=g,L=f,X=d,I=_,Q=T,z=m):(p=l,w=u,C=f,L=g,X=_,I=d,Q=m,z=T)):(N=u,k=g,V=d,q=T,u>=0?(p=l,w=c,C=f,L=h,X=_,I=y,Q=m,z=x):(p=c,w=l,C=h,L=f,X=y,I=_,Q=x,z=m)),N===0)return null;const G=p/N,j=w/N,te=1/N,Ee=C-G*k,Ne=L-j*k,Z=X-G*V,me=I-j*V,Se=Q-G*q,Ae=z-j*q,ge=Se*me-Ae*Z,Ue=Ee*Ae-Ne*Se,pt=Z*Ne-me*Ee;if(s){if(ge<0||Ue<0||pt<0)return null}else if((ge<0||Ue<0||pt<0)&&(ge>0||Ue>0||pt>0))return null;const Ce=ge+Ue+pt;if(Ce===0)return null;const Ke=te*(ge*k+Ue*V+pt*q);return(Ce>0?Ke<0:Ke>0)?null:this.at(Ke/Ce,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Rm extends jr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ye(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vi,this.combine=Gh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Bc=new ft,ui=new Am,Vs=new El,zc=new W,Ws=new W,Xs=new W,$s=new W,ka=new W,qs=new W,Hc=new W,Ys=new W;class ii extends qt{constructor(e=new Bn,t=new Rm){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;t.fromBufferAttribute(s,e);const o=this.morphTargetInfluences;if(r&&o){qs.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=o[l],f=r[l];u!==0&&(ka.fromBufferAttribute(f,e),a?qs.addScaledVector(ka,u):qs.addScaledVector(ka.sub(t),u))}t.add(qs)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Vs.copy(i.boundingSphere),Vs.applyMatrix4(r),ui.copy(e.ray).recast(e.near),!(Vs.containsPoint(ui.origin)===!1&&(ui.intersectSphere(Vs,zc)===null||ui.origin.distanceToSquared(zc)>(e.far-e.near)**2))&&(Bc.copy(r).invert(),ui.copy(e.ray).applyMatrix4(Bc),!(i.boundingBox!==null&&ui.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ui)))}_computeIntersections(e,t,i){let s;const r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,g=r.drawRange;if(o!==null)if(Array.isArray(a))for(let _=0,y=h.length;_<y;_++){const d=h[_],m=a[d.materialIndex],x=Math.max(d.start,g.start),T=Math.min(o.count,Math.min(d.start+d.count,g.start+g.count));for(let S=x,E=T;S<E;S+=3){const A=o.getX(S),p=o.getX(S+1),w=o.getX(S+2);s=Ks(this,m,e,i,c,u,f,A,p,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{const _=Math.max(0,g.start),y=Math.min(o.count,g.start+g.count);for(let d=_,m=y;d<m;d+=3){const x=o.getX(d),T=o.getX(d+1),S=o.getX(d+2);s=Ks(this,a,e,i,c,u,f,x,T,S),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let _=0,y=h.length;_<y;_++){const d=h[_],m=a[d.materialIndex],x=Math.max(d.start,g.start),T=Math.min(l.count,Math.min(d.start+d.count,g.start+g.count));for(let S=x,E=T;S<E;S+=3){const A=S,p=S+1,w=S+2;s=Ks(this,m,e,i,c,u,f,A,p,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{const _=Math.max(0,g.start),y=Math.min(l.count,g.start+g.count);for(let d=_,m=y;d<m;d+=3){const x=d,T=d+1,S=d+2;s=Ks(this,a,e,i,c,u,f,x,T,S),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}}}function Cm(n,e,t,i,s,r,a,o){let l;if(e.side===Vt?l=i.intersectTriangle(a,r,s,!0,o):l=i.intersectTriangle(s,r,a,e.side===gi,o),l===null)return null;Ys.copy(o),Ys.applyMatrix4(n.matrixWorld);const c=t.ray.origin.distanceTo(Ys);return c<t.near||c>t.far?null:{distance:c,point:Ys.clone(),object:n}}function Ks(n,e,t,i,s,r,a,o,l,c){n.getVertexPosition(o,Ws),n.getVertexPosition(l,Xs),n.getVertexPosition(c,$s);const u=Cm(n,e,t,i,Ws,Xs,$s,Hc);if(u){const f=new W;un.getBarycoord(Hc,Ws,Xs,$s,f),s&&(u.uv=un.getInterpolatedAttribute(s,o,l,c,f,new Xe)),r&&(u.uv1=un.getInterpolatedAttribute(r,o,l,c,f,new Xe)),a&&(u.normal=un.getInterpolatedAttribute(a,o,l,c,f,new W),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const h={a:o,b:l,c,normal:new W,materialIndex:0};un.getNormal(Ws,Xs,$s,h.normal),u.face=h,u.barycoord=f}return u}class Wo extends kt{constructor(e=null,t=1,i=1,s,r,a,o,l,c=vt,u=vt,f,h){super(null,a,o,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const hi=new El,Pm=new Xe(.5,.5),Zs=new W;class Ur{constructor(e=new Yn,t=new Yn,i=new Yn,s=new Yn,r=new Yn,a=new Yn){this.planes=[e,t,i,s,r,a]}set(e,t,i,s,r,a){const o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=hn,i=!1){const s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],g=r[7],_=r[8],y=r[9],d=r[10],m=r[11],x=r[12],T=r[13],S=r[14],E=r[15];if(s[0].setComponents(c-a,g-u,m-_,E-x).normalize(),s[1].setComponents(c+a,g+u,m+_,E+x).normalize(),s[2].setComponents(c+o,g+f,m+y,E+T).normalize(),s[3].setComponents(c-o,g-f,m-y,E-T).normalize(),i)s[4].setComponents(l,h,d,S).normalize(),s[5].setComponents(c-l,g-h,m-d,E-S).normalize();else if(s[4].setComponents(c-l,g-h,m-d,E-S).normalize(),t===hn)s[5].setComponents(c+l,g+h,m+d,E+S).normalize();else if(t===Nr)s[5].setComponents(l,h,d,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),hi.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),hi.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(hi)}intersectsSprite(e){hi.center.set(0,0,0);const t=Pm.distanceTo(e.center);return hi.radius=.7071067811865476+t,hi.applyMatrix4(e.matrixWorld),this.intersectsSphere(hi)}intersectsSphere(e){const t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const s=t[i];if(Zs.x=s.normal.x>0?e.max.x:e.min.x,Zs.y=s.normal.y>0?e.max.y:e.min.y,Zs.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Zs)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}const Gc=new ft;class bl{constructor(){this.coordinateSystem=hn,this._frustums=[],this._count=0}setFromArrayCamera(e){const t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){const r=t[s];Gc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ur),i[s].setFromProjectionMatrix(Gc,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;const t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Ur),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new bl().copy(this)}}class dd extends kt{constructor(e=[],t=zi,i,s,r,a,o,l,c,u){super(e,t,i,s,r,a,o,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class Gi extends kt{constructor(e,t,i=bn,s,r,a,o=vt,l=vt,c,u=ni,f=1){if(u!==ni&&u!==Qn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const h={width:e,height:t,depth:f};super(h,s,r,a,o,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new yl(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}}class fd extends Gi{constructor(e,t=bn,i=zi,s,r,a=vt,o=vt,l,c=ni){const u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,a,o,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}}class pd extends kt{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class bs extends Bn{constructor(e=1,t=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};const o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);const l=[],c=[],u=[],f=[];let h=0,g=0;_("z","y","x",-1,-1,i,t,e,a,r,0),_("z","y","x",1,-1,i,t,-e,a,r,1),_("x","z","y",1,1,e,i,t,s,a,2),_("x","z","y",1,-1,e,i,-t,s,a,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new kn(c,3)),this.setAttribute("normal",new kn(u,3)),this.setAttribute("uv",new kn(f,2));function _(y,d,m,x,T,S,E,A,p,w,N){const C=S/p,L=E/w,k=S/2,X=E/2,I=A/2,V=p+1,Q=w+1;let z=0,q=0;const G=new W;for(let j=0;j<Q;j++){const te=j*L-X;for(let Ee=0;Ee<V;Ee++){const Ne=Ee*C-k;G[y]=Ne*x,G[d]=te*T,G[m]=I,c.push(G.x,G.y,G.z),G[y]=0,G[d]=0,G[m]=A>0?1:-1,u.push(G.x,G.y,G.z),f.push(Ee/p),f.push(1-j/w),z+=1}}for(let j=0;j<w;j++)for(let te=0;te<p;te++){const Ee=h+te+V*j,Ne=h+te+V*(j+1),Z=h+(te+1)+V*(j+1),me=h+(te+1)+V*j;l.push(Ee,Ne,me),l.push(Ne,Z,me),q+=6}o.addGroup(g,q,N),g+=q,h+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new bs(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}class ea extends Bn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};const r=e/2,a=t/2,o=Math.floor(i),l=Math.floor(s),c=o+1,u=l+1,f=e/o,h=t/l,g=[],_=[],y=[],d=[];for(let m=0;m<u;m++){const x=m*h-a;for(let T=0;T<c;T++){const S=T*f-r;_.push(S,-x,0),y.push(0,0,1),d.push(T/o),d.push(1-m/l)}}for(let m=0;m<l;m++)for(let x=0;x<o;x++){const T=x+c*m,S=x+c*(m+1),E=x+1+c*(m+1),A=x+1+c*m;g.push(T,S,A),g.push(S,E,A)}this.setIndex(g),this.setAttribute("position",new kn(_,3)),this.setAttribute("normal",new kn(y,3)),this.setAttribute("uv",new kn(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new ea(e.width,e.height,e.widthSegments,e.heightSegments)}}function Vi(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const s=n[t][i];if(Vc(s))s.isRenderTargetTexture?(Pe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Vc(s[0])){const r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Ft(n){const e={};for(let t=0;t<n.length;t++){const i=Vi(n[t]);for(const s in i)e[s]=i[s]}return e}function Vc(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Lm(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function md(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ve.workingColorSpace}const Dm={clone:Vi,merge:Ft};var Nm=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Im=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class xi extends jr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Nm,this.fragmentShader=Im,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Vi(e.uniforms),this.uniformsGroups=Lm(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(const i in e.uniforms){const s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Ye().setHex(s.value);break;case"v2":this.uniforms[i].value=new Xe().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new ht().fromArray(s.value);break;case"m3":this.uniforms[i].value=new De().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ft().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(const i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}}class gd extends xi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class Um extends jr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Hp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class Fm extends jr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const Js=new W,Qs=new qi,gn=new W;class wl extends qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ft,this.projectionMatrix=new ft,this.projectionMatrixInverse=new ft,this.coordinateSystem=hn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Js,Qs,gn),gn.x===1&&gn.y===1&&gn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Js,Qs,gn.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Js,Qs,gn),gn.x===1&&gn.y===1&&gn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Js,Qs,gn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const $n=new W,Wc=new Xe,Xc=new Xe;class vn extends wl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=Go*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(_a*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Go*2*Math.atan(Math.tan(_a*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){$n.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set($n.x,$n.y).multiplyScalar(-e/$n.z),$n.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set($n.x,$n.y).multiplyScalar(-e/$n.z)}getViewSize(e,t){return this.getViewBounds(e,Wc,Xc),t.subVectors(Xc,Wc)}setViewOffset(e,t,i,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(_a*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*i/c,s*=a.width/l,i*=a.height/c}const o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}class Om extends wl{constructor(e=-1,t=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-e,a=i+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=u*this.view.offsetY,l=o-u*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}const Ni=-90,Ii=1;class Xo extends qt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new vn(Ni,Ii,e,t);s.layers=this.layers,this.add(s);const r=new vn(Ni,Ii,e,t);r.layers=this.layers,this.add(r);const a=new vn(Ni,Ii,e,t);a.layers=this.layers,this.add(a);const o=new vn(Ni,Ii,e,t);o.layers=this.layers,this.add(o);const l=new vn(Ni,Ii,e,t);l.layers=this.layers,this.add(l);const c=new vn(Ni,Ii,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,s,r,a,o,l]=t;for(const c of t)this.remove(c);if(e===hn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Nr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,a,o,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),g=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,2,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,3,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,g),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}}class km extends vn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}}function $c(n,e,t,i){const s=Bm(i);switch(t){case td:return n*e;case Qr:return n*e/s.components*s.byteLength;case vl:return n*e/s.components*s.byteLength;case _i:return n*e*2/s.components*s.byteLength;case xl:return n*e*2/s.components*s.byteLength;case nd:return n*e*3/s.components*s.byteLength;case nn:return n*e*4/s.components*s.byteLength;case Sl:return n*e*4/s.components*s.byteLength;case ur:case hr:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case dr:case fr:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ho:case po:return Math.max(n,16)*Math.max(e,8)/4;case uo:case fo:return Math.max(n,8)*Math.max(e,8)/2;case mo:case go:case vo:case xo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case _o:case Pr:case So:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Mo:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case yo:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Eo:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case bo:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case wo:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case To:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Ao:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Ro:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Co:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Po:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Lo:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Do:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case No:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Io:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Uo:case Fo:case Oo:return Math.ceil(n/4)*Math.ceil(e/4)*16;case ko:case Bo:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Lr:case zo:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Bm(n){switch(n){case tn:case Jh:return{byteLength:1,components:1};case gs:case Qh:case Wt:return{byteLength:2,components:1};case gl:case _l:return{byteLength:2,components:4};case bn:case ml:case Ot:return{byteLength:4,components:1};case jh:case ed:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:pl}}));typeof window<"u"&&(window.__THREE__?Pe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=pl);function _d(){let n=null,e=!1,t=null,i=null;function s(r,a){i=n.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function zm(n){const e=new WeakMap;function t(o,l){const c=o.array,u=o.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),o.onUploadCallback();let g;if(c instanceof Float32Array)g=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)g=n.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?g=n.HALF_FLOAT:g=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)g=n.SHORT;else if(c instanceof Uint32Array)g=n.UNSIGNED_INT;else if(c instanceof Int32Array)g=n.INT;else if(c instanceof Int8Array)g=n.BYTE;else if(c instanceof Uint8Array)g=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)g=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:g,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:f}}function i(o,l,c){const u=l.array,f=l.updateRanges;if(n.bindBuffer(c,o),f.length===0)n.bufferSubData(c,0,u);else{f.sort((g,_)=>g.start-_.start);let h=0;for(let g=1;g<f.length;g++){const _=f[h],y=f[g];y.start<=_.start+_.count+1?_.count=Math.max(_.count,y.start+y.count-_.start):(++h,f[h]=y)}f.length=h+1;for(let g=0,_=f.length;g<_;g++){const y=f[g];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);const l=e.get(o);l&&(n.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const u=e.get(o);(!u||u.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var Hm=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Gm=`#ifdef USE_ALPHAHASH
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
#endif`,Vm=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Wm=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Xm=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,$m=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,qm=`#ifdef USE_AOMAP
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
#endif`,Ym=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Km=`#ifdef USE_BATCHING
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
#endif`,Zm=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Jm=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Qm=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,jm=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,eg=`#ifdef USE_IRIDESCENCE
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
#endif`,tg=`#ifdef USE_BUMPMAP
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
#endif`,ng=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,ig=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,sg=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,rg=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,ag=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,og=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,lg=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,cg=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,ug=`#define PI 3.141592653589793
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
} // validated`,hg=`vec3 transformedNormal = objectNormal;
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
#endif`,dg=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,fg=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,pg=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,mg=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,gg="gl_FragColor = linearToOutputTexel( gl_FragColor );",_g=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,vg=`#ifdef USE_ENVMAP
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
#endif`,xg=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Sg=`#ifdef USE_ENVMAP
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
#endif`,Mg=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,yg=`#ifdef USE_ENVMAP
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
#endif`,Eg=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,bg=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,wg=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Tg=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ag=`#ifdef USE_GRADIENTMAP
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
}`,Rg=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Cg=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Pg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Lg=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Dg=`#ifdef USE_ENVMAP
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
#endif`,Ng=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ig=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ug=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Fg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Og=`PhysicalMaterial material;
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
#endif`,kg=`uniform sampler2D dfgLUT;
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
}`,Bg=`
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
#endif`,zg=`#if defined( RE_IndirectDiffuse )
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
#endif`,Hg=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Gg=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Vg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Wg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Xg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$g=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,qg=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Yg=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Kg=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Zg=`#if defined( USE_POINTS_UV )
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
#endif`,Jg=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Qg=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,jg=`#ifdef USE_INSTANCING_MORPH
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
#endif`,t_=`#ifdef USE_MORPHNORMALS
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
#endif`,i_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,s_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,r_=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,a_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,o_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,l_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,c_=`#ifdef USE_NORMALMAP
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
#endif`,h_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,d_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,f_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,p_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,m_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,g_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,__=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,v_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,x_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,S_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,M_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,y_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,E_=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,b_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,w_=`float getShadowMask() {
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
}`,T_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,A_=`#ifdef USE_SKINNING
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
#endif`,C_=`#ifdef USE_SKINNING
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
#endif`,P_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,L_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,D_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,N_=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,I_=`#ifdef USE_TRANSMISSION
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
#endif`,U_=`#ifdef USE_TRANSMISSION
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
#endif`,O_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,k_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,B_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const z_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,H_=`uniform sampler2D t2D;
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
}`,G_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,V_=`uniform float backgroundBlurriness;
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
}`,W_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,X_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$_=`#include <common>
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
}`,q_=`#if DEPTH_PACKING == 3200
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
}`,Y_=`#define DISTANCE
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
}`,K_=`#define DISTANCE
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
}`,Z_=`varying vec3 vWorldDirection;
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
}`,j_=`uniform vec3 diffuse;
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
}`,e0=`#include <common>
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
}`,t0=`uniform vec3 diffuse;
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
}`,n0=`#define LAMBERT
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
}`,i0=`#define LAMBERT
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
}`,s0=`#define MATCAP
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
}`,r0=`#define MATCAP
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
}`,a0=`#define NORMAL
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
}`,o0=`#define NORMAL
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
}`,l0=`#define PHONG
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
}`,c0=`#define PHONG
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
}`,u0=`#define STANDARD
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
}`,h0=`#define STANDARD
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
}`,d0=`#define TOON
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
}`,f0=`#define TOON
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
}`,p0=`uniform float size;
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
}`,m0=`uniform vec3 diffuse;
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
}`,g0=`#include <common>
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
}`,_0=`uniform vec3 color;
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
}`,v0=`uniform float rotation;
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
}`,x0=`uniform vec3 diffuse;
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
}`,ke={alphahash_fragment:Hm,alphahash_pars_fragment:Gm,alphamap_fragment:Vm,alphamap_pars_fragment:Wm,alphatest_fragment:Xm,alphatest_pars_fragment:$m,aomap_fragment:qm,aomap_pars_fragment:Ym,batching_pars_vertex:Km,batching_vertex:Zm,begin_vertex:Jm,beginnormal_vertex:Qm,bsdfs:jm,iridescence_fragment:eg,bumpmap_pars_fragment:tg,clipping_planes_fragment:ng,clipping_planes_pars_fragment:ig,clipping_planes_pars_vertex:sg,clipping_planes_vertex:rg,color_fragment:ag,color_pars_fragment:og,color_pars_vertex:lg,color_vertex:cg,common:ug,defaultnormal_vertex:hg,displacementmap_pars_vertex:dg,displacementmap_vertex:fg,emissivemap_fragment:pg,emissivemap_pars_fragment:mg,colorspace_fragment:gg,colorspace_pars_fragment:_g,envmap_fragment:vg,envmap_common_pars_fragment:xg,envmap_pars_fragment:Sg,envmap_pars_vertex:Mg,envmap_physical_pars_fragment:Dg,envmap_vertex:yg,fog_vertex:Eg,fog_pars_vertex:bg,fog_fragment:wg,fog_pars_fragment:Tg,gradientmap_pars_fragment:Ag,lightmap_pars_fragment:Rg,lights_lambert_fragment:Cg,lights_lambert_pars_fragment:Pg,lights_pars_begin:Lg,lights_toon_fragment:Ng,lights_toon_pars_fragment:Ig,lights_phong_fragment:Ug,lights_phong_pars_fragment:Fg,lights_physical_fragment:Og,lights_physical_pars_fragment:kg,lights_fragment_begin:Bg,lights_fragment_maps:zg,lights_fragment_end:Hg,lightprobes_pars_fragment:Gg,logdepthbuf_fragment:Vg,logdepthbuf_pars_fragment:Wg,logdepthbuf_pars_vertex:Xg,logdepthbuf_vertex:$g,map_fragment:qg,map_pars_fragment:Yg,map_particle_fragment:Kg,map_particle_pars_fragment:Zg,metalnessmap_fragment:Jg,metalnessmap_pars_fragment:Qg,morphinstance_vertex:jg,morphcolor_vertex:e_,morphnormal_vertex:t_,morphtarget_pars_vertex:n_,morphtarget_vertex:i_,normal_fragment_begin:s_,normal_fragment_maps:r_,normal_pars_fragment:a_,normal_pars_vertex:o_,normal_vertex:l_,normalmap_pars_fragment:c_,clearcoat_normal_fragment_begin:u_,clearcoat_normal_fragment_maps:h_,clearcoat_pars_fragment:d_,iridescence_pars_fragment:f_,opaque_fragment:p_,packing:m_,premultiplied_alpha_fragment:g_,project_vertex:__,dithering_fragment:v_,dithering_pars_fragment:x_,roughnessmap_fragment:S_,roughnessmap_pars_fragment:M_,shadowmap_pars_fragment:y_,shadowmap_pars_vertex:E_,shadowmap_vertex:b_,shadowmask_pars_fragment:w_,skinbase_vertex:T_,skinning_pars_vertex:A_,skinning_vertex:R_,skinnormal_vertex:C_,specularmap_fragment:P_,specularmap_pars_fragment:L_,tonemapping_fragment:D_,tonemapping_pars_fragment:N_,transmission_fragment:I_,transmission_pars_fragment:U_,uv_pars_fragment:F_,uv_pars_vertex:O_,uv_vertex:k_,worldpos_vertex:B_,background_vert:z_,background_frag:H_,backgroundCube_vert:G_,backgroundCube_frag:V_,cube_vert:W_,cube_frag:X_,depth_vert:$_,depth_frag:q_,distance_vert:Y_,distance_frag:K_,equirect_vert:Z_,equirect_frag:J_,linedashed_vert:Q_,linedashed_frag:j_,meshbasic_vert:e0,meshbasic_frag:t0,meshlambert_vert:n0,meshlambert_frag:i0,meshmatcap_vert:s0,meshmatcap_frag:r0,meshnormal_vert:a0,meshnormal_frag:o0,meshphong_vert:l0,meshphong_frag:c0,meshphysical_vert:u0,meshphysical_frag:h0,meshtoon_vert:d0,meshtoon_frag:f0,points_vert:p0,points_frag:m0,shadow_vert:g0,shadow_frag:_0,sprite_vert:v0,sprite_frag:x0},pe={common:{diffuse:{value:new Ye(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new De}},envmap:{envMap:{value:null},envMapRotation:{value:new De},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new De}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new De}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new De},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new De},normalScale:{value:new Xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new De},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new De}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new De}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new De}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ye(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ye(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0},uvTransform:{value:new De}},sprite:{diffuse:{value:new Ye(16777215)},opacity:{value:1},center:{value:new Xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}}},xn={basic:{uniforms:Ft([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.fog]),vertexShader:ke.meshbasic_vert,fragmentShader:ke.meshbasic_frag},lambert:{uniforms:Ft([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)},envMapIntensity:{value:1}}]),vertexShader:ke.meshlambert_vert,fragmentShader:ke.meshlambert_frag},phong:{uniforms:Ft([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)},specular:{value:new Ye(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ke.meshphong_vert,fragmentShader:ke.meshphong_frag},standard:{uniforms:Ft([pe.common,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.roughnessmap,pe.metalnessmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ke.meshphysical_vert,fragmentShader:ke.meshphysical_frag},toon:{uniforms:Ft([pe.common,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.gradientmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)}}]),vertexShader:ke.meshtoon_vert,fragmentShader:ke.meshtoon_frag},matcap:{uniforms:Ft([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,{matcap:{value:null}}]),vertexShader:ke.meshmatcap_vert,fragmentShader:ke.meshmatcap_frag},points:{uniforms:Ft([pe.points,pe.fog]),vertexShader:ke.points_vert,fragmentShader:ke.points_frag},dashed:{uniforms:Ft([pe.common,pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ke.linedashed_vert,fragmentShader:ke.linedashed_frag},depth:{uniforms:Ft([pe.common,pe.displacementmap]),vertexShader:ke.depth_vert,fragmentShader:ke.depth_frag},normal:{uniforms:Ft([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,{opacity:{value:1}}]),vertexShader:ke.meshnormal_vert,fragmentShader:ke.meshnormal_frag},sprite:{uniforms:Ft([pe.sprite,pe.fog]),vertexShader:ke.sprite_vert,fragmentShader:ke.sprite_frag},background:{uniforms:{uvTransform:{value:new De},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ke.background_vert,fragmentShader:ke.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new De}},vertexShader:ke.backgroundCube_vert,fragmentShader:ke.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ke.cube_vert,fragmentShader:ke.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ke.equirect_vert,fragmentShader:ke.equirect_frag},distance:{uniforms:Ft([pe.common,pe.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ke.distance_vert,fragmentShader:ke.distance_frag},shadow:{uniforms:Ft([pe.lights,pe.fog,{color:{value:new Ye(0)},opacity:{value:1}}]),vertexShader:ke.shadow_vert,fragmentShader:ke.shadow_frag}};xn.physical={uniforms:Ft([xn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new De},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new De},clearcoatNormalScale:{value:new Xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new De},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new De},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new De},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new De},sheen:{value:0},sheenColor:{value:new Ye(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new De},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new De},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new De},transmissionSamplerSize:{value:new Xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new De},attenuationDistance:{value:0},attenuationColor:{value:new Ye(0)},specularColor:{value:new Ye(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new De},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new De},anisotropyVector:{value:new Xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new De}}]),vertexShader:ke.meshphysical_vert,fragmentShader:ke.meshphysical_frag};const js={r:0,b:0,g:0},S0=new ft,vd=new De;vd.set(-1,0,0,0,1,0,0,0,1);function M0(n,e,t,i,s,r){const a=new Ye(0);let o=s===!0?0:1,l,c,u=null,f=0,h=null;function g(x){let T=x.isScene===!0?x.background:null;if(T&&T.isTexture){const S=x.backgroundBlurriness>0;T=e.get(T,S)}return T}function _(x){let T=!1;const S=g(x);S===null?d(a,o):S&&S.isColor&&(d(S,1),T=!0);const E=n.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,T){const S=g(T);S&&S.isCubeTexture?(c===void 0&&(c=new ii(new bs(1,1,1),new xi({name:"BackgroundCubeMaterial",uniforms:Vi(xn.backgroundCube.uniforms),vertexShader:xn.backgroundCube.vertexShader,fragmentShader:xn.backgroundCube.fragmentShader,side:Vt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,A,p){this.matrixWorld.copyPosition(p.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(S0.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(vd),c.material.toneMapped=Ve.getTransfer(S.colorSpace)!==Je,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new ii(new ea(2,2),new xi({name:"BackgroundMaterial",uniforms:Vi(xn.background.uniforms),vertexShader:xn.background.vertexShader,fragmentShader:xn.background.fragmentShader,side:gi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Ve.getTransfer(S.colorSpace)!==Je,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function d(x,T){x.getRGB(js,md(n)),t.buffers.color.setClear(js.r,js.g,js.b,T,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(x,T=1){a.set(x),o=T,d(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(x){o=x,d(a,o)},render:_,addToRenderList:y,dispose:m}}function y0(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null);let r=s,a=!1;function o(L,k,X,I,V){let Q=!1;const z=f(L,I,X,k);r!==z&&(r=z,c(r.object)),Q=g(L,I,X,V),Q&&_(L,I,X,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(Q||a)&&(a=!1,S(L,k,X,I),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,k,X,I){const V=I.wireframe===!0;let Q=i[k.id];Q===void 0&&(Q={},i[k.id]=Q);const z=L.isInstancedMesh===!0?L.id:0;let q=Q[z];q===void 0&&(q={},Q[z]=q);let G=q[X.id];G===void 0&&(G={},q[X.id]=G);let j=G[V];return j===void 0&&(j=h(l()),G[V]=j),j}function h(L){const k=[],X=[],I=[];for(let V=0;V<t;V++)k[V]=0,X[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:X,attributeDivisors:I,object:L,attributes:{},index:null}}function g(L,k,X,I){const V=r.attributes,Q=k.attributes;let z=0;const q=X.getAttributes();for(const G in q)if(q[G].location>=0){const te=V[G];let Ee=Q[G];if(Ee===void 0&&(G==="instanceMatrix"&&L.instanceMatrix&&(Ee=L.instanceMatrix),G==="instanceColor"&&L.instanceColor&&(Ee=L.instanceColor)),te===void 0||te.attribute!==Ee||Ee&&te.data!==Ee.data)return!0;z++}return r.attributesNum!==z||r.index!==I}function _(L,k,X,I){const V={},Q=k.attributes;let z=0;const q=X.getAttributes();for(const G in q)if(q[G].location>=0){let te=Q[G];te===void 0&&(G==="instanceMatrix"&&L.instanceMatrix&&(te=L.instanceMatrix),G==="instanceColor"&&L.instanceColor&&(te=L.instanceColor));const Ee={};Ee.attribute=te,te&&te.data&&(Ee.data=te.data),V[G]=Ee,z++}r.attributes=V,r.attributesNum=z,r.index=I}function y(){const L=r.newAttributes;for(let k=0,X=L.length;k<X;k++)L[k]=0}function d(L){m(L,0)}function m(L,k){const X=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;X[L]=1,I[L]===0&&(n.enableVertexAttribArray(L),I[L]=1),V[L]!==k&&(n.vertexAttribDivisor(L,k),V[L]=k)}function x(){const L=r.newAttributes,k=r.enabledAttributes;for(let X=0,I=k.length;X<I;X++)k[X]!==L[X]&&(n.disableVertexAttribArray(X),k[X]=0)}function T(L,k,X,I,V,Q,z){z===!0?n.vertexAttribIPointer(L,k,X,V,Q):n.vertexAttribPointer(L,k,X,I,V,Q)}function S(L,k,X,I){y();const V=I.attributes,Q=X.getAttributes(),z=k.defaultAttributeValues;for(const q in Q){const G=Q[q];if(G.location>=0){let j=V[q];if(j===void 0&&(q==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),q==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){const te=j.normalized,Ee=j.itemSize,Ne=e.get(j);if(Ne===void 0)continue;const Z=Ne.buffer,me=Ne.type,Se=Ne.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===ml;if(j.isInterleavedBufferAttribute){const ge=j.data,Ue=ge.isInterleavedBuffer===!0?ge.stride:ge.itemSize,pt=j.offset;if(ge.isInstancedInterleavedBuffer||ge.isInstancedBufferAttribute){for(let Ce=0;Ce<G.locationSize;Ce++)m(G.location+Ce,ge.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ge.meshPerAttribute*ge.count)}else for(let Ce=0;Ce<G.locationSize;Ce++)d(G.location+Ce);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let Ce=0;Ce<G.locationSize;Ce++)T(G.location+Ce,Ee/G.locationSize,me,te,Ue*Se,(pt+Ee/G.locationSize*Ce)*Se,Ae)}else{if(j.isInstancedBufferAttribute){for(let ge=0;ge<G.locationSize;ge++)m(G.location+ge,j.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let ge=0;ge<G.locationSize;ge++)d(G.location+ge);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let ge=0;ge<G.locationSize;ge++)T(G.location+ge,Ee/G.locationSize,me,te,Ee*Se,Ee/G.locationSize*ge*Se,Ae)}}else if(z!==void 0){const te=z[q];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(G.location,te);break;case 3:n.vertexAttrib3fv(G.location,te);break;case 4:n.vertexAttrib4fv(G.location,te);break;default:n.vertexAttrib1fv(G.location,te)}}}}x()}function E(){N();for(const L in i){const k=i[L];for(const X in k){const I=k[X];for(const V in I){const Q=I[V];for(const z in Q)u(Q[z].object),delete Q[z];delete I[V]}}delete i[L]}}function A(L){if(i[L.id]===void 0)return;const k=i[L.id];for(const X in k){const I=k[X];for(const V in I){const Q=I[V];for(const z in Q)u(Q[z].object),delete Q[z];delete I[V]}}delete i[L.id]}function p(L){for(const k in i){const X=i[k];for(const I in X){const V=X[I];if(V[L.id]===void 0)continue;const Q=V[L.id];for(const z in Q)u(Q[z].object),delete Q[z];delete V[L.id]}}}function w(L){for(const k in i){const X=i[k],I=L.isInstancedMesh===!0?L.id:0,V=X[I];if(V!==void 0){for(const Q in V){const z=V[Q];for(const q in z)u(z[q].object),delete z[q];delete V[Q]}delete X[I],Object.keys(X).length===0&&delete i[k]}}}function N(){C(),a=!0,r!==s&&(r=s,c(r.object))}function C(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:N,resetDefaultState:C,dispose:E,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:p,initAttributes:y,enableAttribute:d,disableUnusedAttributes:x}}function E0(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function a(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function o(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let g=0;g<u;g++)h+=c[g];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function b0(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const p=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(p.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(p){return!(p!==nn&&i.convert(p)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(p){const w=p===Wt&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(p!==tn&&p!==Ot&&!w&&i.convert(p)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(p){if(p==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";p="mediump"}return p==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const u=l(c);u!==c&&(Pe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Pe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Pe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");const g=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:g,maxVertexTextures:_,maxTextureSize:y,maxCubemapSize:d,maxAttributes:m,maxVertexUniforms:x,maxVaryings:T,maxFragmentUniforms:S,maxSamples:E,samples:A}}function w0(n){const e=this;let t=null,i=0,s=!1,r=!1;const a=new Yn,o=new De,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){const g=f.length!==0||h||i!==0||s;return s=h,i=f.length,g},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,g){const _=f.clippingPlanes,y=f.clipIntersection,d=f.clipShadows,m=n.get(f);if(!s||_===null||_.length===0||r&&!d)r?u(null):c();else{const x=r?0:i,T=x*4;let S=m.clippingState||null;l.value=S,S=u(_,h,T,g);for(let E=0;E!==T;++E)S[E]=t[E];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,g,_){const y=f!==null?f.length:0;let d=null;if(y!==0){if(d=l.value,_!==!0||d===null){const m=g+y*4,x=h.matrixWorldInverse;o.getNormalMatrix(x),(d===null||d.length<m)&&(d=new Float32Array(m));for(let T=0,S=g;T!==y;++T,S+=4)a.copy(f[T]).applyMatrix4(x,o),a.normal.toArray(d,S),d[S+3]=a.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,d}}class Tl extends fn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new dd(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new bs(5,5,5),r=new xi({name:"CubemapFromEquirect",uniforms:Vi(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Vt,blending:fi});r.uniforms.tEquirect.value=t;const a=new ii(s,r),o=t.minFilter;return t.minFilter===Jn&&(t.minFilter=Pt),new Xo(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){const r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,i,s);e.setRenderTarget(r)}}const qc=256,T0=3,A0=20,xd=256,Sd=16,R0=3,C0=new W,P0=new Ye;class Fr{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Xo(1,10,null),this._boxMesh=new ii(new bs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){const{size:a=256,position:o=C0}=r,l=this._renderer;this._setSize(a);const c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);const f=l.autoClear,h=l.autoClearColor,g=l.autoClearDepth,_=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(P0));const d=new Xo(i,s,u);return d.position.copy(o),d.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=g,l.autoClearStencil=_,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Zc(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Kc(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(qc,tm(e))}_fromTexture(e,t){e.mapping===zi||e.mapping===ms?this._setSize(e.image.length===0?qc:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);const i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){const e=this._cubeSize,t=Yc(e,!1,!1),i=Math.log2(e)-T0;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){const t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Yc(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){const s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;const a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===zi||e.mapping===ms?(this._cubemapMaterial===null&&(this._cubemapMaterial=Zc()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Kc()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=L0(),this._integrationMaterial=D0());const t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;const r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Sd);for(let a=0;a<=i;a++){const o=Fr.lodToRoughness(a,i);if(a>i-R0)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{const l=o>0?Math.log2(t)+.5*Math.log2(6/(xd*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=N0());const i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}}function Yc(n,e,t){return new Tl(n,{minFilter:Jn,generateMipmaps:e,type:Wt,colorSpace:_s,depthBuffer:t})}function ws(n,e,t){return new xi({name:n,uniforms:e,vertexShader:ke.cube_vert,fragmentShader:t,side:Vt,blending:fi,depthTest:!1,depthWrite:!1})}function L0(){return ws("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${xd}u

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
	`)}function D0(){return ws("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Sd}},`

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
	`)}function N0(){return ws("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${A0}
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
	`)}function Kc(){return ws("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Zc(){return ws("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function I0(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,g=!1){return h==null?null:g?a(h):r(h)}function r(h){if(h&&h.isTexture){const g=h.mapping;if(g===fa||g===pa)if(e.has(h)){const _=e.get(h).texture;return o(_,h.mapping)}else{const _=h.image;if(_&&_.height>0){const y=new Tl(_.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",c),o(y.texture,h.mapping)}else return null}}return h}function a(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){const g=h.mapping,_=g===fa||g===pa,y=g===zi||g===ms;if(_||y){let d=t.get(h);const m=d!==void 0?d.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Fr(n)),d=_?i.fromEquirectangular(h,d):i.fromCubemap(h,d),d.texture.pmremVersion=h.pmremVersion,t.set(h,d),d.texture;if(d!==void 0)return d.texture;{const x=h.image;return _&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new Fr(n)),d=_?i.fromEquirectangular(h):i.fromCubemap(h),d.texture.pmremVersion=h.pmremVersion,t.set(h,d),h.addEventListener("dispose",u),d.texture):null}}}return h}function o(h,g){return g===fa?h.mapping=zi:g===pa&&(h.mapping=ms),h}function l(h){let g=0;const _=6;for(let y=0;y<_;y++)h[y]!==void 0&&g++;return g===_}function c(h){const g=h.target;g.removeEventListener("dispose",c);const _=e.get(g);_!==void 0&&(e.delete(g),_.dispose())}function u(h){const g=h.target;g.removeEventListener("dispose",u);const _=t.get(g);_!==void 0&&(t.delete(g),_.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function U0(n){const e={};function t(i){if(e[i]!==void 0)return e[i];const s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const s=t(i);return s===null&&pr("WebGLRenderer: "+i+" extension not supported."),s}}}function F0(n,e,t,i){const s={},r=new WeakMap,a=new FinalizationRegistry(_=>delete s[_]);function o(_){l(_.target)}function l(_){_.index!==null&&e.remove(_.index);for(const d in _.attributes)e.remove(_.attributes[d]);_.removeEventListener("dispose",o),delete s[_.id],a.unregister(_);const y=r.get(_);y&&(e.remove(y),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}function c(_,y){return s[y.id]!==void 0||(y.addEventListener("dispose",o),s[y.id]=new WeakRef(y),a.register(y,y.id,y),t.memory.geometries++),y}function u(_){const y=_.attributes;for(const d in y)e.update(y[d],n.ARRAY_BUFFER)}function f(_){const y=_.index,d=_.attributes.position;let m=0;if(d===void 0)return;const x=y!==null?y.array.length:d.array.length/3-1,T=d.count>=65535?hd:ud,S=new T(Math.ceil(x/3)*6,1),E=S.array;if(y!==null){const p=y.array;m=y.version;for(let w=0,N=0;w<x;w+=3){const C=p[w+0],L=p[w+1],k=p[w+2];E[N++]=C,E[N++]=L,E[N++]=L,E[N++]=k,E[N++]=k,E[N++]=C}}else{m=d.version;for(let p=0,w=0;p<x;p+=3){const N=p+0,C=p+1,L=p+2;E[w++]=N,E[w++]=C,E[w++]=C,E[w++]=L,E[w++]=L,E[w++]=N}}S.version=m;const A=r.get(_);A&&e.remove(A),r.set(_,S)}function h(_){const y=r.get(_);if(y){const d=_.index;d!==null&&y.version<d.version&&f(_)}else f(_);return r.get(_)}function g(){for(const _ in s){const y=s[_].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:g}}function O0(n,e,t){let i;function s(f){i=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*a),t.update(h,i,1)}function c(f,h,g){g!==0&&(n.drawElementsInstanced(i,h,r,f*a,g),t.update(h,i,g))}function u(f,h,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,g);let y=0;for(let d=0;d<g;d++)y+=h[d];t.update(y,i,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function k0(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(t.calls++,a){case n.TRIANGLES:t.triangles+=o*(r/3);break;case n.LINES:t.lines+=o*(r/2);break;case n.LINE_STRIP:t.lines+=o*(r-1);break;case n.LINE_LOOP:t.lines+=o*r;break;case n.POINTS:t.points+=o*r;break;default:qe("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function B0(n,e,t){const i=new WeakMap,s=new ht;function r(a,o,l){const c=a.morphTargetInfluences,u=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=u!==void 0?u.length:0;let h=i.get(o);if(h===void 0||h.count!==f){let C=function(){w.dispose(),i.delete(o),o.removeEventListener("dispose",C)};var g=C;h!==void 0&&h.texture.dispose();const _=o.morphAttributes.position!==void 0,y=o.morphAttributes.normal!==void 0,d=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],x=o.morphAttributes.normal||[],T=o.morphAttributes.color||[];let S=0;_===!0&&(S=1),y===!0&&(S=2),d===!0&&(S=3);let E=o.attributes.position.count*S,A=1;E>e.maxTextureSize&&(A=Math.ceil(E/e.maxTextureSize),E=e.maxTextureSize);const p=new Float32Array(E*A*4*f),w=new od(p,E,A,f);w.type=Ot,w.needsUpdate=!0;const N=S*4;for(let L=0;L<f;L++){const k=m[L],X=x[L],I=T[L],V=E*A*4*L;for(let Q=0;Q<k.count;Q++){const z=Q*N;_===!0&&(s.fromBufferAttribute(k,Q),p[V+z+0]=s.x,p[V+z+1]=s.y,p[V+z+2]=s.z,p[V+z+3]=0),y===!0&&(s.fromBufferAttribute(X,Q),p[V+z+4]=s.x,p[V+z+5]=s.y,p[V+z+6]=s.z,p[V+z+7]=0),d===!0&&(s.fromBufferAttribute(I,Q),p[V+z+8]=s.x,p[V+z+9]=s.y,p[V+z+10]=s.z,p[V+z+11]=I.itemSize===4?s.w:1)}}h={count:f,texture:w,size:new Xe(E,A)},i.set(o,h),o.addEventListener("dispose",C)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,t);else{let _=0;for(let d=0;d<c.length;d++)_+=c[d];const y=o.morphTargetsRelative?1:1-_;l.getUniforms().setValue(n,"morphTargetBaseInfluence",y),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function z0(n,e,t,i,s){let r=new WeakMap;function a(c){const u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){const g=c.skeleton;r.get(g)!==u&&(g.update(),r.set(g,u))}return h}function o(){r=new WeakMap}function l(c){const u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:a,dispose:o}}const H0={[Vh]:"LINEAR_TONE_MAPPING",[Wh]:"REINHARD_TONE_MAPPING",[Xh]:"CINEON_TONE_MAPPING",[$h]:"ACES_FILMIC_TONE_MAPPING",[Yh]:"AGX_TONE_MAPPING",[Kh]:"NEUTRAL_TONE_MAPPING",[qh]:"CUSTOM_TONE_MAPPING"};function G0(n,e,t,i,s,r){const a=new fn(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1});let o=null,l=null,c=null;const u=new Bn;u.setAttribute("position",new kn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new kn([0,2,0,0,2,0],2));const f=new gd({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new ii(u,f),g=new Om(-1,1,1,-1,0,1);let _=null,y=null,d=!1,m,x=null,T=[],S=!1;this.setSize=function(E,A){a.setSize(E,A),o!==null&&o.setSize(E,A),l!==null&&l.setSize(E,A);for(let p=0;p<T.length;p++){const w=T[p];w.setSize&&w.setSize(E,A)}},this.setEffects=function(E){T=E,S=T.length>0&&T[0].isRenderPass===!0;const A=a.width,p=a.height;T.length>0&&o===null&&(o=new fn(A,p,{type:Wt,depthBuffer:!1,stencilBuffer:!1}),l=new fn(A,p,{type:Wt,depthBuffer:!1,stencilBuffer:!1}));const w=s===!0&&T.some(N=>N.needsDepthTexture===!0);w!==(a.depthTexture!==null)&&(w===!0&&c===null&&(c=new Gi(A,p),r===!0&&(c.format=Qn,c.type=Hi)),a.dispose(),a.depthTexture=w?c:null,a.resolveDepthBuffer=w,a.storeMultisampledDepthBuffer=w);for(let N=0;N<T.length;N++){const C=T[N];C.setSize&&C.setSize(A,p),w&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(E,A){if(d||E.toneMapping===Fn&&T.length===0)return!1;if(x=A,A!==null){const p=A.width,w=A.height;(a.width!==p||a.height!==w)&&this.setSize(p,w)}return S===!1&&E.setRenderTarget(a),m=E.toneMapping,E.toneMapping=Fn,!0},this.hasRenderPass=function(){return S},this.end=function(E,A){E.toneMapping=m,d=!0;let p=a,w=o;for(let N=0;N<T.length;N++){const C=T[N];C.enabled!==!1&&(C.render(E,w,p,A),C.needsSwap!==!1&&(p=w,w=w===o?l:o))}if(_!==E.outputColorSpace||y!==E.toneMapping){_=E.outputColorSpace,y=E.toneMapping,f.defines={},Ve.getTransfer(_)===Je&&(f.defines.SRGB_TRANSFER="");const N=H0[y];N&&(f.defines[N]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=p.texture,E.setRenderTarget(x),E.render(h,g),x=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}const Md=new kt,yd=new Gi(1,1),Ed=new fd(1),bd=new od,wd=new Vo,Td=new dd,Jc=[],Qc=[],jc=new Float32Array(16),eu=new Float32Array(9),tu=new Float32Array(4);function Yi(n,e,t){const i=n[0];if(i<=0||i>0)return n;const s=e*t;let r=Jc[s];if(r===void 0&&(r=new Float32Array(s),Jc[s]=r),e!==0){i.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,n[a].toArray(r,o)}return r}function Mt(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function yt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function ta(n,e){let t=Qc[e];t===void 0&&(t=new Int32Array(e),Qc[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function V0(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function W0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mt(t,e))return;n.uniform2fv(this.addr,e),yt(t,e)}}function X0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Mt(t,e))return;n.uniform3fv(this.addr,e),yt(t,e)}}function $0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mt(t,e))return;n.uniform4fv(this.addr,e),yt(t,e)}}function q0(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Mt(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),yt(t,e)}else{if(Mt(t,i))return;tu.set(i),n.uniformMatrix2fv(this.addr,!1,tu),yt(t,i)}}function Y0(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Mt(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),yt(t,e)}else{if(Mt(t,i))return;eu.set(i),n.uniformMatrix3fv(this.addr,!1,eu),yt(t,i)}}function K0(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Mt(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),yt(t,e)}else{if(Mt(t,i))return;jc.set(i),n.uniformMatrix4fv(this.addr,!1,jc),yt(t,i)}}function Z0(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function J0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mt(t,e))return;n.uniform2iv(this.addr,e),yt(t,e)}}function Q0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mt(t,e))return;n.uniform3iv(this.addr,e),yt(t,e)}}function j0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mt(t,e))return;n.uniform4iv(this.addr,e),yt(t,e)}}function ev(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function tv(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mt(t,e))return;n.uniform2uiv(this.addr,e),yt(t,e)}}function nv(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mt(t,e))return;n.uniform3uiv(this.addr,e),yt(t,e)}}function iv(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mt(t,e))return;n.uniform4uiv(this.addr,e),yt(t,e)}}function na(n){return n.version===0&&(n.compareFunction=rd,n.needsUpdate=!0),n}function sv(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=na(yd):r=Md,t.setTexture2D(e||r,s)}function rv(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||wd,s)}function av(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=na(Ed):r=Td,t.setTextureCube(e||r,s)}function ov(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||bd,s)}function lv(n){switch(n){case 5126:return V0;case 35664:return W0;case 35665:return X0;case 35666:return $0;case 35674:return q0;case 35675:return Y0;case 35676:return K0;case 5124:case 35670:return Z0;case 35667:case 35671:return J0;case 35668:case 35672:return Q0;case 35669:case 35673:return j0;case 5125:return ev;case 36294:return tv;case 36295:return nv;case 36296:return iv;case 35678:case 36198:case 36298:case 36306:case 35682:return sv;case 35679:case 36299:case 36307:return rv;case 35680:case 36300:case 36308:case 36293:return av;case 36289:case 36303:case 36311:case 36292:return ov}}function cv(n,e){n.uniform1fv(this.addr,e)}function uv(n,e){const t=Yi(e,this.size,2);n.uniform2fv(this.addr,t)}function hv(n,e){const t=Yi(e,this.size,3);n.uniform3fv(this.addr,t)}function dv(n,e){const t=Yi(e,this.size,4);n.uniform4fv(this.addr,t)}function fv(n,e){const t=Yi(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function pv(n,e){const t=Yi(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function mv(n,e){const t=Yi(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function gv(n,e){n.uniform1iv(this.addr,e)}function _v(n,e){n.uniform2iv(this.addr,e)}function vv(n,e){n.uniform3iv(this.addr,e)}function xv(n,e){n.uniform4iv(this.addr,e)}function Sv(n,e){n.uniform1uiv(this.addr,e)}function Mv(n,e){n.uniform2uiv(this.addr,e)}function yv(n,e){n.uniform3uiv(this.addr,e)}function Ev(n,e){n.uniform4uiv(this.addr,e)}function bv(n,e,t){const i=this.cache,s=e.length,r=ta(t,s);Mt(i,r)||(n.uniform1iv(this.addr,r),yt(i,r));let a;this.type===n.SAMPLER_2D_SHADOW?a=na(yd):a=Md;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function wv(n,e,t){const i=this.cache,s=e.length,r=ta(t,s);Mt(i,r)||(n.uniform1iv(this.addr,r),yt(i,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||wd,r[a])}function Tv(n,e,t){const i=this.cache,s=e.length,r=ta(t,s);Mt(i,r)||(n.uniform1iv(this.addr,r),yt(i,r));let a;this.type===n.SAMPLER_CUBE_SHADOW?a=na(Ed):a=Td;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function Av(n,e,t){const i=this.cache,s=e.length,r=ta(t,s);Mt(i,r)||(n.uniform1iv(this.addr,r),yt(i,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||bd,r[a])}function Rv(n){switch(n){case 5126:return cv;case 35664:return uv;case 35665:return hv;case 35666:return dv;case 35674:return fv;case 35675:return pv;case 35676:return mv;case 5124:case 35670:return gv;case 35667:case 35671:return _v;case 35668:case 35672:return vv;case 35669:case 35673:return xv;case 5125:return Sv;case 36294:return Mv;case 36295:return yv;case 36296:return Ev;case 35678:case 36198:case 36298:case 36306:case 35682:return bv;case 35679:case 36299:case 36307:return wv;case 35680:case 36300:case 36308:case 36293:return Tv;case 36289:case 36303:case 36311:case 36292:return Av}}class Cv{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=lv(t.type)}}class Pv{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Rv(t.type)}}class Lv{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const s=this.seq;for(let r=0,a=s.length;r!==a;++r){const o=s[r];o.setValue(e,t[o.id],i)}}}const Ba=/(\w+)(\])?(\[|\.)?/g;function nu(n,e){n.seq.push(e),n.map[e.id]=e}function Dv(n,e,t){const i=n.name,s=i.length;for(Ba.lastIndex=0;;){const r=Ba.exec(i),a=Ba.lastIndex;let o=r[1];const l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){nu(t,c===void 0?new Cv(o,n,e):new Pv(o,n,e));break}else{let f=t.map[o];f===void 0&&(f=new Lv(o),nu(t,f)),t=f}}}class mr{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){const o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);Dv(o,l,this)}const s=[],r=[];for(const a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){const r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){const s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,a=t.length;r!==a;++r){const o=t[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){const i=[];for(let s=0,r=e.length;s!==r;++s){const a=e[s];a.id in t&&i.push(a)}return i}}function iu(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const Nv=37297;let Iv=0;function Uv(n,e){const t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){const o=a+1;i.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return i.join(`
`)}const su=new De;function Fv(n){Ve._getMatrix(su,Ve.workingColorSpace,n);const e=`mat3( ${su.elements.map(t=>t.toFixed(4))} )`;switch(Ve.getTransfer(n)){case Dr:return[e,"LinearTransferOETF"];case Je:return[e,"sRGBTransferOETF"];default:return Pe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function ru(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";const a=/ERROR: 0:(\d+)/.exec(r);if(a){const o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+Uv(n.getShaderSource(e),o)}else return r}function Ov(n,e){const t=Fv(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}const kv={[Vh]:"Linear",[Wh]:"Reinhard",[Xh]:"Cineon",[$h]:"ACESFilmic",[Yh]:"AgX",[Kh]:"Neutral",[qh]:"Custom"};function Bv(n,e){const t=kv[e];return t===void 0?(Pe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const er=new W;function zv(){Ve.getLuminanceCoefficients(er);const n=er.x.toFixed(4),e=er.y.toFixed(4),t=er.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Hv(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(is).join(`
`)}function Gv(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Vv(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(e,s),a=r.name;let o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:n.getAttribLocation(e,a),locationSize:o}}return t}function is(n){return n!==""}function au(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function ou(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const Wv=/^[ \t]*#include +<([\w\d./]+)>/gm;function $o(n){return n.replace(Wv,Xv)}function Xv(n,e){const t=ke[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return $o(t)}const $v=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function lu(n){return n.replace($v,qv)}function qv(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function cu(n){let e=`precision ${n.precision} float;
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
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}const Yv={[cr]:"SHADOWMAP_TYPE_PCF",[ns]:"SHADOWMAP_TYPE_VSM"};function Kv(n){return Yv[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const Zv={[ms]:"ENVMAP_MODE_REFRACTION"};function Jv(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Zv[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}const Qv={[Gh]:"ENVMAP_BLENDING_MULTIPLY",[kp]:"ENVMAP_BLENDING_MIX",[Bp]:"ENVMAP_BLENDING_ADD"};function jv(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Qv[n.combine]||"ENVMAP_BLENDING_NONE"}function ex(n,e,t,i){const s=n.getContext(),r=t.defines;let a=t.vertexShader,o=t.fragmentShader;const l=Kv(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Jv(t),f=jv(t),h=Hv(t),g=Gv(r),_=s.createProgram();let y,d,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(is).join(`
`),y.length>0&&(y+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(is).join(`
`),d.length>0&&(d+=`
`)):(y=[cu(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(is).join(`
`),d=[cu(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Fn?"#define TONE_MAPPING":"",t.toneMapping!==Fn?ke.tonemapping_pars_fragment:"",t.toneMapping!==Fn?Bv("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ke.colorspace_pars_fragment,Ov("linearToOutputTexel",t.outputColorSpace),zv(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(is).join(`
`)),a=$o(a),a=au(a,t),a=ou(a,t),o=$o(o),o=au(o,t),o=ou(o,t),a=lu(a),o=lu(o),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,d=["#define varying in",t.glslVersion===Ho?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ho?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);const x=m+y+a,T=m+d+o,S=iu(s,s.VERTEX_SHADER,x),E=iu(s,s.FRAGMENT_SHADER,T);s.attachShader(_,S),s.attachShader(_,E),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function A(C){if(n.debug.checkShaderErrors){const L=s.getProgramInfoLog(_)||"",k=s.getShaderInfoLog(S)||"",X=s.getShaderInfoLog(E)||"",I=L.trim(),V=k.trim(),Q=X.trim();let z=!0,q=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,S,E);else{const G=ru(s,S,"vertex"),j=ru(s,E,"fragment");qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+I+`
`+G+`
`+j)}else I!==""?Pe("WebGLProgram: Program Info Log:",I):(V===""||Q==="")&&(q=!1);q&&(C.diagnostics={runnable:z,programLog:I,vertexShader:{log:V,prefix:y},fragmentShader:{log:Q,prefix:d}})}s.deleteShader(S),s.deleteShader(E),p=new mr(s,_),w=Vv(s,_)}let p;this.getUniforms=function(){return p===void 0&&A(this),p};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let N=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(_,Nv)),N},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Iv++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=S,this.fragmentShader=E,this}let tx=0;class nx{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){const s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new ix(e),t.set(e,i)),i}}class ix{constructor(e){this.id=tx++,this.code=e,this.usedTimes=0}}function sx(n){return n===_i||n===Pr||n===Lr}function rx(n,e,t,i,s,r){const a=new ld,o=new nx,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function g(p){return l.add(p),p===0?"uv":`uv${p}`}function _(p,w,N,C,L,k){const X=C.fog,I=L.geometry,V=p.isMeshStandardMaterial||p.isMeshLambertMaterial||p.isMeshPhongMaterial?C.environment:null,Q=p.isMeshStandardMaterial||p.isMeshLambertMaterial&&!p.envMap||p.isMeshPhongMaterial&&!p.envMap,z=e.get(p.envMap||V,Q),q=h[p.type];let G=i.precision;p.precision!==null&&(G=i.getMaxPrecision(p.precision),G!==p.precision&&Pe("WebGLProgram.getParameters:",p.precision,"not supported, using",G,"instead."));const j=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,te=j!==void 0?j.length:0;let Ee=0;I.morphAttributes.position!==void 0&&(Ee=1),I.morphAttributes.normal!==void 0&&(Ee=2),I.morphAttributes.color!==void 0&&(Ee=3);let Ne,Z,me,Se;if(q){const fe=xn[q];Ne=fe.vertexShader,Z=fe.fragmentShader}else{Ne=p.vertexShader,Z=p.fragmentShader;const fe=o.getVertexShaderStage(p),Ze=o.getFragmentShaderStage(p);o.update(p,fe,Ze),me=fe.id,Se=Ze.id}const Ae=n.getRenderTarget(),ge=n.state.buffers.depth.getReversed(),Ue=L.isInstancedMesh===!0,pt=L.isBatchedMesh===!0,Ce=!!p.map,Ke=!!p.matcap,je=!!z,Be=je&&z.isPMREMTexture===!0,At=!!p.aoMap,xt=!!p.lightMap,zt=!!p.bumpMap&&p.wireframe===!1,ct=!!p.normalMap,mn=!!p.displacementMap,Et=!!p.emissiveMap,Yt=!!p.metalnessMap,Kt=!!p.roughnessMap,Zt=p.anisotropy>0,U=p.clearcoat>0,Jt=p.diffuseRoughness>0,at=p.dispersion>0,ot=p.retroreflectivity>0,de=p.iridescence>0,St=p.sheen>0,Re=p.transmission>0,Le=Zt&&!!p.anisotropyMap,R=U&&!!p.clearcoatMap,v=U&&!!p.clearcoatNormalMap,O=U&&!!p.clearcoatRoughnessMap,ne=Jt&&!!p.diffuseRoughnessMap,ee=de&&!!p.iridescenceMap,re=de&&!!p.iridescenceThicknessMap,ue=St&&!!p.sheenColorMap,Y=St&&!!p.sheenRoughnessMap,K=!!p.specularMap,oe=!!p.specularColorMap,P=!!p.specularIntensityMap,J=Re&&!!p.transmissionMap,$=Re&&!!p.thicknessMap,le=!!p.gradientMap,se=!!p.alphaMap,ae=p.alphaTest>0,we=!!p.alphaHash,Oe=!!p.extensions;let ie=Fn;p.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ie=n.toneMapping);const Te=Be?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,Fe={shaderID:q,shaderType:p.type,shaderName:p.name,vertexShader:Ne,fragmentShader:Z,defines:p.defines,customVertexShaderID:me,customFragmentShaderID:Se,isRawShaderMaterial:p.isRawShaderMaterial===!0,glslVersion:p.glslVersion,precision:G,batching:pt,batchingColor:pt&&L._colorsTexture!==null,instancing:Ue,instancingColor:Ue&&L.instanceColor!==null,instancingMorph:Ue&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:Ve.workingColorSpace,alphaToCoverage:!!p.alphaToCoverage,map:Ce,matcap:Ke,envMap:je,envMapMode:je&&z.mapping,envMapPMREM:Be,envMapMaxLod:Be?Te.length-1:null,envMapSize:Be?Te[0].width:null,aoMap:At,lightMap:xt,bumpMap:zt,normalMap:ct,displacementMap:mn,emissiveMap:Et,normalMapObjectSpace:ct&&p.normalMapType===Gp,normalMapTangentSpace:ct&&p.normalMapType===wc,packedNormalMap:ct&&p.normalMapType===wc&&sx(p.normalMap.format),metalnessMap:Yt,roughnessMap:Kt,anisotropy:Zt,anisotropyMap:Le,clearcoat:U,clearcoatMap:R,clearcoatNormalMap:v,clearcoatRoughnessMap:O,diffuseRoughness:Jt,diffuseRoughnessMap:ne,dispersion:at,retroreflection:ot,iridescence:de,iridescenceMap:ee,iridescenceThicknessMap:re,sheen:St,sheenColorMap:ue,sheenRoughnessMap:Y,specularMap:K,specularColorMap:oe,specularIntensityMap:P,transmission:Re,transmissionMap:J,thicknessMap:$,gradientMap:le,opaque:p.transparent===!1&&p.blending===cs&&p.alphaToCoverage===!1,alphaMap:se,alphaTest:ae,alphaHash:we,combine:p.combine,mapUv:Ce&&g(p.map.channel),aoMapUv:At&&g(p.aoMap.channel),lightMapUv:xt&&g(p.lightMap.channel),bumpMapUv:zt&&g(p.bumpMap.channel),normalMapUv:ct&&g(p.normalMap.channel),displacementMapUv:mn&&g(p.displacementMap.channel),emissiveMapUv:Et&&g(p.emissiveMap.channel),metalnessMapUv:Yt&&g(p.metalnessMap.channel),roughnessMapUv:Kt&&g(p.roughnessMap.channel),anisotropyMapUv:Le&&g(p.anisotropyMap.channel),clearcoatMapUv:R&&g(p.clearcoatMap.channel),clearcoatNormalMapUv:v&&g(p.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:O&&g(p.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&g(p.diffuseRoughnessMap.channel),iridescenceMapUv:ee&&g(p.iridescenceMap.channel),iridescenceThicknessMapUv:re&&g(p.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&g(p.sheenColorMap.channel),sheenRoughnessMapUv:Y&&g(p.sheenRoughnessMap.channel),specularMapUv:K&&g(p.specularMap.channel),specularColorMapUv:oe&&g(p.specularColorMap.channel),specularIntensityMapUv:P&&g(p.specularIntensityMap.channel),transmissionMapUv:J&&g(p.transmissionMap.channel),thicknessMapUv:$&&g(p.thicknessMap.channel),alphaMapUv:se&&g(p.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(ct||Zt),vertexNormals:!!I.attributes.normal,vertexColors:p.vertexColors,vertexAlphas:p.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!I.attributes.uv&&(Ce||se),fog:!!X,useFog:p.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:p.wireframe===!1&&(p.flatShading===!0||I.attributes.normal===void 0&&ct===!1&&(p.isMeshLambertMaterial||p.isMeshPhongMaterial||p.isMeshStandardMaterial||p.isMeshPhysicalMaterial)),sizeAttenuation:p.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ge,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:Ee,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:k.filter(fe=>fe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:p.dithering,shadowMapEnabled:n.shadowMap.enabled&&N.length>0,shadowMapType:n.shadowMap.type,toneMapping:ie,decodeVideoTexture:Ce&&p.map.isVideoTexture===!0&&Ve.getTransfer(p.map.colorSpace)===Je,decodeVideoTextureEmissive:Et&&p.emissiveMap.isVideoTexture===!0&&Ve.getTransfer(p.emissiveMap.colorSpace)===Je,premultipliedAlpha:p.premultipliedAlpha,doubleSided:p.side===Sn,flipSided:p.side===Vt,useDepthPacking:p.depthPacking>=0,depthPacking:p.depthPacking||0,index0AttributeName:p.index0AttributeName,extensionClipCullDistance:Oe&&p.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&p.extensions.multiDraw===!0||pt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:p.customProgramCacheKey()};return Fe.vertexUv1s=l.has(1),Fe.vertexUv2s=l.has(2),Fe.vertexUv3s=l.has(3),l.clear(),Fe}function y(p){const w=[];if(p.shaderID?w.push(p.shaderID):(w.push(p.customVertexShaderID),w.push(p.customFragmentShaderID)),p.defines!==void 0)for(const N in p.defines)w.push(N),w.push(p.defines[N]);return p.isRawShaderMaterial===!1&&(d(w,p),m(w,p),w.push(n.outputColorSpace)),w.push(p.customProgramCacheKey),w.join()}function d(p,w){p.push(w.precision),p.push(w.outputColorSpace),p.push(w.envMapMode),p.push(w.envMapPMREM),p.push(w.envMapMaxLod),p.push(w.envMapSize),p.push(w.mapUv),p.push(w.alphaMapUv),p.push(w.lightMapUv),p.push(w.aoMapUv),p.push(w.bumpMapUv),p.push(w.normalMapUv),p.push(w.displacementMapUv),p.push(w.emissiveMapUv),p.push(w.metalnessMapUv),p.push(w.roughnessMapUv),p.push(w.anisotropyMapUv),p.push(w.clearcoatMapUv),p.push(w.clearcoatNormalMapUv),p.push(w.clearcoatRoughnessMapUv),p.push(w.diffuseRoughnessMapUv),p.push(w.iridescenceMapUv),p.push(w.iridescenceThicknessMapUv),p.push(w.sheenColorMapUv),p.push(w.sheenRoughnessMapUv),p.push(w.specularMapUv),p.push(w.specularColorMapUv),p.push(w.specularIntensityMapUv),p.push(w.transmissionMapUv),p.push(w.thicknessMapUv),p.push(w.combine),p.push(w.fogExp2),p.push(w.sizeAttenuation),p.push(w.morphTargetsCount),p.push(w.numSunLights),p.push(w.numDirLights),p.push(w.numPointLights),p.push(w.numSpotLights),p.push(w.numSpotLightMaps),p.push(w.numHemiLights),p.push(w.numRectAreaLights),p.push(w.numSunLightShadows),p.push(w.numDirLightShadows),p.push(w.numPointLightShadows),p.push(w.numSpotLightShadows),p.push(w.numSpotLightShadowsWithMaps),p.push(w.numLightProbes),p.push(w.numLightProbeGrids),p.push(w.shadowMapType),p.push(w.toneMapping),p.push(w.numClippingPlanes),p.push(w.numClipIntersection),p.push(w.depthPacking)}function m(p,w){a.disableAll(),w.instancing&&a.enable(0),w.instancingColor&&a.enable(1),w.instancingMorph&&a.enable(2),w.matcap&&a.enable(3),w.envMap&&a.enable(4),w.normalMapObjectSpace&&a.enable(5),w.normalMapTangentSpace&&a.enable(6),w.clearcoat&&a.enable(7),w.iridescence&&a.enable(8),w.alphaTest&&a.enable(9),w.vertexColors&&a.enable(10),w.vertexAlphas&&a.enable(11),w.vertexUv1s&&a.enable(12),w.vertexUv2s&&a.enable(13),w.vertexUv3s&&a.enable(14),w.vertexTangents&&a.enable(15),w.anisotropy&&a.enable(16),w.alphaHash&&a.enable(17),w.batching&&a.enable(18),w.dispersion&&a.enable(19),w.retroreflection&&a.enable(24),w.diffuseRoughness&&a.enable(25),w.batchingColor&&a.enable(20),w.gradientMap&&a.enable(21),w.packedNormalMap&&a.enable(22),w.vertexNormals&&a.enable(23),p.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),w.numLightProbeGrids>0&&a.enable(22),w.hasPositionAttribute&&a.enable(23),p.push(a.mask)}function x(p){const w=h[p.type];let N;if(w){const C=xn[w];N=Dm.clone(C.uniforms)}else N=p.uniforms;return N}function T(p,w){let N=u.get(w);return N!==void 0?++N.usedTimes:(N=new ex(n,w,p,s),c.push(N),u.set(w,N)),N}function S(p){if(--p.usedTimes===0){const w=c.indexOf(p);c[w]=c[c.length-1],c.pop(),u.delete(p.cacheKey),p.destroy()}}function E(p){o.remove(p)}function A(){o.dispose()}return{getParameters:_,getProgramCacheKey:y,getUniforms:x,acquireProgram:T,releaseProgram:S,releaseShaderCache:E,programs:c,dispose:A}}function ax(){let n=new WeakMap;function e(a){return n.has(a)}function t(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,l){n.get(a)[o]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function ox(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function uu(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function hu(){const n=[];let e=0;const t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function a(h){let g=0;return h.isInstancedMesh&&(g+=2),h.isSkinnedMesh&&(g+=1),g}function o(h,g,_,y,d,m){let x=n[e];return x===void 0?(x={id:h.id,object:h,geometry:g,material:_,materialVariant:a(h),groupOrder:y,renderOrder:h.renderOrder,z:d,group:m},n[e]=x):(x.id=h.id,x.object=h,x.geometry=g,x.material=_,x.materialVariant=a(h),x.groupOrder=y,x.renderOrder=h.renderOrder,x.z=d,x.group=m),e++,x}function l(h,g,_,y,d,m,x){x.reversedDepth===!0&&(d=-d);const T=o(h,g,_,y,d,m);_.transmission>0?i.push(T):_.transparent===!0?s.push(T):t.push(T)}function c(h,g,_,y,d,m){const x=o(h,g,_,y,d,m);_.transmission>0?i.unshift(x):_.transparent===!0?s.unshift(x):t.unshift(x)}function u(h,g){t.length>1&&t.sort(h||ox),i.length>1&&i.sort(g||uu),s.length>1&&s.sort(g||uu)}function f(){for(let h=e,g=n.length;h<g;h++){const _=n[h];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function lx(){let n=new WeakMap;function e(i,s){const r=n.get(i);let a;return r===void 0?(a=new hu,n.set(i,[a])):s>=r.length?(a=new hu,r.push(a)):a=r[s],a}function t(){n=new WeakMap}return{get:e,dispose:t}}function cx(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new W,color:new Ye};break;case"SpotLight":t={position:new W,direction:new W,color:new Ye,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new W,color:new Ye,distance:0,decay:0};break;case"HemisphereLight":t={direction:new W,skyColor:new Ye,groundColor:new Ye};break;case"RectAreaLight":t={color:new Ye,position:new W,halfWidth:new W,halfHeight:new W};break}return n[e.id]=t,t}}}function ux(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let hx=0;function dx(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function fx(n){const e=new cx,t=ux(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);const s=new W,r=new ft,a=new ft;function o(c){let u=0,f=0,h=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let g=0,_=0,y=0,d=0,m=0,x=0,T=0,S=0,E=0,A=0,p=0,w=0,N=0,C=0;c.sort(dx);for(let k=0,X=c.length;k<X;k++){const I=c[k],V=I.color,Q=I.intensity,z=I.distance;let q=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===_i?q=I.shadow.map.texture:q=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=V.r*Q,f+=V.g*Q,h+=V.b*Q;else if(I.isLightProbe){for(let G=0;G<9;G++)i.probe[G].addScaledVector(I.sh.coefficients[G],Q);C++}else if(I.isSunLight){const G=e.get(I);if(G.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){const j=I.shadow,te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[_]=te,i.sunShadowMap[_]=q;const Ee=j.getViewportCount();for(let Ne=0;Ne<Ee;Ne++)i.sunShadowMatrix[y+Ne]=j.getMatrix(Ne),i.sunShadowCascade[y+Ne]=j._cascadeData[Ne];y+=Ee,_++}i.sun[g]=G,g++}else if(I.isDirectionalLight){const G=e.get(I);if(G.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){const j=I.shadow,te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.directionalShadow[d]=te,i.directionalShadowMap[d]=q,i.directionalShadowMatrix[d]=I.shadow.matrix,E++}i.directional[d]=G,d++}else if(I.isSpotLight){const G=e.get(I);G.position.setFromMatrixPosition(I.matrixWorld),G.color.copy(V).multiplyScalar(Q),G.distance=z,G.coneCos=Math.cos(I.angle),G.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),G.decay=I.decay,i.spot[x]=G;const j=I.shadow;if(I.map&&(i.spotLightMap[w]=I.map,w++,j.updateMatrices(I),I.castShadow&&N++),i.spotLightMatrix[x]=j.matrix,I.castShadow){const te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.spotShadow[x]=te,i.spotShadowMap[x]=q,p++}x++}else if(I.isRectAreaLight){const G=e.get(I);G.color.copy(V).multiplyScalar(Q),G.halfWidth.set(I.width*.5,0,0),G.halfHeight.set(0,I.height*.5,0),i.rectArea[T]=G,T++}else if(I.isPointLight){const G=e.get(I);if(G.color.copy(I.color).multiplyScalar(I.intensity),G.distance=I.distance,G.decay=I.decay,I.castShadow){const j=I.shadow,te=t.get(I);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,te.shadowCameraNear=j.camera.near,te.shadowCameraFar=j.camera.far,i.pointShadow[m]=te,i.pointShadowMap[m]=q,i.pointShadowMatrix[m]=I.shadow.matrix,A++}i.point[m]=G,m++}else if(I.isHemisphereLight){const G=e.get(I);G.skyColor.copy(I.color).multiplyScalar(Q),G.groundColor.copy(I.groundColor).multiplyScalar(Q),i.hemi[S]=G,S++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=pe.LTC_FLOAT_1,i.rectAreaLTC2=pe.LTC_FLOAT_2):(i.rectAreaLTC1=pe.LTC_HALF_1,i.rectAreaLTC2=pe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;const L=i.hash;(L.sunLength!==g||L.directionalLength!==d||L.pointLength!==m||L.spotLength!==x||L.rectAreaLength!==T||L.hemiLength!==S||L.numSunShadows!==_||L.numDirectionalShadows!==E||L.numPointShadows!==A||L.numSpotShadows!==p||L.numSpotMaps!==w||L.numLightProbes!==C)&&(i.sun.length=g,i.directional.length=d,i.spot.length=x,i.rectArea.length=T,i.point.length=m,i.hemi.length=S,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=p,i.spotShadowMap.length=p,i.spotLightMatrix.length=p+w-N,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=N,i.numLightProbes=C,L.sunLength=g,L.directionalLength=d,L.pointLength=m,L.spotLength=x,L.rectAreaLength=T,L.hemiLength=S,L.numSunShadows=_,L.numDirectionalShadows=E,L.numPointShadows=A,L.numSpotShadows=p,L.numSpotMaps=w,L.numLightProbes=C,i.version=hx++)}function l(c,u){let f=0,h=0,g=0,_=0,y=0,d=0;const m=u.matrixWorldInverse;for(let x=0,T=c.length;x<T;x++){const S=c[x];if(S.isSunLight){const E=i.sun[f];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(m),f++}else if(S.isDirectionalLight){const E=i.directional[h];E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),h++}else if(S.isSpotLight){const E=i.spot[_];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(m),E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),_++}else if(S.isRectAreaLight){const E=i.rectArea[y];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(m),a.identity(),r.copy(S.matrixWorld),r.premultiply(m),a.extractRotation(r),E.halfWidth.set(S.width*.5,0,0),E.halfHeight.set(0,S.height*.5,0),E.halfWidth.applyMatrix4(a),E.halfHeight.applyMatrix4(a),y++}else if(S.isPointLight){const E=i.point[g];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(m),g++}else if(S.isHemisphereLight){const E=i.hemi[d];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(m),d++}}}return{setup:o,setupView:l,state:i}}function du(n){const e=new fx(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):t.push(f)}function o(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}const u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function px(n){let e=new WeakMap;function t(s,r=0){const a=e.get(s);let o;return a===void 0?(o=new du(n),e.set(s,[o])):r>=a.length?(o=new du(n),a.push(o)):o=a[r],o}function i(){e=new WeakMap}return{get:t,dispose:i}}const mx=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,gx=`uniform sampler2D shadow_pass;
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
}`,_x=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],vx=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],fu=new ft,ts=new W,za=new W;function xx(n,e,t){let i=new Ur;const s=new Xe,r=new Xe,a=new ht,o=new Um,l=new Fm,c={},u=t.maxTextureSize,f={[gi]:Vt,[Vt]:gi,[Sn]:Sn},h=new xi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xe},radius:{value:4}},vertexShader:mx,fragmentShader:gx}),g=h.clone();g.defines.HORIZONTAL_PASS=1;const _=new Bn;_.setAttribute("position",new En(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const y=new ii(_,h),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=cr;let m=this.type;this.render=function(A,p,w){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||A.length===0)return;this.type===Mp&&(Pe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=cr);const N=n.getRenderTarget(),C=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),k=n.state;k.setBlending(fi),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);const X=m!==this.type;X&&p.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=A.length;I<V;I++){const Q=A[I],z=Q.shadow;if(z===void 0){Pe("WebGLShadowMap:",Q,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);const q=z.getFrameExtents();s.multiply(q),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/q.x),s.x=r.x*q.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/q.y),s.y=r.y*q.y,z.mapSize.y=r.y));const G=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=G,z.map===null||X===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===ns){if(Q.isPointLight){Pe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new fn(s.x,s.y,{format:_i,type:Wt,minFilter:Pt,magFilter:Pt,generateMipmaps:!1}),z.map.texture.name=Q.name+".shadowMap",z.map.depthTexture=new Gi(s.x,s.y,Ot),z.map.depthTexture.name=Q.name+".shadowMapDepth",z.map.depthTexture.format=ni,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=vt,z.map.depthTexture.magFilter=vt}else Q.isPointLight?(z.map=new Tl(s.x),z.map.depthTexture=new fd(s.x,bn)):(z.map=new fn(s.x,s.y),z.map.depthTexture=new Gi(s.x,s.y,bn)),z.map.depthTexture.name=Q.name+".shadowMap",z.map.depthTexture.format=ni,this.type===cr?(z.map.depthTexture.compareFunction=G?sd:id,z.map.depthTexture.minFilter=Pt,z.map.depthTexture.magFilter=Pt):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=vt,z.map.depthTexture.magFilter=vt);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);const j=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();Q.isPointLight!==!0&&z.updateMatrices(Q,w);const te=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:w.layers;for(let Ee=0;Ee<j;Ee++){const Ne=z.getCamera(Ee);if(Q.isPointLight){const Z=z.camera,me=z.matrix,Se=Q.distance||Z.far;Se!==Z.far&&(Z.far=Se,Z.updateProjectionMatrix()),ts.setFromMatrixPosition(Q.matrixWorld),Z.position.copy(ts),za.copy(Z.position),za.add(_x[Ee]),Z.up.copy(vx[Ee]),Z.lookAt(za),Z.updateMatrixWorld(),me.makeTranslation(-ts.x,-ts.y,-ts.z),fu.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),z._frustum.setFromProjectionMatrix(fu,Z.coordinateSystem,Z.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,Ee),n.clear();else{Ee===0&&(n.setRenderTarget(z.map),n.clear());const Z=z.getViewport(Ee);a.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),k.viewport(a)}i=z.getFrustum(Ee),S(p,w,Ne,Q,te,this.type)}z.isPointLightShadow!==!0&&this.type===ns&&x(z,w),z.needsUpdate=!1}m=this.type,d.needsUpdate=!1,n.setRenderTarget(N,C,L)};function x(A,p){const w=e.update(y);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,g.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,g.needsUpdate=!0),A.mapPass===null?A.mapPass=new fn(s.x,s.y,{format:_i,type:Wt}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(p,null,w,h,y,null),g.uniforms.shadow_pass.value=A.mapPass.texture,g.uniforms.resolution.value.set(A.map.width,A.map.height),g.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(p,null,w,g,y,null)}function T(A,p,w,N){let C=null;const L=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)C=L;else if(C=w.isPointLight===!0?l:o,n.localClippingEnabled&&p.clipShadows===!0&&Array.isArray(p.clippingPlanes)&&p.clippingPlanes.length!==0||p.displacementMap&&p.displacementScale!==0||p.alphaMap&&p.alphaTest>0||p.map&&p.alphaTest>0||p.alphaToCoverage===!0){const k=C.uuid,X=p.uuid;let I=c[k];I===void 0&&(I={},c[k]=I);let V=I[X];V===void 0&&(V=C.clone(),I[X]=V,p.addEventListener("dispose",E)),C=V}if(C.visible=p.visible,C.wireframe=p.wireframe,N===ns?C.side=p.shadowSide!==null?p.shadowSide:p.side:C.side=p.shadowSide!==null?p.shadowSide:f[p.side],C.alphaMap=p.alphaMap,C.alphaTest=p.alphaToCoverage===!0?.5:p.alphaTest,C.map=p.map,C.clipShadows=p.clipShadows,C.clippingPlanes=p.clippingPlanes,C.clipIntersection=p.clipIntersection,C.displacementMap=p.displacementMap,C.displacementScale=p.displacementScale,C.displacementBias=p.displacementBias,C.wireframeLinewidth=p.wireframeLinewidth,C.linewidth=p.linewidth,w.isPointLight===!0&&C.isMeshDistanceMaterial===!0){const k=n.properties.get(C);k.light=w}return C}function S(A,p,w,N,C,L){if(A.visible===!1)return;if(A.layers.test(C)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===ns)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);const I=e.update(A),V=A.material;if(Array.isArray(V)){const Q=I.groups;for(let z=0,q=Q.length;z<q;z++){const G=Q[z],j=V[G.materialIndex];if(j&&j.visible){const te=T(A,j,N,L);A.onBeforeShadow(n,A,p,w,I,te,G),n.renderBufferDirect(w,null,I,te,A,G),A.onAfterShadow(n,A,p,w,I,te,G)}}}else if(V.visible){const Q=T(A,V,N,L);A.onBeforeShadow(n,A,p,w,I,Q,null),n.renderBufferDirect(w,null,I,Q,A,null),A.onAfterShadow(n,A,p,w,I,Q,null)}}const X=A.children;for(let I=0,V=X.length;I<V;I++)S(X[I],p,w,N,C,L)}function E(A){A.target.removeEventListener("dispose",E);for(const w in c){const N=c[w],C=A.target.uuid;C in N&&(N[C].dispose(),delete N[C])}}}function Sx(n,e){function t(){let P=!1;const J=new ht;let $=null;const le=new ht(0,0,0,0);return{setMask:function(se){$!==se&&!P&&(n.colorMask(se,se,se,se),$=se)},setLocked:function(se){P=se},setClear:function(se,ae,we,Oe,ie){ie===!0&&(se*=Oe,ae*=Oe,we*=Oe),J.set(se,ae,we,Oe),le.equals(J)===!1&&(n.clearColor(se,ae,we,Oe),le.copy(J))},reset:function(){P=!1,$=null,le.set(-1,0,0,0)}}}function i(){let P=!1,J=!1,$=null,le=null,se=null;return{setReversed:function(ae){if(J!==ae){const we=e.get("EXT_clip_control");ae?we.clipControlEXT(we.LOWER_LEFT_EXT,we.ZERO_TO_ONE_EXT):we.clipControlEXT(we.LOWER_LEFT_EXT,we.NEGATIVE_ONE_TO_ONE_EXT),J=ae;const Oe=se;se=null,this.setClear(Oe)}},getReversed:function(){return J},setTest:function(ae){ae?ge(n.DEPTH_TEST):Ue(n.DEPTH_TEST)},setMask:function(ae){$!==ae&&!P&&(n.depthMask(ae),$=ae)},setFunc:function(ae){if(J&&(ae=jp[ae]),le!==ae){switch(ae){case io:n.depthFunc(n.NEVER);break;case so:n.depthFunc(n.ALWAYS);break;case Rr:n.depthFunc(n.LESS);break;case ps:n.depthFunc(n.LEQUAL);break;case ro:n.depthFunc(n.EQUAL);break;case ao:n.depthFunc(n.GEQUAL);break;case oo:n.depthFunc(n.GREATER);break;case lo:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}le=ae}},setLocked:function(ae){P=ae},setClear:function(ae){se!==ae&&(se=ae,J&&(ae=1-ae),n.clearDepth(ae))},reset:function(){P=!1,$=null,le=null,se=null,J=!1}}}function s(){let P=!1,J=null,$=null,le=null,se=null,ae=null,we=null,Oe=null,ie=null;return{setTest:function(Te){P||(Te?ge(n.STENCIL_TEST):Ue(n.STENCIL_TEST))},setMask:function(Te){J!==Te&&!P&&(n.stencilMask(Te),J=Te)},setFunc:function(Te,Fe,fe){($!==Te||le!==Fe||se!==fe)&&(n.stencilFunc(Te,Fe,fe),$=Te,le=Fe,se=fe)},setOp:function(Te,Fe,fe){(ae!==Te||we!==Fe||Oe!==fe)&&(n.stencilOp(Te,Fe,fe),ae=Te,we=Fe,Oe=fe)},setLocked:function(Te){P=Te},setClear:function(Te){ie!==Te&&(n.clearStencil(Te),ie=Te)},reset:function(){P=!1,J=null,$=null,le=null,se=null,ae=null,we=null,Oe=null,ie=null}}}const r=new t,a=new i,o=new s;let l={};const c=new WeakMap;let u={},f={},h={},g=new WeakMap,_=[],y=null,d=!1,m=null,x=null,T=null,S=null,E=null,A=null,p=null,w=new Ye(0,0,0),N=0,C=!1,L=null,k=null,X=null,I=null,V=null;const Q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let z=!1,q=0;const G=n.getParameter(n.VERSION);G.indexOf("WebGL")!==-1?(q=parseFloat(/^WebGL (\d)/.exec(G)[1]),z=q>=1):G.indexOf("OpenGL ES")!==-1&&(q=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),z=q>=2);let j=null,te={};const Ee=n.getParameter(n.SCISSOR_BOX),Ne=n.getParameter(n.VIEWPORT),Z=new ht().fromArray(Ee),me=new ht().fromArray(Ne);function Se(P,J,$,le){const se=new Uint8Array(4),ae=n.createTexture();n.bindTexture(P,ae),n.texParameteri(P,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(P,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let we=0;we<$;we++)P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY?n.texImage3D(J,0,n.RGBA,1,1,le,0,n.RGBA,n.UNSIGNED_BYTE,se):n.texImage2D(J+we,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,se);return ae}const Ae={};Ae[n.TEXTURE_2D]=Se(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=Se(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=Se(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=Se(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),ge(n.DEPTH_TEST),a.setFunc(ps),zt(!1),ct(Mc),ge(n.CULL_FACE),At(fi);function ge(P){u[P]!==!0&&(n.enable(P),u[P]=!0)}function Ue(P){u[P]!==!1&&(n.disable(P),u[P]=!1)}function pt(P,J){return h[P]!==J?(n.bindFramebuffer(P,J),h[P]=J,P===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=J),P===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=J),!0):!1}function Ce(P,J){let $=_,le=!1;if(P){$=g.get(J),$===void 0&&($=[],g.set(J,$));const se=P.textures;if($.length!==se.length||$[0]!==n.COLOR_ATTACHMENT0){for(let ae=0,we=se.length;ae<we;ae++)$[ae]=n.COLOR_ATTACHMENT0+ae;$.length=se.length,le=!0}}else $[0]!==n.BACK&&($[0]=n.BACK,le=!0);le&&n.drawBuffers($)}function Ke(P){return y!==P?(n.useProgram(P),y=P,!0):!1}const je={[Fi]:n.FUNC_ADD,[yp]:n.FUNC_SUBTRACT,[Ep]:n.FUNC_REVERSE_SUBTRACT};je[bp]=n.MIN,je[wp]=n.MAX;const Be={[Tp]:n.ZERO,[no]:n.ONE,[Ap]:n.SRC_COLOR,[zh]:n.SRC_ALPHA,[Np]:n.SRC_ALPHA_SATURATE,[Lp]:n.DST_COLOR,[Cp]:n.DST_ALPHA,[Rp]:n.ONE_MINUS_SRC_COLOR,[Hh]:n.ONE_MINUS_SRC_ALPHA,[Dp]:n.ONE_MINUS_DST_COLOR,[Pp]:n.ONE_MINUS_DST_ALPHA,[Ip]:n.CONSTANT_COLOR,[Up]:n.ONE_MINUS_CONSTANT_COLOR,[Fp]:n.CONSTANT_ALPHA,[Op]:n.ONE_MINUS_CONSTANT_ALPHA};function At(P,J,$,le,se,ae,we,Oe,ie,Te){if(P===fi){d===!0&&(Ue(n.BLEND),d=!1);return}if(d===!1&&(ge(n.BLEND),d=!0),P!==Bh){if(P!==m||Te!==C){if((x!==Fi||E!==Fi)&&(n.blendEquation(n.FUNC_ADD),x=Fi,E=Fi),Te)switch(P){case cs:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yc:n.blendFunc(n.ONE,n.ONE);break;case Ec:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case bc:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:qe("WebGLState: Invalid blending: ",P);break}else switch(P){case cs:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case yc:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ec:qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case bc:qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:qe("WebGLState: Invalid blending: ",P);break}T=null,S=null,A=null,p=null,w.set(0,0,0),N=0,m=P,C=Te}return}se=se||J,ae=ae||$,we=we||le,(J!==x||se!==E)&&(n.blendEquationSeparate(je[J],je[se]),x=J,E=se),($!==T||le!==S||ae!==A||we!==p)&&(n.blendFuncSeparate(Be[$],Be[le],Be[ae],Be[we]),T=$,S=le,A=ae,p=we),(Oe.equals(w)===!1||ie!==N)&&(n.blendColor(Oe.r,Oe.g,Oe.b,ie),w.copy(Oe),N=ie),m=P,C=!1}function xt(P,J){P.side===Sn?Ue(n.CULL_FACE):ge(n.CULL_FACE);let $=P.side===Vt;J&&($=!$),zt($),P.blending===cs&&P.transparent===!1?At(fi):At(P.blending,P.blendEquation,P.blendSrc,P.blendDst,P.blendEquationAlpha,P.blendSrcAlpha,P.blendDstAlpha,P.blendColor,P.blendAlpha,P.premultipliedAlpha),a.setFunc(P.depthFunc),a.setTest(P.depthTest),a.setMask(P.depthWrite),r.setMask(P.colorWrite);const le=P.stencilWrite;o.setTest(le),le&&(o.setMask(P.stencilWriteMask),o.setFunc(P.stencilFunc,P.stencilRef,P.stencilFuncMask),o.setOp(P.stencilFail,P.stencilZFail,P.stencilZPass)),Et(P.polygonOffset,P.polygonOffsetFactor,P.polygonOffsetUnits),P.alphaToCoverage===!0?ge(n.SAMPLE_ALPHA_TO_COVERAGE):Ue(n.SAMPLE_ALPHA_TO_COVERAGE)}function zt(P){L!==P&&(P?n.frontFace(n.CW):n.frontFace(n.CCW),L=P)}function ct(P){P!==xp?(ge(n.CULL_FACE),P!==k&&(P===Mc?n.cullFace(n.BACK):P===Sp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ue(n.CULL_FACE),k=P}function mn(P){P!==X&&(z&&n.lineWidth(P),X=P)}function Et(P,J,$){P?(ge(n.POLYGON_OFFSET_FILL),(I!==J||V!==$)&&(I=J,V=$,a.getReversed()&&(J=-J,$=-$),n.polygonOffset(J,$))):Ue(n.POLYGON_OFFSET_FILL)}function Yt(P){P?ge(n.SCISSOR_TEST):Ue(n.SCISSOR_TEST)}function Kt(P){P===void 0&&(P=n.TEXTURE0+Q-1),j!==P&&(n.activeTexture(P),j=P)}function Zt(P,J,$){$===void 0&&(j===null?$=n.TEXTURE0+Q-1:$=j);let le=te[$];le===void 0&&(le={type:void 0,texture:void 0},te[$]=le),(le.type!==P||le.texture!==J)&&(j!==$&&(n.activeTexture($),j=$),n.bindTexture(P,J||Ae[P]),le.type=P,le.texture=J)}function U(){const P=te[j];P!==void 0&&P.type!==void 0&&(n.bindTexture(P.type,null),P.type=void 0,P.texture=void 0)}function Jt(){try{n.compressedTexImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function at(){try{n.compressedTexImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function ot(){try{n.texSubImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function de(){try{n.texSubImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function St(){try{n.compressedTexSubImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function Re(){try{n.compressedTexSubImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function Le(){try{n.texStorage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function R(){try{n.texStorage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function v(){try{n.texImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function O(){try{n.texImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function ne(P){return f[P]!==void 0?f[P]:n.getParameter(P)}function ee(P,J){f[P]!==J&&(n.pixelStorei(P,J),f[P]=J)}function re(P){Z.equals(P)===!1&&(n.scissor(P.x,P.y,P.z,P.w),Z.copy(P))}function ue(P){me.equals(P)===!1&&(n.viewport(P.x,P.y,P.z,P.w),me.copy(P))}function Y(P,J){let $=c.get(J);$===void 0&&($=new WeakMap,c.set(J,$));let le=$.get(P);le===void 0&&(le=n.getUniformBlockIndex(J,P.name),n.uniformBlockBinding(J,le,le),$.set(P,le))}function K(P,J,$){const se=c.get(J).get(P);l[se]!==$&&(n.bindBufferBase(n.UNIFORM_BUFFER,se,$),l[se]=$)}function oe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},j=null,te={},h={},l={},g=new WeakMap,_=[],y=null,d=!1,m=null,x=null,T=null,S=null,E=null,A=null,p=null,w=new Ye(0,0,0),N=0,C=!1,L=null,k=null,X=null,I=null,V=null,Z.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:ge,disable:Ue,bindFramebuffer:pt,drawBuffers:Ce,useProgram:Ke,setBlending:At,setMaterial:xt,setFlipSided:zt,setCullFace:ct,setLineWidth:mn,setPolygonOffset:Et,setScissorTest:Yt,activeTexture:Kt,bindTexture:Zt,unbindTexture:U,compressedTexImage2D:Jt,compressedTexImage3D:at,texImage2D:v,texImage3D:O,pixelStorei:ee,getParameter:ne,updateUBOMapping:Y,uniformBlockBinding:K,texStorage2D:Le,texStorage3D:R,texSubImage2D:ot,texSubImage3D:de,compressedTexSubImage2D:St,compressedTexSubImage3D:Re,scissor:re,viewport:ue,reset:oe}}function Mx(n,e,t,i,s,r,a){const o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xe,u=new WeakMap,f=new Set;let h;const g=new WeakMap,_=new Set,y=new FinalizationRegistry(R=>_.delete(R));let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,v){return d?new OffscreenCanvas(R,v):Ir("canvas")}function x(R,v,O){let ne=1;const ee=Le(R);if((ee.width>O||ee.height>O)&&(ne=O/Math.max(ee.width,ee.height)),ne<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){const re=Math.floor(ne*ee.width),ue=Math.floor(ne*ee.height);h===void 0&&(h=m(re,ue));const Y=v?m(re,ue):h;return Y.width=re,Y.height=ue,Y.getContext("2d").drawImage(R,0,0,re,ue),Pe("WebGLRenderer: Texture has been resized from ("+ee.width+"x"+ee.height+") to ("+re+"x"+ue+")."),Y}else return"data"in R&&Pe("WebGLRenderer: Image in DataTexture is too big ("+ee.width+"x"+ee.height+")."),R;return R}function T(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function E(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,v,O,ne,ee,re=!1){if(R!==null){if(n[R]!==void 0)return n[R];Pe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ue;ne&&(ue=e.get("EXT_texture_norm16"),ue||Pe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=v;if(v===n.RED&&(O===n.FLOAT&&(Y=n.R32F),O===n.HALF_FLOAT&&(Y=n.R16F),O===n.UNSIGNED_BYTE&&(Y=n.R8),O===n.UNSIGNED_SHORT&&ue&&(Y=ue.R16_EXT),O===n.SHORT&&ue&&(Y=ue.R16_SNORM_EXT)),v===n.RED_INTEGER&&(O===n.UNSIGNED_BYTE&&(Y=n.R8UI),O===n.UNSIGNED_SHORT&&(Y=n.R16UI),O===n.UNSIGNED_INT&&(Y=n.R32UI),O===n.BYTE&&(Y=n.R8I),O===n.SHORT&&(Y=n.R16I),O===n.INT&&(Y=n.R32I)),v===n.RG&&(O===n.FLOAT&&(Y=n.RG32F),O===n.HALF_FLOAT&&(Y=n.RG16F),O===n.UNSIGNED_BYTE&&(Y=n.RG8),O===n.UNSIGNED_SHORT&&ue&&(Y=ue.RG16_EXT),O===n.SHORT&&ue&&(Y=ue.RG16_SNORM_EXT)),v===n.RG_INTEGER&&(O===n.UNSIGNED_BYTE&&(Y=n.RG8UI),O===n.UNSIGNED_SHORT&&(Y=n.RG16UI),O===n.UNSIGNED_INT&&(Y=n.RG32UI),O===n.BYTE&&(Y=n.RG8I),O===n.SHORT&&(Y=n.RG16I),O===n.INT&&(Y=n.RG32I)),v===n.RGB_INTEGER&&(O===n.UNSIGNED_BYTE&&(Y=n.RGB8UI),O===n.UNSIGNED_SHORT&&(Y=n.RGB16UI),O===n.UNSIGNED_INT&&(Y=n.RGB32UI),O===n.BYTE&&(Y=n.RGB8I),O===n.SHORT&&(Y=n.RGB16I),O===n.INT&&(Y=n.RGB32I)),v===n.RGBA_INTEGER&&(O===n.UNSIGNED_BYTE&&(Y=n.RGBA8UI),O===n.UNSIGNED_SHORT&&(Y=n.RGBA16UI),O===n.UNSIGNED_INT&&(Y=n.RGBA32UI),O===n.BYTE&&(Y=n.RGBA8I),O===n.SHORT&&(Y=n.RGBA16I),O===n.INT&&(Y=n.RGBA32I)),v===n.RGB&&(O===n.UNSIGNED_SHORT&&ue&&(Y=ue.RGB16_EXT),O===n.SHORT&&ue&&(Y=ue.RGB16_SNORM_EXT),O===n.UNSIGNED_INT_5_9_9_9_REV&&(Y=n.RGB9_E5),O===n.UNSIGNED_INT_10F_11F_11F_REV&&(Y=n.R11F_G11F_B10F)),v===n.RGBA){const K=re?Dr:Ve.getTransfer(ee);O===n.FLOAT&&(Y=n.RGBA32F),O===n.HALF_FLOAT&&(Y=n.RGBA16F),O===n.UNSIGNED_BYTE&&(Y=K===Je?n.SRGB8_ALPHA8:n.RGBA8),O===n.UNSIGNED_SHORT&&ue&&(Y=ue.RGBA16_EXT),O===n.SHORT&&ue&&(Y=ue.RGBA16_SNORM_EXT),O===n.UNSIGNED_SHORT_4_4_4_4&&(Y=n.RGBA4),O===n.UNSIGNED_SHORT_5_5_5_1&&(Y=n.RGB5_A1)}return(Y===n.R16F||Y===n.R32F||Y===n.RG16F||Y===n.RG32F||Y===n.RGBA16F||Y===n.RGBA32F)&&e.get("EXT_color_buffer_float"),Y}function p(R,v){let O;return R?v===null||v===bn||v===Hi?O=n.DEPTH24_STENCIL8:v===Ot?O=n.DEPTH32F_STENCIL8:v===gs&&(O=n.DEPTH24_STENCIL8,Pe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===bn||v===Hi?O=n.DEPTH_COMPONENT24:v===Ot?O=n.DEPTH_COMPONENT32F:v===gs&&(O=n.DEPTH_COMPONENT16),O}function w(R,v){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==vt&&R.minFilter!==Pt?Math.log2(Math.max(v.width,v.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?v.mipmaps.length:1}function N(R){const v=new WeakRef(R);i.get(R).__ref=v,_.add(v),y.register(R,v,v)}function C(R){const v=i.get(R).__ref;v!==void 0&&(_.delete(v),y.unregister(v))}function L(R){X(R.target)}function k(R){I(R.target)}function X(R){R.removeEventListener("dispose",L),C(R),Q(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function I(R){R.removeEventListener("dispose",k),C(R),q(R)}function V(){for(const R of _){const v=R.deref();v!==void 0&&(v.isRenderTarget===!0?I(v):X(v))}_.clear(),f.clear()}function Q(R){const v=i.get(R);if(v.__webglInit===void 0)return;const O=R.source,ne=g.get(O);if(ne){const ee=ne[v.__cacheKey];ee.usedTimes--,ee.usedTimes===0&&z(R),Object.keys(ne).length===0&&g.delete(O)}i.remove(R)}function z(R){const v=i.get(R);n.deleteTexture(v.__webglTexture);const O=R.source,ne=g.get(O);delete ne[v.__cacheKey],a.memory.textures--}function q(R){const v=i.get(R);v.__depthDisposeCallback&&v.__depthDisposeCallback();const O=R.depthTexture;if(O&&O.renderTarget===R&&X(O),R.isWebGLCubeRenderTarget)for(let ee=0;ee<6;ee++){if(Array.isArray(v.__webglFramebuffer[ee]))for(let re=0;re<v.__webglFramebuffer[ee].length;re++)n.deleteFramebuffer(v.__webglFramebuffer[ee][re]);else n.deleteFramebuffer(v.__webglFramebuffer[ee]);v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer[ee])}else{if(Array.isArray(v.__webglFramebuffer))for(let ee=0;ee<v.__webglFramebuffer.length;ee++)n.deleteFramebuffer(v.__webglFramebuffer[ee]);else n.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&n.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let ee=0;ee<v.__webglColorRenderbuffer.length;ee++)v.__webglColorRenderbuffer[ee]&&n.deleteRenderbuffer(v.__webglColorRenderbuffer[ee]);v.__webglDepthRenderbuffer&&n.deleteRenderbuffer(v.__webglDepthRenderbuffer)}const ne=R.textures;for(let ee=0,re=ne.length;ee<re;ee++){const ue=i.get(ne[ee]);ue.__webglTexture&&(n.deleteTexture(ue.__webglTexture),a.memory.textures--),i.remove(ne[ee])}i.remove(R)}let G=0;function j(){G=0}function te(){return G}function Ee(R){G=R}function Ne(){const R=G;return R>=s.maxTextures&&Pe("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),G+=1,R}function Z(R){const v=[];return v.push(R.wrapS),v.push(R.wrapT),v.push(R.wrapR||0),v.push(R.magFilter),v.push(R.minFilter),v.push(R.anisotropy),v.push(R.internalFormat),v.push(R.format),v.push(R.type),v.push(R.generateMipmaps),v.push(R.mipmapsAutoUpdate),v.push(R.premultiplyAlpha),v.push(R.flipY),v.push(R.unpackAlignment),v.push(R.colorSpace),v.join()}function me(R,v){const O=i.get(R);if(R.isVideoTexture&&St(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&O.__version!==R.version){const ne=R.image;if(ne===null)Pe("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Pe("WebGLRenderer: Texture marked for update but image is incomplete");else{xt(O,R,v);return}}else R.isExternalTexture&&(O.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,O.__webglTexture,n.TEXTURE0+v)}function Se(R,v){const O=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&O.__version!==R.version){xt(O,R,v);return}else R.isExternalTexture&&(O.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,O.__webglTexture,n.TEXTURE0+v)}function Ae(R,v){const O=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&O.__version!==R.version){xt(O,R,v);return}t.bindTexture(n.TEXTURE_3D,O.__webglTexture,n.TEXTURE0+v)}function ge(R,v){const O=i.get(R);if(R.version>0&&O.__version!==R.version){zt(O,R,v);return}t.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+v)}const Ue={[Cr]:n.REPEAT,[Mn]:n.CLAMP_TO_EDGE,[co]:n.MIRRORED_REPEAT},pt={[vt]:n.NEAREST,[zp]:n.NEAREST_MIPMAP_NEAREST,[Ds]:n.NEAREST_MIPMAP_LINEAR,[Pt]:n.LINEAR,[ma]:n.LINEAR_MIPMAP_NEAREST,[Jn]:n.LINEAR_MIPMAP_LINEAR},Ce={[Wp]:n.NEVER,[rd]:n.ALWAYS,[Xp]:n.LESS,[id]:n.LEQUAL,[$p]:n.EQUAL,[sd]:n.GEQUAL,[qp]:n.GREATER,[Yp]:n.NOTEQUAL};function Ke(R,v){if(v.type===Ot&&e.has("OES_texture_float_linear")===!1&&(v.magFilter===Pt||v.magFilter===ma||v.magFilter===Ds||v.magFilter===Jn||v.minFilter===Pt||v.minFilter===ma||v.minFilter===Ds||v.minFilter===Jn)&&Pe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Ue[v.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Ue[v.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Ue[v.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,pt[v.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,pt[v.minFilter]),v.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ce[v.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===vt||v.minFilter!==Ds&&v.minFilter!==Jn||v.type===Ot&&e.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||i.get(v).__currentAnisotropy){const O=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,O.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),i.get(v).__currentAnisotropy=v.anisotropy}}}function je(R,v){let O=!1;R.__webglInit===void 0&&(R.__webglInit=!0,v.addEventListener("dispose",L),N(v));const ne=v.source;let ee=g.get(ne);ee===void 0&&(ee={},g.set(ne,ee));const re=Z(v);if(re!==R.__cacheKey){ee[re]===void 0&&(ee[re]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,O=!0),ee[re].usedTimes++;const ue=ee[R.__cacheKey];ue!==void 0&&(ee[R.__cacheKey].usedTimes--,ue.usedTimes===0&&z(v)),R.__cacheKey=re,R.__webglTexture=ee[re].texture}return O}function Be(R,v,O){return Math.floor(Math.floor(R/O)/v)}function At(R,v,O,ne){const re=R.updateRanges;if(re.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,v.width,v.height,O,ne,v.data);else{re.sort((P,J)=>P.start-J.start);let ue=0;for(let P=1;P<re.length;P++){const J=re[ue],$=re[P],le=J.start+J.count,se=Be($.start,v.width,4),ae=Be(J.start,v.width,4);$.start<=le+1&&se===ae&&Be($.start+$.count-1,v.width,4)===se?J.count=Math.max(J.count,$.start+$.count-J.start):(++ue,re[ue]=$)}re.length=ue+1;const Y=t.getParameter(n.UNPACK_ROW_LENGTH),K=t.getParameter(n.UNPACK_SKIP_PIXELS),oe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,v.width);for(let P=0,J=re.length;P<J;P++){const $=re[P],le=Math.floor($.start/4),se=Math.ceil($.count/4),ae=le%v.width,we=Math.floor(le/v.width),Oe=se,ie=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,we),t.texSubImage2D(n.TEXTURE_2D,0,ae,we,Oe,ie,O,ne,v.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,Y),t.pixelStorei(n.UNPACK_SKIP_PIXELS,K),t.pixelStorei(n.UNPACK_SKIP_ROWS,oe)}}function xt(R,v,O){let ne=n.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(ne=n.TEXTURE_2D_ARRAY),v.isData3DTexture&&(ne=n.TEXTURE_3D);const ee=je(R,v),re=v.source;t.bindTexture(ne,R.__webglTexture,n.TEXTURE0+O);const ue=i.get(re);if(re.version!==ue.__version||ee===!0){if(t.activeTexture(n.TEXTURE0+O),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){const ie=Ve.getPrimaries(Ve.workingColorSpace),Te=v.colorSpace===Zn?null:Ve.getPrimaries(v.colorSpace),Fe=v.colorSpace===Zn||ie===Te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Fe)}t.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment);let K=x(v.image,!1,s.maxTextureSize);K=Re(v,K);const oe=r.convert(v.format,v.colorSpace),P=r.convert(v.type);let J=A(v.internalFormat,oe,P,v.normalized,v.colorSpace,v.isVideoTexture);Ke(ne,v);let $;const le=v.mipmaps,se=v.isVideoTexture!==!0,ae=ue.__version===void 0||ee===!0,we=re.dataReady,Oe=w(v,K);if(v.isDepthTexture)J=p(v.format===Qn,v.type),ae&&(se?t.texStorage2D(n.TEXTURE_2D,1,J,K.width,K.height):t.texImage2D(n.TEXTURE_2D,0,J,K.width,K.height,0,oe,P,null));else if(v.isDataTexture)if(le.length>0){se&&ae&&t.texStorage2D(n.TEXTURE_2D,Oe,J,le[0].width,le[0].height);for(let ie=0,Te=le.length;ie<Te;ie++)$=le[ie],se?we&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,oe,P,$.data):t.texImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,oe,P,$.data);v.generateMipmaps=!1}else se?(ae&&t.texStorage2D(n.TEXTURE_2D,Oe,J,K.width,K.height),we&&At(v,K,oe,P)):t.texImage2D(n.TEXTURE_2D,0,J,K.width,K.height,0,oe,P,K.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){se&&ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Oe,J,le[0].width,le[0].height,K.depth);for(let ie=0,Te=le.length;ie<Te;ie++)if($=le[ie],v.format!==nn)if(oe!==null)if(se){if(we)if(v.layerUpdates.size>0){const Fe=$c($.width,$.height,v.format,v.type);for(const fe of v.layerUpdates){const Ze=$.data.subarray(fe*Fe/$.data.BYTES_PER_ELEMENT,(fe+1)*Fe/$.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,fe,$.width,$.height,1,oe,Ze)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,oe,$.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,$.data,0,0);else Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?we&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,K.depth,oe,P,$.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,K.depth,0,oe,P,$.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{se&&ae&&t.texStorage2D(n.TEXTURE_2D,Oe,J,le[0].width,le[0].height);for(let ie=0,Te=le.length;ie<Te;ie++)$=le[ie],v.format!==nn?oe!==null?se?we&&t.compressedTexSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,oe,$.data):t.compressedTexImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,$.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?we&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,oe,P,$.data):t.texImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,oe,P,$.data)}else if(v.isDataArrayTexture)if(se){if(ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Oe,J,K.width,K.height,K.depth),we)if(v.layerUpdates.size>0){const ie=$c(K.width,K.height,v.format,v.type);for(const Te of v.layerUpdates){const Fe=K.data.subarray(Te*ie/K.data.BYTES_PER_ELEMENT,(Te+1)*ie/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Te,K.width,K.height,1,oe,P,Fe)}v.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,oe,P,K.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,J,K.width,K.height,K.depth,0,oe,P,K.data);else if(v.isData3DTexture)se?(ae&&t.texStorage3D(n.TEXTURE_3D,Oe,J,K.width,K.height,K.depth),we&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,oe,P,K.data)):t.texImage3D(n.TEXTURE_3D,0,J,K.width,K.height,K.depth,0,oe,P,K.data);else if(v.isFramebufferTexture){if(ae)if(se)t.texStorage2D(n.TEXTURE_2D,Oe,J,K.width,K.height);else{let ie=K.width,Te=K.height;for(let Fe=0;Fe<Oe;Fe++)t.texImage2D(n.TEXTURE_2D,Fe,J,ie,Te,0,oe,P,null),ie>>=1,Te>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in n){const ie=n.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),K.parentNode!==ie){ie.appendChild(K),f.add(v),ie.onpaint=Te=>{const Fe=Te.changedElements;for(const fe of f)Fe.includes(fe.image)&&(fe.needsUpdate=!0)},ie.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,K);else{const Fe=n.RGBA,fe=n.RGBA,Ze=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Fe,fe,Ze,K)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(le.length>0){if(se&&ae){const ie=Le(le[0]);t.texStorage2D(n.TEXTURE_2D,Oe,J,ie.width,ie.height)}for(let ie=0,Te=le.length;ie<Te;ie++)$=le[ie],se?we&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,oe,P,$):t.texImage2D(n.TEXTURE_2D,ie,J,oe,P,$);v.generateMipmaps=!1}else if(se){if(ae){const ie=Le(K);t.texStorage2D(n.TEXTURE_2D,Oe,J,ie.width,ie.height)}we&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,oe,P,K)}else t.texImage2D(n.TEXTURE_2D,0,J,oe,P,K);T(v)&&v.mipmapsAutoUpdate===!0&&S(ne),ue.__version=re.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}function zt(R,v,O){if(v.image.length!==6)return;const ne=je(R,v),ee=v.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+O);const re=i.get(ee);if(ee.version!==re.__version||ne===!0){t.activeTexture(n.TEXTURE0+O);const ue=Ve.getPrimaries(Ve.workingColorSpace),Y=v.colorSpace===Zn?null:Ve.getPrimaries(v.colorSpace),K=v.colorSpace===Zn||ue===Y?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);const oe=v.isCompressedTexture||v.image[0].isCompressedTexture,P=v.image[0]&&v.image[0].isDataTexture,J=[];for(let fe=0;fe<6;fe++)!oe&&!P?J[fe]=x(v.image[fe],!0,s.maxCubemapSize):J[fe]=P?v.image[fe].image:v.image[fe],J[fe]=Re(v,J[fe]);const $=J[0],le=r.convert(v.format,v.colorSpace),se=r.convert(v.type);let ae=A(v.internalFormat,le,se,v.normalized,v.colorSpace);const we=v.isVideoTexture!==!0,Oe=re.__version===void 0||ne===!0,ie=ee.dataReady;let Te=w(v,$);Ke(n.TEXTURE_CUBE_MAP,v);let Fe;if(v.isDepthTexture){if(ae=p(v.format===Qn,v.type),Oe)if(we)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,ae,$.width,$.height);else for(let fe=0;fe<6;fe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,$.width,$.height,0,le,se,null)}else if(oe){we&&Oe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Te,ae,$.width,$.height);for(let fe=0;fe<6;fe++){Fe=J[fe].mipmaps;for(let Ze=0;Ze<Fe.length;Ze++){const bt=Fe[Ze];v.format!==nn?le!==null?we?ie&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,0,0,bt.width,bt.height,le,bt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,ae,bt.width,bt.height,0,bt.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,0,0,bt.width,bt.height,le,se,bt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,ae,bt.width,bt.height,0,le,se,bt.data)}}}else{if(Fe=v.mipmaps,we&&Oe){Fe.length>0&&Te++;const fe=Le(J[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Te,ae,fe.width,fe.height)}for(let fe=0;fe<6;fe++)if(P){we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,0,0,J[fe].width,J[fe].height,le,se,J[fe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,J[fe].width,J[fe].height,0,le,se,J[fe].data);for(let Ze=0;Ze<Fe.length;Ze++){const zn=Fe[Ze].image[fe].image;we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,0,0,zn.width,zn.height,le,se,zn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,ae,zn.width,zn.height,0,le,se,zn.data)}}else{we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,0,0,le,se,J[fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,le,se,J[fe]);for(let Ze=0;Ze<Fe.length;Ze++){const bt=Fe[Ze];we?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,0,0,le,se,bt.image[fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,ae,le,se,bt.image[fe])}}}T(v)&&v.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),re.__version=ee.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}function ct(R,v,O,ne,ee,re){const ue=r.convert(O.format,O.colorSpace),Y=r.convert(O.type),K=A(O.internalFormat,ue,Y,O.normalized,O.colorSpace),oe=i.get(v),P=i.get(O);if(P.__renderTarget=v,!oe.__hasExternalTextures){const J=Math.max(1,v.width>>re),$=Math.max(1,v.height>>re);ee===n.TEXTURE_3D||ee===n.TEXTURE_2D_ARRAY?t.texImage3D(ee,re,K,J,$,v.depth,0,ue,Y,null):t.texImage2D(ee,re,K,J,$,0,ue,Y,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),de(v)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,ee,P.__webglTexture,0,ot(v)):(ee===n.TEXTURE_2D||ee>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ee<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ne,ee,P.__webglTexture,re),t.bindFramebuffer(n.FRAMEBUFFER,null)}function mn(R,v,O){if(n.bindRenderbuffer(n.RENDERBUFFER,R),v.depthBuffer){const ne=v.depthTexture,ee=ne&&ne.isDepthTexture?ne.type:null,re=p(v.stencilBuffer,ee),ue=v.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;de(v)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(v),re,v.width,v.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(v),re,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,re,v.width,v.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ue,n.RENDERBUFFER,R)}else{const ne=v.textures;for(let ee=0;ee<ne.length;ee++){const re=ne[ee],ue=r.convert(re.format,re.colorSpace),Y=r.convert(re.type),K=A(re.internalFormat,ue,Y,re.normalized,re.colorSpace);de(v)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(v),K,v.width,v.height):O?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(v),K,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,K,v.width,v.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Et(R,v,O){const ne=v.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");const ee=i.get(v.depthTexture);ee.__renderTarget=v;const re=ne?v.depthTexture.image[0]:v.depthTexture.image;(!ee.__webglTexture||re.width!==v.width||re.height!==v.height)&&(re.width=v.width,re.height=v.height,v.depthTexture.needsUpdate=!0),ne?ge(v.depthTexture,0):me(v.depthTexture,0);const ue=ee.__webglTexture,Y=ot(v),K=ne?n.TEXTURE_CUBE_MAP_POSITIVE_X+O:n.TEXTURE_2D,oe=v.depthTexture.format===Qn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(v.depthTexture.format===ni)de(v)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,oe,K,ue,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,oe,K,ue,0);else if(v.depthTexture.format===Qn)de(v)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,oe,K,ue,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,oe,K,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Yt(R){const v=i.get(R),O=R.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==R.depthTexture){const ne=R.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),ne){const ee=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,ne.removeEventListener("dispose",ee)};ne.addEventListener("dispose",ee),v.__depthDisposeCallback=ee}v.__boundDepthTexture=ne}if(R.depthTexture&&!v.__autoAllocateDepthBuffer)if(O)for(let ne=0;ne<6;ne++)Et(v.__webglFramebuffer[ne],R,ne);else R.texture.mipmaps.length>0?Et(v.__webglFramebuffer[0],R,0):Et(v.__webglFramebuffer,R,0);else if(O){v.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[ne]),v.__webglDepthbuffer[ne]===void 0)v.__webglDepthbuffer[ne]=n.createRenderbuffer(),mn(v.__webglDepthbuffer[ne],R,!1);else{const ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=v.__webglDepthbuffer[ne];n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,re)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=n.createRenderbuffer(),mn(v.__webglDepthbuffer,R,!1);else{const ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=v.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,re)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Kt(R,v,O){const ne=i.get(R);v!==void 0&&ct(ne.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),O!==void 0&&Yt(R)}function Zt(R){const v=R.texture,O=i.get(R),ne=i.get(v);R.addEventListener("dispose",k),N(R);const ee=R.textures,re=R.isWebGLCubeRenderTarget===!0,ue=ee.length>1;if(ue||(ne.__webglTexture===void 0&&(ne.__webglTexture=n.createTexture()),ne.__version=v.version,a.memory.textures++),re){O.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0){O.__webglFramebuffer[Y]=[];for(let K=0;K<v.mipmaps.length;K++)O.__webglFramebuffer[Y][K]=n.createFramebuffer()}else O.__webglFramebuffer[Y]=n.createFramebuffer()}else{if(v.mipmaps.length>0){O.__webglFramebuffer=[];for(let Y=0;Y<v.mipmaps.length;Y++)O.__webglFramebuffer[Y]=n.createFramebuffer()}else O.__webglFramebuffer=n.createFramebuffer();if(ue)for(let Y=0,K=ee.length;Y<K;Y++){const oe=i.get(ee[Y]);oe.__webglTexture===void 0&&(oe.__webglTexture=n.createTexture(),a.memory.textures++)}if(R.samples>0&&de(R)===!1){O.__webglMultisampledFramebuffer=n.createFramebuffer(),O.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,O.__webglMultisampledFramebuffer);for(let Y=0;Y<ee.length;Y++){const K=ee[Y];O.__webglColorRenderbuffer[Y]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,O.__webglColorRenderbuffer[Y]);const oe=r.convert(K.format,K.colorSpace),P=r.convert(K.type),J=A(K.internalFormat,oe,P,K.normalized,K.colorSpace,R.isXRRenderTarget===!0),$=ot(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,$,J,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Y,n.RENDERBUFFER,O.__webglColorRenderbuffer[Y])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(O.__webglDepthRenderbuffer=n.createRenderbuffer(),mn(O.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(re){t.bindTexture(n.TEXTURE_CUBE_MAP,ne.__webglTexture),Ke(n.TEXTURE_CUBE_MAP,v);for(let Y=0;Y<6;Y++)if(v.mipmaps.length>0)for(let K=0;K<v.mipmaps.length;K++)ct(O.__webglFramebuffer[Y][K],R,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,K);else ct(O.__webglFramebuffer[Y],R,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);T(v)?S(n.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let Y=0,K=ee.length;Y<K;Y++){const oe=ee[Y],P=i.get(oe);let J=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(J=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(J,P.__webglTexture),Ke(J,oe),ct(O.__webglFramebuffer,R,oe,n.COLOR_ATTACHMENT0+Y,J,0),T(oe)&&S(J)}t.unbindTexture()}else{let Y=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Y=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(Y,ne.__webglTexture),Ke(Y,v),v.mipmaps.length>0)for(let K=0;K<v.mipmaps.length;K++)ct(O.__webglFramebuffer[K],R,v,n.COLOR_ATTACHMENT0,Y,K);else ct(O.__webglFramebuffer,R,v,n.COLOR_ATTACHMENT0,Y,0);T(v)?S(Y):v.mipmaps.length>0&&n.texParameteri(Y,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Yt(R)}function U(R){const v=R.textures;for(let O=0,ne=v.length;O<ne;O++){const ee=v[O];if(T(ee)&&ee.mipmapsAutoUpdate===!0){const re=E(R),ue=i.get(ee).__webglTexture;t.bindTexture(re,ue),S(re),t.unbindTexture()}}}const Jt=[];function at(R){if(R.samples>0){if(de(R)===!1){const v=R.textures,O=R.width,ne=R.height;let ee=n.COLOR_BUFFER_BIT;const re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ue=i.get(R),Y=v.length>1;if(Y)for(let oe=0;oe<v.length;oe++)t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let oe=0;oe<v.length;oe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ee|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ee|=n.STENCIL_BUFFER_BIT)),Y){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ue.__webglColorRenderbuffer[oe]);const P=i.get(v[oe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,P,0)}n.blitFramebuffer(0,0,O,ne,0,0,O,ne,ee,n.NEAREST),l===!0&&(Jt.length=0,Jt.push(n.COLOR_ATTACHMENT0+oe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Jt.push(re),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Jt))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Y)for(let oe=0;oe<v.length;oe++){t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.RENDERBUFFER,ue.__webglColorRenderbuffer[oe]);const P=i.get(v[oe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.TEXTURE_2D,P,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){const v=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[v])}}}function ot(R){return Math.min(s.maxSamples,R.samples)}function de(R){const v=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function St(R){const v=a.render.frame;u.get(R)!==v&&(u.set(R,v),R.update())}function Re(R,v){const O=R.colorSpace,ne=R.format,ee=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||O!==_s&&O!==Zn&&(Ve.getTransfer(O)===Je?(ne!==nn||ee!==tn)&&Pe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):qe("WebGLTextures: Unsupported texture color space:",O)),v}function Le(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=Ne,this.resetTextureUnits=j,this.getTextureUnits=te,this.setTextureUnits=Ee,this.setTexture2D=me,this.setTexture2DArray=Se,this.setTexture3D=Ae,this.setTextureCube=ge,this.rebindTextures=Kt,this.setupRenderTarget=Zt,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=at,this.setupDepthRenderbuffer=Yt,this.setupFrameBufferTexture=ct,this.useMultisampledRTT=de,this.dispose=V}function yx(n,e){function t(i,s=Zn){let r;const a=Ve.getTransfer(s);if(i===tn)return n.UNSIGNED_BYTE;if(i===gl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===_l)return n.UNSIGNED_SHORT_5_5_5_1;if(i===jh)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ed)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Jh)return n.BYTE;if(i===Qh)return n.SHORT;if(i===gs)return n.UNSIGNED_SHORT;if(i===ml)return n.INT;if(i===bn)return n.UNSIGNED_INT;if(i===Ot)return n.FLOAT;if(i===Wt)return n.HALF_FLOAT;if(i===td)return n.ALPHA;if(i===nd)return n.RGB;if(i===nn)return n.RGBA;if(i===ni)return n.DEPTH_COMPONENT;if(i===Qn)return n.DEPTH_STENCIL;if(i===Qr)return n.RED;if(i===vl)return n.RED_INTEGER;if(i===_i)return n.RG;if(i===xl)return n.RG_INTEGER;if(i===Sl)return n.RGBA_INTEGER;if(i===ur||i===hr||i===dr||i===fr)if(a===Je)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ur)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===hr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===dr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===fr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ur)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===hr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===dr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===fr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===uo||i===ho||i===fo||i===po)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===uo)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ho)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===fo)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===po)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===mo||i===go||i===_o||i===vo||i===xo||i===Pr||i===So)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===mo||i===go)return a===Je?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===_o)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===vo)return r.COMPRESSED_R11_EAC;if(i===xo)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Pr)return r.COMPRESSED_RG11_EAC;if(i===So)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Mo||i===yo||i===Eo||i===bo||i===wo||i===To||i===Ao||i===Ro||i===Co||i===Po||i===Lo||i===Do||i===No||i===Io)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Mo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===yo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Eo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===bo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===To)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ao)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ro)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Co)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Po)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Lo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Do)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===No)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Io)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Uo||i===Fo||i===Oo)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Uo)return a===Je?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Fo)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Oo)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ko||i===Bo||i===Lr||i===zo)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===ko)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Bo)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Lr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===zo)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Hi?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}const Ex=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,bx=`
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

}`;class wx{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const i=new pd(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new xi({vertexShader:Ex,fragmentShader:bx,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ii(new ea(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class Tx extends yi{constructor(e,t){super();const i=this;let s=null,r=1,a=null,o="local-floor",l=1,c=null,u=null,f=null,h=null,g=null,_=null;const y=typeof XRWebGLBinding<"u",d=new wx,m={},x=t.getContextAttributes();let T=null,S=null;const E=[],A=[],p=new Xe;let w=null,N=null;const C=new vn;C.viewport=new ht;const L=new vn;L.viewport=new ht;const k=[C,L],X=new km;let I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let me=E[Z];return me===void 0&&(me=new ba,E[Z]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Z){let me=E[Z];return me===void 0&&(me=new ba,E[Z]=me),me.getGripSpace()},this.getHand=function(Z){let me=E[Z];return me===void 0&&(me=new ba,E[Z]=me),me.getHandSpace()};function Q(Z){const me=A.indexOf(Z.inputSource);if(me===-1)return;const Se=E[me];Se!==void 0&&(Se.update(Z.inputSource,Z.frame,c||a),Se.dispatchEvent({type:Z.type,data:Z.inputSource}))}function z(){s.removeEventListener("select",Q),s.removeEventListener("selectstart",Q),s.removeEventListener("selectend",Q),s.removeEventListener("squeeze",Q),s.removeEventListener("squeezestart",Q),s.removeEventListener("squeezeend",Q),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",q);for(let Z=0;Z<E.length;Z++){const me=A[Z];me!==null&&(A[Z]=null,E[Z].disconnect(me))}I=null,V=null,d.reset();for(const Z in m)delete m[Z];if(e.setRenderTarget(T),g=null,h=null,f=null,s=null,S=null,Ne.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(p.width,p.height,!1),N!==null){const Z=N.camera;Z.fov=N.fov,Z.zoom=N.zoom,Z.updateProjectionMatrix(),N=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,i.isPresenting===!0&&Pe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){o=Z,i.isPresenting===!0&&Pe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return h!==null?h:g},this.getBinding=function(){return f===null&&y&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Q),s.addEventListener("selectstart",Q),s.addEventListener("selectend",Q),s.addEventListener("squeeze",Q),s.addEventListener("squeezestart",Q),s.addEventListener("squeezeend",Q),s.addEventListener("end",z),s.addEventListener("inputsourceschange",q),x.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(p),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Se=null,Ae=null,ge=null;x.depth&&(ge=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Se=x.stencil?Qn:ni,Ae=x.stencil?Hi:bn);const Ue={colorFormat:t.RGBA8,depthFormat:ge,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Ue),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new fn(h.textureWidth,h.textureHeight,{format:nn,type:tn,depthTexture:new Gi(h.textureWidth,h.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,Se),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{const Se={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};g=new XRWebGLLayer(s,t,Se),s.updateRenderState({baseLayer:g}),e.setPixelRatio(1),e.setSize(g.framebufferWidth,g.framebufferHeight,!1),S=new fn(g.framebufferWidth,g.framebufferHeight,{format:nn,type:tn,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:g.ignoreDepthValues===!1,resolveStencilBuffer:g.ignoreDepthValues===!1,storeMultisampledDepthBuffer:g.ignoreDepthValues===!1,storeMultisampledStencilBuffer:g.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),Ne.setContext(s),Ne.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function q(Z){for(let me=0;me<Z.removed.length;me++){const Se=Z.removed[me],Ae=A.indexOf(Se);Ae>=0&&(A[Ae]=null,E[Ae].disconnect(Se))}for(let me=0;me<Z.added.length;me++){const Se=Z.added[me];let Ae=A.indexOf(Se);if(Ae===-1){for(let Ue=0;Ue<E.length;Ue++)if(Ue>=A.length){A.push(Se),Ae=Ue;break}else if(A[Ue]===null){A[Ue]=Se,Ae=Ue;break}if(Ae===-1)break}const ge=E[Ae];ge&&ge.connect(Se)}}function G(Z,me){me===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(me.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let me=Z.near,Se=Z.far;d.texture!==null&&(d.depthNear>0&&(me=d.depthNear),d.depthFar>0&&(Se=d.depthFar)),X.near=L.near=C.near=me,X.far=L.far=C.far=Se,(I!==X.near||V!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),I=X.near,V=X.far),X.layers.mask=Z.layers.mask|6,C.layers.mask=X.layers.mask&-5,L.layers.mask=X.layers.mask&-3;const Ae=Z.parent,ge=X.cameras;G(X,Ae);for(let Ue=0;Ue<ge.length;Ue++)G(ge[Ue],Ae);X.projectionMatrix.copy(C.projectionMatrix),X.projectionMatrixInverse.copy(C.projectionMatrixInverse),N===null&&Z.isPerspectiveCamera&&(N={camera:Z,fov:Z.fov,zoom:Z.zoom}),j(Z,X,Ae)};function j(Z,me,Se){Se===null?Z.matrix.copy(me.matrixWorld):(Z.matrix.copy(Se.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(me.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(me.projectionMatrix),Z.projectionMatrixInverse.copy(me.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=Go*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(h===null&&g===null))return l},this.setFoveation=function(Z){l=Z,h!==null&&(h.fixedFoveation=Z),g!==null&&g.fixedFoveation!==void 0&&(g.fixedFoveation=Z)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(X)},this.getCameraTexture=function(Z){return m[Z]};let te=null;function Ee(Z,me){if(u=me.getViewerPose(c||a),_=me,u!==null){const Se=u.views;g!==null&&(e.setRenderTargetFramebuffer(S,g.framebuffer),e.setRenderTarget(S));let Ae=!1;Se.length!==X.cameras.length&&(X.cameras.length=0,Ae=!0);for(let Ce=0;Ce<Se.length;Ce++){const Ke=Se[Ce];let je=null;if(g!==null)je=g.getViewport(Ke);else{const At=f.getViewSubImage(h,Ke);je=At.viewport,Ce===0&&(e.setRenderTargetTextures(S,At.colorTexture,At.depthStencilTexture),e.setRenderTarget(S))}let Be=k[Ce];Be===void 0&&(Be=new vn,Be.layers.enable(Ce),Be.viewport=new ht,k[Ce]=Be),Be.matrix.fromArray(Ke.transform.matrix),Be.matrix.decompose(Be.position,Be.quaternion,Be.scale),Be.projectionMatrix.fromArray(Ke.projectionMatrix),Be.projectionMatrixInverse.copy(Be.projectionMatrix).invert(),Be.viewport.set(je.x,je.y,je.width,je.height),Ce===0&&(X.matrix.copy(Be.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Ae===!0&&X.cameras.push(Be)}const ge=s.enabledFeatures;if(ge&&ge.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){f=i.getBinding();const Ce=f.getDepthInformation(Se[0]);Ce&&Ce.isValid&&Ce.texture&&d.init(Ce,s.renderState)}if(ge&&ge.includes("camera-access")&&y){e.state.unbindTexture(),f=i.getBinding();for(let Ce=0;Ce<Se.length;Ce++){const Ke=Se[Ce].camera;if(Ke){let je=m[Ke];je||(je=new pd,m[Ke]=je);const Be=f.getCameraImage(Ke);je.sourceTexture=Be}}}}for(let Se=0;Se<E.length;Se++){const Ae=A[Se],ge=E[Se];Ae!==null&&ge!==void 0&&ge.update(Ae,me,c||a)}te&&te(Z,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),_=null}const Ne=new _d;Ne.setAnimationLoop(Ee),this.setAnimationLoop=function(Z){te=Z},this.dispose=function(){}}}const Ax=new ft,Ad=new De;Ad.set(-1,0,0,0,1,0,0,0,1);function Rx(n,e){function t(d,m){d.matrixAutoUpdate===!0&&d.updateMatrix(),m.value.copy(d.matrix)}function i(d,m){m.color.getRGB(d.fogColor.value,md(n)),m.isFog?(d.fogNear.value=m.near,d.fogFar.value=m.far):m.isFogExp2&&(d.fogDensity.value=m.density)}function s(d,m,x,T,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(d,m):m.isMeshLambertMaterial?(r(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(d,m),f(d,m)):m.isMeshPhongMaterial?(r(d,m),u(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(d,m),h(d,m),m.isMeshPhysicalMaterial&&g(d,m,S)):m.isMeshMatcapMaterial?(r(d,m),_(d,m)):m.isMeshDepthMaterial?r(d,m):m.isMeshDistanceMaterial?(r(d,m),y(d,m)):m.isMeshNormalMaterial?r(d,m):m.isLineBasicMaterial?(a(d,m),m.isLineDashedMaterial&&o(d,m)):m.isPointsMaterial?l(d,m,x,T):m.isSpriteMaterial?c(d,m):m.isShadowMaterial?(d.color.value.copy(m.color),d.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(d,m){d.opacity.value=m.opacity,m.color&&d.diffuse.value.copy(m.color),m.emissive&&d.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.bumpMap&&(d.bumpMap.value=m.bumpMap,t(m.bumpMap,d.bumpMapTransform),d.bumpScale.value=m.bumpScale,m.side===Vt&&(d.bumpScale.value*=-1)),m.normalMap&&(d.normalMap.value=m.normalMap,t(m.normalMap,d.normalMapTransform),d.normalScale.value.copy(m.normalScale),m.side===Vt&&d.normalScale.value.negate()),m.displacementMap&&(d.displacementMap.value=m.displacementMap,t(m.displacementMap,d.displacementMapTransform),d.displacementScale.value=m.displacementScale,d.displacementBias.value=m.displacementBias),m.emissiveMap&&(d.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,d.emissiveMapTransform)),m.specularMap&&(d.specularMap.value=m.specularMap,t(m.specularMap,d.specularMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest);const x=e.get(m),T=x.envMap,S=x.envMapRotation;T&&(d.envMap.value=T,d.envMapRotation.value.setFromMatrix4(Ax.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(Ad),d.reflectivity.value=m.reflectivity,d.ior.value=m.ior,d.refractionRatio.value=m.refractionRatio),m.lightMap&&(d.lightMap.value=m.lightMap,d.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,d.lightMapTransform)),m.aoMap&&(d.aoMap.value=m.aoMap,d.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,d.aoMapTransform))}function a(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform))}function o(d,m){d.dashSize.value=m.dashSize,d.totalSize.value=m.dashSize+m.gapSize,d.scale.value=m.scale}function l(d,m,x,T){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.size.value=m.size*x,d.scale.value=T*.5,m.map&&(d.map.value=m.map,t(m.map,d.uvTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function c(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.rotation.value=m.rotation,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function u(d,m){d.specular.value.copy(m.specular),d.shininess.value=Math.max(m.shininess,1e-4)}function f(d,m){m.gradientMap&&(d.gradientMap.value=m.gradientMap)}function h(d,m){d.metalness.value=m.metalness,m.metalnessMap&&(d.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,d.metalnessMapTransform)),d.roughness.value=m.roughness,m.roughnessMap&&(d.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,d.roughnessMapTransform)),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)}function g(d,m,x){d.ior.value=m.ior,m.diffuseRoughness>0&&(d.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),m.sheen>0&&(d.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),d.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(d.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,d.sheenColorMapTransform)),m.sheenRoughnessMap&&(d.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,d.sheenRoughnessMapTransform))),m.clearcoat>0&&(d.clearcoat.value=m.clearcoat,d.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(d.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,d.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(d.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Vt&&d.clearcoatNormalScale.value.negate())),m.dispersion>0&&(d.dispersion.value=m.dispersion),m.retroreflectivity>0&&(d.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(d.iridescence.value=m.iridescence,d.iridescenceIOR.value=m.iridescenceIOR,d.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(d.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,d.iridescenceMapTransform)),m.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),m.transmission>0&&(d.transmission.value=m.transmission,d.transmissionSamplerMap.value=x.texture,d.transmissionSamplerSize.value.set(x.width,x.height),m.transmissionMap&&(d.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,d.transmissionMapTransform)),d.thickness.value=m.thickness,m.thicknessMap&&(d.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=m.attenuationDistance,d.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(d.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(d.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=m.specularIntensity,d.specularColor.value.copy(m.specularColor),m.specularColorMap&&(d.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,d.specularColorMapTransform)),m.specularIntensityMap&&(d.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,d.specularIntensityMapTransform))}function _(d,m){m.matcap&&(d.matcap.value=m.matcap)}function y(d,m){const x=e.get(m).light;d.referencePosition.value.setFromMatrixPosition(x.matrixWorld),d.nearDistance.value=x.shadow.camera.near,d.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Cx(n,e,t,i){let s={},r={};function a(x,T){const S=T.program;i.uniformBlockBinding(x,S,s[x.id])}function o(x,T){let S=s[x.id];S===void 0&&(_(x),S=l(x),s[x.id]=S,x.addEventListener("dispose",d));const E=T.program;i.updateUBOMapping(x,E);const A=e.render.frame;r[x.id]!==A&&(c(x),r[x.id]=A)}function l(x){const T=n.createBuffer(),S=x.__size,E=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,S,E),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(x){const T=s[x.id],S=x.uniforms,E=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,p=S.length;A<p;A++){const w=S[A];if(Array.isArray(w))for(let N=0,C=w.length;N<C;N++)u(w[N],A,N,E);else u(w,A,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,T,S,E){if(h(x,T,S,E)===!0){const A=x.__offset,p=x.value;if(Array.isArray(p)){let w=0;for(let N=0;N<p.length;N++){const C=p[N],L=y(C,!0);f(C,x.__data,w),w+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(p,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,x.__data)}}function f(x,T,S){typeof x=="number"||typeof x=="boolean"?T[S]=x:x.isMatrix3?(T[S]=x.elements[0],T[S+1]=x.elements[1],T[S+2]=x.elements[2],T[S+3]=0,T[S+4]=x.elements[3],T[S+5]=x.elements[4],T[S+6]=x.elements[5],T[S+7]=0,T[S+8]=x.elements[6],T[S+9]=x.elements[7],T[S+10]=x.elements[8],T[S+11]=0):ArrayBuffer.isView(x)?T.set(x.subarray(0,T.length-S),S):x.toArray(T,S)}function h(x,T,S,E){const A=x.value,p=T+"_"+S;if(Array.isArray(A)){E[p]===void 0&&(E[p]=[]);const w=E[p];let N=!1;for(let C=0;C<A.length;C++)g(A[C],w,C)===!0&&(N=!0);return N}return g(A,E,p)}function g(x,T,S){if(T[S]===void 0)return typeof x=="number"||typeof x=="boolean"?T[S]=x:ArrayBuffer.isView(x)?T[S]=x.slice():T[S]=x.clone(),!0;{const E=T[S];if(typeof x=="number"||typeof x=="boolean"){if(E!==x)return T[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(E.equals(x)===!1)return E.copy(x),!0}}return!1}function _(x){const T=x.uniforms;let S=0;const E=16;for(let p=0,w=T.length;p<w;p++){const N=Array.isArray(T[p])?T[p]:[T[p]];for(let C=0,L=N.length;C<L;C++){const k=N[C],X=Array.isArray(k.value)?k.value:[k.value],I=Array.isArray(T[p])||Array.isArray(k.value);let V=S;for(let z=0,q=X.length;z<q;z++){const G=X[z],j=y(G,I),te=S%E,Ee=te%j.boundary,Ne=te+Ee;S+=Ee,Ne!==0&&E-Ne<j.storage&&(S+=E-Ne),z===0&&(V=S),S+=j.storage}const Q=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Q((S-V)/Float32Array.BYTES_PER_ELEMENT),k.__offset=V}}const A=S%E;return A>0&&(S+=E-A),x.__size=S,x.__cache={},this}function y(x,T){const S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?Pe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):Pe("WebGLRenderer: Unsupported uniform value type.",x),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function d(x){const T=x.target;T.removeEventListener("dispose",d),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function m(){for(const x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:a,update:o,dispose:m}}const Px=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let _n=null;function Lx(){return _n===null&&(_n=new Wo(Px,16,16,_i,Wt),_n.name="DFG_LUT",_n.minFilter=Pt,_n.magFilter=Pt,_n.wrapS=Mn,_n.wrapT=Mn,_n.generateMipmaps=!1,_n.needsUpdate=!0),_n}class Dx{constructor(e={}){const{canvas:t=Jp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:g=tn}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=a;const y=g,d=new Set([Sl,xl,vl]),m=new Set([tn,bn,gs,Hi,gl,_l]),x=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]};let E=null,A=null;const p=[],w=[];let N=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const C=this;let L=!1,k=null,X=null,I=null,V=null;this._outputColorSpace=jt;let Q=0,z=0,q=null,G=-1,j=null;const te=new ht,Ee=new ht;let Ne=null;const Z=new Ye(0);let me=0,Se=t.width,Ae=t.height,ge=1,Ue=null,pt=null;const Ce=new ht(0,0,Se,Ae),Ke=new ht(0,0,Se,Ae);let je=!1;const Be=new Ur,At=new bl;let xt=!1,zt=!1;const ct=new ft,mn=new W,Et=new ht,Yt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Kt=!1;function Zt(){return q===null?ge:1}let U=i;function Jt(M,D){return t.getContext(M,D)}let at,ot,de,St,Re,Le,R,v,O,ne,ee,re,ue,Y,K,oe,P,J,$,le,se,ae,we;try{const M={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${pl}`),t.addEventListener("webglcontextlost",Te,!1),t.addEventListener("webglcontextrestored",Fe,!1),t.addEventListener("webglcontextcreationerror",fe,!1),U===null){const D="webgl2";if(U=Jt(D,M),U===null)throw Jt(D)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Oe()}catch(M){throw t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",fe,!1),qe("WebGLRenderer: "+M.message),M}function Oe(){at=new U0(U),at.init(),se=new yx(U,at),ot=new b0(U,at,e,se),de=new Sx(U,at),ot.reversedDepthBuffer&&h&&de.buffers.depth.setReversed(!0),X=U.createFramebuffer(),I=U.createFramebuffer(),V=U.createFramebuffer(),St=new k0(U),Re=new ax,Le=new Mx(U,at,de,Re,ot,se,St),R=new I0(C),v=new zm(U),ae=new y0(U,v),O=new F0(U,v,St,ae),ne=new z0(U,O,v,ae,St),J=new B0(U,ot,Le),K=new w0(Re),ee=new rx(C,R,at,ot,ae,K),re=new Rx(C,Re),ue=new lx,Y=new px(at),P=new M0(C,R,de,ne,_,l),oe=new xx(C,ne,ot),we=new Cx(U,St,ot,de),$=new E0(U,at,St),le=new O0(U,at,St),St.programs=ee.programs,C.capabilities=ot,C.extensions=at,C.properties=Re,C.renderLists=ue,C.shadowMap=oe,C.state=de,C.info=St}y!==tn&&(N=new G0(y,t.width,t.height,o,s,r));const ie=new Tx(C,U);this.xr=ie,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){const M=at.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){const M=at.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return ge},this.setPixelRatio=function(M){M!==void 0&&(ge=M,this.setSize(Se,Ae,!1))},this.getSize=function(M){return M.set(Se,Ae)},this.setSize=function(M,D,H=!0){if(ie.isPresenting){Pe("WebGLRenderer: Can't change size while VR device is presenting.");return}Se=M,Ae=D,t.width=Math.floor(M*ge),t.height=Math.floor(D*ge),H===!0&&(t.style.width=M+"px",t.style.height=D+"px"),N!==null&&N.setSize(t.width,t.height),this.setViewport(0,0,M,D)},this.getDrawingBufferSize=function(M){return M.set(Se*ge,Ae*ge).floor()},this.setDrawingBufferSize=function(M,D,H){Se=M,Ae=D,ge=H,t.width=Math.floor(M*H),t.height=Math.floor(D*H),this.setViewport(0,0,M,D)},this.setEffects=function(M){if(y===tn){qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let D=0;D<M.length;D++)if(M[D].isOutputPass===!0){Pe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(te)},this.getViewport=function(M){return M.copy(Ce)},this.setViewport=function(M,D,H,F){M.isVector4?Ce.set(M.x,M.y,M.z,M.w):Ce.set(M,D,H,F),de.viewport(te.copy(Ce).multiplyScalar(Zt()).round())},this.getScissor=function(M){return M.copy(Ke)},this.setScissor=function(M,D,H,F){M.isVector4?Ke.set(M.x,M.y,M.z,M.w):Ke.set(M,D,H,F),de.scissor(Ee.copy(Ke).multiplyScalar(Zt()).round())},this.getScissorTest=function(){return je},this.setScissorTest=function(M){de.setScissorTest(je=M)},this.setOpaqueSort=function(M){Ue=M},this.setTransparentSort=function(M){pt=M},this.getClearColor=function(M){return M.copy(P.getClearColor())},this.setClearColor=function(){P.setClearColor(...arguments)},this.getClearAlpha=function(){return P.getClearAlpha()},this.setClearAlpha=function(){P.setClearAlpha(...arguments)},this.clear=function(M=!0,D=!0,H=!0){let F=0;if(M){let B=!1;if(q!==null){const he=q.texture.format;B=d.has(he)}if(B){const he=q.texture.type,xe=m.has(he),ce=P.getClearColor(),_e=P.getClearAlpha(),be=ce.r,Ie=ce.g,ze=ce.b;xe?(x[0]=be,x[1]=Ie,x[2]=ze,x[3]=_e,U.clearBufferuiv(U.COLOR,0,x)):(T[0]=be,T[1]=Ie,T[2]=ze,T[3]=_e,U.clearBufferiv(U.COLOR,0,T))}else F|=U.COLOR_BUFFER_BIT}D&&(F|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(F|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&U.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),k=M},this.dispose=function(){t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",fe,!1),P.dispose(),ue.dispose(),Y.dispose(),Le.dispose(),Re.dispose(),R.dispose(),ne.dispose(),O.dispose(),ae.dispose(),we.dispose(),ee.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",Fl),ie.removeEventListener("sessionend",Ol),ri.stop()};function Te(M){M.preventDefault(),Ac("WebGLRenderer: Context Lost."),L=!0}function Fe(){Ac("WebGLRenderer: Context Restored."),L=!1;const M=St.autoReset,D=oe.enabled,H=oe.autoUpdate,F=oe.needsUpdate,B=oe.type;Oe(),St.autoReset=M,oe.enabled=D,oe.autoUpdate=H,oe.needsUpdate=F,oe.type=B}function fe(M){qe("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function Ze(M){const D=M.target;D.removeEventListener("dispose",Ze),bt(D)}function bt(M){zn(M),Re.remove(M)}function zn(M){const D=Re.get(M).programs;D!==void 0&&(D.forEach(function(H){ee.releaseProgram(H)}),M.isShaderMaterial&&ee.releaseShaderCache(M))}this.renderBufferDirect=function(M,D,H,F,B,he){D===null&&(D=Yt);const xe=B.isMesh&&B.matrixWorld.determinantAffine()<0,ce=Gd(M,D,H,F,B);de.setMaterial(F,xe);let _e=H.index,be=1;if(F.wireframe===!0){if(_e=O.getWireframeAttribute(H),_e===void 0)return;be=2}const Ie=H.drawRange,ze=H.attributes.position;let Me=Ie.start*be,He=(Ie.start+Ie.count)*be;he!==null&&(Me=Math.max(Me,he.start*be),He=Math.min(He,(he.start+he.count)*be)),_e!==null?(Me=Math.max(Me,0),He=Math.min(He,_e.count)):ze!=null&&(Me=Math.max(Me,0),He=Math.min(He,ze.count));const mt=He-Me;if(mt<0||mt===1/0)return;ae.setup(B,F,ce,H,_e);let it,et=$;if(_e!==null&&(it=v.get(_e),et=le,et.setIndex(it)),B.isMesh)F.wireframe===!0?(de.setLineWidth(F.wireframeLinewidth*Zt()),et.setMode(U.LINES)):et.setMode(U.TRIANGLES);else if(B.isLine){let Lt=F.linewidth;Lt===void 0&&(Lt=1),de.setLineWidth(Lt*Zt()),B.isLineSegments?et.setMode(U.LINES):B.isLineLoop?et.setMode(U.LINE_LOOP):et.setMode(U.LINE_STRIP)}else B.isPoints?et.setMode(U.POINTS):B.isSprite&&et.setMode(U.TRIANGLES);if(B.isBatchedMesh)if(at.get("WEBGL_multi_draw"))et.renderMultiDraw(B._multiDrawStarts,B._multiDrawCounts,B._multiDrawCount);else{const Lt=B._multiDrawStarts,ye=B._multiDrawCounts,Ut=B._multiDrawCount,$e=_e?v.get(_e).bytesPerElement:1,ai=Re.get(F).currentProgram.getUniforms();for(let Dt=0;Dt<Ut;Dt++)ai.setValue(U,"_gl_DrawID",Dt),et.render(Lt[Dt]/$e,ye[Dt])}else if(B.isInstancedMesh)et.renderInstances(Me,mt,B.count);else if(H.isInstancedBufferGeometry){const Lt=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,ye=Math.min(H.instanceCount,Lt);et.renderInstances(Me,mt,ye)}else et.render(Me,mt)};function Ul(M,D,H,F){k!==null&&M.isNodeMaterial&&k.setObject(F,M),xt===!0&&K.setState(M,H,!1),M.transparent===!0&&M.side===Sn&&M.forceSinglePass===!1?(M.side=Vt,M.needsUpdate=!0,Zi(M,D,F),M.side=gi,M.needsUpdate=!0,Zi(M,D,F),M.side=Sn):Zi(M,D,F)}this.compile=function(M,D,H=null){H===null&&(H=M),k!==null&&k.renderStart(M,D,H),A=Y.get(H),A.init(D),w.push(A),H.traverseVisible(function(B){B.isLight&&B.layers.test(D.layers)&&(A.pushLight(B),B.castShadow&&A.pushShadow(B))}),M!==H&&M.traverseVisible(function(B){B.isLight&&B.layers.test(D.layers)&&(A.pushLight(B),B.castShadow&&A.pushShadow(B))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),zt=this.localClippingEnabled,xt=K.init(this.clippingPlanes,zt),xt===!0&&K.setGlobalState(this.clippingPlanes,D),k!==null&&oe.render(A.state.shadowsArray,H,D);const F=new Set;return M.traverse(function(B){if(!(B.isMesh||B.isPoints||B.isLine||B.isSprite))return;const he=B.material;if(he)if(Array.isArray(he))for(let xe=0;xe<he.length;xe++){const ce=he[xe];Ul(ce,H,D,B),F.add(ce)}else Ul(he,H,D,B),F.add(he)}),A=w.pop(),k!==null&&k.renderEnd(),F},this.compileAsync=function(M,D,H=null){const F=this.compile(M,D,H);return new Promise(B=>{function he(){if(F.forEach(function(xe){const _e=Re.get(xe).currentProgram;(_e===void 0||_e.isReady())&&F.delete(xe)}),F.size===0){B(M);return}setTimeout(he,10)}at.get("KHR_parallel_shader_compile")!==null?he():setTimeout(he,10)})};let oa=null;function zd(M){oa&&oa(M)}function Fl(){ri.stop()}function Ol(){ri.start()}const ri=new _d;ri.setAnimationLoop(zd),typeof self<"u"&&ri.setContext(self),this.setAnimationLoop=function(M){oa=M,ie.setAnimationLoop(M),M===null?ri.stop():ri.start()},ie.addEventListener("sessionstart",Fl),ie.addEventListener("sessionend",Ol),this.render=function(M,D){if(D!==void 0&&D.isCamera!==!0){qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;k!==null&&k.renderStart(M,D);const H=ie.enabled===!0&&ie.isPresenting===!0,F=N!==null&&(q===null||H)&&N.begin(C,q);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),D.parent===null&&D.matrixWorldAutoUpdate===!0&&D.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(D),D=ie.getCamera()),M.isScene===!0&&M.onBeforeRender(C,M,D,q),A=Y.get(M,w.length),A.init(D),A.state.textureUnits=Le.getTextureUnits(),w.push(A),ct.multiplyMatrices(D.projectionMatrix,D.matrixWorldInverse),D.isArrayCamera?At.setFromArrayCamera(D):Be.setFromProjectionMatrix(ct,hn,D.reversedDepth),zt=this.localClippingEnabled,xt=K.init(this.clippingPlanes,zt),E=ue.get(M,p.length),E.init(),p.push(E),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){const xe=C.xr.getDepthSensingMesh();xe!==null&&la(xe,D,-1/0,C.sortObjects)}la(M,D,0,C.sortObjects),E.finish(),k!==null&&k.updateLights(A.state.lightsArray),C.sortObjects===!0&&E.sort(Ue,pt),Kt=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,Kt&&P.addToRenderList(E,M),this.info.autoReset===!0&&this.info.reset(),xt===!0&&K.beginShadows();const B=A.state.shadowsArray;if(oe.render(B,M,D),xt===!0&&K.endShadows(),(F&&N.hasRenderPass())===!1){const xe=E.opaque,ce=E.transmissive;if(A.setupLights(),D.isArrayCamera){const _e=D.cameras;if(ce.length>0)for(let be=0,Ie=_e.length;be<Ie;be++){const ze=_e[be];Bl(xe,ce,M,ze)}Kt&&P.render(M);for(let be=0,Ie=_e.length;be<Ie;be++){const ze=_e[be];kl(E,M,ze,ze.viewport)}}else ce.length>0&&Bl(xe,ce,M,D),Kt&&P.render(M),kl(E,M,D)}q!==null&&z===0&&(Le.updateMultisampleRenderTarget(q),Le.updateRenderTargetMipmap(q)),F&&N.end(C),M.isScene===!0&&M.onAfterRender(C,M,D),ae.resetDefaultState(),G=-1,j=null,w.pop(),w.length>0?(A=w[w.length-1],Le.setTextureUnits(A.state.textureUnits),xt===!0&&K.setGlobalState(C.clippingPlanes,A.state.camera)):A=null,p.pop(),p.length>0?E=p[p.length-1]:E=null,k!==null&&k.renderEnd()};function la(M,D,H,F){if(M.visible===!1)return;if(M.layers.test(D.layers)){if(M.isGroup)H=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(D);else if(M.isLight)A.pushLight(M),M.castShadow&&A.pushShadow(M);else if(M.isSprite){const xe=D.isArrayCamera?At:Be;if(!M.frustumCulled||M.intersectsFrustum(xe)){F&&Et.setFromMatrixPosition(M.matrixWorld).applyMatrix4(ct);const ce=ne.update(M),_e=M.material;_e.visible&&E.push(M,ce,_e,H,Et.z,null,D)}}else if(M.isMesh||M.isLine||M.isPoints){const xe=D.isArrayCamera?At:Be;if(!M.frustumCulled||M.intersectsFrustum(xe)){const ce=ne.update(M),_e=M.material;if(F&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),Et.copy(M.boundingSphere.center)):(ce.boundingSphere===null&&ce.computeBoundingSphere(),Et.copy(ce.boundingSphere.center)),Et.applyMatrix4(M.matrixWorld).applyMatrix4(ct)),Array.isArray(_e)){const be=ce.groups;for(let Ie=0,ze=be.length;Ie<ze;Ie++){const Me=be[Ie],He=_e[Me.materialIndex];He&&He.visible&&E.push(M,ce,He,H,Et.z,Me,D)}}else _e.visible&&E.push(M,ce,_e,H,Et.z,null,D)}}}const he=M.children;for(let xe=0,ce=he.length;xe<ce;xe++)la(he[xe],D,H,F)}function kl(M,D,H,F){const{opaque:B,transmissive:he,transparent:xe}=M;A.setupLightsView(H),xt===!0&&K.setGlobalState(C.clippingPlanes,H),F&&de.viewport(te.copy(F)),B.length>0&&Ts(B,D,H),he.length>0&&Ts(he,D,H),xe.length>0&&Ts(xe,D,H),de.buffers.depth.setTest(!0),de.buffers.depth.setMask(!0),de.buffers.color.setMask(!0),de.setPolygonOffset(!1)}function Bl(M,D,H,F){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[F.id]===void 0){const Me=at.has("EXT_color_buffer_half_float")||at.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[F.id]=new fn(1,1,{generateMipmaps:!0,type:Me?Wt:tn,minFilter:Jn,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ve.workingColorSpace})}const he=A.state.transmissionRenderTarget[F.id],xe=F.viewport||te;he.setSize(xe.z*C.transmissionResolutionScale,xe.w*C.transmissionResolutionScale);const ce=C.getRenderTarget(),_e=C.getActiveCubeFace(),be=C.getActiveMipmapLevel();C.setRenderTarget(he),C.getClearColor(Z),me=C.getClearAlpha(),me<1&&C.setClearColor(16777215,.5),C.clear(),Kt&&P.render(H);const Ie=C.toneMapping;C.toneMapping=Fn;const ze=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),A.setupLightsView(F),xt===!0&&K.setGlobalState(C.clippingPlanes,F),Ts(M,H,F),Le.updateMultisampleRenderTarget(he),Le.updateRenderTargetMipmap(he),at.has("WEBGL_multisampled_render_to_texture")===!1){let Me=!1;for(let He=0,mt=D.length;He<mt;He++){const it=D[He],{object:et,geometry:Lt,material:ye,group:Ut}=it;if(ye.side===Sn&&et.layers.test(F.layers)){const $e=ye.side;ye.side=Vt,ye.needsUpdate=!0,zl(et,H,F,Lt,ye,Ut),ye.side=$e,ye.needsUpdate=!0,Me=!0}}Me===!0&&(Le.updateMultisampleRenderTarget(he),Le.updateRenderTargetMipmap(he))}C.setRenderTarget(ce,_e,be),C.setClearColor(Z,me),ze!==void 0&&(F.viewport=ze),C.toneMapping=Ie}function Ts(M,D,H){const F=D.isScene===!0?D.overrideMaterial:null;for(let B=0,he=M.length;B<he;B++){const xe=M[B],{object:ce,geometry:_e,group:be}=xe;let Ie=xe.material;Ie.allowOverride===!0&&F!==null&&(Ie=F),ce.layers.test(H.layers)&&zl(ce,D,H,_e,Ie,be)}}function zl(M,D,H,F,B,he){k!==null&&B.isNodeMaterial&&k.setObject(M,B),M.onBeforeRender(C,D,H,F,B,he),M.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),B.onBeforeRender(C,D,H,F,M,he),B.transparent===!0&&B.side===Sn&&B.forceSinglePass===!1?(B.side=Vt,B.needsUpdate=!0,C.renderBufferDirect(H,D,F,B,M,he),B.side=gi,B.needsUpdate=!0,C.renderBufferDirect(H,D,F,B,M,he),B.side=Sn):C.renderBufferDirect(H,D,F,B,M,he),M.onAfterRender(C,D,H,F,B,he)}function Hl(M){let D=0;for(const H of M)H.texture!==null&&D++;return D}function Zi(M,D,H){D.isScene!==!0&&(D=Yt);const F=Re.get(M),B=A.state.lights,he=A.state.shadowsArray,xe=B.state.version,ce=ee.getParameters(M,B.state,he,D,H,A.state.lightProbeGridArray),_e=ee.getProgramCacheKey(ce);let be=F.programs;F.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?D.environment:null,F.fog=D.fog;const Ie=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;F.envMap=R.get(M.envMap||F.environment,Ie),F.envMapRotation=F.environment!==null&&M.envMap===null?D.environmentRotation:M.envMapRotation,be===void 0&&(M.addEventListener("dispose",Ze),be=new Map,F.programs=be,F.programVariants=new Map);let ze=be.get(_e);if(ze!==void 0){if(F.currentProgram===ze&&F.lightsStateVersion===xe)return Vl(M,ce),ze}else ce.uniforms=ee.getUniforms(M),k!==null&&M.isNodeMaterial&&k.build(M,H,ce),M.onBeforeCompile(ce,C),ze=ee.acquireProgram(ce,_e),be.set(_e,ze),F.uniforms=ce.uniforms;const Me=F.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Me.clippingPlanes=K.uniform),Vl(M,ce),F.needsLights=Wd(M),F.lightsStateVersion=xe,F.needsLights&&(Me.ambientLightColor.value=B.state.ambient,Me.lightProbe.value=B.state.probe,Me.sunLights.value=B.state.sun,Me.sunLightShadows.value=B.state.sunShadow,Me.directionalLights.value=B.state.directional,Me.directionalLightShadows.value=B.state.directionalShadow,Me.spotLights.value=B.state.spot,Me.spotLightShadows.value=B.state.spotShadow,Me.rectAreaLights.value=B.state.rectArea,Me.ltc_1.value=B.state.rectAreaLTC1,Me.ltc_2.value=B.state.rectAreaLTC2,Me.pointLights.value=B.state.point,Me.pointLightShadows.value=B.state.pointShadow,Me.hemisphereLights.value=B.state.hemi,Me.sunShadowMatrix.value=B.state.sunShadowMatrix,Me.sunShadowCascade.value=B.state.sunShadowCascade,Me.directionalShadowMatrix.value=B.state.directionalShadowMatrix,Me.spotLightMatrix.value=B.state.spotLightMatrix,Me.spotLightMap.value=B.state.spotLightMap,Me.pointShadowMatrix.value=B.state.pointShadowMatrix),F.numLightProbeGrids=Hl(A.state.lightProbeGridArray),F.currentProgram=ze,F.uniformsList=null,ze}function Hd(M,D,H,F,B){const he=Re.get(M),xe=he.currentProgram.id+","+F+","+B;let ce=he.programVariants.get(xe);return ce===void 0?(ce=Zi(M,D,H),he.programVariants.set(xe,ce)):(he.currentProgram=ce,he.uniformsList=null,he.outputColorSpace=F,he.toneMapping=B),ce}function Gl(M){if(M.uniformsList===null){const D=M.currentProgram.getUniforms();M.uniformsList=mr.seqWithValue(D.seq,M.uniforms)}return M.uniformsList}function Vl(M,D){const H=Re.get(M);H.outputColorSpace=D.outputColorSpace,H.batching=D.batching,H.batchingColor=D.batchingColor,H.instancing=D.instancing,H.instancingColor=D.instancingColor,H.instancingMorph=D.instancingMorph,H.skinning=D.skinning,H.morphTargets=D.morphTargets,H.morphNormals=D.morphNormals,H.morphColors=D.morphColors,H.morphTargetsCount=D.morphTargetsCount,H.numClippingPlanes=D.numClippingPlanes,H.numIntersection=D.numClipIntersection,H.vertexAlphas=D.vertexAlphas,H.vertexTangents=D.vertexTangents,H.toneMapping=D.toneMapping}function Gd(M,D,H,F,B){D.isScene!==!0&&(D=Yt),Le.resetTextureUnits();const he=D.fog,xe=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?D.environment:null,ce=q===null?C.outputColorSpace:q.isXRRenderTarget===!0?q.texture.colorSpace:Ve.workingColorSpace,_e=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,be=R.get(F.envMap||xe,_e),Ie=F.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,ze=!!H.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),Me=!!H.morphAttributes.position,He=!!H.morphAttributes.normal,mt=!!H.morphAttributes.color;let it=Fn;F.toneMapped&&(q===null||q.isXRRenderTarget===!0)&&(it=C.toneMapping);const et=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,Lt=et!==void 0?et.length:0,ye=Re.get(F),Ut=A.state.lights;if(xt===!0&&(zt===!0||M!==j)){const ut=M===j&&F.id===G;K.setState(F,M,ut)}let $e=!1,ai=!1;F.version===ye.__version?ye.needsLights&&ye.lightsStateVersion!==Ut.state.version||B.isBatchedMesh&&ye.batching===!1||!B.isBatchedMesh&&ye.batching===!0||B.isBatchedMesh&&ye.batchingColor===!0&&B._colorsTexture===null||B.isBatchedMesh&&ye.batchingColor===!1&&B._colorsTexture!==null||B.isInstancedMesh&&ye.instancing===!1||!B.isInstancedMesh&&ye.instancing===!0||B.isSkinnedMesh&&ye.skinning===!1||!B.isSkinnedMesh&&ye.skinning===!0||B.isInstancedMesh&&ye.instancingColor===!0&&B.instanceColor===null||B.isInstancedMesh&&ye.instancingColor===!1&&B.instanceColor!==null||B.isInstancedMesh&&ye.instancingMorph===!0&&B.morphTexture===null||B.isInstancedMesh&&ye.instancingMorph===!1&&B.morphTexture!==null||ye.envMap!==be||F.fog===!0&&ye.fog!==he||ye.numClippingPlanes!==void 0&&(ye.numClippingPlanes!==K.numPlanes||ye.numIntersection!==K.numIntersection)||ye.vertexAlphas!==Ie||ye.vertexTangents!==ze||ye.morphTargets!==Me||ye.morphNormals!==He||ye.morphColors!==mt||ye.morphTargetsCount!==Lt||ye.numLightProbeGrids!==Hl(A.state.lightProbeGridArray)?$e=!0:(ye.outputColorSpace!==ce||ye.toneMapping!==it)&&(ai=!0):($e=!0,ye.__version=F.version);let Dt=ye.currentProgram;($e===!0||ai===!0)&&(Dt=ai===!0?Hd(F,D,B,ce,it):Zi(F,D,B),k&&F.isNodeMaterial&&k.onUpdateProgram(F,Dt,ye));let As=!1,Hn=!1,oi=!1;const We=Dt.getUniforms(),Rt=ye.uniforms;if(de.useProgram(Dt.program)&&(As=!0,Hn=!0,oi=!0),F.id!==G&&(G=F.id,Hn=!0),As||j!==M){de.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),We.setValue(U,"projectionMatrix",M.projectionMatrix),We.setValue(U,"viewMatrix",M.matrixWorldInverse);const wt=We.map.cameraPosition;wt!==void 0&&wt.setValue(U,mn.setFromMatrixPosition(M.matrixWorld)),ot.logarithmicDepthBuffer&&We.setValue(U,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&We.setValue(U,"isOrthographic",M.isOrthographicCamera===!0),j!==M&&(j=M,Hn=!0,oi=!0)}if(ye.needsLights&&(Ut.state.sunShadowMap.length>0&&We.setValue(U,"sunShadowMap",Ut.state.sunShadowMap,Le),Ut.state.directionalShadowMap.length>0&&We.setValue(U,"directionalShadowMap",Ut.state.directionalShadowMap,Le),Ut.state.spotShadowMap.length>0&&We.setValue(U,"spotShadowMap",Ut.state.spotShadowMap,Le),Ut.state.pointShadowMap.length>0&&We.setValue(U,"pointShadowMap",Ut.state.pointShadowMap,Le)),B.isSkinnedMesh){We.setOptional(U,B,"bindMatrix"),We.setOptional(U,B,"bindMatrixInverse");const ut=B.skeleton;ut&&(ut.boneTexture===null&&ut.computeBoneTexture(),We.setValue(U,"boneTexture",ut.boneTexture,Le))}B.isBatchedMesh&&(We.setOptional(U,B,"batchingTexture"),We.setValue(U,"batchingTexture",B._matricesTexture,Le),We.setOptional(U,B,"batchingIdTexture"),We.setValue(U,"batchingIdTexture",B._indirectTexture,Le),We.setOptional(U,B,"batchingColorTexture"),B._colorsTexture!==null&&We.setValue(U,"batchingColorTexture",B._colorsTexture,Le));const an=H.morphAttributes;if((an.position!==void 0||an.normal!==void 0||an.color!==void 0)&&J.update(B,H,Dt),(Hn||ye.receiveShadow!==B.receiveShadow)&&(ye.receiveShadow=B.receiveShadow,We.setValue(U,"receiveShadow",B.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&D.environment!==null&&(Rt.envMapIntensity.value=D.environmentIntensity),Rt.dfgLUT!==void 0&&(Rt.dfgLUT.value=Lx()),Hn){if(We.setValue(U,"toneMappingExposure",C.toneMappingExposure),ye.needsLights&&Vd(Rt,oi),he&&F.fog===!0&&re.refreshFogUniforms(Rt,he),re.refreshMaterialUniforms(Rt,F,ge,Ae,A.state.transmissionRenderTarget[M.id]),ye.needsLights&&ye.numLightProbeGrids>0){const ut=S;let wt=0;for(const wn of A.state.lightProbeGridArray)wn.texture!==null&&(ut.textures[wt]=wn.texture,ut.min[wt]=wn.boundingBox.min,ut.max[wt]=wn.boundingBox.max,ut.resolution[wt]=wn.resolution,wt++);for(const wn in ut)ut[wn].length=wt;Rt.probesSH.value=ut.textures,Rt.probesMin.value=ut.min,Rt.probesMax.value=ut.max,Rt.probesResolution.value=ut.resolution}mr.upload(U,Gl(ye),Rt,Le)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(mr.upload(U,Gl(ye),Rt,Le),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&We.setValue(U,"center",B.center),We.setValue(U,"modelViewMatrix",B.modelViewMatrix),We.setValue(U,"normalMatrix",B.normalMatrix),We.setValue(U,"modelMatrix",B.matrixWorld),F.uniformsGroups!==void 0){const ut=F.uniformsGroups;for(let wt=0,wn=ut.length;wt<wn;wt++){const Xl=ut[wt];we.update(Xl,Dt),we.bind(Xl,Dt)}}return Dt}function Vd(M,D){M.ambientLightColor.needsUpdate=D,M.lightProbe.needsUpdate=D,M.sunLights.needsUpdate=D,M.sunLightShadows.needsUpdate=D,M.directionalLights.needsUpdate=D,M.directionalLightShadows.needsUpdate=D,M.pointLights.needsUpdate=D,M.pointLightShadows.needsUpdate=D,M.spotLights.needsUpdate=D,M.spotLightShadows.needsUpdate=D,M.rectAreaLights.needsUpdate=D,M.hemisphereLights.needsUpdate=D}function Wd(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return Q},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return q},this.setRenderTargetTextures=function(M,D,H){const F=Re.get(M);F.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),Re.get(M.texture).__webglTexture=D,Re.get(M.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:H,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,D){const H=Re.get(M);H.__webglFramebuffer=D,H.__useDefaultFramebuffer=D===void 0},this.setRenderTarget=function(M,D=0,H=0){q=M,Q=D,z=H;let F=null,B=!1,he=!1;if(M){const ce=Re.get(M);if(ce.__useDefaultFramebuffer!==void 0){de.bindFramebuffer(U.FRAMEBUFFER,ce.__webglFramebuffer),te.copy(M.viewport),Ee.copy(M.scissor),Ne=M.scissorTest,de.viewport(te),de.scissor(Ee),de.setScissorTest(Ne),G=-1;return}else if(ce.__webglFramebuffer===void 0)Le.setupRenderTarget(M);else if(ce.__hasExternalTextures)Le.rebindTextures(M,Re.get(M.texture).__webglTexture,Re.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){const Ie=M.depthTexture;if(ce.__boundDepthTexture!==Ie){if(Ie!==null&&Re.has(Ie)&&(M.width!==Ie.image.width||M.height!==Ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Le.setupDepthRenderbuffer(M)}}const _e=M.texture;(_e.isData3DTexture||_e.isDataArrayTexture||_e.isCompressedArrayTexture)&&(he=!0);const be=Re.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(be[D])?F=be[D][H]:F=be[D],B=!0):M.samples>0&&Le.useMultisampledRTT(M)===!1?F=Re.get(M).__webglMultisampledFramebuffer:Array.isArray(be)?F=be[H]:F=be,te.copy(M.viewport),Ee.copy(M.scissor),Ne=M.scissorTest}else te.copy(Ce).multiplyScalar(ge).floor(),Ee.copy(Ke).multiplyScalar(ge).floor(),Ne=je;if(H!==0&&(F=X),de.bindFramebuffer(U.FRAMEBUFFER,F)&&de.drawBuffers(M,F),de.viewport(te),de.scissor(Ee),de.setScissorTest(Ne),B){const ce=Re.get(M.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+D,ce.__webglTexture,H)}else if(he){const ce=D;for(let _e=0;_e<M.textures.length;_e++){const be=Re.get(M.textures[_e]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+_e,be.__webglTexture,H,ce)}}else if(M!==null&&H!==0){const ce=Re.get(M.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ce.__webglTexture,H)}G=-1};function Wl(M){const D=Re.get(M);return(D.__readFormat!==M.format||D.__readType!==M.type)&&(D.__readFormat=M.format,D.__readType=M.type,D.__formatReadable=ot.textureFormatReadable(M.format),D.__typeReadable=ot.textureTypeReadable(M.type)),D}this.readRenderTargetPixels=function(M,D,H,F,B,he,xe,ce=0){if(!(M&&M.isWebGLRenderTarget)){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _e=Re.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&xe!==void 0&&(_e=_e[xe],Array.isArray(_e)&&(_e=_e[0])),_e){de.bindFramebuffer(U.FRAMEBUFFER,_e);try{const be=M.textures[ce],Ie=be.format,ze=be.type;M.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ce);const Me=Wl(be);if(Me.__formatReadable===!1){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Me.__typeReadable===!1){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}D>=0&&D<=M.width-F&&H>=0&&H<=M.height-B&&U.readPixels(D,H,F,B,se.convert(Ie),se.convert(ze),he)}finally{const be=q!==null?Re.get(q).__webglFramebuffer:null;de.bindFramebuffer(U.FRAMEBUFFER,be)}}},this.readRenderTargetPixelsAsync=async function(M,D,H,F,B,he,xe,ce=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _e=Re.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&xe!==void 0&&(_e=_e[xe],Array.isArray(_e)&&(_e=_e[0])),_e)if(D>=0&&D<=M.width-F&&H>=0&&H<=M.height-B){de.bindFramebuffer(U.FRAMEBUFFER,_e);const be=M.textures[ce],Ie=be.format,ze=be.type;M.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ce);const Me=Wl(be);if(Me.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Me.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const He=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,He),U.bufferData(U.PIXEL_PACK_BUFFER,he.byteLength,U.STREAM_READ),U.readPixels(D,H,F,B,se.convert(Ie),se.convert(ze),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);const mt=q!==null?Re.get(q).__webglFramebuffer:null;de.bindFramebuffer(U.FRAMEBUFFER,mt);const it=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await Qp(U,it,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,He),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,he),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(He),U.deleteSync(it),he}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,D=null,H=0){const F=Math.pow(2,-H),B=Math.floor(M.image.width*F),he=Math.floor(M.image.height*F),xe=D!==null?D.x:0,ce=D!==null?D.y:0;Le.setTexture2D(M,0),U.copyTexSubImage2D(U.TEXTURE_2D,H,0,0,xe,ce,B,he),de.unbindTexture()},this.copyTextureToTexture=function(M,D,H=null,F=null,B=0,he=0){let xe,ce,_e,be,Ie,ze,Me,He,mt;const it=M.isCompressedTexture?M.mipmaps[he]:M.image;if(H!==null)xe=H.max.x-H.min.x,ce=H.max.y-H.min.y,_e=H.isBox3?H.max.z-H.min.z:1,be=H.min.x,Ie=H.min.y,ze=H.isBox3?H.min.z:0;else{const We=Math.pow(2,-B);xe=Math.floor(it.width*We),ce=Math.floor(it.height*We),M.isDataArrayTexture?_e=it.depth:M.isData3DTexture?_e=Math.floor(it.depth*We):_e=1,be=0,Ie=0,ze=0}F!==null?(Me=F.x,He=F.y,mt=F.z):(Me=0,He=0,mt=0);const et=se.convert(D.format),Lt=se.convert(D.type);let ye;D.isData3DTexture?(Le.setTexture3D(D,0),ye=U.TEXTURE_3D):D.isDataArrayTexture||D.isCompressedArrayTexture?(Le.setTexture2DArray(D,0),ye=U.TEXTURE_2D_ARRAY):(Le.setTexture2D(D,0),ye=U.TEXTURE_2D),de.activeTexture(U.TEXTURE0),de.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,D.flipY),de.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,D.premultiplyAlpha),de.pixelStorei(U.UNPACK_ALIGNMENT,D.unpackAlignment);const Ut=de.getParameter(U.UNPACK_ROW_LENGTH),$e=de.getParameter(U.UNPACK_IMAGE_HEIGHT),ai=de.getParameter(U.UNPACK_SKIP_PIXELS),Dt=de.getParameter(U.UNPACK_SKIP_ROWS),As=de.getParameter(U.UNPACK_SKIP_IMAGES);de.pixelStorei(U.UNPACK_ROW_LENGTH,it.width),de.pixelStorei(U.UNPACK_IMAGE_HEIGHT,it.height),de.pixelStorei(U.UNPACK_SKIP_PIXELS,be),de.pixelStorei(U.UNPACK_SKIP_ROWS,Ie),de.pixelStorei(U.UNPACK_SKIP_IMAGES,ze);const Hn=M.isDataArrayTexture||M.isData3DTexture,oi=D.isDataArrayTexture||D.isData3DTexture;if(M.isDepthTexture){const We=Re.get(M),Rt=Re.get(D),an=Re.get(We.__renderTarget),ut=Re.get(Rt.__renderTarget);de.bindFramebuffer(U.READ_FRAMEBUFFER,an.__webglFramebuffer),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,ut.__webglFramebuffer);for(let wt=0;wt<_e;wt++)Hn&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Re.get(M).__webglTexture,B,ze+wt),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Re.get(D).__webglTexture,he,mt+wt)),U.blitFramebuffer(be,Ie,be+xe,Ie+ce,Me,He,Me+xe,He+ce,U.DEPTH_BUFFER_BIT,U.NEAREST);de.bindFramebuffer(U.READ_FRAMEBUFFER,null),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(B!==0||M.isRenderTargetTexture||Re.has(M)){const We=Re.get(M),Rt=Re.get(D);de.bindFramebuffer(U.READ_FRAMEBUFFER,I),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,V);for(let an=0;an<_e;an++)Hn?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,We.__webglTexture,B,ze+an):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,We.__webglTexture,B),oi?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Rt.__webglTexture,he,mt+an):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Rt.__webglTexture,he),B!==0?U.blitFramebuffer(be,Ie,be+xe,Ie+ce,Me,He,Me+xe,He+ce,U.COLOR_BUFFER_BIT,U.NEAREST):oi?U.copyTexSubImage3D(ye,he,Me,He,mt+an,be,Ie,xe,ce):U.copyTexSubImage2D(ye,he,Me,He,be,Ie,xe,ce);de.bindFramebuffer(U.READ_FRAMEBUFFER,null),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else oi?M.isDataTexture||M.isData3DTexture?U.texSubImage3D(ye,he,Me,He,mt,xe,ce,_e,et,Lt,it.data):D.isCompressedArrayTexture?U.compressedTexSubImage3D(ye,he,Me,He,mt,xe,ce,_e,et,it.data):U.texSubImage3D(ye,he,Me,He,mt,xe,ce,_e,et,Lt,it):M.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,he,Me,He,xe,ce,et,Lt,it.data):M.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,he,Me,He,it.width,it.height,et,it.data):U.texSubImage2D(U.TEXTURE_2D,he,Me,He,xe,ce,et,Lt,it);de.pixelStorei(U.UNPACK_ROW_LENGTH,Ut),de.pixelStorei(U.UNPACK_IMAGE_HEIGHT,$e),de.pixelStorei(U.UNPACK_SKIP_PIXELS,ai),de.pixelStorei(U.UNPACK_SKIP_ROWS,Dt),de.pixelStorei(U.UNPACK_SKIP_IMAGES,As),he===0&&D.generateMipmaps===!0&&D.mipmapsAutoUpdate===!0&&U.generateMipmap(ye),de.unbindTexture()},this.initRenderTarget=function(M){Re.get(M).__webglFramebuffer===void 0&&Le.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Le.setTextureCube(M,0):M.isData3DTexture?Le.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Le.setTexture2DArray(M,0):Le.setTexture2D(M,0),de.unbindTexture()},this.resetState=function(){Q=0,z=0,q=null,de.reset(),ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return hn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=Ve._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ve._getUnpackColorSpace()}}function Nx(n){const e=n.getContext("webgl2",{alpha:!0,antialias:!1,depth:!1,preserveDrawingBuffer:!0});if(e===null)throw new Error("this browser has no WebGL 2");if(e.getExtension("EXT_color_buffer_float")===null)throw new Error("this browser's WebGL 2 does not draw into floats");const t=new Dx({canvas:n,context:e});return t.autoClear=!1,t.sortObjects=!1,t.setClearColor(0,0),t.outputColorSpace=_s,t.debug.onShaderError=(i,s,r,a)=>{const o=[i.getProgramInfoLog(s)];throw o.push(i.getShaderInfoLog(r),i.getShaderInfoLog(a)),new Error(`shader: ${o.join(`
`)}`)},t}const pu=new wl;class Or{constructor(e,t,i,{adds:s=!1,depth:r=!1}={}){this.renderer=e,this.scene=new gm,this.compiled=!1,this.fault=null;const a=new gd({glslVersion:Ho,vertexShader:t,fragmentShader:i,side:Sn,depthTest:r,depthWrite:r,depthFunc:Rr,blending:s?Bh:fi,blendSrc:no,blendDst:no});this.mesh=new ii(new Bn,a),this.mesh.geometry.setDrawRange(0,3),this.mesh.frustumCulled=!1,this.scene.add(this.mesh),this.scene.matrixWorldAutoUpdate=!1,e.compileAsync(this.scene,pu).then(()=>this.compiled=!0,o=>this.fault=o)}ready(){if(this.fault!==null)throw this.fault;return this.compiled}setMesh({positions:e,normals:t,indices:i}){const s=new Bn;s.setAttribute("position",new En(e,3)),s.setAttribute("normal",new En(t,3)),s.setIndex(new En(i,1)),this.mesh.geometry.dispose(),this.mesh.geometry=s}set(e){const{uniforms:t}=this.mesh.material;for(const[i,s]of Object.entries(e)){const r=t[i];r===void 0?t[i]={value:s}:r.value=s}}draw(e,t){e!==null&&(e.scissorTest=t!==void 0,t!==void 0&&e.scissor.set(0,t[0],e.width,t[1])),this.renderer.setRenderTarget(e),this.renderer.render(this.scene,pu)}}function kr(n,e,t,i,{count:s=1,depth:r=!1,linear:a=!1,red:o=!1}={}){const l=new fn(e,t,{count:s,type:i,format:o?Qr:nn,minFilter:a?Pt:vt,magFilter:a?Pt:vt,depthBuffer:r});return Br(n,l),l}function Br(n,e){e.scissorTest=!1,n.setRenderTarget(e),n.clear(!0,e.depthBuffer,!1)}function gr(n,e,t,i,{linear:s=!1,repeat:r=!1}={}){const[a=1,o=1,l]=t;if(n instanceof Wo||n instanceof Vo){const{image:u}=n,f="depth"in u?u.depth:void 0;if(u.width===a&&u.height===o&&f===l)return u.data=i,n.needsUpdate=!0,n}n?.dispose();const c=l===void 0?new Wo(i,a,o):new Vo(i,a,o,l);return c.format=e==="r32f"?Qr:nn,c.internalFormat=e==="r32f"?"R32F":"RGBA16F",c.type=i instanceof Uint16Array?Wt:Ot,c.minFilter=c.magFilter=s?Pt:vt,c.wrapS=r?Cr:Mn,c.needsUpdate=!0,c}const pi=Math.PI/180,zr=(n,e)=>[n[0]+e[0],n[1]+e[1],n[2]+e[2]],Ix=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],yn=(n,e)=>[n*e[0],n*e[1],n*e[2]],mu=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],Ux=n=>yn(1/Math.hypot(...n),n);function Rd(n,e){const t=new Float32Array(16);for(let i=0;i<4;++i)for(let s=0;s<4;++s){let r=0;for(let a=0;a<4;++a)r+=n[4*a+s]*e[4*i+a];t[4*i+s]=r}return t}function _r(n,e){const t=ia(1),[i,s]=[Math.cos(e*pi),Math.sin(e*pi)],[r,a]=[(n+1)%3,(n+2)%3];return t[5*r]=t[5*a]=i,t[4*r+a]=s,t[4*a+r]=-s,t}function ia(n){return new Float32Array([n,0,0,0,0,n,0,0,0,0,n,0,0,0,0,1])}function qo(n){const e=ia(1);return e.set(n,12),e}function Cd(n,e,t){const[i,s,r]=n.rotation_deg;return[Ox(t,e),qo(n.translation_mm),_r(2,r),_r(1,s),_r(0,i),ia(n.scale)].reduce(Rd)}function Fx(n){const e=ia(1);for(let t=0;t<3;++t){let i=0;for(let s=0;s<3;++s){const r=n[4*t+s];e[4*s+t]=r,i-=r*n[12+s]}e[12+t]=i}return e}function Ox(n,e){return[qo(n),_r(2,e),qo(yn(-1,n))].reduce(Rd)}function ss(n,e){const[t,i]=[Math.cos(e*pi),Math.sin(e*pi)];return[t*n[0]-i*n[1],i*n[0]+t*n[1],n[2]]}const kx=(n,e,t)=>zr(t,ss(Ix(n,t),e));function Bx(n,e){const[t,i]=[n.azimuth_deg*pi,n.elevation_deg*pi],s=[Math.cos(i)*Math.cos(t),Math.cos(i)*Math.sin(t),Math.sin(i)],r=yn(-1,s),a=Ux(mu(r,[0,0,1])),o=Math.tan(.5*n.fov_deg*pi);return{place:zr(n.target_mm,yn(n.distance_mm,s)),ahead:r,across:yn(o*e,a),upwards:yn(o,mu(a,r))}}function zx(n,e,t){const[i,s]=[.1*e,10*e],r=[n.across,n.upwards].map(_=>yn(1/(_[0]**2+_[1]**2+_[2]**2),_)),[a,o]=r,{ahead:l,place:c}=n,u=(s+i)/(s-i),f=(_,y)=>_[0]*y[0]+_[1]*y[1]+_[2]*y[2],h=new Float32Array(16),g=(_,y,d)=>{for(let m=0;m<3;++m)h[4*m+_]=y[m];h[12+_]=d-f(y,c)};return g(0,zr(a,yn(t[0],l)),0),g(1,zr(o,yn(t[1],l)),0),g(2,yn(u,l),-2*s*i/(s-i)),g(3,l,0),h}const Bi=16,gu=4,Ha=Math.sqrt(Bi),Ga=n=>n<.5?Math.sqrt(2*n)-1:1-Math.sqrt(Math.max(2-2*n,0));function _u(n,e){const[t,i]=[Ga(n/Ha),Ga((n+1)/Ha)],[s,r]=[.5*(t+i),i-t],a=.5*r/(1-Math.abs(s));return[Ga((n+e)/Ha),s,r,s<0?a:-a]}function vu(n,e){if(!e)return{sampled:!1,stratum:xu(n)};const t=n<Bi||n%gu===0,i=Math.min(n,Bi)+Math.ceil(Math.max(n-Bi,0)/gu);return{sampled:t,stratum:xu(t?i:n-i)}}function xu(n){const[e,t]=[Math.floor(n/Bi),n%Bi],i=l=>t>>l&1,s=2*i(0)+i(2),r=2*(i(0)^i(1))+(i(2)^i(3)),a=_u(s,(e*.7548776662+.5)%1),o=_u(r,(e*.569840291+.5)%1);return{place:[a[0],o[0]],middle:[a[1],o[1]],size:[a[2],o[2]],tilt:[a[3],o[3]]}}function Hx(n,e,t){return Fx(Cd({...n,scale:1},e,t))}function Gx(n,{middle:e,size:t,tilt:i},s,r){return{flakesShown:s?1:0,flakesSampled:r?1:0,toRest:n,stratumMiddle:e,stratumSize:t,stratumTilt:i}}const Vx=`
#ifdef NACRE_FLAKES
uniform bool flakesShown;
uniform bool flakesSampled;
uniform mat4 toRest;
uniform vec2 stratumMiddle;  // in pixels, from the middle of this one
uniform vec2 stratumSize;
uniform vec2 stratumTilt;

vec3 lookedAtFrom;
mat3 lookedAtFrame;
vec3 nacreRadiance(vec3 wo) {
    float ignored;
    return radianceFrom(lookedAtFrom, lookedAtFrame * wo, ignored);
}

/// What the stratum of a pixel covers of the surface, which is flat there.
NacrePatch patchOn(vec3 place, mat3 toWorld) {
    vec3 n = toWorld[2], q = place - eye;
    float depth = dot(q, ahead);
    q /= depth;
    float facing = dot(n, q);
    if (abs(facing) < 1e-6) facing = -1e-6;
    vec3 stepX = across * (2. / size.x), stepY = upwards * (2. / size.y);
    vec3 edgeX = depth * (stepX - q * (dot(n, stepX) / facing));
    vec3 edgeY = depth * (stepY - q * (dot(n, stepY) / facing));
    vec2 from = stratumMiddle - shift;
    vec3 middle = place + from.x * edgeX + from.y * edgeY;
    mat3 turn = mat3(toRest);
    return NacrePatch((toRest * vec4(middle, 1.)).xyz, normalize(turn * n), normalize(turn * toWorld[0]),
                      stratumSize.x * (turn * edgeX), stratumSize.y * (turn * edgeY), stratumTilt);
}

vec3 shadedFlakes(vec3 place, mat3 toWorld, vec3 wi, vec3 towardsSun) {
    if (!flakesShown) {
        nacreShowNone();
        nacreSunResolved = nacreResolved;
        return vec3(0.);
    }
    lookedAtFrom = place;
    lookedAtFrame = toWorld;
    float angle = 2. * PI * (1. - sun.w);
    return nacreFlakes(patchOn(place, toWorld), flakesSampled, wi, towardsSun, sunRadiance * angle, angle,
                       mixBits(pixelBits ^ (sampleIndex * 0x9e3779b9u)));
}
#else
const bool flakesSampled = false;
vec3 shadedFlakes(vec3 place, mat3 toWorld, vec3 wi, vec3 towardsSun) { return vec3(0.); }
void nacreWithoutSunlit() {}
#endif
`,Dn=4,Wx=115,Ki=`
precision highp float;
precision highp int;
precision highp sampler2D;
#define PI 3.141592653589793
`,Pd=`
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.);
}`,Su=`
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 toWorld;
uniform mat4 toScreen;
out vec3 place;
out vec3 facing;
void main() {
    vec4 world = toWorld * vec4(position, 1.);
    place = world.xyz;
    facing = mat3(toWorld) * normal;
    gl_Position = toScreen * world;
}`,Mu=`${Ki}
in vec3 place;
in vec3 facing;
layout(location = 0) out vec4 placeAt;
layout(location = 1) out vec4 facingAt;
void main() {
    placeAt = vec4(place, 1.);
    facingAt = vec4(normalize(facing), 0.);
}`;function Xx(n,e){return`${Ki}
${n}
uniform sampler2D placeAt;
uniform sampler2D facingAt;
uniform sampler2D surroundings;
uniform sampler2D byColumn;
uniform sampler2D byRow;
uniform float azimuth;           // of the middle of the surroundings
uniform vec4 sun;                // towards it, and the cosine of its radius; 2: there is none
uniform vec3 sunRadiance;
uniform int rectangleCount;
uniform vec3 corner[${String(Dn)}];
uniform vec3 edgeU[${String(Dn)}];
uniform vec3 edgeV[${String(Dn)}];
uniform vec3 rectangleNormal[${String(Dn)}];
uniform vec3 rectangleRadiance[${String(Dn)}];
uniform vec3 eye;
uniform vec3 ahead;              // to the middle of the picture, and half its width and height
uniform vec3 across;
uniform vec3 upwards;
uniform vec2 size;
uniform vec2 shift;              // of this sample within its pixel
uniform uint sampleIndex;
uniform int interleaved;         // pixels of a side of which each takes other ones of the same numbers; 0: none
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 flakes;  // their light apart, as not all samples have it

uint mixBits(uint x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
uint pixelBits, number;
/// Numbers in [0, 1) that fill the square evenly from sample to sample, shifted by pixel.
vec2 evenly(uint which) {
    uint a = mixBits(pixelBits + which * 0x9e3779b9u), b = mixBits(a);
    return vec2((uvec2(a, b) + number * uvec2(3242174889u, 2447445413u)) >> 8) * 0x1p-24_;
}
float evenlyOne(uint which) {
    return float((mixBits(pixelBits ^ (which * 0x85ebca6bu)) + number * 2654435769u) >> 8) * 0x1p-24_;
}

vec2 placeOf(vec3 w) {
    float u = (azimuth - atan(w.y, w.x)) / (2. * PI) + .5;
    return vec2(u - floor(u), acos(clamp(w.z, -1., 1.)) / PI);
}
vec3 fromAfar(vec3 w) { return textureLod(surroundings, placeOf(w), 0.).rgb; }

float columnAt(int x, int y) { return x < 0 ? 0. : texelFetch(byColumn, ivec2(x, y), 0).r; }
float rowAt(int y) { return y < 0 ? 0. : texelFetch(byRow, ivec2(y, 0), 0).r; }
/// Density per solid angle of drawFromAfar() in a texel.
float densityOf(ivec2 texel, ivec2 texels) {
    float top = PI * float(texel.y) / float(texels.y), bottom = PI * float(texel.y + 1) / float(texels.y);
    float solidAngle = 2. * PI / float(texels.x) * (cos(top) - cos(bottom));
    return (columnAt(texel.x, texel.y) - columnAt(texel.x - 1, texel.y)) *
           (rowAt(texel.y) - rowAt(texel.y - 1)) / solidAngle;
}
float densityFromAfar(vec3 w) {
    ivec2 texels = textureSize(byColumn, 0);
    return densityOf(min(ivec2(placeOf(w) * vec2(texels)), texels - 1), texels);
}
vec3 drawFromAfar(vec2 u) {
    ivec2 texels = textureSize(byColumn, 0);
    int y = 0;
    int high = texels.y - 1;
    do {
        int middle = (y + high) / 2;
        if (rowAt(middle) > u.y) high = middle; else y = middle + 1;
    } while (y < high);
    int x = 0;
    high = texels.x - 1;
    do {
        int middle = (x + high) / 2;
        if (columnAt(middle, y) > u.x) high = middle; else x = middle + 1;
    } while (x < high);
    float left = columnAt(x - 1, y), above = rowAt(y - 1);
    vec2 part = clamp(vec2((u.x - left) / max(columnAt(x, y) - left, 1e-20),
                           (u.y - above) / max(rowAt(y) - above, 1e-20)), 0., 1.);
    float top = cos(PI * float(y) / float(texels.y)), bottom = cos(PI * float(y + 1) / float(texels.y));
    float z = mix(top, bottom, part.y), r = sqrt(max(1. - z * z, 0.));
    float turn = azimuth - 2. * PI * ((float(x) + part.x) / float(texels.x) - .5);
    return vec3(r * cos(turn), r * sin(turn), z);
}

/// How far a rectangle is, in units of w; negative: w misses it.
float distanceTo(int k, vec3 place, vec3 w) {
    float facing = dot(rectangleNormal[k], w);
    if (abs(facing) < 1e-6) return -1.;
    float far = dot(rectangleNormal[k], corner[k] - place) / facing;
    vec3 at = place + far * w - corner[k];
    float u = dot(at, edgeU[k]) / dot(edgeU[k], edgeU[k]), v = dot(at, edgeV[k]) / dot(edgeV[k], edgeV[k]);
    return far > 0. && u >= 0. && u <= 1. && v >= 0. && v <= 1. ? far : -1.;
}
/// Radiance from w; density: per solid angle of drawing it from a rectangle that it meets.
vec3 radianceFrom(vec3 place, vec3 w, out float density) {
    float nearest = 1e30;
    int met = -1;
    for (int k = 0; k < rectangleCount; ++k) {
        float far = distanceTo(k, place, w);
        if (far > 0. && far < nearest) { nearest = far; met = k; }
    }
    density = 0.;
    if (met < 0) return fromAfar(w);
    float facing = -dot(rectangleNormal[met], w);
    if (facing <= 0.) return vec3(0.);
    density = nearest * nearest / (facing * length(cross(edgeU[met], edgeV[met])));
    return rectangleRadiance[met];
}

const float EVEN = .3;  // the part of the paint's directions that are drawn evenly
float densityOfPaint(vec3 wi, vec3 wo) {
    float sum = 0.;
    int count = int(nacreLobeCount), k = 0;
    do sum += nacreDensity(k, wi, wo); while (++k < count);
    return EVEN * wo.z / PI + (1. - EVEN) / float(count) * sum;
}
${Vx}
vec3 shaded(vec3 place, vec3 n, vec3 view, out vec3 ofFlakes) {
    vec3 t = normalize(abs(n.x) < .9 ? cross(n, vec3(1., 0., 0.)) : cross(n, vec3(0., 1., 0.)));
    mat3 toWorld = mat3(t, cross(n, t), n);
    vec3 wi = view * toWorld;
    wi = normalize(vec3(wi.xy, max(wi.z, 1e-3)));
    // Towards a place on the sun; below the horizon: there is none.
    vec3 towardsSun = vec3(0., 0., -1.);
    if (sun.w < 1.5) {
        vec2 u = evenly(6u);
        float z = 1. - u.x * (1. - sun.w), r = sqrt(max(1. - z * z, 0.)), phi = 2. * PI * u.y;
        vec3 s = normalize(abs(sun.x) < .9 ? cross(sun.xyz, vec3(1., 0., 0.)) : cross(sun.xyz, vec3(0., 1., 0.)));
        towardsSun = (r * cos(phi) * s + r * sin(phi) * cross(sun.xyz, s) + z * sun.xyz) * toWorld;
    }
    ofFlakes = shadedFlakes(place, toWorld, wi, towardsSun);
    vec3 sum = vec3(0.);
    // Directions from the paint, from afar and from each rectangle, and at last to the sun. Processors that draw in
    // place of a card compute both sides of an if, and a loop's body once more than it runs where it is asked at
    // its beginning, here and in what it calls.
    float which = evenlyOne(7u);
    vec2 u = evenly(0u);
    float r = sqrt(u.x), phi = 2. * PI * u.y;
    vec3 ofPaint = nacreDraw(clamp(int((which - EVEN) / (1. - EVEN) * nacreLobeCount), 0, int(nacreLobeCount) - 1), wi, u);
    if (which < EVEN) ofPaint = vec3(r * cos(phi), r * sin(phi), sqrt(1. - u.x));
    vec3 fromFar = drawFromAfar(evenly(1u));
    int toSun = 2 + rectangleCount, ways = towardsSun.z > 1e-4 ? toSun + 1 : toSun, way = 0;
    do {
        vec3 wo = ofPaint, w = toWorld * wo, radiance;
        float scale = 0.;
        if (way > 0) {
            u = evenly(uint(way));
            int k = min(max(way - 2, 0), ${String(Dn-1)});
            w = way == 1 ? fromFar : normalize(corner[k] + u.x * edgeU[k] + u.y * edgeV[k] - place);
            wo = w * toWorld;
        }
        if (way == toSun) {
            nacreWithoutSunlit();
            wo = towardsSun;
            radiance = sunRadiance;
            scale = 2. * PI * (1. - sun.w) * wo.z;
        } else if (wo.z > 1e-4) {
            float density;
            radiance = radianceFrom(place, w, density);
            density += densityFromAfar(w) + densityOfPaint(wi, wo);
            if (max(radiance.r, max(radiance.g, radiance.b)) > 0.) scale = wo.z / density;
        }
        if (scale > 0.) sum += nacreColour(wi, wo) * radiance * scale;
        ++way;
    } while (way < ways);
#if ${e?"1":"0"}
    vec3 mirrored = toWorld * vec3(-wi.xy, wi.z);
    float ignored;
    vec3 image = radianceFrom(place, mirrored, ignored);
    if (dot(mirrored, sun.xyz) > sun.w) image += sunRadiance;
    sum += nacreFresnel(wi.z) * image;
#endif
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    pixelBits = interleaved > 0 ? 0u : mixBits(uint(pixel.x) + mixBits(uint(pixel.y)));
    number = sampleIndex;
    if (interleaved > 0) {
        ivec2 within = pixel % interleaved;
        number += ${String(Wx)}u * uint(within.x + interleaved * within.y);
    }
    vec4 place = texelFetch(placeAt, pixel, 0);
    vec3 value, ofFlakes = vec3(0.);
    if (place.w == 0.) {
        vec2 at = (gl_FragCoord.xy + shift) / size * 2. - 1.;
        float ignored;
        value = radianceFrom(eye, normalize(ahead + at.x * across + at.y * upwards), ignored);
    } else {
        vec3 view = normalize(eye - place.xyz), n = texelFetch(facingAt, pixel, 0).xyz;
        value = shaded(place.xyz, dot(n, view) < -.1 ? -n : n, view, ofFlakes);
    }
    // What is not finite would stay for good.
    light = vec4(dot(value, value) < 1e12 ? value : vec3(0.), 1.);
    flakes = vec4(dot(ofFlakes, ofFlakes) < 1e12 ? ofFlakes : vec3(0.), flakesSampled ? 1. : 0.);
}`.replaceAll("0x1p-24_","5.9604644775390625e-8")}const sa=`
vec4 mean(vec4 sum) { return sum.a > 0. ? vec4(sum.rgb / sum.a, 1.) : vec4(0.); }
float brightness(vec3 light) { return max(dot(light, vec3(.2126, .7152, .0722)), 0.); }
vec3 lightOf(sampler2D sums, sampler2D flakes, ivec2 pixel) {
    return mean(texelFetch(sums, pixel, 0)).rgb + mean(texelFetch(flakes, pixel, 0)).rgb;
}
`,$x=`${Ki}${sa}
uniform sampler2D sums;
uniform sampler2D sumsOfFlakes;
uniform vec2 size;
out vec4 around;
void main() {
    vec2 step = vec2(textureSize(sums, 0)) / size;
    ivec2 begin = ivec2(floor((gl_FragCoord.xy - .5) * step)), end = ivec2(ceil((gl_FragCoord.xy + .5) * step));
    end = min(end, textureSize(sums, 0));
    vec4 sum = vec4(0.);
    for (int y = begin.y; y < end.y; ++y) for (int x = begin.x; x < end.x; ++x) {
        bool known = texelFetch(sums, ivec2(x, y), 0).a > 0.;
        if (known) sum += vec4(lightOf(sums, sumsOfFlakes, ivec2(x, y)), 1.);
    }
    around = min(mean(sum), 65504.); // the largest half float
}`,qx=`${Ki}${sa}
uniform sampler2D sums;
uniform sampler2D placeAt;
uniform sampler2D facingAt;
uniform vec2 along;
uniform int width;
out vec4 around;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(sums, 0) - 1;
    vec3 facing = texelFetch(facingAt, pixel, 0).xyz;
    int reach = texelFetch(placeAt, pixel, 0).w > 0. ? width : 1; // what lies behind has no noise
    vec4 sum = vec4(0.);
    for (int k = 1 - reach; k < reach; ++k) {
        ivec2 at = clamp(pixel + k * ivec2(along), ivec2(0), last);
        bool alike = k == 0 || dot(texelFetch(facingAt, at, 0).xyz, facing) > .8;
        if (alike) sum += float(reach - abs(k)) * mean(texelFetch(sums, at, 0));
    }
    around = min(mean(sum), 65504.);
}`,Yx=`${Ki}${sa}
uniform sampler2D sums;
uniform sampler2D sumsOfFlakes;
uniform sampler2D means;  // filtered between its pixels, which are larger
out float glitter;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float around = brightness(mean(texture(means, gl_FragCoord.xy / vec2(textureSize(sums, 0)))).rgb);
    float here = brightness(lightOf(sums, sumsOfFlakes, pixel));
    glitter = around > 1e-4 ? min(here / around, 65504.) : 1.;
}`;function Va(n){const[e,t]=[n!=="whole",n!=="coarse"].map(Number);return`${Ki}${sa}
#define HAS_COARSE ${String(e)}
#define HAS_WHOLE ${String(t)}
uniform sampler2D whole;
uniform sampler2D wholeFlakes;
uniform sampler2D coarseMeans;  // filtered between its pixels, which are larger
uniform sampler2D glitter;      // of the picture before; one texel where there is none
uniform vec2 size;
uniform float enough;  // samples
uniform bool warn;     // of colours outside the gamut
out vec4 seen;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 light = vec4(0.);
#if HAS_WHOLE
    light = texelFetch(whole, pixel, 0);
    float samples = light.a;
    light = mean(light);
    light.rgb += mean(texelFetch(wholeFlakes, pixel, 0)).rgb;
#endif
#if HAS_COARSE
    vec2 at = gl_FragCoord.xy / size;
    vec4 coarse = mean(texture(coarseMeans, at));
    coarse.rgb *= texture(glitter, at).r;
#if HAS_WHOLE
    if (samples < enough) light = coarse;
#else
    light = coarse;
#endif
#endif
    vec3 linear = light.rgb, clipped = clamp(linear, 0., 1.);
    vec3 encoded = mix(12.92 * clipped, 1.055 * pow(max(clipped, 1e-6), vec3(1. / 2.4)) - .055,
                       vec3(greaterThan(clipped, vec3(.0031308))));
    // Stripes where a component is negative by more than rounding.
    float lowest = min(linear.r, min(linear.g, linear.b)), scale = max(linear.r, max(linear.g, linear.b));
    bool stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.) < 4.;
    if (warn && stripe && lowest < -.002 - .01 * scale) encoded = vec3(.5);
    seen = light.a > 0. ? vec4(encoded, 1.) : vec4(0.);  // else what lies behind the canvas is seen
}`}const Hr=4,Ld=5,Kx=5,Zx=16,Ln=({textures:n})=>n[0],Wa=({textures:n})=>n[1],yu=(n,e)=>n?.width===e.width&&n.height===e.height;function Eu(n){const e=["nacreField","nacreFieldLevels","nacreFieldKey"].map(t=>n.uniforms.find(i=>i.name===t)?.values);return JSON.stringify(e.map(t=>Array.from(t??[])))}class Jx{constructor(e){this.renderer=e,this.even=gr(void 0,"r32f",[1,1],Float32Array.of(1)),this.before=null,this.glitters=!1,this.rowMeans=null,this.coarseMeans=null,this.smoothedOf=null;const t=e.getContext().getExtension("OES_texture_float_linear")!==null;this.filteredType=t?Ot:Wt;const i=s=>new Or(e,Pd,s);this.screens={coarse:i(Va("coarse")),whole:i(Va("whole")),both:i(Va("both"))},this.average=i($x),this.smooth=i(qx),this.glitter=i(Yx)}ready(){return[...Object.values(this.screens),this.average,this.smooth,this.glitter].every(t=>t.ready())}changePaint(e,t,i,s){let r=e;if(t.flakes&&e.samples>=Zx){r=this.before?.sums??s();const{means:a=null,glitter:o=null}=this.before??{};this.before={sums:e,flakes:Eu(t),means:a,glitter:o,known:!1}}return this.glitters=i.flakes&&this.before?.flakes===Eu(i),r}forget(){this.glitters=!1,this.before?.sums.delete(),this.before?.means?.dispose(),this.before?.glitter?.dispose(),this.before=null}draw(e,t,i,s){let r="whole";t!==null&&e.samples<Hr&&(r=e.begun?"both":"coarse");let a=this.even;t!==null&&r!=="whole"&&(this.smoothed(t),this.glitters&&this.before!==null&&i!==null&&(a=this.glitterOf(this.before,i)));const o=this.screens[r];o.set({whole:Ln(e.target),wholeFlakes:Wa(e.target),coarseMeans:Ln(this.coarseMeans??e.target),glitter:a,size:this.renderer.getDrawingBufferSize(new Xe).toArray(),enough:Hr,warn:s?1:0}),o.draw(null)}glitterOf(e,t){const{sums:i}=e;if(e.known&&e.glitter!==null&&yu(e.means,t.target))return Ln(e.glitter);e.means=this.meansOf(i,t,e.means);const{width:s,height:r}=i.target;return e.glitter??=kr(this.renderer,s,r,Wt,{red:!0}),this.glitter.set({sums:Ln(i.target),sumsOfFlakes:Wa(i.target),means:Ln(e.means)}),this.glitter.draw(e.glitter),e.known=!0,Ln(e.glitter)}smoothed(e){const{target:t,shape:i,samples:s,changes:r}=e;this.smoothedOf?.sums===e&&this.smoothedOf.changes===r||(this.smoothedOf={sums:e,changes:r},this.rowMeans=this.meansLike(t,this.rowMeans),this.coarseMeans=this.meansLike(t,this.coarseMeans),this.smooth.set({placeAt:i.textures[0],facingAt:i.textures[1],width:s<=Kx?Ld:2}),this.smooth.set({sums:Ln(t),along:[1,0]}),this.smooth.draw(this.rowMeans),this.smooth.set({sums:Ln(this.rowMeans),along:[0,1]}),this.smooth.draw(this.coarseMeans))}meansOf({target:e},t,i){const s=this.meansLike(t.target,i);return this.average.set({sums:Ln(e),sumsOfFlakes:Wa(e),size:[s.width,s.height]}),this.average.draw(s),s}meansLike(e,t){if(t!==null&&yu(t,e))return t;t?.dispose();const{width:i,height:s}=e;return kr(this.renderer,i,s,this.filteredType,{linear:!0})}}const Qx={frame_ms:12,moving_ms:6,strip_ms:12},jx={frame_ms:30,moving_ms:12,strip_ms:12},eS=15,bu=4096,tS=200,wu=2,nS=4;function iS(n,e){const t=n.fenceSync(n.SYNC_GPU_COMMANDS_COMPLETE,0);if(n.flush(),t===null)return!1;const i=()=>{if(n.clientWaitSync(t,0,0)===n.TIMEOUT_EXPIRED){setTimeout(i,wu);return}n.deleteSync(t),e()};return setTimeout(i,wu),!0}class sS{constructor(){this.frame_ms=0,this.speed=2e3,this.overhead_ms=16}get budgets(){const e=this.overhead_ms<eS?Qx:jx;return{budget:Math.max(e.frame_ms*this.speed,bu),moving:e.moving_ms*this.speed,strip:Math.max(e.strip_ms*this.speed,bu)}}drawn(e,t,i){this.frame_ms=e,i&&(this.overhead_ms=Math.min(this.overhead_ms,e));const s=Math.max(e-(i?this.overhead_ms:nS),1),r=Math.min(t/s,1.5*this.speed);this.speed=.5*(this.speed+r)}}const rS=100;class aS{constructor(e,t){this.gl=e,this.drawing=t,this.pace=new sS,this.underWay=!1,this.request=0,this.restsUntil=0,this.isNew=!1,this.shownAt=0,this.stopped=!1,this.held=!1,this.lost=!1}get frame_ms(){return this.pace.frame_ms}renew(){this.isNew=!0,this.schedule()}schedule(){this.request!==0||this.stopped||this.lost||(this.request=requestAnimationFrame(()=>{this.request=0,this.attempt()}))}now(){this.stopped||this.lost||(this.attempt(),this.schedule())}rest(){this.restsUntil=performance.now()+tS}pause(){this.stopped=!0,cancelAnimationFrame(this.request),clearTimeout(this.timer),this.request=0}resume(){this.stopped&&(this.stopped=!1,this.renew())}hold(e){e!==this.held&&(this.held=e,e||this.schedule())}end(){this.lost=!0,this.pause()}attempt(){try{this.frame()}catch(e){this.drawing.failed(e)}}scheduleAt(e){clearTimeout(this.timer),this.timer=setTimeout(()=>{this.schedule()},e-performance.now())}frame(){if(this.underWay)return;this.drawing.takeNew()&&(this.isNew=!0);const e=performance.now();if(!this.isNew&&(this.held||e<this.restsUntil)){this.drawing.awaits?this.schedule():this.held||this.scheduleAt(this.restsUntil);return}const t=this.drawing.draw(this.pace.budgets,this.isNew),i=this.isNew||t!==null&&this.shows(t,e);i&&(this.isNew=!1,this.shownAt=e,this.drawing.show()),t!==null?this.waitUntilDrawn(e,t.work,i):this.drawing.awaits&&this.schedule()}shows({seen:e},t){return e==="now"||e==="soon"&&t-this.shownAt>=rS}waitUntilDrawn(e,t,i){this.underWay=iS(this.gl,()=>{this.underWay=!1,this.pace.drawn(performance.now()-e,t,i),i||this.stopped||this.lost?this.schedule():this.attempt()})}}function oS(n,e,t){const{sun:i,rectangles:s,azimuth_deg:r}=n,a=Math.PI/180,o=i?ss(i.direction,e):[0,0,1],l=i?Math.cos(i.angular_radius_deg*a):2,c=u=>{const f=new Float32Array(3*Dn);return f.set(s.flatMap(u)),f};return{azimuth:(r+e)*a,sun:[...o,l],sunRadiance:i?.rgb??[0,0,0],rectangleCount:s.length,corner:c(u=>kx(u.corner,e,t)),edgeU:c(u=>ss(u.edge_u,e)),edgeV:c(u=>ss(u.edge_v,e)),rectangleNormal:c(u=>ss(u.normal,e)),rectangleRadiance:c(u=>u.rgb)}}function lS(n,e,t){const[i,s,r]=[Math.abs(n),Math.abs(e),Math.abs(t)];return i>=s&&i>=r?n<0?1:0:s>=r?e<0?3:2:t<0?5:4}function cS(n,e){const{positions:t,normals:i,indices:s}=n,r=t.length/3,a=[1/0,1/0,1/0],o=[-1/0,-1/0,-1/0];t.forEach((T,S)=>{const E=S%3;a[E]=Math.min(a[E],T),o[E]=Math.max(o[E],T)});const l=a.map((T,S)=>Math.floor((o[S]-T)/e)+1),[c=1,u=1,f=1]=l;if(6*c*u*f>Number.MAX_SAFE_INTEGER)return n;const h=new Uint32Array(r),g=new Map,_=[],y=[];for(let T=0;T<r;++T){const S=C=>t[3*T+C],E=C=>i[3*T+C],A=C=>Math.floor((S(C)-a[C])/e),w=lS(E(0),E(1),E(2))+6*(A(0)+c*(A(1)+u*A(2)));let N=g.get(w);N===void 0&&(N=_.length,g.set(w,N),_.push(0),y.push(0,0,0,0,0,0)),h[T]=N,_[N]=_[N]+1;for(let C=0;C<3;++C){const L=6*N+C;y[L]=y[L]+S(C),y[L+3]=y[L+3]+E(C)}}const d=[];for(let T=0;T<s.length;T+=3){const S=w=>h[s[T+w]],[E,A,p]=[S(0),S(1),S(2)];E!==A&&A!==p&&p!==E&&d.push(E,A,p)}if(2*d.length>s.length)return n;const m=new Float32Array(3*_.length),x=new Float32Array(3*_.length);return _.forEach((T,S)=>{for(let E=0;E<3;++E)m[3*S+E]=y[6*S+E]/T,x[3*S+E]=y[6*S+3+E]}),{positions:m,normals:x,indices:Uint32Array.from(d)}}const Tu=2,Au=1;class uS{constructor(e){this.renderer=e,this.mesh=null,this.cell=0,this.whole=new Or(e,Su,Mu,{depth:!0}),this.coarse=new Or(e,Su,Mu,{depth:!0})}ready(){return this.whole.ready()&&this.coarse.ready()}setMesh(e){this.whole.setMesh(e),this.mesh=e,this.cell=0}draw(e,t,i,s,r,a,o){if(e.shapeFrom?.[0]===a[0]&&e.shapeFrom[1]===a[1])return;e.shapeFrom=a;const{shape:l}=e,c=[-2*a[0]/l.width,-2*a[1]/l.height];o&&this.fit(l.height,t,s);const u=o?this.coarse:this.whole;u.set({toWorld:Cd(t,i,s.target_mm),toScreen:zx(r,s.distance_mm,c)}),Br(this.renderer,l),u.draw(l)}fit(e,{scale:t},{distance_mm:i,fov_deg:s}){const a=2*i*Math.tan(s*Math.PI/360)/e/t;this.mesh!==null&&(this.cell<=Tu*a&&this.cell>=Au*a||(this.cell=Math.sqrt(Tu*Au)*a,this.coarse.setMesh(cS(this.mesh,this.cell))))}}class hS{constructor(e,t,i,s){this.renderer=e,this.type=s,this.shapeFrom=null,this.samples=0,this.rows=0,this.changes=0,this.first=0,this.target=kr(e,t,i,s,{count:2}),this.shape=kr(e,t,i,Ot,{count:2,depth:!0})}get begun(){return this.samples>0||this.rows>0}get left(){return(this.target.height-this.rows)*this.target.width}get place(){return this.first+this.samples}restart(){this.samples=this.rows=this.first=0,this.shapeFrom=null}restartWhereSeen(){this.rows===0&&this.samples>0&&--this.samples,this.first=this.place,this.samples=this.rows=0}added(e){++this.changes,this.rows+=e,!(this.rows<this.target.height)&&(this.rows=0,++this.samples)}means(){const{width:e,height:t}=this.target,i=new Float32Array(4*e*t);for(let s=0;s<this.target.textures.length;++s){const r=this.read(s);for(let a=0;a<i.length;a+=4){const o=1/Math.max(r[a+3],1);for(let l=a;l<a+3;++l)i[l]=i[l]+o*r[l];i[a+3]=1}}return{width:e,height:t,data:i}}delete(){this.target.dispose(),this.shape.dispose()}read(e){const{target:t,type:i}=this,{width:s,height:r}=t,a=4*s*r,o=c=>{this.renderer.readRenderTargetPixels(t,0,0,s,r,c,0,e)};if(i===Ot){const c=new Float32Array(a);return o(c),c}const l=new Uint16Array(a);return o(l),Float32Array.from(l,c=>Sm.fromHalfFloat(c))}}const dS=65504;function fS(n){const{width:e,height:t,rgb:i}=n,s=new Float32Array(4*e*t),r=new Float32Array(e*t);for(let u=0;u<e*t;++u){const[f,h,g]=[0,1,2].map(_=>Math.min(i[3*u+_],dS));s.set([f,h,g,1],4*u),r[u]=Math.max(.2126*f+.7152*h+.0722*g,0)}const a=new Float32Array(e*t),o=new Float32Array(t),l=new Float64Array(e);let c=0;for(let u=0;u<t;++u){let f=0;for(let h=0;h<e;++h){let g=1e-9;for(let _=Math.max(u-1,0);_<=Math.min(u+1,t-1);++_)for(const y of[h-1+e,h,h+1])g+=r[_*e+y%e];l[h]=f+=g}for(let h=0;h<e;++h)a[u*e+h]=l[h]/f;c+=f*(Math.cos(Math.PI*u/t)-Math.cos(Math.PI*(u+1)/t)),o[u]=c}for(let u=0;u<t;++u)o[u]=o[u]/c;return{width:e,height:t,picture:s,byColumn:a,byRow:o}}const Ru=24,pS=3,mS=10,Cu=6,gS=1024;class _S{constructor(e,t={}){this.canvas=e,this.options=t,this.paints=new Map,this.paintTextures=new Map,this.lightTextures={},this.transform=null,this.light=null,this.camera=null,this.turn_deg=0,this.lightTurn_deg=0,this.paint=null,this.nextPaint=null,this.warn=!1,this.sparkle=!0,this.whole=null,this.coarse=null,this.fine=null,this.coarseness=3,this.filmsWanted=!1,this.onLost=r=>{r.preventDefault(),this.loop.end(),this.canvas.removeEventListener("webglcontextlost",this.onLost),this.renderer.dispose(),this.options.onFault?.("the graphics processor was lost")},this.renderer=Nx(e);const i=this.renderer.getContext();this.loop=new aS(i,this);const s=i.getExtension("EXT_float_blend")!==null;this.sumType=s?Ot:Wt,this.mostSamples=Math.min(t.samples??gS,s?1e6:128),this.shape=new uS(this.renderer),this.shown=new Jx(this.renderer),this.paintTextures.set("nacreFilms",gr(void 0,"rgba16f",[1,1],new Uint16Array(4))),e.addEventListener("webglcontextlost",this.onLost)}setShape(e,t){this.shape.setMesh(e),this.transform=t,this.restart()}setLight(e){if(e.rectangles.length>Dn)throw new Error(`a light of ${String(e.rectangles.length)} rectangles: must be at most ${String(Dn)}`);const{width:t,height:i,picture:s,byColumn:r,byRow:a}=fS(e),o=(c,...u)=>{this.lightTextures[c]=gr(this.lightTextures[c],...u)};o("surroundings","rgba16f",[t,i],s,{linear:!0,repeat:!0}),o("byColumn","r32f",[t,i],r),o("byRow","r32f",[i,1],a),this.light=e,this.restart()}setPaint(e){if(!this.paints.has(e.program)){const t=Xx(e.glsl,e.smoothCoat);this.paints.set(e.program,new Or(this.renderer,Pd,t,{adds:!0}))}this.nextPaint=e,this.loop.now()}setFilms(e){this.paint===null||this.paint.films||(this.paint=pp(this.paint,e),this.handOver(this.paint,e),this.loop.schedule())}setCamera(e){const t=JSON.stringify(e)===JSON.stringify(this.camera);this.camera=e,t||this.restart()}turn(e,t){const i=e==="shape"?this.turn_deg:this.lightTurn_deg;t!==i&&(e==="shape"?this.turn_deg=t:this.lightTurn_deg=t,this.restart())}setGamutWarning(e){this.warn=e,this.loop.renew()}setSparkle(e){e!==this.sparkle&&(this.sparkle=e,this.restart())}resize(e,t){if(!(this.canvas.width===e&&this.canvas.height===t&&this.whole)){this.renderer.setSize(Math.max(1,e),Math.max(1,t),!1),this.whole?.delete(),this.whole=this.make(1);for(const i of[this.coarse,this.fine])i?.delete();this.coarse=this.fine=null,this.restart()}}get state(){return{samples:this.whole?.samples??0,fine:this.isFine,compiling:this.nextPaint!==null,frame_ms:this.loop.frame_ms,coarseness:this.coarseness}}pixels(){if(!this.whole)throw new Error("the picture has no size yet");return this.whole.means()}pause(){this.loop.pause()}resume(){this.loop.resume()}hold(e){this.loop.hold(e)}dispose(){this.loop.end(),this.canvas.removeEventListener("webglcontextlost",this.onLost),this.renderer.dispose(),this.renderer.forceContextLoss()}restart(){this.shown.forget();for(const e of[this.whole,this.coarse,this.fine])e?.restart();this.loop.renew()}get awaits(){return this.nextPaint!==null}failed(e){this.nextPaint=null,this.options.onFault?.(e instanceof Error?e.message:String(e))}takeNew(){const e=this.nextPaint,t=e===null?void 0:this.paints.get(e.program);if(e===null||t?.ready()!==!0)return!1;this.nextPaint=null,this.whole&&this.sparkle&&this.paint!==null&&(this.whole=this.shown.changePaint(this.whole,this.paint,e,()=>this.make(1))),this.paint=e,this.filmsWanted=!1,this.handOver(e,e),this.whole&&(this.whole.samples=this.whole.rows=0);for(const i of[this.coarse,this.fine])i?.restartWhereSeen();return!0}handOver({program:e},t){const i=this.paints.get(e);i.set(hp(t));for(const{name:s,size:r,data:a}of t.textures){const o={linear:r.length===3},l=gr(this.paintTextures.get(s),"rgba16f",r,a,o);this.paintTextures.set(s,l)}i.set(Object.fromEntries(this.paintTextures))}draw({budget:e,moving:t,strip:i},s){const{whole:r}=this;if(!r||!this.transform||!this.light||!this.camera||!this.paint||!this.shape.ready()||!this.shown.ready())return null;const a=r.target.width*r.target.height,{sampled:o}=vu(0,this.showsFlakesIn(r)),l=o?Hr*Cu*a:a,c=o&&!this.paint.films;if(c&&!s&&!this.filmsWanted&&this.nextPaint===null&&(this.filmsWanted=!0,this.options.onFilmsWanted?.()),l<=e&&!c){const f=r.samples===0?Math.max(t,l):e;return this.add(r,Math.min(f,8*l))}if(!r.begun&&this.fine?.begun!==!0){Br(this.renderer,r.target);const f=Math.ceil(Math.sqrt(a/t)),h=this.coarseOf(Math.min(Math.max(f,pS),mS));if(h.samples===0){a>e&&this.loop.rest();const g=h.target.width*h.target.height;return this.add(h,Math.max(g,Math.min(t,Ru*g)))}}const{coarse:u}=this;return u&&u.samples>0&&u.samples<Math.min(Ru,this.mostSamples)&&r.samples===0?this.add(u,i):o&&!r.begun&&!this.isFine?(this.fine??=this.make(1),this.add(this.fine,Math.min(i,this.fine.left))):c?null:this.add(r,i)}get isFine(){return this.fine!==null&&this.fine.samples>0}get mean(){const e=this.isFine?this.fine:this.coarse;return e!==null&&e.samples>0?e:null}showsFlakesIn(e){return this.sparkle&&e===this.whole&&this.paint?.flakes===!0}coarseOf(e){return(this.coarse===null||e>this.coarseness||e<.7*this.coarseness)&&(this.coarseness=e,this.coarse?.delete(),this.coarse=this.make(e)),this.coarse}make(e){const t=Math.max(1,Math.ceil(this.canvas.width/e)),i=Math.max(1,Math.ceil(this.canvas.height/e));return new hS(this.renderer,t,i,this.sumType)}add(e,t){const{width:i,height:s}=e.target;e.samples===0&&e.rows===0&&Br(this.renderer,e.target);let r=0;for(;r<.75*t&&e.samples<this.mostSamples;){const a=this.showsFlakesIn(e),{sampled:o,stratum:l}=vu(a?e.samples:e.place,a),c=o?Cu*i:i,u=Math.max(1,Math.min(s-e.rows,Math.round((t-r)/c))),f=Bx(this.camera,this.canvas.width/this.canvas.height);e.rows===0&&this.drawShape(e,f,l.place),this.shade(e,f,l,u,a,o),r+=u*c,e.added(u)}return r>0?{work:r,seen:this.isSeen(e)}:null}isSeen(e){if(e===this.coarse||e.rows===0)return"now";const t=this.mean===null||e.samples+1>=Hr;return e===this.whole&&t?"soon":"not"}drawShape(e,t,i){const[s,r]=[this.transform,this.camera],a=e===this.coarse;this.shape.draw(e,s,this.turn_deg,r,t,i,a)}shade(e,t,i,s,r,a){const{target:o,shape:l,samples:c,rows:u}=e,f=this.paint,h=this.camera,g=Hx(this.transform,this.turn_deg,h.target_mm),_=this.paints.get(f.program);_.set({...this.lightTextures,...oS(this.light,this.lightTurn_deg,h.target_mm),placeAt:l.textures[0],facingAt:l.textures[1],eye:t.place,ahead:t.ahead,across:t.across,upwards:t.upwards,size:[o.width,o.height],shift:i.place,...Gx(g,i,r,a),sampleIndex:c,interleaved:e===this.whole?0:Ld}),_.draw(o,[u,s])}show(){this.whole&&this.shown.ready()&&this.shown.draw(this.whole,this.mean,this.coarse,this.warn),this.options.onChange?.(this.state)}}const vS=512;class xS{constructor(){this.texts=new Map,this.meshes=new Map,this.lights=new Map}add(e,t){e.mesh!==void 0&&this.meshes.set(t,Promise.resolve(e.mesh)),e.light!==void 0&&this.lights.set(t,Promise.resolve(e.light))}}class SS{constructor(e,t,i,s,r,a,o){this.canvas=e,this.schema=t,this.bytes=i,this.received=s,this.onFault=o,this.shape="",this.light="",this.view=new _S(e,{onChange:({samples:l})=>{r(l)},onFilmsWanted:a,onFault:o})}setSchema(e){this.schema=e}show(e,t,i){const s=this.schema.shapes.find(({name:a})=>a===e.shape);if(s===void 0||t*i===0)return;if(this.shape!==e.shape){this.shape=e.shape;const a=Pu(this.received.meshes,e.shape,()=>this.bytes(`/api/shape/${encodeURIComponent(e.shape)}`).then(Fh));this.when(a,o=>{this.shape===e.shape&&this.view.setShape(o,s.transform)})}if(this.light!==e.light){this.light=e.light;const a=Pu(this.received.lights,e.light,()=>this.bytes(`/api/light/${encodeURIComponent(e.light)}?width=${String(vS)}`).then(Oh));this.when(a,o=>{this.light===e.light&&this.view.setLight(o)})}this.view.resize(t,i);const r=Nh(e.camera,t,i);this.view.setCamera({...r,target_mm:s.camera.target_mm}),this.view.turn("shape",e.turn_deg),this.view.turn("light",e.light_turn_deg),this.view.setSparkle(e.sparkle)}setPaint(e,t){return e.problem!==void 0?!1:(this.view.setPaint(dp(e,t,this.received.texts)),!0)}setFilms(e,t){this.view.setFilms(fp(e,t))}pause(e){e?this.view.pause():this.view.resume()}hold(e){this.view.hold(e)}setGamutWarning(e){this.view.setGamutWarning(e)}snapshot(){const{width:e,height:t}=this.canvas,i=document.createElement("canvas");i.width=e,i.height=t;const s=i.getContext("2d");if(s===null)return null;s.drawImage(this.canvas,0,0);const r=s.getImageData(0,0,e,t).data;return{width:e,height:t,pixels:r,samples:0,of:0}}when(e,t){e.then(t).catch(i=>{this.onFault(i instanceof Error?i.message:String(i))})}}function Pu(n,e,t){const i=n.get(e)??t();return n.set(e,i),i.catch(()=>n.delete(e)),i}function ra({picture:n,recipe:e,view:t}){return n!==null&&n.recipe===e&&n.view===t}function Gr(n){const{picture:e,liveSamples:t}=n;return e===null||t===null?e!==null:!n.gamutWarning&&ra(n)&&e.samples>=n.enough}function Al({kept:n,keptRecipe:e,view:t}){return e!==null&&(n?.view!==t||n.recipe!==e)}function Lu(n){const e=n.kept?.samples??0;return n.keptRecipe!==null&&(Al(n)||e<Dd)}function MS({kept:n}){if(n===null||n.of===0)return"live";if(n.of===1)return"draft";const{samples:e,of:t}=n;return e<t?`${String(e)} of ${String(t)}`:String(e)}function yS(n,e){return n?.recipe===e.recipe&&n.view===e.view&&n.place===e.place&&n.samples>e.samples}const ES=300,Xa=64,Dd=16,bS=3,wS=7e5,Du=16;class TS{constructor(e){this.session=e,this.store=new al({view:null,picture:null,keptRecipe:null,kept:null,fault:null,recipe:null,liveSamples:null,noLive:null,gamutWarning:!1,enough:Du}),this.live=null,this.liveRecipe=null,this.received=new xS,this.size={width:0,height:0},this.meanModel="",this.withLines=new Set,this.underWay=null,this.quickWanted=!1,this.holders=new Set,this.postponed=!1}hold(e,t){if(t?this.holders.add(e):this.holders.delete(e),this.live?.hold(this.holders.has("colours")),t){const i=this.underWay?.job;i!==void 0&&(!i.quick||i.kept)&&(this.postponed=this.stop())}else this.holders.size===0&&this.postponed&&this.startLater()}add(e,t,i){this.received.add(t,i),this.live?.setSchema(e)}resize(e,t){e===this.size.width&&t===this.size.height||(this.size={width:e,height:t},this.store.get().liveSamples!==null&&this.store.set({picture:null}),this.refresh())}begin(e){this.meanModel=e.mean_model;for(const{name:i,illuminant:s}of e.lights)s.startsWith("FL")&&this.withLines.add(i);if(this.store.get().view!==null)return;const t=e.shapes.find(({name:i})=>i==="ball")??e.shapes[0];t!==void 0&&this.setShape(e,t.name,!0)}setShape(e,t,i){const s=e.shapes.find(a=>a.name===t);if(s===void 0)return;const{view:r}=this.store.get();this.store.set({view:{shape:t,light:r===null||i?s.light:r.light,camera:Dh(s),turn_deg:0,light_turn_deg:r?.light_turn_deg??0,sparkle:r?.sparkle??!0}}),this.refresh()}setView(e){const{view:t}=this.store.get();t!==null&&(this.store.set({view:{...t,...e}}),this.refresh())}paint(e){e!==this.store.get().recipe&&(this.store.set({recipe:e}),this.refresh())}attach(e,t,i){const s=r=>{this.live=null,this.store.set({liveSamples:null,noLive:r})};try{const r=l=>{this.store.get().liveSamples!==null&&(this.store.set({liveSamples:l}),this.pauseWhenCovered())},a=this.askForFilms.bind(this);this.live=new SS(e,t,i,this.received,r,a,s),this.live.hold(this.holders.has("colours")),this.live.setGamutWarning(this.store.get().gamutWarning),this.store.set({noLive:null});const{view:o}=this.store.get();o!==null&&this.live.show(o,this.size.width,this.size.height)}catch(r){s(r instanceof Error?r.message:String(r))}}get wantsShader(){return this.live!==null}shader(e,t,i){this.liveRecipe=e,this.live?.pause(!1);const s=this.live?.setPaint(t,i)===!0;this.store.set({liveSamples:s?0:null})}askForFilms(){const e=this.liveRecipe;if(!this.session.isOpen)return;const t=this.session.send("films",{recipe:e},(i,s)=>{this.session.forget(t),e===this.liveRecipe&&this.live?.setFilms(i,s)})}setGamutWarning(e){this.store.set({gamutWarning:e}),this.live?.setGamutWarning(e),e?this.live?.pause(!1):this.pauseWhenCovered()}keep(e){this.store.set({keptRecipe:e,kept:e===null?null:this.shown(e)}),this.refresh()}pauseWhenCovered(){const e=this.store.get();Gr(e)&&this.live?.pause((e.liveSamples??0)>0)}shown(e){const t=this.store.get(),i=Gr(t)||t.view===null?null:this.live?.snapshot();return i==null||t.view===null?t.picture:{...i,recipe:e,view:t.view,place:this.size}}abandon(){this.postponed||=this.underWay!==null,this.underWay=null,this.quickWanted=!1,clearTimeout(this.timer)}refresh(){clearTimeout(this.timer);const e=this.store.get().view?.light??"";if(this.store.set({enough:this.withLines.has(e)?Xa:Du}),this.underWay?.job.quick===!0&&!this.underWay.job.kept){this.quickWanted=!0;return}this.stop(),this.quickWanted=this.postponed=!1;const{view:t,liveSamples:i,recipe:s}=this.store.get();s===this.liveRecipe&&this.live?.pause(!1),t!==null&&this.live?.show(t,this.size.width,this.size.height),i===null?this.start(!0,!1):this.startLater()}stop(){return this.underWay===null?!1:(this.session.tell("stop",{what:"render"}),this.session.forget(this.underWay.id),this.underWay=null,!0)}startLater(){clearTimeout(this.timer),this.timer=setTimeout(()=>{this.proceed()},ES)}start(e,t){const{view:i,keptRecipe:s,recipe:r}=this.store.get(),a=t?s:r,{width:o,height:l}=this.size;if(a===null||i===null||o*l===0||!this.session.isOpen||(this.postponed=this.holders.size>0&&(!e||t),this.postponed))return;const c=Math.min(1,Math.sqrt(wS/(o*l)))/(e?bS:1),u={recipe:a,view:i,place:this.size,kept:t,quick:e},{sparkle:f,...h}=i,g={recipe:a,...f?{}:{model:this.meanModel},scene:{...h,camera:Nh(i.camera,o,l)},width:Math.max(16,Math.round(o*c)),height:Math.max(16,Math.round(l*c)),samples:e?1:t?Dd:Xa},_=this.session.send("render",g,(y,d)=>{this.answered(_,u,y,d)});this.underWay={id:_,job:u}}answered(e,t,i,s){if(i.type==="picture"){const r=AS(t,i,s);if(this.take(t,r),r.samples<r.of){!t.kept&&this.isTimeForA&&(this.stop(),this.proceed());return}}else if(i.type==="error")this.store.set({fault:String(i.message)});else if(i.type!=="done")return;this.underWay?.id===e&&(this.session.forget(e),this.underWay=null,this.quickWanted?this.refresh():t.quick&&!t.kept?this.startLater():i.type!=="error"?this.proceed():!t.kept&&Lu(this.store.get())&&this.start(!1,!0))}take(e,t){const{kept:i,picture:s}=this.store.get();yS(e.kept?i:s,t)||this.store.set(e.kept?{kept:t}:{picture:t}),e.kept||this.store.set({fault:null}),this.pauseWhenCovered()}proceed(){Al(this.store.get())?this.start(!0,!0):this.isTimeForA?this.start(!1,!0):this.tracedSamples<Xa&&this.start(!1,!1)}get tracedSamples(){const e=this.store.get(),{picture:t}=e;return ra(e)&&t?.place===this.size?t.samples:0}get isTimeForA(){const e=this.store.get();return this.tracedSamples>=e.enough&&Lu(e)}}function AS(n,e,t){const i=t.find(({name:l})=>l==="rgb"),[s,r]=i?.shape??[];if(i===void 0||s===void 0||r===void 0)throw new Error("a picture came without its pixels");const a=i.data,o=new Uint8ClampedArray(r*s*4);for(let l=0,c=0;l<o.length;l+=4,c+=3)o[l]=a[c],o[l+1]=a[c+1],o[l+2]=a[c+2],o[l+3]=255;return{width:r,height:s,pixels:o,samples:Number(e.samples),of:Number(e.of),recipe:n.recipe,view:n.view,place:n.place}}function RS(){return b("section",{class:"picture-panel","aria-label":"Picture",children:[b(CS,{}),b(PS,{}),b(LS,{})]})}function CS(){const n=lt(),e=ve(r=>r.schema),t=Ct(r=>r.view),i=Ct(r=>r.keptRecipe),s=ve(r=>r.ownShape);return b("div",{class:"picture-bar",children:[b(Nu,{label:"Shape",chosen:t?.shape??"",entries:e?.shapes??[],own:{text:"Own mesh …",files:dl},choose:r=>{e!==null&&n.viewer.setShape(e,r,!1)},bring:r=>void n.ownFiles.bring("shape",r)}),s!==null&&s.name===t?.shape&&!/\.gl(tf|b)$/i.test(s.file.name)&&b("button",{type:"button",class:"small","aria-pressed":s.yUp,title:"The file's vertical is y, not z",onClick:()=>void n.ownFiles.bring("shape",s.file,!s.yUp),children:"Y up"}),b(Nu,{label:"Light",chosen:t?.light??"",entries:e?.lights??[],own:{text:"Own HDR …",files:fl},choose:r=>{n.viewer.setView({light:r})},bring:r=>void n.ownFiles.bring("light",r)}),b("button",{type:"button",title:"Turn back to where the shape began",onClick:()=>{const r=e?.shapes.find(({name:a})=>a===t?.shape);r!==void 0&&n.viewer.setView({camera:Dh(r),turn_deg:0,light_turn_deg:0})},children:"Front"}),b("span",{class:"gap"}),b("button",{type:"button","aria-pressed":i!==null,title:i===null?"Keep the paint as it is now as A, and see changes beside it":"Stop comparing",onClick:()=>{const{recipe:r}=n.store.get().document;n.viewer.keep(i===null?r:null)},children:i===null?"Keep as A":"A | B"}),i!==null&&b("button",{type:"button",title:"Make A the paint again; the present one can be had back by undo",onClick:()=>{n.useMatch(i)},children:"Back to A"})]})}function Nu(n){const{label:e,chosen:t,entries:i,own:s}=n,r=_t(null);return b(Bt,{children:[b("select",{"aria-label":e,title:i.find(({name:a})=>a===t)?.title,value:t,onChange:a=>{const{value:o}=a.currentTarget;a.currentTarget.value=t,o===""?r.current?.click():n.choose(o)},children:[i.map(({name:a,title:o})=>b("option",{value:a,children:o},a)),b("option",{value:"",children:s.text})]}),b("input",{ref:r,type:"file",accept:s.files,class:"hidden",tabIndex:-1,"aria-label":s.text.replace(" …",""),onChange:a=>{const[o]=a.currentTarget.files??[];a.currentTarget.value="",o!==void 0&&n.bring(o)}})]})}const Iu=.4,tr=5;function Uu(n,e){const t=n?.getContext("2d");if(n===null||t===null||t===void 0)return;if(e===null){t.clearRect(0,0,n.width,n.height);return}(n.width!==e.width||n.height!==e.height)&&(n.width=e.width,n.height=e.height);const i=e.pixels;t.putImageData(new ImageData(i,e.width,e.height),0,0)}function PS(){const n=lt(),e=_t(null),t=_t(null),i=_t(null),s=_t(null),r=ve(E=>E.schema!==null),a=Ct(Gr),o=Ct(E=>E.picture),l=Ct(E=>E.kept),c=Ct(E=>E.keptRecipe),u=Ct(Al),f=Ct(E=>E.view),h=ve(E=>E.document.recipe.name),g=ve(Ms),[_,y]=Un(.5),d=_t(null),m=_t(!1);ei(()=>{const E=e.current;if(E===null)return;const A=new ResizeObserver(()=>{n.viewer.resize(E.clientWidth,E.clientHeight)});return A.observe(E),()=>{A.disconnect()}},[n]),ei(()=>{r&&s.current!==null&&n.attach(s.current)},[n,r]),Er(()=>{Uu(t.current,o)},[o]),Er(()=>{Uu(i.current,l)},[l]);const x=(E,A,p,w=1)=>{if(f===null)return;const N=p?{light_turn_deg:pc(f.light_turn_deg+E)}:{turn_deg:pc(f.turn_deg+E),camera:op(f.camera,A,w)};n.viewer.setView(N)},T=E=>{const p={ArrowLeft:[-tr,0,1],ArrowRight:[tr,0,1],ArrowUp:[0,tr,1],ArrowDown:[0,-tr,1],"+":[0,0,1.2],"-":[0,0,.8333333333333334]}[E.key];p!==void 0&&(E.preventDefault(),x(p[0],p[1],E.shiftKey,p[2]))},S=`${typeof h=="string"?h:"The paint"}, ${f?.shape??""}, ${f?.light??""}`;return b("div",{class:g?"picture stage old-paint":"picture stage",ref:e,children:[b("div",{class:"turnable",role:"application",tabIndex:0,"aria-label":`Picture: ${S}. Arrow keys turn the shape, with Shift the light; plus and minus bring it nearer.`,onKeyDown:T,onPointerDown:E=>{E.button===0&&(E.currentTarget.setPointerCapture(E.pointerId),d.current={x:E.clientX,y:E.clientY})},onPointerMove:E=>{const A=d.current;if(A===null)return;const p=(E.clientX-A.x)*Iu,w=(E.clientY-A.y)*Iu;d.current={x:E.clientX,y:E.clientY},x(p,w,E.shiftKey)},onPointerUp:()=>{d.current=null},onPointerCancel:()=>{d.current=null},onWheel:E=>{E.preventDefault(),x(0,0,!1,Math.exp(-E.deltaY/600))},children:[b("canvas",{ref:s,class:a?"live":"live now"}),b("canvas",{ref:t,class:a?"traced now":"traced",width:"16",height:"16"}),c!==null&&b("div",{class:u?"wiped behind":"wiped",style:{clipPath:`inset(0 ${String(100-100*_)}% 0 0)`},children:b("canvas",{ref:i,width:"16",height:"16"})})]}),c!==null&&b(Bt,{children:[b("span",{class:"side a",children:u?"A, as it was seen before":"A"}),b("span",{class:"side b",children:"B"}),b("div",{class:"wipe-line",style:{left:`${String(100*_)}%`},onPointerDown:E=>{E.button===0&&(E.currentTarget.setPointerCapture(E.pointerId),m.current=!0)},onPointerMove:E=>{const A=e.current?.getBoundingClientRect();if(!m.current||A===void 0)return;const p=(E.clientX-A.left)/A.width;y(Math.min(Math.max(p,0),1))},onPointerUp:()=>{m.current=!1},onPointerCancel:()=>{m.current=!1}}),b("input",{class:"wipe",type:"range",min:"0",max:"1",step:"0.01",value:_,"aria-label":"Wipe between A, kept, and B, as it is now",onInput:E=>{y(Number(E.currentTarget.value))}})]})]})}function LS(){const n=Ct(x=>x.picture),e=Ct(x=>x.fault),t=Ct(x=>x.noLive),i=ve(x=>x.readings),s=ve(Ms),r=i===null?"":sp(i),a=Ct(x=>x.liveSamples),o=Ct(Gr),l=Ct(ra),c=Ct(x=>x.gamutWarning),u=Ct(x=>x.view?.sparkle??!0),f=Ct(x=>x.keptRecipe===null?null:MS(x)),h=lt(),g=n!==null&&n.of>1&&(l||a===null)?n:null,_=g===null?"":`${String(g.samples)} of ${String(g.of)}`,y=a!==null&&!o?`Live${g===null?"":`, path traced ${_}`}`:g!==null?`Path traced, ${_}`:n===null?"No picture yet":"Draft",d=s?`Of the paint before: ${y}`:y,m=f===null?d:`${d}; A: ${f}`;return b("div",{class:"picture-foot",children:[b("span",{class:"how-far",title:e??(t===null?`${m}. Samples a pixel of the path tracer's picture`:`No live picture: ${t}`),children:e??(t===null?m:`${m}; no live picture`)}),b("progress",{max:g?.of??1,value:g?.samples??0,"aria-label":"Samples of the picture"}),b("label",{title:"Single flakes, or their mean",children:[b("input",{type:"checkbox",checked:u,onChange:x=>{h.viewer.setView({sparkle:x.currentTarget.checked})}})," ","Sparkle"]}),a!==null&&b("label",{title:"Colours outside of sRGB, in the live picture",children:[b("input",{type:"checkbox",checked:c,onChange:x=>{h.viewer.setGamutWarning(x.currentTarget.checked)}})," ","Mark"]}),b("span",{class:s?"gamut old":"gamut",role:"status",title:r===""?"":`${r}, of ${String(i?.lab.length??0)} angles: marked by ! and ↑ at the chips`,children:r})]})}function Nd(n){const{label:e,value:t,min:i,max:s,step:r}=n,a=lt();return b("input",{type:"number",min:i,max:s,step:r,value:t,disabled:n.disabled??!1,"aria-label":e,onChange:o=>{const l=o.currentTarget.valueAsNumber,c=r!=="1"||Number.isInteger(l);if(l>=i&&l<=s&&c){n.set(l);return}o.currentTarget.value=String(t);const u=r==="1"?"a whole number":"a number";a.say(`${e}: must be ${u} from ${sn(i)} to ${sn(s)}; it is still ${sn(t)}.`)}})}function DS(n){const{tabs:e,chosen:t,onChoose:i}=n,s=_t(null),r=e.findIndex(({name:o})=>o===t),a=o=>{const l=o.key==="ArrowRight"?(r+1)%e.length:o.key==="ArrowLeft"?(r+e.length-1)%e.length:o.key==="Home"?0:o.key==="End"?e.length-1:null,c=l===null?void 0:e[l];l===null||c===void 0||(o.preventDefault(),i(c.name),s.current?.children[l]?.focus())};return b("section",{class:"tabs","aria-label":n.label,children:[b("div",{role:"tablist","aria-label":n.label,ref:s,onKeyDown:a,children:e.map(({name:o,title:l})=>b("button",{type:"button",role:"tab",id:`tab-${o}`,"aria-selected":o===t,"aria-controls":`panel-${o}`,tabIndex:o===t?0:-1,onClick:()=>{i(o)},children:l},o))}),e.filter(({name:o})=>o===t).map(({name:o,panel:l})=>b("div",{role:"tabpanel",id:`panel-${o}`,"aria-labelledby":`tab-${o}`,tabIndex:0,children:l()},o))]})}const Kn=Math.PI/180;function Id(n){return Math.hypot(n[1],n[2])}function NS(n){if(Id(n)<1e-9)return 0;const e=Math.atan2(n[2],n[1])/Kn;return e<0?(e+360)%360:e}function Fu(n,e){if(n===0&&e===0)return 0;const t=Math.atan2(e,n)/Kn;return t<0?t+360:t}function IS(n,e){const[t,i,s]=n,[r,a,o]=e,l=((Math.hypot(i,s)+Math.hypot(a,o))/2)**7,c=1+.5*(1-Math.sqrt(l/(l+25**7))),u=Math.hypot(c*i,s),f=Math.hypot(c*a,o),h=Fu(c*i,s),g=Fu(c*a,o),_=u*f===0;let y=_?0:g-h;y>180?y-=360:y<-180&&(y+=360);const d=r-t,m=f-u,x=2*Math.sqrt(u*f)*Math.sin(y*Kn/2),T=(t+r)/2,S=(u+f)/2;let E=h+g;_||(Math.abs(h-g)>180&&(E+=E<360?360:-360),E/=2);const A=1-.17*Math.cos((E-30)*Kn)+.24*Math.cos(2*E*Kn)+.32*Math.cos((3*E+6)*Kn)-.2*Math.cos((4*E-63)*Kn),p=1+.015*(T-50)**2/Math.sqrt(20+(T-50)**2),w=1+.045*S,N=1+.015*S*A,C=30*Math.exp(-(((E-275)/25)**2)),L=-2*Math.sqrt(S**7/(S**7+25**7))*Math.sin(2*C*Kn),[k,X,I]=[d/p,m/w,x/N];return Math.sqrt(k*k+X*X+I*I+L*X*I)}const US=[[3.08039909,-1.53738318,-.54301591],[-.92122336,1.8759675,.04525586],[.05287394,-.20397696,1.15110302]];function FS(n){const e=(n[0]+16)/116,[t,i,s]=[e+n[1]/500,e,e-n[2]/200].map(r=>r>6/29?r**3:3*(6/29)**2*(r-4/29));return US.map(([r,a,o])=>r*t+a*i+o*s)}const Ou=1/255;function si(n){const e=FS(n),t=Math.max(...e,1);return{css:"#"+e.map(r=>{const a=Math.min(Math.max(r/t,0),1);return a<=.0031308?12.92*a:1.055*a**(1/2.4)-.055}).map(r=>Math.round(255*r).toString(16).padStart(2,"0")).join(""),tooBright:t>1+Ou,outOfGamut:Math.min(...e)<-Ou*t}}function Yo(n,e,t){const i=(e-n)/t,s=10**Math.floor(Math.log10(i)),r=([1,2,5,10].find(o=>o*s>=i*.999)??10)*s,a=[];for(let o=Math.ceil(n/r-1e-9);o*r<=e+1e-9*r;++o)a.push(Number((o*r).toPrecision(12)));return a}function ku(n){let[e,t]=[1/0,-1/0];for(const i of n)e=Math.min(e,i),t=Math.max(t,i);return e<=t?[e,t]:[0,1]}function OS(n,e,t,i){const s=n.map((l,c)=>({height:l,i:c})).sort((l,c)=>l.height-c.height),r=new Array(n.length).fill(0);let a=-1/0;for(const{height:l,i:c}of s)a=Math.max(l,a+e,t),r[c]=a;let o=i+e;for(const{i:l}of s.reverse())o=Math.min(r[l],o-e),r[l]=o;return r}function Ko(n,e){const{width:t,height:i}=e,s=e.named??!1,r=Math.max(...n.map(S=>S.label.length)),a={left:46,right:s?14+6.6*r:12,top:10,bottom:38},o={w:t-a.left-a.right,h:i-a.top-a.bottom};let[l,c]=e.x??ku(n.flatMap(S=>[...S.x])),[u,f]=e.y??ku(n.flatMap(S=>[...S.y]));if(c<=l&&([l,c]=[l-1,l+1]),f<=u&&(f=u+1),e.square??!1){const S=Math.max((c-l)/o.w,(f-u)/o.h)*1.12,[E,A]=[(l+c)/2,(u+f)/2];[l,c]=[E-S*o.w/2,E+S*o.w/2],[u,f]=[A-S*o.h/2,A+S*o.h/2]}const h=S=>a.left+(S-l)/(c-l)*o.w,g=S=>a.top+(1-(S-u)/(f-u))*o.h,_=S=>S.toFixed(1),y=S=>String(S).replace("-","−"),d=Ht("svg",{viewBox:`0 0 ${String(t)} ${String(i)}`,class:"plot",role:"img","aria-label":e.describedAs}),[m,x]=[a.top+o.h,a.left+o.w];for(const S of Yo(l,c,o.w/70)){const E=S===0&&(e.square??!1)?"axis":"grid";d.append(Ht("path",{class:E,d:`M${_(h(S))} ${String(a.top)}V${_(m)}`}),Ht("text",{x:_(h(S)),y:_(m+15),"text-anchor":"middle"},y(S)))}for(const S of Yo(u,f,o.h/40)){const E=S===0?"axis":"grid";d.append(Ht("path",{class:E,d:`M${String(a.left)} ${_(g(S))}H${_(x)}`}),Ht("text",{x:a.left-6,y:_(g(S)+3.5),"text-anchor":"end"},y(S)))}d.append(Ht("text",{class:"label",x:_(a.left+o.w/2),y:i-4,"text-anchor":"middle"},e.xLabel),Ht("text",{class:"label",transform:`translate(11 ${_(a.top+o.h/2)}) rotate(-90)`,"text-anchor":"middle"},e.yLabel));const T=[];for(const S of n){const E=S.x.map((C,L)=>({x:h(C),y:g(S.y[L])})),A=E.map(({x:C,y:L},k)=>`${k===0?"M":"L"}${_(C)} ${_(L)}`).join(""),p=(S.pointColours??[]).map((C,L)=>{const{x:k,y:X}=E[L];return Ht("circle",{cx:_(k),cy:_(X),r:4.5,style:`fill:${C}`})}),w=Ht("g",{class:S.dashed??!1?"curve dashed":"curve"});w.dataset.label=S.label,w.append(Ht("title",{},S.label),Ht("path",{class:"casing",d:A}),Ht("path",{class:"line",d:A,style:`stroke:${S.colour}`}),...p),d.append(w);const N=E[E.length-1];N!==void 0&&T.push({...N,label:S.label})}if(s){const S=OS(T.map(E=>E.y+3.5),11.5,a.top+4,m+3);T.forEach((E,A)=>{const p=S[A];d.append(Ht("path",{class:"leader",d:`M${_(x+1)} ${_(E.y)}L${_(x+8)} ${_(p-3.5)}`}),Ht("text",{x:x+10,y:_(p),"text-anchor":"start"},E.label))})}return d}const kS=60,BS=5,zS=250;function HS(n,{low:e,high:t}){if(!(t>e))return[];const i=Oi((t-e)/kS),s=[];for(let r=Math.ceil(e/i-1e-9);r*i<=t+1e-9*i;++r){const a=Number((r*i).toPrecision(12));xf(n,a)&&s.push(a)}return s}class GS{constructor(e,t){this.session=e,this.onBusy=t,this.store=new al({atlas:null,busy:!1,fraction:0,fault:null}),this.wanted="",this.underWay=null}want(e,t,i,s){const{geometries:r,illuminant:a,observer:o,model:l}=s,c={recipe:qr(e,t,i[0]),key:Qe(t),values:i,geometries:r,illuminant:a,observer:o,model:l},u=JSON.stringify(c);if(u===this.wanted||i.length===0)return;this.stop(),this.wanted=u,this.setBusy(!0);const f=i.length-1,h=i.filter((g,_)=>_%BS===0||_===f);this.timer=setTimeout(()=>{this.ask({...c,values:h},()=>{this.ask(c,()=>{this.setBusy(!1)})})},zS)}stop(){clearTimeout(this.timer),this.store.get().busy&&(this.wanted=""),this.underWay!==null&&(this.session.tell("stop",{what:"atlas"}),this.session.forget(this.underWay),this.underWay=null),this.setBusy(!1)}setBusy(e){e!==this.store.get().busy&&(this.store.set({busy:e,fraction:0}),this.onBusy(e))}ask(e,t){if(!this.session.isOpen){this.stop();return}const i=this.session.send("atlas",e,s=>{if(s.type==="progress"){this.store.set({fraction:Number(s.fraction)});return}if(this.session.forget(i),this.underWay=null,s.type==="error"){this.store.set({fault:String(s.message)}),this.setBusy(!1);return}this.store.set({fault:null,atlas:s}),t()});this.underWay=i}}function VS(n){const e=/^([\d.]+)as(-?[\d.]+)(az-?[\d.]+)?$/.exec(n);if(e===null){const i=/^([\d.]+)to/.exec(n);return{name:n,lamp:i===null?NaN:Number(i[1]),aspecular:null}}const t=e[3]===void 0;return{name:n,lamp:Number(e[1]),aspecular:t?Number(e[2]):null}}function Ud(n){const e=new Map;n.forEach((t,i)=>{const{lamp:s,aspecular:r}=VS(t);if(r===null)return;const a=e.get(s)??[];a.push({index:i,lamp:s,aspecular:r}),e.set(s,a)});for(const t of e.values())t.sort((i,s)=>i.aspecular-s.aspecular);return e}const Fd="Off the plane";function Rl(n){const e=[...Ud(n)].map(([s,r])=>({title:`Lamp at ${String(s)}°`,places:r.map(({index:a,aspecular:o})=>({i:a,label:`${tt(o,1).replace(/\.0$/,"")}°`}))})),t=new Set(e.flatMap(({places:s})=>s.map(({i:r})=>r))),i=n.map((s,r)=>({i:r,label:vs(s)})).filter(({i:s})=>!t.has(s));return i.length>0&&e.push({title:Fd,places:i}),e}function aa(n,e){const{standard:t,geometries:i}=n,s=t?.geometries.indexOf(i[e])??-1;return t?.lab[s]??null}function Od({text:n}){const e=n.replace(/az/," az").replace(/,/,", ").split(" ");return b(Bt,{children:e.map((t,i)=>b(Bt,{children:[i>0&&b("wbr",{}),t]},t))})}function WS(){const n=ve(s=>s.readings),e=ve(Ms),t=ve(kh);if(n===null)return b("div",{class:"stage chips","aria-busy":"true"});const i=Rl(n.geometries);return b("div",{class:e?"stage chips old":"stage chips",role:"group","aria-label":"Chips","data-current":t,children:[n.standard?.problem!==void 0&&b("p",{class:"problem",children:n.standard.problem}),i.map(s=>b("section",{"aria-label":s.title,children:[i.length>1&&b("h3",{children:s.title}),b("ol",{class:s.title===Fd?"chip-row named":"chip-row",children:s.places.map(({i:r,label:a})=>b(XS,{readings:n,i:r,label:a},r))})]},s.title))]})}function XS({readings:n,i:e,label:t}){const i=n.lab[e],s=aa(n,e),r=n.standard,a=r?.delta_e_2000?.[e],o=r?.passes?.[e],l=ip(n,e),c=`L* ${tt(i[0],2)}, a* ${tt(i[1],2)}, b* ${tt(i[2],2)}`;return b("li",{class:"chip","data-geometry":n.geometries[e],"data-lab":i.join(" "),title:[vs(n.geometries[e]),c,...l.map(({means:u})=>u)].join(`
`),children:[b("div",{class:"faces",children:[s!==null&&b("i",{style:{background:si(s).css}}),b("i",{style:{background:si(i).css}}),b("span",{class:"marks",children:l.map(({mark:u,means:f})=>b("abbr",{title:f,"aria-label":f,children:u},u))})]}),b("b",{children:b(Od,{text:t})}),b("span",{class:"lightness",children:[b("span",{class:"hidden",children:"L* "}),tt(i[0],1)]}),r!==null&&b("span",{class:o===!1?"delta fails":"delta",children:[b("span",{class:"hidden",children:"Delta E "}),tt(a,2),o===!1&&b("abbr",{title:"beyond the tolerance",children:" ✗"}),o===!0&&b("abbr",{title:"within the tolerance",children:" ✓"})]})]})}function Bu({path:n}){return n[n.length-1]==="thickness_nm"}function $S(){const n=lt(),e=ve(p=>p.schema),t=ve(p=>p.document),i=ve(p=>p.fault===null),s=ve(p=>p.settings),r=ve(p=>p.connection==="open"),a=ar(p=>p.fault),o=ve(p=>p.atlasSetup),{key:l,ends:c}=o,{recipe:u}=t,f=ti(()=>e===null?[]:yh(e,u),[e,u]),h=f.filter(Bu),g=p=>f.find(({path:w})=>Qe(w)===p),_=h.find(({path:p})=>p.includes("coats"))??h[0],y=g(l)??_??f[0],d=y===void 0?"":Qe(y.path),m=qS(y,c.get(d)),x=ti(()=>y===void 0||m===null?[]:HS(y.info,m),[y?.info,m?.low,m?.high]);if(ei(()=>{y===void 0||!i||!r||n.atlas.want(u,y.path,x,s)},[n,u,d,x,s,i,r]),ei(()=>()=>{n.atlas.stop()},[n]),y===void 0||m===null)return null;const{label:T,unit:S}=Gt(y.info.key),E=({path:p,info:w})=>{const N=Mi(u,p),C=Gt(w.key).label+(N===""?"":`, ${N}`);return b("option",{value:Qe(p),children:C},Qe(p))},A=p=>{const w=new Map(c).set(d,{...m,...p});n.store.set({atlasSetup:{...o,ends:w}})};return b("div",{class:"atlas",children:[b("div",{class:"atlas-bar",children:[b("select",{"aria-label":"Number of the atlas",value:d,onChange:p=>{const{value:w}=p.currentTarget;n.store.set({atlasSetup:{...o,key:w}})},children:[h.length>0&&b("optgroup",{label:"Films",children:h.map(E)}),b("optgroup",{label:"Other numbers",children:f.filter(p=>!Bu(p)).map(E)})]}),b("span",{children:"From"}),b(zu,{label:"From",value:m.low,set:p=>{A({low:p})}}),b("span",{children:"to"}),b(zu,{label:"To",value:m.high,set:p=>{A({high:p})}}),b("span",{children:S})]}),x.length===0?b("p",{class:"fault-line",children:["Between ",sn(m.low)," and ",sn(m.high)," ",S," nothing is allowed."]}):a!==null?b("p",{class:"fault-line",children:a}):b(YS,{of:d,label:T,unit:S,now:y.value,locked:t.locks.has(d),take:p=>{n.edit(w=>en(w,y.path,p))}})]})}function qS(n,e){const t=_t(null);if(n===void 0)return null;if(e!==void 0)return e;const{path:i,info:s,value:r}=n,a=Qe(i),o=t.current;if(o?.name===a&&r>=o.ends.low&&r<=o.ends.high)return o.ends;const{low:l,high:c}=Th(s,r);return t.current={name:a,ends:{low:l,high:c}},t.current.ends}function zu(n){return b("input",{type:"number",step:"any","aria-label":n.label,value:n.value,onChange:e=>{const t=e.currentTarget.valueAsNumber;Number.isFinite(t)?n.set(t):e.currentTarget.value=String(n.value)}})}function YS(n){const{now:e,take:t,unit:i}=n,s=ar(p=>p.atlas),r=ar(p=>p.busy),a=ve(p=>p.readings),o=ar(p=>p.fraction),[l,c]=Un(null),u=s?.key===n.of?s:null,f=ti(()=>u===null?[]:KS(u),[u]);if(u===null)return b("p",{class:"empty",children:r?"Solving the paint at each value …":""});const{values:h}=u,[g,_]=[h[0],h[h.length-1]],y=p=>_>g?(p-g)/(_-g):.5,d=e>=g&&e<=_,m=l??{column:Hu(h,e),geometry:f[0]?.geometry??0},x=(p,w)=>{const{left:N,width:C}=w.getBoundingClientRect(),L=g+(p.clientX-N)/C*(_-g);return Hu(h,L)},T=p=>{const w=p.target.closest("[data-row]"),N=w===null?m.geometry:Number(w.dataset.row);c({column:x(p,p.currentTarget),geometry:N})},S=p=>{const w=h[p];w!==void 0&&!n.locked&&t(w)},E=p=>{const w=f.findIndex(({geometry:C})=>C===m.geometry),N=(C,L)=>{const k=f[Math.min(Math.max(w+L,0),f.length-1)],X=Math.min(Math.max(m.column+C,0),h.length-1);c({column:X,geometry:k?.geometry??0})};if(p.key==="ArrowLeft")N(-1,0);else if(p.key==="ArrowRight")N(1,0);else if(p.key==="ArrowUp")N(0,-1);else if(p.key==="ArrowDown")N(0,1);else if(p.key==="Home")N(-h.length,0);else if(p.key==="End")N(h.length,0);else if(p.key==="Enter"||p.key===" ")S(m.column);else return;p.preventDefault()},A=p=>`${(100*p).toFixed(2)}%`;return b("div",{class:"stage atlas-stage","aria-busy":r,children:[b("div",{class:"atlas-labels","aria-hidden":"true",children:f.map(({geometry:p,label:w})=>b("span",{children:w},p))}),b("div",{class:n.locked?"atlas-field locked":"atlas-field",role:"application",tabIndex:0,"aria-label":`Atlas of ${n.label.toLowerCase()}: arrow keys go from colour to colour, Enter takes one.`,onPointerMove:T,onPointerDown:T,onPointerLeave:()=>{c(null)},onClick:p=>{S(x(p,p.currentTarget))},onKeyDown:E,onBlur:()=>{c(null)},children:[f.map(({geometry:p,background:w})=>b("i",{class:p===m.geometry&&l!==null?"at":"","data-row":p,style:{background:w}},p)),d&&b("b",{class:"now",style:{left:A(y(e))}}),l!==null&&b("b",{class:"cursor",style:{left:A(y(h[l.column]??e))}})]}),a?.standard!=null&&b("div",{class:"atlas-standard",title:"The standard",children:f.map(({geometry:p})=>b(JS,{readings:a,geometry:p},p))}),b("div",{class:"atlas-axis","aria-hidden":"true",children:Yo(g,_,5).map(p=>b("span",{style:{left:A(y(p))},children:sn(p)},p))}),b("progress",{class:r?"":"done",max:1,value:o,"aria-label":"Colours of the atlas"}),b(QS,{atlas:u,place:m,unit:i,readings:a,hovers:l!==null})]})}function Hu(n,e){let t=0;return n.forEach((i,s)=>{Math.abs(i-e)<Math.abs(n[t]-e)&&(t=s)}),t}function KS({geometries:n,rgb:e}){const t=Rl(n);return t.flatMap(({title:i,places:s})=>s.map(({i:r,label:a})=>{const o=(e[r]??[]).map(bh),l=o.length===1?[...o,...o]:o;return{geometry:r,label:t.length>1?`${ZS(i)}${a}`:a,background:`linear-gradient(to right, ${l.join(", ")})`}}))}function ZS(n){const e=/\d+/.exec(n)?.[0];return e===void 0?"":`${e} / `}function JS(n){const e=aa(n.readings,n.geometry);return b("i",{style:e===null?{}:{background:si(e).css}})}function QS(n){const{atlas:e,place:t,unit:i,readings:s}=n,r=e.values[t.column],a=e.lab[t.geometry]?.[t.column],o=e.lab.flatMap((c,u)=>{const f=s===null?null:aa(s,u),h=c[t.column];return f===null||h===void 0?[]:[IS(f,h)]}),l=o.reduce((c,u)=>c+u,0)/o.length;return b("p",{class:"atlas-reading",role:"status",children:[b("b",{children:[r===void 0?"":sn(r)," ",i]}),b("span",{children:vs(e.geometries[t.geometry]??"")}),a!==void 0&&b(jS,{lab:a}),o.length>0&&b("span",{children:["mean ΔE ",tt(l,1)]})]})}function jS({lab:n}){return b("span",{children:["L* ",tt(n[0],1)," a* ",tt(n[1],1)," b* ",tt(n[2],1)]})}const eM=64,tM=new Set(["volume_fraction","alpha"]);function nM({path:n,info:e}){const t=e.key==="thickness_nm"&&n.includes("coats");return n[0]==="layer"&&(t||tM.has(e.key))}function iM({path:n,value:e},t){const i=t.fit,s=typeof i=="object"&&Qe(n)in i;return n[0]!=="fit"&&n[0]!=="uncertainty"&&(e!==0||s)}function sM(){const n=ve(_=>_.schema),e=ve(_=>_.document),t=ve(_=>_.standard),i=ve(_=>_.fit),s=ve(_=>_.settings.model),r=lt(),a=ve(_=>_.fitSetup),{said:o,starts:l}=a;if(n===null||t===null)return b("p",{class:"empty",children:"Load a standard first: measured readings as CSV. The fit then turns numbers of this paint until its colours match."});const{recipe:c,locks:u}=e,f=yh(n,c).filter(_=>iM(_,c)),h=_=>{const y=Qe(_.path);return!u.has(y)&&(o.get(y)??nM(_))},g=f.filter(h).map(({path:_})=>Qe(_));return b("div",{class:"fit",children:[b("p",{class:"fit-start",children:[i.running?b("button",{type:"button",onClick:()=>{r.stopFit()},children:"Stop"}):b("button",{type:"button",disabled:g.length===0,onClick:()=>{r.fit(g,l)},children:["Fit ",String(g.length)," ",g.length===1?"number":"numbers"]}),b("label",{children:["from"," ",b(Nd,{label:"Starts",min:1,max:eM,step:"1",value:l,disabled:i.running,set:_=>{r.store.set({fitSetup:{...a,starts:_}})}})," ",l===1?"start":"starts"]}),b("progress",{max:"1",value:i.fraction,"aria-label":"Progress of the fit",class:i.running?"":"idle"})]}),i.fault!==null&&b("p",{class:"fault-line",role:"alert",children:i.fault}),i.skipped.length>0&&b("p",{class:"found-by",role:"status",children:["Left as they are, since they do not change the colours: ",i.skipped.join("; "),"."]}),i.matches!==null&&i.model!==s&&b("p",{class:"found-by",children:["Found and read by ",Sh(n,i.model),"."]}),i.matches!==null&&b(rM,{matches:i.matches,colours:i.colours}),b("fieldset",{disabled:i.running,children:[b("legend",{children:"Free numbers"}),f.map(_=>{const y=Qe(_.path),{label:d,unit:m}=Gt(_.info.key);return b("label",{class:"free",children:[b("input",{type:"checkbox",checked:h(_),disabled:u.has(y),onChange:x=>{const T=x.currentTarget.checked,S=new Map(o).set(y,T);r.store.set({fitSetup:{...a,said:S}})}}),b("span",{children:[d,b("small",{children:Mi(c,_.path)})]}),b("b",{children:[u.has(y)?"locked, ":"",sn(_.value)," ",m]})]},y)})]})]})}function rM(n){const e=lt(),t=ve(i=>i.document.recipe);return b("ol",{class:"matches","aria-label":"Paints that were found",children:n.matches.map((i,s)=>b("li",{class:i.recipe===t?"used":"",children:[b("div",{class:"match-head",children:[b("b",{children:["Mean ΔE ",tt(i.mean_delta_e,2)]}),b("span",{children:["greatest ",tt(i.max_delta_e,2)]}),b("button",{type:"button",class:"small","aria-label":`Use match ${String(s+1)}`,onClick:()=>{e.useMatch(i.recipe)},children:"Use"})]}),b("div",{class:"stage match-chips",children:n.colours[s]?.lab.map((r,a)=>{const o=aa(n.colours[s],a);return b("div",{class:"faces",children:[o!==null&&b("i",{style:{background:si(o).css}}),b("i",{style:{background:si(r).css}})]},a)})}),b("dl",{children:i.parameters.map(({key:r,value:a,sd:o,at_bound:l})=>{const c=$r(r),{label:u,unit:f}=Gt(String(c.at(-1))),h=o===null?"":` ± ${sn(Number(o.toPrecision(2)))}`;return[b("dt",{children:[u," ",b("small",{children:Mi(i.recipe,c)})]},`${r} name`),b("dd",{children:[sn(a),h," ",f,l&&" (at its bound)"]},r)]})})]},s))})}function Cl({element:n}){const e=_t(null);return Er(()=>{e.current?.replaceChildren(n)},[n]),b("div",{ref:e})}const Gu=340;function nr(n,e){const t=Math.floor(Math.min(...n)/e)*e,i=Math.ceil(Math.max(...n)/e)*e;return[t,Math.max(i,t+e)]}function Vu(n,e,t,i){return[...Ud(n.geometries)].map(([s,r])=>{const a=r.map(({index:l})=>n.lab[l]),o={x:a.map((l,c)=>t(l,r[c]?.aspecular??0)),y:a.map(i),colour:"var(--line)",label:`${String(s)}°${e?" std":""}`,dashed:e};return e?o:{...o,pointColours:a.map(l=>si(l).css)}})}function Wu(n,e,t){const i=n.standard;return[...i===null?[]:Vu(i,!0,e,t),...Vu(n,!1,e,t)]}function aM(){const n=ve(t=>t.details),e=ti(()=>{if(n===null)return null;const t=Wu(n,(c,u)=>u,c=>c[0]),i=Wu(n,c=>c[1],c=>c[2]),s=n.standard===null?"":"; the standard dashed",r=nr(t.flatMap(({x:c})=>[...c]),15),a=nr([...t.flatMap(({y:c})=>[...c]),99],25)[1],o=nr(i.flatMap(({x:c})=>[...c]),20),l=nr(i.flatMap(({y:c})=>[...c]),20);return[Ko(t,{width:Gu,height:158,xLabel:"Aspecular angle, °",yLabel:"L*",named:t.length>1,x:r,y:[0,a],describedAs:`Lightness over the aspecular angle${s}`}),Ko(i,{width:Gu,height:226,xLabel:"a*",yLabel:"b*",x:o,y:l,square:!0,describedAs:`The way of the colour through a* and b*${s}`})]},[n]);return e===null?null:b(Bt,{children:e.map((t,i)=>b(Cl,{element:t},i))})}function oM(){const n=ve(s=>s.details);if(n===null)return null;const e=n.standard,t=Rl(n.geometries).flatMap(({places:s})=>s.map(({i:r})=>r)),i=s=>b("th",{scope:"row",children:[b("i",{class:"dot",style:{background:si(n.lab[s]).css}}),b(Od,{text:vs(n.geometries[s])})]});return b(Bt,{children:[b("table",{class:"figures",children:[b("thead",{children:b("tr",{children:["Angle","L*","a*","b*","C*","h"].map(s=>b("th",{scope:"col",children:s},s))})}),b("tbody",{children:t.map(s=>{const r=n.lab[s];return b("tr",{children:[i(s),[...r,Id(r)].map((a,o)=>b("td",{children:tt(a,2)},o)),b("td",{children:tt(NS(r),1)})]},s)})})]}),e?.dL!==void 0&&b("table",{class:"figures","aria-label":"Differences from the standard",children:[b("thead",{children:b("tr",{children:["Sample − standard","ΔL*","ΔC*","ΔH*","ΔE2000"].map(s=>b("th",{scope:"col",children:s},s))})}),b("tbody",{children:t.map(s=>b("tr",{children:[i(s),[e.dL,e.dC,e.dH].map((r,a)=>b("td",{children:tt(r?.[s],2)},a)),b("td",{class:"strong",children:tt(e.delta_e_2000?.[s],2)})]},s))})]})]})}function lM(){const n=lt(),e=ve(r=>r.sparkle),t=ve(r=>r.sparkleFraction),i=ve(r=>r.document),s=e!==null&&e.of.recipe!==i.recipe;return b("div",{class:"sparkle",children:[b("p",{class:"sparkle-start",children:[b("button",{type:"button",onClick:()=>{t===null?n.sparkle.measure():n.sparkle.stop()},children:t===null?"Measure sparkle and graininess":"Stop"}),b("progress",{max:"1",value:t??0,"aria-label":"Progress of the measurement",class:t===null?"idle":""})]}),e!==null&&b("div",{class:s?"old":"",children:[b("table",{class:"figures",children:[b("thead",{children:b("tr",{children:["Lamp","Sparkle","Spots per cm²","Intensity"].map(r=>b("th",{scope:"col",children:r},r))})}),b("tbody",{children:e.value.readings.map(r=>b("tr",{children:[b("th",{scope:"row",children:[tt(r.theta_i,0),"°"]}),b("td",{children:Xu(r.sparkle)}),b("td",{children:tt(r.spots_per_cm2?.value,0)}),b("td",{children:tt(r.intensity?.value,1)})]},r.theta_i))})]}),b("p",{children:["Graininess, diffuse light: ",b("b",{children:Xu(e.value.graininess)})]}),s&&b("p",{class:"note",children:"Of the paint before the last change."})]})]})}function Xu(n){if(n===null)return"–";const{value:e,standard_error:t}=n;return t===null?tt(e,1):`${tt(e,1)} ± ${tt(t,1)}`}function $u(n,e){return n.wavelengths_nm.length===0?[]:n.reflectance.map((t,i)=>({x:n.wavelengths_nm,y:t,colour:si(n.lab[i]).css,label:e?"":vs(n.geometries[i]),dashed:e}))}function cM(){const n=ve(t=>t.details),e=ti(()=>{if(n===null)return null;const i=[...n.standard===null?[]:$u(n.standard,!0),...$u(n,!1)],s=Math.max(...i.flatMap(({y:r})=>[...r]));return Ko(i,{width:340,height:400,xLabel:"Wavelength, nm",yLabel:"Reflectance factor",y:[0,Oi(s*1.02)],named:!0,describedAs:"Reflectance factor over wavelength, a curve an angle"})},[n]);return e===null?null:b(Cl,{element:e})}function uM({children:n}){const e=ve(Ms);return b("div",{class:e?"old":"",children:n})}const $a=n=>b(uM,{children:n}),hM=[{name:"flop",title:"Flop",panel:()=>$a(b(aM,{}))},{name:"numbers",title:"L*a*b*",panel:()=>$a(b(oM,{}))},{name:"spectra",title:"Spectra",panel:()=>$a(b(cM,{}))},{name:"atlas",title:"Atlas",panel:()=>b($S,{})},{name:"sparkle",title:"Sparkle",panel:()=>b(lM,{})},{name:"fit",title:"Fit",panel:()=>b(sM,{})}];function dM(){const[n,e]=Un("flop");return b("section",{class:"results","aria-label":"Readings",children:[b(fM,{}),b(pM,{}),b(WS,{}),b(mM,{}),b(DS,{label:"Details",tabs:hM,chosen:n,onChoose:e})]})}function fM(){const n=lt(),e=ve(s=>s.schema),t=ve(s=>s.settings),i=(s,r,a,o,l=c=>c)=>b("select",{"aria-label":s,title:s,value:r,onChange:c=>{o(c.currentTarget.value)},children:a.map(c=>b("option",{value:c,children:l(c)},c))});return b("div",{class:"conditions",children:[i("Angles",t.geometries,(e?.geometry_sets??[]).map(({name:s})=>s),s=>{n.setSettings({geometries:s})},s=>{const r=e?.geometry_sets.find(a=>a.name===s);return`${s}, ${String(r?.geometries.length??0)} angles`}),i("Illuminant",t.illuminant,e?.illuminants??[],s=>{n.setSettings({illuminant:s})}),i("Observer",t.observer,e?.observers??[],s=>{n.setSettings({observer:s})},s=>/^\d+$/.test(s)?`${s}°`:s),b("label",{class:"reading-model",title:"By which chips, plots, atlas and fit are computed. The picture is always by nacre: large flakes make it brighter towards the lamp than micro-flakes are.",children:["Readings by"," ",i("Readings by",t.model,(e?.reading_models??[]).map(({name:s})=>s),s=>{n.setSettings({model:s})},s=>e===null?s:Sh(e,s))]})]})}function pM(){const n=lt(),e=ve(r=>r.standard),t=ve(r=>r.settings.tolerance),i=ve(r=>r.readings),s=_t(null);return b("div",{class:"standard",children:[b("input",{ref:s,type:"file",accept:".csv,.json,text/csv",class:"hidden",tabIndex:-1,"aria-label":"File of a standard",onChange:r=>{const[a]=r.currentTarget.files??[];r.currentTarget.value="",a!==void 0&&n.openStandard(a)}}),e===null?b(Bt,{children:[b("button",{type:"button",class:"small",onClick:()=>s.current?.click(),children:"Load a standard …"}),b("button",{type:"button",class:"small",disabled:i===null,title:"The paint as it is now becomes the standard",onClick:()=>{i!==null&&n.setStandard(i.csv,"this paint.csv")},children:"Take this paint"})]}):b(Bt,{children:[b("span",{class:"standard-name",title:e.name,children:["Standard: ",b("b",{children:e.name})]}),b("label",{children:["ΔE ≤"," ",b(Nd,{label:"Tolerance, Delta E 2000 at each angle",min:.01,max:100,step:"any",value:t,set:r=>{n.setSettings({tolerance:r})}})]}),b("button",{type:"button",class:"small","aria-label":"Remove the standard",onClick:({currentTarget:r})=>{n.setStandard(null,"");const a=n.store.subscribe(()=>{n.store.get().standard===null&&(a(),document.activeElement===r&&hs(".standard button"))})},children:"Remove"})]})]})}function mM(){const n=ve(s=>s.readings),e=n?.standard??null,t=ve(Ms),i=(s,r,a=!1)=>b("div",{class:a?"wide":"",children:[b("dt",{children:s}),b("dd",{children:r})]});return b("dl",{class:t?"key-figures old":"key-figures",children:[i("Flop index",tt(n?.flop_index,2)),i("Colour travel",tt(n?.colour_travel.length,1)),i("Mean ΔE",tt(e?.mean,2)),i("Greatest ΔE",tt(e?.max,2))]})}function gM(n){try{return localStorage.getItem(`nacre-${n}`)}catch{return null}}function _M(n,e){try{localStorage.setItem(`nacre-${n}`,e)}catch{}}function qa(){const n=document.documentElement.dataset.theme;return n!==void 0?n==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function vM(){const n=sf("button",{type:"button",class:"theme"}),e=gM("theme");(e==="light"||e==="dark")&&(document.documentElement.dataset.theme=e);const t=()=>{n.textContent=qa()?"Light":"Dark",n.setAttribute("aria-label",`Use ${qa()?"light":"dark"} greys`)};return n.addEventListener("click",()=>{const i=qa()?"light":"dark";document.documentElement.dataset.theme=i,_M("theme",i),t()}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",t),t(),n}function xM(n,e){const{picture:t,enough:i}=n;return t===null||!ra(n)||n.recipe!==e?null:t.samples>=i?t:null}class SM{constructor(e){this.studio=e,this.leave=null}save(){this.leave?.(),this.leave=null;const{viewer:e,store:t}=this.studio,{gamutWarning:i,liveSamples:s}=e.store.get();if(i&&s!==null){const o=e.shown(t.get().document.recipe);o!==null&&this.write(o,"The live picture was saved, with its marks.");return}if(this.look())return;this.studio.say("Waiting for the path tracer's picture, to save it …");const r=()=>{this.look()&&this.leave?.()},a=[e.store.subscribe(r),t.subscribe(r)];this.leave=()=>{for(const o of a)o()}}look(){const{viewer:e,store:t}=this.studio,{document:i,fault:s,connection:r}=t.get(),a=e.store.get(),o=xM(a,i.recipe);if(o!==null){const c=`${String(o.samples)} of ${String(o.of)} samples a pixel`;return this.write(o,`The picture was saved, path traced, ${c}.`),!0}const l=s!==null?"the paint as it is now has none":r!=="open"?"there is no server to make it":a.fault;return l===null?!1:(this.studio.say(`The picture was not saved: ${l}.`),!0)}write({width:e,height:t,pixels:i},s){const{studio:r}=this,{name:a}=r.store.get().document.recipe,o=document.createElement("canvas");o.width=e,o.height=t;const l=new ImageData(i,e,t);o.getContext("2d")?.putImageData(l,0,0),up(o).then(c=>{wr(Ar(a,"png"),c,"image/png"),r.say(s)},c=>{r.say(Jr(c))})}}function qu(n,e){const{document:t,settings:i}=n.store.get(),{geometries:s,illuminant:r,observer:a,model:o,tolerance:l}=i;n.say("Making the report …"),n.connection.ask("report",{recipe:t.recipe,geometries:s,illuminant:r,observer:a,model:o,tolerance:{limit:l}},u=>{if(u.type==="error"){n.say(String(u.message));return}const f=String(u.html);e==="pdf"?cp(f):wr(Ar(t.recipe.name,"html"),f,"text/html"),n.say(e==="pdf"?"The report can be printed.":"The report was saved.")},u=>{n.say(`Making the report … ${(100*u).toFixed(0)} %`)},()=>{n.say("The server went away before the report was made.")})||n.say("There is no server to make the report.")}function MM(){const n=lt(),e=ve(a=>a.schema),t=ve(a=>a.canUndo),i=ve(a=>a.canRedo),s=ti(()=>vM(),[]),r=_t(null);return b("header",{class:"top",children:[b("h1",{children:["Nacre ",b("span",{children:"Studio"})]}),b(Zr,{label:"Start from a paint that ships",text:"Start from …",class:"start",chosen:null,choices:e?.paints??[],onChoose:a=>{const o=e?.paints.find(l=>l.name===a);o!==void 0&&n.openText(o.toml)}}),b("button",{type:"button",onClick:()=>r.current?.click(),children:"Open …"}),b("input",{ref:r,type:"file",accept:`.toml,.csv,.json,${dl},${fl},application/toml,text/plain`,class:"hidden",tabIndex:-1,"aria-label":"File of a recipe, a standard, a mesh or a light",onChange:a=>{const[o]=a.currentTarget.files??[];a.currentTarget.value="",o!==void 0&&n.openFile(o)}}),b("span",{class:"pair",children:[b(di,{icon:"undo",label:"Undo (Ctrl+Z)",disabled:!t,onClick:()=>{n.undo()}}),b(di,{icon:"redo",label:"Redo (Ctrl+Y)",disabled:!i,onClick:()=>{n.redo()}})]}),b("span",{class:"gap"}),b(yM,{}),b(Cl,{element:s})]})}function yM(){const n=lt(),e=ve(({readings:s,readingsOf:r,document:a,fault:o})=>s!==null&&(o===null||r===a)),t=({document:s})=>s.recipe.name,i=ti(()=>new SM(n),[n]);return b("span",{class:"saving",children:[b("button",{type:"button",disabled:!e,title:"Save the recipe, .toml",onClick:()=>{n.whenCurrent(s=>{const r=s.paint?.toml??"";wr(Ar(t(s),"toml"),r,"application/toml")})},children:"Save recipe"}),b("button",{type:"button",disabled:!e,title:"Save the path tracer's picture, .png",onClick:()=>{i.save()},children:"Picture"}),b("button",{type:"button",disabled:!e,title:"Save the readings, .csv",onClick:()=>{n.whenCurrent(s=>{const r=s.readings?.csv??"",a=`${s.readingsBy?.model??""}.csv`;wr(Ar(t(s),a),r,"text/csv")})},children:"Readings"}),b("button",{type:"button",disabled:!e,title:"Print the report of the panel, or save it as PDF",onClick:()=>{qu(n,"pdf")},children:"Report"}),b("button",{type:"button",disabled:!e,"aria-label":"Report as HTML",title:"Save the report of the panel, .html",onClick:()=>{qu(n,"html")},children:"HTML"}),b("button",{type:"button",title:"Copy an address that holds this paint",onClick:()=>{n.copyLink()},children:"Copy link"})]})}function vr(n){return n instanceof HTMLInputElement&&!["range","checkbox"].includes(n.type)}function EM(n){return vr(n)&&n.dataset.draft!=="false"}function bM(n){ei(()=>{const e=a=>{if(!(a.ctrlKey||a.metaKey)||EM(a.target))return;const o=a.key.toLowerCase();if(o==="z"&&!a.shiftKey)n.undo();else if(o==="y"||o==="z")n.redo();else return;a.preventDefault()},t=a=>{(!vr(a.target)||a.dataTransfer?.types.includes("Files")===!0)&&a.preventDefault()},i=a=>{const o=a.dataTransfer?.files[0],l=a.dataTransfer?.getData("text")??"";o===void 0&&vr(a.target)||(a.preventDefault(),o!==void 0?n.openFile(o):l.includes("=")&&n.openPasted(l))},s=a=>{const o=a.clipboardData?.getData("text")??"";vr(a.target)||!o.includes("=")||(a.preventDefault(),n.openPasted(o))},r=()=>{n.openLink(location.hash)};return document.addEventListener("keydown",e),document.addEventListener("dragover",t),document.addEventListener("drop",i),document.addEventListener("paste",s),addEventListener("hashchange",r),()=>{document.removeEventListener("keydown",e),document.removeEventListener("dragover",t),document.removeEventListener("drop",i),document.removeEventListener("paste",s),removeEventListener("hashchange",r)}},[n])}function wM({studio:n}){return bM(n),b(ff,{value:n,children:[b(MM,{}),b("main",{class:"studio",children:[b(np,{}),b(RS,{}),b(dM,{})]}),b(TM,{})]})}function TM(){const n=ve(r=>r.connection),e=ve(r=>r.latency_ms),t=ve(r=>r.notice),i=ve(r=>r.schema?.version),s={connecting:"Connecting …",open:"",gone:"The studio's program does not answer: has it ended? The paint is safe in this page, which goes on when the same program answers again.",refused:"Another nacre studio answers here, which does not know this page. Open the address that it printed, and paste the paint there: Copy link has it."}[n];return b("footer",{class:s===""||n==="connecting"?"status":"status gone",children:[b("span",{class:"notice",role:"status","aria-live":"polite",children:b("span",{children:s===""?t:s})}),b("span",{class:"latency",title:"From the last change to its colours on the screen",children:e===null?"":`${tt(e,0)} ms`}),b("span",{children:i===void 0?"":`Nacre ${i}`})]})}const Yu=300,AM=4e3,RM={f32:Float32Array,u8:Uint8Array,u16:Uint16Array,u32:Uint32Array,f16:Uint16Array};function CM(n,e){let t=0;return n.map(i=>{const s=RM[i.dtype],r=i.shape.reduce((o,l)=>o*l,1),a=new s(e,t,r);return t+=Math.ceil(a.byteLength/4)*4,{...i,data:a}})}class PM{constructor(e,t,i=()=>{}){this.connect=e,this.onChange=t,this.onUnread=i,this.socket=null,this.open=!1,this.closed=!1,this.nextId=1,this.wait=Yu,this.answers=new Map,this.awaiting=null,this.begin()}get isOpen(){return this.open}send(e,t,i){const s=this.nextId++;return this.answers.set(s,i),this.open&&this.socket?.send(JSON.stringify({type:e,id:s,...t})),s}forget(e){this.answers.delete(e)}tell(e,t){this.open&&this.socket?.send(JSON.stringify({type:e,...t}))}close(){this.closed=!0,this.socket?.close()}begin(){const e=this.connect();this.socket=e,e.binaryType="arraybuffer",e.onopen=()=>{this.open=!0,this.wait=Yu,this.onChange(!0)},e.onclose=()=>{this.open=!1,this.awaiting=null,this.answers.clear(),!this.closed&&(this.onChange(!1),setTimeout(()=>{this.begin()},this.wait),this.wait=Math.min(2*this.wait,AM))},e.onmessage=({data:t})=>{this.receive(t)}}receive(e){if(typeof e=="string"){const t=JSON.parse(e);Array.isArray(t.binary)?this.awaiting=t:this.deliver(t,[])}else if(e instanceof ArrayBuffer&&this.awaiting!==null){const t=this.awaiting;this.awaiting=null,this.deliver(t,CM(t.binary,e))}}deliver(e,t){const{id:i}=e;typeof i=="number"?this.answers.get(i)?.(e,t):e.type==="error"&&this.failAll(e)}failAll(e){this.onUnread(String(e.message));for(const t of[...this.answers.keys()])this.answers.get(t)?.({...e,id:t},[])}}const LM=`ior = 1.5
[[layer]]
thickness_um = 1
`;class DM{constructor(e,t,i){this.server=e,this.store=t,this.follower=i,this.standardText=null,this.standardAsked=null,this.openedText=null,this.toOpen=null,this.unanswered=new Map,this.begun=!1,this.session=new PM(e.connect,s=>{s?this.connected():this.disconnected()},s=>{this.store.set({notice:`The server did not read what it was sent: ${s}`})})}get isOpen(){return this.session.isOpen}async connected(){let e;try{e=this.store.get().schema??await this.server.schema(),this.store.set({connection:"open",schema:e}),this.follower.begin(e)}catch(s){const r=`The server does not say what a paint has: ${Jr(s)}`;this.store.set({notice:r});return}const t=this.standardAsked;this.standardText!==null&&this.sendStandard(this.standardText),t!==null&&this.sendStandard(t);const i=!this.begun;this.begun=!0,i||this.follower.back(),this.toOpen!==null?this.openText(this.toOpen.toml,this.toOpen.name):i&&this.follower.start(e)}disconnected(){this.server.refused().then(t=>{t&&!this.isOpen&&this.store.set({connection:"refused"})}),this.openedText=null;for(const t of this.unanswered.values())t();this.unanswered.clear();const{connection:e}=this.store.get();this.store.set({connection:e==="refused"?"refused":"gone"}),this.follower.lost()}openText(e,t){const i=_c(t??"The text",e);if(i!==null){this.store.set({notOpened:i});return}const s={toml:e,name:t?.slice(-Ih)};if(this.toOpen=s,!this.isOpen)return;const r=this.session.send("open",s,a=>{if(this.session.forget(r),this.toOpen===s&&(this.toOpen=null),a.type==="error"){this.store.set({notOpened:String(a.message)});return}const o=a.tree;this.openedText=e,this.follower.opened({recipe:o,locks:new Set,toml:e})})}openNothing(){this.toOpen=null}tellTextOf(e){const t=e.toml??LM;if(t===this.openedText)return;this.openedText=t;const i=this.session.send("open",{toml:t},()=>{this.session.forget(i)})}setStandard(e,t){const i=e===null?null:_c(t,e);if(i!==null){this.store.set({notice:i});return}this.standardAsked={csv:e,name:t},this.sendStandard(this.standardAsked)}sendStandard(e){if(!this.isOpen)return;const{csv:t,name:i}=e,{model:s}=this.store.get().settings,r=this.session.send("standard",{csv:t,name:i,model:s},a=>{this.session.forget(r);const o=e===this.standardAsked;if(o&&(this.standardAsked=null),a.type==="error"){const c=`The standard cannot be used: ${String(a.message)}`;this.store.set({notice:c});return}this.standardText=t===null?null:e;const l=t===null?null:a;this.follower.standardTaken(l,o)})}ask(e,t,i,s=()=>{},r=()=>{}){if(!this.isOpen)return!1;const a=this.session.send(e,t,(o,l)=>{if(o.type==="progress"){s(Number(o.fraction));return}this.session.forget(a),this.unanswered.delete(a),i(o,l)});return this.unanswered.set(a,r),!0}}const NM="There is no server to fit it; begin again when it answers.";function kd(n,e){const t=$r(e),{label:i}=Gt(String(t.at(-1))),s=Mi(n,t);return s===""?i:`${i}, ${s}`}function IM(n,e,t){return t===void 0?n:n.replace(t,kd(e,t))}class UM{constructor(e,t,i){this.store=e,this.session=t,this.onMatches=i,this.id=null}begin(e,t){const{document:i,settings:s}=this.store.get(),{model:r}=s;if(!this.session.isOpen){this.store.set({fit:{...ls,fault:NM}});return}this.store.set({fit:{...ls,running:!0,began:i,model:r}}),this.ask(i.recipe,e,t,r)}stop(){this.id!==null&&(this.session.tell("stop",{what:"fit"}),this.forget(),this.store.set({fit:{...this.store.get().fit,running:!1}}))}abandon(){this.id=null;const{fit:e}=this.store.get();if(!e.running)return;this.store.set({fit:{...e,running:!1,fault:"The server went away before the fit had ended."}})}ask(e,t,i,s){this.id=this.session.send("fit",{recipe:e,free:t,starts:i,model:s},r=>{const{fit:a}=this.store.get();if(r.type==="progress"){this.store.set({fit:{...a,fraction:Number(r.fraction)}});return}this.forget();const o=r.type==="error"?FM(r,t):null;if(o!==null){const c=[...a.skipped,kd(e,String(r.key))];this.store.set({fit:{...a,skipped:c}}),this.ask(e,o,i,s);return}const l={...a,running:!1,fraction:1};if(r.type==="matches"){const c=r.matches;this.store.set({fit:{...l,matches:c,colours:[],fault:null}}),this.onMatches()}else if(r.type==="error"){const c=r.key,u=IM(String(r.message),e,c);this.store.set({fit:{...l,fault:u}})}})}forget(){this.id!==null&&this.session.forget(this.id),this.id=null}}function FM(n,e){const t=e.filter(s=>s!==n.key);return String(n.message).includes("does not change the colours")&&t.length>0&&t.length<e.length?t:null}const OM=500;class kM{constructor(e){this.present=e,this.past=[],this.future=[],this.gesture=null}get now(){return this.present}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}push(e,t=null){e!==this.present&&((t===null||t!==this.gesture)&&(this.past.push(this.present),this.past.length>OM&&this.past.shift()),this.gesture=t,this.present=e,this.future=[])}begin(e){this.past=[],this.future=[],this.gesture=null,this.present=e}endGesture(){this.gesture=null}undo(){const e=this.past.pop();return e!==void 0&&(this.future.push(this.present),this.present=e),this.gesture=null,this.present}redo(){const e=this.future.pop();return e!==void 0&&(this.past.push(this.present),this.present=e),this.gesture=null,this.present}}class BM{constructor(e){this.send=e,this.underWay=null,this.waiting=null}get busy(){return this.underWay!==null}want(e){if(this.underWay!==null){this.waiting=e;return}this.underWay=e,this.send(e)}finished(){const e=this.waiting;this.underWay=this.waiting=null,e!==null&&this.want(e)}abandon(){const e=this.waiting??this.underWay;return this.underWay=this.waiting=null,e}}const Zo="#paint=",Ku=1<<20;async function Bd(n,e){const i=new Blob([n]).stream().pipeThrough(e).getReader(),s=[];let r=0;for(;;){const{done:l,value:c}=await i.read();if(l)break;if(r+=c.length,r>Ku)throw await i.cancel(),new Error(`holds more than ${String(Ku)} bytes`);s.push(c)}const a=new Uint8Array(r);let o=0;for(const l of s)a.set(l,o),o+=l.length;return a}function zM(n){let e="";for(const t of n)e+=String.fromCharCode(t);return btoa(e).replace(/\+/g,"-").replace(/\//g,"_").replace(/=+$/,"")}function HM(n){const e=atob(n.replace(/-/g,"+").replace(/_/g,"/"));return Uint8Array.from(e,t=>t.charCodeAt(0))}async function Zu({recipe:n,locks:e}){const t=JSON.stringify(e.size>0?{recipe:n,locks:[...e]}:{recipe:n}),i=new TextEncoder().encode(t);return Zo+zM(await Bd(i,new CompressionStream("deflate-raw")))}function GM(n){const e=/^\s*(?:\S*#)?(paint=[\w-]+)\s*$/.exec(n)?.[1];return e===void 0?null:`#${e}`}async function VM(n){if(!n.startsWith(Zo))return null;let e;try{const s=HM(n.slice(Zo.length)),r=await Bd(s,new DecompressionStream("deflate-raw"));e=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(r))}catch(s){const r=s instanceof Error?s.message:String(s);throw new Error(`The paint in this address cannot be read; was it cut? (${r})`)}const t=e??{};if(!mh(t.recipe)||!rt(t.recipe))throw new Error("The address holds something that is no paint.");const i=Array.isArray(t.locks)?t.locks.filter(s=>typeof s=="string"):[];return{recipe:t.recipe,locks:new Set(i)}}class WM{constructor(e,t){this.store=e,this.session=t,this.id=null}measure(){if(!this.session.isOpen)return;const{document:e}=this.store.get();this.store.set({sparkleFraction:0}),this.id=this.session.send("sparkle",{recipe:e.recipe},t=>{if(t.type==="progress"){this.store.set({sparkleFraction:Number(t.fraction)});return}if(t.type==="error")this.store.set({sparkle:null,notice:String(t.message)});else{const i=t;this.store.set({sparkle:{of:e,value:i}})}this.abandon()})}stop(){this.id!==null&&this.session.tell("stop",{what:"sparkle"}),this.abandon()}abandon(){this.id!==null&&this.session.forget(this.id),this.id=null,this.store.set({sparkleFraction:null})}}const Ya={recipe:{},locks:new Set},XM=400;class $M{constructor(e){this.around=e,this.history=new kM(Ya),this.store=new al({connection:"connecting",schema:null,document:Ya,canUndo:!1,canRedo:!1,paint:null,readings:null,readingsOf:null,readingsBy:null,details:null,fault:null,notOpened:null,latency_ms:null,settings:{geometries:"byk-mac",illuminant:"D65",observer:"10",model:"",tolerance:1},standard:null,sparkle:null,sparkleFraction:null,fit:ls,fitSetup:xc,atlasSetup:Sc,ownShape:null,ownLight:null,notice:""}),this.painting=new BM(i=>{this.sendPaint(i)}),this.connection=new DM(e,this.store,{begin:i=>{const{settings:s}=this.store.get(),r=s.model===""?i.reading_model:s.model;this.store.set({settings:{...s,model:r}}),this.viewer.begin(i)},start:i=>{this.start(i)},back:()=>{this.ownFiles.bringAgain(),this.measure()},lost:()=>{this.abandon()},opened:i=>{this.load(i)},standardTaken:this.standardTaken.bind(this)}),this.session=this.connection.session,this.viewer=new TS(this.session);let t=this.lamp;this.viewer.store.subscribe(()=>{this.lamp!==t&&(t=this.lamp,this.measure())}),this.atlas=new GS(this.session,i=>{this.viewer.hold("atlas",i)}),this.sparkle=new WM(this.store,this.session),this.fitting=new UM(this.store,this.session,()=>{this.measureMatch()}),this.ownFiles=new vp(this.store,this.viewer,this.connection)}async start(e){if(await this.openLink(this.around.fragment()))return;const t=e.start??e.paints[0]?.toml;t!==void 0&&this.openText(t)}abandon(){this.painting.abandon(),this.viewer.hold("colours",!1),this.viewer.abandon(),this.atlas.stop(),this.ownFiles.abandon(),this.sparkle.abandon(),this.fitting.abandon()}attach(e){const t=()=>{const{schema:i}=this.store.get();i!==null&&this.viewer.attach(e,i,this.around.bytes),this.measure()};e.addEventListener("webglcontextrestored",t),t()}edit(e,t=null){const i=this.history.now;i===Ya?this.history.begin(e(i)):this.history.push(e(i),t),this.changed()}endGesture(){this.history.endGesture()}undo(){this.history.undo(),this.changed()}redo(){this.history.redo(),this.changed()}changed(){this.store.set({document:this.history.now,canUndo:this.history.canUndo,canRedo:this.history.canRedo,notOpened:null}),this.measure(),clearTimeout(this.linkTimer),this.linkTimer=setTimeout(()=>{Zu(this.history.now).then(this.around.setFragment)},XM)}openText(e,t){this.connection.openText(e,t)}load(e){this.stopFit();const{starts:t}=this.store.get().fitSetup;this.store.set({fit:ls,fitSetup:{...xc,starts:t},atlasSetup:Sc}),this.edit(()=>e)}openPasted(e){const t=GM(e);t===null?this.openText(e):this.openLink(t)}openFile(e){const{name:t}=e,i=_p(t);if(i!==null)this.ownFiles.bring(i,e);else if(/\.(csv|json)$/i.test(t))this.openStandard(e);else{const s=Tr(t,e.size,"read");s!==null?this.store.set({notOpened:s}):e.text().then(r=>{this.openText(r,t)})}}openStandard(e){const t=Tr(e.name,e.size,"read");if(t!==null){this.say(t);return}e.text().then(i=>{this.setStandard(i,e.name)})}async openLink(e){try{const t=await VM(e);return t===null?!1:(this.connection.openNothing(),this.load(t),!0)}catch(t){return this.say(Jr(t)),!1}}say(e){this.store.set({notice:e})}setSettings(e){const{settings:t,fit:i}=this.store.get();this.store.set({settings:{...t,...e},fit:{...i,colours:[]}}),this.measure()}get lamp(){const{view:e}=this.viewer.store.get();return(this.store.get().schema?.lights??[]).find(({name:i})=>i===e?.light)?.illuminant??"D65"}measure(){const{document:e,settings:t}=this.store.get();if(!this.session.isOpen||Object.keys(e.recipe).length===0)return;const{recipe:i}=e;i!==this.viewer.store.get().recipe&&this.viewer.hold("colours",!0);const s=this.around.now(),{model:r}=t;this.painting.want({recipe:i,document:e,settings:t,model:r,lamp:this.lamp,since:s})}whenCurrent(e){const t=()=>{const s=this.store.get(),r=kh(s);return r&&e(s),r||s.fault!==null||s.connection!=="open"};if(t())return;const i=this.store.subscribe(()=>{t()&&i()})}get settled(){return!this.painting.busy}sendPaint({recipe:e,document:t,settings:i,model:s,lamp:r,since:a}){const{geometries:o,illuminant:l,observer:c,tolerance:u}=i,f={recipe:e,geometries:o,illuminant:l,observer:c,model:s,tolerance:{limit:u},shader:t!==null&&this.viewer.wantsShader,lamp:r};t!==null&&this.connection.tellTextOf(t);let h=Promise.resolve(),g=null,_=null;const y=this.session.send("paint",f,(d,m)=>{if(t===null){this.receiveMatch(y,{recipe:e,settings:i},d);return}switch(d.type){case"recipe":g=d;break;case"readings":{const x=d;this.store.set({paint:g,readings:x,readingsOf:t,readingsBy:i,fault:null}),h=new Promise(T=>{this.around.drawn(()=>{_={details:x,latency_ms:this.around.now()-a},T()})});break}case"shader":h.then(()=>{this.viewer.shader(t.recipe,d,m)});break;case"error":this.store.set({fault:d}),this.answered(y,null);break;case"done":this.answered(y,t.recipe,h),h.then(()=>{this.around.drawn(()=>{_!==null&&this.store.set(_)})});break}})}answered(e,t,i=Promise.resolve()){this.session.forget(e),this.painting.finished(),t!==null&&this.viewer.paint(t),i.then(()=>{this.painting.busy||this.viewer.hold("colours",!1)}),this.measureMatch()}measureMatch(){const{fit:e,settings:t}=this.store.get(),i=e.matches?.[e.colours.length];if(i===void 0||this.painting.busy||!this.session.isOpen)return;const{recipe:s}=i,r=this.around.now(),{model:a}=e,o=this.lamp;this.painting.want({recipe:s,document:null,settings:t,model:a,lamp:o,since:r})}receiveMatch(e,t,i){if(i.type==="readings"){const{fit:s,settings:r}=this.store.get();if(s.matches?.[s.colours.length]?.recipe!==t.recipe||r!==t.settings)return;const o=[...s.colours,i];this.store.set({fit:{...s,colours:o}})}else i.type==="done"?this.answered(e,null):i.type==="error"&&(this.session.forget(e),this.painting.finished())}setStandard(e,t){this.connection.setStandard(e,t)}standardTaken(e,t){t&&(this.stopFit(),this.store.set({fit:ls})),this.store.set({standard:e,notice:e?.notes.join(" ")??""}),this.measure()}fit(e,t){this.fitting.begin(e,t)}stopFit(){this.fitting.stop()}useMatch(e){this.edit(t=>({...t,recipe:e}))}copyLink(){Zu(this.history.now).then(e=>(this.around.setFragment(e),navigator.clipboard.writeText(this.around.address()))).then(()=>{this.say("The address of this page holds the paint; it was copied.")},()=>{this.say("The address of this page holds the paint; the browser did not let it be copied.")})}}const Pl=new URLSearchParams(location.search).get("token")??"",qM=`?token=${encodeURIComponent(Pl)}`;async function Ju(n){const e=await fetch(n,{headers:{"X-Nacre-Token":Pl}});if(!e.ok)throw new Error(`${String(e.status)} ${e.statusText}: ${n}`);return e}const YM=new $M({connect:()=>{const n=location.protocol==="https:"?"wss:":"ws:";return new WebSocket(`${n}//${location.host}/api/session${qM}`)},schema:async()=>await(await Ju("/api/schema")).json(),bytes:async n=>(await Ju(n)).arrayBuffer(),refused:async()=>{try{const n={"X-Nacre-Token":Pl},{status:e}=await fetch("/api/schema",{method:"HEAD",headers:n});return e===401}catch{return!1}},now:()=>performance.now(),drawn:n=>{requestAnimationFrame(()=>{setTimeout(n)})},fragment:()=>location.hash,setFragment:n=>{history.replaceState(null,"",n)},address:()=>location.href});Jd(b(wM,{studio:YM}),document.body);
