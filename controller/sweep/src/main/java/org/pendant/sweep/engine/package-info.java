/**
 * Engines: who runs the variants of a sweep. Open {@link org.pendant.sweep.engine.Engine} first;
 * {@link org.pendant.sweep.engine.LocalEngine} runs them on the cores of this machine.
 */
package org.pendant.sweep.engine;
