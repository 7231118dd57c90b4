package org.pendant.editors.lsp.provider;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.InlayHintKind;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.CallSite;
import org.pendant.language.service.CallSite.Given;
import org.pendant.language.service.Quantity;
import org.pendant.language.service.WrittenPose;
import org.pendant.language.signature.Parameter;
import org.pendant.language.source.SourceRange;

/**
 * Inlay hints: names of parameters before numbers and other values that do not say what they are,
 * their units behind them, and behind a pose the same in mm and degrees.
 */
public final class InlayHints {
  /** The most for one request. */
  private static final int MAX_HINTS = 5000;

  private final Document document;
  private final HintSettings settings;
  private final ClientFeatures client;
  private final SourceRange asked;
  private final List<InlayHint> hints = new ArrayList<>();

  private InlayHints(Document document, Range range, HintSettings settings, ClientFeatures client) {
    this.client = client;
    this.document = document;
    this.settings = settings;
    asked = document.positions().range(range);
  }

  /** Those in {@code range}. */
  public static List<InlayHint> of(
      Document document, Range range, HintSettings settings, ClientFeatures client) {
    InlayHints hints = new InlayHints(document, range, settings, client);
    for (CallSite call : document.analysis().calls()) {
      if (hints.concerns(call.range())) {
        call.arguments().forEach(hints::argument);
      }
    }
    if (settings.poses()) {
      document.analysis().poses().stream()
          .filter(pose -> hints.concerns(pose.range()))
          .forEach(hints::pose);
    }
    return hints.hints.stream().limit(MAX_HINTS).toList();
  }

  private boolean concerns(SourceRange range) {
    return range.start() <= asked.end() && asked.start() <= range.end();
  }

  private void argument(Given given) {
    Optional<Parameter> parameter = given.parameter();
    if (parameter.isEmpty() || !concerns(given.value())) {
      return;
    }
    String text = document.source().text(given.value());
    boolean saysIt = given.byName() || text.equals(parameter.get().name());
    if (settings.parameterNames() && !saysIt) {
      InlayHint hint =
          new InlayHint(
              document.positions().position(given.value().start()),
              Either.forLeft(parameter.get().name() + ":"));
      hint.setKind(InlayHintKind.Parameter);
      hint.setPaddingRight(true);
      hint.setTooltip(parameter.get().described());
      hints.add(hint);
    }
    if (settings.units()) {
      document
          .analysis()
          .quantity(given.value().start())
          .filter(quantity -> quantity.range().equals(given.value()))
          .ifPresent(this::unit);
    }
  }

  private void unit(Quantity quantity) {
    InlayHint hint =
        new InlayHint(
            document.positions().position(quantity.range().end()),
            Either.forLeft(quantity.unit().symbol()));
    hint.setPaddingLeft(true);
    HumanUnits.converted(quantity.value(), quantity.unit()).ifPresent(hint::setTooltip);
    hints.add(hint);
  }

  private void pose(WrittenPose pose) {
    InlayHint hint =
        new InlayHint(
            document.positions().position(pose.range().end()),
            Either.forLeft(HumanUnits.shortPose(pose.elements())));
    hint.setPaddingLeft(true);
    hint.setTooltip(String.join("\n", HumanUnits.lines(pose.elements(), client)));
    hints.add(hint);
  }
}
