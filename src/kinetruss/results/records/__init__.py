"""Result records: datasets with named axes and units, a status, where they came from."""
