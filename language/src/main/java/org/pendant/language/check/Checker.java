package org.pendant.language.check;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.check.CheckMemory.Surroundings;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.DefinitionKind;

/**
 * Checker: finds what is certainly wrong with a program before it runs.
 *
 * <p>Errors are certain: a program without them may still fail, but every error is a statement that
 * fails if it runs. Warnings name what runs but is hardly meant, what fails if it runs but does not
 * keep a robot from starting the program, and names that a library lacks: the program that takes it
 * in may have them. The text must have been parsed without syntax errors.
 */
public final class Checker {
  /** Warnings about statements that fail if they run. */
  private static final Set<String> FAILING =
      Set.of("missing-argument", "unknown-variable", "unassigned-variable");

  private Checker() {}

  /**
   * Whether what {@code found} is about certainly fails if it runs; such a warning is an error
   * wherever it is certain to run.
   */
  public static boolean fails(Diagnostic found) {
    return found.isError() || FAILING.contains(found.code());
  }

  /** Everything to say about {@code form}, in the order of the text. */
  public static List<Diagnostic> check(ProgramForm form, Catalogue catalogue) {
    return check(form, Scopes.of(form), catalogue);
  }

  /**
   * Everything to say about {@code form}, in the order of the text.
   *
   * @param scopes those of {@code form}
   */
  public static List<Diagnostic> check(ProgramForm form, Scopes scopes, Catalogue catalogue) {
    Survey survey = Survey.of(form, scopes, new Inference(catalogue));
    return check(form, scopes, catalogue, survey, Optional.empty());
  }

  /**
   * As the other, for a text without syntax errors of which an earlier version was checked: what
   * was said of definitions that are still the same is said again. The result is the same as
   * without it.
   *
   * @param source the text
   * @param memory of the versions of this text
   */
  public static List<Diagnostic> check(
      Source source, ProgramForm form, Scopes scopes, Catalogue catalogue, CheckMemory memory) {
    Survey survey = Survey.of(form, scopes, new Inference(catalogue));
    Surroundings surroundings = Surroundings.of(scopes, survey, catalogue, form.kind());
    KnownBodies known = new KnownBodies(source, scopes, memory.bodies(surroundings));
    List<Diagnostic> found = check(form, scopes, catalogue, survey, Optional.of(known));
    memory.keep(surroundings, known.now());
    return found;
  }

  private static List<Diagnostic> check(
      ProgramForm form,
      Scopes scopes,
      Catalogue catalogue,
      Survey survey,
      Optional<KnownBodies> known) {
    boolean library = form.kind() == ProgramForm.Kind.LIBRARY;
    CheckRun run = new CheckRun(catalogue, survey, false, library, known);
    DefinitionCheck definitions = new DefinitionCheck(run);
    Set<String> defined = new HashSet<>();
    for (Definition sibling : form.siblings()) {
      definitions.check(sibling, scopes.scope(sibling), defined);
    }
    CallGraph.Node node =
        form.entry().map(run.graph()::node).orElseGet(() -> new CallGraph.Node(""));
    FunctionState main = new FunctionState(scopes.mainScope(), node);
    form.entry().ifPresent(entry -> definitions.head(entry, main, defined));
    new StatementCheck(run, main).block(form.body());
    for (Definition definition : scopes.definitions()) {
      if (definition.kind() == DefinitionKind.SECONDARY) {
        run.graph()
            .reportSecondary(run.graph().node(definition), definition.name(), run.findings());
      }
    }
    Diagnostics findings = run.finished();
    findings.addAll(form.problems());
    return findings.sorted();
  }

  /**
   * Everything to say about one line of interpreter mode (manual 13), in the order of the text.
   *
   * @param line the line as a text of its own
   * @param scope the scope before the line: that of the function that called interpreter mode, or
   *     the one that the previous line has left
   */
  public static List<Diagnostic> checkLine(Script line, FunctionScope scope, Catalogue catalogue) {
    FunctionScope extended = scope.extendedBy(line.statements());
    Survey survey = Survey.nothingKnown(new Inference(catalogue));
    CheckRun run = new CheckRun(catalogue, survey, true, false, Optional.empty());
    FunctionState state = new FunctionState(extended, new CallGraph.Node(""));
    new StatementCheck(run, state).block(line.statements());
    return run.finished().sorted();
  }
}
