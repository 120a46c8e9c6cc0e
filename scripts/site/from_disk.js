// The search of a site on a disk: its worker is a script in a hidden frame.
window.Worker = class extends EventTarget {
  constructor(url) {
    super();
    const frame = document.createElement('iframe');
    frame.hidden = true;
    document.body.append(frame);
    this.scope = frame.contentWindow;
    this.scope.postMessage = (data) =>
      this.dispatchEvent(new MessageEvent('message', {data}));
    const script = this.scope.document.createElement('script');
    this.ready = new Promise((loaded) => { script.onload = loaded; });
    script.src = url;
    this.scope.document.body.append(script);
  }
  async postMessage(data) {
    await this.ready;
    this.scope.dispatchEvent(new MessageEvent('message', {data}));
  }
};
