/**
 * Pictures of an arm without a window, for the command line. Open {@link
 * org.pendant.desktop.scene.picture.OffscreenPictures} first.
 */
package org.pendant.desktop.scene.picture;
