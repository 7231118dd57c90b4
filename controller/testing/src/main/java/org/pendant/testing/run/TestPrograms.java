package org.pendant.testing.run;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.bench.TestedPrograms;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.testing.coverage.LineOrigin;
import org.pendant.testing.coverage.TreeOrigin;
import org.pendant.testing.source.MockedFunctions;
import org.pendant.testing.source.TestFile;
import org.pendant.testing.source.TestSources;

/** Programs under test of one test file, each read and compiled once. Any thread may ask. */
final class TestPrograms implements TestedPrograms {
  /** Code of the failure of a test that starts something that is no program. */
  static final String NO_PROGRAM = "no-program";

  /**
   * One program.
   *
   * @param tree where it is a tree
   */
  record Loaded(
      Optional<Program> program, String refusal, Set<String> functions, Optional<TreeFile> tree) {}

  private final TestFile file;
  private final TestSources files;
  private final Builtins<ControlBox> ofPrograms;
  private final Builtins<ControlBox> ofTests;
  private final boolean covered;
  private final Map<String, Loaded> loaded = new ConcurrentHashMap<>();

  /**
   * The programs of a file.
   *
   * @param ofPrograms what programs may call
   * @param ofTests what tests may call
   * @param covered whether runs of them mark what they reach
   */
  TestPrograms(
      TestFile file,
      TestSources files,
      Builtins<ControlBox> ofPrograms,
      Builtins<ControlBox> ofTests,
      boolean covered) {
    this.file = file;
    this.files = files;
    this.ofPrograms = ofPrograms;
    this.ofTests = ofTests;
    this.covered = covered;
  }

  @Override
  public Program load(String name) throws ScriptError {
    String beside = TestSources.beside(file.name(), ByteText.decoded(name));
    Loaded one = loaded.computeIfAbsent(beside, this::read);
    return one.program().orElseThrow(() -> new ScriptError(NO_PROGRAM, "start: " + one.refusal()));
  }

  /** Where a program that was loaded here may read files. */
  ProgramsFolder folder(Program program) {
    return loaded.entrySet().stream()
        .filter(each -> each.getValue().program().filter(program::equals).isPresent())
        .findFirst()
        .map(each -> files.folder(each.getKey()))
        .orElse(ProgramsFolder.NONE);
  }

  /** Where the test itself may read files. */
  ProgramsFolder ownFolder() {
    return files.folder(file.name());
  }

  /** The functions of all programs that were started so far. */
  Set<String> functions() {
    Set<String> all = new HashSet<>();
    loaded.values().forEach(each -> all.addAll(each.functions()));
    return all;
  }

  /** Where the lines of a program that was loaded here come from. */
  LineOrigin origin(Source source) {
    return loaded.entrySet().stream()
        .filter(
            each ->
                each.getValue().program().filter(one -> one.source().equals(source)).isPresent())
        .findFirst()
        .flatMap(each -> each.getValue().tree())
        .<LineOrigin>map(tree -> TreeOrigin.of(tree, tree.script()))
        .orElse(LineOrigin.file(source.name()));
  }

  /** Which node of a tree a line of its script belongs to, as the beginning of a message. */
  Optional<String> nodeAt(String source, int line) {
    return loaded.values().stream()
        .flatMap(each -> each.tree().stream())
        .filter(each -> each.scriptName().equals(source))
        .flatMap(each -> each.nodeAt(line).stream())
        .findFirst();
  }

  private Loaded read(String name) {
    byte[] bytes;
    try {
      bytes = files.read(name);
    } catch (IOException e) {
      return refused(name + ": " + e.getMessage());
    }
    if (!TreeFile.hasEnding(name)) {
      return compiled(Source.of(name, bytes), Optional.empty());
    }
    try {
      TreeFile tree = TreeFile.read(name, bytes);
      List<String> problems = tree.problems();
      return problems.isEmpty()
          ? compiled(Source.of(tree.scriptName(), tree.script().text()), Optional.of(tree))
          : refused(problems.getFirst());
    } catch (BrokenTree e) {
      return refused(e.reports().getFirst());
    }
  }

  private Loaded compiled(Source source, Optional<TreeFile> tree) {
    LoadResult plain =
        covered
            ? ProgramLoader.loadCovered(source, ofPrograms)
            : ProgramLoader.load(source, ofPrograms);
    if (plain.program().isEmpty()) {
      Diagnostic first =
          plain.diagnostics().stream().filter(Diagnostic::isError).findFirst().orElseThrow();
      return refused(
          source.name()
              + ":"
              + source.line(first.range().start())
              + ":"
              + source.column(first.range().start())
              + ": "
              + first.message());
    }
    MockedFunctions mocked = new MockedFunctions(file.mocked());
    LoadResult result =
        file.mocked().isEmpty()
            ? plain
            : ProgramLoader.load(source, mocked::into, mocked.builtins(ofTests), covered);
    return new Loaded(result.program(), "", mocked.found(), tree);
  }

  private static Loaded refused(String why) {
    return new Loaded(Optional.empty(), why, Set.of(), Optional.empty());
  }
}
