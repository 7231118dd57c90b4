package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.pendant.language.check.Checker;
import org.pendant.language.check.MissingNames;
import org.pendant.language.check.ProgramForm;
import org.pendant.language.check.Scopes;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtins;

/**
 * Program loader: makes a program of a text: parse, check, compile. Pure; any thread may call it.
 */
public final class ProgramLoader {
  private ProgramLoader() {}

  /** Why none of a library runs. */
  private static Diagnostic noProgram(ProgramForm library) {
    List<Definition> functions =
        library.body().stream()
            .filter(Definition.class::isInstance)
            .map(Definition.class::cast)
            .filter(each -> each.kind() == Statement.DefinitionKind.FUNCTION)
            .toList();
    Definition last = functions.getLast();
    return Diagnostic.error(
        LoadResult.LIBRARY,
        last.nameRange(),
        functions.size() == 1
            ? text("libraryOfOne", library.name())
            : text("library", library.name(), functions.size()),
        "");
  }

  /** Loads a program file or a program received over a socket. */
  public static LoadResult load(Source source, Builtins<?> builtins) {
    return load(source, UnaryOperator.identity(), builtins, false);
  }

  /**
   * As {@link #load}, for runs that mark what they reach. They compute the same and take the same
   * robot time as those of the program without marks.
   */
  public static LoadResult loadCovered(Source source, Builtins<?> builtins) {
    return load(source, UnaryOperator.identity(), builtins, true);
  }

  /**
   * Loads a program that is not quite what its text says.
   *
   * @param change what is made of the text's statements before they are checked; their ranges are
   *     those of what they came from
   * @param covered whether its runs mark what they reach
   */
  public static LoadResult load(
      Source source, UnaryOperator<Script> change, Builtins<?> builtins, boolean covered) {
    ParseResult parsed = ScriptParser.parseProgram(source);
    List<Diagnostic> diagnostics = new ArrayList<>(parsed.diagnostics());
    if (diagnostics.stream().anyMatch(Diagnostic::isError)) {
      return new LoadResult(Optional.empty(), diagnostics);
    }
    ProgramForm form = ProgramForm.of(change.apply(parsed.script()));
    Scopes scopes = Scopes.of(form);
    diagnostics.addAll(MissingNames.together(source, Checker.check(form, scopes, builtins)));
    if (form.kind() == ProgramForm.Kind.LIBRARY) {
      diagnostics.add(noProgram(form));
    }
    if (diagnostics.stream().anyMatch(Diagnostic::isError)) {
      return new LoadResult(Optional.empty(), diagnostics);
    }
    try {
      Program program = new Compiler(source, form, scopes, builtins, covered).compile();
      return new LoadResult(Optional.of(program), diagnostics);
    } catch (ProgramTooLarge e) {
      diagnostics.add(
          Diagnostic.error("program-too-large", new SourceRange(0, 0), e.getMessage(), ""));
      return new LoadResult(Optional.empty(), diagnostics);
    }
  }
}
