package org.pendant.spark;

import static org.pendant.spark.SparkTexts.text;

import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;

/** The application that a sweep is to Spark. */
final class SparkApplication {
  private SparkApplication() {}

  /** Connects to the master that the process was started with, and waits for a first worker. */
  static Engine start(WorkerJob job) throws EngineException {
    return start(configuration(), job);
  }

  static Engine start(SparkConf configuration, WorkerJob job) throws EngineException {
    JavaSparkContext context;
    try {
      context = new JavaSparkContext(configuration);
    } catch (RuntimeException e) {
      throw new EngineException(text("doesNotStart", e.getMessage()), e);
    }
    boolean made = false;
    try {
      SparkEngine engine = new SparkEngine(context, job);
      made = true;
      return engine;
    } finally {
      if (!made) {
        context.close();
      }
    }
  }

  /** What people have said, and what is right for sweeps where they have said nothing. */
  static SparkConf configuration() {
    SparkConf conf = new SparkConf();
    conf.setIfMissing("spark.app.name", "pendant sweep");
    conf.setIfMissing("spark.log.level", "WARN");
    conf.setIfMissing("spark.ui.enabled", "false");
    conf.setIfMissing("spark.ui.showConsoleProgress", "false");
    // A run gives the same result anywhere: what a slow worker has may be run beside by another
    // one.
    conf.setIfMissing("spark.speculation", "true");
    // A worker that dies says nothing against its runs, up to this number.
    conf.setIfMissing("spark.task.maxFailures", "8");
    conf.setIfMissing("spark.deploy.maxExecutorRetries", "-1");
    // YARN and Kubernetes count in the same way, and would give up after twice as many as there
    // are.
    conf.setIfMissing("spark.executor.maxNumFailures", Integer.toString(Integer.MAX_VALUE));
    // As pendant sweep runs on one machine: what a frame leaves behind dies in a young generation
    // that holds some.
    conf.setIfMissing("spark.executor.extraJavaOptions", "-XX:+UseSerialGC -Xmn64m");
    // Spark remembers so many jobs and tasks for its pages, with or without them; a sweep has many.
    conf.setIfMissing("spark.ui.retainedJobs", "50");
    conf.setIfMissing("spark.ui.retainedStages", "50");
    conf.setIfMissing("spark.ui.retainedTasks", "1000");
    // How often it is looked for workers that have hung for spark.network.timeout.
    conf.setIfMissing("spark.network.timeoutInterval", "10s");
    if (conf.get("spark.master", "").startsWith("local-cluster")
        && !conf.contains("spark.network.timeout")) {
      // Nothing is lost on the way to a worker of this computer, and no other computer runs beside
      // what a worker has that hangs.
      conf.set("spark.network.timeout", "30s");
      conf.setIfMissing("spark.executor.heartbeatInterval", "5s");
    }
    if (conf.get("spark.master", "").startsWith("local")) {
      conf.setIfMissing("spark.driver.host", "127.0.0.1");
      conf.setIfMissing("spark.driver.bindAddress", "127.0.0.1");
    }
    return conf;
  }
}
