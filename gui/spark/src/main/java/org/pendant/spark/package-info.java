/**
 * Sweeps on Apache Spark: the engine, and what its workers do. See {@link
 * org.pendant.spark.SparkEngine} first.
 */
package org.pendant.spark;
