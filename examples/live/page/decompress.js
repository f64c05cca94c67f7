// The bytes of base64 text of a gzip file, which is how the modules lie in the scripts: so the page needs to load nothing,
// and works from a folder as well.
export async function decompress(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
