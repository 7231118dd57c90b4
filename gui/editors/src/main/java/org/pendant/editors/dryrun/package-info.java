/**
 * Dry runs: a program runs once in virtual time on a robot of its own, to say what would go wrong
 * and how long its lines take. {@link org.pendant.editors.dryrun.DryRun} is the class to open
 * first.
 */
package org.pendant.editors.dryrun;
