package org.pendant.spark;

import java.nio.file.Path;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;
import org.pendant.sweep.engine.EngineProvider;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.remote.JobArchive;
import org.pendant.sweep.run.SweepJob;

/** The provider of {@code --engine spark}, in a process that {@code spark-submit} has started. */
public final class SparkEngineProvider implements EngineProvider {

  @Override
  public String name() {
    return "spark";
  }

  /** {@code spark-submit} has told the master. */
  @Override
  public boolean available() {
    return System.getProperty("spark.master") != null;
  }

  @Override
  public Engine create(Path plan, SweepJob job) throws EngineException, PlanException {
    return SparkApplication.start(new WorkerJob(JobArchive.pack(plan, job), job.identity()));
  }
}
