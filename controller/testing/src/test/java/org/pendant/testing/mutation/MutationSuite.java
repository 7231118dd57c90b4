package org.pendant.testing.mutation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.coverage.CoverageCollector;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.run.TestSettings;
import org.pendant.testing.source.TestSources;

/** A suite in memory whose programs are mutated. */
public final class MutationSuite {
  private final Map<String, String> files = new TreeMap<>();
  private MutationSettings settings = new MutationSettings(List.of(), 0, 1, 1);
  private final List<String> progress = new ArrayList<>();
  private SuiteResult result;

  /** A suite with one program, {@code pick.script}. */
  public static MutationSuite of(String... program) {
    return new MutationSuite().with("pick.script", program);
  }

  /** With one more file. */
  public MutationSuite with(String name, String... lines) {
    files.put(name, String.join("\n", lines) + "\n");
    return this;
  }

  /** With tests of the program, which they import. */
  public MutationSuite tests(String... lines) {
    return with("pick_test.script", "import_script(\"pick.script\")\n" + String.join("\n", lines));
  }

  /** With other settings. */
  MutationSuite with(MutationSettings other) {
    settings = other;
    return this;
  }

  /** What the tests have come to. */
  public SuiteResult result() {
    return result;
  }

  /** What was told while mutants were tried. */
  List<String> progress() {
    return progress;
  }

  /** What comes of its mutants. */
  public MutationReport run() {
    TestSources sources =
        name -> {
          String text = files.get(name);
          if (text == null) {
            throw new IOException("no such file");
          }
          return text.getBytes(StandardCharsets.UTF_8);
        };
    return run(sources, files.keySet().stream().filter(n -> n.endsWith("_test.script")).toList());
  }

  /** As {@link #run()}, of files that are somewhere else. */
  MutationReport run(TestSources sources, List<String> names) {
    CoverageCollector coverage = new CoverageCollector();
    TestSettings tests =
        new TestSettings(
            ControllerOptions.headless().withArm(ArmChoice.IDEAL),
            1,
            settings.jobs(),
            60,
            Duration.ofSeconds(60),
            false);
    TestRunner runner =
        new TestRunner(sources, tests, _ -> true, _ -> {}, Goldens.NONE, Optional.of(coverage));
    result = runner.run(runner.plan(names));
    if (result.red()) {
      throw new AssertionError(result.broken() + " " + result.firstRed());
    }
    return new MutationRun(
            sources, runner, result, settings, (done, all) -> progress.add(done + " of " + all))
        .run(coverage.report());
  }
}
