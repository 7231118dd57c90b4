package org.pendant.editors.lsp.provider;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.lsp4j.DocumentHighlight;
import org.eclipse.lsp4j.DocumentHighlightKind;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PrepareRenameResult;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.Occurrence;
import org.pendant.language.service.Occurrence.Role;
import org.pendant.language.service.RenameResult;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.SourceRange;

/** Names: where they come from, where they are used, and new ones for them. */
public final class Names {
  private Names() {}

  /** Where the name at {@code position} comes from, in this text or in a script that it imports. */
  public static Optional<Location> definition(Document document, Position position) {
    return document
        .analysis()
        .definition(document.offset(position))
        .map(range -> location(document, range))
        .or(() -> imported(document, position));
  }

  /** The definition in a script that is imported. */
  private static Optional<Location> imported(Document document, Position position) {
    Optional<String> name =
        document
            .analysis()
            .occurrence(document.offset(position))
            .map(occurrence -> occurrence.symbol().name());
    return document
        .imported()
        .filter(names -> name.isPresent())
        .flatMap(
            names ->
                names
                    .script(name.get())
                    .map(
                        script ->
                            location(
                                script, names.definition(name.get()).orElseThrow().nameRange())));
  }

  /**
   * Where the name at {@code position} stands.
   *
   * @param declarations whether definitions and first assignments are among them
   */
  public static List<Location> references(
      Document document, Position position, boolean declarations) {
    int offset = document.offset(position);
    Optional<SourceRange> origin = document.analysis().definition(offset);
    return document.analysis().references(offset).stream()
        .filter(
            each ->
                declarations
                    || (each.role() != Role.DECLARE && !origin.equals(Optional.of(each.range()))))
        .map(each -> location(document, each.range()))
        .toList();
  }

  /** The places of the name at {@code position}; the words of the block whose word stands there. */
  public static List<DocumentHighlight> highlights(Document document, Position position) {
    int offset = document.offset(position);
    List<SourceRange> block = document.analysis().blockWords(offset);
    if (!block.isEmpty()) {
      return block.stream()
          .map(each -> new DocumentHighlight(document.range(each), DocumentHighlightKind.Text))
          .toList();
    }
    return document.analysis().references(offset).stream()
        .map(
            each ->
                new DocumentHighlight(
                    document.range(each.range()),
                    each.role() == Role.USE
                        ? DocumentHighlightKind.Read
                        : DocumentHighlightKind.Write))
        .toList();
  }

  /** The name at {@code position}, if it can have another. */
  public static Optional<PrepareRenameResult> renamable(Document document, Position position) {
    int offset = document.offset(position);
    return document
        .analysis()
        .occurrence(offset)
        .map(Occurrence::range)
        .filter(
            range -> {
              String probe = ByteText.decoded(document.source().text(range)) + "_";
              return document.analysis().rename(offset, probe) instanceof RenameResult.Renamed;
            })
        .map(
            range ->
                new PrepareRenameResult(
                    document.range(range), ByteText.decoded(document.source().text(range))));
  }

  /**
   * The edits that give the name at {@code position} another one.
   *
   * @throws ResponseErrorException with the reason, if it cannot have that name
   */
  public static WorkspaceEdit renamed(Document document, Position position, String name) {
    return switch (document.analysis().rename(document.offset(position), name)) {
      case RenameResult.Refused(String reason) -> throw RequestRefusal.of(reason);
      case RenameResult.Renamed(var edits) ->
          new WorkspaceEdit(Map.of(document.uri(), document.edits(edits)));
    };
  }

  private static Location location(Document document, SourceRange range) {
    return new Location(document.uri(), document.range(range));
  }
}
