package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.bench.TestedPrograms;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.ArmlessBuiltins;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.layout.ArmEntry;
import org.pendant.controller.layout.NamedFile;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.installation.file.InstallationTrouble;
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
import org.pendant.testing.source.TestCase;
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
   * @param controller what it runs on, where it brings a setup of its own
   */
  record Loaded(
      Optional<Program> program,
      String refusal,
      Set<String> functions,
      Optional<TreeFile> tree,
      Optional<ControllerOptions> controller) {}

  private final TestFile file;
  private final TestSources files;
  private final Builtins<ControlBox> ofPrograms;
  private final Builtins<ControlBox> ofTests;
  private final boolean covered;
  private final ControllerOptions controller;
  private final Map<String, Loaded> loaded = new ConcurrentHashMap<>();

  /**
   * The programs of a file.
   *
   * @param ofPrograms what programs may call
   * @param ofTests what tests may call
   * @param covered whether runs of them mark what they reach
   * @param controller what they run on, unless they bring a setup of their own
   */
  TestPrograms(
      TestFile file,
      TestSources files,
      Builtins<ControlBox> ofPrograms,
      Builtins<ControlBox> ofTests,
      boolean covered,
      ControllerOptions controller) {
    this.file = file;
    this.files = files;
    this.ofPrograms = ofPrograms;
    this.ofTests = ofTests;
    this.covered = covered;
    this.controller = controller;
  }

  @Override
  public Program load(String name) throws ScriptError {
    String beside = TestSources.beside(file.name(), ByteText.decoded(name));
    Loaded one = loaded.computeIfAbsent(beside, this::read);
    return one.program().orElseThrow(() -> new ScriptError(NO_PROGRAM, "start: " + one.refusal()));
  }

  /**
   * What the controller of a test is switched on with: that of the first program that it starts and
   * that brings a setup of its own.
   */
  ControllerOptions controller(TestCase test) {
    ControllerOptions set = setUp(test);
    return test.scene()
        .map(each -> set.withScene(each.scene()).withEquipment(each.equipment()))
        .orElse(set);
  }

  private ControllerOptions setUp(TestCase test) {
    return file.starts().getOrDefault(test.id().function(), List.of()).stream()
        .map(each -> loaded.computeIfAbsent(TestSources.beside(file.name(), each), this::read))
        .flatMap(each -> each.controller().stream())
        .findFirst()
        .orElse(controller);
  }

  /**
   * How the controller of an arm is switched on.
   *
   * @param scene the file that has the arm
   * @param base what it is without
   * @throws IOException if it cannot be set up so; the message says why, for people
   */
  ControllerOptions setUp(ArmEntry arm, String scene, ControllerOptions base) throws IOException {
    ControllerOptions own = arm.robot().map(base::withRobot).orElse(base);
    if (arm.installation().isEmpty()) {
      return own;
    }
    String name = TestSources.beside(scene, arm.installation().get().name());
    try {
      return files.setUp(
          own,
          InstallationFile.read(name, files.read(name), Optional.empty()).installation(),
          arm.robot());
    } catch (InstallationTrouble e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /**
   * The program of an arm that a scene names.
   *
   * @throws IOException if it is none; the message says why, for people
   */
  Program ofArm(String scene, NamedFile program) throws IOException {
    Loaded one = loaded.computeIfAbsent(TestSources.beside(scene, program.name()), this::read);
    return one.program().orElseThrow(() -> new IOException(one.refusal()));
  }

  /**
   * The script of the cell that a scene names.
   *
   * @throws IOException if it is none; the message says why, for people
   */
  Program ofCell(String scene, NamedFile script) throws IOException {
    String name = TestSources.beside(scene, script.name());
    Source source = Source.of(name, files.read(name));
    LoadResult result = ProgramLoader.load(source, ArmlessBuiltins.create());
    return result.program().orElseThrow(() -> new IOException(refusal(source, result)));
  }

  /** Whether a program that was loaded here is what a tree generates. */
  boolean isTree(Program program) {
    return loaded.values().stream()
        .anyMatch(
            each -> each.tree().isPresent() && each.program().filter(program::equals).isPresent());
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
    if (!TreeFile.hasEnding(name) && !name.toLowerCase(Locale.ROOT).endsWith(TreeFile.SCRIPT)) {
      return refused(text("noProgram", name, TreeFile.SCRIPT, String.join(", ", TreeFile.ENDINGS)));
    }
    byte[] bytes;
    try {
      bytes = files.read(name);
    } catch (IOException e) {
      return refused(name + ": " + e.getMessage());
    }
    if (!TreeFile.hasEnding(name)) {
      return compiled(Source.of(name, bytes), Optional.empty(), Optional.empty());
    }
    try {
      TestedTree tested = TestedTree.of(name, bytes, controller.installation(), files);
      TreeFile tree = tested.tree();
      List<String> problems = tree.problems();
      if (!problems.isEmpty()) {
        return refused(problems.getFirst());
      }
      Optional<ControllerOptions> own =
          tested.own().isPresent()
              ? Optional.of(files.setUp(controller, tested.own().get(), tree.robot()))
              : Optional.empty();
      return compiled(Source.of(tree.scriptName(), tree.script().text()), Optional.of(tree), own);
    } catch (IOException e) {
      return refused(name + ": " + e.getMessage());
    } catch (InstallationTrouble e) {
      return refused(e.getMessage());
    } catch (BrokenTree e) {
      return refused(e.reports().getFirst());
    }
  }

  private Loaded compiled(Source source, Optional<TreeFile> tree, Optional<ControllerOptions> own) {
    LoadResult plain =
        covered
            ? ProgramLoader.loadCovered(source, ofPrograms)
            : ProgramLoader.load(source, ofPrograms);
    if (plain.program().isEmpty()) {
      return refused(refusal(source, plain));
    }
    MockedFunctions mocked = new MockedFunctions(file.mocked());
    LoadResult result =
        file.mocked().isEmpty()
            ? plain
            : ProgramLoader.load(source, mocked::into, mocked.builtins(ofTests), covered);
    return new Loaded(result.program(), "", mocked.found(), tree, own);
  }

  private static String refusal(Source source, LoadResult result) {
    Diagnostic first =
        result.diagnostics().stream().filter(Diagnostic::isError).findFirst().orElseThrow();
    return source.name()
        + ":"
        + source.line(first.range().start())
        + ":"
        + source.column(first.range().start())
        + ": "
        + first.message();
  }

  private static Loaded refused(String why) {
    return new Loaded(Optional.empty(), why, Set.of(), Optional.empty(), Optional.empty());
  }
}
