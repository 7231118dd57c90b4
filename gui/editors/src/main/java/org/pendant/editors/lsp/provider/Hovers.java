package org.pendant.editors.lsp.provider;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.MarkupContent;
import org.eclipse.lsp4j.MarkupKind;
import org.eclipse.lsp4j.Position;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.Quantity;
import org.pendant.language.service.ScriptAnalysis;
import org.pendant.language.service.WrittenPose;
import org.pendant.language.source.SourceRange;

/** Hovers: what is known about the name, the number or the pose under the pointer. */
public final class Hovers {
  private Hovers() {}

  /** What is known about the name, the number or the pose at {@code position}. */
  public static Optional<Hover> at(Document document, Position position, ClientFeatures client) {
    int offset = document.offset(position);
    ScriptAnalysis analysis = document.analysis();
    return analysis
        .hover(offset)
        .map(hover -> told(document, hover.range(), explanation(hover, client), client))
        .or(() -> number(document, offset, client))
        .or(() -> pose(document, offset, client));
  }

  private static Explanations.Text explanation(
      org.pendant.language.service.Hover hover, ClientFeatures client) {
    List<String> lines = new ArrayList<>();
    hover.documentation().forEach(written -> written.lines().forEach(lines::add));
    hover.facts().forEach(fact -> lines.add(client.shown(fact)));
    // what has brackets is code
    String head = hover.head().indexOf('(') < 0 ? client.shown(hover.head()) : hover.head();
    return new Explanations.Text(head, lines);
  }

  private static Optional<Hover> number(Document document, int offset, ClientFeatures client) {
    return document
        .analysis()
        .quantity(offset)
        .map(
            quantity ->
                told(
                    document,
                    quantity.range(),
                    new Explanations.Text(line(quantity), List.of()),
                    client));
  }

  private static String line(Quantity quantity) {
    return quantity.name()
        + " = "
        + HumanUnits.number(quantity.value())
        + " "
        + quantity.unit().symbol()
        + HumanUnits.converted(quantity.value(), quantity.unit())
            .map(other -> " = " + other)
            .orElse("");
  }

  private static Optional<Hover> pose(Document document, int offset, ClientFeatures client) {
    return poseAt(document, offset)
        .map(
            pose ->
                told(
                    document,
                    pose.range(),
                    new Explanations.Text("", HumanUnits.lines(pose.elements(), client)),
                    client));
  }

  /** The pose of numbers at {@code offset}. */
  public static Optional<WrittenPose> poseAt(Document document, int offset) {
    return document.analysis().poses().stream()
        .filter(pose -> pose.range().start() <= offset && offset <= pose.range().end())
        .findFirst();
  }

  private static Hover told(
      Document document, SourceRange range, Explanations.Text text, ClientFeatures client) {
    MarkupContent content =
        client.markdown()
            ? new MarkupContent(MarkupKind.MARKDOWN, text.markdown())
            : new MarkupContent(MarkupKind.PLAINTEXT, text.plain());
    return new Hover(content, document.range(range));
  }
}
