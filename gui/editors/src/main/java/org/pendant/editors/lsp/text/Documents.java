package org.pendant.editors.lsp.text;

import static org.pendant.editors.lsp.text.DocumentTexts.text;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.pendant.language.signature.Catalogue;

/** Documents: the newest version of each text that the client has open; for any thread. */
public final class Documents {
  /** The most texts that may be open. */
  public static final int MAX_OPEN = 5000;

  private final Catalogues catalogues;
  private final Map<String, Document> open = new ConcurrentHashMap<>();
  private volatile PositionEncoding encoding = PositionEncoding.UTF16;

  public Documents(Catalogues catalogues) {
    this.catalogues = catalogues;
  }

  /** Takes positions in {@code chosen} units from now on. */
  public void countIn(PositionEncoding chosen) {
    encoding = chosen;
  }

  /**
   * The client has opened a text.
   *
   * @throws IllegalArgumentException if it is too long, or too many are open
   */
  public Document open(String uri, int version, String text) {
    if (open.size() >= MAX_OPEN && !open.containsKey(uri)) {
      throw new IllegalArgumentException(text("tooManyOpen", uri, MAX_OPEN));
    }
    Document document = of(uri, version, text.getBytes(StandardCharsets.UTF_8));
    open.put(uri, document);
    return document;
  }

  private Document of(String uri, int version, byte[] bytes) {
    return Document.of(uri, version, bytes, catalogue(uri), this::imported, encoding);
  }

  /**
   * A script that a file names, as the client has it open or as it is on the disk. A document of
   * its own, which imports nothing itself: files may name each other.
   */
  private Optional<Document> imported(String uri, String name) {
    Optional<Path> file = UriPath.beside(uri, name);
    if (file.isEmpty()) {
      return Optional.empty();
    }
    String named = file.get().toUri().toString();
    try {
      Optional<Document> known = find(named);
      byte[] bytes = known.isPresent() ? known.get().source().bytes() : bytes(file.get());
      return Optional.of(
          Document.of(named, 0, bytes, catalogue(named), Document::noImport, encoding));
    } catch (IOException | IllegalArgumentException e) {
      // a script that is not there, or is too long, has no names
      return Optional.empty();
    }
  }

  private static byte[] bytes(Path file) throws IOException {
    if (Files.size(file) > Document.MAX_BYTES) {
      throw new IOException(file + " is too long");
    }
    return Files.readAllBytes(file);
  }

  /** Has what files import looked up anew: a script has changed. */
  public void forgetImports() {
    open.replaceAll(
        (uri, document) -> document.imported().isEmpty() ? document : document.unread());
  }

  /** A text of the disk, which is not kept. */
  public Document ofDisk(String uri, byte[] bytes) {
    return of(uri, 0, bytes);
  }

  /**
   * The client has changed a text that it has open.
   *
   * @throws IllegalArgumentException if it is not open, or gets too long
   */
  public Document change(String uri, int version, List<TextDocumentContentChangeEvent> changes) {
    Document changed = get(uri).changed(version, changes, encoding);
    open.put(uri, changed);
    return changed;
  }

  public void close(String uri) {
    open.remove(uri);
  }

  public Optional<Document> find(String uri) {
    return Optional.ofNullable(open.get(uri));
  }

  /**
   * The newest version of {@code uri}.
   *
   * @throws IllegalArgumentException if it is not open
   */
  public Document get(String uri) {
    return find(uri).orElseThrow(() -> new IllegalArgumentException(text("notOpen", uri)));
  }

  public Collection<Document> all() {
    return open.values();
  }

  private Catalogue catalogue(String uri) {
    return catalogues.of(UriPath.fileName(uri));
  }
}
