package org.pendant.spark;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.SweepListener;
import org.pendant.sweep.engine.Engine;

/** {@code pendant sweep --engine spark}, by the jar that people submit to a Spark of their own. */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "spark-submit is a shell script here")
class SubmittedSweepTest {
  private static final Path JAR = Path.of("target", "pendant-spark.jar").toAbsolutePath();

  @TempDir private Path folder;
  private Path plan;

  @BeforeEach
  void writeFiles() throws IOException {
    Files.writeString(
        folder.resolve("reach.script"),
        """
        def reach():
          x = 0.2
          movej([x, -1.5, x, -1.5, x, 0], a=1, v=1)
          movej([0, -1.5, x, -1.5, 0, 0], a=1, v=1)
          movel(pose_trans(get_actual_tcp_pose(), p[0, 0, -0.05, 0, 0, 0]), a=1, v=0.5)
        end
        """);
    plan =
        Files.writeString(
            folder.resolve("plan.toml"),
            """
            program = "reach.script"
            [[parameter]]
            set = "variable x"
            from = 0.2
            to = 0.6
            steps = 60
            """);
    // what bin/spark-submit of a distribution comes to
    Path bin = Files.createDirectories(folder.resolve("spark/bin"));
    Path submit =
        Files.writeString(
            bin.resolve("spark-submit"),
            """
            #!/bin/sh
            export SPARK_SCALA_VERSION=2.13
            exec "$JAVA_HOME/bin/java" -XX:TieredStopAtLevel=1 -cp "$SPARK_HOME/jars/*" \
            org.apache.spark.deploy.SparkSubmit "$@"
            """);
    assertTrue(submit.toFile().setExecutable(true));
    Files.createSymbolicLink(
        folder.resolve("spark/jars"), Path.of(System.getenv("SPARK_HOME"), "jars"));
  }

  /** Starts {@code pendant sweep} as people have it: without Spark and its engine. */
  private Process sweep(String... words) throws IOException {
    Path engine = Path.of("target", "classes").toAbsolutePath();
    String classPath =
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator, -1))
            .filter(each -> !Path.of(each).toAbsolutePath().equals(engine))
            .collect(Collectors.joining(File.pathSeparator));
    List<String> line =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                classPath,
                "org.pendant.command.Pendant",
                "sweep"));
    line.addAll(List.of(words));
    ProcessBuilder builder =
        new ProcessBuilder(line)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("told.txt").toFile());
    builder.environment().put("SPARK_HOME", folder.resolve("spark").toString());
    return builder.start();
  }

  private Path results() {
    return folder.resolve("plan.sweep");
  }

  private static byte[] table(Path results) throws IOException {
    return Files.readAllBytes(results.resolve("results.csv"));
  }

  private long rows() throws IOException {
    return Files.exists(results().resolve("results.csv"))
        ? new String(table(results()), StandardCharsets.UTF_8).lines().count() - 1
        : 0;
  }

  private String told() {
    try {
      return Files.readString(folder.resolve("told.txt"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void sweepThatIsEndedEarlyOnSparkGoesOnAnywhereToTheSameTable() throws Exception {
    Process process =
        sweep(
            "--engine",
            "spark",
            "--master",
            "local-cluster[2,1,1024]",
            "--spark-conf",
            "spark.executor.memory=512m",
            "--spark-jar",
            JAR.toString(),
            plan.toString());
    while (rows() < 1) {
      assertFalse(process.waitFor(50, TimeUnit.MILLISECONDS), this::told);
    }

    process.destroy();

    assertTrue(process.waitFor(1, TimeUnit.MINUTES));
    assertTrue(told().contains("60 runs, Spark "), told());
    assertTrue(rows() >= 1);
    Path undisturbed = folder.resolve("undisturbed");
    Sweep sweep = Sweep.read(plan);
    try (Engine engine = sweep.local(2)) {
      sweep.run(results(), Sweep.Start.RESUME, engine, SweepListener.NONE, () -> false);
      sweep.run(undisturbed, Sweep.Start.NEW, engine, SweepListener.NONE, () -> false);
    }
    assertArrayEquals(table(undisturbed), table(results()));
  }
}
