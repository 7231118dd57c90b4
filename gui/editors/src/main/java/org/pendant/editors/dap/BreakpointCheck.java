package org.pendant.editors.dap;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.language.service.GuestExpression;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.LogMessage;

/** Breakpoint check: reads conditions and messages of breakpoints before they are computed. */
final class BreakpointCheck {
  /** Texts beyond this length would take too long to be read for it, in bytes. */
  private static final int LONG = 300_000;

  private final Catalogue catalogue;

  BreakpointCheck(Catalogue catalogue) {
    this.catalogue = catalogue;
  }

  /** Why a breakpoint cannot have them; empty if it can. */
  Optional<String> refusal(DebuggedText text, int line, String condition, String message) {
    if (text.source().text().length() > LONG) {
      return Optional.empty();
    }
    List<String> expressions =
        Stream.concat(
                Stream.of(condition).filter(each -> !each.isBlank()).map(ByteText::asBytes),
                LogMessage.of(ByteText.asBytes(message)).expressions().stream()
                    .map(LogMessage.Part::text))
            .toList();
    return expressions.stream()
        .flatMap(
            each ->
                GuestExpression.of(text.source(), catalogue, line, each).problem().stream()
                    .map(found -> ByteText.decoded(each + ": " + found.message())))
        .findFirst();
  }
}
