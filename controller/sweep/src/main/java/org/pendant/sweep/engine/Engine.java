package org.pendant.sweep.engine;

import java.io.IOException;
import java.util.function.BooleanSupplier;

/**
 * Engine: runs the variants of a sweep somewhere. Whatever the engine, the number of its workers
 * and the order in which they finish: the sink gets the same results in the same order, each
 * exactly once. What goes wrong in a run is in its result; a worker that is lost has its runs run
 * again.
 */
public interface Engine extends AutoCloseable {

  /** What it is, for people, such as {@code 8 workers on this machine}. */
  String description();

  /**
   * Runs variants and returns when all have run, or when it was stopped. The sink has then got all
   * from the first up to some number, and no other.
   *
   * @param variants those of the numbers
   * @param first number of the first
   * @param end number after that of the last
   * @param sink called by the thread that calls this
   * @param stopped asked now and then; once it holds, runs under way are given up
   * @return number after that of the last result that the sink got
   * @throws IOException from the sink
   * @throws EngineException if nothing can be run any more
   */
  long run(VariantSource variants, long first, long end, ResultSink sink, BooleanSupplier stopped)
      throws IOException, EngineException;

  @Override
  void close();
}
