/**
 * Background work: what is slow runs outside of the dispatch thread and hands its result to it.
 * Open {@link org.pendant.kit.background.Background} first.
 */
package org.pendant.kit.background;
