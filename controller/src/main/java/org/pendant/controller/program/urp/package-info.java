/**
 * Program trees in the files of PolyScope, {@code .urp} and {@code .urpx}. Open {@link
 * org.pendant.controller.program.urp.UrpPrograms} first.
 */
package org.pendant.controller.program.urp;
