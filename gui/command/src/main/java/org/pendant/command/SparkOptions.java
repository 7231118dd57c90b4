package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Spark options: what {@code pendant sweep} is told of the cluster.
 *
 * @param master who hands out the workers, as Spark writes it; empty for what Spark's own
 *     configuration says
 * @param settings of Spark, {@code NAME=VALUE}
 * @param jar the file of the jar that workers get; empty for the one that is built beside the
 *     command
 */
record SparkOptions(Optional<String> master, List<String> settings, Optional<String> jar) {
  private static final Option MASTER =
      Option.text("--master", "MASTER")
          .documented(
              "'local[*]'",
              "whose workers run the variants: `local[*]` or `local-cluster[2,1,1024]` on this"
                  + " machine, `spark://HOST:PORT`, `yarn`, `k8s://URL`; default what Spark's"
                  + " configuration says, or else `local[*]`");
  private static final Option SETTING =
      Option.text("--spark-conf", "NAME=VALUE")
          .repeated()
          .documented(
              "spark.executor.memory=1g",
              "a setting of Spark, as for its `--conf`; may be repeated");
  private static final Option JAR =
      Option.input("--spark-jar", "FILE")
          .documented(
              "pendant-spark.jar",
              "the jar that workers get; default the one that was built beside this command");

  /** For the usage text. */
  static final List<Option> ALL = List.of(MASTER, SETTING, JAR);

  private static final Pattern LEGAL_MASTER =
      Pattern.compile(
          "local|local\\[(\\*|\\d+)(,\\s*\\d+)?]|local-cluster\\[\\s*\\d+\\s*(,\\s*\\d+\\s*){2}]"
              + "|spark://.+|yarn|k8s://.+");
  private static final Pattern LEGAL_SETTING = Pattern.compile("spark\\.[^=\\s]+=.*");

  SparkOptions {
    settings = List.copyOf(settings);
  }

  static SparkOptions of(Arguments arguments) throws UsageException {
    Optional<String> master = arguments.value(MASTER);
    if (master.isPresent() && !LEGAL_MASTER.matcher(master.get()).matches()) {
      throw new UsageException(text("masterMustBe", master.get()));
    }
    for (String each : arguments.values(SETTING)) {
      if (!LEGAL_SETTING.matcher(each).matches()) {
        throw new UsageException(text("sparkConfMustBe", each));
      }
      if (each.startsWith("spark.master=")) {
        throw new UsageException(text("sparkConfMaster", each));
      }
      if (each.equals("spark.submit.deployMode=cluster")) {
        throw new UsageException(text("sparkConfDriver", each));
      }
    }
    return new SparkOptions(master, arguments.values(SETTING), arguments.value(JAR));
  }

  /** The first of them that was given. */
  Optional<String> firstGiven() {
    return master
        .map(_ -> MASTER.name())
        .or(() -> settings.stream().findFirst().map(_ -> SETTING.name()))
        .or(() -> jar.map(_ -> JAR.name()));
  }
}
