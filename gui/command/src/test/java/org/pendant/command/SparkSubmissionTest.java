package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.sweep.engine.EngineException;

/** How a sweep is handed to {@code spark-submit}, and what is said where that cannot be. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the program has another name there")
final class SparkSubmissionTest {
  private static final SparkOptions NOTHING =
      new SparkOptions(Optional.empty(), List.of(), Optional.empty());

  @TempDir private Path folder;
  private Path program;
  private Path jar;

  @BeforeEach
  void writeFiles() throws IOException {
    Files.createDirectories(folder.resolve("spark/bin"));
    program = Files.writeString(folder.resolve("spark/bin/spark-submit"), "");
    assertTrue(program.toFile().setExecutable(true));
    jar = Files.writeString(folder.resolve("pendant-spark.jar"), "");
  }

  private static SparkOptions options(String... words) throws UsageException {
    return SparkOptions.of(Arguments.parse(SweepOptions.ALL, List.of(words)));
  }

  private String complaint(SparkOptions options, Map<String, String> environment) {
    return assertThrows(EngineException.class, () -> new SparkSubmission(options, environment))
        .getMessage();
  }

  @Test
  void commandLineIsThatOfSparkSubmitWithTheSettingsOfPeople() throws Exception {
    SparkOptions options =
        options(
            "--master",
            "spark://head:7077",
            "--spark-conf",
            "spark.executor.memory=1g",
            "--spark-jar",
            jar.toString());
    Map<String, String> environment = Map.of("SPARK_HOME", folder.resolve("spark").toString());
    assertEquals(
        List.of(
            program.toString(),
            "--name",
            "pendant sweep",
            "--master",
            "spark://head:7077",
            "--conf",
            "spark.executor.memory=1g",
            "--class",
            "org.pendant.command.Pendant",
            jar.toString(),
            "sweep",
            "plan.toml"),
        new SparkSubmission(options, environment).command(List.of("sweep", "plan.toml")));
  }

  @Test
  void sparkSubmitIsFoundOnThePathAndTheJarWhereTheLauncherSays() throws Exception {
    Map<String, String> environment =
        Map.of("PATH", "/nowhere:" + program.getParent(), "PENDANT_SPARK_JAR", jar.toString());
    List<String> line = new SparkSubmission(NOTHING, environment).command(List.of());
    assertEquals(program.toString(), line.getFirst());
    assertEquals(jar.toString(), line.getLast());
  }

  @Test
  void whatIsMissingIsToldWithWhatHelps() {
    assertTrue(
        complaint(NOTHING, Map.of("PATH", "/nowhere"))
            .startsWith(
                "--engine spark needs Apache Spark 4.2 (spark.apache.org): set SPARK_HOME"));
    assertEquals(
        "SPARK_HOME is /nowhere, which has no bin/spark-submit; must be the folder of Apache Spark"
            + " 4.2",
        complaint(NOTHING, Map.of("SPARK_HOME", "/nowhere")));
    String home = folder.resolve("spark").toString();
    String unbuilt = complaint(NOTHING, Map.of("SPARK_HOME", home));
    assertTrue(
        unbuilt.contains("mvn -Pspark -pl gui/spark -am -Dmaven.test.skip=true process-classes"),
        unbuilt);
    UsageException misspelt =
        assertThrows(
            UsageException.class,
            () ->
                new SparkSubmission(
                    options("--spark-jar", "nothing.jar"), Map.of("SPARK_HOME", home)));
    assertEquals("--spark-jar nothing.jar: no such file", misspelt.getMessage());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "local",
        "local[*]",
        "local[4]",
        "local[4,2]",
        "local-cluster[2,1,1024]",
        "spark://a:7077,b:7077",
        "yarn",
        "k8s://https://host:6443"
      })
  void mastersOfSparkAreTaken(String master) throws UsageException {
    assertEquals(Optional.of(master), options("--master", master).master());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --master     | mesos://a         | --master is mesos://a, must be one of local[*]
          --master     | local[x]          | --master is local[x], must be one of local[*]
          --master     | spark://          | --master is spark://, must be one of local[*]
          --spark-conf | executor.memory=1 | --spark-conf is executor.memory=1, must be spark.NAME=VALUE
          --spark-conf | spark.ui          | --spark-conf is spark.ui, must be spark.NAME=VALUE
          --spark-conf | spark.master=yarn | --spark-conf is spark.master=yarn; --master says
          --spark-conf | spark.submit.deployMode=cluster | --spark-conf is spark.submit.deployMode=cluster; the results
          """)
  void whatSparkWouldNotUnderstandIsRefused(String option, String value, String told) {
    UsageException refused = assertThrows(UsageException.class, () -> options(option, value));
    assertTrue(refused.getMessage().startsWith(told), refused.getMessage());
  }
}
