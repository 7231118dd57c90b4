package org.pendant.editors.lsp.provider;

import static org.pendant.editors.lsp.provider.AnswerTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.Command;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.service.OutlineItem;
import org.pendant.language.source.SourceRange;
import org.pendant.testing.builtin.TestCatalogue;

/** Code lenses: Run and Debug above a program, and Run test and Debug test above each test. */
public final class CodeLenses {
  /** Commands that the client carries out; their argument is the URI, for tests also the name. */
  public static final String RUN = "pendant.run";

  public static final String DEBUG = "pendant.debug";
  public static final String RUN_TEST = "pendant.runTest";
  public static final String DEBUG_TEST = "pendant.debugTest";

  private static final String TEST_PREFIX = "test_";

  private CodeLenses() {}

  /**
   * Those of a text.
   *
   * @param lastRun how long the program took when it was run last, as text
   */
  public static List<CodeLens> of(
      Document document, Optional<String> lastRun, ClientFeatures client) {
    List<OutlineItem> outline = document.analysis().outline();
    List<CodeLens> lenses = new ArrayList<>();
    String uri = document.uri();
    if (TestCatalogue.isFor(document.source().name())) {
      for (OutlineItem item : outline) {
        if (item.name().startsWith(TEST_PREFIX)) {
          lenses.add(
              lens(
                  document,
                  item.nameRange(),
                  client.shown(text("runTest")),
                  RUN_TEST,
                  uri,
                  item.name()));
          lenses.add(
              lens(
                  document,
                  item.nameRange(),
                  client.shown(text("debugTest")),
                  DEBUG_TEST,
                  uri,
                  item.name()));
        }
      }
      return List.copyOf(lenses);
    }
    if (document.analysis().breakpointLines().isEmpty()) {
      return List.of();
    }
    SourceRange place = program(document, outline);
    lenses.add(lens(document, place, client.shown(text("run")), RUN, uri));
    lenses.add(lens(document, place, client.shown(text("debug")), DEBUG, uri));
    lastRun.ifPresent(text -> lenses.add(lens(document, place, client.shown(text), "")));
    return List.copyOf(lenses);
  }

  /** The program's function where the text has one alone, else the first statement. */
  private static SourceRange program(Document document, List<OutlineItem> outline) {
    if (outline.size() == 1 && outline.getFirst().kind() == OutlineItem.Kind.FUNCTION) {
      return outline.getFirst().nameRange();
    }
    int line = document.analysis().breakpointLines().first();
    int start = document.source().lineStart(line);
    return new SourceRange(start, start);
  }

  private static CodeLens lens(
      Document document, SourceRange place, String title, String command, String... arguments) {
    return new CodeLens(
        document.range(place),
        new Command(title, command, List.<Object>of((Object[]) arguments)),
        null);
  }
}
