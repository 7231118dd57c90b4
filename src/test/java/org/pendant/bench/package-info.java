/**
 * How fast Pendant is: JMH benchmarks, their scripts, and the same tasks for other interpreters.
 * Open {@link org.pendant.bench.Measurements} first: it is what {@code mvn -Pbench} runs.
 */
package org.pendant.bench;
