package org.pendant.sweep.engine;

import java.nio.file.Path;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.run.SweepJob;

/**
 * Engine provider: an engine that is found on the class path (a {@link java.util.ServiceLoader}).
 */
public interface EngineProvider {
  /** Its name as {@code --engine} has it, such as {@code spark}. */
  String name();

  /**
   * Whether this process was started for it, so that it runs variants unless people say otherwise.
   */
  boolean available();

  /**
   * Makes the engine.
   *
   * @param plan the file of the plan
   * @param job what was read of it
   * @throws EngineException if the engine cannot start
   * @throws PlanException if workers cannot have the files of the plan
   */
  Engine create(Path plan, SweepJob job) throws EngineException, PlanException;
}
