/**
 * Program trees in the files of PolyScope, {@code .urp}. Open {@link
 * org.pendant.controller.program.urp.UrpPrograms} first.
 */
package org.pendant.controller.program.urp;
