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
var Dr,tt,Iu,$n,Ll,Nu,Uu,Kr,Ys,is,Fu,Fo,Na,Ua,Ou,ur={},hr=[],vd=/acit|ex(?:s|g|n|p|$)|rph|grid|ows|mnc|ntw|ine[ch]|zoo|^ord|itera/i,Ir=Array.isArray;function Dn(n,e){for(var t in e)n[t]=e[t];return n}function Oo(n){n&&n.parentNode&&n.parentNode.removeChild(n)}function Bu(n,e,t){var i,s,r,a={};for(r in e)r=="key"?i=e[r]:r=="ref"?s=e[r]:a[r]=e[r];if(arguments.length>2&&(a.children=arguments.length>3?Dr.call(arguments,2):t),typeof n=="function"&&n.defaultProps!=null)for(r in n.defaultProps)a[r]===void 0&&(a[r]=n.defaultProps[r]);return Ks(n,a,i,s,null)}function Ks(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:void 0,__v:s??++Iu,__i:-1,__u:0};return s==null&&tt.vnode!=null&&tt.vnode(r),r}function Gt(n){return n.children}function ss(n,e){this.props=n,this.context=e}function fi(n,e){if(e==null)return n.__?fi(n.__,n.__i+1):null;for(var t;e<n.__k.length;e++)if((t=n.__k[e])!=null&&t.__e!=null)return t.__e;return typeof n.type=="function"?fi(n):null}function xd(n){if(n.__P&&n.__d){var e=n.__v,t=e.__e,i=[],s=[],r=Dn({},e);r.__v=e.__v+1,tt.vnode&&tt.vnode(r),Bo(n.__P,r,e,n.__n,n.__P.namespaceURI,32&e.__u?[t]:null,i,t??fi(e),!!(32&e.__u),s),r.__v=e.__v,r.__.__k[r.__i]=r,Vu(i,r,s),e.__e=e.__=null,r.__e!=t&&ku(r)}}function ku(n){if((n=n.__)!=null&&n.__c!=null)return n.__e=n.__c.base=null,n.__k.some(function(e){if(e!=null&&e.__e!=null)return n.__e=n.__c.base=e.__e}),ku(n)}function Fa(n){(!n.__d&&(n.__d=!0)&&$n.push(n)&&!dr.__r++||Ll!=tt.debounceRendering)&&((Ll=tt.debounceRendering)||Nu)(dr)}function dr(){try{for(var n,e=1;$n.length;)$n.length>e&&$n.sort(Uu),n=$n.shift(),e=$n.length,xd(n)}finally{$n.length=dr.__r=0}}function zu(n,e,t,i,s,r,a,o,l,c,u){var p,h,d,_,v,m,f=i&&i.__k||hr,x=e.length;for(l=Sd(t,e,f,l,x),p=0;p<x;p++)(d=t.__k[p])!=null&&(h=d.__i!=-1&&f[d.__i]||ur,d.__i=p,m=Bo(n,d,h,s,r,a,o,l,c,u),_=d.__e,d.ref&&h.ref!=d.ref&&(h.ref&&ko(h.ref,null,d),u.push(d.ref,d.__c||_,d)),v==null&&_!=null&&(v=_),4&d.__u?(l=Hu(d,l,n),h.__e&&(h.__e=null)):typeof d.type=="function"&&m!==void 0?l=m:_&&(l=_.nextSibling),d.__u&=-7);return t.__e=v,l}function Sd(n,e,t,i,s){var r,a,o,l,c,u=t.length,p=u,h=0;for(n.__k=new Array(s),r=0;r<s;r++)(a=e[r])!=null&&typeof a!="boolean"&&typeof a!="function"?(typeof a=="string"||typeof a=="number"||typeof a=="bigint"||a.constructor==String?a=n.__k[r]=Ks(null,a,null,null,null):Ir(a)?a=n.__k[r]=Ks(Gt,{children:a},null,null,null):a.constructor===void 0&&a.__b>0?a=n.__k[r]=Ks(a.type,a.props,a.key,a.ref?a.ref:null,a.__v):n.__k[r]=a,l=r+h,a.__=n,a.__b=n.__b+1,o=null,(c=a.__i=Md(a,t,l,p))!=-1&&(p--,(o=t[c])&&(o.__u|=2)),o==null||o.__v==null?(c==-1&&(s>u?h--:s<u&&h++),typeof a.type!="function"&&(a.__u|=4)):c!=l&&(c==l-1?h--:c==l+1?h++:(c>l?h--:h++,a.__u|=4))):n.__k[r]=null;if(p)for(r=0;r<u;r++)(o=t[r])!=null&&(2&o.__u)==0&&(o.__e==i&&(i=fi(o)),Xu(o,o));return i}function Hu(n,e,t){var i,s;if(typeof n.type=="function"){for(i=n.__k,s=0;i&&s<i.length;s++)i[s]&&(i[s].__=n,e=Hu(i[s],e,t));return e}n.__e!=e&&(e&&n.type&&!e.parentNode&&(e=fi(n)),e=t.insertBefore(n.__e,e||null));do e=e&&e.nextSibling;while(e!=null&&e.nodeType==8);return e}function Md(n,e,t,i){var s,r,a,o=n.key,l=n.type,c=e[t],u=c!=null&&(2&c.__u)==0;if(c===null&&o==null||u&&o==c.key&&l==c.type)return t;if(i>(u?1:0)){for(s=t-1,r=t+1;s>=0||r<e.length;)if((c=e[a=s>=0?s--:r++])!=null&&(2&c.__u)==0&&o==c.key&&l==c.type)return a}return-1}function Dl(n,e,t){e[0]=="-"?n.setProperty(e,t??""):n[e]=t==null?"":typeof t!="number"||vd.test(e)?t:t+"px"}function Ss(n,e,t,i,s){var r,a;e:if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Dl(n.style,e,"");if(t)for(e in t)i&&t[e]==i[e]||Dl(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")r=e!=(e=e.replace(Fu,"$1")),a=e.toLowerCase(),e=a in n||e=="onFocusOut"||e=="onFocusIn"?a.slice(2):e.slice(2),n.l||(n.l={}),n.l[e+r]=t,t?i?t[is]=i[is]:(t[is]=Fo,n.addEventListener(e,r?Ua:Na,r)):n.removeEventListener(e,r?Ua:Na,r);else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{n[e]=t??"";break e}catch{}typeof t=="function"||(t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t))}}function Il(n){return function(e){if(this.l){var t=this.l[e.type+n];if(e[Ys]==null)e[Ys]=Fo++;else if(e[Ys]<t[is])return;return t(tt.event?tt.event(e):e)}}}function Bo(n,e,t,i,s,r,a,o,l,c){var u,p,h,d,_,v,m,f,x,w,M,T,R,g,E,N,C=e.type;if(e.constructor!==void 0)return null;128&t.__u&&(l=!!(32&t.__u),r=[o=e.__e=t.__e]),(u=tt.__b)&&u(e);e:if(typeof C=="function"){p=a.length;try{if(x=e.props,w=C.prototype&&C.prototype.render,M=(u=C.contextType)&&i[u.__c],T=u?M?M.props.value:u.__:i,t.__c?f=(h=e.__c=t.__c).__=h.__E:(w?e.__c=h=new C(x,T):(e.__c=h=new ss(x,T),h.constructor=C,h.render=Ed),M&&M.sub(h),h.state||(h.state={}),h.__n=i,d=h.__d=!0,h.__h=[],h._sb=[]),w&&h.__s==null&&(h.__s=h.state),w&&C.getDerivedStateFromProps!=null&&(h.__s==h.state&&(h.__s=Dn({},h.__s)),Dn(h.__s,C.getDerivedStateFromProps(x,h.__s))),_=h.props,v=h.state,h.__v=e,d)w&&C.getDerivedStateFromProps==null&&h.componentWillMount!=null&&h.componentWillMount(),w&&h.componentDidMount!=null&&h.__h.push(h.componentDidMount);else{if(w&&C.getDerivedStateFromProps==null&&x!==_&&h.componentWillReceiveProps!=null&&h.componentWillReceiveProps(x,T),e.__v==t.__v||!h.__e&&h.shouldComponentUpdate!=null&&h.shouldComponentUpdate(x,h.__s,T)===!1){e.__v!=t.__v&&(h.props=x,h.state=h.__s,h.__d=!1),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(L){L&&(L.__=e)}),hr.push.apply(h.__h,h._sb),h._sb=[],h.__h.length&&a.push(h),o=fi(t);break e}h.componentWillUpdate!=null&&h.componentWillUpdate(x,h.__s,T),w&&h.componentDidUpdate!=null&&h.__h.push(function(){h.componentDidUpdate(_,v,m)})}if(h.context=T,h.props=x,h.__P=n,h.__e=!1,R=tt.__r,g=0,w)h.state=h.__s,h.__d=!1,R&&R(e),u=h.render(h.props,h.state,h.context),hr.push.apply(h.__h,h._sb),h._sb=[];else do h.__d=!1,R&&R(e),u=h.render(h.props,h.state,h.context),h.state=h.__s;while(h.__d&&++g<25);h.state=h.__s,h.getChildContext!=null&&(i=Dn(Dn({},i),h.getChildContext())),w&&!d&&h.getSnapshotBeforeUpdate!=null&&(m=h.getSnapshotBeforeUpdate(_,v)),E=u!=null&&u.type===Gt&&u.key==null?Wu(u.props.children):u,o=zu(n,Ir(E)?E:[E],e,t,i,s,r,a,o,l,c),h.base=e.__e,e.__u&=-161,h.__h.length&&a.push(h),f&&(h.__E=h.__=null)}catch(L){if(a.length=p,e.__v=null,l||r!=null){if(L.then){for(e.__u|=l?160:128;o&&o.nodeType==8&&o.nextSibling;)o=o.nextSibling;r!=null&&(r[r.indexOf(o)]=null),e.__e=o}else if(r!=null)for(N=r.length;N--;)Oo(r[N])}else e.__e=t.__e;e.__k==null&&(e.__k=t.__k||[]),L.then||Gu(e),tt.__e(L,e,t)}}else r==null&&e.__v==t.__v?(e.__k=t.__k,e.__e=t.__e):o=e.__e=yd(t.__e,e,t,i,s,r,a,l,c);return(u=tt.diffed)&&u(e),128&e.__u?void 0:o}function Gu(n){n&&(n.__c&&(n.__c.__e=!0),n.__k&&n.__k.some(Gu))}function Vu(n,e,t){for(var i=0;i<t.length;i++)ko(t[i],t[++i],t[++i]);tt.__c&&tt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){tt.__e(r,s.__v)}})}function Wu(n){return typeof n!="object"||n==null||n.__b>0?n:Ir(n)?n.map(Wu):n.constructor!==void 0?null:Dn({},n)}function yd(n,e,t,i,s,r,a,o,l){var c,u,p,h,d,_,v,m=t.props||ur,f=e.props,x=e.type;if(x=="svg"?s="http://www.w3.org/2000/svg":x=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r!=null){for(c=0;c<r.length;c++)if((d=r[c])&&"setAttribute"in d==!!x&&(x?d.localName==x:d.nodeType==3)){n=d,r[c]=null;break}}if(n==null){if(x==null)return document.createTextNode(f);n=document.createElementNS(s,x,f.is&&f),o&&(tt.__m&&tt.__m(e,r),o=!1),r=null}if(x==null)m===f||o&&n.data==f||(n.data=f);else{if(r=x=="textarea"&&f.defaultValue!=null?null:r&&Dr.call(n.childNodes),!o&&r!=null)for(m={},c=0;c<n.attributes.length;c++)m[(d=n.attributes[c]).name]=d.value;for(c in m)d=m[c],c=="dangerouslySetInnerHTML"?p=d:c=="children"||c in f||c=="value"&&"defaultValue"in f||c=="checked"&&"defaultChecked"in f||Ss(n,c,null,d,s);for(c in f)d=f[c],c=="children"?h=d:c=="dangerouslySetInnerHTML"?u=d:c=="value"?_=d:c=="checked"?v=d:o&&typeof d!="function"||m[c]===d||Ss(n,c,d,m[c],s);if(u)o||p&&(u.__html==p.__html||u.__html==n.innerHTML)||(n.innerHTML=u.__html),e.__k=[];else if(p&&(n.innerHTML=""),zu(e.type=="template"?n.content:n,Ir(h)?h:[h],e,t,i,x=="foreignObject"?"http://www.w3.org/1999/xhtml":s,r,a,r?r[0]:t.__k&&fi(t,0),o,l),r!=null)for(c=r.length;c--;)Oo(r[c]);o&&x!="textarea"||(c="value",x=="progress"&&_==null?n.removeAttribute("value"):_!=null&&(_!==n[c]||x=="progress"&&!_||x=="option"&&_!=m[c])&&Ss(n,c,_,m[c],s),c="checked",v!=null&&v!=n[c]&&Ss(n,c,v,m[c],s))}return n}function ko(n,e,t){try{if(typeof n=="function"){var i=typeof n.__u=="function";i&&n.__u(),i&&e==null||(n.__u=n(e))}else n.current=e}catch(s){tt.__e(s,t)}}function Xu(n,e,t){var i,s;if(tt.unmount&&tt.unmount(n),(i=n.ref)&&(i.current&&i.current!=n.__e||ko(i,null,e)),(i=n.__c)!=null){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(r){tt.__e(r,e)}i.base=i.__P=i.__n=null}if(i=n.__k)for(s=0;s<i.length;s++)i[s]&&Xu(i[s],e,t||typeof n.type!="function");t||Oo(n.__e),n.__c=n.__=n.__e=void 0}function Ed(n,e,t){return this.constructor(n,t)}function bd(n,e,t){var i,s,r,a;e==document&&(e=document.documentElement),tt.__&&tt.__(n,e),s=(i=!1)?null:e.__k,r=[],a=[],Bo(e,n=e.__k=Bu(Gt,null,[n]),s||ur,ur,e.namespaceURI,s?null:e.firstChild?Dr.call(e.childNodes):null,r,s?s.__e:e.firstChild,i,a),Vu(r,n,a),n.props.children=null}function wd(n){function e(t){var i,s;return this.getChildContext||(i=new Set,(s={})[e.__c]=this,this.getChildContext=function(){return s},this.componentWillUnmount=function(){i=null},this.shouldComponentUpdate=function(r){this.props.value!=r.value&&i.forEach(function(a){a.__e=!0,Fa(a)})},this.sub=function(r){i.add(r);var a=r.componentWillUnmount;r.componentWillUnmount=function(){i&&i.delete(r),a&&a.call(r)}}),t.children}return e.__c="__cC"+Ou++,e.__=n,e.Provider=e.__l=(e.Consumer=function(t,i){return t.children(i)}).contextType=e,e}Dr=hr.slice,tt={__e:function(n,e,t,i){for(var s,r,a;e=e.__;)if((s=e.__c)&&!s.__)try{if((r=s.constructor)&&r.getDerivedStateFromError!=null&&(s.setState(r.getDerivedStateFromError(n)),a=s.__d),s.componentDidCatch!=null&&(s.componentDidCatch(n,i||{}),a=s.__d),a)return s.__E=s}catch(o){n=o}throw n}},Iu=0,ss.prototype.setState=function(n,e){var t;t=this.__s!=null&&this.__s!=this.state?this.__s:this.__s=Dn({},this.state),typeof n=="function"&&(n=n(Dn({},t),this.props)),n&&Dn(t,n),n!=null&&this.__v&&(e&&this._sb.push(e),Fa(this))},ss.prototype.forceUpdate=function(n){this.__v&&(this.__e=!0,n&&this.__h.push(n),Fa(this))},ss.prototype.render=Gt,$n=[],Nu=typeof Promise=="function"?Promise.prototype.then.bind(Promise.resolve()):setTimeout,Uu=function(n,e){return n.__v.__b-e.__v.__b},dr.__r=0,Kr=Math.random().toString(8),Ys="__d"+Kr,is="__a"+Kr,Fu=/(PointerCapture)$|Capture$/i,Fo=0,Na=Il(!1),Ua=Il(!0),Ou=0;var Td=0;function b(n,e,t,i,s,r){e||(e={});var a,o,l=e;if("ref"in l)for(o in l={},e)o=="ref"?a=e[o]:l[o]=e[o];var c={type:n,props:l,key:t,ref:a,__k:null,__:null,__b:0,__e:null,__c:null,constructor:void 0,__v:--Td,__i:-1,__u:0,__source:s,__self:r};if(typeof n=="function"&&(a=n.defaultProps))for(o in a)l[o]===void 0&&(l[o]=a[o]);return tt.vnode&&tt.vnode(c),c}var jn,it,Zr,Nl,fr=0,$u=[],ut=tt,Ul=ut.__b,Fl=ut.__r,Ol=ut.diffed,Bl=ut.__c,kl=ut.unmount,zl=ut.__;function Hi(n,e){ut.__h&&ut.__h(it,n,fr||e),fr=0;var t=it.__H||(it.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function nn(n){return fr=1,qu(Yu,n)}function qu(n,e,t){var i=Hi(jn++,2);if(i.t=n,!i.__c&&(i.__=[Yu(void 0,e),function(o){var l=i.__N?i.__N[0]:i.__[0],c=i.t(l,o);l!==c&&(i.__N=[c,i.__[1]],i.__c.setState({}))}],i.__c=it,!it.__f)){var s=function(o,l,c){if(!i.__c.__H)return!0;var u=!1,p=i.__c.props!==o;if(i.__c.__H.__.some(function(d){if(d.__N){u=!0;var _=d.__[0];d.__=d.__N,d.__N=void 0,_!==d.__[0]&&(p=!0)}}),r){var h=r.call(this,o,l,c);return u?h||p:h}return!u||p};it.__f=!0;var r=it.shouldComponentUpdate,a=it.componentWillUpdate;it.componentWillUpdate=function(o,l,c){if(this.__e){var u=r;r=void 0,s(o,l,c),r=u}a&&a.call(this,o,l,c)},it.shouldComponentUpdate=s}return i.__N||i.__}function pi(n,e){var t=Hi(jn++,3);!ut.__s&&Ho(t.__H,e)&&(t.__=n,t.u=e,it.__H.__h.push(t))}function pr(n,e){var t=Hi(jn++,4);!ut.__s&&Ho(t.__H,e)&&(t.__=n,t.u=e,it.__h.push(t))}function Tt(n){return fr=5,mi(function(){return{current:n}},[])}function mi(n,e){var t=Hi(jn++,7);return Ho(t.__H,e)&&(t.__=n(),t.__H=e,t.__h=n),t.__}function Ad(n){var e=it.context[n.__c],t=Hi(jn++,9);return t.c=n,e?(t.__==null&&(t.__=!0,e.sub(it)),e.props.value):n.__}function zo(){var n=Hi(jn++,11);if(!n.__){for(var e=it.__v;e!==null&&!e.__m&&e.__!==null;)e=e.__;var t=e.__m||(e.__m=[0,0]);n.__="P"+t[0]+"-"+t[1]++}return n.__}function Rd(){for(var n;n=$u.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Zs),e.__h.some(Oa),e.__h=[]}catch(t){e.__h=[],ut.__e(t,n.__v)}}}ut.__b=function(n){it=null,Ul&&Ul(n)},ut.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),zl&&zl(n,e)},ut.__r=function(n){Fl&&Fl(n),jn=0;var e=(it=n.__c).__H;e&&(Zr===it?(e.__h=[],it.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})):(e.__h.some(Zs),e.__h.some(Oa),e.__h=[],jn=0)),Zr=it},ut.diffed=function(n){Ol&&Ol(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&($u.push(e)!==1&&Nl===ut.requestAnimationFrame||((Nl=ut.requestAnimationFrame)||Cd)(Rd)),e.__H.__.some(function(t){t.u&&(t.__H=t.u,t.u=void 0)})),Zr=it=null},ut.__c=function(n,e){e.some(function(t){try{t.__h.some(Zs),t.__h=t.__h.filter(function(i){return!i.__||Oa(i)})}catch(i){e.some(function(s){s.__h&&(s.__h=[])}),e=[],ut.__e(i,t.__v)}}),Bl&&Bl(n,e)},ut.unmount=function(n){kl&&kl(n);var e,t=n.__c;t&&t.__H&&(t.__H.__.some(function(i){try{Zs(i)}catch(s){e=s}}),t.__H=void 0,e&&ut.__e(e,t.__v))};var Hl=typeof requestAnimationFrame=="function";function Cd(n){var e,t=function(){clearTimeout(i),Hl&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Hl&&(e=requestAnimationFrame(t))}function Zs(n){var e=it,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),it=e}function Oa(n){var e=it;n.__c=n.__(),it=e}function Ho(n,e){return!n||n.length!==e.length||e.some(function(t,i){return t!==n[i]})}function Yu(n,e){return typeof e=="function"?e(n):e}function Ku(n,e,t){for(const[i,s]of Object.entries(e))s==null||s===!1||(i==="style"?n.style.cssText=String(s):n.setAttribute(i,s===!0?"":String(s)));for(const i of t)i!=null&&n.append(i)}function Pd(n,e={},...t){const i=document.createElement(n);return Ku(i,e,t),i}function zt(n,e={},...t){const i=document.createElementNS("http://www.w3.org/2000/svg",n);return Ku(i,e,t),i}function et(n,e){if(n==null||Number.isNaN(n))return"–";const t=n.toFixed(e);return(Number(t)===0?t.replace("-",""):t).replace("-","−")}function ds(n){return n.replace(/-/g,"−")}function ht(n){return typeof n=="object"&&!Array.isArray(n)}function sn(n){return Array.isArray(n)}function dt(n){let e="";for(const t of n)typeof t=="number"?e+=`[${String(t)}]`:e+=e===""?t:`.${t}`;return e}function Go(n){const e=[];for(const t of n.matchAll(/\[(\d+)\]|[^.[\]]+/g))e.push(t[1]===void 0?t[0]:Number(t[1]));return e}function Ld(n){return dt(n).replace(/\[\d+\]/g,"[]")}function Fn(n,e){let t=n;for(const i of e)typeof i=="number"?t=sn(t)?t[i]:void 0:t=ht(t)?t[i]:void 0;return t}function Nr(n,e,t){return Ba(n,e,t)}function Ba(n,e,t){const[i,...s]=e;if(i===void 0)return t;if(typeof i=="number"){const o=sn(n)?[...n]:[],l=Ba(o[i],s,t);return l===void 0?o.splice(i,1):o[i]=l,o}const r=ht(n)?{...n}:{},a=Ba(r[i],s,t);return a===void 0?Reflect.deleteProperty(r,i):r[i]=a,r}const Dd=["fit","uncertainty"];function cn(n,e,t){const i=Nr(n.recipe,e,t);return t===void 0?Ju({...n,recipe:i},s=>Zu(s,e)?null:s):{...n,recipe:i}}function Id(n,e,t){const i=new Set(n.locks);return t?i.add(dt(e)):i.delete(dt(e)),{...n,locks:i}}const Nd="correlation";function Zu(n,e){return e.every((t,i)=>n[i]===t)}function Ju(n,e){const t=r=>{const a=e(Go(r));return a===null?null:dt(a)},i=new Set;for(const r of n.locks){const a=t(r);a!==null&&i.add(a)}let s=n.recipe;for(const r of Dd){const a=s[r];if(!ht(a))continue;const o=Object.entries(a).flatMap(([c,u])=>{if(c===Nd){const h=sn(u)?Ud(u,t):u;return sn(h)&&h.length===0?[]:[[c,h]]}const p=t(c);return p===null?[]:[[p,u]]}),l=o.length>0?Object.fromEntries(o):void 0;s=Nr(s,[r],l)}return{recipe:s,locks:i}}function Ud(n,e){return n.flatMap(t=>{const i=ht(t)?t.of:void 0;if(!ht(t)||!sn(i))return[t];const s=i.flatMap(r=>{const a=typeof r=="string"?e(r):r;return a===null?[]:[a]});return s.length<2?[]:[{...t,of:s}]})}function Vo(n,e,t){return Ju(n,i=>{const s=i[e.length];if(!Zu(i,e)||typeof s!="number")return i;const r=t(s);return r===null?null:[...e,r,...i.slice(e.length+1)]})}function Wo(n,e){const t=Fn(n.recipe,e);return sn(t)?t:[]}function Xo(n,e,t){return{...n,recipe:Nr(n.recipe,e,t.length>0?t:void 0)}}function Qu(n,e,t,i){const s=[...Wo(n,e)];s.splice(t,0,i);const r=Vo(n,e,a=>a>=t?a+1:a);return Xo(r,e,s)}function Fd(n,e,t){const i=Wo(n,e).filter((r,a)=>a!==t),s=Vo(n,e,r=>r===t?null:r>t?r-1:r);return Xo(s,e,i)}function Od(n,e,t,i){const s=[...Wo(n,e)],[r,a]=[s[t],s[t+i]];if(r===void 0||a===void 0)return n;s[t]=a,s[t+i]=r;const o=Vo(n,e,l=>l===t?t+i:l===t+i?t:l);return Xo(o,e,s)}class $o{constructor(e){this.value=e,this.listeners=new Set}get(){return this.value}set(e){this.value={...this.value,...e};for(const t of[...this.listeners])t()}subscribe(e){return this.listeners.add(e),()=>{this.listeners.delete(e)}}}function qo(n,e){const[,t]=qu(r=>r+1,0),i=e(n.get()),s=Tt(e);return s.current=e,pi(()=>{let r=i;const a=()=>{const o=s.current(n.get());Object.is(o,r)||(r=o,t(void 0))};return a(),n.subscribe(a)},[n,i]),i}const ju=wd(null),Bd=ju.Provider;function ct(){const n=Ad(ju);if(n===null)throw new Error("drawn outside of the studio");return n}function we(n){return qo(ct().store,n)}function Ur(n){return we(({document:e})=>Fn(e.recipe,n))}function Ft(n){return qo(ct().viewer.store,n)}function Js(n){return qo(ct().atlas.store,n)}function Mn(n,e){const t=Ld(e);return n.recipe.tables.find(i=>i.path===t)}const kd=[["_g_per_cm3","g/cm³"],["_per_mm","mm⁻¹"],["_per_um","µm⁻¹"],["_um","µm"],["_nm","nm"],["_mm","mm"],["_deg","°"]],zd={ior:"Binder",alpha:"Tilt, alpha",alpha_bottom:"Tilt at bottom",diameter_spread_um:"± diameter",spread_nm:"± thickness",wa:"Waves a",wb:"Waves b",wc:"Waves c",wd:"Waves d",we:"Waves e"};function $t(n){const e=kd.find(([s])=>n.endsWith(s)),t=e===void 0?n:n.slice(0,-e[0].length),i=zd[n]??t.replace(/_/g," ");return{label:i.charAt(0).toUpperCase()+i.slice(1),unit:e?.[1]??""}}function Gi(n,e){const t=e.each.findIndex(({mark:i})=>i!==""&&i in n);return Math.max(t,0)}function Gl(n){return n.each.flatMap(({keys:e})=>e)}function Fr(n,e){const t=e.alternatives??[];return t.filter(i=>t.every(s=>{if(s===i)return!0;const r=s.each[Gi(n,s)]?.keys??[],a=Gl(s).filter(o=>!r.includes(o));return!Gl(i).every(o=>a.includes(o))}))}function Hd(n,e,t){for(const i of Fr(n,e)){const s=Gi(n,i);if(i.each[s]?.keys.includes(t.key)===!0)continue;const r=i.each.findIndex(({mark:a,keys:o})=>a===t.key||t.required&&o.includes(t.key));if(r>=0)return{group:i,to:r}}}function Vl(n,e,t){return Fr(n,e).find(i=>!i.required&&i.each[0]?.mark===""&&i.each[Gi(n,i)]?.mark===t)}function Yo(n,e){const t=new Set,i=new Set;for(const s of Fr(n,e)){const r=Gi(n,s);s.each.forEach(({keys:a},o)=>{for(const l of a)(o===r?i:t).add(l)})}for(const s of i)t.delete(s);return t}function Gd(n){const{min:e,max:t}=n;if(e===void 0&&t===void 0)return"";const i=n.min_excluded===!0||e===null?"(":"[",s=n.max_excluded===!0||t===null?")":"]",r=e==null?"−∞":On(e),a=t==null?"∞":On(t),o=$t(n.key).unit;return`${n.zero===void 0?"":"0 or "}${i}${r}, ${a}${s}${o===""?"":` ${o}`}`}function On(n){return String(Number(n.toPrecision(6))).replace("-","−")}function Vd(n,e){if(!Number.isFinite(e))return!1;if(n.zero!==void 0&&e===0)return!0;const{min:t,max:i}=n;return t!=null&&(n.min_excluded?e<=t:e<t)?!1:!(i!=null&&(n.max_excluded?e>=i:e>i))}function eh(n,e){const t=[],i=s=>{const r=Fn(e,s),a=Mn(n,s);if(!(!ht(r)||a===void 0))for(const o of a.keys){const l=r[o.key],c=[...s,o.key];typeof l=="number"&&(o.kind==="number"||o.kind==="spectrum")?t.push({path:c,info:o,value:l}):o.kind==="table"?i(c):o.kind==="list"&&sn(l)&&l.forEach((u,p)=>{i([...c,p])})}};return i([]),t}function fs(n,e){const t=[];e.slice(0,-1).forEach((s,r)=>{if(typeof s=="number"){const a=Fn(n,e.slice(0,r+1)),o=ht(a)?a.name??a.from??a.material:void 0,c=`${Ko(String(e[r-1]))} ${String(s+1)}`;t.push(typeof o=="string"&&o!==""?o:c)}else typeof e[r+1]!="number"&&t.push(s.replace(/_/g," "))});const i=t.join(", ");return i.charAt(0).toUpperCase()+i.slice(1)}function Ko(n){return n==="flakes"?n:n.replace(/s$/,"")}const Wd={clearcoat:{thickness_um:45},lean:{tilt_deg:5,azimuth_deg:0},substrate:{reflectance:.05},"layer[]":{thickness_um:15},"layer[].flakes[]":{name:"TiO2 on mica",volume_fraction:.03,diameter_um:18,orientation:{distribution:"beckmann",alpha:.1},core:{material:"mica",thickness_nm:500,spread_nm:60},coats:[{material:"TiO2_anatase",thickness_nm:110,spread_nm:5}]},"layer[].flakes[].coats[]":{material:"SiO2",thickness_nm:100,spread_nm:5},"layer[].flakes[].core":{material:"mica",thickness_nm:500,spread_nm:60},"layer[].flakes[].orientation.tilts[]":{tilt_deg:4,density:1},"clearcoat.orange_peel":{wc:.005,wd:.005},microfacet:{alpha:.1,film_ior:1.8,film_thickness_nm:150,base_ior:1.08,base_extinction:.5},"microfacet.facets":{count:1e7,cone_deg:3}},Xd={volume_fraction:.03,area_density_per_um:.1,mass_fraction:.05,density_g_per_cm3:3,diameter_nm:250,d10_um:8,d50_um:18,d90_um:32,thickness_um:15,thickness_nm:100,alpha:.1,reflectance:.5,K:10,S:10,scattering_per_mm:10,absorption_per_mm:10,waviness:.02,edge_um:.5,thickness_spread_um:3,roughness:.1,spread_nm:5,diameter_spread_um:5,transmittance:.1,alpha_bottom:.1};function Or(n,e,t){const i=[...e,t.key].map(a=>typeof a=="number"?"[]":`.${a}`).join("").slice(1),s=Wd[t.kind==="list"?`${i}[]`:i];if(s!==void 0)return t.kind==="list"?[s]:s;if(i==="layer[].pigment")return[qd(n)];const r=Xd[t.key];switch(t.kind){case"number":case"spectrum":return r??t.default??t.min??0;case"material":return n.materials[0]?.name??1.5;case"text":return t.choices==="pigments"?n.pigments[0]?.name??"":"";case"choice":return(Array.isArray(t.choices)?t.choices[0]:"")??"";case"flag":return!0;case"list":return[Wl(n,[...e,t.key,0])];case"table":return Wl(n,[...e,t.key])}}function $d(n,e){const t=Mn(n,e.slice(0,-1))?.keys.find(s=>s.key===e.at(-1));if(t===void 0)return{};const i=Or(n,e.slice(0,-1),t);return(Array.isArray(i)?i[0]:i)??{}}function qd(n){const e=n.pigments[0];return e===void 0?{scattering_per_mm:10,absorption_per_mm:10}:{from:e.name,volume_fraction:.05}}function Wl(n,e){const t=Mn(n,e);if(t===void 0)return{};const i=new Set((t.alternatives??[]).flatMap(({each:r})=>r.flatMap(a=>a.keys))),s={};for(const r of t.keys)r.required&&!i.has(r.key)&&(s[r.key]=Or(n,e,r));for(const r of t.alternatives??[])Fr(s,t).includes(r)&&th(n,e,t,r.each[0],s);return s}function th(n,e,t,i,s){for(const r of t.keys)(r.key===i?.mark||r.required&&i?.keys.includes(r.key))===!0&&s[r.key]===void 0&&(s[r.key]=Or(n,e,r))}function Jr(n,e,t,i,s){const r=Mn(n,e),a=i.each[s];if(r===void 0||a===void 0||Gi(t,i)===s)return t;const o=new Set(i.each.flatMap(({keys:u})=>u));for(const u of a.keys)o.delete(u);const l=Object.entries(t).filter(([u])=>!o.has(u)),c=Object.fromEntries(l);return th(n,e,r,a,c),c}const Yd={up:"M8 13V3M3.5 7.5 8 3l4.5 4.5",down:"M8 3v10M3.5 8.5 8 13l4.5-4.5",remove:"m4 4 8 8m0-8-8 8",copy:"M5.5 5.5v-3h8v8h-3m-8-5h8v8h-8z",lock:"M3.5 7.5h9v6h-9zM5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5",unlock:"M3.5 7.5h9v6h-9zM5.5 7.5V5a2.5 2.5 0 0 1 4.6-1.4",open:"m5 6 3 3.5L11 6",closed:"m6 5 3.5 3L6 11",undo:"M6 3 2.5 6.5 6 10M2.5 6.5H9a4 4 0 0 1 0 8H6",redo:"m10 3 3.5 3.5L10 10m3.5-3.5H7a4 4 0 0 0 0 8h3",add:"M8 3v10M3 8h10"};function nh({name:n}){return b("svg",{class:"icon",viewBox:"0 0 16 16",width:"16",height:"16","aria-hidden":"true",children:b("path",{d:Yd[n]})})}function ui(n){return b("button",{type:"button",class:"icon-button","aria-label":n.label,title:n.label,disabled:n.disabled??!1,"aria-pressed":n.pressed,onClick:n.onClick,children:b(nh,{name:n.icon})})}function ih(n){const e=t=>String(Math.round(255*Math.min(Math.max(t,0),1)));return`rgb(${n.map(e).join(", ")})`}function Xl({rgb:n}){return n===void 0?null:n===null?b("i",{class:"swatch none"}):b("i",{class:"swatch",style:{background:ih(n)}})}const Ms=2,ys=8,$l=380;function ql(n,e){const{top:t,bottom:i,left:s,width:r}=e.getBoundingClientRect(),a=innerHeight-i-Ms-ys,o=t-Ms-ys,l=Math.min($l,n.scrollHeight),c=a<l&&o>a,{style:u}=n;u.minWidth=`${String(r)}px`,u.maxHeight=`${String(Math.min($l,c?o:a))}px`,u.left=`${String(Math.max(ys,Math.min(s,innerWidth-n.offsetWidth-ys)))}px`,u.top=c?"auto":`${String(i+Ms)}px`,u.bottom=c?`${String(innerHeight-t+Ms)}px`:"auto"}const Kd=800;function Br(n){const{choices:e,chosen:t,onChoose:i}=n,[s,r]=nn(!1),[a,o]=nn(0),l=zo(),c=Tt(null),u=Tt(null),p=Tt(null),h=Tt({text:"",at:0}),d=e.find(({name:w})=>w===t);pr(()=>{if(!s||p.current===null||u.current===null)return;const[w,M]=[p.current,u.current];ql(w,M),w.focus({preventScroll:!0});const T=E=>{c.current?.contains(E.target)!==!0&&r(!1)},R=E=>{E.target!==w&&ql(w,M)},g=new IntersectionObserver(([E])=>{E?.isIntersecting===!1&&r(!1)});return g.observe(M),document.addEventListener("pointerdown",T),document.addEventListener("scroll",R,!0),addEventListener("resize",R),()=>{g.disconnect(),document.removeEventListener("pointerdown",T),document.removeEventListener("scroll",R,!0),removeEventListener("resize",R)}},[s]),pi(()=>{s&&p.current?.children[a]?.scrollIntoView({block:"nearest"})},[s,a]);const _=()=>{o(Math.max(0,e.findIndex(({name:w})=>w===t))),r(!0)},v=()=>{r(!1),u.current?.focus()},m=w=>{const M=e[w];v(),M!==void 0&&i(M.name)},f=w=>{const M=Date.now(),T=M-h.current.at>Kd;h.current={text:(T?"":h.current.text)+w.toLowerCase(),at:M};const R=T?a+1:a,E=[...e.keys()].map(N=>(N+R)%e.length).find(N=>{const{title:C,name:L}=e[N];return(C??L).toLowerCase().startsWith(h.current.text)});E!==void 0&&o(E)},x=w=>{const M=e.length-1;if(w.key==="ArrowDown")o(Math.min(a+1,M));else if(w.key==="ArrowUp")o(Math.max(a-1,0));else if(w.key==="Home")o(0);else if(w.key==="End")o(M);else if(w.key==="Enter"||w.key===" ")m(a);else if(w.key==="Escape")v();else if(w.key==="Tab")r(!1);else if(w.key.length===1&&!w.ctrlKey&&!w.metaKey)f(w.key);else return;w.key!=="Tab"&&w.preventDefault(),w.stopPropagation()};return b("div",{class:`picker ${n.class??""}`,ref:c,children:[b("button",{type:"button",ref:u,class:"picked","aria-label":d===void 0?n.label:`${n.label}: ${d.name}`,"aria-haspopup":"listbox","aria-expanded":s,disabled:n.disabled??!1,onClick:()=>{s?r(!1):_()},onKeyDown:w=>{(w.key==="ArrowDown"||w.key==="ArrowUp")&&(w.preventDefault(),_())},children:[n.text===void 0&&b(Xl,{rgb:d?.rgb}),b("span",{children:n.text??d?.title??d?.name??t??""})]}),s&&b("ul",{ref:p,class:"choices",role:"listbox",tabIndex:-1,"aria-label":n.label,"aria-activedescendant":`${l}-${String(a)}`,onKeyDown:x,children:e.map((w,M)=>b("li",{id:`${l}-${String(M)}`,role:"option","aria-selected":w.name===t,class:M===a?"active":"",onPointerMove:()=>{o(M)},onClick:()=>{m(M)},children:[b(Xl,{rgb:w.rgb}),b("span",{children:[w.title??w.name,w.summary!==void 0&&b("small",{children:w.summary})]})]},w.name))})]})}function Vi(n){return class extends ss{shouldComponentUpdate(t){return!Zd(this.props,t)}render(){return Bu(n,this.props)}}}function Zd(n,e){const[t,i]=[Object.entries(n),new Map(Object.entries(e))];return t.length===i.size&&t.every(([s,r])=>i.has(s)&&Jd(s,r,i.get(s)))}function Jd(n,e,t){return n==="path"?dt(e)===dt(t):e===t}function sh(n){const e=dt(n);return we(({fault:t})=>t?.key===e?ka(t.message,e):null)}function Qd(n){const e=dt(n);return we(({fault:t,document:i})=>{if(t?.key===void 0)return null;if(t.key===e)return ka(t.message,e);const s=Go(t.key);return s.length===n.length+1&&n.every((a,o)=>s[o]===a)&&Fn(i.recipe,s)===void 0?ka(t.message,e):null})}function ka(n,e){const t=n.indexOf(e),i=t<0?n:n.slice(t+e.length).replace(/^[ .:]+/,""),s=i.startsWith("= ")?i.indexOf(": "):-1;return s<0?i:i.slice(s+2)}function Zo({id:n,text:e}){return e===null?null:b("p",{class:"fault",id:n,role:"alert",children:e})}const jd={nm:100,um:50,"1/mm":100,"1/um":1,deg:45,"g/cm^3":5};function Ni(n){const e=10**Math.floor(Math.log10(n)),t=[1,2,5,10].find(i=>i*e>=n*(1-1e-9))??10;return Number((t*e).toPrecision(12))}function rh(n,e,t){const i=n.min??-1/0,s=n.max??1/0;let r,a;if(t!==void 0)[r,a]=t;else if(s-i<=1.0000001&&e>s/4)[r,a]=[i,s];else if(i<0)[r,a]=[i,s];else{const l=e>0?Ni(2*e):jd[n.unit]??1;[r,a]=[0,Math.min(l,s)]}Number.isFinite(r)||(r=-Ni(2*Math.abs(e)||1)),Number.isFinite(a)||(a=Ni(2*Math.abs(e)||1)),r<i&&n.zero===void 0&&(r=i);const o=Ni((a-r)/500);return{low:r,high:a,step:o}}function Qr(n,e,t){const i=Number((Math.round(t/e.step)*e.step).toPrecision(12));let s=Math.min(Math.max(i,e.low),e.high);const{min:r,max:a}=n;return n.zero!==void 0&&r!==null&&r!==void 0&&s<r?s<r/2?0:r:(r!=null&&(s=Math.max(s,n.min_excluded?r+e.step:r)),a!=null&&(s=Math.min(s,n.max_excluded?a-e.step:a)),Number(s.toPrecision(12)))}function Yl(n){return String(Number(n.toPrecision(6)))}function ef(n){if(!Array.isArray(n)||n.length!==2)return;const[e,t]=n;return typeof e=="number"&&typeof t=="number"?[e,t]:void 0}function ah(n){const{path:e,info:t,value:i}=n,s=ct(),r=dt(e),a=we(F=>F.document.locks.has(r)),o=we(F=>fs(F.document.recipe,e)),l=ef(Ur(["fit",r])),c=sh(e),u=zo(),[p,h]=nn(null),[d,_]=nn(null),v=Tt(null),m=Tt(!1),f=v.current,x=f===null||i>f.high||i<f.low,w=f!==null&&i>0&&i<f.high/40;(x||w&&!m.current)&&(v.current=rh(t,i,l));const{low:M,high:T,step:R}=v.current,{unit:g}=$t(t.key),E=n.label??$t(t.key).label,N=Gd(t),C=`${E}, ${o}`,L=(F,K)=>{s.edit(k=>cn(k,e,F),K)},H=()=>{if(p===null)return;const F=Number(p.trim().replace("−","-").replace(",","."));if(h(null),p.trim()===""||!Number.isFinite(F)){_(`“${p}” is not a number`);return}_(null),F!==i&&L(F,null)},W=(F,K)=>{K.preventDefault(),h(null);const k=K.shiftKey?10*R:R;L(Qr(t,{low:M,high:1/0,step:R},i+F*k),`type ${r}`)},I=d??c;return b("div",{class:I===null?"row number":"row number wrong","data-key":r,children:[b("label",{for:u,title:t.doc,children:E}),b("input",{type:"range",min:M,max:T,step:"any",value:i,disabled:a,"aria-label":`${C}, slider`,"aria-valuetext":`${Yl(i)} ${g}`,onInput:F=>{m.current=!0,_(null);const K=Number(F.currentTarget.value);L(Qr(t,{low:M,high:T,step:R},K),`slide ${r}`)},onChange:()=>{m.current=!1,s.endGesture()},onKeyDown:F=>{const k={ArrowRight:1,ArrowUp:1,ArrowLeft:-1,ArrowDown:-1,PageUp:20,PageDown:-20}[F.key];if(k===void 0)return;F.preventDefault();const te=F.shiftKey?10*R:R,X=Qr(t,{low:M,high:T,step:R},i+k*te);L(X,`slide ${r}`)},onBlur:()=>{s.endGesture()}}),b("input",{id:u,type:"text",inputMode:"decimal",autocomplete:"off",value:p??Yl(i),readOnly:a,title:N===""?t.doc:`${t.doc}; ${N}`,"aria-label":C,"aria-invalid":I!==null,"aria-describedby":I===null?void 0:`${u}-fault`,onInput:F=>{h(F.currentTarget.value)},onFocus:F=>{F.currentTarget.select()},onBlur:()=>{H(),s.endGesture()},onKeyDown:F=>{if(F.key==="Enter")H();else if(F.key==="Escape")h(null),_(null);else{if(a)return;F.key==="ArrowUp"?W(1,F):F.key==="ArrowDown"&&W(-1,F)}}}),b("span",{class:"unit",children:g}),b(ui,{icon:a?"lock":"unlock",label:a?`Unlock ${C}`:`Lock ${C}`,pressed:a,onClick:()=>{s.edit(F=>Id(F,e,!a))}}),b(Zo,{id:`${u}-fault`,text:I})]})}const tf=Vi(({path:n,info:e,value:t})=>{if(typeof t=="number"&&e.kind!=="material")return b(ah,{path:n,info:e,value:t});switch(e.kind){case"material":return b(nf,{path:n,info:e,value:t});case"choice":return b(rf,{path:n,info:e,value:t});case"text":return e.choices==="pigments"?b(sf,{path:n,info:e,value:t}):b(af,{path:n,info:e,value:t});case"spectrum":return of(t)?b(uf,{path:n,info:e,value:t}):b(Kl,{path:n,info:e,value:t});default:return b(Kl,{path:n,info:e,value:t})}});function Wi({path:n,info:e}){const t=ct(),i=we(o=>fs(o.document.recipe,n)),s=sh(n),r=zo(),{label:a}=$t(e.key);return{id:r,label:a,full:i===""?a:`${a}, ${i}`,fault:s,faultText:b(Zo,{id:`${r}-fault`,text:s}),describedBy:s===null?void 0:`${r}-fault`,class:s===null?"row":"row wrong",set:o=>{t.edit(l=>cn(l,n,o))}}}function as(n){return typeof n=="string"||typeof n=="number"?String(n):""}const jr="a number: its index";function nf(n){const e=Wi(n),{value:t}=n,i=we(u=>u.schema?.materials)??[],{info:s,path:r}=n,a=ht(t)?"own samples":typeof t=="string"?t:null,o=i.some(({name:u})=>u===t),l=[...a!==null&&!o?[{name:a,rgb:null}]:[],...i,{name:jr,summary:"the same at all wavelengths",rgb:null}],c=b(Br,{label:e.full,choices:l,chosen:typeof t=="number"?jr:a,onChoose:u=>{u===jr?e.set(typeof t=="number"?t:1.5):u!==a&&e.set(u)}});return typeof t=="number"?b(Gt,{children:[b("div",{class:e.class,children:[b("span",{class:"label",title:s.doc,children:e.label}),c]}),b(ah,{path:r,info:{...s,kind:"number"},value:t,label:"Index"})]}):b("div",{class:e.class,"data-key":r.join("."),children:[b("span",{class:"label",title:s.doc,children:e.label}),c,e.faultText]})}function sf(n){const e=Wi(n),t=we(i=>i.schema?.pigments)??[];return b("div",{class:e.class,children:[b("span",{class:"label",children:"Pigment"}),b(Br,{label:e.full,choices:t,chosen:as(n.value),onChoose:e.set}),e.faultText]})}function rf(n){const e=Wi(n),{info:t,value:i}=n,s=Array.isArray(t.choices)?t.choices:[];return b("div",{class:e.class,children:[b("label",{for:e.id,title:t.doc,children:e.label}),b("select",{id:e.id,"aria-label":e.full,"aria-describedby":e.describedBy,value:as(i),onChange:r=>{e.set(r.currentTarget.value)},children:s.map(r=>b("option",{value:r,children:r},r))}),e.faultText]})}function af(n){const e=Wi(n);return b("div",{class:e.class,children:[b("label",{for:e.id,title:n.info.doc,children:e.label}),b("input",{id:e.id,type:"text","aria-label":e.full,"aria-describedby":e.describedBy,value:as(n.value),onChange:t=>{e.set(t.currentTarget.value)}}),e.faultText]})}function of(n){return sn(n)&&n.length===3&&n.every(e=>typeof e=="number")}const lf=n=>n<=.0031308?12.92*n:1.055*n**(1/2.4)-.055,cf=n=>n<=.04045?n/12.92:((n+.055)/1.055)**2.4;function uf(n){const e=Wi(n),t=n.value,i=t.map(s=>Math.round(255*lf(Math.min(Math.max(s,0),1)))).map(s=>s.toString(16).padStart(2,"0")).join("");return b("div",{class:e.class,children:[b("label",{for:e.id,title:n.info.doc,children:e.label}),b("span",{class:"colour",children:[b("input",{id:e.id,type:"color","aria-label":e.full,"aria-describedby":e.describedBy,value:`#${i}`,onChange:s=>{const r=s.currentTarget.value.slice(1).match(/../g)??[],a=o=>Number(cf(parseInt(o,16)/255).toFixed(4));e.set(r.map(a))}}),b("span",{children:t.map(s=>s.toFixed(3)).join(" ")})]}),e.faultText]})}function Kl(n){const e=Wi(n),{value:t,info:i}=n,s=ht(t)?Fn(t,["wavelengths_nm"]):void 0,r=sn(s)?`${String(s.length)} samples, ${as(s[0])} to ${as(s.at(-1))} nm`:typeof t=="string"?t:"as in the recipe";return b("div",{class:e.class,children:[b("span",{class:"label",title:i.doc,children:e.label}),b("span",{class:"plain",children:r}),i.kind==="spectrum"&&b("button",{type:"button",class:"small","aria-label":`One number in place of samples: ${e.full}`,onClick:()=>{e.set(hf(t))},children:"One number"}),e.faultText]})}function hf(n){const e=ht(n)?n.values:void 0,t=sn(e)?e.filter(s=>typeof s=="number"):[];if(t.length===0)return .5;const i=t.reduce((s,r)=>s+r,0)/t.length;return Number(i.toPrecision(4))}const df=new Set(["name","volume_fraction","mass_fraction","density_g_per_cm3","binder_density_g_per_cm3"]),Qs=new Set(["coats"]),ff="core",os="name";function pf(n,e){const t=Yo(n,e),i=e.keys.some(s=>s.choices==="pigments"&&s.key in n);return e.keys.filter(s=>!(s.key in n)&&!t.has(s.key)&&s.key!==os&&s.choices!=="pigments"&&(!i||df.has(s.key)))}const Jo=Vi(({path:n})=>{const e=we(l=>l.schema),t=Ur(n),i=e===null?void 0:Mn(e,n),s=Qd(n);if(e===null||i===void 0||!ht(t))return null;const r=[],a=[],o=({key:l})=>l===ff;for(const l of[...i.keys.filter(c=>!o(c)),...i.keys.filter(o)]){const c=t[l.key],u=[...n,l.key];if(l.kind==="list")(sn(c)||n.length===0||oh(n,l.key))&&Mn(e,[...u,0])!==void 0&&(Yo(t,i).has(l.key)||a.push(b(xf,{path:u},l.key)));else{if(c===void 0||l.key===os)continue;l.kind==="table"?ht(c)&&Mn(e,u)!==void 0&&a.push(b(vf,{path:u,info:l},l.key)):r.push(b(tf,{path:u,info:l,value:c},l.key))}}return b(Gt,{children:[b(Zo,{id:`fault-${dt(n)}`,text:s}),r,a]})});function oh(n,e){return n.length===2&&n[0]==="layer"||e==="coats"}const lh=Vi(({path:n})=>{const e=we(r=>r.schema),t=ct();we(({document:r})=>mf(Fn(r.recipe,n)));const i=Fn(t.store.get().document.recipe,n),s=e===null?void 0:Mn(e,n);return e===null||s===void 0||!ht(i)?null:b(gf,{path:n,table:i,info:s,schema:e})});function mf(n){return ht(n)?Object.keys(n).join(" "):""}function gf(n){const{path:e,table:t,info:i,schema:s}=n,r=ct(),a=v=>v.kind!=="table"||Mn(s,[...e,v.key])!==void 0,o=v=>v.kind==="list"&&(e.length===0||oh(e,v.key)),l=pf(t,i).filter(v=>a(v)&&!o(v)),c=new Set((i.alternatives??[]).filter(v=>v.required).flatMap(v=>v.each.map(m=>m.mark))),u=i.keys.filter(v=>v.key in t&&(!v.required||Vl(t,i,v.key)!==void 0)&&!c.has(v.key)&&v.key!==os&&v.kind!=="list"&&v.kind!=="table"&&v.choices!=="pigments"),p=Yo(t,i),d=i.keys.some(v=>v.choices==="pigments"&&v.key in t)?[]:(i.alternatives??[]).flatMap((v,m)=>v.each.flatMap(({mark:f},x)=>{const w=Gi(t,v),M=v.each[w]?.mark??"";return x===w||f===""||M===""||p.has(M)?[]:[{g:m,i:x,text:`${$t(f).label} in place of ${_f(M)}`}]}));if(l.length+u.length+d.length===0)return null;const _=v=>{const[m,f,x]=v.split(":");r.edit(w=>{const M=Fn(w.recipe,e);if(m==="add"){const g=i.keys.find(C=>C.key===f);if(g===void 0)return w;const E=ht(M)?Hd(M,i,g):void 0;if(E===void 0||!ht(M))return cn(w,[...e,g.key],Or(s,e,g));const N=Jr(s,e,M,E.group,E.to);return cn(w,e,N)}if(m==="remove"){const g=ht(M)?Vl(M,i,f??""):void 0;return g===void 0||!ht(M)?cn(w,[...e,f??""],void 0):cn(w,e,Jr(s,e,M,g,0))}const T=i.alternatives?.[Number(f)];if(T===void 0||!ht(M))return w;const R=Jr(s,e,M,T,Number(x));return cn(w,e,R)})};return b("select",{class:"more","aria-label":`More of ${dt(e)||"the paint"}`,value:"",onChange:v=>{_(v.currentTarget.value),v.currentTarget.value=""},children:[b("option",{value:"",children:"More"}),l.length>0&&b("optgroup",{label:"Add",children:l.map(({key:v})=>b("option",{value:`add:${v}`,children:$t(v).label},v))}),d.length>0&&b("optgroup",{label:"Say otherwise",children:d.map(({g:v,i:m,text:f})=>b("option",{value:`instead:${String(v)}:${String(m)}`,children:f},f))}),u.length>0&&b("optgroup",{label:"Leave out",children:u.map(({key:v})=>b("option",{value:`remove:${v}`,children:$t(v).label},v))})]})}function _f(n){return $t(n).label.toLowerCase()}function ch(n){const[e,t]=nn(!0);return b("section",{class:`part ${n.kind}`,"aria-label":n.label,children:[b("header",{children:[b("button",{type:"button",class:"fold","aria-expanded":e,"aria-label":`${e?"Fold":"Unfold"} ${n.label}`,onClick:()=>{t(!e)},children:b(nh,{name:e?"open":"closed"})}),b("h3",{children:n.title}),b("span",{class:"tools",children:[b(lh,{path:n.path}),n.tools]})]}),e&&n.children]})}function vf({path:n,info:e}){const t=ct(),{label:i}=$t(e.key);return b(ch,{path:n,kind:e.key,title:i,label:i,tools:!e.required&&b(ui,{icon:"remove",label:`Remove ${i}`,onClick:()=>{t.edit(s=>cn(s,n,void 0))}}),children:b(Jo,{path:n})})}const xf=Vi(({path:n})=>{const e=Ur(n),t=sn(e)?e:[],i=String(n.at(-1)),s=[...t.keys()];Qs.has(i)&&s.reverse();const r=b(Sf,{path:n,at:t.length});return b("div",{class:`list ${i}`,children:[Qs.has(i)&&r,s.map(a=>b(Mf,{path:n,i:a,count:t.length},a)),!Qs.has(i)&&r]})}),Zl="own coefficients",Sf=Vi(({path:n,at:e})=>{const t=ct(),i=we(o=>o.schema);if(i===null)return null;const s=String(n.at(-1)),r=Ko(s),a=(o=$d(i,n))=>{t.edit(l=>Qu(l,n,e,o))};return s==="pigment"?b(Br,{class:"add",label:"Add a pigment",text:"+ Pigment",chosen:null,choices:[...i.pigments,{name:Zl,summary:"scattering and absorption",rgb:null}],onChoose:o=>{a(o===Zl?{scattering_per_mm:10,absorption_per_mm:10}:{from:o,volume_fraction:.05})}}):b("button",{type:"button",class:"add",onClick:()=>{a()},children:["+ ",r.charAt(0).toUpperCase()+r.slice(1)]})}),Mf=Vi(({path:n,i:e,count:t})=>{const i=ct(),s=we(f=>f.schema),r=[...n,e],a=Ur(r),o=String(n.at(-1)),l=Ko(o),c=o==="layer"&&t===1?"":` ${String(e+1)}`,u=`${l.charAt(0).toUpperCase()}${l.slice(1)}${c}`;if(!ht(a)||s===null)return null;const p=Mn(s,r)?.keys.some(({key:f})=>f===os)===!0,h=typeof a.name=="string"?a.name:"",d=h===""?u:`${u}, ${h}`,_=p?b("input",{type:"text",class:"name",value:h,placeholder:typeof a.from=="string"?a.from:u,"aria-label":`Name of ${u.toLowerCase()}`,onChange:f=>{const x=f.currentTarget.value;i.edit(w=>cn(w,[...r,os],x===""?void 0:x))}}):u,v=Qs.has(o)?1:-1,m=(f,x)=>b(ui,{icon:x,label:`Move ${d} ${x}`,disabled:e+f<0||e+f>=t,onClick:()=>{i.edit(w=>Od(w,n,e,f))}});return b(ch,{path:r,kind:o,title:_,label:d,tools:b(Gt,{children:[t>1&&m(v,"up"),t>1&&m(v===1?-1:1,"down"),b(ui,{icon:"copy",label:`Duplicate ${d}`,onClick:()=>{i.edit(f=>Qu(f,n,e+1,a))}}),b(ui,{icon:"remove",label:`Remove ${d}`,onClick:()=>{i.edit(f=>Fd(f,n,e))}})]}),children:b(Jo,{path:r})})});function yf(){const n=ct(),e=we(o=>o.document.recipe.name),t=we(o=>o.fault),i=we(o=>o.notOpened),s=we(o=>o.paint?.warnings),r=i===null?t?.message:`Not opened: ${i}`;return b("section",{class:"composition","aria-label":"Composition",children:[b("div",{class:"paint-name",children:[b("input",{type:"text",class:"name","aria-label":"Name of the paint",placeholder:"Without a name",value:typeof e=="string"?e:"",onChange:o=>{const l=o.currentTarget.value;n.edit(c=>cn(c,["name"],l===""?void 0:l))}}),b(lh,{path:[]})]}),b("div",{class:"form",children:b(Jo,{path:[]})}),b("div",{class:"said-place",children:b("div",{class:r===void 0?"said":"said wrong",role:"status","aria-label":"What the server says of the recipe",children:(r===void 0?s??[]:[r]).map(o=>b("p",{children:o},o))})})]})}const mr=180/Math.PI;function uh(n){const{position_mm:e,target_mm:t,fov_deg:i,aspect:s}=n.camera,[r,a,o]=[0,1,2].map(c=>e[c]-t[c]),l=Math.hypot(r,a,o);return{azimuth_deg:Math.atan2(a,r)*mr,elevation_deg:Math.asin(o/l)*mr,distance_mm:l,fov_deg:i,aspect:s}}function hh({aspect:n,...e},t,i){const s=Math.max(1,n*i/t),r=Math.tan(e.fov_deg/2/mr);return{...e,fov_deg:2*mr*Math.atan(r*s)}}const Jl=(n,e,t)=>Math.min(Math.max(n,e),t);function Ef(n,e,t=1){return{...n,elevation_deg:Jl(n.elevation_deg+e,-85,85),distance_mm:Jl(n.distance_mm/t,1,1e5)}}function Ql(n){const e=(n%360+360)%360;return e>180?e-360:e}function gr(n){return n instanceof Error?n.message:String(n)}function js(n,e,t){const i=URL.createObjectURL(new Blob([e],{type:t})),s=document.createElement("a");s.href=i,s.download=n,s.click(),setTimeout(()=>{URL.revokeObjectURL(i)},1e4)}function er(n,e){const i=(typeof n=="string"?n.toLowerCase().replace(/[^\p{L}\p{N}]+/gu,"-"):"").replace(/^-+|-+$/g,"").slice(0,80);return`${i===""?"paint":i}.${e}`}function bf(n){return new Promise((e,t)=>{const i=new FileReader;i.onload=()=>{const s=i.result;e(s.slice(s.indexOf(",")+1))},i.onerror=()=>{t(new Error("the browser could not read it"))},i.readAsDataURL(n)})}function wf(n){document.querySelector("iframe.print")?.remove();const e=document.createElement("iframe");e.className="print",e.title="Report",e.addEventListener("load",()=>{e.contentWindow?.focus(),e.contentWindow?.print()}),e.srcdoc=n,document.body.append(e)}function Tf(n){return new Promise((e,t)=>{n.toBlob(i=>{i===null?t(new Error("the browser could not write a PNG")):e(i)},"image/png")})}function Af({uniforms:n}){return Object.fromEntries(n.map(({name:e,components:t,array:i,values:s})=>[e,t===1&&!i?s[0]:Float32Array.from(s)]))}function Rf(n,e,t){const i=String(n.program);typeof n.glsl=="string"&&t.set(i,n.glsl);const s=t.get(i);if(s===void 0)throw new Error(`shader ${i}: its text did not come`);return{program:i,glsl:s,smoothCoat:n.smooth_coat===!0,flakes:s.includes("#define NACRE_FLAKES "),films:!1,...dh(n,e)}}function Cf(n,e){return n.type!=="films"?{uniforms:[],textures:[]}:dh(n,e)}function Pf(n,e){const t=new Set([...e.uniforms,...e.textures].map(({name:s})=>s)),i=s=>s.filter(({name:r})=>!t.has(r));return{...n,films:!0,uniforms:[...i(n.uniforms),...e.uniforms],textures:[...i(n.textures),...e.textures]}}function dh(n,e){return{uniforms:n.uniforms,textures:e.map(({name:t,shape:i,data:s})=>({name:t,size:i.slice(0,-1).reverse(),data:new Uint16Array(s.buffer,s.byteOffset,s.byteLength/2)}))}}function fh(n){const[e,t]=new Uint32Array(n,0,2),i=8;return{positions:new Float32Array(n,i,3*e),normals:new Float32Array(n,i+12*e,3*e),indices:new Uint32Array(n,i+32*e,3*t)}}function ph(n){const[e]=new Uint32Array(n,0,1),t=new TextDecoder().decode(new Uint8Array(n,4,e)),i=JSON.parse(t),[s,r]=new Uint32Array(n,4+e,2),a=new Float32Array(n,12+e,3*s*r);return{...i,width:s,height:r,rgb:a}}const jl=6e6,Lf=80,Qo=".obj,.ply,.stl,.glb,.gltf",jo=".hdr,.exr",ec=n=>new RegExp(`(${n.replace(/\./g,"\\.").replace(/,/g,"|")})$`,"i"),[Df,If]=[ec(Qo),ec(jo)];function Nf(n){return Df.test(n)?"shape":If.test(n)?"light":null}class Uf{constructor(e,t,i){this.store=e,this.viewer=t,this.ask=i}bringAgain(){const{ownShape:e,ownLight:t}=this.store.get();e!==null&&this.bring("shape",e.file,e.yUp),t!==null&&this.bring("light",t.file)}abandon(){for(const e of["shape","light"])this.viewer.hold(e,!1)}async bring(e,t,i=!1){const{ownShape:s,ownLight:r}=this.store.get(),a=e==="shape"?s:r;if(t.size>jl){const[o,l]=[t.size,jl].map(c=>(c/1e6).toFixed(1));this.say(`${t.name} has ${o??""} MB; at most ${l??""} MB can be shown.`);return}this.say(`Reading ${t.name} …`),this.viewer.hold(e,!0);try{const o=await bf(t),l={file:t.name.slice(-Lf),base64:o};if(this.ask(e,e==="shape"?{...l,y_up:i}:l,(u,p)=>{this.viewer.hold(e,!1),u.type==="error"?this.say(String(u.message)):this.brought({file:t,yUp:i,name:""},a,u,p)}))return}catch(o){this.say(`${t.name}: ${gr(o)}`)}this.viewer.hold(e,!1)}brought(e,t,i,s){const{schema:r}=this.store.get(),a=s[0]?.data;if(r===null||a===void 0)return;const o=a.buffer,l=this.viewer.store.get().view,c=t?.file===e.file;if(i.type==="shape"){const u=i.shape,p=[...r.shapes.filter(({name:m})=>m!==t?.name),u],h={...r,shapes:p};this.store.set({schema:h,ownShape:{...e,name:u.name}}),this.viewer.add(h,{mesh:fh(o)},u.name),(!c||l?.shape===t.name)&&this.viewer.setShape(h,u.name,!1);const[d,_]=[i.extent_mm,i.shown_mm].map(m=>Number(Number(m).toPrecision(3))),v=`${String(d)} mm${d===_?"":`, shown as ${String(_)} mm`}`;this.say(`${e.file.name}: ${String(i.triangles)} triangles, ${v}.`)}else{const u=i.light,p=[...r.lights.filter(({name:_})=>_!==t?.name),u],h={...r,lights:p};this.store.set({schema:h,ownLight:{...e,name:u.name}}),this.viewer.add(h,{light:ph(o)},u.name),(!c||l?.light===t.name)&&this.viewer.setView({light:u.name});const d=`${String(i.width)} x ${String(i.height)} pixels`;this.say(`${e.file.name}: ${d}, a white panel that lies flat is white. ${String(i.note)}`)}}say(e){this.store.set({notice:e})}}const el="187",Ff=0,tc=1,Of=2,tr=1,Bf=2,es=3,gi=0,Ht=1,vn=2,hi=0,rs=1,nc=2,ic=3,sc=4,mh=5,Ii=100,kf=101,zf=102,Hf=103,Gf=104,Vf=200,za=201,Wf=202,Xf=203,gh=204,_h=205,$f=206,qf=207,Yf=208,Kf=209,Zf=210,Jf=211,Qf=212,jf=213,ep=214,Ha=0,Ga=1,_r=2,ls=3,Va=4,Wa=5,Xa=6,$a=7,vh=0,tp=1,np=2,In=0,xh=1,Sh=2,Mh=3,yh=4,Eh=5,bh=6,wh=7,Th=300,Oi=301,cs=302,ea=303,ta=304,vr=1e3,xn=1001,qa=1002,_t=1003,ip=1004,Es=1005,Ct=1006,na=1007,Jn=1008,en=1009,Ah=1010,Rh=1011,us=1012,tl=1013,En=1014,Ot=1015,Vt=1016,nl=1017,il=1018,Bi=1020,Ch=35902,Ph=35899,Lh=1021,Dh=1022,tn=1023,ei=1026,Qn=1027,kr=1028,sl=1029,_i=1030,rl=1031,al=1033,nr=33776,ir=33777,sr=33778,rr=33779,Ya=35840,Ka=35841,Za=35842,Ja=35843,Qa=36196,ja=37492,eo=37496,to=37488,no=37489,xr=37490,io=37491,so=37808,ro=37809,ao=37810,oo=37811,lo=37812,co=37813,uo=37814,ho=37815,fo=37816,po=37817,mo=37818,go=37819,_o=37820,vo=37821,xo=36492,So=36494,Mo=36495,yo=36283,Eo=36284,Sr=36285,bo=36286,sp=3200,rc=0,rp=1,Kn="",jt="srgb",hs="srgb-linear",Mr="linear",Je="srgb",ia=7680,ap=519,op=512,lp=513,cp=514,Ih=515,up=516,hp=517,Nh=518,Uh=519,dp=35044,wo="300 es",hn=2e3,yr=2001;function fp(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Er(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function pp(){const n=Er("canvas");return n.style.display="block",n}const ac={};function oc(...n){const e="THREE."+n.shift();console.log(e,...n)}function Fh(n){const e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){const t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Pe(...n){n=Fh(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function qe(...n){n=Fh(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function ar(...n){const e=n.join(" ");e in ac||(ac[e]=!0,Pe(...n))}function mp(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}const gp={[Ha]:Ha,[_r]:Xa,[Va]:Va,[ls]:Wa,[Ga]:Ga,[Xa]:_r,[$a]:$a,[Wa]:ls};class Si{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){const i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){const i=this._listeners;if(i===void 0)return;const s=i[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const i=t[e.type];if(i!==void 0){e.target=this;const s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}}const Dt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],sa=Math.PI/180,To=180/Math.PI;function ps(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Dt[n&255]+Dt[n>>8&255]+Dt[n>>16&255]+Dt[n>>24&255]+"-"+Dt[e&255]+Dt[e>>8&255]+"-"+Dt[e>>16&15|64]+Dt[e>>24&255]+"-"+Dt[t&63|128]+Dt[t>>8&255]+"-"+Dt[t>>16&255]+Dt[t>>24&255]+Dt[i&255]+Dt[i>>8&255]+Dt[i>>16&255]+Dt[i>>24&255]).toLowerCase()}function Ge(n,e,t){return Math.max(e,Math.min(t,n))}function _p(n,e){return(n%e+e)%e}function ra(n,e,t){return(1-t)*n+t*e}function vp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ol(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function xp(n,e){if(e.constructor===Float32Array)return n;const t=ol(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Sp(n,e){if(e.constructor===Float32Array)return n;const t=ol(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}const gl=class gl{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Ge(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Ge(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*i-a*s+e.x,this.y=r*s+a*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};gl.prototype.isVector2=!0;let Xe=gl;class Xi{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,a,o){let l=i[s+0],c=i[s+1],u=i[s+2],p=i[s+3],h=r[a+0],d=r[a+1],_=r[a+2],v=r[a+3];if(p!==v||l!==h||c!==d||u!==_){let m=l*h+c*d+u*_+p*v;m<0&&(h=-h,d=-d,_=-_,v=-v,m=-m);let f=1-o;if(m<.9995){const x=Math.acos(m),w=Math.sin(x);f=Math.sin(f*x)/w,o=Math.sin(o*x)/w,l=l*f+h*o,c=c*f+d*o,u=u*f+_*o,p=p*f+v*o}else{l=l*f+h*o,c=c*f+d*o,u=u*f+_*o,p=p*f+v*o;const x=1/Math.sqrt(l*l+c*c+u*u+p*p);l*=x,c*=x,u*=x,p*=x}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=p}static multiplyQuaternionsFlat(e,t,i,s,r,a){const o=i[s],l=i[s+1],c=i[s+2],u=i[s+3],p=r[a],h=r[a+1],d=r[a+2],_=r[a+3];return e[t]=o*_+u*p+l*d-c*h,e[t+1]=l*_+u*h+c*p-o*d,e[t+2]=c*_+u*d+o*h-l*p,e[t+3]=u*_-o*p-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(i/2),u=o(s/2),p=o(r/2),h=l(i/2),d=l(s/2),_=l(r/2);switch(a){case"XYZ":this._x=h*u*p+c*d*_,this._y=c*d*p-h*u*_,this._z=c*u*_+h*d*p,this._w=c*u*p-h*d*_;break;case"YXZ":this._x=h*u*p+c*d*_,this._y=c*d*p-h*u*_,this._z=c*u*_-h*d*p,this._w=c*u*p+h*d*_;break;case"ZXY":this._x=h*u*p-c*d*_,this._y=c*d*p+h*u*_,this._z=c*u*_+h*d*p,this._w=c*u*p-h*d*_;break;case"ZYX":this._x=h*u*p-c*d*_,this._y=c*d*p+h*u*_,this._z=c*u*_-h*d*p,this._w=c*u*p+h*d*_;break;case"YZX":this._x=h*u*p+c*d*_,this._y=c*d*p+h*u*_,this._z=c*u*_-h*d*p,this._w=c*u*p-h*d*_;break;case"XZY":this._x=h*u*p-c*d*_,this._y=c*d*p-h*u*_,this._z=c*u*_+h*d*p,this._w=c*u*p+h*d*_;break;default:Pe("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],u=t[6],p=t[10],h=i+o+p;if(h>0){const d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(a-s)*d}else if(i>o&&i>p){const d=2*Math.sqrt(1+i-o-p);this._w=(u-l)/d,this._x=.25*d,this._y=(s+a)/d,this._z=(r+c)/d}else if(o>p){const d=2*Math.sqrt(1+o-i-p);this._w=(r-c)/d,this._x=(s+a)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+p-i-o);this._w=(a-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ge(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+a*o+s*c-r*l,this._y=s*u+a*l+r*o-i*c,this._z=r*u+a*c+i*l-s*o,this._w=a*u-i*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(i=-i,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){const c=Math.acos(o),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}const _l=class _l{constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(lc.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(lc.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(e){const t=this.x,i=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*i),u=2*(o*t-r*s),p=2*(r*i-a*t);return this.x=t+l*c+a*p-o*u,this.y=i+l*u+o*c-r*p,this.z=s+l*p+r*u-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Ge(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-i*l,this.z=i*o-s*a,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return aa.copy(this).projectOnVector(e),this.sub(aa)}reflect(e){return this.sub(aa.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Ge(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};_l.prototype.isVector3=!0;let V=_l;const aa=new V,lc=new Xi,vl=class vl{constructor(e,t,i,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c)}set(e,t,i,s,r,a,o,l,c){const u=this.elements;return u[0]=e,u[1]=s,u[2]=o,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=a,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[3],l=i[6],c=i[1],u=i[4],p=i[7],h=i[2],d=i[5],_=i[8],v=s[0],m=s[3],f=s[6],x=s[1],w=s[4],M=s[7],T=s[2],R=s[5],g=s[8];return r[0]=a*v+o*x+l*T,r[3]=a*m+o*w+l*R,r[6]=a*f+o*M+l*g,r[1]=c*v+u*x+p*T,r[4]=c*m+u*w+p*R,r[7]=c*f+u*M+p*g,r[2]=h*v+d*x+_*T,r[5]=h*m+d*w+_*R,r[8]=h*f+d*M+_*g,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8];return t*a*u-t*o*c-i*r*u+i*o*l+s*r*c-s*a*l}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],p=u*a-o*c,h=o*l-u*r,d=c*r-a*l,_=t*p+i*h+s*d;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/_;return e[0]=p*v,e[1]=(s*c-u*i)*v,e[2]=(o*i-s*a)*v,e[3]=h*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-o*t)*v,e[6]=d*v,e[7]=(i*l-c*t)*v,e[8]=(a*t-i*r)*v,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,a,o){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return ar("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(oa.makeScale(e,t)),this}rotate(e){return ar("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(oa.makeRotation(-e)),this}translate(e,t){return ar("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(oa.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}};vl.prototype.isMatrix3=!0;let De=vl;const oa=new De,cc=new De().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),uc=new De().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Mp(){const n={enabled:!0,workingColorSpace:hs,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Je&&(s.r=Nn(s.r),s.g=Nn(s.g),s.b=Nn(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Je&&(s.r=Ui(s.r),s.g=Ui(s.g),s.b=Ui(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Kn?Mr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[hs]:{primaries:e,whitePoint:i,transfer:Mr,toXYZ:cc,fromXYZ:uc,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:jt},outputColorSpaceConfig:{drawingBufferColorSpace:jt}},[jt]:{primaries:e,whitePoint:i,transfer:Je,toXYZ:cc,fromXYZ:uc,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:jt}}}),n}const Ve=Mp();function Nn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ui(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}let Mi;class yp{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Mi===void 0&&(Mi=Er("canvas")),Mi.width=e.width,Mi.height=e.height;const s=Mi.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Mi}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=Er("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Nn(r[a]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Nn(t[i]/255)*255):t[i]=Nn(t[i]);return{data:t,width:e.width,height:e.height}}else return Pe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let Ep=0;class ll{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ep++}),this.uuid=ps(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(la(s[a].image)):r.push(la(s[a]))}else r=la(s);i.url=r}return t||(e.images[this.uuid]=i),i}}function la(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?yp.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Pe("Texture: Unable to serialize Texture."),{})}let bp=0;const ca=new V;class Bt extends Si{constructor(e=Bt.DEFAULT_IMAGE,t=Bt.DEFAULT_MAPPING,i=xn,s=xn,r=Ct,a=Jn,o=tn,l=en,c=Bt.DEFAULT_ANISOTROPY,u=Kn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:bp++}),this.uuid=ps(),this.name="",this.source=new ll(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Xe(0,0),this.repeat=new Xe(1,1),this.center=new Xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new De,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ca).x}get height(){return this.source.getSize(ca).y}get depth(){return this.source.getSize(ca).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const i=e[t];if(i===void 0){Pe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){Pe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Th)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case vr:e.x=e.x-Math.floor(e.x);break;case xn:e.x=e.x<0?0:1;break;case qa:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case vr:e.y=e.y-Math.floor(e.y);break;case xn:e.y=e.y<0?0:1;break;case qa:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}Bt.DEFAULT_IMAGE=null;Bt.DEFAULT_MAPPING=Th;Bt.DEFAULT_ANISOTROPY=1;const xl=class xl{constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*i+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r;const l=e.elements,c=l[0],u=l[4],p=l[8],h=l[1],d=l[5],_=l[9],v=l[2],m=l[6],f=l[10];if(Math.abs(u-h)<.01&&Math.abs(p-v)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(p+v)<.1&&Math.abs(_+m)<.1&&Math.abs(c+d+f-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const w=(c+1)/2,M=(d+1)/2,T=(f+1)/2,R=(u+h)/4,g=(p+v)/4,E=(_+m)/4;return w>M&&w>T?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=R/i,r=g/i):M>T?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=R/s,r=E/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=g/r,s=E/r),this.set(i,s,r,t),this}let x=Math.sqrt((m-_)*(m-_)+(p-v)*(p-v)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(m-_)/x,this.y=(p-v)/x,this.z=(h-u)/x,this.w=Math.acos((c+d+f-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ge(this.x,e.x,t.x),this.y=Ge(this.y,e.y,t.y),this.z=Ge(this.z,e.z,t.z),this.w=Ge(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ge(this.x,e,t),this.y=Ge(this.y,e,t),this.z=Ge(this.z,e,t),this.w=Ge(this.w,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Ge(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};xl.prototype.isVector4=!0;let lt=xl;class wp extends Si{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ct,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new lt(0,0,e,t),this.scissorTest=!1,this.viewport=new lt(0,0,e,t),this.textures=[];const s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Bt({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){const t={minFilter:Ct,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const s=Object.assign({},e.textures[t].image);this.textures[t].source=new ll(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){const t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}}class dn extends wp{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class Oh extends Bt{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_t,this.minFilter=_t,this.wrapR=xn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class Ao extends Bt{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_t,this.minFilter=_t,this.wrapR=xn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}}const Lr=class Lr{constructor(e,t,i,s,r,a,o,l,c,u,p,h,d,_,v,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,l,c,u,p,h,d,_,v,m)}set(e,t,i,s,r,a,o,l,c,u,p,h,d,_,v,m){const f=this.elements;return f[0]=e,f[4]=t,f[8]=i,f[12]=s,f[1]=r,f[5]=a,f[9]=o,f[13]=l,f[2]=c,f[6]=u,f[10]=p,f[14]=h,f[3]=d,f[7]=_,f[11]=v,f[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Lr().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();const t=this.elements,i=e.elements,s=1/yi.setFromMatrixColumn(e,0).length(),r=1/yi.setFromMatrixColumn(e,1).length(),a=1/yi.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*a,t[9]=i[9]*a,t[10]=i[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,s=e.y,r=e.z,a=Math.cos(i),o=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),p=Math.sin(r);if(e.order==="XYZ"){const h=a*u,d=a*p,_=o*u,v=o*p;t[0]=l*u,t[4]=-l*p,t[8]=c,t[1]=d+_*c,t[5]=h-v*c,t[9]=-o*l,t[2]=v-h*c,t[6]=_+d*c,t[10]=a*l}else if(e.order==="YXZ"){const h=l*u,d=l*p,_=c*u,v=c*p;t[0]=h+v*o,t[4]=_*o-d,t[8]=a*c,t[1]=a*p,t[5]=a*u,t[9]=-o,t[2]=d*o-_,t[6]=v+h*o,t[10]=a*l}else if(e.order==="ZXY"){const h=l*u,d=l*p,_=c*u,v=c*p;t[0]=h-v*o,t[4]=-a*p,t[8]=_+d*o,t[1]=d+_*o,t[5]=a*u,t[9]=v-h*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){const h=a*u,d=a*p,_=o*u,v=o*p;t[0]=l*u,t[4]=_*c-d,t[8]=h*c+v,t[1]=l*p,t[5]=v*c+h,t[9]=d*c-_,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){const h=a*l,d=a*c,_=o*l,v=o*c;t[0]=l*u,t[4]=v-h*p,t[8]=_*p+d,t[1]=p,t[5]=a*u,t[9]=-o*u,t[2]=-c*u,t[6]=d*p+_,t[10]=h-v*p}else if(e.order==="XZY"){const h=a*l,d=a*c,_=o*l,v=o*c;t[0]=l*u,t[4]=-p,t[8]=c*u,t[1]=h*p+v,t[5]=a*u,t[9]=d*p-_,t[2]=_*p-d,t[6]=o*u,t[10]=v*p+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Tp,e,Ap)}lookAt(e,t,i){const s=this.elements;return Wt.subVectors(e,t),Wt.lengthSq()===0&&(Wt.z=1),Wt.normalize(),Hn.crossVectors(i,Wt),Hn.lengthSq()===0&&(Math.abs(i.z)===1?Wt.x+=1e-4:Wt.z+=1e-4,Wt.normalize(),Hn.crossVectors(i,Wt)),Hn.normalize(),bs.crossVectors(Wt,Hn),s[0]=Hn.x,s[4]=bs.x,s[8]=Wt.x,s[1]=Hn.y,s[5]=bs.y,s[9]=Wt.y,s[2]=Hn.z,s[6]=bs.z,s[10]=Wt.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[4],l=i[8],c=i[12],u=i[1],p=i[5],h=i[9],d=i[13],_=i[2],v=i[6],m=i[10],f=i[14],x=i[3],w=i[7],M=i[11],T=i[15],R=s[0],g=s[4],E=s[8],N=s[12],C=s[1],L=s[5],H=s[9],W=s[13],I=s[2],F=s[6],K=s[10],k=s[14],te=s[3],X=s[7],j=s[11],ee=s[15];return r[0]=a*R+o*C+l*I+c*te,r[4]=a*g+o*L+l*F+c*X,r[8]=a*E+o*H+l*K+c*j,r[12]=a*N+o*W+l*k+c*ee,r[1]=u*R+p*C+h*I+d*te,r[5]=u*g+p*L+h*F+d*X,r[9]=u*E+p*H+h*K+d*j,r[13]=u*N+p*W+h*k+d*ee,r[2]=_*R+v*C+m*I+f*te,r[6]=_*g+v*L+m*F+f*X,r[10]=_*E+v*H+m*K+f*j,r[14]=_*N+v*W+m*k+f*ee,r[3]=x*R+w*C+M*I+T*te,r[7]=x*g+w*L+M*F+T*X,r[11]=x*E+w*H+M*K+T*j,r[15]=x*N+w*W+M*k+T*ee,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],u=e[2],p=e[6],h=e[10],d=e[14],_=e[3],v=e[7],m=e[11],f=e[15],x=l*d-c*h,w=o*d-c*p,M=o*h-l*p,T=a*d-c*u,R=a*h-l*u,g=a*p-o*u;return t*(v*x-m*w+f*M)-i*(_*x-m*T+f*R)+s*(_*w-v*T+f*g)-r*(_*M-v*R+m*g)}determinantAffine(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],u=e[10];return t*(a*u-o*c)-i*(r*u-o*l)+s*(r*c-a*l)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],p=e[9],h=e[10],d=e[11],_=e[12],v=e[13],m=e[14],f=e[15],x=t*o-i*a,w=t*l-s*a,M=t*c-r*a,T=i*l-s*o,R=i*c-r*o,g=s*c-r*l,E=u*v-p*_,N=u*m-h*_,C=u*f-d*_,L=p*m-h*v,H=p*f-d*v,W=h*f-d*m,I=x*W-w*H+M*L+T*C-R*N+g*E;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const F=1/I;return e[0]=(o*W-l*H+c*L)*F,e[1]=(s*H-i*W-r*L)*F,e[2]=(v*g-m*R+f*T)*F,e[3]=(h*R-p*g-d*T)*F,e[4]=(l*C-a*W-c*N)*F,e[5]=(t*W-s*C+r*N)*F,e[6]=(m*M-_*g-f*w)*F,e[7]=(u*g-h*M+d*w)*F,e[8]=(a*H-o*C+c*E)*F,e[9]=(i*C-t*H-r*E)*F,e[10]=(_*R-v*M+f*x)*F,e[11]=(p*M-u*R-d*x)*F,e[12]=(o*N-a*L-l*E)*F,e[13]=(t*L-i*N+s*E)*F,e[14]=(v*w-_*T-m*x)*F,e[15]=(u*T-p*w+h*x)*F,this}scale(e){const t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),s=Math.sin(t),r=1-i,a=e.x,o=e.y,l=e.z,c=r*a,u=r*o;return this.set(c*a+i,c*o-s*l,c*l+s*o,0,c*o+s*l,u*o+i,u*l-s*a,0,c*l-s*o,u*l+s*a,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,a){return this.set(1,i,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){const s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,u=a+a,p=o+o,h=r*c,d=r*u,_=r*p,v=a*u,m=a*p,f=o*p,x=l*c,w=l*u,M=l*p,T=i.x,R=i.y,g=i.z;return s[0]=(1-(v+f))*T,s[1]=(d+M)*T,s[2]=(_-w)*T,s[3]=0,s[4]=(d-M)*R,s[5]=(1-(h+f))*R,s[6]=(m+x)*R,s[7]=0,s[8]=(_+w)*g,s[9]=(m-x)*g,s[10]=(1-(h+v))*g,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){const s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];const r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let a=yi.set(s[0],s[1],s[2]).length();const o=yi.set(s[4],s[5],s[6]).length(),l=yi.set(s[8],s[9],s[10]).length();r<0&&(a=-a),an.copy(this);const c=1/a,u=1/o,p=1/l;return an.elements[0]*=c,an.elements[1]*=c,an.elements[2]*=c,an.elements[4]*=u,an.elements[5]*=u,an.elements[6]*=u,an.elements[8]*=p,an.elements[9]*=p,an.elements[10]*=p,t.setFromRotationMatrix(an),i.x=a,i.y=o,i.z=l,this}makePerspective(e,t,i,s,r,a,o=hn,l=!1){const c=this.elements,u=2*r/(t-e),p=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s);let _,v;if(l)_=r/(a-r),v=a*r/(a-r);else if(o===hn)_=-(a+r)/(a-r),v=-2*a*r/(a-r);else if(o===yr)_=-a/(a-r),v=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=p,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,a,o=hn,l=!1){const c=this.elements,u=2/(t-e),p=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s);let _,v;if(l)_=1/(a-r),v=a/(a-r);else if(o===hn)_=-2/(a-r),v=-(a+r)/(a-r);else if(o===yr)_=-1/(a-r),v=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=p,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}};Lr.prototype.isMatrix4=!0;let ft=Lr;const yi=new V,an=new ft,Tp=new V(0,0,0),Ap=new V(1,1,1),Hn=new V,bs=new V,Wt=new V,hc=new ft,dc=new Xi;class vi{constructor(e=0,t=0,i=0,s=vi.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],u=s[9],p=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(Ge(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ge(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(o,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-p,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ge(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-p,d),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ge(p,-1,1)),Math.abs(p)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(Ge(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-p,r)):(this._x=0,this._y=Math.atan2(o,d));break;case"XZY":this._z=Math.asin(-Ge(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Pe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return hc.makeRotationFromQuaternion(e),this.setFromRotationMatrix(hc,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return dc.setFromEuler(this),this.setFromQuaternion(dc,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}vi.DEFAULT_ORDER="XYZ";class Bh{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let Rp=0;const fc=new V,Ei=new Xi,wn=new ft,ws=new V,Ki=new V,Cp=new V,Pp=new Xi,pc=new V(1,0,0),mc=new V(0,1,0),gc=new V(0,0,1),_c={type:"added"},Lp={type:"removed"},bi={type:"childadded",child:null},ua={type:"childremoved",child:null};class qt extends Si{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Rp++}),this.uuid=ps(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=qt.DEFAULT_UP.clone();const e=new V,t=new vi,i=new Xi,s=new V(1,1,1);function r(){i.setFromEuler(t,!1)}function a(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ft},normalMatrix:{value:new De}}),this.matrix=new ft,this.matrixWorld=new ft,this.matrixAutoUpdate=qt.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Bh,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ei.setFromAxisAngle(e,t),this.quaternion.multiply(Ei),this}rotateOnWorldAxis(e,t){return Ei.setFromAxisAngle(e,t),this.quaternion.premultiply(Ei),this}rotateX(e){return this.rotateOnAxis(pc,e)}rotateY(e){return this.rotateOnAxis(mc,e)}rotateZ(e){return this.rotateOnAxis(gc,e)}translateOnAxis(e,t){return fc.copy(e).applyQuaternion(this.quaternion),this.position.add(fc.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(pc,e)}translateY(e){return this.translateOnAxis(mc,e)}translateZ(e){return this.translateOnAxis(gc,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(wn.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ws.copy(e):ws.set(e,t,i);const s=this.parent;this.updateWorldMatrix(!0,!1),Ki.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?wn.lookAt(Ki,ws,this.up):wn.lookAt(ws,Ki,this.up),this.quaternion.setFromRotationMatrix(wn),s&&(wn.extractRotation(s.matrixWorld),Ei.setFromRotationMatrix(wn),this.quaternion.premultiply(Ei.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(_c),bi.child=e,this.dispatchEvent(bi),bi.child=null):qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Lp),ua.child=e,this.dispatchEvent(ua),ua.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),wn.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),wn.multiply(e.parent.matrixWorld)),e.applyMatrix4(wn),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(_c),bi.child=e,this.dispatchEvent(bi),bi.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){const a=this.children[i].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,e,Cp),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ki,Pp,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const e=this.pivot;if(e!==null){const t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){const s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){const r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,i)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const l=o.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const p=l[c];r(e.shapes,p)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){const l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){const o=a(e.geometries),l=a(e.materials),c=a(e.textures),u=a(e.images),p=a(e.shapes),h=a(e.skeletons),d=a(e.animations),_=a(e.nodes);o.length>0&&(i.geometries=o),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),p.length>0&&(i.shapes=p),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),_.length>0&&(i.nodes=_)}return i.object=s,i;function a(o){const l=[];for(const c in o){const u=o[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}}qt.DEFAULT_UP=new V(0,1,0);qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class Ts extends qt{constructor(){super(),this.isGroup=!0,this.type="Group"}}const Dp={type:"move"};class ha{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ts,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ts,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ts,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,a=null;const o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(const v of e.hand.values()){const m=t.getJointPose(v,i),f=this._getHandJoint(c,v);m!==null&&(f.matrix.fromArray(m.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=m.radius),f.visible=m!==null}const u=c.joints["index-finger-tip"],p=c.joints["thumb-tip"],h=u.position.distanceTo(p.position),d=.02,_=.005;c.inputState.pinching&&h>d+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Dp)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new Ts;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}const kh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Gn={h:0,s:0,l:0},As={h:0,s:0,l:0};function da(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Ye{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=jt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ve.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Ve.workingColorSpace){return this.r=e,this.g=t,this.b=i,Ve.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Ve.workingColorSpace){if(e=_p(e,1),t=Ge(t,0,1),i=Ge(i,0,1),t===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+t):i+t-i*t,a=2*i-r;this.r=da(a,r,e+1/3),this.g=da(a,r,e),this.b=da(a,r,e-1/3)}return Ve.colorSpaceToWorking(this,s),this}setStyle(e,t=jt){function i(r){r!==void 0&&parseFloat(r)<1&&Pe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Pe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Pe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=jt){const i=kh[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Pe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Nn(e.r),this.g=Nn(e.g),this.b=Nn(e.b),this}copyLinearToSRGB(e){return this.r=Ui(e.r),this.g=Ui(e.g),this.b=Ui(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=jt){return Ve.workingToColorSpace(It.copy(this),e),Math.round(Ge(It.r*255,0,255))*65536+Math.round(Ge(It.g*255,0,255))*256+Math.round(Ge(It.b*255,0,255))}getHexString(e=jt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ve.workingColorSpace){Ve.workingToColorSpace(It.copy(this),t);const i=It.r,s=It.g,r=It.b,a=Math.max(i,s,r),o=Math.min(i,s,r);let l,c;const u=(o+a)/2;if(o===a)l=0,c=0;else{const p=a-o;switch(c=u<=.5?p/(a+o):p/(2-a-o),a){case i:l=(s-r)/p+(s<r?6:0);break;case s:l=(r-i)/p+2;break;case r:l=(i-s)/p+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Ve.workingColorSpace){return Ve.workingToColorSpace(It.copy(this),t),e.r=It.r,e.g=It.g,e.b=It.b,e}getStyle(e=jt){Ve.workingToColorSpace(It.copy(this),e);const t=It.r,i=It.g,s=It.b;return e!==jt?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Gn),this.setHSL(Gn.h+e,Gn.s+t,Gn.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Gn),e.getHSL(As);const i=ra(Gn.h,As.h,t),s=ra(Gn.s,As.s,t),r=ra(Gn.l,As.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const It=new Ye;Ye.NAMES=kh;class Ip extends qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new vi,this.environmentIntensity=1,this.environmentRotation=new vi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}}const on=new V,Tn=new V,fa=new V,An=new V,wi=new V,Ti=new V,vc=new V,pa=new V,ma=new V,ga=new V,_a=new lt,va=new lt,xa=new lt;class un{constructor(e=new V,t=new V,i=new V){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),on.subVectors(e,t),s.cross(on);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){on.subVectors(s,t),Tn.subVectors(i,t),fa.subVectors(e,t);const a=on.dot(on),o=on.dot(Tn),l=on.dot(fa),c=Tn.dot(Tn),u=Tn.dot(fa),p=a*c-o*o;if(p===0)return r.set(0,0,0),null;const h=1/p,d=(c*l-o*u)*h,_=(a*u-o*l)*h;return r.set(1-d-_,_,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,An)===null?!1:An.x>=0&&An.y>=0&&An.x+An.y<=1}static getInterpolation(e,t,i,s,r,a,o,l){return this.getBarycoord(e,t,i,s,An)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,An.x),l.addScaledVector(a,An.y),l.addScaledVector(o,An.z),l)}static getInterpolatedAttribute(e,t,i,s,r,a){return _a.setScalar(0),va.setScalar(0),xa.setScalar(0),_a.fromBufferAttribute(e,t),va.fromBufferAttribute(e,i),xa.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(_a,r.x),a.addScaledVector(va,r.y),a.addScaledVector(xa,r.z),a}static isFrontFacing(e,t,i,s){return on.subVectors(i,t),Tn.subVectors(e,t),on.cross(Tn).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return on.subVectors(this.c,this.b),Tn.subVectors(this.a,this.b),on.cross(Tn).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return un.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return un.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return un.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return un.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return un.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,s=this.b,r=this.c;let a,o;wi.subVectors(s,i),Ti.subVectors(r,i),pa.subVectors(e,i);const l=wi.dot(pa),c=Ti.dot(pa);if(l<=0&&c<=0)return t.copy(i);ma.subVectors(e,s);const u=wi.dot(ma),p=Ti.dot(ma);if(u>=0&&p<=u)return t.copy(s);const h=l*p-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return a=l/(l-u),t.copy(i).addScaledVector(wi,a);ga.subVectors(e,r);const d=wi.dot(ga),_=Ti.dot(ga);if(_>=0&&d<=_)return t.copy(r);const v=d*c-l*_;if(v<=0&&c>=0&&_<=0)return o=c/(c-_),t.copy(i).addScaledVector(Ti,o);const m=u*_-d*p;if(m<=0&&p-u>=0&&d-_>=0)return vc.subVectors(r,s),o=(p-u)/(p-u+(d-_)),t.copy(s).addScaledVector(vc,o);const f=1/(m+v+h);return a=v*f,o=h*f,t.copy(i).addScaledVector(wi,a).addScaledVector(Ti,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}class ms{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(ln.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(ln.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=ln.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,ln):ln.fromBufferAttribute(r,a),ln.applyMatrix4(e.matrixWorld),this.expandByPoint(ln);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Rs.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Rs.copy(i.boundingBox)),Rs.applyMatrix4(e.matrixWorld),this.union(Rs)}const s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ln),ln.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Zi),Cs.subVectors(this.max,Zi),Ai.subVectors(e.a,Zi),Ri.subVectors(e.b,Zi),Ci.subVectors(e.c,Zi),Vn.subVectors(Ri,Ai),Wn.subVectors(Ci,Ri),ai.subVectors(Ai,Ci);let t=[0,-Vn.z,Vn.y,0,-Wn.z,Wn.y,0,-ai.z,ai.y,Vn.z,0,-Vn.x,Wn.z,0,-Wn.x,ai.z,0,-ai.x,-Vn.y,Vn.x,0,-Wn.y,Wn.x,0,-ai.y,ai.x,0];return!Sa(t,Ai,Ri,Ci,Cs)||(t=[1,0,0,0,1,0,0,0,1],!Sa(t,Ai,Ri,Ci,Cs))?!1:(Ps.crossVectors(Vn,Wn),t=[Ps.x,Ps.y,Ps.z],Sa(t,Ai,Ri,Ci,Cs))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ln).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ln).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Rn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Rn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Rn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Rn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Rn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Rn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Rn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Rn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Rn),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const Rn=[new V,new V,new V,new V,new V,new V,new V,new V],ln=new V,Rs=new ms,Ai=new V,Ri=new V,Ci=new V,Vn=new V,Wn=new V,ai=new V,Zi=new V,Cs=new V,Ps=new V,oi=new V;function Sa(n,e,t,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){oi.fromArray(n,r);const o=s.x*Math.abs(oi.x)+s.y*Math.abs(oi.y)+s.z*Math.abs(oi.z),l=e.dot(oi),c=t.dot(oi),u=i.dot(oi);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>o)return!1}return!0}const Ln=Np();function Np(){const n=new ArrayBuffer(4),e=new Float32Array(n),t=new Uint32Array(n),i=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){const c=l-127;c<-27?(i[l]=0,i[l|256]=32768,s[l]=24,s[l|256]=24):c<-14?(i[l]=1024>>-c-14,i[l|256]=1024>>-c-14|32768,s[l]=-c-1,s[l|256]=-c-1):c<=15?(i[l]=c+15<<10,i[l|256]=c+15<<10|32768,s[l]=13,s[l|256]=13):c<128?(i[l]=31744,i[l|256]=64512,s[l]=24,s[l|256]=24):(i[l]=31744,i[l|256]=64512,s[l]=13,s[l|256]=13)}const r=new Uint32Array(2048),a=new Uint32Array(64),o=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,u=0;for(;(c&8388608)===0;)c<<=1,u-=8388608;c&=-8388609,u+=947912704,r[l]=c|u}for(let l=1024;l<2048;++l)r[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)a[l]=l<<23;a[31]=1199570944,a[32]=2147483648;for(let l=33;l<63;++l)a[l]=2147483648+(l-32<<23);a[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(o[l]=1024);return{floatView:e,uint32View:t,baseTable:i,shiftTable:s,mantissaTable:r,exponentTable:a,offsetTable:o}}function Up(n){Math.abs(n)>65504&&Pe("DataUtils.toHalfFloat(): Value out of range."),n=Ge(n,-65504,65504),Ln.floatView[0]=n;const e=Ln.uint32View[0],t=e>>23&511;return Ln.baseTable[t]+((e&8388607)>>Ln.shiftTable[t])}function Fp(n){const e=n>>10;return Ln.uint32View[0]=Ln.mantissaTable[Ln.offsetTable[e]+(n&1023)]+Ln.exponentTable[e],Ln.floatView[0]}class Op{static toHalfFloat(e){return Up(e)}static fromHalfFloat(e){return Fp(e)}}const gt=new V,Ls=new Xe;let Bp=0;class yn extends Si{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Bp++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=dp,this.updateRanges=[],this.gpuType=Ot,this.version=0,this._normalizationScale=e!==void 0?ol(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Ls.fromBufferAttribute(this,t),Ls.applyMatrix3(e),this.setXY(t,Ls.x,Ls.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.applyMatrix3(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.applyMatrix4(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.applyNormalMatrix(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)gt.fromBufferAttribute(this,t),gt.transformDirection(e),this.setXYZ(t,gt.x,gt.y,gt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){const t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):xp(e,this.array)}_normalize(e){const t=this._normalizationScale;return t!==void 0?Math.round(e*t):Sp(e,this.array)}}class zh extends yn{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class Hh extends yn{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class Un extends yn{constructor(e,t,i){super(new Float32Array(e),t,i)}}const kp=new ms,Ji=new V,Ma=new V;class cl{constructor(e=new V,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):kp.setFromPoints(e).getCenter(i);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ji.subVectors(e,this.center);const t=Ji.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Ji,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ma.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ji.copy(e.center).add(Ma)),this.expandByPoint(Ji.copy(e.center).sub(Ma))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}let zp=0;const Qt=new ft,ya=new qt,Pi=new V,Xt=new ms,Qi=new ms,wt=new V;class Bn extends Si{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:zp++}),this.uuid=ps(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(fp(e)?Hh:zh)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new De().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Qt.makeRotationFromQuaternion(e),this.applyMatrix4(Qt),this}rotateX(e){return Qt.makeRotationX(e),this.applyMatrix4(Qt),this}rotateY(e){return Qt.makeRotationY(e),this.applyMatrix4(Qt),this}rotateZ(e){return Qt.makeRotationZ(e),this.applyMatrix4(Qt),this}translate(e,t,i){return Qt.makeTranslation(e,t,i),this.applyMatrix4(Qt),this}scale(e,t,i){return Qt.makeScale(e,t,i),this.applyMatrix4(Qt),this}lookAt(e){return ya.lookAt(e),ya.updateMatrix(),this.applyMatrix4(ya.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Pi).negate(),this.translate(Pi.x,Pi.y,Pi.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let s=0,r=e.length;s<r;s++){const a=e[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Un(i,3))}else{const i=Math.min(e.length,t.count);for(let s=0;s<i;s++){const r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Pe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ms);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){const r=t[i];Xt.setFromBufferAttribute(r),this.morphTargetsRelative?(wt.addVectors(this.boundingBox.min,Xt.min),this.boundingBox.expandByPoint(wt),wt.addVectors(this.boundingBox.max,Xt.max),this.boundingBox.expandByPoint(wt)):(this.boundingBox.expandByPoint(Xt.min),this.boundingBox.expandByPoint(Xt.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new cl);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){const i=this.boundingSphere.center;if(Xt.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){const o=t[r];Qi.setFromBufferAttribute(o),this.morphTargetsRelative?(wt.addVectors(Xt.min,Qi.min),Xt.expandByPoint(wt),wt.addVectors(Xt.max,Qi.max),Xt.expandByPoint(wt)):(Xt.expandByPoint(Qi.min),Xt.expandByPoint(Qi.max))}Xt.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)wt.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(wt));if(t)for(let r=0,a=t.length;r<a;r++){const o=t[r],l=this.morphTargetsRelative;for(let c=0,u=o.count;c<u;c++)wt.fromBufferAttribute(o,c),l&&(Pi.fromBufferAttribute(e,c),wt.add(Pi)),s=Math.max(s,i.distanceToSquared(wt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,s=t.normal,r=t.uv;let a=this.getAttribute("tangent");(a===void 0||a.count!==i.count)&&(a=new yn(new Float32Array(4*i.count),4),this.setAttribute("tangent",a));const o=[],l=[],c=new Uint8Array(i.count);for(let N=0;N<i.count;N++)o[N]=new V,l[N]=new V;const u=new V,p=new V,h=new V,d=new Xe,_=new Xe,v=new Xe,m=new V,f=new V;function x(N,C,L){c[N]=c[C]=c[L]=1,u.fromBufferAttribute(i,N),p.fromBufferAttribute(i,C),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,N),_.fromBufferAttribute(r,C),v.fromBufferAttribute(r,L),p.sub(u),h.sub(u),_.sub(d),v.sub(d);const H=1/(_.x*v.y-v.x*_.y);isFinite(H)&&(m.copy(p).multiplyScalar(v.y).addScaledVector(h,-_.y).multiplyScalar(H),f.copy(h).multiplyScalar(_.x).addScaledVector(p,-v.x).multiplyScalar(H),o[N].add(m),o[C].add(m),o[L].add(m),l[N].add(f),l[C].add(f),l[L].add(f))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let N=0,C=w.length;N<C;++N){const L=w[N],H=L.start,W=L.count;for(let I=H,F=H+W;I<F;I+=3)x(e.getX(I+0),e.getX(I+1),e.getX(I+2))}const M=new V,T=new V,R=new V,g=new V;function E(N){R.fromBufferAttribute(s,N),g.copy(R);const C=o[N];M.copy(C),M.sub(R.multiplyScalar(R.dot(C))).normalize(),T.crossVectors(g,C);const H=T.dot(l[N])<0?-1:1;a.setXYZW(N,M.x,M.y,M.z,H)}for(let N=0,C=i.count;N<C;++N)c[N]&&E(N);this._transformed=!0}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new yn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);const s=new V,r=new V,a=new V,o=new V,l=new V,c=new V,u=new V,p=new V;if(e)for(let h=0,d=e.count;h<d;h+=3){const _=e.getX(h+0),v=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,v),a.fromBufferAttribute(t,m),u.subVectors(a,r),p.subVectors(s,r),u.cross(p),o.fromBufferAttribute(i,_),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),o.add(u),l.add(u),c.add(u),i.setXYZ(_,o.x,o.y,o.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),a.fromBufferAttribute(t,h+2),u.subVectors(a,r),p.subVectors(s,r),u.cross(p),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)wt.fromBufferAttribute(e,t),wt.normalize(),e.setXYZ(t,wt.x,wt.y,wt.z)}toNonIndexed(){function e(o,l){const c=o.array,u=o.itemSize,p=o.normalized,h=new c.constructor(l.length*u);let d=0,_=0;for(let v=0,m=l.length;v<m;v++){o.isInterleavedBufferAttribute?d=l[v]*o.data.stride+o.offset:d=l[v]*u;for(let f=0;f<u;f++)h[_++]=c[d++]}return new yn(h,u,p)}if(this.index===null)return Pe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new Bn,i=this.index.array,s=this.attributes;for(const o in s){const l=s[o],c=e(l,i);t.setAttribute(o,c)}const r=this.morphAttributes;for(const o in r){const l=[],c=r[o];for(let u=0,p=c.length;u<p;u++){const h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let o=0,l=a.length;o<l;o++){const c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const l in i){const c=i[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let p=0,h=c.length;p<h;p++){const d=c[p];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));const o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone());const s=e.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(t))}const r=e.morphAttributes;for(const c in r){const u=[],p=r[c];for(let h=0,d=p.length;h<d;h++)u.push(p[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;const a=e.groups;for(let c=0,u=a.length;c<u;c++){const p=a[c];this.addGroup(p.start,p.count,p.materialIndex)}const o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Ea=new V,Hp=new V,Gp=new De;class qn{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const s=Ea.subVectors(i,t).cross(Hp.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){const s=e.delta(Ea),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const a=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||Gp.getNormalMatrix(e),s=this.coplanarPoint(Ea).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}}let Vp=0;class zr extends Si{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vp++}),this.uuid=ps(),this.name="",this.type="Material",this.blending=rs,this.side=gi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=gh,this.blendDst=_h,this.blendEquation=Ii,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ye(0,0,0),this.blendAlpha=0,this.depthFunc=ls,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ap,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ia,this.stencilZFail=ia,this.stencilZPass=ia,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){Pe(`Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){Pe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const a=[];for(const o in r){const l=r[o];delete l.metadata,a.push(l)}return a}if(t){const r=s(e.textures),a=s(e.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ye().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new qn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Xe().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}const Cn=new V,ba=new V,Ds=new V,Is=new V;class Wp{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Cn)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Cn.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Cn.copy(this.origin).addScaledVector(this.direction,t),Cn.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){ba.copy(e).add(t).multiplyScalar(.5),Ds.copy(t).sub(e).normalize(),Is.copy(this.origin).sub(ba);const r=e.distanceTo(t)*.5,a=-this.direction.dot(Ds),o=Is.dot(this.direction),l=-Is.dot(Ds),c=Is.lengthSq(),u=Math.abs(1-a*a);let p,h,d,_;if(u>0)if(p=a*l-o,h=a*o-l,_=r*u,p>=0)if(h>=-_)if(h<=_){const v=1/u;p*=v,h*=v,d=p*(p+a*h+2*o)+h*(a*p+h+2*l)+c}else h=r,p=Math.max(0,-(a*h+o)),d=-p*p+h*(h+2*l)+c;else h=-r,p=Math.max(0,-(a*h+o)),d=-p*p+h*(h+2*l)+c;else h<=-_?(p=Math.max(0,-(-a*r+o)),h=p>0?-r:Math.min(Math.max(-r,-l),r),d=-p*p+h*(h+2*l)+c):h<=_?(p=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(p=Math.max(0,-(a*r+o)),h=p>0?r:Math.min(Math.max(-r,-l),r),d=-p*p+h*(h+2*l)+c);else h=a>0?-r:r,p=Math.max(0,-(a*h+o)),d=-p*p+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,p),s&&s.copy(ba).addScaledVector(Ds,h),d}intersectSphere(e,t){if(e.radius<0)return null;Cn.subVectors(e.center,this.origin);const i=Cn.dot(this.direction),s=Cn.dot(Cn)-i*i,r=e.radius*e.radius;if(s>r)return null;const a=Math.sqrt(r-s),o=i-a,l=i+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,a,o,l;const c=1/this.direction.x,u=1/this.direction.y,p=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,a=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,a=(e.min.y-h.y)*u),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),p>=0?(o=(e.min.z-h.z)*p,l=(e.max.z-h.z)*p):(o=(e.max.z-h.z)*p,l=(e.min.z-h.z)*p),i>l||o>s)||((o>i||i!==i)&&(i=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Cn)!==null}intersectTriangle(e,t,i,s,r){const a=this.origin,o=this.direction,l=o.x,c=o.y,u=o.z,p=e.x-a.x,h=e.y-a.y,d=e.z-a.z,_=t.x-a.x,v=t.y-a.y,m=t.z-a.z,f=i.x-a.x,x=i.y-a.y,w=i.z-a.z,M=Math.abs(l),T=Math.abs(c),R=Math.abs(u);let g,E,N,C,L,H,W,I,F,K,k,te;if(M>=T&&M>=R?(N=l,H=p,F=_,te=f,l>=0?(g=c,E=u,C=h,L=d,W=v,I=m,K=x,k=w):(g=u,E=c,C=d,L=h,W=m,I=v,K=w,k=x)):T>=R?(N=c,H=h,F=v,te=x,c>=0?(g=u,E=l,C=d,L=p,W=m,I=_,K=w,k=f):(g=l,E=u,C=p,L=d,W=_,I=m,K=f,k=w)):(N=u,H=d,F=m,te=w,u>=0?(g=l,E=c,C=p,L=h,W=_,I=v,K=f,k=x):(g=c,E=l,C=h,L=p,W=v,I=_,K=x,k=f)),N===0)return null;const X=g/N,j=E/N,ee=1/N,ye=C-X*H,Ie=L-j*H,Z=W-X*F,me=I-j*F,xe=K-X*te,Ae=k-j*te,ge=xe*me-Ae*Z,Ue=ye*Ae-Ie*xe,pt=Z*Ie-me*ye;if(s){if(ge<0||Ue<0||pt<0)return null}else if((ge<0||Ue<0||pt<0)&&(ge>0||Ue>0||pt>0))return null;const Ce=ge+Ue+pt;if(Ce===0)return null;const Ke=ee*(ge*H+Ue*F+pt*te);return(Ce>0?Ke<0:Ke>0)?null:this.at(Ke/Ce,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Xp extends zr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ye(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vi,this.combine=vh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const xc=new ft,li=new Wp,Ns=new cl,Sc=new V,Us=new V,Fs=new V,Os=new V,wa=new V,Bs=new V,Mc=new V,ks=new V;class ti extends qt{constructor(e=new Bn,t=new Xp){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;t.fromBufferAttribute(s,e);const o=this.morphTargetInfluences;if(r&&o){Bs.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=o[l],p=r[l];u!==0&&(wa.fromBufferAttribute(p,e),a?Bs.addScaledVector(wa,u):Bs.addScaledVector(wa.sub(t),u))}t.add(Bs)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ns.copy(i.boundingSphere),Ns.applyMatrix4(r),li.copy(e.ray).recast(e.near),!(Ns.containsPoint(li.origin)===!1&&(li.intersectSphere(Ns,Sc)===null||li.origin.distanceToSquared(Sc)>(e.far-e.near)**2))&&(xc.copy(r).invert(),li.copy(e.ray).applyMatrix4(xc),!(i.boundingBox!==null&&li.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,li)))}_computeIntersections(e,t,i){let s;const r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,p=r.attributes.normal,h=r.groups,d=r.drawRange;if(o!==null)if(Array.isArray(a))for(let _=0,v=h.length;_<v;_++){const m=h[_],f=a[m.materialIndex],x=Math.max(m.start,d.start),w=Math.min(o.count,Math.min(m.start+m.count,d.start+d.count));for(let M=x,T=w;M<T;M+=3){const R=o.getX(M),g=o.getX(M+1),E=o.getX(M+2);s=zs(this,f,e,i,c,u,p,R,g,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,d.start),v=Math.min(o.count,d.start+d.count);for(let m=_,f=v;m<f;m+=3){const x=o.getX(m),w=o.getX(m+1),M=o.getX(m+2);s=zs(this,a,e,i,c,u,p,x,w,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let _=0,v=h.length;_<v;_++){const m=h[_],f=a[m.materialIndex],x=Math.max(m.start,d.start),w=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=x,T=w;M<T;M+=3){const R=M,g=M+1,E=M+2;s=zs(this,f,e,i,c,u,p,R,g,E),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const _=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=_,f=v;m<f;m+=3){const x=m,w=m+1,M=m+2;s=zs(this,a,e,i,c,u,p,x,w,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}}function $p(n,e,t,i,s,r,a,o){let l;if(e.side===Ht?l=i.intersectTriangle(a,r,s,!0,o):l=i.intersectTriangle(s,r,a,e.side===gi,o),l===null)return null;ks.copy(o),ks.applyMatrix4(n.matrixWorld);const c=t.ray.origin.distanceTo(ks);return c<t.near||c>t.far?null:{distance:c,point:ks.clone(),object:n}}function zs(n,e,t,i,s,r,a,o,l,c){n.getVertexPosition(o,Us),n.getVertexPosition(l,Fs),n.getVertexPosition(c,Os);const u=$p(n,e,t,i,Us,Fs,Os,Mc);if(u){const p=new V;un.getBarycoord(Mc,Us,Fs,Os,p),s&&(u.uv=un.getInterpolatedAttribute(s,o,l,c,p,new Xe)),r&&(u.uv1=un.getInterpolatedAttribute(r,o,l,c,p,new Xe)),a&&(u.normal=un.getInterpolatedAttribute(a,o,l,c,p,new V),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const h={a:o,b:l,c,normal:new V,materialIndex:0};un.getNormal(Us,Fs,Os,h.normal),u.face=h,u.barycoord=p}return u}class Ro extends Bt{constructor(e=null,t=1,i=1,s,r,a,o,l,c=_t,u=_t,p,h){super(null,a,o,l,c,u,s,r,p,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const ci=new cl,qp=new Xe(.5,.5),Hs=new V;class br{constructor(e=new qn,t=new qn,i=new qn,s=new qn,r=new qn,a=new qn){this.planes=[e,t,i,s,r,a]}set(e,t,i,s,r,a){const o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=hn,i=!1){const s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],u=r[4],p=r[5],h=r[6],d=r[7],_=r[8],v=r[9],m=r[10],f=r[11],x=r[12],w=r[13],M=r[14],T=r[15];if(s[0].setComponents(c-a,d-u,f-_,T-x).normalize(),s[1].setComponents(c+a,d+u,f+_,T+x).normalize(),s[2].setComponents(c+o,d+p,f+v,T+w).normalize(),s[3].setComponents(c-o,d-p,f-v,T-w).normalize(),i)s[4].setComponents(l,h,m,M).normalize(),s[5].setComponents(c-l,d-h,f-m,T-M).normalize();else if(s[4].setComponents(c-l,d-h,f-m,T-M).normalize(),t===hn)s[5].setComponents(c+l,d+h,f+m,T+M).normalize();else if(t===yr)s[5].setComponents(l,h,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ci.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ci.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ci)}intersectsSprite(e){ci.center.set(0,0,0);const t=qp.distanceTo(e.center);return ci.radius=.7071067811865476+t,ci.applyMatrix4(e.matrixWorld),this.intersectsSphere(ci)}intersectsSphere(e){const t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const s=t[i];if(Hs.x=s.normal.x>0?e.max.x:e.min.x,Hs.y=s.normal.y>0?e.max.y:e.min.y,Hs.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Hs)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}const yc=new ft;class ul{constructor(){this.coordinateSystem=hn,this._frustums=[],this._count=0}setFromArrayCamera(e){const t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){const r=t[s];yc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new br),i[s].setFromProjectionMatrix(yc,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){const t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;const t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new br),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new ul().copy(this)}}class Gh extends Bt{constructor(e=[],t=Oi,i,s,r,a,o,l,c,u){super(e,t,i,s,r,a,o,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class ki extends Bt{constructor(e,t,i=En,s,r,a,o=_t,l=_t,c,u=ei,p=1){if(u!==ei&&u!==Qn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const h={width:e,height:t,depth:p};super(h,s,r,a,o,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ll(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}}class Vh extends ki{constructor(e,t=En,i=Oi,s,r,a=_t,o=_t,l,c=ei){const u={width:e,height:e,depth:1},p=[u,u,u,u,u,u];super(e,e,t,i,s,r,a,o,l,c),this.image=p,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}}class Wh extends Bt{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class gs extends Bn{constructor(e=1,t=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};const o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);const l=[],c=[],u=[],p=[];let h=0,d=0;_("z","y","x",-1,-1,i,t,e,a,r,0),_("z","y","x",1,-1,i,t,-e,a,r,1),_("x","z","y",1,1,e,i,t,s,a,2),_("x","z","y",1,-1,e,i,-t,s,a,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Un(c,3)),this.setAttribute("normal",new Un(u,3)),this.setAttribute("uv",new Un(p,2));function _(v,m,f,x,w,M,T,R,g,E,N){const C=M/g,L=T/E,H=M/2,W=T/2,I=R/2,F=g+1,K=E+1;let k=0,te=0;const X=new V;for(let j=0;j<K;j++){const ee=j*L-W;for(let ye=0;ye<F;ye++){const Ie=ye*C-H;X[v]=Ie*x,X[m]=ee*w,X[f]=I,c.push(X.x,X.y,X.z),X[v]=0,X[m]=0,X[f]=R>0?1:-1,u.push(X.x,X.y,X.z),p.push(ye/g),p.push(1-j/E),k+=1}}for(let j=0;j<E;j++)for(let ee=0;ee<g;ee++){const ye=h+ee+F*j,Ie=h+ee+F*(j+1),Z=h+(ee+1)+F*(j+1),me=h+(ee+1)+F*j;l.push(ye,Ie,me),l.push(Ie,Z,me),te+=6}o.addGroup(d,te,N),d+=te,h+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new gs(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}class Hr extends Bn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};const r=e/2,a=t/2,o=Math.floor(i),l=Math.floor(s),c=o+1,u=l+1,p=e/o,h=t/l,d=[],_=[],v=[],m=[];for(let f=0;f<u;f++){const x=f*h-a;for(let w=0;w<c;w++){const M=w*p-r;_.push(M,-x,0),v.push(0,0,1),m.push(w/o),m.push(1-f/l)}}for(let f=0;f<l;f++)for(let x=0;x<o;x++){const w=x+c*f,M=x+c*(f+1),T=x+1+c*(f+1),R=x+1+c*f;d.push(w,M,R),d.push(M,T,R)}this.setIndex(d),this.setAttribute("position",new Un(_,3)),this.setAttribute("normal",new Un(v,3)),this.setAttribute("uv",new Un(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Hr(e.width,e.height,e.widthSegments,e.heightSegments)}}function zi(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const s=n[t][i];if(Ec(s))s.isRenderTargetTexture?(Pe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Ec(s[0])){const r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Ut(n){const e={};for(let t=0;t<n.length;t++){const i=zi(n[t]);for(const s in i)e[s]=i[s]}return e}function Ec(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Yp(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Xh(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ve.workingColorSpace}const Kp={clone:zi,merge:Ut};var Zp=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Jp=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class xi extends zr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Zp,this.fragmentShader=Jp,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=zi(e.uniforms),this.uniformsGroups=Yp(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(const i in e.uniforms){const s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Ye().setHex(s.value);break;case"v2":this.uniforms[i].value=new Xe().fromArray(s.value);break;case"v3":this.uniforms[i].value=new V().fromArray(s.value);break;case"v4":this.uniforms[i].value=new lt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new De().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ft().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(const i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}}class $h extends xi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class Qp extends zr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=sp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class jp extends zr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const Gs=new V,Vs=new Xi,pn=new V;class hl extends qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ft,this.projectionMatrix=new ft,this.projectionMatrixInverse=new ft,this.coordinateSystem=hn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Gs,Vs,pn),pn.x===1&&pn.y===1&&pn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Gs,Vs,pn.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Gs,Vs,pn),pn.x===1&&pn.y===1&&pn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Gs,Vs,pn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const Xn=new V,bc=new Xe,wc=new Xe;class gn extends hl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=To*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(sa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return To*2*Math.atan(Math.tan(sa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Xn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Xn.x,Xn.y).multiplyScalar(-e/Xn.z),Xn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Xn.x,Xn.y).multiplyScalar(-e/Xn.z)}getViewSize(e,t){return this.getViewBounds(e,bc,wc),t.subVectors(wc,bc)}setViewOffset(e,t,i,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(sa*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*i/c,s*=a.width/l,i*=a.height/c}const o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}class em extends hl{constructor(e=-1,t=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-e,a=i+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=u*this.view.offsetY,l=o-u*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}const Li=-90,Di=1;class Co extends qt{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new gn(Li,Di,e,t);s.layers=this.layers,this.add(s);const r=new gn(Li,Di,e,t);r.layers=this.layers,this.add(r);const a=new gn(Li,Di,e,t);a.layers=this.layers,this.add(a);const o=new gn(Li,Di,e,t);o.layers=this.layers,this.add(o);const l=new gn(Li,Di,e,t);l.layers=this.layers,this.add(l);const c=new gn(Li,Di,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,s,r,a,o,l]=t;for(const c of t)this.remove(c);if(e===hn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===yr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,a,o,l,c,u]=this.children,p=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;const v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(p,h,d),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}}class tm extends gn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}}function Tc(n,e,t,i){const s=nm(i);switch(t){case Lh:return n*e;case kr:return n*e/s.components*s.byteLength;case sl:return n*e/s.components*s.byteLength;case _i:return n*e*2/s.components*s.byteLength;case rl:return n*e*2/s.components*s.byteLength;case Dh:return n*e*3/s.components*s.byteLength;case tn:return n*e*4/s.components*s.byteLength;case al:return n*e*4/s.components*s.byteLength;case nr:case ir:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case sr:case rr:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ka:case Ja:return Math.max(n,16)*Math.max(e,8)/4;case Ya:case Za:return Math.max(n,8)*Math.max(e,8)/2;case Qa:case ja:case to:case no:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case eo:case xr:case io:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case so:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ro:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ao:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case oo:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case lo:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case co:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case uo:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case ho:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case fo:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case po:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case mo:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case go:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case _o:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case vo:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case xo:case So:case Mo:return Math.ceil(n/4)*Math.ceil(e/4)*16;case yo:case Eo:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Sr:case bo:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function nm(n){switch(n){case en:case Ah:return{byteLength:1,components:1};case us:case Rh:case Vt:return{byteLength:2,components:1};case nl:case il:return{byteLength:2,components:4};case En:case tl:case Ot:return{byteLength:4,components:1};case Ch:case Ph:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:el}}));typeof window<"u"&&(window.__THREE__?Pe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=el);function qh(){let n=null,e=!1,t=null,i=null;function s(r,a){i=n.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function im(n){const e=new WeakMap;function t(o,l){const c=o.array,u=o.usage,p=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),o.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:p}}function i(o,l,c){const u=l.array,p=l.updateRanges;if(n.bindBuffer(c,o),p.length===0)n.bufferSubData(c,0,u);else{p.sort((d,_)=>d.start-_.start);let h=0;for(let d=1;d<p.length;d++){const _=p[h],v=p[d];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++h,p[h]=v)}p.length=h+1;for(let d=0,_=p.length;d<_;d++){const v=p[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);const l=e.get(o);l&&(n.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const u=e.get(o);(!u||u.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var sm=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,rm=`#ifdef USE_ALPHAHASH
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
#endif`,am=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,om=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lm=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cm=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,um=`#ifdef USE_AOMAP
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
#endif`,hm=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,dm=`#ifdef USE_BATCHING
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
#endif`,fm=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pm=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mm=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gm=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,_m=`#ifdef USE_IRIDESCENCE
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
#endif`,vm=`#ifdef USE_BUMPMAP
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
#endif`,xm=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Sm=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Mm=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ym=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Em=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,bm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,wm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Tm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Am=`#define PI 3.141592653589793
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
} // validated`,Rm=`vec3 transformedNormal = objectNormal;
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
#endif`,Cm=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Pm=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Lm=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Dm=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Im="gl_FragColor = linearToOutputTexel( gl_FragColor );",Nm=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Um=`#ifdef USE_ENVMAP
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
#endif`,Fm=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Om=`#ifdef USE_ENVMAP
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
#endif`,Bm=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,km=`#ifdef USE_ENVMAP
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
#endif`,zm=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Hm=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Gm=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Vm=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Wm=`#ifdef USE_GRADIENTMAP
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
}`,Xm=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,$m=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qm=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ym=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Km=`#ifdef USE_ENVMAP
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
#endif`,Zm=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Jm=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Qm=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,jm=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,eg=`PhysicalMaterial material;
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
#endif`,tg=`uniform sampler2D dfgLUT;
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
}`,ng=`
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
#endif`,ig=`#if defined( RE_IndirectDiffuse )
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
#endif`,sg=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,rg=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,ag=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,og=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cg=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ug=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,hg=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,dg=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,fg=`#if defined( USE_POINTS_UV )
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
#endif`,pg=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,mg=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,gg=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,_g=`#if defined( USE_MORPHCOLORS )
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
#endif`,vg=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xg=`#ifdef USE_MORPHTARGETS
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
#endif`,Sg=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Mg=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,yg=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Eg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wg=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Tg=`#ifdef USE_NORMALMAP
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
#endif`,Ag=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Rg=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Cg=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Pg=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Lg=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Dg=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Ig=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ng=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Ug=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Fg=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Og=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Bg=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,kg=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,zg=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Hg=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Gg=`float getShadowMask() {
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
}`,Vg=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Wg=`#ifdef USE_SKINNING
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
#endif`,Xg=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,$g=`#ifdef USE_SKINNING
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
#endif`,qg=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Yg=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Kg=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Zg=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Jg=`#ifdef USE_TRANSMISSION
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
#endif`,Qg=`#ifdef USE_TRANSMISSION
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
#endif`,jg=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,e_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,t_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,n_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const i_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,s_=`uniform sampler2D t2D;
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
}`,r_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,a_=`uniform float backgroundBlurriness;
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
}`,o_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,l_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,c_=`#include <common>
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
}`,u_=`#if DEPTH_PACKING == 3200
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
}`,h_=`#define DISTANCE
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
}`,d_=`#define DISTANCE
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
}`,f_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,p_=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,m_=`uniform float scale;
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
}`,g_=`uniform vec3 diffuse;
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
}`,__=`#include <common>
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
}`,v_=`uniform vec3 diffuse;
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
}`,x_=`#define LAMBERT
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
}`,S_=`#define LAMBERT
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
}`,M_=`#define MATCAP
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
}`,y_=`#define MATCAP
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
}`,E_=`#define NORMAL
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
}`,b_=`#define NORMAL
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
}`,w_=`#define PHONG
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
}`,T_=`#define PHONG
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
}`,A_=`#define STANDARD
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
}`,R_=`#define STANDARD
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
}`,C_=`#define TOON
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
}`,P_=`#define TOON
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
}`,L_=`uniform float size;
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
}`,D_=`uniform vec3 diffuse;
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
}`,I_=`#include <common>
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
}`,N_=`uniform vec3 color;
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
}`,U_=`uniform float rotation;
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
}`,F_=`uniform vec3 diffuse;
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
}`,Be={alphahash_fragment:sm,alphahash_pars_fragment:rm,alphamap_fragment:am,alphamap_pars_fragment:om,alphatest_fragment:lm,alphatest_pars_fragment:cm,aomap_fragment:um,aomap_pars_fragment:hm,batching_pars_vertex:dm,batching_vertex:fm,begin_vertex:pm,beginnormal_vertex:mm,bsdfs:gm,iridescence_fragment:_m,bumpmap_pars_fragment:vm,clipping_planes_fragment:xm,clipping_planes_pars_fragment:Sm,clipping_planes_pars_vertex:Mm,clipping_planes_vertex:ym,color_fragment:Em,color_pars_fragment:bm,color_pars_vertex:wm,color_vertex:Tm,common:Am,defaultnormal_vertex:Rm,displacementmap_pars_vertex:Cm,displacementmap_vertex:Pm,emissivemap_fragment:Lm,emissivemap_pars_fragment:Dm,colorspace_fragment:Im,colorspace_pars_fragment:Nm,envmap_fragment:Um,envmap_common_pars_fragment:Fm,envmap_pars_fragment:Om,envmap_pars_vertex:Bm,envmap_physical_pars_fragment:Km,envmap_vertex:km,fog_vertex:zm,fog_pars_vertex:Hm,fog_fragment:Gm,fog_pars_fragment:Vm,gradientmap_pars_fragment:Wm,lightmap_pars_fragment:Xm,lights_lambert_fragment:$m,lights_lambert_pars_fragment:qm,lights_pars_begin:Ym,lights_toon_fragment:Zm,lights_toon_pars_fragment:Jm,lights_phong_fragment:Qm,lights_phong_pars_fragment:jm,lights_physical_fragment:eg,lights_physical_pars_fragment:tg,lights_fragment_begin:ng,lights_fragment_maps:ig,lights_fragment_end:sg,lightprobes_pars_fragment:rg,logdepthbuf_fragment:ag,logdepthbuf_pars_fragment:og,logdepthbuf_pars_vertex:lg,logdepthbuf_vertex:cg,map_fragment:ug,map_pars_fragment:hg,map_particle_fragment:dg,map_particle_pars_fragment:fg,metalnessmap_fragment:pg,metalnessmap_pars_fragment:mg,morphinstance_vertex:gg,morphcolor_vertex:_g,morphnormal_vertex:vg,morphtarget_pars_vertex:xg,morphtarget_vertex:Sg,normal_fragment_begin:Mg,normal_fragment_maps:yg,normal_pars_fragment:Eg,normal_pars_vertex:bg,normal_vertex:wg,normalmap_pars_fragment:Tg,clearcoat_normal_fragment_begin:Ag,clearcoat_normal_fragment_maps:Rg,clearcoat_pars_fragment:Cg,iridescence_pars_fragment:Pg,opaque_fragment:Lg,packing:Dg,premultiplied_alpha_fragment:Ig,project_vertex:Ng,dithering_fragment:Ug,dithering_pars_fragment:Fg,roughnessmap_fragment:Og,roughnessmap_pars_fragment:Bg,shadowmap_pars_fragment:kg,shadowmap_pars_vertex:zg,shadowmap_vertex:Hg,shadowmask_pars_fragment:Gg,skinbase_vertex:Vg,skinning_pars_vertex:Wg,skinning_vertex:Xg,skinnormal_vertex:$g,specularmap_fragment:qg,specularmap_pars_fragment:Yg,tonemapping_fragment:Kg,tonemapping_pars_fragment:Zg,transmission_fragment:Jg,transmission_pars_fragment:Qg,uv_pars_fragment:jg,uv_pars_vertex:e_,uv_vertex:t_,worldpos_vertex:n_,background_vert:i_,background_frag:s_,backgroundCube_vert:r_,backgroundCube_frag:a_,cube_vert:o_,cube_frag:l_,depth_vert:c_,depth_frag:u_,distance_vert:h_,distance_frag:d_,equirect_vert:f_,equirect_frag:p_,linedashed_vert:m_,linedashed_frag:g_,meshbasic_vert:__,meshbasic_frag:v_,meshlambert_vert:x_,meshlambert_frag:S_,meshmatcap_vert:M_,meshmatcap_frag:y_,meshnormal_vert:E_,meshnormal_frag:b_,meshphong_vert:w_,meshphong_frag:T_,meshphysical_vert:A_,meshphysical_frag:R_,meshtoon_vert:C_,meshtoon_frag:P_,points_vert:L_,points_frag:D_,shadow_vert:I_,shadow_frag:N_,sprite_vert:U_,sprite_frag:F_},pe={common:{diffuse:{value:new Ye(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new De}},envmap:{envMap:{value:null},envMapRotation:{value:new De},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new De}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new De}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new De},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new De},normalScale:{value:new Xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new De},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new De}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new De}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new De}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ye(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ye(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0},uvTransform:{value:new De}},sprite:{diffuse:{value:new Ye(16777215)},opacity:{value:1},center:{value:new Xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}}},_n={basic:{uniforms:Ut([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.fog]),vertexShader:Be.meshbasic_vert,fragmentShader:Be.meshbasic_frag},lambert:{uniforms:Ut([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)},envMapIntensity:{value:1}}]),vertexShader:Be.meshlambert_vert,fragmentShader:Be.meshlambert_frag},phong:{uniforms:Ut([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)},specular:{value:new Ye(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Be.meshphong_vert,fragmentShader:Be.meshphong_frag},standard:{uniforms:Ut([pe.common,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.roughnessmap,pe.metalnessmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag},toon:{uniforms:Ut([pe.common,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.gradientmap,pe.fog,pe.lights,{emissive:{value:new Ye(0)}}]),vertexShader:Be.meshtoon_vert,fragmentShader:Be.meshtoon_frag},matcap:{uniforms:Ut([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,{matcap:{value:null}}]),vertexShader:Be.meshmatcap_vert,fragmentShader:Be.meshmatcap_frag},points:{uniforms:Ut([pe.points,pe.fog]),vertexShader:Be.points_vert,fragmentShader:Be.points_frag},dashed:{uniforms:Ut([pe.common,pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Be.linedashed_vert,fragmentShader:Be.linedashed_frag},depth:{uniforms:Ut([pe.common,pe.displacementmap]),vertexShader:Be.depth_vert,fragmentShader:Be.depth_frag},normal:{uniforms:Ut([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,{opacity:{value:1}}]),vertexShader:Be.meshnormal_vert,fragmentShader:Be.meshnormal_frag},sprite:{uniforms:Ut([pe.sprite,pe.fog]),vertexShader:Be.sprite_vert,fragmentShader:Be.sprite_frag},background:{uniforms:{uvTransform:{value:new De},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Be.background_vert,fragmentShader:Be.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new De}},vertexShader:Be.backgroundCube_vert,fragmentShader:Be.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Be.cube_vert,fragmentShader:Be.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Be.equirect_vert,fragmentShader:Be.equirect_frag},distance:{uniforms:Ut([pe.common,pe.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Be.distance_vert,fragmentShader:Be.distance_frag},shadow:{uniforms:Ut([pe.lights,pe.fog,{color:{value:new Ye(0)},opacity:{value:1}}]),vertexShader:Be.shadow_vert,fragmentShader:Be.shadow_frag}};_n.physical={uniforms:Ut([_n.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new De},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new De},clearcoatNormalScale:{value:new Xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new De},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new De},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new De},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new De},sheen:{value:0},sheenColor:{value:new Ye(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new De},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new De},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new De},transmissionSamplerSize:{value:new Xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new De},attenuationDistance:{value:0},attenuationColor:{value:new Ye(0)},specularColor:{value:new Ye(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new De},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new De},anisotropyVector:{value:new Xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new De}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag};const Ws={r:0,b:0,g:0},O_=new ft,Yh=new De;Yh.set(-1,0,0,0,1,0,0,0,1);function B_(n,e,t,i,s,r){const a=new Ye(0);let o=s===!0?0:1,l,c,u=null,p=0,h=null;function d(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){const M=x.backgroundBlurriness>0;w=e.get(w,M)}return w}function _(x){let w=!1;const M=d(x);M===null?m(a,o):M&&M.isColor&&(m(M,1),w=!0);const T=n.xr.getEnvironmentBlendMode();T==="additive"?t.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(x,w){const M=d(w);M&&M.isCubeTexture?(c===void 0&&(c=new ti(new gs(1,1,1),new xi({name:"BackgroundCubeMaterial",uniforms:zi(_n.backgroundCube.uniforms),vertexShader:_n.backgroundCube.vertexShader,fragmentShader:_n.backgroundCube.fragmentShader,side:Ht,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,R,g){this.matrixWorld.copyPosition(g.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(O_.makeRotationFromEuler(w.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Yh),c.material.toneMapped=Ve.getTransfer(M.colorSpace)!==Je,(u!==M||p!==M.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=M,p=M.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new ti(new Hr(2,2),new xi({name:"BackgroundMaterial",uniforms:zi(_n.background.uniforms),vertexShader:_n.background.vertexShader,fragmentShader:_n.background.fragmentShader,side:gi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Ve.getTransfer(M.colorSpace)!==Je,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||p!==M.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=M,p=M.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,w){x.getRGB(Ws,Xh(n)),t.buffers.color.setClear(Ws.r,Ws.g,Ws.b,w,r)}function f(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(x,w=1){a.set(x),o=w,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(x){o=x,m(a,o)},render:_,addToRenderList:v,dispose:f}}function k_(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null);let r=s,a=!1;function o(L,H,W,I,F){let K=!1;const k=p(L,I,W,H);r!==k&&(r=k,c(r.object)),K=d(L,I,W,F),K&&_(L,I,W,F),F!==null&&e.update(F,n.ELEMENT_ARRAY_BUFFER),(K||a)&&(a=!1,M(L,H,W,I),F!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(F).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function p(L,H,W,I){const F=I.wireframe===!0;let K=i[H.id];K===void 0&&(K={},i[H.id]=K);const k=L.isInstancedMesh===!0?L.id:0;let te=K[k];te===void 0&&(te={},K[k]=te);let X=te[W.id];X===void 0&&(X={},te[W.id]=X);let j=X[F];return j===void 0&&(j=h(l()),X[F]=j),j}function h(L){const H=[],W=[],I=[];for(let F=0;F<t;F++)H[F]=0,W[F]=0,I[F]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:W,attributeDivisors:I,object:L,attributes:{},index:null}}function d(L,H,W,I){const F=r.attributes,K=H.attributes;let k=0;const te=W.getAttributes();for(const X in te)if(te[X].location>=0){const ee=F[X];let ye=K[X];if(ye===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(ye=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(ye=L.instanceColor)),ee===void 0||ee.attribute!==ye||ye&&ee.data!==ye.data)return!0;k++}return r.attributesNum!==k||r.index!==I}function _(L,H,W,I){const F={},K=H.attributes;let k=0;const te=W.getAttributes();for(const X in te)if(te[X].location>=0){let ee=K[X];ee===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor));const ye={};ye.attribute=ee,ee&&ee.data&&(ye.data=ee.data),F[X]=ye,k++}r.attributes=F,r.attributesNum=k,r.index=I}function v(){const L=r.newAttributes;for(let H=0,W=L.length;H<W;H++)L[H]=0}function m(L){f(L,0)}function f(L,H){const W=r.newAttributes,I=r.enabledAttributes,F=r.attributeDivisors;W[L]=1,I[L]===0&&(n.enableVertexAttribArray(L),I[L]=1),F[L]!==H&&(n.vertexAttribDivisor(L,H),F[L]=H)}function x(){const L=r.newAttributes,H=r.enabledAttributes;for(let W=0,I=H.length;W<I;W++)H[W]!==L[W]&&(n.disableVertexAttribArray(W),H[W]=0)}function w(L,H,W,I,F,K,k){k===!0?n.vertexAttribIPointer(L,H,W,F,K):n.vertexAttribPointer(L,H,W,I,F,K)}function M(L,H,W,I){v();const F=I.attributes,K=W.getAttributes(),k=H.defaultAttributeValues;for(const te in K){const X=K[te];if(X.location>=0){let j=F[te];if(j===void 0&&(te==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),te==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){const ee=j.normalized,ye=j.itemSize,Ie=e.get(j);if(Ie===void 0)continue;const Z=Ie.buffer,me=Ie.type,xe=Ie.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||j.gpuType===tl;if(j.isInterleavedBufferAttribute){const ge=j.data,Ue=ge.isInterleavedBuffer===!0?ge.stride:ge.itemSize,pt=j.offset;if(ge.isInstancedInterleavedBuffer||ge.isInstancedBufferAttribute){for(let Ce=0;Ce<X.locationSize;Ce++)f(X.location+Ce,ge.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ge.meshPerAttribute*ge.count)}else for(let Ce=0;Ce<X.locationSize;Ce++)m(X.location+Ce);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let Ce=0;Ce<X.locationSize;Ce++)w(X.location+Ce,ye/X.locationSize,me,ee,Ue*xe,(pt+ye/X.locationSize*Ce)*xe,Ae)}else{if(j.isInstancedBufferAttribute){for(let ge=0;ge<X.locationSize;ge++)f(X.location+ge,j.meshPerAttribute);L.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let ge=0;ge<X.locationSize;ge++)m(X.location+ge);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let ge=0;ge<X.locationSize;ge++)w(X.location+ge,ye/X.locationSize,me,ee,ye*xe,ye/X.locationSize*ge*xe,Ae)}}else if(k!==void 0){const ee=k[te];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv(X.location,ee);break;case 3:n.vertexAttrib3fv(X.location,ee);break;case 4:n.vertexAttrib4fv(X.location,ee);break;default:n.vertexAttrib1fv(X.location,ee)}}}}x()}function T(){N();for(const L in i){const H=i[L];for(const W in H){const I=H[W];for(const F in I){const K=I[F];for(const k in K)u(K[k].object),delete K[k];delete I[F]}}delete i[L]}}function R(L){if(i[L.id]===void 0)return;const H=i[L.id];for(const W in H){const I=H[W];for(const F in I){const K=I[F];for(const k in K)u(K[k].object),delete K[k];delete I[F]}}delete i[L.id]}function g(L){for(const H in i){const W=i[H];for(const I in W){const F=W[I];if(F[L.id]===void 0)continue;const K=F[L.id];for(const k in K)u(K[k].object),delete K[k];delete F[L.id]}}}function E(L){for(const H in i){const W=i[H],I=L.isInstancedMesh===!0?L.id:0,F=W[I];if(F!==void 0){for(const K in F){const k=F[K];for(const te in k)u(k[te].object),delete k[te];delete F[K]}delete W[I],Object.keys(W).length===0&&delete i[H]}}}function N(){C(),a=!0,r!==s&&(r=s,c(r.object))}function C(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:N,resetDefaultState:C,dispose:T,releaseStatesOfGeometry:R,releaseStatesOfObject:E,releaseStatesOfProgram:g,initAttributes:v,enableAttribute:m,disableUnusedAttributes:x}}function z_(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function a(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function o(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function H_(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const g=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(g.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(g){return!(g!==tn&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(g){const E=g===Vt&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(g!==en&&g!==Ot&&!E&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(g){if(g==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";g="mediump"}return g==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const u=l(c);u!==c&&(Pe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const p=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&p===!1;t.reversedDepthBuffer===!0&&p===!1&&Pe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&p===!0&&Pe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");const d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),f=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),R=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:p,maxTextures:d,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:m,maxAttributes:f,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:M,maxSamples:T,samples:R}}function G_(n){const e=this;let t=null,i=0,s=!1,r=!1;const a=new qn,o=new De,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(p,h){const d=p.length!==0||h||i!==0||s;return s=h,i=p.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(p,h){t=u(p,h,0)},this.setState=function(p,h,d){const _=p.clippingPlanes,v=p.clipIntersection,m=p.clipShadows,f=n.get(p);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{const x=r?0:i,w=x*4;let M=f.clippingState||null;l.value=M,M=u(_,h,w,d);for(let T=0;T!==w;++T)M[T]=t[T];f.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(p,h,d,_){const v=p!==null?p.length:0;let m=null;if(v!==0){if(m=l.value,_!==!0||m===null){const f=d+v*4,x=h.matrixWorldInverse;o.getNormalMatrix(x),(m===null||m.length<f)&&(m=new Float32Array(f));for(let w=0,M=d;w!==v;++w,M+=4)a.copy(p[w]).applyMatrix4(x,o),a.normal.toArray(m,M),m[M+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}class dl extends dn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Gh(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new gs(5,5,5),r=new xi({name:"CubemapFromEquirect",uniforms:zi(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ht,blending:hi});r.uniforms.tEquirect.value=t;const a=new ti(s,r),o=t.minFilter;return t.minFilter===Jn&&(t.minFilter=Ct),new Co(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){const r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,i,s);e.setRenderTarget(r)}}const Ac=256,V_=3,W_=20,Kh=256,Zh=16,X_=3,$_=new V,q_=new Ye;class wr{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Co(1,10,null),this._boxMesh=new ti(new gs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){const{size:a=256,position:o=$_}=r,l=this._renderer;this._setSize(a);const c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);const p=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,_=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(q_));const m=new Co(i,s,u);return m.position.copy(o),m.update(l,e),l.autoClear=p,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=_,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Pc(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cc(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Ac,vp(e))}_fromTexture(e,t){e.mapping===Oi||e.mapping===cs?this._setSize(e.image.length===0?Ac:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);const i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){const e=this._cubeSize,t=Rc(e,!1,!1),i=Math.log2(e)-V_;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){const t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Rc(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){const s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;const a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Oi||e.mapping===cs?(this._cubemapMaterial===null&&(this._cubemapMaterial=Pc()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Cc()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Y_(),this._integrationMaterial=K_());const t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;const r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Zh);for(let a=0;a<=i;a++){const o=wr.lodToRoughness(a,i);if(a>i-X_)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{const l=o>0?Math.log2(t)+.5*Math.log2(6/(Kh*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Z_());const i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}}function Rc(n,e,t){return new dl(n,{minFilter:Jn,generateMipmaps:e,type:Vt,colorSpace:hs,depthBuffer:t})}function _s(n,e,t){return new xi({name:n,uniforms:e,vertexShader:Be.cube_vert,fragmentShader:t,side:Ht,blending:hi,depthTest:!1,depthWrite:!1})}function Y_(){return _s("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Kh}u

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
	`)}function K_(){return _s("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Zh}},`

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
	`)}function Z_(){return _s("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${W_}
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
	`)}function Cc(){return _s("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Pc(){return _s("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function J_(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?a(h):r(h)}function r(h){if(h&&h.isTexture){const d=h.mapping;if(d===ea||d===ta)if(e.has(h)){const _=e.get(h).texture;return o(_,h.mapping)}else{const _=h.image;if(_&&_.height>0){const v=new dl(_.height);return v.fromEquirectangularTexture(n,h),e.set(h,v),h.addEventListener("dispose",c),o(v.texture,h.mapping)}else return null}}return h}function a(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){const d=h.mapping,_=d===ea||d===ta,v=d===Oi||d===cs;if(_||v){let m=t.get(h);const f=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==f)return i===null&&(i=new wr(n)),m=_?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;{const x=h.image;return _&&x&&x.height>0||v&&x&&l(x)?(i===null&&(i=new wr(n)),m=_?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function o(h,d){return d===ea?h.mapping=Oi:d===ta&&(h.mapping=cs),h}function l(h){let d=0;const _=6;for(let v=0;v<_;v++)h[v]!==void 0&&d++;return d===_}function c(h){const d=h.target;d.removeEventListener("dispose",c);const _=e.get(d);_!==void 0&&(e.delete(d),_.dispose())}function u(h){const d=h.target;d.removeEventListener("dispose",u);const _=t.get(d);_!==void 0&&(t.delete(d),_.dispose())}function p(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:p}}function Q_(n){const e={};function t(i){if(e[i]!==void 0)return e[i];const s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const s=t(i);return s===null&&ar("WebGLRenderer: "+i+" extension not supported."),s}}}function j_(n,e,t,i){const s={},r=new WeakMap,a=new FinalizationRegistry(_=>delete s[_]);function o(_){l(_.target)}function l(_){_.index!==null&&e.remove(_.index);for(const m in _.attributes)e.remove(_.attributes[m]);_.removeEventListener("dispose",o),delete s[_.id],a.unregister(_);const v=r.get(_);v&&(e.remove(v),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}function c(_,v){return s[v.id]!==void 0||(v.addEventListener("dispose",o),s[v.id]=new WeakRef(v),a.register(v,v.id,v),t.memory.geometries++),v}function u(_){const v=_.attributes;for(const m in v)e.update(v[m],n.ARRAY_BUFFER)}function p(_){const v=_.index,m=_.attributes.position;let f=0;if(m===void 0)return;const x=v!==null?v.array.length:m.array.length/3-1,w=m.count>=65535?Hh:zh,M=new w(Math.ceil(x/3)*6,1),T=M.array;if(v!==null){const g=v.array;f=v.version;for(let E=0,N=0;E<x;E+=3){const C=g[E+0],L=g[E+1],H=g[E+2];T[N++]=C,T[N++]=L,T[N++]=L,T[N++]=H,T[N++]=H,T[N++]=C}}else{f=m.version;for(let g=0,E=0;g<x;g+=3){const N=g+0,C=g+1,L=g+2;T[E++]=N,T[E++]=C,T[E++]=C,T[E++]=L,T[E++]=L,T[E++]=N}}M.version=f;const R=r.get(_);R&&e.remove(R),r.set(_,M)}function h(_){const v=r.get(_);if(v){const m=_.index;m!==null&&v.version<m.version&&p(_)}else p(_);return r.get(_)}function d(){for(const _ in s){const v=s[_].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function e0(n,e,t){let i;function s(p){i=p}let r,a;function o(p){r=p.type,a=p.bytesPerElement}function l(p,h){n.drawElements(i,h,r,p*a),t.update(h,i,1)}function c(p,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,p*a,d),t.update(h,i,d))}function u(p,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,p,0,d);let v=0;for(let m=0;m<d;m++)v+=h[m];t.update(v,i,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function t0(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(t.calls++,a){case n.TRIANGLES:t.triangles+=o*(r/3);break;case n.LINES:t.lines+=o*(r/2);break;case n.LINE_STRIP:t.lines+=o*(r-1);break;case n.LINE_LOOP:t.lines+=o*r;break;case n.POINTS:t.points+=o*r;break;default:qe("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function n0(n,e,t){const i=new WeakMap,s=new lt;function r(a,o,l){const c=a.morphTargetInfluences,u=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,p=u!==void 0?u.length:0;let h=i.get(o);if(h===void 0||h.count!==p){let C=function(){E.dispose(),i.delete(o),o.removeEventListener("dispose",C)};var d=C;h!==void 0&&h.texture.dispose();const _=o.morphAttributes.position!==void 0,v=o.morphAttributes.normal!==void 0,m=o.morphAttributes.color!==void 0,f=o.morphAttributes.position||[],x=o.morphAttributes.normal||[],w=o.morphAttributes.color||[];let M=0;_===!0&&(M=1),v===!0&&(M=2),m===!0&&(M=3);let T=o.attributes.position.count*M,R=1;T>e.maxTextureSize&&(R=Math.ceil(T/e.maxTextureSize),T=e.maxTextureSize);const g=new Float32Array(T*R*4*p),E=new Oh(g,T,R,p);E.type=Ot,E.needsUpdate=!0;const N=M*4;for(let L=0;L<p;L++){const H=f[L],W=x[L],I=w[L],F=T*R*4*L;for(let K=0;K<H.count;K++){const k=K*N;_===!0&&(s.fromBufferAttribute(H,K),g[F+k+0]=s.x,g[F+k+1]=s.y,g[F+k+2]=s.z,g[F+k+3]=0),v===!0&&(s.fromBufferAttribute(W,K),g[F+k+4]=s.x,g[F+k+5]=s.y,g[F+k+6]=s.z,g[F+k+7]=0),m===!0&&(s.fromBufferAttribute(I,K),g[F+k+8]=s.x,g[F+k+9]=s.y,g[F+k+10]=s.z,g[F+k+11]=I.itemSize===4?s.w:1)}}h={count:p,texture:E,size:new Xe(T,R)},i.set(o,h),o.addEventListener("dispose",C)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",a.morphTexture,t);else{let _=0;for(let m=0;m<c.length;m++)_+=c[m];const v=o.morphTargetsRelative?1:1-_;l.getUniforms().setValue(n,"morphTargetBaseInfluence",v),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function i0(n,e,t,i,s){let r=new WeakMap;function a(c){const u=s.render.frame,p=c.geometry,h=e.get(c,p);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){const d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function o(){r=new WeakMap}function l(c){const u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:a,dispose:o}}const s0={[xh]:"LINEAR_TONE_MAPPING",[Sh]:"REINHARD_TONE_MAPPING",[Mh]:"CINEON_TONE_MAPPING",[yh]:"ACES_FILMIC_TONE_MAPPING",[bh]:"AGX_TONE_MAPPING",[wh]:"NEUTRAL_TONE_MAPPING",[Eh]:"CUSTOM_TONE_MAPPING"};function r0(n,e,t,i,s,r){const a=new dn(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1});let o=null,l=null,c=null;const u=new Bn;u.setAttribute("position",new Un([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Un([0,2,0,0,2,0],2));const p=new $h({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new ti(u,p),d=new em(-1,1,1,-1,0,1);let _=null,v=null,m=!1,f,x=null,w=[],M=!1;this.setSize=function(T,R){a.setSize(T,R),o!==null&&o.setSize(T,R),l!==null&&l.setSize(T,R);for(let g=0;g<w.length;g++){const E=w[g];E.setSize&&E.setSize(T,R)}},this.setEffects=function(T){w=T,M=w.length>0&&w[0].isRenderPass===!0;const R=a.width,g=a.height;w.length>0&&o===null&&(o=new dn(R,g,{type:Vt,depthBuffer:!1,stencilBuffer:!1}),l=new dn(R,g,{type:Vt,depthBuffer:!1,stencilBuffer:!1}));const E=s===!0&&w.some(N=>N.needsDepthTexture===!0);E!==(a.depthTexture!==null)&&(E===!0&&c===null&&(c=new ki(R,g),r===!0&&(c.format=Qn,c.type=Bi)),a.dispose(),a.depthTexture=E?c:null,a.resolveDepthBuffer=E,a.storeMultisampledDepthBuffer=E);for(let N=0;N<w.length;N++){const C=w[N];C.setSize&&C.setSize(R,g),E&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(T,R){if(m||T.toneMapping===In&&w.length===0)return!1;if(x=R,R!==null){const g=R.width,E=R.height;(a.width!==g||a.height!==E)&&this.setSize(g,E)}return M===!1&&T.setRenderTarget(a),f=T.toneMapping,T.toneMapping=In,!0},this.hasRenderPass=function(){return M},this.end=function(T,R){T.toneMapping=f,m=!0;let g=a,E=o;for(let N=0;N<w.length;N++){const C=w[N];C.enabled!==!1&&(C.render(T,E,g,R),C.needsSwap!==!1&&(g=E,E=E===o?l:o))}if(_!==T.outputColorSpace||v!==T.toneMapping){_=T.outputColorSpace,v=T.toneMapping,p.defines={},Ve.getTransfer(_)===Je&&(p.defines.SRGB_TRANSFER="");const N=s0[v];N&&(p.defines[N]=""),p.needsUpdate=!0}p.uniforms.tDiffuse.value=g.texture,T.setRenderTarget(x),T.render(h,d),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),u.dispose(),p.dispose()}}const Jh=new Bt,Qh=new ki(1,1),jh=new Vh(1),ed=new Oh,td=new Ao,nd=new Gh,Lc=[],Dc=[],Ic=new Float32Array(16),Nc=new Float32Array(9),Uc=new Float32Array(4);function $i(n,e,t){const i=n[0];if(i<=0||i>0)return n;const s=e*t;let r=Lc[s];if(r===void 0&&(r=new Float32Array(s),Lc[s]=r),e!==0){i.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,n[a].toArray(r,o)}return r}function St(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Mt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Gr(n,e){let t=Dc[e];t===void 0&&(t=new Int32Array(e),Dc[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function a0(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function o0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(St(t,e))return;n.uniform2fv(this.addr,e),Mt(t,e)}}function l0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(St(t,e))return;n.uniform3fv(this.addr,e),Mt(t,e)}}function c0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(St(t,e))return;n.uniform4fv(this.addr,e),Mt(t,e)}}function u0(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(St(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Mt(t,e)}else{if(St(t,i))return;Uc.set(i),n.uniformMatrix2fv(this.addr,!1,Uc),Mt(t,i)}}function h0(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(St(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Mt(t,e)}else{if(St(t,i))return;Nc.set(i),n.uniformMatrix3fv(this.addr,!1,Nc),Mt(t,i)}}function d0(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(St(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Mt(t,e)}else{if(St(t,i))return;Ic.set(i),n.uniformMatrix4fv(this.addr,!1,Ic),Mt(t,i)}}function f0(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function p0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(St(t,e))return;n.uniform2iv(this.addr,e),Mt(t,e)}}function m0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(St(t,e))return;n.uniform3iv(this.addr,e),Mt(t,e)}}function g0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(St(t,e))return;n.uniform4iv(this.addr,e),Mt(t,e)}}function _0(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function v0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(St(t,e))return;n.uniform2uiv(this.addr,e),Mt(t,e)}}function x0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(St(t,e))return;n.uniform3uiv(this.addr,e),Mt(t,e)}}function S0(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(St(t,e))return;n.uniform4uiv(this.addr,e),Mt(t,e)}}function Vr(n){return n.version===0&&(n.compareFunction=Uh,n.needsUpdate=!0),n}function M0(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Vr(Qh):r=Jh,t.setTexture2D(e||r,s)}function y0(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||td,s)}function E0(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Vr(jh):r=nd,t.setTextureCube(e||r,s)}function b0(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||ed,s)}function w0(n){switch(n){case 5126:return a0;case 35664:return o0;case 35665:return l0;case 35666:return c0;case 35674:return u0;case 35675:return h0;case 35676:return d0;case 5124:case 35670:return f0;case 35667:case 35671:return p0;case 35668:case 35672:return m0;case 35669:case 35673:return g0;case 5125:return _0;case 36294:return v0;case 36295:return x0;case 36296:return S0;case 35678:case 36198:case 36298:case 36306:case 35682:return M0;case 35679:case 36299:case 36307:return y0;case 35680:case 36300:case 36308:case 36293:return E0;case 36289:case 36303:case 36311:case 36292:return b0}}function T0(n,e){n.uniform1fv(this.addr,e)}function A0(n,e){const t=$i(e,this.size,2);n.uniform2fv(this.addr,t)}function R0(n,e){const t=$i(e,this.size,3);n.uniform3fv(this.addr,t)}function C0(n,e){const t=$i(e,this.size,4);n.uniform4fv(this.addr,t)}function P0(n,e){const t=$i(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function L0(n,e){const t=$i(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function D0(n,e){const t=$i(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function I0(n,e){n.uniform1iv(this.addr,e)}function N0(n,e){n.uniform2iv(this.addr,e)}function U0(n,e){n.uniform3iv(this.addr,e)}function F0(n,e){n.uniform4iv(this.addr,e)}function O0(n,e){n.uniform1uiv(this.addr,e)}function B0(n,e){n.uniform2uiv(this.addr,e)}function k0(n,e){n.uniform3uiv(this.addr,e)}function z0(n,e){n.uniform4uiv(this.addr,e)}function H0(n,e,t){const i=this.cache,s=e.length,r=Gr(t,s);St(i,r)||(n.uniform1iv(this.addr,r),Mt(i,r));let a;this.type===n.SAMPLER_2D_SHADOW?a=Vr(Qh):a=Jh;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function G0(n,e,t){const i=this.cache,s=e.length,r=Gr(t,s);St(i,r)||(n.uniform1iv(this.addr,r),Mt(i,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||td,r[a])}function V0(n,e,t){const i=this.cache,s=e.length,r=Gr(t,s);St(i,r)||(n.uniform1iv(this.addr,r),Mt(i,r));let a;this.type===n.SAMPLER_CUBE_SHADOW?a=Vr(jh):a=nd;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function W0(n,e,t){const i=this.cache,s=e.length,r=Gr(t,s);St(i,r)||(n.uniform1iv(this.addr,r),Mt(i,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||ed,r[a])}function X0(n){switch(n){case 5126:return T0;case 35664:return A0;case 35665:return R0;case 35666:return C0;case 35674:return P0;case 35675:return L0;case 35676:return D0;case 5124:case 35670:return I0;case 35667:case 35671:return N0;case 35668:case 35672:return U0;case 35669:case 35673:return F0;case 5125:return O0;case 36294:return B0;case 36295:return k0;case 36296:return z0;case 35678:case 36198:case 36298:case 36306:case 35682:return H0;case 35679:case 36299:case 36307:return G0;case 35680:case 36300:case 36308:case 36293:return V0;case 36289:case 36303:case 36311:case 36292:return W0}}class $0{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=w0(t.type)}}class q0{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=X0(t.type)}}class Y0{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const s=this.seq;for(let r=0,a=s.length;r!==a;++r){const o=s[r];o.setValue(e,t[o.id],i)}}}const Ta=/(\w+)(\])?(\[|\.)?/g;function Fc(n,e){n.seq.push(e),n.map[e.id]=e}function K0(n,e,t){const i=n.name,s=i.length;for(Ta.lastIndex=0;;){const r=Ta.exec(i),a=Ta.lastIndex;let o=r[1];const l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Fc(t,c===void 0?new $0(o,n,e):new q0(o,n,e));break}else{let p=t.map[o];p===void 0&&(p=new Y0(o),Fc(t,p)),t=p}}}class or{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){const o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);K0(o,l,this)}const s=[],r=[];for(const a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){const r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){const s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,a=t.length;r!==a;++r){const o=t[r],l=i[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){const i=[];for(let s=0,r=e.length;s!==r;++s){const a=e[s];a.id in t&&i.push(a)}return i}}function Oc(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const Z0=37297;let J0=0;function Q0(n,e){const t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){const o=a+1;i.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return i.join(`
`)}const Bc=new De;function j0(n){Ve._getMatrix(Bc,Ve.workingColorSpace,n);const e=`mat3( ${Bc.elements.map(t=>t.toFixed(4))} )`;switch(Ve.getTransfer(n)){case Mr:return[e,"LinearTransferOETF"];case Je:return[e,"sRGBTransferOETF"];default:return Pe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function kc(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";const a=/ERROR: 0:(\d+)/.exec(r);if(a){const o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+Q0(n.getShaderSource(e),o)}else return r}function ev(n,e){const t=j0(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}const tv={[xh]:"Linear",[Sh]:"Reinhard",[Mh]:"Cineon",[yh]:"ACESFilmic",[bh]:"AgX",[wh]:"Neutral",[Eh]:"Custom"};function nv(n,e){const t=tv[e];return t===void 0?(Pe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const Xs=new V;function iv(){Ve.getLuminanceCoefficients(Xs);const n=Xs.x.toFixed(4),e=Xs.y.toFixed(4),t=Xs.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sv(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ts).join(`
`)}function rv(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function av(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(e,s),a=r.name;let o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:n.getAttribLocation(e,a),locationSize:o}}return t}function ts(n){return n!==""}function zc(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Hc(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const ov=/^[ \t]*#include +<([\w\d./]+)>/gm;function Po(n){return n.replace(ov,lv)}function lv(n,e){const t=Be[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Po(t)}const cv=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Gc(n){return n.replace(cv,uv)}function uv(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Vc(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}const hv={[tr]:"SHADOWMAP_TYPE_PCF",[es]:"SHADOWMAP_TYPE_VSM"};function dv(n){return hv[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const fv={[cs]:"ENVMAP_MODE_REFRACTION"};function pv(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":fv[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}const mv={[vh]:"ENVMAP_BLENDING_MULTIPLY",[tp]:"ENVMAP_BLENDING_MIX",[np]:"ENVMAP_BLENDING_ADD"};function gv(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":mv[n.combine]||"ENVMAP_BLENDING_NONE"}function _v(n,e,t,i){const s=n.getContext(),r=t.defines;let a=t.vertexShader,o=t.fragmentShader;const l=dv(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=pv(t),p=gv(t),h=sv(t),d=rv(r),_=s.createProgram();let v,m,f=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ts).join(`
`),v.length>0&&(v+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(ts).join(`
`),m.length>0&&(m+=`
`)):(v=[Vc(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ts).join(`
`),m=[Vc(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+p:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==In?"#define TONE_MAPPING":"",t.toneMapping!==In?Be.tonemapping_pars_fragment:"",t.toneMapping!==In?nv("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Be.colorspace_pars_fragment,ev("linearToOutputTexel",t.outputColorSpace),iv(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ts).join(`
`)),a=Po(a),a=zc(a,t),a=Hc(a,t),o=Po(o),o=zc(o,t),o=Hc(o,t),a=Gc(a),o=Gc(o),t.isRawShaderMaterial!==!0&&(f=`#version 300 es
`,v=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,m=["#define varying in",t.glslVersion===wo?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===wo?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);const x=f+v+a,w=f+m+o,M=Oc(s,s.VERTEX_SHADER,x),T=Oc(s,s.FRAGMENT_SHADER,w);s.attachShader(_,M),s.attachShader(_,T),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function R(C){if(n.debug.checkShaderErrors){const L=s.getProgramInfoLog(_)||"",H=s.getShaderInfoLog(M)||"",W=s.getShaderInfoLog(T)||"",I=L.trim(),F=H.trim(),K=W.trim();let k=!0,te=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(k=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,M,T);else{const X=kc(s,M,"vertex"),j=kc(s,T,"fragment");qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+I+`
`+X+`
`+j)}else I!==""?Pe("WebGLProgram: Program Info Log:",I):(F===""||K==="")&&(te=!1);te&&(C.diagnostics={runnable:k,programLog:I,vertexShader:{log:F,prefix:v},fragmentShader:{log:K,prefix:m}})}s.deleteShader(M),s.deleteShader(T),g=new or(s,_),E=av(s,_)}let g;this.getUniforms=function(){return g===void 0&&R(this),g};let E;this.getAttributes=function(){return E===void 0&&R(this),E};let N=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(_,Z0)),N},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=J0++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=M,this.fragmentShader=T,this}let vv=0;class xv{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){const s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new Sv(e),t.set(e,i)),i}}class Sv{constructor(e){this.id=vv++,this.code=e,this.usedTimes=0}}function Mv(n){return n===_i||n===xr||n===Sr}function yv(n,e,t,i,s,r){const a=new Bh,o=new xv,l=new Set,c=[],u=new Map,p=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(g){return l.add(g),g===0?"uv":`uv${g}`}function _(g,E,N,C,L,H){const W=C.fog,I=L.geometry,F=g.isMeshStandardMaterial||g.isMeshLambertMaterial||g.isMeshPhongMaterial?C.environment:null,K=g.isMeshStandardMaterial||g.isMeshLambertMaterial&&!g.envMap||g.isMeshPhongMaterial&&!g.envMap,k=e.get(g.envMap||F,K),te=h[g.type];let X=i.precision;g.precision!==null&&(X=i.getMaxPrecision(g.precision),X!==g.precision&&Pe("WebGLProgram.getParameters:",g.precision,"not supported, using",X,"instead."));const j=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ee=j!==void 0?j.length:0;let ye=0;I.morphAttributes.position!==void 0&&(ye=1),I.morphAttributes.normal!==void 0&&(ye=2),I.morphAttributes.color!==void 0&&(ye=3);let Ie,Z,me,xe;if(te){const fe=_n[te];Ie=fe.vertexShader,Z=fe.fragmentShader}else{Ie=g.vertexShader,Z=g.fragmentShader;const fe=o.getVertexShaderStage(g),Ze=o.getFragmentShaderStage(g);o.update(g,fe,Ze),me=fe.id,xe=Ze.id}const Ae=n.getRenderTarget(),ge=n.state.buffers.depth.getReversed(),Ue=L.isInstancedMesh===!0,pt=L.isBatchedMesh===!0,Ce=!!g.map,Ke=!!g.matcap,Qe=!!k,ke=Qe&&k.isPMREMTexture===!0,At=!!g.aoMap,vt=!!g.lightMap,kt=!!g.bumpMap&&g.wireframe===!1,at=!!g.normalMap,fn=!!g.displacementMap,yt=!!g.emissiveMap,Yt=!!g.metalnessMap,Kt=!!g.roughnessMap,Zt=g.anisotropy>0,U=g.clearcoat>0,Jt=g.diffuseRoughness>0,st=g.dispersion>0,rt=g.retroreflectivity>0,de=g.iridescence>0,xt=g.sheen>0,Re=g.transmission>0,Le=Zt&&!!g.anisotropyMap,A=U&&!!g.clearcoatMap,S=U&&!!g.clearcoatNormalMap,B=U&&!!g.clearcoatRoughnessMap,ne=Jt&&!!g.diffuseRoughnessMap,Q=de&&!!g.iridescenceMap,re=de&&!!g.iridescenceThicknessMap,ue=xt&&!!g.sheenColorMap,q=xt&&!!g.sheenRoughnessMap,Y=!!g.specularMap,oe=!!g.specularColorMap,P=!!g.specularIntensityMap,J=Re&&!!g.transmissionMap,$=Re&&!!g.thicknessMap,le=!!g.gradientMap,se=!!g.alphaMap,ae=g.alphaTest>0,be=!!g.alphaHash,Oe=!!g.extensions;let ie=In;g.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ie=n.toneMapping);const Te=ke?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,Fe={shaderID:te,shaderType:g.type,shaderName:g.name,vertexShader:Ie,fragmentShader:Z,defines:g.defines,customVertexShaderID:me,customFragmentShaderID:xe,isRawShaderMaterial:g.isRawShaderMaterial===!0,glslVersion:g.glslVersion,precision:X,batching:pt,batchingColor:pt&&L._colorsTexture!==null,instancing:Ue,instancingColor:Ue&&L.instanceColor!==null,instancingMorph:Ue&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:Ve.workingColorSpace,alphaToCoverage:!!g.alphaToCoverage,map:Ce,matcap:Ke,envMap:Qe,envMapMode:Qe&&k.mapping,envMapPMREM:ke,envMapMaxLod:ke?Te.length-1:null,envMapSize:ke?Te[0].width:null,aoMap:At,lightMap:vt,bumpMap:kt,normalMap:at,displacementMap:fn,emissiveMap:yt,normalMapObjectSpace:at&&g.normalMapType===rp,normalMapTangentSpace:at&&g.normalMapType===rc,packedNormalMap:at&&g.normalMapType===rc&&Mv(g.normalMap.format),metalnessMap:Yt,roughnessMap:Kt,anisotropy:Zt,anisotropyMap:Le,clearcoat:U,clearcoatMap:A,clearcoatNormalMap:S,clearcoatRoughnessMap:B,diffuseRoughness:Jt,diffuseRoughnessMap:ne,dispersion:st,retroreflection:rt,iridescence:de,iridescenceMap:Q,iridescenceThicknessMap:re,sheen:xt,sheenColorMap:ue,sheenRoughnessMap:q,specularMap:Y,specularColorMap:oe,specularIntensityMap:P,transmission:Re,transmissionMap:J,thicknessMap:$,gradientMap:le,opaque:g.transparent===!1&&g.blending===rs&&g.alphaToCoverage===!1,alphaMap:se,alphaTest:ae,alphaHash:be,combine:g.combine,mapUv:Ce&&d(g.map.channel),aoMapUv:At&&d(g.aoMap.channel),lightMapUv:vt&&d(g.lightMap.channel),bumpMapUv:kt&&d(g.bumpMap.channel),normalMapUv:at&&d(g.normalMap.channel),displacementMapUv:fn&&d(g.displacementMap.channel),emissiveMapUv:yt&&d(g.emissiveMap.channel),metalnessMapUv:Yt&&d(g.metalnessMap.channel),roughnessMapUv:Kt&&d(g.roughnessMap.channel),anisotropyMapUv:Le&&d(g.anisotropyMap.channel),clearcoatMapUv:A&&d(g.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(g.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&d(g.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&d(g.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&d(g.iridescenceMap.channel),iridescenceThicknessMapUv:re&&d(g.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&d(g.sheenColorMap.channel),sheenRoughnessMapUv:q&&d(g.sheenRoughnessMap.channel),specularMapUv:Y&&d(g.specularMap.channel),specularColorMapUv:oe&&d(g.specularColorMap.channel),specularIntensityMapUv:P&&d(g.specularIntensityMap.channel),transmissionMapUv:J&&d(g.transmissionMap.channel),thicknessMapUv:$&&d(g.thicknessMap.channel),alphaMapUv:se&&d(g.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(at||Zt),vertexNormals:!!I.attributes.normal,vertexColors:g.vertexColors,vertexAlphas:g.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!I.attributes.uv&&(Ce||se),fog:!!W,useFog:g.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:g.wireframe===!1&&(g.flatShading===!0||I.attributes.normal===void 0&&at===!1&&(g.isMeshLambertMaterial||g.isMeshPhongMaterial||g.isMeshStandardMaterial||g.isMeshPhysicalMaterial)),sizeAttenuation:g.sizeAttenuation===!0,logarithmicDepthBuffer:p,reversedDepthBuffer:ge,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:ye,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:H.filter(fe=>fe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:g.dithering,shadowMapEnabled:n.shadowMap.enabled&&N.length>0,shadowMapType:n.shadowMap.type,toneMapping:ie,decodeVideoTexture:Ce&&g.map.isVideoTexture===!0&&Ve.getTransfer(g.map.colorSpace)===Je,decodeVideoTextureEmissive:yt&&g.emissiveMap.isVideoTexture===!0&&Ve.getTransfer(g.emissiveMap.colorSpace)===Je,premultipliedAlpha:g.premultipliedAlpha,doubleSided:g.side===vn,flipSided:g.side===Ht,useDepthPacking:g.depthPacking>=0,depthPacking:g.depthPacking||0,index0AttributeName:g.index0AttributeName,extensionClipCullDistance:Oe&&g.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&g.extensions.multiDraw===!0||pt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:g.customProgramCacheKey()};return Fe.vertexUv1s=l.has(1),Fe.vertexUv2s=l.has(2),Fe.vertexUv3s=l.has(3),l.clear(),Fe}function v(g){const E=[];if(g.shaderID?E.push(g.shaderID):(E.push(g.customVertexShaderID),E.push(g.customFragmentShaderID)),g.defines!==void 0)for(const N in g.defines)E.push(N),E.push(g.defines[N]);return g.isRawShaderMaterial===!1&&(m(E,g),f(E,g),E.push(n.outputColorSpace)),E.push(g.customProgramCacheKey),E.join()}function m(g,E){g.push(E.precision),g.push(E.outputColorSpace),g.push(E.envMapMode),g.push(E.envMapPMREM),g.push(E.envMapMaxLod),g.push(E.envMapSize),g.push(E.mapUv),g.push(E.alphaMapUv),g.push(E.lightMapUv),g.push(E.aoMapUv),g.push(E.bumpMapUv),g.push(E.normalMapUv),g.push(E.displacementMapUv),g.push(E.emissiveMapUv),g.push(E.metalnessMapUv),g.push(E.roughnessMapUv),g.push(E.anisotropyMapUv),g.push(E.clearcoatMapUv),g.push(E.clearcoatNormalMapUv),g.push(E.clearcoatRoughnessMapUv),g.push(E.diffuseRoughnessMapUv),g.push(E.iridescenceMapUv),g.push(E.iridescenceThicknessMapUv),g.push(E.sheenColorMapUv),g.push(E.sheenRoughnessMapUv),g.push(E.specularMapUv),g.push(E.specularColorMapUv),g.push(E.specularIntensityMapUv),g.push(E.transmissionMapUv),g.push(E.thicknessMapUv),g.push(E.combine),g.push(E.fogExp2),g.push(E.sizeAttenuation),g.push(E.morphTargetsCount),g.push(E.numSunLights),g.push(E.numDirLights),g.push(E.numPointLights),g.push(E.numSpotLights),g.push(E.numSpotLightMaps),g.push(E.numHemiLights),g.push(E.numRectAreaLights),g.push(E.numSunLightShadows),g.push(E.numDirLightShadows),g.push(E.numPointLightShadows),g.push(E.numSpotLightShadows),g.push(E.numSpotLightShadowsWithMaps),g.push(E.numLightProbes),g.push(E.numLightProbeGrids),g.push(E.shadowMapType),g.push(E.toneMapping),g.push(E.numClippingPlanes),g.push(E.numClipIntersection),g.push(E.depthPacking)}function f(g,E){a.disableAll(),E.instancing&&a.enable(0),E.instancingColor&&a.enable(1),E.instancingMorph&&a.enable(2),E.matcap&&a.enable(3),E.envMap&&a.enable(4),E.normalMapObjectSpace&&a.enable(5),E.normalMapTangentSpace&&a.enable(6),E.clearcoat&&a.enable(7),E.iridescence&&a.enable(8),E.alphaTest&&a.enable(9),E.vertexColors&&a.enable(10),E.vertexAlphas&&a.enable(11),E.vertexUv1s&&a.enable(12),E.vertexUv2s&&a.enable(13),E.vertexUv3s&&a.enable(14),E.vertexTangents&&a.enable(15),E.anisotropy&&a.enable(16),E.alphaHash&&a.enable(17),E.batching&&a.enable(18),E.dispersion&&a.enable(19),E.retroreflection&&a.enable(24),E.diffuseRoughness&&a.enable(25),E.batchingColor&&a.enable(20),E.gradientMap&&a.enable(21),E.packedNormalMap&&a.enable(22),E.vertexNormals&&a.enable(23),g.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),E.numLightProbeGrids>0&&a.enable(22),E.hasPositionAttribute&&a.enable(23),g.push(a.mask)}function x(g){const E=h[g.type];let N;if(E){const C=_n[E];N=Kp.clone(C.uniforms)}else N=g.uniforms;return N}function w(g,E){let N=u.get(E);return N!==void 0?++N.usedTimes:(N=new _v(n,E,g,s),c.push(N),u.set(E,N)),N}function M(g){if(--g.usedTimes===0){const E=c.indexOf(g);c[E]=c[c.length-1],c.pop(),u.delete(g.cacheKey),g.destroy()}}function T(g){o.remove(g)}function R(){o.dispose()}return{getParameters:_,getProgramCacheKey:v,getUniforms:x,acquireProgram:w,releaseProgram:M,releaseShaderCache:T,programs:c,dispose:R}}function Ev(){let n=new WeakMap;function e(a){return n.has(a)}function t(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,l){n.get(a)[o]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function bv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Wc(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Xc(){const n=[];let e=0;const t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function a(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function o(h,d,_,v,m,f){let x=n[e];return x===void 0?(x={id:h.id,object:h,geometry:d,material:_,materialVariant:a(h),groupOrder:v,renderOrder:h.renderOrder,z:m,group:f},n[e]=x):(x.id=h.id,x.object=h,x.geometry=d,x.material=_,x.materialVariant=a(h),x.groupOrder=v,x.renderOrder=h.renderOrder,x.z=m,x.group=f),e++,x}function l(h,d,_,v,m,f,x){x.reversedDepth===!0&&(m=-m);const w=o(h,d,_,v,m,f);_.transmission>0?i.push(w):_.transparent===!0?s.push(w):t.push(w)}function c(h,d,_,v,m,f){const x=o(h,d,_,v,m,f);_.transmission>0?i.unshift(x):_.transparent===!0?s.unshift(x):t.unshift(x)}function u(h,d){t.length>1&&t.sort(h||bv),i.length>1&&i.sort(d||Wc),s.length>1&&s.sort(d||Wc)}function p(){for(let h=e,d=n.length;h<d;h++){const _=n[h];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:p,sort:u}}function wv(){let n=new WeakMap;function e(i,s){const r=n.get(i);let a;return r===void 0?(a=new Xc,n.set(i,[a])):s>=r.length?(a=new Xc,r.push(a)):a=r[s],a}function t(){n=new WeakMap}return{get:e,dispose:t}}function Tv(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new Ye};break;case"SpotLight":t={position:new V,direction:new V,color:new Ye,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new Ye,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,skyColor:new Ye,groundColor:new Ye};break;case"RectAreaLight":t={color:new Ye,position:new V,halfWidth:new V,halfHeight:new V};break}return n[e.id]=t,t}}}function Av(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let Rv=0;function Cv(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Pv(n){const e=new Tv,t=Av(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new V);const s=new V,r=new ft,a=new ft;function o(c){let u=0,p=0,h=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let d=0,_=0,v=0,m=0,f=0,x=0,w=0,M=0,T=0,R=0,g=0,E=0,N=0,C=0;c.sort(Cv);for(let H=0,W=c.length;H<W;H++){const I=c[H],F=I.color,K=I.intensity,k=I.distance;let te=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===_i?te=I.shadow.map.texture:te=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=F.r*K,p+=F.g*K,h+=F.b*K;else if(I.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(I.sh.coefficients[X],K);C++}else if(I.isSunLight){const X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){const j=I.shadow,ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[_]=ee,i.sunShadowMap[_]=te;const ye=j.getViewportCount();for(let Ie=0;Ie<ye;Ie++)i.sunShadowMatrix[v+Ie]=j.getMatrix(Ie),i.sunShadowCascade[v+Ie]=j._cascadeData[Ie];v+=ye,_++}i.sun[d]=X,d++}else if(I.isDirectionalLight){const X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){const j=I.shadow,ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize=j.mapSize,i.directionalShadow[m]=ee,i.directionalShadowMap[m]=te,i.directionalShadowMatrix[m]=I.shadow.matrix,T++}i.directional[m]=X,m++}else if(I.isSpotLight){const X=e.get(I);X.position.setFromMatrixPosition(I.matrixWorld),X.color.copy(F).multiplyScalar(K),X.distance=k,X.coneCos=Math.cos(I.angle),X.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),X.decay=I.decay,i.spot[x]=X;const j=I.shadow;if(I.map&&(i.spotLightMap[E]=I.map,E++,j.updateMatrices(I),I.castShadow&&N++),i.spotLightMatrix[x]=j.matrix,I.castShadow){const ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize=j.mapSize,i.spotShadow[x]=ee,i.spotShadowMap[x]=te,g++}x++}else if(I.isRectAreaLight){const X=e.get(I);X.color.copy(F).multiplyScalar(K),X.halfWidth.set(I.width*.5,0,0),X.halfHeight.set(0,I.height*.5,0),i.rectArea[w]=X,w++}else if(I.isPointLight){const X=e.get(I);if(X.color.copy(I.color).multiplyScalar(I.intensity),X.distance=I.distance,X.decay=I.decay,I.castShadow){const j=I.shadow,ee=t.get(I);ee.shadowIntensity=j.intensity,ee.shadowBias=j.bias,ee.shadowNormalBias=j.normalBias,ee.shadowRadius=j.radius,ee.shadowMapSize=j.mapSize,ee.shadowCameraNear=j.camera.near,ee.shadowCameraFar=j.camera.far,i.pointShadow[f]=ee,i.pointShadowMap[f]=te,i.pointShadowMatrix[f]=I.shadow.matrix,R++}i.point[f]=X,f++}else if(I.isHemisphereLight){const X=e.get(I);X.skyColor.copy(I.color).multiplyScalar(K),X.groundColor.copy(I.groundColor).multiplyScalar(K),i.hemi[M]=X,M++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=pe.LTC_FLOAT_1,i.rectAreaLTC2=pe.LTC_FLOAT_2):(i.rectAreaLTC1=pe.LTC_HALF_1,i.rectAreaLTC2=pe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=p,i.ambient[2]=h;const L=i.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==f||L.spotLength!==x||L.rectAreaLength!==w||L.hemiLength!==M||L.numSunShadows!==_||L.numDirectionalShadows!==T||L.numPointShadows!==R||L.numSpotShadows!==g||L.numSpotMaps!==E||L.numLightProbes!==C)&&(i.sun.length=d,i.directional.length=m,i.spot.length=x,i.rectArea.length=w,i.point.length=f,i.hemi.length=M,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=R,i.pointShadowMap.length=R,i.pointShadowMatrix.length=R,i.spotShadow.length=g,i.spotShadowMap.length=g,i.spotLightMatrix.length=g+E-N,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=N,i.numLightProbes=C,L.sunLength=d,L.directionalLength=m,L.pointLength=f,L.spotLength=x,L.rectAreaLength=w,L.hemiLength=M,L.numSunShadows=_,L.numDirectionalShadows=T,L.numPointShadows=R,L.numSpotShadows=g,L.numSpotMaps=E,L.numLightProbes=C,i.version=Rv++)}function l(c,u){let p=0,h=0,d=0,_=0,v=0,m=0;const f=u.matrixWorldInverse;for(let x=0,w=c.length;x<w;x++){const M=c[x];if(M.isSunLight){const T=i.sun[p];T.direction.setFromMatrixPosition(M.matrixWorld),T.direction.transformDirection(f),p++}else if(M.isDirectionalLight){const T=i.directional[h];T.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(f),h++}else if(M.isSpotLight){const T=i.spot[_];T.position.setFromMatrixPosition(M.matrixWorld),T.position.applyMatrix4(f),T.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(f),_++}else if(M.isRectAreaLight){const T=i.rectArea[v];T.position.setFromMatrixPosition(M.matrixWorld),T.position.applyMatrix4(f),a.identity(),r.copy(M.matrixWorld),r.premultiply(f),a.extractRotation(r),T.halfWidth.set(M.width*.5,0,0),T.halfHeight.set(0,M.height*.5,0),T.halfWidth.applyMatrix4(a),T.halfHeight.applyMatrix4(a),v++}else if(M.isPointLight){const T=i.point[d];T.position.setFromMatrixPosition(M.matrixWorld),T.position.applyMatrix4(f),d++}else if(M.isHemisphereLight){const T=i.hemi[m];T.direction.setFromMatrixPosition(M.matrixWorld),T.direction.transformDirection(f),m++}}}return{setup:o,setupView:l,state:i}}function $c(n){const e=new Pv(n),t=[],i=[],s=[];function r(p){u.camera=p,t.length=0,i.length=0,s.length=0}function a(p){p.isLightProbeGrid?s.push(p):t.push(p)}function o(p){i.push(p)}function l(){e.setup(t),s.sort((p,h)=>p.priority-h.priority||p.id-h.id)}function c(p){e.setupView(t,p)}const u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function Lv(n){let e=new WeakMap;function t(s,r=0){const a=e.get(s);let o;return a===void 0?(o=new $c(n),e.set(s,[o])):r>=a.length?(o=new $c(n),a.push(o)):o=a[r],o}function i(){e=new WeakMap}return{get:t,dispose:i}}const Dv=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Iv=`uniform sampler2D shadow_pass;
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
}`,Nv=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],Uv=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],qc=new ft,ji=new V,Aa=new V;function Fv(n,e,t){let i=new br;const s=new Xe,r=new Xe,a=new lt,o=new Qp,l=new jp,c={},u=t.maxTextureSize,p={[gi]:Ht,[Ht]:gi,[vn]:vn},h=new xi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xe},radius:{value:4}},vertexShader:Dv,fragmentShader:Iv}),d=h.clone();d.defines.HORIZONTAL_PASS=1;const _=new Bn;_.setAttribute("position",new yn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new ti(_,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=tr;let f=this.type;this.render=function(R,g,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;this.type===Bf&&(Pe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=tr);const N=n.getRenderTarget(),C=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),H=n.state;H.setBlending(hi),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);const W=f!==this.type;W&&g.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(F=>F.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,F=R.length;I<F;I++){const K=R[I],k=K.shadow;if(k===void 0){Pe("WebGLShadowMap:",K,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);const te=k.getFrameExtents();s.multiply(te),r.copy(k.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/te.x),s.x=r.x*te.x,k.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/te.y),s.y=r.y*te.y,k.mapSize.y=r.y));const X=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=X,k.map===null||W===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===es){if(K.isPointLight){Pe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new dn(s.x,s.y,{format:_i,type:Vt,minFilter:Ct,magFilter:Ct,generateMipmaps:!1}),k.map.texture.name=K.name+".shadowMap",k.map.depthTexture=new ki(s.x,s.y,Ot),k.map.depthTexture.name=K.name+".shadowMapDepth",k.map.depthTexture.format=ei,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=_t,k.map.depthTexture.magFilter=_t}else K.isPointLight?(k.map=new dl(s.x),k.map.depthTexture=new Vh(s.x,En)):(k.map=new dn(s.x,s.y),k.map.depthTexture=new ki(s.x,s.y,En)),k.map.depthTexture.name=K.name+".shadowMap",k.map.depthTexture.format=ei,this.type===tr?(k.map.depthTexture.compareFunction=X?Nh:Ih,k.map.depthTexture.minFilter=Ct,k.map.depthTexture.magFilter=Ct):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=_t,k.map.depthTexture.magFilter=_t);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);const j=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();K.isPointLight!==!0&&k.updateMatrices(K,E);const ee=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:E.layers;for(let ye=0;ye<j;ye++){const Ie=k.getCamera(ye);if(K.isPointLight){const Z=k.camera,me=k.matrix,xe=K.distance||Z.far;xe!==Z.far&&(Z.far=xe,Z.updateProjectionMatrix()),ji.setFromMatrixPosition(K.matrixWorld),Z.position.copy(ji),Aa.copy(Z.position),Aa.add(Nv[ye]),Z.up.copy(Uv[ye]),Z.lookAt(Aa),Z.updateMatrixWorld(),me.makeTranslation(-ji.x,-ji.y,-ji.z),qc.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),k._frustum.setFromProjectionMatrix(qc,Z.coordinateSystem,Z.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,ye),n.clear();else{ye===0&&(n.setRenderTarget(k.map),n.clear());const Z=k.getViewport(ye);a.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),H.viewport(a)}i=k.getFrustum(ye),M(g,E,Ie,K,ee,this.type)}k.isPointLightShadow!==!0&&this.type===es&&x(k,E),k.needsUpdate=!1}f=this.type,m.needsUpdate=!1,n.setRenderTarget(N,C,L)};function x(R,g){const E=e.update(v);h.defines.VSM_SAMPLES!==R.blurSamples&&(h.defines.VSM_SAMPLES=R.blurSamples,d.defines.VSM_SAMPLES=R.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),R.mapPass===null?R.mapPass=new dn(s.x,s.y,{format:_i,type:Vt}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),h.uniforms.shadow_pass.value=R.map.depthTexture,h.uniforms.resolution.value.set(R.map.width,R.map.height),h.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(g,null,E,h,v,null),d.uniforms.shadow_pass.value=R.mapPass.texture,d.uniforms.resolution.value.set(R.map.width,R.map.height),d.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(g,null,E,d,v,null)}function w(R,g,E,N){let C=null;const L=E.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(L!==void 0)C=L;else if(C=E.isPointLight===!0?l:o,n.localClippingEnabled&&g.clipShadows===!0&&Array.isArray(g.clippingPlanes)&&g.clippingPlanes.length!==0||g.displacementMap&&g.displacementScale!==0||g.alphaMap&&g.alphaTest>0||g.map&&g.alphaTest>0||g.alphaToCoverage===!0){const H=C.uuid,W=g.uuid;let I=c[H];I===void 0&&(I={},c[H]=I);let F=I[W];F===void 0&&(F=C.clone(),I[W]=F,g.addEventListener("dispose",T)),C=F}if(C.visible=g.visible,C.wireframe=g.wireframe,N===es?C.side=g.shadowSide!==null?g.shadowSide:g.side:C.side=g.shadowSide!==null?g.shadowSide:p[g.side],C.alphaMap=g.alphaMap,C.alphaTest=g.alphaToCoverage===!0?.5:g.alphaTest,C.map=g.map,C.clipShadows=g.clipShadows,C.clippingPlanes=g.clippingPlanes,C.clipIntersection=g.clipIntersection,C.displacementMap=g.displacementMap,C.displacementScale=g.displacementScale,C.displacementBias=g.displacementBias,C.wireframeLinewidth=g.wireframeLinewidth,C.linewidth=g.linewidth,E.isPointLight===!0&&C.isMeshDistanceMaterial===!0){const H=n.properties.get(C);H.light=E}return C}function M(R,g,E,N,C,L){if(R.visible===!1)return;if(R.layers.test(C)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&L===es)&&(!R.frustumCulled||R.intersectsFrustum(i))){R.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,R.matrixWorld);const I=e.update(R),F=R.material;if(Array.isArray(F)){const K=I.groups;for(let k=0,te=K.length;k<te;k++){const X=K[k],j=F[X.materialIndex];if(j&&j.visible){const ee=w(R,j,N,L);R.onBeforeShadow(n,R,g,E,I,ee,X),n.renderBufferDirect(E,null,I,ee,R,X),R.onAfterShadow(n,R,g,E,I,ee,X)}}}else if(F.visible){const K=w(R,F,N,L);R.onBeforeShadow(n,R,g,E,I,K,null),n.renderBufferDirect(E,null,I,K,R,null),R.onAfterShadow(n,R,g,E,I,K,null)}}const W=R.children;for(let I=0,F=W.length;I<F;I++)M(W[I],g,E,N,C,L)}function T(R){R.target.removeEventListener("dispose",T);for(const E in c){const N=c[E],C=R.target.uuid;C in N&&(N[C].dispose(),delete N[C])}}}function Ov(n,e){function t(){let P=!1;const J=new lt;let $=null;const le=new lt(0,0,0,0);return{setMask:function(se){$!==se&&!P&&(n.colorMask(se,se,se,se),$=se)},setLocked:function(se){P=se},setClear:function(se,ae,be,Oe,ie){ie===!0&&(se*=Oe,ae*=Oe,be*=Oe),J.set(se,ae,be,Oe),le.equals(J)===!1&&(n.clearColor(se,ae,be,Oe),le.copy(J))},reset:function(){P=!1,$=null,le.set(-1,0,0,0)}}}function i(){let P=!1,J=!1,$=null,le=null,se=null;return{setReversed:function(ae){if(J!==ae){const be=e.get("EXT_clip_control");ae?be.clipControlEXT(be.LOWER_LEFT_EXT,be.ZERO_TO_ONE_EXT):be.clipControlEXT(be.LOWER_LEFT_EXT,be.NEGATIVE_ONE_TO_ONE_EXT),J=ae;const Oe=se;se=null,this.setClear(Oe)}},getReversed:function(){return J},setTest:function(ae){ae?ge(n.DEPTH_TEST):Ue(n.DEPTH_TEST)},setMask:function(ae){$!==ae&&!P&&(n.depthMask(ae),$=ae)},setFunc:function(ae){if(J&&(ae=gp[ae]),le!==ae){switch(ae){case Ha:n.depthFunc(n.NEVER);break;case Ga:n.depthFunc(n.ALWAYS);break;case _r:n.depthFunc(n.LESS);break;case ls:n.depthFunc(n.LEQUAL);break;case Va:n.depthFunc(n.EQUAL);break;case Wa:n.depthFunc(n.GEQUAL);break;case Xa:n.depthFunc(n.GREATER);break;case $a:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}le=ae}},setLocked:function(ae){P=ae},setClear:function(ae){se!==ae&&(se=ae,J&&(ae=1-ae),n.clearDepth(ae))},reset:function(){P=!1,$=null,le=null,se=null,J=!1}}}function s(){let P=!1,J=null,$=null,le=null,se=null,ae=null,be=null,Oe=null,ie=null;return{setTest:function(Te){P||(Te?ge(n.STENCIL_TEST):Ue(n.STENCIL_TEST))},setMask:function(Te){J!==Te&&!P&&(n.stencilMask(Te),J=Te)},setFunc:function(Te,Fe,fe){($!==Te||le!==Fe||se!==fe)&&(n.stencilFunc(Te,Fe,fe),$=Te,le=Fe,se=fe)},setOp:function(Te,Fe,fe){(ae!==Te||be!==Fe||Oe!==fe)&&(n.stencilOp(Te,Fe,fe),ae=Te,be=Fe,Oe=fe)},setLocked:function(Te){P=Te},setClear:function(Te){ie!==Te&&(n.clearStencil(Te),ie=Te)},reset:function(){P=!1,J=null,$=null,le=null,se=null,ae=null,be=null,Oe=null,ie=null}}}const r=new t,a=new i,o=new s;let l={};const c=new WeakMap;let u={},p={},h={},d=new WeakMap,_=[],v=null,m=!1,f=null,x=null,w=null,M=null,T=null,R=null,g=null,E=new Ye(0,0,0),N=0,C=!1,L=null,H=null,W=null,I=null,F=null;const K=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let k=!1,te=0;const X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(te=parseFloat(/^WebGL (\d)/.exec(X)[1]),k=te>=1):X.indexOf("OpenGL ES")!==-1&&(te=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),k=te>=2);let j=null,ee={};const ye=n.getParameter(n.SCISSOR_BOX),Ie=n.getParameter(n.VIEWPORT),Z=new lt().fromArray(ye),me=new lt().fromArray(Ie);function xe(P,J,$,le){const se=new Uint8Array(4),ae=n.createTexture();n.bindTexture(P,ae),n.texParameteri(P,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(P,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let be=0;be<$;be++)P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY?n.texImage3D(J,0,n.RGBA,1,1,le,0,n.RGBA,n.UNSIGNED_BYTE,se):n.texImage2D(J+be,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,se);return ae}const Ae={};Ae[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),ge(n.DEPTH_TEST),a.setFunc(ls),kt(!1),at(tc),ge(n.CULL_FACE),At(hi);function ge(P){u[P]!==!0&&(n.enable(P),u[P]=!0)}function Ue(P){u[P]!==!1&&(n.disable(P),u[P]=!1)}function pt(P,J){return h[P]!==J?(n.bindFramebuffer(P,J),h[P]=J,P===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=J),P===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=J),!0):!1}function Ce(P,J){let $=_,le=!1;if(P){$=d.get(J),$===void 0&&($=[],d.set(J,$));const se=P.textures;if($.length!==se.length||$[0]!==n.COLOR_ATTACHMENT0){for(let ae=0,be=se.length;ae<be;ae++)$[ae]=n.COLOR_ATTACHMENT0+ae;$.length=se.length,le=!0}}else $[0]!==n.BACK&&($[0]=n.BACK,le=!0);le&&n.drawBuffers($)}function Ke(P){return v!==P?(n.useProgram(P),v=P,!0):!1}const Qe={[Ii]:n.FUNC_ADD,[kf]:n.FUNC_SUBTRACT,[zf]:n.FUNC_REVERSE_SUBTRACT};Qe[Hf]=n.MIN,Qe[Gf]=n.MAX;const ke={[Vf]:n.ZERO,[za]:n.ONE,[Wf]:n.SRC_COLOR,[gh]:n.SRC_ALPHA,[Zf]:n.SRC_ALPHA_SATURATE,[Yf]:n.DST_COLOR,[$f]:n.DST_ALPHA,[Xf]:n.ONE_MINUS_SRC_COLOR,[_h]:n.ONE_MINUS_SRC_ALPHA,[Kf]:n.ONE_MINUS_DST_COLOR,[qf]:n.ONE_MINUS_DST_ALPHA,[Jf]:n.CONSTANT_COLOR,[Qf]:n.ONE_MINUS_CONSTANT_COLOR,[jf]:n.CONSTANT_ALPHA,[ep]:n.ONE_MINUS_CONSTANT_ALPHA};function At(P,J,$,le,se,ae,be,Oe,ie,Te){if(P===hi){m===!0&&(Ue(n.BLEND),m=!1);return}if(m===!1&&(ge(n.BLEND),m=!0),P!==mh){if(P!==f||Te!==C){if((x!==Ii||T!==Ii)&&(n.blendEquation(n.FUNC_ADD),x=Ii,T=Ii),Te)switch(P){case rs:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case nc:n.blendFunc(n.ONE,n.ONE);break;case ic:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case sc:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:qe("WebGLState: Invalid blending: ",P);break}else switch(P){case rs:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case nc:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case ic:qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case sc:qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:qe("WebGLState: Invalid blending: ",P);break}w=null,M=null,R=null,g=null,E.set(0,0,0),N=0,f=P,C=Te}return}se=se||J,ae=ae||$,be=be||le,(J!==x||se!==T)&&(n.blendEquationSeparate(Qe[J],Qe[se]),x=J,T=se),($!==w||le!==M||ae!==R||be!==g)&&(n.blendFuncSeparate(ke[$],ke[le],ke[ae],ke[be]),w=$,M=le,R=ae,g=be),(Oe.equals(E)===!1||ie!==N)&&(n.blendColor(Oe.r,Oe.g,Oe.b,ie),E.copy(Oe),N=ie),f=P,C=!1}function vt(P,J){P.side===vn?Ue(n.CULL_FACE):ge(n.CULL_FACE);let $=P.side===Ht;J&&($=!$),kt($),P.blending===rs&&P.transparent===!1?At(hi):At(P.blending,P.blendEquation,P.blendSrc,P.blendDst,P.blendEquationAlpha,P.blendSrcAlpha,P.blendDstAlpha,P.blendColor,P.blendAlpha,P.premultipliedAlpha),a.setFunc(P.depthFunc),a.setTest(P.depthTest),a.setMask(P.depthWrite),r.setMask(P.colorWrite);const le=P.stencilWrite;o.setTest(le),le&&(o.setMask(P.stencilWriteMask),o.setFunc(P.stencilFunc,P.stencilRef,P.stencilFuncMask),o.setOp(P.stencilFail,P.stencilZFail,P.stencilZPass)),yt(P.polygonOffset,P.polygonOffsetFactor,P.polygonOffsetUnits),P.alphaToCoverage===!0?ge(n.SAMPLE_ALPHA_TO_COVERAGE):Ue(n.SAMPLE_ALPHA_TO_COVERAGE)}function kt(P){L!==P&&(P?n.frontFace(n.CW):n.frontFace(n.CCW),L=P)}function at(P){P!==Ff?(ge(n.CULL_FACE),P!==H&&(P===tc?n.cullFace(n.BACK):P===Of?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ue(n.CULL_FACE),H=P}function fn(P){P!==W&&(k&&n.lineWidth(P),W=P)}function yt(P,J,$){P?(ge(n.POLYGON_OFFSET_FILL),(I!==J||F!==$)&&(I=J,F=$,a.getReversed()&&(J=-J,$=-$),n.polygonOffset(J,$))):Ue(n.POLYGON_OFFSET_FILL)}function Yt(P){P?ge(n.SCISSOR_TEST):Ue(n.SCISSOR_TEST)}function Kt(P){P===void 0&&(P=n.TEXTURE0+K-1),j!==P&&(n.activeTexture(P),j=P)}function Zt(P,J,$){$===void 0&&(j===null?$=n.TEXTURE0+K-1:$=j);let le=ee[$];le===void 0&&(le={type:void 0,texture:void 0},ee[$]=le),(le.type!==P||le.texture!==J)&&(j!==$&&(n.activeTexture($),j=$),n.bindTexture(P,J||Ae[P]),le.type=P,le.texture=J)}function U(){const P=ee[j];P!==void 0&&P.type!==void 0&&(n.bindTexture(P.type,null),P.type=void 0,P.texture=void 0)}function Jt(){try{n.compressedTexImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function st(){try{n.compressedTexImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function rt(){try{n.texSubImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function de(){try{n.texSubImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function xt(){try{n.compressedTexSubImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function Re(){try{n.compressedTexSubImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function Le(){try{n.texStorage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function A(){try{n.texStorage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function S(){try{n.texImage2D(...arguments)}catch(P){qe("WebGLState:",P)}}function B(){try{n.texImage3D(...arguments)}catch(P){qe("WebGLState:",P)}}function ne(P){return p[P]!==void 0?p[P]:n.getParameter(P)}function Q(P,J){p[P]!==J&&(n.pixelStorei(P,J),p[P]=J)}function re(P){Z.equals(P)===!1&&(n.scissor(P.x,P.y,P.z,P.w),Z.copy(P))}function ue(P){me.equals(P)===!1&&(n.viewport(P.x,P.y,P.z,P.w),me.copy(P))}function q(P,J){let $=c.get(J);$===void 0&&($=new WeakMap,c.set(J,$));let le=$.get(P);le===void 0&&(le=n.getUniformBlockIndex(J,P.name),n.uniformBlockBinding(J,le,le),$.set(P,le))}function Y(P,J,$){const se=c.get(J).get(P);l[se]!==$&&(n.bindBufferBase(n.UNIFORM_BUFFER,se,$),l[se]=$)}function oe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},p={},j=null,ee={},h={},l={},d=new WeakMap,_=[],v=null,m=!1,f=null,x=null,w=null,M=null,T=null,R=null,g=null,E=new Ye(0,0,0),N=0,C=!1,L=null,H=null,W=null,I=null,F=null,Z.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:ge,disable:Ue,bindFramebuffer:pt,drawBuffers:Ce,useProgram:Ke,setBlending:At,setMaterial:vt,setFlipSided:kt,setCullFace:at,setLineWidth:fn,setPolygonOffset:yt,setScissorTest:Yt,activeTexture:Kt,bindTexture:Zt,unbindTexture:U,compressedTexImage2D:Jt,compressedTexImage3D:st,texImage2D:S,texImage3D:B,pixelStorei:Q,getParameter:ne,updateUBOMapping:q,uniformBlockBinding:Y,texStorage2D:Le,texStorage3D:A,texSubImage2D:rt,texSubImage3D:de,compressedTexSubImage2D:xt,compressedTexSubImage3D:Re,scissor:re,viewport:ue,reset:oe}}function Bv(n,e,t,i,s,r,a){const o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Xe,u=new WeakMap,p=new Set;let h;const d=new WeakMap,_=new Set,v=new FinalizationRegistry(A=>_.delete(A));let m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function f(A,S){return m?new OffscreenCanvas(A,S):Er("canvas")}function x(A,S,B){let ne=1;const Q=Le(A);if((Q.width>B||Q.height>B)&&(ne=B/Math.max(Q.width,Q.height)),ne<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){const re=Math.floor(ne*Q.width),ue=Math.floor(ne*Q.height);h===void 0&&(h=f(re,ue));const q=S?f(re,ue):h;return q.width=re,q.height=ue,q.getContext("2d").drawImage(A,0,0,re,ue),Pe("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+re+"x"+ue+")."),q}else return"data"in A&&Pe("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),A;return A}function w(A){return A.generateMipmaps}function M(A){n.generateMipmap(A)}function T(A){return A.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?n.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function R(A,S,B,ne,Q,re=!1){if(A!==null){if(n[A]!==void 0)return n[A];Pe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let ue;ne&&(ue=e.get("EXT_texture_norm16"),ue||Pe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let q=S;if(S===n.RED&&(B===n.FLOAT&&(q=n.R32F),B===n.HALF_FLOAT&&(q=n.R16F),B===n.UNSIGNED_BYTE&&(q=n.R8),B===n.UNSIGNED_SHORT&&ue&&(q=ue.R16_EXT),B===n.SHORT&&ue&&(q=ue.R16_SNORM_EXT)),S===n.RED_INTEGER&&(B===n.UNSIGNED_BYTE&&(q=n.R8UI),B===n.UNSIGNED_SHORT&&(q=n.R16UI),B===n.UNSIGNED_INT&&(q=n.R32UI),B===n.BYTE&&(q=n.R8I),B===n.SHORT&&(q=n.R16I),B===n.INT&&(q=n.R32I)),S===n.RG&&(B===n.FLOAT&&(q=n.RG32F),B===n.HALF_FLOAT&&(q=n.RG16F),B===n.UNSIGNED_BYTE&&(q=n.RG8),B===n.UNSIGNED_SHORT&&ue&&(q=ue.RG16_EXT),B===n.SHORT&&ue&&(q=ue.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(B===n.UNSIGNED_BYTE&&(q=n.RG8UI),B===n.UNSIGNED_SHORT&&(q=n.RG16UI),B===n.UNSIGNED_INT&&(q=n.RG32UI),B===n.BYTE&&(q=n.RG8I),B===n.SHORT&&(q=n.RG16I),B===n.INT&&(q=n.RG32I)),S===n.RGB_INTEGER&&(B===n.UNSIGNED_BYTE&&(q=n.RGB8UI),B===n.UNSIGNED_SHORT&&(q=n.RGB16UI),B===n.UNSIGNED_INT&&(q=n.RGB32UI),B===n.BYTE&&(q=n.RGB8I),B===n.SHORT&&(q=n.RGB16I),B===n.INT&&(q=n.RGB32I)),S===n.RGBA_INTEGER&&(B===n.UNSIGNED_BYTE&&(q=n.RGBA8UI),B===n.UNSIGNED_SHORT&&(q=n.RGBA16UI),B===n.UNSIGNED_INT&&(q=n.RGBA32UI),B===n.BYTE&&(q=n.RGBA8I),B===n.SHORT&&(q=n.RGBA16I),B===n.INT&&(q=n.RGBA32I)),S===n.RGB&&(B===n.UNSIGNED_SHORT&&ue&&(q=ue.RGB16_EXT),B===n.SHORT&&ue&&(q=ue.RGB16_SNORM_EXT),B===n.UNSIGNED_INT_5_9_9_9_REV&&(q=n.RGB9_E5),B===n.UNSIGNED_INT_10F_11F_11F_REV&&(q=n.R11F_G11F_B10F)),S===n.RGBA){const Y=re?Mr:Ve.getTransfer(Q);B===n.FLOAT&&(q=n.RGBA32F),B===n.HALF_FLOAT&&(q=n.RGBA16F),B===n.UNSIGNED_BYTE&&(q=Y===Je?n.SRGB8_ALPHA8:n.RGBA8),B===n.UNSIGNED_SHORT&&ue&&(q=ue.RGBA16_EXT),B===n.SHORT&&ue&&(q=ue.RGBA16_SNORM_EXT),B===n.UNSIGNED_SHORT_4_4_4_4&&(q=n.RGBA4),B===n.UNSIGNED_SHORT_5_5_5_1&&(q=n.RGB5_A1)}return(q===n.R16F||q===n.R32F||q===n.RG16F||q===n.RG32F||q===n.RGBA16F||q===n.RGBA32F)&&e.get("EXT_color_buffer_float"),q}function g(A,S){let B;return A?S===null||S===En||S===Bi?B=n.DEPTH24_STENCIL8:S===Ot?B=n.DEPTH32F_STENCIL8:S===us&&(B=n.DEPTH24_STENCIL8,Pe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===En||S===Bi?B=n.DEPTH_COMPONENT24:S===Ot?B=n.DEPTH_COMPONENT32F:S===us&&(B=n.DEPTH_COMPONENT16),B}function E(A,S){return w(A)===!0||A.isFramebufferTexture&&A.minFilter!==_t&&A.minFilter!==Ct?Math.log2(Math.max(S.width,S.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?S.mipmaps.length:1}function N(A){const S=new WeakRef(A);i.get(A).__ref=S,_.add(S),v.register(A,S,S)}function C(A){const S=i.get(A).__ref;S!==void 0&&(_.delete(S),v.unregister(S))}function L(A){W(A.target)}function H(A){I(A.target)}function W(A){A.removeEventListener("dispose",L),C(A),K(A),A.isVideoTexture&&u.delete(A),A.isHTMLTexture&&p.delete(A)}function I(A){A.removeEventListener("dispose",H),C(A),te(A)}function F(){for(const A of _){const S=A.deref();S!==void 0&&(S.isRenderTarget===!0?I(S):W(S))}_.clear(),p.clear()}function K(A){const S=i.get(A);if(S.__webglInit===void 0)return;const B=A.source,ne=d.get(B);if(ne){const Q=ne[S.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&k(A),Object.keys(ne).length===0&&d.delete(B)}i.remove(A)}function k(A){const S=i.get(A);n.deleteTexture(S.__webglTexture);const B=A.source,ne=d.get(B);delete ne[S.__cacheKey],a.memory.textures--}function te(A){const S=i.get(A);S.__depthDisposeCallback&&S.__depthDisposeCallback();const B=A.depthTexture;if(B&&B.renderTarget===A&&W(B),A.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(S.__webglFramebuffer[Q]))for(let re=0;re<S.__webglFramebuffer[Q].length;re++)n.deleteFramebuffer(S.__webglFramebuffer[Q][re]);else n.deleteFramebuffer(S.__webglFramebuffer[Q]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[Q])}else{if(Array.isArray(S.__webglFramebuffer))for(let Q=0;Q<S.__webglFramebuffer.length;Q++)n.deleteFramebuffer(S.__webglFramebuffer[Q]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let Q=0;Q<S.__webglColorRenderbuffer.length;Q++)S.__webglColorRenderbuffer[Q]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[Q]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}const ne=A.textures;for(let Q=0,re=ne.length;Q<re;Q++){const ue=i.get(ne[Q]);ue.__webglTexture&&(n.deleteTexture(ue.__webglTexture),a.memory.textures--),i.remove(ne[Q])}i.remove(A)}let X=0;function j(){X=0}function ee(){return X}function ye(A){X=A}function Ie(){const A=X;return A>=s.maxTextures&&Pe("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,A}function Z(A){const S=[];return S.push(A.wrapS),S.push(A.wrapT),S.push(A.wrapR||0),S.push(A.magFilter),S.push(A.minFilter),S.push(A.anisotropy),S.push(A.internalFormat),S.push(A.format),S.push(A.type),S.push(A.generateMipmaps),S.push(A.mipmapsAutoUpdate),S.push(A.premultiplyAlpha),S.push(A.flipY),S.push(A.unpackAlignment),S.push(A.colorSpace),S.join()}function me(A,S){const B=i.get(A);if(A.isVideoTexture&&xt(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&B.__version!==A.version){const ne=A.image;if(ne===null)Pe("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Pe("WebGLRenderer: Texture marked for update but image is incomplete");else{vt(B,A,S);return}}else A.isExternalTexture&&(B.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,B.__webglTexture,n.TEXTURE0+S)}function xe(A,S){const B=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&B.__version!==A.version){vt(B,A,S);return}else A.isExternalTexture&&(B.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,B.__webglTexture,n.TEXTURE0+S)}function Ae(A,S){const B=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&B.__version!==A.version){vt(B,A,S);return}t.bindTexture(n.TEXTURE_3D,B.__webglTexture,n.TEXTURE0+S)}function ge(A,S){const B=i.get(A);if(A.version>0&&B.__version!==A.version){kt(B,A,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,B.__webglTexture,n.TEXTURE0+S)}const Ue={[vr]:n.REPEAT,[xn]:n.CLAMP_TO_EDGE,[qa]:n.MIRRORED_REPEAT},pt={[_t]:n.NEAREST,[ip]:n.NEAREST_MIPMAP_NEAREST,[Es]:n.NEAREST_MIPMAP_LINEAR,[Ct]:n.LINEAR,[na]:n.LINEAR_MIPMAP_NEAREST,[Jn]:n.LINEAR_MIPMAP_LINEAR},Ce={[op]:n.NEVER,[Uh]:n.ALWAYS,[lp]:n.LESS,[Ih]:n.LEQUAL,[cp]:n.EQUAL,[Nh]:n.GEQUAL,[up]:n.GREATER,[hp]:n.NOTEQUAL};function Ke(A,S){if(S.type===Ot&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Ct||S.magFilter===na||S.magFilter===Es||S.magFilter===Jn||S.minFilter===Ct||S.minFilter===na||S.minFilter===Es||S.minFilter===Jn)&&Pe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(A,n.TEXTURE_WRAP_S,Ue[S.wrapS]),n.texParameteri(A,n.TEXTURE_WRAP_T,Ue[S.wrapT]),(A===n.TEXTURE_3D||A===n.TEXTURE_2D_ARRAY)&&n.texParameteri(A,n.TEXTURE_WRAP_R,Ue[S.wrapR]),n.texParameteri(A,n.TEXTURE_MAG_FILTER,pt[S.magFilter]),n.texParameteri(A,n.TEXTURE_MIN_FILTER,pt[S.minFilter]),S.compareFunction&&(n.texParameteri(A,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(A,n.TEXTURE_COMPARE_FUNC,Ce[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===_t||S.minFilter!==Es&&S.minFilter!==Jn||S.type===Ot&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){const B=e.get("EXT_texture_filter_anisotropic");n.texParameterf(A,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function Qe(A,S){let B=!1;A.__webglInit===void 0&&(A.__webglInit=!0,S.addEventListener("dispose",L),N(S));const ne=S.source;let Q=d.get(ne);Q===void 0&&(Q={},d.set(ne,Q));const re=Z(S);if(re!==A.__cacheKey){Q[re]===void 0&&(Q[re]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,B=!0),Q[re].usedTimes++;const ue=Q[A.__cacheKey];ue!==void 0&&(Q[A.__cacheKey].usedTimes--,ue.usedTimes===0&&k(S)),A.__cacheKey=re,A.__webglTexture=Q[re].texture}return B}function ke(A,S,B){return Math.floor(Math.floor(A/B)/S)}function At(A,S,B,ne){const re=A.updateRanges;if(re.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,B,ne,S.data);else{re.sort((P,J)=>P.start-J.start);let ue=0;for(let P=1;P<re.length;P++){const J=re[ue],$=re[P],le=J.start+J.count,se=ke($.start,S.width,4),ae=ke(J.start,S.width,4);$.start<=le+1&&se===ae&&ke($.start+$.count-1,S.width,4)===se?J.count=Math.max(J.count,$.start+$.count-J.start):(++ue,re[ue]=$)}re.length=ue+1;const q=t.getParameter(n.UNPACK_ROW_LENGTH),Y=t.getParameter(n.UNPACK_SKIP_PIXELS),oe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let P=0,J=re.length;P<J;P++){const $=re[P],le=Math.floor($.start/4),se=Math.ceil($.count/4),ae=le%S.width,be=Math.floor(le/S.width),Oe=se,ie=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,be),t.texSubImage2D(n.TEXTURE_2D,0,ae,be,Oe,ie,B,ne,S.data)}A.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,q),t.pixelStorei(n.UNPACK_SKIP_PIXELS,Y),t.pixelStorei(n.UNPACK_SKIP_ROWS,oe)}}function vt(A,S,B){let ne=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ne=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ne=n.TEXTURE_3D);const Q=Qe(A,S),re=S.source;t.bindTexture(ne,A.__webglTexture,n.TEXTURE0+B);const ue=i.get(re);if(re.version!==ue.__version||Q===!0){if(t.activeTexture(n.TEXTURE0+B),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){const ie=Ve.getPrimaries(Ve.workingColorSpace),Te=S.colorSpace===Kn?null:Ve.getPrimaries(S.colorSpace),Fe=S.colorSpace===Kn||ie===Te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Fe)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let Y=x(S.image,!1,s.maxTextureSize);Y=Re(S,Y);const oe=r.convert(S.format,S.colorSpace),P=r.convert(S.type);let J=R(S.internalFormat,oe,P,S.normalized,S.colorSpace,S.isVideoTexture);Ke(ne,S);let $;const le=S.mipmaps,se=S.isVideoTexture!==!0,ae=ue.__version===void 0||Q===!0,be=re.dataReady,Oe=E(S,Y);if(S.isDepthTexture)J=g(S.format===Qn,S.type),ae&&(se?t.texStorage2D(n.TEXTURE_2D,1,J,Y.width,Y.height):t.texImage2D(n.TEXTURE_2D,0,J,Y.width,Y.height,0,oe,P,null));else if(S.isDataTexture)if(le.length>0){se&&ae&&t.texStorage2D(n.TEXTURE_2D,Oe,J,le[0].width,le[0].height);for(let ie=0,Te=le.length;ie<Te;ie++)$=le[ie],se?be&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,oe,P,$.data):t.texImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,oe,P,$.data);S.generateMipmaps=!1}else se?(ae&&t.texStorage2D(n.TEXTURE_2D,Oe,J,Y.width,Y.height),be&&At(S,Y,oe,P)):t.texImage2D(n.TEXTURE_2D,0,J,Y.width,Y.height,0,oe,P,Y.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){se&&ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Oe,J,le[0].width,le[0].height,Y.depth);for(let ie=0,Te=le.length;ie<Te;ie++)if($=le[ie],S.format!==tn)if(oe!==null)if(se){if(be)if(S.layerUpdates.size>0){const Fe=Tc($.width,$.height,S.format,S.type);for(const fe of S.layerUpdates){const Ze=$.data.subarray(fe*Fe/$.data.BYTES_PER_ELEMENT,(fe+1)*Fe/$.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,fe,$.width,$.height,1,oe,Ze)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,Y.depth,oe,$.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,Y.depth,0,$.data,0,0);else Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?be&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ie,0,0,0,$.width,$.height,Y.depth,oe,P,$.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ie,J,$.width,$.height,Y.depth,0,oe,P,$.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{se&&ae&&t.texStorage2D(n.TEXTURE_2D,Oe,J,le[0].width,le[0].height);for(let ie=0,Te=le.length;ie<Te;ie++)$=le[ie],S.format!==tn?oe!==null?se?be&&t.compressedTexSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,oe,$.data):t.compressedTexImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,$.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?be&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,$.width,$.height,oe,P,$.data):t.texImage2D(n.TEXTURE_2D,ie,J,$.width,$.height,0,oe,P,$.data)}else if(S.isDataArrayTexture)if(se){if(ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Oe,J,Y.width,Y.height,Y.depth),be)if(S.layerUpdates.size>0){const ie=Tc(Y.width,Y.height,S.format,S.type);for(const Te of S.layerUpdates){const Fe=Y.data.subarray(Te*ie/Y.data.BYTES_PER_ELEMENT,(Te+1)*ie/Y.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Te,Y.width,Y.height,1,oe,P,Fe)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,oe,P,Y.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,J,Y.width,Y.height,Y.depth,0,oe,P,Y.data);else if(S.isData3DTexture)se?(ae&&t.texStorage3D(n.TEXTURE_3D,Oe,J,Y.width,Y.height,Y.depth),be&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,oe,P,Y.data)):t.texImage3D(n.TEXTURE_3D,0,J,Y.width,Y.height,Y.depth,0,oe,P,Y.data);else if(S.isFramebufferTexture){if(ae)if(se)t.texStorage2D(n.TEXTURE_2D,Oe,J,Y.width,Y.height);else{let ie=Y.width,Te=Y.height;for(let Fe=0;Fe<Oe;Fe++)t.texImage2D(n.TEXTURE_2D,Fe,J,ie,Te,0,oe,P,null),ie>>=1,Te>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){const ie=n.canvas;if(ie.hasAttribute("layoutsubtree")||ie.setAttribute("layoutsubtree","true"),Y.parentNode!==ie){ie.appendChild(Y),p.add(S),ie.onpaint=Te=>{const Fe=Te.changedElements;for(const fe of p)Fe.includes(fe.image)&&(fe.needsUpdate=!0)},ie.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Y);else{const Fe=n.RGBA,fe=n.RGBA,Ze=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Fe,fe,Ze,Y)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(le.length>0){if(se&&ae){const ie=Le(le[0]);t.texStorage2D(n.TEXTURE_2D,Oe,J,ie.width,ie.height)}for(let ie=0,Te=le.length;ie<Te;ie++)$=le[ie],se?be&&t.texSubImage2D(n.TEXTURE_2D,ie,0,0,oe,P,$):t.texImage2D(n.TEXTURE_2D,ie,J,oe,P,$);S.generateMipmaps=!1}else if(se){if(ae){const ie=Le(Y);t.texStorage2D(n.TEXTURE_2D,Oe,J,ie.width,ie.height)}be&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,oe,P,Y)}else t.texImage2D(n.TEXTURE_2D,0,J,oe,P,Y);w(S)&&S.mipmapsAutoUpdate===!0&&M(ne),ue.__version=re.version,S.onUpdate&&S.onUpdate(S)}A.__version=S.version}function kt(A,S,B){if(S.image.length!==6)return;const ne=Qe(A,S),Q=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,A.__webglTexture,n.TEXTURE0+B);const re=i.get(Q);if(Q.version!==re.__version||ne===!0){t.activeTexture(n.TEXTURE0+B);const ue=Ve.getPrimaries(Ve.workingColorSpace),q=S.colorSpace===Kn?null:Ve.getPrimaries(S.colorSpace),Y=S.colorSpace===Kn||ue===q?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);const oe=S.isCompressedTexture||S.image[0].isCompressedTexture,P=S.image[0]&&S.image[0].isDataTexture,J=[];for(let fe=0;fe<6;fe++)!oe&&!P?J[fe]=x(S.image[fe],!0,s.maxCubemapSize):J[fe]=P?S.image[fe].image:S.image[fe],J[fe]=Re(S,J[fe]);const $=J[0],le=r.convert(S.format,S.colorSpace),se=r.convert(S.type);let ae=R(S.internalFormat,le,se,S.normalized,S.colorSpace);const be=S.isVideoTexture!==!0,Oe=re.__version===void 0||ne===!0,ie=Q.dataReady;let Te=E(S,$);Ke(n.TEXTURE_CUBE_MAP,S);let Fe;if(S.isDepthTexture){if(ae=g(S.format===Qn,S.type),Oe)if(be)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,ae,$.width,$.height);else for(let fe=0;fe<6;fe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,$.width,$.height,0,le,se,null)}else if(oe){be&&Oe&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Te,ae,$.width,$.height);for(let fe=0;fe<6;fe++){Fe=J[fe].mipmaps;for(let Ze=0;Ze<Fe.length;Ze++){const Et=Fe[Ze];S.format!==tn?le!==null?be?ie&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,0,0,Et.width,Et.height,le,Et.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,ae,Et.width,Et.height,0,Et.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):be?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,0,0,Et.width,Et.height,le,se,Et.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze,ae,Et.width,Et.height,0,le,se,Et.data)}}}else{if(Fe=S.mipmaps,be&&Oe){Fe.length>0&&Te++;const fe=Le(J[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Te,ae,fe.width,fe.height)}for(let fe=0;fe<6;fe++)if(P){be?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,0,0,J[fe].width,J[fe].height,le,se,J[fe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,J[fe].width,J[fe].height,0,le,se,J[fe].data);for(let Ze=0;Ze<Fe.length;Ze++){const kn=Fe[Ze].image[fe].image;be?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,0,0,kn.width,kn.height,le,se,kn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,ae,kn.width,kn.height,0,le,se,kn.data)}}else{be?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,0,0,le,se,J[fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,0,ae,le,se,J[fe]);for(let Ze=0;Ze<Fe.length;Ze++){const Et=Fe[Ze];be?ie&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,0,0,le,se,Et.image[fe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+fe,Ze+1,ae,le,se,Et.image[fe])}}}w(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),re.__version=Q.version,S.onUpdate&&S.onUpdate(S)}A.__version=S.version}function at(A,S,B,ne,Q,re){const ue=r.convert(B.format,B.colorSpace),q=r.convert(B.type),Y=R(B.internalFormat,ue,q,B.normalized,B.colorSpace),oe=i.get(S),P=i.get(B);if(P.__renderTarget=S,!oe.__hasExternalTextures){const J=Math.max(1,S.width>>re),$=Math.max(1,S.height>>re);Q===n.TEXTURE_3D||Q===n.TEXTURE_2D_ARRAY?t.texImage3D(Q,re,Y,J,$,S.depth,0,ue,q,null):t.texImage2D(Q,re,Y,J,$,0,ue,q,null)}t.bindFramebuffer(n.FRAMEBUFFER,A),de(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ne,Q,P.__webglTexture,0,rt(S)):(Q===n.TEXTURE_2D||Q>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ne,Q,P.__webglTexture,re),t.bindFramebuffer(n.FRAMEBUFFER,null)}function fn(A,S,B){if(n.bindRenderbuffer(n.RENDERBUFFER,A),S.depthBuffer){const ne=S.depthTexture,Q=ne&&ne.isDepthTexture?ne.type:null,re=g(S.stencilBuffer,Q),ue=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;de(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(S),re,S.width,S.height):B?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(S),re,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,re,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ue,n.RENDERBUFFER,A)}else{const ne=S.textures;for(let Q=0;Q<ne.length;Q++){const re=ne[Q],ue=r.convert(re.format,re.colorSpace),q=r.convert(re.type),Y=R(re.internalFormat,ue,q,re.normalized,re.colorSpace);de(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,rt(S),Y,S.width,S.height):B?n.renderbufferStorageMultisample(n.RENDERBUFFER,rt(S),Y,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,Y,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function yt(A,S,B){const ne=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,A),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");const Q=i.get(S.depthTexture);Q.__renderTarget=S;const re=ne?S.depthTexture.image[0]:S.depthTexture.image;(!Q.__webglTexture||re.width!==S.width||re.height!==S.height)&&(re.width=S.width,re.height=S.height,S.depthTexture.needsUpdate=!0),ne?ge(S.depthTexture,0):me(S.depthTexture,0);const ue=Q.__webglTexture,q=rt(S),Y=ne?n.TEXTURE_CUBE_MAP_POSITIVE_X+B:n.TEXTURE_2D,oe=S.depthTexture.format===Qn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===ei)de(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,oe,Y,ue,0,q):n.framebufferTexture2D(n.FRAMEBUFFER,oe,Y,ue,0);else if(S.depthTexture.format===Qn)de(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,oe,Y,ue,0,q):n.framebufferTexture2D(n.FRAMEBUFFER,oe,Y,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Yt(A){const S=i.get(A),B=A.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==A.depthTexture){const ne=A.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ne){const Q=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ne.removeEventListener("dispose",Q)};ne.addEventListener("dispose",Q),S.__depthDisposeCallback=Q}S.__boundDepthTexture=ne}if(A.depthTexture&&!S.__autoAllocateDepthBuffer)if(B)for(let ne=0;ne<6;ne++)yt(S.__webglFramebuffer[ne],A,ne);else A.texture.mipmaps.length>0?yt(S.__webglFramebuffer[0],A,0):yt(S.__webglFramebuffer,A,0);else if(B){S.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ne]),S.__webglDepthbuffer[ne]===void 0)S.__webglDepthbuffer[ne]=n.createRenderbuffer(),fn(S.__webglDepthbuffer[ne],A,!1);else{const Q=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=S.__webglDepthbuffer[ne];n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,re)}}else if(A.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),fn(S.__webglDepthbuffer,A,!1);else{const Q=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,re=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,re),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,re)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Kt(A,S,B){const ne=i.get(A);S!==void 0&&at(ne.__webglFramebuffer,A,A.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),B!==void 0&&Yt(A)}function Zt(A){const S=A.texture,B=i.get(A),ne=i.get(S);A.addEventListener("dispose",H),N(A);const Q=A.textures,re=A.isWebGLCubeRenderTarget===!0,ue=Q.length>1;if(ue||(ne.__webglTexture===void 0&&(ne.__webglTexture=n.createTexture()),ne.__version=S.version,a.memory.textures++),re){B.__webglFramebuffer=[];for(let q=0;q<6;q++)if(S.mipmaps.length>0){B.__webglFramebuffer[q]=[];for(let Y=0;Y<S.mipmaps.length;Y++)B.__webglFramebuffer[q][Y]=n.createFramebuffer()}else B.__webglFramebuffer[q]=n.createFramebuffer()}else{if(S.mipmaps.length>0){B.__webglFramebuffer=[];for(let q=0;q<S.mipmaps.length;q++)B.__webglFramebuffer[q]=n.createFramebuffer()}else B.__webglFramebuffer=n.createFramebuffer();if(ue)for(let q=0,Y=Q.length;q<Y;q++){const oe=i.get(Q[q]);oe.__webglTexture===void 0&&(oe.__webglTexture=n.createTexture(),a.memory.textures++)}if(A.samples>0&&de(A)===!1){B.__webglMultisampledFramebuffer=n.createFramebuffer(),B.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let q=0;q<Q.length;q++){const Y=Q[q];B.__webglColorRenderbuffer[q]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,B.__webglColorRenderbuffer[q]);const oe=r.convert(Y.format,Y.colorSpace),P=r.convert(Y.type),J=R(Y.internalFormat,oe,P,Y.normalized,Y.colorSpace,A.isXRRenderTarget===!0),$=rt(A);n.renderbufferStorageMultisample(n.RENDERBUFFER,$,J,A.width,A.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+q,n.RENDERBUFFER,B.__webglColorRenderbuffer[q])}n.bindRenderbuffer(n.RENDERBUFFER,null),A.depthBuffer&&(B.__webglDepthRenderbuffer=n.createRenderbuffer(),fn(B.__webglDepthRenderbuffer,A,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(re){t.bindTexture(n.TEXTURE_CUBE_MAP,ne.__webglTexture),Ke(n.TEXTURE_CUBE_MAP,S);for(let q=0;q<6;q++)if(S.mipmaps.length>0)for(let Y=0;Y<S.mipmaps.length;Y++)at(B.__webglFramebuffer[q][Y],A,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Y);else at(B.__webglFramebuffer[q],A,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+q,0);w(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let q=0,Y=Q.length;q<Y;q++){const oe=Q[q],P=i.get(oe);let J=n.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(J=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(J,P.__webglTexture),Ke(J,oe),at(B.__webglFramebuffer,A,oe,n.COLOR_ATTACHMENT0+q,J,0),w(oe)&&M(J)}t.unbindTexture()}else{let q=n.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(q=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(q,ne.__webglTexture),Ke(q,S),S.mipmaps.length>0)for(let Y=0;Y<S.mipmaps.length;Y++)at(B.__webglFramebuffer[Y],A,S,n.COLOR_ATTACHMENT0,q,Y);else at(B.__webglFramebuffer,A,S,n.COLOR_ATTACHMENT0,q,0);w(S)?M(q):S.mipmaps.length>0&&n.texParameteri(q,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}A.depthBuffer&&Yt(A)}function U(A){const S=A.textures;for(let B=0,ne=S.length;B<ne;B++){const Q=S[B];if(w(Q)&&Q.mipmapsAutoUpdate===!0){const re=T(A),ue=i.get(Q).__webglTexture;t.bindTexture(re,ue),M(re),t.unbindTexture()}}}const Jt=[];function st(A){if(A.samples>0){if(de(A)===!1){const S=A.textures,B=A.width,ne=A.height;let Q=n.COLOR_BUFFER_BIT;const re=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ue=i.get(A),q=S.length>1;if(q)for(let oe=0;oe<S.length;oe++)t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let oe=0;oe<S.length;oe++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(Q|=n.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(Q|=n.STENCIL_BUFFER_BIT)),q){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ue.__webglColorRenderbuffer[oe]);const P=i.get(S[oe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,P,0)}n.blitFramebuffer(0,0,B,ne,0,0,B,ne,Q,n.NEAREST),l===!0&&(Jt.length=0,Jt.push(n.COLOR_ATTACHMENT0+oe),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&Jt.push(re),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Jt))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),q)for(let oe=0;oe<S.length;oe++){t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.RENDERBUFFER,ue.__webglColorRenderbuffer[oe]);const P=i.get(S[oe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ue.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+oe,n.TEXTURE_2D,P,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){const S=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function rt(A){return Math.min(s.maxSamples,A.samples)}function de(A){const S=i.get(A);return A.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function xt(A){const S=a.render.frame;u.get(A)!==S&&(u.set(A,S),A.update())}function Re(A,S){const B=A.colorSpace,ne=A.format,Q=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||B!==hs&&B!==Kn&&(Ve.getTransfer(B)===Je?(ne!==tn||Q!==en)&&Pe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):qe("WebGLTextures: Unsupported texture color space:",B)),S}function Le(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=Ie,this.resetTextureUnits=j,this.getTextureUnits=ee,this.setTextureUnits=ye,this.setTexture2D=me,this.setTexture2DArray=xe,this.setTexture3D=Ae,this.setTextureCube=ge,this.rebindTextures=Kt,this.setupRenderTarget=Zt,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=st,this.setupDepthRenderbuffer=Yt,this.setupFrameBufferTexture=at,this.useMultisampledRTT=de,this.dispose=F}function kv(n,e){function t(i,s=Kn){let r;const a=Ve.getTransfer(s);if(i===en)return n.UNSIGNED_BYTE;if(i===nl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===il)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ch)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ph)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Ah)return n.BYTE;if(i===Rh)return n.SHORT;if(i===us)return n.UNSIGNED_SHORT;if(i===tl)return n.INT;if(i===En)return n.UNSIGNED_INT;if(i===Ot)return n.FLOAT;if(i===Vt)return n.HALF_FLOAT;if(i===Lh)return n.ALPHA;if(i===Dh)return n.RGB;if(i===tn)return n.RGBA;if(i===ei)return n.DEPTH_COMPONENT;if(i===Qn)return n.DEPTH_STENCIL;if(i===kr)return n.RED;if(i===sl)return n.RED_INTEGER;if(i===_i)return n.RG;if(i===rl)return n.RG_INTEGER;if(i===al)return n.RGBA_INTEGER;if(i===nr||i===ir||i===sr||i===rr)if(a===Je)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===nr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ir)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===sr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===rr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===nr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ir)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===sr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===rr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ya||i===Ka||i===Za||i===Ja)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ya)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ka)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Za)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ja)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Qa||i===ja||i===eo||i===to||i===no||i===xr||i===io)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Qa||i===ja)return a===Je?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===eo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===to)return r.COMPRESSED_R11_EAC;if(i===no)return r.COMPRESSED_SIGNED_R11_EAC;if(i===xr)return r.COMPRESSED_RG11_EAC;if(i===io)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===so||i===ro||i===ao||i===oo||i===lo||i===co||i===uo||i===ho||i===fo||i===po||i===mo||i===go||i===_o||i===vo)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===so)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ro)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ao)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===oo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===lo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===co)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===uo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===ho)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===po)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===mo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===go)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===_o)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===vo)return a===Je?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===xo||i===So||i===Mo)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===xo)return a===Je?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===So)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Mo)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===yo||i===Eo||i===Sr||i===bo)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===yo)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Eo)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Sr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===bo)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Bi?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}const zv=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Hv=`
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

}`;class Gv{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const i=new Wh(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new xi({vertexShader:zv,fragmentShader:Hv,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ti(new Hr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class Vv extends Si{constructor(e,t){super();const i=this;let s=null,r=1,a=null,o="local-floor",l=1,c=null,u=null,p=null,h=null,d=null,_=null;const v=typeof XRWebGLBinding<"u",m=new Gv,f={},x=t.getContextAttributes();let w=null,M=null;const T=[],R=[],g=new Xe;let E=null,N=null;const C=new gn;C.viewport=new lt;const L=new gn;L.viewport=new lt;const H=[C,L],W=new tm;let I=null,F=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let me=T[Z];return me===void 0&&(me=new ha,T[Z]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Z){let me=T[Z];return me===void 0&&(me=new ha,T[Z]=me),me.getGripSpace()},this.getHand=function(Z){let me=T[Z];return me===void 0&&(me=new ha,T[Z]=me),me.getHandSpace()};function K(Z){const me=R.indexOf(Z.inputSource);if(me===-1)return;const xe=T[me];xe!==void 0&&(xe.update(Z.inputSource,Z.frame,c||a),xe.dispatchEvent({type:Z.type,data:Z.inputSource}))}function k(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",te);for(let Z=0;Z<T.length;Z++){const me=R[Z];me!==null&&(R[Z]=null,T[Z].disconnect(me))}I=null,F=null,m.reset();for(const Z in f)delete f[Z];if(e.setRenderTarget(w),d=null,h=null,p=null,s=null,M=null,Ie.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(g.width,g.height,!1),N!==null){const Z=N.camera;Z.fov=N.fov,Z.zoom=N.zoom,Z.updateProjectionMatrix(),N=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,i.isPresenting===!0&&Pe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){o=Z,i.isPresenting===!0&&Pe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return p===null&&v&&(p=new XRWebGLBinding(s,t)),p},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(w=e.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",k),s.addEventListener("inputsourceschange",te),x.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(g),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ae=null,ge=null;x.depth&&(ge=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=x.stencil?Qn:ei,Ae=x.stencil?Bi:En);const Ue={colorFormat:t.RGBA8,depthFormat:ge,scaleFactor:r};p=this.getBinding(),h=p.createProjectionLayer(Ue),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),M=new dn(h.textureWidth,h.textureHeight,{format:tn,type:en,depthTexture:new ki(h.textureWidth,h.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{const xe={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new dn(d.framebufferWidth,d.framebufferHeight,{format:tn,type:en,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),Ie.setContext(s),Ie.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function te(Z){for(let me=0;me<Z.removed.length;me++){const xe=Z.removed[me],Ae=R.indexOf(xe);Ae>=0&&(R[Ae]=null,T[Ae].disconnect(xe))}for(let me=0;me<Z.added.length;me++){const xe=Z.added[me];let Ae=R.indexOf(xe);if(Ae===-1){for(let Ue=0;Ue<T.length;Ue++)if(Ue>=R.length){R.push(xe),Ae=Ue;break}else if(R[Ue]===null){R[Ue]=xe,Ae=Ue;break}if(Ae===-1)break}const ge=T[Ae];ge&&ge.connect(xe)}}function X(Z,me){me===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(me.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let me=Z.near,xe=Z.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),W.near=L.near=C.near=me,W.far=L.far=C.far=xe,(I!==W.near||F!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),I=W.near,F=W.far),W.layers.mask=Z.layers.mask|6,C.layers.mask=W.layers.mask&-5,L.layers.mask=W.layers.mask&-3;const Ae=Z.parent,ge=W.cameras;X(W,Ae);for(let Ue=0;Ue<ge.length;Ue++)X(ge[Ue],Ae);W.projectionMatrix.copy(C.projectionMatrix),W.projectionMatrixInverse.copy(C.projectionMatrixInverse),N===null&&Z.isPerspectiveCamera&&(N={camera:Z,fov:Z.fov,zoom:Z.zoom}),j(Z,W,Ae)};function j(Z,me,xe){xe===null?Z.matrix.copy(me.matrixWorld):(Z.matrix.copy(xe.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(me.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(me.projectionMatrix),Z.projectionMatrixInverse.copy(me.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=To*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(Z){l=Z,h!==null&&(h.fixedFoveation=Z),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Z)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(Z){return f[Z]};let ee=null;function ye(Z,me){if(u=me.getViewerPose(c||a),_=me,u!==null){const xe=u.views;d!==null&&(e.setRenderTargetFramebuffer(M,d.framebuffer),e.setRenderTarget(M));let Ae=!1;xe.length!==W.cameras.length&&(W.cameras.length=0,Ae=!0);for(let Ce=0;Ce<xe.length;Ce++){const Ke=xe[Ce];let Qe=null;if(d!==null)Qe=d.getViewport(Ke);else{const At=p.getViewSubImage(h,Ke);Qe=At.viewport,Ce===0&&(e.setRenderTargetTextures(M,At.colorTexture,At.depthStencilTexture),e.setRenderTarget(M))}let ke=H[Ce];ke===void 0&&(ke=new gn,ke.layers.enable(Ce),ke.viewport=new lt,H[Ce]=ke),ke.matrix.fromArray(Ke.transform.matrix),ke.matrix.decompose(ke.position,ke.quaternion,ke.scale),ke.projectionMatrix.fromArray(Ke.projectionMatrix),ke.projectionMatrixInverse.copy(ke.projectionMatrix).invert(),ke.viewport.set(Qe.x,Qe.y,Qe.width,Qe.height),Ce===0&&(W.matrix.copy(ke.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Ae===!0&&W.cameras.push(ke)}const ge=s.enabledFeatures;if(ge&&ge.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){p=i.getBinding();const Ce=p.getDepthInformation(xe[0]);Ce&&Ce.isValid&&Ce.texture&&m.init(Ce,s.renderState)}if(ge&&ge.includes("camera-access")&&v){e.state.unbindTexture(),p=i.getBinding();for(let Ce=0;Ce<xe.length;Ce++){const Ke=xe[Ce].camera;if(Ke){let Qe=f[Ke];Qe||(Qe=new Wh,f[Ke]=Qe);const ke=p.getCameraImage(Ke);Qe.sourceTexture=ke}}}}for(let xe=0;xe<T.length;xe++){const Ae=R[xe],ge=T[xe];Ae!==null&&ge!==void 0&&ge.update(Ae,me,c||a)}ee&&ee(Z,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),_=null}const Ie=new qh;Ie.setAnimationLoop(ye),this.setAnimationLoop=function(Z){ee=Z},this.dispose=function(){}}}const Wv=new ft,id=new De;id.set(-1,0,0,0,1,0,0,0,1);function Xv(n,e){function t(m,f){m.matrixAutoUpdate===!0&&m.updateMatrix(),f.value.copy(m.matrix)}function i(m,f){f.color.getRGB(m.fogColor.value,Xh(n)),f.isFog?(m.fogNear.value=f.near,m.fogFar.value=f.far):f.isFogExp2&&(m.fogDensity.value=f.density)}function s(m,f,x,w,M){f.isNodeMaterial?f.uniformsNeedUpdate=!1:f.isMeshBasicMaterial?r(m,f):f.isMeshLambertMaterial?(r(m,f),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)):f.isMeshToonMaterial?(r(m,f),p(m,f)):f.isMeshPhongMaterial?(r(m,f),u(m,f),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)):f.isMeshStandardMaterial?(r(m,f),h(m,f),f.isMeshPhysicalMaterial&&d(m,f,M)):f.isMeshMatcapMaterial?(r(m,f),_(m,f)):f.isMeshDepthMaterial?r(m,f):f.isMeshDistanceMaterial?(r(m,f),v(m,f)):f.isMeshNormalMaterial?r(m,f):f.isLineBasicMaterial?(a(m,f),f.isLineDashedMaterial&&o(m,f)):f.isPointsMaterial?l(m,f,x,w):f.isSpriteMaterial?c(m,f):f.isShadowMaterial?(m.color.value.copy(f.color),m.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(m,f){m.opacity.value=f.opacity,f.color&&m.diffuse.value.copy(f.color),f.emissive&&m.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(m.map.value=f.map,t(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,t(f.alphaMap,m.alphaMapTransform)),f.bumpMap&&(m.bumpMap.value=f.bumpMap,t(f.bumpMap,m.bumpMapTransform),m.bumpScale.value=f.bumpScale,f.side===Ht&&(m.bumpScale.value*=-1)),f.normalMap&&(m.normalMap.value=f.normalMap,t(f.normalMap,m.normalMapTransform),m.normalScale.value.copy(f.normalScale),f.side===Ht&&m.normalScale.value.negate()),f.displacementMap&&(m.displacementMap.value=f.displacementMap,t(f.displacementMap,m.displacementMapTransform),m.displacementScale.value=f.displacementScale,m.displacementBias.value=f.displacementBias),f.emissiveMap&&(m.emissiveMap.value=f.emissiveMap,t(f.emissiveMap,m.emissiveMapTransform)),f.specularMap&&(m.specularMap.value=f.specularMap,t(f.specularMap,m.specularMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest);const x=e.get(f),w=x.envMap,M=x.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(Wv.makeRotationFromEuler(M)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(id),m.reflectivity.value=f.reflectivity,m.ior.value=f.ior,m.refractionRatio.value=f.refractionRatio),f.lightMap&&(m.lightMap.value=f.lightMap,m.lightMapIntensity.value=f.lightMapIntensity,t(f.lightMap,m.lightMapTransform)),f.aoMap&&(m.aoMap.value=f.aoMap,m.aoMapIntensity.value=f.aoMapIntensity,t(f.aoMap,m.aoMapTransform))}function a(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,f.map&&(m.map.value=f.map,t(f.map,m.mapTransform))}function o(m,f){m.dashSize.value=f.dashSize,m.totalSize.value=f.dashSize+f.gapSize,m.scale.value=f.scale}function l(m,f,x,w){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.size.value=f.size*x,m.scale.value=w*.5,f.map&&(m.map.value=f.map,t(f.map,m.uvTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,t(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function c(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.rotation.value=f.rotation,f.map&&(m.map.value=f.map,t(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,t(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function u(m,f){m.specular.value.copy(f.specular),m.shininess.value=Math.max(f.shininess,1e-4)}function p(m,f){f.gradientMap&&(m.gradientMap.value=f.gradientMap)}function h(m,f){m.metalness.value=f.metalness,f.metalnessMap&&(m.metalnessMap.value=f.metalnessMap,t(f.metalnessMap,m.metalnessMapTransform)),m.roughness.value=f.roughness,f.roughnessMap&&(m.roughnessMap.value=f.roughnessMap,t(f.roughnessMap,m.roughnessMapTransform)),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)}function d(m,f,x){m.ior.value=f.ior,f.diffuseRoughness>0&&(m.diffuseRoughness.value=f.diffuseRoughness,f.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=f.diffuseRoughnessMap,t(f.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),f.sheen>0&&(m.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),m.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(m.sheenColorMap.value=f.sheenColorMap,t(f.sheenColorMap,m.sheenColorMapTransform)),f.sheenRoughnessMap&&(m.sheenRoughnessMap.value=f.sheenRoughnessMap,t(f.sheenRoughnessMap,m.sheenRoughnessMapTransform))),f.clearcoat>0&&(m.clearcoat.value=f.clearcoat,m.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(m.clearcoatMap.value=f.clearcoatMap,t(f.clearcoatMap,m.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,t(f.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(m.clearcoatNormalMap.value=f.clearcoatNormalMap,t(f.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===Ht&&m.clearcoatNormalScale.value.negate())),f.dispersion>0&&(m.dispersion.value=f.dispersion),f.retroreflectivity>0&&(m.retroreflectivity.value=f.retroreflectivity),f.iridescence>0&&(m.iridescence.value=f.iridescence,m.iridescenceIOR.value=f.iridescenceIOR,m.iridescenceThicknessMinimum.value=f.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=f.iridescenceThicknessMaximum,f.iridescenceMap&&(m.iridescenceMap.value=f.iridescenceMap,t(f.iridescenceMap,m.iridescenceMapTransform)),f.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=f.iridescenceThicknessMap,t(f.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),f.transmission>0&&(m.transmission.value=f.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),f.transmissionMap&&(m.transmissionMap.value=f.transmissionMap,t(f.transmissionMap,m.transmissionMapTransform)),m.thickness.value=f.thickness,f.thicknessMap&&(m.thicknessMap.value=f.thicknessMap,t(f.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=f.attenuationDistance,m.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(m.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(m.anisotropyMap.value=f.anisotropyMap,t(f.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=f.specularIntensity,m.specularColor.value.copy(f.specularColor),f.specularColorMap&&(m.specularColorMap.value=f.specularColorMap,t(f.specularColorMap,m.specularColorMapTransform)),f.specularIntensityMap&&(m.specularIntensityMap.value=f.specularIntensityMap,t(f.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,f){f.matcap&&(m.matcap.value=f.matcap)}function v(m,f){const x=e.get(f).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function $v(n,e,t,i){let s={},r={};function a(x,w){const M=w.program;i.uniformBlockBinding(x,M,s[x.id])}function o(x,w){let M=s[x.id];M===void 0&&(_(x),M=l(x),s[x.id]=M,x.addEventListener("dispose",m));const T=w.program;i.updateUBOMapping(x,T);const R=e.render.frame;r[x.id]!==R&&(c(x),r[x.id]=R)}function l(x){const w=n.createBuffer(),M=x.__size,T=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,M,T),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(x){const w=s[x.id],M=x.uniforms,T=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let R=0,g=M.length;R<g;R++){const E=M[R];if(Array.isArray(E))for(let N=0,C=E.length;N<C;N++)u(E[N],R,N,T);else u(E,R,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,w,M,T){if(h(x,w,M,T)===!0){const R=x.__offset,g=x.value;if(Array.isArray(g)){let E=0;for(let N=0;N<g.length;N++){const C=g[N],L=v(C,!0);p(C,x.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else p(g,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,R,x.__data)}}function p(x,w,M){typeof x=="number"||typeof x=="boolean"?w[M]=x:x.isMatrix3?(w[M]=x.elements[0],w[M+1]=x.elements[1],w[M+2]=x.elements[2],w[M+3]=0,w[M+4]=x.elements[3],w[M+5]=x.elements[4],w[M+6]=x.elements[5],w[M+7]=0,w[M+8]=x.elements[6],w[M+9]=x.elements[7],w[M+10]=x.elements[8],w[M+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-M),M):x.toArray(w,M)}function h(x,w,M,T){const R=x.value,g=w+"_"+M;if(Array.isArray(R)){T[g]===void 0&&(T[g]=[]);const E=T[g];let N=!1;for(let C=0;C<R.length;C++)d(R[C],E,C)===!0&&(N=!0);return N}return d(R,T,g)}function d(x,w,M){if(w[M]===void 0)return typeof x=="number"||typeof x=="boolean"?w[M]=x:ArrayBuffer.isView(x)?w[M]=x.slice():w[M]=x.clone(),!0;{const T=w[M];if(typeof x=="number"||typeof x=="boolean"){if(T!==x)return w[M]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(T.equals(x)===!1)return T.copy(x),!0}}return!1}function _(x){const w=x.uniforms;let M=0;const T=16;for(let g=0,E=w.length;g<E;g++){const N=Array.isArray(w[g])?w[g]:[w[g]];for(let C=0,L=N.length;C<L;C++){const H=N[C],W=Array.isArray(H.value)?H.value:[H.value],I=Array.isArray(w[g])||Array.isArray(H.value);let F=M;for(let k=0,te=W.length;k<te;k++){const X=W[k],j=v(X,I),ee=M%T,ye=ee%j.boundary,Ie=ee+ye;M+=ye,Ie!==0&&T-Ie<j.storage&&(M+=T-Ie),k===0&&(F=M),M+=j.storage}const K=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new K((M-F)/Float32Array.BYTES_PER_ELEMENT),H.__offset=F}}const R=M%T;return R>0&&(M+=T-R),x.__size=M,x.__cache={},this}function v(x,w){const M={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(M.boundary=4,M.storage=4):x.isVector2?(M.boundary=8,M.storage=8):x.isVector3||x.isColor?(M.boundary=16,M.storage=12):x.isVector4?(M.boundary=16,M.storage=16):x.isMatrix3?(M.boundary=16,M.storage=48):x.isMatrix4?(M.boundary=16,M.storage=64):x.isTexture?Pe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(M.boundary=16,M.storage=x.byteLength):Pe("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(x){const w=x.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function f(){for(const x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:a,update:o,dispose:f}}const qv=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let mn=null;function Yv(){return mn===null&&(mn=new Ro(qv,16,16,_i,Vt),mn.name="DFG_LUT",mn.minFilter=Ct,mn.magFilter=Ct,mn.wrapS=xn,mn.wrapT=xn,mn.generateMipmaps=!1,mn.needsUpdate=!0),mn}class Kv{constructor(e={}){const{canvas:t=pp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:p=!1,reversedDepthBuffer:h=!1,outputBufferType:d=en}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=a;const v=d,m=new Set([al,rl,sl]),f=new Set([en,En,us,Bi,nl,il]),x=new Uint32Array(4),w=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]};let T=null,R=null;const g=[],E=[];let N=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=In,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const C=this;let L=!1,H=null,W=null,I=null,F=null;this._outputColorSpace=jt;let K=0,k=0,te=null,X=-1,j=null;const ee=new lt,ye=new lt;let Ie=null;const Z=new Ye(0);let me=0,xe=t.width,Ae=t.height,ge=1,Ue=null,pt=null;const Ce=new lt(0,0,xe,Ae),Ke=new lt(0,0,xe,Ae);let Qe=!1;const ke=new br,At=new ul;let vt=!1,kt=!1;const at=new ft,fn=new V,yt=new lt,Yt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Kt=!1;function Zt(){return te===null?ge:1}let U=i;function Jt(y,D){return t.getContext(y,D)}let st,rt,de,xt,Re,Le,A,S,B,ne,Q,re,ue,q,Y,oe,P,J,$,le,se,ae,be;try{const y={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:p};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${el}`),t.addEventListener("webglcontextlost",Te,!1),t.addEventListener("webglcontextrestored",Fe,!1),t.addEventListener("webglcontextcreationerror",fe,!1),U===null){const D="webgl2";if(U=Jt(D,y),U===null)throw Jt(D)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Oe()}catch(y){throw t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",fe,!1),qe("WebGLRenderer: "+y.message),y}function Oe(){st=new Q_(U),st.init(),se=new kv(U,st),rt=new H_(U,st,e,se),de=new Ov(U,st),rt.reversedDepthBuffer&&h&&de.buffers.depth.setReversed(!0),W=U.createFramebuffer(),I=U.createFramebuffer(),F=U.createFramebuffer(),xt=new t0(U),Re=new Ev,Le=new Bv(U,st,de,Re,rt,se,xt),A=new J_(C),S=new im(U),ae=new k_(U,S),B=new j_(U,S,xt,ae),ne=new i0(U,B,S,ae,xt),J=new n0(U,rt,Le),Y=new G_(Re),Q=new yv(C,A,st,rt,ae,Y),re=new Xv(C,Re),ue=new wv,q=new Lv(st),P=new B_(C,A,de,ne,_,l),oe=new Fv(C,ne,rt),be=new $v(U,xt,rt,de),$=new z_(U,st,xt),le=new e0(U,st,xt),xt.programs=Q.programs,C.capabilities=rt,C.extensions=st,C.properties=Re,C.renderLists=ue,C.shadowMap=oe,C.state=de,C.info=xt}v!==en&&(N=new r0(v,t.width,t.height,o,s,r));const ie=new Vv(C,U);this.xr=ie,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){const y=st.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){const y=st.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return ge},this.setPixelRatio=function(y){y!==void 0&&(ge=y,this.setSize(xe,Ae,!1))},this.getSize=function(y){return y.set(xe,Ae)},this.setSize=function(y,D,G=!0){if(ie.isPresenting){Pe("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=y,Ae=D,t.width=Math.floor(y*ge),t.height=Math.floor(D*ge),G===!0&&(t.style.width=y+"px",t.style.height=D+"px"),N!==null&&N.setSize(t.width,t.height),this.setViewport(0,0,y,D)},this.getDrawingBufferSize=function(y){return y.set(xe*ge,Ae*ge).floor()},this.setDrawingBufferSize=function(y,D,G){xe=y,Ae=D,ge=G,t.width=Math.floor(y*G),t.height=Math.floor(D*G),this.setViewport(0,0,y,D)},this.setEffects=function(y){if(v===en){qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(y){for(let D=0;D<y.length;D++)if(y[D].isOutputPass===!0){Pe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(y||[])},this.getCurrentViewport=function(y){return y.copy(ee)},this.getViewport=function(y){return y.copy(Ce)},this.setViewport=function(y,D,G,O){y.isVector4?Ce.set(y.x,y.y,y.z,y.w):Ce.set(y,D,G,O),de.viewport(ee.copy(Ce).multiplyScalar(Zt()).round())},this.getScissor=function(y){return y.copy(Ke)},this.setScissor=function(y,D,G,O){y.isVector4?Ke.set(y.x,y.y,y.z,y.w):Ke.set(y,D,G,O),de.scissor(ye.copy(Ke).multiplyScalar(Zt()).round())},this.getScissorTest=function(){return Qe},this.setScissorTest=function(y){de.setScissorTest(Qe=y)},this.setOpaqueSort=function(y){Ue=y},this.setTransparentSort=function(y){pt=y},this.getClearColor=function(y){return y.copy(P.getClearColor())},this.setClearColor=function(){P.setClearColor(...arguments)},this.getClearAlpha=function(){return P.getClearAlpha()},this.setClearAlpha=function(){P.setClearAlpha(...arguments)},this.clear=function(y=!0,D=!0,G=!0){let O=0;if(y){let z=!1;if(te!==null){const he=te.texture.format;z=m.has(he)}if(z){const he=te.texture.type,ve=f.has(he),ce=P.getClearColor(),_e=P.getClearAlpha(),Ee=ce.r,Ne=ce.g,ze=ce.b;ve?(x[0]=Ee,x[1]=Ne,x[2]=ze,x[3]=_e,U.clearBufferuiv(U.COLOR,0,x)):(w[0]=Ee,w[1]=Ne,w[2]=ze,w[3]=_e,U.clearBufferiv(U.COLOR,0,w))}else O|=U.COLOR_BUFFER_BIT}D&&(O|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),G&&(O|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),O!==0&&U.clear(O)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(y){y.setRenderer(this),H=y},this.dispose=function(){t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",fe,!1),P.dispose(),ue.dispose(),q.dispose(),Le.dispose(),Re.dispose(),A.dispose(),ne.dispose(),B.dispose(),ae.dispose(),be.dispose(),Q.dispose(),ie.dispose(),ie.removeEventListener("sessionstart",Ml),ie.removeEventListener("sessionend",yl),ii.stop()};function Te(y){y.preventDefault(),oc("WebGLRenderer: Context Lost."),L=!0}function Fe(){oc("WebGLRenderer: Context Restored."),L=!1;const y=xt.autoReset,D=oe.enabled,G=oe.autoUpdate,O=oe.needsUpdate,z=oe.type;Oe(),xt.autoReset=y,oe.enabled=D,oe.autoUpdate=G,oe.needsUpdate=O,oe.type=z}function fe(y){qe("WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function Ze(y){const D=y.target;D.removeEventListener("dispose",Ze),Et(D)}function Et(y){kn(y),Re.remove(y)}function kn(y){const D=Re.get(y).programs;D!==void 0&&(D.forEach(function(G){Q.releaseProgram(G)}),y.isShaderMaterial&&Q.releaseShaderCache(y))}this.renderBufferDirect=function(y,D,G,O,z,he){D===null&&(D=Yt);const ve=z.isMesh&&z.matrixWorld.determinantAffine()<0,ce=md(y,D,G,O,z);de.setMaterial(O,ve);let _e=G.index,Ee=1;if(O.wireframe===!0){if(_e=B.getWireframeAttribute(G),_e===void 0)return;Ee=2}const Ne=G.drawRange,ze=G.attributes.position;let Se=Ne.start*Ee,He=(Ne.start+Ne.count)*Ee;he!==null&&(Se=Math.max(Se,he.start*Ee),He=Math.min(He,(he.start+he.count)*Ee)),_e!==null?(Se=Math.max(Se,0),He=Math.min(He,_e.count)):ze!=null&&(Se=Math.max(Se,0),He=Math.min(He,ze.count));const mt=He-Se;if(mt<0||mt===1/0)return;ae.setup(z,O,ce,G,_e);let nt,je=$;if(_e!==null&&(nt=S.get(_e),je=le,je.setIndex(nt)),z.isMesh)O.wireframe===!0?(de.setLineWidth(O.wireframeLinewidth*Zt()),je.setMode(U.LINES)):je.setMode(U.TRIANGLES);else if(z.isLine){let Pt=O.linewidth;Pt===void 0&&(Pt=1),de.setLineWidth(Pt*Zt()),z.isLineSegments?je.setMode(U.LINES):z.isLineLoop?je.setMode(U.LINE_LOOP):je.setMode(U.LINE_STRIP)}else z.isPoints?je.setMode(U.POINTS):z.isSprite&&je.setMode(U.TRIANGLES);if(z.isBatchedMesh)if(st.get("WEBGL_multi_draw"))je.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{const Pt=z._multiDrawStarts,Me=z._multiDrawCounts,Nt=z._multiDrawCount,$e=_e?S.get(_e).bytesPerElement:1,si=Re.get(O).currentProgram.getUniforms();for(let Lt=0;Lt<Nt;Lt++)si.setValue(U,"_gl_DrawID",Lt),je.render(Pt[Lt]/$e,Me[Lt])}else if(z.isInstancedMesh)je.renderInstances(Se,mt,z.count);else if(G.isInstancedBufferGeometry){const Pt=G._maxInstanceCount!==void 0?G._maxInstanceCount:1/0,Me=Math.min(G.instanceCount,Pt);je.renderInstances(Se,mt,Me)}else je.render(Se,mt)};function Sl(y,D,G,O){H!==null&&y.isNodeMaterial&&H.setObject(O,y),vt===!0&&Y.setState(y,G,!1),y.transparent===!0&&y.side===vn&&y.forceSinglePass===!1?(y.side=Ht,y.needsUpdate=!0,Yi(y,D,O),y.side=gi,y.needsUpdate=!0,Yi(y,D,O),y.side=vn):Yi(y,D,O)}this.compile=function(y,D,G=null){G===null&&(G=y),H!==null&&H.renderStart(y,D,G),R=q.get(G),R.init(D),E.push(R),G.traverseVisible(function(z){z.isLight&&z.layers.test(D.layers)&&(R.pushLight(z),z.castShadow&&R.pushShadow(z))}),y!==G&&y.traverseVisible(function(z){z.isLight&&z.layers.test(D.layers)&&(R.pushLight(z),z.castShadow&&R.pushShadow(z))}),R.setupLights(),H!==null&&H.updateLights(R.state.lightsArray),kt=this.localClippingEnabled,vt=Y.init(this.clippingPlanes,kt),vt===!0&&Y.setGlobalState(this.clippingPlanes,D),H!==null&&oe.render(R.state.shadowsArray,G,D);const O=new Set;return y.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;const he=z.material;if(he)if(Array.isArray(he))for(let ve=0;ve<he.length;ve++){const ce=he[ve];Sl(ce,G,D,z),O.add(ce)}else Sl(he,G,D,z),O.add(he)}),R=E.pop(),H!==null&&H.renderEnd(),O},this.compileAsync=function(y,D,G=null){const O=this.compile(y,D,G);return new Promise(z=>{function he(){if(O.forEach(function(ve){const _e=Re.get(ve).currentProgram;(_e===void 0||_e.isReady())&&O.delete(ve)}),O.size===0){z(y);return}setTimeout(he,10)}st.get("KHR_parallel_shader_compile")!==null?he():setTimeout(he,10)})};let qr=null;function fd(y){qr&&qr(y)}function Ml(){ii.stop()}function yl(){ii.start()}const ii=new qh;ii.setAnimationLoop(fd),typeof self<"u"&&ii.setContext(self),this.setAnimationLoop=function(y){qr=y,ie.setAnimationLoop(y),y===null?ii.stop():ii.start()},ie.addEventListener("sessionstart",Ml),ie.addEventListener("sessionend",yl),this.render=function(y,D){if(D!==void 0&&D.isCamera!==!0){qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;H!==null&&H.renderStart(y,D);const G=ie.enabled===!0&&ie.isPresenting===!0,O=N!==null&&(te===null||G)&&N.begin(C,te);if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),D.parent===null&&D.matrixWorldAutoUpdate===!0&&D.updateMatrixWorld(),ie.enabled===!0&&ie.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ie.cameraAutoUpdate===!0&&ie.updateCamera(D),D=ie.getCamera()),y.isScene===!0&&y.onBeforeRender(C,y,D,te),R=q.get(y,E.length),R.init(D),R.state.textureUnits=Le.getTextureUnits(),E.push(R),at.multiplyMatrices(D.projectionMatrix,D.matrixWorldInverse),D.isArrayCamera?At.setFromArrayCamera(D):ke.setFromProjectionMatrix(at,hn,D.reversedDepth),kt=this.localClippingEnabled,vt=Y.init(this.clippingPlanes,kt),T=ue.get(y,g.length),T.init(),g.push(T),this.info.render.frame++,ie.enabled===!0&&ie.isPresenting===!0){const ve=C.xr.getDepthSensingMesh();ve!==null&&Yr(ve,D,-1/0,C.sortObjects)}Yr(y,D,0,C.sortObjects),T.finish(),H!==null&&H.updateLights(R.state.lightsArray),C.sortObjects===!0&&T.sort(Ue,pt),Kt=ie.enabled===!1||ie.isPresenting===!1||ie.hasDepthSensing()===!1,Kt&&P.addToRenderList(T,y),this.info.autoReset===!0&&this.info.reset(),vt===!0&&Y.beginShadows();const z=R.state.shadowsArray;if(oe.render(z,y,D),vt===!0&&Y.endShadows(),(O&&N.hasRenderPass())===!1){const ve=T.opaque,ce=T.transmissive;if(R.setupLights(),D.isArrayCamera){const _e=D.cameras;if(ce.length>0)for(let Ee=0,Ne=_e.length;Ee<Ne;Ee++){const ze=_e[Ee];bl(ve,ce,y,ze)}Kt&&P.render(y);for(let Ee=0,Ne=_e.length;Ee<Ne;Ee++){const ze=_e[Ee];El(T,y,ze,ze.viewport)}}else ce.length>0&&bl(ve,ce,y,D),Kt&&P.render(y),El(T,y,D)}te!==null&&k===0&&(Le.updateMultisampleRenderTarget(te),Le.updateRenderTargetMipmap(te)),O&&N.end(C),y.isScene===!0&&y.onAfterRender(C,y,D),ae.resetDefaultState(),X=-1,j=null,E.pop(),E.length>0?(R=E[E.length-1],Le.setTextureUnits(R.state.textureUnits),vt===!0&&Y.setGlobalState(C.clippingPlanes,R.state.camera)):R=null,g.pop(),g.length>0?T=g[g.length-1]:T=null,H!==null&&H.renderEnd()};function Yr(y,D,G,O){if(y.visible===!1)return;if(y.layers.test(D.layers)){if(y.isGroup)G=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(D);else if(y.isLight)R.pushLight(y),y.castShadow&&R.pushShadow(y);else if(y.isSprite){const ve=D.isArrayCamera?At:ke;if(!y.frustumCulled||y.intersectsFrustum(ve)){O&&yt.setFromMatrixPosition(y.matrixWorld).applyMatrix4(at);const ce=ne.update(y),_e=y.material;_e.visible&&T.push(y,ce,_e,G,yt.z,null,D)}}else if(y.isMesh||y.isLine||y.isPoints){const ve=D.isArrayCamera?At:ke;if(!y.frustumCulled||y.intersectsFrustum(ve)){const ce=ne.update(y),_e=y.material;if(O&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),yt.copy(y.boundingSphere.center)):(ce.boundingSphere===null&&ce.computeBoundingSphere(),yt.copy(ce.boundingSphere.center)),yt.applyMatrix4(y.matrixWorld).applyMatrix4(at)),Array.isArray(_e)){const Ee=ce.groups;for(let Ne=0,ze=Ee.length;Ne<ze;Ne++){const Se=Ee[Ne],He=_e[Se.materialIndex];He&&He.visible&&T.push(y,ce,He,G,yt.z,Se,D)}}else _e.visible&&T.push(y,ce,_e,G,yt.z,null,D)}}}const he=y.children;for(let ve=0,ce=he.length;ve<ce;ve++)Yr(he[ve],D,G,O)}function El(y,D,G,O){const{opaque:z,transmissive:he,transparent:ve}=y;R.setupLightsView(G),vt===!0&&Y.setGlobalState(C.clippingPlanes,G),O&&de.viewport(ee.copy(O)),z.length>0&&vs(z,D,G),he.length>0&&vs(he,D,G),ve.length>0&&vs(ve,D,G),de.buffers.depth.setTest(!0),de.buffers.depth.setMask(!0),de.buffers.color.setMask(!0),de.setPolygonOffset(!1)}function bl(y,D,G,O){if((G.isScene===!0?G.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[O.id]===void 0){const Se=st.has("EXT_color_buffer_half_float")||st.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[O.id]=new dn(1,1,{generateMipmaps:!0,type:Se?Vt:en,minFilter:Jn,samples:Math.max(4,rt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ve.workingColorSpace})}const he=R.state.transmissionRenderTarget[O.id],ve=O.viewport||ee;he.setSize(ve.z*C.transmissionResolutionScale,ve.w*C.transmissionResolutionScale);const ce=C.getRenderTarget(),_e=C.getActiveCubeFace(),Ee=C.getActiveMipmapLevel();C.setRenderTarget(he),C.getClearColor(Z),me=C.getClearAlpha(),me<1&&C.setClearColor(16777215,.5),C.clear(),Kt&&P.render(G);const Ne=C.toneMapping;C.toneMapping=In;const ze=O.viewport;if(O.viewport!==void 0&&(O.viewport=void 0),R.setupLightsView(O),vt===!0&&Y.setGlobalState(C.clippingPlanes,O),vs(y,G,O),Le.updateMultisampleRenderTarget(he),Le.updateRenderTargetMipmap(he),st.has("WEBGL_multisampled_render_to_texture")===!1){let Se=!1;for(let He=0,mt=D.length;He<mt;He++){const nt=D[He],{object:je,geometry:Pt,material:Me,group:Nt}=nt;if(Me.side===vn&&je.layers.test(O.layers)){const $e=Me.side;Me.side=Ht,Me.needsUpdate=!0,wl(je,G,O,Pt,Me,Nt),Me.side=$e,Me.needsUpdate=!0,Se=!0}}Se===!0&&(Le.updateMultisampleRenderTarget(he),Le.updateRenderTargetMipmap(he))}C.setRenderTarget(ce,_e,Ee),C.setClearColor(Z,me),ze!==void 0&&(O.viewport=ze),C.toneMapping=Ne}function vs(y,D,G){const O=D.isScene===!0?D.overrideMaterial:null;for(let z=0,he=y.length;z<he;z++){const ve=y[z],{object:ce,geometry:_e,group:Ee}=ve;let Ne=ve.material;Ne.allowOverride===!0&&O!==null&&(Ne=O),ce.layers.test(G.layers)&&wl(ce,D,G,_e,Ne,Ee)}}function wl(y,D,G,O,z,he){H!==null&&z.isNodeMaterial&&H.setObject(y,z),y.onBeforeRender(C,D,G,O,z,he),y.modelViewMatrix.multiplyMatrices(G.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),z.onBeforeRender(C,D,G,O,y,he),z.transparent===!0&&z.side===vn&&z.forceSinglePass===!1?(z.side=Ht,z.needsUpdate=!0,C.renderBufferDirect(G,D,O,z,y,he),z.side=gi,z.needsUpdate=!0,C.renderBufferDirect(G,D,O,z,y,he),z.side=vn):C.renderBufferDirect(G,D,O,z,y,he),y.onAfterRender(C,D,G,O,z,he)}function Tl(y){let D=0;for(const G of y)G.texture!==null&&D++;return D}function Yi(y,D,G){D.isScene!==!0&&(D=Yt);const O=Re.get(y),z=R.state.lights,he=R.state.shadowsArray,ve=z.state.version,ce=Q.getParameters(y,z.state,he,D,G,R.state.lightProbeGridArray),_e=Q.getProgramCacheKey(ce);let Ee=O.programs;O.environment=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?D.environment:null,O.fog=D.fog;const Ne=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap;O.envMap=A.get(y.envMap||O.environment,Ne),O.envMapRotation=O.environment!==null&&y.envMap===null?D.environmentRotation:y.envMapRotation,Ee===void 0&&(y.addEventListener("dispose",Ze),Ee=new Map,O.programs=Ee,O.programVariants=new Map);let ze=Ee.get(_e);if(ze!==void 0){if(O.currentProgram===ze&&O.lightsStateVersion===ve)return Rl(y,ce),ze}else ce.uniforms=Q.getUniforms(y),H!==null&&y.isNodeMaterial&&H.build(y,G,ce),y.onBeforeCompile(ce,C),ze=Q.acquireProgram(ce,_e),Ee.set(_e,ze),O.uniforms=ce.uniforms;const Se=O.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(Se.clippingPlanes=Y.uniform),Rl(y,ce),O.needsLights=_d(y),O.lightsStateVersion=ve,O.needsLights&&(Se.ambientLightColor.value=z.state.ambient,Se.lightProbe.value=z.state.probe,Se.sunLights.value=z.state.sun,Se.sunLightShadows.value=z.state.sunShadow,Se.directionalLights.value=z.state.directional,Se.directionalLightShadows.value=z.state.directionalShadow,Se.spotLights.value=z.state.spot,Se.spotLightShadows.value=z.state.spotShadow,Se.rectAreaLights.value=z.state.rectArea,Se.ltc_1.value=z.state.rectAreaLTC1,Se.ltc_2.value=z.state.rectAreaLTC2,Se.pointLights.value=z.state.point,Se.pointLightShadows.value=z.state.pointShadow,Se.hemisphereLights.value=z.state.hemi,Se.sunShadowMatrix.value=z.state.sunShadowMatrix,Se.sunShadowCascade.value=z.state.sunShadowCascade,Se.directionalShadowMatrix.value=z.state.directionalShadowMatrix,Se.spotLightMatrix.value=z.state.spotLightMatrix,Se.spotLightMap.value=z.state.spotLightMap,Se.pointShadowMatrix.value=z.state.pointShadowMatrix),O.numLightProbeGrids=Tl(R.state.lightProbeGridArray),O.currentProgram=ze,O.uniformsList=null,ze}function pd(y,D,G,O,z){const he=Re.get(y),ve=he.currentProgram.id+","+O+","+z;let ce=he.programVariants.get(ve);return ce===void 0?(ce=Yi(y,D,G),he.programVariants.set(ve,ce)):(he.currentProgram=ce,he.uniformsList=null,he.outputColorSpace=O,he.toneMapping=z),ce}function Al(y){if(y.uniformsList===null){const D=y.currentProgram.getUniforms();y.uniformsList=or.seqWithValue(D.seq,y.uniforms)}return y.uniformsList}function Rl(y,D){const G=Re.get(y);G.outputColorSpace=D.outputColorSpace,G.batching=D.batching,G.batchingColor=D.batchingColor,G.instancing=D.instancing,G.instancingColor=D.instancingColor,G.instancingMorph=D.instancingMorph,G.skinning=D.skinning,G.morphTargets=D.morphTargets,G.morphNormals=D.morphNormals,G.morphColors=D.morphColors,G.morphTargetsCount=D.morphTargetsCount,G.numClippingPlanes=D.numClippingPlanes,G.numIntersection=D.numClipIntersection,G.vertexAlphas=D.vertexAlphas,G.vertexTangents=D.vertexTangents,G.toneMapping=D.toneMapping}function md(y,D,G,O,z){D.isScene!==!0&&(D=Yt),Le.resetTextureUnits();const he=D.fog,ve=O.isMeshStandardMaterial||O.isMeshLambertMaterial||O.isMeshPhongMaterial?D.environment:null,ce=te===null?C.outputColorSpace:te.isXRRenderTarget===!0?te.texture.colorSpace:Ve.workingColorSpace,_e=O.isMeshStandardMaterial||O.isMeshLambertMaterial&&!O.envMap||O.isMeshPhongMaterial&&!O.envMap,Ee=A.get(O.envMap||ve,_e),Ne=O.vertexColors===!0&&!!G.attributes.color&&G.attributes.color.itemSize===4,ze=!!G.attributes.tangent&&(!!O.normalMap||O.anisotropy>0),Se=!!G.morphAttributes.position,He=!!G.morphAttributes.normal,mt=!!G.morphAttributes.color;let nt=In;O.toneMapped&&(te===null||te.isXRRenderTarget===!0)&&(nt=C.toneMapping);const je=G.morphAttributes.position||G.morphAttributes.normal||G.morphAttributes.color,Pt=je!==void 0?je.length:0,Me=Re.get(O),Nt=R.state.lights;if(vt===!0&&(kt===!0||y!==j)){const ot=y===j&&O.id===X;Y.setState(O,y,ot)}let $e=!1,si=!1;O.version===Me.__version?Me.needsLights&&Me.lightsStateVersion!==Nt.state.version||z.isBatchedMesh&&Me.batching===!1||!z.isBatchedMesh&&Me.batching===!0||z.isBatchedMesh&&Me.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Me.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Me.instancing===!1||!z.isInstancedMesh&&Me.instancing===!0||z.isSkinnedMesh&&Me.skinning===!1||!z.isSkinnedMesh&&Me.skinning===!0||z.isInstancedMesh&&Me.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Me.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Me.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Me.instancingMorph===!1&&z.morphTexture!==null||Me.envMap!==Ee||O.fog===!0&&Me.fog!==he||Me.numClippingPlanes!==void 0&&(Me.numClippingPlanes!==Y.numPlanes||Me.numIntersection!==Y.numIntersection)||Me.vertexAlphas!==Ne||Me.vertexTangents!==ze||Me.morphTargets!==Se||Me.morphNormals!==He||Me.morphColors!==mt||Me.morphTargetsCount!==Pt||Me.numLightProbeGrids!==Tl(R.state.lightProbeGridArray)?$e=!0:(Me.outputColorSpace!==ce||Me.toneMapping!==nt)&&(si=!0):($e=!0,Me.__version=O.version);let Lt=Me.currentProgram;($e===!0||si===!0)&&(Lt=si===!0?pd(O,D,z,ce,nt):Yi(O,D,z),H&&O.isNodeMaterial&&H.onUpdateProgram(O,Lt,Me));let xs=!1,zn=!1,ri=!1;const We=Lt.getUniforms(),Rt=Me.uniforms;if(de.useProgram(Lt.program)&&(xs=!0,zn=!0,ri=!0),O.id!==X&&(X=O.id,zn=!0),xs||j!==y){de.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),We.setValue(U,"projectionMatrix",y.projectionMatrix),We.setValue(U,"viewMatrix",y.matrixWorldInverse);const bt=We.map.cameraPosition;bt!==void 0&&bt.setValue(U,fn.setFromMatrixPosition(y.matrixWorld)),rt.logarithmicDepthBuffer&&We.setValue(U,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(O.isMeshPhongMaterial||O.isMeshToonMaterial||O.isMeshLambertMaterial||O.isMeshBasicMaterial||O.isMeshStandardMaterial||O.isShaderMaterial)&&We.setValue(U,"isOrthographic",y.isOrthographicCamera===!0),j!==y&&(j=y,zn=!0,ri=!0)}if(Me.needsLights&&(Nt.state.sunShadowMap.length>0&&We.setValue(U,"sunShadowMap",Nt.state.sunShadowMap,Le),Nt.state.directionalShadowMap.length>0&&We.setValue(U,"directionalShadowMap",Nt.state.directionalShadowMap,Le),Nt.state.spotShadowMap.length>0&&We.setValue(U,"spotShadowMap",Nt.state.spotShadowMap,Le),Nt.state.pointShadowMap.length>0&&We.setValue(U,"pointShadowMap",Nt.state.pointShadowMap,Le)),z.isSkinnedMesh){We.setOptional(U,z,"bindMatrix"),We.setOptional(U,z,"bindMatrixInverse");const ot=z.skeleton;ot&&(ot.boneTexture===null&&ot.computeBoneTexture(),We.setValue(U,"boneTexture",ot.boneTexture,Le))}z.isBatchedMesh&&(We.setOptional(U,z,"batchingTexture"),We.setValue(U,"batchingTexture",z._matricesTexture,Le),We.setOptional(U,z,"batchingIdTexture"),We.setValue(U,"batchingIdTexture",z._indirectTexture,Le),We.setOptional(U,z,"batchingColorTexture"),z._colorsTexture!==null&&We.setValue(U,"batchingColorTexture",z._colorsTexture,Le));const rn=G.morphAttributes;if((rn.position!==void 0||rn.normal!==void 0||rn.color!==void 0)&&J.update(z,G,Lt),(zn||Me.receiveShadow!==z.receiveShadow)&&(Me.receiveShadow=z.receiveShadow,We.setValue(U,"receiveShadow",z.receiveShadow)),(O.isMeshStandardMaterial||O.isMeshLambertMaterial||O.isMeshPhongMaterial)&&O.envMap===null&&D.environment!==null&&(Rt.envMapIntensity.value=D.environmentIntensity),Rt.dfgLUT!==void 0&&(Rt.dfgLUT.value=Yv()),zn){if(We.setValue(U,"toneMappingExposure",C.toneMappingExposure),Me.needsLights&&gd(Rt,ri),he&&O.fog===!0&&re.refreshFogUniforms(Rt,he),re.refreshMaterialUniforms(Rt,O,ge,Ae,R.state.transmissionRenderTarget[y.id]),Me.needsLights&&Me.numLightProbeGrids>0){const ot=M;let bt=0;for(const bn of R.state.lightProbeGridArray)bn.texture!==null&&(ot.textures[bt]=bn.texture,ot.min[bt]=bn.boundingBox.min,ot.max[bt]=bn.boundingBox.max,ot.resolution[bt]=bn.resolution,bt++);for(const bn in ot)ot[bn].length=bt;Rt.probesSH.value=ot.textures,Rt.probesMin.value=ot.min,Rt.probesMax.value=ot.max,Rt.probesResolution.value=ot.resolution}or.upload(U,Al(Me),Rt,Le)}if(O.isShaderMaterial&&O.uniformsNeedUpdate===!0&&(or.upload(U,Al(Me),Rt,Le),O.uniformsNeedUpdate=!1),O.isSpriteMaterial&&We.setValue(U,"center",z.center),We.setValue(U,"modelViewMatrix",z.modelViewMatrix),We.setValue(U,"normalMatrix",z.normalMatrix),We.setValue(U,"modelMatrix",z.matrixWorld),O.uniformsGroups!==void 0){const ot=O.uniformsGroups;for(let bt=0,bn=ot.length;bt<bn;bt++){const Pl=ot[bt];be.update(Pl,Lt),be.bind(Pl,Lt)}}return Lt}function gd(y,D){y.ambientLightColor.needsUpdate=D,y.lightProbe.needsUpdate=D,y.sunLights.needsUpdate=D,y.sunLightShadows.needsUpdate=D,y.directionalLights.needsUpdate=D,y.directionalLightShadows.needsUpdate=D,y.pointLights.needsUpdate=D,y.pointLightShadows.needsUpdate=D,y.spotLights.needsUpdate=D,y.spotLightShadows.needsUpdate=D,y.rectAreaLights.needsUpdate=D,y.hemisphereLights.needsUpdate=D}function _d(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return te},this.setRenderTargetTextures=function(y,D,G){const O=Re.get(y);O.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,O.__autoAllocateDepthBuffer===!1&&(O.__useRenderToTexture=!1),Re.get(y.texture).__webglTexture=D,Re.get(y.depthTexture).__webglTexture=O.__autoAllocateDepthBuffer?void 0:G,O.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,D){const G=Re.get(y);G.__webglFramebuffer=D,G.__useDefaultFramebuffer=D===void 0},this.setRenderTarget=function(y,D=0,G=0){te=y,K=D,k=G;let O=null,z=!1,he=!1;if(y){const ce=Re.get(y);if(ce.__useDefaultFramebuffer!==void 0){de.bindFramebuffer(U.FRAMEBUFFER,ce.__webglFramebuffer),ee.copy(y.viewport),ye.copy(y.scissor),Ie=y.scissorTest,de.viewport(ee),de.scissor(ye),de.setScissorTest(Ie),X=-1;return}else if(ce.__webglFramebuffer===void 0)Le.setupRenderTarget(y);else if(ce.__hasExternalTextures)Le.rebindTextures(y,Re.get(y.texture).__webglTexture,Re.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){const Ne=y.depthTexture;if(ce.__boundDepthTexture!==Ne){if(Ne!==null&&Re.has(Ne)&&(y.width!==Ne.image.width||y.height!==Ne.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Le.setupDepthRenderbuffer(y)}}const _e=y.texture;(_e.isData3DTexture||_e.isDataArrayTexture||_e.isCompressedArrayTexture)&&(he=!0);const Ee=Re.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(Ee[D])?O=Ee[D][G]:O=Ee[D],z=!0):y.samples>0&&Le.useMultisampledRTT(y)===!1?O=Re.get(y).__webglMultisampledFramebuffer:Array.isArray(Ee)?O=Ee[G]:O=Ee,ee.copy(y.viewport),ye.copy(y.scissor),Ie=y.scissorTest}else ee.copy(Ce).multiplyScalar(ge).floor(),ye.copy(Ke).multiplyScalar(ge).floor(),Ie=Qe;if(G!==0&&(O=W),de.bindFramebuffer(U.FRAMEBUFFER,O)&&de.drawBuffers(y,O),de.viewport(ee),de.scissor(ye),de.setScissorTest(Ie),z){const ce=Re.get(y.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+D,ce.__webglTexture,G)}else if(he){const ce=D;for(let _e=0;_e<y.textures.length;_e++){const Ee=Re.get(y.textures[_e]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+_e,Ee.__webglTexture,G,ce)}}else if(y!==null&&G!==0){const ce=Re.get(y.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,ce.__webglTexture,G)}X=-1};function Cl(y){const D=Re.get(y);return(D.__readFormat!==y.format||D.__readType!==y.type)&&(D.__readFormat=y.format,D.__readType=y.type,D.__formatReadable=rt.textureFormatReadable(y.format),D.__typeReadable=rt.textureTypeReadable(y.type)),D}this.readRenderTargetPixels=function(y,D,G,O,z,he,ve,ce=0){if(!(y&&y.isWebGLRenderTarget)){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _e=Re.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&ve!==void 0&&(_e=_e[ve],Array.isArray(_e)&&(_e=_e[0])),_e){de.bindFramebuffer(U.FRAMEBUFFER,_e);try{const Ee=y.textures[ce],Ne=Ee.format,ze=Ee.type;y.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ce);const Se=Cl(Ee);if(Se.__formatReadable===!1){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Se.__typeReadable===!1){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}D>=0&&D<=y.width-O&&G>=0&&G<=y.height-z&&U.readPixels(D,G,O,z,se.convert(Ne),se.convert(ze),he)}finally{const Ee=te!==null?Re.get(te).__webglFramebuffer:null;de.bindFramebuffer(U.FRAMEBUFFER,Ee)}}},this.readRenderTargetPixelsAsync=async function(y,D,G,O,z,he,ve,ce=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _e=Re.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&ve!==void 0&&(_e=_e[ve],Array.isArray(_e)&&(_e=_e[0])),_e)if(D>=0&&D<=y.width-O&&G>=0&&G<=y.height-z){de.bindFramebuffer(U.FRAMEBUFFER,_e);const Ee=y.textures[ce],Ne=Ee.format,ze=Ee.type;y.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+ce);const Se=Cl(Ee);if(Se.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Se.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const He=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,He),U.bufferData(U.PIXEL_PACK_BUFFER,he.byteLength,U.STREAM_READ),U.readPixels(D,G,O,z,se.convert(Ne),se.convert(ze),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);const mt=te!==null?Re.get(te).__webglFramebuffer:null;de.bindFramebuffer(U.FRAMEBUFFER,mt);const nt=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await mp(U,nt,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,He),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,he),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(He),U.deleteSync(nt),he}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,D=null,G=0){const O=Math.pow(2,-G),z=Math.floor(y.image.width*O),he=Math.floor(y.image.height*O),ve=D!==null?D.x:0,ce=D!==null?D.y:0;Le.setTexture2D(y,0),U.copyTexSubImage2D(U.TEXTURE_2D,G,0,0,ve,ce,z,he),de.unbindTexture()},this.copyTextureToTexture=function(y,D,G=null,O=null,z=0,he=0){let ve,ce,_e,Ee,Ne,ze,Se,He,mt;const nt=y.isCompressedTexture?y.mipmaps[he]:y.image;if(G!==null)ve=G.max.x-G.min.x,ce=G.max.y-G.min.y,_e=G.isBox3?G.max.z-G.min.z:1,Ee=G.min.x,Ne=G.min.y,ze=G.isBox3?G.min.z:0;else{const We=Math.pow(2,-z);ve=Math.floor(nt.width*We),ce=Math.floor(nt.height*We),y.isDataArrayTexture?_e=nt.depth:y.isData3DTexture?_e=Math.floor(nt.depth*We):_e=1,Ee=0,Ne=0,ze=0}O!==null?(Se=O.x,He=O.y,mt=O.z):(Se=0,He=0,mt=0);const je=se.convert(D.format),Pt=se.convert(D.type);let Me;D.isData3DTexture?(Le.setTexture3D(D,0),Me=U.TEXTURE_3D):D.isDataArrayTexture||D.isCompressedArrayTexture?(Le.setTexture2DArray(D,0),Me=U.TEXTURE_2D_ARRAY):(Le.setTexture2D(D,0),Me=U.TEXTURE_2D),de.activeTexture(U.TEXTURE0),de.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,D.flipY),de.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,D.premultiplyAlpha),de.pixelStorei(U.UNPACK_ALIGNMENT,D.unpackAlignment);const Nt=de.getParameter(U.UNPACK_ROW_LENGTH),$e=de.getParameter(U.UNPACK_IMAGE_HEIGHT),si=de.getParameter(U.UNPACK_SKIP_PIXELS),Lt=de.getParameter(U.UNPACK_SKIP_ROWS),xs=de.getParameter(U.UNPACK_SKIP_IMAGES);de.pixelStorei(U.UNPACK_ROW_LENGTH,nt.width),de.pixelStorei(U.UNPACK_IMAGE_HEIGHT,nt.height),de.pixelStorei(U.UNPACK_SKIP_PIXELS,Ee),de.pixelStorei(U.UNPACK_SKIP_ROWS,Ne),de.pixelStorei(U.UNPACK_SKIP_IMAGES,ze);const zn=y.isDataArrayTexture||y.isData3DTexture,ri=D.isDataArrayTexture||D.isData3DTexture;if(y.isDepthTexture){const We=Re.get(y),Rt=Re.get(D),rn=Re.get(We.__renderTarget),ot=Re.get(Rt.__renderTarget);de.bindFramebuffer(U.READ_FRAMEBUFFER,rn.__webglFramebuffer),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,ot.__webglFramebuffer);for(let bt=0;bt<_e;bt++)zn&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Re.get(y).__webglTexture,z,ze+bt),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Re.get(D).__webglTexture,he,mt+bt)),U.blitFramebuffer(Ee,Ne,Ee+ve,Ne+ce,Se,He,Se+ve,He+ce,U.DEPTH_BUFFER_BIT,U.NEAREST);de.bindFramebuffer(U.READ_FRAMEBUFFER,null),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(z!==0||y.isRenderTargetTexture||Re.has(y)){const We=Re.get(y),Rt=Re.get(D);de.bindFramebuffer(U.READ_FRAMEBUFFER,I),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,F);for(let rn=0;rn<_e;rn++)zn?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,We.__webglTexture,z,ze+rn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,We.__webglTexture,z),ri?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Rt.__webglTexture,he,mt+rn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Rt.__webglTexture,he),z!==0?U.blitFramebuffer(Ee,Ne,Ee+ve,Ne+ce,Se,He,Se+ve,He+ce,U.COLOR_BUFFER_BIT,U.NEAREST):ri?U.copyTexSubImage3D(Me,he,Se,He,mt+rn,Ee,Ne,ve,ce):U.copyTexSubImage2D(Me,he,Se,He,Ee,Ne,ve,ce);de.bindFramebuffer(U.READ_FRAMEBUFFER,null),de.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else ri?y.isDataTexture||y.isData3DTexture?U.texSubImage3D(Me,he,Se,He,mt,ve,ce,_e,je,Pt,nt.data):D.isCompressedArrayTexture?U.compressedTexSubImage3D(Me,he,Se,He,mt,ve,ce,_e,je,nt.data):U.texSubImage3D(Me,he,Se,He,mt,ve,ce,_e,je,Pt,nt):y.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,he,Se,He,ve,ce,je,Pt,nt.data):y.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,he,Se,He,nt.width,nt.height,je,nt.data):U.texSubImage2D(U.TEXTURE_2D,he,Se,He,ve,ce,je,Pt,nt);de.pixelStorei(U.UNPACK_ROW_LENGTH,Nt),de.pixelStorei(U.UNPACK_IMAGE_HEIGHT,$e),de.pixelStorei(U.UNPACK_SKIP_PIXELS,si),de.pixelStorei(U.UNPACK_SKIP_ROWS,Lt),de.pixelStorei(U.UNPACK_SKIP_IMAGES,xs),he===0&&D.generateMipmaps===!0&&D.mipmapsAutoUpdate===!0&&U.generateMipmap(Me),de.unbindTexture()},this.initRenderTarget=function(y){Re.get(y).__webglFramebuffer===void 0&&Le.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?Le.setTextureCube(y,0):y.isData3DTexture?Le.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?Le.setTexture2DArray(y,0):Le.setTexture2D(y,0),de.unbindTexture()},this.resetState=function(){K=0,k=0,te=null,de.reset(),ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return hn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=Ve._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ve._getUnpackColorSpace()}}function Zv(n){const e=n.getContext("webgl2",{alpha:!0,antialias:!1,depth:!1,preserveDrawingBuffer:!0});if(e===null)throw new Error("this browser has no WebGL 2");if(e.getExtension("EXT_color_buffer_float")===null)throw new Error("this browser's WebGL 2 does not draw into floats");const t=new Kv({canvas:n,context:e});return t.autoClear=!1,t.sortObjects=!1,t.setClearColor(0,0),t.outputColorSpace=hs,t.debug.onShaderError=(i,s,r,a)=>{const o=[i.getProgramInfoLog(s)];throw o.push(i.getShaderInfoLog(r),i.getShaderInfoLog(a)),new Error(`shader: ${o.join(`
`)}`)},t}const Yc=new hl;class Tr{constructor(e,t,i,{adds:s=!1,depth:r=!1}={}){this.renderer=e,this.scene=new Ip,this.compiled=!1,this.fault=null;const a=new $h({glslVersion:wo,vertexShader:t,fragmentShader:i,side:vn,depthTest:r,depthWrite:r,depthFunc:_r,blending:s?mh:hi,blendSrc:za,blendDst:za});this.mesh=new ti(new Bn,a),this.mesh.geometry.setDrawRange(0,3),this.mesh.frustumCulled=!1,this.scene.add(this.mesh),this.scene.matrixWorldAutoUpdate=!1,e.compileAsync(this.scene,Yc).then(()=>this.compiled=!0,o=>this.fault=o)}ready(){if(this.fault!==null)throw this.fault;return this.compiled}setMesh({positions:e,normals:t,indices:i}){const s=new Bn;s.setAttribute("position",new yn(e,3)),s.setAttribute("normal",new yn(t,3)),s.setIndex(new yn(i,1)),this.mesh.geometry.dispose(),this.mesh.geometry=s}set(e){const{uniforms:t}=this.mesh.material;for(const[i,s]of Object.entries(e)){const r=t[i];r===void 0?t[i]={value:s}:r.value=s}}draw(e,t){e!==null&&(e.scissorTest=t!==void 0,t!==void 0&&e.scissor.set(0,t[0],e.width,t[1])),this.renderer.setRenderTarget(e),this.renderer.render(this.scene,Yc)}}function Ar(n,e,t,i,{count:s=1,depth:r=!1,linear:a=!1,red:o=!1}={}){const l=new dn(e,t,{count:s,type:i,format:o?kr:tn,minFilter:a?Ct:_t,magFilter:a?Ct:_t,depthBuffer:r});return Rr(n,l),l}function Rr(n,e){e.scissorTest=!1,n.setRenderTarget(e),n.clear(!0,e.depthBuffer,!1)}function lr(n,e,t,i,{linear:s=!1,repeat:r=!1}={}){const[a=1,o=1,l]=t;if(n instanceof Ro||n instanceof Ao){const{image:u}=n,p="depth"in u?u.depth:void 0;if(u.width===a&&u.height===o&&p===l)return u.data=i,n.needsUpdate=!0,n}n?.dispose();const c=l===void 0?new Ro(i,a,o):new Ao(i,a,o,l);return c.format=e==="r32f"?kr:tn,c.internalFormat=e==="r32f"?"R32F":"RGBA16F",c.type=i instanceof Uint16Array?Vt:Ot,c.minFilter=c.magFilter=s?Ct:_t,c.wrapS=r?vr:xn,c.needsUpdate=!0,c}const di=Math.PI/180,Cr=(n,e)=>[n[0]+e[0],n[1]+e[1],n[2]+e[2]],Jv=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],Sn=(n,e)=>[n*e[0],n*e[1],n*e[2]],Kc=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],Qv=n=>Sn(1/Math.hypot(...n),n);function sd(n,e){const t=new Float32Array(16);for(let i=0;i<4;++i)for(let s=0;s<4;++s){let r=0;for(let a=0;a<4;++a)r+=n[4*a+s]*e[4*i+a];t[4*i+s]=r}return t}function cr(n,e){const t=Wr(1),[i,s]=[Math.cos(e*di),Math.sin(e*di)],[r,a]=[(n+1)%3,(n+2)%3];return t[5*r]=t[5*a]=i,t[4*r+a]=s,t[4*a+r]=-s,t}function Wr(n){return new Float32Array([n,0,0,0,0,n,0,0,0,0,n,0,0,0,0,1])}function Lo(n){const e=Wr(1);return e.set(n,12),e}function rd(n,e,t){const[i,s,r]=n.rotation_deg;return[ex(t,e),Lo(n.translation_mm),cr(2,r),cr(1,s),cr(0,i),Wr(n.scale)].reduce(sd)}function jv(n){const e=Wr(1);for(let t=0;t<3;++t){let i=0;for(let s=0;s<3;++s){const r=n[4*t+s];e[4*s+t]=r,i-=r*n[12+s]}e[12+t]=i}return e}function ex(n,e){return[Lo(n),cr(2,e),Lo(Sn(-1,n))].reduce(sd)}function ns(n,e){const[t,i]=[Math.cos(e*di),Math.sin(e*di)];return[t*n[0]-i*n[1],i*n[0]+t*n[1],n[2]]}const tx=(n,e,t)=>Cr(t,ns(Jv(n,t),e));function nx(n,e){const[t,i]=[n.azimuth_deg*di,n.elevation_deg*di],s=[Math.cos(i)*Math.cos(t),Math.cos(i)*Math.sin(t),Math.sin(i)],r=Sn(-1,s),a=Qv(Kc(r,[0,0,1])),o=Math.tan(.5*n.fov_deg*di);return{place:Cr(n.target_mm,Sn(n.distance_mm,s)),ahead:r,across:Sn(o*e,a),upwards:Sn(o,Kc(a,r))}}function ix(n,e,t){const[i,s]=[.1*e,10*e],r=[n.across,n.upwards].map(_=>Sn(1/(_[0]**2+_[1]**2+_[2]**2),_)),[a,o]=r,{ahead:l,place:c}=n,u=(s+i)/(s-i),p=(_,v)=>_[0]*v[0]+_[1]*v[1]+_[2]*v[2],h=new Float32Array(16),d=(_,v,m)=>{for(let f=0;f<3;++f)h[4*f+_]=v[f];h[12+_]=m-p(v,c)};return d(0,Cr(a,Sn(t[0],l)),0),d(1,Cr(o,Sn(t[1],l)),0),d(2,Sn(u,l),-2*s*i/(s-i)),d(3,l,0),h}const Fi=16,Zc=4,Ra=Math.sqrt(Fi),Ca=n=>n<.5?Math.sqrt(2*n)-1:1-Math.sqrt(Math.max(2-2*n,0));function Jc(n,e){const[t,i]=[Ca(n/Ra),Ca((n+1)/Ra)],[s,r]=[.5*(t+i),i-t],a=.5*r/(1-Math.abs(s));return[Ca((n+e)/Ra),s,r,s<0?a:-a]}function Qc(n,e){if(!e)return{asks:!1,part:jc(n)};const t=n<Fi||n%Zc===0,i=Math.min(n,Fi)+Math.ceil(Math.max(n-Fi,0)/Zc);return{asks:t,part:jc(t?i:n-i)}}function jc(n){const[e,t]=[Math.floor(n/Fi),n%Fi],i=l=>t>>l&1,s=2*i(0)+i(2),r=2*(i(0)^i(1))+(i(2)^i(3)),a=Jc(s,(e*.7548776662+.5)%1),o=Jc(r,(e*.569840291+.5)%1);return{place:[a[0],o[0]],middle:[a[1],o[1]],size:[a[2],o[2]],tilt:[a[3],o[3]]}}function sx(n,e,t){return jv(rd({...n,scale:1},e,t))}function rx(n,{middle:e,size:t,tilt:i},s,r){return{flakesShown:s?1:0,flakesAsked:r?1:0,toRest:n,partMiddle:e,partSize:t,partTilt:i}}const ax=`
#ifdef NACRE_FLAKES
uniform bool flakesShown;
uniform bool flakesAsked;
uniform mat4 toRest;
uniform vec2 partMiddle;  // in pixels, from the middle of this one
uniform vec2 partSize;
uniform vec2 partTilt;

vec3 lookedAtFrom;
mat3 lookedAtFrame;
vec3 nacreRadiance(vec3 wo) {
    float ignored;
    return radianceFrom(lookedAtFrom, lookedAtFrame * wo, ignored);
}

/// What the part of a pixel covers of the surface, which is flat there.
NacrePatch partOn(vec3 place, mat3 toWorld) {
    vec3 n = toWorld[2], q = place - eye;
    float depth = dot(q, ahead);
    q /= depth;
    float facing = dot(n, q);
    if (abs(facing) < 1e-6) facing = -1e-6;
    vec3 stepX = across * (2. / size.x), stepY = upwards * (2. / size.y);
    vec3 edgeX = depth * (stepX - q * (dot(n, stepX) / facing));
    vec3 edgeY = depth * (stepY - q * (dot(n, stepY) / facing));
    vec2 from = partMiddle - shift;
    vec3 middle = place + from.x * edgeX + from.y * edgeY;
    mat3 turn = mat3(toRest);
    return NacrePatch((toRest * vec4(middle, 1.)).xyz, normalize(turn * n), normalize(turn * toWorld[0]),
                      partSize.x * (turn * edgeX), partSize.y * (turn * edgeY), partTilt);
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
    return nacreFlakes(partOn(place, toWorld), flakesAsked, wi, towardsSun, sunRadiance * angle, angle,
                       mixBits(pixelBits ^ (sampleIndex * 0x9e3779b9u)));
}
#else
const bool flakesAsked = false;
vec3 shadedFlakes(vec3 place, mat3 toWorld, vec3 wi, vec3 towardsSun) { return vec3(0.); }
void nacreWithoutSunlit() {}
#endif
`,Zn=4,ox=115,qi=`
precision highp float;
precision highp int;
precision highp sampler2D;
#define PI 3.141592653589793
`,ad=`
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.);
}`,eu=`
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
}`,tu=`${qi}
in vec3 place;
in vec3 facing;
layout(location = 0) out vec4 placeAt;
layout(location = 1) out vec4 facingAt;
void main() {
    placeAt = vec4(place, 1.);
    facingAt = vec4(normalize(facing), 0.);
}`;function lx(n,e){return`${qi}
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
uniform vec3 corner[${String(Zn)}];
uniform vec3 edgeU[${String(Zn)}];
uniform vec3 edgeV[${String(Zn)}];
uniform vec3 rectangleNormal[${String(Zn)}];
uniform vec3 rectangleRadiance[${String(Zn)}];
uniform vec3 eye;
uniform vec3 ahead;              // to the middle of the picture, and half its width and height
uniform vec3 across;
uniform vec3 upwards;
uniform vec2 size;
uniform vec2 shift;              // of this sample within its pixel
uniform uint sampleIndex;
uniform int interleaved;         // pixels of a side of which each takes other ones of the same numbers; 0: none
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 flakes;  // their light apart, as not all samples ask them

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
    for (int low = 0, high = texels.y - 1; low < high; y = low) {
        int middle = (low + high) / 2;
        if (rowAt(middle) > u.y) high = middle; else low = middle + 1;
    }
    int x = 0;
    for (int low = 0, high = texels.x - 1; low < high; x = low) {
        int middle = (low + high) / 2;
        if (columnAt(middle, y) > u.x) high = middle; else low = middle + 1;
    }
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
    int count = int(nacreLobeCount);
    for (int k = 0; k < count; ++k) sum += nacreDensity(k, wi, wo);
    return EVEN * wo.z / PI + (1. - EVEN) / float(count) * sum;
}
${ax}
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
    // Directions from the paint, from afar and from each rectangle.
    for (int way = 0; way < 2 + rectangleCount; ++way) {
        vec2 u = evenly(uint(way));
        vec3 w, wo;
        if (way == 0) {
            float which = evenlyOne(7u);
            float r = sqrt(u.x), phi = 2. * PI * u.y;
            if (which < EVEN) wo = vec3(r * cos(phi), r * sin(phi), sqrt(1. - u.x));
            else wo = nacreDraw(min(int((which - EVEN) / (1. - EVEN) * nacreLobeCount), int(nacreLobeCount) - 1), wi, u);
            w = toWorld * wo;
        } else if (way == 1) {
            w = drawFromAfar(u);
            wo = w * toWorld;
        } else {
            vec3 at = corner[way - 2] + u.x * edgeU[way - 2] + u.y * edgeV[way - 2];
            w = normalize(at - place);
            wo = w * toWorld;
        }
        if (wo.z <= 1e-4) continue;
        float density;
        vec3 radiance = radianceFrom(place, w, density);
        if (max(radiance.r, max(radiance.g, radiance.b)) <= 0.) continue;
        density += densityFromAfar(w) + densityOfPaint(wi, wo);
        sum += nacreColour(wi, wo) * radiance * (wo.z / density);
    }
    if (towardsSun.z > 1e-4) {
        nacreWithoutSunlit();
        sum += nacreColour(wi, towardsSun) * sunRadiance * (2. * PI * (1. - sun.w) * towardsSun.z);
    }
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
        number += ${String(ox)}u * uint(within.x + interleaved * within.y);
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
    flakes = vec4(dot(ofFlakes, ofFlakes) < 1e12 ? ofFlakes : vec3(0.), flakesAsked ? 1. : 0.);
}`.replaceAll("0x1p-24_","5.9604644775390625e-8")}const Xr=`
vec4 mean(vec4 sum) { return sum.a > 0. ? vec4(sum.rgb / sum.a, 1.) : vec4(0.); }
float brightness(vec3 light) { return max(dot(light, vec3(.2126, .7152, .0722)), 0.); }
vec3 lightOf(sampler2D sums, sampler2D flakes, ivec2 pixel) {
    return mean(texelFetch(sums, pixel, 0)).rgb + mean(texelFetch(flakes, pixel, 0)).rgb;
}
`,cx=`${qi}${Xr}
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
}`,ux=`${qi}${Xr}
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
}`,hx=`${qi}${Xr}
uniform sampler2D sums;
uniform sampler2D sumsOfFlakes;
uniform sampler2D means;  // filtered between its pixels, which are larger
out float glitter;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float around = brightness(mean(texture(means, gl_FragCoord.xy / vec2(textureSize(sums, 0)))).rgb);
    float here = brightness(lightOf(sums, sumsOfFlakes, pixel));
    glitter = around > 1e-4 ? min(here / around, 65504.) : 1.;
}`;function Pa(n){const[e,t]=[n!=="whole",n!=="coarse"].map(Number);return`${qi}${Xr}
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
}`}const Do=4,od=5,dx=5,fx=16,Pn=({textures:n})=>n[0],La=({textures:n})=>n[1],nu=(n,e)=>n?.width===e.width&&n.height===e.height;function iu(n){const e=["nacreField","nacreFieldLevels","nacreFieldKey"].map(t=>n.uniforms.find(i=>i.name===t)?.values);return JSON.stringify(e.map(t=>Array.from(t??[])))}class px{constructor(e){this.renderer=e,this.even=lr(void 0,"r32f",[1,1],Float32Array.of(1)),this.before=null,this.glitters=!1,this.rowMeans=null,this.coarseMeans=null;const t=e.getContext().getExtension("OES_texture_float_linear")!==null;this.filteredType=t?Ot:Vt;const i=s=>new Tr(e,ad,s);this.screens={coarse:i(Pa("coarse")),whole:i(Pa("whole")),both:i(Pa("both"))},this.average=i(cx),this.smooth=i(ux),this.glitter=i(hx)}ready(){return[...Object.values(this.screens),this.average,this.smooth,this.glitter].every(t=>t.ready())}changePaint(e,t,i,s){let r=e;if(t.flakes&&e.samples>=fx){r=this.before?.sums??s();const{means:a=null,glitter:o=null}=this.before??{};this.before={sums:e,flakes:iu(t),means:a,glitter:o,known:!1}}return this.glitters=i.flakes&&this.before?.flakes===iu(i),r}forget(){this.glitters=!1,this.before?.sums.delete(),this.before?.means?.dispose(),this.before?.glitter?.dispose(),this.before=null}draw(e,t,i){const s=t!==null&&t.samples>0;let r="whole";s&&e.samples<Do&&(r=e.samples===0&&e.rows===0?"coarse":"both");let a=this.even;s&&r!=="whole"&&(this.smoothed(t),this.glitters&&this.before!==null&&(a=this.glitterOf(this.before,t)));const o=this.screens[r];o.set({whole:Pn(e.target),wholeFlakes:La(e.target),coarseMeans:Pn(this.coarseMeans??e.target),glitter:a,size:this.renderer.getDrawingBufferSize(new Xe).toArray(),enough:Do,warn:i?1:0}),o.draw(null)}glitterOf(e,t){const{sums:i}=e;if(e.known&&e.glitter!==null&&nu(e.means,t.target))return Pn(e.glitter);e.means=this.meansOf(i,t,e.means);const{width:s,height:r}=i.target;return e.glitter??=Ar(this.renderer,s,r,Vt,{red:!0}),this.glitter.set({sums:Pn(i.target),sumsOfFlakes:La(i.target),means:Pn(e.means)}),this.glitter.draw(e.glitter),e.known=!0,Pn(e.glitter)}smoothed({target:e,shape:t,samples:i}){this.rowMeans=this.meansLike(e,this.rowMeans),this.coarseMeans=this.meansLike(e,this.coarseMeans),this.smooth.set({placeAt:t.textures[0],facingAt:t.textures[1],width:i<=dx?od:2}),this.smooth.set({sums:Pn(e),along:[1,0]}),this.smooth.draw(this.rowMeans),this.smooth.set({sums:Pn(this.rowMeans),along:[0,1]}),this.smooth.draw(this.coarseMeans)}meansOf({target:e},t,i){const s=this.meansLike(t.target,i);return this.average.set({sums:Pn(e),sumsOfFlakes:La(e),size:[s.width,s.height]}),this.average.draw(s),s}meansLike(e,t){if(t!==null&&nu(t,e))return t;t?.dispose();const{width:i,height:s}=e;return Ar(this.renderer,i,s,this.filteredType,{linear:!0})}}function mx(n,e,t){const{sun:i,rectangles:s,azimuth_deg:r}=n,a=Math.PI/180,o=i?ns(i.direction,e):[0,0,1],l=i?Math.cos(i.angular_radius_deg*a):2,c=u=>{const p=new Float32Array(3*Zn);return p.set(s.flatMap(u)),p};return{azimuth:(r+e)*a,sun:[...o,l],sunRadiance:i?.rgb??[0,0,0],rectangleCount:s.length,corner:c(u=>tx(u.corner,e,t)),edgeU:c(u=>ns(u.edge_u,e)),edgeV:c(u=>ns(u.edge_v,e)),rectangleNormal:c(u=>ns(u.normal,e)),rectangleRadiance:c(u=>u.rgb)}}const gx={frame_ms:12,moving_ms:6},_x={frame_ms:30,moving_ms:12},vx=15,xx=4096,Sx=200;class Mx{constructor(){this.frame_ms=0,this.speed=2e3,this.overhead_ms=16}budgets(){const{frame_ms:e,moving_ms:t}=this.overhead_ms<vx?gx:_x;return{budget:Math.max(e*this.speed,xx),moving:t*this.speed}}drawn(e,t){this.frame_ms=e,this.overhead_ms=Math.min(this.overhead_ms,e);const i=Math.max(e-this.overhead_ms,1);this.speed=.5*this.speed+.5*t/i}}function yx(n,e,t){const[i,s,r]=[Math.abs(n),Math.abs(e),Math.abs(t)];return i>=s&&i>=r?n<0?1:0:s>=r?e<0?3:2:t<0?5:4}function Ex(n,e){const{positions:t,normals:i,indices:s}=n,r=t.length/3,a=[1/0,1/0,1/0],o=[-1/0,-1/0,-1/0];t.forEach((w,M)=>{const T=M%3;a[T]=Math.min(a[T],w),o[T]=Math.max(o[T],w)});const l=a.map((w,M)=>Math.floor((o[M]-w)/e)+1),[c=1,u=1,p=1]=l;if(6*c*u*p>Number.MAX_SAFE_INTEGER)return n;const h=new Uint32Array(r),d=new Map,_=[],v=[];for(let w=0;w<r;++w){const M=C=>t[3*w+C],T=C=>i[3*w+C],R=C=>Math.floor((M(C)-a[C])/e),E=yx(T(0),T(1),T(2))+6*(R(0)+c*(R(1)+u*R(2)));let N=d.get(E);N===void 0&&(N=_.length,d.set(E,N),_.push(0),v.push(0,0,0,0,0,0)),h[w]=N,_[N]=_[N]+1;for(let C=0;C<3;++C){const L=6*N+C;v[L]=v[L]+M(C),v[L+3]=v[L+3]+T(C)}}const m=[];for(let w=0;w<s.length;w+=3){const M=E=>h[s[w+E]],[T,R,g]=[M(0),M(1),M(2)];T!==R&&R!==g&&g!==T&&m.push(T,R,g)}if(2*m.length>s.length)return n;const f=new Float32Array(3*_.length),x=new Float32Array(3*_.length);return _.forEach((w,M)=>{for(let T=0;T<3;++T)f[3*M+T]=v[6*M+T]/w,x[3*M+T]=v[6*M+3+T]}),{positions:f,normals:x,indices:Uint32Array.from(m)}}const su=2,ru=1;class bx{constructor(e){this.renderer=e,this.mesh=null,this.cell=0,this.whole=new Tr(e,eu,tu,{depth:!0}),this.coarse=new Tr(e,eu,tu,{depth:!0})}ready(){return this.whole.ready()&&this.coarse.ready()}setMesh(e){this.whole.setMesh(e),this.mesh=e,this.cell=0}draw(e,t,i,s,r,a,o){if(e.shapeFrom?.[0]===a[0]&&e.shapeFrom[1]===a[1])return;e.shapeFrom=a;const{shape:l}=e,c=[-2*a[0]/l.width,-2*a[1]/l.height];o&&this.fit(l.height,t,s);const u=o?this.coarse:this.whole;u.set({toWorld:rd(t,i,s.target_mm),toScreen:ix(r,s.distance_mm,c)}),Rr(this.renderer,l),u.draw(l)}fit(e,{scale:t},{distance_mm:i,fov_deg:s}){const a=2*i*Math.tan(s*Math.PI/360)/e/t;this.mesh!==null&&(this.cell<=su*a&&this.cell>=ru*a||(this.cell=Math.sqrt(su*ru)*a,this.coarse.setMesh(Ex(this.mesh,this.cell))))}}class wx{constructor(e,t,i,s){this.renderer=e,this.type=s,this.shapeFrom=null,this.samples=0,this.rows=0,this.first=0,this.target=Ar(e,t,i,s,{count:2}),this.shape=Ar(e,t,i,Ot,{count:2,depth:!0})}get place(){return this.first+this.samples}restart(){this.samples=this.rows=this.first=0,this.shapeFrom=null}restartWhereSeen(){this.rows===0&&this.samples>0&&--this.samples,this.first=this.place,this.samples=this.rows=0}added(e){this.rows+=e,!(this.rows<this.target.height)&&(this.rows=0,++this.samples)}means(){const{width:e,height:t}=this.target,i=new Float32Array(4*e*t);for(let s=0;s<this.target.textures.length;++s){const r=this.read(s);for(let a=0;a<i.length;a+=4){const o=1/Math.max(r[a+3],1);for(let l=a;l<a+3;++l)i[l]=i[l]+o*r[l];i[a+3]=1}}return{width:e,height:t,data:i}}delete(){this.target.dispose(),this.shape.dispose()}read(e){const{target:t,type:i}=this,{width:s,height:r}=t,a=4*s*r,o=c=>{this.renderer.readRenderTargetPixels(t,0,0,s,r,c,0,e)};if(i===Ot){const c=new Float32Array(a);return o(c),c}const l=new Uint16Array(a);return o(l),Float32Array.from(l,c=>Op.fromHalfFloat(c))}}const Tx=65504;function Ax(n){const{width:e,height:t,rgb:i}=n,s=new Float32Array(4*e*t),r=new Float32Array(e*t);for(let u=0;u<e*t;++u){const[p,h,d]=[0,1,2].map(_=>Math.min(i[3*u+_],Tx));s.set([p,h,d,1],4*u),r[u]=Math.max(.2126*p+.7152*h+.0722*d,0)}const a=new Float32Array(e*t),o=new Float32Array(t),l=new Float64Array(e);let c=0;for(let u=0;u<t;++u){let p=0;for(let h=0;h<e;++h){let d=1e-9;for(let _=Math.max(u-1,0);_<=Math.min(u+1,t-1);++_)for(const v of[h-1+e,h,h+1])d+=r[_*e+v%e];l[h]=p+=d}for(let h=0;h<e;++h)a[u*e+h]=l[h]/p;c+=p*(Math.cos(Math.PI*u/t)-Math.cos(Math.PI*(u+1)/t)),o[u]=c}for(let u=0;u<t;++u)o[u]=o[u]/c;return{width:e,height:t,picture:s,byColumn:a,byRow:o}}const au=24,Rx=3,Cx=10,ou=2,lu=6,Px=1024;class Lx{constructor(e,t={}){this.canvas=e,this.options=t,this.paints=new Map,this.paintTextures=new Map,this.lightTextures={},this.transform=null,this.light=null,this.camera=null,this.turn_deg=0,this.lightTurn_deg=0,this.paint=null,this.nextPaint=null,this.warn=!1,this.sparkle=!0,this.whole=null,this.coarse=null,this.coarseness=3,this.pace=new Mx,this.underWay=!1,this.request=0,this.filmsWanted=!1,this.restsUntil=0,this.dirty=!1,this.stopped=!1,this.held=!1,this.lost=!1,this.onLost=s=>{s.preventDefault(),this.lost=!0,this.pause(),this.canvas.removeEventListener("webglcontextlost",this.onLost),this.renderer.dispose(),this.options.onFault?.("the graphics processor was lost")},this.renderer=Zv(e);const i=this.renderer.getContext().getExtension("EXT_float_blend")!==null;this.sumType=i?Ot:Vt,this.mostSamples=Math.min(t.samples??Px,i?1e6:128),this.shape=new bx(this.renderer),this.shown=new px(this.renderer),this.paintTextures.set("nacreFilms",lr(void 0,"rgba16f",[1,1],new Uint16Array(4))),e.addEventListener("webglcontextlost",this.onLost)}setShape(e,t){this.shape.setMesh(e),this.transform=t,this.restart()}setLight(e){if(e.rectangles.length>Zn)throw new Error(`a light of ${String(e.rectangles.length)} rectangles: must be at most ${String(Zn)}`);const{width:t,height:i,picture:s,byColumn:r,byRow:a}=Ax(e),o=(c,...u)=>{this.lightTextures[c]=lr(this.lightTextures[c],...u)};o("surroundings","rgba16f",[t,i],s,{linear:!0,repeat:!0}),o("byColumn","r32f",[t,i],r),o("byRow","r32f",[i,1],a),this.light=e,this.restart()}setPaint(e){if(!this.paints.has(e.program)){const t=lx(e.glsl,e.smoothCoat);this.paints.set(e.program,new Tr(this.renderer,ad,t,{adds:!0}))}this.nextPaint=e,!(this.stopped||this.lost)&&(this.attempt(),this.schedule())}setFilms(e){this.paint===null||this.paint.films||(this.paint=Pf(this.paint,e),this.handOver(this.paint,e),this.schedule())}setCamera(e){const t=JSON.stringify(e)===JSON.stringify(this.camera);this.camera=e,t||this.restart()}turn(e,t){const i=e==="shape"?this.turn_deg:this.lightTurn_deg;t!==i&&(e==="shape"?this.turn_deg=t:this.lightTurn_deg=t,this.restart())}setGamutWarning(e){this.warn=e,this.dirty=!0,this.schedule()}setSparkle(e){e!==this.sparkle&&(this.sparkle=e,this.restart())}resize(e,t){this.canvas.width===e&&this.canvas.height===t&&this.whole||(this.renderer.setSize(Math.max(1,e),Math.max(1,t),!1),this.whole?.delete(),this.whole=this.make(1),this.coarse?.delete(),this.coarse=null,this.restart())}get state(){return{samples:this.whole?.samples??0,compiling:this.nextPaint!==null,frame_ms:this.pace.frame_ms,coarseness:this.coarseness}}pixels(){if(!this.whole)throw new Error("the picture has no size yet");return this.whole.means()}pause(){this.stopped=!0,cancelAnimationFrame(this.request),clearTimeout(this.timer),this.request=0}resume(){this.stopped&&(this.stopped=!1,this.dirty=!0,this.schedule())}hold(e){e!==this.held&&(this.held=e,e||this.schedule())}dispose(){this.pause(),this.canvas.removeEventListener("webglcontextlost",this.onLost),this.renderer.dispose(),this.renderer.forceContextLoss()}restart(){this.shown.forget();for(const e of[this.whole,this.coarse])e?.restart();this.dirty=!0,this.schedule()}schedule(){this.request!==0||this.stopped||this.lost||(this.request=requestAnimationFrame(()=>{this.request=0,this.attempt()}))}attempt(){try{this.frame()}catch(e){this.nextPaint=null,this.options.onFault?.(e instanceof Error?e.message:String(e))}}scheduleAt(e){clearTimeout(this.timer),this.timer=setTimeout(()=>{this.schedule()},e-performance.now())}frame(){if(this.underWay)return;this.takePaint();const e=performance.now();if(!this.dirty&&(this.held||e<this.restsUntil)){this.nextPaint!==null?this.schedule():this.held||this.scheduleAt(this.restsUntil);return}const t=this.draw();(t>0||this.dirty)&&(this.display(),this.dirty=!1,this.options.onChange?.(this.state)),t>0?this.waitUntilDrawn(e,t):this.nextPaint!==null&&this.schedule()}waitUntilDrawn(e,t){const i=this.renderer.getContext(),s=i.fenceSync(i.SYNC_GPU_COMMANDS_COMPLETE,0);if(i.flush(),s===null)return;this.underWay=!0;const r=()=>{if(i.clientWaitSync(s,0,0)===i.TIMEOUT_EXPIRED){setTimeout(r,ou);return}i.deleteSync(s),this.underWay=!1,this.pace.drawn(performance.now()-e,t),this.schedule()};setTimeout(r,ou)}takePaint(){const e=this.nextPaint,t=e===null?void 0:this.paints.get(e.program);e===null||t?.ready()!==!0||(this.nextPaint=null,this.whole&&this.sparkle&&this.paint!==null&&(this.whole=this.shown.changePaint(this.whole,this.paint,e,()=>this.make(1))),this.paint=e,this.filmsWanted=!1,this.handOver(e,e),this.whole&&(this.whole.samples=this.whole.rows=0),this.coarse?.restartWhereSeen(),this.dirty=!0)}handOver({program:e},t){const i=this.paints.get(e);i.set(Af(t));for(const{name:s,size:r,data:a}of t.textures){const o={linear:r.length===3},l=lr(this.paintTextures.get(s),"rgba16f",r,a,o);this.paintTextures.set(s,l)}i.set(Object.fromEntries(this.paintTextures))}draw(){const{whole:e}=this;if(!e||!this.transform||!this.light||!this.camera||!this.paint||!this.shape.ready()||!this.shown.ready())return 0;const t=e.target.width*e.target.height,{budget:i,moving:s}=this.pace.budgets(),{asks:r}=Qc(0,this.showsFlakesIn(e)),a=r?Do*lu*t:t,o=r&&!this.paint.films;if(o&&!this.dirty&&!this.filmsWanted&&this.nextPaint===null&&(this.filmsWanted=!0,this.options.onFilmsWanted?.()),a<=i&&!o){const c=e.samples===0?Math.max(s,a):i;return this.add(e,Math.min(c,8*a))}if(e.samples===0&&e.rows===0){Rr(this.renderer,e.target);const c=Math.ceil(Math.sqrt(t/s)),u=this.coarseOf(Math.min(Math.max(c,Rx),Cx));if(u.samples===0){t>i&&(this.restsUntil=performance.now()+Sx);const p=u.target.width*u.target.height;return this.add(u,Math.max(p,Math.min(s,au*p)))}}const{coarse:l}=this;return l&&l.samples>0&&l.samples<Math.min(au,this.mostSamples)&&e.samples===0?this.add(l,i):o?0:this.add(e,i)}showsFlakesIn(e){return this.sparkle&&e===this.whole&&this.paint?.flakes===!0}coarseOf(e){return(this.coarse===null||e>this.coarseness||e<.7*this.coarseness)&&(this.coarseness=e,this.coarse?.delete(),this.coarse=this.make(e)),this.coarse}make(e){const t=Math.max(1,Math.ceil(this.canvas.width/e)),i=Math.max(1,Math.ceil(this.canvas.height/e));return new wx(this.renderer,t,i,this.sumType)}add(e,t){const{width:i,height:s}=e.target;e.samples===0&&e.rows===0&&Rr(this.renderer,e.target);let r=0;for(;r<.75*t&&e.samples<this.mostSamples;){const a=this.showsFlakesIn(e),{asks:o,part:l}=Qc(a?e.samples:e.place,a),c=o?lu*i:i,u=Math.max(1,Math.min(s-e.rows,Math.round((t-r)/c))),p=nx(this.camera,this.canvas.width/this.canvas.height);e.rows===0&&this.drawShape(e,p,l.place),this.shade(e,p,l,u,a,o),r+=u*c,e.added(u)}return r}drawShape(e,t,i){const[s,r]=[this.transform,this.camera],a=e!==this.whole;this.shape.draw(e,s,this.turn_deg,r,t,i,a)}shade(e,t,i,s,r,a){const{target:o,shape:l,samples:c,rows:u}=e,p=this.paint,h=this.camera,d=sx(this.transform,this.turn_deg,h.target_mm),_=this.paints.get(p.program);_.set({...this.lightTextures,...mx(this.light,this.lightTurn_deg,h.target_mm),placeAt:l.textures[0],facingAt:l.textures[1],eye:t.place,ahead:t.ahead,across:t.across,upwards:t.upwards,size:[o.width,o.height],shift:i.place,...rx(d,i,r,a),sampleIndex:c,interleaved:e===this.whole?0:od}),_.draw(o,[u,s])}display(){this.whole&&this.shown.ready()&&this.shown.draw(this.whole,this.coarse,this.warn)}}const Dx=512;class Ix{constructor(){this.texts=new Map,this.meshes=new Map,this.lights=new Map}add(e,t){e.mesh!==void 0&&this.meshes.set(t,Promise.resolve(e.mesh)),e.light!==void 0&&this.lights.set(t,Promise.resolve(e.light))}}class Nx{constructor(e,t,i,s,r,a,o){this.canvas=e,this.schema=t,this.bytes=i,this.received=s,this.onFault=o,this.shape="",this.light="",this.view=new Lx(e,{onChange:({samples:l})=>{r(l)},onFilmsWanted:a,onFault:o})}setSchema(e){this.schema=e}show(e,t,i){const s=this.schema.shapes.find(({name:a})=>a===e.shape);if(s===void 0||t*i===0)return;if(this.shape!==e.shape){this.shape=e.shape;const a=cu(this.received.meshes,e.shape,()=>this.bytes(`/api/shape/${encodeURIComponent(e.shape)}`).then(fh));this.when(a,o=>{this.shape===e.shape&&this.view.setShape(o,s.transform)})}if(this.light!==e.light){this.light=e.light;const a=cu(this.received.lights,e.light,()=>this.bytes(`/api/light/${encodeURIComponent(e.light)}?width=${String(Dx)}`).then(ph));this.when(a,o=>{this.light===e.light&&this.view.setLight(o)})}this.view.resize(t,i);const r=hh(e.camera,t,i);this.view.setCamera({...r,target_mm:s.camera.target_mm}),this.view.turn("shape",e.turn_deg),this.view.turn("light",e.light_turn_deg),this.view.setSparkle(e.sparkle)}setPaint(e,t){return e.problem!==void 0?!1:(this.view.setPaint(Rf(e,t,this.received.texts)),!0)}setFilms(e,t){this.view.setFilms(Cf(e,t))}pause(e){e?this.view.pause():this.view.resume()}hold(e){this.view.hold(e)}setGamutWarning(e){this.view.setGamutWarning(e)}snapshot(){const{width:e,height:t}=this.canvas,i=document.createElement("canvas");i.width=e,i.height=t;const s=i.getContext("2d");if(s===null)return null;s.drawImage(this.canvas,0,0);const r=s.getImageData(0,0,e,t).data;return{width:e,height:t,pixels:r,samples:0,of:0}}when(e,t){e.then(t).catch(i=>{this.onFault(i instanceof Error?i.message:String(i))})}}function cu(n,e,t){const i=n.get(e)??t();return n.set(e,i),i.catch(()=>n.delete(e)),i}function ld({picture:n,recipe:e,view:t}){return n!==null&&n.recipe===e&&n.view===t}function Pr(n){const{picture:e,liveSamples:t}=n;return e===null||t===null?e!==null:!n.gamutWarning&&ld(n)&&e.samples>=n.enough}function Ux({kept:n,keptRecipe:e,view:t}){return n!==null&&n.recipe===e&&n.view===t&&n.samples>=cd}const Fx=300,uu=64,cd=16,Ox=3,Bx=7e5,hu=16;class kx{constructor(e){this.session=e,this.store=new $o({view:null,picture:null,keptRecipe:null,kept:null,fault:null,recipe:null,liveSamples:null,noLive:null,gamutWarning:!1,enough:hu}),this.live=null,this.liveRecipe=null,this.received=new Ix,this.size={width:0,height:0},this.meanModel="",this.withLines=new Set,this.underWay=null,this.quickWanted=!1,this.holders=new Set,this.postponed=!1}hold(e,t){t?this.holders.add(e):this.holders.delete(e),this.live?.hold(this.holders.has("colours")),t?this.underWay?.job.quick===!1&&(this.postponed=this.stop()):this.holders.size===0&&this.postponed&&this.startLater()}add(e,t,i){this.received.add(t,i),this.live?.setSchema(e)}resize(e,t){e===this.size.width&&t===this.size.height||(this.size={width:e,height:t},this.store.get().liveSamples!==null&&this.store.set({picture:null}),this.refresh())}begin(e){this.meanModel=e.mean_model;for(const{name:i,illuminant:s}of e.lights)s.startsWith("FL")&&this.withLines.add(i);if(this.store.get().view!==null)return;const t=e.shapes.find(({name:i})=>i==="ball")??e.shapes[0];t!==void 0&&this.setShape(e,t.name,!0)}setShape(e,t,i){const s=e.shapes.find(a=>a.name===t);if(s===void 0)return;const{view:r}=this.store.get();this.store.set({view:{shape:t,light:r===null||i?s.light:r.light,camera:uh(s),turn_deg:0,light_turn_deg:r?.light_turn_deg??0,sparkle:r?.sparkle??!0}}),this.refresh()}setView(e){const{view:t}=this.store.get();t!==null&&(this.store.set({view:{...t,...e}}),this.refresh())}paint(e){e!==this.store.get().recipe&&(this.store.set({recipe:e}),this.refresh())}attach(e,t,i){const s=r=>{this.live=null,this.store.set({liveSamples:null,noLive:r})};try{const r=l=>{this.store.get().liveSamples!==null&&(this.store.set({liveSamples:l}),this.pauseWhenCovered())},a=this.askForFilms.bind(this);this.live=new Nx(e,t,i,this.received,r,a,s),this.live.hold(this.holders.has("colours")),this.live.setGamutWarning(this.store.get().gamutWarning),this.store.set({noLive:null});const{view:o}=this.store.get();o!==null&&this.live.show(o,this.size.width,this.size.height)}catch(r){s(r instanceof Error?r.message:String(r))}}get wantsShader(){return this.live!==null}shader(e,t,i){this.liveRecipe=e;const s=this.live?.setPaint(t,i)===!0;this.store.set({liveSamples:s?0:null})}askForFilms(){const e=this.liveRecipe;if(!this.session.isOpen)return;const t=this.session.send("films",{recipe:e},(i,s)=>{this.session.forget(t),e===this.liveRecipe&&this.live?.setFilms(i,s)})}setGamutWarning(e){this.store.set({gamutWarning:e}),this.live?.setGamutWarning(e),e?this.live?.pause(!1):this.pauseWhenCovered()}keep(e){this.store.set({keptRecipe:e,kept:e===null?null:this.shown(e)}),this.refresh()}pauseWhenCovered(){const e=this.store.get();Pr(e)&&this.live?.pause((e.liveSamples??0)>0)}shown(e){const t=this.store.get(),i=Pr(t)||t.view===null?null:this.live?.snapshot();return i==null||t.view===null?t.picture:{...i,recipe:e,view:t.view}}abandon(){this.underWay=null,this.quickWanted=!1,clearTimeout(this.timer)}refresh(){clearTimeout(this.timer);const e=this.store.get().view?.light??"";if(this.store.set({enough:this.withLines.has(e)?uu:hu}),this.underWay?.job.quick===!0){this.quickWanted=!0;return}this.stop(),this.quickWanted=this.postponed=!1;const{view:t,liveSamples:i}=this.store.get();this.live?.pause(!1),t!==null&&this.live?.show(t,this.size.width,this.size.height),i===null?this.start(!0,!1):this.startLater()}stop(){return this.underWay===null?!1:(this.session.tell("stop",{what:"render"}),this.session.forget(this.underWay.id),this.underWay=null,!0)}startLater(){clearTimeout(this.timer),this.timer=setTimeout(()=>{this.start(!1,!1)},Fx)}start(e,t){const{view:i,keptRecipe:s,recipe:r}=this.store.get(),a=t?s:r,{width:o,height:l}=this.size;if(a===null||i===null||o*l===0||!this.session.isOpen||(this.postponed=this.holders.size>0&&!e,this.postponed))return;const c=Math.min(1,Math.sqrt(Bx/(o*l)))/(e?Ox:1),u={recipe:a,view:i,kept:t,quick:e},{sparkle:p,...h}=i,d={recipe:a,...p?{}:{model:this.meanModel},scene:{...h,camera:hh(i.camera,o,l)},width:Math.max(16,Math.round(o*c)),height:Math.max(16,Math.round(l*c)),samples:e?1:t?cd:uu},_=this.session.send("render",d,(v,m)=>{this.answered(_,u,v,m)});this.underWay={id:_,job:u}}answered(e,t,i,s){if(i.type==="picture"){const r=zx(t,i,s);if(this.store.set(t.kept?{kept:r}:{picture:r,fault:null}),this.pauseWhenCovered(),r.samples<r.of)return}else if(i.type==="error")this.store.set({fault:String(i.message)});else if(i.type!=="done")return;if(this.underWay?.id===e){if(this.session.forget(e),this.underWay=null,this.quickWanted)this.refresh();else if(t.quick)this.startLater();else if(!t.kept){const r=this.store.get();r.keptRecipe!==null&&!Ux(r)&&this.start(!1,!0)}}}}function zx(n,e,t){const i=t.find(({name:l})=>l==="rgb"),[s,r]=i?.shape??[];if(i===void 0||s===void 0||r===void 0)throw new Error("a picture came without its pixels");const a=i.data,o=new Uint8ClampedArray(r*s*4);for(let l=0,c=0;l<o.length;l+=4,c+=3)o[l]=a[c],o[l+1]=a[c+1],o[l+2]=a[c+2],o[l+3]=255;return{width:r,height:s,pixels:o,samples:Number(e.samples),of:Number(e.of),recipe:n.recipe,view:n.view}}function Hx(){return b("section",{class:"picture-panel","aria-label":"Picture",children:[b(Gx,{}),b(Vx,{}),b(Wx,{})]})}function Gx(){const n=ct(),e=we(r=>r.schema),t=Ft(r=>r.view),i=Ft(r=>r.keptRecipe),s=we(r=>r.ownShape);return b("div",{class:"picture-bar",children:[b(du,{label:"Shape",chosen:t?.shape??"",entries:e?.shapes??[],own:{text:"Own mesh …",files:Qo},choose:r=>{e!==null&&n.viewer.setShape(e,r,!1)},bring:r=>void n.ownFiles.bring("shape",r)}),s!==null&&s.name===t?.shape&&!/\.gl(tf|b)$/i.test(s.file.name)&&b("button",{type:"button",class:"small","aria-pressed":s.yUp,title:"The file's vertical is y, not z",onClick:()=>void n.ownFiles.bring("shape",s.file,!s.yUp),children:"Y up"}),b(du,{label:"Light",chosen:t?.light??"",entries:e?.lights??[],own:{text:"Own HDR …",files:jo},choose:r=>{n.viewer.setView({light:r})},bring:r=>void n.ownFiles.bring("light",r)}),b("button",{type:"button",title:"Turn back to where the shape began",onClick:()=>{const r=e?.shapes.find(({name:a})=>a===t?.shape);r!==void 0&&n.viewer.setView({camera:uh(r),turn_deg:0,light_turn_deg:0})},children:"Front"}),b("span",{class:"gap"}),b("button",{type:"button","aria-pressed":i!==null,title:i===null?"Keep the paint as it is now as A, and see changes beside it":"Stop comparing",onClick:()=>{const{recipe:r}=n.store.get().document;n.viewer.keep(i===null?r:null)},children:i===null?"Keep as A":"A | B"}),i!==null&&b("button",{type:"button",title:"Make A the paint again; the present one can be had back by undo",onClick:()=>{n.useMatch(i)},children:"Back to A"})]})}function du(n){const{label:e,chosen:t,entries:i,own:s}=n,r=Tt(null);return b(Gt,{children:[b("select",{"aria-label":e,title:i.find(({name:a})=>a===t)?.title,value:t,onChange:a=>{const{value:o}=a.currentTarget;a.currentTarget.value=t,o===""?r.current?.click():n.choose(o)},children:[i.map(({name:a,title:o})=>b("option",{value:a,children:o},a)),b("option",{value:"",children:s.text})]}),b("input",{ref:r,type:"file",accept:s.files,class:"hidden",tabIndex:-1,"aria-label":s.text.replace(" …",""),onChange:a=>{const[o]=a.currentTarget.files??[];a.currentTarget.value="",o!==void 0&&n.bring(o)}})]})}const fu=.4,$s=5;function pu(n,e){const t=n?.getContext("2d");if(n===null||t===null||t===void 0)return;if(e===null){t.clearRect(0,0,n.width,n.height);return}(n.width!==e.width||n.height!==e.height)&&(n.width=e.width,n.height=e.height);const i=e.pixels;t.putImageData(new ImageData(i,e.width,e.height),0,0)}function Vx(){const n=ct(),e=Tt(null),t=Tt(null),i=Tt(null),s=Tt(null),r=we(x=>x.schema!==null),a=Ft(Pr),o=Ft(x=>x.picture),l=Ft(x=>x.kept),c=Ft(x=>x.keptRecipe),u=Ft(x=>x.view),p=we(x=>x.document.recipe.name),[h,d]=nn(.5),_=Tt(null);pi(()=>{const x=e.current;if(x===null)return;const w=new ResizeObserver(()=>{n.viewer.resize(x.clientWidth,x.clientHeight)});return w.observe(x),()=>{w.disconnect()}},[n]),pi(()=>{r&&s.current!==null&&n.attach(s.current)},[n,r]),pr(()=>{pu(t.current,o)},[o]),pr(()=>{pu(i.current,l)},[l]);const v=(x,w,M,T=1)=>{if(u===null)return;const R=M?{light_turn_deg:Ql(u.light_turn_deg+x)}:{turn_deg:Ql(u.turn_deg+x),camera:Ef(u.camera,w,T)};n.viewer.setView(R)},m=x=>{const M={ArrowLeft:[-$s,0,1],ArrowRight:[$s,0,1],ArrowUp:[0,$s,1],ArrowDown:[0,-$s,1],"+":[0,0,1.2],"-":[0,0,.8333333333333334]}[x.key];M!==void 0&&(x.preventDefault(),v(M[0],M[1],x.shiftKey,M[2]))},f=`${typeof p=="string"?p:"The paint"}, ${u?.shape??""}, ${u?.light??""}`;return b("div",{class:"picture stage",ref:e,children:[b("div",{class:"turnable",role:"application",tabIndex:0,"aria-label":`Picture: ${f}. Arrow keys turn the shape, with Shift the light; plus and minus bring it nearer.`,onKeyDown:m,onPointerDown:x=>{x.button===0&&(x.currentTarget.setPointerCapture(x.pointerId),_.current={x:x.clientX,y:x.clientY})},onPointerMove:x=>{const w=_.current;if(w===null)return;const M=(x.clientX-w.x)*fu,T=(x.clientY-w.y)*fu;_.current={x:x.clientX,y:x.clientY},v(M,T,x.shiftKey)},onPointerUp:()=>{_.current=null},onPointerCancel:()=>{_.current=null},onWheel:x=>{x.preventDefault(),v(0,0,!1,Math.exp(-x.deltaY/600))},children:[b("canvas",{ref:s,class:a?"live":"live now"}),b("canvas",{ref:t,class:a?"traced now":"traced",width:"16",height:"16"}),c!==null&&b("div",{class:"wiped",style:{clipPath:`inset(0 ${String(100-100*h)}% 0 0)`},children:b("canvas",{ref:i,width:"16",height:"16"})})]}),c!==null&&b(Gt,{children:[b("span",{class:"side a",children:"A"}),b("span",{class:"side b",children:"B"}),b("div",{class:"wipe-line",style:{left:`${String(100*h)}%`}}),b("input",{class:"wipe",type:"range",min:"0",max:"1",step:"0.01",value:h,"aria-label":"Wipe between A, kept, and B, as it is now",onInput:x=>{d(Number(x.currentTarget.value))}})]})]})}function Wx(){const n=Ft(_=>_.picture),e=Ft(_=>_.fault),t=Ft(_=>_.noLive),i=we(_=>_.readings),s=i?.out_of_gamut.filter(Boolean).length??0,r=Ft(_=>_.liveSamples),a=Ft(Pr),o=Ft(ld),l=Ft(_=>_.gamutWarning),c=Ft(_=>_.view?.sparkle??!0),u=ct(),p=n!==null&&n.of>1&&(o||r===null)?n:null,h=p===null?"":`${String(p.samples)} of ${String(p.of)}`,d=r!==null&&!a?`Live${p===null?"":`, path traced ${h}`}`:p!==null?`Path traced, ${h}`:n===null?"No picture yet":"Draft";return b("div",{class:"picture-foot",children:[b("span",{class:"how-far",title:e??(t===null?"Samples a pixel of the path tracer's picture":`No live picture: ${t}`),children:e??(t===null?d:`${d}; no live picture`)}),b("progress",{max:p?.of??1,value:p?.samples??0,"aria-label":"Samples of the picture"}),b("label",{title:"Single flakes, or their mean",children:[b("input",{type:"checkbox",checked:c,onChange:_=>{u.viewer.setView({sparkle:_.currentTarget.checked})}})," ","Sparkle"]}),r!==null&&b("label",{title:"Colours outside of sRGB, in the live picture",children:[b("input",{type:"checkbox",checked:l,onChange:_=>{u.viewer.setGamutWarning(_.currentTarget.checked)}})," ","Mark"]}),b("span",{class:"gamut",role:"status",title:"Angles whose colours are outside of sRGB",children:s>0?`${String(s)} of ${String(i?.lab.length??0)} outside sRGB`:""})]})}function Xx(n){const{tabs:e,chosen:t,onChoose:i}=n,s=Tt(null),r=e.findIndex(({name:o})=>o===t),a=o=>{const l=o.key==="ArrowRight"?(r+1)%e.length:o.key==="ArrowLeft"?(r+e.length-1)%e.length:o.key==="Home"?0:o.key==="End"?e.length-1:null,c=l===null?void 0:e[l];l===null||c===void 0||(o.preventDefault(),i(c.name),s.current?.children[l]?.focus())};return b("section",{class:"tabs","aria-label":n.label,children:[b("div",{role:"tablist","aria-label":n.label,ref:s,onKeyDown:a,children:e.map(({name:o,title:l})=>b("button",{type:"button",role:"tab",id:`tab-${o}`,"aria-selected":o===t,"aria-controls":`panel-${o}`,tabIndex:o===t?0:-1,onClick:()=>{i(o)},children:l},o))}),e.filter(({name:o})=>o===t).map(({name:o,panel:l})=>b("div",{role:"tabpanel",id:`panel-${o}`,"aria-labelledby":`tab-${o}`,tabIndex:0,children:l()},o))]})}const Yn=Math.PI/180;function ud(n){return Math.hypot(n[1],n[2])}function $x(n){if(ud(n)<1e-9)return 0;const e=Math.atan2(n[2],n[1])/Yn;return e<0?(e+360)%360:e}function mu(n,e){if(n===0&&e===0)return 0;const t=Math.atan2(e,n)/Yn;return t<0?t+360:t}function qx(n,e){const[t,i,s]=n,[r,a,o]=e,l=((Math.hypot(i,s)+Math.hypot(a,o))/2)**7,c=1+.5*(1-Math.sqrt(l/(l+25**7))),u=Math.hypot(c*i,s),p=Math.hypot(c*a,o),h=mu(c*i,s),d=mu(c*a,o),_=u*p===0;let v=_?0:d-h;v>180?v-=360:v<-180&&(v+=360);const m=r-t,f=p-u,x=2*Math.sqrt(u*p)*Math.sin(v*Yn/2),w=(t+r)/2,M=(u+p)/2;let T=h+d;_||(Math.abs(h-d)>180&&(T+=T<360?360:-360),T/=2);const R=1-.17*Math.cos((T-30)*Yn)+.24*Math.cos(2*T*Yn)+.32*Math.cos((3*T+6)*Yn)-.2*Math.cos((4*T-63)*Yn),g=1+.015*(w-50)**2/Math.sqrt(20+(w-50)**2),E=1+.045*M,N=1+.015*M*R,C=30*Math.exp(-(((T-275)/25)**2)),L=-2*Math.sqrt(M**7/(M**7+25**7))*Math.sin(2*C*Yn),[H,W,I]=[m/g,f/E,x/N];return Math.sqrt(H*H+W*W+I*I+L*W*I)}const Yx=[[3.08039909,-1.53738318,-.54301591],[-.92122336,1.8759675,.04525586],[.05287394,-.20397696,1.15110302]];function Kx(n){const e=(n[0]+16)/116,[t,i,s]=[e+n[1]/500,e,e-n[2]/200].map(r=>r>6/29?r**3:3*(6/29)**2*(r-4/29));return Yx.map(([r,a,o])=>r*t+a*i+o*s)}const gu=1/255;function ni(n){const e=Kx(n),t=Math.max(...e,1);return{css:"#"+e.map(r=>{const a=Math.min(Math.max(r/t,0),1);return a<=.0031308?12.92*a:1.055*a**(1/2.4)-.055}).map(r=>Math.round(255*r).toString(16).padStart(2,"0")).join(""),tooBright:t>1+gu,outOfGamut:Math.min(...e)<-gu*t}}function Io(n,e,t){const i=(e-n)/t,s=10**Math.floor(Math.log10(i)),r=([1,2,5,10].find(o=>o*s>=i*.999)??10)*s,a=[];for(let o=Math.ceil(n/r-1e-9);o*r<=e+1e-9*r;++o)a.push(Number((o*r).toPrecision(12)));return a}function _u(n){let[e,t]=[1/0,-1/0];for(const i of n)e=Math.min(e,i),t=Math.max(t,i);return e<=t?[e,t]:[0,1]}function Zx(n,e,t,i){const s=n.map((l,c)=>({height:l,i:c})).sort((l,c)=>l.height-c.height),r=new Array(n.length).fill(0);let a=-1/0;for(const{height:l,i:c}of s)a=Math.max(l,a+e,t),r[c]=a;let o=i+e;for(const{i:l}of s.reverse())o=Math.min(r[l],o-e),r[l]=o;return r}function No(n,e){const{width:t,height:i}=e,s=e.named??!1,r=Math.max(...n.map(M=>M.label.length)),a={left:46,right:s?14+6.6*r:12,top:10,bottom:38},o={w:t-a.left-a.right,h:i-a.top-a.bottom};let[l,c]=e.x??_u(n.flatMap(M=>[...M.x])),[u,p]=e.y??_u(n.flatMap(M=>[...M.y]));if(c<=l&&([l,c]=[l-1,l+1]),p<=u&&(p=u+1),e.square??!1){const M=Math.max((c-l)/o.w,(p-u)/o.h)*1.12,[T,R]=[(l+c)/2,(u+p)/2];[l,c]=[T-M*o.w/2,T+M*o.w/2],[u,p]=[R-M*o.h/2,R+M*o.h/2]}const h=M=>a.left+(M-l)/(c-l)*o.w,d=M=>a.top+(1-(M-u)/(p-u))*o.h,_=M=>M.toFixed(1),v=M=>String(M).replace("-","−"),m=zt("svg",{viewBox:`0 0 ${String(t)} ${String(i)}`,class:"plot",role:"img","aria-label":e.describedAs}),[f,x]=[a.top+o.h,a.left+o.w];for(const M of Io(l,c,o.w/70)){const T=M===0&&(e.square??!1)?"axis":"grid";m.append(zt("path",{class:T,d:`M${_(h(M))} ${String(a.top)}V${_(f)}`}),zt("text",{x:_(h(M)),y:_(f+15),"text-anchor":"middle"},v(M)))}for(const M of Io(u,p,o.h/40)){const T=M===0?"axis":"grid";m.append(zt("path",{class:T,d:`M${String(a.left)} ${_(d(M))}H${_(x)}`}),zt("text",{x:a.left-6,y:_(d(M)+3.5),"text-anchor":"end"},v(M)))}m.append(zt("text",{class:"label",x:_(a.left+o.w/2),y:i-4,"text-anchor":"middle"},e.xLabel),zt("text",{class:"label",transform:`translate(11 ${_(a.top+o.h/2)}) rotate(-90)`,"text-anchor":"middle"},e.yLabel));const w=[];for(const M of n){const T=M.x.map((C,L)=>({x:h(C),y:d(M.y[L])})),R=T.map(({x:C,y:L},H)=>`${H===0?"M":"L"}${_(C)} ${_(L)}`).join(""),g=(M.pointColours??[]).map((C,L)=>{const{x:H,y:W}=T[L];return zt("circle",{cx:_(H),cy:_(W),r:4.5,style:`fill:${C}`})}),E=zt("g",{class:M.dashed??!1?"curve dashed":"curve"});E.dataset.label=M.label,E.append(zt("title",{},M.label),zt("path",{class:"casing",d:R}),zt("path",{class:"line",d:R,style:`stroke:${M.colour}`}),...g),m.append(E);const N=T[T.length-1];N!==void 0&&w.push({...N,label:M.label})}if(s){const M=Zx(w.map(T=>T.y+3.5),11.5,a.top+4,f+3);w.forEach((T,R)=>{const g=M[R];m.append(zt("path",{class:"leader",d:`M${_(x+1)} ${_(T.y)}L${_(x+8)} ${_(g-3.5)}`}),zt("text",{x:x+10,y:_(g),"text-anchor":"start"},T.label))})}return m}const Jx=60,Qx=5,jx=250;function eS(n,{low:e,high:t}){if(!(t>e))return[];const i=Ni((t-e)/Jx),s=[];for(let r=Math.ceil(e/i-1e-9);r*i<=t+1e-9*i;++r){const a=Number((r*i).toPrecision(12));Vd(n,a)&&s.push(a)}return s}class tS{constructor(e,t){this.session=e,this.onBusy=t,this.store=new $o({atlas:null,busy:!1,fraction:0,fault:null}),this.wanted="",this.underWay=null}want(e,t,i,s){const{geometries:r,illuminant:a,observer:o}=s,l={recipe:Nr(e,t,i[0]),key:dt(t),values:i,geometries:r,illuminant:a,observer:o},c=JSON.stringify(l);if(c===this.wanted||i.length===0)return;this.stop(),this.wanted=c,this.setBusy(!0);const u=i.length-1,p=i.filter((h,d)=>d%Qx===0||d===u);this.timer=setTimeout(()=>{this.ask({...l,values:p},()=>{this.ask(l,()=>{this.setBusy(!1)})})},jx)}stop(){clearTimeout(this.timer),this.store.get().busy&&(this.wanted=""),this.underWay!==null&&(this.session.tell("stop",{what:"atlas"}),this.session.forget(this.underWay),this.underWay=null),this.setBusy(!1)}setBusy(e){e!==this.store.get().busy&&(this.store.set({busy:e,fraction:0}),this.onBusy(e))}ask(e,t){if(!this.session.isOpen){this.stop();return}const i=this.session.send("atlas",e,s=>{if(s.type==="progress"){this.store.set({fraction:Number(s.fraction)});return}if(this.session.forget(i),this.underWay=null,s.type==="error"){this.store.set({fault:String(s.message)}),this.setBusy(!1);return}this.store.set({fault:null,atlas:s}),t()});this.underWay=i}}function nS(n){const e=/^([\d.]+)as(-?[\d.]+)(az-?[\d.]+)?$/.exec(n);if(e===null){const i=/^([\d.]+)to/.exec(n);return{name:n,lamp:i===null?NaN:Number(i[1]),aspecular:null}}const t=e[3]===void 0;return{name:n,lamp:Number(e[1]),aspecular:t?Number(e[2]):null}}function hd(n){const e=new Map;n.forEach((t,i)=>{const{lamp:s,aspecular:r}=nS(t);if(r===null)return;const a=e.get(s)??[];a.push({index:i,lamp:s,aspecular:r}),e.set(s,a)});for(const t of e.values())t.sort((i,s)=>i.aspecular-s.aspecular);return e}function fl(n){const e=[...hd(n)].map(([s,r])=>({title:`Lamp at ${String(s)}°`,places:r.map(({index:a,aspecular:o})=>({i:a,label:`${et(o,1).replace(/\.0$/,"")}°`}))})),t=new Set(e.flatMap(({places:s})=>s.map(({i:r})=>r))),i=n.map((s,r)=>({i:r,label:ds(s)})).filter(({i:s})=>!t.has(s));return i.length>0&&e.push({title:"Off the plane",places:i}),e}function $r(n,e){const{standard:t,geometries:i}=n,s=t?.geometries.indexOf(i[e])??-1;return t?.lab[s]??null}function iS(){const n=we(s=>s.readings),e=we(s=>s.fault===null),t=we(s=>s.readingsOf===s.document);if(n===null)return b("div",{class:"stage chips","aria-busy":"true"});const i=fl(n.geometries);return b("div",{class:e?"stage chips":"stage chips old",role:"group","aria-label":"Chips","data-current":t,children:[n.standard?.problem!==void 0&&b("p",{class:"problem",children:n.standard.problem}),i.map(s=>b("section",{"aria-label":s.title,children:[i.length>1&&b("h3",{children:s.title}),b("ol",{class:"chip-row",children:s.places.map(({i:r,label:a})=>b(sS,{readings:n,i:r,label:a},r))})]},s.title))]})}function sS({readings:n,i:e,label:t}){const i=n.lab[e],s=$r(n,e),r=n.standard,a=r?.delta_e_2000?.[e],o=r?.passes?.[e],l=[n.out_of_gamut[e]===!0?"outside sRGB, clipped":"",n.too_bright[e]===!0?"brighter than white, dimmed":""].filter(Boolean),c=`L* ${et(i[0],2)}, a* ${et(i[1],2)}, b* ${et(i[2],2)}`;return b("li",{class:"chip","data-geometry":n.geometries[e],"data-lab":i.join(" "),title:[ds(n.geometries[e]),c,...l].join(`
`),children:[b("div",{class:"faces",children:[s!==null&&b("i",{style:{background:ni(s).css}}),b("i",{style:{background:ni(i).css}}),l.length>0&&b("abbr",{"aria-label":l.join(", "),children:"!"})]}),b("b",{children:t.split(/(?=az)/).map(u=>b(Gt,{children:[u,b("wbr",{})]},u))}),b("span",{class:"lightness",children:[b("span",{class:"hidden",children:"L* "}),et(i[0],1)]}),r!==null&&b("span",{class:o===!1?"delta fails":"delta",children:[b("span",{class:"hidden",children:"Delta E "}),et(a,2),o===!1&&b("abbr",{title:"beyond the tolerance",children:" ✗"}),o===!0&&b("abbr",{title:"within the tolerance",children:" ✓"})]})]})}function vu({path:n}){return n[n.length-1]==="thickness_nm"}function rS(){const n=ct(),e=we(E=>E.schema),t=we(E=>E.document),i=we(E=>E.fault===null),s=we(E=>E.settings),r=we(E=>E.connection==="open"),a=Js(E=>E.fault),[o,l]=nn(null),[c,u]=nn(new Map),{recipe:p}=t,h=mi(()=>e===null?[]:eh(e,p),[e,p]),d=h.filter(vu),_=E=>h.find(({path:N})=>dt(N)===E),v=d.find(({path:E})=>E.includes("coats"))??d[0],m=_(o)??v??h[0],f=m===void 0?"":dt(m.path),x=aS(m,c.get(f)),w=mi(()=>m===void 0||x===null?[]:eS(m.info,x),[m?.info,x?.low,x?.high]);if(pi(()=>{m===void 0||!i||!r||n.atlas.want(p,m.path,w,s)},[n,p,f,w,s,i,r]),pi(()=>()=>{n.atlas.stop()},[n]),m===void 0||x===null)return null;const{label:M,unit:T}=$t(m.info.key),R=({path:E,info:N})=>{const C=fs(p,E),L=$t(N.key).label+(C===""?"":`, ${C}`);return b("option",{value:dt(E),children:L},dt(E))},g=E=>{u(new Map(c).set(f,{...x,...E}))};return b("div",{class:"atlas",children:[b("div",{class:"atlas-bar",children:[b("select",{"aria-label":"Number of the atlas",value:f,onChange:E=>{l(E.currentTarget.value)},children:[d.length>0&&b("optgroup",{label:"Films",children:d.map(R)}),b("optgroup",{label:"Other numbers",children:h.filter(E=>!vu(E)).map(R)})]}),b("span",{children:"From"}),b(xu,{label:"From",value:x.low,set:E=>{g({low:E})}}),b("span",{children:"to"}),b(xu,{label:"To",value:x.high,set:E=>{g({high:E})}}),b("span",{children:T})]}),w.length===0?b("p",{class:"fault-line",children:["Between ",On(x.low)," and ",On(x.high)," ",T," nothing is allowed."]}):a!==null?b("p",{class:"fault-line",children:a}):b(oS,{of:f,label:M,unit:T,now:m.value,locked:t.locks.has(f),take:E=>{n.edit(N=>cn(N,m.path,E))}})]})}function aS(n,e){const t=Tt(null);if(n===void 0)return null;if(e!==void 0)return e;const{path:i,info:s,value:r}=n,a=dt(i),o=t.current;if(o?.name===a&&r>=o.ends.low&&r<=o.ends.high)return o.ends;const{low:l,high:c}=rh(s,r);return t.current={name:a,ends:{low:l,high:c}},t.current.ends}function xu(n){return b("input",{type:"number",step:"any","aria-label":n.label,value:n.value,onChange:e=>{const t=e.currentTarget.valueAsNumber;Number.isFinite(t)?n.set(t):e.currentTarget.value=String(n.value)}})}function oS(n){const{now:e,take:t,unit:i}=n,s=Js(g=>g.atlas),r=Js(g=>g.busy),a=we(g=>g.readings),o=Js(g=>g.fraction),[l,c]=nn(null),u=s?.key===n.of?s:null,p=mi(()=>u===null?[]:lS(u),[u]);if(u===null)return b("p",{class:"empty",children:r?"Solving the paint at each value …":""});const{values:h}=u,[d,_]=[h[0],h[h.length-1]],v=g=>_>d?(g-d)/(_-d):.5,m=e>=d&&e<=_,f=l??{column:Su(h,e),geometry:p[0]?.geometry??0},x=(g,E)=>{const{left:N,width:C}=E.getBoundingClientRect(),L=d+(g.clientX-N)/C*(_-d);return Su(h,L)},w=g=>{const E=g.target.closest("[data-row]"),N=E===null?f.geometry:Number(E.dataset.row);c({column:x(g,g.currentTarget),geometry:N})},M=g=>{const E=h[g];E!==void 0&&!n.locked&&t(E)},T=g=>{const E=p.findIndex(({geometry:C})=>C===f.geometry),N=(C,L)=>{const H=p[Math.min(Math.max(E+L,0),p.length-1)],W=Math.min(Math.max(f.column+C,0),h.length-1);c({column:W,geometry:H?.geometry??0})};if(g.key==="ArrowLeft")N(-1,0);else if(g.key==="ArrowRight")N(1,0);else if(g.key==="ArrowUp")N(0,-1);else if(g.key==="ArrowDown")N(0,1);else if(g.key==="Home")N(-h.length,0);else if(g.key==="End")N(h.length,0);else if(g.key==="Enter"||g.key===" ")M(f.column);else return;g.preventDefault()},R=g=>`${(100*g).toFixed(2)}%`;return b("div",{class:"stage atlas-stage","aria-busy":r,children:[b("div",{class:"atlas-labels","aria-hidden":"true",children:p.map(({geometry:g,label:E})=>b("span",{children:E},g))}),b("div",{class:n.locked?"atlas-field locked":"atlas-field",role:"application",tabIndex:0,"aria-label":`Atlas of ${n.label.toLowerCase()}: arrow keys go from colour to colour, Enter takes one.`,onPointerMove:w,onPointerDown:w,onPointerLeave:()=>{c(null)},onClick:g=>{M(x(g,g.currentTarget))},onKeyDown:T,onBlur:()=>{c(null)},children:[p.map(({geometry:g,background:E})=>b("i",{class:g===f.geometry&&l!==null?"at":"","data-row":g,style:{background:E}},g)),m&&b("b",{class:"now",style:{left:R(v(e))}}),l!==null&&b("b",{class:"cursor",style:{left:R(v(h[l.column]??e))}})]}),a?.standard!=null&&b("div",{class:"atlas-standard",title:"The standard",children:p.map(({geometry:g})=>b(uS,{readings:a,geometry:g},g))}),b("div",{class:"atlas-axis","aria-hidden":"true",children:Io(d,_,5).map(g=>b("span",{style:{left:R(v(g))},children:On(g)},g))}),b("progress",{class:r?"":"done",max:1,value:o,"aria-label":"Colours of the atlas"}),b(hS,{atlas:u,place:f,unit:i,readings:a,hovers:l!==null})]})}function Su(n,e){let t=0;return n.forEach((i,s)=>{Math.abs(i-e)<Math.abs(n[t]-e)&&(t=s)}),t}function lS({geometries:n,rgb:e}){const t=fl(n);return t.flatMap(({title:i,places:s})=>s.map(({i:r,label:a})=>{const o=(e[r]??[]).map(ih),l=o.length===1?[...o,...o]:o;return{geometry:r,label:t.length>1?`${cS(i)}${a}`:a,background:`linear-gradient(to right, ${l.join(", ")})`}}))}function cS(n){const e=/\d+/.exec(n)?.[0];return e===void 0?"":`${e} / `}function uS(n){const e=$r(n.readings,n.geometry);return b("i",{style:e===null?{}:{background:ni(e).css}})}function hS(n){const{atlas:e,place:t,unit:i,readings:s}=n,r=e.values[t.column],a=e.lab[t.geometry]?.[t.column],o=e.lab.flatMap((c,u)=>{const p=s===null?null:$r(s,u),h=c[t.column];return p===null||h===void 0?[]:[qx(p,h)]}),l=o.reduce((c,u)=>c+u,0)/o.length;return b("p",{class:"atlas-reading",role:"status",children:[b("b",{children:[r===void 0?"":On(r)," ",i]}),b("span",{children:ds(e.geometries[t.geometry]??"")}),a!==void 0&&b(dS,{lab:a}),o.length>0&&b("span",{children:["mean ΔE ",et(l,1)]})]})}function dS({lab:n}){return b("span",{children:["L* ",et(n[0],1)," a* ",et(n[1],1)," b* ",et(n[2],1)]})}const fS=new Set(["volume_fraction","alpha"]);function pS({path:n,info:e}){const t=e.key==="thickness_nm"&&n.includes("coats");return n[0]==="layer"&&(t||fS.has(e.key))}function mS({path:n,value:e},t){const i=t.fit,s=typeof i=="object"&&dt(n)in i;return n[0]!=="fit"&&n[0]!=="uncertainty"&&(e!==0||s)}function gS(){const n=we(_=>_.schema),e=we(_=>_.document),t=we(_=>_.standard),i=we(_=>_.fit),s=ct(),[r,a]=nn(new Map),[o,l]=nn(4);if(n===null||t===null)return b("p",{class:"empty",children:"Load a standard first: measured readings as CSV. The fit then turns numbers of this paint until its colours match."});const{recipe:c,locks:u}=e,p=eh(n,c).filter(_=>mS(_,c)),h=_=>{const v=dt(_.path);return!u.has(v)&&(r.get(v)??pS(_))},d=p.filter(h).map(({path:_})=>dt(_));return b("div",{class:"fit",children:[b("p",{class:"fit-start",children:[i.running?b("button",{type:"button",onClick:()=>{s.stopFit()},children:"Stop"}):b("button",{type:"button",disabled:d.length===0,onClick:()=>{s.fit(d,o)},children:["Fit ",String(d.length)," ",d.length===1?"number":"numbers"]}),b("label",{children:["from"," ",b("input",{type:"number",min:"1",max:"64",value:o,disabled:i.running,"aria-label":"Starts",onChange:_=>{const v=Math.round(Number(_.currentTarget.value));v>=1&&l(v)}})," ",o===1?"start":"starts"]}),b("progress",{max:"1",value:i.fraction,"aria-label":"Progress of the fit",class:i.running?"":"idle"})]}),i.fault!==null&&b("p",{class:"fault-line",role:"alert",children:i.fault}),i.matches!==null&&b(_S,{matches:i.matches,colours:i.colours}),b("fieldset",{disabled:i.running,children:[b("legend",{children:"Free numbers"}),p.map(_=>{const v=dt(_.path),{label:m,unit:f}=$t(_.info.key);return b("label",{class:"free",children:[b("input",{type:"checkbox",checked:h(_),disabled:u.has(v),onChange:x=>{a(new Map(r).set(v,x.currentTarget.checked))}}),b("span",{children:[m,b("small",{children:fs(c,_.path)})]}),b("b",{children:[u.has(v)?"locked, ":"",On(_.value)," ",f]})]},v)})]})]})}function _S(n){const e=ct(),t=we(i=>i.document.recipe);return b("ol",{class:"matches","aria-label":"Paints that were found",children:n.matches.map((i,s)=>b("li",{class:i.recipe===t?"used":"",children:[b("div",{class:"match-head",children:[b("b",{children:["Mean ΔE ",et(i.mean_delta_e,2)]}),b("span",{children:["greatest ",et(i.max_delta_e,2)]}),b("button",{type:"button",class:"small","aria-label":`Use match ${String(s+1)}`,onClick:()=>{e.useMatch(i.recipe)},children:"Use"})]}),b("div",{class:"stage match-chips",children:n.colours[s]?.lab.map((r,a)=>{const o=$r(n.colours[s],a);return b("div",{class:"faces",children:[o!==null&&b("i",{style:{background:ni(o).css}}),b("i",{style:{background:ni(r).css}})]},a)})}),b("dl",{children:i.parameters.map(({key:r,value:a,sd:o,at_bound:l})=>{const c=Go(r),{label:u,unit:p}=$t(String(c.at(-1))),h=o===null?"":` ± ${On(Number(o.toPrecision(2)))}`;return[b("dt",{children:[u," ",b("small",{children:fs(i.recipe,c)})]},`${r} name`),b("dd",{children:[On(a),h," ",p,l&&" (at its bound)"]},r)]})})]},s))})}function pl({element:n}){const e=Tt(null);return pr(()=>{e.current?.replaceChildren(n)},[n]),b("div",{ref:e})}const Mu=340;function qs(n,e){const t=Math.floor(Math.min(...n)/e)*e,i=Math.ceil(Math.max(...n)/e)*e;return[t,Math.max(i,t+e)]}function yu(n,e,t,i){return[...hd(n.geometries)].map(([s,r])=>{const a=r.map(({index:l})=>n.lab[l]),o={x:a.map((l,c)=>t(l,r[c]?.aspecular??0)),y:a.map(i),colour:"var(--line)",label:`${String(s)}°${e?" std":""}`,dashed:e};return e?o:{...o,pointColours:a.map(l=>ni(l).css)}})}function Eu(n,e,t){const i=n.standard;return[...i===null?[]:yu(i,!0,e,t),...yu(n,!1,e,t)]}function vS(){const n=we(t=>t.details),e=mi(()=>{if(n===null)return null;const t=Eu(n,(c,u)=>u,c=>c[0]),i=Eu(n,c=>c[1],c=>c[2]),s=n.standard===null?"":"; the standard dashed",r=qs(t.flatMap(({x:c})=>[...c]),15),a=qs([...t.flatMap(({y:c})=>[...c]),99],25)[1],o=qs(i.flatMap(({x:c})=>[...c]),20),l=qs(i.flatMap(({y:c})=>[...c]),20);return[No(t,{width:Mu,height:158,xLabel:"Aspecular angle, °",yLabel:"L*",named:t.length>1,x:r,y:[0,a],describedAs:`Lightness over the aspecular angle${s}`}),No(i,{width:Mu,height:226,xLabel:"a*",yLabel:"b*",x:o,y:l,square:!0,describedAs:`The way of the colour through a* and b*${s}`})]},[n]);return e===null?null:b(Gt,{children:e.map((t,i)=>b(pl,{element:t},i))})}function xS(){const n=we(s=>s.details);if(n===null)return null;const e=n.standard,t=fl(n.geometries).flatMap(({places:s})=>s.map(({i:r})=>r)),i=s=>b("th",{scope:"row",children:[b("i",{class:"dot",style:{background:ni(n.lab[s]).css}}),ds(n.geometries[s])]});return b(Gt,{children:[b("table",{class:"figures",children:[b("thead",{children:b("tr",{children:["Angle","L*","a*","b*","C*","h"].map(s=>b("th",{scope:"col",children:s},s))})}),b("tbody",{children:t.map(s=>{const r=n.lab[s];return b("tr",{children:[i(s),[...r,ud(r)].map((a,o)=>b("td",{children:et(a,2)},o)),b("td",{children:et($x(r),1)})]},s)})})]}),e?.dL!==void 0&&b("table",{class:"figures","aria-label":"Differences from the standard",children:[b("thead",{children:b("tr",{children:["Sample − standard","ΔL*","ΔC*","ΔH*","ΔE2000"].map(s=>b("th",{scope:"col",children:s},s))})}),b("tbody",{children:t.map(s=>b("tr",{children:[i(s),[e.dL,e.dC,e.dH].map((r,a)=>b("td",{children:et(r?.[s],2)},a)),b("td",{class:"strong",children:et(e.delta_e_2000?.[s],2)})]},s))})]})]})}function SS(){const n=ct(),e=we(r=>r.sparkle),t=we(r=>r.sparkleFraction),i=we(r=>r.document),s=e!==null&&e.of.recipe!==i.recipe;return b("div",{class:"sparkle",children:[b("p",{class:"sparkle-start",children:[b("button",{type:"button",onClick:()=>{t===null?n.sparkle.measure():n.sparkle.stop()},children:t===null?"Measure sparkle and graininess":"Stop"}),b("progress",{max:"1",value:t??0,"aria-label":"Progress of the measurement",class:t===null?"idle":""})]}),e!==null&&b("div",{class:s?"old":"",children:[b("table",{class:"figures",children:[b("thead",{children:b("tr",{children:["Lamp","Sparkle","Spots per cm²","Intensity"].map(r=>b("th",{scope:"col",children:r},r))})}),b("tbody",{children:e.value.readings.map(r=>b("tr",{children:[b("th",{scope:"row",children:[et(r.theta_i,0),"°"]}),b("td",{children:bu(r.sparkle)}),b("td",{children:et(r.spots_per_cm2?.value,0)}),b("td",{children:et(r.intensity?.value,1)})]},r.theta_i))})]}),b("p",{children:["Graininess, diffuse light: ",b("b",{children:bu(e.value.graininess)})]}),s&&b("p",{class:"note",children:"Of the paint before the last change."})]})]})}function bu(n){if(n===null)return"–";const{value:e,standard_error:t}=n;return t===null?et(e,1):`${et(e,1)} ± ${et(t,1)}`}function wu(n,e){return n.wavelengths_nm.length===0?[]:n.reflectance.map((t,i)=>({x:n.wavelengths_nm,y:t,colour:ni(n.lab[i]).css,label:e?"":ds(n.geometries[i]),dashed:e}))}function MS(){const n=we(t=>t.details),e=mi(()=>{if(n===null)return null;const i=[...n.standard===null?[]:wu(n.standard,!0),...wu(n,!1)],s=Math.max(...i.flatMap(({y:r})=>[...r]));return No(i,{width:340,height:400,xLabel:"Wavelength, nm",yLabel:"Reflectance factor",y:[0,Ni(s*1.02)],named:!0,describedAs:"Reflectance factor over wavelength, a curve an angle"})},[n]);return e===null?null:b(pl,{element:e})}const yS=[{name:"flop",title:"Flop",panel:()=>b(vS,{})},{name:"numbers",title:"L*a*b*",panel:()=>b(xS,{})},{name:"spectra",title:"Spectra",panel:()=>b(MS,{})},{name:"atlas",title:"Atlas",panel:()=>b(rS,{})},{name:"sparkle",title:"Sparkle",panel:()=>b(SS,{})},{name:"fit",title:"Fit",panel:()=>b(gS,{})}];function ES(){const[n,e]=nn("flop");return b("section",{class:"results","aria-label":"Readings",children:[b(bS,{}),b(wS,{}),b(iS,{}),b(TS,{}),b(Xx,{label:"Details",tabs:yS,chosen:n,onChoose:e})]})}function bS(){const n=ct(),e=we(s=>s.schema),t=we(s=>s.settings),i=(s,r,a,o,l=c=>c)=>b("select",{"aria-label":s,title:s,value:r,onChange:c=>{o(c.currentTarget.value)},children:a.map(c=>b("option",{value:c,children:l(c)},c))});return b("div",{class:"conditions",children:[i("Angles",t.geometries,(e?.geometry_sets??[]).map(({name:s})=>s),s=>{n.setSettings({geometries:s})},s=>{const r=e?.geometry_sets.find(a=>a.name===s);return`${s}, ${String(r?.geometries.length??0)} angles`}),i("Illuminant",t.illuminant,e?.illuminants??[],s=>{n.setSettings({illuminant:s})}),i("Observer",t.observer,e?.observers??[],s=>{n.setSettings({observer:s})},s=>/^\d+$/.test(s)?`${s}°`:s)]})}function wS(){const n=ct(),e=we(r=>r.standard),t=we(r=>r.settings.tolerance),i=we(r=>r.readings),s=Tt(null);return b("div",{class:"standard",children:[b("input",{ref:s,type:"file",accept:".csv,.json,text/csv",class:"hidden",tabIndex:-1,"aria-label":"File of a standard",onChange:r=>{const[a]=r.currentTarget.files??[];r.currentTarget.value="",a!==void 0&&a.text().then(o=>{n.setStandard(o,a.name)})}}),e===null?b(Gt,{children:[b("button",{type:"button",class:"small",onClick:()=>s.current?.click(),children:"Load a standard …"}),b("button",{type:"button",class:"small",disabled:i===null,title:"The paint as it is now becomes the standard",onClick:()=>{i!==null&&n.setStandard(i.csv,"this paint.csv")},children:"Take this paint"})]}):b(Gt,{children:[b("span",{class:"standard-name",title:e.name,children:["Standard: ",b("b",{children:e.name})]}),b("label",{children:["ΔE ≤"," ",b("input",{type:"number",min:"0.01",max:"100",step:"0.1",value:t,"aria-label":"Tolerance, Delta E 2000 at each angle",onChange:r=>{const a=Number(r.currentTarget.value);a>0&&n.setSettings({tolerance:a})}})]}),b("button",{type:"button",class:"small","aria-label":"Remove the standard",onClick:()=>{n.setStandard(null,"")},children:"Remove"})]})]})}function TS(){const n=we(i=>i.readings),e=n?.standard??null,t=(i,s,r=!1)=>b("div",{class:r?"wide":"",children:[b("dt",{children:i}),b("dd",{children:s})]});return b("dl",{class:"key-figures",children:[t("Flop index",et(n?.flop_index,2)),t("Colour travel",et(n?.colour_travel.length,1)),t("Mean ΔE",et(e?.mean,2)),t("Greatest ΔE",et(e?.max,2))]})}function AS(n){try{return localStorage.getItem(`nacre-${n}`)}catch{return null}}function RS(n,e){try{localStorage.setItem(`nacre-${n}`,e)}catch{}}function Da(){const n=document.documentElement.dataset.theme;return n!==void 0?n==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function CS(){const n=Pd("button",{type:"button",class:"theme"}),e=AS("theme");(e==="light"||e==="dark")&&(document.documentElement.dataset.theme=e);const t=()=>{n.textContent=Da()?"Light":"Dark",n.setAttribute("aria-label",`Use ${Da()?"light":"dark"} greys`)};return n.addEventListener("click",()=>{const i=Da()?"light":"dark";document.documentElement.dataset.theme=i,RS("theme",i),t()}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",t),t(),n}function Tu(n,e){const{document:t,settings:i}=n.store.get(),{geometries:s,illuminant:r,observer:a,tolerance:o}=i;n.say("Making the report …"),n.ask("report",{recipe:t.recipe,geometries:s,illuminant:r,observer:a,tolerance:{limit:o}},l=>{if(l.type==="error"){n.say(String(l.message));return}const c=String(l.html);e==="pdf"?wf(c):js(er(t.recipe.name,"html"),c,"text/html"),n.say(e==="pdf"?"The report can be printed.":"The report was saved.")},l=>{n.say(`Making the report … ${(100*l).toFixed(0)} %`)})}function PS(){const n=ct(),e=we(a=>a.schema),t=we(a=>a.canUndo),i=we(a=>a.canRedo),s=mi(()=>CS(),[]),r=Tt(null);return b("header",{class:"top",children:[b("h1",{children:["Nacre ",b("span",{children:"Studio"})]}),b(Br,{label:"Start from a paint that ships",text:"Start from …",class:"start",chosen:null,choices:e?.paints??[],onChoose:a=>{const o=e?.paints.find(l=>l.name===a);o!==void 0&&n.openText(o.toml)}}),b("button",{type:"button",onClick:()=>r.current?.click(),children:"Open …"}),b("input",{ref:r,type:"file",accept:`.toml,.csv,.json,${Qo},${jo},application/toml,text/plain`,class:"hidden",tabIndex:-1,"aria-label":"File of a recipe, a standard, a mesh or a light",onChange:a=>{const[o]=a.currentTarget.files??[];a.currentTarget.value="",o!==void 0&&n.openFile(o)}}),b("span",{class:"pair",children:[b(ui,{icon:"undo",label:"Undo (Ctrl+Z)",disabled:!t,onClick:()=>{n.undo()}}),b(ui,{icon:"redo",label:"Redo (Ctrl+Y)",disabled:!i,onClick:()=>{n.redo()}})]}),b("span",{class:"gap"}),b(LS,{}),b(pl,{element:s})]})}function LS(){const n=ct(),e=we(({readings:s,readingsOf:r,document:a,fault:o})=>s!==null&&(o===null||r===a)),t=({document:s})=>s.recipe.name;return b("span",{class:"saving",children:[b("button",{type:"button",disabled:!e,title:"Save the recipe, .toml",onClick:()=>{n.whenCurrent(s=>{const r=s.paint?.toml??"";js(er(t(s),"toml"),r,"application/toml")})},children:"Save recipe"}),b("button",{type:"button",title:"Save the picture, .png",onClick:()=>{const s=globalThis.document.querySelector("canvas.now");s!==null&&Tf(s).then(r=>{js(er(t(n.store.get()),"png"),r,"image/png")},r=>{n.say(gr(r))})},children:"Picture"}),b("button",{type:"button",disabled:!e,title:"Save the readings, .csv",onClick:()=>{n.whenCurrent(s=>{const r=s.readings?.csv??"";js(er(t(s),"csv"),r,"text/csv")})},children:"Readings"}),b("button",{type:"button",disabled:!e,title:"Print the report of the panel, or save it as PDF",onClick:()=>{Tu(n,"pdf")},children:"Report"}),b("button",{type:"button",disabled:!e,"aria-label":"Report as HTML",title:"Save the report of the panel, .html",onClick:()=>{Tu(n,"html")},children:"HTML"}),b("button",{type:"button",title:"Copy an address that holds this paint",onClick:()=>{n.copyLink()},children:"Copy link"})]})}function Au(n){return n instanceof HTMLInputElement&&!["range","checkbox"].includes(n.type)}function DS(n){pi(()=>{const e=a=>{if(!(a.ctrlKey||a.metaKey)||Au(a.target))return;const o=a.key.toLowerCase();if(o==="z"&&!a.shiftKey)n.undo();else if(o==="y"||o==="z")n.redo();else return;a.preventDefault()},t=a=>{a.preventDefault()},i=a=>{a.preventDefault();const o=a.dataTransfer?.files[0];o!==void 0&&n.openFile(o)},s=a=>{const o=a.clipboardData?.getData("text")??"";Au(a.target)||!o.includes("=")||(a.preventDefault(),n.openText(o))},r=()=>{n.openLink(location.hash)};return document.addEventListener("keydown",e),document.addEventListener("dragover",t),document.addEventListener("drop",i),document.addEventListener("paste",s),addEventListener("hashchange",r),()=>{document.removeEventListener("keydown",e),document.removeEventListener("dragover",t),document.removeEventListener("drop",i),document.removeEventListener("paste",s),removeEventListener("hashchange",r)}},[n])}function IS({studio:n}){return DS(n),b(Bd,{value:n,children:[b(PS,{}),b("main",{class:"studio",children:[b(yf,{}),b(Hx,{}),b(ES,{})]}),b(NS,{})]})}function NS(){const n=we(r=>r.connection),e=we(r=>r.latency_ms),t=we(r=>r.notice),i=we(r=>r.schema?.version),s={connecting:"Connecting …",open:"",gone:"The studio's program does not answer: has it ended? The paint is safe in this page, which goes on when the same program answers again.",refused:"Another nacre studio answers here, which does not know this page. Open the address that it printed, and paste the paint there: Copy link has it."}[n];return b("footer",{class:s===""||n==="connecting"?"status":"status gone",children:[b("span",{class:"notice",role:"status","aria-live":"polite",title:s===""?t:s,children:s===""?t:s}),b("span",{class:"latency",title:"From the last change to its colours on the screen",children:e===null?"":`${et(e,0)} ms`}),b("span",{children:i===void 0?"":`Nacre ${i}`})]})}const US=500;class FS{constructor(e){this.present=e,this.past=[],this.future=[],this.gesture=null}get now(){return this.present}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}push(e,t=null){e!==this.present&&((t===null||t!==this.gesture)&&(this.past.push(this.present),this.past.length>US&&this.past.shift()),this.gesture=t,this.present=e,this.future=[])}begin(e){this.past=[],this.future=[],this.gesture=null,this.present=e}endGesture(){this.gesture=null}undo(){const e=this.past.pop();return e!==void 0&&(this.future.push(this.present),this.present=e),this.gesture=null,this.present}redo(){const e=this.future.pop();return e!==void 0&&(this.past.push(this.present),this.present=e),this.gesture=null,this.present}}class OS{constructor(e){this.send=e,this.underWay=null,this.waiting=null}get busy(){return this.underWay!==null}want(e){if(this.underWay!==null){this.waiting=e;return}this.underWay=e,this.send(e)}finished(){const e=this.waiting;this.underWay=this.waiting=null,e!==null&&this.want(e)}abandon(){const e=this.waiting??this.underWay;return this.underWay=this.waiting=null,e}}const Uo="#paint=",Ru=1<<20;async function dd(n,e){const i=new Blob([n]).stream().pipeThrough(e).getReader(),s=[];let r=0;for(;;){const{done:l,value:c}=await i.read();if(l)break;if(r+=c.length,r>Ru)throw await i.cancel(),new Error(`holds more than ${String(Ru)} bytes`);s.push(c)}const a=new Uint8Array(r);let o=0;for(const l of s)a.set(l,o),o+=l.length;return a}function BS(n){let e="";for(const t of n)e+=String.fromCharCode(t);return btoa(e).replace(/\+/g,"-").replace(/\//g,"_").replace(/=+$/,"")}function kS(n){const e=atob(n.replace(/-/g,"+").replace(/_/g,"/"));return Uint8Array.from(e,t=>t.charCodeAt(0))}async function Cu({recipe:n,locks:e}){const t=JSON.stringify(e.size>0?{recipe:n,locks:[...e]}:{recipe:n}),i=new TextEncoder().encode(t);return Uo+BS(await dd(i,new CompressionStream("deflate-raw")))}async function zS(n){if(!n.startsWith(Uo))return null;let e;try{const s=kS(n.slice(Uo.length)),r=await dd(s,new DecompressionStream("deflate-raw"));e=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(r))}catch(s){const r=s instanceof Error?s.message:String(s);throw new Error(`The paint in this address cannot be read; was it cut? (${r})`)}const t=e;if(typeof t!="object"||t===null||!ht(t.recipe))throw new Error("The address holds something that is no paint.");const i=Array.isArray(t.locks)?t.locks.filter(s=>typeof s=="string"):[];return{recipe:t.recipe,locks:new Set(i)}}class HS{constructor(e,t){this.store=e,this.session=t,this.id=null}measure(){if(!this.session.isOpen)return;const{document:e}=this.store.get();this.store.set({sparkleFraction:0}),this.id=this.session.send("sparkle",{recipe:e.recipe},t=>{if(t.type==="progress"){this.store.set({sparkleFraction:Number(t.fraction)});return}if(t.type==="error")this.store.set({sparkle:null,notice:String(t.message)});else{const i=t;this.store.set({sparkle:{of:e,value:i}})}this.abandon()})}stop(){this.id!==null&&this.session.tell("stop",{what:"sparkle"}),this.abandon()}abandon(){this.id!==null&&this.session.forget(this.id),this.id=null,this.store.set({sparkleFraction:null})}}const Pu=300,GS=4e3,VS={f32:Float32Array,u8:Uint8Array,u16:Uint16Array,u32:Uint32Array,f16:Uint16Array};function WS(n,e){let t=0;return n.map(i=>{const s=VS[i.dtype],r=i.shape.reduce((o,l)=>o*l,1),a=new s(e,t,r);return t+=Math.ceil(a.byteLength/4)*4,{...i,data:a}})}class XS{constructor(e,t){this.connect=e,this.onChange=t,this.socket=null,this.open=!1,this.closed=!1,this.nextId=1,this.wait=Pu,this.answers=new Map,this.awaiting=null,this.begin()}get isOpen(){return this.open}send(e,t,i){const s=this.nextId++;return this.answers.set(s,i),this.socket?.send(JSON.stringify({type:e,id:s,...t})),s}forget(e){this.answers.delete(e)}tell(e,t){this.open&&this.socket?.send(JSON.stringify({type:e,...t}))}close(){this.closed=!0,this.socket?.close()}begin(){const e=this.connect();this.socket=e,e.binaryType="arraybuffer",e.onopen=()=>{this.open=!0,this.wait=Pu,this.onChange(!0)},e.onclose=()=>{this.open=!1,this.awaiting=null,this.answers.clear(),!this.closed&&(this.onChange(!1),setTimeout(()=>{this.begin()},this.wait),this.wait=Math.min(2*this.wait,GS))},e.onmessage=({data:t})=>{this.receive(t)}}receive(e){if(typeof e=="string"){const t=JSON.parse(e);Array.isArray(t.binary)?this.awaiting=t:this.deliver(t,[])}else if(e instanceof ArrayBuffer&&this.awaiting!==null){const t=this.awaiting;this.awaiting=null,this.deliver(t,WS(t.binary,e))}}deliver(e,t){const{id:i}=e;i!==void 0&&this.answers.get(i)?.(e,t)}}const Lu={running:!1,fraction:0,matches:null,colours:[],fault:null,began:null},Ia={recipe:{},locks:new Set},$S=400;class qS{constructor(e){this.around=e,this.history=new FS(Ia),this.standardText=null,this.fitId=null,this.begun=!1,this.store=new $o({connection:"connecting",schema:null,document:Ia,canUndo:!1,canRedo:!1,paint:null,readings:null,readingsOf:null,details:null,fault:null,notOpened:null,latency_ms:null,settings:{geometries:"byk-mac",illuminant:"D65",observer:"10",tolerance:1},standard:null,sparkle:null,sparkleFraction:null,fit:Lu,ownShape:null,ownLight:null,notice:""}),this.painting=new OS(i=>{this.sendPaint(i)}),this.session=new XS(e.connect,i=>{i?this.connected():this.disconnected()}),this.viewer=new kx(this.session);let t=this.lamp;this.viewer.store.subscribe(()=>{this.lamp!==t&&(t=this.lamp,this.measure())}),this.atlas=new tS(this.session,i=>{this.viewer.hold("atlas",i)}),this.sparkle=new HS(this.store,this.session),this.ownFiles=new Uf(this.store,this.viewer,this.ask.bind(this))}async connected(){try{const e=this.store.get().schema??await this.around.schema();this.store.set({connection:"open",schema:e}),this.viewer.begin(e)}catch(e){this.say(`The server does not say what a paint has: ${gr(e)}`);return}if(this.standardText!==null&&this.sendStandard(),this.ownFiles.bringAgain(),this.begun){this.measure();return}this.begun=!0,await this.openLink(this.around.fragment())||this.openFirst()}disconnected(){this.around.refused().then(i=>{i&&!this.session.isOpen&&this.store.set({connection:"refused"})}),this.painting.abandon(),this.viewer.hold("colours",!1),this.viewer.abandon(),this.atlas.stop(),this.ownFiles.abandon(),this.fitId=null;const{connection:e}=this.store.get();this.store.set({connection:e==="refused"?"refused":"gone"}),this.sparkle.abandon();const{fit:t}=this.store.get();t.running&&this.store.set({fit:{...t,running:!1,fault:"The server went away before the fit had ended."}})}openFirst(){const{schema:e}=this.store.get(),t=e?.start??e?.paints[0]?.toml;t!==void 0&&this.openText(t)}attach(e){const t=()=>{const{schema:i}=this.store.get();i!==null&&this.viewer.attach(e,i,this.around.bytes),this.measure()};e.addEventListener("webglcontextrestored",t),t()}edit(e,t=null){const i=this.history.now;i===Ia?this.history.begin(e(i)):this.history.push(e(i),t),this.changed()}endGesture(){this.history.endGesture()}undo(){this.history.undo(),this.changed()}redo(){this.history.redo(),this.changed()}changed(){this.store.set({document:this.history.now,canUndo:this.history.canUndo,canRedo:this.history.canRedo,notOpened:null}),this.measure(),clearTimeout(this.linkTimer),this.linkTimer=setTimeout(()=>{Cu(this.history.now).then(this.around.setFragment)},$S)}openText(e){const t=this.session.send("open",{toml:e},i=>{if(this.session.forget(t),i.type==="error"){this.store.set({notOpened:String(i.message)});return}const s=i.tree;this.edit(()=>({recipe:s,locks:new Set}))})}openFile(e){const{name:t}=e,i=Nf(t);i!==null?this.ownFiles.bring(i,e):/\.(csv|json)$/i.test(t)?e.text().then(s=>{this.setStandard(s,t)}):e.text().then(s=>{this.openText(s)})}async openLink(e){try{const t=await zS(e);return t===null?!1:(this.edit(()=>t),!0)}catch(t){return this.say(gr(t)),!1}}say(e){this.store.set({notice:e})}setSettings(e){this.store.set({settings:{...this.store.get().settings,...e}}),this.measure()}get lamp(){const{view:e}=this.viewer.store.get();return(this.store.get().schema?.lights??[]).find(({name:i})=>i===e?.light)?.illuminant??"D65"}measure(){const{document:e,settings:t}=this.store.get();if(!this.session.isOpen||Object.keys(e.recipe).length===0)return;const{recipe:i}=e;this.viewer.hold("colours",!0);const s=this.around.now();this.painting.want({recipe:i,document:e,settings:t,lamp:this.lamp,since:s})}whenCurrent(e){const t=()=>{const s=this.store.get(),r=s.readingsOf===s.document;return r&&e(s),r||s.fault!==null||s.connection!=="open"};if(t())return;const i=this.store.subscribe(()=>{t()&&i()})}get settled(){return!this.painting.busy}sendPaint({recipe:e,document:t,settings:i,lamp:s,since:r}){const{geometries:a,illuminant:o,observer:l,tolerance:c}=i,u={recipe:e,geometries:a,illuminant:o,observer:l,tolerance:{limit:c},shader:t!==null&&this.viewer.wantsShader,lamp:s};let p=Promise.resolve(),h=null,d=null;const _=this.session.send("paint",u,(v,m)=>{if(t===null){this.receiveMatch(_,v);return}switch(v.type){case"recipe":h=v;break;case"readings":{const f=v;this.store.set({paint:h,readings:f,readingsOf:t,fault:null}),p=new Promise(x=>{this.around.drawn(()=>{d={details:f,latency_ms:this.around.now()-r},x()})});break}case"shader":p.then(()=>{this.viewer.shader(t.recipe,v,m)});break;case"error":this.store.set({fault:v}),this.answered(_,null);break;case"done":this.answered(_,t.recipe,p),p.then(()=>{this.around.drawn(()=>{d!==null&&this.store.set(d)})});break}})}answered(e,t,i=Promise.resolve()){this.session.forget(e),this.painting.finished(),t!==null&&this.viewer.paint(t),i.then(()=>{this.painting.busy||this.viewer.hold("colours",!1)}),this.measureMatch()}measureMatch(){const{fit:e,settings:t}=this.store.get(),i=e.matches?.[e.colours.length];if(i===void 0||this.painting.busy||!this.session.isOpen)return;const{recipe:s}=i,r=this.around.now();this.painting.want({recipe:s,document:null,settings:t,lamp:this.lamp,since:r})}receiveMatch(e,t){if(t.type==="readings"){const{fit:i}=this.store.get(),s=[...i.colours,t];this.store.set({fit:{...i,colours:s}})}else t.type==="done"?this.answered(e,null):t.type==="error"&&(this.session.forget(e),this.painting.finished())}setStandard(e,t){this.standardText=e===null?null:{csv:e,name:t},this.sendStandard()}sendStandard(){const{csv:e,name:t}=this.standardText??{csv:null,name:""},i=this.session.send("standard",{csv:e,name:t},s=>{if(this.session.forget(i),s.type==="error"){this.standardText=null,this.say(`The standard cannot be used: ${String(s.message)}`);return}const r=e===null?null:s;this.store.set({standard:r,notice:r?.notes.join(" ")??""}),this.measure()})}fit(e,t){const{document:i}=this.store.get();this.store.set({fit:{...Lu,running:!0,began:i}});const s={recipe:i.recipe,free:e,starts:t};this.fitId=this.session.send("fit",s,r=>{const{fit:a}=this.store.get();if(r.type==="progress"){this.store.set({fit:{...a,fraction:Number(r.fraction)}});return}const o={...a,running:!1,fraction:1};if(r.type==="matches"){const l=r.matches;this.store.set({fit:{...o,matches:l,colours:[],fault:null}}),this.measureMatch()}else r.type==="error"&&this.store.set({fit:{...o,fault:String(r.message)}});this.fitId!==null&&this.session.forget(this.fitId),this.fitId=null})}stopFit(){this.fitId!==null&&(this.session.tell("stop",{what:"fit"}),this.session.forget(this.fitId),this.fitId=null,this.store.set({fit:{...this.store.get().fit,running:!1}}))}useMatch(e){this.edit(t=>({...t,recipe:e}))}copyLink(){Cu(this.history.now).then(e=>(this.around.setFragment(e),navigator.clipboard.writeText(this.around.address()))).then(()=>{this.say("The address of this page holds the paint; it was copied.")},()=>{this.say("The address of this page holds the paint; the browser did not let it be copied.")})}ask(e,t,i,s=()=>{}){if(!this.session.isOpen)return!1;const r=this.session.send(e,t,(a,o)=>{if(a.type==="progress"){s(Number(a.fraction));return}this.session.forget(r),i(a,o)});return!0}}const ml=new URLSearchParams(location.search).get("token")??"",YS=`?token=${encodeURIComponent(ml)}`;async function Du(n){const e=await fetch(n,{headers:{"X-Nacre-Token":ml}});if(!e.ok)throw new Error(`${String(e.status)} ${e.statusText}: ${n}`);return e}const KS=new qS({connect:()=>{const n=location.protocol==="https:"?"wss:":"ws:";return new WebSocket(`${n}//${location.host}/api/session${YS}`)},schema:async()=>await(await Du("/api/schema")).json(),bytes:async n=>(await Du(n)).arrayBuffer(),refused:async()=>{try{const n={"X-Nacre-Token":ml},{status:e}=await fetch("/api/schema",{method:"HEAD",headers:n});return e===401}catch{return!1}},now:()=>performance.now(),drawn:n=>{requestAnimationFrame(()=>{setTimeout(n)})},fragment:()=>location.hash,setFragment:n=>{history.replaceState(null,"",n)},address:()=>location.href});bd(b(IS,{studio:KS}),document.body);
