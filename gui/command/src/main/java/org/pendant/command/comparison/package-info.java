/**
 * Comparisons of recordings with Pendant's runs, written for people and programs: charts, pages and
 * JSON. {@link org.pendant.command.comparison.ComparisonPage} is the class to open first.
 */
package org.pendant.command.comparison;
