/**
 * Searches: variants that follow from what came of those before. Open {@link
 * org.pendant.sweep.search.SweepSearch} first.
 */
package org.pendant.sweep.search;
