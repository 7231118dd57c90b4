/**
 * Coverage of tests: what the programs under test have reached in all tests together, and which
 * test reaches which line. Begin with {@link org.pendant.testing.coverage.CoverageCollector}.
 */
package org.pendant.testing.coverage;
