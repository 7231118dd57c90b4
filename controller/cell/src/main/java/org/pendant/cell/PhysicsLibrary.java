package org.pendant.cell;

import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeHelper;

/**
 * Physics library: where worlds of ode4j are made; sets the library's tables up before the first.
 *
 * <p>What else of the library is static has no effect on results but one thing: the random numbers
 * by which {@code quickStep} shuffles its constraints, which all worlds share. It does so in its
 * ninth iteration first, see {@link #ITERATIONS}.
 */
final class PhysicsLibrary {
  /** Of {@code quickStep}: as many as go without random numbers. */
  static final int ITERATIONS = 8;

  static {
    OdeHelper.initODE2(0);
  }

  private PhysicsLibrary() {}

  /** A new world. */
  static DWorld world() {
    return OdeHelper.createWorld();
  }
}
