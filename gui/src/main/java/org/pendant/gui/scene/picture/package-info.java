/**
 * Pictures of an arm without a window, for the command line. Open {@link
 * org.pendant.gui.scene.picture.OffscreenPictures} first.
 */
package org.pendant.gui.scene.picture;
