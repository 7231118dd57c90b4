package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.function.Supplier;
import org.pendant.language.check.Nearest;
import org.pendant.language.signature.Catalogue;

/** Command {@code pendant functions [NAME]}: the function reference in the terminal. */
final class FunctionsCommand implements Subcommand {
  private static final Option MARKDOWN =
      Option.flag("--markdown").explained("--markdown.functions");

  private static final Option TESTS = Option.flag("--tests");

  private final Supplier<? extends Catalogue> catalogue;
  private final Supplier<? extends Catalogue> ofTests;

  /**
   * The command.
   *
   * @param catalogue what programs may call
   * @param ofTests what tests may call
   */
  FunctionsCommand(Supplier<? extends Catalogue> catalogue, Supplier<? extends Catalogue> ofTests) {
    this.catalogue = catalogue;
    this.ofTests = ofTests;
  }

  @Override
  public String name() {
    return "functions";
  }

  @Override
  public String operands() {
    return "[NAME]";
  }

  @Override
  public List<Option> options() {
    return List.of(MARKDOWN, TESTS);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    List<String> names = arguments.operands();
    if (names.size() > 1 || (arguments.has(MARKDOWN) && !names.isEmpty())) {
      throw new UsageException(text("unexpected", names.getLast()));
    }
    FunctionReference reference =
        arguments.has(TESTS)
            ? FunctionReference.ofTests(ofTests.get())
            : new FunctionReference(catalogue.get());
    if (arguments.has(MARKDOWN)) {
      console.print(reference.markdown().stripTrailing());
    } else if (names.isEmpty()) {
      reference.table().forEach(console::print);
    } else {
      explain(names.getFirst(), reference, console);
    }
    return ExitCode.DONE;
  }

  private static void explain(String word, FunctionReference reference, Console console)
      throws UsageException {
    // People copy the name from a call.
    String name = word.endsWith("()") ? word.substring(0, word.length() - 2) : word;
    List<String> lines = reference.entries(name);
    if (lines.isEmpty()) {
      String hint =
          new Nearest()
              .to(name, reference::names)
              .map(near -> text("didYouMean", near))
              .orElse(text("functionsListsAll"));
      throw new UsageException(text("noFunction", name, hint));
    }
    lines.forEach(console::print);
  }
}
