/**
 * Program trees in the files of PolyScope, {@code .urp} and {@code .urpx}. Open {@link
 * org.pendant.project.program.urp.UrpPrograms} first.
 */
package org.pendant.project.program.urp;
