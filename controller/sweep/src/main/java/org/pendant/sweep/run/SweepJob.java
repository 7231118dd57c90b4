package org.pendant.sweep.run;

import static org.pendant.sweep.run.SweepRunTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.DiagnosticFormat;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.plan.SweepVariant;

/**
 * Sweep job: a plan with all that it names. Immutable: any number of threads have it run variants,
 * and a process on another machine that reads the same files gets the same results.
 */
public final class SweepJob {
  private final JobInputs inputs;
  private final ScriptPlaces places;
  private final Builtins<ControlBox> builtins;
  private final LoadResult loaded;
  private final String planText;
  private final String identity;
  private final List<String> files;

  private SweepJob(
      JobInputs inputs, Builtins<ControlBox> builtins, String planText, Map<String, byte[]> files)
      throws PlanException {
    this.inputs = inputs;
    this.builtins = builtins;
    this.planText = planText;
    identity = identity(planText, files);
    this.files = List.copyOf(files.keySet());
    ParseResult parsed = ScriptParser.parseProgram(inputs.program());
    places = new ScriptPlaces(parsed.script(), builtins);
    loaded = ProgramLoader.load(inputs.program(), builtins);
    List<String> errors =
        loaded.diagnostics().stream()
            .filter(Diagnostic::isError)
            .map(each -> DiagnosticFormat.format(inputs.program(), each))
            .toList();
    if (!errors.isEmpty()) {
      throw new PlanException(errors);
    }
    if (loaded.program().orElseThrow().secondary()) {
      throw new PlanException(
          text("secondaryProgram", inputs.plan().name(), inputs.plan().program()));
    }
    List<String> mistakes = PlanCheck.mistakes(inputs, places);
    if (!mistakes.isEmpty()) {
      throw new PlanException(mistakes);
    }
  }

  /**
   * Reads a plan and all that it names.
   *
   * @throws PlanException with all that is wrong
   */
  public static SweepJob read(Path file) throws PlanException {
    String name = file.toString();
    byte[] bytes;
    try (InputStream in = Files.newInputStream(file)) {
      bytes = in.readNBytes(PlanReader.MAX_BYTES + 1);
    } catch (IOException e) {
      throw new PlanException(name + ": error: " + FileTrouble.reason(e));
    }
    if (bytes.length > PlanReader.MAX_BYTES) {
      throw new PlanException(text("planTooLong", name, PlanReader.MAX_BYTES));
    }
    String text = new String(bytes, StandardCharsets.UTF_8);
    return of(PlanReader.read(name, text), text, file.toAbsolutePath().getParent());
  }

  /**
   * A job of a plan that was read.
   *
   * @param text of the plan
   * @param folder from which the names in it are seen
   * @throws PlanException with all that is wrong
   */
  public static SweepJob of(SweepPlan plan, String text, Path folder) throws PlanException {
    PlanFiles files = new PlanFiles(plan, folder);
    JobInputs inputs = files.inputs();
    return new SweepJob(inputs, StandardBuiltins.create(), text, files.read());
  }

  private static String identity(String plan, Map<String, byte[]> files) {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      digest.update(plan.getBytes(StandardCharsets.UTF_8));
      files.forEach(
          (name, bytes) -> {
            digest.update((name + '\0' + bytes.length + '\0').getBytes(StandardCharsets.UTF_8));
            digest.update(bytes);
          });
      return HexFormat.of().formatHex(digest.digest());
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    }
  }

  /** What runs. */
  public SweepPlan plan() {
    return inputs.plan();
  }

  /** The text of the plan. */
  public String planText() {
    return planText;
  }

  /** The program before any variant changes it. */
  public Source program() {
    return inputs.program();
  }

  /** Where the lines of the program are in the tree that it is made of; empty for scripts. */
  public Optional<ProgramNodes> nodes() {
    return inputs.nodes();
  }

  /** A number in hexadecimal digits that changes when the plan or a file that it names does. */
  public String identity() {
    return identity;
  }

  /** The names of the files that it was read from beside the plan, as seen from its folder. */
  public List<String> files() {
    return files;
  }

  /** Runs a variant from its start to its end; whatever goes wrong is in the result. */
  public SweepResult run(SweepVariant variant) {
    return run(variant, RunWatcher.NONE);
  }

  /** The result of a run that nobody could bring to its end, for a reason outside of it. */
  public static SweepResult lost(SweepVariant variant, String reason) {
    return SweepRun.failed(variant, RunOutcome.INTERNAL_ERROR, reason);
  }

  /** As {@link #run(SweepVariant)}, with somebody who sees every frame. */
  public SweepResult run(SweepVariant variant, RunWatcher watcher) {
    try {
      return new SweepRun(this, variant, watcher).result();
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      return SweepRun.failed(variant, RunOutcome.INTERNAL_ERROR, e.toString());
    }
  }

  VariantSetup setup(SweepVariant variant) {
    return SetupMaker.of(inputs, places, variant);
  }

  /** The program of a setup; the same object for all that change none of its text. */
  LoadResult load(Source program) {
    return program == inputs.program() ? loaded : ProgramLoader.load(program, builtins);
  }

  Builtins<ControlBox> builtins() {
    return builtins;
  }
}
