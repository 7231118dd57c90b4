/**
 * Folders with the results of a sweep. Open {@link org.pendant.sweep.folder.SweepFolder} first: it
 * begins one, goes on with one, and tells what is in it.
 */
package org.pendant.sweep.folder;
