/**
 * Reports of coverage: as text for people, and in the forms that other tools read. The same
 * coverage gives the same bytes. Begin with {@link
 * org.pendant.testing.coverage.report.CoverageTable}.
 */
package org.pendant.testing.coverage.report;
