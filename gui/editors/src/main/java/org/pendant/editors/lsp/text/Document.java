package org.pendant.editors.lsp.text;

import static org.pendant.editors.lsp.text.DocumentTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.eclipse.lsp4j.TextEdit;
import org.pendant.language.service.ScriptAnalysis;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.testing.builtin.TestCatalogue;

/**
 * Document: one version of a text, which never changes. It is analysed when something about it is
 * asked for the first time, by whichever thread asks, with the help of what is known of the version
 * before.
 */
public final class Document {
  /** The most bytes of a text. */
  public static final int MAX_BYTES = 16 << 20;

  private final String uri;
  private final int version;
  private final Source source;
  private final Catalogue catalogue;
  private final TextPositions positions;
  private final ImportedNames.Finder imports;
  private Optional<ImportedNames> imported = Optional.empty();
  private boolean analysed;

  /** That of this text once it is made; before, that of an earlier version, if there is one. */
  private volatile Optional<ScriptAnalysis> newest;

  private Document(
      String uri,
      int version,
      Source source,
      Catalogue catalogue,
      ImportedNames.Finder imports,
      TextPositions positions,
      Optional<ScriptAnalysis> earlier) {
    this.uri = uri;
    this.version = version;
    this.source = source;
    this.catalogue = catalogue;
    this.imports = imports;
    this.positions = positions;
    newest = earlier;
  }

  /** Nothing can be imported. */
  static Optional<Document> noImport(String uri, String name) {
    return Optional.empty();
  }

  /**
   * A document with the text of a client.
   *
   * @param catalogue the functions that it may call
   * @throws IllegalArgumentException if the text is too long
   */
  public static Document of(
      String uri, int version, String text, Catalogue catalogue, PositionEncoding encoding) {
    return of(
        uri,
        version,
        text.getBytes(StandardCharsets.UTF_8),
        catalogue,
        Document::noImport,
        encoding);
  }

  /** As the other, with bytes, and scripts that it may import. */
  static Document of(
      String uri,
      int version,
      byte[] bytes,
      Catalogue catalogue,
      ImportedNames.Finder imports,
      PositionEncoding encoding) {
    refuseLong(uri, bytes.length);
    Source source = Source.of(UriPath.fileName(uri), bytes);
    TextPositions positions = new TextPositions(source.text(), encoding);
    return new Document(uri, version, source, catalogue, imports, positions, Optional.empty());
  }

  /** The same text, which has not been looked at yet: what it imports may have changed. */
  Document unread() {
    return new Document(uri, version, source, catalogue, imports, positions, newest);
  }

  private static void refuseLong(String uri, long bytes) {
    if (bytes > MAX_BYTES) {
      throw new IllegalArgumentException(text("tooManyBytes", uri, bytes, MAX_BYTES));
    }
  }

  /**
   * The next version.
   *
   * @param changes one after the other, each of the text that the one before has left
   * @throws IllegalArgumentException if it gets too long
   */
  public Document changed(
      int newVersion, List<TextDocumentContentChangeEvent> changes, PositionEncoding encoding) {
    Document changed = this;
    for (TextDocumentContentChangeEvent change : changes) {
      changed = changed.with(newVersion, change, encoding);
    }
    return changed;
  }

  private Document with(
      int newVersion, TextDocumentContentChangeEvent change, PositionEncoding encoding) {
    String inserted = ByteText.asBytes(change.getText());
    String before = source.text();
    SourceRange range =
        change.getRange() == null
            ? new SourceRange(0, before.length())
            : positions.range(change.getRange());
    refuseLong(uri, (long) before.length() - (range.end() - range.start()) + inserted.length());
    String after = before.substring(0, range.start()) + inserted + before.substring(range.end());
    Source changed = Source.of(source.name(), after.getBytes(StandardCharsets.ISO_8859_1));
    TextPositions moved = new TextPositions(changed.text(), encoding);
    return new Document(uri, newVersion, changed, catalogue, imports, moved, newest);
  }

  public String uri() {
    return uri;
  }

  /** Counts the changes that the client has made; 0 for a text from the disk. */
  public int version() {
    return version;
  }

  public Source source() {
    return source;
  }

  public TextPositions positions() {
    return positions;
  }

  /** What the language says of it. */
  public synchronized ScriptAnalysis analysis() {
    if (!analysed) {
      ScriptAnalysis made =
          newest
              .map(earlier -> earlier.changed(source, catalogue))
              .orElseGet(() -> ScriptAnalysis.of(source, catalogue));
      if (TestCatalogue.isFor(source.name())) {
        imported = ImportedNames.of(made, uri, imports);
        if (imported.isPresent()) {
          made = made.changed(source, imported.get());
        }
      }
      newest = Optional.of(made);
      analysed = true;
    }
    return newest.orElseThrow();
  }

  /** What it has of the scripts that it imports; empty for a text that imports none. */
  public synchronized Optional<ImportedNames> imported() {
    analysis();
    return imported;
  }

  public int offset(Position position) {
    return positions.offset(position);
  }

  public Range range(SourceRange range) {
    return positions.range(range);
  }

  /** An edit as the protocol has it. */
  public TextEdit edit(org.pendant.language.service.TextEdit edit) {
    return new TextEdit(range(edit.range()), ByteText.decoded(edit.text()));
  }

  public List<TextEdit> edits(List<org.pendant.language.service.TextEdit> edits) {
    return edits.stream().map(this::edit).toList();
  }
}
