package org.pendant.testing.source;

import static org.pendant.testing.source.SourceTexts.text;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.StringLiteral;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.Evaluate;
import org.pendant.models.json.JsonException;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.TestPlace;
import org.pendant.testing.builtin.ExpectationBuiltins;
import org.pendant.testing.builtin.MockBuiltins;
import org.pendant.testing.builtin.TestBuiltins;

/**
 * Reader of test files: parses one, finds its tests, and makes one program of it, of the scripts
 * that it imports, and of lines that choose the test by its number.
 */
public final class TestFileReader {
  /** The function that runs before each test. */
  static final String BEFORE = "before_each";

  /** The function that runs after each test that has come to its end. */
  static final String AFTER = "after_each";

  private final TestSources files;
  private final Builtins<ControlBox> builtins;
  private final boolean covered;

  /**
   * A reader.
   *
   * @param builtins those of {@link TestBuiltins}
   * @param covered whether tests mark what they reach of the scripts that they import
   */
  public TestFileReader(TestSources files, Builtins<ControlBox> builtins, boolean covered) {
    this.files = files;
    this.builtins = builtins;
    this.covered = covered;
  }

  /** A file of which no test can run, and why. */
  public static final class Broken extends Exception {
    private static final long serialVersionUID = 1L;
    private final transient BrokenTestFile file;

    Broken(BrokenTestFile file) {
      super(String.join("\n", file.problems()), null, false, false);
      this.file = file;
    }

    /** What is wrong. */
    public BrokenTestFile file() {
      return file;
    }
  }

  /**
   * Reads a test file.
   *
   * @throws Broken if none of its tests can run
   */
  public TestFile read(String name) throws Broken {
    Source source;
    try {
      source = Source.of(name, files.read(name));
    } catch (IOException e) {
      throw new Broken(new BrokenTestFile(name, List.of(name + ": error: " + e.getMessage())));
    }
    return new Reading(source).file();
  }

  /** One file while it is read. */
  private final class Reading {
    private final Source source;
    private final Composition composition = new Composition();
    private final List<String> problems = new ArrayList<>();
    private final Set<String> warnings = new LinkedHashSet<>();
    private AnsweringFunctions answering = new AnsweringFunctions(List.of());
    private final Map<String, List<String>> starts = new HashMap<>();

    Reading(Source source) {
      this.source = source;
    }

    private TestFile file() throws Broken {
      composition.add(source);
      ParseResult parsed = ScriptParser.parseProgram(source);
      report(parsed.diagnostics());
      List<Statement> own = parsed.script().statements();
      List<SourceRange> imported = imports(own);
      answering = new AnsweringFunctions(own);
      Set<String> mocked = mocked(own);
      List<TestCase> tests = tests(own);
      stopIfBroken();
      Source composed = composition.source();
      Set<String> functions = new HashSet<>(mocked);
      Map<String, List<String>> calls = new HashMap<>();
      List<Statement> written = new ArrayList<>();
      functions.removeIf(each -> builtins.find(each).isEmpty());
      LoadResult loaded =
          ProgramLoader.load(
              composed,
              script -> {
                written.addAll(written(script, imported));
                Script whole = arranged(script, imported);
                Definitions.each(whole.statements(), each -> functions.add(each.name()));
                TestReach reach = new TestReach(written, builtins);
                starts.keySet().forEach(test -> calls.put(test, reach.all(test)));
                return Definitions.mockable(whole, mocked);
              },
              TestBuiltins.mockable(builtins, mocked),
              covered);
      report(loaded.diagnostics());
      stopIfBroken();
      return new TestFile(
          source.name(),
          loaded.program().orElseThrow(),
          composition,
          tests,
          mocked,
          functions,
          starts,
          calls,
          new SentTests(composed, written),
          List.copyOf(warnings));
    }

    private void stopIfBroken() throws Broken {
      if (!problems.isEmpty()) {
        throw new Broken(new BrokenTestFile(source.name(), problems));
      }
    }

    private void report(List<Diagnostic> diagnostics) {
      for (Diagnostic each : diagnostics) {
        TestPlace place = composition.place(each.range().start(), "");
        if (each.isError()) {
          problems.add(place.text() + ": error: " + ByteText.decoded(each.message()));
        } else if (each.range().start() < source.text().length()) {
          // those of scripts that are imported are told where these are checked
          warnings.add(place.text() + ": warning: " + ByteText.decoded(each.message()));
        }
      }
    }

    private void report(SourceRange range, String message) {
      report(List.of(Diagnostic.error("test-file", range, message, "")));
    }

    /** Adds the files that are imported, and answers where they stand. */
    private List<SourceRange> imports(List<Statement> own) {
      List<SourceRange> ranges = new ArrayList<>();
      for (Statement each : own) {
        Optional<Call> call = importing(each);
        if (call.isEmpty()) {
          continue;
        }
        Optional<String> file = literal(call.get());
        if (file.isEmpty()) {
          report(each.range(), text("importName"));
          continue;
        }
        String beside = TestSources.beside(source.name(), ByteText.decoded(file.get()));
        try {
          ranges.add(composition.add(Source.of(beside, files.read(beside))));
        } catch (IOException e) {
          report(call.get().range(), "import_script: " + beside + ": " + e.getMessage());
        }
      }
      return ranges;
    }

    private Set<String> mocked(List<Statement> own) {
      Set<String> names = new TreeSet<>(answering.mocked());
      SyntaxWalk.all(
          own,
          each -> {
            if (each instanceof Call call
                && AnsweringFunction.says(call)
                && AnsweringFunction.of(call).isEmpty()) {
              report(call.range(), text("twoNames", call.function()));
            } else if (each instanceof Call call
                && (call.function().equals(MockBuiltins.MOCK)
                    || call.function().equals("mock_list"))) {
              Optional<String> name = literal(call);
              name.ifPresent(names::add);
              if (name.isEmpty()) {
                report(call.range(), text("oneName", call.function()));
              }
            }
          });
      return names;
    }

    private Optional<TestScene> scene(TestMarks.Case mark) {
      String beside = TestSources.beside(source.name(), ByteText.decoded(mark.arguments()));
      try {
        return Optional.of(TestScene.read(files, beside));
      } catch (IOException e) {
        report(mark.range(), "@scene: " + beside + ": " + e.getMessage());
      } catch (JsonException e) {
        report(mark.range(), "@scene: " + e.getMessage());
      }
      return Optional.empty();
    }

    /** Finds the tests, and adds the lines that choose one of them. */
    private List<TestCase> tests(List<Statement> own) {
      TestReach reach = new TestReach(own, builtins);
      List<Definition> found = new ArrayList<>();
      boolean before = false;
      boolean after = false;
      Set<String> names = new HashSet<>();
      for (Statement each : own) {
        if (each instanceof Definition definition) {
          before |= definition.name().equals(BEFORE);
          after |= definition.name().equals(AFTER);
          if (definition.name().startsWith("test_")
              && definition.kind() == Statement.DefinitionKind.FUNCTION
              && names.add(definition.name())) {
            found.add(definition);
          }
        }
      }
      TestNumbering numbering = new TestNumbering(source, composition, before, after);
      for (Definition each : found) {
        List<Diagnostic> wrong = new ArrayList<>();
        TestMarks marks = TestMarks.above(source, source.line(each.range().start()), wrong);
        report(wrong);
        boolean watches = reach.starts(each.name());
        starts.put(each.name(), reach.started(each.name()));
        if (watches) {
          reach
              .move(each.name())
              .ifPresent(
                  move -> report(move.range(), text("watchesOnly", move.function(), each.name())));
        }
        numbering
            .add(each, marks, marks.scene().flatMap(this::scene), watches)
            .ifPresent(problem -> report(each.nameRange(), problem));
      }
      numbering.end();
      if (found.isEmpty() && problems.isEmpty()) {
        problems.add(source.name() + ": error: " + text("noTest"));
      }
      return numbering.tests();
    }

    /** What people have written: imported values and functions, and the own text. */
    private List<Statement> written(Script script, List<SourceRange> imported) {
      List<Statement> statements = new ArrayList<>();
      List<Statement> functions = new ArrayList<>();
      imported.forEach(
          each -> new ImportedScript(within(script, each), builtins).into(statements, functions));
      statements.addAll(functions);
      script.statements().stream()
          .filter(each -> each.range().start() < source.text().length())
          .filter(each -> importing(each).isEmpty())
          .forEach(statements::add);
      return statements;
    }

    /** The whole text as one program: imported values, own statements, and the choice of a test. */
    private Script arranged(Script script, List<SourceRange> imported) {
      List<Statement> constants = new ArrayList<>();
      List<Statement> functions = new ArrayList<>();
      List<Statement> rest = new ArrayList<>();
      int end = source.text().length();
      for (SourceRange each : imported) {
        new ImportedScript(within(script, each), builtins).into(constants, functions);
        end = each.end();
      }
      for (Statement each : script.statements()) {
        boolean own = each.range().start() < source.text().length();
        boolean choice = each.range().start() >= end && !own;
        if (own ? importing(each).isEmpty() : choice) {
          rest.add(each);
        }
      }
      List<Statement> all = new ArrayList<>(constants);
      answering.check(joined(functions, rest), builtins, this::report);
      List<Statement> first = new ArrayList<>();
      answering.into(functions, first);
      all.addAll(functions);
      all.addAll(first);
      all.addAll(rest);
      return new Script(
          script.source(), new Expectations(script.source()).asLoops(all), script.range());
    }

    private static List<Statement> joined(List<Statement> one, List<Statement> other) {
      List<Statement> both = new ArrayList<>(one);
      both.addAll(other);
      return both;
    }

    private static Script within(Script script, SourceRange range) {
      List<Statement> inside =
          script.statements().stream()
              .filter(
                  each ->
                      each.range().start() >= range.start() && each.range().start() < range.end())
              .toList();
      return new Script(script.source(), inside, range);
    }
  }

  /** The call of {@code import_script} that a statement is. */
  private static Optional<Call> importing(Statement statement) {
    return statement instanceof Evaluate evaluate
            && evaluate.expression() instanceof Call call
            && call.function().equals(ExpectationBuiltins.IMPORT)
        ? Optional.of(call)
        : Optional.empty();
  }

  /** The text of the first argument, where that is one. */
  private static Optional<String> literal(Call call) {
    if (!call.arguments().isEmpty()) {
      Expression first = call.arguments().getFirst().value();
      if (first instanceof StringLiteral text) {
        return Optional.of(text.value());
      }
    }
    return Optional.empty();
  }
}
