package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.DefinitionKind;
import org.pendant.language.syntax.Statement.Evaluate;
import org.pendant.language.syntax.Statement.Label;

/**
 * Program form: which part of a script runs, and as what.
 *
 * @param kind what the script is
 * @param name the program's name: that of {@code entry}, or the file's name without extension
 * @param body the statements that run as the main level; the variables assigned there are globals
 * @param entry the definition whose body that is; empty for a fragment and a library
 * @param siblings the other top-level definitions, callable from everywhere; empty for a fragment
 *     and a library, whose definitions stand in {@code body}
 * @param problems what is wrong with the form itself: {@code empty-program}, {@code
 *     entry-parameters}, and the warning {@code trailing-call}
 */
public record ProgramForm(
    Kind kind,
    String name,
    List<Statement> body,
    Optional<Definition> entry,
    List<Definition> siblings,
    List<Diagnostic> problems) {

  /** What a script is. */
  public enum Kind {
    /** Definitions only; the last function among them runs. */
    PROGRAM,
    /** Definitions only, the last one a secondary program (manual 12). */
    SECONDARY,
    /** Statements without a function around them. */
    FRAGMENT,
    /**
     * Functions for other programs, the last of which cannot run by itself, and variables that they
     * share: nothing here is a program.
     */
    LIBRARY
  }

  public ProgramForm {
    body = List.copyOf(body);
    siblings = List.copyOf(siblings);
    problems = List.copyOf(problems);
  }

  /** The form of {@code script}. */
  public static ProgramForm of(Script script) {
    List<Definition> definitions = new ArrayList<>();
    List<Statement> others = new ArrayList<>();
    for (Statement statement : script.statements()) {
      if (statement instanceof Definition definition) {
        definitions.add(definition);
      } else if (!(statement instanceof Label)) {
        others.add(statement);
      }
    }
    Optional<Definition> entry = entry(definitions);
    if (entry.isPresent() && isLibrary(entry.get(), definitions, others)) {
      return statements(Kind.LIBRARY, script, List.of());
    }
    if (entry.isPresent()) {
      if (others.isEmpty()) {
        return program(entry.get(), definitions, List.of());
      }
      if (callsLastFunction(script.statements(), others, entry.get())) {
        String name = entry.get().name();
        String message = text("trailingCall", name);
        return program(
            entry.get(),
            definitions,
            List.of(Diagnostic.warning("trailing-call", others.getFirst().range(), message)));
      }
    }
    return fragment(script, definitions.isEmpty() && others.isEmpty());
  }

  private static ProgramForm program(
      Definition entry, List<Definition> definitions, List<Diagnostic> warnings) {
    List<Diagnostic> problems = new ArrayList<>(warnings);
    for (ParameterDeclaration parameter : entry.parameters()) {
      if (parameter.defaultValue().isEmpty()) {
        String message = text("programParameter", entry.name(), parameter.name());
        problems.add(Diagnostic.error("entry-parameters", parameter.range(), message, ""));
      }
    }
    // Not equals: two definitions with the same text are still two.
    List<Definition> siblings = new ArrayList<>(definitions);
    siblings.removeIf(definition -> isSame(definition, entry));
    Kind kind = entry.kind() == DefinitionKind.SECONDARY ? Kind.SECONDARY : Kind.PROGRAM;
    return new ProgramForm(
        kind, entry.name(), entry.body(), Optional.of(entry), siblings, problems);
  }

  private static ProgramForm fragment(Script script, boolean empty) {
    List<Diagnostic> problems = List.of();
    if (empty) {
      SourceRange start = new SourceRange(0, 0);
      String message = text("emptyProgram", script.source().name());
      problems = List.of(Diagnostic.error("empty-program", start, message, ""));
    }
    return statements(Kind.FRAGMENT, script, problems);
  }

  private static ProgramForm statements(Kind kind, Script script, List<Diagnostic> problems) {
    String name = baseName(script.source().name());
    return new ProgramForm(kind, name, script.statements(), Optional.empty(), List.of(), problems);
  }

  /**
   * Whether nothing of a file can run: its last function waits for values, and what stands around
   * the functions only names values.
   */
  private static boolean isLibrary(
      Definition last, List<Definition> definitions, List<Statement> others) {
    Set<String> own = definitions.stream().map(Definition::name).collect(Collectors.toSet());
    return last.kind() == DefinitionKind.FUNCTION
        && last.parameters().stream().anyMatch(each -> each.defaultValue().isEmpty())
        && others.stream()
            .allMatch(each -> each instanceof Assign assign && !calls(assign.value(), own));
  }

  /** Whether {@code value} calls or starts one of these functions. */
  private static boolean calls(Expression value, Set<String> functions) {
    return switch (value) {
      case Expression.Call call ->
          functions.contains(call.function()) || argumentsCall(call.arguments(), functions);
      case Expression.MethodCall call ->
          calls(call.receiver(), functions) || argumentsCall(call.arguments(), functions);
      case Expression.Run _ -> true;
      case Expression.PoseLiteral pose -> anyCalls(pose.elements(), functions);
      case Expression.ListLiteral list -> anyCalls(list.elements(), functions);
      case Expression.Unary unary -> calls(unary.operand(), functions);
      case Expression.Binary binary ->
          calls(binary.left(), functions) || calls(binary.right(), functions);
      case Expression.Member member -> calls(member.receiver(), functions);
      case Expression.Index index ->
          calls(index.receiver(), functions) || anyCalls(index.indices(), functions);
      case Expression.IntLiteral _,
          Expression.FloatLiteral _,
          Expression.StringLiteral _,
          Expression.BoolLiteral _,
          Expression.NoneLiteral _,
          Expression.Name _ ->
          false;
    };
  }

  private static boolean argumentsCall(List<Argument> arguments, Set<String> functions) {
    return arguments.stream().anyMatch(each -> calls(each.value(), functions));
  }

  private static boolean anyCalls(List<Expression> values, Set<String> functions) {
    return values.stream().anyMatch(each -> calls(each, functions));
  }

  /** The last function or secondary program; a thread never starts by itself. */
  private static Optional<Definition> entry(List<Definition> definitions) {
    Optional<Definition> lastSecondary = Optional.empty();
    for (Definition definition : definitions.reversed()) {
      if (definition.kind() == DefinitionKind.FUNCTION) {
        boolean secondaryIsLast =
            lastSecondary.isPresent() && isSame(lastSecondary.get(), definitions.getLast());
        return secondaryIsLast ? lastSecondary : Optional.of(definition);
      }
      if (definition.kind() == DefinitionKind.SECONDARY && lastSecondary.isEmpty()) {
        lastSecondary = Optional.of(definition);
      }
    }
    return lastSecondary;
  }

  private static boolean callsLastFunction(
      List<Statement> all, List<Statement> others, Definition entry) {
    if (others.size() != 1 || entry.kind() != DefinitionKind.FUNCTION) {
      return false;
    }
    Statement only = others.getFirst();
    return only instanceof Evaluate evaluate
        && evaluate.expression() instanceof Call call
        && call.function().equals(entry.name())
        && call.arguments().isEmpty()
        && all.stream().noneMatch(s -> s instanceof Definition && follows(s, only));
  }

  private static boolean follows(Statement later, Statement earlier) {
    return later.range().start() > earlier.range().start();
  }

  private static boolean isSame(Definition one, Definition other) {
    return one.range().equals(other.range());
  }

  private static String baseName(String path) {
    String file = path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
    int dot = file.lastIndexOf('.');
    return dot > 0 ? file.substring(0, dot) : file;
  }
}
