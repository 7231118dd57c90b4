package org.pendant.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.apache.spark.SparkConf;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.LocalEngine;
import org.pendant.sweep.engine.VariantSource;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.remote.JobArchive;
import org.pendant.sweep.run.RunOutcome;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.run.SweepResult;

/** A Spark with two workers, each a JVM of its own. */
@Tag("slow")
class SparkEngineTest {
  private static final String PLAN =
      """
      program = "reach.script"
      variables = ["x"]
      time_limit = 20

      [[parameter]]
      set = "variable x"
      values = [%s]
      """;
  private static final String PROGRAM =
      """
      def reach():
        x = 0.2
        set_digital_out(0, True)
        if x > 0.9:
          while True:
            sync()
          end
        end
        y = 1 / (x - 0.15)
        movej([x, -1.5, x, -1.5, x, 0], a=3, v=2)
        movel(pose_trans(get_actual_tcp_pose(), p[0, 0, -0.05 * x, 0, 0, 0]), a=1, v=0.5)
      end
      """;

  /** More than {@code ResultCodec} reads: such a variant fails in every worker. */
  private static final int UNREADABLE_CHARACTERS = (1 << 24) + 1;

  private static final BooleanSupplier NEVER = () -> false;

  @TempDir private static Path folder;
  private static SweepJob job;
  private static Engine engine;
  private static List<SweepResult> expected;

  @BeforeAll
  static void startSpark() throws Exception {
    Files.writeString(folder.resolve("reach.script"), PROGRAM);
    List<String> values =
        Stream.concat(
                LongStream.rangeClosed(0, 40).mapToObj(each -> "0." + (10 + each)), Stream.of("1"))
            .toList();
    Path plan =
        Files.writeString(folder.resolve("plan.toml"), PLAN.formatted(String.join(", ", values)));
    job = SweepJob.read(plan);
    expected = run(new LocalEngine(job, 1), job.plan()::variant, job.plan().size());
    SparkConf conf =
        SparkApplication.configuration()
            .setMaster("local-cluster[2,1,1024]")
            .set("spark.driver.host", "127.0.0.1")
            .set("spark.driver.bindAddress", "127.0.0.1")
            .set("spark.task.maxFailures", "4")
            .set("spark.executor.memory", "512m")
            .set("spark.executor.extraJavaOptions", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC")
            .set("spark.executorEnv.SPARK_SCALA_VERSION", "2.13")
            .set("spark.executor.extraClassPath", System.getProperty("java.class.path"));
    engine =
        SparkApplication.start(conf, new WorkerJob(JobArchive.pack(plan, job), job.identity()));
  }

  @AfterAll
  static void endSpark() {
    engine.close();
  }

  private static List<SweepResult> run(Engine engine, VariantSource variants, long end)
      throws Exception {
    List<SweepResult> results = new ArrayList<>();
    assertEquals(end, engine.run(variants, 0, end, results::add, NEVER));
    return results;
  }

  private static boolean killAWorker() {
    return ProcessHandle.current()
        .children()
        .filter(each -> each.info().command().orElse("").endsWith("java"))
        .findAny()
        .filter(ProcessHandle::destroyForcibly)
        .isPresent();
  }

  @Test
  void workersInOtherProcessesGiveTheSameResultsEvenWhenThreeAreKilled() throws Exception {
    List<SweepResult> results = new ArrayList<>();
    AtomicInteger killed = new AtomicInteger();
    BooleanSupplier killing =
        () -> {
          if (killed.get() < 3 && !results.isEmpty() && killAWorker()) {
            killed.incrementAndGet();
          }
          return false;
        };

    engine.run(job.plan()::variant, 0, job.plan().size(), results::add, killing);

    assertEquals(3, killed.get());
    assertEquals(expected, results);
    assertEquals(RunOutcome.FINISHED, results.getFirst().outcome());
    assertEquals(RunOutcome.FAILED, results.get(5).outcome());
    assertEquals(RunOutcome.NEVER_ENDED, results.getLast().outcome());
  }

  @Test
  void variantThatFailsEveryWorkerCostsOnlyItsOwnResult() throws Exception {
    VariantSource variants =
        number ->
            number == 5
                ? new SweepVariant(
                    5, List.of(new ParameterValue("x".repeat(UNREADABLE_CHARACTERS), 0)))
                : job.plan().variant(number);

    List<SweepResult> results = run(engine, variants, 12);

    SweepResult lost = results.remove(5);
    assertEquals(RunOutcome.INTERNAL_ERROR, lost.outcome());
    assertTrue(lost.reason().startsWith("no worker brings it to its end: "), lost.reason());
    assertTrue(lost.reason().contains("a text of 16777217 bytes"), lost.reason());
    List<SweepResult> others = new ArrayList<>(expected.subList(0, 12));
    others.remove(5);
    assertEquals(others, results);
  }

  @Test
  void sweepThatIsStoppedHasGivenTheFirstResultsAndGoesOnBehindThem() throws Exception {
    List<SweepResult> results = new ArrayList<>();

    long done =
        engine.run(
            job.plan()::variant, 0, job.plan().size(), results::add, () -> !results.isEmpty());

    assertEquals(done, results.size());
    assertTrue(done > 0 && done < expected.size(), "stopped after " + done);
    engine.run(job.plan()::variant, done, job.plan().size(), results::add, NEVER);
    assertEquals(expected, results);
  }
}
