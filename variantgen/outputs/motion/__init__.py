"""Parts of the plots of the motion: what is plotted, its axes, panels, caption, page and film."""
